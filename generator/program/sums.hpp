// Sums of a program as lists of terms: a chain of additions and subtractions whose partial sums nothing else needs. Not:
// what is done with them (collect.cpp, share_sums.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

using Terms = std::vector<Ref>;

struct Sums {
  explicit Sums(const Program& program);

  std::vector<bool> inner;      // of each node: a partial sum; its one use is in another sum of its stage, without a name
  std::map<Index, Terms> sums;  // by the node that holds the whole
};

}  // namespace kanec::program
