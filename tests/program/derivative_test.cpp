// Derivatives written down as operations. Oracle: dual numbers, which differentiate while they evaluate.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/derivative.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "generator/program/evaluate.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "tests/program/small_program.hpp"
#include "tests/support/dual.hpp"
#include "tests/support/random.hpp"

namespace kanec::program {
namespace {

using Dual = test::Dual<double>;
using test::Random;

constexpr int nx = 3;  // variables of the programs below: x, and time

// Columns of a Jacobian by each of x and by time.
std::vector<Column> columns(Builder& builder) {
  std::vector<Column> result;
  for (Index i = 0; i < nx; ++i) result.push_back({{{Group::x, i}, builder.constant(1.0)}});
  result.push_back({{{Group::time, 0}, builder.constant(1.0)}});
  return result;
}

Arguments<Dual> along(const Arguments<double>& at, int column) {
  Arguments<Dual> dual;
  for (int i = 0; i < nx; ++i) dual.x.push_back({at.x[static_cast<std::size_t>(i)], i == column ? 1.0 : 0.0});
  dual.time = {at.time, column == nx ? 1.0 : 0.0};
  return dual;
}

Program with_jacobian(SmallProgram& b, const std::vector<Ref>& outputs) {
  const std::vector<Column> by = columns(b);
  Program program = b.with(outputs);
  program.functions.push_back(jacobian(program, program.functions[0], by));
  program.functions[1].name = "f_x";
  check(program);
  return program;
}

// Both are a few roundings from the truth, enlarged by the conditioning of what they compute: relative to the largest.
void expect_jacobian(const Program& program, const Arguments<double>& at) {
  const std::vector<double> found = evaluate(program, program.functions[1], at);
  const std::size_t n_rows = program.functions[0].outputs.size();
  ASSERT_EQ(found.size(), n_rows * (nx + 1));
  for (int j = 0; j <= nx; ++j) {
    const std::vector<Dual> expected = evaluate(program, program.functions[0], along(at, j));
    for (std::size_t i = 0; i < n_rows; ++i) {
      const double rate = expected[i].rate;
      EXPECT_NEAR(found[i * (nx + 1) + static_cast<std::size_t>(j)], rate, 1e-11 * std::max(1.0, std::abs(rate)))
          << "row " << i << ", column " << j;
    }
  }
}

struct Rule {
  const char* name;
  std::function<Ref(SmallProgram&, Ref, Ref)> make;  // of two results between 0.1 and 0.9
  friend void PrintTo(const Rule& rule, std::ostream* out) { *out << rule.name; }
};

Rule unary(const char* name, Unary function) {
  return {name, [function](SmallProgram& b, Ref u, Ref) { return b.call(function, u); }};
}
Rule binary(const char* name, Binary function) {
  return {name, [function](SmallProgram& b, Ref u, Ref v) { return b.call(function, u, v); }};
}

class EveryRule : public testing::TestWithParam<Rule> {};

INSTANTIATE_TEST_SUITE_P(
    Rules, EveryRule,
    testing::Values(Rule{"sum", [](SmallProgram& b, Ref u, Ref v) { return b.add(u, v); }},
                    Rule{"difference", [](SmallProgram& b, Ref u, Ref v) { return b.subtract(u, v); }},
                    Rule{"product", [](SmallProgram& b, Ref u, Ref v) { return b.multiply(u, v); }},
                    Rule{"quotient", [](SmallProgram& b, Ref u, Ref v) { return b.divide(u, v); }},
                    Rule{"reciprocal", [](SmallProgram& b, Ref u, Ref) { return b.divide(b.c(1), u); }},
                    Rule{"square_root", [](SmallProgram& b, Ref u, Ref) { return b.square_root(u); }},
                    Rule{"sine", [](SmallProgram& b, Ref u, Ref) { return b.sine(u); }},
                    Rule{"cosine", [](SmallProgram& b, Ref u, Ref) { return b.cosine(-u); }}, unary("tan", Unary::tan),
                    unary("asin", Unary::asin), unary("acos", Unary::acos), unary("exp", Unary::exp),
                    unary("log", Unary::log), unary("abs", Unary::abs), unary("tanh", Unary::tanh),
                    Rule{"abs_of_a_negative",
                         [](SmallProgram& b, Ref u, Ref v) {
                           return b.call(Unary::abs, b.subtract(b.multiply(u, v), b.c(1)));
                         }},
                    binary("atan2", Binary::atan2), binary("min", Binary::min), binary("max", Binary::max),
                    binary("pow", Binary::pow),
                    Rule{"whole_power", [](SmallProgram& b, Ref u, Ref) { return b.call(Binary::pow, u, b.c(-3)); }},
                    Rule{"real_power", [](SmallProgram& b, Ref u, Ref) { return b.call(Binary::pow, u, b.c(2.7)); }},
                    Rule{"selection", [](SmallProgram& b, Ref u,
                                         Ref v) { return b.select(b.subtract(u, v), b.multiply(u, u), -v); }}),
    [](const auto& rule) { return std::string(rule.param.name); });

TEST_P(EveryRule, gives_the_rate_of_dual_numbers) {
  SmallProgram b;
  // u = sin(x0 x1 + t)² scaled into (0.1, 0.9), v likewise of x2: the chain rule on either side
  const Ref t = b.variable(Group::time, 0);
  const auto within = [&](Ref a) { return b.add(b.c(0.5), b.multiply(b.c(0.4), b.sine(a))); };
  const Ref u = within(b.add(b.multiply(b.x(0), b.x(1)), t));
  const Ref v = within(b.multiply(b.x(2), b.x(1)));
  const Ref result = GetParam().make(b, u, v);
  const Program program = with_jacobian(b, {result, b.multiply(-result, u)});
  Random random(1);
  for (int i = 0; i < 20; ++i) {
    Arguments<double> at;
    for (int j = 0; j < nx; ++j) at.x.push_back(random.uniform(-2, 2));
    at.time = random.uniform(0, 5);
    expect_jacobian(program, at);
    expect_jacobian(optimized(program), at);
  }
}

// Long chains of every operation, of values kept near 1.
Program random_chains(Random& random, int n_nodes) {
  SmallProgram b;
  std::vector<Ref> list = {b.x(0), b.x(1), b.x(2), b.variable(Group::time, 0), b.c(0.5)};
  const auto any = [&] {
    const int n = static_cast<int>(list.size());
    const Ref ref = list[static_cast<std::size_t>(n - 1 - random.below(std::min(n, 9)))];
    return random.chance(0.3) ? -ref : ref;
  };
  const auto above_one = [&](Ref a) { return b.add(b.c(1), b.multiply(a, a)); };
  for (int i = 0; i < n_nodes; ++i) {
    const Ref u = any(), v = any();
    const std::function<Ref()> kinds[] = {
        [&] { return b.multiply(b.c(0.6), b.add(u, v)); },
        [&] { return b.multiply(b.c(0.6), b.subtract(u, v)); },
        [&] { return b.multiply(b.sine(u), v); },
        [&] { return b.divide(u, above_one(v)); },
        [&] { return b.cosine(u); },
        [&] { return b.square_root(above_one(u)); },
        [&] { return b.call(Unary::log, above_one(u)); },
        [&] { return b.call(Unary::exp, b.call(Unary::tanh, u)); },
        [&] { return b.call(Unary::abs, u); },
        [&] { return b.call(Binary::min, u, v); },
        [&] { return b.call(Binary::max, u, v); },
        [&] { return b.call(Binary::atan2, u, above_one(v)); },
        [&] { return b.call(Binary::pow, above_one(u), b.call(Unary::tanh, v)); },
    };
    list.push_back(kinds[random.below(std::size(kinds))]());
  }
  return with_jacobian(b, {list.end() - 5, list.end()});
}

TEST(Jacobian, of_long_random_programs_has_the_rates_of_dual_numbers) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    Random random(seed);
    const Program program = random_chains(random, 60);
    Arguments<double> at;
    for (int j = 0; j < nx; ++j) at.x.push_back(random.uniform(-1, 1));
    at.time = random.uniform(0, 2);
    expect_jacobian(program, at);
    expect_jacobian(optimized(program), at);
    if (HasFailure()) return;
  }
}

