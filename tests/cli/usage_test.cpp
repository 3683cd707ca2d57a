// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Usage : public Program {};

TEST_F(Usage, every_command_teaches_by_an_example) {
  for (const std::string command : {"derive", "generate", "simulate", "check", "eval", "bench", "ledger", "report"}) {
    SCOPED_TRACE(command);
    const Answer answer = kanec({command, "--help"});
    EXPECT_EQ(answer.status, 0);
    EXPECT_THAT(answer.out, HasSubstr("Example: "));
    EXPECT_THAT(answer.out, HasSubstr("  kanec " + command));
    EXPECT_THAT(answer.out, HasSubstr("--json"));
    EXPECT_THAT(answer.err, IsEmpty());
  }
}

TEST_F(Usage, overview_names_the_stages_and_the_exit_statuses) {
  const Answer answer = kanec({"--help"});
  EXPECT_EQ(answer.status, 0);
  for (const char* word :
       {"derive", "generate", "simulate", "check", "eval", "bench", "ledger", "report", "Exit status"})
    EXPECT_THAT(answer.out, HasSubstr(word));
}

TEST_F(Usage, version_is_one_line) {
  const Answer answer = kanec({"--version"});
  EXPECT_EQ(answer.status, 0);
  EXPECT_THAT(answer.out, testing::MatchesRegex("kanec [0-9]+\\.[0-9]+\\.[0-9]+\n"));
}

TEST_F(Usage, what_has_no_meaning_is_refused_with_the_nearest_that_has) {
  refuses({}, "a command is needed");
  refuses({"simulat"}, "no command 'simulat' (did you mean simulate?); see kanec --help");
  refuses({"simulate", "x", "--duratio", "3"}, "no option '--duratio' here (did you mean --duration?)");
  refuses({"simulate", "x", "--duratio=3"}, "did you mean --duration?");
  refuses({"--bogus"}, "no option '--bogus' here; see kanec --help");
  refuses({"derive", "x", "y"}, "one argument too many: 'y'");
  refuses({"derive", "x", "--format", "tex"}, "--format");
  refuses({"simulate", "x", "--duration", "long"}, "--duration: found \"long\"; allowed: a positive finite number");
  refuses({"check", "x", "--states", "0"}, "--states");
}

TEST_F(Usage, the_last_of_an_option_counts) {
  EXPECT_EQ(kanec({"derive", "--connection", "0", "--connection", "0,1"}).out,
            kanec({"derive", "--connection", "0,1"}).out);
}

TEST_F(Usage, exactly_one_scene_is_needed) {
  refuses({"derive"}, "no scene is given");
  refuses({"derive", "x", "--connection", "0"}, "a scene file and --connection are both given");
  refuses({"derive", "nowhere"}, "nowhere: No such file or directory");
  refuses({"derive", "."}, "scene.toml: No such file or directory");
}

TEST_F(Usage, a_folder_means_the_scene_in_it) {
  EXPECT_EQ(kanec({"derive", model("free_body")}).out, kanec({"derive", model("free_body/scene.toml")}).out);
}

TEST_F(Usage, errors_of_a_scene_name_their_place) {
  write("scene.toml", "name = \"a\"\nconnection = [0]\n[[body]]\nmas = 1.0\ninertia = [1, 1, 1]\n");
  refuses({"simulate", "."}, "scene.toml:4: body 1", {"scene.toml"});
  write("scene.toml", "name = ");
  refuses({"simulate", "."}, "scene.toml:1: ", {"scene.toml"});
  refuses({"derive", "--connection", "0,2"}, "number 2: found 2", {"scene.toml"});
}

TEST_F(Usage, notes_and_warnings_of_a_scene_are_told) {
  write("scene.toml",
        "name = \"a\"\nconnection = [0]\n[[body]]\nmass = 1.0\ninertia = [1, 1, 3]\n[body.initial]\neps = [0, 0, 1, "
        "1]\n");
  const Answer answer = kanec({"derive", "."});
  EXPECT_EQ(answer.status, 0);
  EXPECT_THAT(answer.err, HasSubstr("kanec: warning: "));
  EXPECT_THAT(answer.err, HasSubstr("triangle inequality"));
  EXPECT_THAT(answer.err, HasSubstr("kanec: note: "));
}

TEST_F(Usage, output_that_nobody_gets_is_an_error) {
  for (const std::vector<std::string>& arguments :
       {std::vector<std::string>{"--help"}, {"--version"}, {"derive", "--connection", "0"}}) {
    SCOPED_TRACE(testing::PrintToString(arguments));
    const Answer full = kanec(arguments, "", ">/dev/full");
    EXPECT_EQ(full.status, 2);
    EXPECT_EQ(full.err, "kanec: standard output: No space left on device\n");
    const Answer closed = kanec(arguments, "", ">&-");
    EXPECT_EQ(closed.status, 2);
    EXPECT_EQ(closed.err, "kanec: standard output: Bad file descriptor\n");
  }
}

}  // namespace
}  // namespace kanec::cli::test
