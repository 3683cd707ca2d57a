// A number and its rate along some direction: any function template evaluated with it is differentiated exactly, chain
// rule by chain rule; a Dual of Duals also twice. Not a finite difference: the rate is as accurate as the value.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

namespace kanec::generic {

template <class Real>
struct Dual;

template <class Real>
inline constexpr bool is_dual = false;
template <class Real>
inline constexpr bool is_dual<Dual<Real>> = true;

// Zero with all its rates, where a == 0 compares values alone.
template <class Real>
bool is_exactly_zero(const Real& a) {
  if constexpr (is_dual<Real>)
    return is_exactly_zero(a.value) && is_exactly_zero(a.rate);
  else
    return a == 0;
}

template <class Real>
struct Dual {
  Real value{}, rate{};

  Dual() = default;
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number> || std::is_same_v<Number, Real>>>
  Dual(const Number& number) : value(static_cast<Real>(number)) {}  // implicit: a constant
  Dual(const Real& value_, const Real& rate_) : value(value_), rate(rate_) {}

  Dual& operator+=(const Dual& b) { return *this = *this + b; }
  Dual& operator-=(const Dual& b) { return *this = *this - b; }
  Dual& operator*=(const Dual& b) { return *this = *this * b; }
  Dual& operator/=(const Dual& b) { return *this = *this / b; }

  friend Dual operator-(const Dual& a) { return {-a.value, -a.rate}; }
  friend Dual operator+(const Dual& a, const Dual& b) { return {a.value + b.value, a.rate + b.rate}; }
  friend Dual operator-(const Dual& a, const Dual& b) { return {a.value - b.value, a.rate - b.rate}; }
  friend Dual operator*(const Dual& a, const Dual& b) {
    return {a.value * b.value, a.rate * b.value + a.value * b.rate};
  }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const Real quotient = a.value / b.value;
    return {quotient, (a.rate - quotient * b.rate) / b.value};
  }

  // A value of zero that changes is not zero: solvers skip what is.
  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value && a.rate == b.rate; }
  friend bool operator!=(const Dual& a, const Dual& b) { return !(a == b); }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }

  friend Dual abs(const Dual& a) { return a.value < Real(0) ? -a : a; }
  friend Dual min(const Dual& a, const Dual& b) { return b.value < a.value ? b : a; }
  friend Dual max(const Dual& a, const Dual& b) { return a.value < b.value ? b : a; }

  friend Dual sqrt(const Dual& a) {
    using std::sqrt;
    const Real root = sqrt(a.value);
    if (is_exactly_zero(a.rate)) return {root, Real(0)};  // also of a length that is 0
    return {root, a.rate / (Real(2) * root)};
  }
  friend Dual exp(const Dual& a) {
    using std::exp;
    const Real power = exp(a.value);
    return {power, power * a.rate};
  }
  friend Dual log(const Dual& a) {
    using std::log;
    return {log(a.value), a.rate / a.value};
  }
  friend Dual sin(const Dual& a) {
    using std::cos, std::sin;
    return {sin(a.value), cos(a.value) * a.rate};
  }
  friend Dual cos(const Dual& a) {
    using std::cos, std::sin;
    return {cos(a.value), -sin(a.value) * a.rate};
  }
  friend Dual tan(const Dual& a) {
    using std::tan;
    const Real tangent = tan(a.value);
    return {tangent, (Real(1) + tangent * tangent) * a.rate};
  }
  friend Dual tanh(const Dual& a) {
    using std::tanh;
    const Real tangent = tanh(a.value);
    return {tangent, (Real(1) - tangent * tangent) * a.rate};
  }
  friend Dual asin(const Dual& a) {
    using std::asin, std::sqrt;
    return {asin(a.value), a.rate / sqrt(Real(1) - a.value * a.value)};
  }
  friend Dual acos(const Dual& a) {
    using std::acos, std::sqrt;
    return {acos(a.value), -a.rate / sqrt(Real(1) - a.value * a.value)};
  }
  friend Dual atan2(const Dual& a, const Dual& b) {
    using std::atan2;
    return {atan2(a.value, b.value), (a.rate * b.value - a.value * b.rate) / (a.value * a.value + b.value * b.value)};
  }
  // A constant exponent allows any base that real powers allow; a variable one needs a positive base.
  friend Dual pow(const Dual& a, const Dual& b) {
    using std::log, std::pow;
    const Real power = pow(a.value, b.value);
    Real slope(0);
    if (!is_exactly_zero(a.rate) && !is_exactly_zero(b.value))
      slope += b.value * pow(a.value, b.value - Real(1)) * a.rate;
    if (!is_exactly_zero(b.rate)) slope += power * log(a.value) * b.rate;
    return {power, slope};
  }
};

}  // namespace kanec::generic

template <class Number>
struct Eigen::NumTraits<kanec::generic::Dual<Number>> : Eigen::NumTraits<Number> {
  using Real = kanec::generic::Dual<Number>;
  using NonInteger = Real;
  using Literal = Real;
  using Nested = Real;
  enum { RequireInitialization = 1 };
};
