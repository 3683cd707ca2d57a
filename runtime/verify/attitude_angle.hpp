// The angle between two attitudes. Not: attitudes of a motion (report/motion_error.hpp, hard/attitude.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <Eigen/Core>
#include <cmath>

namespace kanec {

// Of the rotation C that takes one to the other [rad]: from its sine, twice which is the vector part of C - Cᵀ, and its
// cosine, so that no angle loses digits, neither a tiny one nor one near π.
inline long double attitude_angle(const Eigen::Matrix<long double, 3, 3>& a,
                                  const Eigen::Matrix<long double, 3, 3>& b) {
  const Eigen::Matrix<long double, 3, 3> C = a.transpose() * b;
  const Eigen::Matrix<long double, 3, 1> twice_sine(C(2, 1) - C(1, 2), C(0, 2) - C(2, 0), C(1, 0) - C(0, 1));
  return std::atan2(twice_sine.norm(), C.trace() - 1.0L);
}

}  // namespace kanec
