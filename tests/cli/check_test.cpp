// Oracles: kanec check compares with the generic path and with 50 digits itself; here that it does so and says so.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/compile/compiler.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Check : public Program {
 protected:
  void passes(std::vector<std::string> scene, std::size_t n_functions) const {
    scene.insert(scene.begin(), "check");
    scene.emplace_back("--json");
    const json report = json_of(scene);
    EXPECT_TRUE(report.at("passed"));
    EXPECT_EQ(report.at("states"), 32);
    EXPECT_EQ(report.at("functions").size(), n_functions);
    for (const json& function : report.at("functions")) {
      SCOPED_TRACE(function.dump());
      EXPECT_LE(function.at("median_ulps"), function.at("largest_ulps"));
      EXPECT_LE(function.at("largest_ulps"), 50);  // 17 is the most of 10^5 states
      EXPECT_LE(function.at("generic"), 1e-13);    // 50 ulps and what the generic path adds
      EXPECT_GT(function.at("largest_ulps"), 0);   // double rounds, 50 digits do not
    }
  }
};

TEST_F(Check, six_bodies_agree) { passes({model("six_body")}, 11); }
TEST_F(Check, s6f_agrees) { passes({model("bench_s6f")}, 11); }
TEST_F(Check, free_bodies_without_loads_agree) { passes({model("six_body_free")}, 10); }
TEST_F(Check, all_symbols_agree) { passes({"--connection", "0,1,2,2,1,5"}, 11); }

TEST_F(Check, of_a_folder_of_scenes_is_of_each_by_name) {
  for (const std::string name : {"b", "a"}) {
    fs::create_directories(work() / "some" / name);
    write("some/" + name + "/scene.toml",
          "name = '" + name + "'\nconnection = [0]\n[[body]]\nmass = 1\ninertia = [1, 1, 1]\n");
  }
  const json all = json_of({"check", "some", "--functions", "energy", "--json", "--states", "2"});
  ASSERT_EQ(all.size(), 2u);
  EXPECT_EQ(all.at(0).at("model"), "a");
  EXPECT_EQ(all.at(1).at("model"), "b");
}

TEST_F(Check, beyond_a_bound_it_fails_with_status_1) {
  const std::vector<std::string> command = {"check", model("free_body"), "--functions", "energy,accelerations"};
  for (const char* bound : {"--bound", "--generic-bound"}) {
    std::vector<std::string> arguments = command;
    arguments.insert(arguments.end(), {bound, "0"});
    const Answer text = kanec(arguments);
    EXPECT_EQ(text.status, 1);
    EXPECT_THAT(text.err, HasSubstr("kanec: check failed: "));
    EXPECT_THAT(text.out, HasSubstr("beyond the bound"));
    arguments.emplace_back("--json");
    const Answer machine = kanec(arguments);
    EXPECT_EQ(machine.status, 1);
    EXPECT_FALSE(json::parse(machine.out).at("passed"));
  }
}

// A compiler that changes the mass of the body, 0.8 kg, before it compiles.
TEST_F(Check, a_wrong_number_in_the_compiled_code_is_found) {
  const std::string real = compile::find_compiler("").path.string();
  const fs::path script = work() / "wrong";
  write("wrong", "#!/bin/sh\nfor word; do case $word in --version) exec '" + real +
                     "' --version;; *_abi.cpp) folder=$(dirname \"$word\");; esac; done\n"
                     "sed -i 's/(0\\.8)/(0.8000001)/' \"$folder\"/free_body.hpp\n"
                     "grep -q 0.8000001 \"$folder\"/free_body.hpp && exec '" +
                     real + "' \"$@\"\n");
  fs::permissions(script, fs::perms(0700));
  const std::vector<std::string> more = {model("free_body"), "--functions", "energy",
                                         "--no-cache",       "--compiler",  script.string()};
  const auto with = [&more](std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  };
  const Answer answer = kanec(with({"check", "--json"}));
  EXPECT_EQ(answer.status, 1) << answer.err;
  const json energy = json::parse(answer.out).at("functions").at(0);
  EXPECT_GT(energy.at("largest_ulps"), 1e6);  // up to 1e-7 of the kinetic energy is up to 5e8 ulps
  EXPECT_GT(energy.at("generic"), 1e-9);
  refuses(with({"bench"}), "not timed", {"wrong"});
}

TEST_F(Check, states_follow_from_the_seed_alone) {
  const auto report = [this](const std::string& seed) {
    return json_of({"check", model("free_body"), "--json", "--seed", seed}).at("functions");
  };
  EXPECT_EQ(report("5"), report("5"));
  EXPECT_NE(report("5"), report("6"));
}

TEST_F(Check, text_states_the_bounds) {
  const Answer answer = kanec({"check", model("free_body"), "--states", "3"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_THAT(answer.out, HasSubstr("free_body: 3 states, seed 1; bounds 200 ulps and 1e-12"));
}

}  // namespace
}  // namespace kanec::cli::test
