// SPDX-License-Identifier: BSD-3-Clause
// bench_s6b: equations of motion of 6 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 6f7cec86c3b4af98 of bench_s6b/scene.toml; the usual functions
// bodies and their joints:
//   1 body_1 on the inertial frame: free
//   2 body_2 on 1: ball
//   3 body_3 on 2: ball
//   4 body_4 on 2: ball
//   5 body_5 on 1: ball
//   6 body_6 on 5: ball
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, eps_2_1 .. eps_2_4, eps_3_1 .. eps_3_4, eps_4_1 .. eps_4_4, eps_5_1 .. eps_5_4,
//   eps_6_1 .. eps_6_4, s_1_1 .. s_1_3)
//   y = (omega_1_1 .. omega_1_3, omega_2_1 .. omega_2_3, omega_3_1 .. omega_3_3, omega_4_1 .. omega_4_3,
//   omega_5_1 .. omega_5_3, omega_6_1 .. omega_6_3, sdot_1_1 .. sdot_1_3)
//   eps       Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)
//   s         translation from the joint point, axes of the lower body [m]
//   omega     absolute angular velocity, body axes [rad/s] (3)
//   sdot      rate of s [m/s]
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              138 (48 add, 90 multiply)
//   poses                   309 (153 add, 156 multiply)
//   energy                  647 (295 add, 352 multiply)
//   momentum                876 (415 add, 461 multiply)
//   power                   386 (173 add, 213 multiply)
//   accelerations           2385 (1111 add, 1262 multiply, 12 divide)
//   residual                1174 (574 add, 600 multiply)
//   forcing                 1087 (513 add, 574 multiply)
//   mass_matrix             1004 (396 add, 608 multiply)
//   partial_velocities      381 (159 add, 222 multiply)
//   partial_velocity_rates  543 (213 add, 330 multiply)
#pragma once

namespace kanec::bench_s6b {

inline constexpr int n_bodies = 6;
inline constexpr int nx = 27;
inline constexpr int ny = 21;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 21;
inline constexpr char model_hash[] = "6f7cec86c3b4af98";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, eps_2_1 = 4, eps_2_2 = 5, eps_2_3 = 6,
    eps_2_4 = 7, eps_3_1 = 8, eps_3_2 = 9, eps_3_3 = 10, eps_3_4 = 11, eps_4_1 = 12, eps_4_2 = 13, eps_4_3 = 14,
    eps_4_4 = 15, eps_5_1 = 16, eps_5_2 = 17, eps_5_3 = 18, eps_5_4 = 19, eps_6_1 = 20, eps_6_2 = 21, eps_6_3 = 22,
    eps_6_4 = 23, s_1_1 = 24, s_1_2 = 25, s_1_3 = 26;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, omega_2_1 = 3, omega_2_2 = 4, omega_2_3 = 5,
    omega_3_1 = 6, omega_3_2 = 7, omega_3_3 = 8, omega_4_1 = 9, omega_4_2 = 10, omega_4_3 = 11, omega_5_1 = 12,
    omega_5_2 = 13, omega_5_3 = 14, omega_6_1 = 15, omega_6_2 = 16, omega_6_3 = 17, sdot_1_1 = 18, sdot_1_2 = 19,
    sdot_1_3 = 20;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 309;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2,
    3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5,
    5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8,
    8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 11, 11, 11, 11,
    11, 11, 11, 11, 11, 11, 11, 11, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 13, 13, 13, 13, 13, 13, 13, 13,
    13, 13, 13, 13, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15,
    16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 18, 18, 18, 18,
    18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19,
    19, 19, 19, 19, 19, 19, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
    20, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
    11, 12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 18, 19, 20, 0, 1, 2, 3, 4, 5, 6, 7,
    8, 9, 10, 11, 18, 19, 20, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 18, 19, 20, 0, 1, 2, 3, 4, 5, 6, 7, 8, 18, 19, 20,
    0, 1, 2, 3, 4, 5, 6, 7, 8, 18, 19, 20, 0, 1, 2, 3, 4, 5, 6, 7, 8, 18, 19, 20, 0, 1, 2, 3, 4, 5, 9, 10, 11, 18, 19,
    20, 0, 1, 2, 3, 4, 5, 9, 10, 11, 18, 19, 20, 0, 1, 2, 3, 4, 5, 9, 10, 11, 18, 19, 20, 0, 1, 2, 12, 13, 14, 15, 16,
    17, 18, 19, 20, 0, 1, 2, 12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 1, 2, 12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 1, 2,
    12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 1, 2, 12, 13, 14, 15, 16, 17, 18, 19, 20, 0, 1, 2, 12, 13, 14, 15, 16, 17,
    18, 19, 20, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
    11, 12, 13, 14, 15, 16, 17, 19, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 20};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
  T F_1_1 = T(0);
  T F_1_2 = T(0);
  T F_1_3 = T(0);
  T M_1_1 = T(0);
  T M_1_2 = T(0);
  T M_1_3 = T(0);
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

  // ---- body 4 (body_4) on body 2
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

  // ---- body 5 (body_5) on body 1
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

  // ---- results
  const T sdot1_1 = y[18], sdot1_2 = y[19], sdot1_3 = y[20];
  xdot[24] = sdot1_1;
  xdot[25] = sdot1_2;
  xdot[26] = sdot1_3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 153 add, 156 multiply
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[24], s1_2 = x[25], s1_3 = x[26];
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
  // p1 = s1 + R1^T r1: position of the mass centre, inertial axes [m]
  const T p1_1 = s1_1 + R1_11 * T(0.1) + R1_21 * T(0.2) + R1_31 * T(0.05);
  const T p1_2 = s1_2 + R1_12 * T(0.1) + R1_22 * T(0.2) + R1_32 * T(0.05);
  const T p1_3 = s1_3 + R1_13 * T(0.1) + R1_23 * T(0.2) + R1_33 * T(0.05);
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
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_13 = s1_1 + R1_31 * T(0.1) + R1_11 * T(0.3);
  const T P2_1 = t2_13 + R1_21 * T(0.1);
  const T t2_14 = s1_2 + R1_32 * T(0.1) + R1_12 * T(0.3);
  const T P2_2 = t2_14 + R1_22 * T(0.1);
  const T t2_15 = s1_3 + R1_33 * T(0.1) + R1_13 * T(0.3);
  const T P2_3 = t2_15 + R1_23 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_16 = P2_1 + R2_21 * T(0.2);
  const T p2_1 = R2_11 * T(0.1) + t2_16 + R2_31 * T(0.05);
  const T t2_17 = P2_2 + R2_22 * T(0.2);
  const T p2_2 = R2_12 * T(0.1) + t2_17 + R2_32 * T(0.05);
  const T t2_18 = P2_3 + R2_23 * T(0.2);
  const T p2_3 = R2_13 * T(0.1) + t2_18 + R2_33 * T(0.05);
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
  const T t3_13 = R2_11 * T(0.3) + R2_31 * T(0.1);
  const T P3_1 = t3_13 + P2_1 + R2_21 * T(0.15);
  const T t3_14 = R2_12 * T(0.3) + R2_32 * T(0.1);
  const T P3_2 = t3_14 + P2_2 + R2_22 * T(0.15);
  const T t3_15 = R2_13 * T(0.3) + R2_33 * T(0.1);
  const T P3_3 = t3_15 + P2_3 + R2_23 * T(0.15);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 + R3_11 * T(0.1) + R3_21 * T(0.2) + R3_31 * T(0.05);
  const T p3_2 = P3_2 + R3_12 * T(0.1) + R3_22 * T(0.2) + R3_32 * T(0.05);
  const T p3_3 = P3_3 + R3_13 * T(0.1) + R3_23 * T(0.2) + R3_33 * T(0.05);
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (body_4) on body 2
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
  // P4 = R2^T q4 + P2: position of the body origin, inertial axes [m]
  const T P4_1 = t3_13 + t2_16;
  const T P4_2 = t3_14 + t2_17;
  const T P4_3 = t3_15 + t2_18;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 + R4_11 * T(0.1) + R4_21 * T(0.2) + R4_31 * T(0.05);
  const T p4_2 = P4_2 + R4_12 * T(0.1) + R4_22 * T(0.2) + R4_32 * T(0.05);
  const T p4_3 = P4_3 + R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05);
  pose[45] = p4_1;
  pose[46] = p4_2;
  pose[47] = p4_3;

  // ---- body 5 (body_5) on body 1
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
  // P5 = s1 + R1^T q5: position of the body origin, inertial axes [m]
  const T P5_1 = t2_13 + R1_21 * T(0.25);
  const T P5_2 = t2_14 + R1_22 * T(0.25);
  const T P5_3 = t2_15 + R1_23 * T(0.25);
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
// 295 add, 352 multiply
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_3 = x[26];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[18], sdot1_2 = y[19], sdot1_3 = y[20];
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
  // p1 = s1 + R1^T r1: position of the mass centre, inertial axes [m]
  const T p1_3 = s1_3 + R1_13 * T(0.1) + R1_23 * T(0.2) + R1_33 * T(0.05);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T t1_14 = omega1_3 * T(0.1);
  const T t1_15 = t1_14 - omega1_1 * T(0.05);
  const T t1_16 = omega1_2 * T(0.1);
  const T t1_17 = omega1_1 * T(0.2) - t1_16;
  const T v1_1 = sdot1_1 + R1_11 * t1_13 + R1_21 * t1_15 + R1_31 * t1_17;
  const T v1_2 = sdot1_2 + R1_12 * t1_13 + R1_22 * t1_15 + R1_32 * t1_17;
  const T v1_3 = sdot1_3 + R1_13 * t1_13 + R1_23 * t1_15 + R1_33 * t1_17;
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
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_13 = s1_3 + R1_33 * T(0.1) + R1_13 * T(0.3);
  const T P2_3 = t2_13 + R1_23 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_14 = P2_3 + R2_23 * T(0.2);
  const T p2_3 = R2_13 * T(0.1) + t2_14 + R2_33 * T(0.05);
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_15 = omega1_1 * T(0.1);
  const T t2_16 = omega1_3 * T(0.3) - t2_15;
  const T t2_17 = sdot1_1 + R1_21 * t2_16;
  const T t2_18 = t1_16 - t1_14;
  const T t2_19 = omega1_2 * T(0.3);
  const T t2_20 = t2_15 - t2_19;
  const T Pdot2_1 = t2_17 + R1_11 * t2_18 + R1_31 * t2_20;
  const T t2_21 = sdot1_2 + R1_22 * t2_16;
  const T Pdot2_2 = t2_21 + R1_12 * t2_18 + R1_32 * t2_20;
  const T t2_22 = sdot1_3 + R1_23 * t2_16;
  const T Pdot2_3 = t2_22 + R1_13 * t2_18 + R1_33 * t2_20;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_23 = omega2_3 * T(0.2);
  const T t2_24 = omega2_2 * T(0.05) - t2_23;
  const T t2_25 = omega2_3 * T(0.1) - omega2_1 * T(0.05);
  const T t2_26 = omega2_1 * T(0.2);
  const T t2_27 = omega2_2 * T(0.1);
  const T t2_28 = t2_26 - t2_27;
  const T v2_1 = Pdot2_1 + R2_11 * t2_24 + R2_21 * t2_25 + R2_31 * t2_28;
  const T v2_2 = Pdot2_2 + R2_12 * t2_24 + R2_22 * t2_25 + R2_32 * t2_28;
  const T v2_3 = Pdot2_3 + R2_13 * t2_24 + R2_23 * t2_25 + R2_33 * t2_28;
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
  const T t3_13 = R2_13 * T(0.3) + R2_33 * T(0.1);
  const T P3_3 = t3_13 + P2_3 + R2_23 * T(0.15);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_3 = P3_3 + R3_13 * T(0.1) + R3_23 * T(0.2) + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_14 = t2_27 - omega2_3 * T(0.15);
  const T t3_15 = omega2_3 * T(0.3) - omega2_1 * T(0.1);
  const T t3_16 = Pdot2_1 + R2_21 * t3_15;
  const T t3_17 = omega2_2 * T(0.3);
  const T t3_18 = omega2_1 * T(0.15) - t3_17;
  const T Pdot3_1 = R2_11 * t3_14 + t3_16 + R2_31 * t3_18;
  const T t3_19 = Pdot2_2 + R2_22 * t3_15;
  const T Pdot3_2 = R2_12 * t3_14 + t3_19 + R2_32 * t3_18;
  const T t3_20 = Pdot2_3 + R2_23 * t3_15;
  const T Pdot3_3 = R2_13 * t3_14 + t3_20 + R2_33 * t3_18;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_21 = omega3_2 * T(0.05) - omega3_3 * T(0.2);
  const T t3_22 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_23 = omega3_1 * T(0.2) - omega3_2 * T(0.1);
  const T v3_1 = Pdot3_1 + R3_11 * t3_21 + R3_21 * t3_22 + R3_31 * t3_23;
  const T v3_2 = Pdot3_2 + R3_12 * t3_21 + R3_22 * t3_22 + R3_32 * t3_23;
  const T v3_3 = Pdot3_3 + R3_13 * t3_21 + R3_23 * t3_22 + R3_33 * t3_23;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (omega3_1 * (T(0.13) * omega3_1 + T(0.0065) * omega3_2 + T(0.0039) * omega3_3) + omega3_2 *
      (T(0.0065) * omega3_1 + T(0.156) * omega3_2 - T(0.0052) * omega3_3) + omega3_3 * (T(0.0039) * omega3_1 -
      T(0.0052) * omega3_2 + T(0.104) * omega3_3)) + T(0.65) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (body_4) on body 2
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
  // P4 = R2^T q4 + P2: position of the body origin, inertial axes [m]
  const T P4_3 = t3_13 + t2_14;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_3 = P4_3 + R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05);
  // Pdot4 = R2^T omega2~ q4 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = t2_27 - t2_23;
  const T t4_14 = t2_26 - t3_17;
  const T Pdot4_1 = R2_11 * t4_13 + t3_16 + R2_31 * t4_14;
  const T Pdot4_2 = R2_12 * t4_13 + t3_19 + R2_32 * t4_14;
  const T Pdot4_3 = R2_13 * t4_13 + t3_20 + R2_33 * t4_14;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_15 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_16 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_17 = omega4_1 * T(0.2) - omega4_2 * T(0.1);
  const T v4_1 = Pdot4_1 + R4_11 * t4_15 + R4_21 * t4_16 + R4_31 * t4_17;
  const T v4_2 = Pdot4_2 + R4_12 * t4_15 + R4_22 * t4_16 + R4_32 * t4_17;
  const T v4_3 = Pdot4_3 + R4_13 * t4_15 + R4_23 * t4_16 + R4_33 * t4_17;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (omega4_1 * (T(0.14) * omega4_1 + T(0.007) * omega4_2 + T(0.0042) * omega4_3) + omega4_2 *
      (T(0.007) * omega4_1 + T(0.168) * omega4_2 - T(0.0056) * omega4_3) + omega4_3 * (T(0.0042) * omega4_1 -
      T(0.0056) * omega4_2 + T(0.112) * omega4_3)) + T(0.7) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (body_5) on body 1
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
  // P5 = s1 + R1^T q5: position of the body origin, inertial axes [m]
  const T P5_3 = t2_13 + R1_23 * T(0.25);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_3 = P5_3 + R5_13 * T(0.1) + R5_23 * T(0.2) + R5_33 * T(0.05);
  // Pdot5 = sdot1 + R1^T omega1~ q5: velocity of the body origin, inertial axes [m/s]
  const T t5_13 = t1_16 - omega1_3 * T(0.25);
  const T t5_14 = omega1_1 * T(0.25) - t2_19;
  const T Pdot5_1 = t2_17 + R1_11 * t5_13 + R1_31 * t5_14;
  const T Pdot5_2 = t2_21 + R1_12 * t5_13 + R1_32 * t5_14;
  const T Pdot5_3 = t2_22 + R1_13 * t5_13 + R1_33 * t5_14;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_15 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_16 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_17 = omega5_2 * T(0.1);
  const T t5_18 = omega5_1 * T(0.2) - t5_17;
  const T v5_1 = Pdot5_1 + R5_11 * t5_15 + R5_21 * t5_16 + R5_31 * t5_18;
  const T v5_2 = Pdot5_2 + R5_12 * t5_15 + R5_22 * t5_16 + R5_32 * t5_18;
  const T v5_3 = Pdot5_3 + R5_13 * t5_15 + R5_23 * t5_16 + R5_33 * t5_18;
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
  const T t6_14 = t5_17 - t6_13;
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
// 415 add, 461 multiply
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[24], s1_2 = x[25], s1_3 = x[26];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[18], sdot1_2 = y[19], sdot1_3 = y[20];
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
  // p1 = s1 + R1^T r1: position of the mass centre, inertial axes [m]
  const T p1_1 = s1_1 + R1_11 * T(0.1) + R1_21 * T(0.2) + R1_31 * T(0.05);
  const T p1_2 = s1_2 + R1_12 * T(0.1) + R1_22 * T(0.2) + R1_32 * T(0.05);
  const T p1_3 = s1_3 + R1_13 * T(0.1) + R1_23 * T(0.2) + R1_33 * T(0.05);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T t1_14 = omega1_3 * T(0.1);
  const T t1_15 = t1_14 - omega1_1 * T(0.05);
  const T t1_16 = omega1_2 * T(0.1);
  const T t1_17 = omega1_1 * T(0.2) - t1_16;
  const T v1_1 = sdot1_1 + R1_11 * t1_13 + R1_21 * t1_15 + R1_31 * t1_17;
  const T v1_2 = sdot1_2 + R1_12 * t1_13 + R1_22 * t1_15 + R1_32 * t1_17;
  const T v1_3 = sdot1_3 + R1_13 * t1_13 + R1_23 * t1_15 + R1_33 * t1_17;
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
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_13 = s1_1 + R1_31 * T(0.1) + R1_11 * T(0.3);
  const T P2_1 = t2_13 + R1_21 * T(0.1);
  const T t2_14 = s1_2 + R1_32 * T(0.1) + R1_12 * T(0.3);
  const T P2_2 = t2_14 + R1_22 * T(0.1);
  const T t2_15 = s1_3 + R1_33 * T(0.1) + R1_13 * T(0.3);
  const T P2_3 = t2_15 + R1_23 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_16 = P2_1 + R2_21 * T(0.2);
  const T p2_1 = R2_11 * T(0.1) + t2_16 + R2_31 * T(0.05);
  const T t2_17 = P2_2 + R2_22 * T(0.2);
  const T p2_2 = R2_12 * T(0.1) + t2_17 + R2_32 * T(0.05);
  const T t2_18 = P2_3 + R2_23 * T(0.2);
  const T p2_3 = R2_13 * T(0.1) + t2_18 + R2_33 * T(0.05);
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_19 = omega1_1 * T(0.1);
  const T t2_20 = omega1_3 * T(0.3) - t2_19;
  const T t2_21 = sdot1_1 + R1_21 * t2_20;
  const T t2_22 = t1_16 - t1_14;
  const T t2_23 = omega1_2 * T(0.3);
  const T t2_24 = t2_19 - t2_23;
  const T Pdot2_1 = t2_21 + R1_11 * t2_22 + R1_31 * t2_24;
  const T t2_25 = sdot1_2 + R1_22 * t2_20;
  const T Pdot2_2 = t2_25 + R1_12 * t2_22 + R1_32 * t2_24;
  const T t2_26 = sdot1_3 + R1_23 * t2_20;
  const T Pdot2_3 = t2_26 + R1_13 * t2_22 + R1_33 * t2_24;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_27 = omega2_3 * T(0.2);
  const T t2_28 = omega2_2 * T(0.05) - t2_27;
  const T t2_29 = omega2_3 * T(0.1) - omega2_1 * T(0.05);
  const T t2_30 = omega2_1 * T(0.2);
  const T t2_31 = omega2_2 * T(0.1);
  const T t2_32 = t2_30 - t2_31;
  const T v2_1 = Pdot2_1 + R2_11 * t2_28 + R2_21 * t2_29 + R2_31 * t2_32;
  const T v2_2 = Pdot2_2 + R2_12 * t2_28 + R2_22 * t2_29 + R2_32 * t2_32;
  const T v2_3 = Pdot2_3 + R2_13 * t2_28 + R2_23 * t2_29 + R2_33 * t2_32;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(1.2) * v2_1;
  const T l2_2 = T(1.2) * v2_2;
  const T l2_3 = T(1.2) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_33 = T(0.12) * omega2_1 + T(0.006) * omega2_2 + T(0.0036) * omega2_3;
  const T t2_34 = T(0.006) * omega2_1 + T(0.144) * omega2_2 - T(0.0048) * omega2_3;
  const T t2_35 = T(0.0036) * omega2_1 - T(0.0048) * omega2_2 + T(0.096) * omega2_3;
  const T H2_1 = R2_11 * t2_33 + R2_21 * t2_34 + R2_31 * t2_35 + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = R2_12 * t2_33 + R2_22 * t2_34 + R2_32 * t2_35 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = R2_13 * t2_33 + R2_23 * t2_34 + R2_33 * t2_35 + p2_1 * l2_2 - p2_2 * l2_1;

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
  const T t3_13 = R2_11 * T(0.3) + R2_31 * T(0.1);
  const T P3_1 = t3_13 + P2_1 + R2_21 * T(0.15);
  const T t3_14 = R2_12 * T(0.3) + R2_32 * T(0.1);
  const T P3_2 = t3_14 + P2_2 + R2_22 * T(0.15);
  const T t3_15 = R2_13 * T(0.3) + R2_33 * T(0.1);
  const T P3_3 = t3_15 + P2_3 + R2_23 * T(0.15);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 + R3_11 * T(0.1) + R3_21 * T(0.2) + R3_31 * T(0.05);
  const T p3_2 = P3_2 + R3_12 * T(0.1) + R3_22 * T(0.2) + R3_32 * T(0.05);
  const T p3_3 = P3_3 + R3_13 * T(0.1) + R3_23 * T(0.2) + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_16 = t2_31 - omega2_3 * T(0.15);
  const T t3_17 = omega2_3 * T(0.3) - omega2_1 * T(0.1);
  const T t3_18 = Pdot2_1 + R2_21 * t3_17;
  const T t3_19 = omega2_2 * T(0.3);
  const T t3_20 = omega2_1 * T(0.15) - t3_19;
  const T Pdot3_1 = R2_11 * t3_16 + t3_18 + R2_31 * t3_20;
  const T t3_21 = Pdot2_2 + R2_22 * t3_17;
  const T Pdot3_2 = R2_12 * t3_16 + t3_21 + R2_32 * t3_20;
  const T t3_22 = Pdot2_3 + R2_23 * t3_17;
  const T Pdot3_3 = R2_13 * t3_16 + t3_22 + R2_33 * t3_20;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_23 = omega3_2 * T(0.05) - omega3_3 * T(0.2);
  const T t3_24 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_25 = omega3_1 * T(0.2) - omega3_2 * T(0.1);
  const T v3_1 = Pdot3_1 + R3_11 * t3_23 + R3_21 * t3_24 + R3_31 * t3_25;
  const T v3_2 = Pdot3_2 + R3_12 * t3_23 + R3_22 * t3_24 + R3_32 * t3_25;
  const T v3_3 = Pdot3_3 + R3_13 * t3_23 + R3_23 * t3_24 + R3_33 * t3_25;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(1.3) * v3_1;
  const T l3_2 = T(1.3) * v3_2;
  const T l3_3 = T(1.3) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_26 = T(0.13) * omega3_1 + T(0.0065) * omega3_2 + T(0.0039) * omega3_3;
  const T t3_27 = T(0.0065) * omega3_1 + T(0.156) * omega3_2 - T(0.0052) * omega3_3;
  const T t3_28 = T(0.0039) * omega3_1 - T(0.0052) * omega3_2 + T(0.104) * omega3_3;
  const T H3_1 = R3_11 * t3_26 + R3_21 * t3_27 + R3_31 * t3_28 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = R3_12 * t3_26 + R3_22 * t3_27 + R3_32 * t3_28 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R3_13 * t3_26 + R3_23 * t3_27 + R3_33 * t3_28 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (body_4) on body 2
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
  // P4 = R2^T q4 + P2: position of the body origin, inertial axes [m]
  const T P4_1 = t3_13 + t2_16;
  const T P4_2 = t3_14 + t2_17;
  const T P4_3 = t3_15 + t2_18;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 + R4_11 * T(0.1) + R4_21 * T(0.2) + R4_31 * T(0.05);
  const T p4_2 = P4_2 + R4_12 * T(0.1) + R4_22 * T(0.2) + R4_32 * T(0.05);
  const T p4_3 = P4_3 + R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05);
  // Pdot4 = R2^T omega2~ q4 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = t2_31 - t2_27;
  const T t4_14 = t2_30 - t3_19;
  const T Pdot4_1 = R2_11 * t4_13 + t3_18 + R2_31 * t4_14;
  const T Pdot4_2 = R2_12 * t4_13 + t3_21 + R2_32 * t4_14;
  const T Pdot4_3 = R2_13 * t4_13 + t3_22 + R2_33 * t4_14;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_15 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_16 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_17 = omega4_1 * T(0.2) - omega4_2 * T(0.1);
  const T v4_1 = Pdot4_1 + R4_11 * t4_15 + R4_21 * t4_16 + R4_31 * t4_17;
  const T v4_2 = Pdot4_2 + R4_12 * t4_15 + R4_22 * t4_16 + R4_32 * t4_17;
  const T v4_3 = Pdot4_3 + R4_13 * t4_15 + R4_23 * t4_16 + R4_33 * t4_17;
  // l4 = m4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(1.4) * v4_1;
  const T l4_2 = T(1.4) * v4_2;
  const T l4_3 = T(1.4) * v4_3;
  // H4 = R4^T I4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_18 = T(0.14) * omega4_1 + T(0.007) * omega4_2 + T(0.0042) * omega4_3;
  const T t4_19 = T(0.007) * omega4_1 + T(0.168) * omega4_2 - T(0.0056) * omega4_3;
  const T t4_20 = T(0.0042) * omega4_1 - T(0.0056) * omega4_2 + T(0.112) * omega4_3;
  const T H4_1 = R4_11 * t4_18 + R4_21 * t4_19 + R4_31 * t4_20 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_18 + R4_22 * t4_19 + R4_32 * t4_20 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R4_13 * t4_18 + R4_23 * t4_19 + R4_33 * t4_20 + p4_1 * l4_2 - p4_2 * l4_1;

  // ---- body 5 (body_5) on body 1
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
  // P5 = s1 + R1^T q5: position of the body origin, inertial axes [m]
  const T P5_1 = t2_13 + R1_21 * T(0.25);
  const T P5_2 = t2_14 + R1_22 * T(0.25);
  const T P5_3 = t2_15 + R1_23 * T(0.25);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_1 = P5_1 + R5_11 * T(0.1) + R5_21 * T(0.2) + R5_31 * T(0.05);
  const T p5_2 = P5_2 + R5_12 * T(0.1) + R5_22 * T(0.2) + R5_32 * T(0.05);
  const T p5_3 = P5_3 + R5_13 * T(0.1) + R5_23 * T(0.2) + R5_33 * T(0.05);
  // Pdot5 = sdot1 + R1^T omega1~ q5: velocity of the body origin, inertial axes [m/s]
  const T t5_13 = t1_16 - omega1_3 * T(0.25);
  const T t5_14 = omega1_1 * T(0.25) - t2_23;
  const T Pdot5_1 = t2_21 + R1_11 * t5_13 + R1_31 * t5_14;
  const T Pdot5_2 = t2_25 + R1_12 * t5_13 + R1_32 * t5_14;
  const T Pdot5_3 = t2_26 + R1_13 * t5_13 + R1_33 * t5_14;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_15 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_16 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_17 = omega5_2 * T(0.1);
  const T t5_18 = omega5_1 * T(0.2) - t5_17;
  const T v5_1 = Pdot5_1 + R5_11 * t5_15 + R5_21 * t5_16 + R5_31 * t5_18;
  const T v5_2 = Pdot5_2 + R5_12 * t5_15 + R5_22 * t5_16 + R5_32 * t5_18;
  const T v5_3 = Pdot5_3 + R5_13 * t5_15 + R5_23 * t5_16 + R5_33 * t5_18;
  // l5 = m5 v5: linear momentum, inertial axes [kg m/s]
  const T l5_1 = T(1.5) * v5_1;
  const T l5_2 = T(1.5) * v5_2;
  const T l5_3 = T(1.5) * v5_3;
  // H5 = R5^T I5 omega5 + p5~ l5: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t5_19 = T(0.15) * omega5_1 + T(0.0075) * omega5_2 + T(0.0045) * omega5_3;
  const T t5_20 = T(0.0075) * omega5_1 + T(0.18) * omega5_2 - T(0.006) * omega5_3;
  const T t5_21 = T(0.0045) * omega5_1 - T(0.006) * omega5_2 + T(0.12) * omega5_3;
  const T H5_1 = R5_11 * t5_19 + R5_21 * t5_20 + R5_31 * t5_21 + p5_2 * l5_3 - p5_3 * l5_2;
  const T H5_2 = R5_12 * t5_19 + R5_22 * t5_20 + R5_32 * t5_21 + p5_3 * l5_1 - p5_1 * l5_3;
  const T H5_3 = R5_13 * t5_19 + R5_23 * t5_20 + R5_33 * t5_21 + p5_1 * l5_2 - p5_2 * l5_1;

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
  const T t6_14 = t5_17 - t6_13;
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
// 173 add, 213 multiply
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

  // ---- body 4 (body_4) on body 2
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

  // ---- body 5 (body_5) on body 1
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
  const T sdot1_1 = y[18], sdot1_2 = y[19], sdot1_3 = y[20];
  // power = -R1 R2^T M_torque_2_ . omega1 - R1 R5^T M_torque_5_ . omega1 - R2 R3^T M_torque_3_ . omega2 - R2 R4^T
  //   M_torque_4_ . omega2 - R5 R6^T M_torque_6_ . omega5 + F1 . (sdot1 + R1^T omega1~ r1) + M1 . omega1 +
  //   M_torque_2_ . omega2 + M_torque_3_ . omega3 + M_torque_4_ . omega4 + M_torque_5_ . omega5 + M_torque_6_ .
  //   omega6: power of the applied loads [W]
  const T b0_1 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T b0_2 = omega1_3 * T(0.1) - omega1_1 * T(0.05);
  const T b0_3 = omega1_1 * T(0.2) - omega1_2 * T(0.1);
  const T b0_4 = R2_11 * u.tau_2_1 + R2_21 * u.tau_2_2 + R2_31 * u.tau_2_3;
  const T b0_5 = R2_12 * u.tau_2_1 + R2_22 * u.tau_2_2 + R2_32 * u.tau_2_3;
  const T b0_6 = R2_13 * u.tau_2_1 + R2_23 * u.tau_2_2 + R2_33 * u.tau_2_3;
  const T b0_7 = R5_11 * u.tau_5_1 + R5_21 * u.tau_5_2 + R5_31 * u.tau_5_3;
  const T b0_8 = R5_12 * u.tau_5_1 + R5_22 * u.tau_5_2 + R5_32 * u.tau_5_3;
  const T b0_9 = R5_13 * u.tau_5_1 + R5_23 * u.tau_5_2 + R5_33 * u.tau_5_3;
  const T b0_10 = R3_11 * u.tau_3_1 + R3_21 * u.tau_3_2 + R3_31 * u.tau_3_3;
  const T b0_11 = R3_12 * u.tau_3_1 + R3_22 * u.tau_3_2 + R3_32 * u.tau_3_3;
  const T b0_12 = R3_13 * u.tau_3_1 + R3_23 * u.tau_3_2 + R3_33 * u.tau_3_3;
  const T b0_13 = R4_11 * u.tau_4_1 + R4_21 * u.tau_4_2 + R4_31 * u.tau_4_3;
  const T b0_14 = R4_12 * u.tau_4_1 + R4_22 * u.tau_4_2 + R4_32 * u.tau_4_3;
  const T b0_15 = R4_13 * u.tau_4_1 + R4_23 * u.tau_4_2 + R4_33 * u.tau_4_3;
  const T b0_16 = R6_11 * u.tau_6_1 + R6_21 * u.tau_6_2 + R6_31 * u.tau_6_3;
  const T b0_17 = R6_12 * u.tau_6_1 + R6_22 * u.tau_6_2 + R6_32 * u.tau_6_3;
  const T b0_18 = R6_13 * u.tau_6_1 + R6_23 * u.tau_6_2 + R6_33 * u.tau_6_3;
  const T power = u.F_1_1 * (sdot1_1 + R1_11 * b0_1 + R1_21 * b0_2 + R1_31 * b0_3) - ((R1_11 * b0_4 + R1_12 * b0_5 +
      R1_13 * b0_6) * omega1_1 + (R1_21 * b0_4 + R1_22 * b0_5 + R1_23 * b0_6) * omega1_2 + (R1_31 * b0_4 + R1_32 *
      b0_5 + R1_33 * b0_6) * omega1_3 + (R1_11 * b0_7 + R1_12 * b0_8 + R1_13 * b0_9) * omega1_1 + (R1_21 * b0_7 +
      R1_22 * b0_8 + R1_23 * b0_9) * omega1_2 + (R1_31 * b0_7 + R1_32 * b0_8 + R1_33 * b0_9) * omega1_3 + (R2_11 *
      b0_10 + R2_12 * b0_11 + R2_13 * b0_12) * omega2_1 + (R2_21 * b0_10 + R2_22 * b0_11 + R2_23 * b0_12) * omega2_2 +
      (R2_31 * b0_10 + R2_32 * b0_11 + R2_33 * b0_12) * omega2_3 + (R2_11 * b0_13 + R2_12 * b0_14 + R2_13 * b0_15) *
      omega2_1 + (R2_21 * b0_13 + R2_22 * b0_14 + R2_23 * b0_15) * omega2_2 + (R2_31 * b0_13 + R2_32 * b0_14 + R2_33 *
      b0_15) * omega2_3 + (R5_11 * b0_16 + R5_12 * b0_17 + R5_13 * b0_18) * omega5_1 + (R5_21 * b0_16 + R5_22 * b0_17
      + R5_23 * b0_18) * omega5_2 + (R5_31 * b0_16 + R5_32 * b0_17 + R5_33 * b0_18) * omega5_3) + u.F_1_2 * (sdot1_2 +
      R1_12 * b0_1 + R1_22 * b0_2 + R1_32 * b0_3) + u.F_1_3 * (sdot1_3 + R1_13 * b0_1 + R1_23 * b0_2 + R1_33 * b0_3) +
      u.M_1_1 * omega1_1 + u.M_1_2 * omega1_2 + u.M_1_3 * omega1_3 + u.tau_2_1 * omega2_1 + u.tau_2_2 * omega2_2 +
      u.tau_2_3 * omega2_3 + u.tau_3_1 * omega3_1 + u.tau_3_2 * omega3_2 + u.tau_3_3 * omega3_3 + u.tau_4_1 * omega4_1
      + u.tau_4_2 * omega4_2 + u.tau_4_3 * omega4_3 + u.tau_5_1 * omega5_1 + u.tau_5_2 * omega5_2 + u.tau_5_3 *
      omega5_3 + u.tau_6_1 * omega6_1 + u.tau_6_2 * omega6_2 + u.tau_6_3 * omega6_3;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 1111 add, 1262 multiply, 12 divide
