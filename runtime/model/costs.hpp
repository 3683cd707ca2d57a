// The operations of every function of many scenes, side by side. Not: how operations are counted (generator/program).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "generator/program/ledger.hpp"
#include "generator/scene/scene.hpp"
#include "runtime/text/json.hpp"

namespace kanec {

struct FunctionCost {
  std::string name;
  int results = 0;
  program::Ledger ledger;
  int instructions = 0, critical_path = 0;
};

struct SceneCost {
  std::string name;
  int bodies = 0, nx = 0, ny = 0;
  std::vector<FunctionCost> functions;
  program::Ledger prepare;  // once for all evaluations with the same parameters
};

// Of the functions that the scene asks for, or the usual ones; or of all that it can have.
SceneCost cost_of(const scene::Scene& scene, bool all_functions,
                  const std::function<void(const std::string& note)>& tell = {});

std::string costs_text(const std::vector<SceneCost>& costs);
Json costs_json(const std::vector<SceneCost>& costs);
// `command`: the one that writes this page.
std::string costs_markdown(const std::vector<SceneCost>& costs, const std::string& command);

}  // namespace kanec
