// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/models/model.hpp"

#include <algorithm>
#include <filesystem>
#include <stdexcept>

#include "generator/read/read.hpp"

namespace kanec::test {

std::vector<std::string> shipped_models() {
  std::vector<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(KANEC_SOURCE_DIR "/models"))
    if (std::filesystem::exists(entry.path() / "scene.toml")) names.push_back(entry.path().filename().string());
  std::sort(names.begin(), names.end());
  return names;
}

scene::Scene shipped_scene(const std::string& name) {
  return scene::read(KANEC_SOURCE_DIR "/models/" + name + "/scene.toml");
}

Model::Model(const scene::Scene& scene, const std::vector<std::string>& functions)
    : scene_(scene), program_(program_of(scene, functions)) {}

program::Arguments<double> Model::start() const {
  const std::vector<double> y = initial_speeds(scene_);
  return {default_parameters(scene_), initial_coordinates(scene_), y, std::vector<double>(y.size(), 0.0),
          default_inputs(scene_)};
}

std::vector<double> Model::operator()(const std::string& name, const program::Arguments<double>& at) const {
  return evaluate(program_, function(name), at);
}

int Model::operations(const std::string& name) const { return program::ledger(program_, function(name)).operations(); }

const program::Function& Model::function(const std::string& name) const {
  for (const program::Function& function : program_.functions)
    if (function.name == name) return function;
  throw std::out_of_range(name);
}

}  // namespace kanec::test
