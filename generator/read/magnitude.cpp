// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/magnitude.hpp"

#include <cmath>
#include <utility>

#include "generator/read/expression_names.hpp"
#include "generator/scene/expression_value.hpp"
#include "runtime/base/text.hpp"

namespace kanec::scene {

Magnitudes::Magnitudes(Scene& scene, Symbols& symbols)
    : scene_(scene), symbols_(symbols), names_(names_for_loads(scene)) {}

Number Magnitudes::number(const Node& node) {
  constexpr auto allowed = "a finite number, the name of a parameter or input, or an expression in quotes";
  if (!node.is_text()) return Number::constant(node.real(allowed));
  const std::string text = node.text(allowed);
  if (const auto named = symbols_.find(text)) return *named;
  Expression expression = parse_expression(text, node.place(), names_);
  symbols_.mark_used(expression);
  if (!has_finite_constants(expression)) fail(node.place(), in_quotes(text) + ", which is not finite", allowed);
  if (!is_constant(expression)) {
    scene_.expressions.push_back(std::move(expression));
    return Number::expression(static_cast<int>(scene_.expressions.size()) - 1);
  }
  return Number::constant(static_cast<double>(value(expression, {})));
}

Number Magnitudes::not_negative(const Node& node, const std::string& note) {
  const Number read = number(node);
  if (read.kind == Number::Kind::constant && read.value < 0)
    scene_.notes.push_back(remark(node.place(), "found " + shortest(read.value) + ", " + note));
  return read;
}

Vector Magnitudes::vector(const Node& node) {
  Vector out;
  const std::vector<Node> list = node.list(3, "a list of 3 numbers, names or expressions");
  for (std::size_t i = 0; i < 3; ++i) out[i] = number(list[i]);
  return out;
}

}  // namespace kanec::scene
