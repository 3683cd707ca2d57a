// Principal axes of an inertia, to rounding. Not: whose.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include "tests/bench/peers/adapter.hpp"

namespace kanec::peers {

struct Principal {
  Vector3d moments;         // [kg m²]
  Eigen::Quaterniond axes;  // principal components to body components
};

inline Principal principal(const kanec_peer_body& body) {
  const Matrix3 inertia = matrix(body.inertia);
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(inertia);
  Eigen::Matrix3d axes = solver.eigenvectors();
  if (axes.determinant() < 0.0) axes.col(2) *= -1.0;
  return {solver.eigenvalues(), Eigen::Quaterniond(axes)};
}

}  // namespace kanec::peers
