// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/system.hpp"
#include "runtime/trajectory/batch_ensemble.hpp"

namespace kanec {

using namespace integrate;

namespace {

constexpr std::size_t alignment = 64;

// Numbers of one group: entry i of lane l at [i * lanes + l], aligned as lanes want it.
class Block {
 public:
  Block(int entries, int lanes)
      : lanes_(lanes), lines_(static_cast<std::size_t>(std::max(entries, 1) * lanes) / 8 + 1) {}
  double* data() { return lines_.front().numbers; }
  double* entry(int i) { return data() + static_cast<std::ptrdiff_t>(i) * lanes_; }
  double at(int i, int lane) const { return lines_.front().numbers[static_cast<std::ptrdiff_t>(i) * lanes_ + lane]; }
  void set(int i, int lane, double value) { entry(i)[lane] = value; }
  void set_all(int i, int lane, std::span<const double> values) {
    for (const double value : values) set(i++, lane, value);
  }
  std::vector<double> column(int first, int count, int lane) const {
    std::vector<double> result;
    for (int i = first; i < first + count; ++i) result.push_back(at(i, lane));
    return result;
  }

 private:
  struct alignas(alignment) Line {
    double numbers[8];
  };
  int lanes_;
  std::vector<Line> lines_;
};

// One group of scenarios from start to end. Lanes without a scenario repeat the last one.
class Group {
 public:
  Group(const BatchSolver<double>& solver, std::span<const Scenario> scenarios, std::int64_t group,
        const EnsembleOptions& options, int worker)
      : solver_(solver),
        model_(solver.model()),
        rk4_(*solver.batch().rk4),
        energy_(solver.find("energy")),
        options_(options),
        group_(group),
        worker_(worker),
        count_(static_cast<int>(scenarios.size())),
        z_(rk4_.size, solver.lanes()),
        u_(model_.n_inputs, solver.lanes()),
        energies_(2, solver.lanes()),
        norm_error_(1, solver.lanes()),
        finite_until_(1, solver.lanes()),
        outcomes_(scenarios.size()),
        watches_(scenarios.size()),
        running_(scenarios.size(), true) {
    for (int lane = 0; lane < solver.lanes(); ++lane) {
      const Scenario& scenario = scenarios[static_cast<std::size_t>(std::min(lane, count_ - 1))];
      z_.set_all(0, lane, state_at_start(model_, scenario.x, scenario.y));
      u_.set_all(0, lane, scenario.inputs);
    }
  }

  std::vector<Outcome> run() {
    const RowTimes times(options_.run.duration, options_.run.output_step);
    for (std::int64_t row = 0; row < times.size() && any_runs(); ++row) {
      if (row > 0) advance(times[row - 1], times[row]);
      take(times[row], row, row + 1 == times.size());
    }
    for (std::size_t lane = 0; lane < outcomes_.size(); ++lane) finish(lane);
    return std::move(outcomes_);
  }

 private:
  bool any_runs() const { return std::find(running_.begin(), running_.end(), true) != running_.end(); }

  // As Rk4 of one scenario divides the time between two rows.
  void advance(double begin, double end) {
    const auto n = static_cast<std::int64_t>(std::max(1.0, std::ceil((end - begin) / options_.run.step - 1e-9)));
    for (int lane = 0; lane < solver_.lanes(); ++lane) finite_until_.set(0, lane, begin);
    const kanec_group group{
        begin, end, n, solver_.prepared(group_), u_.data(), z_.data(), norm_error_.data(), finite_until_.data()};
    rk4_.steps(&group);
    steps_ += n;
  }

  void take(double t, std::int64_t row, bool is_last) {
    if (energy_) solver_.evaluate_group(*energy_, group_, t, z_.data(), z_.entry(model_.nx), energies_.data(), worker_);
    const bool wanted = is_last || (options_.keep_every > 0 && row % options_.keep_every == 0);
    for (int lane = 0; lane < count_; ++lane) {
      const auto i = static_cast<std::size_t>(lane);
      if (!running_[i]) continue;
      if (row > 0 && finite_until_.at(0, lane) < t) {
        stop(i, "integration stopped after t = " + shortest(finite_until_.at(0, lane)) +
                    " s: the state or its rate is not finite");
        continue;
      }
      if (energy_) watches_[i].add(energy_at(energies_, lane), work_at(z_, lane));
      if (wanted) outcomes_[i].rows.push_back(row_of(t, z_, energies_, lane));
      if (steps_ > options_.run.max_steps)
        stop(i, "integration stopped at t = " + shortest(t) + " s: the limit of " +
                    std::to_string(options_.run.max_steps) + " steps is reached");
    }
    last_time_ = t;
    last_z_ = z_;
    last_energies_ = energies_;
  }

