// Derivatives of emitted functions with respect to the state, by coordinates as they are or by the tangent of
// rotations. Not: how operations are differentiated (program/derivative.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"
#include "generator/symbolic/way.hpp"

namespace kanec::lower {

// A function that is made of others by differentiation.
struct Derived {
  std::string name;  // "accelerations_x"
  std::string meaning;
  std::string of;               // "accelerations"
  std::vector<std::string> by;  // directions.hpp
  int rows = 0, columns = 0;
  program::Signature signature;
};

// Those of a scene, in order.
std::vector<Derived> derived_functions(const scene::Scene& scene);

// The one of this name, if it is one.
std::optional<Derived> derived_function(const scene::Scene& scene, const std::string& name);

// The functions that it is made of.
std::vector<std::string> parts_of(const Derived& derived, symbolic::Derivatives way);

// Appends one to a program that has these, simplified.
void append_derived(program::Program& program, const scene::Scene& scene, const Derived& derived,
                    symbolic::Derivatives way);

}  // namespace kanec::lower
