// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <numbers>

#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

using Motion = Coordinate::Motion;

const std::string revolute = "joint = 'revolute'\naxis = 'z'\n";
const std::string universal = "joint = 'universal'\naxes = ['x', 'y']\n";

TEST(InitialState, of_one_coordinate_is_a_number_and_of_several_a_list) {
  const Scene scene = parse(
      "name = 'a'\nconnection = [0, 1]\n" + good_body() + revolute + "[body.initial]\ntheta = 0.5\nthetadot = -1\n" +
          good_body() + "joint = 'planar'\naxis = 'z'\n" + "[body.initial]\ntheta = 0.25\ns = [1, 2]\nsdot = [3, 4]\n",
      "f");
  EXPECT_THAT(initial_coordinates(scene), ElementsAre(0.5, 0.25, 1, 2));
  EXPECT_THAT(initial_speeds(scene), ElementsAre(-1, 0, 3, 4));
  EXPECT_THAT(initial_coordinates(parse(one_body(universal + "[body.initial]\ntheta = [0.1, 0.2]"), "f")),
              ElementsAre(0.1, 0.2));
}

TEST(InitialState, of_another_shape_than_the_joint_is_refused) {
  EXPECT_EQ(message(one_body(revolute + "[body.initial]\ntheta = [0.1]")),
            "f:9: body 1: initial.theta: found a list of 1; allowed: a finite number (names are not for the initial "
            "state)");
  EXPECT_EQ(message(one_body(universal + "[body.initial]\nthetadot = 0.1")),
            "f:9: body 1: initial.thetadot: found 0.1; allowed: a list of 2 numbers");
}

TEST(InitialState, of_another_joint_is_refused_with_what_this_one_has) {
  EXPECT_EQ(message(one_body(revolute + "[body.initial]\neps = [0, 0, 0, 1]")),
            "f:9: body 1: initial.eps: found a key that joint \"revolute\" does not have; allowed: theta, thetadot");
  EXPECT_EQ(
      message(one_body("joint = 'weld'\n[body.initial]\ntheta = 1")),
      "f:8: body 1: initial.theta: found a key that joint \"weld\" does not have; allowed: none: joint \"weld\" has "
      "no coordinates");
  EXPECT_EQ(message(one_body("joint = 'ball'\n[body.initial]\ns = [0, 0, 0]")),
            "f:8: body 1: initial.s: found a key that joint \"ball\" does not have; allowed: eps, omega");
}

TEST(Motion, that_is_a_number_is_a_lock) {
  const Scene scene = parse(one_body(revolute + "[body.motion]\ntheta = 0.3"), "f");
  const Coordinate& theta = scene.bodies[0].joint.turns[0];
  EXPECT_EQ(theta.motion, Motion::locked);
  EXPECT_EQ(theta.value, 0.3);
  EXPECT_THAT(initial_coordinates(scene), testing::IsEmpty());
}

TEST(Motion, that_is_an_expression_of_numbers_is_a_lock) {
  const Scene scene = parse(one_body(revolute + "[body.motion]\ntheta = '-pi/2'"), "f");
  EXPECT_EQ(scene.bodies[0].joint.turns[0].motion, Motion::locked);
  EXPECT_EQ(scene.bodies[0].joint.turns[0].value, -std::numbers::pi / 2);
  EXPECT_TRUE(scene.expressions.empty());
}

TEST(Motion, that_is_an_expression_of_time_is_prescribed) {
  const Scene scene = parse(one_body(revolute + "[body.motion]\ntheta = 'a*sin(3*t)'\n[parameters]\na = 0.2"), "f");
  const Coordinate& theta = scene.bodies[0].joint.turns[0];
  EXPECT_EQ(theta.motion, Motion::prescribed);
  ASSERT_EQ(scene.expressions.size(), 1u);
  EXPECT_EQ(scene.expressions[static_cast<std::size_t>(theta.expression)].text, "a*sin(3*t)");
  EXPECT_THAT(scene.warnings, testing::IsEmpty());
}

TEST(Motion, of_several_coordinates_may_be_mixed) {
  const Scene scene = parse(one_body("[body.initial]\ns = [0, 0, 3]\n[body.motion]\ns = ['t', 2, 'free']"), "f");
  const auto& slides = scene.bodies[0].joint.slides;
  EXPECT_EQ(slides[0].motion, Motion::prescribed);
  EXPECT_EQ(slides[1].motion, Motion::locked);
  EXPECT_EQ(slides[2].motion, Motion::free);
  EXPECT_THAT(initial_coordinates(scene), ElementsAre(0, 0, 0, 1, 3));
  EXPECT_EQ(coordinate_names(scene).back(), "s_1_3");
}

