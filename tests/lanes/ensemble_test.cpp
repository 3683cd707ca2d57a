// Ensembles in lanes and in threads. Oracle: simulate(), one scenario at a time.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/trajectory/batch_ensemble.hpp"
#include "runtime/trajectory/simulate.hpp"
#include "tests/lanes/compiled.hpp"

namespace kanec::test {
namespace {

using testing::HasSubstr;

class Ensemble : public testing::TestWithParam<const char*> {
 protected:
  const scene::Scene scene = scene::read(std::string(KANEC_SOURCE_DIR "/models/") + GetParam() + "/scene.toml");
  const Generated generated = generate(scene, {functions()});
  const compile::Model scalar = compiled(generated, scene);
  const compile::Model lanes = compiled_in_lanes(generated, scene, {"double", 4});
  EnsembleOptions options = {fixed_steps(), 1};

  static integrate::Options fixed_steps() {
    integrate::Options run;
    run.method = integrate::Method::rk4;
    run.duration = 0.3;
    run.output_step = 0.1;
    run.step = 0.01;
    return run;
  }

  std::vector<std::string> functions() const {
    const bool has_loads = std::string(GetParam()) != "free_body";
    return {has_loads ? "kinematics+accelerations+power" : "kinematics+accelerations", "energy"};
  }

  std::vector<Scenario> scenarios(int count) const {
    Random random(11);
    std::vector<Scenario> list;
    for (int j = 0; j < count; ++j) {
      const Sample sample = sample_of(scene, random);
      list.push_back(
          {sample.state.x, sample.state.y, read_parameters(sample, scalar.abi()), read_inputs(sample, scalar.abi())});
    }
    return list;
  }

  std::vector<KeptRow> rows_alone(const Scenario& scenario) const {
    Solver solver(scalar.abi());
    solver.set_parameters(scenario.parameters);
    solver.set_inputs(scenario.inputs);
    std::vector<KeptRow> rows;
    simulate(solver, scenario.x, scenario.y, options.run, [&](const Row& row) {
      rows.push_back({row.t, {row.x.begin(), row.x.end()}, {row.y.begin(), row.y.end()}, row.energy, row.work});
    });
    return rows;
  }

  static std::vector<double> flat(const KeptRow& row) {
    std::vector<double> all = {row.t, row.work, row.energy->kinetic, row.energy->potential};
    all.insert(all.end(), row.x.begin(), row.x.end());
    all.insert(all.end(), row.y.begin(), row.y.end());
    return all;
  }
};

INSTANTIATE_TEST_SUITE_P(Scenes, Ensemble, testing::Values("cart_pole", "six_body", "free_body"));

// 120 evaluations, each right to some 1e-15, on motions that do not diverge in 0.3 s: 1e-11 of the largest number.
TEST_P(Ensemble, in_lanes_goes_as_each_scenario_alone) {
  const std::vector<Scenario> list = scenarios(7);
  BatchSolver<double> solver(lanes.batch(), 2);
  const std::vector<Outcome> found = run_in_lanes(solver, list, options);
  ASSERT_EQ(found.size(), list.size());
  for (std::size_t j = 0; j < list.size(); ++j) {
    EXPECT_EQ(found[j].stopped, "");
    EXPECT_EQ(found[j].steps, 30);
    EXPECT_EQ(found[j].evaluations, 120);
    EXPECT_LT(found[j].worst_norm_error, 1e-5);
    const auto rows = rows_alone(list[j]);
    ASSERT_EQ(found[j].rows.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i)
      EXPECT_LT(relative_difference(flat(found[j].rows[i]), as<long double>(flat(rows[i]))), 1e-11);
  }
}

TEST_P(Ensemble, is_the_same_to_the_bit_whatever_the_threads_and_the_neighbours) {
  const std::vector<Scenario> list = scenarios(21);
  options.keep_every = 0;
  BatchSolver<double> one(lanes.batch(), 1), three(lanes.batch(), 3);
  const std::vector<Outcome> a = run_in_lanes(one, list, options), b = run_in_lanes(three, list, options);
  const std::vector<Outcome> some = run_in_lanes(three, std::span(list).subspan(5, 3), options);
  for (std::size_t j = 0; j < list.size(); ++j) EXPECT_EQ(flat(a[j].end()), flat(b[j].end()));
  for (std::size_t j = 0; j < some.size(); ++j) EXPECT_EQ(flat(some[j].end()), flat(a[j + 5].end()));
}

TEST_P(Ensemble, one_by_one_is_simulate_by_any_method) {
  const std::vector<Scenario> list = scenarios(5);
  options.run.method = integrate::Method::arkode;
  Workers workers(3);
  const std::vector<Outcome> found = run_one_by_one(scalar.abi(), workers, list, options);
  for (std::size_t j = 0; j < list.size(); ++j) {
    const auto rows = rows_alone(list[j]);
    ASSERT_EQ(found[j].rows.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(flat(found[j].rows[i]), flat(rows[i]));
  }
}

// A speed whose square is infinite: that scenario stops, the ones beside it do not notice.
TEST_P(Ensemble, a_scenario_that_stops_leaves_the_others_alone) {
  std::vector<Scenario> list = scenarios(6);
  BatchSolver<double> solver(lanes.batch());
  const std::vector<Outcome> quiet = run_in_lanes(solver, list, options);
  list[2].y[0] = 1e300;
  for (const bool in_lanes : {true, false}) {
    Workers workers(2);
    const std::vector<Outcome> found =
        in_lanes ? run_in_lanes(solver, list, options) : run_one_by_one(scalar.abi(), workers, list, options);
    EXPECT_THAT(found[2].stopped, HasSubstr("integration stopped"));
    EXPECT_THAT(found[2].stopped, HasSubstr("not finite"));
    EXPECT_EQ(found[2].end().t, 0.0);
    // but for Euler parameters, which are projected at the start
    EXPECT_LT(relative_difference(found[2].end().x, as<long double>(list[2].x)), 1e-15);
    if (!in_lanes) continue;
    for (const std::size_t j : {0u, 1u, 3u, 4u, 5u}) EXPECT_EQ(flat(found[j].end()), flat(quiet[j].end()));
  }
}

TEST_P(Ensemble, refuses_a_state_that_is_none) {
  std::vector<Scenario> list = scenarios(2);
  list[1].x[0] = NAN;
  BatchSolver<double> solver(lanes.batch());
  EXPECT_THROW(run_in_lanes(solver, list, options), InputError);
  list[1].x.clear();
  EXPECT_THROW(run_in_lanes(solver, list, options), InputError);
}

}  // namespace
}  // namespace kanec::test
