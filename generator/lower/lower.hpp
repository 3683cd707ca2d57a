// From the named quantities of the derivation to a straight-line program. Not: passes, text.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/program/program.hpp"
#include "generator/symbolic/equations.hpp"

namespace kanec::lower {

// Lowers the functions of the equations, unsimplified. Sums and products follow the fixed order of symbolic/order.hpp.
program::Program lower(const symbolic::Equations& equations);

}  // namespace kanec::lower
