// The shipped chain of springs. Oracle: its normal modes.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <numbers>

#include "tests/models/motion.hpp"

namespace kanec::test {
namespace {

using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

constexpr int n = 5;
constexpr double k_over_m = 50.0 / 0.5;

// ω_j = 2 √(k/m) sin(j π / (2 (n + 1))).
double frequency(int j) { return 2 * std::sqrt(k_over_m) * std::sin(j * std::numbers::pi / (2 * (n + 1))); }

class SpringChain : public testing::Test {
 protected:
  Matrix matrix(const std::string& function) const {
    program::Arguments<double> at = model.start();
    at.x.assign(n, 0.0);
    const std::vector<double> flat = model(function, at);
    return Eigen::Map<const Matrix>(flat.data(), n, n);
  }

  const Model model{shipped_scene("spring_chain"), {"kinematics", "accelerations", "mass_matrix", "residual_x"}};
};

// Sums of five terms and an eigenvalue problem of condition number 100.
TEST_F(SpringChain, eigenvalues_are_the_squares_of_the_known_frequencies) {
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(matrix("residual_x"), matrix("mass_matrix"));
  for (int j = 1; j <= n; ++j)
    EXPECT_NEAR(modes.eigenvalues()[j - 1], frequency(j) * frequency(j), 1e-12 * 4 * k_over_m) << j;
}

// Mode j, pulled out as sin(i j π/(n+1)), is there mirrored after half its period. The method leaves (ω h)^4/120 =
// 1e-10.
TEST_F(SpringChain, each_mode_swings_alone_with_its_frequency) {
  for (int j = 1; j <= n; ++j) {
    program::Arguments<double> at = model.start();
    const auto shape = [&](int i) { return 0.01 * std::sin(i * j * std::numbers::pi / (n + 1)); };
    for (int i = 1; i <= n; ++i) at.x[static_cast<std::size_t>(i - 1)] = shape(i) - shape(i - 1);
    const auto later = after(model, at, std::numbers::pi / frequency(j), 200);
    for (std::size_t i = 0; i < n; ++i) EXPECT_NEAR(later.x[i], -at.x[i], 1e-10) << j;
  }
}

}  // namespace
}  // namespace kanec::test
