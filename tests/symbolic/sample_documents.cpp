// SPDX-License-Identifier: BSD-3-Clause
#include "tests/symbolic/sample_documents.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "tests/support/random_scene.hpp"

namespace kanec::test {
namespace {

constexpr std::array roughness = {"",   "_", "__", "_1", "_2_3",  "_kg_m2", "7",  "x__y_", "'s", "#1", "$x$",
                                  "%c", "&", "{",  "}",  "\\par", "~",      "^2", "<a>",   "`",  "|",  "-"};

}  // namespace

std::vector<std::filesystem::path> shipped_scenes() {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(KANEC_SOURCE_DIR "/models"))
    if (entry.path().filename() == "scene.toml") files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

scene::Scene scene_with_rough_names(int seed) {
  Random random(static_cast<std::uint64_t>(seed));
  scene::Scene scene = random_scene(random, 1 + seed % 9, everything());
  scene.name = "rough_" + std::to_string(seed);
  const auto roughen = [&](std::string& name) {
    name += roughness[static_cast<std::size_t>(random.below(static_cast<int>(roughness.size())))];
  };
  roughen(scene.name);
  for (scene::Body& body : scene.bodies) roughen(body.name);
  for (scene::Load& load : scene.loads) roughen(load.name);
  for (scene::Point& point : scene.points) roughen(point.name);
  for (scene::Named& parameter : scene.parameters) roughen(parameter.name);
  for (scene::Named& input : scene.inputs) roughen(input.name);
  return scene;
}

}  // namespace kanec::test
