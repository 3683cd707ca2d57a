// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/equations.hpp"

#include <utility>
#include <vector>

#include "generator/scene/place.hpp"
#include "generator/symbolic/derive.hpp"
#include "generator/tables/grids.hpp"
#include "generator/tables/tables.hpp"
#include "runtime/base/error.hpp"
#include "runtime/text/json.hpp"

namespace kanec {
namespace {

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

// The tables of the source: origins where the scene has them.
constexpr symbolic::Reductions as_typed = {.place_origins = false, .regroup = false, .turn_axes = false};

}  // namespace

std::string equations_text(const scene::Scene& scene, const std::string& format) {
  const std::vector<std::string> known = {"text", "latex", "json"};
  if (format != known[0] && format != known[1] && format != known[2])
    throw InputError("format: found " + scene::in_quotes(format) + "; allowed: " + scene::one_of(known, format));
  const symbolic::Equations equations = symbolic::derive(scene, {}, {as_typed});
  if (format == "json") return json_text(tables_json(equations));
  return format == "latex" ? emit::latex_document(equations) : emit::text_document(equations);
}

}  // namespace kanec
