// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>

#include "generator/read/joint_kind.hpp"
#include "generator/read/parse_expression.hpp"
#include "runtime/base/files.hpp"
#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string models = std::string(KANEC_SOURCE_DIR) + "/models/";

const char* const two_bodies = R"(
name = "two_body"
connection = [0, 1]
gravity = [0.0, 0.0, -9.81]
[parameters]
m_payload = 1.2
[inputs]
thrust = 0.5
[[body]]
name = "hub"
joint = "free"
mass = 4.0
inertia = [0.10, 0.12, 0.08]
force = [0.0, 1.5, "thrust"]
[[body]]
mass = "m_payload"
inertia = [[0.050, 0.002, 0.001], [0.002, 0.060, -0.003], [0.001, -0.003, 0.040]]
r = [0.1, 0.2, 0.05]
q = [0.3, 0.0, "m_payload"]
moment = ["thrust", "m_payload", 0.25]
[body.initial]
eps = [0.1, 0.1, 0.7, 0.7]
omega = [1, 2, 3]
s = [4, 5, 6]
sdot = [7, 8, 9]
)";

TEST(Scene, keeps_what_is_written) {
  const Scene scene = parse(two_bodies, "f");
  EXPECT_EQ(scene.name, "two_body");
  EXPECT_THAT(scene.lower, ElementsAre(0, 1));
  EXPECT_THAT(scene.gravity, ElementsAre(Number::constant(0), Number::constant(0), Number::constant(-9.81)));
  ASSERT_EQ(scene.bodies.size(), 2u);
  const Body& hub = scene.bodies[0];
  EXPECT_EQ(hub.name, "hub");
  EXPECT_EQ(hub.mass, Number::constant(4));
  EXPECT_THAT(hub.force, ElementsAre(Number::constant(0), Number::constant(1.5), Number::input(0)));
  const Body& payload = scene.bodies[1];
  EXPECT_EQ(payload.mass, Number::parameter(0));
  EXPECT_THAT(payload.r, ElementsAre(Number::constant(0.1), Number::constant(0.2), Number::constant(0.05)));
  EXPECT_THAT(payload.q, ElementsAre(Number::constant(0.3), Number::constant(0), Number::parameter(0)));
  EXPECT_THAT(payload.moment, ElementsAre(Number::input(0), Number::parameter(0), Number::constant(0.25)));
  EXPECT_THAT(scene.notes, IsEmpty());
  EXPECT_THAT(scene.warnings, IsEmpty());
}

TEST(Scene, takes_defaults_where_nothing_is_written) {
  const Scene scene = parse(two_bodies, "f");
  EXPECT_EQ(scene.bodies[1].name, "body_2");
  const Body& hub = scene.bodies[0];
  for (const Vector& vector : {hub.r, hub.q, hub.moment})
    for (const Number& number : vector) EXPECT_TRUE(number.is_zero());
  EXPECT_THAT(hub.initial.eps, ElementsAre(0, 0, 0, 1));
  EXPECT_THAT(hub.initial.omega, ElementsAre(0, 0, 0));
  for (const Number& number : parse(one_body(""), "f").gravity) EXPECT_TRUE(number.is_zero());
}

TEST(Scene, gives_its_state_in_order) {
  const Scene scene = parse(two_bodies, "f");
  EXPECT_THAT(initial_coordinates(scene), ElementsAre(0, 0, 0, 1, 0.1, 0.1, 0.7, 0.7, 0, 0, 0, 4, 5, 6));
  EXPECT_THAT(initial_speeds(scene), ElementsAre(0, 0, 0, 1, 2, 3, 0, 0, 0, 7, 8, 9));
  EXPECT_THAT(coordinate_names(scene),
              ElementsAre("eps_1_1", "eps_1_2", "eps_1_3", "eps_1_4", "eps_2_1", "eps_2_2", "eps_2_3", "eps_2_4",
                          "s_1_1", "s_1_2", "s_1_3", "s_2_1", "s_2_2", "s_2_3"));
  EXPECT_THAT(default_parameters(scene), ElementsAre(1.2));
  EXPECT_THAT(default_inputs(scene), ElementsAre(0.5));
}

