// What acts on the bodies besides gravity. Not: the force and moment of [[body]], which stand in Body.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/scene/number.hpp"

namespace kanec::scene {

// In whose axes a vector is written.
enum class Axes { inertial, body, lower };

// A point fixed in a body; body 0 is the inertial frame.
struct Point {
  std::string name;
  int body = 0;  // from 1
  Vector r;      // from the body's origin, body axes [m]; constants or parameters
};

// One load. Every magnitude is a constant, a parameter, an input or an expression.
struct Load {
  enum class Kind {
    force,   // `vector` at `point` [N]
    moment,  // `vector` on point.body [N m]
    joint,   // on one scalar coordinate, along it: effort - stiffness (value - rest) - damping rate [N m], [N]
    spring   // between `point` and `other`: they attract each other with stiffness (l - rest) + damping dl/dt [N]
  };
  Kind kind = Kind::force;
  std::string name;  // of the load, unique
  Point point;       // its name is not used
  Axes axes = Axes::inertial;
  Vector vector;
  int reaction = -1;  // of force and moment: a body that the opposite acts on, at the same place in space; -1: none
  Point other;
  bool turn = true;    // of joint: one of the turns of point.body, or of its slides
  int coordinate = 0;  // which of these, from 0
  Number effort, stiffness, damping, rest;
};

}  // namespace kanec::scene
