// A hard case run at full or modest length: what was kept, to what, at what cost. Not: how that is shown.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "runtime/model/model.hpp"
#include "runtime/study/hard/hard_case.hpp"
#include "runtime/study/hard/rounding.hpp"
#include "runtime/trajectory/simulate.hpp"

namespace kanec::hard {

struct Kept {
  std::string what;  // "attitude"
  std::string unit;  // "rad"; empty where it is relative
  double found = 0.0, most = 0.0;
  bool holds() const { return found <= most; }  // NaN does not
};

struct Outcome {
  integrate::Options options;
  Summary summary;
  std::string failure;  // what stopped the run, with time, body and coordinate; empty where nothing did
  std::vector<Kept> kept;
  Rounding accelerations;  // in states of the run

  // No failure, and everything within its bounds.
  bool holds() const;
};

// The case's scene with all that its runs need. Throws InputError, BuildError, LoadError.
CompiledModel compiled(const HardCase& hard, const BuildOptions& arguments = {});

// `model` is that. Throws SceneError for a bound on what the case does not have, InputError where its answer is not of
// the scene or the start.
Outcome outcome(const HardCase& hard, const Length& length, const CompiledModel& model,
                const std::function<void(double)>& progress = {});

}  // namespace kanec::hard
