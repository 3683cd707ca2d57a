// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/scene_argument.hpp"

#include <algorithm>
#include <filesystem>

#include "generator/scene/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/cli/output.hpp"

namespace kanec::cli {
namespace {

namespace fs = std::filesystem;

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

fs::path file_of(const fs::path& path) { return is_folder(path) ? path / "scene.toml" : path; }

bool is_scene(const fs::path& path) {
  std::error_code ignored;
  return !is_folder(path) || fs::exists(path / "scene.toml", ignored);
}

scene::Scene read(const SceneArgument& argument) {
  if (!argument.path.empty() && !argument.connection.empty())
    throw InputError("a scene file and --connection are both given: '" + argument.path + "', '" + argument.connection +
                     "'; allowed: one of them");
  if (!argument.connection.empty()) return scene::from_connection(scene::parse_connection(argument.connection));
  if (!argument.path.empty()) return scene::read(file_of(argument.path));
  throw InputError("no scene is given; allowed: a scene.toml, a folder that holds one, or --connection 0,1,2,2,1,5");
}

}  // namespace

void add_scene(CLI::App& command, SceneArgument& argument, const std::string& help) {
  command.add_option("SCENE", argument.path, help)->option_text(" ");
  command
      .add_option("--connection", argument.connection,
                  "instead of a scene: the all-symbolic system of this lower-numbered body array")
      ->option_text("L(1),L(2),...");
}

scene::Scene load(const SceneArgument& argument) {
  scene::Scene scene = read(argument);
  for (const std::string& note : scene.notes) remark("note: " + note);
  for (const std::string& warning : scene.warnings) remark("warning: " + warning);
  return scene;
}

std::string typed(const std::string& path) { return fit::shell(path.starts_with('-') ? "./" + path : path); }

std::vector<std::string> scene_files(const std::string& word) {
  if (is_scene(word)) return {file_of(word).string()};
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(word))
    if (is_folder(entry.path()) && is_scene(entry.path())) files.push_back(file_of(entry.path()).string());
  std::sort(files.begin(), files.end());
  if (files.empty())
    throw InputError("SCENE: found '" + word +
                     "', in which no folder holds a scene.toml; allowed: scenes, or a folder of them");
  return files;
}

std::vector<scene::Scene> load_all(const std::vector<std::string>& words, const std::string& connection) {
  std::vector<scene::Scene> list;
  for (const std::string& word : words)
    for (const std::string& file : scene_files(word)) list.push_back(load(SceneArgument{file, connection}));
  if (list.empty()) list.push_back(load(SceneArgument{"", connection}));
  return list;
}

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace kanec::cli
