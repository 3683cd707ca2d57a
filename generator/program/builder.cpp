// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/builder.hpp"

namespace kanec::program {

Ref Builder::append(const Node& node) {
  nodes_.push_back(node);
  return {static_cast<Index>(nodes_.size()) - 1, false};
}

Ref Builder::add(Ref a, Ref b) {
  if (a.negative && b.negative) return {append(Add{a.node, b.node}).node, true};
  if (a.negative) return append(Subtract{b.node, a.node});
  if (b.negative) return append(Subtract{a.node, b.node});
  return append(Add{a.node, b.node});
}

Index Builder::value_of(Ref a) {
  if (!a.negative) return a.node;
  if (const auto* known = std::get_if<Constant>(&nodes_[static_cast<std::size_t>(a.node)]))
    return constant(-known->value).node;
  return append(Subtract{constant(0.0).node, a.node}).node;
}

Ref Builder::call(Unary function, Ref a) {
  switch (function) {
    case Unary::tan:
    case Unary::asin:
    case Unary::tanh:
      return {append(UnaryCall{function, a.node}).node, a.negative};  // odd
    case Unary::abs:
      return append(UnaryCall{function, a.node});  // even
    case Unary::acos:
    case Unary::exp:
    case Unary::log:
      break;
  }
  return append(UnaryCall{function, value_of(a)});
}

Ref Builder::call(Binary function, Ref a, Ref b) {
  const bool is_extremum = function == Binary::min || function == Binary::max;
  if (is_extremum && a.negative && b.negative)
    return {append(BinaryCall{function == Binary::min ? Binary::max : Binary::min, a.node, b.node}).node, true};
  const bool is_odd = function == Binary::atan2;  // in its first argument
  const Index first = is_odd ? a.node : value_of(a);
  const Index second = value_of(b);
  return {append(BinaryCall{function, first, second}).node, is_odd && a.negative};
}

Ref Builder::select(Ref sign, Ref a, Ref b) {
  const bool negative = a.negative && b.negative;
  if (negative) a = -a, b = -b;
  const Index first = value_of(a);
  const Index second = value_of(b);
  const Index condition = value_of(sign);
  return {append(Select{first, second, condition}).node, negative};
}

}  // namespace kanec::program
