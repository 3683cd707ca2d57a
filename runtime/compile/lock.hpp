// A lock between processes by flock(2), whose holder is known by its process. Not: what it protects.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <chrono>
#include <filesystem>
#include <functional>
#include <string>

#include "runtime/base/descriptor.hpp"

namespace kanec::compile {

// What becomes of the time in which a lock is waited for.
struct Waiting {
  std::string holder_does;                       // "which compiles the same model"
  std::function<void(const std::string&)> tell;  // after two seconds, and when it is given up; may be empty
  std::function<void()> poll;                    // all the while; what it throws ends it; may be empty
};

// A lock file, which holds the number of its process, and is removed at the end. Where the file system knows no locks,
// or none can be made, or its holder hangs, there is none: callers must stay correct without it, it only saves double
// work.
class Lock {
 public:
  Lock() = default;
  // Waits for the holder, at most so long, and for one that is stopped no more than five seconds. A holder that dies
  // leaves the lock.
  Lock(const std::filesystem::path& path, std::chrono::milliseconds patience, const Waiting& waiting = {});
  Lock(Lock&&) noexcept = default;
  Lock& operator=(Lock&&) = delete;
  ~Lock();
  bool held() const { return static_cast<bool>(file_); }

 private:
  std::filesystem::path path_;
  Descriptor file_;
};

}  // namespace kanec::compile
