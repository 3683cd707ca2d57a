// SPDX-License-Identifier: BSD-3-Clause
#include <optional>

#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

std::optional<Number> value(const Builder& builder, Ref ref) {
  const auto* constant = std::get_if<Constant>(&builder.nodes()[static_cast<std::size_t>(ref.node)]);
  if (constant == nullptr) return std::nullopt;
  return ref.negative ? -constant->value : constant->value;
}

// A constant by its magnitude, so that c and -c are one literal.
Ref literal(Builder& builder, const Number& number) {
  return number.high < 0 ? -builder.constant(-number) : builder.constant(number);
}

bool is(const std::optional<Number>& number, double wanted) { return number && *number == Number(wanted); }

Ref sum(Builder& builder, Ref a, Ref b) {
  const auto u = value(builder, a);
  const auto v = value(builder, b);
  if (u && v) return literal(builder, *u + *v);
  if (is(u, 0)) return b;
  if (is(v, 0)) return a;
  if (a == -b) return builder.constant(0.0);
  return builder.add(a, b);
}

Ref product(Builder& builder, Ref a, Ref b) {
  const auto u = value(builder, a);
  const auto v = value(builder, b);
  if (u && v) return literal(builder, *u * *v);
  if (is(u, 0) || is(v, 0)) return builder.constant(0.0);
  if (is(u, 1)) return b;
  if (is(v, 1)) return a;
  if (is(u, -1)) return -b;
  if (is(v, -1)) return -a;
  return builder.multiply(a, b);
}

Ref quotient(Builder& builder, Ref a, Ref b) {
  const auto u = value(builder, a);
  const auto v = value(builder, b);
  if (is(u, 0)) return a;
  if (v && v->high != 0) return product(builder, a, literal(builder, Number(1.0) / *v));
  return builder.divide(a, b);
}

Ref simplified(Builder& builder, const Node& node, Ref a, Ref b) {
  if (const auto* constant = std::get_if<Constant>(&node)) return literal(builder, constant->value);
  if (std::holds_alternative<Add>(node)) return sum(builder, a, b);
  if (std::holds_alternative<Subtract>(node)) return sum(builder, a, -b);
  if (std::holds_alternative<Multiply>(node)) return product(builder, a, b);
  if (std::holds_alternative<Divide>(node)) return quotient(builder, a, b);
  return same_again(builder, node, a, b);
}

}  // namespace

Program simplify(const Program& program) { return rebuilt(program, simplified); }

}  // namespace kanec::program
