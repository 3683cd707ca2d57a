// Functions of lanes in ulps of their scalar. Oracle: the function in long double.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/lanes/lane_functions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include "tests/support/random.hpp"

namespace kanec::test {
namespace {

// Error of a result in units of the last place of what is right.
template <class T>
double ulps(T found, long double right) {
  const T rounded = static_cast<T>(right);
  if (!std::isfinite(rounded) || !std::isfinite(found))
    return (std::isnan(found) && std::isnan(rounded)) || found == rounded ? 0 : HUGE_VAL;
  const T larger = std::nextafter(std::abs(rounded), std::numeric_limits<T>::infinity());
  return static_cast<double>(std::abs(static_cast<long double>(found) - right) / (larger - std::abs(rounded)));
}

template <class L>
class LaneFunctions : public testing::Test {
 protected:
  using Number = typename L::Scalar;

  L between(double low, double high) {
    L result;
    for (int i = 0; i < L::size; ++i) result.set(i, static_cast<Number>(random_.uniform(low, high)));
    return result;
  }

  // The largest error over some thousand arguments; recorded under the function's name.
  template <class OfLanes, class Exact>
  void expect_ulps(const char* name, double low, double high, OfLanes of_lanes, Exact exact, double bound) {
    double worst = 0;
    for (int n = 0; n < 4000; ++n) {
      const L a = between(low, high), b = between(low, high), found = of_lanes(a, b);
      for (int i = 0; i < L::size; ++i) worst = std::max(worst, ulps(found[i], exact(a[i], b[i])));
    }
    this->RecordProperty(name, std::to_string(worst));
    EXPECT_LE(worst, bound) << name;
  }

 private:
  Random random_{2};
};

using Types = testing::Types<Lanes<double, 2>, Lanes<double, 4>, Lanes<double, 8>, Lanes<double, 16>, Lanes<float, 2>,
                             Lanes<float, 4>, Lanes<float, 8>, Lanes<float, 16>>;
TYPED_TEST_SUITE(LaneFunctions, Types);

using Long = long double;

TYPED_TEST(LaneFunctions, square_root_is_correctly_rounded) {
  this->expect_ulps(
      "sqrt", 0, 1e4, [](const auto& a, const auto&) { return sqrt(a); }, [](Long a, Long) { return std::sqrt(a); },
      0.5000001);
}

constexpr double promised = 4.0;  // by libmvec, in ulps

// Found with glibc 2.36: 3.5 ulps in double, 1.9 in float.
TYPED_TEST(LaneFunctions, sine_and_cosine_err_by_few_ulps) {
  for (const double range : {1.0, 7.0, 1000.0}) {
    this->expect_ulps(
        "sin", -range, range, [](const auto& a, const auto&) { return sin(a); },
        [](Long a, Long) { return std::sin(a); }, promised);
    this->expect_ulps(
        "cos", -range, range, [](const auto& a, const auto&) { return cos(a); },
        [](Long a, Long) { return std::cos(a); }, promised);
  }
}

TYPED_TEST(LaneFunctions, others_err_by_few_ulps) {
  this->expect_ulps(
      "tan", -1.5, 1.5, [](const auto& a, const auto&) { return tan(a); }, [](Long a, Long) { return std::tan(a); },
      promised);
  this->expect_ulps(
      "asin", -1, 1, [](const auto& a, const auto&) { return asin(a); }, [](Long a, Long) { return std::asin(a); },
      promised);
  this->expect_ulps(
      "acos", -1, 1, [](const auto& a, const auto&) { return acos(a); }, [](Long a, Long) { return std::acos(a); },
      promised);
  this->expect_ulps(
      "exp", -20, 20, [](const auto& a, const auto&) { return exp(a); }, [](Long a, Long) { return std::exp(a); },
      promised);
  this->expect_ulps(
      "log", 1e-3, 1e3, [](const auto& a, const auto&) { return log(a); }, [](Long a, Long) { return std::log(a); },
      promised);
  this->expect_ulps(
      "tanh", -5, 5, [](const auto& a, const auto&) { return tanh(a); }, [](Long a, Long) { return std::tanh(a); },
      promised);
  this->expect_ulps(
      "atan2", -2, 2, [](const auto& a, const auto& b) { return atan2(a, b); },
      [](Long a, Long b) { return std::atan2(a, b); }, promised);
  this->expect_ulps(
      "pow", 0.1, 5, [](const auto& a, const auto& b) { return pow(a, b); },
      [](Long a, Long b) { return std::pow(a, b); }, promised);
}

// What one lane holds does not change another: a state's results must not depend on its neighbours.
TYPED_TEST(LaneFunctions, lanes_do_not_disturb_each_other) {
  using T = typename TypeParam::Scalar;
  for (int n = 0; n < 200; ++n) {
    const TypeParam quiet = this->between(0.1, 0.9);
    TypeParam odd = quiet;
    constexpr T strange[] = {std::numeric_limits<T>::quiet_NaN(), std::numeric_limits<T>::infinity(), T(1e30), T(-1)};
    const int at = n % TypeParam::size;
    odd.set(at, strange[n % 4]);
    for (int i = 0; i < TypeParam::size; ++i) {
      if (i == at) continue;
      EXPECT_EQ(sin(odd)[i], sin(quiet)[i]);
      EXPECT_EQ(cos(odd)[i], cos(quiet)[i]);
      EXPECT_EQ(sqrt(odd)[i], sqrt(quiet)[i]);
      EXPECT_EQ(log(odd)[i], log(quiet)[i]);
      EXPECT_EQ(pow(odd, quiet)[i], pow(quiet, quiet)[i]);
    }
  }
}

}  // namespace
}  // namespace kanec::test
