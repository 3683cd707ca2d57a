// The ways to compute a scene's functions, of which for each function the cheapest is kept among those that lose no
// digits. Not: the ways, nor how they are compared (comparison.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "generator/choice/requests.hpp"
#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"
#include "generator/symbolic/way.hpp"

namespace kanec {

// "composite" or "articulated".
std::string name(symbolic::Algorithm algorithm);

// The way in which a function is computed, and what speaks for it: program::Function::choice.
struct Chosen {
  symbolic::Way way;
  std::string choice = {};
};

// Of each of these functions. `all`: what every way leaves out at most.
std::vector<Chosen> choose_ways(const scene::Scene& scene, const std::vector<std::string>& names,
                                std::optional<symbolic::Algorithm> algorithm = {},
                                const symbolic::Reductions& all = {});

// The functions of these names, optimised, each in the way of least weighted cost among those whose expected rounding
// error is at most half again the least, or four ulps; accelerations by `algorithm` where it is given.
// program::Function::choice says by which, and what the best of the other algorithm costs. `all`: what all ways leave
// out at most. A system with many coupled links is not tried in ways that are known to lose there.
program::Program cheapest_program(const scene::Scene& scene, const std::vector<std::string>& names,
                                  std::optional<symbolic::Algorithm> algorithm = {},
                                  const symbolic::Reductions& all = {});

}  // namespace kanec
