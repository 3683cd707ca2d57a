// Random scenes with all that scenes hold, under names that emitted code might use itself. Not: what is done with them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <string>

#include "generator/scene/scene.hpp"
#include "tests/support/random.hpp"

namespace kanec::test {

// The number-th of a seed. Even numbers take all 12³ triples of joints in turn, in a chain or two on one; odd ones are
// trees of up to a dozen bodies.
scene::Scene random_model(std::uint64_t seed, int number);

bool is_triple(int number);

// Accelerations and up to `most` others of the scene's functions by name, some joined by +.
std::vector<std::string> random_functions(Random& random, const scene::Scene& scene, int most);

}  // namespace kanec::test
