// Kane's equations of a scene, evaluated by loops over its bodies: what emitted code is checked against. Not: fast, nor
// any part of the generator; of the scene it takes the data alone.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"

namespace kanec::generic {

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;
template <class Real>
using Matrix3 = Eigen::Matrix<Real, 3, 3>;

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

template <class Real>
struct Energy {
  Real kinetic, potential;  // [J]; potential = -Σ m g·p
};

template <class Real>
struct Momentum {
  Vector3<Real> linear;   // inertial axes [kg m/s]
  Vector3<Real> angular;  // about the inertial origin, inertial axes [kg m²/s]
};

template <class Real>
struct Pose {
  Matrix3<Real> R;  // inertial to body components
  Vector3<Real> p;  // mass centre, inertial axes [m]
};

// Letters, frames, state order and domain (|ε| = 1) as in CONVENTIONS.md; x (7N), y and ydot (6N), u (inputs of the
// scene). Real is double or long double; for another scalar include system.inl, which says what it must offer.
template <class Real>
class System {
 public:
  using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
  using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
  using Argument = Eigen::Ref<const Vector>;

  // `parameters`: a value for each parameter of the scene, in its order. Throws InputError when their number differs.
  System(const scene::Scene& scene, std::span<const double> parameters);

  int n_bodies() const { return n_bodies_; }
  int n_coordinates() const { return 7 * n_bodies_; }
  int n_speeds() const { return 6 * n_bodies_; }
  int n_inputs() const { return n_inputs_; }

  Vector kinematics(const Argument& x, const Argument& y) const;                  // ẋ (7N)
  Matrix mass_matrix(const Argument& x) const;                                    // A (6N × 6N)
  Vector forcing(const Argument& x, const Argument& y, const Argument& u) const;  // f (6N)

  // A ẏ - f (6N), by sums over the bodies; A is not formed.
  Vector residual(const Argument& x, const Argument& y, const Argument& ydot, const Argument& u) const;

  // ẏ (6N) by Cholesky's factorisation of A. Throws InputError where A is not positive definite.
  Vector accelerations(const Argument& x, const Argument& y, const Argument& u) const;

  // Rows 3(K-1) to 3(K-1)+2 are those of body K (3N × 6N).
  Matrix partial_velocities(const Argument& x) const;
  Matrix partial_velocity_rates(const Argument& x, const Argument& y) const;
  Matrix partial_angular_velocities() const;      // the same in every state
  Matrix partial_angular_velocity_rates() const;  // zero

  Energy<Real> energy(const Argument& x, const Argument& y) const;
  Momentum<Real> momentum(const Argument& x, const Argument& y) const;
  std::vector<Pose<Real>> poses(const Argument& x) const;                     // (N)
  Real power(const Argument& x, const Argument& y, const Argument& u) const;  // of F and M, gravity not included [W]

 private:
  // The physical numbers of a body; of the loads, only those that are inputs are still open.
  struct Numbers {
    Real m{};
    Matrix3<Real> I;
    Vector3<Real> r, q;
    scene::Vector force, moment;
  };
  // Where a body is and how it moves.
  struct Frame {
    Matrix3<Real> R;            // inertial to body components
    Vector3<Real> d;            // q + s, L(K)'s axes
    Vector3<Real> P, p;         // origin and mass centre, inertial axes
    Vector3<Real> omega, sdot;  // body axes, L(K)'s axes
  };
  using Frames = ByBody<Frame>;

  int eps_at(int k) const { return 4 * (k - 1); }
  int s_at(int k) const { return 4 * n_bodies_ + 3 * (k - 1); }
  int omega_at(int k) const { return 3 * (k - 1); }
  int sdot_at(int k) const { return 3 * (n_bodies_ + k - 1); }
  int rows_of(int k) const { return 3 * (k - 1); }

  Frames place(const Argument& x) const;                              // R, d, P, p
  Frames place_and_move(const Argument& x, const Argument& y) const;  // all
  Vector3<Real> load(const scene::Vector& numbers, const Argument& u) const;

  Matrix stack_v_y(const Frames& at) const;
  Matrix stack_v_y_dot(const Frames& at) const;
  Matrix sum_mass_matrix(const Matrix& v_y) const;
  Vector sum_forcing(const Frames& at, const Matrix& v_y, const Argument& y, const Argument& u) const;

  std::string name_;
  int n_bodies_;
  int n_inputs_;
  ByBody<int> lower_;
  ByBody<Numbers> body_;
  Vector3<Real> gravity_;  // inertial axes
  Vector masses_;          // of the rows of v_y (3N)
};

extern template class System<double>;
extern template class System<long double>;

}  // namespace kanec::generic
