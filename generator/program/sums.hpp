// Sums of a program as lists of terms: a chain of additions and subtractions whose partial sums nothing else needs.
// Not: what is done with them (collect.cpp, share_sums.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

using Terms = std::vector<Ref>;

// The order of terms: as the operations stand, or as they were written: -(a + b) + c becomes c - (a + b), and is read
// as the former. Of sums that differ in the signs of constants only, the latter gives the same order.
enum class TermOrder { as_it_stands, as_written };

struct Sums {
  explicit Sums(const Program& program, TermOrder order = TermOrder::as_it_stands);

  // Takes a sum, and its partial sums, off the lists.
  void leave(const Program& program, Index sum);

  std::vector<bool> inner;  // of each node: a partial sum; its one use is in another sum of its stage, without a name
  std::map<Index, Terms> sums;  // by the node that holds the whole
};

}  // namespace kanec::program
