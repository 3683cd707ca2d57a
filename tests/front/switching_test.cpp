// Loads that switch or saturate, by the default integrator with default tolerances, for any distance of rows.
// Oracle: closed forms for the block and the wave; for the floors a small-step integration from piece to piece (SciPy's
// DOP853 at 1e-12).
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>

#include <cmath>

#include "tests/front/bench.hpp"

namespace kanec::test {
namespace {

struct Switching {
  std::string name, axis, effort;
  double gravity, mass, s, sdot, duration;
  double right_s, right_sdot;
};

void PrintTo(const Switching& one, std::ostream* out) { *out << one.name; }

class SwitchingLoads : public testing::TestWithParam<Switching> {
 protected:
  static Scene scene() {
    const Switching& one = GetParam();
    return Scene::build({{"name", one.name},
                         {"connection", List{0}},
                         {"gravity", std::vector<double>{0, 0, one.gravity}},
                         {"body", List{Table{{"name", "block"},
                                             {"joint", "prismatic"},
                                             {"axis", one.axis},
                                             {"mass", one.mass},
                                             {"inertia", std::vector<double>{0, 0, 0}},
                                             {"effort", one.effort},
                                             {"initial", Table{{"s", one.s}, {"sdot", one.sdot}}}}}}});
  }
};

TEST_P(SwitchingLoads, are_integrated_to_a_hundred_tolerances_for_any_rows) {
  auto run = scene().run();
  run.duration = GetParam().duration;
  for (const double output_step : {0.003, 0.01, 0.1}) {
    run.output_step = output_step;
    const Motion motion = scene().simulate(run, shared_cache());
    const std::size_t last = motion.rows() - 1;
    const double allowed = 100 * run.relative_tolerance;
    EXPECT_NEAR(motion.x_at(last)[0], GetParam().right_s, allowed) << output_step;
    EXPECT_NEAR(motion.y_at(last)[0], GetParam().right_sdot, allowed) << output_step;
  }
}

// Friction without a slope at rest: the block stops at 10/3 s, and the load switches there for ever.
TEST(SwitchingLoad, that_no_step_gets_past_is_told) {
  const Scene scene = Scene::parse(R"toml(
name = "chatter"
connection = [0]
[[body]]
name = "block"
joint = "prismatic"
axis = "x"
mass = 1
inertia = [0, 0, 0]
effort = "-0.3*sdot_block/abs(sdot_block)"
initial = {sdot = 1.0}
[simulate]
duration = 5.0
)toml");
  for (const char* integrator : {"dop853", "arkode", "cvode_bdf", "ida"}) {
    auto run = scene.run();
    run.integrator = integrator;
    const std::string said = refusal<IntegrationError>([&] { scene.simulate(run, shared_cache()); });
    EXPECT_THAT(said, testing::StartsWith("integration stopped at t = 3.33333")) << integrator;
    EXPECT_THAT(said, testing::HasSubstr("sdot_block: a load that switches back and forth")) << integrator;
  }
}

std::string floor_of(const std::string& k, const std::string& d) {
  return k + "*max(0, -s_block)^1.5*max(0, 1 - " + d + "*sdot_block)";
}

// Stops at v^2/(2 mu g) + pi^2 e^2/(12 mu g).
double stopping_place(double v, double mu, double g, double e) {
  return v * v / (2 * mu * g) + M_PI * M_PI * e * e / (12 * mu * g);
}

INSTANTIATE_TEST_SUITE_P(
    Found, SwitchingLoads,
    testing::Values(
        Switching{"floor_1", "z", floor_of("4e6", "0.2"), -9.81, 0.3, 0.5, 0, 1.0, 0.1310970552, -0.5262633770},
        Switching{"floor_2", "z", floor_of("3e7", "0.08"), -9.81, 2.0, 0.7, 0, 1.2, 0.3223453693, 0.8258557497},
        Switching{"floor_3", "z", floor_of("2e8", "0.03"), -9.81, 5.0, 1.3, 0, 2.0, 0.8298911244, -1.1587869848},
        Switching{"friction", "x", "-0.4*1.5*9.81*tanh(sdot_block/2e-4)", 0, 1.5, 0, 2.5, 3.0,
                  stopping_place(2.5, 0.4, 9.81, 2e-4), 0},
        Switching{"square_wave", "x", "tanh(800*sin(16*pi*t))", 0, 1.0, 0, 0, 0.91, 0.0279405644342, 0.0349827627350}));

}  // namespace
}  // namespace kanec::test
