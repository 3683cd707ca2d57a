// Steps by Taylor series. Oracles: closed forms, Gauss collocation at a small step, and the conservation laws.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "generator/read/read.hpp"
#include "runtime/base/error.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/trajectory/simulate.hpp"
#include "tests/support/compiled.hpp"

namespace kanec::test {
namespace {

using integrate::Method;
using integrate::Options;
using testing::HasSubstr;
using testing::ThrowsMessage;

class Motion {
 public:
  explicit Motion(scene::Scene scene)
      : scene_(std::move(scene)), model_(compiled(generate(scene_, request(scene_)), scene_)) {}
  explicit Motion(const std::string& text) : Motion(scene::parse(text, "scene.toml")) {}

  static Motion of(const std::string& model) {
    return Motion(scene::read(std::string(KANEC_SOURCE_DIR) + "/models/" + model + "/scene.toml"));
  }

  Summary run(const Options& options, const Observer& observer = {}) const {
    return simulate(Solver(model_.abi()), scene::initial_coordinates(scene_), scene::initial_speeds(scene_), options,
                    observer);
  }
  std::vector<double> end(const Options& options) const {
    const Summary summary = run(options);
    std::vector<double> z = summary.x;
    z.insert(z.end(), summary.y.begin(), summary.y.end());
    return z;
  }

 private:
  static GenerateOptions request(const scene::Scene& scene) {
    std::vector<std::string> functions = all_rates(scene);
    functions.insert(functions.end(), {"energy", "momentum"});
    return {.functions = functions, .with_taylor = true};
  }

