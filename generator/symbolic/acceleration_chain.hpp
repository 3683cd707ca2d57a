// Accelerations along the tree by differentiating the velocities once more. Not here: what drives them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

// U_K = ω̇~ + ω̃ω̃ from rates that know ω̇_K: U a is the acceleration that rotation gives a point fixed at a.
GiNaC::ex define_spin(Derivation& derivation, const Rates& rates, int body);

// An acceleration with common factors taken out and U_K by its name.
GiNaC::ex through_spin(const GiNaC::ex& acceleration, const GiNaC::ex& spin, const Rates& rates, const Letters& of);

// Accelerations less gravity, by body from 1; gravity enters as an acceleration −g of the inertial frame, exact since
// every v_K then changes by the same g t.
struct Accelerations {
  std::vector<GiNaC::ex> spin;    // U_K
  std::vector<GiNaC::ex> centre;  // a_K = v̇_K − g
};

// `rates` gives the rates of the speeds.
Accelerations derive_acceleration_chain(Derivation& derivation, Rates rates);

}  // namespace kanec::symbolic
