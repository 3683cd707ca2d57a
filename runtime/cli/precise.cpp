// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/precise.hpp"

#include <cmath>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"

namespace kanec::cli {
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

double Precise::rounded() const {
  if (cln::zerop(value_) || cln::float_exponent(value_) > far_below) return cln::double_approx(value_);
  return std::ldexp(cln::double_approx(cln::scale_float(value_, shift)), -shift);
}

}  // namespace kanec::cli
