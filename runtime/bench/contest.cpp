// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/contest.hpp"

#include <algorithm>

#include "runtime/base/error.hpp"
#include "runtime/bench/entrants.hpp"

namespace kanec {

const Entry& Contest::first(const std::string& function) const {
  const auto same = [&](const Entry& entry) { return entry.function == function; };
  const auto found = std::find_if(entries.begin(), entries.end(), same);
  if (found == entries.end()) throw InternalError("no entry of " + function);
  return *found;
}

std::vector<Contest> contests(const std::vector<scene::Scene>& scenes, const ContestOptions& options) {
  std::deque<Entrants> entrants;
  std::vector<Loop> loops;
  for (const scene::Scene& scene : scenes) {
    const Entrants& made = entrants.emplace_back(scene, options);
    loops.insert(loops.end(), made.loops.begin(), made.loops.end());
  }
  const std::vector<Time> times = timed(loops, options.min_time);
  auto time = times.begin();
  std::vector<Contest> list;
  for (Entrants& one : entrants) {
    for (const std::size_t entry : one.loop_of) one.contest.entries[entry].time = *time++;
    list.push_back(std::move(one.contest));
  }
  return list;
}

}  // namespace kanec
