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

// A path as it is typed into a shell where a scene may stand: no option, one word.
std::string typed(const std::string& path);

// The scene files that a word means: a scene.toml, or that of a folder, or those of a folder of such folders, by name.
// Throws InputError for a folder that holds neither.
std::vector<std::string> scene_files(const std::string& word);

// All scenes of these words, or the one of the connection array.
std::vector<scene::Scene> load_all(const std::vector<std::string>& words, const std::string& connection);

// "6 bodies", "1 body"
std::string counted(std::size_t count, const std::string& one, const std::string& many);

}  // namespace kanec::cli
