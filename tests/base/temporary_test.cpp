// What dead processes leave goes, what others use or only looks alike stays. Oracles: processes that are killed.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/temporary.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <fstream>
#include <functional>
#include <string>

#include "runtime/base/files.hpp"
#include "tests/base/folder.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::names;
using testing::ElementsAre;
using testing::Not;
using testing::SizeIs;
using testing::StartsWith;

// A process that does its work and then lives until it is killed.
class Living {
 public:
  explicit Living(const std::function<void()>& work) {
    int ready[2];
    if (::pipe(ready) != 0) throw std::runtime_error("no pipe");
    process_ = ::fork();
    if (process_ == 0) {
      work();
      ::close(ready[1]);
      for (;;) ::pause();
    }
    ::close(ready[1]);
    char none = 0;
    while (::read(ready[0], &none, 1) < 0) {
    }
    ::close(ready[0]);
  }
  ~Living() { kill(); }
  Living(const Living&) = delete;
  Living& operator=(const Living&) = delete;
  void kill() {
    if (process_ <= 0) return;
    ::kill(process_, SIGKILL);
    ::waitpid(process_, nullptr, 0);
    process_ = 0;
  }

 private:
  pid_t process_ = 0;
};

class Temporary : public testing::Test {
 protected:
  // Begins a file and a folder, and ends neither.
  Living begun() const {
    return Living([this] {
      static AtomicFile file(path() / "a");
      file.write(std::string(100'000, 'x'));
      static TemporaryFolder folder(path() / "f");
      write_file(folder.path() / "inner", "x");
    });
  }
  fs::path path() const { return folder_.path(); }

 private:
  Folder folder_;
};

TEST_F(Temporary, of_a_killed_process_are_cleared_away_by_the_next_write_and_of_a_living_one_stay) {
  Living process = begun();
  write_file(path() / "b", "x");
  ASSERT_THAT(names(path()), ElementsAre(StartsWith("a.kanec-"), "b", StartsWith("f.kanec-")));
  process.kill();
  ASSERT_THAT(names(path()), SizeIs(3));
  write_file(path() / "c", "x");
  EXPECT_THAT(names(path()), ElementsAre("b", "c"));
}

TEST_F(Temporary, of_a_killed_process_are_cleared_away_by_the_next_folder) {
  begun().kill();
  const TemporaryFolder folder(path() / "f");
  EXPECT_THAT(names(path()), ElementsAre(folder.path().filename().string()));
}

TEST_F(Temporary, files_that_only_look_alike_stay) {
  const std::string real = temporary_name("a");
  const std::string changed = real.substr(0, real.size() - 1) + (real.back() == '0' ? '1' : '0');
  for (const std::string& name : {changed, "b" + real, real + "0", std::string("a.kanec-0123456789abcdef"),
                                  std::string("a.AbCdEf"), std::string(".kanec-"), std::string("kanec-")}) {
    EXPECT_FALSE(is_temporary_name(name)) << name;
    std::ofstream(path() / name) << "x";
  }
  EXPECT_TRUE(is_temporary_name(real));
  std::ofstream(path() / real) << "x";
  write_file(path() / "a", "x");
  EXPECT_THAT(names(path()), SizeIs(8));
  EXPECT_THAT(names(path()), Not(testing::Contains(real)));
}

TEST_F(Temporary, files_of_another_user_stay) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give files away";
  const std::string name = temporary_name("a");
  std::ofstream(path() / name) << "x";
  ASSERT_EQ(::chown((path() / name).c_str(), 54321, static_cast<gid_t>(-1)), 0);
  write_file(path() / "a", "x");
  EXPECT_THAT(names(path()), ElementsAre("a", name));
}

TEST_F(Temporary, names_are_as_long_as_a_file_system_takes) {
  const std::string longest(255, 'n');
  write_file(path() / longest, "x");
  EXPECT_EQ(read_file(path() / longest), "x");
  EXPECT_THAT(names(path()), ElementsAre(longest));
  EXPECT_THAT(temporary_name(longest), SizeIs(255));
  EXPECT_TRUE(is_temporary_name(temporary_name(longest)));
}

}  // namespace
}  // namespace kanec
