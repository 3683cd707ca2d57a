// SPDX-License-Identifier: BSD-3-Clause
// bench_s6b: equations of motion of 6 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 1a7cc5188e8d9c86 of bench_s6b/scene.toml; the usual functions
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
//   accelerations           4278 (1860 add, 2406 multiply, 12 divide)
//   residual                1265 (613 add, 652 multiply)
//   forcing                 1200 (538 add, 662 multiply)
//   mass_matrix             1080 (408 add, 672 multiply)
//   partial_velocities      381 (159 add, 222 multiply)
//   partial_velocity_rates  543 (213 add, 330 multiply)
#pragma once

namespace kanec::bench_s6b {

inline constexpr int n_bodies = 6;
inline constexpr int nx = 27;
inline constexpr int ny = 21;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 21;
inline constexpr char model_hash[] = "1a7cc5188e8d9c86";

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
Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
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
  const T t2_13 = s1_1 + R1_11 * T(0.3) + R1_31 * T(0.1);
  const T P2_1 = t2_13 + R1_21 * T(0.1);
  const T t2_14 = s1_2 + R1_12 * T(0.3) + R1_32 * T(0.1);
  const T P2_2 = t2_14 + R1_22 * T(0.1);
  const T t2_15 = s1_3 + R1_13 * T(0.3) + R1_33 * T(0.1);
  const T P2_3 = t2_15 + R1_23 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_16 = R2_21 * T(0.2) + P2_1;
  const T p2_1 = R2_11 * T(0.1) + t2_16 + R2_31 * T(0.05);
  const T t2_17 = R2_22 * T(0.2) + P2_2;
  const T p2_2 = R2_12 * T(0.1) + t2_17 + R2_32 * T(0.05);
  const T t2_18 = R2_23 * T(0.2) + P2_3;
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
  const T P3_1 = t3_13 + R2_21 * T(0.15) + P2_1;
  const T t3_14 = R2_12 * T(0.3) + R2_32 * T(0.1);
  const T P3_2 = t3_14 + R2_22 * T(0.15) + P2_2;
  const T t3_15 = R2_13 * T(0.3) + R2_33 * T(0.1);
  const T P3_3 = t3_15 + R2_23 * T(0.15) + P2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = R3_11 * T(0.1) + R3_21 * T(0.2) + R3_31 * T(0.05) + P3_1;
  const T p3_2 = R3_12 * T(0.1) + R3_22 * T(0.2) + R3_32 * T(0.05) + P3_2;
  const T p3_3 = R3_13 * T(0.1) + R3_23 * T(0.2) + R3_33 * T(0.05) + P3_3;
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
  const T p4_1 = R4_11 * T(0.1) + R4_21 * T(0.2) + R4_31 * T(0.05) + P4_1;
  const T p4_2 = R4_12 * T(0.1) + R4_22 * T(0.2) + R4_32 * T(0.05) + P4_2;
  const T p4_3 = R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05) + P4_3;
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
  const T p5_1 = R5_11 * T(0.1) + R5_21 * T(0.2) + R5_31 * T(0.05) + P5_1;
  const T p5_2 = R5_12 * T(0.1) + R5_22 * T(0.2) + R5_32 * T(0.05) + P5_2;
  const T p5_3 = R5_13 * T(0.1) + R5_23 * T(0.2) + R5_33 * T(0.05) + P5_3;
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
  const T P6_1 = R5_11 * T(0.3) + R5_21 * T(0.3) + R5_31 * T(0.1) + P5_1;
  const T P6_2 = R5_12 * T(0.3) + R5_22 * T(0.3) + R5_32 * T(0.1) + P5_2;
  const T P6_3 = R5_13 * T(0.3) + R5_23 * T(0.3) + R5_33 * T(0.1) + P5_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = R6_11 * T(0.1) + R6_21 * T(0.2) + R6_31 * T(0.05) + P6_1;
  const T p6_2 = R6_12 * T(0.1) + R6_22 * T(0.2) + R6_32 * T(0.05) + P6_2;
  const T p6_3 = R6_13 * T(0.1) + R6_23 * T(0.2) + R6_33 * T(0.05) + P6_3;
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
  const T t2_13 = s1_3 + R1_13 * T(0.3) + R1_33 * T(0.1);
  const T P2_3 = t2_13 + R1_23 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_14 = R2_23 * T(0.2) + P2_3;
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
  const T v2_1 = R2_11 * t2_24 + R2_21 * t2_25 + R2_31 * t2_28 + Pdot2_1;
  const T v2_2 = R2_12 * t2_24 + R2_22 * t2_25 + R2_32 * t2_28 + Pdot2_2;
  const T v2_3 = R2_13 * t2_24 + R2_23 * t2_25 + R2_33 * t2_28 + Pdot2_3;
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
  const T P3_3 = t3_13 + R2_23 * T(0.15) + P2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_3 = R3_13 * T(0.1) + R3_23 * T(0.2) + R3_33 * T(0.05) + P3_3;
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
  const T v3_1 = R3_11 * t3_21 + R3_21 * t3_22 + R3_31 * t3_23 + Pdot3_1;
  const T v3_2 = R3_12 * t3_21 + R3_22 * t3_22 + R3_32 * t3_23 + Pdot3_2;
  const T v3_3 = R3_13 * t3_21 + R3_23 * t3_22 + R3_33 * t3_23 + Pdot3_3;
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
  const T p4_3 = R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05) + P4_3;
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
  const T v4_1 = R4_11 * t4_15 + R4_21 * t4_16 + R4_31 * t4_17 + Pdot4_1;
  const T v4_2 = R4_12 * t4_15 + R4_22 * t4_16 + R4_32 * t4_17 + Pdot4_2;
  const T v4_3 = R4_13 * t4_15 + R4_23 * t4_16 + R4_33 * t4_17 + Pdot4_3;
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
  const T p5_3 = R5_13 * T(0.1) + R5_23 * T(0.2) + R5_33 * T(0.05) + P5_3;
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
  const T v5_1 = R5_11 * t5_15 + R5_21 * t5_16 + R5_31 * t5_18 + Pdot5_1;
  const T v5_2 = R5_12 * t5_15 + R5_22 * t5_16 + R5_32 * t5_18 + Pdot5_2;
  const T v5_3 = R5_13 * t5_15 + R5_23 * t5_16 + R5_33 * t5_18 + Pdot5_3;
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
  const T P6_3 = R5_13 * T(0.3) + R5_23 * T(0.3) + R5_33 * T(0.1) + P5_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_3 = R6_13 * T(0.1) + R6_23 * T(0.2) + R6_33 * T(0.05) + P6_3;
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = omega5_3 * T(0.3);
  const T t6_14 = t5_17 - t6_13;
  const T t6_15 = t6_13 - omega5_1 * T(0.1);
  const T t6_16 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = R5_11 * t6_14 + R5_21 * t6_15 + R5_31 * t6_16 + Pdot5_1;
  const T Pdot6_2 = R5_12 * t6_14 + R5_22 * t6_15 + R5_32 * t6_16 + Pdot5_2;
  const T Pdot6_3 = R5_13 * t6_14 + R5_23 * t6_15 + R5_33 * t6_16 + Pdot5_3;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_17 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_18 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_19 = omega6_1 * T(0.2) - omega6_2 * T(0.1);
  const T v6_1 = R6_11 * t6_17 + R6_21 * t6_18 + R6_31 * t6_19 + Pdot6_1;
  const T v6_2 = R6_12 * t6_17 + R6_22 * t6_18 + R6_32 * t6_19 + Pdot6_2;
  const T v6_3 = R6_13 * t6_17 + R6_23 * t6_18 + R6_33 * t6_19 + Pdot6_3;
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
  const T t2_13 = s1_1 + R1_11 * T(0.3) + R1_31 * T(0.1);
  const T P2_1 = t2_13 + R1_21 * T(0.1);
  const T t2_14 = s1_2 + R1_12 * T(0.3) + R1_32 * T(0.1);
  const T P2_2 = t2_14 + R1_22 * T(0.1);
  const T t2_15 = s1_3 + R1_13 * T(0.3) + R1_33 * T(0.1);
  const T P2_3 = t2_15 + R1_23 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_16 = R2_21 * T(0.2) + P2_1;
  const T p2_1 = R2_11 * T(0.1) + t2_16 + R2_31 * T(0.05);
  const T t2_17 = R2_22 * T(0.2) + P2_2;
  const T p2_2 = R2_12 * T(0.1) + t2_17 + R2_32 * T(0.05);
  const T t2_18 = R2_23 * T(0.2) + P2_3;
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
  const T v2_1 = R2_11 * t2_28 + R2_21 * t2_29 + R2_31 * t2_32 + Pdot2_1;
  const T v2_2 = R2_12 * t2_28 + R2_22 * t2_29 + R2_32 * t2_32 + Pdot2_2;
  const T v2_3 = R2_13 * t2_28 + R2_23 * t2_29 + R2_33 * t2_32 + Pdot2_3;
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
  const T P3_1 = t3_13 + R2_21 * T(0.15) + P2_1;
  const T t3_14 = R2_12 * T(0.3) + R2_32 * T(0.1);
  const T P3_2 = t3_14 + R2_22 * T(0.15) + P2_2;
  const T t3_15 = R2_13 * T(0.3) + R2_33 * T(0.1);
  const T P3_3 = t3_15 + R2_23 * T(0.15) + P2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = R3_11 * T(0.1) + R3_21 * T(0.2) + R3_31 * T(0.05) + P3_1;
  const T p3_2 = R3_12 * T(0.1) + R3_22 * T(0.2) + R3_32 * T(0.05) + P3_2;
  const T p3_3 = R3_13 * T(0.1) + R3_23 * T(0.2) + R3_33 * T(0.05) + P3_3;
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
  const T v3_1 = R3_11 * t3_23 + R3_21 * t3_24 + R3_31 * t3_25 + Pdot3_1;
  const T v3_2 = R3_12 * t3_23 + R3_22 * t3_24 + R3_32 * t3_25 + Pdot3_2;
  const T v3_3 = R3_13 * t3_23 + R3_23 * t3_24 + R3_33 * t3_25 + Pdot3_3;
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
  const T p4_1 = R4_11 * T(0.1) + R4_21 * T(0.2) + R4_31 * T(0.05) + P4_1;
  const T p4_2 = R4_12 * T(0.1) + R4_22 * T(0.2) + R4_32 * T(0.05) + P4_2;
  const T p4_3 = R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05) + P4_3;
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
  const T v4_1 = R4_11 * t4_15 + R4_21 * t4_16 + R4_31 * t4_17 + Pdot4_1;
  const T v4_2 = R4_12 * t4_15 + R4_22 * t4_16 + R4_32 * t4_17 + Pdot4_2;
  const T v4_3 = R4_13 * t4_15 + R4_23 * t4_16 + R4_33 * t4_17 + Pdot4_3;
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
  const T p5_1 = R5_11 * T(0.1) + R5_21 * T(0.2) + R5_31 * T(0.05) + P5_1;
  const T p5_2 = R5_12 * T(0.1) + R5_22 * T(0.2) + R5_32 * T(0.05) + P5_2;
  const T p5_3 = R5_13 * T(0.1) + R5_23 * T(0.2) + R5_33 * T(0.05) + P5_3;
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
  const T v5_1 = R5_11 * t5_15 + R5_21 * t5_16 + R5_31 * t5_18 + Pdot5_1;
  const T v5_2 = R5_12 * t5_15 + R5_22 * t5_16 + R5_32 * t5_18 + Pdot5_2;
  const T v5_3 = R5_13 * t5_15 + R5_23 * t5_16 + R5_33 * t5_18 + Pdot5_3;
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
  const T P6_1 = R5_11 * T(0.3) + R5_21 * T(0.3) + R5_31 * T(0.1) + P5_1;
  const T P6_2 = R5_12 * T(0.3) + R5_22 * T(0.3) + R5_32 * T(0.1) + P5_2;
  const T P6_3 = R5_13 * T(0.3) + R5_23 * T(0.3) + R5_33 * T(0.1) + P5_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = R6_11 * T(0.1) + R6_21 * T(0.2) + R6_31 * T(0.05) + P6_1;
  const T p6_2 = R6_12 * T(0.1) + R6_22 * T(0.2) + R6_32 * T(0.05) + P6_2;
  const T p6_3 = R6_13 * T(0.1) + R6_23 * T(0.2) + R6_33 * T(0.05) + P6_3;
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = omega5_3 * T(0.3);
  const T t6_14 = t5_17 - t6_13;
  const T t6_15 = t6_13 - omega5_1 * T(0.1);
  const T t6_16 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = R5_11 * t6_14 + R5_21 * t6_15 + R5_31 * t6_16 + Pdot5_1;
  const T Pdot6_2 = R5_12 * t6_14 + R5_22 * t6_15 + R5_32 * t6_16 + Pdot5_2;
  const T Pdot6_3 = R5_13 * t6_14 + R5_23 * t6_15 + R5_33 * t6_16 + Pdot5_3;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_17 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_18 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_19 = omega6_1 * T(0.2) - omega6_2 * T(0.1);
  const T v6_1 = R6_11 * t6_17 + R6_21 * t6_18 + R6_31 * t6_19 + Pdot6_1;
  const T v6_2 = R6_12 * t6_17 + R6_22 * t6_18 + R6_32 * t6_19 + Pdot6_2;
  const T v6_3 = R6_13 * t6_17 + R6_23 * t6_18 + R6_33 * t6_19 + Pdot6_3;
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
// 1860 add, 2406 multiply, 12 divide
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
  // a1 = R1^T omega1~ omega1~ r1: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t1_13 = omega1_2 * T(0.1);
  const T t1_14 = omega1_1 * T(0.2) - t1_13;
  const T t1_15 = omega1_3 * T(0.1);
  const T t1_16 = t1_15 - omega1_1 * T(0.05);
  const T t1_17 = omega1_2 * t1_14 - omega1_3 * t1_16;
  const T t1_18 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T t1_19 = omega1_3 * t1_18 - omega1_1 * t1_14;
  const T t1_20 = omega1_1 * t1_16 - omega1_2 * t1_18;
  const T a1_1 = R1_11 * t1_17 + R1_21 * t1_19 + R1_31 * t1_20;
  const T a1_2 = R1_12 * t1_17 + R1_22 * t1_19 + R1_32 * t1_20;
  const T a1_3 = R1_13 * t1_17 + R1_23 * t1_19 + R1_33 * t1_20;
  // G1 = -m1 a1 + F1: applied less inertia force at ydot = 0, inertial axes [N]
  const T G1_1 = u.F_1_1 - T(1.1) * a1_1;
  const T G1_2 = u.F_1_2 - T(1.1) * a1_2;
  const T G1_3 = u.F_1_3 - T(1.1) * a1_3;

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
  // Pddot2 = R1^T omega1~ omega1~ q2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t2_13 = omega1_1 * T(0.1);
  const T t2_14 = omega1_2 * T(0.3);
  const T t2_15 = t2_13 - t2_14;
  const T t2_16 = omega1_3 * T(0.3) - t2_13;
  const T t2_17 = omega1_3 * t2_16;
  const T t2_18 = omega1_2 * t2_15 - t2_17;
  const T t2_19 = t1_13 - t1_15;
  const T t2_20 = omega1_3 * t2_19 - omega1_1 * t2_15;
  const T t2_21 = omega1_1 * t2_16;
  const T t2_22 = t2_21 - omega1_2 * t2_19;
  const T Pddot2_1 = R1_11 * t2_18 + R1_21 * t2_20 + R1_31 * t2_22;
  const T Pddot2_2 = R1_12 * t2_18 + R1_22 * t2_20 + R1_32 * t2_22;
  const T Pddot2_3 = R1_13 * t2_18 + R1_23 * t2_20 + R1_33 * t2_22;
  // a2 = R2^T omega2~ omega2~ r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_23 = omega2_1 * T(0.2);
  const T t2_24 = omega2_2 * T(0.1);
  const T t2_25 = t2_23 - t2_24;
  const T t2_26 = omega2_3 * T(0.1) - omega2_1 * T(0.05);
  const T t2_27 = omega2_2 * t2_25 - omega2_3 * t2_26;
  const T t2_28 = omega2_3 * T(0.2);
  const T t2_29 = omega2_2 * T(0.05) - t2_28;
  const T t2_30 = omega2_3 * t2_29 - omega2_1 * t2_25;
  const T t2_31 = omega2_1 * t2_26 - omega2_2 * t2_29;
  const T a2_1 = R2_11 * t2_27 + R2_21 * t2_30 + R2_31 * t2_31 + Pddot2_1;
  const T a2_2 = R2_12 * t2_27 + R2_22 * t2_30 + R2_32 * t2_31 + Pddot2_2;
  const T a2_3 = R2_13 * t2_27 + R2_23 * t2_30 + R2_33 * t2_31 + Pddot2_3;
  // G2 = -m2 a2: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G2_1 = T(1.2) * a2_1;
  const T minus_G2_2 = T(1.2) * a2_2;
  const T minus_G2_3 = T(1.2) * a2_3;
  // C1_2 = R1 R2^T: takes components in the body to those in body 1
  const T C1_2_11 = R1_11 * R2_11 + R1_12 * R2_12 + R1_13 * R2_13;
  const T C1_2_12 = R1_11 * R2_21 + R1_12 * R2_22 + R1_13 * R2_23;
  const T C1_2_13 = R1_11 * R2_31 + R1_12 * R2_32 + R1_13 * R2_33;
  const T C1_2_21 = R1_21 * R2_11 + R1_22 * R2_12 + R1_23 * R2_13;
  const T C1_2_22 = R1_21 * R2_21 + R1_22 * R2_22 + R1_23 * R2_23;
  const T C1_2_23 = R1_21 * R2_31 + R1_22 * R2_32 + R1_23 * R2_33;
  const T C1_2_31 = R1_31 * R2_11 + R1_32 * R2_12 + R1_33 * R2_13;
  const T C1_2_32 = R1_31 * R2_21 + R1_32 * R2_22 + R1_33 * R2_23;
  const T C1_2_33 = R1_31 * R2_31 + R1_32 * R2_32 + R1_33 * R2_33;

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
  // Pddot3 = R2^T omega2~ omega2~ q3 + Pddot2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t3_13 = omega2_2 * T(0.3);
  const T t3_14 = omega2_1 * T(0.15) - t3_13;
  const T t3_15 = omega2_3 * T(0.3) - omega2_1 * T(0.1);
  const T t3_16 = omega2_3 * t3_15;
  const T t3_17 = omega2_2 * t3_14 - t3_16;
  const T t3_18 = t2_24 - omega2_3 * T(0.15);
  const T t3_19 = omega2_3 * t3_18 - omega2_1 * t3_14;
  const T t3_20 = omega2_1 * t3_15;
  const T t3_21 = t3_20 - omega2_2 * t3_18;
  const T Pddot3_1 = R2_11 * t3_17 + R2_21 * t3_19 + R2_31 * t3_21 + Pddot2_1;
  const T Pddot3_2 = R2_12 * t3_17 + R2_22 * t3_19 + R2_32 * t3_21 + Pddot2_2;
  const T Pddot3_3 = R2_13 * t3_17 + R2_23 * t3_19 + R2_33 * t3_21 + Pddot2_3;
  // a3 = R3^T omega3~ omega3~ r3 + Pddot3: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t3_22 = omega3_1 * T(0.2) - omega3_2 * T(0.1);
  const T t3_23 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_24 = omega3_2 * t3_22 - omega3_3 * t3_23;
  const T t3_25 = omega3_2 * T(0.05) - omega3_3 * T(0.2);
  const T t3_26 = omega3_3 * t3_25 - omega3_1 * t3_22;
  const T t3_27 = omega3_1 * t3_23 - omega3_2 * t3_25;
  const T a3_1 = R3_11 * t3_24 + R3_21 * t3_26 + R3_31 * t3_27 + Pddot3_1;
  const T a3_2 = R3_12 * t3_24 + R3_22 * t3_26 + R3_32 * t3_27 + Pddot3_2;
  const T a3_3 = R3_13 * t3_24 + R3_23 * t3_26 + R3_33 * t3_27 + Pddot3_3;
  // G3 = -m3 a3: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G3_1 = T(1.3) * a3_1;
  const T minus_G3_2 = T(1.3) * a3_2;
  const T minus_G3_3 = T(1.3) * a3_3;
  // N3 = -omega3~ I3 omega3 + M_torque_3_: applied less inertia moment at ydot = 0, body axes [N m]
  const T t3_28 = omega3_2 * omega3_3;
  const T t3_29 = omega3_2 * omega3_2;
  const T t3_30 = omega3_3 * omega3_3;
  const T t3_31 = omega3_1 * omega3_2;
  const T t3_32 = omega3_1 * omega3_3;
  const T N3_1 = T(0.052000000000000005) * t3_28 + T(0.0052) * (t3_29 - t3_30) - T(0.0039) * t3_31 + T(0.0065) * t3_32
      + u.tau_3_1;
  const T t3_33 = omega3_1 * omega3_1;
  const T N3_2 = u.tau_3_2 - (T(0.02600000000000001) * t3_32 + T(0.0039) * (t3_30 - t3_33) + T(0.0065) * t3_28 +
      T(0.0052) * t3_31);
  const T N3_3 = T(0.0052) * t3_32 - (T(0.025999999999999995) * t3_31 + T(0.0065) * (t3_33 - t3_29)) + T(0.0039) *
      t3_28 + u.tau_3_3;
  // C2_3 = R2 R3^T: takes components in the body to those in body 2
  const T C2_3_11 = R2_11 * R3_11 + R2_12 * R3_12 + R2_13 * R3_13;
  const T C2_3_12 = R2_11 * R3_21 + R2_12 * R3_22 + R2_13 * R3_23;
  const T C2_3_13 = R2_11 * R3_31 + R2_12 * R3_32 + R2_13 * R3_33;
  const T C2_3_21 = R2_21 * R3_11 + R2_22 * R3_12 + R2_23 * R3_13;
  const T C2_3_22 = R2_21 * R3_21 + R2_22 * R3_22 + R2_23 * R3_23;
  const T C2_3_23 = R2_21 * R3_31 + R2_22 * R3_32 + R2_23 * R3_33;
  const T C2_3_31 = R2_31 * R3_11 + R2_32 * R3_12 + R2_33 * R3_13;
  const T C2_3_32 = R2_31 * R3_21 + R2_32 * R3_22 + R2_33 * R3_23;
  const T C2_3_33 = R2_31 * R3_31 + R2_32 * R3_32 + R2_33 * R3_33;
  // C1_3 = R1 R3^T: takes components in the body to those in body 1
  const T C1_3_11 = R1_11 * R3_11 + R1_12 * R3_12 + R1_13 * R3_13;
  const T C1_3_12 = R1_11 * R3_21 + R1_12 * R3_22 + R1_13 * R3_23;
  const T C1_3_13 = R1_11 * R3_31 + R1_12 * R3_32 + R1_13 * R3_33;
  const T C1_3_21 = R1_21 * R3_11 + R1_22 * R3_12 + R1_23 * R3_13;
  const T C1_3_22 = R1_21 * R3_21 + R1_22 * R3_22 + R1_23 * R3_23;
  const T C1_3_23 = R1_21 * R3_31 + R1_22 * R3_32 + R1_23 * R3_33;
  const T C1_3_31 = R1_31 * R3_11 + R1_32 * R3_12 + R1_33 * R3_13;
  const T C1_3_32 = R1_31 * R3_21 + R1_32 * R3_22 + R1_33 * R3_23;
  const T C1_3_33 = R1_31 * R3_31 + R1_32 * R3_32 + R1_33 * R3_33;

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
  // Pddot4 = R2^T omega2~ omega2~ q4 + Pddot2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t4_13 = t2_23 - t3_13;
  const T t4_14 = omega2_2 * t4_13 - t3_16;
  const T t4_15 = t2_24 - t2_28;
  const T t4_16 = omega2_3 * t4_15 - omega2_1 * t4_13;
  const T t4_17 = t3_20 - omega2_2 * t4_15;
  const T Pddot4_1 = R2_11 * t4_14 + R2_21 * t4_16 + R2_31 * t4_17 + Pddot2_1;
  const T Pddot4_2 = R2_12 * t4_14 + R2_22 * t4_16 + R2_32 * t4_17 + Pddot2_2;
  const T Pddot4_3 = R2_13 * t4_14 + R2_23 * t4_16 + R2_33 * t4_17 + Pddot2_3;
  // N2 = -R2 R3^T M_torque_3_ - R2 R4^T M_torque_4_ - omega2~ I2 omega2 + M_torque_2_: applied less inertia moment at
  //   ydot = 0, body axes [N m]
  const T t4_18 = omega2_2 * omega2_3;
  const T t4_19 = R3_11 * u.tau_3_1 + R3_21 * u.tau_3_2 + R3_31 * u.tau_3_3;
  const T t4_20 = R3_12 * u.tau_3_1 + R3_22 * u.tau_3_2 + R3_32 * u.tau_3_3;
  const T t4_21 = R3_13 * u.tau_3_1 + R3_23 * u.tau_3_2 + R3_33 * u.tau_3_3;
  const T t4_22 = R4_11 * u.tau_4_1 + R4_21 * u.tau_4_2 + R4_31 * u.tau_4_3;
  const T t4_23 = R4_12 * u.tau_4_1 + R4_22 * u.tau_4_2 + R4_32 * u.tau_4_3;
  const T t4_24 = R4_13 * u.tau_4_1 + R4_23 * u.tau_4_2 + R4_33 * u.tau_4_3;
  const T t4_25 = omega2_2 * omega2_2;
  const T t4_26 = omega2_3 * omega2_3;
  const T t4_27 = omega2_1 * omega2_2;
  const T t4_28 = omega2_1 * omega2_3;
  const T N2_1 = T(0.04799999999999999) * t4_18 - (R2_11 * t4_19 + R2_12 * t4_20 + R2_13 * t4_21 + R2_11 * t4_22 +
      R2_12 * t4_23 + R2_13 * t4_24) + T(0.0048) * (t4_25 - t4_26) - T(0.0036) * t4_27 + T(0.006) * t4_28 + u.tau_2_1;
  const T t4_29 = omega2_1 * omega2_1;
  const T N2_2 = u.tau_2_2 - (R2_21 * t4_19 + R2_22 * t4_20 + R2_23 * t4_21 + R2_21 * t4_22 + R2_22 * t4_23 + R2_23 *
      t4_24 + T(0.023999999999999994) * t4_28 + T(0.0036) * (t4_26 - t4_29) + T(0.006) * t4_18 + T(0.0048) * t4_27);
  const T N2_3 = T(0.0048) * t4_28 - (R2_31 * t4_19 + R2_32 * t4_20 + R2_33 * t4_21 + R2_31 * t4_22 + R2_32 * t4_23 +
      R2_33 * t4_24 + T(0.023999999999999994) * t4_27 + T(0.006) * (t4_29 - t4_25)) + T(0.0036) * t4_18 + u.tau_2_3;
  // a4 = R4^T omega4~ omega4~ r4 + Pddot4: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t4_30 = omega4_1 * T(0.2) - omega4_2 * T(0.1);
  const T t4_31 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_32 = omega4_2 * t4_30 - omega4_3 * t4_31;
  const T t4_33 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_34 = omega4_3 * t4_33 - omega4_1 * t4_30;
  const T t4_35 = omega4_1 * t4_31 - omega4_2 * t4_33;
  const T a4_1 = R4_11 * t4_32 + R4_21 * t4_34 + R4_31 * t4_35 + Pddot4_1;
  const T a4_2 = R4_12 * t4_32 + R4_22 * t4_34 + R4_32 * t4_35 + Pddot4_2;
  const T a4_3 = R4_13 * t4_32 + R4_23 * t4_34 + R4_33 * t4_35 + Pddot4_3;
  // G4 = -m4 a4: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G4_1 = T(1.4) * a4_1;
  const T minus_G4_2 = T(1.4) * a4_2;
  const T minus_G4_3 = T(1.4) * a4_3;
  // N4 = -omega4~ I4 omega4 + M_torque_4_: applied less inertia moment at ydot = 0, body axes [N m]
  const T t4_36 = omega4_2 * omega4_3;
  const T t4_37 = omega4_2 * omega4_2;
  const T t4_38 = omega4_3 * omega4_3;
  const T t4_39 = omega4_1 * omega4_2;
  const T t4_40 = omega4_1 * omega4_3;
  const T N4_1 = T(0.05600000000000001) * t4_36 + T(0.0056) * (t4_37 - t4_38) - T(0.0042) * t4_39 + T(0.007) * t4_40 +
      u.tau_4_1;
  const T t4_41 = omega4_1 * omega4_1;
  const T N4_2 = u.tau_4_2 - (T(0.02800000000000001) * t4_40 + T(0.0042) * (t4_38 - t4_41) + T(0.007) * t4_36 +
      T(0.0056) * t4_39);
  const T N4_3 = T(0.0056) * t4_40 - (T(0.027999999999999997) * t4_39 + T(0.007) * (t4_41 - t4_37)) + T(0.0042) *
      t4_36 + u.tau_4_3;
  // C2_4 = R2 R4^T: takes components in the body to those in body 2
  const T C2_4_11 = R2_11 * R4_11 + R2_12 * R4_12 + R2_13 * R4_13;
  const T C2_4_12 = R2_11 * R4_21 + R2_12 * R4_22 + R2_13 * R4_23;
  const T C2_4_13 = R2_11 * R4_31 + R2_12 * R4_32 + R2_13 * R4_33;
  const T C2_4_21 = R2_21 * R4_11 + R2_22 * R4_12 + R2_23 * R4_13;
  const T C2_4_22 = R2_21 * R4_21 + R2_22 * R4_22 + R2_23 * R4_23;
  const T C2_4_23 = R2_21 * R4_31 + R2_22 * R4_32 + R2_23 * R4_33;
  const T C2_4_31 = R2_31 * R4_11 + R2_32 * R4_12 + R2_33 * R4_13;
  const T C2_4_32 = R2_31 * R4_21 + R2_32 * R4_22 + R2_33 * R4_23;
  const T C2_4_33 = R2_31 * R4_31 + R2_32 * R4_32 + R2_33 * R4_33;
  // C1_4 = R1 R4^T: takes components in the body to those in body 1
  const T C1_4_11 = R1_11 * R4_11 + R1_12 * R4_12 + R1_13 * R4_13;
  const T C1_4_12 = R1_11 * R4_21 + R1_12 * R4_22 + R1_13 * R4_23;
  const T C1_4_13 = R1_11 * R4_31 + R1_12 * R4_32 + R1_13 * R4_33;
  const T C1_4_21 = R1_21 * R4_11 + R1_22 * R4_12 + R1_23 * R4_13;
  const T C1_4_22 = R1_21 * R4_21 + R1_22 * R4_22 + R1_23 * R4_23;
  const T C1_4_23 = R1_21 * R4_31 + R1_22 * R4_32 + R1_23 * R4_33;
  const T C1_4_31 = R1_31 * R4_11 + R1_32 * R4_12 + R1_33 * R4_13;
  const T C1_4_32 = R1_31 * R4_21 + R1_32 * R4_22 + R1_33 * R4_23;
  const T C1_4_33 = R1_31 * R4_31 + R1_32 * R4_32 + R1_33 * R4_33;

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
  // Pddot5 = R1^T omega1~ omega1~ q5: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t5_13 = omega1_1 * T(0.25) - t2_14;
  const T t5_14 = omega1_2 * t5_13 - t2_17;
  const T t5_15 = t1_13 - omega1_3 * T(0.25);
  const T t5_16 = omega1_3 * t5_15 - omega1_1 * t5_13;
  const T t5_17 = t2_21 - omega1_2 * t5_15;
  const T Pddot5_1 = R1_11 * t5_14 + R1_21 * t5_16 + R1_31 * t5_17;
  const T Pddot5_2 = R1_12 * t5_14 + R1_22 * t5_16 + R1_32 * t5_17;
  const T Pddot5_3 = R1_13 * t5_14 + R1_23 * t5_16 + R1_33 * t5_17;
  // N1 = -R1 R2^T M_torque_2_ - R1 R5^T M_torque_5_ - omega1~ I1 omega1 + M1: applied less inertia moment at ydot =
  //   0, body axes [N m]
  const T t5_18 = omega1_2 * omega1_3;
  const T t5_19 = R2_11 * u.tau_2_1 + R2_21 * u.tau_2_2 + R2_31 * u.tau_2_3;
  const T t5_20 = R2_12 * u.tau_2_1 + R2_22 * u.tau_2_2 + R2_32 * u.tau_2_3;
  const T t5_21 = R2_13 * u.tau_2_1 + R2_23 * u.tau_2_2 + R2_33 * u.tau_2_3;
  const T t5_22 = R5_11 * u.tau_5_1 + R5_21 * u.tau_5_2 + R5_31 * u.tau_5_3;
  const T t5_23 = R5_12 * u.tau_5_1 + R5_22 * u.tau_5_2 + R5_32 * u.tau_5_3;
  const T t5_24 = R5_13 * u.tau_5_1 + R5_23 * u.tau_5_2 + R5_33 * u.tau_5_3;
  const T t5_25 = omega1_2 * omega1_2;
  const T t5_26 = omega1_3 * omega1_3;
  const T t5_27 = omega1_1 * omega1_2;
  const T t5_28 = omega1_1 * omega1_3;
  const T N1_1 = T(0.04400000000000001) * t5_18 - (R1_11 * t5_19 + R1_12 * t5_20 + R1_13 * t5_21 + R1_11 * t5_22 +
      R1_12 * t5_23 + R1_13 * t5_24) + T(0.0044) * (t5_25 - t5_26) - T(0.0033) * t5_27 + T(0.0055) * t5_28 + u.M_1_1;
  const T t5_29 = omega1_1 * omega1_1;
  const T N1_2 = u.M_1_2 - (R1_21 * t5_19 + R1_22 * t5_20 + R1_23 * t5_21 + R1_21 * t5_22 + R1_22 * t5_23 + R1_23 *
      t5_24 + T(0.022000000000000006) * t5_28 + T(0.0033) * (t5_26 - t5_29) + T(0.0055) * t5_18 + T(0.0044) * t5_27);
  const T N1_3 = T(0.0044) * t5_28 - (R1_31 * t5_19 + R1_32 * t5_20 + R1_33 * t5_21 + R1_31 * t5_22 + R1_32 * t5_23 +
      R1_33 * t5_24 + T(0.022000000000000006) * t5_27 + T(0.0055) * (t5_29 - t5_25)) + T(0.0033) * t5_18 + u.M_1_3;
  // a5 = R5^T omega5~ omega5~ r5 + Pddot5: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t5_30 = omega5_2 * T(0.1);
  const T t5_31 = omega5_1 * T(0.2) - t5_30;
  const T t5_32 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_33 = omega5_2 * t5_31 - omega5_3 * t5_32;
  const T t5_34 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_35 = omega5_3 * t5_34 - omega5_1 * t5_31;
  const T t5_36 = omega5_1 * t5_32 - omega5_2 * t5_34;
  const T a5_1 = R5_11 * t5_33 + R5_21 * t5_35 + R5_31 * t5_36 + Pddot5_1;
  const T a5_2 = R5_12 * t5_33 + R5_22 * t5_35 + R5_32 * t5_36 + Pddot5_2;
  const T a5_3 = R5_13 * t5_33 + R5_23 * t5_35 + R5_33 * t5_36 + Pddot5_3;
  // G5 = -m5 a5: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G5_1 = T(1.5) * a5_1;
  const T minus_G5_2 = T(1.5) * a5_2;
  const T minus_G5_3 = T(1.5) * a5_3;
  // C1_5 = R1 R5^T: takes components in the body to those in body 1
  const T C1_5_11 = R1_11 * R5_11 + R1_12 * R5_12 + R1_13 * R5_13;
  const T C1_5_12 = R1_11 * R5_21 + R1_12 * R5_22 + R1_13 * R5_23;
  const T C1_5_13 = R1_11 * R5_31 + R1_12 * R5_32 + R1_13 * R5_33;
  const T C1_5_21 = R1_21 * R5_11 + R1_22 * R5_12 + R1_23 * R5_13;
  const T C1_5_22 = R1_21 * R5_21 + R1_22 * R5_22 + R1_23 * R5_23;
  const T C1_5_23 = R1_21 * R5_31 + R1_22 * R5_32 + R1_23 * R5_33;
  const T C1_5_31 = R1_31 * R5_11 + R1_32 * R5_12 + R1_33 * R5_13;
  const T C1_5_32 = R1_31 * R5_21 + R1_32 * R5_22 + R1_33 * R5_23;
  const T C1_5_33 = R1_31 * R5_31 + R1_32 * R5_32 + R1_33 * R5_33;

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
  // Pddot6 = R5^T omega5~ omega5~ q6 + Pddot5: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t6_13 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T t6_14 = omega5_3 * T(0.3);
  const T t6_15 = t6_14 - omega5_1 * T(0.1);
  const T t6_16 = omega5_2 * t6_13 - omega5_3 * t6_15;
  const T t6_17 = t5_30 - t6_14;
  const T t6_18 = omega5_3 * t6_17 - omega5_1 * t6_13;
  const T t6_19 = omega5_1 * t6_15 - omega5_2 * t6_17;
  const T Pddot6_1 = R5_11 * t6_16 + R5_21 * t6_18 + R5_31 * t6_19 + Pddot5_1;
  const T Pddot6_2 = R5_12 * t6_16 + R5_22 * t6_18 + R5_32 * t6_19 + Pddot5_2;
  const T Pddot6_3 = R5_13 * t6_16 + R5_23 * t6_18 + R5_33 * t6_19 + Pddot5_3;
  // N5 = -R5 R6^T M_torque_6_ - omega5~ I5 omega5 + M_torque_5_: applied less inertia moment at ydot = 0, body axes
  //   [N m]
  const T t6_20 = omega5_2 * omega5_3;
  const T t6_21 = R6_11 * u.tau_6_1 + R6_21 * u.tau_6_2 + R6_31 * u.tau_6_3;
  const T t6_22 = R6_12 * u.tau_6_1 + R6_22 * u.tau_6_2 + R6_32 * u.tau_6_3;
  const T t6_23 = R6_13 * u.tau_6_1 + R6_23 * u.tau_6_2 + R6_33 * u.tau_6_3;
  const T t6_24 = omega5_2 * omega5_2;
  const T t6_25 = omega5_3 * omega5_3;
  const T t6_26 = omega5_1 * omega5_2;
  const T t6_27 = omega5_1 * omega5_3;
  const T N5_1 = T(0.06) * t6_20 - (R5_11 * t6_21 + R5_12 * t6_22 + R5_13 * t6_23) + T(0.006) * (t6_24 - t6_25) -
      T(0.0045) * t6_26 + T(0.0075) * t6_27 + u.tau_5_1;
  const T t6_28 = omega5_1 * omega5_1;
  const T N5_2 = u.tau_5_2 - (R5_21 * t6_21 + R5_22 * t6_22 + R5_23 * t6_23 + T(0.03) * t6_27 + T(0.0045) * (t6_25 -
      t6_28) + T(0.0075) * t6_20 + T(0.006) * t6_26);
  const T N5_3 = T(0.006) * t6_27 - (R5_31 * t6_21 + R5_32 * t6_22 + R5_33 * t6_23 + T(0.03) * t6_26 + T(0.0075) *
      (t6_28 - t6_24)) + T(0.0045) * t6_20 + u.tau_5_3;
  // a6 = R6^T omega6~ omega6~ r6 + Pddot6: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t6_29 = omega6_1 * T(0.2) - omega6_2 * T(0.1);
  const T t6_30 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_31 = omega6_2 * t6_29 - omega6_3 * t6_30;
  const T t6_32 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_33 = omega6_3 * t6_32 - omega6_1 * t6_29;
  const T t6_34 = omega6_1 * t6_30 - omega6_2 * t6_32;
  const T a6_1 = R6_11 * t6_31 + R6_21 * t6_33 + R6_31 * t6_34 + Pddot6_1;
  const T a6_2 = R6_12 * t6_31 + R6_22 * t6_33 + R6_32 * t6_34 + Pddot6_2;
  const T a6_3 = R6_13 * t6_31 + R6_23 * t6_33 + R6_33 * t6_34 + Pddot6_3;
  // G6 = -m6 a6: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G6_1 = T(1.6) * a6_1;
  const T minus_G6_2 = T(1.6) * a6_2;
  const T minus_G6_3 = T(1.6) * a6_3;
  // N6 = -omega6~ I6 omega6 + M_torque_6_: applied less inertia moment at ydot = 0, body axes [N m]
  const T t6_35 = omega6_2 * omega6_3;
  const T t6_36 = omega6_2 * omega6_2;
  const T t6_37 = omega6_3 * omega6_3;
  const T t6_38 = omega6_1 * omega6_2;
  const T t6_39 = omega6_1 * omega6_3;
  const T N6_1 = T(0.064) * t6_35 + T(0.0064) * (t6_36 - t6_37) - T(0.0048) * t6_38 + T(0.008) * t6_39 + u.tau_6_1;
  const T t6_40 = omega6_1 * omega6_1;
  const T N6_2 = u.tau_6_2 - (T(0.032) * t6_39 + T(0.0048) * (t6_37 - t6_40) + T(0.008) * t6_35 + T(0.0064) * t6_38);
  const T N6_3 = T(0.0064) * t6_39 - (T(0.032) * t6_38 + T(0.008) * (t6_40 - t6_36)) + T(0.0048) * t6_35 + u.tau_6_3;
  // C5_6 = R5 R6^T: takes components in the body to those in body 5
  const T C5_6_11 = R5_11 * R6_11 + R5_12 * R6_12 + R5_13 * R6_13;
  const T C5_6_12 = R5_11 * R6_21 + R5_12 * R6_22 + R5_13 * R6_23;
  const T C5_6_13 = R5_11 * R6_31 + R5_12 * R6_32 + R5_13 * R6_33;
  const T C5_6_21 = R5_21 * R6_11 + R5_22 * R6_12 + R5_23 * R6_13;
  const T C5_6_22 = R5_21 * R6_21 + R5_22 * R6_22 + R5_23 * R6_23;
  const T C5_6_23 = R5_21 * R6_31 + R5_22 * R6_32 + R5_23 * R6_33;
  const T C5_6_31 = R5_31 * R6_11 + R5_32 * R6_12 + R5_33 * R6_13;
  const T C5_6_32 = R5_31 * R6_21 + R5_32 * R6_22 + R5_33 * R6_23;
  const T C5_6_33 = R5_31 * R6_31 + R5_32 * R6_32 + R5_33 * R6_33;
  // C1_6 = R1 R6^T: takes components in the body to those in body 1
  const T C1_6_11 = R1_11 * R6_11 + R1_12 * R6_12 + R1_13 * R6_13;
  const T C1_6_12 = R1_11 * R6_21 + R1_12 * R6_22 + R1_13 * R6_23;
  const T C1_6_13 = R1_11 * R6_31 + R1_12 * R6_32 + R1_13 * R6_33;
  const T C1_6_21 = R1_21 * R6_11 + R1_22 * R6_12 + R1_23 * R6_13;
  const T C1_6_22 = R1_21 * R6_21 + R1_22 * R6_22 + R1_23 * R6_23;
  const T C1_6_23 = R1_21 * R6_31 + R1_22 * R6_32 + R1_23 * R6_33;
  const T C1_6_31 = R1_31 * R6_11 + R1_32 * R6_12 + R1_33 * R6_13;
  const T C1_6_32 = R1_31 * R6_21 + R1_32 * R6_22 + R1_33 * R6_23;
  const T C1_6_33 = R1_31 * R6_31 + R1_32 * R6_32 + R1_33 * R6_33;

  // ---- body 6 (body_6) and what it carries
  // f_omega6 = r6~ R6 G6 + N6: Kane's equation of omega [N m]
  const T b6_1 = R6_21 * minus_G6_1 + R6_22 * minus_G6_2 + R6_23 * minus_G6_3;
  const T b6_2 = R6_31 * minus_G6_1 + R6_32 * minus_G6_2 + R6_33 * minus_G6_3;
  const T f_omega6_1 = T(0.05) * b6_1 - T(0.2) * b6_2 + N6_1;
  const T b6_3 = R6_11 * minus_G6_1 + R6_12 * minus_G6_2 + R6_13 * minus_G6_3;
  const T f_omega6_2 = T(0.1) * b6_2 - T(0.05) * b6_3 + N6_2;
  const T f_omega6_3 = T(0.2) * b6_3 - T(0.1) * b6_1 + N6_3;

  // ---- body 5 (body_5) and what it carries
  // S5 = G5 + G6: sum of the force balances of the subtree, inertial axes [N]
  const T minus_S5_1 = minus_G5_1 + minus_G6_1;
  const T minus_S5_2 = minus_G5_2 + minus_G6_2;
  const T minus_S5_3 = minus_G5_3 + minus_G6_3;
  // f_omega5 = q6~ R5 G6 + r5~ R5 G5 + N5: Kane's equation of omega [N m]
  const T b5_1 = R5_21 * minus_G6_1 + R5_22 * minus_G6_2 + R5_23 * minus_G6_3;
  const T b5_2 = T(0.3) * (R5_31 * minus_G6_1 + R5_32 * minus_G6_2 + R5_33 * minus_G6_3);
  const T b5_3 = R5_21 * minus_G5_1 + R5_22 * minus_G5_2 + R5_23 * minus_G5_3;
  const T b5_4 = R5_31 * minus_G5_1 + R5_32 * minus_G5_2 + R5_33 * minus_G5_3;
  const T f_omega5_1 = T(0.1) * b5_1 - b5_2 + T(0.05) * b5_3 - T(0.2) * b5_4 + N5_1;
  const T b5_5 = R5_11 * minus_G6_1 + R5_12 * minus_G6_2 + R5_13 * minus_G6_3;
  const T b5_6 = R5_11 * minus_G5_1 + R5_12 * minus_G5_2 + R5_13 * minus_G5_3;
  const T f_omega5_2 = b5_2 - T(0.1) * b5_5 + T(0.1) * b5_4 - T(0.05) * b5_6 + N5_2;
  const T f_omega5_3 = T(0.3) * b5_5 - T(0.3) * b5_1 + T(0.2) * b5_6 - T(0.1) * b5_3 + N5_3;
  // D_omegadot5: pivots of L D L^T
  const T b5_7 = T(0.3) * (C5_6_32 * T(0.08000000000000002) - C5_6_33 * T(0.32000000000000006));
  const T b5_8 = C5_6_22 * T(0.08000000000000002) - C5_6_23 * T(0.32000000000000006);
  const T b5_9 = b5_7 - T(0.1) * b5_8;
  const T b5_10 = b5_9 * T(4.385964912280701);
  const T b5_11 = T(0.3) * (C5_6_33 * T(0.16000000000000003) - C5_6_31 * T(0.08000000000000002));
  const T b5_12 = C5_6_23 * T(0.16000000000000003) - C5_6_21 * T(0.08000000000000002);
  const T b5_13 = b5_10 * T(0.024000000000000004) + b5_11 - T(0.1) * b5_12;
  const T b5_14 = b5_13 * T(4.773869346733668);
  const T b5_15 = T(0.3) * (C5_6_31 * T(0.32000000000000006) - C5_6_32 * T(0.16000000000000003));
  const T b5_16 = C5_6_21 * T(0.32000000000000006) - C5_6_22 * T(0.16000000000000003);
  const T b5_17 = b5_10 * T(0.003200000000000002) + b5_15 - T(0.1) * b5_16 + b5_14 * T(0.02273684210526316);
  const T b5_18 = b5_17 * T(4.866483897725908);
  const T D_omegadot5_1 = T(0.37375) - b5_10 * b5_9 - b5_14 * b5_13 - b5_18 * b5_17;
  const T b5_19 = C5_6_12 * T(0.08000000000000002) - C5_6_13 * T(0.32000000000000006);
  const T b5_20 = T(0.1) * b5_19 - b5_7;
  const T b5_21 = b5_20 * T(4.385964912280701);
  const T b5_22 = C5_6_13 * T(0.16000000000000003) - C5_6_11 * T(0.08000000000000002);
  const T b5_23 = b5_21 * T(0.024000000000000004) + T(0.1) * b5_22 - b5_11;
  const T b5_24 = b5_23 * T(4.773869346733668);
  const T b5_25 = C5_6_11 * T(0.32000000000000006) - C5_6_12 * T(0.16000000000000003);
  const T b5_26 = b5_21 * T(0.003200000000000002) + T(0.1) * b5_25 - b5_15 + b5_24 * T(0.02273684210526316);
  const T b5_27 = b5_26 * T(4.866483897725908);
  const T b5_28 = T(0.1665) + b5_21 * b5_9 + b5_24 * b5_13 + b5_27 * b5_17;
  const T b5_29 = T(1) / D_omegadot5_1;
  const T b5_30 = b5_28 * b5_29;
  const T D_omegadot5_2 = T(0.35875) - b5_21 * b5_20 - b5_24 * b5_23 - b5_27 * b5_26 - b5_30 * b5_28;
  const T b5_31 = T(0.3) * b5_8 - T(0.3) * b5_19;
  const T b5_32 = b5_31 * T(4.385964912280701);
  const T b5_33 = b5_32 * T(0.024000000000000004) + T(0.3) * b5_12 - T(0.3) * b5_22;
  const T b5_34 = b5_33 * T(4.773869346733668);
  const T b5_35 = b5_32 * T(0.003200000000000002) + T(0.3) * b5_16 - T(0.3) * b5_25 + b5_34 * T(0.02273684210526316);
  const T b5_36 = b5_35 * T(4.866483897725908);
  const T b5_37 = T(0.051000000000000004) + b5_32 * b5_9 + b5_34 * b5_13 + b5_36 * b5_17;
  const T b5_38 = b5_37 * b5_29;
  const T b5_39 = T(0.069) + b5_32 * b5_20 + b5_34 * b5_23 + b5_36 * b5_26 + b5_38 * b5_28;
  const T b5_40 = T(1) / D_omegadot5_2;
  const T b5_41 = b5_39 * b5_40;
  const T D_omegadot5_3 = T(0.483) - b5_32 * b5_31 - b5_34 * b5_33 - b5_36 * b5_35 - b5_38 * b5_37 - b5_41 * b5_39;

  // ---- body 4 (body_4) and what it carries
  // f_omega4 = r4~ R4 G4 + N4: Kane's equation of omega [N m]
  const T b4_1 = R4_21 * minus_G4_1 + R4_22 * minus_G4_2 + R4_23 * minus_G4_3;
  const T b4_2 = R4_31 * minus_G4_1 + R4_32 * minus_G4_2 + R4_33 * minus_G4_3;
  const T f_omega4_1 = T(0.05) * b4_1 - T(0.2) * b4_2 + N4_1;
  const T b4_3 = R4_11 * minus_G4_1 + R4_12 * minus_G4_2 + R4_13 * minus_G4_3;
  const T f_omega4_2 = T(0.1) * b4_2 - T(0.05) * b4_3 + N4_2;
  const T f_omega4_3 = T(0.2) * b4_3 - T(0.1) * b4_1 + N4_3;

  // ---- body 3 (body_3) and what it carries
  // f_omega3 = r3~ R3 G3 + N3: Kane's equation of omega [N m]
  const T b3_1 = R3_21 * minus_G3_1 + R3_22 * minus_G3_2 + R3_23 * minus_G3_3;
  const T b3_2 = R3_31 * minus_G3_1 + R3_32 * minus_G3_2 + R3_33 * minus_G3_3;
  const T f_omega3_1 = T(0.05) * b3_1 - T(0.2) * b3_2 + N3_1;
  const T b3_3 = R3_11 * minus_G3_1 + R3_12 * minus_G3_2 + R3_13 * minus_G3_3;
  const T f_omega3_2 = T(0.1) * b3_2 - T(0.05) * b3_3 + N3_2;
  const T f_omega3_3 = T(0.2) * b3_3 - T(0.1) * b3_1 + N3_3;

  // ---- body 2 (body_2) and what it carries
  // S2 = G2 + G3 + G4: sum of the force balances of the subtree, inertial axes [N]
  const T minus_S2_1 = minus_G2_1 + minus_G3_1 + minus_G4_1;
  const T minus_S2_2 = minus_G2_2 + minus_G3_2 + minus_G4_2;
  const T minus_S2_3 = minus_G2_3 + minus_G3_3 + minus_G4_3;
  // f_omega2 = q3~ R2 G3 + q4~ R2 G4 + r2~ R2 G2 + N2: Kane's equation of omega [N m]
  const T b2_1 = R2_21 * minus_G3_1 + R2_22 * minus_G3_2 + R2_23 * minus_G3_3;
  const T b2_2 = R2_31 * minus_G3_1 + R2_32 * minus_G3_2 + R2_33 * minus_G3_3;
  const T b2_3 = R2_21 * minus_G4_1 + R2_22 * minus_G4_2 + R2_23 * minus_G4_3;
  const T b2_4 = R2_31 * minus_G4_1 + R2_32 * minus_G4_2 + R2_33 * minus_G4_3;
  const T b2_5 = R2_21 * minus_G2_1 + R2_22 * minus_G2_2 + R2_23 * minus_G2_3;
  const T b2_6 = R2_31 * minus_G2_1 + R2_32 * minus_G2_2 + R2_33 * minus_G2_3;
  const T f_omega2_1 = T(0.1) * b2_1 - T(0.15) * b2_2 + T(0.1) * b2_3 - T(0.2) * b2_4 + T(0.05) * b2_5 - T(0.2) * b2_6
      + N2_1;
  const T b2_7 = R2_11 * minus_G3_1 + R2_12 * minus_G3_2 + R2_13 * minus_G3_3;
  const T b2_8 = R2_11 * minus_G4_1 + R2_12 * minus_G4_2 + R2_13 * minus_G4_3;
  const T b2_9 = R2_11 * minus_G2_1 + R2_12 * minus_G2_2 + R2_13 * minus_G2_3;
  const T f_omega2_2 = T(0.3) * b2_2 - T(0.1) * b2_7 + T(0.3) * b2_4 - T(0.1) * b2_8 + T(0.1) * b2_6 - T(0.05) * b2_9
      + N2_2;
  const T f_omega2_3 = T(0.15) * b2_7 - T(0.3) * b2_1 + T(0.2) * b2_8 - T(0.3) * b2_3 + T(0.2) * b2_9 - T(0.1) * b2_5
      + N2_3;
  // D_omegadot2: pivots of L D L^T
  const T b2_10 = C2_4_32 * T(0.06999999999999999) - C2_4_33 * T(0.27999999999999997);
  const T b2_11 = C2_4_22 * T(0.06999999999999999) - C2_4_23 * T(0.27999999999999997);
  const T b2_12 = T(0.2) * b2_10 - T(0.1) * b2_11;
  const T b2_13 = b2_12 * T(5.012531328320802);
  const T b2_14 = C2_4_33 * T(0.13999999999999999) - C2_4_31 * T(0.06999999999999999);
  const T b2_15 = C2_4_23 * T(0.13999999999999999) - C2_4_21 * T(0.06999999999999999);
  const T b2_16 = b2_13 * T(0.021) + T(0.2) * b2_14 - T(0.1) * b2_15;
  const T b2_17 = b2_16 * T(5.455850681981335);
  const T b2_18 = C2_4_31 * T(0.27999999999999997) - C2_4_32 * T(0.13999999999999999);
  const T b2_19 = C2_4_21 * T(0.27999999999999997) - C2_4_22 * T(0.13999999999999999);
  const T b2_20 = b2_13 * T(0.0028000000000000004) + T(0.2) * b2_18 - T(0.1) * b2_19 + b2_17 *
      T(0.019894736842105264);
  const T b2_21 = b2_20 * T(5.561695883115324);
  const T b2_22 = C2_3_32 * T(0.065) - C2_3_33 * T(0.26);
  const T b2_23 = C2_3_22 * T(0.065) - C2_3_23 * T(0.26);
  const T b2_24 = T(0.15) * b2_22 - T(0.1) * b2_23;
  const T b2_25 = b2_24 * T(5.398110661268555);
  const T b2_26 = C2_3_33 * T(0.13) - C2_3_31 * T(0.065);
  const T b2_27 = C2_3_23 * T(0.13) - C2_3_21 * T(0.065);
  const T b2_28 = b2_25 * T(0.019500000000000003) + T(0.15) * b2_26 - T(0.1) * b2_27;
  const T b2_29 = b2_28 * T(5.875531503672208);
  const T b2_30 = C2_3_31 * T(0.26) - C2_3_32 * T(0.13);
  const T b2_31 = C2_3_21 * T(0.26) - C2_3_22 * T(0.13);
  const T b2_32 = b2_25 * T(0.002600000000000001) + T(0.15) * b2_30 - T(0.1) * b2_31 + b2_29 * T(0.01847368421052632);
  const T b2_33 = b2_32 * T(5.989518643354965);
  const T D_omegadot2_1 = T(0.28325) - b2_13 * b2_12 - b2_17 * b2_16 - b2_21 * b2_20 - b2_25 * b2_24 - b2_29 * b2_28 -
      b2_33 * b2_32;
  const T b2_34 = C2_4_12 * T(0.06999999999999999) - C2_4_13 * T(0.27999999999999997);
  const T b2_35 = T(0.1) * b2_34 - T(0.3) * b2_10;
  const T b2_36 = b2_35 * T(5.012531328320802);
  const T b2_37 = C2_4_13 * T(0.13999999999999999) - C2_4_11 * T(0.06999999999999999);
  const T b2_38 = b2_36 * T(0.021) + T(0.1) * b2_37 - T(0.3) * b2_14;
  const T b2_39 = b2_38 * T(5.455850681981335);
  const T b2_40 = C2_4_11 * T(0.27999999999999997) - C2_4_12 * T(0.13999999999999999);
  const T b2_41 = b2_36 * T(0.0028000000000000004) + T(0.1) * b2_40 - T(0.3) * b2_18 + b2_39 *
      T(0.019894736842105264);
  const T b2_42 = b2_41 * T(5.561695883115324);
  const T b2_43 = C2_3_12 * T(0.065) - C2_3_13 * T(0.26);
  const T b2_44 = T(0.1) * b2_43 - T(0.3) * b2_22;
  const T b2_45 = b2_44 * T(5.398110661268555);
  const T b2_46 = C2_3_13 * T(0.13) - C2_3_11 * T(0.065);
  const T b2_47 = b2_45 * T(0.019500000000000003) + T(0.1) * b2_46 - T(0.3) * b2_26;
  const T b2_48 = b2_47 * T(5.875531503672208);
  const T b2_49 = C2_3_11 * T(0.26) - C2_3_12 * T(0.13);
  const T b2_50 = b2_45 * T(0.002600000000000001) + T(0.1) * b2_49 - T(0.3) * b2_30 + b2_48 * T(0.01847368421052632);
  const T b2_51 = b2_50 * T(5.989518643354965);
  const T b2_52 = T(0.1605) + b2_36 * b2_12 + b2_39 * b2_16 + b2_42 * b2_20 + b2_45 * b2_24 + b2_48 * b2_28 + b2_51 *
      b2_32;
  const T b2_53 = T(1) / D_omegadot2_1;
  const T b2_54 = b2_52 * b2_53;
  const T D_omegadot2_2 = T(0.429) - b2_36 * b2_35 - b2_39 * b2_38 - b2_42 * b2_41 - b2_45 * b2_44 - b2_48 * b2_47 -
      b2_51 * b2_50 - b2_54 * b2_52;
  const T b2_55 = T(0.3) * b2_11 - T(0.2) * b2_34;
  const T b2_56 = b2_55 * T(5.012531328320802);
  const T b2_57 = b2_56 * T(0.021) + T(0.3) * b2_15 - T(0.2) * b2_37;
  const T b2_58 = b2_57 * T(5.455850681981335);
  const T b2_59 = b2_56 * T(0.0028000000000000004) + T(0.3) * b2_19 - T(0.2) * b2_40 + b2_58 *
      T(0.019894736842105264);
  const T b2_60 = b2_59 * T(5.561695883115324);
  const T b2_61 = T(0.3) * b2_23 - T(0.15) * b2_43;
  const T b2_62 = b2_61 * T(5.398110661268555);
  const T b2_63 = b2_62 * T(0.019500000000000003) + T(0.3) * b2_27 - T(0.15) * b2_46;
  const T b2_64 = b2_63 * T(5.875531503672208);
  const T b2_65 = b2_62 * T(0.002600000000000001) + T(0.3) * b2_31 - T(0.15) * b2_49 + b2_64 * T(0.01847368421052632);
  const T b2_66 = b2_65 * T(5.989518643354965);
  const T b2_67 = T(0.0834) + b2_56 * b2_12 + b2_58 * b2_16 + b2_60 * b2_20 + b2_62 * b2_24 + b2_64 * b2_28 + b2_66 *
      b2_32;
  const T b2_68 = b2_67 * b2_53;
  const T b2_69 = T(0.0643) + b2_56 * b2_35 + b2_58 * b2_38 + b2_60 * b2_41 + b2_62 * b2_44 + b2_64 * b2_47 + b2_66 *
      b2_50 + b2_68 * b2_52;
  const T b2_70 = T(1) / D_omegadot2_2;
  const T b2_71 = b2_69 * b2_70;
  const T D_omegadot2_3 = T(0.48424999999999996) - b2_56 * b2_55 - b2_58 * b2_57 - b2_60 * b2_59 - b2_62 * b2_61 -
      b2_64 * b2_63 - b2_66 * b2_65 - b2_68 * b2_67 - b2_71 * b2_69;

  // ---- body 1 (body_1) and what it carries
  // S1 = G1 + S5 + S2: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = G1_1 - minus_S5_1 - minus_S2_1;
  const T S1_2 = G1_2 - minus_S5_2 - minus_S2_2;
  const T S1_3 = G1_3 - minus_S5_3 - minus_S2_3;
  // f_omega1 = q2~ R1 S2 + q5~ R1 S5 + r1~ R1 G1 + N1: Kane's equation of omega [N m]
  const T b1_1 = R1_21 * minus_S2_1 + R1_22 * minus_S2_2 + R1_23 * minus_S2_3;
  const T b1_2 = R1_31 * minus_S2_1 + R1_32 * minus_S2_2 + R1_33 * minus_S2_3;
  const T b1_3 = R1_21 * minus_S5_1 + R1_22 * minus_S5_2 + R1_23 * minus_S5_3;
  const T b1_4 = R1_31 * minus_S5_1 + R1_32 * minus_S5_2 + R1_33 * minus_S5_3;
  const T b1_5 = R1_31 * G1_1 + R1_32 * G1_2 + R1_33 * G1_3;
  const T b1_6 = R1_21 * G1_1 + R1_22 * G1_2 + R1_23 * G1_3;
  const T f_omega1_1 = T(0.1) * b1_1 - T(0.1) * b1_2 + T(0.1) * b1_3 - T(0.25) * b1_4 + T(0.2) * b1_5 - T(0.05) * b1_6
      + N1_1;
  const T b1_7 = T(0.1) * (R1_11 * minus_S2_1 + R1_12 * minus_S2_2 + R1_13 * minus_S2_3);
  const T b1_8 = R1_11 * minus_S5_1 + R1_12 * minus_S5_2 + R1_13 * minus_S5_3;
  const T b1_9 = R1_11 * G1_1 + R1_12 * G1_2 + R1_13 * G1_3;
  const T f_omega1_2 = T(0.3) * b1_2 - b1_7 + T(0.3) * b1_4 - T(0.1) * b1_8 + T(0.05) * b1_9 - T(0.1) * b1_5 + N1_2;
  const T f_omega1_3 = b1_7 - T(0.3) * b1_1 + T(0.25) * b1_8 - T(0.3) * b1_3 + T(0.1) * b1_6 - T(0.2) * b1_9 + N1_3;
  // D_omegadot1: pivots of L D L^T
  const T b1_10 = C1_6_32 * T(0.08000000000000002) - C1_6_33 * T(0.32000000000000006);
  const T b1_11 = C1_6_22 * T(0.08000000000000002) - C1_6_23 * T(0.32000000000000006);
  const T b1_12 = T(0.25) * b1_10 - T(0.1) * b1_11;
  const T b1_13 = b1_12 * T(4.385964912280701);
  const T b1_14 = C1_6_33 * T(0.16000000000000003) - C1_6_31 * T(0.08000000000000002);
  const T b1_15 = C1_6_23 * T(0.16000000000000003) - C1_6_21 * T(0.08000000000000002);
  const T b1_16 = b1_13 * T(0.024000000000000004) + T(0.25) * b1_14 - T(0.1) * b1_15;
  const T b1_17 = b1_16 * T(4.773869346733668);
  const T b1_18 = C1_6_31 * T(0.32000000000000006) - C1_6_32 * T(0.16000000000000003);
  const T b1_19 = C1_6_21 * T(0.32000000000000006) - C1_6_22 * T(0.16000000000000003);
  const T b1_20 = b1_13 * T(0.003200000000000002) + T(0.25) * b1_18 - T(0.1) * b1_19 + b1_17 * T(0.02273684210526316);
  const T b1_21 = b1_20 * T(4.866483897725908);
  const T b1_22 = C1_5_32 * T(0.23500000000000001) - C1_5_33 * T(0.78);
  const T b1_23 = C1_5_22 * T(0.23500000000000001) - C1_5_23 * T(0.78);
  const T b1_24 = T(0.25) * b1_22 - T(0.1) * b1_23 + b1_13 * b5_9 + b1_17 * b5_13 + b1_21 * b5_17;
  const T b1_25 = b1_24 * b5_29;
  const T b1_26 = C1_5_33 * T(0.63) - C1_5_31 * T(0.23500000000000001);
  const T b1_27 = C1_5_23 * T(0.63) - C1_5_21 * T(0.23500000000000001);
  const T b1_28 = b1_25 * b5_28 + T(0.25) * b1_26 - T(0.1) * b1_27 + b1_13 * b5_20 + b1_17 * b5_23 + b1_21 * b5_26;
  const T b1_29 = b1_28 * b5_40;
  const T b1_30 = C1_5_31 * T(0.78) - C1_5_32 * T(0.63);
  const T b1_31 = C1_5_21 * T(0.78) - C1_5_22 * T(0.63);
  const T b1_32 = b1_25 * b5_37 + T(0.25) * b1_30 - T(0.1) * b1_31 + b1_13 * b5_31 + b1_17 * b5_33 + b1_21 * b5_35 +
      b1_29 * b5_39;
  const T b1_33 = T(1) / D_omegadot5_3;
  const T b1_34 = b1_32 * b1_33;
  const T b1_35 = C1_4_32 * T(0.06999999999999999) - C1_4_33 * T(0.27999999999999997);
  const T b1_36 = C1_4_22 * T(0.06999999999999999) - C1_4_23 * T(0.27999999999999997);
  const T b1_37 = T(0.1) * b1_35 - T(0.1) * b1_36;
  const T b1_38 = b1_37 * T(5.012531328320802);
  const T b1_39 = C1_4_33 * T(0.13999999999999999) - C1_4_31 * T(0.06999999999999999);
  const T b1_40 = C1_4_23 * T(0.13999999999999999) - C1_4_21 * T(0.06999999999999999);
  const T b1_41 = b1_38 * T(0.021) + T(0.1) * b1_39 - T(0.1) * b1_40;
  const T b1_42 = b1_41 * T(5.455850681981335);
  const T b1_43 = C1_4_31 * T(0.27999999999999997) - C1_4_32 * T(0.13999999999999999);
  const T b1_44 = C1_4_21 * T(0.27999999999999997) - C1_4_22 * T(0.13999999999999999);
  const T b1_45 = b1_38 * T(0.0028000000000000004) + T(0.1) * b1_43 - T(0.1) * b1_44 + b1_42 *
      T(0.019894736842105264);
  const T b1_46 = b1_45 * T(5.561695883115324);
  const T b1_47 = C1_3_32 * T(0.065) - C1_3_33 * T(0.26);
  const T b1_48 = C1_3_22 * T(0.065) - C1_3_23 * T(0.26);
  const T b1_49 = T(0.1) * b1_47 - T(0.1) * b1_48;
  const T b1_50 = b1_49 * T(5.398110661268555);
  const T b1_51 = C1_3_33 * T(0.13) - C1_3_31 * T(0.065);
  const T b1_52 = C1_3_23 * T(0.13) - C1_3_21 * T(0.065);
  const T b1_53 = b1_50 * T(0.019500000000000003) + T(0.1) * b1_51 - T(0.1) * b1_52;
  const T b1_54 = b1_53 * T(5.875531503672208);
  const T b1_55 = C1_3_31 * T(0.26) - C1_3_32 * T(0.13);
  const T b1_56 = C1_3_21 * T(0.26) - C1_3_22 * T(0.13);
  const T b1_57 = b1_50 * T(0.002600000000000001) + T(0.1) * b1_55 - T(0.1) * b1_56 + b1_54 * T(0.01847368421052632);
  const T b1_58 = b1_57 * T(5.989518643354965);
  const T b1_59 = C1_2_32 * T(0.33) - C1_2_33 * T(0.715);
  const T b1_60 = C1_2_22 * T(0.33) - C1_2_23 * T(0.715);
  const T b1_61 = T(0.1) * b1_59 - T(0.1) * b1_60 + b1_38 * b2_12 + b1_42 * b2_16 + b1_46 * b2_20 + b1_50 * b2_24 +
      b1_54 * b2_28 + b1_58 * b2_32;
  const T b1_62 = b1_61 * b2_53;
  const T b1_63 = C1_2_33 * T(0.9299999999999999) - C1_2_31 * T(0.33);
  const T b1_64 = C1_2_23 * T(0.9299999999999999) - C1_2_21 * T(0.33);
  const T b1_65 = b1_62 * b2_52 + T(0.1) * b1_63 - T(0.1) * b1_64 + b1_38 * b2_35 + b1_42 * b2_38 + b1_46 * b2_41 +
      b1_50 * b2_44 + b1_54 * b2_47 + b1_58 * b2_50;
  const T b1_66 = b1_65 * b2_70;
  const T b1_67 = C1_2_31 * T(0.715) - C1_2_32 * T(0.9299999999999999);
  const T b1_68 = C1_2_21 * T(0.715) - C1_2_22 * T(0.9299999999999999);
  const T b1_69 = b1_62 * b2_67 + T(0.1) * b1_67 - T(0.1) * b1_68 + b1_38 * b2_55 + b1_42 * b2_57 + b1_46 * b2_59 +
      b1_50 * b2_61 + b1_54 * b2_63 + b1_58 * b2_65 + b1_66 * b2_69;
  const T b1_70 = T(1) / D_omegadot2_3;
  const T b1_71 = b1_69 * b1_70;
  const T D_omegadot1_1 = T(0.4595) - b1_13 * b1_12 - b1_17 * b1_16 - b1_21 * b1_20 - b1_25 * b1_24 - b1_29 * b1_28 -
      b1_34 * b1_32 - b1_38 * b1_37 - b1_42 * b1_41 - b1_46 * b1_45 - b1_50 * b1_49 - b1_54 * b1_53 - b1_58 * b1_57 -
      b1_62 * b1_61 - b1_66 * b1_65 - b1_71 * b1_69;
  const T b1_72 = C1_6_12 * T(0.08000000000000002) - C1_6_13 * T(0.32000000000000006);
  const T b1_73 = T(0.1) * b1_72 - T(0.3) * b1_10;
  const T b1_74 = b1_73 * T(4.385964912280701);
  const T b1_75 = C1_6_13 * T(0.16000000000000003) - C1_6_11 * T(0.08000000000000002);
  const T b1_76 = b1_74 * T(0.024000000000000004) + T(0.1) * b1_75 - T(0.3) * b1_14;
  const T b1_77 = b1_76 * T(4.773869346733668);
  const T b1_78 = C1_6_11 * T(0.32000000000000006) - C1_6_12 * T(0.16000000000000003);
  const T b1_79 = b1_74 * T(0.003200000000000002) + T(0.1) * b1_78 - T(0.3) * b1_18 + b1_77 * T(0.02273684210526316);
  const T b1_80 = b1_79 * T(4.866483897725908);
  const T b1_81 = C1_5_12 * T(0.23500000000000001) - C1_5_13 * T(0.78);
  const T b1_82 = T(0.1) * b1_81 - T(0.3) * b1_22 + b1_74 * b5_9 + b1_77 * b5_13 + b1_80 * b5_17;
  const T b1_83 = b1_82 * b5_29;
  const T b1_84 = C1_5_13 * T(0.63) - C1_5_11 * T(0.23500000000000001);
  const T b1_85 = b1_83 * b5_28 + T(0.1) * b1_84 - T(0.3) * b1_26 + b1_74 * b5_20 + b1_77 * b5_23 + b1_80 * b5_26;
  const T b1_86 = b1_85 * b5_40;
  const T b1_87 = C1_5_11 * T(0.78) - C1_5_12 * T(0.63);
  const T b1_88 = b1_83 * b5_37 + T(0.1) * b1_87 - T(0.3) * b1_30 + b1_74 * b5_31 + b1_77 * b5_33 + b1_80 * b5_35 +
      b1_86 * b5_39;
  const T b1_89 = b1_88 * b1_33;
  const T b1_90 = T(0.1) * (C1_4_12 * T(0.06999999999999999) - C1_4_13 * T(0.27999999999999997));
  const T b1_91 = b1_90 - T(0.3) * b1_35;
  const T b1_92 = b1_91 * T(5.012531328320802);
  const T b1_93 = T(0.1) * (C1_4_13 * T(0.13999999999999999) - C1_4_11 * T(0.06999999999999999));
  const T b1_94 = b1_92 * T(0.021) + b1_93 - T(0.3) * b1_39;
  const T b1_95 = b1_94 * T(5.455850681981335);
  const T b1_96 = T(0.1) * (C1_4_11 * T(0.27999999999999997) - C1_4_12 * T(0.13999999999999999));
  const T b1_97 = b1_92 * T(0.0028000000000000004) + b1_96 - T(0.3) * b1_43 + b1_95 * T(0.019894736842105264);
  const T b1_98 = b1_97 * T(5.561695883115324);
  const T b1_99 = T(0.1) * (C1_3_12 * T(0.065) - C1_3_13 * T(0.26));
  const T b1_100 = b1_99 - T(0.3) * b1_47;
  const T b1_101 = b1_100 * T(5.398110661268555);
  const T b1_102 = T(0.1) * (C1_3_13 * T(0.13) - C1_3_11 * T(0.065));
  const T b1_103 = b1_101 * T(0.019500000000000003) + b1_102 - T(0.3) * b1_51;
  const T b1_104 = b1_103 * T(5.875531503672208);
  const T b1_105 = T(0.1) * (C1_3_11 * T(0.26) - C1_3_12 * T(0.13));
  const T b1_106 = b1_101 * T(0.002600000000000001) + b1_105 - T(0.3) * b1_55 + b1_104 * T(0.01847368421052632);
  const T b1_107 = b1_106 * T(5.989518643354965);
  const T b1_108 = T(0.1) * (C1_2_12 * T(0.33) - C1_2_13 * T(0.715));
  const T b1_109 = b1_108 - T(0.3) * b1_59 + b1_92 * b2_12 + b1_95 * b2_16 + b1_98 * b2_20 + b1_101 * b2_24 + b1_104 *
      b2_28 + b1_107 * b2_32;
  const T b1_110 = b1_109 * b2_53;
  const T b1_111 = T(0.1) * (C1_2_13 * T(0.9299999999999999) - C1_2_11 * T(0.33));
  const T b1_112 = b1_110 * b2_52 + b1_111 - T(0.3) * b1_63 + b1_92 * b2_35 + b1_95 * b2_38 + b1_98 * b2_41 + b1_101 *
      b2_44 + b1_104 * b2_47 + b1_107 * b2_50;
  const T b1_113 = b1_112 * b2_70;
  const T b1_114 = T(0.1) * (C1_2_11 * T(0.715) - C1_2_12 * T(0.9299999999999999));
  const T b1_115 = b1_110 * b2_67 + b1_114 - T(0.3) * b1_67 + b1_92 * b2_55 + b1_95 * b2_57 + b1_98 * b2_59 + b1_101 *
      b2_61 + b1_104 * b2_63 + b1_107 * b2_65 + b1_113 * b2_69;
  const T b1_116 = b1_115 * b1_70;
  const T b1_117 = T(0.366) + b1_74 * b1_12 + b1_77 * b1_16 + b1_80 * b1_20 + b1_83 * b1_24 + b1_86 * b1_28 + b1_89 *
      b1_32 + b1_92 * b1_37 + b1_95 * b1_41 + b1_98 * b1_45 + b1_101 * b1_49 + b1_104 * b1_53 + b1_107 * b1_57 +
      b1_110 * b1_61 + b1_113 * b1_65 + b1_116 * b1_69;
  const T b1_118 = T(1) / D_omegadot1_1;
  const T b1_119 = b1_117 * b1_118;
  const T D_omegadot1_2 = T(0.84575) - b1_74 * b1_73 - b1_77 * b1_76 - b1_80 * b1_79 - b1_83 * b1_82 - b1_86 * b1_85 -
      b1_89 * b1_88 - b1_92 * b1_91 - b1_95 * b1_94 - b1_98 * b1_97 - b1_101 * b1_100 - b1_104 * b1_103 - b1_107 *
      b1_106 - b1_110 * b1_109 - b1_113 * b1_112 - b1_116 * b1_115 - b1_119 * b1_117;
  const T b1_120 = T(0.3) * b1_11 - T(0.25) * b1_72;
  const T b1_121 = b1_120 * T(4.385964912280701);
  const T b1_122 = b1_121 * T(0.024000000000000004) + T(0.3) * b1_15 - T(0.25) * b1_75;
  const T b1_123 = b1_122 * T(4.773869346733668);
  const T b1_124 = b1_121 * T(0.003200000000000002) + T(0.3) * b1_19 - T(0.25) * b1_78 + b1_123 *
      T(0.02273684210526316);
  const T b1_125 = b1_124 * T(4.866483897725908);
  const T b1_126 = T(0.3) * b1_23 - T(0.25) * b1_81 + b1_121 * b5_9 + b1_123 * b5_13 + b1_125 * b5_17;
  const T b1_127 = b1_126 * b5_29;
  const T b1_128 = b1_127 * b5_28 + T(0.3) * b1_27 - T(0.25) * b1_84 + b1_121 * b5_20 + b1_123 * b5_23 + b1_125 *
      b5_26;
  const T b1_129 = b1_128 * b5_40;
  const T b1_130 = b1_127 * b5_37 + T(0.3) * b1_31 - T(0.25) * b1_87 + b1_121 * b5_31 + b1_123 * b5_33 + b1_125 *
      b5_35 + b1_129 * b5_39;
  const T b1_131 = b1_130 * b1_33;
  const T b1_132 = T(0.3) * b1_36 - b1_90;
  const T b1_133 = b1_132 * T(5.012531328320802);
  const T b1_134 = b1_133 * T(0.021) + T(0.3) * b1_40 - b1_93;
  const T b1_135 = b1_134 * T(5.455850681981335);
  const T b1_136 = b1_133 * T(0.0028000000000000004) + T(0.3) * b1_44 - b1_96 + b1_135 * T(0.019894736842105264);
  const T b1_137 = b1_136 * T(5.561695883115324);
  const T b1_138 = T(0.3) * b1_48 - b1_99;
  const T b1_139 = b1_138 * T(5.398110661268555);
  const T b1_140 = b1_139 * T(0.019500000000000003) + T(0.3) * b1_52 - b1_102;
  const T b1_141 = b1_140 * T(5.875531503672208);
  const T b1_142 = b1_139 * T(0.002600000000000001) + T(0.3) * b1_56 - b1_105 + b1_141 * T(0.01847368421052632);
  const T b1_143 = b1_142 * T(5.989518643354965);
  const T b1_144 = T(0.3) * b1_60 - b1_108 + b1_133 * b2_12 + b1_135 * b2_16 + b1_137 * b2_20 + b1_139 * b2_24 +
      b1_141 * b2_28 + b1_143 * b2_32;
  const T b1_145 = b1_144 * b2_53;
  const T b1_146 = b1_145 * b2_52 + T(0.3) * b1_64 - b1_111 + b1_133 * b2_35 + b1_135 * b2_38 + b1_137 * b2_41 +
      b1_139 * b2_44 + b1_141 * b2_47 + b1_143 * b2_50;
  const T b1_147 = b1_146 * b2_70;
  const T b1_148 = b1_145 * b2_67 + T(0.3) * b1_68 - b1_114 + b1_133 * b2_55 + b1_135 * b2_57 + b1_137 * b2_59 +
      b1_139 * b2_61 + b1_141 * b2_63 + b1_143 * b2_65 + b1_147 * b2_69;
  const T b1_149 = b1_148 * b1_70;
  const T b1_150 = T(0.2122) + b1_121 * b1_12 + b1_123 * b1_16 + b1_125 * b1_20 + b1_127 * b1_24 + b1_129 * b1_28 +
      b1_131 * b1_32 + b1_133 * b1_37 + b1_135 * b1_41 + b1_137 * b1_45 + b1_139 * b1_49 + b1_141 * b1_53 + b1_143 *
      b1_57 + b1_145 * b1_61 + b1_147 * b1_65 + b1_149 * b1_69;
  const T b1_151 = b1_150 * b1_118;
  const T b1_152 = T(0.13190000000000002) + b1_121 * b1_73 + b1_123 * b1_76 + b1_125 * b1_79 + b1_127 * b1_82 + b1_129
      * b1_85 + b1_131 * b1_88 + b1_133 * b1_91 + b1_135 * b1_94 + b1_137 * b1_97 + b1_139 * b1_100 + b1_141 * b1_103
      + b1_143 * b1_106 + b1_145 * b1_109 + b1_147 * b1_112 + b1_149 * b1_115 + b1_151 * b1_117;
  const T b1_153 = T(1) / D_omegadot1_2;
  const T b1_154 = b1_152 * b1_153;
  const T D_omegadot1_3 = T(1.00575) - b1_121 * b1_120 - b1_123 * b1_122 - b1_125 * b1_124 - b1_127 * b1_126 - b1_129
      * b1_128 - b1_131 * b1_130 - b1_133 * b1_132 - b1_135 * b1_134 - b1_137 * b1_136 - b1_139 * b1_138 - b1_141 *
      b1_140 - b1_143 * b1_142 - b1_145 * b1_144 - b1_147 * b1_146 - b1_149 * b1_148 - b1_151 * b1_150 - b1_154 *
      b1_152;
  // D_Pddot1: pivots of L D L^T
  const T b1_155 = R6_21 * T(0.08000000000000002) - R6_31 * T(0.32000000000000006);
  const T b1_156 = b1_155 * T(4.385964912280701);
  const T b1_157 = b1_156 * T(0.024000000000000004) + R6_31 * T(0.16000000000000003) - R6_11 * T(0.08000000000000002);
  const T b1_158 = b1_157 * T(4.773869346733668);
  const T b1_159 = b1_156 * T(0.003200000000000002) + R6_11 * T(0.32000000000000006) - R6_21 * T(0.16000000000000003)
      + b1_158 * T(0.02273684210526316);
  const T b1_160 = b1_159 * T(4.866483897725908);
  const T b1_161 = R5_21 * T(0.23500000000000001) - R5_31 * T(0.78) + b1_156 * b5_9 + b1_158 * b5_13 + b1_160 * b5_17;
  const T b1_162 = b1_161 * b5_29;
  const T b1_163 = b1_162 * b5_28 + R5_31 * T(0.63) - R5_11 * T(0.23500000000000001) + b1_156 * b5_20 + b1_158 * b5_23
      + b1_160 * b5_26;
  const T b1_164 = b1_163 * b5_40;
  const T b1_165 = b1_162 * b5_37 + R5_11 * T(0.78) - R5_21 * T(0.63) + b1_156 * b5_31 + b1_158 * b5_33 + b1_160 *
      b5_35 + b1_164 * b5_39;
  const T b1_166 = b1_165 * b1_33;
  const T b1_167 = R4_21 * T(0.06999999999999999) - R4_31 * T(0.27999999999999997);
  const T b1_168 = b1_167 * T(5.012531328320802);
  const T b1_169 = b1_168 * T(0.021) + R4_31 * T(0.13999999999999999) - R4_11 * T(0.06999999999999999);
  const T b1_170 = b1_169 * T(5.455850681981335);
  const T b1_171 = b1_168 * T(0.0028000000000000004) + R4_11 * T(0.27999999999999997) - R4_21 * T(0.13999999999999999)
      + b1_170 * T(0.019894736842105264);
  const T b1_172 = b1_171 * T(5.561695883115324);
  const T b1_173 = R3_21 * T(0.065) - R3_31 * T(0.26);
  const T b1_174 = b1_173 * T(5.398110661268555);
  const T b1_175 = b1_174 * T(0.019500000000000003) + R3_31 * T(0.13) - R3_11 * T(0.065);
  const T b1_176 = b1_175 * T(5.875531503672208);
  const T b1_177 = b1_174 * T(0.002600000000000001) + R3_11 * T(0.26) - R3_21 * T(0.13) + b1_176 *
      T(0.01847368421052632);
  const T b1_178 = b1_177 * T(5.989518643354965);
  const T b1_179 = R2_21 * T(0.33) - R2_31 * T(0.715) + b1_168 * b2_12 + b1_170 * b2_16 + b1_172 * b2_20 + b1_174 *
      b2_24 + b1_176 * b2_28 + b1_178 * b2_32;
  const T b1_180 = b1_179 * b2_53;
  const T b1_181 = b1_180 * b2_52 + R2_31 * T(0.9299999999999999) - R2_11 * T(0.33) + b1_168 * b2_35 + b1_170 * b2_38
      + b1_172 * b2_41 + b1_174 * b2_44 + b1_176 * b2_47 + b1_178 * b2_50;
  const T b1_182 = b1_181 * b2_70;
  const T b1_183 = b1_180 * b2_67 + R2_11 * T(0.715) - R2_21 * T(0.9299999999999999) + b1_168 * b2_55 + b1_170 * b2_57
      + b1_172 * b2_59 + b1_174 * b2_61 + b1_176 * b2_63 + b1_178 * b2_65 + b1_182 * b2_69;
  const T b1_184 = b1_183 * b1_70;
  const T b1_185 = T(1.385) * R1_31 - T(0.755) * R1_21 - b1_156 * b1_12 - b1_158 * b1_16 - b1_160 * b1_20 - b1_162 *
      b1_24 - b1_164 * b1_28 - b1_166 * b1_32 - b1_168 * b1_37 - b1_170 * b1_41 - b1_172 * b1_45 - b1_174 * b1_49 -
      b1_176 * b1_53 - b1_178 * b1_57 - b1_180 * b1_61 - b1_182 * b1_65 - b1_184 * b1_69;
  const T b1_186 = b1_185 * b1_118;
  const T b1_187 = T(0.755) * R1_11 - T(2.21) * R1_31 - b1_156 * b1_73 - b1_158 * b1_76 - b1_160 * b1_79 - b1_162 *
      b1_82 - b1_164 * b1_85 - b1_166 * b1_88 - b1_168 * b1_91 - b1_170 * b1_94 - b1_172 * b1_97 - b1_174 * b1_100 -
      b1_176 * b1_103 - b1_178 * b1_106 - b1_180 * b1_109 - b1_182 * b1_112 - b1_184 * b1_115 + b1_186 * b1_117;
  const T b1_188 = b1_187 * b1_153;
  const T b1_189 = T(2.21) * R1_21 - T(1.385) * R1_11 - b1_156 * b1_120 - b1_158 * b1_122 - b1_160 * b1_124 - b1_162 *
      b1_126 - b1_164 * b1_128 - b1_166 * b1_130 - b1_168 * b1_132 - b1_170 * b1_134 - b1_172 * b1_136 - b1_174 *
      b1_138 - b1_176 * b1_140 - b1_178 * b1_142 - b1_180 * b1_144 - b1_182 * b1_146 - b1_184 * b1_148 + b1_186 *
      b1_150 + b1_188 * b1_152;
  const T b1_190 = T(1) / D_omegadot1_3;
  const T b1_191 = b1_189 * b1_190;
  const T D_Pddot1_1 = T(8.1) - b1_156 * b1_155 - b1_158 * b1_157 - b1_160 * b1_159 - b1_162 * b1_161 - b1_164 *
      b1_163 - b1_166 * b1_165 - b1_168 * b1_167 - b1_170 * b1_169 - b1_172 * b1_171 - b1_174 * b1_173 - b1_176 *
      b1_175 - b1_178 * b1_177 - b1_180 * b1_179 - b1_182 * b1_181 - b1_184 * b1_183 - b1_186 * b1_185 - b1_188 *
      b1_187 - b1_191 * b1_189;
  const T b1_192 = R6_22 * T(0.08000000000000002) - R6_32 * T(0.32000000000000006);
  const T b1_193 = b1_192 * T(4.385964912280701);
  const T b1_194 = b1_193 * T(0.024000000000000004) + R6_32 * T(0.16000000000000003) - R6_12 * T(0.08000000000000002);
  const T b1_195 = b1_194 * T(4.773869346733668);
  const T b1_196 = b1_193 * T(0.003200000000000002) + R6_12 * T(0.32000000000000006) - R6_22 * T(0.16000000000000003)
      + b1_195 * T(0.02273684210526316);
  const T b1_197 = b1_196 * T(4.866483897725908);
  const T b1_198 = R5_22 * T(0.23500000000000001) - R5_32 * T(0.78) + b1_193 * b5_9 + b1_195 * b5_13 + b1_197 * b5_17;
  const T b1_199 = b1_198 * b5_29;
  const T b1_200 = b1_199 * b5_28 + R5_32 * T(0.63) - R5_12 * T(0.23500000000000001) + b1_193 * b5_20 + b1_195 * b5_23
      + b1_197 * b5_26;
  const T b1_201 = b1_200 * b5_40;
  const T b1_202 = b1_199 * b5_37 + R5_12 * T(0.78) - R5_22 * T(0.63) + b1_193 * b5_31 + b1_195 * b5_33 + b1_197 *
      b5_35 + b1_201 * b5_39;
  const T b1_203 = b1_202 * b1_33;
  const T b1_204 = R4_22 * T(0.06999999999999999) - R4_32 * T(0.27999999999999997);
  const T b1_205 = b1_204 * T(5.012531328320802);
  const T b1_206 = b1_205 * T(0.021) + R4_32 * T(0.13999999999999999) - R4_12 * T(0.06999999999999999);
  const T b1_207 = b1_206 * T(5.455850681981335);
  const T b1_208 = b1_205 * T(0.0028000000000000004) + R4_12 * T(0.27999999999999997) - R4_22 * T(0.13999999999999999)
      + b1_207 * T(0.019894736842105264);
  const T b1_209 = b1_208 * T(5.561695883115324);
  const T b1_210 = R3_22 * T(0.065) - R3_32 * T(0.26);
  const T b1_211 = b1_210 * T(5.398110661268555);
  const T b1_212 = b1_211 * T(0.019500000000000003) + R3_32 * T(0.13) - R3_12 * T(0.065);
  const T b1_213 = b1_212 * T(5.875531503672208);
  const T b1_214 = b1_211 * T(0.002600000000000001) + R3_12 * T(0.26) - R3_22 * T(0.13) + b1_213 *
      T(0.01847368421052632);
  const T b1_215 = b1_214 * T(5.989518643354965);
  const T b1_216 = R2_22 * T(0.33) - R2_32 * T(0.715) + b1_205 * b2_12 + b1_207 * b2_16 + b1_209 * b2_20 + b1_211 *
      b2_24 + b1_213 * b2_28 + b1_215 * b2_32;
  const T b1_217 = b1_216 * b2_53;
  const T b1_218 = b1_217 * b2_52 + R2_32 * T(0.9299999999999999) - R2_12 * T(0.33) + b1_205 * b2_35 + b1_207 * b2_38
      + b1_209 * b2_41 + b1_211 * b2_44 + b1_213 * b2_47 + b1_215 * b2_50;
  const T b1_219 = b1_218 * b2_70;
  const T b1_220 = b1_217 * b2_67 + R2_12 * T(0.715) - R2_22 * T(0.9299999999999999) + b1_205 * b2_55 + b1_207 * b2_57
      + b1_209 * b2_59 + b1_211 * b2_61 + b1_213 * b2_63 + b1_215 * b2_65 + b1_219 * b2_69;
  const T b1_221 = b1_220 * b1_70;
  const T b1_222 = T(1.385) * R1_32 - T(0.755) * R1_22 - b1_193 * b1_12 - b1_195 * b1_16 - b1_197 * b1_20 - b1_199 *
      b1_24 - b1_201 * b1_28 - b1_203 * b1_32 - b1_205 * b1_37 - b1_207 * b1_41 - b1_209 * b1_45 - b1_211 * b1_49 -
      b1_213 * b1_53 - b1_215 * b1_57 - b1_217 * b1_61 - b1_219 * b1_65 - b1_221 * b1_69;
  const T b1_223 = b1_222 * b1_118;
  const T b1_224 = T(0.755) * R1_12 - T(2.21) * R1_32 - b1_193 * b1_73 - b1_195 * b1_76 - b1_197 * b1_79 - b1_199 *
      b1_82 - b1_201 * b1_85 - b1_203 * b1_88 - b1_205 * b1_91 - b1_207 * b1_94 - b1_209 * b1_97 - b1_211 * b1_100 -
      b1_213 * b1_103 - b1_215 * b1_106 - b1_217 * b1_109 - b1_219 * b1_112 - b1_221 * b1_115 + b1_223 * b1_117;
  const T b1_225 = b1_224 * b1_153;
  const T b1_226 = T(2.21) * R1_22 - T(1.385) * R1_12 - b1_193 * b1_120 - b1_195 * b1_122 - b1_197 * b1_124 - b1_199 *
      b1_126 - b1_201 * b1_128 - b1_203 * b1_130 - b1_205 * b1_132 - b1_207 * b1_134 - b1_209 * b1_136 - b1_211 *
      b1_138 - b1_213 * b1_140 - b1_215 * b1_142 - b1_217 * b1_144 - b1_219 * b1_146 - b1_221 * b1_148 + b1_223 *
      b1_150 + b1_225 * b1_152;
  const T b1_227 = b1_226 * b1_190;
  const T b1_228 = b1_193 * b1_155 + b1_195 * b1_157 + b1_197 * b1_159 + b1_199 * b1_161 + b1_201 * b1_163 + b1_203 *
      b1_165 + b1_205 * b1_167 + b1_207 * b1_169 + b1_209 * b1_171 + b1_211 * b1_173 + b1_213 * b1_175 + b1_215 *
      b1_177 + b1_217 * b1_179 + b1_219 * b1_181 + b1_221 * b1_183 + b1_223 * b1_185 + b1_225 * b1_187 + b1_227 *
      b1_189;
  const T b1_229 = T(1) / D_Pddot1_1;
  const T b1_230 = b1_228 * b1_229;
  const T D_Pddot1_2 = T(8.1) - b1_193 * b1_192 - b1_195 * b1_194 - b1_197 * b1_196 - b1_199 * b1_198 - b1_201 *
      b1_200 - b1_203 * b1_202 - b1_205 * b1_204 - b1_207 * b1_206 - b1_209 * b1_208 - b1_211 * b1_210 - b1_213 *
      b1_212 - b1_215 * b1_214 - b1_217 * b1_216 - b1_219 * b1_218 - b1_221 * b1_220 - b1_223 * b1_222 - b1_225 *
      b1_224 - b1_227 * b1_226 - b1_230 * b1_228;
  const T b1_231 = R6_23 * T(0.08000000000000002) - R6_33 * T(0.32000000000000006);
  const T b1_232 = b1_231 * T(4.385964912280701);
  const T b1_233 = b1_232 * T(0.024000000000000004) + R6_33 * T(0.16000000000000003) - R6_13 * T(0.08000000000000002);
  const T b1_234 = b1_233 * T(4.773869346733668);
  const T b1_235 = b1_232 * T(0.003200000000000002) + R6_13 * T(0.32000000000000006) - R6_23 * T(0.16000000000000003)
      + b1_234 * T(0.02273684210526316);
  const T b1_236 = b1_235 * T(4.866483897725908);
  const T b1_237 = R5_23 * T(0.23500000000000001) - R5_33 * T(0.78) + b1_232 * b5_9 + b1_234 * b5_13 + b1_236 * b5_17;
  const T b1_238 = b1_237 * b5_29;
  const T b1_239 = b1_238 * b5_28 + R5_33 * T(0.63) - R5_13 * T(0.23500000000000001) + b1_232 * b5_20 + b1_234 * b5_23
      + b1_236 * b5_26;
  const T b1_240 = b1_239 * b5_40;
  const T b1_241 = b1_238 * b5_37 + R5_13 * T(0.78) - R5_23 * T(0.63) + b1_232 * b5_31 + b1_234 * b5_33 + b1_236 *
      b5_35 + b1_240 * b5_39;
  const T b1_242 = b1_241 * b1_33;
  const T b1_243 = R4_23 * T(0.06999999999999999) - R4_33 * T(0.27999999999999997);
  const T b1_244 = b1_243 * T(5.012531328320802);
  const T b1_245 = b1_244 * T(0.021) + R4_33 * T(0.13999999999999999) - R4_13 * T(0.06999999999999999);
  const T b1_246 = b1_245 * T(5.455850681981335);
  const T b1_247 = b1_244 * T(0.0028000000000000004) + R4_13 * T(0.27999999999999997) - R4_23 * T(0.13999999999999999)
      + b1_246 * T(0.019894736842105264);
  const T b1_248 = b1_247 * T(5.561695883115324);
  const T b1_249 = R3_23 * T(0.065) - R3_33 * T(0.26);
  const T b1_250 = b1_249 * T(5.398110661268555);
  const T b1_251 = b1_250 * T(0.019500000000000003) + R3_33 * T(0.13) - R3_13 * T(0.065);
  const T b1_252 = b1_251 * T(5.875531503672208);
  const T b1_253 = b1_250 * T(0.002600000000000001) + R3_13 * T(0.26) - R3_23 * T(0.13) + b1_252 *
      T(0.01847368421052632);
  const T b1_254 = b1_253 * T(5.989518643354965);
  const T b1_255 = R2_23 * T(0.33) - R2_33 * T(0.715) + b1_244 * b2_12 + b1_246 * b2_16 + b1_248 * b2_20 + b1_250 *
      b2_24 + b1_252 * b2_28 + b1_254 * b2_32;
  const T b1_256 = b1_255 * b2_53;
  const T b1_257 = b1_256 * b2_52 + R2_33 * T(0.9299999999999999) - R2_13 * T(0.33) + b1_244 * b2_35 + b1_246 * b2_38
      + b1_248 * b2_41 + b1_250 * b2_44 + b1_252 * b2_47 + b1_254 * b2_50;
  const T b1_258 = b1_257 * b2_70;
  const T b1_259 = b1_256 * b2_67 + R2_13 * T(0.715) - R2_23 * T(0.9299999999999999) + b1_244 * b2_55 + b1_246 * b2_57
      + b1_248 * b2_59 + b1_250 * b2_61 + b1_252 * b2_63 + b1_254 * b2_65 + b1_258 * b2_69;
  const T b1_260 = b1_259 * b1_70;
  const T b1_261 = T(1.385) * R1_33 - T(0.755) * R1_23 - b1_232 * b1_12 - b1_234 * b1_16 - b1_236 * b1_20 - b1_238 *
      b1_24 - b1_240 * b1_28 - b1_242 * b1_32 - b1_244 * b1_37 - b1_246 * b1_41 - b1_248 * b1_45 - b1_250 * b1_49 -
      b1_252 * b1_53 - b1_254 * b1_57 - b1_256 * b1_61 - b1_258 * b1_65 - b1_260 * b1_69;
  const T b1_262 = b1_261 * b1_118;
  const T b1_263 = T(0.755) * R1_13 - T(2.21) * R1_33 - b1_232 * b1_73 - b1_234 * b1_76 - b1_236 * b1_79 - b1_238 *
      b1_82 - b1_240 * b1_85 - b1_242 * b1_88 - b1_244 * b1_91 - b1_246 * b1_94 - b1_248 * b1_97 - b1_250 * b1_100 -
      b1_252 * b1_103 - b1_254 * b1_106 - b1_256 * b1_109 - b1_258 * b1_112 - b1_260 * b1_115 + b1_262 * b1_117;
  const T b1_264 = b1_263 * b1_153;
  const T b1_265 = T(2.21) * R1_23 - T(1.385) * R1_13 - b1_232 * b1_120 - b1_234 * b1_122 - b1_236 * b1_124 - b1_238 *
      b1_126 - b1_240 * b1_128 - b1_242 * b1_130 - b1_244 * b1_132 - b1_246 * b1_134 - b1_248 * b1_136 - b1_250 *
      b1_138 - b1_252 * b1_140 - b1_254 * b1_142 - b1_256 * b1_144 - b1_258 * b1_146 - b1_260 * b1_148 + b1_262 *
      b1_150 + b1_264 * b1_152;
  const T b1_266 = b1_265 * b1_190;
  const T b1_267 = b1_232 * b1_155 + b1_234 * b1_157 + b1_236 * b1_159 + b1_238 * b1_161 + b1_240 * b1_163 + b1_242 *
      b1_165 + b1_244 * b1_167 + b1_246 * b1_169 + b1_248 * b1_171 + b1_250 * b1_173 + b1_252 * b1_175 + b1_254 *
      b1_177 + b1_256 * b1_179 + b1_258 * b1_181 + b1_260 * b1_183 + b1_262 * b1_185 + b1_264 * b1_187 + b1_266 *
      b1_189;
  const T b1_268 = b1_267 * b1_229;
  const T b1_269 = b1_232 * b1_192 + b1_234 * b1_194 + b1_236 * b1_196 + b1_238 * b1_198 + b1_240 * b1_200 + b1_242 *
      b1_202 + b1_244 * b1_204 + b1_246 * b1_206 + b1_248 * b1_208 + b1_250 * b1_210 + b1_252 * b1_212 + b1_254 *
      b1_214 + b1_256 * b1_216 + b1_258 * b1_218 + b1_260 * b1_220 + b1_262 * b1_222 + b1_264 * b1_224 + b1_266 *
      b1_226 + b1_268 * b1_228;
  const T b1_270 = T(1) / D_Pddot1_2;
  const T b1_271 = b1_269 * b1_270;
  const T D_Pddot1_3 = T(8.1) - b1_232 * b1_231 - b1_234 * b1_233 - b1_236 * b1_235 - b1_238 * b1_237 - b1_240 *
      b1_239 - b1_242 * b1_241 - b1_244 * b1_243 - b1_246 * b1_245 - b1_248 * b1_247 - b1_250 * b1_249 - b1_252 *
      b1_251 - b1_254 * b1_253 - b1_256 * b1_255 - b1_258 * b1_257 - b1_260 * b1_259 - b1_262 * b1_261 - b1_264 *
      b1_263 - b1_266 * b1_265 - b1_268 * b1_267 - b1_271 * b1_269;

  // ---- body 1 (body_1), solved
  // Pddot1: from A ydot = f by elimination
  const T z1_1 = f_omega6_2 + T(0.10526315789473686) * f_omega6_1;
  const T z1_2 = f_omega6_3 + T(0.014035087719298253) * f_omega6_1 + T(0.1085427135678392) * z1_1;
  const T z1_3 = f_omega5_1 + b5_10 * f_omega6_1 + b5_14 * z1_1 + b5_18 * z1_2;
  const T z1_4 = f_omega5_2 + b5_21 * f_omega6_1 + b5_24 * z1_1 + b5_27 * z1_2 + b5_30 * z1_3;
  const T z1_5 = f_omega5_3 + b5_32 * f_omega6_1 + b5_34 * z1_1 + b5_36 * z1_2 + b5_38 * z1_3 + b5_41 * z1_4;
  const T z1_6 = f_omega4_2 + T(0.10526315789473684) * f_omega4_1;
  const T z1_7 = f_omega4_3 + T(0.014035087719298248) * f_omega4_1 + T(0.10854271356783919) * z1_6;
  const T z1_8 = f_omega3_2 + T(0.10526315789473685) * f_omega3_1;
  const T z1_9 = f_omega3_3 + T(0.014035087719298251) * f_omega3_1 + T(0.1085427135678392) * z1_8;
  const T z1_10 = f_omega2_1 + b2_13 * f_omega4_1 + b2_17 * z1_6 + b2_21 * z1_7 + b2_25 * f_omega3_1 + b2_29 * z1_8 +
      b2_33 * z1_9;
  const T z1_11 = f_omega2_2 + b2_36 * f_omega4_1 + b2_39 * z1_6 + b2_42 * z1_7 + b2_45 * f_omega3_1 + b2_48 * z1_8 +
      b2_51 * z1_9 + b2_54 * z1_10;
  const T z1_12 = f_omega2_3 + b2_56 * f_omega4_1 + b2_58 * z1_6 + b2_60 * z1_7 + b2_62 * f_omega3_1 + b2_64 * z1_8 +
      b2_66 * z1_9 + b2_68 * z1_10 + b2_71 * z1_11;
  const T z1_13 = f_omega1_1 + b1_13 * f_omega6_1 + b1_17 * z1_1 + b1_21 * z1_2 + b1_25 * z1_3 + b1_29 * z1_4 + b1_34
      * z1_5 + b1_38 * f_omega4_1 + b1_42 * z1_6 + b1_46 * z1_7 + b1_50 * f_omega3_1 + b1_54 * z1_8 + b1_58 * z1_9 +
      b1_62 * z1_10 + b1_66 * z1_11 + b1_71 * z1_12;
  const T z1_14 = f_omega1_2 + b1_74 * f_omega6_1 + b1_77 * z1_1 + b1_80 * z1_2 + b1_83 * z1_3 + b1_86 * z1_4 + b1_89
      * z1_5 + b1_92 * f_omega4_1 + b1_95 * z1_6 + b1_98 * z1_7 + b1_101 * f_omega3_1 + b1_104 * z1_8 + b1_107 * z1_9
      + b1_110 * z1_10 + b1_113 * z1_11 + b1_116 * z1_12 + b1_119 * z1_13;
  const T z1_15 = f_omega1_3 + b1_121 * f_omega6_1 + b1_123 * z1_1 + b1_125 * z1_2 + b1_127 * z1_3 + b1_129 * z1_4 +
      b1_131 * z1_5 + b1_133 * f_omega4_1 + b1_135 * z1_6 + b1_137 * z1_7 + b1_139 * f_omega3_1 + b1_141 * z1_8 +
      b1_143 * z1_9 + b1_145 * z1_10 + b1_147 * z1_11 + b1_149 * z1_12 + b1_151 * z1_13 + b1_154 * z1_14;
  const T z1_16 = S1_1 + b1_156 * f_omega6_1 + b1_158 * z1_1 + b1_160 * z1_2 + b1_162 * z1_3 + b1_164 * z1_4 + b1_166
      * z1_5 + b1_168 * f_omega4_1 + b1_170 * z1_6 + b1_172 * z1_7 + b1_174 * f_omega3_1 + b1_176 * z1_8 + b1_178 *
      z1_9 + b1_180 * z1_10 + b1_182 * z1_11 + b1_184 * z1_12 - b1_186 * z1_13 - b1_188 * z1_14 - b1_191 * z1_15;
  const T z1_17 = S1_2 + b1_193 * f_omega6_1 + b1_195 * z1_1 + b1_197 * z1_2 + b1_199 * z1_3 + b1_201 * z1_4 + b1_203
      * z1_5 + b1_205 * f_omega4_1 + b1_207 * z1_6 + b1_209 * z1_7 + b1_211 * f_omega3_1 + b1_213 * z1_8 + b1_215 *
      z1_9 + b1_217 * z1_10 + b1_219 * z1_11 + b1_221 * z1_12 - b1_223 * z1_13 - b1_225 * z1_14 - b1_227 * z1_15 +
      b1_230 * z1_16;
  const T z1_18 = T(1) / D_Pddot1_3 * (S1_3 + b1_232 * f_omega6_1 + b1_234 * z1_1 + b1_236 * z1_2 + b1_238 * z1_3 +
      b1_240 * z1_4 + b1_242 * z1_5 + b1_244 * f_omega4_1 + b1_246 * z1_6 + b1_248 * z1_7 + b1_250 * f_omega3_1 +
      b1_252 * z1_8 + b1_254 * z1_9 + b1_256 * z1_10 + b1_258 * z1_11 + b1_260 * z1_12 - b1_262 * z1_13 - b1_264 *
      z1_14 - b1_266 * z1_15 + b1_268 * z1_16 + b1_271 * z1_17);
  const T z1_19 = z1_17 * b1_270 + b1_271 * z1_18;
  const T Pddot1_1 = z1_16 * b1_229 + b1_230 * z1_19 + b1_268 * z1_18;
  ydot[18] = Pddot1_1;
  ydot[19] = z1_19;
  // omegadot1: from A ydot = f by elimination
  const T z1_20 = z1_15 * b1_190 - b1_191 * Pddot1_1 - b1_227 * z1_19 - b1_266 * z1_18;
  const T z1_21 = z1_14 * b1_153 + b1_154 * z1_20 - b1_188 * Pddot1_1 - b1_225 * z1_19 - b1_264 * z1_18;
  const T omegadot1_1 = z1_13 * b1_118 + b1_119 * z1_21 + b1_151 * z1_20 - b1_186 * Pddot1_1 - b1_223 * z1_19 - b1_262
      * z1_18;
  ydot[0] = omegadot1_1;
  ydot[1] = z1_21;
  ydot[2] = z1_20;
  // sddot1 = g + Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_3 = z1_18 - T(9.81);
  ydot[20] = sddot1_3;

  // ---- body 2 (body_2), solved
  // omegadot2: from A ydot = f by elimination
  const T z2_1 = z1_12 * b1_70 + b1_71 * omegadot1_1 + b1_116 * z1_21 + b1_149 * z1_20 + b1_184 * Pddot1_1 + b1_221 *
      z1_19 + b1_260 * z1_18;
  const T z2_2 = z1_11 * b2_70 + b2_71 * z2_1 + b1_66 * omegadot1_1 + b1_113 * z1_21 + b1_147 * z1_20 + b1_182 *
      Pddot1_1 + b1_219 * z1_19 + b1_258 * z1_18;
  const T omegadot2_1 = z1_10 * b2_53 + b2_54 * z2_2 + b2_68 * z2_1 + b1_62 * omegadot1_1 + b1_110 * z1_21 + b1_145 *
      z1_20 + b1_180 * Pddot1_1 + b1_217 * z1_19 + b1_256 * z1_18;
  ydot[3] = omegadot2_1;
  ydot[4] = z2_2;
  ydot[5] = z2_1;

  // ---- body 3 (body_3), solved
  // omegadot3: from A ydot = f by elimination
  const T z3_1 = z1_9 * T(5.989518643354965) + b2_33 * omegadot2_1 + b2_51 * z2_2 + b2_66 * z2_1 + b1_58 * omegadot1_1
      + b1_107 * z1_21 + b1_143 * z1_20 + b1_178 * Pddot1_1 + b1_215 * z1_19 + b1_254 * z1_18;
  const T z3_2 = z1_8 * T(5.875531503672208) + T(0.1085427135678392) * z3_1 + b2_29 * omegadot2_1 + b2_48 * z2_2 +
      b2_64 * z2_1 + b1_54 * omegadot1_1 + b1_104 * z1_21 + b1_141 * z1_20 + b1_176 * Pddot1_1 + b1_213 * z1_19 +
      b1_252 * z1_18;
  const T omegadot3_1 = f_omega3_1 * T(5.398110661268555) + T(0.10526315789473685) * z3_2 + T(0.014035087719298251) *
      z3_1 + b2_25 * omegadot2_1 + b2_45 * z2_2 + b2_62 * z2_1 + b1_50 * omegadot1_1 + b1_101 * z1_21 + b1_139 * z1_20
      + b1_174 * Pddot1_1 + b1_211 * z1_19 + b1_250 * z1_18;
  ydot[6] = omegadot3_1;
  ydot[7] = z3_2;
  ydot[8] = z3_1;

  // ---- body 4 (body_4), solved
  // omegadot4: from A ydot = f by elimination
  const T z4_1 = z1_7 * T(5.561695883115324) + b2_21 * omegadot2_1 + b2_42 * z2_2 + b2_60 * z2_1 + b1_46 * omegadot1_1
      + b1_98 * z1_21 + b1_137 * z1_20 + b1_172 * Pddot1_1 + b1_209 * z1_19 + b1_248 * z1_18;
  const T z4_2 = z1_6 * T(5.455850681981335) + T(0.10854271356783919) * z4_1 + b2_17 * omegadot2_1 + b2_39 * z2_2 +
      b2_58 * z2_1 + b1_42 * omegadot1_1 + b1_95 * z1_21 + b1_135 * z1_20 + b1_170 * Pddot1_1 + b1_207 * z1_19 +
      b1_246 * z1_18;
  const T omegadot4_1 = f_omega4_1 * T(5.012531328320802) + T(0.10526315789473684) * z4_2 + T(0.014035087719298248) *
      z4_1 + b2_13 * omegadot2_1 + b2_36 * z2_2 + b2_56 * z2_1 + b1_38 * omegadot1_1 + b1_92 * z1_21 + b1_133 * z1_20
      + b1_168 * Pddot1_1 + b1_205 * z1_19 + b1_244 * z1_18;
  ydot[9] = omegadot4_1;
  ydot[10] = z4_2;
  ydot[11] = z4_1;

  // ---- body 5 (body_5), solved
  // omegadot5: from A ydot = f by elimination
  const T z5_1 = z1_5 * b1_33 + b1_34 * omegadot1_1 + b1_89 * z1_21 + b1_131 * z1_20 + b1_166 * Pddot1_1 + b1_203 *
      z1_19 + b1_242 * z1_18;
  const T z5_2 = z1_4 * b5_40 + b5_41 * z5_1 + b1_29 * omegadot1_1 + b1_86 * z1_21 + b1_129 * z1_20 + b1_164 *
      Pddot1_1 + b1_201 * z1_19 + b1_240 * z1_18;
  const T omegadot5_1 = z1_3 * b5_29 + b5_30 * z5_2 + b5_38 * z5_1 + b1_25 * omegadot1_1 + b1_83 * z1_21 + b1_127 *
      z1_20 + b1_162 * Pddot1_1 + b1_199 * z1_19 + b1_238 * z1_18;
  ydot[12] = omegadot5_1;
  ydot[13] = z5_2;
  ydot[14] = z5_1;

  // ---- body 6 (body_6), solved
  // omegadot6: from A ydot = f by elimination
  const T z6_1 = z1_2 * T(4.866483897725908) + b5_18 * omegadot5_1 + b5_27 * z5_2 + b5_36 * z5_1 + b1_21 * omegadot1_1
      + b1_80 * z1_21 + b1_125 * z1_20 + b1_160 * Pddot1_1 + b1_197 * z1_19 + b1_236 * z1_18;
  const T z6_2 = z1_1 * T(4.773869346733668) + T(0.1085427135678392) * z6_1 + b5_14 * omegadot5_1 + b5_24 * z5_2 +
      b5_34 * z5_1 + b1_17 * omegadot1_1 + b1_77 * z1_21 + b1_123 * z1_20 + b1_158 * Pddot1_1 + b1_195 * z1_19 +
      b1_234 * z1_18;
  const T omegadot6_1 = f_omega6_1 * T(4.385964912280701) + T(0.10526315789473686) * z6_2 + T(0.014035087719298253) *
      z6_1 + b5_10 * omegadot5_1 + b5_21 * z5_2 + b5_32 * z5_1 + b1_13 * omegadot1_1 + b1_74 * z1_21 + b1_121 * z1_20
      + b1_156 * Pddot1_1 + b1_193 * z1_19 + b1_232 * z1_18;
  ydot[15] = omegadot6_1;
  ydot[16] = z6_2;
  ydot[17] = z6_1;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 613 add, 652 multiply
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
  const T t1_15 = omega1_1 * omega1_2;
  const T U1_12 = t1_15 - omegadot1_3;
  const T t1_16 = omega1_1 * omega1_3;
  const T U1_13 = t1_16 + omegadot1_2;
  const T U1_21 = t1_15 + omegadot1_3;
  const T t1_17 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_17;
  const T t1_18 = omega1_2 * omega1_3;
  const T U1_23 = t1_18 - omegadot1_1;
  const T U1_31 = t1_16 - omegadot1_2;
  const T U1_32 = t1_18 + omegadot1_1;
  const T minus_U1_33 = t1_14 + t1_17;
  // Pddot1 = -g + sddot1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T Pddot1_3 = sddot1_3 + T(9.81);
  // a1 = R1^T U1 r1 + Pddot1: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t1_19 = U1_12 * T(0.2) - minus_U1_11 * T(0.1) + U1_13 * T(0.05);
  const T t1_20 = U1_21 * T(0.1) - minus_U1_22 * T(0.2) + U1_23 * T(0.05);
  const T t1_21 = U1_31 * T(0.1) + U1_32 * T(0.2) - minus_U1_33 * T(0.05);
  const T a1_1 = R1_11 * t1_19 + R1_21 * t1_20 + R1_31 * t1_21 + sddot1_1;
  const T a1_2 = R1_12 * t1_19 + R1_22 * t1_20 + R1_32 * t1_21 + sddot1_2;
  const T a1_3 = R1_13 * t1_19 + R1_23 * t1_20 + R1_33 * t1_21 + Pddot1_3;
  // G1 = m1 a1 - F1: force balance, inertial axes [N]
  const T G1_1 = T(1.1) * a1_1 - u.F_1_1;
  const T G1_2 = T(1.1) * a1_2 - u.F_1_2;
  const T G1_3 = T(1.1) * a1_3 - u.F_1_3;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T omegadot2_1 = ydot[3], omegadot2_2 = ydot[4], omegadot2_3 = ydot[5];
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
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_13 = omega2_3 * omega2_3;
  const T t2_14 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_13 + t2_14;
  const T t2_15 = omega2_1 * omega2_2;
  const T U2_12 = t2_15 - omegadot2_3;
  const T t2_16 = omega2_1 * omega2_3;
  const T U2_13 = t2_16 + omegadot2_2;
  const T U2_21 = t2_15 + omegadot2_3;
  const T t2_17 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_13 + t2_17;
  const T t2_18 = omega2_2 * omega2_3;
  const T U2_23 = t2_18 - omegadot2_1;
  const T U2_31 = t2_16 - omegadot2_2;
  const T U2_32 = t2_18 + omegadot2_1;
  const T minus_U2_33 = t2_14 + t2_17;
  // Pddot2 = R1^T U1 q2 + Pddot1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t2_19 = minus_U1_11 * T(0.3) - U1_13 * T(0.1);
  const T t2_20 = U1_12 * T(0.1) - t2_19;
  const T t2_21 = U1_21 * T(0.3) + U1_23 * T(0.1);
  const T t2_22 = t2_21 - minus_U1_22 * T(0.1);
  const T t2_23 = U1_31 * T(0.3) - minus_U1_33 * T(0.1);
  const T t2_24 = t2_23 + U1_32 * T(0.1);
  const T Pddot2_1 = R1_11 * t2_20 + R1_21 * t2_22 + R1_31 * t2_24 + sddot1_1;
  const T Pddot2_2 = R1_12 * t2_20 + R1_22 * t2_22 + R1_32 * t2_24 + sddot1_2;
  const T Pddot2_3 = R1_13 * t2_20 + R1_23 * t2_22 + R1_33 * t2_24 + Pddot1_3;
  // a2 = R2^T U2 r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_25 = U2_12 * T(0.2);
  const T t2_26 = t2_25 - minus_U2_11 * T(0.1) + U2_13 * T(0.05);
  const T t2_27 = minus_U2_22 * T(0.2);
  const T t2_28 = U2_21 * T(0.1) - t2_27 + U2_23 * T(0.05);
  const T t2_29 = U2_32 * T(0.2);
  const T t2_30 = U2_31 * T(0.1) + t2_29 - minus_U2_33 * T(0.05);
  const T a2_1 = R2_11 * t2_26 + R2_21 * t2_28 + R2_31 * t2_30 + Pddot2_1;
  const T a2_2 = R2_12 * t2_26 + R2_22 * t2_28 + R2_32 * t2_30 + Pddot2_2;
  const T a2_3 = R2_13 * t2_26 + R2_23 * t2_28 + R2_33 * t2_30 + Pddot2_3;
  // G2 = m2 a2: force balance, inertial axes [N]
  const T G2_1 = T(1.2) * a2_1;
  const T G2_2 = T(1.2) * a2_2;
  const T G2_3 = T(1.2) * a2_3;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T omegadot3_1 = ydot[6], omegadot3_2 = ydot[7], omegadot3_3 = ydot[8];
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
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_13 = omega3_3 * omega3_3;
  const T t3_14 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_13 + t3_14;
  const T t3_15 = omega3_1 * omega3_2;
  const T U3_12 = t3_15 - omegadot3_3;
  const T t3_16 = omega3_1 * omega3_3;
  const T U3_13 = t3_16 + omegadot3_2;
  const T U3_21 = t3_15 + omegadot3_3;
  const T t3_17 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_13 + t3_17;
  const T t3_18 = omega3_2 * omega3_3;
  const T U3_23 = t3_18 - omegadot3_1;
  const T U3_31 = t3_16 - omegadot3_2;
  const T U3_32 = t3_18 + omegadot3_1;
  const T minus_U3_33 = t3_14 + t3_17;
  // Pddot3 = R2^T U2 q3 + Pddot2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t3_19 = minus_U2_11 * T(0.3) - U2_13 * T(0.1);
  const T t3_20 = U2_12 * T(0.15) - t3_19;
  const T t3_21 = U2_21 * T(0.3) + U2_23 * T(0.1);
  const T t3_22 = t3_21 - minus_U2_22 * T(0.15);
  const T t3_23 = U2_31 * T(0.3) - minus_U2_33 * T(0.1);
  const T t3_24 = t3_23 + U2_32 * T(0.15);
  const T Pddot3_1 = R2_11 * t3_20 + R2_21 * t3_22 + R2_31 * t3_24 + Pddot2_1;
  const T Pddot3_2 = R2_12 * t3_20 + R2_22 * t3_22 + R2_32 * t3_24 + Pddot2_2;
  const T Pddot3_3 = R2_13 * t3_20 + R2_23 * t3_22 + R2_33 * t3_24 + Pddot2_3;
  // a3 = R3^T U3 r3 + Pddot3: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t3_25 = U3_12 * T(0.2) - minus_U3_11 * T(0.1) + U3_13 * T(0.05);
  const T t3_26 = U3_21 * T(0.1) - minus_U3_22 * T(0.2) + U3_23 * T(0.05);
  const T t3_27 = U3_31 * T(0.1) + U3_32 * T(0.2) - minus_U3_33 * T(0.05);
  const T a3_1 = R3_11 * t3_25 + R3_21 * t3_26 + R3_31 * t3_27 + Pddot3_1;
  const T a3_2 = R3_12 * t3_25 + R3_22 * t3_26 + R3_32 * t3_27 + Pddot3_2;
  const T a3_3 = R3_13 * t3_25 + R3_23 * t3_26 + R3_33 * t3_27 + Pddot3_3;
  // G3 = m3 a3: force balance, inertial axes [N]
  const T G3_1 = T(1.3) * a3_1;
  const T G3_2 = T(1.3) * a3_2;
  const T G3_3 = T(1.3) * a3_3;
  // N3 = -M_torque_3_ + axial(U3 (tr(I3)/2 - I3)): moment balance about the mass centre, body axes [N m]
  const T N3_1 = T(0.039) * U3_32 - T(0.091) * U3_23 + T(0.0052) * (minus_U3_22 - minus_U3_33) - T(0.0065) * U3_31 +
      T(0.0039) * U3_21 - u.tau_3_1;
  const T N3_2 = T(0.091) * U3_13 - T(0.065) * U3_31 - T(0.0039) * (minus_U3_33 - minus_U3_11) + T(0.0052) * U3_12 +
      T(0.0065) * U3_32 - u.tau_3_2;
  const T N3_3 = T(0.065) * U3_21 - T(0.039) * U3_12 - T(0.0065) * (minus_U3_11 - minus_U3_22) - T(0.0039) * U3_23 -
      T(0.0052) * U3_13 - u.tau_3_3;

  // ---- body 4 (body_4) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T omegadot4_1 = ydot[9], omegadot4_2 = ydot[10], omegadot4_3 = ydot[11];
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
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_13 = omega4_3 * omega4_3;
  const T t4_14 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_13 + t4_14;
  const T t4_15 = omega4_1 * omega4_2;
  const T U4_12 = t4_15 - omegadot4_3;
  const T t4_16 = omega4_1 * omega4_3;
  const T U4_13 = t4_16 + omegadot4_2;
  const T U4_21 = t4_15 + omegadot4_3;
  const T t4_17 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_13 + t4_17;
  const T t4_18 = omega4_2 * omega4_3;
  const T U4_23 = t4_18 - omegadot4_1;
  const T U4_31 = t4_16 - omegadot4_2;
  const T U4_32 = t4_18 + omegadot4_1;
  const T minus_U4_33 = t4_14 + t4_17;
  // Pddot4 = R2^T U2 q4 + Pddot2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t4_19 = t2_25 - t3_19;
  const T t4_20 = t3_21 - t2_27;
  const T t4_21 = t3_23 + t2_29;
  const T Pddot4_1 = R2_11 * t4_19 + R2_21 * t4_20 + R2_31 * t4_21 + Pddot2_1;
  const T Pddot4_2 = R2_12 * t4_19 + R2_22 * t4_20 + R2_32 * t4_21 + Pddot2_2;
  const T Pddot4_3 = R2_13 * t4_19 + R2_23 * t4_20 + R2_33 * t4_21 + Pddot2_3;
  // N2 = R2 R3^T M_torque_3_ + R2 R4^T M_torque_4_ - M_torque_2_ + axial(U2 (tr(I2)/2 - I2)): moment balance about
  //   the mass centre, body axes [N m]
  const T t4_22 = R3_11 * u.tau_3_1 + R3_21 * u.tau_3_2 + R3_31 * u.tau_3_3;
  const T t4_23 = R3_12 * u.tau_3_1 + R3_22 * u.tau_3_2 + R3_32 * u.tau_3_3;
  const T t4_24 = R3_13 * u.tau_3_1 + R3_23 * u.tau_3_2 + R3_33 * u.tau_3_3;
  const T t4_25 = R4_11 * u.tau_4_1 + R4_21 * u.tau_4_2 + R4_31 * u.tau_4_3;
  const T t4_26 = R4_12 * u.tau_4_1 + R4_22 * u.tau_4_2 + R4_32 * u.tau_4_3;
  const T t4_27 = R4_13 * u.tau_4_1 + R4_23 * u.tau_4_2 + R4_33 * u.tau_4_3;
  const T N2_1 = R2_11 * t4_22 + R2_12 * t4_23 + R2_13 * t4_24 + R2_11 * t4_25 + R2_12 * t4_26 + R2_13 * t4_27 -
      u.tau_2_1 + T(0.036000000000000004) * U2_32 - T(0.08399999999999999) * U2_23 + T(0.0048) * (minus_U2_22 -
      minus_U2_33) - T(0.006) * U2_31 + T(0.0036) * U2_21;
  const T N2_2 = R2_21 * t4_22 + R2_22 * t4_23 + R2_23 * t4_24 + R2_21 * t4_25 + R2_22 * t4_26 + R2_23 * t4_27 -
      u.tau_2_2 + T(0.08399999999999999) * U2_13 - T(0.06) * U2_31 - T(0.0036) * (minus_U2_33 - minus_U2_11) +
      T(0.0048) * U2_12 + T(0.006) * U2_32;
  const T N2_3 = R2_31 * t4_22 + R2_32 * t4_23 + R2_33 * t4_24 + R2_31 * t4_25 + R2_32 * t4_26 + R2_33 * t4_27 -
      u.tau_2_3 + T(0.06) * U2_21 - T(0.036000000000000004) * U2_12 - T(0.006) * (minus_U2_11 - minus_U2_22) -
      T(0.0036) * U2_23 - T(0.0048) * U2_13;
  // a4 = R4^T U4 r4 + Pddot4: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t4_28 = U4_12 * T(0.2) - minus_U4_11 * T(0.1) + U4_13 * T(0.05);
  const T t4_29 = U4_21 * T(0.1) - minus_U4_22 * T(0.2) + U4_23 * T(0.05);
  const T t4_30 = U4_31 * T(0.1) + U4_32 * T(0.2) - minus_U4_33 * T(0.05);
  const T a4_1 = R4_11 * t4_28 + R4_21 * t4_29 + R4_31 * t4_30 + Pddot4_1;
  const T a4_2 = R4_12 * t4_28 + R4_22 * t4_29 + R4_32 * t4_30 + Pddot4_2;
  const T a4_3 = R4_13 * t4_28 + R4_23 * t4_29 + R4_33 * t4_30 + Pddot4_3;
  // G4 = m4 a4: force balance, inertial axes [N]
  const T G4_1 = T(1.4) * a4_1;
  const T G4_2 = T(1.4) * a4_2;
  const T G4_3 = T(1.4) * a4_3;
  // N4 = -M_torque_4_ + axial(U4 (tr(I4)/2 - I4)): moment balance about the mass centre, body axes [N m]
  const T N4_1 = T(0.042) * U4_32 - T(0.098) * U4_23 + T(0.0056) * (minus_U4_22 - minus_U4_33) - T(0.007) * U4_31 +
      T(0.0042) * U4_21 - u.tau_4_1;
  const T N4_2 = T(0.098) * U4_13 - T(0.07) * U4_31 - T(0.0042) * (minus_U4_33 - minus_U4_11) + T(0.0056) * U4_12 +
      T(0.007) * U4_32 - u.tau_4_2;
  const T N4_3 = T(0.07) * U4_21 - T(0.042) * U4_12 - T(0.007) * (minus_U4_11 - minus_U4_22) - T(0.0042) * U4_23 -
      T(0.0056) * U4_13 - u.tau_4_3;

  // ---- body 5 (body_5) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T omegadot5_1 = ydot[12], omegadot5_2 = ydot[13], omegadot5_3 = ydot[14];
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
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_13 = omega5_3 * omega5_3;
  const T t5_14 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_13 + t5_14;
  const T t5_15 = omega5_1 * omega5_2;
  const T U5_12 = t5_15 - omegadot5_3;
  const T t5_16 = omega5_1 * omega5_3;
  const T U5_13 = t5_16 + omegadot5_2;
  const T U5_21 = t5_15 + omegadot5_3;
  const T t5_17 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_13 + t5_17;
  const T t5_18 = omega5_2 * omega5_3;
  const T U5_23 = t5_18 - omegadot5_1;
  const T U5_31 = t5_16 - omegadot5_2;
  const T U5_32 = t5_18 + omegadot5_1;
  const T minus_U5_33 = t5_14 + t5_17;
  // Pddot5 = R1^T U1 q5 + Pddot1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t5_19 = U1_12 * T(0.25) - t2_19;
  const T t5_20 = t2_21 - minus_U1_22 * T(0.25);
  const T t5_21 = t2_23 + U1_32 * T(0.25);
  const T Pddot5_1 = R1_11 * t5_19 + R1_21 * t5_20 + R1_31 * t5_21 + sddot1_1;
  const T Pddot5_2 = R1_12 * t5_19 + R1_22 * t5_20 + R1_32 * t5_21 + sddot1_2;
  const T Pddot5_3 = R1_13 * t5_19 + R1_23 * t5_20 + R1_33 * t5_21 + Pddot1_3;
  // N1 = R1 R2^T M_torque_2_ + R1 R5^T M_torque_5_ - M1 + axial(U1 (tr(I1)/2 - I1)): moment balance about the mass
  //   centre, body axes [N m]
  const T t5_22 = R2_11 * u.tau_2_1 + R2_21 * u.tau_2_2 + R2_31 * u.tau_2_3;
  const T t5_23 = R2_12 * u.tau_2_1 + R2_22 * u.tau_2_2 + R2_32 * u.tau_2_3;
  const T t5_24 = R2_13 * u.tau_2_1 + R2_23 * u.tau_2_2 + R2_33 * u.tau_2_3;
  const T t5_25 = R5_11 * u.tau_5_1 + R5_21 * u.tau_5_2 + R5_31 * u.tau_5_3;
  const T t5_26 = R5_12 * u.tau_5_1 + R5_22 * u.tau_5_2 + R5_32 * u.tau_5_3;
  const T t5_27 = R5_13 * u.tau_5_1 + R5_23 * u.tau_5_2 + R5_33 * u.tau_5_3;
  const T N1_1 = R1_11 * t5_22 + R1_12 * t5_23 + R1_13 * t5_24 + R1_11 * t5_25 + R1_12 * t5_26 + R1_13 * t5_27 -
      u.M_1_1 + T(0.032999999999999995) * U1_32 - T(0.07700000000000001) * U1_23 + T(0.0044) * (minus_U1_22 -
      minus_U1_33) - T(0.0055) * U1_31 + T(0.0033) * U1_21;
  const T N1_2 = R1_21 * t5_22 + R1_22 * t5_23 + R1_23 * t5_24 + R1_21 * t5_25 + R1_22 * t5_26 + R1_23 * t5_27 -
      u.M_1_2 + T(0.07700000000000001) * U1_13 - T(0.055) * U1_31 - T(0.0033) * (minus_U1_33 - minus_U1_11) +
      T(0.0044) * U1_12 + T(0.0055) * U1_32;
  const T N1_3 = R1_31 * t5_22 + R1_32 * t5_23 + R1_33 * t5_24 + R1_31 * t5_25 + R1_32 * t5_26 + R1_33 * t5_27 -
      u.M_1_3 + T(0.055) * U1_21 - T(0.032999999999999995) * U1_12 - T(0.0055) * (minus_U1_11 - minus_U1_22) -
      T(0.0033) * U1_23 - T(0.0044) * U1_13;
  // a5 = R5^T U5 r5 + Pddot5: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t5_28 = U5_12 * T(0.2) - minus_U5_11 * T(0.1) + U5_13 * T(0.05);
  const T t5_29 = U5_21 * T(0.1) - minus_U5_22 * T(0.2) + U5_23 * T(0.05);
  const T t5_30 = U5_31 * T(0.1) + U5_32 * T(0.2) - minus_U5_33 * T(0.05);
  const T a5_1 = R5_11 * t5_28 + R5_21 * t5_29 + R5_31 * t5_30 + Pddot5_1;
  const T a5_2 = R5_12 * t5_28 + R5_22 * t5_29 + R5_32 * t5_30 + Pddot5_2;
  const T a5_3 = R5_13 * t5_28 + R5_23 * t5_29 + R5_33 * t5_30 + Pddot5_3;
  // G5 = m5 a5: force balance, inertial axes [N]
  const T G5_1 = T(1.5) * a5_1;
  const T G5_2 = T(1.5) * a5_2;
  const T G5_3 = T(1.5) * a5_3;

  // ---- body 6 (body_6) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T omegadot6_1 = ydot[15], omegadot6_2 = ydot[16], omegadot6_3 = ydot[17];
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
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_13 = omega6_3 * omega6_3;
  const T t6_14 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_13 + t6_14;
  const T t6_15 = omega6_1 * omega6_2;
  const T U6_12 = t6_15 - omegadot6_3;
  const T t6_16 = omega6_1 * omega6_3;
  const T U6_13 = t6_16 + omegadot6_2;
  const T U6_21 = t6_15 + omegadot6_3;
  const T t6_17 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_13 + t6_17;
  const T t6_18 = omega6_2 * omega6_3;
  const T U6_23 = t6_18 - omegadot6_1;
  const T U6_31 = t6_16 - omegadot6_2;
  const T U6_32 = t6_18 + omegadot6_1;
  const T minus_U6_33 = t6_14 + t6_17;
  // Pddot6 = R5^T U5 q6 + Pddot5: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t6_19 = U5_12 * T(0.3) - minus_U5_11 * T(0.3) + U5_13 * T(0.1);
  const T t6_20 = U5_21 * T(0.3) - minus_U5_22 * T(0.3) + U5_23 * T(0.1);
  const T t6_21 = U5_31 * T(0.3) + U5_32 * T(0.3) - minus_U5_33 * T(0.1);
  const T Pddot6_1 = R5_11 * t6_19 + R5_21 * t6_20 + R5_31 * t6_21 + Pddot5_1;
  const T Pddot6_2 = R5_12 * t6_19 + R5_22 * t6_20 + R5_32 * t6_21 + Pddot5_2;
  const T Pddot6_3 = R5_13 * t6_19 + R5_23 * t6_20 + R5_33 * t6_21 + Pddot5_3;
  // N5 = R5 R6^T M_torque_6_ - M_torque_5_ + axial(U5 (tr(I5)/2 - I5)): moment balance about the mass centre, body
  //   axes [N m]
  const T t6_22 = R6_11 * u.tau_6_1 + R6_21 * u.tau_6_2 + R6_31 * u.tau_6_3;
  const T t6_23 = R6_12 * u.tau_6_1 + R6_22 * u.tau_6_2 + R6_32 * u.tau_6_3;
  const T t6_24 = R6_13 * u.tau_6_1 + R6_23 * u.tau_6_2 + R6_33 * u.tau_6_3;
  const T N5_1 = R5_11 * t6_22 + R5_12 * t6_23 + R5_13 * t6_24 - u.tau_5_1 + T(0.045) * U5_32 - T(0.105) * U5_23 +
      T(0.006) * (minus_U5_22 - minus_U5_33) - T(0.0075) * U5_31 + T(0.0045) * U5_21;
  const T N5_2 = R5_21 * t6_22 + R5_22 * t6_23 + R5_23 * t6_24 - u.tau_5_2 + T(0.105) * U5_13 - T(0.075) * U5_31 -
      T(0.0045) * (minus_U5_33 - minus_U5_11) + T(0.006) * U5_12 + T(0.0075) * U5_32;
  const T N5_3 = R5_31 * t6_22 + R5_32 * t6_23 + R5_33 * t6_24 - u.tau_5_3 + T(0.075) * U5_21 - T(0.045) * U5_12 -
      T(0.0075) * (minus_U5_11 - minus_U5_22) - T(0.0045) * U5_23 - T(0.006) * U5_13;
  // a6 = R6^T U6 r6 + Pddot6: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t6_25 = U6_12 * T(0.2) - minus_U6_11 * T(0.1) + U6_13 * T(0.05);
  const T t6_26 = U6_21 * T(0.1) - minus_U6_22 * T(0.2) + U6_23 * T(0.05);
  const T t6_27 = U6_31 * T(0.1) + U6_32 * T(0.2) - minus_U6_33 * T(0.05);
  const T a6_1 = R6_11 * t6_25 + R6_21 * t6_26 + R6_31 * t6_27 + Pddot6_1;
  const T a6_2 = R6_12 * t6_25 + R6_22 * t6_26 + R6_32 * t6_27 + Pddot6_2;
  const T a6_3 = R6_13 * t6_25 + R6_23 * t6_26 + R6_33 * t6_27 + Pddot6_3;
  // G6 = m6 a6: force balance, inertial axes [N]
  const T G6_1 = T(1.6) * a6_1;
  const T G6_2 = T(1.6) * a6_2;
  const T G6_3 = T(1.6) * a6_3;
  // N6 = -M_torque_6_ + axial(U6 (tr(I6)/2 - I6)): moment balance about the mass centre, body axes [N m]
  const T N6_1 = T(0.048) * U6_32 - T(0.112) * U6_23 + T(0.0064) * (minus_U6_22 - minus_U6_33) - T(0.008) * U6_31 +
      T(0.0048) * U6_21 - u.tau_6_1;
  const T N6_2 = T(0.112) * U6_13 - T(0.08) * U6_31 - T(0.0048) * (minus_U6_33 - minus_U6_11) + T(0.0064) * U6_12 +
      T(0.008) * U6_32 - u.tau_6_2;
  const T N6_3 = T(0.08) * U6_21 - T(0.048) * U6_12 - T(0.008) * (minus_U6_11 - minus_U6_22) - T(0.0048) * U6_23 -
      T(0.0064) * U6_13 - u.tau_6_3;

  // ---- body 6 (body_6) and what it carries
  // r_omega6 = r6~ R6 G6 + N6: Kane's equation of omega [N m]
  const T b6_1 = R6_31 * G6_1 + R6_32 * G6_2 + R6_33 * G6_3;
  const T b6_2 = R6_21 * G6_1 + R6_22 * G6_2 + R6_23 * G6_3;
  const T r_omega6_1 = T(0.2) * b6_1 - T(0.05) * b6_2 + N6_1;
  const T b6_3 = R6_11 * G6_1 + R6_12 * G6_2 + R6_13 * G6_3;
  const T r_omega6_2 = T(0.05) * b6_3 - T(0.1) * b6_1 + N6_2;
  const T r_omega6_3 = T(0.1) * b6_2 - T(0.2) * b6_3 + N6_3;
  r[15] = r_omega6_1;
  r[16] = r_omega6_2;
  r[17] = r_omega6_3;

  // ---- body 5 (body_5) and what it carries
  // S5 = G5 + G6: sum of the force balances of the subtree, inertial axes [N]
  const T S5_1 = G5_1 + G6_1;
  const T S5_2 = G5_2 + G6_2;
  const T S5_3 = G5_3 + G6_3;
  // r_omega5 = q6~ R5 G6 + r5~ R5 G5 + N5: Kane's equation of omega [N m]
  const T b5_1 = T(0.3) * (R5_31 * G6_1 + R5_32 * G6_2 + R5_33 * G6_3);
  const T b5_2 = R5_21 * G6_1 + R5_22 * G6_2 + R5_23 * G6_3;
  const T b5_3 = R5_31 * G5_1 + R5_32 * G5_2 + R5_33 * G5_3;
  const T b5_4 = R5_21 * G5_1 + R5_22 * G5_2 + R5_23 * G5_3;
  const T r_omega5_1 = b5_1 - T(0.1) * b5_2 + T(0.2) * b5_3 - T(0.05) * b5_4 + N5_1;
  const T b5_5 = R5_11 * G6_1 + R5_12 * G6_2 + R5_13 * G6_3;
  const T b5_6 = R5_11 * G5_1 + R5_12 * G5_2 + R5_13 * G5_3;
  const T r_omega5_2 = T(0.1) * b5_5 - b5_1 + T(0.05) * b5_6 - T(0.1) * b5_3 + N5_2;
  const T r_omega5_3 = T(0.3) * b5_2 - T(0.3) * b5_5 + T(0.1) * b5_4 - T(0.2) * b5_6 + N5_3;
  r[12] = r_omega5_1;
  r[13] = r_omega5_2;
  r[14] = r_omega5_3;

  // ---- body 4 (body_4) and what it carries
  // r_omega4 = r4~ R4 G4 + N4: Kane's equation of omega [N m]
  const T b4_1 = R4_31 * G4_1 + R4_32 * G4_2 + R4_33 * G4_3;
  const T b4_2 = R4_21 * G4_1 + R4_22 * G4_2 + R4_23 * G4_3;
  const T r_omega4_1 = T(0.2) * b4_1 - T(0.05) * b4_2 + N4_1;
  const T b4_3 = R4_11 * G4_1 + R4_12 * G4_2 + R4_13 * G4_3;
  const T r_omega4_2 = T(0.05) * b4_3 - T(0.1) * b4_1 + N4_2;
  const T r_omega4_3 = T(0.1) * b4_2 - T(0.2) * b4_3 + N4_3;
  r[9] = r_omega4_1;
  r[10] = r_omega4_2;
  r[11] = r_omega4_3;

  // ---- body 3 (body_3) and what it carries
  // r_omega3 = r3~ R3 G3 + N3: Kane's equation of omega [N m]
  const T b3_1 = R3_31 * G3_1 + R3_32 * G3_2 + R3_33 * G3_3;
  const T b3_2 = R3_21 * G3_1 + R3_22 * G3_2 + R3_23 * G3_3;
  const T r_omega3_1 = T(0.2) * b3_1 - T(0.05) * b3_2 + N3_1;
  const T b3_3 = R3_11 * G3_1 + R3_12 * G3_2 + R3_13 * G3_3;
  const T r_omega3_2 = T(0.05) * b3_3 - T(0.1) * b3_1 + N3_2;
  const T r_omega3_3 = T(0.1) * b3_2 - T(0.2) * b3_3 + N3_3;
  r[6] = r_omega3_1;
  r[7] = r_omega3_2;
  r[8] = r_omega3_3;

  // ---- body 2 (body_2) and what it carries
  // S2 = G2 + G3 + G4: sum of the force balances of the subtree, inertial axes [N]
  const T S2_1 = G2_1 + G3_1 + G4_1;
  const T S2_2 = G2_2 + G3_2 + G4_2;
  const T S2_3 = G2_3 + G3_3 + G4_3;
  // r_omega2 = q3~ R2 G3 + q4~ R2 G4 + r2~ R2 G2 + N2: Kane's equation of omega [N m]
  const T b2_1 = R2_31 * G3_1 + R2_32 * G3_2 + R2_33 * G3_3;
  const T b2_2 = R2_21 * G3_1 + R2_22 * G3_2 + R2_23 * G3_3;
  const T b2_3 = R2_31 * G4_1 + R2_32 * G4_2 + R2_33 * G4_3;
  const T b2_4 = R2_21 * G4_1 + R2_22 * G4_2 + R2_23 * G4_3;
  const T b2_5 = R2_31 * G2_1 + R2_32 * G2_2 + R2_33 * G2_3;
  const T b2_6 = R2_21 * G2_1 + R2_22 * G2_2 + R2_23 * G2_3;
  const T r_omega2_1 = T(0.15) * b2_1 - T(0.1) * b2_2 + T(0.2) * b2_3 - T(0.1) * b2_4 + T(0.2) * b2_5 - T(0.05) * b2_6
      + N2_1;
  const T b2_7 = R2_11 * G3_1 + R2_12 * G3_2 + R2_13 * G3_3;
  const T b2_8 = R2_11 * G4_1 + R2_12 * G4_2 + R2_13 * G4_3;
  const T b2_9 = R2_11 * G2_1 + R2_12 * G2_2 + R2_13 * G2_3;
  const T r_omega2_2 = T(0.1) * b2_7 - T(0.3) * b2_1 + T(0.1) * b2_8 - T(0.3) * b2_3 + T(0.05) * b2_9 - T(0.1) * b2_5
      + N2_2;
  const T r_omega2_3 = T(0.3) * b2_2 - T(0.15) * b2_7 + T(0.3) * b2_4 - T(0.2) * b2_8 + T(0.1) * b2_6 - T(0.2) * b2_9
      + N2_3;
  r[3] = r_omega2_1;
  r[4] = r_omega2_2;
  r[5] = r_omega2_3;

  // ---- body 1 (body_1) and what it carries
  // S1 = G1 + S5 + S2: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = G1_1 + S5_1 + S2_1;
  const T S1_2 = G1_2 + S5_2 + S2_2;
  const T S1_3 = G1_3 + S5_3 + S2_3;
  r[18] = S1_1;
  r[19] = S1_2;
  r[20] = S1_3;
  // r_omega1 = q2~ R1 S2 + q5~ R1 S5 + r1~ R1 G1 + N1: Kane's equation of omega [N m]
  const T b1_1 = R1_31 * S2_1 + R1_32 * S2_2 + R1_33 * S2_3;
  const T b1_2 = R1_21 * S2_1 + R1_22 * S2_2 + R1_23 * S2_3;
  const T b1_3 = R1_31 * S5_1 + R1_32 * S5_2 + R1_33 * S5_3;
  const T b1_4 = R1_21 * S5_1 + R1_22 * S5_2 + R1_23 * S5_3;
  const T b1_5 = R1_31 * G1_1 + R1_32 * G1_2 + R1_33 * G1_3;
  const T b1_6 = R1_21 * G1_1 + R1_22 * G1_2 + R1_23 * G1_3;
  const T r_omega1_1 = T(0.1) * b1_1 - T(0.1) * b1_2 + T(0.25) * b1_3 - T(0.1) * b1_4 + T(0.2) * b1_5 - T(0.05) * b1_6
      + N1_1;
  const T b1_7 = T(0.1) * (R1_11 * S2_1 + R1_12 * S2_2 + R1_13 * S2_3);
  const T b1_8 = R1_11 * S5_1 + R1_12 * S5_2 + R1_13 * S5_3;
  const T b1_9 = R1_11 * G1_1 + R1_12 * G1_2 + R1_13 * G1_3;
  const T r_omega1_2 = b1_7 - T(0.3) * b1_1 + T(0.1) * b1_8 - T(0.3) * b1_3 + T(0.05) * b1_9 - T(0.1) * b1_5 + N1_2;
  const T r_omega1_3 = T(0.3) * b1_2 - b1_7 + T(0.3) * b1_4 - T(0.25) * b1_8 + T(0.1) * b1_6 - T(0.2) * b1_9 + N1_3;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 538 add, 662 multiply
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
  // a1 = R1^T omega1~ omega1~ r1 + Pddot1: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t1_13 = omega1_2 * T(0.1);
  const T t1_14 = omega1_1 * T(0.2) - t1_13;
  const T t1_15 = omega1_3 * T(0.1);
  const T t1_16 = t1_15 - omega1_1 * T(0.05);
  const T t1_17 = omega1_2 * t1_14 - omega1_3 * t1_16;
  const T t1_18 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T t1_19 = omega1_3 * t1_18 - omega1_1 * t1_14;
  const T t1_20 = omega1_1 * t1_16 - omega1_2 * t1_18;
  const T a1_1 = R1_11 * t1_17 + R1_21 * t1_19 + R1_31 * t1_20;
  const T a1_2 = R1_12 * t1_17 + R1_22 * t1_19 + R1_32 * t1_20;
  const T a1_3 = R1_13 * t1_17 + R1_23 * t1_19 + R1_33 * t1_20 + T(9.81);
  // G1 = -m1 a1 + F1: applied less inertia force at ydot = 0, inertial axes [N]
  const T G1_1 = u.F_1_1 - T(1.1) * a1_1;
  const T G1_2 = u.F_1_2 - T(1.1) * a1_2;
  const T G1_3 = u.F_1_3 - T(1.1) * a1_3;

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
  // Pddot2 = R1^T omega1~ omega1~ q2 + Pddot1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t2_13 = omega1_1 * T(0.1);
  const T t2_14 = omega1_2 * T(0.3);
  const T t2_15 = t2_13 - t2_14;
  const T t2_16 = omega1_3 * T(0.3) - t2_13;
  const T t2_17 = omega1_3 * t2_16;
  const T t2_18 = omega1_2 * t2_15 - t2_17;
  const T t2_19 = t1_13 - t1_15;
  const T t2_20 = omega1_3 * t2_19 - omega1_1 * t2_15;
  const T t2_21 = omega1_1 * t2_16;
  const T t2_22 = t2_21 - omega1_2 * t2_19;
  const T Pddot2_1 = R1_11 * t2_18 + R1_21 * t2_20 + R1_31 * t2_22;
  const T Pddot2_2 = R1_12 * t2_18 + R1_22 * t2_20 + R1_32 * t2_22;
  const T Pddot2_3 = R1_13 * t2_18 + R1_23 * t2_20 + R1_33 * t2_22 + T(9.81);
  // a2 = R2^T omega2~ omega2~ r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_23 = omega2_1 * T(0.2);
  const T t2_24 = omega2_2 * T(0.1);
  const T t2_25 = t2_23 - t2_24;
  const T t2_26 = omega2_3 * T(0.1) - omega2_1 * T(0.05);
  const T t2_27 = omega2_2 * t2_25 - omega2_3 * t2_26;
  const T t2_28 = omega2_3 * T(0.2);
  const T t2_29 = omega2_2 * T(0.05) - t2_28;
  const T t2_30 = omega2_3 * t2_29 - omega2_1 * t2_25;
  const T t2_31 = omega2_1 * t2_26 - omega2_2 * t2_29;
  const T a2_1 = R2_11 * t2_27 + R2_21 * t2_30 + R2_31 * t2_31 + Pddot2_1;
  const T a2_2 = R2_12 * t2_27 + R2_22 * t2_30 + R2_32 * t2_31 + Pddot2_2;
  const T a2_3 = R2_13 * t2_27 + R2_23 * t2_30 + R2_33 * t2_31 + Pddot2_3;
  // G2 = -m2 a2: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G2_1 = T(1.2) * a2_1;
  const T minus_G2_2 = T(1.2) * a2_2;
  const T minus_G2_3 = T(1.2) * a2_3;

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
  // Pddot3 = R2^T omega2~ omega2~ q3 + Pddot2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t3_13 = omega2_2 * T(0.3);
  const T t3_14 = omega2_1 * T(0.15) - t3_13;
  const T t3_15 = omega2_3 * T(0.3) - omega2_1 * T(0.1);
  const T t3_16 = omega2_3 * t3_15;
  const T t3_17 = omega2_2 * t3_14 - t3_16;
  const T t3_18 = t2_24 - omega2_3 * T(0.15);
  const T t3_19 = omega2_3 * t3_18 - omega2_1 * t3_14;
  const T t3_20 = omega2_1 * t3_15;
  const T t3_21 = t3_20 - omega2_2 * t3_18;
  const T Pddot3_1 = R2_11 * t3_17 + R2_21 * t3_19 + R2_31 * t3_21 + Pddot2_1;
  const T Pddot3_2 = R2_12 * t3_17 + R2_22 * t3_19 + R2_32 * t3_21 + Pddot2_2;
  const T Pddot3_3 = R2_13 * t3_17 + R2_23 * t3_19 + R2_33 * t3_21 + Pddot2_3;
  // a3 = R3^T omega3~ omega3~ r3 + Pddot3: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t3_22 = omega3_1 * T(0.2) - omega3_2 * T(0.1);
  const T t3_23 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_24 = omega3_2 * t3_22 - omega3_3 * t3_23;
  const T t3_25 = omega3_2 * T(0.05) - omega3_3 * T(0.2);
  const T t3_26 = omega3_3 * t3_25 - omega3_1 * t3_22;
  const T t3_27 = omega3_1 * t3_23 - omega3_2 * t3_25;
  const T a3_1 = R3_11 * t3_24 + R3_21 * t3_26 + R3_31 * t3_27 + Pddot3_1;
  const T a3_2 = R3_12 * t3_24 + R3_22 * t3_26 + R3_32 * t3_27 + Pddot3_2;
  const T a3_3 = R3_13 * t3_24 + R3_23 * t3_26 + R3_33 * t3_27 + Pddot3_3;
  // G3 = -m3 a3: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G3_1 = T(1.3) * a3_1;
  const T minus_G3_2 = T(1.3) * a3_2;
  const T minus_G3_3 = T(1.3) * a3_3;
  // N3 = -omega3~ I3 omega3 + M_torque_3_: applied less inertia moment at ydot = 0, body axes [N m]
  const T t3_28 = omega3_2 * omega3_3;
  const T t3_29 = omega3_2 * omega3_2;
  const T t3_30 = omega3_3 * omega3_3;
  const T t3_31 = omega3_1 * omega3_2;
  const T t3_32 = omega3_1 * omega3_3;
  const T N3_1 = T(0.052000000000000005) * t3_28 + T(0.0052) * (t3_29 - t3_30) - T(0.0039) * t3_31 + T(0.0065) * t3_32
      + u.tau_3_1;
  const T t3_33 = omega3_1 * omega3_1;
  const T N3_2 = u.tau_3_2 - (T(0.02600000000000001) * t3_32 + T(0.0039) * (t3_30 - t3_33) + T(0.0065) * t3_28 +
      T(0.0052) * t3_31);
  const T N3_3 = T(0.0052) * t3_32 - (T(0.025999999999999995) * t3_31 + T(0.0065) * (t3_33 - t3_29)) + T(0.0039) *
      t3_28 + u.tau_3_3;

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
  // Pddot4 = R2^T omega2~ omega2~ q4 + Pddot2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t4_13 = t2_23 - t3_13;
  const T t4_14 = omega2_2 * t4_13 - t3_16;
  const T t4_15 = t2_24 - t2_28;
  const T t4_16 = omega2_3 * t4_15 - omega2_1 * t4_13;
  const T t4_17 = t3_20 - omega2_2 * t4_15;
  const T Pddot4_1 = R2_11 * t4_14 + R2_21 * t4_16 + R2_31 * t4_17 + Pddot2_1;
  const T Pddot4_2 = R2_12 * t4_14 + R2_22 * t4_16 + R2_32 * t4_17 + Pddot2_2;
  const T Pddot4_3 = R2_13 * t4_14 + R2_23 * t4_16 + R2_33 * t4_17 + Pddot2_3;
  // N2 = -R2 R3^T M_torque_3_ - R2 R4^T M_torque_4_ - omega2~ I2 omega2 + M_torque_2_: applied less inertia moment at
  //   ydot = 0, body axes [N m]
  const T t4_18 = omega2_2 * omega2_3;
  const T t4_19 = R3_11 * u.tau_3_1 + R3_21 * u.tau_3_2 + R3_31 * u.tau_3_3;
  const T t4_20 = R3_12 * u.tau_3_1 + R3_22 * u.tau_3_2 + R3_32 * u.tau_3_3;
  const T t4_21 = R3_13 * u.tau_3_1 + R3_23 * u.tau_3_2 + R3_33 * u.tau_3_3;
  const T t4_22 = R4_11 * u.tau_4_1 + R4_21 * u.tau_4_2 + R4_31 * u.tau_4_3;
  const T t4_23 = R4_12 * u.tau_4_1 + R4_22 * u.tau_4_2 + R4_32 * u.tau_4_3;
  const T t4_24 = R4_13 * u.tau_4_1 + R4_23 * u.tau_4_2 + R4_33 * u.tau_4_3;
  const T t4_25 = omega2_2 * omega2_2;
  const T t4_26 = omega2_3 * omega2_3;
  const T t4_27 = omega2_1 * omega2_2;
  const T t4_28 = omega2_1 * omega2_3;
  const T N2_1 = T(0.04799999999999999) * t4_18 - (R2_11 * t4_19 + R2_12 * t4_20 + R2_13 * t4_21 + R2_11 * t4_22 +
      R2_12 * t4_23 + R2_13 * t4_24) + T(0.0048) * (t4_25 - t4_26) - T(0.0036) * t4_27 + T(0.006) * t4_28 + u.tau_2_1;
  const T t4_29 = omega2_1 * omega2_1;
  const T N2_2 = u.tau_2_2 - (R2_21 * t4_19 + R2_22 * t4_20 + R2_23 * t4_21 + R2_21 * t4_22 + R2_22 * t4_23 + R2_23 *
      t4_24 + T(0.023999999999999994) * t4_28 + T(0.0036) * (t4_26 - t4_29) + T(0.006) * t4_18 + T(0.0048) * t4_27);
  const T N2_3 = T(0.0048) * t4_28 - (R2_31 * t4_19 + R2_32 * t4_20 + R2_33 * t4_21 + R2_31 * t4_22 + R2_32 * t4_23 +
      R2_33 * t4_24 + T(0.023999999999999994) * t4_27 + T(0.006) * (t4_29 - t4_25)) + T(0.0036) * t4_18 + u.tau_2_3;
  // a4 = R4^T omega4~ omega4~ r4 + Pddot4: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t4_30 = omega4_1 * T(0.2) - omega4_2 * T(0.1);
  const T t4_31 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_32 = omega4_2 * t4_30 - omega4_3 * t4_31;
  const T t4_33 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_34 = omega4_3 * t4_33 - omega4_1 * t4_30;
  const T t4_35 = omega4_1 * t4_31 - omega4_2 * t4_33;
  const T a4_1 = R4_11 * t4_32 + R4_21 * t4_34 + R4_31 * t4_35 + Pddot4_1;
  const T a4_2 = R4_12 * t4_32 + R4_22 * t4_34 + R4_32 * t4_35 + Pddot4_2;
  const T a4_3 = R4_13 * t4_32 + R4_23 * t4_34 + R4_33 * t4_35 + Pddot4_3;
  // G4 = -m4 a4: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G4_1 = T(1.4) * a4_1;
  const T minus_G4_2 = T(1.4) * a4_2;
  const T minus_G4_3 = T(1.4) * a4_3;
  // N4 = -omega4~ I4 omega4 + M_torque_4_: applied less inertia moment at ydot = 0, body axes [N m]
  const T t4_36 = omega4_2 * omega4_3;
  const T t4_37 = omega4_2 * omega4_2;
  const T t4_38 = omega4_3 * omega4_3;
  const T t4_39 = omega4_1 * omega4_2;
  const T t4_40 = omega4_1 * omega4_3;
  const T N4_1 = T(0.05600000000000001) * t4_36 + T(0.0056) * (t4_37 - t4_38) - T(0.0042) * t4_39 + T(0.007) * t4_40 +
      u.tau_4_1;
  const T t4_41 = omega4_1 * omega4_1;
  const T N4_2 = u.tau_4_2 - (T(0.02800000000000001) * t4_40 + T(0.0042) * (t4_38 - t4_41) + T(0.007) * t4_36 +
      T(0.0056) * t4_39);
  const T N4_3 = T(0.0056) * t4_40 - (T(0.027999999999999997) * t4_39 + T(0.007) * (t4_41 - t4_37)) + T(0.0042) *
      t4_36 + u.tau_4_3;

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
  // Pddot5 = R1^T omega1~ omega1~ q5 + Pddot1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t5_13 = omega1_1 * T(0.25) - t2_14;
  const T t5_14 = omega1_2 * t5_13 - t2_17;
  const T t5_15 = t1_13 - omega1_3 * T(0.25);
  const T t5_16 = omega1_3 * t5_15 - omega1_1 * t5_13;
  const T t5_17 = t2_21 - omega1_2 * t5_15;
  const T Pddot5_1 = R1_11 * t5_14 + R1_21 * t5_16 + R1_31 * t5_17;
  const T Pddot5_2 = R1_12 * t5_14 + R1_22 * t5_16 + R1_32 * t5_17;
  const T Pddot5_3 = R1_13 * t5_14 + R1_23 * t5_16 + R1_33 * t5_17 + T(9.81);
  // N1 = -R1 R2^T M_torque_2_ - R1 R5^T M_torque_5_ - omega1~ I1 omega1 + M1: applied less inertia moment at ydot =
  //   0, body axes [N m]
  const T t5_18 = omega1_2 * omega1_3;
  const T t5_19 = R2_11 * u.tau_2_1 + R2_21 * u.tau_2_2 + R2_31 * u.tau_2_3;
  const T t5_20 = R2_12 * u.tau_2_1 + R2_22 * u.tau_2_2 + R2_32 * u.tau_2_3;
  const T t5_21 = R2_13 * u.tau_2_1 + R2_23 * u.tau_2_2 + R2_33 * u.tau_2_3;
  const T t5_22 = R5_11 * u.tau_5_1 + R5_21 * u.tau_5_2 + R5_31 * u.tau_5_3;
  const T t5_23 = R5_12 * u.tau_5_1 + R5_22 * u.tau_5_2 + R5_32 * u.tau_5_3;
  const T t5_24 = R5_13 * u.tau_5_1 + R5_23 * u.tau_5_2 + R5_33 * u.tau_5_3;
  const T t5_25 = omega1_2 * omega1_2;
  const T t5_26 = omega1_3 * omega1_3;
  const T t5_27 = omega1_1 * omega1_2;
  const T t5_28 = omega1_1 * omega1_3;
  const T N1_1 = T(0.04400000000000001) * t5_18 - (R1_11 * t5_19 + R1_12 * t5_20 + R1_13 * t5_21 + R1_11 * t5_22 +
      R1_12 * t5_23 + R1_13 * t5_24) + T(0.0044) * (t5_25 - t5_26) - T(0.0033) * t5_27 + T(0.0055) * t5_28 + u.M_1_1;
  const T t5_29 = omega1_1 * omega1_1;
  const T N1_2 = u.M_1_2 - (R1_21 * t5_19 + R1_22 * t5_20 + R1_23 * t5_21 + R1_21 * t5_22 + R1_22 * t5_23 + R1_23 *
      t5_24 + T(0.022000000000000006) * t5_28 + T(0.0033) * (t5_26 - t5_29) + T(0.0055) * t5_18 + T(0.0044) * t5_27);
  const T N1_3 = T(0.0044) * t5_28 - (R1_31 * t5_19 + R1_32 * t5_20 + R1_33 * t5_21 + R1_31 * t5_22 + R1_32 * t5_23 +
      R1_33 * t5_24 + T(0.022000000000000006) * t5_27 + T(0.0055) * (t5_29 - t5_25)) + T(0.0033) * t5_18 + u.M_1_3;
  // a5 = R5^T omega5~ omega5~ r5 + Pddot5: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t5_30 = omega5_2 * T(0.1);
  const T t5_31 = omega5_1 * T(0.2) - t5_30;
  const T t5_32 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_33 = omega5_2 * t5_31 - omega5_3 * t5_32;
  const T t5_34 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_35 = omega5_3 * t5_34 - omega5_1 * t5_31;
  const T t5_36 = omega5_1 * t5_32 - omega5_2 * t5_34;
  const T a5_1 = R5_11 * t5_33 + R5_21 * t5_35 + R5_31 * t5_36 + Pddot5_1;
  const T a5_2 = R5_12 * t5_33 + R5_22 * t5_35 + R5_32 * t5_36 + Pddot5_2;
  const T a5_3 = R5_13 * t5_33 + R5_23 * t5_35 + R5_33 * t5_36 + Pddot5_3;
  // G5 = -m5 a5: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G5_1 = T(1.5) * a5_1;
  const T minus_G5_2 = T(1.5) * a5_2;
  const T minus_G5_3 = T(1.5) * a5_3;

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
  // Pddot6 = R5^T omega5~ omega5~ q6 + Pddot5: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t6_13 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T t6_14 = omega5_3 * T(0.3);
  const T t6_15 = t6_14 - omega5_1 * T(0.1);
  const T t6_16 = omega5_2 * t6_13 - omega5_3 * t6_15;
  const T t6_17 = t5_30 - t6_14;
  const T t6_18 = omega5_3 * t6_17 - omega5_1 * t6_13;
  const T t6_19 = omega5_1 * t6_15 - omega5_2 * t6_17;
  const T Pddot6_1 = R5_11 * t6_16 + R5_21 * t6_18 + R5_31 * t6_19 + Pddot5_1;
  const T Pddot6_2 = R5_12 * t6_16 + R5_22 * t6_18 + R5_32 * t6_19 + Pddot5_2;
  const T Pddot6_3 = R5_13 * t6_16 + R5_23 * t6_18 + R5_33 * t6_19 + Pddot5_3;
  // N5 = -R5 R6^T M_torque_6_ - omega5~ I5 omega5 + M_torque_5_: applied less inertia moment at ydot = 0, body axes
  //   [N m]
  const T t6_20 = omega5_2 * omega5_3;
  const T t6_21 = R6_11 * u.tau_6_1 + R6_21 * u.tau_6_2 + R6_31 * u.tau_6_3;
  const T t6_22 = R6_12 * u.tau_6_1 + R6_22 * u.tau_6_2 + R6_32 * u.tau_6_3;
  const T t6_23 = R6_13 * u.tau_6_1 + R6_23 * u.tau_6_2 + R6_33 * u.tau_6_3;
  const T t6_24 = omega5_2 * omega5_2;
  const T t6_25 = omega5_3 * omega5_3;
  const T t6_26 = omega5_1 * omega5_2;
  const T t6_27 = omega5_1 * omega5_3;
  const T N5_1 = T(0.06) * t6_20 - (R5_11 * t6_21 + R5_12 * t6_22 + R5_13 * t6_23) + T(0.006) * (t6_24 - t6_25) -
      T(0.0045) * t6_26 + T(0.0075) * t6_27 + u.tau_5_1;
  const T t6_28 = omega5_1 * omega5_1;
  const T N5_2 = u.tau_5_2 - (R5_21 * t6_21 + R5_22 * t6_22 + R5_23 * t6_23 + T(0.03) * t6_27 + T(0.0045) * (t6_25 -
      t6_28) + T(0.0075) * t6_20 + T(0.006) * t6_26);
  const T N5_3 = T(0.006) * t6_27 - (R5_31 * t6_21 + R5_32 * t6_22 + R5_33 * t6_23 + T(0.03) * t6_26 + T(0.0075) *
      (t6_28 - t6_24)) + T(0.0045) * t6_20 + u.tau_5_3;
  // a6 = R6^T omega6~ omega6~ r6 + Pddot6: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t6_29 = omega6_1 * T(0.2) - omega6_2 * T(0.1);
  const T t6_30 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_31 = omega6_2 * t6_29 - omega6_3 * t6_30;
  const T t6_32 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_33 = omega6_3 * t6_32 - omega6_1 * t6_29;
  const T t6_34 = omega6_1 * t6_30 - omega6_2 * t6_32;
  const T a6_1 = R6_11 * t6_31 + R6_21 * t6_33 + R6_31 * t6_34 + Pddot6_1;
  const T a6_2 = R6_12 * t6_31 + R6_22 * t6_33 + R6_32 * t6_34 + Pddot6_2;
  const T a6_3 = R6_13 * t6_31 + R6_23 * t6_33 + R6_33 * t6_34 + Pddot6_3;
  // G6 = -m6 a6: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G6_1 = T(1.6) * a6_1;
  const T minus_G6_2 = T(1.6) * a6_2;
  const T minus_G6_3 = T(1.6) * a6_3;
  // N6 = -omega6~ I6 omega6 + M_torque_6_: applied less inertia moment at ydot = 0, body axes [N m]
  const T t6_35 = omega6_2 * omega6_3;
  const T t6_36 = omega6_2 * omega6_2;
  const T t6_37 = omega6_3 * omega6_3;
  const T t6_38 = omega6_1 * omega6_2;
  const T t6_39 = omega6_1 * omega6_3;
  const T N6_1 = T(0.064) * t6_35 + T(0.0064) * (t6_36 - t6_37) - T(0.0048) * t6_38 + T(0.008) * t6_39 + u.tau_6_1;
  const T t6_40 = omega6_1 * omega6_1;
  const T N6_2 = u.tau_6_2 - (T(0.032) * t6_39 + T(0.0048) * (t6_37 - t6_40) + T(0.008) * t6_35 + T(0.0064) * t6_38);
  const T N6_3 = T(0.0064) * t6_39 - (T(0.032) * t6_38 + T(0.008) * (t6_40 - t6_36)) + T(0.0048) * t6_35 + u.tau_6_3;

  // ---- body 6 (body_6) and what it carries
  // f_omega6 = r6~ R6 G6 + N6: Kane's equation of omega [N m]
  const T b6_1 = R6_21 * minus_G6_1 + R6_22 * minus_G6_2 + R6_23 * minus_G6_3;
  const T b6_2 = R6_31 * minus_G6_1 + R6_32 * minus_G6_2 + R6_33 * minus_G6_3;
  const T f_omega6_1 = T(0.05) * b6_1 - T(0.2) * b6_2 + N6_1;
  const T b6_3 = R6_11 * minus_G6_1 + R6_12 * minus_G6_2 + R6_13 * minus_G6_3;
  const T f_omega6_2 = T(0.1) * b6_2 - T(0.05) * b6_3 + N6_2;
  const T f_omega6_3 = T(0.2) * b6_3 - T(0.1) * b6_1 + N6_3;
  f[15] = f_omega6_1;
  f[16] = f_omega6_2;
  f[17] = f_omega6_3;

  // ---- body 5 (body_5) and what it carries
  // S5 = G5 + G6: sum of the force balances of the subtree, inertial axes [N]
  const T minus_S5_1 = minus_G5_1 + minus_G6_1;
  const T minus_S5_2 = minus_G5_2 + minus_G6_2;
  const T minus_S5_3 = minus_G5_3 + minus_G6_3;
  // f_omega5 = q6~ R5 G6 + r5~ R5 G5 + N5: Kane's equation of omega [N m]
  const T b5_1 = R5_21 * minus_G6_1 + R5_22 * minus_G6_2 + R5_23 * minus_G6_3;
  const T b5_2 = T(0.3) * (R5_31 * minus_G6_1 + R5_32 * minus_G6_2 + R5_33 * minus_G6_3);
  const T b5_3 = R5_21 * minus_G5_1 + R5_22 * minus_G5_2 + R5_23 * minus_G5_3;
  const T b5_4 = R5_31 * minus_G5_1 + R5_32 * minus_G5_2 + R5_33 * minus_G5_3;
  const T f_omega5_1 = T(0.1) * b5_1 - b5_2 + T(0.05) * b5_3 - T(0.2) * b5_4 + N5_1;
  const T b5_5 = R5_11 * minus_G6_1 + R5_12 * minus_G6_2 + R5_13 * minus_G6_3;
  const T b5_6 = R5_11 * minus_G5_1 + R5_12 * minus_G5_2 + R5_13 * minus_G5_3;
  const T f_omega5_2 = b5_2 - T(0.1) * b5_5 + T(0.1) * b5_4 - T(0.05) * b5_6 + N5_2;
  const T f_omega5_3 = T(0.3) * b5_5 - T(0.3) * b5_1 + T(0.2) * b5_6 - T(0.1) * b5_3 + N5_3;
  f[12] = f_omega5_1;
  f[13] = f_omega5_2;
  f[14] = f_omega5_3;

  // ---- body 4 (body_4) and what it carries
  // f_omega4 = r4~ R4 G4 + N4: Kane's equation of omega [N m]
  const T b4_1 = R4_21 * minus_G4_1 + R4_22 * minus_G4_2 + R4_23 * minus_G4_3;
  const T b4_2 = R4_31 * minus_G4_1 + R4_32 * minus_G4_2 + R4_33 * minus_G4_3;
  const T f_omega4_1 = T(0.05) * b4_1 - T(0.2) * b4_2 + N4_1;
  const T b4_3 = R4_11 * minus_G4_1 + R4_12 * minus_G4_2 + R4_13 * minus_G4_3;
  const T f_omega4_2 = T(0.1) * b4_2 - T(0.05) * b4_3 + N4_2;
  const T f_omega4_3 = T(0.2) * b4_3 - T(0.1) * b4_1 + N4_3;
  f[9] = f_omega4_1;
  f[10] = f_omega4_2;
  f[11] = f_omega4_3;

  // ---- body 3 (body_3) and what it carries
  // f_omega3 = r3~ R3 G3 + N3: Kane's equation of omega [N m]
  const T b3_1 = R3_21 * minus_G3_1 + R3_22 * minus_G3_2 + R3_23 * minus_G3_3;
  const T b3_2 = R3_31 * minus_G3_1 + R3_32 * minus_G3_2 + R3_33 * minus_G3_3;
  const T f_omega3_1 = T(0.05) * b3_1 - T(0.2) * b3_2 + N3_1;
  const T b3_3 = R3_11 * minus_G3_1 + R3_12 * minus_G3_2 + R3_13 * minus_G3_3;
  const T f_omega3_2 = T(0.1) * b3_2 - T(0.05) * b3_3 + N3_2;
  const T f_omega3_3 = T(0.2) * b3_3 - T(0.1) * b3_1 + N3_3;
  f[6] = f_omega3_1;
  f[7] = f_omega3_2;
  f[8] = f_omega3_3;

  // ---- body 2 (body_2) and what it carries
  // S2 = G2 + G3 + G4: sum of the force balances of the subtree, inertial axes [N]
  const T minus_S2_1 = minus_G2_1 + minus_G3_1 + minus_G4_1;
  const T minus_S2_2 = minus_G2_2 + minus_G3_2 + minus_G4_2;
  const T minus_S2_3 = minus_G2_3 + minus_G3_3 + minus_G4_3;
  // f_omega2 = q3~ R2 G3 + q4~ R2 G4 + r2~ R2 G2 + N2: Kane's equation of omega [N m]
  const T b2_1 = R2_21 * minus_G3_1 + R2_22 * minus_G3_2 + R2_23 * minus_G3_3;
  const T b2_2 = R2_31 * minus_G3_1 + R2_32 * minus_G3_2 + R2_33 * minus_G3_3;
  const T b2_3 = R2_21 * minus_G4_1 + R2_22 * minus_G4_2 + R2_23 * minus_G4_3;
  const T b2_4 = R2_31 * minus_G4_1 + R2_32 * minus_G4_2 + R2_33 * minus_G4_3;
  const T b2_5 = R2_21 * minus_G2_1 + R2_22 * minus_G2_2 + R2_23 * minus_G2_3;
  const T b2_6 = R2_31 * minus_G2_1 + R2_32 * minus_G2_2 + R2_33 * minus_G2_3;
  const T f_omega2_1 = T(0.1) * b2_1 - T(0.15) * b2_2 + T(0.1) * b2_3 - T(0.2) * b2_4 + T(0.05) * b2_5 - T(0.2) * b2_6
      + N2_1;
  const T b2_7 = R2_11 * minus_G3_1 + R2_12 * minus_G3_2 + R2_13 * minus_G3_3;
  const T b2_8 = R2_11 * minus_G4_1 + R2_12 * minus_G4_2 + R2_13 * minus_G4_3;
  const T b2_9 = R2_11 * minus_G2_1 + R2_12 * minus_G2_2 + R2_13 * minus_G2_3;
  const T f_omega2_2 = T(0.3) * b2_2 - T(0.1) * b2_7 + T(0.3) * b2_4 - T(0.1) * b2_8 + T(0.1) * b2_6 - T(0.05) * b2_9
      + N2_2;
  const T f_omega2_3 = T(0.15) * b2_7 - T(0.3) * b2_1 + T(0.2) * b2_8 - T(0.3) * b2_3 + T(0.2) * b2_9 - T(0.1) * b2_5
      + N2_3;
  f[3] = f_omega2_1;
  f[4] = f_omega2_2;
  f[5] = f_omega2_3;

  // ---- body 1 (body_1) and what it carries
  // S1 = G1 + S5 + S2: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = G1_1 - minus_S5_1 - minus_S2_1;
  const T S1_2 = G1_2 - minus_S5_2 - minus_S2_2;
  const T S1_3 = G1_3 - minus_S5_3 - minus_S2_3;
  f[18] = S1_1;
  f[19] = S1_2;
  f[20] = S1_3;
  // f_omega1 = q2~ R1 S2 + q5~ R1 S5 + r1~ R1 G1 + N1: Kane's equation of omega [N m]
  const T b1_1 = R1_21 * minus_S2_1 + R1_22 * minus_S2_2 + R1_23 * minus_S2_3;
  const T b1_2 = R1_31 * minus_S2_1 + R1_32 * minus_S2_2 + R1_33 * minus_S2_3;
  const T b1_3 = R1_21 * minus_S5_1 + R1_22 * minus_S5_2 + R1_23 * minus_S5_3;
  const T b1_4 = R1_31 * minus_S5_1 + R1_32 * minus_S5_2 + R1_33 * minus_S5_3;
  const T b1_5 = R1_31 * G1_1 + R1_32 * G1_2 + R1_33 * G1_3;
  const T b1_6 = R1_21 * G1_1 + R1_22 * G1_2 + R1_23 * G1_3;
  const T f_omega1_1 = T(0.1) * b1_1 - T(0.1) * b1_2 + T(0.1) * b1_3 - T(0.25) * b1_4 + T(0.2) * b1_5 - T(0.05) * b1_6
      + N1_1;
  const T b1_7 = T(0.1) * (R1_11 * minus_S2_1 + R1_12 * minus_S2_2 + R1_13 * minus_S2_3);
  const T b1_8 = R1_11 * minus_S5_1 + R1_12 * minus_S5_2 + R1_13 * minus_S5_3;
  const T b1_9 = R1_11 * G1_1 + R1_12 * G1_2 + R1_13 * G1_3;
  const T f_omega1_2 = T(0.3) * b1_2 - b1_7 + T(0.3) * b1_4 - T(0.1) * b1_8 + T(0.05) * b1_9 - T(0.1) * b1_5 + N1_2;
  const T f_omega1_3 = b1_7 - T(0.3) * b1_1 + T(0.25) * b1_8 - T(0.3) * b1_3 + T(0.1) * b1_6 - T(0.2) * b1_9 + N1_3;
  f[0] = f_omega1_1;
  f[1] = f_omega1_2;
  f[2] = f_omega1_3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 408 add, 672 multiply
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
  // C1_2 = R1 R2^T: takes components in the body to those in body 1
  const T C1_2_11 = R1_11 * R2_11 + R1_12 * R2_12 + R1_13 * R2_13;
  const T C1_2_12 = R1_11 * R2_21 + R1_12 * R2_22 + R1_13 * R2_23;
  const T C1_2_13 = R1_11 * R2_31 + R1_12 * R2_32 + R1_13 * R2_33;
  const T C1_2_21 = R1_21 * R2_11 + R1_22 * R2_12 + R1_23 * R2_13;
  const T C1_2_22 = R1_21 * R2_21 + R1_22 * R2_22 + R1_23 * R2_23;
  const T C1_2_23 = R1_21 * R2_31 + R1_22 * R2_32 + R1_23 * R2_33;
  const T C1_2_31 = R1_31 * R2_11 + R1_32 * R2_12 + R1_33 * R2_13;
  const T C1_2_32 = R1_31 * R2_21 + R1_32 * R2_22 + R1_33 * R2_23;
  const T C1_2_33 = R1_31 * R2_31 + R1_32 * R2_32 + R1_33 * R2_33;

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
  // C2_3 = R2 R3^T: takes components in the body to those in body 2
  const T C2_3_11 = R2_11 * R3_11 + R2_12 * R3_12 + R2_13 * R3_13;
  const T C2_3_12 = R2_11 * R3_21 + R2_12 * R3_22 + R2_13 * R3_23;
  const T C2_3_13 = R2_11 * R3_31 + R2_12 * R3_32 + R2_13 * R3_33;
  const T C2_3_21 = R2_21 * R3_11 + R2_22 * R3_12 + R2_23 * R3_13;
  const T C2_3_22 = R2_21 * R3_21 + R2_22 * R3_22 + R2_23 * R3_23;
  const T C2_3_23 = R2_21 * R3_31 + R2_22 * R3_32 + R2_23 * R3_33;
  const T C2_3_31 = R2_31 * R3_11 + R2_32 * R3_12 + R2_33 * R3_13;
  const T C2_3_32 = R2_31 * R3_21 + R2_32 * R3_22 + R2_33 * R3_23;
  const T C2_3_33 = R2_31 * R3_31 + R2_32 * R3_32 + R2_33 * R3_33;
  // C1_3 = R1 R3^T: takes components in the body to those in body 1
  const T C1_3_11 = R1_11 * R3_11 + R1_12 * R3_12 + R1_13 * R3_13;
  const T C1_3_12 = R1_11 * R3_21 + R1_12 * R3_22 + R1_13 * R3_23;
  const T C1_3_13 = R1_11 * R3_31 + R1_12 * R3_32 + R1_13 * R3_33;
  const T C1_3_21 = R1_21 * R3_11 + R1_22 * R3_12 + R1_23 * R3_13;
  const T C1_3_22 = R1_21 * R3_21 + R1_22 * R3_22 + R1_23 * R3_23;
  const T C1_3_23 = R1_21 * R3_31 + R1_22 * R3_32 + R1_23 * R3_33;
  const T C1_3_31 = R1_31 * R3_11 + R1_32 * R3_12 + R1_33 * R3_13;
  const T C1_3_32 = R1_31 * R3_21 + R1_32 * R3_22 + R1_33 * R3_23;
  const T C1_3_33 = R1_31 * R3_31 + R1_32 * R3_32 + R1_33 * R3_33;

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
  // C2_4 = R2 R4^T: takes components in the body to those in body 2
  const T C2_4_11 = R2_11 * R4_11 + R2_12 * R4_12 + R2_13 * R4_13;
  const T C2_4_12 = R2_11 * R4_21 + R2_12 * R4_22 + R2_13 * R4_23;
  const T C2_4_13 = R2_11 * R4_31 + R2_12 * R4_32 + R2_13 * R4_33;
  const T C2_4_21 = R2_21 * R4_11 + R2_22 * R4_12 + R2_23 * R4_13;
  const T C2_4_22 = R2_21 * R4_21 + R2_22 * R4_22 + R2_23 * R4_23;
  const T C2_4_23 = R2_21 * R4_31 + R2_22 * R4_32 + R2_23 * R4_33;
  const T C2_4_31 = R2_31 * R4_11 + R2_32 * R4_12 + R2_33 * R4_13;
  const T C2_4_32 = R2_31 * R4_21 + R2_32 * R4_22 + R2_33 * R4_23;
  const T C2_4_33 = R2_31 * R4_31 + R2_32 * R4_32 + R2_33 * R4_33;
  // C1_4 = R1 R4^T: takes components in the body to those in body 1
  const T C1_4_11 = R1_11 * R4_11 + R1_12 * R4_12 + R1_13 * R4_13;
  const T C1_4_12 = R1_11 * R4_21 + R1_12 * R4_22 + R1_13 * R4_23;
  const T C1_4_13 = R1_11 * R4_31 + R1_12 * R4_32 + R1_13 * R4_33;
  const T C1_4_21 = R1_21 * R4_11 + R1_22 * R4_12 + R1_23 * R4_13;
  const T C1_4_22 = R1_21 * R4_21 + R1_22 * R4_22 + R1_23 * R4_23;
  const T C1_4_23 = R1_21 * R4_31 + R1_22 * R4_32 + R1_23 * R4_33;
  const T C1_4_31 = R1_31 * R4_11 + R1_32 * R4_12 + R1_33 * R4_13;
  const T C1_4_32 = R1_31 * R4_21 + R1_32 * R4_22 + R1_33 * R4_23;
  const T C1_4_33 = R1_31 * R4_31 + R1_32 * R4_32 + R1_33 * R4_33;

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
  // C1_5 = R1 R5^T: takes components in the body to those in body 1
  const T C1_5_11 = R1_11 * R5_11 + R1_12 * R5_12 + R1_13 * R5_13;
  const T C1_5_12 = R1_11 * R5_21 + R1_12 * R5_22 + R1_13 * R5_23;
  const T C1_5_13 = R1_11 * R5_31 + R1_12 * R5_32 + R1_13 * R5_33;
  const T C1_5_21 = R1_21 * R5_11 + R1_22 * R5_12 + R1_23 * R5_13;
  const T C1_5_22 = R1_21 * R5_21 + R1_22 * R5_22 + R1_23 * R5_23;
  const T C1_5_23 = R1_21 * R5_31 + R1_22 * R5_32 + R1_23 * R5_33;
  const T C1_5_31 = R1_31 * R5_11 + R1_32 * R5_12 + R1_33 * R5_13;
  const T C1_5_32 = R1_31 * R5_21 + R1_32 * R5_22 + R1_33 * R5_23;
  const T C1_5_33 = R1_31 * R5_31 + R1_32 * R5_32 + R1_33 * R5_33;

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
  // C5_6 = R5 R6^T: takes components in the body to those in body 5
  const T C5_6_11 = R5_11 * R6_11 + R5_12 * R6_12 + R5_13 * R6_13;
  const T C5_6_12 = R5_11 * R6_21 + R5_12 * R6_22 + R5_13 * R6_23;
  const T C5_6_13 = R5_11 * R6_31 + R5_12 * R6_32 + R5_13 * R6_33;
  const T C5_6_21 = R5_21 * R6_11 + R5_22 * R6_12 + R5_23 * R6_13;
  const T C5_6_22 = R5_21 * R6_21 + R5_22 * R6_22 + R5_23 * R6_23;
  const T C5_6_23 = R5_21 * R6_31 + R5_22 * R6_32 + R5_23 * R6_33;
  const T C5_6_31 = R5_31 * R6_11 + R5_32 * R6_12 + R5_33 * R6_13;
  const T C5_6_32 = R5_31 * R6_21 + R5_32 * R6_22 + R5_33 * R6_23;
  const T C5_6_33 = R5_31 * R6_31 + R5_32 * R6_32 + R5_33 * R6_33;
  // C1_6 = R1 R6^T: takes components in the body to those in body 1
  const T C1_6_11 = R1_11 * R6_11 + R1_12 * R6_12 + R1_13 * R6_13;
  const T C1_6_12 = R1_11 * R6_21 + R1_12 * R6_22 + R1_13 * R6_23;
  const T C1_6_13 = R1_11 * R6_31 + R1_12 * R6_32 + R1_13 * R6_33;
  const T C1_6_21 = R1_21 * R6_11 + R1_22 * R6_12 + R1_23 * R6_13;
  const T C1_6_22 = R1_21 * R6_21 + R1_22 * R6_22 + R1_23 * R6_23;
  const T C1_6_23 = R1_21 * R6_31 + R1_22 * R6_32 + R1_23 * R6_33;
  const T C1_6_31 = R1_31 * R6_11 + R1_32 * R6_12 + R1_33 * R6_13;
  const T C1_6_32 = R1_31 * R6_21 + R1_32 * R6_22 + R1_33 * R6_23;
  const T C1_6_33 = R1_31 * R6_31 + R1_32 * R6_32 + R1_33 * R6_33;

  // ---- results
  A[0] = T(0.4595);
  A[1] = -T(0.366);
  A[21] = -T(0.366);
  A[2] = -T(0.2122);
  A[42] = -T(0.2122);
  const T t1 = C1_2_32 * T(0.33) - C1_2_33 * T(0.715);
  const T t2 = C1_2_22 * T(0.33) - C1_2_23 * T(0.715);
  const T t3 = T(0.1) * t1 - T(0.1) * t2;
  A[3] = -t3;
  A[63] = -t3;
  const T t4 = C1_2_33 * T(0.9299999999999999) - C1_2_31 * T(0.33);
  const T t5 = C1_2_23 * T(0.9299999999999999) - C1_2_21 * T(0.33);
  const T t6 = T(0.1) * t4 - T(0.1) * t5;
  A[4] = -t6;
  A[84] = -t6;
  const T t7 = C1_2_31 * T(0.715) - C1_2_32 * T(0.9299999999999999);
  const T t8 = C1_2_21 * T(0.715) - C1_2_22 * T(0.9299999999999999);
  const T t9 = T(0.1) * t7 - T(0.1) * t8;
  A[5] = -t9;
  A[105] = -t9;
  const T t10 = C1_3_32 * T(0.065) - C1_3_33 * T(0.26);
  const T t11 = C1_3_22 * T(0.065) - C1_3_23 * T(0.26);
  const T t12 = T(0.1) * t10 - T(0.1) * t11;
  A[6] = -t12;
  A[126] = -t12;
  const T t13 = C1_3_33 * T(0.13) - C1_3_31 * T(0.065);
  const T t14 = C1_3_23 * T(0.13) - C1_3_21 * T(0.065);
  const T t15 = T(0.1) * t13 - T(0.1) * t14;
  A[7] = -t15;
  A[147] = -t15;
  const T t16 = C1_3_31 * T(0.26) - C1_3_32 * T(0.13);
  const T t17 = C1_3_21 * T(0.26) - C1_3_22 * T(0.13);
  const T t18 = T(0.1) * t16 - T(0.1) * t17;
  A[8] = -t18;
  A[168] = -t18;
  const T t19 = C1_4_32 * T(0.06999999999999999) - C1_4_33 * T(0.27999999999999997);
  const T t20 = C1_4_22 * T(0.06999999999999999) - C1_4_23 * T(0.27999999999999997);
  const T t21 = T(0.1) * t19 - T(0.1) * t20;
  A[9] = -t21;
  A[189] = -t21;
  const T t22 = C1_4_33 * T(0.13999999999999999) - C1_4_31 * T(0.06999999999999999);
  const T t23 = C1_4_23 * T(0.13999999999999999) - C1_4_21 * T(0.06999999999999999);
  const T t24 = T(0.1) * t22 - T(0.1) * t23;
  A[10] = -t24;
  A[210] = -t24;
  const T t25 = C1_4_31 * T(0.27999999999999997) - C1_4_32 * T(0.13999999999999999);
  const T t26 = C1_4_21 * T(0.27999999999999997) - C1_4_22 * T(0.13999999999999999);
  const T t27 = T(0.1) * t25 - T(0.1) * t26;
  A[11] = -t27;
  A[231] = -t27;
  const T t28 = C1_5_32 * T(0.23500000000000001) - C1_5_33 * T(0.78);
  const T t29 = C1_5_22 * T(0.23500000000000001) - C1_5_23 * T(0.78);
  const T t30 = T(0.25) * t28 - T(0.1) * t29;
  A[12] = -t30;
  A[252] = -t30;
  const T t31 = C1_5_33 * T(0.63) - C1_5_31 * T(0.23500000000000001);
  const T t32 = C1_5_23 * T(0.63) - C1_5_21 * T(0.23500000000000001);
  const T t33 = T(0.25) * t31 - T(0.1) * t32;
  A[13] = -t33;
  A[273] = -t33;
  const T t34 = C1_5_31 * T(0.78) - C1_5_32 * T(0.63);
  const T t35 = C1_5_21 * T(0.78) - C1_5_22 * T(0.63);
  const T t36 = T(0.25) * t34 - T(0.1) * t35;
  A[14] = -t36;
  A[294] = -t36;
  const T t37 = C1_6_32 * T(0.08000000000000002) - C1_6_33 * T(0.32000000000000006);
  const T t38 = C1_6_22 * T(0.08000000000000002) - C1_6_23 * T(0.32000000000000006);
  const T t39 = T(0.25) * t37 - T(0.1) * t38;
  A[15] = -t39;
  A[315] = -t39;
  const T t40 = C1_6_33 * T(0.16000000000000003) - C1_6_31 * T(0.08000000000000002);
  const T t41 = C1_6_23 * T(0.16000000000000003) - C1_6_21 * T(0.08000000000000002);
  const T t42 = T(0.25) * t40 - T(0.1) * t41;
  A[16] = -t42;
  A[336] = -t42;
  const T t43 = C1_6_31 * T(0.32000000000000006) - C1_6_32 * T(0.16000000000000003);
  const T t44 = C1_6_21 * T(0.32000000000000006) - C1_6_22 * T(0.16000000000000003);
  const T t45 = T(0.25) * t43 - T(0.1) * t44;
  A[17] = -t45;
  A[357] = -t45;
  const T t46 = T(1.385) * R1_31 - T(0.755) * R1_21;
  A[18] = t46;
  A[378] = t46;
  const T t47 = T(1.385) * R1_32 - T(0.755) * R1_22;
  A[19] = t47;
  A[399] = t47;
  const T t48 = T(1.385) * R1_33 - T(0.755) * R1_23;
  A[20] = t48;
  A[420] = t48;
  A[22] = T(0.84575);
  A[23] = -T(0.13190000000000002);
  A[43] = -T(0.13190000000000002);
  const T t49 = T(0.1) * (C1_2_12 * T(0.33) - C1_2_13 * T(0.715));
  const T t50 = t49 - T(0.3) * t1;
  A[24] = -t50;
  A[64] = -t50;
  const T t51 = T(0.1) * (C1_2_13 * T(0.9299999999999999) - C1_2_11 * T(0.33));
  const T t52 = t51 - T(0.3) * t4;
  A[25] = -t52;
  A[85] = -t52;
  const T t53 = T(0.1) * (C1_2_11 * T(0.715) - C1_2_12 * T(0.9299999999999999));
  const T t54 = t53 - T(0.3) * t7;
  A[26] = -t54;
  A[106] = -t54;
  const T t55 = T(0.1) * (C1_3_12 * T(0.065) - C1_3_13 * T(0.26));
  const T t56 = t55 - T(0.3) * t10;
  A[27] = -t56;
  A[127] = -t56;
  const T t57 = T(0.1) * (C1_3_13 * T(0.13) - C1_3_11 * T(0.065));
  const T t58 = t57 - T(0.3) * t13;
  A[28] = -t58;
  A[148] = -t58;
  const T t59 = T(0.1) * (C1_3_11 * T(0.26) - C1_3_12 * T(0.13));
  const T t60 = t59 - T(0.3) * t16;
  A[29] = -t60;
  A[169] = -t60;
  const T t61 = T(0.1) * (C1_4_12 * T(0.06999999999999999) - C1_4_13 * T(0.27999999999999997));
  const T t62 = t61 - T(0.3) * t19;
  A[30] = -t62;
  A[190] = -t62;
  const T t63 = T(0.1) * (C1_4_13 * T(0.13999999999999999) - C1_4_11 * T(0.06999999999999999));
  const T t64 = t63 - T(0.3) * t22;
  A[31] = -t64;
  A[211] = -t64;
  const T t65 = T(0.1) * (C1_4_11 * T(0.27999999999999997) - C1_4_12 * T(0.13999999999999999));
  const T t66 = t65 - T(0.3) * t25;
  A[32] = -t66;
  A[232] = -t66;
  const T t67 = C1_5_12 * T(0.23500000000000001) - C1_5_13 * T(0.78);
  const T t68 = T(0.1) * t67 - T(0.3) * t28;
  A[33] = -t68;
  A[253] = -t68;
  const T t69 = C1_5_13 * T(0.63) - C1_5_11 * T(0.23500000000000001);
  const T t70 = T(0.1) * t69 - T(0.3) * t31;
  A[34] = -t70;
  A[274] = -t70;
  const T t71 = C1_5_11 * T(0.78) - C1_5_12 * T(0.63);
  const T t72 = T(0.1) * t71 - T(0.3) * t34;
  A[35] = -t72;
  A[295] = -t72;
  const T t73 = C1_6_12 * T(0.08000000000000002) - C1_6_13 * T(0.32000000000000006);
  const T t74 = T(0.1) * t73 - T(0.3) * t37;
  A[36] = -t74;
  A[316] = -t74;
  const T t75 = C1_6_13 * T(0.16000000000000003) - C1_6_11 * T(0.08000000000000002);
  const T t76 = T(0.1) * t75 - T(0.3) * t40;
  A[37] = -t76;
  A[337] = -t76;
  const T t77 = C1_6_11 * T(0.32000000000000006) - C1_6_12 * T(0.16000000000000003);
  const T t78 = T(0.1) * t77 - T(0.3) * t43;
  A[38] = -t78;
  A[358] = -t78;
  const T t79 = T(0.755) * R1_11 - T(2.21) * R1_31;
  A[39] = t79;
  A[379] = t79;
  const T t80 = T(0.755) * R1_12 - T(2.21) * R1_32;
  A[40] = t80;
  A[400] = t80;
  const T t81 = T(0.755) * R1_13 - T(2.21) * R1_33;
  A[41] = t81;
  A[421] = t81;
  A[44] = T(1.00575);
  const T t82 = T(0.3) * t2 - t49;
  A[45] = -t82;
  A[65] = -t82;
  const T t83 = T(0.3) * t5 - t51;
  A[46] = -t83;
  A[86] = -t83;
  const T t84 = T(0.3) * t8 - t53;
  A[47] = -t84;
  A[107] = -t84;
  const T t85 = T(0.3) * t11 - t55;
  A[48] = -t85;
  A[128] = -t85;
  const T t86 = T(0.3) * t14 - t57;
  A[49] = -t86;
  A[149] = -t86;
  const T t87 = T(0.3) * t17 - t59;
  A[50] = -t87;
  A[170] = -t87;
  const T t88 = T(0.3) * t20 - t61;
  A[51] = -t88;
  A[191] = -t88;
  const T t89 = T(0.3) * t23 - t63;
  A[52] = -t89;
  A[212] = -t89;
  const T t90 = T(0.3) * t26 - t65;
  A[53] = -t90;
  A[233] = -t90;
  const T t91 = T(0.3) * t29 - T(0.25) * t67;
  A[54] = -t91;
  A[254] = -t91;
  const T t92 = T(0.3) * t32 - T(0.25) * t69;
  A[55] = -t92;
  A[275] = -t92;
  const T t93 = T(0.3) * t35 - T(0.25) * t71;
  A[56] = -t93;
  A[296] = -t93;
  const T t94 = T(0.3) * t38 - T(0.25) * t73;
  A[57] = -t94;
  A[317] = -t94;
  const T t95 = T(0.3) * t41 - T(0.25) * t75;
  A[58] = -t95;
  A[338] = -t95;
  const T t96 = T(0.3) * t44 - T(0.25) * t77;
  A[59] = -t96;
  A[359] = -t96;
  const T t97 = T(2.21) * R1_21 - T(1.385) * R1_11;
  A[60] = t97;
  A[380] = t97;
  const T t98 = T(2.21) * R1_22 - T(1.385) * R1_12;
  A[61] = t98;
  A[401] = t98;
  const T t99 = T(2.21) * R1_23 - T(1.385) * R1_13;
  A[62] = t99;
  A[422] = t99;
  A[66] = T(0.28325);
  A[67] = -T(0.1605);
  A[87] = -T(0.1605);
  A[68] = -T(0.0834);
  A[108] = -T(0.0834);
  const T t100 = C2_3_32 * T(0.065) - C2_3_33 * T(0.26);
  const T t101 = C2_3_22 * T(0.065) - C2_3_23 * T(0.26);
  const T t102 = T(0.15) * t100 - T(0.1) * t101;
  A[69] = -t102;
  A[129] = -t102;
  const T t103 = C2_3_33 * T(0.13) - C2_3_31 * T(0.065);
  const T t104 = C2_3_23 * T(0.13) - C2_3_21 * T(0.065);
  const T t105 = T(0.15) * t103 - T(0.1) * t104;
  A[70] = -t105;
  A[150] = -t105;
  const T t106 = C2_3_31 * T(0.26) - C2_3_32 * T(0.13);
  const T t107 = C2_3_21 * T(0.26) - C2_3_22 * T(0.13);
  const T t108 = T(0.15) * t106 - T(0.1) * t107;
  A[71] = -t108;
  A[171] = -t108;
  const T t109 = C2_4_32 * T(0.06999999999999999) - C2_4_33 * T(0.27999999999999997);
  const T t110 = C2_4_22 * T(0.06999999999999999) - C2_4_23 * T(0.27999999999999997);
  const T t111 = T(0.2) * t109 - T(0.1) * t110;
  A[72] = -t111;
  A[192] = -t111;
  const T t112 = C2_4_33 * T(0.13999999999999999) - C2_4_31 * T(0.06999999999999999);
  const T t113 = C2_4_23 * T(0.13999999999999999) - C2_4_21 * T(0.06999999999999999);
  const T t114 = T(0.2) * t112 - T(0.1) * t113;
  A[73] = -t114;
  A[213] = -t114;
  const T t115 = C2_4_31 * T(0.27999999999999997) - C2_4_32 * T(0.13999999999999999);
  const T t116 = C2_4_21 * T(0.27999999999999997) - C2_4_22 * T(0.13999999999999999);
  const T t117 = T(0.2) * t115 - T(0.1) * t116;
  A[74] = -t117;
  A[234] = -t117;
  const T t118 = R2_21 * T(0.33) - R2_31 * T(0.715);
  A[81] = -t118;
  A[381] = -t118;
  const T t119 = R2_22 * T(0.33) - R2_32 * T(0.715);
  A[82] = -t119;
  A[402] = -t119;
  const T t120 = R2_23 * T(0.33) - R2_33 * T(0.715);
  A[83] = -t120;
  A[423] = -t120;
  A[88] = T(0.429);
  A[89] = -T(0.0643);
  A[109] = -T(0.0643);
  const T t121 = C2_3_12 * T(0.065) - C2_3_13 * T(0.26);
  const T t122 = T(0.1) * t121 - T(0.3) * t100;
  A[90] = -t122;
  A[130] = -t122;
  const T t123 = C2_3_13 * T(0.13) - C2_3_11 * T(0.065);
  const T t124 = T(0.1) * t123 - T(0.3) * t103;
  A[91] = -t124;
  A[151] = -t124;
  const T t125 = C2_3_11 * T(0.26) - C2_3_12 * T(0.13);
  const T t126 = T(0.1) * t125 - T(0.3) * t106;
  A[92] = -t126;
  A[172] = -t126;
  const T t127 = C2_4_12 * T(0.06999999999999999) - C2_4_13 * T(0.27999999999999997);
  const T t128 = T(0.1) * t127 - T(0.3) * t109;
  A[93] = -t128;
  A[193] = -t128;
  const T t129 = C2_4_13 * T(0.13999999999999999) - C2_4_11 * T(0.06999999999999999);
  const T t130 = T(0.1) * t129 - T(0.3) * t112;
  A[94] = -t130;
  A[214] = -t130;
  const T t131 = C2_4_11 * T(0.27999999999999997) - C2_4_12 * T(0.13999999999999999);
  const T t132 = T(0.1) * t131 - T(0.3) * t115;
  A[95] = -t132;
  A[235] = -t132;
  const T t133 = R2_31 * T(0.9299999999999999) - R2_11 * T(0.33);
  A[102] = -t133;
  A[382] = -t133;
  const T t134 = R2_32 * T(0.9299999999999999) - R2_12 * T(0.33);
  A[103] = -t134;
  A[403] = -t134;
  const T t135 = R2_33 * T(0.9299999999999999) - R2_13 * T(0.33);
  A[104] = -t135;
  A[424] = -t135;
  A[110] = T(0.48424999999999996);
  const T t136 = T(0.3) * t101 - T(0.15) * t121;
  A[111] = -t136;
  A[131] = -t136;
  const T t137 = T(0.3) * t104 - T(0.15) * t123;
  A[112] = -t137;
  A[152] = -t137;
  const T t138 = T(0.3) * t107 - T(0.15) * t125;
  A[113] = -t138;
  A[173] = -t138;
  const T t139 = T(0.3) * t110 - T(0.2) * t127;
  A[114] = -t139;
  A[194] = -t139;
  const T t140 = T(0.3) * t113 - T(0.2) * t129;
  A[115] = -t140;
  A[215] = -t140;
  const T t141 = T(0.3) * t116 - T(0.2) * t131;
  A[116] = -t141;
  A[236] = -t141;
  const T t142 = R2_11 * T(0.715) - R2_21 * T(0.9299999999999999);
  A[123] = -t142;
  A[383] = -t142;
  const T t143 = R2_12 * T(0.715) - R2_22 * T(0.9299999999999999);
  A[124] = -t143;
  A[404] = -t143;
  const T t144 = R2_13 * T(0.715) - R2_23 * T(0.9299999999999999);
  A[125] = -t144;
  A[425] = -t144;
  A[132] = T(0.18525000000000003);
  A[133] = -T(0.019500000000000003);
  A[153] = -T(0.019500000000000003);
  A[134] = -T(0.002600000000000001);
  A[174] = -T(0.002600000000000001);
  const T t145 = R3_21 * T(0.065) - R3_31 * T(0.26);
  A[144] = -t145;
  A[384] = -t145;
  const T t146 = R3_22 * T(0.065) - R3_32 * T(0.26);
  A[145] = -t146;
  A[405] = -t146;
  const T t147 = R3_23 * T(0.065) - R3_33 * T(0.26);
  A[146] = -t147;
  A[426] = -t147;
  A[154] = T(0.17225000000000001);
  A[155] = -T(0.0182);
  A[175] = -T(0.0182);
  const T t148 = R3_31 * T(0.13) - R3_11 * T(0.065);
  A[165] = -t148;
  A[385] = -t148;
  const T t149 = R3_32 * T(0.13) - R3_12 * T(0.065);
  A[166] = -t149;
  A[406] = -t149;
  const T t150 = R3_33 * T(0.13) - R3_13 * T(0.065);
  A[167] = -t150;
  A[427] = -t150;
  A[176] = T(0.169);
  const T t151 = R3_11 * T(0.26) - R3_21 * T(0.13);
  A[186] = -t151;
  A[386] = -t151;
  const T t152 = R3_12 * T(0.26) - R3_22 * T(0.13);
  A[187] = -t152;
  A[407] = -t152;
  const T t153 = R3_13 * T(0.26) - R3_23 * T(0.13);
  A[188] = -t153;
  A[428] = -t153;
  A[198] = T(0.1995);
  A[199] = -T(0.021);
  A[219] = -T(0.021);
  A[200] = -T(0.0028000000000000004);
  A[240] = -T(0.0028000000000000004);
  const T t154 = R4_21 * T(0.06999999999999999) - R4_31 * T(0.27999999999999997);
  A[207] = -t154;
  A[387] = -t154;
  const T t155 = R4_22 * T(0.06999999999999999) - R4_32 * T(0.27999999999999997);
  A[208] = -t155;
  A[408] = -t155;
  const T t156 = R4_23 * T(0.06999999999999999) - R4_33 * T(0.27999999999999997);
  A[209] = -t156;
  A[429] = -t156;
  A[220] = T(0.1855);
  A[221] = -T(0.0196);
  A[241] = -T(0.0196);
  const T t157 = R4_31 * T(0.13999999999999999) - R4_11 * T(0.06999999999999999);
  A[228] = -t157;
  A[388] = -t157;
  const T t158 = R4_32 * T(0.13999999999999999) - R4_12 * T(0.06999999999999999);
  A[229] = -t158;
  A[409] = -t158;
  const T t159 = R4_33 * T(0.13999999999999999) - R4_13 * T(0.06999999999999999);
  A[230] = -t159;
  A[430] = -t159;
  A[242] = T(0.182);
  const T t160 = R4_11 * T(0.27999999999999997) - R4_21 * T(0.13999999999999999);
  A[249] = -t160;
  A[389] = -t160;
  const T t161 = R4_12 * T(0.27999999999999997) - R4_22 * T(0.13999999999999999);
  A[250] = -t161;
  A[410] = -t161;
  const T t162 = R4_13 * T(0.27999999999999997) - R4_23 * T(0.13999999999999999);
  A[251] = -t162;
  A[431] = -t162;
  A[264] = T(0.37375);
  A[265] = -T(0.1665);
  A[285] = -T(0.1665);
  A[266] = -T(0.051000000000000004);
  A[306] = -T(0.051000000000000004);
  const T t163 = T(0.3) * (C5_6_32 * T(0.08000000000000002) - C5_6_33 * T(0.32000000000000006));
  const T t164 = C5_6_22 * T(0.08000000000000002) - C5_6_23 * T(0.32000000000000006);
  const T t165 = t163 - T(0.1) * t164;
  A[267] = -t165;
  A[327] = -t165;
  const T t166 = T(0.3) * (C5_6_33 * T(0.16000000000000003) - C5_6_31 * T(0.08000000000000002));
  const T t167 = C5_6_23 * T(0.16000000000000003) - C5_6_21 * T(0.08000000000000002);
  const T t168 = t166 - T(0.1) * t167;
  A[268] = -t168;
  A[348] = -t168;
  const T t169 = T(0.3) * (C5_6_31 * T(0.32000000000000006) - C5_6_32 * T(0.16000000000000003));
  const T t170 = C5_6_21 * T(0.32000000000000006) - C5_6_22 * T(0.16000000000000003);
  const T t171 = t169 - T(0.1) * t170;
  A[269] = -t171;
  A[369] = -t171;
  const T t172 = R5_21 * T(0.23500000000000001) - R5_31 * T(0.78);
  A[270] = -t172;
  A[390] = -t172;
  const T t173 = R5_22 * T(0.23500000000000001) - R5_32 * T(0.78);
  A[271] = -t173;
  A[411] = -t173;
  const T t174 = R5_23 * T(0.23500000000000001) - R5_33 * T(0.78);
  A[272] = -t174;
  A[432] = -t174;
  A[286] = T(0.35875);
  A[287] = -T(0.069);
  A[307] = -T(0.069);
  const T t175 = C5_6_12 * T(0.08000000000000002) - C5_6_13 * T(0.32000000000000006);
  const T t176 = T(0.1) * t175 - t163;
  A[288] = -t176;
  A[328] = -t176;
  const T t177 = C5_6_13 * T(0.16000000000000003) - C5_6_11 * T(0.08000000000000002);
  const T t178 = T(0.1) * t177 - t166;
  A[289] = -t178;
  A[349] = -t178;
  const T t179 = C5_6_11 * T(0.32000000000000006) - C5_6_12 * T(0.16000000000000003);
  const T t180 = T(0.1) * t179 - t169;
  A[290] = -t180;
  A[370] = -t180;
  const T t181 = R5_31 * T(0.63) - R5_11 * T(0.23500000000000001);
  A[291] = -t181;
  A[391] = -t181;
  const T t182 = R5_32 * T(0.63) - R5_12 * T(0.23500000000000001);
  A[292] = -t182;
  A[412] = -t182;
  const T t183 = R5_33 * T(0.63) - R5_13 * T(0.23500000000000001);
  A[293] = -t183;
  A[433] = -t183;
  A[308] = T(0.483);
  const T t184 = T(0.3) * t164 - T(0.3) * t175;
  A[309] = -t184;
  A[329] = -t184;
  const T t185 = T(0.3) * t167 - T(0.3) * t177;
  A[310] = -t185;
  A[350] = -t185;
  const T t186 = T(0.3) * t170 - T(0.3) * t179;
  A[311] = -t186;
  A[371] = -t186;
  const T t187 = R5_11 * T(0.78) - R5_21 * T(0.63);
  A[312] = -t187;
  A[392] = -t187;
  const T t188 = R5_12 * T(0.78) - R5_22 * T(0.63);
  A[313] = -t188;
  A[413] = -t188;
  const T t189 = R5_13 * T(0.78) - R5_23 * T(0.63);
  A[314] = -t189;
  A[434] = -t189;
  A[330] = T(0.228);
  A[331] = -T(0.024000000000000004);
  A[351] = -T(0.024000000000000004);
  A[332] = -T(0.003200000000000002);
  A[372] = -T(0.003200000000000002);
  const T t190 = R6_21 * T(0.08000000000000002) - R6_31 * T(0.32000000000000006);
  A[333] = -t190;
  A[393] = -t190;
  const T t191 = R6_22 * T(0.08000000000000002) - R6_32 * T(0.32000000000000006);
  A[334] = -t191;
  A[414] = -t191;
  const T t192 = R6_23 * T(0.08000000000000002) - R6_33 * T(0.32000000000000006);
  A[335] = -t192;
  A[435] = -t192;
  A[352] = T(0.212);
  A[353] = -T(0.022400000000000003);
  A[373] = -T(0.022400000000000003);
  const T t193 = R6_31 * T(0.16000000000000003) - R6_11 * T(0.08000000000000002);
  A[354] = -t193;
  A[394] = -t193;
  const T t194 = R6_32 * T(0.16000000000000003) - R6_12 * T(0.08000000000000002);
  A[355] = -t194;
  A[415] = -t194;
  const T t195 = R6_33 * T(0.16000000000000003) - R6_13 * T(0.08000000000000002);
  A[356] = -t195;
  A[436] = -t195;
  A[374] = T(0.20800000000000002);
  const T t196 = R6_11 * T(0.32000000000000006) - R6_21 * T(0.16000000000000003);
  A[375] = -t196;
  A[395] = -t196;
  const T t197 = R6_12 * T(0.32000000000000006) - R6_22 * T(0.16000000000000003);
  A[376] = -t197;
  A[416] = -t197;
  const T t198 = R6_13 * T(0.32000000000000006) - R6_23 * T(0.16000000000000003);
  A[377] = -t198;
  A[437] = -t198;
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
