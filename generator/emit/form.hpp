// How each function is written, as a straight line or as loops over bodies, and what either takes of memory. Not: the
// text.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/emit/model.hpp"
#include "generator/program/footprint.hpp"
#include "generator/program/ledger.hpp"

namespace kanec::emit {

struct Form {
  std::optional<program::Rolled> loops;  // absent: a straight line
  program::Footprint straight, rolled;   // the latter where there are loops
};

// For size, loops wherever they take less code. For speed, in functions beyond the model's longest line of which most
// are repeated: code that does not fit the processor's caches is no faster as a straight line, and takes long to
// compile. Frames for speed stay below `most_stack` bytes: a thread may have little more.
inline constexpr std::size_t most_stack = 1 << 20;

std::vector<Form> forms(const program::Program& program, const std::vector<program::Ledger>& costs, const Model& model);

// Comment lines on the functions that are loops; empty where there are none.
std::string memory(const program::Program& program, const std::vector<Form>& forms);

}  // namespace kanec::emit
