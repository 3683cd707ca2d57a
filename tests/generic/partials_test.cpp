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

// R of each body (inertial to body components), and the mass centres (3N), from `poses`.
Matrix3<Real> rotation(const Vector& poses, int k) {
  return Eigen::Map<const Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>>(poses.data() + 12 * (k - 1));
}
Vector positions(const Vector& poses) {
  Vector p(poses.size() / 4);
  for (Eigen::Index k = 0; k < p.size() / 3; ++k) p.segment<3>(3 * k) = poses.segment<3>(12 * k + 9);
  return p;
}

// Of the mass centres (3N), by differentiation of their positions.
Vector velocities(const Sample& s) { return positions(s.rate("poses")); }

TEST(Rotation, quarter_turn_about_the_third_axis_carries_the_first_axis_to_the_second) {
  Sample s;
  s.scene.lower = {0};
  s.scene.bodies.resize(1);
  s.x = Vector::Zero(7);
  s.x[2] = s.x[3] = std::sqrt(0.5L);
  const Matrix3<Real> to_inertial = rotation(s("poses"), 1).transpose();
  EXPECT_LT(relative_error(to_inertial * Vector3<Real>::UnitX(), Vector3<Real>::UnitY()), rounding);
}

// Two turns, first about the third axis, then about the carried second one: R^T = Rot(z, a) Rot(y, b) zero.
TEST(Rotation, of_turns_is_the_product_of_the_turns_and_the_zero_attitude) {
  Sample s;
  s.scene.lower = {0};
  s.scene.bodies.resize(1);
  scene::Joint& joint = s.scene.bodies[0].joint;
  joint.ball = false;
  joint.slides.clear();
  joint.turns = {{.axis = {0, 0, 1}}, {.axis = {0, 1, 0}}};
  joint.zero = {{{1, 0, 0}, {0, 0, -1}, {0, 1, 0}}};
  s.x = Vector{{0.3L, -1.1L}};
  const Real a = s.x[0], b = s.x[1];
  Matrix3<Real> first, second, zero;
  first << std::cos(a), -std::sin(a), 0, std::sin(a), std::cos(a), 0, 0, 0, 1;
  second << std::cos(b), 0, std::sin(b), 0, 1, 0, -std::sin(b), 0, std::cos(b);
  zero << 1, 0, 0, 0, 0, -1, 0, 1, 0;
  EXPECT_LT(relative_error(rotation(s("poses"), 1).transpose(), first * second * zero), rounding);
}

TEST(Rotation, is_orthonormal_and_right_handed) {
  for (const Sample& s : samples()) {
    const Vector poses = s("poses");
    for (int k = 1; k <= scene::size(s.scene); ++k) {
      const Matrix3<Real> R = rotation(poses, k);
      EXPECT_LT(relative_error(R * R.transpose(), Matrix3<Real>::Identity()), rounding);
      EXPECT_GT(R.determinant(), 0);
    }
  }
}

// d(R)/dt = -ω̃ R, for R from inertial to body components; ω = ω_y y where nothing is prescribed.
TEST(Rotation, rate_by_the_kinematical_equations_is_that_of_omega) {
  test::RandomSceneOptions options = test::everything();
  options.prescribed_share = 0;
  for (const Sample& s : samples(options)) {
    const Vector poses = s("poses"), moving = s.rate("poses");
    const Vector omegas = s.matrix("partial_angular_velocities", 3 * scene::size(s.scene)) * s.y;
    for (int k = 1; k <= scene::size(s.scene); ++k) {
      const Vector3<Real> omega = omegas.segment<3>(3 * (k - 1));
      Matrix3<Real> expected;
      for (int column = 0; column < 3; ++column) expected.col(column) = -omega.cross(rotation(poses, k).col(column));
      EXPECT_LT((rotation(moving, k) - expected).cwiseAbs().maxCoeff(), rounding * (1 + double(omega.norm())));
    }
  }
}

TEST(Kinematics, keep_the_norm_of_the_euler_parameters) {
  for (const Sample& s : samples()) {
    const Vector xdot = s("kinematics");
    for (const scene::BodyLayout& at : scene::Layout(s.scene).bodies)
      EXPECT_LT(at.eps < 0 ? 0 : std::abs(s.x.segment<4>(at.eps).dot(xdot.segment<4>(at.eps))), rounding);
  }
}