TEST(Scene, counts_depth_from_the_first_body_of_each_tree) {
  EXPECT_THAT(depth({0, 1, 2, 2, 1, 5}), ElementsAre(0, 1, 2, 2, 1, 2));
  EXPECT_THAT(depth({0, 0, 2, 3, 0}), ElementsAre(0, 0, 1, 2, 0));
}

TEST(Scene, reads_the_same_with_windows_line_ends_and_a_byte_order_mark) {
  std::string text = "\xEF\xBB\xBF";
  for (const char c : std::string(two_bodies)) text += c == '\n' ? "\r\n" : std::string(1, c);
  EXPECT_EQ(initial_coordinates(parse(text, "f")), initial_coordinates(parse(two_bodies, "f")));
}

TEST(SceneFile, that_is_absent_or_a_folder_is_a_file_error) {
  EXPECT_THROW(read(models + "no_such.toml"), FileError);
  EXPECT_THROW(read(models), FileError);
}

TEST(SceneFile, is_named_in_the_message) {
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "kanec_scene_read_test.toml";
  std::ofstream(path) << one_body("r = 1");
  try {
    read(path);
    ADD_FAILURE() << "no error";
  } catch (const SceneError& error) {
    EXPECT_THAT(error.what(), HasSubstr(path.string() + ":6: body 1: r: found 1"));
  }
  std::filesystem::remove(path);
}

class Models : public testing::TestWithParam<std::string> {};

TEST_P(Models, is_read_without_notes_and_warnings_and_named_like_its_folder) {
  const Scene scene = read(models + GetParam() + "/scene.toml");
  EXPECT_EQ(scene.name, GetParam());
  EXPECT_THAT(scene.notes, IsEmpty());
  EXPECT_THAT(scene.warnings, IsEmpty());
  EXPECT_TRUE(std::filesystem::exists(models + GetParam() + "/README.md"));
}

std::vector<std::string> shipped() {
  std::vector<std::string> folders;
  for (const auto& entry : std::filesystem::directory_iterator(models))
    if (std::filesystem::exists(entry.path() / "scene.toml")) folders.push_back(entry.path().filename().string());
  std::sort(folders.begin(), folders.end());
  return folders;
}

INSTANTIATE_TEST_SUITE_P(Shipped, Models, testing::ValuesIn(shipped()),
                         [](const auto& parameter) { return parameter.param; });

TEST(Models, examples_of_the_documentation_are_scenes) {
  const std::string text = read_file(models + "README.md");
  const std::string fence = "```toml\nname = ";
  std::vector<std::string> names;
  for (std::size_t at = text.find(fence); at != std::string::npos; at = text.find(fence, at + 1)) {
    const std::size_t begin = text.find('\n', at) + 1;
    const Scene scene = parse(text.substr(begin, text.find("```\n", begin) - begin), "README.md");
    names.push_back(scene.name);
    EXPECT_THAT(scene.notes, IsEmpty());
    EXPECT_THAT(scene.warnings, IsEmpty());
  }
  EXPECT_THAT(names, ElementsAre("two_body", "cart_arm"));
}

// Every key and every kind is documented: its name stands in the page as code.
TEST(Models, documentation_names_every_key) {
  const std::string text = read_file(models + "README.md");
  for (const JointKind& kind : joint_kinds()) {
    EXPECT_THAT(text, HasSubstr("| `" + kind.name + "` |"));
    for (const std::string& key : kind.keys) EXPECT_THAT(text, HasSubstr("`" + key + "`"));
  }
  for (const std::string& call : call_names()) EXPECT_THAT(text, testing::ContainsRegex("[` ]" + call + "[ (`]"));
  for (const std::string key :
       {"kind", "vector", "axes", "reaction", "coordinate", "other_body", "other_r", "other_point", "point",
        "functions", "theta", "thetadot", "[[point]]", "[[load]]", "[body.motion]"})
    EXPECT_THAT(text, HasSubstr("`" + key + "`"));
}

