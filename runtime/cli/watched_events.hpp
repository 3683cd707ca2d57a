// The events of a scene as a run watches for them, and as the summary tells of them. Not: their search.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/cli/output.hpp"
#include "runtime/integrate/simulate.hpp"
#include "runtime/integrate/state_names.hpp"

namespace kanec::cli {

std::vector<integrate::Event> watched_events(const scene::Scene& scene);

// Coordinates, speeds, and the inputs that events set: the columns of a trajectory.
integrate::StateNames trajectory_names(const scene::Scene& scene);

// One line an event that happened, at most `most`, then how many more; empty where none was watched for.
std::vector<std::string> event_lines(const integrate::Summary& summary, const std::vector<integrate::Event>& watched,
                                     std::size_t most);
Json events_json(const integrate::Summary& summary, const std::vector<integrate::Event>& watched);

}  // namespace kanec::cli
