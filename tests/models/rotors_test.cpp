// Shipped spinning bodies. Oracle: steady precession of the heavy symmetric top, and the torque-free motion about the
// intermediate axis (Landau and Lifshitz, Mechanics, 35 and 37).
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "tests/models/motion.hpp"

namespace kanec::test {
namespace {

class Top : public testing::Test {
 protected:
  // A of the top about its fixed point, C about its axis, tilt, precession, spin.
  const double A = 0.0002 + 0.3 * 0.05 * 0.05, C = 0.00025, mgl = 0.3 * 9.81 * 0.05;
  const double cosine = 0.8432, sine = 0.5376, precession = 5.0, omega_3 = 133.7408;
  const double spin = omega_3 - precession * cosine;
  const Model model{shipped_scene("spinning_top"), {"kinematics", "accelerations"}};
};

// A Ω² cos θ - C ω3 Ω + m g l = 0.
TEST_F(Top, numbers_of_the_scene_are_those_of_steady_precession) {
  EXPECT_NEAR(A * precession * precession * cosine + mgl, C * omega_3 * precession, 1e-15);
}

// ω is constant in axes that precess with the top but do not spin: ω̇ in body axes is of the spin alone.
TEST_F(Top, accelerations_are_those_of_steady_precession) {
  const std::vector<double> found = model("accelerations", model.start());
  const double expected = spin * precession * sine;
  EXPECT_NEAR(found[0], expected, 1e-13 * expected);
  EXPECT_NEAR(found[1], 0.0, 1e-13 * expected);
  EXPECT_NEAR(found[2], 0.0, 1e-13 * expected);
}

// The axis keeps its tilt and turns by Ω t. A step of 5e-5 s leaves (ω h)^4 ω t / 120 = 2e-10 of the method.
TEST_F(Top, axis_goes_round_at_a_steady_tilt) {
  const double t = 0.1;
  const auto at = after(model, model.start(), t, 2000);
  const double e1 = at.x[0], e2 = at.x[1], e3 = at.x[2], e4 = at.x[3];
  EXPECT_NEAR(2 * (e1 * e3 + e2 * e4), sine * std::sin(precession * t), 1e-8);
  EXPECT_NEAR(2 * (e2 * e3 - e1 * e4), -sine * std::cos(precession * t), 1e-8);
  EXPECT_NEAR(1 - 2 * (e1 * e1 + e2 * e2), cosine, 1e-8);
}

// Principal moments of both cylinders together, I1 < I2 < I3 along y, x, z; spun about x.
TEST(THandle, turns_over_in_the_time_of_the_closed_form) {
  const double I1 = 1.666e-4, I2 = 3.707e-4, I3 = 5.191e-4;
  const double w1 = 0.01, w2 = 10.0, w3 = 0.01;
  const double energy = I1 * w1 * w1 + I2 * w2 * w2 + I3 * w3 * w3;
  const double H2 = I1 * I1 * w1 * w1 + I2 * I2 * w2 * w2 + I3 * I3 * w3 * w3;
  ASSERT_GT(H2, energy * I2);
  const double tau = std::sqrt((I3 - I2) * (H2 - energy * I1) / (I1 * I2 * I3));
  const double k = std::sqrt((I2 - I1) * (energy * I3 - H2) / ((I3 - I2) * (H2 - energy * I1)));
  const double half_turn = 2 * std::comp_ellint_1(k) / tau;

  const Model model(shipped_scene("t_handle"), {"kinematics", "accelerations"});
  const auto at = after(model, model.start(), half_turn, 8000);
  // ω2 as sn and ω1 as cn change sign after half a period, ω3 as dn does not. The method's error of 5e-10 grows by
  // e^7 on the way.
  EXPECT_NEAR(at.y[0], -w2, 1e-5);
  EXPECT_NEAR(at.y[1], -w1, 1e-5);
  EXPECT_NEAR(at.y[2], w3, 1e-5);
}

// The bar's origin is the mass centre of the whole, which stays where it is.
TEST(THandle, mass_centre_of_both_cylinders_stays) {
  const Model model(shipped_scene("t_handle"), {"kinematics", "accelerations"});
  const auto at = after(model, model.start(), 0.5, 500);
  for (std::size_t i = 4; i < 7; ++i) EXPECT_NEAR(at.x[i], 0.0, 1e-12);
}

}  // namespace
}  // namespace kanec::test
