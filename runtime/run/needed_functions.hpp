// The functions that integrating a scene takes. Not: their compilation (runtime/model).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/integrate/options.hpp"

namespace kanec {

// kinematics+accelerations, with power where the scene has it: all rates of a state in one call.
std::string all_rates(const scene::Scene& scene);

// Those that are asked for, or, where none are, those that the scene asks for or the usual ones, with all rates in one
// function in front unless they are there: what a Taylor series is made of. `tell` gets notes on what is left out.
std::vector<std::string> functions_with_rates(const scene::Scene& scene, std::vector<std::string> chosen,
                                              const std::function<void(const std::string&)>& tell);

// What an integrator calls. A Jacobian that is not asked for by name, and would take minutes to compile, is left to
// differences: options.jacobian says so then.
std::vector<std::string> functions_to_integrate(const scene::Scene& scene, integrate::Options& options);

}  // namespace kanec
