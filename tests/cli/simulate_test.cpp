// Oracles: conservation of energy and momentum, and that the files say what the summary says.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <sstream>

#include "tests/base/small_disk.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Simulate : public Program {
 protected:
  std::vector<std::string> run(const std::string& name, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"simulate", model(name), "--duration", "0.5", "--output-step", "0.125"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }
};

std::vector<std::vector<std::string>> cells(const std::string& csv) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    rows.emplace_back();
    std::istringstream words(line);
    for (std::string word; std::getline(words, word, ',');) rows.back().push_back(word);
  }
  return rows;
}

// All numbers of x and y, in state order.
std::vector<double> flat(const json& state) {
  std::vector<double> numbers;
  for (const char* part : {"x", "y"})
    for (const char* prefix : {"eps", "s_", "omega", "sdot"})
      for (const auto& [name, values] : state.at(part).items())
        if (name.starts_with(prefix))
          for (const double value : values) numbers.push_back(value);
  return numbers;
}

TEST_F(Simulate, summary_tells_of_norms_where_there_are_attitudes_alone) {
  EXPECT_THAT(kanec(run("six_body", {})).out, HasSubstr("worst | |eps| - 1 |"));
  EXPECT_THAT(kanec(run("pendulum", {})).out, testing::Not(HasSubstr("|eps|")));
}

TEST_F(Simulate, energy_follows_the_work_and_the_summary_says_so) {
  const json summary = json_of(run("six_body", {"--json"}));
  EXPECT_EQ(summary.at("rows"), 5);
  EXPECT_EQ(summary.at("integrator"), "dop853");
  EXPECT_GT(summary.at("steps"), 0);
  EXPECT_GE(summary.at("evaluations"), summary.at("steps"));
  EXPECT_NE(summary.at("energy").at("work"), 0.0);
  // hundred steps with a local error of 1e-9 each; most of it averages out
  EXPECT_LT(summary.at("energy").at("worst").at("relative"), 1e-8);
  EXPECT_LT(summary.at("norm_error").at("in_rows"), 1e-15);  // projected: some roundings
  const Answer text = kanec(run("six_body", {}));
  for (const char* word : {"steps", "evaluations of", "wall time", "energy change minus work", "linear momentum",
                           "angular momentum", "not kept", "at the ends of steps"})
    EXPECT_THAT(text.out, HasSubstr(std::string(word) == "evaluations of" ? "evaluations" : word));
}

TEST_F(Simulate, without_gravity_and_loads_momenta_are_kept) {
  const json summary = json_of(run("six_body_free", {"--json", "--rtol", "1e-12", "--atol", "1e-14"}));
  // a thousand times the tolerance of a step, for some hundred steps
  for (const char* quantity : {"energy", "linear_momentum", "angular_momentum"})
    EXPECT_LT(summary.at(quantity).at("worst").at("relative"), 1e-9) << quantity;
  EXPECT_THAT(kanec(run("six_body_free", {})).out, Not(HasSubstr("not kept")));
}

TEST_F(Simulate, all_integrators_come_to_the_same_end) {
  const std::vector<double> expected = flat(json_of(run("free_body", {"--json"})).at("final"));
  for (const std::string integrator :
       {"rk4", "lie4", "cvode", "cvode_bdf", "arkode_dirk", "ida", "taylor", "taylor_extended"}) {
    SCOPED_TRACE(integrator);
    const json summary = json_of(run("free_body", {"--json", "--integrator", integrator}));
    EXPECT_EQ(summary.at("integrator"), integrator);
    const std::vector<double> found = flat(summary.at("final"));
    ASSERT_EQ(found.size(), expected.size());
    // rk4 at 1 ms: 5 rad/s makes 1e-2 rad a step, (1e-2)^4 / 120 = 1e-10; BDF steps at 1e-9 each
    for (std::size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-5) << i;
  }
}

// Joints, a prescribed motion, loads and their power, all in one Jacobian.
TEST_F(Simulate, implicit_integrators_come_to_the_same_end_with_emitted_derivatives) {
  const auto end_of = [this](const std::string& integrator, const std::string& jacobian) {
    const json summary = json_of(run("slider_crank", {"--json", "--integrator", integrator, "--jacobian", jacobian}));
    EXPECT_EQ(summary.at("jacobian_evaluations") > 0, jacobian != "differences" && integrator != "arkode");
    return std::pair(summary.at("final").at("x"), summary.at("energy").at("work").get<double>());
  };
  const auto [expected, work] = end_of("arkode", "auto");
  for (const std::string integrator : {"cvode_bdf", "arkode_dirk", "ida"})
    for (const std::string jacobian : {"dense", "sparse", "differences"}) {
      SCOPED_TRACE(integrator + " " + jacobian);
      const auto [found, found_work] = end_of(integrator, jacobian);
      // thousands of steps of 1e-9 each
      EXPECT_NEAR(found_work, work, 1e-4);
      for (const auto& [name, value] : expected.items())
        EXPECT_NEAR(found.at(name).get<double>(), value.get<double>(), 1e-5) << name;
    }
}

