// What the emitted files say about the model besides its arithmetic. Not: the program.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/scene/scene.hpp"

namespace kanec::emit {

// How functions are written: as a straight line, or as loops over bodies.
enum class Form { straight, rolled };

struct Model {
  const scene::Scene* scene = nullptr;
  std::string version;  // of the generator: "0.1.0"
  std::string hash;     // of the emitted text
  std::string options;  // as text: "all functions"
  std::string source = {};  // where the scene was read: a path, or empty
  Form form = Form::straight;
};

}  // namespace kanec::emit
