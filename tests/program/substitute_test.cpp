// Arguments replaced by results. Oracle: the function at these results' values, exactly in a prime field.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/substitute.hpp"

#include <gtest/gtest.h>

#include "generator/program/builder.hpp"
#include "generator/program/evaluate.hpp"
#include "tests/program/field.hpp"

namespace kanec::program {
namespace {

using test::Field;
using test::Random;

// f = (x0 - ẏ0) (ẏ1 x1) with a quantity x0 - ẏ0, and g0 = -x0 x1, g1 = x1.
struct Sample {
  Sample() {
    Builder builder;
    const auto x = [&](Index i) { return builder.variable(Group::x, i); };
    const auto ydot = [&](Index i) { return builder.variable(Group::ydot, i); };
    const Ref difference = builder.subtract(x(0), ydot(0));
    const Ref product = builder.multiply(difference, builder.multiply(ydot(1), x(1)));
    Quantity named;
    named.entries = {difference};
    function = {"f", "", {named}, {product, -difference, x(1)}, {}, 3};
    results = {-builder.multiply(x(0), x(1)), x(1)};
    program.nodes = builder.nodes();
  }
  std::vector<Field> at(const std::vector<Ref>& outputs, const std::vector<Field>& x,
                        const std::vector<Field>& ydot) const {
    Function some = function;
    some.outputs = outputs;
    return evaluate(program, some, Arguments<Field>{{}, x, {}, ydot, {}, Field(0.0)});
  }
  Program program;
  Function function;
  std::vector<Ref> results;
};

TEST(Substitute, gives_the_function_at_the_results) {
  Sample s;
  const Function composed = substituted(s.program, s.function, Group::ydot, s.results);
  Random random(5);
  const std::vector<Field> x = {Field::random(random), Field::random(random)};
  const std::vector<Field> ydot = {-(x[0] * x[1]), x[1]};
  EXPECT_EQ(s.at(composed.outputs, x, {}), s.at(s.function.outputs, x, ydot));
  EXPECT_EQ(s.at({composed.quantities[0].entries[0]}, x, {}), s.at({s.function.quantities[0].entries[0]}, x, ydot));
  check(s.program);
}

TEST(Substitute, leaves_alone_what_does_not_depend_on_the_argument) {
  Sample s;
  const std::size_t before = s.program.nodes.size();
  const Function composed = substituted(s.program, s.function, Group::ydot, s.results);
  EXPECT_EQ(composed.outputs[2], s.function.outputs[2]);
  EXPECT_EQ(s.program.nodes.size(), before + 3);  // a difference and two products
}

}  // namespace
}  // namespace kanec::program
