// What rounding costs the emitted accelerations in states of a run, in double beside what it costs the generic path,
// and in float. Not: a report of all functions (report/evaluation.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <vector>

#include "runtime/model/model.hpp"
#include "runtime/model/state_file.hpp"

namespace kanec::hard {

// Medians over the states of the largest error of a component beside the largest component.
struct Rounding {
  double emitted = 0.0, generic = 0.0;  // from the generic path in long double, in ulps of double
  double single = 0.0;                  // of the program in float, from 50 digits: relative

  // No worse than twice the generic path, or than four ulps.
  bool holds() const { return emitted <= std::max(2 * generic, 4.0); }
  // Whether single precision gives three digits.
  bool suffices_single() const { return single <= 1e-3; }
};

// `model` has the accelerations as a function of their own.
Rounding rounding(const CompiledModel& model, const scene::Scene& scene, const std::vector<State>& states);

}  // namespace kanec::hard
