// SPDX-License-Identifier: BSD-3-Clause
// pendulum: equations of motion of 1 rigid body, made by kanec 0.1.0. Not to be edited by hand.
//
// model a0435cc64bbf5963 of pendulum/scene.toml; the usual functions
// bodies and their joints:
//   1 rod on the inertial frame: revolute
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (theta_1)
//   y = (thetadot_1)
//   theta     angle of a joint about its axis [rad]
//   thetadot  rate of theta [rad/s]
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one, and of
// its own or by conversion cos, sin.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              0 (0 add, 0 multiply)
//   poses                   2 (0 add, 2 multiply, 2 sine or cosine)
//   energy                  14 (2 add, 12 multiply, 2 sine or cosine)
//   momentum                12 (2 add, 10 multiply, 2 sine or cosine)
//   power                   2 (0 add, 2 multiply)
//   accelerations           5 (1 add, 4 multiply, 1 sine or cosine)
//   residual                6 (2 add, 4 multiply, 1 sine or cosine)
//   forcing                 4 (1 add, 3 multiply, 1 sine or cosine)
//   mass_matrix             0 (0 add, 0 multiply)
//   partial_velocities      2 (0 add, 2 multiply, 2 sine or cosine)
//   partial_velocity_rates  3 (0 add, 3 multiply, 2 sine or cosine)
#pragma once

#include <cmath>

namespace kanec::pendulum {

inline constexpr int n_bodies = 1;
inline constexpr int nx = 1;
inline constexpr int ny = 1;
inline constexpr int n_parameters = 1;
inline constexpr int n_inputs = 0;
inline constexpr char model_hash[] = "a0435cc64bbf5963";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_1 = 0;
inline constexpr int thetadot_1 = 0;
inline constexpr int theta_rod = 0;
inline constexpr int thetadot_rod = 0;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 1;
inline constexpr int mass_matrix_rows[] = {0};
inline constexpr int mass_matrix_columns[] = {0};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T c = T(0);
};

// What depends on parameters only, computed once for many calls.
template <class T>
struct Prepared {
  Parameters<T> p;
};

// prepare: 0 add, 0 multiply
template <class T>
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  Prepared<T> c{};
  c.p = p;
  return c;
}

