// SPDX-License-Identifier: BSD-3-Clause
#include "generator/program/footprint.hpp"

#include <algorithm>
#include <vector>

namespace kanec::program {
namespace {

constexpr std::size_t bytes_an_operation = 9;
constexpr std::size_t bytes_a_load = 5;  // often part of an operation
constexpr std::size_t bytes_a_number = 8;

// The function's operations in the order in which they are written.
std::vector<Index> in_order(const Program& program, const Function& function) {
  const std::vector<Stage> stage = stages(program);
  const Sections all = sections(program, function, stage);
  const Signs signs(program, function, stage);
  std::vector<Index> result;
  for (std::size_t i = 0; i < all.list.size(); ++i) {
    const Canonical form = canonical(program, all, i, stage, signs);
    result.insert(result.end(), form.operations.begin(), form.operations.end());
  }
  return result;
}

// Results that are made and not yet used for the last time, at most.
std::size_t most_live(const Program& program, const std::vector<Index>& order) {
  std::vector<std::size_t> last(program.nodes.size(), 0);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const Operands from = operands(program.nodes[at(order[i])]);
    for (int j = 0; j < from.count; ++j) last[at(from.at[j])] = i;
  }
  std::vector<std::size_t> ends(order.size() + 1, 0);
  std::size_t live = 0, most = 0;
  for (std::size_t i = 0; i < order.size(); ++i) {
    live -= ends[i];
    if (last[at(order[i])] > i) {
      ++live;
      ++ends[last[at(order[i])]];
    }
    most = std::max(most, live);
  }
  return most;
}

// Loads and stores of a section body, and its rows in the tables.
std::size_t section_bytes(const SectionClass& kind) {
  const auto members = kind.bodies.size();
  std::size_t bytes = bytes_an_operation * (kind.kept.size() + kind.outputs.size());
  for (const Leaf& leaf : kind.leaves) {
    if (leaf.kind != LeafKind::constant) bytes += bytes_a_load;
    if (leaf.kind == LeafKind::constant) bytes += bytes_a_number * members;
  }
  for (const Node& node : kind.body.nodes) bytes += operands(node).count > 0 ? bytes_an_operation : 0;
  const bool has_rows = members > 1;
  return bytes + (has_rows ? 6 * members : 0);  // some six columns of one or two bytes, and the steps
}

}  // namespace

Footprint straight_footprint(const Program& program, const Function& function) {
  const std::vector<Index> order = in_order(program, function);
  return {bytes_an_operation * order.size(), bytes_a_number * most_live(program, order)};
}

Footprint rolled_footprint(const Rolled& rolled) {
  Footprint result{0, bytes_a_number * at(rolled.frames_size)};
  for (const SectionClass& kind : rolled.classes) result.code += section_bytes(kind);
  return result;
}

}  // namespace kanec::program
