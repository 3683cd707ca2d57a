// That times are taken and told; how long anything takes is no test.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Bench : public Program {};

TEST_F(Bench, times_and_operations_stand_side_by_side) {
  const std::vector<std::string> command = {
      "bench", model("free_body"), "--functions", "accelerations,energy", "--min-time", "0.01"};
  std::vector<std::string> machine = command;
  machine.emplace_back("--json");
  const json report = json_of(machine);
  ASSERT_EQ(report.at("functions").size(), 2u);
  for (const json& function : report.at("functions")) {
    const double emitted = function.at("emitted_ns"), generic = function.at("generic_ns");
    EXPECT_GT(emitted, 0.0);
    EXPECT_GT(generic, 0.0);
    EXPECT_DOUBLE_EQ(function.at("ratio"), generic / emitted);
    EXPECT_GT(function.at("operations"), 0);
  }
  EXPECT_THAT(report.at("compiler").get<std::string>(), HasSubstr("-O0"));
  const Answer text = kanec(command);
  EXPECT_EQ(text.status, 0);
  for (const char* word : {"accelerations", "energy", "ratio", "multiply", " ns"})
    EXPECT_THAT(text.out, HasSubstr(word));
}

TEST_F(Bench, least_time_is_bounded) { refuses({"bench", model("free_body"), "--min-time", "0"}, "--min-time"); }

}  // namespace
}  // namespace kanec::cli::test
