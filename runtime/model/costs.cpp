// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/costs.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "generator/pipeline.hpp"
#include "generator/program/critical_path.hpp"
#include "runtime/base/fit.hpp"
#include "runtime/model/dump.hpp"
#include "runtime/model/functions.hpp"
#include "runtime/text/table.hpp"

namespace kanec {
namespace {

// What an overview shows of each scene.
const std::vector<std::string> overview_functions = {"accelerations", "residual", "mass_matrix", "forcing",
                                                     "kinematics"};

std::vector<TextRow> rows_of(const SceneCost& cost) {
  std::vector<TextRow> rows;
  for (const FunctionCost& function : cost.functions)
    rows.push_back(ledger_row(function.name, function.ledger, std::to_string(function.results)));
  if (cost.prepare != program::Ledger{}) rows.push_back(ledger_row("prepare (once)", cost.prepare, ""));
  return rows;
}

std::string operations_of(const SceneCost& cost, const std::string& name) {
  for (const FunctionCost& function : cost.functions)
    if (function.name == name) return std::to_string(function.ledger.operations());
  return "";
}

std::vector<TextRow> overview(const std::vector<SceneCost>& costs) {
  std::vector<TextRow> rows = {{"scene", "bodies", "coordinates", "speeds"}};
  rows[0].insert(rows[0].end(), overview_functions.begin(), overview_functions.end());
  for (const SceneCost& cost : costs) {
    rows.push_back({cost.name, std::to_string(cost.bodies), std::to_string(cost.nx), std::to_string(cost.ny)});
    for (const std::string& function : overview_functions) rows.back().push_back(operations_of(cost, function));
  }
  return rows;
}

// The first row is the heading; columns from `first_right` on stand to the right.
std::string markdown_table(const std::vector<TextRow>& rows, std::size_t first_right) {
  std::string text = markdown_row(rows[0]) + "|";
  for (std::size_t i = 0; i < rows[0].size(); ++i) text += i < first_right ? "---|" : "--:|";
  text += '\n';
  for (std::size_t i = 1; i < rows.size(); ++i) text += markdown_row(rows[i]);
  return text;
}

}  // namespace

SceneCost cost_of(const scene::Scene& scene, bool all_functions,
                  const std::function<void(const std::string& note)>& tell) {
  const std::vector<std::string> functions = all_functions ? Functions(scene).names() : std::vector<std::string>{};
  GenerateOptions options{functions};
  options.tell = tell;
  const program::Program program = generate(scene, options).program;
  SceneCost cost{scene.name, size(scene), n_coordinates(scene), n_speeds(scene), {}, program::prepare_ledger(program)};
  const std::vector<program::Ledger> ledgers = program::ledgers(program);
  for (std::size_t i = 0; i < ledgers.size(); ++i)
    cost.functions.push_back({program.functions[i].name, program.functions[i].n_out, ledgers[i],
                              program::instructions(program, program.functions[i]),
                              program::critical_path(program, program.functions[i])});
  return cost;
}

std::string costs_text(const std::vector<SceneCost>& costs) {
  std::vector<TextRow> rows = {ledger_headings()};
  rows[0].insert(rows[0].begin(), "scene");
  for (const SceneCost& cost : costs)
    for (TextRow& row : rows_of(cost)) {
      row.insert(row.begin(), cost.name);
      rows.push_back(std::move(row));
    }
  return text_table(rows, "llr");
}

Json costs_json(const std::vector<SceneCost>& costs) {
  Json list = Json::array();
  for (const SceneCost& cost : costs) {
    Json functions = Json::array();
    for (const FunctionCost& function : cost.functions) {
      functions.push_back({{"name", function.name}, {"results", function.results}});
      functions.back().update(ledger_json(function.ledger));
      functions.back()["instructions"] = function.instructions;
      functions.back()["critical_path"] = function.critical_path;
    }
    list.push_back({{"model", cost.name},
                    {"n_bodies", cost.bodies},
                    {"nx", cost.nx},
                    {"ny", cost.ny},
                    {"functions", std::move(functions)},
                    {"prepare", ledger_json(cost.prepare)}});
  }
  return list;
}

std::string costs_markdown(const std::vector<SceneCost>& costs, const std::string& command) {
  std::string text =
      "# Ledger\n\nWritten by " + fit::code(command) +
      "; a test compares. One evaluation of each emitted function, counted exactly:\noperations are additions, "
      "multiplications and divisions in double; square roots, sines and cosines and other functions\nstand beside "
      "them. What depends on parameters alone is computed once, in `prepare`.\n\n## Operations by scene\n\n" +
      markdown_table(overview(costs), 1);
  for (const SceneCost& cost : costs) {
    std::vector<TextRow> rows = rows_of(cost);
    rows.insert(rows.begin(), ledger_headings());
    text += "\n## " + cost.name + "\n\n" + markdown_table(rows, 1);
  }
  return text;
}

}  // namespace kanec
