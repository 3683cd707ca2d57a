// Known answers against each other and against the equations of motion: oracles are the generic path in long double,
// extrapolated, for closed forms, and closed forms for it.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "generator/scene/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/cli/hard/answer.hpp"
#include "runtime/cli/hard/extrapolation.hpp"
#include "runtime/generic/evaluate.hpp"

namespace kanec::cli::hard::test {
namespace {

using Real = long double;

scene::Scene hard_scene(const std::string& name) {
  return scene::read(KANEC_SOURCE_DIR "/models/hard/" + name + "/scene.toml");
}

// Rows of a run of the generic path in long double, 1e-15 a step, rounded to double.
template <class Show>
void run(const scene::Scene& scene, double duration, int rows, const Show& show) {
  const generic::System<Real> system(scene, scene::default_parameters(scene));
  const auto nx = static_cast<std::size_t>(scene::n_coordinates(scene));
  const auto rates = [&](Real t, const std::vector<Real>& z) {
    const std::span<const Real> all(z);
    const generic::Arguments<Real> at{t, all.first(nx), all.subspan(nx), {}, {}};
    std::vector<Real> rate = generic::evaluate<Real>(system, "kinematics", at);
    for (const Real value : generic::evaluate<Real>(system, "accelerations", at)) rate.push_back(value);
    return rate;
  };
  std::vector<Real> z;
  for (const double value : scene::initial_coordinates(scene)) z.push_back(value);
  for (const double value : scene::initial_speeds(scene)) z.push_back(value);
  Extrapolation<Real> reference(rates, z, {8, 1e-16, 19});
  for (int i = 0; i <= rows; ++i) {
    const double t = duration * i / rows;
    const std::vector<Real>& now = reference.advance(t);
    const std::vector<double> values(now.begin(), now.end());
    const std::span<const double> all(values);
    show(integrate::Row{t, all.first(nx), all.subspan(nx), 0.0, {}});
  }
}

// What rounding a row to double and a run of some hundred steps leave.
TEST(Answers, in_closed_form_are_solutions_of_the_equations_of_motion) {
  struct Case {
    const char *scene, *answer;
    double duration, most;
  };
  for (const Case& one : {Case{"torque_free", "torque_free", 8.0, 1e-13},
                          {"fast_spin", "torque_free", 0.002, 1e-13},
                          {"fast_top", "heavy_top", 0.1, 1e-13},
                          {"precessing_top", "heavy_top", 0.2, 1e-13},
                          {"sleeping_top", "heavy_top", 2.0, 1e-12},
                          {"kovalevskaya", "kovalevskaya", 3.0, 1e-13},
                          {"stiff_springs", "uniform_chain", 0.002, 1e-13},
                          {"attractor", "kepler", 6.0, 1e-12}}) {
    SCOPED_TRACE(one.scene);
    const scene::Scene scene = hard_scene(one.scene);
    const auto known = answer(one.answer, scene);
    run(scene, one.duration, 20, [&](const integrate::Row& row) { known->compare(row); });
    for (const Error& error : known->errors()) EXPECT_LT(error.value, one.most) << error.what;
  }
}

// The same instant, a thousandth off: an answer that says nothing would be 0.
TEST(Answers, in_closed_form_see_a_small_error) {
  for (const auto& [name, closed_form] : {std::pair("torque_free", "torque_free"), {"fast_top", "heavy_top"}}) {
    const scene::Scene scene = hard_scene(name);
    const auto known = answer(closed_form, scene);
    run(scene, 0.01, 2, [&](integrate::Row row) {
      if (row.t > 0) row.t *= 1.001;
      known->compare(row);
    });
    EXPECT_GT(known->errors().front().value, 1e-6) << name;
  }
}

TEST(Answers, by_reference_runs_agree_with_each_other) {
  const scene::Scene scene = hard_scene("double_pendulum");
  const auto wide = answer("reference", scene), precise = answer("precise", scene);
  run(scene, 1.0, 4, [&](const integrate::Row& row) {
    wide->compare(row);
    precise->compare(row);
  });
  // constants of the program are rounded to double, and so are rows
  for (const auto* known : {&wide, &precise})
    for (const Error& error : (*known)->errors()) EXPECT_LT(error.value, 1e-14) << error.what;
}

TEST(Answers, refuse_scenes_that_they_are_not_of) {
  const scene::Scene scene = hard_scene("double_pendulum");
  for (const char* name : {"torque_free", "heavy_top", "kovalevskaya", "uniform_chain", "kepler", "bounce"})
    EXPECT_THROW(answer(name, scene), InputError) << name;
  EXPECT_THROW(answer("torque", scene), InputError);
}

}  // namespace
}  // namespace kanec::cli::hard::test
