// SPDX-License-Identifier: BSD-3-Clause
// spinning_top: equations of motion of 1 rigid body, made by kanec 0.1.0. Not to be edited by hand.
//
// model fe281d1d2f8b023d of spinning_top/scene.toml; the usual functions
// bodies and their joints:
//   1 top on the inertial frame: ball
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4)
//   y = (omega_1_1 .. omega_1_3)
//   eps       Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)
//   omega     absolute angular velocity, body axes [rad/s] (3)
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              23 (8 add, 15 multiply)
//   poses                   26 (11 add, 15 multiply)
//   energy                  51 (17 add, 34 multiply)
//   momentum                70 (26 add, 44 multiply)
//   accelerations           20 (4 add, 16 multiply)
//   residual                32 (13 add, 19 multiply)
//   forcing                 18 (4 add, 14 multiply)
//   mass_matrix             0 (0 add, 0 multiply)
//   partial_velocities      25 (7 add, 18 multiply)
//   partial_velocity_rates  47 (17 add, 30 multiply)
#pragma once

namespace kanec::spinning_top {

inline constexpr int n_bodies = 1;
inline constexpr int nx = 4;
inline constexpr int ny = 3;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 0;
inline constexpr char model_hash[] = "fe281d1d2f8b023d";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2;
inline constexpr int eps_top_1 = 0, eps_top_2 = 1, eps_top_3 = 2, eps_top_4 = 3;
inline constexpr int omega_top_1 = 0, omega_top_2 = 1, omega_top_3 = 2;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 3;
inline constexpr int mass_matrix_rows[] = {0, 1, 2};
inline constexpr int mass_matrix_columns[] = {0, 1, 2};

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

