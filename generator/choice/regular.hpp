// Whether a scene's mass matrix can be inverted where the motion begins. Not: away from there.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/scene/scene.hpp"

namespace kanec {

// Throws InputError that names a coordinate which can change without moving any mass, or as others already do: a
// massless body on a hinge, aligned axes of a gimbal. Judged at the initial state with the defaults of the parameters,
// t = 0.
void check_regular(const scene::Scene& scene);

}  // namespace kanec
