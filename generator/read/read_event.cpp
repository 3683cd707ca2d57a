// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/read_event.hpp"

#include <algorithm>
#include <optional>

namespace kanec::scene {
namespace {

using Words = std::vector<std::string>;

// In the order of Event::Direction and Event::Action.
const Words directions = {"both", "up", "down"};
const Words actions = {"record", "stop", "set"};

std::size_t choice(const Table& table, const char* key, const Words& words, std::size_t otherwise) {
  const std::optional<Node> node = table.find(key);
  if (!node) return otherwise;
  const std::string word = node->text(one_of(words, ""));
  const auto found = std::find(words.begin(), words.end(), word);
  if (found == words.end()) node->refuse(one_of(words, word));
  return static_cast<std::size_t>(found - words.begin());
}

bool reads_motion(const Expression& expression) {
  using NodeKind = ExpressionNode::Kind;
  return std::any_of(expression.nodes.begin(), expression.nodes.end(), [](const ExpressionNode& node) {
    return node.kind == NodeKind::time || node.kind == NodeKind::coordinate || node.kind == NodeKind::speed;
  });
}

Number read_crossing(const Node& node, Magnitudes& magnitudes, const Scene& scene) {
  constexpr auto allowed = "an expression of the time, coordinates or speeds, as \"theta_1 - pi\"";
  if (!node.is_text()) node.refuse(allowed);
  const Number number = magnitudes.number(node);
  const bool moves = number.kind == Number::Kind::expression &&
                     reads_motion(scene.expressions[static_cast<std::size_t>(number.index)]);
  if (!moves) fail(node.place(), in_quotes(node.text(allowed)) + ", which no motion brings to zero", allowed);
  return number;
}

std::vector<Event::Setting> read_settings(const Node& node, Symbols& symbols, const Scene& scene) {
  Words known;
  for (const Named& input : scene.inputs) known.push_back(input.name);
  const Table table(node, node.place().field + ".");
  std::vector<Event::Setting> settings;
  for (const Table::Entry& entry : table.entries()) {
    const auto found = std::find(known.begin(), known.end(), entry.key);
    if (found == known.end())
      fail(entry.node.place(), "an unknown name",
           known.empty() ? "inputs, of which this scene has none" : "inputs of the scene: " + one_of(known, entry.key));
    symbols.find(entry.key);
    settings.push_back({static_cast<int>(found - known.begin()), entry.node.real()});
  }
  if (settings.empty()) fail(node.place(), "an empty table", "values of inputs, as { thrust = 0.0 }");
  return settings;
}

bool read_row(const Table& table) {
  const std::optional<Node> node = table.find("row");
  if (!node) return false;
  const auto value = node->value().value_exact<bool>();
  if (!value) node->refuse("true or false");
  return *value;
}

void check_action(const Table& table, const Event& event, bool has_settings) {
  if (event.action == Event::Action::set && !has_settings)
    fail(table.at("action", "").place(), "\"set\" without the inputs to be set", "set = { input = value } beside it");
  if (event.action != Event::Action::set && has_settings)
    fail(table.at("action", "").place(), in_quotes(actions[static_cast<std::size_t>(event.action)]) + " beside set",
         "\"set\", or no action");
}

Event read_event(const Table& table, const std::string& name, Magnitudes& magnitudes, Symbols& symbols,
                 const Scene& scene) {
  table.only({"name", "expression", "direction", "action", "set", "row"});
  Event event;
  event.name = name;
  event.expression =
      read_crossing(table.at("expression", "an expression that is zero at the event"), magnitudes, scene);
  event.direction = static_cast<Event::Direction>(choice(table, "direction", directions, 0));
  const std::optional<Node> settings = table.find("set");
  event.action = static_cast<Event::Action>(choice(table, "action", actions, settings ? 2 : 0));
  check_action(table, event, settings.has_value());
  if (settings) event.settings = read_settings(*settings, symbols, scene);
  event.row = read_row(table);
  return event;
}

}  // namespace

void read_events(const Table& root, Magnitudes& magnitudes, Symbols& symbols, Scene& scene) {
  const std::optional<Node> list = root.find("event");
  if (!list) return;
  for (const Node& node : list->list("[[event]] tables")) {
    Place place = node.place();
    place.field.clear();
    place.body = "event " + std::to_string(scene.events.size() + 1);
    if (scene.events.size() == most_events) fail(place, "another event", "at most " + std::to_string(most_events));
    const Node named = Table(Node(node.value(), place), "").at("name", "the name of the event");
    const std::string name = read_name(named);
    for (const Event& other : scene.events)
      if (other.name == name) fail(named.place(), in_quotes(name) + ", the name of another event", "another name");
    place.body += " (" + name + ")";
    scene.events.push_back(read_event(Table(Node(node.value(), place), ""), name, magnitudes, symbols, scene));
  }
}

}  // namespace kanec::scene
