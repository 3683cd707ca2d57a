// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/read_motion.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "generator/scene/expression_value.hpp"
#include "runtime/base/text.hpp"

namespace kanec::scene {
namespace {

constexpr double worst_norm = 1e-6;  // Euler parameters written with fewer digits than this are worth a note
constexpr auto initial_number = "a finite number (names are not for the initial state)";
constexpr auto motion_entry =
    "a number (locked there), an expression of t and parameters in quotes (prescribed), or \"free\"";

// Refuses keys that no joint has as unknown ones, and those of other joints with what this one has.
void check_motion_keys(const Table& table, const std::vector<std::string>& own, const std::vector<std::string>& all,
                       const JointKind& kind) {
  for (const auto& [key, node] : table.entries()) {
    if (std::find(own.begin(), own.end(), key) != own.end()) continue;
    const bool known = std::find(all.begin(), all.end(), key) != all.end();
    const std::string joint = "joint \"" + kind.name + "\"";
    const std::string keys = own.empty() ? "none: " + joint + " has no coordinates" : one_of(own, known ? "" : key);
    fail(node.place(), known ? "a key that " + joint + " does not have" : "an unknown key", keys);
  }
}

template <std::size_t n>
void read_numbers(const Table& table, const char* key, std::array<double, n>& out) {
  const std::optional<Node> node = table.find(key);
  if (!node) return;
  const std::vector<Node> list = node->list(n, "a list of " + std::to_string(n) + " numbers");
  for (std::size_t i = 0; i < n; ++i) out[i] = list[i].real(initial_number);
}

// One entry a coordinate: the value itself where there is one coordinate, else a list.
std::vector<Node> entries(const Node& node, std::size_t n, const std::string& entry, const std::string& list) {
  if (n > 1) return node.list(n, "a list of " + std::to_string(n) + " " + list);
  if (node.is_list()) node.refuse(entry);
  return {node};
}

void read_numbers(const Table& table, const char* key, std::vector<Coordinate>& coordinates,
                  double Coordinate::*member) {
  const std::optional<Node> node = table.find(key);
  if (!node) return;
  const std::vector<Node> list = entries(*node, coordinates.size(), initial_number, "numbers");
  for (std::size_t i = 0; i < list.size(); ++i) coordinates[i].*member = list[i].real(initial_number);
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

void hold(const Node& node, Body& body) {
  if (!node.is_text() || node.text("") != "hold") node.refuse("\"hold\": the attitude stays at initial.eps");
  for (const double omega : body.initial.omega)
    if (omega != 0) fail(node.place(), "a held attitude beside an initial.omega", "no initial.omega, or zero");
  body.joint.held = true;
}

// A motion that does not change: of a number, or of an expression of numbers alone.
std::optional<double> constant(const Node& node, const std::optional<Expression>& expression) {
  if (!expression) return node.real(motion_entry);
  if (!has_finite_constants(*expression))
    fail(node.place(), in_quotes(expression->text) + ", which is not finite", motion_entry);
  if (!is_constant(*expression)) return std::nullopt;
  return static_cast<double>(value(*expression, {}));
}

class MotionReader {
 public:
  MotionReader(const Table& table, Scene& scene, const std::vector<ExpressionName>& names)
      : table_(table), scene_(scene), names_(names) {}

  void read(const char* key, std::vector<Coordinate>& coordinates) {
    const std::optional<Node> node = table_.find(key);
    if (!node) return;
    const std::vector<Node> list =
        entries(*node, coordinates.size(), motion_entry, "entries: " + std::string(motion_entry));
    for (std::size_t i = 0; i < list.size(); ++i) read(list[i], coordinates[i]);
  }

 private:
  void read(const Node& node, Coordinate& coordinate) {
    if (node.is_text() && node.text("") == "free") return;
    if (coordinate.value != 0 || coordinate.rate != 0)
      fail(node.place(), "a motion beside an initial value or rate of the same coordinate",
           "one of them (0 in a list of initial values)");
    std::optional<Expression> expression;
    if (node.is_text()) expression = parse_expression(node.text(""), node.place(), names_);
    if (const auto value = constant(node, expression)) {
      coordinate.motion = Coordinate::Motion::locked;
      coordinate.value = *value;
      return;
    }
    coordinate.motion = Coordinate::Motion::prescribed;
    coordinate.expression = static_cast<int>(scene_.expressions.size());
    scene_.expressions.push_back(*expression);
  }

  const Table& table_;
  Scene& scene_;
  const std::vector<ExpressionName>& names_;
};

}  // namespace

void read_initial(const Table& body_table, const JointKind& kind, Body& body, std::vector<std::string>& notes) {
  const std::optional<Node> node = body_table.find("initial");
  if (!node) return;
  const Table table(*node, "initial.");
  check_motion_keys(table, kind.initial_keys(), {"eps", "omega", "theta", "thetadot", "s", "sdot"}, kind);
  read_numbers(table, "eps", body.initial.eps);
  read_numbers(table, "omega", body.initial.omega);
  read_numbers(table, "theta", body.joint.turns, &Coordinate::value);
  read_numbers(table, "thetadot", body.joint.turns, &Coordinate::rate);
  read_numbers(table, "s", body.joint.slides, &Coordinate::value);
  read_numbers(table, "sdot", body.joint.slides, &Coordinate::rate);
  const auto note = [&](const Node& found, const std::string& text) { notes.push_back(remark(found.place(), text)); };
  for (const Coordinate& turn : body.joint.turns)
    if (std::fabs(turn.value) > 2 * std::numbers::pi)
      note(*table.find("theta"), "found " + shortest(turn.value) + ", more than a turn: angles are in rad");
  const auto eps = table.find("eps");
  if (!eps) return;
  normalise(body.initial.eps, eps->place(), notes);
  if (std::fabs(body.initial.eps[0]) == 1)
    note(*eps, "half a turn about x: the scalar part is the last of the four, [0, 0, 0, 1] is no turn");
}

void read_motion(const Table& body_table, const JointKind& kind, int k, const std::vector<ExpressionName>& names,
                 Scene& scene) {
  const std::optional<Node> node = body_table.find("motion");
  if (!node) return;
  const Table table(*node, "motion.");
  check_motion_keys(table, kind.motion_keys(), {"eps", "theta", "s"}, kind);
  Body& body = scene.bodies[static_cast<std::size_t>(k - 1)];
  if (const auto eps = table.find("eps")) hold(*eps, body);
  MotionReader reader(table, scene, names);
  reader.read("theta", body.joint.turns);
  reader.read("s", body.joint.slides);
}

}  // namespace kanec::scene
