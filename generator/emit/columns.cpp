// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/columns.hpp"

#include <algorithm>

namespace kanec::emit {

Columns::Key Columns::key_of(const std::string& array, const Places& places) {
  Places distances;
  for (const program::Index place : places) distances.push_back(place - places[0]);
  return {array, std::move(distances)};
}

void Columns::add(const std::string& array, const Places& places) {
  const auto [entry, is_new] = lowest_.emplace(key_of(array, places), places[0]);
  if (!is_new) entry->second = std::min(entry->second, places[0]);
}

std::string Columns::index(const std::string& array, const Places& places) {
  if (std::equal(places.begin() + 1, places.end(), places.begin())) return std::to_string(places[0]);
  const Key key = key_of(array, places);
  const program::Index lowest = lowest_.at(key);
  const auto [entry, is_new] = names_.emplace(key, "");
  if (is_new) {
    const int count = ++counts_[array];
    entry->second = array + "_at" + (count > 1 ? std::to_string(count) : "");
    Places column;
    for (const program::Index distance : key.second) column.push_back(lowest + distance);
    columns_.push_back({entry->second, std::move(column)});
  }
  const program::Index above = places[0] - lowest;
  return entry->second + (above == 0 ? "" : " + " + std::to_string(above));
}

}  // namespace kanec::emit
