// A scene's states in the relative coordinates of peer_abi.h, its loads as forces on these. Not: which states.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "runtime/bench/relative_model.hpp"
#include "runtime/model/state_file.hpp"

namespace kanec {

struct RelativeState {
  std::vector<double> q, u, force;
};

class RelativeStates {
 public:
  // The model must outlive this.
  RelativeStates(const scene::Scene& scene, const RelativeModel& model);

  // Of everything that acts in the state but gravity, also of springs and dampers.
  RelativeState of(const State& state) const;
  // The coordinates and speeds x and y of q and u, the inverse of that; the rest as `like` has it.
  State scene_state(const RelativeState& relative, const State& like) const;
  // The rates of u where those of y are the state's ydot.
  std::vector<double> rates(const State& state) const;

 private:
  struct Motion;
  Motion motion(const State& state) const;

  scene::Scene scene_, unloaded_;
  const RelativeModel& model_;
  scene::Layout layout_;
};

}  // namespace kanec
