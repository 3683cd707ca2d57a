// A run from an initial state to a duration or an event: rows to an observer, a summary at the end. Not here: files
// (trajectory.hpp), pictures (plot.hpp), how any of it is shown.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <vector>

#include "runtime/abi/solver.hpp"
#include "runtime/integrate/events.hpp"
#include "runtime/integrate/options.hpp"
#include "runtime/trajectory/balance.hpp"

namespace kanec {

// The state at one output time; the spans are valid during the call only.
struct Row {
  double t;                      // [s]
  std::span<const double> x, y;  // Euler parameters of unit norm
  double work;                   // of the applied loads since the start [J]; 0 where the model has no `power`
  std::optional<Energy> energy;  // empty where the model has no `energy`
  std::span<const double> inputs = {};
};

struct Summary {
  std::int64_t rows = 0;
  std::int64_t steps = 0;        // accepted
  std::int64_t failed = 0;       // rejected by error control or not converged
  std::int64_t restarts = 0;     // of cvode (Adams) and ida: new starts because of the norm of the Euler parameters
  std::int64_t evaluations = 0;  // of ẋ and ẏ, those for differences included; of ida those of the residual too
  std::int64_t jacobians = 0;    // evaluations of emitted derivatives
  double wall_seconds = 0.0;     // whole run, observer included
  std::optional<EnergyBalance> energy;
  std::optional<MomentumChange> linear_momentum;   // [kg m/s]
  std::optional<MomentumChange> angular_momentum;  // about the inertial origin [kg m²/s]
  double worst_norm_error_before = 0.0;      // | |ε| - 1 | at the end of a step, before any projection, over all steps
  double worst_norm_error_after = 0.0;       // the same in the rows
  std::vector<integrate::Happening> events;  // in the order of time
  bool stopped = false;                      // by an event, before the duration
  double t = 0.0;                            // at the end [s]
  std::vector<double> x, y;                  // there
  std::vector<double> inputs;                // there
};

using Observer = std::function<void(const Row&)>;
using Progress = std::function<void(double fraction)>;  // after every step; 0 to 1

// Throws InputError (options, initial state, a model without the functions needed), IntegrationError (time and cause),
// and whatever the observer throws. Inputs and parameters are those of the solver, until an event sets inputs; the
// state and options.work are those at options.start.
Summary simulate(const Solver& solver, std::span<const double> x, std::span<const double> y,
                 const integrate::Options& options, const Observer& observer = {}, const Progress& progress = {});

}  // namespace kanec
