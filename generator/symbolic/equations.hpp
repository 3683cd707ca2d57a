// What the derivation returns: letters, named quantities in order, the functions that the solver shall have, and the
// tables that the source prints. Not here: how they are derived (derive.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"
#include "generator/symbolic/symbols.hpp"

namespace kanec::symbolic {

using program::Pass;

// A named step of the derivation, written in the letters and the quantities before it.
struct Quantity {
  GiNaC::ex symbol;
  GiNaC::ex value;
  int body = 0;  // whose section it belongs to, from 1
  Pass pass = Pass::outward;
  std::string meaning;  // "velocity of the mass centre, inertial axes [m/s]"
};

// Where a block of a function's result goes: entry (i, j) to out[offset + i * stride + j].
struct Output {
  GiNaC::ex block;
  int offset = 0;
  int stride = 1;
  bool transposed = false;  // entry (j, i) goes there instead
};

struct Function {
  std::string name;     // "accelerations"
  std::string meaning;  // "ydot from A ydot = f"
  std::vector<Output> outputs;
  int n_out = 0;
  bool repeated = false;  // the same blocks stand at many places (partial velocities)
  program::Signature signature = {};
};

// Columns of the state y: ω_K is column K-1, ṡ_K column N+K-1.
using Blocks = std::map<int, GiNaC::ex>;  // column -> 3×3 block; absent = 0

// The source's tables, a row a body (index K-1).
struct Tables {
  std::vector<GiNaC::ex> origin, centre;                // P_K, p_K, names left in
  std::vector<GiNaC::ex> origin_rate, velocity;         // Ṗ_K, v_K
  std::vector<Blocks> omega_y, v_y;                     // partial angular velocities, partial velocities
  std::vector<Blocks> omega_y_dot, v_y_dot;             // their time derivatives
  std::vector<Blocks> origin_y;                         // partial velocities of the body origins
};

// Letters of one body.
struct Letters {
  GiNaC::ex e, eps4, omega, s, sdot, omegadot, sddot;  // state and its rates
  GiNaC::ex mass, inertia, r, q, force, moment;        // data; 0 where the scene has none
  GiNaC::ex to_inertial, to_body;                      // R_Kᵀ, R_K
};

struct Equations {
  scene::Scene scene;
  SymbolTable table;
  GiNaC::ex gravity;  // 0 where the scene has none
  std::vector<Letters> letters;
  std::vector<Quantity> quantities;
  std::vector<Function> functions;
  Tables tables;
};

}  // namespace kanec::symbolic
