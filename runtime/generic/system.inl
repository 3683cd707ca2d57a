// The bodies of system.hpp, for scalars other than double and long double. Not needed for these two.
// Such a scalar needs + - * /, comparisons, construction from double and int, sqrt and abs found by argument-dependent
// lookup, and a specialisation of Eigen::NumTraits.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include "runtime/base/error.hpp"
#include "runtime/generic/system.hpp"

namespace kanec::generic {

namespace detail {

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

// R_Kᵀ = 1 + 2 ε4 ẽ + 2 ẽ ẽ, for |ε| = 1.
template <class Real>
Matrix3<Real> rotation_to_inertial(const Eigen::Matrix<Real, 4, 1>& eps) {
  const Matrix3<Real> e = skew<Real>(eps.template head<3>());
  return Matrix3<Real>::Identity() + Real(2) * eps[3] * e + Real(2) * e * e;
}

// Constants and parameters of the scene to values.
class Values {
 public:
  Values(const scene::Scene& scene, std::span<const double> parameters) : parameters_(parameters) {
    if (parameters.size() != scene.parameters.size())
      throw InputError("scene " + scene.name + ": " + std::to_string(parameters.size()) + " parameters given, " +
                       std::to_string(scene.parameters.size()) + " needed");
  }

  double value(const scene::Number& number) const {
    if (number.kind == scene::Number::Kind::input)
      throw InternalError(
          "an input stands where only loads may vary: masses, inertias and lengths are constants or parameters");
    return number.kind == scene::Number::Kind::constant ? number.value
                                                        : parameters_[static_cast<std::size_t>(number.index)];
  }

  template <class Real>
  Vector3<Real> vector(const scene::Vector& a) const {
    return {Real(value(a[0])), Real(value(a[1])), Real(value(a[2]))};
  }

  template <class Real>
  Matrix3<Real> matrix(const scene::Symmetric& a) const {
    const Real xx(value(a.xx)), yy(value(a.yy)), zz(value(a.zz)), xy(value(a.xy)), xz(value(a.xz)), yz(value(a.yz));
    Matrix3<Real> m;
    m << xx, xy, xz, xy, yy, yz, xz, yz, zz;
    return m;
  }

  // A load with its parameters replaced; inputs stay.
  scene::Vector load(scene::Vector a) const {
    for (scene::Number& number : a)
      if (number.kind == scene::Number::Kind::parameter) number = scene::Number::constant(value(number));
    return a;
  }

