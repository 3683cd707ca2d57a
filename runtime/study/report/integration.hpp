// What accuracy costs in time with each integrator: runs over tolerances or steps against a reference. Not: how it is
// shown (integration_text.hpp, integration_diagram.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/bench/peers.hpp"
#include "runtime/integrate/options.hpp"
#include "runtime/model/model.hpp"
#include "runtime/study/report/motion_error.hpp"

namespace kanec {

// Tolerances 1e-4 … 1e-14, of Taylor series finer ones; steps from about those of the coarsest on.
constexpr int coarsest_decade = 4, finest_decade = 14;
constexpr int most_halvings = 14;

struct IntegrationOptions {
  std::vector<std::string> integrators;  // by name; empty: all
  std::optional<double> duration;        // [s]; none: the scene's
  std::vector<Peer> peers;               // other engines beside them
  std::optional<double> error;           // that a recommendation is wanted for
  double limit = 1.0;                    // of one run [s]
  int rows = 20;                         // after the start, at which errors are looked at
};

// One integrator with one tolerance or step.
struct IntegrationRun {
  std::string method;                         // "cvode_bdf, differences"; "Simbody 3.7, RungeKuttaMerson"
  std::string setting;                        // "rtol 1e-09"
  double step = 0.0;                          // the longest of equal ones [s]; 0: error control with
  double tolerance = 0.0;                     // relative; 0: equal steps
  std::optional<integrate::Options> options;  // of kanec's own integrators
  std::string failure;                        // empty: it went through
  double wall_seconds = 0.0;                  // least of a few; of a failed run, until it failed
  std::int64_t steps = 0, rejected = 0, evaluations = 0;
  std::optional<std::int64_t> jacobians;      // evaluations of emitted derivatives, where the method takes some
  MotionError end, worst;                     // at the end; largest of each over the rows
  double end_error = 0.0, worst_error = 0.0;  // the same as one number (motion_error.hpp)
  std::optional<double> energy;               // change less work, worst over rows, beside the energies exchanged
  std::optional<double> momentum;             // change, worst over rows, where nothing acts from outside
  std::optional<double> norm;  // worst | |ε| - 1 | at the ends of steps, where there are Euler parameters
  bool is_on_front = false;    // no other run is both more accurate and faster

  bool ok() const { return failure.empty(); }
};

// A run of kanec's own, not yet made.
IntegrationRun run_with(const integrate::Options& options);

struct SceneRuns {
  std::string model;
  std::string path;            // as it was given, for a command to type
  std::string picture;         // file of the diagram; empty: none
  scene::Simulation settings;  // the scene's own
  double duration = 0.0;       // asked for [s]
  std::optional<double> end;   // where an event ends the most accurate run before that [s]
  std::int64_t rows = 0;       // after the start, that were compared
  MotionScales scales;
  std::string reference, coarser, check;  // as reference.hpp has them
  double reference_error = 0.0, check_difference = 0.0;
  bool is_disputed = false;
  std::vector<IntegrationRun> runs;  // by method, coarse to fine
  std::string failure = {};          // why there is none of this; empty: there is
};

struct Reference;

// Errors of a run's rows.
void measure(IntegrationRun& run, const std::vector<Bodies>& rows, const Reference& reference);

// What is asked of the generator: what the methods call, and what runs are judged by.
std::vector<std::string> integration_functions(const scene::Scene& scene, const IntegrationOptions& options);

// `progress` is told the share that is done, often; it may throw. Throws IntegrationError without a reference. The
// model has integration_functions() and Taylor series.
SceneRuns integration_runs(const scene::Scene& scene, const kanec_model& model, const IntegrationOptions& options,
                           const std::function<void(double)>& progress);

}  // namespace kanec
