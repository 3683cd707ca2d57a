// Emitted code of small trees of every joint, compiled alone and run in each scalar. Oracles: the program evaluated
// operation by operation, the generic numeric path, and the emitted derivatives against dual numbers through the same
// header.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "tests/emit/driver.hpp"
#include "tests/lower/trees.hpp"

namespace kanec::test {
namespace {

using Vector = std::vector<long double>;

Sample tree(int seed, int n_bodies) {
  Random random(static_cast<std::uint64_t>(7000 + seed));
  Sample s = sample_of(random_scene(random, n_bodies, everything()), random);
  s.t = Driver::time;
  return s;
}

// Of one to three bodies; the smaller the more functions, so that the compiler has little to read.
Generated generated(const Sample& s) {
  const int n_bodies = scene::size(s.scene);
  if (n_bodies == 1) return generate(s.scene, {every_function(s.scene)});
  if (n_bodies == 2) return generate(s.scene, {without_derivatives(s.scene)});
  return generate(s.scene);
}

class SmallTrees : public testing::TestWithParam<int> {};

INSTANTIATE_TEST_SUITE_P(Seeds, SmallTrees, testing::Range(0, 30));

TEST_P(SmallTrees, give_the_numbers_of_their_programs_in_every_scalar) {
  const Sample s = tree(GetParam(), 1 + GetParam() % 3);
  const Generated model = generated(s);
  Driver driver(s, model);
  ASSERT_EQ(driver.compile("g++", {"-O0", "-ffp-contract=off"}, {"float", "double", "long double"}), "");
  driver.run();
  const program::Arguments<long double> at = arguments<long double>(s);
  for (const program::Function& function : model.program.functions) {
    SCOPED_TRACE(function.name);
    const Vector of_program = evaluate(model.program, function, at);
    const Vector result = driver.results<long double>("long double", function.name);
    EXPECT_LT(relative_difference(result, of_program, least_size), 1e-16);  // a few hundred roundings of 5e-20
    // folded constants are doubles, 1.1e-16 off, in sums that cancel
    EXPECT_LT(relative_difference(comparable(s, function.name, result),
                                  comparable(s, function.name, generic_result(s, function.name, at)), least_size),
              1e-12);
    EXPECT_LT(relative_difference(driver.results<double>("double", function.name), of_program, least_size), 1e-12);
    // 6e-8 a rounding; measured 3e-5
    EXPECT_LT(relative_difference(driver.results<double>("float", function.name), of_program, least_size), 1e-3);
  }
}

// A direction in which all arguments but time and parameters change.
program::Arguments<long double> direction(const Sample& s, Random& random) {
  program::Arguments<long double> rates = still(s);
  for (Vector* part : {&rates.x, &rates.y, &rates.ydot, &rates.inputs})
    for (long double& rate : *part) rate = random.uniform(-1, 1);
  return rates;
}

Vector product(const std::vector<double>& matrix, const Vector& v) {
  Vector result(v.empty() ? 0 : matrix.size() / v.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) result[i] += matrix[i * v.size() + j] * v[j];
  return result;
}

Vector sum(Vector a, const Vector& b) {
  for (std::size_t i = 0; i < b.size(); ++i) a[i] += b[i];
  return a;
}

// The header's own functions in a dual scalar, along one direction, against its derivatives times that direction.
TEST(EmittedDerivatives, are_the_rates_of_the_emitted_functions_in_dual_numbers) {
  for (const int seed : {100, 103}) {
    const Sample s = tree(seed, 2);
    ASSERT_GT(s.state.y.size() * s.scene.inputs.size(), 0u) << seed;
    const Generated model =
        generate(s.scene, {{"residual", "residual_x", "residual_y", "residual_ydot", "accelerations", "accelerations_x",
                            "accelerations_y", "accelerations_u"}});
    Driver driver(s, model);
    ASSERT_EQ(driver.compile("g++", {"-O0"}, {"double", "dual"}), "");
    Random random(1);
    const program::Arguments<long double> rates = direction(s, random);
    driver.run(rates);
    const auto times = [&](const std::string& name, const Vector& v) {
      return product(driver.results<double>("double", name), v);
    };
    const Vector by_xy = sum(times("accelerations_x", rates.x), times("accelerations_y", rates.y));
    const Vector of_accelerations = sum(by_xy, times("accelerations_u", rates.inputs));
    EXPECT_LT(relative_difference(driver.results<double>("dual", "accelerations"), of_accelerations), 1e-12) << seed;
    // the residual is linear in the inputs, as the accelerations are: ∂r/∂u = −A ∂ẏ/∂u with A = ∂r/∂ẏ
    Vector less_inputs = times("accelerations_u", rates.inputs);
    for (long double& entry : less_inputs) entry = -entry;
    const Vector of_residual = sum(sum(times("residual_x", rates.x), times("residual_y", rates.y)),
                                   times("residual_ydot", sum(rates.ydot, less_inputs)));
    EXPECT_LT(relative_difference(driver.results<double>("dual", "residual"), of_residual), 1e-12) << seed;
  }
}

}  // namespace
}  // namespace kanec::test
