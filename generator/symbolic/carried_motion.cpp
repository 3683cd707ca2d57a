// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/carried_motion.hpp"

#include "generator/symbolic/factor.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

CarriedMotion::CarriedMotion(Derivation& derivation, const AccelerationChain& chain, const InwardSums& sums,
                             Composites& composites)
    : derivation_(derivation),
      chain_(chain),
      sums_(sums),
      composites_(composites),
      links_(static_cast<std::size_t>(derivation.size()) + 1) {
  for (int k = derivation.size(); k >= 1; --k) add(k);
}

ex CarriedMotion::define(const std::string& name, int k, const ex& value, const std::string& meaning) {
  return derivation_.define(name, name, k, Pass::inward, factored(value), meaning);
}

// With d from the origin to a joint: rate + 2 m ḋ, K − d̃ (rate + 2 m ḋ)~ − 2 h̃ ḋ~, W + f̃ d̃.
void CarriedMotion::add(int k) {
  const Letters& link = derivation_.letters(k);
  const Inertia& own = derivation_.inertia(k);
  Carried sum{composites_.mass(k), composites_.moment(k), 0, composites_.inertia(k), 0, 0, 0, sums_.force(k),
              sums_.moment(k),     chain_.origin(k)};
  const ex spin = skew(link.omega);
  sum.rate = 2 * (spin * own.moment);
  sum.coriolis = -2 * (spin * second_moment(own.inertia));
  for (const int c : derivation_.mechanism().children(k)) {
    const Carried& joint = at_joint(c);
    const ex& d = derivation_.joint_offsets[static_cast<std::size_t>(c)];
    const ex& moved = joint_rate(c);
    const ex rate =
        define("hd", c, joint.rate + joint.mass * moved, "twice the rate of the first moment it adds [kg m/s]");
    sum.rate += rate;
    sum.coriolis += joint.coriolis - skew(d) * skew(rate) - skew(joint.moment) * skew(moved);
    sum.pull += joint.pull;
    sum.arms += joint.arms + skew(joint.pull) * skew(d);
  }
  sum.rate = define("hdot", k, sum.rate, "twice the rate of the first moment carried, body axes [kg m/s]");
  sum.coriolis =
      define("KC", k, sum.coriolis, "moment of the Coriolis forces of an angular velocity, body axes [kg m^2/s]");
  sum.pull = define("pull", k, sum.pull, "what bodies beyond ball joints pull, body axes [N]");
  sum.arms = define("arms", k, sum.arms, "its moment as the body turns, body axes [N m]");
  links_[static_cast<std::size_t>(k)] = sum;
}

const ex& CarriedMotion::joint_rate(int k) {
  const auto [at, is_new] = joint_rates_.try_emplace(k);
  if (is_new) {
    const ex& d = derivation_.joint_offsets[static_cast<std::size_t>(k)];
    const ex& omega = derivation_.letters(derivation_.lower(k)).omega;
    at->second = derivation_.define("dd", "\\dot d", k, Pass::outward,
                                    factored(2 * (skew(omega) * d) + 2 * derivation_.letters(k).sdot),
                                    "twice the rate of the joint's place, lower body's axes [m/s]");
  }
  return at->second;
}

const Carried& CarriedMotion::at_joint(int k) {
  const auto known = joints_.find(k);
  if (known != joints_.end()) return known->second;
  return joints_.emplace(k, derivation_.letters(k).turns_with_lower ? turned(k) : beyond_ball(k)).first->second;
}

Carried CarriedMotion::turned(int k) {
  const Carried& link = of_link(k);
  const ex& E_T = derivation_.letters(k).to_lower;
  const int below = derivation_.lower(k);
  const auto square = [&](const char* name, const ex& value, const char* meaning) {
    return value.is_zero() ? ex(0) : derivation_.define(name, name, k, Pass::inward, similarity(E_T, value), meaning);
  };
  Carried joint;
  joint.mass = link.mass;
  joint.moment = composites_.lower_moment(k);
  joint.inertia = composites_.lower_inertia(k);
  joint.rate = define("hdotc", k, E_T * link.rate, "the same in the lower body's axes");
  joint.coriolis = square("KCc", link.coriolis, "the same in the lower body's axes");
  joint.pull = define("pullc", k, E_T * link.pull, "the same in the lower body's axes");
  joint.arms = square("armsc", link.arms, "the same in the lower body's axes");
  joint.force = sums_.force_in_lower_axes(k);
  joint.torque = E_T * link.torque;
  joint.origin = derivation_.define("Pddotc", "\\ddot P'", k, Pass::outward,
                                    chain_.with_spin(sum(expanded(chain_.joint_point(k))), below),
                                    "acceleration of the body origin, less gravity, lower body's axes [m/s^2]");
  return joint;
}

Carried CarriedMotion::beyond_ball(int k) {
  const Carried& link = of_link(k);
  const int below = derivation_.lower(k);
  Carried joint;
  joint.mass = link.mass;
  joint.force = sums_.force_in_lower_axes(k);
  joint.pull = define("pullc", k, derivation_.in_axes(link.force - link.mass * link.origin, derivation_.home(k), below),
                      "force on the joint beyond that of its mass there, lower body's axes [N]");
  joint.origin = derivation_.in_axes(link.origin, derivation_.home(k), below);
  return joint;
}

}  // namespace kanec::symbolic
