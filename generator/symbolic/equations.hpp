// What the derivation returns: letters, named quantities in order, the functions that the solver shall have, and the
// tables that the source prints. Not here: how they are derived (derive.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"
#include "generator/symbolic/links.hpp"
#include "generator/symbolic/relative_rotations.hpp"
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

// A symmetric positive definite system of equations, solved entry by entry without fill-in: leaves before roots.
struct Solve {
  struct Unknown {
    GiNaC::ex letter;  // a scalar or a vector, defined by the solution
    GiNaC::ex right;   // right-hand side of its rows
    int link = 0;
  };
  struct Entry {              // of the matrix, its rows not before its columns in elimination order
    int row = 0, column = 0;  // unknowns
    GiNaC::ex block;
    bool transposed = false;  // `block` is the transpose of the entry
    bool wide = false;        // 3×3: a scalar stands for that times the identity
  };
  std::vector<Unknown> unknowns;  // in the order of elimination
  std::vector<Entry> matrix;
};

// Where a block of a function's result goes: entry (i, j) to out[offset + i * stride + j].
struct Output {
  GiNaC::ex block;
  int offset = 0;
  int stride = 1;
  bool transposed = false;  // entry (j, i) goes there instead
  bool wide = false;        // a 3×3 block: a scalar stands for that times the identity
};

struct Function {
  std::string name;     // "accelerations"
  std::string meaning;  // "ydot from A ydot = f"
  std::vector<Output> outputs;
  int n_out = 0;
  bool repeated = false;  // the same blocks stand at many places (partial velocities)
  program::Signature signature = {};
  bool usual = true;  // emitted unless functions are named
};

// A column of the state y: ω_K and a translation along all axes are 3 entries, an angle or a slide is one.
struct Speed {
  GiNaC::ex letter;
  int row = 0;  // of its first entry in y
  int link = 0;
};

using Blocks = std::map<int, GiNaC::ex>;  // column -> block, as many columns wide as its speed has entries; absent = 0

// The source's tables, a row a link (index j-1), inertial axes; of partial angular velocities link axes.
struct Tables {
  std::vector<GiNaC::ex> origin, centre;         // P, p, names left in
  std::vector<GiNaC::ex> origin_rate, velocity;  // Ṗ, v
  std::vector<Blocks> omega_y, v_y;              // partial angular velocities, partial velocities
  std::vector<Blocks> omega_y_dot, v_y_dot;      // their time derivatives
  std::vector<Blocks> origin_y;                  // of the link origins
};

// A coordinate of a joint in letters; 0 where it is constant.
struct Coordinate {
  Freedom freedom;
  GiNaC::ex value, speed, acceleration;
  GiNaC::ex axis;   // of a turn: link axes; of a slide: lower link's axes; a letter of three numbers
  int row = -1;     // in y; -1: locked or prescribed
  int column = -1;  // into Equations::speeds
};

inline bool is_rotation(const Coordinate& c) {
  return c.freedom.kind == Freedom::Kind::attitude || c.freedom.kind == Freedom::Kind::turn;
}

// Three numbers in one.
inline bool is_wide(const Coordinate& c) {
  return c.freedom.kind == Freedom::Kind::attitude || c.freedom.kind == Freedom::Kind::translation;
}

// Letters of one link; [0] is the inertial frame.
struct Letters {
  GiNaC::ex to_inertial = 1, to_body = 1;  // Rᵀ, R
  GiNaC::ex to_lower = 1, from_lower = 1;  // Eᵀ, E: link to lower link components, where it turns with its lower link
  bool turns_with_lower = true;            // false: Euler parameters relative to the inertial frame
  GiNaC::ex e, eps4;                       // of a ball
  GiNaC::ex omega;                         // absolute, link axes; 0 where it cannot turn
  GiNaC::ex omega_value;                   // of a link that turns with its lower link: ω written with the lower one's
  GiNaC::ex s, sdot;                       // translation and its rate, lower link's axes
  GiNaC::ex offset;                        // q, and what locked coordinates add
  GiNaC::ex pitch;                         // of a screw [m/rad], else 0
  GiNaC::ex mass, r, inertia;              // of all bodies on the link, link axes; 0 where there is none
  std::vector<Coordinate> coordinates;     // rotation first
};

// Where a body of the scene is on its link.
struct BodyFrame {
  int link = 0;
  GiNaC::ex orientation = 1;  // C: body to link components
  GiNaC::ex orientation_transposed = 1;
  GiNaC::ex offset;            // of its origin from the link's, link axes
  GiNaC::ex mass, r, inertia;  // body axes
};

struct Equations {
  explicit Equations(const scene::Scene& of) : scene(of), layout(of) {}
  scene::Scene scene;
  SymbolTable table;
  Mechanism mechanism;
  scene::Layout layout;
  GiNaC::ex gravity;              // 0 where the scene has none
  std::vector<Letters> letters;   // by link
  std::vector<BodyFrame> bodies;  // by body, from 1
  std::vector<Speed> speeds;      // the columns of y, in order
  JointRotations joint_rotations;
  std::map<std::string, GiNaC::ex> load_letters;  // of loads, by name
  std::vector<Quantity> quantities;
  std::vector<Solve> solves;
  std::vector<Function> functions;
  Tables tables;
};

}  // namespace kanec::symbolic
