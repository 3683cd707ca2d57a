// Emitted text of every pair of joints, of many functions at once, in one piece and in several. Oracles: the compilers,
// and the generic numeric path.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "generator/read/read.hpp"
#include "runtime/base/process.hpp"
#include "tests/emit/many_models.hpp"
#include "tests/lower/trees.hpp"

namespace kanec::test {
namespace {

using emit::Optimize;
using symbolic::Algorithm;

// Of the two masses and inertias either general or the same sphere, with its mass centre at the joint.
scene::Scene pair_of(const std::string& below, const std::string& above, bool is_general) {
  Random random(static_cast<std::uint64_t>(below.size() * 100 + above.size()));
  scene::Scene scene = random_scene(
      random, std::vector<int>{0, 1},
      {.loads = is_general, .joints = {below, above}, .in_order = true, .springs = is_general, .points = 1});
  if (!is_general)
    for (scene::Body& body : scene.bodies) {
      const scene::Number one = scene::Number::constant(1.0);
      body.mass = one;
      body.inertia = {};
      body.inertia.xx = body.inertia.yy = body.inertia.zz = one;
      body.r = {};
    }
  scene.name = below + "_" + above + (is_general ? "" : "_spheres");
  return scene;
}

struct Member {
  Sample sample;
  Generated generated;
};

std::size_t at_size(program::Index count) { return static_cast<std::size_t>(count); }

// Whether the other parts take the accelerations that are a part.
bool is_fed(const program::Function& function) {
  const std::vector<program::Result> list = results(function);
  return std::any_of(list.begin(), list.end(), [](const auto& result) { return result.function == "accelerations"; });
}

// Relative to the largest entry of what the generic path finds. A name that stands for another value is off by a tenth
// and more; roundings of double are amplified where A is nearly singular, 1e-10 at worst here.
void expect_generic_results(const ManyModels& models, const Member& member) {
  SCOPED_TRACE(member.generated.name);
  const program::Arguments<long double> at = arguments<long double>(member.sample);
  program::Arguments<long double> fed = at;
  fed.ydot = generic_result(member.sample, "accelerations", at);
  for (const program::Function& function : member.generated.program.functions) {
    SCOPED_TRACE(function.name);
    const std::vector<double> found = models.result(member.generated.name, function.name, member.sample);
    std::size_t begin = 0;
    for (const program::Result& result : results(function)) {
      SCOPED_TRACE(result.function);
      const std::vector<long double> part(found.begin() + static_cast<std::ptrdiff_t>(begin),
                                          found.begin() + static_cast<std::ptrdiff_t>(begin + at_size(result.count)));
      begin += part.size();
      const program::Arguments<long double>& now = is_fed(function) ? fed : at;
      EXPECT_LT(relative_difference(
                    comparable(member.sample, result.function, part),
                    comparable(member.sample, result.function, generic_result(member.sample, result.function, now)),
                    least_size),
                1e-9);
    }
  }
}

class PairsOfJoints : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Below, PairsOfJoints, testing::ValuesIn(every_joint()));

TEST_P(PairsOfJoints, compute_what_the_generic_path_does) {
  ManyModels models;
  std::vector<Member> members;
  for (const std::string& above : every_joint())
    for (const bool is_general : {true, false}) {
      Random random(5);
      const Sample sample = sample_of(pair_of(GetParam(), above, is_general), random);
      members.push_back({sample, generate(sample.scene, {without_derivatives(sample.scene)})});
      models.add(members.back().generated);
    }
  models.load("g++");
  for (const Member& member : members) expect_generic_results(models, member);
}

// All functions, derivatives among them, as straight lines, loops and for size in turn, by both algorithms. clang++
// reads them faster than g++, which has its say above.
TEST_P(PairsOfJoints, compile_without_a_warning_in_every_form) {
  ManyModels models;
  const std::vector<std::string> kinds = every_joint();
  for (std::size_t i = 0; i < kinds.size(); ++i) {
    const scene::Scene scene = pair_of(GetParam(), kinds[i], i % 2 == 0);
    GenerateOptions options{every_function(scene)};
    options.optimize = std::array{Optimize::line, Optimize::loops, Optimize::size}[(i + GetParam().size()) % 3];
    options.algorithm = i % 4 < 2 ? Algorithm::composite : Algorithm::articulated;
    models.add(generate(scene, options));
  }
  EXPECT_EQ(models.complaints(find_program("clang++") ? "clang++" : "g++"), "");
}

// Names of a scene by its number.
scene::Scene numbered(scene::Scene scene, int number) {
  scene.name = "random_" + std::to_string(number);
  return scene;
}

// Several forms of functions of random trees of every joint: in loops, in pieces of which many results cross the cuts,
// by either algorithm, with derivatives.
class RandomTrees : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Groups, RandomTrees, testing::Range(0, 6));

GenerateOptions in_some_form(int seed, const scene::Scene& scene) {
  GenerateOptions options{without_derivatives(scene)};
  if (seed % 3 == 0)
    options.functions = {"accelerations+residual", "accelerations", "state_matrix", "residual_x+energy"};
  options.optimize = std::array{Optimize::line, Optimize::loops, Optimize::size}[static_cast<std::size_t>(seed) % 3];
  if (seed % 4 > 1) options.algorithm = seed % 4 == 2 ? Algorithm::composite : Algorithm::articulated;
  options.lengths = {40, 15};
  return options;
}

TEST_P(RandomTrees, compute_in_pieces_and_loops_what_the_generic_path_does) {
  ManyModels models;
  std::vector<Member> members;
  for (int i = 0; i < 20; ++i) {
    const int seed = 20 * GetParam() + i;
    Random random(static_cast<std::uint64_t>(9000 + seed));
    const Sample sample = sample_of(numbered(random_scene(random, 1 + seed % 4, everything()), seed), random);
    members.push_back({sample, generate(sample.scene, in_some_form(seed, sample.scene))});
    models.add(members.back().generated);
  }
  models.load("g++");
  for (const Member& member : members) expect_generic_results(models, member);
}

// Every two functions that a scene has, as one. What one part returns and another takes is given on: no ẏ is asked for
// where accelerations are a part.
TEST(PairsOfFunctions, compile_and_hand_on_the_accelerations) {
  for (const std::string name : {"cart_pole", "satellite"}) {
    const scene::Scene scene = scene::read(KANEC_SOURCE_DIR "/models/" + name + "/scene.toml");
    const std::vector<std::string> all = every_function(scene);
    std::vector<std::string> pairs;
    for (const std::string& a : all)
      for (const std::string& b : all)
        if (a != b && (name == "cart_pole" || a == "accelerations")) pairs.push_back(a + "+" + b);
    Random random(3);
    const Member member{sample_of(scene, random), generate(scene, {pairs})};
    EXPECT_FALSE(find(member.generated.program, "accelerations_and_residual").signature.ydot);
    ManyModels models;
    models.add(member.generated);
    models.load("g++");
    expect_generic_results(models, member);
  }
}

}  // namespace
}  // namespace kanec::test
