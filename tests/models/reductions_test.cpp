// What a scene does not have costs nothing. Oracle: the operations of the smaller scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "tests/models/model.hpp"

namespace kanec::test {
namespace {

using scene::Number;
using scene::Scene;

const std::vector<std::string> functions = {"kinematics", "energy",  "accelerations",
                                            "residual",   "forcing", "mass_matrix"};

void expect_equal_operations(const Scene& reduced, const Scene& smaller, const char* what) {
  const Model left(reduced, functions), right(smaller, functions);
  for (const std::string& name : functions)
    EXPECT_EQ(left.operations(name), right.operations(name)) << what << ", " << name;
}

// The joint of body k turned to stone at zero.
Scene welded(Scene scene, int k) {
  scene.bodies[static_cast<std::size_t>(k - 1)].joint.kind = "weld";
  scene.bodies[static_cast<std::size_t>(k - 1)].joint.turns.clear();
  std::erase_if(scene.loads,
                [k](const scene::Load& load) { return load.kind == scene::Load::Kind::joint && load.point.body == k; });
  return scene;
}

Scene locked(Scene scene, int k, double value) {
  scene::Coordinate& angle = scene.bodies[static_cast<std::size_t>(k - 1)].joint.turns[0];
  angle.motion = scene::Coordinate::Motion::locked;
  angle.value = value;
  return scene;
}

// A point mass at the mass centre of body k: no inertia changes its pattern of zeros.
Scene with_ballast(Scene scene, std::size_t k) {
  scene::Body ballast;
  ballast.name = "ballast";
  ballast.joint.kind = "weld";
  ballast.joint.ball = false;
  ballast.joint.slides.clear();
  ballast.mass = Number::constant(0.25);
  ballast.q = scene.bodies[k - 1].r;
  scene.lower.push_back(static_cast<int>(k));
  scene.bodies.push_back(ballast);
  return scene;
}

TEST(Reductions, weld_adds_no_operations) {
  for (const char* name : {"double_pendulum", "arm_7", "bench_s6r", "spinning_top"}) {
    const Scene scene = shipped_scene(name);
    for (std::size_t k = 1; k <= scene.bodies.size(); ++k) expect_equal_operations(with_ballast(scene, k), scene, name);
  }
}

TEST(Reductions, locked_joint_costs_what_the_weld_costs) {
  const Scene arm = shipped_scene("arm_7");
  for (int k = 1; k <= 7; ++k) expect_equal_operations(locked(arm, k, 0.0), welded(arm, k), "locked at zero");
}

TEST(Reductions, wholly_locked_scene_costs_nothing) {
  Scene pendulum = locked(locked(shipped_scene("double_pendulum"), 1, 0.3), 2, -0.2);
  const Model model(pendulum, {"energy", "kinematics", "residual"});
  for (const char* name : {"energy", "kinematics", "residual"}) EXPECT_EQ(model.operations(name), 0) << name;
}

TEST(Reductions, scene_without_gravity_has_no_terms_of_it) {
  Scene pendulum = shipped_scene("pendulum");
  pendulum.gravity = {};
  const Model model(pendulum, functions);
  EXPECT_EQ(model.operations("forcing"), 1);        // -c θ̇
  EXPECT_LE(model.operations("accelerations"), 2);  // over I + m r²
  for (const std::string& name : shipped_models()) {
    Scene scene = shipped_scene(name);
    if (is_zero(scene.gravity)) continue;
    const Model heavy(scene, functions);
    scene.gravity = {};
    const Model weightless(scene, functions);
    for (const char* function : {"residual", "forcing", "energy", "accelerations"})
      EXPECT_LT(weightless.operations(function), heavy.operations(function)) << name << ", " << function;
  }
}

// Two rods whose numbers are all of 3-D: full inertias, mass centres and joints beside the plane of motion.
TEST(Reductions, planar_motion_of_spatial_bodies_costs_what_the_plane_costs) {
  const Scene plane = shipped_scene("double_pendulum");
  Scene space = plane;
  for (scene::Body& body : space.bodies) {
    body.inertia.zz = Number::constant(0.01);
    body.inertia.xy = Number::constant(0.002);
    body.inertia.xz = Number::constant(0.001);
    body.inertia.yz = Number::constant(-0.003);
    body.r[1] = Number::constant(0.04);
    body.q[1] = Number::constant(0.1);
  }
  const Model in_plane(plane, functions), in_space(space, functions);
  for (const std::string& name : functions)
    EXPECT_LE(in_space.operations(name), 1.1 * in_plane.operations(name)) << name;
}

}  // namespace
}  // namespace kanec::test
