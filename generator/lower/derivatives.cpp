// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/derivatives.hpp"

#include <algorithm>
#include <utility>

#include "generator/lower/directions.hpp"
#include "generator/lower/implicit.hpp"
#include "generator/program/derivative.hpp"

namespace kanec::lower {

using program::Builder;
using program::Column;
using program::Group;
using program::Program;
using program::Ref;
using symbolic::Derivatives;

namespace {

program::Function derivative(Program& program, const scene::Scene& scene, const std::string& of,
                             const std::string& what, Derivatives way) {
  if (way == Derivatives::equations) return derivative_by_equations(program, scene, of, what);
  const std::vector<Column> columns = columns_by(program, scene, what);
  const program::Function function = find(program, of);
  return program::jacobian(program, function, columns);
}

// The upper half of the state matrix: d(δξ)/dt = δy, and of a rotation φ̇ = δω − ω × φ.
std::vector<Ref> kinematic_rows(Builder& builder, const scene::Layout& layout) {
  const auto n = static_cast<std::size_t>(layout.ny);
  std::vector<Ref> rows(n * 2 * n, builder.constant(0.0));
  for (std::size_t i = 0; i < n; ++i) rows[i * 2 * n + n + i] = builder.constant(1.0);
  for (const scene::BodyLayout& body : layout.bodies)
    for (int i = 0; body.omega >= 0 && i < 3; ++i) {
      const int next = (i + 1) % 3, last = (i + 2) % 3;
      const auto at = [&](int column) -> Ref& {
        return rows[static_cast<std::size_t>(body.omega + i) * 2 * n + static_cast<std::size_t>(body.omega + column)];
      };
      at(next) = builder.variable(Group::y, body.omega + last);
      at(last) = -builder.variable(Group::y, body.omega + next);
    }
  return rows;
}

program::Function state_matrix(Program& program, const scene::Scene& scene, Derivatives way) {
  const auto n = static_cast<std::size_t>(scene::n_speeds(scene));
  program::Function by_xi = derivative(program, scene, "accelerations", "xi", way);
  const program::Function by_y = derivative(program, scene, "accelerations", "y", way);
  std::vector<Ref> outputs =
      appended(program, [&](Builder& builder) { return kinematic_rows(builder, scene::Layout(scene)); });
  for (std::size_t i = 0; i < n; ++i)
    for (const program::Function* half : {&std::as_const(by_xi), &by_y})
      outputs.insert(outputs.end(), half->outputs.begin() + static_cast<std::ptrdiff_t>(i * n),
                     half->outputs.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
  by_xi.outputs = std::move(outputs);
  return by_xi;
}

program::Function input_matrix(Program& program, const scene::Scene& scene, Derivatives way) {
  program::Function function = derivative(program, scene, "accelerations", "u", way);
  const Ref zero = appended(program, [](Builder& builder) { return builder.constant(0.0); });
  function.outputs.insert(function.outputs.begin(), function.outputs.size(), zero);
  return function;
}

}  // namespace

std::vector<Derived> derived_functions(const scene::Scene& scene) {
  const scene::Layout layout(scene);
  const int nx = layout.nx, ny = layout.ny, nu = static_cast<int>(scene.inputs.size());
  const auto signature = [](const std::string& out, bool ydot, const std::string& shape, int columns) {
    return program::Signature{true, true, ydot, true, out, out + " (" + shape + ")", columns};
  };
  std::vector<Derived> list = {
      {"residual_x",
       "derivative of r by x; of Euler parameters along their unit sphere",
       "residual",
       {"x"},
       ny,
       nx,
       signature("r_x", true, "ny x nx", nx)},
      {"residual_y", "derivative of r by y", "residual", {"y"}, ny, ny, signature("r_y", true, "ny x ny", ny)},
      {"residual_ydot",
       "derivative of r by ydot",
       "residual",
       {"ydot"},
       ny,
       ny,
       signature("r_ydot", true, "ny x ny", ny)},
      {"residual_xi",
       "derivative of r by the tangent xi of x: of a ball a small turn, body axes; else as x",
       "residual",
       {"xi"},
       ny,
       ny,
       signature("r_xi", true, "ny x ny", ny)},
      {"accelerations_x",
       "derivative of ydot by x; of Euler parameters along their unit sphere",
       "accelerations",
       {"x"},
       ny,
       nx,
       signature("ydot_x", false, "ny x nx", nx)},
      {"accelerations_y",
       "derivative of ydot by y",
       "accelerations",
       {"y"},
       ny,
       ny,
       signature("ydot_y", false, "ny x ny", ny)},
      {"accelerations_xi",
       "derivative of ydot by the tangent xi of x: of a ball a small turn, body axes; else as x",
       "accelerations",
       {"xi"},
       ny,
       ny,
       signature("ydot_xi", false, "ny x ny", ny)},
      {"state_matrix",
       "S of d(xi, y)/dt = S (xi, y) for small changes; xi: of a ball a turn, body axes; else as x",
       "accelerations",
       {"xi", "y"},
       2 * ny,
       2 * ny,
       signature("S", false, "2 ny x 2 ny", 2 * ny)}};
  if (nu > 0) {
    list.push_back({"accelerations_u",
                    "derivative of ydot by the inputs",
                    "accelerations",
                    {"u"},
                    ny,
                    nu,
                    signature("ydot_u", false, "ny x n_inputs", nu)});
    list.push_back({"input_matrix",
                    "rates of (xi, y) for small changes of the inputs",
                    "accelerations",
                    {"u"},
                    2 * ny,
                    nu,
                    signature("B", false, "2 ny x n_inputs", nu)});
  }
  for (Derived& derived : list) derived.signature.by_inputs = derived.by == std::vector<std::string>{"u"};
  return list;
}

std::optional<Derived> derived_function(const scene::Scene& scene, const std::string& name) {
  for (Derived& derived : derived_functions(scene))
    if (derived.name == name) return std::move(derived);
  return std::nullopt;
}

void append_derived(Program& program, const scene::Scene& scene, const Derived& derived, Derivatives way) {
  program::Function function;
  if (derived.name == "state_matrix")
    function = state_matrix(program, scene, way);
  else if (derived.name == "input_matrix")
    function = input_matrix(program, scene, way);
  else
    function = derivative(program, scene, derived.of, derived.by[0], way);
  function.name = derived.name;
  function.meaning = derived.meaning;
  function.signature = derived.signature;
  function.n_out = derived.rows * derived.columns;
  program.functions.push_back(std::move(function));
}

std::vector<std::string> parts_of(const Derived& derived, Derivatives way) {
  if (way == Derivatives::operations) return {derived.of};
  std::vector<std::string> parts;
  for (const std::string& by : derived.by)
    for (const std::string& part : parts_for(derived.of, by)) parts.push_back(part);
  return parts;
}

}  // namespace kanec::lower
