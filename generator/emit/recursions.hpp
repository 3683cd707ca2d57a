// The statements of a Taylor series: values, and coefficient k of every result by its recursion. Not: the class around
// them (taylor.hpp), nor which recursion a result has (program/series.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/emit/function.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

struct RecursionText {
  std::string values, coefficients;    // statements of either function
  std::string factors, sums;           // structs of the rows' numbers
  std::string products;                // the table's entries: " {S::a, F::b, F::c, 1},"
  std::vector<std::string> functions;  // of the standard library that are called
  bool chooses = false;                // select() is called
};

RecursionText recursion_text(const program::Program& program, const program::Function& function, const Named& named);

}  // namespace kanec::emit
