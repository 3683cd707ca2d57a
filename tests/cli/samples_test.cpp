// Oracle: what samples.hpp promises. SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/samples.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "generator/scene/read.hpp"
#include "runtime/cli/model.hpp"

namespace kanec::cli {
namespace {

TEST(Samples, are_the_same_for_the_same_seed) {
  const scene::Scene scene = scene::from_connection({0, 1});
  EXPECT_EQ(samples(scene, 5, 7).back().x, samples(scene, 5, 7).back().x);
  EXPECT_NE(samples(scene, 5, 7).back().x, samples(scene, 5, 8).back().x);
}

TEST(Samples, begin_with_the_initial_state_and_have_unit_norm) {
  const scene::Scene scene = scene::read(KANEC_SOURCE_DIR "/models/six_body/scene.toml");
  const std::vector<State> list = samples(scene, 20, 1);
  ASSERT_EQ(list.size(), 20u);
  EXPECT_EQ(list[0].x, initial_coordinates(scene));
  EXPECT_EQ(list[0].y, initial_speeds(scene));
  for (const State& state : list)
    for (int k = 0; k < size(scene); ++k) {
      const double* eps = &state.x[static_cast<std::size_t>(scene::Layout(scene).bodies[static_cast<std::size_t>(k)].eps)];
      // a division rounds each of the four by half an ulp
      EXPECT_NEAR(std::hypot(std::hypot(eps[0], eps[1]), std::hypot(eps[2], eps[3])), 1.0, 1e-15);
    }
}

TEST(Samples, every_second_one_has_other_parameters_and_inputs) {
  const scene::Scene scene = scene::from_connection({0, 1});
  const std::vector<State> list = samples(scene, 6, 1);
  for (std::size_t i = 0; i < list.size(); ++i) {
    EXPECT_EQ(list[i].parameters == default_parameters(scene), i % 2 == 0) << i;
    EXPECT_EQ(list[i].inputs == default_inputs(scene), i % 2 == 0) << i;
  }
}

TEST(Model, functions_are_those_that_the_generator_knows) {
  for (const char* name : {"six_body", "six_body_free"}) {
    const scene::Scene scene = scene::read(std::string(KANEC_SOURCE_DIR "/models/") + name + "/scene.toml");
    std::vector<std::string> emitted, known = functions_of(scene);
    for (const program::Function& function : generate(scene).program.functions) emitted.push_back(function.name);
    std::sort(emitted.begin(), emitted.end());
    std::sort(known.begin(), known.end());
    EXPECT_EQ(emitted, known);
  }
}

}  // namespace
}  // namespace kanec::cli
