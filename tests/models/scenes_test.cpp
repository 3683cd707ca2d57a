// The shipped scenes: read as they are, every function they ask for. Oracle: the generic numeric path.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "generator/choice/requests.hpp"
#include "tests/models/model.hpp"

namespace kanec::test {
namespace {

class Shipped : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Scenes, Shipped, testing::ValuesIn(shipped_models()),
                         [](const auto& name) { return name.param; });

TEST_P(Shipped, reads_without_notes_and_warnings_and_has_a_readme) {
  const scene::Scene scene = shipped_scene(GetParam());
  EXPECT_EQ(scene.name, GetParam());
  EXPECT_THAT(scene.notes, testing::IsEmpty());
  EXPECT_THAT(scene.warnings, testing::IsEmpty());
  EXPECT_TRUE(std::filesystem::exists(KANEC_SOURCE_DIR "/models/" + GetParam() + "/README.md"));
}

// The usual functions and those that the scene asks for, combinations apart.
std::vector<std::string> functions_of(const scene::Scene& scene) {
  std::vector<std::string> names;
  for (const Available& available : available_functions(scene))
    if (available.usual) names.push_back(available.name);
  for (const std::string& name : scene.functions)
    if (name.find('+') == std::string::npos && std::find(names.begin(), names.end(), name) == names.end())
      names.push_back(name);
  return names;
}

Sample at_start(const scene::Scene& scene) {
  const std::vector<double> y = initial_speeds(scene);
  return {scene,
          {initial_coordinates(scene), y, std::vector<double>(y.size(), 1.0)},
          default_parameters(scene),
          default_inputs(scene)};
}

// Measured: 1e-13, whatever the size of the scene, as accelerations joint by joint do not feel the condition of A (5e7
// for a chain of 64); 5e-12 for the crank, whose motion is an expression that cancels.
TEST_P(Shipped, functions_agree_with_the_generic_path) {
  const scene::Scene scene = shipped_scene(GetParam());
  const Model model(scene, functions_of(scene));
  constexpr double tolerance = 1e-11;
  Random random(31);
  for (const Sample& s : {at_start(scene), sample_of(scene, random), sample_of(scene, random)}) {
    const program::Arguments<double> at = arguments<double>(s);
    for (const program::Function& function : model.program().functions)
      EXPECT_LT(relative_difference(model(function.name, at), generic_result(s, function.name, widened(at))), tolerance)
          << function.name;
  }
}

// "kinematics+accelerations" of the satellite, whose parts the program holds as well.
TEST(Combination, has_the_results_of_its_parts_one_after_another) {
  const Model model(shipped_scene("satellite"));
  Random random(32);
  const program::Arguments<double> at = arguments<double>(sample_of(model.scene(), random));
  std::vector<double> parts = model("kinematics", at);
  const std::vector<double> rest = model("accelerations", at);
  parts.insert(parts.end(), rest.begin(), rest.end());
  EXPECT_EQ(model("kinematics_and_accelerations", at), parts);
  EXPECT_LE(model.operations("kinematics_and_accelerations"),
            model.operations("kinematics") + model.operations("accelerations"));
}

}  // namespace
}  // namespace kanec::test
