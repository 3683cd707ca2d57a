// Oracle: programs whose needed nodes are known.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/program/passes.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using testing::ElementsAre;

TEST(DropDead, operations_that_no_output_needs_go) {
  SmallProgram b;
  const Ref kept = b.add(b.x(0), b.x(1));
  b.multiply(kept, b.square_root(b.p(0)));
  const Program program = drop_dead(b.with({kept}));
  EXPECT_EQ(program.nodes.size(), 3u);
  EXPECT_EQ(count<Add>(program), 1);
}

TEST(DropDead, quantities_lose_what_is_not_needed_and_go_when_nothing_is_left) {
  SmallProgram b;
  const Ref kept = b.add(b.x(0), b.x(1));
  const Ref lost = b.multiply(b.x(0), b.x(1));
  Program program = b.with({kept}, {lost});
  program.functions[0].quantities.push_back(
      {"v", {"v_1", "v_2", "v_3"}, {lost, -kept, lost}, 0, Pass::outward, "", ""});
  const Program trimmed = drop_dead(program);
  const auto& quantities = trimmed.functions[0].quantities;
  ASSERT_EQ(quantities.size(), 1u);
  EXPECT_THAT(quantities[0].labels, ElementsAre("v_2"));
  EXPECT_THAT(quantities[0].entries, ElementsAre(-output(trimmed)));
}

TEST(DropDead, a_quantity_of_one_function_is_not_kept_for_another) {
  SmallProgram b;
  const Ref first = b.add(b.x(0), b.x(1));
  const Ref second = b.multiply(b.x(0), b.x(1));
  Program program = b.with({first}, {first, second});
  program.functions.push_back({"g", "", program.functions[0].quantities, {second}, {}, 1, 0});
  const Program trimmed = drop_dead(program);
  ASSERT_EQ(trimmed.functions[0].quantities.size(), 1u);
  ASSERT_EQ(trimmed.functions[1].quantities.size(), 1u);
  EXPECT_EQ(trimmed.functions[0].quantities[0].name, "n1");
  EXPECT_EQ(trimmed.functions[1].quantities[0].name, "n2");
}

}  // namespace
}  // namespace kanec::program
