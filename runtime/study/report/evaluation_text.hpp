// Rounding errors of scenes' functions for people and for machines. Not: how they are measured (evaluation.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/study/report/evaluation.hpp"
#include "runtime/text/json.hpp"

namespace kanec {

std::string evaluation_text(const std::vector<SceneErrors>& scenes);
Json evaluation_json(const std::vector<SceneErrors>& scenes, const EvaluationOptions& options);
// A line a way, headings first.
std::string evaluation_csv(const std::vector<SceneErrors>& scenes);
// Of the compiled variants, where they are timed.
std::string variants_csv(const std::vector<SceneErrors>& scenes);
// `command`: the one that writes this page.
std::string evaluation_markdown(const std::vector<SceneErrors>& scenes, const EvaluationOptions& options,
                                const std::string& command);

}  // namespace kanec
