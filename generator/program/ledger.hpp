// What an evaluation of a function costs, counted exactly (where it selects, both values are counted). Not: time.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

struct Ledger {
  int adds = 0;  // and subtractions
  int multiplies = 0;
  int divides = 0;
  int square_roots = 0;
  int trigonometric = 0;  // sines and cosines
  int functions = 0;      // others, and selections

  int operations() const { return adds + multiplies + divides; }
  bool operator==(const Ledger&) const = default;
};

// One call of the function; what depends on parameters only is prepare()'s.
Ledger ledger(const Program& program, const Function& function);

// The same for every function of the program, in order.
std::vector<Ledger> ledgers(const Program& program);

// What prepare() does for all functions of the program.
Ledger prepare_ledger(const Program& program);

// All operations as so many additions: throughputs of independent evaluations, measured (DESIGN.md).
long weighted_cost(const Ledger& ledger);

// "512 add, 449 multiply"; zero counts but the first two are left out.
std::string text(const Ledger& ledger);

}  // namespace kanec::program
