// What the tests of the generic path share: random scenes in motion, in long double and in dual numbers. No tests here.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string_view>
#include <vector>

#include "runtime/generic/evaluate.hpp"
#include "tests/support/dual.hpp"
#include "tests/support/random_scene.hpp"

namespace kanec::generic {

using Real = long double;
using Vector = VectorX<Real>;
using Matrix = MatrixX<Real>;

// A scene in a state.
struct Sample {
  scene::Scene scene;
  std::vector<double> parameters;
  Real t = 0;
  Vector x, y, ydot, u;

  template <class Number>
  System<Number> system() const {
    return {scene, parameters};
  }

  // The function of that name, flat, or as so many rows.
  Vector operator()(std::string_view function) const;
  Matrix matrix(std::string_view function, Eigen::Index rows) const;

  // Its time derivative while t runs, x follows y and y follows ydot, at constant inputs.
  Vector rate(std::string_view function) const;
  Matrix matrix_rate(std::string_view function, Eigen::Index rows) const;

  // The same state with the accelerations that its loads give it.
  Sample falling() const;
  // Without speeds' rates, speeds, or inputs.
  Sample with(Vector Sample::*argument, Vector value) const;
};

Sample sample(const scene::Scene& scene, test::Random& random);

// One each of 1 to 12 bodies, the same in every run.
std::vector<Sample> samples(const test::RandomSceneOptions& options);

// Random forests of free joints, and of every joint with every load: half of the numbers parameters, half of the loads
// inputs.
std::vector<Sample> free_samples();
std::vector<Sample> samples();

// Largest difference of two entries over the largest entry of `right`.
template <class Left, class Right>
double relative_error(const Eigen::MatrixBase<Left>& left, const Eigen::MatrixBase<Right>& right) {
  if (left.size() == 0 && right.size() == 0) return 0;
  return static_cast<double>((left - right).cwiseAbs().maxCoeff() / right.cwiseAbs().maxCoeff());
}

// The value that a number of the scene has in a sample, read here and nowhere else. Not for expressions.
Real value(const Sample& s, const scene::Number& number);
Vector3<Real> values(const Sample& s, const scene::Vector& a);
Matrix3<Real> inertia(const Sample& s, const scene::Symmetric& a);

// Long double has 64 bits, one rounding is 5e-20. The samples' quantities are sums of up to some hundred products of
// like size: two hundred roundings of the largest entry are generous, and a lost term is fifteen powers of ten above.
inline constexpr double rounding = 1e-17;

// What comes out of a factorisation of A is worse by its condition number, of which a hundredth shows in the largest
// entry; it is below 1e5 for these scenes (asserted in dynamics_test.cpp).
inline constexpr double rounding_of_solve = 1e-15;

}  // namespace kanec::generic
