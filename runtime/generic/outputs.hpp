// What a model tells of a state besides its equations: partial velocities, energy, momentum, poses, powers, points.
// Each flat, as an emitted solver writes it. Not: the equations (equations.hpp) or what joints transmit
// (reactions.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/generic/equations.hpp"

namespace kanec::generic {

template <class Real, class Derived>
void append(std::vector<Real>& out, const Eigen::MatrixBase<Derived>& rows) {
  for (Eigen::Index i = 0; i < rows.rows(); ++i)
    for (Eigen::Index j = 0; j < rows.cols(); ++j) out.push_back(rows(i, j));
}

// `columns_of(k)` (3 × (ny + 1)) of every body, without the last column (N × 3 × ny).
template <class Real, class ColumnsOf>
std::vector<Real> stacked(const Motion<Real>& motion, const ColumnsOf& columns_of) {
  std::vector<Real> out;
  for (int k = 1; k <= motion.system().n_bodies(); ++k)
    append(out, Columns3<Real>(columns_of(k)).leftCols(motion.y().size()));
  return out;
}

template <class Real>
std::vector<Real> partial_velocities(const Motion<Real>& motion) {
  return stacked(motion, [&](int k) { return motion.mass_centre(k).now; });
}

template <class Real>
std::vector<Real> partial_velocity_rates(const Motion<Real>& motion) {
  return stacked(motion, [&](int k) { return motion.mass_centre(k).rate; });
}

template <class Real>
std::vector<Real> partial_angular_velocities(const Motion<Real>& motion) {
  return stacked(motion, [&](int k) { return motion[k].omega_y.now; });
}

template <class Real>
std::vector<Real> partial_angular_velocity_rates(const Motion<Real>& motion) {
  return stacked(motion, [&](int k) { return motion[k].omega_y.rate; });
}

// Kinetic and potential [J]; the potential of gravity, -Σ m g·p, and of springs.
template <class Real>
std::vector<Real> energy(const Motion<Real>& motion) {
  Real kinetic(0), potential(0);
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    const Body<Real>& body = motion.system().body(k);
    const Vector3<Real> v = motion.velocity(motion.mass_centre(k)), omega = motion[k].omega;
    kinetic += Real(0.5) * (body.m * v.squaredNorm() + omega.dot(body.I * omega));
    potential -= body.m * motion.system().gravity().dot(motion.point(k, body.r));
  }
  for (const scene::Load& load : motion.system().scene().loads) potential += potential_of(motion, load);
  return {kinetic, potential};
}

// Linear [kg m/s], then angular about the inertial origin [kg m²/s], inertial axes.
template <class Real>
std::vector<Real> momentum(const Motion<Real>& motion) {
  Eigen::Matrix<Real, 6, 1> sum = Eigen::Matrix<Real, 6, 1>::Zero();
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    const Body<Real>& body = motion.system().body(k);
    const Vector3<Real> linear = body.m * motion.velocity(motion.mass_centre(k));
    const Vector3<Real> spin = body.I * motion[k].omega;
    sum.template head<3>() += linear;
    sum.template tail<3>() += motion.point(k, body.r).cross(linear) + motion[k].R_T * spin;
  }
  return {sum.begin(), sum.end()};
}

// Of each body R (inertial to body components, 3 × 3) and the mass centre (inertial axes, 3).
template <class Real>
std::vector<Real> poses(const Motion<Real>& motion) {
  std::vector<Real> out;
  for (int k = 1; k <= motion.system().n_bodies(); ++k) {
    append(out, motion[k].R_T.transpose());
    append(out, motion.point(k, motion.system().body(k).r));
  }
  return out;
}

// Of all applied loads but gravity and the springs that have a potential [W].
template <class Real>
Real power(const Motion<Real>& motion) {
  Real sum(0);
  for (int k = 1; k <= motion.system().n_bodies(); ++k) sum += power_of(motion, own_action(motion, k));
  for (const scene::Load& load : motion.system().scene().loads)
    sum += power_of(motion, load, Springs::not_conservative);
  return sum;
}

// Whether a body's own table has a force or moment.
inline bool is_loaded(const scene::Body& body) { return !is_zero(body.force) || !is_zero(body.moment); }

// First of the bodies that are loaded, then of each load [W].
template <class Real>
std::vector<Real> load_powers(const Motion<Real>& motion) {
  const scene::Scene& scene = motion.system().scene();
  std::vector<Real> out;
  for (int k = 1; k <= motion.system().n_bodies(); ++k)
    if (is_loaded(scene.bodies[static_cast<std::size_t>(k - 1)]))
      out.push_back(power_of(motion, own_action(motion, k)));
  for (const scene::Load& load : scene.loads) out.push_back(power_of(motion, load));
  return out;
}

// The expressions of the scene's events.
template <class Real>
std::vector<Real> events(const Motion<Real>& motion) {
  std::vector<Real> out;
  for (const scene::Event& event : motion.system().scene().events)
    out.push_back(motion.system().value(event.expression, motion.arguments()));
  return out;
}

enum class OfPoint { position, velocity, acceleration, jacobian };

// Inertial axes (3); the Jacobian is the velocity's by y (3 × ny).
template <class Real>
std::vector<Real> point_output(const Motion<Real>& motion, const scene::Point& point, OfPoint wanted) {
  const Vector3<Real> r = motion.system().constant(point.r);
  const Partials<Real> partials = motion.partials(point.body, r);
  std::vector<Real> out;
  switch (wanted) {
    case OfPoint::position:
      append(out, motion.point(point.body, r));
      break;
    case OfPoint::velocity:
      append(out, motion.velocity(partials));
      break;
    case OfPoint::acceleration:
      append(out, motion.acceleration(partials));
      break;
    case OfPoint::jacobian:
      append(out, partials.now.leftCols(motion.y().size()));
      break;
  }
  return out;
}

}  // namespace kanec::generic
