// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/read_ensemble.hpp"

#include <algorithm>
#include <optional>

namespace kanec::scene {
namespace {

constexpr auto drawing_rule = "{uniform = [least, largest]} or {normal = [mean, standard deviation]}";

void check_draw(const Draw& draw, const Node& node) {
  if (draw.kind == Draw::Kind::uniform && draw.a > draw.b)
    fail(node.place(), "a least value above the largest", "[least, largest]");
  if (draw.kind == Draw::Kind::normal && draw.b < 0)
    fail(node.place(), "a negative standard deviation", "[mean, standard deviation]");
}

Draw read_draw(const Table::Entry& entry, const std::string& name) {
  const Table table(entry.node, "ensemble." + entry.key + ".");
  table.only({"uniform", "normal"});
  const std::vector<Table::Entry> entries = table.entries();
  if (entries.size() != 1) entry.node.refuse(drawing_rule);
  const std::vector<Node> numbers = entries[0].node.list(2, "a list of 2 numbers");
  const Draw draw{name, entries[0].key == "uniform" ? Draw::Kind::uniform : Draw::Kind::normal, numbers[0].real(),
                  numbers[1].real()};
  check_draw(draw, entries[0].node);
  return draw;
}

int integer(const Table& table, const std::string& key, int least, int largest, int otherwise) {
  const std::optional<Node> node = table.find(key);
  if (!node) return otherwise;
  const std::string allowed = "a whole number from " + std::to_string(least) + " to " + std::to_string(largest);
  const int value = node->integer(allowed);
  if (value < least || value > largest) node->refuse(allowed);
  return value;
}

}  // namespace

std::vector<std::string> scenario_names(const Scene& scene) {
  std::vector<std::string> names = in_words(scene, coordinate_names(scene));
  for (const std::string& name : in_words(scene, speed_names(scene))) names.push_back(name);
  for (const Named& named : scene.parameters) names.push_back(named.name);
  for (const Named& named : scene.inputs) names.push_back(named.name);
  return names;
}

std::string scenario_name(const EntryNames& entries, const std::string& given) {
  const std::optional<Entry> entry = entries.find(given);
  if (!entry || entry->among == Entry::Among::ydot) return "";
  return entries.printed(entry->among)[static_cast<std::size_t>(entry->index)];
}

Ensemble read_ensemble(const Table& root, const Scene& scene) {
  const std::optional<Node> node = root.find("ensemble");
  if (!node) return {};
  const Table table(*node, "ensemble.");
  Ensemble out;
  out.count = integer(table, "count", 1, most_scenarios, 100);
  out.seed = integer(table, "seed", 0, 2'147'483'647, 1);
  const EntryNames names(scene);
  for (const Table::Entry& entry : table.entries()) {
    if (entry.key == "count" || entry.key == "seed") continue;
    const std::string name = scenario_name(names, entry.key);
    if (name.empty())
      fail(entry.node.place(), "an unknown name",
           "count, seed, or a coordinate, speed, parameter or input: " + one_of(scenario_names(scene), entry.key));
    const auto is_drawn = [&](const Draw& draw) { return draw.name == name; };
    if (std::any_of(out.draws.begin(), out.draws.end(), is_drawn))
      fail(entry.node.place(), "what is drawn already as " + name, "each name once");
    out.draws.push_back(read_draw(entry, name));
  }
  return out;
}

}  // namespace kanec::scene
