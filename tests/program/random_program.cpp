// SPDX-License-Identifier: BSD-3-Clause
#include "tests/program/random_program.hpp"

#include <array>
#include <string>

#include "generator/program/builder.hpp"

namespace kanec::test {
namespace {

using program::Group;
using program::Index;
using program::Ref;

constexpr int n_of_group = 4;  // entries of each argument

class Maker {
 public:
  explicit Maker(Random& random) : random_(random) {}

  program::Program program(int n_nodes) {
    for (int i = 0; i < n_nodes; ++i) append();
    program::Program program;
    for (const char* name : {"first", "second"}) program.functions.push_back(function(name));
    program.functions.push_back(placed());
    program.nodes = std::move(builder_.nodes());
    return program;
  }

 private:
  // Constants are made of constants only `folds` deep, so that their folded values stay short.
  struct Result {
    Ref ref;
    bool constant = false;
    int folds = 0;
  };

  void append() {
    const int kind = results_.size() < 6 ? random_.below(2) : random_.below(20);
    if (kind == 0) return keep({constant(), true, 0});
    if (kind <= 2) return keep({variable(), false, 0});
    if (kind >= 18) return keep(function_of(any()));
    const Result a = any();
    const Result b = a.constant && a.folds > 1 ? Result{variable()} : other(a);
    if (kind == 17) return keep({builder_.divide(a.ref, divisor()), false, 0});
    const Ref ref = kind < 8    ? builder_.add(a.ref, b.ref)
                    : kind < 12 ? builder_.subtract(a.ref, b.ref)
                                : builder_.multiply(a.ref, b.ref);
    keep({ref, a.constant && b.constant, 1 + std::max(a.folds, b.folds)});
  }

  void keep(const Result& result) { results_.push_back(result); }

  Ref constant() {
    constexpr std::array values = {0.0, 1.0, -1.0, 2.0, 0.5, -0.25, 3.0, 0.625};
    return builder_.constant(values[static_cast<std::size_t>(random_.below(values.size()))]);
  }

  Ref variable() {
    constexpr std::array groups = {Group::parameter, Group::x, Group::y, Group::ydot, Group::input, Group::time};
    const Group group = groups[static_cast<std::size_t>(random_.below(groups.size()))];
    return builder_.variable(group, group == Group::time ? 0 : random_.below(n_of_group));
  }

  // Mostly one of the last results, with either sign.
  Result any() {
    const int size = static_cast<int>(results_.size());
    const int back = random_.chance(0.7) ? random_.below(std::min(size, 12)) : random_.below(size);
    Result result = results_[static_cast<std::size_t>(size - 1 - back)];
    if (random_.chance(0.3)) result.ref = -result.ref;
    return result;
  }

  Result other(const Result& a) {
    const Result b = any();
    return a.constant && b.constant && b.folds > 1 ? Result{variable()} : b;
  }

  // A variable or a power of two: dividing by other constants is not exact.
  Ref divisor() { return random_.chance(0.5) ? variable() : builder_.constant(random_.chance(0.5) ? 4.0 : -0.5); }

  Result function_of(Result a) {
    if (a.constant) a = {variable()};
    const int which = random_.below(6);
    if (which == 0) return {builder_.square_root({a.ref.node, false})};
    if (which == 1) return {builder_.sine(a.ref)};
    if (which == 2) return {builder_.cosine(a.ref)};
    if (which == 3) return {builder_.call(static_cast<program::Unary>(random_.below(7)), a.ref)};
    const Ref b = any().ref;
    if (which == 4) return {builder_.call(static_cast<program::Binary>(random_.below(4)), a.ref, b)};
    return {builder_.select(a.ref, b, any().ref)};
  }

  program::Function function(const std::string& name) {
    program::Function function{name, "", {}, {}, {}, 0, 0, {}};
    for (int i = 0; i < 5; ++i) {
      program::Quantity quantity;
      quantity.name = "q" + std::to_string(i);
      for (int entry = 0; entry < 3; ++entry) {
        quantity.labels.push_back(quantity.name + "_" + std::to_string(entry + 1));
        quantity.entries.push_back(any().ref);
      }
      function.quantities.push_back(quantity);
    }
    for (int i = 0; i < 8; ++i) function.outputs.push_back(any().ref);
    function.n_out = 8;
    return function;
  }

  // Two blocks at three places.
  program::Function placed() {
    program::Function function{"placed", "", {}, {}, {{0, 0}, {1, 3}, {0, 21}}, 36, 6};
    for (int i = 0; i < 18; ++i) function.outputs.push_back(any().ref);
    return function;
  }

  Random& random_;
  program::Builder builder_;
  std::vector<Result> results_;
};

}  // namespace

program::Program random_program(Random& random, int n_nodes) { return Maker(random).program(n_nodes); }

program::Arguments<Field> random_arguments(Random& random) {
  program::Arguments<Field> arguments;
  for (auto* group : {&arguments.parameters, &arguments.x, &arguments.y, &arguments.ydot, &arguments.inputs})
    for (int i = 0; i < n_of_group; ++i) group->push_back(Field::random(random));
  arguments.time = Field::random(random);
  return arguments;
}

std::vector<std::vector<Field>> entry_values(const program::Program& program,
                                             const program::Arguments<Field>& arguments) {
  std::vector<std::vector<Field>> values;
  for (const program::Function& function : program.functions) {
    program::Function entries;
    for (const program::Quantity& quantity : function.quantities)
      entries.outputs.insert(entries.outputs.end(), quantity.entries.begin(), quantity.entries.end());
    values.push_back(program::evaluate(program, entries, arguments));
  }
  return values;
}

}  // namespace kanec::test
