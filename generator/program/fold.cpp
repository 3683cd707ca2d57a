// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/fold.hpp"

#include <algorithm>
#include <cmath>

#include "generator/program/overloaded.hpp"

namespace kanec::program::fold {
namespace {

// What a chain of folded operations leaves of numbers that cancel, relative to them: some hundred roundings of 2^-106.
constexpr double rounding = 0x1p-98;

bool is(const std::optional<Number>& number, double wanted) { return number && *number == Number(wanted); }

bool is_less(const Number& a, const Number& b) { return (a - b).high < 0; }

// xⁿ for n > 0 by squaring: the fewest products up to n = 8 but for 7.
Ref power(Builder& builder, Ref x, int n) {
  if (n == 1) return x;
  const Ref half = power(builder, x, n / 2);
  const Ref even = product(builder, half, half);
  return n % 2 == 0 ? even : product(builder, even, x);
}

Ref power(Builder& builder, Ref a, Ref b) {
  constexpr double largest = 8;
  const auto exponent = value(builder, b);
  if (is(exponent, 0) || fold::is(builder, a, 1)) return builder.constant(1.0);
  if (is(exponent, 0.5)) return square_root(builder, a);
  const bool is_whole = exponent && exponent->low == 0 && exponent->high == std::trunc(exponent->high);
  if (!is_whole || std::abs(exponent->high) > largest) return builder.call(Binary::pow, a, b);
  const Ref result = power(builder, a, static_cast<int>(std::abs(exponent->high)));
  return exponent->high > 0 ? result : quotient(builder, builder.constant(1.0), result);
}

Ref extremum(Builder& builder, Binary function, Ref a, Ref b) {
  const auto u = value(builder, a);
  const auto v = value(builder, b);
  if (a == b) return a;
  if (u && v) return is_less(*u, *v) == (function == Binary::min) ? a : b;
  return builder.call(function, a, b);
}

}  // namespace

std::optional<Number> value(const Builder& builder, Ref ref) {
  const auto* constant = std::get_if<Constant>(&builder.nodes()[static_cast<std::size_t>(ref.node)]);
  if (constant == nullptr) return std::nullopt;
  return ref.negative ? -constant->value : constant->value;
}

bool is(const Builder& builder, Ref ref, double wanted) { return is(value(builder, ref), wanted); }

Ref literal(Builder& builder, const Number& exact) {
  const bool is_double = std::abs(exact.low) <= rounding * std::abs(exact.high);
  const Number number = is_double ? Number(exact.high) : exact;
  return number.high < 0 ? -builder.constant(-number) : builder.constant(number);
}

Ref sum(Builder& builder, Ref a, Ref b) {
  const auto u = value(builder, a);
  const auto v = value(builder, b);
  if (u && v) {
    const Number both = *u + *v;
    const bool cancels = std::abs(both.high) <= rounding * std::max(std::abs(u->high), std::abs(v->high));
    return literal(builder, cancels ? Number(0.0) : both);
  }
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

Ref square_root(Builder& builder, Ref a) { return is(builder, a, 0) || is(builder, a, 1) ? a : builder.square_root(a); }

Ref sine(Builder& builder, Ref a) { return is(builder, a, 0) ? a : builder.sine(a); }

Ref cosine(Builder& builder, Ref a) { return is(builder, a, 0) ? builder.constant(1.0) : builder.cosine(a); }

Ref call(Builder& builder, Unary function, Ref a) {
  const auto u = value(builder, a);
  switch (function) {
    case Unary::tan:
    case Unary::asin:
    case Unary::tanh:
      if (is(u, 0)) return a;
      break;
    case Unary::exp:
      if (is(u, 0)) return builder.constant(1.0);
      break;
    case Unary::acos:
    case Unary::log:
      if (is(u, 1)) return builder.constant(0.0);
      break;
    case Unary::abs:
      if (u) return builder.constant(u->high < 0 ? -*u : *u);
      break;
  }
  return builder.call(function, a);
}

Ref call(Builder& builder, Binary function, Ref a, Ref b) {
  if (function == Binary::pow) return power(builder, a, b);
  if (function != Binary::atan2) return extremum(builder, function, a, b);
  const auto v = value(builder, b);
  return is(builder, a, 0) && v && v->high > 0 ? a : builder.call(function, a, b);
}

Ref select(Builder& builder, Ref sign, Ref a, Ref b) {
  if (a == b) return a;
  if (const auto known = value(builder, sign)) return known->high < 0 ? a : b;
  return builder.select(sign, a, b);
}

Ref again(Builder& builder, const Node& node, const Refs& operands) {
  const Ref a = operands[0], b = operands[1], sign = operands[2];
  return std::visit(Overloaded{
                        [&](const Constant& op) { return literal(builder, op.value); },
                        [&](const Variable& op) { return builder.variable(op.group, op.index); },
                        [&](const Add&) { return sum(builder, a, b); },
                        [&](const Subtract&) { return sum(builder, a, -b); },
                        [&](const Multiply&) { return product(builder, a, b); },
                        [&](const Divide&) { return quotient(builder, a, b); },
                        [&](const SquareRoot&) { return square_root(builder, a); },
                        [&](const Sine&) { return sine(builder, a); },
                        [&](const Cosine&) { return cosine(builder, a); },
                        [&](const UnaryCall& op) { return call(builder, op.function, a); },
                        [&](const BinaryCall& op) { return call(builder, op.function, a, b); },
                        [&](const Select&) { return select(builder, sign, a, b); },
                    },
                    node);
}

}  // namespace kanec::program::fold
