// A cache in which others may have put something: not read, told, and no obstacle. Oracles: the counting compiler, the
// toy's closed form, the file system.
// SPDX-License-Identifier: BSD-3-Clause
#include <sys/stat.h>
#include <unistd.h>

#include <functional>

#include "runtime/base/error.hpp"
#include "runtime/compile/library.hpp"
#include "tests/compile/bench.hpp"

namespace kanec::compile::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;
using testing::StartsWith;

bool give_away(const fs::path& path) { return ::lchown(path.c_str(), some_other_user, static_cast<gid_t>(-1)) == 0; }

class Trust : public Bench {
 protected:
  // Made anew once, after which the cache is as it should be; the notes of the build that made it.
  std::vector<std::string> notes_of_rebuilding(const std::function<void(const fs::path& entry)>& plant) const {
    plant(make_entry());
    const int before = runs();
    const Model rebuilt = build(toy(), options);
    EXPECT_FALSE(rebuilt.from_cache());
    EXPECT_EQ(evaluate(rebuilt), -12.0);
    EXPECT_EQ(runs(), before + 1);
    EXPECT_TRUE(build(toy(), options).from_cache());
    EXPECT_THAT(build(toy(), options).notes(), IsEmpty());
    EXPECT_THAT(entries(), SizeIs(1));
    return rebuilt.notes();
  }
  fs::path entry() const { return cache() / entries().at(0); }
};

TEST_F(Trust, what_others_may_write_to_is_made_anew_with_a_note) {
  for (const std::string part : {"", "model.so", "key", "seal"})
    for (const int mode : {0720, 0702}) {
      SCOPED_TRACE(part);
      const auto open_up = [&](const fs::path& entry) { fs::permissions(entry / part, fs::perms(mode)); };
      const fs::path named = part.empty() ? make_entry() : make_entry() / part;
      EXPECT_THAT(notes_of_rebuilding(open_up),
                  ElementsAre(named.string() + ": not read, because others may write to it; compiled anew"));
    }
}

TEST_F(Trust, what_is_another_users_is_neither_read_nor_removed) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give files away";
  for (const std::string part : {"", "model.so", "key", "seal"}) {
    SCOPED_TRACE(part);
    make_entry();
    const fs::path theirs = part.empty() ? entry() : entry() / part;
    ASSERT_TRUE(give_away(theirs));
    const int before = runs();
    {
      const Model model = build(toy(), options);
      EXPECT_FALSE(model.from_cache());
      EXPECT_EQ(evaluate(model), -12.0);
      EXPECT_THAT(model.notes(), ElementsAre("the compiled model is not kept: " + theirs.string() +
                                             ": belongs to another user (54321), and is not read; remove it"));
    }
    EXPECT_EQ(runs(), before + 1);
    EXPECT_TRUE(fs::exists(theirs));
    fs::remove_all(entry());
  }
}

TEST_F(Trust, another_users_link_in_place_of_an_entry_is_not_followed) {
  const fs::path place = make_entry();
  fs::rename(place, root() / "elsewhere");
  fs::create_directory_symlink(root() / "elsewhere", place);
  if (!give_away(place)) GTEST_SKIP() << "only root can give links away";
  EXPECT_THAT(build(toy(), options).notes(), ElementsAre(HasSubstr("belongs to another user")));
  EXPECT_TRUE(fs::is_symlink(place));
}

// A link of our own to a sound entry or library: nothing that we made.
TEST_F(Trust, links_are_not_followed_but_replaced) {
  EXPECT_THAT(notes_of_rebuilding([&](const fs::path& entry) {
                fs::rename(entry, root() / "elsewhere");
                fs::create_directory_symlink(root() / "elsewhere", entry);
              }),
              IsEmpty());
  EXPECT_TRUE(fs::exists(root() / "elsewhere" / "model.so"));
  for (const char* part : {"model.so", "key", "seal"})
    EXPECT_THAT(notes_of_rebuilding([&](const fs::path& entry) {
                  fs::rename(entry / part, root() / part);
                  fs::create_symlink(root() / part, entry / part);
                }),
                IsEmpty());
}

TEST_F(Trust, pipes_and_folders_in_place_of_files_are_replaced_without_waiting) {
  for (const char* part : {"model.so", "key", "seal"}) {
    EXPECT_THAT(notes_of_rebuilding([&](const fs::path& entry) {
                  fs::remove(entry / part);
                  ASSERT_EQ(::mkfifo((entry / part).c_str(), 0600), 0);
                }),
                IsEmpty());
    EXPECT_THAT(notes_of_rebuilding([&](const fs::path& entry) {
                  fs::remove(entry / part);
                  fs::create_directory(entry / part);
                }),
                IsEmpty());
  }
  EXPECT_THAT(notes_of_rebuilding([&](const fs::path& entry) {
                fs::remove_all(entry);
                ASSERT_EQ(::mkfifo(entry.c_str(), 0600), 0);
              }),
              IsEmpty());
}

