// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/files.hpp"

#include <fcntl.h>
#include <stdio.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <utility>

#include "runtime/base/error.hpp"
#include "runtime/base/links.hpp"
#include "runtime/base/temporary.hpp"

namespace kanec {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_size(const fs::path& path, std::size_t most) {
  throw FileError(path.string(), "found more than " + std::to_string(most >> 20) + " MiB; allowed: at most so many");
}

}  // namespace

std::string read_file(const fs::path& path, std::size_t most) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0) throw FileError(path.string(), std::strerror(errno));
  const bool is_regular = S_ISREG(status.st_mode);
  if (!is_regular) most = std::min(most, most_bytes);
  if (is_regular && static_cast<std::size_t>(status.st_size) > most) refuse_size(path, most);
  std::string text;
  char block[65536];
  for (;;) {
    const ssize_t n = ::read(file.get(), block, sizeof block);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) throw FileError(path.string(), std::strerror(errno));
    if (n == 0) return text;
    text.append(block, static_cast<std::size_t>(n));
    if (text.size() > most) refuse_size(path, most);
  }
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  if (path_ == "-" || path_ == "/dev/stdout") {
    path_ = "standard output";
    open_direct(Descriptor(::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0)));
    return;
  }
  place_ = follow_links(path_);
  if (const int number = own_descriptor(place_); number >= 0)
    open_direct(Descriptor(::fcntl(number, F_DUPFD_CLOEXEC, 0)));
  else
    open_place();
}

AtomicFile::~AtomicFile() {
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::open_direct(Descriptor descriptor) {
  if (!descriptor) fail(errno);
  file_ = std::move(descriptor);
}

void AtomicFile::open_place() {
  struct stat status {};
  const bool exists = ::stat(place_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) fail(EISDIR);
  std::error_code ignored;
  const bool is_descriptor = fs::is_symlink(place_, ignored);  // another process'
  if (exists && (!S_ISREG(status.st_mode) || is_descriptor)) {
    open_direct(Descriptor(::open(place_.c_str(), O_WRONLY | O_APPEND | O_CLOEXEC)));
    return;
  }
  TemporaryFile made = make_temporary_file(place_);
  temporary_ = std::move(made.path);
  file_ = std::move(made.file);
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(file_.get(), exists ? status.st_mode : 0666 & ~mask);
}

void AtomicFile::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= 1 << 16) put_out();
}

void AtomicFile::put_out() {
  std::size_t written = 0;
  while (written < buffer_.size()) {
    const ssize_t n = ::write(file_.get(), buffer_.data() + written, buffer_.size() - written);
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) {
      const int error = errno;
      buffer_.erase(0, written);  // for another attempt
      fail(error);
    }
    written += static_cast<std::size_t>(n);
  }
  buffer_.clear();
}

void AtomicFile::flush() {
  put_out();
  if (!temporary_.empty() && ::fsync(file_.get()) != 0) fail(errno);
}

void AtomicFile::commit() {
  AtomicFile* const alone = this;
  commit_all({&alone, 1});
}

// An exchange leaves the old file under the temporary name, from where it can come back.
void AtomicFile::place(bool can_be_taken_back) {
  if (temporary_.empty()) return;
  struct stat old {};
  const bool replaces = ::lstat(place_.c_str(), &old) == 0;
  if (can_be_taken_back && replaces && S_ISREG(old.st_mode) &&
      ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, place_.c_str(), RENAME_EXCHANGE) == 0) {
    stage_ = Stage::exchanged;
    return;
  }
  if (::rename(temporary_.c_str(), place_.c_str()) != 0) fail(errno);
  stage_ = replaces ? Stage::replaced : Stage::created;
}

void AtomicFile::take_back() {
  if (stage_ == Stage::exchanged) ::renameat2(AT_FDCWD, temporary_.c_str(), AT_FDCWD, place_.c_str(), RENAME_EXCHANGE);
  if (stage_ == Stage::created) ::unlink(place_.c_str());
  stage_ = Stage::open;
}

// The lock on the temporary name ends with the descriptor: last.
void AtomicFile::finish() {
  if (stage_ == Stage::exchanged) ::unlink(temporary_.c_str());
  temporary_.clear();
  file_.close();
}

void AtomicFile::fail(int error) const { throw FileError(path_.string(), std::strerror(error)); }

void commit_all(std::span<AtomicFile* const> files) {
  for (AtomicFile* file : files) file->flush();
  std::size_t placed = 0;
  try {
    for (; placed < files.size(); ++placed) files[placed]->place(placed + 1 < files.size());
  } catch (const FileError&) {
    while (placed > 0) files[--placed]->take_back();
    throw;
  }
  for (AtomicFile* file : files) file->finish();
}

void write_file(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

bool is_same_file(const fs::path& a, const fs::path& b) {
  if (a.empty() || b.empty()) return false;
  std::error_code unknown;  // where one is not there yet
  if (a == b || fs::equivalent(a, b, unknown)) return true;
  const fs::path first = fs::weakly_canonical(fs::absolute(follow_links(a)), unknown);
  return !unknown && first == fs::weakly_canonical(fs::absolute(follow_links(b)), unknown);
}

}  // namespace kanec
