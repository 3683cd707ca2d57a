// Oracle: the file system itself, read through the standard library.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/files.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <cerrno>
#include <csignal>
#include <cstring>
#include <fstream>
#include <functional>
#include <iterator>
#include <string>

#include "runtime/base/error.hpp"
#include "runtime/base/temporary.hpp"
#include "tests/base/environment.hpp"
#include "tests/base/folder.hpp"
#include "tests/base/message_of.hpp"
#include "tests/base/small_disk.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::names;
using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

std::string contents(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

using kanec::test::message_of;

// Every byte value, over several blocks of any buffer.
std::string every_byte() {
  std::string text;
  for (int i = 0; i < 300000; ++i) text += static_cast<char>(i * 7 + i / 256);
  return text;
}

TEST(Files, file_is_read_as_it_was_written) {
  const Folder folder;
  const std::string text = every_byte();
  write_file(folder.path() / "a", text);
  EXPECT_TRUE(contents(folder.path() / "a") == text);
  EXPECT_TRUE(read_file(folder.path() / "a") == text);
  write_file(folder.path() / "empty", "");
  EXPECT_EQ(read_file(folder.path() / "empty"), "");
  EXPECT_THAT(names(folder.path()), ElementsAre("a", "empty"));
}

TEST(Files, reading_a_missing_file_names_it) {
  const Folder folder;
  const std::string path = (folder.path() / "none").string();
  EXPECT_EQ(message_of([&] { read_file(path); }), path + ": No such file or directory");
}

TEST(Files, reading_a_folder_is_an_error) {
  const Folder folder;
  EXPECT_EQ(message_of([&] { read_file(folder.path()); }), folder.path().string() + ": Is a directory");
}

TEST(Files, reading_more_than_what_is_allowed_is_an_error) {
  const Folder folder;
  write_file(folder.path() / "a", std::string((1 << 20) + 1, 'a'));
  EXPECT_EQ(read_file(folder.path() / "a", (1 << 20) + 1).size(), (1u << 20) + 1);
  EXPECT_EQ(message_of([&] { read_file(folder.path() / "a", 1 << 20); }),
            (folder.path() / "a").string() + ": found more than 1 MiB; allowed: at most so many");
}

TEST(Files, reading_what_has_no_end_is_an_error) {
  EXPECT_EQ(message_of([] { read_file("/dev/zero", any_size); }),
            "/dev/zero: found more than 64 MiB; allowed: at most so many");
}

TEST(Files, temporary_root_is_absolute) {
  const Folder folder;
  {
    const test::Variable variable("TMPDIR", folder.path().string());
    EXPECT_EQ(temporary_root(), folder.path());
  }
  const test::Variable relative("TMPDIR", ".");
  EXPECT_TRUE(temporary_root().is_absolute());
  const test::Variable missing("TMPDIR", (folder.path() / "none").string());
  EXPECT_EQ(temporary_root(), "/tmp");
}

TEST(Files, file_appears_only_by_commit) {
  const Folder folder;
  AtomicFile file(folder.path() / "a");
  file.write("one ");
  file.write("two");
  EXPECT_FALSE(fs::exists(folder.path() / "a"));
  file.commit();
  EXPECT_EQ(contents(folder.path() / "a"), "one two");
}

TEST(Files, old_file_stays_until_commit_and_without_it) {
  const Folder folder;
  write_file(folder.path() / "a", "old");
  {
    AtomicFile file(folder.path() / "a");
    file.write(every_byte());
    EXPECT_EQ(contents(folder.path() / "a"), "old");
  }
  EXPECT_EQ(contents(folder.path() / "a"), "old");
  EXPECT_THAT(names(folder.path()), ElementsAre("a"));
}

TEST(Files, new_file_has_the_rights_of_the_mask_and_an_old_one_keeps_its_own) {
  const Folder folder;
  const mode_t before = ::umask(027);
  write_file(folder.path() / "new", "x");
  ::umask(before);
  EXPECT_EQ(fs::status(folder.path() / "new").permissions(), fs::perms(0640));
  fs::permissions(folder.path() / "new", fs::perms(0754));
  write_file(folder.path() / "new", "y");
  EXPECT_EQ(fs::status(folder.path() / "new").permissions(), fs::perms(0754));
}

TEST(Files, writing_over_a_folder_is_refused) {
  const Folder folder;
  fs::create_directory(folder.path() / "sub");
  EXPECT_THAT(message_of([&] { write_file(folder.path() / "sub", "x"); }), HasSubstr("sub: Is a directory"));
  EXPECT_THAT(names(folder.path()), ElementsAre("sub"));
}

// Paths that nobody can write to, the superuser included.
TEST(Files, unwritable_folder_is_named) {
  const Folder folder;
  write_file(folder.path() / "file", "x");
  const fs::path below = folder.path() / "file" / "a";
  EXPECT_EQ(message_of([&] { write_file(below, "x"); }), below.string() + ": Not a directory");
  EXPECT_THAT(message_of([] { write_file("/proc/kanec", "x"); }), StartsWith("/proc/kanec: "));
  const fs::path missing = folder.path() / "none" / "a";
  EXPECT_EQ(message_of([&] { write_file(missing, "x"); }), missing.string() + ": No such file or directory");
  EXPECT_THAT(names(folder.path()), ElementsAre("file"));
}

TEST(Files, devices_are_written_directly) {
  EXPECT_NO_THROW(write_file("/dev/null", every_byte()));
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(Files, full_device_is_an_error) {
  EXPECT_EQ(message_of([] { write_file("/dev/full", "x"); }), "/dev/full: No space left on device");
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

// A file that may not grow, for any user: the write fails half-way as it does on a full disk.
class SizeLimit {
 public:
  explicit SizeLimit(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~SizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST(Files, write_that_fails_half_way_keeps_the_old_file) {
  const Folder folder;
  const fs::path path = folder.path() / "a";
  write_file(path, "old");
  const SizeLimit limit(100000);
  EXPECT_EQ(message_of([&] { write_file(path, every_byte()); }), path.string() + ": File too large");
  EXPECT_EQ(contents(path), "old");
  EXPECT_THAT(names(folder.path()), ElementsAre("a"));
}

TEST(Files, full_disk_keeps_the_old_file_and_leaves_nothing) {
  const Folder folder;
  const test::SmallDisk disk(folder.path(), "64k");
  if (disk.error() != 0) GTEST_SKIP() << "a small disk cannot be mounted here: " << std::strerror(disk.error());
  const fs::path path = folder.path() / "a";
  write_file(path, "old");
  EXPECT_EQ(message_of([&] { write_file(path, every_byte()); }), path.string() + ": No space left on device");
  EXPECT_EQ(contents(path), "old");
  EXPECT_THAT(names(folder.path()), ElementsAre("a"));
  EXPECT_NO_THROW(write_file(path, "new"));
  EXPECT_EQ(contents(path), "new");
}

}  // namespace
}  // namespace kanec
