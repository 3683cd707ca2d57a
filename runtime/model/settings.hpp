// Parameters and inputs other than the scene's defaults: `--set name=value`. Not: how a model takes them.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec {

// The scene with these defaults in place of its own; masses and inertias are judged anew. What is generated from a
// scene holds its defaults: generate from the scene as it was. Throws InputError, SceneError.
scene::Scene with_settings(scene::Scene scene, const std::vector<std::string>& settings);

// Throws SceneError, naming `origin`, where a mass or an inertia cannot be with the scene's present defaults.
void check_defaults(const scene::Scene& scene, const std::string& origin);

}  // namespace kanec
