// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "generator/program/elimination.hpp"
#include "generator/program/ledger.hpp"
#include "generator/program/passes.hpp"
#include "runtime/base/error.hpp"

namespace kanec::program {
namespace {

struct Candidate {
  std::vector<Node> nodes;
  std::vector<Ref> outputs;
};

Candidate by_columns(Builder builder, const Function& function, const std::vector<Column>& columns) {
  std::vector<Ref> outputs(function.outputs.size() * columns.size());
  for (std::size_t j = 0; j < columns.size(); ++j) {
    Tangents tangents(builder);
    for (const Direction& direction : columns[j]) tangents.seed(direction.variable, direction.amount);
    for (std::size_t i = 0; i < function.outputs.size(); ++i)
      outputs[i * columns.size() + j] = tangents.of(function.outputs[i]);
  }
  return {std::move(builder.nodes()), std::move(outputs)};
}

Candidate by_elimination(Builder builder, const Function& function, const std::vector<Column>& columns, Order order) {
  std::vector<Ref> outputs = jacobian_entries(builder, function.outputs, columns, order);
  return {std::move(builder.nodes()), std::move(outputs)};
}

// Operations when equal ones are made once.
int cost(const Candidate& candidate) {
  Function function;
  function.outputs = candidate.outputs;
  const Program shared = share({{}, candidate.nodes, {function}});
  const Ledger count = ledger(shared, shared.functions[0]);
  return count.operations() + count.square_roots + count.trigonometric + count.functions;
}

bool selects(const Node& node) {
  const auto* call = std::get_if<BinaryCall>(&node);
  const bool is_extremum = call != nullptr && (call->function == Binary::min || call->function == Binary::max);
  return is_extremum || std::holds_alternative<Select>(node);
}

bool selects(const Program& program, const Function& function) {
  const std::vector<bool> alive = reachable(program, function.outputs);
  for (std::size_t i = 0; i < alive.size(); ++i)
    if (alive[i] && selects(program.nodes[i])) return true;
  return false;
}

Candidate cheapest(const Program& program, const Function& function, const std::vector<Column>& columns) {
  constexpr std::size_t many = 200000;  // nodes, from which on trying takes seconds
  Builder builder;
  builder.nodes() = program.nodes;
  Candidate best = by_columns(builder, function, columns);
  if (selects(program, function) || best.nodes.size() > many) return best;
  int fewest = cost(best);
  for (const Order order : {Order::outputs_first, Order::fewest_products}) {
    Candidate other = by_elimination(builder, function, columns, order);
    const int count = cost(other);
    if (count >= fewest) continue;
    fewest = count;
    best = std::move(other);
  }
  return best;
}

}  // namespace

Function jacobian(Program& program, const Function& function, const std::vector<Column>& columns) {
  if (!function.placements.empty()) throw InternalError("jacobian: of a function with placements");
  Function result = function;
  Candidate best = cheapest(program, function, columns);
  program.nodes = std::move(best.nodes);
  result.outputs = std::move(best.outputs);
  result.n_out = static_cast<Index>(result.outputs.size());
  result.signature.columns = static_cast<Index>(columns.size());
  result.signature.results.clear();
  return result;
}

}  // namespace kanec::program
