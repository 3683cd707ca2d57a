// Derivative functions of trees of every joint. Oracle: the program's own residual and accelerations in dual numbers,
// rates exact, direction by direction.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <gtest/gtest.h>

#include <algorithm>

#include "generator/choice/requests.hpp"
#include "generator/program/passes.hpp"
#include "generator/symbolic/functions.hpp"
#include "runtime/generic/dual.hpp"
#include "tests/lower/trees.hpp"

namespace kanec::test {
namespace {

using Real = long double;
using Dual = generic::Dual<Real>;
using Vector = std::vector<Real>;

// A change of one argument, and what it is called: "x", "y", "ydot", "u".
struct Direction {
  std::string by;
  Vector change;
};

class Tree {
 public:
  Tree(std::uint64_t seed, symbolic::Derivatives derivatives) {
    Random random(seed);
    s = sample_of(random_scene(random, 1 + static_cast<int>(seed % 4), everything()), random);
    const std::vector<std::string> others = without_derivatives(s.scene);
    std::vector<std::string> names = {"residual", "accelerations", "kinematics"};
    if (symbolic::has_loads(s.scene)) names.push_back("power");
    for (const std::string& name : every_function(s.scene))
      if (std::find(others.begin(), others.end(), name) == others.end()) names.push_back(name);
    program = program::optimized(kanec::program_of(s.scene, names, {.derivatives = derivatives}));
    at = arguments<Real>(s);
  }

  Vector operator()(const std::string& name) const { return evaluate(program, find(name), at); }

  // The rate of a function while an argument changes.
  Vector rate(const std::string& name, const Direction& direction) const {
    const auto moving = [&](const Vector& values, const std::string& by) {
      std::vector<Dual> result;
      for (std::size_t i = 0; i < values.size(); ++i)
        result.emplace_back(values[i], direction.by == by ? direction.change[i] : Real(0));
      return result;
    };
    const program::Arguments<Dual> arguments{moving(at.parameters, ""), moving(at.x, "x"),      moving(at.y, "y"),
                                             moving(at.ydot, "ydot"),   moving(at.inputs, "u"), Dual(at.time)};
    Vector result;
    for (const Dual& entry : evaluate(program, find(name), arguments)) result.push_back(entry.rate);
    return result;
  }

  Sample s;
  program::Program program;
  program::Arguments<Real> at;

 private:
  const program::Function& find(const std::string& name) const {
    for (const program::Function& function : program.functions)
      if (function.name == name) return function;
    throw std::out_of_range(name);
  }
};

std::vector<Direction> entries(const std::string& by, std::size_t n) {
  std::vector<Direction> result(n, {by, Vector(n, 0)});
  for (std::size_t i = 0; i < n; ++i) result[i].change[i] = 1;
  return result;
}

// δe = ½ (ε4 φ + e × φ), δε4 = −½ e·φ for φ along each axis of a ball; the other coordinates one by one.
std::vector<Direction> tangent(const Tree& tree) {
  const scene::Layout layout(tree.s.scene);
  const auto index = [](int i) { return static_cast<std::size_t>(i); };
  const std::size_t nx = tree.at.x.size();
  std::vector<Direction> result(tree.at.y.size(), {"x", Vector(nx, 0)});
  for (const scene::BodyLayout& body : layout.bodies) {
    for (std::size_t i = 0; i < body.theta.size(); ++i)
      if (body.theta[i] >= 0) result[index(body.thetadot[i])].change[index(body.theta[i])] = 1;
    for (std::size_t i = 0; i < body.s.size(); ++i)
      if (body.s[i] >= 0) result[index(body.sdot[i])].change[index(body.s[i])] = 1;
    if (body.eps < 0) continue;
    const Real* e = &tree.at.x[index(body.eps)];
    const Real rows[3][4] = {{e[3], e[2], -e[1], -e[0]}, {-e[2], e[3], e[0], -e[1]}, {e[1], -e[0], e[3], -e[2]}};
    for (int axis = 0; axis < 3; ++axis)
      for (int i = 0; i < 4; ++i) result[index(body.omega + axis)].change[index(body.eps + i)] = rows[axis][i] / 2;
  }
  return result;
}

// Both sides differentiate the same operations, so that the constants' rounding is in both; what differs is the order
// of sums, a few hundred roundings of 5e-20, enlarged by pivots of the solution where there is one. Measured: 4e-16.
constexpr double tolerance = 1e-14;

// Of trees from a seed, made either way.
class Jacobians : public testing::TestWithParam<std::tuple<std::uint64_t, symbolic::Derivatives>> {
 protected:
  // Columns side by side, row by row.
  Vector columns(const std::string& of, const std::vector<Direction>& directions) const {
    const std::size_t rows = tree(of).size();
    Vector result(rows * directions.size());
    for (std::size_t j = 0; j < directions.size(); ++j) {
      const Vector column = tree.rate(of, directions[j]);
      for (std::size_t i = 0; i < rows; ++i) result[i * directions.size() + j] = column[i];
    }
    return result;
  }
  void expect(const std::string& of, const std::string& by, const std::vector<Direction>& directions) const {
    const auto compared = [&](const Vector& result) { return comparable(tree.s, of + "_" + by, result); };
    const double error =
        relative_difference(compared(tree(of + "_" + by)), compared(columns(of, directions)), least_size);
    EXPECT_LT(error, tolerance) << of << " by " << by;
  }

