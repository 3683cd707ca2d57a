// The norm of Euler parameters: how far off it is, and its restoration. Not: when to restore it (the steppers decide).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <span>

#include "runtime/lanes/rk4_step.hpp"

namespace kanec::integrate {

// The larger of two magnitudes; once one is NaN it stays NaN, so that a comparison can hide nothing.
inline double worse(double a, double b) noexcept { return a >= b || std::isnan(a) ? a : b; }

// |ε| of one set of Euler parameters (4).
inline double norm(const double* eps) noexcept {
  return std::sqrt(eps[0] * eps[0] + eps[1] * eps[1] + eps[2] * eps[2] + eps[3] * eps[3]);
}

// Worst | |ε| - 1 | of the sets that begin at `attitudes` of z.
inline double norm_error(const double* z, std::span<const int> attitudes) noexcept {
  double worst = 0.0;
  for (const int at : attitudes) worst = worse(worst, std::fabs(norm(z + at) - 1.0));
  return worst;
}

// Projects each of them to unit norm, which is the nearest point; returns the worst | |ε| - 1 | before.
inline double normalise(double* z, std::span<const int> attitudes) noexcept {
  double worst = 0.0;
  for (const int at : attitudes) {
    const double length = kanec::normalise(z + at);
    worst = worse(worst, std::fabs(length - 1.0));
  }
  return worst;
}

}  // namespace kanec::integrate
