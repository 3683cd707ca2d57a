// Oracle: rules of arithmetic, written down case by case.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

// A result that is the variable x[index], with its sign.
void expect_x(const Program& program, Index index, bool negative) {
  const Ref ref = output(program);
  const auto* variable = std::get_if<Variable>(&node(program, ref));
  ASSERT_NE(variable, nullptr);
  EXPECT_EQ(variable->index, index);
  EXPECT_EQ(ref.negative, negative);
}

void expect_constant(const Program& program, const Number& value) {
  const Ref ref = output(program);
  const auto* constant = std::get_if<Constant>(&node(program, ref));
  ASSERT_NE(constant, nullptr);
  EXPECT_EQ(ref.negative ? -constant->value : constant->value, value);
}

template <class Make>
Program simplified(Make make) {
  SmallProgram b;
  const Ref result = make(b);
  return simplify(b.with({result}));
}

TEST(Simplify, zero_and_one_are_eliminated) {
  expect_x(simplified([](SmallProgram& b) { return b.add(b.x(3), b.c(0)); }), 3, false);
  expect_x(simplified([](SmallProgram& b) { return b.add(b.c(0), b.x(3)); }), 3, false);
  expect_x(simplified([](SmallProgram& b) { return b.subtract(b.x(3), b.c(0)); }), 3, false);
  expect_x(simplified([](SmallProgram& b) { return b.subtract(b.c(0), b.x(3)); }), 3, true);
  expect_x(simplified([](SmallProgram& b) { return b.multiply(b.x(3), b.c(1)); }), 3, false);
  expect_x(simplified([](SmallProgram& b) { return b.multiply(b.c(-1), b.x(3)); }), 3, true);
  expect_x(simplified([](SmallProgram& b) { return b.divide(b.x(3), b.c(1)); }), 3, false);
  expect_constant(simplified([](SmallProgram& b) { return b.multiply(b.c(0), b.x(3)); }), 0.0);
  expect_constant(simplified([](SmallProgram& b) { return b.divide(b.c(0), b.x(3)); }), 0.0);
}

TEST(Simplify, what_follows_from_an_elimination_is_eliminated_too) {
  // (0 x0 + 1) x1 - 0
  expect_x(simplified([](SmallProgram& b) {
             return b.subtract(b.multiply(b.add(b.multiply(b.c(0), b.x(0)), b.c(1)), b.x(1)), b.c(0));
           }),
           1, false);
}

TEST(Simplify, a_value_less_itself_is_zero) {
  expect_constant(simplified([](SmallProgram& b) {
                    const Ref x = b.x(0);
                    return b.subtract(x, x);
                  }),
                  0.0);
}

// As exact numbers 0.1·3 and its rounding to a double differ; the folded constant keeps the difference.
TEST(Simplify, constants_fold_in_twice_the_digits_of_a_double) {
  const Program program = simplified([](SmallProgram& b) { return b.multiply(b.c(0.1), b.c(3)); });
  expect_constant(program, two_product(0.1, 3));
  EXPECT_NE(std::get<Constant>(node(program, output(program))).value.low, 0.0);
}

TEST(Simplify, constants_fold_through_a_chain_without_rounding_between) {
  // (1 + 2^-70) - 1, which doubles would give as 0
  expect_constant(simplified([](SmallProgram& b) { return b.subtract(b.add(b.c(1), b.c(0x1p-70)), b.c(1)); }), 0x1p-70);
}

// (7/10/3)·3 - 7/10 in double-double is some 1e-33; and (1/10·1.85)/1.85 is the double 0.1 again.
TEST(Simplify, rounding_of_folded_constants_is_not_taken_for_a_value) {
  expect_constant(
      simplified([](SmallProgram& b) { return b.subtract(b.multiply(b.divide(b.c(0.7), b.c(3)), b.c(3)), b.c(0.7)); }),
      0.0);
  expect_constant(simplified([](SmallProgram& b) { return b.divide(b.multiply(b.c(0.1), b.c(1.85)), b.c(1.85)); }),
                  0.1);
}

TEST(Simplify, dividing_by_a_constant_becomes_multiplying_by_its_reciprocal) {
  const Program program = simplified([](SmallProgram& b) { return b.divide(b.x(0), b.c(-8)); });
  const auto& product = std::get<Multiply>(node(program, output(program)));
  EXPECT_TRUE(output(program).negative);
  EXPECT_EQ(std::get<Constant>(program.nodes[static_cast<std::size_t>(product.b)]).value, Number(0.125));
}

TEST(Simplify, dividing_by_a_constant_zero_is_left_to_the_machine) {
  EXPECT_EQ(count<Divide>(simplified([](SmallProgram& b) { return b.divide(b.c(1), b.c(0)); })), 1);
}

TEST(Simplify, a_constant_and_its_negative_are_one_literal) {
  SmallProgram b;
  const Ref plus = b.multiply(b.c(0.3), b.x(0));
  const Ref minus = b.multiply(b.c(-0.3), b.x(1));
  const Program program = simplify(b.with({plus, minus}));
  EXPECT_FALSE(output(program, 0).negative);
  EXPECT_TRUE(output(program, 1).negative);
  EXPECT_EQ(count<Constant>(share(program)), 1);
}

TEST(Simplify, signs_cost_nothing) {
  SmallProgram b;
  // -((-x0) x1) - (-x2)
  const Ref product = b.multiply(-b.x(0), b.x(1));
  const Program program = simplify(b.with({b.subtract(-product, -b.x(2))}));
  EXPECT_EQ(ledger(program, program.functions[0]), (Ledger{1, 1, 0, 0, 0}));
}

TEST(Simplify, functions_of_constants_are_left_to_the_machine) {
  SmallProgram b;
  EXPECT_EQ(count<SquareRoot>(simplify(b.with({b.square_root(b.c(2))}))), 1);
}

}  // namespace
}  // namespace kanec::program
