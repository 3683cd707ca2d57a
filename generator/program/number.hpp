// Constants of a program while they are folded: double-double, about 32 digits, the same on every IEEE machine.
// Not an extended scalar for evaluation. After Dekker (1971) and Knuth, TAOCP vol. 2, 4.2.2.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace kanec::program {

// The unevaluated sum high + low with |low| at most half an ulp of high.
struct Number {
  double high = 0.0;
  double low = 0.0;

  Number() = default;
  Number(double value) : high(value) {}  // NOLINT: a double is a Number

  double rounded() const { return high; }
  bool operator==(const Number&) const = default;
};

inline Number two_sum(double a, double b) {
  Number r(a + b);
  const double part = r.high - a;
  r.low = (a - (r.high - part)) + (b - part);
  return r;
}

inline Number two_product(double a, double b) {
  Number r(a * b);
  r.low = std::fma(a, b, -r.high);
  return r;
}

inline Number operator-(Number a) {
  a.high = -a.high;
  a.low = -a.low;
  return a;
}

inline Number operator+(const Number& a, const Number& b) {
  const Number high = two_sum(a.high, b.high);
  const Number low = two_sum(a.low, b.low);
  const Number partial = two_sum(high.high, high.low + low.high);
  return two_sum(partial.high, partial.low + low.low);
}

inline Number operator-(const Number& a, const Number& b) { return a + -b; }

inline Number operator*(const Number& a, const Number& b) {
  const Number product = two_product(a.high, b.high);
  return two_sum(product.high, product.low + (a.high * b.low + a.low * b.high));
}

// Three quotient digits of one double each.
inline Number operator/(const Number& a, const Number& b) {
  const double first = a.high / b.high;
  const Number rest = a - b * Number(first);
  const double second = rest.high / b.high;
  const double third = (rest - b * Number(second)).high / b.high;
  return Number(first) + Number(second) + Number(third);
}

}  // namespace kanec::program
