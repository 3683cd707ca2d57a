// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/body.hpp"

#include <algorithm>
#include <optional>

#include "generator/read/check.hpp"
#include "generator/read/read_joint.hpp"
#include "generator/read/read_motion.hpp"

namespace kanec::scene {
namespace {

const char* const inertia_shape = "3 principal moments, or 3 rows of 3 (about the mass centre, body axes)";

std::string body_name(const Table& table, int k) {
  const std::optional<Node> node = table.find("name");
  if (!node) return "body_" + std::to_string(k);
  std::string name = read_name(*node);
  if (name == "ground") fail(node->place(), in_quotes(name) + ", the inertial frame", "another name");
  return name;
}

Symmetric diagonal(const std::vector<Node>& moments, Symbols& symbols) {
  Symmetric out;
  out.xx = symbols.constant_or_parameter(moments[0]);
  out.yy = symbols.constant_or_parameter(moments[1]);
  out.zz = symbols.constant_or_parameter(moments[2]);
  return out;
}

Symmetric full(const std::vector<Node>& rows, const Place& place, Symbols& symbols) {
  std::array<Vector, 3> entry;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::vector<Node> row = rows[i].list(3, "a row of 3 numbers or names: " + std::string(inertia_shape));
    for (std::size_t j = 0; j < 3; ++j) entry[i][j] = symbols.constant_or_parameter(row[j]);
  }
  const auto named = [&](std::size_t i, std::size_t j) {
    return "inertia[" + std::to_string(i + 1) + "][" + std::to_string(j + 1) + "] is " + symbols.shown(entry[i][j]);
  };
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = i + 1; j < 3; ++j)
      if (entry[i][j] != entry[j][i])
        fail(place, named(i, j) + ", " + named(j, i), "a symmetric matrix: the same number or name in both");
  return {entry[0][0], entry[1][1], entry[2][2], entry[0][1], entry[0][2], entry[1][2]};
}

Symmetric read_inertia(const Node& node, Symbols& symbols) {
  const std::vector<Node> rows = node.list(3, inertia_shape);
  const bool matrix = std::any_of(rows.begin(), rows.end(), [](const Node& row) { return row.is_list(); });
  return matrix ? full(rows, node.place(), symbols) : diagonal(rows, symbols);
}

Vector vector_or_zero(const Table& table, const char* key, Symbols& symbols) {
  const std::optional<Node> node = table.find(key);
  return node ? symbols.vector(*node) : Vector{};
}

// Refuses keys that no body has as unknown ones, and those of other joints with what this one takes.
void check_keys(const Table& table, const JointKind& kind) {
  std::vector<std::string> own = {"name", "joint"};
  own.insert(own.end(), kind.keys.begin(), kind.keys.end());
  for (const char* key : {"mass", "inertia", "r", "q", "force", "moment", "initial", "motion"}) own.emplace_back(key);
  const std::vector<std::string>& all = joint_keys();
  for (const auto& [key, node] : table.entries())
    if (std::find(all.begin(), all.end(), key) != all.end() && !kind.takes(key))
      fail(node.place(), "a key that joint \"" + kind.name + "\" does not have",
           kind.keys.empty() ? "none of its own" : one_of(kind.keys, key));
  table.only(own);
}

}  // namespace

BodyTable read_body_table(const Node& node, int k) {
  Place place = node.place();
  place.field.clear();
  place.body = "body " + std::to_string(k);
  std::string name = body_name(Table(Node(node.value(), place), ""), k);
  if (name != "body_" + std::to_string(k)) place.body += " (" + name + ")";
  BodyTable out{Table(Node(node.value(), place), ""), std::move(name)};
  out.kind = &read_joint_kind(out.table);
  check_keys(out.table, *out.kind);
  return out;
}

Body read_body(const BodyTable& from, Symbols& symbols, Scene& scene) {
  const Table& table = from.table;
  Body body;
  body.name = from.name;
  body.joint = read_joint(table, *from.kind, scene.notes);
  const Node mass = table.at("mass", "a number or the name of a parameter [kg]");
  const Node inertia = table.at("inertia", inertia_shape);
  body.mass = symbols.constant_or_parameter(mass);
  check_mass(body.mass, symbols, mass.place());
  body.inertia = read_inertia(inertia, symbols);
  check_inertia(body.inertia, symbols, inertia.place());
  body.r = vector_or_zero(table, "r", symbols);
  body.q = vector_or_zero(table, "q", symbols);
  read_initial(table, *from.kind, body, scene.notes);
  return body;
}

}  // namespace kanec::scene
