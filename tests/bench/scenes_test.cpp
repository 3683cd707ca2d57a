// The benchmark scenes follow the rule in their README. Oracle: that rule.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "generator/read/read.hpp"

namespace kanec::scene {
namespace {

struct Chain {
  const char* name;
  const char* joint;
  int n_bodies;
};

class BenchmarkChain : public testing::TestWithParam<Chain> {};

INSTANTIATE_TEST_SUITE_P(Models, BenchmarkChain,
                         testing::Values(Chain{"bench_cr7", "revolute", 7}, Chain{"bench_cr16", "revolute", 16},
                                         Chain{"bench_cr32", "revolute", 32}, Chain{"bench_cr64", "revolute", 64},
                                         Chain{"bench_cb6", "ball", 6}, Chain{"bench_cb32", "ball", 32}),
                         [](const auto& chain) { return std::string(chain.param.name); });

// Decimals beside the same products in double: two roundings of numbers below 8.
constexpr double rounding = 2e-15;

void expect_numbers(const Body& body, int k) {
  const double m = 1 + 0.1 * k;
  EXPECT_NEAR(body.mass.value, m, rounding);
  EXPECT_NEAR(body.inertia.xx.value, m * 0.10, rounding);
  EXPECT_NEAR(body.inertia.yy.value, m * 0.12, rounding);
  EXPECT_NEAR(body.inertia.zz.value, m * 0.08, rounding);
  EXPECT_NEAR(body.inertia.xy.value, m * 0.005, rounding);
  EXPECT_NEAR(body.inertia.xz.value, m * 0.003, rounding);
  EXPECT_NEAR(body.inertia.yz.value, m * -0.004, rounding);
  EXPECT_EQ(body.r, (Vector{Number::constant(0.1), Number::constant(0.2), Number::constant(0.05)}));
  EXPECT_NEAR(body.q[0].value, k == 1 ? 0 : 0.3, rounding);
  EXPECT_NEAR(body.q[1].value, k == 1 ? 0 : 0.05 * k, rounding);
  EXPECT_NEAR(body.q[2].value, k == 1 ? 0 : 0.1, rounding);
}

TEST_P(BenchmarkChain, follows_its_rule) {
  const Scene scene = read(std::string(KANEC_SOURCE_DIR "/models/") + GetParam().name + "/scene.toml");
  ASSERT_EQ(size(scene), GetParam().n_bodies);
  EXPECT_EQ(static_cast<int>(scene.inputs.size()), n_speeds(scene));
  EXPECT_EQ(scene.gravity, (Vector{Number::constant(0), Number::constant(0), Number::constant(-9.81)}));
  for (int k = 1; k <= size(scene); ++k) {
    const Body& body = scene.bodies[static_cast<std::size_t>(k) - 1];
    SCOPED_TRACE(body.name);
    EXPECT_EQ(scene.lower[static_cast<std::size_t>(k) - 1], k - 1);
    EXPECT_EQ(body.joint.kind, GetParam().joint);
    expect_numbers(body, k);
    if (body.joint.ball) continue;
    EXPECT_EQ(body.joint.turns.at(0).axis[static_cast<std::size_t>(k % 3)], 1.0);
  }
}

}  // namespace
}  // namespace kanec::scene
