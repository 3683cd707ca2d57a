// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/picture/plot.hpp"

#include <algorithm>

#include "runtime/base/error.hpp"
#include "runtime/base/process.hpp"
#include "runtime/base/temporary.hpp"
#include "runtime/picture/panels.hpp"

namespace kanec {
namespace {

namespace fs = std::filesystem;

fs::path require_gnuplot() {
  if (const auto program = find_program("gnuplot")) return *program;
  throw InputError("a plot needs gnuplot, which is not on the PATH; it comes with the Debian package gnuplot-nox");
}

// Enough for the width of a panel, and the whole picture within a few megabytes.
std::size_t most_samples(const PlotData& data) { return std::clamp<std::size_t>(300'000 / data.columns(), 400, 1200); }

}  // namespace

Plot::Plot(const fs::path& path, const StateNames& names, bool has_energy, bool driven)
    : path_(path),
      gnuplot_(require_gnuplot()),
      file_(path),
      data_{names, has_energy, driven},
      most_samples_(most_samples(data_)) {
  panels(names);  // refuses names that are none
}

void Plot::add(const Row& row) {
  if (row.energy.has_value() != data_.has_energy) throw InternalError("a row whose energy does not fit the plot");
  current_.assign(1, row.t);
  current_.insert(current_.end(), row.x.begin(), row.x.end());
  current_.insert(current_.end(), row.y.begin(), row.y.end());
  if (row.energy) current_.insert(current_.end(), {row.energy->kinetic, row.energy->potential});
  current_.push_back(row.work);
  if (current_.size() != data_.columns()) throw InternalError("a row whose state does not fit the plot");
  if (seen_ % stride_ == 0) append_current();
  ++seen_;
  if (data_.samples() > most_samples_) thin();
}

void Plot::append_current() { data_.values.insert(data_.values.end(), current_.begin(), current_.end()); }

// Drops every second sample and from now on takes half as many.
void Plot::thin() {
  const auto width = static_cast<std::ptrdiff_t>(data_.columns());
  auto to = data_.values.begin();
  for (auto from = data_.values.begin(); from < data_.values.end();
       from += std::min(2 * width, data_.values.end() - from))
    to = std::copy(from, from + width, to);
  data_.values.erase(to, data_.values.end());
  stride_ *= 2;
}

void Plot::draw() {
  if (seen_ == 0) throw InternalError("a plot without rows");
  const double last_kept = data_.values[data_.values.size() - data_.columns()];
  if (last_kept != current_.front()) append_current();
  const TemporaryFolder folder(temporary_root() / "kanec-plot");
  const fs::path picture = folder.path() / "plot.svg";
  const ProcessResult result = run_process({gnuplot_.string(), "-d", "-"}, gnuplot_script(data_, picture.string()));
  const std::string svg = fs::exists(picture) ? read_file(picture, any_size) : "";
  if (result.status != 0 || svg.find("</svg>") == std::string::npos)
    throw FileError(path_.string(), "gnuplot failed with status " + std::to_string(result.status), result.output);
  file_.write(svg);
}

void Plot::finish() {
  draw();
  file_.commit();
}

}  // namespace kanec
