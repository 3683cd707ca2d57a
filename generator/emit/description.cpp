// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/description.hpp"

#include "generator/emit/signature.hpp"
#include "generator/emit/sparsity.hpp"
#include "generator/emit/statements.hpp"
#include "generator/program/ledger.hpp"
#include "generator/scene/entry_names.hpp"
#include "generator/scene/spelling.hpp"

namespace kanec::emit {
namespace {

// As the ABI has it: KANEC_READS_T and so on.
unsigned flags_of(const Reads& reads) {
  return (reads.time ? 1u : 0u) | (reads.x ? 2u : 0u) | (reads.y ? 4u : 0u) | (reads.ydot ? 8u : 0u) |
         (reads.inputs ? 16u : 0u);
}

std::string record(const program::Function& function, const program::Ledger& cost, const Reads& reads,
                   const std::string& evaluate) {
  std::string text = "    {\"" + function.name + "\", " + std::to_string(function.n_out);
  for (const int n : {cost.adds, cost.multiplies, cost.divides, cost.square_roots, cost.trigonometric, cost.functions})
    text += ", " + std::to_string(n);
  return text + ", " + std::to_string(flags_of(reads)) + ", " + evaluate + "},\n";
}

// Lists end in a null: C++ has no empty arrays.
std::string name_list(const std::string& what, const std::vector<std::string>& list) {
  std::string text = "const char* const " + what + "_names[] = {";
  for (const std::string& name : list) text += "\"" + name + "\", ";
  return text + "nullptr};\n";
}

std::string named_lists(const std::string& what, const std::vector<scene::Named>& list) {
  std::vector<std::string> names;
  std::string values = "const double " + what + "_defaults[] = {";
  for (const scene::Named& named : list) {
    names.push_back(named.name);
    values += literal(named.value) + ", ";
  }
  return name_list(what, names) + values + "0};\n";
}

}  // namespace

std::vector<scene::BodyLayout> attitudes(const scene::Scene& scene) {
  std::vector<scene::BodyLayout> list = scene::Layout(scene).bodies;
  std::erase_if(list, [](const scene::BodyLayout& at) { return at.eps < 0; });
  return list;
}

std::string attitude_list(const scene::Scene& scene) {
  std::string text = "const kanec_attitude attitudes[] = {";
  for (const scene::BodyLayout& at : attitudes(scene))
    text += "{" + std::to_string(at.eps) + ", " + std::to_string(at.omega) + "}, ";
  return text + "{0, 0}};\n";
}

namespace {

std::string description(const Model& model, std::size_t n_functions, std::size_t n_patterns, bool callable) {
  const scene::Scene& scene = *model.scene;
  return "const kanec_model description = {\n    KANEC_ABI_VERSION, sizeof(kanec_model), \"" + scene.name + "\", \"" +
         model.hash + "\", model::n_bodies, model::nx, model::ny,\n    model::n_parameters, model::n_inputs, " +
         std::to_string(n_functions) +
         ", parameter_names, parameter_defaults, input_names,\n    input_defaults, sizeof(Prepared), " +
         (callable ? "prepare" : "nullptr") + ", functions, coordinate_names, speed_names,\n    " +
         std::to_string(attitudes(scene).size()) + ", attitudes, " +
         (callable ? "n_taylor, taylor, " : "0, nullptr, ") + std::to_string(n_patterns) + ", patterns};\n\n";
}

}  // namespace

std::string described(const Model& model, const program::Program& program, const Used& read, bool callable) {
  std::string text = "const kanec_function functions[] = {\n";
  const std::vector<program::Ledger> costs = program::ledgers(program);
  const PatternTable patterns = pattern_table(program);
  for (std::size_t i = 0; i < costs.size(); ++i)
    text += record(program.functions[i], costs[i], reads(program, program.functions[i]),
                   callable ? program.functions[i].name : "nullptr");
  return text + "};\n\n" + named_lists("parameter", read.parameters) + named_lists("input", read.inputs) +
         name_list("coordinate", in_words(*model.scene, coordinate_names(*model.scene))) +
         name_list("speed", in_words(*model.scene, speed_names(*model.scene))) + attitude_list(*model.scene) +
         patterns.text + "\n" + description(model, costs.size(), patterns.size, callable);
}

std::string spread(const std::string& array, std::size_t count, const std::string& close) {
  std::string text = "{";
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + array + "[" + std::to_string(i) + "]" + close;
  return text + "}";
}

std::string begin(const scene::Scene& scene, const std::string& what, const std::string& includes) {
  return "// SPDX-License-Identifier: BSD-3-Clause\n// " + scene.name + " " + what +
         " behind kanec's ABI. Not needed by a program that includes the header.\n" + includes + "#include \"" +
         scene.name + ".hpp\"\n\nnamespace {\n\nnamespace model = kanec::" + scene::spelled(scene.name) + ";\n";
}

std::string entry(const std::string& type, const std::string& name, const std::string& value) {
  return "extern \"C\" __attribute__((visibility(\"default\"))) const " + type + "* " + name + "(void) { return " +
         value + "; }\n";
}

}  // namespace kanec::emit
