// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/bench/contest_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/picture/svg.hpp"

namespace kanec {
namespace {

// Lengths in pixels.
constexpr double width = 960, left = 190, right = 190, top = 74, bottom = 40, bar = 16, row_height = 20, title = 26;

constexpr std::array<const char*, 10> colours = {"#1b6ca8", "#5fa8d3", "#a9d6e5", "#3d5a80", "#9aa5b1",
                                                 "#d1495b", "#edae49", "#66a182", "#8d6a9f", "#b08968"};

// Of a time to that of the first entry: "7.1 times", "4 times faster".
std::string chart_ratio(double ratio) {
  return ratio < 1.0 ? fmt::format("{:.2g} times faster", 1.0 / ratio) : fmt::format("{:.3g} times", ratio);
}

// Decades that hold all times, the shortest some way into the first [ns].
LogAxis axis_of(const std::vector<Contest>& contests) {
  LogAxis axis{1, 4, left, width - right};
  double least = INFINITY, most = 0.0;
  for (const Contest& contest : contests)
    for (const Entry& entry : contest.entries)
      if (entry.time) {
        least = std::min(least, entry.time->median);
        most = std::max(most, entry.time->median);
      }
  if (most <= 0.0) return axis;
  axis.first = static_cast<int>(std::floor(std::log10(std::max(least / 2, 1e-3))));
  axis.last = std::max(axis.first + 1, static_cast<int>(std::ceil(std::log10(most))));
  return axis;
}

// Entries of one function have the same colour everywhere by name, in order of first appearance.
class Palette {
 public:
  const char* of(const std::string& name) {
    const auto found = std::find(names_.begin(), names_.end(), name);
    const auto at = static_cast<std::size_t>(found - names_.begin());
    if (found == names_.end()) names_.push_back(name);
    return colours[at % colours.size()];
  }

 private:
  std::vector<std::string> names_;
};

std::string bar_of(const Entry& entry, const Entry& first, const LogAxis& axis, double y, const char* colour) {
  const std::string name = svg_label(left - 8, y + 12, "name", entry.name);
  if (!entry.time) return name + svg_label(left + 4, y + 12, "note", entry.note);
  const double end = axis.at(entry.time->median);
  std::string value = duration_text(entry.time->median * 1e-9);
  if (&entry != &first && first.time) value += ", " + chart_ratio(entry.time->median / first.time->median);
  return name +
         fmt::format("<rect x=\"{}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\" fill=\"{}\"/>\n", left, y,
                     std::max(end - left, 1.0), bar, colour) +
         svg_label(end + 6, y + 12, "value", value);
}

std::string grid(const LogAxis& axis, double height) {
  std::string text;
  for (int decade = axis.first; decade <= axis.last; ++decade) {
    const double x = axis.at(std::pow(10.0, decade));
    text += svg_line(x, top - 8, x, height - bottom);
    text += svg_label(x, height - bottom + 16, "tick", duration_text(std::pow(10.0, decade - 9)));
  }
  return text + svg_label((left + width - right) / 2, height - 8, "tick", "processor time per evaluation, logarithmic");
}

std::string bars(const std::vector<Contest>& contests, const LogAxis& axis, double& y) {
  Palette palette;
  std::string text, group;
  for (const Contest& contest : contests)
    for (const Entry& entry : contest.entries) {
      const std::string heading = contest.model + ": " + entry.function;
      if (heading != group) {
        text += svg_label(16, y + 18, "group", heading);
        y += title;
        group = heading;
      }
      text += bar_of(entry, contest.first(entry.function), axis, y, palette.of(entry.name));
      y += row_height;
    }
  return text;
}

constexpr auto style = R"(text { font: 12px sans-serif; fill: #222; }
.heading { font-size: 16px; font-weight: bold; }
.group { font-weight: bold; }
.name { text-anchor: end; }
.tick { text-anchor: middle; fill: #555; }
.note { fill: #777; font-style: italic; }
line { stroke: #ddd; }
)";

}  // namespace

std::string chart(const std::vector<Contest>& contests, const Conditions& conditions) {
  const LogAxis axis = axis_of(contests);
  double y = top;
  const std::string drawn = bars(contests, axis, y);
  const double height = y + bottom;
  return svg_picture(width, height, style,
                     svg_label(16, 26, "heading", "Time per evaluation: emitted code beside other ways") +
                         svg_label(16, 44, "note", conditions.processor) +
                         svg_label(16, 60, "note", "emitted code by " + conditions.compiler) + grid(axis, height) +
                         drawn);
}

}  // namespace kanec
