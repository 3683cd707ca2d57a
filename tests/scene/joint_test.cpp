// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>

#include "generator/scene/rotation.hpp"
#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::DoubleNear;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr double half = 0.70710678118654752440;  // sqrt(1/2)
constexpr double rounding = 2.3e-16;             // one rounding of a number below 1, from extended precision

Joint joint(const std::string& keys) { return parse(one_body(keys), "f").bodies[0].joint; }

// Rows of a rotation near to those of another.
void expect_rotation(const Rotation& found, const Rotation& wanted) {
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) EXPECT_NEAR(found[i][j], wanted[i][j], rounding) << i << j;
}

struct Shape {
  const char* keys;
  bool ball;
  std::vector<Axis> turns, slides;
};

const Axis X = {1, 0, 0}, Y = {0, 1, 0}, Z = {0, 0, 1};

// Every kind; axes are exact where they are coordinate axes.
const Shape shapes[] = {
    {"joint = 'free'", true, {}, {X, Y, Z}},
    {"joint = 'ball'", true, {}, {}},
    {"joint = 'revolute'\naxis = 'y'", false, {Y}, {}},
    {"joint = 'universal'\naxes = ['x', 'z']", false, {X, Z}, {}},
    {"joint = 'gimbal'\naxes = ['z', 'y', [2, 0, 0]]", false, {Z, Y, X}, {}},
    {"joint = 'prismatic'\naxis = '-z'", false, {}, {{0, 0, -1}}},
    {"joint = 'cartesian'", false, {}, {X, Y, Z}},
    {"joint = 'cartesian'\naxes = ['y', 'z', '-x']", false, {}, {Y, Z, {-1, 0, 0}}},
    {"joint = 'cylindrical'\naxis = [0, 0, -0.1]", false, {{0, 0, -1}}, {{0, 0, -1}}},
    {"joint = 'planar'\naxis = 'z'", false, {Z}, {X, Y}},
    {"joint = 'planar'\naxis = 'x'", false, {X}, {Y, Z}},
    {"joint = 'planar'\naxis = '-y'", false, {{0, -1, 0}}, {Z, {-1, 0, 0}}},
    {"joint = 'planar'\naxes = ['x', 'z']", false, {{0, -1, 0}}, {X, Z}},
    {"joint = 'bearing'\naxis = 'x'", true, {}, {X}},
    {"joint = 'screw'\naxis = 'z'\npitch = 0.01", false, {Z}, {}},
    {"joint = 'weld'", false, {}, {}},
};

TEST(Joint, of_every_kind_has_its_axes) {
  for (const Shape& shape : shapes) {
    const Joint found = joint(shape.keys);
    EXPECT_EQ(found.ball, shape.ball) << shape.keys;
    EXPECT_EQ(found.zero, no_rotation) << shape.keys;
    ASSERT_EQ(found.turns.size(), shape.turns.size()) << shape.keys;
    ASSERT_EQ(found.slides.size(), shape.slides.size()) << shape.keys;
    for (std::size_t i = 0; i < shape.turns.size(); ++i) EXPECT_EQ(found.turns[i].axis, shape.turns[i]) << shape.keys;
    for (std::size_t i = 0; i < shape.slides.size(); ++i)
      EXPECT_EQ(found.slides[i].axis, shape.slides[i]) << shape.keys;
  }
}

TEST(Joint, is_free_where_nothing_is_written) {
  EXPECT_EQ(joint("").kind, "free");
  EXPECT_TRUE(joint("").ball);
  EXPECT_EQ(joint("joint = 'gimbal'\naxes = ['x', 'y', 'z']").kind, "gimbal");
}

TEST(Joint, of_an_unknown_kind_is_refused_with_the_nearest) {
  const std::string kinds =
      "; allowed: free, ball, revolute, universal, gimbal, prismatic, cartesian, cylindrical, planar, bearing, screw, "
      "weld";
  EXPECT_EQ(message(one_body("joint = 'revolut'")),
            "f:6: body 1: joint: found the text \"revolut\"" + kinds + " (did you mean revolute?)");
  EXPECT_EQ(message(one_body("joint = 6")), "f:6: body 1: joint: found 6" + kinds);
}

