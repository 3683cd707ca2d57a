// Which runs pay: the Pareto front of time and error, and the run for a wanted error. Not: the runs themselves.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/study/report/integration.hpp"

namespace kanec {

// Marks the runs that no other one equals or beats in both time and worst error. Errors below `least` count as that:
// they are not known better.
void mark_front(std::vector<IntegrationRun>& runs, double least);

// "cvode_bdf, differences, rtol 1e-09"
std::string title_of(const IntegrationRun& run);

// The fastest run of kanec's integrators whose worst error is at most this; none where there is none.
const IntegrationRun* fastest_within(const SceneRuns& scene, double error);

// One line: "for an error of 1e-9: arkode, rtol 1e-11, takes 1.2 ms (worst error 3.2e-10): kanec simulate ...", or why
// there is no such run.
std::string recommendation(const SceneRuns& scene, double error);

// One line: the fastest runs of kanec and of other engines with at most that error at the end, and how many times the
// latter takes as long.
std::string comparison(const SceneRuns& scene, double error);

}  // namespace kanec
