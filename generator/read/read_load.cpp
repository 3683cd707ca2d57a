// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/read_load.hpp"

#include <algorithm>
#include <optional>

#include "generator/read/read_point.hpp"
#include "generator/scene/component.hpp"

namespace kanec::scene {
namespace {

using LoadKind = Load::Kind;
using KeyWords = std::vector<std::string>;

// Of each kind of load, in the order of Load::Kind.
const std::vector<KeyWords> keys_of_kinds = {
    {"name", "kind", "body", "r", "point", "vector", "axes", "reaction"},
    {"name", "kind", "body", "vector", "axes", "reaction"},
    {"name", "kind", "coordinate", "effort", "stiffness", "damping", "rest"},
    {"name", "kind", "body", "r", "point", "other_body", "other_r", "other_point", "stiffness", "damping", "rest"}};

// The place in `words` of the text at `node`, which must be one of them.
std::size_t chosen_word(const Node& node, const KeyWords& words) {
  const std::string word = node.text(one_of(words, ""));
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) node.refuse(one_of(words, word));
  return static_cast<std::size_t>(found - words.begin());
}

Number number_or_zero(const Table& table, const char* key, Magnitudes& magnitudes) {
  const std::optional<Node> node = table.find(key);
  return node ? magnitudes.number(*node) : Number{};
}

// What pulls back: effort (of joints), stiffness, damping, rest; at least one of the first three.
void read_restoring(const Table& table, bool has_effort, Magnitudes& magnitudes, Load& load) {
  if (!table.find("stiffness") && !table.find("damping") && !(has_effort && table.find("effort")))
    fail(table.place(), "a load without magnitude",
         has_effort ? "effort, stiffness or damping" : "stiffness or damping");
  if (const auto rest = table.find("rest"); rest && !table.find("stiffness"))
    fail(rest->place(), "rest without stiffness", "both, or neither");
  if (has_effort) load.effort = number_or_zero(table, "effort", magnitudes);
  if (const auto stiffness = table.find("stiffness"))
    load.stiffness = magnitudes.not_negative(*stiffness, "a stiffness that drives away from rest");
  if (const auto damping = table.find("damping"))
    load.damping = magnitudes.not_negative(*damping, "a damping that feeds the motion");
  load.rest = number_or_zero(table, "rest", magnitudes);
}

void read_coordinate(const Node& node, const Scene& scene, Load& load) {
  std::vector<std::string> known;
  const std::string name = node.text("the name of a coordinate, as \"theta_2\"");
  int matches = 0;
  for (const Component& component : components(scene)) {
    const bool scalar = component.kind != Component::Kind::attitude;
    if (scalar) known.push_back(coordinate_name_by_body(scene, component));
    if (name != coordinate_name_by_body(scene, component) && name != coordinate_name(component)) continue;
    if (!scalar)
      fail(node.place(), in_quotes(name) + ", of an attitude", "an angle or translation; on an attitude a moment");
    ++matches;
    load.point.body = component.body;
    load.turn = component.kind == Component::Kind::turn;
    load.coordinate = component.index;
  }
  if (matches == 0) node.refuse("the name of an angle or translation: " + one_of(known, name));
  if (matches > 1)
    fail(node.place(), in_quotes(name) + ", the name of two coordinates", "the body's number for its name");
}

// One of [[load]], its keys by its kind.
class LoadReader {
 public:
  LoadReader(const Table& table, Magnitudes& magnitudes, Symbols& symbols, const Scene& scene)
      : table_(table), magnitudes_(magnitudes), symbols_(symbols), scene_(scene) {}

  Load read(const std::string& name) {
    load_.name = name;
    load_.kind = read_kind();
    switch (load_.kind) {
      case LoadKind::force:
        force();
        break;
      case LoadKind::moment:
        moment();
        break;
      case LoadKind::joint:
        joint();
        break;
      case LoadKind::spring:
        spring();
        break;
    }
    return load_;
  }

