// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/run/watched_events.hpp"

#include <algorithm>

#include "generator/scene/component.hpp"
#include "generator/scene/entry_names.hpp"
#include "runtime/base/text.hpp"

namespace kanec {

using integrate::Event;
using integrate::Happening;

namespace {

Event::Direction direction_of(const scene::Event& event) {
  switch (event.direction) {
    case scene::Event::Direction::up:
      return Event::Direction::up;
    case scene::Event::Direction::down:
      return Event::Direction::down;
    case scene::Event::Direction::both:
      break;
  }
  return Event::Direction::both;
}

}  // namespace

std::vector<Event> watched_events(const scene::Scene& scene) {
  std::vector<Event> list;
  for (const scene::Event& from : scene.events) {
    Event event;
    event.name = from.name;
    event.direction = direction_of(from);
    event.stops = from.action == scene::Event::Action::stop;
    event.has_row = from.row;
    for (const scene::Event::Setting& setting : from.settings) event.settings.push_back({setting.input, setting.value});
    list.push_back(std::move(event));
  }
  return list;
}

StateNames state_names(const scene::Scene& scene) {
  StateNames names{in_words(scene, coordinate_names(scene)), in_words(scene, speed_names(scene))};
  names.bodies = body_words(scene);
  return names;
}

StateNames trajectory_names(const scene::Scene& scene) {
  StateNames names = state_names(scene);
  for (int i = 0; i < static_cast<int>(scene.inputs.size()); ++i) {
    const bool is_set = std::any_of(scene.events.begin(), scene.events.end(), [i](const scene::Event& event) {
      return std::any_of(event.settings.begin(), event.settings.end(), [i](const auto& s) { return s.input == i; });
    });
    if (!is_set) continue;
    names.inputs.push_back(scene.inputs[static_cast<std::size_t>(i)].name);
    names.input_indices.push_back(i);
  }
  return names;
}

std::vector<std::string> event_lines(const Summary& summary, const std::vector<Event>& watched, std::size_t most) {
  std::vector<std::string> lines;
  if (watched.empty()) return lines;
  for (const Happening& happening : summary.events) {
    if (lines.size() == most) {
      lines.push_back("and " + std::to_string(summary.events.size() - most) + " more");
      return lines;
    }
    const Event& event = watched[static_cast<std::size_t>(happening.event)];
    lines.push_back(shortest(happening.t) + " s: " + event.name + (happening.up ? ", up" : ", down") +
                    (event.stops ? ", end of the run" : "") + (event.settings.empty() ? "" : ", inputs set"));
  }
  if (lines.empty()) lines.push_back("none of " + std::to_string(watched.size()) + " watched for");
  return lines;
}

Json events_json(const Summary& summary, const std::vector<Event>& watched) {
  Json list = Json::array();
  for (const Happening& happening : summary.events)
    list.push_back({{"t", happening.t},
                    {"name", watched[static_cast<std::size_t>(happening.event)].name},
                    {"direction", happening.up ? "up" : "down"}});
  return list;
}

}  // namespace kanec
