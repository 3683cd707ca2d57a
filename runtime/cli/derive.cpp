// kanec derive: the tables of the derivation.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/derive.hpp"

#include <optional>

#include "generator/emit/grids.hpp"
#include "generator/emit/tables.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"
#include "runtime/cli/arguments.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/model/model.hpp"
#include "runtime/model/reductions.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/text/json.hpp"

namespace kanec::cli {
namespace {

constexpr auto footer = R"(Example: the source's six bodies, on paper
  kanec derive --connection 0,1,2,2,1,5 --format latex -o six.tex && pdflatex six.tex

Prints the bodies, the connection array, u(K), the state vectors, the kinematical equations, rotations, positions,
velocities, partial velocities and their time derivatives, block by block and one matrix a body, A, f and the loads;
R1^T is R_1 transposed, a~ the skew matrix of a.

  kanec derive models/arm_6 --reduction --functions accelerations

prints instead what was left out of the scene before its equations, and the operations that each reduction saves.)";

struct Options {
  SceneArgument scene;
  std::string format = "text";
  bool json = false;
  bool reduction = false;
  std::vector<std::string> functions;
  std::string output;
};

// A line by the heads of its columns.
Json lines_json(const emit::Grid& grid) {
  Json lines = Json::array();
  for (const std::vector<std::string>& line : grid.lines) {
    Json cells;
    for (std::size_t i = 0; i < line.size(); ++i) cells[grid.columns[i].head] = line[i];
    lines.push_back(std::move(cells));
  }
  return lines;
}

Json tables_json(const symbolic::Equations& equations) {
  Json tables = Json::array();
  for (const emit::Table& table : emit::tables(equations, symbolic::Style::text)) {
    Json rows = Json::array();
    for (const auto& [left, right] : table.rows) rows.push_back({{"left", left}, {"right", right}});
    tables.push_back({{"title", table.title}, {"rows", std::move(rows)}});
  }
  const scene::Scene& scene = equations.scene;
  return {{"model", scene.name},
          {"connection", scene.lower},
          {"depth", scene::depth(scene.lower)},
          {"nx", n_coordinates(scene)},
          {"ny", n_speeds(scene)},
          {"tables", std::move(tables)},
          {"bodies", lines_json(emit::body_grid(equations, symbolic::Style::text))},
          {"loads", lines_json(emit::load_grid(equations, symbolic::Style::text))}};
}

std::string reduction_document(const scene::Scene& scene, const std::vector<std::string>& functions, bool json) {
  const std::vector<Reduction> list = reductions(scene, functions);
  return json ? json_text(reductions_json(scene.name, list)) : reductions_text(scene.name, list);
}

// The tables of the source: origins where the scene has them.
constexpr symbolic::Reductions as_typed = {.place_origins = false, .regroup = false, .turn_axes = false};

std::string document(const symbolic::Equations& equations, const std::string& format) {
  if (format == "json") return json_text(tables_json(equations));
  return format == "latex" ? emit::latex_document(equations) : emit::text_document(equations);
}

int derive(const Options& options) {
  const scene::Scene scene = load(options.scene);
  const std::string format = options.json ? "json" : options.format;
  if (!options.functions.empty() && !options.reduction) throw InputError("--functions goes with --reduction");
  if (options.reduction && format == "latex")
    throw InputError("--reduction: found --format latex; allowed: text, json");
  std::optional<AtomicFile> file;
  if (!options.output.empty()) file.emplace(options.output);
  const std::string text = options.reduction ? reduction_document(scene, options.functions, format == "json")
                                             : document(symbolic::derive(scene, {}, {as_typed}), format);
  if (file) {
    file->write(text);
    file->commit();
  } else {
    print(text);
  }
  return 0;
}

}  // namespace

void add_derive(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, "derive", "Kane's equations of a scene, symbolically, block by block", footer, &derive);
  add_scene(*command, options->scene);
  command->add_option("--format", options->format, "how to print them (text)")
      ->option_text("text|latex|json")
      ->check(CLI::IsMember({"text", "latex", "json"}));
  command->add_flag("--json", options->json, "the same as --format json");
  command->add_flag("--reduction", options->reduction, "what was left out of the scene, and what that saves");
  add_functions(*command, options->functions);
  command->add_option("-o,--output", options->output, "into this file; - is standard output")->option_text("FILE");
}

}  // namespace kanec::cli
