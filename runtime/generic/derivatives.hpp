// Jacobians of the equations: exact, one evaluation in dual numbers a column. Not: finite differences.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <string_view>

#include "runtime/generic/equations.hpp"
#include "runtime/generic/evaluate.hpp"

namespace kanec::generic {

// Which argument varies.
enum class By { x, y, ydot, u };

// The derivative of the function of that name along each column of `directions`, which are directions of the argument
// `by`.
template <class Real>
MatrixX<Real> derivative(const Motion<Real>& motion, std::string_view function, By by,
                         const MatrixX<Real>& directions) {
  const System<Dual<Real>> system(motion.system().scene(), motion.system().parameters());
  const Arguments<Real>& at = motion.arguments();
  const auto constant = [](std::span<const Real> a) { return std::vector<Dual<Real>>(a.begin(), a.end()); };
  std::array<std::vector<Dual<Real>>, 4> given = {constant(at.x), constant(at.y), constant(at.ydot), constant(at.u)};
  std::vector<Dual<Real>>& varied = given[static_cast<std::size_t>(by)];
  MatrixX<Real> out;
  for (Eigen::Index column = 0; column < directions.cols(); ++column) {
    for (std::size_t i = 0; i < varied.size(); ++i) varied[i].rate = directions(static_cast<Eigen::Index>(i), column);
    const auto result =
        evaluate<Dual<Real>>(system, function, {Dual<Real>(at.t), given[0], given[1], given[2], given[3]});
    out.conservativeResize(static_cast<Eigen::Index>(result.size()), directions.cols());
    for (std::size_t i = 0; i < result.size(); ++i) out(static_cast<Eigen::Index>(i), column) = result[i].rate;
  }
  return out;
}

template <class Real>
MatrixX<Real> derivative(const Motion<Real>& motion, std::string_view function, By by) {
  const Arguments<Real>& at = motion.arguments();
  const std::array<std::size_t, 4> sizes = {at.x.size(), at.y.size(), at.ydot.size(), at.u.size()};
  const auto n = static_cast<Eigen::Index>(sizes[static_cast<std::size_t>(by)]);
  return derivative<Real>(motion, function, by, MatrixX<Real>::Identity(n, n));
}

// δx = E ξ (nx × ny): of a ball δe = ½ (ε4 φ + e × φ), δε4 = -½ e·φ, φ in body axes; of other coordinates δx itself.
template <class Real>
MatrixX<Real> tangent(const Motion<Real>& motion) {
  MatrixX<Real> E(motion.system().n_coordinates(), motion.system().n_speeds());
  Arguments<Real> at = motion.arguments();
  for (Eigen::Index j = 0; j < E.cols(); ++j) {
    // ẋ is the same linear function of y
    const VectorX<Real> one = VectorX<Real>::Unit(E.cols(), j);
    at.y = {one.data(), static_cast<std::size_t>(one.size())};
    E.col(j) = kinematics(Motion<Real>(motion.system(), at));
  }
  return E;
}

// d/dt (ξ, δy) = S (ξ, δy) (2ny × 2ny); φ̇ = δω - ω × φ of a ball.
template <class Real>
MatrixX<Real> state_matrix(const Motion<Real>& motion) {
  const Eigen::Index ny = motion.y().size();
  MatrixX<Real> S = MatrixX<Real>::Zero(2 * ny, 2 * ny);
  S.topRightCorner(ny, ny).setIdentity();
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    const int omega = motion.system().body(k).omega;
    if (omega >= 0) S.template block<3, 3>(omega, omega) = -skew(motion[k].omega);
  }
  S.bottomLeftCorner(ny, ny) = derivative<Real>(motion, "accelerations", By::x, tangent(motion));
  S.bottomRightCorner(ny, ny) = derivative<Real>(motion, "accelerations", By::y);
  return S;
}

// d/dt (ξ, δy) by δu (2ny × inputs).
template <class Real>
MatrixX<Real> input_matrix(const Motion<Real>& motion) {
  const MatrixX<Real> lower = derivative<Real>(motion, "accelerations", By::u);
  MatrixX<Real> B = MatrixX<Real>::Zero(2 * lower.rows(), lower.cols());
  B.bottomRows(lower.rows()) = lower;
  return B;
}

}  // namespace kanec::generic
