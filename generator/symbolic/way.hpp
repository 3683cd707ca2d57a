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

// How derivatives of residual and accelerations are made.
enum class Derivatives {
  operations,  // of the function's own program, operation by operation (program/jacobian.cpp)
  equations    // of Kane's equations, joint by joint (variations.cpp); of accelerations −A⁻¹ times these
};

struct Way {
  Reductions reductions = {};
  Algorithm algorithm = Algorithm::composite;
  Axes axes = Axes::inertial;
  Derivatives derivatives = Derivatives::operations;

  bool operator==(const Way&) const = default;
};

}  // namespace kanec::symbolic
