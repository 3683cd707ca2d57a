// Every function of 500 trees of every joint, load and motion: each kind of joint alone, and all of them together.
// Oracle: the generic numeric path in long double.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "generator/choice/requests.hpp"
#include "generator/program/passes.hpp"
#include "tests/lower/trees.hpp"

namespace kanec::test {
namespace {

using symbolic::Derivatives;

struct Kind {
  std::string joint;  // "every", or one
  std::uint64_t seed;
  friend void PrintTo(const Kind& kind, std::ostream* out) { *out << kind.joint << " from seed " << kind.seed; }
};

// Thirteen lots of every joint, and one of each alone.
std::vector<Kind> kinds() {
  std::vector<Kind> result;
  for (std::uint64_t seed = 1; seed <= 13; ++seed) result.push_back({"every", 10000 * seed});
  for (const std::string& joint : every_joint()) result.push_back({joint, 1000 * result.size()});
  return result;
}

class Joints : public testing::TestWithParam<Kind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, Joints, testing::ValuesIn(kinds()), [](const auto& kind) {
  return kind.param.joint + "_" + std::to_string(kind.param.seed / 1000);
});

// Each lot has trees of 1 to 12 bodies, and of the smaller ones a few more.
constexpr int sizes[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 1, 2, 3, 4, 5, 6, 2, 3};
// Derivatives of large trees take seconds; those of the first trees of up to six bodies are among the functions.
constexpr int n_with_derivatives = 6;

Sample tree(const Kind& kind, int n_bodies, std::uint64_t i) {
  Random random(kind.seed + i);
  RandomSceneOptions options = everything();
  if (kind.joint != "every") options.joints = {kind.joint};
  return sample_of(random_scene(random, n_bodies, options), random);
}

std::vector<long double> wide(const std::vector<double>& v) { return {v.begin(), v.end()}; }

// The algorithms, the axes, the origins, the grouping of masses and the derivatives that there are, each on a part of
// the trees: which is the cheapest does not matter here.
std::vector<symbolic::Way> all_ways() {
  std::vector<symbolic::Way> ways;
  for (const auto algorithm : {symbolic::Algorithm::articulated, symbolic::Algorithm::composite})
    for (const auto axes : {symbolic::Axes::body, symbolic::Axes::inertial})
      for (const bool place : {true, false})
        for (const bool regroup : {true, false}) {
          ways.push_back(
              {{}, algorithm, axes, ways.size() % 3 == 0 ? Derivatives::operations : Derivatives::equations});
          ways.back().reductions.place_origins = place;
          ways.back().reductions.regroup = regroup;
          ways.back().reductions.turn_axes = place != regroup;
        }
  return ways;
}

// Constants that the passes fold are doubles: 1.1e-16 each, in sums of some hundred terms. Measured: below 1e-14, but
// for points that hardly accelerate, 8e-14, where gravity of ten is subtracted and added again.
constexpr double of_constants = 1e-12;

// Measured over 500 trees: 1e-14 for most, 4e-13 for powers, which cancel. With the mass matrix scaled to ones on its
// diagonal, its condition is below 3e3 in these trees: no tolerance is wider where it is worse.
TEST_P(Joints, give_what_the_generic_path_gives) {
  const std::vector<symbolic::Way> ways = all_ways();
  for (int i = 0; i < int(std::size(sizes)); ++i) {
    const Sample s = tree(GetParam(), sizes[i], static_cast<std::uint64_t>(i));
    const bool with_derivatives = i < n_with_derivatives;
    const std::vector<std::string> names = with_derivatives ? every_function(s.scene) : without_derivatives(s.scene);
    const symbolic::Way& way = ways[(GetParam().seed / 1000 + static_cast<std::size_t>(i)) % ways.size()];
    const program::Program program = program::optimized(kanec::program_of(s.scene, names, way));
    const program::Arguments<double> at = arguments<double>(s);
    for (const program::Function& function : program.functions) {
      SCOPED_TRACE(function.name + " of tree " + std::to_string(i) + " with " + std::to_string(sizes[i]) + " bodies");
      const auto compared = [&](const std::vector<long double>& result) {
        return comparable(s, function.name, result);
      };
      const auto expected = compared(generic_result(s, function.name, widened(at)));
      EXPECT_LT(relative_difference(compared(wide(evaluate(program, function, at))), expected, least_size), 1e-11);
      EXPECT_LT(relative_difference(compared(evaluate(program, function, widened(at))), expected, least_size),
                of_constants);
    }
  }
}

}  // namespace
}  // namespace kanec::test
