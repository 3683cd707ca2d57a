// A real number of 50 decimal digits, by CLN: the scalar in which a program tells the rounding error of its emitted
// code. Not: a type for anything else.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cln/float.h>
#include <cln/real.h>

namespace kanec {

class Precise {
 public:
  // Exactly this number, which must be finite; throws InputError where it is not.
  Precise(double value = 0.0);  // NOLINT: a double is a Precise

  friend Precise operator+(const Precise& a, const Precise& b) { return Precise(a.value_ + b.value_); }
  friend Precise operator-(const Precise& a, const Precise& b) { return Precise(a.value_ - b.value_); }
  friend Precise operator*(const Precise& a, const Precise& b) { return Precise(a.value_ * b.value_); }
  friend Precise operator/(const Precise& a, const Precise& b);  // throws InputError for b = 0
  Precise operator-() const { return Precise(-value_); }

  friend Precise sqrt(const Precise& a);  // throws InputError for a < 0
  friend Precise sin(const Precise& a);
  friend Precise cos(const Precise& a);
  friend Precise tan(const Precise& a);
  friend Precise asin(const Precise& a);  // asin, acos: throw InputError for |a| > 1
  friend Precise acos(const Precise& a);
  friend Precise atan2(const Precise& a, const Precise& b);  // 0 for a = b = 0
  friend Precise exp(const Precise& a);
  friend Precise log(const Precise& a);                    // throws InputError for a ≤ 0
  friend Precise pow(const Precise& a, const Precise& b);  // throws InputError where it is no real number
  friend Precise tanh(const Precise& a);
  friend Precise abs(const Precise& a) { return a.magnitude(); }
  friend bool operator<(const Precise& a, const Precise& b) { return a.value_ < b.value_; }

  Precise magnitude() const { return Precise(cln::abs(value_)); }
  // The nearest double; infinite beyond their range.
  double rounded() const;

 private:
  explicit Precise(const cln::cl_F& value) : value_(value) {}
  cln::cl_F value_;
};

}  // namespace kanec
