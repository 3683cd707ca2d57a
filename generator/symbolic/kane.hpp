// Kane's equations as emitted functions: residual, forcing, and what drives or holds the joints. Not: solved for ẏ.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/symbolic/acceleration_chain.hpp"
#include "generator/symbolic/inward_sums.hpp"

namespace kanec::symbolic {

void derive_residual(Derivation& derivation);
void derive_forcing(Derivation& derivation);
// Need a mechanism in which nothing is merged or dropped.
void derive_driving_loads(Derivation& derivation);
void derive_reactions(Derivation& derivation);

// Rates with ẏ = 0; prescribed coordinates keep theirs.
Rates rates_at_rest(const Derivation& derivation);

// Applied less inertia force and moment of each link.
Balance applied_less_inertia(Derivation& derivation, AccelerationChain& chain);

// Inertia force and moment of each link, whatever is applied.
Balance inertia_alone(Derivation& derivation, AccelerationChain& chain);

// Of Kane's equation of one of a link's coordinates, its suffix left out: "r_sdot", "f_theta".
struct RowLetter {
  std::string name, latex;
};
RowLetter row_letter(const std::string& letter, const Letters& link, const Coordinate& coordinate);

}  // namespace kanec::symbolic
