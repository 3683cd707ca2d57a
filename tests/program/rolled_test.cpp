// A function as calls of section bodies. Oracle: the function evaluated as a straight line.
// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/rolled.hpp"

#include <gtest/gtest.h>

#include "generator/program/evaluate.hpp"
#include "generator/program/footprint.hpp"
#include "generator/program/passes.hpp"
#include "tests/program/random_program.hpp"
#include "tests/program/small_program.hpp"

namespace kanec::program {
namespace {

using test::Random;

// Values of all nodes, for those that depend on parameters only.
template <class T>
std::vector<T> all_values(const Program& program, const Arguments<T>& at) {
  Function every{"every", "", {}, {}, {}, 0, 0, {}};
  for (std::size_t i = 0; i < program.nodes.size(); ++i) every.outputs.push_back({static_cast<Index>(i), false});
  return evaluate(program, every, at);
}

template <class T>
class Evaluation {
 public:
  Evaluation(const Program& program, const Rolled& rolled, const Arguments<T>& at, std::size_t n_outputs)
      : rolled_(rolled),
        at_(at),
        values_(all_values(program, at)),
        outputs_(n_outputs, T(0.0)),
        frames_(static_cast<std::size_t>(rolled.frames_size), T(0.0)) {
    for (const Step& step : rolled.steps) call(rolled.classes[step.of], step.member);
  }

  const std::vector<T>& outputs() const { return outputs_; }

 private:
  T& place(Index body, Index field) {
    const Index begin = rolled_.begins.at(static_cast<std::size_t>(body));
    return frames_.at(static_cast<std::size_t>(begin + rolled_.slots.at(static_cast<std::size_t>(field))));
  }

  T value(const Leaf& leaf, std::size_t m) {
    const Index place_of = leaf.places[m];
    switch (leaf.kind) {
      case LeafKind::constant:
        return T(leaf.numbers[m].rounded());
      case LeafKind::x:
        return at_[{Group::x, place_of}];
      case LeafKind::y:
        return at_[{Group::y, place_of}];
      case LeafKind::ydot:
        return at_[{Group::ydot, place_of}];
      case LeafKind::input:
        return at_[{Group::input, place_of}];
      case LeafKind::time:
        return at_.time;
      case LeafKind::prepared:
        return values_[static_cast<std::size_t>(place_of)];
      case LeafKind::frame:
        return place(place_of, leaf.fields[m]);
    }
    throw InternalError("no such leaf");
  }

  void call(const SectionClass& kind, std::size_t m) {
    Arguments<T> leaves;
    for (const Leaf& leaf : kind.leaves) leaves.x.push_back(value(leaf, m));
    const std::vector<T> results = evaluate(kind.body, kind.body.functions[0], leaves);
    for (std::size_t i = 0; i < kind.outputs.size(); ++i) outputs_[kind.outputs[i].places[m]] = results[i];
    const Index body = std::max(kind.bodies[m], 0);
    for (std::size_t i = 0; i < kind.kept.size(); ++i)
      place(body, kind.kept[i].field) = results[kind.outputs.size() + i];
  }

  const Rolled& rolled_;
  const Arguments<T>& at_;
  std::vector<T> values_, outputs_, frames_;
};

TEST(Rolled, gives_the_values_of_the_straight_line_for_random_programs) {
  int n_functions = 0;
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    Random random(seed);
    const Program program = optimized(test::random_program(random, 120));
    const Arguments<test::Field> at = test::random_arguments(random);
    for (const Function& function : program.functions) {
      const std::optional<Rolled> loops = rolled(program, function);
      EXPECT_EQ(loops.has_value(), function.placements.empty());
      if (!loops) continue;
      ++n_functions;
      for (const SectionClass& kind : loops->classes) check(kind.body);
      EXPECT_EQ(Evaluation(program, *loops, at, function.outputs.size()).outputs(), evaluate(program, function, at))
          << seed;
    }
  }
  EXPECT_GT(n_functions, 50);
}

// v_K = c_K v_L + sin(x_K), with v_1 = sin(x_1) and the last one the output; c_K different for each body.
Program chain(int n) {
  SmallProgram p;
  Function function{"f", "", {}, {}, {}, 1, 0, {}};
  Ref v;
  for (int k = 1; k <= n; ++k) {
    const Ref s = p.sine(p.x(k - 1));
    v = k == 1 ? s : p.add(p.multiply(p.c(0.25 + k), v), s);
    const std::string name = "v" + std::to_string(k);
    function.quantities.push_back({name, {name}, {v}, k, Pass::outward, name + " = ..", ""});
  }
  function.outputs = {v};
  return {{}, p.nodes(), {function}};
}

TEST(Rolled, writes_sections_once_that_differ_in_constants_and_arguments) {
  for (const int n : {4, 40}) {
    const Program program = chain(n);
    const Rolled loops = *rolled(program, program.functions[0]);
    ASSERT_EQ(loops.classes.size(), 3u);  // the first, the last, which is the output, and those between
    EXPECT_EQ(loops.classes[1].bodies.size(), static_cast<std::size_t>(n - 2));
    EXPECT_EQ(loops.steps.size(), static_cast<std::size_t>(n));
    EXPECT_EQ(loops.written, 1u + 3u + 3u);
    EXPECT_EQ(loops.operations, 1u + 3u * static_cast<std::size_t>(n - 1));
    ASSERT_EQ(loops.fields.size(), 1u);
    EXPECT_EQ(loops.fields[0].with("K"), "vK");
    Arguments<double> at;
    for (int k = 0; k < n; ++k) at.x.push_back(0.1 * k);
    EXPECT_EQ(Evaluation(program, loops, at, 1).outputs(), evaluate(program, program.functions[0], at));
  }
}

// a b + c and c + b a with operands in other places of the list.
TEST(Rolled, does_not_mind_the_order_of_operands_that_commute) {
  SmallProgram p;
  const Ref a = p.add(p.multiply(p.sine(p.x(0)), p.x(1)), p.x(2));
  const Ref b = p.add(p.x(5), p.multiply(p.x(4), p.sine(p.x(3))));
  Program program = p.with({a, b}, {a, b});
  program.functions[0].quantities[0].body = 1;
  program.functions[0].quantities[1].body = 2;
  const Rolled loops = *rolled(program, program.functions[0]);
  EXPECT_EQ(loops.classes.size(), 1u);
  EXPECT_EQ(loops.classes[0].bodies, (std::vector<Index>{1, 2}));
}

TEST(Stem, is_a_name_around_the_number_of_its_body) {
  EXPECT_EQ(stem("omega7_1", 7).with("K"), "omegaK_1");
  EXPECT_EQ(stem("omega7_1", 7).with(""), "omega_1");
  EXPECT_EQ(stem("omega12_1", 1).with("K"), "omega12_1");  // another body's
  EXPECT_EQ(stem("gravity", 3).with("K"), "gravity");
}

TEST(Footprint, counts_the_results_that_are_live_at_once) {
  const Program program = chain(40);
  EXPECT_EQ(straight_footprint(program, program.functions[0]).stack, 8u * 2u);  // of v_L, c v_L and the sine two
  EXPECT_GT(straight_footprint(program, program.functions[0]).code,
            rolled_footprint(*rolled(program, program.functions[0])).code);
}

}  // namespace
}  // namespace kanec::program
