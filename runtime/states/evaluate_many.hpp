// One function in many states, one after another. Not: where the states come from (state_source.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/abi/abi.h"
#include "runtime/model/state_file.hpp"
#include "runtime/states/results.hpp"
#include "runtime/states/state_source.hpp"

namespace kanec {

struct ManyStates {
  std::int64_t count = 0;
  std::int64_t normalised = 0;  // with Euler parameters off unit norm by more than 1e-6
};

// evaluate: of a checked state, Euler parameters of unit norm. `scene` with the values that states without their own
// have. progress: the share that is done, now and then. Throws InputError that names the state, and what evaluate
// throws.
ManyStates evaluate_many(const scene::Scene& scene, StateSource& states, ResultSink& results,
                         const std::function<const std::vector<double>&(const State&)>& evaluate,
                         const std::function<void(double)>& progress);

// The compiled function, whose parameters are prepared where they change alone.
std::function<const std::vector<double>&(const State&)> compiled_function(const kanec_model& model,
                                                                          const scene::Scene& scene,
                                                                          const std::string& function);

}  // namespace kanec
