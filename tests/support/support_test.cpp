// That random scenes are the same everywhere and physically sound; that dual numbers differentiate.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <set>

#include "tests/support/dual.hpp"
#include "tests/support/random_scene.hpp"

namespace kanec::test {
namespace {

double value(const scene::Scene& scene, const scene::Number& number) {
  return number.kind == scene::Number::Kind::constant ? number.value
                                                      : scene.parameters[static_cast<std::size_t>(number.index)].value;
}

Eigen::Matrix3d matrix(const scene::Scene& scene, const scene::Symmetric& a) {
  Eigen::Matrix3d m;
  m << value(scene, a.xx), value(scene, a.xy), value(scene, a.xz), value(scene, a.xy), value(scene, a.yy),
      value(scene, a.yz), value(scene, a.xz), value(scene, a.yz), value(scene, a.zz);
  return m;
}

// The 10000th output of mt19937_64 with its default seed is given by the C++ standard, [rand.predef].
TEST(Random, uniform_numbers_follow_the_standard_engine) {
  Random random(std::mt19937_64::default_seed);
  double last = 0;
  for (int i = 0; i < 10000; ++i) last = random.uniform(0, 1);
  EXPECT_EQ(last, static_cast<double>(9981545732273789042ull >> 11) / 9007199254740992.0);
}

TEST(RandomScene, same_seed_gives_the_same_scene_and_another_seed_another) {
  const auto initial = [](std::uint64_t seed) {
    Random random(seed);
    return scene::initial_coordinates(random_scene(random, 5));
  };
  EXPECT_EQ(initial(7), initial(7));
  EXPECT_NE(initial(7), initial(8));
}

TEST(RandomScene, every_connection_is_valid_and_trees_stand_on_one_body) {
  Random random(11);
  for (int n_bodies = 1; n_bodies <= 12; ++n_bodies)
    for (const bool forest : {false, true}) {
      const std::vector<int> lower = random_connection(random, n_bodies, forest);
      ASSERT_EQ(lower.size(), static_cast<std::size_t>(n_bodies));
      EXPECT_EQ(lower[0], 0);
      for (int k = 2; k <= n_bodies; ++k) {
        EXPECT_LT(lower[static_cast<std::size_t>(k - 1)], k);
        EXPECT_GE(lower[static_cast<std::size_t>(k - 1)], forest ? 0 : 1);
      }
    }
}

TEST(RandomScene, inertias_are_positive_definite_and_keep_the_triangle_inequality) {
  Random random(13);
  for (const double zero_share : {0.0, 0.5}) {
    RandomSceneOptions options;
    options.zero_share = zero_share;
    options.parameter_share = 0.5;
    const scene::Scene scene = random_scene(random, 12, options);
    for (const scene::Body& body : scene.bodies) {
      const Eigen::Vector3d principal = matrix(scene, body.inertia).selfadjointView<Eigen::Lower>().eigenvalues();
      EXPECT_GT(principal[0], 0);
      EXPECT_LE(principal[2], principal[0] + principal[1]);
    }
  }
}

TEST(RandomScene, shares_of_one_turn_every_number_into_a_parameter_or_an_input) {
  Random random(17);
  RandomSceneOptions options;
  options.parameter_share = 1;
  options.input_share = 1;
  const scene::Scene scene = random_scene(random, 4, options);
  EXPECT_EQ(scene.parameters.size(), 3u + 4u * 13u);  // gravity; mass, inertia, r, q of four bodies
  EXPECT_EQ(scene.inputs.size(), 4u * 6u);            // force and moment of four bodies
  std::set<std::string> names;
  for (const scene::Named& named : scene.parameters) names.insert(named.name);
  for (const scene::Named& named : scene.inputs) names.insert(named.name);
  EXPECT_EQ(names.size(), scene.parameters.size() + scene.inputs.size());
}

TEST(Dual, differentiates_every_operation) {
  // t at t = 2: 8t³ + √t - 1/t + |1 - t| has the rate 24t² + 1/(2√t) + 1/t² + 1.
  const Dual<double> t(2.0, 1.0);
  const Dual<double> f = 8 * t * t * t + sqrt(t) - 1 / t + abs(1 - t);
  // a handful of roundings of numbers near 100
  EXPECT_NEAR(f.value, 64 + std::sqrt(2.0) - 0.5 + 1, 1e-13);
  EXPECT_NEAR(f.rate, 96 + 0.5 / std::sqrt(2.0) + 0.25 + 1, 1e-13);
}

}  // namespace
}  // namespace kanec::test
