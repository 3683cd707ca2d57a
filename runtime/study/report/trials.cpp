// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/trials.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/model/evaluate.hpp"
#include "runtime/model/state_file.hpp"
#include "runtime/study/report/least_time.hpp"
#include "runtime/verify/paths.hpp"

namespace kanec {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); }

class OutOfTime : public Error {
 public:
  using Error::Error;
};

// Looks at the clock every so many steps alone, which would take longer than a step of a small model.
class Deadline {
 public:
  Deadline(double limit, double duration, const std::function<void()>& poll)
      : limit_(limit), duration_(duration), poll_(poll) {}

  void step(double fraction) {
    constexpr int steps_between = 64;
    if (++steps_ % steps_between != 0) return;
    poll_();
    if (seconds_since(begin_) > limit_)
      throw OutOfTime(fmt::format("time limit of {} s reached at t = {:.3g} of {} s", shortest(limit_),
                                  fraction * duration_, shortest(duration_)));
  }

 private:
  double limit_, duration_;
  const std::function<void()>& poll_;
  Clock::time_point begin_ = Clock::now();
  int steps_ = 0;
};

}  // namespace

Trials::Trials(const scene::Scene& scene, const kanec_model& model, std::function<void()> poll)
    : poll_(std::move(poll)),
      system_(scene, scene::default_parameters(scene)),
      solver_(solver_of(model, scene, initial_state(scene))),
      x_(scene::initial_coordinates(scene)),
      y_(scene::initial_speeds(scene)) {}

Trial Trials::once(const integrate::Options& options, double limit) const {
  Trial trial{options, {}, false, {}, 0.0, {}};
  struct Kept {
    double t;
    std::vector<double> x, y;
  };
  std::vector<Kept> states;
  const auto keep = [&](const Row& row) {
    states.push_back({row.t, {row.x.begin(), row.x.end()}, {row.y.begin(), row.y.end()}});
  };
  Deadline deadline(limit, options.duration, poll_);
  const Clock::time_point begin = Clock::now();
  try {
    trial.summary = simulate(solver_, x_, y_, options, keep, [&](double done) { deadline.step(done); });
    trial.wall_seconds = trial.summary.wall_seconds;
    for (const Kept& state : states) trial.rows.push_back(bodies_at(system_, state.t, state.x, state.y));
  } catch (const InternalError&) {
    throw;
  } catch (const Error& error) {
    trial.failure = error.what();
    trial.out_of_time = dynamic_cast<const OutOfTime*>(&error) != nullptr;
    trial.wall_seconds = seconds_since(begin);
  }
  return trial;
}

double Trials::wall_seconds(const integrate::Options& options) const {
  poll_();
  return simulate(solver_, x_, y_, options).wall_seconds;
}

Trial Trials::timed(const integrate::Options& options, double limit) const {
  Trial trial = once(options, limit);
  if (!trial.ok()) return trial;
  repeat_while_short(trial.wall_seconds, [&] {
    const double seconds = wall_seconds(options);
    trial.wall_seconds = std::min(trial.wall_seconds, seconds);
    return seconds;
  });
  return trial;
}

}  // namespace kanec
