// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/trajectory/batch_ensemble.hpp"

#include "runtime/base/error.hpp"
#include "runtime/trajectory/simulate.hpp"

namespace kanec {

using namespace integrate;

namespace {

KeptRow kept(const Row& row) {
  return {row.t, {row.x.begin(), row.x.end()}, {row.y.begin(), row.y.end()}, row.energy, row.work};
}

Outcome run_alone(const kanec_model& model, const Scenario& scenario, const EnsembleOptions& options) {
  Solver solver(model);
  solver.set_parameters(scenario.parameters);
  solver.set_inputs(scenario.inputs);
  Outcome outcome;
  std::optional<KeptRow> last;
  std::int64_t n = 0;
  const auto keep = [&](const Row& row) {
    last = kept(row);
    const bool wanted = options.keep_every > 0 && n % options.keep_every == 0;
    if (wanted) outcome.rows.push_back(*last);
    ++n;
  };
  try {
    const Summary summary = simulate(solver, scenario.x, scenario.y, options.run, keep);
    outcome.energy = summary.energy;
    outcome.worst_norm_error = summary.worst_norm_error_before;
    outcome.steps = summary.steps;
    outcome.evaluations = summary.evaluations;
  } catch (const IntegrationError& error) {
    outcome.stopped = error.what();
  }
  if (last && (outcome.rows.empty() || outcome.rows.back().t < last->t)) outcome.rows.push_back(std::move(*last));
  if (outcome.rows.empty()) outcome.rows.push_back({0.0, scenario.x, scenario.y, {}, 0.0});
  return outcome;
}

}  // namespace

std::vector<Outcome> run_one_by_one(const kanec_model& model, Workers& workers, std::span<const Scenario> scenarios,
                                    const EnsembleOptions& options) {
  check(options.run);
  std::vector<Outcome> outcomes(scenarios.size());
  workers.run(static_cast<std::int64_t>(scenarios.size()), [&](std::int64_t piece, int) {
    const auto i = static_cast<std::size_t>(piece);
    outcomes[i] = run_alone(model, scenarios[i], options);
  });
  return outcomes;
}

}  // namespace kanec
