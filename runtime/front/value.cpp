// SPDX-License-Identifier: GPL-2.0-or-later
#include "kanec/value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "runtime/base/text.hpp"

namespace kanec {
namespace {

std::string toml_string(std::string_view text) {
  std::string quoted = "\"";
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    if (c == '"' || c == '\\')
      quoted += std::string("\\") + c;
    else if (byte < 0x20 || byte == 0x7f)
      quoted += fmt::format("\\u{:04x}", byte);
    else
      quoted += c;
  }
  return quoted + "\"";
}

std::string toml_number(double value) {
  if (!std::isfinite(value)) return std::isnan(value) ? "nan" : value > 0 ? "inf" : "-inf";
  const std::string text = shortest(value);
  return text.find_first_of(".e") == text.npos ? text + ".0" : text;
}

// On one line.
struct Inline {
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(std::int64_t value) const { return std::to_string(value); }
  std::string operator()(double value) const { return toml_number(value); }
  std::string operator()(const std::string& value) const { return toml_string(value); }
  std::string operator()(const List& list) const {
    std::string text;
    for (const Value& value : list) text += (text.empty() ? "" : ", ") + std::visit(*this, value.kind());
    return "[" + text + "]";
  }
  std::string operator()(const Table& table) const {
    std::string text;
    for (const auto& [key, value] : table)
      text += (text.empty() ? "" : ", ") + toml_string(key) + " = " + std::visit(*this, value.kind());
    return "{" + text + "}";
  }
};

bool is_table(const Value& value) { return std::holds_alternative<Table>(value.kind()); }

bool is_list_of_tables(const Value& value) {
  const auto* list = std::get_if<List>(&value.kind());
  return list != nullptr && !list->empty() && std::all_of(list->begin(), list->end(), is_table);
}

std::string lines_of(const Table& table) {
  std::string text;
  for (const auto& [key, value] : table) text += toml_string(key) + " = " + std::visit(Inline{}, value.kind()) + "\n";
  return text;
}

}  // namespace

std::string toml_text(const Table& table) {
  Table plain;
  std::string tables;
  for (const auto& [key, value] : table) {
    if (is_table(value))
      tables += "[" + toml_string(key) + "]\n" + lines_of(std::get<Table>(value.kind()));
    else if (is_list_of_tables(value))
      for (const Value& one : std::get<List>(value.kind()))
        tables += "[[" + toml_string(key) + "]]\n" + lines_of(std::get<Table>(one.kind()));
    else
      plain.emplace_back(key, value);
  }
  return lines_of(plain) + tables;
}

}  // namespace kanec
