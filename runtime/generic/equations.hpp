// Kane's equations in a state: ẋ, A, f, r and ẏ, by sums over the bodies. Not: the loads one by one (loads.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>

#include "runtime/base/error.hpp"
#include "runtime/generic/loads.hpp"

namespace kanec::generic {

// d(e)/dt = ½ (ε4 ω + e × ω), d(ε4)/dt = -½ e·ω; every other coordinate's rate is a speed (nx).
template <class Real>
VectorX<Real> kinematics(const Motion<Real>& motion) {
  const Real half(0.5);
  const auto& x = motion.arguments().x;
  VectorX<Real> xdot(motion.system().n_coordinates());
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    const Body<Real>& body = motion.system().body(k);
    for (const auto* coordinates : {&body.turns, &body.slides})
      for (const Coordinate<Real>& coordinate : *coordinates)
        if (coordinate.x >= 0) xdot[coordinate.x] = motion.y()[coordinate.y];
    if (body.eps < 0) continue;
    const Eigen::Map<const Vector3<Real>> e(x.data() + body.eps);
    const Vector3<Real> omega = motion[k].omega;
    xdot.template segment<3>(body.eps) = half * (x[static_cast<std::size_t>(body.eps) + 3] * omega + e.cross(omega));
    xdot[body.eps + 3] = -half * e.dot(omega);
  }
  return xdot;
}

// A = Σ (m v_yᵀ v_y + ω_yᵀ I ω_y) (ny × ny).
template <class Real>
MatrixX<Real> mass_matrix(const Motion<Real>& motion) {
  const auto ny = motion.y().size();
  MatrixX<Real> A = MatrixX<Real>::Zero(ny, ny);
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    const Body<Real>& body = motion.system().body(k);
    const Columns3<Real> v_y = motion.mass_centre(k).now.leftCols(ny);
    const Columns3<Real> omega_y = motion[k].omega_y.now.leftCols(ny);
    A += body.m * v_y.transpose().lazyProduct(v_y);
    const Columns3<Real> I_omega_y = body.I * omega_y;
    A += omega_y.transpose().lazyProduct(I_omega_y);
  }
  return A;
}

// The efforts of joint loads along the coordinates of the state (ny).
template <class Real>
VectorX<Real> joint_efforts(const Motion<Real>& motion) {
  VectorX<Real> efforts = VectorX<Real>::Zero(motion.y().size());
  for (const scene::Load& load : motion.system().scene().loads) {
    if (load.kind != scene::Load::Kind::joint) continue;
    const Body<Real>& body = motion.system().body(load.point.body);
    const int y = (load.turn ? body.turns : body.slides)[static_cast<std::size_t>(load.coordinate)].y;
    if (y >= 0) efforts[y] += joint_effort(motion, load);
  }
  return efforts;
}

// r = A ẏ - f = Σ v_yᵀ m (v̇ - g) + ω_yᵀ (I ω̇ + ω × I ω) - applied loads (ny); A is not formed.
template <class Real>
VectorX<Real> residual(const Motion<Real>& motion) {
  const auto ny = motion.y().size();
  const auto applied = resultants(motion);
  VectorX<Real> r = -joint_efforts(motion);
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    const Body<Real>& body = motion.system().body(k);
    const Frame<Real>& at = motion[k];
    const Partials<Real> v_y = motion.mass_centre(k);
    const Vector3<Real> G = body.m * (motion.acceleration(v_y) - motion.system().gravity());
    const Vector3<Real> I_omega = body.I * at.omega;
    const Vector3<Real> N = body.I * motion.acceleration(at.omega_y) + at.omega.cross(I_omega);
    r += v_y.now.leftCols(ny).transpose() * G +
         at.omega_y.now.leftCols(ny).transpose() * Vector3<Real>(N - applied[k].moment);
    r -= at.Pdot_y.now.leftCols(ny).transpose() * applied[k].force;
  }
  return r;
}

// f (ny): minus the residual of ẏ = 0. The motion's own ẏ does not count.
template <class Real>
VectorX<Real> forcing(const Motion<Real>& motion) {
  Arguments<Real> at = motion.arguments();
  at.ydot = {};
  return -residual(Motion<Real>(motion.system(), at));
}

// ẏ by Cholesky's factorisation of A (ny). Throws InputError where A is not positive definite.
template <class Real>
VectorX<Real> accelerations(const Motion<Real>& motion) {
  if (motion.y().size() == 0) return motion.y();
  const Eigen::LLT<MatrixX<Real>> factors(mass_matrix(motion));
  if (factors.info() != Eigen::Success)
    throw InputError("scene " + motion.system().scene().name +
                     ": the mass matrix is not positive definite with these parameters");
  return factors.solve(forcing(motion));
}

}  // namespace kanec::generic
