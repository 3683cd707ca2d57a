// How a body turns and moves relative to its lower body. Not: how a joint is written in a scene file (read_joint.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>
#include <vector>

namespace kanec::scene {

using Axis = std::array<double, 3>;                     // of unit length
using Rotation = std::array<std::array<double, 3>, 3>;  // row-major, orthonormal
inline constexpr Rotation no_rotation = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

// One angle or one translation of a joint, and how it moves.
struct Coordinate {
  enum class Motion { free, locked, prescribed };
  Axis axis = {0, 0, 1};  // of rotation: below; of translation: axes of L(K)
  Motion motion = Motion::free;
  double value = 0.0;  // locked: where [rad], [m]; free: initial
  double rate = 0.0;   // free: initial [rad/s], [m/s]
  int expression = 0;  // prescribed: into Scene::expressions, of time and parameters
};

// K's axes against L(K)'s: Rot(axis_1, θ_1) Rot(axis_2, θ_2) … zero takes components in K to components in L(K), where
// Rot(a, θ) turns by θ about a (right-handed) and each axis is written in L(K)'s axes as it stands when all angles are
// zero. K's origin: q + Σ axis_i s_i (+ pitch θ_1 axis_1 of a screw), in L(K)'s axes. A ball ignores `turns` and
// `zero`: its Euler parameters are relative to the inertial frame.
struct Joint {
  std::string kind = "free";       // as written: "revolute"
  bool ball = true;                // Euler parameters and absolute ω in body axes
  bool held = false;               // of a ball: attitude locked at the initial eps, ω = 0
  std::vector<Coordinate> turns;   // at most 3 angles
  Rotation zero = no_rotation;     // of K's axes when all angles are zero
  std::vector<Coordinate> slides;  // at most 3 translations
  double pitch = 0.0;              // of a screw [m/rad]

  Joint() : slides(3) {  // free
    slides[0].axis = {1, 0, 0};
    slides[1].axis = {0, 1, 0};
  }
};

}  // namespace kanec::scene
