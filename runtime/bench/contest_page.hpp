// Contests as a page of documentation: a row a scene and function, a column a path. Not: the text and JSON of a run
// (contest_text.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/bench/contest_chart.hpp"

namespace kanec {

// Markdown; `command` is what wrote it; with the picture beside it where `picture` names one.
std::string page(const std::vector<Contest>& contests, const Conditions& conditions, const std::string& command,
                 const std::string& picture);

}  // namespace kanec
