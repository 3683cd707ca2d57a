// Which functions a model has, and what stands in it. Oracle: the scene, and the text of the emitted header.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include "generator/pipeline.hpp"
#include "generator/program/program.hpp"
#include "runtime/base/error.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

scene::Scene scene_of(const RandomSceneOptions& options) {
  Random random(9);
  return random_scene(random, {0, 1, 1}, options);
}

std::vector<std::string> names(const program::Program& program) {
  std::vector<std::string> list;
  for (const program::Function& function : program.functions) list.push_back(function.name);
  return list;
}

// Without printing the text where it is not so.
bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

bool mentions(const std::string& text, const std::string& word) {
  return std::regex_search(text, std::regex("\\b" + word + "\\b"));
}

TEST(GenerateOptions, leave_out_functions_that_nobody_asks_for) {
  const Generated all = generate(scene_of({}));
  const Generated some = generate(scene_of({}), {{"residual", "poses"}});
  EXPECT_THAT(names(some.program), ElementsAre("residual", "poses"));
  EXPECT_EQ(names(all.program).size(), 11u);
  for (const char* gone : {"accelerations", "mass_matrix", "Iinv"}) {
    EXPECT_TRUE(contains(all.header, gone)) << gone;
    EXPECT_FALSE(contains(some.header, gone)) << gone;
  }
  EXPECT_TRUE(contains(some.header, "functions residual poses"));
  EXPECT_NE(some.hash, all.hash);
  EXPECT_LT(some.program.nodes.size(), all.program.nodes.size());
}

TEST(GenerateOptions, give_a_function_the_same_code_with_and_without_others) {
  const Generated all = generate(scene_of({}));
  const Generated one = generate(scene_of({}), {{"accelerations"}});
  const auto body = [](const std::string& header) {
    const std::size_t from = header.find("// accelerations:");
    return header.substr(from, header.find("\n}\n", header.find("void accelerations(", from)) - from);
  };
  EXPECT_EQ(body(one.header), body(all.header));
}

TEST(GenerateOptions, refuse_a_function_that_the_scene_does_not_have_and_name_those_it_has) {
  EXPECT_THAT(
      [] {
        generate(scene_of({}), {{"residual", "acceleration"}});
      },
      ThrowsMessage<InputError>(HasSubstr("function: found \"acceleration\"; allowed: kinematics, poses, energy, "
                                          "momentum, power, accelerations, residual, forcing, mass_matrix, "
                                          "partial_velocities, partial_velocity_rates, ")));
  EXPECT_THAT(
      [] { generate(scene_of({.loads = false}), {{"power"}}); },
      ThrowsMessage<InputError>(HasSubstr("function: found power, which a scene without applied loads does not have; "
                                          "allowed: kinematics, poses, ")));
}

TEST(GenerateOptions, refuse_a_function_twice_in_one) {
  EXPECT_THAT([] { generate(scene_of({}), {{"energy+energy"}}); },
              ThrowsMessage<InputError>(HasSubstr("function: found \"energy+energy\"; allowed: each part once")));
}

TEST(Generate, a_combination_has_the_patterns_of_its_parts_once) {
  const scene::Scene scene = scene_of({});
  const std::string header = generate(scene, {{"residual_x+residual_y", "residual_y"}}).header;
  for (const char* name : {"residual_x_nonzeros", "residual_y_nonzeros"}) {
    const std::size_t first = header.find(std::string("int ") + name);
    EXPECT_NE(first, std::string::npos) << name;
    EXPECT_EQ(header.find(std::string("int ") + name, first + 1), std::string::npos) << name;
  }
}

// A column of a derivative by the inputs is one of theirs, read or not.
TEST(Generate, a_derivative_by_inputs_keeps_all_inputs) {
  scene::Scene scene = scene_of({});
  scene.inputs = {{"tau", 0.0}, {"spare", 0.0}};
  EXPECT_THAT(generate(scene, {{"accelerations_u"}}).header, HasSubstr("inline constexpr int n_inputs = 2;"));
  EXPECT_THAT(generate(scene, {{"accelerations"}}).header, HasSubstr("inline constexpr int n_inputs = 0;"));
}

TEST(Generate, a_scene_without_gravity_does_not_mention_it) {
  const std::string with = generate(scene_of({})).header;
  const std::string without = generate(scene_of({.gravity = false})).header;
  EXPECT_TRUE(mentions(with, "g"));
  EXPECT_FALSE(mentions(without, "g"));
  for (const char* name : {"potential_?1?", "mp_1"}) {
    EXPECT_TRUE(mentions(with, name)) << name;
    EXPECT_FALSE(std::regex_search(without, std::regex(std::string("const T ") + name))) << name;
  }
}

TEST(Generate, what_depends_on_parameters_only_is_prepared) {
  const std::string header = generate(scene_of({.parameter_share = 1, .input_share = 1})).header;
  EXPECT_TRUE(contains(header, "  c.Iinv2_11 = Iinv2_11;\n"));
  EXPECT_EQ(header.find("const T Iinv2_11"), header.rfind("const T Iinv2_11"));
  EXPECT_TRUE(contains(header, "c.p.m_2"));
}

TEST(Generate, the_hash_is_of_what_is_emitted_and_stands_in_it) {
  const scene::Scene scene = scene_of({});
  const Generated first = generate(scene);
  EXPECT_EQ(first.hash.size(), 16u);
  EXPECT_TRUE(contains(first.header, "model_hash[] = \"" + first.hash + "\";\n"));
  EXPECT_TRUE(contains(first.abi, "\"" + first.hash + "\""));
  EXPECT_EQ(generate(scene).hash, first.hash);
  scene::Scene other = scene;
  other.bodies[1].r[2] = scene::Number::constant(other.bodies[1].r[2].value + 1e-15);
  EXPECT_NE(generate(other).hash, first.hash);
}

}  // namespace
}  // namespace kanec::test
