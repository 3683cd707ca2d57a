// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/body.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "generator/scene/check.hpp"
#include "runtime/base/text.hpp"

namespace kanec::scene {
namespace {

const char* const inertia_shape = "3 principal moments, or 3 rows of 3 (about the mass centre, body axes)";
constexpr double worst_norm = 1e-6;  // Euler parameters written with fewer digits than this are worth a note

std::string body_name(const Table& table, int k) {
  const std::optional<Node> node = table.find("name");
  return node ? read_name(*node) : "body_" + std::to_string(k);
}

Joint read_joint(const Table& table) {
  const std::optional<Node> node = table.find("joint");
  const std::vector<std::string> kinds = {"free"};
  if (node && node->text("free") != "free") node->refuse(one_of(kinds, node->text("free")));
  return {};
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

template <std::size_t n>
void read_numbers(const Table& table, const char* key, std::array<double, n>& out) {
  const std::optional<Node> node = table.find(key);
  if (!node) return;
  const std::vector<Node> list = node->list(n, "a list of " + std::to_string(n) + " numbers");
  for (std::size_t i = 0; i < n; ++i) out[i] = list[i].real("a finite number (names are not for the initial state)");
}

// To unit norm in full precision; a note where the norm was far from it.
void normalise(std::array<double, 4>& eps, const Place& place, std::vector<std::string>& notes) {
  long double square = 0;
  for (const double e : eps) square += static_cast<long double>(e) * e;
  const long double norm = std::sqrt(square);
  if (norm == 0) fail(place, "Euler parameters of norm 0", "any other four numbers, scalar last; they are normalised");
  for (double& e : eps) e = static_cast<double>(e / norm);
  if (std::fabs(norm - 1) > worst_norm)
    notes.push_back(
        remark(place, "Euler parameters of norm " + shortest(static_cast<double>(norm)) + ", normalised to 1"));
}

void read_state(const Table& table_of_body, Body& body, std::vector<std::string>& notes) {
  const std::optional<Node> node = table_of_body.find("initial");
  if (!node) return;
  const Table table(*node, "initial.");
  table.only({"eps", "omega", "s", "sdot"});
  read_numbers(table, "eps", body.initial.eps);
  read_numbers(table, "omega", body.initial.omega);
  std::array<double, 3> s{}, sdot{};
  read_numbers(table, "s", s);
  read_numbers(table, "sdot", sdot);
  for (std::size_t i = 0; i < 3; ++i) {
    body.joint.slides[i].value = s[i];
    body.joint.slides[i].rate = sdot[i];
  }
  if (const auto eps = table.find("eps")) normalise(body.initial.eps, eps->place(), notes);
}

Vector vector_or_zero(const Table& table, const char* key, Symbols& symbols, Number (Symbols::*read)(const Node&)) {
  const std::optional<Node> node = table.find(key);
  return node ? symbols.vector(*node, read) : Vector{};
}

// The table, with "body 3 (arm)" in every place.
Table located(const Node& node, int k, std::string* name) {
  Place place = node.place();
  place.field.clear();
  place.body = "body " + std::to_string(k);
  *name = body_name(Table(Node(node.value(), place), ""), k);
  if (*name != "body_" + std::to_string(k)) place.body += " (" + *name + ")";
  return Table(Node(node.value(), place), "");
}

}  // namespace

Body read_body(const Node& node, int k, Symbols& symbols, Scene& scene) {
  Body body;
  const Table table = located(node, k, &body.name);
  table.only({"name", "joint", "mass", "inertia", "r", "q", "force", "moment", "initial"});
  body.joint = read_joint(table);
  const Node mass = table.at("mass", "a positive number or the name of a parameter [kg]");
  const Node inertia = table.at("inertia", inertia_shape);
  body.mass = symbols.constant_or_parameter(mass);
  check_mass(body.mass, symbols, mass.place());
  body.inertia = read_inertia(inertia, symbols);
  if (auto warning = check_inertia(body.inertia, symbols, inertia.place())) scene.warnings.push_back(*warning);
  body.r = vector_or_zero(table, "r", symbols, &Symbols::constant_or_parameter);
  body.q = vector_or_zero(table, "q", symbols, &Symbols::constant_or_parameter);
  body.force = vector_or_zero(table, "force", symbols, &Symbols::any);
  body.moment = vector_or_zero(table, "moment", symbols, &Symbols::any);
  read_state(table, body, scene.notes);
  return body;
}

}  // namespace kanec::scene
