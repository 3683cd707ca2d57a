// The pieces that kanec's own pictures are made of: SVG text, frames, logarithmic axes. Not: any picture
// (bench/contest_chart.hpp, report/diagram.hpp), nor those that gnuplot draws.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace kanec {

// One line of text whose anchor is at (x, y) [px]; `kind` is a class of the picture's style.
std::string svg_label(double x, double y, const char* kind, const std::string& text);

std::string svg_line(double x1, double y1, double x2, double y2);

// A whole picture on white that needs nothing else; `style`: CSS rules.
std::string svg_picture(double width, double height, const std::string& style, const std::string& content);

// "85 ns", "1.2 µs", "3 ms", "2 s"
std::string duration_text(double seconds);

// Decades 10^first … 10^last from pixel `begin` to pixel `end`.
struct LogAxis {
  int first = 0, last = 1;
  double begin = 0.0, end = 1.0;

  // The pixel of a value; what is beyond the axis stands at its end.
  double at(double value) const;
};

}  // namespace kanec
