// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/lock.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <sys/file.h>
#include <sys/stat.h>

#include <cerrno>
#include <cstring>
#include <ctime>
#include <string>
#include <system_error>
#include <thread>
#include <utility>

#include "runtime/base/error.hpp"

namespace kanec::compile {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

enum class Attempt { locked, taken, impossible };

Attempt try_lock(const Descriptor& file) {
  while (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return Attempt::taken;
    if (errno != EINTR) return Attempt::impossible;
  }
  return Attempt::locked;
}

// Whether the path still leads to the open file; its last holder may have removed it meanwhile.
bool leads_to(const fs::path& path, const Descriptor& file) {
  struct stat here {};
  struct stat there {};
  return ::fstat(file.get(), &here) == 0 && ::lstat(path.c_str(), &there) == 0 && here.st_dev == there.st_dev &&
         here.st_ino == there.st_ino;
}

std::chrono::seconds age(const Descriptor& file) {
  struct stat status {};
  if (::fstat(file.get(), &status) != 0) return 0s;
  return std::chrono::seconds(std::time(nullptr) - status.st_mtim.tv_sec);
}

void remove_if_abandoned(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  if (!file || age(file) < 1min) return;
  const Attempt attempt = try_lock(file);
  if (attempt == Attempt::taken || (attempt == Attempt::impossible && age(file) < 24h)) return;
  std::error_code ignored;
  if (leads_to(path, file)) fs::remove_all(path, ignored);
}

}  // namespace

Lock::Lock(const fs::path& path, std::chrono::milliseconds patience) {
  const auto end = std::chrono::steady_clock::now() + patience;
  for (;;) {
    Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0600));
    if (!file) return;
    const Attempt attempt = try_lock(file);
    if (attempt == Attempt::impossible) return;
    if (attempt == Attempt::locked && leads_to(path, file)) {
      path_ = path;
      file_ = std::move(file);
      return;
    }
    if (attempt == Attempt::taken && std::chrono::steady_clock::now() >= end) return;
    if (attempt == Attempt::taken) std::this_thread::sleep_for(10ms);
  }
}

Lock::~Lock() {
  if (held()) ::unlink(path_.c_str());
}

TemporaryFolder::TemporaryFolder(const fs::path& prefix) {
  std::string name = prefix.string() + ".XXXXXX";
  if (::mkdtemp(name.data()) == nullptr) throw FileError(prefix.string(), std::strerror(errno));
  path_ = name;
  lock_ = Descriptor(::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (lock_) try_lock(lock_);
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})), lock_(std::move(other.lock_)) {}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  if (!path_.empty()) fs::remove_all(path_, ignored);
}

void sweep(const fs::path& folder) {
  std::error_code failed;
  for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end; entry.increment(failed))
    remove_if_abandoned(entry->path());
}

}  // namespace kanec::compile
