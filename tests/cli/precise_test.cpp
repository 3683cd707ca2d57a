// Oracle: identities of real numbers, in 50 digits. SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/precise.hpp"

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
}

}  // namespace
}  // namespace kanec::cli
