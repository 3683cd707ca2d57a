// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/header.hpp"
#include "generator/emit/signature.hpp"
#include "generator/emit/statements.hpp"
#include "generator/program/ledger.hpp"

namespace kanec::emit {
namespace {

// "{values[0], values[1]}" for the fields of a struct.
std::string spread(const std::string& array, std::size_t count) {
  std::string text = "{";
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + array + "[" + std::to_string(i) + "]";
  return text + "}";
}

std::string wrapper(const scene::Scene& scene, const program::Function& function) {
  const Signature& shape = function.signature;
  const std::string arguments = argument_list(shape, "*static_cast<const Prepared*>(prepared)",
                                              "model::Inputs<double>" + spread("u", scene.inputs.size()), "out");
  return "void " + function.name +
         "(const void* prepared, double, [[maybe_unused]] const double* x, [[maybe_unused]] const double* y,\n"
         "    [[maybe_unused]] const double* ydot, [[maybe_unused]] const double* u, double* out) {\n  model::" +
         function.name + "(" + arguments + ");\n}\n\n";
}

std::string record(const program::Function& function, const program::Ledger& cost) {
  std::string text = "    {\"" + function.name + "\", " + std::to_string(function.n_out);
  for (const int n : {cost.adds, cost.multiplies, cost.divides, cost.square_roots, cost.trigonometric})
    text += ", " + std::to_string(n);
  return text + ", " + function.name + "},\n";
}

// Lists end in a null: C++ has no empty arrays.
std::string named_lists(const std::string& what, const std::vector<scene::Named>& list) {
  std::string names = "const char* const " + what + "_names[] = {";
  std::string values = "const double " + what + "_defaults[] = {";
  for (const scene::Named& named : list) {
    names += "\"" + named.name + "\", ";
    values += literal(named.value) + ", ";
  }
  return names + "nullptr};\n" + values + "0};\n";
}

}  // namespace

std::string emit_abi(const Model& model, const program::Program& program) {
  const scene::Scene& scene = *model.scene;
  std::string text = "// SPDX-License-Identifier: BSD-3-Clause\n// " + scene.name +
                     " in double behind kanec's ABI. Not needed by a program that includes the header.\n"
                     "#include <new>\n\n#include \"abi.h\"\n#include \"" + scene.name + ".hpp\"\n\nnamespace {\n\n"
                     "namespace model = kanec::" + scene.name + ";\nusing Prepared = model::Prepared<double>;\n\n";
  text += "void prepare([[maybe_unused]] const double* p, void* prepared) {\n  ::new (prepared) Prepared(model::prepare("
          "model::Parameters<double>" + spread("p", scene.parameters.size()) + "));\n}\n\n";
  for (const program::Function& function : program.functions) text += wrapper(scene, function);
  text += "const kanec_function functions[] = {\n";
  const std::vector<program::Ledger> costs = program::ledgers(program);
  for (std::size_t i = 0; i < costs.size(); ++i) text += record(program.functions[i], costs[i]);
  text += "};\n\n" + named_lists("parameter", scene.parameters) + named_lists("input", scene.inputs) + "\n";
  text += "const kanec_model description = {\n    KANEC_ABI_VERSION, sizeof(kanec_model), \"" + scene.name + "\", \"" +
          model.hash + "\", " + std::to_string(size(scene)) + ", model::nx, model::ny,\n    model::n_parameters, model::n_inputs, " +
          std::to_string(program.functions.size()) +
          ", parameter_names, parameter_defaults, input_names,\n    input_defaults, sizeof(Prepared), prepare, functions};\n\n"
          "}  // namespace\n\n"
          "extern \"C\" __attribute__((visibility(\"default\"))) const kanec_model* kanec_model_entry(void) { return "
          "&description; }\n";
  return text;
}

}  // namespace kanec::emit
