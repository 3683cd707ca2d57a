// One [[body]] table to a checked Body. Not: the scene around it.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/scene/node.hpp"
#include "generator/scene/scene.hpp"
#include "generator/scene/symbols.hpp"

namespace kanec::scene {

// Body `k` (from 1) of a scene. Appends to the scene's notes and warnings. Throws SceneError.
Body read_body(const Node& node, int k, Symbols& symbols, Scene& scene);

}  // namespace kanec::scene
