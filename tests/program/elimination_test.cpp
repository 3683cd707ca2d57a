// Jacobians by elimination. Oracles: forward differentiation, and programs whose best order is known.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/elimination.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "generator/program/evaluate.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "tests/program/random_program.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using test::Field;

constexpr Order orders[] = {Order::outputs_first, Order::fewest_products};

std::vector<Column> by_x(Builder& builder, Index nx) {
  std::vector<Column> columns;
  for (Index i = 0; i < nx; ++i) columns.push_back({{{Group::x, i}, builder.constant(1.0)}});
  return columns;
}

// The chain rule holds for any functions that are taken for the partial derivatives, and so in a prime field: exactly.
TEST(Elimination, in_every_order_gives_the_entries_of_forward_differentiation) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    test::Random random(seed);
    const Program program = test::random_program(random, 80);
    Builder builder;
    builder.nodes() = program.nodes;
    std::vector<Column> columns = by_x(builder, 4);
    columns[1].push_back({{Group::y, 2}, builder.variable(Group::parameter, 1)});
    Function forward = program.functions[0];
    forward.outputs.clear();
    std::vector<std::vector<Ref>> of_column;
    for (const Column& column : columns) {
      Tangents tangents(builder);
      for (const Direction& direction : column) tangents.seed(direction.variable, direction.amount);
      of_column.emplace_back();
      for (const Ref output : program.functions[0].outputs) of_column.back().push_back(tangents.of(output));
    }
    for (std::size_t i = 0; i < program.functions[0].outputs.size(); ++i)
      for (const std::vector<Ref>& column : of_column) forward.outputs.push_back(column[i]);
    Function other = forward;
    for (const Order order : orders) {
      other.outputs = jacobian_entries(builder, program.functions[0].outputs, columns, order);
      const Program both{{}, builder.nodes(), {forward, other}};
      check(both);
      const Arguments<Field> at = test::random_arguments(random);
      ASSERT_EQ(evaluate(both, other, at), evaluate(both, forward, at)) << "seed " << seed;
    }
  }
}

int cost(const Program& program, const Function& function) {
  const Program alone = optimized({{}, program.nodes, {function}});
  return ledger(alone, alone.functions[0]).operations();
}

// x0 x1 … x9, whose gradient backwards costs about three times the product, column by column n times.
TEST(Jacobian, of_one_result_by_many_variables_is_that_of_reverse_differentiation) {
  constexpr Index n = 10;
  SmallProgram b;
  Ref product = b.x(0);
  for (Index i = 1; i < n; ++i) product = b.multiply(product, b.x(i));
  const std::vector<Column> columns = by_x(b, n);
  Program program = b.with({product});
  const Function gradient = jacobian(program, program.functions[0], columns);
  EXPECT_LE(cost(program, gradient), 3 * (n - 1));
}

// sin(y_i s), s = sin(a · x): from n variables through one result to m. Column by column 2 n m + n products, and n m +
// n + m where the derivatives of the m by s are formed first.
TEST(Jacobian, through_one_result_passes_by_it_once) {
  constexpr Index n = 6, m = 6;
  SmallProgram b;
  Ref sum = b.multiply(b.p(0), b.x(0));
  for (Index i = 1; i < n; ++i) sum = b.add(sum, b.multiply(b.p(i), b.x(i)));
  const Ref wave = b.sine(sum);
  std::vector<Ref> outputs;
  for (Index i = 0; i < m; ++i) outputs.push_back(b.sine(b.multiply(b.variable(Group::y, i), wave)));
  const std::vector<Column> columns = by_x(b, n);
  Program program = b.with(outputs);
  const Function found = jacobian(program, program.functions[0], columns);
  const int of_arguments = n + (n - 1) + m;
  EXPECT_LE(cost(program, found), of_arguments + n * m + n + m);
}

// Of operations of every kind, each made once.
int total(const Program& program) {
  const Program shared = share(program);
  const Ledger count = ledger(shared, shared.functions[0]);
  return count.operations() + count.square_roots + count.trigonometric + count.functions;
}

TEST(Jacobian, never_costs_more_than_column_by_column) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    test::Random random(seed);
    Program program = test::random_program(random, 100);
    const Function& function = program.functions[0];
    Builder builder;
    builder.nodes() = program.nodes;
    const std::vector<Column> columns = by_x(builder, 4);
    program.nodes = builder.nodes();
    Function forward = function;
    forward.outputs.clear();
    for (const Column& column : columns) {
      Tangents tangents(builder);
      tangents.seed(column[0].variable, column[0].amount);
      for (const Ref output : function.outputs) forward.outputs.push_back(tangents.of(output));
    }
    const Program by_columns{{}, builder.nodes(), {forward}};
    const Function found = jacobian(program, Function(function), columns);
    EXPECT_LE(total({{}, program.nodes, {found}}), total(by_columns)) << "seed " << seed;
  }
}

}  // namespace
}  // namespace kanec::program
