// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/directions.hpp"

#include <utility>

namespace kanec::lower {

using program::Builder;
using program::Column;
using program::Group;
using program::Program;
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

}  // namespace

std::vector<Column> columns_by(Program& program, const scene::Scene& scene, const std::string& by) {
  const auto n_inputs = static_cast<int>(scene.inputs.size());
  return program::appended(program, [&](Builder& builder) { return Columns(builder, scene).by(by, n_inputs); });
}

}  // namespace kanec::lower
