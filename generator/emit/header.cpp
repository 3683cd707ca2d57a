// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/header.hpp"

#include "generator/emit/angles.hpp"
#include "generator/emit/calls.hpp"
#include "generator/emit/check_code.hpp"
#include "generator/emit/form.hpp"
#include "generator/emit/function.hpp"
#include "generator/emit/names.hpp"
#include "generator/emit/preamble.hpp"
#include "generator/emit/prepare.hpp"
#include "generator/emit/sparsity.hpp"
#include "generator/program/ledger.hpp"

namespace kanec::emit {
namespace {

std::string constant(const std::string& name, std::size_t value) {
  return "inline constexpr int " + name + " = " + std::to_string(value) + ";\n";
}

std::string sizes(const scene::Scene& scene, const Used& used) {
  const auto count = [](int n) { return static_cast<std::size_t>(n); };
  return constant("n_bodies", scene.bodies.size()) + constant("nx", count(n_coordinates(scene))) +
         constant("ny", count(n_speeds(scene))) + constant("n_parameters", used.parameters.size()) +
         constant("n_inputs", used.inputs.size());
}

}  // namespace

std::string emit_header(const Model& model, const program::Program& program) {
  const scene::Scene& scene = *model.scene;
  const Used read = used(scene, program);
  const std::vector<program::Stage> stages = program::stages(program);
  const Preparation preparation = emit_prepare(read, program, stages);
  const std::vector<program::Ledger> costs = program::ledgers(program);
  const std::vector<Form> how = forms(program, costs, model);
  const std::string turns = cos_sin_text(model, program);
  const std::string included =
      includes(program) + (turns.empty() ? "" : "#include <cstdint>\n#include <cstring>\n" + turns);
  std::string code = "namespace kanec::" + scene.name + " {\n\n" + sizes(scene, read) +
                     "inline constexpr char model_hash[] = \"" + model.hash + "\";\n\n" + state_constants(scene) +
                     (selects(program) ? selection() : "") + sparsity(program) + preparation.text;
  for (std::size_t i = 0; i < costs.size(); ++i)
    code += "\n" + emit_function(model, program, stages, program.functions[i], costs[i], preparation.named, how[i]);
  code += "\n}  // namespace kanec::" + scene.name + "\n";
  check_code(code, {"kanec_cos_sin"});
  return preamble(model, program, read, costs) + memory(program, how) + "#pragma once\n\n" + included +
         (included.empty() ? "" : "\n") + code;
}

}  // namespace kanec::emit
