// Scenes in relative coordinates. Oracles: the power of the loads and the kinematics of the generic path, which know
// nothing of these coordinates; closed forms.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "generator/read/read.hpp"
#include "runtime/bench/relative_state.hpp"
#include "runtime/verify/paths.hpp"
#include "runtime/verify/samples.hpp"
#include "tests/support/random_scene.hpp"

namespace kanec::test {
namespace {

// Every joint that other engines can have, welds among them, with forces and moments at points.
std::vector<scene::Scene> scenes() {
  kanec::test::RandomSceneOptions options;
  options.joints = {"free",      "ball",      "bearing",     "revolute", "universal", "gimbal",
                    "prismatic", "cartesian", "cylindrical", "planar",   "weld"};
  options.point_loads = true;
  std::vector<scene::Scene> list;
  for (std::uint64_t seed = 1; seed <= 12; ++seed) {
    kanec::test::Random random(100 + seed);
    list.push_back(random_scene(random, 2 + static_cast<int>(seed), options));
  }
  return list;
}

double dot(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Some hundred roundings of terms of the size of the largest.
TEST(RelativeState, forces_have_the_power_of_the_loads) {
  for (const scene::Scene& scene : scenes()) {
    const RelativeModel model = relative_model(scene);
    const RelativeStates states(scene, model);
    for (const kanec::State& state : samples(scene, 3, 1)) {
      const RelativeState found = states.of(state);
      double size = 1.0;
      for (std::size_t i = 0; i < found.u.size(); ++i) size = std::max(size, std::fabs(found.u[i] * found.force[i]));
      EXPECT_NEAR(dot(found.force, found.u), generic_path<double>(scene, {"power"}, state).at(0), 1e-11 * size);
    }
  }
}

// The state a time h later, to first order.
kanec::State later(const scene::Scene& scene, kanec::State state, double h) {
  const std::vector<double> xdot = generic_path<double>(scene, {"kinematics"}, state);
  for (std::size_t i = 0; i < xdot.size(); ++i) state.x[i] += h * xdot[i];
  for (std::size_t i = 0; i < state.y.size(); ++i) state.y[i] += h * state.ydot[i];
  const scene::Layout layout(scene);
  for (const scene::BodyLayout& body : layout.bodies) {
    if (body.eps < 0) continue;
    double* eps = &state.x[static_cast<std::size_t>(body.eps)];
    const double norm = std::hypot(std::hypot(eps[0], eps[1]), std::hypot(eps[2], eps[3]));
    for (int i = 0; i < 4; ++i) eps[i] /= norm;
  }
  return state;
}

// Central differences with h = 1e-5: h² is 1e-10 of third derivatives up to some hundred, roundings are 1e-11.
TEST(RelativeState, rates_are_those_of_the_speeds) {
  constexpr double h = 1e-5;
  for (const scene::Scene& scene : scenes()) {
    const RelativeModel model = relative_model(scene);
    const RelativeStates states(scene, model);
    for (const kanec::State& state : samples(scene, 2, 2)) {
      const std::vector<double> rates = states.rates(state), before = states.of(later(scene, state, -h)).u,
                                after = states.of(later(scene, state, h)).u;
      for (std::size_t i = 0; i < rates.size(); ++i)
        EXPECT_NEAR((after[i] - before[i]) / (2 * h), rates[i], 1e-6) << scene.bodies.size() << " bodies, speed " << i;
    }
  }
}

// A few hundred roundings, up to a sign of all four Euler parameters.
TEST(RelativeState, scene_state_undoes_it) {
  for (const scene::Scene& scene : scenes()) {
    const RelativeModel model = relative_model(scene);
    const RelativeStates states(scene, model);
    const scene::Layout layout(scene);
    for (const kanec::State& state : samples(scene, 2, 3)) {
      kanec::State found = states.scene_state(states.of(state), initial_state(scene));
      for (const scene::BodyLayout& body : layout.bodies) {
        if (body.eps < 0) continue;
        const auto at = static_cast<std::size_t>(body.eps);
        if (found.x[at] * state.x[at] < 0.0)
          for (std::size_t i = 0; i < 4; ++i) found.x[at + i] *= -1.0;
      }
      EXPECT_THAT(found.x, testing::Pointwise(testing::DoubleNear(1e-12), state.x));
      EXPECT_THAT(found.y, testing::Pointwise(testing::DoubleNear(1e-11), state.y));
    }
  }
}

constexpr auto two_welded = R"(
name = "pair"
connection = [0, 1]
[[body]]
name = "one"
mass = 1.0
inertia = [0.1, 0.2, 0.3]
r = [1.0, 0.0, 0.0]
[[body]]
name = "two"
joint = "weld"
mass = 3.0
q = [1.0, 0.0, 0.0]
inertia = [0.3, 0.4, 0.5]
r = [4.0, 0.0, 0.0]
)";

TEST(RelativeModel, welds_bodies_about_their_common_mass_centre) {
  const RelativeModel model = relative_model(scene::parse(two_welded, "pair"));
  ASSERT_EQ(model.bodies.size(), 1u);
  const kanec_peer_body& body = model.bodies[0];
  EXPECT_DOUBLE_EQ(body.mass, 4.0);
  EXPECT_DOUBLE_EQ(body.r[0], 4.0);  // (1 · 1 + 3 · 5) / 4
  EXPECT_DOUBLE_EQ(body.inertia[0], 0.4);
  EXPECT_DOUBLE_EQ(body.inertia[4], 0.6 + 1.0 * 9.0 + 3.0 * 1.0);
  EXPECT_DOUBLE_EQ(body.inertia[8], 0.8 + 1.0 * 9.0 + 3.0 * 1.0);
  EXPECT_EQ(model.n_q, 7);
  EXPECT_EQ(model.n_u, 6);
}

constexpr auto locked = R"(
name = "slide"
connection = [0]
[[body]]
name = "one"
joint = "cylindrical"
axis = "z"
mass = 1.0
inertia = [0.1, 0.2, 0.25]
[body.motion]
s = 0.5
)";

TEST(RelativeModel, refuses_what_it_has_no_word_for) {
  EXPECT_THAT([] { relative_model(scene::parse(locked, "slide")); },
              testing::ThrowsMessage<NotModelled>("a locked coordinate"));
}

}  // namespace
}  // namespace kanec::test
