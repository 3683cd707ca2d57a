// What hard.toml may say, and what becomes of a run that stops.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/hard_case.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <map>

#include "runtime/base/error.hpp"
#include "runtime/study/hard/outcome.hpp"
#include "tests/base/environment.hpp"
#include "tests/base/folder.hpp"

namespace kanec::hard::test {
namespace {

using kanec::test::Folder;
using kanec::test::Variable;
using testing::HasSubstr;

class Reading : public testing::Test {
 protected:
  HardCase read(const std::string& hard, const std::string& body = "mass = 1.0\ninertia = [1.0, 2.0, 3.0]\n") const {
    std::ofstream(folder_.path() / "scene.toml") << "name = \"a\"\nconnection = [0]\n[[body]]\n" << body;
    std::ofstream(folder_.path() / "hard.toml") << hard;
    return read_hard_case(folder_.path());
  }
  void refuses(const std::string& hard, const std::string& message) const {
    try {
      read(hard);
      ADD_FAILURE() << "nothing was thrown: " << message;
    } catch (const SceneError& error) {
      EXPECT_THAT(error.what(), HasSubstr(message));
    }
  }
  const std::string head = "case = \"c\"\nsource = \"s\"\n";

 private:
  Folder folder_;
};

TEST_F(Reading, a_short_run_is_as_the_full_one_but_for_what_it_says) {
  const HardCase hard = read(head +
                             "answer = \"torque_free\"\n[[run]]\nintegrator = \"gauss6\"\nduration = 5\n"
                             "keeps = { energy = 1e-9 }\n[run.short]\nduration = 1\n");
  ASSERT_EQ(hard.runs.size(), 1u);
  EXPECT_EQ(hard.answer, "torque_free");
  EXPECT_EQ(hard.runs[0].full.settings.duration, 5.0);
  EXPECT_EQ(hard.runs[0].brief.settings.duration, 1.0);
  EXPECT_EQ(hard.runs[0].brief.settings.integrator, "gauss6");
  ASSERT_EQ(hard.runs[0].brief.keeps.size(), 1u);
  EXPECT_EQ(hard.runs[0].brief.keeps[0].most, 1e-9);
}

TEST_F(Reading, what_has_no_meaning_is_refused_with_its_line) {
  refuses(head, "run: ");
  refuses("case = \"c\"\n[[run]]\n", "source: ");
  refuses(head + "[[run]]\nduratio = 1\n", "hard.toml:4: run.duratio: found an unknown key");
  refuses(head + "[[run]]\nduration = -1\n", "hard.toml:4: run.duration: ");
  refuses(head + "[[run]]\nintegrator = \"euler\"\n", "hard.toml:4: run.integrator: ");
  refuses(head + "[[run]]\nkeeps = { energy = 0 }\n", "hard.toml:4: ");
  refuses(head + "[[run]]\n[run.short]\nkeep = 0\n", "hard.toml:5: run.short.keep: found an unknown key");
  refuses(head + "[[run]]\nduration = 1e7\n", "run[1].output_step (of scene.toml): found 0.01, which makes 1e+09 rows");
  refuses(head + "[[run]]\n[run.short]\nduration = 1e7\n", "run.short.output_step (of the run): found 0.01");
  refuses(head + "[[run\n", "hard.toml:3");
}

class Running : public Reading {
 private:
  Variable cache_{"KANEC_CACHE", KANEC_BINARY_DIR "/tests/hard_cache"};
  Variable flags_{"KANEC_CXXFLAGS", "-O0"};
};

TEST_F(Running, a_short_run_may_have_an_integrator_of_its_own) {
  const std::string run =
      "[[run]]\nintegrator = \"rk4\"\nstep = 0.1\nduration = 1\nkeeps = { energy = 1 }\n[run.short]\n";
  const HardCase hard = read(head + run + "integrator = \"taylor\"\n" + run + "integrator = \"cvode_bdf\"\n",
                             "mass = 1.0\ninertia = [1.0, 2.0, 3.0]\n[body.initial]\nomega = [1.0, 1.0, 1.0]\n");
  const CompiledModel model = compiled(hard);
  for (const auto& one : hard.runs)
    for (const Length& length : {one.full, one.brief}) EXPECT_TRUE(outcome(hard, length, model).holds());
}

TEST_F(Running, a_bound_on_what_the_case_does_not_have_is_refused) {
  const HardCase hard = read(head + "[[run]]\nduration = 0.1\nkeeps = { attitude = 1 }\n");
  const CompiledModel model = compiled(hard);
  EXPECT_THROW(outcome(hard, hard.runs[0].full, model), SceneError);
}

TEST_F(Running, an_answer_that_is_not_of_the_scene_is_refused_with_its_line) {
  const std::string run = "[[run]]\nduration = 0.1\nkeeps = { energy = 1 }\n";
  const std::map<std::string, std::string> refused = {
      {"kepplr", "answer: found \"kepplr\"; allowed: "},
      {"kepler", "kepler: found another scene; allowed: "},
      {"torque_free", "torque_free: found a start at rest"}};  // told by the first row
  for (const auto& [answer, message] : refused) {
    const HardCase hard = read(head + "answer = \"" + answer + "\"\n" + run);
    const CompiledModel model = compiled(hard);
    try {
      outcome(hard, hard.runs[0].full, model);
      ADD_FAILURE() << "nothing was thrown: " << answer;
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), testing::StartsWith(hard.file + ":3: " + message));
    }
  }
}