// by: articulated; composite would take 1652 add, 2009 multiply, 12 divide
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot)
    noexcept {

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
  // U1 = omega1~ omega1~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t1_13 = omega1_3 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T minus_U1_11 = t1_13 + t1_14;
  const T U1_12 = omega1_2 * omega1_1;
  const T U1_13 = omega1_3 * omega1_1;
  const T t1_15 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_15;
  const T U1_23 = omega1_3 * omega1_2;
  const T minus_U1_33 = t1_14 + t1_15;
  // G1 = R1 F1 - U1 h_all_1: applied less inertia force, body axes [N]
  const T t1_16 = R1_11 * u.F_1_1 + R1_12 * u.F_1_2 + R1_13 * u.F_1_3;
  const T G1_1 = t1_16 + minus_U1_11 * T(2.21) - U1_12 * T(1.385) - U1_13 * T(0.755);
  const T t1_17 = R1_21 * u.F_1_1 + R1_22 * u.F_1_2 + R1_23 * u.F_1_3;
  const T G1_2 = t1_17 + minus_U1_22 * T(1.385) - U1_12 * T(2.21) - U1_23 * T(0.755);
  const T t1_18 = R1_31 * u.F_1_1 + R1_32 * u.F_1_2 + R1_33 * u.F_1_3;
  const T G1_3 = t1_18 - U1_13 * T(2.21) - U1_23 * T(1.385) + minus_U1_33 * T(0.755);

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
  // Pddot2 = C2 U1 q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_16 = minus_U1_11 * T(0.3) - U1_13 * T(0.1);
  const T t2_17 = U1_12 * T(0.1) - t2_16;
  const T t2_18 = U1_23 * T(0.1);
  const T t2_19 = t2_18 + U1_12 * T(0.3);
  const T t2_20 = t2_19 - minus_U1_22 * T(0.1);
  const T t2_21 = U1_13 * T(0.3) - minus_U1_33 * T(0.1);
  const T t2_22 = t2_21 + t2_18;
  const T Pddot2_1 = C2_11 * t2_17 + C2_12 * t2_20 + C2_13 * t2_22;
  const T Pddot2_2 = C2_21 * t2_17 + C2_22 * t2_20 + C2_23 * t2_22;
  const T Pddot2_3 = C2_31 * t2_17 + C2_32 * t2_20 + C2_33 * t2_22;
  // G2 = -U2 h_all_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_12 * T(0.715) - minus_U2_11 * T(0.9299999999999999) + U2_13 * T(0.33);
  const T minus_G2_2 = U2_12 * T(0.9299999999999999) - minus_U2_22 * T(0.715) + U2_23 * T(0.33);
  const T minus_G2_3 = U2_13 * T(0.9299999999999999) + U2_23 * T(0.715) - minus_U2_33 * T(0.33);

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
  const T t3_16 = Pddot2_1 - minus_U2_11 * T(0.3) + U2_13 * T(0.1);
  const T t3_17 = t3_16 + U2_12 * T(0.15);
  const T t3_18 = Pddot2_2 + U2_12 * T(0.3) + U2_23 * T(0.1);
  const T t3_19 = t3_18 - minus_U2_22 * T(0.15);
  const T t3_20 = Pddot2_3 + U2_13 * T(0.3) - minus_U2_33 * T(0.1);
  const T t3_21 = t3_20 + U2_23 * T(0.15);
  const T Pddot3_1 = C3_11 * t3_17 + C3_12 * t3_19 + C3_13 * t3_21;
  const T Pddot3_2 = C3_21 * t3_17 + C3_22 * t3_19 + C3_23 * t3_21;
  const T Pddot3_3 = C3_31 * t3_17 + C3_32 * t3_19 + C3_33 * t3_21;
  // G3 = -U3 h_all_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = U3_12 * T(0.26) - minus_U3_11 * T(0.13) + U3_13 * T(0.065);
  const T minus_G3_2 = U3_12 * T(0.13) - minus_U3_22 * T(0.26) + U3_23 * T(0.065);
  const T minus_G3_3 = U3_13 * T(0.13) + U3_23 * T(0.26) - minus_U3_33 * T(0.065);
  // N3 = -h_all_3~ Pddot3 - omega3~ J_all_3 omega3 + M_torque_3_: applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N3_1 = u.tau_3_1 + T(0.065) * Pddot3_2 - T(0.26) * Pddot3_3 + T(0.0032499999999999977) * U3_23 + T(0.0182) *
      (t3_14 - t3_13) + T(0.002600000000000001) * U3_12 - T(0.019500000000000003) * U3_13;
  const T N3_2 = u.tau_3_2 + T(0.13) * Pddot3_3 - T(0.065) * Pddot3_1 - T(0.016250000000000007) * U3_13 +
      T(0.002600000000000001) * (t3_13 - t3_15) + T(0.019500000000000003) * U3_23 - T(0.0182) * U3_12;
  const T N3_3 = u.tau_3_3 + T(0.26) * Pddot3_1 - T(0.13) * Pddot3_2 + T(0.01300000000000001) * U3_12 +
      T(0.019500000000000003) * (t3_15 - t3_14) + T(0.0182) * U3_13 - T(0.002600000000000001) * U3_23;

  // ---- body 4 (body_4) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  // erel4 = -e2~ e4 + eps4_2 e4 - eps4_4 e2: Euler parameters relative to the lower body
  const T erel4_1 = eps2_3 * eps4_2 - eps2_2 * eps4_3 + eps2_4 * eps4_1 - eps4_4 * eps2_1;
  const T erel4_2 = eps2_1 * eps4_3 - eps2_3 * eps4_1 + eps2_4 * eps4_2 - eps4_4 * eps2_2;
  const T erel4_3 = eps2_2 * eps4_1 - eps2_1 * eps4_2 + eps2_4 * eps4_3 - eps4_4 * eps2_3;
  // eps4rel4 = e2 . e4 + eps4_2 eps4_4
  const T eps4rel4 = eps2_1 * eps4_1 + eps2_2 * eps4_2 + eps2_3 * eps4_3 + eps2_4 * eps4_4;
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
  // Pddot4 = C4 (U2 q4 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_16 = t3_16 + U2_12 * T(0.2);
  const T t4_17 = t3_18 - minus_U2_22 * T(0.2);
  const T t4_18 = t3_20 + U2_23 * T(0.2);
  const T Pddot4_1 = C4_11 * t4_16 + C4_12 * t4_17 + C4_13 * t4_18;
  const T Pddot4_2 = C4_21 * t4_16 + C4_22 * t4_17 + C4_23 * t4_18;
  const T Pddot4_3 = C4_31 * t4_16 + C4_32 * t4_17 + C4_33 * t4_18;
  // N2 = -C3^T M_torque_3_ - C4^T M_torque_4_ - h_all_2~ Pddot2 - omega2~ J_all_2 omega2 + M_torque_2_: applied less
  //   inertia moment about the body origin, body axes [N m]
  const T N2_1 = u.tau_2_1 - C3_11 * u.tau_3_1 - C3_21 * u.tau_3_2 - C3_31 * u.tau_3_3 - C4_11 * u.tau_4_1 - C4_21 *
      u.tau_4_2 - C4_31 * u.tau_4_3 - T(0.715) * Pddot2_3 + T(0.33) * Pddot2_2 - T(0.055250000000000014) * U2_23 +
      T(0.0643) * (t2_14 - t2_13) + T(0.0834) * U2_12 - T(0.1605) * U2_13;
  const T N2_2 = u.tau_2_2 - C3_12 * u.tau_3_1 - C3_22 * u.tau_3_2 - C3_32 * u.tau_3_3 - C4_12 * u.tau_4_1 - C4_22 *
      u.tau_4_2 - C4_32 * u.tau_4_3 - T(0.33) * Pddot2_1 + T(0.9299999999999999) * Pddot2_3 + T(0.20099999999999998) *
      U2_13 + T(0.0834) * (t2_13 - t2_15) + T(0.1605) * U2_23 - T(0.0643) * U2_12;
  const T N2_3 = u.tau_2_3 - C3_13 * u.tau_3_1 - C3_23 * u.tau_3_2 - C3_33 * u.tau_3_3 - C4_13 * u.tau_4_1 - C4_23 *
      u.tau_4_2 - C4_33 * u.tau_4_3 - T(0.9299999999999999) * Pddot2_2 + T(0.715) * Pddot2_1 - T(0.14574999999999996)
      * U2_12 + T(0.1605) * (t2_15 - t2_14) + T(0.0643) * U2_13 - T(0.0834) * U2_23;
  // G4 = -U4 h_all_4: applied less inertia force, body axes [N]
  const T minus_G4_1 = U4_12 * T(0.27999999999999997) - minus_U4_11 * T(0.13999999999999999) + U4_13 *
      T(0.06999999999999999);
  const T minus_G4_2 = U4_12 * T(0.13999999999999999) - minus_U4_22 * T(0.27999999999999997) + U4_23 *
      T(0.06999999999999999);
  const T minus_G4_3 = U4_13 * T(0.13999999999999999) + U4_23 * T(0.27999999999999997) - minus_U4_33 *
      T(0.06999999999999999);
  // N4 = -h_all_4~ Pddot4 - omega4~ J_all_4 omega4 + M_torque_4_: applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N4_1 = u.tau_4_1 + T(0.06999999999999999) * Pddot4_2 - T(0.27999999999999997) * Pddot4_3 +
      T(0.0035000000000000057) * U4_23 + T(0.0196) * (t4_14 - t4_13) + T(0.0028000000000000004) * U4_12 - T(0.021) *
      U4_13;
  const T N4_2 = u.tau_4_2 + T(0.13999999999999999) * Pddot4_3 - T(0.06999999999999999) * Pddot4_1 -
      T(0.017500000000000012) * U4_13 + T(0.0028000000000000004) * (t4_13 - t4_15) + T(0.021) * U4_23 - T(0.0196) *
      U4_12;
  const T N4_3 = u.tau_4_3 + T(0.27999999999999997) * Pddot4_1 - T(0.13999999999999999) * Pddot4_2 +
      T(0.014000000000000005) * U4_12 + T(0.021) * (t4_15 - t4_14) + T(0.0196) * U4_13 - T(0.0028000000000000004) *
      U4_23;

  // ---- body 5 (body_5) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  // erel5 = -e1~ e5 + eps4_1 e5 - eps4_5 e1: Euler parameters relative to the lower body
  const T erel5_1 = eps1_3 * eps5_2 - eps1_2 * eps5_3 + eps1_4 * eps5_1 - eps5_4 * eps1_1;
  const T erel5_2 = eps1_1 * eps5_3 - eps1_3 * eps5_1 + eps1_4 * eps5_2 - eps5_4 * eps1_2;
  const T erel5_3 = eps1_2 * eps5_1 - eps1_1 * eps5_2 + eps1_4 * eps5_3 - eps5_4 * eps1_3;
  // eps4rel5 = e1 . e5 + eps4_1 eps4_5
  const T eps4rel5 = eps1_1 * eps5_1 + eps1_2 * eps5_2 + eps1_3 * eps5_3 + eps1_4 * eps5_4;
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
  // Pddot5 = C5 U1 q5: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_16 = U1_12 * T(0.25) - t2_16;
  const T t5_17 = t2_19 - minus_U1_22 * T(0.25);
  const T t5_18 = t2_21 + U1_23 * T(0.25);
  const T Pddot5_1 = C5_11 * t5_16 + C5_12 * t5_17 + C5_13 * t5_18;
  const T Pddot5_2 = C5_21 * t5_16 + C5_22 * t5_17 + C5_23 * t5_18;
  const T Pddot5_3 = C5_31 * t5_16 + C5_32 * t5_17 + C5_33 * t5_18;
  // N1 = -C2^T M_torque_2_ - C5^T M_torque_5_ + r1~ R1 F1 - omega1~ J_all_1 omega1 + M1: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N1_1 = u.M_1_1 - C2_11 * u.tau_2_1 - C2_21 * u.tau_2_2 - C2_31 * u.tau_2_3 - C5_11 * u.tau_5_1 - C5_21 *
      u.tau_5_2 - C5_31 * u.tau_5_3 + T(0.2) * t1_18 - T(0.05) * t1_17 - T(0.16) * U1_23 + T(0.13190000000000002) *
      (t1_14 - t1_13) + T(0.2122) * U1_12 - T(0.366) * U1_13;
  const T N1_2 = u.M_1_2 - C2_12 * u.tau_2_1 - C2_22 * u.tau_2_2 - C2_32 * u.tau_2_3 - C5_12 * u.tau_5_1 - C5_22 *
      u.tau_5_2 - C5_32 * u.tau_5_3 + T(0.05) * t1_16 - T(0.1) * t1_18 + T(0.5462499999999999) * U1_13 + T(0.2122) *
      (t1_13 - t1_15) + T(0.366) * U1_23 - T(0.13190000000000002) * U1_12;
  const T N1_3 = u.M_1_3 - C2_13 * u.tau_2_1 - C2_23 * u.tau_2_2 - C2_33 * u.tau_2_3 - C5_13 * u.tau_5_1 - C5_23 *
      u.tau_5_2 - C5_33 * u.tau_5_3 + T(0.1) * t1_17 - T(0.2) * t1_16 - T(0.3862499999999999) * U1_12 + T(0.366) *
      (t1_15 - t1_14) + T(0.13190000000000002) * U1_13 - T(0.2122) * U1_23;
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
  // w_4 = D(LD4)^-1 L(LD4)^-1 N4: D^-1 L^-1 n
  const T w_4_1 = T(5.012531328320802) * N4_1;
  const T b4_1 = N4_2 + T(0.10526315789473684) * N4_1;
  const T w_4_2 = T(5.455850681981335) * b4_1;
  const T w_4_3 = T(5.561695883115324) * (N4_3 + T(0.014035087719298248) * N4_1 + T(0.10854271356783919) * b4_1);
  // gb4 = G4 - Y4^T w_4: force with the ball solved [N]
  const T minus_gb4_1 = minus_G4_1 + T(0.06999999999999999) * w_4_2 - T(0.2724020100502513) * w_4_3;
  const T minus_gb4_2 = minus_G4_2 - T(0.007368421052631579) * w_4_2 - T(0.06999999999999999) * w_4_1 +
      T(0.1382177554438861) * w_4_3;
  const T minus_gb4_3 = minus_G4_3 + T(0.27999999999999997) * w_4_1 - T(0.11052631578947368) * w_4_2 -
      T(0.008067001675041876) * w_4_3;
  // Mb4 = C4^T M4 C4: M of the joint, lower body's axes
  const T b4_2 = C4_11 * T(0.43942738195230613) - C4_21 * T(0.2122163386042435) - C4_31 * T(0.029989409487638313);
  const T b4_3 = C4_21 * T(0.13110908227732535) - C4_11 * T(0.2122163386042435) - C4_31 * T(0.10000365190081437);
  const T b4_4 = C4_31 * T(0.4599934265785341) - (C4_11 * T(0.029989409487638313) + C4_21 * T(0.10000365190081437));
  const T minus_Mb4_11 = b4_2 * C4_11 + b4_3 * C4_21 + b4_4 * C4_31;
  const T minus_Mb4_12 = b4_2 * C4_12 + b4_3 * C4_22 + b4_4 * C4_32;
  const T minus_Mb4_13 = b4_2 * C4_13 + b4_3 * C4_23 + b4_4 * C4_33;
  const T b4_5 = C4_12 * T(0.43942738195230613) - C4_22 * T(0.2122163386042435) - C4_32 * T(0.029989409487638313);
  const T b4_6 = C4_22 * T(0.13110908227732535) - C4_12 * T(0.2122163386042435) - C4_32 * T(0.10000365190081437);
  const T b4_7 = C4_32 * T(0.4599934265785341) - (C4_12 * T(0.029989409487638313) + C4_22 * T(0.10000365190081437));
  const T minus_Mb4_22 = b4_5 * C4_12 + b4_6 * C4_22 + b4_7 * C4_32;
  const T minus_Mb4_23 = b4_5 * C4_13 + b4_6 * C4_23 + b4_7 * C4_33;
  const T Mb4_33 = minus_Mb4_11 - T(1.0305298908081655) + minus_Mb4_22;
  // Hb4 = q4~ Mb4: H of the joint at the lower body's origin, its axes
  const T b4_8 = T(0.1) * minus_Mb4_12;
  const T b4_9 = T(0.2) * minus_Mb4_13;
  const T Hb4_11 = b4_8 - b4_9;
  const T Hb4_12 = T(0.1) * minus_Mb4_22 - T(0.2) * minus_Mb4_23;
  const T Hb4_13 = T(0.1) * minus_Mb4_23 + T(0.2) * Mb4_33;
  const T Hb4_21 = T(0.3) * minus_Mb4_13 - T(0.1) * minus_Mb4_11;
  const T b4_10 = T(0.3) * minus_Mb4_23;
  const T Hb4_22 = b4_10 - b4_8;
  const T minus_Hb4_23 = T(0.1) * minus_Mb4_13 + T(0.3) * Mb4_33;
  const T Hb4_31 = T(0.2) * minus_Mb4_11 - T(0.3) * minus_Mb4_12;
  const T Hb4_32 = T(0.2) * minus_Mb4_12 - T(0.3) * minus_Mb4_22;
  const T Hb4_33 = b4_9 - b4_10;

  // ---- body 3 (body_3) and what it carries
  // w_3 = D(LD3)^-1 L(LD3)^-1 N3: D^-1 L^-1 n
  const T w_3_1 = T(5.398110661268555) * N3_1;
  const T b3_1 = N3_2 + T(0.10526315789473685) * N3_1;
  const T w_3_2 = T(5.875531503672208) * b3_1;
  const T w_3_3 = T(5.989518643354965) * (N3_3 + T(0.014035087719298251) * N3_1 + T(0.1085427135678392) * b3_1);
  // gb3 = G3 - Y3^T w_3: force with the ball solved [N]
  const T minus_gb3_1 = minus_G3_1 + T(0.065) * w_3_2 - T(0.25294472361809045) * w_3_3;
  const T minus_gb3_2 = minus_G3_2 - T(0.006842105263157897) * w_3_2 - T(0.065) * w_3_1 + T(0.12834505862646567) *
      w_3_3;
  const T minus_gb3_3 = minus_G3_3 + T(0.26) * w_3_1 - T(0.10263157894736842) * w_3_2 - T(0.007490787269681742) *
      w_3_3;
  // Mb3 = C3^T M3 C3: M of the joint, lower body's axes
  const T b3_2 = C3_11 * T(0.4080397118128558) - C3_21 * T(0.19705802870394043) - C3_31 * T(0.02784730880994987);
  const T b3_3 = C3_21 * T(0.12174414782894498) - C3_11 * T(0.19705802870394043) - C3_31 * T(0.09286053390789907);
  const T b3_4 = C3_31 * T(0.427136753251496) - (C3_11 * T(0.02784730880994987) + C3_21 * T(0.09286053390789907));
  const T minus_Mb3_11 = b3_2 * C3_11 + b3_3 * C3_21 + b3_4 * C3_31;
  const T minus_Mb3_12 = b3_2 * C3_12 + b3_3 * C3_22 + b3_4 * C3_32;
  const T minus_Mb3_13 = b3_2 * C3_13 + b3_3 * C3_23 + b3_4 * C3_33;
  const T b3_5 = C3_12 * T(0.4080397118128558) - C3_22 * T(0.19705802870394043) - C3_32 * T(0.02784730880994987);
  const T b3_6 = C3_22 * T(0.12174414782894498) - C3_12 * T(0.19705802870394043) - C3_32 * T(0.09286053390789907);
  const T b3_7 = C3_32 * T(0.427136753251496) - (C3_12 * T(0.02784730880994987) + C3_22 * T(0.09286053390789907));
  const T minus_Mb3_22 = b3_5 * C3_12 + b3_6 * C3_22 + b3_7 * C3_32;
  const T minus_Mb3_23 = b3_5 * C3_13 + b3_6 * C3_23 + b3_7 * C3_33;
  const T Mb3_33 = minus_Mb3_11 - T(0.9569206128932968) + minus_Mb3_22;
  // Hb3 = q3~ Mb3: H of the joint at the lower body's origin, its axes
  const T b3_8 = T(0.1) * minus_Mb3_12;
  const T b3_9 = T(0.15) * minus_Mb3_13;
  const T Hb3_11 = b3_8 - b3_9;
  const T Hb3_12 = T(0.1) * minus_Mb3_22 - T(0.15) * minus_Mb3_23;
  const T Hb3_13 = T(0.1) * minus_Mb3_23 + T(0.15) * Mb3_33;
  const T Hb3_21 = T(0.3) * minus_Mb3_13 - T(0.1) * minus_Mb3_11;
  const T b3_10 = T(0.3) * minus_Mb3_23;
  const T Hb3_22 = b3_10 - b3_8;
  const T minus_Hb3_23 = T(0.1) * minus_Mb3_13 + T(0.3) * Mb3_33;
  const T Hb3_31 = T(0.15) * minus_Mb3_11 - T(0.3) * minus_Mb3_12;
  const T Hb3_32 = T(0.15) * minus_Mb3_12 - T(0.3) * minus_Mb3_22;
  const T Hb3_33 = b3_9 - b3_10;

  // ---- body 2 (body_2) and what it carries
  // MA2 = Mb3 + Mb4: force for an acceleration of the origin, home axes [kg]
  const T minus_MA2_11 = minus_Mb3_11 + minus_Mb4_11;
  const T minus_MA2_12 = minus_Mb3_12 + minus_Mb4_12;
  const T minus_MA2_13 = minus_Mb3_13 + minus_Mb4_13;
  const T minus_MA2_22 = minus_Mb3_22 + minus_Mb4_22;
  const T minus_MA2_23 = minus_Mb3_23 + minus_Mb4_23;
  const T MA2_33 = Mb3_33 + Mb4_33;
  // HA2 = h_all_2~ + Hb3 + Hb4: moment for an acceleration of the origin, body axes [kg m]
  const T HA2_11 = Hb3_11 + Hb4_11;
  const T HA2_12 = Hb3_12 - T(0.33) + Hb4_12;
  const T HA2_13 = T(0.715) + Hb3_13 + Hb4_13;
  const T HA2_21 = T(0.33) + Hb3_21 + Hb4_21;
  const T HA2_22 = Hb3_22 + Hb4_22;
  const T minus_HA2_23 = T(0.9299999999999999) + minus_Hb3_23 + minus_Hb4_23;
  const T HA2_31 = Hb3_31 - T(0.715) + Hb4_31;
  const T HA2_32 = T(0.9299999999999999) + Hb3_32 + Hb4_32;
  const T HA2_33 = Hb3_33 + Hb4_33;
  // JA2 = J_all_2 - Hb3 q3~ - Hb4 q4~: moment for an angular acceleration, body axes [kg m^2]
  const T JA2_11 = T(0.28325) + Hb3_13 * T(0.15) - Hb3_12 * T(0.1) - Hb4_12 * T(0.1) + Hb4_13 * T(0.2);
  const T minus_JA2_12 = T(0.1605) + Hb3_13 * T(0.3) - Hb3_11 * T(0.1) + Hb4_13 * T(0.3) - Hb4_11 * T(0.1);
  const T minus_JA2_13 = T(0.0834) + Hb3_11 * T(0.15) - Hb3_12 * T(0.3) + Hb4_11 * T(0.2) - Hb4_12 * T(0.3);
  const T JA2_22 = T(0.429) + Hb3_21 * T(0.1) + minus_Hb3_23 * T(0.3) + Hb4_21 * T(0.1) + minus_Hb4_23 * T(0.3);
  const T minus_JA2_23 = T(0.0643) + Hb3_21 * T(0.15) - Hb3_22 * T(0.3) + Hb4_21 * T(0.2) - Hb4_22 * T(0.3);
  const T JA2_33 = T(0.48424999999999996) + Hb3_32 * T(0.3) - Hb3_31 * T(0.15) - Hb4_31 * T(0.2) + Hb4_32 * T(0.3);
  // g2 = C3^T gb3 + C4^T gb4 + G2: force that drives it, home axes [N]
  const T b2_1 = C3_11 * minus_gb3_1 + C3_21 * minus_gb3_2 + C3_31 * minus_gb3_3;
  const T b2_2 = C4_11 * minus_gb4_1 + C4_21 * minus_gb4_2 + C4_31 * minus_gb4_3;
  const T minus_g2_1 = b2_1 + b2_2 + minus_G2_1;
  const T b2_3 = C3_12 * minus_gb3_1 + C3_22 * minus_gb3_2 + C3_32 * minus_gb3_3;
  const T b2_4 = C4_12 * minus_gb4_1 + C4_22 * minus_gb4_2 + C4_32 * minus_gb4_3;
  const T minus_g2_2 = b2_3 + b2_4 + minus_G2_2;
  const T b2_5 = C3_13 * minus_gb3_1 + C3_23 * minus_gb3_2 + C3_33 * minus_gb3_3;
  const T b2_6 = C4_13 * minus_gb4_1 + C4_23 * minus_gb4_2 + C4_33 * minus_gb4_3;
  const T minus_g2_3 = b2_5 + b2_6 + minus_G2_3;
  // n2 = q3~ C3^T gb3 + q4~ C4^T gb4 + N2: moment that drives it, body axes [N m]
  const T n2_1 = N2_1 + T(0.1) * b2_3 - T(0.15) * b2_5 + T(0.1) * b2_4 - T(0.2) * b2_6;
  const T n2_2 = N2_2 + T(0.3) * b2_5 - T(0.1) * b2_1 + T(0.3) * b2_6 - T(0.1) * b2_2;
  const T n2_3 = N2_3 + T(0.15) * b2_1 - T(0.3) * b2_3 + T(0.2) * b2_2 - T(0.3) * b2_4;
  // LD2 = L D L^T of JA2: L D L^T = JA: L, and 1/D on the diagonal
  const T LD2_11 = T(1) / JA2_11;
  const T minus_LD2_21 = LD2_11 * minus_JA2_12;
  const T LD2_22 = T(1) / (JA2_22 - minus_LD2_21 * minus_JA2_12);
  const T minus_LD2_31 = LD2_11 * minus_JA2_13;
  const T b2_7 = minus_JA2_23 + minus_LD2_21 * minus_JA2_13;
  const T minus_LD2_32 = LD2_22 * b2_7;
  const T LD2_33 = T(1) / (JA2_33 - minus_LD2_31 * minus_JA2_13 - minus_LD2_32 * b2_7);
  // Y2 = L(LD2)^-1 HA2: L^-1 HA
  const T Y2_21 = HA2_21 + minus_LD2_21 * HA2_11;
  const T Y2_22 = HA2_22 + minus_LD2_21 * HA2_12;
  const T minus_Y2_23 = minus_HA2_23 - minus_LD2_21 * HA2_13;
  const T Y2_31 = HA2_31 + minus_LD2_31 * HA2_11 + minus_LD2_32 * Y2_21;
  const T Y2_32 = HA2_32 + minus_LD2_31 * HA2_12 + minus_LD2_32 * Y2_22;
  const T Y2_33 = HA2_33 + minus_LD2_31 * HA2_13 - minus_LD2_32 * minus_Y2_23;
  // W2 = D(LD2)^-1 Y2: D^-1 L^-1 HA
  const T W2_11 = LD2_11 * HA2_11;
  const T W2_12 = LD2_11 * HA2_12;
  const T W2_13 = LD2_11 * HA2_13;
  const T W2_21 = LD2_22 * Y2_21;
  const T W2_22 = LD2_22 * Y2_22;
  const T minus_W2_23 = LD2_22 * minus_Y2_23;
  const T W2_31 = LD2_33 * Y2_31;
  const T W2_32 = LD2_33 * Y2_32;
  const T W2_33 = LD2_33 * Y2_33;
  // w_2 = D(LD2)^-1 L(LD2)^-1 n2: D^-1 L^-1 n
  const T w_2_1 = LD2_11 * n2_1;
  const T b2_8 = n2_2 + minus_LD2_21 * n2_1;
  const T w_2_2 = LD2_22 * b2_8;
  const T w_2_3 = LD2_33 * (n2_3 + minus_LD2_31 * n2_1 + minus_LD2_32 * b2_8);
  // M2 = MA2 - Y2^T W2: MA less what the ball takes up [kg]
  const T minus_M2_11 = minus_MA2_11 + HA2_11 * W2_11 + Y2_21 * W2_21 + Y2_31 * W2_31;
  const T minus_M2_12 = minus_MA2_12 + HA2_11 * W2_12 + Y2_21 * W2_22 + Y2_31 * W2_32;
  const T minus_M2_13 = minus_MA2_13 + HA2_11 * W2_13 - Y2_21 * minus_W2_23 + Y2_31 * W2_33;
  const T minus_M2_22 = minus_MA2_22 + HA2_12 * W2_12 + Y2_22 * W2_22 + Y2_32 * W2_32;
  const T minus_M2_23 = minus_MA2_23 + HA2_12 * W2_13 - Y2_22 * minus_W2_23 + Y2_32 * W2_33;
  const T M2_33 = MA2_33 - HA2_13 * W2_13 - minus_Y2_23 * minus_W2_23 - Y2_33 * W2_33;
  // gb2 = g2 - Y2^T w_2: force with the ball solved [N]
  const T minus_gb2_1 = minus_g2_1 + HA2_11 * w_2_1 + Y2_21 * w_2_2 + Y2_31 * w_2_3;
  const T minus_gb2_2 = minus_g2_2 + HA2_12 * w_2_1 + Y2_22 * w_2_2 + Y2_32 * w_2_3;
  const T minus_gb2_3 = minus_g2_3 + HA2_13 * w_2_1 - minus_Y2_23 * w_2_2 + Y2_33 * w_2_3;
  // Mb2 = C2^T M2 C2: M of the joint, lower body's axes
  const T b2_9 = C2_31 * M2_33 - (C2_11 * minus_M2_13 + C2_21 * minus_M2_23);
  const T b2_10 = C2_11 * minus_M2_11 + C2_21 * minus_M2_12 + C2_31 * minus_M2_13;
  const T b2_11 = C2_11 * minus_M2_12 + C2_21 * minus_M2_22 + C2_31 * minus_M2_23;
  const T Mb2_11 = b2_9 * C2_31 - (b2_10 * C2_11 + b2_11 * C2_21);
  const T Mb2_12 = b2_9 * C2_32 - (b2_10 * C2_12 + b2_11 * C2_22);
  const T Mb2_13 = b2_9 * C2_33 - (b2_10 * C2_13 + b2_11 * C2_23);
  const T b2_12 = C2_32 * M2_33 - (C2_12 * minus_M2_13 + C2_22 * minus_M2_23);
  const T b2_13 = C2_12 * minus_M2_11 + C2_22 * minus_M2_12 + C2_32 * minus_M2_13;
  const T b2_14 = C2_12 * minus_M2_12 + C2_22 * minus_M2_22 + C2_32 * minus_M2_23;
  const T Mb2_22 = b2_12 * C2_32 - (b2_13 * C2_12 + b2_14 * C2_22);
  const T Mb2_23 = b2_12 * C2_33 - (b2_13 * C2_13 + b2_14 * C2_23);
  const T Mb2_33 = M2_33 - (minus_M2_11 + minus_M2_22) - Mb2_11 - Mb2_22;
  // Hb2 = q2~ Mb2: H of the joint at the lower body's origin, its axes
  const T b2_15 = T(0.1) * Mb2_13;
  const T b2_16 = T(0.1) * Mb2_12;
  const T Hb2_11 = b2_15 - b2_16;
  const T b2_17 = T(0.1) * Mb2_23;
  const T Hb2_12 = b2_17 - T(0.1) * Mb2_22;
  const T Hb2_13 = T(0.1) * Mb2_33 - b2_17;
  const T b2_18 = T(0.1) * Mb2_11;
  const T Hb2_21 = b2_18 - T(0.3) * Mb2_13;
  const T b2_19 = T(0.3) * Mb2_23;
  const T Hb2_22 = b2_16 - b2_19;
  const T Hb2_23 = b2_15 - T(0.3) * Mb2_33;
  const T Hb2_31 = T(0.3) * Mb2_12 - b2_18;
  const T Hb2_32 = T(0.3) * Mb2_22 - b2_16;
  const T Hb2_33 = b2_19 - b2_15;

  // ---- body 1 (body_1) and what it carries
  // MA1 = m_all_1 one + Mb2 + Mb5: force for an acceleration of the origin, home axes [kg]
  const T MA1_11 = T(8.1) + Mb2_11 + Mb5_11;
  const T MA1_12 = Mb2_12 + Mb5_12;
  const T MA1_13 = Mb2_13 + Mb5_13;
  const T MA1_22 = T(8.1) + Mb2_22 + Mb5_22;
  const T MA1_23 = Mb2_23 + Mb5_23;
  const T MA1_33 = T(8.1) + Mb2_33 + Mb5_33;
  // HA1 = h_all_1~ + Hb2 + Hb5: moment for an acceleration of the origin, body axes [kg m]
  const T HA1_11 = Hb2_11 + Hb5_11;
  const T HA1_12 = Hb2_12 - T(0.755) + Hb5_12;
  const T HA1_13 = T(1.385) + Hb2_13 + Hb5_13;
  const T HA1_21 = T(0.755) + Hb2_21 + Hb5_21;
  const T HA1_22 = Hb2_22 + Hb5_22;
  const T HA1_23 = Hb2_23 - T(2.21) + Hb5_23;
  const T HA1_31 = Hb2_31 - T(1.385) + Hb5_31;
  const T HA1_32 = T(2.21) + Hb2_32 + Hb5_32;
  const T HA1_33 = Hb2_33 + Hb5_33;
  // JA1 = J_all_1 - Hb2 q2~ - Hb5 q5~: moment for an angular acceleration, body axes [kg m^2]
  const T JA1_11 = T(0.4595) + Hb2_13 * T(0.1) - Hb2_12 * T(0.1) - Hb5_12 * T(0.1) + Hb5_13 * T(0.25);
  const T b1_1 = Hb2_11 * T(0.1);
  const T minus_JA1_12 = T(0.366) - b1_1 + Hb2_13 * T(0.3) + Hb5_13 * T(0.3) - Hb5_11 * T(0.1);
  const T minus_JA1_13 = T(0.2122) + b1_1 - Hb2_12 * T(0.3) + Hb5_11 * T(0.25) - Hb5_12 * T(0.3);
  const T b1_2 = Hb2_21 * T(0.1);
  const T JA1_22 = b1_2 + T(0.84575) - Hb2_23 * T(0.3) - Hb5_23 * T(0.3) + Hb5_21 * T(0.1);
  const T minus_JA1_23 = T(0.13190000000000002) + b1_2 - Hb2_22 * T(0.3) + Hb5_21 * T(0.25) - Hb5_22 * T(0.3);
  const T JA1_33 = T(1.00575) + Hb2_32 * T(0.3) - Hb2_31 * T(0.1) - Hb5_31 * T(0.25) + Hb5_32 * T(0.3);
  // g1 = C2^T gb2 + C5^T gb5 + G1: force that drives it, home axes [N]
  const T b1_3 = C2_11 * minus_gb2_1 + C2_21 * minus_gb2_2 + C2_31 * minus_gb2_3;
  const T b1_4 = C5_11 * minus_gb5_1 + C5_21 * minus_gb5_2 + C5_31 * minus_gb5_3;
  const T g1_1 = G1_1 - (b1_3 + b1_4);
  const T b1_5 = C2_12 * minus_gb2_1 + C2_22 * minus_gb2_2 + C2_32 * minus_gb2_3;
  const T b1_6 = C5_12 * minus_gb5_1 + C5_22 * minus_gb5_2 + C5_32 * minus_gb5_3;
  const T g1_2 = G1_2 - (b1_5 + b1_6);
  const T b1_7 = C2_13 * minus_gb2_1 + C2_23 * minus_gb2_2 + C2_33 * minus_gb2_3;
  const T b1_8 = C5_13 * minus_gb5_1 + C5_23 * minus_gb5_2 + C5_33 * minus_gb5_3;
  const T g1_3 = G1_3 - (b1_7 + b1_8);
  // n1 = q2~ C2^T gb2 + q5~ C5^T gb5 + N1: moment that drives it, body axes [N m]
  const T n1_1 = N1_1 + T(0.1) * b1_5 - T(0.1) * b1_7 + T(0.1) * b1_6 - T(0.25) * b1_8;
  const T b1_9 = T(0.1) * b1_3;
  const T n1_2 = N1_2 - b1_9 + T(0.3) * b1_7 + T(0.3) * b1_8 - T(0.1) * b1_4;
  const T n1_3 = b1_9 + N1_3 - T(0.3) * b1_5 + T(0.25) * b1_4 - T(0.3) * b1_6;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T minus_LD1_21 = LD1_11 * minus_JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - minus_LD1_21 * minus_JA1_12);
  const T minus_LD1_31 = LD1_11 * minus_JA1_13;
  const T b1_10 = minus_JA1_23 + minus_LD1_21 * minus_JA1_13;
  const T minus_LD1_32 = LD1_22 * b1_10;
  const T LD1_33 = T(1) / (JA1_33 - minus_LD1_31 * minus_JA1_13 - minus_LD1_32 * b1_10);
  // Y1 = L(LD1)^-1 HA1: L^-1 HA
  const T Y1_21 = HA1_21 + minus_LD1_21 * HA1_11;
  const T Y1_22 = HA1_22 + minus_LD1_21 * HA1_12;
  const T Y1_23 = HA1_23 + minus_LD1_21 * HA1_13;
  const T Y1_31 = HA1_31 + minus_LD1_31 * HA1_11 + minus_LD1_32 * Y1_21;
  const T Y1_32 = HA1_32 + minus_LD1_31 * HA1_12 + minus_LD1_32 * Y1_22;
  const T Y1_33 = HA1_33 + minus_LD1_31 * HA1_13 + minus_LD1_32 * Y1_23;
  // W1 = D(LD1)^-1 Y1: D^-1 L^-1 HA
  const T W1_11 = LD1_11 * HA1_11;
  const T W1_12 = LD1_11 * HA1_12;
  const T W1_13 = LD1_11 * HA1_13;
  const T W1_21 = LD1_22 * Y1_21;
  const T W1_22 = LD1_22 * Y1_22;
  const T W1_23 = LD1_22 * Y1_23;
  const T W1_31 = LD1_33 * Y1_31;
  const T W1_32 = LD1_33 * Y1_32;
  const T W1_33 = LD1_33 * Y1_33;
  // w_1 = D(LD1)^-1 L(LD1)^-1 n1: D^-1 L^-1 n
  const T w_1_1 = LD1_11 * n1_1;
  const T b1_11 = n1_2 + minus_LD1_21 * n1_1;
  const T w_1_2 = LD1_22 * b1_11;
  const T w_1_3 = LD1_33 * (n1_3 + minus_LD1_31 * n1_1 + minus_LD1_32 * b1_11);
  // M1 = MA1 - Y1^T W1: MA less what the ball takes up [kg]
  const T M1_11 = MA1_11 - HA1_11 * W1_11 - Y1_21 * W1_21 - Y1_31 * W1_31;
  const T M1_12 = MA1_12 - HA1_11 * W1_12 - Y1_21 * W1_22 - Y1_31 * W1_32;
  const T M1_13 = MA1_13 - HA1_11 * W1_13 - Y1_21 * W1_23 - Y1_31 * W1_33;
  const T M1_22 = MA1_22 - HA1_12 * W1_12 - Y1_22 * W1_22 - Y1_32 * W1_32;
  const T M1_23 = MA1_23 - HA1_12 * W1_13 - Y1_22 * W1_23 - Y1_32 * W1_33;
  const T M1_33 = MA1_33 - HA1_13 * W1_13 - Y1_23 * W1_23 - Y1_33 * W1_33;
  // gb1 = g1 - Y1^T w_1: force with the ball solved [N]
  const T gb1_1 = g1_1 - HA1_11 * w_1_1 - Y1_21 * w_1_2 - Y1_31 * w_1_3;
  const T gb1_2 = g1_2 - HA1_12 * w_1_1 - Y1_22 * w_1_2 - Y1_32 * w_1_3;
  const T gb1_3 = g1_3 - HA1_13 * w_1_1 - Y1_23 * w_1_2 - Y1_33 * w_1_3;
  // LDs1 = L D L^T of M1: L D L^T = M: L, and 1/D on the diagonal
  const T LDs1_11 = T(1) / M1_11;
  const T LDs1_21 = LDs1_11 * M1_12;
  const T LDs1_22 = T(1) / (M1_22 - LDs1_21 * M1_12);
  const T LDs1_31 = LDs1_11 * M1_13;
  const T b1_12 = M1_23 - LDs1_21 * M1_13;
  const T LDs1_32 = LDs1_22 * b1_12;
  const T LDs1_33 = T(1) / (M1_33 - LDs1_31 * M1_13 - LDs1_32 * b1_12);
  // ws1 = D(LDs1)^-1 L(LDs1)^-1 gb1: D^-1 L^-1 g
  const T ws1_1 = LDs1_11 * gb1_1;
  const T b1_13 = gb1_2 - LDs1_21 * gb1_1;
  const T ws1_2 = LDs1_22 * b1_13;
  const T ws1_3 = LDs1_33 * (gb1_3 - LDs1_31 * gb1_1 - LDs1_32 * b1_13);

  // ---- body 1 (body_1), solved
  // Pddot1 = L(LDs1)^-T ws1
  const T z1_1 = ws1_2 - LDs1_32 * ws1_3;
  const T Pddot1_1 = ws1_1 - LDs1_21 * z1_1 - LDs1_31 * ws1_3;
  // omegadot1 = L(LD1)^-T (-W1 Pddot1 + w_1)
  const T z1_2 = w_1_3 - W1_31 * Pddot1_1 - W1_32 * z1_1 - W1_33 * ws1_3;
  const T z1_3 = w_1_2 - W1_21 * Pddot1_1 - W1_22 * z1_1 - W1_23 * ws1_3 + minus_LD1_32 * z1_2;
  const T omegadot1_1 = w_1_1 - W1_11 * Pddot1_1 - W1_12 * z1_1 - W1_13 * ws1_3 + minus_LD1_21 * z1_3 + minus_LD1_31 *
      z1_2;
  ydot[0] = omegadot1_1;
  ydot[1] = z1_3;
  ydot[2] = z1_2;
  // sddot1 = g + R1^T Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_1 = R1_11 * Pddot1_1 + R1_21 * z1_1 + R1_31 * ws1_3;
  const T sddot1_2 = R1_12 * Pddot1_1 + R1_22 * z1_1 + R1_32 * ws1_3;
  const T sddot1_3 = R1_13 * Pddot1_1 - T(9.81) + R1_23 * z1_1 + R1_33 * ws1_3;
  ydot[18] = sddot1_1;
  ydot[19] = sddot1_2;
  ydot[20] = sddot1_3;

  // ---- body 2 (body_2), solved
  // beta2 = -C2 q2~ omegadot1 + C2 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z2_1 = T(0.1) * z1_3;
  const T z2_2 = T(0.1) * z1_2 - z2_1;
  const T z2_3 = T(0.1) * omegadot1_1;
  const T z2_4 = z2_3 - T(0.3) * z1_2;
  const T z2_5 = T(0.3) * z1_3;
  const T z2_6 = z2_5 - z2_3;
  const T beta2_1 = C2_11 * Pddot1_1 - (C2_11 * z2_2 + C2_12 * z2_4 + C2_13 * z2_6) + C2_12 * z1_1 + C2_13 * ws1_3;
  const T beta2_2 = C2_21 * Pddot1_1 - (C2_21 * z2_2 + C2_22 * z2_4 + C2_23 * z2_6) + C2_22 * z1_1 + C2_23 * ws1_3;
  const T beta2_3 = C2_31 * Pddot1_1 - (C2_31 * z2_2 + C2_32 * z2_4 + C2_33 * z2_6) + C2_32 * z1_1 + C2_33 * ws1_3;
  // omegadot2 = L(LD2)^-T (-W2 beta2 + w_2)
  const T z2_7 = w_2_3 - W2_31 * beta2_1 - W2_32 * beta2_2 - W2_33 * beta2_3;
  const T z2_8 = w_2_2 - W2_21 * beta2_1 - W2_22 * beta2_2 + minus_W2_23 * beta2_3 + minus_LD2_32 * z2_7;
  const T omegadot2_1 = w_2_1 - W2_11 * beta2_1 - W2_12 * beta2_2 - W2_13 * beta2_3 + minus_LD2_21 * z2_8 +
      minus_LD2_31 * z2_7;
  ydot[3] = omegadot2_1;
  ydot[4] = z2_8;
  ydot[5] = z2_7;

  // ---- body 3 (body_3), solved
  // beta3 = -C3 q3~ omegadot2 + C3 beta2: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z3_1 = T(0.1) * z2_8;
  const T z3_2 = T(0.15) * z2_7 - z3_1;
  const T z3_3 = T(0.1) * omegadot2_1 - T(0.3) * z2_7;
  const T z3_4 = T(0.3) * z2_8;
  const T z3_5 = z3_4 - T(0.15) * omegadot2_1;
  const T beta3_1 = C3_11 * beta2_1 - (C3_11 * z3_2 + C3_12 * z3_3 + C3_13 * z3_5) + C3_12 * beta2_2 + C3_13 *
      beta2_3;
  const T beta3_2 = C3_21 * beta2_1 - (C3_21 * z3_2 + C3_22 * z3_3 + C3_23 * z3_5) + C3_22 * beta2_2 + C3_23 *
      beta2_3;
  const T beta3_3 = C3_31 * beta2_1 - (C3_31 * z3_2 + C3_32 * z3_3 + C3_33 * z3_5) + C3_32 * beta2_2 + C3_33 *
      beta2_3;
  // omegadot3 = L(LD3)^-T (-W3 beta3 + w_3)
  const T z3_6 = w_3_3 + T(1.5150171378488217) * beta3_1 - T(0.7687251214257022) * beta3_2 + T(0.04486621000516483) *
      beta3_3;
  const T z3_7 = w_3_2 + T(0.040201005025125636) * beta3_2 - T(0.3819095477386935) * beta3_1 + T(0.6030150753768845) *
      beta3_3 + T(0.1085427135678392) * z3_6;
  const T omegadot3_1 = w_3_1 + T(0.3508771929824561) * beta3_2 - T(1.4035087719298245) * beta3_3 +
      T(0.10526315789473685) * z3_7 + T(0.014035087719298251) * z3_6;
  ydot[6] = omegadot3_1;
  ydot[7] = z3_7;
  ydot[8] = z3_6;

  // ---- body 4 (body_4), solved
  // beta4 = -C4 q4~ omegadot2 + C4 beta2: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z4_1 = T(0.2) * z2_7 - z3_1;
  const T z4_2 = z3_4 - T(0.2) * omegadot2_1;
  const T beta4_1 = C4_11 * beta2_1 - (C4_11 * z4_1 + C4_12 * z3_3 + C4_13 * z4_2) + C4_12 * beta2_2 + C4_13 *
      beta2_3;
  const T beta4_2 = C4_21 * beta2_1 - (C4_21 * z4_1 + C4_22 * z3_3 + C4_23 * z4_2) + C4_22 * beta2_2 + C4_23 *
      beta2_3;
  const T beta4_3 = C4_31 * beta2_1 - (C4_31 * z4_1 + C4_32 * z3_3 + C4_33 * z4_2) + C4_32 * beta2_2 + C4_33 *
      beta2_3;
  // omegadot4 = L(LD4)^-T (-W4 beta4 + w_4)
  const T z4_3 = w_4_3 + T(1.5150171378488217) * beta4_1 - T(0.768725121425702) * beta4_2 + T(0.044866210005164824) *
      beta4_3;
  const T z4_4 = w_4_2 + T(0.04020100502512562) * beta4_2 - T(0.38190954773869346) * beta4_1 + T(0.6030150753768844) *
      beta4_3 + T(0.10854271356783919) * z4_3;
  const T omegadot4_1 = w_4_1 + T(0.3508771929824561) * beta4_2 - T(1.4035087719298245) * beta4_3 +
      T(0.10526315789473684) * z4_4 + T(0.014035087719298248) * z4_3;
  ydot[9] = omegadot4_1;
  ydot[10] = z4_4;
  ydot[11] = z4_3;

  // ---- body 5 (body_5), solved
  // beta5 = -C5 q5~ omegadot1 + C5 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z5_1 = T(0.25) * z1_2 - z2_1;
  const T z5_2 = z2_5 - T(0.25) * omegadot1_1;
  const T beta5_1 = C5_11 * Pddot1_1 - (C5_11 * z5_1 + C5_12 * z2_4 + C5_13 * z5_2) + C5_12 * z1_1 + C5_13 * ws1_3;
  const T beta5_2 = C5_21 * Pddot1_1 - (C5_21 * z5_1 + C5_22 * z2_4 + C5_23 * z5_2) + C5_22 * z1_1 + C5_23 * ws1_3;
  const T beta5_3 = C5_31 * Pddot1_1 - (C5_31 * z5_1 + C5_32 * z2_4 + C5_33 * z5_2) + C5_32 * z1_1 + C5_33 * ws1_3;
  // omegadot5 = L(LD5)^-T (-W5 beta5 + w_5)
  const T z5_3 = w_5_3 - W5_31 * beta5_1 - W5_32 * beta5_2 - W5_33 * beta5_3;
  const T z5_4 = w_5_2 - W5_21 * beta5_1 - W5_22 * beta5_2 + minus_W5_23 * beta5_3 + minus_LD5_32 * z5_3;
  const T omegadot5_1 = w_5_1 - W5_11 * beta5_1 - W5_12 * beta5_2 - W5_13 * beta5_3 + minus_LD5_21 * z5_4 +
      minus_LD5_31 * z5_3;
  ydot[12] = omegadot5_1;
  ydot[13] = z5_4;
  ydot[14] = z5_3;

  // ---- body 6 (body_6), solved
  // beta6 = -C6 q6~ omegadot5 + C6 beta5: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z6_1 = T(0.3) * z5_3;
  const T z6_2 = z6_1 - T(0.1) * z5_4;
  const T z6_3 = T(0.1) * omegadot5_1 - z6_1;
  const T z6_4 = T(0.3) * z5_4 - T(0.3) * omegadot5_1;
  const T beta6_1 = C6_11 * beta5_1 - (C6_11 * z6_2 + C6_12 * z6_3 + C6_13 * z6_4) + C6_12 * beta5_2 + C6_13 *
      beta5_3;
  const T beta6_2 = C6_21 * beta5_1 - (C6_21 * z6_2 + C6_22 * z6_3 + C6_23 * z6_4) + C6_22 * beta5_2 + C6_23 *
      beta5_3;
  const T beta6_3 = C6_31 * beta5_1 - (C6_31 * z6_2 + C6_32 * z6_3 + C6_33 * z6_4) + C6_32 * beta5_2 + C6_33 *
      beta5_3;
  // omegadot6 = L(LD6)^-T (-W6 beta6 + w_6)
  const T z6_5 = w_6_3 + T(1.5150171378488217) * beta6_1 - T(0.7687251214257022) * beta6_2 + T(0.044866210005164824) *
      beta6_3;
  const T z6_6 = w_6_2 + T(0.040201005025125636) * beta6_2 - T(0.3819095477386935) * beta6_1 + T(0.6030150753768845) *
      beta6_3 + T(0.1085427135678392) * z6_5;
  const T omegadot6_1 = w_6_1 + T(0.3508771929824562) * beta6_2 - T(1.4035087719298247) * beta6_3 +
      T(0.10526315789473686) * z6_6 + T(0.014035087719298253) * z6_5;
  ydot[15] = omegadot6_1;
  ydot[16] = z6_6;
  ydot[17] = z6_5;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 574 add, 600 multiply
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r)
    noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[18], sddot1_2 = ydot[19], sddot1_3 = ydot[20];
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
  const T t1_13 = omega1_3 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T minus_U1_11 = t1_13 + t1_14;
  const T t1_15 = omega1_2 * omega1_1;
  const T U1_12 = t1_15 - omegadot1_3;
  const T t1_16 = omega1_3 * omega1_1;
  const T U1_13 = t1_16 + omegadot1_2;
  const T U1_21 = t1_15 + omegadot1_3;
  const T t1_17 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_17;
  const T t1_18 = omega1_3 * omega1_2;
  const T U1_23 = t1_18 - omegadot1_1;
  const T U1_31 = t1_16 - omegadot1_2;
  const T U1_32 = t1_18 + omegadot1_1;
  const T minus_U1_33 = t1_14 + t1_17;
  // Pddot1 = R1 (-g + sddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t1_19 = sddot1_3 + T(9.81);
  const T Pddot1_1 = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * t1_19;
  const T Pddot1_2 = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * t1_19;
  const T Pddot1_3 = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * t1_19;
  // G1 = -R1 F1 + m_all_1 Pddot1 + U1 h_all_1: inertia less applied force, body axes [N]
  const T t1_20 = R1_11 * u.F_1_1 + R1_12 * u.F_1_2 + R1_13 * u.F_1_3;
  const T G1_1 = T(8.1) * Pddot1_1 - t1_20 + U1_12 * T(1.385) - minus_U1_11 * T(2.21) + U1_13 * T(0.755);
  const T t1_21 = R1_21 * u.F_1_1 + R1_22 * u.F_1_2 + R1_23 * u.F_1_3;
  const T G1_2 = T(8.1) * Pddot1_2 - t1_21 + U1_21 * T(2.21) - minus_U1_22 * T(1.385) + U1_23 * T(0.755);
  const T t1_22 = R1_31 * u.F_1_1 + R1_32 * u.F_1_2 + R1_33 * u.F_1_3;
  const T G1_3 = T(8.1) * Pddot1_3 - t1_22 + U1_31 * T(2.21) + U1_32 * T(1.385) - minus_U1_33 * T(0.755);

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
  const T t2_19 = Pddot1_1 - minus_U1_11 * T(0.3) + U1_13 * T(0.1);
  const T t2_20 = t2_19 + U1_12 * T(0.1);
  const T t2_21 = Pddot1_2 + U1_21 * T(0.3) + U1_23 * T(0.1);
  const T t2_22 = t2_21 - minus_U1_22 * T(0.1);
  const T t2_23 = Pddot1_3 + U1_31 * T(0.3) - minus_U1_33 * T(0.1);
  const T t2_24 = t2_23 + U1_32 * T(0.1);
  const T Pddot2_1 = C2_11 * t2_20 + C2_12 * t2_22 + C2_13 * t2_24;
  const T Pddot2_2 = C2_21 * t2_20 + C2_22 * t2_22 + C2_23 * t2_24;
  const T Pddot2_3 = C2_31 * t2_20 + C2_32 * t2_22 + C2_33 * t2_24;
  // G2 = U2 h_all_2: inertia less applied force, body axes [N]
  const T G2_1 = U2_12 * T(0.715) - minus_U2_11 * T(0.9299999999999999) + U2_13 * T(0.33);
  const T G2_2 = U2_21 * T(0.9299999999999999) - minus_U2_22 * T(0.715) + U2_23 * T(0.33);
  const T G2_3 = U2_31 * T(0.9299999999999999) + U2_32 * T(0.715) - minus_U2_33 * T(0.33);

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
  const T t3_19 = Pddot2_1 - minus_U2_11 * T(0.3) + U2_13 * T(0.1);
  const T t3_20 = t3_19 + U2_12 * T(0.15);
  const T t3_21 = Pddot2_2 + U2_21 * T(0.3) + U2_23 * T(0.1);
  const T t3_22 = t3_21 - minus_U2_22 * T(0.15);
  const T t3_23 = Pddot2_3 + U2_31 * T(0.3) - minus_U2_33 * T(0.1);
  const T t3_24 = t3_23 + U2_32 * T(0.15);
  const T Pddot3_1 = C3_11 * t3_20 + C3_12 * t3_22 + C3_13 * t3_24;
  const T Pddot3_2 = C3_21 * t3_20 + C3_22 * t3_22 + C3_23 * t3_24;
  const T Pddot3_3 = C3_31 * t3_20 + C3_32 * t3_22 + C3_33 * t3_24;
  // G3 = U3 h_all_3: inertia less applied force, body axes [N]
  const T G3_1 = U3_12 * T(0.26) - minus_U3_11 * T(0.13) + U3_13 * T(0.065);
  const T G3_2 = U3_21 * T(0.13) - minus_U3_22 * T(0.26) + U3_23 * T(0.065);
  const T G3_3 = U3_31 * T(0.13) + U3_32 * T(0.26) - minus_U3_33 * T(0.065);
  // N3 = h_all_3~ Pddot3 + axial(U3 (tr(J_all_3)/2 - J_all_3)) - M_torque_3_: inertia less applied moment about the
  //   body origin, body axes [N m]
  const T N3_1 = T(0.26) * Pddot3_3 - u.tau_3_1 - T(0.065) * Pddot3_2 + T(0.09100000000000001) * U3_32 - T(0.09425) *
      U3_23 + T(0.0182) * (minus_U3_22 - minus_U3_33) + T(0.019500000000000003) * U3_31 - T(0.002600000000000001) *
      U3_21;
  const T N3_2 = T(0.065) * Pddot3_1 - u.tau_3_2 - T(0.13) * Pddot3_3 + T(0.09425) * U3_13 - T(0.078) * U3_31 +
      T(0.002600000000000001) * (minus_U3_33 - minus_U3_11) + T(0.0182) * U3_12 - T(0.019500000000000003) * U3_32;
  const T N3_3 = T(0.13) * Pddot3_2 - u.tau_3_3 - T(0.26) * Pddot3_1 + T(0.078) * U3_21 - T(0.09100000000000001) *
      U3_12 + T(0.019500000000000003) * (minus_U3_11 - minus_U3_22) + T(0.002600000000000001) * U3_23 - T(0.0182) *
      U3_13;
  r[6] = N3_1;
  r[7] = N3_2;
  r[8] = N3_3;

  // ---- body 4 (body_4) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T omegadot4_1 = ydot[9], omegadot4_2 = ydot[10], omegadot4_3 = ydot[11];
  // erel4 = -e2~ e4 + eps4_2 e4 - eps4_4 e2: Euler parameters relative to the lower body
  const T erel4_1 = eps2_3 * eps4_2 - eps2_2 * eps4_3 + eps2_4 * eps4_1 - eps4_4 * eps2_1;
  const T erel4_2 = eps2_1 * eps4_3 - eps2_3 * eps4_1 + eps2_4 * eps4_2 - eps4_4 * eps2_2;
  const T erel4_3 = eps2_2 * eps4_1 - eps2_1 * eps4_2 + eps2_4 * eps4_3 - eps4_4 * eps2_3;
  // eps4rel4 = e2 . e4 + eps4_2 eps4_4
  const T eps4rel4 = eps2_1 * eps4_1 + eps2_2 * eps4_2 + eps2_3 * eps4_3 + eps2_4 * eps4_4;
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
  // Pddot4 = C4 (U2 q4 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_19 = t3_19 + U2_12 * T(0.2);
  const T t4_20 = t3_21 - minus_U2_22 * T(0.2);
  const T t4_21 = t3_23 + U2_32 * T(0.2);
  const T Pddot4_1 = C4_11 * t4_19 + C4_12 * t4_20 + C4_13 * t4_21;
  const T Pddot4_2 = C4_21 * t4_19 + C4_22 * t4_20 + C4_23 * t4_21;
  const T Pddot4_3 = C4_31 * t4_19 + C4_32 * t4_20 + C4_33 * t4_21;
  // N2 = C3^T M_torque_3_ + C4^T M_torque_4_ + h_all_2~ Pddot2 + axial(U2 (tr(J_all_2)/2 - J_all_2)) - M_torque_2_:
  //   inertia less applied moment about the body origin, body axes [N m]
  const T N2_1 = C3_11 * u.tau_3_1 - u.tau_2_1 + C3_21 * u.tau_3_2 + C3_31 * u.tau_3_3 + C4_11 * u.tau_4_1 + C4_21 *
      u.tau_4_2 + C4_31 * u.tau_4_3 + T(0.715) * Pddot2_3 - T(0.33) * Pddot2_2 + T(0.16925) * U2_32 -
      T(0.11399999999999999) * U2_23 + T(0.0643) * (minus_U2_22 - minus_U2_33) + T(0.1605) * U2_31 - T(0.0834) *
      U2_21;
  const T N2_2 = C3_12 * u.tau_3_1 - u.tau_2_2 + C3_22 * u.tau_3_2 + C3_32 * u.tau_3_3 + C4_12 * u.tau_4_1 + C4_22 *
      u.tau_4_2 + C4_32 * u.tau_4_3 + T(0.33) * Pddot2_1 - T(0.9299999999999999) * Pddot2_3 + T(0.11399999999999999) *
      U2_13 - T(0.315) * U2_31 + T(0.0834) * (minus_U2_33 - minus_U2_11) + T(0.0643) * U2_12 - T(0.1605) * U2_32;
  const T N2_3 = C3_13 * u.tau_3_1 - u.tau_2_3 + C3_23 * u.tau_3_2 + C3_33 * u.tau_3_3 + C4_13 * u.tau_4_1 + C4_23 *
      u.tau_4_2 + C4_33 * u.tau_4_3 + T(0.9299999999999999) * Pddot2_2 - T(0.715) * Pddot2_1 + T(0.315) * U2_21 -
      T(0.16925) * U2_12 + T(0.1605) * (minus_U2_11 - minus_U2_22) + T(0.0834) * U2_23 - T(0.0643) * U2_13;
  // G4 = U4 h_all_4: inertia less applied force, body axes [N]
  const T G4_1 = U4_12 * T(0.27999999999999997) - minus_U4_11 * T(0.13999999999999999) + U4_13 *
      T(0.06999999999999999);
  const T G4_2 = U4_21 * T(0.13999999999999999) - minus_U4_22 * T(0.27999999999999997) + U4_23 *
      T(0.06999999999999999);
  const T G4_3 = U4_31 * T(0.13999999999999999) + U4_32 * T(0.27999999999999997) - minus_U4_33 *
      T(0.06999999999999999);
  // N4 = h_all_4~ Pddot4 + axial(U4 (tr(J_all_4)/2 - J_all_4)) - M_torque_4_: inertia less applied moment about the
  //   body origin, body axes [N m]
  const T N4_1 = T(0.27999999999999997) * Pddot4_3 - u.tau_4_1 - T(0.06999999999999999) * Pddot4_2 + T(0.098) * U4_32
      - T(0.1015) * U4_23 + T(0.0196) * (minus_U4_22 - minus_U4_33) + T(0.021) * U4_31 - T(0.0028000000000000004) *
      U4_21;
  const T N4_2 = T(0.06999999999999999) * Pddot4_1 - u.tau_4_2 - T(0.13999999999999999) * Pddot4_3 + T(0.1015) * U4_13
      - T(0.084) * U4_31 + T(0.0028000000000000004) * (minus_U4_33 - minus_U4_11) + T(0.0196) * U4_12 - T(0.021) *
      U4_32;
  const T N4_3 = T(0.13999999999999999) * Pddot4_2 - u.tau_4_3 - T(0.27999999999999997) * Pddot4_1 + T(0.084) * U4_21
      - T(0.098) * U4_12 + T(0.021) * (minus_U4_11 - minus_U4_22) + T(0.0028000000000000004) * U4_23 - T(0.0196) *
      U4_13;
  r[9] = N4_1;
  r[10] = N4_2;
  r[11] = N4_3;

  // ---- body 5 (body_5) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T omegadot5_1 = ydot[12], omegadot5_2 = ydot[13], omegadot5_3 = ydot[14];
  // erel5 = -e1~ e5 + eps4_1 e5 - eps4_5 e1: Euler parameters relative to the lower body
  const T erel5_1 = eps1_3 * eps5_2 - eps1_2 * eps5_3 + eps1_4 * eps5_1 - eps5_4 * eps1_1;
  const T erel5_2 = eps1_1 * eps5_3 - eps1_3 * eps5_1 + eps1_4 * eps5_2 - eps5_4 * eps1_2;
  const T erel5_3 = eps1_2 * eps5_1 - eps1_1 * eps5_2 + eps1_4 * eps5_3 - eps5_4 * eps1_3;
  // eps4rel5 = e1 . e5 + eps4_1 eps4_5
  const T eps4rel5 = eps1_1 * eps5_1 + eps1_2 * eps5_2 + eps1_3 * eps5_3 + eps1_4 * eps5_4;
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
  // Pddot5 = C5 (U1 q5 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_19 = t2_19 + U1_12 * T(0.25);
  const T t5_20 = t2_21 - minus_U1_22 * T(0.25);
  const T t5_21 = t2_23 + U1_32 * T(0.25);
  const T Pddot5_1 = C5_11 * t5_19 + C5_12 * t5_20 + C5_13 * t5_21;
  const T Pddot5_2 = C5_21 * t5_19 + C5_22 * t5_20 + C5_23 * t5_21;
  const T Pddot5_3 = C5_31 * t5_19 + C5_32 * t5_20 + C5_33 * t5_21;
  // N1 = C2^T M_torque_2_ + C5^T M_torque_5_ - r1~ R1 F1 + h_all_1~ Pddot1 + axial(U1 (tr(J_all_1)/2 - J_all_1)) -
  //   M1: inertia less applied moment about the body origin, body axes [N m]
  const T N1_1 = C2_11 * u.tau_2_1 - u.M_1_1 + C2_21 * u.tau_2_2 + C2_31 * u.tau_2_3 + C5_11 * u.tau_5_1 + C5_21 *
      u.tau_5_2 + C5_31 * u.tau_5_3 - T(0.2) * t1_22 + T(0.05) * t1_21 + T(1.385) * Pddot1_3 - T(0.755) * Pddot1_2 +
      T(0.30975) * U1_32 - T(0.14975000000000002) * U1_23 + T(0.13190000000000002) * (minus_U1_22 - minus_U1_33) +
      T(0.366) * U1_31 - T(0.2122) * U1_21;
  const T N1_2 = C2_12 * u.tau_2_1 - u.M_1_2 + C2_22 * u.tau_2_2 + C2_32 * u.tau_2_3 + C5_12 * u.tau_5_1 + C5_22 *
      u.tau_5_2 + C5_32 * u.tau_5_3 - T(0.05) * t1_20 + T(0.1) * t1_22 + T(0.755) * Pddot1_1 - T(2.21) * Pddot1_3 +
      T(0.14975000000000002) * U1_13 - T(0.696) * U1_31 + T(0.2122) * (minus_U1_33 - minus_U1_11) +
      T(0.13190000000000002) * U1_12 - T(0.366) * U1_32;
  const T N1_3 = C2_13 * u.tau_2_1 - u.M_1_3 + C2_23 * u.tau_2_2 + C2_33 * u.tau_2_3 + C5_13 * u.tau_5_1 + C5_23 *
      u.tau_5_2 + C5_33 * u.tau_5_3 - T(0.1) * t1_21 + T(0.2) * t1_20 + T(2.21) * Pddot1_2 - T(1.385) * Pddot1_1 +
      T(0.696) * U1_21 - T(0.30975) * U1_12 + T(0.366) * (minus_U1_11 - minus_U1_22) + T(0.2122) * U1_23 -
      T(0.13190000000000002) * U1_13;
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

  // ---- body 2 (body_2) and what it carries
  // S2 = C3^T G3 + C4^T G4 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = C3_11 * G3_1 + C3_21 * G3_2 + C3_31 * G3_3;
  const T b2_2 = C4_11 * G4_1 + C4_21 * G4_2 + C4_31 * G4_3;
  const T S2_1 = b2_1 + b2_2 + G2_1;
  const T b2_3 = C3_12 * G3_1 + C3_22 * G3_2 + C3_32 * G3_3;
  const T b2_4 = C4_12 * G4_1 + C4_22 * G4_2 + C4_32 * G4_3;
  const T S2_2 = b2_3 + b2_4 + G2_2;
  const T b2_5 = C3_13 * G3_1 + C3_23 * G3_2 + C3_33 * G3_3;
  const T b2_6 = C4_13 * G4_1 + C4_23 * G4_2 + C4_33 * G4_3;
  const T S2_3 = b2_5 + b2_6 + G2_3;
  // r_omega2 = q3~ C3^T G3 + q4~ C4^T G4 + N2: Kane's equation of omega [N m]
  const T r_omega2_1 = N2_1 + T(0.15) * b2_5 - T(0.1) * b2_3 + T(0.2) * b2_6 - T(0.1) * b2_4;
  const T r_omega2_2 = N2_2 + T(0.1) * b2_1 - T(0.3) * b2_5 + T(0.1) * b2_2 - T(0.3) * b2_6;
  const T r_omega2_3 = N2_3 + T(0.3) * b2_3 - T(0.15) * b2_1 + T(0.3) * b2_4 - T(0.2) * b2_2;
  r[3] = r_omega2_1;
  r[4] = r_omega2_2;
  r[5] = r_omega2_3;

  // ---- body 1 (body_1) and what it carries
  // S1 = C2^T S2 + C5^T S5 + G1: sum of the force balances of the subtree, body axes [N]
  const T b1_1 = C2_11 * S2_1 + C2_21 * S2_2 + C2_31 * S2_3;
  const T b1_2 = C5_11 * S5_1 + C5_21 * S5_2 + C5_31 * S5_3;
  const T S1_1 = b1_1 + b1_2 + G1_1;
  const T b1_3 = C2_12 * S2_1 + C2_22 * S2_2 + C2_32 * S2_3;
  const T b1_4 = C5_12 * S5_1 + C5_22 * S5_2 + C5_32 * S5_3;
  const T S1_2 = b1_3 + b1_4 + G1_2;
  const T b1_5 = C2_13 * S2_1 + C2_23 * S2_2 + C2_33 * S2_3;
  const T b1_6 = C5_13 * S5_1 + C5_23 * S5_2 + C5_33 * S5_3;
  const T S1_3 = b1_5 + b1_6 + G1_3;
  // r_omega1 = q2~ C2^T S2 + q5~ C5^T S5 + N1: Kane's equation of omega [N m]
  const T r_omega1_1 = N1_1 + T(0.1) * b1_5 - T(0.1) * b1_3 + T(0.25) * b1_6 - T(0.1) * b1_4;
  const T b1_7 = T(0.1) * b1_1;
  const T r_omega1_2 = b1_7 + N1_2 - T(0.3) * b1_5 + T(0.1) * b1_2 - T(0.3) * b1_6;
  const T r_omega1_3 = N1_3 - b1_7 + T(0.3) * b1_3 + T(0.3) * b1_4 - T(0.25) * b1_2;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
  // r_sdot1 = R1^T S1: Kane's equation of sdot [N]
  const T r_sdot1_1 = R1_11 * S1_1 + R1_21 * S1_2 + R1_31 * S1_3;
  const T r_sdot1_2 = R1_12 * S1_1 + R1_22 * S1_2 + R1_32 * S1_3;
  const T r_sdot1_3 = R1_13 * S1_1 + R1_23 * S1_2 + R1_33 * S1_3;
  r[18] = r_sdot1_1;
  r[19] = r_sdot1_2;
  r[20] = r_sdot1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 513 add, 574 multiply
