// Taylor series of emitted code. Oracle: the rates' program evaluated on whole truncated power series, by which each
// coefficient follows from those before.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <new>

#include "generator/emit/taylor.hpp"
#include "generator/pipeline.hpp"
#include "generator/program/combined.hpp"
#include "tests/emit/every_node.hpp"
#include "tests/lower/sample.hpp"
#include "tests/support/compiled.hpp"
#include "tests/support/power_series.hpp"

namespace kanec::test {
namespace {

constexpr int order = 12;
using Number = PowerSeries<long double, order>;
using Coefficients = std::vector<std::vector<long double>>;  // k, entry of z

// Each pass finds one coefficient more.
Coefficients expected(const program::Program& program, const Sample& sample) {
  const program::Function& rates = *emit::rates(program);
  const program::Arguments<long double> at = arguments<long double>(sample);
  const auto constants = [](const std::vector<long double>& values) {
    return std::vector<Number>(values.begin(), values.end());
  };
  program::Arguments<Number> moving{constants(at.parameters), constants(at.x), constants(at.y), {},
                                    constants(at.inputs),     Number(at.time)};
  moving.time.c[1] = 1;
  const std::size_t nx = moving.x.size(), size = rates.outputs.size();
  std::vector<long double> start = at.x;
  start.insert(start.end(), at.y.begin(), at.y.end());
  start.resize(size, 0);
  Coefficients all = {start};
  for (std::size_t k = 0; k < order; ++k) {
    const std::vector<Number> zdot = evaluate(program, rates, moving);
    all.emplace_back();
    for (std::size_t i = 0; i < size; ++i) {
      const long double next = zdot[i].c[k] / static_cast<long double>(k + 1);
      all.back().push_back(next);
      if (i < nx) moving.x[i].c[k + 1] = next;
      if (i >= nx && i < nx + moving.y.size()) moving.y[i - nx].c[k + 1] = next;
    }
  }
  return all;
}

template <class Real>
Coefficients found(const kanec_taylor& series, const kanec_model& model, const Sample& sample,
                   const Coefficients& start) {
  EXPECT_EQ(series.scalar_size, static_cast<std::int32_t>(sizeof(Real)));
  const auto named = [](const std::vector<scene::Named>& all, const std::vector<double>& values,
                        const char* const* names) {
    std::vector<double> result;
    for (; *names != nullptr; ++names)
      for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].name == *names) result.push_back(values[i]);
    return result;
  };
  const auto alignment = std::align_val_t{std::max<std::size_t>(series.alignment, 64)};
  const auto release = [&](void* memory) { ::operator delete(memory, alignment); };
  const std::unique_ptr<void, decltype(release)> prepared(::operator new(series.prepared_size, alignment), release),
      work(::operator new(series.work_size, alignment), release);
  series.prepare(named(sample.scene.parameters, sample.parameters, model.parameter_names).data(), prepared.get());
  const auto size = static_cast<std::size_t>(series.size);
  std::vector<Real> z(start[0].begin(), start[0].end());
  z.resize(size * (order + 1));
  series.coefficients(prepared.get(), sample.t, named(sample.scene.inputs, sample.inputs, model.input_names).data(),
                      order, z.data(), work.get());
  Coefficients result;
  for (std::size_t k = 0; k <= order; ++k)
    result.emplace_back(z.begin() + static_cast<std::ptrdiff_t>(k * size),
                        z.begin() + static_cast<std::ptrdiff_t>((k + 1) * size));
  return result;
}

// Coefficient k against the largest of its order, which may be reached by cancellation of terms larger than it.
void expect_near(const Coefficients& found, const Coefficients& right, double bound) {
  ASSERT_EQ(found.size(), right.size());
  for (std::size_t k = 0; k < found.size(); ++k)
    EXPECT_LT(relative_difference(found[k], right[k], 1e-3L), bound) << "coefficient " << k;
}

void expect_series(const Generated& generated, const Sample& sample, double digits) {
  const compile::Model model = compiled(generated, sample.scene);
  const kanec_model& abi = model.abi();
  ASSERT_EQ(abi.n_taylor, 2);
  const Coefficients right = expected(generated.program, sample);
  expect_near(found<double>(abi.taylor[0], abi, sample, right), right, digits * 2e-16);
  expect_near(found<long double>(abi.taylor[1], abi, sample, right), right, digits * 1e-19);
}

class RandomTrees : public testing::TestWithParam<int> {};

// Sixteen trees of every joint, with springs, expressions, prescribed coordinates, parameters and inputs.
TEST_P(RandomTrees, move_along_the_series_of_their_rates) {
  Random random(static_cast<std::uint64_t>(7000 + GetParam()));
  scene::Scene scene = random_scene(random, 1 + GetParam() % 5, everything());
  scene.name = "tree";
  const Sample sample = sample_of(scene, random);
  if (n_speeds(scene) == 0) GTEST_SKIP() << "everything is prescribed";
  const Generated generated = generate(scene, {.functions = all_rates(scene), .with_taylor = true});
  expect_series(generated, sample, 2e4);
}

INSTANTIATE_TEST_SUITE_P(Taylor, RandomTrees, testing::Range(0, 16));

// All functions that expressions may have, of arguments that move: outputs are sums of several kinds of node.
TEST(TaylorSeries, of_every_kind_of_node_are_those_of_its_definition) {
  const Sample sample = every_node_sample();
  expect_series(every_node_motion(sample.scene), sample, 2e4);
}

TEST(TaylorSeries, are_left_out_where_no_function_gives_all_rates) {
  Random random(3);
  const scene::Scene scene = random_scene(random, 2);
  EXPECT_EQ(generate(scene, {.functions = {"accelerations"}, .with_taylor = true}).taylor, "");
}

}  // namespace
}  // namespace kanec::test
