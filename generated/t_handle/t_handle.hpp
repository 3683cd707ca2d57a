// SPDX-License-Identifier: BSD-3-Clause
// t_handle: equations of motion of 2 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model d5254dd329c8a167 of t_handle/scene.toml; the usual functions
// bodies and their joints:
//   1 bar on the inertial frame: free
//   2 stem on 1: weld
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, s_1_1 .. s_1_3)
//   y = (omega_1_1 .. omega_1_3, sdot_1_1 .. sdot_1_3)
//   eps       Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)
//   s         translation from the joint point, axes of the lower body [m]
//   omega     absolute angular velocity, body axes [rad/s] (3)
//   sdot      rate of s [m/s]
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              23 (8 add, 15 multiply)
//   poses                   35 (17 add, 18 multiply)
//   energy                  49 (18 add, 31 multiply)
//   momentum                76 (32 add, 44 multiply)
//   accelerations           55 (20 add, 35 multiply)
//   residual                82 (36 add, 46 multiply)
//   forcing                 67 (24 add, 43 multiply)
//   mass_matrix             25 (7 add, 18 multiply)
//   partial_velocities      31 (7 add, 24 multiply)
//   partial_velocity_rates  53 (17 add, 36 multiply)
#pragma once

namespace kanec::t_handle {

inline constexpr int n_bodies = 2;
inline constexpr int nx = 7;
inline constexpr int ny = 6;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 0;
inline constexpr char model_hash[] = "d5254dd329c8a167";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, s_1_1 = 4, s_1_2 = 5, s_1_3 = 6;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, sdot_1_1 = 3, sdot_1_2 = 4, sdot_1_3 = 5;
inline constexpr int eps_bar_1 = 0, eps_bar_2 = 1, eps_bar_3 = 2, eps_bar_4 = 3, s_bar_1 = 4, s_bar_2 = 5,
    s_bar_3 = 6;
inline constexpr int omega_bar_1 = 0, omega_bar_2 = 1, omega_bar_3 = 2, sdot_bar_1 = 3, sdot_bar_2 = 4,
    sdot_bar_3 = 5;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 18;
inline constexpr int mass_matrix_rows[] = {0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 4, 4, 4, 5, 5, 5};
inline constexpr int mass_matrix_columns[] = {0, 1, 3, 4, 5, 2, 3, 4, 5, 1, 2, 3, 1, 2, 4, 1, 2, 5};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
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
// 8 add, 15 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* xdot) noexcept {

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // w1 = 1/2 omega1: half the angular velocity [rad/s]
  const T w1_1 = T(0.5) * omega1_1;
  const T w1_2 = T(0.5) * omega1_2;
  const T w1_3 = T(0.5) * omega1_3;
  // edot1 = e1~ w1 + eps4_1 w1: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot1_1 = eps1_2 * w1_3 - eps1_3 * w1_2 + eps1_4 * w1_1;
  const T edot1_2 = eps1_3 * w1_1 - eps1_1 * w1_3 + eps1_4 * w1_2;
  const T edot1_3 = eps1_1 * w1_2 - eps1_2 * w1_1 + eps1_4 * w1_3;
  xdot[0] = edot1_1;
  xdot[1] = edot1_2;
  xdot[2] = edot1_3;
  // eps4dot1 = -e1 . w1: rate of eps_4 [1/s]
  const T minus_eps4dot1 = eps1_1 * w1_1 + eps1_2 * w1_2 + eps1_3 * w1_3;
  xdot[3] = -minus_eps4dot1;

