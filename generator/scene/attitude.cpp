// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/attitude.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "generator/scene/expression_value.hpp"

namespace kanec::scene {
namespace {

constexpr long double least_direction_sine = 1e-9L;  // between directions that are told apart

long double initial_value(const Scene& scene, const Coordinate& coordinate) {
  if (coordinate.motion != Coordinate::Motion::prescribed) return coordinate.value;
  return value(scene.expressions[static_cast<std::size_t>(coordinate.expression)], scene.parameters);
}

// Of unit norm in extended precision as well.
Turn ball_turn(const BallState& state) {
  std::array<long double, 4> eps;
  std::copy(state.eps.begin(), state.eps.end(), eps.begin());
  const long double norm = std::sqrt(eps[0] * eps[0] + eps[1] * eps[1] + eps[2] * eps[2] + eps[3] * eps[3]);
  for (long double& e : eps) e /= norm;
  return turn_of_eps(eps);
}

// Each axis as the turns before it have left it.
Attitude attitude(const Scene& scene, const Body& body, const Turn& lower) {
  Attitude out;
  Turn turned = lower;
  for (const Coordinate& coordinate : body.joint.turns) {
    const Direction axis = direction(coordinate.axis);
    out.axes.push_back(turned * axis);
    turned = turned * turn_about(axis, initial_value(scene, coordinate));
  }
  for (const Coordinate& coordinate : body.joint.slides) out.slide_axes.push_back(lower * direction(coordinate.axis));
  out.turn = body.joint.ball ? ball_turn(body.initial) : turned * turn(body.joint.zero);
  return out;
}

// What a body turns about: nothing, one direction, or several.
struct Turning {
  std::optional<Direction> direction;
  bool several = false;
};

Turning with(Turning turning, const Joint& joint, const Attitude& attitude) {
  for (std::size_t i = 0; i < joint.turns.size(); ++i) {
    if (joint.turns[i].motion == Coordinate::Motion::locked) continue;
    if (turning.direction && norm(cross(*turning.direction, attitude.axes[i])) > least_direction_sine)
      turning.several = true;
    turning.direction = attitude.axes[i];
  }
  return turning;
}

}  // namespace

std::vector<Attitude> initial_attitudes(const Scene& scene) {
  std::vector<Attitude> out;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const int lower = scene.lower[k];
    out.push_back(
        attitude(scene, scene.bodies[k], lower == 0 ? no_turn : out[static_cast<std::size_t>(lower - 1)].turn));
  }
  return out;
}

std::vector<bool> turns_about_one_direction(const Scene& scene, const std::vector<Attitude>& attitudes) {
  std::vector<Turning> turnings;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const Joint& joint = scene.bodies[k].joint;
    const int lower = scene.lower[k];
    // the attitude of a ball is its own, not that of its lower body
    const Turning below = lower == 0 || joint.ball ? Turning{} : turnings[static_cast<std::size_t>(lower - 1)];
    turnings.push_back(joint.ball ? Turning{{}, !joint.held} : with(below, joint, attitudes[k]));
  }
  std::vector<bool> out;
  for (const Turning& turning : turnings) out.push_back(!turning.several);
  return out;
}

}  // namespace kanec::scene
