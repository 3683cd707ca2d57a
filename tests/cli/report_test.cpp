// Oracles: the counts of `kanec ledger`, the errors that `kanec check` finds in compiled code, and the generic path,
// from which a way with a mistake would be 1e10 ulps away.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/read/read.hpp"
#include "runtime/study/report/evaluation.hpp"
#include "runtime/study/report/ways.hpp"
#include "runtime/verify/samples.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Report : public Program {
 protected:
  json functions_of(const std::string& scene, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> command = {"report", model(scene), "--json", "--states", "12"};
    command.insert(command.end(), more.begin(), more.end());
    return json_of(command).at("scenes").at(0).at("functions");
  }
};

TEST_F(Report, has_the_kept_way_first_with_the_counts_of_the_ledger) {
  const json counted = json_of({"ledger", model("bench_s6r"), "--json"}).at(0).at("functions");
  const json functions = functions_of("bench_s6r");
  ASSERT_EQ(functions.size(), 4u);
  int compared = 0;
  for (const json& function : functions) {
    const json& kept = function.at("ways").at(0);
    EXPECT_EQ(kept.at("name"), "kept");
    for (const json& known : counted)
      if (known.at("name") == function.at("name")) {
        EXPECT_EQ(kept.at("operations"), known.at("operations")) << function;
        ++compared;
      }
  }
  EXPECT_EQ(compared, 4);
}

TEST_F(Report, has_hard_states_however_few_the_random_ones) {
  for (const json& function : functions_of("arm_6", {"--functions", "accelerations", "--states", "1"}))
    for (const json& way : function.at("ways")) EXPECT_GT(way.at("double").at("hard_ulps"), 0) << way;
}

TEST_F(Report, finds_every_way_some_ulps_from_fifty_digits_and_from_the_generic_path) {
  for (const json& function : functions_of("arm_7"))
    for (const json& way : function.at("ways")) {
      SCOPED_TRACE(way.dump());
      EXPECT_GT(way.at("double").at("largest_ulps"), 0);  // double rounds, 50 digits do not
      EXPECT_LT(way.at("double").at("largest_ulps"), 100);
      EXPECT_LT(way.at("float").at("largest_ulps"), 100);
      EXPECT_LT(way.at("from_generic").at("hard_ulps"), 1000);
      EXPECT_LT(way.at("expected_ulps"), way.at("double").at("largest_ulps").get<double>() + 1);
    }
}

// Lanes round as one state at a time does, in another order of operations where the compiler fuses; float is 2^29
// coarser.
TEST_F(Report, has_lanes_and_float_beside_what_is_emitted_in_a_picture) {
  const json scene = json_of({"report", model("pendulum"), "--functions", "accelerations", "--json", "--states", "4",
                              "--plot", "a.svg"})
                         .at("scenes")
                         .at(0);
  std::vector<std::string> names;
  for (const json& variant : scene.at("variants")) {
    names.push_back(variant.at("variant"));
    EXPECT_EQ(variant.at("scalar"), names.back() == "float_lanes" ? "float" : "double");
    EXPECT_LT(variant.at("from_generic").at("largest_ulps"), 100) << variant;
    EXPECT_GT(variant.at("nanoseconds"), 0);
  }
  for (const char* name : {"emitted", "lanes", "float_lanes", "generic"}) EXPECT_THAT(names, testing::Contains(name));
  EXPECT_THAT(read_file(work() / "a.svg"), HasSubstr("pendulum: time against rounding error"));
}

TEST_F(Report, writes_what_is_timed_as_a_table_of_its_own) {
  const Answer answer =
      kanec({"report", model("pendulum"), "--functions", "energy", "--states", "1", "--timed", "--csv"});
  EXPECT_THAT(answer.out, testing::StartsWith("model,function,variant,scalar,time[ns]"));
  EXPECT_THAT(answer.out, HasSubstr("\npendulum,energy,emitted,double,"));
  EXPECT_THAT(answer.out, HasSubstr("\npendulum,energy,float_lanes,float,"));
}

