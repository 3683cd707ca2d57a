// The [ensemble] table of a scene: how many scenarios, and what is drawn for each. Not: the drawing (runtime/cli).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/read/node.hpp"
#include "generator/scene/entry_names.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

inline constexpr int most_scenarios = 10'000'000;

// All that a scenario may have a value of its own for: coordinates, speeds, parameters, inputs.
std::vector<std::string> scenario_names(const Scene& scene);

// The one of these that a name means, by the number or by the name of a body; empty where it means none.
std::string scenario_name(const EntryNames& entries, const std::string& given);

// Throws SceneError. An Ensemble of count 0 where there is no such table.
Ensemble read_ensemble(const Table& root, const Scene& scene);

}  // namespace kanec::scene
