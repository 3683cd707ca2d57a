// The rounding error of a program in single precision. Not: in double (ulp_errors.hpp, evaluation.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "generator/program/program.hpp"
#include "runtime/model/state_file.hpp"
#include "runtime/study/report/ulp_errors.hpp"

namespace kanec {

// The same numbers as float has them.
State in_float(State state);

// Of the program in float from the same in 50 digits, both at the state as float has it; infinite where float does not
// have it.
StateError error_in_float(const program::Program& program, const program::Function& function, const State& state);

}  // namespace kanec
