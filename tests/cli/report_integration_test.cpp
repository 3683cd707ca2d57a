// Oracles: the exact motion of a mass on a spring; the orders of the methods; what the numbers of one run say of each
// other.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <map>

#include "generator/read/read.hpp"
#include "runtime/study/report/integration.hpp"
#include "runtime/study/report/reference.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

// 2 kg on 18 N/m, let go 0.1 m off: s = 0.1 cos 3 t.
constexpr auto oscillator = R"(name = "oscillator"
connection = [0]
[[body]]
joint = "prismatic"
axis = "x"
mass = 2.0
inertia = [0.0, 0.0, 0.0]
stiffness = 18.0
[body.initial]
s = 0.1
[simulate]
duration = 2.0
)";

class IntegrationReport : public Program {
 protected:
  json runs_of(const std::string& scene, const std::vector<std::string>& more) const {
    std::vector<std::string> command = {"report", scene, "--integration", "--json"};
    command.insert(command.end(), more.begin(), more.end());
    return json_of(command).at("scenes").at(0).at("integration");
  }
};

TEST_F(IntegrationReport, the_reference_is_the_exact_motion_to_its_own_error) {
  const scene::Scene scene = scene::parse(oscillator, "oscillator");
  const CompiledModel model = build(scene, integration_functions(scene, {}), {}, /*with_taylor=*/true);
  const Trials trials(scene, model.library.abi(), [] {});
  integrate::Options base;
  base.duration = 2.0;
  base.output_step = 0.5;
  const Reference found = reference(trials, base, 0.1, 10.0);
  ASSERT_EQ(found.rows.size(), 5u);
  EXPECT_LT(found.own_error, 1e-13);
  EXPECT_LT(found.check_difference, 1e-11);
  EXPECT_NEAR(found.scales.length, 0.2, 0.002);  // from where it began, at the row nearest to half a turn
  for (std::size_t i = 0; i < found.rows.size(); ++i) {
    const long double exact = 0.1L * std::cos(1.5L * static_cast<long double>(i));
    // beside the amplitude, half the length; the change from the run before it is the same or larger
    EXPECT_NEAR(static_cast<double>((found.rows[i][0].p.x() - exact) / 0.1L), 0.0, 4 * found.own_error) << i;
  }
}

TEST_F(IntegrationReport, errors_fall_with_the_order_of_the_method) {
  const std::map<std::string, double> orders = {{"rk4", 4}, {"gauss4", 4}, {"gauss6", 6}};
  const json runs = runs_of(write("scene.toml", oscillator), {"--integrators", "rk4,gauss4,gauss6"}).at("runs");
  std::map<std::string, int> compared;
  for (std::size_t i = 1; i < runs.size(); ++i) {
    const json &coarse = runs[i - 1], &fine = runs[i];
    if (coarse.at("method") != fine.at("method")) continue;
    const double before = coarse.at("worst").at("relative"), after = fine.at("worst").at("relative");
    EXPECT_DOUBLE_EQ(coarse.at("step"), 2 * fine.at("step").get<double>());
    if (before > 1e-3 || after < 1e-12) continue;  // not in its range yet, or rounding
    EXPECT_NEAR(std::log2(before / after), orders.at(fine.at("method")), 0.3) << fine;
    ++compared[fine.at("method")];
  }
  for (const auto& [method, order] : orders) EXPECT_GE(compared[method], 2) << method;
}

TEST_F(IntegrationReport, error_control_follows_the_tolerance) {
  const json report = runs_of(write("scene.toml", oscillator), {"--integrators", "arkode,cvode"});
  for (const json& run : report.at("runs")) {
    const double tolerance = run.at("relative_tolerance"), error = run.at("worst").at("relative");
    EXPECT_LT(error, 1000 * tolerance) << run;                         // of a step, against that of a whole run
    EXPECT_DOUBLE_EQ(run.at("absolute_tolerance"), 1e-3 * tolerance);  // as the scene's defaults are
    EXPECT_GE(run.at("evaluations"), run.at("steps"));
    EXPECT_LE(run.at("end").at("relative"), error);
  }
}

