// The numbers of one random scene: constants, or the parameters, inputs and expressions that the options ask for.
// Not: what they stand for.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "tests/support/random_scene.hpp"

namespace kanec::test {

class RandomNumbers {
 public:
  RandomNumbers(Random& random, scene::Scene& scene, const RandomSceneOptions& options)
      : random_(random), scene_(scene), options_(options) {}

  scene::Number number(const std::string& name, double value);
  scene::Vector vector(const std::string& name, double range);  // constants and parameters
  scene::Symmetric inertia(const std::string& name, double m);

  // Of a load, up to `range`.
  scene::Vector load(const std::string& name, double range);
  // The same, or an expression: only where the scene's coordinates are known.
  scene::Number magnitude(const std::string& name, double low, double high);
  void some_to_expressions(scene::Vector& vector, double range);

 private:
  std::string own_name(const std::string& name) const;
  scene::Number number_or_zero(const std::string& name, double range);
  scene::Number load_entry(const std::string& name, double low, double high);
  scene::Number expression(double size);

  Random& random_;
  scene::Scene& scene_;
  const RandomSceneOptions& options_;
};

}  // namespace kanec::test
