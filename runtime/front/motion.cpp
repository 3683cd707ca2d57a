// SPDX-License-Identifier: BSD-3-Clause
#include "kanec/motion.hpp"

#include "runtime/front/data.hpp"
#include "runtime/integrate/options.hpp"
#include "runtime/trajectory/simulate.hpp"

namespace kanec {
namespace {

integrate::Event event_of(const WatchedEvent& from, int n_inputs) {
  using Direction = integrate::Event::Direction;
  integrate::Event event;
  event.name = from.name;
  event.direction = from.direction == 0 ? Direction::both : from.direction > 0 ? Direction::up : Direction::down;
  event.stops = from.stops;
  event.has_row = from.has_row;
  for (const WatchedEvent::Setting& setting : from.settings) {
    if (setting.input < 0 || (n_inputs >= 0 && setting.input >= n_inputs))
      throw InputError("event " + from.name + ": found input " + std::to_string(setting.input) + "; allowed: 0 to " +
                       std::to_string(n_inputs - 1));
    event.settings.push_back({setting.input, setting.value});
  }
  return event;
}

// n_inputs: of the model; -1 where it is not known.
integrate::Options options_of(const Run& run, int n_inputs) {
  integrate::Options options;
  options.method = integrate::method_of(run.integrator);
  options.duration = run.duration;
  options.output_step = run.output_step;
  options.step = run.step;
  options.longest_step = run.longest_step;
  options.relative_tolerance = run.relative_tolerance;
  options.absolute_tolerance = run.absolute_tolerance;
  options.order = run.order;
  options.jacobian = integrate::jacobian_of(run.jacobian);
  options.has_kinks = run.has_kinks;
  for (const WatchedEvent& event : run.events) options.events.push_back(event_of(event, n_inputs));
  return options;
}

void require_state(const kanec_model& model, const char* what, std::span<const double> found, int wanted) {
  if (found.size() != static_cast<std::size_t>(wanted))
    throw InputError(std::string(model.name) + ": " + what + ": found " + std::to_string(found.size()) +
                     " numbers; allowed: " + std::to_string(wanted));
  require_finite(what, found);
}

void append(std::vector<double>& list, std::span<const double> values) {
  list.insert(list.end(), values.begin(), values.end());
}

}  // namespace

std::vector<std::string> functions_to_simulate(const Run& run, bool has_power, int nx) {
  std::vector<std::string> list = integrate::needed_functions(options_of(run, -1), has_power, nx);
  if (!run.events.empty()) list.emplace_back("events");
  list.emplace_back("energy");
  return list;
}

bool needs_taylor(const Run& run) { return integrate::needs_series(integrate::method_of(run.integrator)); }

std::vector<std::string> integrators() { return integrate::method_names(); }

Motion simulate(const Evaluator& evaluator, std::span<const double> x, std::span<const double> y, const Run& run,
                const Progress& progress) {
  const kanec_model& model = evaluator.model().abi();
  require_state(model, "x", x, model.nx);
  require_state(model, "y", y, model.ny);
  const integrate::Options options = options_of(run, model.n_inputs);
  Motion motion;
  motion.nx = model.nx;
  motion.ny = model.ny;
  const Summary summary = simulate(
      evaluator.data().solver, x, y, options,
      [&](const Row& row) {
        motion.t.push_back(row.t);
        append(motion.x, row.x);
        append(motion.y, row.y);
        motion.work.push_back(row.work);
        if (!row.energy) return;
        motion.kinetic.push_back(row.energy->kinetic);
        motion.potential.push_back(row.energy->potential);
      },
      progress);
  for (const integrate::Happening& happening : summary.events)
    motion.happenings.push_back({happening.t, happening.event, happening.up});
  motion.inputs = summary.inputs;
  motion.stopped = summary.stopped;
  motion.steps = summary.steps;
  motion.failed_steps = summary.failed;
  motion.evaluations = summary.evaluations;
  motion.wall_seconds = summary.wall_seconds;
  if (summary.energy) motion.energy_error = summary.energy->worst.relative();
  motion.norm_error = summary.worst_norm_error_before;
  return motion;
}

}  // namespace kanec
