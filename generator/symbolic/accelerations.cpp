// A ẏ = f solved without A. A = Vᵀ 𝓜 V with V the stacked partial velocities. Where every joint is free, V is square,
// block triangular along the tree, and its diagonal blocks (1 for ω_K, a rotation for ṡ_K) are invertible: so
// Vᵀ (𝓜 (V ẏ + V̇ y) − F) = 0 holds just when each body's own balance does, m_K a_K = F_K and I_K ω̇_K + ω̃_K I_K ω_K = M_K.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/acceleration_chain.hpp"
#include "generator/symbolic/factor.hpp"
#include "runtime/base/error.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

// The diagonal block of V of ṡ_K, its own partial velocity: a rotation (or 1) where the joint is free.
ex diagonal_block(const Derivation& derivation, int k) {
  const Blocks& own = derivation.equations.tables.v_y[static_cast<std::size_t>(k - 1)];
  const ex block = own.at(derivation.sdot_column(k));
  if (!block.is_equal(derivation.letters(derivation.lower(k)).to_inertial))
    throw InternalError("accelerations by decoupling need free joints");
  return block;
}

// s̈_K from P̈_K = (what the lower body gives) + V_KK s̈_K, all less gravity.
ex solve_sddot(Derivation& derivation, Rates& rates, int k, const ex& Pddot, const ex& spin_below) {
  const Letters& body = derivation.letters(k);
  const Letters& below = derivation.letters(derivation.lower(k));
  const ex block = diagonal_block(derivation, k);
  rates.set(body.sdot, 0);
  ex carried = rates.of(derivation.equations.tables.origin_rate[static_cast<std::size_t>(k - 1)]);
  if (derivation.lower(k) == 0) carried -= derivation.equations.gravity;
  const ex inverse_block = block.is_equal(1) ? block : derivation.transposed(block);
  const ex sddot = with_orthonormal_rotations(inverse_block * (Pddot - carried), derivation.equations.table);
  return through_spin(sddot, spin_below, rates, below);
}

}  // namespace

void derive_accelerations(Derivation& derivation) {
  Rates rates = derivation.rates;
  std::vector<ex> spin = {ex(0)};
  Function function{"accelerations", "ydot from A ydot = f", {}, 6 * derivation.size(), false,
                    {true, true, false, true, "ydot", "rates of y (ny) [rad/s^2], [m/s^2]"}};
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& body = derivation.letters(k);
    const auto at = static_cast<std::size_t>(k);
    const auto define = [&](const char* name, const char* latex, const ex& value, const char* meaning) {
      return derivation.define(name, latex, k, Pass::outward, value, meaning);
    };
    const ex moment = define("N", "N", body.moment - gyroscopic(body.inertia, body.omega),
                             "applied less gyroscopic moment, body axes [N m]");
    const ex inertia_inverse = define("Iinv", "I^{-1}", inverse(body.inertia), "inverse of the inertia matrix");
    const ex omegadot = define("omegadot", "\\dot\\omega", inertia_inverse * moment, "I omegadot + omega~ I omega = M");
    rates.set(body.omega, omegadot);
    spin.push_back(define_spin(derivation, rates, k));
    const ex centre = define("a", "a", body.force / body.mass,
                             "acceleration of the mass centre, less gravity, inertial axes [m/s^2]");
    const Tables& tables = derivation.equations.tables;
    const ex of_centre = rates.of(tables.velocity[at - 1] - derivation.origin_rates[at]);
    const ex Pddot = define("Pddot", "\\ddot P", centre - through_spin(of_centre, spin[at], rates, body),
                            "acceleration of the body origin, less gravity, inertial axes [m/s^2]");
    const ex sddot = define("sddot", "\\ddot s",
                            solve_sddot(derivation, rates, k, Pddot, spin[static_cast<std::size_t>(derivation.lower(k))]),
                            "relative acceleration, axes of the lower body [m/s^2]");
    rates.set(derivation.origin_rates[at], Pddot);
    function.outputs.push_back({omegadot, derivation.row(derivation.omega_column(k)), 1, false});
    function.outputs.push_back({sddot, derivation.row(derivation.sdot_column(k)), 1, false});
  }
  derivation.equations.functions.push_back(function);
}

}  // namespace kanec::symbolic
