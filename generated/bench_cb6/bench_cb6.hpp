// SPDX-License-Identifier: BSD-3-Clause
// bench_cb6: equations of motion of 6 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 5d87b4d0845fb4cb of bench_cb6/scene.toml; the usual functions
// bodies and their joints:
//   1 body_1 on the inertial frame: ball
//   2 body_2 on 1: ball
//   3 body_3 on 2: ball
//   4 body_4 on 3: ball
//   5 body_5 on 4: ball
//   6 body_6 on 5: ball
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, eps_2_1 .. eps_2_4, eps_3_1 .. eps_3_4, eps_4_1 .. eps_4_4, eps_5_1 .. eps_5_4,
//   eps_6_1 .. eps_6_4)
//   y = (omega_1_1 .. omega_1_3, omega_2_1 .. omega_2_3, omega_3_1 .. omega_3_3, omega_4_1 .. omega_4_3,
//   omega_5_1 .. omega_5_3, omega_6_1 .. omega_6_3)
//   eps       Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)
//   omega     absolute angular velocity, body axes [rad/s] (3)
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              138 (48 add, 90 multiply)
//   poses                   324 (156 add, 168 multiply)
//   energy                  666 (298 add, 368 multiply)
//   momentum                905 (420 add, 485 multiply)
//   power                   353 (158 add, 195 multiply)
//   accelerations           2363 (1080 add, 1268 multiply, 15 divide)
//   residual                1105 (539 add, 566 multiply)
//   forcing                 1031 (485 add, 546 multiply)
//   mass_matrix             1227 (475 add, 752 multiply)
//   partial_velocities      405 (165 add, 240 multiply)
//   partial_velocity_rates  567 (219 add, 348 multiply)
#pragma once

