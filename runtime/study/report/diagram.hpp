// Lines of points in a double-logarithmic plane as SVG: labelled axes, a legend, the Pareto front. Not: what the points
// are (integration_diagram.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <functional>
#include <string>
#include <vector>

namespace kanec {

struct DiagramPoint {
  double x = 0.0, y = 0.0;  // positive and finite; others are not drawn
  std::string title;        // shown where the pointer rests
  bool is_on_front = false;
  std::string label = {};  // beside it; empty: none
};

// One colour, one marker, one entry of the legend.
struct DiagramLine {
  std::string name;
  std::vector<DiagramPoint> points;
  bool is_joined = true;
};

struct DiagramAxis {
  std::string title;                             // with its unit
  std::function<std::string(double)> tick_text;  // of a power of ten
};

struct Diagram {
  std::string heading;
  std::vector<std::string> notes;  // lines below it
  DiagramAxis x, y;
  std::vector<DiagramLine> lines;
  double unknown_below = 0.0;    // x that are not told apart, as a shaded strip; 0: none
  std::string unknown_text;      // what that strip is
  bool has_common_front = true;  // of all lines, drawn as one; else of each line, its points' full markers
};

std::string diagram_svg(const Diagram& diagram);

}  // namespace kanec
