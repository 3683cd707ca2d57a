// A symmetric positive definite system solved entry by entry: L D Lᵀ in a given order, of the tree's pattern only,
// which elimination from the leaves does not fill. Not: where the system comes from. SPDX-License-Identifier:
// GPL-2.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "generator/program/builder.hpp"

namespace kanec::lower {

// Rows and columns by number; the lower triangle in elimination order: an entry's row is not before its column.
using Entries = std::map<std::pair<int, int>, program::Ref>;

struct Elimination {
  std::vector<program::Ref> pivots;  // D, by row
  Entries factors;                   // L
  std::vector<program::Ref> solution;
};

// Throws nothing: a pivot that vanishes shows in its value.
Elimination eliminate(program::Builder& builder, Entries matrix, std::vector<program::Ref> right);

}  // namespace kanec::lower
