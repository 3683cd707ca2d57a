// Which functions a scene's solver can have. Not: how they are derived (stages.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "generator/symbolic/equations.hpp"

namespace kanec::symbolic {

// In order, without outputs.
std::vector<Function> functions(const scene::Scene& scene);

// Is there anything applied, whose `power` is a function?
bool has_loads(const scene::Scene& scene);

// What derivatives are put together from; never emitted themselves.
std::vector<Function> derivative_parts(const scene::Scene& scene);

}  // namespace kanec::symbolic
