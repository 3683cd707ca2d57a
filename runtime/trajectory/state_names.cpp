// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/trajectory/state_names.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <utility>

#include "runtime/base/error.hpp"

namespace kanec {

namespace {

struct Known {
  std::string_view letter, unit;
};

// by Kind
constexpr std::array<Known, 6> known = {
    {{"eps", ""}, {"theta", "rad"}, {"s", "m"}, {"omega", "rad/s"}, {"thetadot", "rad/s"}, {"sdot", "m/s"}}};

[[noreturn]] void refuse(std::string_view name) {
  throw InternalError("'" + std::string(name) + "' is no component of a state");
}

// All of it is one, from 1.
std::optional<int> number(std::string_view text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || value < 1 || end != text.data() + text.size()) return std::nullopt;
  return value;
}

// From 1; a number where bodies have no words.
std::optional<int> body_of(std::string_view word, const std::vector<std::string>& bodies) {
  if (bodies.empty()) return number(word);
  const auto found = std::find(bodies.begin(), bodies.end(), word);
  if (found == bodies.end()) return std::nullopt;
  return static_cast<int>(found - bodies.begin()) + 1;
}

// The letter of a name, and what is behind its '_'.
std::pair<Kind, std::string_view> split_name(std::string_view name) {
  const std::size_t at = std::min(name.find('_'), name.size());
  for (std::size_t kind = 0; kind < known.size(); ++kind)
    if (at < name.size() && name.substr(0, at) == known[kind].letter)
      return {static_cast<Kind>(kind), name.substr(at + 1)};
  refuse(name);
}

}  // namespace

Component component_of(std::string_view name, const std::vector<std::string>& bodies) {
  const auto [kind, rest] = split_name(name);
  if (const auto body = body_of(rest, bodies)) return {kind, *body, 1};
  const std::size_t at = rest.rfind('_');
  if (at == rest.npos) refuse(name);
  const auto body = body_of(rest.substr(0, at), bodies), component = number(rest.substr(at + 1));
  if (!body || !component) refuse(name);
  return {kind, *body, *component};
}

std::string_view unit_of(std::string_view name) { return known[static_cast<std::size_t>(split_name(name).first)].unit; }

}  // namespace kanec
