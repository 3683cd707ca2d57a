// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/header.hpp"

#include <algorithm>

#include "generator/emit/function.hpp"
#include "generator/emit/prepare.hpp"
#include "generator/program/ledger.hpp"

namespace kanec::emit {
namespace {

std::string constant(const std::string& name, int value) {
  return "inline constexpr int " + name + " = " + std::to_string(value) + ";\n";
}

std::string bodies(const scene::Scene& scene) {
  std::string text;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const int lower = scene.lower[k];
    text += "//   " + std::to_string(k + 1) + " " + scene.bodies[k].name + " on " +
            (lower == 0 ? "the inertial frame" : std::to_string(lower)) + "\n";
  }
  return text;
}

std::string operations(const program::Program& program, const std::vector<program::Ledger>& costs) {
  std::string text;
  for (std::size_t i = 0; i < costs.size(); ++i) {
    const program::Function& function = program.functions[i];
    const program::Ledger& ledger = costs[i];
    text += "//   " + function.name + std::string(24 - std::min<std::size_t>(23, function.name.size()), ' ') +
            std::to_string(ledger.operations()) + " (" + program::text(ledger) + ")\n";
  }
  return text;
}

std::string comment(const std::string& text) {
  std::string lines;
  for (const std::string& line : wrapped("// " + text, "// ")) lines += line + "\n";
  return lines;
}

std::string preamble(const Model& model, const program::Program& program, const std::vector<program::Ledger>& costs) {
  const scene::Scene& scene = *model.scene;
  std::string text = "// SPDX-License-Identifier: BSD-3-Clause\n" +
                     comment(scene.name + ": equations of motion of " + std::to_string(size(scene)) + " rigid " +
                             (size(scene) == 1 ? "body" : "bodies") + ", made by kanec " + model.version +
                             ". Not to be edited by hand.");
  text += "//\n" + comment("model " + model.hash + "; " + model.options) + "// bodies, each with a free joint:\n" +
          bodies(scene);
  text +=
      "//\n"
      "// Units SI, angles in rad. x = (eps_1 .. eps_N ; s_1 .. s_N), y = (omega_1 .. omega_N ; sdot_1 .. sdot_N):\n"
      "//   eps    Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)\n"
      "//   s      translation from the joint point, axes of the lower body [m] (3)\n"
      "//   omega  absolute angular velocity, body axes [rad/s] (3)\n"
      "//   sdot   rate of s [m/s] (3)\n"
      "// R takes inertial components to body components; a~ b = a x b; matrices are row-major.\n"
      "// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:\n"
      "// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one.\n"
      "//\n// operations of one call (adds + multiplies + divides):\n";
  return text + operations(program, costs);
}

std::string includes(const program::Program& program) {
  const auto needs_functions = [](const program::Node& node) {
    return std::holds_alternative<program::SquareRoot>(node) || std::holds_alternative<program::Sine>(node) ||
           std::holds_alternative<program::Cosine>(node);
  };
  const bool any = std::any_of(program.nodes.begin(), program.nodes.end(), needs_functions);
  return any ? "#pragma once\n\n#include <cmath>\n\n" : "#pragma once\n\n";
}

}  // namespace

std::string emit_header(const Model& model, const program::Program& program) {
  const scene::Scene& scene = *model.scene;
  const std::vector<program::Stage> stages = program::stages(program);
  const Preparation preparation = emit_prepare(scene, program, stages);
  const std::vector<program::Ledger> costs = program::ledgers(program);
  std::string text = preamble(model, program, costs) + includes(program) + "namespace kanec::" + scene.name + " {\n\n";
  text += constant("n_bodies", size(scene)) + constant("nx", n_coordinates(scene)) + constant("ny", n_speeds(scene)) +
          constant("n_parameters", static_cast<int>(scene.parameters.size())) +
          constant("n_inputs", static_cast<int>(scene.inputs.size())) + "inline constexpr char model_hash[] = \"" +
          model.hash + "\";\n\n";
  text += preparation.text;
  for (std::size_t i = 0; i < costs.size(); ++i)
    text += "\n" + emit_function(model, program, stages, program.functions[i], costs[i], preparation.names);
  return text + "\n}  // namespace kanec::" + scene.name + "\n";
}

}  // namespace kanec::emit