TEST_F(Report, finds_the_errors_that_check_finds) {
  const json checked = json_of({"check", model("free_body"), "--functions", "energy", "--json"}).at("functions").at(0);
  const json reported = json_of({"report", model("free_body"), "--functions", "energy", "--json"})
                            .at("scenes")
                            .at(0)
                            .at("functions")
                            .at(0)
                            .at("ways")
                            .at(0)
                            .at("double");
  // the same states and the same operations, but for products and sums that the compiler may have fused
  EXPECT_NEAR(reported.at("median_ulps"), checked.at("median_ulps"), 1.0);
  EXPECT_NEAR(reported.at("largest_ulps"), checked.at("largest_ulps"), 2.0);
}

TEST_F(Report, says_the_same_as_text_table_and_page) {
  const std::vector<std::string> command = {"report",        model("pendulum"), "--functions",
                                            "accelerations", "--states",        "4"};
  const auto with = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all = command;
    all.insert(all.end(), more.begin(), more.end());
    const Answer answer = kanec(all);
    EXPECT_EQ(answer.status, 0) << answer.err;
    return answer.out;
  };
  EXPECT_THAT(with({}), testing::StartsWith("pendulum: condition of A 1"));
  EXPECT_THAT(with({"--csv"}), HasSubstr("\npendulum,accelerations,kept,"));
  EXPECT_THAT(with({"--markdown"}), HasSubstr("## pendulum"));
  EXPECT_THAT(with({"--markdown", "-o", "page.md"}), IsEmpty());
  EXPECT_EQ(read_file(work() / "page.md"), with({"--markdown"}));
}

TEST_F(Report, refuses_what_it_does_not_know) {
  refuses({"report"}, "no scene is given");
  refuses({"report", model("pendulum"), "--json", "--csv"}, "found several of them");
  refuses({"report", model("pendulum"), "--functions", "acceleration"}, "function: found");
  refuses({"report", "--hard", "--json", "--markdown"}, "found several of them");
  for (const char* other : {"--peers", "--timed", "--csv", "--evaluation", "--limit=2", "--seed=2", "--error=1e-6"})
    refuses({"report", "--hard", other}, "--hard: found it beside other reports");
}

TEST(HardStates, have_high_speeds_large_angles_and_unit_norms) {
  const scene::Scene scene = scene::read(KANEC_SOURCE_DIR "/models/every_joint/scene.toml");
  const std::vector<State> random = samples(scene, 3, 1), hard = hard_states(scene, random);
  ASSERT_EQ(hard.size(), 8u);
  EXPECT_EQ(hard[0].y[0], 1000 * random[1].y[0]);
  double largest = 0.0;
  for (const State& state : hard)
    for (const scene::BodyLayout& at : scene::Layout(scene).bodies) {
      for (const int theta : at.theta)
        if (theta >= 0) largest = std::max(largest, std::fabs(state.x[static_cast<std::size_t>(theta)]));
      if (at.eps < 0) continue;
      const double* eps = &state.x[static_cast<std::size_t>(at.eps)];
      EXPECT_NEAR(std::hypot(std::hypot(eps[0], eps[1]), std::hypot(eps[2], eps[3])), 1.0, 1e-15);
    }
  EXPECT_GT(largest, 1e3);
}

TEST(Ways, differ_from_the_kept_one_in_one_thing) {
  const scene::Scene scene = scene::read(KANEC_SOURCE_DIR "/models/bench_cb6/scene.toml");
  const symbolic::Way kept{.algorithm = symbolic::Algorithm::articulated, .axes = symbolic::Axes::body};
  const std::vector<NamedWay> ways = ways_beside(scene, "accelerations", kept);
  EXPECT_EQ(ways.front().way, kept);
  for (std::size_t i = 1; i + 1 < ways.size(); ++i) {
    const symbolic::Reductions &a = ways[i].way.reductions, &b = kept.reductions;
    const int changes = (ways[i].way.algorithm != kept.algorithm) + (ways[i].way.axes != kept.axes) +
                        (a.place_origins != b.place_origins) + (a.turn_axes != b.turn_axes) +
                        (a.regroup != b.regroup || a.group != b.group);
    EXPECT_EQ(changes, 1) << ways[i].name;
  }
  EXPECT_FALSE(ways.back().passes);
}

}  // namespace
}  // namespace kanec::cli::test
