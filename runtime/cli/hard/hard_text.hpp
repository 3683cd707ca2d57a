// Hard cases as a table: what was kept, to what. Not: the runs (outcome.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/cli/hard/outcome.hpp"
#include "runtime/cli/output.hpp"

namespace kanec::cli::hard {

struct CaseReport {
  HardCase hard;
  std::vector<Outcome> outcomes;  // one a run
};

std::string report_text(const std::vector<CaseReport>& cases);
// A page; `command` is what writes it again.
std::string report_markdown(const std::vector<CaseReport>& cases, const std::string& command);
Json report_json(const std::vector<CaseReport>& cases);

}  // namespace kanec::cli::hard
