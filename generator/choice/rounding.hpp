// The rounding error that a function's operations are expected to make in a state, to first order: what its way of
// computing costs in digits. Not: a measurement, which other libraries and compilers would change (kanec report).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

#include "generator/program/evaluate.hpp"
#include "generator/program/program.hpp"

namespace kanec {

// Every operation errs by a share of its value, at random and independently of the others; so the square of an output's
// expected error is Σ (∂output/∂operation · value)², as Linnainmaa (1976) propagates single errors. A smooth function
// of the state: what libraries and processors differ in moves it in its last digits only.
struct Rounding {
  double error = 0.0;  // expected, of the output that has most of it
  double size = 0.0;   // largest output

  double ulps() const;  // of the largest output; infinite where a number is not finite
};

// Of so many outputs at most, the last among them, evenly spread.
Rounding expected_rounding(const program::Program& program, const program::Function& function,
                           const program::Arguments<double>& arguments, std::size_t most_outputs = 1 << 20);

}  // namespace kanec
