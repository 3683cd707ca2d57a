// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/states.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace kanec {
namespace {

using scene::Axis;

Axis cross(const Axis& a, const Axis& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double dot(const Axis& a, const Axis& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

// The volume that the three axes of a joint span when the second angle is theta, of the most that it can be: 1 where
// the third axis stands straight on the plane of the first two, 0 at gimbal lock.
double spread(const std::vector<scene::Coordinate>& turns, double theta) {
  const Axis &a = turns[0].axis, &b = turns[1].axis, &c = turns[2].axis;
  const Axis ab = cross(a, b), bc = cross(b, c);
  const double most = std::sqrt(dot(ab, ab) * dot(bc, bc));
  // a · (b × c turned by theta about b) = (a × b) · c turned; what is along b stays, and has no part in it
  const double volume = std::cos(theta) * dot(ab, c) + std::sin(theta) * dot(ab, bc);
  return most == 0.0 ? 1.0 : std::fabs(volume) / most;
}

void random_angles(const scene::Joint& joint, const std::vector<int>& at, Random& random, std::vector<double>& x) {
  constexpr double least_spread = 0.3;
  for (std::size_t i = 0; i < at.size(); ++i) {
    if (at[i] < 0) continue;
    double& theta = x[static_cast<std::size_t>(at[i])];
    do theta = random.between(-std::numbers::pi, std::numbers::pi);
    while (i == 1 && at.size() == 3 && spread(joint.turns, theta) < least_spread);
  }
}

}  // namespace

std::vector<double> Random::numbers(std::size_t count) {
  std::vector<double> list(count);
  for (double& number : list) number = between(-1.0, 1.0);
  return list;
}

// From the ball within the cube, away from its centre.
void Random::unit(double* eps) {
  double norm = 0.0;
  do {
    for (int i = 0; i < 4; ++i) eps[i] = between(-1.0, 1.0);
    norm = std::hypot(std::hypot(eps[0], eps[1]), std::hypot(eps[2], eps[3]));
  } while (norm > 1.0 || norm < 0.1);
  for (int i = 0; i < 4; ++i) eps[i] /= norm;
}

bool reads_time(const scene::Scene& scene) {
  return std::any_of(scene.expressions.begin(), scene.expressions.end(), [](const scene::Expression& expression) {
    return std::any_of(expression.nodes.begin(), expression.nodes.end(), [](const scene::ExpressionNode& node) {
      return node.kind == scene::ExpressionNode::Kind::time;
    });
  });
}

RandomState random_state(const scene::Scene& scene, Random& random) {
  const scene::Layout layout(scene);
  const auto ny = static_cast<std::size_t>(layout.ny);
  RandomState state;
  if (reads_time(scene)) state.t = random.between(0.0, 1.0);
  state.x = random.numbers(static_cast<std::size_t>(layout.nx));
  for (std::size_t k = 0; k < layout.bodies.size(); ++k) {
    const scene::BodyLayout& at = layout.bodies[k];
    if (at.eps >= 0) random.unit(&state.x[static_cast<std::size_t>(at.eps)]);
    random_angles(scene.bodies[k].joint, at.theta, random, state.x);
  }
  state.y = random.numbers(ny);
  state.ydot = random.numbers(ny);
  return state;
}

std::vector<double> random_inputs(const scene::Scene& scene, Random& random) {
  std::vector<double> inputs = default_inputs(scene);
  for (double& input : inputs) input += random.between(-1.0, 1.0) * (1.0 + std::fabs(input));
  return inputs;
}

}  // namespace kanec
