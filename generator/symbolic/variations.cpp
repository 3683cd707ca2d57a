// Derivatives of r without applied loads: how Kane's equations change with one coordinate or one speed, all else and ẏ
// kept. A joint's turn by φ moves all that it carries as one rigid body: δρ = φ × ρ, and with φ fixed in the lower link
// δρ̈ = φ × ρ̈ + 2 φ̇ × ρ̇ + φ̈ × ρ. So each column is one force and one moment at its joint, passed on inward, and each row
// one measure of what its joint carries against the motion of the joints below: both as the columns of A are
// (composites.hpp). After Jain & Rodriguez (1993) and Singh, Russo & Wensing (2022), here for absolute ω, ball joints
// and slides as well, about joint origins.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/stages.hpp"
#include "generator/symbolic/variation_columns.hpp"
#include "generator/symbolic/variation_rows.hpp"

namespace kanec::symbolic {
namespace {

void derive_inertia(Derivation& derivation, By by) {
  Variation variation(derivation, by);
  VariationRows rows(variation);
  VariationColumns columns(variation);
  for (int k = derivation.size(); k >= 1; --k)
    for (const Coordinate& c : derivation.letters(k).coordinates) {
      if (c.row < 0) continue;
      rows.add(k, c);
      columns.add(k, c);
    }
}

}  // namespace

void derive_inertia_xi(Derivation& derivation) { derive_inertia(derivation, By::xi); }
void derive_inertia_y(Derivation& derivation) { derive_inertia(derivation, By::y); }

}  // namespace kanec::symbolic
