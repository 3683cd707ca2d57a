// The scene of a command line: a file, a folder that holds one, or a bare connection array. Not: how scenes are read.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::cli {

struct SceneArgument {
  std::string path;
  std::string connection;
};

void add_scene(CLI::App& command, SceneArgument& argument,
               const std::string& help = "a scene.toml, or a folder that holds one");

// Reads it; its notes and warnings go to standard error. Throws InputError unless exactly one is given, SceneError,
// FileError.
scene::Scene load(const SceneArgument& argument);

// All scenes of these words, or the one of the connection array.
std::vector<scene::Scene> load_all(const std::vector<std::string>& words, const std::string& connection);

// "6 bodies", "1 body"
std::string counted(std::size_t count, const std::string& one, const std::string& many);

}  // namespace kanec::cli
