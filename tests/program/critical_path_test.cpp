// Oracle: chains counted by hand.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/critical_path.hpp"

#include <gtest/gtest.h>

#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

int path(const Program& program) { return critical_path(program, program.functions[0]); }
int arithmetic(const Program& program) { return instructions(program, program.functions[0]); }

TEST(CriticalPath, is_the_longest_chain_and_not_the_sum) {
  SmallProgram b;
  const Ref sum = b.add(b.add(b.x(0), b.x(1)), b.x(2));          // 8
  const Ref quotient = b.divide(b.add(b.x(0), b.x(3)), b.x(1));  // 18
  EXPECT_EQ(path(b.with({sum})), 8);
  EXPECT_EQ(path(b.with({sum, quotient})), 18);
}

TEST(CriticalPath, takes_a_product_into_the_sum_that_alone_needs_it) {
  SmallProgram b;
  const Ref product = b.multiply(b.x(0), b.x(1));
  const Program program = b.with({b.add(b.x(2), product)});
  EXPECT_EQ(path(program), 4);
  EXPECT_EQ(arithmetic(program), 1);
  const Program kept = b.with({b.add(b.x(2), product), product});
  EXPECT_EQ(path(kept), 8);
  EXPECT_EQ(arithmetic(kept), 2);
}

TEST(CriticalPath, takes_in_one_product_of_two) {
  SmallProgram b;
  const Program program = b.with({b.subtract(b.multiply(b.x(0), b.x(1)), b.multiply(b.x(2), b.x(3)))});
  EXPECT_EQ(path(program), 8);
  EXPECT_EQ(arithmetic(program), 2);
}

TEST(CriticalPath, begins_behind_what_parameters_give) {
  SmallProgram b;
  EXPECT_EQ(path(b.with({b.multiply(b.x(0), b.square_root(b.p(0)))})), 4);
  EXPECT_EQ(path(b.with({b.multiply(b.p(0), b.square_root(b.x(0)))})), 22);
}

}  // namespace
}  // namespace kanec::program
