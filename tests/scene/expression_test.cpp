// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <cmath>
#include <numbers>

#include "generator/read/expression_names.hpp"
#include "generator/read/parse_expression.hpp"
#include "generator/scene/expression_value.hpp"
#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using Kind = ExpressionNode::Kind;

const std::vector<ExpressionName> names = {{"t", {.kind = Kind::time}}, {"a", {.kind = Kind::parameter, .index = 0}}};

Expression parsed(const std::string& text) { return parse_expression(text, {"f"}, names); }

// The value at t = 2 with a = 3.
double number(const std::string& text) { return static_cast<double>(value(parsed(text), {{"a", 3}}, 2)); }

std::string refusal(const std::string& text) {
  try {
    parsed(text);
  } catch (const SceneError& error) {
    return error.what();
  }
  return "no error";
}

std::string repeated(const std::string& text, int times) {
  std::string out;
  for (int i = 0; i < times; ++i) out += text;
  return out;
}

// Oracle: arithmetic by hand; every number is a double exactly.
TEST(Expression, operators_bind_as_written_in_mathematics) {
  EXPECT_EQ(number("1 + 2*3"), 7);
  EXPECT_EQ(number("1 - 2 - 3"), -4);
  EXPECT_EQ(number("16/4/2"), 2);
  EXPECT_EQ(number("(1 + 2)*3"), 9);
  EXPECT_EQ(number("2^3^2"), 512);
  EXPECT_EQ(number("-2^2"), -4);
  EXPECT_EQ(number("(-2)^2"), 4);
  EXPECT_EQ(number("2^-1"), 0.5);
  EXPECT_EQ(number("2^-2^2"), 0.0625);
  EXPECT_EQ(number("2*-3"), -6);
  EXPECT_EQ(number("3--2"), 5);
  EXPECT_EQ(number("-+-4"), 4);
  EXPECT_EQ(number("a*t^2/4 + t"), 5);
}

TEST(Expression, numbers_are_read_in_every_form) {
  EXPECT_EQ(number("12"), 12);
  EXPECT_EQ(number("1.5e-3"), 1.5e-3);
  EXPECT_EQ(number("1E2"), 100);
  EXPECT_EQ(number(".5"), 0.5);
  EXPECT_EQ(number("2."), 2);
  EXPECT_EQ(number(" \t0.1 "), 0.1);
  EXPECT_EQ(number("pi"), std::numbers::pi);
}

// Oracle: the C++ library's functions in extended precision.
TEST(Expression, calls_are_those_of_their_names) {
  const long double x = 0.3L, y = 0.7L;
  const std::string one = "(3/10)", two = "(3/10, 7/10)";
  const std::vector<std::pair<std::string, long double>> calls = {{"sin" + one, std::sin(x)},
                                                                  {"cos" + one, std::cos(x)},
                                                                  {"tan" + one, std::tan(x)},
                                                                  {"asin" + one, std::asin(x)},
                                                                  {"acos" + one, std::acos(x)},
                                                                  {"atan2" + two, std::atan2(x, y)},
                                                                  {"sqrt" + one, std::sqrt(x)},
                                                                  {"exp" + one, std::exp(x)},
                                                                  {"log" + one, std::log(x)},
                                                                  {"abs(-3/10)", x},
                                                                  {"min" + two, x},
                                                                  {"max" + two, y},
                                                                  {"pow" + two, std::pow(x, y)},
                                                                  {"tanh" + one, std::tanh(x)}};
  EXPECT_EQ(calls.size(), call_names().size());
  for (const auto& [text, wanted] : calls) EXPECT_EQ(number(text), static_cast<double>(wanted)) << text;
}

TEST(Expression, power_is_a_call_and_operands_stand_before_their_step) {
  const Expression expression = parsed("-a^t");
  ASSERT_EQ(expression.nodes.size(), 4u);
  EXPECT_EQ(expression.nodes[2].kind, Kind::call);
  EXPECT_EQ(expression.nodes[2].call, Call::pow);
  EXPECT_EQ(expression.nodes[3].kind, Kind::negate);
  EXPECT_EQ(expression.text, "-a^t");
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_LT(expression.nodes[i].a, static_cast<int>(i));
    EXPECT_LT(expression.nodes[i].b, static_cast<int>(i));
  }
}

TEST(Expression, every_call_takes_its_number_of_arguments) {
  for (std::size_t i = 0; i < call_names().size(); ++i) {
    const std::string& name = call_names()[i];
    const bool two = n_arguments(static_cast<Call>(i)) == 2;
    EXPECT_EQ(refusal(name + "(1)") == "no error", !two) << name;
    EXPECT_EQ(refusal(name + "(1, 2)") == "no error", two) << name;
    EXPECT_NE(refusal(name + "(1, 2, 3)"), "no error") << name;
    EXPECT_NE(refusal(name + "()"), "no error") << name;
  }
  EXPECT_EQ(refusal("atan2(1)"),
            "f: found \")\" in column 8 of \"atan2(1)\"; allowed: an operator, or a comma: atan2 "
            "takes two arguments");
  EXPECT_EQ(refusal("sin(1, 2)"),
            "f: found \",\" in column 6 of \"sin(1, 2)\"; allowed: an operator or ): sin takes one argument");
}

