// The emitted C header: its text, what strict compilers say to it, and its results. Oracles: the compilers, the C++
// header.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "generator/program/ledger.hpp"
#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/process.hpp"
#include "tests/emit/both_languages.hpp"
#include "tests/emit/every_node.hpp"
#include "tests/emit/shipped.hpp"
#include "tests/lower/trees.hpp"

namespace kanec::test {
namespace {

namespace fs = std::filesystem;
using emit::Language;
using emit::Optimize;
using testing::HasSubstr;

std::vector<std::string> shipped_models() {
  std::vector<std::string> models;
  for (const auto& entry : fs::directory_iterator(KANEC_SOURCE_DIR "/models"))
    if (fs::exists(entry.path() / "scene.toml")) models.push_back(entry.path().filename().string());
  std::sort(models.begin(), models.end());
  return models;
}

GenerateOptions in_c(GenerateOptions options) {
  options.language = Language::c;
  return options;
}

// All functions and combinations of them; of large trees, whose derivatives are very long, without these, and of the
// largest those that the scene names.
std::vector<std::string> functions_of(const scene::Scene& scene) {
  if (size(scene) > 12) return scene.functions;
  std::vector<std::string> list = size(scene) <= 3 ? every_function(scene) : without_derivatives(scene);
  for (const char* combination : {"accelerations+residual", "kinematics+accelerations", "energy+mass_matrix"})
    list.push_back(combination);
  return list;
}

std::vector<std::string> compiler(const std::string& name) {
  std::vector<std::string> command = {name};
  const std::vector<std::string> flags = strict_c_flags();
  command.insert(command.end(), flags.begin(), flags.end());
  return command;
}

class CHeader : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Shipped, CHeader, testing::ValuesIn(shipped_models()),
                         [](const auto& model) { return model.param; });

// With every function called, so that no table or parameter is unused.
TEST_P(CHeader, of_all_functions_compiles_without_a_warning_and_is_c_alone) {
  const scene::Scene scene = shipped(GetParam());
  const GenerateOptions options{functions_of(scene)};
  const Generated c = generate(scene, in_c(options)), cpp = generate(scene, options);
  EXPECT_EQ(program::ledgers(c.program), program::ledgers(cpp.program));
  EXPECT_TRUE(c.abi.empty() && c.batch.empty() && c.taylor.empty());
  const std::regex foreign("\\b(template|constexpr|namespace|noexcept|auto|using|std|class|T)\\b|::|\\[\\[|<T>");
  std::istringstream lines(c.header);
  for (std::string line; std::getline(lines, line);) {
    const std::string code = line.substr(0, line.find("//"));
    EXPECT_LE(code.size(), 120u) << line;
    EXPECT_FALSE(std::regex_search(code, foreign)) << line;
  }
  BothLanguages both;
  both.add(scene, cpp, c, 1);
  EXPECT_EQ(both.complaints(compiler("gcc"), "double"), "");
  EXPECT_EQ(both.complaints(
                {"g++", "-std=c++17", "-pedantic", "-Wall", "-Wextra", "-Wconversion", "-Wshadow", "-Werror"}, "float"),
            "");
  if (find_program("clang")) {
    EXPECT_EQ(both.complaints(compiler("clang"), "float"), "");
  }
  if (!find_program("arm-none-eabi-gcc")) return;
  std::vector<std::string> cortex = compiler("arm-none-eabi-gcc");
  for (const char* flag : {"-mcpu=cortex-m4", "-mthumb", "-mfloat-abi=hard", "-mfpu=fpv4-sp-d16"})
    cortex.push_back(flag);
  EXPECT_EQ(both.complaints(cortex, "float"), "");
}

void add(BothLanguages& both, scene::Scene scene, const std::string& name, const GenerateOptions& options) {
  scene.name = name;
  both.add(scene, generate(scene, options), generate(scene, in_c(options)), 31);
}

GenerateOptions written(std::vector<std::string> functions, Optimize optimize, emit::Lengths lengths = {}) {
  GenerateOptions options{std::move(functions), {}, optimize};
  options.lengths = lengths;
  return options;
}

// Parameters, inputs, time, library functions, joints of every kind, derivatives, combinations; in one piece, in
// several, and as loops over bodies.
TEST(CAndCpp, give_the_same_bits_in_double_and_in_float) {
  BothLanguages both;
  const scene::Scene cart_pole = shipped("cart_pole"), every_joint = shipped("every_joint"), arm = shipped("arm_6");
  add(both, cart_pole, "cart_pole", written(functions_of(cart_pole), Optimize::speed));
  add(both, shipped("satellite"), "satellite", {{"accelerations+residual", "residual_x+energy", "power"}});
  add(both, every_joint, "joints", written(without_derivatives(every_joint), Optimize::speed));
  add(both, every_joint, "joints_in_pieces",
      written({"accelerations", "residual_x", "mass_matrix"}, Optimize::line, {40, 15}));
  add(both, every_joint, "joints_in_loops", written(without_derivatives(every_joint), Optimize::loops));
  add(both, arm, "arm",
      written({"accelerations", "accelerations_x+accelerations_y", "partial_velocities"}, Optimize::speed));
  add(both, arm, "arm_in_pieces", written({"accelerations", "partial_velocities"}, Optimize::line, {40, 15}));
  add(both, arm, "arm_in_loops", written({"residual", "accelerations"}, Optimize::loops));
  add(both, shipped("quadruped"), "small_quadruped", written({}, Optimize::size));
  const scene::Scene nodes = every_node_sample().scene;
  both.add(nodes, every_node_model(nodes), every_node_model(nodes, 1, Language::c), 32);
  EXPECT_EQ(both.differences("gcc", "g++"), "");
  EXPECT_EQ(both.complaints(compiler("gcc"), "float"), "");
  if (!find_program("clang") || !find_program("clang++")) return;
  EXPECT_EQ(both.differences("clang", "clang++"), "");
  EXPECT_EQ(both.complaints(compiler("clang"), "double"), "");
}

TEST(CAndCpp, are_told_apart_by_their_hash_and_emitted_alike_twice) {
  const scene::Scene scene = shipped("cart_pole");
  const Generated c = generate(scene, in_c({})), again = generate(scene, in_c({}));
  EXPECT_EQ(c.header, again.header);
  EXPECT_NE(c.hash, generate(scene).hash);
}

TEST(CHeader, is_refused_with_a_taylor_series) {
  GenerateOptions options = in_c({});
  options.with_taylor = true;
  try {
    generate(shipped("pendulum"), options);
    ADD_FAILURE() << "not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("a Taylor series in C"));
  }
}

// Oracle: the compiler's own words.
TEST(CHeader, takes_no_other_scalar_than_float_and_double) {
  const scene::Scene scene = shipped("pendulum");
  BothLanguages both;
  both.add(scene, generate(scene), generate(scene, in_c({})), 1);
  for (const char* real : {"int", "long double", "unsigned"})
    EXPECT_THAT(both.complaints({"gcc", "-std=c99"}, real), HasSubstr("KANEC_REAL is neither float nor double"))
        << real;
}

}  // namespace
}  // namespace kanec::test
