// Several files that appear together or not at all. Oracle: the file system.
// SPDX-License-Identifier: BSD-3-Clause
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cstring>
#include <functional>
#include <string>

#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "tests/base/folder.hpp"
#include "tests/base/small_disk.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::names;
using testing::ElementsAre;

class FileSet : public testing::Test {
 protected:
  fs::path path(const std::string& name) const { return folder_.path() / name; }

  // Writes new files a, b, c in that order; what is thrown.
  std::string write_all(std::size_t bytes, const std::function<void()>& before_commit = {}) const {
    try {
      AtomicFile a(path("a")), b(path("b")), c(path("c"));
      const std::array<AtomicFile*, 3> files = {&a, &b, &c};
      for (AtomicFile* file : files) file->write(std::string(bytes, 'n'));
      if (before_commit) before_commit();
      commit_all(files);
    } catch (const FileError& error) {
      return error.what();
    }
    return "nothing was thrown";
  }
  std::string contents() const {
    std::string text;
    for (const char* name : {"a", "b", "c"})
      text += fs::is_regular_file(path(name)) ? read_file(path(name)).substr(0, 1) : "-";
    return text;
  }

  Folder folder_;
};

TEST_F(FileSet, appears_together) {
  write_file(path("b"), "old");
  write_all(10, [&] { EXPECT_EQ(contents(), "-o-"); });
  EXPECT_EQ(contents(), "nnn");
  EXPECT_THAT(names(folder_.path()), ElementsAre("a", "b", "c"));
}

TEST_F(FileSet, keeps_every_old_file_and_makes_no_new_one_where_one_cannot_be_put_in_place) {
  write_file(path("a"), "old");
  const std::string message = write_all(10, [&] { fs::create_directory(path("c")); });
  EXPECT_EQ(message, path("c").string() + ": Is a directory");
  EXPECT_EQ(contents(), "o--");
  EXPECT_THAT(names(folder_.path()), ElementsAre("a", "c"));
}

TEST_F(FileSet, keeps_every_old_file_where_one_in_the_middle_is_taken_by_a_folder) {
  for (const char* name : {"a", "c"}) write_file(path(name), "old");
  write_all(10, [&] { fs::create_directory(path("b")); });
  EXPECT_EQ(contents(), "o-o");
  EXPECT_THAT(names(folder_.path()), ElementsAre("a", "b", "c"));
}

TEST_F(FileSet, on_a_full_disk_is_as_it_was) {
  const test::SmallDisk disk(folder_.path(), "64k");
  if (disk.error() != 0) GTEST_SKIP() << "a small disk cannot be mounted here: " << std::strerror(disk.error());
  for (const char* name : {"a", "b"}) write_file(path(name), "old");
  EXPECT_EQ(write_all(24'000), path("c").string() + ": No space left on device");
  EXPECT_EQ(contents(), "oo-");
  EXPECT_THAT(names(folder_.path()), ElementsAre("a", "b"));
  EXPECT_EQ(write_all(8'000), "nothing was thrown");
  EXPECT_EQ(contents(), "nnn");
}

}  // namespace
}  // namespace kanec
