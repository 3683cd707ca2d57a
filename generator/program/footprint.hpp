// What a function takes of memory, estimated by rule: what compilers make of it cannot be known here. Not: a
// measurement (kanec bench).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

#include "generator/program/rolled.hpp"

namespace kanec::program {

// Of one function in double on a machine with 16 registers of a vector unit. Measured: code within a quarter, stack
// within a factor of two (docs/compile_time.md).
struct Footprint {
  std::size_t code;   // [byte], tables of constants among it
  std::size_t stack;  // [byte]
};

// As a straight line: 9 bytes an operation, 8 on the stack for every result that is live at the busiest point.
Footprint straight_footprint(const Program& program, const Function& function);

// As loops: 9 bytes for every operation and store of the section bodies, 5 a load, tables as they are; on the stack the
// frames.
Footprint rolled_footprint(const Rolled& rolled);

}  // namespace kanec::program
