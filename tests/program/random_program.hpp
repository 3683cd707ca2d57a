// Random straight-line programs for tests of passes, each a function of its seed alone. Not: what a derivation lowers
// to.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "generator/program/evaluate.hpp"
#include "generator/program/program.hpp"
#include "tests/program/field.hpp"

namespace kanec::test {

// Every kind of node, many equal ones, constants that invite simplification, quantities with dead entries, and the two
// kinds of function. Constants are such that folding them is exact in a double.
program::Program random_program(Random& random, int n_nodes);

// Arguments for it, the same for the same state of `random`.
program::Arguments<Field> random_arguments(Random& random);

// The value of every quantity's entry, function by function, as if each were an output.
std::vector<std::vector<Field>> entry_values(const program::Program& program,
                                             const program::Arguments<Field>& arguments);

// What its first function is at some arguments, the same for every program.
inline std::vector<Field> values_at_random(const program::Program& program) {
  Random random(1);
  return evaluate(program, program.functions[0], random_arguments(random));
}

}  // namespace kanec::test
