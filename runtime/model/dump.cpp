// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/dump.hpp"

#include <fmt/format.h>

#include "generator/program/critical_path.hpp"
#include "generator/scene/place.hpp"
#include "generator/symbolic/derive.hpp"
#include "generator/symbolic/notation.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/model/scene_text.hpp"

namespace kanec {
namespace {

std::string equations_text(const symbolic::Equations& equations) {
  const auto print = [&](const GiNaC::ex& e) { return symbolic::notation(e, equations.table, symbolic::Style::text); };
  std::string text;
  for (const symbolic::Quantity& quantity : equations.quantities)
    text += fmt::format("{} = {}  # body {}: {}\n", print(quantity.symbol), print(quantity.value), quantity.body,
                        quantity.meaning);
  for (const symbolic::Function& function : equations.functions) {
    text += fmt::format("\n{}: {}; {} results\n", function.name, function.meaning, function.n_out);
    for (const symbolic::Output& output : function.outputs)
      text += fmt::format("  [{}, stride {}] = {}{}\n", output.offset, output.stride, print(output.block),
                          output.transposed ? ", transposed" : "");
  }
  return text;
}

// An operation as text; results are %0, %1, ...
struct Line {
  const program::ArgumentNames& names;

  static std::string two(program::Index a, const char* sign, program::Index b) {
    return fmt::format("%{} {} %{}", a, sign, b);
  }

  std::string operator()(const program::Constant& op) const { return shortest(op.value.rounded()); }
  std::string operator()(const program::Variable& op) const {
    if (op.group == program::Group::time) return "t";
    const std::vector<std::string>* const groups[] = {&names.parameters, &names.x, &names.y, &names.ydot,
                                                      &names.inputs};
    return (*groups[static_cast<std::size_t>(op.group)])[static_cast<std::size_t>(op.index)];
  }
  std::string operator()(const program::Add& op) const { return two(op.a, "+", op.b); }
  std::string operator()(const program::Subtract& op) const { return two(op.a, "-", op.b); }
  std::string operator()(const program::Multiply& op) const { return two(op.a, "*", op.b); }
  std::string operator()(const program::Divide& op) const { return two(op.a, "/", op.b); }
  std::string operator()(const program::SquareRoot& op) const { return fmt::format("sqrt %{}", op.a); }
  std::string operator()(const program::Sine& op) const { return fmt::format("sin %{}", op.a); }
  std::string operator()(const program::Cosine& op) const { return fmt::format("cos %{}", op.a); }
  std::string operator()(const program::UnaryCall& op) const {
    return fmt::format("{} %{}", program::name(op.function), op.a);
  }
  std::string operator()(const program::BinaryCall& op) const {
    return fmt::format("{} %{} %{}", program::name(op.function), op.a, op.b);
  }
  std::string operator()(const program::Select& op) const {
    return fmt::format("%{} < 0 ? %{} : %{}", op.sign, op.a, op.b);
  }
};

std::string shown_ref(const program::Ref& ref) { return fmt::format("{}%{}", ref.negative ? "-" : "", ref.node); }

std::string function_text(const program::Function& function) {
  std::string text = fmt::format("\n{}: {}\n", function.name, function.meaning);
  for (const program::Quantity& quantity : function.quantities)
    for (std::size_t i = 0; i < quantity.entries.size(); ++i)
      text += fmt::format("  {} = {}\n", quantity.labels[i], shown_ref(quantity.entries[i]));
  for (std::size_t i = 0; i < function.outputs.size(); ++i)
    text += fmt::format("  out[{}] = {}\n", i, shown_ref(function.outputs[i]));
  for (const program::Placement& place : function.placements)
    text += fmt::format("  block {} at {}, stride {}\n", place.block, place.offset, function.stride);
  return text;
}

std::string program_text(const program::Program& program) {
  std::string text;
  for (std::size_t i = 0; i < program.nodes.size(); ++i)
    text += fmt::format("%{} = {}\n", i, std::visit(Line{program.names}, program.nodes[i]));
  for (const program::Function& function : program.functions) text += function_text(function);
  return text;
}

}  // namespace

std::vector<std::string> stage_names() { return {"scene", "equations", "program", "ledger", "header", "abi"}; }

std::string dump(const scene::Scene& scene, const std::vector<std::string>& functions, const std::string& stage) {
  if (stage == "scene") return scene_text(scene);
  if (stage == "equations") return equations_text(symbolic::derive(scene));
  const Generated generated = generate(scene, {functions});
  if (stage == "program") return program_text(generated.program);
  if (stage == "ledger") return ledger_text(generated.program);
  if (stage == "header") return generated.header;
  if (stage == "abi") return generated.abi;
  throw InputError("stage: found " + scene::in_quotes(stage) + "; allowed: " + scene::one_of(stage_names(), stage));
}

TextRow ledger_headings() {
  return {"function", "operations", "add", "multiply", "divide", "square root", "sine, cosine", "other", "results"};
}

TextRow ledger_row(const std::string& function, const program::Ledger& ledger, const std::string& results) {
  TextRow row = {function};
  for (const int n : {ledger.operations(), ledger.adds, ledger.multiplies, ledger.divides, ledger.square_roots,
                      ledger.trigonometric, ledger.functions})
    row.push_back(std::to_string(n));
  row.push_back(results);
  return row;
}

std::string ledger_text(const program::Program& program) {
  std::vector<TextRow> rows = {ledger_headings()};
  for (const program::Function& function : program.functions)
    rows.push_back(ledger_row(function.name, program::ledger(program, function), std::to_string(function.n_out)));
  if (!program.names.parameters.empty())
    rows.push_back(ledger_row("prepare (once)", program::prepare_ledger(program), ""));
  return text_table(rows);
}

Json ledger_json(const program::Ledger& ledger) {
  return {{"operations", ledger.operations()},   {"adds", ledger.adds},
          {"multiplies", ledger.multiplies},     {"divides", ledger.divides},
          {"square_roots", ledger.square_roots}, {"trigonometric", ledger.trigonometric},
          {"other_functions", ledger.functions}};
}

Json ledgers_json(const program::Program& program) {
  Json functions = Json::array();
  for (const program::Function& function : program.functions) {
    Json entry = {{"name", function.name}, {"results", function.n_out}};
    entry.update(ledger_json(program::ledger(program, function)));
    entry["instructions"] = program::instructions(program, function);
    entry["critical_path"] = program::critical_path(program, function);
    functions.push_back(std::move(entry));
  }
  return functions;
}

}  // namespace kanec
