// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/entry.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <optional>
#include <utility>

#include "runtime/base/files.hpp"
#include "runtime/base/hash.hpp"

namespace kanec::compile {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t largest_library = std::size_t{1} << 30;
constexpr std::size_t longest_seal = 64;

std::string seal(const std::string& library) {
  return std::to_string(library.size()) + " " + fingerprint(library) + "\n";
}

// Opens parts of one entry; the first doubt about one of them is kept.
class Look {
 public:
  explicit Look(const fs::path& entry) : path_(entry), folder_(open(AT_FDCWD, entry, O_DIRECTORY, S_IFDIR)) {}

  Descriptor open_part(const char* name) { return folder_ ? open(folder_.get(), name, 0, S_IFREG) : Descriptor(); }

  // The whole file, unless it is longer than that.
  std::optional<std::string> read(const Descriptor& file, std::size_t longest) const {
    struct stat status {};
    if (!file || ::fstat(file.get(), &status) != 0 || static_cast<std::size_t>(status.st_size) > longest)
      return std::nullopt;
    std::string text(static_cast<std::size_t>(status.st_size), '\0');
    for (std::size_t at = 0; at < text.size();) {
      const ssize_t n = ::pread(file.get(), text.data() + at, text.size() - at, static_cast<off_t>(at));
      if (n < 0 && errno == EINTR) continue;
      if (n <= 0) return std::nullopt;
      at += static_cast<std::size_t>(n);
    }
    return text;
  }

  std::optional<Finding> doubt() { return std::move(doubt_); }

 private:
  Descriptor open(int base, const fs::path& name, int flags, mode_t kind) {
    Descriptor file(::openat(base, name.c_str(), O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC | flags));
    struct stat status {};
    const int failed =
        file ? ::fstat(file.get(), &status) : ::fstatat(base, name.c_str(), &status, AT_SYMLINK_NOFOLLOW);
    if (failed != 0) return Descriptor();
    judge(kind == S_IFDIR ? path_ : path_ / name, status);
    return file && !doubt_ && (status.st_mode & S_IFMT) == kind ? std::move(file) : Descriptor();
  }

  // Links have no rights of their own.
  void judge(const fs::path& path, const struct stat& status) {
    if (doubt_) return;
    if (status.st_uid != ::geteuid())
      doubt_ = Finding{Finding::Kind::foreign, path, Descriptor(),
                       "belongs to another user (" + std::to_string(status.st_uid) + ")"};
    else if (!S_ISLNK(status.st_mode) && (status.st_mode & (S_IWGRP | S_IWOTH)) != 0)
      doubt_ = Finding{Finding::Kind::exposed, path, Descriptor(), "others may write to it"};
  }

  fs::path path_;
  std::optional<Finding> doubt_;
  Descriptor folder_;
};

}  // namespace

Finding look_at(const fs::path& entry, const std::string& key) {
  Look look(entry);
  const Descriptor key_file = look.open_part("key"), seal_file = look.open_part("seal");
  Descriptor library = look.open_part(library_name);
  if (auto doubt = look.doubt()) return std::move(*doubt);
  if (look.read(key_file, key.size()) != key) return {};
  const auto sealed = look.read(seal_file, longest_seal);
  const auto content = look.read(library, largest_library);
  if (!sealed || !content || *sealed != seal(*content)) return {};
  return {Finding::Kind::sound, entry / library_name, std::move(library)};
}

void complete(const fs::path& made, const std::string& key) {
  write_file(made / "key", key);
  write_file(made / "seal", seal(read_file(made / library_name, any_size)));
  for (const char* name : {"key", "seal", library_name}) {
    std::error_code ignored;  // an exposed entry is made anew each time
    fs::permissions(made / name, fs::perms::group_write | fs::perms::others_write, fs::perm_options::remove, ignored);
  }
}

}  // namespace kanec::compile
