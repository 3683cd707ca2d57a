// Contests as text and for machines. Not: as a picture (contest_chart.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

#include "runtime/bench/contest.hpp"
#include "runtime/text/json.hpp"

namespace kanec {

// "Intel(R) Xeon(R) Processor", of the machine that runs this; empty where it does not tell.
std::string processor_name();

// A table; the name of the model before it.
std::string text(const Contest& contest);
Json json(const Contest& contest);

// What has to be known beside times of other engines, a line each; none where nothing has.
std::string footnotes(const std::vector<Contest>& contests);

}  // namespace kanec
