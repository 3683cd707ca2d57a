// What is drawn, as a gnuplot script with the data in it. Not: running gnuplot (plot.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/trajectory/state_names.hpp"

namespace kanec {

// Samples row by row: t, x, y, kinetic and potential energy (where there is energy), work.
struct PlotData {
  StateNames names;
  bool has_energy;
  bool driven;                      // prescribed coordinates do work as well
  std::vector<double> values = {};  // (samples × columns)

  std::size_t columns() const { return 2 + names.coordinates.size() + names.speeds.size() + (has_energy ? 2 : 0); }
  std::size_t samples() const { return values.size() / columns(); }
};

// Draws an SVG into `output`: a row of panels for each kind of coordinate (panels.hpp), one for energy and its balance.
std::string gnuplot_script(const PlotData& data, const std::string& output);

}  // namespace kanec
