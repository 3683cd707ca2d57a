// Oracle: the angle that a rotation was made of.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/verify/attitude_angle.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <numbers>

namespace kanec::test {
namespace {

using Matrix = Eigen::Matrix<long double, 3, 3>;
using Vector = Eigen::Matrix<long double, 3, 1>;

Matrix turned(long double angle, const Vector& axis) {
  return Eigen::AngleAxis<long double>(angle, axis.normalized()).toRotationMatrix();
}

// A hundred roundings of long double.
TEST(AttitudeAngle, has_all_digits_however_small_or_near_half_a_turn) {
  constexpr long double pi = std::numbers::pi_v<long double>;
  const Matrix from = turned(0.7L, {1, -1, 2});
  for (const long double angle : {0.0L, 1e-15L, 1e-6L, 1.0L, 3.0L, pi - 1e-6L, pi - 1e-12L, pi})
    EXPECT_NEAR(static_cast<double>(attitude_angle(from, from * turned(angle, {1, 2, 2})) - angle), 0.0, 1e-17);
}

}  // namespace
}  // namespace kanec::test
