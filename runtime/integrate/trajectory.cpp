// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/trajectory.hpp"

#include <array>
#include <charconv>

#include "runtime/base/error.hpp"

namespace kanec::integrate {
namespace {

std::string header(const StateNames& names, bool has_energy) {
  const std::size_t n = n_bodies(names);
  std::string line = "t[s]";
  for (std::size_t i = 0; i < 7 * n; ++i) line += "," + names.coordinates[i] + (i < 4 * n ? "" : "[m]");
  for (std::size_t i = 0; i < 6 * n; ++i) line += "," + names.speeds[i] + (i < 3 * n ? "[rad/s]" : "[m/s]");
  return line + (has_energy ? ",kinetic[J],potential[J]" : "") + ",work[J]\n";
}

void append(std::string& line, double value) {
  std::array<char, 32> text;
  const auto end = std::to_chars(text.data(), text.data() + text.size(), value).ptr;
  line.append(text.data(), end);
}

}  // namespace

std::size_t n_bodies(const StateNames& names) {
  const std::size_t n = names.speeds.size() / 6;
  if (n == 0 || names.speeds.size() != 6 * n || names.coordinates.size() != 7 * n)
    throw InternalError("names of a state that is not 7N coordinates and 6N speeds");
  return n;
}

Trajectory::Trajectory(const std::filesystem::path& path, const StateNames& names, bool has_energy)
    : file_(path), has_energy_(has_energy) {
  file_.write(header(names, has_energy));
}

void Trajectory::add(const Row& row) {
  if (row.energy.has_value() != has_energy_) throw InternalError("a row whose energy does not fit the header");
  line_.clear();
  append(line_, row.t);
  const auto next = [this](double value) {
    line_ += ',';
    append(line_, value);
  };
  for (const double value : row.x) next(value);
  for (const double value : row.y) next(value);
  if (row.energy) {
    next(row.energy->kinetic);
    next(row.energy->potential);
  }
  next(row.work);
  line_ += '\n';
  file_.write(line_);
}

}  // namespace kanec::integrate
