// Jacobians of residual and accelerations. Oracles: central differences, with attitudes turned by rotations; the
// implicit function theorem.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "generator/read/read.hpp"
#include "tests/generic/sample.hpp"

namespace kanec::generic {
namespace {

// A step of 1e-6 leaves 1e-12 of a third derivative, which may be a thousand times the entries, and 1e-13 of rounding.
constexpr Real step = 1e-6L;
constexpr double of_differences = 1e-8;

std::vector<Sample> small_samples() {
  std::vector<Sample> all = samples(test::everything());
  std::erase_if(all, [](const Sample& s) { return s.y.size() == 0; });
  all.resize(8);
  return all;
}

double error(const Matrix& left, const Matrix& right) {
  return left.size() == 0 ? 0 : double((left - right).norm() / (1 + right.norm()));
}

Matrix difference(const Sample& s, const char* function, Vector Sample::*argument) {
  const Eigen::Index n = (s.*argument).size();
  Matrix out(s(function).size(), n);
  for (Eigen::Index j = 0; j < n; ++j) {
    const Vector direction = step * Vector::Unit(n, j);
    out.col(j) =
        s.with(argument, s.*argument + direction)(function) - s.with(argument, s.*argument - direction)(function);
  }
  return out / (2 * step);
}

// The coordinates after a small motion ξ: attitudes turned by the rotation vector φ in body axes, Rᵀ exp(φ~).
Vector moved(const Sample& s, const Vector& xi) {
  using Quaternion = Eigen::Quaternion<Real>;
  Vector x = s.x;
  const scene::Layout layout(s.scene);
  const auto shift = [&](const std::vector<int>& at, const std::vector<int>& rate_at) {
    for (std::size_t i = 0; i < at.size(); ++i)
      if (at[i] >= 0) x[at[i]] += xi[rate_at[i]];
  };
  for (const scene::BodyLayout& at : layout.bodies) {
    shift(at.theta, at.thetadot);
    shift(at.s, at.sdot);
    if (at.eps < 0) continue;
    const Vector3<Real> phi = xi.segment<3>(at.omega);
    if (phi.norm() == 0) continue;
    const Quaternion turned = Quaternion(x[at.eps + 3], x[at.eps], x[at.eps + 1], x[at.eps + 2]) *
                              Quaternion(Eigen::AngleAxis<Real>(phi.norm(), phi.normalized()));
    x.segment<4>(at.eps) = turned.coeffs();
  }
  return x;
}

Matrix difference_by_xi(const Sample& s, const char* function) {
  const Eigen::Index n = s.y.size();
  Matrix out(n, n);
  for (Eigen::Index j = 0; j < n; ++j)
    out.col(j) = s.with(&Sample::x, moved(s, step * Vector::Unit(n, j)))(function) -
                 s.with(&Sample::x, moved(s, -step * Vector::Unit(n, j)))(function);
  return out / (2 * step);
}

// Raw Euler parameters leave the unit sphere in these differences, as the formulas allow.
TEST(Derivatives, are_the_limits_of_differences) {
  struct Case {
    const char *function, *derivative;
    Vector Sample::*argument;
  };
  for (const Sample& s : small_samples())
    for (const auto& [function, derivative, argument] :
         {Case{"residual", "residual_x", &Sample::x}, Case{"residual", "residual_y", &Sample::y},
          Case{"residual", "residual_ydot", &Sample::ydot}, Case{"accelerations", "accelerations_x", &Sample::x},
          Case{"accelerations", "accelerations_y", &Sample::y}, Case{"accelerations", "accelerations_u", &Sample::u},
          Case{"kinematics", "kinematics_x", &Sample::x}, Case{"kinematics", "kinematics_y", &Sample::y},
          Case{"power", "power_x", &Sample::x}, Case{"power", "power_y", &Sample::y}}) {
      const Matrix expected = difference(s, function, argument);
      EXPECT_LT(error(s.matrix(derivative, expected.rows()), expected), of_differences) << derivative;
    }
}

TEST(Derivatives, by_the_tangent_turn_attitudes_by_rotation_vectors) {
  for (const Sample& s : small_samples()) {
    EXPECT_LT(error(s.matrix("residual_xi", s.y.size()), difference_by_xi(s, "residual")), of_differences);
    EXPECT_LT(error(s.matrix("accelerations_xi", s.y.size()), difference_by_xi(s, "accelerations")), of_differences);
  }
}

TEST(Derivatives, of_the_residual_by_accelerations_is_the_mass_matrix) {
  for (const Sample& s : samples()) EXPECT_LT(relative_error(s("residual_ydot"), s("mass_matrix")), rounding);
}

// r(x, y, ẏ(x, y)) = 0, hence A ∂ẏ/∂x = -∂r/∂x at the accelerations.
TEST(Derivatives, of_accelerations_and_residual_obey_the_implicit_function_theorem) {
  for (const Sample& s : small_samples()) {
    const Sample falling = s.falling();
    const Eigen::Index n = s.y.size();
    const Matrix A = s.matrix("mass_matrix", n);
    for (const std::string by : {"_x", "_y", "_xi"}) {
      const Matrix A_ydot = A * s.matrix("accelerations" + by, n), r = falling.matrix("residual" + by, n);
      EXPECT_LT(error(A_ydot, -r), rounding_of_solve) << by;
    }
  }
}

// Rᵀ' = Rᵀ exp(φ~), so exp(φ~) = R R'ᵀ: its rate between two moving states, divided by their distance.
Matrix attitude_rate_differences(const Sample& s, const scene::BodyLayout& at, int k, const Matrix& xi,
                                 const Matrix& dy) {
  using Rotation = Eigen::Matrix<Real, 3, 3, Eigen::RowMajor>;
  const auto R = [&](const Vector& poses) -> Rotation { return Eigen::Map<const Rotation>(poses.data() + 12 * k); };
  const Rotation here = R(s("poses")), rate = R(s.rate("poses"));
  Matrix out(3, xi.cols());
  for (Eigen::Index j = 0; j < xi.cols(); ++j) {
    Matrix3<Real> sum = Matrix3<Real>::Zero();
    for (const Real sign : {1.0L, -1.0L}) {
      const Sample other =
          s.with(&Sample::x, moved(s, sign * step * xi.col(j))).with(&Sample::y, s.y + sign * step * dy.col(j));
      const Rotation there = R(other("poses")), there_rate = R(other.rate("poses"));
      sum += sign * (rate * there.transpose() + here * there_rate.transpose());
    }
    out.col(j) = Vector3<Real>(sum(2, 1) - sum(1, 2), sum(0, 2) - sum(2, 0), sum(1, 0) - sum(0, 1)) / (4 * step);
  }
  return at.omega < 0 ? Matrix() : out;
}

TEST(StateMatrix, turns_attitude_errors_as_two_motions_part) {
  for (const Sample& s : small_samples()) {
    const Eigen::Index n = s.y.size();
    const Matrix S = s.matrix("state_matrix", 2 * n);
    Matrix xi = Matrix::Zero(n, 2 * n), dy = Matrix::Zero(n, 2 * n);
    xi.leftCols(n).setIdentity();
    dy.rightCols(n).setIdentity();
    const scene::Layout layout(s.scene);
    for (int k = 0; k < scene::size(s.scene); ++k) {
      const scene::BodyLayout& at = layout.bodies[static_cast<std::size_t>(k)];
      if (at.omega < 0) continue;
      EXPECT_LT(error(S.middleRows<3>(at.omega), attitude_rate_differences(s, at, k, xi, dy)), of_differences);
    }
  }
}

TEST(StateMatrix, holds_rates_of_other_coordinates_and_derivatives_of_accelerations) {
  for (const Sample& s : small_samples()) {
    const Eigen::Index n = s.y.size();
    const Matrix S = s.matrix("state_matrix", 2 * n);
    const scene::Layout layout(s.scene);
    EXPECT_EQ(Matrix(S.topRightCorner(n, n)), Matrix::Identity(n, n));
    EXPECT_EQ(Matrix(S.bottomLeftCorner(n, n)), s.matrix("accelerations_xi", n));
    EXPECT_EQ(Matrix(S.bottomRightCorner(n, n)), s.matrix("accelerations_y", n));
    for (const scene::BodyLayout& at : layout.bodies)
      for (const int j : at.thetadot) EXPECT_TRUE(j < 0 || S.row(j).head(n).isZero(0));
  }
}

TEST(InputMatrix, is_the_derivative_of_the_accelerations_below_zeros) {
  for (const Sample& s : small_samples()) {
    const Eigen::Index n = s.y.size();
    if (s.u.size() == 0) continue;
    const Matrix B = s.matrix("input_matrix", 2 * n);
    EXPECT_TRUE(B.topRows(n).isZero(0));
    EXPECT_EQ(Matrix(B.bottomRows(n)), s.matrix("accelerations_u", n));
  }
}

// Two hinges at rest: the forcing is zero, and its derivative is not. Accelerations are then linear in the input.
TEST(Derivatives, at_rest_are_those_of_what_is_zero_there) {
  const scene::Scene scene = scene::parse(R"(name = "hinges"
connection = [0, 1]
[inputs]
u = 0.0
[[body]]
joint = "revolute"
axis = "z"
mass = 1
inertia = [1, 1, 1]
effort = "u"
[[body]]
joint = "revolute"
axis = "z"
mass = 1
inertia = [1, 1, 1]
q = [0.5, 0, 0]
r = [0.5, 0, 0]
)",
                                          "hinges.toml");
  const System<Real> system(scene, {});
  const std::vector<Real> x = {0, 0.7L}, y = {0, 0}, none = {0}, unit = {1};
  const auto by_u = evaluate<Real>(system, "accelerations_u", {0, x, y, {}, none});
  const auto of_unit = evaluate<Real>(system, "accelerations", {0, x, y, {}, unit});
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(double(by_u[i]), double(of_unit[i]), 1e-15);
  EXPECT_GT(std::abs(double(of_unit[1])), 0.1);
}

}  // namespace
}  // namespace kanec::generic
