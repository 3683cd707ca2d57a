// Operations of one call, asserted so that a lost optimisation fails. Oracle: figures measured once and not to be
// exceeded, and the law that they follow.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include "generator/program/ledger.hpp"
#include "generator/read/read.hpp"
#include "tests/lower/sample.hpp"
#include "tests/support/reference.hpp"

namespace kanec::test {
namespace {

program::Ledger ledger_of(const program::Program& program, const std::string& name) {
  for (const program::Function& function : program.functions)
    if (function.name == name) return program::ledger(program, function);
  throw std::out_of_range(name);
}

int operations(const program::Program& program, const std::string& name) {
  return ledger_of(program, name).operations();
}

scene::Scene six_bodies() { return scene::read(KANEC_SOURCE_DIR "/models/bench_s6f/scene.toml"); }

TEST(Counts, of_the_benchmark_tree_with_all_loads) {
  const program::Program program = program_of(six_bodies());
  EXPECT_LE(operations(program, "residual"), 1237);
  EXPECT_LE(operations(program, "accelerations"), 961);
  EXPECT_LE(operations(program, "forcing"), 1119);
  EXPECT_LE(operations(program, "mass_matrix"), 1395);
  EXPECT_LE(operations(program, "partial_velocities"), 450);
  EXPECT_LE(operations(program, "partial_velocity_rates"), 792);
  EXPECT_LE(operations(program, "kinematics"), 138);
  EXPECT_LE(operations(program, "poses"), 351);
  EXPECT_LE(operations(program, "energy"), 716);
  EXPECT_LE(operations(program, "momentum"), 963);
  EXPECT_LE(operations(program, "power"), 536);
}

// Of 7 accelerations by 7 coordinates, 7 speeds and 7 torques.
TEST(Counts, of_the_derivatives_of_an_arm_of_seven_joints) {
  const scene::Scene scene = read_reference(KANEC_SOURCE_DIR "/tests/data/reference_cr7.json").scene;
  const std::string all = "accelerations_x+accelerations_y+accelerations_u";
  const program::Program program =
      program_of(scene, {all, "residual_xi", "residual_y", "residual_ydot", "state_matrix"});
  EXPECT_LE(program::ledger(program, program.functions[0]).operations(), 5342);
  EXPECT_LE(operations(program, "residual_xi"), 2612);
  EXPECT_LE(operations(program, "residual_y"), 1691);
  EXPECT_LE(operations(program, "residual_ydot"), 439);
  EXPECT_LE(operations(program, "state_matrix"), 5139);
}

// The trees of tests/data with ball and revolute joints, torques as inputs. Sines and cosines, one each an angle, are
// not among the operations.
struct Benchmark {
  const char* name;
  int accelerations, residual, forcing, mass_matrix;
};

TEST(Counts, of_the_benchmark_trees_of_other_joints) {
  for (const Benchmark& most : {Benchmark{"s6b", 2385, 1174, 1087, 1004},
                                {"s6r", 1439, 757, 691, 366},
                                {"cr7", 1495, 700, 665, 439},
                                {"cb6", 2363, 1105, 1031, 1227}}) {
    const scene::Scene scene =
        read_reference(KANEC_SOURCE_DIR "/tests/data/reference_" + std::string(most.name) + ".json").scene;
    const program::Program program = program_of(scene);
    EXPECT_LE(operations(program, "accelerations"), most.accelerations) << most.name;
    EXPECT_LE(operations(program, "residual"), most.residual) << most.name;
    EXPECT_LE(operations(program, "forcing"), most.forcing) << most.name;
    EXPECT_LE(operations(program, "mass_matrix"), most.mass_matrix) << most.name;
  }
}

// Its numbers are constants: inverses of inertias are folded, no call divides, and nothing is left to prepare.
TEST(Counts, of_constants_hold_no_divisions_and_leave_nothing_to_prepare) {
  const program::Program program = program_of(six_bodies());
  for (const program::Function& function : program.functions)
    EXPECT_EQ(program::ledger(program, function).divides, 0) << function.name;
  EXPECT_EQ(program::prepare_ledger(program), program::Ledger{});
}

// With every number a parameter the inverses are prepared: again no call divides, and each inertia takes one division.
TEST(Counts, of_parameters_hold_no_divisions_in_calls) {
  const program::Program program = program_of(scene::from_connection({0, 1, 2, 2, 1, 5}));
  for (const program::Function& function : program.functions)
    EXPECT_EQ(program::ledger(program, function).divides, 0) << function.name;
  EXPECT_EQ(program::prepare_ledger(program).divides, 2 * 6);  // and each mass one
}

// The body whose sections repeat, added to the end of a chain or to the hub of a star.
std::vector<int> star(int n) {
  std::vector<int> lower(static_cast<std::size_t>(n), 1);
  lower[0] = 0;
  return lower;
}

struct Growth {
  const char* name;
  std::vector<int> (*tree)(int);
  int residual, accelerations;  // at most, a body
};

TEST(Counts, of_residual_and_accelerations_grow_by_the_same_number_a_body) {
  for (const Growth& growth : {Growth{"chain", chain, 221, 167}, Growth{"star", star, 218, 164}}) {
    const auto count = [&](int n) {
      Random random(static_cast<std::uint64_t>(n));
      const program::Program program = program_of(random_scene(random, growth.tree(n)), {"residual", "accelerations"});
      return std::pair(operations(program, "residual"), operations(program, "accelerations"));
    };
    const auto [residual, accelerations] = count(8);
    const auto next = count(9);
    const int of_residual = next.first - residual;
    const int of_accelerations = next.second - accelerations;
    EXPECT_LE(of_residual, growth.residual) << growth.name;
    EXPECT_LE(of_accelerations, growth.accelerations) << growth.name;
    for (const int n : {10, 11, 12, 16, 24, 31, 32, 33, 48, 63, 64})
      EXPECT_EQ(count(n), std::pair(residual + (n - 8) * of_residual, accelerations + (n - 8) * of_accelerations))
          << growth.name << " of " << n << " bodies";
  }
}

TEST(Counts, of_a_scene_without_loads_or_gravity_are_lower) {
  const scene::Scene full = six_bodies();
  scene::Scene no_loads = full;
  for (scene::Body& body : no_loads.bodies) body.force = body.moment = {};
  scene::Scene no_gravity = no_loads;
  no_gravity.gravity = {};
  const program::Program with_all = program_of(full);
  const program::Program without_loads = program_of(no_loads);
  const program::Program without_both = program_of(no_gravity);
  // loads are 36 numbers, each added once a function
  for (const char* name : {"residual", "forcing"}) {
    EXPECT_EQ(operations(without_loads, name), operations(with_all, name) - 36) << name;
    EXPECT_LT(operations(without_both, name), operations(without_loads, name)) << name;
  }
  EXPECT_LT(operations(without_loads, "accelerations"), operations(with_all, "accelerations"));
  EXPECT_LE(operations(without_both, "accelerations"), operations(without_loads, "accelerations"));
  EXPECT_LT(operations(without_both, "energy"), operations(without_loads, "energy"));
}

TEST(Counts, of_a_lone_parameter_are_no_more_than_it_saves_as_a_constant) {
  scene::Scene constant = six_bodies();
  scene::Scene parameter = constant;
  parameter.parameters = {{"m", 1.3}};
  parameter.bodies[2].mass = scene::Number::parameter(0);
  const program::Program with_constant = program_of(constant);
  const program::Program with_parameter = program_of(parameter);
  EXPECT_EQ(program::prepare_ledger(with_constant).operations(), 0);
  EXPECT_GT(program::prepare_ledger(with_parameter).operations(), 0);
  for (const program::Function& function : with_constant.functions)
    EXPECT_LE(operations(with_constant, function.name), operations(with_parameter, function.name)) << function.name;
}

TEST(Counts, of_symmetric_scenes_are_no_more_than_of_others) {
  Random random(8);
  scene::Scene general = random_scene(random, chain(4));
  scene::Scene aligned = general;
  for (scene::Body& body : aligned.bodies) {
    body.inertia.xy = body.inertia.xz = body.inertia.yz = {};
    body.r[0] = body.r[1] = body.q[1] = body.q[2] = {};
  }
  const program::Program with_all = program_of(general);
  const program::Program with_zeros = program_of(aligned);
  for (const char* name : {"residual", "accelerations", "forcing", "mass_matrix", "momentum", "energy"})
    EXPECT_LT(operations(with_zeros, name), operations(with_all, name)) << name;
}

}  // namespace
}  // namespace kanec::test
