// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/picture/plot_script.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "runtime/base/fit.hpp"
#include "runtime/picture/panels.hpp"

namespace kanec {
namespace {

constexpr std::size_t row_height = 420;  // [px]

void append(std::string& text, double value) {
  std::array<char, 32> digits;
  const auto end =
      std::to_chars(digits.data(), digits.data() + digits.size(), value, std::chars_format::general, 8).ptr;
  text.append(digits.data(), end);
}

std::string block_name(std::size_t panel, int body) {
  return "$body" + std::to_string(panel) + "_" + std::to_string(body);
}

// kinetic + potential - work - their start; the difference is taken before rounding to a few digits
double imbalance(const double* row, const double* start, std::size_t columns) {
  const double* now = row + columns - 3;
  const double* then = start + columns - 3;
  return (now[0] - then[0]) + (now[1] - then[1]) - (now[2] - then[2]);
}

std::vector<Curve> curves_of(const Panel& panel, int body) {
  std::vector<Curve> curves;
  for (const Curve& curve : panel.curves)
    if (curve.body == body) curves.push_back(curve);
  return curves;
}

// One data block a body and panel ($body<panel>_<body>: t, components): gnuplot reads a whole block again for every
// curve.
std::string body_block(const PlotData& data, const std::string& name, const std::vector<Curve>& curves) {
  std::string text = name + " << END\n";
  for (std::size_t row = 0; row < data.samples(); ++row) {
    const double* values = data.values.data() + row * data.columns();
    append(text, values[0]);
    for (const Curve& curve : curves) append(text += ' ', values[1 + curve.entry]);
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

std::string data_blocks(const PlotData& data, const std::vector<Panel>& panels) {
  std::string text = data.has_energy ? energy_block(data) : "";
  for (std::size_t i = 0; i < panels.size(); ++i)
    for (const int body : panels[i].bodies) text += body_block(data, block_name(i, body), curves_of(panels[i], body));
  return text;
}

std::string draw(const Panel& panel, std::size_t number) {
  std::string text = "set title " + fit::gnuplot(panel.title + legend_note(panel)) + "\nset ylabel " +
                     fit::gnuplot(panel.axis) + "\nplot ";
  for (const int body : panel.bodies) {
    std::size_t column = 2;
    for (const Curve& curve : curves_of(panel, body)) {
      const std::string words = legend(panel, curve);
      if (text.back() != ' ') text += ", \\\n  ";
      text += block_name(number, body) + " using 1:" + std::to_string(column++) + " with lines " + look(panel, curve) +
              " " + (words.empty() ? "notitle" : "title " + fit::gnuplot(words));
    }
  }
  return text + "\n";
}

std::string draw_energies(bool driven) {
  const std::string balance = driven ? "work of the prescribed coordinates: what the applied loads leave over"
                                     : "energy balance: zero but for errors";
  return R"(set title 'energies and work of the applied loads'
set ylabel 'energy [J]'
plot $energy using 1:($2+$3) with lines lw 4 lc rgb '#c0c0c0' title 'total', \
  $energy using 1:2 with lines lw 1.4 lc rgb '#1f77b4' title 'kinetic', \
  $energy using 1:3 with lines lw 1.4 lc rgb '#2ca02c' title 'potential', \
  $energy using 1:4 with lines lw 1.4 dt 2 lc rgb '#d62728' title 'work'
set title )" +
         fit::gnuplot(balance) + R"(
set ylabel 'change of energy - work [J]'
set format y '%.1e'
plot $energy using 1:5 with lines lw 1.2 lc rgb '#d62728' notitle
)";
}

}  // namespace

std::string gnuplot_script(const PlotData& data, const std::string& output) {
  const std::vector<Panel> list = panels(data.names);
  const std::size_t rows = std::max<std::size_t>(list.size() / 2 + (data.has_energy ? 1 : 0), 1);
  std::string script = "set encoding utf8\nset terminal svg size 1500," + std::to_string(row_height * rows) +
                       " noenhanced font 'Helvetica,14' background 'white'\nset output " + fit::gnuplot(output) + "\n" +
                       data_blocks(data, list) + "set multiplot layout " + std::to_string(rows) +
                       ",2\nset xlabel 'time t [s]'\nset grid lc rgb '#c0c0c0'\nset autoscale xfix\n"
                       "set offsets 0, 0, graph 0.05, graph 0.05\nset key outside right top samplen 2 spacing 0.9\n";
  for (std::size_t i = 0; i < list.size(); ++i) script += draw(list[i], i);
  if (data.has_energy) script += draw_energies(data.driven);
  return script + "unset multiplot\nunset output\n";
}

}  // namespace kanec
