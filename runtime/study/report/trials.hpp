// Runs of one scene's model with one integrator each: rows compared later, wall time, what was kept, or why it failed.
// Not: which integrators and how finely (integration.hpp), nor how far off they are (motion_error.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/study/report/motion_error.hpp"
#include "runtime/trajectory/simulate.hpp"

namespace kanec {

struct Trial {
  integrate::Options options;
  std::string failure;        // empty: it went through
  bool out_of_time = false;   // why it failed
  Summary summary;            // of one that went through
  double wall_seconds = 0.0;  // the least of its runs; of a failed one, until it failed
  std::vector<Bodies> rows;   // of one that went through

  bool ok() const { return failure.empty(); }
};

class Trials {
 public:
  // `poll` is called now and then during runs, and may throw. The model must outlive the trials.
  Trials(const scene::Scene& scene, const kanec_model& model, std::function<void()> poll);

  // One run, given up after `limit` [s].
  Trial once(const integrate::Options& options, double limit) const;
  // The same, run again while that is short, so that the least wall time counts.
  Trial timed(const integrate::Options& options, double limit) const;

 private:
  double wall_seconds(const integrate::Options& options) const;

  std::function<void()> poll_;
  generic::System<long double> system_;
  Solver solver_;
  std::vector<double> x_, y_;
};

}  // namespace kanec
