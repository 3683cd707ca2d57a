// What rounding costs the emitted accelerations in states of a run, beside what it costs the generic path. Not: a
// report of all functions (report/evaluation.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "runtime/cli/model.hpp"
#include "runtime/cli/state_file.hpp"

namespace kanec::cli::hard {

// Medians over the states, in ulps of the largest component, from the generic path in long double.
struct Rounding {
  double emitted = 0.0, generic = 0.0;

  // No worse than twice the generic path, or than four ulps.
  bool holds() const { return emitted <= std::max(2 * generic, 4.0); }
};

Rounding rounding(const CompiledModel& model, const scene::Scene& scene, const std::vector<State>& states);

}  // namespace kanec::cli::hard
