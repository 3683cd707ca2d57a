// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/prepare.hpp"

#include <algorithm>
#include <set>

#include "generator/emit/calls.hpp"
#include "generator/program/ledger.hpp"
#include "generator/scene/spelling.hpp"

namespace kanec::emit {
namespace {

using program::at;
using program::Index;
using program::Ref;
using program::Stage;

// Operations on parameters that results of the state, or outputs, use directly.
std::vector<Ref> fields(const program::Program& program, const std::vector<Stage>& stages) {
  std::vector<bool> is_field(program.nodes.size(), false);
  const auto mark = [&](Index i) {
    if (stages[at(i)] == Stage::parameter && operands(program.nodes[at(i)]).count > 0) is_field[at(i)] = true;
  };
  for (std::size_t i = 0; i < program.nodes.size(); ++i) {
    const program::Operands from = operands(program.nodes[i]);
    for (int j = 0; j < from.count && stages[i] == Stage::state; ++j) mark(from.at[j]);
  }
  for (const program::Function& function : program.functions)
    for (const Ref output : function.outputs) mark(output.node);
  std::vector<Ref> result;
  for (std::size_t i = 0; i < is_field.size(); ++i)
    if (is_field[i]) result.push_back({static_cast<Index>(i), false});
  return result;
}

// Labels of quantities that are fields; a label that two nodes bear goes to the first.
std::unordered_map<Index, std::string> labels(const program::Program& program) {
  std::unordered_map<Index, std::string> result;
  std::set<std::string> taken;
  for (const program::Function& function : program.functions)
    for (const program::Quantity& quantity : function.quantities)
      for (std::size_t i = 0; i < quantity.entries.size(); ++i) {
        const Ref entry = quantity.entries[i];
        if (entry.negative || result.count(entry.node) > 0) continue;
        if (taken.insert(quantity.labels[i]).second) result[entry.node] = quantity.labels[i];
      }
  return result;
}

// The body in whose section each node is first used, 0 for the whole system and for what outputs use directly. Fields
// without a label are numbered by it, so that a change to one body renames no other's.
class Owners {
 public:
  explicit Owners(const program::Program& program) : program_(program), owner_(program.nodes.size(), -1) {
    for (const program::Function& function : program.functions) {
      for (const program::Quantity& quantity : function.quantities)
        for (const Ref entry : quantity.entries) claim(entry.node, quantity.body);
      for (const Ref output : function.outputs) claim(output.node, 0);
    }
  }

  int of(Index node) const { return owner_[at(node)]; }

 private:
  void claim(Index node, int body) {
    if (owner_[at(node)] >= 0) return;
    owner_[at(node)] = body;
    const program::Operands from = operands(program_.nodes[at(node)]);
    for (int i = 0; i < from.count; ++i) claim(from.at[i], body);
  }

  const program::Program& program_;
  std::vector<int> owner_;
};

// In C, which has no empty structs and no defaults of members, a function gives these: default_parameters().
std::string named_struct(const std::string& what, const std::string& name, const std::string& defaults,
                         const std::vector<scene::Named>& list, const Syntax& syntax) {
  std::string text = "// " + what + "\n" + syntax.open_struct(name);
  std::string values;
  for (const scene::Named& named : list) {
    const std::string field = scene::spelled(named.name), value = " = " + syntax.number(literal(named.value)) + ";\n";
    text += "  " + syntax.scalar() + " " + field + (syntax.is_c() ? ";\n" : value);
    values += "  list." + field + value;
  }
  if (!syntax.is_c()) return text + syntax.close_struct(name) + "\n";
  if (list.empty()) text += "  char none;\n", values = "  list.none = 0;\n";
  return text + syntax.close_struct(name) + "static inline " + syntax.type(name) + " " + syntax.global(defaults) +
         "(void) {\n  " + syntax.type(name) + " list;\n" + values + "  return list;\n}\n\n";
}

// Whether prepare() calls nothing that is no constant expression; nor are any in C.
bool is_constant(const program::Program& program, const std::vector<Stage>& stages) {
  const std::vector<std::string> called = functions_called(program, stages, Stage::parameter);
  return std::all_of(called.begin(), called.end(),
                     [](const std::string& function) { return function == "min" || function == "max"; });
}

}  // namespace

Preparation emit_prepare(const Used& used, const program::Program& program, const std::vector<Stage>& stages,
                         const Syntax& syntax) {
  Preparation result;
  result.named.has_inputs = !used.inputs.empty();
  result.text = named_struct("Run-time parameters with the scene's defaults, SI units.", "Parameters",
                             "default_parameters", used.parameters, syntax);
  if (result.named.has_inputs)
    result.text += named_struct("Run-time inputs with the scene's defaults, SI units.", "Inputs", "default_inputs",
                                used.inputs, syntax);
  const std::vector<Ref> wanted = fields(program, stages);
  const auto known = labels(program);
  Scope scope;  // of prepare()
  Scope fields;
  for (const std::string& name : {std::string("T"), std::string("p"), std::string("c"), syntax.scalar()})
    scope.reserve(name), fields.reserve(name);
  for (const std::string& name : functions_called(program)) scope.reserve(name);
  Statements statements(program, stages, Stage::parameter, wanted, scope, syntax);
  std::string members;
  std::string stores;
  const Owners owners(program);
  std::unordered_map<int, int> unnamed;  // by body
  for (const Ref field : wanted) {
    const auto label = known.find(field.node);
    const int body = owners.of(field.node);
    const std::string name = fields.unique(
        label != known.end() ? label->second : "c" + std::to_string(body) + "_" + std::to_string(++unnamed[body]));
    statements.define(name, field);
    members += "  " + syntax.scalar() + " " + name + ";\n";
    stores += "  c." + name + " = " + statements.value(field) + ";\n";
    result.named.prepared[field.node] = {syntax.member("c", name), false};
  }
  const std::string type = syntax.type("Prepared"), parameters = syntax.type("Parameters");
  result.text += "// What depends on parameters only, computed once for many calls.\n" +
                 syntax.open_struct("Prepared") + "  " + parameters + " p;\n" + members +
                 syntax.close_struct("Prepared") + "\n";
  const bool constant = !syntax.is_c() && is_constant(program, stages);
  result.text += "// prepare: " + program::text(program::prepare_ledger(program)) + "\n" +
                 syntax.opening((constant ? "constexpr " : "") + type, "prepare",
                                syntax.maybe_unused(syntax.given(parameters, "p")), {}) +
                 usings(program, reachable(program, wanted), stages, Stage::parameter, syntax) +
                 (syntax.is_c() ? "  " + type + " c;\n  c.p = *p;\n" : "  " + type + " c{};\n  c.p = p;\n");
  for (const std::string& line : statements.take_lines()) result.text += line + "\n";
  result.text += stores + "  return c;\n}\n";
  return result;
}

}  // namespace kanec::emit
