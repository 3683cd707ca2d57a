// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

constexpr int first_line = 20;

// A cart on the ground, an arm on it, a ball on the ground; `rest` begins on first_line.
std::string cart_and_arm(const std::string& rest) {
  return "name = 'a'\nconnection = [0, 1, 0]\n" + good_body("cart") + "joint = 'prismatic'\naxis = 'x'\n" +
         good_body("arm") + "joint = 'revolute'\naxis = 'z'\n" + good_body("buoy") + "joint = 'ball'\n" + rest + "\n";
}

std::string at(int line) { return "f:" + std::to_string(first_line + line) + ": "; }

Scene read_with(const std::string& rest) { return parse(cart_and_arm(rest), "f"); }
Load load(const std::string& keys) { return read_with("[[load]]\n" + keys).loads.at(0); }
std::string load_refusal(const std::string& keys) { return message(cart_and_arm("[[load]]\n" + keys)); }

TEST(Load, that_is_a_force_acts_at_a_point) {
  const Load force = load(
      "kind = 'force'\nname = 'push'\nbody = 'arm'\nr = [1, 0, 'l']\nvector = [1, 'u', '2*u']\naxes = 'lower'\n"
      "reaction = 'buoy'\n[parameters]\nl = 1\n[inputs]\nu = 1");
  EXPECT_EQ(force.kind, Load::Kind::force);
  EXPECT_EQ(force.name, "push");
  EXPECT_EQ(force.point.body, 2);
  EXPECT_THAT(force.point.r, ElementsAre(Number::constant(1), Number::constant(0), Number::parameter(0)));
  EXPECT_THAT(force.vector, ElementsAre(Number::constant(1), Number::input(0), Number::expression(0)));
  EXPECT_EQ(force.axes, Axes::lower);
  EXPECT_EQ(force.reaction, 3);
}

TEST(Load, takes_defaults_where_nothing_is_written) {
  const Load force = load("kind = 'force'\nbody = 'arm'\nvector = [0, 0, 1]");
  EXPECT_EQ(force.name, "load_1");
  EXPECT_EQ(force.axes, Axes::inertial);
  EXPECT_EQ(force.reaction, -1);
  EXPECT_TRUE(is_zero(force.point.r));
}

TEST(Load, that_is_a_moment_has_no_point) {
  const Load moment =
      load("kind = 'moment'\nbody = 'buoy'\nvector = [0, 'omega_buoy_2', 1]\naxes = 'body'\nreaction = 'ground'");
  EXPECT_EQ(moment.kind, Load::Kind::moment);
  EXPECT_EQ(moment.point.body, 3);
  EXPECT_EQ(moment.axes, Axes::body);
  EXPECT_EQ(moment.reaction, 0);
  EXPECT_THAT(load_refusal("kind = 'moment'\nbody = 'buoy'\nvector = [0, 0, 1]\nr = [0, 0, 1]"),
              HasSubstr("r: found an unknown key; allowed: name, kind, body, vector, axes, reaction"));
}

TEST(Load, along_a_coordinate_is_found_by_number_and_by_name) {
  for (const std::string coordinate : {"theta_2", "theta_arm"}) {
    const Load joint =
        load("kind = 'joint'\ncoordinate = '" + coordinate + "'\neffort = 1\nstiffness = 2\ndamping = 3\nrest = 4");
    EXPECT_EQ(joint.kind, Load::Kind::joint);
    EXPECT_EQ(joint.point.body, 2);
    EXPECT_TRUE(joint.turn);
    EXPECT_EQ(joint.coordinate, 0);
    EXPECT_EQ(joint.effort, Number::constant(1));
    EXPECT_EQ(joint.stiffness, Number::constant(2));
    EXPECT_EQ(joint.damping, Number::constant(3));
    EXPECT_EQ(joint.rest, Number::constant(4));
  }
  const Load slide = load("kind = 'joint'\ncoordinate = 's_cart'\ndamping = 1");
  EXPECT_FALSE(slide.turn);
  EXPECT_EQ(slide.point.body, 1);
  const Scene free = parse(one_body("[[load]]\nkind = 'joint'\ncoordinate = 's_1_3'\ndamping = 1"), "f");
  EXPECT_EQ(free.loads[0].coordinate, 2);
}

TEST(Load, along_a_locked_coordinate_is_kept) {
  const Scene scene =
      parse(one_body("joint = 'revolute'\naxis = 'x'\n[body.motion]\ntheta = 1\n[[load]]\nkind = 'joint'\n"
                     "coordinate = 'theta_1'\nstiffness = 1"),
            "f");
  EXPECT_EQ(scene.loads.size(), 1u);
}

