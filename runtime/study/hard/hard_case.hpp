// A hard case: a scene, its known answer, how it is run and what a run keeps to what; models/hard/<case>/hard.toml
// beside scene.toml. Not: the runs (outcome.hpp).
//
//   case = "torque-free body near its intermediate axis"
//   source = "Landau and Lifshitz, Mechanics, section 37"
//   answer = "torque_free"           # answer.hpp; without the key, none
//   [[run]]                          # what is not given is as in the scene's [simulate]
//   integrator = "gauss6"
//   step = 1e-3
//   duration = 2752.0
//   keeps = { energy = 1e-12, angular_momentum = 1e-12, norm = 1e-13, attitude = 1e-6 }
//   [run.short]                      # for tests: what is not given is as above
//   duration = 27.5
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::hard {

// The most that something may be off: energy, energy_drift (its linear part), angular_momentum, relative;
// linear_momentum beside √(2 m T); norm, | |ε| − 1 |; or a deviation from the answer by its name.
struct Bound {
  std::string what;
  double most = 0.0;
};

struct Length {
  scene::Simulation settings;
  std::vector<Bound> keeps;
};

struct Run {
  Length full, brief;
};

struct HardCase {
  std::string name;  // of its folder
  std::string title, source, answer;
  scene::Scene scene;
  std::vector<Run> runs;
  std::string file;     // hard.toml, as it was opened
  int answer_line = 0;  // there
};

// Throws SceneError, FileError.
HardCase read_hard_case(const std::filesystem::path& folder);

// Folders under `folder` that hold a hard.toml, by name.
std::vector<std::filesystem::path> hard_cases(const std::filesystem::path& folder);

}  // namespace kanec::hard
