// What is drawn, as a gnuplot script with the data in it. Not: running gnuplot (plot.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/integrate/trajectory.hpp"

namespace kanec::integrate {

// Samples row by row: t, x, y, kinetic and potential energy (where there is energy), work.
struct PlotData {
  StateNames names;
  bool has_energy;
  std::vector<double> values;  // (samples × columns)

  std::size_t n_bodies() const { return integrate::n_bodies(names); }
  std::size_t columns() const { return 2 + 13 * n_bodies() + (has_energy ? 2 : 0); }
  std::size_t samples() const { return values.size() / columns(); }
};

// Draws an SVG of six panels (four without energy) into `output`. Colours tell bodies apart and dashes components, with
// a legend of every curve up to 3 bodies, of the bodies up to 12, and beyond that none.
std::string gnuplot_script(const PlotData& data, const std::string& output);

}  // namespace kanec::integrate
