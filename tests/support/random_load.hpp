// Random loads at points, along coordinates and between points, and random named points. Not: the force and moment that
// stand with a body.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "tests/support/random_numbers.hpp"

namespace kanec::test {

// Appends what the options ask for to a scene whose bodies are complete.
void add_loads(Random& random, RandomNumbers& make, scene::Scene& scene, const RandomSceneOptions& options);
void add_points(Random& random, RandomNumbers& make, scene::Scene& scene, int n);

}  // namespace kanec::test
