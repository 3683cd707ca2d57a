// That random scenes are the same everywhere and physically sound; that dual numbers differentiate.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <Eigen/LU>
#include <set>

#include "generator/read/expression_names.hpp"
#include "runtime/generic/expression.hpp"
#include "tests/support/dual.hpp"
#include "tests/support/random_scene.hpp"

namespace kanec::test {
namespace {

double value(const scene::Scene& scene, const scene::Number& number) {
  return number.kind == scene::Number::Kind::constant ? number.value
                                                      : scene.parameters[static_cast<std::size_t>(number.index)].value;
}

Eigen::Matrix3d matrix(const scene::Scene& scene, const scene::Symmetric& a) {
  Eigen::Matrix3d m;
  m << value(scene, a.xx), value(scene, a.xy), value(scene, a.xz), value(scene, a.xy), value(scene, a.yy),
      value(scene, a.yz), value(scene, a.xz), value(scene, a.yz), value(scene, a.zz);
  return m;
}

// The 10000th output of mt19937_64 with its default seed is given by the C++ standard, [rand.predef].
TEST(Random, uniform_numbers_follow_the_standard_engine) {
  Random random(std::mt19937_64::default_seed);
  double last = 0;
  for (int i = 0; i < 10000; ++i) last = random.uniform(0, 1);
  EXPECT_EQ(last, static_cast<double>(9981545732273789042ull >> 11) / 9007199254740992.0);
}

TEST(RandomScene, same_seed_gives_the_same_scene_and_another_seed_another) {
  const auto initial = [](std::uint64_t seed) {
    Random random(seed);
    return scene::initial_coordinates(random_scene(random, 5));
  };
  EXPECT_EQ(initial(7), initial(7));
  EXPECT_NE(initial(7), initial(8));
}

TEST(RandomScene, every_connection_is_valid_and_trees_stand_on_one_body) {
  Random random(11);
  for (int n_bodies = 1; n_bodies <= 12; ++n_bodies)
    for (const bool forest : {false, true}) {
      const std::vector<int> lower = random_connection(random, n_bodies, forest);
      ASSERT_EQ(lower.size(), static_cast<std::size_t>(n_bodies));
      EXPECT_EQ(lower[0], 0);
      for (int k = 2; k <= n_bodies; ++k) {
        EXPECT_LT(lower[static_cast<std::size_t>(k - 1)], k);
        EXPECT_GE(lower[static_cast<std::size_t>(k - 1)], forest ? 0 : 1);
      }
    }
}

TEST(RandomScene, inertias_are_positive_definite_and_keep_the_triangle_inequality) {
  Random random(13);
  for (const double zero_share : {0.0, 0.5}) {
    RandomSceneOptions options;
    options.zero_share = zero_share;
    options.parameter_share = 0.5;
    const scene::Scene scene = random_scene(random, 12, options);
    for (const scene::Body& body : scene.bodies) {
      const Eigen::Vector3d principal = matrix(scene, body.inertia).selfadjointView<Eigen::Lower>().eigenvalues();
      EXPECT_GT(principal[0], 0);
      EXPECT_LE(principal[2], principal[0] + principal[1]);
    }
  }
}

TEST(RandomScene, shares_of_one_turn_every_number_into_a_parameter_or_an_input) {
  Random random(17);
  RandomSceneOptions options;
  options.parameter_share = 1;
  options.input_share = 1;
  const scene::Scene scene = random_scene(random, 4, options);
  EXPECT_EQ(scene.parameters.size(), 3u + 4u * 13u);  // gravity; mass, inertia, r, q of four bodies
  EXPECT_EQ(scene.inputs.size(), 4u * 6u);            // force and moment of four bodies
  std::set<std::string> names;
  for (const scene::Named& named : scene.parameters) names.insert(named.name);
  for (const scene::Named& named : scene.inputs) names.insert(named.name);
  EXPECT_EQ(names.size(), scene.parameters.size() + scene.inputs.size());
}

TEST(RandomScene, has_every_joint_motion_and_load) {
  using Motion = scene::Coordinate::Motion;
  std::set<std::string> kinds, held;
  std::set<Motion> motions;
  std::set<scene::Load::Kind> loads;
  std::set<scene::Number::Kind> stiffnesses;
  Random random(19);
  for (int i = 0; i < 30; ++i) {
    const scene::Scene scene = random_scene(random, 12, everything());
    for (const scene::Body& body : scene.bodies) {
      kinds.insert(body.joint.kind);
      if (body.joint.held) held.insert(body.joint.kind);
      for (const auto* coordinates : {&body.joint.turns, &body.joint.slides})
        for (const scene::Coordinate& coordinate : *coordinates) motions.insert(coordinate.motion);
    }
    for (const scene::Load& load : scene.loads) {
      loads.insert(load.kind);
      stiffnesses.insert(load.stiffness.kind);
    }
    EXPECT_EQ(scene.points.size(), 2u);
  }
  EXPECT_EQ(kinds.size(), 12u);
  EXPECT_EQ(held.size(), 3u);  // free, ball, bearing
  EXPECT_EQ(motions.size(), 3u);
  EXPECT_EQ(loads.size(), 4u);
  EXPECT_EQ(stiffnesses.size(), 4u);
}

TEST(RandomScene, axes_are_of_unit_length_and_zero_attitudes_are_rotations) {
  Random random(23);
  const scene::Scene scene = random_scene(random, 64, everything());
  for (const scene::Body& body : scene.bodies) {
    for (const auto* coordinates : {&body.joint.turns, &body.joint.slides})
      for (const scene::Coordinate& one : *coordinates)
        EXPECT_NEAR(Eigen::Vector3d(one.axis.data()).norm(), 1, 1e-15);  // a few roundings
    const Eigen::Matrix3d zero =
        Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(body.joint.zero[0].data());
    EXPECT_LT((zero * zero.transpose() - Eigen::Matrix3d::Identity()).norm(), 1e-14);
    EXPECT_GT(zero.determinant(), 0);
  }
}

TEST(RandomScene, state_leaves_locked_and_prescribed_coordinates_out) {
  Random random(29);
  for (int n_bodies = 1; n_bodies <= 12; ++n_bodies) {
    const scene::Scene scene = random_scene(random, n_bodies, everything());
    const State state = random_state(random, scene);
    EXPECT_EQ(state.x.size(), static_cast<std::size_t>(scene::n_coordinates(scene)));
    EXPECT_EQ(state.y.size(), static_cast<std::size_t>(scene::n_speeds(scene)));
    EXPECT_EQ(state.ydot.size(), state.y.size());
  }
}

// Oracle: the parser of scene files.
TEST(RandomScene, expressions_read_as_their_nodes_say) {
  Random random(31);
  for (int n_bodies = 1; n_bodies <= 12; ++n_bodies) {
    const scene::Scene scene = random_scene(random, n_bodies, everything());
    const State state = random_state(random, scene);
    const std::vector<scene::ExpressionName> names = scene::names_for_loads(scene);
    const auto leaf = [&](const scene::ExpressionNode& node) {
      const auto i = static_cast<std::size_t>(node.index);
      switch (node.kind) {
        case scene::ExpressionNode::Kind::coordinate:
          return state.x[i];
        case scene::ExpressionNode::Kind::speed:
          return state.y[i];
        case scene::ExpressionNode::Kind::parameter:
          return scene.parameters[i].value;
        case scene::ExpressionNode::Kind::input:
          return scene.inputs[i].value;
        default:
          return 0.75;  // time
      }
    };
    for (const scene::Expression& expression : scene.expressions) {
      const scene::Expression parsed = scene::parse_expression(expression.text, {}, names);
      EXPECT_DOUBLE_EQ(generic::value_of<double>(parsed, leaf), generic::value_of<double>(expression, leaf));
    }
  }
}

TEST(Dual, differentiates_every_operation) {
  // t at t = 2: 8t³ + √t - 1/t + |1 - t| has the rate 24t² + 1/(2√t) + 1/t² + 1.
  const Dual<double> t(2.0, 1.0);
  const Dual<double> f = 8 * t * t * t + sqrt(t) - 1 / t + abs(1 - t);
  // a handful of roundings of numbers near 100
  EXPECT_NEAR(f.value, 64 + std::sqrt(2.0) - 0.5 + 1, 1e-13);
  EXPECT_NEAR(f.rate, 96 + 0.5 / std::sqrt(2.0) + 0.25 + 1, 1e-13);
}

}  // namespace
}  // namespace kanec::test
