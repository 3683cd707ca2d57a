// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/trajectory/trajectory.hpp"

#include <array>
#include <charconv>

#include "runtime/base/error.hpp"

namespace kanec {

using namespace integrate;

namespace {

std::string column(const std::string& name) {
  const std::string unit(unit_of(name));
  return "," + name + (unit.empty() ? "" : "[" + unit + "]");
}

void append(std::string& line, double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  line.append(text.data(), end);
}

}  // namespace

std::string csv_header(const StateNames& names, bool has_energy) {
  std::string line = "t[s]";
  for (const std::string& name : names.coordinates) line += column(name);
  for (const std::string& name : names.speeds) line += column(name);
  line += std::string(has_energy ? ",kinetic[J],potential[J]" : "") + ",work[J]";
  for (const std::string& name : names.inputs) line += "," + name;
  return line;
}

void append_csv(std::string& line, const Row& row, std::span<const int> inputs) {
  append(line, row.t);
  const auto next = [&line](double value) {
    line += ',';
    append(line, value);
  };
  for (const double value : row.x) next(value);
  for (const double value : row.y) next(value);
  if (row.energy) {
    next(row.energy->kinetic);
    next(row.energy->potential);
  }
  next(row.work);
  for (const int input : inputs) next(row.inputs[static_cast<std::size_t>(input)]);
}

Trajectory::Trajectory(const std::filesystem::path& path, const StateNames& names, bool has_energy)
    : file_(path),
      has_energy_(has_energy),
      n_state_(names.coordinates.size() + names.speeds.size()),
      inputs_(names.input_indices) {
  file_.write(csv_header(names, has_energy) + "\n");
}

void Trajectory::add(const Row& row) {
  if (row.energy.has_value() != has_energy_) throw InternalError("a row whose energy does not fit the header");
  if (row.x.size() + row.y.size() != n_state_) throw InternalError("a row whose state does not fit the header");
  line_.clear();
  append_csv(line_, row, inputs_);
  line_ += '\n';
  file_.write(line_);
}

}  // namespace kanec
