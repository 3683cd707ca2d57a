// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <string>

#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

// Every place of a number, each with NUMBER for it, and the field that a message must name.
struct Spot {
  std::string text, field;
};
const Spot spots[] = {
    {"gravity = [0, 0, NUMBER]\n" + one_body(""), "f:1: gravity[3]: "},
    {bare_body("mass = NUMBER\ninertia = [1, 1, 1]"), "f:4: body 1: mass: "},
    {bare_body("mass = 1\ninertia = [1, NUMBER, 1]"), "f:5: body 1: inertia[2]: "},
    {bare_body("mass = 1\ninertia = [[1, 0, 0], [0, 1, 0], [NUMBER, 0, 1]]"), "f:5: body 1: inertia[3][1]: "},
    {one_body("r = [NUMBER, 0, 0]"), "f:6: body 1: r[1]: "},
    {one_body("q = [0, NUMBER, 0]"), "f:6: body 1: q[2]: "},
    {one_body("force = [0, 0, NUMBER]"), "f:6: body 1: force[3]: "},
    {one_body("moment = [0, 0, NUMBER]"), "f:6: body 1: moment[3]: "},
    {one_body("[body.initial]\neps = [NUMBER, 0, 0, 1]"), "f:7: body 1: initial.eps[1]: "},
    {one_body("[body.initial]\nomega = [0, 0, NUMBER]"), "f:7: body 1: initial.omega[3]: "},
    {one_body("[body.initial]\ns = [0, 0, NUMBER]"), "f:7: body 1: initial.s[3]: "},
    {one_body("[body.initial]\nsdot = [0, 0, NUMBER]"), "f:7: body 1: initial.sdot[3]: "},
    {one_body("joint = 'revolute'\naxis = [1, NUMBER, 0]"), "f:7: body 1: axis[2]: "},
    {one_body("joint = 'universal'\naxes = ['x', [0, 1, NUMBER]]"), "f:7: body 1: axes[2][3]: "},
    {one_body("joint = 'screw'\naxis = 'x'\npitch = NUMBER"), "f:8: body 1: pitch: "},
    {one_body("frame_on_lower = {rpy = [0, NUMBER, 0]}"), "f:6: body 1: frame_on_lower.rpy[2]: "},
    {one_body("frame_on_lower = {eps = [0, 0, 1, NUMBER]}"), "f:6: body 1: frame_on_lower.eps[4]: "},
    {one_body("joint = 'revolute'\naxis = 'x'\neffort = NUMBER"), "f:8: body 1: effort: "},
    {one_body("joint = 'revolute'\naxis = 'x'\n[body.initial]\ntheta = NUMBER"), "f:9: body 1: initial.theta: "},
    {one_body("joint = 'revolute'\naxis = 'x'\n[body.initial]\nthetadot = NUMBER"), "f:9: body 1: initial.thetadot: "},
    {one_body("joint = 'revolute'\naxis = 'x'\n[body.motion]\ntheta = NUMBER"), "f:9: body 1: motion.theta: "},
    {one_body("[body.motion]\ns = ['free', NUMBER, 't']"), "f:7: body 1: motion.s[2]: "},
    {with_table("[[point]]\nname = 'p'\nbody = 'body_1'\nr = [0, NUMBER, 0]"), "f:9: point[1].r[2]: "},
    {with_table("[[load]]\nkind = 'force'\nbody = 'body_1'\nvector = [0, NUMBER, 0]"), "f:9: load 1: vector[2]: "},
    {with_table("[[load]]\nkind = 'joint'\ncoordinate = 's_1_1'\ndamping = NUMBER"), "f:9: load 1: damping: "},
    {with_table(
         "[[load]]\nkind = 'spring'\nbody = 'body_1'\nother_body = 'ground'\nother_r = [0, 0, NUMBER]\nstiffness = 1"),
     "f:10: load 1: other_r[3]: "},
    {with_table("[parameters]\nm = NUMBER"), "f:7: parameters.m: "},
    {with_table("[inputs]\nu = NUMBER"), "f:7: inputs.u: "},
    {with_table("[simulate]\nduration = NUMBER"), "f:7: simulate.duration: "},
    {with_table("[simulate]\noutput_step = NUMBER"), "f:7: simulate.output_step: "},
    {with_table("[simulate]\nstep = NUMBER"), "f:7: simulate.step: "},
    {with_table("[simulate]\nrelative_tolerance = NUMBER"), "f:7: simulate.relative_tolerance: "},
    {with_table("[simulate]\nabsolute_tolerance = NUMBER"), "f:7: simulate.absolute_tolerance: "},
};

std::string replaced(std::string text, const std::string& number) {
  return text.replace(text.find("NUMBER"), 6, number);
}

TEST(Numbers, that_are_not_finite_are_refused_everywhere) {
  for (const Spot& spot : spots)
    for (const std::string number : {"nan", "inf", "-inf"}) {
      const std::string shown = message(replaced(spot.text, number));
      EXPECT_THAT(shown, StartsWith(spot.field + "found " + number + "; allowed: "));
    }
}

TEST(Numbers, whose_products_would_overflow_are_refused_everywhere) {
  for (const Spot& spot : spots) {
    const std::string shown = message(replaced(spot.text, "-1e61"));
    EXPECT_THAT(shown, StartsWith(spot.field + "found -1e+61; allowed: "));
    EXPECT_THAT(shown, HasSubstr("in magnitude at most 1e+60"));
  }
}

TEST(Numbers, of_another_type_are_refused_everywhere) {
  for (const Spot& spot : spots)
    EXPECT_THAT(message(replaced(spot.text, "true")), StartsWith(spot.field + "found true; allowed: "));
}

TEST(Numbers, whole_ones_are_accepted_where_others_are) {
  const Scene scene = parse(
      "name = 'a'\nconnection = [0]\ngravity = [0, 0, -10]\n[parameters]\nm = 3\n[inputs]\nu = -2\n[[body]]\nmass = "
      "'m'\n"
      "inertia = [1, 1, 1]\nr = [1, 2, 3]\nforce = [0, 0, 'u']\n[body.initial]\neps = [0, 0, 0, 1]\nomega = [1, 2, 3]\n"
      "[simulate]\nduration = 2\n",
      "f");
  EXPECT_EQ(scene.gravity[2], Number::constant(-10.0));
  EXPECT_EQ(scene.parameters[0].value, 3.0);
  EXPECT_EQ(scene.inputs[0].value, -2.0);
  EXPECT_EQ(scene.bodies[0].r[2], Number::constant(3.0));
  EXPECT_EQ(scene.bodies[0].initial.omega[1], 2.0);
  EXPECT_EQ(scene.simulation.duration, 2.0);
}

TEST(Numbers, are_read_to_the_last_bit) {
  const Scene scene = parse(one_body("r = [0.1, 1e-300, 123456789.12345679]"), "f");
  EXPECT_EQ(scene.bodies[0].r[0].value, 0.1);
  EXPECT_EQ(scene.bodies[0].r[1].value, 1e-300);
  EXPECT_EQ(scene.bodies[0].r[2].value, 123456789.12345679);
}

}  // namespace
}  // namespace kanec::scene
