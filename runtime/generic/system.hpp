// A scene with the values of its parameters, its numbers in one scalar: what the generic path evaluates. Not: any
// state, nor any part of the generator; of the scene it takes the data alone.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/generic/dual.hpp"

namespace kanec::generic {

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using Matrix3 = Eigen::Matrix<Real, 3, 3>;
template <class Real>
using VectorX = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
template <class Real>
using MatrixX = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;

// One entry a body, numbered as in the text: [1] to [N], and [0] for the inertial frame.
template <class T>
class ByBody {
 public:
  explicit ByBody(int n_bodies) : entries_(static_cast<std::size_t>(n_bodies) + 1) {}
  T& operator[](int k) { return entries_[static_cast<std::size_t>(k)]; }
  const T& operator[](int k) const { return entries_[static_cast<std::size_t>(k)]; }

 private:
  std::vector<T> entries_;
};

// The arguments of an evaluation; those that the function does not read may be empty.
template <class Real>
struct Arguments {
  Real t{};
  std::span<const Real> x = {}, y = {}, ydot = {}, u = {};
};

// One angle or translation of a joint.
template <class Real>
struct Coordinate {
  Vector3<Real> axis;  // of unit length to rounding of Real
  scene::Coordinate::Motion motion;
  Real locked_at{};
  int expression = 0;  // of a prescribed motion
  int x = -1, y = -1;  // where a free one stands
};

// The physical numbers of a body and its joint.
template <class Real>
struct Body {
  int lower = 0;
  Real m{};
  Matrix3<Real> I;
  Vector3<Real> r, q;
  bool ball = true, held = false;
  int eps = -1, omega = -1;  // of a ball that is not held
  Eigen::Matrix<Real, 4, 1> held_eps;
  std::vector<Coordinate<Real>> turns, slides;
  Matrix3<Real> zero;
  Real pitch{};
};

// Letters, frames and state order as in CONVENTIONS.md; x, y, ydot and u (inputs of the scene) as scene::Layout has
// them. Real: double, long double, or Dual of these.
template <class Real>
class System {
 public:
  // `parameters`: a value for each parameter of the scene, in its order. Throws InputError when their number differs.
  System(const scene::Scene& scene, std::span<const double> parameters);

  int n_bodies() const { return scene::size(scene_); }
  int n_coordinates() const { return layout_.nx; }
  int n_speeds() const { return layout_.ny; }
  int n_inputs() const { return static_cast<int>(scene_.inputs.size()); }

  const scene::Scene& scene() const { return scene_; }
  const std::vector<double>& parameters() const { return parameters_; }
  const Body<Real>& body(int k) const { return bodies_[k]; }
  const Vector3<Real>& gravity() const { return gravity_; }

  // A number of a load.
  Real value(const scene::Number& number, const Arguments<Real>& at) const;
  Vector3<Real> vector(const scene::Vector& a, const Arguments<Real>& at) const;
  // A number that is a constant or a parameter. Throws InternalError for others.
  Real constant(const scene::Number& number) const;
  Vector3<Real> constant(const scene::Vector& a) const;

  // An expression of time and parameters with its first and second time derivatives.
  struct Course {
    Real value, rate, second_rate;
  };
  Course course(int expression, const Real& t) const;

 private:
  Matrix3<Real> symmetric(const scene::Symmetric& a) const;
  Body<Real> read_body(int k) const;

  scene::Scene scene_;
  std::vector<double> parameters_;
  scene::Layout layout_;
  ByBody<Body<Real>> bodies_;
  Vector3<Real> gravity_;  // inertial axes
};

extern template class System<double>;
extern template class System<long double>;
extern template class System<Dual<double>>;
extern template class System<Dual<long double>>;

}  // namespace kanec::generic
