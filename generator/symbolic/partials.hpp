// Partial velocities of any point of a link, and the emitted functions of them. Not: what they are used for.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

// Partial velocities of all links, and their rates: the tables.
void derive_partial_velocities(Derivation& derivation);

// Partial velocities of a point at `place` from the link's origin, link axes; its velocity is that of the origin and
// R^T omega~ place.
Blocks partials_of_point(const Derivation& derivation, int link, const GiNaC::ex& place);

// Emitted functions partial_velocities, partial_angular_velocities and their rates, of the bodies of the scene.
void derive_partial_velocity_functions(Derivation& derivation, const std::string& name);

}  // namespace kanec::symbolic