template <class T>
void forcing([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* f) noexcept {

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
  // U1 = omega1~ omega1~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t1_13 = omega1_3 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T minus_U1_11 = t1_13 + t1_14;
  const T U1_12 = omega1_2 * omega1_1;
  const T U1_13 = omega1_3 * omega1_1;
  const T t1_15 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_15;
  const T U1_23 = omega1_3 * omega1_2;
  const T minus_U1_33 = t1_14 + t1_15;
  // Pddot1 = -R1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1 = R1_13 * T(9.81);
  const T Pddot1_2 = R1_23 * T(9.81);
  const T Pddot1_3 = R1_33 * T(9.81);
  // G1 = R1 F1 - m_all_1 Pddot1 - U1 h_all_1: applied less inertia force, body axes [N]
  const T t1_16 = R1_11 * u.F_1_1 + R1_12 * u.F_1_2 + R1_13 * u.F_1_3;
  const T G1_1 = t1_16 - T(8.1) * Pddot1_1 - U1_12 * T(1.385) + minus_U1_11 * T(2.21) - U1_13 * T(0.755);
  const T t1_17 = R1_21 * u.F_1_1 + R1_22 * u.F_1_2 + R1_23 * u.F_1_3;
  const T G1_2 = t1_17 - T(8.1) * Pddot1_2 - U1_12 * T(2.21) + minus_U1_22 * T(1.385) - U1_23 * T(0.755);
  const T t1_18 = R1_31 * u.F_1_1 + R1_32 * u.F_1_2 + R1_33 * u.F_1_3;
  const T G1_3 = t1_18 - T(8.1) * Pddot1_3 - U1_13 * T(2.21) - U1_23 * T(1.385) + minus_U1_33 * T(0.755);

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
  const T t2_16 = Pddot1_1 - minus_U1_11 * T(0.3) + U1_13 * T(0.1);
  const T t2_17 = t2_16 + U1_12 * T(0.1);
  const T t2_18 = U1_23 * T(0.1);
  const T t2_19 = Pddot1_2 + t2_18 + U1_12 * T(0.3);
  const T t2_20 = t2_19 - minus_U1_22 * T(0.1);
  const T t2_21 = Pddot1_3 - minus_U1_33 * T(0.1) + U1_13 * T(0.3);
  const T t2_22 = t2_21 + t2_18;
  const T Pddot2_1 = C2_11 * t2_17 + C2_12 * t2_20 + C2_13 * t2_22;
  const T Pddot2_2 = C2_21 * t2_17 + C2_22 * t2_20 + C2_23 * t2_22;
  const T Pddot2_3 = C2_31 * t2_17 + C2_32 * t2_20 + C2_33 * t2_22;
  // G2 = -U2 h_all_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_12 * T(0.715) - minus_U2_11 * T(0.9299999999999999) + U2_13 * T(0.33);
  const T minus_G2_2 = U2_12 * T(0.9299999999999999) - minus_U2_22 * T(0.715) + U2_23 * T(0.33);
  const T minus_G2_3 = U2_13 * T(0.9299999999999999) + U2_23 * T(0.715) - minus_U2_33 * T(0.33);

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
  const T t3_16 = Pddot2_1 - minus_U2_11 * T(0.3) + U2_13 * T(0.1);
  const T t3_17 = t3_16 + U2_12 * T(0.15);
  const T t3_18 = Pddot2_2 + U2_12 * T(0.3) + U2_23 * T(0.1);
  const T t3_19 = t3_18 - minus_U2_22 * T(0.15);
  const T t3_20 = Pddot2_3 - minus_U2_33 * T(0.1) + U2_13 * T(0.3);
  const T t3_21 = t3_20 + U2_23 * T(0.15);
  const T Pddot3_1 = C3_11 * t3_17 + C3_12 * t3_19 + C3_13 * t3_21;
  const T Pddot3_2 = C3_21 * t3_17 + C3_22 * t3_19 + C3_23 * t3_21;
  const T Pddot3_3 = C3_31 * t3_17 + C3_32 * t3_19 + C3_33 * t3_21;
  // G3 = -U3 h_all_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = U3_12 * T(0.26) - minus_U3_11 * T(0.13) + U3_13 * T(0.065);
  const T minus_G3_2 = U3_12 * T(0.13) - minus_U3_22 * T(0.26) + U3_23 * T(0.065);
  const T minus_G3_3 = U3_13 * T(0.13) + U3_23 * T(0.26) - minus_U3_33 * T(0.065);
  // N3 = -h_all_3~ Pddot3 - omega3~ J_all_3 omega3 + M_torque_3_: applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N3_1 = u.tau_3_1 + T(0.065) * Pddot3_2 - T(0.26) * Pddot3_3 + T(0.0032499999999999977) * U3_23 + T(0.0182) *
      (t3_14 - t3_13) + T(0.002600000000000001) * U3_12 - T(0.019500000000000003) * U3_13;
  const T N3_2 = u.tau_3_2 + T(0.13) * Pddot3_3 - T(0.065) * Pddot3_1 - T(0.016250000000000007) * U3_13 +
      T(0.002600000000000001) * (t3_13 - t3_15) + T(0.019500000000000003) * U3_23 - T(0.0182) * U3_12;
  const T N3_3 = u.tau_3_3 + T(0.26) * Pddot3_1 - T(0.13) * Pddot3_2 + T(0.01300000000000001) * U3_12 +
      T(0.019500000000000003) * (t3_15 - t3_14) + T(0.0182) * U3_13 - T(0.002600000000000001) * U3_23;
  f[6] = N3_1;
  f[7] = N3_2;
  f[8] = N3_3;

  // ---- body 4 (body_4) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  // erel4 = -e2~ e4 + eps4_2 e4 - eps4_4 e2: Euler parameters relative to the lower body
  const T erel4_1 = eps2_3 * eps4_2 - eps2_2 * eps4_3 + eps2_4 * eps4_1 - eps4_4 * eps2_1;
  const T erel4_2 = eps2_1 * eps4_3 - eps2_3 * eps4_1 + eps2_4 * eps4_2 - eps4_4 * eps2_2;
  const T erel4_3 = eps2_2 * eps4_1 - eps2_1 * eps4_2 + eps2_4 * eps4_3 - eps4_4 * eps2_3;
  // eps4rel4 = e2 . e4 + eps4_2 eps4_4
  const T eps4rel4 = eps2_1 * eps4_1 + eps2_2 * eps4_2 + eps2_3 * eps4_3 + eps2_4 * eps4_4;
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
  // Pddot4 = C4 (U2 q4 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_16 = t3_16 + U2_12 * T(0.2);
  const T t4_17 = t3_18 - minus_U2_22 * T(0.2);
  const T t4_18 = t3_20 + U2_23 * T(0.2);
  const T Pddot4_1 = C4_11 * t4_16 + C4_12 * t4_17 + C4_13 * t4_18;
  const T Pddot4_2 = C4_21 * t4_16 + C4_22 * t4_17 + C4_23 * t4_18;
  const T Pddot4_3 = C4_31 * t4_16 + C4_32 * t4_17 + C4_33 * t4_18;
  // N2 = -C3^T M_torque_3_ - C4^T M_torque_4_ - h_all_2~ Pddot2 - omega2~ J_all_2 omega2 + M_torque_2_: applied less
  //   inertia moment about the body origin, body axes [N m]
  const T N2_1 = T(0.33) * Pddot2_2 - (C3_11 * u.tau_3_1 - u.tau_2_1 + C3_21 * u.tau_3_2 + C3_31 * u.tau_3_3 + C4_11 *
      u.tau_4_1 + C4_21 * u.tau_4_2 + C4_31 * u.tau_4_3 + T(0.715) * Pddot2_3) - T(0.055250000000000014) * U2_23 +
      T(0.0643) * (t2_14 - t2_13) + T(0.0834) * U2_12 - T(0.1605) * U2_13;
  const T N2_2 = T(0.9299999999999999) * Pddot2_3 - (C3_12 * u.tau_3_1 - u.tau_2_2 + C3_22 * u.tau_3_2 + C3_32 *
      u.tau_3_3 + C4_12 * u.tau_4_1 + C4_22 * u.tau_4_2 + C4_32 * u.tau_4_3 + T(0.33) * Pddot2_1) +
      T(0.20099999999999998) * U2_13 + T(0.0834) * (t2_13 - t2_15) + T(0.1605) * U2_23 - T(0.0643) * U2_12;
  const T N2_3 = T(0.715) * Pddot2_1 - (C3_13 * u.tau_3_1 - u.tau_2_3 + C3_23 * u.tau_3_2 + C3_33 * u.tau_3_3 + C4_13
      * u.tau_4_1 + C4_23 * u.tau_4_2 + C4_33 * u.tau_4_3 + T(0.9299999999999999) * Pddot2_2) - T(0.14574999999999996)
      * U2_12 + T(0.1605) * (t2_15 - t2_14) + T(0.0643) * U2_13 - T(0.0834) * U2_23;
  // G4 = -U4 h_all_4: applied less inertia force, body axes [N]
  const T minus_G4_1 = U4_12 * T(0.27999999999999997) - minus_U4_11 * T(0.13999999999999999) + U4_13 *
      T(0.06999999999999999);
  const T minus_G4_2 = U4_12 * T(0.13999999999999999) - minus_U4_22 * T(0.27999999999999997) + U4_23 *
      T(0.06999999999999999);
  const T minus_G4_3 = U4_13 * T(0.13999999999999999) + U4_23 * T(0.27999999999999997) - minus_U4_33 *
      T(0.06999999999999999);
  // N4 = -h_all_4~ Pddot4 - omega4~ J_all_4 omega4 + M_torque_4_: applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N4_1 = u.tau_4_1 + T(0.06999999999999999) * Pddot4_2 - T(0.27999999999999997) * Pddot4_3 +
      T(0.0035000000000000057) * U4_23 + T(0.0196) * (t4_14 - t4_13) + T(0.0028000000000000004) * U4_12 - T(0.021) *
      U4_13;
  const T N4_2 = u.tau_4_2 + T(0.13999999999999999) * Pddot4_3 - T(0.06999999999999999) * Pddot4_1 -
      T(0.017500000000000012) * U4_13 + T(0.0028000000000000004) * (t4_13 - t4_15) + T(0.021) * U4_23 - T(0.0196) *
      U4_12;
  const T N4_3 = u.tau_4_3 + T(0.27999999999999997) * Pddot4_1 - T(0.13999999999999999) * Pddot4_2 +
      T(0.014000000000000005) * U4_12 + T(0.021) * (t4_15 - t4_14) + T(0.0196) * U4_13 - T(0.0028000000000000004) *
      U4_23;
  f[9] = N4_1;
  f[10] = N4_2;
  f[11] = N4_3;

  // ---- body 5 (body_5) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  // erel5 = -e1~ e5 + eps4_1 e5 - eps4_5 e1: Euler parameters relative to the lower body
  const T erel5_1 = eps1_3 * eps5_2 - eps1_2 * eps5_3 + eps1_4 * eps5_1 - eps5_4 * eps1_1;
  const T erel5_2 = eps1_1 * eps5_3 - eps1_3 * eps5_1 + eps1_4 * eps5_2 - eps5_4 * eps1_2;
  const T erel5_3 = eps1_2 * eps5_1 - eps1_1 * eps5_2 + eps1_4 * eps5_3 - eps5_4 * eps1_3;
  // eps4rel5 = e1 . e5 + eps4_1 eps4_5
  const T eps4rel5 = eps1_1 * eps5_1 + eps1_2 * eps5_2 + eps1_3 * eps5_3 + eps1_4 * eps5_4;
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
  // Pddot5 = C5 (U1 q5 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_16 = t2_16 + U1_12 * T(0.25);
  const T t5_17 = t2_19 - minus_U1_22 * T(0.25);
  const T t5_18 = t2_21 + U1_23 * T(0.25);
  const T Pddot5_1 = C5_11 * t5_16 + C5_12 * t5_17 + C5_13 * t5_18;
  const T Pddot5_2 = C5_21 * t5_16 + C5_22 * t5_17 + C5_23 * t5_18;
  const T Pddot5_3 = C5_31 * t5_16 + C5_32 * t5_17 + C5_33 * t5_18;
  // N1 = -C2^T M_torque_2_ - C5^T M_torque_5_ + r1~ R1 F1 - h_all_1~ Pddot1 - omega1~ J_all_1 omega1 + M1: applied
  //   less inertia moment about the body origin, body axes [N m]
  const T N1_1 = T(0.755) * Pddot1_2 - (C2_11 * u.tau_2_1 - u.M_1_1 + C2_21 * u.tau_2_2 + C2_31 * u.tau_2_3 + C5_11 *
      u.tau_5_1 + C5_21 * u.tau_5_2 + C5_31 * u.tau_5_3 - T(0.2) * t1_18 + T(0.05) * t1_17 + T(1.385) * Pddot1_3) -
      T(0.16) * U1_23 + T(0.13190000000000002) * (t1_14 - t1_13) + T(0.2122) * U1_12 - T(0.366) * U1_13;
  const T N1_2 = T(2.21) * Pddot1_3 - (C2_12 * u.tau_2_1 - u.M_1_2 + C2_22 * u.tau_2_2 + C2_32 * u.tau_2_3 + C5_12 *
      u.tau_5_1 + C5_22 * u.tau_5_2 + C5_32 * u.tau_5_3 - T(0.05) * t1_16 + T(0.1) * t1_18 + T(0.755) * Pddot1_1) +
      T(0.5462499999999999) * U1_13 + T(0.2122) * (t1_13 - t1_15) + T(0.366) * U1_23 - T(0.13190000000000002) * U1_12;
  const T N1_3 = T(1.385) * Pddot1_1 - (C2_13 * u.tau_2_1 - u.M_1_3 + C2_23 * u.tau_2_2 + C2_33 * u.tau_2_3 + C5_13 *
      u.tau_5_1 + C5_23 * u.tau_5_2 + C5_33 * u.tau_5_3 - T(0.1) * t1_17 + T(0.2) * t1_16 + T(2.21) * Pddot1_2) -
      T(0.3862499999999999) * U1_12 + T(0.366) * (t1_15 - t1_14) + T(0.13190000000000002) * U1_13 - T(0.2122) * U1_23;
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

  // ---- body 2 (body_2) and what it carries
  // S2 = C3^T G3 + C4^T G4 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = C3_11 * minus_G3_1 + C3_21 * minus_G3_2 + C3_31 * minus_G3_3;
  const T b2_2 = C4_11 * minus_G4_1 + C4_21 * minus_G4_2 + C4_31 * minus_G4_3;
  const T minus_S2_1 = b2_1 + b2_2 + minus_G2_1;
  const T b2_3 = C3_12 * minus_G3_1 + C3_22 * minus_G3_2 + C3_32 * minus_G3_3;
  const T b2_4 = C4_12 * minus_G4_1 + C4_22 * minus_G4_2 + C4_32 * minus_G4_3;
  const T minus_S2_2 = b2_3 + b2_4 + minus_G2_2;
  const T b2_5 = C3_13 * minus_G3_1 + C3_23 * minus_G3_2 + C3_33 * minus_G3_3;
  const T b2_6 = C4_13 * minus_G4_1 + C4_23 * minus_G4_2 + C4_33 * minus_G4_3;
  const T minus_S2_3 = b2_5 + b2_6 + minus_G2_3;
  // f_omega2 = q3~ C3^T G3 + q4~ C4^T G4 + N2: Kane's equation of omega [N m]
  const T f_omega2_1 = N2_1 + T(0.1) * b2_3 - T(0.15) * b2_5 + T(0.1) * b2_4 - T(0.2) * b2_6;
  const T f_omega2_2 = N2_2 + T(0.3) * b2_5 - T(0.1) * b2_1 + T(0.3) * b2_6 - T(0.1) * b2_2;
  const T f_omega2_3 = N2_3 + T(0.15) * b2_1 - T(0.3) * b2_3 + T(0.2) * b2_2 - T(0.3) * b2_4;
  f[3] = f_omega2_1;
  f[4] = f_omega2_2;
  f[5] = f_omega2_3;

  // ---- body 1 (body_1) and what it carries
  // S1 = C2^T S2 + C5^T S5 + G1: sum of the force balances of the subtree, body axes [N]
  const T b1_1 = C2_11 * minus_S2_1 + C2_21 * minus_S2_2 + C2_31 * minus_S2_3;
  const T b1_2 = C5_11 * minus_S5_1 + C5_21 * minus_S5_2 + C5_31 * minus_S5_3;
  const T S1_1 = G1_1 - (b1_1 + b1_2);
  const T b1_3 = C2_12 * minus_S2_1 + C2_22 * minus_S2_2 + C2_32 * minus_S2_3;
  const T b1_4 = C5_12 * minus_S5_1 + C5_22 * minus_S5_2 + C5_32 * minus_S5_3;
  const T S1_2 = G1_2 - (b1_3 + b1_4);
  const T b1_5 = C2_13 * minus_S2_1 + C2_23 * minus_S2_2 + C2_33 * minus_S2_3;
  const T b1_6 = C5_13 * minus_S5_1 + C5_23 * minus_S5_2 + C5_33 * minus_S5_3;
  const T S1_3 = G1_3 - (b1_5 + b1_6);
  // f_omega1 = q2~ C2^T S2 + q5~ C5^T S5 + N1: Kane's equation of omega [N m]
  const T f_omega1_1 = N1_1 + T(0.1) * b1_3 - T(0.1) * b1_5 + T(0.1) * b1_4 - T(0.25) * b1_6;
  const T b1_7 = T(0.1) * b1_1;
  const T f_omega1_2 = N1_2 - b1_7 + T(0.3) * b1_5 + T(0.3) * b1_6 - T(0.1) * b1_2;
  const T f_omega1_3 = b1_7 + N1_3 - T(0.3) * b1_3 + T(0.25) * b1_2 - T(0.3) * b1_4;
  f[0] = f_omega1_1;
  f[1] = f_omega1_2;
  f[2] = f_omega1_3;
  // f_sdot1 = R1^T S1: Kane's equation of sdot [N]
  const T f_sdot1_1 = R1_11 * S1_1 + R1_21 * S1_2 + R1_31 * S1_3;
  const T f_sdot1_2 = R1_12 * S1_1 + R1_22 * S1_2 + R1_32 * S1_3;
  const T f_sdot1_3 = R1_13 * S1_1 + R1_23 * S1_2 + R1_33 * S1_3;
  f[18] = f_sdot1_1;
  f[19] = f_sdot1_2;
  f[20] = f_sdot1_3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 396 add, 608 multiply
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  for (int i = 0; i < 441; ++i) A[i] = T(0);

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

  // ---- body 4 (body_4) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  // erel4 = -e2~ e4 + eps4_2 e4 - eps4_4 e2: Euler parameters relative to the lower body
  const T erel4_1 = eps2_3 * eps4_2 - eps2_2 * eps4_3 + eps2_4 * eps4_1 - eps4_4 * eps2_1;
  const T erel4_2 = eps2_1 * eps4_3 - eps2_3 * eps4_1 + eps2_4 * eps4_2 - eps4_4 * eps2_2;
  const T erel4_3 = eps2_2 * eps4_1 - eps2_1 * eps4_2 + eps2_4 * eps4_3 - eps4_4 * eps2_3;
  // eps4rel4 = e2 . e4 + eps4_2 eps4_4
  const T eps4rel4 = eps2_1 * eps4_1 + eps2_2 * eps4_2 + eps2_3 * eps4_3 + eps2_4 * eps4_4;
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

  // ---- body 5 (body_5) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  // erel5 = -e1~ e5 + eps4_1 e5 - eps4_5 e1: Euler parameters relative to the lower body
  const T erel5_1 = eps1_3 * eps5_2 - eps1_2 * eps5_3 + eps1_4 * eps5_1 - eps5_4 * eps1_1;
  const T erel5_2 = eps1_1 * eps5_3 - eps1_3 * eps5_1 + eps1_4 * eps5_2 - eps5_4 * eps1_2;
  const T erel5_3 = eps1_2 * eps5_1 - eps1_1 * eps5_2 + eps1_4 * eps5_3 - eps5_4 * eps1_3;
  // eps4rel5 = e1 . e5 + eps4_1 eps4_5
  const T eps4rel5 = eps1_1 * eps5_1 + eps1_2 * eps5_2 + eps1_3 * eps5_3 + eps1_4 * eps5_4;
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
  A[0] = T(0.4595);
  A[1] = -T(0.366);
  A[21] = -T(0.366);
  A[2] = -T(0.2122);
  A[42] = -T(0.2122);
  const T t1 = C2_23 * T(0.33) - C2_33 * T(0.715);
  const T t2 = C2_22 * T(0.33) - C2_32 * T(0.715);
  const T t3 = T(0.1) * t1 - T(0.1) * t2;
  A[3] = -t3;
  A[63] = -t3;
  const T t4 = C2_33 * T(0.9299999999999999) - C2_13 * T(0.33);
  const T t5 = C2_32 * T(0.9299999999999999) - C2_12 * T(0.33);
  const T t6 = T(0.1) * t4 - T(0.1) * t5;
  A[4] = -t6;
  A[84] = -t6;
  const T t7 = C2_13 * T(0.715) - C2_23 * T(0.9299999999999999);
  const T t8 = C2_12 * T(0.715) - C2_22 * T(0.9299999999999999);
  const T t9 = T(0.1) * t7 - T(0.1) * t8;
  A[5] = -t9;
  A[105] = -t9;
  const T t10 = C3_21 * T(0.065) - C3_31 * T(0.26);
  const T t11 = C3_22 * T(0.065) - C3_32 * T(0.26);
  const T t12 = C3_23 * T(0.065) - C3_33 * T(0.26);
  const T t13 = C2_13 * t10 + C2_23 * t11 + C2_33 * t12;
  const T t14 = C2_12 * t10 + C2_22 * t11 + C2_32 * t12;
  const T t15 = T(0.1) * t13 - T(0.1) * t14;
  A[6] = -t15;
  A[126] = -t15;
  const T t16 = C3_31 * T(0.13) - C3_11 * T(0.065);
  const T t17 = C3_32 * T(0.13) - C3_12 * T(0.065);
  const T t18 = C3_33 * T(0.13) - C3_13 * T(0.065);
  const T t19 = C2_13 * t16 + C2_23 * t17 + C2_33 * t18;
  const T t20 = C2_12 * t16 + C2_22 * t17 + C2_32 * t18;
  const T t21 = T(0.1) * t19 - T(0.1) * t20;
  A[7] = -t21;
  A[147] = -t21;
  const T t22 = C3_11 * T(0.26) - C3_21 * T(0.13);
  const T t23 = C3_12 * T(0.26) - C3_22 * T(0.13);
  const T t24 = C3_13 * T(0.26) - C3_23 * T(0.13);
  const T t25 = C2_13 * t22 + C2_23 * t23 + C2_33 * t24;
  const T t26 = C2_12 * t22 + C2_22 * t23 + C2_32 * t24;
  const T t27 = T(0.1) * t25 - T(0.1) * t26;
  A[8] = -t27;
  A[168] = -t27;
  const T t28 = C4_21 * T(0.06999999999999999) - C4_31 * T(0.27999999999999997);
  const T t29 = C4_22 * T(0.06999999999999999) - C4_32 * T(0.27999999999999997);
  const T t30 = C4_23 * T(0.06999999999999999) - C4_33 * T(0.27999999999999997);
  const T t31 = C2_13 * t28 + C2_23 * t29 + C2_33 * t30;
  const T t32 = C2_12 * t28 + C2_22 * t29 + C2_32 * t30;
  const T t33 = T(0.1) * t31 - T(0.1) * t32;
  A[9] = -t33;
  A[189] = -t33;
  const T t34 = C4_31 * T(0.13999999999999999) - C4_11 * T(0.06999999999999999);
  const T t35 = C4_32 * T(0.13999999999999999) - C4_12 * T(0.06999999999999999);
  const T t36 = C4_33 * T(0.13999999999999999) - C4_13 * T(0.06999999999999999);
  const T t37 = C2_13 * t34 + C2_23 * t35 + C2_33 * t36;
  const T t38 = C2_12 * t34 + C2_22 * t35 + C2_32 * t36;
  const T t39 = T(0.1) * t37 - T(0.1) * t38;
  A[10] = -t39;
  A[210] = -t39;
  const T t40 = C4_11 * T(0.27999999999999997) - C4_21 * T(0.13999999999999999);
  const T t41 = C4_12 * T(0.27999999999999997) - C4_22 * T(0.13999999999999999);
  const T t42 = C4_13 * T(0.27999999999999997) - C4_23 * T(0.13999999999999999);
  const T t43 = C2_13 * t40 + C2_23 * t41 + C2_33 * t42;
  const T t44 = C2_12 * t40 + C2_22 * t41 + C2_32 * t42;
  const T t45 = T(0.1) * t43 - T(0.1) * t44;
  A[11] = -t45;
  A[231] = -t45;
  const T t46 = C5_23 * T(0.23500000000000001) - C5_33 * T(0.78);
  const T t47 = C5_22 * T(0.23500000000000001) - C5_32 * T(0.78);
  const T t48 = T(0.25) * t46 - T(0.1) * t47;
  A[12] = -t48;
  A[252] = -t48;
  const T t49 = C5_33 * T(0.63) - C5_13 * T(0.23500000000000001);
  const T t50 = C5_32 * T(0.63) - C5_12 * T(0.23500000000000001);
  const T t51 = T(0.25) * t49 - T(0.1) * t50;
  A[13] = -t51;
  A[273] = -t51;
  const T t52 = C5_13 * T(0.78) - C5_23 * T(0.63);
  const T t53 = C5_12 * T(0.78) - C5_22 * T(0.63);
  const T t54 = T(0.25) * t52 - T(0.1) * t53;
  A[14] = -t54;
  A[294] = -t54;
  const T t55 = C6_21 * T(0.08000000000000002) - C6_31 * T(0.32000000000000006);
  const T t56 = C6_22 * T(0.08000000000000002) - C6_32 * T(0.32000000000000006);
  const T t57 = C6_23 * T(0.08000000000000002) - C6_33 * T(0.32000000000000006);
  const T t58 = C5_13 * t55 + C5_23 * t56 + C5_33 * t57;
  const T t59 = C5_12 * t55 + C5_22 * t56 + C5_32 * t57;
  const T t60 = T(0.25) * t58 - T(0.1) * t59;
  A[15] = -t60;
  A[315] = -t60;
  const T t61 = C6_31 * T(0.16000000000000003) - C6_11 * T(0.08000000000000002);
  const T t62 = C6_32 * T(0.16000000000000003) - C6_12 * T(0.08000000000000002);
  const T t63 = C6_33 * T(0.16000000000000003) - C6_13 * T(0.08000000000000002);
  const T t64 = C5_13 * t61 + C5_23 * t62 + C5_33 * t63;
  const T t65 = C5_12 * t61 + C5_22 * t62 + C5_32 * t63;
  const T t66 = T(0.25) * t64 - T(0.1) * t65;
  A[16] = -t66;
  A[336] = -t66;
  const T t67 = C6_11 * T(0.32000000000000006) - C6_21 * T(0.16000000000000003);
  const T t68 = C6_12 * T(0.32000000000000006) - C6_22 * T(0.16000000000000003);
  const T t69 = C6_13 * T(0.32000000000000006) - C6_23 * T(0.16000000000000003);
  const T t70 = C5_13 * t67 + C5_23 * t68 + C5_33 * t69;
  const T t71 = C5_12 * t67 + C5_22 * t68 + C5_32 * t69;
  const T t72 = T(0.25) * t70 - T(0.1) * t71;
  A[17] = -t72;
  A[357] = -t72;
  const T t73 = T(1.385) * R1_31 - T(0.755) * R1_21;
  A[18] = t73;
  A[378] = t73;
  const T t74 = T(1.385) * R1_32 - T(0.755) * R1_22;
  A[19] = t74;
  A[399] = t74;
  const T t75 = T(1.385) * R1_33 - T(0.755) * R1_23;
  A[20] = t75;
  A[420] = t75;
  A[22] = T(0.84575);
  A[23] = -T(0.13190000000000002);
  A[43] = -T(0.13190000000000002);
  const T t76 = C2_21 * T(0.33) - C2_31 * T(0.715);
  const T t77 = T(0.1) * t76;
  const T t78 = t77 - T(0.3) * t1;
  A[24] = -t78;
  A[64] = -t78;
  const T t79 = C2_31 * T(0.9299999999999999) - C2_11 * T(0.33);
  const T t80 = T(0.1) * t79;
  const T t81 = t80 - T(0.3) * t4;
  A[25] = -t81;
  A[85] = -t81;
  const T t82 = C2_11 * T(0.715) - C2_21 * T(0.9299999999999999);
  const T t83 = T(0.1) * t82;
  const T t84 = t83 - T(0.3) * t7;
  A[26] = -t84;
  A[106] = -t84;
  const T t85 = C2_11 * t10 + C2_21 * t11 + C2_31 * t12;
  const T t86 = T(0.1) * t85;
  const T t87 = t86 - T(0.3) * t13;
  A[27] = -t87;
  A[127] = -t87;
  const T t88 = C2_11 * t16 + C2_21 * t17 + C2_31 * t18;
  const T t89 = T(0.1) * t88;
  const T t90 = t89 - T(0.3) * t19;
  A[28] = -t90;
  A[148] = -t90;
  const T t91 = C2_11 * t22 + C2_21 * t23 + C2_31 * t24;
  const T t92 = T(0.1) * t91;
  const T t93 = t92 - T(0.3) * t25;
  A[29] = -t93;
  A[169] = -t93;
  const T t94 = C2_11 * t28 + C2_21 * t29 + C2_31 * t30;
  const T t95 = T(0.1) * t94;
  const T t96 = t95 - T(0.3) * t31;
  A[30] = -t96;
  A[190] = -t96;
  const T t97 = C2_11 * t34 + C2_21 * t35 + C2_31 * t36;
  const T t98 = T(0.1) * t97;
  const T t99 = t98 - T(0.3) * t37;
  A[31] = -t99;
  A[211] = -t99;
  const T t100 = C2_11 * t40 + C2_21 * t41 + C2_31 * t42;
  const T t101 = T(0.1) * t100;
  const T t102 = t101 - T(0.3) * t43;
  A[32] = -t102;
  A[232] = -t102;
  const T t103 = C5_21 * T(0.23500000000000001) - C5_31 * T(0.78);
  const T t104 = T(0.1) * t103 - T(0.3) * t46;
  A[33] = -t104;
  A[253] = -t104;
  const T t105 = C5_31 * T(0.63) - C5_11 * T(0.23500000000000001);
  const T t106 = T(0.1) * t105 - T(0.3) * t49;
  A[34] = -t106;
  A[274] = -t106;
  const T t107 = C5_11 * T(0.78) - C5_21 * T(0.63);
  const T t108 = T(0.1) * t107 - T(0.3) * t52;
  A[35] = -t108;
  A[295] = -t108;
  const T t109 = C5_11 * t55 + C5_21 * t56 + C5_31 * t57;
  const T t110 = T(0.1) * t109 - T(0.3) * t58;
  A[36] = -t110;
  A[316] = -t110;
  const T t111 = C5_11 * t61 + C5_21 * t62 + C5_31 * t63;
  const T t112 = T(0.1) * t111 - T(0.3) * t64;
  A[37] = -t112;
  A[337] = -t112;
  const T t113 = C5_11 * t67 + C5_21 * t68 + C5_31 * t69;
  const T t114 = T(0.1) * t113 - T(0.3) * t70;
  A[38] = -t114;
  A[358] = -t114;
  const T t115 = T(0.755) * R1_11 - T(2.21) * R1_31;
  A[39] = t115;
  A[379] = t115;
  const T t116 = T(0.755) * R1_12 - T(2.21) * R1_32;
  A[40] = t116;
  A[400] = t116;
  const T t117 = T(0.755) * R1_13 - T(2.21) * R1_33;
  A[41] = t117;
  A[421] = t117;
  A[44] = T(1.00575);
  const T t118 = T(0.3) * t2 - t77;
  A[45] = -t118;
  A[65] = -t118;
  const T t119 = T(0.3) * t5 - t80;
  A[46] = -t119;
  A[86] = -t119;
  const T t120 = T(0.3) * t8 - t83;
  A[47] = -t120;
  A[107] = -t120;
  const T t121 = T(0.3) * t14 - t86;
  A[48] = -t121;
  A[128] = -t121;
  const T t122 = T(0.3) * t20 - t89;
  A[49] = -t122;
  A[149] = -t122;
  const T t123 = T(0.3) * t26 - t92;
  A[50] = -t123;
  A[170] = -t123;
  const T t124 = T(0.3) * t32 - t95;
  A[51] = -t124;
  A[191] = -t124;
  const T t125 = T(0.3) * t38 - t98;
  A[52] = -t125;
  A[212] = -t125;
  const T t126 = T(0.3) * t44 - t101;
  A[53] = -t126;
  A[233] = -t126;
  const T t127 = T(0.3) * t47 - T(0.25) * t103;
  A[54] = -t127;
  A[254] = -t127;
  const T t128 = T(0.3) * t50 - T(0.25) * t105;
  A[55] = -t128;
  A[275] = -t128;
  const T t129 = T(0.3) * t53 - T(0.25) * t107;
  A[56] = -t129;
  A[296] = -t129;
  const T t130 = T(0.3) * t59 - T(0.25) * t109;
  A[57] = -t130;
  A[317] = -t130;
  const T t131 = T(0.3) * t65 - T(0.25) * t111;
  A[58] = -t131;
  A[338] = -t131;
  const T t132 = T(0.3) * t71 - T(0.25) * t113;
  A[59] = -t132;
  A[359] = -t132;
  const T t133 = T(2.21) * R1_21 - T(1.385) * R1_11;
  A[60] = t133;
  A[380] = t133;
  const T t134 = T(2.21) * R1_22 - T(1.385) * R1_12;
  A[61] = t134;
  A[401] = t134;
  const T t135 = T(2.21) * R1_23 - T(1.385) * R1_13;
  A[62] = t135;
  A[422] = t135;
  A[66] = T(0.28325);
  A[67] = -T(0.1605);
  A[87] = -T(0.1605);
  A[68] = -T(0.0834);
  A[108] = -T(0.0834);
  const T t136 = T(0.15) * t12 - T(0.1) * t11;
  A[69] = -t136;
  A[129] = -t136;
  const T t137 = T(0.15) * t18 - T(0.1) * t17;
  A[70] = -t137;
  A[150] = -t137;
  const T t138 = T(0.15) * t24 - T(0.1) * t23;
  A[71] = -t138;
  A[171] = -t138;
  const T t139 = T(0.2) * t30 - T(0.1) * t29;
  A[72] = -t139;
  A[192] = -t139;
  const T t140 = T(0.2) * t36 - T(0.1) * t35;
  A[73] = -t140;
  A[213] = -t140;
  const T t141 = T(0.2) * t42 - T(0.1) * t41;
  A[74] = -t141;
  A[234] = -t141;
  const T t142 = R1_11 * t76 + R1_21 * t2 + R1_31 * t1;
  A[81] = -t142;
  A[381] = -t142;
  const T t143 = R1_12 * t76 + R1_22 * t2 + R1_32 * t1;
  A[82] = -t143;
  A[402] = -t143;
  const T t144 = R1_13 * t76 + R1_23 * t2 + R1_33 * t1;
  A[83] = -t144;
  A[423] = -t144;
  A[88] = T(0.429);
  A[89] = -T(0.0643);
  A[109] = -T(0.0643);
  const T t145 = T(0.1) * t10 - T(0.3) * t12;
  A[90] = -t145;
  A[130] = -t145;
  const T t146 = T(0.1) * t16 - T(0.3) * t18;
  A[91] = -t146;
  A[151] = -t146;
  const T t147 = T(0.1) * t22 - T(0.3) * t24;
  A[92] = -t147;
  A[172] = -t147;
  const T t148 = T(0.1) * t28 - T(0.3) * t30;
  A[93] = -t148;
  A[193] = -t148;
  const T t149 = T(0.1) * t34 - T(0.3) * t36;
  A[94] = -t149;
  A[214] = -t149;
  const T t150 = T(0.1) * t40 - T(0.3) * t42;
  A[95] = -t150;
  A[235] = -t150;
  const T t151 = R1_11 * t79 + R1_21 * t5 + R1_31 * t4;
  A[102] = -t151;
  A[382] = -t151;
  const T t152 = R1_12 * t79 + R1_22 * t5 + R1_32 * t4;
  A[103] = -t152;
  A[403] = -t152;
  const T t153 = R1_13 * t79 + R1_23 * t5 + R1_33 * t4;
  A[104] = -t153;
  A[424] = -t153;
  A[110] = T(0.48424999999999996);
  const T t154 = T(0.3) * t11 - T(0.15) * t10;
  A[111] = -t154;
  A[131] = -t154;
  const T t155 = T(0.3) * t17 - T(0.15) * t16;
  A[112] = -t155;
  A[152] = -t155;
  const T t156 = T(0.3) * t23 - T(0.15) * t22;
  A[113] = -t156;
  A[173] = -t156;
  const T t157 = T(0.3) * t29 - T(0.2) * t28;
  A[114] = -t157;
  A[194] = -t157;
  const T t158 = T(0.3) * t35 - T(0.2) * t34;
  A[115] = -t158;
  A[215] = -t158;
  const T t159 = T(0.3) * t41 - T(0.2) * t40;
  A[116] = -t159;
  A[236] = -t159;
  const T t160 = R1_11 * t82 + R1_21 * t8 + R1_31 * t7;
  A[123] = -t160;
  A[383] = -t160;
  const T t161 = R1_12 * t82 + R1_22 * t8 + R1_32 * t7;
  A[124] = -t161;
  A[404] = -t161;
  const T t162 = R1_13 * t82 + R1_23 * t8 + R1_33 * t7;
  A[125] = -t162;
  A[425] = -t162;
  A[132] = T(0.18525000000000003);
  A[133] = -T(0.019500000000000003);
  A[153] = -T(0.019500000000000003);
  A[134] = -T(0.002600000000000001);
  A[174] = -T(0.002600000000000001);
  const T t163 = R1_11 * t85 + R1_21 * t14 + R1_31 * t13;
  A[144] = -t163;
  A[384] = -t163;
  const T t164 = R1_12 * t85 + R1_22 * t14 + R1_32 * t13;
  A[145] = -t164;
  A[405] = -t164;
  const T t165 = R1_13 * t85 + R1_23 * t14 + R1_33 * t13;
  A[146] = -t165;
  A[426] = -t165;
  A[154] = T(0.17225000000000001);
  A[155] = -T(0.0182);
  A[175] = -T(0.0182);
  const T t166 = R1_11 * t88 + R1_21 * t20 + R1_31 * t19;
  A[165] = -t166;
  A[385] = -t166;
  const T t167 = R1_12 * t88 + R1_22 * t20 + R1_32 * t19;
  A[166] = -t167;
  A[406] = -t167;
  const T t168 = R1_13 * t88 + R1_23 * t20 + R1_33 * t19;
  A[167] = -t168;
  A[427] = -t168;
  A[176] = T(0.169);
  const T t169 = R1_11 * t91 + R1_21 * t26 + R1_31 * t25;
  A[186] = -t169;
  A[386] = -t169;
  const T t170 = R1_12 * t91 + R1_22 * t26 + R1_32 * t25;
  A[187] = -t170;
  A[407] = -t170;
  const T t171 = R1_13 * t91 + R1_23 * t26 + R1_33 * t25;
  A[188] = -t171;
  A[428] = -t171;
  A[198] = T(0.1995);
  A[199] = -T(0.021);
  A[219] = -T(0.021);
  A[200] = -T(0.0028000000000000004);
  A[240] = -T(0.0028000000000000004);
  const T t172 = R1_11 * t94 + R1_21 * t32 + R1_31 * t31;
  A[207] = -t172;
  A[387] = -t172;
  const T t173 = R1_12 * t94 + R1_22 * t32 + R1_32 * t31;
  A[208] = -t173;
  A[408] = -t173;
  const T t174 = R1_13 * t94 + R1_23 * t32 + R1_33 * t31;
  A[209] = -t174;
  A[429] = -t174;
  A[220] = T(0.1855);
  A[221] = -T(0.0196);
  A[241] = -T(0.0196);
  const T t175 = R1_11 * t97 + R1_21 * t38 + R1_31 * t37;
  A[228] = -t175;
  A[388] = -t175;
  const T t176 = R1_12 * t97 + R1_22 * t38 + R1_32 * t37;
  A[229] = -t176;
  A[409] = -t176;
  const T t177 = R1_13 * t97 + R1_23 * t38 + R1_33 * t37;
  A[230] = -t177;
  A[430] = -t177;
  A[242] = T(0.182);
  const T t178 = R1_11 * t100 + R1_21 * t44 + R1_31 * t43;
  A[249] = -t178;
  A[389] = -t178;
  const T t179 = R1_12 * t100 + R1_22 * t44 + R1_32 * t43;
  A[250] = -t179;
  A[410] = -t179;
  const T t180 = R1_13 * t100 + R1_23 * t44 + R1_33 * t43;
  A[251] = -t180;
  A[431] = -t180;
  A[264] = T(0.37375);
  A[265] = -T(0.1665);
  A[285] = -T(0.1665);
  A[266] = -T(0.051000000000000004);
  A[306] = -T(0.051000000000000004);
  const T t181 = T(0.3) * t57;
  const T t182 = t181 - T(0.1) * t56;
  A[267] = -t182;
  A[327] = -t182;
  const T t183 = T(0.3) * t63;
  const T t184 = t183 - T(0.1) * t62;
  A[268] = -t184;
  A[348] = -t184;
  const T t185 = T(0.3) * t69;
  const T t186 = t185 - T(0.1) * t68;
  A[269] = -t186;
  A[369] = -t186;
  const T t187 = R1_11 * t103 + R1_21 * t47 + R1_31 * t46;
  A[270] = -t187;
  A[390] = -t187;
  const T t188 = R1_12 * t103 + R1_22 * t47 + R1_32 * t46;
  A[271] = -t188;
  A[411] = -t188;
  const T t189 = R1_13 * t103 + R1_23 * t47 + R1_33 * t46;
  A[272] = -t189;
  A[432] = -t189;
  A[286] = T(0.35875);
  A[287] = -T(0.069);
  A[307] = -T(0.069);
  const T t190 = T(0.1) * t55 - t181;
  A[288] = -t190;
  A[328] = -t190;
  const T t191 = T(0.1) * t61 - t183;
  A[289] = -t191;
  A[349] = -t191;
  const T t192 = T(0.1) * t67 - t185;
  A[290] = -t192;
  A[370] = -t192;
  const T t193 = R1_11 * t105 + R1_21 * t50 + R1_31 * t49;
  A[291] = -t193;
  A[391] = -t193;
  const T t194 = R1_12 * t105 + R1_22 * t50 + R1_32 * t49;
  A[292] = -t194;
  A[412] = -t194;
  const T t195 = R1_13 * t105 + R1_23 * t50 + R1_33 * t49;
  A[293] = -t195;
  A[433] = -t195;
  A[308] = T(0.483);
  const T t196 = T(0.3) * t56 - T(0.3) * t55;
  A[309] = -t196;
  A[329] = -t196;
  const T t197 = T(0.3) * t62 - T(0.3) * t61;
  A[310] = -t197;
  A[350] = -t197;
  const T t198 = T(0.3) * t68 - T(0.3) * t67;
  A[311] = -t198;
  A[371] = -t198;
  const T t199 = R1_11 * t107 + R1_21 * t53 + R1_31 * t52;
  A[312] = -t199;
  A[392] = -t199;
  const T t200 = R1_12 * t107 + R1_22 * t53 + R1_32 * t52;
  A[313] = -t200;
  A[413] = -t200;
  const T t201 = R1_13 * t107 + R1_23 * t53 + R1_33 * t52;
  A[314] = -t201;
  A[434] = -t201;
  A[330] = T(0.228);
  A[331] = -T(0.024000000000000004);
  A[351] = -T(0.024000000000000004);
  A[332] = -T(0.003200000000000002);
  A[372] = -T(0.003200000000000002);
  const T t202 = R1_11 * t109 + R1_21 * t59 + R1_31 * t58;
  A[333] = -t202;
  A[393] = -t202;
  const T t203 = R1_12 * t109 + R1_22 * t59 + R1_32 * t58;
  A[334] = -t203;
  A[414] = -t203;
  const T t204 = R1_13 * t109 + R1_23 * t59 + R1_33 * t58;
  A[335] = -t204;
  A[435] = -t204;
  A[352] = T(0.212);
  A[353] = -T(0.022400000000000003);
  A[373] = -T(0.022400000000000003);
  const T t205 = R1_11 * t111 + R1_21 * t65 + R1_31 * t64;
  A[354] = -t205;
  A[394] = -t205;
  const T t206 = R1_12 * t111 + R1_22 * t65 + R1_32 * t64;
  A[355] = -t206;
  A[415] = -t206;
  const T t207 = R1_13 * t111 + R1_23 * t65 + R1_33 * t64;
  A[356] = -t207;
  A[436] = -t207;
  A[374] = T(0.20800000000000002);
  const T t208 = R1_11 * t113 + R1_21 * t71 + R1_31 * t70;
  A[375] = -t208;
  A[395] = -t208;
  const T t209 = R1_12 * t113 + R1_22 * t71 + R1_32 * t70;
  A[376] = -t209;
  A[416] = -t209;
  const T t210 = R1_13 * t113 + R1_23 * t71 + R1_33 * t70;
  A[377] = -t210;
  A[437] = -t210;
  A[396] = T(8.1);
  A[418] = T(8.1);
  A[440] = T(8.1);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 159 add, 222 multiply
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  T block[108];

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
  // B3_1 = -R1^T q2~
  const T minus_B3_1_11 = t1_14 - t1_13;
  const T t1_19 = R1_11 * T(0.1);
  const T minus_B3_1_12 = R1_31 * T(0.3) - t1_19;
  const T t1_20 = R1_21 * T(0.3);
  const T minus_B3_1_13 = t1_19 - t1_20;
  const T minus_B3_1_21 = t1_16 - t1_15;
  const T t1_21 = R1_12 * T(0.1);
  const T minus_B3_1_22 = R1_32 * T(0.3) - t1_21;
  const T t1_22 = R1_22 * T(0.3);
  const T minus_B3_1_23 = t1_21 - t1_22;
  const T minus_B3_1_31 = t1_18 - t1_17;
  const T t1_23 = R1_13 * T(0.1);
  const T minus_B3_1_32 = R1_33 * T(0.3) - t1_23;
  const T t1_24 = R1_23 * T(0.3);
  const T minus_B3_1_33 = t1_23 - t1_24;
  block[18] = -minus_B3_1_11;
  block[19] = -minus_B3_1_12;
  block[73] = -minus_B3_1_12;
  block[20] = -minus_B3_1_13;
  block[21] = -minus_B3_1_21;
  block[22] = -minus_B3_1_22;
  block[76] = -minus_B3_1_22;
  block[23] = -minus_B3_1_23;
  block[24] = -minus_B3_1_31;
  block[25] = -minus_B3_1_32;
  block[79] = -minus_B3_1_32;
  block[26] = -minus_B3_1_33;
  // B9_1 = -R1^T q5~
  const T minus_B9_1_11 = t1_14 - R1_31 * T(0.25);
  const T minus_B9_1_13 = R1_11 * T(0.25) - t1_20;
  const T minus_B9_1_21 = t1_16 - R1_32 * T(0.25);
  const T minus_B9_1_23 = R1_12 * T(0.25) - t1_22;
  const T minus_B9_1_31 = t1_18 - R1_33 * T(0.25);
  const T minus_B9_1_33 = R1_13 * T(0.25) - t1_24;
  block[72] = -minus_B9_1_11;
  block[74] = -minus_B9_1_13;
  block[75] = -minus_B9_1_21;
  block[77] = -minus_B9_1_23;
  block[78] = -minus_B9_1_31;
  block[80] = -minus_B9_1_33;

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
  // B4_2 = -R2^T r2~
  const T t2_13 = R2_31 * T(0.2);
  const T minus_B4_2_11 = R2_21 * T(0.05) - t2_13;
  const T minus_B4_2_12 = R2_31 * T(0.1) - R2_11 * T(0.05);
  const T t2_14 = R2_11 * T(0.2);
  const T t2_15 = R2_21 * T(0.1);
  const T minus_B4_2_13 = t2_14 - t2_15;
  const T t2_16 = R2_32 * T(0.2);
  const T minus_B4_2_21 = R2_22 * T(0.05) - t2_16;
  const T minus_B4_2_22 = R2_32 * T(0.1) - R2_12 * T(0.05);
  const T t2_17 = R2_12 * T(0.2);
  const T t2_18 = R2_22 * T(0.1);
  const T minus_B4_2_23 = t2_17 - t2_18;
  const T t2_19 = R2_33 * T(0.2);
  const T minus_B4_2_31 = R2_23 * T(0.05) - t2_19;
  const T minus_B4_2_32 = R2_33 * T(0.1) - R2_13 * T(0.05);
  const T t2_20 = R2_13 * T(0.2);
  const T t2_21 = R2_23 * T(0.1);
  const T minus_B4_2_33 = t2_20 - t2_21;
  block[27] = -minus_B4_2_11;
  block[28] = -minus_B4_2_12;
  block[29] = -minus_B4_2_13;
  block[30] = -minus_B4_2_21;
  block[31] = -minus_B4_2_22;
  block[32] = -minus_B4_2_23;
  block[33] = -minus_B4_2_31;
  block[34] = -minus_B4_2_32;
  block[35] = -minus_B4_2_33;
  // B5_2 = -R2^T q3~
  const T minus_B5_2_11 = t2_15 - R2_31 * T(0.15);
  const T minus_B5_2_12 = R2_31 * T(0.3) - R2_11 * T(0.1);
  const T t2_22 = R2_21 * T(0.3);
  const T minus_B5_2_13 = R2_11 * T(0.15) - t2_22;
  const T minus_B5_2_21 = t2_18 - R2_32 * T(0.15);
  const T minus_B5_2_22 = R2_32 * T(0.3) - R2_12 * T(0.1);
  const T t2_23 = R2_22 * T(0.3);
  const T minus_B5_2_23 = R2_12 * T(0.15) - t2_23;
  const T minus_B5_2_31 = t2_21 - R2_33 * T(0.15);
  const T minus_B5_2_32 = R2_33 * T(0.3) - R2_13 * T(0.1);
  const T t2_24 = R2_23 * T(0.3);
  const T minus_B5_2_33 = R2_13 * T(0.15) - t2_24;
  block[36] = -minus_B5_2_11;
  block[37] = -minus_B5_2_12;
  block[55] = -minus_B5_2_12;
  block[38] = -minus_B5_2_13;
  block[39] = -minus_B5_2_21;
  block[40] = -minus_B5_2_22;
  block[58] = -minus_B5_2_22;
  block[41] = -minus_B5_2_23;
  block[42] = -minus_B5_2_31;
  block[43] = -minus_B5_2_32;
  block[61] = -minus_B5_2_32;
  block[44] = -minus_B5_2_33;
  // B7_2 = -R2^T q4~
  const T minus_B7_2_11 = t2_15 - t2_13;
  const T minus_B7_2_13 = t2_14 - t2_22;
  const T minus_B7_2_21 = t2_18 - t2_16;
  const T minus_B7_2_23 = t2_17 - t2_23;
  const T minus_B7_2_31 = t2_21 - t2_19;
  const T minus_B7_2_33 = t2_20 - t2_24;
  block[54] = -minus_B7_2_11;
  block[56] = -minus_B7_2_13;
  block[57] = -minus_B7_2_21;
  block[59] = -minus_B7_2_23;
  block[60] = -minus_B7_2_31;
  block[62] = -minus_B7_2_33;

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
  // B6_3 = -R3^T r3~
  const T minus_B6_3_11 = R3_21 * T(0.05) - R3_31 * T(0.2);
  const T minus_B6_3_12 = R3_31 * T(0.1) - R3_11 * T(0.05);
  const T minus_B6_3_13 = R3_11 * T(0.2) - R3_21 * T(0.1);
  const T minus_B6_3_21 = R3_22 * T(0.05) - R3_32 * T(0.2);
  const T minus_B6_3_22 = R3_32 * T(0.1) - R3_12 * T(0.05);
  const T minus_B6_3_23 = R3_12 * T(0.2) - R3_22 * T(0.1);
  const T minus_B6_3_31 = R3_23 * T(0.05) - R3_33 * T(0.2);
  const T minus_B6_3_32 = R3_33 * T(0.1) - R3_13 * T(0.05);
  const T minus_B6_3_33 = R3_13 * T(0.2) - R3_23 * T(0.1);
  block[45] = -minus_B6_3_11;
  block[46] = -minus_B6_3_12;
  block[47] = -minus_B6_3_13;
  block[48] = -minus_B6_3_21;
  block[49] = -minus_B6_3_22;
  block[50] = -minus_B6_3_23;
  block[51] = -minus_B6_3_31;
  block[52] = -minus_B6_3_32;
  block[53] = -minus_B6_3_33;

  // ---- body 4 (body_4) on body 2
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
  // B8_4 = -R4^T r4~
  const T minus_B8_4_11 = R4_21 * T(0.05) - R4_31 * T(0.2);
  const T minus_B8_4_12 = R4_31 * T(0.1) - R4_11 * T(0.05);
  const T minus_B8_4_13 = R4_11 * T(0.2) - R4_21 * T(0.1);
  const T minus_B8_4_21 = R4_22 * T(0.05) - R4_32 * T(0.2);
  const T minus_B8_4_22 = R4_32 * T(0.1) - R4_12 * T(0.05);
  const T minus_B8_4_23 = R4_12 * T(0.2) - R4_22 * T(0.1);
  const T minus_B8_4_31 = R4_23 * T(0.05) - R4_33 * T(0.2);
  const T minus_B8_4_32 = R4_33 * T(0.1) - R4_13 * T(0.05);
  const T minus_B8_4_33 = R4_13 * T(0.2) - R4_23 * T(0.1);
  block[63] = -minus_B8_4_11;
  block[64] = -minus_B8_4_12;
  block[65] = -minus_B8_4_13;
  block[66] = -minus_B8_4_21;
  block[67] = -minus_B8_4_22;
  block[68] = -minus_B8_4_23;
  block[69] = -minus_B8_4_31;
  block[70] = -minus_B8_4_32;
  block[71] = -minus_B8_4_33;

  // ---- body 5 (body_5) on body 1
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
  // B10_5 = -R5^T r5~
  const T minus_B10_5_11 = R5_21 * T(0.05) - R5_31 * T(0.2);
  const T minus_B10_5_12 = R5_31 * T(0.1) - R5_11 * T(0.05);
  const T t5_13 = R5_21 * T(0.1);
  const T minus_B10_5_13 = R5_11 * T(0.2) - t5_13;
  const T minus_B10_5_21 = R5_22 * T(0.05) - R5_32 * T(0.2);
  const T minus_B10_5_22 = R5_32 * T(0.1) - R5_12 * T(0.05);
  const T t5_14 = R5_22 * T(0.1);
  const T minus_B10_5_23 = R5_12 * T(0.2) - t5_14;
  const T minus_B10_5_31 = R5_23 * T(0.05) - R5_33 * T(0.2);
  const T minus_B10_5_32 = R5_33 * T(0.1) - R5_13 * T(0.05);
  const T t5_15 = R5_23 * T(0.1);
  const T minus_B10_5_33 = R5_13 * T(0.2) - t5_15;
  block[81] = -minus_B10_5_11;
  block[82] = -minus_B10_5_12;
  block[83] = -minus_B10_5_13;
  block[84] = -minus_B10_5_21;
  block[85] = -minus_B10_5_22;
  block[86] = -minus_B10_5_23;
  block[87] = -minus_B10_5_31;
  block[88] = -minus_B10_5_32;
  block[89] = -minus_B10_5_33;
  // B11_5 = -R5^T q6~
  const T t5_16 = R5_31 * T(0.3);
  const T minus_B11_5_11 = t5_13 - t5_16;
  const T minus_B11_5_12 = t5_16 - R5_11 * T(0.1);
  const T minus_B11_5_13 = R5_11 * T(0.3) - R5_21 * T(0.3);
  const T t5_17 = R5_32 * T(0.3);
  const T minus_B11_5_21 = t5_14 - t5_17;
  const T minus_B11_5_22 = t5_17 - R5_12 * T(0.1);
  const T minus_B11_5_23 = R5_12 * T(0.3) - R5_22 * T(0.3);
  const T t5_18 = R5_33 * T(0.3);
  const T minus_B11_5_31 = t5_15 - t5_18;
  const T minus_B11_5_32 = t5_18 - R5_13 * T(0.1);
  const T minus_B11_5_33 = R5_13 * T(0.3) - R5_23 * T(0.3);
  block[90] = -minus_B11_5_11;
  block[91] = -minus_B11_5_12;
  block[92] = -minus_B11_5_13;
  block[93] = -minus_B11_5_21;
  block[94] = -minus_B11_5_22;
  block[95] = -minus_B11_5_23;
  block[96] = -minus_B11_5_31;
  block[97] = -minus_B11_5_32;
  block[98] = -minus_B11_5_33;

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
  // B12_6 = -R6^T r6~
  const T minus_B12_6_11 = R6_21 * T(0.05) - R6_31 * T(0.2);
  const T minus_B12_6_12 = R6_31 * T(0.1) - R6_11 * T(0.05);
  const T minus_B12_6_13 = R6_11 * T(0.2) - R6_21 * T(0.1);
  const T minus_B12_6_21 = R6_22 * T(0.05) - R6_32 * T(0.2);
  const T minus_B12_6_22 = R6_32 * T(0.1) - R6_12 * T(0.05);
  const T minus_B12_6_23 = R6_12 * T(0.2) - R6_22 * T(0.1);
  const T minus_B12_6_31 = R6_23 * T(0.05) - R6_33 * T(0.2);
  const T minus_B12_6_32 = R6_33 * T(0.1) - R6_13 * T(0.05);
  const T minus_B12_6_33 = R6_13 * T(0.2) - R6_23 * T(0.1);
  block[99] = -minus_B12_6_11;
  block[100] = -minus_B12_6_12;
  block[101] = -minus_B12_6_13;
  block[102] = -minus_B12_6_21;
  block[103] = -minus_B12_6_22;
  block[104] = -minus_B12_6_23;
  block[105] = -minus_B12_6_31;
  block[106] = -minus_B12_6_32;
  block[107] = -minus_B12_6_33;

  // ---- results
  block[9] = T(1);
  block[13] = T(1);
  block[17] = T(1);
  block[10] = T(0);
  block[11] = T(0);
  block[12] = T(0);
  block[14] = T(0);
  block[15] = T(0);
  block[16] = T(0);

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,0}, {1,18}, {2,63}, {3,66}, {1,81}, {2,126}, {4,129}, {5,132}, {1,144}, {2,189}, {6,192}, {7,198}, {1,207},
      {8,252}, {9,264}, {1,270}, {8,315}, {10,327}, {11,330}, {1,333},
  };
  for (int i = 0; i < 378; ++i) v_y[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y[place[1] + i * 21 + j] = block[9 * place[0] + 3 * i + j];
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 213 add, 330 multiply
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
  const T t1_29 = t1_13 * T(0.3);
  const T minus_B2_1_13 = t1_28 - t1_29;
  const T minus_B2_1_21 = t1_22 - t1_20;
  const T t1_30 = t1_21 * T(0.1);
  const T minus_B2_1_22 = t1_19 * T(0.3) - t1_30;
  const T t1_31 = t1_18 * T(0.3);
  const T minus_B2_1_23 = t1_30 - t1_31;
  const T minus_B2_1_31 = t1_27 - t1_25;
  const T t1_32 = t1_26 * T(0.1);
  const T minus_B2_1_32 = t1_24 * T(0.3) - t1_32;
  const T t1_33 = t1_23 * T(0.3);
  const T minus_B2_1_33 = t1_32 - t1_33;
  block[9] = -minus_B2_1_11;
  block[10] = -minus_B2_1_12;
  block[64] = -minus_B2_1_12;
  block[11] = -minus_B2_1_13;
  block[12] = -minus_B2_1_21;
  block[13] = -minus_B2_1_22;
  block[67] = -minus_B2_1_22;
  block[14] = -minus_B2_1_23;
  block[15] = -minus_B2_1_31;
  block[16] = -minus_B2_1_32;
  block[70] = -minus_B2_1_32;
  block[17] = -minus_B2_1_33;
  // B8_1 = -R1^T omega1~ q5~
  const T minus_B8_1_11 = t1_17 - t1_14 * T(0.25);
  const T minus_B8_1_13 = t1_16 * T(0.25) - t1_29;
  const T minus_B8_1_21 = t1_22 - t1_19 * T(0.25);
  const T minus_B8_1_23 = t1_21 * T(0.25) - t1_31;
  const T minus_B8_1_31 = t1_27 - t1_24 * T(0.25);
  const T minus_B8_1_33 = t1_26 * T(0.25) - t1_33;
  block[63] = -minus_B8_1_11;
  block[65] = -minus_B8_1_13;
  block[66] = -minus_B8_1_21;
  block[68] = -minus_B8_1_23;
  block[69] = -minus_B8_1_31;
  block[71] = -minus_B8_1_33;

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
  const T t2_15 = t2_14 * T(0.2);
  const T minus_B3_2_11 = t2_13 * T(0.05) - t2_15;
  const T t2_16 = R2_21 * omega2_3 - R2_31 * omega2_2;
  const T minus_B3_2_12 = t2_14 * T(0.1) - t2_16 * T(0.05);
  const T t2_17 = t2_16 * T(0.2);
  const T t2_18 = t2_13 * T(0.1);
  const T minus_B3_2_13 = t2_17 - t2_18;
  const T t2_19 = R2_32 * omega2_1 - R2_12 * omega2_3;
  const T t2_20 = R2_12 * omega2_2 - R2_22 * omega2_1;
  const T t2_21 = t2_20 * T(0.2);
  const T minus_B3_2_21 = t2_19 * T(0.05) - t2_21;
  const T t2_22 = R2_22 * omega2_3 - R2_32 * omega2_2;
  const T minus_B3_2_22 = t2_20 * T(0.1) - t2_22 * T(0.05);
  const T t2_23 = t2_22 * T(0.2);
  const T t2_24 = t2_19 * T(0.1);
  const T minus_B3_2_23 = t2_23 - t2_24;
  const T t2_25 = R2_33 * omega2_1 - R2_13 * omega2_3;
  const T t2_26 = R2_13 * omega2_2 - R2_23 * omega2_1;
  const T t2_27 = t2_26 * T(0.2);
  const T minus_B3_2_31 = t2_25 * T(0.05) - t2_27;
  const T t2_28 = R2_23 * omega2_3 - R2_33 * omega2_2;
  const T minus_B3_2_32 = t2_26 * T(0.1) - t2_28 * T(0.05);
  const T t2_29 = t2_28 * T(0.2);
  const T t2_30 = t2_25 * T(0.1);
  const T minus_B3_2_33 = t2_29 - t2_30;
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
  const T minus_B4_2_11 = t2_18 - t2_14 * T(0.15);
  const T minus_B4_2_12 = t2_14 * T(0.3) - t2_16 * T(0.1);
  const T t2_31 = t2_13 * T(0.3);
  const T minus_B4_2_13 = t2_16 * T(0.15) - t2_31;
  const T minus_B4_2_21 = t2_24 - t2_20 * T(0.15);
  const T minus_B4_2_22 = t2_20 * T(0.3) - t2_22 * T(0.1);
  const T t2_32 = t2_19 * T(0.3);
  const T minus_B4_2_23 = t2_22 * T(0.15) - t2_32;
  const T minus_B4_2_31 = t2_30 - t2_26 * T(0.15);
  const T minus_B4_2_32 = t2_26 * T(0.3) - t2_28 * T(0.1);
  const T t2_33 = t2_25 * T(0.3);
  const T minus_B4_2_33 = t2_28 * T(0.15) - t2_33;
  block[27] = -minus_B4_2_11;
  block[28] = -minus_B4_2_12;
  block[46] = -minus_B4_2_12;
  block[29] = -minus_B4_2_13;
  block[30] = -minus_B4_2_21;
  block[31] = -minus_B4_2_22;
  block[49] = -minus_B4_2_22;
  block[32] = -minus_B4_2_23;
  block[33] = -minus_B4_2_31;
  block[34] = -minus_B4_2_32;
  block[52] = -minus_B4_2_32;
  block[35] = -minus_B4_2_33;
  // B6_2 = -R2^T omega2~ q4~
  const T minus_B6_2_11 = t2_18 - t2_15;
  const T minus_B6_2_13 = t2_17 - t2_31;
  const T minus_B6_2_21 = t2_24 - t2_21;
  const T minus_B6_2_23 = t2_23 - t2_32;
  const T minus_B6_2_31 = t2_30 - t2_27;
  const T minus_B6_2_33 = t2_29 - t2_33;
  block[45] = -minus_B6_2_11;
  block[47] = -minus_B6_2_13;
  block[48] = -minus_B6_2_21;
  block[50] = -minus_B6_2_23;
  block[51] = -minus_B6_2_31;
  block[53] = -minus_B6_2_33;

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
  const T minus_B5_3_11 = t3_13 * T(0.05) - t3_14 * T(0.2);
  const T t3_15 = R3_21 * omega3_3 - R3_31 * omega3_2;
  const T minus_B5_3_12 = t3_14 * T(0.1) - t3_15 * T(0.05);
  const T minus_B5_3_13 = t3_15 * T(0.2) - t3_13 * T(0.1);
  const T t3_16 = R3_32 * omega3_1 - R3_12 * omega3_3;
  const T t3_17 = R3_12 * omega3_2 - R3_22 * omega3_1;
  const T minus_B5_3_21 = t3_16 * T(0.05) - t3_17 * T(0.2);
  const T t3_18 = R3_22 * omega3_3 - R3_32 * omega3_2;
  const T minus_B5_3_22 = t3_17 * T(0.1) - t3_18 * T(0.05);
  const T minus_B5_3_23 = t3_18 * T(0.2) - t3_16 * T(0.1);
  const T t3_19 = R3_33 * omega3_1 - R3_13 * omega3_3;
  const T t3_20 = R3_13 * omega3_2 - R3_23 * omega3_1;
  const T minus_B5_3_31 = t3_19 * T(0.05) - t3_20 * T(0.2);
  const T t3_21 = R3_23 * omega3_3 - R3_33 * omega3_2;
  const T minus_B5_3_32 = t3_20 * T(0.1) - t3_21 * T(0.05);
  const T minus_B5_3_33 = t3_21 * T(0.2) - t3_19 * T(0.1);
  block[36] = -minus_B5_3_11;
  block[37] = -minus_B5_3_12;
  block[38] = -minus_B5_3_13;
  block[39] = -minus_B5_3_21;
  block[40] = -minus_B5_3_22;
  block[41] = -minus_B5_3_23;
  block[42] = -minus_B5_3_31;
  block[43] = -minus_B5_3_32;
  block[44] = -minus_B5_3_33;

  // ---- body 4 (body_4) on body 2
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
  const T minus_B7_4_13 = t4_15 * T(0.2) - t4_13 * T(0.1);
  const T t4_16 = R4_32 * omega4_1 - R4_12 * omega4_3;
  const T t4_17 = R4_12 * omega4_2 - R4_22 * omega4_1;
  const T minus_B7_4_21 = t4_16 * T(0.05) - t4_17 * T(0.2);
  const T t4_18 = R4_22 * omega4_3 - R4_32 * omega4_2;
  const T minus_B7_4_22 = t4_17 * T(0.1) - t4_18 * T(0.05);
  const T minus_B7_4_23 = t4_18 * T(0.2) - t4_16 * T(0.1);
  const T t4_19 = R4_33 * omega4_1 - R4_13 * omega4_3;
  const T t4_20 = R4_13 * omega4_2 - R4_23 * omega4_1;
  const T minus_B7_4_31 = t4_19 * T(0.05) - t4_20 * T(0.2);
  const T t4_21 = R4_23 * omega4_3 - R4_33 * omega4_2;
  const T minus_B7_4_32 = t4_20 * T(0.1) - t4_21 * T(0.05);
  const T minus_B7_4_33 = t4_21 * T(0.2) - t4_19 * T(0.1);
  block[54] = -minus_B7_4_11;
  block[55] = -minus_B7_4_12;
  block[56] = -minus_B7_4_13;
  block[57] = -minus_B7_4_21;
  block[58] = -minus_B7_4_22;
  block[59] = -minus_B7_4_23;
  block[60] = -minus_B7_4_31;
  block[61] = -minus_B7_4_32;
  block[62] = -minus_B7_4_33;

  // ---- body 5 (body_5) on body 1
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
      {0,0}, {1,63}, {2,66}, {1,126}, {3,129}, {4,132}, {1,189}, {5,192}, {6,198}, {7,252}, {8,264}, {7,315}, {9,327},
      {10,330},
  };
  for (int i = 0; i < 378; ++i) v_y_dot[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y_dot[place[1] + i * 21 + j] = block[9 * place[0] + 3 * i + j];
}

}  // namespace kanec::bench_s6b
