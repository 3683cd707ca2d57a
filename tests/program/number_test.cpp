// Double-double arithmetic. Oracle: exact rational numbers (CLN through GiNaC).
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/program/number.hpp"

#include <ginac/ginac.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

#include "tests/support/random.hpp"

namespace kanec::program {
namespace {

using GiNaC::numeric;

numeric exact(double value) {
  int exponent = 0;
  const auto mantissa = static_cast<long>(std::ldexp(std::frexp(value, &exponent), 53));
  return numeric(mantissa) * GiNaC::pow(numeric(2), numeric(exponent - 53));
}

numeric exact(const Number& number) { return exact(number.high) + exact(number.low); }

// |found - wanted| in units of 2^-106 |wanted|, the square of half an ulp.
double error(const Number& found, const numeric& wanted) {
  if (wanted.is_zero()) return exact(found).is_zero() ? 0 : HUGE_VAL;
  const numeric relative = GiNaC::abs((exact(found) - wanted) / wanted);
  return (relative * GiNaC::pow(numeric(2), numeric(106))).to_double();
}

// Of many magnitudes and both signs; every third one a plain double.
Number random_number(test::Random& random) {
  const double high = std::ldexp(random.uniform(-1, 1), random.below(80) - 40);
  return random.chance(0.3) ? Number(high) : two_sum(high, high * random.uniform(-0x1p-54, 0x1p-54));
}

constexpr int n_samples = 2000;

TEST(Number, sums_and_products_of_two_doubles_are_exact) {
  test::Random random(1);
  for (int i = 0; i < n_samples; ++i) {
    const double a = random_number(random).high;
    const double b = random_number(random).high;
    ASSERT_EQ(exact(two_sum(a, b)), exact(a) + exact(b));
    ASSERT_EQ(exact(two_product(a, b)), exact(a) * exact(b));
  }
}

TEST(Number, low_part_is_at_most_half_an_ulp_of_the_high_part) {
  test::Random random(2);
  for (int i = 0; i < n_samples; ++i) {
    const Number a = random_number(random);
    const Number b = random_number(random);
    for (const Number& result : {a + b, a - b, a * b, a / b}) {
      ASSERT_EQ(result.high + result.low, result.high);  // adding it changes nothing
      ASSERT_EQ(result.rounded(), result.high);
    }
  }
}

// Bounds for these algorithms, Joldes, Muller, Popescu, ACM TOMS 44 (2017): 3 u² for the sum and 5 u² for the product,
// u = 2^-53, plus terms in u³. Three quotient digits leave the rounding of the last sums, two of 3 u².
TEST(Number, operations_err_by_a_few_units_of_the_106th_bit) {
  test::Random random(3);
  double of_sum = 0, of_product = 0, of_quotient = 0;
  for (int i = 0; i < n_samples; ++i) {
    const Number a = random_number(random);
    const Number b = random_number(random);
    of_sum = std::max({of_sum, error(a + b, exact(a) + exact(b)), error(a - b, exact(a) - exact(b))});
    of_product = std::max(of_product, error(a * b, exact(a) * exact(b)));
    if (b.high != 0) of_quotient = std::max(of_quotient, error(a / b, exact(a) / exact(b)));
  }
  EXPECT_LE(of_sum, 3.01);
  EXPECT_LE(of_product, 5.01);
  EXPECT_LE(of_quotient, 6.01);
}

TEST(Number, quotients_of_integers_come_back_when_multiplied) {
  test::Random random(4);
  for (int i = 0; i < n_samples; ++i) {
    const double a = 1 + random.below(1 << 30);
    const double b = 1 + random.below(1 << 30);
    const Number back = Number(a) / Number(b) * Number(b);
    EXPECT_LE(error(back, exact(a)), 11.1);  // the two bounds above
    EXPECT_EQ(back.rounded(), a);
  }
}

TEST(Number, negation_is_exact_and_a_number_less_itself_is_zero) {
  test::Random random(5);
  for (int i = 0; i < n_samples; ++i) {
    const Number a = random_number(random);
    EXPECT_EQ(exact(-a), -exact(a));
    EXPECT_EQ(a - a, Number(0.0));
    EXPECT_EQ(a + Number(0.0), a);
    EXPECT_EQ(a * Number(1.0), a);
    EXPECT_EQ(a / Number(1.0), a);
  }
}

}  // namespace
}  // namespace kanec::program
