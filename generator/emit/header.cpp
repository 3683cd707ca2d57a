// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/header.hpp"

#include <algorithm>

#include "generator/emit/angles.hpp"
#include "generator/emit/c_file.hpp"
#include "generator/emit/calls.hpp"
#include "generator/emit/check_code.hpp"
#include "generator/emit/form.hpp"
#include "generator/emit/function.hpp"
#include "generator/emit/marked.hpp"
#include "generator/emit/names.hpp"
#include "generator/emit/preamble.hpp"
#include "generator/emit/prepare.hpp"
#include "generator/emit/sparsity.hpp"
#include "generator/program/ledger.hpp"
#include "generator/scene/spelling.hpp"
#include "runtime/lanes/files.hpp"

namespace kanec::emit {
namespace {

std::string sizes(const scene::Scene& scene, const Used& used, const Syntax& syntax) {
  const std::pair<const char*, std::size_t> all[] = {{"n_bodies", scene.bodies.size()},
                                                     {"nx", static_cast<std::size_t>(n_coordinates(scene))},
                                                     {"ny", static_cast<std::size_t>(n_speeds(scene))},
                                                     {"n_parameters", used.parameters.size()},
                                                     {"n_inputs", used.inputs.size()}};
  std::string text, list;
  for (const auto& [name, size] : all) {
    const std::string constant = syntax.global(name) + " = " + std::to_string(size);
    list += (list.empty() ? "" : ", ") + constant;
    text += syntax.constants(constant);
  }
  return syntax.is_c() ? syntax.constants(list) : text;  // in C of one type, so that they may be added
}

// Structs, constants and functions.
std::string model_code(const Model& model, const program::Program& program, const Used& read,
                       const std::vector<program::Ledger>& costs, const std::vector<Form>& how) {
  const scene::Scene& scene = *model.scene;
  const Syntax syntax(model);
  const std::vector<program::Stage> stages = program::stages(program);
  const Preparation preparation = emit_prepare(read, program, stages, syntax);
  std::string code = sizes(scene, read, syntax) + syntax.table("char", "model_hash", "[]") + "\"" + model.hash +
                     "\";\n\n" + state_constants(scene, syntax) + (selects(program) ? selection(syntax) : "") +
                     comparisons(program, syntax) + small_cos_sin(model, program) + sparsity(program, syntax) +
                     preparation.text;
  for (std::size_t i = 0; i < costs.size(); ++i)
    code += "\n" + emit_function(model, program, stages, program.functions[i], costs[i], preparation.named, how[i]);
  return code;
}

constexpr const char* not_a_macro =
    "// behind a name that may be a macro with arguments, so that it is none\n#define KANEC_CALL\n";

std::string cpp_file(const Model& model, const program::Program& program, const std::string& code) {
  const bool has_vectors = takes_turns(model, program) && model.optimize != Optimize::size;
  const std::string turns = has_vectors ? "#include <cstdint>\n\n" + between_marks(cos_sin_text()) : "";
  const std::string included = includes(program, Syntax()) + turns + (compares(program) ? not_a_macro : "");
  const std::string space = "kanec::" + scene::spelled(model.scene->name);
  const std::string all = "namespace " + space + " {\n\n" + code + "\n}  // namespace " + space + "\n";
  check_code(all, {"kanec_cos_sin"});
  return "#pragma once\n\n" + included + (included.empty() ? "" : "\n") + all;
}

std::string c_file(const Model& model, const program::Program& program, const std::string& code) {
  const Syntax syntax(model);
  const bool apart = code.find("KANEC_APART") != std::string::npos;
  std::vector<std::string> around = {"kanec_real"};
  if (model.optimize != Optimize::size) around.push_back(syntax.call("cos_sin"));
  for (const std::string& function : functions_called(program)) around.push_back("kanec_" + function);
  const std::string all = "typedef kanec_real " + syntax.global("real") + ";\n" + code;
  check_code(all, around);
  return c_beginning(model, program, apart) + all + c_end(program, apart);
}

}  // namespace

std::string emit_header(const Model& model, const program::Program& program) {
  const Used read = used(*model.scene, program);
  const std::vector<program::Ledger> costs = program::ledgers(program);
  const std::vector<Form> how = forms(program, costs, model);
  const std::string code = model_code(model, program, read, costs, how);
  return preamble(model, program, read, costs) + memory(program, how) +
         (model.language == Language::c ? c_file(model, program, code) : cpp_file(model, program, code));
}

}  // namespace kanec::emit
