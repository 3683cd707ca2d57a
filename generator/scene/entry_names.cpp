// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/entry_names.hpp"

#include <algorithm>
#include <set>

#include "generator/scene/component.hpp"

namespace kanec::scene {
namespace {

std::vector<std::string> names_of(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& named : list) names.push_back(named.name);
  return names;
}

// "theta_", 3 and "_2" of "theta_3_2".
struct Numbered {
  explicit Numbered(const std::string& name) {
    const std::size_t first = name.find('_') + 1;
    const std::size_t end = std::min(name.find('_', first), name.size());
    letter = name.substr(0, first);
    body = std::stoul(name.substr(first, end - first));
    component = name.substr(end);
  }
  std::string with(const std::string& word) const { return letter + word + component; }

  std::string letter, component;
  std::size_t body;
};

// Not such that every body has it anyway.
bool is_own(const std::string& name, int k) {
  return name != "body_" + std::to_string(k) && name != "body" + std::to_string(k);
}

}  // namespace

std::string name_by_body(const Scene& scene, const std::string& name) {
  const Numbered parts(name);
  return parts.with(scene.bodies[parts.body - 1].name);
}

std::vector<std::string> body_words(const Scene& scene) {
  std::map<std::string, std::set<int>> bodies;  // that have a coordinate of that name, whether in the state or not
  for (const Component& component : components(scene)) {
    bodies[coordinate_name(component)].insert(component.body);
    bodies[coordinate_name_by_body(scene, component)].insert(component.body);
  }
  for (const auto* list : {&scene.parameters, &scene.inputs})
    for (const Named& named : *list) bodies[named.name].insert(0);
  std::vector<std::string> words;
  for (int k = 1; k <= size(scene); ++k) {
    const std::string& name = scene.bodies[static_cast<std::size_t>(k - 1)].name;
    words.push_back(is_own(name, k) ? name : std::to_string(k));
  }
  for (const Component& component : components(scene))
    if (bodies[coordinate_name_by_body(scene, component)].size() > 1)
      words[static_cast<std::size_t>(component.body - 1)] = std::to_string(component.body);
  return words;
}

std::string in_words(const std::string& name, const std::vector<std::string>& words) {
  const Numbered parts(name);
  return parts.with(words[parts.body - 1]);
}

std::vector<std::string> in_words(const Scene& scene, std::vector<std::string> names) {
  const std::vector<std::string> words = body_words(scene);
  for (std::string& name : names) name = in_words(name, words);
  return names;
}

EntryNames::EntryNames(const Scene& scene) {
  using enum Entry::Among;
  const std::vector<std::string> lists[] = {coordinate_names(scene), speed_names(scene), speed_rate_names(scene),
                                            names_of(scene.parameters), names_of(scene.inputs)};
  for (const Entry::Among among : {x, y, ydot, parameters, inputs}) {
    const auto at = static_cast<std::size_t>(among);
    numbered_[at] = lists[at];
    printed_[at] = among == parameters || among == inputs ? lists[at] : in_words(scene, lists[at]);
    for (int i = 0; i < static_cast<int>(lists[at].size()); ++i)
      entries_[lists[at][static_cast<std::size_t>(i)]] = Entry{among, i};
  }
  for (const Entry::Among among : {x, y, ydot}) {
    const auto at = static_cast<std::size_t>(among);
    for (int i = 0; i < static_cast<int>(lists[at].size()); ++i) {
      by_body_[at].push_back(name_by_body(scene, lists[at][static_cast<std::size_t>(i)]));
      add(by_body_[at].back(), {among, i});
    }
  }
}

void EntryNames::add(const std::string& name, const Entry& entry) {
  const auto [at, is_new] = entries_.try_emplace(name, entry);
  if (is_new) return;
  const std::optional<Entry>& other = at->second;
  if (!other || other->among != entry.among || other->index != entry.index) at->second.reset();
}

std::optional<Entry> EntryNames::find(const std::string& name) const {
  const auto found = entries_.find(name);
  return found == entries_.end() ? std::nullopt : found->second;
}

std::vector<std::string> EntryNames::known(const std::vector<Entry::Among>& among) const {
  std::vector<std::string> names;
  for (const Entry::Among one : among) {
    const auto at = static_cast<std::size_t>(one);
    for (std::size_t i = 0; i < numbered_[at].size(); ++i) {
      names.push_back(numbered_[at][i]);
      if (i >= by_body_[at].size() || by_body_[at][i] == numbered_[at][i]) continue;
      if (find(by_body_[at][i])) names.push_back(by_body_[at][i]);
    }
  }
  return names;
}

}  // namespace kanec::scene
