// A program evaluated in any arithmetic: in 50 digits it tells the rounding error of the emitted code. Not: the emitted
// code itself.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "generator/program/program.hpp"
#include "runtime/base/error.hpp"

namespace kanec::program {

// Arguments of an evaluation in the scalar T; groups that the function does not read may be empty.
template <class T>
struct Arguments {
  std::vector<T> parameters, x, y, ydot, inputs;
  T time = T(0.0);

  const T& operator[](const Variable& v) const {
    if (v.group == Group::time) return time;
    const std::vector<T>* const groups[] = {&parameters, &x, &y, &ydot, &inputs};
    return (*groups[static_cast<std::size_t>(v.group)])[static_cast<std::size_t>(v.index)];
  }
};

namespace detail {

template <class T>
struct Evaluate {
  const Arguments<T>& arguments;
  const std::vector<T>& done;

  const T& of(Index i) const { return done[static_cast<std::size_t>(i)]; }
  T operator()(const Constant& op) const { return T(op.value.rounded()); }  // as it is emitted
  T operator()(const Variable& op) const { return arguments[op]; }
  T operator()(const Add& op) const { return of(op.a) + of(op.b); }
  T operator()(const Subtract& op) const { return of(op.a) - of(op.b); }
  T operator()(const Multiply& op) const { return of(op.a) * of(op.b); }
  T operator()(const Divide& op) const { return of(op.a) / of(op.b); }
  T operator()(const SquareRoot& op) const {
    using std::sqrt;
    return sqrt(of(op.a));
  }
  T operator()(const Sine& op) const {
    using std::sin;
    return sin(of(op.a));
  }
  T operator()(const Cosine& op) const {
    using std::cos;
    return cos(of(op.a));
  }
  T operator()(const UnaryCall& op) const { return call(op.function, of(op.a)); }
  T operator()(const BinaryCall& op) const { return call(op.function, of(op.a), of(op.b)); }
  T operator()(const Select& op) const { return of(op.sign) < T(0.0) ? of(op.a) : of(op.b); }

  static T call(Unary function, const T& a) {
    using std::abs, std::acos, std::asin, std::exp, std::log, std::tan, std::tanh;
    switch (function) {
      case Unary::tan:
        return tan(a);
      case Unary::asin:
        return asin(a);
      case Unary::acos:
        return acos(a);
      case Unary::exp:
        return exp(a);
      case Unary::log:
        return log(a);
      case Unary::abs:
        return abs(a);
      case Unary::tanh:
        return tanh(a);
    }
    throw InternalError("evaluate: no such function");
  }
  static T call(Binary function, const T& a, const T& b) {
    using std::atan2, std::max, std::min, std::pow;
    switch (function) {
      case Binary::atan2:
        return atan2(a, b);
      case Binary::min:
        return min(a, b);
      case Binary::max:
        return max(a, b);
      case Binary::pow:
        return pow(a, b);
    }
    throw InternalError("evaluate: no such function");
  }
};

}  // namespace detail

// The outputs of the function as they stand in `outputs` of the emitted call (n_out of them).
template <class T>
std::vector<T> evaluate(const Program& program, const Function& function, const Arguments<T>& arguments) {
  const std::vector<bool> alive = reachable(program, function.outputs);
  std::vector<T> done(program.nodes.size(), T(0.0));
  const detail::Evaluate<T> operation{arguments, done};
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    if (alive[i]) done[i] = std::visit(operation, program.nodes[i]);
  std::vector<T> results;
  for (const Ref ref : function.outputs) {
    const T& value = done[static_cast<std::size_t>(ref.node)];
    results.push_back(ref.negative ? T(-value) : value);
  }
  if (function.placements.empty()) return results;
  std::vector<T> placed(static_cast<std::size_t>(function.n_out), T(0.0));
  for (const Placement& place : function.placements)
    for (Index i = 0; i < 9; ++i)
      placed[static_cast<std::size_t>(place.offset + i / 3 * function.stride + i % 3)] =
          results[static_cast<std::size_t>(9 * place.block + i)];
  return placed;
}

}  // namespace kanec::program
