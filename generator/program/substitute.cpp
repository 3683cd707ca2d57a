// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/substitute.hpp"

#include <utility>

#include "generator/program/passes.hpp"

namespace kanec::program {
namespace {

class Substitution {
 public:
  Substitution(Program& program, Group argument, const std::vector<Ref>& results)
      : argument_(argument), results_(results) {
    builder_.nodes() = std::move(program.nodes);
    for (std::size_t i = 0; i < builder_.nodes().size(); ++i) now_.push_back({static_cast<Index>(i)});
  }

  // All nodes that the roots need, in order: operands first.
  void remake(const std::vector<bool>& needed) {
    for (std::size_t i = 0; i < needed.size(); ++i)
      if (needed[i]) now_[i] = remade(static_cast<Index>(i));
  }

  Ref of(Ref ref) const {
    const Ref now = now_[static_cast<std::size_t>(ref.node)];
    return ref.negative ? -now : now;
  }

  std::vector<Node> nodes() { return std::move(builder_.nodes()); }

 private:
  Ref remade(Index index) {
    const Node node = builder_.nodes()[static_cast<std::size_t>(index)];
    if (const auto* variable = std::get_if<Variable>(&node))
      return variable->group == argument_ ? results_[static_cast<std::size_t>(variable->index)] : Ref{index};
    const Operands from = operands(node);
    Refs refs{};
    bool is_same = true;
    for (int i = 0; i < from.count; ++i) {
      const auto at = static_cast<std::size_t>(i);
      refs[at] = now_[static_cast<std::size_t>(from.at[i])];
      is_same = is_same && refs[at] == Ref{from.at[i]};
    }
    return is_same ? Ref{index} : same_again(builder_, node, refs);
  }

  Group argument_;
  const std::vector<Ref>& results_;
  Builder builder_;
  std::vector<Ref> now_;  // by node of the function
};

}  // namespace

Function substituted(Program& program, const Function& function, Group argument, const std::vector<Ref>& results) {
  std::vector<Ref> roots = function.outputs;
  for (const Quantity& quantity : function.quantities)
    roots.insert(roots.end(), quantity.entries.begin(), quantity.entries.end());
  const std::vector<bool> needed = reachable(program, roots);
  Substitution substitution(program, argument, results);
  substitution.remake(needed);
  Function result = function;
  for (Ref& output : result.outputs) output = substitution.of(output);
  for (Quantity& quantity : result.quantities)
    for (Ref& entry : quantity.entries) entry = substitution.of(entry);
  program.nodes = substitution.nodes();
  return result;
}

}  // namespace kanec::program
