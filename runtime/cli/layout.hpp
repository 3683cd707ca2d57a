// Names, shapes and units of what stands in the arguments and results of the functions. Not: the numbers.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/cli/output.hpp"

namespace kanec::cli {

// So many numbers that belong together: a scalar (rows 0, columns 0), a vector (rows 0), or a matrix, row by row.
struct Block {
  std::string name;  // "eps_1"
  int rows, columns;
  std::string unit;  // "rad/s"

  std::size_t size() const {
    return static_cast<std::size_t>(rows == 0 ? 1 : rows) * static_cast<std::size_t>(columns == 0 ? 1 : columns);
  }
};

struct Layout {
  std::string name;                  // "x", "ydot", "mass_matrix"
  std::vector<Block> blocks;         // in order
  std::string summary;               // "eps_K (4), s_K (3); K from 1 to 6"
  std::vector<std::string> rows;     // names of the rows and
  std::vector<std::string> columns;  // columns of wide matrices; else empty

  std::size_t size() const;
  // {"eps_1": [...], ...}, with "rows" and "columns" before them where they have names.
  Json json(std::span<const double> values) const;
  // A line a vector or a row, 17 digits; of wide matrices a line an entry that is not zero.
  std::string text(std::span<const double> values) const;
};

// Arguments: x, y, ydot.
Layout coordinates_layout(const scene::Scene& scene);
Layout speeds_layout(const scene::Scene& scene);
Layout speed_rates_layout(const scene::Scene& scene);

// The result of a function that the scene has.
Layout result_layout(const scene::Scene& scene, const std::string& function);

}  // namespace kanec::cli