TEST_F(IntegrationReport, takes_every_integrator_and_recommends_a_run_within_the_error) {
  const json report = runs_of(model("free_body"), {"--duration", "1", "--error", "1e-7"});
  std::vector<std::string> methods;
  for (const json& run : report.at("runs")) methods.push_back(run.at("method"));
  for (const std::string& method : integrate::method_names()) {
    if (method == "taylor_extended") continue;  // for references
    EXPECT_THAT(methods, testing::Contains(method));
  }
  const json& chosen = report.at("recommended").at(0);
  EXPECT_LE(chosen.at("run").at("worst").at("relative"), 1e-7);
  for (const json& run : report.at("runs")) {
    if (run.contains("failure") || run.at("worst").at("relative") > 1e-7) continue;
    EXPECT_GE(run.at("wall_seconds"), chosen.at("run").at("wall_seconds"));
  }
}

// Passages of zero ask for rows, which a report leaves out; all runs end at 1.55 s by the event.
constexpr auto pulsed = R"(name = "pulsed"
connection = [0]
[[body]]
joint = "prismatic"
axis = "x"
mass = 1.0
inertia = [0.0, 0.0, 0.0]
effort = "max(0, 1 - 100*abs(t - 3.3))*1000"
[simulate]
duration = 10.0
output_step = 1.0
)";

// 10 N s at 3.3 s, then 6.7 s at 10 m/s. Steps of up to 5 ms cannot miss it.
TEST_F(IntegrationReport, a_short_load_is_met_with_short_steps_by_every_method) {
  const std::string scene = write("scene.toml", pulsed);
  for (const std::string& method : integrate::method_names()) {
    const json end =
        json_of({"simulate", scene, "--json", "--integrator", method, "--longest-step", "0.005"}).at("final");
    EXPECT_NEAR(end.at("x").at("s_1").get<double>(), 67.0, 1e-3) << method;
  }
}

// Passages of zero ask for rows, which a report leaves out; all runs end at 1.55 s by the event.
TEST_F(IntegrationReport, compares_rows_of_the_same_times_alone) {
  const std::string events =
      "[[event]]\nname = 'zero'\nexpression = 's_1'\nrow = true\n"
      "[[event]]\nname = 'end'\nexpression = 't - 1.55'\naction = 'stop'\n";
  const json report = runs_of(write("scene.toml", oscillator + events), {"--integrators", "arkode,rk4"});
  const json& runs = report.at("runs");
  EXPECT_EQ(report.at("duration"), 2.0);
  EXPECT_NEAR(report.at("end").get<double>(), 1.55, 1e-14);  // some roundings
  EXPECT_EQ(report.at("rows"), 16);                          // fifteen tenths, and where the event is
  for (const json& run : runs) {
    ASSERT_FALSE(run.contains("failure")) << run;
    EXPECT_LT(run.at("worst").at("relative"), 3) << run;
  }
  EXPECT_LT(runs.at(0).at("worst").at("relative"), 1e-2);
}

TEST_F(IntegrationReport, tells_of_runs_that_take_too_long) {
  const json runs = runs_of(model("spinning_top"), {"--integrators", "rk4,cvode_bdf", "--limit", "0.01"}).at("runs");
  const auto is_late = [](const json& run) {
    return run.contains("failure") && run.at("failure").get<std::string>().find("time limit of 0.01 s") == 0;
  };
  EXPECT_TRUE(std::any_of(runs.begin(), runs.end(), is_late)) << runs;
}

