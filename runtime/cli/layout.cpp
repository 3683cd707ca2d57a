// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/cli/layout.hpp"

#include <fmt/format.h>

#include "runtime/base/error.hpp"
#include "runtime/cli/table.hpp"

namespace kanec::cli {
namespace {

// One block a body of `first`, then one a body of `second`, as states are ordered.
Layout two_by_body(const scene::Scene& scene, const std::string& name, const Block& first, const Block& second) {
  Layout layout{name, {}, {}, {}, {}};
  for (const Block& block : {first, second})
    for (int k = 1; k <= size(scene); ++k) {
      layout.blocks.push_back(block);
      layout.blocks.back().name += "_" + std::to_string(k);
    }
  layout.summary = fmt::format("{}_K ({} numbers), {}_K ({} numbers), K from 1 to {}", first.name, first.columns,
                               second.name, second.columns, size(scene));
  return layout;
}

Layout plain(const std::string& name, const std::vector<Block>& blocks) { return {name, blocks, {}, {}, {}}; }

Layout along_speeds(const scene::Scene& scene, const std::string& name) {
  return two_by_body(scene, name, {"omega", 0, 3, "N m"}, {"sdot", 0, 3, "N"});
}

Layout mass_matrix(const scene::Scene& scene) {
  const int ny = n_speeds(scene);
  return {"mass_matrix", {{"A", ny, ny, "kg m^2, kg m, kg"}}, {}, speed_names(scene), speed_names(scene)};
}

Layout by_body_and_speed(const scene::Scene& scene, const std::string& name, const std::string& unit) {
  Layout layout{name, {}, {}, {"1", "2", "3"}, speed_names(scene)};
  for (int k = 1; k <= size(scene); ++k) layout.blocks.push_back({"v_" + std::to_string(k), 3, n_speeds(scene), unit});
  return layout;
}

Layout poses(const scene::Scene& scene) {
  Layout layout = plain("poses", {});
  for (int k = 1; k <= size(scene); ++k) {
    layout.blocks.push_back({"R_" + std::to_string(k), 3, 3, ""});
    layout.blocks.push_back({"p_" + std::to_string(k), 0, 3, "m"});
  }
  return layout;
}

Json json_of(std::span<const double> values) { return Json(std::vector<double>(values.begin(), values.end())); }

Json json_of(const Block& block, std::span<const double> values) {
  if (block.columns == 0) return values[0];
  if (block.rows == 0) return json_of(values);
  Json rows = Json::array();
  const auto width = static_cast<std::size_t>(block.columns);
  for (std::size_t i = 0; i < values.size(); i += width) rows.push_back(json_of(values.subspan(i, width)));
  return rows;
}

void add_row(std::vector<TextRow>& table, const std::string& name, std::span<const double> values) {
  table.push_back({name});
  for (const double value : values) table.back().push_back(fmt::format("{:.16e}", value));
}

void add_entries(std::vector<TextRow>& table, const Layout& layout, const Block& block,
                 std::span<const double> values) {
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t row = i / layout.columns.size(), column = i % layout.columns.size();
    if (values[i] == 0.0) continue;
    const std::string name = fmt::format("{}[{}, {}]", block.name, layout.rows[row], layout.columns[column]);
    add_row(table, name, values.subspan(i, 1));
  }
}

void add_block(std::vector<TextRow>& table, const Block& block, std::span<const double> values) {
  const auto width = block.columns == 0 ? 1 : static_cast<std::size_t>(block.columns);
  const std::string name = block.unit.empty() ? block.name : fmt::format("{} [{}]", block.name, block.unit);
  for (std::size_t i = 0; i < values.size(); i += width) add_row(table, i == 0 ? name : "", values.subspan(i, width));
}

}  // namespace

std::size_t Layout::size() const {
  std::size_t sum = 0;
  for (const Block& block : blocks) sum += block.size();
  return sum;
}

Json Layout::json(std::span<const double> values) const {
  Json object = Json::object();
  if (!rows.empty()) object["rows"] = rows;
  if (!columns.empty()) object["columns"] = columns;
  for (const Block& block : blocks) {
    object[block.name] = json_of(block, values.first(block.size()));
    values = values.subspan(block.size());
  }
  return object;
}

std::string Layout::text(std::span<const double> values) const {
  std::vector<TextRow> table;
  for (const Block& block : blocks) {
    if (columns.empty())
      add_block(table, block, values.first(block.size()));
    else
      add_entries(table, *this, block, values.first(block.size()));
    values = values.subspan(block.size());
  }
  return text_table(table);
}

Layout coordinates_layout(const scene::Scene& scene) {
  return two_by_body(scene, "x", {"eps", 0, 4, ""}, {"s", 0, 3, "m"});
}

Layout speeds_layout(const scene::Scene& scene) {
  return two_by_body(scene, "y", {"omega", 0, 3, "rad/s"}, {"sdot", 0, 3, "m/s"});
}

Layout speed_rates_layout(const scene::Scene& scene) {
  return two_by_body(scene, "ydot", {"omegadot", 0, 3, "rad/s^2"}, {"sddot", 0, 3, "m/s^2"});
}

Layout result_layout(const scene::Scene& scene, const std::string& function) {
  if (function == "kinematics") return two_by_body(scene, "xdot", {"epsdot", 0, 4, "1/s"}, {"sdot", 0, 3, "m/s"});
  if (function == "mass_matrix") return mass_matrix(scene);
  if (function == "forcing") return along_speeds(scene, "f");
  if (function == "residual") return along_speeds(scene, "r");
  if (function == "accelerations") return speed_rates_layout(scene);
  if (function == "partial_velocities") return by_body_and_speed(scene, "v_y", "");
  if (function == "partial_velocity_rates") return by_body_and_speed(scene, "v_y_dot", "");
  if (function == "energy") return plain("energy", {{"kinetic", 0, 0, "J"}, {"potential", 0, 0, "J"}});
  if (function == "momentum") return plain("momentum", {{"linear", 0, 3, "kg m/s"}, {"angular", 0, 3, "kg m^2/s"}});
  if (function == "poses") return poses(scene);
  if (function == "power") return plain("power", {{"applied", 0, 0, "W"}});
  throw InternalError("no layout of function " + function);
}

}  // namespace kanec::cli
