// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/trajectory/simulate.hpp"

#include <algorithm>
#include <chrono>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/events.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/stepper.hpp"
#include "runtime/integrate/system.hpp"

namespace kanec {

using namespace integrate;

namespace {

std::function<void(double)> at_time(const Options& options, const Progress& progress) {
  if (!progress || options.duration == options.start) return {};
  return [&progress, start = options.start, stretch = options.duration - options.start](double t) {
    progress((t - start) / stretch);
  };
}

void require_finite(const System& system, double t, std::span<const double> z) {
  if (const int index = first_not_finite(z); index >= 0)
    throw IntegrationError("integration stopped at t = " + shortest(t) + " s: " + system.component(index) +
                           " is not finite");
}

// One run, from row to row, through its events.
class Run {
 public:
  Run(Solver& solver, System& system, Stepper& stepper, const StepBook& book, const Options& options,
      const Observer& observer)
      : solver_(solver),
        system_(system),
        stepper_(stepper),
        book_(book),
        options_(options),
        observer_(observer),
        balance_(solver),
        seen_(options.start),
        looked_at_(options.start) {
    if (!options.events.empty()) watch_.emplace(solver, options.events);
  }

  Summary summary() {
    const RowTimes times(options_.duration, options_.output_step, options_.start);
    add_row(times[0], stepper_.at(times[0]));
    if (watch_) watch_->begin(times[0], stepper_.at(times[0]));
    for (std::int64_t i = 1; i < times.size(); ++i) {
      if (!reach(times[i])) break;
      add_row(times[i], stepper_.at(times[i]));
    }
    summary_.energy = balance_.energy();
    summary_.linear_momentum = balance_.linear_momentum();
    summary_.angular_momentum = balance_.angular_momentum();
    summary_.inputs.assign(solver_.inputs().begin(), solver_.inputs().end());
    return std::move(summary_);
  }

 private:
  // False where an event stops the run before or there.
  bool reach(double t) {
    while (seen_ < t) {
      if (stepper_.time() <= seen_) {
        stepper_.step(t);
        require_progress();
      }
      const double end = std::min(stepper_.time(), t);
      const std::optional<double> event = watch_ ? watch_->next(stepper_, seen_, end) : std::nullopt;
      seen_ = event.value_or(end);
      if (event && !happen(*event, t)) return false;
    }
    return true;
  }

  // Where a load switches back and forth, or is stiff, steps may become so short that the end is never reached.
  void require_progress() {
    constexpr std::int64_t between_looks = 100'000;
    constexpr double least_part = 1e-6;  // of what is left
    const std::int64_t tried = book_.steps + book_.failed;
    if (tried < next_look_) return;
    const double t = stepper_.time(), gone = t - looked_at_;
    if (next_look_ > between_looks && gone < least_part * (options_.duration - t)) {
      const std::span<const double> state = stepper_.at(t);
      const std::vector<double> z(state.begin(), state.end());
      throw IntegrationError(
          "integration stopped at t = " + shortest(t) + " s: the last " + std::to_string(between_looks) +
          " steps, those tried again among them, went " + shortest(gone) + " s; what changes fastest there is " +
          system_.fastest(t, z.data()) +
          ": a load that switches back and forth, or a stiff one (cvode_bdf and arkode_dirk are for these)");
    }
    looked_at_ = t;
    next_look_ = tried + between_looks;
  }

  bool happen(double t, double next_row) {
    const std::span<const double> state = stepper_.at(t);
    const std::vector<double> z(state.begin(), state.end());
    bool has_row = false;
    const std::vector<double> before(solver_.inputs().begin(), solver_.inputs().end());
    std::vector<double> inputs = before;
    for (const Happening& happening : watch_->cross(t, z)) {
      add(happening);
      const Event& event = options_.events[static_cast<std::size_t>(happening.event)];
      has_row = has_row || event.has_row;
      summary_.stopped = summary_.stopped || event.stops;
      for (const Event::Setting& setting : event.settings)
        inputs[static_cast<std::size_t>(setting.input)] = setting.value;
    }
    // before the row, so that a run goes on from it with them
    if (inputs != before) solver_.set_inputs(inputs);
    if (summary_.stopped || (has_row && t < next_row)) add_row(t, z);
    if (summary_.stopped || inputs == before) return !summary_.stopped;
    stepper_.restart(t, z);
    watch_->inputs_changed(t, z);
    return true;
  }

  // Loads that switch each other on and off at one place would go on for ever.
  void add(const Happening& happening) {
    constexpr std::size_t most = 100'000;
    if (summary_.events.size() == most)
      throw IntegrationError("integration stopped at t = " + shortest(happening.t) + " s: more than " +
                             std::to_string(most) + " events, the last one " +
                             options_.events[static_cast<std::size_t>(happening.event)].name);
    summary_.events.push_back(happening);
  }

  void add_row(double t, std::span<const double> z) {
    require_finite(system_, t, z);
    const auto nx = static_cast<std::size_t>(system_.nx()), ny = static_cast<std::size_t>(system_.ny());
    Row row{t, z.first(nx), z.subspan(nx, ny), system_.has_work() ? z[nx + ny] : 0.0, {}, solver_.inputs()};
    row.energy = balance_.add(row.t, row.x.data(), row.y.data(), row.work);
    summary_.worst_norm_error_after = worse(summary_.worst_norm_error_after, norm_error(z.data(), system_.attitudes()));
    if (observer_) observer_(row);
    ++summary_.rows;
    summary_.t = t;
    summary_.x.assign(row.x.begin(), row.x.end());
    summary_.y.assign(row.y.begin(), row.y.end());
  }

  Solver& solver_;
  System& system_;
  Stepper& stepper_;
  const StepBook& book_;
  const Options& options_;
  const Observer& observer_;
  Balance balance_;
  std::optional<EventWatch> watch_;
  double seen_;       // until here nothing is missed
  double looked_at_;  // the time at the last look at the pace, and the step of the next one
  std::int64_t next_look_ = 100'000;
  Summary summary_;
};

}  // namespace

Summary simulate(const Solver& solver, std::span<const double> x, std::span<const double> y, const Options& options,
                 const Observer& observer, const Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  check(options);
  Solver own = solver;  // whose inputs events may set
  System system(own);
  StepBook book(options.max_steps, at_time(options, progress));
  const auto stepper = make_stepper(system, system.initial_state(x, y, options.work), options, book);
  Summary summary = Run(own, system, *stepper, book, options, observer).summary();
  summary.steps = book.steps;
  summary.failed = book.failed;
  summary.restarts = book.restarts;
  summary.evaluations = system.evaluations();
  summary.jacobians = book.jacobians;
  summary.worst_norm_error_before = book.worst_norm_error;
  summary.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return summary;
}

}  // namespace kanec
