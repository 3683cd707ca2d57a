// The stages in order: scene -> equations -> program -> passes -> emitted files. Not: any of the stages.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"
#include "generator/scene/scene.hpp"

namespace kanec {

struct GenerateOptions {
  std::vector<std::string> functions;  // all that the scene has when empty
};

struct Generated {
  program::Program program;
  std::string name;    // of the model
  std::string hash;    // of the emitted text: scene, generator and options
  std::string header;  // <name>.hpp
  std::string abi;     // <name>_abi.cpp
};

// A function that a scene's solver can have.
struct Available {
  std::string name;
  std::string meaning;
  int n_out = 0;
  program::Signature signature;
};

// All of them, in order.
std::vector<Available> available_functions(const scene::Scene& scene);

// Throws InputError for a function that the scene does not have.
Generated generate(const scene::Scene& scene, const GenerateOptions& options = {});

std::string version();

}  // namespace kanec
