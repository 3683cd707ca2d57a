// What a scene's [simulate] says, as the integrators take it. Not: the command line (simulate.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/scene/scene.hpp"
#include "runtime/integrate/options.hpp"

namespace kanec {

// Of checked settings (scene::check_simulation), with the scene's events.
integrate::Options integration_options(const scene::Scene& scene, const scene::Simulation& run);

}  // namespace kanec
