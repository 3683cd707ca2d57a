// Kane's equations: r = Σ_K v_{K,y}ᵀ (m_K v̇_K − F_K) + Σ_K ω_{K,y}ᵀ (I_K ω̇_K + ω̃_K I_K ω_K − M_K), and f = −r at ẏ = 0.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/kane.hpp"

#include "generator/symbolic/loads.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

std::string component(const Coordinate& c) {
  return c.freedom.kind == Freedom::Kind::slide || c.freedom.kind == Freedom::Kind::turn
             ? std::to_string(c.freedom.coordinate + 1) + "_"
             : "";
}

// Inertia less applied force and moment of each link.
Balance inertia_less_applied(Derivation& derivation, AccelerationChain& chain, const AppliedLoads& loads) {
  Balance balance{{ex(0)}, {ex(0)}};
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& link = derivation.letters(k);
    const auto at = static_cast<std::size_t>(k);
    const ex centre = link.mass.is_zero() ? ex(0) : chain.centre(k);
    balance.force.push_back(derivation.define(
        "G", "G", k, Pass::outward, link.mass * centre - loads.force[at],
        derivation.home(k) == 0 ? "force balance, inertial axes [N]" : "force balance, body axes [N]"));
    // I ω̇ + ω̃ I ω, of which U_K holds all products
    const ex inertia =
        link.inertia.is_zero() || chain.spin(k).is_zero() ? ex(0) : inertia_moment(chain.spin(k), link.inertia);
    balance.moment.push_back(derivation.define("N", "N", k, Pass::outward, inertia - loads.moment[at],
                                               "moment balance about the mass centre, body axes [N m]"));
  }
  return balance;
}

struct Residual {
  InwardSums sums;
  AppliedLoads loads;
};

Residual residual(Derivation& derivation) {
  AccelerationChain chain = derive_acceleration_chain(derivation, derivation.rates);
  AppliedLoads loads = applied_loads(derivation);
  const Balance balance = inertia_less_applied(derivation, chain, loads);
  return {InwardSums(derivation, balance, "r"), std::move(loads)};
}

}  // namespace

std::string row_name(const std::string& letter, const Coordinate& c) {
  switch (c.freedom.kind) {
    case Freedom::Kind::attitude:
      return letter + "_omega";
    case Freedom::Kind::turn:
      return letter + "_theta";
    default:
      return letter + "_sdot";
  }
}

namespace {

std::string row_latex(const std::string& letter, const Coordinate& c) {
  switch (c.freedom.kind) {
    case Freedom::Kind::attitude:
      return letter + "_{\\omega}";
    case Freedom::Kind::turn:
      return letter + "_{\\theta}";
    default:
      return letter + "_{\\dot s}";
  }
}

std::string row_meaning(const Coordinate& c) {
  switch (c.freedom.kind) {
    case Freedom::Kind::attitude:
      return "Kane's equation of omega [N m]";
    case Freedom::Kind::turn:
      return "Kane's equation of the angle [N m]";
    default:
      return "Kane's equation of sdot [N]";
  }
}

// r = row − effort, f = row + effort, for each coordinate of the state.
void fill(Derivation& derivation, const InwardSums& sums, const AppliedLoads& loads, const std::string& letter,
          int sign, Function& function) {
  for (int k = derivation.size(); k >= 1; --k) {
    const std::vector<Coordinate>& coordinates = derivation.letters(k).coordinates;
    for (std::size_t i = 0; i < coordinates.size(); ++i) {
      const Coordinate& c = coordinates[i];
      if (c.row < 0) continue;
      const ex value = sums.row(k, c) + sign * loads.effort[static_cast<std::size_t>(k)][i];
      const bool is_one_of_many = c.freedom.kind == Freedom::Kind::slide && coordinates.size() > 1;
      const ex symbol = derivation.define(row_name(letter, c) + (is_one_of_many ? component(c) : ""),
                                          row_latex(letter, c), k, Pass::inward, value, row_meaning(c));
      function.outputs.push_back({symbol, c.row, 1, false});
    }
  }
}

}  // namespace

