// What an expression of time and parameters is worth. Not: expressions of coordinates, speeds or inputs, whose values
// only a state gives.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::scene {

// Whether it holds neither time, coordinates, speeds, parameters nor inputs.
bool is_constant(const Expression& expression);

// Whether every part that is made of numbers alone is a finite number: not so in "0/0 + k".
bool has_finite_constants(const Expression& expression);

// At time t with the defaults of the parameters. NaN where it holds a coordinate, a speed or an input. The double
// nearest to pi counts as pi itself, so that cos(pi/2) is zero to extended precision.
long double value(const Expression& expression, const std::vector<Named>& parameters, long double t = 0);

}  // namespace kanec::scene
