// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/elliptic.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace kanec::hard {
namespace {

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr Real smallest = std::numeric_limits<Real>::epsilon();

constexpr int points = 16;
struct Rule {
  std::array<Real, points> node, weight;
};

// Zeros of the Legendre polynomial by Newton's method, weights 2 / ((1 − x²) P'²).
Rule legendre() {
  Rule rule;
  for (int i = 0; i < points; ++i) {
    Real x = std::cos(pi * (static_cast<Real>(i) + 0.75L) / (points + 0.5L)), slope = 0;
    for (int iteration = 0; iteration < 20; ++iteration) {
      Real before = 1, value = x;
      for (int n = 2; n <= points; ++n) {
        const Real next = ((2 * n - 1) * x * value - (n - 1) * before) / n;
        before = value;
        value = next;
      }
      slope = points * (x * value - before) / (x * x - 1);
      x -= value / slope;
    }
    rule.node[static_cast<std::size_t>(i)] = x;
    rule.weight[static_cast<std::size_t>(i)] = 2 / ((1 - x * x) * slope * slope);
  }
  return rule;
}

}  // namespace

// Arithmetic-geometric means of 1 and k' (Abramowitz and Stegun, 16.4, 17.6).
Elliptic::Elliptic(Real complement) : complement_(complement) {
  Real a = 1, b = std::sqrt(complement), c = std::sqrt(std::max(1 - complement, Real(0)));
  for (;; ++n_) {
    a_[n_] = a;
    c_[n_] = c;
    if (c <= smallest * a || n_ + 1 == most) break;
    const Real mean = (a + b) / 2;
    c = (a - b) / 2;
    b = std::sqrt(a * b);
    a = mean;
  }
  quarter_ = pi / (2 * a_[n_]);
}

Jacobi Elliptic::operator()(Real u) const {
  u = std::remainder(u, 4 * quarter_);
  Real phi = std::ldexp(a_[n_] * u, n_);
  for (int i = n_; i > 0; --i) phi = (phi + std::asin(c_[i] / a_[i] * std::sin(phi))) / 2;
  const Real sn = std::sin(phi), cn = std::cos(phi);
  return {sn, cn, std::sqrt(cn * cn + complement_ * sn * sn)};
}

Real Elliptic::argument(Real sn, Real cn) const {
  const Real length = std::hypot(sn, cn);
  sn /= length;
  cn /= length;
  const Real u = sn * carlson(cn * cn, cn * cn + complement_ * sn * sn, 1);
  return cn >= 0 ? u : std::copysign(2 * quarter_, sn) - u;
}

// Duplication until the arguments agree (Carlson, Numer. Math. 33, 1979), then the series of fifth order.
Real carlson(Real x, Real y, Real z) {
  Real mean = 0, X = 0, Y = 0, Z = 0;
  for (int i = 0; i < 60; ++i) {
    const Real shift = std::sqrt(x * y) + std::sqrt(y * z) + std::sqrt(z * x);
    x = (x + shift) / 4;
    y = (y + shift) / 4;
    z = (z + shift) / 4;
    mean = (x + y + z) / 3;
    X = (mean - x) / mean;
    Y = (mean - y) / mean;
    Z = (mean - z) / mean;
    if (std::max({std::fabs(X), std::fabs(Y), std::fabs(Z)}) < 3e-4L) break;
  }
  const Real e2 = X * Y - Z * Z, e3 = X * Y * Z;
  return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(mean);
}

Real integral(const std::function<Real(Real)>& f, Real a, Real b, Real longest) {
  static const Rule rule = legendre();
  const auto panels = std::max<long>(1, std::lround(std::ceil(std::fabs(b - a) / longest)));
  const Real half = (b - a) / (2 * static_cast<Real>(panels));
  Real sum = 0;
  for (long i = 0; i < panels; ++i) {
    const Real middle = a + half * static_cast<Real>(2 * i + 1);
    for (std::size_t j = 0; j < points; ++j) sum += rule.weight[j] * f(middle + half * rule.node[j]);
  }
  return half * sum;
}

}  // namespace kanec::hard
