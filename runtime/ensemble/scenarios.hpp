// Scenarios of an ensemble as a table: values by name, one row a scenario, from a CSV file or drawn as the scene says.
// Not: their integration.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/abi/abi.h"
#include "runtime/trajectory/batch_ensemble.hpp"

namespace kanec {

struct ScenarioTable {
  std::string origin;              // the file; "scene pendulum" of drawn ones
  std::vector<std::string> names;  // of the columns: coordinates, speeds, parameters, inputs
  std::vector<double> values;      // row by row
  std::vector<int> lines;          // of the file, one a row; empty: drawn

  std::size_t rows() const { return names.empty() ? 0 : values.size() / names.size(); }
  std::span<const double> row(std::size_t i) const { return {values.data() + i * names.size(), names.size()}; }
  // "runs.csv:12" or "scene pendulum: scenario 11".
  std::string place(std::size_t i) const;
};

// A header line of names, a unit in brackets behind each if one likes; then a line a scenario. Lines that are empty or
// begin with # count for nothing. Throws InputError that names file, line and column.
ScenarioTable read_scenarios(std::string_view text, const std::string& file, const scene::Scene& scene);

// As the scene's [ensemble] says: mt19937_64 of that seed, scenario by scenario, name by name, so that further
// scenarios leave the first ones alone. Uniform: the upper 53 bits; normal: Box and Muller's cosine, of two such
// numbers. Throws InputError where the scene draws nothing.
ScenarioTable draw_scenarios(const scene::Scene& scene, int count, std::uint64_t seed);

// That table as a CSV file that reads back as the same.
std::string csv_text(const ScenarioTable& table);

// Rows to what the integrators take: what has no column is as the scene has it, Euler parameters are normalised.
class Scenarios {
 public:
  // Checks every row. Throws InputError and SceneError that name place and column: Euler parameters that are all zero,
  // parameters that no body can have.
  Scenarios(const scene::Scene& scene, const ScenarioTable& table);

  // For a compiled model of the scene.
  Scenario at(std::size_t row, const kanec_model& model) const;
  // How many rows had Euler parameters further than 1e-6 from unit norm.
  std::size_t normalised() const { return normalised_; }

 private:
  enum class Part { x, y, parameter, input };
  struct Column {
    Part part;
    std::size_t index;
  };

  Column column_of(const std::string& name) const;
  bool has(Part part) const;
  std::vector<double> with(Part part, std::vector<double> values, std::size_t row) const;
  void check_parameters(std::size_t row) const;
  bool normalise(std::vector<double>& x, std::size_t row) const;

  const scene::Scene& scene_;
  const ScenarioTable& table_;
  scene::Layout layout_;
  std::vector<double> x_, y_;
  std::vector<Column> columns_;
  std::size_t normalised_ = 0;
};

}  // namespace kanec
