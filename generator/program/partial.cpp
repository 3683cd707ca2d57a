// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/derivative.hpp"
#include "generator/program/fold.hpp"
#include "generator/program/overloaded.hpp"

namespace kanec::program {
namespace {

// Partial derivatives of functions; `value` is the call itself.
class Partials {
 public:
  Partials(Builder& builder, Index node, int operand) : b_(builder), value_{node, false}, operand_(operand) {}

  Ref operator()(const Constant&) { return number(0); }
  Ref operator()(const Variable&) { return number(0); }
  Ref operator()(const Add&) { return number(1); }
  Ref operator()(const Subtract&) { return number(operand_ == 0 ? 1 : -1); }
  Ref operator()(const Multiply& op) { return ref(operand_ == 0 ? op.b : op.a); }
  Ref operator()(const Divide& op) {
    const Ref reciprocal = fold::is(b_, ref(op.a), 1) ? value_ : fold::quotient(b_, number(1), ref(op.b));
    return operand_ == 0 ? reciprocal : -fold::product(b_, value_, reciprocal);
  }
  Ref operator()(const SquareRoot& op) {
    if (!is_sum_of_squares(op.a)) return fold::quotient(b_, number(0.5), value_);
    return fold::quotient(b_, where_positive(value_, number(0.5), 0), where_positive(value_, value_, 1));
  }
  Ref operator()(const Sine& op) { return fold::cosine(b_, ref(op.a)); }
  Ref operator()(const Cosine& op) { return -fold::sine(b_, ref(op.a)); }
  Ref operator()(const UnaryCall& op) { return of(op.function, ref(op.a)); }
  Ref operator()(const BinaryCall& op) { return of(op.function, ref(op.a), ref(op.b)); }
  Ref operator()(const Select& op) {
    if (operand_ == 2) return number(0);
    return operand_ == 0 ? one_where(ref(op.sign), number(0)) : zero_where(ref(op.sign), number(0));
  }

 private:
  Ref of(Unary function, Ref a) {
    switch (function) {
      case Unary::tan:
        return fold::sum(b_, number(1), square(value_));
      case Unary::tanh:
        return fold::sum(b_, number(1), -square(value_));
      case Unary::asin:
        return fold::quotient(b_, number(1), root_of_one_less(square(a)));
      case Unary::acos:
        return -fold::quotient(b_, number(1), root_of_one_less(square(a)));
      case Unary::exp:
        return value_;
      case Unary::log:
        return fold::quotient(b_, number(1), a);
      case Unary::abs:
        return fold::select(b_, a, number(-1), number(1));
    }
    return {};
  }

  Ref of(Binary function, Ref a, Ref b) {
    switch (function) {
      case Binary::atan2: {
        const Ref square_of_radius = fold::sum(b_, square(a), square(b));
        return fold::quotient(b_, operand_ == 0 ? b : -a, square_of_radius);
      }
      case Binary::min:
        return operand_ == 0 ? zero_where(b, a) : one_where(b, a);
      case Binary::max:
        return operand_ == 0 ? zero_where(a, b) : one_where(a, b);
      case Binary::pow: {
        if (operand_ == 1) return fold::product(b_, value_, fold::call(b_, Unary::log, a));
        const Ref exponent = fold::sum(b_, b, number(-1));
        if (!has_a_limit_at_zero(a, b)) return fold::product(b_, b, fold::call(b_, Binary::pow, a, exponent));
        const Ref power = fold::call(b_, Binary::pow, where_positive(a, a, 1), exponent);
        return fold::product(b_, where_positive(a, b, 0), power);
      }
    }
    return {};
  }

  // Where the length of a vector is zero it has no derivative, but what it is a factor of may, as |v| v: there its
  // rates, 0/0, are 0. Of other roots and powers they are infinite.
  bool is_sum_of_squares(Index at) const {
    return std::visit(Overloaded{[](const Multiply& op) { return op.a == op.b; },
                                 [&](const Add& op) { return is_sum_of_squares(op.a) && is_sum_of_squares(op.b); },
                                 [&](const BinaryCall& op) {
                                   const auto exponent = fold::value(b_, ref(op.b));
                                   return op.function == Binary::pow && exponent && exponent->high == 2;
                                 },
                                 [](const auto&) { return false; }},
                      b_.nodes()[static_cast<std::size_t>(at)]);
  }
  bool has_a_limit_at_zero(Ref a, Ref b) const {
    const auto exponent = fold::value(b_, b);
    return exponent && exponent->high > 0 && exponent->high < 1 && !a.negative && is_sum_of_squares(a.node);
  }
  // `otherwise` where a, which is not negative, is 0.
  Ref where_positive(Ref a, Ref value, double otherwise) { return fold::select(b_, -a, value, number(otherwise)); }

  // 1 and 0, or 0 and 1, where a < b and elsewhere.
  Ref one_where(Ref a, Ref b) { return fold::select(b_, fold::sum(b_, a, -b), number(1), number(0)); }
  Ref zero_where(Ref a, Ref b) { return fold::select(b_, fold::sum(b_, a, -b), number(0), number(1)); }

  static Ref ref(Index node) { return {node, false}; }
  Ref number(double value) { return fold::literal(b_, value); }
  Ref square(Ref a) { return fold::product(b_, a, a); }
  Ref root_of_one_less(Ref a) { return fold::square_root(b_, fold::sum(b_, number(1), -a)); }

  Builder& b_;
  Ref value_;
  int operand_;
};

}  // namespace

Ref partial(Builder& builder, Index node, int operand) {
  const Node op = builder.nodes()[static_cast<std::size_t>(node)];  // a copy: the rule appends
  return std::visit(Partials(builder, node, operand), op);
}

}  // namespace kanec::program
