// All letters of one derivation, in one table: two GiNaC symbols of the same name would be different letters.
// Not here: expressions.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/symbolic/algebra.hpp"

namespace kanec::symbolic {

// What a letter stands for. `quantity`: defined by an expression; the others are data of the scene or of the call.
enum class Role { euler_vector, euler_scalar, omega, s, sdot, omegadot, sddot, mass, inertia, r, q, gravity, force, moment,
                  quantity };

struct Symbol {
  GiNaC::ex atom;
  std::string name;    // "omega", as in the code; the body follows
  std::string latex;   // "\omega"
  Role role;
  int body = 0;        // K, from 1; 0 where none
  GiNaC::ex transpose; // of a matrix letter
};

class SymbolTable {
 public:
  // A new letter. A matrix is its own transpose until pair() says otherwise.
  GiNaC::ex add(Role role, const std::string& name, const std::string& latex, int body, Shape shape);
  // Declares b the transpose of a.
  void pair(const GiNaC::ex& a, const GiNaC::ex& b);

  const Symbol& of(const GiNaC::ex& atom) const { return symbols_[index(atom)]; }
  const Symbol& of(const Atom& atom) const { return symbols_[static_cast<std::size_t>(atom.index())]; }
  const std::vector<Symbol>& all() const { return symbols_; }

  GiNaC::ex transposed(const GiNaC::ex& e) const;

 private:
  static std::size_t index(const GiNaC::ex& atom) {
    return static_cast<std::size_t>(GiNaC::ex_to<Atom>(atom).index());
  }
  std::vector<Symbol> symbols_;
};

}  // namespace kanec::symbolic
