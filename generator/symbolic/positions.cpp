// Positions from the connection array; everything else is differentiated from them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/derivation.hpp"
#include "generator/symbolic/factor.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

// P_K = P_L + R_Lᵀ (q_K + s_K), p_K = P_K + R_Kᵀ r_K, with P_0 = 0 and R_0 = 1.
void derive_positions(Derivation& derivation) {
  derivation.origins = derivation.centres = derivation.joint_offsets = {ex(0)};
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& link = derivation.letters(k);
    const auto below = static_cast<std::size_t>(derivation.lower(k));
    const ex& to_inertial = derivation.letters(derivation.lower(k)).to_inertial;
    const ex d = derivation.define("d", "d", k, Pass::outward, link.offset + link.s,
                                   "joint offset q + s, axes of the lower body [m]");
    if (!d.is_equal(link.s) && !link.sdot.is_zero()) derivation.rates.set(d, link.sdot);
    derivation.joint_offsets.push_back(d);
    const ex origin = derivation.origins[below] + to_inertial * d;
    derivation.equations.tables.origin.push_back(origin);
    const ex P =
        derivation.define("P", "P", k, Pass::outward, origin, "position of the body origin, inertial axes [m]");
    const ex centre = P + link.to_inertial * link.r;
    derivation.equations.tables.centre.push_back(centre);
    derivation.origins.push_back(P);
    derivation.centres.push_back(
        derivation.define("p", "p", k, Pass::outward, centre, "position of the mass centre, inertial axes [m]"));
  }
}

// Ṗ_K and v_K by differentiating the positions in time, through their names.
void derive_velocities(Derivation& derivation) {
  derivation.origin_rates = derivation.velocities = {ex(0)};
  Tables& tables = derivation.equations.tables;
  for (int k = 1; k <= derivation.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    const ex origin_rate = derivation.rates.of(tables.origin[at - 1]);
    tables.origin_rate.push_back(origin_rate);
    const ex Pdot = derivation.define("Pdot", "\\dot P", k, Pass::outward, factored(origin_rate),
                                      "velocity of the body origin, inertial axes [m/s]");
    // a name that stands for its lower body's has its rate already
    const auto set_rate = [&](const ex& of, const ex& before, const ex& rate) {
      if (!GiNaC::is_a<Atom>(of) || of.is_equal(before)) return;
      if (derivation.equations.table.of(of).role == Role::quantity) derivation.rates.set(of, rate);
    };
    set_rate(derivation.origins[at], derivation.origins[static_cast<std::size_t>(derivation.lower(k))], Pdot);
    const ex velocity = derivation.rates.of(tables.centre[at - 1]);
    tables.velocity.push_back(velocity);
    const ex v = derivation.define("v", "v", k, Pass::outward, factored(velocity),
                                   "velocity of the mass centre, inertial axes [m/s]");
    set_rate(derivation.centres[at], derivation.origins[at], v);
    derivation.origin_rates.push_back(Pdot);
    derivation.velocities.push_back(v);
  }
}

}  // namespace kanec::symbolic
