// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/derive.hpp"

#include <utility>

#include "generator/symbolic/partials.hpp"

namespace kanec::symbolic {

Equations derive(const scene::Scene& scene) {
  Derivation derivation(scene);
  derive_positions(derivation);
  derive_velocities(derivation);
  derive_partial_velocities(derivation);
  derive_measures(derivation);
  derive_accelerations(derivation);
  derive_residual(derivation);
  derive_forcing(derivation);
  derive_mass_matrix(derivation);
  derive_partial_velocity_functions(derivation);
  return std::move(derivation.equations);
}

}  // namespace kanec::symbolic
