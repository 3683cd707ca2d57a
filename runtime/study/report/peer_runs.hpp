// Other engines' integrators over accuracies or steps, with the error measures of ours. Not: how an engine is called
// (runtime/bench/peers.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "runtime/study/report/integration.hpp"
#include "runtime/study/report/reference.hpp"

namespace kanec {

struct PeerSweep {
  double duration = 0.0;  // [s]
  int rows = 0;
  double step = 0.0;   // the coarsest of equal steps [s]
  double limit = 0.0;  // of one run [s]
};

// By engine and integrator, coarse to fine; one failed run of an engine that cannot have the scene. `poll` is called
// between runs and may throw.
std::vector<IntegrationRun> peer_runs(const scene::Scene& scene, const std::vector<Peer>& peers, const PeerSweep& sweep,
                                      const Reference& reference, const std::function<void()>& poll);

}  // namespace kanec
