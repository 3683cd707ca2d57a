// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/expression_value.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>

namespace kanec::scene {
namespace {

using Kind = ExpressionNode::Kind;

long double call(Call function, long double a, long double b) {
  switch (function) {
    case Call::sin:
      return std::sin(a);
    case Call::cos:
      return std::cos(a);
    case Call::tan:
      return std::tan(a);
    case Call::asin:
      return std::asin(a);
    case Call::acos:
      return std::acos(a);
    case Call::atan2:
      return std::atan2(a, b);
    case Call::sqrt:
      return std::sqrt(a);
    case Call::exp:
      return std::exp(a);
    case Call::log:
      return std::log(a);
    case Call::abs:
      return std::fabs(a);
    case Call::min:
      return std::fmin(a, b);
    case Call::max:
      return std::fmax(a, b);
    case Call::pow:
      return std::pow(a, b);
    case Call::tanh:
      return std::tanh(a);
  }
  return std::numeric_limits<long double>::quiet_NaN();
}

long double combined(const ExpressionNode& node, long double a, long double b) {
  switch (node.kind) {
    case Kind::negate:
      return -a;
    case Kind::add:
      return a + b;
    case Kind::subtract:
      return a - b;
    case Kind::multiply:
      return a * b;
    case Kind::divide:
      return a / b;
    case Kind::call:
      return call(node.call, a, b);
    default:
      return std::numeric_limits<long double>::quiet_NaN();
  }
}

long double number(double value) {
  return value == std::numbers::pi ? std::numbers::pi_v<long double> : static_cast<long double>(value);
}

}  // namespace

bool is_constant(const Expression& expression) {
  return std::none_of(expression.nodes.begin(), expression.nodes.end(), [](const ExpressionNode& node) {
    return node.kind == Kind::time || node.kind == Kind::coordinate || node.kind == Kind::speed ||
           node.kind == Kind::parameter || node.kind == Kind::input;
  });
}

bool has_finite_constants(const Expression& expression) {
  std::vector<std::optional<long double>> values;
  const auto known = [&values](int index) { return index < 0 || values[static_cast<std::size_t>(index)].has_value(); };
  const auto operand = [&values](int index) { return index < 0 ? 0.0L : *values[static_cast<std::size_t>(index)]; };
  for (const ExpressionNode& node : expression.nodes) {
    std::optional<long double> result;
    if (node.kind == Kind::number)
      result = number(node.value);
    else if (node.a >= 0 && known(node.a) && known(node.b))
      result = combined(node, operand(node.a), operand(node.b));
    if (result && !std::isfinite(*result)) return false;
    values.push_back(result);
  }
  return true;
}

long double value(const Expression& expression, const std::vector<Named>& parameters, long double t) {
  std::vector<long double> values;
  const auto operand = [&values](int index) { return index < 0 ? 0.0L : values[static_cast<std::size_t>(index)]; };
  for (const ExpressionNode& node : expression.nodes) {
    if (node.kind == Kind::number)
      values.push_back(number(node.value));
    else if (node.kind == Kind::time)
      values.push_back(t);
    else if (node.kind == Kind::parameter)
      values.push_back(parameters[static_cast<std::size_t>(node.index)].value);
    else
      values.push_back(combined(node, operand(node.a), operand(node.b)));
  }
  return values.back();
}

}  // namespace kanec::scene
