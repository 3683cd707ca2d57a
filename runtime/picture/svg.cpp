// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/picture/svg.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/base/fit.hpp"

namespace kanec {

std::string svg_label(double x, double y, const char* kind, const std::string& text) {
  return fmt::format("<text class=\"{}\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>\n", kind, x, y, fit::xml(text));
}

std::string svg_line(double x1, double y1, double x2, double y2) {
  return fmt::format("<line x1=\"{:.1f}\" y1=\"{:.1f}\" x2=\"{:.1f}\" y2=\"{:.1f}\"/>\n", x1, y1, x2, y2);
}

std::string svg_picture(double width, double height, const std::string& style, const std::string& content) {
  return fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} "
      "{1:.0f}\">\n<style>\n{2}</style>\n<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n{3}</svg>\n",
      width, height, style, content);
}

std::string duration_text(double seconds) {
  struct Unit {
    double size;
    const char* name;
  };
  constexpr std::array<Unit, 3> smaller = {{{1e-9, "ns"}, {1e-6, "µs"}, {1e-3, "ms"}}};
  for (const Unit& unit : smaller)
    if (seconds < 999.5 * unit.size) return fmt::format("{:.3g} {}", seconds / unit.size, unit.name);
  return fmt::format("{:.3g} s", seconds);
}

double LogAxis::at(double value) const {
  const double decade = std::log10(std::max(value, std::pow(10.0, first)));
  return begin + std::clamp((decade - first) / (last - first), 0.0, 1.0) * (end - begin);
}

}  // namespace kanec