TEST(Load, that_is_a_spring_is_between_two_points) {
  const Scene scene = read_with(
      "[[point]]\nname = 'tip'\nbody = 'arm'\nr = [1, 0, 0]\n[[load]]\nkind = 'spring'\npoint = 'tip'\nother_body = "
      "'ground'\nother_r = [0, 0, 2]\nstiffness = 100\ndamping = '0.1*s_cart^2'\nrest = 0.5");
  const Load& spring = scene.loads[0];
  EXPECT_EQ(spring.kind, Load::Kind::spring);
  EXPECT_EQ(spring.point.body, 2);
  EXPECT_EQ(spring.point.r[0], Number::constant(1));
  EXPECT_EQ(spring.other.body, 0);
  EXPECT_EQ(spring.other.r[2], Number::constant(2));
  EXPECT_EQ(spring.stiffness, Number::constant(100));
  EXPECT_EQ(spring.damping, Number::expression(0));
  EXPECT_EQ(spring.rest, Number::constant(0.5));
}

TEST(Load, of_a_joint_with_one_coordinate_may_stand_in_the_body) {
  const Scene scene =
      parse("name = 'a'\nconnection = [0, 1]\n" + good_body("hub") + "force = ['2*t', 0, 0]\n" + good_body("door") +
                "joint = 'prismatic'\naxis = 'x'\nstiffness = 'k'\nrest = 0.1\ndamping = 2\n"
                "[[load]]\nkind = 'moment'\nbody = 'hub'\nvector = [1, 0, 0]\n[parameters]\nk = 10\n",
            "f");
  ASSERT_EQ(scene.loads.size(), 2u);
  const Load& hinge = scene.loads[0];
  EXPECT_EQ(hinge.kind, Load::Kind::joint);
  EXPECT_EQ(hinge.name, "door");
  EXPECT_EQ(hinge.point.body, 2);
  EXPECT_FALSE(hinge.turn);
  EXPECT_EQ(hinge.stiffness, Number::parameter(0));
  EXPECT_EQ(hinge.rest, Number::constant(0.1));
  EXPECT_EQ(hinge.damping, Number::constant(2));
  EXPECT_TRUE(hinge.effort.is_zero());
  EXPECT_EQ(scene.loads[1].name, "load_1");
  EXPECT_EQ(scene.bodies[0].force[0].kind, Number::Kind::expression);
  EXPECT_THAT(message(one_body("stiffness = 1")), HasSubstr("a key that joint \"free\" does not have"));
  EXPECT_THAT(message(one_body("joint = 'cylindrical'\naxis = 'x'\neffort = 1")),
              HasSubstr("a key that joint \"cylindrical\" does not have"));
}

TEST(Load, magnitude_of_numbers_alone_is_a_constant) {
  EXPECT_EQ(load("kind = 'force'\nbody = 'arm'\nvector = ['2*3', '-0.5', 0]").vector[0], Number::constant(6));
  EXPECT_EQ(load_refusal("kind = 'force'\nbody = 'arm'\nvector = ['log(0)', 0, 0]"),
            at(3) +
                "load 1: vector[1]: found \"log(0)\", which is not finite; allowed: a finite number, the name of a "
                "parameter or input, or an expression in quotes");
}

// Not only whole expressions: what is infinite or no number stays so whatever the rest is.
TEST(Load, part_of_numbers_alone_that_is_not_finite_is_refused) {
  for (const std::string text : {"0/0 + t", "0*(1/0) + t", "t*log(0)", "max(sqrt(-1), t)"})
    EXPECT_THAT(load_refusal("kind = 'force'\nbody = 'arm'\nvector = ['" + text + "', 0, 0]"),
                HasSubstr("found \"" + text + "\", which is not finite; "))
        << text;
  EXPECT_EQ(load("kind = 'force'\nbody = 'arm'\nvector = ['0/2 + t', 0, 0]").vector[0].kind, Number::Kind::expression);
}

TEST(Load, of_an_unknown_kind_or_without_one_is_refused) {
  EXPECT_EQ(
      load_refusal("kind = 'forse'"),
      at(1) + "load 1: kind: found the text \"forse\"; allowed: force, moment, joint, spring (did you mean force?)");
  EXPECT_EQ(load_refusal("body = 'arm'"),
            at(0) + "load 1: kind: found no such key, and it is required; allowed: force, moment, joint, spring");
  EXPECT_EQ(message("load = 1\n" + one_body("")), "f:1: load: found 1; allowed: [[load]] tables");
  EXPECT_EQ(message("load = [1]\n" + one_body("")), "f:1: load 1: found 1; allowed: a table");
}

