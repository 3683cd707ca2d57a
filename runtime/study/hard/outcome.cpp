// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/outcome.hpp"

#include <algorithm>
#include <cmath>

#include "generator/scene/place.hpp"
#include "runtime/base/error.hpp"
#include "runtime/generic/system.hpp"
#include "runtime/model/evaluate.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/run/integration_options.hpp"
#include "runtime/run/needed_functions.hpp"
#include "runtime/study/hard/answer.hpp"
#include "runtime/verify/paths.hpp"

namespace kanec::hard {
namespace {

// Energy against work along the run: the slope of the straight line nearest to it, times the duration.
class Drift {
 public:
  void add(double t, double value) {
    if (n_ == 0) first_ = value;
    const long double change = static_cast<long double>(value) - first_;
    ++n_;
    t_ += t;
    e_ += change;
    tt_ += static_cast<long double>(t) * t;
    te_ += t * change;
  }
  double total(double duration) const {
    const long double spread = n_ * tt_ - t_ * t_;
    return spread > 0 ? static_cast<double>(std::fabs((n_ * te_ - t_ * e_) / spread * duration)) : 0.0;
  }

 private:
  long double n_ = 0, first_ = 0, t_ = 0, e_ = 0, tt_ = 0, te_ = 0;
};

// Some states evenly along the run.
class Samples {
 public:
  Samples(const scene::Scene& scene, std::int64_t rows)
      : scene_(scene), every_(std::max<std::int64_t>(1, rows / most)) {}

  void add(const Row& row) {
    if (row_++ % every_ != 0 || std::ssize(states_) >= most) return;
    State state = initial_state(scene_);
    state.t = row.t;
    state.x.assign(row.x.begin(), row.x.end());
    state.y.assign(row.y.begin(), row.y.end());
    states_.push_back(std::move(state));
  }
  const std::vector<State>& states() const { return states_; }

 private:
  static constexpr std::int64_t most = 15;
  const scene::Scene& scene_;
  std::int64_t every_, row_ = 0;
  std::vector<State> states_;
};

// Of a linear momentum beside the largest that so much energy can have, √(2 m T): it may well be zero.
double of_momentum(const HardCase& hard, const Summary& summary) {
  const generic::System<double> system(hard.scene, scene::default_parameters(hard.scene));
  double mass = 0.0;
  for (int k = 1; k <= system.n_bodies(); ++k) mass += system.body(k).m;
  const double kinetic = std::max(summary.energy->start.kinetic, summary.energy->end.kinetic);
  return summary.linear_momentum->worst.value / std::sqrt(2 * mass * kinetic);
}

std::vector<Deviation> physical(const HardCase& hard, const Summary& summary, const Drift& drift, double duration) {
  std::vector<Deviation> list;
  if (summary.energy) {
    const double scale = summary.energy->worst.scale;
    list.push_back({"energy", "", summary.energy->worst.relative()});
    list.push_back({"energy_drift", "", scale > 0 ? drift.total(duration) / scale : 0.0});
  }
  if (summary.linear_momentum) list.push_back({"linear_momentum", "", of_momentum(hard, summary)});
  if (summary.angular_momentum) list.push_back({"angular_momentum", "", summary.angular_momentum->worst.relative()});
  list.push_back({"norm", "", summary.worst_norm_error_after});
  return list;
}

std::vector<Kept> kept(const HardCase& hard, const Length& length, const std::vector<Deviation>& deviations) {
  std::vector<Kept> list;
  std::vector<std::string> known;
  for (const Deviation& one : deviations) known.push_back(one.what);
  for (const Bound& bound : length.keeps) {
    const auto same = std::find_if(deviations.begin(), deviations.end(),
                                   [&](const Deviation& one) { return one.what == bound.what; });
    if (same == deviations.end())
      scene::fail({hard.file, 0, "", "keeps"}, scene::in_quotes(bound.what), scene::one_of(known, bound.what));
    list.push_back({same->what, same->unit, same->value, bound.most});
  }
  return list;
}

// What `action` returns; what an answer refuses is told with the line that names the answer.
template <class Action>
auto by_answer(const HardCase& hard, const Action& action) {
  try {
    return action();
  } catch (const InputError& error) {
    throw InputError(scene::remark({hard.file, hard.answer_line}, error.what()));
  }
}

// None where the case has none.
std::unique_ptr<Answer> answer_of(const HardCase& hard) {
  if (hard.answer.empty()) return nullptr;
  return by_answer(hard, [&] { return answer(hard.answer, hard.scene); });
}

std::vector<Length> lengths(const HardCase& hard) {
  std::vector<Length> list;
  for (const Run& run : hard.runs) list.insert(list.end(), {run.full, run.brief});
  return list;
}

}  // namespace

bool Outcome::holds() const {
  return failure.empty() && std::all_of(kept.begin(), kept.end(), [](const Kept& one) { return one.holds(); });
}

CompiledModel compiled(const HardCase& hard, const BuildOptions& arguments) {
  std::vector<std::string> functions = {"accelerations", "energy", "momentum"};
  bool with_series = false;
  for (const Length& length : lengths(hard)) {
    integrate::Options options = integration_options(hard.scene, length.settings);
    for (std::string& name : functions_to_integrate(hard.scene, options))
      if (std::find(functions.begin(), functions.end(), name) == functions.end()) functions.push_back(std::move(name));
    with_series |= integrate::needs_series(options.method);
  }
  return build(hard.scene, functions, arguments, with_series);
}

Outcome outcome(const HardCase& hard, const Length& length, const CompiledModel& model,
                const std::function<void(double)>& progress) {
  Outcome result;
  result.options = integration_options(hard.scene, length.settings);
  const State start = initial_state(hard.scene);
  const Solver solver = solver_of(model.library.abi(), hard.scene, start);
  const std::unique_ptr<Answer> known = answer_of(hard);
  Samples samples(hard.scene, integrate::RowTimes(result.options.duration, result.options.output_step).size());
  Drift drift;
  try {
    const auto add = [&](const Row& row) {
      if (row.energy) drift.add(row.t, row.energy->total() - row.work);
      if (known) by_answer(hard, [&] { known->compare(row); });
      samples.add(row);
    };
    result.summary = simulate(solver, start.x, start.y, result.options, add, progress);
  } catch (const IntegrationError& error) {
    result.failure = error.what();
    return result;
  }
  std::vector<Deviation> deviations = physical(hard, result.summary, drift, result.options.duration);
  if (known)
    for (Deviation& one : known->deviations()) deviations.push_back(std::move(one));
  result.kept = kept(hard, length, deviations);
  result.accelerations = rounding(model, hard.scene, samples.states());
  return result;
}

}  // namespace kanec::hard
