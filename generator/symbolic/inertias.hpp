// Mass, first moment and inertia of each link about its origin; what its joint cannot feel belongs to the lower link.
// Not here: what joints carry (composites.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/symbolic/algebra.hpp"

namespace kanec::symbolic {

class Derivation;

struct Inertia {
  GiNaC::ex mass;          // [kg]
  GiNaC::ex moment;        // first moment, link axes [kg m]
  GiNaC::ex inertia;       // about the link's origin, link axes [kg m²]
  GiNaC::ex reference;     // what its balance of moments is written about, from the origin, link axes: its mass centre,
                           // or the origin (0) where it is regrouped
  bool regrouped = false;  // something of it went to the lower link, or something of a link above came to it
};

// After the letters. Base parameters after Khalil & Gautier (1990): a point mass at the centre of a ball joint and a
// line of mass along the axis of a turn move with the lower link, whatever the joint does. So of a ball's link m = 0,
// of a turn's m = 0, b·h = 0 and, in link axes of which b is one, another entry of the inertia's diagonal.
void derive_inertias(Derivation& derivation);

}  // namespace kanec::symbolic
