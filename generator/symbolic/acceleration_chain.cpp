// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/acceleration_chain.hpp"

#include <algorithm>

#include "generator/symbolic/factor.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

// U = ω̇~ + ω̃ω̃: U a is the acceleration that rotation gives a point fixed at a.
ex spin_value(const Rates& rates, const ex& omega) { return skew(omega) * skew(omega) + skew(rates.of(omega)); }

// ω̃ω̃ by its name U wherever it stands in a product, unless ω̃ alone stands in another: ω̃ (ω̃ d + 2 ṡ) is cheaper then.
ex with_square(const ex& e, const ex& omega, const ex& U) {
  const ex cross = skew(omega);
  std::vector<Term> terms = expanded(e);
  for (Term& term : terms) {
    const auto first = std::find_if(term.factors.begin(), term.factors.end(),
                                    [&cross](const ex& factor) { return factor.is_equal(cross); });
    if (first == term.factors.end()) continue;
    if (first + 1 == term.factors.end() || !(first + 1)->is_equal(cross)) return e;
    *first = U;
    term.factors.erase(first + 1);
  }
  return factored(sum(terms));
}

}  // namespace

AccelerationChain::AccelerationChain(Derivation& derivation, Rates rates, std::vector<bool> beside_rest)
    : derivation_(derivation),
      rates_(std::move(rates)),
      beside_rest_(std::move(beside_rest)),
      spin_{ex(0)},
      origin_{-derivation.equations.gravity} {}

ex AccelerationChain::define(const std::string& name, const std::string& latex, int k, const ex& value,
                             const std::string& meaning) {
  const auto at = static_cast<std::size_t>(k);
  const bool is_solved = at < beside_rest_.size() && beside_rest_[at];
  return derivation_.define(is_solved ? name + "_solved_" : name, is_solved ? latex + "^{*}" : latex, k, Pass::outward,
                            value, meaning);
}

void AccelerationChain::add_spin(int k) {
  const Letters& link = derivation_.letters(k);
  const int below = derivation_.lower(k);
  if (link.turns_with_lower && link.to_lower.is_equal(1)) {
    spin_.push_back(spin_[static_cast<std::size_t>(below)]);
    return;
  }
  if (link.turns_with_lower && GiNaC::is_a<Atom>(link.omega))
    rates_.set(link.omega, define("omegadot", "\\dot\\omega", k, factored(rates_.of(link.omega_value)),
                                  "angular acceleration, body axes [rad/s^2]"));
  spin_.push_back(define("U", "U", k, spin_value(rates_, link.omega),
                         "takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]"));
}

ex AccelerationChain::with_spin(const ex& acceleration, int k) const {
  const ex simple = factored(acceleration);
  const ex& omega = derivation_.letters(k).omega;
  if (omega.is_zero()) return simple;
  const ex value = spin_value(rates_, omega);
  if (rates_.of(omega).is_zero()) return with_square(simple, omega, spin(k));
  return simple.subs(GiNaC::lst{value == spin(k), -value == -spin(k)}, GiNaC::subs_options::no_pattern);
}

void AccelerationChain::add_origin(int k, const ex* known) {
  const int below = derivation_.lower(k);
  const ex value = known ? *known : with_spin(derivation_.in_axes(joint_point(k), below, derivation_.home(k)), below);
  origin_.push_back(define("Pddot", "\\ddot P", k, value,
                           derivation_.home(k) == 0
                               ? "acceleration of the body origin, less gravity, inertial axes [m/s^2]"
                               : "acceleration of the body origin, less gravity, body axes [m/s^2]"));
}

ex AccelerationChain::joint_point(int k) const {
  const int below = derivation_.lower(k);
  const ex relative = derivation_.equations.tables.origin_rate[static_cast<std::size_t>(k - 1)] -
                      derivation_.origin_rates[static_cast<std::size_t>(below)];
  return derivation_.in_axes(origin(below), derivation_.home(below), below) +
         derivation_.in_axes(rates_.of(relative), 0, below);
}

ex AccelerationChain::about_origin(int k) const {
  const auto at = static_cast<std::size_t>(k);
  const ex value = rates_.of(derivation_.equations.tables.velocity[at - 1] - derivation_.origin_rates[at]);
  return with_spin(derivation_.in_axes(value, 0, derivation_.home(k)), k);
}

ex AccelerationChain::centre(int k) {
  return define("a", "a", k, origin(k) + about_origin(k),
                derivation_.home(k) == 0 ? "acceleration of the mass centre, less gravity, inertial axes [m/s^2]"
                                         : "acceleration of the mass centre, less gravity, body axes [m/s^2]");
}

ex AccelerationChain::of_point(int k, const ex& place) const {
  return origin(k) + derivation_.in_axes(spin(k) * place, k, derivation_.home(k));
}

AccelerationChain derive_acceleration_chain(Derivation& derivation, const Rates& rates) {
  AccelerationChain chain(derivation, rates);
  for (int k = 1; k <= derivation.size(); ++k) {
    chain.add_spin(k);
    chain.add_origin(k);
  }
  return chain;
}

}  // namespace kanec::symbolic
