// Where the numbers of x, y, ydot and of what acts along the speeds stand, for any joints. Not: their values.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/model/layout.hpp"

namespace kanec {

// A block a body and kind where all of its components are in the state ("eps_hub", "s_1"; "theta_3" is a number where
// there is one angle), else a number each ("s_2_2", where s_2_1 is locked or prescribed).
Layout coordinates_layout(const scene::Scene& scene);                            // x
Layout speeds_layout(const scene::Scene& scene);                                 // y
Layout speed_rates_layout(const scene::Scene& scene);                            // ydot
Layout coordinate_rates_layout(const scene::Scene& scene);                       // xdot
Layout along_speeds_layout(const scene::Scene& scene, const std::string& name);  // forces and moments
Layout driving_loads_layout(const scene::Scene& scene);  // along what is locked or prescribed: "phi_1", "theta_3"

// What blocks of x, y or ydot are, for people: "eps_1 (4 numbers), theta_K (1 number), K from 2 to 13".
std::string summary_of(const Layout& layout);

// Of the tangent ξ, one a speed: "phi_1_1" (of a ball's rotation vector), "theta_3", "s_2_1".
std::vector<std::string> tangent_names(const scene::Scene& scene);

}  // namespace kanec
