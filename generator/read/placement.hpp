// Directions and orientations as a scene file writes them. Not: which joint they place.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/read/node.hpp"
#include "generator/scene/rotation.hpp"

namespace kanec::scene {

// "x", "-y", …, or three numbers that are not all zero; of unit length. Throws SceneError.
Direction read_direction(const Node& node);

// { eps = [4] }, { rpy = [3] } or { x = [3], z = [3] }: takes components in the joint frame to components in the body's
// axes. rpy are roll, pitch and yaw, Rot(z, yaw) Rot(y, pitch) Rot(x, roll); z is kept as it is, x made orthogonal to
// it. Throws SceneError.
Turn read_orientation(const Node& node);

// Rounds to double; what is within 1e-15 of 0 or ±1 becomes that. `snapped` becomes true where this hides more than the
// rounding of an extended precision.
double snap(long double value, bool& snapped);

}  // namespace kanec::scene
