// The norm of Euler parameters: how far off it is, and its restoration. Not: when to restore it (the steppers decide).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace kanec::integrate {

// The larger of two magnitudes; once one is NaN it stays NaN, so that a comparison can hide nothing.
inline double worse(double a, double b) noexcept { return a >= b || std::isnan(a) ? a : b; }

// |ε| of one body (4).
inline double norm(const double* eps) noexcept {
  return std::sqrt(eps[0] * eps[0] + eps[1] * eps[1] + eps[2] * eps[2] + eps[3] * eps[3]);
}

// Worst | |ε_K| - 1 | of n_bodies sets of Euler parameters (4 n_bodies).
inline double norm_error(const double* eps, int n_bodies) noexcept {
  double worst = 0.0;
  for (int k = 0; k < n_bodies; ++k) worst = worse(worst, std::fabs(norm(eps + 4 * k) - 1.0));
  return worst;
}

// Projects every ε_K to unit norm, which is the nearest point; returns the worst | |ε_K| - 1 | before.
inline double normalise(double* eps, int n_bodies) noexcept {
  double worst = 0.0;
  for (int k = 0; k < n_bodies; ++k, eps += 4) {
    const double length = norm(eps);
    worst = worse(worst, std::fabs(length - 1.0));
    for (int i = 0; i < 4; ++i) eps[i] /= length;
  }
  return worst;
}

}  // namespace kanec::integrate
