// How long a function takes on a processor that can do any number of things at once. Not: time; most take as long as
// their instructions need places (docs/profile.md).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "generator/program/program.hpp"

namespace kanec::program {

// The longest chain of operations of one call in cycles: 4 an addition, multiplication, both fused or a choice, 14 a
// division, 18 a square root, 60 another function; what depends on parameters only is there from the beginning.
int critical_path(const Program& program, const Function& function);

// Instructions of arithmetic of one call, functions not among them: operations less multiply-adds.
int instructions(const Program& program, const Function& function);

}  // namespace kanec::program
