// The scene a user wrote, checked: a tree of rigid bodies, its numbers, its loads, its initial state. Not: how it is
// read (read.hpp) or what follows from it. BSD, not GPL: the runtime's generic path evaluates scenes as well.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

namespace kanec::scene {

// A physical number: folded into the code, or a field of the parameter struct, or (loads only) of the input struct.
struct Number {
  enum class Kind { constant, parameter, input };
  Kind kind = Kind::constant;
  double value = 0.0;  // of a constant
  int index = 0;       // into Scene::parameters or Scene::inputs

  static Number constant(double value) { return {Kind::constant, value, 0}; }
  static Number parameter(int index) { return {Kind::parameter, 0.0, index}; }
  static Number input(int index) { return {Kind::input, 0.0, index}; }
  bool is_zero() const { return kind == Kind::constant && value == 0.0; }
  bool operator==(const Number&) const = default;
};

using Vector = std::array<Number, 3>;

// Symmetric 3×3 by its six entries.
struct Symmetric {
  Number xx, yy, zz, xy, xz, yz;
};

// A parameter or an input of the scene.
struct Named {
  std::string name;    // a C++ identifier
  double value = 0.0;  // default
};

// A joint is how a body turns and how it moves relative to its lower body.
enum class RotationKind { ball };     // Euler parameters relative to the inertial frame, absolute ω in body axes
enum class TranslationKind { free };  // s_K, three components in the lower body's axes
struct Joint {
  RotationKind rotation = RotationKind::ball;
  TranslationKind translation = TranslationKind::free;
};

// State of one body; letters and frames of CONVENTIONS.md.
struct BodyState {
  std::array<double, 4> eps = {0, 0, 0, 1};  // Euler parameters, scalar last, unit norm
  std::array<double, 3> omega = {0, 0, 0};   // absolute angular velocity, body axes [rad/s]
  std::array<double, 3> s = {0, 0, 0};       // translation, lower body's axes [m]
  std::array<double, 3> sdot = {0, 0, 0};    // its rate [m/s]
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
  BodyState initial;
};

// What `kanec simulate` does unless told otherwise on its command line.
struct Simulation {
  double duration = 10.0;             // [s]
  double output_step = 0.01;          // between rows of the trajectory [s]
  std::string integrator = "arkode";  // rk4, arkode, cvode, cvode_bdf
  double step = 0.001;                // of rk4 [s]
  double relative_tolerance = 1e-9;   // of arkode and cvode
  double absolute_tolerance = 1e-12;
};

// Body K of the text is bodies[K-1]; lower[K-1] is L(K), 0 = inertial frame, L(K) < K.
struct Scene {
  std::string name;  // a C++ identifier
  std::vector<int> lower;
  std::vector<Body> bodies;
  Vector gravity;  // inertial axes [m/s²]
  std::vector<Named> parameters;
  std::vector<Named> inputs;
  Simulation simulation;
  std::vector<std::string> notes;     // what was changed in reading (normalised Euler parameters)
  std::vector<std::string> warnings;  // what is odd but modelled (violated triangle inequality)
};

inline int size(const Scene& scene) { return static_cast<int>(scene.bodies.size()); }
inline int n_coordinates(const Scene& scene) { return 7 * size(scene); }
inline int n_speeds(const Scene& scene) { return 6 * size(scene); }

// State vectors x = (ε_1 … ε_N ; s_1 … s_N) and y = (ω_1 … ω_N ; ṡ_1 … ṡ_N): where body `body` (from 0) begins.
inline int eps_at(const Scene&, int body) { return 4 * body; }
inline int s_at(const Scene& scene, int body) { return 4 * size(scene) + 3 * body; }
inline int omega_at(const Scene&, int body) { return 3 * body; }
inline int sdot_at(const Scene& scene, int body) { return 3 * size(scene) + 3 * body; }

// Initial x and y of the scene.
std::vector<double> initial_coordinates(const Scene& scene);
std::vector<double> initial_speeds(const Scene& scene);

// Defaults of the parameters and inputs, in order.
std::vector<double> default_parameters(const Scene& scene);
std::vector<double> default_inputs(const Scene& scene);

// u(K) for every body: steps down from K to its tree's first body (the one whose lower body is 0).
std::vector<int> depth(const std::vector<int>& lower);

// One name a coordinate ("eps_1_1" … "s_6_3") and a speed ("omega_1_1" … "sdot_6_3"), in state order.
std::vector<std::string> coordinate_names(const Scene& scene);
std::vector<std::string> speed_names(const Scene& scene);

}  // namespace kanec::scene
