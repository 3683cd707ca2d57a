// Coordinates that nothing resists, so that A is singular, as far as the tree and the start show it. Not: the rank of
// the whole of A, which depends on more than one joint.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "generator/scene/attitude.hpp"
#include "generator/scene/place.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// Refuses, with the name of the coordinate: free turns of one joint whose axes depend on each other at the start; a
// free translation that carries no mass; a free rotation that carries neither mass nor inertia; and the free
// coordinates of a body that alone has mass of all that they carry, where its own block of A is singular at the start.
// `place_of(k)` is where body k stands. Parameters count by their defaults. Throws SceneError.
void check_resistance(const Scene& scene, const std::vector<Attitude>& attitudes,
                      const std::function<Place(int k)>& place_of);

}  // namespace kanec::scene
