// Known answers against each other and against the equations of motion: oracles are the generic path in long double,
// extrapolated, and motions worked out by hand for closed forms, and closed forms for the generic path.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "generator/read/read.hpp"
#include "runtime/generic/evaluate.hpp"
#include "runtime/study/hard/answer.hpp"
#include "runtime/study/hard/extrapolation.hpp"

namespace kanec::hard::test {
namespace {

using Real = long double;

scene::Scene hard_scene(const std::string& name) {
  return scene::read(KANEC_SOURCE_DIR "/models/hard/" + name + "/scene.toml");
}

// A row and what it refers to.
struct Instant {
  double t;
  std::vector<double> x, y;
  Row row() const { return {t, x, y, 0.0, {}}; }
};

std::vector<double> evenly(double duration, int rows) {
  std::vector<double> times;
  for (int i = 0; i <= rows; ++i) times.push_back(duration * i / rows);
  return times;
}

// Of a run of the generic path in long double, 1e-16 a step, rounded to double.
std::vector<Instant> solution(const scene::Scene& scene, const std::vector<double>& times) {
  const generic::System<Real> system(scene, scene::default_parameters(scene));
  const auto nx = scene::n_coordinates(scene);
  const auto rates = [&](Real t, const std::vector<Real>& z) {
    const std::span<const Real> all(z);
    const auto n = static_cast<std::size_t>(nx);
    const generic::Arguments<Real> at{t, all.first(n), all.subspan(n), {}, {}};
    std::vector<Real> rate = generic::evaluate<Real>(system, "kinematics", at);
    for (const Real value : generic::evaluate<Real>(system, "accelerations", at)) rate.push_back(value);
    return rate;
  };
  std::vector<Real> z;
  for (const double value : scene::initial_coordinates(scene)) z.push_back(value);
  for (const double value : scene::initial_speeds(scene)) z.push_back(value);
  Extrapolation<Real> reference(rates, z, {8, 1e-16, 19});
  std::vector<Instant> list;
  for (const double t : times) {
    const std::vector<Real>& now = reference.advance(t);
    list.push_back({t, {now.begin(), now.begin() + nx}, {now.begin() + nx, now.end()}});
  }
  return list;
}

// An answer, instants of its scene by another way, and what these differ by.
struct Case {
  std::string name;
  std::string answer;
  scene::Scene scene;
  std::vector<Instant> instants;
  double most;
};

Case run(const std::string& name, const std::string& answer, const std::vector<double>& times, double most) {
  const scene::Scene scene = hard_scene(name);
  return {name, answer, scene, solution(scene, times), most};
}

// 2.5, -2.5 and 10 m/s² down: up from 3 m/s to 2 at 1 m and 0.4 s, to 4 at 3.4 m and 1.2 s.
Case switched_by_hand() {
  scene::Scene scene = hard_scene("switched_gravity");
  for (scene::Named& one : scene.parameters) one.value = one.name == "low" ? 1.0 : 3.4;
  scene.inputs[0].value = 2.5;
  scene.events[0].settings[0].value = -2.5;
  scene.events[1].settings[0].value = 10.0;
  return {"switched_gravity",
          "switched",
          scene,
          {{0.0, {0.0}, {3.0}}, {0.2, {0.55}, {2.5}}, {0.8, {2.0}, {3.0}}, {2.0, {3.4}, {-4.0}}},
          1e-14};
}

// Half a swing of 1e-4 pi s, whose middle is 1 mm deep and at rest: as fast away as it came. A rounding of the time
// turns the swing by 1e-13.
Case bounce_by_hand() {
  const double end = 0.2 + 1e-4 * std::numbers::pi;
  return {"contact left again",
          "bounce",
          hard_scene("contact"),
          {{0.0, {1.0}, {-10.0}}, {end / 2, {-1e-3}, {0.0}}, {end - 0.05, {0.5}, {10.0}}, {end, {1.0}, {10.0}}},
          1e-12};
}

// A circle is an ellipse without a periapsis.
Case circle_by_hand() {
  Case one{"circle", "kepler", hard_scene("attractor"), {}, 1e-15};
  for (const double t : evenly(20.0, 10))
    one.instants.push_back({t, {std::cos(t), std::sin(t), 0.0}, {-std::sin(t), std::cos(t), 0.0}});
  return one;
}

// k = m = 1, c = 2: q = (1 + t) exp(-t).
Case critically_damped_by_hand() {
  const scene::Scene scene = scene::parse(
      "name = \"a\"\nconnection = [0]\n[parameters]\nk = 1.0\nc = 2.0\n[[body]]\njoint = \"prismatic\"\naxis = \"x\"\n"
      "mass = 1.0\ninertia = [0.0, 0.0, 0.0]\nstiffness = \"k\"\ndamping = \"c\"\n",
      "scene.toml");
  Case one{"critically damped", "uniform_chain", scene, {}, 1e-15};
  for (const double t : evenly(8.0, 16)) one.instants.push_back({t, {(1.0 + t) * std::exp(-t)}, {-t * std::exp(-t)}});
  return one;
}

// Bounds: what rounding a row to double and a run of some hundred steps leave.
const std::vector<Case>& cases() {
  static const std::vector<Case> list = {
      run("torque_free", "torque_free", evenly(8.0, 20), 1e-13),
      run("fast_spin", "torque_free", evenly(0.002, 20), 1e-13), run("fast_top", "heavy_top", evenly(0.1, 20), 1e-13),
      run("precessing_top", "heavy_top", evenly(0.2, 20), 1e-13),
      run("sleeping_top", "heavy_top", evenly(2.0, 20), 1e-12),
      run("kovalevskaya", "kovalevskaya", evenly(3.0, 20), 1e-13),
      run("stiff_springs", "uniform_chain", evenly(0.002, 20), 1e-13),
      run("attractor", "kepler", evenly(6.0, 20), 1e-12),
      // to where the spring is met, and on it: the force has a corner, which the run is not to step over
      run("contact", "bounce", {0.0, 0.1, 0.1001, 0.1002, 0.1003}, 1e-12), bounce_by_hand(), switched_by_hand(),
      circle_by_hand(), critically_damped_by_hand()};
  return list;
}

TEST(Answers, in_closed_form_are_solutions_of_the_equations_of_motion) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    const auto known = answer(one.answer, one.scene);
    for (const Instant& instant : one.instants) known->compare(instant.row());
    for (const Deviation& deviation : known->deviations()) EXPECT_LT(deviation.value, one.most) << deviation.what;
  }
}

