// What a joint carries while it moves: first and second moments of mass with their rates, and what of its inertia
// forces turns with the joint and what does not. Not: the mass matrix (composites.hpp), derivatives (variations.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/symbolic/acceleration_chain.hpp"
#include "generator/symbolic/composites.hpp"
#include "generator/symbolic/inward_sums.hpp"

namespace kanec::symbolic {

// About the origin of a link, with ρ from there to a point of mass dm that turns when the link does. Bodies beyond a
// ball joint do not turn: they count as their mass at the joint's point, and what they pull there besides as a force
// that keeps its direction.
struct Carried {
  GiNaC::ex mass;      // Σ dm, of all
  GiNaC::ex moment;    // h = Σ dm ρ
  GiNaC::ex rate;      // 2 Σ dm ρ̇
  GiNaC::ex inertia;   // J = −Σ dm ρ̃ ρ̃
  GiNaC::ex coriolis;  // K = −2 Σ dm ρ̃ ρ̇~: moment of 2 b × ρ̇ is K b
  GiNaC::ex pull;      // f = Σ F − dm P̈ of what is beyond balls
  GiNaC::ex arms;      // W = Σ f̃ ρ̃
  GiNaC::ex force;     // inertia force of all, less gravity
  GiNaC::ex torque;    // its moment about the origin
  GiNaC::ex origin;    // P̈ less gravity
};

class CarriedMotion {
 public:
  CarriedMotion(Derivation& derivation, const AccelerationChain& chain, const InwardSums& sums, Composites& composites);

  // Link axes; force and origin in home axes.
  const Carried& of_link(int link) const { return links_[static_cast<std::size_t>(link)]; }
  // As the lower link feels it through the joint's turn, slides left out: lower link's axes.
  const Carried& at_joint(int link);
  // Twice the rate of the joint's place on the lower link, lower link's axes.
  const GiNaC::ex& joint_rate(int link);

 private:
  void add(int link);
  Carried turned(int link);
  Carried beyond_ball(int link);
  GiNaC::ex define(const std::string& name, int link, const GiNaC::ex& value, const std::string& meaning);

  Derivation& derivation_;
  const AccelerationChain& chain_;
  const InwardSums& sums_;
  Composites& composites_;
  std::vector<Carried> links_;
  std::map<int, Carried> joints_;
  std::map<int, GiNaC::ex> joint_rates_;
};

}  // namespace kanec::symbolic
