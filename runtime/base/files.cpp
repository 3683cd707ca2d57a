// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/files.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <utility>

#include "runtime/base/descriptor.hpp"
#include "runtime/base/error.hpp"

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

fs::path temporary_root() {
  std::error_code failed;
  const fs::path root = fs::temp_directory_path(failed);
  return failed ? "/tmp" : fs::absolute(root);
}

AtomicFile::AtomicFile(fs::path path) : path_(std::move(path)) {
  if (path_ == "-" || path_ == "/dev/stdout") {
    path_ = "standard output";
    descriptor_ = ::fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 0);
    if (descriptor_ < 0) fail(errno);
    return;
  }
  struct stat status {};
  const bool exists = ::stat(path_.c_str(), &status) == 0;
  if (exists && S_ISDIR(status.st_mode)) throw FileError(path_.string(), std::strerror(EISDIR));
  if (exists && !S_ISREG(status.st_mode)) {
    descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor_ < 0) throw FileError(path_.string(), std::strerror(errno));
    return;
  }
  std::string name = path_.string() + ".XXXXXX";
  descriptor_ = ::mkostemp(name.data(), O_CLOEXEC);
  if (descriptor_ < 0) throw FileError(path_.string(), std::strerror(errno));
  temporary_ = name;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  ::fchmod(descriptor_, exists ? status.st_mode : 0666 & ~mask);
}

AtomicFile::~AtomicFile() {
  if (descriptor_ >= 0) ::close(descriptor_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::write(std::string_view text) {
  buffer_ += text;
  if (buffer_.size() >= 1 << 16) flush();
}

void AtomicFile::flush() {
  std::string_view rest = buffer_;
  while (!rest.empty()) {
    const ssize_t n = ::write(descriptor_, rest.data(), rest.size());
    if (n < 0 && errno == EINTR) continue;
    if (n < 0) fail(errno);
    rest.remove_prefix(static_cast<std::size_t>(n));
  }
  buffer_.clear();
}

void AtomicFile::commit() {
  flush();
  const bool regular = !temporary_.empty();
  if (regular && ::fsync(descriptor_) != 0) fail(errno);
  if (::close(std::exchange(descriptor_, -1)) != 0) fail(errno);
  if (regular && ::rename(temporary_.c_str(), path_.c_str()) != 0) fail(errno);
  temporary_.clear();
}

void AtomicFile::fail(int error) { throw FileError(path_.string(), std::strerror(error)); }

void write_file(const fs::path& path, std::string_view text) {
  AtomicFile file(path);
  file.write(text);
  file.commit();
}

}  // namespace kanec
