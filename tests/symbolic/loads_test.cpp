// The tables of bodies and loads. Oracle: the scene, read by hand.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/read/read.hpp"
#include "generator/symbolic/derive.hpp"
#include "generator/tables/formula.hpp"
#include "generator/tables/grids.hpp"
#include "generator/tables/tables.hpp"

namespace kanec::emit {
namespace {

using symbolic::Style;
using testing::ElementsAre;
using testing::ElementsAreArray;
using testing::HasSubstr;
using testing::IsEmpty;

using Lines = std::vector<std::vector<std::string>>;

constexpr auto text = R"toml(
name = "loads"
connection = [0, 1, 2]
[parameters]
k = 40
[inputs]
push = 1.5
[[body]]
name = "hub"
mass = 1
inertia = [1, 1, 1]
force = [0, 0, "push"]
moment = [0.5, 0, 0]
[[body]]
name = "arm"
joint = "revolute"
axis = "y"
mass = 1
inertia = [1, 1, 1]
effort = "push - 0.5*theta_arm^2"
stiffness = "k"
rest = 1e-3
damping = 0.25
[body.initial]
theta = 2
[[body]]
name = "tip"
joint = "weld"
mass = 1
inertia = [1, 1, 1]
[[load]]
kind = "force"
name = "jet"
body = "tip"
r = [0, 0.1, 0]
vector = [0, "2*cos(t)", 0]
axes = "lower"
reaction = "ground"
[[load]]
kind = "moment"
name = "twist"
body = "arm"
vector = [0, 0, 1]
[[load]]
kind = "spring"
name = "tie"
body = "tip"
other_body = "ground"
other_r = [1, 0, 0]
stiffness = 3
rest = 0.5
)toml";

symbolic::Equations equations() { return symbolic::derive(scene::parse(text, "loads.toml")); }

TEST(Loads, have_a_line_a_number_with_place_letter_value_and_unit) {
  const std::string arm = "joint of body 2 (arm), along theta_arm";
  const std::string tie = "between body 3 (tip) at its origin and the ground at r_tie_other_ = (1, 0, 0) m";
  EXPECT_THAT(load_grid(equations(), Style::text).lines,
              ElementsAreArray(Lines{
                  {"hub", "body 1 (hub) at its mass centre, inertial axes", "F1", "(0, 0, push)", "(0, 0, 1.5)", "N"},
                  {"hub", "body 1 (hub), its axes", "M1", "(0.5, 0, 0)", "(0.5, 0, 0)", "N m"},
                  {"arm", arm, "tau_arm_", "push - 0.5*theta_arm^2", "-0.5", "N m"},
                  {"arm", arm, "k_arm_", "k", "40", "N m/rad"},
                  {"arm", arm, "c_arm_", "0.25", "0.25", "N m s/rad"},
                  {"arm", arm, "l_arm_", "0.001", "0.001", "rad"},
                  {"jet", "body 3 (tip) at r_jet_ = (0, 0.1, 0) m, axes of body 2 (arm); the opposite on the ground",
                   "F_jet_", "(0, 2*cos(t), 0)", "(0, 2, 0)", "N"},
                  {"twist", "body 2 (arm), inertial axes", "M_twist_", "(0, 0, 1)", "(0, 0, 1)", "N m"},
                  {"tie", tie, "k_tie_", "3", "3", "N/m"},
                  {"tie", tie, "l_tie_", "0.5", "0.5", "m"}}));
}

TEST(Loads, have_the_letters_of_the_equations) {
  const std::string document = text_document(equations());
  const std::string shown = document.substr(0, document.find("\nLoads"));
  for (const auto& line : load_grid(equations(), Style::text).lines) EXPECT_THAT(shown, HasSubstr(line[2]));
  const std::string latex = latex_document(equations());
  const std::string rows = latex.substr(0, latex.find("\\subsection*{Loads"));
  for (const auto& line : load_grid(equations(), Style::latex).lines)
    EXPECT_THAT(rows, HasSubstr(line[2].substr(1, line[2].size() - 2)));
}

TEST(Loads, are_set_as_formulas) {
  const Lines lines = load_grid(equations(), Style::latex).lines;
  ASSERT_EQ(lines.size(), 10u);
  EXPECT_EQ(lines[2][2], "$\\tau_{\\text{arm}}$");
  EXPECT_EQ(lines[2][3], "$\\text{push} \\brk - 0.5 \\brkfac \\cdot \\theta_{2}^{2}$");
  EXPECT_EQ(lines[5][4], "$0.001$");
}

TEST(Loads, of_a_scene_without_any_have_no_table) {
  const symbolic::Equations free = symbolic::derive(scene::read(KANEC_SOURCE_DIR "/models/free_body/scene.toml"));
  EXPECT_THAT(load_grid(free, Style::text).lines, IsEmpty());
  EXPECT_THAT(text_document(free), testing::Not(HasSubstr("Loads")));
  EXPECT_THAT(latex_document(free), testing::Not(HasSubstr("Loads")));
}

TEST(Loads, say_whose_and_where_once) {
  const Lines lines = without_repetition(load_grid(equations(), Style::text));
  EXPECT_EQ(lines[0][0], "hub");
  EXPECT_EQ(lines[1][0], "");
  EXPECT_EQ(lines[1][1], "body 1 (hub), its axes");
  EXPECT_EQ(lines[3][1], "");
  EXPECT_EQ(lines[3][2], "k_arm_");
}

TEST(Bodies, have_their_names_joints_and_coordinates) {
  EXPECT_THAT(body_grid(equations(), Style::text).lines,
              ElementsAreArray(Lines{{"1", "hub", "free", "eps_hub_1 to 4, s_hub_1 to 3"},
                                     {"2", "arm", "revolute", "theta_arm"},
                                     {"3", "tip", "weld", "none"}}));
}

TEST(Formula, ends_its_lines_between_entries_rather_than_terms_and_terms_rather_than_factors) {
  EXPECT_EQ(latex_breaks("a_{1} b + \\dot s (c - d, e)"),
            "a_{1} \\brkfac b \\brk + \\dot s \\brkfac (c \\brkin - d,\\; \\brkin e)");
  EXPECT_EQ(latex_breaks("[-a + b, 0]"), "[-a \\brkin + b,\\; \\brk 0]");
  EXPECT_EQ(latex_breaks("\\text{a b} = \\tfrac{a + b}{c}"), "\\text{a b} \\brk = \\tfrac{a + b}{c}");
}

TEST(Formula, keeps_the_meaning_of_signs_and_powers) {
  const scene::Scene scene = scene::parse(R"toml(
name = "signs"
connection = [0]
[parameters]
a_ = 1
b = 2
[[body]]
name = "m"
joint = "prismatic"
axis = "x"
mass = 1
inertia = [0, 0, 0]
effort = "-(a_ + b)*-b/(2*b) - (a_ - b)^(b/2) - (-b)^2 + max(abs(s_m), 1e-9)*sqrt(2)/pi"
)toml",
                                          "signs.toml");
  ASSERT_EQ(scene.expressions.size(), 1u);
  EXPECT_EQ(
      latex_formula(scene, scene.expressions[0]),
      "-(\\text{a\\_} + \\text{b}) \\cdot (-\\text{b}) / (2 \\cdot \\text{b}) - (\\text{a\\_} - \\text{b})^{\\text{b} "
      "/ 2} - (-\\text{b})^{2} + \\max(\\lvert s_{1} \\rvert, 10^{-9}) \\cdot \\sqrt{2} / \\pi");
}

}  // namespace
}  // namespace kanec::emit
