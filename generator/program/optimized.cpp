// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

Program checked(Program program) {
#ifndef NDEBUG
  check(program);
#endif
  return program;
}

}  // namespace

Program optimized(Program program) {
  program = checked(simplify(program));
  program = checked(share(program));
  program = checked(simplify(program));  // x - x is seen once both are one node
  program = checked(drop_dead(program));
  program = checked(share_sums(program));
  program = checked(share(program));
  return checked(drop_dead(program));
}

}  // namespace kanec::program
