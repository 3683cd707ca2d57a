// Motions of the single body that are known in closed form. Not: their integration.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <vector>

namespace kanec::integrate::test {

struct State {
  std::vector<double> x, y;
};

using Quaternion = std::array<double, 4>;  // Euler parameters, scalar last

// Hamilton's product: the rotation p after q, both taking body to inertial.
inline Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p[3] * q[0] + p[0] * q[3] + p[1] * q[2] - p[2] * q[1], p[3] * q[1] - p[0] * q[2] + p[1] * q[3] + p[2] * q[0],
          p[3] * q[2] + p[0] * q[1] - p[1] * q[0] + p[2] * q[3], p[3] * q[3] - p[0] * q[0] - p[1] * q[1] - p[2] * q[2]};
}

inline Quaternion rotation(double angle, const std::array<double, 3>& axis) {
  const double length = std::hypot(axis[0], axis[1], axis[2]), s = std::sin(angle / 2) / length;
  return {s * axis[0], s * axis[1], s * axis[2], std::cos(angle / 2)};
}

// Torque-free motion of an axisymmetric body, I = diag(A, A, C), body and inertial axes aligned at t = 0, drifting at a
// constant velocity. ω turns about the third body axis at (C - A)/A ω_3; the body precesses about its angular momentum
// h at |h|/A and spins at ω_3 (A - C)/A (Goldstein, Classical Mechanics, 3rd ed., section 5.6).
inline State precession(double t) {
  constexpr double A = 3.0, C = 1.5;
  const std::array<double, 3> omega = {1.1, -0.4, 2.0}, h = {A * omega[0], A * omega[1], C * omega[2]};
  const double turn = (C - A) / A * omega[2] * t;
  const Quaternion eps = product(rotation(std::hypot(h[0], h[1], h[2]) / A * t, h), rotation(-turn, {0, 0, 1}));
  const double c = std::cos(turn), s = std::sin(turn);
  return {{eps[0], eps[1], eps[2], eps[3], 0.3 + 0.7 * t, -0.2 * t, 1.0 + 0.1 * t},
          {c * omega[0] - s * omega[1], s * omega[0] + c * omega[1], omega[2], 0.7, -0.2, 0.1}};
}

inline double largest_difference(const State& state, const State& expected) {
  double largest = 0.0;
  for (std::size_t i = 0; i < expected.x.size(); ++i)
    largest = std::fmax(largest, std::fabs(state.x[i] - expected.x[i]));
  for (std::size_t i = 0; i < expected.y.size(); ++i)
    largest = std::fmax(largest, std::fabs(state.y[i] - expected.y[i]));
  return largest;
}

}  // namespace kanec::integrate::test
