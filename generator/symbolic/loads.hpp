// What acts on the links: applied forces and moments, springs, joint loads, and their power. Not: gravity.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/symbolic/derivation.hpp"

namespace kanec::symbolic {

// Sums over the loads.
struct AppliedLoads {
  std::vector<GiNaC::ex> force;                // on each link, home axes [N]
  std::vector<GiNaC::ex> moment;               // about its reference point, link axes [N m]
  std::vector<std::vector<GiNaC::ex>> effort;  // along each coordinate of each link [N], [N m]
  std::vector<GiNaC::ex>
      through_joint;  // part of `force`: of each link's own joint along a translation by three, home axes [N]
};

// The letter of a number of a load: tau, k, c, l (its rest), F or M, and r, where it acts.
struct LoadLetter {
  std::string name, latex;  // "tau_motor_", "\tau_{\text{motor}}"
};
LoadLetter load_letter(const std::string& letter, const std::string& load);

AppliedLoads applied_loads(Derivation& derivation);

// Power of each load, in the order of load_powers [W]; `conservative`: with what springs of constant stiffness give
// back.
std::vector<GiNaC::ex> load_powers(Derivation& derivation, bool conservative);

// Energy stored in springs whose stiffness and rest are constants or parameters [J].
GiNaC::ex spring_energy(Derivation& derivation);

}  // namespace kanec::symbolic
