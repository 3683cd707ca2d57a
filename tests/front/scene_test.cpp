// Scenes by the front door: what they say of themselves, and what is made of them.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <fstream>
#include <sstream>

#include "tests/front/bench.hpp"

namespace kanec::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::string file_text(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

TEST(FrontScene, tells_its_states_parameters_and_functions) {
  const Scene scene = shipped("cart_pole");
  EXPECT_EQ(scene.name(), "cart_pole");
  EXPECT_THAT(scene.bodies(), ElementsAre("cart", "pole"));
  EXPECT_THAT(scene.connection(), ElementsAre(0, 1));
  EXPECT_EQ(scene.nx(), 2);
  EXPECT_EQ(scene.x().parts[0].name, "theta_pole");
  EXPECT_EQ(scene.x().parts[0].unit, "rad");
  EXPECT_EQ(scene.y().parts[1].begin, 1);
  EXPECT_EQ(scene.inputs()[0].name, "push");
  const std::vector<Offer> functions = scene.functions();
  const auto mass =
      std::find_if(functions.begin(), functions.end(), [](const Offer& f) { return f.name == "mass_matrix"; });
  ASSERT_NE(mass, functions.end());
  EXPECT_THAT(mass->result.rows, ElementsAre("thetadot_pole", "sdot_cart"));
  EXPECT_EQ(mass->result.size, 4);
  EXPECT_TRUE(mass->reads_x && !mass->reads_y && !mass->reads_ydot);
  EXPECT_EQ(scene.results("kinematics+accelerations").size(), 2u);
}

TEST(FrontScene, reads_and_refuses_as_the_command_does) {
  EXPECT_THAT(refusal<SceneError>([] { Scene::parse("name = 3", "mine.toml"); }), HasSubstr("mine.toml:1"));
  EXPECT_THROW(Scene::read("/no/such/scene.toml"), FileError);
  EXPECT_THAT(refusal<InputError>([] { shipped("cart_pole").results("acelerations"); }),
              HasSubstr("did you mean accelerations?"));
  EXPECT_THAT(refusal<InputError>([] { shipped("cart_pole").with({{"pusch", 1}}); }), HasSubstr("did you mean push?"));
  EXPECT_THAT(refusal<InputError>([] {
                shipped("cart_pole").with({{"push", NAN}});
              }),
              HasSubstr("push: found nan; allowed: a finite number"));
  EXPECT_THROW(Scene::tree({0, 3}), SceneError);
}

TEST(FrontScene, emits_the_header_that_is_shipped) {
  const std::vector<File> files = shipped("cart_pole").generate();
  ASSERT_EQ(files.size(), 1u);
  EXPECT_EQ(files[0].name, "cart_pole.hpp");
  EXPECT_TRUE(files[0].text ==
              file_text(std::filesystem::path(KANEC_SOURCE_DIR) / "generated" / "cart_pole" / "cart_pole.hpp"));
}

TEST(FrontScene, emits_every_kind_of_file_and_refuses_the_rest) {
  const Scene scene = shipped("cart_pole");
  Emission emission;
  emission.abi = emission.taylor = true;
  std::vector<std::string> names;
  for (const File& file : scene.generate(emission)) names.push_back(file.name);
  EXPECT_THAT(names, ElementsAre("cart_pole.hpp", "cart_pole_abi.cpp", "abi.h", "cart_pole_taylor.hpp"));
  emission.language = "c";
  EXPECT_THAT(refusal<InputError>([&] { scene.generate(emission); }), HasSubstr("language c: found it beside abi"));
  emission = {};
  emission.language = "rust";
  EXPECT_THAT(refusal<InputError>([&] { scene.generate(emission); }), HasSubstr("allowed: cpp, c"));
  emission = {};
  emission.optimize = "sized";
  EXPECT_THAT(refusal<InputError>([&] { scene.generate(emission); }), HasSubstr("did you mean size?"));
  EXPECT_THAT(refusal<InputError>([&] { scene.generate({.functions = {"forcings"}}); }),
              HasSubstr("did you mean forcing?"));
  EXPECT_THAT(scene.generate({.language = "c"})[0].name, "cart_pole.h");
  EXPECT_THAT(scene.derive("latex"), HasSubstr("\\begin{document}"));
  EXPECT_THAT(refusal<InputError>([&] { scene.derive("html"); }), HasSubstr("allowed: text, latex, json"));
}

TEST(FrontScene, checks_its_compiled_functions) {
  const std::vector<Agreed> list =
      shipped("cart_pole").check({.functions = {"accelerations", "mass_matrix"}}, shared_cache(), 8);
  ASSERT_EQ(list.size(), 2u);
  for (const Agreed& one : list) EXPECT_TRUE(one.passed) << one.function;
}

// Oracle: the energy of a pendulum without friction is kept, and its values of parameters count.
TEST(FrontScene, simulates_with_its_values) {
  const Scene scene = shipped("cart_pole");
  auto run = scene.run();
  run.duration = 1;
  run.output_step = 0.25;
  const Motion still = scene.simulate(run, shared_cache());
  const Motion pushed = scene.with({{"push", 5}}).simulate(run, shared_cache());
  ASSERT_EQ(still.rows(), 5u);
  EXPECT_EQ(still.x_at(0)[0], scene.initial_x()[0]);
  EXPECT_NE(still.x_at(4)[1], pushed.x_at(4)[1]);
  EXPECT_LT(still.energy_error.value(), 1e-8);
  EXPECT_EQ(still.kinetic.size(), 5u);
  run.integrator = "taylor";
  const Motion series = scene.simulate(run, shared_cache());
  for (std::size_t i = 0; i < still.x.size(); ++i) EXPECT_NEAR(series.x[i], still.x[i], 1e-7);
  run.integrator = "euler";
  EXPECT_THAT(refusal<InputError>([&] { scene.simulate(run, shared_cache()); }), HasSubstr("euler"));
}

TEST(FrontScene, what_is_compiled_has_its_values) {
  const Scene scene = shipped("cart_pole").with({{"push", 5}});
  const Emission emission{.functions = {"accelerations"}};
  const Model model = scene.compile(emission, shared_cache());
  EXPECT_EQ(model.inputs()[0].value, 5);
  const std::vector<double> x{0.1, 0.2}, y{0.3, 0.4};
  const std::vector<double> pushed = Evaluator(model).evaluate("accelerations", {.x = x, .y = y});
  Evaluator still(shipped("cart_pole").compile(emission, shared_cache()));
  EXPECT_NE(still.evaluate("accelerations", {.x = x, .y = y}), pushed);
  still.set_input("push", 5);
  EXPECT_EQ(still.evaluate("accelerations", {.x = x, .y = y}), pushed);
  Batch batch = scene.compile_batch(emission, shared_cache(), 1);
  EXPECT_EQ(batch.model().inputs()[0].value, 5);
  std::vector<double> one(2);
  batch.evaluate(batch.model().function("accelerations"), StatesView<double>{.count = 1, .x = x, .y = y}, one);
  for (std::size_t i = 0; i < 2; ++i) EXPECT_NEAR(one[i], pushed[i], 1e-14);
  EXPECT_THAT(refusal<InputError>([&] { model.with({{"push", NAN}}); }), HasSubstr("push: found nan"));
}

TEST(FrontScene, a_scene_that_goes_away_after_reading_is_of_no_concern) {
  const Folder folder;
  std::filesystem::copy(std::filesystem::path(KANEC_SOURCE_DIR) / "models" / "pendulum" / "scene.toml",
                        folder.path() / "scene.toml");
  const Scene scene = Scene::read(folder.path());
  std::filesystem::remove(folder.path() / "scene.toml");
  EXPECT_TRUE(scene.compile({.functions = {"accelerations"}}, shared_cache()).has("accelerations"));
}

TEST(FrontScene, events_happen_in_a_motion) {
  const Scene scene = Scene::parse(R"toml(
name = "falling"
connection = [0]
gravity = [0.0, 0.0, -10.0]
[[body]]
joint = "prismatic"
axis = "z"
mass = 1.0
inertia = [1.0, 1.0, 1.0]
initial = {s = 5.0}
[[event]]
name = "ground"
expression = "s_1"
direction = "down"
action = "stop"
[simulate]
duration = 3.0
)toml");
  const Motion motion = scene.simulate(scene.run(), shared_cache());
  ASSERT_EQ(motion.happenings.size(), 1u);
  EXPECT_TRUE(motion.stopped);
  EXPECT_NEAR(motion.happenings[0].t, 1.0, 1e-9);
  EXPECT_FALSE(motion.happenings[0].up);
}

}  // namespace
}  // namespace kanec::test