 private:
  LoadKind read_kind() {
    const KeyWords kinds = {"force", "moment", "joint", "spring"};
    const std::size_t kind = chosen_word(table_.at("kind", one_of(kinds, "")), kinds);
    table_.only(keys_of_kinds[kind]);
    return static_cast<LoadKind>(kind);
  }

  void force() {
    load_.point = read_load_point(table_, "", symbols_, scene_);
    vector();
  }

  void moment() {
    load_.point.body = read_body_name(table_.at("body", "the name of a body"), scene_);
    vector();
  }

  void vector() {
    load_.vector = magnitudes_.vector(table_.at("vector", "a list of 3 numbers, names or expressions"));
    if (const auto axes = table_.find("axes"))
      load_.axes = static_cast<Axes>(chosen_word(*axes, {"inertial", "body", "lower"}));
    if (load_.point.body == 0)
      fail(table_.place(), "a load on the inertial frame, which nothing moves", "the name of a body");
    const auto reaction = table_.find("reaction");
    if (!reaction) return;
    load_.reaction = read_body_name(*reaction, scene_);
    if (load_.reaction == load_.point.body) reaction->refuse("another body than the one that the load acts on");
  }

  void joint() {
    read_coordinate(table_.at("coordinate", "the name of a coordinate, as \"theta_2\""), scene_, load_);
    read_restoring(table_, true, magnitudes_, load_);
  }

  void spring() {
    load_.point = read_load_point(table_, "", symbols_, scene_);
    load_.other = read_load_point(table_, "other_", symbols_, scene_);
    if (load_.point.body == load_.other.body)
      fail(table_.place(), "a spring between two points of one body, which does nothing", "points of two bodies");
    read_restoring(table_, false, magnitudes_, load_);
    if (load_.rest.kind == Number::Kind::constant && load_.rest.value < 0)
      table_.at("rest", "").refuse("a length: zero or positive");
  }

  const Table& table_;
  Magnitudes& magnitudes_;
  Symbols& symbols_;
  const Scene& scene_;
  Load load_;
};

void read_load(const Node& node, int number, Magnitudes& magnitudes, Symbols& symbols, Scene& scene) {
  Place place = node.place();
  place.field.clear();
  place.body = "load " + std::to_string(number);
  std::string name = "load_" + std::to_string(number);
  const auto name_node = Table(Node(node.value(), place), "").find("name");
  if (name_node) {
    name = read_name(*name_node);
    place.body += " (" + name + ")";
  }
  for (const Load& other : scene.loads)
    if (other.name == name)
      fail(name_node ? name_node->place() : place, in_quotes(name) + ", the name of another load", "another name");
  const Table table(Node(node.value(), place), "");
  scene.loads.push_back(LoadReader(table, magnitudes, symbols, scene).read(name));
}

}  // namespace

void read_body_loads(const BodyTable& from, int k, Magnitudes& magnitudes, Scene& scene) {
  const Table& table = from.table;
  Body& body = scene.bodies[static_cast<std::size_t>(k - 1)];
  if (const auto force = table.find("force")) body.force = magnitudes.vector(*force);
  if (const auto moment = table.find("moment")) body.moment = magnitudes.vector(*moment);
  const KeyWords keys = {"effort", "stiffness", "damping", "rest"};
  if (std::none_of(keys.begin(), keys.end(), [&](const std::string& key) { return table.find(key); })) return;
  Load load;
  load.kind = LoadKind::joint;
  load.name = from.name;
  load.point.body = k;
  load.turn = from.kind->turns == 1;
  read_restoring(table, true, magnitudes, load);
  scene.loads.push_back(load);
}

void read_loads(const Table& root, Magnitudes& magnitudes, Symbols& symbols, Scene& scene) {
  const std::optional<Node> node = root.find("load");
  if (!node) return;
  int number = 0;
  for (const Node& load : node->list("[[load]] tables")) read_load(load, ++number, magnitudes, symbols, scene);
}

}  // namespace kanec::scene
