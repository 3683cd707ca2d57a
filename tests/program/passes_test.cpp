// Every pass on random programs. Oracle: the program before the pass, evaluated exactly in a prime field, and its
// ledger.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/passes.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <ostream>
#include <string>

#include "generator/program/ledger.hpp"
#include "tests/program/random_program.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using test::Field;
using test::Random;

struct NamedPass {
  const char* name;
  Program (*apply)(Program);
  friend void PrintTo(const NamedPass& pass, std::ostream* out) { *out << pass.name; }
};

class EveryPass : public testing::TestWithParam<NamedPass> {
 protected:
  static constexpr int n_programs = 150;

  // Calls test(before, after, arguments) for many programs.
  template <class Test>
  void for_programs(Test test) const {
    for (int seed = 0; seed < n_programs; ++seed) {
      SCOPED_TRACE("seed " + std::to_string(seed));
      Random random(static_cast<std::uint64_t>(seed));
      const Program before = test::random_program(random, 20 + 2 * seed);
      test(before, GetParam().apply(before), test::random_arguments(random));
      if (HasFatalFailure()) return;
    }
  }
};

TEST_P(EveryPass, keeps_every_output) {
  for_programs([](const Program& before, const Program& after, const Arguments<Field>& arguments) {
    ASSERT_EQ(before.functions.size(), after.functions.size());
    for (std::size_t i = 0; i < before.functions.size(); ++i)
      ASSERT_EQ(evaluate(before, before.functions[i], arguments), evaluate(after, after.functions[i], arguments));
  });
}

// Operations of prepare() and of one call of each function.
int total(const Program& program) {
  int n = prepare_ledger(program).operations();
  for (const Function& function : program.functions) n += ledger(program, function).operations();
  return n;
}

// A sign taken out of an argument of a root or a function comes back as a subtraction; a power with a whole exponent up
// to 8 becomes at most four products and a quotient.
int possible_signs(const Ledger& ledger) { return ledger.square_roots + 5 * ledger.functions; }

TEST_P(EveryPass, never_raises_the_cost) {
  for_programs([](const Program& before, const Program& after, const Arguments<Field>&) {
    int signs = possible_signs(prepare_ledger(before));
    for (std::size_t i = 0; i < before.functions.size(); ++i) {
      const Ledger was = ledger(before, before.functions[i]);
      const Ledger is = ledger(after, after.functions[i]);
      ASSERT_LE(is.operations(), was.operations() + possible_signs(was));
      ASSERT_LE(is.divides, was.divides + was.functions);
      ASSERT_LE(is.square_roots, was.square_roots + was.functions);
      ASSERT_LE(is.trigonometric, was.trigonometric);
      ASSERT_LE(is.functions, was.functions);
      signs += possible_signs(was);
    }
    ASSERT_LE(total(after), total(before) + signs);
  });
}

TEST_P(EveryPass, leaves_a_program_that_passes_the_check) {
  for_programs([](const Program&, const Program& after, const Arguments<Field>&) { ASSERT_NO_THROW(check(after)); });
}

TEST_P(EveryPass, keeps_the_value_under_every_name_that_it_leaves) {
  for_programs([](const Program& before, const Program& after, const Arguments<Field>& arguments) {
    const auto was = test::entry_values(before, arguments);
    const auto is = test::entry_values(after, arguments);
    for (std::size_t i = 0; i < before.functions.size(); ++i) {
      std::map<std::string, Field> by_label;
      std::size_t at = 0;
      for (const Quantity& quantity : before.functions[i].quantities)
        for (const std::string& label : quantity.labels) by_label[label] = was[i][at++];
      at = 0;
      for (const Quantity& quantity : after.functions[i].quantities) {
        ASSERT_EQ(quantity.labels.size(), quantity.entries.size());
        for (const std::string& label : quantity.labels) ASSERT_EQ(is[i][at++], by_label.at(label)) << label;
      }
    }
  });
}

INSTANTIATE_TEST_SUITE_P(Passes, EveryPass,
                         testing::Values(NamedPass{"simplify", simplify}, NamedPass{"share", share},
                                         NamedPass{"share_sums", share_sums}, NamedPass{"order_terms", order_terms},
                                         NamedPass{"drop_dead", drop_dead}, NamedPass{"optimized", optimized}),
                         [](const auto& pass) { return std::string(pass.param.name); });

// Not promised where sums are re-associated.
TEST(Passes, find_nothing_more_to_do_in_their_own_result) {
  for (const auto pass : {simplify, share, drop_dead})
    for (std::uint64_t seed = 0; seed < 150; ++seed) {
      Random random(seed);
      const Program once = pass(test::random_program(random, 150));
      const Program twice = pass(once);
      for (std::size_t i = 0; i < once.functions.size(); ++i)
        ASSERT_EQ(ledger(twice, twice.functions[i]), ledger(once, once.functions[i])) << "seed " << seed;
    }
}

// But for divisions by zero, the sign of an argument, and functions without an exact result, left to the machine.
TEST(Optimized, holds_each_operation_once_and_none_on_constants) {
  for (std::uint64_t seed = 0; seed < 150; ++seed) {
    Random random(seed);
    const Program program = optimized(test::random_program(random, 200));
    const std::vector<bool> alive = reachable(program);
    const auto constant = [&](Index i) { return std::get_if<Constant>(&program.nodes[static_cast<std::size_t>(i)]); };
    for (std::size_t i = 0; i < program.nodes.size(); ++i) {
      ASSERT_TRUE(alive[i]) << "seed " << seed;
      const Operands from = operands(program.nodes[i]);
      const bool all = std::all_of(from.at, from.at + from.count, [&](Index a) { return constant(a) != nullptr; });
      if (from.count < 2 || !all) continue;
      const bool by_zero = std::holds_alternative<Divide>(program.nodes[i]);
      const bool sign =
          std::holds_alternative<Subtract>(program.nodes[i]) && constant(from.at[0])->value == Number(0.0);
      const bool inexact = std::holds_alternative<BinaryCall>(program.nodes[i]);
      ASSERT_TRUE(by_zero || sign || inexact) << "seed " << seed;
    }
    EXPECT_EQ(share(program).nodes.size(), program.nodes.size()) << "seed " << seed;
  }
}

// What 512 free bodies on the inertial frame make of the mass matrix: millions of zeros, which no pass carries along.
TEST(Optimized, every_place_of_a_large_matrix_keeps_its_entry) {
  SmallProgram b;
  const Ref zero = b.c(0), entry = b.multiply(b.x(0), b.add(b.x(1), b.c(0))), other = b.add(b.x(2), b.x(0));
  std::vector<Ref> matrix(3'000'000, zero);
  for (std::size_t i = 0; i < matrix.size(); i += 3000)
    matrix[i] = entry, matrix[i + 1] = -entry, matrix[i + 2] = other;
  const Program program = b.with(matrix);
  const Program passed = optimized(program);
  Random random(1);
  const Arguments<Field> at = test::random_arguments(random);
  EXPECT_EQ(evaluate(passed, passed.functions[0], at), evaluate(program, program.functions[0], at));
  EXPECT_EQ(ledger(passed, passed.functions[0]).operations(), 2);
}

}  // namespace
}  // namespace kanec::program
