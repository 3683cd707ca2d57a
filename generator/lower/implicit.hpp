// Derivatives of the residual put together from those of the inertia forces and of the applied loads, and derivatives
// of accelerations from these: r(x, y, ẏ) = 0 gives ẏ_x = −A⁻¹ r_x. Not: the parts (symbolic/variations.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::lower {

// The functions that a program must have for it, `of` "residual" or "accelerations" and `by` as in directions.hpp.
std::vector<std::string> parts_for(const std::string& of, const std::string& by);

// The function's operations are appended to the program, whose zeros must be simplified; a row an equation, a column a
// direction; name, meaning and layout are left to the caller.
program::Function derivative_by_equations(program::Program& program, const scene::Scene& scene, const std::string& of,
                                          const std::string& by);

}  // namespace kanec::lower
