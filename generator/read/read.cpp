// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/read.hpp"

#include <algorithm>

#include "generator/read/body.hpp"
#include "generator/read/check.hpp"
#include "generator/read/connection.hpp"
#include "generator/read/expression_names.hpp"
#include "generator/read/node.hpp"
#include "generator/read/parse_toml.hpp"
#include "generator/read/read_ensemble.hpp"
#include "generator/read/read_event.hpp"
#include "generator/read/read_functions.hpp"
#include "generator/read/read_load.hpp"
#include "generator/read/read_motion.hpp"
#include "generator/read/read_point.hpp"
#include "generator/read/read_simulation.hpp"
#include "generator/read/singular.hpp"
#include "generator/read/symbols.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/files.hpp"

namespace kanec::scene {
namespace {

std::vector<int> read_connection(const Table& root) {
  const Node node = root.at("connection", "the lower-numbered body array, as [0, 1, 2, 2, 1, 5]");
  const std::vector<Node> entries = node.list("a list of whole numbers, one a body");
  std::vector<int> lower;
  for (const Node& entry : entries)
    lower.push_back(entry.integer("a whole number, 0 (the inertial frame) or a lower body"));
  check_connection(lower, [&](std::size_t k) { return k == 0 ? node.place() : entries[k - 1].place(); });
  return lower;
}

std::string tables_of(std::size_t bodies) {
  return std::to_string(bodies) + (bodies == 1 ? " [[body]] table" : " [[body]] tables");
}

std::vector<Node> body_tables(const Table& root, std::size_t wanted) {
  const std::string allowed = tables_of(wanted) + ", one a number of connection";
  const Node node = root.at("body", allowed);
  const std::vector<Node> tables = node.list(allowed);
  if (tables.size() != wanted) fail(node.place(), tables_of(tables.size()), allowed);
  return tables;
}

void refuse_duplicates(const std::vector<BodyTable>& tables) {
  for (std::size_t k = 0; k < tables.size(); ++k)
    for (std::size_t j = 0; j < k; ++j)
      if (tables[j].name == tables[k].name) {
        Place place = tables[k].table.place();
        place.body = "body " + std::to_string(k + 1);
        place.field = "name";
        fail(place, in_quotes(tables[k].name) + ", the name of body " + std::to_string(j + 1), "another name");
      }
}

// What depends on more than one body.
void check_tree(const std::vector<BodyTable>& tables, const Symbols& symbols, Scene& scene) {
  const std::vector<Attitude> attitudes = initial_attitudes(scene);
  check_resistance(scene, attitudes,
                   [&tables](int k) { return tables[static_cast<std::size_t>(k - 1)].table.place(); });
  const std::vector<bool> one_direction = turns_about_one_direction(scene, attitudes);
  for (std::size_t k = 0; k < tables.size(); ++k) {
    const Place place = tables[k].table.at("inertia", "").place();
    if (auto warning = inertia_warning(scene.bodies[k].inertia, one_direction[k], symbols, place))
      scene.warnings.push_back(*warning);
  }
}

// Joints first, then what refers to them.
void read_tree(const Table& root, Symbols& symbols, Scene& scene) {
  std::vector<BodyTable> tables;
  for (const Node& node : body_tables(root, scene.lower.size()))
    tables.push_back(read_body_table(node, static_cast<int>(tables.size()) + 1));
  refuse_duplicates(tables);
  for (const BodyTable& table : tables) scene.bodies.push_back(read_body(table, symbols, scene));
  symbols.refuse(taken_names(scene));
  const std::vector<ExpressionName> names = names_for_motions(scene);
  for (std::size_t k = 0; k < tables.size(); ++k)
    read_motion(tables[k].table, *tables[k].kind, static_cast<int>(k) + 1, names, scene);
  for (const Expression& expression : scene.expressions) symbols.mark_used(expression);
  check_tree(tables, symbols, scene);
  read_points(root, symbols, scene);
  Magnitudes magnitudes(scene, symbols);
  for (std::size_t k = 0; k < tables.size(); ++k)
    read_body_loads(tables[k], static_cast<int>(k) + 1, magnitudes, scene);
  read_loads(root, magnitudes, symbols, scene);
  read_events(root, magnitudes, symbols, scene);
}

Scene read_scene(const Table& root) {
  root.only({"name", "connection", "gravity", "functions", "parameters", "inputs", "body", "point", "load", "event",
             "simulate", "ensemble"});
  Scene scene;
  Symbols symbols;
  scene.name = read_scene_name(root.at("name", "the name of the scene"));
  if (const auto node = root.find("parameters")) symbols.add_parameters(Table(*node, "parameters."));
  if (const auto node = root.find("inputs")) symbols.add_inputs(Table(*node, "inputs."));
  scene.parameters = symbols.parameters();
  scene.inputs = symbols.inputs();
  if (const auto node = root.find("gravity")) scene.gravity = symbols.vector(*node);
  scene.lower = read_connection(root);
  read_tree(root, symbols, scene);
  AskedFunctions asked = read_functions(root);
  scene.functions = std::move(asked.names);
  scene.function_places = std::move(asked.places);
  if (const auto node = root.find("simulate"))
    scene.simulation = read_simulation(Table(*node, "simulate."), {}, "default");
  scene.ensemble = read_ensemble(root, scene);
  for (std::string& warning : symbols.warnings()) scene.warnings.push_back(std::move(warning));
  return scene;
}

}  // namespace

Scene parse(std::string_view text, const std::string& file) {
  const toml::table table = parse_toml(text, file);
  return read_scene(Table(table, {file}, ""));
}

Scene read(const std::filesystem::path& path) {
  Scene scene = parse(read_file(path), path.string());
  const std::filesystem::path full = std::filesystem::absolute(path).lexically_normal();
  scene.source = (full.parent_path().filename() / full.filename()).generic_string();
  return scene;
}

}  // namespace kanec::scene
