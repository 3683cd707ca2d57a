// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/program.hpp"

#include <algorithm>
#include <utility>

#include "runtime/base/error.hpp"

namespace kanec::program {
namespace {

template <class Op>
Operands operands_of(const Op& op) {
  if constexpr (requires { op.sign; })
    return {{op.a, op.b, op.sign}, 3};
  else if constexpr (requires { op.b; })
    return {{op.a, op.b, 0}, 2};
  else if constexpr (requires { op.a; })
    return {{op.a, 0, 0}, 1};
  else
    return {{0, 0, 0}, 0};
}

Stage own_stage(const Node& node) {
  const auto* variable = std::get_if<Variable>(&node);
  if (variable == nullptr) return Stage::constant;
  return variable->group == Group::parameter ? Stage::parameter : Stage::state;
}

std::vector<bool> with_operands(const Program& program, std::vector<bool> nodes) {
  for (std::size_t i = program.nodes.size(); i-- > 0;) {
    if (!nodes[i]) continue;
    const Operands from = operands(program.nodes[i]);
    for (int j = 0; j < from.count; ++j) nodes[at(from.at[j])] = true;
  }
  return nodes;
}

}  // namespace

Operands operands(const Node& node) {
  return std::visit([](const auto& op) { return operands_of(op); }, node);
}

bool is_sum(const Node& node) { return std::holds_alternative<Add>(node) || std::holds_alternative<Subtract>(node); }

const char* name(Unary function) {
  constexpr const char* names[] = {"tan", "asin", "acos", "exp", "log", "abs", "tanh"};
  return names[static_cast<std::size_t>(function)];
}

const char* name(Binary function) {
  constexpr const char* names[] = {"atan2", "min", "max", "pow"};
  return names[static_cast<std::size_t>(function)];
}

std::vector<Result> results(const Function& function) {
  const Signature& signature = function.signature;
  if (!signature.results.empty()) return signature.results;
  return {{function.name, signature.out, function.n_out, signature.layout, signature.columns}};
}

const Function& find(const Program& program, const std::string& name) {
  for (const Function& function : program.functions)
    if (function.name == name) return function;
  throw InternalError("no function " + name + " in the program");
}

std::vector<Stage> stages(const Program& program) {
  std::vector<Stage> result;
  result.reserve(program.nodes.size());
  for (const Node& node : program.nodes) {
    Stage stage = own_stage(node);
    const Operands from = operands(node);
    if (from.count > 0) stage = Stage::parameter;
    for (int i = 0; i < from.count; ++i) stage = std::max(stage, result[at(from.at[i])]);
    result.push_back(stage);
  }
  return result;
}

std::vector<bool> reachable(const Program& program, const std::vector<Ref>& roots) {
  std::vector<bool> result(program.nodes.size(), false);
  for (const Ref root : roots) result[at(root.node)] = true;
  return with_operands(program, std::move(result));
}

std::vector<bool> reachable(const Program& program) {
  std::vector<bool> result(program.nodes.size(), false);
  for (const Function& function : program.functions)
    for (const Ref output : function.outputs) result[at(output.node)] = true;
  return with_operands(program, std::move(result));
}

void check(const Program& program) {
  const auto size = static_cast<Index>(program.nodes.size());
  for (Index i = 0; i < size; ++i) {
    const Operands from = operands(program.nodes[at(i)]);
    for (int j = 0; j < from.count; ++j)
      if (from.at[j] < 0 || from.at[j] >= i) throw InternalError("program: an operand stands after its user");
  }
  const auto in_range = [size](Ref ref) { return ref.node >= 0 && ref.node < size; };
  for (const Function& function : program.functions) {
    if (!std::all_of(function.outputs.begin(), function.outputs.end(), in_range))
      throw InternalError("program: an output refers to no node");
    for (const Quantity& quantity : function.quantities)
      if (!std::all_of(quantity.entries.begin(), quantity.entries.end(), in_range))
        throw InternalError("program: a quantity refers to no node");
  }
}

}  // namespace kanec::program
