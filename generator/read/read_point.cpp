// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/read_point.hpp"

#include <optional>
#include <vector>

namespace kanec::scene {
namespace {

constexpr auto body_rule = "the name of a body, or \"ground\", the inertial frame";

std::vector<std::string> body_names(const Scene& scene) {
  std::vector<std::string> names = {"ground"};
  for (const Body& body : scene.bodies) names.push_back(body.name);
  return names;
}

Vector read_r(const Table& table, const std::string& key, Symbols& symbols) {
  const std::optional<Node> node = table.find(key);
  return node ? symbols.vector(*node) : Vector{};
}

void read_point(const Node& node, Symbols& symbols, Scene& scene) {
  const Table table(node, node.place().field + ".");
  table.only({"name", "body", "r"});
  Point point;
  const Node name = table.at("name", "the name of the point");
  point.name = read_name(name);
  for (const Point& other : scene.points)
    if (other.name == point.name)
      fail(name.place(), in_quotes(point.name) + ", the name of another point", "another name");
  point.body = read_body_name(table.at("body", body_rule), scene);
  point.r = read_r(table, "r", symbols);
  scene.points.push_back(point);
}

Point named_point(const Node& node, const Scene& scene) {
  std::vector<std::string> names;
  for (const Point& point : scene.points) names.push_back(point.name);
  const std::string name = node.text("the name of one of [[point]]");
  for (const Point& point : scene.points)
    if (point.name == name) return point;
  node.refuse(names.empty() ? "the name of one of [[point]] (this scene has none)"
                            : "the name of one of [[point]]: " + one_of(names, name));
}

}  // namespace

int read_body_name(const Node& node, const Scene& scene) {
  const std::vector<std::string> names = body_names(scene);
  const std::string name = node.text(body_rule);
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return static_cast<int>(k);
  node.refuse("the name of a body, or ground: " + one_of(names, name));
}

void read_points(const Table& root, Symbols& symbols, Scene& scene) {
  const std::optional<Node> node = root.find("point");
  if (!node) return;
  for (const Node& point : node->list("[[point]] tables")) read_point(point, symbols, scene);
}

Point read_load_point(const Table& load, const std::string& prefix, Symbols& symbols, const Scene& scene) {
  const std::optional<Node> named = load.find(prefix + "point");
  const std::optional<Node> body = load.find(prefix + "body"), r = load.find(prefix + "r");
  if (named && (body || r))
    fail((body ? body : r)->place(), "a place beside " + prefix + "point",
         prefix + "point, or " + prefix + "body and " + prefix + "r");
  if (named) return named_point(*named, scene);
  Point point;
  point.body = read_body_name(load.at(prefix + "body", std::string(body_rule) + " (or " + prefix + "point)"), scene);
  point.r = read_r(load, prefix + "r", symbols);
  return point;
}

}  // namespace kanec::scene