// Central difference: its step of 1e-6 leaves 1e-12 of a third derivative that is 10 to 1000 times the velocity (ω up
// to 5, positions up to 10), and 1e-13 of rounding.
TEST(PartialVelocity, times_speeds_is_finite_difference_of_position) {
  for (const Sample& s : free_samples()) {
    const Vector xdot = s("kinematics");
    const Real h = 1e-6L;
    const Vector ahead = positions(s.with(&Sample::x, s.x + h * xdot)("poses"));
    const Vector behind = positions(s.with(&Sample::x, s.x - h * xdot)("poses"));
    const Matrix v_y = s.matrix("partial_velocities", ahead.size());
    EXPECT_LT(relative_error(v_y * s.y, (ahead - behind) / (2 * h)), 1e-8);
  }
}

// Speed by speed: a velocity is affine in y, so its difference between y = e_j and y = 0 is the column.
TEST(PartialVelocity, is_the_derivative_of_the_velocity) {
  for (const Sample& s : samples()) {
    const Eigen::Index n = s.y.size();
    const Vector at_rest = velocities(s.with(&Sample::y, Vector::Zero(n)));
    const Matrix v_y = s.matrix("partial_velocities", at_rest.size());
    for (Eigen::Index j = 0; j < n; ++j) {
      const Vector velocity = velocities(s.with(&Sample::y, Vector::Unit(n, j)));
      EXPECT_LT((velocity - at_rest - v_y.col(j)).cwiseAbs().maxCoeff(), 100 * rounding);  // positions up to 10
    }
  }
}

TEST(PartialVelocity, rates_are_the_derivatives_of_the_partial_velocities) {
  for (const Sample& s : samples()) {
    for (const auto& [function, rates] : {std::pair("partial_velocities", "partial_velocity_rates"),
                                          std::pair("partial_angular_velocities", "partial_angular_velocity_rates")}) {
      const Vector expected = s.rate(function), rate = s(rates);
      EXPECT_LT(((rate - expected).cwiseAbs().maxCoeff()), 10 * rounding * (1 + double(expected.norm()))) << function;
    }
  }
}

// Of points fixed in bodies, also while coordinates are prescribed.
TEST(Point, velocity_and_acceleration_are_the_rates_of_position_and_velocity) {
  for (const Sample& s : samples(test::everything()))
    for (const std::string point : {"point_1", "point_2"}) {
      const Vector velocity = s.rate(point + "_position"), acceleration = s.rate(point + "_velocity");
      EXPECT_LT((s(point + "_velocity") - velocity).norm(), 10 * rounding * (1 + velocity.norm()));
      EXPECT_LT((s(point + "_acceleration") - acceleration).norm(), 10 * rounding * (1 + acceleration.norm()));
    }
}

// v(y) = v(0) + J y.
TEST(Point, jacobian_is_the_derivative_of_its_velocity) {
  for (const Sample& s : samples(test::everything())) {
    const Vector at_rest = s.with(&Sample::y, Vector::Zero(s.y.size()))("point_1_velocity");
    const Vector velocity = s("point_1_velocity");
    EXPECT_LT((at_rest + s.matrix("point_1_jacobian", 3) * s.y - velocity).norm(),
              10 * rounding * (1 + velocity.norm()));
  }
}

TEST(PartialAngularVelocity, of_free_joints_picks_omega_and_its_rate_is_zero) {
  for (const Sample& s : free_samples()) {
    const Eigen::Index rows = 3 * scene::size(s.scene);
    EXPECT_EQ(Vector(s.matrix("partial_angular_velocities", rows) * s.y), Vector(s.y.head(rows)));
    const Matrix rate = s.matrix("partial_angular_velocity_rates", rows);
    EXPECT_EQ(rate.cols(), s.y.size());
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

Matrix expected_row(const Sample& s, const SourceRow& row) {
  const Vector poses = s("poses");
  const auto body = [&](int k) -> const scene::Body& { return s.scene.bodies[static_cast<std::size_t>(k - 1)]; };
  const auto R_T = [&](int k) -> Matrix3<Real> { return rotation(poses, k).transpose(); };
  Matrix expected = Matrix::Zero(3, 36);
  for (const auto& [j, c] : row.omega) {
    const Vector3<Real> arm =
        c == 0 ? values(s, body(j).r) : Vector3<Real>(values(s, body(c).q) + s.x.segment<3>(24 + 3 * (c - 1)));
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
  const Matrix v_y = s.matrix("partial_velocities", 18);
  for (int k = 1; k <= 6; ++k) {
    const Matrix expected = expected_row(s, source_table[static_cast<std::size_t>(k - 1)]);
    EXPECT_LT(relative_error(v_y.middleRows<3>(3 * (k - 1)), expected), rounding) << "body " << k;
  }
}

}  // namespace
}  // namespace kanec::generic
