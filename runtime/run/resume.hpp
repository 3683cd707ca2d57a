// A trajectory that a run goes on from. Not: how trajectories are written (runtime/trajectory/trajectory.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <string_view>

#include "generator/scene/scene.hpp"
#include "runtime/model/state_file.hpp"

namespace kanec {

struct Resumed {
  State state;        // of the last full row; inputs that events set as they stand there, all others the scene's
  double work = 0.0;  // of the applied loads until there [J]
  std::string rows;   // before the last full one, without the header
};

// A last line that is cut off is left out; lines may end as on Windows. Throws InputError, naming `file`, for columns
// that are not the scene's and for rows that are no finite numbers in the order of time.
Resumed read_trajectory(std::string_view text, const std::string& file, const scene::Scene& scene);

}  // namespace kanec
