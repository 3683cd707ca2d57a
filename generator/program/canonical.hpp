// A section of a function in a form that is the same for sections that do the same: operations numbered in an order
// that depends on their structure alone, what they read by its kind alone. Not: the classes made of it (rolled.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <vector>

#include "generator/program/section.hpp"
#include "generator/program/signs.hpp"

namespace kanec::program {

// What a section reads and does not make.
enum class LeafKind : std::uint8_t { constant, x, y, ydot, input, time, prepared, frame };

struct Canonical {
  std::vector<std::int64_t> key;                // equal for sections that do the same
  std::vector<Index> operations;                // nodes in order, operands before users
  std::vector<std::vector<std::size_t>> order;  // of the operands of each
  std::vector<Ref> leaves;  // nodes read, once for every place where one is read, in order; constants with signs
};

LeafKind leaf_kind(const Node& node, Stage stage);

// number: of the section in the list.
Canonical canonical(const Program& program, const Sections& sections, std::size_t number,
                    const std::vector<Stage>& stages, const Signs& signs);

}  // namespace kanec::program