TEST(Load, on_an_unknown_body_or_point_or_coordinate_is_refused_with_the_nearest) {
  EXPECT_EQ(
      load_refusal("kind = 'force'\nbody = 'amr'\nvector = [0, 0, 0]"),
      at(2) +
          "load 1: body: found the text \"amr\"; allowed: the name of a body, or ground: ground, cart, arm, buoy (did "
          "you mean arm?)");
  EXPECT_EQ(
      load_refusal("kind = 'force'\npoint = 'tip'\nvector = [0, 0, 0]"),
      at(2) + "load 1: point: found the text \"tip\"; allowed: the name of one of [[point]] (this scene has none)");
  EXPECT_THAT(load_refusal("kind = 'force'\npoint = 'tpi'\nvector = [0, 0, 0]\n[[point]]\nname = 'tip'\nbody = 'arm'"),
              HasSubstr("the name of one of [[point]]: tip (did you mean tip?)"));
  EXPECT_EQ(
      load_refusal("kind = 'joint'\ncoordinate = 'theta_am'\ndamping = 1"),
      at(2) +
          "load 1: coordinate: found the text \"theta_am\"; allowed: the name of an angle or translation: s_cart, "
          "theta_arm (did you mean theta_arm?)");
  EXPECT_EQ(load_refusal("kind = 'joint'\ncoordinate = 'eps_buoy_1'\ndamping = 1"),
            at(2) +
                "load 1: coordinate: found \"eps_buoy_1\", of an attitude; allowed: an angle or translation; on an "
                "attitude a moment");
}

TEST(Load, whose_keys_do_not_fit_together_is_refused) {
  EXPECT_EQ(load_refusal("kind = 'force'\nbody = 'ground'\nvector = [0, 0, 1]"),
            at(0) + "load 1: found a load on the inertial frame, which nothing moves; allowed: the name of a body");
  EXPECT_EQ(
      load_refusal("kind = 'force'\nbody = 'arm'\nreaction = 'arm'\nvector = [0, 0, 1]"),
      at(3) + "load 1: reaction: found the text \"arm\"; allowed: another body than the one that the load acts on");
  EXPECT_EQ(load_refusal("kind = 'force'\nbody = 'arm'\npoint = 'tip'\nvector = [0, 0, 1]"),
            at(2) + "load 1: body: found a place beside point; allowed: point, or body and r");
  EXPECT_EQ(
      load_refusal("kind = 'spring'\nbody = 'arm'\nother_body = 'arm'\nstiffness = 1"),
      at(0) +
          "load 1: found a spring between two points of one body, which does nothing; allowed: points of two bodies");
  EXPECT_EQ(load_refusal("kind = 'spring'\nbody = 'arm'\nother_body = 'cart'"),
            at(0) + "load 1: found a load without magnitude; allowed: stiffness or damping");
  EXPECT_EQ(load_refusal("kind = 'spring'\nbody = 'arm'\nother_body = 'cart'\nstiffness = 1\nrest = -0.1"),
            at(5) + "load 1: rest: found -0.1; allowed: a length: zero or positive");
  EXPECT_EQ(load_refusal("kind = 'joint'\ncoordinate = 'theta_2'\nrest = 1"),
            at(0) + "load 1: found a load without magnitude; allowed: effort, stiffness or damping");
  EXPECT_EQ(load_refusal("kind = 'joint'\ncoordinate = 'theta_2'\nrest = 1\neffort = 2"),
            at(3) + "load 1: rest: found rest without stiffness; allowed: both, or neither");
  EXPECT_EQ(
      load_refusal("kind = 'force'\nname = 'push'\nbody = 'arm'\nvector = [0, 0, 1]\naxes = 'inertail'"),
      at(5) +
          "load 1 (push): axes: found the text \"inertail\"; allowed: inertial, body, lower (did you mean inertial?)");
}

TEST(Load, without_a_required_key_is_refused) {
  EXPECT_THAT(
      load_refusal("kind = 'force'\nvector = [0, 0, 1]"),
      HasSubstr("load 1: body: found no such key, and it is required; allowed: the name of a body, or \"ground\", the "
                "inertial frame (or point)"));
  EXPECT_THAT(load_refusal("kind = 'force'\nbody = 'arm'"), HasSubstr("load 1: vector: found no such key"));
  EXPECT_THAT(load_refusal("kind = 'moment'\nvector = [0, 0, 1]"), HasSubstr("load 1: body: found no such key"));
  EXPECT_THAT(load_refusal("kind = 'joint'"), HasSubstr("load 1: coordinate: found no such key"));
  EXPECT_THAT(load_refusal("kind = 'spring'\nbody = 'arm'\nstiffness = 1"),
              HasSubstr("load 1: other_body: found no such key"));
}

