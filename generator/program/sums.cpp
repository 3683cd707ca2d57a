// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/sums.hpp"

namespace kanec::program {
namespace {

std::size_t at(Index index) { return static_cast<std::size_t>(index); }

bool is_sum(const Node& node) { return std::holds_alternative<Add>(node) || std::holds_alternative<Subtract>(node); }

std::vector<bool> partial_sums(const Program& program) {
  const std::vector<Stage> stage = stages(program);
  std::vector<int> uses(program.nodes.size(), 0);
  std::vector<bool> used_in_sum(program.nodes.size(), false);
  for (std::size_t user = 0; user < program.nodes.size(); ++user) {
    const Operands from = operands(program.nodes[user]);
    for (int i = 0; i < from.count; ++i) {
      const std::size_t operand = at(from.at[i]);
      ++uses[operand];
      if (is_sum(program.nodes[user]) && stage[user] == stage[operand]) used_in_sum[operand] = true;
    }
  }
  for (const Ref ref : all_outputs(program)) uses[at(ref.node)] += 2;
  for (const Function& function : program.functions)
    for (const Quantity& quantity : function.quantities)
      for (const Ref ref : quantity.entries) uses[at(ref.node)] += 2;
  std::vector<bool> inner(program.nodes.size());
  for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = is_sum(program.nodes[i]) && uses[i] == 1 && used_in_sum[i];
  return inner;
}

void flatten(const Program& program, const std::vector<bool>& inner, Ref ref, Terms& terms) {
  const Operands from = operands(program.nodes[at(ref.node)]);
  const bool difference = std::holds_alternative<Subtract>(program.nodes[at(ref.node)]);
  for (int i = 0; i < 2; ++i) {
    const Ref operand{from.at[i], ref.negative != (difference && i == 1)};
    if (inner[at(operand.node)])
      flatten(program, inner, operand, terms);
    else
      terms.push_back(operand);
  }
}

}  // namespace

Sums::Sums(const Program& program) : inner(partial_sums(program)) {
  for (Index i = 0; i < static_cast<Index>(program.nodes.size()); ++i)
    if (is_sum(program.nodes[at(i)]) && !inner[at(i)]) flatten(program, inner, {i, false}, sums[i]);
}

}  // namespace kanec::program
