// Random expressions whose text and nodes say the same, smooth and finite in every state. Not: a parser.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "generator/scene/scene.hpp"
#include "tests/support/random.hpp"

namespace kanec::test {

// Of time, coordinates, speeds, parameters and inputs; of about `size` for numbers near one.
scene::Expression random_expression(Random& random, const scene::Scene& scene, double size);

// Of time and parameters: value + amplitude times something within ±1 that moves within seconds.
scene::Expression random_course(Random& random, const scene::Scene& scene, double value, double amplitude);

}  // namespace kanec::test