TEST(Expression, error_names_column_and_what_was_expected) {
  const std::string operand = "; allowed: a number, a name, a function or (";
  const std::string rest = "; allowed: an operator, + - * / ^, or the end";
  EXPECT_EQ(refusal(""), "f: found the end in column 1 of \"\"" + operand);
  EXPECT_EQ(refusal("1 +"), "f: found the end in column 4 of \"1 +\"" + operand);
  EXPECT_EQ(refusal("1 + * 2"), "f: found \"*\" in column 5 of \"1 + * 2\"" + operand);
  EXPECT_EQ(refusal("2 t"), "f: found \"t\" in column 3 of \"2 t\"" + rest);
  EXPECT_EQ(refusal("1e"), "f: found \"e\" in column 2 of \"1e\"" + rest);
  EXPECT_EQ(refusal("0x10"), "f: found \"x10\" in column 2 of \"0x10\"" + rest);
  EXPECT_EQ(refusal("1)"), "f: found \")\" in column 2 of \"1)\"" + rest);
  EXPECT_EQ(refusal("(1"), "f: found the end in column 3 of \"(1\"; allowed: an operator or )");
  EXPECT_EQ(refusal("1, 2"), "f: found \",\" in column 2 of \"1, 2\"" + rest);
  EXPECT_EQ(refusal("t**2"), "f: found \"*\" in column 2 of \"t**2\"; allowed: one *, or ^ for a power");
  EXPECT_EQ(refusal("t = 2"),
            "f: found \"=\" in column 3 of \"t = 2\"; allowed: numbers, names, + - * / ^ ( ) and commas");
  EXPECT_THAT(refusal("2 · t"), HasSubstr("found \"·\" in column 3 of"));
  EXPECT_THAT(refusal("1\n+ t"), HasSubstr("found \"\\x0a\" in column 2 of"));
  EXPECT_EQ(refusal("."), "f: found \".\" in column 1 of \".\"; allowed: a number, in magnitude at most 1e+60");
  EXPECT_THAT(refusal("2*1e61"), HasSubstr("found \"1e61\" in column 3 of "));
  EXPECT_THAT(refusal("1e999"), HasSubstr("found \"1e999\" in column 1 of "));
  EXPECT_THAT(refusal("inf"), HasSubstr("found \"inf\" in column 1 of \"inf\"; allowed: a name: pi, t, a"));
}

TEST(Expression, name_or_function_that_is_not_known_is_refused_with_the_nearest) {
  EXPECT_EQ(
      refusal("sine(t)"),
      "f: found \"sine\" in column 1 of \"sine(t)\"; allowed: a function: sin, cos, tan, asin, acos, atan2, sqrt, "
      "exp, log, abs, min, max, pow, tanh (did you mean sin?)");
  EXPECT_EQ(refusal("2*sin"),
            "f: found \"sin\" in column 3 of \"2*sin\", a function without its argument; allowed: sin(…)");
  EXPECT_THAT(refusal("a(2)"), HasSubstr("found \"a\" in column 1 of \"a(2)\"; allowed: a function: "));
  EXPECT_THAT(refusal("system('ls')"), HasSubstr("found \"system\" in column 1"));
}

TEST(Expression, depth_and_length_have_limits_and_no_text_overflows_the_stack) {
  const std::string rule = "; allowed: at most 64 levels of parentheses, signs and powers";
  EXPECT_EQ(refusal(repeated("(", 63) + "1" + repeated(")", 63)), "no error");
  for (const std::string text : {"(", "-", "2^", "sin(", "-2^-("})
    EXPECT_THAT(refusal(repeated(text, 4096 / static_cast<int>(text.size()))), HasSubstr(rule)) << text;
  EXPECT_EQ(refusal(repeated("1+", 2047) + "1"), "no error");
  EXPECT_EQ(refusal(repeated(" ", 4096) + "1"), "f: found an expression of 4097 characters; allowed: at most 4096");
}

TEST(Expression, of_numbers_alone_is_constant) {
  EXPECT_TRUE(is_constant(parsed("2*sin(pi/3)")));
  EXPECT_FALSE(is_constant(parsed("0*t")));
  EXPECT_FALSE(is_constant(parsed("a - a")));
}

TEST(Expression, cosine_of_half_pi_is_zero_to_extended_precision) {
  EXPECT_LT(std::fabs(value(parsed("cos(pi/2)"), {})), 1e-19L);
}