TEST_F(Simulate, csv_has_a_row_a_time_and_a_column_a_quantity) {
  const json summary = json_of(run("free_body", {"--json", "--csv", "free.csv"}));
  EXPECT_EQ(names(work()), std::vector<std::string>{"free.csv"});
  const auto rows = cells(read_file(work() / "free.csv"));
  ASSERT_EQ(rows.size(), 6u);
  const std::vector<std::string> header = {"t[s]",
                                           "eps_handle_1",
                                           "eps_handle_2",
                                           "eps_handle_3",
                                           "eps_handle_4",
                                           "s_handle_1[m]",
                                           "s_handle_2[m]",
                                           "s_handle_3[m]",
                                           "omega_handle_1[rad/s]",
                                           "omega_handle_2[rad/s]",
                                           "omega_handle_3[rad/s]",
                                           "sdot_handle_1[m/s]",
                                           "sdot_handle_2[m/s]",
                                           "sdot_handle_3[m/s]",
                                           "kinetic[J]",
                                           "potential[J]",
                                           "work[J]"};
  EXPECT_EQ(rows[0], header);
  const std::vector<double> end = flat(summary.at("final"));
  for (std::size_t i = 0; i < rows.size() - 1; ++i) {
    ASSERT_EQ(rows[i + 1].size(), header.size());
    EXPECT_EQ(std::stod(rows[i + 1][0]), 0.125 * static_cast<double>(i));
  }
  for (std::size_t i = 0; i < end.size(); ++i) EXPECT_EQ(std::stod(rows[5][i + 1]), end[i]);
  EXPECT_EQ(std::stod(rows[5][14]), summary.at("energy").at("end").at("kinetic"));
}

TEST_F(Simulate, final_state_is_what_eval_reads) {
  const json summary = json_of(run("six_body", {"--json", "--final", "end.json", "--set", "m_payload=2.5"}));
  EXPECT_EQ(json::parse(read_file(work() / "end.json")), summary.at("final"));
  EXPECT_EQ(summary.at("final").at("parameters").at("m_payload"), 2.5);
  const json energy =
      json_of({"eval", model("six_body"), "energy", "--input", "end.json", "--path", "generic", "--json"});
  const double kinetic = energy.at("result").at("energy").at("kinetic");
  // the same state in other arithmetic: some roundings
  EXPECT_NEAR(kinetic, summary.at("energy").at("end").at("kinetic"), 1e-13 * kinetic);
}

TEST_F(Simulate, settings_change_the_run_and_not_the_code) {
  const json summary = json_of(run("six_body", {"--json"}));
  const Answer answer = kanec(run("six_body", {"--json", "--set", "m_payload=2.5", "--set", "thrust=0"}));
  EXPECT_THAT(answer.err, HasSubstr("six_body: from the cache"));
  const json other = json::parse(answer.out);
  EXPECT_EQ(other.at("hash"), summary.at("hash"));
  EXPECT_GT(other.at("energy").at("start").at("kinetic"), summary.at("energy").at("start").at("kinetic"));
  EXPECT_EQ(other.at("final").at("inputs").at("thrust"), 0.0);
}

TEST_F(Simulate, settings_that_cannot_be_are_refused) {
  refuses(run("six_body", {"--set", "m_paylod=1"}),
          "--set: found \"m_paylod\"; allowed: m_payload, thrust (did you mean m_payload?)");
  refuses(run("six_body", {"--set", "m_payload"}), "allowed: NAME=VALUE");
  refuses(run("six_body", {"--set", "m_payload=heavy"}), "found m_payload = \"heavy\"; allowed: a finite number");
  refuses(run("six_body", {"--set", "m_payload=nan"}), "allowed: a finite number");
  refuses(run("six_body", {"--set", "m_payload=-1"}), "--set: body 4 (payload): mass: found m_payload = -1");
  refuses(run("free_body", {"--set", "m=1"}), "has no parameters and no inputs");
}

TEST_F(Simulate, options_that_cannot_be_are_refused_by_their_names) {
  refuses(run("free_body", {"--duration", "-1"}), "--duration: found -1; allowed: a positive");
  refuses(run("free_body", {"--output-step", "0"}), "--output-step: found 0");
  refuses(run("free_body", {"--step", "inf"}), "--step: found inf");
  refuses(run("free_body", {"--rtol", "2"}), "--rtol: found 2");
  refuses(run("free_body", {"--atol", "0"}), "--atol: found 0");
  refuses(run("free_body", {"--integrator", "rk5"}), "--integrator: found \"rk5\"; allowed: rk4, lie4, gauss4, gauss6");
  refuses(run("free_body", {"--jacobian", "full"}), "--jacobian: found \"full\"; allowed: auto, dense, sparse");
  refuses(run("free_body", {"--integrator", "arkode", "--order", "7"}), "--order: found 7; allowed: 4, 5, 6, 8, or 0");
  refuses(run("free_body", {"--output-step", "1e-12"}), "rows");
}

