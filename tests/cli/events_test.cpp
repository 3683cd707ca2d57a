// Events, failing runs and runs that go on from a trajectory, by the program. Oracles: other integrators, the whole
// run.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>

#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

constexpr auto swing = R"(
name = "swing"
connection = [0]
gravity = [0.0, 0.0, -9.81]
[inputs]
k = 0.0
[[body]]
name = "rod"
joint = "revolute"
axis = "y"
mass = 1.2
inertia = [0.1, 0.1, 0.0]
r = [0.0, 0.0, -0.5]
effort = "-k*theta_rod"
[body.initial]
theta = 2.0
[[event]]
name = "bottom"
expression = "theta_rod"
direction = "down"
set = { k = 20.0 }
row = true
[[event]]
name = "turn"
expression = "thetadot_1"
[simulate]
duration = 2.0
output_step = 0.5
relative_tolerance = 1e-11
absolute_tolerance = 1e-13
)";

class Events : public Program {
 protected:
  std::string swing_with(const std::string& more) const { return write("swing.toml", std::string(swing) + more); }
};

// Tolerances of 1e-11 a step; rk4 with steps of 1 ms in motions of 6 rad/s: 1e-10.
TEST_F(Events, are_found_alike_by_all_integrators_and_in_the_json_summary) {
  const std::string scene = swing_with("");
  const json expected = json_of({"simulate", scene, "--json", "--integrator", "gauss6"}).at("events");
  ASSERT_EQ(expected.size(), 6u);  // down through the bottom twice, four turns
  EXPECT_EQ(expected[0].at("name"), "bottom");
  EXPECT_EQ(expected[0].at("direction"), "down");
  EXPECT_EQ(expected[1].at("name"), "turn");
  for (const std::string integrator : {"rk4", "dop853", "arkode", "cvode", "ida", "arkode_dirk", "taylor"}) {
    const json found = json_of({"simulate", scene, "--json", "--integrator", integrator}).at("events");
    ASSERT_EQ(found.size(), expected.size()) << integrator;
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(found[i].at("name"), expected[i].at("name"));
      EXPECT_NEAR(found[i].at("t").get<double>(), expected[i].at("t").get<double>(), 1e-8) << integrator;
    }
  }
}

TEST_F(Events, have_rows_and_set_columns) {
  const Answer answer = kanec({"simulate", swing_with(""), "--csv", "-"});
  const std::vector<std::string> rows = lines_of(answer.out);
  EXPECT_THAT(rows.at(0), testing::EndsWith(",work[J],k"));
  EXPECT_THAT(rows.at(2), testing::EndsWith(",0"));
  EXPECT_THAT(rows.at(3), testing::AllOf(testing::StartsWith("0.544168627"), testing::EndsWith(",20")));  // the bottom
  EXPECT_THAT(rows.at(4), testing::EndsWith(",20"));
  EXPECT_THAT(answer.err, HasSubstr("s: bottom, down, inputs set"));
}

TEST_F(Events, stop_the_run) {
  const std::string scene = swing_with("[[event]]\nname = 'end'\nexpression = 't - 1.3'\naction = 'stop'\n");
  const json summary = json_of({"simulate", scene, "--json"});
  EXPECT_EQ(summary.at("stopped_by_event"), true);
  EXPECT_NEAR(summary.at("end").get<double>(), 1.3, 1e-15);  // two roundings
  EXPECT_EQ(summary.at("final").at("inputs").at("k"), 20.0);
}

TEST_F(Events, are_a_function_of_the_scene_in_every_path) {
  const std::string scene = swing_with("");
  const std::string state = kanec({"eval", scene, "events", "--template"}).out;
  for (const std::string path : {"emitted", "generic"}) {
    const Answer answer = kanec({"eval", scene, "events", "--path", path, "--input", "-"}, state);
    EXPECT_THAT(answer.out, HasSubstr("2.0000000000000000e+00")) << path << answer.err;
  }
  EXPECT_THAT(kanec({"generate", model("pendulum"), "--functions", "events", "-o", "x"}).err,
              HasSubstr("events, which a scene without events does not have"));
}

TEST_F(Events, are_refused_in_ensembles) {
  write("runs.csv", "theta_1\n0.1\n");
  refuses({"simulate", swing_with(""), "--ensemble", "runs.csv"}, "--ensemble: found a scene with [[event]] tables",
          {"runs.csv", "swing.toml"});
}

// With equal steps between rows the rest is the same to the last bit.
TEST_F(Events, of_a_resumed_run_are_the_rest) {
  const std::string scene = swing_with("");
  const std::vector<std::string> rk4 = {"simulate", scene, "--integrator", "rk4", "--csv"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> arguments = rk4;
    arguments.insert(arguments.end(), more.begin(), more.end());
    return kanec(arguments).status;
  };
  EXPECT_EQ(with({"whole.csv"}), 0);
  EXPECT_EQ(with({"part.csv", "--duration", "1"}), 0);
  EXPECT_EQ(with({"./part.csv", "--resume", "part.csv"}), 0);
  EXPECT_EQ(read_file(work() / "part.csv"), read_file(work() / "whole.csv"));
  const std::string text = read_file(work() / "whole.csv");
  write("cut.csv", text.substr(0, text.size() - 9));  // within the last row
  EXPECT_EQ(with({"other.csv", "--resume", "cut.csv"}), 0);
  const std::vector<std::string> whole = lines_of(text), rest = lines_of(read_file(work() / "other.csv"));
  EXPECT_EQ(rest.back(), whole.back());
  EXPECT_LT(rest.size(), whole.size());
}

