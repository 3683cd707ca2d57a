// What acts on the bodies: [[load]], and the loads that stand in [[body]]. Not: gravity.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "generator/read/body.hpp"
#include "generator/read/magnitude.hpp"

namespace kanec::scene {

// Force, moment and the load along the joint's only coordinate of body k, named like the body. Throws SceneError.
void read_body_loads(const BodyTable& from, int k, Magnitudes& magnitudes, Scene& scene);

// All of [[load]]; the K-th is load_K where it has no name. Throws SceneError.
void read_loads(const Table& root, Magnitudes& magnitudes, Symbols& symbols, Scene& scene);

}  // namespace kanec::scene