TEST(Joint, axes_are_normalised_beyond_double) {
  const Axis axis = joint("joint = 'revolute'\naxis = [3, 0, 4]").turns[0].axis;
  EXPECT_THAT(axis, ElementsAre(0.6, 0.0, 0.8));
  EXPECT_THAT(joint("joint = 'revolute'\naxis = [1e-60, 0, 1e-60]").turns[0].axis,
              ElementsAre(DoubleNear(half, rounding), 0, DoubleNear(half, rounding)));
}

TEST(Joint, plane_is_orthogonal_to_its_normal_and_right_handed) {
  const Joint planar = joint("joint = 'planar'\naxis = [1, -2, 0.5]");
  const Direction n = direction(planar.turns[0].axis);
  const Direction a = direction(planar.slides[0].axis), b = direction(planar.slides[1].axis);
  EXPECT_NEAR(static_cast<double>(dot(n, a)), 0, 2 * rounding);
  EXPECT_NEAR(static_cast<double>(dot(n, cross(a, b))), 1, 4 * rounding);
  // the largest component is y: the first direction leans to z
  EXPECT_GT(a[2], 0.9);
}

TEST(Joint, pitch_of_a_screw_is_kept_and_required) {
  EXPECT_EQ(joint("joint = 'screw'\naxis = 'z'\npitch = -0.01").pitch, -0.01);
  EXPECT_EQ(message(one_body("joint = 'screw'\naxis = 'z'")),
            "f:3: body 1: pitch: found no such key, and it is required; allowed: a number: advance along the axis "
            "[m/rad]");
}

TEST(Joint, key_of_another_kind_is_refused_with_what_this_one_takes) {
  EXPECT_EQ(message(one_body("joint = 'revolute'\naxes = ['x']")),
            "f:7: body 1: axes: found a key that joint \"revolute\" does not have; allowed: axis, frame_on_lower, "
            "frame_on_body, effort, stiffness, damping, rest (did you mean axis?)");
  EXPECT_EQ(message(one_body("joint = 'ball'\naxis = 'x'")),
            "f:7: body 1: axis: found a key that joint \"ball\" does not have; allowed: none of its own");
  EXPECT_EQ(
      message(one_body("frame_on_body = {x = 'x', z = 'z'}")),
      "f:6: body 1: frame_on_body: found a key that joint \"free\" does not have; allowed: frame_on_lower (did you "
      "mean frame_on_lower?)");
  EXPECT_THAT(message(one_body("joint = 'weld'\naxi = 1")),
              HasSubstr("axi: found an unknown key; allowed: name, joint, "));
}

TEST(Joint, axis_that_is_none_is_refused) {
  const std::string shape = "; allowed: \"x\", \"-y\" and the like, or a list of 3 numbers";
  const auto revolute = [](const std::string& axis) { return message(one_body("joint = 'revolute'\naxis = " + axis)); };
  EXPECT_EQ(revolute("[0, 0, 0.0]"), "f:7: body 1: axis: found a direction of length 0" + shape);
  EXPECT_EQ(revolute("'w'"), "f:7: body 1: axis: found the text \"w\"" + shape);
  EXPECT_EQ(revolute("'--x'"), "f:7: body 1: axis: found the text \"--x\"" + shape);
  EXPECT_EQ(revolute("''"), "f:7: body 1: axis: found the text \"\"" + shape);
  EXPECT_EQ(revolute("[1, 2]"), "f:7: body 1: axis: found a list of 2" + shape);
  EXPECT_EQ(revolute("1"), "f:7: body 1: axis: found 1" + shape);
  EXPECT_EQ(revolute("[1, 2, 'x']"), "f:7: body 1: axis[3]: found the text \"x\"; allowed: a finite number");
  EXPECT_EQ(revolute("[1, 2, inf]"), "f:7: body 1: axis[3]: found inf; allowed: a finite number");
  EXPECT_THAT(message(one_body("joint = 'revolute'")), HasSubstr("axis: found no such key, and it is required"));
}

