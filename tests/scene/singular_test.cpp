// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "generator/scene/attitude.hpp"
#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A scene of one body; the body begins on line 3, its keys on line 4.
std::string body(const std::string& mass, const std::string& inertia, const std::string& rest = "") {
  return bare_body("mass = " + mass + "\ninertia = " + inertia + "\n" + rest);
}

// Two bodies, the first on the ground; the second begins on line 7.
std::string chain(const std::string& first, const std::string& second) {
  return "name = 'a'\nconnection = [0, 1]\n[[body]]\n" + first + "\n[[body]]\n" + second + "\n";
}

const std::string massless = "mass = 0\ninertia = [0, 0, 0]\n";
const std::string heavy = "mass = 1\ninertia = [1, 1, 1]\n";
const std::string instead = "; or a lock or prescribed motion of it";

TEST(Massless, translation_is_refused_with_its_name) {
  EXPECT_EQ(message(body("0", "[1, 1, 1]")),
            "f:3: body 1: found s_1_1, which moves no mass (A is singular); allowed: mass in "
            "what it carries" +
                instead);
  EXPECT_THAT(message(body("0", "[1, 1, 1]", "name = 'cart'\njoint = 'prismatic'\naxis = 'x'")),
              HasSubstr("body 1 (cart): found s_1, which moves no mass"));
  EXPECT_THAT(message(body("'m'", "[1, 1, 1]", "[parameters]\nm = 0")), HasSubstr("found s_1_1, which moves no mass"));
}

TEST(Massless, rotation_of_nothing_is_refused_with_its_name) {
  EXPECT_EQ(message(body("0", "[0, 0, 0]", "joint = 'revolute'\naxis = 'x'")),
            "f:3: body 1: found theta_1, which moves neither mass nor inertia (A is singular); allowed: mass or "
            "inertia in what "
            "it carries" +
                instead);
  EXPECT_THAT(message(body("0", "[0, 0, 0]", "joint = 'ball'")), HasSubstr("found omega_1_1, which moves neither"));
  EXPECT_THAT(message(chain(heavy, massless + "joint = 'universal'\naxes = ['x', 'y']")),
              HasSubstr("body 2: found theta_2_1, which moves neither"));
}

TEST(Massless, body_between_others_is_allowed) {
  EXPECT_EQ(message(chain(massless + "joint = 'revolute'\naxis = 'x'", heavy + "joint = 'revolute'\naxis = 'y'")),
            "no error");
  EXPECT_EQ(message(chain(massless + "joint = 'cartesian'", heavy + "joint = 'ball'")), "no error");
}

TEST(Massless, body_that_no_free_coordinate_moves_alone_is_allowed) {
  EXPECT_EQ(message(chain(heavy, massless + "joint = 'weld'")), "no error");
  EXPECT_EQ(message(body("0", "[0, 0, 0]", "joint = 'weld'")), "no error");
  EXPECT_EQ(message(body("0", "[0, 0, 0]", "joint = 'revolute'\naxis = 'x'\n[body.motion]\ntheta = 't'")), "no error");
  EXPECT_EQ(message(body("0", "[0, 0, 0]", "joint = 'ball'\n[body.motion]\neps = 'hold'")), "no error");
  EXPECT_EQ(message(body("0", "[0, 0, 0]", "[body.motion]\neps = 'hold'\ns = [0, 1, 't']")), "no error");
}

TEST(Massless, bodies_above_do_not_count) {
  EXPECT_THAT(message("name = 'a'\nconnection = [0, 1, 2]\n[[body]]\n" + massless +
                      "joint = 'prismatic'\naxis = 'x'\n[[body]]\n" + massless + "joint = 'weld'\n[[body]]\n" +
                      massless + "joint = 'weld'\n"),
              HasSubstr("body 1: found s_1, which moves no mass"));
  // the weld's mass is the cart's
  EXPECT_EQ(message(chain(massless + "joint = 'prismatic'\naxis = 'x'", heavy + "joint = 'weld'")), "no error");
}

