// Values of expressions, their derivatives by dual numbers, the courses of prescribed coordinates. Oracles: the
// standard library's functions, central differences, derivatives in closed form.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/generic/expression.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "tests/generic/sample.hpp"

namespace kanec::generic {
namespace {

using scene::Call;
using Node = scene::ExpressionNode;
using Kind = Node::Kind;

// call(t, b), or call(t).
scene::Expression calling(Call function, double b) {
  return {"",
          {{.kind = Kind::time},
           {.kind = Kind::number, .value = b},
           {.kind = Kind::call, .call = function, .a = 0, .b = 1}}};
}

template <class Number>
Number at_time(const scene::Expression& expression, const Number& t) {
  return value_of<Number>(expression, [&](const Node&) { return t; });
}

struct Case {
  Call call;
  double b;
  std::function<Real(Real)> expected;
};
const std::vector<Case> cases = {
    {Call::sin, 0, [](Real t) { return std::sin(t); }},
    {Call::cos, 0, [](Real t) { return std::cos(t); }},
    {Call::tan, 0, [](Real t) { return std::tan(t); }},
    {Call::asin, 0, [](Real t) { return std::asin(t); }},
    {Call::acos, 0, [](Real t) { return std::acos(t); }},
    {Call::atan2, -0.7, [](Real t) { return std::atan2(t, Real(-0.7)); }},
    {Call::sqrt, 0, [](Real t) { return std::sqrt(t); }},
    {Call::exp, 0, [](Real t) { return std::exp(t); }},
    {Call::log, 0, [](Real t) { return std::log(t); }},
    {Call::abs, 0, [](Real t) { return std::abs(t); }},
    {Call::min, 0.5, [](Real t) { return std::min(t, 0.5L); }},
    {Call::max, 0.5, [](Real t) { return std::max(t, 0.5L); }},
    {Call::pow, 2.5, [](Real t) { return std::pow(t, 2.5L); }},
    {Call::tanh, 0, [](Real t) { return std::tanh(t); }},
};

TEST(Expression, calls_every_function) {
  for (const Case& c : cases)
    for (const Real t : {0.3L, 0.8L}) EXPECT_EQ(at_time(calling(c.call, c.b), t), c.expected(t)) << int(c.call);
}

// A step of 1e-6 leaves 1e-12 of a third derivative of at most 100, and 1e-13 of rounding.
TEST(Expression, is_differentiated_by_dual_numbers) {
  const Real h = 1e-6L;
  for (const Case& c : cases)
    for (const Real t : {0.3L, 0.8L}) {
      const Real difference = (c.expected(t + h) - c.expected(t - h)) / (2 * h);
      EXPECT_NEAR(double(at_time(calling(c.call, c.b), Dual<Real>(t, 1)).rate), double(difference), 1e-9)
          << int(c.call);
    }
}

TEST(Expression, computes_with_its_operands_in_their_order) {
  // (2 - t) / -(t + 3) * 5
  const scene::Expression expression = {"",
                                        {{.kind = Kind::number, .value = 2},
                                         {.kind = Kind::time},
                                         {.kind = Kind::subtract, .a = 0, .b = 1},
                                         {.kind = Kind::number, .value = 3},
                                         {.kind = Kind::add, .a = 1, .b = 3},
                                         {.kind = Kind::negate, .a = 4},
                                         {.kind = Kind::divide, .a = 2, .b = 5},
                                         {.kind = Kind::number, .value = 5},
                                         {.kind = Kind::multiply, .a = 6, .b = 7}}};
  EXPECT_EQ(at_time(expression, Real(7)), 2.5L);
}

// Value, first and second derivative of an expression of time alone.
Vector course(const scene::Expression& expression, Real t) {
  scene::Scene scene;
  scene.expressions = {expression};
  const auto course = System<Real>(scene, {}).course(0, t);
  return Vector{{course.value, course.rate, course.second_rate}};
}

TEST(Course, has_first_and_second_derivatives_in_closed_form) {
  const Real t = 0.4L;
  EXPECT_LT(relative_error(course(calling(Call::sin, 0), t), Vector{{std::sin(t), std::cos(t), -std::sin(t)}}),
            rounding);
  EXPECT_LT(relative_error(course(calling(Call::exp, 0), t), std::exp(t) * Vector::Ones(3)), rounding);
  EXPECT_LT(relative_error(course(calling(Call::log, 0), t), Vector{{std::log(t), 1 / t, -1 / (t * t)}}), rounding);
  const Real square = 1 + t * t;
  EXPECT_LT(relative_error(course(calling(Call::atan2, 1), t),
                           Vector{{std::atan(t), 1 / square, -2 * t / (square * square)}}),
            rounding);
}

// A whole power of time has its derivatives also at and before zero.
TEST(Course, of_powers_needs_no_positive_base) {
  EXPECT_EQ(course(calling(Call::pow, 2), 0), (Vector{{0, 0, 2}}));
  EXPECT_EQ(course(calling(Call::pow, 3), -2), (Vector{{-8, 12, -12}}));
  EXPECT_EQ(course(calling(Call::pow, 1), 0), (Vector{{0, 1, 0}}));
  EXPECT_EQ(course(calling(Call::pow, 0), 0), (Vector{{1, 0, 0}}));
}

// Central differences of random courses of bounded derivatives: errors as above.
TEST(Course, is_that_of_its_differences) {
  for (const Sample& s : samples(test::everything())) {
    const System<Real> system = s.system<Real>();
    for (const scene::Body& body : s.scene.bodies)
      for (const auto* coordinates : {&body.joint.turns, &body.joint.slides})
        for (const scene::Coordinate& one : *coordinates) {
          if (one.motion != scene::Coordinate::Motion::prescribed) continue;
          const Real h = 1e-6L;
          const auto here = system.course(one.expression, s.t), ahead = system.course(one.expression, s.t + h),
                     behind = system.course(one.expression, s.t - h);
          EXPECT_NEAR(double(here.rate), double((ahead.value - behind.value) / (2 * h)), 1e-8);
          EXPECT_NEAR(double(here.second_rate), double((ahead.rate - behind.rate) / (2 * h)), 1e-8);
        }
  }
}

}  // namespace
}  // namespace kanec::generic
