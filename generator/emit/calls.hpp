// Which functions of the standard library emitted code calls: using-declarations and includes. Not: the calls.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::emit {

// "  using std::cos, std::sin;\n" for the marked nodes of this stage, so that a scalar's own functions are found as well;
// empty where none is called.
std::string usings(const program::Program& program, const std::vector<bool>& wanted,
                   const std::vector<program::Stage>& stages, program::Stage stage);

// The names of all functions that the program calls, in alphabetical order.
std::vector<std::string> functions_called(const program::Program& program);

// "#include <cmath>\n" and the like for these.
std::string includes(const program::Program& program);

// Whether anything in the program chooses between two values.
bool selects(const program::Program& program);

// The function template select(condition, a, b) for scalars whose comparison gives a bool.
std::string selection();

}  // namespace kanec::emit
