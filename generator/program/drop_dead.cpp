// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>

#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

bool any_alive(const Quantity& quantity, const std::vector<bool>& alive) {
  return std::any_of(quantity.entries.begin(), quantity.entries.end(),
                     [&](Ref ref) { return alive[static_cast<std::size_t>(ref.node)]; });
}

}  // namespace

Program drop_dead(const Program& program) {
  Program trimmed = program;
  std::vector<Ref> roots = all_outputs(program);
  for (Function& function : trimmed.functions) {
    const std::vector<bool> alive = reachable(program, function.outputs);
    std::erase_if(function.quantities, [&](const Quantity& quantity) { return !any_alive(quantity, alive); });
    for (Quantity& quantity : function.quantities)
      for (std::size_t i = quantity.entries.size(); i-- > 0;)
        if (!alive[static_cast<std::size_t>(quantity.entries[i].node)]) {
          quantity.entries.erase(quantity.entries.begin() + static_cast<std::ptrdiff_t>(i));
          quantity.labels.erase(quantity.labels.begin() + static_cast<std::ptrdiff_t>(i));
        }
  }
  const std::vector<bool> alive = reachable(program, roots);
  // a dead node is not made again; only dead nodes refer to it
  std::size_t at = 0;
  return rebuilt(trimmed, [&](Builder& builder, const Node& node, const Refs& now) {
    return alive[at++] ? same_again(builder, node, now) : Ref{};
  });
}

}  // namespace kanec::program
