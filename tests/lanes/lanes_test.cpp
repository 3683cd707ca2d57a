// The lane type: arithmetic, comparison, choice. Oracle: the same of one number, lane by lane.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/lanes/lanes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "tests/support/random.hpp"

namespace kanec::test {
namespace {

template <class L>
class LaneType : public testing::Test {
 protected:
  using Number = typename L::Scalar;

  // Ordinary numbers, zeros of both signs, equal ones, infinities, and what is no number.
  Number number() {
    constexpr Number special[] = {
        0, -Number(0), 1, 1, std::numeric_limits<Number>::infinity(), std::numeric_limits<Number>::quiet_NaN()};
    const int i = random_.below(16);
    return i < 6 ? special[i] : static_cast<Number>(random_.uniform(-2, 2));
  }
  L lanes() {
    L result;
    for (int i = 0; i < L::size; ++i) result.set(i, number());
    return result;
  }
  static bool same(Number a, Number b) {
    return std::isnan(a) ? std::isnan(b) : a == b && std::signbit(a) == std::signbit(b);
  }

  template <class OfLanes, class OfOne>
  void expect_each(OfLanes of_lanes, OfOne of_one) {
    for (int repetition = 0; repetition < 200; ++repetition) {
      const L a = lanes(), b = lanes(), result = of_lanes(a, b);
      for (int i = 0; i < L::size; ++i)
        ASSERT_TRUE(same(result[i], of_one(a[i], b[i]))) << a[i] << ", " << b[i] << " gives " << result[i];
    }
  }

 private:
  Random random_{1};
};

using Types = testing::Types<Lanes<double, 2>, Lanes<double, 4>, Lanes<double, 8>, Lanes<double, 16>, Lanes<float, 4>,
                             Lanes<float, 8>, Lanes<float, 16>, Lanes<float, 2>>;
TYPED_TEST_SUITE(LaneType, Types);

TYPED_TEST(LaneType, computes_as_its_scalar_does) {
  using T = typename TypeParam::Scalar;
  const auto t = [](auto value) { return static_cast<T>(value); };
  this->expect_each([](const auto& a, const auto& b) { return a + b; }, [&](T a, T b) { return t(a + b); });
  this->expect_each([](const auto& a, const auto& b) { return a - b; }, [&](T a, T b) { return t(a - b); });
  this->expect_each([](const auto& a, const auto& b) { return a * b; }, [&](T a, T b) { return t(a * b); });
  this->expect_each([](const auto& a, const auto& b) { return a / b; }, [&](T a, T b) { return t(a / b); });
  this->expect_each([](const auto& a, const auto&) { return -a; }, [&](T a, T) { return t(-a); });
  this->expect_each(
      [](const auto& a, const auto& b) {
        auto c = a;
        return c += b, c -= a, c *= b, c /= b;
      },
      [&](T a, T b) { return t(t(t(t(a + b) - a) * b) / b); });
}

TYPED_TEST(LaneType, chooses_as_its_scalar_does) {
  using T = typename TypeParam::Scalar;
  this->expect_each([](const auto& a, const auto& b) { return min(a, b); }, [](T a, T b) { return std::min(a, b); });
  this->expect_each([](const auto& a, const auto& b) { return max(a, b); }, [](T a, T b) { return std::max(a, b); });
  this->expect_each([](const auto& a, const auto&) { return abs(a); }, [](T a, T) { return std::abs(a); });
  this->expect_each([](const auto& a, const auto& b) { return select(a < b, a, -b); },
                    [](T a, T b) { return a < b ? a : -b; });
  this->expect_each([](const auto& a, const auto& b) { return select(a > b, a, -b); },
                    [](T a, T b) { return a > b ? a : -b; });
  this->expect_each([](const auto& a, const auto& b) { return select(a <= b, a, -b); },
                    [](T a, T b) { return a <= b ? a : -b; });
  this->expect_each([](const auto& a, const auto& b) { return select(a >= b, a, -b); },
                    [](T a, T b) { return a >= b ? a : -b; });
  this->expect_each([](const auto& a, const auto& b) { return select(a == b, a, -b); },
                    [](T a, T b) { return a == b ? a : -b; });
  this->expect_each([](const auto& a, const auto& b) { return select(a != b, a, -b); },
                    [](T a, T b) { return a != b ? a : -b; });
}

TYPED_TEST(LaneType, mask_tells_lane_by_lane) {
  const TypeParam a = this->lanes(), b = this->lanes();
  const auto mask = a < b;
  for (int i = 0; i < TypeParam::size; ++i) EXPECT_EQ(mask[i], a[i] < b[i]);
}

TYPED_TEST(LaneType, constant_stands_in_every_lane_with_its_sign) {
  using T = typename TypeParam::Scalar;
  for (const double value : {0.1, -0.0, 0.0, 3.0, 1e300, -1e-310}) {
    const TypeParam lanes(value);
    for (int i = 0; i < TypeParam::size; ++i) EXPECT_TRUE(this->same(lanes[i], static_cast<T>(value)));
  }
}

TYPED_TEST(LaneType, is_read_from_and_written_to_any_address) {
  using T = typename TypeParam::Scalar;
  T from[TypeParam::size + 1], to[TypeParam::size + 1] = {};
  for (int i = 0; i <= TypeParam::size; ++i) from[i] = static_cast<T>(i);
  TypeParam::load(from + 1).store(to + 1);
  EXPECT_EQ(to[0], 0);
  for (int i = 1; i <= TypeParam::size; ++i) EXPECT_EQ(to[i], static_cast<T>(i));
}

TYPED_TEST(LaneType, is_as_large_as_its_numbers_and_copied_as_bytes) {
  EXPECT_EQ(sizeof(TypeParam), TypeParam::size * sizeof(typename TypeParam::Scalar));
  EXPECT_TRUE(std::is_trivially_copyable_v<TypeParam>);
  EXPECT_FALSE((std::is_convertible_v<double, TypeParam>));
  EXPECT_FALSE((std::is_convertible_v<TypeParam, double>));
}

}  // namespace
}  // namespace kanec::test
