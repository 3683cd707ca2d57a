// The bookkeeping of a derivation in progress: it names quantities and knows the rates of letters. Not here: mechanics.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/symbolic/equations.hpp"

namespace kanec::symbolic {

// What is the time derivative of each letter. The derivation makes several: with the rates of the speeds as letters, with
// them zero (bias), with them found (accelerations).
class Rates {
 public:
  void set(const GiNaC::ex& atom, const GiNaC::ex& rate);
  GiNaC::ex operator()(const Atom& atom) const;  // 0 for constants
  // Time derivative of an expression of letters, expanded.
  GiNaC::ex of(const GiNaC::ex& e) const { return time_derivative(e, *this); }

 private:
  std::vector<GiNaC::ex> rates_;  // by table index
};

class Derivation {
 public:
  explicit Derivation(const scene::Scene& scene);

  // Appends the quantity name_K = value and returns its letter; a value that is 0 or a letter already is returned as it is.
  GiNaC::ex define(const std::string& name, const std::string& latex, int body, Pass pass, const GiNaC::ex& value,
                   const std::string& meaning);

  int size() const { return scene::size(equations.scene); }
  int lower(int body) const { return equations.scene.lower[static_cast<std::size_t>(body - 1)]; }  // bodies from 1 here
  const Letters& letters(int body) const { return equations.letters[static_cast<std::size_t>(body)]; }  // 0: inertial frame
  // Columns of the state y.
  int omega_column(int body) const { return body - 1; }
  int sdot_column(int body) const { return size() + body - 1; }
  int row(int column) const { return 3 * column; }  // first scalar row of a column
  GiNaC::ex transposed(const GiNaC::ex& e) const { return equations.table.transposed(e); }

  Equations equations;
  Rates rates;                           // of rotations, s and what is defined from them; ω̇ and s̈ are letters
  std::vector<GiNaC::ex> origin_rates;   // Ṗ_K, by K
  std::vector<GiNaC::ex> velocities;     // v_K, by K
  std::vector<GiNaC::ex> origins, centres;
};

// The stages of the derivation, in order; each file of that name holds one.
void derive_positions(Derivation& derivation);
void derive_velocities(Derivation& derivation);
void derive_partial_velocities(Derivation& derivation);
void derive_residual(Derivation& derivation);
void derive_forcing(Derivation& derivation);
void derive_mass_matrix(Derivation& derivation);
void derive_accelerations(Derivation& derivation);
void derive_measures(Derivation& derivation);  // energy, momentum, poses, power

}  // namespace kanec::symbolic