TEST(Models, six_body_has_no_zero_that_hides_a_term) {
  const Scene scene = read(models + "six_body/scene.toml");
  EXPECT_THAT(scene.lower, ElementsAre(0, 1, 2, 2, 1, 5));
  for (std::size_t k = 0; k < 6; ++k) {
    const Body& body = scene.bodies[k];
    const Symmetric& i = body.inertia;
    for (const Number& number : {i.xy, i.xz, i.yz}) EXPECT_FALSE(number.is_zero()) << body.name;
    for (const Vector& vector : {body.r, body.force, body.moment})
      for (const Number& number : vector) EXPECT_FALSE(number.is_zero()) << body.name;
    for (const Number& number : body.q) EXPECT_EQ(number.is_zero(), k == 0) << body.name;
  }
  for (const double value : initial_coordinates(scene)) EXPECT_NE(value, 0);
  for (const double value : initial_speeds(scene)) EXPECT_NE(value, 0);
  EXPECT_EQ(scene.parameters.size(), 1u);
  EXPECT_EQ(scene.inputs.size(), 1u);
}

TEST(Models, six_body_free_is_six_body_without_what_acts_on_it) {
  const Scene loaded = read(models + "six_body/scene.toml");
  const Scene scene = read(models + "six_body_free/scene.toml");
  EXPECT_EQ(initial_coordinates(scene), initial_coordinates(loaded));
  EXPECT_EQ(initial_speeds(scene), initial_speeds(loaded));
  EXPECT_TRUE(scene.parameters.empty() && scene.inputs.empty());
  for (const Number& number : scene.gravity) EXPECT_TRUE(number.is_zero());
  for (std::size_t k = 0; k < 6; ++k) {
    EXPECT_EQ(scene.bodies[k].r, loaded.bodies[k].r);
    EXPECT_EQ(scene.bodies[k].q, loaded.bodies[k].q);
    for (const Vector& vector : {scene.bodies[k].force, scene.bodies[k].moment})
      for (const Number& number : vector) EXPECT_TRUE(number.is_zero());
  }
  EXPECT_EQ(scene.bodies[3].mass.value, loaded.parameters[0].value);
}

TEST(Models, bench_s6f_follows_its_rule) {
  const Scene scene = read(models + "bench_s6f/scene.toml");
  EXPECT_EQ(scene.inputs.size(), 36u);
  for (int k = 1; k <= 6; ++k) {
    const Body& body = scene.bodies[static_cast<std::size_t>(k - 1)];
    const double m = 1 + 0.1 * k;
    // decimals beside the same products in double: two roundings of numbers below 2
    EXPECT_NEAR(body.mass.value, m, 1e-15);
    EXPECT_NEAR(body.inertia.xx.value, m * 0.10, 1e-15);
    EXPECT_NEAR(body.inertia.yy.value, m * 0.12, 1e-15);
    EXPECT_NEAR(body.inertia.zz.value, m * 0.08, 1e-15);
    EXPECT_NEAR(body.inertia.xy.value, m * 0.005, 1e-15);
    EXPECT_NEAR(body.inertia.xz.value, m * 0.003, 1e-15);
    EXPECT_NEAR(body.inertia.yz.value, m * -0.004, 1e-15);
    EXPECT_NEAR(body.q[1].value, k == 1 ? 0 : 0.05 * k, 1e-15);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string component = "_" + std::to_string(k) + "_" + std::to_string(i + 1);
      EXPECT_EQ(scene.inputs[static_cast<std::size_t>(body.force[i].index)].name, "F" + component);
      EXPECT_EQ(scene.inputs[static_cast<std::size_t>(body.moment[i].index)].name, "M" + component);
    }
  }
}

}  // namespace
}  // namespace kanec::scene
