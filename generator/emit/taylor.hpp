// The Taylor series of a model's motion as a C++ class template: one recursion a result of the very program that gives
// its rates. Not: steps by these series (runtime/integrate/taylor.cpp), nor which recursion a result has
// (program/series.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/emit/model.hpp"
#include "generator/program/program.hpp"

namespace kanec::emit {

// The function of the program that gives all rates of a state at once: kinematics_and_accelerations, with power where
// there is one; null where there is none.
const program::Function* rates(const program::Program& program);

// "<model>_taylor.hpp", to stand beside the header; empty where the program has no such function.
std::string emit_taylor(const Model& model, const program::Program& program);

}  // namespace kanec::emit
