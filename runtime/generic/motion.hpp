// Where every body of a system is and how its velocities depend on the speeds: partial velocities, their rates, and the
// part that prescribed coordinates give. Built up the tree, body upon lower body. Not: masses or loads.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>

#include "runtime/generic/rotation.hpp"
#include "runtime/generic/system.hpp"

namespace kanec::generic {

template <class Real>
using Columns3 = Eigen::Matrix<Real, 3, Eigen::Dynamic>;

// A velocity as columns by the speeds and one last column for what is there at y = 0, and the time derivatives of all
// these entries (3 × (ny + 1)): velocity = now (y, 1), acceleration = now (ẏ, 0) + rate (y, 1).
template <class Real>
struct Partials {
  Columns3<Real> now, rate;
};

// How one angle or translation stands and moves.
template <class Real>
struct Course {
  Real value{}, rate{}, second_rate{};  // the last of a prescribed one only
};

template <class Real>
struct Frame {
  Matrix3<Real> R_T;               // body to inertial components
  Vector3<Real> P;                 // origin, inertial axes
  Partials<Real> omega_y, Pdot_y;  // of ω, body axes; of the origin's velocity, inertial axes
  Vector3<Real> omega;             // body axes
  std::vector<Course<Real>> turns, slides;
  std::vector<Vector3<Real>> turn_axes, slide_axes;  // inertial axes
};

template <class Real>
class Motion {
 public:
  // Absent y and ydot count as zero.
  Motion(const System<Real>& system, const Arguments<Real>& at);

  const System<Real>& system() const { return system_; }
  const Arguments<Real>& arguments() const { return at_; }
  const VectorX<Real>& y() const { return y_; }
  const VectorX<Real>& ydot() const { return ydot_; }
  const Frame<Real>& operator[](int k) const { return frames_[k]; }

  Vector3<Real> velocity(const Partials<Real>& partials) const;
  Vector3<Real> acceleration(const Partials<Real>& partials) const;

  // Of a point fixed in body k at r, body axes: its place and its velocity, inertial axes.
  Vector3<Real> point(int k, const Vector3<Real>& r) const { return frames_[k].P + frames_[k].R_T * r; }
  Partials<Real> partials(int k, const Vector3<Real>& r) const;
  Partials<Real> mass_centre(int k) const { return partials(k, system_.body(k).r); }

 private:
  Course<Real> course(const Coordinate<Real>& coordinate) const;
  std::vector<Course<Real>> courses(const std::vector<Coordinate<Real>>& coordinates) const;
  Partials<Real> nothing() const;
  void add(Partials<Real>& to, const Coordinate<Real>& coordinate, const Course<Real>& course,
           const Vector3<Real>& axis) const;
  void turn_ball(int k);
  void turn_axes(int k);
  void translate(int k);

