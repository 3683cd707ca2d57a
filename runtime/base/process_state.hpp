// What the system tells about another process, by its number. Not: starting or ending one (process.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <sys/types.h>

#include <optional>
#include <string>

namespace kanec {

struct ProcessState {
  std::string name;         // of its program, as far as the system keeps it (15 characters), printable
  std::string start;        // in ticks since the system started: with it the number stands for no other process
  bool is_stopped = false;  // by SIGSTOP, SIGTSTP or a debugger; its locks stay
};

// Empty where there is none, or where it is dead already and only waits to be asked for its status.
std::optional<ProcessState> state_of_process(pid_t number);

}  // namespace kanec
