// Hard cases as a table: what was kept, to what. Not: the runs (outcome.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "runtime/study/hard/outcome.hpp"
#include "runtime/text/json.hpp"

namespace kanec::hard {

struct CaseReport {
  std::filesystem::path folder;  // where it was read
  HardCase hard;
  std::vector<Outcome> outcomes;  // one a run
};

std::string report_text(const std::vector<CaseReport>& cases);
// A page; `command` is what writes it again, its links are relative to the folder `place`.
std::string report_markdown(const std::vector<CaseReport>& cases, const std::string& command,
                            const std::filesystem::path& place);
Json report_json(const std::vector<CaseReport>& cases);

}  // namespace kanec::hard
