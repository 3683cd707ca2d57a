// The methods against closed forms (oracle: textbook motion of the single body) and against conservation laws.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/base/error.hpp"
#include "runtime/trajectory/simulate.hpp"
#include "tests/integrate/closed_form.hpp"
#include "tests/integrate/tree_model.hpp"

namespace kanec::integrate::test {
namespace {

using ::testing::AllOf;
using ::testing::AnyOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

Options with(Method method, double tolerance) {
  Options options;
  options.method = method;
  options.relative_tolerance = tolerance;
  options.absolute_tolerance = 0.1 * tolerance;
  return options;
}

Summary run(const kanec_model& model, const Options& options, const Observer& observer = {}) {
  const State start = precession(0.0);
  return simulate(Solver(model), start.x, start.y, options, observer);
}

double rk4_error(double step) {
  Options options;
  options.method = Method::rk4;
  options.step = step;
  options.output_step = 1.0;
  const Summary summary = run(single_body(), options);
  return largest_difference({summary.x, summary.y}, precession(options.duration));
}

// Largest error of any row against the closed form.
double worst_error(const Options& options) {
  double worst = 0.0;
  run(single_body(), options, [&worst](const Row& row) {
    const State state = {{row.x.begin(), row.x.end()}, {row.y.begin(), row.y.end()}};
    worst = std::max(worst, largest_difference(state, precession(row.t)));
  });
  return worst;
}

TEST(Rk4, converges_with_order_four) {
  const double coarse = rk4_error(0.05), fine = rk4_error(0.025), finer = rk4_error(0.0125);
  EXPECT_LT(coarse, 1e-5);
  // 2^order; the next term of the error expansion shifts it by a few percent at these steps
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.1);
  EXPECT_NEAR(std::log2(fine / finer), 4.0, 0.1);
}

double gauss_error(Method method, double step) {
  Options options;
  options.method = method;
  options.step = step;
  options.output_step = 1.0;
  const Summary summary = run(single_body(), options);
  return largest_difference({summary.x, summary.y}, precession(options.duration));
}

TEST(Gauss, converges_with_order_four_or_six) {
  const double coarse = gauss_error(Method::gauss4, 0.1), fine = gauss_error(Method::gauss4, 0.05);
  EXPECT_LT(coarse, 1e-4);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.1);  // the next term of the error expansion is of order 6
  const double coarse_6 = gauss_error(Method::gauss6, 0.2), fine_6 = gauss_error(Method::gauss6, 0.1);
  EXPECT_LT(coarse_6, 1e-5);
  EXPECT_NEAR(std::log2(coarse_6 / fine_6), 6.0, 0.1);
}

// 10,000 coarse steps without projection. The norm is a quadratic invariant, which only rounding of 1e-16 a step moves,
// and that is compensated.
TEST(Gauss, keeps_the_norm_of_euler_parameters_without_projection) {
  for (const Method method : {Method::gauss4, Method::gauss6}) {
    Options options;
    options.method = method;
    options.step = 0.1;
    options.output_step = 1.0;
    options.duration = 1000.0;
    EXPECT_LT(run(single_body(), options).worst_norm_error_before, 2e-14);
  }
}

double lie_error(double step) {
  Options options;
  options.method = Method::lie4;
  options.step = step;
  options.output_step = 1.0;
  const Summary summary = run(single_body(), options);
  return largest_difference({summary.x, summary.y}, precession(options.duration));
}

TEST(Lie, converges_with_order_four) {
  const double coarse = lie_error(0.05), fine = lie_error(0.025);
  EXPECT_LT(coarse, 1e-5);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.1);  // the next term of the error expansion, as of rk4
}

// 10,000 steps of 0.1 s, a quarter of a radian each. Rounding of 1e-16 a step is compensated.
TEST(Lie, keeps_the_norm_of_euler_parameters_without_projection) {
  Options options;
  options.method = Method::lie4;
  options.step = 0.1;
  options.output_step = 1.0;
  options.duration = 1000.0;
  EXPECT_LT(run(single_body(), options).worst_norm_error_before, 2e-14);
}

