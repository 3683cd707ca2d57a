// kanec eval --states as a user meets it: many states of a file, results of the same kind. Oracle: eval of one state.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <sstream>

#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class EvalStates : public Program {
 protected:
  void write(const std::string& name, const std::string& text) const { write_file(work() / name, text); }
  std::vector<std::string> eval(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"eval", model("cart_pole"), "accelerations"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
  const std::string header = "theta_pole,s_cart,thetadot_pole,sdot_cart\n";
};

TEST_F(EvalStates, results_are_those_of_one_state_at_a_time) {
  write("states.csv", header + "0.3,1,-2,0.5\n0.7,0,0.25,4\n");
  const Answer many = kanec(eval({"--states", "states.csv"}));
  EXPECT_EQ(many.status, 0) << many.err;
  std::istringstream lines(many.out);
  std::string line;
  std::getline(lines, line);
  EXPECT_EQ(line, "thetaddot_pole[rad/s^2],sddot_cart[m/s^2]");
  for (const char* state : {R"({"x": {"theta_pole": 0.3, "s_1": 1}, "y": {"thetadot_2": -2, "sdot_1": 0.5}})",
                            R"({"x": {"theta_2": 0.7, "s_1": 0}, "y": {"thetadot_2": 0.25, "sdot_1": 4}})"}) {
    const json one = json::parse(kanec(eval({"--input", "-", "--json"}), state).out).at("result").at("ydot");
    std::getline(lines, line);
    EXPECT_EQ(std::stod(line), one.at("thetaddot_pole").get<double>());
    EXPECT_EQ(std::stod(line.substr(line.find(',') + 1)), one.at("sddot_cart").get<double>());
  }
}

TEST_F(EvalStates, one_kind_becomes_another) {
  write("states.csv", header + "0.3,1,-2,0.5\n0.7,0,0.25,4\n");
  EXPECT_EQ(kanec(eval({"--states", "states.csv", "-o", "out.npy"})).status, 0);
  EXPECT_EQ(fs::file_size(work() / "out.npy"), 128u + 2 * 2 * 8);
  EXPECT_EQ(kanec(eval({"--states", "states.csv", "-o", "out.jsonl"})).status, 0);
  std::istringstream lines(read_file(work() / "out.jsonl"));
  std::string line;
  for (int i = 0; i < 2; ++i) {
    ASSERT_TRUE(std::getline(lines, line));
    EXPECT_TRUE(json::parse(line).at("ydot").at("thetaddot_pole").is_number());
  }
}

TEST_F(EvalStates, of_another_path_agree) {
  write("states.csv", header + "0.3,1,-2,0.5\n");
  const std::string emitted = kanec(eval({"--states", "states.csv"})).out,
                    generic = kanec(eval({"--states", "states.csv", "--path", "generic"})).out;
  EXPECT_NEAR(std::stod(emitted.substr(emitted.find('\n'))), std::stod(generic.substr(generic.find('\n'))), 1e-12);
}

TEST_F(EvalStates, a_trajectory_goes_in_as_it_comes_out) {
  EXPECT_EQ(kanec({"simulate", model("cart_pole"), "--duration", "0.1", "--csv", "run.csv"}).status, 0);
  EXPECT_EQ(kanec(eval({"--states", "run.csv", "-o", "out.csv"})).status, 0);
  const std::string text = read_file(work() / "out.csv"), run = read_file(work() / "run.csv");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), std::count(run.begin(), run.end(), '\n'));
}

TEST_F(EvalStates, one_bad_line_leaves_nothing) {
  write("states.csv", header + "0.3,1,-2,0.5\n0.7,0,oops,4\n");
  refuses(eval({"--states", "states.csv", "-o", "out.csv"}), "states.csv:3: thetadot_pole: found \"oops\"",
          {"states.csv"});
  refuses(eval({"--states", "states.csv", "--input", "-"}), "--states: found it beside --input", {"states.csv"});
  refuses(eval({"--format", "npy"}), "--format, --output: found without --states", {"states.csv"});
  refuses(eval({"--states", "states.csv", "--format", "npy"}), "no .npy file", {"states.csv"});
  refuses(eval({"--states", "none.csv"}), "none.csv: No such file", {"states.csv"});
}

TEST_F(EvalStates, set_values_hold_for_all) {
  write("states.csv", header + "0.3,1,-2,0.5\n");
  EXPECT_NE(kanec(eval({"--states", "states.csv", "--set", "push=3"})).out,
            kanec(eval({"--states", "states.csv"})).out);
}

TEST_F(EvalStates, names_by_body_are_taken_by_set_and_ensembles) {
  const json changed = json::parse(
      kanec({"eval", model("cart_pole"), "energy", "--template", "--set", "theta_pole=0.5", "--set", "sdot_1=2"}).out);
  EXPECT_EQ(changed.at("x").at("theta_pole"), 0.5);
  EXPECT_EQ(changed.at("y").at("sdot_cart"), 2);
  refuses({"eval", model("free_body"), "energy", "--template", "--set", "eps_1_4=1"}, "an Euler parameter alone");
  write("runs.csv", "theta_pole,push\n0.1,0\n0.2,1\n");
  EXPECT_EQ(kanec({"simulate", model("cart_pole"), "--duration", "0.1", "--integrator", "rk4", "--ensemble", "runs.csv",
                   "--json"})
                .status,
            0);
}

TEST_F(EvalStates, functions_tells_what_can_be_asked_for) {
  const std::string text = kanec({"functions", model("cart_pole")}).out;
  EXPECT_THAT(text, HasSubstr("accelerations_u"));
  const json list = json::parse(kanec({"functions", model("cart_pole"), "--json"}).out).at("functions");
  for (const json& function : list) {
    std::size_t size = 0;
    for (const json& block : function.at("blocks")) {
      std::size_t product = 1;
      for (const json& extent : block.at("shape")) product *= extent.get<std::size_t>();
      size += product;
    }
    EXPECT_EQ(size, function.at("size").get<std::size_t>()) << function.at("name");
  }
}

}  // namespace
}  // namespace kanec::cli::test
