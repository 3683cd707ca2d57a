// Rotation matrices from Euler parameters, from an axis and an angle. Not: whose rotations they are.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cmath>

#include "runtime/generic/system.hpp"

namespace kanec::generic {

// ã b = a × b.
template <class Real>
Matrix3<Real> skew(const Vector3<Real>& a) {
  const Real zero(0);
  Matrix3<Real> m;
  m << zero, -a[2], a[1],  //
      a[2], zero, -a[0],   //
      -a[1], a[0], zero;
  return m;
}

// R_Kᵀ = 1 + 2 ẽ (ε4 + ẽ): a rotation for |ε| = 1, this polynomial for every ε.
template <class Real>
Matrix3<Real> rotation_to_inertial(const Eigen::Matrix<Real, 4, 1>& eps) {
  const Matrix3<Real> e = skew<Real>(eps.template head<3>());
  return Matrix3<Real>::Identity() + Real(2) * eps[3] * e + Real(2) * e * e;
}

// Rot(a, θ) = 1 + sin θ ã + (1 - cos θ) ã ã, a of unit length.
template <class Real>
Matrix3<Real> rotation_about(const Vector3<Real>& a, const Real& theta) {
  using std::cos, std::sin;
  const Matrix3<Real> a_skew = skew(a);
  return Matrix3<Real>::Identity() + sin(theta) * a_skew + (Real(1) - cos(theta)) * a_skew * a_skew;
}

}  // namespace kanec::generic
