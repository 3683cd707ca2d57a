// What a scene's loads do in a state: forces and moments on bodies, efforts along coordinates, their power, the
// potential of those that have one. Not: inertia, and gravity only in the potential.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <vector>

#include "runtime/generic/motion.hpp"

namespace kanec::generic {

// Acts on one body.
template <class Real>
struct Action {
  int body;
  Vector3<Real> r;       // where the force acts, from the body's origin, body axes
  Vector3<Real> force;   // inertial axes
  Vector3<Real> moment;  // body axes
};

template <class Real>
using Actions = std::vector<Action<Real>>;

// With springs that have a potential, or without.
enum class Springs { all, not_conservative };

// Whether a joint load's or spring's stiffness gives a potential.
inline bool is_conservative(const scene::Load& load) {
  const auto fixed = [](const scene::Number& number) {
    return number.kind == scene::Number::Kind::constant || number.kind == scene::Number::Kind::parameter;
  };
  return fixed(load.stiffness) && fixed(load.rest);
}

// The two ends of a spring.
template <class Real>
struct Stretch {
  Vector3<Real> direction;  // from point to other, inertial axes
  Real length, rate;
};

template <class Real>
Vector3<Real> place_of(const Motion<Real>& motion, const scene::Point& point) {
  return motion.point(point.body, motion.system().constant(point.r));
}

template <class Real>
Vector3<Real> velocity_of(const Motion<Real>& motion, const scene::Point& point) {
  return motion.velocity(motion.partials(point.body, motion.system().constant(point.r)));
}

// The length is never zero: l² = |d|² + 1e-36.
template <class Real>
Stretch<Real> stretch(const Motion<Real>& motion, const scene::Load& load) {
  using std::sqrt;
  const Vector3<Real> d = place_of(motion, load.other) - place_of(motion, load.point);
  const Real l = sqrt(d.dot(d) + Real(1e-36));
  const Vector3<Real> direction = d / l;
  const Vector3<Real> approach = velocity_of(motion, load.other) - velocity_of(motion, load.point);
  return {direction, l, direction.dot(approach)};
}

// -stiffness (value - rest) - damping rate.
template <class Real>
Real restoring(const Motion<Real>& motion, const scene::Load& load, const Real& value, const Real& rate,
               Springs springs) {
  const auto number = [&](const scene::Number& a) { return motion.system().value(a, motion.arguments()); };
  Real effort = -number(load.damping) * rate;
  if (springs == Springs::all || !is_conservative(load)) effort -= number(load.stiffness) * (value - number(load.rest));
  return effort;
}

template <class Real>
const Course<Real>& course_of(const Motion<Real>& motion, const scene::Load& load) {
  const Frame<Real>& at = motion[load.point.body];
  return (load.turn ? at.turns : at.slides)[static_cast<std::size_t>(load.coordinate)];
}

// The effort of a joint load along its coordinate.
template <class Real>
Real joint_effort(const Motion<Real>& motion, const scene::Load& load, Springs springs = Springs::all) {
  const Course<Real>& course = course_of(motion, load);
  return motion.system().value(load.effort, motion.arguments()) +
         restoring(motion, load, course.value, course.rate, springs);
}

template <class Real>
Actions<Real> spring_actions(const Motion<Real>& motion, const scene::Load& load, Springs springs) {
  const Stretch<Real> at = stretch(motion, load);
  const Vector3<Real> force = -restoring(motion, load, at.length, at.rate, springs) * at.direction;
  const Vector3<Real> zero = Vector3<Real>::Zero();
  return {{load.point.body, motion.system().constant(load.point.r), force, zero},
          {load.other.body, motion.system().constant(load.other.r), -force, zero}};
}

// From the axes in which a load on a body is written.
template <class Real>
Vector3<Real> to_inertial(const Motion<Real>& motion, const scene::Load& load, const Vector3<Real>& a) {
  const int k = load.point.body;
  if (load.axes == scene::Axes::inertial || k == 0) return a;
  return motion[load.axes == scene::Axes::body ? k : motion.system().body(k).lower].R_T * a;
}
template <class Real>
Vector3<Real> to_body(const Motion<Real>& motion, const scene::Load& load, const Vector3<Real>& a) {
  if (load.axes == scene::Axes::body) return a;
  return motion[load.point.body].R_T.transpose() * to_inertial(motion, load, a);
}

// A force and its opposite at the same place in space.
template <class Real>
Actions<Real> force_actions(const Motion<Real>& motion, const scene::Load& load) {
  const Vector3<Real> force = to_inertial(motion, load, motion.system().vector(load.vector, motion.arguments()));
  const Vector3<Real> zero = Vector3<Real>::Zero();
  Actions<Real> actions = {{load.point.body, motion.system().constant(load.point.r), force, zero}};
  if (load.reaction < 0) return actions;
  const Frame<Real>& other = motion[load.reaction];
  actions.push_back({load.reaction, other.R_T.transpose() * (place_of(motion, load.point) - other.P), -force, zero});
  return actions;
}

template <class Real>
Actions<Real> moment_actions(const Motion<Real>& motion, const scene::Load& load) {
  const Vector3<Real> moment = motion.system().vector(load.vector, motion.arguments());
  const Vector3<Real> zero = Vector3<Real>::Zero();
  Actions<Real> actions = {{load.point.body, zero, zero, to_body(motion, load, moment)}};
  if (load.reaction < 0) return actions;
  actions.push_back(
      {load.reaction, zero, zero, -motion[load.reaction].R_T.transpose() * to_inertial(motion, load, moment)});
  return actions;
}

// Of any load but one on a coordinate, which has none.
template <class Real>
Actions<Real> actions_of(const Motion<Real>& motion, const scene::Load& load, Springs springs = Springs::all) {
  switch (load.kind) {
    case scene::Load::Kind::force:
      return force_actions(motion, load);
    case scene::Load::Kind::moment:
      return moment_actions(motion, load);
    case scene::Load::Kind::spring:
      return spring_actions(motion, load, springs);
    case scene::Load::Kind::joint:
      break;
  }
  return {};
}

// The force and moment that stand in a body's own table.
template <class Real>
Action<Real> own_action(const Motion<Real>& motion, int k) {
  const System<Real>& system = motion.system();
  const scene::Body& body = system.scene().bodies[static_cast<std::size_t>(k - 1)];
  return {k, system.body(k).r, system.vector(body.force, motion.arguments()),
          system.vector(body.moment, motion.arguments())};
}

template <class Real>
Real power_of(const Motion<Real>& motion, const Action<Real>& action) {
  return action.force.dot(motion.velocity(motion.partials(action.body, action.r))) +
         action.moment.dot(motion[action.body].omega);
}

template <class Real>
Real power_of(const Motion<Real>& motion, const scene::Load& load, Springs springs = Springs::all) {
  if (load.kind == scene::Load::Kind::joint) return joint_effort(motion, load, springs) * course_of(motion, load).rate;
  Real power(0);
  for (const Action<Real>& action : actions_of(motion, load, springs)) power += power_of(motion, action);
  return power;
}

// ½ stiffness (value - rest)², where that is a potential.
template <class Real>
Real potential_of(const Motion<Real>& motion, const scene::Load& load) {
  using Kind = scene::Load::Kind;
  if (!is_conservative(load) || (load.kind != Kind::joint && load.kind != Kind::spring)) return Real(0);
  const Real value = load.kind == Kind::joint ? course_of(motion, load).value : stretch(motion, load).length;
  const Real strain = value - motion.system().constant(load.rest);
  return Real(0.5) * motion.system().constant(load.stiffness) * strain * strain;
}

// A force (inertial axes) and a moment about the body's origin (body axes).
template <class Real>
struct Resultant {
  Vector3<Real> force = Vector3<Real>::Zero(), moment = Vector3<Real>::Zero();
};

// Of all actions on each body; gravity and efforts along coordinates are not among them.
template <class Real>
ByBody<Resultant<Real>> resultants(const Motion<Real>& motion) {
  ByBody<Resultant<Real>> sum(motion.system().n_bodies());
  const auto add = [&](const Action<Real>& action) {
    const Vector3<Real> force = motion[action.body].R_T.transpose() * action.force;
    sum[action.body].force += action.force;
    sum[action.body].moment += action.moment + action.r.cross(force);
  };
  for (int k = 1; k <= motion.system().n_bodies(); ++k) add(own_action(motion, k));
  for (const scene::Load& load : motion.system().scene().loads)
    for (const Action<Real>& action : actions_of(motion, load)) add(action);
  return sum;
}

}  // namespace kanec::generic
