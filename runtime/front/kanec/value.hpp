// A scene built in code: the tables of a scene.toml as values. Not: which keys there are (models/README.md).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "kanec/export.hpp"

namespace kanec {

class Value;

// Keys in their order.
using Table = std::vector<std::pair<std::string, Value>>;
using List = std::vector<Value>;

class KANEC_API Value {
 public:
  Value(bool value) : value_(value) {}                      // NOLINT: all of these are Values
  Value(int value) : value_(std::int64_t{value}) {}         // NOLINT
  Value(std::int64_t value) : value_(value) {}              // NOLINT
  Value(double value) : value_(value) {}                    // NOLINT
  Value(const char* value) : value_(std::string(value)) {}  // NOLINT
  Value(std::string value) : value_(std::move(value)) {}    // NOLINT
  Value(List value) : value_(std::move(value)) {}           // NOLINT
  Value(Table value) : value_(std::move(value)) {}          // NOLINT
  Value(const std::vector<double>& values) : value_(List(values.begin(), values.end())) {}  // NOLINT

  using Kind = std::variant<bool, std::int64_t, double, std::string, List, Table>;
  const Kind& kind() const { return value_; }

 private:
  Kind value_;
};

// As a TOML file has it, which reads back as the same numbers and texts.
KANEC_API std::string toml_text(const Table& table);

}  // namespace kanec
