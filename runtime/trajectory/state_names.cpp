// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/trajectory/state_names.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "runtime/base/error.hpp"

namespace kanec {

namespace {

struct Known {
  std::string_view letter, unit;
};

// by Kind
constexpr std::array<Known, 6> known = {
    {{"eps", ""}, {"theta", "rad"}, {"s", "m"}, {"omega", "rad/s"}, {"thetadot", "rad/s"}, {"sdot", "m/s"}}};

std::vector<std::string> list(const char* const* names, int count) { return {names, names + count}; }

[[noreturn]] void refuse(std::string_view name) {
  throw InternalError("'" + std::string(name) + "' is no component of a state");
}

// The number behind the next '_', taken off the text.
int number(std::string_view& text, std::string_view name) {
  int value = 0;
  if (text.empty() || text.front() != '_') refuse(name);
  text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || value < 1) refuse(name);
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

}  // namespace

StateNames state_names(const kanec_model& model) {
  return {list(model.coordinate_names, model.nx), list(model.speed_names, model.ny)};
}

Component component_of(std::string_view name) {
  std::string_view rest = name.substr(std::min(name.find('_'), name.size()));
  const std::string_view letter = name.substr(0, name.size() - rest.size());
  for (std::size_t kind = 0; kind < known.size(); ++kind) {
    if (letter != known[kind].letter) continue;
    Component component{static_cast<Kind>(kind), number(rest, name), 1};
    if (!rest.empty()) component.component = number(rest, name);
    if (!rest.empty()) refuse(name);
    return component;
  }
  refuse(name);
}

std::string_view unit_of(Kind kind) { return known[static_cast<std::size_t>(kind)].unit; }

}  // namespace kanec
