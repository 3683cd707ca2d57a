// Arguments of a function replaced by results. Not: passes (passes.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

// The function with result i in the place of entry i of that argument; what depends on it is appended to the program.
Function substituted(Program& program, const Function& function, Group argument, const std::vector<Ref>& results);

}  // namespace kanec::program
