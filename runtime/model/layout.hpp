// Names, shapes and units of numbers that stand one after another. Not: which numbers these are (state_layout.hpp,
// result_layout.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "runtime/text/json.hpp"

namespace kanec {

// Numbers that belong together.
struct Block {
  std::string name;           // "eps_hub"
  std::vector<int> shape;     // none: a number; one: a list; two: a matrix, row by row
  std::string unit;           // "rad/s"
  std::string numbered = {};  // its other name, by the body's number: "eps_1"; empty where it has none

  std::size_t size() const;
};

struct Layout {
  std::string name;                       // "x", "ydot", "mass_matrix"
  std::vector<Block> blocks;              // in order
  std::vector<std::string> rows = {};     // names of the rows and
  std::vector<std::string> columns = {};  // columns of wide matrices; else empty

  std::size_t size() const;
  // {"eps_1": [...], ...}, with "rows" and "columns" before them where they have names.
  Json json(std::span<const double> values) const;
  // A line a vector or a row, 17 digits; of wide matrices a line an entry that is not zero.
  std::string text(std::span<const double> values) const;
};

}  // namespace kanec
