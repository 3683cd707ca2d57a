// Derivatives of results, written down as further operations: along a direction, and Jacobians of functions. Not:
// passes; what the new operations share among each other is left to these.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "generator/program/builder.hpp"
#include "generator/program/program.hpp"

namespace kanec::program {

// Forward differentiation along one direction. At kinks a one-sided derivative: abs has 1 at 0, and where both
// arguments of min or max are equal the first is taken. No operation is made for a derivative that is 0, nor a product
// with 1.
class Tangents {
 public:
  explicit Tangents(Builder& builder) : builder_(builder), zero_(builder.constant(0.0)) {}

  // The derivative of this variable wherever it stands, or of this result; of other variables it is 0. Before `of`.
  void seed(const Variable& variable, Ref derivative) { seeds_.push_back({variable, derivative}); }
  void seed(Index node, Ref derivative) { remember(node, derivative); }

  // The derivative of a result. Work and new operations are linear in what the result depends on, once for all calls.
  Ref of(Ref ref);

  // Whether a derivative that `of` returned is 0 for every argument.
  bool is_zero(Ref derivative) const;

 private:
  struct Seed {
    Variable variable;
    Ref derivative;
  };

  bool is_known(Index node) const;
  void remember(Index node, Ref derivative);
  Ref known(Index node) const { return known_[static_cast<std::size_t>(node)]; }
  Ref of_variable(const Variable& variable) const;
  Ref by_rule(Index node);
  Ref of_extremum(const BinaryCall& call);

  Builder& builder_;
  Ref zero_;
  std::vector<Seed> seeds_;
  std::vector<Ref> known_;  // by node; node -1 where not known yet
};

// The partial derivative of a node with respect to its operand of this number, its value a result of the program.
Ref partial(Builder& builder, Index node, int operand);

// One column of a Jacobian: what of every variable changes, and how much of it.
struct Direction {
  Variable variable;
  Ref amount;
};
using Column = std::vector<Direction>;

// A function whose outputs are the derivatives of the outputs of `function`, row-major, a row an output and a column a
// direction; with its quantities, so that what both need keeps its name. Its operations are appended to the program;
// name, meaning, layout and the name of the result are left to the caller. `function` has no placements. Of the ways to
// arrange the chain rule (elimination.hpp) the one with the fewest operations is taken.
Function jacobian(Program& program, const Function& function, const std::vector<Column>& columns);

}  // namespace kanec::program
