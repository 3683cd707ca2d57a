// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/scene.hpp"

#include <algorithm>

namespace kanec::scene {
namespace {

std::vector<double> values(const std::vector<Named>& list) {
  std::vector<double> out;
  for (const Named& named : list) out.push_back(named.value);
  return out;
}

}  // namespace

std::vector<double> initial_coordinates(const Scene& scene) {
  const Layout layout(scene);
  std::vector<double> x(static_cast<std::size_t>(layout.nx));
  const auto set = [&](const std::vector<Coordinate>& coordinates, const std::vector<int>& at) {
    for (std::size_t i = 0; i < at.size(); ++i)
      if (at[i] >= 0) x[static_cast<std::size_t>(at[i])] = coordinates[i].value;
  };
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const BodyLayout& at = layout.bodies[k];
    const auto& eps = scene.bodies[k].initial.eps;
    if (at.eps >= 0) std::copy(eps.begin(), eps.end(), x.begin() + at.eps);
    set(scene.bodies[k].joint.turns, at.theta);
    set(scene.bodies[k].joint.slides, at.s);
  }
  return x;
}

std::vector<double> initial_speeds(const Scene& scene) {
  const Layout layout(scene);
  std::vector<double> y(static_cast<std::size_t>(layout.ny));
  const auto set = [&](const std::vector<Coordinate>& coordinates, const std::vector<int>& at) {
    for (std::size_t i = 0; i < at.size(); ++i)
      if (at[i] >= 0) y[static_cast<std::size_t>(at[i])] = coordinates[i].rate;
  };
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const BodyLayout& at = layout.bodies[k];
    const auto& omega = scene.bodies[k].initial.omega;
    if (at.omega >= 0) std::copy(omega.begin(), omega.end(), y.begin() + at.omega);
    set(scene.bodies[k].joint.turns, at.thetadot);
    set(scene.bodies[k].joint.slides, at.sdot);
  }
  return y;
}

std::vector<double> default_parameters(const Scene& scene) { return values(scene.parameters); }
std::vector<double> default_inputs(const Scene& scene) { return values(scene.inputs); }

bool has_kinks(const Scene& scene) {
  const auto is_kink = [](const ExpressionNode& node) {
    return node.kind == ExpressionNode::Kind::call &&
           (node.call == Call::abs || node.call == Call::min || node.call == Call::max);
  };
  return std::any_of(scene.expressions.begin(), scene.expressions.end(), [&](const Expression& expression) {
    return std::any_of(expression.nodes.begin(), expression.nodes.end(), is_kink);
  });
}

std::vector<int> depth(const std::vector<int>& lower) {
  std::vector<int> u(lower.size(), 0);
  for (std::size_t k = 0; k < lower.size(); ++k)
    if (lower[k] > 0) u[k] = u[static_cast<std::size_t>(lower[k] - 1)] + 1;
  return u;
}

}  // namespace kanec::scene
