// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>

#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

// A scene of one body of that inertia, on line 5.
std::string with_inertia(const std::string& inertia) { return bare_body("mass = 1\ninertia = " + inertia); }

TEST(Mass, that_is_negative_is_refused) {
  EXPECT_EQ(message(bare_body("mass = -1\ninertia = [1, 1, 1]")),
            "f:4: body 1: mass: found -1; allowed: a positive number, or zero");
}

TEST(Mass, too_small_for_a_reciprocal_is_refused) {
  EXPECT_EQ(message(bare_body("mass = 1e-101\ninertia = [1, 1, 1]")),
            "f:4: body 1: mass: found 1e-101; allowed: a positive number, or zero");
  EXPECT_EQ(
      message(bare_body("mass = 1\ninertia = [1e-101, 1e-101, 1e-101]")),
      "f:5: body 1: inertia: found principal moments 1e-101, 1e-101, 1e-101 (entries xx 1e-101, yy 1e-101, zz 1e-101, "
      "xy 0, xz 0, yz 0); allowed: larger ones, or zeros");
}

TEST(Mass, that_is_a_parameter_is_judged_by_its_default) {
  EXPECT_EQ(message(bare_body("mass = 'm'\ninertia = [1, 1, 1]\n[parameters]\nm = -0.5")),
            "f:4: body 1: mass: found m = -0.5; allowed: a positive number, or zero");
}

TEST(Inertia, of_three_moments_is_diagonal) {
  const Symmetric inertia = parse(with_inertia("[1, 2, 2.5]"), "f").bodies[0].inertia;
  EXPECT_EQ(inertia.xx, Number::constant(1));
  EXPECT_EQ(inertia.yy, Number::constant(2));
  EXPECT_EQ(inertia.zz, Number::constant(2.5));
  for (const Number& number : {inertia.xy, inertia.xz, inertia.yz}) EXPECT_TRUE(number.is_zero());
}

TEST(Inertia, entries_keep_their_places) {
  const Symmetric inertia = parse(with_inertia("[[4, 0.1, 0.2], [0.1, 5, 0.3], [0.2, 0.3, 6]]"), "f").bodies[0].inertia;
  EXPECT_EQ(inertia.xx, Number::constant(4));
  EXPECT_EQ(inertia.yy, Number::constant(5));
  EXPECT_EQ(inertia.zz, Number::constant(6));
  EXPECT_EQ(inertia.xy, Number::constant(0.1));
  EXPECT_EQ(inertia.xz, Number::constant(0.2));
  EXPECT_EQ(inertia.yz, Number::constant(0.3));
}

TEST(Inertia, that_is_not_symmetric_is_refused) {
  EXPECT_EQ(
      message(with_inertia("[[1, 0.1, 0], [0.2, 1, 0], [0, 0, 1]]")),
      "f:5: body 1: inertia: found inertia[1][2] is 0.1, inertia[2][1] is 0.2; allowed: a symmetric matrix: the same "
      "number or name in both");
  EXPECT_THAT(message(with_inertia("[[1, 0, 0], [0, 1, 'c'], [0, 0.1, 1]]\n[parameters]\nc = 0.1")),
              HasSubstr("found inertia[2][3] is c = 0.1, inertia[3][2] is 0.1; "));
}

TEST(Inertia, with_a_negative_moment_is_refused) {
  EXPECT_EQ(
      message(with_inertia("[1, -2, 1]")),
      "f:5: body 1: inertia: found principal moments -2, 1, 1 (entries xx 1, yy -2, zz 1, xy 0, xz 0, yz 0); allowed: "
      "a positive definite matrix; one of these is negative");
  // positive diagonal, yet eigenvalues 1 - 2 and 1 + 2
  EXPECT_THAT(message(with_inertia("[[1, 2, 0], [2, 1, 0], [0, 0, 1]]")), HasSubstr("found principal moments -1"));
  EXPECT_THAT(message(with_inertia("[-1, -1, -1]")), HasSubstr("one of these is negative"));
}

