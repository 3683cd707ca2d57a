// A symmetric positive definite system solved entry by entry: L D Lᵀ in a given order, of the tree's pattern only,
// which elimination from the leaves does not fill. Not: where the system comes from.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "generator/program/builder.hpp"

namespace kanec::lower {

// Rows and columns by number; the lower triangle in elimination order: an entry's row is not before its column.
using Entries = std::map<std::pair<int, int>, program::Ref>;

struct Factors {
  std::vector<program::Ref> pivots, inverses;  // D and 1/D, by row
  Entries lower;                               // L
};

// Throws nothing: a pivot that vanishes shows in its value.
Factors factorised(program::Builder& builder, Entries matrix, int size);
std::vector<program::Ref> solved(program::Builder& builder, const Factors& factors, std::vector<program::Ref> right);
// All of the inverse, row-major, its symmetric half computed: after Takahashi, Fagan & Chin (1973).
std::vector<program::Ref> inverted(program::Builder& builder, const Factors& factors);

}  // namespace kanec::lower