TEST(Gauss, says_when_the_stages_do_not_converge) {
  Options options;
  options.method = Method::gauss6;
  options.step = options.output_step = 1000.0;
  options.duration = 2000.0;
  EXPECT_THAT([&] { run(single_body(), options); },
              ThrowsMessage<IntegrationError>(HasSubstr("stages of a step of 1000 s do not converge, least of all ")));
}

TEST(Rk4, takes_equal_steps_no_longer_than_asked_for) {
  Options options;
  options.method = Method::rk4;
  options.duration = 1.0;
  options.output_step = 0.1;
  options.step = 0.03;  // four steps of 0.025 in each row interval
  const Summary summary = run(single_body(), options);
  EXPECT_EQ(summary.steps, 40);
  EXPECT_EQ(summary.evaluations, 160);
  EXPECT_EQ(summary.failed, 0);
}

// Local errors of the size of the tolerance add up over the steps of 10 s: a Runge-Kutta pair stays near the tolerance
// itself, since its error estimate is that of the lower order; a multistep method has no such reserve and takes tens to
// hundreds of steps, whose errors add up.
TEST(Arkode, keeps_the_tolerance_in_every_row) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    for (const double output_step : {0.01, 2.5}) {
      Options options = with(Method::arkode, tolerance);
      options.output_step = output_step;
      EXPECT_LT(worst_error(options), 5.0 * tolerance) << tolerance << " " << output_step;
    }
}

// The error is controlled by an estimate of order 5, far above that of the result.
TEST(Dop853, keeps_the_tolerance_in_every_row) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    for (const double output_step : {0.01, 2.5}) {
      Options options = with(Method::dop853, tolerance);
      options.output_step = output_step;
      EXPECT_LT(worst_error(options), tolerance) << tolerance << " " << output_step;
    }
}

// Rows are values of a polynomial, and no steps end at them.
TEST(Dop853, takes_the_same_steps_for_any_rows) {
  Options fine = with(Method::dop853, 1e-9), coarse = fine;
  fine.output_step = 1e-3;
  coarse.output_step = 10.0;
  const Summary a = run(single_body(), fine), b = run(single_body(), coarse);
  EXPECT_EQ(a.steps, b.steps);
  EXPECT_EQ(a.x, b.x);
  EXPECT_EQ(a.y, b.y);
}

TEST(Dop853, evaluates_twelve_times_a_step_and_three_more_for_rows) {
  Options options = with(Method::dop853, 1e-9);
  options.output_step = 10.0;
  const Summary coarse = run(single_body(), options);
  EXPECT_EQ(coarse.evaluations, 2 + 12 * coarse.steps + 11 * coarse.failed);
  options.output_step = 1e-3;
  EXPECT_EQ(run(single_body(), options).evaluations, coarse.evaluations + 3 * coarse.steps);
}

TEST(Arkode, keeps_the_tolerance_with_every_order) {
  for (const int order : {4, 5, 6, 8}) {
    Options options = with(Method::arkode, 1e-9);
    options.order = order;
    options.output_step = 10.0;
    EXPECT_LT(worst_error(options), 5e-9) << order;
  }
}

TEST(Arkode, takes_fewer_steps_with_a_higher_order) {
  std::int64_t before = std::numeric_limits<std::int64_t>::max();
  for (const int order : {4, 5, 6, 8}) {
    Options options = with(Method::arkode, 1e-10);
    options.order = order;
    options.output_step = 10.0;
    const std::int64_t steps = run(single_body(), options).steps;
    EXPECT_LT(steps, before) << order;
    before = steps;
  }
}

TEST(Arkode, chooses_its_order_from_the_tolerance) {
  EXPECT_EQ(arkode_order(with(Method::arkode, 1e-4)), 5);
  EXPECT_EQ(arkode_order(with(Method::arkode, 1e-6)), 8);
}

TEST(Cvode, keeps_the_tolerance_in_every_row) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10, 1e-12})
    for (const double output_step : {0.01, 2.5}) {
      Options options = with(Method::cvode, tolerance);
      options.output_step = output_step;
      EXPECT_LT(worst_error(options), 100.0 * tolerance) << tolerance << " " << output_step;
    }
}

TEST(CvodeBdf, keeps_the_tolerance_in_every_row) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8, 1e-10}) {
    Options options = with(Method::cvode_bdf, tolerance);
    options.output_step = 0.1;
    EXPECT_LT(worst_error(options), 500.0 * tolerance) << tolerance;
  }
}

