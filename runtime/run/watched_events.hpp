// The events of a scene as a run watches for them, and as the summary tells of them. Not: their search.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/text/json.hpp"
#include "runtime/trajectory/simulate.hpp"
#include "runtime/trajectory/state_names.hpp"

namespace kanec {

std::vector<integrate::Event> watched_events(const scene::Scene& scene);

// Coordinates and speeds as they are printed.
StateNames state_names(const scene::Scene& scene);
// With the inputs that events set: the columns of a trajectory.
StateNames trajectory_names(const scene::Scene& scene);

// One line an event that happened, at most `most`, then how many more; empty where none was watched for.
std::vector<std::string> event_lines(const Summary& summary, const std::vector<integrate::Event>& watched,
                                     std::size_t most);
Json events_json(const Summary& summary, const std::vector<integrate::Event>& watched);

}  // namespace kanec