TEST_F(IntegrationReport, says_the_same_as_text_table_page_and_picture) {
  const std::vector<std::string> command = {
      "report", write("scene.toml", oscillator), "--integrators", "gauss6", "--plot", "runs.svg"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = command;
    all.insert(all.end(), more.begin(), more.end());
    const Answer answer = kanec(all);
    EXPECT_EQ(answer.status, 0) << answer.err;
    return answer.out;
  };
  const std::string both = with({});
  EXPECT_THAT(both, HasSubstr("oscillator: condition of A 1"));
  EXPECT_THAT(both, HasSubstr("oscillator: integration from t = 0 to 2 s\nreference: taylor_extended"));
  EXPECT_THAT(both, HasSubstr("for an error of 1e-09: gauss6, h "));
  EXPECT_THAT(with({"--markdown"}), testing::AllOf(HasSubstr("# Accuracy of evaluation"), HasSubstr("](runs.svg)")));
  const std::string table = with({"--integration", "--csv"});
  const auto commas = [](const std::string& line) { return std::count(line.begin(), line.end(), ','); };
  EXPECT_EQ(commas(table.substr(0, table.find('\n'))), 23);
  EXPECT_EQ(commas(table), 23 * std::count(table.begin(), table.end(), '\n'));
  EXPECT_THAT(read_file(work() / "runs.svg"), HasSubstr("oscillator: wall time against error"));
}

TEST_F(IntegrationReport, draws_a_picture_a_scene_and_the_page_shows_them) {
  const std::string one = write("one.toml", oscillator),
                    two = write(
                        "two.toml", "# other\n" + [] {
                          std::string text = oscillator;
                          return text.replace(text.find("oscillator"), 10, "other");
                        }());
  EXPECT_EQ(kanec({"report", one, two, "--integration", "--integrators", "gauss6", "--duration", "0.2", "--markdown",
                   "-o", "page.md", "--plot", "runs.svg"})
                .status,
            0);
  const std::string page = read_file(work() / "page.md");
  for (const std::string name : {"oscillator", "other"}) {
    EXPECT_THAT(page, HasSubstr("](runs_" + name + ".svg)"));
    EXPECT_THAT(read_file(work() / ("runs_" + name + ".svg")), HasSubstr(name + ": wall time against error"));
  }
}

// The force is no number from 0.1 s on, so that no method gets through.
TEST_F(IntegrationReport, of_several_scenes_says_why_one_failed_and_has_the_others) {
  std::string failing = oscillator;
  failing.replace(failing.find("oscillator"), 10, "failing");
  failing.insert(failing.find("[body.initial]"), "effort = \"sqrt(0.1 - t)\"\n");
  const std::string one = write("one.toml", failing), two = write("two.toml", oscillator);
  const auto with = [&](const std::vector<std::string>& more, int status) {
    std::vector<std::string> all = {"report", "--integration", "--integrators", "gauss6", "--duration", "0.2"};
    all.insert(all.end(), more.begin(), more.end());
    const Answer answer = kanec(all);
    EXPECT_EQ(answer.status, status) << answer.err;
    EXPECT_THAT(answer.err, HasSubstr("no reference: "));
    return answer;
  };
  const json scenes = json::parse(with({one, two, "--json"}, 1).out).at("scenes");
  EXPECT_EQ(scenes.at(0).at("model"), "failing");
  EXPECT_THAT(scenes.at(0).at("integration").at("failure").get<std::string>(), HasSubstr("no reference: "));
  EXPECT_FALSE(scenes.at(1).at("integration").at("runs").empty());
  EXPECT_THAT(with({one, two, "--markdown"}, 1).out, testing::AllOf(HasSubstr("## failing\n\nFailed: no reference: "),
                                                                    HasSubstr("## oscillator\n\n0 to 0.2 s")));
  const Answer text = with({one, two, "--plot", "runs.svg"}, 1);
  EXPECT_THAT(text.out, testing::AllOf(testing::StartsWith("failing: integration failed: no reference: "),
                                       HasSubstr("oscillator: integration from t = 0")));
  EXPECT_THAT(text.err, HasSubstr("kanec: failing: no reference: "));
  EXPECT_EQ(names(work()), (std::vector<std::string>{"one.toml", "runs_oscillator.svg", "two.toml"}));
  EXPECT_THAT(with({one}, 2).out, IsEmpty());  // alone it is refused
}

