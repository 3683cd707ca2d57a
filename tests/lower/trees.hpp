// What the tests of trees of every joint share: lists of functions, and results in a form that two derivations have in
// common. Not: any expectation.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "tests/lower/sample.hpp"

namespace kanec::test {

// All that the scene can have, with or without those that are made by differentiation.
std::vector<std::string> every_function(const scene::Scene& scene);
std::vector<std::string> without_derivatives(const scene::Scene& scene);

// Numbers of the random scenes are between a tenth and a thousand, gravity is ten. A result that cancels below this,
// such as the acceleration of a point that stands still, is compared with this size instead of its own.
inline constexpr long double least_size = 1e-2;

// Derivatives by raw x along the unit sphere of the Euler parameters, all other results as they are: off the sphere,
// where nothing moves, formulas differ.
std::vector<long double> comparable(const Sample& s, const std::string& function,
                                    const std::vector<long double>& result);

}  // namespace kanec::test
