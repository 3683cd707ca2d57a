// Appends operations to a program with signs carried along. Not here: any simplification; passes do that.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

class Builder {
 public:
  Ref constant(const Number& value) { return append(Constant{value}); }
  Ref variable(Group group, Index index) { return append(Variable{group, index}); }
  Ref add(Ref a, Ref b);
  Ref subtract(Ref a, Ref b) { return add(a, -b); }
  Ref multiply(Ref a, Ref b) { return {append(Multiply{a.node, b.node}).node, a.negative != b.negative}; }
  Ref divide(Ref a, Ref b) { return {append(Divide{a.node, b.node}).node, a.negative != b.negative}; }
  Ref sine(Ref a) { return {append(Sine{a.node}).node, a.negative}; }  // odd
  Ref cosine(Ref a) { return append(Cosine{a.node}); }                 // even
  // Where a sign cannot be carried along, a negative reference costs one subtraction, of a constant none.
  Ref square_root(Ref a) { return append(SquareRoot{value_of(a)}); }
  Ref call(Unary function, Ref a);
  Ref call(Binary function, Ref a, Ref b);
  Ref select(Ref sign, Ref a, Ref b);  // sign < 0 ? a : b
  std::vector<Node>& nodes() { return nodes_; }
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  Ref append(const Node& node);
  Index value_of(Ref a);  // a node of this value, sign included
  std::vector<Node> nodes_;
};

// What `work` returns of a builder that appends to the program's nodes.
template <class Work>
auto appended(Program& program, const Work& work) {
  Builder builder;
  builder.nodes() = std::move(program.nodes);
  auto result = work(builder);
  program.nodes = std::move(builder.nodes());
  return result;
}

}  // namespace kanec::program
