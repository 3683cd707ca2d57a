// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/peer_runs.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/study/report/least_time.hpp"
#include "runtime/study/report/refinement.hpp"

namespace kanec {
namespace {

// Beyond gravity: what acts changes with the state, and other engines are told of none of it.
void require_gravity_alone(const scene::Scene& scene) {
  const bool is_loaded = std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const scene::Body& body) {
    return !is_zero(body.force) || !is_zero(body.moment);
  });
  if (is_loaded || !scene.loads.empty()) throw NotModelled("loads other than gravity");
  if (!scene.events.empty()) throw NotModelled("events");
}

// One scene in one engine.
class Engine {
 public:
  Engine(const scene::Scene& scene, const Peer& peer, const PeerSweep& sweep, const Reference& reference,
         const std::function<void()>& poll)
      : peer_(peer),
        sweep_(sweep),
        reference_(reference),
        poll_(poll),
        model_(relative_model(scene)),
        states_(scene, model_),
        initial_(initial_state(scene)),
        system_(scene, initial_.parameters),
        simulation_(peer, model_, {states_.of(initial_)}) {
    for (int row = 1; row <= sweep.rows; ++row) times_.push_back(sweep.duration * row / sweep.rows);
  }

  void append_to(std::vector<IntegrationRun>& runs) {
    for (int i = 0; i < peer_.functions().n_integrators; ++i)
      peer_.functions().integrators[i].has_fixed_step != 0 ? with_steps(i, runs) : with_accuracies(i, runs);
  }

 private:
  // Twice as many as kanec's own have tolerances, so that what another engine takes for an error is not overstated.
  void with_accuracies(int integrator, std::vector<IntegrationRun>& runs) {
    for (int half = 2 * coarsest_decade; half <= 2 * finest_decade; ++half) {
      IntegrationRun run;
      run.tolerance = std::pow(10.0, -half / 2.0);
      run.setting = fmt::format("accuracy {:.0e}", run.tolerance);
      if (runs.push_back(done(integrator, run.tolerance, std::move(run))); is_late_) return;
    }
  }

  void with_steps(int integrator, std::vector<IntegrationRun>& runs) {
    Refinement refinement(reference_.own_error);
    double step = sweep_.step;
    for (int i = 0; i < most_halvings; ++i, step /= 2.0) {
      IntegrationRun run;
      run.step = step;
      run.setting = fmt::format("h {:.3g} s", step);
      runs.push_back(done(integrator, step, std::move(run)));
      if (is_late_ || (runs.back().ok() && refinement.is_done(runs.back().worst_error))) return;
    }
  }

  IntegrationRun done(int integrator, double fineness, IntegrationRun run) {
    run.method = peer_.name() + ", " + peer_.functions().integrators[integrator].name;
    is_late_ = false;
    try {
      const PeerMotion motion = timed(integrator, fineness);
      is_late_ = motion.is_late;
      run.wall_seconds = motion.seconds;
      run.steps = motion.steps;
      run.evaluations = motion.evaluations;
      if (is_late_) {
        run.failure = fmt::format("time limit of {} s reached; finer ones are left out", shortest(sweep_.limit));
      } else {
        measure(run, rows_of(motion), reference_);
      }
    } catch (const IntegrationError& error) {
      run.failure = error.what();
    }
    return run;
  }

  // Again while that is short, so that the least wall time counts.
  PeerMotion timed(int integrator, double fineness) {
    PeerMotion best = once(integrator, fineness);
    if (best.is_late) return best;
    repeat_while_short(best.seconds, [&] {
      PeerMotion again = once(integrator, fineness);
      const double seconds = again.seconds;
      if (seconds < best.seconds && !again.is_late) best = std::move(again);
      return seconds;
    });
    return best;
  }

  PeerMotion once(int integrator, double fineness) {
    poll_();
    return simulation_.integrate(0, integrator, fineness, times_, sweep_.limit);
  }

  std::vector<Bodies> rows_of(const PeerMotion& motion) const {
    std::vector<Bodies> rows = {bodies_at(system_, 0.0, initial_.x, initial_.y)};
    for (std::size_t i = 0; i < times_.size(); ++i) {
      const State state = states_.scene_state(motion.states[i], initial_);
      rows.push_back(bodies_at(system_, times_[i], state.x, state.y));
    }
    return rows;
  }

  const Peer& peer_;
  const PeerSweep& sweep_;
  const Reference& reference_;
  const std::function<void()>& poll_;
  RelativeModel model_;
  RelativeStates states_;
  State initial_;
  generic::System<long double> system_;
  PeerSimulation simulation_;
  std::vector<double> times_;
  bool is_late_ = false;
};

}  // namespace

std::vector<IntegrationRun> peer_runs(const scene::Scene& scene, const std::vector<Peer>& peers, const PeerSweep& sweep,
                                      const Reference& reference, const std::function<void()>& poll) {
  std::vector<IntegrationRun> runs;
  for (const Peer& peer : peers) {
    if (peer.functions().n_integrators == 0) continue;
    try {
      require_gravity_alone(scene);
      Engine(scene, peer, sweep, reference, poll).append_to(runs);
    } catch (const NotModelled& error) {
      IntegrationRun run;
      run.method = peer.name();
      run.failure = std::string("not modelled: ") + error.what();
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

}  // namespace kanec
