// Which curves the picture of a run has: panels, legends, looks. Not: the script that draws them (plot_script.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "runtime/trajectory/state_names.hpp"

namespace kanec {

struct Curve {
  std::size_t entry;  // of (x, y), from 0
  int body, component;
  std::string name, body_name;
};

// All components of one kind, body by body.
struct Panel {
  std::string title, axis;
  std::vector<Curve> curves;
  std::vector<int> bodies;  // that have curves here, in order
};

// Two panels a kind of coordinate that the state has: the coordinates, and beside them their speeds.
std::vector<Panel> panels(const StateNames& names);

// Colours tell bodies apart and dashes components; of a single body, colours its components. Every curve of up to
// twelve is named; of more the bodies are, up to twelve; of still more none.
std::string look(const Panel& panel, const Curve& curve);    // "lw 1.4 lc rgb '#1f77b4' dt 1"
std::string legend(const Panel& panel, const Curve& curve);  // the curve's text, or empty
std::string legend_note(const Panel& panel);                 // " (1 solid, 2 dashed, 3 dotted)", or empty

}  // namespace kanec