TEST(Inertia, of_a_slender_rod_is_accepted) {
  const Scene scene = parse(with_inertia("[1, 1, 1e-9]"), "f");
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(Inertia, against_the_triangle_inequality_is_a_warning_that_names_the_entries) {
  EXPECT_THAT(
      parse(with_inertia("[0.1, 0.5, 0.2]"), "f").warnings,
      ElementsAre("f:5: body 1: inertia: principal moments 0.1, 0.2, 0.5 (entries xx 0.1, yy 0.5, zz 0.2, xy 0, xz 0, "
                  "yz 0) violate the triangle inequality: the largest exceeds the sum of the others, as in no rigid "
                  "body; modelled as written"));
}

TEST(Inertia, triangle_inequality_is_of_principal_moments_and_not_of_entries) {
  // entries 2, 2, 3; principal moments 0.5, 3, 3.5
  EXPECT_THAT(parse(with_inertia("[[2, 1.5, 0], [1.5, 2, 0], [0, 0, 3]]"), "f").warnings, IsEmpty());
  // entries 2, 2, 2; principal moments 0.5, 2, 3.5
  EXPECT_THAT(parse(with_inertia("[[2, 1.5, 0], [1.5, 2, 0], [0, 0, 2]]"), "f").warnings,
              ElementsAre(HasSubstr("violate the triangle inequality")));
}

TEST(Inertia, of_a_flat_body_meets_the_triangle_inequality_in_decimals) {
  EXPECT_GT(0.1 + 0.2, 0.3);  // and 0.7 + 0.1 is below 0.8: rounding is not a violation
  EXPECT_LT(0.7 + 0.1, 0.8);
  EXPECT_THAT(parse(with_inertia("[0.1, 0.2, 0.3]"), "f").warnings, IsEmpty());
  EXPECT_THAT(parse(with_inertia("[0.7, 0.1, 0.8]"), "f").warnings, IsEmpty());
}

TEST(Inertia, of_parameters_is_judged_by_their_defaults) {
  const std::string matrix = "[['a', 'c', 0], ['c', 1, 0], [0, 0, 1]]\n[parameters]\na = 1\nc = ";
  EXPECT_EQ(message(with_inertia(matrix + "0.5")), "no error");
  EXPECT_THAT(message(with_inertia(matrix + "1.5")),
              HasSubstr("(entries xx a = 1, yy 1, zz 1, xy c = 1.5, xz 0, yz 0); allowed: a positive definite matrix"));
}

TEST(Inertia, of_another_shape_is_refused) {
  const std::string shape = "; allowed: 3 principal moments, or 3 rows of 3 (about the mass centre, body axes)";
  EXPECT_EQ(message(with_inertia("1")), "f:5: body 1: inertia: found 1" + shape);
  EXPECT_EQ(message(with_inertia("[1, 1]")), "f:5: body 1: inertia: found a list of 2" + shape);
  EXPECT_EQ(message(with_inertia("[1, 0, 0, 0, 1, 0, 0, 0, 1]")), "f:5: body 1: inertia: found a list of 9" + shape);
  EXPECT_THAT(message(with_inertia("[[1, 0, 0], [0, 1], [0, 0, 1]]")),
              StartsWith("f:5: body 1: inertia[2]: found a list of 2; allowed: a row of 3"));
  EXPECT_THAT(message(with_inertia("[1, [0, 1, 0], 1]")),
              StartsWith("f:5: body 1: inertia[1]: found 1; allowed: a row of 3"));
  EXPECT_THAT(message(with_inertia("[[1, 0, 0], [0, 1, 0], [0, 0, {}]]")),
              StartsWith("f:5: body 1: inertia[3][3]: found a table"));
}

TEST(InitialState, with_euler_parameters_of_zero_norm_is_refused) {
  EXPECT_EQ(
      message(one_body("[body.initial]\neps = [0, 0, 0, 0.0]")),
      "f:7: body 1: initial.eps: found Euler parameters of norm 0; allowed: any other four numbers, scalar last; they "
      "are normalised");
}

TEST(InitialState, far_from_unit_norm_is_normalised_with_a_note) {
  const Scene scene = parse(one_body("[body.initial]\neps = [0, 3, 0, 4]"), "f");
  EXPECT_THAT(scene.bodies[0].initial.eps, ElementsAre(0, 0.6, 0, 0.8));
  EXPECT_THAT(scene.notes, ElementsAre("f:7: body 1: initial.eps: Euler parameters of norm 5, normalised to 1"));
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(InitialState, that_may_be_meant_otherwise_has_a_note) {
  const auto notes = [](const std::string& joint, const std::string& initial) {
    return parse(one_body(joint + "\n[body.initial]\n" + initial), "f").notes;
  };
  EXPECT_THAT(notes("", "eps = [1, 0, 0, 0]"),
              ElementsAre("f:8: body 1: initial.eps: half a turn about x: the scalar part is the last of the four, "
                          "[0, 0, 0, 1] is no turn"));
  EXPECT_THAT(notes("joint = 'revolute'\naxis = 'x'", "theta = 90"),
              ElementsAre("f:9: body 1: initial.theta: found 90, more than a turn: angles are in rad"));
  EXPECT_THAT(notes("joint = 'revolute'\naxis = 'x'", "theta = -6.2"), IsEmpty());
}

TEST(JointLoad, that_drives_instead_of_holding_has_a_note) {
  const auto notes = [](const std::string& load) {
    return parse(one_body("joint = 'revolute'\naxis = 'x'\n" + load), "f").notes;
  };
  EXPECT_THAT(notes("stiffness = -5"),
              ElementsAre("f:8: body 1: stiffness: found -5, a stiffness that drives away from rest"));
  EXPECT_THAT(notes("damping = '-2*3'"),
              ElementsAre("f:8: body 1: damping: found -6, a damping that feeds the motion"));
  EXPECT_THAT(notes("stiffness = 5\ndamping = 0"), IsEmpty());
}

TEST(InitialState, near_to_unit_norm_is_normalised_without_a_note) {
  const Scene scene = parse(one_body("[body.initial]\neps = [0.5773503, 0.5773503, 0.5773503, 0]"), "f");
  // four roundings of half an ulp each leave the norm within 4 eps
  EXPECT_NEAR(
      std::hypot(scene.bodies[0].initial.eps[0], scene.bodies[0].initial.eps[1], scene.bodies[0].initial.eps[2]), 1,
      4 * 2.2e-16);
  EXPECT_NE(scene.bodies[0].initial.eps[0], 0.5773503);
  EXPECT_THAT(scene.notes, IsEmpty());
}

TEST(InitialState, of_extreme_euler_parameters_neither_overflows_nor_underflows) {
  EXPECT_THAT(parse(one_body("[body.initial]\neps = [0, 3e59, 0, 4e59]"), "f").bodies[0].initial.eps,
              ElementsAre(0, 0.6, 0, 0.8));
  EXPECT_THAT(parse(one_body("[body.initial]\neps = [0, 0, 0, -1e-320]"), "f").bodies[0].initial.eps,
              ElementsAre(0, 0, 0, -1));
}

TEST(InitialState, takes_numbers_and_no_names) {
  for (const std::string key : {"omega", "s", "sdot"})
    EXPECT_EQ(message(one_body("[body.initial]\n" + key + " = [0, 'w', 0]\n[parameters]\nw = 1")),
              "f:7: body 1: initial." + key +
                  "[2]: found the text \"w\"; allowed: a finite number (names are not for the initial state)");
  EXPECT_THAT(message(one_body("[body.initial]\neps = [0, 0, 0, '1']")),
              StartsWith("f:7: body 1: initial.eps[4]: found the text"));
}

TEST(InitialState, of_another_shape_is_refused) {
  EXPECT_EQ(message(one_body("[body.initial]\neps = [0, 0, 1]")),
            "f:7: body 1: initial.eps: found a list of 3; allowed: a list of 4 numbers");
  EXPECT_EQ(message(one_body("[body.initial]\nomega = [0, 0, 1, 0]")),
            "f:7: body 1: initial.omega: found a list of 4; allowed: a list of 3 numbers");
  EXPECT_EQ(message(one_body("[body.initial]\nsdot = 1")),
            "f:7: body 1: initial.sdot: found 1; allowed: a list of 3 numbers");
}

}  // namespace
}  // namespace kanec::scene