TEST_F(Running, a_run_that_stops_says_when_and_at_which_coordinate_of_which_body) {
  const HardCase hard = read(head + "[[run]]\nduration = 3\nkeeps = { energy = 1 }\n",
                             "joint = \"prismatic\"\naxis = \"x\"\nmass = 1.0\ninertia = [0.0, 0.0, 0.0]\n"
                             "effort = \"1 + 1e-3*sqrt(2 - s_1)\"\n");
  const CompiledModel model = compiled(hard);
  const Outcome found = outcome(hard, hard.runs[0].full, model);
  EXPECT_FALSE(found.holds());
  EXPECT_THAT(found.failure, HasSubstr("integration stopped at t = "));
  EXPECT_THAT(found.failure, HasSubstr("sdot_1"));
}

// The answer of the whole: two runs of half the time, the second from where the first ended.
TEST_F(Running, a_run_goes_on_from_its_last_state) {
  const HardCase hard = read(head + "[[run]]\nintegrator = \"gauss6\"\nduration = 2\nkeeps = { energy = 1 }\n",
                             "mass = 1.0\ninertia = [1.0, 2.0, 3.0]\n[body.initial]\nomega = [1.0, 1.0, 1.0]\n");
  const CompiledModel model = compiled(hard);
  const Solver solver(model.library.abi());
  integrate::Options options = outcome(hard, hard.runs[0].full, model).options;
  const auto x = scene::initial_coordinates(hard.scene), y = scene::initial_speeds(hard.scene);
  const Summary whole = simulate(solver, x, y, options);
  options.duration = 1.0;
  const Summary first = simulate(solver, x, y, options);
  const Summary second = simulate(solver, first.x, first.y, options);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(second.x[i], whole.x[i], 1e-14);
  for (std::size_t i = 0; i < y.size(); ++i) EXPECT_NEAR(second.y[i], whole.y[i], 1e-14);
}

TEST_F(Running, a_bound_that_is_not_kept_is_told) {
  const HardCase hard = read(head +
                                 "answer = \"torque_free\"\n[[run]]\nintegrator = \"rk4\"\nstep = 0.1\nduration = 5\n"
                                 "keeps = { attitude = 1e-12 }\n",
                             "mass = 1.0\ninertia = [1.0, 2.0, 3.0]\n[body.initial]\nomega = [1.0, 1.0, 1.0]\n");
  const CompiledModel model = compiled(hard);
  const Outcome found = outcome(hard, hard.runs[0].full, model);
  EXPECT_EQ(found.failure, "");
  EXPECT_FALSE(found.holds());
}

}  // namespace
}  // namespace kanec::hard::test