TEST(Inertia, that_a_free_or_ball_joint_needs_and_a_leaf_lacks_is_refused) {
  const std::string reason =
      ", which nothing resists: the body has no inertia against it at the start (A is singular); allowed: "
      "inertia about its axis, or mass beside it" +
      instead;
  EXPECT_EQ(message(body("1", "[1, 0, 1]")), "f:3: body 1: found omega_1_2" + reason);
  EXPECT_THAT(message(body("1", "[0, 0, 0]", "r = [1, 2, 3]")), HasSubstr("found omega_1_1" + reason));
  EXPECT_THAT(message(body("1", "[1, 1, 1e-20]")), HasSubstr("found omega_1_3" + reason));
  // singular without a zero entry: 1 - u uᵀ with u = (1, 1, 1)/√3, times three
  EXPECT_THAT(message(body("1", "[[2, -1, -1], [-1, 2, -1], [-1, -1, 2]]")), HasSubstr("found omega_1_3" + reason));
  // a point mass on a ball turns about its own direction without resistance
  EXPECT_THAT(message(body("1", "[0, 0, 0]", "joint = 'ball'\nr = [1, 2, 3]")), HasSubstr("found omega_1_3" + reason));
}

TEST(Inertia, that_is_enough_for_the_joint_is_accepted) {
  EXPECT_EQ(message(body("1", "[0, 0, 2]", "joint = 'revolute'\naxis = 'z'")), "no error");
  EXPECT_EQ(message(body("1", "[0, 0, 0]", "joint = 'revolute'\naxis = 'z'\nr = [1, 0, 0]")), "no error");
  EXPECT_EQ(message(body("0", "[0, 0, 2]", "joint = 'revolute'\naxis = 'z'")), "no error");
  EXPECT_EQ(message(body("1", "[0, 0, 2]", "joint = 'planar'\naxis = 'z'\nr = [1, 2, 0]")), "no error");
  EXPECT_EQ(message(body("1", "[0, 0, 0]", "joint = 'screw'\naxis = 'z'\npitch = 0.1")), "no error");
  EXPECT_EQ(message(body("1", "[0, 0, 0]", "joint = 'cartesian'")), "no error");
  EXPECT_EQ(message(body("1", "[1, 1, 1e-9]", "r = [0, 30, 0]")), "no error");
  EXPECT_EQ(message(body("1", "[0, 0, 0]", "joint = 'universal'\naxes = ['x', 'y']\nr = [0, 0, 1]")), "no error");
}

TEST(Inertia, that_a_turn_needs_and_a_leaf_lacks_is_refused) {
  for (const std::string& lacking :
       {body("1", "[1, 1, 0]", "joint = 'revolute'\naxis = 'z'"),
        body("1", "[0, 0, 0]", "joint = 'revolute'\naxis = 'z'"),
        body("1", "[0, 0, 0]", "joint = 'revolute'\naxis = [1, 1, 1]\nr = [0.2, 0.2, 0.2]"),
        body("1", "[0, 0, 1]", "joint = 'revolute'\naxis = 'z'\nframe_on_body = {x = 'y', z = 'x'}"),
        body("1", "[0, 0, 0]", "joint = 'planar'\naxis = 'z'\nr = [1, 2, 0]")})
    EXPECT_THAT(message(lacking), HasSubstr("found theta_1, which nothing resists: ")) << lacking;
  EXPECT_THAT(message(body("1", "[0, 0, 0]", "joint = 'universal'\naxes = ['x', 'y']\nr = [0, 1, 0]")),
              HasSubstr("found theta_1_2, which nothing resists: "));
}

