// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <utility>

#include "generator/tables/grids.hpp"
#include "generator/tables/tables.hpp"

namespace kanec::emit {
namespace {

// Columns side by side, two spaces apart; the last one is as long as it likes.
std::string side_by_side(const Grid& grid) {
  std::vector<std::vector<std::string>> lines = {{}};
  for (const Column& column : grid.columns) lines.front().push_back(column.head);
  for (std::vector<std::string>& line : without_repetition(grid)) lines.push_back(std::move(line));
  std::vector<std::size_t> widths(grid.columns.size());
  for (const auto& line : lines)
    for (std::size_t i = 0; i < line.size(); ++i) widths[i] = std::max(widths[i], line[i].size());
  std::string text;
  for (const auto& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < line.size(); ++i) {
      row += "  " + line[i];
      if (i + 1 < line.size()) row += std::string(widths[i] - line[i].size(), ' ');
    }
    text += row + "\n";
  }
  return text;
}

std::string text_of(const Grid& grid) {
  if (grid.lines.empty()) return "";
  return "\n" + grid.title + "\n" + (grid.note.empty() ? "" : "  " + grid.note + "\n") + side_by_side(grid);
}

}  // namespace

std::string text_document(const symbolic::Equations& equations) {
  std::string text = equations.scene.name + ": " + std::to_string(size(equations.scene)) +
                     (size(equations.scene) == 1 ? " body" : " bodies") +
                     "\na~ b = a x b; R_K takes inertial components to those in body K\n";
  text += text_of(body_grid(equations, symbolic::Style::text));
  for (const Table& table : tables(equations, symbolic::Style::text)) {
    text += "\n" + table.title + "\n";
    for (const auto& [left, right] : table.rows) text += "  " + left + " = " + right + "\n";
  }
  return text + text_of(load_grid(equations, symbolic::Style::text));
}

}  // namespace kanec::emit
