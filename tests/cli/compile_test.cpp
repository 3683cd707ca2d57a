// Compilation as a user of the command meets it, with a private cache and a compiler that counts its runs.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <unistd.h>

#include <algorithm>

#include "runtime/compile/compiler.hpp"
#include "tests/cli/program.hpp"

namespace kanec::cli::test {
namespace {

class Compile : public Program {
 protected:
  Compile() {
    const std::string real = compile::find_compiler("").path.string();
    write_script("count", "for word; do test \"$word\" = --version && exec '" + real +
                              "' --version; done\necho run >> '" + (tools_.path() / "runs").string() + "'\nexec '" +
                              real + "' \"$@\"\n");
    write_script("broken",
                 "for word; do test \"$word\" = --version && echo broken 1.0 && exit; done\n"
                 "echo 'all is lost' >&2\nexit 3\n");
  }

  void write_script(const std::string& name, const std::string& text) const {
    std::ofstream(tools_.path() / name) << "#!/bin/sh\n" << text;
    fs::permissions(tools_.path() / name, fs::perms(0700));
  }

  std::string tool(const std::string& name) const { return (tools_.path() / name).string(); }
  fs::path cache() const { return tools_.path() / "cache"; }

  std::vector<std::string> simulate(const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {"simulate", model("free_body"), "--duration", "0.1",
                                          "--cache",  cache().string(),   "--compiler", tool("count")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  int runs() const {
    std::ifstream file(tools_.path() / "runs");
    return static_cast<int>(std::count(std::istreambuf_iterator<char>(file), {}, '\n'));
  }

  // In the cache: found by the emitted text, and by what that follows from.
  std::vector<fs::path> libraries() const {
    std::vector<fs::path> list;
    for (const std::string& name : names(cache()))
      if (name != "tmp") list.push_back(cache() / name / "model.so");
    return list;
  }

 private:
  Folder tools_;
};

TEST_F(Compile, another_form_of_the_code_is_another_model) {
  for (const char* form : {"speed", "size", "line", "loops"})
    EXPECT_EQ(kanec(simulate({"--optimize", form})).status, 0) << form;
  EXPECT_EQ(runs(), 4);
}

TEST_F(Compile, second_run_compiles_nothing) {
  const Answer first = kanec(simulate({}));
  EXPECT_EQ(first.status, 0);
  EXPECT_THAT(first.err, HasSubstr("kanec: free_body: compiled in "));
  const Answer second = kanec(simulate({}));
  EXPECT_EQ(second.err, "kanec: free_body: from the cache\n");
  EXPECT_EQ(runs(), 1);
}

TEST_F(Compile, flags_are_handed_on_and_told_apart) {
  kanec(simulate({"--flags", "-O0"}));
  kanec(simulate({"--flags", "-O1 -g"}));
  EXPECT_EQ(runs(), 2);
  const Answer answer = kanec(simulate({"--flags", "-no-such-flag"}));
  EXPECT_EQ(answer.status, 2);
  EXPECT_THAT(answer.err, HasSubstr("-no-such-flag"));
}

TEST_F(Compile, without_cache_nothing_is_kept) {
  EXPECT_EQ(kanec(simulate({"--no-cache"})).status, 0);
  EXPECT_EQ(kanec(simulate({"--no-cache"})).status, 0);
  EXPECT_EQ(runs(), 2);
  EXPECT_THAT(names(cache()), IsEmpty());
}

// What runs alone read is no part of a model; every other number is.
TEST_F(Compile, what_is_known_is_not_derived_again) {
  write_file(work() / "scene.toml", read_file(model("pendulum") + "/scene.toml"));
  const auto told = [&] {
    return kanec({"simulate", (work() / "scene.toml").string(), "--duration", "0.1", "--compiler", tool("count"),
                  "--cache", cache().string()})
        .err;
  };
  EXPECT_THAT(told(), HasSubstr("compiled in"));
  const std::string text = read_file(work() / "scene.toml");
  write_file(work() / "scene.toml", text + "\n# a remark\n");
  EXPECT_THAT(told(), HasSubstr("from the cache"));
  EXPECT_EQ(libraries().size(), 2u);
  std::string heavier = text;
  const std::size_t mass = heavier.find("mass = ");
  ASSERT_NE(mass, heavier.npos);
  heavier.replace(mass, heavier.find('\n', mass) - mass, "mass = 1.0000000000000002");
  write_file(work() / "scene.toml", heavier);
  EXPECT_THAT(told(), HasSubstr("compiled in"));
}

TEST_F(Compile, truncated_cache_is_rebuilt_without_a_word) {
  const std::string first = kanec(simulate({"--json"})).out;
  EXPECT_EQ(libraries().size(), 2u);
  for (const fs::path& library : libraries()) fs::resize_file(library, fs::file_size(library) / 2);
  const Answer second = kanec(simulate({"--json"}));
  EXPECT_EQ(second.status, 0);
  EXPECT_THAT(second.err, testing::MatchesRegex("kanec: free_body: compiled in [^\n]* s\n"));
  EXPECT_EQ(runs(), 2);
  EXPECT_EQ(json::parse(second.out).at("final"), json::parse(first).at("final"));
}

TEST_F(Compile, no_compiler_is_told) {
  refuses(simulate({"--compiler", "no-such-compiler"}), "no C++ compiler found; tried no-such-compiler");
  const Variable path("PATH", "/nowhere");
  refuses({"simulate", model("free_body"), "--cache", cache().string()}, "install one (Debian: apt install g++)");
}

TEST_F(Compile, output_of_a_compiler_that_fails_is_shown) {
  refuses(simulate({"--compiler", tool("broken"), "--csv", "free.csv"}), "all is lost");
  EXPECT_EQ(names(cache()), std::vector<std::string>{"tmp"});
  EXPECT_THAT(names(cache() / "tmp"), IsEmpty());
}

TEST_F(Compile, cache_that_cannot_be_is_done_without) {
  const Answer answer = kanec(simulate({"--cache", "/dev/null/cache"}));
  EXPECT_EQ(answer.status, 0);
  EXPECT_THAT(answer.err, HasSubstr("kanec: note: the compiled model is not kept: "));
}

TEST_F(Compile, entry_that_others_may_write_to_is_not_read_which_is_told) {
  EXPECT_EQ(kanec(simulate({})).status, 0);
  for (const fs::path& library : libraries()) fs::permissions(library, fs::perms(0666));
  const Answer answer = kanec(simulate({}));
  EXPECT_EQ(answer.status, 0);
  for (const fs::path& library : libraries())
    EXPECT_THAT(answer.err, HasSubstr("kanec: note: " + library.string() +
                                      ": not read, because others may write to it; compiled anew\n"));
  EXPECT_EQ(runs(), 2);
}

// The first one is stopped by its compiler, which goes on.
TEST_F(Compile, who_waits_for_a_stopped_one_says_so_and_goes_on_alone) {
  const std::string real = compile::find_compiler("").path.string();
  write_script("stopping", "for word; do test \"$word\" = --version && exec '" + real + "' --version; done\ntest -e '" +
                               tool("first") + "' || { echo $PPID > '" + tool("first") +
                               "'; kill -STOP $PPID; }\nexec '" + real + "' \"$@\"\n");
  const std::vector<std::string> arguments = simulate({"--compiler", tool("stopping")});
  std::vector<std::string> command = {"/bin/sh", "-c", "\"$0\" \"$@\" >/dev/null 2>&1 &", KANEC_PROGRAM};
  command.insert(command.end(), arguments.begin(), arguments.end());
  run_process(command);
  while (!fs::exists(tool("first")) || fs::file_size(tool("first")) == 0) ::usleep(10'000);
  const std::string number = std::to_string(std::stoi(read_file(tool("first"))));
  const Answer answer = kanec(arguments);
  EXPECT_EQ(answer.status, 0);
  const std::string who = "process " + number + " (kanec), which compiles the same model";
  EXPECT_THAT(answer.err, HasSubstr("kanec: note: waiting for " + who + "\n"));
  EXPECT_THAT(answer.err, HasSubstr("kanec: note: " + who + ", is stopped and not waited for any longer"));
  run_process({"/bin/sh", "-c", "kill -KILL " + number});
}

}  // namespace
}  // namespace kanec::cli::test
