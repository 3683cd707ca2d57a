// Estimates of what the mass matrix takes, and what becomes of a wish for it. Oracle: exact counts of emitted programs.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/reach.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "generator/pipeline.hpp"
#include "generator/program/ledger.hpp"
#include "generator/scene/read.hpp"
#include "runtime/base/error.hpp"

namespace kanec::test {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::vector<int> chain(int n) {
  std::vector<int> list;
  for (int k = 0; k < n; ++k) list.push_back(k);
  return list;
}

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
