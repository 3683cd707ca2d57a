// States by name, as JSON: what `kanec eval` reads and what `kanec simulate --final` leaves. Not: evaluation.
//
//   {"t": 0,
//    "x": {"eps_1": [0, 0, 0, 1], "theta_2": 0.3, ..., "s_1": [0, 0, 0], ...},
//    "y": {"omega_1": [0, 0, 0], "thetadot_2": 0, ..., "sdot_1": [0, 0, 0], ...},
//    "ydot": {"omegadot_1": [0, 0, 0], "thetaddot_2": 0, ..., "sddot_1": [0, 0, 0], ...},
//    "parameters": {"m_payload": 1.2}, "inputs": {"thrust": 2}}
//
// Letters, frames and units of CONVENTIONS.md, blocks of state_layout.hpp. x is always there (unless nothing moves
// freely); y and ydot where the function reads them. Each of these is complete. t that is left out is 0; parameters and
// inputs that are left out have the scene's values.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/text/json.hpp"

namespace kanec {

struct State {
  double t = 0.0;                          // [s]
  std::vector<double> x, y, ydot;          // empty: not given
  std::vector<double> parameters, inputs;  // all of the scene's, in its order
};

// What the scene begins with, ydot zero.
State initial_state(const scene::Scene& scene);

struct ReadState {
  State state;
  std::vector<std::string> notes;
};

// Euler parameters whose norm is 1 to rounding (1e-15) are taken as they stand, others normalised, with a note where
// they were off by more than 1e-6. Throws InputError that names `file` and the field.
ReadState read_state(std::string_view text, const std::string& file, const scene::Scene& scene, const Needs& needs);

// Parts that are empty are left out, but x; and t where nothing in the scene depends on it.
Json state_json(const scene::Scene& scene, const State& state);

}  // namespace kanec
