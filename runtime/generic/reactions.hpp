// What joints transmit and what drives locked and prescribed coordinates, by Newton's and Euler's laws summed down the
// tree. Not by partial velocities: these and the residual check each other.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/generic/equations.hpp"

namespace kanec::generic {

// A force and a moment about a body's origin, inertial axes.
template <class Real>
struct Transmitted {
  Vector3<Real> force = Vector3<Real>::Zero(), moment = Vector3<Real>::Zero();
};

// What each body needs through its joint for the motion's ẏ.
//
// A ball's speeds are absolute, so a moment along them, which keeps a held attitude or is the residual of a free one,
// acts between the body and the inertial frame: it is not handed down to L(K). All else is.
template <class Real>
ByBody<Transmitted<Real>> transmitted(const Motion<Real>& motion) {
  ByBody<Transmitted<Real>> needed(motion.system().n_bodies());
  const auto applied = resultants(motion);
  for (int k = motion.system().n_bodies(); k >= 1; --k) {
    const Body<Real>& body = motion.system().body(k);
    const Frame<Real>& at = motion[k];
    const Vector3<Real> G = body.m * (motion.acceleration(motion.mass_centre(k)) - motion.system().gravity());
    const Vector3<Real> I_omega = body.I * at.omega;
    const Vector3<Real> N = body.I * motion.acceleration(at.omega_y) + at.omega.cross(I_omega);
    const Vector3<Real> arm = at.R_T * body.r;
    needed[k].force += G - applied[k].force;
    needed[k].moment += at.R_T * (N - applied[k].moment) + arm.cross(G);
    Transmitted<Real>& below = needed[body.lower];
    below.force += needed[k].force;
    below.moment += Vector3<Real>(at.P - motion[body.lower].P).cross(needed[k].force);
    if (!body.ball) below.moment += needed[k].moment;
  }
  return needed;
}

// Force and moment that L(K) exerts on K through the joint, K's axes (6N).
template <class Real>
VectorX<Real> reactions(const Motion<Real>& motion) {
  const auto needed = transmitted(motion);
  VectorX<Real> out(6 * motion.system().n_bodies());
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    const Matrix3<Real> R = motion[k].R_T.transpose();
    out.template segment<3>(6 * (k - 1)) = R * needed[k].force;
    out.template segment<3>(6 * (k - 1) + 3) = R * needed[k].moment;
  }
  return out;
}

// Of all joint loads along one coordinate.
template <class Real>
Real joint_effort_along(const Motion<Real>& motion, int k, bool turn, std::size_t i) {
  Real effort(0);
  for (const scene::Load& load : motion.system().scene().loads)
    if (load.kind == scene::Load::Kind::joint && load.point.body == k && load.turn == turn &&
        static_cast<std::size_t>(load.coordinate) == i)
      effort += joint_effort(motion, load);
  return effort;
}

// What must act along each coordinate of the turns of body k, besides joint loads. A screw's first turn also
// translates.
template <class Real>
Real driving_turn(const Motion<Real>& motion, const Transmitted<Real>& needed, int k, std::size_t i) {
  const Body<Real>& body = motion.system().body(k);
  Real along = motion[k].turn_axes[i].dot(needed.moment);
  if (i == 0) along += body.pitch * motion[k].turn_axes[0].dot(needed.force);
  return along - joint_effort_along(motion, k, true, i);
}

template <class Real>
Real driving_slide(const Motion<Real>& motion, const Transmitted<Real>& needed, int k, std::size_t i) {
  return motion[k].slide_axes[i].dot(needed.force) - joint_effort_along(motion, k, false, i);
}

// Along the coordinates that are not free: of a held ball the moment (body axes, 3), of a turn and a slide one number
// each; rotations of all bodies first, then translations.
template <class Real>
std::vector<Real> driving_loads(const Motion<Real>& motion) {
  using Kind = scene::Coordinate::Motion;
  const auto needed = transmitted(motion);
  std::vector<Real> out;
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    const Body<Real>& body = motion.system().body(k);
    const Vector3<Real> moment = motion[k].R_T.transpose() * needed[k].moment;
    if (body.held) out.insert(out.end(), moment.begin(), moment.end());
    for (std::size_t i = 0; i < body.turns.size(); ++i)
      if (body.turns[i].motion != Kind::free) out.push_back(driving_turn(motion, needed[k], k, i));
  }
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    const Body<Real>& body = motion.system().body(k);
    for (std::size_t i = 0; i < body.slides.size(); ++i)
      if (body.slides[i].motion != Kind::free) out.push_back(driving_slide(motion, needed[k], k, i));
  }
  return out;
}

}  // namespace kanec::generic
