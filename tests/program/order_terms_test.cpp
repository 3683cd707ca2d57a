// Oracle: sums whose number of multiply-adds in the best order is known.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "generator/program/fusible.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "tests/program/field.hpp"
#include "tests/program/random_program.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using test::Field;

int fused(const Program& program) { return multiply_adds(program, program.functions[0]); }

TEST(OrderTerms, a_term_that_is_no_product_comes_first) {
  SmallProgram b;
  const Ref product = b.multiply(b.x(0), b.x(1)), other = b.multiply(b.x(1), b.x(2));
  const Program program = b.with({b.add(b.add(product, other), b.x(3))});  // x0 x1 + x1 x2 + x3
  const Program ordered = order_terms(program);
  EXPECT_EQ(fused(program), 1);
  EXPECT_EQ(fused(ordered), 2);
  EXPECT_EQ(ledger(ordered, ordered.functions[0]), ledger(program, program.functions[0]));
  EXPECT_EQ(test::values_at_random(ordered), test::values_at_random(program));
}

TEST(OrderTerms, a_product_that_something_else_needs_comes_before_those_that_nothing_else_needs) {
  SmallProgram b;
  const Ref shared = b.multiply(b.x(0), b.x(1)), own = b.multiply(b.x(1), b.x(2)), first = b.multiply(b.x(2), b.x(3));
  const Program program = b.with({b.add(b.add(own, first), shared), shared});
  EXPECT_EQ(fused(program), 1);
  EXPECT_EQ(fused(order_terms(program)), 2);
  EXPECT_EQ(test::values_at_random(order_terms(program)), test::values_at_random(program));
}

TEST(OrderTerms, sums_of_products_alone_stay_as_they_were) {
  SmallProgram b;
  const Program program = b.with({b.subtract(b.multiply(b.x(0), b.x(1)), b.multiply(b.x(2), b.x(3)))});
  EXPECT_EQ(fused(order_terms(program)), fused(program));
  EXPECT_EQ(test::values_at_random(order_terms(program)), test::values_at_random(program));
}

TEST(OrderTerms, never_lowers_the_number_of_multiply_adds) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    test::Random random(seed);
    const Program program = drop_dead(share(test::random_program(random, 150)));
    const Program ordered = order_terms(program);
    for (std::size_t i = 0; i < program.functions.size(); ++i)
      ASSERT_GE(multiply_adds(ordered, ordered.functions[i]), multiply_adds(program, program.functions[i])) << seed;
  }
}

}  // namespace
}  // namespace kanec::program
