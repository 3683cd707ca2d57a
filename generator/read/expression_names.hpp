// The names that a scene's expressions may hold. Not: how expressions are read (parse_expression.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <map>
#include <string>
#include <vector>

#include "generator/read/parse_expression.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// Of loads: t, parameters, inputs, coordinates and speeds, each by the number and by the name of its body. Coordinates
// that are locked or prescribed are known and refused, and so is a name that two bodies make alike.
std::vector<ExpressionName> names_for_loads(const Scene& scene);

// Of prescribed motions: t and parameters. Inputs are known and refused: a speed and an acceleration follow from the
// expression, and nobody knows the rate of an input. So are coordinates and speeds, once the joints are read.
std::vector<ExpressionName> names_for_motions(const Scene& scene);

// Of numbers that are constant: none but pi.
std::vector<ExpressionName> names_for_constants(const Scene& scene);

// What expressions read as something else than a parameter or input, and what that is: t, pi, functions, coordinates
// and speeds, and the word free of motions.
std::map<std::string, std::string> taken_names(const Scene& scene);

}  // namespace kanec::scene
