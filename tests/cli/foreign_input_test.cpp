// Contents of files, options and variables of the environment as strangers choose them. Oracle: rules on printed text,
// and what must not be there afterwards.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>

#include "runtime/base/fit.hpp"
#include "tests/base/nasty.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

using kanec::test::nasty_names;
using kanec::test::nasty_texts;

class ForeignInput : public Program {
 protected:
  Answer refused_in_one_line(const std::vector<std::string>& arguments, const std::string& input = {}) const {
    SCOPED_TRACE(testing::PrintToString(arguments) + " " + input.substr(0, 100));
    Answer answer = kanec(arguments, input);
    EXPECT_EQ(answer.status, 2);
    EXPECT_EQ(std::count(answer.err.begin(), answer.err.end(), '\n'), 1) << answer.err;
    EXPECT_EQ(fit::lines(answer.err), answer.err);
    EXPECT_THAT(answer.out, IsEmpty());
    return answer;
  }

  void write_script(const std::string& name, const std::string& text) const {
    write(name, "#!/bin/sh\n" + text);
    fs::permissions(work() / name, fs::perms(0700));
  }

  const std::string scene_ = model("pendulum");
};

TEST_F(ForeignInput, headers_of_tables_are_refused_in_one_line) {
  for (const std::string& text : nasty_texts()) {
    write("table.csv", text + "," + text + "\n1,2\n");
    refused_in_one_line({"simulate", scene_, "--resume", "table.csv"});
    refused_in_one_line({"simulate", scene_, "--ensemble", "table.csv"});
    write("table.csv", "theta_1\n" + text + "\n");
    refused_in_one_line({"simulate", scene_, "--ensemble", "table.csv"});
  }
}

TEST_F(ForeignInput, json_is_refused_in_one_line) {
  for (const std::string& text : nasty_texts()) {
    refused_in_one_line({"eval", scene_, "energy", "--input", "-"}, text);
    refused_in_one_line({"eval", scene_, "energy", "--input", "-"}, "{\"" + text + "\": 1}");
    const std::string value = json(text).dump(-1, ' ', false, json::error_handler_t::replace);
    refused_in_one_line({"eval", scene_, "energy", "--input", "-"}, "{" + value + ": 1}");
    refused_in_one_line({"eval", scene_, "energy", "--input", "-"}, "{\"x\": " + value + "}");
  }
}

TEST_F(ForeignInput, scenes_are_refused_in_one_line) {
  for (const std::string& text : nasty_texts()) {
    for (const std::string& toml :
         {text + "=", fit::toml(text) + " = 1\n", "name = " + fit::toml(text) + "\n", "name = '''" + text + "'''\n",
          "name = 'a'\nconnection = " + text + "x\n",
          "name = 'a'\nconnection = [0]\n[[body]]\nmass = 1\ninertia = [1, 1, 1]\n[[load]]\nname "
          "= 'l'\nkind = 'force'\nbody = 'body_1'\nvector = [0, 0, " +
              fit::toml("1 + " + text) + "]\n"}) {
      write("scene.toml", toml);
      refused_in_one_line({"derive", "scene.toml"});
    }
  }
}

// U+FE7F, U+FEBF, U+FEFB and a byte order mark that is not the first: toml++ 3.3 has no behaviour for some of them.
TEST_F(ForeignInput, letters_outside_of_quotes_are_refused_with_their_line) {
  for (const std::string letter : {"\ufe7f", "\ufebf", "\ufefb", "\ufeff\ufeff", "\u00e9", "\xff"})
    for (const std::string before : {"", "name = 'a'\n \t"}) {
      write("scene.toml", before + letter + "name = 'b'\n");
      const std::string line = before.empty() ? "1" : "2";
      EXPECT_THAT(refused_in_one_line({"derive", "scene.toml"}).err,
                  HasSubstr("scene.toml:" + line + ": found the character \""));
    }
  write("scene.toml", "\ufeffname = 'a' # \ufe7f\nconnection = [0]\n[[body]]\nmass = 1\ninertia = [1, 1, 1]\n");
  EXPECT_EQ(kanec({"derive", "scene.toml"}).status, 0);
}

