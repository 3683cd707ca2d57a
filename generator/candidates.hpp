// The ways to compute a scene's functions, counted, of which the cheapest is kept for each function. Not: the ways.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/requests.hpp"
#include "generator/scene/scene.hpp"
#include "generator/symbolic/way.hpp"

namespace kanec {

// "composite" or "articulated".
std::string name(symbolic::Algorithm algorithm);

// The functions of these names, optimised, each in the way of least weighted cost, accelerations by `algorithm` where it
// is given. program::Function::choice says by which, and what the best of the other algorithm costs. `base`: what all
// ways leave out at most. A system with many coupled links is not tried in ways that are known to lose there.
program::Program cheapest_program(const scene::Scene& scene, const std::vector<std::string>& names,
                                  std::optional<symbolic::Algorithm> algorithm = {},
                                  const symbolic::Reductions& base = {});

}  // namespace kanec
