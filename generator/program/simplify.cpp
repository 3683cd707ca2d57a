// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/fold.hpp"
#include "generator/program/passes.hpp"

namespace kanec::program {

Program simplify(Program program) {
  rebuild(program, fold::again);
  return program;
}

}  // namespace kanec::program
