// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/eigenvalues.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace kanec::scene {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

double largest_entry(const Matrix& a) {
  double largest = 0;
  for (const auto& row : a)
    for (const double entry : row) largest = std::max(largest, std::fabs(entry));
  return largest;
}

// a := Jᵀ a J with J the rotation in the plane (p, q) that makes a[p][q] zero.
void rotate(Matrix& a, std::size_t p, std::size_t q) {
  if (a[p][q] == 0) return;
  // t = tan of the smaller angle that solves t² + 2 τ t - 1 = 0; τ² may overflow to infinity, then t = 0
  const double tau = (a[q][q] - a[p][p]) / (2 * a[p][q]);
  const double t = std::copysign(1.0, tau) / (std::fabs(tau) + std::sqrt(1 + tau * tau));
  const double cosine = 1 / std::sqrt(1 + t * t), sine = t * cosine;
  const std::size_t other = 3 - p - q;
  const double shift = t * a[p][q], left = a[p][other], right = a[q][other];
  a[p][p] -= shift;
  a[q][q] += shift;
  a[p][q] = a[q][p] = 0;
  a[p][other] = a[other][p] = cosine * left - sine * right;
  a[q][other] = a[other][q] = sine * left + cosine * right;
}

}  // namespace

std::array<double, 3> eigenvalues(Matrix a) {
  const double scale = largest_entry(a);
  if (scale == 0) return {0, 0, 0};
  for (auto& row : a)
    for (double& entry : row) entry /= scale;
  // convergence is quadratic: for 3×3, six sweeps reach rounding, the rest is a margin
  for (int sweep = 0; sweep < 12; ++sweep) {
    rotate(a, 0, 1);
    rotate(a, 0, 2);
    rotate(a, 1, 2);
  }
  std::array<double, 3> out = {a[0][0] * scale, a[1][1] * scale, a[2][2] * scale};
  std::sort(out.begin(), out.end());
  return out;
}

}  // namespace kanec::scene
