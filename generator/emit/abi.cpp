// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/header.hpp"
#include "generator/emit/signature.hpp"
#include "generator/emit/statements.hpp"
#include "generator/emit/used.hpp"
#include "generator/program/ledger.hpp"

namespace kanec::emit {
namespace {

// "{values[0], values[1]}" for the fields of a struct.
std::string spread(const std::string& array, std::size_t count) {
  std::string text = "{";
  for (std::size_t i = 0; i < count; ++i) text += (i == 0 ? "" : ", ") + array + "[" + std::to_string(i) + "]";
  return text + "}";
}

std::string wrapper(const program::Program& program, const program::Function& function, const Used& used) {
  const ArgumentList list(program, function, !used.inputs.empty());
  const std::string arguments = list.values("*static_cast<const Prepared*>(prepared)",
                                            "model::Inputs<double>" + spread("u", used.inputs.size()), "out");
  return "void " + function.name +
         "(const void* prepared, [[maybe_unused]] double t, [[maybe_unused]] const double* x,\n"
         "    [[maybe_unused]] const double* y, [[maybe_unused]] const double* ydot, [[maybe_unused]] const double* u,\n"
         "    double* out) {\n  model::" + function.name + "(" + arguments + ");\n}\n\n";
}

std::string record(const program::Function& function, const program::Ledger& cost) {
  std::string text = "    {\"" + function.name + "\", " + std::to_string(function.n_out);
  for (const int n :
       {cost.adds, cost.multiplies, cost.divides, cost.square_roots, cost.trigonometric, cost.functions})
    text += ", " + std::to_string(n);
  return text + ", " + function.name + "},\n";
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

// Bodies whose Euler parameters are in the state.
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

std::string description(const Model& model, std::size_t n_functions) {
  const scene::Scene& scene = *model.scene;
  return "const kanec_model description = {\n    KANEC_ABI_VERSION, sizeof(kanec_model), \"" + scene.name + "\", \"" +
         model.hash + "\", model::n_bodies, model::nx, model::ny,\n    model::n_parameters, model::n_inputs, " +
         std::to_string(n_functions) +
         ", parameter_names, parameter_defaults, input_names,\n    input_defaults, sizeof(Prepared), prepare, functions, "
         "coordinate_names, speed_names,\n    " + std::to_string(attitudes(scene).size()) + ", attitudes};\n\n";
}

}  // namespace

std::string emit_abi(const Model& model, const program::Program& program) {
  const scene::Scene& scene = *model.scene;
  const Used read = used(scene, program);
  std::string text = "// SPDX-License-Identifier: BSD-3-Clause\n// " + scene.name +
                     " in double behind kanec's ABI. Not needed by a program that includes the header.\n"
                     "#include <new>\n\n#include \"abi.h\"\n#include \"" + scene.name + ".hpp\"\n\nnamespace {\n\n"
                     "namespace model = kanec::" + scene.name + ";\nusing Prepared = model::Prepared<double>;\n\n";
  text += "void prepare([[maybe_unused]] const double* p, void* prepared) {\n  ::new (prepared) Prepared(model::prepare("
          "model::Parameters<double>" + spread("p", read.parameters.size()) + "));\n}\n\n";
  for (const program::Function& function : program.functions) text += wrapper(program, function, read);
  text += "const kanec_function functions[] = {\n";
  const std::vector<program::Ledger> costs = program::ledgers(program);
  for (std::size_t i = 0; i < costs.size(); ++i) text += record(program.functions[i], costs[i]);
  text += "};\n\n" + named_lists("parameter", read.parameters) + named_lists("input", read.inputs) +
          name_list("coordinate", coordinate_names(scene)) + name_list("speed", speed_names(scene)) +
          attitude_list(scene) + "\n" + description(model, costs.size());
  return text +
         "}  // namespace\n\n"
         "extern \"C\" __attribute__((visibility(\"default\"))) const kanec_model* kanec_model_entry(void) { return "
         "&description; }\n";
}

}  // namespace kanec::emit