void derive_residual(Derivation& derivation) {
  const Residual r = residual(derivation);
  fill(derivation, r.sums, r.loads, "r", -1, derivation.function("residual"));
}

Rates rates_at_rest(const Derivation& derivation) {
  Rates at_rest = derivation.rates;
  for (int k = 1; k <= derivation.size(); ++k)
    for (const Coordinate& c : derivation.letters(k).coordinates)
      if (c.row >= 0) at_rest.set(c.speed, 0);
  return at_rest;
}

Balance applied_less_inertia(Derivation& derivation, AccelerationChain& chain) {
  const AppliedLoads loads = applied_loads(derivation);
  Balance balance{{ex(0)}, {ex(0)}};
  for (int k = 1; k <= derivation.size(); ++k) {
    const Letters& link = derivation.letters(k);
    const auto at = static_cast<std::size_t>(k);
    const ex centre = link.mass.is_zero() ? ex(0) : chain.centre(k);
    balance.force.push_back(derivation.define("G", "G", k, Pass::outward, loads.force[at] - link.mass * centre,
                                              derivation.home(k) == 0
                                                  ? "applied less inertia force at ydot = 0, inertial axes [N]"
                                                  : "applied less inertia force at ydot = 0, body axes [N]"));
    // of a ball ω̇ = 0 here, of others it is what the speeds leave
    ex inertia = 0;
    if (!link.inertia.is_zero() && !link.omega.is_zero())
      inertia =
          link.turns_with_lower ? inertia_moment(chain.spin(k), link.inertia) : gyroscopic(link.inertia, link.omega);
    balance.moment.push_back(derivation.define("N", "N", k, Pass::outward, loads.moment[at] - inertia,
                                               "applied less inertia moment at ydot = 0, body axes [N m]"));
  }
  return balance;
}

void derive_forcing(Derivation& derivation) {
  AccelerationChain chain = derive_acceleration_chain(derivation, rates_at_rest(derivation));
  const Balance balance = applied_less_inertia(derivation, chain);
  const InwardSums sums(derivation, balance, "f");
  fill(derivation, sums, applied_loads(derivation), "f", 1, derivation.function("forcing"));
}

void derive_driving_loads(Derivation& derivation) {
  const Residual r = residual(derivation);
  Function& function = derivation.function("driving_loads");
  int at = 0;
  for (const bool rotation : {true, false})
    for (int k = 1; k <= derivation.size(); ++k) {
      const std::vector<Coordinate>& coordinates = derivation.letters(k).coordinates;
      for (std::size_t i = 0; i < coordinates.size(); ++i) {
        const Freedom::Kind kind = coordinates[i].freedom.kind;
        const bool is_rotation = kind == Freedom::Kind::attitude || kind == Freedom::Kind::turn;
        if (coordinates[i].row >= 0 || is_rotation != rotation) continue;
        const ex value = r.sums.row(k, coordinates[i]) - r.loads.effort[static_cast<std::size_t>(k)][i];
        function.outputs.push_back({value, at, 1, false});
        at += kind == Freedom::Kind::attitude ? 3 : 1;
      }
    }
}

// The force and the moment that a joint passes on are the sums of what it carries, with what acts in the joint itself.
void derive_reactions(Derivation& derivation) {
  const Residual r = residual(derivation);
  Function& function = derivation.function("reactions");
  for (int k = 1; k <= derivation.n_bodies(); ++k) {
    const BodyFrame& body = derivation.body(k);
    const int link = body.link;
    // through all frames of the joint the force is the same, and so is the moment about their common origin
    const ex sum = r.sums.force(link) + r.loads.through_joint[static_cast<std::size_t>(link)];
    const ex force = derivation.in_axes(sum, derivation.home(link), link);
    function.outputs.push_back({body.orientation_transposed * force, 6 * (k - 1), 1, false});
    function.outputs.push_back({body.orientation_transposed * r.sums.moment(link), 6 * (k - 1) + 3, 1, false});
  }
}

}  // namespace kanec::symbolic
