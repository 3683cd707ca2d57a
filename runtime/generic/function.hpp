// The table of functions by name that evaluate() looks into. Not: what they compute.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>
#include <utility>

#include "runtime/generic/derivatives.hpp"
#include "runtime/generic/outputs.hpp"
#include "runtime/generic/reactions.hpp"

namespace kanec::generic {

enum Reads : unsigned { reads_x = 1, reads_y = 2, reads_ydot = 4, reads_u = 8 };
inline constexpr unsigned xy = reads_x | reads_y, xyu = xy | reads_u, all = xyu | reads_ydot;

template <class Real>
struct Function {
  std::string_view name;
  unsigned reads;
  std::vector<Real> (*call)(const Motion<Real>&);
};

template <class Derived>
auto flat(const Eigen::MatrixBase<Derived>& rows) {
  std::vector<typename Derived::Scalar> out;
  append(out, rows);
  return out;
}

template <class Real>
const auto& usual_functions() {
  using M = const Motion<Real>&;
  static constexpr std::array<Function<Real>, 11> table = {{
      {"kinematics", xy, [](M m) { return flat(kinematics(m)); }},
      {"mass_matrix", reads_x, [](M m) { return flat(mass_matrix(m)); }},
      {"forcing", xyu, [](M m) { return flat(forcing(m)); }},
      {"residual", all, [](M m) { return flat(residual(m)); }},
      {"accelerations", xyu, [](M m) { return flat(accelerations(m)); }},
      {"partial_velocities", reads_x, partial_velocities},
      {"partial_velocity_rates", xy, partial_velocity_rates},
      {"energy", xy, energy},
      {"momentum", xy, momentum},
      {"poses", reads_x, poses},
      {"power", xyu, [](M m) { return std::vector<Real>{power(m)}; }},
  }};
  return table;
}

template <class Real>
const auto& functions_on_request() {
  using M = const Motion<Real>&;
  static constexpr std::array<Function<Real>, 6> table = {{
      {"partial_angular_velocities", reads_x, partial_angular_velocities},
      {"partial_angular_velocity_rates", xy, partial_angular_velocity_rates},
      {"load_powers", xyu, load_powers},
      {"events", xyu, events},
      {"driving_loads", all, driving_loads},
      {"reactions", all, [](M m) { return flat(reactions(m)); }},
  }};
  return table;
}

// Not in dual numbers, whose derivatives these are.
template <class Real>
const auto& derivative_functions() {
  using M = const Motion<Real>&;
  static constexpr std::array<Function<Real>, 14> table = {{
      {"residual_x", all, [](M m) { return flat(derivative<Real>(m, "residual", By::x)); }},
      {"residual_y", all, [](M m) { return flat(derivative<Real>(m, "residual", By::y)); }},
      {"residual_ydot", all, [](M m) { return flat(derivative<Real>(m, "residual", By::ydot)); }},
      {"residual_xi", all, [](M m) { return flat(derivative<Real>(m, "residual", By::x, tangent(m))); }},
      {"accelerations_x", xyu, [](M m) { return flat(derivative<Real>(m, "accelerations", By::x)); }},
      {"accelerations_y", xyu, [](M m) { return flat(derivative<Real>(m, "accelerations", By::y)); }},
      {"accelerations_u", xyu, [](M m) { return flat(derivative<Real>(m, "accelerations", By::u)); }},
      {"accelerations_xi", xyu, [](M m) { return flat(derivative<Real>(m, "accelerations", By::x, tangent(m))); }},
      {"kinematics_x", xy, [](M m) { return flat(derivative<Real>(m, "kinematics", By::x)); }},
      {"kinematics_y", xy, [](M m) { return flat(derivative<Real>(m, "kinematics", By::y)); }},
      {"power_x", xyu, [](M m) { return flat(derivative<Real>(m, "power", By::x)); }},
      {"power_y", xyu, [](M m) { return flat(derivative<Real>(m, "power", By::y)); }},
      {"state_matrix", xyu, [](M m) { return flat(state_matrix(m)); }},
      {"input_matrix", xyu, [](M m) { return flat(input_matrix(m)); }},
  }};
  return table;
}

// Of each named point, behind its name.
struct PointFunction {
  std::string_view suffix;
  unsigned reads;
  OfPoint wanted;
};
inline constexpr std::array<PointFunction, 4> point_functions = {{
    {"_position", reads_x, OfPoint::position},
    {"_velocity", xy, OfPoint::velocity},
    {"_acceleration", xy | reads_ydot, OfPoint::acceleration},
    {"_jacobian", reads_x, OfPoint::jacobian},
}};

}  // namespace kanec::generic
