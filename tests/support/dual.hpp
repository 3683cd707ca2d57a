// A number and its rate in time: any function template evaluated with it is differentiated exactly, chain rule by chain
// rule. Not a finite difference: the rate is as accurate as the value.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>
#include <type_traits>

namespace kanec::test {

template <class Real>
struct Dual {
  Real value{}, rate{};

  Dual() = default;
  template <class Number, class = std::enable_if_t<std::is_arithmetic_v<Number>>>
  Dual(Number number) : value(static_cast<Real>(number)) {}  // implicit: a constant
  Dual(Real value_, Real rate_) : value(value_), rate(rate_) {}

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
  friend Dual sqrt(const Dual& a) {
    const Real root = std::sqrt(a.value);
    return {root, a.rate / (2 * root)};
  }
  friend Dual abs(const Dual& a) { return a.value < 0 ? -a : a; }

  friend bool operator==(const Dual& a, const Dual& b) { return a.value == b.value; }
  friend bool operator!=(const Dual& a, const Dual& b) { return a.value != b.value; }
  friend bool operator<(const Dual& a, const Dual& b) { return a.value < b.value; }
  friend bool operator>(const Dual& a, const Dual& b) { return a.value > b.value; }
  friend bool operator<=(const Dual& a, const Dual& b) { return a.value <= b.value; }
  friend bool operator>=(const Dual& a, const Dual& b) { return a.value >= b.value; }
};

// Values along a motion: each entry with its rate.
template <class Real>
Eigen::Matrix<Dual<Real>, Eigen::Dynamic, 1> along(const Eigen::Matrix<Real, Eigen::Dynamic, 1>& values,
                                                   const Eigen::Matrix<Real, Eigen::Dynamic, 1>& rates) {
  return values.binaryExpr(rates, [](const Real& value, const Real& rate) { return Dual<Real>(value, rate); });
}

// The rates of an expression in dual numbers.
template <class Derived>
auto rates(const Eigen::MatrixBase<Derived>& a) {
  return a.unaryExpr([](const auto& entry) { return entry.rate; }).eval();
}

}  // namespace kanec::test

template <class Number>
struct Eigen::NumTraits<kanec::test::Dual<Number>> : Eigen::NumTraits<Number> {
  using Real = kanec::test::Dual<Number>;
  using NonInteger = Real;
  using Literal = Real;
  using Nested = Real;
  enum { RequireInitialization = 1 };
};
