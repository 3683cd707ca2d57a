// What a batch refuses, and what it leaves alone. Oracles: a single state, marks around the results.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"
#include "tests/lanes/compiled.hpp"

namespace kanec::test {
namespace {

class BatchLayout : public testing::Test {
 protected:
  const scene::Scene scene = scene::read(KANEC_SOURCE_DIR "/models/cart_pole/scene.toml");
  const Generated generated = generate(scene, {{"accelerations", "energy"}});
  const compile::Model lanes = compiled_in_lanes(generated, scene, {"double", 4});
  BatchSolver<double> solver{lanes.batch(), 3};
  const int accelerations = *solver.find("accelerations");

  std::vector<Sample> samples(int count) const {
    Random random(5);
    std::vector<Sample> list;
    for (int j = 0; j < count; ++j) list.push_back(sample_of(scene, random));
    return list;
  }
};

TEST_F(BatchLayout, results_are_the_same_to_the_bit_in_every_layout_and_with_every_number_of_threads) {
  const std::vector<Sample> list = samples(1100);
  const SampleBatch<double> first(list, solver.model(), 0);
  std::vector<double> wanted(first.size(2));
  solver.evaluate(accelerations, first.states(), wanted.data());
  for (const std::int64_t stride : {1, 4, 8, 1500}) {
    for (const int threads : {1, 2, 5}) {
      BatchSolver<double> other(lanes.batch(), threads);
      const SampleBatch<double> data(list, solver.model(), stride);
      std::vector<double> out(data.size(2));
      other.evaluate(accelerations, data.states(), out.data());
      for (std::int64_t j = 0; j < data.count; ++j)
        for (int i = 0; i < 2; ++i) ASSERT_EQ(data.at(out, 2, i, j), first.at(wanted, 2, i, j));
    }
  }
}

TEST_F(BatchLayout, a_state_does_not_depend_on_its_neighbours) {
  const std::vector<Sample> list = samples(11);
  const SampleBatch<double> all(list, solver.model(), 0);
  std::vector<double> together(all.size(2));
  solver.evaluate(accelerations, all.states(), together.data());
  for (std::int64_t j = 0; j < all.count; ++j) {
    const SampleBatch<double> one({list[static_cast<std::size_t>(j)]}, solver.model(), 0);
    std::vector<double> alone(2);
    solver.evaluate(accelerations, one.states(), alone.data());
    for (int i = 0; i < 2; ++i) EXPECT_EQ(one.at(alone, 2, i, 0), all.at(together, 2, i, j));
  }
}

TEST_F(BatchLayout, nothing_is_written_beyond_the_last_state) {
  const SampleBatch<double> data(samples(6), solver.model(), 10);
  std::vector<double> out(data.size(2), 77.0);
  solver.evaluate(accelerations, data.states(), out.data());
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NE(out[10 * i + 5], 77.0);
    for (std::size_t j = 6; j < 10; ++j) EXPECT_EQ(out[10 * i + j], 77.0);
  }
}

TEST_F(BatchLayout, inputs_and_parameters_for_all_states_are_those_that_were_set) {
  const std::vector<Sample> list = samples(5);
  const SampleBatch<double> data(list, solver.model(), 0);
  BatchStates<double> states = data.states();
  states.u = nullptr;
  const std::vector<double> push = {3.0};
  solver.set_inputs(push);
  std::vector<double> found(data.size(2)), wanted(data.size(2));
  solver.evaluate(accelerations, states, found.data());
  const std::vector<double> each(5, 3.0);
  states.u = each.data();
  solver.evaluate(accelerations, states, wanted.data());
  EXPECT_EQ(found, wanted);
}

TEST_F(BatchLayout, an_empty_batch_is_none) {
  EXPECT_NO_THROW(solver.evaluate(accelerations, BatchStates<double>{}, nullptr));
}

TEST_F(BatchLayout, refuses_other_strides_scalars_and_counts) {
  BatchStates<double> states;
  states.count = 10;
  states.stride = 6;
  EXPECT_THROW(solver.evaluate(accelerations, states, nullptr), InputError);
  states.stride = -4;
  EXPECT_THROW(solver.evaluate(accelerations, states, nullptr), InputError);
  EXPECT_THROW(BatchSolver<float>(lanes.batch()), LoadError);
  EXPECT_THROW(solver.set_inputs(std::vector<double>(3)), InputError);
  EXPECT_THROW(solver.set_parameters(std::vector<double>(3)), InputError);
  EXPECT_THROW(solver.set_parameters_each(0, nullptr), InputError);
  EXPECT_FALSE(solver.find("forcing").has_value());
}

}  // namespace
}  // namespace kanec::test
