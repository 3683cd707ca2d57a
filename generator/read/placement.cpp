// SPDX-License-Identifier: BSD-3-Clause
#include "generator/read/placement.hpp"

#include <algorithm>
#include <cmath>

#include "generator/read/parse_expression.hpp"
#include "generator/scene/expression_value.hpp"
#include "runtime/base/text.hpp"

namespace kanec::scene {
namespace {

constexpr auto direction_shape = "\"x\", \"-y\" and the like, or a list of 3 numbers";
constexpr auto orientation_shape =
    "{ eps = [4 numbers] }, { rpy = [roll, pitch, yaw] } or { x = direction, z = direction }";
constexpr long double snap_margin = 1e-15L;
constexpr long double rounding = 1e-18L;    // some roundings of numbers near 1, in 64 bits
constexpr long double least_angle = 1e-6L;  // between the directions x and z
constexpr auto angle_shape = "an angle [rad]: a number, or a constant expression, as \"pi/2\"";

Direction named_direction(const Node& node) {
  const std::string text = node.text("");
  const bool negative = text.size() == 2 && text[0] == '-';
  const std::string letter = negative ? text.substr(1) : text;
  if (letter != "x" && letter != "y" && letter != "z") node.refuse(direction_shape);
  Direction out = no_turn[static_cast<std::size_t>(letter[0] - 'x')];
  for (long double& entry : out)
    if (negative && entry != 0) entry = -entry;
  return out;
}

template <std::size_t n>
std::array<long double, n> reals(const Node& node, const std::string& allowed) {
  std::array<long double, n> out;
  const std::vector<Node> list = node.list(n, allowed);
  for (std::size_t i = 0; i < n; ++i) out[i] = list[i].real();
  return out;
}

long double angle(const Node& node) {
  if (!node.is_text()) return node.real(angle_shape);
  const Expression expression = parse_expression(node.text(""), node.place(), {});
  const long double angle = value(expression, {});
  if (!std::isfinite(angle)) fail(node.place(), in_quotes(expression.text) + ", which is not finite", angle_shape);
  return angle;
}

Turn of_angles(const Node& node) {
  const std::vector<Node> list = node.list(3, "roll, pitch and yaw [rad]");
  return turn_about(no_turn[2], angle(list[2])) * turn_about(no_turn[1], angle(list[1])) *
         turn_about(no_turn[0], angle(list[0]));
}

Turn of_eps(const Node& node) {
  std::array<long double, 4> eps = reals<4>(node, "4 Euler parameters, scalar last");
  long double square = 0;
  for (const long double e : eps) square += e * e;
  if (square == 0) fail(node.place(), "Euler parameters of norm 0", "any other four numbers; they are normalised");
  for (long double& e : eps) e /= std::sqrt(square);
  return turn_of_eps(eps);
}

Turn of_directions(const Node& x_node, const Node& z_node) {
  const Direction z = unit(read_direction(z_node));
  const Direction x = read_direction(x_node);
  if (norm(cross(z, x)) < least_angle) fail(x_node.place(), "the direction of z", "another direction than that of z");
  const Direction across = sum(x, scaled(-dot(x, z), z));
  return turn_of_columns(unit(sum(across, scaled(-dot(across, z), z))), z);
}

}  // namespace

Direction read_direction(const Node& node) {
  if (node.is_text()) return named_direction(node);
  const Direction out = reals<3>(node, direction_shape);
  if (out == Direction{0, 0, 0}) fail(node.place(), "a direction of length 0", direction_shape);
  return unit(out);
}

Turn read_orientation(const Node& node) {
  if (!node.value().is_table()) node.refuse(orientation_shape);
  const Table table(node, node.place().field + ".");
  table.only({"eps", "rpy", "x", "z"});
  const auto eps = table.find("eps"), rpy = table.find("rpy"), x = table.find("x"), z = table.find("z");
  const int forms = (eps ? 1 : 0) + (rpy ? 1 : 0) + (x || z ? 1 : 0);
  if (forms != 1 || x.has_value() != z.has_value())
    fail(node.place(), forms == 0 ? "an empty table" : "other keys together", orientation_shape);
  if (eps) return of_eps(*eps);
  return rpy ? of_angles(*rpy) : of_directions(*x, *z);
}

double snap(long double value, bool& snapped) {
  for (const long double exact : {0.0L, 1.0L, -1.0L}) {
    const long double off = std::fabs(value - exact);
    if (off >= snap_margin) continue;
    if (off > rounding) snapped = true;
    return static_cast<double>(exact);
  }
  return static_cast<double>(value);
}

}  // namespace kanec::scene
