// What `kanec report --hard` writes, and its exit status. Oracle: what the scene of the test keeps and does not.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/study/hard/hard_report.hpp"
#include "runtime/study/hard/hard_text.hpp"
#include "tests/base/environment.hpp"
#include "tests/base/folder.hpp"

namespace kanec::hard::test {
namespace {

namespace fs = std::filesystem;
using kanec::test::Folder;
using kanec::test::Variable;
using testing::HasSubstr;

// Two cases in a folder: a spinning body by RK4, which keeps its energy to 1e-3 and not to 1e-15.
class HardReport : public testing::Test {
 protected:
  HardReport() {
    write("kept", "1e-3");
    write("lost", "1e-15");
  }

  std::string folder(const std::string& name = "") const { return (folder_.path() / "cases" / name).string(); }

  // Its output, and the status that it must have.
  std::string told(HardOptions options, int status) const {
    options.output = (folder_.path() / "page").string();
    EXPECT_EQ(report_hard_cases(options), status == 0);
    return read_file(options.output);
  }

 private:
  void write(const std::string& name, const std::string& bound) const {
    fs::create_directories(folder(name));
    std::ofstream(fs::path(folder(name)) / "scene.toml")
        << "name = \"" << name << "\"\nconnection = [0]\n[[body]]\nmass = 1.0\ninertia = [1.0, 2.0, 3.0]\n"
        << "[body.initial]\nomega = [1.0, 1.0, 1.0]\n";
    std::ofstream(fs::path(folder(name)) / "hard.toml")
        << "case = \"a body\"\nsource = \"none\"\n[[run]]\nintegrator "
           "= \"rk4\"\nstep = 0.1\noutput_step = 0.1\nduration = 9\nkeeps = { energy = "
        << bound << " }\n[run.short]\nduration = 3\n";
  }

  Folder folder_;
  Variable cache_{"KANEC_CACHE", KANEC_BINARY_DIR "/tests/hard_cache"};
  Variable flags_{"KANEC_CXXFLAGS", "-O0"};
};

TEST_F(HardReport, of_a_folder_has_every_case_and_says_what_is_not_kept) {
  const std::string text = told({{folder()}}, 1);
  EXPECT_THAT(text, HasSubstr("kept  rk4, h 0.1 s  9 s"));
  EXPECT_THAT(text, HasSubstr("lost  rk4"));
  EXPECT_THAT(text, HasSubstr("(1e-15) NOT KEPT"));
  EXPECT_THAT(text, testing::Not(HasSubstr("(0.001) NOT KEPT")));
}

TEST_F(HardReport, of_one_case_succeeds_where_all_is_kept) {
  EXPECT_THAT(told({{folder("kept")}}, 0), HasSubstr("kept  rk4"));
  EXPECT_THAT(told({{folder("kept")}, true}, 0), HasSubstr("rk4, h 0.1 s  3 s"));
}

TEST_F(HardReport, as_page_and_for_machines_says_the_same) {
  HardOptions options{{folder()}};
  options.markdown = true;
  EXPECT_THAT(told(options, 1), HasSubstr("| [kept](cases/kept): a body | rk4, h 0.1 s | 9 s | 90 |"));
  options.markdown = false;
  options.json = true;
  const nlohmann::json cases = nlohmann::json::parse(told(options, 1));
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].at("runs")[0].at("holds"), true);
  EXPECT_EQ(cases[1].at("runs")[0].at("kept")[0].at("holds"), false);
}

TEST_F(HardReport, as_page_links_to_its_cases_from_where_it_stands) {
  const std::vector<CaseReport> reports = {{folder("kept"), read_hard_case(folder("kept")), {Outcome{}}}};
  EXPECT_THAT(report_markdown(reports, "", folder("kept")), HasSubstr("| [kept](.): a body |"));
  EXPECT_THAT(report_markdown(reports, "", folder("lost")), HasSubstr("| [kept](../kept): a body |"));
}

TEST_F(HardReport, of_a_run_that_failed_shows_no_figures) {
  Outcome failed;
  failed.failure = "integration stopped";
  failed.options.duration = 9.0;
  const std::vector<CaseReport> reports = {{folder("kept"), read_hard_case(folder("kept")), {failed}}};
  EXPECT_THAT(report_markdown(reports, "", folder()), HasSubstr("| 9 s |  |  |  |  | integration stopped |"));
  EXPECT_THAT(report_text(reports), testing::ContainsRegex("9 s +integration stopped"));
  const Json run = report_json(reports)[0].at("runs")[0];
  EXPECT_EQ(run.at("failure"), "integration stopped");
  for (const char* figure : {"steps", "evaluations", "wall_seconds", "emitted_ulps", "generic_ulps", "float_error"})
    EXPECT_TRUE(run.at(figure).is_null()) << figure;
}

TEST_F(HardReport, refuses_a_folder_without_cases) {
  fs::create_directory(folder("empty"));
  EXPECT_THROW(report_hard_cases({{folder("empty")}}), InputError);
  EXPECT_THROW(report_hard_cases({{folder("nowhere")}}), InputError);
}

}  // namespace
}  // namespace kanec::hard::test
