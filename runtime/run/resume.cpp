// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/run/resume.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "generator/scene/place.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/split.hpp"
#include "runtime/run/watched_events.hpp"
#include "runtime/trajectory/trajectory.hpp"

namespace kanec {
namespace {

[[noreturn]] void refuse(const std::string& file, std::size_t line, const std::string& found,
                         const std::string& allowed) {
  throw InputError(file + ":" + std::to_string(line) + ": found " + found + "; allowed: " + allowed);
}

std::optional<std::vector<double>> numbers_of(std::string_view line) {
  std::vector<double> numbers;
  for (const char *at = line.data(), *end = at + line.size();; ++at) {
    double value = 0.0;
    const auto [next, error] = std::from_chars(at, end, value);
    if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
    numbers.push_back(value);
    at = next;
    if (at == end) return numbers;
    if (*at != ',') return std::nullopt;
  }
}

// The lines that end with a line feed, without it and a carriage return before it.
std::vector<std::string_view> full_lines(std::string_view text) {
  std::vector<std::string_view> lines;
  for (std::size_t begin = 0, end; (end = text.find('\n', begin)) != std::string_view::npos; begin = end + 1) {
    lines.push_back(text.substr(begin, end - begin));
    if (lines.back().ends_with('\r')) lines.back().remove_suffix(1);
  }
  return lines;
}

// By the first column that is called neither by its body nor by the body's number.
void check_header(std::string_view found, const StateNames& names, const StateNames& numbered, const std::string& file,
                  const std::string& model) {
  const std::string by_body = csv_header(names, true), by_number = csv_header(numbered, true);
  const std::vector<std::string_view> there = split(found, ','), wanted = split(by_body, ','),
                                      other = split(by_number, ',');
  const std::string trajectory = " of a trajectory of " + model;
  for (std::size_t i = 0; i < std::max(there.size(), wanted.size()); ++i) {
    const std::string column = "column " + std::to_string(i + 1);
    if (i == there.size()) refuse(file, 1, "no " + column, scene::in_quotes(wanted[i]) + trajectory);
    if (i == wanted.size())
      refuse(file, 1, scene::in_quotes(there[i]) + " in " + column, std::to_string(i) + " columns" + trajectory);
    if (there[i] != wanted[i] && there[i] != other[i])
      refuse(file, 1, scene::in_quotes(there[i]) + " in " + column, scene::in_quotes(wanted[i]) + trajectory);
  }
}

Resumed of_row(const std::vector<double>& row, const scene::Scene& scene, const StateNames& names) {
  Resumed resumed{initial_state(scene), 0.0, {}};
  auto next = row.begin();
  resumed.state.t = *next++;
  for (double& value : resumed.state.x) value = *next++;
  for (double& value : resumed.state.y) value = *next++;
  next += 2;  // energies
  resumed.work = *next++;
  for (const int input : names.input_indices) resumed.state.inputs[static_cast<std::size_t>(input)] = *next++;
  return resumed;
}

}  // namespace

Resumed read_trajectory(std::string_view text, const std::string& file, const scene::Scene& scene) {
  const StateNames names = trajectory_names(scene);
  StateNames numbered = names;
  numbered.coordinates = coordinate_names(scene);
  numbered.speeds = speed_names(scene);
  const std::vector<std::string_view> lines = full_lines(text);
  if (lines.empty()) refuse(file, 1, "no full line", "the header of a trajectory of " + scene.name);
  check_header(lines[0], names, numbered, file, scene.name);
  if (lines.size() < 2) refuse(file, 2, "no full row", "at least one");
  std::vector<double> row;
  for (std::size_t i = 1; i < lines.size(); ++i) {
    auto numbers = numbers_of(lines[i]);
    if (!numbers || numbers->size() != 1 + names.coordinates.size() + names.speeds.size() + 3 + names.inputs.size())
      refuse(file, i + 1, scene::in_quotes(lines[i]), "a finite number a column");
    if (i > 1 && !(numbers->front() > row.front()))
      refuse(file, i + 1, "a time not after the row before", "rows in time");
    row = std::move(*numbers);
  }
  Resumed resumed = of_row(row, scene, names);
  for (std::size_t i = 1; i + 1 < lines.size(); ++i) resumed.rows.append(lines[i]).append("\n");
  return resumed;
}

}  // namespace kanec
