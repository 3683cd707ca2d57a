// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/samples.hpp"

#include <cmath>
#include <numbers>
#include <random>

#include "runtime/base/error.hpp"
#include "runtime/cli/settings.hpp"

namespace kanec::cli {
namespace {

constexpr double parameter_share = 0.01;
constexpr double parameter_of_zero = 0.001;

// Not the standard library's distributions, which differ from one library to the next.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}

  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(engine_() >> 11) * 0x1p-53;
  }

  std::vector<double> numbers(std::size_t count) {
    std::vector<double> list(count);
    for (double& number : list) number = between(-1.0, 1.0);
    return list;
  }

  // Uniform on the sphere: from the ball within the cube, away from its centre.
  void unit(double* eps) {
    double norm = 0.0;
    do {
      for (int i = 0; i < 4; ++i) eps[i] = between(-1.0, 1.0);
      norm = std::hypot(std::hypot(eps[0], eps[1]), std::hypot(eps[2], eps[3]));
    } while (norm > 1.0 || norm < 0.1);
    for (int i = 0; i < 4; ++i) eps[i] /= norm;
  }

 private:
  std::mt19937_64 engine_;
};

std::vector<double> near_defaults(const scene::Scene& scene, Random& random) {
  scene::Scene changed = scene;
  for (scene::Named& parameter : changed.parameters) {
    const double change = random.between(-1.0, 1.0);
    parameter.value += change * (parameter.value == 0.0 ? parameter_of_zero : parameter_share * parameter.value);
  }
  try {
    check_defaults(changed, scene.name);
  } catch (const SceneError&) {
    return default_parameters(scene);
  }
  return default_parameters(changed);
}

std::vector<double> near_inputs(const scene::Scene& scene, Random& random) {
  std::vector<double> inputs = default_inputs(scene);
  for (double& input : inputs) input += random.between(-1.0, 1.0) * (1.0 + std::fabs(input));
  return inputs;
}

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

State sample(const scene::Scene& scene, Random& random, bool defaults) {
  State state = initial_state(scene);
  if (reads_time(scene)) state.t = random.between(0.0, 1.0);
  state.x = random.numbers(state.x.size());
  const scene::Layout layout(scene);
  for (std::size_t k = 0; k < layout.bodies.size(); ++k) {
    const scene::BodyLayout& at = layout.bodies[k];
    if (at.eps >= 0) random.unit(&state.x[static_cast<std::size_t>(at.eps)]);
    random_angles(scene.bodies[k].joint, at.theta, random, state.x);
  }
  state.y = random.numbers(state.y.size());
  state.ydot = random.numbers(state.ydot.size());
  if (defaults) return state;
  state.parameters = near_defaults(scene, random);
  state.inputs = near_inputs(scene, random);
  return state;
}

}  // namespace

std::vector<State> samples(const scene::Scene& scene, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<State> list = {initial_state(scene)};
  list.front().ydot = random.numbers(list.front().ydot.size());
  while (static_cast<int>(list.size()) < count) list.push_back(sample(scene, random, list.size() % 2 == 0));
  return list;
}

}  // namespace kanec::cli