TEST(Axes, that_depend_on_each_other_at_the_start_are_refused_with_the_coordinate) {
  const std::string gimbal = "joint = 'gimbal'\naxes = ['z', 'y', 'x']\n";
  EXPECT_EQ(message(one_body(gimbal)), "no error");
  EXPECT_EQ(message(one_body(gimbal + "[body.initial]\ntheta = [0.3, 1.5707963267948966, 0]")),
            "f:3: body 1: found theta_1_3, whose axis at the start depends on those of the turns before it; allowed: "
            "other axes "
            "or initial angles: here A is singular");
  const std::string euler = "joint = 'gimbal'\naxes = ['z', 'x', 'z']\n";
  EXPECT_THAT(message(one_body(euler)), HasSubstr("found theta_1_3, whose axis at the start depends"));
  EXPECT_EQ(message(one_body(euler + "[body.initial]\ntheta = [0, 0.1, 0]")), "no error");
}

TEST(Axes, of_locked_turns_do_not_count_and_prescribed_ones_stand_where_they_are_at_the_start) {
  const std::string euler = "joint = 'gimbal'\naxes = ['z', 'x', 'z']\n";
  EXPECT_EQ(message(one_body(euler + "[body.motion]\ntheta = [0, 'free', 'free']")), "no error");
  EXPECT_THAT(message(one_body(euler + "[body.motion]\ntheta = ['free', 't', 'free']")),
              HasSubstr("found theta_1_3, whose axis"));
  EXPECT_EQ(message(one_body(euler + "[body.motion]\ntheta = ['free', 't + a', 'free']\n[parameters]\na = 1")),
            "no error");
}

TEST(Triangle, is_no_warning_where_a_planar_body_has_its_one_moment) {
  EXPECT_THAT(parse(body("1", "[0, 0, 2]", "joint = 'revolute'\naxis = 'z'"), "f").warnings, IsEmpty());
  EXPECT_THAT(parse(body("1", "[1, 1, 3]", "joint = 'revolute'\naxis = 'z'"), "f").warnings,
              ElementsAre(HasSubstr("violate the triangle inequality")));
  const std::string planar = "mass = 1\ninertia = [0, 0, 2]\njoint = 'revolute'\n";
  EXPECT_THAT(parse(chain(planar + "axis = 'z'", planar + "axis = '-z'"), "f").warnings, IsEmpty());
  // here the moment about z is not the only one that counts
  EXPECT_THAT(parse(chain(heavy + "joint = 'revolute'\naxis = 'x'", planar + "axis = 'z'"), "f").warnings,
              ElementsAre(HasSubstr("body 2: inertia: principal moments 0, 0, 2")));
}

// Oracle: turns by hand.
TEST(Attitude, at_the_start_follows_joints_and_motions) {
  const Scene scene = parse("name = 'a'\nconnection = [0, 1, 2]\n[[body]]\n" + heavy +
                                "[body.initial]\neps = [0, 0, 1, 1]\n[[body]]\n" + heavy +
                                "joint = 'revolute'\naxis = 'x'\n[body.motion]\ntheta = 'pi/2 + t'\n[[body]]\n" +
                                heavy + "joint = 'universal'\naxes = ['z', 'x']\n[body.initial]\ntheta = [0, 0.3]\n",
                            "f");
  const auto attitudes = initial_attitudes(scene);
  const auto expect = [](const Direction& found, const Direction& wanted) {
    // some roundings of entries up to 1, in extended precision
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(static_cast<double>(found[i]), static_cast<double>(wanted[i]), 1e-17);
  };
  expect(attitudes[0].turn * Direction{1, 0, 0}, {0, 1, 0});
  expect(attitudes[1].axes[0], {0, 1, 0});
  // x stays; z of the arm is -y of the first body after its quarter turn, which is x
  expect(attitudes[1].turn * Direction{0, 0, 1}, {1, 0, 0});
  expect(attitudes[2].axes[0], {1, 0, 0});
  expect(attitudes[2].axes[1], {0, 1, 0});
}

}  // namespace
}  // namespace kanec::scene
