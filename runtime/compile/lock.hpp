// Locks between processes by flock(2), and folders that are known to be in use by such a lock. Not: what they protect.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>

#include "runtime/base/descriptor.hpp"

namespace kanec::compile {

// A lock file, removed at the end. Where the file system knows no locks, or none can be made, or its holder hangs,
// there is none: callers must stay correct without it, it only saves double work.
class Lock {
 public:
  Lock() = default;
  // Waits for the holder, at most so long.
  Lock(const std::filesystem::path& path, std::chrono::milliseconds patience);
  Lock(Lock&&) noexcept = default;
  Lock& operator=(Lock&&) = delete;
  ~Lock();
  bool held() const { return static_cast<bool>(file_); }

 private:
  std::filesystem::path path_;
  Descriptor file_;
};

// A new folder for this process alone, "<prefix>.XXXXXX", locked while it is used, removed at the end with all that it
// holds.
class TemporaryFolder {
 public:
  // Throws FileError.
  explicit TemporaryFolder(const std::filesystem::path& prefix);
  TemporaryFolder(TemporaryFolder&&) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&&) = delete;
  ~TemporaryFolder();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  Descriptor lock_;
};

// Removes from `folder` the lock files and temporary folders of processes that ended without doing so: over a minute
// old and locked by nobody (over a day old where the file system knows no locks).
void sweep(const std::filesystem::path& folder);

}  // namespace kanec::compile
