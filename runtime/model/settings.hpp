// Parameters, inputs and initial coordinates and speeds other than the scene's: `--set name=value`. Not: how a model
// takes them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec {

// The scene with these values in place of its own: of parameters, inputs, and initial coordinates and speeds
// ("theta_2", "omega_hub_3"; an Euler parameter alone is refused, of which four make an attitude); masses and inertias
// are judged anew. What is generated from a scene holds its defaults: generate from the scene as it was. Throws
// InputError, SceneError.
scene::Scene with_settings(scene::Scene scene, const std::vector<std::string>& settings);

// Throws SceneError, naming `origin`, where a mass or an inertia cannot be with the scene's present defaults.
void check_defaults(const scene::Scene& scene, const std::string& origin);

}  // namespace kanec
