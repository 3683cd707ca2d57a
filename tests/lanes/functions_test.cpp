// Every function of several scenes in lanes. Oracles: the same function one state at a time, which fuses other
// multiply-adds and has other sines, and the generic numeric path in long double.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "generator/read/read.hpp"
#include "tests/lanes/compiled.hpp"

namespace kanec::test {
namespace {

struct Case {
  const char* name;
  LaneChoice choice;
  std::vector<std::string> functions = {};
};

void PrintTo(const Case& c, std::ostream* stream) {
  *stream << c.name << " " << c.choice.scalar << " " << c.choice.lanes;
}

class Batch : public testing::TestWithParam<Case> {
 protected:
  scene::Scene read() const {
    return scene::read(std::string(KANEC_SOURCE_DIR "/models/") + GetParam().name + "/scene.toml");
  }
  const scene::Scene scene = read();
  const Generated generated = generate(scene, {GetParam().functions});
  const compile::Model scalar = compiled(generated, scene);
  const compile::Model lanes = compiled_in_lanes(generated, scene, GetParam().choice);
  Random random{7};

  std::vector<Sample> samples(int count) {
    std::vector<Sample> list;
    for (int j = 0; j < count; ++j) list.push_back(sample_of(scene, random));
    return list;
  }

  // Of a combined function one part after another.
  static std::vector<long double> generic(const Sample& sample, std::string function) {
    std::vector<long double> result;
    for (std::size_t at = 0; at != std::string::npos; function.erase(0, at == std::string::npos ? at : at + 5)) {
      at = function.find("_and_");
      const auto part = generic_result(sample, function.substr(0, at), arguments<long double>(sample));
      result.insert(result.end(), part.begin(), part.end());
    }
    return result;
  }

  // All functions for all samples: relative differences from both oracles, by the largest entry of a result.
  template <class Real>
  void expect_same(const std::vector<Sample>& list, std::int64_t stride, int threads, double bound) {
    BatchSolver<Real> batch(lanes.batch(), threads);
    Solver solver(scalar.abi());
    const SampleBatch<Real> data(list, batch.model(), stride);
    batch.set_parameters_each(data.count, data.parameters.data(), data.stride);
    for (const program::Function& function : generated.program.functions) {
      SCOPED_TRACE(function.name);
      const int number = *batch.find(function.name), n = batch.n_out(number);
      std::vector<Real> out(data.size(n), std::numeric_limits<Real>::quiet_NaN());
      batch.evaluate(number, data.states(), out.data());
      for (std::int64_t j = 0; j < data.count; ++j) {
        const Sample& sample = list[static_cast<std::size_t>(j)];
        std::vector<double> found;
        for (int i = 0; i < n; ++i) found.push_back(data.at(out, n, i, j));
        const std::vector<double> one = scalar_result(solver, function.name, sample);
        EXPECT_LT(relative_difference(found, as<long double>(one)), bound) << "state " << j << " of " << data.count;
        EXPECT_LT(relative_difference(found, generic(sample, function.name)), 4 * bound) << "state " << j;
      }
    }
  }
};

// 1e-12 of a result's largest entry: some thousand roundings, each of some 1e-16, amplified by the solution of a
// system.
TEST_P(Batch, equals_one_state_at_a_time_and_the_generic_path_whatever_count_and_layout) {
  const bool is_float = std::string(GetParam().choice.scalar) == "float";
  const int width = lanes.batch().lanes;
  EXPECT_EQ(static_cast<std::size_t>(lanes.batch().scalar_size), is_float ? sizeof(float) : sizeof(double));
  if (GetParam().choice.lanes > 0) {
    EXPECT_EQ(width, GetParam().choice.lanes);
  }
  const std::int64_t strides[] = {0, 64, width, 2 * width};
  for (int repetition = 0; repetition < 8; ++repetition) {
    const std::vector<Sample> list = samples(1 + random.below(37));
    const std::int64_t stride = strides[repetition % 4];
    if (is_float)
      expect_same<float>(list, stride, 1 + repetition % 2, 2e-3);
    else
      expect_same<double>(list, stride, 1 + repetition % 2, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Batch,
                         testing::Values(Case{"every_joint", {}}, Case{"six_body", {"double", 2}},
                                         Case{"bench_cr7", {"double", 4}},
                                         Case{"bench_s6b", {"double", 8}, {"accelerations", "residual", "energy"}},
                                         Case{"cart_pole", {"float", 0}},
                                         Case{"bench_cr7", {"float", 8}, {"kinematics+accelerations", "residual"}}));

}  // namespace
}  // namespace kanec::test
