// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/symbols.hpp"

#include <utility>

namespace kanec::symbolic {

using GiNaC::ex;

ex SymbolTable::add(Role role, const std::string& name, const std::string& latex, const std::string& suffix,
                    Shape shape) {
  const ex atom = Atom(name + suffix, latex, shape, static_cast<int>(symbols_.size()));
  symbols_.push_back({atom, name, latex, role, suffix, 0, {}, atom, false});
  return atom;
}

ex SymbolTable::add_state(Role role, const std::string& name, const std::string& latex, const std::string& suffix,
                          Shape shape, int at) {
  const ex atom = add(role, name, latex, suffix, shape);
  symbols_.back().at = at;
  return atom;
}

ex SymbolTable::add_numbers(const std::string& name, const std::string& latex, const std::string& suffix,
                            std::vector<scene::Number> numbers) {
  const Shape shape = numbers.size() == 1 ? Shape::scalar : numbers.size() == 3 ? Shape::vector : Shape::matrix;
  const ex atom = add(Role::numbers, name, latex, suffix, shape);
  symbols_.back().numbers = std::move(numbers);
  return atom;
}

void SymbolTable::pair(const ex& a, const ex& b) {
  symbols_[index(a)].transpose = b;
  symbols_[index(b)].transpose = a;
  symbols_[index(b)].is_transpose = true;
}

void SymbolTable::rename(const ex& atom, const std::string& name, const std::string& latex) {
  symbols_[index(atom)].name = name;
  symbols_[index(atom)].latex = latex;
}

ex SymbolTable::transposed(const ex& e) const {
  return symbolic::transposed(e, [this](const Atom& atom) { return of(atom).transpose; });
}

}  // namespace kanec::symbolic
