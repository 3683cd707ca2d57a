// Random states of a scene, the same for the same seed everywhere. Not: what they are used for.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/model/state_file.hpp"

namespace kanec {

// The first is the scene's initial state but for a random ydot. In the others Euler parameters are any of unit norm,
// angles any (where three axes turn one after another, the second angle keeps them from lying in one plane), all other
// coordinates, speeds and rates between -1 and 1 of their unit, and the time, where the scene depends on it, between 0
// and 1 s. Parameters and inputs of every second one are the scene's defaults, those of the rest near them: parameters
// within 1 %, or 0.001 where they are zero (and the defaults again where a mass or an inertia could not be so), inputs
// within 1 + |default|.
std::vector<State> samples(const scene::Scene& scene, int count, std::uint64_t seed);

}  // namespace kanec