namespace kanec::bench_cb6 {

inline constexpr int n_bodies = 6;
inline constexpr int nx = 24;
inline constexpr int ny = 18;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 18;
inline constexpr char model_hash[] = "5d87b4d0845fb4cb";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, eps_2_1 = 4, eps_2_2 = 5, eps_2_3 = 6,
    eps_2_4 = 7, eps_3_1 = 8, eps_3_2 = 9, eps_3_3 = 10, eps_3_4 = 11, eps_4_1 = 12, eps_4_2 = 13, eps_4_3 = 14,
    eps_4_4 = 15, eps_5_1 = 16, eps_5_2 = 17, eps_5_3 = 18, eps_5_4 = 19, eps_6_1 = 20, eps_6_2 = 21, eps_6_3 = 22,
    eps_6_4 = 23;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, omega_2_1 = 3, omega_2_2 = 4, omega_2_3 = 5,
    omega_3_1 = 6, omega_3_2 = 7, omega_3_3 = 8, omega_4_1 = 9, omega_4_2 = 10, omega_4_3 = 11, omega_5_1 = 12,
    omega_5_2 = 13, omega_5_3 = 14, omega_6_1 = 15, omega_6_2 = 16, omega_6_3 = 17;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 324;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5,
    5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7,
    7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9,
    9, 9, 9, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 11, 11, 11, 11, 11, 11, 11, 11,
    11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12,
    13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14,
    14, 14, 14, 14, 14, 14, 14, 14, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 16, 16,
    16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17,
    17, 17, 17, 17, 17, 17};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2,
    3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17,
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14,
    15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11,
    12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8,
    9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5,
    6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2,
    3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17,
    0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14,
    15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11,
    12, 13, 14, 15, 16, 17};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
  T tau_1_1 = T(0);
  T tau_1_2 = T(0);
  T tau_1_3 = T(0);
  T tau_2_1 = T(0);
  T tau_2_2 = T(0);
  T tau_2_3 = T(0);
  T tau_3_1 = T(0);
  T tau_3_2 = T(0);
  T tau_3_3 = T(0);
  T tau_4_1 = T(0);
  T tau_4_2 = T(0);
  T tau_4_3 = T(0);
  T tau_5_1 = T(0);
  T tau_5_2 = T(0);
  T tau_5_3 = T(0);
  T tau_6_1 = T(0);
  T tau_6_2 = T(0);
  T tau_6_3 = T(0);
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
// 48 add, 90 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* xdot) noexcept {

  // ---- body 1 (body_1) on the inertial frame
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

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // w2 = 1/2 omega2: half the angular velocity [rad/s]
  const T w2_1 = T(0.5) * omega2_1;
  const T w2_2 = T(0.5) * omega2_2;
  const T w2_3 = T(0.5) * omega2_3;
  // edot2 = e2~ w2 + eps4_2 w2: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot2_1 = eps2_2 * w2_3 - eps2_3 * w2_2 + eps2_4 * w2_1;
  const T edot2_2 = eps2_3 * w2_1 - eps2_1 * w2_3 + eps2_4 * w2_2;
  const T edot2_3 = eps2_1 * w2_2 - eps2_2 * w2_1 + eps2_4 * w2_3;
  xdot[4] = edot2_1;
  xdot[5] = edot2_2;
  xdot[6] = edot2_3;
  // eps4dot2 = -e2 . w2: rate of eps_4 [1/s]
  const T minus_eps4dot2 = eps2_1 * w2_1 + eps2_2 * w2_2 + eps2_3 * w2_3;
  xdot[7] = -minus_eps4dot2;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  // w3 = 1/2 omega3: half the angular velocity [rad/s]
  const T w3_1 = T(0.5) * omega3_1;
  const T w3_2 = T(0.5) * omega3_2;
  const T w3_3 = T(0.5) * omega3_3;
  // edot3 = e3~ w3 + eps4_3 w3: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot3_1 = eps3_2 * w3_3 - eps3_3 * w3_2 + eps3_4 * w3_1;
  const T edot3_2 = eps3_3 * w3_1 - eps3_1 * w3_3 + eps3_4 * w3_2;
  const T edot3_3 = eps3_1 * w3_2 - eps3_2 * w3_1 + eps3_4 * w3_3;
  xdot[8] = edot3_1;
  xdot[9] = edot3_2;
  xdot[10] = edot3_3;
  // eps4dot3 = -e3 . w3: rate of eps_4 [1/s]
  const T minus_eps4dot3 = eps3_1 * w3_1 + eps3_2 * w3_2 + eps3_3 * w3_3;
  xdot[11] = -minus_eps4dot3;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  // w4 = 1/2 omega4: half the angular velocity [rad/s]
  const T w4_1 = T(0.5) * omega4_1;
  const T w4_2 = T(0.5) * omega4_2;
  const T w4_3 = T(0.5) * omega4_3;
  // edot4 = e4~ w4 + eps4_4 w4: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot4_1 = eps4_2 * w4_3 - eps4_3 * w4_2 + eps4_4 * w4_1;
  const T edot4_2 = eps4_3 * w4_1 - eps4_1 * w4_3 + eps4_4 * w4_2;
  const T edot4_3 = eps4_1 * w4_2 - eps4_2 * w4_1 + eps4_4 * w4_3;
  xdot[12] = edot4_1;
  xdot[13] = edot4_2;
  xdot[14] = edot4_3;
  // eps4dot4 = -e4 . w4: rate of eps_4 [1/s]
  const T minus_eps4dot4 = eps4_1 * w4_1 + eps4_2 * w4_2 + eps4_3 * w4_3;
  xdot[15] = -minus_eps4dot4;

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  // w5 = 1/2 omega5: half the angular velocity [rad/s]
  const T w5_1 = T(0.5) * omega5_1;
  const T w5_2 = T(0.5) * omega5_2;
  const T w5_3 = T(0.5) * omega5_3;
  // edot5 = e5~ w5 + eps4_5 w5: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot5_1 = eps5_2 * w5_3 - eps5_3 * w5_2 + eps5_4 * w5_1;
  const T edot5_2 = eps5_3 * w5_1 - eps5_1 * w5_3 + eps5_4 * w5_2;
  const T edot5_3 = eps5_1 * w5_2 - eps5_2 * w5_1 + eps5_4 * w5_3;
  xdot[16] = edot5_1;
  xdot[17] = edot5_2;
  xdot[18] = edot5_3;
  // eps4dot5 = -e5 . w5: rate of eps_4 [1/s]
  const T minus_eps4dot5 = eps5_1 * w5_1 + eps5_2 * w5_2 + eps5_3 * w5_3;
  xdot[19] = -minus_eps4dot5;

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  // w6 = 1/2 omega6: half the angular velocity [rad/s]
  const T w6_1 = T(0.5) * omega6_1;
  const T w6_2 = T(0.5) * omega6_2;
  const T w6_3 = T(0.5) * omega6_3;
  // edot6 = e6~ w6 + eps4_6 w6: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot6_1 = eps6_2 * w6_3 - eps6_3 * w6_2 + eps6_4 * w6_1;
  const T edot6_2 = eps6_3 * w6_1 - eps6_1 * w6_3 + eps6_4 * w6_2;
  const T edot6_3 = eps6_1 * w6_2 - eps6_2 * w6_1 + eps6_4 * w6_3;
  xdot[20] = edot6_1;
  xdot[21] = edot6_2;
  xdot[22] = edot6_3;
  // eps4dot6 = -e6 . w6: rate of eps_4 [1/s]
  const T minus_eps4dot6 = eps6_1 * w6_1 + eps6_2 * w6_2 + eps6_3 * w6_3;
  xdot[23] = -minus_eps4dot6;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 156 add, 168 multiply
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {

  // ---- body 1 (body_1) on the inertial frame
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
  const T p1_1 = R1_11 * T(0.1) + R1_21 * T(0.2) + R1_31 * T(0.05);
  const T p1_2 = R1_12 * T(0.1) + R1_22 * T(0.2) + R1_32 * T(0.05);
  const T p1_3 = R1_13 * T(0.1) + R1_23 * T(0.2) + R1_33 * T(0.05);
  pose[9] = p1_1;
  pose[10] = p1_2;
  pose[11] = p1_3;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  pose[12] = R2_11;
  pose[13] = R2_12;
  pose[14] = R2_13;
  pose[15] = R2_21;
  pose[16] = R2_22;
  pose[17] = R2_23;
  pose[18] = R2_31;
  pose[19] = R2_32;
  pose[20] = R2_33;
  // P2 = R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = R1_11 * T(0.3) + R1_21 * T(0.1) + R1_31 * T(0.1);
  const T P2_2 = R1_12 * T(0.3) + R1_22 * T(0.1) + R1_32 * T(0.1);
  const T P2_3 = R1_13 * T(0.3) + R1_23 * T(0.1) + R1_33 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = P2_1 + R2_11 * T(0.1) + R2_21 * T(0.2) + R2_31 * T(0.05);
  const T p2_2 = P2_2 + R2_12 * T(0.1) + R2_22 * T(0.2) + R2_32 * T(0.05);
  const T p2_3 = P2_3 + R2_13 * T(0.1) + R2_23 * T(0.2) + R2_33 * T(0.05);
  pose[21] = p2_1;
  pose[22] = p2_2;
  pose[23] = p2_3;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  // R3^T = 1 + 2 e3~ (eps4_3 + e3~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t3_1 = T(2) * eps3_2;
  const T t3_2 = t3_1 * eps3_2;
  const T t3_3 = T(2) * eps3_3;
  const T t3_4 = t3_3 * eps3_3;
  const T R3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * eps3_1;
  const T t3_6 = t3_5 * eps3_2;
  const T t3_7 = t3_3 * eps3_4;
  const T R3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * eps3_3;
  const T t3_9 = t3_1 * eps3_4;
  const T R3_13 = t3_8 - t3_9;
  const T R3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * eps3_1;
  const T R3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * eps3_3;
  const T t3_12 = t3_5 * eps3_4;
  const T R3_23 = t3_11 + t3_12;
  const T R3_31 = t3_8 + t3_9;
  const T R3_32 = t3_11 - t3_12;
  const T R3_33 = t3_10 - t3_2;
  pose[24] = R3_11;
  pose[25] = R3_12;
  pose[26] = R3_13;
  pose[27] = R3_21;
  pose[28] = R3_22;
  pose[29] = R3_23;
  pose[30] = R3_31;
  pose[31] = R3_32;
  pose[32] = R3_33;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 + R2_11 * T(0.3) + R2_21 * T(0.15) + R2_31 * T(0.1);
  const T P3_2 = P2_2 + R2_12 * T(0.3) + R2_22 * T(0.15) + R2_32 * T(0.1);
  const T P3_3 = P2_3 + R2_13 * T(0.3) + R2_23 * T(0.15) + R2_33 * T(0.1);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T t3_13 = P3_1 + R3_21 * T(0.2);
  const T p3_1 = R3_11 * T(0.1) + t3_13 + R3_31 * T(0.05);
  const T t3_14 = P3_2 + R3_22 * T(0.2);
  const T p3_2 = R3_12 * T(0.1) + t3_14 + R3_32 * T(0.05);
  const T t3_15 = P3_3 + R3_23 * T(0.2);
  const T p3_3 = R3_13 * T(0.1) + t3_15 + R3_33 * T(0.05);
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  // R4^T = 1 + 2 e4~ (eps4_4 + e4~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t4_1 = T(2) * eps4_2;
  const T t4_2 = t4_1 * eps4_2;
  const T t4_3 = T(2) * eps4_3;
  const T t4_4 = t4_3 * eps4_3;
  const T R4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * eps4_1;
  const T t4_6 = t4_5 * eps4_2;
  const T t4_7 = t4_3 * eps4_4;
  const T R4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * eps4_3;
  const T t4_9 = t4_1 * eps4_4;
  const T R4_13 = t4_8 - t4_9;
  const T R4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * eps4_1;
  const T R4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * eps4_3;
  const T t4_12 = t4_5 * eps4_4;
  const T R4_23 = t4_11 + t4_12;
  const T R4_31 = t4_8 + t4_9;
  const T R4_32 = t4_11 - t4_12;
  const T R4_33 = t4_10 - t4_2;
  pose[36] = R4_11;
  pose[37] = R4_12;
  pose[38] = R4_13;
  pose[39] = R4_21;
  pose[40] = R4_22;
  pose[41] = R4_23;
  pose[42] = R4_31;
  pose[43] = R4_32;
  pose[44] = R4_33;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = R3_11 * T(0.3) + t3_13 + R3_31 * T(0.1);
  const T P4_2 = R3_12 * T(0.3) + t3_14 + R3_32 * T(0.1);
  const T P4_3 = R3_13 * T(0.3) + t3_15 + R3_33 * T(0.1);
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 + R4_11 * T(0.1) + R4_21 * T(0.2) + R4_31 * T(0.05);
  const T p4_2 = P4_2 + R4_12 * T(0.1) + R4_22 * T(0.2) + R4_32 * T(0.05);
  const T p4_3 = P4_3 + R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05);
  pose[45] = p4_1;
  pose[46] = p4_2;
  pose[47] = p4_3;

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  // R5^T = 1 + 2 e5~ (eps4_5 + e5~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t5_1 = T(2) * eps5_2;
  const T t5_2 = t5_1 * eps5_2;
  const T t5_3 = T(2) * eps5_3;
  const T t5_4 = t5_3 * eps5_3;
  const T R5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * eps5_1;
  const T t5_6 = t5_5 * eps5_2;
  const T t5_7 = t5_3 * eps5_4;
  const T R5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * eps5_3;
  const T t5_9 = t5_1 * eps5_4;
  const T R5_13 = t5_8 - t5_9;
  const T R5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * eps5_1;
  const T R5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * eps5_3;
  const T t5_12 = t5_5 * eps5_4;
  const T R5_23 = t5_11 + t5_12;
  const T R5_31 = t5_8 + t5_9;
  const T R5_32 = t5_11 - t5_12;
  const T R5_33 = t5_10 - t5_2;
  pose[48] = R5_11;
  pose[49] = R5_12;
  pose[50] = R5_13;
  pose[51] = R5_21;
  pose[52] = R5_22;
  pose[53] = R5_23;
  pose[54] = R5_31;
  pose[55] = R5_32;
  pose[56] = R5_33;
  // P5 = R4^T q5 + P4: position of the body origin, inertial axes [m]
  const T P5_1 = P4_1 + R4_11 * T(0.3) + R4_21 * T(0.25) + R4_31 * T(0.1);
  const T P5_2 = P4_2 + R4_12 * T(0.3) + R4_22 * T(0.25) + R4_32 * T(0.1);
  const T P5_3 = P4_3 + R4_13 * T(0.3) + R4_23 * T(0.25) + R4_33 * T(0.1);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_1 = P5_1 + R5_11 * T(0.1) + R5_21 * T(0.2) + R5_31 * T(0.05);
  const T p5_2 = P5_2 + R5_12 * T(0.1) + R5_22 * T(0.2) + R5_32 * T(0.05);
  const T p5_3 = P5_3 + R5_13 * T(0.1) + R5_23 * T(0.2) + R5_33 * T(0.05);
  pose[57] = p5_1;
  pose[58] = p5_2;
  pose[59] = p5_3;

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  // R6^T = 1 + 2 e6~ (eps4_6 + e6~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t6_1 = T(2) * eps6_2;
  const T t6_2 = t6_1 * eps6_2;
  const T t6_3 = T(2) * eps6_3;
  const T t6_4 = t6_3 * eps6_3;
  const T R6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * eps6_1;
  const T t6_6 = t6_5 * eps6_2;
  const T t6_7 = t6_3 * eps6_4;
  const T R6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * eps6_3;
  const T t6_9 = t6_1 * eps6_4;
  const T R6_13 = t6_8 - t6_9;
  const T R6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * eps6_1;
  const T R6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * eps6_3;
  const T t6_12 = t6_5 * eps6_4;
  const T R6_23 = t6_11 + t6_12;
  const T R6_31 = t6_8 + t6_9;
  const T R6_32 = t6_11 - t6_12;
  const T R6_33 = t6_10 - t6_2;
  pose[60] = R6_11;
  pose[61] = R6_12;
  pose[62] = R6_13;
  pose[63] = R6_21;
  pose[64] = R6_22;
  pose[65] = R6_23;
  pose[66] = R6_31;
  pose[67] = R6_32;
  pose[68] = R6_33;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T P6_1 = P5_1 + R5_11 * T(0.3) + R5_21 * T(0.3) + R5_31 * T(0.1);
  const T P6_2 = P5_2 + R5_12 * T(0.3) + R5_22 * T(0.3) + R5_32 * T(0.1);
  const T P6_3 = P5_3 + R5_13 * T(0.3) + R5_23 * T(0.3) + R5_33 * T(0.1);
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = P6_1 + R6_11 * T(0.1) + R6_21 * T(0.2) + R6_31 * T(0.05);
  const T p6_2 = P6_2 + R6_12 * T(0.1) + R6_22 * T(0.2) + R6_32 * T(0.05);
  const T p6_3 = P6_3 + R6_13 * T(0.1) + R6_23 * T(0.2) + R6_33 * T(0.05);
  pose[69] = p6_1;
  pose[70] = p6_2;
  pose[71] = p6_3;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 298 add, 368 multiply
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {

  // ---- body 1 (body_1) on the inertial frame
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
  const T p1_3 = R1_13 * T(0.1) + R1_23 * T(0.2) + R1_33 * T(0.05);
  // v1 = R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T t1_14 = omega1_3 * T(0.1);
  const T t1_15 = t1_14 - omega1_1 * T(0.05);
  const T t1_16 = omega1_2 * T(0.1);
  const T t1_17 = omega1_1 * T(0.2) - t1_16;
  const T v1_1 = R1_11 * t1_13 + R1_21 * t1_15 + R1_31 * t1_17;
  const T v1_2 = R1_12 * t1_13 + R1_22 * t1_15 + R1_32 * t1_17;
  const T v1_3 = R1_13 * t1_13 + R1_23 * t1_15 + R1_33 * t1_17;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.5) * (omega1_1 * (T(0.11) * omega1_1 + T(0.0055) * omega1_2 + T(0.0033) * omega1_3) + omega1_2 *
      (T(0.0055) * omega1_1 + T(0.132) * omega1_2 - T(0.0044) * omega1_3) + omega1_3 * (T(0.0033) * omega1_1 -
      T(0.0044) * omega1_2 + T(0.088) * omega1_3)) + T(0.55) * (v1_1 * v1_1 + v1_2 * v1_2 + v1_3 * v1_3);

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P2 = R1^T q2: position of the body origin, inertial axes [m]
  const T P2_3 = R1_13 * T(0.3) + R1_23 * T(0.1) + R1_33 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_3 = P2_3 + R2_13 * T(0.1) + R2_23 * T(0.2) + R2_33 * T(0.05);
  // Pdot2 = R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_13 = t1_16 - t1_14;
  const T t2_14 = omega1_1 * T(0.1);
  const T t2_15 = omega1_3 * T(0.3) - t2_14;
  const T t2_16 = t2_14 - omega1_2 * T(0.3);
  const T Pdot2_1 = R1_11 * t2_13 + R1_21 * t2_15 + R1_31 * t2_16;
  const T Pdot2_2 = R1_12 * t2_13 + R1_22 * t2_15 + R1_32 * t2_16;
  const T Pdot2_3 = R1_13 * t2_13 + R1_23 * t2_15 + R1_33 * t2_16;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_17 = omega2_2 * T(0.05) - omega2_3 * T(0.2);
  const T t2_18 = omega2_3 * T(0.1) - omega2_1 * T(0.05);
  const T t2_19 = omega2_2 * T(0.1);
  const T t2_20 = omega2_1 * T(0.2) - t2_19;
  const T v2_1 = Pdot2_1 + R2_11 * t2_17 + R2_21 * t2_18 + R2_31 * t2_20;
  const T v2_2 = Pdot2_2 + R2_12 * t2_17 + R2_22 * t2_18 + R2_32 * t2_20;
  const T v2_3 = Pdot2_3 + R2_13 * t2_17 + R2_23 * t2_18 + R2_33 * t2_20;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (omega2_1 * (T(0.12) * omega2_1 + T(0.006) * omega2_2 + T(0.0036) * omega2_3) + omega2_2 *
      (T(0.006) * omega2_1 + T(0.144) * omega2_2 - T(0.0048) * omega2_3) + omega2_3 * (T(0.0036) * omega2_1 -
      T(0.0048) * omega2_2 + T(0.096) * omega2_3)) + T(0.6) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  // R3^T = 1 + 2 e3~ (eps4_3 + e3~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t3_1 = T(2) * eps3_2;
  const T t3_2 = t3_1 * eps3_2;
  const T t3_3 = T(2) * eps3_3;
  const T t3_4 = t3_3 * eps3_3;
  const T R3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * eps3_1;
  const T t3_6 = t3_5 * eps3_2;
  const T t3_7 = t3_3 * eps3_4;
  const T R3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * eps3_3;
  const T t3_9 = t3_1 * eps3_4;
  const T R3_13 = t3_8 - t3_9;
  const T R3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * eps3_1;
  const T R3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * eps3_3;
  const T t3_12 = t3_5 * eps3_4;
  const T R3_23 = t3_11 + t3_12;
  const T R3_31 = t3_8 + t3_9;
  const T R3_32 = t3_11 - t3_12;
  const T R3_33 = t3_10 - t3_2;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_3 = P2_3 + R2_13 * T(0.3) + R2_23 * T(0.15) + R2_33 * T(0.1);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T t3_13 = P3_3 + R3_23 * T(0.2);
  const T p3_3 = R3_13 * T(0.1) + t3_13 + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_14 = t2_19 - omega2_3 * T(0.15);
  const T t3_15 = omega2_3 * T(0.3) - omega2_1 * T(0.1);
  const T t3_16 = omega2_1 * T(0.15) - omega2_2 * T(0.3);
  const T Pdot3_1 = Pdot2_1 + R2_11 * t3_14 + R2_21 * t3_15 + R2_31 * t3_16;
  const T Pdot3_2 = Pdot2_2 + R2_12 * t3_14 + R2_22 * t3_15 + R2_32 * t3_16;
  const T Pdot3_3 = Pdot2_3 + R2_13 * t3_14 + R2_23 * t3_15 + R2_33 * t3_16;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_17 = omega3_3 * T(0.2);
  const T t3_18 = omega3_2 * T(0.05) - t3_17;
  const T t3_19 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_20 = omega3_1 * T(0.2);
  const T t3_21 = omega3_2 * T(0.1);
  const T t3_22 = t3_20 - t3_21;
  const T v3_1 = Pdot3_1 + R3_11 * t3_18 + R3_21 * t3_19 + R3_31 * t3_22;
  const T v3_2 = Pdot3_2 + R3_12 * t3_18 + R3_22 * t3_19 + R3_32 * t3_22;
  const T v3_3 = Pdot3_3 + R3_13 * t3_18 + R3_23 * t3_19 + R3_33 * t3_22;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (omega3_1 * (T(0.13) * omega3_1 + T(0.0065) * omega3_2 + T(0.0039) * omega3_3) + omega3_2 *
      (T(0.0065) * omega3_1 + T(0.156) * omega3_2 - T(0.0052) * omega3_3) + omega3_3 * (T(0.0039) * omega3_1 -
      T(0.0052) * omega3_2 + T(0.104) * omega3_3)) + T(0.65) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  // R4^T = 1 + 2 e4~ (eps4_4 + e4~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t4_1 = T(2) * eps4_2;
  const T t4_2 = t4_1 * eps4_2;
  const T t4_3 = T(2) * eps4_3;
  const T t4_4 = t4_3 * eps4_3;
  const T R4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * eps4_1;
  const T t4_6 = t4_5 * eps4_2;
  const T t4_7 = t4_3 * eps4_4;
  const T R4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * eps4_3;
  const T t4_9 = t4_1 * eps4_4;
  const T R4_13 = t4_8 - t4_9;
  const T R4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * eps4_1;
  const T R4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * eps4_3;
  const T t4_12 = t4_5 * eps4_4;
  const T R4_23 = t4_11 + t4_12;
  const T R4_31 = t4_8 + t4_9;
  const T R4_32 = t4_11 - t4_12;
  const T R4_33 = t4_10 - t4_2;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_3 = R3_13 * T(0.3) + t3_13 + R3_33 * T(0.1);
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_3 = P4_3 + R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = t3_21 - t3_17;
  const T t4_14 = omega3_3 * T(0.3) - omega3_1 * T(0.1);
  const T t4_15 = t3_20 - omega3_2 * T(0.3);
  const T Pdot4_1 = Pdot3_1 + R3_11 * t4_13 + R3_21 * t4_14 + R3_31 * t4_15;
  const T Pdot4_2 = Pdot3_2 + R3_12 * t4_13 + R3_22 * t4_14 + R3_32 * t4_15;
  const T Pdot4_3 = Pdot3_3 + R3_13 * t4_13 + R3_23 * t4_14 + R3_33 * t4_15;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_16 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_17 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_18 = omega4_2 * T(0.1);
  const T t4_19 = omega4_1 * T(0.2) - t4_18;
  const T v4_1 = Pdot4_1 + R4_11 * t4_16 + R4_21 * t4_17 + R4_31 * t4_19;
  const T v4_2 = Pdot4_2 + R4_12 * t4_16 + R4_22 * t4_17 + R4_32 * t4_19;
  const T v4_3 = Pdot4_3 + R4_13 * t4_16 + R4_23 * t4_17 + R4_33 * t4_19;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (omega4_1 * (T(0.14) * omega4_1 + T(0.007) * omega4_2 + T(0.0042) * omega4_3) + omega4_2 *
      (T(0.007) * omega4_1 + T(0.168) * omega4_2 - T(0.0056) * omega4_3) + omega4_3 * (T(0.0042) * omega4_1 -
      T(0.0056) * omega4_2 + T(0.112) * omega4_3)) + T(0.7) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  // R5^T = 1 + 2 e5~ (eps4_5 + e5~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t5_1 = T(2) * eps5_2;
  const T t5_2 = t5_1 * eps5_2;
  const T t5_3 = T(2) * eps5_3;
  const T t5_4 = t5_3 * eps5_3;
  const T R5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * eps5_1;
  const T t5_6 = t5_5 * eps5_2;
  const T t5_7 = t5_3 * eps5_4;
  const T R5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * eps5_3;
  const T t5_9 = t5_1 * eps5_4;
  const T R5_13 = t5_8 - t5_9;
  const T R5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * eps5_1;
  const T R5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * eps5_3;
  const T t5_12 = t5_5 * eps5_4;
  const T R5_23 = t5_11 + t5_12;
  const T R5_31 = t5_8 + t5_9;
  const T R5_32 = t5_11 - t5_12;
  const T R5_33 = t5_10 - t5_2;
  // P5 = R4^T q5 + P4: position of the body origin, inertial axes [m]
  const T P5_3 = P4_3 + R4_13 * T(0.3) + R4_23 * T(0.25) + R4_33 * T(0.1);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_3 = P5_3 + R5_13 * T(0.1) + R5_23 * T(0.2) + R5_33 * T(0.05);
  // Pdot5 = R4^T omega4~ q5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t5_13 = t4_18 - omega4_3 * T(0.25);
  const T t5_14 = omega4_3 * T(0.3) - omega4_1 * T(0.1);
  const T t5_15 = omega4_1 * T(0.25) - omega4_2 * T(0.3);
  const T Pdot5_1 = Pdot4_1 + R4_11 * t5_13 + R4_21 * t5_14 + R4_31 * t5_15;
  const T Pdot5_2 = Pdot4_2 + R4_12 * t5_13 + R4_22 * t5_14 + R4_32 * t5_15;
  const T Pdot5_3 = Pdot4_3 + R4_13 * t5_13 + R4_23 * t5_14 + R4_33 * t5_15;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_16 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_17 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_18 = omega5_2 * T(0.1);
  const T t5_19 = omega5_1 * T(0.2) - t5_18;
  const T v5_1 = Pdot5_1 + R5_11 * t5_16 + R5_21 * t5_17 + R5_31 * t5_19;
  const T v5_2 = Pdot5_2 + R5_12 * t5_16 + R5_22 * t5_17 + R5_32 * t5_19;
  const T v5_3 = Pdot5_3 + R5_13 * t5_16 + R5_23 * t5_17 + R5_33 * t5_19;
  // T5 = 1/2 omega5 . (I5 omega5) + 1/2 m5 v5 . v5: kinetic energy [J]
  const T T5 = T(0.5) * (omega5_1 * (T(0.15) * omega5_1 + T(0.0075) * omega5_2 + T(0.0045) * omega5_3) + omega5_2 *
      (T(0.0075) * omega5_1 + T(0.18) * omega5_2 - T(0.006) * omega5_3) + omega5_3 * (T(0.0045) * omega5_1 - T(0.006)
      * omega5_2 + T(0.12) * omega5_3)) + T(0.75) * (v5_1 * v5_1 + v5_2 * v5_2 + v5_3 * v5_3);

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  // R6^T = 1 + 2 e6~ (eps4_6 + e6~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t6_1 = T(2) * eps6_2;
  const T t6_2 = t6_1 * eps6_2;
  const T t6_3 = T(2) * eps6_3;
  const T t6_4 = t6_3 * eps6_3;
  const T R6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * eps6_1;
  const T t6_6 = t6_5 * eps6_2;
  const T t6_7 = t6_3 * eps6_4;
  const T R6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * eps6_3;
  const T t6_9 = t6_1 * eps6_4;
  const T R6_13 = t6_8 - t6_9;
  const T R6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * eps6_1;
  const T R6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * eps6_3;
  const T t6_12 = t6_5 * eps6_4;
  const T R6_23 = t6_11 + t6_12;
  const T R6_31 = t6_8 + t6_9;
  const T R6_32 = t6_11 - t6_12;
  const T R6_33 = t6_10 - t6_2;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T P6_3 = P5_3 + R5_13 * T(0.3) + R5_23 * T(0.3) + R5_33 * T(0.1);
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_3 = P6_3 + R6_13 * T(0.1) + R6_23 * T(0.2) + R6_33 * T(0.05);
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = omega5_3 * T(0.3);
  const T t6_14 = t5_18 - t6_13;
  const T t6_15 = t6_13 - omega5_1 * T(0.1);
  const T t6_16 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_14 + R5_21 * t6_15 + R5_31 * t6_16;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_14 + R5_22 * t6_15 + R5_32 * t6_16;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_14 + R5_23 * t6_15 + R5_33 * t6_16;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_17 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_18 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_19 = omega6_1 * T(0.2) - omega6_2 * T(0.1);
  const T v6_1 = Pdot6_1 + R6_11 * t6_17 + R6_21 * t6_18 + R6_31 * t6_19;
  const T v6_2 = Pdot6_2 + R6_12 * t6_17 + R6_22 * t6_18 + R6_32 * t6_19;
  const T v6_3 = Pdot6_3 + R6_13 * t6_17 + R6_23 * t6_18 + R6_33 * t6_19;
  // T6 = 1/2 omega6 . (I6 omega6) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (omega6_1 * (T(0.16) * omega6_1 + T(0.008) * omega6_2 + T(0.0048) * omega6_3) + omega6_2 *
      (T(0.008) * omega6_1 + T(0.192) * omega6_2 - T(0.0064) * omega6_3) + omega6_3 * (T(0.0048) * omega6_1 -
      T(0.0064) * omega6_2 + T(0.128) * omega6_3)) + T(0.8) * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6: first moment of mass, inertial axes [kg m]
  const T mp_3 = T(1.1) * p1_3 + T(1.2) * p2_3 + T(1.3) * p3_3 + T(1.4) * p4_3 + T(1.5) * p5_3 + T(1.6) * p6_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 420 add, 485 multiply
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {

  // ---- body 1 (body_1) on the inertial frame
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
  const T p1_1 = R1_11 * T(0.1) + R1_21 * T(0.2) + R1_31 * T(0.05);
  const T p1_2 = R1_12 * T(0.1) + R1_22 * T(0.2) + R1_32 * T(0.05);
  const T p1_3 = R1_13 * T(0.1) + R1_23 * T(0.2) + R1_33 * T(0.05);
  // v1 = R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T t1_14 = omega1_3 * T(0.1);
  const T t1_15 = t1_14 - omega1_1 * T(0.05);
  const T t1_16 = omega1_2 * T(0.1);
  const T t1_17 = omega1_1 * T(0.2) - t1_16;
  const T v1_1 = R1_11 * t1_13 + R1_21 * t1_15 + R1_31 * t1_17;
  const T v1_2 = R1_12 * t1_13 + R1_22 * t1_15 + R1_32 * t1_17;
  const T v1_3 = R1_13 * t1_13 + R1_23 * t1_15 + R1_33 * t1_17;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(1.1) * v1_1;
  const T l1_2 = T(1.1) * v1_2;
  const T l1_3 = T(1.1) * v1_3;
  // H1 = R1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_18 = T(0.11) * omega1_1 + T(0.0055) * omega1_2 + T(0.0033) * omega1_3;
  const T t1_19 = T(0.0055) * omega1_1 + T(0.132) * omega1_2 - T(0.0044) * omega1_3;
  const T t1_20 = T(0.0033) * omega1_1 - T(0.0044) * omega1_2 + T(0.088) * omega1_3;
  const T H1_1 = R1_11 * t1_18 + R1_21 * t1_19 + R1_31 * t1_20 + p1_2 * l1_3 - p1_3 * l1_2;
  const T H1_2 = R1_12 * t1_18 + R1_22 * t1_19 + R1_32 * t1_20 + p1_3 * l1_1 - p1_1 * l1_3;
  const T H1_3 = R1_13 * t1_18 + R1_23 * t1_19 + R1_33 * t1_20 + p1_1 * l1_2 - p1_2 * l1_1;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P2 = R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = R1_11 * T(0.3) + R1_21 * T(0.1) + R1_31 * T(0.1);
  const T P2_2 = R1_12 * T(0.3) + R1_22 * T(0.1) + R1_32 * T(0.1);
  const T P2_3 = R1_13 * T(0.3) + R1_23 * T(0.1) + R1_33 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = P2_1 + R2_11 * T(0.1) + R2_21 * T(0.2) + R2_31 * T(0.05);
  const T p2_2 = P2_2 + R2_12 * T(0.1) + R2_22 * T(0.2) + R2_32 * T(0.05);
  const T p2_3 = P2_3 + R2_13 * T(0.1) + R2_23 * T(0.2) + R2_33 * T(0.05);
  // Pdot2 = R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_13 = t1_16 - t1_14;
  const T t2_14 = omega1_1 * T(0.1);
  const T t2_15 = omega1_3 * T(0.3) - t2_14;
  const T t2_16 = t2_14 - omega1_2 * T(0.3);
  const T Pdot2_1 = R1_11 * t2_13 + R1_21 * t2_15 + R1_31 * t2_16;
  const T Pdot2_2 = R1_12 * t2_13 + R1_22 * t2_15 + R1_32 * t2_16;
  const T Pdot2_3 = R1_13 * t2_13 + R1_23 * t2_15 + R1_33 * t2_16;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_17 = omega2_2 * T(0.05) - omega2_3 * T(0.2);
  const T t2_18 = omega2_3 * T(0.1) - omega2_1 * T(0.05);
  const T t2_19 = omega2_2 * T(0.1);
  const T t2_20 = omega2_1 * T(0.2) - t2_19;
  const T v2_1 = Pdot2_1 + R2_11 * t2_17 + R2_21 * t2_18 + R2_31 * t2_20;
  const T v2_2 = Pdot2_2 + R2_12 * t2_17 + R2_22 * t2_18 + R2_32 * t2_20;
  const T v2_3 = Pdot2_3 + R2_13 * t2_17 + R2_23 * t2_18 + R2_33 * t2_20;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(1.2) * v2_1;
  const T l2_2 = T(1.2) * v2_2;
  const T l2_3 = T(1.2) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_21 = T(0.12) * omega2_1 + T(0.006) * omega2_2 + T(0.0036) * omega2_3;
  const T t2_22 = T(0.006) * omega2_1 + T(0.144) * omega2_2 - T(0.0048) * omega2_3;
  const T t2_23 = T(0.0036) * omega2_1 - T(0.0048) * omega2_2 + T(0.096) * omega2_3;
  const T H2_1 = R2_11 * t2_21 + R2_21 * t2_22 + R2_31 * t2_23 + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = R2_12 * t2_21 + R2_22 * t2_22 + R2_32 * t2_23 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = R2_13 * t2_21 + R2_23 * t2_22 + R2_33 * t2_23 + p2_1 * l2_2 - p2_2 * l2_1;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  // R3^T = 1 + 2 e3~ (eps4_3 + e3~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t3_1 = T(2) * eps3_2;
  const T t3_2 = t3_1 * eps3_2;
  const T t3_3 = T(2) * eps3_3;
  const T t3_4 = t3_3 * eps3_3;
  const T R3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * eps3_1;
  const T t3_6 = t3_5 * eps3_2;
  const T t3_7 = t3_3 * eps3_4;
  const T R3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * eps3_3;
  const T t3_9 = t3_1 * eps3_4;
  const T R3_13 = t3_8 - t3_9;
  const T R3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * eps3_1;
  const T R3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * eps3_3;
  const T t3_12 = t3_5 * eps3_4;
  const T R3_23 = t3_11 + t3_12;
  const T R3_31 = t3_8 + t3_9;
  const T R3_32 = t3_11 - t3_12;
  const T R3_33 = t3_10 - t3_2;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 + R2_11 * T(0.3) + R2_21 * T(0.15) + R2_31 * T(0.1);
  const T P3_2 = P2_2 + R2_12 * T(0.3) + R2_22 * T(0.15) + R2_32 * T(0.1);
  const T P3_3 = P2_3 + R2_13 * T(0.3) + R2_23 * T(0.15) + R2_33 * T(0.1);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T t3_13 = P3_1 + R3_21 * T(0.2);
  const T p3_1 = R3_11 * T(0.1) + t3_13 + R3_31 * T(0.05);
  const T t3_14 = P3_2 + R3_22 * T(0.2);
  const T p3_2 = R3_12 * T(0.1) + t3_14 + R3_32 * T(0.05);
  const T t3_15 = P3_3 + R3_23 * T(0.2);
  const T p3_3 = R3_13 * T(0.1) + t3_15 + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_16 = t2_19 - omega2_3 * T(0.15);
  const T t3_17 = omega2_3 * T(0.3) - omega2_1 * T(0.1);
  const T t3_18 = omega2_1 * T(0.15) - omega2_2 * T(0.3);
  const T Pdot3_1 = Pdot2_1 + R2_11 * t3_16 + R2_21 * t3_17 + R2_31 * t3_18;
  const T Pdot3_2 = Pdot2_2 + R2_12 * t3_16 + R2_22 * t3_17 + R2_32 * t3_18;
  const T Pdot3_3 = Pdot2_3 + R2_13 * t3_16 + R2_23 * t3_17 + R2_33 * t3_18;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_19 = omega3_3 * T(0.2);
  const T t3_20 = omega3_2 * T(0.05) - t3_19;
  const T t3_21 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_22 = omega3_1 * T(0.2);
  const T t3_23 = omega3_2 * T(0.1);
  const T t3_24 = t3_22 - t3_23;
  const T v3_1 = Pdot3_1 + R3_11 * t3_20 + R3_21 * t3_21 + R3_31 * t3_24;
  const T v3_2 = Pdot3_2 + R3_12 * t3_20 + R3_22 * t3_21 + R3_32 * t3_24;
  const T v3_3 = Pdot3_3 + R3_13 * t3_20 + R3_23 * t3_21 + R3_33 * t3_24;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(1.3) * v3_1;
  const T l3_2 = T(1.3) * v3_2;
  const T l3_3 = T(1.3) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_25 = T(0.13) * omega3_1 + T(0.0065) * omega3_2 + T(0.0039) * omega3_3;
  const T t3_26 = T(0.0065) * omega3_1 + T(0.156) * omega3_2 - T(0.0052) * omega3_3;
  const T t3_27 = T(0.0039) * omega3_1 - T(0.0052) * omega3_2 + T(0.104) * omega3_3;
  const T H3_1 = R3_11 * t3_25 + R3_21 * t3_26 + R3_31 * t3_27 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = R3_12 * t3_25 + R3_22 * t3_26 + R3_32 * t3_27 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R3_13 * t3_25 + R3_23 * t3_26 + R3_33 * t3_27 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  // R4^T = 1 + 2 e4~ (eps4_4 + e4~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t4_1 = T(2) * eps4_2;
  const T t4_2 = t4_1 * eps4_2;
  const T t4_3 = T(2) * eps4_3;
  const T t4_4 = t4_3 * eps4_3;
  const T R4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * eps4_1;
  const T t4_6 = t4_5 * eps4_2;
  const T t4_7 = t4_3 * eps4_4;
  const T R4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * eps4_3;
  const T t4_9 = t4_1 * eps4_4;
  const T R4_13 = t4_8 - t4_9;
  const T R4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * eps4_1;
  const T R4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * eps4_3;
  const T t4_12 = t4_5 * eps4_4;
  const T R4_23 = t4_11 + t4_12;
  const T R4_31 = t4_8 + t4_9;
  const T R4_32 = t4_11 - t4_12;
  const T R4_33 = t4_10 - t4_2;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = R3_11 * T(0.3) + t3_13 + R3_31 * T(0.1);
  const T P4_2 = R3_12 * T(0.3) + t3_14 + R3_32 * T(0.1);
  const T P4_3 = R3_13 * T(0.3) + t3_15 + R3_33 * T(0.1);
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 + R4_11 * T(0.1) + R4_21 * T(0.2) + R4_31 * T(0.05);
  const T p4_2 = P4_2 + R4_12 * T(0.1) + R4_22 * T(0.2) + R4_32 * T(0.05);
  const T p4_3 = P4_3 + R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = t3_23 - t3_19;
  const T t4_14 = omega3_3 * T(0.3) - omega3_1 * T(0.1);
  const T t4_15 = t3_22 - omega3_2 * T(0.3);
  const T Pdot4_1 = Pdot3_1 + R3_11 * t4_13 + R3_21 * t4_14 + R3_31 * t4_15;
  const T Pdot4_2 = Pdot3_2 + R3_12 * t4_13 + R3_22 * t4_14 + R3_32 * t4_15;
  const T Pdot4_3 = Pdot3_3 + R3_13 * t4_13 + R3_23 * t4_14 + R3_33 * t4_15;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_16 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_17 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_18 = omega4_2 * T(0.1);
  const T t4_19 = omega4_1 * T(0.2) - t4_18;
  const T v4_1 = Pdot4_1 + R4_11 * t4_16 + R4_21 * t4_17 + R4_31 * t4_19;
  const T v4_2 = Pdot4_2 + R4_12 * t4_16 + R4_22 * t4_17 + R4_32 * t4_19;
  const T v4_3 = Pdot4_3 + R4_13 * t4_16 + R4_23 * t4_17 + R4_33 * t4_19;
  // l4 = m4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(1.4) * v4_1;
  const T l4_2 = T(1.4) * v4_2;
  const T l4_3 = T(1.4) * v4_3;
  // H4 = R4^T I4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_20 = T(0.14) * omega4_1 + T(0.007) * omega4_2 + T(0.0042) * omega4_3;
  const T t4_21 = T(0.007) * omega4_1 + T(0.168) * omega4_2 - T(0.0056) * omega4_3;
  const T t4_22 = T(0.0042) * omega4_1 - T(0.0056) * omega4_2 + T(0.112) * omega4_3;
  const T H4_1 = R4_11 * t4_20 + R4_21 * t4_21 + R4_31 * t4_22 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_20 + R4_22 * t4_21 + R4_32 * t4_22 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R4_13 * t4_20 + R4_23 * t4_21 + R4_33 * t4_22 + p4_1 * l4_2 - p4_2 * l4_1;

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  // R5^T = 1 + 2 e5~ (eps4_5 + e5~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t5_1 = T(2) * eps5_2;
  const T t5_2 = t5_1 * eps5_2;
  const T t5_3 = T(2) * eps5_3;
  const T t5_4 = t5_3 * eps5_3;
  const T R5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * eps5_1;
  const T t5_6 = t5_5 * eps5_2;
  const T t5_7 = t5_3 * eps5_4;
  const T R5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * eps5_3;
  const T t5_9 = t5_1 * eps5_4;
  const T R5_13 = t5_8 - t5_9;
  const T R5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * eps5_1;
  const T R5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * eps5_3;
  const T t5_12 = t5_5 * eps5_4;
  const T R5_23 = t5_11 + t5_12;
  const T R5_31 = t5_8 + t5_9;
  const T R5_32 = t5_11 - t5_12;
  const T R5_33 = t5_10 - t5_2;
  // P5 = R4^T q5 + P4: position of the body origin, inertial axes [m]
  const T P5_1 = P4_1 + R4_11 * T(0.3) + R4_21 * T(0.25) + R4_31 * T(0.1);
  const T P5_2 = P4_2 + R4_12 * T(0.3) + R4_22 * T(0.25) + R4_32 * T(0.1);
  const T P5_3 = P4_3 + R4_13 * T(0.3) + R4_23 * T(0.25) + R4_33 * T(0.1);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_1 = P5_1 + R5_11 * T(0.1) + R5_21 * T(0.2) + R5_31 * T(0.05);
  const T p5_2 = P5_2 + R5_12 * T(0.1) + R5_22 * T(0.2) + R5_32 * T(0.05);
  const T p5_3 = P5_3 + R5_13 * T(0.1) + R5_23 * T(0.2) + R5_33 * T(0.05);
  // Pdot5 = R4^T omega4~ q5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t5_13 = t4_18 - omega4_3 * T(0.25);
  const T t5_14 = omega4_3 * T(0.3) - omega4_1 * T(0.1);
  const T t5_15 = omega4_1 * T(0.25) - omega4_2 * T(0.3);
  const T Pdot5_1 = Pdot4_1 + R4_11 * t5_13 + R4_21 * t5_14 + R4_31 * t5_15;
  const T Pdot5_2 = Pdot4_2 + R4_12 * t5_13 + R4_22 * t5_14 + R4_32 * t5_15;
  const T Pdot5_3 = Pdot4_3 + R4_13 * t5_13 + R4_23 * t5_14 + R4_33 * t5_15;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_16 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_17 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_18 = omega5_2 * T(0.1);
  const T t5_19 = omega5_1 * T(0.2) - t5_18;
  const T v5_1 = Pdot5_1 + R5_11 * t5_16 + R5_21 * t5_17 + R5_31 * t5_19;
  const T v5_2 = Pdot5_2 + R5_12 * t5_16 + R5_22 * t5_17 + R5_32 * t5_19;
  const T v5_3 = Pdot5_3 + R5_13 * t5_16 + R5_23 * t5_17 + R5_33 * t5_19;
  // l5 = m5 v5: linear momentum, inertial axes [kg m/s]
  const T l5_1 = T(1.5) * v5_1;
  const T l5_2 = T(1.5) * v5_2;
  const T l5_3 = T(1.5) * v5_3;
  // H5 = R5^T I5 omega5 + p5~ l5: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t5_20 = T(0.15) * omega5_1 + T(0.0075) * omega5_2 + T(0.0045) * omega5_3;
  const T t5_21 = T(0.0075) * omega5_1 + T(0.18) * omega5_2 - T(0.006) * omega5_3;
  const T t5_22 = T(0.0045) * omega5_1 - T(0.006) * omega5_2 + T(0.12) * omega5_3;
  const T H5_1 = R5_11 * t5_20 + R5_21 * t5_21 + R5_31 * t5_22 + p5_2 * l5_3 - p5_3 * l5_2;
  const T H5_2 = R5_12 * t5_20 + R5_22 * t5_21 + R5_32 * t5_22 + p5_3 * l5_1 - p5_1 * l5_3;
  const T H5_3 = R5_13 * t5_20 + R5_23 * t5_21 + R5_33 * t5_22 + p5_1 * l5_2 - p5_2 * l5_1;

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  // R6^T = 1 + 2 e6~ (eps4_6 + e6~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t6_1 = T(2) * eps6_2;
  const T t6_2 = t6_1 * eps6_2;
  const T t6_3 = T(2) * eps6_3;
  const T t6_4 = t6_3 * eps6_3;
  const T R6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * eps6_1;
  const T t6_6 = t6_5 * eps6_2;
  const T t6_7 = t6_3 * eps6_4;
  const T R6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * eps6_3;
  const T t6_9 = t6_1 * eps6_4;
  const T R6_13 = t6_8 - t6_9;
  const T R6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * eps6_1;
  const T R6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * eps6_3;
  const T t6_12 = t6_5 * eps6_4;
  const T R6_23 = t6_11 + t6_12;
  const T R6_31 = t6_8 + t6_9;
  const T R6_32 = t6_11 - t6_12;
  const T R6_33 = t6_10 - t6_2;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T P6_1 = P5_1 + R5_11 * T(0.3) + R5_21 * T(0.3) + R5_31 * T(0.1);
  const T P6_2 = P5_2 + R5_12 * T(0.3) + R5_22 * T(0.3) + R5_32 * T(0.1);
  const T P6_3 = P5_3 + R5_13 * T(0.3) + R5_23 * T(0.3) + R5_33 * T(0.1);
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = P6_1 + R6_11 * T(0.1) + R6_21 * T(0.2) + R6_31 * T(0.05);
  const T p6_2 = P6_2 + R6_12 * T(0.1) + R6_22 * T(0.2) + R6_32 * T(0.05);
  const T p6_3 = P6_3 + R6_13 * T(0.1) + R6_23 * T(0.2) + R6_33 * T(0.05);
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = omega5_3 * T(0.3);
  const T t6_14 = t5_18 - t6_13;
  const T t6_15 = t6_13 - omega5_1 * T(0.1);
  const T t6_16 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_14 + R5_21 * t6_15 + R5_31 * t6_16;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_14 + R5_22 * t6_15 + R5_32 * t6_16;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_14 + R5_23 * t6_15 + R5_33 * t6_16;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_17 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_18 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_19 = omega6_1 * T(0.2) - omega6_2 * T(0.1);
  const T v6_1 = Pdot6_1 + R6_11 * t6_17 + R6_21 * t6_18 + R6_31 * t6_19;
  const T v6_2 = Pdot6_2 + R6_12 * t6_17 + R6_22 * t6_18 + R6_32 * t6_19;
  const T v6_3 = Pdot6_3 + R6_13 * t6_17 + R6_23 * t6_18 + R6_33 * t6_19;
  // l6 = m6 v6: linear momentum, inertial axes [kg m/s]
  const T l6_1 = T(1.6) * v6_1;
  const T l6_2 = T(1.6) * v6_2;
  const T l6_3 = T(1.6) * v6_3;
  // H6 = R6^T I6 omega6 + p6~ l6: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t6_20 = T(0.16) * omega6_1 + T(0.008) * omega6_2 + T(0.0048) * omega6_3;
  const T t6_21 = T(0.008) * omega6_1 + T(0.192) * omega6_2 - T(0.0064) * omega6_3;
  const T t6_22 = T(0.0048) * omega6_1 - T(0.0064) * omega6_2 + T(0.128) * omega6_3;
  const T H6_1 = R6_11 * t6_20 + R6_21 * t6_21 + R6_31 * t6_22 + p6_2 * l6_3 - p6_3 * l6_2;
  const T H6_2 = R6_12 * t6_20 + R6_22 * t6_21 + R6_32 * t6_22 + p6_3 * l6_1 - p6_1 * l6_3;
  const T H6_3 = R6_13 * t6_20 + R6_23 * t6_21 + R6_33 * t6_22 + p6_1 * l6_2 - p6_2 * l6_1;

  // ---- whole system
  // linear = l1 + l2 + l3 + l4 + l5 + l6: linear momentum of the system [kg m/s]
  const T linear_1 = l1_1 + l2_1 + l3_1 + l4_1 + l5_1 + l6_1;
  const T linear_2 = l1_2 + l2_2 + l3_2 + l4_2 + l5_2 + l6_2;
  const T linear_3 = l1_3 + l2_3 + l3_3 + l4_3 + l5_3 + l6_3;
  momentum[0] = linear_1;
  momentum[1] = linear_2;
  momentum[2] = linear_3;
  // angular = H1 + H2 + H3 + H4 + H5 + H6: angular momentum of the system about the inertial origin [kg m^2/s]
  const T angular_1 = H1_1 + H2_1 + H3_1 + H4_1 + H5_1 + H6_1;
  const T angular_2 = H1_2 + H2_2 + H3_2 + H4_2 + H5_2 + H6_2;
  const T angular_3 = H1_3 + H2_3 + H3_3 + H4_3 + H5_3 + H6_3;
  momentum[3] = angular_1;
  momentum[4] = angular_2;
  momentum[5] = angular_3;
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 158 add, 195 multiply
template <class T>
void power([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* out) noexcept {

  // ---- body 1 (body_1) on the inertial frame
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

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  // R3^T = 1 + 2 e3~ (eps4_3 + e3~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t3_1 = T(2) * eps3_2;
  const T t3_2 = t3_1 * eps3_2;
  const T t3_3 = T(2) * eps3_3;
  const T t3_4 = t3_3 * eps3_3;
  const T R3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * eps3_1;
  const T t3_6 = t3_5 * eps3_2;
  const T t3_7 = t3_3 * eps3_4;
  const T R3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * eps3_3;
  const T t3_9 = t3_1 * eps3_4;
  const T R3_13 = t3_8 - t3_9;
  const T R3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * eps3_1;
  const T R3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * eps3_3;
  const T t3_12 = t3_5 * eps3_4;
  const T R3_23 = t3_11 + t3_12;
  const T R3_31 = t3_8 + t3_9;
  const T R3_32 = t3_11 - t3_12;
  const T R3_33 = t3_10 - t3_2;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  // R4^T = 1 + 2 e4~ (eps4_4 + e4~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t4_1 = T(2) * eps4_2;
  const T t4_2 = t4_1 * eps4_2;
  const T t4_3 = T(2) * eps4_3;
  const T t4_4 = t4_3 * eps4_3;
  const T R4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * eps4_1;
  const T t4_6 = t4_5 * eps4_2;
  const T t4_7 = t4_3 * eps4_4;
  const T R4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * eps4_3;
  const T t4_9 = t4_1 * eps4_4;
  const T R4_13 = t4_8 - t4_9;
  const T R4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * eps4_1;
  const T R4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * eps4_3;
  const T t4_12 = t4_5 * eps4_4;
  const T R4_23 = t4_11 + t4_12;
  const T R4_31 = t4_8 + t4_9;
  const T R4_32 = t4_11 - t4_12;
  const T R4_33 = t4_10 - t4_2;

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  // R5^T = 1 + 2 e5~ (eps4_5 + e5~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t5_1 = T(2) * eps5_2;
  const T t5_2 = t5_1 * eps5_2;
  const T t5_3 = T(2) * eps5_3;
  const T t5_4 = t5_3 * eps5_3;
  const T R5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * eps5_1;
  const T t5_6 = t5_5 * eps5_2;
  const T t5_7 = t5_3 * eps5_4;
  const T R5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * eps5_3;
  const T t5_9 = t5_1 * eps5_4;
  const T R5_13 = t5_8 - t5_9;
  const T R5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * eps5_1;
  const T R5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * eps5_3;
  const T t5_12 = t5_5 * eps5_4;
  const T R5_23 = t5_11 + t5_12;
  const T R5_31 = t5_8 + t5_9;
  const T R5_32 = t5_11 - t5_12;
  const T R5_33 = t5_10 - t5_2;

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  // R6^T = 1 + 2 e6~ (eps4_6 + e6~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t6_1 = T(2) * eps6_2;
  const T t6_2 = t6_1 * eps6_2;
  const T t6_3 = T(2) * eps6_3;
  const T t6_4 = t6_3 * eps6_3;
  const T R6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * eps6_1;
  const T t6_6 = t6_5 * eps6_2;
  const T t6_7 = t6_3 * eps6_4;
  const T R6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * eps6_3;
  const T t6_9 = t6_1 * eps6_4;
  const T R6_13 = t6_8 - t6_9;
  const T R6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * eps6_1;
  const T R6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * eps6_3;
  const T t6_12 = t6_5 * eps6_4;
  const T R6_23 = t6_11 + t6_12;
  const T R6_31 = t6_8 + t6_9;
  const T R6_32 = t6_11 - t6_12;
  const T R6_33 = t6_10 - t6_2;

  // ---- whole system
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  // power = -R1 R2^T M_torque_2_ . omega1 - R2 R3^T M_torque_3_ . omega2 - R3 R4^T M_torque_4_ . omega3 - R4 R5^T
  //   M_torque_5_ . omega4 - R5 R6^T M_torque_6_ . omega5 + M_torque_1_ . omega1 + M_torque_2_ . omega2 + M_torque_3_
  //   . omega3 + M_torque_4_ . omega4 + M_torque_5_ . omega5 + M_torque_6_ . omega6: power of the applied loads [W]
  const T b0_1 = R2_11 * u.tau_2_1 + R2_21 * u.tau_2_2 + R2_31 * u.tau_2_3;
  const T b0_2 = R2_12 * u.tau_2_1 + R2_22 * u.tau_2_2 + R2_32 * u.tau_2_3;
  const T b0_3 = R2_13 * u.tau_2_1 + R2_23 * u.tau_2_2 + R2_33 * u.tau_2_3;
  const T b0_4 = R3_11 * u.tau_3_1 + R3_21 * u.tau_3_2 + R3_31 * u.tau_3_3;
  const T b0_5 = R3_12 * u.tau_3_1 + R3_22 * u.tau_3_2 + R3_32 * u.tau_3_3;
  const T b0_6 = R3_13 * u.tau_3_1 + R3_23 * u.tau_3_2 + R3_33 * u.tau_3_3;
  const T b0_7 = R4_11 * u.tau_4_1 + R4_21 * u.tau_4_2 + R4_31 * u.tau_4_3;
  const T b0_8 = R4_12 * u.tau_4_1 + R4_22 * u.tau_4_2 + R4_32 * u.tau_4_3;
  const T b0_9 = R4_13 * u.tau_4_1 + R4_23 * u.tau_4_2 + R4_33 * u.tau_4_3;
  const T b0_10 = R5_11 * u.tau_5_1 + R5_21 * u.tau_5_2 + R5_31 * u.tau_5_3;
  const T b0_11 = R5_12 * u.tau_5_1 + R5_22 * u.tau_5_2 + R5_32 * u.tau_5_3;
  const T b0_12 = R5_13 * u.tau_5_1 + R5_23 * u.tau_5_2 + R5_33 * u.tau_5_3;
  const T b0_13 = R6_11 * u.tau_6_1 + R6_21 * u.tau_6_2 + R6_31 * u.tau_6_3;
  const T b0_14 = R6_12 * u.tau_6_1 + R6_22 * u.tau_6_2 + R6_32 * u.tau_6_3;
  const T b0_15 = R6_13 * u.tau_6_1 + R6_23 * u.tau_6_2 + R6_33 * u.tau_6_3;
  const T power = u.tau_1_1 * omega1_1 - ((R1_11 * b0_1 + R1_12 * b0_2 + R1_13 * b0_3) * omega1_1 + (R1_21 * b0_1 +
      R1_22 * b0_2 + R1_23 * b0_3) * omega1_2 + (R1_31 * b0_1 + R1_32 * b0_2 + R1_33 * b0_3) * omega1_3 + (R2_11 *
      b0_4 + R2_12 * b0_5 + R2_13 * b0_6) * omega2_1 + (R2_21 * b0_4 + R2_22 * b0_5 + R2_23 * b0_6) * omega2_2 +
      (R2_31 * b0_4 + R2_32 * b0_5 + R2_33 * b0_6) * omega2_3 + (R3_11 * b0_7 + R3_12 * b0_8 + R3_13 * b0_9) *
      omega3_1 + (R3_21 * b0_7 + R3_22 * b0_8 + R3_23 * b0_9) * omega3_2 + (R3_31 * b0_7 + R3_32 * b0_8 + R3_33 *
      b0_9) * omega3_3 + (R4_11 * b0_10 + R4_12 * b0_11 + R4_13 * b0_12) * omega4_1 + (R4_21 * b0_10 + R4_22 * b0_11 +
      R4_23 * b0_12) * omega4_2 + (R4_31 * b0_10 + R4_32 * b0_11 + R4_33 * b0_12) * omega4_3 + (R5_11 * b0_13 + R5_12
      * b0_14 + R5_13 * b0_15) * omega5_1 + (R5_21 * b0_13 + R5_22 * b0_14 + R5_23 * b0_15) * omega5_2 + (R5_31 *
      b0_13 + R5_32 * b0_14 + R5_33 * b0_15) * omega5_3) + u.tau_1_2 * omega1_2 + u.tau_1_3 * omega1_3 + u.tau_2_1 *
      omega2_1 + u.tau_2_2 * omega2_2 + u.tau_2_3 * omega2_3 + u.tau_3_1 * omega3_1 + u.tau_3_2 * omega3_2 + u.tau_3_3
      * omega3_3 + u.tau_4_1 * omega4_1 + u.tau_4_2 * omega4_2 + u.tau_4_3 * omega4_3 + u.tau_5_1 * omega5_1 +
      u.tau_5_2 * omega5_2 + u.tau_5_3 * omega5_3 + u.tau_6_1 * omega6_1 + u.tau_6_2 * omega6_2 + u.tau_6_3 *
      omega6_3;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 1080 add, 1268 multiply, 15 divide
// by: articulated; composite would take 2116 add, 2597 multiply, 15 divide
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot)
    noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_2;
  const T R1_13 = t1_1 * eps1_3 - t1_2 * eps1_4;
  const T R1_23 = t1_2 * eps1_3 + t1_1 * eps1_4;
  const T R1_33 = T(1) - t1_1 * eps1_1 - t1_2 * eps1_2;
  // U1 = omega1~ omega1~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t1_3 = omega1_3 * omega1_3;
  const T t1_4 = omega1_2 * omega1_2;
  const T minus_U1_11 = t1_3 + t1_4;
  const T U1_12 = omega1_2 * omega1_1;
  const T U1_13 = omega1_3 * omega1_1;
  const T t1_5 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_3 + t1_5;
  const T U1_23 = omega1_3 * omega1_2;
  const T minus_U1_33 = t1_4 + t1_5;
  // Pddot1 = -R1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1 = R1_13 * T(9.81);
  const T Pddot1_2 = R1_23 * T(9.81);
  const T Pddot1_3 = R1_33 * T(9.81);

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // erel2 = -e1~ e2 + eps4_1 e2 - eps4_2 e1: Euler parameters relative to the lower body
  const T erel2_1 = eps1_3 * eps2_2 - eps1_2 * eps2_3 + eps1_4 * eps2_1 - eps2_4 * eps1_1;
  const T erel2_2 = eps1_1 * eps2_3 - eps1_3 * eps2_1 + eps1_4 * eps2_2 - eps2_4 * eps1_2;
  const T erel2_3 = eps1_2 * eps2_1 - eps1_1 * eps2_2 + eps1_4 * eps2_3 - eps2_4 * eps1_3;
  // eps4rel2 = e1 . e2 + eps4_1 eps4_2
  const T eps4rel2 = eps1_1 * eps2_1 + eps1_2 * eps2_2 + eps1_3 * eps2_3 + eps1_4 * eps2_4;
  // C2^T = 1 + 2 erel2~ (eps4rel2 + erel2~): C takes components in the lower body to those in the body
  const T t2_1 = T(2) * erel2_2;
  const T t2_2 = t2_1 * erel2_2;
  const T t2_3 = T(2) * erel2_3;
  const T t2_4 = t2_3 * erel2_3;
  const T C2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * erel2_1;
  const T t2_6 = t2_5 * erel2_2;
  const T t2_7 = t2_3 * eps4rel2;
  const T C2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * erel2_3;
  const T t2_9 = t2_1 * eps4rel2;
  const T C2_13 = t2_8 - t2_9;
  const T C2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * erel2_1;
  const T C2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * erel2_3;
  const T t2_12 = t2_5 * eps4rel2;
  const T C2_23 = t2_11 + t2_12;
  const T C2_31 = t2_8 + t2_9;
  const T C2_32 = t2_11 - t2_12;
  const T C2_33 = t2_10 - t2_2;
  // U2 = omega2~ omega2~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t2_13 = omega2_3 * omega2_3;
  const T t2_14 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_13 + t2_14;
  const T U2_12 = omega2_2 * omega2_1;
  const T U2_13 = omega2_3 * omega2_1;
  const T t2_15 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_13 + t2_15;
  const T U2_23 = omega2_3 * omega2_2;
  const T minus_U2_33 = t2_14 + t2_15;
  // Pddot2 = C2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_16 = Pddot1_1 + U1_12 * T(0.1) - minus_U1_11 * T(0.3) + U1_13 * T(0.1);
  const T t2_17 = U1_23 * T(0.1);
  const T t2_18 = t2_17 + Pddot1_2 + U1_12 * T(0.3) - minus_U1_22 * T(0.1);
  const T t2_19 = t2_17 + Pddot1_3 + U1_13 * T(0.3) - minus_U1_33 * T(0.1);
  const T Pddot2_1 = C2_11 * t2_16 + C2_12 * t2_18 + C2_13 * t2_19;
  const T Pddot2_2 = C2_21 * t2_16 + C2_22 * t2_18 + C2_23 * t2_19;
  const T Pddot2_3 = C2_31 * t2_16 + C2_32 * t2_18 + C2_33 * t2_19;
  // N1 = -C2^T M_torque_2_ - h_all_1~ Pddot1 - omega1~ J_all_1 omega1 + M_torque_1_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N1_1 = u.tau_1_1 - C2_11 * u.tau_2_1 - C2_21 * u.tau_2_2 - C2_31 * u.tau_2_3 - T(0.47000000000000003) *
      Pddot1_3 + T(0.30500000000000005) * Pddot1_2 + T(0.0027500000000000033) * U1_23 + T(0.040400000000000005) *
      (t1_4 - t1_3) + T(0.0772) * U1_12 - T(0.09150000000000001) * U1_13;
  const T N1_2 = u.tau_1_2 - C2_12 * u.tau_2_1 - C2_22 * u.tau_2_2 - C2_32 * u.tau_2_3 - T(0.30500000000000005) *
      Pddot1_1 + T(0.86) * Pddot1_3 + T(0.18624999999999997) * U1_13 + T(0.0772) * (t1_3 - t1_5) +
      T(0.09150000000000001) * U1_23 - T(0.040400000000000005) * U1_12;
  const T N1_3 = u.tau_1_3 - C2_13 * u.tau_2_1 - C2_23 * u.tau_2_2 - C2_33 * u.tau_2_3 - T(0.86) * Pddot1_2 +
      T(0.47000000000000003) * Pddot1_1 - T(0.18899999999999997) * U1_12 + T(0.09150000000000001) * (t1_5 - t1_4) +
      T(0.040400000000000005) * U1_13 - T(0.0772) * U1_23;
  // G2 = -U2 h_all_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_12 * T(0.435) - minus_U2_11 * T(0.51) + U2_13 * T(0.19);
  const T minus_G2_2 = U2_12 * T(0.51) - minus_U2_22 * T(0.435) + U2_23 * T(0.19);
  const T minus_G2_3 = U2_13 * T(0.51) + U2_23 * T(0.435) - minus_U2_33 * T(0.19);

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  // erel3 = -e2~ e3 + eps4_2 e3 - eps4_3 e2: Euler parameters relative to the lower body
  const T erel3_1 = eps2_3 * eps3_2 - eps2_2 * eps3_3 + eps2_4 * eps3_1 - eps3_4 * eps2_1;
  const T erel3_2 = eps2_1 * eps3_3 - eps2_3 * eps3_1 + eps2_4 * eps3_2 - eps3_4 * eps2_2;
  const T erel3_3 = eps2_2 * eps3_1 - eps2_1 * eps3_2 + eps2_4 * eps3_3 - eps3_4 * eps2_3;
  // eps4rel3 = e2 . e3 + eps4_2 eps4_3
  const T eps4rel3 = eps2_1 * eps3_1 + eps2_2 * eps3_2 + eps2_3 * eps3_3 + eps2_4 * eps3_4;
  // C3^T = 1 + 2 erel3~ (eps4rel3 + erel3~): C takes components in the lower body to those in the body
  const T t3_1 = T(2) * erel3_2;
  const T t3_2 = t3_1 * erel3_2;
  const T t3_3 = T(2) * erel3_3;
  const T t3_4 = t3_3 * erel3_3;
  const T C3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * erel3_1;
  const T t3_6 = t3_5 * erel3_2;
  const T t3_7 = t3_3 * eps4rel3;
  const T C3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * erel3_3;
  const T t3_9 = t3_1 * eps4rel3;
  const T C3_13 = t3_8 - t3_9;
  const T C3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * erel3_1;
  const T C3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * erel3_3;
  const T t3_12 = t3_5 * eps4rel3;
  const T C3_23 = t3_11 + t3_12;
  const T C3_31 = t3_8 + t3_9;
  const T C3_32 = t3_11 - t3_12;
  const T C3_33 = t3_10 - t3_2;
  // U3 = omega3~ omega3~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t3_13 = omega3_3 * omega3_3;
  const T t3_14 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_13 + t3_14;
  const T U3_12 = omega3_2 * omega3_1;
  const T U3_13 = omega3_3 * omega3_1;
  const T t3_15 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_13 + t3_15;
  const T U3_23 = omega3_3 * omega3_2;
  const T minus_U3_33 = t3_14 + t3_15;
  // Pddot3 = C3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_16 = Pddot2_1 + U2_12 * T(0.15) - minus_U2_11 * T(0.3) + U2_13 * T(0.1);
  const T t3_17 = Pddot2_2 + U2_12 * T(0.3) - minus_U2_22 * T(0.15) + U2_23 * T(0.1);
  const T t3_18 = Pddot2_3 + U2_13 * T(0.3) + U2_23 * T(0.15) - minus_U2_33 * T(0.1);
  const T Pddot3_1 = C3_11 * t3_16 + C3_12 * t3_17 + C3_13 * t3_18;
  const T Pddot3_2 = C3_21 * t3_16 + C3_22 * t3_17 + C3_23 * t3_18;
  const T Pddot3_3 = C3_31 * t3_16 + C3_32 * t3_17 + C3_33 * t3_18;
  // N2 = -C3^T M_torque_3_ - h_all_2~ Pddot2 - omega2~ J_all_2 omega2 + M_torque_2_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N2_1 = u.tau_2_1 - C3_11 * u.tau_3_1 - C3_21 * u.tau_3_2 - C3_31 * u.tau_3_3 - T(0.435) * Pddot2_3 + T(0.19)
      * Pddot2_2 - T(0.013250000000000014) * U2_23 + T(0.0363) * (t2_14 - t2_13) + T(0.0414) * U2_12 - T(0.0765) *
      U2_13;
  const T N2_2 = u.tau_2_2 - C3_12 * u.tau_3_1 - C3_22 * u.tau_3_2 - C3_32 * u.tau_3_3 - T(0.19) * Pddot2_1 + T(0.51)
      * Pddot2_3 + T(0.089) * U2_13 + T(0.0414) * (t2_13 - t2_15) + T(0.0765) * U2_23 - T(0.0363) * U2_12;
  const T N2_3 = u.tau_2_3 - C3_13 * u.tau_3_1 - C3_23 * u.tau_3_2 - C3_33 * u.tau_3_3 - T(0.51) * Pddot2_2 + T(0.435)
      * Pddot2_1 - T(0.07574999999999998) * U2_12 + T(0.0765) * (t2_15 - t2_14) + T(0.0363) * U2_13 - T(0.0414) *
      U2_23;
  // G3 = -U3 h_all_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = U3_12 * T(0.26) - minus_U3_11 * T(0.13) + U3_13 * T(0.065);
  const T minus_G3_2 = U3_12 * T(0.13) - minus_U3_22 * T(0.26) + U3_23 * T(0.065);
  const T minus_G3_3 = U3_13 * T(0.13) + U3_23 * T(0.26) - minus_U3_33 * T(0.065);

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  // erel4 = -e3~ e4 + eps4_3 e4 - eps4_4 e3: Euler parameters relative to the lower body
  const T erel4_1 = eps3_3 * eps4_2 - eps3_2 * eps4_3 + eps3_4 * eps4_1 - eps4_4 * eps3_1;
  const T erel4_2 = eps3_1 * eps4_3 - eps3_3 * eps4_1 + eps3_4 * eps4_2 - eps4_4 * eps3_2;
  const T erel4_3 = eps3_2 * eps4_1 - eps3_1 * eps4_2 + eps3_4 * eps4_3 - eps4_4 * eps3_3;
  // eps4rel4 = e3 . e4 + eps4_3 eps4_4
  const T eps4rel4 = eps3_1 * eps4_1 + eps3_2 * eps4_2 + eps3_3 * eps4_3 + eps3_4 * eps4_4;
  // C4^T = 1 + 2 erel4~ (eps4rel4 + erel4~): C takes components in the lower body to those in the body
  const T t4_1 = T(2) * erel4_2;
  const T t4_2 = t4_1 * erel4_2;
  const T t4_3 = T(2) * erel4_3;
  const T t4_4 = t4_3 * erel4_3;
  const T C4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * erel4_1;
  const T t4_6 = t4_5 * erel4_2;
  const T t4_7 = t4_3 * eps4rel4;
  const T C4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * erel4_3;
  const T t4_9 = t4_1 * eps4rel4;
  const T C4_13 = t4_8 - t4_9;
  const T C4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * erel4_1;
  const T C4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * erel4_3;
  const T t4_12 = t4_5 * eps4rel4;
  const T C4_23 = t4_11 + t4_12;
  const T C4_31 = t4_8 + t4_9;
  const T C4_32 = t4_11 - t4_12;
  const T C4_33 = t4_10 - t4_2;
  // U4 = omega4~ omega4~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t4_13 = omega4_3 * omega4_3;
  const T t4_14 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_13 + t4_14;
  const T U4_12 = omega4_2 * omega4_1;
  const T U4_13 = omega4_3 * omega4_1;
  const T t4_15 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_13 + t4_15;
  const T U4_23 = omega4_3 * omega4_2;
  const T minus_U4_33 = t4_14 + t4_15;
  // Pddot4 = C4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_16 = Pddot3_1 + U3_12 * T(0.2) - minus_U3_11 * T(0.3) + U3_13 * T(0.1);
  const T t4_17 = Pddot3_2 + U3_12 * T(0.3) - minus_U3_22 * T(0.2) + U3_23 * T(0.1);
  const T t4_18 = Pddot3_3 + U3_13 * T(0.3) + U3_23 * T(0.2) - minus_U3_33 * T(0.1);
  const T Pddot4_1 = C4_11 * t4_16 + C4_12 * t4_17 + C4_13 * t4_18;
  const T Pddot4_2 = C4_21 * t4_16 + C4_22 * t4_17 + C4_23 * t4_18;
  const T Pddot4_3 = C4_31 * t4_16 + C4_32 * t4_17 + C4_33 * t4_18;
  // N3 = -C4^T M_torque_4_ - h_all_3~ Pddot3 - omega3~ J_all_3 omega3 + M_torque_3_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N3_1 = u.tau_3_1 - C4_11 * u.tau_4_1 - C4_21 * u.tau_4_2 - C4_31 * u.tau_4_3 - T(0.26) * Pddot3_3 + T(0.065)
      * Pddot3_2 + T(0.0032499999999999977) * U3_23 + T(0.0182) * (t3_14 - t3_13) + T(0.002600000000000001) * U3_12 -
      T(0.019500000000000003) * U3_13;
  const T N3_2 = u.tau_3_2 - C4_12 * u.tau_4_1 - C4_22 * u.tau_4_2 - C4_32 * u.tau_4_3 - T(0.065) * Pddot3_1 + T(0.13)
      * Pddot3_3 - T(0.016250000000000007) * U3_13 + T(0.002600000000000001) * (t3_13 - t3_15) +
      T(0.019500000000000003) * U3_23 - T(0.0182) * U3_12;
  const T N3_3 = u.tau_3_3 - C4_13 * u.tau_4_1 - C4_23 * u.tau_4_2 - C4_33 * u.tau_4_3 - T(0.13) * Pddot3_2 + T(0.26)
      * Pddot3_1 + T(0.01300000000000001) * U3_12 + T(0.019500000000000003) * (t3_15 - t3_14) + T(0.0182) * U3_13 -
      T(0.002600000000000001) * U3_23;
  // G4 = -m_all_4 Pddot4 - U4 h_all_4: applied less inertia force, body axes [N]
  const T minus_G4_1 = T(4.5) * Pddot4_1 + U4_12 * T(1.055) - minus_U4_11 * T(1.07) + U4_13 * T(0.38);
  const T minus_G4_2 = T(4.5) * Pddot4_2 + U4_12 * T(1.07) - minus_U4_22 * T(1.055) + U4_23 * T(0.38);
  const T minus_G4_3 = T(4.5) * Pddot4_3 + U4_13 * T(1.07) + U4_23 * T(1.055) - minus_U4_33 * T(0.38);

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  // erel5 = -e4~ e5 + eps4_4 e5 - eps4_5 e4: Euler parameters relative to the lower body
  const T erel5_1 = eps4_3 * eps5_2 - eps4_2 * eps5_3 + eps4_4 * eps5_1 - eps5_4 * eps4_1;
  const T erel5_2 = eps4_1 * eps5_3 - eps4_3 * eps5_1 + eps4_4 * eps5_2 - eps5_4 * eps4_2;
  const T erel5_3 = eps4_2 * eps5_1 - eps4_1 * eps5_2 + eps4_4 * eps5_3 - eps5_4 * eps4_3;
  // eps4rel5 = e4 . e5 + eps4_4 eps4_5
  const T eps4rel5 = eps4_1 * eps5_1 + eps4_2 * eps5_2 + eps4_3 * eps5_3 + eps4_4 * eps5_4;
  // C5^T = 1 + 2 erel5~ (eps4rel5 + erel5~): C takes components in the lower body to those in the body
  const T t5_1 = T(2) * erel5_2;
  const T t5_2 = t5_1 * erel5_2;
  const T t5_3 = T(2) * erel5_3;
  const T t5_4 = t5_3 * erel5_3;
  const T C5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * erel5_1;
  const T t5_6 = t5_5 * erel5_2;
  const T t5_7 = t5_3 * eps4rel5;
  const T C5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * erel5_3;
  const T t5_9 = t5_1 * eps4rel5;
  const T C5_13 = t5_8 - t5_9;
  const T C5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * erel5_1;
  const T C5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * erel5_3;
  const T t5_12 = t5_5 * eps4rel5;
  const T C5_23 = t5_11 + t5_12;
  const T C5_31 = t5_8 + t5_9;
  const T C5_32 = t5_11 - t5_12;
  const T C5_33 = t5_10 - t5_2;
  // U5 = omega5~ omega5~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t5_13 = omega5_3 * omega5_3;
  const T t5_14 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_13 + t5_14;
  const T U5_12 = omega5_2 * omega5_1;
  const T U5_13 = omega5_3 * omega5_1;
  const T t5_15 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_13 + t5_15;
  const T U5_23 = omega5_3 * omega5_2;
  const T minus_U5_33 = t5_14 + t5_15;
  // Pddot5 = C5 (U4 q5 + Pddot4): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_16 = Pddot4_1 + U4_12 * T(0.25) - minus_U4_11 * T(0.3) + U4_13 * T(0.1);
  const T t5_17 = Pddot4_2 + U4_12 * T(0.3) - minus_U4_22 * T(0.25) + U4_23 * T(0.1);
  const T t5_18 = Pddot4_3 + U4_13 * T(0.3) + U4_23 * T(0.25) - minus_U4_33 * T(0.1);
  const T Pddot5_1 = C5_11 * t5_16 + C5_12 * t5_17 + C5_13 * t5_18;
  const T Pddot5_2 = C5_21 * t5_16 + C5_22 * t5_17 + C5_23 * t5_18;
  const T Pddot5_3 = C5_31 * t5_16 + C5_32 * t5_17 + C5_33 * t5_18;
  // N4 = -C5^T M_torque_5_ - h_all_4~ Pddot4 - omega4~ J_all_4 omega4 + M_torque_4_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N4_1 = u.tau_4_1 - C5_11 * u.tau_5_1 - C5_21 * u.tau_5_2 - C5_31 * u.tau_5_3 - T(1.055) * Pddot4_3 + T(0.38)
      * Pddot4_2 - T(0.15925) * U4_23 + T(0.0971) * (t4_14 - t4_13) + T(0.09580000000000001) * U4_12 - T(0.2535) *
      U4_13;
  const T N4_2 = u.tau_4_2 - C5_12 * u.tau_5_1 - C5_22 * u.tau_5_2 - C5_32 * u.tau_5_3 - T(0.38) * Pddot4_1 + T(1.07)
      * Pddot4_3 + T(0.23049999999999998) * U4_13 + T(0.09580000000000001) * (t4_13 - t4_15) + T(0.2535) * U4_23 -
      T(0.0971) * U4_12;
  const T N4_3 = u.tau_4_3 - C5_13 * u.tau_5_1 - C5_23 * u.tau_5_2 - C5_33 * u.tau_5_3 - T(1.07) * Pddot4_2 + T(1.055)
      * Pddot4_1 - T(0.07124999999999998) * U4_12 + T(0.2535) * (t4_15 - t4_14) + T(0.0971) * U4_13 -
      T(0.09580000000000001) * U4_23;
  // G5 = -U5 h_all_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = U5_12 * T(0.78) - minus_U5_11 * T(0.63) + U5_13 * T(0.23500000000000001);
  const T minus_G5_2 = U5_12 * T(0.63) - minus_U5_22 * T(0.78) + U5_23 * T(0.23500000000000001);
  const T minus_G5_3 = U5_13 * T(0.63) + U5_23 * T(0.78) - minus_U5_33 * T(0.23500000000000001);

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  // erel6 = -e5~ e6 + eps4_5 e6 - eps4_6 e5: Euler parameters relative to the lower body
  const T erel6_1 = eps5_3 * eps6_2 - eps5_2 * eps6_3 + eps5_4 * eps6_1 - eps6_4 * eps5_1;
  const T erel6_2 = eps5_1 * eps6_3 - eps5_3 * eps6_1 + eps5_4 * eps6_2 - eps6_4 * eps5_2;
  const T erel6_3 = eps5_2 * eps6_1 - eps5_1 * eps6_2 + eps5_4 * eps6_3 - eps6_4 * eps5_3;
  // eps4rel6 = e5 . e6 + eps4_5 eps4_6
  const T eps4rel6 = eps5_1 * eps6_1 + eps5_2 * eps6_2 + eps5_3 * eps6_3 + eps5_4 * eps6_4;
  // C6^T = 1 + 2 erel6~ (eps4rel6 + erel6~): C takes components in the lower body to those in the body
  const T t6_1 = T(2) * erel6_2;
  const T t6_2 = t6_1 * erel6_2;
  const T t6_3 = T(2) * erel6_3;
  const T t6_4 = t6_3 * erel6_3;
  const T C6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * erel6_1;
  const T t6_6 = t6_5 * erel6_2;
  const T t6_7 = t6_3 * eps4rel6;
  const T C6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * erel6_3;
  const T t6_9 = t6_1 * eps4rel6;
  const T C6_13 = t6_8 - t6_9;
  const T C6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * erel6_1;
  const T C6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * erel6_3;
  const T t6_12 = t6_5 * eps4rel6;
  const T C6_23 = t6_11 + t6_12;
  const T C6_31 = t6_8 + t6_9;
  const T C6_32 = t6_11 - t6_12;
  const T C6_33 = t6_10 - t6_2;
  // U6 = omega6~ omega6~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t6_13 = omega6_3 * omega6_3;
  const T t6_14 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_13 + t6_14;
  const T U6_12 = omega6_2 * omega6_1;
  const T U6_13 = omega6_3 * omega6_1;
  const T t6_15 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_13 + t6_15;
  const T U6_23 = omega6_3 * omega6_2;
  const T minus_U6_33 = t6_14 + t6_15;
  // Pddot6 = C6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t6_16 = U5_12 * T(0.3);
  const T t6_17 = t6_16 + Pddot5_1 - minus_U5_11 * T(0.3) + U5_13 * T(0.1);
  const T t6_18 = t6_16 + Pddot5_2 - minus_U5_22 * T(0.3) + U5_23 * T(0.1);
  const T t6_19 = Pddot5_3 + U5_13 * T(0.3) + U5_23 * T(0.3) - minus_U5_33 * T(0.1);
  const T Pddot6_1 = C6_11 * t6_17 + C6_12 * t6_18 + C6_13 * t6_19;
  const T Pddot6_2 = C6_21 * t6_17 + C6_22 * t6_18 + C6_23 * t6_19;
  const T Pddot6_3 = C6_31 * t6_17 + C6_32 * t6_18 + C6_33 * t6_19;
  // N5 = -C6^T M_torque_6_ - h_all_5~ Pddot5 - omega5~ J_all_5 omega5 + M_torque_5_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N5_1 = u.tau_5_1 - C6_11 * u.tau_6_1 - C6_21 * u.tau_6_2 - C6_31 * u.tau_6_3 - T(0.78) * Pddot5_3 +
      T(0.23500000000000001) * Pddot5_2 - T(0.12425) * U5_23 + T(0.069) * (t5_14 - t5_13) + T(0.051000000000000004) *
      U5_12 - T(0.1665) * U5_13;
  const T N5_2 = u.tau_5_2 - C6_12 * u.tau_6_1 - C6_22 * u.tau_6_2 - C6_32 * u.tau_6_3 - T(0.23500000000000001) *
      Pddot5_1 + T(0.63) * Pddot5_3 + T(0.10925) * U5_13 + T(0.051000000000000004) * (t5_13 - t5_15) + T(0.1665) *
      U5_23 - T(0.069) * U5_12;
  const T N5_3 = u.tau_5_3 - C6_13 * u.tau_6_1 - C6_23 * u.tau_6_2 - C6_33 * u.tau_6_3 - T(0.63) * Pddot5_2 + T(0.78)
      * Pddot5_1 + T(0.015000000000000006) * U5_12 + T(0.1665) * (t5_15 - t5_14) + T(0.069) * U5_13 -
      T(0.051000000000000004) * U5_23;
  // G6 = -U6 h_all_6: applied less inertia force, body axes [N]
  const T minus_G6_1 = U6_12 * T(0.32000000000000006) - minus_U6_11 * T(0.16000000000000003) + U6_13 *
      T(0.08000000000000002);
  const T minus_G6_2 = U6_12 * T(0.16000000000000003) - minus_U6_22 * T(0.32000000000000006) + U6_23 *
      T(0.08000000000000002);
  const T minus_G6_3 = U6_13 * T(0.16000000000000003) + U6_23 * T(0.32000000000000006) - minus_U6_33 *
      T(0.08000000000000002);
  // N6 = -h_all_6~ Pddot6 - omega6~ J_all_6 omega6 + M_torque_6_: applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N6_1 = u.tau_6_1 + T(0.08000000000000002) * Pddot6_2 - T(0.32000000000000006) * Pddot6_3 +
      T(0.003999999999999991) * U6_23 + T(0.022400000000000003) * (t6_14 - t6_13) + T(0.003200000000000002) * U6_12 -
      T(0.024000000000000004) * U6_13;
  const T N6_2 = u.tau_6_2 + T(0.16000000000000003) * Pddot6_3 - T(0.08000000000000002) * Pddot6_1 -
      T(0.019999999999999997) * U6_13 + T(0.003200000000000002) * (t6_13 - t6_15) + T(0.024000000000000004) * U6_23 -
      T(0.022400000000000003) * U6_12;
  const T N6_3 = u.tau_6_3 + T(0.32000000000000006) * Pddot6_1 - T(0.16000000000000003) * Pddot6_2 +
      T(0.016000000000000007) * U6_12 + T(0.024000000000000004) * (t6_15 - t6_14) + T(0.022400000000000003) * U6_13 -
      T(0.003200000000000002) * U6_23;

  // ---- body 6 (body_6) and what it carries
  // w_6 = D(LD6)^-1 L(LD6)^-1 N6: D^-1 L^-1 n
  const T w_6_1 = T(4.385964912280701) * N6_1;
  const T b6_1 = N6_2 + T(0.10526315789473686) * N6_1;
  const T w_6_2 = T(4.773869346733668) * b6_1;
  const T w_6_3 = T(4.866483897725908) * (N6_3 + T(0.014035087719298253) * N6_1 + T(0.1085427135678392) * b6_1);
  // gb6 = G6 - Y6^T w_6: force with the ball solved [N]
  const T minus_gb6_1 = minus_G6_1 + T(0.08000000000000002) * w_6_2 - T(0.31131658291457287) * w_6_3;
  const T minus_gb6_2 = minus_G6_2 - T(0.008421052631578949) * w_6_2 - T(0.08000000000000002) * w_6_1 +
      T(0.157963149078727) * w_6_3;
  const T minus_gb6_3 = minus_G6_3 + T(0.32000000000000006) * w_6_1 - T(0.12631578947368421) * w_6_2 -
      T(0.009219430485762145) * w_6_3;
  // Mb6 = C6^T M6 C6: M of the joint, lower body's axes
  const T b6_2 = C6_11 * T(0.5022027222312071) - C6_21 * T(0.24253295840484976) - C6_31 * T(0.03427361084301522);
  const T b6_3 = C6_21 * T(0.14983895117408613) - C6_11 * T(0.24253295840484976) - C6_31 * T(0.11428988788664501);
  const T b6_4 = C6_31 * T(0.5257067732326105) - (C6_11 * T(0.03427361084301522) + C6_21 * T(0.11428988788664501));
  const T minus_Mb6_11 = b6_2 * C6_11 + b6_3 * C6_21 + b6_4 * C6_31;
  const T minus_Mb6_12 = b6_2 * C6_12 + b6_3 * C6_22 + b6_4 * C6_32;
  const T minus_Mb6_13 = b6_2 * C6_13 + b6_3 * C6_23 + b6_4 * C6_33;
  const T b6_5 = C6_12 * T(0.5022027222312071) - C6_22 * T(0.24253295840484976) - C6_32 * T(0.03427361084301522);
  const T b6_6 = C6_22 * T(0.14983895117408613) - C6_12 * T(0.24253295840484976) - C6_32 * T(0.11428988788664501);
  const T b6_7 = C6_32 * T(0.5257067732326105) - (C6_12 * T(0.03427361084301522) + C6_22 * T(0.11428988788664501));
  const T minus_Mb6_22 = b6_5 * C6_12 + b6_6 * C6_22 + b6_7 * C6_32;
  const T minus_Mb6_23 = b6_5 * C6_13 + b6_6 * C6_23 + b6_7 * C6_33;
  const T Mb6_33 = minus_Mb6_11 - T(1.1777484466379038) + minus_Mb6_22;
  // Hb6 = q6~ Mb6: H of the joint at the lower body's origin, its axes
  const T b6_8 = T(0.1) * minus_Mb6_12;
  const T b6_9 = T(0.3) * minus_Mb6_13;
  const T Hb6_11 = b6_8 - b6_9;
  const T b6_10 = T(0.3) * minus_Mb6_23;
  const T Hb6_12 = T(0.1) * minus_Mb6_22 - b6_10;
  const T b6_11 = T(0.3) * Mb6_33;
  const T Hb6_13 = b6_11 + T(0.1) * minus_Mb6_23;
  const T Hb6_21 = b6_9 - T(0.1) * minus_Mb6_11;
  const T Hb6_22 = b6_10 - b6_8;
  const T minus_Hb6_23 = b6_11 + T(0.1) * minus_Mb6_13;
  const T b6_12 = T(0.3) * minus_Mb6_12;
  const T Hb6_31 = T(0.3) * minus_Mb6_11 - b6_12;
  const T Hb6_32 = b6_12 - T(0.3) * minus_Mb6_22;
  const T Hb6_33 = b6_9 - b6_10;

  // ---- body 5 (body_5) and what it carries
  // HA5 = h_all_5~ + Hb6: moment for an acceleration of the origin, body axes [kg m]
  const T HA5_12 = Hb6_12 - T(0.23500000000000001);
  const T HA5_13 = T(0.78) + Hb6_13;
  const T HA5_21 = T(0.23500000000000001) + Hb6_21;
  const T minus_HA5_23 = T(0.63) + minus_Hb6_23;
  const T HA5_31 = Hb6_31 - T(0.78);
  const T HA5_32 = T(0.63) + Hb6_32;
  // JA5 = J_all_5 - Hb6 q6~: moment for an angular acceleration, body axes [kg m^2]
  const T b5_1 = Hb6_13 * T(0.3);
  const T JA5_11 = b5_1 + T(0.37375) - Hb6_12 * T(0.1);
  const T minus_JA5_12 = T(0.1665) + b5_1 - Hb6_11 * T(0.1);
  const T minus_JA5_13 = T(0.051000000000000004) + Hb6_11 * T(0.3) - Hb6_12 * T(0.3);
  const T JA5_22 = T(0.35875) + Hb6_21 * T(0.1) + minus_Hb6_23 * T(0.3);
  const T minus_JA5_23 = T(0.069) + Hb6_21 * T(0.3) - Hb6_22 * T(0.3);
  const T JA5_33 = T(0.483) + Hb6_32 * T(0.3) - Hb6_31 * T(0.3);
  // g5 = C6^T gb6 + G5: force that drives it, home axes [N]
  const T b5_2 = C6_11 * minus_gb6_1 + C6_21 * minus_gb6_2 + C6_31 * minus_gb6_3;
  const T minus_g5_1 = b5_2 + minus_G5_1;
  const T b5_3 = C6_12 * minus_gb6_1 + C6_22 * minus_gb6_2 + C6_32 * minus_gb6_3;
  const T minus_g5_2 = b5_3 + minus_G5_2;
  const T b5_4 = C6_13 * minus_gb6_1 + C6_23 * minus_gb6_2 + C6_33 * minus_gb6_3;
  const T minus_g5_3 = b5_4 + minus_G5_3;
  // n5 = q6~ C6^T gb6 + N5: moment that drives it, body axes [N m]
  const T b5_5 = T(0.3) * b5_4;
  const T n5_1 = N5_1 - b5_5 + T(0.1) * b5_3;
  const T n5_2 = b5_5 + N5_2 - T(0.1) * b5_2;
  const T n5_3 = N5_3 + T(0.3) * b5_2 - T(0.3) * b5_3;
  // LD5 = L D L^T of JA5: L D L^T = JA: L, and 1/D on the diagonal
  const T LD5_11 = T(1) / JA5_11;
  const T minus_LD5_21 = LD5_11 * minus_JA5_12;
  const T LD5_22 = T(1) / (JA5_22 - minus_LD5_21 * minus_JA5_12);
  const T minus_LD5_31 = LD5_11 * minus_JA5_13;
  const T b5_6 = minus_JA5_23 + minus_LD5_21 * minus_JA5_13;
  const T minus_LD5_32 = LD5_22 * b5_6;
  const T LD5_33 = T(1) / (JA5_33 - minus_LD5_31 * minus_JA5_13 - minus_LD5_32 * b5_6);
  // Y5 = L(LD5)^-1 HA5: L^-1 HA
  const T Y5_21 = HA5_21 + minus_LD5_21 * Hb6_11;
  const T Y5_22 = Hb6_22 + minus_LD5_21 * HA5_12;
  const T minus_Y5_23 = minus_HA5_23 - minus_LD5_21 * HA5_13;
  const T Y5_31 = HA5_31 + minus_LD5_31 * Hb6_11 + minus_LD5_32 * Y5_21;
  const T Y5_32 = HA5_32 + minus_LD5_31 * HA5_12 + minus_LD5_32 * Y5_22;
  const T Y5_33 = Hb6_33 + minus_LD5_31 * HA5_13 - minus_LD5_32 * minus_Y5_23;
  // W5 = D(LD5)^-1 Y5: D^-1 L^-1 HA
  const T W5_11 = LD5_11 * Hb6_11;
  const T W5_12 = LD5_11 * HA5_12;
  const T W5_13 = LD5_11 * HA5_13;
  const T W5_21 = LD5_22 * Y5_21;
  const T W5_22 = LD5_22 * Y5_22;
  const T minus_W5_23 = LD5_22 * minus_Y5_23;
  const T W5_31 = LD5_33 * Y5_31;
  const T W5_32 = LD5_33 * Y5_32;
  const T W5_33 = LD5_33 * Y5_33;
  // w_5 = D(LD5)^-1 L(LD5)^-1 n5: D^-1 L^-1 n
  const T w_5_1 = LD5_11 * n5_1;
  const T b5_7 = n5_2 + minus_LD5_21 * n5_1;
  const T w_5_2 = LD5_22 * b5_7;
  const T w_5_3 = LD5_33 * (n5_3 + minus_LD5_31 * n5_1 + minus_LD5_32 * b5_7);
  // M5 = Mb6 - Y5^T W5: MA less what the ball takes up [kg]
  const T minus_M5_11 = minus_Mb6_11 + Hb6_11 * W5_11 + Y5_21 * W5_21 + Y5_31 * W5_31;
  const T minus_M5_12 = minus_Mb6_12 + Hb6_11 * W5_12 + Y5_21 * W5_22 + Y5_31 * W5_32;
  const T minus_M5_13 = minus_Mb6_13 + Hb6_11 * W5_13 - Y5_21 * minus_W5_23 + Y5_31 * W5_33;
  const T minus_M5_22 = minus_Mb6_22 + HA5_12 * W5_12 + Y5_22 * W5_22 + Y5_32 * W5_32;
  const T minus_M5_23 = minus_Mb6_23 + HA5_12 * W5_13 - Y5_22 * minus_W5_23 + Y5_32 * W5_33;
  const T M5_33 = Mb6_33 - HA5_13 * W5_13 - minus_Y5_23 * minus_W5_23 - Y5_33 * W5_33;
  // gb5 = g5 - Y5^T w_5: force with the ball solved [N]
  const T minus_gb5_1 = minus_g5_1 + Hb6_11 * w_5_1 + Y5_21 * w_5_2 + Y5_31 * w_5_3;
  const T minus_gb5_2 = minus_g5_2 + HA5_12 * w_5_1 + Y5_22 * w_5_2 + Y5_32 * w_5_3;
  const T minus_gb5_3 = minus_g5_3 + HA5_13 * w_5_1 - minus_Y5_23 * w_5_2 + Y5_33 * w_5_3;
  // Mb5 = C5^T M5 C5: M of the joint, lower body's axes
  const T b5_8 = C5_31 * M5_33 - (C5_11 * minus_M5_13 + C5_21 * minus_M5_23);
  const T b5_9 = C5_11 * minus_M5_11 + C5_21 * minus_M5_12 + C5_31 * minus_M5_13;
  const T b5_10 = C5_11 * minus_M5_12 + C5_21 * minus_M5_22 + C5_31 * minus_M5_23;
  const T Mb5_11 = b5_8 * C5_31 - (b5_9 * C5_11 + b5_10 * C5_21);
  const T Mb5_12 = b5_8 * C5_32 - (b5_9 * C5_12 + b5_10 * C5_22);
  const T Mb5_13 = b5_8 * C5_33 - (b5_9 * C5_13 + b5_10 * C5_23);
  const T b5_11 = C5_32 * M5_33 - (C5_12 * minus_M5_13 + C5_22 * minus_M5_23);
  const T b5_12 = C5_12 * minus_M5_11 + C5_22 * minus_M5_12 + C5_32 * minus_M5_13;
  const T b5_13 = C5_12 * minus_M5_12 + C5_22 * minus_M5_22 + C5_32 * minus_M5_23;
  const T Mb5_22 = b5_11 * C5_32 - (b5_12 * C5_12 + b5_13 * C5_22);
  const T Mb5_23 = b5_11 * C5_33 - (b5_12 * C5_13 + b5_13 * C5_23);
  const T Mb5_33 = M5_33 - (minus_M5_11 + minus_M5_22) - Mb5_11 - Mb5_22;
  // Hb5 = q5~ Mb5: H of the joint at the lower body's origin, its axes
  const T b5_14 = T(0.25) * Mb5_13;
  const T b5_15 = T(0.1) * Mb5_12;
  const T Hb5_11 = b5_14 - b5_15;
  const T Hb5_12 = T(0.25) * Mb5_23 - T(0.1) * Mb5_22;
  const T Hb5_13 = T(0.25) * Mb5_33 - T(0.1) * Mb5_23;
  const T Hb5_21 = T(0.1) * Mb5_11 - T(0.3) * Mb5_13;
  const T b5_16 = T(0.3) * Mb5_23;
  const T Hb5_22 = b5_15 - b5_16;
  const T Hb5_23 = T(0.1) * Mb5_13 - T(0.3) * Mb5_33;
  const T Hb5_31 = T(0.3) * Mb5_12 - T(0.25) * Mb5_11;
  const T Hb5_32 = T(0.3) * Mb5_22 - T(0.25) * Mb5_12;
  const T Hb5_33 = b5_16 - b5_14;

  // ---- body 4 (body_4) and what it carries
  // MA4 = m_all_4 one + Mb5: force for an acceleration of the origin, home axes [kg]
  const T MA4_11 = T(4.5) + Mb5_11;
  const T MA4_22 = T(4.5) + Mb5_22;
  const T MA4_33 = T(4.5) + Mb5_33;
  // HA4 = h_all_4~ + Hb5: moment for an acceleration of the origin, body axes [kg m]
  const T HA4_12 = Hb5_12 - T(0.38);
  const T HA4_13 = T(1.055) + Hb5_13;
  const T HA4_21 = T(0.38) + Hb5_21;
  const T HA4_23 = Hb5_23 - T(1.07);
  const T HA4_31 = Hb5_31 - T(1.055);
  const T HA4_32 = T(1.07) + Hb5_32;
  // JA4 = J_all_4 - Hb5 q5~: moment for an angular acceleration, body axes [kg m^2]
  const T JA4_11 = T(0.42425) + Hb5_13 * T(0.25) - Hb5_12 * T(0.1);
  const T minus_JA4_12 = T(0.2535) + Hb5_13 * T(0.3) - Hb5_11 * T(0.1);
  const T minus_JA4_13 = T(0.09580000000000001) + Hb5_11 * T(0.25) - Hb5_12 * T(0.3);
  const T JA4_22 = T(0.4955) + Hb5_21 * T(0.1) - Hb5_23 * T(0.3);
  const T minus_JA4_23 = T(0.0971) + Hb5_21 * T(0.25) - Hb5_22 * T(0.3);
  const T JA4_33 = T(0.6547499999999999) + Hb5_32 * T(0.3) - Hb5_31 * T(0.25);
  // g4 = C5^T gb5 + G4: force that drives it, home axes [N]
  const T b4_1 = C5_11 * minus_gb5_1 + C5_21 * minus_gb5_2 + C5_31 * minus_gb5_3;
  const T minus_g4_1 = minus_G4_1 + b4_1;
  const T b4_2 = C5_12 * minus_gb5_1 + C5_22 * minus_gb5_2 + C5_32 * minus_gb5_3;
  const T minus_g4_2 = minus_G4_2 + b4_2;
  const T b4_3 = C5_13 * minus_gb5_1 + C5_23 * minus_gb5_2 + C5_33 * minus_gb5_3;
  const T minus_g4_3 = minus_G4_3 + b4_3;
  // n4 = q5~ C5^T gb5 + N4: moment that drives it, body axes [N m]
  const T n4_1 = N4_1 + T(0.1) * b4_2 - T(0.25) * b4_3;
  const T n4_2 = N4_2 + T(0.3) * b4_3 - T(0.1) * b4_1;
  const T n4_3 = N4_3 + T(0.25) * b4_1 - T(0.3) * b4_2;
  // LD4 = L D L^T of JA4: L D L^T = JA: L, and 1/D on the diagonal
  const T LD4_11 = T(1) / JA4_11;
  const T minus_LD4_21 = LD4_11 * minus_JA4_12;
  const T LD4_22 = T(1) / (JA4_22 - minus_LD4_21 * minus_JA4_12);
  const T minus_LD4_31 = LD4_11 * minus_JA4_13;
  const T b4_4 = minus_JA4_23 + minus_LD4_21 * minus_JA4_13;
  const T minus_LD4_32 = LD4_22 * b4_4;
  const T LD4_33 = T(1) / (JA4_33 - minus_LD4_31 * minus_JA4_13 - minus_LD4_32 * b4_4);
  // Y4 = L(LD4)^-1 HA4: L^-1 HA
  const T Y4_21 = HA4_21 + minus_LD4_21 * Hb5_11;
  const T Y4_22 = Hb5_22 + minus_LD4_21 * HA4_12;
  const T Y4_23 = HA4_23 + minus_LD4_21 * HA4_13;
  const T Y4_31 = HA4_31 + minus_LD4_31 * Hb5_11 + minus_LD4_32 * Y4_21;
  const T Y4_32 = HA4_32 + minus_LD4_31 * HA4_12 + minus_LD4_32 * Y4_22;
  const T Y4_33 = Hb5_33 + minus_LD4_31 * HA4_13 + minus_LD4_32 * Y4_23;
  // W4 = D(LD4)^-1 Y4: D^-1 L^-1 HA
  const T W4_11 = LD4_11 * Hb5_11;
  const T W4_12 = LD4_11 * HA4_12;
  const T W4_13 = LD4_11 * HA4_13;
  const T W4_21 = LD4_22 * Y4_21;
  const T W4_22 = LD4_22 * Y4_22;
  const T W4_23 = LD4_22 * Y4_23;
  const T W4_31 = LD4_33 * Y4_31;
  const T W4_32 = LD4_33 * Y4_32;
  const T W4_33 = LD4_33 * Y4_33;
  // w_4 = D(LD4)^-1 L(LD4)^-1 n4: D^-1 L^-1 n
  const T w_4_1 = LD4_11 * n4_1;
  const T b4_5 = n4_2 + minus_LD4_21 * n4_1;
  const T w_4_2 = LD4_22 * b4_5;
  const T w_4_3 = LD4_33 * (n4_3 + minus_LD4_31 * n4_1 + minus_LD4_32 * b4_5);
  // M4 = MA4 - Y4^T W4: MA less what the ball takes up [kg]
  const T M4_11 = MA4_11 - Hb5_11 * W4_11 - Y4_21 * W4_21 - Y4_31 * W4_31;
  const T M4_12 = Mb5_12 - Hb5_11 * W4_12 - Y4_21 * W4_22 - Y4_31 * W4_32;
  const T M4_13 = Mb5_13 - Hb5_11 * W4_13 - Y4_21 * W4_23 - Y4_31 * W4_33;
  const T M4_22 = MA4_22 - HA4_12 * W4_12 - Y4_22 * W4_22 - Y4_32 * W4_32;
  const T M4_23 = Mb5_23 - HA4_12 * W4_13 - Y4_22 * W4_23 - Y4_32 * W4_33;
  const T M4_33 = MA4_33 - HA4_13 * W4_13 - Y4_23 * W4_23 - Y4_33 * W4_33;
  // gb4 = g4 - Y4^T w_4: force with the ball solved [N]
  const T minus_gb4_1 = minus_g4_1 + Hb5_11 * w_4_1 + Y4_21 * w_4_2 + Y4_31 * w_4_3;
  const T minus_gb4_2 = minus_g4_2 + HA4_12 * w_4_1 + Y4_22 * w_4_2 + Y4_32 * w_4_3;
  const T minus_gb4_3 = minus_g4_3 + HA4_13 * w_4_1 + Y4_23 * w_4_2 + Y4_33 * w_4_3;
  // Mb4 = C4^T M4 C4: M of the joint, lower body's axes
  const T b4_6 = C4_11 * M4_11 + C4_21 * M4_12 + C4_31 * M4_13;
  const T b4_7 = C4_11 * M4_12 + C4_21 * M4_22 + C4_31 * M4_23;
  const T b4_8 = C4_11 * M4_13 + C4_21 * M4_23 + C4_31 * M4_33;
  const T Mb4_11 = b4_6 * C4_11 + b4_7 * C4_21 + b4_8 * C4_31;
  const T Mb4_12 = b4_6 * C4_12 + b4_7 * C4_22 + b4_8 * C4_32;
  const T Mb4_13 = b4_6 * C4_13 + b4_7 * C4_23 + b4_8 * C4_33;
  const T b4_9 = C4_12 * M4_11 + C4_22 * M4_12 + C4_32 * M4_13;
  const T b4_10 = C4_12 * M4_12 + C4_22 * M4_22 + C4_32 * M4_23;
  const T b4_11 = C4_12 * M4_13 + C4_22 * M4_23 + C4_32 * M4_33;
  const T Mb4_22 = b4_9 * C4_12 + b4_10 * C4_22 + b4_11 * C4_32;
  const T Mb4_23 = b4_9 * C4_13 + b4_10 * C4_23 + b4_11 * C4_33;
  const T Mb4_33 = M4_11 + M4_22 + M4_33 - Mb4_11 - Mb4_22;
  // Hb4 = q4~ Mb4: H of the joint at the lower body's origin, its axes
  const T b4_12 = T(0.2) * Mb4_13;
  const T b4_13 = T(0.1) * Mb4_12;
  const T Hb4_11 = b4_12 - b4_13;
  const T Hb4_12 = T(0.2) * Mb4_23 - T(0.1) * Mb4_22;
  const T Hb4_13 = T(0.2) * Mb4_33 - T(0.1) * Mb4_23;
  const T Hb4_21 = T(0.1) * Mb4_11 - T(0.3) * Mb4_13;
  const T b4_14 = T(0.3) * Mb4_23;
  const T Hb4_22 = b4_13 - b4_14;
  const T Hb4_23 = T(0.1) * Mb4_13 - T(0.3) * Mb4_33;
  const T Hb4_31 = T(0.3) * Mb4_12 - T(0.2) * Mb4_11;
  const T Hb4_32 = T(0.3) * Mb4_22 - T(0.2) * Mb4_12;
  const T Hb4_33 = b4_14 - b4_12;

  // ---- body 3 (body_3) and what it carries
  // HA3 = h_all_3~ + Hb4: moment for an acceleration of the origin, body axes [kg m]
  const T HA3_12 = Hb4_12 - T(0.065);
  const T HA3_13 = T(0.26) + Hb4_13;
  const T HA3_21 = T(0.065) + Hb4_21;
  const T HA3_23 = Hb4_23 - T(0.13);
  const T HA3_31 = Hb4_31 - T(0.26);
  const T HA3_32 = T(0.13) + Hb4_32;
  // JA3 = J_all_3 - Hb4 q4~: moment for an angular acceleration, body axes [kg m^2]
  const T JA3_11 = T(0.18525000000000003) + Hb4_13 * T(0.2) - Hb4_12 * T(0.1);
  const T minus_JA3_12 = T(0.019500000000000003) + Hb4_13 * T(0.3) - Hb4_11 * T(0.1);
  const T minus_JA3_13 = T(0.002600000000000001) + Hb4_11 * T(0.2) - Hb4_12 * T(0.3);
  const T JA3_22 = T(0.17225000000000001) + Hb4_21 * T(0.1) - Hb4_23 * T(0.3);
  const T minus_JA3_23 = T(0.0182) + Hb4_21 * T(0.2) - Hb4_22 * T(0.3);
  const T JA3_33 = T(0.169) + Hb4_32 * T(0.3) - Hb4_31 * T(0.2);
  // g3 = C4^T gb4 + G3: force that drives it, home axes [N]
  const T b3_1 = C4_11 * minus_gb4_1 + C4_21 * minus_gb4_2 + C4_31 * minus_gb4_3;
  const T minus_g3_1 = b3_1 + minus_G3_1;
  const T b3_2 = C4_12 * minus_gb4_1 + C4_22 * minus_gb4_2 + C4_32 * minus_gb4_3;
  const T minus_g3_2 = b3_2 + minus_G3_2;
  const T b3_3 = C4_13 * minus_gb4_1 + C4_23 * minus_gb4_2 + C4_33 * minus_gb4_3;
  const T minus_g3_3 = b3_3 + minus_G3_3;
  // n3 = q4~ C4^T gb4 + N3: moment that drives it, body axes [N m]
  const T n3_1 = N3_1 + T(0.1) * b3_2 - T(0.2) * b3_3;
  const T n3_2 = N3_2 + T(0.3) * b3_3 - T(0.1) * b3_1;
  const T n3_3 = N3_3 + T(0.2) * b3_1 - T(0.3) * b3_2;
  // LD3 = L D L^T of JA3: L D L^T = JA: L, and 1/D on the diagonal
  const T LD3_11 = T(1) / JA3_11;
  const T minus_LD3_21 = LD3_11 * minus_JA3_12;
  const T LD3_22 = T(1) / (JA3_22 - minus_LD3_21 * minus_JA3_12);
  const T minus_LD3_31 = LD3_11 * minus_JA3_13;
  const T b3_4 = minus_JA3_23 + minus_LD3_21 * minus_JA3_13;
  const T minus_LD3_32 = LD3_22 * b3_4;
  const T LD3_33 = T(1) / (JA3_33 - minus_LD3_31 * minus_JA3_13 - minus_LD3_32 * b3_4);
  // Y3 = L(LD3)^-1 HA3: L^-1 HA
  const T Y3_21 = HA3_21 + minus_LD3_21 * Hb4_11;
  const T Y3_22 = Hb4_22 + minus_LD3_21 * HA3_12;
  const T Y3_23 = HA3_23 + minus_LD3_21 * HA3_13;
  const T Y3_31 = HA3_31 + minus_LD3_31 * Hb4_11 + minus_LD3_32 * Y3_21;
  const T Y3_32 = HA3_32 + minus_LD3_31 * HA3_12 + minus_LD3_32 * Y3_22;
  const T Y3_33 = Hb4_33 + minus_LD3_31 * HA3_13 + minus_LD3_32 * Y3_23;
  // W3 = D(LD3)^-1 Y3: D^-1 L^-1 HA
  const T W3_11 = LD3_11 * Hb4_11;
  const T W3_12 = LD3_11 * HA3_12;
  const T W3_13 = LD3_11 * HA3_13;
  const T W3_21 = LD3_22 * Y3_21;
  const T W3_22 = LD3_22 * Y3_22;
  const T W3_23 = LD3_22 * Y3_23;
  const T W3_31 = LD3_33 * Y3_31;
  const T W3_32 = LD3_33 * Y3_32;
  const T W3_33 = LD3_33 * Y3_33;
  // w_3 = D(LD3)^-1 L(LD3)^-1 n3: D^-1 L^-1 n
  const T w_3_1 = LD3_11 * n3_1;
  const T b3_5 = n3_2 + minus_LD3_21 * n3_1;
  const T w_3_2 = LD3_22 * b3_5;
  const T w_3_3 = LD3_33 * (n3_3 + minus_LD3_31 * n3_1 + minus_LD3_32 * b3_5);
  // M3 = Mb4 - Y3^T W3: MA less what the ball takes up [kg]
  const T M3_11 = Mb4_11 - Hb4_11 * W3_11 - Y3_21 * W3_21 - Y3_31 * W3_31;
  const T M3_12 = Mb4_12 - Hb4_11 * W3_12 - Y3_21 * W3_22 - Y3_31 * W3_32;
  const T M3_13 = Mb4_13 - Hb4_11 * W3_13 - Y3_21 * W3_23 - Y3_31 * W3_33;
  const T M3_22 = Mb4_22 - HA3_12 * W3_12 - Y3_22 * W3_22 - Y3_32 * W3_32;
  const T M3_23 = Mb4_23 - HA3_12 * W3_13 - Y3_22 * W3_23 - Y3_32 * W3_33;
  const T M3_33 = Mb4_33 - HA3_13 * W3_13 - Y3_23 * W3_23 - Y3_33 * W3_33;
  // gb3 = g3 - Y3^T w_3: force with the ball solved [N]
  const T minus_gb3_1 = minus_g3_1 + Hb4_11 * w_3_1 + Y3_21 * w_3_2 + Y3_31 * w_3_3;
  const T minus_gb3_2 = minus_g3_2 + HA3_12 * w_3_1 + Y3_22 * w_3_2 + Y3_32 * w_3_3;
  const T minus_gb3_3 = minus_g3_3 + HA3_13 * w_3_1 + Y3_23 * w_3_2 + Y3_33 * w_3_3;
  // Mb3 = C3^T M3 C3: M of the joint, lower body's axes
  const T b3_6 = C3_11 * M3_11 + C3_21 * M3_12 + C3_31 * M3_13;
  const T b3_7 = C3_11 * M3_12 + C3_21 * M3_22 + C3_31 * M3_23;
  const T b3_8 = C3_11 * M3_13 + C3_21 * M3_23 + C3_31 * M3_33;
  const T Mb3_11 = b3_6 * C3_11 + b3_7 * C3_21 + b3_8 * C3_31;
  const T Mb3_12 = b3_6 * C3_12 + b3_7 * C3_22 + b3_8 * C3_32;
  const T Mb3_13 = b3_6 * C3_13 + b3_7 * C3_23 + b3_8 * C3_33;
  const T b3_9 = C3_12 * M3_11 + C3_22 * M3_12 + C3_32 * M3_13;
  const T b3_10 = C3_12 * M3_12 + C3_22 * M3_22 + C3_32 * M3_23;
  const T b3_11 = C3_12 * M3_13 + C3_22 * M3_23 + C3_32 * M3_33;
  const T Mb3_22 = b3_9 * C3_12 + b3_10 * C3_22 + b3_11 * C3_32;
  const T Mb3_23 = b3_9 * C3_13 + b3_10 * C3_23 + b3_11 * C3_33;
  const T Mb3_33 = M3_11 + M3_22 + M3_33 - Mb3_11 - Mb3_22;
  // Hb3 = q3~ Mb3: H of the joint at the lower body's origin, its axes
  const T b3_12 = T(0.15) * Mb3_13;
  const T b3_13 = T(0.1) * Mb3_12;
  const T Hb3_11 = b3_12 - b3_13;
  const T Hb3_12 = T(0.15) * Mb3_23 - T(0.1) * Mb3_22;
  const T Hb3_13 = T(0.15) * Mb3_33 - T(0.1) * Mb3_23;
  const T Hb3_21 = T(0.1) * Mb3_11 - T(0.3) * Mb3_13;
  const T b3_14 = T(0.3) * Mb3_23;
  const T Hb3_22 = b3_13 - b3_14;
  const T Hb3_23 = T(0.1) * Mb3_13 - T(0.3) * Mb3_33;
  const T Hb3_31 = T(0.3) * Mb3_12 - T(0.15) * Mb3_11;
  const T Hb3_32 = T(0.3) * Mb3_22 - T(0.15) * Mb3_12;
  const T Hb3_33 = b3_14 - b3_12;

  // ---- body 2 (body_2) and what it carries
  // HA2 = h_all_2~ + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA2_12 = Hb3_12 - T(0.19);
  const T HA2_13 = T(0.435) + Hb3_13;
  const T HA2_21 = T(0.19) + Hb3_21;
  const T HA2_23 = Hb3_23 - T(0.51);
  const T HA2_31 = Hb3_31 - T(0.435);
  const T HA2_32 = T(0.51) + Hb3_32;
  // JA2 = J_all_2 - Hb3 q3~: moment for an angular acceleration, body axes [kg m^2]
  const T JA2_11 = T(0.21325) + Hb3_13 * T(0.15) - Hb3_12 * T(0.1);
  const T minus_JA2_12 = T(0.0765) + Hb3_13 * T(0.3) - Hb3_11 * T(0.1);
  const T minus_JA2_13 = T(0.0414) + Hb3_11 * T(0.15) - Hb3_12 * T(0.3);
  const T JA2_22 = T(0.289) + Hb3_21 * T(0.1) - Hb3_23 * T(0.3);
  const T minus_JA2_23 = T(0.0363) + Hb3_21 * T(0.15) - Hb3_22 * T(0.3);
  const T JA2_33 = T(0.30225) + Hb3_32 * T(0.3) - Hb3_31 * T(0.15);
  // g2 = C3^T gb3 + G2: force that drives it, home axes [N]
  const T b2_1 = C3_11 * minus_gb3_1 + C3_21 * minus_gb3_2 + C3_31 * minus_gb3_3;
  const T minus_g2_1 = b2_1 + minus_G2_1;
  const T b2_2 = C3_12 * minus_gb3_1 + C3_22 * minus_gb3_2 + C3_32 * minus_gb3_3;
  const T minus_g2_2 = b2_2 + minus_G2_2;
  const T b2_3 = C3_13 * minus_gb3_1 + C3_23 * minus_gb3_2 + C3_33 * minus_gb3_3;
  const T minus_g2_3 = b2_3 + minus_G2_3;
  // n2 = q3~ C3^T gb3 + N2: moment that drives it, body axes [N m]
  const T n2_1 = N2_1 + T(0.1) * b2_2 - T(0.15) * b2_3;
  const T n2_2 = N2_2 + T(0.3) * b2_3 - T(0.1) * b2_1;
  const T n2_3 = N2_3 + T(0.15) * b2_1 - T(0.3) * b2_2;
  // LD2 = L D L^T of JA2: L D L^T = JA: L, and 1/D on the diagonal
  const T LD2_11 = T(1) / JA2_11;
  const T minus_LD2_21 = LD2_11 * minus_JA2_12;
  const T LD2_22 = T(1) / (JA2_22 - minus_LD2_21 * minus_JA2_12);
  const T minus_LD2_31 = LD2_11 * minus_JA2_13;
  const T b2_4 = minus_JA2_23 + minus_LD2_21 * minus_JA2_13;
  const T minus_LD2_32 = LD2_22 * b2_4;
  const T LD2_33 = T(1) / (JA2_33 - minus_LD2_31 * minus_JA2_13 - minus_LD2_32 * b2_4);
  // Y2 = L(LD2)^-1 HA2: L^-1 HA
  const T Y2_21 = HA2_21 + minus_LD2_21 * Hb3_11;
  const T Y2_22 = Hb3_22 + minus_LD2_21 * HA2_12;
  const T Y2_23 = HA2_23 + minus_LD2_21 * HA2_13;
  const T Y2_31 = HA2_31 + minus_LD2_31 * Hb3_11 + minus_LD2_32 * Y2_21;
  const T Y2_32 = HA2_32 + minus_LD2_31 * HA2_12 + minus_LD2_32 * Y2_22;
  const T Y2_33 = Hb3_33 + minus_LD2_31 * HA2_13 + minus_LD2_32 * Y2_23;
  // W2 = D(LD2)^-1 Y2: D^-1 L^-1 HA
  const T W2_11 = LD2_11 * Hb3_11;
  const T W2_12 = LD2_11 * HA2_12;
  const T W2_13 = LD2_11 * HA2_13;
  const T W2_21 = LD2_22 * Y2_21;
  const T W2_22 = LD2_22 * Y2_22;
  const T W2_23 = LD2_22 * Y2_23;
  const T W2_31 = LD2_33 * Y2_31;
  const T W2_32 = LD2_33 * Y2_32;
  const T W2_33 = LD2_33 * Y2_33;
  // w_2 = D(LD2)^-1 L(LD2)^-1 n2: D^-1 L^-1 n
  const T w_2_1 = LD2_11 * n2_1;
  const T b2_5 = n2_2 + minus_LD2_21 * n2_1;
  const T w_2_2 = LD2_22 * b2_5;
  const T w_2_3 = LD2_33 * (n2_3 + minus_LD2_31 * n2_1 + minus_LD2_32 * b2_5);
  // M2 = Mb3 - Y2^T W2: MA less what the ball takes up [kg]
  const T M2_11 = Mb3_11 - Hb3_11 * W2_11 - Y2_21 * W2_21 - Y2_31 * W2_31;
  const T M2_12 = Mb3_12 - Hb3_11 * W2_12 - Y2_21 * W2_22 - Y2_31 * W2_32;
  const T M2_13 = Mb3_13 - Hb3_11 * W2_13 - Y2_21 * W2_23 - Y2_31 * W2_33;
  const T M2_22 = Mb3_22 - HA2_12 * W2_12 - Y2_22 * W2_22 - Y2_32 * W2_32;
  const T M2_23 = Mb3_23 - HA2_12 * W2_13 - Y2_22 * W2_23 - Y2_32 * W2_33;
  const T M2_33 = Mb3_33 - HA2_13 * W2_13 - Y2_23 * W2_23 - Y2_33 * W2_33;
  // gb2 = g2 - Y2^T w_2: force with the ball solved [N]
  const T minus_gb2_1 = minus_g2_1 + Hb3_11 * w_2_1 + Y2_21 * w_2_2 + Y2_31 * w_2_3;
  const T minus_gb2_2 = minus_g2_2 + HA2_12 * w_2_1 + Y2_22 * w_2_2 + Y2_32 * w_2_3;
  const T minus_gb2_3 = minus_g2_3 + HA2_13 * w_2_1 + Y2_23 * w_2_2 + Y2_33 * w_2_3;
  // Mb2 = C2^T M2 C2: M of the joint, lower body's axes
  const T b2_6 = C2_11 * M2_11 + C2_21 * M2_12 + C2_31 * M2_13;
  const T b2_7 = C2_11 * M2_12 + C2_21 * M2_22 + C2_31 * M2_23;
  const T b2_8 = C2_11 * M2_13 + C2_21 * M2_23 + C2_31 * M2_33;
  const T Mb2_11 = b2_6 * C2_11 + b2_7 * C2_21 + b2_8 * C2_31;
  const T Mb2_12 = b2_6 * C2_12 + b2_7 * C2_22 + b2_8 * C2_32;
  const T Mb2_13 = b2_6 * C2_13 + b2_7 * C2_23 + b2_8 * C2_33;
  const T b2_9 = C2_12 * M2_11 + C2_22 * M2_12 + C2_32 * M2_13;
  const T b2_10 = C2_12 * M2_12 + C2_22 * M2_22 + C2_32 * M2_23;
  const T b2_11 = C2_12 * M2_13 + C2_22 * M2_23 + C2_32 * M2_33;
  const T Mb2_22 = b2_9 * C2_12 + b2_10 * C2_22 + b2_11 * C2_32;
  const T Mb2_23 = b2_9 * C2_13 + b2_10 * C2_23 + b2_11 * C2_33;
  const T Mb2_33 = M2_11 + M2_22 + M2_33 - Mb2_11 - Mb2_22;
  // Hb2 = q2~ Mb2: H of the joint at the lower body's origin, its axes
  const T b2_12 = T(0.1) * Mb2_13;
  const T b2_13 = T(0.1) * Mb2_12;
  const T Hb2_11 = b2_12 - b2_13;
  const T b2_14 = T(0.1) * Mb2_23;
  const T Hb2_12 = b2_14 - T(0.1) * Mb2_22;
  const T Hb2_13 = T(0.1) * Mb2_33 - b2_14;
  const T b2_15 = T(0.1) * Mb2_11;
  const T Hb2_21 = b2_15 - T(0.3) * Mb2_13;
  const T Hb2_22 = b2_13 - T(0.3) * Mb2_23;
  const T Hb2_23 = b2_12 - T(0.3) * Mb2_33;
  const T Hb2_31 = T(0.3) * Mb2_12 - b2_15;
  const T Hb2_32 = T(0.3) * Mb2_22 - b2_13;

  // ---- body 1 (body_1) and what it carries
  // JA1 = J_all_1 - Hb2 q2~: moment for an angular acceleration, body axes [kg m^2]
  const T JA1_11 = T(0.20675000000000002) + Hb2_13 * T(0.1) - Hb2_12 * T(0.1);
  const T b1_1 = Hb2_11 * T(0.1);
  const T minus_JA1_12 = T(0.09150000000000001) - b1_1 + Hb2_13 * T(0.3);
  const T minus_JA1_13 = T(0.0772) + b1_1 - Hb2_12 * T(0.3);
  const T b1_2 = Hb2_21 * T(0.1);
  const T JA1_22 = b1_2 + T(0.39575) - Hb2_23 * T(0.3);
  const T minus_JA1_23 = T(0.040400000000000005) + b1_2 - Hb2_22 * T(0.3);
  const T JA1_33 = T(0.393) + Hb2_32 * T(0.3) - Hb2_31 * T(0.1);
  // n1 = q2~ C2^T gb2 + N1: moment that drives it, body axes [N m]
  const T b1_3 = C2_12 * minus_gb2_1 + C2_22 * minus_gb2_2 + C2_32 * minus_gb2_3;
  const T b1_4 = C2_13 * minus_gb2_1 + C2_23 * minus_gb2_2 + C2_33 * minus_gb2_3;
  const T n1_1 = N1_1 + T(0.1) * b1_3 - T(0.1) * b1_4;
  const T b1_5 = T(0.1) * (C2_11 * minus_gb2_1 + C2_21 * minus_gb2_2 + C2_31 * minus_gb2_3);
  const T n1_2 = N1_2 - b1_5 + T(0.3) * b1_4;
  const T n1_3 = b1_5 + N1_3 - T(0.3) * b1_3;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T minus_LD1_21 = LD1_11 * minus_JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - minus_LD1_21 * minus_JA1_12);
  const T minus_LD1_31 = LD1_11 * minus_JA1_13;
  const T b1_6 = minus_JA1_23 + minus_LD1_21 * minus_JA1_13;
  const T minus_LD1_32 = LD1_22 * b1_6;
  const T LD1_33 = T(1) / (JA1_33 - minus_LD1_31 * minus_JA1_13 - minus_LD1_32 * b1_6);
  // w_1 = D(LD1)^-1 L(LD1)^-1 n1: D^-1 L^-1 n
  const T w_1_1 = LD1_11 * n1_1;
  const T b1_7 = n1_2 + minus_LD1_21 * n1_1;
  const T w_1_2 = LD1_22 * b1_7;
  const T w_1_3 = LD1_33 * (n1_3 + minus_LD1_31 * n1_1 + minus_LD1_32 * b1_7);
  ydot[2] = w_1_3;

  // ---- body 1 (body_1), solved
  // omegadot1 = L(LD1)^-T w_1
  const T z1_1 = w_1_2 + minus_LD1_32 * w_1_3;
  const T omegadot1_1 = w_1_1 + minus_LD1_21 * z1_1 + minus_LD1_31 * w_1_3;
  ydot[0] = omegadot1_1;
  ydot[1] = z1_1;

  // ---- body 2 (body_2), solved
  // beta2 = -C2 q2~ omegadot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z2_1 = T(0.1) * w_1_3 - T(0.1) * z1_1;
  const T z2_2 = T(0.1) * omegadot1_1;
  const T z2_3 = z2_2 - T(0.3) * w_1_3;
  const T z2_4 = T(0.3) * z1_1 - z2_2;
  const T minus_beta2_1 = C2_11 * z2_1 + C2_12 * z2_3 + C2_13 * z2_4;
  const T minus_beta2_2 = C2_21 * z2_1 + C2_22 * z2_3 + C2_23 * z2_4;
  const T minus_beta2_3 = C2_31 * z2_1 + C2_32 * z2_3 + C2_33 * z2_4;
  // omegadot2 = L(LD2)^-T (-W2 beta2 + w_2)
  const T z2_5 = w_2_3 + W2_31 * minus_beta2_1 + W2_32 * minus_beta2_2 + W2_33 * minus_beta2_3;
  const T z2_6 = w_2_2 + W2_21 * minus_beta2_1 + W2_22 * minus_beta2_2 + W2_23 * minus_beta2_3 + minus_LD2_32 * z2_5;
  const T omegadot2_1 = w_2_1 + W2_11 * minus_beta2_1 + W2_12 * minus_beta2_2 + W2_13 * minus_beta2_3 + minus_LD2_21 *
      z2_6 + minus_LD2_31 * z2_5;
  ydot[3] = omegadot2_1;
  ydot[4] = z2_6;
  ydot[5] = z2_5;

  // ---- body 3 (body_3), solved
  // beta3 = -C3 q3~ omegadot2 + C3 beta2: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z3_1 = T(0.15) * z2_5 - T(0.1) * z2_6;
  const T z3_2 = T(0.1) * omegadot2_1 - T(0.3) * z2_5;
  const T z3_3 = T(0.3) * z2_6 - T(0.15) * omegadot2_1;
  const T minus_beta3_1 = C3_11 * z3_1 + C3_12 * z3_2 + C3_13 * z3_3 + C3_11 * minus_beta2_1 + C3_12 * minus_beta2_2 +
      C3_13 * minus_beta2_3;
  const T minus_beta3_2 = C3_21 * z3_1 + C3_22 * z3_2 + C3_23 * z3_3 + C3_21 * minus_beta2_1 + C3_22 * minus_beta2_2 +
      C3_23 * minus_beta2_3;
  const T minus_beta3_3 = C3_31 * z3_1 + C3_32 * z3_2 + C3_33 * z3_3 + C3_31 * minus_beta2_1 + C3_32 * minus_beta2_2 +
      C3_33 * minus_beta2_3;
  // omegadot3 = L(LD3)^-T (-W3 beta3 + w_3)
  const T z3_4 = w_3_3 + W3_31 * minus_beta3_1 + W3_32 * minus_beta3_2 + W3_33 * minus_beta3_3;
  const T z3_5 = w_3_2 + W3_21 * minus_beta3_1 + W3_22 * minus_beta3_2 + W3_23 * minus_beta3_3 + minus_LD3_32 * z3_4;
  const T omegadot3_1 = w_3_1 + W3_11 * minus_beta3_1 + W3_12 * minus_beta3_2 + W3_13 * minus_beta3_3 + minus_LD3_21 *
      z3_5 + minus_LD3_31 * z3_4;
  ydot[6] = omegadot3_1;
  ydot[7] = z3_5;
  ydot[8] = z3_4;

  // ---- body 4 (body_4), solved
  // beta4 = -C4 q4~ omegadot3 + C4 beta3: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z4_1 = T(0.2) * z3_4 - T(0.1) * z3_5;
  const T z4_2 = T(0.1) * omegadot3_1 - T(0.3) * z3_4;
  const T z4_3 = T(0.3) * z3_5 - T(0.2) * omegadot3_1;
  const T minus_beta4_1 = C4_11 * z4_1 + C4_12 * z4_2 + C4_13 * z4_3 + C4_11 * minus_beta3_1 + C4_12 * minus_beta3_2 +
      C4_13 * minus_beta3_3;
  const T minus_beta4_2 = C4_21 * z4_1 + C4_22 * z4_2 + C4_23 * z4_3 + C4_21 * minus_beta3_1 + C4_22 * minus_beta3_2 +
      C4_23 * minus_beta3_3;
  const T minus_beta4_3 = C4_31 * z4_1 + C4_32 * z4_2 + C4_33 * z4_3 + C4_31 * minus_beta3_1 + C4_32 * minus_beta3_2 +
      C4_33 * minus_beta3_3;
  // omegadot4 = L(LD4)^-T (-W4 beta4 + w_4)
  const T z4_4 = w_4_3 + W4_31 * minus_beta4_1 + W4_32 * minus_beta4_2 + W4_33 * minus_beta4_3;
  const T z4_5 = w_4_2 + W4_21 * minus_beta4_1 + W4_22 * minus_beta4_2 + W4_23 * minus_beta4_3 + minus_LD4_32 * z4_4;
  const T omegadot4_1 = w_4_1 + W4_11 * minus_beta4_1 + W4_12 * minus_beta4_2 + W4_13 * minus_beta4_3 + minus_LD4_21 *
      z4_5 + minus_LD4_31 * z4_4;
  ydot[9] = omegadot4_1;
  ydot[10] = z4_5;
  ydot[11] = z4_4;

  // ---- body 5 (body_5), solved
  // beta5 = -C5 q5~ omegadot4 + C5 beta4: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z5_1 = T(0.25) * z4_4 - T(0.1) * z4_5;
  const T z5_2 = T(0.1) * omegadot4_1 - T(0.3) * z4_4;
  const T z5_3 = T(0.3) * z4_5 - T(0.25) * omegadot4_1;
  const T minus_beta5_1 = C5_11 * z5_1 + C5_12 * z5_2 + C5_13 * z5_3 + C5_11 * minus_beta4_1 + C5_12 * minus_beta4_2 +
      C5_13 * minus_beta4_3;
  const T minus_beta5_2 = C5_21 * z5_1 + C5_22 * z5_2 + C5_23 * z5_3 + C5_21 * minus_beta4_1 + C5_22 * minus_beta4_2 +
      C5_23 * minus_beta4_3;
  const T minus_beta5_3 = C5_31 * z5_1 + C5_32 * z5_2 + C5_33 * z5_3 + C5_31 * minus_beta4_1 + C5_32 * minus_beta4_2 +
      C5_33 * minus_beta4_3;
  // omegadot5 = L(LD5)^-T (-W5 beta5 + w_5)
  const T z5_4 = w_5_3 + W5_31 * minus_beta5_1 + W5_32 * minus_beta5_2 + W5_33 * minus_beta5_3;
  const T z5_5 = w_5_2 + W5_21 * minus_beta5_1 + W5_22 * minus_beta5_2 - minus_W5_23 * minus_beta5_3 + minus_LD5_32 *
      z5_4;
  const T omegadot5_1 = w_5_1 + W5_11 * minus_beta5_1 + W5_12 * minus_beta5_2 + W5_13 * minus_beta5_3 + minus_LD5_21 *
      z5_5 + minus_LD5_31 * z5_4;
  ydot[12] = omegadot5_1;
  ydot[13] = z5_5;
  ydot[14] = z5_4;

  // ---- body 6 (body_6), solved
  // beta6 = -C6 q6~ omegadot5 + C6 beta5: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z6_1 = T(0.3) * z5_4;
  const T z6_2 = z6_1 - T(0.1) * z5_5;
  const T z6_3 = T(0.1) * omegadot5_1 - z6_1;
  const T z6_4 = T(0.3) * z5_5 - T(0.3) * omegadot5_1;
  const T minus_beta6_1 = C6_11 * z6_2 + C6_12 * z6_3 + C6_13 * z6_4 + C6_11 * minus_beta5_1 + C6_12 * minus_beta5_2 +
      C6_13 * minus_beta5_3;
  const T minus_beta6_2 = C6_21 * z6_2 + C6_22 * z6_3 + C6_23 * z6_4 + C6_21 * minus_beta5_1 + C6_22 * minus_beta5_2 +
      C6_23 * minus_beta5_3;
  const T minus_beta6_3 = C6_31 * z6_2 + C6_32 * z6_3 + C6_33 * z6_4 + C6_31 * minus_beta5_1 + C6_32 * minus_beta5_2 +
      C6_33 * minus_beta5_3;
  // omegadot6 = L(LD6)^-T (-W6 beta6 + w_6)
  const T z6_5 = w_6_3 + T(0.7687251214257022) * minus_beta6_2 - T(1.5150171378488217) * minus_beta6_1 -
      T(0.044866210005164824) * minus_beta6_3;
  const T z6_6 = w_6_2 + T(0.3819095477386935) * minus_beta6_1 - T(0.040201005025125636) * minus_beta6_2 -
      T(0.6030150753768845) * minus_beta6_3 + T(0.1085427135678392) * z6_5;
  const T omegadot6_1 = w_6_1 + T(1.4035087719298247) * minus_beta6_3 - T(0.3508771929824562) * minus_beta6_2 +
      T(0.10526315789473686) * z6_6 + T(0.014035087719298253) * z6_5;
  ydot[15] = omegadot6_1;
  ydot[16] = z6_6;
  ydot[17] = z6_5;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 539 add, 566 multiply
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r)
    noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_2;
  const T R1_13 = t1_1 * eps1_3 - t1_2 * eps1_4;
  const T R1_23 = t1_2 * eps1_3 + t1_1 * eps1_4;
  const T R1_33 = T(1) - t1_1 * eps1_1 - t1_2 * eps1_2;
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t1_3 = omega1_3 * omega1_3;
  const T t1_4 = omega1_2 * omega1_2;
  const T minus_U1_11 = t1_3 + t1_4;
  const T t1_5 = omega1_2 * omega1_1;
  const T U1_12 = t1_5 - omegadot1_3;
  const T t1_6 = omega1_3 * omega1_1;
  const T U1_13 = t1_6 + omegadot1_2;
  const T U1_21 = t1_5 + omegadot1_3;
  const T t1_7 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_3 + t1_7;
  const T t1_8 = omega1_3 * omega1_2;
  const T U1_23 = t1_8 - omegadot1_1;
  const T U1_31 = t1_6 - omegadot1_2;
  const T U1_32 = t1_8 + omegadot1_1;
  const T minus_U1_33 = t1_4 + t1_7;
  // Pddot1 = -R1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1 = R1_13 * T(9.81);
  const T Pddot1_2 = R1_23 * T(9.81);
  const T Pddot1_3 = R1_33 * T(9.81);

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T omegadot2_1 = ydot[3], omegadot2_2 = ydot[4], omegadot2_3 = ydot[5];
  // erel2 = -e1~ e2 + eps4_1 e2 - eps4_2 e1: Euler parameters relative to the lower body
  const T erel2_1 = eps1_3 * eps2_2 - eps1_2 * eps2_3 + eps1_4 * eps2_1 - eps2_4 * eps1_1;
  const T erel2_2 = eps1_1 * eps2_3 - eps1_3 * eps2_1 + eps1_4 * eps2_2 - eps2_4 * eps1_2;
  const T erel2_3 = eps1_2 * eps2_1 - eps1_1 * eps2_2 + eps1_4 * eps2_3 - eps2_4 * eps1_3;
  // eps4rel2 = e1 . e2 + eps4_1 eps4_2
  const T eps4rel2 = eps1_1 * eps2_1 + eps1_2 * eps2_2 + eps1_3 * eps2_3 + eps1_4 * eps2_4;
  // C2^T = 1 + 2 erel2~ (eps4rel2 + erel2~): C takes components in the lower body to those in the body
  const T t2_1 = T(2) * erel2_2;
  const T t2_2 = t2_1 * erel2_2;
  const T t2_3 = T(2) * erel2_3;
  const T t2_4 = t2_3 * erel2_3;
  const T C2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * erel2_1;
  const T t2_6 = t2_5 * erel2_2;
  const T t2_7 = t2_3 * eps4rel2;
  const T C2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * erel2_3;
  const T t2_9 = t2_1 * eps4rel2;
  const T C2_13 = t2_8 - t2_9;
  const T C2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * erel2_1;
  const T C2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * erel2_3;
  const T t2_12 = t2_5 * eps4rel2;
  const T C2_23 = t2_11 + t2_12;
  const T C2_31 = t2_8 + t2_9;
  const T C2_32 = t2_11 - t2_12;
  const T C2_33 = t2_10 - t2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_13 = omega2_3 * omega2_3;
  const T t2_14 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_13 + t2_14;
  const T t2_15 = omega2_2 * omega2_1;
  const T U2_12 = t2_15 - omegadot2_3;
  const T t2_16 = omega2_3 * omega2_1;
  const T U2_13 = t2_16 + omegadot2_2;
  const T U2_21 = t2_15 + omegadot2_3;
  const T t2_17 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_13 + t2_17;
  const T t2_18 = omega2_3 * omega2_2;
  const T U2_23 = t2_18 - omegadot2_1;
  const T U2_31 = t2_16 - omegadot2_2;
  const T U2_32 = t2_18 + omegadot2_1;
  const T minus_U2_33 = t2_14 + t2_17;
  // Pddot2 = C2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_19 = Pddot1_1 + U1_12 * T(0.1) - minus_U1_11 * T(0.3) + U1_13 * T(0.1);
  const T t2_20 = Pddot1_2 + U1_21 * T(0.3) - minus_U1_22 * T(0.1) + U1_23 * T(0.1);
  const T t2_21 = Pddot1_3 + U1_31 * T(0.3) + U1_32 * T(0.1) - minus_U1_33 * T(0.1);
  const T Pddot2_1 = C2_11 * t2_19 + C2_12 * t2_20 + C2_13 * t2_21;
  const T Pddot2_2 = C2_21 * t2_19 + C2_22 * t2_20 + C2_23 * t2_21;
  const T Pddot2_3 = C2_31 * t2_19 + C2_32 * t2_20 + C2_33 * t2_21;
  // N1 = C2^T M_torque_2_ + h_all_1~ Pddot1 + axial(U1 (tr(J_all_1)/2 - J_all_1)) - M_torque_1_: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N1_1 = C2_11 * u.tau_2_1 - u.tau_1_1 + C2_21 * u.tau_2_2 + C2_31 * u.tau_2_3 + T(0.92) * Pddot1_3 - T(0.755)
      * Pddot1_2 + T(0.14700000000000002) * U1_32 - T(0.14975000000000002) * U1_23 + T(0.0854) * (minus_U1_22 -
      minus_U1_33) + T(0.2265) * U1_31 - T(0.2122) * U1_21;
  const T N1_2 = C2_12 * u.tau_2_1 - u.tau_1_2 + C2_22 * u.tau_2_2 + C2_32 * u.tau_2_3 + T(0.755) * Pddot1_1 - T(2.21)
      * Pddot1_3 + T(0.14975000000000002) * U1_13 - T(0.696) * U1_31 + T(0.2122) * (minus_U1_33 - minus_U1_11) +
      T(0.0854) * U1_12 - T(0.2265) * U1_32;
  const T N1_3 = C2_13 * u.tau_2_1 - u.tau_1_3 + C2_23 * u.tau_2_2 + C2_33 * u.tau_2_3 + T(2.21) * Pddot1_2 - T(0.92)
      * Pddot1_1 + T(0.696) * U1_21 - T(0.14700000000000002) * U1_12 + T(0.2265) * (minus_U1_11 - minus_U1_22) +
      T(0.2122) * U1_23 - T(0.0854) * U1_13;
  // G2 = U2 h_all_2: inertia less applied force, body axes [N]
  const T G2_1 = U2_12 * T(1.1099999999999999) - minus_U2_11 * T(1.8599999999999999) + U2_13 * T(0.64);
  const T G2_2 = U2_21 * T(1.8599999999999999) - minus_U2_22 * T(1.1099999999999999) + U2_23 * T(0.64);
  const T G2_3 = U2_31 * T(1.8599999999999999) + U2_32 * T(1.1099999999999999) - minus_U2_33 * T(0.64);

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T omegadot3_1 = ydot[6], omegadot3_2 = ydot[7], omegadot3_3 = ydot[8];
  // erel3 = -e2~ e3 + eps4_2 e3 - eps4_3 e2: Euler parameters relative to the lower body
  const T erel3_1 = eps2_3 * eps3_2 - eps2_2 * eps3_3 + eps2_4 * eps3_1 - eps3_4 * eps2_1;
  const T erel3_2 = eps2_1 * eps3_3 - eps2_3 * eps3_1 + eps2_4 * eps3_2 - eps3_4 * eps2_2;
  const T erel3_3 = eps2_2 * eps3_1 - eps2_1 * eps3_2 + eps2_4 * eps3_3 - eps3_4 * eps2_3;
  // eps4rel3 = e2 . e3 + eps4_2 eps4_3
  const T eps4rel3 = eps2_1 * eps3_1 + eps2_2 * eps3_2 + eps2_3 * eps3_3 + eps2_4 * eps3_4;
  // C3^T = 1 + 2 erel3~ (eps4rel3 + erel3~): C takes components in the lower body to those in the body
  const T t3_1 = T(2) * erel3_2;
  const T t3_2 = t3_1 * erel3_2;
  const T t3_3 = T(2) * erel3_3;
  const T t3_4 = t3_3 * erel3_3;
  const T C3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * erel3_1;
  const T t3_6 = t3_5 * erel3_2;
  const T t3_7 = t3_3 * eps4rel3;
  const T C3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * erel3_3;
  const T t3_9 = t3_1 * eps4rel3;
  const T C3_13 = t3_8 - t3_9;
  const T C3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * erel3_1;
  const T C3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * erel3_3;
  const T t3_12 = t3_5 * eps4rel3;
  const T C3_23 = t3_11 + t3_12;
  const T C3_31 = t3_8 + t3_9;
  const T C3_32 = t3_11 - t3_12;
  const T C3_33 = t3_10 - t3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_13 = omega3_3 * omega3_3;
  const T t3_14 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_13 + t3_14;
  const T t3_15 = omega3_2 * omega3_1;
  const T U3_12 = t3_15 - omegadot3_3;
  const T t3_16 = omega3_3 * omega3_1;
  const T U3_13 = t3_16 + omegadot3_2;
  const T U3_21 = t3_15 + omegadot3_3;
  const T t3_17 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_13 + t3_17;
  const T t3_18 = omega3_3 * omega3_2;
  const T U3_23 = t3_18 - omegadot3_1;
  const T U3_31 = t3_16 - omegadot3_2;
  const T U3_32 = t3_18 + omegadot3_1;
  const T minus_U3_33 = t3_14 + t3_17;
  // Pddot3 = C3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_19 = Pddot2_1 + U2_12 * T(0.15) - minus_U2_11 * T(0.3) + U2_13 * T(0.1);
  const T t3_20 = Pddot2_2 + U2_21 * T(0.3) - minus_U2_22 * T(0.15) + U2_23 * T(0.1);
  const T t3_21 = Pddot2_3 + U2_31 * T(0.3) + U2_32 * T(0.15) - minus_U2_33 * T(0.1);
  const T Pddot3_1 = C3_11 * t3_19 + C3_12 * t3_20 + C3_13 * t3_21;
  const T Pddot3_2 = C3_21 * t3_19 + C3_22 * t3_20 + C3_23 * t3_21;
  const T Pddot3_3 = C3_31 * t3_19 + C3_32 * t3_20 + C3_33 * t3_21;
  // N2 = C3^T M_torque_3_ + h_all_2~ Pddot2 + axial(U2 (tr(J_all_2)/2 - J_all_2)) - M_torque_2_: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N2_1 = C3_11 * u.tau_3_1 - u.tau_2_1 + C3_21 * u.tau_3_2 + C3_31 * u.tau_3_3 + T(1.1099999999999999) *
      Pddot2_3 - T(0.64) * Pddot2_2 + T(0.2145) * U2_32 - T(0.145) * U2_23 + T(0.1038) * (minus_U2_22 - minus_U2_33) +
      T(0.27899999999999997) * U2_31 - T(0.1764) * U2_21;
  const T N2_2 = C3_12 * u.tau_3_1 - u.tau_2_2 + C3_22 * u.tau_3_2 + C3_32 * u.tau_3_3 + T(0.64) * Pddot2_1 -
      T(1.8599999999999999) * Pddot2_3 + T(0.145) * U2_13 - T(0.594) * U2_31 + T(0.1764) * (minus_U2_33 - minus_U2_11)
      + T(0.1038) * U2_12 - T(0.27899999999999997) * U2_32;
  const T N2_3 = C3_13 * u.tau_3_1 - u.tau_2_3 + C3_23 * u.tau_3_2 + C3_33 * u.tau_3_3 + T(1.8599999999999999) *
      Pddot2_2 - T(1.1099999999999999) * Pddot2_1 + T(0.594) * U2_21 - T(0.2145) * U2_12 + T(0.27899999999999997) *
      (minus_U2_11 - minus_U2_22) + T(0.1764) * U2_23 - T(0.1038) * U2_13;
  // G3 = U3 h_all_3: inertia less applied force, body axes [N]
  const T G3_1 = U3_12 * T(1.1600000000000001) - minus_U3_11 * T(1.48) + U3_13 * T(0.515);
  const T G3_2 = U3_21 * T(1.48) - minus_U3_22 * T(1.1600000000000001) + U3_23 * T(0.515);
  const T G3_3 = U3_31 * T(1.48) + U3_32 * T(1.1600000000000001) - minus_U3_33 * T(0.515);

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T omegadot4_1 = ydot[9], omegadot4_2 = ydot[10], omegadot4_3 = ydot[11];
  // erel4 = -e3~ e4 + eps4_3 e4 - eps4_4 e3: Euler parameters relative to the lower body
  const T erel4_1 = eps3_3 * eps4_2 - eps3_2 * eps4_3 + eps3_4 * eps4_1 - eps4_4 * eps3_1;
  const T erel4_2 = eps3_1 * eps4_3 - eps3_3 * eps4_1 + eps3_4 * eps4_2 - eps4_4 * eps3_2;
  const T erel4_3 = eps3_2 * eps4_1 - eps3_1 * eps4_2 + eps3_4 * eps4_3 - eps4_4 * eps3_3;
  // eps4rel4 = e3 . e4 + eps4_3 eps4_4
  const T eps4rel4 = eps3_1 * eps4_1 + eps3_2 * eps4_2 + eps3_3 * eps4_3 + eps3_4 * eps4_4;
  // C4^T = 1 + 2 erel4~ (eps4rel4 + erel4~): C takes components in the lower body to those in the body
  const T t4_1 = T(2) * erel4_2;
  const T t4_2 = t4_1 * erel4_2;
  const T t4_3 = T(2) * erel4_3;
  const T t4_4 = t4_3 * erel4_3;
  const T C4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * erel4_1;
  const T t4_6 = t4_5 * erel4_2;
  const T t4_7 = t4_3 * eps4rel4;
  const T C4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * erel4_3;
  const T t4_9 = t4_1 * eps4rel4;
  const T C4_13 = t4_8 - t4_9;
  const T C4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * erel4_1;
  const T C4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * erel4_3;
  const T t4_12 = t4_5 * eps4rel4;
  const T C4_23 = t4_11 + t4_12;
  const T C4_31 = t4_8 + t4_9;
  const T C4_32 = t4_11 - t4_12;
  const T C4_33 = t4_10 - t4_2;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_13 = omega4_3 * omega4_3;
  const T t4_14 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_13 + t4_14;
  const T t4_15 = omega4_2 * omega4_1;
  const T U4_12 = t4_15 - omegadot4_3;
  const T t4_16 = omega4_3 * omega4_1;
  const T U4_13 = t4_16 + omegadot4_2;
  const T U4_21 = t4_15 + omegadot4_3;
  const T t4_17 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_13 + t4_17;
  const T t4_18 = omega4_3 * omega4_2;
  const T U4_23 = t4_18 - omegadot4_1;
  const T U4_31 = t4_16 - omegadot4_2;
  const T U4_32 = t4_18 + omegadot4_1;
  const T minus_U4_33 = t4_14 + t4_17;
  // Pddot4 = C4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_19 = Pddot3_1 + U3_12 * T(0.2) - minus_U3_11 * T(0.3) + U3_13 * T(0.1);
  const T t4_20 = Pddot3_2 + U3_21 * T(0.3) - minus_U3_22 * T(0.2) + U3_23 * T(0.1);
  const T t4_21 = Pddot3_3 + U3_31 * T(0.3) + U3_32 * T(0.2) - minus_U3_33 * T(0.1);
  const T Pddot4_1 = C4_11 * t4_19 + C4_12 * t4_20 + C4_13 * t4_21;
  const T Pddot4_2 = C4_21 * t4_19 + C4_22 * t4_20 + C4_23 * t4_21;
  const T Pddot4_3 = C4_31 * t4_19 + C4_32 * t4_20 + C4_33 * t4_21;
  // N3 = C4^T M_torque_4_ + h_all_3~ Pddot3 + axial(U3 (tr(J_all_3)/2 - J_all_3)) - M_torque_3_: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N3_1 = C4_11 * u.tau_4_1 - u.tau_3_1 + C4_21 * u.tau_4_2 + C4_31 * u.tau_4_3 + T(1.1600000000000001) *
      Pddot3_3 - T(0.515) * Pddot3_2 + T(0.271) * U3_32 - T(0.13925) * U3_23 + T(0.10820000000000002) * (minus_U3_22 -
      minus_U3_33) + T(0.28950000000000004) * U3_31 - T(0.1376) * U3_21;
  const T N3_2 = C4_12 * u.tau_4_1 - u.tau_3_2 + C4_22 * u.tau_4_2 + C4_32 * u.tau_4_3 + T(0.515) * Pddot3_1 - T(1.48)
      * Pddot3_3 + T(0.13925) * U3_13 - T(0.483) * U3_31 + T(0.1376) * (minus_U3_33 - minus_U3_11) +
      T(0.10820000000000002) * U3_12 - T(0.28950000000000004) * U3_32;
  const T N3_3 = C4_13 * u.tau_4_1 - u.tau_3_3 + C4_23 * u.tau_4_2 + C4_33 * u.tau_4_3 + T(1.48) * Pddot3_2 -
      T(1.1600000000000001) * Pddot3_1 + T(0.483) * U3_21 - T(0.271) * U3_12 + T(0.28950000000000004) * (minus_U3_11 -
      minus_U3_22) + T(0.1376) * U3_23 - T(0.10820000000000002) * U3_13;
  // G4 = U4 h_all_4: inertia less applied force, body axes [N]
  const T G4_1 = U4_12 * T(1.055) - minus_U4_11 * T(1.07) + U4_13 * T(0.38);
  const T G4_2 = U4_21 * T(1.07) - minus_U4_22 * T(1.055) + U4_23 * T(0.38);
  const T G4_3 = U4_31 * T(1.07) + U4_32 * T(1.055) - minus_U4_33 * T(0.38);

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T omegadot5_1 = ydot[12], omegadot5_2 = ydot[13], omegadot5_3 = ydot[14];
  // erel5 = -e4~ e5 + eps4_4 e5 - eps4_5 e4: Euler parameters relative to the lower body
  const T erel5_1 = eps4_3 * eps5_2 - eps4_2 * eps5_3 + eps4_4 * eps5_1 - eps5_4 * eps4_1;
  const T erel5_2 = eps4_1 * eps5_3 - eps4_3 * eps5_1 + eps4_4 * eps5_2 - eps5_4 * eps4_2;
  const T erel5_3 = eps4_2 * eps5_1 - eps4_1 * eps5_2 + eps4_4 * eps5_3 - eps5_4 * eps4_3;
  // eps4rel5 = e4 . e5 + eps4_4 eps4_5
  const T eps4rel5 = eps4_1 * eps5_1 + eps4_2 * eps5_2 + eps4_3 * eps5_3 + eps4_4 * eps5_4;
  // C5^T = 1 + 2 erel5~ (eps4rel5 + erel5~): C takes components in the lower body to those in the body
  const T t5_1 = T(2) * erel5_2;
  const T t5_2 = t5_1 * erel5_2;
  const T t5_3 = T(2) * erel5_3;
  const T t5_4 = t5_3 * erel5_3;
  const T C5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * erel5_1;
  const T t5_6 = t5_5 * erel5_2;
  const T t5_7 = t5_3 * eps4rel5;
  const T C5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * erel5_3;
  const T t5_9 = t5_1 * eps4rel5;
  const T C5_13 = t5_8 - t5_9;
  const T C5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * erel5_1;
  const T C5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * erel5_3;
  const T t5_12 = t5_5 * eps4rel5;
  const T C5_23 = t5_11 + t5_12;
  const T C5_31 = t5_8 + t5_9;
  const T C5_32 = t5_11 - t5_12;
  const T C5_33 = t5_10 - t5_2;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_13 = omega5_3 * omega5_3;
  const T t5_14 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_13 + t5_14;
  const T t5_15 = omega5_2 * omega5_1;
  const T U5_12 = t5_15 - omegadot5_3;
  const T t5_16 = omega5_3 * omega5_1;
  const T U5_13 = t5_16 + omegadot5_2;
  const T U5_21 = t5_15 + omegadot5_3;
  const T t5_17 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_13 + t5_17;
  const T t5_18 = omega5_3 * omega5_2;
  const T U5_23 = t5_18 - omegadot5_1;
  const T U5_31 = t5_16 - omegadot5_2;
  const T U5_32 = t5_18 + omegadot5_1;
  const T minus_U5_33 = t5_14 + t5_17;
  // Pddot5 = C5 (U4 q5 + Pddot4): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_19 = Pddot4_1 + U4_12 * T(0.25) - minus_U4_11 * T(0.3) + U4_13 * T(0.1);
  const T t5_20 = Pddot4_2 + U4_21 * T(0.3) - minus_U4_22 * T(0.25) + U4_23 * T(0.1);
  const T t5_21 = Pddot4_3 + U4_31 * T(0.3) + U4_32 * T(0.25) - minus_U4_33 * T(0.1);
  const T Pddot5_1 = C5_11 * t5_19 + C5_12 * t5_20 + C5_13 * t5_21;
  const T Pddot5_2 = C5_21 * t5_19 + C5_22 * t5_20 + C5_23 * t5_21;
  const T Pddot5_3 = C5_31 * t5_19 + C5_32 * t5_20 + C5_33 * t5_21;
  // N4 = C5^T M_torque_5_ + h_all_4~ Pddot4 + axial(U4 (tr(J_all_4)/2 - J_all_4)) - M_torque_4_: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N4_1 = C5_11 * u.tau_5_1 - u.tau_4_1 + C5_21 * u.tau_5_2 + C5_31 * u.tau_5_3 + T(1.055) * Pddot4_3 - T(0.38)
      * Pddot4_2 + T(0.29175) * U4_32 - T(0.1325) * U4_23 + T(0.0971) * (minus_U4_22 - minus_U4_33) + T(0.2535) *
      U4_31 - T(0.09580000000000001) * U4_21;
  const T N4_2 = C5_12 * u.tau_5_1 - u.tau_4_2 + C5_22 * u.tau_5_2 + C5_32 * u.tau_5_3 + T(0.38) * Pddot4_1 - T(1.07)
      * Pddot4_3 + T(0.1325) * U4_13 - T(0.363) * U4_31 + T(0.09580000000000001) * (minus_U4_33 - minus_U4_11) +
      T(0.0971) * U4_12 - T(0.2535) * U4_32;
  const T N4_3 = C5_13 * u.tau_5_1 - u.tau_4_3 + C5_23 * u.tau_5_2 + C5_33 * u.tau_5_3 + T(1.07) * Pddot4_2 - T(1.055)
      * Pddot4_1 + T(0.363) * U4_21 - T(0.29175) * U4_12 + T(0.2535) * (minus_U4_11 - minus_U4_22) +
      T(0.09580000000000001) * U4_23 - T(0.0971) * U4_13;
  // G5 = U5 h_all_5: inertia less applied force, body axes [N]
  const T G5_1 = U5_12 * T(0.78) - minus_U5_11 * T(0.63) + U5_13 * T(0.23500000000000001);
  const T G5_2 = U5_21 * T(0.63) - minus_U5_22 * T(0.78) + U5_23 * T(0.23500000000000001);
  const T G5_3 = U5_31 * T(0.63) + U5_32 * T(0.78) - minus_U5_33 * T(0.23500000000000001);

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T omegadot6_1 = ydot[15], omegadot6_2 = ydot[16], omegadot6_3 = ydot[17];
  // erel6 = -e5~ e6 + eps4_5 e6 - eps4_6 e5: Euler parameters relative to the lower body
  const T erel6_1 = eps5_3 * eps6_2 - eps5_2 * eps6_3 + eps5_4 * eps6_1 - eps6_4 * eps5_1;
  const T erel6_2 = eps5_1 * eps6_3 - eps5_3 * eps6_1 + eps5_4 * eps6_2 - eps6_4 * eps5_2;
  const T erel6_3 = eps5_2 * eps6_1 - eps5_1 * eps6_2 + eps5_4 * eps6_3 - eps6_4 * eps5_3;
  // eps4rel6 = e5 . e6 + eps4_5 eps4_6
  const T eps4rel6 = eps5_1 * eps6_1 + eps5_2 * eps6_2 + eps5_3 * eps6_3 + eps5_4 * eps6_4;
  // C6^T = 1 + 2 erel6~ (eps4rel6 + erel6~): C takes components in the lower body to those in the body
  const T t6_1 = T(2) * erel6_2;
  const T t6_2 = t6_1 * erel6_2;
  const T t6_3 = T(2) * erel6_3;
  const T t6_4 = t6_3 * erel6_3;
  const T C6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * erel6_1;
  const T t6_6 = t6_5 * erel6_2;
  const T t6_7 = t6_3 * eps4rel6;
  const T C6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * erel6_3;
  const T t6_9 = t6_1 * eps4rel6;
  const T C6_13 = t6_8 - t6_9;
  const T C6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * erel6_1;
  const T C6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * erel6_3;
  const T t6_12 = t6_5 * eps4rel6;
  const T C6_23 = t6_11 + t6_12;
  const T C6_31 = t6_8 + t6_9;
  const T C6_32 = t6_11 - t6_12;
  const T C6_33 = t6_10 - t6_2;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_13 = omega6_3 * omega6_3;
  const T t6_14 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_13 + t6_14;
  const T t6_15 = omega6_2 * omega6_1;
  const T U6_12 = t6_15 - omegadot6_3;
  const T t6_16 = omega6_3 * omega6_1;
  const T U6_13 = t6_16 + omegadot6_2;
  const T U6_21 = t6_15 + omegadot6_3;
  const T t6_17 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_13 + t6_17;
  const T t6_18 = omega6_3 * omega6_2;
  const T U6_23 = t6_18 - omegadot6_1;
  const T U6_31 = t6_16 - omegadot6_2;
  const T U6_32 = t6_18 + omegadot6_1;
  const T minus_U6_33 = t6_14 + t6_17;
  // Pddot6 = C6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t6_19 = Pddot5_1 + U5_12 * T(0.3) - minus_U5_11 * T(0.3) + U5_13 * T(0.1);
  const T t6_20 = Pddot5_2 + U5_21 * T(0.3) - minus_U5_22 * T(0.3) + U5_23 * T(0.1);
  const T t6_21 = Pddot5_3 + U5_31 * T(0.3) + U5_32 * T(0.3) - minus_U5_33 * T(0.1);
  const T Pddot6_1 = C6_11 * t6_19 + C6_12 * t6_20 + C6_13 * t6_21;
  const T Pddot6_2 = C6_21 * t6_19 + C6_22 * t6_20 + C6_23 * t6_21;
  const T Pddot6_3 = C6_31 * t6_19 + C6_32 * t6_20 + C6_33 * t6_21;
  // N5 = C6^T M_torque_6_ + h_all_5~ Pddot5 + axial(U5 (tr(J_all_5)/2 - J_all_5)) - M_torque_5_: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N5_1 = C6_11 * u.tau_6_1 - u.tau_5_1 + C6_21 * u.tau_6_2 + C6_31 * u.tau_6_3 + T(0.78) * Pddot5_3 -
      T(0.23500000000000001) * Pddot5_2 + T(0.249) * U5_32 - T(0.12475) * U5_23 + T(0.069) * (minus_U5_22 -
      minus_U5_33) + T(0.1665) * U5_31 - T(0.051000000000000004) * U5_21;
  const T N5_2 = C6_12 * u.tau_6_1 - u.tau_5_2 + C6_22 * u.tau_6_2 + C6_32 * u.tau_6_3 + T(0.23500000000000001) *
      Pddot5_1 - T(0.63) * Pddot5_3 + T(0.12475) * U5_13 - T(0.23399999999999999) * U5_31 + T(0.051000000000000004) *
      (minus_U5_33 - minus_U5_11) + T(0.069) * U5_12 - T(0.1665) * U5_32;
  const T N5_3 = C6_13 * u.tau_6_1 - u.tau_5_3 + C6_23 * u.tau_6_2 + C6_33 * u.tau_6_3 + T(0.63) * Pddot5_2 - T(0.78)
      * Pddot5_1 + T(0.23399999999999999) * U5_21 - T(0.249) * U5_12 + T(0.1665) * (minus_U5_11 - minus_U5_22) +
      T(0.051000000000000004) * U5_23 - T(0.069) * U5_13;
  // G6 = U6 h_all_6: inertia less applied force, body axes [N]
  const T G6_1 = U6_12 * T(0.32000000000000006) - minus_U6_11 * T(0.16000000000000003) + U6_13 *
      T(0.08000000000000002);
  const T G6_2 = U6_21 * T(0.16000000000000003) - minus_U6_22 * T(0.32000000000000006) + U6_23 *
      T(0.08000000000000002);
  const T G6_3 = U6_31 * T(0.16000000000000003) + U6_32 * T(0.32000000000000006) - minus_U6_33 *
      T(0.08000000000000002);
  // N6 = h_all_6~ Pddot6 + axial(U6 (tr(J_all_6)/2 - J_all_6)) - M_torque_6_: inertia less applied moment about the
  //   body origin, body axes [N m]
  const T N6_1 = T(0.32000000000000006) * Pddot6_3 - u.tau_6_1 - T(0.08000000000000002) * Pddot6_2 +
      T(0.11200000000000002) * U6_32 - T(0.116) * U6_23 + T(0.022400000000000003) * (minus_U6_22 - minus_U6_33) +
      T(0.024000000000000004) * U6_31 - T(0.003200000000000002) * U6_21;
  const T N6_2 = T(0.08000000000000002) * Pddot6_1 - u.tau_6_2 - T(0.16000000000000003) * Pddot6_3 + T(0.116) * U6_13
      - T(0.096) * U6_31 + T(0.003200000000000002) * (minus_U6_33 - minus_U6_11) + T(0.022400000000000003) * U6_12 -
      T(0.024000000000000004) * U6_32;
  const T N6_3 = T(0.16000000000000003) * Pddot6_2 - u.tau_6_3 - T(0.32000000000000006) * Pddot6_1 + T(0.096) * U6_21
      - T(0.11200000000000002) * U6_12 + T(0.024000000000000004) * (minus_U6_11 - minus_U6_22) +
      T(0.003200000000000002) * U6_23 - T(0.022400000000000003) * U6_13;
  r[15] = N6_1;
  r[16] = N6_2;
  r[17] = N6_3;

  // ---- body 5 (body_5) and what it carries
  // S5 = C6^T G6 + G5: sum of the force balances of the subtree, body axes [N]
  const T b5_1 = C6_11 * G6_1 + C6_21 * G6_2 + C6_31 * G6_3;
  const T S5_1 = b5_1 + G5_1;
  const T b5_2 = C6_12 * G6_1 + C6_22 * G6_2 + C6_32 * G6_3;
  const T S5_2 = b5_2 + G5_2;
  const T b5_3 = C6_13 * G6_1 + C6_23 * G6_2 + C6_33 * G6_3;
  const T S5_3 = b5_3 + G5_3;
  // r_omega5 = q6~ C6^T G6 + N5: Kane's equation of omega [N m]
  const T b5_4 = T(0.3) * b5_3;
  const T r_omega5_1 = b5_4 + N5_1 - T(0.1) * b5_2;
  const T r_omega5_2 = N5_2 - b5_4 + T(0.1) * b5_1;
  const T r_omega5_3 = N5_3 + T(0.3) * b5_2 - T(0.3) * b5_1;
  r[12] = r_omega5_1;
  r[13] = r_omega5_2;
  r[14] = r_omega5_3;

  // ---- body 4 (body_4) and what it carries
  // S4 = C5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T b4_1 = C5_11 * S5_1 + C5_21 * S5_2 + C5_31 * S5_3;
  const T S4_1 = b4_1 + G4_1;
  const T b4_2 = C5_12 * S5_1 + C5_22 * S5_2 + C5_32 * S5_3;
  const T S4_2 = b4_2 + G4_2;
  const T b4_3 = C5_13 * S5_1 + C5_23 * S5_2 + C5_33 * S5_3;
  const T S4_3 = b4_3 + G4_3;
  // r_omega4 = q5~ C5^T S5 + N4: Kane's equation of omega [N m]
  const T r_omega4_1 = N4_1 + T(0.25) * b4_3 - T(0.1) * b4_2;
  const T r_omega4_2 = N4_2 + T(0.1) * b4_1 - T(0.3) * b4_3;
  const T r_omega4_3 = N4_3 + T(0.3) * b4_2 - T(0.25) * b4_1;
  r[9] = r_omega4_1;
  r[10] = r_omega4_2;
  r[11] = r_omega4_3;

  // ---- body 3 (body_3) and what it carries
  // S3 = C4^T S4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = C4_11 * S4_1 + C4_21 * S4_2 + C4_31 * S4_3;
  const T S3_1 = b3_1 + G3_1;
  const T b3_2 = C4_12 * S4_1 + C4_22 * S4_2 + C4_32 * S4_3;
  const T S3_2 = b3_2 + G3_2;
  const T b3_3 = C4_13 * S4_1 + C4_23 * S4_2 + C4_33 * S4_3;
  const T S3_3 = b3_3 + G3_3;
  // r_omega3 = q4~ C4^T S4 + N3: Kane's equation of omega [N m]
  const T r_omega3_1 = N3_1 + T(0.2) * b3_3 - T(0.1) * b3_2;
  const T r_omega3_2 = N3_2 + T(0.1) * b3_1 - T(0.3) * b3_3;
  const T r_omega3_3 = N3_3 + T(0.3) * b3_2 - T(0.2) * b3_1;
  r[6] = r_omega3_1;
  r[7] = r_omega3_2;
  r[8] = r_omega3_3;

  // ---- body 2 (body_2) and what it carries
  // S2 = C3^T S3 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = C3_11 * S3_1 + C3_21 * S3_2 + C3_31 * S3_3;
  const T S2_1 = b2_1 + G2_1;
  const T b2_2 = C3_12 * S3_1 + C3_22 * S3_2 + C3_32 * S3_3;
  const T S2_2 = b2_2 + G2_2;
  const T b2_3 = C3_13 * S3_1 + C3_23 * S3_2 + C3_33 * S3_3;
  const T S2_3 = b2_3 + G2_3;
  // r_omega2 = q3~ C3^T S3 + N2: Kane's equation of omega [N m]
  const T r_omega2_1 = N2_1 + T(0.15) * b2_3 - T(0.1) * b2_2;
  const T r_omega2_2 = N2_2 + T(0.1) * b2_1 - T(0.3) * b2_3;
  const T r_omega2_3 = N2_3 + T(0.3) * b2_2 - T(0.15) * b2_1;
  r[3] = r_omega2_1;
  r[4] = r_omega2_2;
  r[5] = r_omega2_3;

  // ---- body 1 (body_1) and what it carries
  // r_omega1 = q2~ C2^T S2 + N1: Kane's equation of omega [N m]
  const T b1_1 = C2_13 * S2_1 + C2_23 * S2_2 + C2_33 * S2_3;
  const T b1_2 = C2_12 * S2_1 + C2_22 * S2_2 + C2_32 * S2_3;
  const T r_omega1_1 = N1_1 + T(0.1) * b1_1 - T(0.1) * b1_2;
  const T b1_3 = T(0.1) * (C2_11 * S2_1 + C2_21 * S2_2 + C2_31 * S2_3);
  const T r_omega1_2 = b1_3 + N1_2 - T(0.3) * b1_1;
  const T r_omega1_3 = N1_3 - b1_3 + T(0.3) * b1_2;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 485 add, 546 multiply
