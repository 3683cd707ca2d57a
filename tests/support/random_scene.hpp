// Random scenes, states and inputs for tests, each a function of its seed alone. Not: any expectation about them.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "tests/support/random.hpp"

namespace kanec::test {

struct RandomSceneOptions {
  bool forest = true;          // several bodies may stand on the inertial frame
  bool gravity = true;         // else none
  bool loads = true;           // on bodies, else none
  double parameter_share = 0;  // of all numbers, turned into parameters
  double input_share = 0;      // of the loads' numbers, turned into inputs
  double zero_share = 0;       // of the entries of r, q, loads and gravity; of whole triples of products of inertia

  std::vector<std::string> joints = {};  // kinds to choose from (every_joint()); empty: free joints at default axes
  bool in_order = false;                 // each body has the kind of its place among them
  double locked_share = 0;               // of the coordinates and of the balls' attitudes
  double prescribed_share = 0;           // of the coordinates
  bool springs = false;                  // and dampers and efforts: along half of all coordinates, and between points
  bool point_loads = false;              // forces and moments at points, some with reactions
  double expression_share = 0;           // of the loads' numbers, turned into expressions
  int points = 0;                        // named
  double massless_share = 0;             // of the welded bodies, without mass and inertia
  std::vector<std::string> names = {};   // of parameters and inputs, as far as they go
};

// All kinds: free, ball, bearing, revolute, universal, gimbal, prismatic, cartesian, cylindrical, planar, screw, weld.
std::vector<std::string> every_joint();

// Everything above, in shares that leave some of each.
RandomSceneOptions everything();

// L(K) for n bodies.
std::vector<int> random_connection(Random& random, int n_bodies, bool forest = true);

// Masses, valid inertias, r and q (also on the inertial frame), gravity, loads. The initial state is random_state()'s.
scene::Scene random_scene(Random& random, const std::vector<int>& lower, const RandomSceneOptions& options = {});
scene::Scene random_scene(Random& random, int n_bodies, const RandomSceneOptions& options = {});

// A state with |ε| = 1 to rounding and no axes of a joint near to dependent, and speeds' rates that have nothing to do
// with the loads.
struct State {
  std::vector<double> x, y, ydot;
};
State random_state(Random& random, const scene::Scene& scene);

// Near the defaults (1 %), so that inertias of random_scene() stay positive definite.
std::vector<double> random_parameters(Random& random, const scene::Scene& scene);
std::vector<double> random_inputs(Random& random, const scene::Scene& scene);

}  // namespace kanec::test
