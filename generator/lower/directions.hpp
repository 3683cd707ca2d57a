// The directions of the state that derivatives are taken along: by coordinates as they are, or by the tangent of
// rotations. Not: derivatives.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/derivative.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::lower {

// `by`: "x", "y", "ydot", "u", or "xi" for the tangent. Half Euler parameters are appended to the program.
std::vector<program::Column> columns_by(program::Program& program, const scene::Scene& scene, const std::string& by);

}  // namespace kanec::lower
