// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

bool any_alive(const Quantity& quantity, const std::vector<bool>& alive) {
  return std::any_of(quantity.entries.begin(), quantity.entries.end(),
                     [&](Ref ref) { return alive[static_cast<std::size_t>(ref.node)]; });
}

void trim(Function& function, const std::vector<bool>& alive) {
  std::erase_if(function.quantities, [&](const Quantity& quantity) { return !any_alive(quantity, alive); });
  for (Quantity& quantity : function.quantities)
    for (std::size_t i = quantity.entries.size(); i-- > 0;)
      if (!alive[static_cast<std::size_t>(quantity.entries[i].node)]) {
        quantity.entries.erase(quantity.entries.begin() + static_cast<std::ptrdiff_t>(i));
        quantity.labels.erase(quantity.labels.begin() + static_cast<std::ptrdiff_t>(i));
      }
}

}  // namespace

Program drop_dead(Program program) {
  for (Function& function : program.functions) trim(function, reachable(program, function.outputs));
  const std::vector<bool> alive = reachable(program);
  // a dead node is not made again; only dead nodes refer to it
  std::size_t at = 0;
  rebuild(program, [&](Builder& builder, const Node& node, const Refs& now) {
    return alive[at++] ? same_again(builder, node, now) : Ref{};
  });
  return program;
}

Program alone(const Program& program, Function function) {
  const std::vector<bool> alive = reachable(program, function.outputs);
  trim(function, alive);
  Builder builder;
  std::vector<Ref> to(program.nodes.size());
  const auto now = [&to](Index index) { return to[static_cast<std::size_t>(index)]; };
  for (std::size_t i = 0; i < alive.size(); ++i) {
    if (!alive[i]) continue;
    const Operands from = operands(program.nodes[i]);
    to[i] = same_again(builder, program.nodes[i], {now(from.at[0]), now(from.at[1]), now(from.at[2])});
  }
  const auto move = [&now](Ref& ref) { ref.node = now(ref.node).node; };
  std::for_each(function.outputs.begin(), function.outputs.end(), move);
  for (Quantity& quantity : function.quantities) std::for_each(quantity.entries.begin(), quantity.entries.end(), move);
  Program result{{}, std::move(builder.nodes()), {}};
  result.functions.push_back(std::move(function));
  return result;
}

}  // namespace kanec::program
