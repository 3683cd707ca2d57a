// How the bodies stand and about what they turn when the motion begins. Not: positions, or any later time.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "generator/scene/rotation.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// At t = 0 of one body, prescribed coordinates with the defaults of the parameters.
struct Attitude {
  Turn turn = no_turn;          // R_Kᵀ: components in its axes to inertial ones
  std::vector<Direction> axes;  // of its joint's turns, inertial axes
  std::vector<Direction> slide_axes;
};

// Of body K: [K - 1].
std::vector<Attitude> initial_attitudes(const Scene& scene);

// Whether a body can turn about no more than one direction, whatever moves: locked and held coordinates do not.
std::vector<bool> turns_about_one_direction(const Scene& scene, const std::vector<Attitude>& attitudes);

}  // namespace kanec::scene
