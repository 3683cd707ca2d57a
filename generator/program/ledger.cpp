// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/ledger.hpp"

namespace kanec::program {
namespace {

void count(const Node& node, Ledger& ledger) {
  ledger.adds += is_sum(node);
  ledger.multiplies += std::holds_alternative<Multiply>(node);
  ledger.divides += std::holds_alternative<Divide>(node);
  ledger.square_roots += std::holds_alternative<SquareRoot>(node);
  ledger.trigonometric += std::holds_alternative<Sine>(node) || std::holds_alternative<Cosine>(node);
  ledger.functions += std::holds_alternative<UnaryCall>(node) || std::holds_alternative<BinaryCall>(node) ||
                      std::holds_alternative<Select>(node);
}

Ledger counted(const Program& program, const std::vector<Stage>& stage, const std::vector<bool>& alive, Stage wanted) {
  Ledger result;
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    if (alive[i] && stage[i] == wanted) count(program.nodes[i], result);
  return result;
}

}  // namespace

Ledger ledger(const Program& program, const Function& function) {
  return counted(program, stages(program), reachable(program, function.outputs), Stage::state);
}

std::vector<Ledger> ledgers(const Program& program) {
  const std::vector<Stage> stage = stages(program);
  std::vector<Ledger> result;
  for (const Function& function : program.functions)
    result.push_back(counted(program, stage, reachable(program, function.outputs), Stage::state));
  return result;
}

Ledger prepare_ledger(const Program& program) {
  return counted(program, stages(program), reachable(program), Stage::parameter);
}

long weighted_cost(const Ledger& ledger) {
  constexpr long divide = 8, square_root = 12, trigonometric = 44, function = 70;
  return ledger.adds + ledger.multiplies + divide * ledger.divides + square_root * ledger.square_roots +
         trigonometric * ledger.trigonometric + function * ledger.functions;
}

std::string text(const Ledger& ledger) {
  std::string result = std::to_string(ledger.adds) + " add, " + std::to_string(ledger.multiplies) + " multiply";
  const auto append = [&result](int n, const char* what) {
    if (n > 0) result += ", " + std::to_string(n) + " " + what;
  };
  append(ledger.divides, "divide");
  append(ledger.square_roots, "square root");
  append(ledger.trigonometric, "sine or cosine");
  append(ledger.functions, "other function");
  return result;
}

}  // namespace kanec::program
