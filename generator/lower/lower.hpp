// From the named quantities of the derivation to a straight-line program. Not: passes, text.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/symbolic/equations.hpp"

namespace kanec::lower {

// Lowers the functions of these names (all when the list is empty), unsimplified. Sums and products follow the fixed
// order of symbolic/order.hpp. Throws InputError for a name that the equations do not have.
program::Program lower(const symbolic::Equations& equations, const std::vector<std::string>& functions = {});

}  // namespace kanec::lower
