// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>

#include "generator/read/check.hpp"
#include "tests/scene/snippets.hpp"

namespace kanec::scene {
namespace {

using testing::HasSubstr;

std::string simulate(const std::string& lines) { return with_table("[simulate]\n" + lines); }

TEST(Simulate, takes_its_defaults) {
  const Simulation simulation = parse(with_table(""), "f").simulation;
  EXPECT_EQ(simulation.duration, 10.0);
  EXPECT_EQ(simulation.output_step, 0.01);
  EXPECT_EQ(simulation.integrator, "dop853");
  EXPECT_EQ(simulation.step, 0.001);
  EXPECT_EQ(simulation.relative_tolerance, 1e-9);
  EXPECT_EQ(simulation.absolute_tolerance, 1e-12);
}

TEST(Simulate, reads_every_key) {
  const Simulation simulation = parse(simulate("duration = 5\noutput_step = 0.5\nintegrator = 'rk4'\nstep = 0.1\n"
                                               "relative_tolerance = 1e-3\nabsolute_tolerance = 1e-4"),
                                      "f")
                                    .simulation;
  EXPECT_EQ(simulation.duration, 5.0);
  EXPECT_EQ(simulation.output_step, 0.5);
  EXPECT_EQ(simulation.integrator, "rk4");
  EXPECT_EQ(simulation.step, 0.1);
  EXPECT_EQ(simulation.relative_tolerance, 1e-3);
  EXPECT_EQ(simulation.absolute_tolerance, 1e-4);
}

TEST(Simulate, refuses_zero_and_negative_settings) {
  for (const std::string key : {"duration", "output_step", "step", "relative_tolerance", "absolute_tolerance"}) {
    EXPECT_EQ(message(simulate(key + " = 0")), "f:7: simulate." + key + ": found 0; allowed: a positive finite number");
    EXPECT_EQ(message(simulate(key + " = -0.5")),
              "f:7: simulate." + key + ": found -0.5; allowed: a positive finite number");
  }
}

TEST(Simulate, refuses_names_for_numbers) {
  EXPECT_EQ(message(simulate("duration = 'm'\n[parameters]\nm = 1")),
            "f:7: simulate.duration: found the text \"m\"; allowed: a positive number");
}

TEST(Simulate, refuses_more_than_1e8_rows) {
  EXPECT_EQ(message(simulate("duration = 1\noutput_step = 1e-8")), "no error");
  EXPECT_EQ(
      message(simulate("duration = 1\noutput_step = 5e-9")),
      "f:8: simulate.output_step: found 5e-09, which makes 2e+08 rows; allowed: at most 1e+08 rows in the duration, 1");
  EXPECT_EQ(
      message(simulate("duration = 1e7")),
      "f:6: simulate.output_step (default): found 0.01, which makes 1e+09 rows; allowed: at most 1e+08 rows in the "
      "duration, 1e+07");
}

TEST(Simulate, refuses_more_than_1e12_steps) {
  EXPECT_THAT(message(simulate("step = 1e-12")), HasSubstr("f:7: simulate.step: found 1e-12, which makes 1e+13 steps"));
}

TEST(Simulate, allows_rows_only_at_the_beginning_and_the_end) {
  EXPECT_EQ(message(simulate("duration = 0.001")), "no error");
}

TEST(Simulate, refuses_tolerances_out_of_reach) {
  EXPECT_EQ(message(simulate("relative_tolerance = 1e-15")), "no error");
  EXPECT_EQ(message(simulate("relative_tolerance = 9e-16")),
            "f:7: simulate.relative_tolerance: found 9e-16; allowed: from 1e-15 to below 1");
  EXPECT_EQ(message(simulate("relative_tolerance = 1")),
            "f:7: simulate.relative_tolerance: found 1; allowed: from 1e-15 to below 1");
  EXPECT_EQ(message(simulate("absolute_tolerance = 1.0")),
            "f:7: simulate.absolute_tolerance: found 1; allowed: a positive number below 1");
}

TEST(Simulate, refuses_an_unknown_integrator_with_the_nearest) {
  EXPECT_EQ(message(simulate("integrator = 'arcode'")),
            "f:7: simulate.integrator: found \"arcode\"; allowed: rk4, lie4, gauss4, gauss6, dop853, arkode, "
            "arkode_dirk, cvode, "
            "cvode_bdf, ida, taylor, taylor_extended (did you mean arkode?)");
  EXPECT_EQ(
      message(simulate("integrator = 4")),
      "f:7: simulate.integrator: found 4; allowed: rk4, lie4, gauss4, gauss6, dop853, arkode, arkode_dirk, cvode, "
      "cvode_bdf, ida, taylor, taylor_extended");
}

TEST(Simulate, knows_its_integrators) {
  for (const std::string& name : simulation_integrators())
    EXPECT_EQ(parse(simulate("integrator = '" + name + "'"), "f").simulation.integrator, name);
}

TEST(Simulate, refuses_an_order_that_the_integrator_does_not_have) {
  EXPECT_EQ(message(simulate("order = 6\nintegrator = 'arkode'")), "no error");
  EXPECT_EQ(message(simulate("order = 7\nintegrator = 'arkode'")),
            "f:7: simulate.order: found 7; allowed: 4, 5, 6, 8, or 0");
  EXPECT_EQ(message(simulate("order = 6\nintegrator = 'arkode_dirk'")),
            "f:7: simulate.order: found 6; allowed: 2, 3, 4, 5, or 0");
  EXPECT_EQ(message(simulate("order = 7")), "no error");  // not looked at
}

TEST(Simulate, refuses_an_unknown_jacobian) {
  EXPECT_EQ(parse(simulate("jacobian = 'sparse'"), "f").simulation.jacobian, "sparse");
  EXPECT_EQ(
      message(simulate("jacobian = 'spars'")),
      "f:7: simulate.jacobian: found \"spars\"; allowed: auto, dense, sparse, differences (did you mean sparse?)");
}

}  // namespace
}  // namespace kanec::scene
