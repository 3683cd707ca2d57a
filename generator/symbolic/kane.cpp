// Kane's equations: r = Σ_K v_{K,y}ᵀ (m_K v̇_K − F_K) + Σ_K ω_{K,y}ᵀ (I_K ω̇_K + ω̃_K I_K ω_K − M_K), and f = −r at ẏ = 0.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/kane.hpp"

#include "generator/symbolic/factor.hpp"
#include "generator/symbolic/loads.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

namespace {

enum class Motion { as_given, at_rest };  // of ẏ

// m a of a link; of a regrouped one m P̈ + U h. Home axes.
ex inertia_force(Derivation& derivation, AccelerationChain& chain, int k) {
  const Inertia& own = derivation.inertia(k);
  if (!own.regrouped) return own.mass.is_zero() ? ex(0) : own.mass * chain.centre(k);
  ex force = own.mass * chain.origin(k);
  if (!own.moment.is_zero()) force += derivation.in_axes(chain.spin(k) * own.moment, k, derivation.home(k));
  return force;
}

// I ω̇ + ω̃ I ω, of which U holds all products, about the reference point: of a regrouped link also h × P̈. Link axes. Of
// a ball at rest ω̇ = 0, of others it is what the speeds leave.
ex inertia_moment_of(Derivation& derivation, const AccelerationChain& chain, int k, Motion motion) {
  const Letters& link = derivation.letters(k);
  const Inertia& own = derivation.inertia(k);
  const ex& inertia = own.regrouped ? own.inertia : link.inertia;
  const bool is_steady = motion == Motion::at_rest && !link.turns_with_lower;
  ex moment = 0;
  if (!inertia.is_zero() && !chain.spin(k).is_zero())
    moment = is_steady ? gyroscopic(inertia, link.omega) : inertia_moment(chain.spin(k), inertia);
  if (own.regrouped && !own.moment.is_zero())
    moment += skew(own.moment) * derivation.in_axes(chain.origin(k), derivation.home(k), k);
  return moment;
}

// Inertia less applied force and moment of each link; by sign −1 applied less inertia.
Balance balance_of(Derivation& derivation, AccelerationChain& chain, const AppliedLoads& loads, Motion motion) {
  Balance balance{{ex(0)}, {ex(0)}};
  const int sign = motion == Motion::at_rest ? -1 : 1;
  const std::string of = motion == Motion::at_rest ? "applied less inertia " : "inertia less applied ";
  for (int k = 1; k <= derivation.size(); ++k) {
    const auto at = static_cast<std::size_t>(k);
    const std::string axes = derivation.home(k) == 0 ? "inertial axes [N]" : "body axes [N]";
    const std::string about = derivation.inertia(k).regrouped ? "the body origin" : "the mass centre";
    const ex force = sign * (inertia_force(derivation, chain, k) - loads.force[at]);
    balance.force.push_back(derivation.define("G", "G", k, Pass::outward, force, of + "force, " + axes));
    const ex moment = sign * (inertia_moment_of(derivation, chain, k, motion) - loads.moment[at]);
    balance.moment.push_back(derivation.define("N", "N", k, Pass::outward, factored(moment),
                                               of + "moment about " + about + ", body axes [N m]"));
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
  const Balance balance = balance_of(derivation, chain, loads, Motion::as_given);
  return {InwardSums(derivation, balance, "r"), std::move(loads)};
}

}  // namespace

RowLetter row_letter(const std::string& letter, const Letters& link, const Coordinate& c) {
  switch (c.freedom.kind) {
    case Freedom::Kind::attitude:
      return {letter + "_omega", letter + "_{\\omega_{#}}"};
    case Freedom::Kind::turn:
      return {letter + "_theta", letter + "_{\\theta_{#}}"};
    default:
      break;
  }
  const bool is_one_of_many = c.freedom.kind == Freedom::Kind::slide && link.coordinates.size() > 1;
  if (!is_one_of_many) return {letter + "_sdot", letter + "_{\\dot s_{#}}"};
  const std::string component = std::to_string(c.freedom.coordinate + 1);
  return {letter + "_sdot" + component + "_", letter + "_{\\dot s_{#," + component + "}}"};
}

namespace {

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
      const RowLetter row = row_letter(letter, derivation.letters(k), c);
      const ex symbol = derivation.define(row.name, row.latex, k, Pass::inward, value, row_meaning(c));
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
  return balance_of(derivation, chain, applied_loads(derivation), Motion::at_rest);
}

Balance inertia_alone(Derivation& derivation, AccelerationChain& chain) {
  const std::vector<ex> none(static_cast<std::size_t>(derivation.size()) + 1);
  return balance_of(derivation, chain, {none, none, {}, {}}, Motion::as_given);
}

// Less the applied forces and moments, projected.
void derive_applied(Derivation& derivation) {
  const AppliedLoads loads = applied_loads(derivation);
  Balance balance;
  for (const ex& force : loads.force) balance.force.push_back(-force);
  for (const ex& moment : loads.moment) balance.moment.push_back(-moment);
  fill(derivation, InwardSums(derivation, balance, "r"), loads, "r", -1, derivation.function("applied"));
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
        if (coordinates[i].row >= 0 || is_rotation(coordinates[i]) != rotation) continue;
        const ex value = r.sums.row(k, coordinates[i]) - r.loads.effort[static_cast<std::size_t>(k)][i];
        function.outputs.push_back({value, at, 1, false});
        at += coordinates[i].freedom.kind == Freedom::Kind::attitude ? 3 : 1;
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
