// What a report tells of runs. Oracle: runs made by hand, of which the answer is seen; rotations of known angles.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/choice.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "runtime/study/report/integration_text.hpp"

namespace kanec::cli::test {
namespace {

using testing::HasSubstr;

IntegrationRun run(integrate::Method method, double tolerance, double seconds, double error) {
  integrate::Options options;
  options.method = method;
  options.relative_tolerance = options.absolute_tolerance = tolerance;
  IntegrationRun run = run_with(options);
  run.wall_seconds = seconds;
  run.worst_error = run.end_error = error;
  return run;
}

// Of another engine.
IntegrationRun foreign(double seconds, double error) {
  IntegrationRun run;
  run.method = "Engine 1.0, Euler";
  run.setting = "h 0.1 s";
  run.wall_seconds = seconds;
  run.worst_error = run.end_error = error;
  return run;
}

// Of these the second is slower than the third and no more accurate; the last one failed.
SceneRuns some_runs() {
  using integrate::Method;
  SceneRuns scene;
  scene.model = "arm";
  scene.path = "models/arm";
  scene.reference_error = 1e-12;
  scene.scales = {1.0, 1.0};
  scene.runs = {run(Method::arkode, 1e-4, 1e-3, 1e-5), run(Method::arkode, 1e-8, 3e-3, 1e-8),
                run(Method::cvode, 1e-9, 2e-3, 1e-9), run(Method::cvode, 1e-12, 4e-3, 1e-11),
                run(Method::cvode_bdf, 1e-9, 1e-4, 0.0)};
  scene.runs.back().failure = "it, \"stopped\"";
  mark_front(scene.runs, scene.reference_error);
  return scene;
}

TEST(Choice, the_front_has_what_no_other_run_equals_in_time_and_error) {
  std::vector<bool> front;
  for (const IntegrationRun& run : some_runs().runs) front.push_back(run.is_on_front);
  EXPECT_EQ(front, (std::vector<bool>{true, false, true, true, false}));
}

TEST(Choice, errors_below_the_reference_s_own_are_not_told_apart) {
  using integrate::Method;
  std::vector<IntegrationRun> runs = {run(Method::cvode, 1e-9, 2e-3, 1e-13), run(Method::cvode, 1e-9, 3e-3, 1e-15)};
  mark_front(runs, 1e-12);
  EXPECT_TRUE(runs[0].is_on_front);
  EXPECT_FALSE(runs[1].is_on_front);  // slower, and perhaps no better
}

TEST(Choice, is_the_fastest_run_within_the_wanted_error) {
  const SceneRuns scene = some_runs();
  EXPECT_EQ(fastest_within(scene, 1e-5), &scene.runs[0]);
  EXPECT_EQ(fastest_within(scene, 9e-6), &scene.runs[2]);
  EXPECT_EQ(fastest_within(scene, 1e-12), nullptr);
}

TEST(Choice, is_told_with_the_command_to_type_or_with_the_cause) {
  const SceneRuns scene = some_runs();
  EXPECT_EQ(recommendation(scene, 1e-6),
            "for an error of 1e-06: cvode, rtol 1e-09, in 2 ms (worst error 1.0e-09): kanec simulate models/arm "
            "--duration 10 --output-step 0.01 --integrator cvode --rtol 1e-09 --atol 1e-09");
  EXPECT_THAT(recommendation(scene, 5e-12), HasSubstr("none of these; the most accurate is cvode, rtol 1e-12"));
  EXPECT_THAT(recommendation(scene, 1e-13), HasSubstr("the reference is known to 1.0e-12"));
}

// The measured run took neither.
TEST(Choice, does_not_leave_order_and_jacobian_to_the_scene) {
  SceneRuns scene = some_runs();
  scene.settings.order = 5;
  scene.settings.jacobian = "differences";
  scene.runs = {run(integrate::Method::arkode_dirk, 1e-9, 2e-3, 1e-9)};
  EXPECT_THAT(recommendation(scene, 1e-6), HasSubstr("--integrator arkode_dirk --jacobian auto --order 0 --rtol"));
}

TEST(Choice, is_not_made_where_two_methods_differ_or_nothing_moves) {
  SceneRuns scene = some_runs();
  scene.is_disputed = true;
  scene.reference = "taylor_extended, rtol 1e-17", scene.check = "gauss6, h 0.1 s";
  scene.reference_error = scene.check_difference = 1.6;
  EXPECT_THAT(recommendation(scene, 1e-6), HasSubstr("nothing can be said"));
  EXPECT_THAT(reference_text(scene),
              HasSubstr("no reference to be trusted: taylor_extended, rtol 1e-17 and gauss6, h 0.1 s"));
  scene.scales = {};
  EXPECT_THAT(recommendation(scene, 1e-6), HasSubstr("nothing moves"));
}

TEST(Choice, is_never_another_engine_but_stands_beside_it) {
  SceneRuns scene = some_runs();
  EXPECT_THAT(integration_text(scene, {}), testing::Not(HasSubstr("times as long")));
  scene.runs.push_back(foreign(1e-6, 1e-9));
  EXPECT_EQ(fastest_within(scene, 1e-6), &scene.runs[2]);
  EXPECT_EQ(comparison(scene, 1e-6),
            "for an error of 1e-06 at the end: cvode, rtol 1e-09, 2 ms (1.0e-09); Engine 1.0, Euler, h 0.1 s, 1 µs "
            "(1.0e-09): 0.0005 times as long");
  EXPECT_EQ(comparison(scene, 1e-10), "for an error of 1e-10 at the end: no run of another engine");
  EXPECT_EQ(comparison(scene, 5e-12),
            "for an error of 5e-12 at the end: no run, neither of kanec nor of another engine");
  EXPECT_THAT(comparison(scene, 1e-13), HasSubstr("the reference is known to 1.0e-12"));
}

TEST(IntegrationText, shows_failures_with_their_cause) {
  const SceneRuns scene = some_runs();
  EXPECT_THAT(integration_text(scene, {}), HasSubstr("cvode_bdf, rtol 1e-09: failed after 100 µs: it, \"stopped\""));
  EXPECT_THAT(integration_csv({scene}), HasSubstr(",\"it, \"\"stopped\"\"\"\n"));
  EXPECT_EQ(integration_json(scene, {}).at("runs").at(4).at("failure"), "it, \"stopped\"");
  EXPECT_THAT(integration_markdown({scene}, {}, "kanec report"), HasSubstr("rtol 1e-09: it, \"stopped\""));
}

Bodies turned(long double angle) {
  BodyMotion body{};
  body.R_T.setIdentity();
  body.P.setZero(), body.p.setZero(), body.v.setZero(), body.omega.setZero();
  body.R_T(0, 0) = body.R_T(1, 1) = std::cos(angle);
  body.R_T(1, 0) = std::sin(angle), body.R_T(0, 1) = -body.R_T(1, 0);
  return {body};
}

TEST(MotionError, has_the_angle_of_the_error_rotation_in_full_however_small) {
  for (const double angle : {1e-17, 1e-12, 1e-6, 0.1, 1.0, 3.0, std::numbers::pi})
    EXPECT_NEAR(difference(turned(angle), turned(0)).attitude / angle, 1.0, 1e-7) << angle;  // cosines near π
  EXPECT_NEAR(difference(turned(1.0 + 1e-12L), turned(1.0)).attitude, 1e-12, 1e-18);         // roundings of long double
}

TEST(MotionError, is_relative_to_what_the_reference_does) {
  Bodies bodies = turned(0);
  bodies[0].p = {3, 0, 4};      // 5 m
  bodies[0].v = {0, 10, 0};     // 2 /s
  bodies[0].omega = {0, 0, 1};  // less
  const MotionScales scales = scales_of({bodies});
  EXPECT_EQ(scales.length, 5.0);
  EXPECT_EQ(scales.rate, 2.0);
  EXPECT_EQ(relative({0.5, 0, 0, 0}, scales), 0.1);
  EXPECT_EQ(relative({0, 0.5, 0, 0}, scales), 0.5);
  EXPECT_EQ(relative({0, 0, 0.5, 0}, scales), 0.05);
  EXPECT_EQ(relative({0, 0, 0, 0.5}, scales), 0.25);
  EXPECT_TRUE(std::isnan(relative({NAN, 0.5, 0, 0}, scales)));
}

}  // namespace
}  // namespace kanec::cli::test