  const Tree tree{std::get<0>(GetParam()), std::get<1>(GetParam())};
  const std::size_t nx = tree.at.x.size(), ny = tree.at.y.size(), nu = tree.at.inputs.size();
};

INSTANTIATE_TEST_SUITE_P(Seeds, Jacobians,
                         testing::Combine(testing::Range<std::uint64_t>(0, 40),
                                          testing::Values(symbolic::Derivatives::operations,
                                                          symbolic::Derivatives::equations)));

TEST_P(Jacobians, of_residual_and_accelerations_are_the_rates_of_dual_numbers) {
  for (const std::string of : {"residual", "accelerations"}) {
    expect(of, "x", entries("x", nx));
    expect(of, "y", entries("y", ny));
    expect(of, "xi", tangent(tree));
  }
  expect("residual", "ydot", entries("ydot", ny));
  if (nu > 0) expect("accelerations", "u", entries("u", nu));
}

TEST_P(Jacobians, of_kinematics_and_power_are_the_rates_of_dual_numbers) {
  std::vector<std::string> functions = {"kinematics"};
  if (symbolic::has_loads(tree.s.scene)) functions.push_back("power");
  for (const std::string& of : functions) {
    expect(of, "x", entries("x", nx));
    expect(of, "y", entries("y", ny));
  }
}

// φ̇ = δω − ω × φ; of other coordinates the speeds' changes.
TEST_P(Jacobians, make_up_the_state_matrix_and_the_input_matrix) {
  const Vector S = tree("state_matrix"), by_xi = tree("accelerations_xi"), by_y = tree("accelerations_y");
  Vector expected(4 * ny * ny);
  for (std::size_t i = 0; i < ny; ++i) {
    expected[i * 2 * ny + ny + i] = 1;
    for (std::size_t j = 0; j < ny; ++j) {
      expected[(ny + i) * 2 * ny + j] = by_xi[i * ny + j];
      expected[(ny + i) * 2 * ny + ny + j] = by_y[i * ny + j];
    }
  }
  for (const scene::BodyLayout& body : scene::Layout(tree.s.scene).bodies)
    for (std::size_t i = 0; body.omega >= 0 && i < 3; ++i) {
      const auto at = static_cast<std::size_t>(body.omega);
      const std::size_t next = (i + 1) % 3, last = (i + 2) % 3;
      expected[(at + i) * 2 * ny + at + next] = tree.at.y[at + last];
      expected[(at + i) * 2 * ny + at + last] = -tree.at.y[at + next];
    }
  EXPECT_LT(relative_difference(S, expected), tolerance);
  if (nu == 0) return;
  Vector below = tree("accelerations_u");
  below.insert(below.begin(), below.size(), 0);
  EXPECT_LT(relative_difference(tree("input_matrix"), below), tolerance);
}

}  // namespace
}  // namespace kanec::test
