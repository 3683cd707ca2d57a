// Oracle: identities of real numbers, in 50 digits.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/verify/precise.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "runtime/base/error.hpp"

namespace kanec::cli {
namespace {

constexpr double last_digit = 1e-49;  // a few units of the 50th digit of a number near 1

TEST(Precise, rounds_in_the_fiftieth_digit) {
  const Precise one(1.0), three(3.0), third = one / three;
  EXPECT_LT((third * three - one).magnitude().rounded(), last_digit);
  EXPECT_GT((third - Precise(1.0 / 3.0)).magnitude().rounded(), 1e-17);  // where double rounds
  const Precise root = sqrt(Precise(2.0));
  EXPECT_LT((root * root - Precise(2.0)).magnitude().rounded(), 2 * last_digit);
  const Precise s = sin(Precise(0.7)), c = cos(Precise(0.7));
  EXPECT_LT((s * s + c * c - one).magnitude().rounded(), last_digit);
}

TEST(Precise, functions_undo_each_other_in_fifty_digits) {
  const auto expect_equal = [](const Precise& found, const Precise& wanted) {
    EXPECT_LT((found - wanted).magnitude().rounded(), 20 * last_digit);
  };
  for (const double value : {0.7, -0.3, 0.001, -0.999999}) {
    const Precise a(value);
    expect_equal(sin(asin(a)), a);
    expect_equal(cos(acos(a)), a);
    expect_equal(tan(atan2(a, Precise(1.0))), a);
    expect_equal(log(exp(a)), a);
    expect_equal(tanh(a), (exp(a) - exp(-a)) / (exp(a) + exp(-a)));
    expect_equal(pow(a, Precise(3.0)), a * a * a);
    expect_equal(pow(abs(a), Precise(0.5)), sqrt(abs(a)));
    expect_equal(pow(a, Precise(-2.0)) * a * a, Precise(1.0));
  }
  expect_equal(atan2(Precise(1.0), Precise(-1.0)), Precise(3.0) * atan2(Precise(1.0), Precise(1.0)));
  EXPECT_TRUE(Precise(1.0) < Precise(2.0));
}

TEST(Precise, doubles_come_back_as_they_were) {
  for (const double value : {0.0, 1.0, -0.1, 1e300, 5e-324, 1.0 + 0x1p-52}) EXPECT_EQ(Precise(value).rounded(), value);
  EXPECT_EQ((-Precise(0.1)).rounded(), -0.1);
  EXPECT_EQ((Precise(1.0) - Precise(1.0)).rounded(), 0.0);
}

TEST(Precise, what_is_no_number_is_refused) {
  EXPECT_THROW(Precise{std::numeric_limits<double>::quiet_NaN()}, InputError);
  EXPECT_THROW(Precise{std::numeric_limits<double>::infinity()}, InputError);
  EXPECT_THROW(Precise(1.0) / Precise(0.0), InputError);
  EXPECT_THROW(sqrt(Precise(-1.0)), InputError);
  EXPECT_THROW(asin(Precise(1.1)), InputError);
  EXPECT_THROW(log(Precise(0.0)), InputError);
  EXPECT_THROW(pow(Precise(-1.0), Precise(0.5)), InputError);
}

}  // namespace
}  // namespace kanec::cli