 private:
  std::span<const double> parameters_;
};

}  // namespace detail

template <class Real>
System<Real>::System(const scene::Scene& scene, std::span<const double> parameters)
    : name_(scene.name),
      n_bodies_(scene::size(scene)),
      n_inputs_(static_cast<int>(scene.inputs.size())),
      lower_(n_bodies_),
      body_(n_bodies_),
      masses_(3 * n_bodies_) {
  const detail::Values values(scene, parameters);
  gravity_ = values.vector<Real>(scene.gravity);
  for (int k = 1; k <= n_bodies_; ++k) {
    const scene::Body& body = scene.bodies[static_cast<std::size_t>(k - 1)];
    lower_[k] = scene.lower[static_cast<std::size_t>(k - 1)];
    body_[k] = {Real(values.value(body.mass)), values.matrix<Real>(body.inertia), values.vector<Real>(body.r),
                values.vector<Real>(body.q),   values.load(body.force),           values.load(body.moment)};
    masses_.template segment<3>(rows_of(k)).setConstant(body_[k].m);
  }
}

template <class Real>
auto System<Real>::place(const Argument& x) const -> Frames {
  Frames at(n_bodies_);
  at[0] = {Matrix3<Real>::Identity(), Vector3<Real>::Zero(), Vector3<Real>::Zero(),
           Vector3<Real>::Zero(),     Vector3<Real>::Zero(), Vector3<Real>::Zero()};
  for (int k = 1; k <= n_bodies_; ++k) {
    const Frame& below = at[lower_[k]];
    // P = P_L + R_Lᵀ (q + s), p = P + Rᵀ r
    const Matrix3<Real> R_T = detail::rotation_to_inertial<Real>(x.template segment<4>(eps_at(k)));
    at[k].R = R_T.transpose();
    at[k].d = body_[k].q + x.template segment<3>(s_at(k));
    at[k].P = below.P + below.R.transpose() * at[k].d;
    at[k].p = at[k].P + R_T * body_[k].r;
  }
  return at;
}

template <class Real>
auto System<Real>::place_and_move(const Argument& x, const Argument& y) const -> Frames {
  Frames at = place(x);
  for (int k = 1; k <= n_bodies_; ++k) {
    at[k].omega = y.template segment<3>(omega_at(k));
    at[k].sdot = y.template segment<3>(sdot_at(k));
  }
  return at;
}

template <class Real>
Vector3<Real> System<Real>::load(const scene::Vector& numbers, const Argument& u) const {
  Vector3<Real> value;
  for (int i = 0; i < 3; ++i) {
    const scene::Number& number = numbers[static_cast<std::size_t>(i)];
    value[i] = number.kind == scene::Number::Kind::input ? u[number.index] : Real(number.value);
  }
  return value;
}

// d(e)/dt = ½ (ε4 ω + e × ω), d(ε4)/dt = -½ e·ω, d(s)/dt = ṡ.
template <class Real>
auto System<Real>::kinematics(const Argument& x, const Argument& y) const -> Vector {
  const Real half(0.5);
  Vector xdot(n_coordinates());
  for (int k = 1; k <= n_bodies_; ++k) {
    const Vector3<Real> e = x.template segment<3>(eps_at(k));
    const Vector3<Real> omega = y.template segment<3>(omega_at(k));
    xdot.template segment<3>(eps_at(k)) = half * (x[eps_at(k) + 3] * omega + e.cross(omega));
    xdot[eps_at(k) + 3] = -half * e.dot(omega);
    xdot.template segment<3>(s_at(k)) = y.template segment<3>(sdot_at(k));
  }
  return xdot;
}

// Down the path K, L(K), …; c is the body just above j on it.
template <class Real>
auto System<Real>::stack_v_y(const Frames& at) const -> Matrix {
  Matrix v_y = Matrix::Zero(3 * n_bodies_, n_speeds());
  for (int k = 1; k <= n_bodies_; ++k) {
    const auto block = [&](int column) { return v_y.template block<3, 3>(rows_of(k), column); };
    block(omega_at(k)) = -at[k].R.transpose() * detail::skew(body_[k].r);
    block(sdot_at(k)) = at[lower_[k]].R.transpose();
    for (int c = k, j = lower_[k]; j != 0; c = j, j = lower_[j]) {
      block(omega_at(j)) = -at[j].R.transpose() * detail::skew(at[c].d);
      block(sdot_at(j)) = at[lower_[j]].R.transpose();
    }
  }
  return v_y;
}

// The blocks of v_y differentiated with d(Rᵀ)/dt = Rᵀ ω̃; the inertial frame's ω is zero.
template <class Real>
auto System<Real>::stack_v_y_dot(const Frames& at) const -> Matrix {
  const auto R_T_dot = [&](int j) -> Matrix3<Real> { return at[j].R.transpose() * detail::skew(at[j].omega); };
  Matrix v_y_dot = Matrix::Zero(3 * n_bodies_, n_speeds());
  for (int k = 1; k <= n_bodies_; ++k) {
    const auto block = [&](int column) { return v_y_dot.template block<3, 3>(rows_of(k), column); };
    block(omega_at(k)) = -R_T_dot(k) * detail::skew(body_[k].r);
    block(sdot_at(k)) = R_T_dot(lower_[k]);
    for (int c = k, j = lower_[k]; j != 0; c = j, j = lower_[j]) {
      block(omega_at(j)) = -R_T_dot(j) * detail::skew(at[c].d) - at[j].R.transpose() * detail::skew(at[c].sdot);
      block(sdot_at(j)) = R_T_dot(lower_[j]);
    }
  }
  return v_y_dot;
}

// A = Σ (m v_yᵀ v_y + ω_yᵀ I ω_y); the stacked rows make the first sum one product, ω_y is one identity block.
template <class Real>
auto System<Real>::sum_mass_matrix(const Matrix& v_y) const -> Matrix {
  Matrix A = v_y.transpose() * (masses_.asDiagonal() * v_y);
  for (int k = 1; k <= n_bodies_; ++k) A.template block<3, 3>(omega_at(k), omega_at(k)) += body_[k].I;
  return A;
}

// f = Σ v_yᵀ (F - m v̇_y y) + Σ ω_yᵀ (M - ω̃ I ω), where F holds the weight too.
template <class Real>
auto System<Real>::sum_forcing(const Frames& at, const Matrix& v_y, const Argument& y, const Argument& u) const
    -> Vector {
  Vector forces = -(stack_v_y_dot(at) * y).cwiseProduct(masses_);
  for (int k = 1; k <= n_bodies_; ++k)
    forces.template segment<3>(rows_of(k)) += load(body_[k].force, u) + body_[k].m * gravity_;
  Vector f = v_y.transpose() * forces;
  for (int k = 1; k <= n_bodies_; ++k) {
    const Vector3<Real>& omega = at[k].omega;
    f.template segment<3>(omega_at(k)) += load(body_[k].moment, u) - omega.cross(body_[k].I * omega);
  }
  return f;
}

template <class Real>
auto System<Real>::mass_matrix(const Argument& x) const -> Matrix {
  return sum_mass_matrix(stack_v_y(place(x)));
}

template <class Real>
auto System<Real>::forcing(const Argument& x, const Argument& y, const Argument& u) const -> Vector {
  const Frames at = place_and_move(x, y);
  return sum_forcing(at, stack_v_y(at), y, u);
}

// A ẏ = Σ m v_yᵀ (v_y ẏ) + ω_yᵀ I ω̇.
template <class Real>
auto System<Real>::residual(const Argument& x, const Argument& y, const Argument& ydot, const Argument& u) const
    -> Vector {
  const Frames at = place_and_move(x, y);
  const Matrix v_y = stack_v_y(at);
  Vector r = v_y.transpose() * (v_y * ydot).cwiseProduct(masses_) - sum_forcing(at, v_y, y, u);
  for (int k = 1; k <= n_bodies_; ++k)
    r.template segment<3>(omega_at(k)) += body_[k].I * ydot.template segment<3>(omega_at(k));
  return r;
}

template <class Real>
auto System<Real>::accelerations(const Argument& x, const Argument& y, const Argument& u) const -> Vector {
  const Frames at = place_and_move(x, y);
  const Matrix v_y = stack_v_y(at);
  const Eigen::LLT<Matrix> factors(sum_mass_matrix(v_y));
  if (factors.info() != Eigen::Success)
    throw InputError("scene " + name_ + ": the mass matrix is not positive definite with these parameters");
  return factors.solve(sum_forcing(at, v_y, y, u));
}

template <class Real>
auto System<Real>::partial_velocities(const Argument& x) const -> Matrix {
  return stack_v_y(place(x));
}

template <class Real>
auto System<Real>::partial_velocity_rates(const Argument& x, const Argument& y) const -> Matrix {
  return stack_v_y_dot(place_and_move(x, y));
}

template <class Real>
auto System<Real>::partial_angular_velocities() const -> Matrix {
  return Matrix::Identity(3 * n_bodies_, n_speeds());
}

template <class Real>
auto System<Real>::partial_angular_velocity_rates() const -> Matrix {
  return Matrix::Zero(3 * n_bodies_, n_speeds());
}

template <class Real>
Energy<Real> System<Real>::energy(const Argument& x, const Argument& y) const {
  const Frames at = place_and_move(x, y);
  const Vector v = stack_v_y(at) * y;
  Energy<Real> energy{Real(0), Real(0)};
  for (int k = 1; k <= n_bodies_; ++k) {
    const Real translation = body_[k].m * v.template segment<3>(rows_of(k)).squaredNorm();
    const Real rotation = at[k].omega.dot(body_[k].I * at[k].omega);
    energy.kinetic += Real(0.5) * (translation + rotation);
    energy.potential -= body_[k].m * gravity_.dot(at[k].p);
  }
  return energy;
}

template <class Real>
Momentum<Real> System<Real>::momentum(const Argument& x, const Argument& y) const {
  const Frames at = place_and_move(x, y);
  const Vector mv = (stack_v_y(at) * y).cwiseProduct(masses_);
  Momentum<Real> sum{Vector3<Real>::Zero(), Vector3<Real>::Zero()};
  for (int k = 1; k <= n_bodies_; ++k) {
    const Vector3<Real> linear = mv.template segment<3>(rows_of(k));
    sum.linear += linear;
    sum.angular += at[k].p.cross(linear) + at[k].R.transpose() * (body_[k].I * at[k].omega);
  }
  return sum;
}

template <class Real>
std::vector<Pose<Real>> System<Real>::poses(const Argument& x) const {
  const Frames at = place(x);
  std::vector<Pose<Real>> poses;
  for (int k = 1; k <= n_bodies_; ++k) poses.push_back({at[k].R, at[k].p});
  return poses;
}

template <class Real>
Real System<Real>::power(const Argument& x, const Argument& y, const Argument& u) const {
  const Frames at = place_and_move(x, y);
  const Vector v = stack_v_y(at) * y;
  Real power(0);
  for (int k = 1; k <= n_bodies_; ++k)
    power += load(body_[k].force, u).dot(v.template segment<3>(rows_of(k))) + load(body_[k].moment, u).dot(at[k].omega);
  return power;
}

}  // namespace kanec::generic