TEST(Joint, axes_of_another_number_are_refused) {
  EXPECT_EQ(message(one_body("joint = 'universal'\naxes = ['x']")),
            "f:7: body 1: axes: found a list of 1; allowed: a list of 2 axes, each \"x\" or 3 numbers");
  EXPECT_THAT(message(one_body("joint = 'gimbal'\naxes = 'xyz'")), HasSubstr("allowed: a list of 3 axes"));
  EXPECT_THAT(message(one_body("joint = 'gimbal'")), HasSubstr("axes: found no such key, and it is required"));
}

TEST(Joint, axes_that_are_not_independent_are_refused) {
  EXPECT_EQ(message(one_body("joint = 'universal'\naxes = ['x', '-x']")),
            "f:7: body 1: axes: found axes 1 and 2 in one direction; allowed: successive axes in different directions");
  EXPECT_THAT(message(one_body("joint = 'gimbal'\naxes = ['x', [1, 1, 0], [2, 2, 0]]")),
              HasSubstr("axes 2 and 3 in one direction"));
  EXPECT_EQ(message(one_body("joint = 'cartesian'\naxes = ['x', 'y', [1, 1, 0]]")),
            "f:7: body 1: axes: found three axes in one plane; allowed: three independent directions");
  EXPECT_THAT(message(one_body("joint = 'planar'\naxes = ['x', 'x']")), HasSubstr("found two axes in one direction"));
  EXPECT_EQ(message(one_body("joint = 'planar'\naxes = ['x', 'y']\naxis = 'z'")),
            "f:8: body 1: axis: found axis beside axes; allowed: the normal as axis, or two directions of the plane as "
            "axes");
}

// Oracle: the same rotation by hand.
TEST(Frame, orientations_of_every_form_agree) {
  const Rotation quarter = {{{0, -1, 0}, {1, 0, 0}, {0, 0, 1}}};  // by π/2 about z
  for (const std::string form : {"{eps = [0, 0, 1, 1]}", "{rpy = [0, 0, 'pi/2']}", "{rpy = [0, 0, 1.5707963267948966]}",
                                 "{x = 'y', z = 'z'}", "{x = [0, 3, -2], z = [0, 0, 0.5]}"})
    EXPECT_EQ(joint("joint = 'weld'\nframe_on_lower = " + form).zero, quarter) << form;
}

TEST(Frame, roll_pitch_and_yaw_turn_about_fixed_axes_in_this_order) {
  // x goes to -z by the pitch and stays; y to z by the roll, x by the pitch, y by the yaw; z to -y, -y, x
  const Rotation wanted = {{{0, 0, 1}, {0, 1, 0}, {-1, 0, 0}}};
  EXPECT_EQ(joint("joint = 'weld'\nframe_on_lower = {rpy = ['pi/2', 'pi/2', 'pi/2']}").zero, wanted);
  const double c = std::cos(0.3), s = std::sin(0.3);
  expect_rotation(joint("joint = 'weld'\nframe_on_lower = {rpy = [0.3, 0, 'pi/2']}").zero,
                  {{{0, -c, s}, {1, 0, 0}, {0, s, c}}});
}

TEST(Frame, on_lower_turns_axes_and_zero_and_on_body_turns_zero_back) {
  const Joint both = joint(
      "joint = 'revolute'\naxis = 'z'\nframe_on_lower = {x = 'y', z = 'x'}\n"
      "frame_on_body = {x = 'y', z = 'x'}");
  EXPECT_EQ(both.turns[0].axis, X);
  EXPECT_EQ(both.zero, no_rotation);
  const Joint on_body = joint("joint = 'revolute'\naxis = 'z'\nframe_on_body = {x = 'y', z = 'x'}");
  EXPECT_EQ(on_body.turns[0].axis, Z);
  // x of the joint frame, the lower body's x, is y of the body; its z is x of the body
  EXPECT_EQ(on_body.zero, (Rotation{{{0, 1, 0}, {0, 0, 1}, {1, 0, 0}}}));
}

