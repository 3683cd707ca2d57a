// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/plot_script.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>

namespace kanec::integrate {
namespace {

constexpr std::size_t every_curve_named = 3, every_body_named = 12;

// A panel of one vector a body, `width` numbers; body k's begin at state_first + k width of (x, y).
struct Panel {
  const char* title;
  const char* axis;
  std::size_t state_first, width;
};

std::array<Panel, 4> panels(std::size_t n) {
  return {{{"Euler parameters", "ε [-]", 0, 4},
           {"translations", "s [m]", 4 * n, 3},
           {"angular velocities", "ω [rad/s]", 7 * n, 3},
           {"translation rates", "ds/dt [m/s]", 10 * n, 3}}};
}

std::string quoted(const std::string& text) {
  std::string result = "'";
  for (const char c : text) result += c == '\'' ? std::string("''") : std::string(1, c);
  return result.append("'");
}

void append(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 8).ptr;
  text.append(digits.data(), end);
}

std::string block_name(std::size_t panel, std::size_t body) {
  return "$body" + std::to_string(panel) + "_" + std::to_string(body);
}

// kinetic + potential - work - their start; the difference is taken before rounding to a few digits
double imbalance(const double* row, const double* start, std::size_t columns) {
  const double* now = row + columns - 3;
  const double* then = start + columns - 3;
  return (now[0] - then[0]) + (now[1] - then[1]) - (now[2] - then[2]);
}

// One data block a body and panel ($body<panel>_<body>: t, vector): gnuplot reads a whole block again for every curve.
std::string body_block(const PlotData& data, std::size_t panel_number, std::size_t body) {
  const Panel panel = panels(data.n_bodies())[panel_number];
  std::string text = block_name(panel_number, body) + " << END\n";
  for (std::size_t row = 0; row < data.samples(); ++row) {
    const double* values = data.values.data() + row * data.columns();
    append(text, values[0]);
    for (std::size_t i = 0; i < panel.width; ++i)
      append(text += ' ', values[1 + panel.state_first + body * panel.width + i]);
    text += '\n';
  }
  return text + "END\n";
}

// $energy: t, kinetic, potential, work, imbalance
std::string energy_block(const PlotData& data) {
  std::string text = "$energy << END\n";
  for (std::size_t row = 0; row < data.samples(); ++row) {
    const double* values = data.values.data() + row * data.columns();
    append(text, values[0]);
    for (std::size_t i = 3; i > 0; --i) append(text += ' ', values[data.columns() - i]);
    append(text += ' ', imbalance(values, data.values.data(), data.columns()));
    text += '\n';
  }
  return text + "END\n";
}

std::string data_blocks(const PlotData& data) {
  std::string text = data.has_energy ? energy_block(data) : "";
  for (std::size_t panel = 0; panel < 4; ++panel)
    for (std::size_t body = 0; body < data.n_bodies(); ++body) text += body_block(data, panel, body);
  return text;
}

// Well-separated colours up to twelve, then from blue (first) over green to red (last).
std::string colour(std::size_t index, std::size_t count) {
  constexpr std::array<const char*, every_body_named> distinct = {"#1f77b4", "#d62728", "#2ca02c", "#ff7f0e",
                                                                  "#9467bd", "#8c564b", "#17becf", "#e377c2",
                                                                  "#7f7f7f", "#bcbd22", "#003f5c", "#000000"};
  if (count <= distinct.size()) return distinct[index];
  const double hue = 4.0 * (1.0 - static_cast<double>(index) / static_cast<double>(count - 1));  // 4 = blue, 0 = red
  const auto channel = [hue](double centre) {
    double distance = std::fabs(hue - centre);
    distance = std::min(distance, 6.0 - distance);
    return static_cast<unsigned>(std::lround(220.0 * std::clamp(2.0 - distance, 0.0, 1.0)));
  };
  std::array<char, 8> text{};
  std::snprintf(text.data(), text.size(), "#%02x%02x%02x", channel(0.0), channel(2.0), channel(4.0));
  return text.data();
}

std::string curve_title(const PlotData& data, const Panel& panel, std::size_t body, std::size_t component) {
  const std::size_t n = data.n_bodies();
  if (n <= every_curve_named) {
    const std::size_t i = panel.state_first + body * panel.width + component;
    return "title " + quoted(i < 7 * n ? data.names.coordinates[i] : data.names.speeds[i - 7 * n]);
  }
  if (n <= every_body_named && component == 0) return "title 'body " + std::to_string(body + 1) + "'";
  return "notitle";
}

// Colours tell bodies apart and dashes components; of a single body, colours its components.
std::string look(std::size_t n_bodies, std::size_t width, std::size_t body, std::size_t component) {
  const bool single = n_bodies == 1;
  return std::string("lw ") + (n_bodies > every_body_named ? "0.6" : "1.4") + " lc rgb '" +
         (single ? colour(component, width) : colour(body, n_bodies)) + "' dt " +
         std::to_string(single ? 1 : component + 1);
}

std::string legend_note(std::size_t n_bodies, std::size_t width) {
  if (n_bodies <= every_curve_named) return "";
  std::string note = std::string(" (1 solid, 2 dashed, 3 dotted") + (width == 4 ? ", 4 dash-dotted" : "");
  if (n_bodies > every_body_named) note += "; body 1 blue … " + std::to_string(n_bodies) + " red";
  return note + ")";
}

std::string draw(const PlotData& data, std::size_t panel_number) {
  const std::size_t n = data.n_bodies();
  const Panel panel = panels(n)[panel_number];
  std::string text = "set title " + quoted(panel.title + legend_note(n, panel.width)) + "\nset ylabel " +
                     quoted(panel.axis) + "\nplot ";
  for (std::size_t body = 0; body < n; ++body)
    for (std::size_t i = 0; i < panel.width; ++i) {
      if (body + i > 0) text += ", \\\n  ";
      text += block_name(panel_number, body) + " using 1:" + std::to_string(i + 2) + " with lines " +
              look(n, panel.width, body, i) + " " + curve_title(data, panel, body, i);
    }
  return text + "\n";
}

constexpr const char* draw_energies = R"(set title 'energies and work of the applied loads'
set ylabel 'energy [J]'
plot $energy using 1:($2+$3) with lines lw 4 lc rgb '#c0c0c0' title 'total', \
  $energy using 1:2 with lines lw 1.4 lc rgb '#1f77b4' title 'kinetic', \
  $energy using 1:3 with lines lw 1.4 lc rgb '#2ca02c' title 'potential', \
  $energy using 1:4 with lines lw 1.4 dt 2 lc rgb '#d62728' title 'work'
set title 'energy balance: zero but for errors'
set ylabel 'change of energy - work [J]'
set format y '%.1e'
plot $energy using 1:5 with lines lw 1.2 lc rgb '#d62728' notitle
)";

}  // namespace

std::string gnuplot_script(const PlotData& data, const std::string& output) {
  const std::string height = data.has_energy ? "1260" : "840", rows = data.has_energy ? "3" : "2";
  std::string script = "set encoding utf8\nset terminal svg size 1500," + height +
                       " noenhanced font 'Helvetica,14' background 'white'\nset output " + quoted(output) + "\n" +
                       data_blocks(data) + "set multiplot layout " + rows +
                       ",2\nset xlabel 'time t [s]'\nset grid lc rgb '#c0c0c0'\nset autoscale xfix\n"
                       "set offsets 0, 0, graph 0.05, graph 0.05\nset key outside right top samplen 2 spacing 0.9\n";
  for (std::size_t panel = 0; panel < 4; ++panel) script += draw(data, panel);
  if (data.has_energy) script += draw_energies;
  return script + "unset multiplot\nunset output\n";
}

}  // namespace kanec::integrate
