// All letters of one derivation, in one table: two GiNaC symbols of the same name would be different letters.
// Not here: expressions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/number.hpp"
#include "generator/symbolic/algebra.hpp"

namespace kanec::symbolic {

// What a letter stands for: entries of the state or of ẏ, numbers of the scene, or an expression by its name.
enum class Role { x, y, ydot, numbers, quantity };

struct Symbol {
  GiNaC::ex atom;
  std::string name;   // "omega", as in the code; the suffix follows
  std::string latex;  // "\omega", or with a # where the suffix goes: "f_{\dot s_{#}}"
  Role role;
  std::string suffix;                  // of the link or body: "3", "3a"; empty where none
  int at = 0;                          // x, y, ydot: index of the first entry
  std::vector<scene::Number> numbers;  // row-major
  GiNaC::ex transpose;                 // of a matrix letter
  bool is_transpose = false;           // named by the entries of `transpose`
};

class SymbolTable {
 public:
  // A new letter. A matrix is its own transpose until pair() says otherwise.
  GiNaC::ex add(Role role, const std::string& name, const std::string& latex, const std::string& suffix, Shape shape);
  GiNaC::ex add_state(Role role, const std::string& name, const std::string& latex, const std::string& suffix,
                      Shape shape, int at);
  GiNaC::ex add_numbers(const std::string& name, const std::string& latex, const std::string& suffix,
                        std::vector<scene::Number> numbers);  // 1, 3 or 9
  // Declares b the transpose of a, printed as aᵀ.
  void pair(const GiNaC::ex& a, const GiNaC::ex& b);

  // Other letters for a symbol that is printed as another one is.
  void rename(const GiNaC::ex& atom, const std::string& name, const std::string& latex);

  const Symbol& of(const GiNaC::ex& atom) const { return symbols_[index(atom)]; }
  const Symbol& of(const Atom& atom) const { return symbols_[static_cast<std::size_t>(atom.index())]; }
  const std::vector<Symbol>& all() const { return symbols_; }

  GiNaC::ex transposed(const GiNaC::ex& e) const;

 private:
  static std::size_t index(const GiNaC::ex& atom) { return static_cast<std::size_t>(GiNaC::ex_to<Atom>(atom).index()); }
  std::vector<Symbol> symbols_;
};

}  // namespace kanec::symbolic
