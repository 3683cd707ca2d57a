// The rows of a run as a picture (SVG), drawn by gnuplot: coordinates, speeds, energies and the energy balance over
// time. Not: the numbers themselves (trajectory.hpp keeps every row; here long runs are thinned).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <filesystem>
#include <vector>

#include "runtime/base/files.hpp"
#include "runtime/picture/plot_script.hpp"
#include "runtime/trajectory/simulate.hpp"

namespace kanec {

// The file stands under its name after finish() only, or after draw() and commit_all() of it with others.
class Plot {
 public:
  // `driven`: prescribed coordinates do work that is no applied load's. Throws InputError where there is no gnuplot,
  // FileError where `path` cannot be written, InternalError for names that are none of a state: all before the run.
  Plot(const std::filesystem::path& path, const StateNames& names, bool has_energy, bool driven = false);

  void add(const Row& row);

  // Runs gnuplot and writes the picture to file(). Throws FileError with gnuplot's words where it fails.
  void draw();
  void finish();
  AtomicFile& file() { return file_; }

 private:
  void append_current();
  void thin();

  std::filesystem::path path_;
  std::filesystem::path gnuplot_;
  AtomicFile file_;
  PlotData data_;
  std::vector<double> current_;  // the last row
  std::size_t most_samples_;
  std::int64_t seen_ = 0, stride_ = 1;
};

}  // namespace kanec
