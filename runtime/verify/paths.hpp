// Two ways to a function's result beside the compiled code (runtime/model/evaluate.hpp), with which they share nothing
// but the scene (generic) or the program (precise). Not: their comparison (agreement.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"
#include "runtime/model/state_file.hpp"
#include "runtime/verify/precise.hpp"

namespace kanec {

// runtime/generic, in double, long double or 50 digits; of a request of several parts, one result after another.
template <class Real>
std::vector<Real> generic_path(const scene::Scene& scene, const std::vector<std::string>& parts, const State& state);

extern template std::vector<double> generic_path(const scene::Scene&, const std::vector<std::string>&, const State&);
extern template std::vector<long double> generic_path(const scene::Scene&, const std::vector<std::string>&,
                                                      const State&);

extern template std::vector<Precise> generic_path(const scene::Scene&, const std::vector<std::string>&, const State&);

// The program that was emitted, its constants rounded as they are there, in 50 digits.
std::vector<Precise> precise(const program::Program& program, const std::string& function, const State& state);

}  // namespace kanec
