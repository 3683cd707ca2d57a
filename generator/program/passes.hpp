// The passes over a program, each in a file of its own. Every pass keeps all values and never raises the cost.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <functional>
#include <string>

#include "generator/program/builder.hpp"
#include "generator/program/program.hpp"

namespace kanec::program {

// Constants folded exactly, zeros and ones eliminated, signs taken out of products, x - x = 0.
Program simplify(Program program);

// Constants of a sum in one, and multiples of one value: 0.3 a + b + 0.1 + 0.2 a + c + 0.4 = 0.5 a + b + 0.5 + c. What
// costs as much either way stays.
Program collect(Program program);

// Each operation once: hash-consing modulo commutation and the sign of differences.
Program share(Program program);

// Partial sums that several sums of a function have in common, taken out once. Re-associates sums of three and more
// terms.
Program share_sums(Program program);

// Terms of a sum in an order in which most products are fused with additions: products that nothing else needs last.
// a b + c d + e takes three instructions, e + a b + c d two.
Program order_terms(Program program);

// Operations that no output needs are dropped, and quantities of which nothing is left.
Program drop_dead(Program program);

// One of its functions with what that needs, and nothing else.
Program alone(const Program& program, Function function);

// All of them, in order; checks the program between them in debug builds.
Program optimized(Program program);

// Makes a program anew node by node. `remake` gets the builder, the node, and its operands as they now are; the nodes
// stay what they were until all are made.
using Refs = std::array<Ref, 3>;
using Remake = std::function<Ref(Builder&, const Node&, const Refs&)>;
void rebuild(Program& program, const Remake& remake);

// The functions of two programs over the same arguments in one.
Program joined(Program first, Program second);

// A pass over each function alone: what functions have in common is no saving to any of them, and so each has the same
// code whatever others the program holds.
Program by_function(Program program, const std::function<Program(Program)>& pass);

// The node itself on new operands.
Ref same_again(Builder& builder, const Node& node, const Refs& operands);

}  // namespace kanec::program