// Sparse: they take no place on the disk, and would take all memory.
TEST_F(Trust, giant_files_are_replaced_unread) {
  for (const char* part : {"model.so", "key", "seal"})
    EXPECT_THAT(
        notes_of_rebuilding([&](const fs::path& entry) { fs::resize_file(entry / part, std::uintmax_t{1} << 42); }),
        IsEmpty());
}

TEST_F(Trust, entries_are_writable_by_nobody_else_whatever_the_mask) {
  const mode_t before = ::umask(0);
  const fs::path made = make_entry();
  ::umask(before);
  for (const std::string part : {"", "model.so", "key", "seal"})
    EXPECT_EQ(fs::status(made / part).permissions() & (fs::perms::group_write | fs::perms::others_write),
              fs::perms::none);
  EXPECT_TRUE(build(toy(), options).from_cache());
}

TEST_F(Trust, library_that_was_replaced_since_it_was_looked_at_is_not_loaded) {
  const fs::path made = make_entry();
  const Finding found = look_at(made, read_file(made / "key"));
  ASSERT_EQ(found.kind, Finding::Kind::sound);
  EXPECT_NO_THROW(Library(found.path, toy(), found.library));
  fs::rename(made / "model.so", made / "old");
  fs::copy_file(made / "old", made / "model.so");
  EXPECT_THROW(Library(found.path, toy(), found.library), LoadError);
}

TEST_F(Trust, folder_for_what_is_not_finished_must_be_ours_too) {
  fs::create_directory(cache());
  fs::permissions(cache(), fs::perms(0700));
  const fs::path temporary = cache() / "tmp";
  const auto note = [&] { return build(toy(), options).notes(); };
  fs::create_directory(temporary);
  fs::permissions(temporary, fs::perms(0777));
  EXPECT_THAT(note(), ElementsAre(AllOf(HasSubstr(temporary.string()), HasSubstr("others may write to it"))));
  fs::permissions(temporary, fs::perms(0700));
  if (give_away(temporary)) {
    EXPECT_THAT(note(), ElementsAre(HasSubstr("it belongs to another user; remove it")));
  }
  fs::remove(temporary);
  fs::create_directory(root() / "elsewhere");
  fs::create_directory_symlink(root() / "elsewhere", temporary);
  EXPECT_THAT(note(), ElementsAre(EndsWith("a link, where a folder belongs; remove it")));
  EXPECT_THAT(names(root() / "elsewhere"), IsEmpty());
  fs::remove(temporary);
}

class Above : public Bench {
 protected:
  Above() { options.cache = root() / "above" / "cache"; }
  std::vector<std::string> notes() const { return build(toy(), options).notes(); }
  fs::path above() const { return root() / "above"; }
};

TEST_F(Above, folders_that_others_may_write_to_could_replace_the_cache) {
  fs::create_directory(above());
  fs::permissions(above(), fs::perms(0777));
  EXPECT_THAT(notes(), ElementsAre(AllOf(StartsWith("the compiled model is not kept: " + above().string()),
                                         HasSubstr("may be written to by others (chmod go-w)"))));
  EXPECT_FALSE(fs::exists(options.cache));
  fs::permissions(above(), fs::perms(01777));  // as /tmp
  EXPECT_THAT(notes(), IsEmpty());
  fs::permissions(above(), fs::perms(0755));
  EXPECT_THAT(notes(), IsEmpty());
}

TEST_F(Above, folder_with_a_link_to_the_cache_counts_too) {
  fs::create_directories(above());
  fs::create_directory(root() / "real");
  fs::create_directory_symlink(root() / "real", options.cache);
  EXPECT_THAT(notes(), IsEmpty());
  fs::permissions(above(), fs::perms(0777));
  EXPECT_THAT(notes(), ElementsAre(HasSubstr(above().string())));
}

TEST_F(Above, folders_of_another_user_are_not_trusted_and_those_of_the_users_own_group_are) {
  if (::geteuid() != 0) GTEST_SKIP() << "only root can give folders away";
  fs::create_directory(above());
  fs::permissions(above(), fs::perms(0775));
  ASSERT_EQ(::chown(above().c_str(), 0, 54321), 0);
  EXPECT_THAT(notes(), ElementsAre(HasSubstr("may be written to by others")));
  ASSERT_EQ(::chown(above().c_str(), 0, 0), 0);
  EXPECT_THAT(notes(), IsEmpty());
  ASSERT_TRUE(give_away(above()));
  EXPECT_THAT(notes(), ElementsAre(HasSubstr("belongs to another user (54321)")));
}

}  // namespace
}  // namespace kanec::compile::test