// The same instants, a thousandth late, or of an invariant, which has no time, a thousandth fast.
TEST(Answers, in_closed_form_see_a_small_error) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    const auto known = answer(one.answer, one.scene);
    for (Instant instant : one.instants) {
      if (instant.t > 0 && one.answer == "kovalevskaya")
        for (double& speed : instant.y) speed *= 1.001;
      else
        instant.t *= 1.001;
      known->compare(instant.row());
    }
    for (const Deviation& deviation : known->deviations()) EXPECT_GT(deviation.value, 1e-6) << deviation.what;
  }
}

TEST(Answers, keep_what_is_not_a_number) {
  for (const Case& one : cases()) {
    SCOPED_TRACE(one.name);
    const auto known = answer(one.answer, one.scene);
    for (Instant instant : one.instants) {
      if (instant.t == one.instants[1].t)
        for (auto* values : {&instant.x, &instant.y}) values->assign(values->size(), std::nan(""));
      known->compare(instant.row());
    }
    for (const Deviation& deviation : known->deviations()) EXPECT_TRUE(std::isnan(deviation.value)) << deviation.what;
  }
}

TEST(Answers, by_reference_runs_agree_with_each_other) {
  const scene::Scene scene = hard_scene("double_pendulum");
  const auto wide = answer("reference", scene), precise = answer("precise", scene);
  for (const Instant& instant : solution(scene, evenly(1.0, 4))) {
    wide->compare(instant.row());
    precise->compare(instant.row());
  }
  // constants of the program are rounded to double, and so are rows
  for (const auto* known : {&wide, &precise})
    for (const Deviation& deviation : (*known)->deviations()) EXPECT_LT(deviation.value, 1e-14) << deviation.what;
}

}  // namespace
}  // namespace kanec::hard::test
