// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/lower/implicit.hpp"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "generator/lower/directions.hpp"
#include "generator/lower/elimination.hpp"
#include "generator/program/combined.hpp"
#include "generator/program/fold.hpp"
#include "generator/program/substitute.hpp"

namespace kanec::lower {

using program::Builder;
using program::Function;
using program::Group;
using program::Program;
using program::Ref;

namespace {

bool by_position(const std::string& by) { return by == "x" || by == "xi"; }

// From a column an entry of the tangent to a column an entry of x, one row: of Euler parameters
// r_e = 2 (ε4 g + e × g) and r_ε4 = −2 e·g with g the entries by φ, along the unit sphere.
std::vector<Ref> row_by_x(Builder& builder, const scene::Layout& layout, const std::vector<Ref>& by_xi) {
  using namespace program::fold;
  std::vector<Ref> row(static_cast<std::size_t>(layout.nx), builder.constant(0.0));
  const auto move = [&](const std::vector<int>& to, const std::vector<int>& from) {
    for (std::size_t i = 0; i < to.size(); ++i)
      if (to[i] >= 0) row[static_cast<std::size_t>(to[i])] = by_xi[static_cast<std::size_t>(from[i])];
  };
  for (const scene::BodyLayout& body : layout.bodies) {
    move(body.theta, body.thetadot);
    move(body.s, body.sdot);
    if (body.eps < 0) continue;
    const auto twice = [&](int i) {
      return product(builder, builder.constant(2.0), builder.variable(Group::x, body.eps + i));
    };
    const auto g = [&](int i) { return by_xi[static_cast<std::size_t>(body.omega + i)]; };
    Ref along = builder.constant(0.0);
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3, last = (i + 2) % 3;
      const Ref across = sum(builder, product(builder, twice(next), g(last)), -product(builder, twice(last), g(next)));
      row[static_cast<std::size_t>(body.eps + i)] = sum(builder, product(builder, twice(3), g(i)), across);
      along = sum(builder, along, product(builder, twice(i), g(i)));
    }
    row[static_cast<std::size_t>(body.eps + 3)] = -along;
  }
  return row;
}

// Row-major, of the inertia forces.
std::vector<Ref> of_inertia(Program& program, const scene::Layout& layout, const std::string& by, std::size_t columns) {
  const auto n = static_cast<std::size_t>(layout.ny);
  if (by == "ydot") return find(program, "mass_matrix").outputs;
  if (by == "u")
    return appended(program, [&](Builder& builder) { return std::vector(n * columns, builder.constant(0.0)); });
  const std::vector<Ref> outputs = find(program, by == "y" ? "inertia_y" : "inertia_xi").outputs;
  if (by != "x") return outputs;
  return appended(program, [&](Builder& builder) {
    std::vector<Ref> result;
    for (std::size_t i = 0; i < n; ++i) {
      const auto first = outputs.begin() + static_cast<std::ptrdiff_t>(i * n);
      const std::vector<Ref> row = row_by_x(builder, layout, {first, first + static_cast<std::ptrdiff_t>(n)});
      result.insert(result.end(), row.begin(), row.end());
    }
    return result;
  });
}

// What the functions have in common in quantities, then the sum of both derivatives.
Function of_residual(Program& program, const scene::Scene& scene, const std::string& by) {
  const scene::Layout layout(scene);
  const std::vector<program::Column> directions = columns_by(program, scene, by);
  const Function applied = find(program, "applied");
  Function result = program::jacobian(program, applied, directions);
  const std::vector<Ref> inertia = of_inertia(program, layout, by, directions.size());
  result.outputs = appended(program, [&](Builder& builder) {
    std::vector<Ref> sums;
    for (std::size_t i = 0; i < inertia.size(); ++i)
      sums.push_back(program::fold::sum(builder, inertia[i], result.outputs[i]));
    return sums;
  });
  for (const std::string& part : parts_for("residual", by))
    program::merge_quantities(result.quantities, find(program, part).quantities, "of_" + part);
  return result;
}

// Rows of y from the leaves inward, as accelerations are eliminated (symbolic/accelerations.cpp).
std::vector<std::size_t> elimination_order(const scene::Layout& layout) {
  std::vector<std::size_t> order;
  const auto add = [&order](int row) {
    if (row >= 0) order.push_back(static_cast<std::size_t>(row));
  };
  for (auto body = layout.bodies.rbegin(); body != layout.bodies.rend(); ++body) {
    for (int i = 0; body->omega >= 0 && i < 3; ++i) add(body->omega + i);
    for (auto turn = body->thetadot.rbegin(); turn != body->thetadot.rend(); ++turn) add(*turn);
    for (const int slide : body->sdot) add(slide);
  }
  return order;
}

Factors factors_of(Builder& builder, const std::vector<Ref>& A, const std::vector<std::size_t>& order) {
  Entries entries;
  for (std::size_t i = 0; i < order.size(); ++i)
    for (std::size_t j = 0; j <= i; ++j) {
      const Ref entry = A[order[i] * order.size() + order[j]];
      if (i == j || !program::fold::is(builder, entry, 0)) entries[{static_cast<int>(i), static_cast<int>(j)}] = entry;
    }
  return factorised(builder, std::move(entries), static_cast<int>(order.size()));
}

// Of a column that has one entry its row.
std::optional<std::size_t> only_row(const Builder& builder, const std::vector<Ref>& B, std::size_t columns,
                                    std::size_t j) {
  std::optional<std::size_t> found;
  for (std::size_t row = 0; row * columns < B.size(); ++row) {
    if (program::fold::is(builder, B[row * columns + j], 0)) continue;
    if (found) return std::nullopt;
    found = row;
  }
  return found;
}

// Whether B has a column of one entry for each row, so that all of A⁻¹ is needed.
bool wants_inverse(const Builder& builder, const std::vector<Ref>& B, std::size_t n) {
  std::set<std::size_t> rows;
  for (std::size_t j = 0; j < B.size() / n; ++j)
    if (const auto row = only_row(builder, B, B.size() / n, j)) rows.insert(*row);
  return rows.size() == n;
}

// −A⁻¹ B, row-major.
std::vector<Ref> solved_for(Builder& builder, const std::vector<Ref>& A, const std::vector<std::size_t>& order,
                            const std::vector<Ref>& B) {
  const Factors factors = factors_of(builder, A, order);
  const std::size_t columns = order.empty() ? 0 : B.size() / order.size();
  std::vector<Ref> result(B.size()), inverse;
  if (columns > 0 && wants_inverse(builder, B, order.size())) inverse = inverted(builder, factors);
  for (std::size_t j = 0; j < columns; ++j) {
    std::vector<Ref> right;
    for (const std::size_t row : order) right.push_back(-B[row * columns + j]);
    const auto only = inverse.empty() ? std::nullopt : only_row(builder, B, columns, j);
    if (only) {
      const auto at = static_cast<std::size_t>(std::find(order.begin(), order.end(), *only) - order.begin());
      const Ref factor = right[at];
      for (std::size_t i = 0; i < order.size(); ++i)
        right[i] = program::fold::product(builder, factor, inverse[i * order.size() + at]);
    } else {
      right = solved(builder, factors, std::move(right));
    }
    for (std::size_t i = 0; i < order.size(); ++i) result[order[i] * columns + j] = right[i];
  }
  return result;
}

Function of_accelerations(Program& program, const scene::Scene& scene, const std::string& by) {
  const Function accelerations = find(program, "accelerations");
  const Function mass_matrix = find(program, "mass_matrix");
  const Function residual =
      program::substituted(program, of_residual(program, scene, by), Group::ydot, accelerations.outputs);
  Function result = residual;
  const std::vector<std::size_t> order = elimination_order(scene::Layout(scene));
  result.outputs = appended(
      program, [&](Builder& builder) { return solved_for(builder, mass_matrix.outputs, order, residual.outputs); });
  result.quantities = accelerations.quantities;
  program::merge_quantities(result.quantities, mass_matrix.quantities, "of_A");
  program::merge_quantities(result.quantities, residual.quantities, "of_r", program::From::end);
  return result;
}

}  // namespace

std::vector<std::string> parts_for(const std::string& of, const std::string& by) {
  std::vector<std::string> parts = {"applied"};
  if (by == "ydot" || of == "accelerations") parts.emplace_back("mass_matrix");
  if (by_position(by) || by == "y") parts.emplace_back(by == "y" ? "inertia_y" : "inertia_xi");
  if (of == "accelerations") parts.emplace_back("accelerations");
  return parts;
}

Function derivative_by_equations(Program& program, const scene::Scene& scene, const std::string& of,
                                 const std::string& by) {
  return of == "residual" ? of_residual(program, scene, by) : of_accelerations(program, scene, by);
}

}  // namespace kanec::lower
