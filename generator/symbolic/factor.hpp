// Algebra that lowers the cost of a block expression and keeps its value. Not here: sums over bodies (inward_sums.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/symbolic/algebra.hpp"
#include "generator/symbolic/symbols.hpp"

namespace kanec::symbolic {

// Takes common factors out of a sum, at the left or the right end of its products, those of most terms first:
// R ω̃ ω̃ d + R ω̇~ d + R s̈  ->  R ((ω̃ ω̃ + ω̇~) d + s̈).
GiNaC::ex factored(const GiNaC::ex& e);

}  // namespace kanec::symbolic
