// Many runs of one model, each from its own state with its own parameters and inputs. Not: where these come from, nor
// what is written of the results (runtime/cli).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/abi/batch_solver.hpp"
#include "runtime/integrate/options.hpp"
#include "runtime/trajectory/balance.hpp"

namespace kanec {

// All in the model's order; Euler parameters of unit norm to 1e-6.
struct Scenario {
  std::vector<double> x, y, parameters, inputs;
};

// One row of a run; the same numbers as Row, kept.
struct KeptRow {
  double t = 0.0;
  std::vector<double> x, y;
  std::optional<Energy> energy;
  double work = 0.0;
};

// What became of a scenario. Of one that stopped the rows end with the last finite one, which is also its end.
struct Outcome {
  std::string stopped;        // why, with the time; empty: it ran to its end
  std::vector<KeptRow> rows;  // every n-th from t = 0 on, and the last
  std::optional<EnergyBalance> energy;
  double worst_norm_error = 0.0;  // | |ε| - 1 | at the end of a step, before any projection
  std::int64_t steps = 0;         // accepted
  std::int64_t evaluations = 0;   // of ẋ and ẏ

  const KeptRow& end() const { return rows.back(); }
};

struct EnsembleOptions {
  integrate::Options run;
  std::int64_t keep_every = 0;  // rows of the run; 0: the last one alone
};

// By the classical Runge-Kutta method in lanes, for any number of scenarios; results do not depend on that number, nor
// on threads, nor on which scenarios stand side by side. Throws InputError as simulate() does, and where the batch has
// no rates in one function. Sets the solver's parameters.
std::vector<Outcome> run_in_lanes(BatchSolver<double>& solver, std::span<const Scenario> scenarios,
                                  const EnsembleOptions& options);

// By any method, one scenario at a time in each of the threads.
std::vector<Outcome> run_one_by_one(const kanec_model& model, Workers& workers, std::span<const Scenario> scenarios,
                                    const EnsembleOptions& options);

}  // namespace kanec
