// What was taken out of a scene before its equations were written, and what that saves: each is exact. Not: how.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec {

struct Reduction {
  std::string name;           // "welded bodies"
  std::string what;           // "plate is part of hub"
  long operations_saved = 0;  // of one evaluation of all functions asked for
};

// Those that the scene has anything of. Operations are counted against the same scene with that one reduction undone.
// Names as for generate(). Throws InputError for a function that the scene does not have.
std::vector<Reduction> reductions(const scene::Scene& scene, const std::vector<std::string>& functions);

}  // namespace kanec
