// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/temporary.hpp"

#include <fcntl.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdint>
#include <cstring>
#include <system_error>
#include <utility>

#include "runtime/base/error.hpp"
#include "runtime/base/file_lock.hpp"
#include "runtime/base/hash.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view mark = ".kanec-";
constexpr std::size_t digits = 8;          // of chance, and as many that belong to them
constexpr std::size_t longest_name = 255;  // NAME_MAX

std::string signature(const std::string& name_and_chance) { return fingerprint(name_and_chance).substr(0, digits); }

std::string chance() {
  std::uint64_t number = 0;
  if (::getrandom(&number, sizeof number, 0) != sizeof number) number = static_cast<std::uint64_t>(::getpid());
  return fingerprint({reinterpret_cast<const char*>(&number), sizeof number}).substr(0, digits);
}

fs::path temporary_folder_of(const fs::path& path) {
  return path.has_parent_path() ? path.parent_path() : fs::path(".");
}

Descriptor new_file(const fs::path& path) {
  return Descriptor(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW, 0600));
}

Descriptor new_folder(const fs::path& path) {
  if (::mkdir(path.c_str(), 0700) != 0) return Descriptor();
  Descriptor folder(::open(path.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC | O_NOFOLLOW));
  if (folder) return folder;
  const int error = errno;
  ::rmdir(path.c_str());
  errno = error == ENOENT ? EEXIST : error;  // cleared away already: as if the name were taken
  return folder;
}

// Another process that clears away may take it for abandoned before it is locked: then there is another one.
TemporaryFile make_locked(const fs::path& path, Descriptor (*make)(const fs::path&)) {
  clear_abandoned(temporary_folder_of(path));
  for (int tries = 0; tries < 100; ++tries) {
    fs::path made = path;
    made.replace_filename(temporary_name(path.filename().string()));
    Descriptor file = make(made);
    if (!file && errno != EEXIST) throw FileError(path.string(), std::strerror(errno));
    if (!file) continue;
    const LockAttempt attempt = try_lock(file);
    if (attempt == LockAttempt::impossible || (attempt == LockAttempt::locked && leads_to(made, file)))
      return {std::move(made), std::move(file)};
    std::error_code ignored;
    fs::remove(made, ignored);
  }
  throw FileError(path.string(), "no temporary file can be made beside it");
}

}  // namespace

std::string temporary_name(const std::string& name) {
  const std::string begin = name.substr(0, longest_name - mark.size() - 2 * digits) + std::string(mark) + chance();
  return begin + signature(begin);
}

bool is_temporary_name(std::string_view name) {
  if (name.size() < mark.size() + 2 * digits) return false;
  const std::string begin(name.substr(0, name.size() - digits));
  return begin.substr(begin.size() - digits - mark.size(), mark.size()) == mark &&
         name.substr(name.size() - digits) == signature(begin);
}

void clear_abandoned(const fs::path& folder) {
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    if (is_temporary_name(entry->path().filename().string())) remove_if_abandoned(entry->path());
}

TemporaryFile make_temporary_file(const fs::path& path) { return make_locked(path, &new_file); }

TemporaryFolder::TemporaryFolder(const fs::path& path) {
  TemporaryFile made = make_locked(path, &new_folder);
  path_ = std::move(made.path);
  lock_ = std::move(made.file);
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::move(other.lock_)) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

fs::path temporary_root() {
  std::error_code failed;
  const fs::path root = fs::temp_directory_path(failed);
  return failed ? "/tmp" : fs::absolute(root);
}

}  // namespace kanec