TEST(CvodeBdf, crosses_a_stiff_decay_in_few_steps) {
  Options options = with(Method::cvode_bdf, 1e-6);
  options.duration = 2.0;
  const Summary summary = run(single_body(Fault::stiff), options);
  const State start = precession(0.0);
  EXPECT_NEAR(summary.x[4], start.x[4] + start.y[3] / 1e5, 1e-6);  // the tolerance
  EXPECT_LT(summary.steps, 1000);                                  // an explicit method needs 2 s × 1e5 / 3 or so
}

// Of steps whose last terms reach the tolerance, some ten.
TEST(Taylor, keeps_the_tolerance_in_every_row) {
  for (const double tolerance : {1e-4, 1e-8, 1e-12}) {
    Options options = with(Method::taylor, tolerance);
    options.output_step = 0.1;
    EXPECT_LT(worst_error(options), 10.0 * tolerance) << tolerance;
  }
}

TEST(Ida, keeps_the_tolerance_in_every_row) {
  for (const double tolerance : {1e-4, 1e-6, 1e-8}) {
    Options options = with(Method::ida, tolerance);
    options.output_step = 0.1;
    EXPECT_LT(worst_error(options), 500.0 * tolerance) << tolerance;
  }
}

TEST(Cvode, starts_anew_when_the_norm_has_drifted) {
  Options options = with(Method::cvode, 1e-6);
  options.duration = 1000.0;
  options.output_step = 1.0;
  const Summary summary = run(single_body(), options);
  EXPECT_GT(summary.restarts, 0);
  EXPECT_LT(summary.restarts * 100, summary.steps);        // rare: a start costs some twenty steps
  EXPECT_LT(summary.worst_norm_error_before, 2 * 100e-6);  // the limit, and one step beyond it
  EXPECT_GT(summary.worst_norm_error_before, 1e-6);
  EXPECT_LT(summary.worst_norm_error_after, 5e-16);  // two roundings
}

TEST(Methods, report_the_drift_of_the_norm_and_remove_it) {
  for (const Method method : {Method::rk4, Method::dop853, Method::arkode, Method::cvode, Method::cvode_bdf}) {
    Options options = with(method, 1e-5);
    options.step = 0.1;
    options.output_step = 0.5;
    const Summary summary = run(single_body(), options);
    EXPECT_GT(summary.worst_norm_error_before, 1e-9) << name_of(method);
    EXPECT_LT(summary.worst_norm_error_before, 1e-3) << name_of(method);
    EXPECT_LT(summary.worst_norm_error_after, 5e-16) << name_of(method);  // two roundings
  }
}

Summary six_body_run(const Options& options) {
  return simulate(Solver(six_bodies()), six_body_coordinates(), six_body_speeds(), options);
}

void expect_conserved(const Summary& summary, double tolerance) {
  EXPECT_LT(summary.energy->worst.relative(), tolerance);
  EXPECT_LT(summary.linear_momentum->worst.relative(), tolerance);
  EXPECT_LT(summary.angular_momentum->worst.relative(), tolerance);
}

// 1e-11 is what the project promises; arkode keeps a hundredth of it here.
TEST(SixBodies, keep_energy_and_momentum_at_the_tightest_tolerance) {
  expect_conserved(six_body_run(with(Method::arkode, 1e-13)), 1e-11);
  expect_conserved(six_body_run(with(Method::dop853, 1e-13)), 1e-12);
  expect_conserved(six_body_run(with(Method::cvode, 1e-14)), 1e-11);
}

TEST(SixBodies, come_out_the_same_by_all_methods) {
  const Summary expected = six_body_run(with(Method::arkode, 1e-13));
  Options fixed = with(Method::rk4, 1e-9);
  fixed.step = 1e-3;
  Options on_group = fixed;
  on_group.method = Method::lie4;
  for (const Options& options : {fixed, on_group, with(Method::dop853, 1e-11), with(Method::cvode, 1e-11),
                                 with(Method::cvode_bdf, 1e-11), with(Method::arkode_dirk, 1e-9)}) {
    const Summary summary = six_body_run(options);
    // the loosest is rk4: its error at this step, measured by halving it, is 1e-8
    EXPECT_LT(largest_difference({summary.x, summary.y}, {expected.x, expected.y}), 1e-7) << name_of(options.method);
  }
}

