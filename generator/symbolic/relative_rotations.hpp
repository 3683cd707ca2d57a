// Products of attitudes along the tree: R_J R_Lᵀ of a body and its lower body is the rotation E of the joint.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <utility>

#include "generator/symbolic/symbols.hpp"

namespace kanec::symbolic {

// E by the pair of letters whose product it is.
class JointRotations {
 public:
  void add(const GiNaC::ex& left, const GiNaC::ex& right, const GiNaC::ex& product);
  // The product, or nullptr where these two are not neighbours.
  const GiNaC::ex* find(const GiNaC::ex& left, const GiNaC::ex& right) const;

 private:
  std::map<std::pair<int, int>, GiNaC::ex> products_;
};

// Rotations that undo each other vanish, neighbours in the tree become E; expanded. Exact for rotations of unit norm.
GiNaC::ex with_relative_rotations(const GiNaC::ex& e, const SymbolTable& table, const JointRotations& neighbours = {});

}  // namespace kanec::symbolic
