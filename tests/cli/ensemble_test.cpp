// Oracles: `kanec simulate` of one scenario, and that the files say what the summary says.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <sstream>

#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

constexpr auto pendulum = R"(name = "drawn_pendulum"
connection = [0]
gravity = [0.0, 0.0, -9.81]
[parameters]
m = 1.0
[[body]]
joint = "revolute"
axis = "y"
mass = "m"
inertia = [0.1, 0.1, 0.1]
r = [0.0, 0.0, -1.0]
damping = 0.1
[simulate]
duration = 1.0
output_step = 0.25
integrator = "rk4"
step = 0.01
[ensemble]
count = 11
seed = 4
theta_1 = {uniform = [-0.5, 0.5]}
thetadot_1 = {normal = [0.0, 0.2]}
m = {uniform = [0.9, 1.1]}
)";

class EnsembleCommand : public Program {
 protected:
  EnsembleCommand() { write("scene.toml", pendulum); }
  static std::vector<std::string> lines(const std::string& text) {
    std::vector<std::string> list;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) list.push_back(line);
    return list;
  }
  static std::vector<double> numbers(const std::string& line) {
    std::vector<double> list;
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, ',');) list.push_back(std::stod(word));
    return list;
  }
};

TEST_F(EnsembleCommand, each_scenario_ends_where_it_ends_alone) {
  write("runs.csv", "# two\nthetadot_1 [rad/s], m\n0.5, 1.2\n\n-1e-1,+0.8\r\n");
  const json report = json_of({"simulate", "scene.toml", "--ensemble", "runs.csv", "--csv", "ends.csv", "--json"});
  EXPECT_EQ(report.at("finished"), 2);
  EXPECT_EQ(report.at("steps"), 200);
  const std::vector<std::string> ends = lines(read_file(work() / "ends.csv"));
  ASSERT_EQ(ends.size(), 3u);
  EXPECT_EQ(ends[0], "scenario,t[s],theta_1[rad],thetadot_1[rad/s],kinetic[J],potential[J],work[J]");
  const char* const speeds[] = {"0.5", "-0.1"};
  for (std::size_t j = 0; j < 2; ++j) {
    std::string alone = pendulum;
    alone.insert(alone.find("[simulate]"), std::string("[body.initial]\nthetadot = ") + speeds[j] + "\n");
    write("alone.toml", alone);
    const json one = json_of({"simulate", "alone.toml", "--json", "--set", j == 0 ? "m=1.2" : "m=0.8"});
    const std::vector<double> row = numbers(ends[j + 1]);
    EXPECT_EQ(row[0], static_cast<double>(j + 1));
    EXPECT_EQ(row[1], 1.0);
    // rounding of 400 evaluations
    EXPECT_NEAR(row[2], one.at("final").at("x").at("theta_1").get<double>(), 1e-13);
    EXPECT_NEAR(row[6], one.at("energy").at("work").get<double>(), 1e-13);
  }
}

TEST_F(EnsembleCommand, is_the_same_whatever_the_threads_and_as_drawn) {
  const auto run = [&](const std::vector<std::string>& more) {
    std::vector<std::string> words = {"simulate", "scene.toml", "--csv", "ends.csv"};
    words.insert(words.end(), more.begin(), more.end());
    EXPECT_EQ(kanec(words).status, 0);
    return read_file(work() / "ends.csv");
  };
  for (const char* method : {"rk4", "cvode"}) {
    const std::string ends =
        run({"--ensemble", "scene", "--threads", "1", "--drawn", "drawn.csv", "--integrator", method});
    EXPECT_EQ(lines(ends).size(), 12u);
    EXPECT_EQ(run({"--ensemble", "scene", "--threads", "3", "--integrator", method}), ends);
    EXPECT_EQ(run({"--ensemble", "drawn.csv", "--integrator", method}), ends);
    // further scenarios leave the first ones alone
    EXPECT_TRUE(run({"--ensemble", "scene", "--count", "20", "--integrator", method}).starts_with(ends));
    EXPECT_NE(run({"--ensemble", "scene", "--seed", "5", "--integrator", method}), ends);
  }
}

TEST_F(EnsembleCommand, draws_as_the_scene_says) {
  kanec({"simulate", "scene.toml", "--ensemble", "scene", "--count", "4000", "--drawn", "drawn.csv", "--duration",
         "0.01"});
  const std::vector<std::string> drawn = lines(read_file(work() / "drawn.csv"));
  ASSERT_EQ(drawn.size(), 4001u);
  EXPECT_EQ(drawn[0], "theta_1,thetadot_1,m");
  double sum = 0, squares = 0;
  for (std::size_t j = 1; j < drawn.size(); ++j) {
    const std::vector<double> row = numbers(drawn[j]);
    EXPECT_TRUE(row[0] >= -0.5 && row[0] < 0.5 && row[2] >= 0.9 && row[2] < 1.1);
    sum += row[1];
    squares += row[1] * row[1];
  }
  // four standard errors of the mean and of the deviation
  EXPECT_NEAR(sum / 4000, 0.0, 4 * 0.2 / std::sqrt(4000.0));
  EXPECT_NEAR(std::sqrt(squares / 4000), 0.2, 4 * 0.2 / std::sqrt(8000.0));
}

TEST_F(EnsembleCommand, reads_scenarios_from_standard_input_and_writes_ends_to_standard_output) {
  const Answer answer = kanec({"simulate", "scene.toml", "--ensemble", "-", "--csv", "-"}, "theta_1\n0.1\n0.2");
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_EQ(lines(answer.out).size(), 3u);
  EXPECT_THAT(answer.err, HasSubstr("2 finished"));
}

