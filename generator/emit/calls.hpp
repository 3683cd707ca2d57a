// Which functions of the standard library emitted code calls: using-declarations and includes. Not: the calls.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/emit/language.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// "  using std::cos, std::sin;\n" for the marked nodes of this stage, so that a scalar's own functions are found as
// well; empty where none is called, and in C.
std::string usings(const program::Program& program, const std::vector<bool>& wanted,
                   const std::vector<program::Stage>& stages, program::Stage stage, const Syntax& syntax);

// The names of all functions that the program calls, in alphabetical order.
std::vector<std::string> functions_called(const program::Program& program);

// Of one stage.
std::vector<std::string> functions_called(const program::Program& program, const std::vector<program::Stage>& stages,
                                          program::Stage stage);

// "#include <cmath>\n" or "#include <math.h>\n" for these, where min and max are not all.
std::string includes(const program::Program& program, const Syntax& syntax);

// Whether anything in the program chooses between two values.
bool selects(const program::Program& program);

// The function select(condition, a, b); in C++ for scalars whose comparison gives a bool.
std::string selection(const Syntax& syntax);
// The functions min(a, b) and max(a, b), where they are called: the library's would be lost to macros of these names.
std::string comparisons(const program::Program& program, const Syntax& syntax);
bool compares(const program::Program& program);

}  // namespace kanec::emit
