// Appends operations to a program with signs carried along. Not here: any simplification; passes do that.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

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
  Ref square_root(Ref a);                                              // of a negative reference: one subtraction more
  Ref sine(Ref a) { return {append(Sine{a.node}).node, a.negative}; }  // odd
  Ref cosine(Ref a) { return append(Cosine{a.node}); }                 // even
  std::vector<Node>& nodes() { return nodes_; }
  const std::vector<Node>& nodes() const { return nodes_; }

 private:
  Ref append(const Node& node);
  std::vector<Node> nodes_;
};

}  // namespace kanec::program
