// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/data.hpp"

#include "runtime/base/error.hpp"

namespace kanec::lower {

using program::Group;
using scene::Call;
using scene::ExpressionNode;
using symbolic::Role;

Block Data::of(const symbolic::Symbol& symbol) {
  switch (symbol.role) {
    case Role::x:
      return state(Group::x, symbol);
    case Role::y:
      return state(Group::y, symbol);
    case Role::ydot:
      return state(Group::ydot, symbol);
    case Role::quantity:
      throw InternalError("lower: a quantity without a value");
    case Role::numbers:
      break;
  }
  const int n = static_cast<int>(symbol.numbers.size());
  Block result{n == 9 ? 3 : n, n == 9 ? 3 : 1, {}};
  for (std::size_t i = 0; i < symbol.numbers.size(); ++i) result.entries[i] = value(symbol.numbers[i]);
  return result;
}

Block Data::state(Group group, const symbolic::Symbol& symbol) {
  const bool is_scalar = symbolic::shape_of(symbol.atom) == symbolic::Shape::scalar;
  if (is_scalar) return scalar(builder_.variable(group, symbol.at));
  return vector(builder_.variable(group, symbol.at), builder_.variable(group, symbol.at + 1),
                builder_.variable(group, symbol.at + 2));
}

Ref Data::value(const scene::Number& number) {
  switch (number.kind) {
    case scene::Number::Kind::parameter:
      return builder_.variable(Group::parameter, number.index);
    case scene::Number::Kind::input:
      return builder_.variable(Group::input, number.index);
    case scene::Number::Kind::expression:
      return expression(number.index, 0);
    case scene::Number::Kind::constant:
      break;
  }
  return builder_.constant(number.value);
}

Ref Data::expression(int index, int order) {
  const auto at = static_cast<std::size_t>(index);
  if (expressions_.size() <= at) expressions_.resize(at + 1);
  std::vector<Ref>& known = expressions_[at];
  if (known.empty()) known.push_back(value(scene_.expressions[at]));
  while (static_cast<int>(known.size()) <= order) known.push_back(rate(known.back()));
  return known[static_cast<std::size_t>(order)];
}

Ref Data::rate(Ref of) {
  program::Tangents tangents(builder_);
  tangents.seed(program::Variable{Group::time, 0}, builder_.constant(1.0));
  return tangents.of(of);
}

Ref Data::value(const scene::Expression& expression) {
  std::vector<Ref> values;
  for (const ExpressionNode& node : expression.nodes) {
    const auto operand = [&](int at) { return at < 0 ? Ref{} : values[static_cast<std::size_t>(at)]; };
    values.push_back(value(node, operand(node.a), operand(node.b)));
  }
  return values.back();
}

Ref Data::value(const ExpressionNode& node, Ref a, Ref b) {
  switch (node.kind) {
    case ExpressionNode::Kind::number:
      return builder_.constant(node.value);
    case ExpressionNode::Kind::time:
      return builder_.variable(Group::time, 0);
    case ExpressionNode::Kind::coordinate:
      return builder_.variable(Group::x, node.index);
    case ExpressionNode::Kind::speed:
      return builder_.variable(Group::y, node.index);
    case ExpressionNode::Kind::parameter:
      return builder_.variable(Group::parameter, node.index);
    case ExpressionNode::Kind::input:
      return builder_.variable(Group::input, node.index);
    case ExpressionNode::Kind::negate:
      return -a;
    case ExpressionNode::Kind::add:
      return builder_.add(a, b);
    case ExpressionNode::Kind::subtract:
      return builder_.subtract(a, b);
    case ExpressionNode::Kind::multiply:
      return builder_.multiply(a, b);
    case ExpressionNode::Kind::divide:
      return builder_.divide(a, b);
    case ExpressionNode::Kind::call:
      break;
  }
  return call(node.call, a, b);
}

Ref Data::call(Call function, Ref a, Ref b) {
  using program::Binary;
  using program::Unary;
  switch (function) {
    case Call::sin:
      return builder_.sine(a);
    case Call::cos:
      return builder_.cosine(a);
    case Call::tan:
      return builder_.call(Unary::tan, a);
    case Call::asin:
      return builder_.call(Unary::asin, a);
    case Call::acos:
      return builder_.call(Unary::acos, a);
    case Call::atan2:
      return builder_.call(Binary::atan2, a, b);
    case Call::sqrt:
      return builder_.square_root(a);
    case Call::exp:
      return builder_.call(Unary::exp, a);
    case Call::log:
      return builder_.call(Unary::log, a);
    case Call::abs:
      return builder_.call(Unary::abs, a);
    case Call::min:
      return builder_.call(Binary::min, a, b);
    case Call::max:
      return builder_.call(Binary::max, a, b);
    case Call::pow:
      return builder_.call(Binary::pow, a, b);
    case Call::tanh:
      return builder_.call(Unary::tanh, a);
  }
  throw InternalError("lower: a call of no known function");
}

}  // namespace kanec::lower
