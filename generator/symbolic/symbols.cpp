// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/symbols.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

ex SymbolTable::add(Role role, const std::string& name, const std::string& latex, int body, Shape shape) {
  const std::string suffix = body > 0 ? std::to_string(body) : "";
  const ex atom = Atom(name + suffix, latex, shape, static_cast<int>(symbols_.size()));
  symbols_.push_back({atom, name, latex, role, body, atom});
  return atom;
}

void SymbolTable::pair(const ex& a, const ex& b) {
  symbols_[index(a)].transpose = b;
  symbols_[index(b)].transpose = a;
}

ex SymbolTable::transposed(const ex& e) const {
  return symbolic::transposed(e, [this](const Atom& atom) { return of(atom).transpose; });
}

}  // namespace kanec::symbolic