  scene::Scene scene_;
  compile::Model model_;
};

Options options(Method method, double tolerance, double duration) {
  Options options;
  options.method = method;
  options.relative_tolerance = tolerance;
  options.absolute_tolerance = 0.01 * tolerance;
  options.duration = duration;
  options.output_step = duration;
  return options;
}

double difference(const std::vector<double>& a, const std::vector<double>& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = integrate::worse(worst, std::fabs(a[i] - b[i]));
  return worst;
}

// The errors of a step are those of its last term; 2 s of this motion amplify them by less than 1000.
TEST(TaylorMotion, error_falls_with_the_tolerance_down_to_rounding) {
  const Motion pendulum = Motion::of("double_pendulum");
  Options fine = options(Method::gauss6, 0, 2.0);
  fine.relative_tolerance = fine.absolute_tolerance = 1e-9;  // not used
  fine.step = 1e-3;
  const std::vector<double> right = pendulum.end(options(Method::taylor_extended, 1e-18, 2.0));
  EXPECT_LT(difference(pendulum.end(fine), right), 1e-12);
  for (const double tolerance : {1e-5, 1e-8, 1e-11})
    EXPECT_LT(difference(pendulum.end(options(Method::taylor, tolerance, 2.0)), right), 1000 * tolerance) << tolerance;
  EXPECT_LT(difference(pendulum.end(options(Method::taylor, 1e-16, 2.0)), right), 1e-13);  // 1000 roundings
}

TEST(TaylorMotion, takes_few_long_steps) {
  const Summary summary = Motion::of("bench_s6b").run(options(Method::taylor, 1e-12, 10.0));
  EXPECT_LT(summary.steps, 60);
  EXPECT_EQ(summary.failed, 0);
  EXPECT_EQ(summary.evaluations, summary.steps + 1);
  EXPECT_LT(summary.energy->worst.relative(), 1e-14);
  EXPECT_LT(summary.worst_norm_error_before, 1e-12);
}

// The polynomial of a step tells every state in it.
TEST(TaylorMotion, rows_do_not_change_the_steps) {
  const Motion handle = Motion::of("t_handle");
  Options once = options(Method::taylor, 1e-13, 3.0), often = once;
  often.output_step = 1e-3;
  std::vector<double> middle;
  const Summary many = handle.run(often, [&](const Row& row) {
    if (std::fabs(row.t - 1.5) < 1e-9) middle.assign(row.y.begin(), row.y.end());
  });
  EXPECT_EQ(many.steps, handle.run(once).steps);
  EXPECT_EQ(many.x, handle.run(once).x);
  once.duration = once.output_step = 1.5;
  EXPECT_LT(difference(handle.run(once).y, middle), 1e-11);
}

// A mass of 1 kg along x under an effort; `initial`: how it begins, else at rest in 0.
std::string slide(const std::string& effort, const std::string& initial = "") {
  return "name = 'slide'\nconnection = [0]\n[[body]]\njoint = 'prismatic'\naxis = 'x'\nmass = 1.0\ninertia = [0, 0, "
         "0]\n"
         "effort = '" +
         effort + "'\n[body.initial]\n" + initial + "\n";
}

const std::string bouncing = slide("-max(0, s_1) * 400 - 100 * s_1", "s = -0.3");

// Frequency 10 rad/s on one side of 0, sqrt(500) on the other: the closed form from crossing to crossing.
TEST(TaylorMotion, halves_a_step_at_a_kink) {
  const double pi = std::acos(-1.0), slow = 10, fast = std::sqrt(500.0), period = pi / slow + pi / fast;
  const Motion motion{bouncing};
  Options run = options(Method::taylor, 1e-10, 5 * period);
  const Summary summary = motion.run(run);
  EXPECT_NEAR(summary.x[0], -0.3, 1e-6);
  EXPECT_NEAR(summary.y[0], 0.0, 1e-5);
  EXPECT_GT(summary.failed, 0);
  EXPECT_LT(summary.steps, 2000);
}

const std::string flying = slide("-max(0, s_1) * 1e6", "s = -1.0\nsdot = 2.0");

// The series in free flight ends after its second term, and no step would be too long: half a swing of pi / 1000 s on
// the spring, and back.
TEST(TaylorMotion, a_flight_without_forces_ends_at_a_kink) {
  const double swing = std::acos(-1.0) / 1000;
  const Summary summary = Motion(flying).run(options(Method::taylor, 1e-12, 1.0 + swing));
  EXPECT_NEAR(summary.x[0], -1.0, 1e-9);
  EXPECT_NEAR(summary.y[0], -2.0, 1e-9);
  EXPECT_LT(summary.steps, 100);
}

const std::string falling_in = slide("-1 / s_1^2", "s = 1.0");

const std::string dipping = slide("min(sin(3*t), 0.3)");

// With 0.3 the series is a polynomial, whose step would go over all dips of the sine. sdot(10) by quadrature between
// the kinks a = asin(0.3)/3, b = pi/3 - a, and so on: -1.6317775. Each of ten is passed where rates differ by less than
// 10 orders of tolerances: 2e-10.
TEST(TaylorMotion, does_not_step_over_a_load_that_comes_back) {
  const double pi = std::acos(-1.0), a = std::asin(0.3) / 3, end = 10.0;
  double expected = 0.0;
  for (int n = 0; n < 5; ++n) {
    const double turn = 2 * pi / 3 * n, up = turn + a, down = turn + pi / 3 - a, next = turn + 2 * pi / 3;
    const auto sine = [](double from, double to) { return (std::cos(3 * from) - std::cos(3 * to)) / 3; };
    const auto till = [end](double t) { return std::min(t, end); };
    expected += sine(till(turn), till(up)) + 0.3 * (till(down) - till(up)) + sine(till(down), till(next));
  }
  EXPECT_NEAR(expected, -1.6317775, 1e-7);
  Options run = options(Method::taylor, 1e-12, end);
  run.has_kinks = true;
  const Motion motion{dipping};
  EXPECT_NEAR(motion.run(run).y[0], expected, 2e-9);
  run.method = Method::taylor_extended;
  EXPECT_NEAR(motion.run(run).y[0], expected, 2e-9);
}

TEST(TaylorMotion, where_rates_are_finite_and_not_smooth_says_so) {
  const Motion motion{slide("-sqrt(sdot_1^2)", "s = 1.0")};
  EXPECT_THAT([&] { motion.run(options(Method::taylor, 1e-10, 2.0)); },
              ThrowsMessage<IntegrationError>(HasSubstr("has no Taylor series: it is not smooth there")));
}

// Free fall into the centre takes pi / (2 sqrt 2) s.
TEST(TaylorMotion, stops_at_a_singularity_and_tells_when) {
  const Motion motion{falling_in};
  EXPECT_THAT([&] { motion.run(options(Method::taylor, 1e-10, 2.0)); },
              ThrowsMessage<IntegrationError>(HasSubstr("stopped at t = 1.1107")));
}

TEST(TaylorMotion, needs_a_model_with_series) {
  const scene::Scene scene = scene::parse(bouncing, "scene.toml");
  const compile::Model model = compiled(generate(scene, {.functions = all_rates(scene)}), scene);
  const auto run = [&] {
    simulate(Solver(model.abi()), scene::initial_coordinates(scene), scene::initial_speeds(scene),
             options(Method::taylor, 1e-10, 1.0));
  };
  EXPECT_THAT(run, ThrowsMessage<InputError>(HasSubstr("without the Taylor series")));
}

}  // namespace
}  // namespace kanec::test
