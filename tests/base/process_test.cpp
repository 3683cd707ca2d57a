// Oracles: the standard programs cat, printf, sh, ls and true.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/process.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/time.h>
#include <unistd.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <functional>
#include <string>

#include "runtime/base/descriptor.hpp"
#include "runtime/base/error.hpp"
#include "tests/base/environment.hpp"
#include "tests/base/folder.hpp"
#include "tests/base/message_of.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::Variable;

constexpr std::size_t large = std::size_t{8} << 20;  // far more than any pipe holds

using kanec::test::message_of;

void write_script(const fs::path& path, const std::string& text, int rights = 0700) {
  std::ofstream(path) << text;
  fs::permissions(path, fs::perms(rights));
}

// What a signal does during one test.
class Action {
 public:
  Action(int signal, void (*handler)(int)) : signal_(signal) {
    struct sigaction action {};
    action.sa_handler = handler;  // without SA_RESTART: system calls end with EINTR
    ::sigaction(signal, &action, &before_);
  }
  ~Action() { ::sigaction(signal_, &before_, nullptr); }
  Action(const Action&) = delete;
  Action& operator=(const Action&) = delete;

 private:
  int signal_;
  struct sigaction before_ {};
};

TEST(Process, output_and_exit_status_are_returned) {
  const ProcessResult result = run_process({"sh", "-c", "echo out; exit 3"});
  EXPECT_EQ(result.status, 3);
  EXPECT_EQ(result.output, "out\n");
}

TEST(Process, standard_output_and_error_keep_their_order) {
  EXPECT_EQ(run_process({"sh", "-c", "echo a; echo b >&2; echo c; echo d >&2"}).output, "a\nb\nc\nd\n");
}

TEST(Process, death_by_a_signal_is_128_and_its_number) {
  EXPECT_EQ(run_process({"sh", "-c", "kill -KILL $$"}).status, 128 + SIGKILL);
}

TEST(Process, variables_stand_beside_our_own_or_in_their_place) {
  const Variable ours("KANEC_OURS", "ours"), other("KANEC_OURS_TOO", "too");
  const std::vector<std::string> print = {"sh", "-c", "echo $KANEC_OURS $KANEC_OURS_TOO $KANEC_NEW"};
  EXPECT_EQ(run_process(print, {}, {{"KANEC_OURS", "$a 'b"}, {"KANEC_NEW", "new"}}).output, "$a 'b too new\n");
  EXPECT_EQ(run_process(print).output, "ours too\n");
}

TEST(Process, no_shell_sees_the_arguments) {
  const std::vector<std::string> odd = {"a b", "$HOME", "`id`", "*", "'", "\"", "a;b", "", "\\n", "x\ny", "|"};
  std::vector<std::string> argv = {"printf", "[%s]"};
  argv.insert(argv.end(), odd.begin(), odd.end());
  std::string expected;
  for (const std::string& argument : odd) expected += "[" + argument + "]";
  EXPECT_EQ(run_process(argv).output, expected);
}

TEST(Process, input_reaches_the_program) {
  EXPECT_EQ(run_process({"cat"}, "one\ntwo").output, "one\ntwo");
  EXPECT_EQ(run_process({"cat"}).output, "");
}

TEST(Process, large_input_and_output_do_not_block_each_other) {
  std::string input;
  for (std::size_t i = 0; input.size() < large; ++i) input += std::to_string(i);
  const ProcessResult result = run_process({"cat"}, input);
  EXPECT_EQ(result.status, 0);
  EXPECT_TRUE(result.output == input);
}

TEST(Process, program_that_does_not_read_its_input_does_no_harm) {
  const ProcessResult result = run_process({"true"}, std::string(large, 'x'));
  EXPECT_EQ(result.status, 0);
  EXPECT_EQ(result.output, "");
}

TEST(Process, program_sees_broken_pipes_also_where_we_ignore_them) {
  const Action ignored(SIGPIPE, SIG_IGN);
  EXPECT_EQ(run_process({"sh", "-c", "kill -PIPE $$"}).status, 128 + SIGPIPE);
}

