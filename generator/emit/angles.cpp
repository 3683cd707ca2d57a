// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/angles.hpp"

#include <algorithm>
#include <set>

namespace kanec::emit {
namespace {

using program::Index;

std::string after(const std::string& array, Index entry) {
  return entry == 0 ? array : array + " + " + std::to_string(entry);
}

// The entry of x whose cosine or sine the node is; -1 where it is none.
Index turned(const program::Program& program, const program::Node& node) {
  if (!std::holds_alternative<program::Sine>(node) && !std::holds_alternative<program::Cosine>(node)) return -1;
  const auto of = static_cast<std::size_t>(operands(node).at[0]);
  const auto* variable = std::get_if<program::Variable>(&program.nodes[of]);
  return variable != nullptr && variable->group == program::Group::x ? variable->index : -1;
}

}  // namespace

Angles::Angles(const program::Program& program, const program::Function& function, Optimize optimize)
    : small_(optimize == Optimize::size) {
  const std::vector<bool> alive = reachable(program, function.outputs);
  std::set<Index> found;
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const Index entry = alive[i] ? turned(program, program.nodes[i]) : -1;
    if (entry >= 0) found.insert(entry);
  }
  if (found.size() > 1) entries_.assign(found.begin(), found.end());
}

bool Angles::has(Index entry) const { return std::binary_search(entries_.begin(), entries_.end(), entry); }

std::vector<bool> Angles::others(const program::Program& program, std::vector<bool> wanted) const {
  for (std::size_t i = 0; i < wanted.size(); ++i)
    if (wanted[i] && has(turned(program, program.nodes[i]))) wanted[i] = false;
  return wanted;
}

std::string Angles::declarations(const Syntax& syntax, const std::string& indent) const {
  if (empty()) return "";
  const std::string size = "[" + std::to_string(entries_.back() + 1) + "]";
  return indent + syntax.scalar() + " cosines" + size + ", sines" + size + ";  // of angles, at their places in x\n";
}

std::string Angles::calls(const Syntax& syntax, const std::string& owner) const {
  std::string text;
  for (std::size_t i = 0; i < entries_.size();) {
    std::size_t end = i + 1;
    while (end < entries_.size() && entries_[end] == entries_[end - 1] + 1) ++end;
    text += "  " + syntax.call("cos_sin") + "(" + after("x", entries_[i]) + ", " + std::to_string(end - i) + ", " +
            after(owner + "cosines", entries_[i]) + ", " + after(owner + "sines", entries_[i]) + ");\n";
    i = end;
  }
  return text.empty() || syntax.is_c() || small_ ? text : "  using kanec_cos_sin::cos_sin;\n" + text;
}

bool takes_turns(const Model& model, const program::Program& program) {
  return std::any_of(program.functions.begin(), program.functions.end(),
                     [&](const auto& function) { return !Angles(program, function, model.optimize).empty(); });
}

std::string small_cos_sin(const Model& model, const program::Program& program) {
  if (model.optimize != Optimize::size || !takes_turns(model, program)) return "";
  const Syntax syntax(model);
  const std::string real = syntax.scalar();
  return "// c = cos(a), s = sin(a) for n angles\n" +
         syntax.opening("void", "cos_sin", "const " + real + "* a, int n, " + real + "* c, " + real + "* s", {}) +
         (syntax.is_c() ? "" : "  using std::cos, std::sin;\n") +
         "  for (int i = 0; i < n; ++i) {\n    c[i] = " + syntax.call("cos") +
         "(a[i]);\n    s[i] = " + syntax.call("sin") + "(a[i]);\n  }\n}\n\n";
}

}  // namespace kanec::emit
