// All hard cases run, and told: what `kanec report --hard` does. Not: a single run (outcome.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/model/model.hpp"

namespace kanec::hard {

struct HardOptions {
  std::vector<std::string> folders;  // of a case, or of several; empty: models/hard
  bool brief = false;                // the length of the tests
  bool json = false, markdown = false;
  std::string output = "-";
  BuildOptions build = {};
};

// False where something was not kept. Throws InputError, SceneError, FileError, BuildError.
bool report_hard_cases(const HardOptions& options);

}  // namespace kanec::hard
