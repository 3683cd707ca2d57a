// The settings of a run in a table: [simulate] of a scene, and tables with the same keys. Not: what they do.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/read/node.hpp"
#include "generator/scene/scene.hpp"

namespace kanec::scene {

// `usual` with what the table has instead, checked; `origin` says in messages where the rest is from ("default"). Keys
// beyond the settings are the caller's. Throws SceneError.
Simulation read_simulation(const Table& table, const Simulation& usual, const std::string& origin,
                           const std::vector<std::string>& more_keys = {});

}  // namespace kanec::scene
