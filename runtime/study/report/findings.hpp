// What `kanec report` finds out about scenes, and as text, page, table or for machines. Not: the command line
// (report.cpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/study/report/evaluation.hpp"
#include "runtime/study/report/integration.hpp"

namespace kanec {

struct ReportOptions {
  std::vector<std::string> scenes;
  std::string connection;
  bool evaluation_alone = false, integration_alone = false, with_peers = false, hard = false, brief = false;
  EvaluationOptions evaluation;
  IntegrationOptions integration;
  BuildOptions build;
  bool json = false, csv = false, markdown = false;
  std::string output = "-", plot;

  bool evaluates() const { return !integration_alone; }
  bool integrates() const { return !evaluation_alone && (integration_alone || evaluation.functions.empty()); }
  bool draws_evaluation() const { return !plot.empty() && !integrates(); }
};

// Both parts of every scene, as far as they are made; of a part that failed there is the name and why.
struct Findings {
  std::vector<SceneErrors> errors;
  std::vector<SceneRuns> runs;

  std::vector<std::string> failures() const;  // "pendulum: no reference: ..."
};

// Progress is shown; Ctrl-C ends it. Throws what a scene throws that is alone, and Error where every part failed.
Findings found(const ReportOptions& options, const std::vector<scene::Scene>& scenes);

// In the form that is asked for.
std::string text_of(const Findings& findings, const ReportOptions& options);

}  // namespace kanec
