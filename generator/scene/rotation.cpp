// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/rotation.hpp"

#include <algorithm>
#include <cmath>

namespace kanec::scene {

long double dot(const Direction& a, const Direction& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

Direction cross(const Direction& a, const Direction& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

Direction scaled(long double factor, const Direction& a) { return {factor * a[0], factor * a[1], factor * a[2]}; }

Direction sum(const Direction& a, const Direction& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

long double norm(const Direction& a) { return std::hypot(a[0], a[1], a[2]); }

Direction unit(const Direction& a) {
  // by the largest first: then the norm is between 1 and sqrt 3, and 1 exactly where the others are zero
  const long double largest = std::max({std::fabs(a[0]), std::fabs(a[1]), std::fabs(a[2])});
  const Direction b = {a[0] / largest, a[1] / largest, a[2] / largest};
  const long double length = std::sqrt(dot(b, b));
  return {b[0] / length, b[1] / length, b[2] / length};
}

Direction operator*(const Turn& turn, const Direction& a) {
  return {dot(turn[0], a), dot(turn[1], a), dot(turn[2], a)};
}

Turn operator*(const Turn& a, const Turn& b) {
  const Turn columns = transposed(b);
  return transposed({a * columns[0], a * columns[1], a * columns[2]});
}

Turn transposed(const Turn& a) {
  return {{{a[0][0], a[1][0], a[2][0]}, {a[0][1], a[1][1], a[2][1]}, {a[0][2], a[1][2], a[2][2]}}};
}

// Rodrigues: b cos + (axis × b) sin + axis (axis·b)(1 - cos), for the coordinate axes b as columns.
Turn turn_about(const Direction& axis, long double angle) {
  const long double c = std::cos(angle), s = std::sin(angle);
  Turn columns;
  for (std::size_t j = 0; j < 3; ++j) {
    const Direction& b = no_turn[j];
    columns[j] = sum(sum(scaled(c, b), scaled(s, cross(axis, b))), scaled((1 - c) * axis[j], axis));
  }
  return transposed(columns);
}

// 1 + 2 ẽ (ε4 + ẽ), as columns b + 2 e × (ε4 b + e × b)
Turn turn_of_eps(const std::array<long double, 4>& eps) {
  const Direction e = {eps[0], eps[1], eps[2]};
  Turn columns;
  for (std::size_t j = 0; j < 3; ++j) {
    const Direction& b = no_turn[j];
    columns[j] = sum(b, scaled(2, cross(e, sum(scaled(eps[3], b), cross(e, b)))));
  }
  return transposed(columns);
}

Turn turn_of_columns(const Direction& x, const Direction& z) { return transposed({x, cross(z, x), z}); }

Direction direction(const Axis& axis) { return {axis[0], axis[1], axis[2]}; }

Turn turn(const Rotation& rotation) { return {direction(rotation[0]), direction(rotation[1]), direction(rotation[2])}; }

}  // namespace kanec::scene
