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
using testing::ElementsAreArray;
using testing::ThrowsMessage;

struct Case {
  Sample s = samples()[4];
  System<Real> system = s.system<Real>();

  Arguments<Real> arguments() const { return {0, span(s.x), span(s.y), span(s.ydot), span(s.u)}; }
  std::vector<Real> operator()(std::string_view function) const { return evaluate(system, function, arguments()); }
  static std::span<const Real> span(const Vector& a) { return {a.data(), static_cast<std::size_t>(a.size())}; }
};

TEST(Evaluate, knows_the_functions_of_a_solver) {
  EXPECT_THAT(function_names(),
              ElementsAre("kinematics", "mass_matrix", "forcing", "residual", "accelerations", "partial_velocities",
                          "partial_velocity_rates", "energy", "momentum", "poses", "power"));
}

TEST(Evaluate, gives_vectors_in_state_order) {
  const Case c;
  const Sample& s = c.s;
  EXPECT_THAT(c("kinematics"), ElementsAreArray(c.system.kinematics(s.x, s.y)));
  EXPECT_THAT(c("forcing"), ElementsAreArray(c.system.forcing(s.x, s.y, s.u)));
  EXPECT_THAT(c("residual"), ElementsAreArray(c.system.residual(s.x, s.y, s.ydot, s.u)));
  EXPECT_THAT(c("accelerations"), ElementsAreArray(c.system.accelerations(s.x, s.y, s.u)));
}

TEST(Evaluate, gives_matrices_row_by_row) {
  const Case c;
  const Sample& s = c.s;
  const auto expect_rows = [](const std::vector<Real>& flat, const Matrix& a) {
    ASSERT_EQ(static_cast<Eigen::Index>(flat.size()), a.size());
    for (Eigen::Index i = 0; i < a.rows(); ++i)
      for (Eigen::Index j = 0; j < a.cols(); ++j) ASSERT_EQ(flat[static_cast<std::size_t>(i * a.cols() + j)], a(i, j));
  };
  expect_rows(c("mass_matrix"), c.system.mass_matrix(s.x));
  expect_rows(c("partial_velocities"), c.system.partial_velocities(s.x));
  expect_rows(c("partial_velocity_rates"), c.system.partial_velocity_rates(s.x, s.y));
}

TEST(Evaluate, gives_energy_momentum_and_power_in_the_documented_order) {
  const Case c;
  const Energy<Real> energy = c.system.energy(c.s.x, c.s.y);
  EXPECT_THAT(c("energy"), ElementsAre(energy.kinetic, energy.potential));
  const Momentum<Real> m = c.system.momentum(c.s.x, c.s.y);
  EXPECT_THAT(c("momentum"),
              ElementsAre(m.linear[0], m.linear[1], m.linear[2], m.angular[0], m.angular[1], m.angular[2]));
  EXPECT_THAT(c("power"), ElementsAre(c.system.power(c.s.x, c.s.y, c.s.u)));
}

TEST(Evaluate, gives_each_body_its_rotation_row_by_row_and_then_its_mass_centre) {
  const Case c;
  const std::vector<Real> flat = c("poses");
  const auto poses = c.system.poses(c.s.x);
  ASSERT_EQ(flat.size(), 12 * poses.size());
  for (std::size_t k = 0; k < poses.size(); ++k)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      for (std::size_t j = 0; j < 3; ++j)
        EXPECT_EQ(flat[12 * k + 3 * i + j], poses[k].R(row, static_cast<Eigen::Index>(j)));
      EXPECT_EQ(flat[12 * k + 9 + i], poses[k].p[row]);
    }
}

TEST(Evaluate, needs_only_the_arguments_that_the_function_reads) {
  const Case c;
  EXPECT_EQ(evaluate(c.system, "mass_matrix", {.x = c.arguments().x}), c("mass_matrix"));
  EXPECT_EQ(evaluate(c.system, "energy", {.x = c.arguments().x, .y = c.arguments().y}), c("energy"));
}

TEST(Evaluate, refuses_an_unknown_function_and_names_the_known_ones) {
  const Case c;
  EXPECT_THAT(
      [&] { c("acceleration"); },
      ThrowsMessage<InputError>("no function \"acceleration\"; known: kinematics, mass_matrix, forcing, residual, "
                                "accelerations, partial_velocities, partial_velocity_rates, energy, momentum, "
                                "poses, power"));
}

TEST(Evaluate, refuses_an_argument_of_the_wrong_length) {
  const Case c;
  Arguments<Real> arguments = c.arguments();
  arguments.y = arguments.y.first(29);
  EXPECT_THAT([&] { evaluate(c.system, "energy", arguments); },
              ThrowsMessage<InputError>("energy: y has 29 entries, needs 30"));
  arguments = c.arguments();
  arguments.ydot = {};
  EXPECT_THAT([&] { evaluate(c.system, "residual", arguments); },
              ThrowsMessage<InputError>("residual: ydot has 0 entries, needs 30"));
}

}  // namespace
}  // namespace kanec::generic