  // ---- body 1 (top) on the inertial frame
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
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 11 add, 15 multiply
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {

  // ---- body 1 (top) on the inertial frame
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
  pose[1] = R1_12;
  pose[2] = R1_13;
  pose[3] = R1_21;
  pose[4] = R1_22;
  pose[5] = R1_23;
  pose[6] = R1_31;
  pose[7] = R1_32;
  pose[8] = R1_33;
  // p1 = R1^T r1: position of the mass centre, inertial axes [m]
  const T p1_1 = R1_31 * T(0.05);
  const T p1_2 = R1_32 * T(0.05);
  const T p1_3 = R1_33 * T(0.05);
  pose[9] = p1_1;
  pose[10] = p1_2;
  pose[11] = p1_3;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 17 add, 34 multiply
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {

  // ---- body 1 (top) on the inertial frame
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
  const T R1_13 = t1_5 * eps1_3 - t1_1 * eps1_4;
  const T R1_21 = t1_6 - t1_7;
  const T t1_8 = T(1) - t1_5 * eps1_1;
  const T R1_22 = t1_8 - t1_4;
  const T R1_23 = t1_1 * eps1_3 + t1_5 * eps1_4;
  const T R1_33 = t1_8 - t1_2;
  // p1 = R1^T r1: position of the mass centre, inertial axes [m]
  const T p1_3 = R1_33 * T(0.05);
  // v1 = R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_9 = omega1_2 * T(0.05);
  const T t1_10 = omega1_1 * T(0.05);
  const T v1_1 = R1_11 * t1_9 - R1_21 * t1_10;
  const T v1_2 = R1_12 * t1_9 - R1_22 * t1_10;
  const T v1_3 = R1_13 * t1_9 - R1_23 * t1_10;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.5) * (T(2e-04) * omega1_1 * omega1_1 + T(2e-04) * omega1_2 * omega1_2 + T(0.00025) * omega1_3 *
      omega1_3) + T(0.15) * (v1_1 * v1_1 + v1_2 * v1_2 + v1_3 * v1_3);
  energy[0] = T1;

  // ---- whole system
  // mp = m1 p1: first moment of mass, inertial axes [kg m]
  const T mp_3 = T(0.3) * p1_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 26 add, 44 multiply
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {

  // ---- body 1 (top) on the inertial frame
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
  // p1 = R1^T r1: position of the mass centre, inertial axes [m]
  const T p1_1 = R1_31 * T(0.05);
  const T p1_2 = R1_32 * T(0.05);
  const T p1_3 = R1_33 * T(0.05);
  // v1 = R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_2 * T(0.05);
  const T t1_14 = omega1_1 * T(0.05);
  const T v1_1 = R1_11 * t1_13 - R1_21 * t1_14;
  const T v1_2 = R1_12 * t1_13 - R1_22 * t1_14;
  const T v1_3 = R1_13 * t1_13 - R1_23 * t1_14;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(0.3) * v1_1;
  const T l1_2 = T(0.3) * v1_2;
  const T l1_3 = T(0.3) * v1_3;
  momentum[0] = l1_1;
  momentum[1] = l1_2;
  momentum[2] = l1_3;
  // H1 = R1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_15 = T(2e-04) * omega1_1;
  const T t1_16 = T(2e-04) * omega1_2;
  const T t1_17 = T(0.00025) * omega1_3;
  const T H1_1 = R1_11 * t1_15 + R1_21 * t1_16 + R1_31 * t1_17 + p1_2 * l1_3 - p1_3 * l1_2;
  const T H1_2 = R1_12 * t1_15 + R1_22 * t1_16 + R1_32 * t1_17 + p1_3 * l1_1 - p1_1 * l1_3;
  const T H1_3 = R1_13 * t1_15 + R1_23 * t1_16 + R1_33 * t1_17 + p1_1 * l1_2 - p1_2 * l1_1;
  momentum[3] = H1_1;
  momentum[4] = H1_2;
  momentum[5] = H1_3;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 4 add, 16 multiply
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* ydot) noexcept {

  // ---- body 1 (top) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_2;
  const T R1_13 = t1_1 * eps1_3 - t1_2 * eps1_4;
  const T R1_23 = t1_2 * eps1_3 + t1_1 * eps1_4;
  // N1 = -h_all_1~ R1 Pddot1 - omega1~ J_all_1 omega1: applied less inertia moment about the body origin, body axes
  //   [N m]
  const T N1_1 = R1_23 * T(9.81) * T(0.015) + omega1_2 * omega1_3 * T(0.0007000000000000001);
  const T minus_N1_2 = R1_13 * T(9.81) * T(0.015) + omega1_1 * omega1_3 * T(0.0007000000000000001);

  // ---- body 1 (top) and what it carries
  // w_1 = D(LD1)^-1 L(LD1)^-1 N1: D^-1 L^-1 n
  const T w_1_1 = T(1052.6315789473683) * N1_1;
  const T minus_w_1_2 = T(1052.6315789473683) * minus_N1_2;
  ydot[0] = w_1_1;
  ydot[1] = -minus_w_1_2;

  // ---- results
  ydot[2] = T(0);
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 13 add, 19 multiply
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, T* r) noexcept {

  // ---- body 1 (top) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_2;
  const T R1_13 = t1_1 * eps1_3 - t1_2 * eps1_4;
  const T R1_23 = t1_2 * eps1_3 + t1_1 * eps1_4;
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t1_3 = omega1_2 * omega1_1;
  const T U1_12 = t1_3 - omegadot1_3;
  const T t1_4 = omega1_3 * omega1_1;
  const T U1_13 = t1_4 + omegadot1_2;
  const T U1_21 = t1_3 + omegadot1_3;
  const T t1_5 = omega1_3 * omega1_2;
  const T U1_23 = t1_5 - omegadot1_1;
  const T U1_31 = t1_4 - omegadot1_2;
  const T U1_32 = t1_5 + omegadot1_1;
  // N1 = h_all_1~ R1 Pddot1 + axial(U1 (tr(J_all_1)/2 - J_all_1)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N1_1 = T(0.000125) * U1_32 - T(0.0008250000000000001) * U1_23 - R1_23 * T(9.81) * T(0.015);
  const T N1_2 = R1_13 * T(9.81) * T(0.015) + T(0.0008250000000000001) * U1_13 - T(0.000125) * U1_31;
  const T N1_3 = T(0.000125) * U1_21 - T(0.000125) * U1_12;
  r[0] = N1_1;
  r[1] = N1_2;
  r[2] = N1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 4 add, 14 multiply
template <class T>
void forcing([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* f) noexcept {

  // ---- body 1 (top) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_2;
  const T R1_13 = t1_1 * eps1_3 - t1_2 * eps1_4;
  const T R1_23 = t1_2 * eps1_3 + t1_1 * eps1_4;
  // N1 = -h_all_1~ R1 Pddot1 - omega1~ J_all_1 omega1: applied less inertia moment about the body origin, body axes
  //   [N m]
  const T N1_1 = R1_23 * T(9.81) * T(0.015) + omega1_3 * omega1_2 * T(0.0007000000000000001);
  const T minus_N1_2 = R1_13 * T(9.81) * T(0.015) + omega1_3 * omega1_1 * T(0.0007000000000000001);
  f[0] = N1_1;
  f[1] = -minus_N1_2;

  // ---- results
  f[2] = -T(0);
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 0 add, 0 multiply
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, T* A) noexcept {

  // ---- results
  A[0] = T(0.0009500000000000001);
  A[4] = T(0.0009500000000000001);
  A[1] = T(0);
  A[2] = T(0);
  A[3] = T(0);
  A[5] = T(0);
  A[6] = T(0);
  A[7] = T(0);
  A[8] = T(0.00025);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 7 add, 18 multiply
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  T block[9];

  // ---- body 1 (top) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_3;
  const T t1_2 = T(1) - t1_1 * eps1_3;
  const T t1_3 = T(2) * eps1_2;
  const T R1_11 = t1_2 - t1_3 * eps1_2;
  const T t1_4 = T(2) * eps1_1;
  const T t1_5 = t1_4 * eps1_2;
  const T t1_6 = t1_1 * eps1_4;
  const T R1_12 = t1_5 + t1_6;
  const T R1_13 = t1_4 * eps1_3 - t1_3 * eps1_4;
  const T R1_21 = t1_5 - t1_6;
  const T R1_22 = t1_2 - t1_4 * eps1_1;
  const T R1_23 = t1_3 * eps1_3 + t1_4 * eps1_4;
  // B1_1 = -R1^T r1~
  const T minus_B1_1_11 = R1_21 * T(0.05);
  const T B1_1_12 = R1_11 * T(0.05);
  const T minus_B1_1_21 = R1_22 * T(0.05);
  const T B1_1_22 = R1_12 * T(0.05);
  const T minus_B1_1_31 = R1_23 * T(0.05);
  const T B1_1_32 = R1_13 * T(0.05);
  block[0] = -minus_B1_1_11;
  block[1] = B1_1_12;
  block[3] = -minus_B1_1_21;
  block[4] = B1_1_22;
  block[6] = -minus_B1_1_31;
  block[7] = B1_1_32;

  // ---- results
  block[2] = -T(0);
  block[5] = -T(0);
  block[8] = -T(0);

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,0},
  };
  for (int i = 0; i < 9; ++i) v_y[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y[place[1] + i * 3 + j] = block[9 * place[0] + 3 * i + j];
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 17 add, 30 multiply
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  T block[9];

  // ---- body 1 (top) on the inertial frame
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
  const T minus_B1_1_11 = (R1_31 * omega1_1 - R1_11 * omega1_3) * T(0.05);
  const T B1_1_12 = (R1_21 * omega1_3 - R1_31 * omega1_2) * T(0.05);
  const T minus_B1_1_21 = (R1_32 * omega1_1 - R1_12 * omega1_3) * T(0.05);
  const T B1_1_22 = (R1_22 * omega1_3 - R1_32 * omega1_2) * T(0.05);
  const T minus_B1_1_31 = (R1_33 * omega1_1 - R1_13 * omega1_3) * T(0.05);
  const T B1_1_32 = (R1_23 * omega1_3 - R1_33 * omega1_2) * T(0.05);
  block[0] = -minus_B1_1_11;
  block[1] = B1_1_12;
  block[3] = -minus_B1_1_21;
  block[4] = B1_1_22;
  block[6] = -minus_B1_1_31;
  block[7] = B1_1_32;

  // ---- results
  block[2] = -T(0);
  block[5] = -T(0);
  block[8] = -T(0);

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,0},
  };
  for (int i = 0; i < 9; ++i) v_y_dot[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y_dot[place[1] + i * 3 + j] = block[9 * place[0] + 3 * i + j];
}

}  // namespace kanec::spinning_top
