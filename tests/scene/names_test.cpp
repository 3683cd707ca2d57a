// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string rule =
    "; allowed: a C++ identifier: letters, digits, single underscores, at most 63, a letter first, no keyword";

std::string scene_named(const std::string& name) { return "name = '" + name + "'\nconnection = [0]\n" + good_body(); }

TEST(Names, that_are_no_identifiers_are_refused) {
  for (const std::string name : {"", "2nd", "a b", "a-b", "a__b", "_a", "größe", "a.b", "../../etc"}) {
    EXPECT_EQ(message(scene_named(name)), "f:1: name: found \"" + name + "\"" + rule);
    EXPECT_THAT(message(one_body("name = '" + name + "'")),
                StartsWith("f:6: body 1: name: found \"" + name + "\"" + rule));
    EXPECT_THAT(message(with_table("[parameters]\n'" + name + "' = 1")), HasSubstr(": found \"" + name + "\"" + rule));
    EXPECT_THAT(message(with_table("[inputs]\n'" + name + "' = 1")), HasSubstr(": found \"" + name + "\"" + rule));
  }
}

TEST(Names, may_have_63_characters_and_no_more) {
  EXPECT_EQ(message(scene_named(std::string(63, 'a'))), "no error");
  EXPECT_THAT(message(scene_named(std::string(64, 'a'))), HasSubstr("(64 bytes)" + rule));
}

TEST(Names, that_are_keywords_are_refused) {
  EXPECT_EQ(message(scene_named("class")), "f:1: name: found \"class\"" + rule);
  EXPECT_EQ(message(one_body("name = 'double'")), "f:6: body 1: name: found \"double\"" + rule);
  EXPECT_EQ(message(with_table("[parameters]\nint = 1")), "f:7: parameters.int: found \"int\"" + rule);
  EXPECT_EQ(message(with_table("[inputs]\nxor = 1")), "f:7: inputs.xor: found \"xor\"" + rule);
}

TEST(Names, that_C_headers_may_define_as_macros_are_refused) {
  for (const std::string name : {"M_PI", "EOF", "INT_MAX"})
    EXPECT_EQ(message(with_table("[parameters]\n" + name + " = 1")),
              "f:7: parameters." + name + ": found \"" + name +
                  "\", which may be a macro in C headers; allowed: a name with small letters");
}

TEST(Names, that_the_emitted_code_uses_are_refused) {
  for (const std::string name : {"kanec", "std", "T", "Parameters", "NAN", "linux"})
    EXPECT_EQ(message(scene_named(name)),
              "f:1: name: found \"" + name + "\", which the emitted code uses itself; allowed: another name");
  EXPECT_THAT(message(with_table("[parameters]\nstd = 1")), HasSubstr("which the emitted code uses itself"));
}

TEST(Names, that_are_namespaces_of_kanec_are_refused_for_scenes_alone) {
  EXPECT_EQ(message(scene_named("lower")), "f:1: name: found \"lower\", a namespace of kanec; allowed: another name");
  EXPECT_EQ(message(scene_named("lanes")), "f:1: name: found \"lanes\", a namespace of kanec; allowed: another name");
  EXPECT_EQ(message(one_body("name = 'lower'")), "no error");
}

TEST(Names, of_two_bodies_alike_are_refused) {
  EXPECT_EQ(message("name = 'a'\nconnection = [0, 1]\n" + good_body("arm") + good_body("arm")),
            "f:7: body 2: name: found \"arm\", the name of body 1; allowed: another name");
  EXPECT_THAT(message("name = 'a'\nconnection = [0, 1]\n" + good_body("body_2") + good_body()),
              HasSubstr("body 2: name: found \"body_2\", the name of body 1"));
}

TEST(Names, of_a_parameter_twice_are_refused) {
  EXPECT_THAT(message(with_table("[parameters]\nm = 1\nm = 2")), StartsWith("f:8: found "));
}

