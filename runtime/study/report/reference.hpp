// The motion that integrators are measured by, and how well it is known itself. Not: the measuring (integration.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>
#include <vector>

#include "runtime/study/report/trials.hpp"

namespace kanec {

// A relative error of a state that stands in double: a few of its roundings.
constexpr double rounding_of_double = 1e-15;

struct Reference {
  std::string description;  // "gauss6, h 0.0025 s"
  std::vector<Bodies> rows;
  MotionScales scales;
  double own_error = 0.0;  // relative, worst over rows: change from the next coarser run of its kind, or rounding
  std::string coarser;     // that run
  std::string check;       // another method's best run; empty where none went through
  double check_difference = 0.0;  // from that
  bool is_disputed = false;       // that is more than both can be off by: own_error is the difference
};

// `base`: duration, rows, tolerances of the scene; `step`: one that a loosely error-controlled run takes [s]; `limit`:
// of one run [s]. Throws IntegrationError where no method gets to the end.
Reference reference(const Trials& trials, const integrate::Options& base, double step, double limit);

// Worst over rows, relative.
double distance(const std::vector<Bodies>& rows, const std::vector<Bodies>& from, const MotionScales& scales);

}  // namespace kanec