  Energy energy_at(const Block& energies, int lane) const { return {energies.at(0, lane), energies.at(1, lane)}; }
  double work_at(const Block& z, int lane) const {
    const int n = model_.nx + model_.ny;
    return rk4_.size > n ? z.at(n, lane) : 0.0;
  }
  KeptRow row_of(double t, const Block& z, const Block& energies, int lane) const {
    KeptRow row{t, z.column(0, model_.nx, lane), z.column(model_.nx, model_.ny, lane), {}, work_at(z, lane)};
    if (energy_) row.energy = energy_at(energies, lane);
    return row;
  }

  // The last row that was finite is the end.
  void stop(std::size_t lane, std::string why) {
    running_[lane] = false;
    outcomes_[lane].stopped = std::move(why);
    std::vector<KeptRow>& rows = outcomes_[lane].rows;
    if (rows.empty() || rows.back().t < last_time_)
      rows.push_back(row_of(last_time_, last_z_, last_energies_, static_cast<int>(lane)));
  }

  void finish(std::size_t lane) {
    Outcome& outcome = outcomes_[lane];
    outcome.steps = steps_;
    outcome.evaluations = 4 * steps_;
    outcome.worst_norm_error = norm_error_.at(0, static_cast<int>(lane));
    if (energy_) outcome.energy = watches_[lane].balance();
  }

  const BatchSolver<double>& solver_;
  const kanec_model& model_;
  const kanec_rk4& rk4_;
  std::optional<int> energy_;
  const EnsembleOptions& options_;
  std::int64_t group_;
  int worker_, count_;
  Block z_, u_, energies_, norm_error_, finite_until_;
  std::vector<Outcome> outcomes_;
  std::vector<EnergyWatch> watches_;
  std::vector<bool> running_;
  double last_time_ = 0.0;  // of the row before
  Block last_z_ = z_, last_energies_ = energies_;
  std::int64_t steps_ = 0;
};

// Of all scenarios, entry i of scenario j at [i * count + j].
std::vector<double> parameters_of(std::span<const Scenario> scenarios, int n) {
  std::vector<double> list;
  for (std::size_t i = 0; i < static_cast<std::size_t>(n); ++i)
    for (const Scenario& scenario : scenarios) list.push_back(scenario.parameters.at(i));
  return list;
}

void require_sizes(std::span<const Scenario> scenarios, const kanec_model& model) {
  for (const Scenario& scenario : scenarios)
    if (scenario.parameters.size() != static_cast<std::size_t>(model.n_parameters) ||
        scenario.inputs.size() != static_cast<std::size_t>(model.n_inputs))
      throw InputError("a scenario with a wrong number of parameters or inputs");
}

}  // namespace

std::vector<Outcome> run_in_lanes(BatchSolver<double>& solver, std::span<const Scenario> scenarios,
                                  const EnsembleOptions& options) {
  check(options.run);
  if (solver.batch().rk4 == nullptr)
    throw InputError(std::string("model ") + solver.model().name +
                     " has no function kinematics_and_accelerations, which ensembles need");
  if (scenarios.empty()) return {};
  require_sizes(scenarios, solver.model());
  const auto count = static_cast<std::int64_t>(scenarios.size());
  solver.set_parameters_each(count, parameters_of(scenarios, solver.model().n_parameters).data());
  const auto lanes = static_cast<std::size_t>(solver.lanes());
  std::vector<Outcome> outcomes(scenarios.size());
  solver.workers().run((count + solver.lanes() - 1) / solver.lanes(), [&](std::int64_t group, int worker) {
    const std::size_t first = static_cast<std::size_t>(group) * lanes;
    const auto part = scenarios.subspan(first, std::min(lanes, scenarios.size() - first));
    std::vector<Outcome> done = Group(solver, part, group, options, worker).run();
    std::move(done.begin(), done.end(), outcomes.begin() + static_cast<std::ptrdiff_t>(first));
  });
  return outcomes;
}

}  // namespace kanec
