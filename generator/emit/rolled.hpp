// One function of a program as loops over bodies: a function template for each kind of section, tables of what differs
// from body to body, and frames of the results that sections read of each other. Not: how sections are found alike
// (program/rolled.hpp), or the same function as a straight line (function.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

#include "generator/emit/function.hpp"
#include "generator/program/rolled.hpp"

namespace kanec::emit {

// Without the comment before the function.
std::string rolled_text(const Model& model, const program::Program& program, const program::Function& function,
                        const program::Rolled& rolled, const Named& named);

}  // namespace kanec::emit
