// Ctrl-C and SIGTERM as an exception, so that what is half done is cleared away. Not: any other signal.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <signal.h>

#include <exception>
#include <string>

namespace kanec {

class Interrupted : public std::exception {
 public:
  // `more`: what is said behind "interrupted", of what is left of the work.
  explicit Interrupted(const std::string& more = "") : message_("interrupted" + more) {}
  const char* what() const noexcept override { return message_.c_str(); }

 private:
  std::string message_;
};

// While one of these lives the signals are only noted, and poll() throws Interrupted after one came. A signal that our
// caller ignores stays ignored.
class Interrupts {
 public:
  Interrupts();
  ~Interrupts();
  Interrupts(const Interrupts&) = delete;
  Interrupts& operator=(const Interrupts&) = delete;
  void poll() const;

 private:
  struct sigaction interrupt_before_ {};
  struct sigaction terminate_before_ {};
};

}  // namespace kanec
