// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/relative_rotations.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

void JointRotations::add(const ex& left, const ex& right, const ex& product) {
  products_.emplace(std::pair(GiNaC::ex_to<Atom>(left).index(), GiNaC::ex_to<Atom>(right).index()), product);
}

const ex* JointRotations::find(const ex& left, const ex& right) const {
  if (!GiNaC::is_a<Atom>(left) || !GiNaC::is_a<Atom>(right)) return nullptr;
  const auto found = products_.find({GiNaC::ex_to<Atom>(left).index(), GiNaC::ex_to<Atom>(right).index()});
  return found == products_.end() ? nullptr : &found->second;
}

namespace {

bool undo_each_other(const ex& a, const ex& b, const SymbolTable& table) {
  if (!GiNaC::is_a<Atom>(a) || !GiNaC::is_a<Atom>(b)) return false;
  const Symbol& symbol = table.of(a);
  return !symbol.transpose.is_equal(a) && symbol.transpose.is_equal(b);
}

// Appends a factor; what it makes with the last one may in turn meet the one before.
void append(std::vector<ex>& kept, const ex& factor, const SymbolTable& table, const JointRotations& neighbours) {
  if (!kept.empty()) {
    if (undo_each_other(kept.back(), factor, table)) {
      kept.pop_back();
      return;
    }
    if (const ex* product = neighbours.find(kept.back(), factor)) {
      kept.pop_back();
      return append(kept, *product, table, neighbours);
    }
  }
  kept.push_back(factor);
}

}  // namespace

ex with_relative_rotations(const ex& e, const SymbolTable& table, const JointRotations& neighbours) {
  std::vector<Term> terms = expanded(e);
  for (Term& term : terms) {
    std::vector<ex> kept;
    for (const ex& factor : term.factors) append(kept, factor, table, neighbours);
    term.factors = kept;
  }
  return sum(terms);
}

}  // namespace kanec::symbolic
