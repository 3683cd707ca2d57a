// Products coefficient by coefficient. Oracle: the product of polynomials.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/taylor/products.hpp"

#include <gtest/gtest.h>

#include "tests/support/random.hpp"

namespace kanec::test {
namespace {

constexpr int order = 23, stride = order + 1 + kanec_series::group;

// Small whole numbers: every sum is exact in double.
template <class T>
void expect_products() {
  Random random(5);
  T a[order + 1], b[order + 1];
  for (int k = 0; k <= order; ++k) {
    a[k] = T(static_cast<int>(random.uniform(-9, 9)));
    b[k] = T(static_cast<int>(random.uniform(-9, 9)));
  }
  const kanec_series::Product products[] = {{0, 0, 1, 1}, {1, 1, 0, -1}, {1, 0, 0, 1}};
  T factors[2][stride] = {}, sums[2][stride] = {};
  for (int k = 1; k < order; ++k) {
    T product = 0, mixed = 0;  // without the newest coefficients
    for (int i = 1; i < k; ++i) {
      product += a[i] * b[k - i];
      mixed += a[i] * a[k - i] - a[i] * b[k - i];
    }
    EXPECT_EQ(sums[0][k], product) << k;
    EXPECT_EQ(sums[1][k], mixed) << k;
    const T now[] = {a[k], b[k]};
    kanec_series::add_products<T, stride>(products, 3, 2, k, order, now, factors, sums);
  }
}

TEST(TaylorProducts, are_those_of_polynomials_in_every_scalar) {
  expect_products<float>();
  expect_products<double>();
  expect_products<long double>();
}

}  // namespace
}  // namespace kanec::test
