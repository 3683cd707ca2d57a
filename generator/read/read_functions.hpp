// The functions that a scene asks for, by name. Not: which of them a model can have (pipeline.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/read/node.hpp"

namespace kanec::scene {

// `functions` of the scene: names, or names joined by +; none where there is no such key. Throws SceneError.
struct AskedFunctions {
  std::vector<std::string> names;
  std::vector<Place> places;
};
AskedFunctions read_functions(const Table& root);

}  // namespace kanec::scene
