// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
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

auto operations(const Program& program) {
  return std::count_if(program.nodes.begin(), program.nodes.end(), [](const Node& n) { return operands(n).count > 0; });
}

// Sharing lets more be simplified (x - x is seen once both are one node), and that more be shared.
Program settled(Program program) {
  auto before = operations(program) + 1;
  for (auto now = before - 1; now < before; now = operations(program)) {
    before = now;
    program = checked(simplify(program));
    program = checked(share(program));
    program = checked(drop_dead(program));
  }
  return program;
}

}  // namespace

Program optimized(Program program) {
  program = settled(std::move(program));
  program = settled(checked(collect(program)));
  program = checked(share_sums(program));
  return checked(order_terms(settled(std::move(program))));
}

}  // namespace kanec::program
