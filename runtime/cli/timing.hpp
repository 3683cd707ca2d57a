// Time per evaluation by Google Benchmark, emitted and generic in one run. Not: what is shown of it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/cli/model.hpp"

namespace kanec::cli {

struct Timing {
  std::string function;
  double emitted = 0.0, generic = 0.0;  // processor time per evaluation [ns]
  double ratio() const { return generic / emitted; }
};

// Of every function of the model, with the scene's parameters and inputs, over 256 random states in turn; `min_time`
// [s] for each of the two, in five parts of which the median counts. Nothing is allocated in the timed loop of the
// emitted code; the generic path allocates what it allocates in use.
std::vector<Timing> timings(const scene::Scene& scene, const CompiledModel& model, double min_time);

}  // namespace kanec::cli
