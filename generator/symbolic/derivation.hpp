// The bookkeeping of a derivation in progress: it names quantities and knows the rates of letters. Not here: mechanics.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/symbolic/equations.hpp"
#include "generator/symbolic/inertias.hpp"
#include "generator/symbolic/way.hpp"

namespace kanec::symbolic {

// What is the time derivative of each letter. The derivation makes several: with the rates of the speeds as letters,
// with them zero (bias), with them found (accelerations).
class Rates {
 public:
  void set(const GiNaC::ex& atom, const GiNaC::ex& rate);
  GiNaC::ex operator()(const Atom& atom) const;  // 0 for constants
  // Time derivative of an expression of letters, expanded.
  GiNaC::ex of(const GiNaC::ex& e) const { return time_derivative(e, std::cref(*this)); }

 private:
  std::vector<GiNaC::ex> rates_;  // by table index
};

// In whose axes a block of numbers is written: a link's, or inertial (0).
using Frame = int;

class Derivation {
 public:
  Derivation(const scene::Scene& scene, const Way& way);

  // Appends the quantity name_j = value and returns its letter; a value that is 0 or a letter already is returned as it
  // is. A matrix gets a letter for its transpose as well, unless it is symmetric.
  GiNaC::ex define(const std::string& name, const std::string& latex, int link, Pass pass, const GiNaC::ex& value,
                   const std::string& meaning, bool is_symmetric = false);

  const Mechanism& mechanism() const { return equations.mechanism; }
  int size() const { return equations.mechanism.size(); }  // links
  int lower(int link) const { return mechanism().link(link).lower; }
  const Letters& letters(int link) const { return equations.letters[static_cast<std::size_t>(link)]; }
  const BodyFrame& body(int k) const { return equations.bodies[static_cast<std::size_t>(k)]; }
  int n_bodies() const { return scene::size(equations.scene); }
  // A free joint with all six of its coordinates in the state.
  bool is_free(int link) const;
  // The axes that accelerations and forces of a link are written in: its own where a link above turns with it, or where
  // the way says so; else inertial.
  Frame home(int link) const { return home_[static_cast<std::size_t>(link)]; }
  // The same vector (or the columns of a matrix) in other axes; rotations that undo each other vanish, and R_J R_Lᵀ
  // along a joint is E.
  GiNaC::ex in_axes(const GiNaC::ex& e, Frame from, Frame to) const;

  GiNaC::ex transposed(const GiNaC::ex& e) const { return equations.table.transposed(e); }
  // The function of that name, to be filled.
  Function& function(const std::string& name);

  const Inertia& inertia(int link) const { return inertias[static_cast<std::size_t>(link)]; }

  Equations equations;
  Way way;
  std::vector<Inertia> inertias;  // by link
  Rates partial_rates;            // of `rates` and of the names of partial velocities
  Rates rates;                    // of rotations, s and what is defined from them; ω̇, θ̈ and s̈ are letters
  std::vector<GiNaC::ex> joint_offsets;             // d, by link
  std::vector<GiNaC::ex> origins, centres;          // P, p, by link; [0] is zero
  std::vector<GiNaC::ex> origin_rates, velocities;  // Ṗ, v

 private:
  std::vector<Frame> home_;
};

// Letters of all links and bodies, rotations and angular velocities.
void define_letters(Derivation& derivation);

// What every function needs.
void derive_positions(Derivation& derivation);
void derive_velocities(Derivation& derivation);

}  // namespace kanec::symbolic
