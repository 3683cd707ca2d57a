// Forces and moments of all that a joint carries, summed from the leaves inward, and Kane's equations of its
// coordinates: the transposed partial velocities applied without forming them. Not: what the balances of the links are.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

// By link; [0] is not used.
struct Balance {
  std::vector<GiNaC::ex> force;   // home axes [N]
  std::vector<GiNaC::ex> moment;  // about the link's reference point, link axes [N m]
};

class InwardSums {
 public:
  // `name`: of the rows, "r" or "f". Links for which `starts_anew` pass nothing on.
  InwardSums(Derivation& derivation, const Balance& balance, std::string name, std::vector<bool> starts_anew = {});

  // Sum over the link and all above it: force in home axes; moment about the link's origin, link axes.
  const GiNaC::ex& force(int link) const { return force_[static_cast<std::size_t>(link)]; }
  const GiNaC::ex& moment(int link) const { return moment_[static_cast<std::size_t>(link)]; }
  // Kane's equation of a coordinate without its effort.
  GiNaC::ex row(int link, const Coordinate& coordinate) const;
  // The sum of forces on a link in the axes of its lower link.
  GiNaC::ex force_in_lower_axes(int link) const;

 private:
  void add(int link, const Balance& balance);
  bool passes_on(int link) const;

  Derivation& derivation_;
  std::string name_;
  std::vector<bool> starts_anew_;
  std::vector<GiNaC::ex> force_, moment_;
};

}  // namespace kanec::symbolic
