// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/derivatives.hpp"

#include <algorithm>
#include <utility>

#include "generator/program/derivative.hpp"
#include "runtime/base/error.hpp"

namespace kanec::lower {

using program::Builder;
using program::Column;
using program::Group;
using program::Program;
using program::Ref;
using program::Variable;

namespace {

// The columns of a derivative: one a direction of the state.
class Columns {
 public:
  Columns(Builder& builder, const scene::Scene& scene) : builder_(builder), layout_(scene) {}

  std::vector<Column> by(const std::string& what, int n_inputs) {
    if (what == "x") return along(Group::x, layout_.nx);
    if (what == "y") return along(Group::y, layout_.ny);
    if (what == "ydot") return along(Group::ydot, layout_.ny);
    if (what == "u") return along(Group::input, n_inputs);
    return tangent();
  }

 private:
  std::vector<Column> along(Group group, int n) {
    std::vector<Column> columns;
    for (int i = 0; i < n; ++i) columns.push_back({{Variable{group, i}, builder_.constant(1.0)}});
    return columns;
  }

  // ξ: in the place of a ball's ω its rotation vector φ, body axes; else the coordinate whose speed stands there.
  std::vector<Column> tangent() {
    std::vector<Column> columns(static_cast<std::size_t>(layout_.ny));
    const auto set = [&](const std::vector<int>& at, const std::vector<int>& rate_at) {
      for (std::size_t i = 0; i < at.size(); ++i)
        if (at[i] >= 0)
          columns[static_cast<std::size_t>(rate_at[i])] = {{Variable{Group::x, at[i]}, builder_.constant(1.0)}};
    };
    for (const scene::BodyLayout& body : layout_.bodies) {
      set(body.theta, body.thetadot);
      set(body.s, body.sdot);
      for (int i = 0; body.eps >= 0 && i < 3; ++i)
        columns[static_cast<std::size_t>(body.omega + i)] = turn(body.eps, i);
    }
    return columns;
  }

  // δe = ½ (ε4 φ + e × φ), δε4 = −½ e·φ for φ along one axis.
  Column turn(int eps, int axis) {
    const auto half = [&](int i) {
      return builder_.multiply(builder_.constant(0.5), builder_.variable(Group::x, eps + i));
    };
    const int next = (axis + 1) % 3, last = (axis + 2) % 3;
    return {{Variable{Group::x, eps + axis}, half(3)},
            {Variable{Group::x, eps + next}, half(last)},
            {Variable{Group::x, eps + last}, -half(next)},
            {Variable{Group::x, eps + 3}, -half(axis)}};
  }

  Builder& builder_;
  scene::Layout layout_;
};

const program::Function& find(const Program& program, const std::string& name) {
  for (const program::Function& function : program.functions)
    if (function.name == name) return function;
  throw InternalError("no function " + name + " to differentiate");
}

std::vector<Column> columns_by(Program& program, const scene::Scene& scene, const std::string& what) {
  Builder builder;
  builder.nodes() = std::move(program.nodes);
  std::vector<Column> columns = Columns(builder, scene).by(what, static_cast<int>(scene.inputs.size()));
  program.nodes = std::move(builder.nodes());
  return columns;
}

program::Function derivative(Program& program, const scene::Scene& scene, const std::string& of,
                             const std::string& what) {
  const std::vector<Column> columns = columns_by(program, scene, what);
  const program::Function function = find(program, of);
  return program::jacobian(program, function, columns);
}

// The upper half of the state matrix: d(δξ)/dt = δy, and of a rotation φ̇ = δω − ω × φ.
std::vector<Ref> kinematic_rows(Program& program, const scene::Scene& scene) {
  const scene::Layout layout(scene);
  const auto n = static_cast<std::size_t>(layout.ny);
  Builder builder;
  builder.nodes() = std::move(program.nodes);
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
  program.nodes = std::move(builder.nodes());
  return rows;
}

program::Function state_matrix(Program& program, const scene::Scene& scene) {
  const auto n = static_cast<std::size_t>(scene::n_speeds(scene));
  program::Function by_xi = derivative(program, scene, "accelerations", "xi");
  const program::Function by_y = derivative(program, scene, "accelerations", "y");
  std::vector<Ref> outputs = kinematic_rows(program, scene);
  for (std::size_t i = 0; i < n; ++i)
    for (const program::Function* half : {&std::as_const(by_xi), &by_y})
      outputs.insert(outputs.end(), half->outputs.begin() + static_cast<std::ptrdiff_t>(i * n),
                     half->outputs.begin() + static_cast<std::ptrdiff_t>((i + 1) * n));
  by_xi.outputs = std::move(outputs);
  return by_xi;
}

program::Function input_matrix(Program& program, const scene::Scene& scene) {
  program::Function function = derivative(program, scene, "accelerations", "u");
  Builder builder;
  builder.nodes() = std::move(program.nodes);
  function.outputs.insert(function.outputs.begin(), function.outputs.size(), builder.constant(0.0));
  program.nodes = std::move(builder.nodes());
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
      {"residual_x", "derivative of r by x", "residual", ny, nx, signature("r_x", true, "ny x nx", nx)},
      {"residual_y", "derivative of r by y", "residual", ny, ny, signature("r_y", true, "ny x ny", ny)},
      {"residual_ydot", "derivative of r by ydot", "residual", ny, ny, signature("r_ydot", true, "ny x ny", ny)},
      {"residual_xi", "derivative of r by the tangent of x", "residual", ny, ny,
       signature("r_xi", true, "ny x ny", ny)},
      {"accelerations_x", "derivative of ydot by x", "accelerations", ny, nx,
       signature("ydot_x", false, "ny x nx", nx)},
      {"accelerations_y", "derivative of ydot by y", "accelerations", ny, ny,
       signature("ydot_y", false, "ny x ny", ny)},
      {"accelerations_xi", "derivative of ydot by the tangent of x", "accelerations", ny, ny,
       signature("ydot_xi", false, "ny x ny", ny)},
      {"state_matrix", "S of d(xi, y)/dt = S (xi, y) for small changes of the tangent xi and of y", "accelerations",
       2 * ny, 2 * ny, signature("S", false, "2 ny x 2 ny", 2 * ny)}};
  if (nu > 0) {
    list.push_back({"accelerations_u", "derivative of ydot by the inputs", "accelerations", ny, nu,
                    signature("ydot_u", false, "ny x n_inputs", nu)});
    list.push_back({"input_matrix", "rates of (xi, y) for small changes of the inputs", "accelerations", 2 * ny, nu,
                    signature("B", false, "2 ny x n_inputs", nu)});
  }
  return list;
}

void append_derived(Program& program, const scene::Scene& scene, const Derived& derived) {
  program::Function function;
  if (derived.name == "state_matrix")
    function = state_matrix(program, scene);
  else if (derived.name == "input_matrix")
    function = input_matrix(program, scene);
  else
    function = derivative(program, scene, derived.of, derived.name.substr(derived.of.size() + 1));
  function.name = derived.name;
  function.meaning = derived.meaning;
  function.signature = derived.signature;
  function.n_out = derived.rows * derived.columns;
  program.functions.push_back(std::move(function));
}

}  // namespace kanec::lower