Summary faulty_run(Method method) {
  const Solver solver(six_bodies(Fault::not_finite));
  return simulate(solver, six_body_coordinates(), six_body_speeds(), with(method, 1e-8));
}

TEST(NotFinite, rate_stops_a_run_with_time_body_and_speed) {
  for (const Method method : {Method::rk4, Method::lie4, Method::dop853, Method::arkode, Method::arkode_dirk,
                              Method::cvode, Method::cvode_bdf, Method::ida})
    EXPECT_THAT([&] { faulty_run(method); },
                ThrowsMessage<IntegrationError>(
                    HasSubstr("integration stopped at t = 0.5 s: the rate of omega_3_2 is not finite")))
        << name_of(method);
}

// At the first stage beyond 0.5 s, a part of 1 ms after it.
TEST(NotFinite, rate_stops_collocation_at_a_stage) {
  for (const Method method : {Method::gauss4, Method::gauss6})
    EXPECT_THAT([&] { faulty_run(method); },
                ThrowsMessage<IntegrationError>(
                    AllOf(HasSubstr("t = 0.500"), HasSubstr("the rate of omega_3_2 is not finite"))))
        << name_of(method);
}

// Steps are halved until none is left: the motion until then is known.
TEST(NotFinite, rate_is_where_taylor_steps_end) {
  const State start = precession(0.0);
  const Solver solver(single_body(Fault::not_finite));
  EXPECT_THAT([&] { simulate(solver, start.x, start.y, with(Method::taylor, 1e-8)); },
              ThrowsMessage<IntegrationError>(
                  AllOf(AnyOf(HasSubstr("t = 0.5 s"), HasSubstr("t = 0.49999")), HasSubstr("the rate of omega_1_2 "))));
}

// d(sdot_1_1)/dt = sdot_1_1², infinite at t = 1 s.
Summary run_over_the_end(Method method) {
  State start = precession(0.0);
  start.y[3] = 1.0;
  return simulate(Solver(single_body(Fault::blow_up)), start.x, start.y, with(method, 1e-8));
}

TEST(Methods, stop_where_the_solution_ends) {
  for (const Method method : {Method::dop853, Method::arkode, Method::arkode_dirk, Method::cvode, Method::cvode_bdf,
                              Method::ida, Method::taylor}) {
    const char* cause = method == Method::taylor || method == Method::dop853
                            ? "the rate of sdot_1_1 changes so fast that no step is short enough"
                            : ": the step size has collapsed";
    EXPECT_THAT([&] { run_over_the_end(method); },
                ThrowsMessage<IntegrationError>(
                    AllOf(AnyOf(HasSubstr("t = 1.0000"), HasSubstr("t = 0.9999")), HasSubstr(cause))))
        << name_of(method);
  }
}

// Steps of 1 ms: in the last one before the end the stages run away.
TEST(Methods, of_collocation_stop_in_the_step_where_the_solution_ends) {
  for (const Method method : {Method::gauss4, Method::gauss6})
    EXPECT_THAT([&] { run_over_the_end(method); },
                ThrowsMessage<IntegrationError>(AllOf(HasSubstr("t = 0.99"), HasSubstr("the stages of a step of 0.001"),
                                                      HasSubstr("do not converge"))))
        << name_of(method);
}

TEST(Methods, pass_on_what_the_library_says) {
  for (const Method method : {Method::arkode, Method::cvode, Method::cvode_bdf})
    EXPECT_THAT([&] { run(single_body(), with(method, 1e-17)); },
                ThrowsMessage<IntegrationError>(HasSubstr("too much accuracy requested")));
}

TEST(Methods, stop_at_the_step_limit) {
  for (const std::string& name : method_names()) {
    if (name == "taylor_extended") continue;  // as taylor, of a model with series in long double
    Options options = with(method_of(name), 1e-8);
    options.max_steps = 7;
    EXPECT_THAT([&] { run(single_body(), options); },
                ThrowsMessage<IntegrationError>(HasSubstr("the limit of 7 steps is reached")))
        << name;
  }
}

}  // namespace
}  // namespace kanec::integrate::test
