// From the text of an expression to its steps, with every error at its column. Not: which names a scene offers
// (expression_names.hpp), or values.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "generator/scene/expression.hpp"
#include "generator/scene/place.hpp"

namespace kanec::scene {

inline constexpr std::size_t longest_expression = 4096;  // characters
inline constexpr int deepest_expression = 64;            // parentheses, signs and powers within each other

// A name that an expression may hold, or one whose use is refused with a reason.
struct ExpressionName {
  std::string name;
  ExpressionNode node;
  std::string refusal = {};  // "is locked at 0.3; allowed instead: ..."; empty: allowed
};

// Grammar: sums and differences of products and quotients of signed powers; powers group from the right and bind
// tighter than signs, -a^b = -(a^b); operands are numbers, `pi`, names, calls of the closed list, and parentheses.
// Throws SceneError at `place`.
Expression parse_expression(std::string_view text, const Place& place, const std::vector<ExpressionName>& names);

// "sin", …: the functions that an expression may call.
const std::vector<std::string>& call_names();

}  // namespace kanec::scene
