// Cosines and sines of several angles at once. Oracle: the functions in long double; large angles and what is no
// number: the library's own.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/lanes/cos_sin.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "runtime/lanes/lane_functions.hpp"
#include "tests/support/random.hpp"

namespace kanec::test {
namespace {

using kanec_cos_sin::cos_sin;

constexpr double promised = 0.95;  // ulps

double ulps(double found, long double right) {
  int exponent = 0;
  std::frexp(static_cast<double>(right), &exponent);
  return static_cast<double>(std::abs(found - right) / std::ldexp(1.0L, exponent - 53));
}

// Angles of all sizes, many of them as near as doubles come to multiples of pi/2.
std::vector<double> angles(Random& random, std::size_t n) {
  std::vector<double> list(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double size = std::pow(10.0, random.uniform(-9, 2.6));
    const double angle = random.uniform(-size, size);
    list[i] = i % 3 != 0 ? angle : std::nextafter(std::nearbyint(angle / M_PI_2) * M_PI_2, angle);
  }
  return list;
}

TEST(CosSin, errs_by_less_than_an_ulp_however_many_angles_there_are) {
  Random random(5);
  for (int n = 0; n < 10; ++n)
    for (int k = 0; k < 20000; ++k) {
      const std::vector<double> a = angles(random, static_cast<std::size_t>(n));
      std::vector<double> c(a.size() + 1, 7.0), s(a.size() + 1, 7.0);
      cos_sin(a.data(), n, c.data(), s.data());
      for (std::size_t i = 0; i < a.size(); ++i) {
        ASSERT_LT(ulps(c[i], std::cos(static_cast<long double>(a[i]))), promised) << a[i];
        ASSERT_LT(ulps(s[i], std::sin(static_cast<long double>(a[i]))), promised) << a[i];
      }
      ASSERT_EQ(c.back(), 7.0) << "written beyond the last angle";
      ASSERT_EQ(s.back(), 7.0);
    }
}

TEST(CosSin, of_large_angles_is_the_librarys) {
  const std::vector<double> a = {4097.0, 1e22, -1e300, 0.5, 1.0};
  std::vector<double> c(a.size()), s(a.size());
  cos_sin(a.data(), 5, c.data(), s.data());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(c[i], std::cos(a[i]));
    EXPECT_EQ(s[i], std::sin(a[i]));
  }
}

TEST(CosSin, of_no_number_is_no_number) {
  for (const double bad : {std::numeric_limits<double>::infinity(), std::numeric_limits<double>::quiet_NaN()}) {
    const double a[] = {bad, 0.5};
    double c[2], s[2];
    cos_sin(a, 2, c, s);
    EXPECT_TRUE(std::isnan(c[0]) && std::isnan(s[0]));
    EXPECT_EQ(c[1], std::cos(0.5));
  }
}

TEST(CosSin, of_another_scalar_is_by_its_own_functions) {
  const long double a[] = {0.5L, -2.0L, 5000.0L};
  long double c[3], s[3];
  cos_sin(a, 3, c, s);
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(c[i], std::cos(a[i]));
    EXPECT_EQ(s[i], std::sin(a[i]));
  }
}

template <class L>
class CosSinOfLanes : public testing::Test {};
using Types = testing::Types<Lanes<double, 2>, Lanes<double, 4>, Lanes<double, 8>, Lanes<double, 16>>;
TYPED_TEST_SUITE(CosSinOfLanes, Types);

TYPED_TEST(CosSinOfLanes, errs_by_less_than_an_ulp_in_every_lane) {
  Random random(6);
  constexpr int n = 3, lanes = TypeParam::size;
  for (int k = 0; k < 10000; ++k) {
    const std::vector<double> list = angles(random, n * lanes);
    TypeParam a[n], c[n], s[n];
    for (int i = 0; i < n; ++i) a[i] = TypeParam::load(list.data() + i * lanes);
    cos_sin(a, n, c, s);
    for (int i = 0; i < n; ++i)
      for (int lane = 0; lane < lanes; ++lane) {
        ASSERT_LT(ulps(c[i][lane], std::cos(static_cast<long double>(a[i][lane]))), promised) << a[i][lane];
        ASSERT_LT(ulps(s[i][lane], std::sin(static_cast<long double>(a[i][lane]))), promised) << a[i][lane];
      }
  }
}

TYPED_TEST(CosSinOfLanes, does_not_depend_on_what_other_lanes_hold) {
  TypeParam calm[2] = {TypeParam(0.3), TypeParam(2.5)}, wild[2] = {calm[0], calm[1]}, c[2], s[2], cw[2], sw[2];
  wild[0].set(1, 1e9);
  wild[1].set(1, std::numeric_limits<double>::quiet_NaN());
  cos_sin(calm, 2, c, s);
  cos_sin(wild, 2, cw, sw);
  for (int i = 0; i < 2; ++i)
    for (int lane = 0; lane < TypeParam::size; ++lane) {
      if (lane == 1) continue;
      EXPECT_EQ(c[i][lane], cw[i][lane]);
      EXPECT_EQ(s[i][lane], sw[i][lane]);
    }
  EXPECT_EQ(cw[0][1], std::cos(1e9));
  EXPECT_TRUE(std::isnan(sw[1][1]));
}

}  // namespace
}  // namespace kanec::test
