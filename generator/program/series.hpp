// Taylor series of a function's results along the motion, coefficient by coefficient: which results need what kind of
// recursion. Not: the recursions as code (generator/emit/taylor.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

// How coefficient k >= 1 of a result comes from those of its operands (Griewank & Walther, Evaluating Derivatives, 13).
enum class Recursion {
  still,     // constants, parameters, inputs: nothing but a value
  given,     // x, y and time
  linear,    // sums, and products with what is still
  product,   // of two that move
  quotient,  // by one that moves
  root,      // square root
  integral,  // of sums of g da, for a function f with f' = g
  choice     // of one operand, by values: abs, min, max, select
};

// f = ∫ ± g da
struct Term {
  Index g, a;
  bool negative = false;
};

// Coefficient k of `sum` has in it ± the sum of a_i b_(k-i), a and b being factors.
struct SeriesProduct {
  Index sum, a, b;
  bool by_rate = false;  // n a_n stands in place of a_n
  bool negative = false;
};

struct Series {
  Program program;          // the function's nodes, and after them the derivatives of functions that recursions need
  std::vector<bool> alive;  // needed for the outputs or the recursions; what follows is by node as well
  std::vector<Recursion> recursions;
  std::vector<std::vector<Term>> terms;  // of integrals
  std::vector<bool> is_factor;           // all coefficients are kept
  std::vector<bool> is_rate;             // n times coefficient n is kept, all of them
  std::vector<bool> is_sum;              // products are added up for it
  std::vector<bool> is_named;            // others stand in the one sum that uses them
  std::vector<SeriesProduct> products;

  bool moves(Index node) const { return recursions[static_cast<std::size_t>(node)] != Recursion::still; }
};

// Of a function without placements. `named`: nodes that have a name in any case.
Series series(const Program& program, const Function& function, const std::vector<bool>& named);

}  // namespace kanec::program
