// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/picture/panels.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>

namespace kanec {
namespace {

constexpr std::size_t most_names = 12;

struct Heading {
  const char *title, *axis;
};

// by Kind
constexpr std::array<Heading, 6> headings = {{{"Euler parameters", "ε [-]"},
                                              {"angles", "θ [rad]"},
                                              {"translations", "s [m]"},
                                              {"angular velocities", "ω [rad/s]"},
                                              {"angular rates", "dθ/dt [rad/s]"},
                                              {"translation rates", "ds/dt [m/s]"}}};

void add(std::array<Panel, 6>& by_kind, const StateNames& names, const std::string& name, std::size_t entry) {
  const Component component = component_of(name, names.bodies);
  const std::string body = names.bodies.empty() ? std::to_string(component.body)
                                                : names.bodies[static_cast<std::size_t>(component.body - 1)];
  Panel& panel = by_kind[static_cast<std::size_t>(component.kind)];
  panel.curves.push_back({entry, component.body, component.component, name, "body " + body});
  if (panel.bodies.empty() || panel.bodies.back() != component.body) panel.bodies.push_back(component.body);
}

// Well-separated colours up to twelve, then from blue (first) over green to red (last).
std::string colour(std::size_t index, std::size_t count) {
  constexpr std::array<const char*, most_names> distinct = {"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e",
                                                            "#9467bd", "#8c564b", "#17becf", "#e377c2",
                                                            "#7f7f7f", "#bcbd22", "#003f5c", "#000000"};
  if (count <= distinct.size()) return distinct[index];
  const double hue = 4.0 * (1.0 - static_cast<double>(index) / static_cast<double>(count - 1));  // 4 = blue, 0 = red
  const auto channel = [hue](double centre) {
    double distance = std::fabs(hue - centre);
    distance = std::min(distance, 6.0 - distance);
    return static_cast<unsigned>(std::lround(220.0 * std::clamp(2.0 - distance, 0.0, 1.0)));
  };
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", channel(0.0), channel(2.0), channel(4.0));
  return text.data();
}

std::size_t index_of_body(const Panel& panel, int body) {
  return static_cast<std::size_t>(std::find(panel.bodies.begin(), panel.bodies.end(), body) - panel.bodies.begin());
}

bool is_first_of_its_body(const Panel& panel, const Curve& curve) {
  const auto first = std::find_if(panel.curves.begin(), panel.curves.end(),
                                  [&](const Curve& other) { return other.body == curve.body; });
  return first->entry == curve.entry;
}

}  // namespace

std::vector<Panel> panels(const StateNames& names) {
  std::array<Panel, 6> by_kind;
  for (std::size_t kind = 0; kind < by_kind.size(); ++kind)
    by_kind[kind] = {headings[kind].title, headings[kind].axis, {}, {}};
  for (std::size_t i = 0; i < names.coordinates.size(); ++i) add(by_kind, names, names.coordinates[i], i);
  for (std::size_t i = 0; i < names.speeds.size(); ++i)
    add(by_kind, names, names.speeds[i], names.coordinates.size() + i);
  std::vector<Panel> result;
  for (std::size_t kind = 0; kind < 3; ++kind)
    if (!by_kind[kind].curves.empty()) result.insert(result.end(), {by_kind[kind], by_kind[kind + 3]});
  return result;
}

std::string look(const Panel& panel, const Curve& curve) {
  const bool single = panel.bodies.size() == 1;
  const auto component = static_cast<std::size_t>(curve.component - 1);
  const std::string hue = single ? colour(component, 4) : colour(index_of_body(panel, curve.body), panel.bodies.size());
  return std::string("lw ") + (panel.bodies.size() > most_names ? "0.6" : "1.4") + " lc rgb '" + hue + "' dt " +
         std::to_string(single ? 1 : curve.component);
}

std::string legend(const Panel& panel, const Curve& curve) {
  if (panel.curves.size() <= most_names) return curve.name;
  const bool named = panel.bodies.size() <= most_names && is_first_of_its_body(panel, curve);
  return named ? curve.body_name : "";
}

std::string legend_note(const Panel& panel) {
  if (panel.curves.size() <= most_names) return "";
  int dashes = 1;
  for (const Curve& curve : panel.curves) dashes = std::max(dashes, curve.component);
  std::string note = std::array{"", "1 solid, 2 dashed", "1 solid, 2 dashed, 3 dotted",
                                "1 solid, 2 dashed, 3 dotted, 4 dash-dotted"}[static_cast<std::size_t>(dashes - 1)];
  if (panel.bodies.size() > most_names)
    note += std::string(note.empty() ? "" : "; ") + panel.curves.front().body_name + " blue … " +
            panel.curves.back().body_name.substr(std::string_view("body ").size()) + " red";
  return note.empty() ? "" : " (" + note + ")";
}

}  // namespace kanec
