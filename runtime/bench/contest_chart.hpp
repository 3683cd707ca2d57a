// Contests as a picture: bars of time on a logarithmic axis, in SVG that needs nothing else. Not: the times.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/bench/contest.hpp"

namespace kanec {

// What the times hold for.
struct Conditions {
  std::string processor, compiler;
};

// A group of bars a scene and function; entries without a time stand there with their note.
std::string chart(const std::vector<Contest>& contests, const Conditions& conditions);

}  // namespace kanec