// kinematics: xdot, the kinematical equations.
// rates of x (nx) [1/s], [rad/s], [m/s]
// 0 add, 0 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* xdot) noexcept {
  const T thetadot1 = y[0];
  xdot[0] = thetadot1;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 0 add, 2 multiply, 2 sine or cosine
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (rod) on the inertial frame
  const T theta1 = x[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  pose[0] = E1_11;
  pose[8] = E1_11;
  pose[2] = -minus_E1_13;
  pose[6] = minus_E1_13;
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T minus_p1_1 = minus_E1_13 * T(0.5);
  const T minus_p1_3 = E1_11 * T(0.5);
  pose[9] = -minus_p1_1;
  pose[11] = -minus_p1_3;

  // ---- results
  pose[1] = T(0);
  pose[3] = T(0);
  pose[5] = T(0);
  pose[7] = T(0);
  pose[10] = T(0);
  pose[4] = T(1);
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 2 add, 12 multiply, 2 sine or cosine
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (rod) on the inertial frame
  const T theta1 = x[0];
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T minus_p1_3 = E1_11 * T(0.5);
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_1 = thetadot1 * T(0.5);
  const T minus_v1_1 = E1_11 * t1_1;
  const T v1_3 = minus_E1_13 * t1_1;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.1) * thetadot1 * thetadot1 * T(0.5) + T(0.6) * (minus_v1_1 * minus_v1_1 + v1_3 * v1_3);
  energy[0] = T1;

  // ---- whole system
  // mp = m1 p1: first moment of mass, inertial axes [kg m]
  const T minus_mp_3 = T(1.2) * minus_p1_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T minus_potential = T(9.81) * minus_mp_3;
  energy[1] = -minus_potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 2 add, 10 multiply, 2 sine or cosine
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (rod) on the inertial frame
  const T theta1 = x[0];
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T minus_p1_1 = minus_E1_13 * T(0.5);
  const T minus_p1_3 = E1_11 * T(0.5);
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_1 = thetadot1 * T(0.5);
  const T minus_v1_1 = E1_11 * t1_1;
  const T v1_3 = minus_E1_13 * t1_1;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T minus_l1_1 = T(1.2) * minus_v1_1;
  const T l1_3 = T(1.2) * v1_3;
  momentum[0] = -minus_l1_1;
  momentum[2] = l1_3;
  // H1 = E1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T H1_2 = T(0.1) * thetadot1 + minus_p1_3 * minus_l1_1 + minus_p1_1 * l1_3;
  momentum[4] = H1_2;

  // ---- results
  momentum[1] = T(0);
  momentum[3] = T(0);
  momentum[5] = T(0);
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 0 add, 2 multiply
template <class T>
void power(const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* out) noexcept {

  // ---- body 1 (rod) on the inertial frame
  const T thetadot1 = y[0];
  // effort_rod_1 = -thetadot1 c_rod_: along the coordinate [N m], [N]
  const T minus_effort_rod_1 = thetadot1 * c.p.c;

  // ---- whole system
  // power = thetadot1 effort_rod_1: power of the applied loads [W]
  const T minus_power = thetadot1 * minus_effort_rod_1;
  out[0] = -minus_power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 1 add, 4 multiply, 1 sine or cosine
template <class T>
void accelerations(const Prepared<T>& c, const T* x, const T* y, T* ydot) noexcept {
  using std::sin;

  // ---- body 1 (rod) on the inertial frame
  const T theta1 = x[0];
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T minus_E1_13 = sin(theta1);
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  // effort_rod_1 = -thetadot1 c_rod_: along the coordinate [N m], [N]
  const T minus_effort_rod_1 = thetadot1 * c.p.c;
  // N1 = -h_own_1~ Pddot1 - axial(U1 (tr(J_own_1)/2 - J_own_1)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N1_2 = T(0.6) * minus_Pddot1_1;

  // ---- body 1 (rod) and what it carries
  // u_1 = b1 . N1 + effort_rod_1: drives it [N m], [N]
  const T minus_u_1 = minus_effort_rod_1 + minus_N1_2;
  // v1 = invD1 u_1: u/D
  const T minus_v1 = T(2.5) * minus_u_1;
  ydot[0] = -minus_v1;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 2 add, 4 multiply, 1 sine or cosine
template <class T>
void residual(const Prepared<T>& c, const T* x, const T* y, const T* ydot, T* r) noexcept {
  using std::sin;

  // ---- body 1 (rod) on the inertial frame
  const T theta1 = x[0];
  const T thetadot1 = y[0];
  const T thetaddot1 = ydot[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T minus_E1_13 = sin(theta1);
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  // effort_rod_1 = -thetadot1 c_rod_: along the coordinate [N m], [N]
  const T minus_effort_rod_1 = thetadot1 * c.p.c;
  // N1 = h_own_1~ Pddot1 + axial(U1 (tr(J_own_1)/2 - J_own_1)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N1_2 = T(0.6) * minus_Pddot1_1 + T(0.4) * thetaddot1;

  // ---- body 1 (rod) and what it carries
  // r_theta1 = b1 . N1 - effort_rod_1: Kane's equation of the angle [N m]
  const T r_theta1 = N1_2 + minus_effort_rod_1;
  r[0] = r_theta1;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 1 add, 3 multiply, 1 sine or cosine
template <class T>
void forcing(const Prepared<T>& c, const T* x, const T* y, T* f) noexcept {
  using std::sin;

  // ---- body 1 (rod) on the inertial frame
  const T theta1 = x[0];
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T minus_E1_13 = sin(theta1);
  // effort_rod_1 = -thetadot1 c_rod_: along the coordinate [N m], [N]
  const T minus_effort_rod_1 = thetadot1 * c.p.c;
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  // N1 = -h_own_1~ Pddot1 - axial(U1 (tr(J_own_1)/2 - J_own_1)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N1_2 = T(0.6) * minus_Pddot1_1;

  // ---- body 1 (rod) and what it carries
  // f_theta1 = b1 . N1 + effort_rod_1: Kane's equation of the angle [N m]
  const T minus_f_theta1 = minus_effort_rod_1 + minus_N1_2;
  f[0] = -minus_f_theta1;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 0 add, 0 multiply
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, T* A) noexcept {

  // ---- results
  A[0] = T(0.4);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 0 add, 2 multiply, 2 sine or cosine
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (rod) on the inertial frame
  const T theta1 = x[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // B1_1 = -E1^T r1~ b1
  const T minus_B1_1_1 = E1_11 * T(0.5);
  const T B1_1_3 = minus_E1_13 * T(0.5);
  v_y[0] = -minus_B1_1_1;
  v_y[2] = B1_1_3;

  // ---- results
  v_y[1] = -T(0);
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 0 add, 3 multiply, 2 sine or cosine
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (rod) on the inertial frame
  const T theta1 = x[0];
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // B1_1 = -E1^T omega1~ r1~ b1
  const T t1_1 = thetadot1 * T(0.5);
  const T B1_1_1 = minus_E1_13 * t1_1;
  const T B1_1_3 = E1_11 * t1_1;
  v_y_dot[0] = B1_1_1;
  v_y_dot[2] = B1_1_3;

  // ---- results
  v_y_dot[1] = -T(0);
}

}  // namespace kanec::pendulum
