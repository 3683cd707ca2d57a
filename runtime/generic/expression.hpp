// The value of a scene's expression in any scalar. Not: where coordinates and inputs get theirs (system.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>
#include <vector>

#include "generator/scene/expression.hpp"
#include "runtime/base/error.hpp"

namespace kanec::generic {

template <class Real>
Real call(scene::Call function, const Real& a, const Real& b) {
  using std::abs, std::acos, std::asin, std::atan2, std::cos, std::exp, std::log, std::max, std::min, std::pow,
      std::sin, std::sqrt, std::tan, std::tanh;
  switch (function) {
    case scene::Call::sin:
      return sin(a);
    case scene::Call::cos:
      return cos(a);
    case scene::Call::tan:
      return tan(a);
    case scene::Call::asin:
      return asin(a);
    case scene::Call::acos:
      return acos(a);
    case scene::Call::atan2:
      return atan2(a, b);
    case scene::Call::sqrt:
      return sqrt(a);
    case scene::Call::exp:
      return exp(a);
    case scene::Call::log:
      return log(a);
    case scene::Call::abs:
      return abs(a);
    case scene::Call::min:
      return min(a, b);
    case scene::Call::max:
      return max(a, b);
    case scene::Call::pow:
      return pow(a, b);
    case scene::Call::tanh:
      return tanh(a);
  }
  throw InternalError("an expression calls an unknown function");
}

// `leaf(node)` is the value of a time, coordinate, speed, parameter or input.
template <class Real, class Leaf>
Real value_of(const scene::Expression& expression, const Leaf& leaf) {
  using Kind = scene::ExpressionNode::Kind;
  std::vector<Real> values;
  const auto at = [&](int node) -> Real { return node < 0 ? Real(0) : values[static_cast<std::size_t>(node)]; };
  for (const scene::ExpressionNode& node : expression.nodes) {
    switch (node.kind) {
      case Kind::number:
        values.push_back(Real(node.value));
        break;
      case Kind::negate:
        values.push_back(-at(node.a));
        break;
      case Kind::add:
        values.push_back(at(node.a) + at(node.b));
        break;
      case Kind::subtract:
        values.push_back(at(node.a) - at(node.b));
        break;
      case Kind::multiply:
        values.push_back(at(node.a) * at(node.b));
        break;
      case Kind::divide:
        values.push_back(at(node.a) / at(node.b));
        break;
      case Kind::call:
        values.push_back(call(node.call, at(node.a), at(node.b)));
        break;
      default:
        values.push_back(leaf(node));
    }
  }
  return values.back();
}

}  // namespace kanec::generic
