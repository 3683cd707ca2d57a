// JSON with its keys in order, as text that reads back exactly. Not: what stands in it.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>

namespace kanec {

// Objects keep the order in which they were filled.
using Json = nlohmann::ordered_json;

// Indented, lists of plain values on one line each, a line feed at the end, always UTF-8. Numbers read back exactly;
// what is not finite is null.
std::string json_text(const Json& json);

// In four digits.
std::string brief(double value);

}  // namespace kanec