TEST(Process, interrupted_system_calls_are_continued) {
  const Action alarm(SIGALRM, [](int) {});
  const itimerval often{{0, 1000}, {0, 1000}};
  const itimerval never{};
  ::setitimer(ITIMER_REAL, &often, nullptr);
  const ProcessResult result = run_process({"sh", "-c", "sleep 0.1; cat; sleep 0.1; exit 4"}, std::string(large, 'x'));
  ::setitimer(ITIMER_REAL, &never, nullptr);
  EXPECT_EQ(result.status, 4);
  EXPECT_EQ(result.output.size(), large);
}

// What this program was itself started with may be inherited; ls opens one more, the folder it lists.
TEST(Process, program_inherits_no_descriptors_of_ours) {
  std::ptrdiff_t inherited = 0;
  for (const std::string& name : test::names("/proc/self/fd")) {
    const int flags = ::fcntl(std::stoi(name), F_GETFD);
    if (flags >= 0 && (flags & FD_CLOEXEC) == 0) ++inherited;
  }
  const std::string listed = run_process({"ls", "/proc/self/fd"}, "input").output;
  EXPECT_EQ(std::count(listed.begin(), listed.end(), '\n'), inherited + 1);
}

TEST(Process, nothing_stays_open_here) {
  const auto count = [] { return test::names("/proc/self/fd").size(); };
  const std::size_t before = count();
  run_process({"cat"}, "x");
  EXPECT_THROW(run_process({"/proc/none"}), FileError);
  EXPECT_EQ(count(), before);
}

TEST(Process, closed_standard_streams_of_ours_do_not_matter) {
  const Descriptor in(::fcntl(0, F_DUPFD_CLOEXEC, 10)), out(::fcntl(1, F_DUPFD_CLOEXEC, 10));
  ::close(0);
  ::close(1);
  const ProcessResult result = run_process({"cat"}, "text");
  if (in) ::dup2(in.get(), 0);
  if (out) ::dup2(out.get(), 1);
  EXPECT_EQ(result.output, "text");
}

TEST(Process, unknown_exit_status_is_an_error) {
  const Action ignored(SIGCHLD, SIG_IGN);
  EXPECT_EQ(message_of([] { run_process({"true"}); }), "true: its exit status is not known: SIGCHLD is ignored");
}

TEST(Process, program_that_is_not_there_is_named) {
  EXPECT_EQ(message_of([] { run_process({"kanec-none"}); }), "kanec-none: no such program on PATH");
  EXPECT_EQ(message_of([] { run_process({"/proc/none"}); }), "/proc/none: No such file or directory");
}

TEST(Process, file_that_is_no_program_is_named) {
  const Folder folder;
  const std::string path = (folder.path() / "text").string();
  write_script(path, "echo x\n", 0600);
  EXPECT_EQ(message_of([&] { run_process({path}); }), path + ": Permission denied");
  write_script(path, "echo x\n");  // executable, but neither a binary nor "#!": only a shell would run it
  EXPECT_EQ(message_of([&] { run_process({path}); }), path + ": Exec format error");
}

TEST(Process, programs_are_found_in_the_order_of_path) {
  const Folder first, second;
  write_script(second.path() / "tool", "#!/bin/sh\necho second\n");
  const Variable path("PATH", first.path().string() + ":" + second.path().string());
  EXPECT_EQ(find_program("tool"), second.path() / "tool");
  write_script(first.path() / "tool", "#!/bin/sh\necho first\n", 0600);
  EXPECT_EQ(find_program("tool"), second.path() / "tool");
  fs::permissions(first.path() / "tool", fs::perms(0700));
  EXPECT_EQ(find_program("tool"), first.path() / "tool");
  EXPECT_EQ(run_process({"tool"}).output, "first\n");
}

TEST(Process, folders_are_no_programs) {
  const Folder folder;
  fs::create_directory(folder.path() / "tool");
  const Variable path("PATH", folder.path().string());
  EXPECT_EQ(find_program("tool"), std::nullopt);
  EXPECT_EQ(find_program((folder.path() / "tool").string()), std::nullopt);
  EXPECT_EQ(find_program(""), std::nullopt);
}

TEST(Process, path_of_a_program_is_taken_as_it_is) {
  EXPECT_EQ(find_program("/bin/sh"), fs::path("/bin/sh"));
  EXPECT_EQ(find_program("/bin/kanec-none"), std::nullopt);
}

TEST(Process, without_path_the_programs_of_the_system_are_found) {
  const Variable path("PATH", std::nullopt);
  EXPECT_TRUE(find_program("sh").has_value());
}

}  // namespace
}  // namespace kanec
