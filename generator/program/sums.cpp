// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/sums.hpp"

#include <array>

namespace kanec::program {
namespace {

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
  for (const Function& function : program.functions) {
    for (const Ref output : function.outputs) uses[at(output.node)] += 2;
    for (const Quantity& quantity : function.quantities)
      for (const Ref ref : quantity.entries) uses[at(ref.node)] += 2;
  }
  std::vector<bool> inner(program.nodes.size());
  for (std::size_t i = 0; i < inner.size(); ++i) inner[i] = is_sum(program.nodes[i]) && uses[i] == 1 && used_in_sum[i];
  return inner;
}

// Whether the second operand was written first.
bool is_reversed(const Operands& from, const std::vector<bool>& inner) {
  return inner[at(from.at[1])] && (!inner[at(from.at[0])] || from.at[1] < from.at[0]);
}

void flatten(const Program& program, const std::vector<bool>& inner, TermOrder order, Ref ref, Terms& terms) {
  const Operands from = operands(program.nodes[at(ref.node)]);
  const bool difference = std::holds_alternative<Subtract>(program.nodes[at(ref.node)]);
  const bool reversed = difference && order == TermOrder::as_written && is_reversed(from, inner);
  for (const int i : reversed ? std::array{1, 0} : std::array{0, 1}) {
    const Ref operand{from.at[i], ref.negative != (difference && i == 1)};
    if (inner[at(operand.node)])
      flatten(program, inner, order, operand, terms);
    else
      terms.push_back(operand);
  }
}

}  // namespace

Sums::Sums(const Program& program, TermOrder order) : inner(partial_sums(program)) {
  for (Index i = 0; i < static_cast<Index>(program.nodes.size()); ++i)
    if (is_sum(program.nodes[at(i)]) && !inner[at(i)]) flatten(program, inner, order, {i, false}, sums[i]);
}

void Sums::leave(const Program& program, Index sum) {
  sums.erase(sum);
  std::vector<Index> open = {sum};
  while (!open.empty()) {
    const Operands from = operands(program.nodes[at(open.back())]);
    open.pop_back();
    for (int i = 0; i < from.count; ++i) {
      if (!inner[at(from.at[i])]) continue;
      inner[at(from.at[i])] = false;
      open.push_back(from.at[i]);
    }
  }
}

}  // namespace kanec::program
