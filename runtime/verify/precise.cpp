// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/verify/precise.hpp"

#include <cln/integer.h>

#include <cmath>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"

namespace kanec {
namespace {

constexpr unsigned digits = 50;

cln::cl_F converted(double value) {
  if (!std::isfinite(value))
    throw InputError("50-digit arithmetic: found " + shortest(value) + "; allowed: finite numbers");
  // mantissa and exponent apart: CLN's own conversion refuses subnormal numbers
  int exponent = 0;
  const double mantissa = std::frexp(value, &exponent);
  return cln::scale_float(cln::cl_float(cln::cl_F(mantissa), cln::float_format(digits)), exponent);
}

constexpr int far_below = -900;  // from here on results are scaled, so that CLN need not make a subnormal number
constexpr int shift = 600;

}  // namespace

Precise::Precise(double value) : value_(converted(value)) {}

Precise operator/(const Precise& a, const Precise& b) {
  if (cln::zerop(b.value_)) throw InputError("50-digit arithmetic: division by zero");
  return Precise(a.value_ / b.value_);
}

Precise sqrt(const Precise& a) {
  if (cln::minusp(a.value_)) throw InputError("50-digit arithmetic: square root of a negative number");
  return Precise(cln::sqrt(a.value_));
}

Precise sin(const Precise& a) { return Precise(cln::sin(a.value_)); }
Precise cos(const Precise& a) { return Precise(cln::cos(a.value_)); }

Precise tan(const Precise& a) { return sin(a) / cos(a); }

// By the arctangent, accurate near ±1 too: 1 - a and 1 + a err in their last digit only.
Precise asin(const Precise& a) { return atan2(a, sqrt((Precise(1.0) - a) * (Precise(1.0) + a))); }
Precise acos(const Precise& a) { return atan2(sqrt((Precise(1.0) - a) * (Precise(1.0) + a)), a); }

Precise atan2(const Precise& a, const Precise& b) {
  if (cln::zerop(a.value_) && cln::zerop(b.value_)) return Precise(0.0);
  return Precise(cln::cl_float(cln::atan(b.value_, a.value_), cln::float_format(digits)));
}

Precise exp(const Precise& a) { return Precise(cln::exp(a.value_)); }

Precise log(const Precise& a) {
  if (!cln::plusp(a.value_)) throw InputError("50-digit arithmetic: logarithm of a number that is not positive");
  return Precise(cln::ln(a.value_));
}

Precise pow(const Precise& a, const Precise& b) {
  const bool is_whole = cln::ffloor(b.value_) == b.value_;
  if (cln::plusp(a.value_)) return exp(b * log(a));
  if (cln::zerop(a.value_) && !cln::minusp(b.value_)) return Precise(cln::zerop(b.value_) ? 1.0 : 0.0);
  if (cln::zerop(a.value_) || !is_whole) throw InputError("50-digit arithmetic: power without a real result");
  const bool is_odd = cln::oddp(cln::floor1(b.value_));
  const Precise size = exp(b * log(-a));
  return is_odd ? -size : size;
}

// 1 in 50 digits from |a| = 60 on, where its terms would only grow.
Precise tanh(const Precise& a) {
  if (a.magnitude() < Precise(60.0)) return Precise(cln::tanh(a.value_));
  return Precise(cln::minusp(a.value_) ? -1.0 : 1.0);
}

double Precise::rounded() const {
  if (cln::zerop(value_) || cln::float_exponent(value_) > far_below) return cln::double_approx(value_);
  return std::ldexp(cln::double_approx(cln::scale_float(value_, shift)), -shift);
}

}  // namespace kanec
