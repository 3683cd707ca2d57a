// A function's statements as a list of sections, and the function around them, in one piece or several. Not: how
// statements are made (statements.hpp) or which there are (function.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "generator/emit/angles.hpp"
#include "generator/emit/language.hpp"
#include "generator/emit/model.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

struct Section {
  std::string heading;                     // comment line, empty for none
  std::vector<std::string> lines;          // statements and comments
  std::vector<program::Variable> reads;    // entries of the state, in any order
  std::vector<std::string> defines, uses;  // names of results: made here, used here
};

// Compilers other than clang need more than linear time for a long function (g++ 12 at -O2: 1.9 s for 10,000
// statements, 27 s for 40,000), so longer ones are cut at sections into pieces that share a struct of the results that
// cross cuts.
struct Shape {
  std::string name;  // "accelerations"
  std::string parameters;
  std::vector<std::string> unused;
  std::string piece_parameters;  // the same where any may be unused
  std::vector<std::string> piece_unused;
  std::string arguments;  // as passed on to a piece
  std::string begin;      // statements before the sections
  std::string end;        // and after
  std::string out_local;  // a local array that pieces write into, "block", or empty
  std::string usings;     // using-declarations that the statements need
  Angles angles;          // of which the arrays cosines and sines are
};

std::string function_text(const program::Program& program, const Shape& shape, const std::vector<Section>& sections,
                          const Lengths& lengths, const Syntax& syntax);

}  // namespace kanec::emit
