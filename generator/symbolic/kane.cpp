// Kane's equations: r = Σ_K v_{K,y}ᵀ (m_K v̇_K − F_K) + Σ_K ω_{K,y}ᵀ (I_K ω̇_K + ω̃_K I_K ω_K − M_K), and f = −r at ẏ = 0.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/acceleration_chain.hpp"
#include "generator/symbolic/partials.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

// Force and moment balance of each body, from 1.
struct Balance {
  std::vector<ex> force;   // inertial axes [N]
  std::vector<ex> moment;  // about the mass centre, body axes [N m]
};

// Projects the balances on the speeds: column by column from the leaves, bodies that share a partial velocity at once.
void project(Derivation& derivation, const Balance& balance, Function& function, const std::string& name) {
  SubsetSums forces(balance.force, "S", "S", "sum of the force balances of the subtree, inertial axes [N]");
  const auto row = [&](int column, int body, const ex& moment, const std::string& of, const std::string& latex,
                       const std::string& meaning) {
    ex value = moment;
    for (const Group& group : groups(derivation.equations.tables.v_y, column))
      value += derivation.transposed(group.block) * forces.over(derivation, group.bodies);
    const ex symbol = derivation.define(name + "_" + of, latex, body, Pass::inward, value, meaning);
    function.outputs.push_back({symbol, derivation.row(column), 1, false});
  };
  for (int k = derivation.size(); k >= 1; --k) {
    row(derivation.omega_column(k), k, balance.moment[static_cast<std::size_t>(k)], "omega", name + "_{\\omega}",
        "Kane's equation of omega [N m]");
    row(derivation.sdot_column(k), k, 0, "sdot", name + "_{\\dot s}", "Kane's equation of sdot [N]");
  }
}

}  // namespace

void derive_residual(Derivation& derivation) {
  const Accelerations chain = derive_acceleration_chain(derivation, derivation.rates);
  Balance balance{{ex(0)}, {ex(0)}};
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& body = derivation.letters(k);
    const auto at = static_cast<std::size_t>(k);
    balance.force.push_back(derivation.define("G", "G", k, Pass::outward, body.mass * chain.centre[at] - body.force,
                                              "force balance, inertial axes [N]"));
    // I ω̇ + ω̃ I ω, of which U_K holds all products
    balance.moment.push_back(derivation.define("N", "N", k, Pass::outward,
                                               inertia_moment(chain.spin[at], body.inertia) - body.moment,
                                               "moment balance about the mass centre, body axes [N m]"));
  }
  Function function{"residual", "r = A ydot - f", {}, 6 * derivation.size(), false,
                    {true, true, true, true, "r", "r (ny) [N m], [N]"}};
  project(derivation, balance, function, "r");
  derivation.equations.functions.push_back(function);
}

void derive_forcing(Derivation& derivation) {
  Rates at_rest = derivation.rates;
  for (int k = 1; k <= derivation.size(); ++k) {
    at_rest.set(derivation.letters(k).omega, 0);
    at_rest.set(derivation.letters(k).sdot, 0);
  }
  const Accelerations chain = derive_acceleration_chain(derivation, at_rest);
  Balance balance{{ex(0)}, {ex(0)}};
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& body = derivation.letters(k);
    const auto at = static_cast<std::size_t>(k);
    balance.force.push_back(derivation.define("G", "G", k, Pass::outward, body.force - body.mass * chain.centre[at],
                                              "applied less inertia force at ydot = 0, inertial axes [N]"));
    balance.moment.push_back(derivation.define("N", "N", k, Pass::outward,
                                               body.moment - gyroscopic(body.inertia, body.omega),
                                               "applied less inertia moment at omegadot = 0, body axes [N m]"));
  }
  Function function{"forcing", "f of A ydot = f", {}, 6 * derivation.size(), false,
                    {true, true, false, true, "f", "f (ny) [N m], [N]"}};
  project(derivation, balance, function, "f");
  derivation.equations.functions.push_back(function);
}

}  // namespace kanec::symbolic
