// Oracle: what samples.hpp promises.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/verify/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "generator/read/read.hpp"

namespace kanec::cli {
namespace {

TEST(Samples, are_the_same_for_the_same_seed) {
  const scene::Scene scene = scene::from_connection({0, 1});
  EXPECT_EQ(samples(scene, 5, 7).back().x, samples(scene, 5, 7).back().x);
  EXPECT_NE(samples(scene, 5, 7).back().x, samples(scene, 5, 8).back().x);
}

TEST(Samples, begin_with_the_initial_state_and_have_unit_norm) {
  const scene::Scene scene = scene::read(KANEC_SOURCE_DIR "/models/six_body/scene.toml");
  const std::vector<State> list = samples(scene, 20, 1);
  ASSERT_EQ(list.size(), 20u);
  EXPECT_EQ(list[0].x, initial_coordinates(scene));
  EXPECT_EQ(list[0].y, initial_speeds(scene));
  for (const State& state : list)
    for (int k = 0; k < size(scene); ++k) {
      const double* eps =
          &state.x[static_cast<std::size_t>(scene::Layout(scene).bodies[static_cast<std::size_t>(k)].eps)];
      // a division rounds each of the four by half an ulp
      EXPECT_NEAR(std::hypot(std::hypot(eps[0], eps[1]), std::hypot(eps[2], eps[3])), 1.0, 1e-15);
    }
}

TEST(Samples, every_second_one_has_other_parameters_and_inputs) {
  const scene::Scene scene = scene::from_connection({0, 1});
  const std::vector<State> list = samples(scene, 6, 1);
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i].parameters == default_parameters(scene), i % 2 == 0) << i;
    EXPECT_EQ(list[i].inputs == default_inputs(scene), i % 2 == 0) << i;
  }
}

// A gimbal whose second and third axes are skew, to be kept away from lying in one plane.
TEST(Samples, keep_the_axes_of_a_gimbal_apart) {
  scene::Scene scene = scene::from_connection({0});
  scene::Joint& joint = scene.bodies[0].joint;
  joint.ball = false;
  joint.turns.resize(3);
  joint.turns[0].axis = {1, 0, 0};
  joint.turns[1].axis = {0, 0.6, 0.8};
  joint.turns[2].axis = {0, 0, 1};
  for (const State& state : samples(scene, 200, 3)) {
    const double theta = state.x[1], c = std::cos(theta), s = std::sin(theta);
    // the third axis turned about the second by Rodrigues' formula
    const double along = 0.8, x = 0.6 * s, y = 0.6 * along * (1 - c), z = c + 0.8 * along * (1 - c);
    const double volume = 0.6 * z - 0.8 * y;  // first axis · (second × third)
    EXPECT_LE(std::fabs(x * x + y * y + z * z - 1.0), 1e-15);
    EXPECT_GE(std::fabs(volume), 0.3 * 0.6 - 1e-15);  // 0.6: the most, at theta = 0, where the first state stands
  }
}

TEST(Samples, have_a_time_where_the_scene_depends_on_it) {
  scene::Scene scene = scene::from_connection({0});
  EXPECT_EQ(samples(scene, 3, 1).back().t, 0.0);
  scene.expressions.push_back({"t", {{scene::ExpressionNode::Kind::time}}});
  EXPECT_EQ(samples(scene, 3, 1).front().t, 0.0);
  EXPECT_NE(samples(scene, 3, 1).back().t, samples(scene, 3, 2).back().t);
}

}  // namespace
}  // namespace kanec::cli
