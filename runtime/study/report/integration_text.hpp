// Runs of integrators for people and for machines: text, CSV, JSON, page. Not: the runs (integration.hpp), nor
// their picture (integration_diagram.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "runtime/study/report/integration.hpp"
#include "runtime/text/json.hpp"

namespace kanec {

// `error`: what a recommendation is wanted for; none: for a few usual ones.
std::string integration_text(const SceneRuns& scene, std::optional<double> error);
Json integration_json(const SceneRuns& scene, std::optional<double> error);
// A line a run, headings first.
std::string integration_csv(const std::vector<SceneRuns>& scenes);
// `command`: the one that writes this page, which stands beside its pictures.
std::string integration_markdown(const std::vector<SceneRuns>& scenes, std::optional<double> error,
                                 const std::string& command);

// From when to when; the reference and its own error; what errors are measured by.
std::string stretch_text(const SceneRuns& scene);
std::string reference_text(const SceneRuns& scene);
std::string scales_text(const SceneRuns& scene);

}  // namespace kanec
