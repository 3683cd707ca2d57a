// Bodies that share a partial velocity, and sums over them: what turns sums over all bodies into sums over subtrees.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

// Bodies (from 1, ascending) whose block in one column is the same expression.
struct Group {
  GiNaC::ex block;
  std::vector<int> bodies;
};

std::vector<Group> groups(const std::vector<Blocks>& rows, int column);

// Named sums of one term a body over sets of bodies. Each new sum is written with the largest sums named before it, so
// that nested sets (subtrees, asked for from the leaves inward) cost one addition a child.
class SubsetSums {
 public:
  // terms[K]: the term of body K, from 1. The sums are called name_J with J the first body of the set.
  SubsetSums(std::vector<GiNaC::ex> terms, std::string name, std::string latex, std::string meaning);
  GiNaC::ex over(Derivation& derivation, const std::vector<int>& bodies);

 private:
  std::vector<GiNaC::ex> terms_;
  std::string name_, latex_, meaning_;
  std::map<std::vector<int>, GiNaC::ex> sums_;
  std::vector<const std::vector<int>*> largest_;  // the last set named that holds body K
};

// Emitted functions partial_velocities and partial_velocity_rates.
void derive_partial_velocity_functions(Derivation& derivation);

}  // namespace kanec::symbolic