TEST(Jacobian, along_a_direction_is_the_sum_of_columns_times_amounts) {
  SmallProgram b;
  const Ref product = b.multiply(b.x(0), b.x(1));
  Program program = b.with({product});
  const Column both = {{{Group::x, 0}, b.c(2)}, {{Group::x, 1}, b.x(2)}};
  program.nodes = b.nodes();
  program.functions.push_back(jacobian(program, program.functions[0], {both}));
  EXPECT_THAT(evaluate(program, program.functions[1], Arguments<double>{{}, {3, 5, 7}, {}, {}, {}}),
              testing::ElementsAre(2 * 5 + 7 * 3));
}

TEST(Jacobian, keeps_the_names_of_what_it_needs) {
  SmallProgram b;
  const Ref square = b.multiply(b.x(0), b.x(0));
  const Ref sum = b.add(square, b.x(1));
  const std::vector<Column> by = columns(b);
  Program program = b.with({b.multiply(square, sum)}, {square, sum});
  program.functions = {jacobian(program, program.functions[0], by)};
  const Program result = optimized(program);
  ASSERT_EQ(result.functions[0].quantities.size(), 2u);
  EXPECT_EQ(result.functions[0].quantities[1].name, "n2");
}

TEST(Tangents, of_what_does_not_depend_on_the_seed_are_zero_and_add_no_operation) {
  SmallProgram b;
  const Ref other = b.sine(b.divide(b.x(1), b.add(b.x(2), b.p(0))));
  const Ref linear = b.add(b.x(0), other);
  const std::size_t before = b.nodes().size();
  Tangents tangents(b);
  tangents.seed(Variable{Group::x, 0}, b.c(1));
  EXPECT_TRUE(tangents.is_zero(tangents.of(other)));
  EXPECT_FALSE(tangents.is_zero(tangents.of(linear)));
  EXPECT_TRUE(std::all_of(b.nodes().begin() + static_cast<std::ptrdiff_t>(before), b.nodes().end(),
                          [](const Node& node) { return std::holds_alternative<Constant>(node); }));
}

