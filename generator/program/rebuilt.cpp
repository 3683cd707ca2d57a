// SPDX-License-Identifier: BSD-3-Clause
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

Ref same_again(Builder& builder, const Node& node, Ref a, Ref b) {
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
                    },
                    node);
}

Program rebuilt(const Program& program, const Remake& remake) {
  Builder builder;
  builder.nodes().reserve(program.nodes.size());
  std::vector<Ref> to;
  to.reserve(program.nodes.size());
  for (const Node& node : program.nodes) {
    const Operands from = operands(node);
    const Ref a = from.count > 0 ? to[static_cast<std::size_t>(from.at[0])] : Ref{};
    const Ref b = from.count > 1 ? to[static_cast<std::size_t>(from.at[1])] : Ref{};
    to.push_back(remake(builder, node, a, b));
  }
  Program result{program.names, std::move(builder.nodes()), program.functions};
  for (Function& function : result.functions) {
    move_all(to, function.outputs);
    for (Quantity& quantity : function.quantities) move_all(to, quantity.entries);
  }
  return result;
}

}  // namespace kanec::program
