// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/connection.hpp"

#include <algorithm>
#include <charconv>
#include <string>
#include <string_view>

#include "generator/read/read.hpp"
#include "runtime/base/split.hpp"

namespace kanec::scene {
namespace {

constexpr auto meaning = "0 (the inertial frame) or the number of a lower body";

std::string numbers(std::size_t k) {
  return k == 1 ? "0, the inertial frame" : "a whole number from 0 (the inertial frame) to " + std::to_string(k - 1);
}

void check_entry(int lower, std::size_t k, const Place& place) {
  const std::string body = "body " + std::to_string(k);
  const auto own = static_cast<int>(k);
  if (lower == own) fail(place, std::to_string(lower) + ", so that " + body + " stands on itself", numbers(k));
  if (lower > own) fail(place, std::to_string(lower) + ", a forward reference from " + body, numbers(k));
}

// Where entry k of a command line's array stands.
Place on_command_line(std::size_t k) {
  Place place{"--connection"};
  if (k > 0) place.field = "number " + std::to_string(k);
  return place;
}

std::string_view trimmed(std::string_view text) {
  const auto begin = text.find_first_not_of(" \t");
  if (begin == std::string_view::npos) return {};
  return text.substr(begin, text.find_last_not_of(" \t") - begin + 1);
}

int parse_entry(std::string_view text, std::size_t k) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty()) fail(on_command_line(k), "nothing", numbers(k));
  if (error != std::errc() || end != text.data() + text.size()) fail(on_command_line(k), in_quotes(text), numbers(k));
  return value;
}

}  // namespace

void check_connection(const std::vector<int>& lower, const std::function<Place(std::size_t k)>& place_of) {
  if (lower.empty()) fail(place_of(0), "no bodies", "1 to " + std::to_string(most_bodies) + " numbers, one a body");
  if (lower.size() > most_bodies)
    fail(place_of(0), std::to_string(lower.size()) + " bodies", "1 to " + std::to_string(most_bodies));
  for (std::size_t k = 1; k <= lower.size(); ++k)
    if (lower[k - 1] < 0) fail(place_of(k), std::to_string(lower[k - 1]), meaning);
  if (std::find(lower.begin(), lower.end(), 0) == lower.end())
    fail(place_of(0), "no body on the inertial frame", "an array that begins with 0, the inertial frame");
  for (std::size_t k = 1; k <= lower.size(); ++k) check_entry(lower[k - 1], k, place_of(k));
}

std::vector<int> parse_connection(std::string_view text) {
  if (trimmed(text).empty()) check_connection({}, on_command_line);
  std::vector<int> lower;
  for (const std::string_view part : split(text, ',')) lower.push_back(parse_entry(trimmed(part), lower.size() + 1));
  check_connection(lower, on_command_line);
  return lower;
}

}  // namespace kanec::scene
