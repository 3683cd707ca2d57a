// A fixed order of the operands of sums and scalar products. GiNaC's own follows hashes and may change from run to run.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/symbolic/algebra.hpp"

namespace kanec::symbolic {

// The operands of a sum or a commutative product, by the table indices of their letters from left to right, numbers
// first; in a product the scalars before the block.
std::vector<GiNaC::ex> ordered(const GiNaC::ex& e);

// True where a comes before b in that order.
bool precedes(const GiNaC::ex& a, const GiNaC::ex& b);

}  // namespace kanec::symbolic
