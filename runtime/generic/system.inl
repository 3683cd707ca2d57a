// The bodies of system.hpp, for the files that instantiate them. Not for users.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Geometry>
#include <string>

#include "runtime/base/error.hpp"
#include "runtime/generic/expression.hpp"
#include "runtime/generic/system.hpp"

namespace kanec::generic {
namespace detail {

inline const scene::BodyLayout& of_body(const scene::Layout& layout, int k) {
  return layout.bodies[static_cast<std::size_t>(k - 1)];
}

template <class Real>
Vector3<Real> unit(const scene::Axis& a) {
  return Vector3<Real>(Real(a[0]), Real(a[1]), Real(a[2])).normalized();
}

// Orthonormal to rounding of Real: the doubles are to theirs, one step of Newton's iteration squares what is missing.
template <class Real>
Matrix3<Real> orthonormal(const scene::Rotation& a) {
  Matrix3<Real> m;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) m(i, j) = Real(a[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)]);
  return Real(0.5) * m * (Real(3) * Matrix3<Real>::Identity() - m.transpose() * m);
}

template <class Real>
std::vector<Coordinate<Real>> read_coordinates(const std::vector<scene::Coordinate>& from, const std::vector<int>& x,
                                               const std::vector<int>& y) {
  std::vector<Coordinate<Real>> out;
  for (std::size_t i = 0; i < from.size(); ++i)
    out.push_back({unit<Real>(from[i].axis), from[i].motion, Real(from[i].value), from[i].expression,
                   i < x.size() ? x[i] : -1, i < y.size() ? y[i] : -1});
  return out;
}

}  // namespace detail

template <class Real>
System<Real>::System(const scene::Scene& scene, std::span<const double> parameters)
    : scene_(scene), parameters_(parameters.begin(), parameters.end()), layout_(scene), bodies_(scene::size(scene)) {
  if (parameters.size() != scene.parameters.size())
    throw InputError("scene " + scene.name + ": " + std::to_string(parameters.size()) + " parameters given, " +
                     std::to_string(scene.parameters.size()) + " needed");
  gravity_ = constant(scene.gravity);
  for (int k = 1; k <= n_bodies(); ++k) bodies_[k] = read_body(k);
}

template <class Real>
Body<Real> System<Real>::read_body(int k) const {
  const scene::Body& from = scene_.bodies[static_cast<std::size_t>(k - 1)];
  const scene::BodyLayout& at = detail::of_body(layout_, k);
  const auto& eps = from.initial.eps;
  Body<Real> body;
  body.lower = scene_.lower[static_cast<std::size_t>(k - 1)];
  body.m = constant(from.mass);
  body.I = symmetric(from.inertia);
  body.r = constant(from.r);
  body.q = constant(from.q);
  body.ball = from.joint.ball;
  body.held = from.joint.ball && from.joint.held;
  body.eps = at.eps;
  body.omega = at.omega;
  body.held_eps = Eigen::Matrix<Real, 4, 1>(Real(eps[0]), Real(eps[1]), Real(eps[2]), Real(eps[3])).normalized();
  if (!body.ball) body.turns = detail::read_coordinates<Real>(from.joint.turns, at.theta, at.thetadot);
  body.slides = detail::read_coordinates<Real>(from.joint.slides, at.s, at.sdot);
  body.zero = detail::orthonormal<Real>(from.joint.zero);
  body.pitch = Real(from.joint.pitch);
  return body;
}

template <class Real>
Real System<Real>::constant(const scene::Number& number) const {
  if (number.kind == scene::Number::Kind::constant) return Real(number.value);
  if (number.kind == scene::Number::Kind::parameter) return Real(parameters_[static_cast<std::size_t>(number.index)]);
  throw InternalError(
      "an input or expression stands where only loads may vary: masses, inertias and lengths are constants or "
      "parameters");
}

template <class Real>
Vector3<Real> System<Real>::constant(const scene::Vector& a) const {
  return {constant(a[0]), constant(a[1]), constant(a[2])};
}

template <class Real>
Matrix3<Real> System<Real>::symmetric(const scene::Symmetric& a) const {
  const Real I_xx = constant(a.xx), I_yy = constant(a.yy), I_zz = constant(a.zz);
  const Real I_xy = constant(a.xy), I_xz = constant(a.xz), I_yz = constant(a.yz);
  Matrix3<Real> m;
  m << I_xx, I_xy, I_xz,  //
      I_xy, I_yy, I_yz,   //
      I_xz, I_yz, I_zz;
  return m;
}

template <class Real>
Real System<Real>::value(const scene::Number& number, const Arguments<Real>& at) const {
  using Kind = scene::ExpressionNode::Kind;
  const auto index = static_cast<std::size_t>(number.index);
  if (number.kind == scene::Number::Kind::input) return at.u[index];
  if (number.kind != scene::Number::Kind::expression) return constant(number);
  return value_of<Real>(scene_.expressions[index], [&](const scene::ExpressionNode& node) -> Real {
    const auto i = static_cast<std::size_t>(node.index);
    switch (node.kind) {
      case Kind::time:
        return at.t;
      case Kind::coordinate:
        return at.x[i];
      case Kind::speed:
        return at.y[i];
      case Kind::parameter:
        return Real(parameters_[i]);
      case Kind::input:
        return at.u[i];
      default:
        throw InternalError("an expression has a leaf of unknown kind");
    }
  });
}

template <class Real>
Vector3<Real> System<Real>::vector(const scene::Vector& a, const Arguments<Real>& at) const {
  return {value(a[0], at), value(a[1], at), value(a[2], at)};
}

// Time as a Dual of Duals with the rate 1: the expression's rate has the second derivative as its own.
template <class Real>
auto System<Real>::course(int expression, const Real& t) const -> Course {
  using Kind = scene::ExpressionNode::Kind;
  using Once = Dual<Real>;
  using Twice = Dual<Once>;
  const Twice time(Once(t, Real(1)), Once(Real(1)));
  const Twice course =
      value_of<Twice>(scene_.expressions[static_cast<std::size_t>(expression)], [&](const scene::ExpressionNode& node) {
        if (node.kind == Kind::time) return time;
        if (node.kind == Kind::parameter) return Twice(parameters_[static_cast<std::size_t>(node.index)]);
        throw InternalError("a prescribed motion reads more than time and parameters");
      });
  return {course.value.value, course.value.rate, course.rate.rate};
}

}  // namespace kanec::generic
