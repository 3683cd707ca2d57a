// Events within steps, and runs that go on where others ended. Oracle: an oscillation in closed form.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "runtime/base/error.hpp"
#include "runtime/trajectory/simulate.hpp"
#include "tests/integrate/oscillator.hpp"
#include "tests/integrate/tree_model.hpp"

namespace kanec::integrate::test {
namespace {

using std::numbers::pi;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const State start = {{1.0}, {0.0}};
const std::vector<Method> methods = {Method::rk4,       Method::lie4,   Method::gauss4,      Method::gauss6,
                                     Method::dop853,    Method::arkode, Method::arkode_dirk, Method::cvode,
                                     Method::cvode_bdf, Method::ida};

Options with(Method method) {
  Options options;
  options.method = method;
  options.duration = 4.0;
  options.output_step = 0.5;
  options.relative_tolerance = options.absolute_tolerance = 1e-10;
  for (const char* name : {"middle", "turn", "clock"}) options.events.emplace_back().name = name;
  return options;
}

Summary run(const Options& options, const Observer& observer = {}) {
  return simulate(Solver(oscillator()), start.x, start.y, options, observer);
}

// A local error of 1e-10 a step over at most 1,000 steps; of rk4 with 1 ms below.
constexpr double global_error = 1e-7;

TEST(Events, of_an_oscillation_are_where_its_closed_form_has_them) {
  for (const Method method : methods) {
    SCOPED_TRACE(name_of(method));
    const Summary summary = run(with(method));
    std::vector<double> expected = {0.5};
    for (int k = 1; k < 6; ++k) expected.push_back(k * pi / 4);  // the middle, a turn, the middle, ...
    std::sort(expected.begin(), expected.end());
    ASSERT_EQ(summary.events.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(summary.events[i].t, expected[i], global_error) << i;
    EXPECT_NEAR(summary.events[0].t, 0.5, 1e-15);  // the clock, to two roundings
    EXPECT_EQ(summary.events[0].event, 2);
    EXPECT_EQ(summary.events[1].event, 0);
    EXPECT_FALSE(summary.events[1].up);
    EXPECT_EQ(summary.events[2].event, 1);
    EXPECT_TRUE(summary.events[2].up);
    EXPECT_TRUE(summary.events[3].up);
    EXPECT_FALSE(summary.stopped);
  }
}

TEST(Events, of_one_direction_are_the_others_left_out) {
  Options options = with(Method::arkode);
  options.events[0].direction = Event::Direction::up;
  options.events[1].direction = Event::Direction::down;
  std::vector<double> times;
  for (const Happening& happening : run(options).events) times.push_back(happening.t);
  ASSERT_EQ(times.size(), 3u);
  EXPECT_NEAR(times[1], 3 * pi / 4, global_error);
  EXPECT_NEAR(times[2], pi, global_error);
}

// The third time in the middle is 5 pi / 4, in the middle of coarse steps; the next term of the error shifts the order
// by some percent.
TEST(Events, inside_a_step_are_as_exact_as_the_method) {
  const auto error = [](Method method, double step) {
    Options options = with(method);
    options.step = step;
    options.output_step = 4.0;
    options.events[1].direction = Event::Direction::down;
    return std::fabs(run(options).events.back().t - 5 * pi / 4);
  };
  for (const Method method : {Method::rk4, Method::lie4, Method::gauss4})
    EXPECT_NEAR(std::log2(error(method, 0.1) / error(method, 0.05)), 4.0, 0.4) << name_of(method);
  EXPECT_NEAR(std::log2(error(Method::gauss6, 0.2) / error(Method::gauss6, 0.1)), 6.0, 0.4);
}

// Looking inside steps takes evaluations, and leaves the steps as they are.
TEST(Events, that_only_record_do_not_move_the_run) {
  for (const Method method : methods) {
    Options quiet = with(method);
    quiet.events.clear();
    const Summary watched = run(with(method)), alone = run(quiet);
    EXPECT_EQ(watched.x, alone.x) << name_of(method);
    EXPECT_EQ(watched.steps, alone.steps) << name_of(method);
  }
}

TEST(Events, that_stop_end_the_run_with_a_row_there) {
  for (const Method method : methods) {
    Options options = with(method);
    options.events[1].stops = true;
    std::vector<double> times;
    const Summary summary = run(options, [&times](const Row& row) { times.push_back(row.t); });
    EXPECT_TRUE(summary.stopped);
    EXPECT_NEAR(summary.t, pi / 2, global_error) << name_of(method);
    EXPECT_THAT(times, ElementsAre(0.0, 0.5, 1.0, 1.5, summary.t));
    EXPECT_NEAR(summary.x[0], -1.0, global_error);
    EXPECT_NEAR(summary.y[0], 0.0, global_error);
  }
}

TEST(Events, have_rows_where_asked_for) {
  Options options = with(Method::cvode);
  options.duration = 1.0;
  options.events[0].has_row = true;
  options.events[2].has_row = true;  // where a row stands already, or two roundings beside it
  std::vector<double> times;
  run(options, [&times](const Row& row) { times.push_back(row.t); });
  ASSERT_GE(times.size(), 4u);
  EXPECT_NEAR(times[times.size() - 2], pi / 4, global_error);
}

// From t = 0.5 on u = 4: the same oscillation about s = 1. Its work is u times the way.
TEST(Events, that_set_inputs_change_the_motion_from_there_on) {
  const State middle = oscillation(start, 0.0, 0.5), end = oscillation(middle, 4.0, 3.5);
  for (const Method method : methods) {
    SCOPED_TRACE(name_of(method));
    Options options = with(method);
    options.events[2].settings = {{0, 4.0}};
    options.output_step = 0.8;
    std::vector<double> inputs;
    const Summary summary = run(options, [&inputs](const Row& row) { inputs.push_back(row.inputs[0]); });
    EXPECT_LT(largest_difference({summary.x, summary.y}, end), global_error);
    EXPECT_NEAR(summary.energy->work, 4.0 * (end.x[0] - middle.x[0]), 4 * global_error);
    EXPECT_LT(summary.energy->worst.value, 4 * global_error);
    EXPECT_THAT(inputs, ElementsAre(0.0, 4.0, 4.0, 4.0, 4.0, 4.0));
    EXPECT_THAT(summary.inputs, ElementsAre(4.0));
  }
}

TEST(Events, of_a_model_without_them_are_refused) {
  Options options = with(Method::rk4);
  const State state = precession(0.0);
  EXPECT_THAT([&] { simulate(Solver(single_body()), state.x, state.y, options); },
              ThrowsMessage<InputError>(HasSubstr("no function 'events' of 3 events")));
}

TEST(RowTimes, go_on_from_a_start) {
  const RowTimes times(2.0, 0.5, 0.75);
  ASSERT_EQ(times.size(), 4);
  EXPECT_EQ(times[0], 0.75);
  EXPECT_EQ(times[1], 1.0);
  EXPECT_EQ(times[3], 2.0);
  EXPECT_EQ(RowTimes(2.0, 0.5, 2.0).size(), 1);
  EXPECT_EQ(RowTimes(2.0, 0.5, 1.0).size(), 3);
}

// Steps of the fixed ones begin anew at every row.
TEST(Resumed, run_is_the_rest_of_the_whole_one) {
  for (const Method method : methods) {
    SCOPED_TRACE(name_of(method));
    Options options = with(method);
    options.events[2].settings = {{0, 4.0}};
    const Summary whole = run(options);
    options.duration = 2.0;
    const Summary first = run(options);
    Solver solver(oscillator());
    solver.set_inputs(first.inputs);
    options.start = 2.0;
    options.duration = 4.0;
    options.work = first.energy->work;
    const Summary second = simulate(solver, first.x, first.y, options);
    EXPECT_EQ(second.rows, 5);
    EXPECT_LT(largest_difference({second.x, second.y}, {whole.x, whole.y}), global_error);
    EXPECT_NEAR(second.energy->work + first.energy->work, whole.energy->work, 4 * global_error);
    EXPECT_LT(second.energy->worst.value, 4 * global_error);
    if (method == Method::rk4) {
      EXPECT_EQ(second.x, whole.x);
    }
  }
}

}  // namespace
}  // namespace kanec::integrate::test
