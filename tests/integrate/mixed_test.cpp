// A model of different joints, dependent on time, against its motion in closed form.
// SPDX-License-Identifier: BSD-3-Clause
#include <gtest/gtest.h>

#include "runtime/trajectory/simulate.hpp"
#include "tests/integrate/mixed_model.hpp"

namespace kanec::integrate::test {
namespace {

Options with(Method method) {
  Options options;
  options.method = method;
  options.duration = 5.0;
  options.output_step = 0.25;
  return options;
}

Summary run(Calls calls, const Options& options) {
  const State start = mixed_motion(0.0);
  return simulate(Solver(mixed_model(calls)), start.x, start.y, options);
}

TEST(Mixed, joints_follow_their_closed_forms_in_every_method) {
  for (const Method method : {Method::rk4, Method::lie4, Method::dop853, Method::arkode, Method::arkode_dirk,
                              Method::cvode, Method::cvode_bdf}) {
    const Summary summary = run(Calls::separate, with(method));
    // thousands of BDF steps of 1e-9 each; the others stay below 1e-7
    const double bound = method == Method::cvode_bdf ? 1e-5 : 1e-7;
    EXPECT_LT(largest_difference({summary.x, summary.y}, mixed_motion(5.0)), bound) << name_of(method);
    EXPECT_NEAR(summary.energy->work, mixed_work(5.0), bound) << name_of(method);
    EXPECT_LT(summary.energy->worst.relative(), bound) << name_of(method);
    // a rounding of four squares
    EXPECT_LE(summary.worst_norm_error_after, 1e-15) << name_of(method);
    EXPECT_GT(summary.worst_norm_error_before, 0.0) << name_of(method);
  }
}

TEST(Mixed, combined_functions_give_the_same_run) {
  const Summary separate = run(Calls::separate, with(Method::arkode));
  for (const Calls calls : {Calls::two_in_one, Calls::three_in_one}) {
    const Summary combined = run(calls, with(Method::arkode));
    EXPECT_EQ(combined.x, separate.x);
    EXPECT_EQ(combined.y, separate.y);
    EXPECT_EQ(combined.energy->work, separate.energy->work);
    EXPECT_EQ(combined.evaluations, separate.evaluations);
  }
}

TEST(Mixed, angles_are_not_normalised) {
  State start = mixed_motion(0.0);
  start.x[0] = 7.0;
  const Summary summary = simulate(Solver(mixed_model(Calls::separate)), start.x, start.y, with(Method::rk4));
  // as any other start, to the error of rk4
  EXPECT_NEAR(summary.x[0], mixed_motion(5.0).x[0] + 6.8, 1e-9);
}

TEST(Motionless, models_can_be_run) {
  for (const Method method : {Method::rk4, Method::lie4, Method::dop853, Method::arkode, Method::arkode_dirk,
                              Method::cvode, Method::cvode_bdf}) {
    const Summary summary = simulate(Solver(motionless_model()), {}, {}, with(method));
    EXPECT_EQ(summary.rows, 21) << name_of(method);
    EXPECT_TRUE(summary.x.empty());
    EXPECT_EQ(summary.worst_norm_error_after, 0.0);
  }
}

}  // namespace
}  // namespace kanec::integrate::test
