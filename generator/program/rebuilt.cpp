// SPDX-License-Identifier: BSD-3-Clause
#include <utility>

#include "generator/program/overloaded.hpp"
#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

Ref moved(const std::vector<Ref>& to, Ref ref) {
  const Ref now = to[static_cast<std::size_t>(ref.node)];
  return ref.negative ? -now : now;
}

void move_all(const std::vector<Ref>& to, std::vector<Ref>& refs) {
  for (Ref& ref : refs) ref = moved(to, ref);
}

}  // namespace

Ref same_again(Builder& builder, const Node& node, const Refs& operands) {
  const Ref a = operands[0], b = operands[1], sign = operands[2];
  return std::visit(Overloaded{
                        [&](const Constant& op) { return builder.constant(op.value); },
                        [&](const Variable& op) { return builder.variable(op.group, op.index); },
                        [&](const Add&) { return builder.add(a, b); },
                        [&](const Subtract&) { return builder.subtract(a, b); },
                        [&](const Multiply&) { return builder.multiply(a, b); },
                        [&](const Divide&) { return builder.divide(a, b); },
                        [&](const SquareRoot&) { return builder.square_root(a); },
                        [&](const Sine&) { return builder.sine(a); },
                        [&](const Cosine&) { return builder.cosine(a); },
                        [&](const UnaryCall& op) { return builder.call(op.function, a); },
                        [&](const BinaryCall& op) { return builder.call(op.function, a, b); },
                        [&](const Select&) { return builder.select(sign, a, b); },
                    },
                    node);
}

namespace {

// The nodes of a program behind those of the builder, and where each is now.
std::vector<Ref> remade(Builder& builder, const Program& program, const Remake& remake) {
  builder.nodes().reserve(builder.nodes().size() + program.nodes.size());
  std::vector<Ref> to;
  to.reserve(program.nodes.size());
  for (const Node& node : program.nodes) {
    const Operands from = operands(node);
    Refs now;
    for (int i = 0; i < from.count; ++i) now[static_cast<std::size_t>(i)] = to[static_cast<std::size_t>(from.at[i])];
    to.push_back(remake(builder, node, now));
  }
  return to;
}

void move_all(const std::vector<Ref>& to, Function& function) {
  for (Quantity& quantity : function.quantities) move_all(to, quantity.entries);
  move_all(to, function.outputs);
}

}  // namespace

void rebuild(Program& program, const Remake& remake) {
  Builder builder;
  const std::vector<Ref> to = remade(builder, program, remake);
  program.nodes = std::move(builder.nodes());
  for (Function& function : program.functions) move_all(to, function);
}

Program joined(Program first, Program second) {
  const std::vector<Ref> to = appended(first, [&](Builder& builder) { return remade(builder, second, same_again); });
  for (Function& function : second.functions) {
    move_all(to, function);
    first.functions.push_back(std::move(function));
  }
  return first;
}

}  // namespace kanec::program
