// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/signs.hpp"

namespace kanec::program {
namespace {

bool is_difference(const Node& node) { return std::holds_alternative<Subtract>(node); }
bool is_product(const Node& node) {
  return std::holds_alternative<Multiply>(node) || std::holds_alternative<Divide>(node);
}

}  // namespace

Signs::Signs(const Program& program, const Function& function, const std::vector<Stage>& stages)
    : program_(program), stages_(stages), needed_(reachable(program, function.outputs)) {
  const std::size_t n = program.nodes.size();
  for (auto* list : {&fixed_, &flexible_, &deferred_, &flipped_}) list->assign(n, false);
  uses_.assign(n, 0);
  wanted_.assign(n, std::nullopt);
  first_use_.assign(n, std::nullopt);
  count_uses(function);
  fix_arguments();
  for (std::size_t i = 0; i < n; ++i)
    if (is_own(static_cast<Index>(i))) choose(static_cast<Index>(i));
}

bool Signs::is_own(Index node) const {
  return needed_[at(node)] && stages_[at(node)] == Stage::state && operands(program_.nodes[at(node)]).count > 0;
}

void Signs::count_uses(const Function& function) {
  for (const Ref output : function.outputs)
    if (!wanted_[at(output.node)]) wanted_[at(output.node)] = output.negative;
  for (const Quantity& quantity : function.quantities)
    for (const Ref entry : quantity.entries)
      if (!wanted_[at(entry.node)]) wanted_[at(entry.node)] = entry.negative;
  for (std::size_t user = 0; user < program_.nodes.size(); ++user) {
    if (!is_own(static_cast<Index>(user))) continue;
    const Operands from = operands(program_.nodes[user]);
    for (int i = 0; i < from.count; ++i) {
      ++uses_[at(from.at[i])];
      if (!first_use_[at(from.at[i])]) first_use_[at(from.at[i])] = i == 1 && is_difference(program_.nodes[user]);
    }
  }
}

// Functions of other arguments than sums and products take them as they are.
void Signs::fix_arguments() {
  for (std::size_t i = program_.nodes.size(); i-- > 0;) {
    const Node& node = program_.nodes[i];
    const bool carries =
        is_sum(node) || is_product(node) || std::holds_alternative<Sine>(node) || std::holds_alternative<Cosine>(node);
    if (!is_own(static_cast<Index>(i)) || (carries && !fixed_[i])) continue;
    fixed_[i] = true;
    const Operands from = operands(node);
    for (int j = 0; j < from.count; ++j) fixed_[at(from.at[j])] = true;
  }
}

// Whether the sign can be had either way, by constants.
bool Signs::is_flexible(Index node) const {
  const Node& op = program_.nodes[at(node)];
  const Operands from = operands(op);
  if (is_sum(op)) return yields(from.at[0]) && yields(from.at[1]);
  if (std::holds_alternative<Multiply>(op)) return yields(from.at[0]) || yields(from.at[1]);
  return std::holds_alternative<Divide>(op) && yields(from.at[0]);
}

// Sign of a sum's term within the sum as it stands in the program.
bool Signs::term(Index node, int i) const {
  const Operands from = operands(program_.nodes[at(node)]);
  return flipped(from.at[i]) != (i == 1 && is_difference(program_.nodes[at(node)]));
}

bool Signs::of_sum(Index node) const {
  const Operands from = operands(program_.nodes[at(node)]);
  const bool free_a = yields(from.at[0]), free_b = yields(from.at[1]);
  if (!free_a && !free_b && term(node, 0) == term(node, 1)) return term(node, 0);
  if (wanted_[at(node)]) return *wanted_[at(node)];
  if (free_a || free_b) return free_a ? term(node, 1) : term(node, 0);
  return from.at[0] < from.at[1] ? term(node, 0) : term(node, 1);  // the older one, whatever the order now
}

void Signs::choose(Index node) {
  const std::size_t i = at(node);
  const Node& op = program_.nodes[i];
  const Operands from = operands(op);
  if (fixed_[i]) return;
  if (is_flexible(node)) {
    if (uses_[i] == 1 && !wanted_[i]) {
      deferred_[i] = true;
      return;
    }
    flipped_[i] = wanted_[i] ? *wanted_[i] : first_use_[i].value_or(false);
  } else if (is_sum(op)) {
    flipped_[i] = of_sum(node);
  } else if (is_product(op)) {
    flipped_[i] = flipped(from.at[0]) != flipped(from.at[1]);
  } else if (std::holds_alternative<Sine>(op)) {
    hand_down(node);
    flipped_[i] = flipped(from.at[0]);
  }
  hand_down(node);
}

// Operands that yield take the sign that makes a sum's term positive, and a product's the one that it is to have.
void Signs::hand_down(Index node) {
  const Node& op = program_.nodes[at(node)];
  const Operands from = operands(op);
  bool is_given = is_product(op) && (is_literal(from.at[0]) || is_literal(from.at[1]));  // to a constant
  for (int i = 0; i < from.count; ++i) {
    const Index operand = from.at[i];
    if (!deferred_[at(operand)]) continue;
    bool sign = false;
    if (is_sum(op)) {
      sign = flipped(node) != (i == 1 && is_difference(op));
    } else if (is_product(op) && !is_given) {
      sign = flipped(node) != (deferred_[at(from.at[1 - i])] ? false : flipped(from.at[1 - i]));
      is_given = true;
    }
    flipped_[at(operand)] = sign;
    hand_down(operand);
  }
}

bool Signs::constant_flipped(Index node, int i) const {
  const Node& op = program_.nodes[at(node)];
  if (is_sum(op)) return flipped(node) != (i == 1 && is_difference(op));
  return is_product(op) && flipped(node) != flipped(operands(op).at[1 - i]);
}

bool Signs::negative(Index node, int i) const {
  const Node& op = program_.nodes[at(node)];
  const Index operand = operands(op).at[i];
  return is_sum(op) && flipped(node) != (is_literal(operand) ? constant_flipped(node, i) : flipped(operand));
}

}  // namespace kanec::program
