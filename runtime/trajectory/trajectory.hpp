// The rows of a run as a CSV file. Not: which rows there are (simulate.hpp).
//
// One header line, then one line a row, comma-separated, every number the shortest text that reads back exactly.
// Columns: t[s]; the coordinates (Euler parameters without unit, angles in [rad], translations in [m]); the speeds
// ([rad/s], [m/s]); kinetic[J] and potential[J], both left out where the model has no `energy`; work[J] of the applied
// loads since t = 0; inputs that events set, without unit.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "runtime/base/files.hpp"
#include "runtime/trajectory/simulate.hpp"
#include "runtime/trajectory/state_names.hpp"

namespace kanec {

// The header line and a row's line, without their ends.
std::string csv_header(const StateNames& names, bool has_energy);
void append_csv(std::string& line, const Row& row, std::span<const int> inputs = {});

// The file stands under its name after finish() only, or after commit_all() of it with others; every failure is a
// FileError and leaves nothing behind.
class Trajectory {
 public:
  // Opens the file at once, so that an unwritable path is known before the run. Throws InternalError for names that
  // are none of a state.
  Trajectory(const std::filesystem::path& path, const StateNames& names, bool has_energy);

  void add(const Row& row);
  // Rows as they stand in such a file.
  void add_text(std::string_view rows) { file_.write(rows); }
  void finish() { file_.commit(); }
  AtomicFile& file() { return file_; }

 private:
  AtomicFile file_;
  bool has_energy_;
  std::size_t n_state_;
  std::vector<int> inputs_;  // that have columns
  std::string line_;
};

}  // namespace kanec
