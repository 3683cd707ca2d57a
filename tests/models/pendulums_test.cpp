// Shipped pendulums and the cart. Oracle: their textbook equations in the plane, and the elliptic integral.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <cmath>

#include "tests/models/motion.hpp"

namespace kanec::test {
namespace {

// A dozen roundings of 1.1e-16 a sum, and 2x2 systems of condition number below 100.
constexpr double pendulum_tolerance = 1e-14;

// A rod about its end: m = 1.2, c = 0.5, I + m c² = 0.4.
const double omega_squared = 1.2 * 9.81 * 0.5 / 0.4;

TEST(Pendulum, frequency_of_small_swings_is_the_known_one) {
  const Model pendulum(shipped_scene("pendulum"), {"mass_matrix", "residual_x"});
  program::Arguments<double> at = pendulum.start();
  at.x = {0.0};
  EXPECT_NEAR(pendulum("residual_x", at)[0] / pendulum("mass_matrix", at)[0], omega_squared, 1e-14 * omega_squared);
}

// T = 4 K(sin(θ0/2)) / ω. A step of T/2000 leaves (ω h)^4/120 = 1e-12 of Runge and Kutta's method.
TEST(Pendulum, period_of_large_swings_is_the_known_one) {
  const Model pendulum(shipped_scene("pendulum"), {"kinematics", "accelerations"});
  const double quarter = std::comp_ellint_1(std::sin(1.0)) / std::sqrt(omega_squared);
  const auto lowest = after(pendulum, pendulum.start(), quarter, 500);
  EXPECT_NEAR(lowest.x[0], 0.0, 1e-10);
  const auto other_side = after(pendulum, lowest, quarter, 500);
  EXPECT_NEAR(other_side.x[0], -2.0, 1e-10);
  EXPECT_NEAR(other_side.y[0], 0.0, 1e-10);
}

// Two rods, absolute angles a and b from the vertical; m2 hangs on the end of m1, whose length is 1.
Eigen::Vector2d double_pendulum(double a, double b, double adot, double bdot) {
  const double m1 = 1.2, c1 = 0.5, I1 = 0.1, m2 = 0.6, c2 = 0.3, I2 = 0.018, l = 1.0, g = 9.81;
  const double coupling = m2 * l * c2 * std::cos(a - b), turning = m2 * l * c2 * std::sin(a - b);
  Eigen::Matrix2d A;
  A << I1 + m1 * c1 * c1 + m2 * l * l, coupling, coupling, I2 + m2 * c2 * c2;
  return A.inverse() * Eigen::Vector2d(-turning * bdot * bdot - (m1 * c1 + m2 * l) * g * std::sin(a),
                                       turning * adot * adot - m2 * c2 * g * std::sin(b));
}

TEST(DoublePendulum, accelerations_are_those_of_the_textbook) {
  const Model model(shipped_scene("double_pendulum"), {"accelerations"});
  Random random(3);
  for (int i = 0; i < 20; ++i) {
    program::Arguments<double> at = model.start();
    at.x = {random.uniform(-3, 3), random.uniform(-3, 3)};
    at.y = {random.uniform(-5, 5), random.uniform(-5, 5)};
    const Eigen::Vector2d expected = double_pendulum(at.x[0], at.x[0] + at.x[1], at.y[0], at.y[0] + at.y[1]);
    const std::vector<double> found = model("accelerations", at);
    const double scale = expected.cwiseAbs().maxCoeff();
    EXPECT_NEAR(found[0], expected[0], 10 * pendulum_tolerance * scale);
    EXPECT_NEAR(found[0] + found[1], expected[1], 10 * pendulum_tolerance * scale);
  }
}

// The angle is from the upright, θ first in the state; F is all that acts on the cart along its rail.
Eigen::Vector2d cart_pole(double theta, double thetadot, double F) {
  const double M = 1.0, m = 0.1, l = 0.5, I = 0.1 / 12, g = 9.8;
  Eigen::Matrix2d A;
  A << I + m * l * l, m * l * std::cos(theta), m * l * std::cos(theta), M + m;
  return A.inverse() * Eigen::Vector2d(m * g * l * std::sin(theta), m * l * thetadot * thetadot * std::sin(theta) + F);
}

TEST(CartPole, accelerations_are_those_of_the_textbook) {
  const Model model(shipped_scene("cart_pole"), {"accelerations"});
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    program::Arguments<double> at = model.start();
    at.x = {random.uniform(-3, 3), random.uniform(-1, 1)};
    at.y = {random.uniform(-5, 5), random.uniform(-0.02, 0.02)};
    at.inputs = {random.uniform(-10, 10)};
    const Eigen::Vector2d expected = cart_pole(at.x[0], at.y[0], at.inputs[0] - 0.05 * std::tanh(at.y[1] / 0.01));
    const std::vector<double> found = model("accelerations", at);
    for (int j = 0; j < 2; ++j)
      EXPECT_NEAR(found[static_cast<std::size_t>(j)], expected[j],
                  10 * pendulum_tolerance * expected.cwiseAbs().maxCoeff());
  }
}

// About the upright: θ̈ = (M + m) g / ((M + m)(I/(m l) + l) - m l) θ, the pole of the linearised model.
TEST(CartPole, upright_pole_falls_at_the_known_rate) {
  const Model model(shipped_scene("cart_pole"), {"accelerations_x"});
  program::Arguments<double> at = model.start();
  at.x = {0.0, 0.0};
  const double M = 1.0, m = 0.1, l = 0.5, I = 0.1 / 12, g = 9.8;
  const double expected = (M + m) * g / ((M + m) * (I / (m * l) + l) - m * l);
  EXPECT_NEAR(model("accelerations_x", at)[0], expected, 10 * pendulum_tolerance * expected);
}

}  // namespace
}  // namespace kanec::test