TEST(Load, names_are_of_one_load_each) {
  const std::string moment = "[[load]]\nkind = 'moment'\nbody = 'arm'\nvector = [0, 0, 1]\n";
  EXPECT_EQ(message(cart_and_arm(moment + "name = 'load_2'\n" + moment)),
            at(5) + "load 2: found \"load_2\", the name of another load; allowed: another name");
  EXPECT_EQ(message(cart_and_arm(moment + "name = 'a'\n" + moment + "name = 'a'\n")),
            at(9) + "load 2: name: found \"a\", the name of another load; allowed: another name");
}

TEST(Load, that_uses_a_parameter_or_input_counts_as_use) {
  EXPECT_THAT(
      read_with("[[load]]\nkind = 'joint'\ncoordinate = 'theta_2'\nstiffness = 'k'\ndamping = '2*d'\neffort = 'u*a'\n"
                "[parameters]\nk = 1\nd = 1\na = 1\n[inputs]\nu = 1")
          .warnings,
      IsEmpty());
}

TEST(Point, is_kept_with_its_body_and_place) {
  const Scene scene = read_with(
      "[[point]]\nname = 'tip'\nbody = 'arm'\nr = [0, 'l', 0]\n[[point]]\nname = 'anchor'\nbody = "
      "'ground'\n[parameters]\nl = 1");
  ASSERT_EQ(scene.points.size(), 2u);
  EXPECT_EQ(scene.points[0].name, "tip");
  EXPECT_EQ(scene.points[0].body, 2);
  EXPECT_EQ(scene.points[0].r[1], Number::parameter(0));
  EXPECT_EQ(scene.points[1].body, 0);
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(Point, that_is_wrong_is_refused) {
  const auto point = [](const std::string& keys) { return message(cart_and_arm("[[point]]\n" + keys)); };
  EXPECT_EQ(point("body = 'arm'"),
            at(0) + "point[1].name: found no such key, and it is required; allowed: the name of the point");
  EXPECT_THAT(point("name = 'tip'"),
              HasSubstr("point[1].body: found no such key, and it is required; allowed: the name of a body"));
  EXPECT_THAT(point("name = '2'\nbody = 'arm'"), HasSubstr("point[1].name: found \"2\"; allowed: a C++ identifier"));
  EXPECT_THAT(point("name = 'tip'\nbody = 'arm'\nR = 1"),
              HasSubstr("point[1].R: found an unknown key; allowed: name, body, r"));
  EXPECT_THAT(point("name = 'tip'\nbody = 'arm'\nr = [0, 0, 'u']\n[inputs]\nu = 1"),
              HasSubstr("point[1].r[3]: found the input u; allowed: a number or a parameter"));
  EXPECT_EQ(point("name = 'tip'\nbody = 'arm'\n[[point]]\nname = 'tip'\nbody = 'arm'"),
            at(4) + "point[2].name: found \"tip\", the name of another point; allowed: another name");
  EXPECT_EQ(message("point = 'tip'\n" + one_body("")), "f:1: point: found the text \"tip\"; allowed: [[point]] tables");
}

TEST(Functions, are_kept_in_order) {
  EXPECT_THAT(parse("functions = ['accelerations', 'tip_position', 'kinematics+accelerations']\n" + one_body(""), "f")
                  .functions,
              ElementsAre("accelerations", "tip_position", "kinematics+accelerations"));
  EXPECT_THAT(parse(one_body(""), "f").functions, IsEmpty());
}

TEST(Functions, that_are_no_names_are_refused) {
  const auto functions = [](const std::string& list) { return message("functions = " + list + "\n" + one_body("")); };
  const std::string rule = "; allowed: the name of a function, as \"accelerations\", or several joined by +";
  for (const std::string name : {"", "+", "a+", "+a", "a++b", "a b", "a-b", "2a", "a+2b", "größe"})
    EXPECT_EQ(functions("['" + name + "']"), "f:1: functions[1]: found the text \"" + name + "\"" + rule);
  EXPECT_EQ(functions("[1]"), "f:1: functions[1]: found 1" + rule);
  EXPECT_EQ(functions("'power'"), "f:1: functions: found the text \"power\"; allowed: a list of names of functions");
  EXPECT_EQ(functions("[]"),
            "f:1: functions: found an empty list; allowed: at least one name; without the key, the usual functions");
  EXPECT_EQ(functions("['power', 'power']"), "f:1: functions[2]: found \"power\" twice; allowed: each function once");
}

TEST(Names, ground_is_no_body) {
  EXPECT_EQ(message(one_body("name = 'ground'")),
            "f:6: body 1: name: found \"ground\", the inertial frame; allowed: another name");
}

}  // namespace
}  // namespace kanec::scene
