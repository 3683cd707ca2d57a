// All hard cases run, and told: what `kanec report --hard` does. Not: a single run (outcome.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/cli/model.hpp"

namespace kanec::cli::hard {

struct HardOptions {
  std::vector<std::string> folders;  // of a case, or of several; empty: models/hard
  bool brief = false;                // the length of the tests
  bool json = false, markdown = false;
  std::string output = "-";
  BuildArguments build = {};
};

// Returns the exit status: 1 where something was not kept. Throws InputError, SceneError, FileError, BuildError.
int report_hard_cases(const HardOptions& options);

}  // namespace kanec::cli::hard
