// Oracle: the functions that are combined, each evaluated alone.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/combined.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "runtime/base/error.hpp"
#include "tests/program/random_program.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using test::Field;
using testing::ElementsAre;
using testing::ThrowsMessage;

TEST(Combined, has_the_outputs_of_its_parts_one_after_another) {
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    test::Random random(seed);
    Program program = test::random_program(random, 120);
    const std::vector<std::string> names = {"second", "placed", "first"};
    program.functions.push_back(combined(program, names));
    const Arguments<Field> at = test::random_arguments(random);
    std::vector<Field> expected;
    for (const std::string& name : names)
      for (const Function& function : program.functions)
        if (function.name == name)
          for (const Field value : evaluate(program, function, at)) expected.push_back(value);
    EXPECT_EQ(evaluate(program, program.functions.back(), at), expected) << "seed " << seed;
    const Program passed = optimized(program);
    EXPECT_EQ(evaluate(passed, passed.functions.back(), at), expected) << "seed " << seed;
  }
}

// Two functions with one quantity in common, one of its own each, and one name for two things.
Program two_functions() {
  SmallProgram b;
  const Ref common = b.sine(b.multiply(b.x(0), b.x(1)));
  const Ref only_f = b.add(common, b.x(0));
  const Ref only_g = b.multiply(common, b.x(1));
  Program program = b.with({only_f});
  const auto quantity = [](const std::string& name, Ref ref) {
    return Quantity{name, {name}, {ref}, 0, Pass::outward, "", ""};
  };
  program.functions[0].quantities = {quantity("common", common), quantity("own", only_f)};
  program.functions.push_back({"g", "the other", {}, {only_g}, {}, 1, 0});
  program.functions[1].quantities = {quantity("common", common), quantity("own", only_g)};
  program.functions[0].signature = {true, false, false, false, "a", "a (1)"};
  program.functions[1].signature = {false, true, false, true, "a", "b (1)"};
  return program;
}

TEST(Combined, computes_what_its_parts_have_in_common_once) {
  Program program = two_functions();
  const Function both = combined(program, {"f", "g"});
  EXPECT_EQ(ledger(program, both), (Ledger{1, 2, 0, 0, 1}));
  EXPECT_EQ(both.name, "f_and_g");
  EXPECT_EQ(both.n_out, 2);
}

TEST(Combined, merges_quantities_without_repeats_and_without_two_of_a_label) {
  Program program = two_functions();
  std::vector<std::string> labels;
  for (const Quantity& quantity : combined(program, {"f", "g"}).quantities)
    labels.insert(labels.end(), quantity.labels.begin(), quantity.labels.end());
  EXPECT_THAT(labels, ElementsAre("common", "own_g", "own"));
}

TEST(Combined, takes_the_arguments_of_all_and_returns_a_result_for_each) {
  Program program = two_functions();
  const Signature signature = combined(program, {"f", "g"}).signature;
  EXPECT_TRUE(signature.x && signature.y && signature.inputs && !signature.ydot);
  ASSERT_EQ(signature.results.size(), 2u);
  EXPECT_EQ(signature.results[0].out, "a");
  EXPECT_EQ(signature.results[1].out, "a_g");
  EXPECT_EQ(signature.results[1].layout, "b (1)");
}

TEST(Combined, of_an_unknown_function_is_refused) {
  Program program = two_functions();
  EXPECT_THAT([&] { combined(program, {"f", "h"}); }, ThrowsMessage<InternalError>("no function h in the program"));
}

// Quantities of a chain of hundreds of bodies are tens of thousands. The second list has every other one of the first,
// and one of its own behind each.
TEST(Combined, long_lists_of_quantities_keep_the_order_of_both) {
  constexpr Index n = 20'000;
  const auto quantity = [](const std::string& name, Index node) {
    return Quantity{name, {name}, {{node, false}}, 0, Pass::outward, "", ""};
  };
  std::vector<Quantity> list, more;
  std::vector<std::string> expected;
  for (Index i = 0; i < n; ++i) {
    list.push_back(quantity("a" + std::to_string(i), i));
    expected.push_back(list.back().name);
    if (i % 2 == 0) continue;
    more.push_back(list.back());
    more.push_back(quantity("b" + std::to_string(i), n + i));
    expected.push_back(more.back().name);
  }
  merge_quantities(list, more, "of_b");
  std::vector<std::string> names;
  for (const Quantity& each : list) names.push_back(each.name);
  EXPECT_EQ(names, expected);
}

}  // namespace
}  // namespace kanec::program
