// Rotations, partial velocities and their rates. Oracles: differentiation (dual numbers, finite differences) and the
// source's six-body table.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <cmath>
#include <utility>

#include "tests/generic/sample.hpp"

namespace kanec::generic {
namespace {

Vector positions(const System<Real>& system, const Vector& x) {
  Vector p(3 * system.n_bodies());
  Eigen::Index at = 0;
  for (const Pose<Real>& pose : system.poses(x)) p.segment<3>(3 * at++) = pose.p;
  return p;
}

System<Dual>::Vector moving_coordinates(const Sample& s) {
  return test::along<Real>(s.x, s.system<Real>().kinematics(s.x, s.y));
}

System<Dual>::Vector moving_speeds(const Sample& s) { return test::along<Real>(s.y, s.ydot); }

TEST(Rotation, quarter_turn_about_the_third_axis_carries_the_first_axis_to_the_second) {
  scene::Scene scene;
  scene.lower = {0};
  scene.bodies.resize(1);
  const System<Real> system(scene, {});
  Vector x = Vector::Zero(7);
  x[2] = x[3] = std::sqrt(0.5L);
  const Matrix3<Real> to_inertial = system.poses(x)[0].R.transpose();
  EXPECT_LT(relative_error(to_inertial * Vector3<Real>::UnitX(), Vector3<Real>::UnitY()), rounding);
}

TEST(Rotation, is_orthonormal_and_right_handed) {
  for (const Sample& s : samples())
    for (const Pose<Real>& pose : s.system<Real>().poses(s.x)) {
      EXPECT_LT(relative_error(pose.R * pose.R.transpose(), Matrix3<Real>::Identity()), rounding);
      EXPECT_GT(pose.R.determinant(), 0);
    }
}

// d(R)/dt = -ω̃ R, for R from inertial to body components.
TEST(Rotation, rate_by_the_kinematical_equations_is_that_of_omega) {
  for (const Sample& s : samples()) {
    const auto moving = s.system<Dual>().poses(moving_coordinates(s));
    const auto poses = s.system<Real>().poses(s.x);
    for (std::size_t k = 0; k < poses.size(); ++k) {
      const Vector3<Real> omega = s.y.segment<3>(3 * static_cast<Eigen::Index>(k));
      Matrix3<Real> expected;
      for (int column = 0; column < 3; ++column) expected.col(column) = -omega.cross(poses[k].R.col(column));
      EXPECT_LT(relative_error(test::rates(moving[k].R), expected), rounding);
    }
  }
}

TEST(Kinematics, keep_the_norm_of_the_euler_parameters) {
  for (const Sample& s : samples()) {
    const Vector xdot = s.system<Real>().kinematics(s.x, s.y);
    for (int k = 0; k < scene::size(s.scene); ++k)
      EXPECT_LT(std::abs(s.x.segment<4>(4 * k).dot(xdot.segment<4>(4 * k))), rounding);
  }
}

// Central difference: its step of 1e-6 leaves 1e-12 of a third derivative that is 10 to 1000 times the velocity (ω up
// to 5, positions up to 10), and 1e-13 of rounding.
TEST(PartialVelocity, times_speeds_is_finite_difference_of_position) {
  for (const Sample& s : samples()) {
    const System<Real> system = s.system<Real>();
    const Vector xdot = system.kinematics(s.x, s.y);
    const Real h = 1e-6L;
    const Vector difference = (positions(system, s.x + h * xdot) - positions(system, s.x - h * xdot)) / (2 * h);
    EXPECT_LT(relative_error(system.partial_velocities(s.x) * s.y, difference), 1e-8);
  }
}

// Body by body, also where a velocity is small by cancellation: ten times the tolerance.
TEST(PartialVelocity, times_speeds_is_rate_of_position) {
  for (const Sample& s : samples()) {
    const auto moving = s.system<Dual>().poses(moving_coordinates(s));
    const Vector v = s.system<Real>().partial_velocities(s.x) * s.y;
    for (std::size_t k = 0; k < moving.size(); ++k)
      EXPECT_LT(relative_error(v.segment<3>(3 * static_cast<Eigen::Index>(k)), test::rates(moving[k].p)),
                10 * rounding);
  }
}

TEST(PartialVelocity, rates_are_the_derivatives_of_the_partial_velocities) {
  for (const Sample& s : samples()) {
    const Matrix expected = test::rates(s.system<Dual>().partial_velocities(moving_coordinates(s)));
    EXPECT_LT(relative_error(s.system<Real>().partial_velocity_rates(s.x, s.y), expected), rounding);
  }
}

TEST(PartialVelocity, and_its_rate_give_the_acceleration_of_the_mass_centre) {
  for (const Sample& s : samples()) {
    const auto x = moving_coordinates(s), y = moving_speeds(s);
    const System<Dual>::Vector v = s.system<Dual>().partial_velocities(x) * y;
    const System<Real> system = s.system<Real>();
    const Vector acceleration = system.partial_velocities(s.x) * s.ydot + system.partial_velocity_rates(s.x, s.y) * s.y;
    EXPECT_LT(relative_error(acceleration, test::rates(v)), rounding);
  }
}

TEST(PartialAngularVelocity, times_speeds_is_omega_and_its_rate_is_zero) {
  for (const Sample& s : samples()) {
    const System<Real> system = s.system<Real>();
    EXPECT_EQ(Vector(system.partial_angular_velocities() * s.y), Vector(s.y.head(3 * system.n_bodies())));
    const Matrix rate = system.partial_angular_velocity_rates();
    EXPECT_EQ(rate.rows(), 3 * system.n_bodies());
    EXPECT_EQ(rate.cols(), system.n_speeds());
    EXPECT_TRUE(rate.isZero(0));
  }
}

// The source's table for the tree (0,1,2,2,1,5), body by body. A row of the ω part: the block of body J is -R_Jᵀ (q_c +
// s_c)~, or -R_Jᵀ r_J~ where c is 0. A row of the ṡ part: the block of body J is the transpose of the R named after it,
// 0 = identity.
struct SourceRow {
  std::vector<std::pair<int, int>> omega, sdot;
};
const std::vector<SourceRow> source_table = {
    {{{1, 0}}, {{1, 0}}},
    {{{1, 2}, {2, 0}}, {{1, 0}, {2, 1}}},
    {{{1, 2}, {2, 3}, {3, 0}}, {{1, 0}, {2, 1}, {3, 2}}},
    {{{1, 2}, {2, 4}, {4, 0}}, {{1, 0}, {2, 1}, {4, 2}}},
    {{{1, 5}, {5, 0}}, {{1, 0}, {5, 1}}},
    {{{1, 5}, {5, 6}, {6, 0}}, {{1, 0}, {5, 1}, {6, 5}}},
};

Vector3<Real> constant(const scene::Vector& a) { return {a[0].value, a[1].value, a[2].value}; }

Matrix expected_row(const Sample& s, const SourceRow& row) {
  const auto poses = s.system<Real>().poses(s.x);
  const auto body = [&](int k) -> const scene::Body& { return s.scene.bodies[static_cast<std::size_t>(k - 1)]; };
  const auto R_T = [&](int k) -> Matrix3<Real> { return poses[static_cast<std::size_t>(k - 1)].R.transpose(); };
  Matrix expected = Matrix::Zero(3, 36);
  for (const auto& [j, c] : row.omega) {
    const Vector3<Real> arm =
        c == 0 ? constant(body(j).r) : Vector3<Real>(constant(body(c).q) + s.x.segment<3>(24 + 3 * (c - 1)));
    // column by column: -R_Jᵀ (a × e_i)
    for (int i = 0; i < 3; ++i) expected.col(3 * (j - 1) + i) = -R_T(j) * arm.cross(Vector3<Real>::Unit(i));
  }
  for (const auto& [j, below] : row.sdot)
    expected.middleCols<3>(18 + 3 * (j - 1)) = below == 0 ? Matrix3<Real>::Identity().eval() : R_T(below);
  return expected;
}

TEST(PartialVelocity, of_the_six_body_tree_is_the_table_of_the_source) {
  test::Random random(6);
  const Sample s = sample(test::random_scene(random, {0, 1, 2, 2, 1, 5}), random);
  const Matrix v_y = s.system<Real>().partial_velocities(s.x);
  for (int k = 1; k <= 6; ++k) {
    const Matrix expected = expected_row(s, source_table[static_cast<std::size_t>(k - 1)]);
    EXPECT_LT(relative_error(v_y.middleRows<3>(3 * (k - 1)), expected), rounding) << "body " << k;
  }
}

}  // namespace
}  // namespace kanec::generic
