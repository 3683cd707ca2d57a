// Oracle: rules of arithmetic, written down case by case.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "generator/program/passes.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

TEST(Share, equal_operations_become_one) {
  SmallProgram b;
  const Ref first = b.cosine(b.square_root(b.divide(b.x(0), b.x(1))));
  const Ref second = b.cosine(b.square_root(b.divide(b.x(0), b.x(1))));
  const Program program = share(b.with({first, second}));
  EXPECT_EQ(output(program, 0), output(program, 1));
  EXPECT_EQ(program.nodes.size(), 5u);
}

TEST(Share, sums_and_products_commute_and_quotients_do_not) {
  SmallProgram b;
  const Ref u = b.x(0);
  const Ref v = b.x(1);
  const Program program = share(b.with({b.add(u, v), b.add(v, u), b.multiply(u, v), b.multiply(v, u),  //
                                        b.divide(u, v), b.divide(v, u)}));
  EXPECT_EQ(count<Add>(program), 1);
  EXPECT_EQ(count<Multiply>(program), 1);
  EXPECT_EQ(count<Divide>(program), 2);
}

TEST(Share, a_difference_and_its_reverse_are_one_operation_of_opposite_signs) {
  SmallProgram b;
  const Ref u = b.x(0);
  const Ref v = b.x(1);
  const Program program = share(b.with({b.subtract(u, v), b.subtract(v, u), b.add(-u, v)}));
  EXPECT_EQ(count<Subtract>(program), 1);
  EXPECT_EQ(output(program, 0), -output(program, 1));
  EXPECT_EQ(output(program, 1), output(program, 2));
}

TEST(Share, variables_of_different_groups_and_different_constants_stay_apart) {
  SmallProgram b;
  const Ref sum = b.add(b.add(b.x(0), b.p(0)), b.variable(Group::y, 0));
  const Program program = share(b.with(
      {b.multiply(sum, b.c(1)), b.multiply(sum, b.c(1 + 0x1p-52)), b.multiply(sum, b.constant(two_sum(1, 0x1p-60)))}));
  EXPECT_EQ(count<Variable>(program), 3);
  EXPECT_EQ(count<Constant>(program), 3);
}

TEST(Share, names_of_equal_quantities_stand_for_one_node) {
  SmallProgram b;
  const Ref first = b.multiply(b.x(0), b.x(1));
  const Ref second = b.multiply(b.x(1), b.x(0));
  const Program program = share(b.with({b.add(first, second)}, {first, -second}));
  const auto& quantities = program.functions[0].quantities;
  ASSERT_EQ(quantities.size(), 2u);
  EXPECT_EQ(quantities[0].entries[0], -quantities[1].entries[0]);
}

}  // namespace
}  // namespace kanec::program
