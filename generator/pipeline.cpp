// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline.hpp"

#include "generator/emit/header.hpp"
#include "generator/lower/lower.hpp"
#include "generator/program/passes.hpp"
#include "generator/symbolic/derive.hpp"
#include "runtime/base/hash.hpp"

namespace kanec {
namespace {

std::string options_text(const GenerateOptions& options) {
  if (options.functions.empty()) return "all functions";
  std::string text = "functions";
  for (const std::string& function : options.functions) text += " " + function;
  return text;
}

}  // namespace

Generated generate(const scene::Scene& scene, const GenerateOptions& options) {
  const symbolic::Equations equations = symbolic::derive(scene);
  const program::Program program = program::optimized(lower::lower(equations, options.functions));
  emit::Model model{&scene, version(), "", options_text(options)};
  model.hash = fingerprint(emit::emit_header(model, program) + emit::emit_abi(model, program));
  return {program, scene.name, model.hash, emit::emit_header(model, program), emit::emit_abi(model, program)};
}

std::string version() { return KANEC_VERSION; }

}  // namespace kanec
