// Results of many states as they are written: CSV, JSON lines, .npy. Not: their evaluation.
//
// CSV: a header line, each name with its unit in brackets, entries of matrices "A_2_1" (row, column); of several parts
// the part in front, "f.omega_1_1". JSON lines: an object of the parts a line, as `kanec eval --json` has "result".
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/model/layout.hpp"
#include "runtime/states/state_source.hpp"

namespace kanec {

// A name a number, "thetaddot_2[rad/s^2]".
std::vector<std::string> result_names(const std::vector<Layout>& layouts);

class ResultSink {
 public:
  virtual ~ResultSink() = default;
  virtual void add(std::span<const double> values) = 0;
  // The file appears under its name then, whole.
  virtual void finish() = 0;
};

// "-": standard output. count: of the states, where it is known; else results of an .npy stand in memory until the end.
// Throws FileError.
std::unique_ptr<ResultSink> open_results(const std::string& path, TableFormat format, std::vector<Layout> layouts,
                                         std::optional<std::int64_t> count);

}  // namespace kanec