// A cart of one slide, an arm of one turn that is locked, a hub with a ball and a tool with two turns.
Scene sample() {
  const auto body = [](const std::string& name, const std::string& rest) { return good_body(name) + rest; };
  return parse("name = 'a'\nconnection = [0, 1, 2, 3]\n" + body("cart", "joint = 'prismatic'\naxis = 'x'\n") +
                   body("arm", "joint = 'revolute'\naxis = 'z'\n[body.motion]\ntheta = 0.5\n") +
                   body("hub", "joint = 'ball'\n") + body("tool", "joint = 'universal'\naxes = ['x', 'y']\n") +
                   "[parameters]\nc = 1\n[inputs]\nu = 1\n",
               "f");
}

TEST(ExpressionNames, mean_entries_of_the_state_by_number_and_by_name) {
  const Scene scene = sample();
  const auto names_of_loads = names_for_loads(scene);
  const auto meaning = [&](const std::string& text) {
    const ExpressionNode node = parse_expression(text, {"f"}, names_of_loads).nodes.back();
    return std::pair(node.kind, node.index);
  };
  EXPECT_EQ(meaning("t").first, Kind::time);
  EXPECT_EQ(meaning("c"), std::pair(Kind::parameter, 0));
  EXPECT_EQ(meaning("u"), std::pair(Kind::input, 0));
  const auto x = coordinate_names(scene), y = speed_names(scene);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_EQ(meaning(x[i]), std::pair(Kind::coordinate, static_cast<int>(i)));
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_EQ(meaning(y[i]), std::pair(Kind::speed, static_cast<int>(i)));
  EXPECT_EQ(meaning("s_cart"), meaning("s_1"));
  EXPECT_EQ(meaning("sdot_cart"), meaning("sdot_1"));
  EXPECT_EQ(meaning("eps_hub_4"), meaning("eps_3_4"));
  EXPECT_EQ(meaning("omega_hub_1"), meaning("omega_3_1"));
  EXPECT_EQ(meaning("thetadot_tool_2"), meaning("thetadot_4_2"));
}

TEST(ExpressionNames, of_what_is_not_in_the_state_are_refused_with_the_reason) {
  Scene scene = sample();
  const auto read = [&](const std::string& text) -> std::string {
    try {
      parse_expression(text, {"f"}, names_for_loads(scene));
    } catch (const SceneError& error) {
      return error.what();
    }
    return "no error";
  };
  EXPECT_THAT(read("theta_2"),
              HasSubstr("found \"theta_2\" in column 1 of \"theta_2\", which is locked at 0.5, and no part "
                        "of the state; allowed: another name: pi, t, c, u, "));
  EXPECT_THAT(read("thetadot_arm"), HasSubstr("which is locked at 0.5, and no part of the state"));
  EXPECT_THAT(read("theta_amr"), HasSubstr("found \"theta_amr\" in column 1"));
  EXPECT_THAT(read("theta_tool"), HasSubstr("(did you mean theta_tool_1?)"));
  scene.bodies[2].joint.held = true;
  EXPECT_THAT(read("eps_hub_1"), HasSubstr("of an attitude that is held, and no part of the state"));
}

TEST(ExpressionNames, that_two_bodies_make_alike_are_refused) {
  const Scene scene =
      parse("name = 'a'\nconnection = [0, 1]\n" + good_body("arm") + "joint = 'universal'\naxes = ['x', 'y']\n" +
                good_body("arm_2") + "joint = 'revolute'\naxis = 'x'\n",
            "f");
  EXPECT_THROW(parse_expression("theta_arm_2", {"f"}, names_for_loads(scene)), SceneError);
  EXPECT_EQ(parse_expression("theta_arm_1", {"f"}, names_for_loads(scene)).nodes.size(), 1u);
}

TEST(Names, that_mean_something_else_in_expressions_are_refused) {
  const auto parameter = [](const std::string& name) {
    return message(one_body("name = 'hub'\n[parameters]\n" + name + " = 1"));
  };
  EXPECT_EQ(parameter("t"), "f:8: parameters.t: found \"t\", which is the time; allowed: another name");
  EXPECT_THAT(parameter("pi"), HasSubstr("found \"pi\", which is a constant; "));
  EXPECT_THAT(parameter("atan2"), HasSubstr("found \"atan2\", which is a function of expressions; "));
  EXPECT_THAT(parameter("free"), HasSubstr("found \"free\", which is a word of body.motion; "));
  EXPECT_THAT(parameter("eps_1_4"), HasSubstr("which is a coordinate of this scene; "));
  EXPECT_THAT(parameter("s_hub_3"), HasSubstr("which is a coordinate of this scene; "));
  EXPECT_THAT(parameter("omega_hub_3"), HasSubstr("which is a speed of this scene; "));
  EXPECT_EQ(parameter("theta_1"), "no error");
}

}  // namespace
}  // namespace kanec::scene
