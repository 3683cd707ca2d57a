// kanec functions: what can be asked for of a scene.
// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/functions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <set>

#include "generator/scene/states.hpp"
#include "runtime/cli/commands.hpp"
#include "runtime/cli/scene_argument.hpp"
#include "runtime/model/result_layout.hpp"
#include "runtime/terminal/output.hpp"
#include "runtime/text/json.hpp"
#include "runtime/text/table.hpp"

namespace kanec::cli {
namespace {

constexpr auto functions_footer = R"(Example: which derivatives does a cart with a pole have, and of what shape?
  kanec functions models/cart_pole

Each with its shape (rows x columns; nothing behind a list), the units of its numbers in their order, its arguments and
what it is. Those with a star are emitted where none are named; others by --functions a,b. Several joined by + are one:
--functions kinematics+accelerations. The time is an argument where the scene depends on it, inputs where it has any.)";

struct FunctionsArguments {
  SceneArgument scene;
  bool json = false;
};

std::vector<std::string> arguments_of(const Available& function, const scene::Scene& scene) {
  std::vector<std::string> list;
  const program::Signature& reads = function.signature;
  if (reads_time(scene)) list.emplace_back("t");
  if (reads.x) list.emplace_back("x");
  if (reads.y) list.emplace_back("y");
  if (reads.ydot) list.emplace_back("ydot");
  if (reads.inputs && !scene.inputs.empty()) list.emplace_back("inputs");
  return list;
}

// "14 x 14", "37", "2 x (3 x 3)": of a matrix with names, or of what its blocks have in common.
std::vector<int> extents_of(const Layout& layout) {
  if (layout.blocks.size() == 1 && layout.blocks[0].shape.size() == 2) return layout.blocks[0].shape;
  return {static_cast<int>(layout.size())};
}

std::vector<std::string> units_of(const Layout& layout) {
  std::vector<std::string> list;
  std::set<std::string> seen;
  for (const Block& block : layout.blocks) {
    const std::string unit = block.unit.empty() ? "1" : block.unit;
    if (seen.insert(unit).second) list.push_back(unit);
  }
  return list;
}

std::string table_of(const scene::Scene& scene, const std::vector<Available>& all) {
  std::vector<TextRow> rows = {{"", "function", "shape", "unit", "of", ""}};
  for (const Available& function : all) {
    const Layout layout = result_layouts(scene, function.name).front();
    const bool has_units = layout.rows.empty() || layout.blocks[0].unit != "";
    rows.push_back({function.usual ? "*" : "", function.name, fmt::format("{}", fmt::join(extents_of(layout), " x ")),
                    has_units ? fmt::format("{}", fmt::join(units_of(layout), ", ")) : "",
                    fmt::format("{}", fmt::join(arguments_of(function, scene), " ")), function.meaning});
  }
  return text_table(rows, "llllll");
}

Json functions_json(const scene::Scene& scene, const std::vector<Available>& all) {
  Json list = Json::array();
  for (const Available& function : all) {
    const Layout layout = result_layouts(scene, function.name).front();
    Json blocks = Json::array();
    for (const Block& block : layout.blocks)
      blocks.push_back({{"name", block.name}, {"shape", block.shape}, {"unit", block.unit}});
    Json one = {{"name", function.name},   {"meaning", function.meaning},
                {"usual", function.usual}, {"arguments", arguments_of(function, scene)},
                {"size", layout.size()},   {"blocks", std::move(blocks)}};
    if (!layout.rows.empty()) one["rows"] = layout.rows;
    if (!layout.columns.empty()) one["columns"] = layout.columns;
    list.push_back(std::move(one));
  }
  return {{"model", scene.name}, {"functions", std::move(list)}};
}

int functions(const FunctionsArguments& options) {
  const scene::Scene scene = load(options.scene);
  const Functions known(scene);
  if (options.json)
    print_json(functions_json(scene, known.all()));
  else
    print(table_of(scene, known.all()));
  return 0;
}

}  // namespace

void add_functions_command(CLI::App& app, Action& action) {
  const auto [command, options] =
      add_command(app, action, "functions", "all that can be asked for of a scene, with shape and unit",
                  functions_footer, &functions);
  add_scene(*command, options->scene);
  command->add_flag("--json", options->json, "for machines");
}

}  // namespace kanec::cli
