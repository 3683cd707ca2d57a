// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/fold.hpp"
#include "generator/program/passes.hpp"

namespace kanec::program {

Program simplify(const Program& program) { return rebuilt(program, fold::again); }

}  // namespace kanec::program