TEST_F(Simulate, unwritable_files_are_known_before_anything_is_compiled) {
  for (const char* option : {"--csv", "--final"}) {
    const std::vector<std::string> arguments =
        run("free_body", {option, "nowhere/file", "--compiler", "no-such-compiler"});
    refuses(arguments, "nowhere/file: No such file or directory");
  }
  refuses(run("free_body", {"--csv", "a", "--final", "a"}), "found 'a' twice");
  refuses(run("free_body", {"--csv", "-", "--json"}), "--json: found it beside a file on standard output");
}

TEST_F(Simulate, a_full_disk_leaves_nothing) {
  refuses(run("free_body", {"--csv", "/dev/full"}), "/dev/full: No space left on device");
  const fs::path disk = work() / "disk";
  fs::create_directory(disk);
  const kanec::test::SmallDisk mounted(disk, "16k");
  if (mounted.error() != 0) GTEST_SKIP() << "only root can mount a small disk: " << std::strerror(mounted.error());
  refuses(run("free_body", {"--output-step", "0.001", "--csv", "disk/free.csv"}),
          "disk/free.csv: No space left on device", {"disk"});
  EXPECT_THAT(names(disk), IsEmpty());
}

TEST_F(Simulate, plot_is_drawn) {
  if (!find_program("gnuplot")) GTEST_SKIP() << "gnuplot is not installed";
  EXPECT_EQ(kanec(run("free_body", {"--plot", "free.svg"})).status, 0);
  EXPECT_EQ(names(work()), std::vector<std::string>{"free.svg"});
  EXPECT_THAT(read_file(work() / "free.svg"), HasSubstr("<svg"));
  refuses(run("free_body", {"--plot", "nowhere/free.svg"}), "nowhere/free.svg: No such file or directory",
          {"free.svg"});
}

TEST_F(Simulate, rows_are_kept_where_the_picture_fails_and_nothing_else_is) {
  fs::create_directory(work() / "bin");
  write("bin/gnuplot", "#!/bin/sh\ncat > /dev/null\nexit 3\n");
  fs::permissions(work() / "bin" / "gnuplot", fs::perms(0700));
  const Variable path("PATH", (work() / "bin").string() + ":" + std::getenv("PATH"));
  const Answer answer = kanec(run("free_body", {"--plot", "a.svg", "--csv", "a.csv", "--final", "a.json"}));
  EXPECT_EQ(answer.status, 2);
  EXPECT_THAT(answer.err, HasSubstr("a.svg: gnuplot failed with status 3"));
  EXPECT_THAT(answer.err, HasSubstr("; the rows are in a.csv"));
  EXPECT_THAT(names(work()), testing::ElementsAre("a.csv", "bin"));
}

TEST_F(Simulate, trajectory_is_written_through_links) {
  fs::create_directory(work() / "far");
  fs::create_symlink("far/rows", work() / "a.csv");
  EXPECT_EQ(kanec(run("free_body", {"--csv", "a.csv"})).status, 0);
  EXPECT_TRUE(fs::is_symlink(work() / "a.csv"));
  EXPECT_THAT(read_file(work() / "far" / "rows"), testing::StartsWith("t[s],"));
  refuses(run("free_body", {"--csv", "a.csv", "--final", "far/rows"}), "found 'far/rows' twice", {"a.csv", "far"});
}

TEST_F(Simulate, plot_without_gnuplot_is_refused) {
  const Variable path("PATH", "/nowhere");
  refuses(run("free_body", {"--plot", "free.svg"}), "gnuplot");
}

// Waits for rows in the CSV's temporary file, then ends the run; a step a row.
TEST_F(Simulate, interrupted_run_leaves_its_rows_and_says_until_when) {
  const std::string script = R"(cd "$0" && "$@" & run=$!
    while kill -0 $run && ! find "$0" -name 'long.csv.*' -size +0 | grep -q .; do sleep 0.05; done
    kill -TERM $run; wait $run)";
  const ProcessResult result = run_process({"/bin/sh", "-c", script, work().string(), KANEC_PROGRAM, "simulate",
                                            model("free_body"), "--duration", "1e5", "--output-step", "1e-2",
                                            "--integrator", "rk4", "--step", "1e-2", "--csv", "long.csv"});
  EXPECT_EQ(result.status, 130) << result.output;
  EXPECT_EQ(names(work()), std::vector<std::string>{"long.csv"});
  const std::string csv = read_file(work() / "long.csv");
  ASSERT_EQ(csv.back(), '\n');
  const std::string last = csv.substr(csv.rfind('\n', csv.size() - 2) + 1), end = last.substr(0, last.find(','));
  EXPECT_THAT(result.output, HasSubstr("kanec: interrupted; the rows until " + end +
                                       " s are in long.csv, and --resume long.csv goes on from there\n"));
}

}  // namespace
}  // namespace kanec::cli::test
