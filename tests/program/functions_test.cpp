// Functions of one and two arguments, and selections, in builder, passes and evaluation. Oracles: the standard library,
// and rules of arithmetic case by case.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <string>

#include "generator/program/evaluate.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using testing::ElementsAre;

std::vector<double> values(const Program& program, const std::vector<double>& x) {
  Arguments<double> at;
  at.x = x;
  return evaluate(program, program.functions[0], at);
}

TEST(Functions, are_those_of_the_standard_library) {
  SmallProgram b;
  const Ref u = b.x(0), v = b.x(1);
  std::vector<Ref> outputs;
  for (const Unary f : {Unary::tan, Unary::asin, Unary::acos, Unary::exp, Unary::log, Unary::abs, Unary::tanh})
    outputs.push_back(b.call(f, u));
  for (const Binary f : {Binary::atan2, Binary::min, Binary::max, Binary::pow}) outputs.push_back(b.call(f, u, v));
  const double s = 0.3, t = 0.8;
  EXPECT_THAT(values(b.with(outputs), {s, t}),
              ElementsAre(std::tan(s), std::asin(s), std::acos(s), std::exp(s), std::log(s), s, std::tanh(s),
                          std::atan2(s, t), s, t, std::pow(s, t)));
}

TEST(Functions, of_negatives_are_those_of_the_value) {
  SmallProgram b;
  const Ref u = b.x(0), v = b.x(1);
  std::vector<Ref> outputs;
  for (const Unary f : {Unary::tan, Unary::asin, Unary::acos, Unary::exp, Unary::abs, Unary::tanh})
    outputs.push_back(b.call(f, -u));
  for (const Binary f : {Binary::atan2, Binary::min, Binary::max}) {
    outputs.push_back(b.call(f, -u, v));
    outputs.push_back(b.call(f, u, -v));
    outputs.push_back(b.call(f, -u, -v));
  }
  outputs.push_back(b.call(Binary::pow, u, -v));
  const double s = 0.3, t = 0.8;
  EXPECT_THAT(values(b.with(outputs), {s, t}),
              ElementsAre(std::tan(-s), std::asin(-s), std::acos(-s), std::exp(-s), s, std::tanh(-s),  //
                          std::atan2(-s, t), std::atan2(s, -t), std::atan2(-s, -t),                    //
                          -s, -t, -t, t, s, -s, std::pow(s, -t)));
}

// By the standard: the argument's sign may be taken out of odd functions, dropped from even ones.
TEST(Functions, of_negatives_cost_an_operation_only_where_they_are_neither_odd_nor_even) {
  const auto adds = [](const std::function<Ref(SmallProgram&)>& make) {
    SmallProgram b;
    const Ref result = make(b);
    return ledger(b.with({result}), b.with({result}).functions[0]).adds;
  };
  for (const Unary f : {Unary::tan, Unary::asin, Unary::abs, Unary::tanh})
    EXPECT_EQ(adds([f](SmallProgram& b) { return b.call(f, -b.x(0)); }), 0) << name(f);
  for (const Unary f : {Unary::acos, Unary::exp, Unary::log})
    EXPECT_EQ(adds([f](SmallProgram& b) { return b.call(f, -b.x(0)); }), 1) << name(f);
  EXPECT_EQ(adds([](SmallProgram& b) { return b.call(Binary::min, -b.x(0), -b.x(1)); }), 0);
  EXPECT_EQ(adds([](SmallProgram& b) { return b.call(Binary::atan2, -b.x(0), b.x(1)); }), 0);
  EXPECT_EQ(adds([](SmallProgram& b) { return b.call(Binary::max, b.x(0), -b.c(2)); }), 0);
  EXPECT_EQ(adds([](SmallProgram& b) { return b.select(b.x(0), -b.x(1), -b.x(2)); }), 0);
}

TEST(Select, takes_the_first_where_the_sign_is_negative) {
  SmallProgram b;
  const Program program = b.with({b.select(b.x(0), b.x(1), b.x(2)), b.select(-b.x(0), -b.x(1), b.x(2))});
  EXPECT_THAT(values(program, {-1, 5, 7}), ElementsAre(5, 7));
  EXPECT_THAT(values(program, {0, 5, 7}), ElementsAre(7, 7));
  EXPECT_THAT(values(program, {1, 5, 7}), ElementsAre(7, -5));
}

Program simplified(const std::function<Ref(SmallProgram&)>& make) {
  SmallProgram b;
  const Ref result = make(b);
  return drop_dead(simplify(b.with({result})));
}

