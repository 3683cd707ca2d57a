// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/ensemble/scenarios.hpp"

#include <algorithm>

#include "generator/read/read_ensemble.hpp"
#include "generator/scene/entry_names.hpp"
#include "generator/scene/place.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/model/evaluate.hpp"
#include "runtime/model/settings.hpp"
#include "runtime/model/sound_parameters.hpp"
#include "runtime/model/unit_norm.hpp"
#include "runtime/text/csv.hpp"
#include "runtime/verify/paths.hpp"

namespace kanec {
namespace {

[[noreturn]] void refuse(const std::string& place, const std::string& found, const std::string& allowed) {
  throw InputError(place + ": found " + found + "; allowed: " + allowed);
}

std::vector<std::string> header(std::string_view line, const std::string& place, const scene::Scene& scene) {
  const scene::EntryNames entries(scene);
  const std::vector<std::string> known = scene::scenario_names(scene);
  std::vector<std::string> names;
  for (const std::string_view cell : csv_cells(line)) {
    const std::string given(without_unit(cell)), name = scene::scenario_name(entries, given);
    const std::string column = place + ": column " + std::to_string(names.size() + 1);
    if (name.empty())
      refuse(column, scene::in_quotes(given),
             "a coordinate, speed, parameter or input of " + scene.name + ": " + scene::one_of(known, given));
    if (std::find(names.begin(), names.end(), name) != names.end())
      refuse(column, scene::in_quotes(given) + " twice", "each name once");
    names.push_back(name);
  }
  return names;
}

double number(std::string_view cell, const std::string& place, const std::string& name) {
  const std::optional<double> value = csv_number(cell);
  if (!value) refuse(place + ": " + name, cell.empty() ? "nothing" : scene::in_quotes(cell), "a finite number");
  return *value;
}

void append_row(ScenarioTable& table, std::string_view line, int number_of_line) {
  const std::string place = table.origin + ":" + std::to_string(number_of_line);
  const std::vector<std::string_view> row = csv_cells(line);
  if (row.size() != table.names.size())
    refuse(place, std::to_string(row.size()) + " numbers",
           std::to_string(table.names.size()) + ", one a column of the header");
  for (std::size_t i = 0; i < row.size(); ++i) table.values.push_back(number(row[i], place, table.names[i]));
  table.lines.push_back(number_of_line);
}

}  // namespace

std::string ScenarioTable::place(std::size_t i) const {
  return lines.empty() ? origin + ": scenario " + std::to_string(i + 1) : origin + ":" + std::to_string(lines[i]);
}

ScenarioTable read_scenarios(std::string_view text, const std::string& file, const scene::Scene& scene) {
  ScenarioTable table{file, {}, {}, {}};
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);  // a byte order mark
  int n = 0;
  for (std::size_t begin = 0; begin < text.size(); ++n) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::string_view line = trimmed(text.substr(begin, end - begin));
    begin = end + 1;
    if (!is_csv_row(line)) continue;
    if (table.names.empty())
      table.names = header(line, file + ":" + std::to_string(n + 1), scene);
    else
      append_row(table, line, n + 1);
    if (table.lines.size() > static_cast<std::size_t>(scene::most_scenarios))
      refuse(file, "more scenarios", "at most " + std::to_string(scene::most_scenarios));
  }
  if (table.lines.empty())
    refuse(file, table.names.empty() ? "nothing" : "a header alone", "a header line of names and a line a scenario");
  return table;
}

std::string csv_text(const ScenarioTable& table) {
  std::string text;
  for (const std::string& name : table.names) text += (text.empty() ? "" : ",") + name;
  text += '\n';
  for (std::size_t i = 0; i < table.rows(); ++i) {
    const std::span<const double> row = table.row(i);
    for (std::size_t k = 0; k < row.size(); ++k) text += (k == 0 ? "" : ",") + shortest(row[k]);
    text += '\n';
  }
  return text;
}

Scenarios::Scenarios(const scene::Scene& scene, const ScenarioTable& table)
    : scene_(scene), table_(table), layout_(scene), x_(initial_coordinates(scene)), y_(initial_speeds(scene)) {
  for (const std::string& name : table.names) columns_.push_back(column_of(name));
  for (std::size_t row = 0; row < table.rows(); ++row) {
    if (has(Part::parameter)) check_parameters(row);
    std::vector<double> x = with(Part::x, x_, row);
    normalised_ += normalise(x, row);
  }
}

Scenarios::Column Scenarios::column_of(const std::string& name) const {
  const std::vector<std::string> all = scene::scenario_names(scene_);
  auto at = static_cast<std::size_t>(std::find(all.begin(), all.end(), name) - all.begin());
  const std::size_t sizes[] = {x_.size(), y_.size(), scene_.parameters.size(), scene_.inputs.size()};
  for (const Part part : {Part::x, Part::y, Part::parameter, Part::input}) {
    const std::size_t size = sizes[static_cast<std::size_t>(part)];
    if (at < size) return {part, at};
    at -= size;
  }
  throw InternalError("a scenario's column without a place: " + name);
}

bool Scenarios::has(Part part) const {
  return std::any_of(columns_.begin(), columns_.end(), [part](const Column& column) { return column.part == part; });
}

std::vector<double> Scenarios::with(Part part, std::vector<double> values, std::size_t row) const {
  const std::span<const double> given = table_.row(row);
  for (std::size_t i = 0; i < given.size(); ++i)
    if (columns_[i].part == part) values[columns_[i].index] = given[i];
  return values;
}

void Scenarios::check_parameters(std::size_t row) const {
  const std::vector<double> values = with(Part::parameter, default_parameters(scene_), row);
  if (surely_sound(scene_, values)) return;
  scene::Scene changed = scene_;
  for (std::size_t i = 0; i < values.size(); ++i) changed.parameters[i].value = values[i];
  check_defaults(changed, table_.place(row));
}

// Whether any attitude was far from unit norm.
bool Scenarios::normalise(std::vector<double>& x, std::size_t row) const {
  const UnitNorm norm = to_unit_norm(layout_, x);
  if (norm.zero > 0)
    refuse(table_.place(row) + ": eps_" + scene::body_words(scene_)[static_cast<std::size_t>(norm.zero - 1)], "norm 0",
           "Euler parameters, of which one is not zero");
  return !norm.off.empty();
}

Scenario Scenarios::at(std::size_t row, const kanec_model& model) const {
  Scenario scenario{with(Part::x, x_, row), with(Part::y, y_, row), {}, {}};
  normalise(scenario.x, row);
  scenario.parameters = read_parameters(model, scene_, with(Part::parameter, default_parameters(scene_), row));
  scenario.inputs = read_inputs(model, scene_, with(Part::input, default_inputs(scene_), row));
  return scenario;
}

}  // namespace kanec
