// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/run/integration_options.hpp"

#include "runtime/run/watched_events.hpp"

namespace kanec {

integrate::Options integration_options(const scene::Scene& scene, const scene::Simulation& run) {
  integrate::Options options;
  options.events = watched_events(scene);
  options.method = integrate::method_of(run.integrator);
  options.duration = run.duration;
  options.output_step = run.output_step;
  options.step = run.step;
  options.longest_step = run.longest_step;
  options.has_kinks = scene::has_kinks(scene);
  options.relative_tolerance = run.relative_tolerance;
  options.absolute_tolerance = run.absolute_tolerance;
  options.jacobian = integrate::jacobian_of(run.jacobian);
  options.order = run.order;
  return options;
}

}  // namespace kanec
