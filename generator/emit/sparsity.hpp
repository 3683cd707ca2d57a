// Which entries of a matrix that a function returns are not always 0, as constants in emitted code. Not: how these
// entries are computed.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "generator/emit/language.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// "residual_x_nonzeros", "_rows" and "_columns": rows and columns of the entries in row-major order, of each matrix
// that some function returns, alone or in a combination.
std::string sparsity(const program::Program& program, const Syntax& syntax);

// The matrices that these are of, as a table of kanec_pattern `patterns`, and how many they are.
struct PatternTable {
  std::string text;
  std::size_t size = 0;
};
PatternTable pattern_table(const program::Program& program);

}  // namespace kanec::emit
