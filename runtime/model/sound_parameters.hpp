// A quick look at parameters that are to be judged many times. Not: the judgement (settings.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>

#include "generator/scene/scene.hpp"

namespace kanec {

// True: check_defaults() would find nothing, as every body that has parameters among its mass and inertia gets a
// positive mass and moments clearly above zero with these values. False says nothing.
bool surely_sound(const scene::Scene& scene, std::span<const double> parameters);

}  // namespace kanec
