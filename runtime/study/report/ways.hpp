// The ways of computing a function that a report sets side by side, by name. Not: which of them the generator keeps
// (generator/choice/candidates.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"
#include "generator/symbolic/way.hpp"

namespace kanec {

struct NamedWay {
  std::string name;  // "kept", "masses not regrouped"
  symbolic::Way way;
  bool passes = true;
};

// The kept way first, then those that differ from it in one thing, as far as the scene and the function have them.
std::vector<NamedWay> ways_beside(const scene::Scene& scene, const std::string& function, const symbolic::Way& kept);

// "joint by joint, own axes, masses of 3 together"
std::string description(const symbolic::Way& way, const std::string& function);

// The function alone, as it would be emitted, or without passes.
program::Program program_in(const scene::Scene& scene, const std::string& function, const NamedWay& way);

}  // namespace kanec
