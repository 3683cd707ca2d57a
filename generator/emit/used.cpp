// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/used.hpp"

#include <algorithm>
#include <set>

namespace kanec::emit {
namespace {

using program::Group;

std::set<program::Index> entries_read(const program::Program& program, const std::vector<bool>& alive, Group group) {
  std::set<program::Index> result;
  for (std::size_t i = 0; i < alive.size(); ++i) {
    const auto* variable = std::get_if<program::Variable>(&program.nodes[i]);
    if (alive[i] && variable != nullptr && variable->group == group) result.insert(variable->index);
  }
  return result;
}

}  // namespace

Used used(const scene::Scene& scene, const program::Program& program) {
  const std::vector<bool> alive = reachable(program);
  Used result;
  const bool by_inputs = std::any_of(program.functions.begin(), program.functions.end(),
                                     [](const program::Function& f) { return f.signature.by_inputs; });
  const auto divide = [&](const std::vector<scene::Named>& list, Group group, std::vector<scene::Named>& read) {
    const std::set<program::Index> entries = entries_read(program, alive, group);
    const bool all = by_inputs && group == Group::input;
    for (std::size_t i = 0; i < list.size(); ++i)
      (all || entries.count(static_cast<program::Index>(i)) > 0 ? read : result.left_out).push_back(list[i]);
  };
  divide(scene.parameters, Group::parameter, result.parameters);
  divide(scene.inputs, Group::input, result.inputs);
  return result;
}

}  // namespace kanec::emit
