// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/text/csv.hpp"

#include <charconv>
#include <cmath>

#include "runtime/base/split.hpp"

namespace kanec {

std::string_view trimmed(std::string_view text) {
  const auto blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && blank(text.back())) text.remove_suffix(1);
  return text;
}

std::vector<std::string_view> csv_cells(std::string_view line) {
  std::vector<std::string_view> list = split(line, ',');
  for (std::string_view& cell : list) cell = trimmed(cell);
  return list;
}

std::string_view without_unit(std::string_view cell) {
  const std::size_t bracket = cell.find('[');
  return bracket != cell.npos && cell.back() == ']' ? trimmed(cell.substr(0, bracket)) : cell;
}

std::optional<double> csv_number(std::string_view cell) {
  double value = 0.0;
  const std::string_view digits = cell.starts_with('+') ? cell.substr(1) : cell;
  const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
  if (error != std::errc() || end != digits.data() + digits.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

bool is_csv_row(std::string_view trimmed_line) { return !trimmed_line.empty() && trimmed_line.front() != '#'; }

}  // namespace kanec
