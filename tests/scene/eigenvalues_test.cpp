// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/eigenvalues.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace kanec::scene {
namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

Matrix random_symmetric(std::mt19937_64& generator) {
  std::uniform_real_distribution<double> entry(-1, 1);
  Matrix a{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i; j < 3; ++j) a[i][j] = a[j][i] = entry(generator);
  return a;
}

double determinant(const Matrix& a, double shift) {
  const auto at = [&](std::size_t i, std::size_t j) { return a[i][j] - (i == j ? shift : 0); };
  return at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
         at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
         at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
}

TEST(Eigenvalues, of_a_diagonal_are_its_entries_in_order) {
  EXPECT_EQ(eigenvalues({{{3, 0, 0}, {0, -1, 0}, {0, 0, 2}}}), (std::array<double, 3>{-1, 2, 3}));
  EXPECT_EQ(eigenvalues({}), (std::array<double, 3>{0, 0, 0}));
}

// oracle: the characteristic polynomial, and the invariants trace and sum of squares
TEST(Eigenvalues, are_roots_of_the_characteristic_polynomial) {
  std::mt19937_64 generator(7);
  for (int draw = 0; draw < 1000; ++draw) {
    const Matrix a = random_symmetric(generator);
    const auto roots = eigenvalues(a);
    double trace = 0, square = 0;
    for (std::size_t i = 0; i < 3; ++i) trace += a[i][i];
    for (const auto& row : a)
      for (const double entry : row) square += entry * entry;
    // entries and roots are at most 3 in size: rounding of some tens of operations of that size, each 2.2e-16 relative
    const double tolerance = 1e-13;
    EXPECT_NEAR(roots[0] + roots[1] + roots[2], trace, tolerance);
    EXPECT_NEAR(roots[0] * roots[0] + roots[1] * roots[1] + roots[2] * roots[2], square, tolerance);
    for (const double root : roots) EXPECT_NEAR(determinant(a, root), 0, tolerance);
    EXPECT_LE(roots[0], roots[1]);
    EXPECT_LE(roots[1], roots[2]);
  }
}

TEST(Eigenvalues, of_a_singular_matrix_have_a_zero_to_rounding) {
  // 3 - (1,1,1)(1,1,1)ᵀ: 0, 3, 3; absolute error of a few ulps of the largest
  const auto roots = eigenvalues({{{2, -1, -1}, {-1, 2, -1}, {-1, -1, 2}}});
  EXPECT_NEAR(roots[0], 0, 4e-15);
  EXPECT_NEAR(roots[1], 3, 4e-15);
  EXPECT_NEAR(roots[2], 3, 4e-15);
}

TEST(Eigenvalues, of_extreme_sizes_neither_overflow_nor_underflow) {
  for (const double size : {1e300, 1e-300}) {
    const auto roots = eigenvalues({{{2 * size, size, 0}, {size, 2 * size, 0}, {0, 0, size}}});
    // 1, 1, 3 times the size, to a few roundings
    EXPECT_NEAR(roots[0] / size, 1, 1e-14);
    EXPECT_NEAR(roots[1] / size, 1, 1e-14);
    EXPECT_NEAR(roots[2] / size, 3, 1e-14);
  }
}

}  // namespace
}  // namespace kanec::scene
