// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/text/json.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "runtime/base/fit.hpp"

namespace kanec {
namespace {

// Of what is no UTF-8, as names of files need not be, U+FFFD.
std::string dumped(const Json& json) { return fit::json(json.dump(-1, ' ', false, Json::error_handler_t::replace)); }

bool is_plain(const Json& json) {
  return std::none_of(json.begin(), json.end(), [](const Json& part) { return part.is_structured(); });
}

std::string flat(const Json& list) {
  std::string text;
  for (const Json& part : list) text += (text.empty() ? "" : ", ") + dumped(part);
  return "[" + text + "]";
}

std::string indented(const Json& json, const std::string& margin) {
  if (!json.is_structured()) return dumped(json);
  if (json.empty()) return json.is_object() ? "{}" : "[]";
  if (json.is_array() && is_plain(json)) return flat(json);
  const std::string inner = margin + "  ";
  std::string text;
  for (const auto& [key, part] : json.items()) {
    text += (text.empty() ? "\n" : ",\n") + inner;
    if (json.is_object()) text += dumped(Json(key)) + ": ";
    text += indented(part, inner);
  }
  return (json.is_object() ? "{" : "[") + text + "\n" + margin + (json.is_object() ? "}" : "]");
}

}  // namespace

std::string json_text(const Json& json) { return indented(json, "") + "\n"; }

std::string brief(double value) { return fmt::format("{:.4g}", value); }

}  // namespace kanec
