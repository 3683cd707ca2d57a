// The scene a user wrote, checked: a tree of rigid bodies, its numbers, its loads, its initial state. Not: how it is
// read (read.hpp) or what follows from it. BSD, not GPL: the runtime's generic path evaluates scenes as well.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

#include "generator/scene/event.hpp"
#include "generator/scene/expression.hpp"
#include "generator/scene/joint.hpp"
#include "generator/scene/layout.hpp"
#include "generator/scene/load.hpp"
#include "generator/scene/number.hpp"
#include "generator/scene/place.hpp"

namespace kanec::scene {

// A parameter or an input of the scene.
struct Named {
  std::string name;    // a C++ identifier
  double value = 0.0;  // default
};

// Initial attitude of a ball; angles and translations have theirs in the joint's coordinates.
struct BallState {
  std::array<double, 4> eps = {0, 0, 0, 1};  // Euler parameters, scalar last, unit norm
  std::array<double, 3> omega = {0, 0, 0};   // absolute angular velocity, body axes [rad/s]
};

struct Body {
  std::string name;
  Joint joint;
  Number mass;        // [kg]
  Symmetric inertia;  // about the mass centre, body axes [kg m²]
  Vector r;           // mass centre from the body origin, body axes [m]
  Vector q;           // joint point from the lower body's origin, lower body's axes [m]
  Vector force;       // applied, through the mass centre, inertial axes [N]; gravity not included
  Vector moment;      // applied, body axes [N m]
  BallState initial;
};

// What `kanec simulate` does unless told otherwise on its command line.
struct Simulation {
  double duration = 10.0;             // [s]
  double output_step = 0.01;          // between rows of the trajectory [s]
  std::string integrator = "dop853";  // check.hpp has all
  double step = 0.001;                // of those with fixed steps [s]
  double relative_tolerance = 1e-9;   // of the others
  double longest_step = 0.0;          // of these [s]; 0: as long as the error allows
  double absolute_tolerance = 1e-12;
  std::string jacobian = "auto";  // of arkode_dirk, cvode_bdf, ida
  int order = 0;                  // of arkode and arkode_dirk; 0: by itself
};

// How `kanec simulate --ensemble scene` draws scenarios: each name's value anew for every scenario, all others as the
// scene has them.
struct Draw {
  enum class Kind { uniform, normal };
  std::string name;  // of a coordinate, a speed, a parameter or an input
  Kind kind = Kind::uniform;
  double a = 0.0, b = 0.0;  // uniform: least and largest; normal: mean and standard deviation
};
struct Ensemble {
  int count = 0;  // 0: the scene has none
  int seed = 1;
  std::vector<Draw> draws;  // in the order of the file
};

// Body K of the text is bodies[K-1]; lower[K-1] is L(K), 0 = inertial frame, L(K) < K.
struct Scene {
  std::string name;    // a C++ identifier
  std::string source;  // folder and name of the file it was read from, as "pendulum/scene.toml"; empty where none
  std::vector<int> lower;
  std::vector<Body> bodies;
  Vector gravity;  // inertial axes [m/s²]
  std::vector<Load> loads;
  std::vector<Point> points;            // named, for outputs
  std::vector<Event> events;            // that simulations watch for
  std::vector<Expression> expressions;  // of prescribed coordinates, loads and events
  std::vector<std::string> functions;   // that the scene asks for; empty: the usual ones
  std::vector<Place> function_places;   // where it does so, of each
  std::vector<Named> parameters;
  std::vector<Named> inputs;
  Simulation simulation;
  Ensemble ensemble;
  std::vector<std::string> notes;     // what was changed in reading (normalised Euler parameters)
  std::vector<std::string> warnings;  // what is odd but modelled (violated triangle inequality)
};

// Whether an expression is not smooth everywhere: abs, min, max.
bool has_kinks(const Scene& scene);

inline int size(const Scene& scene) { return static_cast<int>(scene.bodies.size()); }
inline int n_coordinates(const Scene& scene) { return Layout(scene).nx; }
inline int n_speeds(const Scene& scene) { return Layout(scene).ny; }

// Initial x and y of the scene.
std::vector<double> initial_coordinates(const Scene& scene);
std::vector<double> initial_speeds(const Scene& scene);

// Defaults of the parameters and inputs, in order.
std::vector<double> default_parameters(const Scene& scene);
std::vector<double> default_inputs(const Scene& scene);

// u(K) for every body: steps down from K to its tree's first body (the one whose lower body is 0).
std::vector<int> depth(const std::vector<int>& lower);

}  // namespace kanec::scene
