// Folders and files with names as strangers choose them: what is compiled, printed and typed stays what it is for plain
// ones. Oracle: the same scene in a folder with a plain name; bash for commands; rules on printed text.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <sstream>

#include "runtime/base/fit.hpp"
#include "tests/base/nasty.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

using kanec::test::nasty_names;

constexpr auto scene_text =
    "name = \"plain\"\nconnection = [0]\n[[body]]\njoint = \"revolute\"\naxis = \"y\"\nmass = 1.0\n"
    "inertia = [1.0, 1.0, 1.0]\nr = [0.0, 0.0, 1.0]\n[body.initial]\ntheta = 1.0\n"
    "[simulate]\nduration = 1.0\n";

// What is compiled in where a name gets out of its comment.
constexpr auto code = "\nstruct Stranger { Stranger() { __builtin_abort(); } } static stranger;\n#error stranger\n";

std::vector<std::string> names_of_code() { return {code, std::string("\r") + (code + 1), "back\\", "?\?", "*"}; }

class ForeignNames : public Program {
 protected:
  // "./" + name, a folder with the scene.
  std::string folder(const std::string& name) const {
    fs::create_directories(work() / name);
    std::ofstream(work() / name / "scene.toml") << scene_text;
    return "./" + name;
  }

  // One message, of printable characters.
  static void expect_clean(const Answer& answer) {
    EXPECT_EQ(fit::lines(answer.err), answer.err);
    EXPECT_EQ(fit::lines(answer.out), answer.out);
  }

  void expect_refused_in_one_line(const std::vector<std::string>& arguments, const std::string& input = {}) const {
    SCOPED_TRACE(testing::PrintToString(arguments));
    const Answer answer = kanec(arguments, input);
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    expect_clean(answer);
  }
};

TEST_F(ForeignNames, of_a_folder_change_one_line_of_the_header_and_not_its_hash) {
  const json plain = json_of({"generate", folder("plain"), "-o", "plain.hpp", "--json"});
  const std::vector<std::string> expected = lines_of(read_file(work() / "plain.hpp"));
  std::vector<std::string> all = nasty_names(), more = names_of_code();
  all.insert(all.end(), more.begin(), more.end());
  for (const std::string& name : all) {
    SCOPED_TRACE(name);
    EXPECT_EQ(json_of({"generate", folder(name), "-o", "foreign.hpp", "--json"}).at("hash"), plain.at("hash"));
    std::vector<std::string> found = lines_of(read_file(work() / "foreign.hpp"));
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (found[i] == expected[i]) continue;
      EXPECT_THAT(found[i], testing::StartsWith("// model "));
      EXPECT_TRUE(std::all_of(found[i].begin(), found[i].end(), [](char c) { return c >= ' ' && c <= '~'; }));
    }
  }
}

TEST_F(ForeignNames, of_folders_and_files_are_not_compiled) {
  for (const std::string& name : names_of_code()) {
    const std::string scene = folder(name);
    fs::copy_file(work() / name / "scene.toml", work() / name / (name + ".toml"));
    for (const std::string& path : {scene, scene + "/" + name + ".toml"}) {
      SCOPED_TRACE(path);
      const std::vector<std::string> how = {"--flags", "-O0 -trigraphs -Wall -Werror", "--no-cache"};
      std::vector<std::string> arguments = {"eval", path, "energy", "--input", "-"};
      arguments.insert(arguments.end(), how.begin(), how.end());
      const Answer answer = kanec(arguments, kanec({"eval", path, "energy", "--template"}).out);
      EXPECT_EQ(answer.status, 0) << answer.err;
      expect_clean(answer);
    }
  }
}

TEST_F(ForeignNames, of_a_folder_do_not_keep_any_command_from_its_work) {
  const std::string scene = folder(code);
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"derive", scene},
        {"ledger", scene},
        {"check", scene, "--states", "2"},
        {"simulate", scene},
        {"bench", scene, "--functions", "energy", "--min-time", "0.001", "--no-peers"},
        {"report", scene, "--integration", "--integrators", "rk4", "--limit", "0.02"}}) {
    SCOPED_TRACE(arguments.front());
    const Answer answer = kanec(arguments);
    EXPECT_EQ(answer.status, 0) << answer.err;
    expect_clean(answer);
  }
}

