// Whether a body's mass and inertia and a simulation's settings can be modelled. Not: how they are read.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "generator/read/symbols.hpp"
#include "generator/scene/place.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// Parameters are judged by their defaults. Zero is allowed here: what no coordinate accelerates may be massless
// (singular.hpp). Both throw SceneError.
void check_mass(const Number& mass, const Symbols& symbols, const Place& place);
void check_inertia(const Symmetric& inertia, const Symbols& symbols, const Place& place);

// Where the principal moments violate the triangle inequality, which no rigid body does and published models do. None
// for a body with a single moment that turns about one direction: planar models give no other.
std::optional<std::string> inertia_warning(const Symmetric& inertia, bool one_direction, const Symbols& symbols,
                                           const Place& place);

// Where the setting of a key of Simulation stands: in a file, or on a command line.
using PlaceOf = std::function<Place(const std::string& key)>;

// Their names, in order.
const std::vector<std::string>& simulation_integrators();
const std::vector<std::string>& simulation_jacobians();

// Refuses settings that no integrator can follow. Throws SceneError.
void check_simulation(const Simulation& simulation, const PlaceOf& place_of);

}  // namespace kanec::scene
