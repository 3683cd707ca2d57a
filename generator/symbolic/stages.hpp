// The stages of the derivation that fill one emitted function each. Not: what comes before them (derivation.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

void derive_kinematics(Derivation& derivation);
void derive_poses(Derivation& derivation);
void derive_energy(Derivation& derivation);
void derive_momentum(Derivation& derivation);
void derive_power(Derivation& derivation);
void derive_load_powers(Derivation& derivation);
void derive_events(Derivation& derivation);
void derive_accelerations(Derivation& derivation);
void derive_mass_matrix(Derivation& derivation);
// Parts of derivatives of the residual: by the tangent of x and by y of all but what is applied, and what is applied
// itself.
void derive_inertia_xi(Derivation& derivation);
void derive_inertia_y(Derivation& derivation);
void derive_applied(Derivation& derivation);
// "<point>_position" and the like.
void derive_point_function(Derivation& derivation, const std::string& name);

}  // namespace kanec::symbolic
