// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

std::size_t signed_at(Ref ref) { return 2 * static_cast<std::size_t>(ref.node) + (ref.negative ? 1 : 0); }

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
    program = checked(simplify(std::move(program)));
    program = checked(share(std::move(program)));
    program = checked(drop_dead(std::move(program)));
  }
  return program;
}

// Which of its different results stands at each place of a function's output. A matrix of millions of entries has few:
// of 512 free bodies on the inertial frame A has 9.4 million, and 8193 that differ.
using Places = std::vector<std::vector<Index>>;

// Each function's outputs once each.
Places taken_together(Program& program) {
  Places result;
  std::vector<Index> place(2 * program.nodes.size(), -1);  // by reference
  for (Function& function : program.functions) {
    std::vector<Ref> different;
    auto& places = result.emplace_back();
    places.reserve(function.outputs.size());
    for (const Ref output : function.outputs) {
      Index& known = place[signed_at(output)];
      if (known < 0) {
        known = static_cast<Index>(different.size());
        different.push_back(output);
      }
      places.push_back(known);
    }
    for (const Ref output : different) place[signed_at(output)] = -1;
    function.outputs = std::move(different);
  }
  return result;
}

void put_back(const Places& all, Program& program) {
  for (std::size_t i = 0; i < all.size(); ++i) {
    std::vector<Ref> outputs;
    outputs.reserve(all[i].size());
    for (const Index place : all[i]) outputs.push_back(program.functions[i].outputs[static_cast<std::size_t>(place)]);
    program.functions[i].outputs = std::move(outputs);
  }
}

}  // namespace

Program optimized(Program program) {
  const Places places = taken_together(program);
  program = settled(std::move(program));
  program = settled(checked(collect(std::move(program))));
  program = checked(share_sums(std::move(program)));
  program = checked(order_terms(settled(std::move(program))));
  put_back(places, program);
  return program;
}

}  // namespace kanec::program