TEST_F(Events, of_a_run_that_goes_on_from_lines_of_windows_are_the_same) {
  const std::string scene = swing_with("");
  EXPECT_EQ(kanec({"simulate", scene, "--csv", "unix.csv", "--duration", "1"}).status, 0);
  std::string text;
  for (const std::string& line : lines_of(read_file(work() / "unix.csv"))) text += line + "\r\n";
  write("windows.csv", text);
  for (const std::string name : {"unix.csv", "windows.csv"})
    EXPECT_EQ(kanec({"simulate", scene, "--resume", name, "--csv", name}).status, 0);
  EXPECT_EQ(read_file(work() / "windows.csv"), read_file(work() / "unix.csv"));
}

// The event is over there, and what it set is in its row.
TEST_F(Events, of_a_run_that_goes_on_from_one_keep_what_it_set) {
  const std::string scene = swing_with("");
  EXPECT_EQ(kanec({"simulate", scene, "--csv", "whole.csv"}).status, 0);
  const std::vector<std::string> whole = lines_of(read_file(work() / "whole.csv"));
  write("cut.csv", whole[0] + "\n" + whole[1] + "\n" + whole[2] + "\n" + whole[3] + "\n");  // 3: the bottom
  EXPECT_EQ(kanec({"simulate", scene, "--resume", "cut.csv", "--csv", "rest.csv"}).status, 0);
  const std::vector<std::string> rest = lines_of(read_file(work() / "rest.csv"));
  EXPECT_EQ(rest.size(), whole.size() - 2);  // the header and the row it goes on from stand in both
  const auto angle = [](const std::string& row) { return std::stod(row.substr(row.find(',') + 1)); };
  EXPECT_NEAR(angle(rest.back()), angle(whole.back()), 1e-8);
  refuses({"simulate", scene, "--resume", "cut.csv", "--plot", "cut.csv"}, "--resume: found its file 'cut.csv'",
          {"cut.csv", "rest.csv", "swing.toml", "whole.csv"});
}

TEST_F(Events, keep_inputs_of_a_trajectory_from_being_set) {
  const std::string scene = swing_with("");
  EXPECT_EQ(kanec({"simulate", scene, "--csv", "a.csv", "--duration", "1"}).status, 0);
  refuses({"simulate", scene, "--resume", "a.csv", "--set", "k=3"},
          "--set: found 'k=3' beside --resume; allowed: inputs that are no column of a.csv, which holds the value of k",
          {"a.csv", "swing.toml"});
}

TEST_F(Events, of_no_trajectory_are_no_start) {
  const std::string scene = swing_with("");
  const std::string columns = "t[s],theta_1[rad],thetadot_1[rad/s],kinetic[J],potential[J],work[J]";
  const std::vector<std::pair<std::string, std::string>> refused = {
      {"t[s],theta_1[rad]", "no column 3; allowed: \"thetadot_rod[rad/s]\" of a trajectory of swing"},
      {"t[s],theta_2[rad],thetadot_1[rad/s]", "\"theta_2[rad]\" in column 2; allowed: \"theta_rod[rad]\""},
      {columns, "no column 7; allowed: \"k\""},
      {columns + ",k,F", "\"F\" in column 8; allowed: 7 columns of a trajectory of swing"}};
  for (const auto& [found, message] : refused) {
    write("a.csv", found + "\n0,1\n");
    refuses({"simulate", scene, "--resume", "a.csv"}, "a.csv:1: found " + message, {"a.csv", "swing.toml"});
  }
  write("a.csv", "t[s]");
  refuses({"simulate", scene, "--resume", "a.csv"}, "a.csv:1: found no full line", {"a.csv", "swing.toml"});
  const std::string header = columns + ",k\n";
  write("a.csv", header);
  refuses({"simulate", scene, "--resume", "a.csv"}, "a.csv:2: found no full row", {"a.csv", "swing.toml"});
  write("a.csv", header + "0,nan,0,0,0,0,0\n");
  refuses({"simulate", scene, "--resume", "a.csv"}, "a.csv:2: found \"0,nan,0,0,0,0,0\"", {"a.csv", "swing.toml"});
  write("a.csv", header + "3,1,0,0,0,0,0\n");
  refuses({"simulate", scene, "--resume", "a.csv"}, "--resume: found a trajectory until 3 s", {"a.csv", "swing.toml"});
}

TEST_F(Events, of_a_failing_run_stay_in_its_rows_and_the_message_says_where) {
  const std::string scene =
      write("fails.toml", std::string(swing).replace(std::string(swing).find("-k*theta_rod"), 12, "sqrt(1.2 - t)"));
  for (const std::string integrator : {"arkode", "cvode", "rk4", "ida"}) {
    const Answer answer = kanec({"simulate", scene, "--integrator", integrator, "--csv", "rows.csv"});
    EXPECT_NE(answer.status, 0);
    EXPECT_THAT(answer.err,
                HasSubstr("the rate of thetadot_rod is not finite (body 1, rod); the rows until there are in "
                          "rows.csv"));
    const std::vector<std::string> rows = lines_of(read_file(work() / "rows.csv"));
    EXPECT_GE(rows.size(), 4u) << integrator;  // the header, 0, 0.5, an event or more, 1
    EXPECT_THAT(read_file(work() / "rows.csv"), Not(HasSubstr("nan")));
  }
}

}  // namespace
}  // namespace kanec::cli::test
