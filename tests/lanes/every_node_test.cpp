// Every kind of node in lanes, choices between values and parameters that only prepare() sees among them. Oracle: the
// program evaluated operation by operation.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/emit/every_node.hpp"

#include <gtest/gtest.h>

#include "tests/lanes/compiled.hpp"

namespace kanec::test {
namespace {

class EveryNodeInLanes : public testing::TestWithParam<LaneChoice> {
 protected:
  const Sample sample = every_node_sample();
  const Generated generated = every_node_model(sample.scene);
  const compile::Model lanes = compiled_in_lanes(generated, sample.scene, GetParam());

  // The sample with other parameters, inputs, times and coordinates, between which choices fall either way.
  std::vector<Sample> samples() const {
    std::vector<Sample> list;
    Random random(3);
    for (int j = 0; j < 21; ++j) {
      list.push_back(sample);
      Sample& s = list.back();
      for (auto* values : {&s.parameters, &s.inputs, &s.state.x, &s.state.y})
        for (double& value : *values) value = random.uniform(-1, 1);
      s.t = random.uniform(0, 1);
    }
    return list;
  }

  template <class Real>
  void expect_program(double bound) {
    BatchSolver<Real> batch(lanes.batch());
    const std::vector<Sample> list = samples();
    const SampleBatch<Real> data(list, batch.model(), 0);
    batch.set_parameters_each(data.count, data.parameters.data());
    for (const program::Function& function : generated.program.functions) {
      const int number = *batch.find(function.name), n = batch.n_out(number);
      std::vector<Real> out(data.size(n));
      batch.evaluate(number, data.states(), out.data());
      for (std::int64_t j = 0; j < data.count; ++j) {
        const Sample& s = list[static_cast<std::size_t>(j)];
        const program::Arguments<long double> at{as<long double>(s.parameters), as<long double>(s.state.x),
                                                 as<long double>(s.state.y),    as<long double>(s.state.ydot),
                                                 as<long double>(s.inputs),     s.t};
        const auto wanted = evaluate(generated.program, function, at);
        for (int i = 0; i < n; ++i) {
          const auto right = static_cast<double>(wanted[static_cast<std::size_t>(i)]);
          EXPECT_NEAR(data.at(out, n, i, j), right, bound * (1 + std::abs(right))) << function.name << " " << i;
        }
      }
    }
  }
};

// Arguments lie between 0.1 and 0.9, where no function amplifies an error by more than some ten.
TEST_P(EveryNodeInLanes, gives_the_values_of_the_program) {
  if (std::string(GetParam().scalar) == "float")
    expect_program<float>(1e-4);
  else
    expect_program<double>(1e-13);
}

INSTANTIATE_TEST_SUITE_P(Widths, EveryNodeInLanes,
                         testing::Values(LaneChoice{}, LaneChoice{"double", 2}, LaneChoice{"float", 0}));

}  // namespace
}  // namespace kanec::test
