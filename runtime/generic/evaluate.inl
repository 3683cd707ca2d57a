// The bodies of evaluate.hpp, for the files that instantiate them. Not for users.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <functional>
#include <span>

#include "runtime/base/error.hpp"
#include "runtime/generic/evaluate.hpp"
#include "runtime/generic/function.hpp"

namespace kanec::generic {
namespace detail {

// What a name stands for.
template <class Real>
struct Found {
  unsigned reads;
  std::function<std::vector<Real>(const Motion<Real>&)> call;
};

template <class Real>
Found<Real> find(const scene::Scene& scene, std::string_view name) {
  for (const auto& function : usual_functions<Real>())
    if (function.name == name) return {function.reads, function.call};
  for (const auto& function : functions_on_request<Real>())
    if (function.name == name) return {function.reads, function.call};
  if constexpr (!is_dual<Real>)
    for (const auto& function : derivative_functions<Real>())
      if (function.name == name) return {function.reads, function.call};
  for (const scene::Point& point : scene.points)
    for (const PointFunction& function : point_functions)
      if (name == point.name + std::string(function.suffix))
        return {function.reads, [&point, &function](const Motion<Real>& motion) {
                  return point_output(motion, point, function.wanted);
                }};
  std::string known;
  for (const std::string& one : function_names(scene)) known += (known.empty() ? "" : ", ") + one;
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
  const detail::Found<Real> found = detail::find<Real>(system.scene(), function);
  const auto given = [&](unsigned bit, const char* name, std::span<const Real> argument, int needed) {
    if (!(found.reads & bit)) return std::span<const Real>();
    detail::check_length(function, name, argument.size(), needed);
    return argument;
  };
  const Arguments<Real> read = {arguments.t, given(reads_x, "x", arguments.x, system.n_coordinates()),
                                given(reads_y, "y", arguments.y, system.n_speeds()),
                                given(reads_ydot, "ydot", arguments.ydot, system.n_speeds()),
                                given(reads_u, "u", arguments.u, system.n_inputs())};
  return found.call(Motion<Real>(system, read));
}

}  // namespace kanec::generic
