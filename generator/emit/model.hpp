// What the emitted files say about the model besides its arithmetic. Not: the program.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>

#include "generator/scene/scene.hpp"

namespace kanec::emit {

// What emitted code is made for: time; or memory for code and constants, as controllers have little of; or, to compare,
// straight lines or loops over bodies whatever they cost.
enum class Optimize { speed, size, line, loops };

// The longest function that is left whole and the length of a piece of others, in lines.
struct Lengths {
  std::size_t whole = 6000;
  std::size_t piece = 500;
};

// C++17, and the libraries and the command compile it; or C99 for programs of their own.
enum class Language { cpp, c };

struct Model {
  const scene::Scene* scene = nullptr;
  std::string version;      // of the generator: "0.1.0"
  std::string hash;         // of the emitted text
  std::string options;      // as text: "all functions"
  std::string source = {};  // where the scene was read: a path, or empty
  Optimize optimize = Optimize::speed;
  int longest_line = 8000;  // operations of a function that for speed is a straight line in any case
  Lengths lengths = {};
  Language language = Language::cpp;
};

}  // namespace kanec::emit
