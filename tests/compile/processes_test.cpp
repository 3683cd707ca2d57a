// Several processes on one cache, and processes that die in the middle. Oracles: exit statuses, the counting compiler.
// SPDX-License-Identifier: BSD-3-Clause
#include <fcntl.h>
#include <sys/file.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>

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

void make_old(const fs::path& path) { fs::last_write_time(path, fs::file_time_type::clock::now() - 1h); }

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
  // A first build, which needs not wait, tells the entry's name; a folder in the place of its lock file can be no lock.
  std::ofstream(root() / "runs") << "\n\n\n";
  const std::string entry = make_entry().filename().string();
  fs::remove_all(cache() / entry);
  fs::remove(root() / "runs");
  const fs::path obstacle = cache() / "tmp" / (entry + ".lock");
  fs::create_directory(obstacle);
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
  for (const std::string& name : names(cache() / "tmp")) make_old(cache() / "tmp" / name);
  EXPECT_EQ(evaluate(build(toy(), options)), -12.0);
  EXPECT_EQ(runs(), 2);
}

TEST_F(Processes, only_what_is_old_and_unused_is_cleared_away) {
  for (const char* name : {"young", "old", "in_use"}) fs::create_directories(root() / "sweep" / name / "sub");
  write_file(root() / "sweep" / "file", "");
  for (const char* name : {"old", "in_use", "file"}) make_old(root() / "sweep" / name);
  const Descriptor user(::open((root() / "sweep" / "in_use").c_str(), O_RDONLY | O_CLOEXEC));
  ASSERT_EQ(::flock(user.get(), LOCK_EX | LOCK_NB), 0);
  sweep(root() / "sweep");
  EXPECT_THAT(names(root() / "sweep"), ElementsAre("in_use", "young"));
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

}  // namespace
}  // namespace kanec::compile::test
