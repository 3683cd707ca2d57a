// The passes over a program, each in a file of its own. Every pass keeps all values and never raises the cost.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <string>

#include "generator/program/builder.hpp"
#include "generator/program/program.hpp"

namespace kanec::program {

// Constants folded exactly, zeros and ones eliminated, signs taken out of products, x - x = 0.
Program simplify(const Program& program);

// Each operation once: hash-consing modulo commutation and the sign of differences.
Program share(const Program& program);

// Partial sums that several sums of a function have in common, taken out once. Re-associates sums of three and more terms.
Program share_sums(const Program& program);

// Operations that no output needs are dropped, and quantities of which nothing is left.
Program drop_dead(const Program& program);

// All of them, in order; checks the program between them in debug builds.
Program optimized(Program program);

// A program made anew node by node. `remake` gets the builder, the node, and its operands as they now are.
using Remake = std::function<Ref(Builder&, const Node&, Ref, Ref)>;
Program rebuilt(const Program& program, const Remake& remake);

// The node itself on new operands.
Ref same_again(Builder& builder, const Node& node, Ref a, Ref b);

}  // namespace kanec::program