TEST(Names, of_a_parameter_and_an_input_alike_are_refused) {
  EXPECT_EQ(message(with_table("[parameters]\nm = 1\n[inputs]\nm = 2")),
            "f:9: inputs.m: found a parameter and an input of this name, the other on line 7; allowed: two names");
}

TEST(Names, without_a_parameter_or_input_are_refused_with_the_nearest) {
  EXPECT_EQ(
      message(bare_body("mass = 'm_paylod'\ninertia = [1, 1, 1]\n[parameters]\nm_payload = 1\nm_hub = 2")),
      "f:4: body 1: mass: found the text \"m_paylod\"; allowed: a number or the name of a parameter: m_payload, m_hub "
      "(did you mean m_payload?)");
  EXPECT_THAT(
      message(one_body("force = [0, 'trust', 0]\n[inputs]\nthrust = 0")),
      AllOf(StartsWith("f:6: body 1: force[2]: found \"trust\" in column 1 of \"trust\"; allowed: a name: pi, t, "
                       "thrust, "),
            HasSubstr("(did you mean thrust?)")));
  EXPECT_EQ(
      message(bare_body("mass = '1.5'\ninertia = [1, 1, 1]")),
      "f:4: body 1: mass: found the text \"1.5\"; allowed: a number or the name of a parameter (this scene has none)");
}

TEST(Names, of_many_parameters_are_listed_in_part) {
  std::string table = "[parameters]\n";
  for (int i = 1; i <= 30; ++i) table.append("p").append(std::to_string(i)).append(" = 1\n");
  EXPECT_THAT(message(one_body("r = [0, 0, 'length']\n" + table)), HasSubstr("p19, p20, … (30 in all)"));
}

TEST(Names, of_inputs_are_for_loads_alone) {
  const std::string inputs = "\n[inputs]\nu = 1\n";
  const std::string rest = "found the input u; allowed: a number or a parameter: inputs are for loads alone";
  EXPECT_EQ(message(bare_body("mass = 'u'\ninertia = [1, 1, 1]" + inputs)), "f:4: body 1: mass: " + rest);
  EXPECT_EQ(message(bare_body("mass = 1\ninertia = [1, 'u', 1]" + inputs)), "f:5: body 1: inertia[2]: " + rest);
  EXPECT_EQ(message(one_body("r = ['u', 0, 0]" + inputs)), "f:6: body 1: r[1]: " + rest);
  EXPECT_EQ(message(one_body("q = [0, 0, 'u']" + inputs)), "f:6: body 1: q[3]: " + rest);
  EXPECT_EQ(message("gravity = [0, 0, 'u']\n" + one_body(inputs)), "f:1: gravity[3]: " + rest);
  EXPECT_EQ(message(one_body("force = ['u', 0, 0]\nmoment = [0, 'u', 0]" + inputs)), "no error");
}

TEST(Names, that_nothing_uses_are_a_warning) {
  EXPECT_THAT(
      parse(with_table("[parameters]\nm = 1\n[inputs]\nu = 1"), "f").warnings,
      ElementsAre("f:7: parameters.m: nothing in the scene uses it", "f:9: inputs.u: nothing in the scene uses it"));
}

TEST(Names, keep_the_order_of_the_file) {
  const Scene scene = parse(one_body("r = ['z', 'a', 'm']\n[parameters]\nz = 1\na = 2\nm = 3"), "f");
  ASSERT_EQ(scene.parameters.size(), 3u);
  EXPECT_EQ(scene.parameters[0].name, "z");
  EXPECT_EQ(scene.parameters[1].name, "a");
  EXPECT_EQ(scene.parameters[2].name, "m");
  EXPECT_THAT(scene.bodies[0].r, ElementsAre(Number::parameter(0), Number::parameter(1), Number::parameter(2)));
  EXPECT_THAT(default_parameters(scene), ElementsAre(1, 2, 3));
}

}  // namespace
}  // namespace kanec::scene
