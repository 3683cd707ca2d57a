// One way to derive a scene's equations; all ways give the same results at different cost. Not: the choice among them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/symbolic/links.hpp"

namespace kanec::symbolic {

// How accelerations are found where joints carry more than one free body.
enum class Algorithm {
  composite,   // A by composite bodies, L D Lᵀ from the leaves inward (composites.hpp, Equations::solves)
  articulated  // joint by joint, inward and back (articulated.hpp)
};

// What accelerations and forces of ball joints' bodies are written in. Of bodies that turn with others it is always
// their own axes.
enum class Axes { inertial, body };

struct Way {
  Reductions reductions = {};
  Algorithm algorithm = Algorithm::composite;
  Axes axes = Axes::inertial;

  bool operator==(const Way&) const = default;
};

}  // namespace kanec::symbolic
