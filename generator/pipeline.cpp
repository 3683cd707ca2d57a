// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/pipeline.hpp"

#include <utility>

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

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
}

}  // namespace

Generated generate(const scene::Scene& scene, const GenerateOptions& options) {
  const symbolic::Equations equations = symbolic::derive(scene);
  const program::Program program = program::optimized(lower::lower(equations, options.functions));
  // the hash is of the text that it stands in, written first with a mark in its place
  const std::string mark = "@model-hash-mark";
  const emit::Model model{&scene, version(), mark, options_text(options)};
  std::string header = emit::emit_header(model, program);
  std::string abi = emit::emit_abi(model, program);
  const std::string hash = fingerprint(header + abi);
  replace_all(header, mark, hash);
  replace_all(abi, mark, hash);
  return {program, scene.name, hash, std::move(header), std::move(abi)};
}

std::vector<Available> available_functions(const scene::Scene& scene) {
  std::vector<Available> result;
  for (const symbolic::Function& function : symbolic::derive(scene).functions)
    result.push_back({function.name, function.meaning, function.n_out, function.signature});
  return result;
}

std::string version() { return KANEC_VERSION; }

}  // namespace kanec