TEST_F(IntegrationReport, counts_emitted_jacobians_beside_differences_of_rates) {
  const json runs = runs_of(write("scene.toml", oscillator), {"--integrators", "arkode,cvode_bdf"}).at("runs");
  std::map<std::string, int> seen;
  for (const json& run : runs) {
    if (run.contains("failure")) continue;
    const std::string kind = run.value("jacobian", "none");
    ++seen[kind];
    const json& count = run.at("jacobians");
    EXPECT_EQ(count.is_null(), kind == "none") << run;
    EXPECT_EQ(count.is_number() && count > 0, kind == "auto") << run;
  }
  for (const char* kind : {"none", "auto", "differences"}) EXPECT_GE(seen[kind], 4) << kind;
}

// Other engines know nothing of ours, so that both agree only where both are right.
TEST_F(IntegrationReport, other_engines_come_to_the_same_motion) {
  if (!fs::exists(KANEC_BINARY_DIR "/peers")) GTEST_SKIP() << "no other engine was installed when this was built";
  const std::vector<std::string> few = {"--integrators", "taylor", "--duration", "1", "--peers"};
  std::map<std::string, double> best;
  const json report = runs_of(model("tumbling_s6b"), few);
  for (const json& run : report.at("runs")) {
    if (!run.contains("other_engine") || run.contains("failure")) continue;
    double& least = best.try_emplace(run.at("method"), 1.0).first->second;
    least = std::min<double>(least, run.at("worst").at("relative"));
  }
  if (best.empty()) GTEST_SKIP() << "no engine that integrates was installed when this was built";
  for (const auto& [engine, error] : best) {
    const bool is_rough = engine.find("MuJoCo") == 0;  // of low order on ball joints
    EXPECT_LT(error, is_rough ? 1e-2 : 1e-9) << engine;
  }
}

TEST_F(IntegrationReport, tells_what_other_engines_cannot_have) {
  if (!fs::exists(KANEC_BINARY_DIR "/peers/simbody.so")) GTEST_SKIP() << "Simbody was not installed";
  const json runs = runs_of(write("scene.toml", oscillator), {"--integrators", "taylor", "--peers"}).at("runs");
  EXPECT_EQ(runs.back().at("failure"), "not modelled: loads other than gravity");
}

TEST_F(IntegrationReport, refuses_what_cannot_be) {
  const std::string pendulum = model("pendulum");
  refuses({"report", pendulum, "--evaluation", "--integration"}, "found it beside --integration; allowed: one of them");
  refuses({"report", pendulum, "--csv"}, "--csv: found two tables");
  refuses({"report", pendulum, "--evaluation", "--peers"}, "--peers: found it beside --evaluation");
  for (const std::string option : {"--duration=1", "--error=1e-6", "--limit=2", "--integrators=rk4"}) {
    const std::string found = option.substr(0, option.find('=')) + ": found it beside ";
    refuses({"report", pendulum, "--evaluation", option}, found + "--evaluation; allowed: with integration");
    refuses({"report", pendulum, "--functions", "energy", option}, found + "--functions; allowed: with integration");
  }
  for (const std::string option : {"--states=2", "--seed=2"})
    refuses({"report", pendulum, "--integration", option},
            ": found it beside --integration; allowed: with --evaluation");
  for (const std::string list : {"rk4,,", ",rk4", ","})
    refuses({"report", pendulum, "--integrators", list}, "--integrators: found an empty name in '" + list + "'");
  refuses({"report", pendulum, pendulum, "--plot", "a.svg"}, "--plot: found two scenes named pendulum");
  refuses({"report", pendulum, "--integration", "--functions", "energy"}, "--functions: found it beside --integration");
  refuses({"report", pendulum, "--integrators", "rk5"}, "integrator: found 'rk5'");
  refuses({"report", pendulum, "--integration", "--duration", "-1"},
          "--duration: found -1; allowed: a positive finite");
  for (const std::string error : {"0", "-1", "nan", "inf"})
    refuses({"report", pendulum, "--integration", "--error=" + error},
            "--error: found " + error + "; allowed: a positive finite number");
  for (const std::string limit : {"0", "1e-04", "1e+07"})
    refuses({"report", pendulum, "--integration", "--limit=" + limit},
            "--limit: found " + limit + "; allowed: from 0.001 to 1e+06");
}

}  // namespace
}  // namespace kanec::cli::test
