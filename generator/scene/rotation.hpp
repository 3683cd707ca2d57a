// Rotations and directions in extended precision, for reading. Not: the rotations of a moving system.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>

#include "generator/scene/joint.hpp"

namespace kanec::scene {

using Direction = std::array<long double, 3>;
using Turn = std::array<std::array<long double, 3>, 3>;  // row-major, orthonormal

inline constexpr Turn no_turn = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

long double dot(const Direction& a, const Direction& b);
Direction cross(const Direction& a, const Direction& b);
Direction scaled(long double factor, const Direction& a);
Direction sum(const Direction& a, const Direction& b);
long double norm(const Direction& a);  // without overflow or underflow
Direction unit(const Direction& a);    // of a nonzero one; exact where one component alone is not zero

Direction operator*(const Turn& turn, const Direction& a);
Turn operator*(const Turn& a, const Turn& b);
Turn transposed(const Turn& a);

Turn turn_about(const Direction& axis, long double angle);     // by an angle about a unit axis, right-handed
Turn turn_of_eps(const std::array<long double, 4>& eps);       // Euler parameters of unit norm, scalar last
Turn turn_of_columns(const Direction& x, const Direction& z);  // x and z of unit length, at a right angle

Direction direction(const Axis& axis);
Turn turn(const Rotation& rotation);

}  // namespace kanec::scene
