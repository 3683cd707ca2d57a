// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/scene_argument.hpp"

#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/model/scene_files.hpp"
#include "runtime/terminal/output.hpp"

namespace kanec::cli {
namespace {

scene::Scene read(const SceneArgument& argument) {
  if (!argument.path.empty() && !argument.connection.empty())
    throw InputError("a scene file and --connection are both given: '" + argument.path + "', '" + argument.connection +
                     "'; allowed: one of them");
  if (!argument.connection.empty()) return scene::from_connection(scene::parse_connection(argument.connection));
  if (!argument.path.empty()) return scene::read(scene_file(argument.path));
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
