// That times are taken and told, and what stands beside them; how long anything takes is no test. Oracles: the symbols
// that nm lists; other engines, where their adapters were built.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Bench : public Program {
 protected:
  static std::vector<std::string> quick(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "bench");
    arguments.insert(arguments.end(), {"--min-time", "0.01"});
    return arguments;
  }
  static std::vector<json> entries(const json& scene, const std::string& path) {
    std::vector<json> list;
    for (const json& entry : scene.at("entries"))
      if (entry.at("path") == path) list.push_back(entry);
    return list;
  }
};

TEST_F(Bench, times_and_operations_stand_side_by_side) {
  const std::vector<std::string> command =
      quick({model("free_body"), "--functions", "accelerations,energy", "--no-peers"});
  std::vector<std::string> machine = command;
  machine.emplace_back("--json");
  const json report = json_of(machine);
  const json& scene = report.at("scenes").at(0);
  ASSERT_EQ(scene.at("entries").size(), 4u);
  const std::vector<json> emitted = entries(scene, "emitted"), generic = entries(scene, "generic");
  ASSERT_EQ(emitted.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(emitted[i].at("function"), generic[i].at("function"));
    EXPECT_GT(emitted[i].at("ns"), 0.0);
    EXPECT_LE(emitted[i].at("least_ns"), emitted[i].at("ns"));
    EXPECT_DOUBLE_EQ(generic[i].at("ratio"), generic[i].at("ns").get<double>() / emitted[i].at("ns").get<double>());
    EXPECT_GT(emitted[i].at("operations"), 0);
    EXPECT_LT(emitted[i].at("difference"), 1e-12);
  }
  EXPECT_THAT(report.at("compiler").get<std::string>(), HasSubstr("-O0"));
  const Answer text = kanec(command);
  EXPECT_EQ(text.status, 0);
  for (const char* word : {"accelerations", "energy", "ratio", "multiply", " ns"})
    EXPECT_THAT(text.out, HasSubstr(word));
}

TEST_F(Bench, several_scenes_are_compared_by_their_accelerations) {
  const json report =
      json_of(quick({model("free_body"), model("pendulum"), "--no-peers", "--json", "--svg", "times.svg"}));
  ASSERT_EQ(report.at("scenes").size(), 2u);
  EXPECT_EQ(report.at("scenes").at(1).at("model"), "pendulum");
  for (const json& scene : report.at("scenes"))
    for (const json& entry : scene.at("entries")) EXPECT_EQ(entry.at("function"), "accelerations");
  const std::string picture = read_file(work() / "times.svg");
  for (const char* word : {"free_body: accelerations", "pendulum: accelerations", "generic", "</svg>"})
    EXPECT_THAT(picture, HasSubstr(word));
}

// Sizes of the symbols of one function as nm lists them, of all libraries in the cache of this test.
std::size_t listed_bytes(const fs::path& cache, const std::string& function) {
  std::size_t bytes = 0;
  std::set<std::string> seen;  // a library may stand there under two names
  for (const auto& file : fs::recursive_directory_iterator(cache)) {
    if (file.path().extension() != ".so" || !seen.insert(read_file(file.path())).second) continue;
    std::istringstream lines(run_process({*find_program("nm"), "-S", file.path().string()}).output);
    for (std::string line; std::getline(lines, line);)
      if (line.find(std::to_string(function.size()) + function + "E") != line.npos ||
          line.find(std::to_string(function.size()) + function + "I") != line.npos)
        bytes += std::stoul(line.substr(17, 16), nullptr, 16);
  }
  return bytes;
}

TEST_F(Bench, code_bytes_are_the_sizes_of_the_functions_symbols) {
  if (!find_program("nm")) GTEST_SKIP() << "no nm";
  const json report =
      json_of(quick({model("pendulum"), "--functions", "energy", "--no-peers", "--json", "--cache", "kept"}));
  const json emitted = entries(report.at("scenes").at(0), "emitted").at(0);
  EXPECT_EQ(emitted.at("code_bytes"), listed_bytes(work() / "kept", "energy"));
  EXPECT_GT(emitted.at("code_bytes"), 0);
  EXPECT_GT(emitted.at("compile_s"), 0.0);
}

// Free, ball and revolute joints, springs, welds: an engine whose accelerations differ by 1e-9 has no time.
TEST_F(Bench, other_engines_have_the_same_accelerations) {
  if (!fs::exists(KANEC_BINARY_DIR "/peers")) GTEST_SKIP() << "no other engine was installed when this was built";
  const json report =
      json_of(quick({model("bench_s6f"), model("bench_s6b"), model("arm_7"), model("quadruped"), "--json"}));
  for (const json& scene : report.at("scenes")) {
    EXPECT_GT(scene.at("entries").size(), 2u);
    for (const json& entry : scene.at("entries"))
      EXPECT_FALSE(entry.at("ns").is_null()) << scene.at("model") << " " << entry;
  }
}

TEST_F(Bench, what_another_engine_cannot_have_is_said) {
  if (!fs::exists(KANEC_BINARY_DIR "/peers")) GTEST_SKIP() << "no other engine was installed when this was built";
  const Answer answer = kanec(quick({model("slider_crank"), "--functions", "accelerations"}));
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_THAT(answer.out, HasSubstr("not modelled: a "));
}

// Without optimisation, so that nothing is known of their speed. Oracle: the generic path, within float's 6e-8 and
// double's rounding times some ten.
TEST_F(Bench, lanes_are_compared_and_timed_a_state) {
  const json report = json_of(quick(
      {model("pendulum"), "--functions", "accelerations", "--variants", "float_lanes,lanes", "--no-peers", "--json"}));
  const json lanes = entries(report.at("scenes").at(0), "lanes").at(0),
             narrow = entries(report.at("scenes").at(0), "float_lanes").at(0);
  EXPECT_GT(lanes.at("ns"), 0.0);
  EXPECT_LT(lanes.at("difference"), 1e-15);
  EXPECT_GT(narrow.at("ns"), 0.0);
  EXPECT_LT(narrow.at("difference"), 1e-6);
  EXPECT_GT(narrow.at("difference"), 0.0);
  refuses({"bench", model("pendulum"), "--variants", "lane"}, "did you mean lanes?");
}

TEST_F(Bench, page_names_the_command_that_writes_it) {
  const Answer answer =
      kanec(quick({model("pendulum"), model("free_body"), "--no-peers", "--markdown", "-o", "page.md"}));
  EXPECT_EQ(answer.status, 0) << answer.err;
  EXPECT_THAT(answer.out, IsEmpty());
  const std::string page = read_file(work() / "page.md");
  EXPECT_THAT(page,
              HasSubstr("kanec bench " + model("pendulum") + " " + model("free_body") + " --no-peers --markdown"));
  EXPECT_THAT(page, HasSubstr("\n| pendulum | accelerations | "));
}

TEST_F(Bench, least_time_is_bounded) { refuses({"bench", model("free_body"), "--min-time", "0"}, "--min-time"); }

TEST_F(Bench, a_function_that_one_scene_does_not_have_is_refused) {
  refuses({"bench", model("free_body"), model("pendulum"), "--functions", "power"}, "power");
}

}  // namespace
}  // namespace kanec::cli::test
