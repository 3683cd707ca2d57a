// Random joints of every kind, and random positions that keep away from gimbal lock. Not: the bodies that they carry.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "tests/support/random_scene.hpp"

namespace kanec::test {

// Random axes, orientation and motions; prescribed courses are appended to the scene's expressions.
scene::Joint random_joint(Random& random, scene::Scene& scene, const std::string& kind,
                          const RandomSceneOptions& options);

// New values and rates of the coordinates that are free; those of a ball stand in the body.
void randomise_coordinates(Random& random, scene::Joint& joint);

std::array<double, 4> random_eps(Random& random);

}  // namespace kanec::test
