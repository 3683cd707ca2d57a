// Estimates of what the mass matrix takes, and what becomes of a wish for it. Oracle: exact counts of emitted programs.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/choice/reach.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/pipeline.hpp"
#include "generator/program/ledger.hpp"
#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"
#include "tests/lower/sample.hpp"

namespace kanec::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

// All-symbolic, so that no number saves an operation.
scene::Scene of_joints(int n, const std::string& joint) {
  scene::Scene scene = scene::from_connection(chain(n));
  for (scene::Body& body : scene.bodies)
    if (joint == "ball") body.joint.slides.clear(), body.joint.kind = "ball";
  return scene;
}

TEST(Reach, estimates_the_mass_matrix_within_a_fifth) {
  for (const char* joint : {"free", "ball"}) {
    const scene::Scene scene = of_joints(16, joint);
    const Generated made = generate(scene, {{"mass_matrix"}});
    const double exact = program::ledger(made.program, made.program.functions[0]).operations();
    EXPECT_NEAR(static_cast<double>(mass_matrix_operations(scene)) / exact, 1.0, 0.2) << joint;
  }
}

// All-symbolic, about x, y, z in turn.
scene::Scene of_turns(int n, std::size_t turns) {
  scene::Scene scene = scene::from_connection(chain(n));
  std::size_t next = 0;
  for (scene::Body& body : scene.bodies) {
    body.joint.ball = false, body.joint.slides.clear(), body.joint.kind = turns == 1 ? "revolute" : "gimbal";
    for (std::size_t i = 0; i < turns; ++i) {
      body.joint.turns.emplace_back();
      body.joint.turns.back().axis = scene::no_rotation[next++ % 3];
    }
  }
  return scene;
}

TEST(Reach, estimates_what_turns_take_within_a_quarter) {
  for (const std::size_t turns : {1, 3}) {
    SCOPED_TRACE(turns);
    const scene::Scene scene = of_turns(16, turns);
    const Generated made = generate(scene, {{"mass_matrix", "partial_velocities", "partial_velocity_rates"}});
    const std::vector<program::Ledger> exact = program::ledgers(made.program);
    const long estimates[] = {mass_matrix_operations(scene), partial_velocity_operations(scene),
                              partial_velocity_rate_operations(scene)};
    for (std::size_t i = 0; i < 3; ++i)
      EXPECT_NEAR(static_cast<double>(estimates[i]) / exact[i].operations(), 1.0, 0.25) << i;
  }
}

// Balls share them, but for those whose ω a body above has a share of.
TEST(Reach, partial_velocities_of_balls_are_shared) {
  scene::Scene scene = of_joints(300, "ball");
  EXPECT_EQ(partial_velocity_operations(scene), 0);
  scene.bodies[100].joint = of_turns(1, 1).bodies[0].joint;
  EXPECT_EQ(partial_velocity_operations(scene), 57 * (3 * 201 + 200));
}

// Of numbers alone, whatever their count; a turn below them makes them depend on the state.
TEST(Reach, slides_have_numbers_between_them) {
  scene::Scene scene = scene::from_connection(chain(300));
  scene::Joint turn = scene.bodies[0].joint;
  turn.ball = false, turn.slides.clear(), turn.turns.resize(1), turn.kind = "revolute";
  for (scene::Body& body : scene.bodies)
    body.joint.ball = false, body.joint.slides.resize(1), body.joint.kind = "prismatic";
  EXPECT_EQ(mass_matrix_operations(scene), 0);
  scene.bodies[99].joint = turn;
  EXPECT_NEAR(static_cast<double>(mass_matrix_operations(scene)), 22.5 * 201 * 100, 1.0);
}

TEST(Reach, leaves_small_wishes_alone) {
  const Reach reach = within_reach(of_joints(20, "free"), {"residual", "mass_matrix"}, false);
  EXPECT_THAT(reach.names, ElementsAre("residual", "mass_matrix"));
  EXPECT_THAT(reach.notes, IsEmpty());
}

TEST(Reach, a_large_matrix_that_nobody_named_is_left_out_and_said) {
  const Reach reach = within_reach(of_joints(100, "free"), {"residual", "mass_matrix", "energy"}, false);
  EXPECT_THAT(reach.names, ElementsAre("residual", "energy"));
  EXPECT_THAT(reach.notes, ElementsAre(HasSubstr("mass_matrix is left out: it would take some 681,000 operations")));
}

TEST(Reach, large_partial_velocities_that_nobody_named_are_left_out_and_said) {
  const Reach reach = within_reach(of_turns(64, 1), {"partial_velocities", "partial_velocity_rates"}, false);
  EXPECT_THAT(reach.names, ElementsAre("partial_velocities"));
  EXPECT_THAT(reach.notes,
              ElementsAre("partial_velocity_rates is left out: it would take some 253,000 operations; with "
                          "--functions partial_velocity_rates it is made"));
}

TEST(Reach, notes_are_told_before_the_work_begins) {
  std::vector<std::string> notes;
  GenerateOptions options;
  const auto stop = [&](const std::string& note) {
    notes.push_back(note);
    throw InputError("stopped");
  };
  options.tell = stop;
  EXPECT_THROW(generate(of_turns(512, 1), options), InputError);
  EXPECT_THAT(notes, ElementsAre(HasSubstr("mass_matrix is left out")));
}

TEST(Reach, a_large_matrix_that_is_named_is_made_and_said) {
  const Reach reach = within_reach(of_joints(100, "free"), {"energy+mass_matrix"}, true);
  EXPECT_THAT(reach.names, ElementsAre("energy+mass_matrix"));
  EXPECT_THAT(reach.notes, ElementsAre("energy+mass_matrix takes some 681,000 operations: minutes to compile"));
}

TEST(Reach, a_derivative_that_needs_the_matrix_is_as_large_and_the_matrix_is_named_as_the_reason) {
  const Reach reach = within_reach(of_joints(100, "free"), {"accelerations_x"}, true);
  EXPECT_THAT(
      reach.notes,
      ElementsAre("accelerations_x needs the mass matrix, which takes some 681,000 operations: minutes to compile"));
  for (const std::string name : {"residual_ydot", "accelerations_x", "state_matrix"}) {
    try {
      generate(of_joints(500, "free"), {{name}});
      FAIL() << name << ": nothing was thrown";
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), HasSubstr("function " + name +
                                          ": found some 16,908,000 operations for the mass matrix "
                                          "of this scene, which it needs; allowed"));
    }
  }
}

TEST(Reach, a_matrix_beyond_all_measure_is_refused) {
  try {
    generate(of_joints(500, "free"), {{"mass_matrix"}});
    FAIL() << "nothing was thrown";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "function mass_matrix: found some 16,908,000 operations for the mass matrix of this scene; "
                 "allowed: at most 2,000,000 operations (residual and accelerations do without the matrix)");
  }
}

}  // namespace
}  // namespace kanec::test
