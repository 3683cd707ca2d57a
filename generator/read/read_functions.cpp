// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/read_functions.hpp"

#include <algorithm>
#include <optional>
#include <string_view>

namespace kanec::scene {
namespace {

constexpr auto rule = "the name of a function, as \"accelerations\", or several joined by +";
constexpr std::size_t most_functions = 1000;

// Each part by itself: point names make function names longer than other names may be.
bool is_function(std::string_view text) {
  for (std::size_t begin = 0;;) {
    const std::size_t plus = std::min(text.find('+', begin), text.size());
    const std::string_view part = text.substr(begin, plus - begin);
    const auto allowed = [](char c) {
      return c == '_' || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
    };
    if (part.empty() || !std::all_of(part.begin(), part.end(), allowed) || (part[0] >= '0' && part[0] <= '9'))
      return false;
    if (plus == text.size()) return true;
    begin = plus + 1;
  }
}

}  // namespace

AskedFunctions read_functions(const Table& root) {
  const std::optional<Node> node = root.find("functions");
  if (!node) return {};
  AskedFunctions asked;
  const std::vector<Node> list = node->list("a list of names of functions");
  if (list.empty() || list.size() > most_functions)
    node->refuse("at least one name; without the key, the usual functions");
  for (const Node& entry : list) {
    const std::string name = entry.text(rule);
    if (!is_function(name)) entry.refuse(rule);
    if (std::find(asked.names.begin(), asked.names.end(), name) != asked.names.end())
      fail(entry.place(), in_quotes(name) + " twice", "each function once");
    asked.names.push_back(name);
    asked.places.push_back(entry.place());
  }
  return asked;
}

}  // namespace kanec::scene