template <class T>
void forcing([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* f) noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_2;
  const T R1_13 = t1_1 * eps1_3 - t1_2 * eps1_4;
  const T R1_23 = t1_2 * eps1_3 + t1_1 * eps1_4;
  const T R1_33 = T(1) - t1_1 * eps1_1 - t1_2 * eps1_2;
  // U1 = omega1~ omega1~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t1_3 = omega1_3 * omega1_3;
  const T t1_4 = omega1_2 * omega1_2;
  const T minus_U1_11 = t1_3 + t1_4;
  const T U1_12 = omega1_2 * omega1_1;
  const T U1_13 = omega1_3 * omega1_1;
  const T t1_5 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_3 + t1_5;
  const T U1_23 = omega1_3 * omega1_2;
  const T minus_U1_33 = t1_4 + t1_5;
  // Pddot1 = -R1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1 = R1_13 * T(9.81);
  const T Pddot1_2 = R1_23 * T(9.81);
  const T Pddot1_3 = R1_33 * T(9.81);

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // erel2 = -e1~ e2 + eps4_1 e2 - eps4_2 e1: Euler parameters relative to the lower body
  const T erel2_1 = eps1_3 * eps2_2 - eps1_2 * eps2_3 + eps1_4 * eps2_1 - eps2_4 * eps1_1;
  const T erel2_2 = eps1_1 * eps2_3 - eps1_3 * eps2_1 + eps1_4 * eps2_2 - eps2_4 * eps1_2;
  const T erel2_3 = eps1_2 * eps2_1 - eps1_1 * eps2_2 + eps1_4 * eps2_3 - eps2_4 * eps1_3;
  // eps4rel2 = e1 . e2 + eps4_1 eps4_2
  const T eps4rel2 = eps1_1 * eps2_1 + eps1_2 * eps2_2 + eps1_3 * eps2_3 + eps1_4 * eps2_4;
  // C2^T = 1 + 2 erel2~ (eps4rel2 + erel2~): C takes components in the lower body to those in the body
  const T t2_1 = T(2) * erel2_2;
  const T t2_2 = t2_1 * erel2_2;
  const T t2_3 = T(2) * erel2_3;
  const T t2_4 = t2_3 * erel2_3;
  const T C2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * erel2_1;
  const T t2_6 = t2_5 * erel2_2;
  const T t2_7 = t2_3 * eps4rel2;
  const T C2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * erel2_3;
  const T t2_9 = t2_1 * eps4rel2;
  const T C2_13 = t2_8 - t2_9;
  const T C2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * erel2_1;
  const T C2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * erel2_3;
  const T t2_12 = t2_5 * eps4rel2;
  const T C2_23 = t2_11 + t2_12;
  const T C2_31 = t2_8 + t2_9;
  const T C2_32 = t2_11 - t2_12;
  const T C2_33 = t2_10 - t2_2;
  // U2 = omega2~ omega2~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t2_13 = omega2_3 * omega2_3;
  const T t2_14 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_13 + t2_14;
  const T U2_12 = omega2_2 * omega2_1;
  const T U2_13 = omega2_3 * omega2_1;
  const T t2_15 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_13 + t2_15;
  const T U2_23 = omega2_3 * omega2_2;
  const T minus_U2_33 = t2_14 + t2_15;
  // Pddot2 = C2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_16 = Pddot1_1 + U1_12 * T(0.1) - minus_U1_11 * T(0.3) + U1_13 * T(0.1);
  const T t2_17 = U1_23 * T(0.1);
  const T t2_18 = t2_17 + Pddot1_2 + U1_12 * T(0.3) - minus_U1_22 * T(0.1);
  const T t2_19 = t2_17 + Pddot1_3 + U1_13 * T(0.3) - minus_U1_33 * T(0.1);
  const T Pddot2_1 = C2_11 * t2_16 + C2_12 * t2_18 + C2_13 * t2_19;
  const T Pddot2_2 = C2_21 * t2_16 + C2_22 * t2_18 + C2_23 * t2_19;
  const T Pddot2_3 = C2_31 * t2_16 + C2_32 * t2_18 + C2_33 * t2_19;
  // N1 = -C2^T M_torque_2_ - h_all_1~ Pddot1 - omega1~ J_all_1 omega1 + M_torque_1_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N1_1 = T(0.0027500000000000033) * U1_23 - (C2_11 * u.tau_2_1 - u.tau_1_1 + C2_21 * u.tau_2_2 + C2_31 *
      u.tau_2_3 + T(0.92) * Pddot1_3 - T(0.755) * Pddot1_2) + T(0.0854) * (t1_4 - t1_3) + T(0.2122) * U1_12 -
      T(0.2265) * U1_13;
  const T N1_2 = T(0.5462499999999999) * U1_13 - (C2_12 * u.tau_2_1 - u.tau_1_2 + C2_22 * u.tau_2_2 + C2_32 *
      u.tau_2_3 + T(0.755) * Pddot1_1 - T(2.21) * Pddot1_3) + T(0.2122) * (t1_3 - t1_5) + T(0.2265) * U1_23 -
      T(0.0854) * U1_12;
  const T N1_3 = T(0.2265) * (t1_5 - t1_4) - (C2_13 * u.tau_2_1 - u.tau_1_3 + C2_23 * u.tau_2_2 + C2_33 * u.tau_2_3 +
      T(2.21) * Pddot1_2 - T(0.92) * Pddot1_1 + T(0.5489999999999999) * U1_12) + T(0.0854) * U1_13 - T(0.2122) *
      U1_23;
  // G2 = -U2 h_all_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_12 * T(1.1099999999999999) - minus_U2_11 * T(1.8599999999999999) + U2_13 * T(0.64);
  const T minus_G2_2 = U2_12 * T(1.8599999999999999) - minus_U2_22 * T(1.1099999999999999) + U2_23 * T(0.64);
  const T minus_G2_3 = U2_13 * T(1.8599999999999999) + U2_23 * T(1.1099999999999999) - minus_U2_33 * T(0.64);

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  // erel3 = -e2~ e3 + eps4_2 e3 - eps4_3 e2: Euler parameters relative to the lower body
  const T erel3_1 = eps2_3 * eps3_2 - eps2_2 * eps3_3 + eps2_4 * eps3_1 - eps3_4 * eps2_1;
  const T erel3_2 = eps2_1 * eps3_3 - eps2_3 * eps3_1 + eps2_4 * eps3_2 - eps3_4 * eps2_2;
  const T erel3_3 = eps2_2 * eps3_1 - eps2_1 * eps3_2 + eps2_4 * eps3_3 - eps3_4 * eps2_3;
  // eps4rel3 = e2 . e3 + eps4_2 eps4_3
  const T eps4rel3 = eps2_1 * eps3_1 + eps2_2 * eps3_2 + eps2_3 * eps3_3 + eps2_4 * eps3_4;
  // C3^T = 1 + 2 erel3~ (eps4rel3 + erel3~): C takes components in the lower body to those in the body
  const T t3_1 = T(2) * erel3_2;
  const T t3_2 = t3_1 * erel3_2;
  const T t3_3 = T(2) * erel3_3;
  const T t3_4 = t3_3 * erel3_3;
  const T C3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * erel3_1;
  const T t3_6 = t3_5 * erel3_2;
  const T t3_7 = t3_3 * eps4rel3;
  const T C3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * erel3_3;
  const T t3_9 = t3_1 * eps4rel3;
  const T C3_13 = t3_8 - t3_9;
  const T C3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * erel3_1;
  const T C3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * erel3_3;
  const T t3_12 = t3_5 * eps4rel3;
  const T C3_23 = t3_11 + t3_12;
  const T C3_31 = t3_8 + t3_9;
  const T C3_32 = t3_11 - t3_12;
  const T C3_33 = t3_10 - t3_2;
  // U3 = omega3~ omega3~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t3_13 = omega3_3 * omega3_3;
  const T t3_14 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_13 + t3_14;
  const T U3_12 = omega3_2 * omega3_1;
  const T U3_13 = omega3_3 * omega3_1;
  const T t3_15 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_13 + t3_15;
  const T U3_23 = omega3_3 * omega3_2;
  const T minus_U3_33 = t3_14 + t3_15;
  // Pddot3 = C3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_16 = Pddot2_1 + U2_12 * T(0.15) - minus_U2_11 * T(0.3) + U2_13 * T(0.1);
  const T t3_17 = Pddot2_2 + U2_12 * T(0.3) - minus_U2_22 * T(0.15) + U2_23 * T(0.1);
  const T t3_18 = Pddot2_3 + U2_13 * T(0.3) + U2_23 * T(0.15) - minus_U2_33 * T(0.1);
  const T Pddot3_1 = C3_11 * t3_16 + C3_12 * t3_17 + C3_13 * t3_18;
  const T Pddot3_2 = C3_21 * t3_16 + C3_22 * t3_17 + C3_23 * t3_18;
  const T Pddot3_3 = C3_31 * t3_16 + C3_32 * t3_17 + C3_33 * t3_18;
  // N2 = -C3^T M_torque_3_ - h_all_2~ Pddot2 - omega2~ J_all_2 omega2 + M_torque_2_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N2_1 = T(0.64) * Pddot2_2 - (C3_11 * u.tau_3_1 - u.tau_2_1 + C3_21 * u.tau_3_2 + C3_31 * u.tau_3_3 +
      T(1.1099999999999999) * Pddot2_3) - T(0.0695) * U2_23 + T(0.1038) * (t2_14 - t2_13) + T(0.1764) * U2_12 -
      T(0.27899999999999997) * U2_13;
  const T N2_2 = T(1.8599999999999999) * Pddot2_3 - (C3_12 * u.tau_3_1 - u.tau_2_2 + C3_22 * u.tau_3_2 + C3_32 *
      u.tau_3_3 + T(0.64) * Pddot2_1) + T(0.44899999999999995) * U2_13 + T(0.1764) * (t2_13 - t2_15) +
      T(0.27899999999999997) * U2_23 - T(0.1038) * U2_12;
  const T N2_3 = T(1.1099999999999999) * Pddot2_1 - (C3_13 * u.tau_3_1 - u.tau_2_3 + C3_23 * u.tau_3_2 + C3_33 *
      u.tau_3_3 + T(1.8599999999999999) * Pddot2_2) - T(0.37949999999999995) * U2_12 + T(0.27899999999999997) * (t2_15
      - t2_14) + T(0.1038) * U2_13 - T(0.1764) * U2_23;
  // G3 = -U3 h_all_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = U3_12 * T(1.1600000000000001) - minus_U3_11 * T(1.48) + U3_13 * T(0.515);
  const T minus_G3_2 = U3_12 * T(1.48) - minus_U3_22 * T(1.1600000000000001) + U3_23 * T(0.515);
  const T minus_G3_3 = U3_13 * T(1.48) + U3_23 * T(1.1600000000000001) - minus_U3_33 * T(0.515);

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  // erel4 = -e3~ e4 + eps4_3 e4 - eps4_4 e3: Euler parameters relative to the lower body
  const T erel4_1 = eps3_3 * eps4_2 - eps3_2 * eps4_3 + eps3_4 * eps4_1 - eps4_4 * eps3_1;
  const T erel4_2 = eps3_1 * eps4_3 - eps3_3 * eps4_1 + eps3_4 * eps4_2 - eps4_4 * eps3_2;
  const T erel4_3 = eps3_2 * eps4_1 - eps3_1 * eps4_2 + eps3_4 * eps4_3 - eps4_4 * eps3_3;
  // eps4rel4 = e3 . e4 + eps4_3 eps4_4
  const T eps4rel4 = eps3_1 * eps4_1 + eps3_2 * eps4_2 + eps3_3 * eps4_3 + eps3_4 * eps4_4;
  // C4^T = 1 + 2 erel4~ (eps4rel4 + erel4~): C takes components in the lower body to those in the body
  const T t4_1 = T(2) * erel4_2;
  const T t4_2 = t4_1 * erel4_2;
  const T t4_3 = T(2) * erel4_3;
  const T t4_4 = t4_3 * erel4_3;
  const T C4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * erel4_1;
  const T t4_6 = t4_5 * erel4_2;
  const T t4_7 = t4_3 * eps4rel4;
  const T C4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * erel4_3;
  const T t4_9 = t4_1 * eps4rel4;
  const T C4_13 = t4_8 - t4_9;
  const T C4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * erel4_1;
  const T C4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * erel4_3;
  const T t4_12 = t4_5 * eps4rel4;
  const T C4_23 = t4_11 + t4_12;
  const T C4_31 = t4_8 + t4_9;
  const T C4_32 = t4_11 - t4_12;
  const T C4_33 = t4_10 - t4_2;
  // U4 = omega4~ omega4~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t4_13 = omega4_3 * omega4_3;
  const T t4_14 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_13 + t4_14;
  const T U4_12 = omega4_2 * omega4_1;
  const T U4_13 = omega4_3 * omega4_1;
  const T t4_15 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_13 + t4_15;
  const T U4_23 = omega4_3 * omega4_2;
  const T minus_U4_33 = t4_14 + t4_15;
  // Pddot4 = C4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_16 = Pddot3_1 + U3_12 * T(0.2) - minus_U3_11 * T(0.3) + U3_13 * T(0.1);
  const T t4_17 = Pddot3_2 + U3_12 * T(0.3) - minus_U3_22 * T(0.2) + U3_23 * T(0.1);
  const T t4_18 = Pddot3_3 + U3_13 * T(0.3) + U3_23 * T(0.2) - minus_U3_33 * T(0.1);
  const T Pddot4_1 = C4_11 * t4_16 + C4_12 * t4_17 + C4_13 * t4_18;
  const T Pddot4_2 = C4_21 * t4_16 + C4_22 * t4_17 + C4_23 * t4_18;
  const T Pddot4_3 = C4_31 * t4_16 + C4_32 * t4_17 + C4_33 * t4_18;
  // N3 = -C4^T M_torque_4_ - h_all_3~ Pddot3 - omega3~ J_all_3 omega3 + M_torque_3_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N3_1 = T(0.515) * Pddot3_2 - (C4_11 * u.tau_4_1 - u.tau_3_1 + C4_21 * u.tau_4_2 + C4_31 * u.tau_4_3 +
      T(1.1600000000000001) * Pddot3_3) - T(0.13175) * U3_23 + T(0.10820000000000002) * (t3_14 - t3_13) + T(0.1376) *
      U3_12 - T(0.28950000000000004) * U3_13;
  const T N3_2 = T(1.48) * Pddot3_3 - (C4_12 * u.tau_4_1 - u.tau_3_2 + C4_22 * u.tau_4_2 + C4_32 * u.tau_4_3 +
      T(0.515) * Pddot3_1) + T(0.34374999999999994) * U3_13 + T(0.1376) * (t3_13 - t3_15) + T(0.28950000000000004) *
      U3_23 - T(0.10820000000000002) * U3_12;
  const T N3_3 = T(1.1600000000000001) * Pddot3_1 - (C4_13 * u.tau_4_1 - u.tau_3_3 + C4_23 * u.tau_4_2 + C4_33 *
      u.tau_4_3 + T(1.48) * Pddot3_2) - T(0.21199999999999994) * U3_12 + T(0.28950000000000004) * (t3_15 - t3_14) +
      T(0.10820000000000002) * U3_13 - T(0.1376) * U3_23;
  // G4 = -U4 h_all_4: applied less inertia force, body axes [N]
  const T minus_G4_1 = U4_12 * T(1.055) - minus_U4_11 * T(1.07) + U4_13 * T(0.38);
  const T minus_G4_2 = U4_12 * T(1.07) - minus_U4_22 * T(1.055) + U4_23 * T(0.38);
  const T minus_G4_3 = U4_13 * T(1.07) + U4_23 * T(1.055) - minus_U4_33 * T(0.38);

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  // erel5 = -e4~ e5 + eps4_4 e5 - eps4_5 e4: Euler parameters relative to the lower body
  const T erel5_1 = eps4_3 * eps5_2 - eps4_2 * eps5_3 + eps4_4 * eps5_1 - eps5_4 * eps4_1;
  const T erel5_2 = eps4_1 * eps5_3 - eps4_3 * eps5_1 + eps4_4 * eps5_2 - eps5_4 * eps4_2;
  const T erel5_3 = eps4_2 * eps5_1 - eps4_1 * eps5_2 + eps4_4 * eps5_3 - eps5_4 * eps4_3;
  // eps4rel5 = e4 . e5 + eps4_4 eps4_5
  const T eps4rel5 = eps4_1 * eps5_1 + eps4_2 * eps5_2 + eps4_3 * eps5_3 + eps4_4 * eps5_4;
  // C5^T = 1 + 2 erel5~ (eps4rel5 + erel5~): C takes components in the lower body to those in the body
  const T t5_1 = T(2) * erel5_2;
  const T t5_2 = t5_1 * erel5_2;
  const T t5_3 = T(2) * erel5_3;
  const T t5_4 = t5_3 * erel5_3;
  const T C5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * erel5_1;
  const T t5_6 = t5_5 * erel5_2;
  const T t5_7 = t5_3 * eps4rel5;
  const T C5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * erel5_3;
  const T t5_9 = t5_1 * eps4rel5;
  const T C5_13 = t5_8 - t5_9;
  const T C5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * erel5_1;
  const T C5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * erel5_3;
  const T t5_12 = t5_5 * eps4rel5;
  const T C5_23 = t5_11 + t5_12;
  const T C5_31 = t5_8 + t5_9;
  const T C5_32 = t5_11 - t5_12;
  const T C5_33 = t5_10 - t5_2;
  // U5 = omega5~ omega5~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t5_13 = omega5_3 * omega5_3;
  const T t5_14 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_13 + t5_14;
  const T U5_12 = omega5_2 * omega5_1;
  const T U5_13 = omega5_3 * omega5_1;
  const T t5_15 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_13 + t5_15;
  const T U5_23 = omega5_3 * omega5_2;
  const T minus_U5_33 = t5_14 + t5_15;
  // Pddot5 = C5 (U4 q5 + Pddot4): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_16 = Pddot4_1 + U4_12 * T(0.25) - minus_U4_11 * T(0.3) + U4_13 * T(0.1);
  const T t5_17 = Pddot4_2 + U4_12 * T(0.3) - minus_U4_22 * T(0.25) + U4_23 * T(0.1);
  const T t5_18 = Pddot4_3 + U4_13 * T(0.3) + U4_23 * T(0.25) - minus_U4_33 * T(0.1);
  const T Pddot5_1 = C5_11 * t5_16 + C5_12 * t5_17 + C5_13 * t5_18;
  const T Pddot5_2 = C5_21 * t5_16 + C5_22 * t5_17 + C5_23 * t5_18;
  const T Pddot5_3 = C5_31 * t5_16 + C5_32 * t5_17 + C5_33 * t5_18;
  // N4 = -C5^T M_torque_5_ - h_all_4~ Pddot4 - omega4~ J_all_4 omega4 + M_torque_4_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N4_1 = T(0.38) * Pddot4_2 - (C5_11 * u.tau_5_1 - u.tau_4_1 + C5_21 * u.tau_5_2 + C5_31 * u.tau_5_3 +
      T(1.055) * Pddot4_3) - T(0.15925) * U4_23 + T(0.0971) * (t4_14 - t4_13) + T(0.09580000000000001) * U4_12 -
      T(0.2535) * U4_13;
  const T N4_2 = T(1.07) * Pddot4_3 - (C5_12 * u.tau_5_1 - u.tau_4_2 + C5_22 * u.tau_5_2 + C5_32 * u.tau_5_3 + T(0.38)
      * Pddot4_1) + T(0.23049999999999998) * U4_13 + T(0.09580000000000001) * (t4_13 - t4_15) + T(0.2535) * U4_23 -
      T(0.0971) * U4_12;
  const T N4_3 = T(1.055) * Pddot4_1 - (C5_13 * u.tau_5_1 - u.tau_4_3 + C5_23 * u.tau_5_2 + C5_33 * u.tau_5_3 +
      T(1.07) * Pddot4_2) - T(0.07124999999999998) * U4_12 + T(0.2535) * (t4_15 - t4_14) + T(0.0971) * U4_13 -
      T(0.09580000000000001) * U4_23;
  // G5 = -U5 h_all_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = U5_12 * T(0.78) - minus_U5_11 * T(0.63) + U5_13 * T(0.23500000000000001);
  const T minus_G5_2 = U5_12 * T(0.63) - minus_U5_22 * T(0.78) + U5_23 * T(0.23500000000000001);
  const T minus_G5_3 = U5_13 * T(0.63) + U5_23 * T(0.78) - minus_U5_33 * T(0.23500000000000001);

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  // erel6 = -e5~ e6 + eps4_5 e6 - eps4_6 e5: Euler parameters relative to the lower body
  const T erel6_1 = eps5_3 * eps6_2 - eps5_2 * eps6_3 + eps5_4 * eps6_1 - eps6_4 * eps5_1;
  const T erel6_2 = eps5_1 * eps6_3 - eps5_3 * eps6_1 + eps5_4 * eps6_2 - eps6_4 * eps5_2;
  const T erel6_3 = eps5_2 * eps6_1 - eps5_1 * eps6_2 + eps5_4 * eps6_3 - eps6_4 * eps5_3;
  // eps4rel6 = e5 . e6 + eps4_5 eps4_6
  const T eps4rel6 = eps5_1 * eps6_1 + eps5_2 * eps6_2 + eps5_3 * eps6_3 + eps5_4 * eps6_4;
  // C6^T = 1 + 2 erel6~ (eps4rel6 + erel6~): C takes components in the lower body to those in the body
  const T t6_1 = T(2) * erel6_2;
  const T t6_2 = t6_1 * erel6_2;
  const T t6_3 = T(2) * erel6_3;
  const T t6_4 = t6_3 * erel6_3;
  const T C6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * erel6_1;
  const T t6_6 = t6_5 * erel6_2;
  const T t6_7 = t6_3 * eps4rel6;
  const T C6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * erel6_3;
  const T t6_9 = t6_1 * eps4rel6;
  const T C6_13 = t6_8 - t6_9;
  const T C6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * erel6_1;
  const T C6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * erel6_3;
  const T t6_12 = t6_5 * eps4rel6;
  const T C6_23 = t6_11 + t6_12;
  const T C6_31 = t6_8 + t6_9;
  const T C6_32 = t6_11 - t6_12;
  const T C6_33 = t6_10 - t6_2;
  // U6 = omega6~ omega6~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t6_13 = omega6_3 * omega6_3;
  const T t6_14 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_13 + t6_14;
  const T U6_12 = omega6_2 * omega6_1;
  const T U6_13 = omega6_3 * omega6_1;
  const T t6_15 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_13 + t6_15;
  const T U6_23 = omega6_3 * omega6_2;
  const T minus_U6_33 = t6_14 + t6_15;
  // Pddot6 = C6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t6_16 = U5_12 * T(0.3);
  const T t6_17 = t6_16 + Pddot5_1 - minus_U5_11 * T(0.3) + U5_13 * T(0.1);
  const T t6_18 = t6_16 + Pddot5_2 - minus_U5_22 * T(0.3) + U5_23 * T(0.1);
  const T t6_19 = Pddot5_3 + U5_13 * T(0.3) + U5_23 * T(0.3) - minus_U5_33 * T(0.1);
  const T Pddot6_1 = C6_11 * t6_17 + C6_12 * t6_18 + C6_13 * t6_19;
  const T Pddot6_2 = C6_21 * t6_17 + C6_22 * t6_18 + C6_23 * t6_19;
  const T Pddot6_3 = C6_31 * t6_17 + C6_32 * t6_18 + C6_33 * t6_19;
  // N5 = -C6^T M_torque_6_ - h_all_5~ Pddot5 - omega5~ J_all_5 omega5 + M_torque_5_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N5_1 = T(0.23500000000000001) * Pddot5_2 - (C6_11 * u.tau_6_1 - u.tau_5_1 + C6_21 * u.tau_6_2 + C6_31 *
      u.tau_6_3 + T(0.78) * Pddot5_3) - T(0.12425) * U5_23 + T(0.069) * (t5_14 - t5_13) + T(0.051000000000000004) *
      U5_12 - T(0.1665) * U5_13;
  const T N5_2 = T(0.63) * Pddot5_3 - (C6_12 * u.tau_6_1 - u.tau_5_2 + C6_22 * u.tau_6_2 + C6_32 * u.tau_6_3 +
      T(0.23500000000000001) * Pddot5_1) + T(0.10925) * U5_13 + T(0.051000000000000004) * (t5_13 - t5_15) + T(0.1665)
      * U5_23 - T(0.069) * U5_12;
  const T N5_3 = T(0.78) * Pddot5_1 - (C6_13 * u.tau_6_1 - u.tau_5_3 + C6_23 * u.tau_6_2 + C6_33 * u.tau_6_3 + T(0.63)
      * Pddot5_2) + T(0.015000000000000006) * U5_12 + T(0.1665) * (t5_15 - t5_14) + T(0.069) * U5_13 -
      T(0.051000000000000004) * U5_23;
  // G6 = -U6 h_all_6: applied less inertia force, body axes [N]
  const T minus_G6_1 = U6_12 * T(0.32000000000000006) - minus_U6_11 * T(0.16000000000000003) + U6_13 *
      T(0.08000000000000002);
  const T minus_G6_2 = U6_12 * T(0.16000000000000003) - minus_U6_22 * T(0.32000000000000006) + U6_23 *
      T(0.08000000000000002);
  const T minus_G6_3 = U6_13 * T(0.16000000000000003) + U6_23 * T(0.32000000000000006) - minus_U6_33 *
      T(0.08000000000000002);
  // N6 = -h_all_6~ Pddot6 - omega6~ J_all_6 omega6 + M_torque_6_: applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N6_1 = u.tau_6_1 + T(0.08000000000000002) * Pddot6_2 - T(0.32000000000000006) * Pddot6_3 +
      T(0.003999999999999991) * U6_23 + T(0.022400000000000003) * (t6_14 - t6_13) + T(0.003200000000000002) * U6_12 -
      T(0.024000000000000004) * U6_13;
  const T N6_2 = u.tau_6_2 + T(0.16000000000000003) * Pddot6_3 - T(0.08000000000000002) * Pddot6_1 -
      T(0.019999999999999997) * U6_13 + T(0.003200000000000002) * (t6_13 - t6_15) + T(0.024000000000000004) * U6_23 -
      T(0.022400000000000003) * U6_12;
  const T N6_3 = u.tau_6_3 + T(0.32000000000000006) * Pddot6_1 - T(0.16000000000000003) * Pddot6_2 +
      T(0.016000000000000007) * U6_12 + T(0.024000000000000004) * (t6_15 - t6_14) + T(0.022400000000000003) * U6_13 -
      T(0.003200000000000002) * U6_23;
  f[15] = N6_1;
  f[16] = N6_2;
  f[17] = N6_3;

  // ---- body 5 (body_5) and what it carries
  // S5 = C6^T G6 + G5: sum of the force balances of the subtree, body axes [N]
  const T b5_1 = C6_11 * minus_G6_1 + C6_21 * minus_G6_2 + C6_31 * minus_G6_3;
  const T minus_S5_1 = b5_1 + minus_G5_1;
  const T b5_2 = C6_12 * minus_G6_1 + C6_22 * minus_G6_2 + C6_32 * minus_G6_3;
  const T minus_S5_2 = b5_2 + minus_G5_2;
  const T b5_3 = C6_13 * minus_G6_1 + C6_23 * minus_G6_2 + C6_33 * minus_G6_3;
  const T minus_S5_3 = b5_3 + minus_G5_3;
  // f_omega5 = q6~ C6^T G6 + N5: Kane's equation of omega [N m]
  const T b5_4 = T(0.3) * b5_3;
  const T f_omega5_1 = N5_1 - b5_4 + T(0.1) * b5_2;
  const T f_omega5_2 = b5_4 + N5_2 - T(0.1) * b5_1;
  const T f_omega5_3 = N5_3 + T(0.3) * b5_1 - T(0.3) * b5_2;
  f[12] = f_omega5_1;
  f[13] = f_omega5_2;
  f[14] = f_omega5_3;

  // ---- body 4 (body_4) and what it carries
  // S4 = C5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T b4_1 = C5_11 * minus_S5_1 + C5_21 * minus_S5_2 + C5_31 * minus_S5_3;
  const T minus_S4_1 = b4_1 + minus_G4_1;
  const T b4_2 = C5_12 * minus_S5_1 + C5_22 * minus_S5_2 + C5_32 * minus_S5_3;
  const T minus_S4_2 = b4_2 + minus_G4_2;
  const T b4_3 = C5_13 * minus_S5_1 + C5_23 * minus_S5_2 + C5_33 * minus_S5_3;
  const T minus_S4_3 = b4_3 + minus_G4_3;
  // f_omega4 = q5~ C5^T S5 + N4: Kane's equation of omega [N m]
  const T f_omega4_1 = N4_1 + T(0.1) * b4_2 - T(0.25) * b4_3;
  const T f_omega4_2 = N4_2 + T(0.3) * b4_3 - T(0.1) * b4_1;
  const T f_omega4_3 = N4_3 + T(0.25) * b4_1 - T(0.3) * b4_2;
  f[9] = f_omega4_1;
  f[10] = f_omega4_2;
  f[11] = f_omega4_3;

  // ---- body 3 (body_3) and what it carries
  // S3 = C4^T S4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = C4_11 * minus_S4_1 + C4_21 * minus_S4_2 + C4_31 * minus_S4_3;
  const T minus_S3_1 = b3_1 + minus_G3_1;
  const T b3_2 = C4_12 * minus_S4_1 + C4_22 * minus_S4_2 + C4_32 * minus_S4_3;
  const T minus_S3_2 = b3_2 + minus_G3_2;
  const T b3_3 = C4_13 * minus_S4_1 + C4_23 * minus_S4_2 + C4_33 * minus_S4_3;
  const T minus_S3_3 = b3_3 + minus_G3_3;
  // f_omega3 = q4~ C4^T S4 + N3: Kane's equation of omega [N m]
  const T f_omega3_1 = N3_1 + T(0.1) * b3_2 - T(0.2) * b3_3;
  const T f_omega3_2 = N3_2 + T(0.3) * b3_3 - T(0.1) * b3_1;
  const T f_omega3_3 = N3_3 + T(0.2) * b3_1 - T(0.3) * b3_2;
  f[6] = f_omega3_1;
  f[7] = f_omega3_2;
  f[8] = f_omega3_3;

  // ---- body 2 (body_2) and what it carries
  // S2 = C3^T S3 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = C3_11 * minus_S3_1 + C3_21 * minus_S3_2 + C3_31 * minus_S3_3;
  const T minus_S2_1 = b2_1 + minus_G2_1;
  const T b2_2 = C3_12 * minus_S3_1 + C3_22 * minus_S3_2 + C3_32 * minus_S3_3;
  const T minus_S2_2 = b2_2 + minus_G2_2;
  const T b2_3 = C3_13 * minus_S3_1 + C3_23 * minus_S3_2 + C3_33 * minus_S3_3;
  const T minus_S2_3 = b2_3 + minus_G2_3;
  // f_omega2 = q3~ C3^T S3 + N2: Kane's equation of omega [N m]
  const T f_omega2_1 = N2_1 + T(0.1) * b2_2 - T(0.15) * b2_3;
  const T f_omega2_2 = N2_2 + T(0.3) * b2_3 - T(0.1) * b2_1;
  const T f_omega2_3 = N2_3 + T(0.15) * b2_1 - T(0.3) * b2_2;
  f[3] = f_omega2_1;
  f[4] = f_omega2_2;
  f[5] = f_omega2_3;

  // ---- body 1 (body_1) and what it carries
  // f_omega1 = q2~ C2^T S2 + N1: Kane's equation of omega [N m]
  const T b1_1 = C2_12 * minus_S2_1 + C2_22 * minus_S2_2 + C2_32 * minus_S2_3;
  const T b1_2 = C2_13 * minus_S2_1 + C2_23 * minus_S2_2 + C2_33 * minus_S2_3;
  const T f_omega1_1 = N1_1 + T(0.1) * b1_1 - T(0.1) * b1_2;
  const T b1_3 = T(0.1) * (C2_11 * minus_S2_1 + C2_21 * minus_S2_2 + C2_31 * minus_S2_3);
  const T f_omega1_2 = N1_2 - b1_3 + T(0.3) * b1_2;
  const T f_omega1_3 = b1_3 + N1_3 - T(0.3) * b1_1;
  f[0] = f_omega1_1;
  f[1] = f_omega1_2;
  f[2] = f_omega1_3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 475 add, 752 multiply
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {

  // ---- body 2 (body_2) on body 1
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  // erel2 = -e1~ e2 + eps4_1 e2 - eps4_2 e1: Euler parameters relative to the lower body
  const T erel2_1 = eps1_3 * eps2_2 - eps1_2 * eps2_3 + eps1_4 * eps2_1 - eps2_4 * eps1_1;
  const T erel2_2 = eps1_1 * eps2_3 - eps1_3 * eps2_1 + eps1_4 * eps2_2 - eps2_4 * eps1_2;
  const T erel2_3 = eps1_2 * eps2_1 - eps1_1 * eps2_2 + eps1_4 * eps2_3 - eps2_4 * eps1_3;
  // eps4rel2 = e1 . e2 + eps4_1 eps4_2
  const T eps4rel2 = eps1_1 * eps2_1 + eps1_2 * eps2_2 + eps1_3 * eps2_3 + eps1_4 * eps2_4;
  // C2^T = 1 + 2 erel2~ (eps4rel2 + erel2~): C takes components in the lower body to those in the body
  const T t2_1 = T(2) * erel2_2;
  const T t2_2 = t2_1 * erel2_2;
  const T t2_3 = T(2) * erel2_3;
  const T t2_4 = t2_3 * erel2_3;
  const T C2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * erel2_1;
  const T t2_6 = t2_5 * erel2_2;
  const T t2_7 = t2_3 * eps4rel2;
  const T C2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * erel2_3;
  const T t2_9 = t2_1 * eps4rel2;
  const T C2_13 = t2_8 - t2_9;
  const T C2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * erel2_1;
  const T C2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * erel2_3;
  const T t2_12 = t2_5 * eps4rel2;
  const T C2_23 = t2_11 + t2_12;
  const T C2_31 = t2_8 + t2_9;
  const T C2_32 = t2_11 - t2_12;
  const T C2_33 = t2_10 - t2_2;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  // erel3 = -e2~ e3 + eps4_2 e3 - eps4_3 e2: Euler parameters relative to the lower body
  const T erel3_1 = eps2_3 * eps3_2 - eps2_2 * eps3_3 + eps2_4 * eps3_1 - eps3_4 * eps2_1;
  const T erel3_2 = eps2_1 * eps3_3 - eps2_3 * eps3_1 + eps2_4 * eps3_2 - eps3_4 * eps2_2;
  const T erel3_3 = eps2_2 * eps3_1 - eps2_1 * eps3_2 + eps2_4 * eps3_3 - eps3_4 * eps2_3;
  // eps4rel3 = e2 . e3 + eps4_2 eps4_3
  const T eps4rel3 = eps2_1 * eps3_1 + eps2_2 * eps3_2 + eps2_3 * eps3_3 + eps2_4 * eps3_4;
  // C3^T = 1 + 2 erel3~ (eps4rel3 + erel3~): C takes components in the lower body to those in the body
  const T t3_1 = T(2) * erel3_2;
  const T t3_2 = t3_1 * erel3_2;
  const T t3_3 = T(2) * erel3_3;
  const T t3_4 = t3_3 * erel3_3;
  const T C3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * erel3_1;
  const T t3_6 = t3_5 * erel3_2;
  const T t3_7 = t3_3 * eps4rel3;
  const T C3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * erel3_3;
  const T t3_9 = t3_1 * eps4rel3;
  const T C3_13 = t3_8 - t3_9;
  const T C3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * erel3_1;
  const T C3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * erel3_3;
  const T t3_12 = t3_5 * eps4rel3;
  const T C3_23 = t3_11 + t3_12;
  const T C3_31 = t3_8 + t3_9;
  const T C3_32 = t3_11 - t3_12;
  const T C3_33 = t3_10 - t3_2;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  // erel4 = -e3~ e4 + eps4_3 e4 - eps4_4 e3: Euler parameters relative to the lower body
  const T erel4_1 = eps3_3 * eps4_2 - eps3_2 * eps4_3 + eps3_4 * eps4_1 - eps4_4 * eps3_1;
  const T erel4_2 = eps3_1 * eps4_3 - eps3_3 * eps4_1 + eps3_4 * eps4_2 - eps4_4 * eps3_2;
  const T erel4_3 = eps3_2 * eps4_1 - eps3_1 * eps4_2 + eps3_4 * eps4_3 - eps4_4 * eps3_3;
  // eps4rel4 = e3 . e4 + eps4_3 eps4_4
  const T eps4rel4 = eps3_1 * eps4_1 + eps3_2 * eps4_2 + eps3_3 * eps4_3 + eps3_4 * eps4_4;
  // C4^T = 1 + 2 erel4~ (eps4rel4 + erel4~): C takes components in the lower body to those in the body
  const T t4_1 = T(2) * erel4_2;
  const T t4_2 = t4_1 * erel4_2;
  const T t4_3 = T(2) * erel4_3;
  const T t4_4 = t4_3 * erel4_3;
  const T C4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * erel4_1;
  const T t4_6 = t4_5 * erel4_2;
  const T t4_7 = t4_3 * eps4rel4;
  const T C4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * erel4_3;
  const T t4_9 = t4_1 * eps4rel4;
  const T C4_13 = t4_8 - t4_9;
  const T C4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * erel4_1;
  const T C4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * erel4_3;
  const T t4_12 = t4_5 * eps4rel4;
  const T C4_23 = t4_11 + t4_12;
  const T C4_31 = t4_8 + t4_9;
  const T C4_32 = t4_11 - t4_12;
  const T C4_33 = t4_10 - t4_2;

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  // erel5 = -e4~ e5 + eps4_4 e5 - eps4_5 e4: Euler parameters relative to the lower body
  const T erel5_1 = eps4_3 * eps5_2 - eps4_2 * eps5_3 + eps4_4 * eps5_1 - eps5_4 * eps4_1;
  const T erel5_2 = eps4_1 * eps5_3 - eps4_3 * eps5_1 + eps4_4 * eps5_2 - eps5_4 * eps4_2;
  const T erel5_3 = eps4_2 * eps5_1 - eps4_1 * eps5_2 + eps4_4 * eps5_3 - eps5_4 * eps4_3;
  // eps4rel5 = e4 . e5 + eps4_4 eps4_5
  const T eps4rel5 = eps4_1 * eps5_1 + eps4_2 * eps5_2 + eps4_3 * eps5_3 + eps4_4 * eps5_4;
  // C5^T = 1 + 2 erel5~ (eps4rel5 + erel5~): C takes components in the lower body to those in the body
  const T t5_1 = T(2) * erel5_2;
  const T t5_2 = t5_1 * erel5_2;
  const T t5_3 = T(2) * erel5_3;
  const T t5_4 = t5_3 * erel5_3;
  const T C5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * erel5_1;
  const T t5_6 = t5_5 * erel5_2;
  const T t5_7 = t5_3 * eps4rel5;
  const T C5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * erel5_3;
  const T t5_9 = t5_1 * eps4rel5;
  const T C5_13 = t5_8 - t5_9;
  const T C5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * erel5_1;
  const T C5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * erel5_3;
  const T t5_12 = t5_5 * eps4rel5;
  const T C5_23 = t5_11 + t5_12;
  const T C5_31 = t5_8 + t5_9;
  const T C5_32 = t5_11 - t5_12;
  const T C5_33 = t5_10 - t5_2;

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  // erel6 = -e5~ e6 + eps4_5 e6 - eps4_6 e5: Euler parameters relative to the lower body
  const T erel6_1 = eps5_3 * eps6_2 - eps5_2 * eps6_3 + eps5_4 * eps6_1 - eps6_4 * eps5_1;
  const T erel6_2 = eps5_1 * eps6_3 - eps5_3 * eps6_1 + eps5_4 * eps6_2 - eps6_4 * eps5_2;
  const T erel6_3 = eps5_2 * eps6_1 - eps5_1 * eps6_2 + eps5_4 * eps6_3 - eps6_4 * eps5_3;
  // eps4rel6 = e5 . e6 + eps4_5 eps4_6
  const T eps4rel6 = eps5_1 * eps6_1 + eps5_2 * eps6_2 + eps5_3 * eps6_3 + eps5_4 * eps6_4;
  // C6^T = 1 + 2 erel6~ (eps4rel6 + erel6~): C takes components in the lower body to those in the body
  const T t6_1 = T(2) * erel6_2;
  const T t6_2 = t6_1 * erel6_2;
  const T t6_3 = T(2) * erel6_3;
  const T t6_4 = t6_3 * erel6_3;
  const T C6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * erel6_1;
  const T t6_6 = t6_5 * erel6_2;
  const T t6_7 = t6_3 * eps4rel6;
  const T C6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * erel6_3;
  const T t6_9 = t6_1 * eps4rel6;
  const T C6_13 = t6_8 - t6_9;
  const T C6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * erel6_1;
  const T C6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * erel6_3;
  const T t6_12 = t6_5 * eps4rel6;
  const T C6_23 = t6_11 + t6_12;
  const T C6_31 = t6_8 + t6_9;
  const T C6_32 = t6_11 - t6_12;
  const T C6_33 = t6_10 - t6_2;

  // ---- results
  A[0] = T(0.29675);
  A[1] = -T(0.2265);
  A[18] = -T(0.2265);
  A[2] = -T(0.2122);
  A[36] = -T(0.2122);
  const T t1 = C2_23 * T(0.64) - C2_33 * T(1.1099999999999999);
  const T t2 = C2_22 * T(0.64) - C2_32 * T(1.1099999999999999);
  const T t3 = T(0.1) * t1 - T(0.1) * t2;
  A[3] = -t3;
  A[54] = -t3;
  const T t4 = C2_33 * T(1.8599999999999999) - C2_13 * T(0.64);
  const T t5 = C2_32 * T(1.8599999999999999) - C2_12 * T(0.64);
  const T t6 = T(0.1) * t4 - T(0.1) * t5;
  A[4] = -t6;
  A[72] = -t6;
  const T t7 = C2_13 * T(1.1099999999999999) - C2_23 * T(1.8599999999999999);
  const T t8 = C2_12 * T(1.1099999999999999) - C2_22 * T(1.8599999999999999);
  const T t9 = T(0.1) * t7 - T(0.1) * t8;
  A[5] = -t9;
  A[90] = -t9;
  const T t10 = C3_21 * T(0.515) - C3_31 * T(1.1600000000000001);
  const T t11 = C3_22 * T(0.515) - C3_32 * T(1.1600000000000001);
  const T t12 = C3_23 * T(0.515) - C3_33 * T(1.1600000000000001);
  const T t13 = C2_13 * t10 + C2_23 * t11 + C2_33 * t12;
  const T t14 = C2_12 * t10 + C2_22 * t11 + C2_32 * t12;
  const T t15 = T(0.1) * t13 - T(0.1) * t14;
  A[6] = -t15;
  A[108] = -t15;
  const T t16 = C3_31 * T(1.48) - C3_11 * T(0.515);
  const T t17 = C3_32 * T(1.48) - C3_12 * T(0.515);
  const T t18 = C3_33 * T(1.48) - C3_13 * T(0.515);
  const T t19 = C2_13 * t16 + C2_23 * t17 + C2_33 * t18;
  const T t20 = C2_12 * t16 + C2_22 * t17 + C2_32 * t18;
  const T t21 = T(0.1) * t19 - T(0.1) * t20;
  A[7] = -t21;
  A[126] = -t21;
  const T t22 = C3_11 * T(1.1600000000000001) - C3_21 * T(1.48);
  const T t23 = C3_12 * T(1.1600000000000001) - C3_22 * T(1.48);
  const T t24 = C3_13 * T(1.1600000000000001) - C3_23 * T(1.48);
  const T t25 = C2_13 * t22 + C2_23 * t23 + C2_33 * t24;
  const T t26 = C2_12 * t22 + C2_22 * t23 + C2_32 * t24;
  const T t27 = T(0.1) * t25 - T(0.1) * t26;
  A[8] = -t27;
  A[144] = -t27;
  const T t28 = C4_21 * T(0.38) - C4_31 * T(1.055);
  const T t29 = C4_22 * T(0.38) - C4_32 * T(1.055);
  const T t30 = C4_23 * T(0.38) - C4_33 * T(1.055);
  const T t31 = C3_11 * t28 + C3_21 * t29 + C3_31 * t30;
  const T t32 = C3_12 * t28 + C3_22 * t29 + C3_32 * t30;
  const T t33 = C3_13 * t28 + C3_23 * t29 + C3_33 * t30;
  const T t34 = C2_13 * t31 + C2_23 * t32 + C2_33 * t33;
  const T t35 = C2_12 * t31 + C2_22 * t32 + C2_32 * t33;
  const T t36 = T(0.1) * t34 - T(0.1) * t35;
  A[9] = -t36;
  A[162] = -t36;
  const T t37 = C4_31 * T(1.07) - C4_11 * T(0.38);
  const T t38 = C4_32 * T(1.07) - C4_12 * T(0.38);
  const T t39 = C4_33 * T(1.07) - C4_13 * T(0.38);
  const T t40 = C3_11 * t37 + C3_21 * t38 + C3_31 * t39;
  const T t41 = C3_12 * t37 + C3_22 * t38 + C3_32 * t39;
  const T t42 = C3_13 * t37 + C3_23 * t38 + C3_33 * t39;
  const T t43 = C2_13 * t40 + C2_23 * t41 + C2_33 * t42;
  const T t44 = C2_12 * t40 + C2_22 * t41 + C2_32 * t42;
  const T t45 = T(0.1) * t43 - T(0.1) * t44;
  A[10] = -t45;
  A[180] = -t45;
  const T t46 = C4_11 * T(1.055) - C4_21 * T(1.07);
  const T t47 = C4_12 * T(1.055) - C4_22 * T(1.07);
  const T t48 = C4_13 * T(1.055) - C4_23 * T(1.07);
  const T t49 = C3_11 * t46 + C3_21 * t47 + C3_31 * t48;
  const T t50 = C3_12 * t46 + C3_22 * t47 + C3_32 * t48;
  const T t51 = C3_13 * t46 + C3_23 * t47 + C3_33 * t48;
  const T t52 = C2_13 * t49 + C2_23 * t50 + C2_33 * t51;
  const T t53 = C2_12 * t49 + C2_22 * t50 + C2_32 * t51;
  const T t54 = T(0.1) * t52 - T(0.1) * t53;
  A[11] = -t54;
  A[198] = -t54;
  const T t55 = C5_21 * T(0.23500000000000001) - C5_31 * T(0.78);
  const T t56 = C5_22 * T(0.23500000000000001) - C5_32 * T(0.78);
  const T t57 = C5_23 * T(0.23500000000000001) - C5_33 * T(0.78);
  const T t58 = C4_11 * t55 + C4_21 * t56 + C4_31 * t57;
  const T t59 = C4_12 * t55 + C4_22 * t56 + C4_32 * t57;
  const T t60 = C4_13 * t55 + C4_23 * t56 + C4_33 * t57;
  const T t61 = C3_11 * t58 + C3_21 * t59 + C3_31 * t60;
  const T t62 = C3_12 * t58 + C3_22 * t59 + C3_32 * t60;
  const T t63 = C3_13 * t58 + C3_23 * t59 + C3_33 * t60;
  const T t64 = C2_13 * t61 + C2_23 * t62 + C2_33 * t63;
  const T t65 = C2_12 * t61 + C2_22 * t62 + C2_32 * t63;
  const T t66 = T(0.1) * t64 - T(0.1) * t65;
  A[12] = -t66;
  A[216] = -t66;
  const T t67 = C5_31 * T(0.63) - C5_11 * T(0.23500000000000001);
  const T t68 = C5_32 * T(0.63) - C5_12 * T(0.23500000000000001);
  const T t69 = C5_33 * T(0.63) - C5_13 * T(0.23500000000000001);
  const T t70 = C4_11 * t67 + C4_21 * t68 + C4_31 * t69;
  const T t71 = C4_12 * t67 + C4_22 * t68 + C4_32 * t69;
  const T t72 = C4_13 * t67 + C4_23 * t68 + C4_33 * t69;
  const T t73 = C3_11 * t70 + C3_21 * t71 + C3_31 * t72;
  const T t74 = C3_12 * t70 + C3_22 * t71 + C3_32 * t72;
  const T t75 = C3_13 * t70 + C3_23 * t71 + C3_33 * t72;
  const T t76 = C2_13 * t73 + C2_23 * t74 + C2_33 * t75;
  const T t77 = C2_12 * t73 + C2_22 * t74 + C2_32 * t75;
  const T t78 = T(0.1) * t76 - T(0.1) * t77;
  A[13] = -t78;
  A[234] = -t78;
  const T t79 = C5_11 * T(0.78) - C5_21 * T(0.63);
  const T t80 = C5_12 * T(0.78) - C5_22 * T(0.63);
  const T t81 = C5_13 * T(0.78) - C5_23 * T(0.63);
  const T t82 = C4_11 * t79 + C4_21 * t80 + C4_31 * t81;
  const T t83 = C4_12 * t79 + C4_22 * t80 + C4_32 * t81;
  const T t84 = C4_13 * t79 + C4_23 * t80 + C4_33 * t81;
  const T t85 = C3_11 * t82 + C3_21 * t83 + C3_31 * t84;
  const T t86 = C3_12 * t82 + C3_22 * t83 + C3_32 * t84;
  const T t87 = C3_13 * t82 + C3_23 * t83 + C3_33 * t84;
  const T t88 = C2_13 * t85 + C2_23 * t86 + C2_33 * t87;
  const T t89 = C2_12 * t85 + C2_22 * t86 + C2_32 * t87;
  const T t90 = T(0.1) * t88 - T(0.1) * t89;
  A[14] = -t90;
  A[252] = -t90;
  const T t91 = C6_21 * T(0.08000000000000002) - C6_31 * T(0.32000000000000006);
  const T t92 = C6_22 * T(0.08000000000000002) - C6_32 * T(0.32000000000000006);
  const T t93 = C6_23 * T(0.08000000000000002) - C6_33 * T(0.32000000000000006);
  const T t94 = C5_11 * t91 + C5_21 * t92 + C5_31 * t93;
  const T t95 = C5_12 * t91 + C5_22 * t92 + C5_32 * t93;
  const T t96 = C5_13 * t91 + C5_23 * t92 + C5_33 * t93;
  const T t97 = C4_11 * t94 + C4_21 * t95 + C4_31 * t96;
  const T t98 = C4_12 * t94 + C4_22 * t95 + C4_32 * t96;
  const T t99 = C4_13 * t94 + C4_23 * t95 + C4_33 * t96;
  const T t100 = C3_11 * t97 + C3_21 * t98 + C3_31 * t99;
  const T t101 = C3_12 * t97 + C3_22 * t98 + C3_32 * t99;
  const T t102 = C3_13 * t97 + C3_23 * t98 + C3_33 * t99;
  const T t103 = C2_13 * t100 + C2_23 * t101 + C2_33 * t102;
  const T t104 = C2_12 * t100 + C2_22 * t101 + C2_32 * t102;
  const T t105 = T(0.1) * t103 - T(0.1) * t104;
  A[15] = -t105;
  A[270] = -t105;
  const T t106 = C6_31 * T(0.16000000000000003) - C6_11 * T(0.08000000000000002);
  const T t107 = C6_32 * T(0.16000000000000003) - C6_12 * T(0.08000000000000002);
  const T t108 = C6_33 * T(0.16000000000000003) - C6_13 * T(0.08000000000000002);
  const T t109 = C5_11 * t106 + C5_21 * t107 + C5_31 * t108;
  const T t110 = C5_12 * t106 + C5_22 * t107 + C5_32 * t108;
  const T t111 = C5_13 * t106 + C5_23 * t107 + C5_33 * t108;
  const T t112 = C4_11 * t109 + C4_21 * t110 + C4_31 * t111;
  const T t113 = C4_12 * t109 + C4_22 * t110 + C4_32 * t111;
  const T t114 = C4_13 * t109 + C4_23 * t110 + C4_33 * t111;
  const T t115 = C3_11 * t112 + C3_21 * t113 + C3_31 * t114;
  const T t116 = C3_12 * t112 + C3_22 * t113 + C3_32 * t114;
  const T t117 = C3_13 * t112 + C3_23 * t113 + C3_33 * t114;
  const T t118 = C2_13 * t115 + C2_23 * t116 + C2_33 * t117;
  const T t119 = C2_12 * t115 + C2_22 * t116 + C2_32 * t117;
  const T t120 = T(0.1) * t118 - T(0.1) * t119;
  A[16] = -t120;
  A[288] = -t120;
  const T t121 = C6_11 * T(0.32000000000000006) - C6_21 * T(0.16000000000000003);
  const T t122 = C6_12 * T(0.32000000000000006) - C6_22 * T(0.16000000000000003);
  const T t123 = C6_13 * T(0.32000000000000006) - C6_23 * T(0.16000000000000003);
  const T t124 = C5_11 * t121 + C5_21 * t122 + C5_31 * t123;
  const T t125 = C5_12 * t121 + C5_22 * t122 + C5_32 * t123;
  const T t126 = C5_13 * t121 + C5_23 * t122 + C5_33 * t123;
  const T t127 = C4_11 * t124 + C4_21 * t125 + C4_31 * t126;
  const T t128 = C4_12 * t124 + C4_22 * t125 + C4_32 * t126;
  const T t129 = C4_13 * t124 + C4_23 * t125 + C4_33 * t126;
  const T t130 = C3_11 * t127 + C3_21 * t128 + C3_31 * t129;
  const T t131 = C3_12 * t127 + C3_22 * t128 + C3_32 * t129;
  const T t132 = C3_13 * t127 + C3_23 * t128 + C3_33 * t129;
  const T t133 = C2_13 * t130 + C2_23 * t131 + C2_33 * t132;
  const T t134 = C2_12 * t130 + C2_22 * t131 + C2_32 * t132;
  const T t135 = T(0.1) * t133 - T(0.1) * t134;
  A[17] = -t135;
  A[306] = -t135;
  A[19] = T(0.84575);
  A[20] = -T(0.0854);
  A[37] = -T(0.0854);
  const T t136 = T(0.1) * (C2_21 * T(0.64) - C2_31 * T(1.1099999999999999));
  const T t137 = t136 - T(0.3) * t1;
  A[21] = -t137;
  A[55] = -t137;
  const T t138 = T(0.1) * (C2_31 * T(1.8599999999999999) - C2_11 * T(0.64));
  const T t139 = t138 - T(0.3) * t4;
  A[22] = -t139;
  A[73] = -t139;
  const T t140 = T(0.1) * (C2_11 * T(1.1099999999999999) - C2_21 * T(1.8599999999999999));
  const T t141 = t140 - T(0.3) * t7;
  A[23] = -t141;
  A[91] = -t141;
  const T t142 = T(0.1) * (C2_11 * t10 + C2_21 * t11 + C2_31 * t12);
  const T t143 = t142 - T(0.3) * t13;
  A[24] = -t143;
  A[109] = -t143;
  const T t144 = T(0.1) * (C2_11 * t16 + C2_21 * t17 + C2_31 * t18);
  const T t145 = t144 - T(0.3) * t19;
  A[25] = -t145;
  A[127] = -t145;
  const T t146 = T(0.1) * (C2_11 * t22 + C2_21 * t23 + C2_31 * t24);
  const T t147 = t146 - T(0.3) * t25;
  A[26] = -t147;
  A[145] = -t147;
  const T t148 = T(0.1) * (C2_11 * t31 + C2_21 * t32 + C2_31 * t33);
  const T t149 = t148 - T(0.3) * t34;
  A[27] = -t149;
  A[163] = -t149;
  const T t150 = T(0.1) * (C2_11 * t40 + C2_21 * t41 + C2_31 * t42);
  const T t151 = t150 - T(0.3) * t43;
  A[28] = -t151;
  A[181] = -t151;
  const T t152 = T(0.1) * (C2_11 * t49 + C2_21 * t50 + C2_31 * t51);
  const T t153 = t152 - T(0.3) * t52;
  A[29] = -t153;
  A[199] = -t153;
  const T t154 = T(0.1) * (C2_11 * t61 + C2_21 * t62 + C2_31 * t63);
  const T t155 = t154 - T(0.3) * t64;
  A[30] = -t155;
  A[217] = -t155;
  const T t156 = T(0.1) * (C2_11 * t73 + C2_21 * t74 + C2_31 * t75);
  const T t157 = t156 - T(0.3) * t76;
  A[31] = -t157;
  A[235] = -t157;
  const T t158 = T(0.1) * (C2_11 * t85 + C2_21 * t86 + C2_31 * t87);
  const T t159 = t158 - T(0.3) * t88;
  A[32] = -t159;
  A[253] = -t159;
  const T t160 = T(0.1) * (C2_11 * t100 + C2_21 * t101 + C2_31 * t102);
  const T t161 = t160 - T(0.3) * t103;
  A[33] = -t161;
  A[271] = -t161;
  const T t162 = T(0.1) * (C2_11 * t115 + C2_21 * t116 + C2_31 * t117);
  const T t163 = t162 - T(0.3) * t118;
  A[34] = -t163;
  A[289] = -t163;
  const T t164 = T(0.1) * (C2_11 * t130 + C2_21 * t131 + C2_31 * t132);
  const T t165 = t164 - T(0.3) * t133;
  A[35] = -t165;
  A[307] = -t165;
  A[38] = T(0.843);
  const T t166 = T(0.3) * t2 - t136;
  A[39] = -t166;
  A[56] = -t166;
  const T t167 = T(0.3) * t5 - t138;
  A[40] = -t167;
  A[74] = -t167;
  const T t168 = T(0.3) * t8 - t140;
  A[41] = -t168;
  A[92] = -t168;
  const T t169 = T(0.3) * t14 - t142;
  A[42] = -t169;
  A[110] = -t169;
  const T t170 = T(0.3) * t20 - t144;
  A[43] = -t170;
  A[128] = -t170;
  const T t171 = T(0.3) * t26 - t146;
  A[44] = -t171;
  A[146] = -t171;
  const T t172 = T(0.3) * t35 - t148;
  A[45] = -t172;
  A[164] = -t172;
  const T t173 = T(0.3) * t44 - t150;
  A[46] = -t173;
  A[182] = -t173;
  const T t174 = T(0.3) * t53 - t152;
  A[47] = -t174;
  A[200] = -t174;
  const T t175 = T(0.3) * t65 - t154;
  A[48] = -t175;
  A[218] = -t175;
  const T t176 = T(0.3) * t77 - t156;
  A[49] = -t176;
  A[236] = -t176;
  const T t177 = T(0.3) * t89 - t158;
  A[50] = -t177;
  A[254] = -t177;
  const T t178 = T(0.3) * t104 - t160;
  A[51] = -t178;
  A[272] = -t178;
  const T t179 = T(0.3) * t119 - t162;
  A[52] = -t179;
  A[290] = -t179;
  const T t180 = T(0.3) * t134 - t164;
  A[53] = -t180;
  A[308] = -t180;
  A[57] = T(0.3595);
  A[58] = -T(0.27899999999999997);
  A[75] = -T(0.27899999999999997);
  A[59] = -T(0.1764);
  A[93] = -T(0.1764);
  const T t181 = T(0.15) * t12 - T(0.1) * t11;
  A[60] = -t181;
  A[111] = -t181;
  const T t182 = T(0.15) * t18 - T(0.1) * t17;
  A[61] = -t182;
  A[129] = -t182;
  const T t183 = T(0.15) * t24 - T(0.1) * t23;
  A[62] = -t183;
  A[147] = -t183;
  const T t184 = T(0.15) * t33 - T(0.1) * t32;
  A[63] = -t184;
  A[165] = -t184;
  const T t185 = T(0.15) * t42 - T(0.1) * t41;
  A[64] = -t185;
  A[183] = -t185;
  const T t186 = T(0.15) * t51 - T(0.1) * t50;
  A[65] = -t186;
  A[201] = -t186;
  const T t187 = T(0.15) * t63 - T(0.1) * t62;
  A[66] = -t187;
  A[219] = -t187;
  const T t188 = T(0.15) * t75 - T(0.1) * t74;
  A[67] = -t188;
  A[237] = -t188;
  const T t189 = T(0.15) * t87 - T(0.1) * t86;
  A[68] = -t189;
  A[255] = -t189;
  const T t190 = T(0.15) * t102 - T(0.1) * t101;
  A[69] = -t190;
  A[273] = -t190;
  const T t191 = T(0.15) * t117 - T(0.1) * t116;
  A[70] = -t191;
  A[291] = -t191;
  const T t192 = T(0.15) * t132 - T(0.1) * t131;
  A[71] = -t192;
  A[309] = -t192;
  A[76] = T(0.739);
  A[77] = -T(0.1038);
  A[94] = -T(0.1038);
  const T t193 = T(0.1) * t10 - T(0.3) * t12;
  A[78] = -t193;
  A[112] = -t193;
  const T t194 = T(0.1) * t16 - T(0.3) * t18;
  A[79] = -t194;
  A[130] = -t194;
  const T t195 = T(0.1) * t22 - T(0.3) * t24;
  A[80] = -t195;
  A[148] = -t195;
  const T t196 = T(0.1) * t31 - T(0.3) * t33;
  A[81] = -t196;
  A[166] = -t196;
  const T t197 = T(0.1) * t40 - T(0.3) * t42;
  A[82] = -t197;
  A[184] = -t197;
  const T t198 = T(0.1) * t49 - T(0.3) * t51;
  A[83] = -t198;
  A[202] = -t198;
  const T t199 = T(0.1) * t61 - T(0.3) * t63;
  A[84] = -t199;
  A[220] = -t199;
  const T t200 = T(0.1) * t73 - T(0.3) * t75;
  A[85] = -t200;
  A[238] = -t200;
  const T t201 = T(0.1) * t85 - T(0.3) * t87;
  A[86] = -t201;
  A[256] = -t201;
  const T t202 = T(0.1) * t100 - T(0.3) * t102;
  A[87] = -t202;
  A[274] = -t202;
  const T t203 = T(0.1) * t115 - T(0.3) * t117;
  A[88] = -t203;
  A[292] = -t203;
  const T t204 = T(0.1) * t130 - T(0.3) * t132;
  A[89] = -t204;
  A[310] = -t204;
  A[95] = T(0.8085);
  const T t205 = T(0.3) * t11 - T(0.15) * t10;
  A[96] = -t205;
  A[113] = -t205;
  const T t206 = T(0.3) * t17 - T(0.15) * t16;
  A[97] = -t206;
  A[131] = -t206;
  const T t207 = T(0.3) * t23 - T(0.15) * t22;
  A[98] = -t207;
  A[149] = -t207;
  const T t208 = T(0.3) * t32 - T(0.15) * t31;
  A[99] = -t208;
  A[167] = -t208;
  const T t209 = T(0.3) * t41 - T(0.15) * t40;
  A[100] = -t209;
  A[185] = -t209;
  const T t210 = T(0.3) * t50 - T(0.15) * t49;
  A[101] = -t210;
  A[203] = -t210;
  const T t211 = T(0.3) * t62 - T(0.15) * t61;
  A[102] = -t211;
  A[221] = -t211;
  const T t212 = T(0.3) * t74 - T(0.15) * t73;
  A[103] = -t212;
  A[239] = -t212;
  const T t213 = T(0.3) * t86 - T(0.15) * t85;
  A[104] = -t213;
  A[257] = -t213;
  const T t214 = T(0.3) * t101 - T(0.15) * t100;
  A[105] = -t214;
  A[275] = -t214;
  const T t215 = T(0.3) * t116 - T(0.15) * t115;
  A[106] = -t215;
  A[293] = -t215;
  const T t216 = T(0.3) * t131 - T(0.15) * t130;
  A[107] = -t216;
  A[311] = -t216;
  A[114] = T(0.41025000000000006);
  A[115] = -T(0.28950000000000004);
  A[132] = -T(0.28950000000000004);
  A[116] = -T(0.1376);
  A[150] = -T(0.1376);
  const T t217 = T(0.2) * t30 - T(0.1) * t29;
  A[117] = -t217;
  A[168] = -t217;
  const T t218 = T(0.2) * t39 - T(0.1) * t38;
  A[118] = -t218;
  A[186] = -t218;
  const T t219 = T(0.2) * t48 - T(0.1) * t47;
  A[119] = -t219;
  A[204] = -t219;
  const T t220 = T(0.2) * t60 - T(0.1) * t59;
  A[120] = -t220;
  A[222] = -t220;
  const T t221 = T(0.2) * t72 - T(0.1) * t71;
  A[121] = -t221;
  A[240] = -t221;
  const T t222 = T(0.2) * t84 - T(0.1) * t83;
  A[122] = -t222;
  A[258] = -t222;
  const T t223 = T(0.2) * t99 - T(0.1) * t98;
  A[123] = -t223;
  A[276] = -t223;
  const T t224 = T(0.2) * t114 - T(0.1) * t113;
  A[124] = -t224;
  A[294] = -t224;
  const T t225 = T(0.2) * t129 - T(0.1) * t128;
  A[125] = -t225;
  A[312] = -t225;
  A[133] = T(0.62225);
  A[134] = -T(0.10820000000000002);
  A[151] = -T(0.10820000000000002);
  const T t226 = T(0.1) * t28 - T(0.3) * t30;
  A[135] = -t226;
  A[169] = -t226;
  const T t227 = T(0.1) * t37 - T(0.3) * t39;
  A[136] = -t227;
  A[187] = -t227;
  const T t228 = T(0.1) * t46 - T(0.3) * t48;
  A[137] = -t228;
  A[205] = -t228;
  const T t229 = T(0.1) * t58 - T(0.3) * t60;
  A[138] = -t229;
  A[223] = -t229;
  const T t230 = T(0.1) * t70 - T(0.3) * t72;
  A[139] = -t230;
  A[241] = -t230;
  const T t231 = T(0.1) * t82 - T(0.3) * t84;
  A[140] = -t231;
  A[259] = -t231;
  const T t232 = T(0.1) * t97 - T(0.3) * t99;
  A[141] = -t232;
  A[277] = -t232;
  const T t233 = T(0.1) * t112 - T(0.3) * t114;
  A[142] = -t233;
  A[295] = -t233;
  const T t234 = T(0.1) * t127 - T(0.3) * t129;
  A[143] = -t234;
  A[313] = -t234;
  A[152] = T(0.754);
  const T t235 = T(0.3) * t29 - T(0.2) * t28;
  A[153] = -t235;
  A[170] = -t235;
  const T t236 = T(0.3) * t38 - T(0.2) * t37;
  A[154] = -t236;
  A[188] = -t236;
  const T t237 = T(0.3) * t47 - T(0.2) * t46;
  A[155] = -t237;
  A[206] = -t237;
  const T t238 = T(0.3) * t59 - T(0.2) * t58;
  A[156] = -t238;
  A[224] = -t238;
  const T t239 = T(0.3) * t71 - T(0.2) * t70;
  A[157] = -t239;
  A[242] = -t239;
  const T t240 = T(0.3) * t83 - T(0.2) * t82;
  A[158] = -t240;
  A[260] = -t240;
  const T t241 = T(0.3) * t98 - T(0.2) * t97;
  A[159] = -t241;
  A[278] = -t241;
  const T t242 = T(0.3) * t113 - T(0.2) * t112;
  A[160] = -t242;
  A[296] = -t242;
  const T t243 = T(0.3) * t128 - T(0.2) * t127;
  A[161] = -t243;
  A[314] = -t243;
  A[171] = T(0.42425);
  A[172] = -T(0.2535);
  A[189] = -T(0.2535);
  A[173] = -T(0.09580000000000001);
  A[207] = -T(0.09580000000000001);
  const T t244 = T(0.25) * t57 - T(0.1) * t56;
  A[174] = -t244;
  A[225] = -t244;
  const T t245 = T(0.25) * t69 - T(0.1) * t68;
  A[175] = -t245;
  A[243] = -t245;
  const T t246 = T(0.25) * t81 - T(0.1) * t80;
  A[176] = -t246;
  A[261] = -t246;
  const T t247 = T(0.25) * t96 - T(0.1) * t95;
  A[177] = -t247;
  A[279] = -t247;
  const T t248 = T(0.25) * t111 - T(0.1) * t110;
  A[178] = -t248;
  A[297] = -t248;
  const T t249 = T(0.25) * t126 - T(0.1) * t125;
  A[179] = -t249;
  A[315] = -t249;
  A[190] = T(0.4955);
  A[191] = -T(0.0971);
  A[208] = -T(0.0971);
  const T t250 = T(0.1) * t55 - T(0.3) * t57;
  A[192] = -t250;
  A[226] = -t250;
  const T t251 = T(0.1) * t67 - T(0.3) * t69;
  A[193] = -t251;
  A[244] = -t251;
  const T t252 = T(0.1) * t79 - T(0.3) * t81;
  A[194] = -t252;
  A[262] = -t252;
  const T t253 = T(0.1) * t94 - T(0.3) * t96;
  A[195] = -t253;
  A[280] = -t253;
  const T t254 = T(0.1) * t109 - T(0.3) * t111;
  A[196] = -t254;
  A[298] = -t254;
  const T t255 = T(0.1) * t124 - T(0.3) * t126;
  A[197] = -t255;
  A[316] = -t255;
  A[209] = T(0.6547499999999999);
  const T t256 = T(0.3) * t56 - T(0.25) * t55;
  A[210] = -t256;
  A[227] = -t256;
  const T t257 = T(0.3) * t68 - T(0.25) * t67;
  A[211] = -t257;
  A[245] = -t257;
  const T t258 = T(0.3) * t80 - T(0.25) * t79;
  A[212] = -t258;
  A[263] = -t258;
  const T t259 = T(0.3) * t95 - T(0.25) * t94;
  A[213] = -t259;
  A[281] = -t259;
  const T t260 = T(0.3) * t110 - T(0.25) * t109;
  A[214] = -t260;
  A[299] = -t260;
  const T t261 = T(0.3) * t125 - T(0.25) * t124;
  A[215] = -t261;
  A[317] = -t261;
  A[228] = T(0.37375);
  A[229] = -T(0.1665);
  A[246] = -T(0.1665);
  A[230] = -T(0.051000000000000004);
  A[264] = -T(0.051000000000000004);
  const T t262 = T(0.3) * t93;
  const T t263 = t262 - T(0.1) * t92;
  A[231] = -t263;
  A[282] = -t263;
  const T t264 = T(0.3) * t108;
  const T t265 = t264 - T(0.1) * t107;
  A[232] = -t265;
  A[300] = -t265;
  const T t266 = T(0.3) * t123;
  const T t267 = t266 - T(0.1) * t122;
  A[233] = -t267;
  A[318] = -t267;
  A[247] = T(0.35875);
  A[248] = -T(0.069);
  A[265] = -T(0.069);
  const T t268 = T(0.1) * t91 - t262;
  A[249] = -t268;
  A[283] = -t268;
  const T t269 = T(0.1) * t106 - t264;
  A[250] = -t269;
  A[301] = -t269;
  const T t270 = T(0.1) * t121 - t266;
  A[251] = -t270;
  A[319] = -t270;
  A[266] = T(0.483);
  const T t271 = T(0.3) * t92 - T(0.3) * t91;
  A[267] = -t271;
  A[284] = -t271;
  const T t272 = T(0.3) * t107 - T(0.3) * t106;
  A[268] = -t272;
  A[302] = -t272;
  const T t273 = T(0.3) * t122 - T(0.3) * t121;
  A[269] = -t273;
  A[320] = -t273;
  A[285] = T(0.228);
  A[286] = -T(0.024000000000000004);
  A[303] = -T(0.024000000000000004);
  A[287] = -T(0.003200000000000002);
  A[321] = -T(0.003200000000000002);
  A[304] = T(0.212);
  A[305] = -T(0.022400000000000003);
  A[322] = -T(0.022400000000000003);
  A[323] = T(0.20800000000000002);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 165 add, 240 multiply
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  T block[99];

  // ---- body 1 (body_1) on the inertial frame
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
  // B1_1 = -R1^T r1~
  const T minus_B1_1_11 = R1_21 * T(0.05) - R1_31 * T(0.2);
  const T t1_13 = R1_31 * T(0.1);
  const T minus_B1_1_12 = t1_13 - R1_11 * T(0.05);
  const T t1_14 = R1_21 * T(0.1);
  const T minus_B1_1_13 = R1_11 * T(0.2) - t1_14;
  const T minus_B1_1_21 = R1_22 * T(0.05) - R1_32 * T(0.2);
  const T t1_15 = R1_32 * T(0.1);
  const T minus_B1_1_22 = t1_15 - R1_12 * T(0.05);
  const T t1_16 = R1_22 * T(0.1);
  const T minus_B1_1_23 = R1_12 * T(0.2) - t1_16;
  const T minus_B1_1_31 = R1_23 * T(0.05) - R1_33 * T(0.2);
  const T t1_17 = R1_33 * T(0.1);
  const T minus_B1_1_32 = t1_17 - R1_13 * T(0.05);
  const T t1_18 = R1_23 * T(0.1);
  const T minus_B1_1_33 = R1_13 * T(0.2) - t1_18;
  block[0] = -minus_B1_1_11;
  block[1] = -minus_B1_1_12;
  block[2] = -minus_B1_1_13;
  block[3] = -minus_B1_1_21;
  block[4] = -minus_B1_1_22;
  block[5] = -minus_B1_1_23;
  block[6] = -minus_B1_1_31;
  block[7] = -minus_B1_1_32;
  block[8] = -minus_B1_1_33;
  // B2_1 = -R1^T q2~
  const T minus_B2_1_11 = t1_14 - t1_13;
  const T t1_19 = R1_11 * T(0.1);
  const T minus_B2_1_12 = R1_31 * T(0.3) - t1_19;
  const T minus_B2_1_13 = t1_19 - R1_21 * T(0.3);
  const T minus_B2_1_21 = t1_16 - t1_15;
  const T t1_20 = R1_12 * T(0.1);
  const T minus_B2_1_22 = R1_32 * T(0.3) - t1_20;
  const T minus_B2_1_23 = t1_20 - R1_22 * T(0.3);
  const T minus_B2_1_31 = t1_18 - t1_17;
  const T t1_21 = R1_13 * T(0.1);
  const T minus_B2_1_32 = R1_33 * T(0.3) - t1_21;
  const T minus_B2_1_33 = t1_21 - R1_23 * T(0.3);
  block[9] = -minus_B2_1_11;
  block[10] = -minus_B2_1_12;
  block[11] = -minus_B2_1_13;
  block[12] = -minus_B2_1_21;
  block[13] = -minus_B2_1_22;
  block[14] = -minus_B2_1_23;
  block[15] = -minus_B2_1_31;
  block[16] = -minus_B2_1_32;
  block[17] = -minus_B2_1_33;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // B3_2 = -R2^T r2~
  const T minus_B3_2_11 = R2_21 * T(0.05) - R2_31 * T(0.2);
  const T minus_B3_2_12 = R2_31 * T(0.1) - R2_11 * T(0.05);
  const T t2_13 = R2_21 * T(0.1);
  const T minus_B3_2_13 = R2_11 * T(0.2) - t2_13;
  const T minus_B3_2_21 = R2_22 * T(0.05) - R2_32 * T(0.2);
  const T minus_B3_2_22 = R2_32 * T(0.1) - R2_12 * T(0.05);
  const T t2_14 = R2_22 * T(0.1);
  const T minus_B3_2_23 = R2_12 * T(0.2) - t2_14;
  const T minus_B3_2_31 = R2_23 * T(0.05) - R2_33 * T(0.2);
  const T minus_B3_2_32 = R2_33 * T(0.1) - R2_13 * T(0.05);
  const T t2_15 = R2_23 * T(0.1);
  const T minus_B3_2_33 = R2_13 * T(0.2) - t2_15;
  block[18] = -minus_B3_2_11;
  block[19] = -minus_B3_2_12;
  block[20] = -minus_B3_2_13;
  block[21] = -minus_B3_2_21;
  block[22] = -minus_B3_2_22;
  block[23] = -minus_B3_2_23;
  block[24] = -minus_B3_2_31;
  block[25] = -minus_B3_2_32;
  block[26] = -minus_B3_2_33;
  // B4_2 = -R2^T q3~
  const T minus_B4_2_11 = t2_13 - R2_31 * T(0.15);
  const T minus_B4_2_12 = R2_31 * T(0.3) - R2_11 * T(0.1);
  const T minus_B4_2_13 = R2_11 * T(0.15) - R2_21 * T(0.3);
  const T minus_B4_2_21 = t2_14 - R2_32 * T(0.15);
  const T minus_B4_2_22 = R2_32 * T(0.3) - R2_12 * T(0.1);
  const T minus_B4_2_23 = R2_12 * T(0.15) - R2_22 * T(0.3);
  const T minus_B4_2_31 = t2_15 - R2_33 * T(0.15);
  const T minus_B4_2_32 = R2_33 * T(0.3) - R2_13 * T(0.1);
  const T minus_B4_2_33 = R2_13 * T(0.15) - R2_23 * T(0.3);
  block[27] = -minus_B4_2_11;
  block[28] = -minus_B4_2_12;
  block[29] = -minus_B4_2_13;
  block[30] = -minus_B4_2_21;
  block[31] = -minus_B4_2_22;
  block[32] = -minus_B4_2_23;
  block[33] = -minus_B4_2_31;
  block[34] = -minus_B4_2_32;
  block[35] = -minus_B4_2_33;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  // R3^T = 1 + 2 e3~ (eps4_3 + e3~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t3_1 = T(2) * eps3_2;
  const T t3_2 = t3_1 * eps3_2;
  const T t3_3 = T(2) * eps3_3;
  const T t3_4 = t3_3 * eps3_3;
  const T R3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * eps3_1;
  const T t3_6 = t3_5 * eps3_2;
  const T t3_7 = t3_3 * eps3_4;
  const T R3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * eps3_3;
  const T t3_9 = t3_1 * eps3_4;
  const T R3_13 = t3_8 - t3_9;
  const T R3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * eps3_1;
  const T R3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * eps3_3;
  const T t3_12 = t3_5 * eps3_4;
  const T R3_23 = t3_11 + t3_12;
  const T R3_31 = t3_8 + t3_9;
  const T R3_32 = t3_11 - t3_12;
  const T R3_33 = t3_10 - t3_2;
  // B5_3 = -R3^T r3~
  const T t3_13 = R3_31 * T(0.2);
  const T minus_B5_3_11 = R3_21 * T(0.05) - t3_13;
  const T minus_B5_3_12 = R3_31 * T(0.1) - R3_11 * T(0.05);
  const T t3_14 = R3_11 * T(0.2);
  const T t3_15 = R3_21 * T(0.1);
  const T minus_B5_3_13 = t3_14 - t3_15;
  const T t3_16 = R3_32 * T(0.2);
  const T minus_B5_3_21 = R3_22 * T(0.05) - t3_16;
  const T minus_B5_3_22 = R3_32 * T(0.1) - R3_12 * T(0.05);
  const T t3_17 = R3_12 * T(0.2);
  const T t3_18 = R3_22 * T(0.1);
  const T minus_B5_3_23 = t3_17 - t3_18;
  const T t3_19 = R3_33 * T(0.2);
  const T minus_B5_3_31 = R3_23 * T(0.05) - t3_19;
  const T minus_B5_3_32 = R3_33 * T(0.1) - R3_13 * T(0.05);
  const T t3_20 = R3_13 * T(0.2);
  const T t3_21 = R3_23 * T(0.1);
  const T minus_B5_3_33 = t3_20 - t3_21;
  block[36] = -minus_B5_3_11;
  block[37] = -minus_B5_3_12;
  block[38] = -minus_B5_3_13;
  block[39] = -minus_B5_3_21;
  block[40] = -minus_B5_3_22;
  block[41] = -minus_B5_3_23;
  block[42] = -minus_B5_3_31;
  block[43] = -minus_B5_3_32;
  block[44] = -minus_B5_3_33;
  // B6_3 = -R3^T q4~
  const T minus_B6_3_11 = t3_15 - t3_13;
  const T minus_B6_3_12 = R3_31 * T(0.3) - R3_11 * T(0.1);
  const T minus_B6_3_13 = t3_14 - R3_21 * T(0.3);
  const T minus_B6_3_21 = t3_18 - t3_16;
  const T minus_B6_3_22 = R3_32 * T(0.3) - R3_12 * T(0.1);
  const T minus_B6_3_23 = t3_17 - R3_22 * T(0.3);
  const T minus_B6_3_31 = t3_21 - t3_19;
  const T minus_B6_3_32 = R3_33 * T(0.3) - R3_13 * T(0.1);
  const T minus_B6_3_33 = t3_20 - R3_23 * T(0.3);
  block[45] = -minus_B6_3_11;
  block[46] = -minus_B6_3_12;
  block[47] = -minus_B6_3_13;
  block[48] = -minus_B6_3_21;
  block[49] = -minus_B6_3_22;
  block[50] = -minus_B6_3_23;
  block[51] = -minus_B6_3_31;
  block[52] = -minus_B6_3_32;
  block[53] = -minus_B6_3_33;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  // R4^T = 1 + 2 e4~ (eps4_4 + e4~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t4_1 = T(2) * eps4_2;
  const T t4_2 = t4_1 * eps4_2;
  const T t4_3 = T(2) * eps4_3;
  const T t4_4 = t4_3 * eps4_3;
  const T R4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * eps4_1;
  const T t4_6 = t4_5 * eps4_2;
  const T t4_7 = t4_3 * eps4_4;
  const T R4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * eps4_3;
  const T t4_9 = t4_1 * eps4_4;
  const T R4_13 = t4_8 - t4_9;
  const T R4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * eps4_1;
  const T R4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * eps4_3;
  const T t4_12 = t4_5 * eps4_4;
  const T R4_23 = t4_11 + t4_12;
  const T R4_31 = t4_8 + t4_9;
  const T R4_32 = t4_11 - t4_12;
  const T R4_33 = t4_10 - t4_2;
  // B7_4 = -R4^T r4~
  const T minus_B7_4_11 = R4_21 * T(0.05) - R4_31 * T(0.2);
  const T minus_B7_4_12 = R4_31 * T(0.1) - R4_11 * T(0.05);
  const T t4_13 = R4_21 * T(0.1);
  const T minus_B7_4_13 = R4_11 * T(0.2) - t4_13;
  const T minus_B7_4_21 = R4_22 * T(0.05) - R4_32 * T(0.2);
  const T minus_B7_4_22 = R4_32 * T(0.1) - R4_12 * T(0.05);
  const T t4_14 = R4_22 * T(0.1);
  const T minus_B7_4_23 = R4_12 * T(0.2) - t4_14;
  const T minus_B7_4_31 = R4_23 * T(0.05) - R4_33 * T(0.2);
  const T minus_B7_4_32 = R4_33 * T(0.1) - R4_13 * T(0.05);
  const T t4_15 = R4_23 * T(0.1);
  const T minus_B7_4_33 = R4_13 * T(0.2) - t4_15;
  block[54] = -minus_B7_4_11;
  block[55] = -minus_B7_4_12;
  block[56] = -minus_B7_4_13;
  block[57] = -minus_B7_4_21;
  block[58] = -minus_B7_4_22;
  block[59] = -minus_B7_4_23;
  block[60] = -minus_B7_4_31;
  block[61] = -minus_B7_4_32;
  block[62] = -minus_B7_4_33;
  // B8_4 = -R4^T q5~
  const T minus_B8_4_11 = t4_13 - R4_31 * T(0.25);
  const T minus_B8_4_12 = R4_31 * T(0.3) - R4_11 * T(0.1);
  const T minus_B8_4_13 = R4_11 * T(0.25) - R4_21 * T(0.3);
  const T minus_B8_4_21 = t4_14 - R4_32 * T(0.25);
  const T minus_B8_4_22 = R4_32 * T(0.3) - R4_12 * T(0.1);
  const T minus_B8_4_23 = R4_12 * T(0.25) - R4_22 * T(0.3);
  const T minus_B8_4_31 = t4_15 - R4_33 * T(0.25);
  const T minus_B8_4_32 = R4_33 * T(0.3) - R4_13 * T(0.1);
  const T minus_B8_4_33 = R4_13 * T(0.25) - R4_23 * T(0.3);
  block[63] = -minus_B8_4_11;
  block[64] = -minus_B8_4_12;
  block[65] = -minus_B8_4_13;
  block[66] = -minus_B8_4_21;
  block[67] = -minus_B8_4_22;
  block[68] = -minus_B8_4_23;
  block[69] = -minus_B8_4_31;
  block[70] = -minus_B8_4_32;
  block[71] = -minus_B8_4_33;

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  // R5^T = 1 + 2 e5~ (eps4_5 + e5~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t5_1 = T(2) * eps5_2;
  const T t5_2 = t5_1 * eps5_2;
  const T t5_3 = T(2) * eps5_3;
  const T t5_4 = t5_3 * eps5_3;
  const T R5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * eps5_1;
  const T t5_6 = t5_5 * eps5_2;
  const T t5_7 = t5_3 * eps5_4;
  const T R5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * eps5_3;
  const T t5_9 = t5_1 * eps5_4;
  const T R5_13 = t5_8 - t5_9;
  const T R5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * eps5_1;
  const T R5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * eps5_3;
  const T t5_12 = t5_5 * eps5_4;
  const T R5_23 = t5_11 + t5_12;
  const T R5_31 = t5_8 + t5_9;
  const T R5_32 = t5_11 - t5_12;
  const T R5_33 = t5_10 - t5_2;
  // B9_5 = -R5^T r5~
  const T minus_B9_5_11 = R5_21 * T(0.05) - R5_31 * T(0.2);
  const T minus_B9_5_12 = R5_31 * T(0.1) - R5_11 * T(0.05);
  const T t5_13 = R5_21 * T(0.1);
  const T minus_B9_5_13 = R5_11 * T(0.2) - t5_13;
  const T minus_B9_5_21 = R5_22 * T(0.05) - R5_32 * T(0.2);
  const T minus_B9_5_22 = R5_32 * T(0.1) - R5_12 * T(0.05);
  const T t5_14 = R5_22 * T(0.1);
  const T minus_B9_5_23 = R5_12 * T(0.2) - t5_14;
  const T minus_B9_5_31 = R5_23 * T(0.05) - R5_33 * T(0.2);
  const T minus_B9_5_32 = R5_33 * T(0.1) - R5_13 * T(0.05);
  const T t5_15 = R5_23 * T(0.1);
  const T minus_B9_5_33 = R5_13 * T(0.2) - t5_15;
  block[72] = -minus_B9_5_11;
  block[73] = -minus_B9_5_12;
  block[74] = -minus_B9_5_13;
  block[75] = -minus_B9_5_21;
  block[76] = -minus_B9_5_22;
  block[77] = -minus_B9_5_23;
  block[78] = -minus_B9_5_31;
  block[79] = -minus_B9_5_32;
  block[80] = -minus_B9_5_33;
  // B10_5 = -R5^T q6~
  const T t5_16 = R5_31 * T(0.3);
  const T minus_B10_5_11 = t5_13 - t5_16;
  const T minus_B10_5_12 = t5_16 - R5_11 * T(0.1);
  const T minus_B10_5_13 = R5_11 * T(0.3) - R5_21 * T(0.3);
  const T t5_17 = R5_32 * T(0.3);
  const T minus_B10_5_21 = t5_14 - t5_17;
  const T minus_B10_5_22 = t5_17 - R5_12 * T(0.1);
  const T minus_B10_5_23 = R5_12 * T(0.3) - R5_22 * T(0.3);
  const T t5_18 = R5_33 * T(0.3);
  const T minus_B10_5_31 = t5_15 - t5_18;
  const T minus_B10_5_32 = t5_18 - R5_13 * T(0.1);
  const T minus_B10_5_33 = R5_13 * T(0.3) - R5_23 * T(0.3);
  block[81] = -minus_B10_5_11;
  block[82] = -minus_B10_5_12;
  block[83] = -minus_B10_5_13;
  block[84] = -minus_B10_5_21;
  block[85] = -minus_B10_5_22;
  block[86] = -minus_B10_5_23;
  block[87] = -minus_B10_5_31;
  block[88] = -minus_B10_5_32;
  block[89] = -minus_B10_5_33;

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  // R6^T = 1 + 2 e6~ (eps4_6 + e6~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t6_1 = T(2) * eps6_2;
  const T t6_2 = t6_1 * eps6_2;
  const T t6_3 = T(2) * eps6_3;
  const T t6_4 = t6_3 * eps6_3;
  const T R6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * eps6_1;
  const T t6_6 = t6_5 * eps6_2;
  const T t6_7 = t6_3 * eps6_4;
  const T R6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * eps6_3;
  const T t6_9 = t6_1 * eps6_4;
  const T R6_13 = t6_8 - t6_9;
  const T R6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * eps6_1;
  const T R6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * eps6_3;
  const T t6_12 = t6_5 * eps6_4;
  const T R6_23 = t6_11 + t6_12;
  const T R6_31 = t6_8 + t6_9;
  const T R6_32 = t6_11 - t6_12;
  const T R6_33 = t6_10 - t6_2;
  // B11_6 = -R6^T r6~
  const T minus_B11_6_11 = R6_21 * T(0.05) - R6_31 * T(0.2);
  const T minus_B11_6_12 = R6_31 * T(0.1) - R6_11 * T(0.05);
  const T minus_B11_6_13 = R6_11 * T(0.2) - R6_21 * T(0.1);
  const T minus_B11_6_21 = R6_22 * T(0.05) - R6_32 * T(0.2);
  const T minus_B11_6_22 = R6_32 * T(0.1) - R6_12 * T(0.05);
  const T minus_B11_6_23 = R6_12 * T(0.2) - R6_22 * T(0.1);
  const T minus_B11_6_31 = R6_23 * T(0.05) - R6_33 * T(0.2);
  const T minus_B11_6_32 = R6_33 * T(0.1) - R6_13 * T(0.05);
  const T minus_B11_6_33 = R6_13 * T(0.2) - R6_23 * T(0.1);
  block[90] = -minus_B11_6_11;
  block[91] = -minus_B11_6_12;
  block[92] = -minus_B11_6_13;
  block[93] = -minus_B11_6_21;
  block[94] = -minus_B11_6_22;
  block[95] = -minus_B11_6_23;
  block[96] = -minus_B11_6_31;
  block[97] = -minus_B11_6_32;
  block[98] = -minus_B11_6_33;

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,0}, {1,54}, {2,57}, {1,108}, {3,111}, {4,114}, {1,162}, {3,165}, {5,168}, {6,171}, {1,216}, {3,219}, {5,222},
      {7,225}, {8,228}, {1,270}, {3,273}, {5,276}, {7,279}, {9,282}, {10,285},
  };
  for (int i = 0; i < 324; ++i) v_y[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y[place[1] + i * 18 + j] = block[9 * place[0] + 3 * i + j];
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 219 add, 348 multiply
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  T block[99];

  // ---- body 1 (body_1) on the inertial frame
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
  const T t1_13 = R1_31 * omega1_1 - R1_11 * omega1_3;
  const T t1_14 = R1_11 * omega1_2 - R1_21 * omega1_1;
  const T minus_B1_1_11 = t1_13 * T(0.05) - t1_14 * T(0.2);
  const T t1_15 = t1_14 * T(0.1);
  const T t1_16 = R1_21 * omega1_3 - R1_31 * omega1_2;
  const T minus_B1_1_12 = t1_15 - t1_16 * T(0.05);
  const T t1_17 = t1_13 * T(0.1);
  const T minus_B1_1_13 = t1_16 * T(0.2) - t1_17;
  const T t1_18 = R1_32 * omega1_1 - R1_12 * omega1_3;
  const T t1_19 = R1_12 * omega1_2 - R1_22 * omega1_1;
  const T minus_B1_1_21 = t1_18 * T(0.05) - t1_19 * T(0.2);
  const T t1_20 = t1_19 * T(0.1);
  const T t1_21 = R1_22 * omega1_3 - R1_32 * omega1_2;
  const T minus_B1_1_22 = t1_20 - t1_21 * T(0.05);
  const T t1_22 = t1_18 * T(0.1);
  const T minus_B1_1_23 = t1_21 * T(0.2) - t1_22;
  const T t1_23 = R1_33 * omega1_1 - R1_13 * omega1_3;
  const T t1_24 = R1_13 * omega1_2 - R1_23 * omega1_1;
  const T minus_B1_1_31 = t1_23 * T(0.05) - t1_24 * T(0.2);
  const T t1_25 = t1_24 * T(0.1);
  const T t1_26 = R1_23 * omega1_3 - R1_33 * omega1_2;
  const T minus_B1_1_32 = t1_25 - t1_26 * T(0.05);
  const T t1_27 = t1_23 * T(0.1);
  const T minus_B1_1_33 = t1_26 * T(0.2) - t1_27;
  block[0] = -minus_B1_1_11;
  block[1] = -minus_B1_1_12;
  block[2] = -minus_B1_1_13;
  block[3] = -minus_B1_1_21;
  block[4] = -minus_B1_1_22;
  block[5] = -minus_B1_1_23;
  block[6] = -minus_B1_1_31;
  block[7] = -minus_B1_1_32;
  block[8] = -minus_B1_1_33;
  // B2_1 = -R1^T omega1~ q2~
  const T minus_B2_1_11 = t1_17 - t1_15;
  const T t1_28 = t1_16 * T(0.1);
  const T minus_B2_1_12 = t1_14 * T(0.3) - t1_28;
  const T minus_B2_1_13 = t1_28 - t1_13 * T(0.3);
  const T minus_B2_1_21 = t1_22 - t1_20;
  const T t1_29 = t1_21 * T(0.1);
  const T minus_B2_1_22 = t1_19 * T(0.3) - t1_29;
  const T minus_B2_1_23 = t1_29 - t1_18 * T(0.3);
  const T minus_B2_1_31 = t1_27 - t1_25;
  const T t1_30 = t1_26 * T(0.1);
  const T minus_B2_1_32 = t1_24 * T(0.3) - t1_30;
  const T minus_B2_1_33 = t1_30 - t1_23 * T(0.3);
  block[9] = -minus_B2_1_11;
  block[10] = -minus_B2_1_12;
  block[11] = -minus_B2_1_13;
  block[12] = -minus_B2_1_21;
  block[13] = -minus_B2_1_22;
  block[14] = -minus_B2_1_23;
  block[15] = -minus_B2_1_31;
  block[16] = -minus_B2_1_32;
  block[17] = -minus_B2_1_33;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // B3_2 = -R2^T omega2~ r2~
  const T t2_13 = R2_31 * omega2_1 - R2_11 * omega2_3;
  const T t2_14 = R2_11 * omega2_2 - R2_21 * omega2_1;
  const T minus_B3_2_11 = t2_13 * T(0.05) - t2_14 * T(0.2);
  const T t2_15 = R2_21 * omega2_3 - R2_31 * omega2_2;
  const T minus_B3_2_12 = t2_14 * T(0.1) - t2_15 * T(0.05);
  const T t2_16 = t2_13 * T(0.1);
  const T minus_B3_2_13 = t2_15 * T(0.2) - t2_16;
  const T t2_17 = R2_32 * omega2_1 - R2_12 * omega2_3;
  const T t2_18 = R2_12 * omega2_2 - R2_22 * omega2_1;
  const T minus_B3_2_21 = t2_17 * T(0.05) - t2_18 * T(0.2);
  const T t2_19 = R2_22 * omega2_3 - R2_32 * omega2_2;
  const T minus_B3_2_22 = t2_18 * T(0.1) - t2_19 * T(0.05);
  const T t2_20 = t2_17 * T(0.1);
  const T minus_B3_2_23 = t2_19 * T(0.2) - t2_20;
  const T t2_21 = R2_33 * omega2_1 - R2_13 * omega2_3;
  const T t2_22 = R2_13 * omega2_2 - R2_23 * omega2_1;
  const T minus_B3_2_31 = t2_21 * T(0.05) - t2_22 * T(0.2);
  const T t2_23 = R2_23 * omega2_3 - R2_33 * omega2_2;
  const T minus_B3_2_32 = t2_22 * T(0.1) - t2_23 * T(0.05);
  const T t2_24 = t2_21 * T(0.1);
  const T minus_B3_2_33 = t2_23 * T(0.2) - t2_24;
  block[18] = -minus_B3_2_11;
  block[19] = -minus_B3_2_12;
  block[20] = -minus_B3_2_13;
  block[21] = -minus_B3_2_21;
  block[22] = -minus_B3_2_22;
  block[23] = -minus_B3_2_23;
  block[24] = -minus_B3_2_31;
  block[25] = -minus_B3_2_32;
  block[26] = -minus_B3_2_33;
  // B4_2 = -R2^T omega2~ q3~
  const T minus_B4_2_11 = t2_16 - t2_14 * T(0.15);
  const T minus_B4_2_12 = t2_14 * T(0.3) - t2_15 * T(0.1);
  const T minus_B4_2_13 = t2_15 * T(0.15) - t2_13 * T(0.3);
  const T minus_B4_2_21 = t2_20 - t2_18 * T(0.15);
  const T minus_B4_2_22 = t2_18 * T(0.3) - t2_19 * T(0.1);
  const T minus_B4_2_23 = t2_19 * T(0.15) - t2_17 * T(0.3);
  const T minus_B4_2_31 = t2_24 - t2_22 * T(0.15);
  const T minus_B4_2_32 = t2_22 * T(0.3) - t2_23 * T(0.1);
  const T minus_B4_2_33 = t2_23 * T(0.15) - t2_21 * T(0.3);
  block[27] = -minus_B4_2_11;
  block[28] = -minus_B4_2_12;
  block[29] = -minus_B4_2_13;
  block[30] = -minus_B4_2_21;
  block[31] = -minus_B4_2_22;
  block[32] = -minus_B4_2_23;
  block[33] = -minus_B4_2_31;
  block[34] = -minus_B4_2_32;
  block[35] = -minus_B4_2_33;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  // R3^T = 1 + 2 e3~ (eps4_3 + e3~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t3_1 = T(2) * eps3_2;
  const T t3_2 = t3_1 * eps3_2;
  const T t3_3 = T(2) * eps3_3;
  const T t3_4 = t3_3 * eps3_3;
  const T R3_11 = T(1) - t3_2 - t3_4;
  const T t3_5 = T(2) * eps3_1;
  const T t3_6 = t3_5 * eps3_2;
  const T t3_7 = t3_3 * eps3_4;
  const T R3_12 = t3_6 + t3_7;
  const T t3_8 = t3_5 * eps3_3;
  const T t3_9 = t3_1 * eps3_4;
  const T R3_13 = t3_8 - t3_9;
  const T R3_21 = t3_6 - t3_7;
  const T t3_10 = T(1) - t3_5 * eps3_1;
  const T R3_22 = t3_10 - t3_4;
  const T t3_11 = t3_1 * eps3_3;
  const T t3_12 = t3_5 * eps3_4;
  const T R3_23 = t3_11 + t3_12;
  const T R3_31 = t3_8 + t3_9;
  const T R3_32 = t3_11 - t3_12;
  const T R3_33 = t3_10 - t3_2;
  // B5_3 = -R3^T omega3~ r3~
  const T t3_13 = R3_31 * omega3_1 - R3_11 * omega3_3;
  const T t3_14 = R3_11 * omega3_2 - R3_21 * omega3_1;
  const T t3_15 = t3_14 * T(0.2);
  const T minus_B5_3_11 = t3_13 * T(0.05) - t3_15;
  const T t3_16 = R3_21 * omega3_3 - R3_31 * omega3_2;
  const T minus_B5_3_12 = t3_14 * T(0.1) - t3_16 * T(0.05);
  const T t3_17 = t3_16 * T(0.2);
  const T t3_18 = t3_13 * T(0.1);
  const T minus_B5_3_13 = t3_17 - t3_18;
  const T t3_19 = R3_32 * omega3_1 - R3_12 * omega3_3;
  const T t3_20 = R3_12 * omega3_2 - R3_22 * omega3_1;
  const T t3_21 = t3_20 * T(0.2);
  const T minus_B5_3_21 = t3_19 * T(0.05) - t3_21;
  const T t3_22 = R3_22 * omega3_3 - R3_32 * omega3_2;
  const T minus_B5_3_22 = t3_20 * T(0.1) - t3_22 * T(0.05);
  const T t3_23 = t3_22 * T(0.2);
  const T t3_24 = t3_19 * T(0.1);
  const T minus_B5_3_23 = t3_23 - t3_24;
  const T t3_25 = R3_33 * omega3_1 - R3_13 * omega3_3;
  const T t3_26 = R3_13 * omega3_2 - R3_23 * omega3_1;
  const T t3_27 = t3_26 * T(0.2);
  const T minus_B5_3_31 = t3_25 * T(0.05) - t3_27;
  const T t3_28 = R3_23 * omega3_3 - R3_33 * omega3_2;
  const T minus_B5_3_32 = t3_26 * T(0.1) - t3_28 * T(0.05);
  const T t3_29 = t3_28 * T(0.2);
  const T t3_30 = t3_25 * T(0.1);
  const T minus_B5_3_33 = t3_29 - t3_30;
  block[36] = -minus_B5_3_11;
  block[37] = -minus_B5_3_12;
  block[38] = -minus_B5_3_13;
  block[39] = -minus_B5_3_21;
  block[40] = -minus_B5_3_22;
  block[41] = -minus_B5_3_23;
  block[42] = -minus_B5_3_31;
  block[43] = -minus_B5_3_32;
  block[44] = -minus_B5_3_33;
  // B6_3 = -R3^T omega3~ q4~
  const T minus_B6_3_11 = t3_18 - t3_15;
  const T minus_B6_3_12 = t3_14 * T(0.3) - t3_16 * T(0.1);
  const T minus_B6_3_13 = t3_17 - t3_13 * T(0.3);
  const T minus_B6_3_21 = t3_24 - t3_21;
  const T minus_B6_3_22 = t3_20 * T(0.3) - t3_22 * T(0.1);
  const T minus_B6_3_23 = t3_23 - t3_19 * T(0.3);
  const T minus_B6_3_31 = t3_30 - t3_27;
  const T minus_B6_3_32 = t3_26 * T(0.3) - t3_28 * T(0.1);
  const T minus_B6_3_33 = t3_29 - t3_25 * T(0.3);
  block[45] = -minus_B6_3_11;
  block[46] = -minus_B6_3_12;
  block[47] = -minus_B6_3_13;
  block[48] = -minus_B6_3_21;
  block[49] = -minus_B6_3_22;
  block[50] = -minus_B6_3_23;
  block[51] = -minus_B6_3_31;
  block[52] = -minus_B6_3_32;
  block[53] = -minus_B6_3_33;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  // R4^T = 1 + 2 e4~ (eps4_4 + e4~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t4_1 = T(2) * eps4_2;
  const T t4_2 = t4_1 * eps4_2;
  const T t4_3 = T(2) * eps4_3;
  const T t4_4 = t4_3 * eps4_3;
  const T R4_11 = T(1) - t4_2 - t4_4;
  const T t4_5 = T(2) * eps4_1;
  const T t4_6 = t4_5 * eps4_2;
  const T t4_7 = t4_3 * eps4_4;
  const T R4_12 = t4_6 + t4_7;
  const T t4_8 = t4_5 * eps4_3;
  const T t4_9 = t4_1 * eps4_4;
  const T R4_13 = t4_8 - t4_9;
  const T R4_21 = t4_6 - t4_7;
  const T t4_10 = T(1) - t4_5 * eps4_1;
  const T R4_22 = t4_10 - t4_4;
  const T t4_11 = t4_1 * eps4_3;
  const T t4_12 = t4_5 * eps4_4;
  const T R4_23 = t4_11 + t4_12;
  const T R4_31 = t4_8 + t4_9;
  const T R4_32 = t4_11 - t4_12;
  const T R4_33 = t4_10 - t4_2;
  // B7_4 = -R4^T omega4~ r4~
  const T t4_13 = R4_31 * omega4_1 - R4_11 * omega4_3;
  const T t4_14 = R4_11 * omega4_2 - R4_21 * omega4_1;
  const T minus_B7_4_11 = t4_13 * T(0.05) - t4_14 * T(0.2);
  const T t4_15 = R4_21 * omega4_3 - R4_31 * omega4_2;
  const T minus_B7_4_12 = t4_14 * T(0.1) - t4_15 * T(0.05);
  const T t4_16 = t4_13 * T(0.1);
  const T minus_B7_4_13 = t4_15 * T(0.2) - t4_16;
  const T t4_17 = R4_32 * omega4_1 - R4_12 * omega4_3;
  const T t4_18 = R4_12 * omega4_2 - R4_22 * omega4_1;
  const T minus_B7_4_21 = t4_17 * T(0.05) - t4_18 * T(0.2);
  const T t4_19 = R4_22 * omega4_3 - R4_32 * omega4_2;
  const T minus_B7_4_22 = t4_18 * T(0.1) - t4_19 * T(0.05);
  const T t4_20 = t4_17 * T(0.1);
  const T minus_B7_4_23 = t4_19 * T(0.2) - t4_20;
  const T t4_21 = R4_33 * omega4_1 - R4_13 * omega4_3;
  const T t4_22 = R4_13 * omega4_2 - R4_23 * omega4_1;
  const T minus_B7_4_31 = t4_21 * T(0.05) - t4_22 * T(0.2);
  const T t4_23 = R4_23 * omega4_3 - R4_33 * omega4_2;
  const T minus_B7_4_32 = t4_22 * T(0.1) - t4_23 * T(0.05);
  const T t4_24 = t4_21 * T(0.1);
  const T minus_B7_4_33 = t4_23 * T(0.2) - t4_24;
  block[54] = -minus_B7_4_11;
  block[55] = -minus_B7_4_12;
  block[56] = -minus_B7_4_13;
  block[57] = -minus_B7_4_21;
  block[58] = -minus_B7_4_22;
  block[59] = -minus_B7_4_23;
  block[60] = -minus_B7_4_31;
  block[61] = -minus_B7_4_32;
  block[62] = -minus_B7_4_33;
  // B8_4 = -R4^T omega4~ q5~
  const T minus_B8_4_11 = t4_16 - t4_14 * T(0.25);
  const T minus_B8_4_12 = t4_14 * T(0.3) - t4_15 * T(0.1);
  const T minus_B8_4_13 = t4_15 * T(0.25) - t4_13 * T(0.3);
  const T minus_B8_4_21 = t4_20 - t4_18 * T(0.25);
  const T minus_B8_4_22 = t4_18 * T(0.3) - t4_19 * T(0.1);
  const T minus_B8_4_23 = t4_19 * T(0.25) - t4_17 * T(0.3);
  const T minus_B8_4_31 = t4_24 - t4_22 * T(0.25);
  const T minus_B8_4_32 = t4_22 * T(0.3) - t4_23 * T(0.1);
  const T minus_B8_4_33 = t4_23 * T(0.25) - t4_21 * T(0.3);
  block[63] = -minus_B8_4_11;
  block[64] = -minus_B8_4_12;
  block[65] = -minus_B8_4_13;
  block[66] = -minus_B8_4_21;
  block[67] = -minus_B8_4_22;
  block[68] = -minus_B8_4_23;
  block[69] = -minus_B8_4_31;
  block[70] = -minus_B8_4_32;
  block[71] = -minus_B8_4_33;

  // ---- body 5 (body_5) on body 4
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  // R5^T = 1 + 2 e5~ (eps4_5 + e5~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t5_1 = T(2) * eps5_2;
  const T t5_2 = t5_1 * eps5_2;
  const T t5_3 = T(2) * eps5_3;
  const T t5_4 = t5_3 * eps5_3;
  const T R5_11 = T(1) - t5_2 - t5_4;
  const T t5_5 = T(2) * eps5_1;
  const T t5_6 = t5_5 * eps5_2;
  const T t5_7 = t5_3 * eps5_4;
  const T R5_12 = t5_6 + t5_7;
  const T t5_8 = t5_5 * eps5_3;
  const T t5_9 = t5_1 * eps5_4;
  const T R5_13 = t5_8 - t5_9;
  const T R5_21 = t5_6 - t5_7;
  const T t5_10 = T(1) - t5_5 * eps5_1;
  const T R5_22 = t5_10 - t5_4;
  const T t5_11 = t5_1 * eps5_3;
  const T t5_12 = t5_5 * eps5_4;
  const T R5_23 = t5_11 + t5_12;
  const T R5_31 = t5_8 + t5_9;
  const T R5_32 = t5_11 - t5_12;
  const T R5_33 = t5_10 - t5_2;
  // B9_5 = -R5^T omega5~ r5~
  const T t5_13 = R5_31 * omega5_1 - R5_11 * omega5_3;
  const T t5_14 = R5_11 * omega5_2 - R5_21 * omega5_1;
  const T minus_B9_5_11 = t5_13 * T(0.05) - t5_14 * T(0.2);
  const T t5_15 = R5_21 * omega5_3 - R5_31 * omega5_2;
  const T minus_B9_5_12 = t5_14 * T(0.1) - t5_15 * T(0.05);
  const T t5_16 = t5_13 * T(0.1);
  const T minus_B9_5_13 = t5_15 * T(0.2) - t5_16;
  const T t5_17 = R5_32 * omega5_1 - R5_12 * omega5_3;
  const T t5_18 = R5_12 * omega5_2 - R5_22 * omega5_1;
  const T minus_B9_5_21 = t5_17 * T(0.05) - t5_18 * T(0.2);
  const T t5_19 = R5_22 * omega5_3 - R5_32 * omega5_2;
  const T minus_B9_5_22 = t5_18 * T(0.1) - t5_19 * T(0.05);
  const T t5_20 = t5_17 * T(0.1);
  const T minus_B9_5_23 = t5_19 * T(0.2) - t5_20;
  const T t5_21 = R5_33 * omega5_1 - R5_13 * omega5_3;
  const T t5_22 = R5_13 * omega5_2 - R5_23 * omega5_1;
  const T minus_B9_5_31 = t5_21 * T(0.05) - t5_22 * T(0.2);
  const T t5_23 = R5_23 * omega5_3 - R5_33 * omega5_2;
  const T minus_B9_5_32 = t5_22 * T(0.1) - t5_23 * T(0.05);
  const T t5_24 = t5_21 * T(0.1);
  const T minus_B9_5_33 = t5_23 * T(0.2) - t5_24;
  block[72] = -minus_B9_5_11;
  block[73] = -minus_B9_5_12;
  block[74] = -minus_B9_5_13;
  block[75] = -minus_B9_5_21;
  block[76] = -minus_B9_5_22;
  block[77] = -minus_B9_5_23;
  block[78] = -minus_B9_5_31;
  block[79] = -minus_B9_5_32;
  block[80] = -minus_B9_5_33;
  // B10_5 = -R5^T omega5~ q6~
  const T t5_25 = t5_14 * T(0.3);
  const T minus_B10_5_11 = t5_16 - t5_25;
  const T minus_B10_5_12 = t5_25 - t5_15 * T(0.1);
  const T minus_B10_5_13 = t5_15 * T(0.3) - t5_13 * T(0.3);
  const T t5_26 = t5_18 * T(0.3);
  const T minus_B10_5_21 = t5_20 - t5_26;
  const T minus_B10_5_22 = t5_26 - t5_19 * T(0.1);
  const T minus_B10_5_23 = t5_19 * T(0.3) - t5_17 * T(0.3);
  const T t5_27 = t5_22 * T(0.3);
  const T minus_B10_5_31 = t5_24 - t5_27;
  const T minus_B10_5_32 = t5_27 - t5_23 * T(0.1);
  const T minus_B10_5_33 = t5_23 * T(0.3) - t5_21 * T(0.3);
  block[81] = -minus_B10_5_11;
  block[82] = -minus_B10_5_12;
  block[83] = -minus_B10_5_13;
  block[84] = -minus_B10_5_21;
  block[85] = -minus_B10_5_22;
  block[86] = -minus_B10_5_23;
  block[87] = -minus_B10_5_31;
  block[88] = -minus_B10_5_32;
  block[89] = -minus_B10_5_33;

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  // R6^T = 1 + 2 e6~ (eps4_6 + e6~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t6_1 = T(2) * eps6_2;
  const T t6_2 = t6_1 * eps6_2;
  const T t6_3 = T(2) * eps6_3;
  const T t6_4 = t6_3 * eps6_3;
  const T R6_11 = T(1) - t6_2 - t6_4;
  const T t6_5 = T(2) * eps6_1;
  const T t6_6 = t6_5 * eps6_2;
  const T t6_7 = t6_3 * eps6_4;
  const T R6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * eps6_3;
  const T t6_9 = t6_1 * eps6_4;
  const T R6_13 = t6_8 - t6_9;
  const T R6_21 = t6_6 - t6_7;
  const T t6_10 = T(1) - t6_5 * eps6_1;
  const T R6_22 = t6_10 - t6_4;
  const T t6_11 = t6_1 * eps6_3;
  const T t6_12 = t6_5 * eps6_4;
  const T R6_23 = t6_11 + t6_12;
  const T R6_31 = t6_8 + t6_9;
  const T R6_32 = t6_11 - t6_12;
  const T R6_33 = t6_10 - t6_2;
  // B11_6 = -R6^T omega6~ r6~
  const T t6_13 = R6_31 * omega6_1 - R6_11 * omega6_3;
  const T t6_14 = R6_11 * omega6_2 - R6_21 * omega6_1;
  const T minus_B11_6_11 = t6_13 * T(0.05) - t6_14 * T(0.2);
  const T t6_15 = R6_21 * omega6_3 - R6_31 * omega6_2;
  const T minus_B11_6_12 = t6_14 * T(0.1) - t6_15 * T(0.05);
  const T minus_B11_6_13 = t6_15 * T(0.2) - t6_13 * T(0.1);
  const T t6_16 = R6_32 * omega6_1 - R6_12 * omega6_3;
  const T t6_17 = R6_12 * omega6_2 - R6_22 * omega6_1;
  const T minus_B11_6_21 = t6_16 * T(0.05) - t6_17 * T(0.2);
  const T t6_18 = R6_22 * omega6_3 - R6_32 * omega6_2;
  const T minus_B11_6_22 = t6_17 * T(0.1) - t6_18 * T(0.05);
  const T minus_B11_6_23 = t6_18 * T(0.2) - t6_16 * T(0.1);
  const T t6_19 = R6_33 * omega6_1 - R6_13 * omega6_3;
  const T t6_20 = R6_13 * omega6_2 - R6_23 * omega6_1;
  const T minus_B11_6_31 = t6_19 * T(0.05) - t6_20 * T(0.2);
  const T t6_21 = R6_23 * omega6_3 - R6_33 * omega6_2;
  const T minus_B11_6_32 = t6_20 * T(0.1) - t6_21 * T(0.05);
  const T minus_B11_6_33 = t6_21 * T(0.2) - t6_19 * T(0.1);
  block[90] = -minus_B11_6_11;
  block[91] = -minus_B11_6_12;
  block[92] = -minus_B11_6_13;
  block[93] = -minus_B11_6_21;
  block[94] = -minus_B11_6_22;
  block[95] = -minus_B11_6_23;
  block[96] = -minus_B11_6_31;
  block[97] = -minus_B11_6_32;
  block[98] = -minus_B11_6_33;

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,0}, {1,54}, {2,57}, {1,108}, {3,111}, {4,114}, {1,162}, {3,165}, {5,168}, {6,171}, {1,216}, {3,219}, {5,222},
      {7,225}, {8,228}, {1,270}, {3,273}, {5,276}, {7,279}, {9,282}, {10,285},
  };
  for (int i = 0; i < 324; ++i) v_y_dot[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y_dot[place[1] + i * 18 + j] = block[9 * place[0] + 3 * i + j];
}

}  // namespace kanec::bench_cb6
