// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/simulate.hpp"

#include <chrono>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/stepper.hpp"
#include "runtime/integrate/system.hpp"

namespace kanec::integrate {
namespace {

std::function<void(double)> at_time(const Options& options, const Progress& progress) {
  if (!progress || options.duration == 0.0) return {};
  return [&progress, duration = options.duration](double t) { progress(t / duration); };
}

void require_finite(const System& system, double t, std::span<const double> z) {
  if (const int index = first_not_finite(z); index >= 0)
    throw IntegrationError("integration stopped at t = " + shortest(t) + " s: " + system.component(index) +
                           " is not finite");
}

Row row_at(const System& system, double t, std::span<const double> z) {
  const auto nx = static_cast<std::size_t>(system.nx()), ny = static_cast<std::size_t>(system.ny());
  return {t, z.first(nx), z.subspan(nx, ny), system.has_work() ? z[nx + ny] : 0.0, {}};
}

Summary run(const Solver& solver, System& system, Stepper& stepper, const Options& options, const Observer& observer) {
  Summary summary;
  Balance balance(solver);
  const RowTimes times(options.duration, options.output_step);
  for (std::int64_t i = 0; i < times.size(); ++i) {
    const std::span<const double> z = stepper.advance(times[i]);
    require_finite(system, times[i], z);
    Row row = row_at(system, times[i], z);
    row.energy = balance.add(row.t, row.x.data(), row.y.data(), row.work);
    summary.worst_norm_error_after = worse(summary.worst_norm_error_after, norm_error(z.data(), system.attitudes()));
    if (observer) observer(row);
    if (i + 1 < times.size()) continue;
    summary.x.assign(row.x.begin(), row.x.end());
    summary.y.assign(row.y.begin(), row.y.end());
  }
  summary.rows = times.size();
  summary.energy = balance.energy();
  summary.linear_momentum = balance.linear_momentum();
  summary.angular_momentum = balance.angular_momentum();
  return summary;
}

}  // namespace

Summary simulate(const Solver& solver, std::span<const double> x, std::span<const double> y, const Options& options,
                 const Observer& observer, const Progress& progress) {
  const auto begin = std::chrono::steady_clock::now();
  check(options);
  System system(solver);
  StepBook book(options.max_steps, at_time(options, progress));
  const auto stepper = make_stepper(system, system.initial_state(x, y), options, book);
  Summary summary = run(solver, system, *stepper, options, observer);
  summary.steps = book.steps;
  summary.failed = book.failed;
  summary.restarts = book.restarts;
  summary.evaluations = system.evaluations();
  summary.jacobians = book.jacobians;
  summary.worst_norm_error_before = book.worst_norm_error;
  summary.wall_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return summary;
}

}  // namespace kanec::integrate
