// The numbers of a scene: folded into the code, or given at run time. Not: where they stand.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

namespace kanec::scene {

// A physical number: folded into the code, or a field of the parameter struct, or (loads only) of the input struct, or
// (loads only) an expression.
struct Number {
  enum class Kind { constant, parameter, input, expression };
  Kind kind = Kind::constant;
  double value = 0.0;  // of a constant
  int index = 0;       // into Scene::parameters, Scene::inputs or Scene::expressions

  static Number constant(double value) { return {Kind::constant, value, 0}; }
  static Number parameter(int index) { return {Kind::parameter, 0.0, index}; }
  static Number input(int index) { return {Kind::input, 0.0, index}; }
  static Number expression(int index) { return {Kind::expression, 0.0, index}; }
  bool is_zero() const { return kind == Kind::constant && value == 0.0; }
  bool operator==(const Number&) const = default;
};

using Vector = std::array<Number, 3>;

inline bool is_zero(const Vector& v) { return v[0].is_zero() && v[1].is_zero() && v[2].is_zero(); }

// Symmetric 3×3 by its six entries.
struct Symmetric {
  Number xx, yy, zz, xy, xz, yz;
};

}  // namespace kanec::scene
