// The functions by name in flat layouts. Oracle: the layouts written down in runtime/abi/solver.hpp, entry by entry.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/generic/evaluate.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "runtime/base/error.hpp"
#include "tests/generic/sample.hpp"

namespace kanec::generic {
namespace {

using testing::ElementsAre;
using testing::ThrowsMessage;

// A scene of every kind, in a state.
struct Case {
  Sample s = samples(test::everything())[8];
  System<Real> system = s.system<Real>();

  Arguments<Real> arguments() const { return {s.t, span(s.x), span(s.y), span(s.ydot), span(s.u)}; }
  std::vector<Real> operator()(std::string_view function) const { return evaluate(system, function, arguments()); }
  static std::span<const Real> span(const Vector& a) { return {a.data(), static_cast<std::size_t>(a.size())}; }
};

TEST(Evaluate, knows_the_usual_functions_of_a_solver) {
  EXPECT_THAT(function_names(),
              ElementsAre("kinematics", "mass_matrix", "forcing", "residual", "accelerations", "partial_velocities",
                          "partial_velocity_rates", "energy", "momentum", "poses", "power"));
}

TEST(Evaluate, knows_the_functions_that_a_scene_can_have) {
  test::Random random(3);
  scene::Scene scene = test::random_scene(random, 2, {.gravity = false, .loads = false});
  scene.points = {{"tip", 2, {}}};
  const std::vector<std::string> plain = function_names(scene);
  EXPECT_THAT(
      plain, testing::IsSupersetOf({"energy", "reactions", "partial_angular_velocities", "tip_position", "tip_velocity",
                                    "tip_acceleration", "tip_jacobian", "residual_xi", "state_matrix"}));
  for (const char* name : {"power", "power_x", "load_powers", "driving_loads", "accelerations_u", "input_matrix"}) {
    EXPECT_THAT(plain, testing::Not(testing::Contains(name)));
    EXPECT_THAT(function_names(Case().s.scene), testing::Contains(name));
  }
}

// N bodies, nx coordinates, ny speeds, nu inputs.
TEST(Evaluate, gives_each_function_its_size) {
  const Case c;
  const std::size_t n = c.s.scene.bodies.size(), nx = c.arguments().x.size(), ny = c.arguments().y.size(),
                    nu = c.arguments().u.size();
  const std::vector<std::pair<const char*, std::size_t>> sizes = {{"kinematics", nx},
                                                                  {"forcing", ny},
                                                                  {"residual", ny},
                                                                  {"accelerations", ny},
                                                                  {"mass_matrix", ny * ny},
                                                                  {"partial_velocities", 3 * n * ny},
                                                                  {"partial_velocity_rates", 3 * n * ny},
                                                                  {"partial_angular_velocities", 3 * n * ny},
                                                                  {"partial_angular_velocity_rates", 3 * n * ny},
                                                                  {"energy", 2},
                                                                  {"momentum", 6},
                                                                  {"poses", 12 * n},
                                                                  {"power", 1},
                                                                  {"reactions", 6 * n},
                                                                  {"point_1_position", 3},
                                                                  {"point_1_velocity", 3},
                                                                  {"point_1_acceleration", 3},
                                                                  {"point_1_jacobian", 3 * ny},
                                                                  {"residual_x", ny * nx},
                                                                  {"residual_y", ny * ny},
                                                                  {"residual_ydot", ny * ny},
                                                                  {"residual_xi", ny * ny},
                                                                  {"accelerations_x", ny * nx},
                                                                  {"accelerations_y", ny * ny},
                                                                  {"accelerations_u", ny * nu},
                                                                  {"accelerations_xi", ny * ny},
                                                                  {"kinematics_x", nx * nx},
                                                                  {"kinematics_y", nx * ny},
                                                                  {"power_x", nx},
                                                                  {"power_y", ny},
                                                                  {"state_matrix", 4 * ny * ny},
                                                                  {"input_matrix", 2 * ny * nu}};
  for (const auto& [function, size] : sizes) EXPECT_EQ(c(function).size(), size) << function;
}

// The acceleration is affine in ẏ with the Jacobian as its matrix.
TEST(Evaluate, gives_matrices_row_by_row) {
  const Case c;
  const Eigen::Index ny = c.s.y.size();
  const Vector without = c.s.with(&Sample::ydot, Vector::Zero(ny))("point_1_acceleration");
  const std::vector<Real> jacobian = c("point_1_jacobian");
  for (Eigen::Index j = 0; j < ny; ++j) {
    const Vector column = c.s.with(&Sample::ydot, Vector::Unit(ny, j))("point_1_acceleration") - without;
    for (Eigen::Index i = 0; i < 3; ++i)
      EXPECT_NEAR(double(jacobian[static_cast<std::size_t>(i * ny + j)] - column[i]), 0,
                  1e-15);  // accelerations up to 1e3
  }
}

TEST(Evaluate, needs_only_the_arguments_that_the_function_reads) {
  const Case c;
  EXPECT_EQ(evaluate(c.system, "mass_matrix", {.t = c.s.t, .x = c.arguments().x}), c("mass_matrix"));
  EXPECT_EQ(evaluate(c.system, "energy", {.t = c.s.t, .x = c.arguments().x, .y = c.arguments().y}), c("energy"));
}

TEST(Evaluate, does_not_read_other_arguments) {
  const Case c;
  Arguments<Real> arguments = c.arguments();
  arguments.ydot = arguments.u = {};
  arguments.y = arguments.y.first(1);
  EXPECT_EQ(evaluate(c.system, "partial_velocities", arguments), c("partial_velocities"));
}

TEST(Evaluate, gives_double_and_long_double_the_same_to_the_rounding_of_double) {
  const Case c;
  const auto narrow = [](const Vector& a) { return std::vector<double>(a.begin(), a.end()); };
  const std::vector<double> x = narrow(c.s.x), y = narrow(c.s.y), ydot = narrow(c.s.ydot), u = narrow(c.s.u);
  const System<double> system(c.s.scene, c.s.parameters);
  for (const std::string& name : function_names(c.s.scene)) {
    const std::vector<Real> wide = c(name);
    const auto found = evaluate(system, name, {double(c.s.t), x, y, ydot, u});
    double largest = 0, difference = 0;
    for (std::size_t i = 0; i < wide.size(); ++i) {
      largest = std::max(largest, std::abs(double(wide[i])));
      difference = std::max(difference, std::abs(double(wide[i] - Real(found[i]))));
    }
    EXPECT_LT(difference, 1e-12 * largest) << name;  // some hundred roundings, times A's condition
  }
}

TEST(Evaluate, refuses_an_unknown_function_and_names_the_known_ones) {
  const Case c;
  EXPECT_THAT([&] { c("acceleration"); },
              ThrowsMessage<InputError>(testing::StartsWith(
                  "no function \"acceleration\"; known: kinematics, mass_matrix, forcing, residual, accelerations, ")));
}

TEST(Evaluate, refuses_an_argument_of_the_wrong_length) {
  const Case c;
  Arguments<Real> arguments = c.arguments();
  const std::string ny = std::to_string(arguments.y.size()), less = std::to_string(arguments.y.size() - 1);
  arguments.y = arguments.y.first(arguments.y.size() - 1);
  EXPECT_THAT([&] { evaluate(c.system, "energy", arguments); },
              ThrowsMessage<InputError>("energy: y has " + less + " entries, needs " + ny));
  arguments = c.arguments();
  arguments.ydot = {};
  EXPECT_THAT([&] { evaluate(c.system, "residual", arguments); },
              ThrowsMessage<InputError>("residual: ydot has 0 entries, needs " + ny));
}

}  // namespace
}  // namespace kanec::generic
