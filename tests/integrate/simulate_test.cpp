// Rows, summary, options and refusals of a run; numbers against closed forms.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/trajectory/simulate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "runtime/base/error.hpp"
#include "tests/integrate/closed_form.hpp"
#include "tests/integrate/tree_model.hpp"

namespace kanec::integrate::test {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::vector<Method> all_methods = {Method::rk4,    Method::gauss4, Method::gauss6,
                                         Method::arkode, Method::cvode,  Method::cvode_bdf};

TEST(RowTimes, are_multiples_of_the_step_and_the_duration) {
  const RowTimes even(1.0, 0.1);
  ASSERT_EQ(even.size(), 11);
  EXPECT_EQ(even[3], 3 * 0.1);
  EXPECT_EQ(even[10], 1.0);
  const RowTimes uneven(1.0, 0.4);
  ASSERT_EQ(uneven.size(), 4);
  EXPECT_EQ(uneven[2], 0.8);
  EXPECT_EQ(uneven[3], 1.0);
  EXPECT_EQ(RowTimes(0.0, 0.1).size(), 1);
  EXPECT_EQ(RowTimes(0.05, 0.1).size(), 2);
  EXPECT_EQ(RowTimes(1e-9, 1.0).size(), 2);
}

TEST(Simulate, gives_every_row_once_at_its_time) {
  const State start = precession(0.0);
  for (const Method method : all_methods) {
    Options options;
    options.method = method;
    options.duration = 1.0;
    options.output_step = 0.3;
    std::vector<double> times;
    const Summary summary = simulate(Solver(single_body()), start.x, start.y, options,
                                     [&times](const Row& row) { times.push_back(row.t); });
    EXPECT_THAT(times, ElementsAre(0.0, 0.3, 2 * 0.3, 3 * 0.3, 1.0)) << name_of(method);
    EXPECT_EQ(summary.rows, 5);
  }
}

TEST(Simulate, begins_with_the_initial_state_and_ends_with_the_last_row) {
  const State start = precession(0.0);
  std::vector<double> first, last;
  const Summary summary = simulate(Solver(single_body()), start.x, start.y, {}, [&](const Row& row) {
    last.assign(row.x.begin(), row.x.end());
    if (row.t == 0.0) first = last;
  });
  EXPECT_EQ(first, start.x);
  EXPECT_EQ(last, summary.x);
  EXPECT_GT(summary.wall_seconds, 0.0);
}

TEST(Simulate, of_no_duration_is_one_row) {
  const State start = precession(0.0);
  for (const Method method : all_methods) {
    Options options;
    options.method = method;
    options.duration = 0.0;
    const Summary summary = simulate(Solver(single_body()), start.x, start.y, options, {}, [](double) { FAIL(); });
    EXPECT_EQ(summary.rows, 1);
    EXPECT_EQ(summary.steps, 0);
    EXPECT_EQ(summary.y, start.y);
    EXPECT_EQ(summary.energy->worst.relative(), 0.0);
  }
}

TEST(Simulate, tells_its_progress_from_zero_to_one) {
  const State start = precession(0.0);
  for (const Method method : all_methods) {
    Options options;
    options.method = method;
    double before = 0.0;
    simulate(Solver(single_body()), start.x, start.y, options, {}, [&before](double fraction) {
      EXPECT_GT(fraction, before);
      before = fraction;
    });
    EXPECT_EQ(before, 1.0) << name_of(method);
  }
}

// A force along e and a moment about the third axis, from rest in rotation: ω_3 = M t / I_3, s = s0 + v t + F t²/(2 m).
// The work is F·(s - s0) + ½ I_3 ω_3², which is the change of kinetic energy.
TEST(Work, of_constant_loads_is_that_of_the_closed_form) {
  constexpr double m = 2.0, I3 = 1.5, T = 3.0, M = 0.4;
  const std::vector<double> loads = {1.0, -2.0, 0.5, 0.0, 0.0, M};
  const std::vector<double> x = {0, 0, 0, 1, 0, 0, 0}, y = {0, 0, 0, 0.3, 0.1, -0.2};
  double work = 0.5 * M * M * T * T / I3;
  for (std::size_t i = 0; i < 3; ++i) work += loads[i] * (y[3 + i] * T + loads[i] * T * T / (2 * m));
  Solver solver(single_body());
  solver.set_inputs(loads);
  for (const Method method : all_methods) {
    Options options;
    options.method = method;
    options.duration = T;
    const Summary summary = simulate(solver, x, y, options);
    // the tolerance is 1e-9 a step, that of rk4 smaller; hundreds of steps and sums of order 10
    EXPECT_NEAR(summary.energy->work, work, 2e-6) << name_of(method);
    EXPECT_NEAR(summary.energy->change(), work, 2e-6);
    EXPECT_NEAR(summary.y[2], M * T / I3, 1e-6);
    EXPECT_NEAR(summary.x[2], std::sin(M * T * T / I3 / 4), 1e-6);
    EXPECT_LT(summary.energy->worst.relative(), 1e-7);
    EXPECT_GT(summary.energy->worst.scale, work);
  }
}

TEST(Work, of_loads_on_six_bodies_is_their_energy_change) {
  Solver solver(six_bodies());
  solver.set_parameters(std::vector<double>{0.5, 1.0, -9.81});
  std::vector<double> loads(36);
  for (std::size_t i = 0; i < loads.size(); ++i) loads[i] = std::sin(static_cast<double>(7 * i));
  solver.set_inputs(loads);
  Options options;
  options.relative_tolerance = 1e-12;
  options.absolute_tolerance = 1e-13;
  const Summary summary = simulate(solver, six_body_coordinates(), six_body_speeds(), options);
  EXPECT_GT(std::fabs(summary.energy->work), 1.0);
  EXPECT_GT(std::fabs(summary.energy->end.potential - summary.energy->start.potential), 100.0);
  EXPECT_LT(summary.energy->worst.relative(), 1e-11);  // ten times the tolerance
}

TEST(Momentum, changes_under_gravity_by_its_impulse) {
  Solver solver(single_body());
  solver.set_parameters(std::vector<double>{0.0, 0.0, -9.81});
  const State start = precession(0.0);
  const Summary summary = simulate(solver, start.x, start.y, {});
  const MomentumChange linear = *summary.linear_momentum;
  const double impulse = 2.0 * 9.81 * 10.0;                      // m g T
  EXPECT_NEAR(linear.end[2] - linear.start[2], -impulse, 1e-7);  // 1e-9 relative, the tolerance
  EXPECT_NEAR(linear.at_end.value, impulse, 1e-7);
  EXPECT_EQ(linear.worst.value, linear.at_end.value);
  EXPECT_NEAR(linear.worst.relative(), 1.0, 0.02);  // the velocity at the start is a hundredth
  EXPECT_LT(summary.energy->worst.relative(), 1e-9);
}

TEST(Summary, holds_the_worst_deviations_of_all_rows) {
  Options options;
  options.method = Method::rk4;
  options.step = 0.1;  // coarse: the deviation is to be seen
  double worst = 0.0, start = 0.0;
  const Summary summary =
      simulate(Solver(six_bodies()), six_body_coordinates(), six_body_speeds(), options, [&](const Row& row) {
        if (row.t == 0.0) start = row.energy->total();
        worst = std::max(worst, std::fabs(row.energy->total() - start - row.work));
      });
  EXPECT_GT(worst, 1e-12);
  EXPECT_EQ(summary.energy->worst.value, worst);
  EXPECT_GE(worst, std::fabs(summary.energy->at_end.value));
  EXPECT_GE(summary.angular_momentum->worst.value, summary.angular_momentum->at_end.value);
  EXPECT_EQ(summary.energy->start.total(), start);
}

TEST(Summary, marks_what_the_model_cannot_tell_as_absent) {
  const State start = precession(0.0);
  const Summary summary = simulate(Solver(bare_body()), start.x, start.y, {}, [](const Row& row) {
    EXPECT_FALSE(row.energy.has_value());
    EXPECT_EQ(row.work, 0.0);
  });
  EXPECT_FALSE(summary.energy.has_value());
  EXPECT_FALSE(summary.linear_momentum.has_value());
  EXPECT_FALSE(summary.angular_momentum.has_value());
}

template <class Change>
void expect_refused(Change change, const std::string& message) {
  Options options;
  change(options);
  const State start = precession(0.0);
  EXPECT_THAT([&] { simulate(Solver(single_body()), start.x, start.y, options); },
              ThrowsMessage<InputError>(HasSubstr(message)));
}

TEST(Options, out_of_range_are_refused) {
  expect_refused([](Options& o) { o.step = 0.0; }, "step: found 0; allowed: a positive number");
  expect_refused([](Options& o) { o.step = -1e-3; }, "step: found -0.001; allowed: a positive number");
  expect_refused([](Options& o) { o.step = 1e-20; }, "step: found 1e-20; allowed: at least 1e-14 of the duration");
  expect_refused([](Options& o) { o.duration = -1.0; }, "duration: found -1; allowed: zero or a positive number");
  expect_refused([](Options& o) { o.duration = std::nan(""); }, "duration: found nan");
  expect_refused([](Options& o) { o.output_step = 0.0; }, "output step: found 0; allowed: a positive number");
  expect_refused([](Options& o) { o.output_step = std::numeric_limits<double>::infinity(); }, "output step: found inf");
  expect_refused([](Options& o) { o.relative_tolerance = 0.0; },
                 "relative tolerance: found 0; allowed: a number between");
  expect_refused([](Options& o) { o.absolute_tolerance = 1.0; },
                 "absolute tolerance: found 1; allowed: a number between");
  expect_refused([](Options& o) { o.order = 7, o.method = Method::arkode; }, "order: found 7; allowed: 0, 4, 5, 6, 8");
  expect_refused([](Options& o) { o.order = 6, o.method = Method::arkode_dirk; },
                 "order: found 6; allowed: 0, 2, 3, 4, 5");
  expect_refused([](Options& o) { o.max_steps = 0; }, "max steps: found 0; allowed: at least 1");
}

TEST(Options, have_an_order_for_arkode_alone) {
  for (const std::string& name : method_names()) {
    if (name.rfind("arkode", 0) == 0) continue;
    Options options;
    options.method = method_of(name);
    for (const int order : {3, 7}) {
      options.order = order;
      EXPECT_NO_THROW(check(options)) << name;
    }
  }
}

TEST(Options, name_their_methods) {
  for (const Method method : all_methods) EXPECT_EQ(method_of(name_of(method)), method);
  EXPECT_THAT(
      [] { method_of("euler"); },
      ThrowsMessage<InputError>("integrator: found 'euler'; allowed: rk4, lie4, gauss4, gauss6, dop853, arkode, "
                                "arkode_dirk, cvode, cvode_bdf, ida, taylor, taylor_extended"));
}

TEST(InitialState, that_cannot_be_used_is_refused) {
  const Solver solver(six_bodies());
  const std::vector<double> x = six_body_coordinates(), y = six_body_speeds();
  const auto refused = [&solver](const std::vector<double>& x0, const std::vector<double>& y0,
                                 const std::string& text) {
    EXPECT_THAT([&] { simulate(solver, x0, y0, {}); }, ThrowsMessage<InputError>(HasSubstr(text)));
  };
  refused({1.0}, y, "initial coordinates: found 1 numbers; allowed: 42");
  refused(x, {}, "initial speeds: found 0 numbers; allowed: 36");
  std::vector<double> bad = x;
  bad[24 + 4] = std::numeric_limits<double>::infinity();
  refused(bad, y, "initial state: s_2_2: found inf; allowed: a finite number");
  bad = y;
  bad[35] = std::nan("");
  refused(x, bad, "initial state: sdot_6_3: found nan");
  bad = x;
  for (std::size_t i = 4; i < 8; ++i) bad[i] = 0.0;
  refused(bad, y, "initial state: eps_2_1 to _4: Euler parameters are 1 from unit norm; allowed: at most 1e-6");
}

TEST(Model, without_accelerations_is_refused) {
  const State start = precession(0.0);
  EXPECT_THAT([&] { simulate(Solver(body_without_accelerations()), start.x, start.y, {}); },
              ThrowsMessage<InputError>(HasSubstr("has no function 'accelerations'")));
}

}  // namespace
}  // namespace kanec::integrate::test
