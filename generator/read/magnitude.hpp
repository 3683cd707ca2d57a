// The magnitudes of loads: numbers, parameters, inputs, expressions. Not: the numbers of bodies (symbols.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "generator/read/node.hpp"
#include "generator/read/parse_expression.hpp"
#include "generator/read/symbols.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// Reads magnitudes for a scene whose bodies are read, to whose expressions it appends.
class Magnitudes {
 public:
  Magnitudes(Scene& scene, Symbols& symbols);

  // An expression of numbers alone becomes a constant. Both throw SceneError.
  Number number(const Node& node);
  Vector vector(const Node& node);
  // A number that should not be negative; a note where it is one and is.
  Number not_negative(const Node& node, const std::string& note);

 private:
  Scene& scene_;
  Symbols& symbols_;
  std::vector<ExpressionName> names_;
};

}  // namespace kanec::scene
