// Scenes built in code. Oracle: the same scenes as they are written by hand.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/front/bench.hpp"

namespace kanec::test {
namespace {

Table pendulum() {
  return {{"name", "built"},
          {"connection", List{0}},
          {"gravity", std::vector<double>{0, 0, -9.81}},
          {"parameters", Table{{"m", 1.5}}},
          {"body", List{Table{{"name", "bob"},
                              {"joint", "revolute"},
                              {"axis", "y"},
                              {"mass", "m"},
                              {"inertia", std::vector<double>{0.1, 0.1, 0.1}},
                              {"r", std::vector<double>{0, 0, -0.5}},
                              {"initial", Table{{"theta", 0.25}}}}}}};
}

TEST(BuiltScene, is_the_one_that_is_written) {
  const Scene built = Scene::build(pendulum());
  const Scene written = Scene::parse(R"toml(
name = "built"
connection = [0]
gravity = [0.0, 0.0, -9.81]
[parameters]
m = 1.5
[[body]]
name = "bob"
joint = "revolute"
axis = "y"
mass = "m"
inertia = [0.1, 0.1, 0.1]
r = [0.0, 0.0, -0.5]
initial = {theta = 0.25}
)toml");
  EXPECT_EQ(built.text(), written.text());
  EXPECT_EQ(built.initial_x(), std::vector<double>{0.25});
}

TEST(BuiltScene, is_refused_where_the_file_would_be) {
  Table wrong = pendulum();
  wrong.push_back({"gravitty", 1});
  EXPECT_THAT(refusal<SceneError>([&] { Scene::build(wrong); }), testing::HasSubstr("gravitty"));
}

// Whatever stands in a text stays in it.
TEST(TomlText, quotes_what_would_end_a_text) {
  const std::string nasty = "a\"b\\c\nd\x01\x7f = [x]";
  const std::string text = toml_text({{"name", nasty}, {"x y", List{1, 0.1, true, Table{{"a", 1e300}}}}});
  EXPECT_EQ(text,
            "\"name\" = \"a\\\"b\\\\c\\u000ad\\u0001\\u007f = [x]\"\n"
            "\"x y\" = [1, 0.1, true, {\"a\" = 1e+300}]\n");
  EXPECT_THAT(refusal<SceneError>([&] { Scene::build({{"name", nasty}}); }), testing::HasSubstr("name"));
}

TEST(TomlText, keeps_what_is_no_number_for_the_reader_to_refuse) {
  Table table = pendulum();
  table[2] = {"gravity", std::vector<double>{0, 0, std::numeric_limits<double>::quiet_NaN()}};
  EXPECT_THAT(refusal<SceneError>([&] { Scene::build(table); }), testing::HasSubstr("gravity"));
}

}  // namespace
}  // namespace kanec::test