  // ---- results
  const T sdot1_1 = y[3], sdot1_2 = y[4], sdot1_3 = y[5];
  xdot[4] = sdot1_1;
  xdot[5] = sdot1_2;
  xdot[6] = sdot1_3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 17 add, 18 multiply
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_2;
  const T t1_2 = t1_1 * eps1_2;
  const T t1_3 = T(2) * eps1_3;
  const T t1_4 = t1_3 * eps1_3;
  const T R1_11 = T(1) - t1_2 - t1_4;
  const T t1_5 = T(2) * eps1_1;
  const T t1_6 = t1_5 * eps1_2;
  const T t1_7 = t1_3 * eps1_4;
  const T R1_12 = t1_6 + t1_7;
  const T t1_8 = t1_5 * eps1_3;
  const T t1_9 = t1_1 * eps1_4;
  const T R1_13 = t1_8 - t1_9;
  const T R1_21 = t1_6 - t1_7;
  const T t1_10 = T(1) - t1_5 * eps1_1;
  const T R1_22 = t1_10 - t1_4;
  const T t1_11 = t1_1 * eps1_3;
  const T t1_12 = t1_5 * eps1_4;
  const T R1_23 = t1_11 + t1_12;
  const T R1_31 = t1_8 + t1_9;
  const T R1_32 = t1_11 - t1_12;
  const T R1_33 = t1_10 - t1_2;
  pose[0] = R1_11;
  pose[18] = R1_11;
  pose[1] = R1_12;
  pose[19] = R1_12;
  pose[2] = R1_13;
  pose[20] = R1_13;
  pose[3] = R1_21;
  pose[15] = R1_21;
  pose[4] = R1_22;
  pose[16] = R1_22;
  pose[5] = R1_23;
  pose[17] = R1_23;
  pose[6] = R1_31;
  pose[12] = -R1_31;
  pose[7] = R1_32;
  pose[13] = -R1_32;
  pose[8] = R1_33;
  pose[14] = -R1_33;

