// What the components of a state are called, and what a name tells: kind, unit, body. Not: their values.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace kanec {

// In state order: "eps_1_1", "theta_elbow", "s_2_1"; "omega_1_1", "thetadot_elbow", "sdot_2_1". And the inputs that
// change in the run, with their places among all.
struct StateNames {
  std::vector<std::string> coordinates, speeds;
  std::vector<std::string> inputs = {};
  std::vector<int> input_indices = {};
  std::vector<std::string> bodies = {};  // what stands for each body in the names; empty: their numbers
};

// The six kinds of components: coordinates, and below each the speeds that move it.
enum class Kind { eps, theta, s, omega, thetadot, sdot };

struct Component {
  Kind kind;
  int body;       // from 1
  int component;  // from 1; 1 where it is the only one
};

// Of "theta_elbow", or "theta_3", or "s_2_1"; bodies: as of StateNames. Throws InternalError for what is no such name.
Component component_of(std::string_view name, const std::vector<std::string>& bodies);

// "rad/s" of "thetadot_elbow"; empty for Euler parameters.
std::string_view unit_of(std::string_view name);

}  // namespace kanec
