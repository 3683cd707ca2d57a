// Programs, builder, check, stages, ledger and evaluation. Oracle: programs small enough to know all about them.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/program.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "generator/program/evaluate.hpp"
#include "generator/program/ledger.hpp"
#include "runtime/base/error.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using testing::ElementsAre;
using testing::ThrowsMessage;

TEST(Builder, sums_of_negatives_are_negatives_of_sums) {
  SmallProgram b;
  const Ref u = b.x(0), v = b.x(1);
  EXPECT_TRUE(b.add(-u, -v).negative);
  EXPECT_FALSE(b.add(-u, v).negative);
  const Program program = b.with({b.add(-u, -v), b.add(u, -v), b.add(-u, v), b.subtract(-u, v), b.multiply(-u, v),
                                  b.divide(-u, -v), b.sine(-u), b.cosine(-u)});
  const std::vector<double> values = evaluate(program, program.functions[0], Arguments<double>{{}, {3, 4}, {}, {}, {}});
  EXPECT_THAT(values, ElementsAre(-7, -1, 1, -7, -12, 0.75, -std::sin(3.0), std::cos(3.0)));
}

TEST(Builder, square_root_of_a_negated_result_is_that_of_its_value) {
  SmallProgram b;
  const Program program = b.with({b.square_root(-b.x(0))});
  EXPECT_THAT(evaluate(program, program.functions[0], Arguments<double>{{}, {-9}, {}, {}, {}}), ElementsAre(3));
}

TEST(Check, accepts_a_program_in_order) {
  SmallProgram b;
  EXPECT_NO_THROW(check(b.with({b.add(b.x(0), b.c(2))}, {b.x(1)})));
}

TEST(Check, refuses_an_operand_that_does_not_stand_before_its_user) {
  SmallProgram b;
  const Ref sum = b.add(b.x(0), b.x(1));
  for (const Index bad : {Index{2}, Index{3}, Index{-1}}) {
    Program program = b.with({sum});
    std::get<Add>(program.nodes[2]).b = bad;
    EXPECT_THAT([&] { check(program); }, ThrowsMessage<InternalError>("program: an operand stands after its user"));
  }
}

TEST(Check, refuses_an_output_or_a_quantity_that_is_no_node) {
  SmallProgram b;
  const Ref x = b.x(0);
  EXPECT_THAT(
      [&] {
        check(b.with({Ref{1, false}}));
      },
      ThrowsMessage<InternalError>("program: an output refers to no node"));
  EXPECT_THAT(
      [&] {
        check(b.with({x}, {Ref{-1, true}}));
      },
      ThrowsMessage<InternalError>("program: a quantity refers to no node"));
}

TEST(Stages, a_result_is_of_the_stage_of_its_most_variable_operand) {
  SmallProgram b;
  const Ref constant = b.c(2);
  const Ref once = b.sine(constant);
  const Ref prepared = b.add(b.p(0), once);
  const Ref called = b.cosine(b.divide(prepared, b.variable(Group::input, 0)));
  const std::vector<Stage> stage = stages(b.with({called}));
  const auto of = [&](Ref ref) { return stage[static_cast<std::size_t>(ref.node)]; };
  EXPECT_EQ(of(constant), Stage::constant);
  EXPECT_EQ(of(once), Stage::parameter);
  EXPECT_EQ(of(prepared), Stage::parameter);
  EXPECT_EQ(of(called), Stage::state);
}

TEST(Ledger, counts_every_kind_once_and_leaves_to_prepare_what_is_its) {
  SmallProgram b;
  const Ref p = b.sine(b.square_root(b.divide(b.p(0), b.p(1))));  // prepare: one of each
  const Ref u = b.multiply(b.add(b.x(0), p), b.subtract(b.x(1), b.c(3)));
  const Ref v = b.divide(b.square_root(u), b.add(b.sine(u), b.cosine(u)));
  b.multiply(v, v);  // dead
  const Program program = b.with({v, u, -v});
  EXPECT_EQ(ledger(program, program.functions[0]), (Ledger{3, 1, 1, 1, 2}));
  EXPECT_EQ(ledger(program, program.functions[0]).operations(), 5);
  EXPECT_EQ(prepare_ledger(program), (Ledger{0, 0, 1, 1, 1}));
}

TEST(Ledger, of_a_function_leaves_other_functions_out) {
  SmallProgram b;
  const Ref common = b.add(b.x(0), b.x(1));
  Program program = b.with({b.multiply(common, b.x(2))});
  program.functions.push_back({"g", "", {}, {common}, {}, 1, 0});
  EXPECT_EQ(ledger(program, program.functions[0]), (Ledger{1, 1, 0, 0, 0}));
  EXPECT_EQ(ledger(program, program.functions[1]), (Ledger{1, 0, 0, 0, 0}));
}

TEST(Ledger, text_names_adds_and_multiplies_always_and_others_where_there_are_any) {
  EXPECT_EQ(text(Ledger{}), "0 add, 0 multiply");
  EXPECT_EQ(text(Ledger{5, 4, 3, 2, 1}), "5 add, 4 multiply, 3 divide, 2 square root, 1 sine or cosine");
}

TEST(Evaluate, reads_every_group_of_arguments) {
  SmallProgram b;
  const Program program = b.with(
      {b.p(0), b.x(1), b.variable(Group::y, 0), b.variable(Group::ydot, 1), -b.variable(Group::input, 0), b.c(0.5)});
  EXPECT_THAT(evaluate(program, program.functions[0], Arguments<double>{{1}, {0, 2}, {3}, {0, 4}, {5}}),
              ElementsAre(1, 2, 3, 4, -5, 0.5));
}

TEST(Evaluate, puts_blocks_where_the_placements_say_and_zero_elsewhere) {
  SmallProgram b;
  Program program;
  Function function{"f", "", {}, {}, {{0, 1}}, 12, 4};  // one block in a 3 × 4 matrix
  for (int i = 1; i <= 9; ++i) function.outputs.push_back(b.c(i));
  program = {{}, b.nodes(), {function}};
  EXPECT_THAT(evaluate(program, function, Arguments<double>{}), ElementsAre(0, 1, 2, 3, 0, 4, 5, 6, 0, 7, 8, 9));
}

TEST(Evaluate, leaves_alone_what_the_function_does_not_need) {
  SmallProgram b;
  b.x(100);  // of a group that is empty below
  EXPECT_THAT(evaluate(b.with({b.c(2)}), b.with({b.c(2)}).functions[0], Arguments<double>{}), ElementsAre(2));
}

}  // namespace
}  // namespace kanec::program
