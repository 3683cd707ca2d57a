// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/derivative.hpp"

#include "generator/program/fold.hpp"

namespace kanec::program {
namespace {

constexpr Ref unknown = {-1, false};

Ref signed_as(Ref ref, bool negative) { return negative ? -ref : ref; }

}  // namespace

bool Tangents::is_known(Index node) const {
  const auto at = static_cast<std::size_t>(node);
  return at < known_.size() && known_[at] != unknown;
}

void Tangents::remember(Index node, Ref derivative) {
  const auto at = static_cast<std::size_t>(node);
  if (at >= known_.size()) known_.resize(at + 1, unknown);
  known_[at] = derivative;
}

bool Tangents::is_zero(Ref derivative) const { return fold::is(builder_, derivative, 0); }

// Operands first, by a stack: chains of operations are too long for recursion.
Ref Tangents::of(Ref ref) {
  std::vector<Index> wanted = {ref.node};
  while (!wanted.empty()) {
    const Index node = wanted.back();
    const bool is_new = !is_known(node);
    const Operands from = operands(builder_.nodes()[static_cast<std::size_t>(node)]);
    for (int i = 0; i < from.count && is_new; ++i)
      if (!is_known(from.at[i])) wanted.push_back(from.at[i]);
    if (wanted.back() != node) continue;
    wanted.pop_back();
    if (is_new) remember(node, by_rule(node));
  }
  return signed_as(known(ref.node), ref.negative);
}

Ref Tangents::of_variable(const Variable& variable) const {
  for (const Seed& seed : seeds_)
    if (seed.variable.group == variable.group && seed.variable.index == variable.index) return seed.derivative;
  return zero_;
}

// The second argument is taken where it is smaller, or larger; elsewhere the first.
Ref Tangents::of_extremum(const BinaryCall& call) {
  if (is_zero(known(call.a)) && is_zero(known(call.b))) return zero_;
  const Ref difference = fold::sum(builder_, {call.a, false}, {call.b, true});
  const Ref sign = call.function == Binary::max ? difference : -difference;
  return fold::select(builder_, sign, known(call.b), known(call.a));
}

// Σ ∂node/∂operand · derivative of the operand; what is not selected is not multiplied by 0, for it may be infinite.
Ref Tangents::by_rule(Index node) {
  const Node op = builder_.nodes()[static_cast<std::size_t>(node)];
  if (const auto* variable = std::get_if<Variable>(&op)) return of_variable(*variable);
  if (const auto* choice = std::get_if<Select>(&op))
    return fold::select(builder_, {choice->sign, false}, known(choice->a), known(choice->b));
  if (const auto* call = std::get_if<BinaryCall>(&op))
    if (call->function == Binary::min || call->function == Binary::max) return of_extremum(*call);
  const Operands from = operands(op);
  Ref sum = zero_;
  for (int i = 0; i < from.count; ++i) {
    const Ref derivative = known(from.at[i]);
    if (is_zero(derivative)) continue;
    sum = fold::sum(builder_, sum, fold::product(builder_, partial(builder_, node, i), derivative));
  }
  return sum;
}

}  // namespace kanec::program
