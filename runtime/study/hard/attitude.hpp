// Attitudes of rows in long double. Not: the angle between two (runtime/verify/attitude_angle.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <span>

#include "runtime/study/hard/elliptic.hpp"

namespace kanec::hard {

using Vector = Eigen::Matrix<Real, 3, 1>;
using Matrix = Eigen::Matrix<Real, 3, 3>;

// Three numbers of x or y from `at` on.
inline Vector vector(std::span<const double> values, int at) {
  const auto i = static_cast<std::size_t>(at);
  return {values[i], values[i + 1], values[i + 2]};
}

// Body components to inertial ones, from Euler parameters that begin at `at` of x.
inline Matrix attitude(std::span<const double> x, int at) {
  const auto i = static_cast<std::size_t>(at);
  return Eigen::Quaternion<Real>(x[i + 3], x[i], x[i + 1], x[i + 2]).normalized().toRotationMatrix();
}

}  // namespace kanec::hard
