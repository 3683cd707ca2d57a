// Several processes on one cache, and processes that die in the middle. Oracles: exit statuses, the counting compiler.
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <csignal>
#include <functional>

#include "runtime/base/descriptor.hpp"
#include "runtime/compile/lock.hpp"
#include "tests/compile/bench.hpp"

namespace kanec::compile::test {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;
using testing::SizeIs;
using namespace std::chrono_literals;

// A process that builds the toy; ends with status 0 when it got it.
pid_t start_build(const Options& options) {
  const pid_t child = ::fork();
  if (child != 0) return child;
  try {
    ::_exit(evaluate(build(toy(), options)) == -12.0 ? 0 : 1);
  } catch (...) {
    ::_exit(2);
  }
}

int status_of(pid_t child) {
  int status = -1;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
}

std::vector<int> build_at_once(int processes, const Options& options) {
  std::vector<pid_t> children;
  for (int i = 0; i < processes; ++i) children.push_back(start_build(options));
  std::vector<int> statuses;
  for (const pid_t child : children) statuses.push_back(status_of(child));
  return statuses;
}

class Processes : public Bench {
 protected:
  // A compiler that does its work only once so many are running; it gives up, and fails, after a while.
  void write_waiting_compiler(int processes) const {
    write_compiler("tries=0\nwhile test $(wc -l < '" + (root() / "runs").string() + "') -lt " +
                   std::to_string(processes) +
                   "; do\n  tries=$((tries + 1))\n  test $tries -gt 1000 && exit 1\n  sleep 0.01\ndone");
  }
};

TEST_F(Processes, two_on_a_cold_cache_succeed_and_compile_once) {
  write_compiler("sleep 0.1");  // long enough for the other one to come to the lock
  EXPECT_THAT(build_at_once(2, options), ElementsAre(0, 0));
  EXPECT_EQ(runs(), 1);
  EXPECT_THAT(entries(), SizeIs(1));
}

TEST_F(Processes, all_succeed_where_locks_are_not_to_be_had) {
  write_waiting_compiler(3);
  // A first build, which needs not wait, tells the entry's name; a folder in the place of its lock file can be no lock,
  // and is not cleared away while it is used.
  std::ofstream(root() / "runs") << "\n\n\n";
  const std::string entry = make_entry().filename().string();
  fs::remove_all(cache() / entry);
  fs::remove(root() / "runs");
  const fs::path obstacle = cache() / "tmp" / (entry + ".lock");
  fs::create_directory(obstacle);
  const Descriptor user(::open(obstacle.c_str(), O_RDONLY | O_CLOEXEC));
  ASSERT_EQ(::flock(user.get(), LOCK_EX | LOCK_NB), 0);
  EXPECT_THAT(build_at_once(3, options), ElementsAre(0, 0, 0));
  EXPECT_EQ(runs(), 3);
  EXPECT_THAT(entries(), ElementsAre(entry));
  EXPECT_TRUE(build(toy(), options).from_cache());
  fs::remove(obstacle);
}

TEST_F(Processes, failure_of_the_first_does_not_stop_the_second) {
  write_compiler("test $(wc -l < '" + (root() / "runs").string() + "') -eq 1 && exit 1");
  EXPECT_THAT(build_at_once(2, options), testing::UnorderedElementsAre(0, 2));
  EXPECT_EQ(runs(), 2);
}

TEST_F(Processes, what_a_killed_one_left_is_no_obstacle_and_is_cleared_away) {
  const std::string kill_once =
      "test $(wc -l < '" + (root() / "runs").string() + "') -eq 1 && kill -KILL $PPID && exit 1";
  write_compiler(kill_once);
  EXPECT_EQ(status_of(start_build(options)), -SIGKILL);
  EXPECT_THAT(entries(), IsEmpty());
  ASSERT_THAT(names(cache() / "tmp"), SizeIs(2));  // its folder and its lock file
  EXPECT_EQ(evaluate(build(toy(), options)), -12.0);
  EXPECT_EQ(runs(), 2);
}

TEST_F(Processes, what_a_killed_one_left_is_cleared_away_by_a_hit_as_well) {
  make_entry();
  write_file(cache() / "tmp" / "other.lock", "");
  fs::create_directories(cache() / "tmp" / "other.AbCdEf" / "made");
  EXPECT_TRUE(build(toy(), options).from_cache());
  EXPECT_THAT(names(cache() / "tmp"), IsEmpty());
}

TEST_F(Processes, what_a_killed_one_left_outside_the_cache_is_cleared_away) {
  const fs::path temporary = root() / "temporary";
  fs::create_directory(temporary);
  const Variable variable("TMPDIR", temporary.string());
  options.use_cache = false;
  write_compiler("test $(wc -l < '" + (root() / "runs").string() + "') -eq 1 && kill -KILL $PPID && exit 1");
  EXPECT_EQ(status_of(start_build(options)), -SIGKILL);
  ASSERT_THAT(names(temporary), SizeIs(1));
  EXPECT_EQ(evaluate(build(toy(), options)), -12.0);
  EXPECT_THAT(names(temporary), IsEmpty());
}

TEST_F(Processes, only_what_nobody_uses_is_cleared_away) {
  for (const char* name : {"unused", "in_use"}) fs::create_directories(root() / "sweep" / name / "sub");
  write_file(root() / "sweep" / "file", "");
  const Descriptor user(::open((root() / "sweep" / "in_use").c_str(), O_RDONLY | O_CLOEXEC));
  ASSERT_EQ(::flock(user.get(), LOCK_EX | LOCK_NB), 0);
  sweep(root() / "sweep");
  EXPECT_THAT(names(root() / "sweep"), ElementsAre("in_use"));
  EXPECT_NO_THROW(sweep(root() / "none"));
}

TEST_F(Processes, lock_waits_until_its_holder_ends) {
  const fs::path path = root() / "lock";
  const pid_t holder = ::fork();
  if (holder == 0) {
    {
      const Lock lock(path, 0ms);
      write_file(root() / "held", "");
      while (!fs::exists(root() / "release")) ::usleep(1000);
    }
    ::_exit(0);
  }
  while (!fs::exists(root() / "held")) ::usleep(1000);
  EXPECT_FALSE(Lock(path, 20ms).held());
  write_file(root() / "release", "");
  EXPECT_TRUE(Lock(path, 60s).held());
  EXPECT_EQ(status_of(holder), 0);
  EXPECT_FALSE(fs::exists(path));
}

// Each holder removes the file that the next one may just have opened.
TEST_F(Processes, lock_has_one_holder_at_a_time_although_its_file_comes_and_goes) {
  const fs::path path = root() / "lock", marker = root() / "marker";
  const auto take_turns = [&] {
    for (int i = 0; i < 3000; ++i) {
      const Lock lock(path, 60s);
      const Descriptor mine(::open(marker.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0600));
      if (!lock.held() || !mine) return 1;
      ::unlink(marker.c_str());
    }
    return 0;
  };
  std::vector<pid_t> children;
  for (int i = 0; i < 3; ++i) {
    children.push_back(::fork());
    if (children.back() == 0) ::_exit(take_turns());
  }
  for (const pid_t child : children) EXPECT_EQ(status_of(child), 0);
  EXPECT_FALSE(fs::exists(path));
}

// A process that holds the lock until it is killed.
pid_t start_holder(const fs::path& path) {
  const pid_t holder = ::fork();
  if (holder == 0) {
    const Lock lock(path, 0ms);
    while (lock.held()) ::pause();
    ::_exit(1);
  }
  while (!fs::exists(path) || fs::file_size(path) == 0) ::usleep(1000);
  return holder;
}

void kill_holder(pid_t holder) {
  ::kill(holder, SIGKILL);
  status_of(holder);
}

// What is told while a lock is waited for, and how long that takes [s].
struct Told {
  std::vector<std::string> lines;
  bool held = false;
  double seconds = 0.0;
};

Told wait_for(const fs::path& path, std::chrono::milliseconds patience, const std::function<void()>& poll = {}) {
  Told told;
  const auto begin = std::chrono::steady_clock::now();
  const Waiting waiting{"which works", [&](const std::string& line) { told.lines.push_back(line); }, poll};
  told.held = Lock(path, patience, waiting).held();
  told.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return told;
}

// As the system keeps its name.
std::string process(pid_t number, const std::string& does = "which works") {
  const std::string program = std::string(::program_invocation_short_name).substr(0, 15);
  return "process " + std::to_string(number) + " (" + program + "), " + does;
}

TEST_F(Processes, who_waits_says_for_whom_after_two_seconds_and_when_that_is_given_up) {
  const pid_t holder = start_holder(root() / "lock");
  EXPECT_THAT(wait_for(root() / "lock", 1s).lines, IsEmpty());
  const Told told = wait_for(root() / "lock", 3s);
  EXPECT_FALSE(told.held);
  EXPECT_THAT(told.lines,
              ElementsAre("waiting for " + process(holder), process(holder) + ", is not waited for any longer"));
  kill_holder(holder);
}

TEST_F(Processes, stopped_holder_is_told_and_not_waited_for) {
  const pid_t holder = start_holder(root() / "lock");
  ::kill(holder, SIGSTOP);
  const Told told = wait_for(root() / "lock", 120s);
  EXPECT_FALSE(told.held);
  EXPECT_GT(told.seconds, 4.9);
  EXPECT_LT(told.seconds, 30.0);
  EXPECT_THAT(told.lines, ElementsAre("waiting for " + process(holder),
                                      process(holder) + ", is stopped and not waited for any longer (kill -CONT " +
                                          std::to_string(holder) + " lets it go on)"));
  kill_holder(holder);
}

TEST_F(Processes, dead_holder_leaves_the_lock) {
  const pid_t holder = start_holder(root() / "lock");
  kill_holder(holder);
  ASSERT_TRUE(fs::exists(root() / "lock"));
  const Told told = wait_for(root() / "lock", 120s);
  EXPECT_TRUE(told.held);
  EXPECT_LT(told.seconds, 1.0);
}

// A number that was written by a process that is dead, or by nobody.
TEST_F(Processes, holder_that_is_not_known_is_another_process) {
  for (const std::string text : {"", "1 1\n", "999999999 7\n", "garbage", "-1 -1"}) {
    write_file(root() / "lock", text);
    const Descriptor holder(::open((root() / "lock").c_str(), O_RDWR | O_CLOEXEC));
    ASSERT_EQ(::flock(holder.get(), LOCK_EX | LOCK_NB), 0);
    EXPECT_THAT(wait_for(root() / "lock", 2100ms).lines,
                ElementsAre("waiting for another process, which works", testing::_));
  }
}

TEST_F(Processes, wait_ends_with_what_is_thrown_meanwhile) {
  const pid_t holder = start_holder(root() / "lock");
  EXPECT_THROW(wait_for(root() / "lock", 120s, [] { throw std::runtime_error("interrupted"); }), std::runtime_error);
  kill_holder(holder);
}

TEST_F(Processes, what_is_no_file_of_ours_is_no_lock) {
  ASSERT_EQ(::mkfifo((root() / "pipe").c_str(), 0600), 0);
  write_file(root() / "file", "");
  fs::create_symlink(root() / "file", root() / "link");
  for (const char* name : {"pipe", "link"}) EXPECT_FALSE(Lock(root() / name, 10s).held()) << name;
  EXPECT_EQ(read_file(root() / "file"), "");
}

// The whole: a process that is stopped in the middle of compiling is neither an obstacle nor in the way later.
TEST_F(Processes, stopped_one_does_not_stop_the_second) {
  write_compiler("test $(wc -l < '" + (root() / "runs").string() + "') -eq 1 && kill -STOP $PPID");
  const pid_t first = start_build(options);
  int status = 0;
  ASSERT_EQ(::waitpid(first, &status, WUNTRACED), first);
  ASSERT_TRUE(WIFSTOPPED(status));
  std::vector<std::string> told;
  options.tell = [&told](const std::string& line) { told.push_back(line); };
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_EQ(evaluate(build(toy(), options)), -12.0);
  EXPECT_LT(std::chrono::steady_clock::now() - begin, 60s);
  ASSERT_THAT(told, SizeIs(2));
  EXPECT_EQ(told[0], "waiting for " + process(first, "which compiles the same model"));
  EXPECT_THAT(told[1], testing::HasSubstr("is stopped"));
  ::kill(first, SIGCONT);
  EXPECT_EQ(status_of(first), 0);
  EXPECT_EQ(runs(), 2);
  EXPECT_THAT(entries(), SizeIs(1));
}

}  // namespace
}  // namespace kanec::compile::test