TEST(Frame, of_a_ball_turns_its_slides_alone) {
  const Joint bearing = joint("joint = 'bearing'\naxis = 'z'\nframe_on_lower = {x = 'y', z = 'x'}");
  EXPECT_EQ(bearing.slides[0].axis, X);
  EXPECT_EQ(bearing.zero, no_rotation);
  EXPECT_EQ(joint("frame_on_lower = {x = 'y', z = 'x'}").slides[0].axis, Y);
}

TEST(Frame, entry_that_rounding_hides_is_made_exact_with_a_note_where_more_than_that_is_hidden) {
  const auto notes = [](const std::string& form) {
    return parse(one_body("joint = 'weld'\nframe_on_lower = " + form), "f").notes;
  };
  EXPECT_THAT(notes("{rpy = [0, 'pi/2', 0]}"), IsEmpty());
  EXPECT_THAT(notes("{eps = [0.7071067811865476, 0, 0, 0.7071067811865476]}"), IsEmpty());
  EXPECT_THAT(
      notes("{rpy = [0, 1.5707963267948966, 0]}"),
      ElementsAre("f:6: body 1: joint: entries of its axes and frames within 1e-15 of 0 or ±1 were made exact"));
  EXPECT_NE(joint("joint = 'weld'\nframe_on_lower = {rpy = [0, 1.570796, 0]}").zero[0][0], 0);
}

TEST(Frame, of_another_form_is_refused) {
  const std::string forms =
      "; allowed: { eps = [4 numbers] }, { rpy = [roll, pitch, yaw] } or { x = direction, z = direction }";
  const auto weld = [](const std::string& frame) {
    return message(one_body("joint = 'weld'\nframe_on_body = " + frame));
  };
  EXPECT_EQ(weld("[0, 0, 0]"), "f:7: body 1: frame_on_body: found a list of 3" + forms);
  EXPECT_EQ(weld("{}"), "f:7: body 1: frame_on_body: found an empty table" + forms);
  EXPECT_EQ(weld("{x = 'x'}"), "f:7: body 1: frame_on_body: found other keys together" + forms);
  EXPECT_EQ(weld("{eps = [0, 0, 0, 1], rpy = [0, 0, 0]}"),
            "f:7: body 1: frame_on_body: found other keys together" + forms);
  EXPECT_EQ(weld("{quat = [0, 0, 0, 1]}"),
            "f:7: body 1: frame_on_body.quat: found an unknown key; allowed: eps, rpy, x, z");
  EXPECT_THAT(weld("{eps = [0, 0, 0, 0]}"), HasSubstr("frame_on_body.eps: found Euler parameters of norm 0"));
  EXPECT_THAT(weld("{eps = [0, 0, 0]}"), HasSubstr("allowed: 4 Euler parameters, scalar last"));
  EXPECT_THAT(weld("{rpy = [0, 0]}"), HasSubstr("allowed: roll, pitch and yaw [rad]"));
  EXPECT_EQ(weld("{x = 'x', z = '-x'}"),
            "f:7: body 1: frame_on_body.x: found the direction of z; allowed: another direction than that of z");
}

TEST(Frame, angle_may_be_a_constant_expression_and_no_other) {
  const auto roll = [](const std::string& angle) {
    return message(one_body("joint = 'weld'\nframe_on_body = {rpy = [" + angle + ", 0, 0]}\n[parameters]\np = 1"));
  };
  EXPECT_EQ(roll("'-3*pi/4 + 0.1'"), "no error");
  EXPECT_THAT(roll("'p'"), HasSubstr("frame_on_body.rpy[1]: found \"p\" in column 1 of \"p\"; allowed: a name: pi"));
  EXPECT_THAT(roll("'1/0'"), HasSubstr("rpy[1]: found \"1/0\", which is not finite; allowed: an angle [rad]"));
  EXPECT_THAT(roll("true"), HasSubstr("rpy[1]: found true; allowed: an angle [rad]"));
}

}  // namespace
}  // namespace kanec::scene
