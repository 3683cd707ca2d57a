// What a run of a scene keeps, read off the scene: its energy balance, its momenta. Not: how well a run kept it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/scene/scene.hpp"

namespace kanec {

// Prescribed coordinates that move: their drives do work, which no function of the model adds up.
bool has_drives(const scene::Scene& scene);

// Euler parameters in the state, which should keep their norm.
bool has_attitudes(const scene::Scene& scene);

// Nothing outside acts on the bodies: no gravity, no load on any of them that is not answered on another one, and every
// tree of bodies free to move as a whole.
bool is_isolated(const scene::Scene& scene);

}  // namespace kanec