TEST(Tangents, of_tangents_are_second_derivatives) {
  SmallProgram b;
  const Ref t = b.variable(Group::time, 0);
  Tangents tangents(b);
  tangents.seed(Variable{Group::time, 0}, b.c(1));
  const Ref first = tangents.of(b.sine(b.multiply(b.c(3), t)));
  const Ref second = tangents.of(first);
  const Program program = b.with({first, second});
  Arguments<double> at;
  at.time = 0.4;
  const std::vector<double> found = evaluate(program, program.functions[0], at);
  EXPECT_DOUBLE_EQ(found[0], 3 * std::cos(1.2));
  EXPECT_DOUBLE_EQ(found[1], -9 * std::sin(1.2));
}

TEST(Tangents, by_a_result_take_it_as_independent) {
  SmallProgram b;
  const Ref angle = b.multiply(b.x(0), b.x(1));
  const Ref result = b.multiply(angle, b.x(0));
  Tangents tangents(b);
  tangents.seed(angle.node, b.x(2));
  const Program program = b.with({tangents.of(result)});
  EXPECT_THAT(evaluate(program, program.functions[0], Arguments<double>{{}, {3, 5, 7}, {}, {}, {}}),
              testing::ElementsAre(21));
}

// v |v| is differentiable at 0, where x / |x| would give no number.
TEST(Tangents, at_kinks_are_one_sided_and_numbers) {
  SmallProgram b;
  const Ref v = b.x(0);
  const Ref drag = b.multiply(v, b.call(Unary::abs, v));
  const Program program =
      with_jacobian(b, {drag, b.call(Unary::abs, v), b.call(Binary::max, v, b.c(0)), b.call(Binary::min, v, b.c(0))});
  const Arguments<double> at{{}, {0, 0, 0}, {}, {}, {}};
  const std::vector<double> at_zero = evaluate(program, program.functions[1], at);
  EXPECT_EQ(at_zero[0], 0);
  EXPECT_EQ(at_zero[4], 1);
  EXPECT_EQ(at_zero[8], 1);
  EXPECT_EQ(at_zero[12], 1);
}

// max(0.1, sqrt(x)) at x = 0: the slope of what is not selected is infinite.
TEST(Tangents, of_a_selection_do_not_feel_what_is_not_selected) {
  SmallProgram b;
  const Program program = with_jacobian(b, {b.call(Binary::max, b.c(0.1), b.square_root(b.x(0)))});
  for (const Program& each : {program, optimized(program)})
    EXPECT_EQ(evaluate(each, each.functions[1], Arguments<double>{{}, {0, 0, 0}, {}, {}, {}})[0], 0);
}

// A chain rule once a node: of a chain of n products and sines the derivative has a number of operations linear in n.
TEST(Tangents, cost_a_few_operations_a_node) {
  SmallProgram b;
  Ref chain = b.x(0);
  constexpr int n = 5000;  // longer than a stack of recursive calls would like
  for (int i = 0; i < n; ++i) chain = b.sine(b.multiply(chain, b.x(1)));
  const Program program = with_jacobian(b, {chain});
  const Ledger cost = ledger(program, program.functions[1]);
  EXPECT_LE(cost.operations(), (nx - 1) * 4 * n);
}

}  // namespace
}  // namespace kanec::program