// The first speed's square is infinite.
TEST_F(EnsembleCommand, tells_of_a_scenario_that_stopped_and_refuses_where_all_did) {
  for (const char* method : {"rk4", "arkode"}) {
    write("runs.csv", "thetadot_1\n1e300\n0.1\n");
    const Answer some = kanec({"simulate", "scene.toml", "--ensemble", "runs.csv", "--integrator", method});
    EXPECT_EQ(some.status, 0) << some.err;
    EXPECT_THAT(some.out, HasSubstr("1 finished, 1 stopped"));
    EXPECT_THAT(some.out, HasSubstr("runs.csv:2: integration stopped"));
    write("runs.csv", "thetadot_1\n1e300\n");
    refuses({"simulate", "scene.toml", "--ensemble", "runs.csv", "--integrator", method, "--csv", "ends.csv"},
            "every scenario stopped; the first: runs.csv:2: integration stopped", {"runs.csv", "scene.toml"});
  }
}

TEST_F(EnsembleCommand, keeps_rows_on_request) {
  kanec({"simulate", "scene.toml", "--ensemble", "scene", "--count", "3", "--keep-every", "2", "--csv", "rows.csv"});
  const std::vector<std::string> rows = lines(read_file(work() / "rows.csv"));
  ASSERT_EQ(rows.size(), 10u);
  for (std::size_t i = 1; i < rows.size(); ++i) {
    EXPECT_EQ(numbers(rows[i])[0], std::floor(static_cast<double>(i + 2) / 3));
    EXPECT_EQ(numbers(rows[i])[1], 0.5 * static_cast<double>((i - 1) % 3));
  }
}

TEST_F(EnsembleCommand, tells_the_spread_and_the_energy_in_text) {
  const Answer answer = kanec({"simulate", "scene.toml", "--ensemble", "scene", "--threads", "2"});
  EXPECT_EQ(answer.status, 0) << answer.err;
  for (const char* part :
       {"11 finished, 0 stopped", "side by side", "2 threads", "energy change minus work", "deviation", "\n  theta_1 "})
    EXPECT_THAT(answer.out, HasSubstr(part));
}

TEST_F(EnsembleCommand, says_where_a_scenario_is_wrong) {
  const auto refused = [&](const std::string& csv, const std::string& message) {
    write("runs.csv", csv);
    refuses({"simulate", "scene.toml", "--ensemble", "runs.csv"}, message, {"runs.csv", "scene.toml"});
  };
  refused("", "runs.csv: found nothing; allowed: a header line of names and a line a scenario");
  refused("theta_1\n", "runs.csv: found a header alone;");
  refused(
      "theta_1,tehta_1\n1,2\n",
      "runs.csv:1: column 2: found \"tehta_1\"; allowed: a coordinate, speed, parameter or input of drawn_pendulum: "
      "theta_1, thetadot_1, m (did you mean theta_1?)");
  refused("m,m\n1,2\n", "runs.csv:1: column 2: found \"m\" twice; allowed: each name once");
  refused("m,theta_1\n1,2\n# x\n3\n", "runs.csv:4: found 1 numbers; allowed: 2, one a column of the header");
  refused("m,theta_1\n1,2\n3,x\n", "runs.csv:3: theta_1: found \"x\"; allowed: a finite number");
  refused("m,theta_1\n1,\n", "runs.csv:2: theta_1: found nothing; allowed: a finite number");
  refused("m\ninf\n", "runs.csv:2: m: found \"inf\"; allowed: a finite number");
  refused("m\n1\n-1\n", "runs.csv:3: body 1: mass: found m = -1; allowed: a positive number");
}

TEST_F(EnsembleCommand, refuses_options_that_do_not_go_together) {
  const std::vector<std::string> files = {"scene.toml"};
  refuses({"simulate", "scene.toml", "--threads", "2"}, "found without --ensemble; allowed: with it", files);
  refuses({"simulate", "scene.toml", "--ensemble", "scene", "--plot", "a.svg"}, "--plot, --final: found beside", files);
  refuses({"simulate", "scene.toml", "--ensemble", "none.csv"}, "none.csv", files);
  refuses({"simulate", "scene.toml", "--ensemble", "a.csv", "--csv", "a.csv"}, "found 'a.csv' twice", files);
  refuses({"simulate", "scene.toml", "--ensemble", "scene", "--csv", "-", "--drawn", "-"}, "found '-' twice", files);
  refuses({"simulate", "scene.toml", "--ensemble", "scene", "--drawn", "-", "--json"}, "--json: found it beside",
          files);
  refuses({"simulate", "scene.toml", "--ensemble", "x.csv", "--seed", "2"}, "allowed: with --ensemble scene", files);
  refuses({"simulate", model("pendulum"), "--ensemble", "scene"}, "draws nothing; allowed: a scene whose [ensemble]",
          files);
}

TEST_F(EnsembleCommand, normalises_attitudes_and_says_so) {
  write("runs.csv", "eps_1_1,eps_1_4\n0,2\n0.6,0.8\n");
  const Answer answer = kanec({"simulate", model("free_body"), "--ensemble", "runs.csv", "--duration", "0.1"});
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_THAT(answer.err, HasSubstr("Euler parameters of "));
  write("zero.csv", "eps_1_1,eps_1_2,eps_1_3,eps_1_4\n0,0,0,0\n");
  refuses({"simulate", model("free_body"), "--ensemble", "zero.csv"},
          "zero.csv:2: eps_handle: found norm 0; allowed: Euler parameters, of which one is not zero",
          {"runs.csv", "scene.toml", "zero.csv"});
}

}  // namespace
}  // namespace kanec::cli::test
