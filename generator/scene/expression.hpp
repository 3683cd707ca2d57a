// An expression of time, coordinates, speeds, parameters and inputs, parsed. Not: its text's rules
// (parse_expression.hpp) or its values.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

namespace kanec::scene {

// The closed list of what an expression may call.
enum class Call { sin, cos, tan, asin, acos, atan2, sqrt, exp, log, abs, min, max, pow, tanh };

// One step; operands are earlier nodes of the same expression.
struct ExpressionNode {
  enum class Kind { number, time, coordinate, speed, parameter, input, negate, add, subtract, multiply, divide, call };
  Kind kind = Kind::number;
  double value = 0.0;     // of a number
  int index = 0;          // into x, y, parameters or inputs
  Call call = Call::sin;  // of a call
  int a = -1, b = -1;     // operands
};

// The last node is the value.
struct Expression {
  std::string text;  // as written
  std::vector<ExpressionNode> nodes;
};

// How many arguments a call takes: 1 or 2.
inline int n_arguments(Call call) {
  return call == Call::atan2 || call == Call::min || call == Call::max || call == Call::pow ? 2 : 1;
}

}  // namespace kanec::scene
