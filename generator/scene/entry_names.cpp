// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/entry_names.hpp"

#include <algorithm>

namespace kanec::scene {
namespace {

std::vector<std::string> names_of(const std::vector<Named>& list) {
  std::vector<std::string> names;
  for (const Named& named : list) names.push_back(named.name);
  return names;
}

}  // namespace

std::string name_by_body(const Scene& scene, const std::string& name) {
  const std::size_t first = name.find('_') + 1;
  const std::size_t end = std::min(name.find('_', first), name.size());
  const std::size_t k = std::stoul(name.substr(first, end - first));
  return name.substr(0, first) + scene.bodies[k - 1].name + name.substr(end);
}

EntryNames::EntryNames(const Scene& scene) {
  using enum Entry::Among;
  const std::vector<std::string> lists[] = {coordinate_names(scene), speed_names(scene), speed_rate_names(scene),
                                            names_of(scene.parameters), names_of(scene.inputs)};
  for (const Entry::Among among : {x, y, ydot, parameters, inputs}) {
    const auto at = static_cast<std::size_t>(among);
    numbered_[at] = lists[at];
    for (int i = 0; i < static_cast<int>(lists[at].size()); ++i) entries_[lists[at][static_cast<std::size_t>(i)]] = Entry{among, i};
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
