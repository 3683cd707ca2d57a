// Where the cache is, who may use it, and what happens without one. Oracle: the file system.
// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/cache.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cstring>

#include "runtime/base/error.hpp"
#include "tests/base/small_disk.hpp"
#include "tests/compile/bench.hpp"

namespace kanec::compile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

class CacheFolder : public Bench {
 protected:
  std::string refusal() const {
    try {
      build(toy(), options);
    } catch (const InputError& error) {
      return error.what();
    }
    return "nothing was thrown";
  }

  // A build that works, keeps nothing, says why, and leaves nothing in the system's temporary folder.
  void expect_built_for_this_run_alone(const std::string& reason) const {
    const fs::path temporary = root() / "temporary";
    fs::create_directory(temporary);
    const Variable variable("TMPDIR", temporary.string());
    {
      const Model model = build(toy(), options);
      EXPECT_EQ(evaluate(model), -12.0);
      EXPECT_THAT(model.notes(), ElementsAre("the compiled model is not kept: " + reason));
      EXPECT_THAT(names(temporary), SizeIs(1));
      EXPECT_THAT(model.library().string(), StartsWith(temporary.string()));
      EXPECT_TRUE(fs::exists(model.library()));
    }
    EXPECT_THAT(names(temporary), IsEmpty());
    EXPECT_FALSE(build(toy(), options).from_cache());
    EXPECT_EQ(runs(), 2);
  }
};

fs::perms rights(const fs::path& path) { return fs::status(path).permissions(); }

TEST(DefaultCache, first_variable_that_is_set_decides) {
  const Variable own("KANEC_CACHE", "/a/own"), xdg("XDG_CACHE_HOME", "/b"), home("HOME", "/c");
  EXPECT_EQ(default_cache(), "/a/own");
  const Variable no_own("KANEC_CACHE", "");
  EXPECT_EQ(default_cache(), "/b/kanec");
  const Variable relative_xdg("XDG_CACHE_HOME", "b");
  EXPECT_EQ(default_cache(), "/c/.cache/kanec");
  const Variable no_xdg("XDG_CACHE_HOME", std::nullopt);
  EXPECT_EQ(default_cache(), "/c/.cache/kanec");
  const Variable no_home("HOME", std::nullopt), temporary("TMPDIR", "/");
  EXPECT_EQ(default_cache(), "/kanec-" + std::to_string(::geteuid()));
  const Variable odd_temporary("TMPDIR", "/none");
  EXPECT_EQ(default_cache(), "/tmp/kanec-" + std::to_string(::geteuid()));
}

TEST(DefaultCache, own_variable_may_be_relative) {
  const Variable own("KANEC_CACHE", "models");
  EXPECT_EQ(default_cache(), fs::current_path() / "models");
}

TEST_F(CacheFolder, default_is_used_where_none_is_given) {
  const Variable own("KANEC_CACHE", cache().string());
  options.cache.clear();
  build(toy(), options);
  EXPECT_THAT(entries(), SizeIs(1));
}

TEST_F(CacheFolder, is_made_for_its_owner_alone_whatever_the_mask) {
  options.cache = cache() / "a" / "b";
  const mode_t before = ::umask(0);
  build(toy(), options);
  ::umask(before);
  for (const fs::path& path : {cache(), cache() / "a", cache() / "a" / "b", cache() / "a" / "b" / "tmp"})
    EXPECT_EQ(rights(path), fs::perms(0700)) << path;
  for (const std::string& entry : names(options.cache))
    EXPECT_EQ(rights(options.cache / entry), fs::perms(0700)) << entry;
}

TEST_F(CacheFolder, that_others_may_write_to_is_refused) {
  fs::create_directory(cache());
  for (const int mode : {0777, 0720, 0702, 01777}) {
    fs::permissions(cache(), fs::perms(mode));
    EXPECT_EQ(refusal(), cache().string() +
                             ": not used as the model cache, because others may write to it (chmod go-w); change that "
                             "or name another folder in KANEC_CACHE");
  }
  EXPECT_EQ(runs(), 0);
  fs::permissions(cache(), fs::perms(0755));
  EXPECT_EQ(evaluate(build(toy(), options)), -12.0);
}