TEST_F(ForeignNames, are_refused_in_one_line_where_there_is_nothing) {
  const std::string scene = folder("plain");
  for (const std::string& name : nasty_names()) {
    expect_refused_in_one_line({"derive", "./" + name});
    expect_refused_in_one_line({"eval", scene, "energy", "--input", "./" + name});
    expect_refused_in_one_line({"simulate", scene, "--resume", "./" + name});
    expect_refused_in_one_line({"simulate", scene, "--ensemble", "./" + name});
    expect_refused_in_one_line({"generate", scene, "-o", "./nowhere/" + name});
    expect_refused_in_one_line({"report", "--hard", "./" + name});
    expect_refused_in_one_line({"generate", scene, "--functions", name + "?"});
    expect_refused_in_one_line({"simulate", scene, "--set", name + "=1"});
    expect_refused_in_one_line({"simulate", scene, "--bogus" + name});
    expect_refused_in_one_line({"bogus" + name});
  }
}

TEST_F(ForeignNames, leave_json_what_it_is) {
  const std::string scene = folder("plain");
  for (const std::string& name : nasty_names()) {
    SCOPED_TRACE(name);
    const Answer answer = kanec({"generate", scene, "-o", "./" + name, "--json"});
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(fit::lines(answer.out), answer.out);
    const std::string path = json::parse(answer.out).at("files").at(0).at("path");
    if (name.find('\xff') == std::string::npos) {
      EXPECT_EQ(path, "./" + name);
    }
    const Answer text = kanec({"generate", scene, "-o", "./" + name});
    expect_clean(text);
    EXPECT_THAT(text.out, HasSubstr("wrote " + fit::line("./" + name) + " ("));
  }
}

TEST_F(ForeignNames, stand_in_recommended_commands_as_a_shell_takes_them) {
  const auto bash = find_program("bash");
  if (!bash) GTEST_SKIP() << "bash is not installed";
  for (const std::string name : {"$(touch touched) 'a'", "a\nb\x1b`touch touched`"}) {
    const Answer answer = kanec({"report", folder(name), "--integration", "--integrators", "rk4", "--error", "1e-2"});
    ASSERT_EQ(answer.status, 0) << answer.err;
    const std::size_t at = answer.out.find(": kanec simulate ");
    ASSERT_NE(at, std::string::npos) << answer.out;
    const std::string command = answer.out.substr(at + 8, answer.out.find('\n', at) - at - 8);
    const ProcessResult result = run_process(
        {bash->string()}, "cd " + fit::shell(work().string()) + "\n" + KANEC_PROGRAM + " " + command + "\n");
    EXPECT_EQ(result.status, 0) << command << "\n" << result.output;
    EXPECT_FALSE(fs::exists(work() / "touched"));
  }
}

TEST_F(ForeignNames, stand_in_pages_as_text) {
  const std::string name = "`a` | [b](c) <d>\n# e";
  folder(name);
  std::ofstream(work() / name / "hard.toml")
      << "case = \"\"\"f | <g>\n`h`\\u001b\"\"\"\nsource = \"none\"\n[[run]]\nintegrator = "
         "\"rk4\"\nduration = 0.1\nkeeps = { energy = 1 }\n";
  const Answer page = kanec({"report", "--hard", "./" + name, "--short", "--markdown"});
  EXPECT_EQ(page.status, 0) << page.err;
  expect_clean(page);
  EXPECT_THAT(page.out,
              HasSubstr("Written by `` kanec report --hard $'./`a` | [b](c) <d>\\012# e' --short --markdown ``"));
  EXPECT_THAT(
      page.out,
      HasSubstr("| [\\`a\\` \\| \\[b\\](c) \\<d\\>\\\\x0a# e](%60a%60%20%7c%20%5bb%5d%28c%29%20%3cd%3e%0a%23%20e): f "
                "\\| \\<g\\>\\\\x0a\\`h\\`\\\\x1b |"));
  const Answer text = kanec({"report", "--hard", "./" + name, "--short"});
  expect_clean(text);
  EXPECT_EQ(lines_of(text.out).size(), 2u);
}

}  // namespace
}  // namespace kanec::cli::test
