// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/inward_sums.hpp"

#include <utility>

#include "generator/symbolic/factor.hpp"

namespace kanec::symbolic {

using GiNaC::ex;

InwardSums::InwardSums(Derivation& derivation, const Balance& balance, std::string name, std::vector<bool> starts_anew)
    : derivation_(derivation),
      name_(std::move(name)),
      starts_anew_(std::move(starts_anew)),
      force_(static_cast<std::size_t>(derivation.size()) + 1),
      moment_(force_.size()) {
  for (int k = derivation.size(); k >= 1; --k) add(k, balance);
}

bool InwardSums::passes_on(int link) const {
  return starts_anew_.empty() || !starts_anew_[static_cast<std::size_t>(link)];
}

// S = G + Σ S_c and ρ = N + r̃ G (r: what N is about) + Σ (d̃_c S_c + E_cᵀ ρ_c), the last where c turns with the link.
void InwardSums::add(int k, const Balance& balance) {
  const auto at = static_cast<std::size_t>(k);
  const Letters& link = derivation_.letters(k);
  ex force = balance.force[at];
  ex moment = balance.moment[at] +
              skew(derivation_.inertia(k).reference) * derivation_.in_axes(balance.force[at], derivation_.home(k), k);
  for (const int c : derivation_.mechanism().children(k)) {
    if (!passes_on(c)) continue;
    const Letters& above = derivation_.letters(c);
    force += derivation_.in_axes(this->force(c), derivation_.home(c), derivation_.home(k));
    moment += skew(derivation_.joint_offsets[static_cast<std::size_t>(c)]) * force_in_lower_axes(c);
    if (above.turns_with_lower) moment += above.to_lower * this->moment(c);
  }
  const bool is_attitude =
      !link.coordinates.empty() && link.coordinates.front().freedom.kind == Freedom::Kind::attitude;
  force_[at] = derivation_.define("S", "S", k, Pass::inward, force,
                                  std::string("sum of the force balances of the subtree, ") +
                                      (derivation_.home(k) == 0 ? "inertial axes [N]" : "body axes [N]"));
  moment_[at] = is_attitude ? derivation_.define(name_ + "_omega", name_ + "_{\\omega_{#}}", k, Pass::inward, moment,
                                                 "Kane's equation of omega [N m]")
                            : derivation_.define(
                                  "rho", "\\rho", k, Pass::inward, moment,
                                  "sum of the moment balances of the subtree about the body origin, body axes [N m]");
}

ex InwardSums::force_in_lower_axes(int k) const {
  return derivation_.in_axes(force(k), derivation_.home(k), derivation_.lower(k));
}

ex InwardSums::row(int k, const Coordinate& c) const {
  switch (c.freedom.kind) {
    case Freedom::Kind::attitude:
      return moment(k);
    case Freedom::Kind::translation:
      return force_in_lower_axes(k);
    case Freedom::Kind::slide:
      return dot(c.axis, force_in_lower_axes(k));
    case Freedom::Kind::turn:
      break;
  }
  // the axis is the same in the axes of both bodies that it joins
  const ex& pitch = derivation_.letters(k).pitch;
  ex value = dot(c.axis, moment(k));
  if (!pitch.is_zero()) {
    value += pitch * dot(c.axis, derivation_.in_axes(force(k), derivation_.home(k), k));
  }
  return value;
}

}  // namespace kanec::symbolic