TEST_F(ForeignInput, without_end_or_too_large_is_refused) {
  std::ofstream(work() / "large").put('#');
  fs::resize_file(work() / "large", (std::uintmax_t{64} << 20) + 1);
  for (const std::string file : {"/dev/zero", "large"}) {
    const std::string message = file + ": found more than 64 MiB";
    EXPECT_THAT(refused_in_one_line({"derive", file}).err, HasSubstr(message));
    EXPECT_THAT(refused_in_one_line({"eval", scene_, "energy", "--input", file}).err, HasSubstr(message));
  }
  for (const char* option : {"--ensemble", "--resume"})
    EXPECT_THAT(refused_in_one_line({"simulate", scene_, option, "/dev/zero"}).err, HasSubstr("more than 64 MiB"));
}

TEST_F(ForeignInput, beyond_the_memory_there_is_is_refused) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "the sanitizer takes all addresses";
#endif
  std::string zeros = "{\"x\": [0";
  for (int i = 0; i < 15'000'000; ++i) zeros += ",0";
  write("state.json", zeros + "]}");
  const ProcessResult result =
      run_process({"/bin/sh", "-c", "ulimit -v 262144 && exec \"$0\" eval \"$1\" energy --input \"$2\"", KANEC_PROGRAM,
                   scene_, (work() / "state.json").string()});
  EXPECT_EQ(result.status, 2);
  EXPECT_THAT(result.output, testing::StartsWith("kanec: out of memory"));
}

TEST_F(ForeignInput, numbers_that_are_not_finite_are_refused_with_what_is_allowed) {
  const std::vector<std::pair<std::string, std::vector<std::string>>> options = {
      {"simulate", {"--duration", "--output-step", "--step", "--longest-step", "--rtol", "--atol"}},
      {"check", {"--bound", "--generic-bound"}},
      {"bench", {"--min-time"}},
      {"report", {"--duration", "--error", "--limit"}}};
  for (const auto& [command, names] : options)
    for (const std::string& name : names)
      for (const std::string value : {"nan", "-nan", "inf", "-inf", "1e999", "-1"})
        EXPECT_THAT(refused_in_one_line({command, scene_, name + "=" + value}).err,
                    HasSubstr(name + ": found " + value + "; allowed: "));
}

// What a folder's name could have the plotter or the compiler do.
TEST_F(ForeignInput, folder_for_temporary_files_is_never_obeyed) {
  const bool draws = find_program("gnuplot").has_value();
  std::vector<std::string> all = {"\nsystem('touch touched')\n#", "|touch touched; #", "`touch touched`", "-fplugin=x",
                                  "@x"};
  for (const std::string name : {"'; touch touched; '", "\"$(touch touched)\"", "\x1b\xff\u202e"}) all.push_back(name);
  for (const std::string& name : all) {
    SCOPED_TRACE(name);
    fs::create_directory(work() / name);
    const Variable relative("TMPDIR", name);
    std::vector<std::string> arguments = {"simulate", scene_, "--duration", "0.1", "--no-cache"};
    if (draws) arguments.insert(arguments.end(), {"--plot", "plot.svg"});
    const Answer answer = kanec(arguments);
    EXPECT_EQ(answer.status, 0) << answer.err;
    EXPECT_EQ(fs::exists(work() / "plot.svg"), draws);
    EXPECT_FALSE(fs::exists(work() / "touched"));
    fs::remove(work() / "plot.svg");
  }
}

TEST_F(ForeignInput, compilers_named_so_are_told_in_one_line) {
  for (const std::string& name : nasty_names()) {
    const Variable compiler("KANEC_CXX", name);
    refused_in_one_line({"simulate", scene_});
  }
}

TEST_F(ForeignInput, words_of_a_compiler_keep_their_lines_and_nothing_else) {
  write_script("my 'broken' c++",
               "test \"$1\" = --version && echo 1.0 && exit\nprintf 'a.cpp:1:\\n\\terror "
               "\\033[1m\\342\\200\\256\\r\\n' >&2\nexit 1\n");
  const std::string compiler = (work() / "my 'broken' c++").string();
  const Answer answer = kanec({"simulate", scene_, "--compiler", compiler, "--no-cache"});
  EXPECT_EQ(answer.status, 2);
  EXPECT_THAT(answer.err, HasSubstr("\na.cpp:1:\n\terror \\x1b[1m\\u202e\n"));
  EXPECT_THAT(answer.err, HasSubstr("\n  command: " + fit::shell(compiler) + " -std=c++17 "));
}

}  // namespace
}  // namespace kanec::cli::test
