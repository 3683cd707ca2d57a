// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/integration.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/run/conservation.hpp"
#include "runtime/run/watched_events.hpp"
#include "runtime/study/report/choice.hpp"
#include "runtime/study/report/methods.hpp"
#include "runtime/study/report/peer_runs.hpp"
#include "runtime/study/report/reference.hpp"
#include "runtime/study/report/refinement.hpp"
#include "runtime/study/report/trials.hpp"

namespace kanec {
namespace {

using integrate::Method;
using integrate::Options;

// Where rounding leaves nothing to gain.
int last_decade(Method method) {
  if (method == Method::taylor_extended) return 19;
  return method == Method::taylor ? 17 : finest_decade;
}

// Changes beside the largest momentum there was, or, where that vanishes, beside what the energies come to.
double momentum_error(const Summary& summary, const MotionScales& scales) {
  const double energy = summary.energy ? summary.energy->worst.scale : 0.0;
  const auto beside = [](const Deviation& change, double usual) {
    const double scale = std::max(change.scale, usual);
    return change.value == 0.0 || scale == 0.0 ? 0.0 : change.value / scale;
  };
  const double angular = scales.rate > 0.0 ? energy / scales.rate : 0.0;
  const double linear = scales.length > 0.0 ? angular / scales.length : 0.0;
  return std::max(beside(summary.angular_momentum->worst, angular), beside(summary.linear_momentum->worst, linear));
}

class Sweep {
 public:
  Sweep(const scene::Scene& scene, const kanec_model& model, const IntegrationOptions& options,
        const std::function<void(double)>& progress)
      : scene_(scene),
        options_(options),
        progress_(progress),
        methods_(named_methods(scene, options.integrators)),
        conserved_{is_isolated(scene), has_drives(scene)},
        has_attitudes_(model.n_attitudes > 0),
        trials_(scene, model, [this] { progress_(done_ / total()); }) {
    base_.events = watched_events(scene);
    for (integrate::Event& event : base_.events) event.has_row = false;  // rows at the same times in every run
    base_.longest_step = scene.simulation.longest_step;
    base_.has_kinks = scene::has_kinks(scene);
    base_.duration = options.duration.value_or(scene.simulation.duration);
    base_.relative_tolerance = scene.simulation.relative_tolerance;
    base_.absolute_tolerance = scene.simulation.absolute_tolerance;
    require(base_.duration);
    base_.output_step = base_.duration / options.rows;
  }

  SceneRuns all() {
    const double step = usual_step();
    reference_ = reference(trials_, base_, step, reference_share * options_.limit);
    ++done_;
    for (const NamedMethod& method : methods_) {
      has_fixed_step(method.options.method) ? with_steps(method, step) : with_tolerances(method);
      ++done_;
    }
    add_peers(step);
    SceneRuns result;
    result.duration = base_.duration;
    result.end = end_;
    result.rows = std::ssize(reference_.rows) - 1;
    result.scales = reference_.scales;
    result.reference = reference_.description;
    result.coarser = reference_.coarser;
    result.check = reference_.check;
    result.reference_error = reference_.own_error;
    result.check_difference = reference_.check_difference;
    result.is_disputed = reference_.is_disputed;
    result.runs = std::move(runs_);
    mark_front(result.runs, result.reference_error);
    return result;
  }

 private:
  struct Conserved {
    bool momentum, driven;
  };

  static void require(double duration) {
    if (!(duration > 0.0) || !std::isfinite(duration))
      throw InputError("duration: found " + shortest(duration) + "; allowed: a positive number");
  }

  double total() const { return static_cast<double>(methods_.size()) + 1.0; }

  // Of rows halved so often that error control with the coarsest tolerance takes steps about twice as long.
  double usual_step() const {
    const Trial trial = trials_.once(at_tolerance({}, coarsest_decade), options_.limit);
    double step = base_.output_step;
    if (!trial.ok()) return step;
    const double mean = base_.duration / static_cast<double>(std::max<std::int64_t>(trial.summary.steps, 1));
    while (step > 2.0 * mean) step /= 2.0;
    return step;
  }

  Options with(const Options& method) const {
    Options options = base_;
    options.method = method.method;
    options.jacobian = method.jacobian;
    return options;
  }

  Options at_tolerance(const Options& method, int decade) const {
    Options options = with(method);
    options.relative_tolerance = std::pow(10.0, -decade);
    options.absolute_tolerance = options.relative_tolerance * (base_.absolute_tolerance / base_.relative_tolerance);
    return options;
  }

