// The [[event]] tables of a scene. Not: their expressions' rules (parse_expression.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "generator/read/magnitude.hpp"
#include "generator/read/node.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

inline constexpr int most_events = 1000;

// Appends to the scene, whose bodies and inputs are read. Throws SceneError.
void read_events(const Table& root, Magnitudes& magnitudes, Symbols& symbols, Scene& scene);

}  // namespace kanec::scene
