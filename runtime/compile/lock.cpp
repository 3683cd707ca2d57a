// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/compile/lock.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <optional>
#include <sstream>
#include <thread>
#include <utility>

#include "runtime/base/file_lock.hpp"
#include "runtime/base/process_state.hpp"

namespace kanec::compile {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr auto told_after = 2s;
constexpr auto patience_with_stopped = 5s;

// A regular file of our user's: what else may stand there is no lock.
Descriptor open_lock_file(const fs::path& path) {
  Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW | O_NONBLOCK, 0600));
  struct stat status {};
  if (!file || ::fstat(file.get(), &status) != 0) return Descriptor();
  return S_ISREG(status.st_mode) && status.st_uid == ::geteuid() ? std::move(file) : Descriptor();
}

// Our number and start; where they cannot be written, on a full disk, the lock holds all the same.
void write_holder(const Descriptor& file) {
  const auto self = state_of_process(::getpid());
  const std::string text = std::to_string(::getpid()) + " " + (self ? self->start : "") + "\n";
  if (::ftruncate(file.get(), 0) != 0 || ::pwrite(file.get(), text.data(), text.size(), 0) < 0) return;
}

struct Holder {
  std::string name = "another process";
  pid_t number = 0;  // 0: not known
  bool is_stopped = false;
};

// Of the process whose number stands there, unless that number is another one's by now.
Holder holder_of(const Descriptor& file) {
  char text[64] = {};
  if (::pread(file.get(), text, sizeof text - 1, 0) <= 0) return {};
  std::istringstream words(text);
  pid_t number = 0;
  std::string start;
  words >> number >> start;
  const auto process = state_of_process(number);
  if (!process || process->start != start) return {};
  return {"process " + std::to_string(number) + " (" + process->name + ")", number, process->is_stopped};
}

// One wait for a lock, from its first failed attempt.
class Wait {
 public:
  Wait(std::chrono::milliseconds patience, const Waiting& waiting) : patience_(patience), waiting_(waiting) {}

  // Sleeps a moment; false where it is to be given up.
  bool goes_on(const Descriptor& file) {
    if (waiting_.poll) waiting_.poll();
    const auto waited = Clock::now() - begin_;
    if (waited >= told_after && !is_told_) {
      tell("waiting for " + named(holder_of(file)));
      is_told_ = true;
    }
    if (waited >= patience_) {
      if (is_told_) tell(named(holder_of(file)) + ", is not waited for any longer");
      return false;
    }
    if (waited >= patience_with_stopped && gives_up_stopped(holder_of(file))) return false;
    std::this_thread::sleep_for(10ms);
    return true;
  }

 private:
  std::string named(const Holder& holder) const {
    return holder.name + (waiting_.holder_does.empty() ? "" : ", " + waiting_.holder_does);
  }
  void tell(const std::string& text) const {
    if (waiting_.tell) waiting_.tell(text);
  }
  bool gives_up_stopped(const Holder& holder) const {
    if (!holder.is_stopped) return false;
    tell(named(holder) + ", is stopped and not waited for any longer (kill -CONT " + std::to_string(holder.number) +
         " lets it go on)");
    return true;
  }

  std::chrono::milliseconds patience_;
  const Waiting& waiting_;
  Clock::time_point begin_ = Clock::now();
  bool is_told_ = false;
};

}  // namespace

Lock::Lock(const fs::path& path, std::chrono::milliseconds patience, const Waiting& waiting) {
  Wait wait(patience, waiting);
  for (;;) {
    Descriptor file = open_lock_file(path);
    if (!file) return;
    const LockAttempt attempt = try_lock(file);
    if (attempt == LockAttempt::impossible) return;
    if (attempt == LockAttempt::locked && leads_to(path, file)) {
      write_holder(file);
      path_ = path;
      file_ = std::move(file);
      return;
    }
    if (attempt == LockAttempt::taken && !wait.goes_on(file)) return;
  }
}

Lock::~Lock() {
  if (held()) ::unlink(path_.c_str());
}

}  // namespace kanec::compile
