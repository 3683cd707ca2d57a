// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <cstring>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/states/npy.hpp"
#include "runtime/states/state_source.hpp"

namespace kanec {
namespace {

class NpyStates : public StateSource {
 public:
  NpyStates(const std::string& path, const scene::Scene& scene, const Needs& needs)
      : file_(path), table_(read_npy_header(file_)), needs_(needs) {
    const auto nx = static_cast<std::int64_t>(n_coordinates(scene)), ny = static_cast<std::int64_t>(n_speeds(scene));
    const std::int64_t width = nx + (needs.y ? ny : 0) + (needs.ydot ? ny : 0);
    has_time_ = table_.columns == width + 1;
    if (table_.columns != width && !has_time_)
      throw InputError(file_.name() + ": found " + std::to_string(table_.columns) +
                       " columns; allowed: " + std::to_string(width) + ", which are x (" + std::to_string(nx) + ")" +
                       (needs.y ? ", y (" + std::to_string(ny) + ")" : "") +
                       (needs.ydot ? ", ydot (" + std::to_string(ny) + ")" : "") + ", or one more with t in front");
    if (table_.by_columns && !file_.is_regular())
      throw InputError(file_.name() + ": found a table in Fortran's order; allowed from a pipe: one in C's order");
    rows_a_piece_ = std::max<std::int64_t>(1, (std::int64_t{1} << 20) / std::max<std::int64_t>(1, table_.columns * 8));
  }

  bool next(State& state) override {
    if (row_ == table_.rows) return false;
    if (row_ == piece_end_) read_piece();
    const double* from = piece_.data() + (row_ - piece_begin_) * table_.columns;
    ++row_;
    for (std::int64_t i = 0; i < table_.columns; ++i)
      if (!std::isfinite(from[i]))
        throw InputError(place() + ", column " + std::to_string(i) + ": found " + shortest(from[i]) +
                         "; allowed: a finite number");
    if (has_time_) state.t = *from++;
    from = take(state.x, from);
    if (needs_.y) from = take(state.y, from);
    if (needs_.ydot) take(state.ydot, from);
    return true;
  }

  bool has_values() const override { return false; }
  std::string place() const override { return file_.name() + ": row " + std::to_string(row_ - 1); }
  std::optional<std::int64_t> count() const override { return table_.rows; }
  double share() const override {
    return static_cast<double>(row_) / static_cast<double>(std::max<std::int64_t>(1, table_.rows));
  }

 private:
  static const double* take(std::vector<double>& list, const double* from) {
    std::copy(from, from + list.size(), list.begin());
    return from + list.size();
  }

  double number(const char* bytes) const {
    double wide;
    float narrow;
    if (table_.number_size == 8) return std::memcpy(&wide, bytes, 8), wide;
    return std::memcpy(&narrow, bytes, 4), static_cast<double>(narrow);
  }

  void read_piece() {
    piece_begin_ = row_;
    piece_end_ = std::min(row_ + rows_a_piece_, table_.rows);
    const auto rows = static_cast<std::size_t>(piece_end_ - piece_begin_),
               columns = static_cast<std::size_t>(table_.columns), size = static_cast<std::size_t>(table_.number_size);
    piece_.resize(rows * columns);
    if (!table_.by_columns) {
      const std::string_view bytes = file_.bytes(rows * columns * size);
      require(bytes.size(), rows * columns * size);
      for (std::size_t i = 0; i < piece_.size(); ++i) piece_[i] = number(bytes.data() + i * size);
      return;
    }
    for (std::size_t c = 0; c < columns; ++c) {
      const std::size_t first = c * static_cast<std::size_t>(table_.rows) + static_cast<std::size_t>(piece_begin_);
      const std::string bytes = file_.at(table_.begin + first * size, rows * size);
      require(bytes.size(), rows * size);
      for (std::size_t r = 0; r < rows; ++r) piece_[r * columns + c] = number(bytes.data() + r * size);
    }
  }

  void require(std::size_t found, std::size_t wanted) const {
    if (found == wanted) return;
    throw InputError(
        file_.name() + ": found an end within row " +
        std::to_string(piece_begin_ + static_cast<std::int64_t>(found) / (table_.columns * table_.number_size)) +
        "; allowed: the " + std::to_string(table_.rows) + " rows that its header announces");
  }

  FileReader file_;
  NpyTable table_;
  Needs needs_;
  bool has_time_ = false;
  std::vector<double> piece_;
  std::int64_t rows_a_piece_ = 1, row_ = 0, piece_begin_ = 0, piece_end_ = 0;
};

}  // namespace

std::unique_ptr<StateSource> open_npy_states(const std::string& path, const scene::Scene& scene, const Needs& needs) {
  return std::make_unique<NpyStates>(path, scene, needs);
}

}  // namespace kanec
