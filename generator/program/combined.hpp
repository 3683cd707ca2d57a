// Several functions of a program as one, what they have in common computed once. Not: which are combined.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <vector>

#include "generator/program/program.hpp"

namespace kanec::program {

// "kinematics_and_accelerations": the outputs one after another, the quantities in order without repeats, one result a
// function. Where one part returns ẏ, those that would take it as an argument have it from there. Made before the
// passes that re-associate sums, which treat each function alone. Where results have the same name, the later bear
// their function's behind. Throws InternalError for a name that the program does not have.
Function combined(Program& program, const std::vector<std::string>& names);

// Takes more quantities into a list, each once and after those it follows there, from the beginning on or behind all
// that the list has; a label that something else bears gets the suffix behind.
enum class From { beginning, end };
void merge_quantities(std::vector<Quantity>& list, const std::vector<Quantity>& more, const std::string& suffix,
                      From from = From::beginning);

}  // namespace kanec::program
