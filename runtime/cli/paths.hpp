// The three ways to a function's result, which share nothing but the scene (emitted, generic) or the program (emitted,
// precise). Not: their comparison (agreement.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"
#include "runtime/abi/solver.hpp"
#include "runtime/cli/precise.hpp"
#include "runtime/cli/state_file.hpp"

namespace kanec::cli {

// Of the scene's parameters and inputs, in the scene's order, those that the compiled code kept, in its order.
std::vector<double> read_parameters(const kanec_model& model, const scene::Scene& scene,
                                    const std::vector<double>& values);
std::vector<double> read_inputs(const kanec_model& model, const scene::Scene& scene, const std::vector<double>& values);

// A solver of the scene's model with these parameters and inputs: those that the compiled code kept, found by name.
Solver solver_of(const kanec_model& model, const scene::Scene& scene, const State& state);

// The compiled code, with the state's parameters and inputs. `function`: as it is emitted.
std::vector<double> emitted(const kanec_model& model, const scene::Scene& scene, const std::string& function,
                            const State& state);

// runtime/generic, in double, long double or 50 digits; of a request of several parts, one result after another.
template <class Real>
std::vector<Real> generic_path(const scene::Scene& scene, const std::vector<std::string>& parts, const State& state);

extern template std::vector<double> generic_path(const scene::Scene&, const std::vector<std::string>&, const State&);
extern template std::vector<long double> generic_path(const scene::Scene&, const std::vector<std::string>&,
                                                      const State&);

extern template std::vector<Precise> generic_path(const scene::Scene&, const std::vector<std::string>&, const State&);

// The program that was emitted, its constants rounded as they are there, in 50 digits.
std::vector<Precise> precise(const program::Program& program, const std::string& function, const State& state);

}  // namespace kanec::cli
