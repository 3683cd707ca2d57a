// Files written through links. Oracle: the file system itself, read through the standard library.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/links.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <functional>
#include <string>

#include "runtime/base/descriptor.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "tests/base/folder.hpp"
#include "tests/base/message_of.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;
using test::Folder;
using test::names;
using testing::ElementsAre;
using testing::HasSubstr;

using kanec::test::message_of;

class Links : public testing::Test {
 protected:
  fs::path at(const std::string& name) const { return folder_.path() / name; }
  void link(const std::string& name, const fs::path& to) const { fs::create_symlink(to, at(name)); }
  // Written to by the name of the link, which stays one.
  void expect_written(const std::string& name, const std::string& file) const {
    SCOPED_TRACE(name);
    write_file(at(name), "by " + name);
    EXPECT_TRUE(fs::is_symlink(at(name)));
    EXPECT_TRUE(fs::is_regular_file(fs::symlink_status(at(file))));
    EXPECT_EQ(read_file(at(file)), "by " + name);
  }

 private:
  Folder folder_;
};

TEST_F(Links, are_written_through_and_stay) {
  fs::create_directory(at("far"));
  write_file(at("far/file"), "old");
  fs::permissions(at("far/file"), fs::perms(0640));
  link("relative", "far/file");
  link("absolute", at("far/file"));
  link("chain", "far/next");
  link("far/next", "../relative");
  link("folder", "far");
  for (const char* name : {"relative", "absolute", "chain"}) expect_written(name, "far/file");
  write_file(at("folder/file"), "through the folder");
  EXPECT_EQ(read_file(at("far/file")), "through the folder");
  EXPECT_EQ(fs::status(at("far/file")).permissions(), fs::perms(0640));
  EXPECT_THAT(names(at("")), ElementsAre("absolute", "chain", "far", "folder", "relative"));
  EXPECT_THAT(names(at("far")), ElementsAre("file", "next"));
}

TEST_F(Links, to_nowhere_make_their_file) {
  fs::create_directory(at("far"));
  link("new", "far/file");
  link("lost", "none/file");
  expect_written("new", "far/file");
  EXPECT_EQ(message_of([&] { write_file(at("lost"), "x"); }), at("none/file").string() + ": No such file or directory");
  EXPECT_THAT(names(at("")), ElementsAre("far", "lost", "new"));
}

TEST_F(Links, that_go_round_are_refused) {
  link("a", "b");
  link("b", "a");
  link("self", "self");
  for (const char* name : {"a", "self"})
    EXPECT_EQ(message_of([&] { write_file(at(name), "x"); }),
              at(name).string() + ": Too many levels of symbolic links");
  EXPECT_THAT(names(at("")), ElementsAre("a", "b", "self"));
}

TEST_F(Links, to_folders_and_devices_are_as_these) {
  fs::create_directory(at("far"));
  link("folder", "far");
  link("device", "/dev/null");
  EXPECT_EQ(message_of([&] { write_file(at("folder"), "x"); }), at("folder").string() + ": Is a directory");
  EXPECT_NO_THROW(write_file(at("device"), "x"));
  EXPECT_TRUE(fs::is_symlink(at("device")));
}

TEST_F(Links, of_another_user_in_a_folder_where_all_may_write_are_not_followed) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give links away";
  write_file(at("file"), "old");
  fs::create_directory(at("shared"));
  fs::permissions(at("shared"), fs::perms(01777));
  link("shared/theirs", at("file"));
  link("shared/ours", at("file"));
  ASSERT_EQ(::lchown(at("shared/theirs").c_str(), 54321, static_cast<gid_t>(-1)), 0);
  EXPECT_THAT(message_of([&] { write_file(at("shared/theirs"), "x"); }), HasSubstr("a link of another user"));
  EXPECT_EQ(read_file(at("file")), "old");
  expect_written("shared/ours", "file");
}

TEST_F(Links, to_descriptors_are_written_where_these_stand) {
  const Descriptor file(::open(at("file").c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0600));
  ASSERT_EQ(::write(file.get(), "begin ", 6), 6);
  for (const std::string folder : {"/dev/fd/", "/proc/self/fd/"})
    write_file(folder + std::to_string(file.get()), "more ");
  ASSERT_EQ(::write(file.get(), "end", 3), 3);
  EXPECT_EQ(read_file(at("file")), "begin more more end");
  EXPECT_THAT(names(at("")), ElementsAre("file"));
  EXPECT_EQ(message_of([] { write_file("/dev/fd/999", "x"); }), "/dev/fd/999: Bad file descriptor");
}

TEST_F(Links, that_lead_to_one_file_are_told) {
  link("a", "file");
  link("b", at("file"));
  EXPECT_TRUE(is_same_file(at("a"), at("b")));  // there is no file yet
  EXPECT_TRUE(is_same_file(at("a"), at("file")));
  EXPECT_TRUE(is_same_file(at("./x"), at("x")));
  EXPECT_FALSE(is_same_file(at("a"), at("x")));
  EXPECT_FALSE(is_same_file("", ""));
  write_file(at("a"), "x");
  EXPECT_TRUE(is_same_file(at("a"), at("file")));
}

}  // namespace
}  // namespace kanec