  // ---- results
  const T s1_1 = x[4], s1_2 = x[5], s1_3 = x[6];
  pose[9] = s1_1 - R1_11 * T(0.01);
  pose[10] = s1_2 - R1_12 * T(0.01);
  pose[11] = s1_3 - R1_13 * T(0.01);
  pose[21] = s1_1 + R1_11 * T(0.03);
  pose[22] = s1_2 + R1_12 * T(0.03);
  pose[23] = s1_3 + R1_13 * T(0.03);
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 18 add, 31 multiply
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[3], sdot1_2 = y[4], sdot1_3 = y[5];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_3;
  const T R1_21 = t1_1 * eps1_2 - t1_2 * eps1_4;
  const T t1_3 = T(1) - t1_1 * eps1_1;
  const T R1_22 = t1_3 - t1_2 * eps1_3;
  const T t1_4 = T(2) * eps1_2;
  const T t1_5 = t1_4 * eps1_3;
  const T t1_6 = t1_1 * eps1_4;
  const T R1_23 = t1_5 + t1_6;
  const T R1_31 = t1_1 * eps1_3 + t1_4 * eps1_4;
  const T R1_32 = t1_5 - t1_6;
  const T R1_33 = t1_3 - t1_4 * eps1_2;
  // v1 = sdot1 + R1^T omega1~ r_link1: velocity of the mass centre, inertial axes [m/s]
  const T t1_7 = omega1_3 * T(2.6020852139652105e-19);
  const T t1_8 = omega1_2 * T(2.6020852139652105e-19);
  const T v1_1 = sdot1_1 + R1_21 * t1_7 - R1_31 * t1_8;
  const T v1_2 = sdot1_2 + R1_22 * t1_7 - R1_32 * t1_8;
  const T v1_3 = sdot1_3 + R1_23 * t1_7 - R1_33 * t1_8;
  // T1 = 1/2 omega1 . (I_link1 omega1) + 1/2 m_link1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.5) * (T(0.0003707) * omega1_1 * omega1_1 + T(0.0001666) * omega1_2 * omega1_2 + T(0.0005191) *
      omega1_3 * omega1_3) + T(0.2) * (v1_1 * v1_1 + v1_2 * v1_2 + v1_3 * v1_3);
  energy[0] = T1;

  // ---- results
  energy[1] = T(0);
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 32 add, 44 multiply
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[4], s1_2 = x[5], s1_3 = x[6];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[3], sdot1_2 = y[4], sdot1_3 = y[5];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_2;
  const T t1_2 = t1_1 * eps1_2;
  const T t1_3 = T(2) * eps1_3;
  const T t1_4 = t1_3 * eps1_3;
  const T R1_11 = T(1) - t1_2 - t1_4;
  const T t1_5 = T(2) * eps1_1;
  const T t1_6 = t1_5 * eps1_2;
  const T t1_7 = t1_3 * eps1_4;
  const T R1_12 = t1_6 + t1_7;
  const T t1_8 = t1_5 * eps1_3;
  const T t1_9 = t1_1 * eps1_4;
  const T R1_13 = t1_8 - t1_9;
  const T R1_21 = t1_6 - t1_7;
  const T t1_10 = T(1) - t1_5 * eps1_1;
  const T R1_22 = t1_10 - t1_4;
  const T t1_11 = t1_1 * eps1_3;
  const T t1_12 = t1_5 * eps1_4;
  const T R1_23 = t1_11 + t1_12;
  const T R1_31 = t1_8 + t1_9;
  const T R1_32 = t1_11 - t1_12;
  const T R1_33 = t1_10 - t1_2;
  // p1 = s1 + R1^T r_link1: position of the mass centre, inertial axes [m]
  const T p1_1 = s1_1 + R1_11 * T(2.6020852139652105e-19);
  const T p1_2 = s1_2 + R1_12 * T(2.6020852139652105e-19);
  const T p1_3 = s1_3 + R1_13 * T(2.6020852139652105e-19);
  // v1 = sdot1 + R1^T omega1~ r_link1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_3 * T(2.6020852139652105e-19);
  const T t1_14 = omega1_2 * T(2.6020852139652105e-19);
  const T v1_1 = sdot1_1 + R1_21 * t1_13 - R1_31 * t1_14;
  const T v1_2 = sdot1_2 + R1_22 * t1_13 - R1_32 * t1_14;
  const T v1_3 = sdot1_3 + R1_23 * t1_13 - R1_33 * t1_14;
  // l1 = m_link1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(0.4) * v1_1;
  const T l1_2 = T(0.4) * v1_2;
  const T l1_3 = T(0.4) * v1_3;
  momentum[0] = l1_1;
  momentum[1] = l1_2;
  momentum[2] = l1_3;
  // H1 = R1^T I_link1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_15 = T(0.0003707) * omega1_1;
  const T t1_16 = T(0.0001666) * omega1_2;
  const T t1_17 = T(0.0005191) * omega1_3;
  const T H1_1 = R1_11 * t1_15 + R1_21 * t1_16 + R1_31 * t1_17 + p1_2 * l1_3 - p1_3 * l1_2;
  const T H1_2 = R1_12 * t1_15 + R1_22 * t1_16 + R1_32 * t1_17 + p1_3 * l1_1 - p1_1 * l1_3;
  const T H1_3 = R1_13 * t1_15 + R1_23 * t1_16 + R1_33 * t1_17 + p1_1 * l1_2 - p1_2 * l1_1;
  momentum[3] = H1_1;
  momentum[4] = H1_2;
  momentum[5] = H1_3;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 20 add, 35 multiply
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* ydot) noexcept {

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_2;
  const T t1_2 = t1_1 * eps1_2;
  const T t1_3 = T(2) * eps1_3;
  const T t1_4 = t1_3 * eps1_3;
  const T R1_11 = T(1) - t1_2 - t1_4;
  const T t1_5 = T(2) * eps1_1;
  const T t1_6 = t1_5 * eps1_2;
  const T t1_7 = t1_3 * eps1_4;
  const T R1_12 = t1_6 + t1_7;
  const T t1_8 = t1_5 * eps1_3;
  const T t1_9 = t1_1 * eps1_4;
  const T R1_13 = t1_8 - t1_9;
  const T R1_21 = t1_6 - t1_7;
  const T t1_10 = T(1) - t1_5 * eps1_1;
  const T R1_22 = t1_10 - t1_4;
  const T t1_11 = t1_1 * eps1_3;
  const T t1_12 = t1_5 * eps1_4;
  const T R1_23 = t1_11 + t1_12;
  const T R1_31 = t1_8 + t1_9;
  const T R1_32 = t1_11 - t1_12;
  const T R1_33 = t1_10 - t1_2;
  // N1 = -omega1~ I_link1 omega1: applied less gyroscopic moment, body axes [N m]
  const T minus_N1_1 = omega1_2 * omega1_3 * T(0.0003525);
  const T t1_13 = omega1_1 * omega1_3;
  const T N1_2 = T(0.0001484) * t1_13;
  const T t1_14 = omega1_1 * omega1_2;
  const T N1_3 = T(0.00020409999999999997) * t1_14;
  // omegadot1 = Iinv1 N1: I omegadot + omega~ I omega = M
  const T minus_omegadot1_1 = T(2697.5991367682764) * minus_N1_1;
  const T omegadot1_2 = T(6002.400960384153) * N1_2;
  const T omegadot1_3 = T(1926.4110961279137) * N1_3;
  ydot[0] = -minus_omegadot1_1;
  ydot[1] = omegadot1_2;
  ydot[2] = omegadot1_3;
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U1_11 = omega1_3 * omega1_3 + omega1_2 * omega1_2;
  const T U1_21 = t1_14 + omegadot1_3;
  const T U1_31 = t1_13 - omegadot1_2;
  // Pddot1 = -R1^T U1 r_link1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t1_15 = U1_21 * T(2.6020852139652105e-19);
  const T t1_16 = minus_U1_11 * T(2.6020852139652105e-19);
  const T t1_17 = U1_31 * T(2.6020852139652105e-19);
  const T minus_Pddot1_1 = R1_21 * t1_15 - R1_11 * t1_16 + R1_31 * t1_17;
  const T minus_Pddot1_2 = R1_22 * t1_15 - R1_12 * t1_16 + R1_32 * t1_17;
  const T minus_Pddot1_3 = R1_23 * t1_15 - R1_13 * t1_16 + R1_33 * t1_17;
  ydot[3] = -minus_Pddot1_1;
  ydot[4] = -minus_Pddot1_2;
  ydot[5] = -minus_Pddot1_3;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 36 add, 46 multiply
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, T* r) noexcept {

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[3], sddot1_2 = ydot[4], sddot1_3 = ydot[5];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_2;
  const T t1_2 = t1_1 * eps1_2;
  const T t1_3 = T(2) * eps1_3;
  const T t1_4 = t1_3 * eps1_3;
  const T R1_11 = T(1) - t1_2 - t1_4;
  const T t1_5 = T(2) * eps1_1;
  const T t1_6 = t1_5 * eps1_2;
  const T t1_7 = t1_3 * eps1_4;
  const T R1_12 = t1_6 + t1_7;
  const T t1_8 = t1_5 * eps1_3;
  const T t1_9 = t1_1 * eps1_4;
  const T R1_13 = t1_8 - t1_9;
  const T R1_21 = t1_6 - t1_7;
  const T t1_10 = T(1) - t1_5 * eps1_1;
  const T R1_22 = t1_10 - t1_4;
  const T t1_11 = t1_1 * eps1_3;
  const T t1_12 = t1_5 * eps1_4;
  const T R1_23 = t1_11 + t1_12;
  const T R1_31 = t1_8 + t1_9;
  const T R1_32 = t1_11 - t1_12;
  const T R1_33 = t1_10 - t1_2;
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U1_11 = omega1_3 * omega1_3 + omega1_2 * omega1_2;
  const T t1_13 = omega1_2 * omega1_1;
  const T U1_12 = t1_13 - omegadot1_3;
  const T t1_14 = omega1_3 * omega1_1;
  const T U1_13 = t1_14 + omegadot1_2;
  const T U1_21 = t1_13 + omegadot1_3;
  const T t1_15 = omega1_3 * omega1_2;
  const T U1_23 = t1_15 - omegadot1_1;
  const T U1_31 = t1_14 - omegadot1_2;
  const T U1_32 = t1_15 + omegadot1_1;
  // a1 = sddot1 + R1^T U1 r_link1: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t1_16 = U1_21 * T(2.6020852139652105e-19);
  const T t1_17 = minus_U1_11 * T(2.6020852139652105e-19);
  const T t1_18 = U1_31 * T(2.6020852139652105e-19);
  const T a1_1 = sddot1_1 + R1_21 * t1_16 - R1_11 * t1_17 + R1_31 * t1_18;
  const T a1_2 = sddot1_2 + R1_22 * t1_16 - R1_12 * t1_17 + R1_32 * t1_18;
  const T a1_3 = sddot1_3 + R1_23 * t1_16 - R1_13 * t1_17 + R1_33 * t1_18;
  // G1 = m_link1 a1: inertia less applied force, inertial axes [N]
  const T G1_1 = T(0.4) * a1_1;
  const T G1_2 = T(0.4) * a1_2;
  const T G1_3 = T(0.4) * a1_3;
  r[3] = G1_1;
  r[4] = G1_2;
  r[5] = G1_3;
  // N1 = axial(U1 (tr(I_link1)/2 - I_link1)): inertia less applied moment about the mass centre, body axes [N m]
  const T N1_1 = T(0.0003616) * U1_32 - T(9.100000000000001e-06) * U1_23;
  const T N1_2 = T(9.100000000000001e-06) * U1_13 - T(0.0001575) * U1_31;
  const T N1_3 = T(0.0001575) * U1_21 - T(0.0003616) * U1_12;
  r[0] = N1_1;

  // ---- body 1 (bar) and what it carries
  // r_omega1 = r_link1~ R1 G1 + N1: Kane's equation of omega [N m]
  const T r_omega1_2 = N1_2 - T(2.6020852139652105e-19) * (R1_31 * G1_1 + R1_32 * G1_2 + R1_33 * G1_3);
  const T r_omega1_3 = N1_3 + T(2.6020852139652105e-19) * (R1_21 * G1_1 + R1_22 * G1_2 + R1_23 * G1_3);
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 24 add, 43 multiply
template <class T>
void forcing([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* f) noexcept {

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_2;
  const T t1_2 = t1_1 * eps1_2;
  const T t1_3 = T(2) * eps1_3;
  const T t1_4 = t1_3 * eps1_3;
  const T R1_11 = T(1) - t1_2 - t1_4;
  const T t1_5 = T(2) * eps1_1;
  const T t1_6 = t1_5 * eps1_2;
  const T t1_7 = t1_3 * eps1_4;
  const T R1_12 = t1_6 + t1_7;
  const T t1_8 = t1_5 * eps1_3;
  const T t1_9 = t1_1 * eps1_4;
  const T R1_13 = t1_8 - t1_9;
  const T R1_21 = t1_6 - t1_7;
  const T t1_10 = T(1) - t1_5 * eps1_1;
  const T R1_22 = t1_10 - t1_4;
  const T t1_11 = t1_1 * eps1_3;
  const T t1_12 = t1_5 * eps1_4;
  const T R1_23 = t1_11 + t1_12;
  const T R1_31 = t1_8 + t1_9;
  const T R1_32 = t1_11 - t1_12;
  const T R1_33 = t1_10 - t1_2;
  // U1 = omega1~ omega1~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T minus_U1_11 = omega1_3 * omega1_3 + omega1_2 * omega1_2;
  const T U1_12 = omega1_2 * omega1_1;
  const T U1_13 = omega1_3 * omega1_1;
  const T U1_23 = omega1_3 * omega1_2;
  // a1 = R1^T U1 r_link1: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t1_13 = U1_12 * T(2.6020852139652105e-19);
  const T t1_14 = minus_U1_11 * T(2.6020852139652105e-19);
  const T t1_15 = U1_13 * T(2.6020852139652105e-19);
  const T a1_1 = R1_21 * t1_13 - R1_11 * t1_14 + R1_31 * t1_15;
  const T a1_2 = R1_22 * t1_13 - R1_12 * t1_14 + R1_32 * t1_15;
  const T a1_3 = R1_23 * t1_13 - R1_13 * t1_14 + R1_33 * t1_15;
  // G1 = -m_link1 a1: applied less inertia force, inertial axes [N]
  const T minus_G1_1 = T(0.4) * a1_1;
  const T minus_G1_2 = T(0.4) * a1_2;
  const T minus_G1_3 = T(0.4) * a1_3;
  f[3] = -minus_G1_1;
  f[4] = -minus_G1_2;
  f[5] = -minus_G1_3;
  // N1 = -omega1~ I_link1 omega1: applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N1_1 = T(0.0003525) * U1_23;
  const T N1_2 = T(0.0001484) * U1_13;
  const T N1_3 = T(0.00020409999999999997) * U1_12;
  f[0] = -minus_N1_1;

  // ---- body 1 (bar) and what it carries
  // f_omega1 = r_link1~ R1 G1 + N1: Kane's equation of omega [N m]
  const T f_omega1_2 = T(2.6020852139652105e-19) * (R1_31 * minus_G1_1 + R1_32 * minus_G1_2 + R1_33 * minus_G1_3) +
      N1_2;
  const T f_omega1_3 = N1_3 - T(2.6020852139652105e-19) * (R1_21 * minus_G1_1 + R1_22 * minus_G1_2 + R1_23 *
      minus_G1_3);
  f[1] = f_omega1_2;
  f[2] = f_omega1_3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 7 add, 18 multiply
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  for (int i = 0; i < 36; ++i) A[i] = T(0);

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_3;
  const T R1_21 = t1_1 * eps1_2 - t1_2 * eps1_4;
  const T t1_3 = T(1) - t1_1 * eps1_1;
  const T R1_22 = t1_3 - t1_2 * eps1_3;
  const T t1_4 = T(2) * eps1_2;
  const T t1_5 = t1_4 * eps1_3;
  const T t1_6 = t1_1 * eps1_4;
  const T R1_23 = t1_5 + t1_6;
  const T R1_31 = t1_1 * eps1_3 + t1_4 * eps1_4;
  const T R1_32 = t1_5 - t1_6;
  const T R1_33 = t1_3 - t1_4 * eps1_2;

  // ---- results
  A[0] = T(0.0003707);
  A[7] = T(0.0001666);
  const T t1 = T(1.0408340855860842e-19) * R1_31;
  A[9] = -t1;
  A[19] = -t1;
  const T t2 = T(1.0408340855860842e-19) * R1_32;
  A[10] = -t2;
  A[25] = -t2;
  const T t3 = T(1.0408340855860842e-19) * R1_33;
  A[11] = -t3;
  A[31] = -t3;
  A[14] = T(0.0005191);
  const T t4 = T(1.0408340855860842e-19) * R1_21;
  A[15] = t4;
  A[20] = t4;
  const T t5 = T(1.0408340855860842e-19) * R1_22;
  A[16] = t5;
  A[26] = t5;
  const T t6 = T(1.0408340855860842e-19) * R1_23;
  A[17] = t6;
  A[32] = t6;
  A[21] = T(0.4);
  A[28] = T(0.4);
  A[35] = T(0.4);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 7 add, 24 multiply
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  T block[27];

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_3;
  const T R1_21 = t1_1 * eps1_2 - t1_2 * eps1_4;
  const T t1_3 = T(1) - t1_1 * eps1_1;
  const T R1_22 = t1_3 - t1_2 * eps1_3;
  const T t1_4 = T(2) * eps1_2;
  const T t1_5 = t1_4 * eps1_3;
  const T t1_6 = t1_1 * eps1_4;
  const T R1_23 = t1_5 + t1_6;
  const T R1_31 = t1_1 * eps1_3 + t1_4 * eps1_4;
  const T R1_32 = t1_5 - t1_6;
  const T R1_33 = t1_3 - t1_4 * eps1_2;
  // B1_1 = -R1^T r1~
  const T B1_1_12 = R1_31 * T(0.01);
  const T minus_B1_1_13 = R1_21 * T(0.01);
  const T B1_1_22 = R1_32 * T(0.01);
  const T minus_B1_1_23 = R1_22 * T(0.01);
  const T B1_1_32 = R1_33 * T(0.01);
  const T minus_B1_1_33 = R1_23 * T(0.01);
  block[1] = B1_1_12;
  block[2] = -minus_B1_1_13;
  block[4] = B1_1_22;
  block[5] = -minus_B1_1_23;
  block[7] = B1_1_32;
  block[8] = -minus_B1_1_33;
  // B3_1 = -R1^T (C2^T r2)~
  const T minus_B3_1_12 = R1_31 * T(0.03);
  const T B3_1_13 = R1_21 * T(0.03);
  const T minus_B3_1_22 = R1_32 * T(0.03);
  const T B3_1_23 = R1_22 * T(0.03);
  const T minus_B3_1_32 = R1_33 * T(0.03);
  const T B3_1_33 = R1_23 * T(0.03);
  block[19] = -minus_B3_1_12;
  block[20] = B3_1_13;
  block[22] = -minus_B3_1_22;
  block[23] = B3_1_23;
  block[25] = -minus_B3_1_32;
  block[26] = B3_1_33;

  // ---- results
  block[0] = -T(0);
  block[3] = -T(0);
  block[6] = -T(0);
  block[10] = T(0);
  block[11] = T(0);
  block[12] = T(0);
  block[14] = T(0);
  block[15] = T(0);
  block[16] = T(0);
  block[18] = -T(0);
  block[21] = -T(0);
  block[24] = -T(0);
  block[9] = T(1);
  block[13] = T(1);
  block[17] = T(1);

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,0}, {1,3}, {2,18}, {1,21},
  };
  for (int i = 0; i < 36; ++i) v_y[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y[place[1] + i * 6 + j] = block[9 * place[0] + 3 * i + j];
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 17 add, 36 multiply
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  T block[18];

  // ---- body 1 (bar) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_2;
  const T t1_2 = t1_1 * eps1_2;
  const T t1_3 = T(2) * eps1_3;
  const T t1_4 = t1_3 * eps1_3;
  const T R1_11 = T(1) - t1_2 - t1_4;
  const T t1_5 = T(2) * eps1_1;
  const T t1_6 = t1_5 * eps1_2;
  const T t1_7 = t1_3 * eps1_4;
  const T R1_12 = t1_6 + t1_7;
  const T t1_8 = t1_5 * eps1_3;
  const T t1_9 = t1_1 * eps1_4;
  const T R1_13 = t1_8 - t1_9;
  const T R1_21 = t1_6 - t1_7;
  const T t1_10 = T(1) - t1_5 * eps1_1;
  const T R1_22 = t1_10 - t1_4;
  const T t1_11 = t1_1 * eps1_3;
  const T t1_12 = t1_5 * eps1_4;
  const T R1_23 = t1_11 + t1_12;
  const T R1_31 = t1_8 + t1_9;
  const T R1_32 = t1_11 - t1_12;
  const T R1_33 = t1_10 - t1_2;
  // B1_1 = -R1^T omega1~ r1~
  const T t1_13 = R1_11 * omega1_2 - R1_21 * omega1_1;
  const T B1_1_12 = t1_13 * T(0.01);
  const T t1_14 = R1_31 * omega1_1 - R1_11 * omega1_3;
  const T minus_B1_1_13 = t1_14 * T(0.01);
  const T t1_15 = R1_12 * omega1_2 - R1_22 * omega1_1;
  const T B1_1_22 = t1_15 * T(0.01);
  const T t1_16 = R1_32 * omega1_1 - R1_12 * omega1_3;
  const T minus_B1_1_23 = t1_16 * T(0.01);
  const T t1_17 = R1_13 * omega1_2 - R1_23 * omega1_1;
  const T B1_1_32 = t1_17 * T(0.01);
  const T t1_18 = R1_33 * omega1_1 - R1_13 * omega1_3;
  const T minus_B1_1_33 = t1_18 * T(0.01);
  block[1] = B1_1_12;
  block[2] = -minus_B1_1_13;
  block[4] = B1_1_22;
  block[5] = -minus_B1_1_23;
  block[7] = B1_1_32;
  block[8] = -minus_B1_1_33;
  // B2_1 = -R1^T omega1~ (C2^T r2)~
  const T minus_B2_1_12 = t1_13 * T(0.03);
  const T B2_1_13 = t1_14 * T(0.03);
  const T minus_B2_1_22 = t1_15 * T(0.03);
  const T B2_1_23 = t1_16 * T(0.03);
  const T minus_B2_1_32 = t1_17 * T(0.03);
  const T B2_1_33 = t1_18 * T(0.03);
  block[10] = -minus_B2_1_12;
  block[11] = B2_1_13;
  block[13] = -minus_B2_1_22;
  block[14] = B2_1_23;
  block[16] = -minus_B2_1_32;
  block[17] = B2_1_33;

  // ---- results
  block[0] = -T(0);
  block[3] = -T(0);
  block[6] = -T(0);
  block[9] = -T(0);
  block[12] = -T(0);
  block[15] = -T(0);

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,0}, {1,18},
  };
  for (int i = 0; i < 36; ++i) v_y_dot[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y_dot[place[1] + i * 6 + j] = block[9 * place[0] + 3 * i + j];
}

}  // namespace kanec::t_handle
