// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/layout.hpp"

#include <fmt/format.h>

#include "runtime/text/table.hpp"

namespace kanec {
namespace {

// Numbers in one line.
std::size_t width_of(const Block& block) {
  return block.shape.empty() ? 1 : static_cast<std::size_t>(block.shape.back());
}

Json json_of(std::span<const double> values) { return Json(std::vector<double>(values.begin(), values.end())); }

Json json_of(const Block& block, std::span<const double> values) {
  if (block.shape.empty()) return values[0];
  if (block.shape.size() == 1) return json_of(values);
  Json rows = Json::array();
  const std::size_t width = width_of(block);
  for (std::size_t i = 0; i < values.size(); i += width) rows.push_back(json_of(values.subspan(i, width)));
  return rows;
}

void add_row(std::vector<TextRow>& table, const std::string& name, std::span<const double> values) {
  table.push_back({name});
  for (const double value : values) table.back().push_back(fmt::format("{:.16e}", value));
}

void add_entries(std::vector<TextRow>& table, const Layout& layout, const Block& block,
                 std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t row = i / layout.columns.size(), column = i % layout.columns.size();
    if (values[i] == 0.0) continue;
    const std::string name = fmt::format("{}[{}, {}]", block.name, layout.rows[row], layout.columns[column]);
    add_row(table, name, values.subspan(i, 1));
  }
}

void add_block(std::vector<TextRow>& table, const Block& block, std::span<const double> values) {
  const std::size_t width = width_of(block);
  const std::string name = block.unit.empty() ? block.name : fmt::format("{} [{}]", block.name, block.unit);
  for (std::size_t i = 0; i < values.size(); i += width) add_row(table, i == 0 ? name : "", values.subspan(i, width));
}

}  // namespace

std::size_t Block::size() const {
  std::size_t product = 1;
  for (const int extent : shape) product *= static_cast<std::size_t>(extent);
  return product;
}

std::size_t Layout::size() const {
  std::size_t sum = 0;
  for (const Block& block : blocks) sum += block.size();
  return sum;
}

Json Layout::json(std::span<const double> values) const {
  Json object = Json::object();
  if (!rows.empty()) object["rows"] = rows;
  if (!columns.empty()) object["columns"] = columns;
  for (const Block& block : blocks) {
    object[block.name] = json_of(block, values.first(block.size()));
    values = values.subspan(block.size());
  }
  return object;
}

std::string Layout::text(std::span<const double> values) const {
  std::vector<TextRow> table;
  for (const Block& block : blocks) {
    if (columns.empty())
      add_block(table, block, values.first(block.size()));
    else
      add_entries(table, *this, block, values.first(block.size()));
    values = values.subspan(block.size());
  }
  return text_table(table);
}

}  // namespace kanec