  // Finer ones would be given up as well once one was.
  void with_tolerances(const NamedMethod& method) {
    for (int decade = coarsest_decade; decade <= last_decade(method.options.method); ++decade) {
      const Trial trial = trials_.timed(at_tolerance(method.options, decade), options_.limit);
      add(trial);
      if (trial.out_of_time) return;
    }
  }

  void with_steps(const NamedMethod& method, double step) {
    Refinement refinement(reference_.own_error);
    for (int i = 0; i < most_halvings; ++i, step /= 2.0) {
      Options options = with(method.options);
      options.step = step;
      const Trial trial = trials_.timed(options, options_.limit);
      add(trial);
      if (trial.out_of_time || (trial.ok() && refinement.is_done(runs_.back().worst_error))) return;
    }
  }

  void add_peers(double step) {
    if (options_.peers.empty()) return;
    const auto poll = [this] { progress_(done_ / total()); };
    const PeerSweep sweep{base_.duration, options_.rows, step, options_.limit};
    for (IntegrationRun& run : peer_runs(scene_, options_.peers, sweep, reference_, poll))
      runs_.push_back(std::move(run));
  }

  void add(const Trial& trial) {
    IntegrationRun run = run_with(trial.options);
    run.failure = trial.failure + (trial.out_of_time ? "; finer ones are left out" : "");
    run.wall_seconds = trial.wall_seconds;
    if (trial.ok() && trial.rows.size() != reference_.rows.size())
      run.failure = "an event ended it after " + std::to_string(trial.rows.size()) + " rows, the reference after " +
                    std::to_string(reference_.rows.size());
    if (run.ok()) judge(trial, run);
    runs_.push_back(std::move(run));
  }

  void judge(const Trial& trial, IntegrationRun& run) {
    const Summary& summary = trial.summary;
    run.steps = summary.steps;
    run.rejected = summary.failed;
    run.evaluations = summary.evaluations;
    if (has_jacobian(trial.options.method)) run.jacobians = summary.jacobians;
    measure(run, trial.rows, reference_);
    if (summary.stopped && !(run.worst_error >= least_error_)) {
      least_error_ = run.worst_error;
      end_ = summary.t;
    }
    if (summary.energy && !conserved_.driven) run.energy = summary.energy->worst.relative();
    if (summary.angular_momentum && conserved_.momentum) run.momentum = momentum_error(summary, reference_.scales);
    if (has_attitudes_) run.norm = summary.worst_norm_error_before;
  }

  static constexpr double reference_share = 5.0;  // of the time of one run

  const scene::Scene& scene_;
  const IntegrationOptions& options_;
  const std::function<void(double)>& progress_;
  std::vector<NamedMethod> methods_;
  Conserved conserved_;
  bool has_attitudes_;
  double done_ = 0.0;  // methods, and the reference
  Trials trials_;
  Options base_;
  Reference reference_;
  std::vector<IntegrationRun> runs_;
  double least_error_ = std::numeric_limits<double>::infinity();  // of the runs that an event ended
  std::optional<double> end_;                                     // of that run [s]
};

}  // namespace

IntegrationRun run_with(const Options& options) {
  IntegrationRun run;
  run.method = name_of(options);
  run.setting = setting_text(options);
  if (has_fixed_step(options.method))
    run.step = options.step;
  else
    run.tolerance = options.relative_tolerance;
  run.options = options;
  return run;
}

void measure(IntegrationRun& run, const std::vector<Bodies>& rows, const Reference& reference) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    run.end = difference(rows[i], reference.rows[i]);
    run.worst = worse(run.worst, run.end);
  }
  run.end_error = relative(run.end, reference.scales);
  run.worst_error = relative(run.worst, reference.scales);
}

std::vector<std::string> integration_functions(const scene::Scene& scene, const IntegrationOptions& options) {
  std::vector<std::string> list = functions_called(scene, named_methods(scene, options.integrators));
  list.insert(list.end(), {"energy", "momentum"});
  return list;
}

SceneRuns integration_runs(const scene::Scene& scene, const kanec_model& model, const IntegrationOptions& options,
                           const std::function<void(double)>& progress) {
  SceneRuns runs = Sweep(scene, model, options, progress).all();
  runs.model = scene.name;
  runs.settings = scene.simulation;
  return runs;
}

}  // namespace kanec
