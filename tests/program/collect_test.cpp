// Oracle: sums whose cheapest form is known, with their operations; random programs in a finite field.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "tests/program/field.hpp"
#include "tests/program/random_program.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using test::Field;

int operations(const Program& program) { return ledger(program, program.functions[0]).operations(); }

// x + 1/2 + y + 1/4 - 2.
TEST(Collect, constants_of_a_sum_become_one) {
  SmallProgram b;
  const Program program = b.with({b.subtract(b.add(b.add(b.add(b.x(0), b.c(0.5)), b.x(1)), b.c(0.25)), b.c(2))});
  const Program collected = drop_dead(collect(program));
  EXPECT_EQ(operations(program), 4);
  EXPECT_EQ(operations(collected), 2);
  EXPECT_EQ(test::values_at_random(collected), test::values_at_random(program));
}

// x/2 + y + x/4 + x = 7/4 x + y.
TEST(Collect, multiples_of_one_value_become_one) {
  SmallProgram b;
  const Ref x = b.x(0);
  const Ref half = b.multiply(b.c(0.5), x), quarter = b.multiply(x, b.c(0.25));
  const Program program = b.with({b.add(b.add(b.add(half, b.x(1)), quarter), x)});
  const Program collected = drop_dead(collect(program));
  EXPECT_EQ(operations(program), 5);
  EXPECT_EQ(operations(collected), 2);
  EXPECT_EQ(test::values_at_random(collected), test::values_at_random(program));
}

// x/2 + y - x/2 = y.
TEST(Collect, multiples_that_cancel_are_gone) {
  SmallProgram b;
  const Ref half = b.multiply(b.c(0.5), b.x(0));
  const Program program = b.with({b.subtract(b.add(half, b.x(1)), half)});
  const Program collected = drop_dead(collect(program));
  EXPECT_EQ(operations(collected), 0);
  EXPECT_EQ(test::values_at_random(collected), test::values_at_random(program));
}

// A name for the partial sum x + 1/2 keeps it; x + x is no dearer than 2 x.
TEST(Collect, named_partial_sums_and_plain_doubles_stay) {
  SmallProgram b;
  const Ref named = b.add(b.x(0), b.c(0.5));
  const Program program = b.with({b.add(named, b.c(0.25)), b.add(b.x(1), b.x(1))}, {named});
  const Program collected = drop_dead(collect(program));
  EXPECT_EQ(operations(collected), operations(program));
  EXPECT_EQ(count<Multiply>(collected), 0);
}

TEST(Collect, keeps_values_and_never_raises_the_cost) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    test::Random random(seed);
    const Program program = share(simplify(share(simplify(test::random_program(random, 60)))));
    const Program collected = drop_dead(collect(program));
    const auto at = test::random_arguments(random);
    for (std::size_t i = 0; i < program.functions.size(); ++i) {
      EXPECT_EQ(evaluate(collected, collected.functions[i], at), evaluate(program, program.functions[i], at)) << seed;
      EXPECT_LE(ledger(collected, collected.functions[i]).operations(),
                ledger(program, program.functions[i]).operations())
          << seed;
    }
  }
}

// x0 + 2 x0 + x1 + 2 x1 + ...: 3 x0 + 3 x1 + ...
TEST(Collect, multiples_of_thousands_of_values_become_one_each) {
  constexpr Index n = 5000;
  SmallProgram b;
  Ref all = b.c(0.5);
  for (Index i = 0; i < n; ++i) {
    const Ref x = b.x(i);
    all = b.add(b.add(all, x), b.multiply(b.c(2), x));
  }
  EXPECT_EQ(operations(drop_dead(collect(b.with({all})))), 2 * n);
}

}  // namespace
}  // namespace kanec::program
