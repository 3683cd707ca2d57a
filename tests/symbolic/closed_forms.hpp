// The closed forms of positions and partial velocities for any tree, typed in from the text, and the scenes on which
// the derived ones are compared with them. Not: derived from anything.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/symbolic/equations.hpp"

namespace kanec::symbolic {

// Row K-1 of each: mass centre, its partial velocities, and their time derivatives; blocks that are 0 left out.
struct ClosedForms {
  std::vector<GiNaC::ex> centre;
  std::vector<Blocks> v_y, v_y_dot;
};
ClosedForms closed_forms(const Equations& equations);

// Names of positions, velocities and of q + s replaced by what they stand for, down to letters.
GiNaC::ex written_out(const Equations& equations, const GiNaC::ex& e);

// Equal once written out and expanded, with ã b = -b̃ a.
bool are_equal(const Equations& equations, const GiNaC::ex& a, const GiNaC::ex& b);

// What the text gives as rates of letters: d(R_K^T)/dt = R_K^T ω̃_K and so on.
GiNaC::ex rate_of_letter(const Equations& equations, const Atom& atom);

// The source's tree, chains, stars, forests and random trees of 1 to 12 bodies; some with r or q zero.
std::vector<scene::Scene> sample_scenes();

}  // namespace kanec::symbolic