TEST_F(CacheFolder, of_another_user_is_refused) {
  fs::create_directory(cache());
  if (::geteuid() == 0)
    ASSERT_EQ(::chown(cache().c_str(), some_other_user, static_cast<gid_t>(-1)), 0);
  else
    options.cache = "/usr";
  EXPECT_THAT(refusal(),
              AllOf(StartsWith(options.cache.string() + ": not used"), HasSubstr("it belongs to another user")));
  EXPECT_EQ(runs(), 0);
}

TEST_F(CacheFolder, behind_a_link_is_used_unless_the_link_is_of_another_user) {
  fs::create_directory(cache());
  fs::create_symlink(cache(), root() / "link");
  options.cache = root() / "link";
  EXPECT_EQ(evaluate(build(toy(), options)), -12.0);
  if (::lchown(options.cache.c_str(), some_other_user, static_cast<gid_t>(-1)) != 0)
    GTEST_SKIP() << "only root can give links away";
  EXPECT_THAT(refusal(), HasSubstr("it belongs to another user"));
}

// Paths where nobody can make a folder, the superuser included.
TEST_F(CacheFolder, below_a_file_is_done_without) {
  write_file(root() / "file", "");
  options.cache = root() / "file" / "cache";
  expect_built_for_this_run_alone(options.cache.string() + ": Not a directory");
}

TEST_F(CacheFolder, in_a_place_that_cannot_be_written_is_done_without) {
  options.cache = "/proc/kanec/cache";
  expect_built_for_this_run_alone("/proc/kanec: No such file or directory");
}

TEST_F(CacheFolder, that_is_a_file_is_done_without) {
  options.cache = root() / "file";
  write_file(options.cache, "");
  expect_built_for_this_run_alone(options.cache.string() + ": Not a directory");
}

TEST_F(CacheFolder, where_nothing_can_be_made_is_done_without) {
  fs::create_directory(cache());
  write_file(cache() / "tmp", "");
  expect_built_for_this_run_alone((cache() / "tmp").string() + ": Not a directory");
}

TEST_F(CacheFolder, on_a_full_disk_is_done_without) {
  fs::create_directory(cache());
  const kanec::test::SmallDisk disk(cache(), "4k");  // one page: not even the sources fit
  if (disk.error() != 0) GTEST_SKIP() << "a small disk cannot be mounted here: " << std::strerror(disk.error());
  const fs::path temporary = root() / "temporary";
  fs::create_directory(temporary);
  const Variable variable("TMPDIR", temporary.string());
  const Model model = build(toy(), options);
  EXPECT_EQ(evaluate(model), -12.0);
  EXPECT_THAT(model.notes(), ElementsAre(AllOf(StartsWith("the compiled model is not kept: " + cache().string()),
                                               HasSubstr(": No space left on device"))));
  EXPECT_THAT(entries(), IsEmpty());
}

TEST_F(CacheFolder, without_rights_is_done_without) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write everywhere";
  fs::create_directory(cache());
  fs::permissions(cache(), fs::perms(0500));
  expect_built_for_this_run_alone((cache() / "tmp").string() + ": Permission denied");
  fs::permissions(cache(), fs::perms(0700));
}

TEST_F(CacheFolder, is_left_alone_on_request) {
  options.use_cache = false;
  {
    const Model model = build(toy(), options);
    EXPECT_EQ(evaluate(model), -12.0);
    EXPECT_THAT(model.notes(), IsEmpty());
  }
  EXPECT_FALSE(build(toy(), options).from_cache());
  EXPECT_FALSE(fs::exists(cache()));
  EXPECT_EQ(runs(), 2);
}

}  // namespace
}  // namespace kanec::compile::test
