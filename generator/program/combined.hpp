// Several functions of a program as one, what they have in common computed once. Not: which are combined.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

// "kinematics_and_accelerations": the outputs one after another, the quantities in order without repeats, one result a
// function. Made before the passes that re-associate sums, which treat each function alone. Where results have the same
// name, the later bear their function's behind. Throws InternalError for a name that the program does not have.
Function combined(Program& program, const std::vector<std::string>& names);

}  // namespace kanec::program
