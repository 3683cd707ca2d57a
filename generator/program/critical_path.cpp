// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/critical_path.hpp"

#include <algorithm>
#include <vector>

#include "generator/program/fusible.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

int latency(const Node& node) {
  if (std::holds_alternative<Divide>(node)) return 14;
  if (std::holds_alternative<SquareRoot>(node)) return 18;
  if (std::holds_alternative<Select>(node)) return 4;
  const Operands from = operands(node);
  return from.count == 2 && !std::holds_alternative<BinaryCall>(node) ? 4 : from.count > 0 ? 60 : 0;
}

}  // namespace

int critical_path(const Program& program, const Function& function) {
  const Program alone = program::alone(program, function);
  const std::vector<Stage> stage = stages(alone);
  const std::vector<bool> fusible = fusible_products(alone, stage);
  const std::vector<bool> alive = reachable(alone);
  std::vector<int> begun(alone.nodes.size(), 0), done(alone.nodes.size(), 0);
  int longest = 0;
  for (std::size_t i = 0; i < alone.nodes.size(); ++i) {
    if (!alive[i] || stage[i] != Stage::state) continue;
    const Operands from = operands(alone.nodes[i]);
    bool may_fuse = is_sum(alone.nodes[i]);
    for (int j = from.count - 1; j >= 0; --j) {
      const bool is_fused = may_fuse && fusible[at(from.at[j])];
      may_fuse = may_fuse && !is_fused;
      begun[i] = std::max(begun[i], is_fused ? begun[at(from.at[j])] : done[at(from.at[j])]);
    }
    done[i] = begun[i] + latency(alone.nodes[i]);
    longest = std::max(longest, done[i]);
  }
  return longest;
}

int instructions(const Program& program, const Function& function) {
  return ledger(program, function).operations() - multiply_adds(program, function);
}

}  // namespace kanec::program