  const System<Real>& system_;
  Arguments<Real> at_;
  VectorX<Real> y_, ydot_;
  ByBody<Frame<Real>> frames_;
};

template <class Real>
Motion<Real>::Motion(const System<Real>& system, const Arguments<Real>& at)
    : system_(system),
      at_(at),
      y_(VectorX<Real>::Zero(system.n_speeds())),
      ydot_(VectorX<Real>::Zero(system.n_speeds())),
      frames_(system.n_bodies()) {
  if (!at.y.empty()) y_ = Eigen::Map<const VectorX<Real>>(at.y.data(), system.n_speeds());
  if (!at.ydot.empty()) ydot_ = Eigen::Map<const VectorX<Real>>(at.ydot.data(), system.n_speeds());
  frames_[0].R_T = Matrix3<Real>::Identity();
  frames_[0].P = frames_[0].omega = Vector3<Real>::Zero();
  frames_[0].omega_y = frames_[0].Pdot_y = nothing();
  for (int k = 1; k <= system.n_bodies(); ++k) {
    frames_[k].turns = courses(system.body(k).turns);
    frames_[k].slides = courses(system.body(k).slides);
    system.body(k).ball ? turn_ball(k) : turn_axes(k);
    frames_[k].omega = velocity(frames_[k].omega_y);
    translate(k);
  }
}

template <class Real>
Vector3<Real> Motion<Real>::velocity(const Partials<Real>& partials) const {
  return partials.now.leftCols(y_.size()) * y_ + partials.now.col(y_.size());
}

template <class Real>
Vector3<Real> Motion<Real>::acceleration(const Partials<Real>& partials) const {
  return partials.now.leftCols(y_.size()) * ydot_ + partials.rate.leftCols(y_.size()) * y_ +
         partials.rate.col(y_.size());
}

// The velocity Ṗ + Rᵀ (ω × r), with d(Rᵀ)/dt = Rᵀ ω̃.
template <class Real>
Partials<Real> Motion<Real>::partials(int k, const Vector3<Real>& r) const {
  const Frame<Real>& at = frames_[k];
  const Matrix3<Real> minus_r = -skew(r);
  const Columns3<Real> relative = minus_r * at.omega_y.now;
  return {at.Pdot_y.now + at.R_T * relative,
          at.Pdot_y.rate + at.R_T * (skew(at.omega) * relative + minus_r * at.omega_y.rate)};
}

template <class Real>
Course<Real> Motion<Real>::course(const Coordinate<Real>& coordinate) const {
  using Kind = scene::Coordinate::Motion;
  if (coordinate.motion == Kind::locked) return {coordinate.locked_at, Real(0), Real(0)};
  if (coordinate.motion == Kind::free)
    return {at_.x[static_cast<std::size_t>(coordinate.x)], y_[coordinate.y], Real(0)};
  const auto course = system_.course(coordinate.expression, at_.t);
  return {course.value, course.rate, course.second_rate};
}

template <class Real>
std::vector<Course<Real>> Motion<Real>::courses(const std::vector<Coordinate<Real>>& coordinates) const {
  std::vector<Course<Real>> out;
  for (const Coordinate<Real>& coordinate : coordinates) out.push_back(course(coordinate));
  return out;
}

template <class Real>
Partials<Real> Motion<Real>::nothing() const {
  return {Columns3<Real>::Zero(3, y_.size() + 1), Columns3<Real>::Zero(3, y_.size() + 1)};
}

// Adds axis times the coordinate's rate; the axis is constant in the frame in which `to` is written.
template <class Real>
void Motion<Real>::add(Partials<Real>& to, const Coordinate<Real>& coordinate, const Course<Real>& course,
                       const Vector3<Real>& axis) const {
  if (coordinate.motion == scene::Coordinate::Motion::free) {
    to.now.col(coordinate.y) += axis;
  } else {
    to.now.col(y_.size()) += axis * course.rate;
    to.rate.col(y_.size()) += axis * course.second_rate;
  }
}

// A ball's ε and ω are absolute: nothing of the lower body's turning enters.
template <class Real>
void Motion<Real>::turn_ball(int k) {
  const Body<Real>& body = system_.body(k);
  Frame<Real>& at = frames_[k];
  at.omega_y = nothing();
  at.R_T = rotation_to_inertial(body.held_eps);
  if (body.held) return;
  at.R_T = rotation_to_inertial<Real>(Eigen::Map<const Eigen::Matrix<Real, 4, 1>>(at_.x.data() + body.eps));
  at.omega_y.now.template middleCols<3>(body.omega).setIdentity();
}

// Frame after frame along the turns, each carrying ω in its own axes: ω' = Cᵀ ω + a θ̇ with C = Rot(a, θ), d(Cᵀ)/dt =
// -θ̇ Cᵀ ã.
template <class Real>
void Motion<Real>::turn_axes(int k) {
  const Body<Real>& body = system_.body(k);
  Frame<Real>& at = frames_[k];
  at.R_T = frames_[body.lower].R_T;
  at.omega_y = frames_[body.lower].omega_y;
  for (std::size_t i = 0; i < body.turns.size(); ++i) {
    const Vector3<Real>& a = body.turns[i].axis;
    const Matrix3<Real> C = rotation_about<Real>(a, at.turns[i].value), C_T = C.transpose();
    at.turn_axes.push_back(at.R_T * a);
    at.R_T = (at.R_T * C).eval();
    at.omega_y.rate = (C_T * (at.omega_y.rate - at.turns[i].rate * skew(a) * at.omega_y.now)).eval();
    at.omega_y.now = (C_T * at.omega_y.now).eval();
    add(at.omega_y, body.turns[i], at.turns[i], a);
  }
  at.R_T = (at.R_T * body.zero).eval();
  at.omega_y.now = (body.zero.transpose() * at.omega_y.now).eval();
  at.omega_y.rate = (body.zero.transpose() * at.omega_y.rate).eval();
}

// P = P_L + R_Lᵀ d; Ṗ = Ṗ_L + R_Lᵀ (ω_L × d + ḋ), d in L(K)'s axes.
template <class Real>
void Motion<Real>::translate(int k) {
  const Body<Real>& body = system_.body(k);
  Frame<Real>& at = frames_[k];
  const Frame<Real>& below = frames_[body.lower];
  Vector3<Real> d = body.q;
  Partials<Real> d_y = nothing();
  for (std::size_t i = 0; i < body.slides.size(); ++i) {
    d += body.slides[i].axis * at.slides[i].value;
    add(d_y, body.slides[i], at.slides[i], body.slides[i].axis);
    at.slide_axes.push_back(below.R_T * body.slides[i].axis);
  }
  if (!body.turns.empty()) {
    d += body.pitch * body.turns[0].axis * at.turns[0].value;
    add(d_y, body.turns[0], at.turns[0], body.pitch * body.turns[0].axis);
  }
  const Columns3<Real> relative = d_y.now - skew(d) * below.omega_y.now;
  const Columns3<Real> relative_rate =
      d_y.rate - skew(d) * below.omega_y.rate - skew<Real>(velocity(d_y)) * below.omega_y.now;
  at.P = below.P + below.R_T * d;
  at.Pdot_y.now = below.Pdot_y.now + below.R_T * relative;
  at.Pdot_y.rate = below.Pdot_y.rate + below.R_T * (skew(below.omega) * relative + relative_rate);
}

}  // namespace kanec::generic
