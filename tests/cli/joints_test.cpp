// The commands on scenes of other joints than free ones. Oracles: closed forms; kanec check's own two.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <numbers>

#include "runtime/base/text.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

constexpr auto pendulum = R"toml(
name = "pendulum"
connection = [0]
gravity = [0.0, 0.0, -9.81]
[[body]]
joint = "revolute"
axis = "y"
mass = 2.0
inertia = [0.0, 0.05, 0.0]
r = [0.0, 0.0, -0.5]
[body.initial]
theta = 0.01
)toml";

// A cart moved as prescribed, a pendulum on it, a ball hanging from that, a spring, a driven and a locked slide.
constexpr auto crane = R"toml(
name = "crane"
connection = [0, 1, 2]
gravity = [0.0, 0.0, -9.81]
[parameters]
amplitude = 0.2
spare = 1.0
[inputs]
torque = 0.1
[[body]]
name = "cart"
joint = "cartesian"
mass = 3.0
inertia = [0.1, 0.1, 0.1]
[body.motion]
s = ["amplitude*sin(3*t)", 0.25, "free"]
[[body]]
name = "arm"
joint = "revolute"
axis = [0.1, 1.0, 0.2]
mass = 1.0
inertia = [0.1, 0.12, 0.08]
r = [0.0, 0.1, -0.3]
moment = ["torque", 0.0, 0.0]
stiffness = 2.0
damping = 0.1
[[body]]
name = "load"
joint = "ball"
mass = 0.5
inertia = [0.02, 0.03, 0.04]
q = [0.0, 0.0, -0.6]
r = [0.0, 0.0, -0.2]
[body.initial]
eps = [0.1, 0.2, 0.3, 0.9]
[[load]]
name = "tie"
kind = "spring"
body = "ground"
r = [1.0, 0.0, 0.0]
other_body = "load"
stiffness = 10.0
rest = 0.5
[[point]]
name = "hook"
body = "load"
r = [0.0, 0.0, -0.3]
)toml";

class Joints : public Program {
 protected:
  Joints() {
    write("pendulum.toml", pendulum);
    write("crane.toml", crane);
  }
};

TEST_F(Joints, every_function_agrees_with_both_oracles) {
  const json report = json_of({"check", "crane.toml", "--all", "--states", "8", "--json"});
  EXPECT_TRUE(report.at("passed"));
  std::vector<std::string> names;
  for (const json& function : report.at("functions")) {
    names.push_back(function.at("name"));
    EXPECT_EQ(function.at("undefined_states"), 0) << function.dump();
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"driving_loads", "load_powers", "reactions", "hook_jacobian",
                                            "state_matrix", "accelerations_u", "partial_angular_velocities"}));
}

// I θ̈ = -m g l sin θ about the pivot, period 2π √(I / m g l) (1 + θ²/16 + …); the next term is 4e-11 at 0.01 rad.
TEST_F(Joints, pendulum_comes_back_after_its_period) {
  const double inertia = 0.05 + 2.0 * 0.25, small = 2.0 * std::numbers::pi * std::sqrt(inertia / (2.0 * 9.81 * 0.5));
  const double period = small * (1.0 + 0.01 * 0.01 / 16.0);
  const json summary = json_of({"simulate", "pendulum.toml", "--duration", shortest(period), "--json"});
  // a hundred steps with a local error of 1e-9 of 0.01 rad, and 0.04 rad/s
  EXPECT_NEAR(summary.at("final").at("x").at("theta_1"), 0.01, 1e-9);
  EXPECT_NEAR(summary.at("final").at("y").at("thetadot_1"), 0.0, 4e-9);
  EXPECT_TRUE(summary.at("energy").at("balanced"));
  EXPECT_LT(summary.at("energy").at("worst").at("relative"), 1e-8);
}

TEST_F(Joints, trajectories_have_the_names_of_what_moves) {
  const Answer answer = kanec({"simulate", "crane.toml", "--duration", "0.1", "--csv", "-"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  EXPECT_THAT(answer.out,
              testing::StartsWith(
                  "t[s],theta_arm[rad],eps_load_1,eps_load_2,eps_load_3,eps_load_4,s_cart_3[m],thetadot_arm[rad/s],"
                  "omega_load_1[rad/s],omega_load_2[rad/s],omega_load_3[rad/s],sdot_cart_3[m/s],kinetic[J],"));
  EXPECT_THAT(answer.err, HasSubstr("work of prescribed motions"));  // the summary, out of the way
}

TEST_F(Joints, states_have_a_time_and_the_names_of_what_moves) {
  json state = json_of({"eval", "crane.toml", "driving_loads", "--template"});
  EXPECT_EQ(state.at("t"), 0.0);
  EXPECT_EQ(state.at("x").at("theta_arm"), 0.0);
  EXPECT_EQ(state.at("x").at("s_cart_3"), 0.0);
  state["t"] = 0.5;
  const auto result = [&](const std::string& function, const std::string& path) {
    return json_of({"eval", "crane.toml", function, "--path", path, "--input", "-", "--json"}, state.dump())
        .at("result");
  };
  const json drives = result("driving_loads", "emitted").at("driving_loads");
  EXPECT_EQ(drives.size(), 2u);
  const double drive = drives.at("s_cart_1");
  // some hundred roundings of forces of tens of newtons
  EXPECT_NEAR(drive, result("driving_loads", "generic").at("driving_loads").at("s_cart_1").get<double>(), 1e-12);
  const json both = result("energy+load_powers", "emitted");
  EXPECT_TRUE(both.at("energy").contains("kinetic"));
  EXPECT_TRUE(both.at("load_powers").contains("tie"));
  EXPECT_TRUE(both.at("load_powers").contains("body arm"));
}

TEST_F(Joints, parameters_that_nothing_reads_keep_their_place) {
  const Answer answer =
      kanec({"simulate", "crane.toml", "--duration", "0.1", "--set", "spare=2", "--set", "amplitude=0", "--json"});
  ASSERT_EQ(answer.status, 0) << answer.err;
  const json final_state = json::parse(answer.out).at("final");
  EXPECT_EQ(final_state.at("parameters").at("spare"), 2.0);
  EXPECT_EQ(final_state.at("t"), 0.1);
}

TEST_F(Joints, dumped_scene_gives_the_same_code) {
  EXPECT_EQ(kanec({"generate", "crane.toml", "--dump", "scene", "-o", "again.toml"}).status, 0);
  EXPECT_EQ(json_of({"generate", "crane.toml", "--json"}).at("hash"),
            json_of({"generate", "again.toml", "--json"}).at("hash"));
}

}  // namespace
}  // namespace kanec::cli::test
