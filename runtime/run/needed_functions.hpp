// The functions that integrating a scene takes. Not: their compilation (runtime/model).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/integrate/options.hpp"

namespace kanec {

// kinematics+accelerations, with power where the scene has it: all rates of a state in one call.
std::string all_rates(const scene::Scene& scene);

// What an integrator calls. A Jacobian that is not asked for by name, and would take minutes to compile, is left to
// differences: options.jacobian says so then.
std::vector<std::string> functions_to_integrate(const scene::Scene& scene, integrate::Options& options);

}  // namespace kanec
