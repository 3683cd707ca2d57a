// Derivatives of emitted functions with respect to the state, by coordinates as they are or by the tangent of
// rotations. Not: how operations are differentiated (program/derivative.hpp). SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::lower {

// A function that is made of others by differentiation.
struct Derived {
  std::string name;  // "accelerations_x"
  std::string meaning;
  std::string of;  // "accelerations"
  int rows = 0, columns = 0;
  program::Signature signature;
};

// Those of a scene, in order.
std::vector<Derived> derived_functions(const scene::Scene& scene);

// Appends one to a program that has the function it is made of.
void append_derived(program::Program& program, const scene::Scene& scene, const Derived& derived);

}  // namespace kanec::lower
