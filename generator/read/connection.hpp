// The connection array L(K): which arrays are trees (or forests). Not: from_connection's numbers (symbolic_tree.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <vector>

#include "generator/scene/place.hpp"

namespace kanec::scene {

inline constexpr int most_bodies = 512;  // beyond, tables of all pairs of bodies take gigabytes

// Refuses all but 1..most_bodies numbers with 0 <= L(K) < K. `place_of(k)` is where L(k) stands, from 1; `place_of(0)`
// the array. Throws SceneError.
void check_connection(const std::vector<int>& lower, const std::function<Place(std::size_t k)>& place_of);

}  // namespace kanec::scene
