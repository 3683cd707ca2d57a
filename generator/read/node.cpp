// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/node.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "runtime/base/text.hpp"

namespace kanec::scene {
namespace {

// Products of a few such numbers are still finite.
constexpr double largest_value = 1e60;

// A key as it is shown: bare where TOML allows that, else in quotes.
std::string shown(std::string_view key) {
  const auto bare = [](unsigned char c) { return std::isalnum(c) || c == '_' || c == '-'; };
  const bool plain = !key.empty() && key.size() <= 63 && std::all_of(key.begin(), key.end(), bare);
  return plain ? std::string(key) : in_quotes(key);
}

// As TOML tells a float from an integer: "1.0", not "1".
std::string as_float(double value) {
  const std::string text = shortest(value);
  return text.find_first_not_of("-0123456789") == std::string::npos ? text + ".0" : text;
}

}  // namespace

Node::Node(const toml::node& value, Place place) : value_(&value), place_(std::move(place)) {
  const auto line = static_cast<int>(value.source().begin.line);
  if (line > 0) place_.line = line;
}

std::string Node::found() const {
  if (const auto* text = value_->as_string()) return "the text " + in_quotes(text->get());
  if (const auto* integer = value_->as_integer()) return std::to_string(integer->get());
  if (const auto* real = value_->as_floating_point()) return as_float(real->get());
  if (const auto* truth = value_->as_boolean()) return truth->get() ? "true" : "false";
  if (const auto* list = value_->as_array())
    return list->empty() ? "an empty list" : "a list of " + std::to_string(list->size());
  return value_->is_table() ? "a table" : "a date or time";
}

double Node::real(const std::string& allowed) const {
  const auto* integer = value_->as_integer();
  const auto* real = value_->as_floating_point();
  if (!integer && !real) refuse(allowed);
  const double number = real ? real->get() : static_cast<double>(integer->get());
  if (!std::isfinite(number)) refuse(allowed);
  if (std::fabs(number) > largest_value) refuse(allowed + ", in magnitude at most " + shortest(largest_value));
  return number;
}

int Node::integer(const std::string& allowed) const {
  const auto* integer = value_->as_integer();
  if (!integer || !std::in_range<int>(integer->get())) refuse(allowed);
  return static_cast<int>(integer->get());
}

std::string Node::text(const std::string& allowed) const {
  const auto* text = value_->as_string();
  if (!text) refuse(allowed);
  return text->get();
}

std::vector<Node> Node::list(const std::string& allowed) const {
  const auto* array = value_->as_array();
  if (!array) refuse(allowed);
  std::vector<Node> out;
  for (const toml::node& value : *array) {
    Place place = place_;
    place.field.append("[").append(std::to_string(out.size() + 1)).append("]");
    out.emplace_back(value, std::move(place));
  }
  return out;
}

std::vector<Node> Node::list(std::size_t size, const std::string& allowed) const {
  std::vector<Node> out = list(allowed);
  if (out.size() != size) refuse(allowed);
  return out;
}

Table::Table(const Node& node, std::string prefix)
    : table_(node.value().as_table()), place_(node.place()), prefix_(std::move(prefix)) {
  if (!table_) node.refuse("a table");
}

Table::Table(const toml::table& table, Place place, std::string prefix)
    : table_(&table), place_(std::move(place)), prefix_(std::move(prefix)) {}

Node Table::node(const toml::key& key, const toml::node& value) const {
  Place place = place_;
  place.field = prefix_ + shown(key.str());
  place.line = static_cast<int>(key.source().begin.line);
  return {value, std::move(place)};
}

void Table::only(const std::vector<std::string>& known) const {
  for (const auto& [key, node] : entries())
    if (std::find(known.begin(), known.end(), key) == known.end())
      fail(node.place(), "an unknown key", one_of(known, key));
}

std::optional<Node> Table::find(const std::string& key) const {
  const auto found = table_->find(key);
  if (found == table_->end()) return std::nullopt;
  return node(found->first, found->second);
}

Node Table::at(const std::string& key, const std::string& allowed) const {
  const std::optional<Node> found = find(key);
  if (found) return *found;
  Place place = place_;
  place.field = prefix_ + key;
  fail(place, "no such key, and it is required", allowed);
}

std::vector<Table::Entry> Table::entries() const {
  std::vector<std::pair<toml::source_position, Entry>> ordered;
  for (const auto& [key, value] : *table_)
    ordered.push_back({key.source().begin, {std::string(key.str()), node(key, value)}});
  std::stable_sort(ordered.begin(), ordered.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<Entry> out;
  for (auto& [position, entry] : ordered) out.push_back(std::move(entry));
  return out;
}

}  // namespace kanec::scene
