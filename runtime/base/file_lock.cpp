// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/base/file_lock.hpp"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <ctime>
#include <system_error>

namespace kanec {

namespace fs = std::filesystem;

LockAttempt try_lock(const Descriptor& file) {
  while (::flock(file.get(), LOCK_EX | LOCK_NB) != 0) {
    if (errno == EWOULDBLOCK) return LockAttempt::taken;
    if (errno != EINTR) return LockAttempt::impossible;
  }
  return LockAttempt::locked;
}

bool leads_to(const fs::path& path, const Descriptor& file) {
  struct stat here {};
  struct stat there {};
  return ::fstat(file.get(), &here) == 0 && ::lstat(path.c_str(), &there) == 0 && here.st_dev == there.st_dev &&
         here.st_ino == there.st_ino;
}

void remove_if_abandoned(const fs::path& path) {
  const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK));
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0 || status.st_uid != ::geteuid()) return;
  constexpr std::time_t day = 24 * 60 * 60;
  const LockAttempt attempt = try_lock(file);
  if (attempt == LockAttempt::taken) return;
  if (attempt == LockAttempt::impossible && std::time(nullptr) - status.st_mtim.tv_sec < day) return;
  std::error_code ignored;
  if (leads_to(path, file)) fs::remove_all(path, ignored);
}

}  // namespace kanec
