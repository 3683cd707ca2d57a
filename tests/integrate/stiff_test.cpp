// Implicit methods on a stiff chain. Oracle: its modes in closed form.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/base/error.hpp"
#include "runtime/trajectory/simulate.hpp"
#include "tests/integrate/stiff_chain.hpp"

namespace kanec::integrate::test {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Options with(Method method, JacobianChoice jacobian, double tolerance = 1e-7) {
  Options options;
  options.method = method;
  options.jacobian = jacobian;
  options.relative_tolerance = tolerance;
  options.absolute_tolerance = tolerance;
  options.duration = 0.2;  // of the fastest mode, 80,000 time constants of its fast decay
  options.output_step = 0.2;
  return options;
}

Summary run(const Options& options, Derivatives derivatives = Derivatives::all) {
  const State start = chain_motion(0.0);
  return simulate(Solver(stiff_chain(derivatives)), start.x, start.y, options);
}

double error_of(const Summary& summary) { return largest_difference({summary.x, summary.y}, chain_motion(0.2)); }

// Speeds are near 100 m/s: the tolerance, some hundred steps. An explicit method needs steps of 1e-5 s.
TEST(Stiff, chain_follows_its_modes_in_few_steps) {
  for (const Method method : {Method::cvode_bdf, Method::arkode_dirk, Method::ida})
    for (const JacobianChoice jacobian : {JacobianChoice::dense, JacobianChoice::sparse, JacobianChoice::differences}) {
      const Summary summary = run(with(method, jacobian));
      EXPECT_LT(error_of(summary), 1e-3) << name_of(method) << " " << name_of(jacobian);
      EXPECT_LT(summary.steps, 1500) << name_of(method) << " " << name_of(jacobian);
    }
}

// Both factorise the same matrix; roundings differ, and with them now and then a step.
TEST(Stiff, dense_and_sparse_factors_make_the_same_run) {
  for (const Method method : {Method::cvode_bdf, Method::arkode_dirk, Method::ida}) {
    const Summary dense = run(with(method, JacobianChoice::dense)), sparse = run(with(method, JacobianChoice::sparse));
    EXPECT_NEAR(double(dense.steps), double(sparse.steps), 0.05 * double(dense.steps)) << name_of(method);
    EXPECT_LT(largest_difference({dense.x, dense.y}, {sparse.x, sparse.y}), 1e-3) << name_of(method);
  }
}

// Differences cost an evaluation a column, 100 of them; emitted derivatives none.
TEST(Stiff, emitted_derivatives_save_the_evaluations_of_differences) {
  for (const Method method : {Method::cvode_bdf, Method::arkode_dirk, Method::ida}) {
    const Summary emitted = run(with(method, JacobianChoice::automatic));
    const Summary quotients = run(with(method, JacobianChoice::differences));
    EXPECT_GT(emitted.jacobians, 0) << name_of(method);
    EXPECT_EQ(quotients.jacobians, 0) << name_of(method);
    // as many Jacobians in both; rounding moves steps, and with them some
    const double columns = 2.0 * chain_masses * static_cast<double>(emitted.jacobians);
    EXPECT_GT(double(quotients.evaluations - emitted.evaluations), 0.7 * columns) << name_of(method);
  }
}

TEST(Stiff, models_without_derivatives_take_differences_unless_told_otherwise) {
  const Summary summary = run(with(Method::cvode_bdf, JacobianChoice::automatic), Derivatives::none);
  EXPECT_EQ(summary.jacobians, 0);
  EXPECT_LT(error_of(summary), 1e-3);
  EXPECT_THAT([&] { run(with(Method::cvode_bdf, JacobianChoice::sparse), Derivatives::none); },
              ThrowsMessage<InputError>(HasSubstr("'kinematics_x+kinematics_y+accelerations_x+accelerations_y'")));
}

// Local errors of the tolerance beside speeds near 100 m/s, some hundred steps. Steps are as few as they are because a
// Newton iterate is taken before the next one proves it: one by an old matrix would leave an error that does not fall.
TEST(Stiff, error_falls_with_the_tolerance) {
  for (const Method method : {Method::cvode_bdf, Method::arkode_dirk, Method::ida})
    for (const double tolerance : {1e-5, 1e-7, 1e-9})
      EXPECT_LT(error_of(run(with(method, JacobianChoice::sparse, tolerance))), 1e3 * tolerance)
          << name_of(method) << " " << tolerance;
  for (const int order : {3, 4, 5})
    for (const double tolerance : {1e-5, 1e-7, 1e-9}) {
      Options options = with(Method::arkode_dirk, JacobianChoice::sparse, tolerance);
      options.order = order;
      EXPECT_LT(error_of(run(options)), 10 * tolerance) << order << " " << tolerance;
    }
}

}  // namespace
}  // namespace kanec::integrate::test
