// Scenes and starts that a known answer is not of. Oracle: where each closed form ends, and its message.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/study/hard/answer.hpp"

namespace kanec::hard::test {
namespace {

using testing::HasSubstr;

scene::Scene hard_scene(const std::string& name) {
  return scene::read(KANEC_SOURCE_DIR "/models/hard/" + name + "/scene.toml");
}

// One body; `top`: tables before it.
scene::Scene body(const std::string& keys, const std::string& top = "") {
  return scene::parse("name = \"a\"\nconnection = [0]\n" + top + "[[body]]\nmass = 1.0\n" + keys, "scene.toml");
}

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "nothing was refused";
}

std::string of_scene(const std::string& name, const scene::Scene& scene) {
  return refusal([&] { answer(name, scene); });
}

std::string of_start(const std::string& name, const scene::Scene& scene, const std::vector<double>& x,
                     const std::vector<double>& y) {
  const auto known = answer(name, scene);
  return refusal([&] { known->compare({0.0, x, y, 0.0, {}}); });
}

TEST(Refusals, of_answers_to_scenes_that_they_are_not_of) {
  const scene::Scene scene = hard_scene("double_pendulum");
  for (const char* name : {"torque_free", "heavy_top", "kovalevskaya", "uniform_chain", "kepler", "bounce", "switched"})
    EXPECT_THAT(of_scene(name, scene), HasSubstr(std::string(name) + ": found another scene; allowed: "));
  EXPECT_THAT(of_scene("torque", scene), HasSubstr("answer: found \"torque\"; allowed: "));
}

TEST(Refusals, of_slides_that_are_locked) {
  const std::string sliding =
      "joint = \"prismatic\"\naxis = \"z\"\ninertia = [0.0, 0.0, 0.0]\n[body.motion]\ns = 0.5\n";
  const std::string found = ": found a slide of body 1 locked or prescribed; allowed: ";
  EXPECT_THAT(of_scene("kepler", body("joint = \"cartesian\"\ninertia = [0.0, 0.0, 0.0]\n"
                                      "[body.motion]\ns = [\"free\", \"free\", 0.0]\n",
                                      "[parameters]\nmu = 1.0\n")),
              HasSubstr("kepler" + found + "one mass with three free translations"));
  EXPECT_THAT(of_scene("bounce", body(sliding, "[parameters]\nk = 1.0\n")), HasSubstr("bounce" + found));
  EXPECT_THAT(of_scene("switched", body(sliding)), HasSubstr("switched" + found));
  // as many free speeds as bodies
  EXPECT_THAT(of_scene("uniform_chain", body("joint = \"cylindrical\"\naxis = \"z\"\ninertia = [1.0, 1.0, 1.0]\n"
                                             "[body.motion]\ns = 0.5\n",
                                             "[parameters]\nk = 1.0\n")),
              HasSubstr("uniform_chain" + found));
}

TEST(Refusals, of_springs_that_do_not_push_and_tops_that_do_not_fall) {
  EXPECT_THAT(of_scene("bounce", body("joint = \"prismatic\"\naxis = \"z\"\ninertia = [0.0, 0.0, 0.0]\n",
                                      "[parameters]\nk = 0.0\n")),
              HasSubstr("bounce: found a spring that does not push; allowed: k > 0"));
  EXPECT_THAT(of_scene("heavy_top", body("joint = \"ball\"\ninertia = [1.0, 1.0, 1.0]\n", "gravity = [0, 0, -9.81]\n")),
              HasSubstr("heavy_top: found another scene; allowed: "));
}

TEST(Refusals, of_free_turns_that_are_steady_or_on_the_separatrix) {
  const std::string message = "torque_free: found a start at rest, in a steady turn or on the separatrix";
  const std::vector<double> x = {0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
  const scene::Scene scene = hard_scene("torque_free"), sphere = body("inertia = [0.01, 0.01, 0.01]\n");
  for (const std::vector<double>& omega : std::vector<std::vector<double>>{{0, 0, 0}, {5, 0, 0}, {0, 5, 0}, {0, 0, 5}})
    EXPECT_THAT(of_start("torque_free", scene, x, {omega[0], omega[1], omega[2], 0, 0, 0}), HasSubstr(message));
  EXPECT_THAT(of_start("torque_free", sphere, x, {1, 2, 3, 0, 0, 0}), HasSubstr(message));
  // 10 (13 - 10) = 15 (15 - 13): with ω1 = ω3, |I ω|² = 2 T I2
  EXPECT_THAT(of_start("torque_free", body("inertia = [10.0, 13.0, 15.0]\n"), x, {1, 2, 1, 0, 0, 0}),
              HasSubstr(message));
}

TEST(Refusals, of_tops_whose_axis_becomes_vertical) {
  const std::string message = "heavy_top: found a start from which the axis becomes vertical";
  const scene::Scene scene = hard_scene("fast_top");
  const std::vector<double> upright = {0.0, 0.0, 0.0, 1.0}, tilted = {0.28, 0.0, 0.0, 0.96};
  EXPECT_THAT(of_start("heavy_top", scene, upright, {0, 0, 100}), HasSubstr(message));
  EXPECT_THAT(of_start("heavy_top", scene, upright, {1, 0, 0}), HasSubstr(message));
  // pendulums, which swing through the lowest place
  EXPECT_THAT(of_start("heavy_top", scene, tilted, {0, 0, 0}), HasSubstr(message));
  EXPECT_THAT(of_start("heavy_top", scene, tilted, {0, 5, 20}), HasSubstr("nothing"));
}

TEST(Refusals, of_an_invariant_of_zero) {
  EXPECT_THAT(of_start("kovalevskaya", hard_scene("kovalevskaya"), {0, 0, 0, 1}, {0, 0, 5}),
              HasSubstr("kovalevskaya: found a start with an invariant of 0"));
}

TEST(Refusals, of_orbits_that_are_no_ellipse) {
  const std::string message = "kepler: found a start without an ellipse";
  const scene::Scene scene = hard_scene("attractor");
  EXPECT_THAT(of_start("kepler", scene, {1, 0, 0}, {0, 2, 0}), HasSubstr(message));    // a hyperbola
  EXPECT_THAT(of_start("kepler", scene, {2, 0, 0}, {0, 1, 0}), HasSubstr(message));    // a parabola
  EXPECT_THAT(of_start("kepler", scene, {1, 0, 0}, {0.5, 0, 0}), HasSubstr(message));  // a straight line
  EXPECT_THAT(of_start("kepler", scene, {0, 0, 0}, {0, 1, 0}), HasSubstr(message));
}

TEST(Refusals, of_masses_that_do_not_come_to_the_spring_or_the_events) {
  const scene::Scene contact = hard_scene("contact"), switched = hard_scene("switched_gravity");
  EXPECT_THAT(of_start("bounce", contact, {1}, {0}), HasSubstr("bounce: found another start"));
  EXPECT_THAT(of_start("bounce", contact, {-1}, {-1}), HasSubstr("bounce: found another start"));
  EXPECT_THAT(of_start("switched", switched, {0}, {0}), HasSubstr("switched: found another start"));
  EXPECT_THAT(of_start("switched", switched, {0}, {1}), HasSubstr("switched: found another start"));
  EXPECT_THAT(of_start("switched", switched, {0.5}, {3}), HasSubstr("switched: found another start"));
}

}  // namespace
}  // namespace kanec::hard::test
