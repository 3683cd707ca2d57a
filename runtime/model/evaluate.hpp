// A function of a compiled model in one state of its scene. Not: many states (runtime/abi/batch_solver.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/abi/solver.hpp"
#include "runtime/model/state_file.hpp"

namespace kanec {

// Of the scene's parameters and inputs, in the scene's order, those that the compiled code kept, in its order.
std::vector<double> read_parameters(const kanec_model& model, const scene::Scene& scene,
                                    const std::vector<double>& values);
std::vector<double> read_inputs(const kanec_model& model, const scene::Scene& scene, const std::vector<double>& values);

// A solver of the scene's model with these parameters and inputs: those that the compiled code kept, found by name.
Solver solver_of(const kanec_model& model, const scene::Scene& scene, const State& state);

// The compiled code, with the state's parameters and inputs. `function`: as it is emitted.
std::vector<double> emitted(const kanec_model& model, const scene::Scene& scene, const std::string& function,
                            const State& state);

}  // namespace kanec
