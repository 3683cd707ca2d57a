// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/diagram.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/base/fit.hpp"
#include "runtime/picture/svg.hpp"

namespace kanec {
namespace {

// Lengths in pixels.
constexpr double width = 1000, plane_height = 480, left = 84, right = 260, head = 34, note_height = 16, foot = 56;

// Told apart also without colour, together with the markers, of which there are four.
constexpr std::array<const char*, 12> colours = {"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e", "#9467bd", "#8c564b",
                                                 "#17becf", "#e377c2", "#7f7f7f", "#bcbd22", "#003f5c", "#000000"};

constexpr auto style = R"(text { font: 12px sans-serif; fill: #222; }
.heading { font-size: 16px; font-weight: bold; }
.note { fill: #666; }
.x { text-anchor: middle; }
.y { text-anchor: end; }
line { stroke: #ddd; }
polyline { fill: none; stroke-width: 1.5; }
.front { stroke: #ffd54a; stroke-width: 9; stroke-linejoin: round; stroke-linecap: round; }
.unknown { fill: #eee; }
)";

bool is_drawn(const DiagramPoint& point) {
  return point.x > 0.0 && point.y > 0.0 && std::isfinite(point.x) && std::isfinite(point.y);
}

// Decades that hold all these values, and one at least.
LogAxis axis_over(const std::vector<double>& values, double begin, double end) {
  LogAxis axis{0, 1, begin, end};
  if (values.empty()) return axis;
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  axis.first = static_cast<int>(std::floor(std::log10(*least)));
  axis.last = std::max(axis.first + 1, static_cast<int>(std::ceil(std::log10(*most))));
  return axis;
}

class Drawing {
 public:
  explicit Drawing(const Diagram& diagram)
      : diagram_(diagram),
        top_(head + note_height * static_cast<double>(diagram.notes.size()) + 14),
        bottom_(top_ + plane_height),
        x_(axis_over(all(&DiagramPoint::x), left, width - right)),
        y_(axis_over(all(&DiagramPoint::y), bottom_, top_)) {}

  std::string svg() const {
    std::string text = svg_label(16, 24, "heading", diagram_.heading);
    double y = head;
    for (const std::string& note : diagram_.notes) text += svg_label(16, y += note_height, "note", note);
    text += unknown() + grid() + front();
    for (std::size_t i = 0; i < diagram_.lines.size(); ++i) text += line(i);
    return svg_picture(width, bottom_ + foot, style, text + labels() + legend());
  }

 private:
  std::vector<double> all(double DiagramPoint::*coordinate) const {
    std::vector<double> values;
    for (const DiagramLine& line : diagram_.lines)
      for (const DiagramPoint& point : line.points)
        if (is_drawn(point)) values.push_back(point.*coordinate);
    return values;
  }

  std::string unknown() const {
    const double end = x_.at(diagram_.unknown_below);
    if (!(diagram_.unknown_below > 0.0) || end <= left) return "";
    return fmt::format("<rect class=\"unknown\" x=\"{}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{}\"/>\n", left, top_,
                       end - left, plane_height) +
           svg_label(left + 4, bottom_ - 6, "note", diagram_.unknown_text);
  }

  std::string grid() const {
    constexpr int most_ticks = 11;
    const int stride = (x_.last - x_.first) / most_ticks + 1;
    std::string text;
    for (int decade = x_.first; decade <= x_.last; ++decade) {
      const double value = std::pow(10.0, decade), at = x_.at(value);
      text += svg_line(at, top_, at, bottom_);
      if ((decade - x_.first) % stride == 0) text += svg_label(at, bottom_ + 18, "x", diagram_.x.tick_text(value));
    }
    for (int decade = y_.first; decade <= y_.last; ++decade) {
      const double value = std::pow(10.0, decade), at = y_.at(value);
      text += svg_line(left, at, width - right, at) + svg_label(left - 8, at + 4, "y", diagram_.y.tick_text(value));
    }
    return text + svg_label((left + width - right) / 2, bottom_ + 42, "x", diagram_.x.title) + y_title();
  }

  std::string y_title() const {
    return fmt::format("<text class=\"x\" transform=\"translate(22 {:.1f}) rotate(-90)\">{}</text>\n",
                       (top_ + bottom_) / 2, fit::xml(diagram_.y.title));
  }

  std::string polyline(const std::string& look, const std::vector<DiagramPoint>& points) const {
    std::string places;
    for (const DiagramPoint& point : points) places += fmt::format(" {:.1f},{:.1f}", x_.at(point.x), y_.at(point.y));
    return places.empty() ? "" : fmt::format("<polyline {} points=\"{}\"/>\n", look, places.substr(1));
  }

  // From the fastest to the most accurate.
  std::string front() const {
    if (!diagram_.has_common_front) return "";
    std::vector<DiagramPoint> points;
    for (const DiagramLine& line : diagram_.lines)
      for (const DiagramPoint& point : line.points)
        if (point.is_on_front && is_drawn(point)) points.push_back(point);
    std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) { return a.y < b.y; });
    return polyline("class=\"front\"", points);
  }

  std::string line(std::size_t index) const {
    std::vector<DiagramPoint> points;
    for (const DiagramPoint& point : diagram_.lines[index].points)
      if (is_drawn(point)) points.push_back(point);
    const std::string look = fmt::format("stroke=\"{}\"{}", colour(index), dashes(index));
    std::string text = diagram_.lines[index].is_joined ? polyline(look, points) : "";
    for (const DiagramPoint& point : points)
      text += marker(index, x_.at(point.x), y_.at(point.y), point.is_on_front, point.title);
    return text;
  }

  // None where it would cover one that is there.
  std::string labels() const {
    constexpr double height = 11.0, length = 60.0;
    std::vector<std::array<double, 2>> places;
    std::string text;
    for (const DiagramLine& line : diagram_.lines)
      for (const DiagramPoint& point : line.points) {
        if (point.label.empty() || !is_drawn(point)) continue;
        const std::array<double, 2> at = {x_.at(point.x) + 8, y_.at(point.y) + 4};
        const auto covers = [&](const std::array<double, 2>& other) {
          return std::fabs(other[0] - at[0]) < length && std::fabs(other[1] - at[1]) < height;
        };
        if (std::any_of(places.begin(), places.end(), covers)) continue;
        places.push_back(at);
        text += svg_label(at[0], at[1], "note", point.label);
      }
    return text;
  }

  // Lines beyond the colours have them again, dashed.
  static const char* dashes(std::size_t index) { return index < colours.size() ? "" : " stroke-dasharray=\"5 3\""; }

  static const char* colour(std::size_t index) { return colours[index % colours.size()]; }

  // A circle, square, diamond or triangle: full on the front, hollow elsewhere.
  static std::string marker(std::size_t index, double x, double y, bool is_full, const std::string& title) {
    constexpr double r = 4.5;
    const std::string look =
        fmt::format("fill=\"{}\" stroke=\"{}\" stroke-width=\"1.5\"", is_full ? colour(index) : "white", colour(index));
    const std::string inner = fmt::format("><title>{}</title>", fit::xml(title));
    switch ((index + index / colours.size()) % 4) {
      case 0:
        return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}{}</circle>\n", x, y, r, look, inner);
      case 1:
        return path(look, inner, {{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}});
      case 2:
        return path(look, inner, {{x, y - 1.3 * r}, {x + 1.3 * r, y}, {x, y + 1.3 * r}, {x - 1.3 * r, y}});
      default:
        return path(look, inner, {{x, y - 1.2 * r}, {x + 1.2 * r, y + r}, {x - 1.2 * r, y + r}});
    }
  }

  static std::string path(const std::string& look, const std::string& inner,
                          const std::vector<std::array<double, 2>>& corners) {
    std::string places;
    for (const auto& [x, y] : corners) places += fmt::format("{}{:.1f},{:.1f}", places.empty() ? "" : " ", x, y);
    return fmt::format("<polygon points=\"{}\" {}{}</polygon>\n", places, look, inner);
  }

  std::string legend() const {
    constexpr double row = 22;
    const double x = width - right + 24;
    double y = top_ + 12;
    std::string text;
    for (std::size_t i = 0; i < diagram_.lines.size(); ++i, y += row)
      text += marker(i, x, y, true, "") + svg_label(x + 14, y + 4, "name", diagram_.lines[i].name);
    if (!diagram_.has_common_front)
      return text + svg_label(x - 4, y + 4, "name", "full: no other way to the same") +
             svg_label(x - 4, y + 20, "name", "is as fast and as accurate");
    text += fmt::format("<polyline class=\"front\" points=\"{0:.1f},{2:.1f} {1:.1f},{2:.1f}\"/>\n", x - 4, x + 4, y);
    return text + svg_label(x + 14, y + 4, "name", "Pareto front: no other is as fast") +
           svg_label(x + 14, y + 20, "name", "and as accurate; full markers");
  }

  const Diagram& diagram_;
  double top_, bottom_;
  LogAxis x_, y_;
};

}  // namespace

std::string diagram_svg(const Diagram& diagram) { return Drawing(diagram).svg(); }

}  // namespace kanec
