// The bodies of evaluate.hpp, for scalars other than double and long double; see system.inl for what they must offer.
// Not needed for these two.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string>

#include "runtime/base/error.hpp"
#include "runtime/generic/evaluate.hpp"
#include "runtime/generic/system.inl"

namespace kanec::generic {
namespace detail {

template <class Real>
std::vector<Real> flat(const typename System<Real>::Matrix& a) {
  return {a.data(), a.data() + a.size()};
}

template <class Real>
std::vector<Real> flat(const typename System<Real>::Vector& a) {
  return {a.data(), a.data() + a.size()};
}

template <class Real>
std::vector<Real> flat(const Energy<Real>& energy) {
  return {energy.kinetic, energy.potential};
}

template <class Real>
std::vector<Real> flat(const Momentum<Real>& momentum) {
  std::vector<Real> out(momentum.linear.begin(), momentum.linear.end());
  out.insert(out.end(), momentum.angular.begin(), momentum.angular.end());
  return out;
}

template <class Real>
std::vector<Real> flat(const std::vector<Pose<Real>>& poses) {
  std::vector<Real> out;
  for (const Pose<Real>& pose : poses) {
    for (const auto row : pose.R.rowwise()) out.insert(out.end(), row.begin(), row.end());
    out.insert(out.end(), pose.p.begin(), pose.p.end());
  }
  return out;
}

// The arguments as Eigen sees them.
template <class Real>
struct Views {
  using View = Eigen::Map<const typename System<Real>::Vector>;
  View x, y, ydot, u;
};

enum Reads : unsigned { reads_x = 1, reads_y = 2, reads_ydot = 4, reads_u = 8 };

template <class Real>
struct Function {
  std::string_view name;
  unsigned reads;
  std::vector<Real> (*call)(const System<Real>&, const Views<Real>&);
};

template <class Real>
const auto& functions() {
  using S = const System<Real>&;
  using V = const Views<Real>&;
  constexpr unsigned xy = reads_x | reads_y, xyu = xy | reads_u, all = xyu | reads_ydot;
  static constexpr std::array<Function<Real>, 11> table = {{
      {"kinematics", xy, [](S s, V a) { return flat<Real>(s.kinematics(a.x, a.y)); }},
      {"mass_matrix", reads_x, [](S s, V a) { return flat<Real>(s.mass_matrix(a.x)); }},
      {"forcing", xyu, [](S s, V a) { return flat<Real>(s.forcing(a.x, a.y, a.u)); }},
      {"residual", all, [](S s, V a) { return flat<Real>(s.residual(a.x, a.y, a.ydot, a.u)); }},
      {"accelerations", xyu, [](S s, V a) { return flat<Real>(s.accelerations(a.x, a.y, a.u)); }},
      {"partial_velocities", reads_x, [](S s, V a) { return flat<Real>(s.partial_velocities(a.x)); }},
      {"partial_velocity_rates", xy, [](S s, V a) { return flat<Real>(s.partial_velocity_rates(a.x, a.y)); }},
      {"energy", xy, [](S s, V a) { return flat<Real>(s.energy(a.x, a.y)); }},
      {"momentum", xy, [](S s, V a) { return flat<Real>(s.momentum(a.x, a.y)); }},
      {"poses", reads_x, [](S s, V a) { return flat<Real>(s.poses(a.x)); }},
      {"power", xyu, [](S s, V a) { return std::vector<Real>{s.power(a.x, a.y, a.u)}; }},
  }};
  return table;
}

template <class Real>
const Function<Real>& find(std::string_view name) {
  std::string known;
  for (const Function<Real>& function : functions<Real>()) {
    if (function.name == name) return function;
    known += (known.empty() ? "" : ", ") + std::string(function.name);
  }
  throw InputError("no function \"" + std::string(name) + "\"; known: " + known);
}

inline void check_length(std::string_view function, const char* argument, std::size_t found, int needed) {
  if (found != static_cast<std::size_t>(needed))
    throw InputError(std::string(function) + ": " + argument + " has " + std::to_string(found) + " entries, needs " +
                     std::to_string(needed));
}

}  // namespace detail

template <class Real>
std::vector<Real> evaluate(const System<Real>& system, std::string_view function, const Arguments<Real>& arguments) {
  const detail::Function<Real>& entry = detail::find<Real>(function);
  const auto view = [&](unsigned bit, const char* name, std::span<const Real> argument, int needed) {
    if (entry.reads & bit) detail::check_length(function, name, argument.size(), needed);
    return typename detail::Views<Real>::View(argument.data(), static_cast<Eigen::Index>(argument.size()));
  };
  return entry.call(system, {view(detail::reads_x, "x", arguments.x, system.n_coordinates()),
                             view(detail::reads_y, "y", arguments.y, system.n_speeds()),
                             view(detail::reads_ydot, "ydot", arguments.ydot, system.n_speeds()),
                             view(detail::reads_u, "u", arguments.u, system.n_inputs())});
}

}  // namespace kanec::generic
