// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/derivatives.hpp"

#include <algorithm>
#include <utility>

#include "generator/lower/directions.hpp"
#include "generator/lower/implicit.hpp"
#include "generator/program/derivative.hpp"
#include "generator/symbolic/functions.hpp"

namespace kanec::lower {

using program::Builder;
using program::Column;
using program::Group;
using program::Program;
using program::Ref;
using symbolic::Derivatives;

namespace {

// Of the rates of coordinates and of the work there are no equations to be differentiated, but few operations.
bool has_equations(const std::string& of) { return of == "residual" || of == "accelerations"; }

program::Function derivative(Program& program, const scene::Scene& scene, const std::string& of,
                             const std::string& what, Derivatives way) {
  if (way == Derivatives::equations && has_equations(of)) return derivative_by_equations(program, scene, of, what);
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
  const auto matrix = [](const std::string& name, const std::string& meaning, const std::string& of,
                         const std::string& by, int rows, int columns, const std::string& out,
                         const std::string& shape) {
    program::Signature signature{true,   true, of == "residual", of != "kinematics", out, out + " (" + shape + ")",
                                 columns};
    signature.by_inputs = by == "u";
    return Derived{name, meaning, of, {by}, rows, columns, signature};
  };
  const std::string along = "; of Euler parameters along their unit sphere";
  const std::string tangent = " by the tangent xi of x: of a ball a small turn, body axes; else as x";
  const std::string r = "residual", a = "accelerations", k = "kinematics", p = "power";
  std::vector<Derived> list = {
      matrix("residual_x", "derivative of r by x" + along, r, "x", ny, nx, "r_x", "ny x nx"),
      matrix("residual_y", "derivative of r by y", r, "y", ny, ny, "r_y", "ny x ny"),
      matrix("residual_ydot", "derivative of r by ydot", r, "ydot", ny, ny, "r_ydot", "ny x ny"),
      matrix("residual_xi", "derivative of r" + tangent, r, "xi", ny, ny, "r_xi", "ny x ny"),
      matrix("accelerations_x", "derivative of ydot by x" + along, a, "x", ny, nx, "ydot_x", "ny x nx"),
      matrix("accelerations_y", "derivative of ydot by y", a, "y", ny, ny, "ydot_y", "ny x ny"),
      matrix("accelerations_xi", "derivative of ydot" + tangent, a, "xi", ny, ny, "ydot_xi", "ny x ny"),
      matrix("kinematics_x", "derivative of xdot by x, at constant y", k, "x", nx, nx, "xdot_x", "nx x nx"),
      matrix("kinematics_y", "derivative of xdot by y", k, "y", nx, ny, "xdot_y", "nx x ny"),
      matrix("state_matrix",
             "S of d(xi, y)/dt = S (xi, y) for small changes; xi: of a ball a turn, body axes; else as x", a, "xi",
             2 * ny, 2 * ny, "S", "2 ny x 2 ny")};
  list.back().by = {"xi", "y"};
  if (symbolic::has_loads(scene)) {
    list.push_back(matrix("power_x", "derivative of the power by x" + along, p, "x", 1, nx, "power_by_x", "1 x nx"));
    list.push_back(matrix("power_y", "derivative of the power by y", p, "y", 1, ny, "power_by_y", "1 x ny"));
  }
  if (nu > 0) {
    list.push_back(
        matrix("accelerations_u", "derivative of ydot by the inputs", a, "u", ny, nu, "ydot_u", "ny x n_inputs"));
    list.push_back(matrix("input_matrix", "rates of (xi, y) for small changes of the inputs", a, "u", 2 * ny, nu, "B",
                          "2 ny x n_inputs"));
  }
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
  if (way == Derivatives::operations || !has_equations(derived.of)) return {derived.of};
  std::vector<std::string> parts;
  for (const std::string& by : derived.by)
    for (const std::string& part : parts_for(derived.of, by)) parts.push_back(part);
  return parts;
}

}  // namespace kanec::lower