TEST(Motion, of_a_ball_may_be_held) {
  const Scene scene =
      parse(one_body("joint = 'ball'\n[body.initial]\neps = [0, 3, 0, 4]\n[body.motion]\neps = 'hold'"), "f");
  EXPECT_TRUE(scene.bodies[0].joint.held);
  EXPECT_EQ(n_speeds(scene), 0);
  EXPECT_EQ(message(one_body("[body.motion]\neps = [0, 0, 0, 1]")),
            "f:7: body 1: motion.eps: found a list of 4; allowed: \"hold\": the attitude stays at initial.eps");
  EXPECT_EQ(
      message(one_body("[body.initial]\nomega = [0, 1, 0]\n[body.motion]\neps = 'hold'")),
      "f:9: body 1: motion.eps: found a held attitude beside an initial.omega; allowed: no initial.omega, or zero");
}

TEST(Motion, beside_an_initial_value_is_refused) {
  const std::string rest =
      "found a motion beside an initial value or rate of the same coordinate; allowed: one of them (0 in a list of "
      "initial values)";
  EXPECT_EQ(message(one_body(revolute + "[body.initial]\ntheta = 0.5\n[body.motion]\ntheta = 0.5")),
            "f:11: body 1: motion.theta: " + rest);
  EXPECT_EQ(message(one_body("[body.initial]\nsdot = [0, 1, 0]\n[body.motion]\ns = [0, 't', 0]")),
            "f:9: body 1: motion.s[2]: " + rest);
}

TEST(Motion, of_anything_but_time_and_parameters_is_refused_with_the_reason) {
  const auto motion = [](const std::string& text) {
    return message(one_body(revolute + "[body.motion]\ntheta = '" + text + "'\n[parameters]\na = 1\n[inputs]\nu = 1"));
  };
  const std::string rule =
      "a prescribed motion is of time and parameters alone, so that its speed and acceleration follow from it; "
      "allowed: "
      "another name: pi, t, a";
  EXPECT_EQ(motion("t + u"),
            "f:9: body 1: motion.theta: found \"u\" in column 5 of \"t + u\", an input, whose rate is "
            "unknown: " +
                rule + " (did you mean t?)");
  EXPECT_THAT(motion("2*theta_1"),
              HasSubstr("found \"theta_1\" in column 3 of \"2*theta_1\", a coordinate or speed: " + rule));
  EXPECT_THAT(motion("thetadot_body_1"), HasSubstr("a coordinate or speed: " + rule));
  EXPECT_EQ(motion("fre"),
            "f:9: body 1: motion.theta: found \"fre\" in column 1 of \"fre\"; allowed: a name: pi, t, a");
}

TEST(Motion, of_another_type_or_joint_is_refused) {
  EXPECT_EQ(
      message(one_body(revolute + "[body.motion]\ntheta = true")),
      "f:9: body 1: motion.theta: found true; allowed: a number (locked there), an expression of t and parameters "
      "in quotes (prescribed), or \"free\"");
  EXPECT_THAT(message(one_body(revolute + "[body.motion]\ntheta = [1]")),
              HasSubstr("motion.theta: found a list of 1; "));
  EXPECT_THAT(message(one_body("[body.motion]\ns = 1")),
              HasSubstr("motion.s: found 1; allowed: a list of 3 entries: "));
  EXPECT_THAT(message(one_body(revolute + "[body.motion]\ntheta = '1/0'")),
              HasSubstr("found \"1/0\", which is not finite; "));
  EXPECT_EQ(message(one_body(revolute + "[body.motion]\ns = 1")),
            "f:9: body 1: motion.s: found a key that joint \"revolute\" does not have; allowed: theta");
  EXPECT_EQ(message(one_body(revolute + "[body.motion]\nthet = 1")),
            "f:9: body 1: motion.thet: found an unknown key; allowed: theta (did you mean theta?)");
  EXPECT_EQ(message(one_body("motion = 3")), "f:6: body 1: motion: found 3; allowed: a table");
}

}  // namespace
}  // namespace kanec::scene
