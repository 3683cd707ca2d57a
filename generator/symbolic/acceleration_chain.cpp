// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/acceleration_chain.hpp"

#include "generator/symbolic/factor.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

ex spin_value(const Rates& rates, const Letters& of) {
  return skew(of.omega) * skew(of.omega) + skew(rates.of(of.omega));
}

}  // namespace

ex define_spin(Derivation& derivation, const Rates& rates, int body) {
  return derivation.define("U", "U", body, Pass::outward, spin_value(rates, derivation.letters(body)),
                           "takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]");
}

ex through_spin(const ex& acceleration, const ex& spin, const Rates& rates, const Letters& of) {
  const ex simple = factored(acceleration);
  if (of.omega.is_zero()) return simple;
  const ex value = spin_value(rates, of);
  return simple.subs(GiNaC::lst{value == spin, -value == -spin}, GiNaC::subs_options::no_pattern);
}

Accelerations derive_acceleration_chain(Derivation& derivation, Rates rates) {
  const Tables& tables = derivation.equations.tables;
  Accelerations chain{{ex(0)}, {ex(0)}};
  for (int k = 1; k <= derivation.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    const int below = derivation.lower(k);
    chain.spin.push_back(define_spin(derivation, rates, k));
    const ex gravity = below == 0 ? derivation.equations.gravity : ex(0);
    const ex origin = rates.of(tables.origin_rate[at - 1]) - gravity;
    const ex Pddot = derivation.define(
        "Pddot", "\\ddot P", k, Pass::outward,
        through_spin(origin, chain.spin[static_cast<std::size_t>(below)], rates, derivation.letters(below)),
        "acceleration of the body origin, less gravity, inertial axes [m/s^2]");
    rates.set(derivation.origin_rates[at], Pddot);
    const ex centre = rates.of(tables.velocity[at - 1]);
    chain.centre.push_back(derivation.define("a", "a", k, Pass::outward,
                                             through_spin(centre, chain.spin[at], rates, derivation.letters(k)),
                                             "acceleration of the mass centre, less gravity, inertial axes [m/s^2]"));
  }
  return chain;
}

}  // namespace kanec::symbolic
