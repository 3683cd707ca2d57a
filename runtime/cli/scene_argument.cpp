// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/scene_argument.hpp"

#include <filesystem>

#include "generator/scene/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/cli/output.hpp"

namespace kanec::cli {
namespace {

namespace fs = std::filesystem;

fs::path file_of(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored) ? path / "scene.toml" : path;
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

void add_scene(CLI::App& command, SceneArgument& argument) {
  command.add_option("SCENE", argument.path, "a scene.toml, or a folder that holds one")->option_text(" ");
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

std::string counted(std::size_t count, const std::string& one, const std::string& many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace kanec::cli
