// Points of bodies, by name or by body and place. Not: what acts there.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/read/node.hpp"
#include "generator/read/symbols.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// The number of the body of that name, or 0 for "ground", the inertial frame. Throws SceneError.
int read_body_name(const Node& node, const Scene& scene);

// All of [[point]]. Throws SceneError.
void read_points(const Table& root, Symbols& symbols, Scene& scene);

// The point of a load: `<prefix>point`, the name of one of [[point]]; or `<prefix>body` and `<prefix>r`, the body's
// origin where there is no r. Throws SceneError.
Point read_load_point(const Table& load, const std::string& prefix, Symbols& symbols, const Scene& scene);

}  // namespace kanec::scene
