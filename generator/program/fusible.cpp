// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/fusible.hpp"

#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {}  // namespace

std::vector<bool> fusible_products(const Program& program, const std::vector<Stage>& stages) {
  const std::vector<bool> alive = reachable(program);
  std::vector<int> uses(program.nodes.size(), 0);
  for (const Function& function : program.functions)
    for (const Ref output : function.outputs) uses[at(output.node)] += 2;
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    if (!alive[i]) continue;
    const Operands from = operands(program.nodes[i]);
    for (int j = 0; j < from.count; ++j) uses[at(from.at[j])] += is_sum(program.nodes[i]) ? 1 : 2;
  }
  std::vector<bool> result(program.nodes.size());
  for (std::size_t i = 0; i < result.size(); ++i)
    result[i] = std::holds_alternative<Multiply>(program.nodes[i]) && stages[i] == Stage::state && uses[i] == 1;
  return result;
}

int multiply_adds(const Program& program, const Function& function) {
  const Program alone = program::alone(program, function);
  const std::vector<bool> alive = reachable(alone);
  const std::vector<bool> fusible = fusible_products(alone, stages(alone));
  int count = 0;
  for (std::size_t i = 0; i < alone.nodes.size(); ++i) {
    if (!alive[i] || !is_sum(alone.nodes[i])) continue;
    const Operands from = operands(alone.nodes[i]);
    count += fusible[at(from.at[0])] || fusible[at(from.at[1])];
  }
  return count;
}

}  // namespace kanec::program
