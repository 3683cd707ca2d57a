// One command of the tool in a process of its own, with what it left on its outputs. Not: which commands are tried.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace kanec::test {

struct Outcome {
  std::string command;  // as it is typed
  int status = 0;       // exit status, or 128 and the number of the signal that ended it
  std::string output;   // both streams
};

// Runs `kanec <arguments>` within the folder; killed after `seconds`.
Outcome run(const std::filesystem::path& folder, const std::vector<std::string>& arguments, unsigned seconds);

}  // namespace kanec::test
