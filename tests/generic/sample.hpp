// What the tests of the generic path share: random scenes in motion, in long double and in dual numbers. No tests here.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "runtime/generic/system.hpp"
#include "tests/support/dual.hpp"
#include "tests/support/random_scene.hpp"

namespace kanec::generic {

using Real = long double;
using Dual = test::Dual<Real>;
using Vector = System<Real>::Vector;
using Matrix = System<Real>::Matrix;

extern template class System<Dual>;

// A random forest with half of its numbers parameters, half of its loads inputs, in a random state.
struct Sample {
  scene::Scene scene;
  std::vector<double> parameters;
  Vector x, y, ydot, u;

  template <class Number>
  System<Number> system() const {
    return {scene, parameters};
  }
};

Sample sample(const scene::Scene& scene, test::Random& random);

// One each of 1 to 12 bodies, the same in every run.
std::vector<Sample> samples(const test::RandomSceneOptions& options);
std::vector<Sample> samples();

// Largest difference of two entries over the largest entry of `right`.
template <class Left, class Right>
double relative_error(const Eigen::MatrixBase<Left>& left, const Eigen::MatrixBase<Right>& right) {
  return static_cast<double>((left - right).cwiseAbs().maxCoeff() / right.cwiseAbs().maxCoeff());
}

// Long double has 64 bits, one rounding is 5e-20. The samples' quantities are sums of up to some hundred products of
// like size: two hundred roundings of the largest entry are generous, and a lost term is fifteen powers of ten above.
inline constexpr double rounding = 1e-17;

// What comes out of a factorisation of A is worse by its condition number, of which a hundredth shows in the largest
// entry; it is below 1e5 for these scenes (asserted in dynamics_test.cpp).
inline constexpr double rounding_of_solve = 1e-15;

}  // namespace kanec::generic