TEST(Simplify, functions_at_zero_and_one_where_the_result_is_exact) {
  const auto expect = [](double wanted, const std::function<Ref(SmallProgram&)>& make) {
    const Program program = simplified(make);
    ASSERT_EQ(program.nodes.size(), 1u);
    EXPECT_EQ(values(program, {})[0], wanted);
  };
  expect(0, [](SmallProgram& b) { return b.sine(b.c(0)); });
  expect(1, [](SmallProgram& b) { return b.cosine(b.c(0)); });
  expect(1, [](SmallProgram& b) { return b.square_root(b.c(1)); });
  for (const Unary f : {Unary::tan, Unary::asin, Unary::tanh})
    expect(0, [f](SmallProgram& b) { return b.call(f, b.c(0)); });
  expect(1, [](SmallProgram& b) { return b.call(Unary::exp, b.c(0)); });
  expect(0, [](SmallProgram& b) { return b.call(Unary::log, b.c(1)); });
  expect(0, [](SmallProgram& b) { return b.call(Unary::acos, b.c(1)); });
  expect(3, [](SmallProgram& b) { return b.call(Unary::abs, b.c(-3)); });
  expect(-2, [](SmallProgram& b) { return b.call(Binary::min, b.c(5), b.c(-2)); });
  expect(5, [](SmallProgram& b) { return b.call(Binary::max, b.c(5), b.c(-2)); });
  expect(0, [](SmallProgram& b) { return b.call(Binary::atan2, b.c(0), b.c(2)); });
  expect(1, [](SmallProgram& b) { return b.call(Binary::pow, b.x(0), b.c(0)); });
  expect(-5, [](SmallProgram& b) { return b.select(b.c(-1), b.c(-5), b.x(0)); });
}

TEST(Simplify, functions_of_other_constants_are_left_to_the_machine) {
  EXPECT_EQ(count<UnaryCall>(simplified([](SmallProgram& b) { return b.call(Unary::exp, b.c(1)); })), 1);
  EXPECT_EQ(count<BinaryCall>(simplified([](SmallProgram& b) { return b.call(Binary::atan2, b.c(0), b.c(-2)); })), 1);
  EXPECT_EQ(count<BinaryCall>(simplified([](SmallProgram& b) { return b.call(Binary::pow, b.c(2), b.c(0.3)); })), 1);
}

TEST(Simplify, powers_with_small_whole_exponents_become_products) {
  const auto power = [](double exponent) {
    return simplified([exponent](SmallProgram& b) { return b.call(Binary::pow, b.x(0), b.c(exponent)); });
  };
  const auto cost = [&](double exponent) { return ledger(power(exponent), power(exponent).functions[0]); };
  for (int n = -8; n <= 8; ++n) {
    EXPECT_EQ(count<BinaryCall>(power(n)), 0) << n;
    EXPECT_DOUBLE_EQ(values(power(n), {1.7})[0], std::pow(1.7, n)) << n;
  }
  EXPECT_EQ(cost(2), (Ledger{0, 1, 0, 0, 0, 0}));
  EXPECT_EQ(cost(-8), (Ledger{0, 3, 1, 0, 0, 0}));
  EXPECT_EQ(cost(0.5), (Ledger{0, 0, 0, 1, 0, 0}));
  EXPECT_EQ(cost(9), (Ledger{0, 0, 0, 0, 0, 1}));
  EXPECT_EQ(cost(2.5), (Ledger{0, 0, 0, 0, 0, 1}));
}

TEST(Share, tells_functions_apart_and_lets_extrema_commute) {
  SmallProgram b;
  const Ref u = b.x(0), v = b.x(1);
  const Program program =
      share(b.with({b.call(Unary::exp, u), b.call(Unary::log, u), b.call(Unary::exp, u), b.call(Binary::min, u, v),
                    b.call(Binary::min, v, u), b.call(Binary::max, u, v), b.call(Binary::pow, u, v),
                    b.call(Binary::pow, v, u), b.select(u, v, u), b.select(v, v, u), b.select(u, v, u)}));
  EXPECT_EQ(count<UnaryCall>(program), 2);
  EXPECT_EQ(count<BinaryCall>(program), 4);
  EXPECT_EQ(count<Select>(program), 2);
}

TEST(Ledger, counts_functions_and_selections_apart_from_sines_and_roots) {
  SmallProgram b;
  const Ref u = b.x(0);
  const Program program = b.with({b.select(u, b.call(Unary::exp, u), b.call(Binary::pow, u, b.sine(u)))});
  EXPECT_EQ(ledger(program, program.functions[0]), (Ledger{0, 0, 0, 0, 1, 3}));
  EXPECT_EQ(text(ledger(program, program.functions[0])), "0 add, 0 multiply, 1 sine or cosine, 3 other function");
}

TEST(Stages, what_depends_on_time_is_of_the_state) {
  SmallProgram b;
  const Ref wave = b.sine(b.multiply(b.p(0), b.variable(Group::time, 0)));
  EXPECT_EQ(stages(b.with({wave}))[static_cast<std::size_t>(wave.node)], Stage::state);
}

TEST(Evaluate, reads_the_time) {
  SmallProgram b;
  const Program program = b.with({b.variable(Group::time, 0)});
  Arguments<double> at;
  at.time = 2.5;
  EXPECT_THAT(evaluate(program, program.functions[0], at), ElementsAre(2.5));
}

}  // namespace
}  // namespace kanec::program
