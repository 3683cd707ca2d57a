// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <utility>

#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

// Appends the nodes and functions of another program.
void append(Program& program, Program other) {
  const auto first = static_cast<Index>(program.nodes.size());
  const auto moved = [first](Ref ref) { return Ref{ref.node + first, ref.negative}; };
  Builder builder;
  builder.nodes() = std::move(program.nodes);
  for (const Node& node : other.nodes) {
    const Operands from = operands(node);
    same_again(builder, node, {moved({from.at[0], false}), moved({from.at[1], false}), moved({from.at[2], false})});
  }
  program.nodes = std::move(builder.nodes());
  for (Function& function : other.functions) {
    std::transform(function.outputs.begin(), function.outputs.end(), function.outputs.begin(), moved);
    for (Quantity& quantity : function.quantities)
      std::transform(quantity.entries.begin(), quantity.entries.end(), quantity.entries.begin(), moved);
    program.functions.push_back(std::move(function));
  }
}

}  // namespace

Program by_function(Program program, const std::function<Program(Program)>& pass) {
  Program result;
  for (Function& function : program.functions) append(result, pass(alone(program, std::move(function))));
  result.names = std::move(program.names);
  return share(std::move(result));
}

}  // namespace kanec::program
