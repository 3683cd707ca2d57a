// SPDX-License-Identifier: BSD-3-Clause
// bench_cb32: equations of motion of 32 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 5f6c7f97ab975607 of bench_cb32/scene.toml; functions kinematics energy residual
// bodies and their joints:
//   1 body_1 on the inertial frame: ball
//   2 body_2 on 1: ball
//   3 body_3 on 2: ball
//   4 body_4 on 3: ball
//   5 body_5 on 4: ball
//   6 body_6 on 5: ball
//   7 body_7 on 6: ball
//   8 body_8 on 7: ball
//   9 body_9 on 8: ball
//   10 body_10 on 9: ball
//   11 body_11 on 10: ball
//   12 body_12 on 11: ball
//   13 body_13 on 12: ball
//   14 body_14 on 13: ball
//   15 body_15 on 14: ball
//   16 body_16 on 15: ball
//   17 body_17 on 16: ball
//   18 body_18 on 17: ball
//   19 body_19 on 18: ball
//   20 body_20 on 19: ball
//   21 body_21 on 20: ball
//   22 body_22 on 21: ball
//   23 body_23 on 22: ball
//   24 body_24 on 23: ball
//   25 body_25 on 24: ball
//   26 body_26 on 25: ball
//   27 body_27 on 26: ball
//   28 body_28 on 27: ball
//   29 body_29 on 28: ball
//   30 body_30 on 29: ball
//   31 body_31 on 30: ball
//   32 body_32 on 31: ball
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, eps_2_1 .. eps_2_4, eps_3_1 .. eps_3_4, eps_4_1 .. eps_4_4, eps_5_1 .. eps_5_4,
//   eps_6_1 .. eps_6_4, eps_7_1 .. eps_7_4, eps_8_1 .. eps_8_4, eps_9_1 .. eps_9_4, eps_10_1 .. eps_10_4,
//   eps_11_1 .. eps_11_4, eps_12_1 .. eps_12_4, eps_13_1 .. eps_13_4, eps_14_1 .. eps_14_4, eps_15_1 .. eps_15_4,
//   eps_16_1 .. eps_16_4, eps_17_1 .. eps_17_4, eps_18_1 .. eps_18_4, eps_19_1 .. eps_19_4, eps_20_1 .. eps_20_4,
//   eps_21_1 .. eps_21_4, eps_22_1 .. eps_22_4, eps_23_1 .. eps_23_4, eps_24_1 .. eps_24_4, eps_25_1 .. eps_25_4,
//   eps_26_1 .. eps_26_4, eps_27_1 .. eps_27_4, eps_28_1 .. eps_28_4, eps_29_1 .. eps_29_4, eps_30_1 .. eps_30_4,
//   eps_31_1 .. eps_31_4, eps_32_1 .. eps_32_4)
//   y = (omega_1_1 .. omega_1_3, omega_2_1 .. omega_2_3, omega_3_1 .. omega_3_3, omega_4_1 .. omega_4_3,
//   omega_5_1 .. omega_5_3, omega_6_1 .. omega_6_3, omega_7_1 .. omega_7_3, omega_8_1 .. omega_8_3,
//   omega_9_1 .. omega_9_3, omega_10_1 .. omega_10_3, omega_11_1 .. omega_11_3, omega_12_1 .. omega_12_3,
//   omega_13_1 .. omega_13_3, omega_14_1 .. omega_14_3, omega_15_1 .. omega_15_3, omega_16_1 .. omega_16_3,
//   omega_17_1 .. omega_17_3, omega_18_1 .. omega_18_3, omega_19_1 .. omega_19_3, omega_20_1 .. omega_20_3,
//   omega_21_1 .. omega_21_3, omega_22_1 .. omega_22_3, omega_23_1 .. omega_23_3, omega_24_1 .. omega_24_3,
//   omega_25_1 .. omega_25_3, omega_26_1 .. omega_26_3, omega_27_1 .. omega_27_3, omega_28_1 .. omega_28_3,
//   omega_29_1 .. omega_29_3, omega_30_1 .. omega_30_3, omega_31_1 .. omega_31_3, omega_32_1 .. omega_32_3)
//   eps       Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)
//   omega     absolute angular velocity, body axes [rad/s] (3)
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              736 (256 add, 480 multiply)
//   energy                  3753 (1702 add, 2051 multiply)
//   residual                7247 (3468 add, 3779 multiply)
#pragma once

namespace kanec::bench_cb32 {

inline constexpr int n_bodies = 32;
inline constexpr int nx = 128;
inline constexpr int ny = 96;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 96;
inline constexpr char model_hash[] = "5f6c7f97ab975607";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, eps_2_1 = 4, eps_2_2 = 5, eps_2_3 = 6,
    eps_2_4 = 7, eps_3_1 = 8, eps_3_2 = 9, eps_3_3 = 10, eps_3_4 = 11, eps_4_1 = 12, eps_4_2 = 13, eps_4_3 = 14,
    eps_4_4 = 15, eps_5_1 = 16, eps_5_2 = 17, eps_5_3 = 18, eps_5_4 = 19, eps_6_1 = 20, eps_6_2 = 21, eps_6_3 = 22,
    eps_6_4 = 23, eps_7_1 = 24, eps_7_2 = 25, eps_7_3 = 26, eps_7_4 = 27, eps_8_1 = 28, eps_8_2 = 29, eps_8_3 = 30,
    eps_8_4 = 31, eps_9_1 = 32, eps_9_2 = 33, eps_9_3 = 34, eps_9_4 = 35, eps_10_1 = 36, eps_10_2 = 37, eps_10_3 = 38,
    eps_10_4 = 39, eps_11_1 = 40, eps_11_2 = 41, eps_11_3 = 42, eps_11_4 = 43, eps_12_1 = 44, eps_12_2 = 45,
    eps_12_3 = 46, eps_12_4 = 47, eps_13_1 = 48, eps_13_2 = 49, eps_13_3 = 50, eps_13_4 = 51, eps_14_1 = 52,
    eps_14_2 = 53, eps_14_3 = 54, eps_14_4 = 55, eps_15_1 = 56, eps_15_2 = 57, eps_15_3 = 58, eps_15_4 = 59,
    eps_16_1 = 60, eps_16_2 = 61, eps_16_3 = 62, eps_16_4 = 63, eps_17_1 = 64, eps_17_2 = 65, eps_17_3 = 66,
    eps_17_4 = 67, eps_18_1 = 68, eps_18_2 = 69, eps_18_3 = 70, eps_18_4 = 71, eps_19_1 = 72, eps_19_2 = 73,
    eps_19_3 = 74, eps_19_4 = 75, eps_20_1 = 76, eps_20_2 = 77, eps_20_3 = 78, eps_20_4 = 79, eps_21_1 = 80,
    eps_21_2 = 81, eps_21_3 = 82, eps_21_4 = 83, eps_22_1 = 84, eps_22_2 = 85, eps_22_3 = 86, eps_22_4 = 87,
    eps_23_1 = 88, eps_23_2 = 89, eps_23_3 = 90, eps_23_4 = 91, eps_24_1 = 92, eps_24_2 = 93, eps_24_3 = 94,
    eps_24_4 = 95, eps_25_1 = 96, eps_25_2 = 97, eps_25_3 = 98, eps_25_4 = 99, eps_26_1 = 100, eps_26_2 = 101,
    eps_26_3 = 102, eps_26_4 = 103, eps_27_1 = 104, eps_27_2 = 105, eps_27_3 = 106, eps_27_4 = 107, eps_28_1 = 108,
    eps_28_2 = 109, eps_28_3 = 110, eps_28_4 = 111, eps_29_1 = 112, eps_29_2 = 113, eps_29_3 = 114, eps_29_4 = 115,
    eps_30_1 = 116, eps_30_2 = 117, eps_30_3 = 118, eps_30_4 = 119, eps_31_1 = 120, eps_31_2 = 121, eps_31_3 = 122,
    eps_31_4 = 123, eps_32_1 = 124, eps_32_2 = 125, eps_32_3 = 126, eps_32_4 = 127;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, omega_2_1 = 3, omega_2_2 = 4, omega_2_3 = 5,
    omega_3_1 = 6, omega_3_2 = 7, omega_3_3 = 8, omega_4_1 = 9, omega_4_2 = 10, omega_4_3 = 11, omega_5_1 = 12,
    omega_5_2 = 13, omega_5_3 = 14, omega_6_1 = 15, omega_6_2 = 16, omega_6_3 = 17, omega_7_1 = 18, omega_7_2 = 19,
    omega_7_3 = 20, omega_8_1 = 21, omega_8_2 = 22, omega_8_3 = 23, omega_9_1 = 24, omega_9_2 = 25, omega_9_3 = 26,
    omega_10_1 = 27, omega_10_2 = 28, omega_10_3 = 29, omega_11_1 = 30, omega_11_2 = 31, omega_11_3 = 32,
    omega_12_1 = 33, omega_12_2 = 34, omega_12_3 = 35, omega_13_1 = 36, omega_13_2 = 37, omega_13_3 = 38,
    omega_14_1 = 39, omega_14_2 = 40, omega_14_3 = 41, omega_15_1 = 42, omega_15_2 = 43, omega_15_3 = 44,
    omega_16_1 = 45, omega_16_2 = 46, omega_16_3 = 47, omega_17_1 = 48, omega_17_2 = 49, omega_17_3 = 50,
    omega_18_1 = 51, omega_18_2 = 52, omega_18_3 = 53, omega_19_1 = 54, omega_19_2 = 55, omega_19_3 = 56,
    omega_20_1 = 57, omega_20_2 = 58, omega_20_3 = 59, omega_21_1 = 60, omega_21_2 = 61, omega_21_3 = 62,
    omega_22_1 = 63, omega_22_2 = 64, omega_22_3 = 65, omega_23_1 = 66, omega_23_2 = 67, omega_23_3 = 68,
    omega_24_1 = 69, omega_24_2 = 70, omega_24_3 = 71, omega_25_1 = 72, omega_25_2 = 73, omega_25_3 = 74,
    omega_26_1 = 75, omega_26_2 = 76, omega_26_3 = 77, omega_27_1 = 78, omega_27_2 = 79, omega_27_3 = 80,
    omega_28_1 = 81, omega_28_2 = 82, omega_28_3 = 83, omega_29_1 = 84, omega_29_2 = 85, omega_29_3 = 86,
    omega_30_1 = 87, omega_30_2 = 88, omega_30_3 = 89, omega_31_1 = 90, omega_31_2 = 91, omega_31_3 = 92,
    omega_32_1 = 93, omega_32_2 = 94, omega_32_3 = 95;
}  // namespace at

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
  T tau_7_1 = T(0);
  T tau_7_2 = T(0);
  T tau_7_3 = T(0);
  T tau_8_1 = T(0);
  T tau_8_2 = T(0);
  T tau_8_3 = T(0);
  T tau_9_1 = T(0);
  T tau_9_2 = T(0);
  T tau_9_3 = T(0);
  T tau_10_1 = T(0);
  T tau_10_2 = T(0);
  T tau_10_3 = T(0);
  T tau_11_1 = T(0);
  T tau_11_2 = T(0);
  T tau_11_3 = T(0);
  T tau_12_1 = T(0);
  T tau_12_2 = T(0);
  T tau_12_3 = T(0);
  T tau_13_1 = T(0);
  T tau_13_2 = T(0);
  T tau_13_3 = T(0);
  T tau_14_1 = T(0);
  T tau_14_2 = T(0);
  T tau_14_3 = T(0);
  T tau_15_1 = T(0);
  T tau_15_2 = T(0);
  T tau_15_3 = T(0);
  T tau_16_1 = T(0);
  T tau_16_2 = T(0);
  T tau_16_3 = T(0);
  T tau_17_1 = T(0);
  T tau_17_2 = T(0);
  T tau_17_3 = T(0);
  T tau_18_1 = T(0);
  T tau_18_2 = T(0);
  T tau_18_3 = T(0);
  T tau_19_1 = T(0);
  T tau_19_2 = T(0);
  T tau_19_3 = T(0);
  T tau_20_1 = T(0);
  T tau_20_2 = T(0);
  T tau_20_3 = T(0);
  T tau_21_1 = T(0);
  T tau_21_2 = T(0);
  T tau_21_3 = T(0);
  T tau_22_1 = T(0);
  T tau_22_2 = T(0);
  T tau_22_3 = T(0);
  T tau_23_1 = T(0);
  T tau_23_2 = T(0);
  T tau_23_3 = T(0);
  T tau_24_1 = T(0);
  T tau_24_2 = T(0);
  T tau_24_3 = T(0);
  T tau_25_1 = T(0);
  T tau_25_2 = T(0);
  T tau_25_3 = T(0);
  T tau_26_1 = T(0);
  T tau_26_2 = T(0);
  T tau_26_3 = T(0);
  T tau_27_1 = T(0);
  T tau_27_2 = T(0);
  T tau_27_3 = T(0);
  T tau_28_1 = T(0);
  T tau_28_2 = T(0);
  T tau_28_3 = T(0);
  T tau_29_1 = T(0);
  T tau_29_2 = T(0);
  T tau_29_3 = T(0);
  T tau_30_1 = T(0);
  T tau_30_2 = T(0);
  T tau_30_3 = T(0);
  T tau_31_1 = T(0);
  T tau_31_2 = T(0);
  T tau_31_3 = T(0);
  T tau_32_1 = T(0);
  T tau_32_2 = T(0);
  T tau_32_3 = T(0);
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
// 256 add, 480 multiply
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

  // ---- body 7 (body_7) on body 6
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  // w7 = 1/2 omega7: half the angular velocity [rad/s]
  const T w7_1 = T(0.5) * omega7_1;
  const T w7_2 = T(0.5) * omega7_2;
  const T w7_3 = T(0.5) * omega7_3;
  // edot7 = e7~ w7 + eps4_7 w7: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot7_1 = eps7_2 * w7_3 - eps7_3 * w7_2 + eps7_4 * w7_1;
  const T edot7_2 = eps7_3 * w7_1 - eps7_1 * w7_3 + eps7_4 * w7_2;
  const T edot7_3 = eps7_1 * w7_2 - eps7_2 * w7_1 + eps7_4 * w7_3;
  xdot[24] = edot7_1;
  xdot[25] = edot7_2;
  xdot[26] = edot7_3;
  // eps4dot7 = -e7 . w7: rate of eps_4 [1/s]
  const T minus_eps4dot7 = eps7_1 * w7_1 + eps7_2 * w7_2 + eps7_3 * w7_3;
  xdot[27] = -minus_eps4dot7;

  // ---- body 8 (body_8) on body 7
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  // w8 = 1/2 omega8: half the angular velocity [rad/s]
  const T w8_1 = T(0.5) * omega8_1;
  const T w8_2 = T(0.5) * omega8_2;
  const T w8_3 = T(0.5) * omega8_3;
  // edot8 = e8~ w8 + eps4_8 w8: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot8_1 = eps8_2 * w8_3 - eps8_3 * w8_2 + eps8_4 * w8_1;
  const T edot8_2 = eps8_3 * w8_1 - eps8_1 * w8_3 + eps8_4 * w8_2;
  const T edot8_3 = eps8_1 * w8_2 - eps8_2 * w8_1 + eps8_4 * w8_3;
  xdot[28] = edot8_1;
  xdot[29] = edot8_2;
  xdot[30] = edot8_3;
  // eps4dot8 = -e8 . w8: rate of eps_4 [1/s]
  const T minus_eps4dot8 = eps8_1 * w8_1 + eps8_2 * w8_2 + eps8_3 * w8_3;
  xdot[31] = -minus_eps4dot8;

  // ---- body 9 (body_9) on body 8
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  // w9 = 1/2 omega9: half the angular velocity [rad/s]
  const T w9_1 = T(0.5) * omega9_1;
  const T w9_2 = T(0.5) * omega9_2;
  const T w9_3 = T(0.5) * omega9_3;
  // edot9 = e9~ w9 + eps4_9 w9: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot9_1 = eps9_2 * w9_3 - eps9_3 * w9_2 + eps9_4 * w9_1;
  const T edot9_2 = eps9_3 * w9_1 - eps9_1 * w9_3 + eps9_4 * w9_2;
  const T edot9_3 = eps9_1 * w9_2 - eps9_2 * w9_1 + eps9_4 * w9_3;
  xdot[32] = edot9_1;
  xdot[33] = edot9_2;
  xdot[34] = edot9_3;
  // eps4dot9 = -e9 . w9: rate of eps_4 [1/s]
  const T minus_eps4dot9 = eps9_1 * w9_1 + eps9_2 * w9_2 + eps9_3 * w9_3;
  xdot[35] = -minus_eps4dot9;

  // ---- body 10 (body_10) on body 9
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  // w10 = 1/2 omega10: half the angular velocity [rad/s]
  const T w10_1 = T(0.5) * omega10_1;
  const T w10_2 = T(0.5) * omega10_2;
  const T w10_3 = T(0.5) * omega10_3;
  // edot10 = e10~ w10 + eps4_10 w10: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot10_1 = eps10_2 * w10_3 - eps10_3 * w10_2 + eps10_4 * w10_1;
  const T edot10_2 = eps10_3 * w10_1 - eps10_1 * w10_3 + eps10_4 * w10_2;
  const T edot10_3 = eps10_1 * w10_2 - eps10_2 * w10_1 + eps10_4 * w10_3;
  xdot[36] = edot10_1;
  xdot[37] = edot10_2;
  xdot[38] = edot10_3;
  // eps4dot10 = -e10 . w10: rate of eps_4 [1/s]
  const T minus_eps4dot10 = eps10_1 * w10_1 + eps10_2 * w10_2 + eps10_3 * w10_3;
  xdot[39] = -minus_eps4dot10;

  // ---- body 11 (body_11) on body 10
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  // w11 = 1/2 omega11: half the angular velocity [rad/s]
  const T w11_1 = T(0.5) * omega11_1;
  const T w11_2 = T(0.5) * omega11_2;
  const T w11_3 = T(0.5) * omega11_3;
  // edot11 = e11~ w11 + eps4_11 w11: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot11_1 = eps11_2 * w11_3 - eps11_3 * w11_2 + eps11_4 * w11_1;
  const T edot11_2 = eps11_3 * w11_1 - eps11_1 * w11_3 + eps11_4 * w11_2;
  const T edot11_3 = eps11_1 * w11_2 - eps11_2 * w11_1 + eps11_4 * w11_3;
  xdot[40] = edot11_1;
  xdot[41] = edot11_2;
  xdot[42] = edot11_3;
  // eps4dot11 = -e11 . w11: rate of eps_4 [1/s]
  const T minus_eps4dot11 = eps11_1 * w11_1 + eps11_2 * w11_2 + eps11_3 * w11_3;
  xdot[43] = -minus_eps4dot11;

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  // w12 = 1/2 omega12: half the angular velocity [rad/s]
  const T w12_1 = T(0.5) * omega12_1;
  const T w12_2 = T(0.5) * omega12_2;
  const T w12_3 = T(0.5) * omega12_3;
  // edot12 = e12~ w12 + eps4_12 w12: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot12_1 = eps12_2 * w12_3 - eps12_3 * w12_2 + eps12_4 * w12_1;
  const T edot12_2 = eps12_3 * w12_1 - eps12_1 * w12_3 + eps12_4 * w12_2;
  const T edot12_3 = eps12_1 * w12_2 - eps12_2 * w12_1 + eps12_4 * w12_3;
  xdot[44] = edot12_1;
  xdot[45] = edot12_2;
  xdot[46] = edot12_3;
  // eps4dot12 = -e12 . w12: rate of eps_4 [1/s]
  const T minus_eps4dot12 = eps12_1 * w12_1 + eps12_2 * w12_2 + eps12_3 * w12_3;
  xdot[47] = -minus_eps4dot12;

  // ---- body 13 (body_13) on body 12
  const T eps13_1 = x[48], eps13_2 = x[49], eps13_3 = x[50], eps13_4 = x[51];
  const T omega13_1 = y[36], omega13_2 = y[37], omega13_3 = y[38];
  // w13 = 1/2 omega13: half the angular velocity [rad/s]
  const T w13_1 = T(0.5) * omega13_1;
  const T w13_2 = T(0.5) * omega13_2;
  const T w13_3 = T(0.5) * omega13_3;
  // edot13 = e13~ w13 + eps4_13 w13: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot13_1 = eps13_2 * w13_3 - eps13_3 * w13_2 + eps13_4 * w13_1;
  const T edot13_2 = eps13_3 * w13_1 - eps13_1 * w13_3 + eps13_4 * w13_2;
  const T edot13_3 = eps13_1 * w13_2 - eps13_2 * w13_1 + eps13_4 * w13_3;
  xdot[48] = edot13_1;
  xdot[49] = edot13_2;
  xdot[50] = edot13_3;
  // eps4dot13 = -e13 . w13: rate of eps_4 [1/s]
  const T minus_eps4dot13 = eps13_1 * w13_1 + eps13_2 * w13_2 + eps13_3 * w13_3;
  xdot[51] = -minus_eps4dot13;

  // ---- body 14 (body_14) on body 13
  const T eps14_1 = x[52], eps14_2 = x[53], eps14_3 = x[54], eps14_4 = x[55];
  const T omega14_1 = y[39], omega14_2 = y[40], omega14_3 = y[41];
  // w14 = 1/2 omega14: half the angular velocity [rad/s]
  const T w14_1 = T(0.5) * omega14_1;
  const T w14_2 = T(0.5) * omega14_2;
  const T w14_3 = T(0.5) * omega14_3;
  // edot14 = e14~ w14 + eps4_14 w14: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot14_1 = eps14_2 * w14_3 - eps14_3 * w14_2 + eps14_4 * w14_1;
  const T edot14_2 = eps14_3 * w14_1 - eps14_1 * w14_3 + eps14_4 * w14_2;
  const T edot14_3 = eps14_1 * w14_2 - eps14_2 * w14_1 + eps14_4 * w14_3;
  xdot[52] = edot14_1;
  xdot[53] = edot14_2;
  xdot[54] = edot14_3;
  // eps4dot14 = -e14 . w14: rate of eps_4 [1/s]
  const T minus_eps4dot14 = eps14_1 * w14_1 + eps14_2 * w14_2 + eps14_3 * w14_3;
  xdot[55] = -minus_eps4dot14;

  // ---- body 15 (body_15) on body 14
  const T eps15_1 = x[56], eps15_2 = x[57], eps15_3 = x[58], eps15_4 = x[59];
  const T omega15_1 = y[42], omega15_2 = y[43], omega15_3 = y[44];
  // w15 = 1/2 omega15: half the angular velocity [rad/s]
  const T w15_1 = T(0.5) * omega15_1;
  const T w15_2 = T(0.5) * omega15_2;
  const T w15_3 = T(0.5) * omega15_3;
  // edot15 = e15~ w15 + eps4_15 w15: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot15_1 = eps15_2 * w15_3 - eps15_3 * w15_2 + eps15_4 * w15_1;
  const T edot15_2 = eps15_3 * w15_1 - eps15_1 * w15_3 + eps15_4 * w15_2;
  const T edot15_3 = eps15_1 * w15_2 - eps15_2 * w15_1 + eps15_4 * w15_3;
  xdot[56] = edot15_1;
  xdot[57] = edot15_2;
  xdot[58] = edot15_3;
  // eps4dot15 = -e15 . w15: rate of eps_4 [1/s]
  const T minus_eps4dot15 = eps15_1 * w15_1 + eps15_2 * w15_2 + eps15_3 * w15_3;
  xdot[59] = -minus_eps4dot15;

  // ---- body 16 (body_16) on body 15
  const T eps16_1 = x[60], eps16_2 = x[61], eps16_3 = x[62], eps16_4 = x[63];
  const T omega16_1 = y[45], omega16_2 = y[46], omega16_3 = y[47];
  // w16 = 1/2 omega16: half the angular velocity [rad/s]
  const T w16_1 = T(0.5) * omega16_1;
  const T w16_2 = T(0.5) * omega16_2;
  const T w16_3 = T(0.5) * omega16_3;
  // edot16 = e16~ w16 + eps4_16 w16: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot16_1 = eps16_2 * w16_3 - eps16_3 * w16_2 + eps16_4 * w16_1;
  const T edot16_2 = eps16_3 * w16_1 - eps16_1 * w16_3 + eps16_4 * w16_2;
  const T edot16_3 = eps16_1 * w16_2 - eps16_2 * w16_1 + eps16_4 * w16_3;
  xdot[60] = edot16_1;
  xdot[61] = edot16_2;
  xdot[62] = edot16_3;
  // eps4dot16 = -e16 . w16: rate of eps_4 [1/s]
  const T minus_eps4dot16 = eps16_1 * w16_1 + eps16_2 * w16_2 + eps16_3 * w16_3;
  xdot[63] = -minus_eps4dot16;

  // ---- body 17 (body_17) on body 16
  const T eps17_1 = x[64], eps17_2 = x[65], eps17_3 = x[66], eps17_4 = x[67];
  const T omega17_1 = y[48], omega17_2 = y[49], omega17_3 = y[50];
  // w17 = 1/2 omega17: half the angular velocity [rad/s]
  const T w17_1 = T(0.5) * omega17_1;
  const T w17_2 = T(0.5) * omega17_2;
  const T w17_3 = T(0.5) * omega17_3;
  // edot17 = e17~ w17 + eps4_17 w17: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot17_1 = eps17_2 * w17_3 - eps17_3 * w17_2 + eps17_4 * w17_1;
  const T edot17_2 = eps17_3 * w17_1 - eps17_1 * w17_3 + eps17_4 * w17_2;
  const T edot17_3 = eps17_1 * w17_2 - eps17_2 * w17_1 + eps17_4 * w17_3;
  xdot[64] = edot17_1;
  xdot[65] = edot17_2;
  xdot[66] = edot17_3;
  // eps4dot17 = -e17 . w17: rate of eps_4 [1/s]
  const T minus_eps4dot17 = eps17_1 * w17_1 + eps17_2 * w17_2 + eps17_3 * w17_3;
  xdot[67] = -minus_eps4dot17;

  // ---- body 18 (body_18) on body 17
  const T eps18_1 = x[68], eps18_2 = x[69], eps18_3 = x[70], eps18_4 = x[71];
  const T omega18_1 = y[51], omega18_2 = y[52], omega18_3 = y[53];
  // w18 = 1/2 omega18: half the angular velocity [rad/s]
  const T w18_1 = T(0.5) * omega18_1;
  const T w18_2 = T(0.5) * omega18_2;
  const T w18_3 = T(0.5) * omega18_3;
  // edot18 = e18~ w18 + eps4_18 w18: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot18_1 = eps18_2 * w18_3 - eps18_3 * w18_2 + eps18_4 * w18_1;
  const T edot18_2 = eps18_3 * w18_1 - eps18_1 * w18_3 + eps18_4 * w18_2;
  const T edot18_3 = eps18_1 * w18_2 - eps18_2 * w18_1 + eps18_4 * w18_3;
  xdot[68] = edot18_1;
  xdot[69] = edot18_2;
  xdot[70] = edot18_3;
  // eps4dot18 = -e18 . w18: rate of eps_4 [1/s]
  const T minus_eps4dot18 = eps18_1 * w18_1 + eps18_2 * w18_2 + eps18_3 * w18_3;
  xdot[71] = -minus_eps4dot18;

  // ---- body 19 (body_19) on body 18
  const T eps19_1 = x[72], eps19_2 = x[73], eps19_3 = x[74], eps19_4 = x[75];
  const T omega19_1 = y[54], omega19_2 = y[55], omega19_3 = y[56];
  // w19 = 1/2 omega19: half the angular velocity [rad/s]
  const T w19_1 = T(0.5) * omega19_1;
  const T w19_2 = T(0.5) * omega19_2;
  const T w19_3 = T(0.5) * omega19_3;
  // edot19 = e19~ w19 + eps4_19 w19: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot19_1 = eps19_2 * w19_3 - eps19_3 * w19_2 + eps19_4 * w19_1;
  const T edot19_2 = eps19_3 * w19_1 - eps19_1 * w19_3 + eps19_4 * w19_2;
  const T edot19_3 = eps19_1 * w19_2 - eps19_2 * w19_1 + eps19_4 * w19_3;
  xdot[72] = edot19_1;
  xdot[73] = edot19_2;
  xdot[74] = edot19_3;
  // eps4dot19 = -e19 . w19: rate of eps_4 [1/s]
  const T minus_eps4dot19 = eps19_1 * w19_1 + eps19_2 * w19_2 + eps19_3 * w19_3;
  xdot[75] = -minus_eps4dot19;

  // ---- body 20 (body_20) on body 19
  const T eps20_1 = x[76], eps20_2 = x[77], eps20_3 = x[78], eps20_4 = x[79];
  const T omega20_1 = y[57], omega20_2 = y[58], omega20_3 = y[59];
  // w20 = 1/2 omega20: half the angular velocity [rad/s]
  const T w20_1 = T(0.5) * omega20_1;
  const T w20_2 = T(0.5) * omega20_2;
  const T w20_3 = T(0.5) * omega20_3;
  // edot20 = e20~ w20 + eps4_20 w20: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot20_1 = eps20_2 * w20_3 - eps20_3 * w20_2 + eps20_4 * w20_1;
  const T edot20_2 = eps20_3 * w20_1 - eps20_1 * w20_3 + eps20_4 * w20_2;
  const T edot20_3 = eps20_1 * w20_2 - eps20_2 * w20_1 + eps20_4 * w20_3;
  xdot[76] = edot20_1;
  xdot[77] = edot20_2;
  xdot[78] = edot20_3;
  // eps4dot20 = -e20 . w20: rate of eps_4 [1/s]
  const T minus_eps4dot20 = eps20_1 * w20_1 + eps20_2 * w20_2 + eps20_3 * w20_3;
  xdot[79] = -minus_eps4dot20;

  // ---- body 21 (body_21) on body 20
  const T eps21_1 = x[80], eps21_2 = x[81], eps21_3 = x[82], eps21_4 = x[83];
  const T omega21_1 = y[60], omega21_2 = y[61], omega21_3 = y[62];
  // w21 = 1/2 omega21: half the angular velocity [rad/s]
  const T w21_1 = T(0.5) * omega21_1;
  const T w21_2 = T(0.5) * omega21_2;
  const T w21_3 = T(0.5) * omega21_3;
  // edot21 = e21~ w21 + eps4_21 w21: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot21_1 = eps21_2 * w21_3 - eps21_3 * w21_2 + eps21_4 * w21_1;
  const T edot21_2 = eps21_3 * w21_1 - eps21_1 * w21_3 + eps21_4 * w21_2;
  const T edot21_3 = eps21_1 * w21_2 - eps21_2 * w21_1 + eps21_4 * w21_3;
  xdot[80] = edot21_1;
  xdot[81] = edot21_2;
  xdot[82] = edot21_3;
  // eps4dot21 = -e21 . w21: rate of eps_4 [1/s]
  const T minus_eps4dot21 = eps21_1 * w21_1 + eps21_2 * w21_2 + eps21_3 * w21_3;
  xdot[83] = -minus_eps4dot21;

  // ---- body 22 (body_22) on body 21
  const T eps22_1 = x[84], eps22_2 = x[85], eps22_3 = x[86], eps22_4 = x[87];
  const T omega22_1 = y[63], omega22_2 = y[64], omega22_3 = y[65];
  // w22 = 1/2 omega22: half the angular velocity [rad/s]
  const T w22_1 = T(0.5) * omega22_1;
  const T w22_2 = T(0.5) * omega22_2;
  const T w22_3 = T(0.5) * omega22_3;
  // edot22 = e22~ w22 + eps4_22 w22: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot22_1 = eps22_2 * w22_3 - eps22_3 * w22_2 + eps22_4 * w22_1;
  const T edot22_2 = eps22_3 * w22_1 - eps22_1 * w22_3 + eps22_4 * w22_2;
  const T edot22_3 = eps22_1 * w22_2 - eps22_2 * w22_1 + eps22_4 * w22_3;
  xdot[84] = edot22_1;
  xdot[85] = edot22_2;
  xdot[86] = edot22_3;
  // eps4dot22 = -e22 . w22: rate of eps_4 [1/s]
  const T minus_eps4dot22 = eps22_1 * w22_1 + eps22_2 * w22_2 + eps22_3 * w22_3;
  xdot[87] = -minus_eps4dot22;

  // ---- body 23 (body_23) on body 22
  const T eps23_1 = x[88], eps23_2 = x[89], eps23_3 = x[90], eps23_4 = x[91];
  const T omega23_1 = y[66], omega23_2 = y[67], omega23_3 = y[68];
  // w23 = 1/2 omega23: half the angular velocity [rad/s]
  const T w23_1 = T(0.5) * omega23_1;
  const T w23_2 = T(0.5) * omega23_2;
  const T w23_3 = T(0.5) * omega23_3;
  // edot23 = e23~ w23 + eps4_23 w23: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot23_1 = eps23_2 * w23_3 - eps23_3 * w23_2 + eps23_4 * w23_1;
  const T edot23_2 = eps23_3 * w23_1 - eps23_1 * w23_3 + eps23_4 * w23_2;
  const T edot23_3 = eps23_1 * w23_2 - eps23_2 * w23_1 + eps23_4 * w23_3;
  xdot[88] = edot23_1;
  xdot[89] = edot23_2;
  xdot[90] = edot23_3;
  // eps4dot23 = -e23 . w23: rate of eps_4 [1/s]
  const T minus_eps4dot23 = eps23_1 * w23_1 + eps23_2 * w23_2 + eps23_3 * w23_3;
  xdot[91] = -minus_eps4dot23;

  // ---- body 24 (body_24) on body 23
  const T eps24_1 = x[92], eps24_2 = x[93], eps24_3 = x[94], eps24_4 = x[95];
  const T omega24_1 = y[69], omega24_2 = y[70], omega24_3 = y[71];
  // w24 = 1/2 omega24: half the angular velocity [rad/s]
  const T w24_1 = T(0.5) * omega24_1;
  const T w24_2 = T(0.5) * omega24_2;
  const T w24_3 = T(0.5) * omega24_3;
  // edot24 = e24~ w24 + eps4_24 w24: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot24_1 = eps24_2 * w24_3 - eps24_3 * w24_2 + eps24_4 * w24_1;
  const T edot24_2 = eps24_3 * w24_1 - eps24_1 * w24_3 + eps24_4 * w24_2;
  const T edot24_3 = eps24_1 * w24_2 - eps24_2 * w24_1 + eps24_4 * w24_3;
  xdot[92] = edot24_1;
  xdot[93] = edot24_2;
  xdot[94] = edot24_3;
  // eps4dot24 = -e24 . w24: rate of eps_4 [1/s]
  const T minus_eps4dot24 = eps24_1 * w24_1 + eps24_2 * w24_2 + eps24_3 * w24_3;
  xdot[95] = -minus_eps4dot24;

  // ---- body 25 (body_25) on body 24
  const T eps25_1 = x[96], eps25_2 = x[97], eps25_3 = x[98], eps25_4 = x[99];
  const T omega25_1 = y[72], omega25_2 = y[73], omega25_3 = y[74];
  // w25 = 1/2 omega25: half the angular velocity [rad/s]
  const T w25_1 = T(0.5) * omega25_1;
  const T w25_2 = T(0.5) * omega25_2;
  const T w25_3 = T(0.5) * omega25_3;
  // edot25 = e25~ w25 + eps4_25 w25: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot25_1 = eps25_2 * w25_3 - eps25_3 * w25_2 + eps25_4 * w25_1;
  const T edot25_2 = eps25_3 * w25_1 - eps25_1 * w25_3 + eps25_4 * w25_2;
  const T edot25_3 = eps25_1 * w25_2 - eps25_2 * w25_1 + eps25_4 * w25_3;
  xdot[96] = edot25_1;
  xdot[97] = edot25_2;
  xdot[98] = edot25_3;
  // eps4dot25 = -e25 . w25: rate of eps_4 [1/s]
  const T minus_eps4dot25 = eps25_1 * w25_1 + eps25_2 * w25_2 + eps25_3 * w25_3;
  xdot[99] = -minus_eps4dot25;

  // ---- body 26 (body_26) on body 25
  const T eps26_1 = x[100], eps26_2 = x[101], eps26_3 = x[102], eps26_4 = x[103];
  const T omega26_1 = y[75], omega26_2 = y[76], omega26_3 = y[77];
  // w26 = 1/2 omega26: half the angular velocity [rad/s]
  const T w26_1 = T(0.5) * omega26_1;
  const T w26_2 = T(0.5) * omega26_2;
  const T w26_3 = T(0.5) * omega26_3;
  // edot26 = e26~ w26 + eps4_26 w26: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot26_1 = eps26_2 * w26_3 - eps26_3 * w26_2 + eps26_4 * w26_1;
  const T edot26_2 = eps26_3 * w26_1 - eps26_1 * w26_3 + eps26_4 * w26_2;
  const T edot26_3 = eps26_1 * w26_2 - eps26_2 * w26_1 + eps26_4 * w26_3;
  xdot[100] = edot26_1;
  xdot[101] = edot26_2;
  xdot[102] = edot26_3;
  // eps4dot26 = -e26 . w26: rate of eps_4 [1/s]
  const T minus_eps4dot26 = eps26_1 * w26_1 + eps26_2 * w26_2 + eps26_3 * w26_3;
  xdot[103] = -minus_eps4dot26;

  // ---- body 27 (body_27) on body 26
  const T eps27_1 = x[104], eps27_2 = x[105], eps27_3 = x[106], eps27_4 = x[107];
  const T omega27_1 = y[78], omega27_2 = y[79], omega27_3 = y[80];
  // w27 = 1/2 omega27: half the angular velocity [rad/s]
  const T w27_1 = T(0.5) * omega27_1;
  const T w27_2 = T(0.5) * omega27_2;
  const T w27_3 = T(0.5) * omega27_3;
  // edot27 = e27~ w27 + eps4_27 w27: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot27_1 = eps27_2 * w27_3 - eps27_3 * w27_2 + eps27_4 * w27_1;
  const T edot27_2 = eps27_3 * w27_1 - eps27_1 * w27_3 + eps27_4 * w27_2;
  const T edot27_3 = eps27_1 * w27_2 - eps27_2 * w27_1 + eps27_4 * w27_3;
  xdot[104] = edot27_1;
  xdot[105] = edot27_2;
  xdot[106] = edot27_3;
  // eps4dot27 = -e27 . w27: rate of eps_4 [1/s]
  const T minus_eps4dot27 = eps27_1 * w27_1 + eps27_2 * w27_2 + eps27_3 * w27_3;
  xdot[107] = -minus_eps4dot27;

  // ---- body 28 (body_28) on body 27
  const T eps28_1 = x[108], eps28_2 = x[109], eps28_3 = x[110], eps28_4 = x[111];
  const T omega28_1 = y[81], omega28_2 = y[82], omega28_3 = y[83];
  // w28 = 1/2 omega28: half the angular velocity [rad/s]
  const T w28_1 = T(0.5) * omega28_1;
  const T w28_2 = T(0.5) * omega28_2;
  const T w28_3 = T(0.5) * omega28_3;
  // edot28 = e28~ w28 + eps4_28 w28: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot28_1 = eps28_2 * w28_3 - eps28_3 * w28_2 + eps28_4 * w28_1;
  const T edot28_2 = eps28_3 * w28_1 - eps28_1 * w28_3 + eps28_4 * w28_2;
  const T edot28_3 = eps28_1 * w28_2 - eps28_2 * w28_1 + eps28_4 * w28_3;
  xdot[108] = edot28_1;
  xdot[109] = edot28_2;
  xdot[110] = edot28_3;
  // eps4dot28 = -e28 . w28: rate of eps_4 [1/s]
  const T minus_eps4dot28 = eps28_1 * w28_1 + eps28_2 * w28_2 + eps28_3 * w28_3;
  xdot[111] = -minus_eps4dot28;

  // ---- body 29 (body_29) on body 28
  const T eps29_1 = x[112], eps29_2 = x[113], eps29_3 = x[114], eps29_4 = x[115];
  const T omega29_1 = y[84], omega29_2 = y[85], omega29_3 = y[86];
  // w29 = 1/2 omega29: half the angular velocity [rad/s]
  const T w29_1 = T(0.5) * omega29_1;
  const T w29_2 = T(0.5) * omega29_2;
  const T w29_3 = T(0.5) * omega29_3;
  // edot29 = e29~ w29 + eps4_29 w29: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot29_1 = eps29_2 * w29_3 - eps29_3 * w29_2 + eps29_4 * w29_1;
  const T edot29_2 = eps29_3 * w29_1 - eps29_1 * w29_3 + eps29_4 * w29_2;
  const T edot29_3 = eps29_1 * w29_2 - eps29_2 * w29_1 + eps29_4 * w29_3;
  xdot[112] = edot29_1;
  xdot[113] = edot29_2;
  xdot[114] = edot29_3;
  // eps4dot29 = -e29 . w29: rate of eps_4 [1/s]
  const T minus_eps4dot29 = eps29_1 * w29_1 + eps29_2 * w29_2 + eps29_3 * w29_3;
  xdot[115] = -minus_eps4dot29;

  // ---- body 30 (body_30) on body 29
  const T eps30_1 = x[116], eps30_2 = x[117], eps30_3 = x[118], eps30_4 = x[119];
  const T omega30_1 = y[87], omega30_2 = y[88], omega30_3 = y[89];
  // w30 = 1/2 omega30: half the angular velocity [rad/s]
  const T w30_1 = T(0.5) * omega30_1;
  const T w30_2 = T(0.5) * omega30_2;
  const T w30_3 = T(0.5) * omega30_3;
  // edot30 = e30~ w30 + eps4_30 w30: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot30_1 = eps30_2 * w30_3 - eps30_3 * w30_2 + eps30_4 * w30_1;
  const T edot30_2 = eps30_3 * w30_1 - eps30_1 * w30_3 + eps30_4 * w30_2;
  const T edot30_3 = eps30_1 * w30_2 - eps30_2 * w30_1 + eps30_4 * w30_3;
  xdot[116] = edot30_1;
  xdot[117] = edot30_2;
  xdot[118] = edot30_3;
  // eps4dot30 = -e30 . w30: rate of eps_4 [1/s]
  const T minus_eps4dot30 = eps30_1 * w30_1 + eps30_2 * w30_2 + eps30_3 * w30_3;
  xdot[119] = -minus_eps4dot30;

  // ---- body 31 (body_31) on body 30
  const T eps31_1 = x[120], eps31_2 = x[121], eps31_3 = x[122], eps31_4 = x[123];
  const T omega31_1 = y[90], omega31_2 = y[91], omega31_3 = y[92];
  // w31 = 1/2 omega31: half the angular velocity [rad/s]
  const T w31_1 = T(0.5) * omega31_1;
  const T w31_2 = T(0.5) * omega31_2;
  const T w31_3 = T(0.5) * omega31_3;
  // edot31 = e31~ w31 + eps4_31 w31: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot31_1 = eps31_2 * w31_3 - eps31_3 * w31_2 + eps31_4 * w31_1;
  const T edot31_2 = eps31_3 * w31_1 - eps31_1 * w31_3 + eps31_4 * w31_2;
  const T edot31_3 = eps31_1 * w31_2 - eps31_2 * w31_1 + eps31_4 * w31_3;
  xdot[120] = edot31_1;
  xdot[121] = edot31_2;
  xdot[122] = edot31_3;
  // eps4dot31 = -e31 . w31: rate of eps_4 [1/s]
  const T minus_eps4dot31 = eps31_1 * w31_1 + eps31_2 * w31_2 + eps31_3 * w31_3;
  xdot[123] = -minus_eps4dot31;

  // ---- body 32 (body_32) on body 31
  const T eps32_1 = x[124], eps32_2 = x[125], eps32_3 = x[126], eps32_4 = x[127];
  const T omega32_1 = y[93], omega32_2 = y[94], omega32_3 = y[95];
  // w32 = 1/2 omega32: half the angular velocity [rad/s]
  const T w32_1 = T(0.5) * omega32_1;
  const T w32_2 = T(0.5) * omega32_2;
  const T w32_3 = T(0.5) * omega32_3;
  // edot32 = e32~ w32 + eps4_32 w32: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot32_1 = eps32_2 * w32_3 - eps32_3 * w32_2 + eps32_4 * w32_1;
  const T edot32_2 = eps32_3 * w32_1 - eps32_1 * w32_3 + eps32_4 * w32_2;
  const T edot32_3 = eps32_1 * w32_2 - eps32_2 * w32_1 + eps32_4 * w32_3;
  xdot[124] = edot32_1;
  xdot[125] = edot32_2;
  xdot[126] = edot32_3;
  // eps4dot32 = -e32 . w32: rate of eps_4 [1/s]
  const T minus_eps4dot32 = eps32_1 * w32_1 + eps32_2 * w32_2 + eps32_3 * w32_3;
  xdot[127] = -minus_eps4dot32;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 1702 add, 2051 multiply
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
  const T p2_3 = R2_13 * T(0.1) + R2_23 * T(0.2) + R2_33 * T(0.05) + P2_3;
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
  const T v2_1 = R2_11 * t2_17 + R2_21 * t2_18 + R2_31 * t2_20 + Pdot2_1;
  const T v2_2 = R2_12 * t2_17 + R2_22 * t2_18 + R2_32 * t2_20 + Pdot2_2;
  const T v2_3 = R2_13 * t2_17 + R2_23 * t2_18 + R2_33 * t2_20 + Pdot2_3;
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
  const T P3_3 = R2_13 * T(0.3) + R2_23 * T(0.15) + R2_33 * T(0.1) + P2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T t3_13 = R3_23 * T(0.2) + P3_3;
  const T p3_3 = R3_13 * T(0.1) + t3_13 + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_14 = t2_19 - omega2_3 * T(0.15);
  const T t3_15 = omega2_3 * T(0.3) - omega2_1 * T(0.1);
  const T t3_16 = omega2_1 * T(0.15) - omega2_2 * T(0.3);
  const T Pdot3_1 = R2_11 * t3_14 + R2_21 * t3_15 + R2_31 * t3_16 + Pdot2_1;
  const T Pdot3_2 = R2_12 * t3_14 + R2_22 * t3_15 + R2_32 * t3_16 + Pdot2_2;
  const T Pdot3_3 = R2_13 * t3_14 + R2_23 * t3_15 + R2_33 * t3_16 + Pdot2_3;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_17 = omega3_3 * T(0.2);
  const T t3_18 = omega3_2 * T(0.05) - t3_17;
  const T t3_19 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_20 = omega3_1 * T(0.2);
  const T t3_21 = omega3_2 * T(0.1);
  const T t3_22 = t3_20 - t3_21;
  const T v3_1 = R3_11 * t3_18 + R3_21 * t3_19 + R3_31 * t3_22 + Pdot3_1;
  const T v3_2 = R3_12 * t3_18 + R3_22 * t3_19 + R3_32 * t3_22 + Pdot3_2;
  const T v3_3 = R3_13 * t3_18 + R3_23 * t3_19 + R3_33 * t3_22 + Pdot3_3;
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
  const T p4_3 = R4_13 * T(0.1) + R4_23 * T(0.2) + R4_33 * T(0.05) + P4_3;
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = t3_21 - t3_17;
  const T t4_14 = omega3_3 * T(0.3) - omega3_1 * T(0.1);
  const T t4_15 = t3_20 - omega3_2 * T(0.3);
  const T Pdot4_1 = R3_11 * t4_13 + R3_21 * t4_14 + R3_31 * t4_15 + Pdot3_1;
  const T Pdot4_2 = R3_12 * t4_13 + R3_22 * t4_14 + R3_32 * t4_15 + Pdot3_2;
  const T Pdot4_3 = R3_13 * t4_13 + R3_23 * t4_14 + R3_33 * t4_15 + Pdot3_3;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_16 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_17 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_18 = omega4_2 * T(0.1);
  const T t4_19 = omega4_1 * T(0.2) - t4_18;
  const T v4_1 = R4_11 * t4_16 + R4_21 * t4_17 + R4_31 * t4_19 + Pdot4_1;
  const T v4_2 = R4_12 * t4_16 + R4_22 * t4_17 + R4_32 * t4_19 + Pdot4_2;
  const T v4_3 = R4_13 * t4_16 + R4_23 * t4_17 + R4_33 * t4_19 + Pdot4_3;
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
  const T P5_3 = R4_13 * T(0.3) + R4_23 * T(0.25) + R4_33 * T(0.1) + P4_3;
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_3 = R5_13 * T(0.1) + R5_23 * T(0.2) + R5_33 * T(0.05) + P5_3;
  // Pdot5 = R4^T omega4~ q5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t5_13 = t4_18 - omega4_3 * T(0.25);
  const T t5_14 = omega4_3 * T(0.3) - omega4_1 * T(0.1);
  const T t5_15 = omega4_1 * T(0.25) - omega4_2 * T(0.3);
  const T Pdot5_1 = R4_11 * t5_13 + R4_21 * t5_14 + R4_31 * t5_15 + Pdot4_1;
  const T Pdot5_2 = R4_12 * t5_13 + R4_22 * t5_14 + R4_32 * t5_15 + Pdot4_2;
  const T Pdot5_3 = R4_13 * t5_13 + R4_23 * t5_14 + R4_33 * t5_15 + Pdot4_3;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_16 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_17 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_18 = omega5_2 * T(0.1);
  const T t5_19 = omega5_1 * T(0.2) - t5_18;
  const T v5_1 = R5_11 * t5_16 + R5_21 * t5_17 + R5_31 * t5_19 + Pdot5_1;
  const T v5_2 = R5_12 * t5_16 + R5_22 * t5_17 + R5_32 * t5_19 + Pdot5_2;
  const T v5_3 = R5_13 * t5_16 + R5_23 * t5_17 + R5_33 * t5_19 + Pdot5_3;
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
  const T t6_14 = t5_18 - t6_13;
  const T t6_15 = t6_13 - omega5_1 * T(0.1);
  const T t6_16 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = R5_11 * t6_14 + R5_21 * t6_15 + R5_31 * t6_16 + Pdot5_1;
  const T Pdot6_2 = R5_12 * t6_14 + R5_22 * t6_15 + R5_32 * t6_16 + Pdot5_2;
  const T Pdot6_3 = R5_13 * t6_14 + R5_23 * t6_15 + R5_33 * t6_16 + Pdot5_3;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_17 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_18 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_19 = omega6_2 * T(0.1);
  const T t6_20 = omega6_1 * T(0.2) - t6_19;
  const T v6_1 = R6_11 * t6_17 + R6_21 * t6_18 + R6_31 * t6_20 + Pdot6_1;
  const T v6_2 = R6_12 * t6_17 + R6_22 * t6_18 + R6_32 * t6_20 + Pdot6_2;
  const T v6_3 = R6_13 * t6_17 + R6_23 * t6_18 + R6_33 * t6_20 + Pdot6_3;
  // T6 = 1/2 omega6 . (I6 omega6) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (omega6_1 * (T(0.16) * omega6_1 + T(0.008) * omega6_2 + T(0.0048) * omega6_3) + omega6_2 *
      (T(0.008) * omega6_1 + T(0.192) * omega6_2 - T(0.0064) * omega6_3) + omega6_3 * (T(0.0048) * omega6_1 -
      T(0.0064) * omega6_2 + T(0.128) * omega6_3)) + T(0.8) * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- body 7 (body_7) on body 6
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  // R7^T = 1 + 2 e7~ (eps4_7 + e7~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t7_1 = T(2) * eps7_2;
  const T t7_2 = t7_1 * eps7_2;
  const T t7_3 = T(2) * eps7_3;
  const T t7_4 = t7_3 * eps7_3;
  const T R7_11 = T(1) - t7_2 - t7_4;
  const T t7_5 = T(2) * eps7_1;
  const T t7_6 = t7_5 * eps7_2;
  const T t7_7 = t7_3 * eps7_4;
  const T R7_12 = t7_6 + t7_7;
  const T t7_8 = t7_5 * eps7_3;
  const T t7_9 = t7_1 * eps7_4;
  const T R7_13 = t7_8 - t7_9;
  const T R7_21 = t7_6 - t7_7;
  const T t7_10 = T(1) - t7_5 * eps7_1;
  const T R7_22 = t7_10 - t7_4;
  const T t7_11 = t7_1 * eps7_3;
  const T t7_12 = t7_5 * eps7_4;
  const T R7_23 = t7_11 + t7_12;
  const T R7_31 = t7_8 + t7_9;
  const T R7_32 = t7_11 - t7_12;
  const T R7_33 = t7_10 - t7_2;
  // P7 = R6^T q7 + P6: position of the body origin, inertial axes [m]
  const T P7_3 = R6_13 * T(0.3) + R6_23 * T(0.35) + R6_33 * T(0.1) + P6_3;
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_3 = R7_13 * T(0.1) + R7_23 * T(0.2) + R7_33 * T(0.05) + P7_3;
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_13 = t6_19 - omega6_3 * T(0.35);
  const T t7_14 = omega6_3 * T(0.3) - omega6_1 * T(0.1);
  const T t7_15 = omega6_1 * T(0.35) - omega6_2 * T(0.3);
  const T Pdot7_1 = R6_11 * t7_13 + R6_21 * t7_14 + R6_31 * t7_15 + Pdot6_1;
  const T Pdot7_2 = R6_12 * t7_13 + R6_22 * t7_14 + R6_32 * t7_15 + Pdot6_2;
  const T Pdot7_3 = R6_13 * t7_13 + R6_23 * t7_14 + R6_33 * t7_15 + Pdot6_3;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_16 = omega7_2 * T(0.05) - omega7_3 * T(0.2);
  const T t7_17 = omega7_3 * T(0.1) - omega7_1 * T(0.05);
  const T t7_18 = omega7_2 * T(0.1);
  const T t7_19 = omega7_1 * T(0.2) - t7_18;
  const T v7_1 = R7_11 * t7_16 + R7_21 * t7_17 + R7_31 * t7_19 + Pdot7_1;
  const T v7_2 = R7_12 * t7_16 + R7_22 * t7_17 + R7_32 * t7_19 + Pdot7_2;
  const T v7_3 = R7_13 * t7_16 + R7_23 * t7_17 + R7_33 * t7_19 + Pdot7_3;
  // T7 = 1/2 omega7 . (I7 omega7) + 1/2 m7 v7 . v7: kinetic energy [J]
  const T T7 = T(0.5) * (omega7_1 * (T(0.17) * omega7_1 + T(0.0085) * omega7_2 + T(0.0051) * omega7_3) + omega7_2 *
      (T(0.0085) * omega7_1 + T(0.204) * omega7_2 - T(0.0068) * omega7_3) + omega7_3 * (T(0.0051) * omega7_1 -
      T(0.0068) * omega7_2 + T(0.136) * omega7_3)) + T(0.85) * (v7_1 * v7_1 + v7_2 * v7_2 + v7_3 * v7_3);

  // ---- body 8 (body_8) on body 7
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  // R8^T = 1 + 2 e8~ (eps4_8 + e8~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t8_1 = T(2) * eps8_2;
  const T t8_2 = t8_1 * eps8_2;
  const T t8_3 = T(2) * eps8_3;
  const T t8_4 = t8_3 * eps8_3;
  const T R8_11 = T(1) - t8_2 - t8_4;
  const T t8_5 = T(2) * eps8_1;
  const T t8_6 = t8_5 * eps8_2;
  const T t8_7 = t8_3 * eps8_4;
  const T R8_12 = t8_6 + t8_7;
  const T t8_8 = t8_5 * eps8_3;
  const T t8_9 = t8_1 * eps8_4;
  const T R8_13 = t8_8 - t8_9;
  const T R8_21 = t8_6 - t8_7;
  const T t8_10 = T(1) - t8_5 * eps8_1;
  const T R8_22 = t8_10 - t8_4;
  const T t8_11 = t8_1 * eps8_3;
  const T t8_12 = t8_5 * eps8_4;
  const T R8_23 = t8_11 + t8_12;
  const T R8_31 = t8_8 + t8_9;
  const T R8_32 = t8_11 - t8_12;
  const T R8_33 = t8_10 - t8_2;
  // P8 = R7^T q8 + P7: position of the body origin, inertial axes [m]
  const T P8_3 = R7_13 * T(0.3) + R7_23 * T(0.4) + R7_33 * T(0.1) + P7_3;
  // p8 = R8^T r8 + P8: position of the mass centre, inertial axes [m]
  const T p8_3 = R8_13 * T(0.1) + R8_23 * T(0.2) + R8_33 * T(0.05) + P8_3;
  // Pdot8 = R7^T omega7~ q8 + Pdot7: velocity of the body origin, inertial axes [m/s]
  const T t8_13 = t7_18 - omega7_3 * T(0.4);
  const T t8_14 = omega7_3 * T(0.3) - omega7_1 * T(0.1);
  const T t8_15 = omega7_1 * T(0.4) - omega7_2 * T(0.3);
  const T Pdot8_1 = R7_11 * t8_13 + R7_21 * t8_14 + R7_31 * t8_15 + Pdot7_1;
  const T Pdot8_2 = R7_12 * t8_13 + R7_22 * t8_14 + R7_32 * t8_15 + Pdot7_2;
  const T Pdot8_3 = R7_13 * t8_13 + R7_23 * t8_14 + R7_33 * t8_15 + Pdot7_3;
  // v8 = R8^T omega8~ r8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_16 = omega8_2 * T(0.05) - omega8_3 * T(0.2);
  const T t8_17 = omega8_3 * T(0.1) - omega8_1 * T(0.05);
  const T t8_18 = omega8_2 * T(0.1);
  const T t8_19 = omega8_1 * T(0.2) - t8_18;
  const T v8_1 = R8_11 * t8_16 + R8_21 * t8_17 + R8_31 * t8_19 + Pdot8_1;
  const T v8_2 = R8_12 * t8_16 + R8_22 * t8_17 + R8_32 * t8_19 + Pdot8_2;
  const T v8_3 = R8_13 * t8_16 + R8_23 * t8_17 + R8_33 * t8_19 + Pdot8_3;
  // T8 = 1/2 omega8 . (I8 omega8) + 1/2 m8 v8 . v8: kinetic energy [J]
  const T T8 = T(0.5) * (omega8_1 * (T(0.18) * omega8_1 + T(0.009) * omega8_2 + T(0.0054) * omega8_3) + omega8_2 *
      (T(0.009) * omega8_1 + T(0.216) * omega8_2 - T(0.0072) * omega8_3) + omega8_3 * (T(0.0054) * omega8_1 -
      T(0.0072) * omega8_2 + T(0.144) * omega8_3)) + T(0.9) * (v8_1 * v8_1 + v8_2 * v8_2 + v8_3 * v8_3);

  // ---- body 9 (body_9) on body 8
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  // R9^T = 1 + 2 e9~ (eps4_9 + e9~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t9_1 = T(2) * eps9_2;
  const T t9_2 = t9_1 * eps9_2;
  const T t9_3 = T(2) * eps9_3;
  const T t9_4 = t9_3 * eps9_3;
  const T R9_11 = T(1) - t9_2 - t9_4;
  const T t9_5 = T(2) * eps9_1;
  const T t9_6 = t9_5 * eps9_2;
  const T t9_7 = t9_3 * eps9_4;
  const T R9_12 = t9_6 + t9_7;
  const T t9_8 = t9_5 * eps9_3;
  const T t9_9 = t9_1 * eps9_4;
  const T R9_13 = t9_8 - t9_9;
  const T R9_21 = t9_6 - t9_7;
  const T t9_10 = T(1) - t9_5 * eps9_1;
  const T R9_22 = t9_10 - t9_4;
  const T t9_11 = t9_1 * eps9_3;
  const T t9_12 = t9_5 * eps9_4;
  const T R9_23 = t9_11 + t9_12;
  const T R9_31 = t9_8 + t9_9;
  const T R9_32 = t9_11 - t9_12;
  const T R9_33 = t9_10 - t9_2;
  // P9 = R8^T q9 + P8: position of the body origin, inertial axes [m]
  const T P9_3 = R8_13 * T(0.3) + R8_23 * T(0.45) + R8_33 * T(0.1) + P8_3;
  // p9 = R9^T r9 + P9: position of the mass centre, inertial axes [m]
  const T p9_3 = R9_13 * T(0.1) + R9_23 * T(0.2) + R9_33 * T(0.05) + P9_3;
  // Pdot9 = R8^T omega8~ q9 + Pdot8: velocity of the body origin, inertial axes [m/s]
  const T t9_13 = t8_18 - omega8_3 * T(0.45);
  const T t9_14 = omega8_3 * T(0.3) - omega8_1 * T(0.1);
  const T t9_15 = omega8_1 * T(0.45) - omega8_2 * T(0.3);
  const T Pdot9_1 = R8_11 * t9_13 + R8_21 * t9_14 + R8_31 * t9_15 + Pdot8_1;
  const T Pdot9_2 = R8_12 * t9_13 + R8_22 * t9_14 + R8_32 * t9_15 + Pdot8_2;
  const T Pdot9_3 = R8_13 * t9_13 + R8_23 * t9_14 + R8_33 * t9_15 + Pdot8_3;
  // v9 = R9^T omega9~ r9 + Pdot9: velocity of the mass centre, inertial axes [m/s]
  const T t9_16 = omega9_2 * T(0.05) - omega9_3 * T(0.2);
  const T t9_17 = omega9_3 * T(0.1) - omega9_1 * T(0.05);
  const T t9_18 = omega9_2 * T(0.1);
  const T t9_19 = omega9_1 * T(0.2) - t9_18;
  const T v9_1 = R9_11 * t9_16 + R9_21 * t9_17 + R9_31 * t9_19 + Pdot9_1;
  const T v9_2 = R9_12 * t9_16 + R9_22 * t9_17 + R9_32 * t9_19 + Pdot9_2;
  const T v9_3 = R9_13 * t9_16 + R9_23 * t9_17 + R9_33 * t9_19 + Pdot9_3;
  // T9 = 1/2 omega9 . (I9 omega9) + 1/2 m9 v9 . v9: kinetic energy [J]
  const T T9 = T(0.5) * (omega9_1 * (T(0.19) * omega9_1 + T(0.0095) * omega9_2 + T(0.0057) * omega9_3) + omega9_2 *
      (T(0.0095) * omega9_1 + T(0.228) * omega9_2 - T(0.0076) * omega9_3) + omega9_3 * (T(0.0057) * omega9_1 -
      T(0.0076) * omega9_2 + T(0.152) * omega9_3)) + T(0.95) * (v9_1 * v9_1 + v9_2 * v9_2 + v9_3 * v9_3);

  // ---- body 10 (body_10) on body 9
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // P10 = R9^T q10 + P9: position of the body origin, inertial axes [m]
  const T P10_3 = R9_13 * T(0.3) + R9_23 * T(0.5) + R9_33 * T(0.1) + P9_3;
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_3 = R10_13 * T(0.1) + R10_23 * T(0.2) + R10_33 * T(0.05) + P10_3;
  // Pdot10 = R9^T omega9~ q10 + Pdot9: velocity of the body origin, inertial axes [m/s]
  const T t10_13 = t9_18 - T(0.5) * omega9_3;
  const T t10_14 = omega9_3 * T(0.3) - omega9_1 * T(0.1);
  const T t10_15 = T(0.5) * omega9_1 - omega9_2 * T(0.3);
  const T Pdot10_1 = R9_11 * t10_13 + R9_21 * t10_14 + R9_31 * t10_15 + Pdot9_1;
  const T Pdot10_2 = R9_12 * t10_13 + R9_22 * t10_14 + R9_32 * t10_15 + Pdot9_2;
  const T Pdot10_3 = R9_13 * t10_13 + R9_23 * t10_14 + R9_33 * t10_15 + Pdot9_3;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_16 = omega10_2 * T(0.05) - omega10_3 * T(0.2);
  const T t10_17 = omega10_3 * T(0.1) - omega10_1 * T(0.05);
  const T t10_18 = T(0.2) * omega10_1;
  const T t10_19 = omega10_2 * T(0.1);
  const T t10_20 = t10_18 - t10_19;
  const T v10_1 = R10_11 * t10_16 + R10_21 * t10_17 + R10_31 * t10_20 + Pdot10_1;
  const T v10_2 = R10_12 * t10_16 + R10_22 * t10_17 + R10_32 * t10_20 + Pdot10_2;
  const T v10_3 = R10_13 * t10_16 + R10_23 * t10_17 + R10_33 * t10_20 + Pdot10_3;
  // T10 = 1/2 omega10 . (I10 omega10) + 1/2 m10 v10 . v10: kinetic energy [J]
  const T T10 = T(0.5) * (omega10_1 * (t10_18 + T(0.01) * omega10_2 + T(0.006) * omega10_3) + omega10_2 * (T(0.01) *
      omega10_1 + T(0.24) * omega10_2 - T(0.008) * omega10_3) + omega10_3 * (T(0.006) * omega10_1 - T(0.008) *
      omega10_2 + T(0.16) * omega10_3)) + v10_1 * v10_1 + v10_2 * v10_2 + v10_3 * v10_3;

  // ---- body 11 (body_11) on body 10
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  // R11^T = 1 + 2 e11~ (eps4_11 + e11~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t11_1 = T(2) * eps11_2;
  const T t11_2 = t11_1 * eps11_2;
  const T t11_3 = T(2) * eps11_3;
  const T t11_4 = t11_3 * eps11_3;
  const T R11_11 = T(1) - t11_2 - t11_4;
  const T t11_5 = T(2) * eps11_1;
  const T t11_6 = t11_5 * eps11_2;
  const T t11_7 = t11_3 * eps11_4;
  const T R11_12 = t11_6 + t11_7;
  const T t11_8 = t11_5 * eps11_3;
  const T t11_9 = t11_1 * eps11_4;
  const T R11_13 = t11_8 - t11_9;
  const T R11_21 = t11_6 - t11_7;
  const T t11_10 = T(1) - t11_5 * eps11_1;
  const T R11_22 = t11_10 - t11_4;
  const T t11_11 = t11_1 * eps11_3;
  const T t11_12 = t11_5 * eps11_4;
  const T R11_23 = t11_11 + t11_12;
  const T R11_31 = t11_8 + t11_9;
  const T R11_32 = t11_11 - t11_12;
  const T R11_33 = t11_10 - t11_2;
  // P11 = R10^T q11 + P10: position of the body origin, inertial axes [m]
  const T P11_3 = R10_13 * T(0.3) + R10_23 * T(0.55) + R10_33 * T(0.1) + P10_3;
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T p11_3 = R11_13 * T(0.1) + R11_23 * T(0.2) + R11_33 * T(0.05) + P11_3;
  // Pdot11 = R10^T omega10~ q11 + Pdot10: velocity of the body origin, inertial axes [m/s]
  const T t11_13 = t10_19 - omega10_3 * T(0.55);
  const T t11_14 = omega10_3 * T(0.3) - omega10_1 * T(0.1);
  const T t11_15 = omega10_1 * T(0.55) - omega10_2 * T(0.3);
  const T Pdot11_1 = R10_11 * t11_13 + R10_21 * t11_14 + R10_31 * t11_15 + Pdot10_1;
  const T Pdot11_2 = R10_12 * t11_13 + R10_22 * t11_14 + R10_32 * t11_15 + Pdot10_2;
  const T Pdot11_3 = R10_13 * t11_13 + R10_23 * t11_14 + R10_33 * t11_15 + Pdot10_3;
  // v11 = R11^T omega11~ r11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_16 = omega11_2 * T(0.05) - omega11_3 * T(0.2);
  const T t11_17 = omega11_3 * T(0.1) - omega11_1 * T(0.05);
  const T t11_18 = omega11_2 * T(0.1);
  const T t11_19 = omega11_1 * T(0.2) - t11_18;
  const T v11_1 = R11_11 * t11_16 + R11_21 * t11_17 + R11_31 * t11_19 + Pdot11_1;
  const T v11_2 = R11_12 * t11_16 + R11_22 * t11_17 + R11_32 * t11_19 + Pdot11_2;
  const T v11_3 = R11_13 * t11_16 + R11_23 * t11_17 + R11_33 * t11_19 + Pdot11_3;
  // T11 = 1/2 omega11 . (I11 omega11) + 1/2 m11 v11 . v11: kinetic energy [J]
  const T T11 = T(0.5) * (omega11_1 * (T(0.21) * omega11_1 + T(0.0105) * omega11_2 + T(0.0063) * omega11_3) +
      omega11_2 * (T(0.0105) * omega11_1 + T(0.252) * omega11_2 - T(0.0084) * omega11_3) + omega11_3 * (T(0.0063) *
      omega11_1 - T(0.0084) * omega11_2 + T(0.168) * omega11_3)) + T(1.05) * (v11_1 * v11_1 + v11_2 * v11_2 + v11_3 *
      v11_3);

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  // R12^T = 1 + 2 e12~ (eps4_12 + e12~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t12_1 = T(2) * eps12_2;
  const T t12_2 = t12_1 * eps12_2;
  const T t12_3 = T(2) * eps12_3;
  const T t12_4 = t12_3 * eps12_3;
  const T R12_11 = T(1) - t12_2 - t12_4;
  const T t12_5 = T(2) * eps12_1;
  const T t12_6 = t12_5 * eps12_2;
  const T t12_7 = t12_3 * eps12_4;
  const T R12_12 = t12_6 + t12_7;
  const T t12_8 = t12_5 * eps12_3;
  const T t12_9 = t12_1 * eps12_4;
  const T R12_13 = t12_8 - t12_9;
  const T R12_21 = t12_6 - t12_7;
  const T t12_10 = T(1) - t12_5 * eps12_1;
  const T R12_22 = t12_10 - t12_4;
  const T t12_11 = t12_1 * eps12_3;
  const T t12_12 = t12_5 * eps12_4;
  const T R12_23 = t12_11 + t12_12;
  const T R12_31 = t12_8 + t12_9;
  const T R12_32 = t12_11 - t12_12;
  const T R12_33 = t12_10 - t12_2;
  // P12 = R11^T q12 + P11: position of the body origin, inertial axes [m]
  const T P12_3 = R11_13 * T(0.3) + R11_23 * T(0.6) + R11_33 * T(0.1) + P11_3;
  // p12 = R12^T r12 + P12: position of the mass centre, inertial axes [m]
  const T p12_3 = R12_13 * T(0.1) + R12_23 * T(0.2) + R12_33 * T(0.05) + P12_3;
  // Pdot12 = R11^T omega11~ q12 + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_13 = t11_18 - omega11_3 * T(0.6);
  const T t12_14 = omega11_3 * T(0.3) - omega11_1 * T(0.1);
  const T t12_15 = omega11_1 * T(0.6) - omega11_2 * T(0.3);
  const T Pdot12_1 = R11_11 * t12_13 + R11_21 * t12_14 + R11_31 * t12_15 + Pdot11_1;
  const T Pdot12_2 = R11_12 * t12_13 + R11_22 * t12_14 + R11_32 * t12_15 + Pdot11_2;
  const T Pdot12_3 = R11_13 * t12_13 + R11_23 * t12_14 + R11_33 * t12_15 + Pdot11_3;
  // v12 = R12^T omega12~ r12 + Pdot12: velocity of the mass centre, inertial axes [m/s]
  const T t12_16 = omega12_2 * T(0.05) - omega12_3 * T(0.2);
  const T t12_17 = omega12_3 * T(0.1) - omega12_1 * T(0.05);
  const T t12_18 = omega12_2 * T(0.1);
  const T t12_19 = omega12_1 * T(0.2) - t12_18;
  const T v12_1 = R12_11 * t12_16 + R12_21 * t12_17 + R12_31 * t12_19 + Pdot12_1;
  const T v12_2 = R12_12 * t12_16 + R12_22 * t12_17 + R12_32 * t12_19 + Pdot12_2;
  const T v12_3 = R12_13 * t12_16 + R12_23 * t12_17 + R12_33 * t12_19 + Pdot12_3;
  // T12 = 1/2 omega12 . (I12 omega12) + 1/2 m12 v12 . v12: kinetic energy [J]
  const T T12 = T(0.5) * (omega12_1 * (T(0.22) * omega12_1 + T(0.011) * omega12_2 + T(0.0066) * omega12_3) + omega12_2
      * (T(0.011) * omega12_1 + T(0.264) * omega12_2 - T(0.0088) * omega12_3) + omega12_3 * (T(0.0066) * omega12_1 -
      T(0.0088) * omega12_2 + T(0.176) * omega12_3)) + T(1.1) * (v12_1 * v12_1 + v12_2 * v12_2 + v12_3 * v12_3);

  // ---- body 13 (body_13) on body 12
  const T eps13_1 = x[48], eps13_2 = x[49], eps13_3 = x[50], eps13_4 = x[51];
  const T omega13_1 = y[36], omega13_2 = y[37], omega13_3 = y[38];
  // R13^T = 1 + 2 e13~ (eps4_13 + e13~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t13_1 = T(2) * eps13_2;
  const T t13_2 = t13_1 * eps13_2;
  const T t13_3 = T(2) * eps13_3;
  const T t13_4 = t13_3 * eps13_3;
  const T R13_11 = T(1) - t13_2 - t13_4;
  const T t13_5 = T(2) * eps13_1;
  const T t13_6 = t13_5 * eps13_2;
  const T t13_7 = t13_3 * eps13_4;
  const T R13_12 = t13_6 + t13_7;
  const T t13_8 = t13_5 * eps13_3;
  const T t13_9 = t13_1 * eps13_4;
  const T R13_13 = t13_8 - t13_9;
  const T R13_21 = t13_6 - t13_7;
  const T t13_10 = T(1) - t13_5 * eps13_1;
  const T R13_22 = t13_10 - t13_4;
  const T t13_11 = t13_1 * eps13_3;
  const T t13_12 = t13_5 * eps13_4;
  const T R13_23 = t13_11 + t13_12;
  const T R13_31 = t13_8 + t13_9;
  const T R13_32 = t13_11 - t13_12;
  const T R13_33 = t13_10 - t13_2;
  // P13 = R12^T q13 + P12: position of the body origin, inertial axes [m]
  const T P13_3 = R12_13 * T(0.3) + R12_23 * T(0.65) + R12_33 * T(0.1) + P12_3;
  // p13 = R13^T r13 + P13: position of the mass centre, inertial axes [m]
  const T p13_3 = R13_13 * T(0.1) + R13_23 * T(0.2) + R13_33 * T(0.05) + P13_3;
  // Pdot13 = R12^T omega12~ q13 + Pdot12: velocity of the body origin, inertial axes [m/s]
  const T t13_13 = t12_18 - omega12_3 * T(0.65);
  const T t13_14 = omega12_3 * T(0.3) - omega12_1 * T(0.1);
  const T t13_15 = omega12_1 * T(0.65) - omega12_2 * T(0.3);
  const T Pdot13_1 = R12_11 * t13_13 + R12_21 * t13_14 + R12_31 * t13_15 + Pdot12_1;
  const T Pdot13_2 = R12_12 * t13_13 + R12_22 * t13_14 + R12_32 * t13_15 + Pdot12_2;
  const T Pdot13_3 = R12_13 * t13_13 + R12_23 * t13_14 + R12_33 * t13_15 + Pdot12_3;
  // v13 = R13^T omega13~ r13 + Pdot13: velocity of the mass centre, inertial axes [m/s]
  const T t13_16 = omega13_2 * T(0.05) - omega13_3 * T(0.2);
  const T t13_17 = omega13_3 * T(0.1) - omega13_1 * T(0.05);
  const T t13_18 = omega13_2 * T(0.1);
  const T t13_19 = omega13_1 * T(0.2) - t13_18;
  const T v13_1 = R13_11 * t13_16 + R13_21 * t13_17 + R13_31 * t13_19 + Pdot13_1;
  const T v13_2 = R13_12 * t13_16 + R13_22 * t13_17 + R13_32 * t13_19 + Pdot13_2;
  const T v13_3 = R13_13 * t13_16 + R13_23 * t13_17 + R13_33 * t13_19 + Pdot13_3;
  // T13 = 1/2 omega13 . (I13 omega13) + 1/2 m13 v13 . v13: kinetic energy [J]
  const T T13 = T(0.5) * (omega13_1 * (T(0.23) * omega13_1 + T(0.0115) * omega13_2 + T(0.0069) * omega13_3) +
      omega13_2 * (T(0.0115) * omega13_1 + T(0.276) * omega13_2 - T(0.0092) * omega13_3) + omega13_3 * (T(0.0069) *
      omega13_1 - T(0.0092) * omega13_2 + T(0.184) * omega13_3)) + T(1.15) * (v13_1 * v13_1 + v13_2 * v13_2 + v13_3 *
      v13_3);

  // ---- body 14 (body_14) on body 13
  const T eps14_1 = x[52], eps14_2 = x[53], eps14_3 = x[54], eps14_4 = x[55];
  const T omega14_1 = y[39], omega14_2 = y[40], omega14_3 = y[41];
  // R14^T = 1 + 2 e14~ (eps4_14 + e14~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t14_1 = T(2) * eps14_2;
  const T t14_2 = t14_1 * eps14_2;
  const T t14_3 = T(2) * eps14_3;
  const T t14_4 = t14_3 * eps14_3;
  const T R14_11 = T(1) - t14_2 - t14_4;
  const T t14_5 = T(2) * eps14_1;
  const T t14_6 = t14_5 * eps14_2;
  const T t14_7 = t14_3 * eps14_4;
  const T R14_12 = t14_6 + t14_7;
  const T t14_8 = t14_5 * eps14_3;
  const T t14_9 = t14_1 * eps14_4;
  const T R14_13 = t14_8 - t14_9;
  const T R14_21 = t14_6 - t14_7;
  const T t14_10 = T(1) - t14_5 * eps14_1;
  const T R14_22 = t14_10 - t14_4;
  const T t14_11 = t14_1 * eps14_3;
  const T t14_12 = t14_5 * eps14_4;
  const T R14_23 = t14_11 + t14_12;
  const T R14_31 = t14_8 + t14_9;
  const T R14_32 = t14_11 - t14_12;
  const T R14_33 = t14_10 - t14_2;
  // P14 = R13^T q14 + P13: position of the body origin, inertial axes [m]
  const T P14_3 = R13_13 * T(0.3) + R13_23 * T(0.7) + R13_33 * T(0.1) + P13_3;
  // p14 = R14^T r14 + P14: position of the mass centre, inertial axes [m]
  const T p14_3 = R14_13 * T(0.1) + R14_23 * T(0.2) + R14_33 * T(0.05) + P14_3;
  // Pdot14 = R13^T omega13~ q14 + Pdot13: velocity of the body origin, inertial axes [m/s]
  const T t14_13 = t13_18 - omega13_3 * T(0.7);
  const T t14_14 = omega13_3 * T(0.3) - omega13_1 * T(0.1);
  const T t14_15 = omega13_1 * T(0.7) - omega13_2 * T(0.3);
  const T Pdot14_1 = R13_11 * t14_13 + R13_21 * t14_14 + R13_31 * t14_15 + Pdot13_1;
  const T Pdot14_2 = R13_12 * t14_13 + R13_22 * t14_14 + R13_32 * t14_15 + Pdot13_2;
  const T Pdot14_3 = R13_13 * t14_13 + R13_23 * t14_14 + R13_33 * t14_15 + Pdot13_3;
  // v14 = R14^T omega14~ r14 + Pdot14: velocity of the mass centre, inertial axes [m/s]
  const T t14_16 = omega14_2 * T(0.05) - omega14_3 * T(0.2);
  const T t14_17 = omega14_3 * T(0.1) - omega14_1 * T(0.05);
  const T t14_18 = omega14_2 * T(0.1);
  const T t14_19 = omega14_1 * T(0.2) - t14_18;
  const T v14_1 = R14_11 * t14_16 + R14_21 * t14_17 + R14_31 * t14_19 + Pdot14_1;
  const T v14_2 = R14_12 * t14_16 + R14_22 * t14_17 + R14_32 * t14_19 + Pdot14_2;
  const T v14_3 = R14_13 * t14_16 + R14_23 * t14_17 + R14_33 * t14_19 + Pdot14_3;
  // T14 = 1/2 omega14 . (I14 omega14) + 1/2 m14 v14 . v14: kinetic energy [J]
  const T T14 = T(0.5) * (omega14_1 * (T(0.24) * omega14_1 + T(0.012) * omega14_2 + T(0.0072) * omega14_3) + omega14_2
      * (T(0.012) * omega14_1 + T(0.288) * omega14_2 - T(0.0096) * omega14_3) + omega14_3 * (T(0.0072) * omega14_1 -
      T(0.0096) * omega14_2 + T(0.192) * omega14_3)) + T(1.2) * (v14_1 * v14_1 + v14_2 * v14_2 + v14_3 * v14_3);

  // ---- body 15 (body_15) on body 14
  const T eps15_1 = x[56], eps15_2 = x[57], eps15_3 = x[58], eps15_4 = x[59];
  const T omega15_1 = y[42], omega15_2 = y[43], omega15_3 = y[44];
  // R15^T = 1 + 2 e15~ (eps4_15 + e15~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t15_1 = T(2) * eps15_2;
  const T t15_2 = t15_1 * eps15_2;
  const T t15_3 = T(2) * eps15_3;
  const T t15_4 = t15_3 * eps15_3;
  const T R15_11 = T(1) - t15_2 - t15_4;
  const T t15_5 = T(2) * eps15_1;
  const T t15_6 = t15_5 * eps15_2;
  const T t15_7 = t15_3 * eps15_4;
  const T R15_12 = t15_6 + t15_7;
  const T t15_8 = t15_5 * eps15_3;
  const T t15_9 = t15_1 * eps15_4;
  const T R15_13 = t15_8 - t15_9;
  const T R15_21 = t15_6 - t15_7;
  const T t15_10 = T(1) - t15_5 * eps15_1;
  const T R15_22 = t15_10 - t15_4;
  const T t15_11 = t15_1 * eps15_3;
  const T t15_12 = t15_5 * eps15_4;
  const T R15_23 = t15_11 + t15_12;
  const T R15_31 = t15_8 + t15_9;
  const T R15_32 = t15_11 - t15_12;
  const T R15_33 = t15_10 - t15_2;
  // P15 = R14^T q15 + P14: position of the body origin, inertial axes [m]
  const T P15_3 = R14_13 * T(0.3) + R14_23 * T(0.75) + R14_33 * T(0.1) + P14_3;
  // p15 = R15^T r15 + P15: position of the mass centre, inertial axes [m]
  const T p15_3 = R15_13 * T(0.1) + R15_23 * T(0.2) + R15_33 * T(0.05) + P15_3;
  // Pdot15 = R14^T omega14~ q15 + Pdot14: velocity of the body origin, inertial axes [m/s]
  const T t15_13 = t14_18 - omega14_3 * T(0.75);
  const T t15_14 = omega14_3 * T(0.3) - omega14_1 * T(0.1);
  const T t15_15 = omega14_1 * T(0.75) - omega14_2 * T(0.3);
  const T Pdot15_1 = R14_11 * t15_13 + R14_21 * t15_14 + R14_31 * t15_15 + Pdot14_1;
  const T Pdot15_2 = R14_12 * t15_13 + R14_22 * t15_14 + R14_32 * t15_15 + Pdot14_2;
  const T Pdot15_3 = R14_13 * t15_13 + R14_23 * t15_14 + R14_33 * t15_15 + Pdot14_3;
  // v15 = R15^T omega15~ r15 + Pdot15: velocity of the mass centre, inertial axes [m/s]
  const T t15_16 = T(0.2) * omega15_3;
  const T t15_17 = omega15_2 * T(0.05) - t15_16;
  const T t15_18 = omega15_3 * T(0.1) - omega15_1 * T(0.05);
  const T t15_19 = omega15_2 * T(0.1);
  const T t15_20 = omega15_1 * T(0.2) - t15_19;
  const T v15_1 = R15_11 * t15_17 + R15_21 * t15_18 + R15_31 * t15_20 + Pdot15_1;
  const T v15_2 = R15_12 * t15_17 + R15_22 * t15_18 + R15_32 * t15_20 + Pdot15_2;
  const T v15_3 = R15_13 * t15_17 + R15_23 * t15_18 + R15_33 * t15_20 + Pdot15_3;
  // T15 = 1/2 omega15 . (I15 omega15) + 1/2 m15 v15 . v15: kinetic energy [J]
  const T t15_21 = T(0.3) * omega15_2;
  const T T15 = T(0.5) * (omega15_1 * (T(0.25) * omega15_1 + T(0.0125) * omega15_2 + T(0.0075) * omega15_3) +
      omega15_2 * (T(0.0125) * omega15_1 + t15_21 - T(0.01) * omega15_3) + omega15_3 * (T(0.0075) * omega15_1 -
      T(0.01) * omega15_2 + t15_16)) + T(1.25) * (v15_1 * v15_1 + v15_2 * v15_2 + v15_3 * v15_3);

  // ---- body 16 (body_16) on body 15
  const T eps16_1 = x[60], eps16_2 = x[61], eps16_3 = x[62], eps16_4 = x[63];
  const T omega16_1 = y[45], omega16_2 = y[46], omega16_3 = y[47];
  // R16^T = 1 + 2 e16~ (eps4_16 + e16~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t16_1 = T(2) * eps16_2;
  const T t16_2 = t16_1 * eps16_2;
  const T t16_3 = T(2) * eps16_3;
  const T t16_4 = t16_3 * eps16_3;
  const T R16_11 = T(1) - t16_2 - t16_4;
  const T t16_5 = T(2) * eps16_1;
  const T t16_6 = t16_5 * eps16_2;
  const T t16_7 = t16_3 * eps16_4;
  const T R16_12 = t16_6 + t16_7;
  const T t16_8 = t16_5 * eps16_3;
  const T t16_9 = t16_1 * eps16_4;
  const T R16_13 = t16_8 - t16_9;
  const T R16_21 = t16_6 - t16_7;
  const T t16_10 = T(1) - t16_5 * eps16_1;
  const T R16_22 = t16_10 - t16_4;
  const T t16_11 = t16_1 * eps16_3;
  const T t16_12 = t16_5 * eps16_4;
  const T R16_23 = t16_11 + t16_12;
  const T R16_31 = t16_8 + t16_9;
  const T R16_32 = t16_11 - t16_12;
  const T R16_33 = t16_10 - t16_2;
  // P16 = R15^T q16 + P15: position of the body origin, inertial axes [m]
  const T P16_3 = R15_13 * T(0.3) + R15_23 * T(0.8) + R15_33 * T(0.1) + P15_3;
  // p16 = R16^T r16 + P16: position of the mass centre, inertial axes [m]
  const T p16_3 = R16_13 * T(0.1) + R16_23 * T(0.2) + R16_33 * T(0.05) + P16_3;
  // Pdot16 = R15^T omega15~ q16 + Pdot15: velocity of the body origin, inertial axes [m/s]
  const T t16_13 = t15_19 - omega15_3 * T(0.8);
  const T t16_14 = omega15_3 * T(0.3) - omega15_1 * T(0.1);
  const T t16_15 = omega15_1 * T(0.8) - t15_21;
  const T Pdot16_1 = R15_11 * t16_13 + R15_21 * t16_14 + R15_31 * t16_15 + Pdot15_1;
  const T Pdot16_2 = R15_12 * t16_13 + R15_22 * t16_14 + R15_32 * t16_15 + Pdot15_2;
  const T Pdot16_3 = R15_13 * t16_13 + R15_23 * t16_14 + R15_33 * t16_15 + Pdot15_3;
  // v16 = R16^T omega16~ r16 + Pdot16: velocity of the mass centre, inertial axes [m/s]
  const T t16_16 = omega16_2 * T(0.05) - omega16_3 * T(0.2);
  const T t16_17 = omega16_3 * T(0.1) - omega16_1 * T(0.05);
  const T t16_18 = omega16_2 * T(0.1);
  const T t16_19 = omega16_1 * T(0.2) - t16_18;
  const T v16_1 = R16_11 * t16_16 + R16_21 * t16_17 + R16_31 * t16_19 + Pdot16_1;
  const T v16_2 = R16_12 * t16_16 + R16_22 * t16_17 + R16_32 * t16_19 + Pdot16_2;
  const T v16_3 = R16_13 * t16_16 + R16_23 * t16_17 + R16_33 * t16_19 + Pdot16_3;
  // T16 = 1/2 omega16 . (I16 omega16) + 1/2 m16 v16 . v16: kinetic energy [J]
  const T T16 = T(0.5) * (omega16_1 * (T(0.26) * omega16_1 + T(0.013) * omega16_2 + T(0.0078) * omega16_3) + omega16_2
      * (T(0.013) * omega16_1 + T(0.312) * omega16_2 - T(0.0104) * omega16_3) + omega16_3 * (T(0.0078) * omega16_1 -
      T(0.0104) * omega16_2 + T(0.208) * omega16_3)) + T(1.3) * (v16_1 * v16_1 + v16_2 * v16_2 + v16_3 * v16_3);

  // ---- body 17 (body_17) on body 16
  const T eps17_1 = x[64], eps17_2 = x[65], eps17_3 = x[66], eps17_4 = x[67];
  const T omega17_1 = y[48], omega17_2 = y[49], omega17_3 = y[50];
  // R17^T = 1 + 2 e17~ (eps4_17 + e17~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t17_1 = T(2) * eps17_2;
  const T t17_2 = t17_1 * eps17_2;
  const T t17_3 = T(2) * eps17_3;
  const T t17_4 = t17_3 * eps17_3;
  const T R17_11 = T(1) - t17_2 - t17_4;
  const T t17_5 = T(2) * eps17_1;
  const T t17_6 = t17_5 * eps17_2;
  const T t17_7 = t17_3 * eps17_4;
  const T R17_12 = t17_6 + t17_7;
  const T t17_8 = t17_5 * eps17_3;
  const T t17_9 = t17_1 * eps17_4;
  const T R17_13 = t17_8 - t17_9;
  const T R17_21 = t17_6 - t17_7;
  const T t17_10 = T(1) - t17_5 * eps17_1;
  const T R17_22 = t17_10 - t17_4;
  const T t17_11 = t17_1 * eps17_3;
  const T t17_12 = t17_5 * eps17_4;
  const T R17_23 = t17_11 + t17_12;
  const T R17_31 = t17_8 + t17_9;
  const T R17_32 = t17_11 - t17_12;
  const T R17_33 = t17_10 - t17_2;
  // P17 = R16^T q17 + P16: position of the body origin, inertial axes [m]
  const T P17_3 = R16_13 * T(0.3) + R16_23 * T(0.85) + R16_33 * T(0.1) + P16_3;
  // p17 = R17^T r17 + P17: position of the mass centre, inertial axes [m]
  const T p17_3 = R17_13 * T(0.1) + R17_23 * T(0.2) + R17_33 * T(0.05) + P17_3;
  // Pdot17 = R16^T omega16~ q17 + Pdot16: velocity of the body origin, inertial axes [m/s]
  const T t17_13 = t16_18 - omega16_3 * T(0.85);
  const T t17_14 = omega16_3 * T(0.3) - omega16_1 * T(0.1);
  const T t17_15 = omega16_1 * T(0.85) - omega16_2 * T(0.3);
  const T Pdot17_1 = R16_11 * t17_13 + R16_21 * t17_14 + R16_31 * t17_15 + Pdot16_1;
  const T Pdot17_2 = R16_12 * t17_13 + R16_22 * t17_14 + R16_32 * t17_15 + Pdot16_2;
  const T Pdot17_3 = R16_13 * t17_13 + R16_23 * t17_14 + R16_33 * t17_15 + Pdot16_3;
  // v17 = R17^T omega17~ r17 + Pdot17: velocity of the mass centre, inertial axes [m/s]
  const T t17_16 = omega17_2 * T(0.05) - omega17_3 * T(0.2);
  const T t17_17 = omega17_3 * T(0.1) - omega17_1 * T(0.05);
  const T t17_18 = omega17_2 * T(0.1);
  const T t17_19 = omega17_1 * T(0.2) - t17_18;
  const T v17_1 = R17_11 * t17_16 + R17_21 * t17_17 + R17_31 * t17_19 + Pdot17_1;
  const T v17_2 = R17_12 * t17_16 + R17_22 * t17_17 + R17_32 * t17_19 + Pdot17_2;
  const T v17_3 = R17_13 * t17_16 + R17_23 * t17_17 + R17_33 * t17_19 + Pdot17_3;
  // T17 = 1/2 omega17 . (I17 omega17) + 1/2 m17 v17 . v17: kinetic energy [J]
  const T T17 = T(0.5) * (omega17_1 * (T(0.27) * omega17_1 + T(0.0135) * omega17_2 + T(0.0081) * omega17_3) +
      omega17_2 * (T(0.0135) * omega17_1 + T(0.324) * omega17_2 - T(0.0108) * omega17_3) + omega17_3 * (T(0.0081) *
      omega17_1 - T(0.0108) * omega17_2 + T(0.216) * omega17_3)) + T(1.35) * (v17_1 * v17_1 + v17_2 * v17_2 + v17_3 *
      v17_3);

  // ---- body 18 (body_18) on body 17
  const T eps18_1 = x[68], eps18_2 = x[69], eps18_3 = x[70], eps18_4 = x[71];
  const T omega18_1 = y[51], omega18_2 = y[52], omega18_3 = y[53];
  // R18^T = 1 + 2 e18~ (eps4_18 + e18~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t18_1 = T(2) * eps18_2;
  const T t18_2 = t18_1 * eps18_2;
  const T t18_3 = T(2) * eps18_3;
  const T t18_4 = t18_3 * eps18_3;
  const T R18_11 = T(1) - t18_2 - t18_4;
  const T t18_5 = T(2) * eps18_1;
  const T t18_6 = t18_5 * eps18_2;
  const T t18_7 = t18_3 * eps18_4;
  const T R18_12 = t18_6 + t18_7;
  const T t18_8 = t18_5 * eps18_3;
  const T t18_9 = t18_1 * eps18_4;
  const T R18_13 = t18_8 - t18_9;
  const T R18_21 = t18_6 - t18_7;
  const T t18_10 = T(1) - t18_5 * eps18_1;
  const T R18_22 = t18_10 - t18_4;
  const T t18_11 = t18_1 * eps18_3;
  const T t18_12 = t18_5 * eps18_4;
  const T R18_23 = t18_11 + t18_12;
  const T R18_31 = t18_8 + t18_9;
  const T R18_32 = t18_11 - t18_12;
  const T R18_33 = t18_10 - t18_2;
  // P18 = R17^T q18 + P17: position of the body origin, inertial axes [m]
  const T P18_3 = R17_13 * T(0.3) + R17_23 * T(0.9) + R17_33 * T(0.1) + P17_3;
  // p18 = R18^T r18 + P18: position of the mass centre, inertial axes [m]
  const T p18_3 = R18_13 * T(0.1) + R18_23 * T(0.2) + R18_33 * T(0.05) + P18_3;
  // Pdot18 = R17^T omega17~ q18 + Pdot17: velocity of the body origin, inertial axes [m/s]
  const T t18_13 = t17_18 - omega17_3 * T(0.9);
  const T t18_14 = omega17_3 * T(0.3) - omega17_1 * T(0.1);
  const T t18_15 = omega17_1 * T(0.9) - omega17_2 * T(0.3);
  const T Pdot18_1 = R17_11 * t18_13 + R17_21 * t18_14 + R17_31 * t18_15 + Pdot17_1;
  const T Pdot18_2 = R17_12 * t18_13 + R17_22 * t18_14 + R17_32 * t18_15 + Pdot17_2;
  const T Pdot18_3 = R17_13 * t18_13 + R17_23 * t18_14 + R17_33 * t18_15 + Pdot17_3;
  // v18 = R18^T omega18~ r18 + Pdot18: velocity of the mass centre, inertial axes [m/s]
  const T t18_16 = omega18_2 * T(0.05) - omega18_3 * T(0.2);
  const T t18_17 = omega18_3 * T(0.1) - omega18_1 * T(0.05);
  const T t18_18 = omega18_2 * T(0.1);
  const T t18_19 = omega18_1 * T(0.2) - t18_18;
  const T v18_1 = R18_11 * t18_16 + R18_21 * t18_17 + R18_31 * t18_19 + Pdot18_1;
  const T v18_2 = R18_12 * t18_16 + R18_22 * t18_17 + R18_32 * t18_19 + Pdot18_2;
  const T v18_3 = R18_13 * t18_16 + R18_23 * t18_17 + R18_33 * t18_19 + Pdot18_3;
  // T18 = 1/2 omega18 . (I18 omega18) + 1/2 m18 v18 . v18: kinetic energy [J]
  const T T18 = T(0.5) * (omega18_1 * (T(0.28) * omega18_1 + T(0.014) * omega18_2 + T(0.0084) * omega18_3) + omega18_2
      * (T(0.014) * omega18_1 + T(0.336) * omega18_2 - T(0.0112) * omega18_3) + omega18_3 * (T(0.0084) * omega18_1 -
      T(0.0112) * omega18_2 + T(0.224) * omega18_3)) + T(1.4) * (v18_1 * v18_1 + v18_2 * v18_2 + v18_3 * v18_3);

  // ---- body 19 (body_19) on body 18
  const T eps19_1 = x[72], eps19_2 = x[73], eps19_3 = x[74], eps19_4 = x[75];
  const T omega19_1 = y[54], omega19_2 = y[55], omega19_3 = y[56];
  // R19^T = 1 + 2 e19~ (eps4_19 + e19~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t19_1 = T(2) * eps19_2;
  const T t19_2 = t19_1 * eps19_2;
  const T t19_3 = T(2) * eps19_3;
  const T t19_4 = t19_3 * eps19_3;
  const T R19_11 = T(1) - t19_2 - t19_4;
  const T t19_5 = T(2) * eps19_1;
  const T t19_6 = t19_5 * eps19_2;
  const T t19_7 = t19_3 * eps19_4;
  const T R19_12 = t19_6 + t19_7;
  const T t19_8 = t19_5 * eps19_3;
  const T t19_9 = t19_1 * eps19_4;
  const T R19_13 = t19_8 - t19_9;
  const T R19_21 = t19_6 - t19_7;
  const T t19_10 = T(1) - t19_5 * eps19_1;
  const T R19_22 = t19_10 - t19_4;
  const T t19_11 = t19_1 * eps19_3;
  const T t19_12 = t19_5 * eps19_4;
  const T R19_23 = t19_11 + t19_12;
  const T R19_31 = t19_8 + t19_9;
  const T R19_32 = t19_11 - t19_12;
  const T R19_33 = t19_10 - t19_2;
  // P19 = R18^T q19 + P18: position of the body origin, inertial axes [m]
  const T P19_3 = R18_13 * T(0.3) + R18_23 * T(0.95) + R18_33 * T(0.1) + P18_3;
  // p19 = R19^T r19 + P19: position of the mass centre, inertial axes [m]
  const T p19_3 = R19_13 * T(0.1) + R19_23 * T(0.2) + R19_33 * T(0.05) + P19_3;
  // Pdot19 = R18^T omega18~ q19 + Pdot18: velocity of the body origin, inertial axes [m/s]
  const T t19_13 = t18_18 - omega18_3 * T(0.95);
  const T t19_14 = omega18_3 * T(0.3) - omega18_1 * T(0.1);
  const T t19_15 = omega18_1 * T(0.95) - omega18_2 * T(0.3);
  const T Pdot19_1 = R18_11 * t19_13 + R18_21 * t19_14 + R18_31 * t19_15 + Pdot18_1;
  const T Pdot19_2 = R18_12 * t19_13 + R18_22 * t19_14 + R18_32 * t19_15 + Pdot18_2;
  const T Pdot19_3 = R18_13 * t19_13 + R18_23 * t19_14 + R18_33 * t19_15 + Pdot18_3;
  // v19 = R19^T omega19~ r19 + Pdot19: velocity of the mass centre, inertial axes [m/s]
  const T t19_16 = omega19_2 * T(0.05) - omega19_3 * T(0.2);
  const T t19_17 = omega19_3 * T(0.1) - omega19_1 * T(0.05);
  const T t19_18 = omega19_2 * T(0.1);
  const T t19_19 = omega19_1 * T(0.2) - t19_18;
  const T v19_1 = R19_11 * t19_16 + R19_21 * t19_17 + R19_31 * t19_19 + Pdot19_1;
  const T v19_2 = R19_12 * t19_16 + R19_22 * t19_17 + R19_32 * t19_19 + Pdot19_2;
  const T v19_3 = R19_13 * t19_16 + R19_23 * t19_17 + R19_33 * t19_19 + Pdot19_3;
  // T19 = 1/2 omega19 . (I19 omega19) + 1/2 m19 v19 . v19: kinetic energy [J]
  const T T19 = T(0.5) * (omega19_1 * (T(0.29) * omega19_1 + T(0.0145) * omega19_2 + T(0.0087) * omega19_3) +
      omega19_2 * (T(0.0145) * omega19_1 + T(0.348) * omega19_2 - T(0.0116) * omega19_3) + omega19_3 * (T(0.0087) *
      omega19_1 - T(0.0116) * omega19_2 + T(0.232) * omega19_3)) + T(1.45) * (v19_1 * v19_1 + v19_2 * v19_2 + v19_3 *
      v19_3);

  // ---- body 20 (body_20) on body 19
  const T eps20_1 = x[76], eps20_2 = x[77], eps20_3 = x[78], eps20_4 = x[79];
  const T omega20_1 = y[57], omega20_2 = y[58], omega20_3 = y[59];
  // R20^T = 1 + 2 e20~ (eps4_20 + e20~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t20_1 = T(2) * eps20_2;
  const T t20_2 = t20_1 * eps20_2;
  const T t20_3 = T(2) * eps20_3;
  const T t20_4 = t20_3 * eps20_3;
  const T R20_11 = T(1) - t20_2 - t20_4;
  const T t20_5 = T(2) * eps20_1;
  const T t20_6 = t20_5 * eps20_2;
  const T t20_7 = t20_3 * eps20_4;
  const T R20_12 = t20_6 + t20_7;
  const T t20_8 = t20_5 * eps20_3;
  const T t20_9 = t20_1 * eps20_4;
  const T R20_13 = t20_8 - t20_9;
  const T R20_21 = t20_6 - t20_7;
  const T t20_10 = T(1) - t20_5 * eps20_1;
  const T R20_22 = t20_10 - t20_4;
  const T t20_11 = t20_1 * eps20_3;
  const T t20_12 = t20_5 * eps20_4;
  const T R20_23 = t20_11 + t20_12;
  const T R20_31 = t20_8 + t20_9;
  const T R20_32 = t20_11 - t20_12;
  const T R20_33 = t20_10 - t20_2;
  // P20 = R19^T q20 + P19: position of the body origin, inertial axes [m]
  const T P20_3 = R19_13 * T(0.3) + R19_23 + R19_33 * T(0.1) + P19_3;
  // p20 = R20^T r20 + P20: position of the mass centre, inertial axes [m]
  const T p20_3 = R20_13 * T(0.1) + R20_23 * T(0.2) + R20_33 * T(0.05) + P20_3;
  // Pdot20 = R19^T omega19~ q20 + Pdot19: velocity of the body origin, inertial axes [m/s]
  const T t20_13 = t19_18 - omega19_3;
  const T t20_14 = omega19_3 * T(0.3) - omega19_1 * T(0.1);
  const T t20_15 = omega19_1 - omega19_2 * T(0.3);
  const T Pdot20_1 = R19_11 * t20_13 + R19_21 * t20_14 + R19_31 * t20_15 + Pdot19_1;
  const T Pdot20_2 = R19_12 * t20_13 + R19_22 * t20_14 + R19_32 * t20_15 + Pdot19_2;
  const T Pdot20_3 = R19_13 * t20_13 + R19_23 * t20_14 + R19_33 * t20_15 + Pdot19_3;
  // v20 = R20^T omega20~ r20 + Pdot20: velocity of the mass centre, inertial axes [m/s]
  const T t20_16 = omega20_2 * T(0.05) - omega20_3 * T(0.2);
  const T t20_17 = omega20_3 * T(0.1) - omega20_1 * T(0.05);
  const T t20_18 = omega20_2 * T(0.1);
  const T t20_19 = omega20_1 * T(0.2) - t20_18;
  const T v20_1 = R20_11 * t20_16 + R20_21 * t20_17 + R20_31 * t20_19 + Pdot20_1;
  const T v20_2 = R20_12 * t20_16 + R20_22 * t20_17 + R20_32 * t20_19 + Pdot20_2;
  const T v20_3 = R20_13 * t20_16 + R20_23 * t20_17 + R20_33 * t20_19 + Pdot20_3;
  // T20 = 1/2 omega20 . (I20 omega20) + 1/2 m20 v20 . v20: kinetic energy [J]
  const T T20 = T(0.5) * (omega20_1 * (T(0.3) * omega20_1 + T(0.015) * omega20_2 + T(0.009) * omega20_3) + omega20_2 *
      (T(0.015) * omega20_1 + T(0.36) * omega20_2 - T(0.012) * omega20_3) + omega20_3 * (T(0.009) * omega20_1 -
      T(0.012) * omega20_2 + T(0.24) * omega20_3)) + T(1.5) * (v20_1 * v20_1 + v20_2 * v20_2 + v20_3 * v20_3);

  // ---- body 21 (body_21) on body 20
  const T eps21_1 = x[80], eps21_2 = x[81], eps21_3 = x[82], eps21_4 = x[83];
  const T omega21_1 = y[60], omega21_2 = y[61], omega21_3 = y[62];
  // R21^T = 1 + 2 e21~ (eps4_21 + e21~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t21_1 = T(2) * eps21_2;
  const T t21_2 = t21_1 * eps21_2;
  const T t21_3 = T(2) * eps21_3;
  const T t21_4 = t21_3 * eps21_3;
  const T R21_11 = T(1) - t21_2 - t21_4;
  const T t21_5 = T(2) * eps21_1;
  const T t21_6 = t21_5 * eps21_2;
  const T t21_7 = t21_3 * eps21_4;
  const T R21_12 = t21_6 + t21_7;
  const T t21_8 = t21_5 * eps21_3;
  const T t21_9 = t21_1 * eps21_4;
  const T R21_13 = t21_8 - t21_9;
  const T R21_21 = t21_6 - t21_7;
  const T t21_10 = T(1) - t21_5 * eps21_1;
  const T R21_22 = t21_10 - t21_4;
  const T t21_11 = t21_1 * eps21_3;
  const T t21_12 = t21_5 * eps21_4;
  const T R21_23 = t21_11 + t21_12;
  const T R21_31 = t21_8 + t21_9;
  const T R21_32 = t21_11 - t21_12;
  const T R21_33 = t21_10 - t21_2;
  // P21 = R20^T q21 + P20: position of the body origin, inertial axes [m]
  const T P21_3 = R20_13 * T(0.3) + R20_23 * T(1.05) + R20_33 * T(0.1) + P20_3;
  // p21 = R21^T r21 + P21: position of the mass centre, inertial axes [m]
  const T p21_3 = R21_13 * T(0.1) + R21_23 * T(0.2) + R21_33 * T(0.05) + P21_3;
  // Pdot21 = R20^T omega20~ q21 + Pdot20: velocity of the body origin, inertial axes [m/s]
  const T t21_13 = t20_18 - omega20_3 * T(1.05);
  const T t21_14 = omega20_3 * T(0.3) - omega20_1 * T(0.1);
  const T t21_15 = omega20_1 * T(1.05) - omega20_2 * T(0.3);
  const T Pdot21_1 = R20_11 * t21_13 + R20_21 * t21_14 + R20_31 * t21_15 + Pdot20_1;
  const T Pdot21_2 = R20_12 * t21_13 + R20_22 * t21_14 + R20_32 * t21_15 + Pdot20_2;
  const T Pdot21_3 = R20_13 * t21_13 + R20_23 * t21_14 + R20_33 * t21_15 + Pdot20_3;
  // v21 = R21^T omega21~ r21 + Pdot21: velocity of the mass centre, inertial axes [m/s]
  const T t21_16 = omega21_2 * T(0.05) - omega21_3 * T(0.2);
  const T t21_17 = omega21_3 * T(0.1) - omega21_1 * T(0.05);
  const T t21_18 = omega21_2 * T(0.1);
  const T t21_19 = omega21_1 * T(0.2) - t21_18;
  const T v21_1 = R21_11 * t21_16 + R21_21 * t21_17 + R21_31 * t21_19 + Pdot21_1;
  const T v21_2 = R21_12 * t21_16 + R21_22 * t21_17 + R21_32 * t21_19 + Pdot21_2;
  const T v21_3 = R21_13 * t21_16 + R21_23 * t21_17 + R21_33 * t21_19 + Pdot21_3;
  // T21 = 1/2 omega21 . (I21 omega21) + 1/2 m21 v21 . v21: kinetic energy [J]
  const T T21 = T(0.5) * (omega21_1 * (T(0.31) * omega21_1 + T(0.0155) * omega21_2 + T(0.0093) * omega21_3) +
      omega21_2 * (T(0.0155) * omega21_1 + T(0.372) * omega21_2 - T(0.0124) * omega21_3) + omega21_3 * (T(0.0093) *
      omega21_1 - T(0.0124) * omega21_2 + T(0.248) * omega21_3)) + T(1.55) * (v21_1 * v21_1 + v21_2 * v21_2 + v21_3 *
      v21_3);

  // ---- body 22 (body_22) on body 21
  const T eps22_1 = x[84], eps22_2 = x[85], eps22_3 = x[86], eps22_4 = x[87];
  const T omega22_1 = y[63], omega22_2 = y[64], omega22_3 = y[65];
  // R22^T = 1 + 2 e22~ (eps4_22 + e22~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t22_1 = T(2) * eps22_2;
  const T t22_2 = t22_1 * eps22_2;
  const T t22_3 = T(2) * eps22_3;
  const T t22_4 = t22_3 * eps22_3;
  const T R22_11 = T(1) - t22_2 - t22_4;
  const T t22_5 = T(2) * eps22_1;
  const T t22_6 = t22_5 * eps22_2;
  const T t22_7 = t22_3 * eps22_4;
  const T R22_12 = t22_6 + t22_7;
  const T t22_8 = t22_5 * eps22_3;
  const T t22_9 = t22_1 * eps22_4;
  const T R22_13 = t22_8 - t22_9;
  const T R22_21 = t22_6 - t22_7;
  const T t22_10 = T(1) - t22_5 * eps22_1;
  const T R22_22 = t22_10 - t22_4;
  const T t22_11 = t22_1 * eps22_3;
  const T t22_12 = t22_5 * eps22_4;
  const T R22_23 = t22_11 + t22_12;
  const T R22_31 = t22_8 + t22_9;
  const T R22_32 = t22_11 - t22_12;
  const T R22_33 = t22_10 - t22_2;
  // P22 = R21^T q22 + P21: position of the body origin, inertial axes [m]
  const T P22_3 = R21_13 * T(0.3) + R21_23 * T(1.1) + R21_33 * T(0.1) + P21_3;
  // p22 = R22^T r22 + P22: position of the mass centre, inertial axes [m]
  const T p22_3 = R22_13 * T(0.1) + R22_23 * T(0.2) + R22_33 * T(0.05) + P22_3;
  // Pdot22 = R21^T omega21~ q22 + Pdot21: velocity of the body origin, inertial axes [m/s]
  const T t22_13 = t21_18 - omega21_3 * T(1.1);
  const T t22_14 = omega21_3 * T(0.3) - omega21_1 * T(0.1);
  const T t22_15 = omega21_1 * T(1.1) - omega21_2 * T(0.3);
  const T Pdot22_1 = R21_11 * t22_13 + R21_21 * t22_14 + R21_31 * t22_15 + Pdot21_1;
  const T Pdot22_2 = R21_12 * t22_13 + R21_22 * t22_14 + R21_32 * t22_15 + Pdot21_2;
  const T Pdot22_3 = R21_13 * t22_13 + R21_23 * t22_14 + R21_33 * t22_15 + Pdot21_3;
  // v22 = R22^T omega22~ r22 + Pdot22: velocity of the mass centre, inertial axes [m/s]
  const T t22_16 = omega22_2 * T(0.05) - omega22_3 * T(0.2);
  const T t22_17 = omega22_3 * T(0.1) - omega22_1 * T(0.05);
  const T t22_18 = omega22_2 * T(0.1);
  const T t22_19 = omega22_1 * T(0.2) - t22_18;
  const T v22_1 = R22_11 * t22_16 + R22_21 * t22_17 + R22_31 * t22_19 + Pdot22_1;
  const T v22_2 = R22_12 * t22_16 + R22_22 * t22_17 + R22_32 * t22_19 + Pdot22_2;
  const T v22_3 = R22_13 * t22_16 + R22_23 * t22_17 + R22_33 * t22_19 + Pdot22_3;
  // T22 = 1/2 omega22 . (I22 omega22) + 1/2 m22 v22 . v22: kinetic energy [J]
  const T T22 = T(0.5) * (omega22_1 * (T(0.32) * omega22_1 + T(0.016) * omega22_2 + T(0.0096) * omega22_3) + omega22_2
      * (T(0.016) * omega22_1 + T(0.384) * omega22_2 - T(0.0128) * omega22_3) + omega22_3 * (T(0.0096) * omega22_1 -
      T(0.0128) * omega22_2 + T(0.256) * omega22_3)) + T(1.6) * (v22_1 * v22_1 + v22_2 * v22_2 + v22_3 * v22_3);

  // ---- body 23 (body_23) on body 22
  const T eps23_1 = x[88], eps23_2 = x[89], eps23_3 = x[90], eps23_4 = x[91];
  const T omega23_1 = y[66], omega23_2 = y[67], omega23_3 = y[68];
  // R23^T = 1 + 2 e23~ (eps4_23 + e23~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t23_1 = T(2) * eps23_2;
  const T t23_2 = t23_1 * eps23_2;
  const T t23_3 = T(2) * eps23_3;
  const T t23_4 = t23_3 * eps23_3;
  const T R23_11 = T(1) - t23_2 - t23_4;
  const T t23_5 = T(2) * eps23_1;
  const T t23_6 = t23_5 * eps23_2;
  const T t23_7 = t23_3 * eps23_4;
  const T R23_12 = t23_6 + t23_7;
  const T t23_8 = t23_5 * eps23_3;
  const T t23_9 = t23_1 * eps23_4;
  const T R23_13 = t23_8 - t23_9;
  const T R23_21 = t23_6 - t23_7;
  const T t23_10 = T(1) - t23_5 * eps23_1;
  const T R23_22 = t23_10 - t23_4;
  const T t23_11 = t23_1 * eps23_3;
  const T t23_12 = t23_5 * eps23_4;
  const T R23_23 = t23_11 + t23_12;
  const T R23_31 = t23_8 + t23_9;
  const T R23_32 = t23_11 - t23_12;
  const T R23_33 = t23_10 - t23_2;
  // P23 = R22^T q23 + P22: position of the body origin, inertial axes [m]
  const T P23_3 = R22_13 * T(0.3) + R22_23 * T(1.15) + R22_33 * T(0.1) + P22_3;
  // p23 = R23^T r23 + P23: position of the mass centre, inertial axes [m]
  const T p23_3 = R23_13 * T(0.1) + R23_23 * T(0.2) + R23_33 * T(0.05) + P23_3;
  // Pdot23 = R22^T omega22~ q23 + Pdot22: velocity of the body origin, inertial axes [m/s]
  const T t23_13 = t22_18 - omega22_3 * T(1.15);
  const T t23_14 = omega22_3 * T(0.3) - omega22_1 * T(0.1);
  const T t23_15 = omega22_1 * T(1.15) - omega22_2 * T(0.3);
  const T Pdot23_1 = R22_11 * t23_13 + R22_21 * t23_14 + R22_31 * t23_15 + Pdot22_1;
  const T Pdot23_2 = R22_12 * t23_13 + R22_22 * t23_14 + R22_32 * t23_15 + Pdot22_2;
  const T Pdot23_3 = R22_13 * t23_13 + R22_23 * t23_14 + R22_33 * t23_15 + Pdot22_3;
  // v23 = R23^T omega23~ r23 + Pdot23: velocity of the mass centre, inertial axes [m/s]
  const T t23_16 = omega23_2 * T(0.05) - omega23_3 * T(0.2);
  const T t23_17 = omega23_3 * T(0.1) - omega23_1 * T(0.05);
  const T t23_18 = omega23_2 * T(0.1);
  const T t23_19 = omega23_1 * T(0.2) - t23_18;
  const T v23_1 = R23_11 * t23_16 + R23_21 * t23_17 + R23_31 * t23_19 + Pdot23_1;
  const T v23_2 = R23_12 * t23_16 + R23_22 * t23_17 + R23_32 * t23_19 + Pdot23_2;
  const T v23_3 = R23_13 * t23_16 + R23_23 * t23_17 + R23_33 * t23_19 + Pdot23_3;
  // T23 = 1/2 omega23 . (I23 omega23) + 1/2 m23 v23 . v23: kinetic energy [J]
  const T T23 = T(0.5) * (omega23_1 * (T(0.33) * omega23_1 + T(0.0165) * omega23_2 + T(0.0099) * omega23_3) +
      omega23_2 * (T(0.0165) * omega23_1 + T(0.396) * omega23_2 - T(0.0132) * omega23_3) + omega23_3 * (T(0.0099) *
      omega23_1 - T(0.0132) * omega23_2 + T(0.264) * omega23_3)) + T(1.65) * (v23_1 * v23_1 + v23_2 * v23_2 + v23_3 *
      v23_3);

  // ---- body 24 (body_24) on body 23
  const T eps24_1 = x[92], eps24_2 = x[93], eps24_3 = x[94], eps24_4 = x[95];
  const T omega24_1 = y[69], omega24_2 = y[70], omega24_3 = y[71];
  // R24^T = 1 + 2 e24~ (eps4_24 + e24~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t24_1 = T(2) * eps24_2;
  const T t24_2 = t24_1 * eps24_2;
  const T t24_3 = T(2) * eps24_3;
  const T t24_4 = t24_3 * eps24_3;
  const T R24_11 = T(1) - t24_2 - t24_4;
  const T t24_5 = T(2) * eps24_1;
  const T t24_6 = t24_5 * eps24_2;
  const T t24_7 = t24_3 * eps24_4;
  const T R24_12 = t24_6 + t24_7;
  const T t24_8 = t24_5 * eps24_3;
  const T t24_9 = t24_1 * eps24_4;
  const T R24_13 = t24_8 - t24_9;
  const T R24_21 = t24_6 - t24_7;
  const T t24_10 = T(1) - t24_5 * eps24_1;
  const T R24_22 = t24_10 - t24_4;
  const T t24_11 = t24_1 * eps24_3;
  const T t24_12 = t24_5 * eps24_4;
  const T R24_23 = t24_11 + t24_12;
  const T R24_31 = t24_8 + t24_9;
  const T R24_32 = t24_11 - t24_12;
  const T R24_33 = t24_10 - t24_2;
  // P24 = R23^T q24 + P23: position of the body origin, inertial axes [m]
  const T P24_3 = R23_13 * T(0.3) + R23_23 * T(1.2) + R23_33 * T(0.1) + P23_3;
  // p24 = R24^T r24 + P24: position of the mass centre, inertial axes [m]
  const T p24_3 = R24_13 * T(0.1) + R24_23 * T(0.2) + R24_33 * T(0.05) + P24_3;
  // Pdot24 = R23^T omega23~ q24 + Pdot23: velocity of the body origin, inertial axes [m/s]
  const T t24_13 = t23_18 - omega23_3 * T(1.2);
  const T t24_14 = omega23_3 * T(0.3) - omega23_1 * T(0.1);
  const T t24_15 = omega23_1 * T(1.2) - omega23_2 * T(0.3);
  const T Pdot24_1 = R23_11 * t24_13 + R23_21 * t24_14 + R23_31 * t24_15 + Pdot23_1;
  const T Pdot24_2 = R23_12 * t24_13 + R23_22 * t24_14 + R23_32 * t24_15 + Pdot23_2;
  const T Pdot24_3 = R23_13 * t24_13 + R23_23 * t24_14 + R23_33 * t24_15 + Pdot23_3;
  // v24 = R24^T omega24~ r24 + Pdot24: velocity of the mass centre, inertial axes [m/s]
  const T t24_16 = omega24_2 * T(0.05) - omega24_3 * T(0.2);
  const T t24_17 = omega24_3 * T(0.1) - omega24_1 * T(0.05);
  const T t24_18 = omega24_2 * T(0.1);
  const T t24_19 = omega24_1 * T(0.2) - t24_18;
  const T v24_1 = R24_11 * t24_16 + R24_21 * t24_17 + R24_31 * t24_19 + Pdot24_1;
  const T v24_2 = R24_12 * t24_16 + R24_22 * t24_17 + R24_32 * t24_19 + Pdot24_2;
  const T v24_3 = R24_13 * t24_16 + R24_23 * t24_17 + R24_33 * t24_19 + Pdot24_3;
  // T24 = 1/2 omega24 . (I24 omega24) + 1/2 m24 v24 . v24: kinetic energy [J]
  const T T24 = T(0.5) * (omega24_1 * (T(0.34) * omega24_1 + T(0.017) * omega24_2 + T(0.0102) * omega24_3) + omega24_2
      * (T(0.017) * omega24_1 + T(0.408) * omega24_2 - T(0.0136) * omega24_3) + omega24_3 * (T(0.0102) * omega24_1 -
      T(0.0136) * omega24_2 + T(0.272) * omega24_3)) + T(1.7) * (v24_1 * v24_1 + v24_2 * v24_2 + v24_3 * v24_3);

  // ---- body 25 (body_25) on body 24
  const T eps25_1 = x[96], eps25_2 = x[97], eps25_3 = x[98], eps25_4 = x[99];
  const T omega25_1 = y[72], omega25_2 = y[73], omega25_3 = y[74];
  // R25^T = 1 + 2 e25~ (eps4_25 + e25~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t25_1 = T(2) * eps25_2;
  const T t25_2 = t25_1 * eps25_2;
  const T t25_3 = T(2) * eps25_3;
  const T t25_4 = t25_3 * eps25_3;
  const T R25_11 = T(1) - t25_2 - t25_4;
  const T t25_5 = T(2) * eps25_1;
  const T t25_6 = t25_5 * eps25_2;
  const T t25_7 = t25_3 * eps25_4;
  const T R25_12 = t25_6 + t25_7;
  const T t25_8 = t25_5 * eps25_3;
  const T t25_9 = t25_1 * eps25_4;
  const T R25_13 = t25_8 - t25_9;
  const T R25_21 = t25_6 - t25_7;
  const T t25_10 = T(1) - t25_5 * eps25_1;
  const T R25_22 = t25_10 - t25_4;
  const T t25_11 = t25_1 * eps25_3;
  const T t25_12 = t25_5 * eps25_4;
  const T R25_23 = t25_11 + t25_12;
  const T R25_31 = t25_8 + t25_9;
  const T R25_32 = t25_11 - t25_12;
  const T R25_33 = t25_10 - t25_2;
  // P25 = R24^T q25 + P24: position of the body origin, inertial axes [m]
  const T P25_3 = R24_13 * T(0.3) + R24_23 * T(1.25) + R24_33 * T(0.1) + P24_3;
  // p25 = R25^T r25 + P25: position of the mass centre, inertial axes [m]
  const T p25_3 = R25_13 * T(0.1) + R25_23 * T(0.2) + R25_33 * T(0.05) + P25_3;
  // Pdot25 = R24^T omega24~ q25 + Pdot24: velocity of the body origin, inertial axes [m/s]
  const T t25_13 = t24_18 - omega24_3 * T(1.25);
  const T t25_14 = omega24_3 * T(0.3) - omega24_1 * T(0.1);
  const T t25_15 = omega24_1 * T(1.25) - omega24_2 * T(0.3);
  const T Pdot25_1 = R24_11 * t25_13 + R24_21 * t25_14 + R24_31 * t25_15 + Pdot24_1;
  const T Pdot25_2 = R24_12 * t25_13 + R24_22 * t25_14 + R24_32 * t25_15 + Pdot24_2;
  const T Pdot25_3 = R24_13 * t25_13 + R24_23 * t25_14 + R24_33 * t25_15 + Pdot24_3;
  // v25 = R25^T omega25~ r25 + Pdot25: velocity of the mass centre, inertial axes [m/s]
  const T t25_16 = omega25_2 * T(0.05) - omega25_3 * T(0.2);
  const T t25_17 = omega25_3 * T(0.1) - omega25_1 * T(0.05);
  const T t25_18 = omega25_2 * T(0.1);
  const T t25_19 = omega25_1 * T(0.2) - t25_18;
  const T v25_1 = R25_11 * t25_16 + R25_21 * t25_17 + R25_31 * t25_19 + Pdot25_1;
  const T v25_2 = R25_12 * t25_16 + R25_22 * t25_17 + R25_32 * t25_19 + Pdot25_2;
  const T v25_3 = R25_13 * t25_16 + R25_23 * t25_17 + R25_33 * t25_19 + Pdot25_3;
  // T25 = 1/2 omega25 . (I25 omega25) + 1/2 m25 v25 . v25: kinetic energy [J]
  const T T25 = T(0.5) * (omega25_1 * (T(0.35) * omega25_1 + T(0.0175) * omega25_2 + T(0.0105) * omega25_3) +
      omega25_2 * (T(0.0175) * omega25_1 + T(0.42) * omega25_2 - T(0.014) * omega25_3) + omega25_3 * (T(0.0105) *
      omega25_1 - T(0.014) * omega25_2 + T(0.28) * omega25_3)) + T(1.75) * (v25_1 * v25_1 + v25_2 * v25_2 + v25_3 *
      v25_3);

  // ---- body 26 (body_26) on body 25
  const T eps26_1 = x[100], eps26_2 = x[101], eps26_3 = x[102], eps26_4 = x[103];
  const T omega26_1 = y[75], omega26_2 = y[76], omega26_3 = y[77];
  // R26^T = 1 + 2 e26~ (eps4_26 + e26~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t26_1 = T(2) * eps26_2;
  const T t26_2 = t26_1 * eps26_2;
  const T t26_3 = T(2) * eps26_3;
  const T t26_4 = t26_3 * eps26_3;
  const T R26_11 = T(1) - t26_2 - t26_4;
  const T t26_5 = T(2) * eps26_1;
  const T t26_6 = t26_5 * eps26_2;
  const T t26_7 = t26_3 * eps26_4;
  const T R26_12 = t26_6 + t26_7;
  const T t26_8 = t26_5 * eps26_3;
  const T t26_9 = t26_1 * eps26_4;
  const T R26_13 = t26_8 - t26_9;
  const T R26_21 = t26_6 - t26_7;
  const T t26_10 = T(1) - t26_5 * eps26_1;
  const T R26_22 = t26_10 - t26_4;
  const T t26_11 = t26_1 * eps26_3;
  const T t26_12 = t26_5 * eps26_4;
  const T R26_23 = t26_11 + t26_12;
  const T R26_31 = t26_8 + t26_9;
  const T R26_32 = t26_11 - t26_12;
  const T R26_33 = t26_10 - t26_2;
  // P26 = R25^T q26 + P25: position of the body origin, inertial axes [m]
  const T P26_3 = R25_13 * T(0.3) + R25_23 * T(1.3) + R25_33 * T(0.1) + P25_3;
  // p26 = R26^T r26 + P26: position of the mass centre, inertial axes [m]
  const T p26_3 = R26_13 * T(0.1) + R26_23 * T(0.2) + R26_33 * T(0.05) + P26_3;
  // Pdot26 = R25^T omega25~ q26 + Pdot25: velocity of the body origin, inertial axes [m/s]
  const T t26_13 = t25_18 - omega25_3 * T(1.3);
  const T t26_14 = omega25_3 * T(0.3) - omega25_1 * T(0.1);
  const T t26_15 = omega25_1 * T(1.3) - omega25_2 * T(0.3);
  const T Pdot26_1 = R25_11 * t26_13 + R25_21 * t26_14 + R25_31 * t26_15 + Pdot25_1;
  const T Pdot26_2 = R25_12 * t26_13 + R25_22 * t26_14 + R25_32 * t26_15 + Pdot25_2;
  const T Pdot26_3 = R25_13 * t26_13 + R25_23 * t26_14 + R25_33 * t26_15 + Pdot25_3;
  // v26 = R26^T omega26~ r26 + Pdot26: velocity of the mass centre, inertial axes [m/s]
  const T t26_16 = omega26_2 * T(0.05) - omega26_3 * T(0.2);
  const T t26_17 = omega26_3 * T(0.1) - omega26_1 * T(0.05);
  const T t26_18 = omega26_2 * T(0.1);
  const T t26_19 = omega26_1 * T(0.2) - t26_18;
  const T v26_1 = R26_11 * t26_16 + R26_21 * t26_17 + R26_31 * t26_19 + Pdot26_1;
  const T v26_2 = R26_12 * t26_16 + R26_22 * t26_17 + R26_32 * t26_19 + Pdot26_2;
  const T v26_3 = R26_13 * t26_16 + R26_23 * t26_17 + R26_33 * t26_19 + Pdot26_3;
  // T26 = 1/2 omega26 . (I26 omega26) + 1/2 m26 v26 . v26: kinetic energy [J]
  const T T26 = T(0.5) * (omega26_1 * (T(0.36) * omega26_1 + T(0.018) * omega26_2 + T(0.0108) * omega26_3) + omega26_2
      * (T(0.018) * omega26_1 + T(0.432) * omega26_2 - T(0.0144) * omega26_3) + omega26_3 * (T(0.0108) * omega26_1 -
      T(0.0144) * omega26_2 + T(0.288) * omega26_3)) + T(1.8) * (v26_1 * v26_1 + v26_2 * v26_2 + v26_3 * v26_3);

  // ---- body 27 (body_27) on body 26
  const T eps27_1 = x[104], eps27_2 = x[105], eps27_3 = x[106], eps27_4 = x[107];
  const T omega27_1 = y[78], omega27_2 = y[79], omega27_3 = y[80];
  // R27^T = 1 + 2 e27~ (eps4_27 + e27~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t27_1 = T(2) * eps27_2;
  const T t27_2 = t27_1 * eps27_2;
  const T t27_3 = T(2) * eps27_3;
  const T t27_4 = t27_3 * eps27_3;
  const T R27_11 = T(1) - t27_2 - t27_4;
  const T t27_5 = T(2) * eps27_1;
  const T t27_6 = t27_5 * eps27_2;
  const T t27_7 = t27_3 * eps27_4;
  const T R27_12 = t27_6 + t27_7;
  const T t27_8 = t27_5 * eps27_3;
  const T t27_9 = t27_1 * eps27_4;
  const T R27_13 = t27_8 - t27_9;
  const T R27_21 = t27_6 - t27_7;
  const T t27_10 = T(1) - t27_5 * eps27_1;
  const T R27_22 = t27_10 - t27_4;
  const T t27_11 = t27_1 * eps27_3;
  const T t27_12 = t27_5 * eps27_4;
  const T R27_23 = t27_11 + t27_12;
  const T R27_31 = t27_8 + t27_9;
  const T R27_32 = t27_11 - t27_12;
  const T R27_33 = t27_10 - t27_2;
  // P27 = R26^T q27 + P26: position of the body origin, inertial axes [m]
  const T P27_3 = R26_13 * T(0.3) + R26_23 * T(1.35) + R26_33 * T(0.1) + P26_3;
  // p27 = R27^T r27 + P27: position of the mass centre, inertial axes [m]
  const T p27_3 = R27_13 * T(0.1) + R27_23 * T(0.2) + R27_33 * T(0.05) + P27_3;
  // Pdot27 = R26^T omega26~ q27 + Pdot26: velocity of the body origin, inertial axes [m/s]
  const T t27_13 = t26_18 - omega26_3 * T(1.35);
  const T t27_14 = omega26_3 * T(0.3) - omega26_1 * T(0.1);
  const T t27_15 = omega26_1 * T(1.35) - omega26_2 * T(0.3);
  const T Pdot27_1 = R26_11 * t27_13 + R26_21 * t27_14 + R26_31 * t27_15 + Pdot26_1;
  const T Pdot27_2 = R26_12 * t27_13 + R26_22 * t27_14 + R26_32 * t27_15 + Pdot26_2;
  const T Pdot27_3 = R26_13 * t27_13 + R26_23 * t27_14 + R26_33 * t27_15 + Pdot26_3;
  // v27 = R27^T omega27~ r27 + Pdot27: velocity of the mass centre, inertial axes [m/s]
  const T t27_16 = omega27_2 * T(0.05) - omega27_3 * T(0.2);
  const T t27_17 = omega27_3 * T(0.1) - omega27_1 * T(0.05);
  const T t27_18 = omega27_2 * T(0.1);
  const T t27_19 = omega27_1 * T(0.2) - t27_18;
  const T v27_1 = R27_11 * t27_16 + R27_21 * t27_17 + R27_31 * t27_19 + Pdot27_1;
  const T v27_2 = R27_12 * t27_16 + R27_22 * t27_17 + R27_32 * t27_19 + Pdot27_2;
  const T v27_3 = R27_13 * t27_16 + R27_23 * t27_17 + R27_33 * t27_19 + Pdot27_3;
  // T27 = 1/2 omega27 . (I27 omega27) + 1/2 m27 v27 . v27: kinetic energy [J]
  const T T27 = T(0.5) * (omega27_1 * (T(0.37) * omega27_1 + T(0.0185) * omega27_2 + T(0.0111) * omega27_3) +
      omega27_2 * (T(0.0185) * omega27_1 + T(0.444) * omega27_2 - T(0.0148) * omega27_3) + omega27_3 * (T(0.0111) *
      omega27_1 - T(0.0148) * omega27_2 + T(0.296) * omega27_3)) + T(1.85) * (v27_1 * v27_1 + v27_2 * v27_2 + v27_3 *
      v27_3);

  // ---- body 28 (body_28) on body 27
  const T eps28_1 = x[108], eps28_2 = x[109], eps28_3 = x[110], eps28_4 = x[111];
  const T omega28_1 = y[81], omega28_2 = y[82], omega28_3 = y[83];
  // R28^T = 1 + 2 e28~ (eps4_28 + e28~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t28_1 = T(2) * eps28_2;
  const T t28_2 = t28_1 * eps28_2;
  const T t28_3 = T(2) * eps28_3;
  const T t28_4 = t28_3 * eps28_3;
  const T R28_11 = T(1) - t28_2 - t28_4;
  const T t28_5 = T(2) * eps28_1;
  const T t28_6 = t28_5 * eps28_2;
  const T t28_7 = t28_3 * eps28_4;
  const T R28_12 = t28_6 + t28_7;
  const T t28_8 = t28_5 * eps28_3;
  const T t28_9 = t28_1 * eps28_4;
  const T R28_13 = t28_8 - t28_9;
  const T R28_21 = t28_6 - t28_7;
  const T t28_10 = T(1) - t28_5 * eps28_1;
  const T R28_22 = t28_10 - t28_4;
  const T t28_11 = t28_1 * eps28_3;
  const T t28_12 = t28_5 * eps28_4;
  const T R28_23 = t28_11 + t28_12;
  const T R28_31 = t28_8 + t28_9;
  const T R28_32 = t28_11 - t28_12;
  const T R28_33 = t28_10 - t28_2;
  // P28 = R27^T q28 + P27: position of the body origin, inertial axes [m]
  const T P28_3 = R27_13 * T(0.3) + R27_23 * T(1.4) + R27_33 * T(0.1) + P27_3;
  // p28 = R28^T r28 + P28: position of the mass centre, inertial axes [m]
  const T p28_3 = R28_13 * T(0.1) + R28_23 * T(0.2) + R28_33 * T(0.05) + P28_3;
  // Pdot28 = R27^T omega27~ q28 + Pdot27: velocity of the body origin, inertial axes [m/s]
  const T t28_13 = t27_18 - omega27_3 * T(1.4);
  const T t28_14 = omega27_3 * T(0.3) - omega27_1 * T(0.1);
  const T t28_15 = omega27_1 * T(1.4) - omega27_2 * T(0.3);
  const T Pdot28_1 = R27_11 * t28_13 + R27_21 * t28_14 + R27_31 * t28_15 + Pdot27_1;
  const T Pdot28_2 = R27_12 * t28_13 + R27_22 * t28_14 + R27_32 * t28_15 + Pdot27_2;
  const T Pdot28_3 = R27_13 * t28_13 + R27_23 * t28_14 + R27_33 * t28_15 + Pdot27_3;
  // v28 = R28^T omega28~ r28 + Pdot28: velocity of the mass centre, inertial axes [m/s]
  const T t28_16 = omega28_2 * T(0.05) - omega28_3 * T(0.2);
  const T t28_17 = omega28_3 * T(0.1) - omega28_1 * T(0.05);
  const T t28_18 = omega28_2 * T(0.1);
  const T t28_19 = omega28_1 * T(0.2) - t28_18;
  const T v28_1 = R28_11 * t28_16 + R28_21 * t28_17 + R28_31 * t28_19 + Pdot28_1;
  const T v28_2 = R28_12 * t28_16 + R28_22 * t28_17 + R28_32 * t28_19 + Pdot28_2;
  const T v28_3 = R28_13 * t28_16 + R28_23 * t28_17 + R28_33 * t28_19 + Pdot28_3;
  // T28 = 1/2 omega28 . (I28 omega28) + 1/2 m28 v28 . v28: kinetic energy [J]
  const T T28 = T(0.5) * (omega28_1 * (T(0.38) * omega28_1 + T(0.019) * omega28_2 + T(0.0114) * omega28_3) + omega28_2
      * (T(0.019) * omega28_1 + T(0.456) * omega28_2 - T(0.0152) * omega28_3) + omega28_3 * (T(0.0114) * omega28_1 -
      T(0.0152) * omega28_2 + T(0.304) * omega28_3)) + T(1.9) * (v28_1 * v28_1 + v28_2 * v28_2 + v28_3 * v28_3);

  // ---- body 29 (body_29) on body 28
  const T eps29_1 = x[112], eps29_2 = x[113], eps29_3 = x[114], eps29_4 = x[115];
  const T omega29_1 = y[84], omega29_2 = y[85], omega29_3 = y[86];
  // R29^T = 1 + 2 e29~ (eps4_29 + e29~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t29_1 = T(2) * eps29_2;
  const T t29_2 = t29_1 * eps29_2;
  const T t29_3 = T(2) * eps29_3;
  const T t29_4 = t29_3 * eps29_3;
  const T R29_11 = T(1) - t29_2 - t29_4;
  const T t29_5 = T(2) * eps29_1;
  const T t29_6 = t29_5 * eps29_2;
  const T t29_7 = t29_3 * eps29_4;
  const T R29_12 = t29_6 + t29_7;
  const T t29_8 = t29_5 * eps29_3;
  const T t29_9 = t29_1 * eps29_4;
  const T R29_13 = t29_8 - t29_9;
  const T R29_21 = t29_6 - t29_7;
  const T t29_10 = T(1) - t29_5 * eps29_1;
  const T R29_22 = t29_10 - t29_4;
  const T t29_11 = t29_1 * eps29_3;
  const T t29_12 = t29_5 * eps29_4;
  const T R29_23 = t29_11 + t29_12;
  const T R29_31 = t29_8 + t29_9;
  const T R29_32 = t29_11 - t29_12;
  const T R29_33 = t29_10 - t29_2;
  // P29 = R28^T q29 + P28: position of the body origin, inertial axes [m]
  const T P29_3 = R28_13 * T(0.3) + R28_23 * T(1.45) + R28_33 * T(0.1) + P28_3;
  // p29 = R29^T r29 + P29: position of the mass centre, inertial axes [m]
  const T p29_3 = R29_13 * T(0.1) + R29_23 * T(0.2) + R29_33 * T(0.05) + P29_3;
  // Pdot29 = R28^T omega28~ q29 + Pdot28: velocity of the body origin, inertial axes [m/s]
  const T t29_13 = t28_18 - omega28_3 * T(1.45);
  const T t29_14 = omega28_3 * T(0.3) - omega28_1 * T(0.1);
  const T t29_15 = omega28_1 * T(1.45) - omega28_2 * T(0.3);
  const T Pdot29_1 = R28_11 * t29_13 + R28_21 * t29_14 + R28_31 * t29_15 + Pdot28_1;
  const T Pdot29_2 = R28_12 * t29_13 + R28_22 * t29_14 + R28_32 * t29_15 + Pdot28_2;
  const T Pdot29_3 = R28_13 * t29_13 + R28_23 * t29_14 + R28_33 * t29_15 + Pdot28_3;
  // v29 = R29^T omega29~ r29 + Pdot29: velocity of the mass centre, inertial axes [m/s]
  const T t29_16 = omega29_2 * T(0.05) - omega29_3 * T(0.2);
  const T t29_17 = omega29_3 * T(0.1) - omega29_1 * T(0.05);
  const T t29_18 = omega29_2 * T(0.1);
  const T t29_19 = omega29_1 * T(0.2) - t29_18;
  const T v29_1 = R29_11 * t29_16 + R29_21 * t29_17 + R29_31 * t29_19 + Pdot29_1;
  const T v29_2 = R29_12 * t29_16 + R29_22 * t29_17 + R29_32 * t29_19 + Pdot29_2;
  const T v29_3 = R29_13 * t29_16 + R29_23 * t29_17 + R29_33 * t29_19 + Pdot29_3;
  // T29 = 1/2 omega29 . (I29 omega29) + 1/2 m29 v29 . v29: kinetic energy [J]
  const T T29 = T(0.5) * (omega29_1 * (T(0.39) * omega29_1 + T(0.0195) * omega29_2 + T(0.0117) * omega29_3) +
      omega29_2 * (T(0.0195) * omega29_1 + T(0.468) * omega29_2 - T(0.0156) * omega29_3) + omega29_3 * (T(0.0117) *
      omega29_1 - T(0.0156) * omega29_2 + T(0.312) * omega29_3)) + T(1.95) * (v29_1 * v29_1 + v29_2 * v29_2 + v29_3 *
      v29_3);

  // ---- body 30 (body_30) on body 29
  const T eps30_1 = x[116], eps30_2 = x[117], eps30_3 = x[118], eps30_4 = x[119];
  const T omega30_1 = y[87], omega30_2 = y[88], omega30_3 = y[89];
  // R30^T = 1 + 2 e30~ (eps4_30 + e30~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t30_1 = T(2) * eps30_2;
  const T t30_2 = t30_1 * eps30_2;
  const T t30_3 = T(2) * eps30_3;
  const T t30_4 = t30_3 * eps30_3;
  const T R30_11 = T(1) - t30_2 - t30_4;
  const T t30_5 = T(2) * eps30_1;
  const T t30_6 = t30_5 * eps30_2;
  const T t30_7 = t30_3 * eps30_4;
  const T R30_12 = t30_6 + t30_7;
  const T t30_8 = t30_5 * eps30_3;
  const T t30_9 = t30_1 * eps30_4;
  const T R30_13 = t30_8 - t30_9;
  const T R30_21 = t30_6 - t30_7;
  const T t30_10 = T(1) - t30_5 * eps30_1;
  const T R30_22 = t30_10 - t30_4;
  const T t30_11 = t30_1 * eps30_3;
  const T t30_12 = t30_5 * eps30_4;
  const T R30_23 = t30_11 + t30_12;
  const T R30_31 = t30_8 + t30_9;
  const T R30_32 = t30_11 - t30_12;
  const T R30_33 = t30_10 - t30_2;
  // P30 = R29^T q30 + P29: position of the body origin, inertial axes [m]
  const T P30_3 = R29_13 * T(0.3) + R29_23 * T(1.5) + R29_33 * T(0.1) + P29_3;
  // p30 = R30^T r30 + P30: position of the mass centre, inertial axes [m]
  const T p30_3 = R30_13 * T(0.1) + R30_23 * T(0.2) + R30_33 * T(0.05) + P30_3;
  // Pdot30 = R29^T omega29~ q30 + Pdot29: velocity of the body origin, inertial axes [m/s]
  const T t30_13 = t29_18 - omega29_3 * T(1.5);
  const T t30_14 = omega29_3 * T(0.3) - omega29_1 * T(0.1);
  const T t30_15 = omega29_1 * T(1.5) - omega29_2 * T(0.3);
  const T Pdot30_1 = R29_11 * t30_13 + R29_21 * t30_14 + R29_31 * t30_15 + Pdot29_1;
  const T Pdot30_2 = R29_12 * t30_13 + R29_22 * t30_14 + R29_32 * t30_15 + Pdot29_2;
  const T Pdot30_3 = R29_13 * t30_13 + R29_23 * t30_14 + R29_33 * t30_15 + Pdot29_3;
  // v30 = R30^T omega30~ r30 + Pdot30: velocity of the mass centre, inertial axes [m/s]
  const T t30_16 = omega30_2 * T(0.05) - omega30_3 * T(0.2);
  const T t30_17 = omega30_3 * T(0.1) - omega30_1 * T(0.05);
  const T t30_18 = omega30_2 * T(0.1);
  const T t30_19 = omega30_1 * T(0.2) - t30_18;
  const T v30_1 = R30_11 * t30_16 + R30_21 * t30_17 + R30_31 * t30_19 + Pdot30_1;
  const T v30_2 = R30_12 * t30_16 + R30_22 * t30_17 + R30_32 * t30_19 + Pdot30_2;
  const T v30_3 = R30_13 * t30_16 + R30_23 * t30_17 + R30_33 * t30_19 + Pdot30_3;
  // T30 = 1/2 omega30 . (I30 omega30) + 1/2 m30 v30 . v30: kinetic energy [J]
  const T T30 = T(0.5) * (omega30_1 * (T(0.4) * omega30_1 + T(0.02) * omega30_2 + T(0.012) * omega30_3) + omega30_2 *
      (T(0.02) * omega30_1 + T(0.48) * omega30_2 - T(0.016) * omega30_3) + omega30_3 * (T(0.012) * omega30_1 -
      T(0.016) * omega30_2 + T(0.32) * omega30_3)) + T(2) * (v30_1 * v30_1 + v30_2 * v30_2 + v30_3 * v30_3);

  // ---- body 31 (body_31) on body 30
  const T eps31_1 = x[120], eps31_2 = x[121], eps31_3 = x[122], eps31_4 = x[123];
  const T omega31_1 = y[90], omega31_2 = y[91], omega31_3 = y[92];
  // R31^T = 1 + 2 e31~ (eps4_31 + e31~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t31_1 = T(2) * eps31_2;
  const T t31_2 = t31_1 * eps31_2;
  const T t31_3 = T(2) * eps31_3;
  const T t31_4 = t31_3 * eps31_3;
  const T R31_11 = T(1) - t31_2 - t31_4;
  const T t31_5 = T(2) * eps31_1;
  const T t31_6 = t31_5 * eps31_2;
  const T t31_7 = t31_3 * eps31_4;
  const T R31_12 = t31_6 + t31_7;
  const T t31_8 = t31_5 * eps31_3;
  const T t31_9 = t31_1 * eps31_4;
  const T R31_13 = t31_8 - t31_9;
  const T R31_21 = t31_6 - t31_7;
  const T t31_10 = T(1) - t31_5 * eps31_1;
  const T R31_22 = t31_10 - t31_4;
  const T t31_11 = t31_1 * eps31_3;
  const T t31_12 = t31_5 * eps31_4;
  const T R31_23 = t31_11 + t31_12;
  const T R31_31 = t31_8 + t31_9;
  const T R31_32 = t31_11 - t31_12;
  const T R31_33 = t31_10 - t31_2;
  // P31 = R30^T q31 + P30: position of the body origin, inertial axes [m]
  const T P31_3 = R30_13 * T(0.3) + R30_23 * T(1.55) + R30_33 * T(0.1) + P30_3;
  // p31 = R31^T r31 + P31: position of the mass centre, inertial axes [m]
  const T p31_3 = R31_13 * T(0.1) + R31_23 * T(0.2) + R31_33 * T(0.05) + P31_3;
  // Pdot31 = R30^T omega30~ q31 + Pdot30: velocity of the body origin, inertial axes [m/s]
  const T t31_13 = t30_18 - omega30_3 * T(1.55);
  const T t31_14 = omega30_3 * T(0.3) - omega30_1 * T(0.1);
  const T t31_15 = omega30_1 * T(1.55) - omega30_2 * T(0.3);
  const T Pdot31_1 = R30_11 * t31_13 + R30_21 * t31_14 + R30_31 * t31_15 + Pdot30_1;
  const T Pdot31_2 = R30_12 * t31_13 + R30_22 * t31_14 + R30_32 * t31_15 + Pdot30_2;
  const T Pdot31_3 = R30_13 * t31_13 + R30_23 * t31_14 + R30_33 * t31_15 + Pdot30_3;
  // v31 = R31^T omega31~ r31 + Pdot31: velocity of the mass centre, inertial axes [m/s]
  const T t31_16 = omega31_2 * T(0.05) - omega31_3 * T(0.2);
  const T t31_17 = omega31_3 * T(0.1) - omega31_1 * T(0.05);
  const T t31_18 = omega31_2 * T(0.1);
  const T t31_19 = omega31_1 * T(0.2) - t31_18;
  const T v31_1 = R31_11 * t31_16 + R31_21 * t31_17 + R31_31 * t31_19 + Pdot31_1;
  const T v31_2 = R31_12 * t31_16 + R31_22 * t31_17 + R31_32 * t31_19 + Pdot31_2;
  const T v31_3 = R31_13 * t31_16 + R31_23 * t31_17 + R31_33 * t31_19 + Pdot31_3;
  // T31 = 1/2 omega31 . (I31 omega31) + 1/2 m31 v31 . v31: kinetic energy [J]
  const T T31 = T(0.5) * (omega31_1 * (T(0.41) * omega31_1 + T(0.0205) * omega31_2 + T(0.0123) * omega31_3) +
      omega31_2 * (T(0.0205) * omega31_1 + T(0.492) * omega31_2 - T(0.0164) * omega31_3) + omega31_3 * (T(0.0123) *
      omega31_1 - T(0.0164) * omega31_2 + T(0.328) * omega31_3)) + T(2.05) * (v31_1 * v31_1 + v31_2 * v31_2 + v31_3 *
      v31_3);

  // ---- body 32 (body_32) on body 31
  const T eps32_1 = x[124], eps32_2 = x[125], eps32_3 = x[126], eps32_4 = x[127];
  const T omega32_1 = y[93], omega32_2 = y[94], omega32_3 = y[95];
  // R32^T = 1 + 2 e32~ (eps4_32 + e32~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t32_1 = T(2) * eps32_2;
  const T t32_2 = t32_1 * eps32_2;
  const T t32_3 = T(2) * eps32_3;
  const T t32_4 = t32_3 * eps32_3;
  const T R32_11 = T(1) - t32_2 - t32_4;
  const T t32_5 = T(2) * eps32_1;
  const T t32_6 = t32_5 * eps32_2;
  const T t32_7 = t32_3 * eps32_4;
  const T R32_12 = t32_6 + t32_7;
  const T t32_8 = t32_5 * eps32_3;
  const T t32_9 = t32_1 * eps32_4;
  const T R32_13 = t32_8 - t32_9;
  const T R32_21 = t32_6 - t32_7;
  const T t32_10 = T(1) - t32_5 * eps32_1;
  const T R32_22 = t32_10 - t32_4;
  const T t32_11 = t32_1 * eps32_3;
  const T t32_12 = t32_5 * eps32_4;
  const T R32_23 = t32_11 + t32_12;
  const T R32_31 = t32_8 + t32_9;
  const T R32_32 = t32_11 - t32_12;
  const T R32_33 = t32_10 - t32_2;
  // P32 = R31^T q32 + P31: position of the body origin, inertial axes [m]
  const T P32_3 = R31_13 * T(0.3) + R31_23 * T(1.6) + R31_33 * T(0.1) + P31_3;
  // p32 = R32^T r32 + P32: position of the mass centre, inertial axes [m]
  const T p32_3 = R32_13 * T(0.1) + R32_23 * T(0.2) + R32_33 * T(0.05) + P32_3;
  // Pdot32 = R31^T omega31~ q32 + Pdot31: velocity of the body origin, inertial axes [m/s]
  const T t32_13 = t31_18 - omega31_3 * T(1.6);
  const T t32_14 = omega31_3 * T(0.3) - omega31_1 * T(0.1);
  const T t32_15 = omega31_1 * T(1.6) - omega31_2 * T(0.3);
  const T Pdot32_1 = R31_11 * t32_13 + R31_21 * t32_14 + R31_31 * t32_15 + Pdot31_1;
  const T Pdot32_2 = R31_12 * t32_13 + R31_22 * t32_14 + R31_32 * t32_15 + Pdot31_2;
  const T Pdot32_3 = R31_13 * t32_13 + R31_23 * t32_14 + R31_33 * t32_15 + Pdot31_3;
  // v32 = R32^T omega32~ r32 + Pdot32: velocity of the mass centre, inertial axes [m/s]
  const T t32_16 = omega32_2 * T(0.05) - omega32_3 * T(0.2);
  const T t32_17 = omega32_3 * T(0.1) - omega32_1 * T(0.05);
  const T t32_18 = omega32_1 * T(0.2) - omega32_2 * T(0.1);
  const T v32_1 = R32_11 * t32_16 + R32_21 * t32_17 + R32_31 * t32_18 + Pdot32_1;
  const T v32_2 = R32_12 * t32_16 + R32_22 * t32_17 + R32_32 * t32_18 + Pdot32_2;
  const T v32_3 = R32_13 * t32_16 + R32_23 * t32_17 + R32_33 * t32_18 + Pdot32_3;
  // T32 = 1/2 omega32 . (I32 omega32) + 1/2 m32 v32 . v32: kinetic energy [J]
  const T T32 = T(0.5) * (omega32_1 * (T(0.42) * omega32_1 + T(0.021) * omega32_2 + T(0.0126) * omega32_3) + omega32_2
      * (T(0.021) * omega32_1 + T(0.504) * omega32_2 - T(0.0168) * omega32_3) + omega32_3 * (T(0.0126) * omega32_1 -
      T(0.0168) * omega32_2 + T(0.336) * omega32_3)) + T(2.1) * (v32_1 * v32_1 + v32_2 * v32_2 + v32_3 * v32_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12 + T13 + T14 + T15 + T16 + T17 + T18 + T19
  //   + T20 + T21 + T22 + T23 + T24 + T25 + T26 + T27 + T28 + T29 + T30 + T31 + T32: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12 + T13 + T14 + T15 + T16 + T17 + T18 +
      T19 + T20 + T21 + T22 + T23 + T24 + T25 + T26 + T27 + T28 + T29 + T30 + T31 + T32;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6 + m7 p7 + m8 p8 + m9 p9 + m10 p10 + m11 p11 + m12 p12 + m13
  //   p13 + m14 p14 + m15 p15 + m16 p16 + m17 p17 + m18 p18 + m19 p19 + m20 p20 + m21 p21 + m22 p22 + m23 p23 + m24
  //   p24 + m25 p25 + m26 p26 + m27 p27 + m28 p28 + m29 p29 + m30 p30 + m31 p31 + m32 p32: first moment of mass,
  //   inertial axes [kg m]
  const T mp_3 = T(1.1) * p1_3 + T(1.2) * p2_3 + T(1.3) * p3_3 + T(1.4) * p4_3 + T(1.5) * p5_3 + T(1.6) * p6_3 +
      T(1.7) * p7_3 + T(1.8) * p8_3 + T(1.9) * p9_3 + T(2) * p10_3 + T(2.1) * p11_3 + T(2.2) * p12_3 + T(2.3) * p13_3
      + T(2.4) * p14_3 + T(2.5) * p15_3 + T(2.6) * p16_3 + T(2.7) * p17_3 + T(2.8) * p18_3 + T(2.9) * p19_3 + T(3) *
      p20_3 + T(3.1) * p21_3 + T(3.2) * p22_3 + T(3.3) * p23_3 + T(3.4) * p24_3 + T(3.5) * p25_3 + T(3.6) * p26_3 +
      T(3.7) * p27_3 + T(3.8) * p28_3 + T(3.9) * p29_3 + T(4) * p30_3 + T(4.1) * p31_3 + T(4.2) * p32_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 3468 add, 3779 multiply
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r)
    noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
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
  // a1 = R1^T U1 r1 + Pddot1: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t1_19 = U1_12 * T(0.2) - minus_U1_11 * T(0.1) + U1_13 * T(0.05);
  const T t1_20 = U1_21 * T(0.1) - minus_U1_22 * T(0.2) + U1_23 * T(0.05);
  const T t1_21 = U1_31 * T(0.1) + U1_32 * T(0.2) - minus_U1_33 * T(0.05);
  const T a1_1 = R1_11 * t1_19 + R1_21 * t1_20 + R1_31 * t1_21;
  const T a1_2 = R1_12 * t1_19 + R1_22 * t1_20 + R1_32 * t1_21;
  const T a1_3 = R1_13 * t1_19 + R1_23 * t1_20 + R1_33 * t1_21 + T(9.81);
  // G1 = m1 a1: force balance, inertial axes [N]
  const T G1_1 = T(1.1) * a1_1;
  const T G1_2 = T(1.1) * a1_2;
  const T G1_3 = T(1.1) * a1_3;

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
  // Pddot2 = R1^T U1 q2 + Pddot1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t2_19 = U1_12 * T(0.1) - minus_U1_11 * T(0.3) + U1_13 * T(0.1);
  const T t2_20 = U1_21 * T(0.3) - minus_U1_22 * T(0.1) + U1_23 * T(0.1);
  const T t2_21 = U1_31 * T(0.3) + U1_32 * T(0.1) - minus_U1_33 * T(0.1);
  const T Pddot2_1 = R1_11 * t2_19 + R1_21 * t2_20 + R1_31 * t2_21;
  const T Pddot2_2 = R1_12 * t2_19 + R1_22 * t2_20 + R1_32 * t2_21;
  const T Pddot2_3 = R1_13 * t2_19 + R1_23 * t2_20 + R1_33 * t2_21 + T(9.81);
  // N1 = R1 R2^T M_torque_2_ + axial(U1 (tr(I1)/2 - I1)) - M_torque_1_: moment balance about the mass centre, body
  //   axes [N m]
  const T t2_22 = R2_11 * u.tau_2_1 + R2_21 * u.tau_2_2 + R2_31 * u.tau_2_3;
  const T t2_23 = R2_12 * u.tau_2_1 + R2_22 * u.tau_2_2 + R2_32 * u.tau_2_3;
  const T t2_24 = R2_13 * u.tau_2_1 + R2_23 * u.tau_2_2 + R2_33 * u.tau_2_3;
  const T N1_1 = R1_11 * t2_22 + R1_12 * t2_23 + R1_13 * t2_24 + T(0.032999999999999995) * U1_32 -
      T(0.07700000000000001) * U1_23 + T(0.0044) * (minus_U1_22 - minus_U1_33) - T(0.0055) * U1_31 + T(0.0033) * U1_21
      - u.tau_1_1;
  const T N1_2 = R1_21 * t2_22 + R1_22 * t2_23 + R1_23 * t2_24 + T(0.07700000000000001) * U1_13 - T(0.055) * U1_31 -
      T(0.0033) * (minus_U1_33 - minus_U1_11) + T(0.0044) * U1_12 + T(0.0055) * U1_32 - u.tau_1_2;
  const T N1_3 = R1_31 * t2_22 + R1_32 * t2_23 + R1_33 * t2_24 + T(0.055) * U1_21 - T(0.032999999999999995) * U1_12 -
      T(0.0055) * (minus_U1_11 - minus_U1_22) - T(0.0033) * U1_23 - T(0.0044) * U1_13 - u.tau_1_3;
  // a2 = R2^T U2 r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_25 = U2_12 * T(0.2) - minus_U2_11 * T(0.1) + U2_13 * T(0.05);
  const T t2_26 = U2_21 * T(0.1) - minus_U2_22 * T(0.2) + U2_23 * T(0.05);
  const T t2_27 = U2_31 * T(0.1) + U2_32 * T(0.2) - minus_U2_33 * T(0.05);
  const T a2_1 = R2_11 * t2_25 + R2_21 * t2_26 + R2_31 * t2_27 + Pddot2_1;
  const T a2_2 = R2_12 * t2_25 + R2_22 * t2_26 + R2_32 * t2_27 + Pddot2_2;
  const T a2_3 = R2_13 * t2_25 + R2_23 * t2_26 + R2_33 * t2_27 + Pddot2_3;
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
  // Pddot3 = R2^T U2 q3 + Pddot2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t3_19 = U2_12 * T(0.15) - minus_U2_11 * T(0.3) + U2_13 * T(0.1);
  const T t3_20 = U2_21 * T(0.3) - minus_U2_22 * T(0.15) + U2_23 * T(0.1);
  const T t3_21 = U2_31 * T(0.3) + U2_32 * T(0.15) - minus_U2_33 * T(0.1);
  const T Pddot3_1 = R2_11 * t3_19 + R2_21 * t3_20 + R2_31 * t3_21 + Pddot2_1;
  const T Pddot3_2 = R2_12 * t3_19 + R2_22 * t3_20 + R2_32 * t3_21 + Pddot2_2;
  const T Pddot3_3 = R2_13 * t3_19 + R2_23 * t3_20 + R2_33 * t3_21 + Pddot2_3;
  // N2 = R2 R3^T M_torque_3_ + axial(U2 (tr(I2)/2 - I2)) - M_torque_2_: moment balance about the mass centre, body
  //   axes [N m]
  const T t3_22 = R3_11 * u.tau_3_1 + R3_21 * u.tau_3_2 + R3_31 * u.tau_3_3;
  const T t3_23 = R3_12 * u.tau_3_1 + R3_22 * u.tau_3_2 + R3_32 * u.tau_3_3;
  const T t3_24 = R3_13 * u.tau_3_1 + R3_23 * u.tau_3_2 + R3_33 * u.tau_3_3;
  const T N2_1 = R2_11 * t3_22 + R2_12 * t3_23 + R2_13 * t3_24 + T(0.036000000000000004) * U2_32 -
      T(0.08399999999999999) * U2_23 + T(0.0048) * (minus_U2_22 - minus_U2_33) - T(0.006) * U2_31 + T(0.0036) * U2_21
      - u.tau_2_1;
  const T N2_2 = R2_21 * t3_22 + R2_22 * t3_23 + R2_23 * t3_24 + T(0.08399999999999999) * U2_13 - T(0.06) * U2_31 -
      T(0.0036) * (minus_U2_33 - minus_U2_11) + T(0.0048) * U2_12 + T(0.006) * U2_32 - u.tau_2_2;
  const T N2_3 = R2_31 * t3_22 + R2_32 * t3_23 + R2_33 * t3_24 + T(0.06) * U2_21 - T(0.036000000000000004) * U2_12 -
      T(0.006) * (minus_U2_11 - minus_U2_22) - T(0.0036) * U2_23 - T(0.0048) * U2_13 - u.tau_2_3;
  // a3 = R3^T U3 r3 + Pddot3: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t3_25 = U3_12 * T(0.2);
  const T t3_26 = t3_25 - minus_U3_11 * T(0.1) + U3_13 * T(0.05);
  const T t3_27 = minus_U3_22 * T(0.2);
  const T t3_28 = U3_21 * T(0.1) - t3_27 + U3_23 * T(0.05);
  const T t3_29 = U3_32 * T(0.2);
  const T t3_30 = U3_31 * T(0.1) + t3_29 - minus_U3_33 * T(0.05);
  const T a3_1 = R3_11 * t3_26 + R3_21 * t3_28 + R3_31 * t3_30 + Pddot3_1;
  const T a3_2 = R3_12 * t3_26 + R3_22 * t3_28 + R3_32 * t3_30 + Pddot3_2;
  const T a3_3 = R3_13 * t3_26 + R3_23 * t3_28 + R3_33 * t3_30 + Pddot3_3;
  // G3 = m3 a3: force balance, inertial axes [N]
  const T G3_1 = T(1.3) * a3_1;
  const T G3_2 = T(1.3) * a3_2;
  const T G3_3 = T(1.3) * a3_3;

  // ---- body 4 (body_4) on body 3
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
  // Pddot4 = R3^T U3 q4 + Pddot3: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t4_19 = t3_25 - minus_U3_11 * T(0.3) + U3_13 * T(0.1);
  const T t4_20 = U3_21 * T(0.3) - t3_27 + U3_23 * T(0.1);
  const T t4_21 = U3_31 * T(0.3) + t3_29 - minus_U3_33 * T(0.1);
  const T Pddot4_1 = R3_11 * t4_19 + R3_21 * t4_20 + R3_31 * t4_21 + Pddot3_1;
  const T Pddot4_2 = R3_12 * t4_19 + R3_22 * t4_20 + R3_32 * t4_21 + Pddot3_2;
  const T Pddot4_3 = R3_13 * t4_19 + R3_23 * t4_20 + R3_33 * t4_21 + Pddot3_3;
  // N3 = R3 R4^T M_torque_4_ + axial(U3 (tr(I3)/2 - I3)) - M_torque_3_: moment balance about the mass centre, body
  //   axes [N m]
  const T t4_22 = R4_11 * u.tau_4_1 + R4_21 * u.tau_4_2 + R4_31 * u.tau_4_3;
  const T t4_23 = R4_12 * u.tau_4_1 + R4_22 * u.tau_4_2 + R4_32 * u.tau_4_3;
  const T t4_24 = R4_13 * u.tau_4_1 + R4_23 * u.tau_4_2 + R4_33 * u.tau_4_3;
  const T N3_1 = R3_11 * t4_22 + R3_12 * t4_23 + R3_13 * t4_24 + T(0.039) * U3_32 - T(0.091) * U3_23 + T(0.0052) *
      (minus_U3_22 - minus_U3_33) - T(0.0065) * U3_31 + T(0.0039) * U3_21 - u.tau_3_1;
  const T N3_2 = R3_21 * t4_22 + R3_22 * t4_23 + R3_23 * t4_24 + T(0.091) * U3_13 - T(0.065) * U3_31 - T(0.0039) *
      (minus_U3_33 - minus_U3_11) + T(0.0052) * U3_12 + T(0.0065) * U3_32 - u.tau_3_2;
  const T N3_3 = R3_31 * t4_22 + R3_32 * t4_23 + R3_33 * t4_24 + T(0.065) * U3_21 - T(0.039) * U3_12 - T(0.0065) *
      (minus_U3_11 - minus_U3_22) - T(0.0039) * U3_23 - T(0.0052) * U3_13 - u.tau_3_3;
  // a4 = R4^T U4 r4 + Pddot4: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t4_25 = U4_12 * T(0.2) - minus_U4_11 * T(0.1) + U4_13 * T(0.05);
  const T t4_26 = U4_21 * T(0.1) - minus_U4_22 * T(0.2) + U4_23 * T(0.05);
  const T t4_27 = U4_31 * T(0.1) + U4_32 * T(0.2) - minus_U4_33 * T(0.05);
  const T a4_1 = R4_11 * t4_25 + R4_21 * t4_26 + R4_31 * t4_27 + Pddot4_1;
  const T a4_2 = R4_12 * t4_25 + R4_22 * t4_26 + R4_32 * t4_27 + Pddot4_2;
  const T a4_3 = R4_13 * t4_25 + R4_23 * t4_26 + R4_33 * t4_27 + Pddot4_3;
  // G4 = m4 a4: force balance, inertial axes [N]
  const T G4_1 = T(1.4) * a4_1;
  const T G4_2 = T(1.4) * a4_2;
  const T G4_3 = T(1.4) * a4_3;

  // ---- body 5 (body_5) on body 4
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
  // Pddot5 = R4^T U4 q5 + Pddot4: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t5_19 = U4_12 * T(0.25) - minus_U4_11 * T(0.3) + U4_13 * T(0.1);
  const T t5_20 = U4_21 * T(0.3) - minus_U4_22 * T(0.25) + U4_23 * T(0.1);
  const T t5_21 = U4_31 * T(0.3) + U4_32 * T(0.25) - minus_U4_33 * T(0.1);
  const T Pddot5_1 = R4_11 * t5_19 + R4_21 * t5_20 + R4_31 * t5_21 + Pddot4_1;
  const T Pddot5_2 = R4_12 * t5_19 + R4_22 * t5_20 + R4_32 * t5_21 + Pddot4_2;
  const T Pddot5_3 = R4_13 * t5_19 + R4_23 * t5_20 + R4_33 * t5_21 + Pddot4_3;
  // N4 = R4 R5^T M_torque_5_ + axial(U4 (tr(I4)/2 - I4)) - M_torque_4_: moment balance about the mass centre, body
  //   axes [N m]
  const T t5_22 = R5_11 * u.tau_5_1 + R5_21 * u.tau_5_2 + R5_31 * u.tau_5_3;
  const T t5_23 = R5_12 * u.tau_5_1 + R5_22 * u.tau_5_2 + R5_32 * u.tau_5_3;
  const T t5_24 = R5_13 * u.tau_5_1 + R5_23 * u.tau_5_2 + R5_33 * u.tau_5_3;
  const T N4_1 = R4_11 * t5_22 + R4_12 * t5_23 + R4_13 * t5_24 + T(0.042) * U4_32 - T(0.098) * U4_23 + T(0.0056) *
      (minus_U4_22 - minus_U4_33) - T(0.007) * U4_31 + T(0.0042) * U4_21 - u.tau_4_1;
  const T N4_2 = R4_21 * t5_22 + R4_22 * t5_23 + R4_23 * t5_24 + T(0.098) * U4_13 - T(0.07) * U4_31 - T(0.0042) *
      (minus_U4_33 - minus_U4_11) + T(0.0056) * U4_12 + T(0.007) * U4_32 - u.tau_4_2;
  const T N4_3 = R4_31 * t5_22 + R4_32 * t5_23 + R4_33 * t5_24 + T(0.07) * U4_21 - T(0.042) * U4_12 - T(0.007) *
      (minus_U4_11 - minus_U4_22) - T(0.0042) * U4_23 - T(0.0056) * U4_13 - u.tau_4_3;
  // a5 = R5^T U5 r5 + Pddot5: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t5_25 = U5_12 * T(0.2) - minus_U5_11 * T(0.1) + U5_13 * T(0.05);
  const T t5_26 = U5_21 * T(0.1) - minus_U5_22 * T(0.2) + U5_23 * T(0.05);
  const T t5_27 = U5_31 * T(0.1) + U5_32 * T(0.2) - minus_U5_33 * T(0.05);
  const T a5_1 = R5_11 * t5_25 + R5_21 * t5_26 + R5_31 * t5_27 + Pddot5_1;
  const T a5_2 = R5_12 * t5_25 + R5_22 * t5_26 + R5_32 * t5_27 + Pddot5_2;
  const T a5_3 = R5_13 * t5_25 + R5_23 * t5_26 + R5_33 * t5_27 + Pddot5_3;
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
  // Pddot6 = R5^T U5 q6 + Pddot5: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t6_19 = U5_12 * T(0.3) - minus_U5_11 * T(0.3) + U5_13 * T(0.1);
  const T t6_20 = U5_21 * T(0.3) - minus_U5_22 * T(0.3) + U5_23 * T(0.1);
  const T t6_21 = U5_31 * T(0.3) + U5_32 * T(0.3) - minus_U5_33 * T(0.1);
  const T Pddot6_1 = R5_11 * t6_19 + R5_21 * t6_20 + R5_31 * t6_21 + Pddot5_1;
  const T Pddot6_2 = R5_12 * t6_19 + R5_22 * t6_20 + R5_32 * t6_21 + Pddot5_2;
  const T Pddot6_3 = R5_13 * t6_19 + R5_23 * t6_20 + R5_33 * t6_21 + Pddot5_3;
  // N5 = R5 R6^T M_torque_6_ + axial(U5 (tr(I5)/2 - I5)) - M_torque_5_: moment balance about the mass centre, body
  //   axes [N m]
  const T t6_22 = R6_11 * u.tau_6_1 + R6_21 * u.tau_6_2 + R6_31 * u.tau_6_3;
  const T t6_23 = R6_12 * u.tau_6_1 + R6_22 * u.tau_6_2 + R6_32 * u.tau_6_3;
  const T t6_24 = R6_13 * u.tau_6_1 + R6_23 * u.tau_6_2 + R6_33 * u.tau_6_3;
  const T N5_1 = R5_11 * t6_22 + R5_12 * t6_23 + R5_13 * t6_24 + T(0.045) * U5_32 - T(0.105) * U5_23 + T(0.006) *
      (minus_U5_22 - minus_U5_33) - T(0.0075) * U5_31 + T(0.0045) * U5_21 - u.tau_5_1;
  const T N5_2 = R5_21 * t6_22 + R5_22 * t6_23 + R5_23 * t6_24 + T(0.105) * U5_13 - T(0.075) * U5_31 - T(0.0045) *
      (minus_U5_33 - minus_U5_11) + T(0.006) * U5_12 + T(0.0075) * U5_32 - u.tau_5_2;
  const T N5_3 = R5_31 * t6_22 + R5_32 * t6_23 + R5_33 * t6_24 + T(0.075) * U5_21 - T(0.045) * U5_12 - T(0.0075) *
      (minus_U5_11 - minus_U5_22) - T(0.0045) * U5_23 - T(0.006) * U5_13 - u.tau_5_3;
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

  // ---- body 7 (body_7) on body 6
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  const T omegadot7_1 = ydot[18], omegadot7_2 = ydot[19], omegadot7_3 = ydot[20];
  // R7^T = 1 + 2 e7~ (eps4_7 + e7~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t7_1 = T(2) * eps7_2;
  const T t7_2 = t7_1 * eps7_2;
  const T t7_3 = T(2) * eps7_3;
  const T t7_4 = t7_3 * eps7_3;
  const T R7_11 = T(1) - t7_2 - t7_4;
  const T t7_5 = T(2) * eps7_1;
  const T t7_6 = t7_5 * eps7_2;
  const T t7_7 = t7_3 * eps7_4;
  const T R7_12 = t7_6 + t7_7;
  const T t7_8 = t7_5 * eps7_3;
  const T t7_9 = t7_1 * eps7_4;
  const T R7_13 = t7_8 - t7_9;
  const T R7_21 = t7_6 - t7_7;
  const T t7_10 = T(1) - t7_5 * eps7_1;
  const T R7_22 = t7_10 - t7_4;
  const T t7_11 = t7_1 * eps7_3;
  const T t7_12 = t7_5 * eps7_4;
  const T R7_23 = t7_11 + t7_12;
  const T R7_31 = t7_8 + t7_9;
  const T R7_32 = t7_11 - t7_12;
  const T R7_33 = t7_10 - t7_2;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t7_13 = omega7_3 * omega7_3;
  const T t7_14 = omega7_2 * omega7_2;
  const T minus_U7_11 = t7_13 + t7_14;
  const T t7_15 = omega7_2 * omega7_1;
  const T U7_12 = t7_15 - omegadot7_3;
  const T t7_16 = omega7_3 * omega7_1;
  const T U7_13 = t7_16 + omegadot7_2;
  const T U7_21 = t7_15 + omegadot7_3;
  const T t7_17 = omega7_1 * omega7_1;
  const T minus_U7_22 = t7_13 + t7_17;
  const T t7_18 = omega7_3 * omega7_2;
  const T U7_23 = t7_18 - omegadot7_1;
  const T U7_31 = t7_16 - omegadot7_2;
  const T U7_32 = t7_18 + omegadot7_1;
  const T minus_U7_33 = t7_14 + t7_17;
  // Pddot7 = R6^T U6 q7 + Pddot6: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t7_19 = U6_12 * T(0.35) - minus_U6_11 * T(0.3) + U6_13 * T(0.1);
  const T t7_20 = U6_21 * T(0.3) - minus_U6_22 * T(0.35) + U6_23 * T(0.1);
  const T t7_21 = U6_31 * T(0.3) + U6_32 * T(0.35) - minus_U6_33 * T(0.1);
  const T Pddot7_1 = R6_11 * t7_19 + R6_21 * t7_20 + R6_31 * t7_21 + Pddot6_1;
  const T Pddot7_2 = R6_12 * t7_19 + R6_22 * t7_20 + R6_32 * t7_21 + Pddot6_2;
  const T Pddot7_3 = R6_13 * t7_19 + R6_23 * t7_20 + R6_33 * t7_21 + Pddot6_3;
  // N6 = R6 R7^T M_torque_7_ + axial(U6 (tr(I6)/2 - I6)) - M_torque_6_: moment balance about the mass centre, body
  //   axes [N m]
  const T t7_22 = R7_11 * u.tau_7_1 + R7_21 * u.tau_7_2 + R7_31 * u.tau_7_3;
  const T t7_23 = R7_12 * u.tau_7_1 + R7_22 * u.tau_7_2 + R7_32 * u.tau_7_3;
  const T t7_24 = R7_13 * u.tau_7_1 + R7_23 * u.tau_7_2 + R7_33 * u.tau_7_3;
  const T N6_1 = R6_11 * t7_22 + R6_12 * t7_23 + R6_13 * t7_24 + T(0.048) * U6_32 - T(0.112) * U6_23 + T(0.0064) *
      (minus_U6_22 - minus_U6_33) - T(0.008) * U6_31 + T(0.0048) * U6_21 - u.tau_6_1;
  const T N6_2 = R6_21 * t7_22 + R6_22 * t7_23 + R6_23 * t7_24 + T(0.112) * U6_13 - T(0.08) * U6_31 - T(0.0048) *
      (minus_U6_33 - minus_U6_11) + T(0.0064) * U6_12 + T(0.008) * U6_32 - u.tau_6_2;
  const T N6_3 = R6_31 * t7_22 + R6_32 * t7_23 + R6_33 * t7_24 + T(0.08) * U6_21 - T(0.048) * U6_12 - T(0.008) *
      (minus_U6_11 - minus_U6_22) - T(0.0048) * U6_23 - T(0.0064) * U6_13 - u.tau_6_3;
  // a7 = R7^T U7 r7 + Pddot7: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t7_25 = U7_12 * T(0.2) - minus_U7_11 * T(0.1) + U7_13 * T(0.05);
  const T t7_26 = U7_21 * T(0.1) - minus_U7_22 * T(0.2) + U7_23 * T(0.05);
  const T t7_27 = U7_31 * T(0.1) + U7_32 * T(0.2) - minus_U7_33 * T(0.05);
  const T a7_1 = R7_11 * t7_25 + R7_21 * t7_26 + R7_31 * t7_27 + Pddot7_1;
  const T a7_2 = R7_12 * t7_25 + R7_22 * t7_26 + R7_32 * t7_27 + Pddot7_2;
  const T a7_3 = R7_13 * t7_25 + R7_23 * t7_26 + R7_33 * t7_27 + Pddot7_3;
  // G7 = m7 a7: force balance, inertial axes [N]
  const T G7_1 = T(1.7) * a7_1;
  const T G7_2 = T(1.7) * a7_2;
  const T G7_3 = T(1.7) * a7_3;

  // ---- body 8 (body_8) on body 7
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  const T omegadot8_1 = ydot[21], omegadot8_2 = ydot[22], omegadot8_3 = ydot[23];
  // R8^T = 1 + 2 e8~ (eps4_8 + e8~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t8_1 = T(2) * eps8_2;
  const T t8_2 = t8_1 * eps8_2;
  const T t8_3 = T(2) * eps8_3;
  const T t8_4 = t8_3 * eps8_3;
  const T R8_11 = T(1) - t8_2 - t8_4;
  const T t8_5 = T(2) * eps8_1;
  const T t8_6 = t8_5 * eps8_2;
  const T t8_7 = t8_3 * eps8_4;
  const T R8_12 = t8_6 + t8_7;
  const T t8_8 = t8_5 * eps8_3;
  const T t8_9 = t8_1 * eps8_4;
  const T R8_13 = t8_8 - t8_9;
  const T R8_21 = t8_6 - t8_7;
  const T t8_10 = T(1) - t8_5 * eps8_1;
  const T R8_22 = t8_10 - t8_4;
  const T t8_11 = t8_1 * eps8_3;
  const T t8_12 = t8_5 * eps8_4;
  const T R8_23 = t8_11 + t8_12;
  const T R8_31 = t8_8 + t8_9;
  const T R8_32 = t8_11 - t8_12;
  const T R8_33 = t8_10 - t8_2;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_13 = omega8_3 * omega8_3;
  const T t8_14 = omega8_2 * omega8_2;
  const T minus_U8_11 = t8_13 + t8_14;
  const T t8_15 = omega8_2 * omega8_1;
  const T U8_12 = t8_15 - omegadot8_3;
  const T t8_16 = omega8_3 * omega8_1;
  const T U8_13 = t8_16 + omegadot8_2;
  const T U8_21 = t8_15 + omegadot8_3;
  const T t8_17 = omega8_1 * omega8_1;
  const T minus_U8_22 = t8_13 + t8_17;
  const T t8_18 = omega8_3 * omega8_2;
  const T U8_23 = t8_18 - omegadot8_1;
  const T U8_31 = t8_16 - omegadot8_2;
  const T U8_32 = t8_18 + omegadot8_1;
  const T minus_U8_33 = t8_14 + t8_17;
  // Pddot8 = R7^T U7 q8 + Pddot7: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t8_19 = U7_12 * T(0.4) - minus_U7_11 * T(0.3) + U7_13 * T(0.1);
  const T t8_20 = U7_21 * T(0.3) - minus_U7_22 * T(0.4) + U7_23 * T(0.1);
  const T t8_21 = U7_31 * T(0.3) + U7_32 * T(0.4) - minus_U7_33 * T(0.1);
  const T Pddot8_1 = R7_11 * t8_19 + R7_21 * t8_20 + R7_31 * t8_21 + Pddot7_1;
  const T Pddot8_2 = R7_12 * t8_19 + R7_22 * t8_20 + R7_32 * t8_21 + Pddot7_2;
  const T Pddot8_3 = R7_13 * t8_19 + R7_23 * t8_20 + R7_33 * t8_21 + Pddot7_3;
  // N7 = R7 R8^T M_torque_8_ + axial(U7 (tr(I7)/2 - I7)) - M_torque_7_: moment balance about the mass centre, body
  //   axes [N m]
  const T t8_22 = R8_11 * u.tau_8_1 + R8_21 * u.tau_8_2 + R8_31 * u.tau_8_3;
  const T t8_23 = R8_12 * u.tau_8_1 + R8_22 * u.tau_8_2 + R8_32 * u.tau_8_3;
  const T t8_24 = R8_13 * u.tau_8_1 + R8_23 * u.tau_8_2 + R8_33 * u.tau_8_3;
  const T N7_1 = R7_11 * t8_22 + R7_12 * t8_23 + R7_13 * t8_24 + T(0.05100000000000002) * U7_32 - T(0.119) * U7_23 +
      T(0.0068) * (minus_U7_22 - minus_U7_33) - T(0.0085) * U7_31 + T(0.0051) * U7_21 - u.tau_7_1;
  const T N7_2 = R7_21 * t8_22 + R7_22 * t8_23 + R7_23 * t8_24 + T(0.119) * U7_13 - T(0.08499999999999999) * U7_31 -
      T(0.0051) * (minus_U7_33 - minus_U7_11) + T(0.0068) * U7_12 + T(0.0085) * U7_32 - u.tau_7_2;
  const T N7_3 = R7_31 * t8_22 + R7_32 * t8_23 + R7_33 * t8_24 + T(0.08499999999999999) * U7_21 -
      T(0.05100000000000002) * U7_12 - T(0.0085) * (minus_U7_11 - minus_U7_22) - T(0.0051) * U7_23 - T(0.0068) * U7_13
      - u.tau_7_3;
  // a8 = R8^T U8 r8 + Pddot8: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t8_25 = U8_12 * T(0.2) - minus_U8_11 * T(0.1) + U8_13 * T(0.05);
  const T t8_26 = U8_21 * T(0.1) - minus_U8_22 * T(0.2) + U8_23 * T(0.05);
  const T t8_27 = U8_31 * T(0.1) + U8_32 * T(0.2) - minus_U8_33 * T(0.05);
  const T a8_1 = R8_11 * t8_25 + R8_21 * t8_26 + R8_31 * t8_27 + Pddot8_1;
  const T a8_2 = R8_12 * t8_25 + R8_22 * t8_26 + R8_32 * t8_27 + Pddot8_2;
  const T a8_3 = R8_13 * t8_25 + R8_23 * t8_26 + R8_33 * t8_27 + Pddot8_3;
  // G8 = m8 a8: force balance, inertial axes [N]
  const T G8_1 = T(1.8) * a8_1;
  const T G8_2 = T(1.8) * a8_2;
  const T G8_3 = T(1.8) * a8_3;

  // ---- body 9 (body_9) on body 8
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  const T omegadot9_1 = ydot[24], omegadot9_2 = ydot[25], omegadot9_3 = ydot[26];
  // R9^T = 1 + 2 e9~ (eps4_9 + e9~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t9_1 = T(2) * eps9_2;
  const T t9_2 = t9_1 * eps9_2;
  const T t9_3 = T(2) * eps9_3;
  const T t9_4 = t9_3 * eps9_3;
  const T R9_11 = T(1) - t9_2 - t9_4;
  const T t9_5 = T(2) * eps9_1;
  const T t9_6 = t9_5 * eps9_2;
  const T t9_7 = t9_3 * eps9_4;
  const T R9_12 = t9_6 + t9_7;
  const T t9_8 = t9_5 * eps9_3;
  const T t9_9 = t9_1 * eps9_4;
  const T R9_13 = t9_8 - t9_9;
  const T R9_21 = t9_6 - t9_7;
  const T t9_10 = T(1) - t9_5 * eps9_1;
  const T R9_22 = t9_10 - t9_4;
  const T t9_11 = t9_1 * eps9_3;
  const T t9_12 = t9_5 * eps9_4;
  const T R9_23 = t9_11 + t9_12;
  const T R9_31 = t9_8 + t9_9;
  const T R9_32 = t9_11 - t9_12;
  const T R9_33 = t9_10 - t9_2;
  // U9 = omega9~ omega9~ + omegadot9~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t9_13 = omega9_3 * omega9_3;
  const T t9_14 = omega9_2 * omega9_2;
  const T minus_U9_11 = t9_13 + t9_14;
  const T t9_15 = omega9_2 * omega9_1;
  const T U9_12 = t9_15 - omegadot9_3;
  const T t9_16 = omega9_3 * omega9_1;
  const T U9_13 = t9_16 + omegadot9_2;
  const T U9_21 = t9_15 + omegadot9_3;
  const T t9_17 = omega9_1 * omega9_1;
  const T minus_U9_22 = t9_13 + t9_17;
  const T t9_18 = omega9_3 * omega9_2;
  const T U9_23 = t9_18 - omegadot9_1;
  const T U9_31 = t9_16 - omegadot9_2;
  const T U9_32 = t9_18 + omegadot9_1;
  const T minus_U9_33 = t9_14 + t9_17;
  // Pddot9 = R8^T U8 q9 + Pddot8: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t9_19 = U8_12 * T(0.45) - minus_U8_11 * T(0.3) + U8_13 * T(0.1);
  const T t9_20 = U8_21 * T(0.3) - minus_U8_22 * T(0.45) + U8_23 * T(0.1);
  const T t9_21 = U8_31 * T(0.3) + U8_32 * T(0.45) - minus_U8_33 * T(0.1);
  const T Pddot9_1 = R8_11 * t9_19 + R8_21 * t9_20 + R8_31 * t9_21 + Pddot8_1;
  const T Pddot9_2 = R8_12 * t9_19 + R8_22 * t9_20 + R8_32 * t9_21 + Pddot8_2;
  const T Pddot9_3 = R8_13 * t9_19 + R8_23 * t9_20 + R8_33 * t9_21 + Pddot8_3;
  // N8 = R8 R9^T M_torque_9_ + axial(U8 (tr(I8)/2 - I8)) - M_torque_8_: moment balance about the mass centre, body
  //   axes [N m]
  const T t9_22 = R9_11 * u.tau_9_1 + R9_21 * u.tau_9_2 + R9_31 * u.tau_9_3;
  const T t9_23 = R9_12 * u.tau_9_1 + R9_22 * u.tau_9_2 + R9_32 * u.tau_9_3;
  const T t9_24 = R9_13 * u.tau_9_1 + R9_23 * u.tau_9_2 + R9_33 * u.tau_9_3;
  const T N8_1 = R8_11 * t9_22 + R8_12 * t9_23 + R8_13 * t9_24 + T(0.05399999999999999) * U8_32 - T(0.126) * U8_23 +
      T(0.0072) * (minus_U8_22 - minus_U8_33) - T(0.009) * U8_31 + T(0.0054) * U8_21 - u.tau_8_1;
  const T N8_2 = R8_21 * t9_22 + R8_22 * t9_23 + R8_23 * t9_24 + T(0.126) * U8_13 - T(0.09) * U8_31 - T(0.0054) *
      (minus_U8_33 - minus_U8_11) + T(0.0072) * U8_12 + T(0.009) * U8_32 - u.tau_8_2;
  const T N8_3 = R8_31 * t9_22 + R8_32 * t9_23 + R8_33 * t9_24 + T(0.09) * U8_21 - T(0.05399999999999999) * U8_12 -
      T(0.009) * (minus_U8_11 - minus_U8_22) - T(0.0054) * U8_23 - T(0.0072) * U8_13 - u.tau_8_3;
  // a9 = R9^T U9 r9 + Pddot9: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t9_25 = U9_12 * T(0.2) - minus_U9_11 * T(0.1) + U9_13 * T(0.05);
  const T t9_26 = U9_21 * T(0.1) - minus_U9_22 * T(0.2) + U9_23 * T(0.05);
  const T t9_27 = U9_31 * T(0.1) + U9_32 * T(0.2) - minus_U9_33 * T(0.05);
  const T a9_1 = R9_11 * t9_25 + R9_21 * t9_26 + R9_31 * t9_27 + Pddot9_1;
  const T a9_2 = R9_12 * t9_25 + R9_22 * t9_26 + R9_32 * t9_27 + Pddot9_2;
  const T a9_3 = R9_13 * t9_25 + R9_23 * t9_26 + R9_33 * t9_27 + Pddot9_3;
  // G9 = m9 a9: force balance, inertial axes [N]
  const T G9_1 = T(1.9) * a9_1;
  const T G9_2 = T(1.9) * a9_2;
  const T G9_3 = T(1.9) * a9_3;

  // ---- body 10 (body_10) on body 9
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  const T omegadot10_1 = ydot[27], omegadot10_2 = ydot[28], omegadot10_3 = ydot[29];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // U10 = omega10~ omega10~ + omegadot10~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t10_13 = omega10_3 * omega10_3;
  const T t10_14 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_13 + t10_14;
  const T t10_15 = omega10_2 * omega10_1;
  const T U10_12 = t10_15 - omegadot10_3;
  const T t10_16 = omega10_3 * omega10_1;
  const T U10_13 = t10_16 + omegadot10_2;
  const T U10_21 = t10_15 + omegadot10_3;
  const T t10_17 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_13 + t10_17;
  const T t10_18 = omega10_3 * omega10_2;
  const T U10_23 = t10_18 - omegadot10_1;
  const T U10_31 = t10_16 - omegadot10_2;
  const T U10_32 = t10_18 + omegadot10_1;
  const T minus_U10_33 = t10_14 + t10_17;
  // Pddot10 = R9^T U9 q10 + Pddot9: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t10_19 = U9_12 * T(0.5) - minus_U9_11 * T(0.3) + U9_13 * T(0.1);
  const T t10_20 = U9_21 * T(0.3) - minus_U9_22 * T(0.5) + U9_23 * T(0.1);
  const T t10_21 = U9_31 * T(0.3) + U9_32 * T(0.5) - minus_U9_33 * T(0.1);
  const T Pddot10_1 = R9_11 * t10_19 + R9_21 * t10_20 + R9_31 * t10_21 + Pddot9_1;
  const T Pddot10_2 = R9_12 * t10_19 + R9_22 * t10_20 + R9_32 * t10_21 + Pddot9_2;
  const T Pddot10_3 = R9_13 * t10_19 + R9_23 * t10_20 + R9_33 * t10_21 + Pddot9_3;
  // N9 = R9 R10^T M_torque_10_ + axial(U9 (tr(I9)/2 - I9)) - M_torque_9_: moment balance about the mass centre, body
  //   axes [N m]
  const T t10_22 = R10_11 * u.tau_10_1 + R10_21 * u.tau_10_2 + R10_31 * u.tau_10_3;
  const T t10_23 = R10_12 * u.tau_10_1 + R10_22 * u.tau_10_2 + R10_32 * u.tau_10_3;
  const T t10_24 = R10_13 * u.tau_10_1 + R10_23 * u.tau_10_2 + R10_33 * u.tau_10_3;
  const T N9_1 = R9_11 * t10_22 + R9_12 * t10_23 + R9_13 * t10_24 + T(0.056999999999999995) * U9_32 - T(0.133) * U9_23
      + T(0.0076) * (minus_U9_22 - minus_U9_33) - T(0.0095) * U9_31 + T(0.0057) * U9_21 - u.tau_9_1;
  const T N9_2 = R9_21 * t10_22 + R9_22 * t10_23 + R9_23 * t10_24 + T(0.133) * U9_13 - T(0.095) * U9_31 - T(0.0057) *
      (minus_U9_33 - minus_U9_11) + T(0.0076) * U9_12 + T(0.0095) * U9_32 - u.tau_9_2;
  const T N9_3 = R9_31 * t10_22 + R9_32 * t10_23 + R9_33 * t10_24 + T(0.095) * U9_21 - T(0.056999999999999995) * U9_12
      - T(0.0095) * (minus_U9_11 - minus_U9_22) - T(0.0057) * U9_23 - T(0.0076) * U9_13 - u.tau_9_3;
  // a10 = R10^T U10 r10 + Pddot10: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t10_25 = U10_12 * T(0.2) - minus_U10_11 * T(0.1) + U10_13 * T(0.05);
  const T t10_26 = U10_21 * T(0.1) - minus_U10_22 * T(0.2) + U10_23 * T(0.05);
  const T t10_27 = U10_31 * T(0.1) + U10_32 * T(0.2) - minus_U10_33 * T(0.05);
  const T a10_1 = R10_11 * t10_25 + R10_21 * t10_26 + R10_31 * t10_27 + Pddot10_1;
  const T a10_2 = R10_12 * t10_25 + R10_22 * t10_26 + R10_32 * t10_27 + Pddot10_2;
  const T a10_3 = R10_13 * t10_25 + R10_23 * t10_26 + R10_33 * t10_27 + Pddot10_3;
  // G10 = m10 a10: force balance, inertial axes [N]
  const T G10_1 = T(2) * a10_1;
  const T G10_2 = T(2) * a10_2;
  const T G10_3 = T(2) * a10_3;

  // ---- body 11 (body_11) on body 10
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  const T omegadot11_1 = ydot[30], omegadot11_2 = ydot[31], omegadot11_3 = ydot[32];
  // R11^T = 1 + 2 e11~ (eps4_11 + e11~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t11_1 = T(2) * eps11_2;
  const T t11_2 = t11_1 * eps11_2;
  const T t11_3 = T(2) * eps11_3;
  const T t11_4 = t11_3 * eps11_3;
  const T R11_11 = T(1) - t11_2 - t11_4;
  const T t11_5 = T(2) * eps11_1;
  const T t11_6 = t11_5 * eps11_2;
  const T t11_7 = t11_3 * eps11_4;
  const T R11_12 = t11_6 + t11_7;
  const T t11_8 = t11_5 * eps11_3;
  const T t11_9 = t11_1 * eps11_4;
  const T R11_13 = t11_8 - t11_9;
  const T R11_21 = t11_6 - t11_7;
  const T t11_10 = T(1) - t11_5 * eps11_1;
  const T R11_22 = t11_10 - t11_4;
  const T t11_11 = t11_1 * eps11_3;
  const T t11_12 = t11_5 * eps11_4;
  const T R11_23 = t11_11 + t11_12;
  const T R11_31 = t11_8 + t11_9;
  const T R11_32 = t11_11 - t11_12;
  const T R11_33 = t11_10 - t11_2;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_13 = omega11_3 * omega11_3;
  const T t11_14 = omega11_2 * omega11_2;
  const T minus_U11_11 = t11_13 + t11_14;
  const T t11_15 = omega11_2 * omega11_1;
  const T U11_12 = t11_15 - omegadot11_3;
  const T t11_16 = omega11_3 * omega11_1;
  const T U11_13 = t11_16 + omegadot11_2;
  const T U11_21 = t11_15 + omegadot11_3;
  const T t11_17 = omega11_1 * omega11_1;
  const T minus_U11_22 = t11_13 + t11_17;
  const T t11_18 = omega11_3 * omega11_2;
  const T U11_23 = t11_18 - omegadot11_1;
  const T U11_31 = t11_16 - omegadot11_2;
  const T U11_32 = t11_18 + omegadot11_1;
  const T minus_U11_33 = t11_14 + t11_17;
  // Pddot11 = R10^T U10 q11 + Pddot10: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t11_19 = U10_12 * T(0.55) - minus_U10_11 * T(0.3) + U10_13 * T(0.1);
  const T t11_20 = U10_21 * T(0.3) - minus_U10_22 * T(0.55) + U10_23 * T(0.1);
  const T t11_21 = U10_31 * T(0.3) + U10_32 * T(0.55) - minus_U10_33 * T(0.1);
  const T Pddot11_1 = R10_11 * t11_19 + R10_21 * t11_20 + R10_31 * t11_21 + Pddot10_1;
  const T Pddot11_2 = R10_12 * t11_19 + R10_22 * t11_20 + R10_32 * t11_21 + Pddot10_2;
  const T Pddot11_3 = R10_13 * t11_19 + R10_23 * t11_20 + R10_33 * t11_21 + Pddot10_3;
  // N10 = R10 R11^T M_torque_11_ + axial(U10 (tr(I10)/2 - I10)) - M_torque_10_: moment balance about the mass centre,
  //   body axes [N m]
  const T t11_22 = R11_11 * u.tau_11_1 + R11_21 * u.tau_11_2 + R11_31 * u.tau_11_3;
  const T t11_23 = R11_12 * u.tau_11_1 + R11_22 * u.tau_11_2 + R11_32 * u.tau_11_3;
  const T t11_24 = R11_13 * u.tau_11_1 + R11_23 * u.tau_11_2 + R11_33 * u.tau_11_3;
  const T N10_1 = R10_11 * t11_22 + R10_12 * t11_23 + R10_13 * t11_24 + T(0.06000000000000001) * U10_32 - T(0.14) *
      U10_23 + T(0.008) * (minus_U10_22 - minus_U10_33) - T(0.01) * U10_31 + T(0.006) * U10_21 - u.tau_10_1;
  const T N10_2 = R10_21 * t11_22 + R10_22 * t11_23 + R10_23 * t11_24 + T(0.14) * U10_13 - T(0.09999999999999999) *
      U10_31 - T(0.006) * (minus_U10_33 - minus_U10_11) + T(0.008) * U10_12 + T(0.01) * U10_32 - u.tau_10_2;
  const T N10_3 = R10_31 * t11_22 + R10_32 * t11_23 + R10_33 * t11_24 + T(0.09999999999999999) * U10_21 -
      T(0.06000000000000001) * U10_12 - T(0.01) * (minus_U10_11 - minus_U10_22) - T(0.006) * U10_23 - T(0.008) *
      U10_13 - u.tau_10_3;
  // a11 = R11^T U11 r11 + Pddot11: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t11_25 = U11_12 * T(0.2) - minus_U11_11 * T(0.1) + U11_13 * T(0.05);
  const T t11_26 = U11_21 * T(0.1) - minus_U11_22 * T(0.2) + U11_23 * T(0.05);
  const T t11_27 = U11_31 * T(0.1) + U11_32 * T(0.2) - minus_U11_33 * T(0.05);
  const T a11_1 = R11_11 * t11_25 + R11_21 * t11_26 + R11_31 * t11_27 + Pddot11_1;
  const T a11_2 = R11_12 * t11_25 + R11_22 * t11_26 + R11_32 * t11_27 + Pddot11_2;
  const T a11_3 = R11_13 * t11_25 + R11_23 * t11_26 + R11_33 * t11_27 + Pddot11_3;
  // G11 = m11 a11: force balance, inertial axes [N]
  const T G11_1 = T(2.1) * a11_1;
  const T G11_2 = T(2.1) * a11_2;
  const T G11_3 = T(2.1) * a11_3;

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  const T omegadot12_1 = ydot[33], omegadot12_2 = ydot[34], omegadot12_3 = ydot[35];
  // R12^T = 1 + 2 e12~ (eps4_12 + e12~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t12_1 = T(2) * eps12_2;
  const T t12_2 = t12_1 * eps12_2;
  const T t12_3 = T(2) * eps12_3;
  const T t12_4 = t12_3 * eps12_3;
  const T R12_11 = T(1) - t12_2 - t12_4;
  const T t12_5 = T(2) * eps12_1;
  const T t12_6 = t12_5 * eps12_2;
  const T t12_7 = t12_3 * eps12_4;
  const T R12_12 = t12_6 + t12_7;
  const T t12_8 = t12_5 * eps12_3;
  const T t12_9 = t12_1 * eps12_4;
  const T R12_13 = t12_8 - t12_9;
  const T R12_21 = t12_6 - t12_7;
  const T t12_10 = T(1) - t12_5 * eps12_1;
  const T R12_22 = t12_10 - t12_4;
  const T t12_11 = t12_1 * eps12_3;
  const T t12_12 = t12_5 * eps12_4;
  const T R12_23 = t12_11 + t12_12;
  const T R12_31 = t12_8 + t12_9;
  const T R12_32 = t12_11 - t12_12;
  const T R12_33 = t12_10 - t12_2;
  // U12 = omega12~ omega12~ + omegadot12~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t12_13 = omega12_3 * omega12_3;
  const T t12_14 = omega12_2 * omega12_2;
  const T minus_U12_11 = t12_13 + t12_14;
  const T t12_15 = omega12_2 * omega12_1;
  const T U12_12 = t12_15 - omegadot12_3;
  const T t12_16 = omega12_3 * omega12_1;
  const T U12_13 = t12_16 + omegadot12_2;
  const T U12_21 = t12_15 + omegadot12_3;
  const T t12_17 = omega12_1 * omega12_1;
  const T minus_U12_22 = t12_13 + t12_17;
  const T t12_18 = omega12_3 * omega12_2;
  const T U12_23 = t12_18 - omegadot12_1;
  const T U12_31 = t12_16 - omegadot12_2;
  const T U12_32 = t12_18 + omegadot12_1;
  const T minus_U12_33 = t12_14 + t12_17;
  // Pddot12 = R11^T U11 q12 + Pddot11: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t12_19 = U11_12 * T(0.6) - minus_U11_11 * T(0.3) + U11_13 * T(0.1);
  const T t12_20 = U11_21 * T(0.3) - minus_U11_22 * T(0.6) + U11_23 * T(0.1);
  const T t12_21 = U11_31 * T(0.3) + U11_32 * T(0.6) - minus_U11_33 * T(0.1);
  const T Pddot12_1 = R11_11 * t12_19 + R11_21 * t12_20 + R11_31 * t12_21 + Pddot11_1;
  const T Pddot12_2 = R11_12 * t12_19 + R11_22 * t12_20 + R11_32 * t12_21 + Pddot11_2;
  const T Pddot12_3 = R11_13 * t12_19 + R11_23 * t12_20 + R11_33 * t12_21 + Pddot11_3;
  // N11 = R11 R12^T M_torque_12_ + axial(U11 (tr(I11)/2 - I11)) - M_torque_11_: moment balance about the mass centre,
  //   body axes [N m]
  const T t12_22 = R12_11 * u.tau_12_1 + R12_21 * u.tau_12_2 + R12_31 * u.tau_12_3;
  const T t12_23 = R12_12 * u.tau_12_1 + R12_22 * u.tau_12_2 + R12_32 * u.tau_12_3;
  const T t12_24 = R12_13 * u.tau_12_1 + R12_23 * u.tau_12_2 + R12_33 * u.tau_12_3;
  const T N11_1 = R11_11 * t12_22 + R11_12 * t12_23 + R11_13 * t12_24 + T(0.063) * U11_32 - T(0.147) * U11_23 +
      T(0.0084) * (minus_U11_22 - minus_U11_33) - T(0.0105) * U11_31 + T(0.0063) * U11_21 - u.tau_11_1;
  const T N11_2 = R11_21 * t12_22 + R11_22 * t12_23 + R11_23 * t12_24 + T(0.147) * U11_13 - T(0.10500000000000001) *
      U11_31 - T(0.0063) * (minus_U11_33 - minus_U11_11) + T(0.0084) * U11_12 + T(0.0105) * U11_32 - u.tau_11_2;
  const T N11_3 = R11_31 * t12_22 + R11_32 * t12_23 + R11_33 * t12_24 + T(0.10500000000000001) * U11_21 - T(0.063) *
      U11_12 - T(0.0105) * (minus_U11_11 - minus_U11_22) - T(0.0063) * U11_23 - T(0.0084) * U11_13 - u.tau_11_3;
  // a12 = R12^T U12 r12 + Pddot12: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t12_25 = U12_12 * T(0.2) - minus_U12_11 * T(0.1) + U12_13 * T(0.05);
  const T t12_26 = U12_21 * T(0.1) - minus_U12_22 * T(0.2) + U12_23 * T(0.05);
  const T t12_27 = U12_31 * T(0.1) + U12_32 * T(0.2) - minus_U12_33 * T(0.05);
  const T a12_1 = R12_11 * t12_25 + R12_21 * t12_26 + R12_31 * t12_27 + Pddot12_1;
  const T a12_2 = R12_12 * t12_25 + R12_22 * t12_26 + R12_32 * t12_27 + Pddot12_2;
  const T a12_3 = R12_13 * t12_25 + R12_23 * t12_26 + R12_33 * t12_27 + Pddot12_3;
  // G12 = m12 a12: force balance, inertial axes [N]
  const T G12_1 = T(2.2) * a12_1;
  const T G12_2 = T(2.2) * a12_2;
  const T G12_3 = T(2.2) * a12_3;

  // ---- body 13 (body_13) on body 12
  const T eps13_1 = x[48], eps13_2 = x[49], eps13_3 = x[50], eps13_4 = x[51];
  const T omega13_1 = y[36], omega13_2 = y[37], omega13_3 = y[38];
  const T omegadot13_1 = ydot[36], omegadot13_2 = ydot[37], omegadot13_3 = ydot[38];
  // R13^T = 1 + 2 e13~ (eps4_13 + e13~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t13_1 = T(2) * eps13_2;
  const T t13_2 = t13_1 * eps13_2;
  const T t13_3 = T(2) * eps13_3;
  const T t13_4 = t13_3 * eps13_3;
  const T R13_11 = T(1) - t13_2 - t13_4;
  const T t13_5 = T(2) * eps13_1;
  const T t13_6 = t13_5 * eps13_2;
  const T t13_7 = t13_3 * eps13_4;
  const T R13_12 = t13_6 + t13_7;
  const T t13_8 = t13_5 * eps13_3;
  const T t13_9 = t13_1 * eps13_4;
  const T R13_13 = t13_8 - t13_9;
  const T R13_21 = t13_6 - t13_7;
  const T t13_10 = T(1) - t13_5 * eps13_1;
  const T R13_22 = t13_10 - t13_4;
  const T t13_11 = t13_1 * eps13_3;
  const T t13_12 = t13_5 * eps13_4;
  const T R13_23 = t13_11 + t13_12;
  const T R13_31 = t13_8 + t13_9;
  const T R13_32 = t13_11 - t13_12;
  const T R13_33 = t13_10 - t13_2;
  // U13 = omega13~ omega13~ + omegadot13~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t13_13 = omega13_3 * omega13_3;
  const T t13_14 = omega13_2 * omega13_2;
  const T minus_U13_11 = t13_13 + t13_14;
  const T t13_15 = omega13_2 * omega13_1;
  const T U13_12 = t13_15 - omegadot13_3;
  const T t13_16 = omega13_3 * omega13_1;
  const T U13_13 = t13_16 + omegadot13_2;
  const T U13_21 = t13_15 + omegadot13_3;
  const T t13_17 = omega13_1 * omega13_1;
  const T minus_U13_22 = t13_13 + t13_17;
  const T t13_18 = omega13_3 * omega13_2;
  const T U13_23 = t13_18 - omegadot13_1;
  const T U13_31 = t13_16 - omegadot13_2;
  const T U13_32 = t13_18 + omegadot13_1;
  const T minus_U13_33 = t13_14 + t13_17;
  // Pddot13 = R12^T U12 q13 + Pddot12: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t13_19 = U12_12 * T(0.65) - minus_U12_11 * T(0.3) + U12_13 * T(0.1);
  const T t13_20 = U12_21 * T(0.3) - minus_U12_22 * T(0.65) + U12_23 * T(0.1);
  const T t13_21 = U12_31 * T(0.3) + U12_32 * T(0.65) - minus_U12_33 * T(0.1);
  const T Pddot13_1 = R12_11 * t13_19 + R12_21 * t13_20 + R12_31 * t13_21 + Pddot12_1;
  const T Pddot13_2 = R12_12 * t13_19 + R12_22 * t13_20 + R12_32 * t13_21 + Pddot12_2;
  const T Pddot13_3 = R12_13 * t13_19 + R12_23 * t13_20 + R12_33 * t13_21 + Pddot12_3;
  // N12 = R12 R13^T M_torque_13_ + axial(U12 (tr(I12)/2 - I12)) - M_torque_12_: moment balance about the mass centre,
  //   body axes [N m]
  const T t13_22 = R13_11 * u.tau_13_1 + R13_21 * u.tau_13_2 + R13_31 * u.tau_13_3;
  const T t13_23 = R13_12 * u.tau_13_1 + R13_22 * u.tau_13_2 + R13_32 * u.tau_13_3;
  const T t13_24 = R13_13 * u.tau_13_1 + R13_23 * u.tau_13_2 + R13_33 * u.tau_13_3;
  const T N12_1 = R12_11 * t13_22 + R12_12 * t13_23 + R12_13 * t13_24 + T(0.06599999999999999) * U12_32 -
      T(0.15400000000000003) * U12_23 + T(0.0088) * (minus_U12_22 - minus_U12_33) - T(0.011) * U12_31 + T(0.0066) *
      U12_21 - u.tau_12_1;
  const T N12_2 = R12_21 * t13_22 + R12_22 * t13_23 + R12_23 * t13_24 + T(0.15400000000000003) * U12_13 - T(0.11) *
      U12_31 - T(0.0066) * (minus_U12_33 - minus_U12_11) + T(0.0088) * U12_12 + T(0.011) * U12_32 - u.tau_12_2;
  const T N12_3 = R12_31 * t13_22 + R12_32 * t13_23 + R12_33 * t13_24 + T(0.11) * U12_21 - T(0.06599999999999999) *
      U12_12 - T(0.011) * (minus_U12_11 - minus_U12_22) - T(0.0066) * U12_23 - T(0.0088) * U12_13 - u.tau_12_3;
  // a13 = R13^T U13 r13 + Pddot13: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t13_25 = U13_12 * T(0.2) - minus_U13_11 * T(0.1) + U13_13 * T(0.05);
  const T t13_26 = U13_21 * T(0.1) - minus_U13_22 * T(0.2) + U13_23 * T(0.05);
  const T t13_27 = U13_31 * T(0.1) + U13_32 * T(0.2) - minus_U13_33 * T(0.05);
  const T a13_1 = R13_11 * t13_25 + R13_21 * t13_26 + R13_31 * t13_27 + Pddot13_1;
  const T a13_2 = R13_12 * t13_25 + R13_22 * t13_26 + R13_32 * t13_27 + Pddot13_2;
  const T a13_3 = R13_13 * t13_25 + R13_23 * t13_26 + R13_33 * t13_27 + Pddot13_3;
  // G13 = m13 a13: force balance, inertial axes [N]
  const T G13_1 = T(2.3) * a13_1;
  const T G13_2 = T(2.3) * a13_2;
  const T G13_3 = T(2.3) * a13_3;

  // ---- body 14 (body_14) on body 13
  const T eps14_1 = x[52], eps14_2 = x[53], eps14_3 = x[54], eps14_4 = x[55];
  const T omega14_1 = y[39], omega14_2 = y[40], omega14_3 = y[41];
  const T omegadot14_1 = ydot[39], omegadot14_2 = ydot[40], omegadot14_3 = ydot[41];
  // R14^T = 1 + 2 e14~ (eps4_14 + e14~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t14_1 = T(2) * eps14_2;
  const T t14_2 = t14_1 * eps14_2;
  const T t14_3 = T(2) * eps14_3;
  const T t14_4 = t14_3 * eps14_3;
  const T R14_11 = T(1) - t14_2 - t14_4;
  const T t14_5 = T(2) * eps14_1;
  const T t14_6 = t14_5 * eps14_2;
  const T t14_7 = t14_3 * eps14_4;
  const T R14_12 = t14_6 + t14_7;
  const T t14_8 = t14_5 * eps14_3;
  const T t14_9 = t14_1 * eps14_4;
  const T R14_13 = t14_8 - t14_9;
  const T R14_21 = t14_6 - t14_7;
  const T t14_10 = T(1) - t14_5 * eps14_1;
  const T R14_22 = t14_10 - t14_4;
  const T t14_11 = t14_1 * eps14_3;
  const T t14_12 = t14_5 * eps14_4;
  const T R14_23 = t14_11 + t14_12;
  const T R14_31 = t14_8 + t14_9;
  const T R14_32 = t14_11 - t14_12;
  const T R14_33 = t14_10 - t14_2;
  // U14 = omega14~ omega14~ + omegadot14~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t14_13 = omega14_3 * omega14_3;
  const T t14_14 = omega14_2 * omega14_2;
  const T minus_U14_11 = t14_13 + t14_14;
  const T t14_15 = omega14_2 * omega14_1;
  const T U14_12 = t14_15 - omegadot14_3;
  const T t14_16 = omega14_3 * omega14_1;
  const T U14_13 = t14_16 + omegadot14_2;
  const T U14_21 = t14_15 + omegadot14_3;
  const T t14_17 = omega14_1 * omega14_1;
  const T minus_U14_22 = t14_13 + t14_17;
  const T t14_18 = omega14_3 * omega14_2;
  const T U14_23 = t14_18 - omegadot14_1;
  const T U14_31 = t14_16 - omegadot14_2;
  const T U14_32 = t14_18 + omegadot14_1;
  const T minus_U14_33 = t14_14 + t14_17;
  // Pddot14 = R13^T U13 q14 + Pddot13: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t14_19 = U13_12 * T(0.7) - minus_U13_11 * T(0.3) + U13_13 * T(0.1);
  const T t14_20 = U13_21 * T(0.3) - minus_U13_22 * T(0.7) + U13_23 * T(0.1);
  const T t14_21 = U13_31 * T(0.3) + U13_32 * T(0.7) - minus_U13_33 * T(0.1);
  const T Pddot14_1 = R13_11 * t14_19 + R13_21 * t14_20 + R13_31 * t14_21 + Pddot13_1;
  const T Pddot14_2 = R13_12 * t14_19 + R13_22 * t14_20 + R13_32 * t14_21 + Pddot13_2;
  const T Pddot14_3 = R13_13 * t14_19 + R13_23 * t14_20 + R13_33 * t14_21 + Pddot13_3;
  // N13 = R13 R14^T M_torque_14_ + axial(U13 (tr(I13)/2 - I13)) - M_torque_13_: moment balance about the mass centre,
  //   body axes [N m]
  const T t14_22 = R14_11 * u.tau_14_1 + R14_21 * u.tau_14_2 + R14_31 * u.tau_14_3;
  const T t14_23 = R14_12 * u.tau_14_1 + R14_22 * u.tau_14_2 + R14_32 * u.tau_14_3;
  const T t14_24 = R14_13 * u.tau_14_1 + R14_23 * u.tau_14_2 + R14_33 * u.tau_14_3;
  const T N13_1 = R13_11 * t14_22 + R13_12 * t14_23 + R13_13 * t14_24 + T(0.06899999999999999) * U13_32 -
      T(0.16100000000000003) * U13_23 + T(0.0092) * (minus_U13_22 - minus_U13_33) - T(0.0115) * U13_31 + T(0.0069) *
      U13_21 - u.tau_13_1;
  const T N13_2 = R13_21 * t14_22 + R13_22 * t14_23 + R13_23 * t14_24 + T(0.16100000000000003) * U13_13 - T(0.115) *
      U13_31 - T(0.0069) * (minus_U13_33 - minus_U13_11) + T(0.0092) * U13_12 + T(0.0115) * U13_32 - u.tau_13_2;
  const T N13_3 = R13_31 * t14_22 + R13_32 * t14_23 + R13_33 * t14_24 + T(0.115) * U13_21 - T(0.06899999999999999) *
      U13_12 - T(0.0115) * (minus_U13_11 - minus_U13_22) - T(0.0069) * U13_23 - T(0.0092) * U13_13 - u.tau_13_3;
  // a14 = R14^T U14 r14 + Pddot14: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t14_25 = U14_12 * T(0.2) - minus_U14_11 * T(0.1) + U14_13 * T(0.05);
  const T t14_26 = U14_21 * T(0.1) - minus_U14_22 * T(0.2) + U14_23 * T(0.05);
  const T t14_27 = U14_31 * T(0.1) + U14_32 * T(0.2) - minus_U14_33 * T(0.05);
  const T a14_1 = R14_11 * t14_25 + R14_21 * t14_26 + R14_31 * t14_27 + Pddot14_1;
  const T a14_2 = R14_12 * t14_25 + R14_22 * t14_26 + R14_32 * t14_27 + Pddot14_2;
  const T a14_3 = R14_13 * t14_25 + R14_23 * t14_26 + R14_33 * t14_27 + Pddot14_3;
  // G14 = m14 a14: force balance, inertial axes [N]
  const T G14_1 = T(2.4) * a14_1;
  const T G14_2 = T(2.4) * a14_2;
  const T G14_3 = T(2.4) * a14_3;

  // ---- body 15 (body_15) on body 14
  const T eps15_1 = x[56], eps15_2 = x[57], eps15_3 = x[58], eps15_4 = x[59];
  const T omega15_1 = y[42], omega15_2 = y[43], omega15_3 = y[44];
  const T omegadot15_1 = ydot[42], omegadot15_2 = ydot[43], omegadot15_3 = ydot[44];
  // R15^T = 1 + 2 e15~ (eps4_15 + e15~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t15_1 = T(2) * eps15_2;
  const T t15_2 = t15_1 * eps15_2;
  const T t15_3 = T(2) * eps15_3;
  const T t15_4 = t15_3 * eps15_3;
  const T R15_11 = T(1) - t15_2 - t15_4;
  const T t15_5 = T(2) * eps15_1;
  const T t15_6 = t15_5 * eps15_2;
  const T t15_7 = t15_3 * eps15_4;
  const T R15_12 = t15_6 + t15_7;
  const T t15_8 = t15_5 * eps15_3;
  const T t15_9 = t15_1 * eps15_4;
  const T R15_13 = t15_8 - t15_9;
  const T R15_21 = t15_6 - t15_7;
  const T t15_10 = T(1) - t15_5 * eps15_1;
  const T R15_22 = t15_10 - t15_4;
  const T t15_11 = t15_1 * eps15_3;
  const T t15_12 = t15_5 * eps15_4;
  const T R15_23 = t15_11 + t15_12;
  const T R15_31 = t15_8 + t15_9;
  const T R15_32 = t15_11 - t15_12;
  const T R15_33 = t15_10 - t15_2;
  // U15 = omega15~ omega15~ + omegadot15~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t15_13 = omega15_3 * omega15_3;
  const T t15_14 = omega15_2 * omega15_2;
  const T minus_U15_11 = t15_13 + t15_14;
  const T t15_15 = omega15_2 * omega15_1;
  const T U15_12 = t15_15 - omegadot15_3;
  const T t15_16 = omega15_3 * omega15_1;
  const T U15_13 = t15_16 + omegadot15_2;
  const T U15_21 = t15_15 + omegadot15_3;
  const T t15_17 = omega15_1 * omega15_1;
  const T minus_U15_22 = t15_13 + t15_17;
  const T t15_18 = omega15_3 * omega15_2;
  const T U15_23 = t15_18 - omegadot15_1;
  const T U15_31 = t15_16 - omegadot15_2;
  const T U15_32 = t15_18 + omegadot15_1;
  const T minus_U15_33 = t15_14 + t15_17;
  // Pddot15 = R14^T U14 q15 + Pddot14: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t15_19 = U14_12 * T(0.75) - minus_U14_11 * T(0.3) + U14_13 * T(0.1);
  const T t15_20 = U14_21 * T(0.3) - minus_U14_22 * T(0.75) + U14_23 * T(0.1);
  const T t15_21 = U14_31 * T(0.3) + U14_32 * T(0.75) - minus_U14_33 * T(0.1);
  const T Pddot15_1 = R14_11 * t15_19 + R14_21 * t15_20 + R14_31 * t15_21 + Pddot14_1;
  const T Pddot15_2 = R14_12 * t15_19 + R14_22 * t15_20 + R14_32 * t15_21 + Pddot14_2;
  const T Pddot15_3 = R14_13 * t15_19 + R14_23 * t15_20 + R14_33 * t15_21 + Pddot14_3;
  // N14 = R14 R15^T M_torque_15_ + axial(U14 (tr(I14)/2 - I14)) - M_torque_14_: moment balance about the mass centre,
  //   body axes [N m]
  const T t15_22 = R15_11 * u.tau_15_1 + R15_21 * u.tau_15_2 + R15_31 * u.tau_15_3;
  const T t15_23 = R15_12 * u.tau_15_1 + R15_22 * u.tau_15_2 + R15_32 * u.tau_15_3;
  const T t15_24 = R15_13 * u.tau_15_1 + R15_23 * u.tau_15_2 + R15_33 * u.tau_15_3;
  const T N14_1 = R14_11 * t15_22 + R14_12 * t15_23 + R14_13 * t15_24 + T(0.07200000000000001) * U14_32 -
      T(0.16799999999999998) * U14_23 + T(0.0096) * (minus_U14_22 - minus_U14_33) - T(0.012) * U14_31 + T(0.0072) *
      U14_21 - u.tau_14_1;
  const T N14_2 = R14_21 * t15_22 + R14_22 * t15_23 + R14_23 * t15_24 + T(0.16799999999999998) * U14_13 - T(0.12) *
      U14_31 - T(0.0072) * (minus_U14_33 - minus_U14_11) + T(0.0096) * U14_12 + T(0.012) * U14_32 - u.tau_14_2;
  const T N14_3 = R14_31 * t15_22 + R14_32 * t15_23 + R14_33 * t15_24 + T(0.12) * U14_21 - T(0.07200000000000001) *
      U14_12 - T(0.012) * (minus_U14_11 - minus_U14_22) - T(0.0072) * U14_23 - T(0.0096) * U14_13 - u.tau_14_3;
  // a15 = R15^T U15 r15 + Pddot15: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t15_25 = U15_12 * T(0.2) - minus_U15_11 * T(0.1) + U15_13 * T(0.05);
  const T t15_26 = U15_21 * T(0.1) - minus_U15_22 * T(0.2) + U15_23 * T(0.05);
  const T t15_27 = U15_31 * T(0.1) + U15_32 * T(0.2) - minus_U15_33 * T(0.05);
  const T a15_1 = R15_11 * t15_25 + R15_21 * t15_26 + R15_31 * t15_27 + Pddot15_1;
  const T a15_2 = R15_12 * t15_25 + R15_22 * t15_26 + R15_32 * t15_27 + Pddot15_2;
  const T a15_3 = R15_13 * t15_25 + R15_23 * t15_26 + R15_33 * t15_27 + Pddot15_3;
  // G15 = m15 a15: force balance, inertial axes [N]
  const T G15_1 = T(2.5) * a15_1;
  const T G15_2 = T(2.5) * a15_2;
  const T G15_3 = T(2.5) * a15_3;

  // ---- body 16 (body_16) on body 15
  const T eps16_1 = x[60], eps16_2 = x[61], eps16_3 = x[62], eps16_4 = x[63];
  const T omega16_1 = y[45], omega16_2 = y[46], omega16_3 = y[47];
  const T omegadot16_1 = ydot[45], omegadot16_2 = ydot[46], omegadot16_3 = ydot[47];
  // R16^T = 1 + 2 e16~ (eps4_16 + e16~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t16_1 = T(2) * eps16_2;
  const T t16_2 = t16_1 * eps16_2;
  const T t16_3 = T(2) * eps16_3;
  const T t16_4 = t16_3 * eps16_3;
  const T R16_11 = T(1) - t16_2 - t16_4;
  const T t16_5 = T(2) * eps16_1;
  const T t16_6 = t16_5 * eps16_2;
  const T t16_7 = t16_3 * eps16_4;
  const T R16_12 = t16_6 + t16_7;
  const T t16_8 = t16_5 * eps16_3;
  const T t16_9 = t16_1 * eps16_4;
  const T R16_13 = t16_8 - t16_9;
  const T R16_21 = t16_6 - t16_7;
  const T t16_10 = T(1) - t16_5 * eps16_1;
  const T R16_22 = t16_10 - t16_4;
  const T t16_11 = t16_1 * eps16_3;
  const T t16_12 = t16_5 * eps16_4;
  const T R16_23 = t16_11 + t16_12;
  const T R16_31 = t16_8 + t16_9;
  const T R16_32 = t16_11 - t16_12;
  const T R16_33 = t16_10 - t16_2;
  // U16 = omega16~ omega16~ + omegadot16~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t16_13 = omega16_3 * omega16_3;
  const T t16_14 = omega16_2 * omega16_2;
  const T minus_U16_11 = t16_13 + t16_14;
  const T t16_15 = omega16_2 * omega16_1;
  const T U16_12 = t16_15 - omegadot16_3;
  const T t16_16 = omega16_3 * omega16_1;
  const T U16_13 = t16_16 + omegadot16_2;
  const T U16_21 = t16_15 + omegadot16_3;
  const T t16_17 = omega16_1 * omega16_1;
  const T minus_U16_22 = t16_13 + t16_17;
  const T t16_18 = omega16_3 * omega16_2;
  const T U16_23 = t16_18 - omegadot16_1;
  const T U16_31 = t16_16 - omegadot16_2;
  const T U16_32 = t16_18 + omegadot16_1;
  const T minus_U16_33 = t16_14 + t16_17;
  // Pddot16 = R15^T U15 q16 + Pddot15: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t16_19 = U15_12 * T(0.8) - minus_U15_11 * T(0.3) + U15_13 * T(0.1);
  const T t16_20 = U15_21 * T(0.3) - minus_U15_22 * T(0.8) + U15_23 * T(0.1);
  const T t16_21 = U15_31 * T(0.3) + U15_32 * T(0.8) - minus_U15_33 * T(0.1);
  const T Pddot16_1 = R15_11 * t16_19 + R15_21 * t16_20 + R15_31 * t16_21 + Pddot15_1;
  const T Pddot16_2 = R15_12 * t16_19 + R15_22 * t16_20 + R15_32 * t16_21 + Pddot15_2;
  const T Pddot16_3 = R15_13 * t16_19 + R15_23 * t16_20 + R15_33 * t16_21 + Pddot15_3;
  // N15 = R15 R16^T M_torque_16_ + axial(U15 (tr(I15)/2 - I15)) - M_torque_15_: moment balance about the mass centre,
  //   body axes [N m]
  const T t16_22 = R16_11 * u.tau_16_1 + R16_21 * u.tau_16_2 + R16_31 * u.tau_16_3;
  const T t16_23 = R16_12 * u.tau_16_1 + R16_22 * u.tau_16_2 + R16_32 * u.tau_16_3;
  const T t16_24 = R16_13 * u.tau_16_1 + R16_23 * u.tau_16_2 + R16_33 * u.tau_16_3;
  const T N15_1 = R15_11 * t16_22 + R15_12 * t16_23 + R15_13 * t16_24 + T(0.07500000000000001) * U15_32 - T(0.175) *
      U15_23 + T(0.01) * (minus_U15_22 - minus_U15_33) - T(0.0125) * U15_31 + T(0.0075) * U15_21 - u.tau_15_1;
  const T N15_2 = R15_21 * t16_22 + R15_22 * t16_23 + R15_23 * t16_24 + T(0.175) * U15_13 - T(0.125) * U15_31 -
      T(0.0075) * (minus_U15_33 - minus_U15_11) + T(0.01) * U15_12 + T(0.0125) * U15_32 - u.tau_15_2;
  const T N15_3 = R15_31 * t16_22 + R15_32 * t16_23 + R15_33 * t16_24 + T(0.125) * U15_21 - T(0.07500000000000001) *
      U15_12 - T(0.0125) * (minus_U15_11 - minus_U15_22) - T(0.0075) * U15_23 - T(0.01) * U15_13 - u.tau_15_3;
  // a16 = R16^T U16 r16 + Pddot16: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t16_25 = U16_12 * T(0.2) - minus_U16_11 * T(0.1) + U16_13 * T(0.05);
  const T t16_26 = U16_21 * T(0.1) - minus_U16_22 * T(0.2) + U16_23 * T(0.05);
  const T t16_27 = U16_31 * T(0.1) + U16_32 * T(0.2) - minus_U16_33 * T(0.05);
  const T a16_1 = R16_11 * t16_25 + R16_21 * t16_26 + R16_31 * t16_27 + Pddot16_1;
  const T a16_2 = R16_12 * t16_25 + R16_22 * t16_26 + R16_32 * t16_27 + Pddot16_2;
  const T a16_3 = R16_13 * t16_25 + R16_23 * t16_26 + R16_33 * t16_27 + Pddot16_3;
  // G16 = m16 a16: force balance, inertial axes [N]
  const T G16_1 = T(2.6) * a16_1;
  const T G16_2 = T(2.6) * a16_2;
  const T G16_3 = T(2.6) * a16_3;

  // ---- body 17 (body_17) on body 16
  const T eps17_1 = x[64], eps17_2 = x[65], eps17_3 = x[66], eps17_4 = x[67];
  const T omega17_1 = y[48], omega17_2 = y[49], omega17_3 = y[50];
  const T omegadot17_1 = ydot[48], omegadot17_2 = ydot[49], omegadot17_3 = ydot[50];
  // R17^T = 1 + 2 e17~ (eps4_17 + e17~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t17_1 = T(2) * eps17_2;
  const T t17_2 = t17_1 * eps17_2;
  const T t17_3 = T(2) * eps17_3;
  const T t17_4 = t17_3 * eps17_3;
  const T R17_11 = T(1) - t17_2 - t17_4;
  const T t17_5 = T(2) * eps17_1;
  const T t17_6 = t17_5 * eps17_2;
  const T t17_7 = t17_3 * eps17_4;
  const T R17_12 = t17_6 + t17_7;
  const T t17_8 = t17_5 * eps17_3;
  const T t17_9 = t17_1 * eps17_4;
  const T R17_13 = t17_8 - t17_9;
  const T R17_21 = t17_6 - t17_7;
  const T t17_10 = T(1) - t17_5 * eps17_1;
  const T R17_22 = t17_10 - t17_4;
  const T t17_11 = t17_1 * eps17_3;
  const T t17_12 = t17_5 * eps17_4;
  const T R17_23 = t17_11 + t17_12;
  const T R17_31 = t17_8 + t17_9;
  const T R17_32 = t17_11 - t17_12;
  const T R17_33 = t17_10 - t17_2;
  // U17 = omega17~ omega17~ + omegadot17~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t17_13 = omega17_3 * omega17_3;
  const T t17_14 = omega17_2 * omega17_2;
  const T minus_U17_11 = t17_13 + t17_14;
  const T t17_15 = omega17_2 * omega17_1;
  const T U17_12 = t17_15 - omegadot17_3;
  const T t17_16 = omega17_3 * omega17_1;
  const T U17_13 = t17_16 + omegadot17_2;
  const T U17_21 = t17_15 + omegadot17_3;
  const T t17_17 = omega17_1 * omega17_1;
  const T minus_U17_22 = t17_13 + t17_17;
  const T t17_18 = omega17_3 * omega17_2;
  const T U17_23 = t17_18 - omegadot17_1;
  const T U17_31 = t17_16 - omegadot17_2;
  const T U17_32 = t17_18 + omegadot17_1;
  const T minus_U17_33 = t17_14 + t17_17;
  // Pddot17 = R16^T U16 q17 + Pddot16: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t17_19 = U16_12 * T(0.85) - minus_U16_11 * T(0.3) + U16_13 * T(0.1);
  const T t17_20 = U16_21 * T(0.3) - minus_U16_22 * T(0.85) + U16_23 * T(0.1);
  const T t17_21 = U16_31 * T(0.3) + U16_32 * T(0.85) - minus_U16_33 * T(0.1);
  const T Pddot17_1 = R16_11 * t17_19 + R16_21 * t17_20 + R16_31 * t17_21 + Pddot16_1;
  const T Pddot17_2 = R16_12 * t17_19 + R16_22 * t17_20 + R16_32 * t17_21 + Pddot16_2;
  const T Pddot17_3 = R16_13 * t17_19 + R16_23 * t17_20 + R16_33 * t17_21 + Pddot16_3;
  // N16 = R16 R17^T M_torque_17_ + axial(U16 (tr(I16)/2 - I16)) - M_torque_16_: moment balance about the mass centre,
  //   body axes [N m]
  const T t17_22 = R17_11 * u.tau_17_1 + R17_21 * u.tau_17_2 + R17_31 * u.tau_17_3;
  const T t17_23 = R17_12 * u.tau_17_1 + R17_22 * u.tau_17_2 + R17_32 * u.tau_17_3;
  const T t17_24 = R17_13 * u.tau_17_1 + R17_23 * u.tau_17_2 + R17_33 * u.tau_17_3;
  const T N16_1 = R16_11 * t17_22 + R16_12 * t17_23 + R16_13 * t17_24 + T(0.078) * U16_32 - T(0.182) * U16_23 +
      T(0.0104) * (minus_U16_22 - minus_U16_33) - T(0.013) * U16_31 + T(0.0078) * U16_21 - u.tau_16_1;
  const T N16_2 = R16_21 * t17_22 + R16_22 * t17_23 + R16_23 * t17_24 + T(0.182) * U16_13 - T(0.13) * U16_31 -
      T(0.0078) * (minus_U16_33 - minus_U16_11) + T(0.0104) * U16_12 + T(0.013) * U16_32 - u.tau_16_2;
  const T N16_3 = R16_31 * t17_22 + R16_32 * t17_23 + R16_33 * t17_24 + T(0.13) * U16_21 - T(0.078) * U16_12 -
      T(0.013) * (minus_U16_11 - minus_U16_22) - T(0.0078) * U16_23 - T(0.0104) * U16_13 - u.tau_16_3;
  // a17 = R17^T U17 r17 + Pddot17: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t17_25 = U17_12 * T(0.2) - minus_U17_11 * T(0.1) + U17_13 * T(0.05);
  const T t17_26 = U17_21 * T(0.1) - minus_U17_22 * T(0.2) + U17_23 * T(0.05);
  const T t17_27 = U17_31 * T(0.1) + U17_32 * T(0.2) - minus_U17_33 * T(0.05);
  const T a17_1 = R17_11 * t17_25 + R17_21 * t17_26 + R17_31 * t17_27 + Pddot17_1;
  const T a17_2 = R17_12 * t17_25 + R17_22 * t17_26 + R17_32 * t17_27 + Pddot17_2;
  const T a17_3 = R17_13 * t17_25 + R17_23 * t17_26 + R17_33 * t17_27 + Pddot17_3;
  // G17 = m17 a17: force balance, inertial axes [N]
  const T G17_1 = T(2.7) * a17_1;
  const T G17_2 = T(2.7) * a17_2;
  const T G17_3 = T(2.7) * a17_3;

  // ---- body 18 (body_18) on body 17
  const T eps18_1 = x[68], eps18_2 = x[69], eps18_3 = x[70], eps18_4 = x[71];
  const T omega18_1 = y[51], omega18_2 = y[52], omega18_3 = y[53];
  const T omegadot18_1 = ydot[51], omegadot18_2 = ydot[52], omegadot18_3 = ydot[53];
  // R18^T = 1 + 2 e18~ (eps4_18 + e18~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t18_1 = T(2) * eps18_2;
  const T t18_2 = t18_1 * eps18_2;
  const T t18_3 = T(2) * eps18_3;
  const T t18_4 = t18_3 * eps18_3;
  const T R18_11 = T(1) - t18_2 - t18_4;
  const T t18_5 = T(2) * eps18_1;
  const T t18_6 = t18_5 * eps18_2;
  const T t18_7 = t18_3 * eps18_4;
  const T R18_12 = t18_6 + t18_7;
  const T t18_8 = t18_5 * eps18_3;
  const T t18_9 = t18_1 * eps18_4;
  const T R18_13 = t18_8 - t18_9;
  const T R18_21 = t18_6 - t18_7;
  const T t18_10 = T(1) - t18_5 * eps18_1;
  const T R18_22 = t18_10 - t18_4;
  const T t18_11 = t18_1 * eps18_3;
  const T t18_12 = t18_5 * eps18_4;
  const T R18_23 = t18_11 + t18_12;
  const T R18_31 = t18_8 + t18_9;
  const T R18_32 = t18_11 - t18_12;
  const T R18_33 = t18_10 - t18_2;
  // U18 = omega18~ omega18~ + omegadot18~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t18_13 = omega18_3 * omega18_3;
  const T t18_14 = omega18_2 * omega18_2;
  const T minus_U18_11 = t18_13 + t18_14;
  const T t18_15 = omega18_2 * omega18_1;
  const T U18_12 = t18_15 - omegadot18_3;
  const T t18_16 = omega18_3 * omega18_1;
  const T U18_13 = t18_16 + omegadot18_2;
  const T U18_21 = t18_15 + omegadot18_3;
  const T t18_17 = omega18_1 * omega18_1;
  const T minus_U18_22 = t18_13 + t18_17;
  const T t18_18 = omega18_3 * omega18_2;
  const T U18_23 = t18_18 - omegadot18_1;
  const T U18_31 = t18_16 - omegadot18_2;
  const T U18_32 = t18_18 + omegadot18_1;
  const T minus_U18_33 = t18_14 + t18_17;
  // Pddot18 = R17^T U17 q18 + Pddot17: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t18_19 = U17_12 * T(0.9) - minus_U17_11 * T(0.3) + U17_13 * T(0.1);
  const T t18_20 = U17_21 * T(0.3) - minus_U17_22 * T(0.9) + U17_23 * T(0.1);
  const T t18_21 = U17_31 * T(0.3) + U17_32 * T(0.9) - minus_U17_33 * T(0.1);
  const T Pddot18_1 = R17_11 * t18_19 + R17_21 * t18_20 + R17_31 * t18_21 + Pddot17_1;
  const T Pddot18_2 = R17_12 * t18_19 + R17_22 * t18_20 + R17_32 * t18_21 + Pddot17_2;
  const T Pddot18_3 = R17_13 * t18_19 + R17_23 * t18_20 + R17_33 * t18_21 + Pddot17_3;
  // N17 = R17 R18^T M_torque_18_ + axial(U17 (tr(I17)/2 - I17)) - M_torque_17_: moment balance about the mass centre,
  //   body axes [N m]
  const T t18_22 = R18_11 * u.tau_18_1 + R18_21 * u.tau_18_2 + R18_31 * u.tau_18_3;
  const T t18_23 = R18_12 * u.tau_18_1 + R18_22 * u.tau_18_2 + R18_32 * u.tau_18_3;
  const T t18_24 = R18_13 * u.tau_18_1 + R18_23 * u.tau_18_2 + R18_33 * u.tau_18_3;
  const T N17_1 = R17_11 * t18_22 + R17_12 * t18_23 + R17_13 * t18_24 + T(0.081) * U17_32 - T(0.189) * U17_23 +
      T(0.0108) * (minus_U17_22 - minus_U17_33) - T(0.0135) * U17_31 + T(0.0081) * U17_21 - u.tau_17_1;
  const T N17_2 = R17_21 * t18_22 + R17_22 * t18_23 + R17_23 * t18_24 + T(0.189) * U17_13 - T(0.135) * U17_31 -
      T(0.0081) * (minus_U17_33 - minus_U17_11) + T(0.0108) * U17_12 + T(0.0135) * U17_32 - u.tau_17_2;
  const T N17_3 = R17_31 * t18_22 + R17_32 * t18_23 + R17_33 * t18_24 + T(0.135) * U17_21 - T(0.081) * U17_12 -
      T(0.0135) * (minus_U17_11 - minus_U17_22) - T(0.0081) * U17_23 - T(0.0108) * U17_13 - u.tau_17_3;
  // a18 = R18^T U18 r18 + Pddot18: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t18_25 = U18_12 * T(0.2) - minus_U18_11 * T(0.1) + U18_13 * T(0.05);
  const T t18_26 = U18_21 * T(0.1) - minus_U18_22 * T(0.2) + U18_23 * T(0.05);
  const T t18_27 = U18_31 * T(0.1) + U18_32 * T(0.2) - minus_U18_33 * T(0.05);
  const T a18_1 = R18_11 * t18_25 + R18_21 * t18_26 + R18_31 * t18_27 + Pddot18_1;
  const T a18_2 = R18_12 * t18_25 + R18_22 * t18_26 + R18_32 * t18_27 + Pddot18_2;
  const T a18_3 = R18_13 * t18_25 + R18_23 * t18_26 + R18_33 * t18_27 + Pddot18_3;
  // G18 = m18 a18: force balance, inertial axes [N]
  const T G18_1 = T(2.8) * a18_1;
  const T G18_2 = T(2.8) * a18_2;
  const T G18_3 = T(2.8) * a18_3;

  // ---- body 19 (body_19) on body 18
  const T eps19_1 = x[72], eps19_2 = x[73], eps19_3 = x[74], eps19_4 = x[75];
  const T omega19_1 = y[54], omega19_2 = y[55], omega19_3 = y[56];
  const T omegadot19_1 = ydot[54], omegadot19_2 = ydot[55], omegadot19_3 = ydot[56];
  // R19^T = 1 + 2 e19~ (eps4_19 + e19~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t19_1 = T(2) * eps19_2;
  const T t19_2 = t19_1 * eps19_2;
  const T t19_3 = T(2) * eps19_3;
  const T t19_4 = t19_3 * eps19_3;
  const T R19_11 = T(1) - t19_2 - t19_4;
  const T t19_5 = T(2) * eps19_1;
  const T t19_6 = t19_5 * eps19_2;
  const T t19_7 = t19_3 * eps19_4;
  const T R19_12 = t19_6 + t19_7;
  const T t19_8 = t19_5 * eps19_3;
  const T t19_9 = t19_1 * eps19_4;
  const T R19_13 = t19_8 - t19_9;
  const T R19_21 = t19_6 - t19_7;
  const T t19_10 = T(1) - t19_5 * eps19_1;
  const T R19_22 = t19_10 - t19_4;
  const T t19_11 = t19_1 * eps19_3;
  const T t19_12 = t19_5 * eps19_4;
  const T R19_23 = t19_11 + t19_12;
  const T R19_31 = t19_8 + t19_9;
  const T R19_32 = t19_11 - t19_12;
  const T R19_33 = t19_10 - t19_2;
  // U19 = omega19~ omega19~ + omegadot19~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t19_13 = omega19_3 * omega19_3;
  const T t19_14 = omega19_2 * omega19_2;
  const T minus_U19_11 = t19_13 + t19_14;
  const T t19_15 = omega19_2 * omega19_1;
  const T U19_12 = t19_15 - omegadot19_3;
  const T t19_16 = omega19_3 * omega19_1;
  const T U19_13 = t19_16 + omegadot19_2;
  const T U19_21 = t19_15 + omegadot19_3;
  const T t19_17 = omega19_1 * omega19_1;
  const T minus_U19_22 = t19_13 + t19_17;
  const T t19_18 = omega19_3 * omega19_2;
  const T U19_23 = t19_18 - omegadot19_1;
  const T U19_31 = t19_16 - omegadot19_2;
  const T U19_32 = t19_18 + omegadot19_1;
  const T minus_U19_33 = t19_14 + t19_17;
  // Pddot19 = R18^T U18 q19 + Pddot18: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t19_19 = U18_12 * T(0.95) - minus_U18_11 * T(0.3) + U18_13 * T(0.1);
  const T t19_20 = U18_21 * T(0.3) - minus_U18_22 * T(0.95) + U18_23 * T(0.1);
  const T t19_21 = U18_31 * T(0.3) + U18_32 * T(0.95) - minus_U18_33 * T(0.1);
  const T Pddot19_1 = R18_11 * t19_19 + R18_21 * t19_20 + R18_31 * t19_21 + Pddot18_1;
  const T Pddot19_2 = R18_12 * t19_19 + R18_22 * t19_20 + R18_32 * t19_21 + Pddot18_2;
  const T Pddot19_3 = R18_13 * t19_19 + R18_23 * t19_20 + R18_33 * t19_21 + Pddot18_3;
  // N18 = R18 R19^T M_torque_19_ + axial(U18 (tr(I18)/2 - I18)) - M_torque_18_: moment balance about the mass centre,
  //   body axes [N m]
  const T t19_22 = R19_11 * u.tau_19_1 + R19_21 * u.tau_19_2 + R19_31 * u.tau_19_3;
  const T t19_23 = R19_12 * u.tau_19_1 + R19_22 * u.tau_19_2 + R19_32 * u.tau_19_3;
  const T t19_24 = R19_13 * u.tau_19_1 + R19_23 * u.tau_19_2 + R19_33 * u.tau_19_3;
  const T N18_1 = R18_11 * t19_22 + R18_12 * t19_23 + R18_13 * t19_24 + T(0.084) * U18_32 - T(0.196) * U18_23 +
      T(0.0112) * (minus_U18_22 - minus_U18_33) - T(0.014) * U18_31 + T(0.0084) * U18_21 - u.tau_18_1;
  const T N18_2 = R18_21 * t19_22 + R18_22 * t19_23 + R18_23 * t19_24 + T(0.196) * U18_13 - T(0.14) * U18_31 -
      T(0.0084) * (minus_U18_33 - minus_U18_11) + T(0.0112) * U18_12 + T(0.014) * U18_32 - u.tau_18_2;
  const T N18_3 = R18_31 * t19_22 + R18_32 * t19_23 + R18_33 * t19_24 + T(0.14) * U18_21 - T(0.084) * U18_12 -
      T(0.014) * (minus_U18_11 - minus_U18_22) - T(0.0084) * U18_23 - T(0.0112) * U18_13 - u.tau_18_3;
  // a19 = R19^T U19 r19 + Pddot19: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t19_25 = U19_12 * T(0.2) - minus_U19_11 * T(0.1) + U19_13 * T(0.05);
  const T t19_26 = U19_21 * T(0.1) - minus_U19_22 * T(0.2) + U19_23 * T(0.05);
  const T t19_27 = U19_31 * T(0.1) + U19_32 * T(0.2) - minus_U19_33 * T(0.05);
  const T a19_1 = R19_11 * t19_25 + R19_21 * t19_26 + R19_31 * t19_27 + Pddot19_1;
  const T a19_2 = R19_12 * t19_25 + R19_22 * t19_26 + R19_32 * t19_27 + Pddot19_2;
  const T a19_3 = R19_13 * t19_25 + R19_23 * t19_26 + R19_33 * t19_27 + Pddot19_3;
  // G19 = m19 a19: force balance, inertial axes [N]
  const T G19_1 = T(2.9) * a19_1;
  const T G19_2 = T(2.9) * a19_2;
  const T G19_3 = T(2.9) * a19_3;

  // ---- body 20 (body_20) on body 19
  const T eps20_1 = x[76], eps20_2 = x[77], eps20_3 = x[78], eps20_4 = x[79];
  const T omega20_1 = y[57], omega20_2 = y[58], omega20_3 = y[59];
  const T omegadot20_1 = ydot[57], omegadot20_2 = ydot[58], omegadot20_3 = ydot[59];
  // R20^T = 1 + 2 e20~ (eps4_20 + e20~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t20_1 = T(2) * eps20_2;
  const T t20_2 = t20_1 * eps20_2;
  const T t20_3 = T(2) * eps20_3;
  const T t20_4 = t20_3 * eps20_3;
  const T R20_11 = T(1) - t20_2 - t20_4;
  const T t20_5 = T(2) * eps20_1;
  const T t20_6 = t20_5 * eps20_2;
  const T t20_7 = t20_3 * eps20_4;
  const T R20_12 = t20_6 + t20_7;
  const T t20_8 = t20_5 * eps20_3;
  const T t20_9 = t20_1 * eps20_4;
  const T R20_13 = t20_8 - t20_9;
  const T R20_21 = t20_6 - t20_7;
  const T t20_10 = T(1) - t20_5 * eps20_1;
  const T R20_22 = t20_10 - t20_4;
  const T t20_11 = t20_1 * eps20_3;
  const T t20_12 = t20_5 * eps20_4;
  const T R20_23 = t20_11 + t20_12;
  const T R20_31 = t20_8 + t20_9;
  const T R20_32 = t20_11 - t20_12;
  const T R20_33 = t20_10 - t20_2;
  // U20 = omega20~ omega20~ + omegadot20~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t20_13 = omega20_3 * omega20_3;
  const T t20_14 = omega20_2 * omega20_2;
  const T minus_U20_11 = t20_13 + t20_14;
  const T t20_15 = omega20_2 * omega20_1;
  const T U20_12 = t20_15 - omegadot20_3;
  const T t20_16 = omega20_3 * omega20_1;
  const T U20_13 = t20_16 + omegadot20_2;
  const T U20_21 = t20_15 + omegadot20_3;
  const T t20_17 = omega20_1 * omega20_1;
  const T minus_U20_22 = t20_13 + t20_17;
  const T t20_18 = omega20_3 * omega20_2;
  const T U20_23 = t20_18 - omegadot20_1;
  const T U20_31 = t20_16 - omegadot20_2;
  const T U20_32 = t20_18 + omegadot20_1;
  const T minus_U20_33 = t20_14 + t20_17;
  // Pddot20 = R19^T U19 q20 + Pddot19: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t20_19 = U19_12 - minus_U19_11 * T(0.3) + U19_13 * T(0.1);
  const T t20_20 = U19_21 * T(0.3) - minus_U19_22 + U19_23 * T(0.1);
  const T t20_21 = U19_31 * T(0.3) + U19_32 - minus_U19_33 * T(0.1);
  const T Pddot20_1 = R19_11 * t20_19 + R19_21 * t20_20 + R19_31 * t20_21 + Pddot19_1;
  const T Pddot20_2 = R19_12 * t20_19 + R19_22 * t20_20 + R19_32 * t20_21 + Pddot19_2;
  const T Pddot20_3 = R19_13 * t20_19 + R19_23 * t20_20 + R19_33 * t20_21 + Pddot19_3;
  // N19 = R19 R20^T M_torque_20_ + axial(U19 (tr(I19)/2 - I19)) - M_torque_19_: moment balance about the mass centre,
  //   body axes [N m]
  const T t20_22 = R20_11 * u.tau_20_1 + R20_21 * u.tau_20_2 + R20_31 * u.tau_20_3;
  const T t20_23 = R20_12 * u.tau_20_1 + R20_22 * u.tau_20_2 + R20_32 * u.tau_20_3;
  const T t20_24 = R20_13 * u.tau_20_1 + R20_23 * u.tau_20_2 + R20_33 * u.tau_20_3;
  const T N19_1 = R19_11 * t20_22 + R19_12 * t20_23 + R19_13 * t20_24 + T(0.08700000000000001) * U19_32 -
      T(0.20299999999999996) * U19_23 + T(0.0116) * (minus_U19_22 - minus_U19_33) - T(0.0145) * U19_31 + T(0.0087) *
      U19_21 - u.tau_19_1;
  const T N19_2 = R19_21 * t20_22 + R19_22 * t20_23 + R19_23 * t20_24 + T(0.20299999999999996) * U19_13 -
      T(0.14500000000000002) * U19_31 - T(0.0087) * (minus_U19_33 - minus_U19_11) + T(0.0116) * U19_12 + T(0.0145) *
      U19_32 - u.tau_19_2;
  const T N19_3 = R19_31 * t20_22 + R19_32 * t20_23 + R19_33 * t20_24 + T(0.14500000000000002) * U19_21 -
      T(0.08700000000000001) * U19_12 - T(0.0145) * (minus_U19_11 - minus_U19_22) - T(0.0087) * U19_23 - T(0.0116) *
      U19_13 - u.tau_19_3;
  // a20 = R20^T U20 r20 + Pddot20: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t20_25 = U20_12 * T(0.2) - minus_U20_11 * T(0.1) + U20_13 * T(0.05);
  const T t20_26 = U20_21 * T(0.1) - minus_U20_22 * T(0.2) + U20_23 * T(0.05);
  const T t20_27 = U20_31 * T(0.1) + U20_32 * T(0.2) - minus_U20_33 * T(0.05);
  const T a20_1 = R20_11 * t20_25 + R20_21 * t20_26 + R20_31 * t20_27 + Pddot20_1;
  const T a20_2 = R20_12 * t20_25 + R20_22 * t20_26 + R20_32 * t20_27 + Pddot20_2;
  const T a20_3 = R20_13 * t20_25 + R20_23 * t20_26 + R20_33 * t20_27 + Pddot20_3;
  // G20 = m20 a20: force balance, inertial axes [N]
  const T G20_1 = T(3) * a20_1;
  const T G20_2 = T(3) * a20_2;
  const T G20_3 = T(3) * a20_3;

  // ---- body 21 (body_21) on body 20
  const T eps21_1 = x[80], eps21_2 = x[81], eps21_3 = x[82], eps21_4 = x[83];
  const T omega21_1 = y[60], omega21_2 = y[61], omega21_3 = y[62];
  const T omegadot21_1 = ydot[60], omegadot21_2 = ydot[61], omegadot21_3 = ydot[62];
  // R21^T = 1 + 2 e21~ (eps4_21 + e21~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t21_1 = T(2) * eps21_2;
  const T t21_2 = t21_1 * eps21_2;
  const T t21_3 = T(2) * eps21_3;
  const T t21_4 = t21_3 * eps21_3;
  const T R21_11 = T(1) - t21_2 - t21_4;
  const T t21_5 = T(2) * eps21_1;
  const T t21_6 = t21_5 * eps21_2;
  const T t21_7 = t21_3 * eps21_4;
  const T R21_12 = t21_6 + t21_7;
  const T t21_8 = t21_5 * eps21_3;
  const T t21_9 = t21_1 * eps21_4;
  const T R21_13 = t21_8 - t21_9;
  const T R21_21 = t21_6 - t21_7;
  const T t21_10 = T(1) - t21_5 * eps21_1;
  const T R21_22 = t21_10 - t21_4;
  const T t21_11 = t21_1 * eps21_3;
  const T t21_12 = t21_5 * eps21_4;
  const T R21_23 = t21_11 + t21_12;
  const T R21_31 = t21_8 + t21_9;
  const T R21_32 = t21_11 - t21_12;
  const T R21_33 = t21_10 - t21_2;
  // U21 = omega21~ omega21~ + omegadot21~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t21_13 = omega21_3 * omega21_3;
  const T t21_14 = omega21_2 * omega21_2;
  const T minus_U21_11 = t21_13 + t21_14;
  const T t21_15 = omega21_2 * omega21_1;
  const T U21_12 = t21_15 - omegadot21_3;
  const T t21_16 = omega21_3 * omega21_1;
  const T U21_13 = t21_16 + omegadot21_2;
  const T U21_21 = t21_15 + omegadot21_3;
  const T t21_17 = omega21_1 * omega21_1;
  const T minus_U21_22 = t21_13 + t21_17;
  const T t21_18 = omega21_3 * omega21_2;
  const T U21_23 = t21_18 - omegadot21_1;
  const T U21_31 = t21_16 - omegadot21_2;
  const T U21_32 = t21_18 + omegadot21_1;
  const T minus_U21_33 = t21_14 + t21_17;
  // Pddot21 = R20^T U20 q21 + Pddot20: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t21_19 = U20_12 * T(1.05) - minus_U20_11 * T(0.3) + U20_13 * T(0.1);
  const T t21_20 = U20_21 * T(0.3) - minus_U20_22 * T(1.05) + U20_23 * T(0.1);
  const T t21_21 = U20_31 * T(0.3) + U20_32 * T(1.05) - minus_U20_33 * T(0.1);
  const T Pddot21_1 = R20_11 * t21_19 + R20_21 * t21_20 + R20_31 * t21_21 + Pddot20_1;
  const T Pddot21_2 = R20_12 * t21_19 + R20_22 * t21_20 + R20_32 * t21_21 + Pddot20_2;
  const T Pddot21_3 = R20_13 * t21_19 + R20_23 * t21_20 + R20_33 * t21_21 + Pddot20_3;
  // N20 = R20 R21^T M_torque_21_ + axial(U20 (tr(I20)/2 - I20)) - M_torque_20_: moment balance about the mass centre,
  //   body axes [N m]
  const T t21_22 = R21_11 * u.tau_21_1 + R21_21 * u.tau_21_2 + R21_31 * u.tau_21_3;
  const T t21_23 = R21_12 * u.tau_21_1 + R21_22 * u.tau_21_2 + R21_32 * u.tau_21_3;
  const T t21_24 = R21_13 * u.tau_21_1 + R21_23 * u.tau_21_2 + R21_33 * u.tau_21_3;
  const T N20_1 = R20_11 * t21_22 + R20_12 * t21_23 + R20_13 * t21_24 + T(0.09) * U20_32 - T(0.21) * U20_23 + T(0.012)
      * (minus_U20_22 - minus_U20_33) - T(0.015) * U20_31 + T(0.009) * U20_21 - u.tau_20_1;
  const T N20_2 = R20_21 * t21_22 + R20_22 * t21_23 + R20_23 * t21_24 + T(0.21) * U20_13 - T(0.15) * U20_31 - T(0.009)
      * (minus_U20_33 - minus_U20_11) + T(0.012) * U20_12 + T(0.015) * U20_32 - u.tau_20_2;
  const T N20_3 = R20_31 * t21_22 + R20_32 * t21_23 + R20_33 * t21_24 + T(0.15) * U20_21 - T(0.09) * U20_12 - T(0.015)
      * (minus_U20_11 - minus_U20_22) - T(0.009) * U20_23 - T(0.012) * U20_13 - u.tau_20_3;
  // a21 = R21^T U21 r21 + Pddot21: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t21_25 = U21_12 * T(0.2) - minus_U21_11 * T(0.1) + U21_13 * T(0.05);
  const T t21_26 = U21_21 * T(0.1) - minus_U21_22 * T(0.2) + U21_23 * T(0.05);
  const T t21_27 = U21_31 * T(0.1) + U21_32 * T(0.2) - minus_U21_33 * T(0.05);
  const T a21_1 = R21_11 * t21_25 + R21_21 * t21_26 + R21_31 * t21_27 + Pddot21_1;
  const T a21_2 = R21_12 * t21_25 + R21_22 * t21_26 + R21_32 * t21_27 + Pddot21_2;
  const T a21_3 = R21_13 * t21_25 + R21_23 * t21_26 + R21_33 * t21_27 + Pddot21_3;
  // G21 = m21 a21: force balance, inertial axes [N]
  const T G21_1 = T(3.1) * a21_1;
  const T G21_2 = T(3.1) * a21_2;
  const T G21_3 = T(3.1) * a21_3;

  // ---- body 22 (body_22) on body 21
  const T eps22_1 = x[84], eps22_2 = x[85], eps22_3 = x[86], eps22_4 = x[87];
  const T omega22_1 = y[63], omega22_2 = y[64], omega22_3 = y[65];
  const T omegadot22_1 = ydot[63], omegadot22_2 = ydot[64], omegadot22_3 = ydot[65];
  // R22^T = 1 + 2 e22~ (eps4_22 + e22~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t22_1 = T(2) * eps22_2;
  const T t22_2 = t22_1 * eps22_2;
  const T t22_3 = T(2) * eps22_3;
  const T t22_4 = t22_3 * eps22_3;
  const T R22_11 = T(1) - t22_2 - t22_4;
  const T t22_5 = T(2) * eps22_1;
  const T t22_6 = t22_5 * eps22_2;
  const T t22_7 = t22_3 * eps22_4;
  const T R22_12 = t22_6 + t22_7;
  const T t22_8 = t22_5 * eps22_3;
  const T t22_9 = t22_1 * eps22_4;
  const T R22_13 = t22_8 - t22_9;
  const T R22_21 = t22_6 - t22_7;
  const T t22_10 = T(1) - t22_5 * eps22_1;
  const T R22_22 = t22_10 - t22_4;
  const T t22_11 = t22_1 * eps22_3;
  const T t22_12 = t22_5 * eps22_4;
  const T R22_23 = t22_11 + t22_12;
  const T R22_31 = t22_8 + t22_9;
  const T R22_32 = t22_11 - t22_12;
  const T R22_33 = t22_10 - t22_2;
  // U22 = omega22~ omega22~ + omegadot22~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t22_13 = omega22_3 * omega22_3;
  const T t22_14 = omega22_2 * omega22_2;
  const T minus_U22_11 = t22_13 + t22_14;
  const T t22_15 = omega22_2 * omega22_1;
  const T U22_12 = t22_15 - omegadot22_3;
  const T t22_16 = omega22_3 * omega22_1;
  const T U22_13 = t22_16 + omegadot22_2;
  const T U22_21 = t22_15 + omegadot22_3;
  const T t22_17 = omega22_1 * omega22_1;
  const T minus_U22_22 = t22_13 + t22_17;
  const T t22_18 = omega22_3 * omega22_2;
  const T U22_23 = t22_18 - omegadot22_1;
  const T U22_31 = t22_16 - omegadot22_2;
  const T U22_32 = t22_18 + omegadot22_1;
  const T minus_U22_33 = t22_14 + t22_17;
  // Pddot22 = R21^T U21 q22 + Pddot21: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t22_19 = U21_12 * T(1.1) - minus_U21_11 * T(0.3) + U21_13 * T(0.1);
  const T t22_20 = U21_21 * T(0.3) - minus_U21_22 * T(1.1) + U21_23 * T(0.1);
  const T t22_21 = U21_31 * T(0.3) + U21_32 * T(1.1) - minus_U21_33 * T(0.1);
  const T Pddot22_1 = R21_11 * t22_19 + R21_21 * t22_20 + R21_31 * t22_21 + Pddot21_1;
  const T Pddot22_2 = R21_12 * t22_19 + R21_22 * t22_20 + R21_32 * t22_21 + Pddot21_2;
  const T Pddot22_3 = R21_13 * t22_19 + R21_23 * t22_20 + R21_33 * t22_21 + Pddot21_3;
  // N21 = R21 R22^T M_torque_22_ + axial(U21 (tr(I21)/2 - I21)) - M_torque_21_: moment balance about the mass centre,
  //   body axes [N m]
  const T t22_22 = R22_11 * u.tau_22_1 + R22_21 * u.tau_22_2 + R22_31 * u.tau_22_3;
  const T t22_23 = R22_12 * u.tau_22_1 + R22_22 * u.tau_22_2 + R22_32 * u.tau_22_3;
  const T t22_24 = R22_13 * u.tau_22_1 + R22_23 * u.tau_22_2 + R22_33 * u.tau_22_3;
  const T N21_1 = R21_11 * t22_22 + R21_12 * t22_23 + R21_13 * t22_24 + T(0.093) * U21_32 - T(0.217) * U21_23 +
      T(0.0124) * (minus_U21_22 - minus_U21_33) - T(0.0155) * U21_31 + T(0.0093) * U21_21 - u.tau_21_1;
  const T N21_2 = R21_21 * t22_22 + R21_22 * t22_23 + R21_23 * t22_24 + T(0.217) * U21_13 - T(0.155) * U21_31 -
      T(0.0093) * (minus_U21_33 - minus_U21_11) + T(0.0124) * U21_12 + T(0.0155) * U21_32 - u.tau_21_2;
  const T N21_3 = R21_31 * t22_22 + R21_32 * t22_23 + R21_33 * t22_24 + T(0.155) * U21_21 - T(0.093) * U21_12 -
      T(0.0155) * (minus_U21_11 - minus_U21_22) - T(0.0093) * U21_23 - T(0.0124) * U21_13 - u.tau_21_3;
  // a22 = R22^T U22 r22 + Pddot22: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t22_25 = U22_12 * T(0.2) - minus_U22_11 * T(0.1) + U22_13 * T(0.05);
  const T t22_26 = U22_21 * T(0.1) - minus_U22_22 * T(0.2) + U22_23 * T(0.05);
  const T t22_27 = U22_31 * T(0.1) + U22_32 * T(0.2) - minus_U22_33 * T(0.05);
  const T a22_1 = R22_11 * t22_25 + R22_21 * t22_26 + R22_31 * t22_27 + Pddot22_1;
  const T a22_2 = R22_12 * t22_25 + R22_22 * t22_26 + R22_32 * t22_27 + Pddot22_2;
  const T a22_3 = R22_13 * t22_25 + R22_23 * t22_26 + R22_33 * t22_27 + Pddot22_3;
  // G22 = m22 a22: force balance, inertial axes [N]
  const T G22_1 = T(3.2) * a22_1;
  const T G22_2 = T(3.2) * a22_2;
  const T G22_3 = T(3.2) * a22_3;

  // ---- body 23 (body_23) on body 22
  const T eps23_1 = x[88], eps23_2 = x[89], eps23_3 = x[90], eps23_4 = x[91];
  const T omega23_1 = y[66], omega23_2 = y[67], omega23_3 = y[68];
  const T omegadot23_1 = ydot[66], omegadot23_2 = ydot[67], omegadot23_3 = ydot[68];
  // R23^T = 1 + 2 e23~ (eps4_23 + e23~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t23_1 = T(2) * eps23_2;
  const T t23_2 = t23_1 * eps23_2;
  const T t23_3 = T(2) * eps23_3;
  const T t23_4 = t23_3 * eps23_3;
  const T R23_11 = T(1) - t23_2 - t23_4;
  const T t23_5 = T(2) * eps23_1;
  const T t23_6 = t23_5 * eps23_2;
  const T t23_7 = t23_3 * eps23_4;
  const T R23_12 = t23_6 + t23_7;
  const T t23_8 = t23_5 * eps23_3;
  const T t23_9 = t23_1 * eps23_4;
  const T R23_13 = t23_8 - t23_9;
  const T R23_21 = t23_6 - t23_7;
  const T t23_10 = T(1) - t23_5 * eps23_1;
  const T R23_22 = t23_10 - t23_4;
  const T t23_11 = t23_1 * eps23_3;
  const T t23_12 = t23_5 * eps23_4;
  const T R23_23 = t23_11 + t23_12;
  const T R23_31 = t23_8 + t23_9;
  const T R23_32 = t23_11 - t23_12;
  const T R23_33 = t23_10 - t23_2;
  // U23 = omega23~ omega23~ + omegadot23~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t23_13 = omega23_3 * omega23_3;
  const T t23_14 = omega23_2 * omega23_2;
  const T minus_U23_11 = t23_13 + t23_14;
  const T t23_15 = omega23_2 * omega23_1;
  const T U23_12 = t23_15 - omegadot23_3;
  const T t23_16 = omega23_3 * omega23_1;
  const T U23_13 = t23_16 + omegadot23_2;
  const T U23_21 = t23_15 + omegadot23_3;
  const T t23_17 = omega23_1 * omega23_1;
  const T minus_U23_22 = t23_13 + t23_17;
  const T t23_18 = omega23_3 * omega23_2;
  const T U23_23 = t23_18 - omegadot23_1;
  const T U23_31 = t23_16 - omegadot23_2;
  const T U23_32 = t23_18 + omegadot23_1;
  const T minus_U23_33 = t23_14 + t23_17;
  // Pddot23 = R22^T U22 q23 + Pddot22: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t23_19 = U22_12 * T(1.15) - minus_U22_11 * T(0.3) + U22_13 * T(0.1);
  const T t23_20 = U22_21 * T(0.3) - minus_U22_22 * T(1.15) + U22_23 * T(0.1);
  const T t23_21 = U22_31 * T(0.3) + U22_32 * T(1.15) - minus_U22_33 * T(0.1);
  const T Pddot23_1 = R22_11 * t23_19 + R22_21 * t23_20 + R22_31 * t23_21 + Pddot22_1;
  const T Pddot23_2 = R22_12 * t23_19 + R22_22 * t23_20 + R22_32 * t23_21 + Pddot22_2;
  const T Pddot23_3 = R22_13 * t23_19 + R22_23 * t23_20 + R22_33 * t23_21 + Pddot22_3;
  // N22 = R22 R23^T M_torque_23_ + axial(U22 (tr(I22)/2 - I22)) - M_torque_22_: moment balance about the mass centre,
  //   body axes [N m]
  const T t23_22 = R23_11 * u.tau_23_1 + R23_21 * u.tau_23_2 + R23_31 * u.tau_23_3;
  const T t23_23 = R23_12 * u.tau_23_1 + R23_22 * u.tau_23_2 + R23_32 * u.tau_23_3;
  const T t23_24 = R23_13 * u.tau_23_1 + R23_23 * u.tau_23_2 + R23_33 * u.tau_23_3;
  const T N22_1 = R22_11 * t23_22 + R22_12 * t23_23 + R22_13 * t23_24 + T(0.096) * U22_32 - T(0.224) * U22_23 +
      T(0.0128) * (minus_U22_22 - minus_U22_33) - T(0.016) * U22_31 + T(0.0096) * U22_21 - u.tau_22_1;
  const T N22_2 = R22_21 * t23_22 + R22_22 * t23_23 + R22_23 * t23_24 + T(0.224) * U22_13 - T(0.16) * U22_31 -
      T(0.0096) * (minus_U22_33 - minus_U22_11) + T(0.0128) * U22_12 + T(0.016) * U22_32 - u.tau_22_2;
  const T N22_3 = R22_31 * t23_22 + R22_32 * t23_23 + R22_33 * t23_24 + T(0.16) * U22_21 - T(0.096) * U22_12 -
      T(0.016) * (minus_U22_11 - minus_U22_22) - T(0.0096) * U22_23 - T(0.0128) * U22_13 - u.tau_22_3;
  // a23 = R23^T U23 r23 + Pddot23: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t23_25 = U23_12 * T(0.2) - minus_U23_11 * T(0.1) + U23_13 * T(0.05);
  const T t23_26 = U23_21 * T(0.1) - minus_U23_22 * T(0.2) + U23_23 * T(0.05);
  const T t23_27 = U23_31 * T(0.1) + U23_32 * T(0.2) - minus_U23_33 * T(0.05);
  const T a23_1 = R23_11 * t23_25 + R23_21 * t23_26 + R23_31 * t23_27 + Pddot23_1;
  const T a23_2 = R23_12 * t23_25 + R23_22 * t23_26 + R23_32 * t23_27 + Pddot23_2;
  const T a23_3 = R23_13 * t23_25 + R23_23 * t23_26 + R23_33 * t23_27 + Pddot23_3;
  // G23 = m23 a23: force balance, inertial axes [N]
  const T G23_1 = T(3.3) * a23_1;
  const T G23_2 = T(3.3) * a23_2;
  const T G23_3 = T(3.3) * a23_3;

  // ---- body 24 (body_24) on body 23
  const T eps24_1 = x[92], eps24_2 = x[93], eps24_3 = x[94], eps24_4 = x[95];
  const T omega24_1 = y[69], omega24_2 = y[70], omega24_3 = y[71];
  const T omegadot24_1 = ydot[69], omegadot24_2 = ydot[70], omegadot24_3 = ydot[71];
  // R24^T = 1 + 2 e24~ (eps4_24 + e24~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t24_1 = T(2) * eps24_2;
  const T t24_2 = t24_1 * eps24_2;
  const T t24_3 = T(2) * eps24_3;
  const T t24_4 = t24_3 * eps24_3;
  const T R24_11 = T(1) - t24_2 - t24_4;
  const T t24_5 = T(2) * eps24_1;
  const T t24_6 = t24_5 * eps24_2;
  const T t24_7 = t24_3 * eps24_4;
  const T R24_12 = t24_6 + t24_7;
  const T t24_8 = t24_5 * eps24_3;
  const T t24_9 = t24_1 * eps24_4;
  const T R24_13 = t24_8 - t24_9;
  const T R24_21 = t24_6 - t24_7;
  const T t24_10 = T(1) - t24_5 * eps24_1;
  const T R24_22 = t24_10 - t24_4;
  const T t24_11 = t24_1 * eps24_3;
  const T t24_12 = t24_5 * eps24_4;
  const T R24_23 = t24_11 + t24_12;
  const T R24_31 = t24_8 + t24_9;
  const T R24_32 = t24_11 - t24_12;
  const T R24_33 = t24_10 - t24_2;
  // U24 = omega24~ omega24~ + omegadot24~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t24_13 = omega24_3 * omega24_3;
  const T t24_14 = omega24_2 * omega24_2;
  const T minus_U24_11 = t24_13 + t24_14;
  const T t24_15 = omega24_2 * omega24_1;
  const T U24_12 = t24_15 - omegadot24_3;
  const T t24_16 = omega24_3 * omega24_1;
  const T U24_13 = t24_16 + omegadot24_2;
  const T U24_21 = t24_15 + omegadot24_3;
  const T t24_17 = omega24_1 * omega24_1;
  const T minus_U24_22 = t24_13 + t24_17;
  const T t24_18 = omega24_3 * omega24_2;
  const T U24_23 = t24_18 - omegadot24_1;
  const T U24_31 = t24_16 - omegadot24_2;
  const T U24_32 = t24_18 + omegadot24_1;
  const T minus_U24_33 = t24_14 + t24_17;
  // Pddot24 = R23^T U23 q24 + Pddot23: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t24_19 = U23_12 * T(1.2) - minus_U23_11 * T(0.3) + U23_13 * T(0.1);
  const T t24_20 = U23_21 * T(0.3) - minus_U23_22 * T(1.2) + U23_23 * T(0.1);
  const T t24_21 = U23_31 * T(0.3) + U23_32 * T(1.2) - minus_U23_33 * T(0.1);
  const T Pddot24_1 = R23_11 * t24_19 + R23_21 * t24_20 + R23_31 * t24_21 + Pddot23_1;
  const T Pddot24_2 = R23_12 * t24_19 + R23_22 * t24_20 + R23_32 * t24_21 + Pddot23_2;
  const T Pddot24_3 = R23_13 * t24_19 + R23_23 * t24_20 + R23_33 * t24_21 + Pddot23_3;
  // N23 = R23 R24^T M_torque_24_ + axial(U23 (tr(I23)/2 - I23)) - M_torque_23_: moment balance about the mass centre,
  //   body axes [N m]
  const T t24_22 = R24_11 * u.tau_24_1 + R24_21 * u.tau_24_2 + R24_31 * u.tau_24_3;
  const T t24_23 = R24_12 * u.tau_24_1 + R24_22 * u.tau_24_2 + R24_32 * u.tau_24_3;
  const T t24_24 = R24_13 * u.tau_24_1 + R24_23 * u.tau_24_2 + R24_33 * u.tau_24_3;
  const T N23_1 = R23_11 * t24_22 + R23_12 * t24_23 + R23_13 * t24_24 + T(0.099) * U23_32 - T(0.231) * U23_23 +
      T(0.0132) * (minus_U23_22 - minus_U23_33) - T(0.0165) * U23_31 + T(0.0099) * U23_21 - u.tau_23_1;
  const T N23_2 = R23_21 * t24_22 + R23_22 * t24_23 + R23_23 * t24_24 + T(0.231) * U23_13 - T(0.165) * U23_31 -
      T(0.0099) * (minus_U23_33 - minus_U23_11) + T(0.0132) * U23_12 + T(0.0165) * U23_32 - u.tau_23_2;
  const T N23_3 = R23_31 * t24_22 + R23_32 * t24_23 + R23_33 * t24_24 + T(0.165) * U23_21 - T(0.099) * U23_12 -
      T(0.0165) * (minus_U23_11 - minus_U23_22) - T(0.0099) * U23_23 - T(0.0132) * U23_13 - u.tau_23_3;
  // a24 = R24^T U24 r24 + Pddot24: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t24_25 = U24_12 * T(0.2) - minus_U24_11 * T(0.1) + U24_13 * T(0.05);
  const T t24_26 = U24_21 * T(0.1) - minus_U24_22 * T(0.2) + U24_23 * T(0.05);
  const T t24_27 = U24_31 * T(0.1) + U24_32 * T(0.2) - minus_U24_33 * T(0.05);
  const T a24_1 = R24_11 * t24_25 + R24_21 * t24_26 + R24_31 * t24_27 + Pddot24_1;
  const T a24_2 = R24_12 * t24_25 + R24_22 * t24_26 + R24_32 * t24_27 + Pddot24_2;
  const T a24_3 = R24_13 * t24_25 + R24_23 * t24_26 + R24_33 * t24_27 + Pddot24_3;
  // G24 = m24 a24: force balance, inertial axes [N]
  const T G24_1 = T(3.4) * a24_1;
  const T G24_2 = T(3.4) * a24_2;
  const T G24_3 = T(3.4) * a24_3;

  // ---- body 25 (body_25) on body 24
  const T eps25_1 = x[96], eps25_2 = x[97], eps25_3 = x[98], eps25_4 = x[99];
  const T omega25_1 = y[72], omega25_2 = y[73], omega25_3 = y[74];
  const T omegadot25_1 = ydot[72], omegadot25_2 = ydot[73], omegadot25_3 = ydot[74];
  // R25^T = 1 + 2 e25~ (eps4_25 + e25~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t25_1 = T(2) * eps25_2;
  const T t25_2 = t25_1 * eps25_2;
  const T t25_3 = T(2) * eps25_3;
  const T t25_4 = t25_3 * eps25_3;
  const T R25_11 = T(1) - t25_2 - t25_4;
  const T t25_5 = T(2) * eps25_1;
  const T t25_6 = t25_5 * eps25_2;
  const T t25_7 = t25_3 * eps25_4;
  const T R25_12 = t25_6 + t25_7;
  const T t25_8 = t25_5 * eps25_3;
  const T t25_9 = t25_1 * eps25_4;
  const T R25_13 = t25_8 - t25_9;
  const T R25_21 = t25_6 - t25_7;
  const T t25_10 = T(1) - t25_5 * eps25_1;
  const T R25_22 = t25_10 - t25_4;
  const T t25_11 = t25_1 * eps25_3;
  const T t25_12 = t25_5 * eps25_4;
  const T R25_23 = t25_11 + t25_12;
  const T R25_31 = t25_8 + t25_9;
  const T R25_32 = t25_11 - t25_12;
  const T R25_33 = t25_10 - t25_2;
  // U25 = omega25~ omega25~ + omegadot25~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t25_13 = omega25_3 * omega25_3;
  const T t25_14 = omega25_2 * omega25_2;
  const T minus_U25_11 = t25_13 + t25_14;
  const T t25_15 = omega25_2 * omega25_1;
  const T U25_12 = t25_15 - omegadot25_3;
  const T t25_16 = omega25_3 * omega25_1;
  const T U25_13 = t25_16 + omegadot25_2;
  const T U25_21 = t25_15 + omegadot25_3;
  const T t25_17 = omega25_1 * omega25_1;
  const T minus_U25_22 = t25_13 + t25_17;
  const T t25_18 = omega25_3 * omega25_2;
  const T U25_23 = t25_18 - omegadot25_1;
  const T U25_31 = t25_16 - omegadot25_2;
  const T U25_32 = t25_18 + omegadot25_1;
  const T minus_U25_33 = t25_14 + t25_17;
  // Pddot25 = R24^T U24 q25 + Pddot24: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t25_19 = U24_12 * T(1.25) - minus_U24_11 * T(0.3) + U24_13 * T(0.1);
  const T t25_20 = U24_21 * T(0.3) - minus_U24_22 * T(1.25) + U24_23 * T(0.1);
  const T t25_21 = U24_31 * T(0.3) + U24_32 * T(1.25) - minus_U24_33 * T(0.1);
  const T Pddot25_1 = R24_11 * t25_19 + R24_21 * t25_20 + R24_31 * t25_21 + Pddot24_1;
  const T Pddot25_2 = R24_12 * t25_19 + R24_22 * t25_20 + R24_32 * t25_21 + Pddot24_2;
  const T Pddot25_3 = R24_13 * t25_19 + R24_23 * t25_20 + R24_33 * t25_21 + Pddot24_3;
  // N24 = R24 R25^T M_torque_25_ + axial(U24 (tr(I24)/2 - I24)) - M_torque_24_: moment balance about the mass centre,
  //   body axes [N m]
  const T t25_22 = R25_11 * u.tau_25_1 + R25_21 * u.tau_25_2 + R25_31 * u.tau_25_3;
  const T t25_23 = R25_12 * u.tau_25_1 + R25_22 * u.tau_25_2 + R25_32 * u.tau_25_3;
  const T t25_24 = R25_13 * u.tau_25_1 + R25_23 * u.tau_25_2 + R25_33 * u.tau_25_3;
  const T N24_1 = R24_11 * t25_22 + R24_12 * t25_23 + R24_13 * t25_24 + T(0.10200000000000004) * U24_32 - T(0.238) *
      U24_23 + T(0.0136) * (minus_U24_22 - minus_U24_33) - T(0.017) * U24_31 + T(0.0102) * U24_21 - u.tau_24_1;
  const T N24_2 = R24_21 * t25_22 + R24_22 * t25_23 + R24_23 * t25_24 + T(0.238) * U24_13 - T(0.16999999999999998) *
      U24_31 - T(0.0102) * (minus_U24_33 - minus_U24_11) + T(0.0136) * U24_12 + T(0.017) * U24_32 - u.tau_24_2;
  const T N24_3 = R24_31 * t25_22 + R24_32 * t25_23 + R24_33 * t25_24 + T(0.16999999999999998) * U24_21 -
      T(0.10200000000000004) * U24_12 - T(0.017) * (minus_U24_11 - minus_U24_22) - T(0.0102) * U24_23 - T(0.0136) *
      U24_13 - u.tau_24_3;
  // a25 = R25^T U25 r25 + Pddot25: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t25_25 = U25_12 * T(0.2) - minus_U25_11 * T(0.1) + U25_13 * T(0.05);
  const T t25_26 = U25_21 * T(0.1) - minus_U25_22 * T(0.2) + U25_23 * T(0.05);
  const T t25_27 = U25_31 * T(0.1) + U25_32 * T(0.2) - minus_U25_33 * T(0.05);
  const T a25_1 = R25_11 * t25_25 + R25_21 * t25_26 + R25_31 * t25_27 + Pddot25_1;
  const T a25_2 = R25_12 * t25_25 + R25_22 * t25_26 + R25_32 * t25_27 + Pddot25_2;
  const T a25_3 = R25_13 * t25_25 + R25_23 * t25_26 + R25_33 * t25_27 + Pddot25_3;
  // G25 = m25 a25: force balance, inertial axes [N]
  const T G25_1 = T(3.5) * a25_1;
  const T G25_2 = T(3.5) * a25_2;
  const T G25_3 = T(3.5) * a25_3;

  // ---- body 26 (body_26) on body 25
  const T eps26_1 = x[100], eps26_2 = x[101], eps26_3 = x[102], eps26_4 = x[103];
  const T omega26_1 = y[75], omega26_2 = y[76], omega26_3 = y[77];
  const T omegadot26_1 = ydot[75], omegadot26_2 = ydot[76], omegadot26_3 = ydot[77];
  // R26^T = 1 + 2 e26~ (eps4_26 + e26~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t26_1 = T(2) * eps26_2;
  const T t26_2 = t26_1 * eps26_2;
  const T t26_3 = T(2) * eps26_3;
  const T t26_4 = t26_3 * eps26_3;
  const T R26_11 = T(1) - t26_2 - t26_4;
  const T t26_5 = T(2) * eps26_1;
  const T t26_6 = t26_5 * eps26_2;
  const T t26_7 = t26_3 * eps26_4;
  const T R26_12 = t26_6 + t26_7;
  const T t26_8 = t26_5 * eps26_3;
  const T t26_9 = t26_1 * eps26_4;
  const T R26_13 = t26_8 - t26_9;
  const T R26_21 = t26_6 - t26_7;
  const T t26_10 = T(1) - t26_5 * eps26_1;
  const T R26_22 = t26_10 - t26_4;
  const T t26_11 = t26_1 * eps26_3;
  const T t26_12 = t26_5 * eps26_4;
  const T R26_23 = t26_11 + t26_12;
  const T R26_31 = t26_8 + t26_9;
  const T R26_32 = t26_11 - t26_12;
  const T R26_33 = t26_10 - t26_2;
  // U26 = omega26~ omega26~ + omegadot26~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t26_13 = omega26_3 * omega26_3;
  const T t26_14 = omega26_2 * omega26_2;
  const T minus_U26_11 = t26_13 + t26_14;
  const T t26_15 = omega26_2 * omega26_1;
  const T U26_12 = t26_15 - omegadot26_3;
  const T t26_16 = omega26_3 * omega26_1;
  const T U26_13 = t26_16 + omegadot26_2;
  const T U26_21 = t26_15 + omegadot26_3;
  const T t26_17 = omega26_1 * omega26_1;
  const T minus_U26_22 = t26_13 + t26_17;
  const T t26_18 = omega26_3 * omega26_2;
  const T U26_23 = t26_18 - omegadot26_1;
  const T U26_31 = t26_16 - omegadot26_2;
  const T U26_32 = t26_18 + omegadot26_1;
  const T minus_U26_33 = t26_14 + t26_17;
  // Pddot26 = R25^T U25 q26 + Pddot25: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t26_19 = U25_12 * T(1.3) - minus_U25_11 * T(0.3) + U25_13 * T(0.1);
  const T t26_20 = U25_21 * T(0.3) - minus_U25_22 * T(1.3) + U25_23 * T(0.1);
  const T t26_21 = U25_31 * T(0.3) + U25_32 * T(1.3) - minus_U25_33 * T(0.1);
  const T Pddot26_1 = R25_11 * t26_19 + R25_21 * t26_20 + R25_31 * t26_21 + Pddot25_1;
  const T Pddot26_2 = R25_12 * t26_19 + R25_22 * t26_20 + R25_32 * t26_21 + Pddot25_2;
  const T Pddot26_3 = R25_13 * t26_19 + R25_23 * t26_20 + R25_33 * t26_21 + Pddot25_3;
  // N25 = R25 R26^T M_torque_26_ + axial(U25 (tr(I25)/2 - I25)) - M_torque_25_: moment balance about the mass centre,
  //   body axes [N m]
  const T t26_22 = R26_11 * u.tau_26_1 + R26_21 * u.tau_26_2 + R26_31 * u.tau_26_3;
  const T t26_23 = R26_12 * u.tau_26_1 + R26_22 * u.tau_26_2 + R26_32 * u.tau_26_3;
  const T t26_24 = R26_13 * u.tau_26_1 + R26_23 * u.tau_26_2 + R26_33 * u.tau_26_3;
  const T N25_1 = R25_11 * t26_22 + R25_12 * t26_23 + R25_13 * t26_24 + T(0.10500000000000001) * U25_32 -
      T(0.24499999999999997) * U25_23 + T(0.014) * (minus_U25_22 - minus_U25_33) - T(0.0175) * U25_31 + T(0.0105) *
      U25_21 - u.tau_25_1;
  const T N25_2 = R25_21 * t26_22 + R25_22 * t26_23 + R25_23 * t26_24 + T(0.24499999999999997) * U25_13 -
      T(0.17500000000000002) * U25_31 - T(0.0105) * (minus_U25_33 - minus_U25_11) + T(0.014) * U25_12 + T(0.0175) *
      U25_32 - u.tau_25_2;
  const T N25_3 = R25_31 * t26_22 + R25_32 * t26_23 + R25_33 * t26_24 + T(0.17500000000000002) * U25_21 -
      T(0.10500000000000001) * U25_12 - T(0.0175) * (minus_U25_11 - minus_U25_22) - T(0.0105) * U25_23 - T(0.014) *
      U25_13 - u.tau_25_3;
  // a26 = R26^T U26 r26 + Pddot26: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t26_25 = U26_12 * T(0.2) - minus_U26_11 * T(0.1) + U26_13 * T(0.05);
  const T t26_26 = U26_21 * T(0.1) - minus_U26_22 * T(0.2) + U26_23 * T(0.05);
  const T t26_27 = U26_31 * T(0.1) + U26_32 * T(0.2) - minus_U26_33 * T(0.05);
  const T a26_1 = R26_11 * t26_25 + R26_21 * t26_26 + R26_31 * t26_27 + Pddot26_1;
  const T a26_2 = R26_12 * t26_25 + R26_22 * t26_26 + R26_32 * t26_27 + Pddot26_2;
  const T a26_3 = R26_13 * t26_25 + R26_23 * t26_26 + R26_33 * t26_27 + Pddot26_3;
  // G26 = m26 a26: force balance, inertial axes [N]
  const T G26_1 = T(3.6) * a26_1;
  const T G26_2 = T(3.6) * a26_2;
  const T G26_3 = T(3.6) * a26_3;

  // ---- body 27 (body_27) on body 26
  const T eps27_1 = x[104], eps27_2 = x[105], eps27_3 = x[106], eps27_4 = x[107];
  const T omega27_1 = y[78], omega27_2 = y[79], omega27_3 = y[80];
  const T omegadot27_1 = ydot[78], omegadot27_2 = ydot[79], omegadot27_3 = ydot[80];
  // R27^T = 1 + 2 e27~ (eps4_27 + e27~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t27_1 = T(2) * eps27_2;
  const T t27_2 = t27_1 * eps27_2;
  const T t27_3 = T(2) * eps27_3;
  const T t27_4 = t27_3 * eps27_3;
  const T R27_11 = T(1) - t27_2 - t27_4;
  const T t27_5 = T(2) * eps27_1;
  const T t27_6 = t27_5 * eps27_2;
  const T t27_7 = t27_3 * eps27_4;
  const T R27_12 = t27_6 + t27_7;
  const T t27_8 = t27_5 * eps27_3;
  const T t27_9 = t27_1 * eps27_4;
  const T R27_13 = t27_8 - t27_9;
  const T R27_21 = t27_6 - t27_7;
  const T t27_10 = T(1) - t27_5 * eps27_1;
  const T R27_22 = t27_10 - t27_4;
  const T t27_11 = t27_1 * eps27_3;
  const T t27_12 = t27_5 * eps27_4;
  const T R27_23 = t27_11 + t27_12;
  const T R27_31 = t27_8 + t27_9;
  const T R27_32 = t27_11 - t27_12;
  const T R27_33 = t27_10 - t27_2;
  // U27 = omega27~ omega27~ + omegadot27~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t27_13 = omega27_3 * omega27_3;
  const T t27_14 = omega27_2 * omega27_2;
  const T minus_U27_11 = t27_13 + t27_14;
  const T t27_15 = omega27_2 * omega27_1;
  const T U27_12 = t27_15 - omegadot27_3;
  const T t27_16 = omega27_3 * omega27_1;
  const T U27_13 = t27_16 + omegadot27_2;
  const T U27_21 = t27_15 + omegadot27_3;
  const T t27_17 = omega27_1 * omega27_1;
  const T minus_U27_22 = t27_13 + t27_17;
  const T t27_18 = omega27_3 * omega27_2;
  const T U27_23 = t27_18 - omegadot27_1;
  const T U27_31 = t27_16 - omegadot27_2;
  const T U27_32 = t27_18 + omegadot27_1;
  const T minus_U27_33 = t27_14 + t27_17;
  // Pddot27 = R26^T U26 q27 + Pddot26: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t27_19 = U26_12 * T(1.35) - minus_U26_11 * T(0.3) + U26_13 * T(0.1);
  const T t27_20 = U26_21 * T(0.3) - minus_U26_22 * T(1.35) + U26_23 * T(0.1);
  const T t27_21 = U26_31 * T(0.3) + U26_32 * T(1.35) - minus_U26_33 * T(0.1);
  const T Pddot27_1 = R26_11 * t27_19 + R26_21 * t27_20 + R26_31 * t27_21 + Pddot26_1;
  const T Pddot27_2 = R26_12 * t27_19 + R26_22 * t27_20 + R26_32 * t27_21 + Pddot26_2;
  const T Pddot27_3 = R26_13 * t27_19 + R26_23 * t27_20 + R26_33 * t27_21 + Pddot26_3;
  // N26 = R26 R27^T M_torque_27_ + axial(U26 (tr(I26)/2 - I26)) - M_torque_26_: moment balance about the mass centre,
  //   body axes [N m]
  const T t27_22 = R27_11 * u.tau_27_1 + R27_21 * u.tau_27_2 + R27_31 * u.tau_27_3;
  const T t27_23 = R27_12 * u.tau_27_1 + R27_22 * u.tau_27_2 + R27_32 * u.tau_27_3;
  const T t27_24 = R27_13 * u.tau_27_1 + R27_23 * u.tau_27_2 + R27_33 * u.tau_27_3;
  const T N26_1 = R26_11 * t27_22 + R26_12 * t27_23 + R26_13 * t27_24 + T(0.10799999999999998) * U26_32 - T(0.252) *
      U26_23 + T(0.0144) * (minus_U26_22 - minus_U26_33) - T(0.018) * U26_31 + T(0.0108) * U26_21 - u.tau_26_1;
  const T N26_2 = R26_21 * t27_22 + R26_22 * t27_23 + R26_23 * t27_24 + T(0.252) * U26_13 - T(0.18) * U26_31 -
      T(0.0108) * (minus_U26_33 - minus_U26_11) + T(0.0144) * U26_12 + T(0.018) * U26_32 - u.tau_26_2;
  const T N26_3 = R26_31 * t27_22 + R26_32 * t27_23 + R26_33 * t27_24 + T(0.18) * U26_21 - T(0.10799999999999998) *
      U26_12 - T(0.018) * (minus_U26_11 - minus_U26_22) - T(0.0108) * U26_23 - T(0.0144) * U26_13 - u.tau_26_3;
  // a27 = R27^T U27 r27 + Pddot27: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t27_25 = U27_12 * T(0.2) - minus_U27_11 * T(0.1) + U27_13 * T(0.05);
  const T t27_26 = U27_21 * T(0.1) - minus_U27_22 * T(0.2) + U27_23 * T(0.05);
  const T t27_27 = U27_31 * T(0.1) + U27_32 * T(0.2) - minus_U27_33 * T(0.05);
  const T a27_1 = R27_11 * t27_25 + R27_21 * t27_26 + R27_31 * t27_27 + Pddot27_1;
  const T a27_2 = R27_12 * t27_25 + R27_22 * t27_26 + R27_32 * t27_27 + Pddot27_2;
  const T a27_3 = R27_13 * t27_25 + R27_23 * t27_26 + R27_33 * t27_27 + Pddot27_3;
  // G27 = m27 a27: force balance, inertial axes [N]
  const T G27_1 = T(3.7) * a27_1;
  const T G27_2 = T(3.7) * a27_2;
  const T G27_3 = T(3.7) * a27_3;

  // ---- body 28 (body_28) on body 27
  const T eps28_1 = x[108], eps28_2 = x[109], eps28_3 = x[110], eps28_4 = x[111];
  const T omega28_1 = y[81], omega28_2 = y[82], omega28_3 = y[83];
  const T omegadot28_1 = ydot[81], omegadot28_2 = ydot[82], omegadot28_3 = ydot[83];
  // R28^T = 1 + 2 e28~ (eps4_28 + e28~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t28_1 = T(2) * eps28_2;
  const T t28_2 = t28_1 * eps28_2;
  const T t28_3 = T(2) * eps28_3;
  const T t28_4 = t28_3 * eps28_3;
  const T R28_11 = T(1) - t28_2 - t28_4;
  const T t28_5 = T(2) * eps28_1;
  const T t28_6 = t28_5 * eps28_2;
  const T t28_7 = t28_3 * eps28_4;
  const T R28_12 = t28_6 + t28_7;
  const T t28_8 = t28_5 * eps28_3;
  const T t28_9 = t28_1 * eps28_4;
  const T R28_13 = t28_8 - t28_9;
  const T R28_21 = t28_6 - t28_7;
  const T t28_10 = T(1) - t28_5 * eps28_1;
  const T R28_22 = t28_10 - t28_4;
  const T t28_11 = t28_1 * eps28_3;
  const T t28_12 = t28_5 * eps28_4;
  const T R28_23 = t28_11 + t28_12;
  const T R28_31 = t28_8 + t28_9;
  const T R28_32 = t28_11 - t28_12;
  const T R28_33 = t28_10 - t28_2;
  // U28 = omega28~ omega28~ + omegadot28~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t28_13 = omega28_3 * omega28_3;
  const T t28_14 = omega28_2 * omega28_2;
  const T minus_U28_11 = t28_13 + t28_14;
  const T t28_15 = omega28_2 * omega28_1;
  const T U28_12 = t28_15 - omegadot28_3;
  const T t28_16 = omega28_3 * omega28_1;
  const T U28_13 = t28_16 + omegadot28_2;
  const T U28_21 = t28_15 + omegadot28_3;
  const T t28_17 = omega28_1 * omega28_1;
  const T minus_U28_22 = t28_13 + t28_17;
  const T t28_18 = omega28_3 * omega28_2;
  const T U28_23 = t28_18 - omegadot28_1;
  const T U28_31 = t28_16 - omegadot28_2;
  const T U28_32 = t28_18 + omegadot28_1;
  const T minus_U28_33 = t28_14 + t28_17;
  // Pddot28 = R27^T U27 q28 + Pddot27: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t28_19 = U27_12 * T(1.4) - minus_U27_11 * T(0.3) + U27_13 * T(0.1);
  const T t28_20 = U27_21 * T(0.3) - minus_U27_22 * T(1.4) + U27_23 * T(0.1);
  const T t28_21 = U27_31 * T(0.3) + U27_32 * T(1.4) - minus_U27_33 * T(0.1);
  const T Pddot28_1 = R27_11 * t28_19 + R27_21 * t28_20 + R27_31 * t28_21 + Pddot27_1;
  const T Pddot28_2 = R27_12 * t28_19 + R27_22 * t28_20 + R27_32 * t28_21 + Pddot27_2;
  const T Pddot28_3 = R27_13 * t28_19 + R27_23 * t28_20 + R27_33 * t28_21 + Pddot27_3;
  // N27 = R27 R28^T M_torque_28_ + axial(U27 (tr(I27)/2 - I27)) - M_torque_27_: moment balance about the mass centre,
  //   body axes [N m]
  const T t28_22 = R28_11 * u.tau_28_1 + R28_21 * u.tau_28_2 + R28_31 * u.tau_28_3;
  const T t28_23 = R28_12 * u.tau_28_1 + R28_22 * u.tau_28_2 + R28_32 * u.tau_28_3;
  const T t28_24 = R28_13 * u.tau_28_1 + R28_23 * u.tau_28_2 + R28_33 * u.tau_28_3;
  const T N27_1 = R27_11 * t28_22 + R27_12 * t28_23 + R27_13 * t28_24 + T(0.11099999999999999) * U27_32 - T(0.259) *
      U27_23 + T(0.0148) * (minus_U27_22 - minus_U27_33) - T(0.0185) * U27_31 + T(0.0111) * U27_21 - u.tau_27_1;
  const T N27_2 = R27_21 * t28_22 + R27_22 * t28_23 + R27_23 * t28_24 + T(0.259) * U27_13 - T(0.185) * U27_31 -
      T(0.0111) * (minus_U27_33 - minus_U27_11) + T(0.0148) * U27_12 + T(0.0185) * U27_32 - u.tau_27_2;
  const T N27_3 = R27_31 * t28_22 + R27_32 * t28_23 + R27_33 * t28_24 + T(0.185) * U27_21 - T(0.11099999999999999) *
      U27_12 - T(0.0185) * (minus_U27_11 - minus_U27_22) - T(0.0111) * U27_23 - T(0.0148) * U27_13 - u.tau_27_3;
  // a28 = R28^T U28 r28 + Pddot28: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t28_25 = U28_12 * T(0.2) - minus_U28_11 * T(0.1) + U28_13 * T(0.05);
  const T t28_26 = U28_21 * T(0.1) - minus_U28_22 * T(0.2) + U28_23 * T(0.05);
  const T t28_27 = U28_31 * T(0.1) + U28_32 * T(0.2) - minus_U28_33 * T(0.05);
  const T a28_1 = R28_11 * t28_25 + R28_21 * t28_26 + R28_31 * t28_27 + Pddot28_1;
  const T a28_2 = R28_12 * t28_25 + R28_22 * t28_26 + R28_32 * t28_27 + Pddot28_2;
  const T a28_3 = R28_13 * t28_25 + R28_23 * t28_26 + R28_33 * t28_27 + Pddot28_3;
  // G28 = m28 a28: force balance, inertial axes [N]
  const T G28_1 = T(3.8) * a28_1;
  const T G28_2 = T(3.8) * a28_2;
  const T G28_3 = T(3.8) * a28_3;

  // ---- body 29 (body_29) on body 28
  const T eps29_1 = x[112], eps29_2 = x[113], eps29_3 = x[114], eps29_4 = x[115];
  const T omega29_1 = y[84], omega29_2 = y[85], omega29_3 = y[86];
  const T omegadot29_1 = ydot[84], omegadot29_2 = ydot[85], omegadot29_3 = ydot[86];
  // R29^T = 1 + 2 e29~ (eps4_29 + e29~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t29_1 = T(2) * eps29_2;
  const T t29_2 = t29_1 * eps29_2;
  const T t29_3 = T(2) * eps29_3;
  const T t29_4 = t29_3 * eps29_3;
  const T R29_11 = T(1) - t29_2 - t29_4;
  const T t29_5 = T(2) * eps29_1;
  const T t29_6 = t29_5 * eps29_2;
  const T t29_7 = t29_3 * eps29_4;
  const T R29_12 = t29_6 + t29_7;
  const T t29_8 = t29_5 * eps29_3;
  const T t29_9 = t29_1 * eps29_4;
  const T R29_13 = t29_8 - t29_9;
  const T R29_21 = t29_6 - t29_7;
  const T t29_10 = T(1) - t29_5 * eps29_1;
  const T R29_22 = t29_10 - t29_4;
  const T t29_11 = t29_1 * eps29_3;
  const T t29_12 = t29_5 * eps29_4;
  const T R29_23 = t29_11 + t29_12;
  const T R29_31 = t29_8 + t29_9;
  const T R29_32 = t29_11 - t29_12;
  const T R29_33 = t29_10 - t29_2;
  // U29 = omega29~ omega29~ + omegadot29~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t29_13 = omega29_3 * omega29_3;
  const T t29_14 = omega29_2 * omega29_2;
  const T minus_U29_11 = t29_13 + t29_14;
  const T t29_15 = omega29_2 * omega29_1;
  const T U29_12 = t29_15 - omegadot29_3;
  const T t29_16 = omega29_3 * omega29_1;
  const T U29_13 = t29_16 + omegadot29_2;
  const T U29_21 = t29_15 + omegadot29_3;
  const T t29_17 = omega29_1 * omega29_1;
  const T minus_U29_22 = t29_13 + t29_17;
  const T t29_18 = omega29_3 * omega29_2;
  const T U29_23 = t29_18 - omegadot29_1;
  const T U29_31 = t29_16 - omegadot29_2;
  const T U29_32 = t29_18 + omegadot29_1;
  const T minus_U29_33 = t29_14 + t29_17;
  // Pddot29 = R28^T U28 q29 + Pddot28: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t29_19 = U28_12 * T(1.45) - minus_U28_11 * T(0.3) + U28_13 * T(0.1);
  const T t29_20 = U28_21 * T(0.3) - minus_U28_22 * T(1.45) + U28_23 * T(0.1);
  const T t29_21 = U28_31 * T(0.3) + U28_32 * T(1.45) - minus_U28_33 * T(0.1);
  const T Pddot29_1 = R28_11 * t29_19 + R28_21 * t29_20 + R28_31 * t29_21 + Pddot28_1;
  const T Pddot29_2 = R28_12 * t29_19 + R28_22 * t29_20 + R28_32 * t29_21 + Pddot28_2;
  const T Pddot29_3 = R28_13 * t29_19 + R28_23 * t29_20 + R28_33 * t29_21 + Pddot28_3;
  // N28 = R28 R29^T M_torque_29_ + axial(U28 (tr(I28)/2 - I28)) - M_torque_28_: moment balance about the mass centre,
  //   body axes [N m]
  const T t29_22 = R29_11 * u.tau_29_1 + R29_21 * u.tau_29_2 + R29_31 * u.tau_29_3;
  const T t29_23 = R29_12 * u.tau_29_1 + R29_22 * u.tau_29_2 + R29_32 * u.tau_29_3;
  const T t29_24 = R29_13 * u.tau_29_1 + R29_23 * u.tau_29_2 + R29_33 * u.tau_29_3;
  const T N28_1 = R28_11 * t29_22 + R28_12 * t29_23 + R28_13 * t29_24 + T(0.11399999999999999) * U28_32 - T(0.266) *
      U28_23 + T(0.0152) * (minus_U28_22 - minus_U28_33) - T(0.019) * U28_31 + T(0.0114) * U28_21 - u.tau_28_1;
  const T N28_2 = R28_21 * t29_22 + R28_22 * t29_23 + R28_23 * t29_24 + T(0.266) * U28_13 - T(0.19) * U28_31 -
      T(0.0114) * (minus_U28_33 - minus_U28_11) + T(0.0152) * U28_12 + T(0.019) * U28_32 - u.tau_28_2;
  const T N28_3 = R28_31 * t29_22 + R28_32 * t29_23 + R28_33 * t29_24 + T(0.19) * U28_21 - T(0.11399999999999999) *
      U28_12 - T(0.019) * (minus_U28_11 - minus_U28_22) - T(0.0114) * U28_23 - T(0.0152) * U28_13 - u.tau_28_3;
  // a29 = R29^T U29 r29 + Pddot29: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t29_25 = U29_12 * T(0.2) - minus_U29_11 * T(0.1) + U29_13 * T(0.05);
  const T t29_26 = U29_21 * T(0.1) - minus_U29_22 * T(0.2) + U29_23 * T(0.05);
  const T t29_27 = U29_31 * T(0.1) + U29_32 * T(0.2) - minus_U29_33 * T(0.05);
  const T a29_1 = R29_11 * t29_25 + R29_21 * t29_26 + R29_31 * t29_27 + Pddot29_1;
  const T a29_2 = R29_12 * t29_25 + R29_22 * t29_26 + R29_32 * t29_27 + Pddot29_2;
  const T a29_3 = R29_13 * t29_25 + R29_23 * t29_26 + R29_33 * t29_27 + Pddot29_3;
  // G29 = m29 a29: force balance, inertial axes [N]
  const T G29_1 = T(3.9) * a29_1;
  const T G29_2 = T(3.9) * a29_2;
  const T G29_3 = T(3.9) * a29_3;

  // ---- body 30 (body_30) on body 29
  const T eps30_1 = x[116], eps30_2 = x[117], eps30_3 = x[118], eps30_4 = x[119];
  const T omega30_1 = y[87], omega30_2 = y[88], omega30_3 = y[89];
  const T omegadot30_1 = ydot[87], omegadot30_2 = ydot[88], omegadot30_3 = ydot[89];
  // R30^T = 1 + 2 e30~ (eps4_30 + e30~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t30_1 = T(2) * eps30_2;
  const T t30_2 = t30_1 * eps30_2;
  const T t30_3 = T(2) * eps30_3;
  const T t30_4 = t30_3 * eps30_3;
  const T R30_11 = T(1) - t30_2 - t30_4;
  const T t30_5 = T(2) * eps30_1;
  const T t30_6 = t30_5 * eps30_2;
  const T t30_7 = t30_3 * eps30_4;
  const T R30_12 = t30_6 + t30_7;
  const T t30_8 = t30_5 * eps30_3;
  const T t30_9 = t30_1 * eps30_4;
  const T R30_13 = t30_8 - t30_9;
  const T R30_21 = t30_6 - t30_7;
  const T t30_10 = T(1) - t30_5 * eps30_1;
  const T R30_22 = t30_10 - t30_4;
  const T t30_11 = t30_1 * eps30_3;
  const T t30_12 = t30_5 * eps30_4;
  const T R30_23 = t30_11 + t30_12;
  const T R30_31 = t30_8 + t30_9;
  const T R30_32 = t30_11 - t30_12;
  const T R30_33 = t30_10 - t30_2;
  // U30 = omega30~ omega30~ + omegadot30~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t30_13 = omega30_3 * omega30_3;
  const T t30_14 = omega30_2 * omega30_2;
  const T minus_U30_11 = t30_13 + t30_14;
  const T t30_15 = omega30_2 * omega30_1;
  const T U30_12 = t30_15 - omegadot30_3;
  const T t30_16 = omega30_3 * omega30_1;
  const T U30_13 = t30_16 + omegadot30_2;
  const T U30_21 = t30_15 + omegadot30_3;
  const T t30_17 = omega30_1 * omega30_1;
  const T minus_U30_22 = t30_13 + t30_17;
  const T t30_18 = omega30_3 * omega30_2;
  const T U30_23 = t30_18 - omegadot30_1;
  const T U30_31 = t30_16 - omegadot30_2;
  const T U30_32 = t30_18 + omegadot30_1;
  const T minus_U30_33 = t30_14 + t30_17;
  // Pddot30 = R29^T U29 q30 + Pddot29: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t30_19 = U29_12 * T(1.5) - minus_U29_11 * T(0.3) + U29_13 * T(0.1);
  const T t30_20 = U29_21 * T(0.3) - minus_U29_22 * T(1.5) + U29_23 * T(0.1);
  const T t30_21 = U29_31 * T(0.3) + U29_32 * T(1.5) - minus_U29_33 * T(0.1);
  const T Pddot30_1 = R29_11 * t30_19 + R29_21 * t30_20 + R29_31 * t30_21 + Pddot29_1;
  const T Pddot30_2 = R29_12 * t30_19 + R29_22 * t30_20 + R29_32 * t30_21 + Pddot29_2;
  const T Pddot30_3 = R29_13 * t30_19 + R29_23 * t30_20 + R29_33 * t30_21 + Pddot29_3;
  // N29 = R29 R30^T M_torque_30_ + axial(U29 (tr(I29)/2 - I29)) - M_torque_29_: moment balance about the mass centre,
  //   body axes [N m]
  const T t30_22 = R30_11 * u.tau_30_1 + R30_21 * u.tau_30_2 + R30_31 * u.tau_30_3;
  const T t30_23 = R30_12 * u.tau_30_1 + R30_22 * u.tau_30_2 + R30_32 * u.tau_30_3;
  const T t30_24 = R30_13 * u.tau_30_1 + R30_23 * u.tau_30_2 + R30_33 * u.tau_30_3;
  const T N29_1 = R29_11 * t30_22 + R29_12 * t30_23 + R29_13 * t30_24 + T(0.11699999999999999) * U29_32 - T(0.273) *
      U29_23 + T(0.0156) * (minus_U29_22 - minus_U29_33) - T(0.0195) * U29_31 + T(0.0117) * U29_21 - u.tau_29_1;
  const T N29_2 = R29_21 * t30_22 + R29_22 * t30_23 + R29_23 * t30_24 + T(0.273) * U29_13 - T(0.195) * U29_31 -
      T(0.0117) * (minus_U29_33 - minus_U29_11) + T(0.0156) * U29_12 + T(0.0195) * U29_32 - u.tau_29_2;
  const T N29_3 = R29_31 * t30_22 + R29_32 * t30_23 + R29_33 * t30_24 + T(0.195) * U29_21 - T(0.11699999999999999) *
      U29_12 - T(0.0195) * (minus_U29_11 - minus_U29_22) - T(0.0117) * U29_23 - T(0.0156) * U29_13 - u.tau_29_3;
  // a30 = R30^T U30 r30 + Pddot30: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t30_25 = U30_12 * T(0.2) - minus_U30_11 * T(0.1) + U30_13 * T(0.05);
  const T t30_26 = U30_21 * T(0.1) - minus_U30_22 * T(0.2) + U30_23 * T(0.05);
  const T t30_27 = U30_31 * T(0.1) + U30_32 * T(0.2) - minus_U30_33 * T(0.05);
  const T a30_1 = R30_11 * t30_25 + R30_21 * t30_26 + R30_31 * t30_27 + Pddot30_1;
  const T a30_2 = R30_12 * t30_25 + R30_22 * t30_26 + R30_32 * t30_27 + Pddot30_2;
  const T a30_3 = R30_13 * t30_25 + R30_23 * t30_26 + R30_33 * t30_27 + Pddot30_3;
  // G30 = m30 a30: force balance, inertial axes [N]
  const T G30_1 = T(4) * a30_1;
  const T G30_2 = T(4) * a30_2;
  const T G30_3 = T(4) * a30_3;

  // ---- body 31 (body_31) on body 30
  const T eps31_1 = x[120], eps31_2 = x[121], eps31_3 = x[122], eps31_4 = x[123];
  const T omega31_1 = y[90], omega31_2 = y[91], omega31_3 = y[92];
  const T omegadot31_1 = ydot[90], omegadot31_2 = ydot[91], omegadot31_3 = ydot[92];
  // R31^T = 1 + 2 e31~ (eps4_31 + e31~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t31_1 = T(2) * eps31_2;
  const T t31_2 = t31_1 * eps31_2;
  const T t31_3 = T(2) * eps31_3;
  const T t31_4 = t31_3 * eps31_3;
  const T R31_11 = T(1) - t31_2 - t31_4;
  const T t31_5 = T(2) * eps31_1;
  const T t31_6 = t31_5 * eps31_2;
  const T t31_7 = t31_3 * eps31_4;
  const T R31_12 = t31_6 + t31_7;
  const T t31_8 = t31_5 * eps31_3;
  const T t31_9 = t31_1 * eps31_4;
  const T R31_13 = t31_8 - t31_9;
  const T R31_21 = t31_6 - t31_7;
  const T t31_10 = T(1) - t31_5 * eps31_1;
  const T R31_22 = t31_10 - t31_4;
  const T t31_11 = t31_1 * eps31_3;
  const T t31_12 = t31_5 * eps31_4;
  const T R31_23 = t31_11 + t31_12;
  const T R31_31 = t31_8 + t31_9;
  const T R31_32 = t31_11 - t31_12;
  const T R31_33 = t31_10 - t31_2;
  // U31 = omega31~ omega31~ + omegadot31~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t31_13 = omega31_3 * omega31_3;
  const T t31_14 = omega31_2 * omega31_2;
  const T minus_U31_11 = t31_13 + t31_14;
  const T t31_15 = omega31_2 * omega31_1;
  const T U31_12 = t31_15 - omegadot31_3;
  const T t31_16 = omega31_3 * omega31_1;
  const T U31_13 = t31_16 + omegadot31_2;
  const T U31_21 = t31_15 + omegadot31_3;
  const T t31_17 = omega31_1 * omega31_1;
  const T minus_U31_22 = t31_13 + t31_17;
  const T t31_18 = omega31_3 * omega31_2;
  const T U31_23 = t31_18 - omegadot31_1;
  const T U31_31 = t31_16 - omegadot31_2;
  const T U31_32 = t31_18 + omegadot31_1;
  const T minus_U31_33 = t31_14 + t31_17;
  // Pddot31 = R30^T U30 q31 + Pddot30: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t31_19 = U30_12 * T(1.55) - minus_U30_11 * T(0.3) + U30_13 * T(0.1);
  const T t31_20 = U30_21 * T(0.3) - minus_U30_22 * T(1.55) + U30_23 * T(0.1);
  const T t31_21 = U30_31 * T(0.3) + U30_32 * T(1.55) - minus_U30_33 * T(0.1);
  const T Pddot31_1 = R30_11 * t31_19 + R30_21 * t31_20 + R30_31 * t31_21 + Pddot30_1;
  const T Pddot31_2 = R30_12 * t31_19 + R30_22 * t31_20 + R30_32 * t31_21 + Pddot30_2;
  const T Pddot31_3 = R30_13 * t31_19 + R30_23 * t31_20 + R30_33 * t31_21 + Pddot30_3;
  // N30 = R30 R31^T M_torque_31_ + axial(U30 (tr(I30)/2 - I30)) - M_torque_30_: moment balance about the mass centre,
  //   body axes [N m]
  const T t31_22 = R31_11 * u.tau_31_1 + R31_21 * u.tau_31_2 + R31_31 * u.tau_31_3;
  const T t31_23 = R31_12 * u.tau_31_1 + R31_22 * u.tau_31_2 + R31_32 * u.tau_31_3;
  const T t31_24 = R31_13 * u.tau_31_1 + R31_23 * u.tau_31_2 + R31_33 * u.tau_31_3;
  const T N30_1 = R30_11 * t31_22 + R30_12 * t31_23 + R30_13 * t31_24 + T(0.12000000000000002) * U30_32 - T(0.28) *
      U30_23 + T(0.016) * (minus_U30_22 - minus_U30_33) - T(0.02) * U30_31 + T(0.012) * U30_21 - u.tau_30_1;
  const T N30_2 = R30_21 * t31_22 + R30_22 * t31_23 + R30_23 * t31_24 + T(0.28) * U30_13 - T(0.19999999999999998) *
      U30_31 - T(0.012) * (minus_U30_33 - minus_U30_11) + T(0.016) * U30_12 + T(0.02) * U30_32 - u.tau_30_2;
  const T N30_3 = R30_31 * t31_22 + R30_32 * t31_23 + R30_33 * t31_24 + T(0.19999999999999998) * U30_21 -
      T(0.12000000000000002) * U30_12 - T(0.02) * (minus_U30_11 - minus_U30_22) - T(0.012) * U30_23 - T(0.016) *
      U30_13 - u.tau_30_3;
  // a31 = R31^T U31 r31 + Pddot31: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t31_25 = U31_12 * T(0.2) - minus_U31_11 * T(0.1) + U31_13 * T(0.05);
  const T t31_26 = U31_21 * T(0.1) - minus_U31_22 * T(0.2) + U31_23 * T(0.05);
  const T t31_27 = U31_31 * T(0.1) + U31_32 * T(0.2) - minus_U31_33 * T(0.05);
  const T a31_1 = R31_11 * t31_25 + R31_21 * t31_26 + R31_31 * t31_27 + Pddot31_1;
  const T a31_2 = R31_12 * t31_25 + R31_22 * t31_26 + R31_32 * t31_27 + Pddot31_2;
  const T a31_3 = R31_13 * t31_25 + R31_23 * t31_26 + R31_33 * t31_27 + Pddot31_3;
  // G31 = m31 a31: force balance, inertial axes [N]
  const T G31_1 = T(4.1) * a31_1;
  const T G31_2 = T(4.1) * a31_2;
  const T G31_3 = T(4.1) * a31_3;

  // ---- body 32 (body_32) on body 31
  const T eps32_1 = x[124], eps32_2 = x[125], eps32_3 = x[126], eps32_4 = x[127];
  const T omega32_1 = y[93], omega32_2 = y[94], omega32_3 = y[95];
  const T omegadot32_1 = ydot[93], omegadot32_2 = ydot[94], omegadot32_3 = ydot[95];
  // R32^T = 1 + 2 e32~ (eps4_32 + e32~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t32_1 = T(2) * eps32_2;
  const T t32_2 = t32_1 * eps32_2;
  const T t32_3 = T(2) * eps32_3;
  const T t32_4 = t32_3 * eps32_3;
  const T R32_11 = T(1) - t32_2 - t32_4;
  const T t32_5 = T(2) * eps32_1;
  const T t32_6 = t32_5 * eps32_2;
  const T t32_7 = t32_3 * eps32_4;
  const T R32_12 = t32_6 + t32_7;
  const T t32_8 = t32_5 * eps32_3;
  const T t32_9 = t32_1 * eps32_4;
  const T R32_13 = t32_8 - t32_9;
  const T R32_21 = t32_6 - t32_7;
  const T t32_10 = T(1) - t32_5 * eps32_1;
  const T R32_22 = t32_10 - t32_4;
  const T t32_11 = t32_1 * eps32_3;
  const T t32_12 = t32_5 * eps32_4;
  const T R32_23 = t32_11 + t32_12;
  const T R32_31 = t32_8 + t32_9;
  const T R32_32 = t32_11 - t32_12;
  const T R32_33 = t32_10 - t32_2;
  // U32 = omega32~ omega32~ + omegadot32~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t32_13 = omega32_3 * omega32_3;
  const T t32_14 = omega32_2 * omega32_2;
  const T minus_U32_11 = t32_13 + t32_14;
  const T t32_15 = omega32_2 * omega32_1;
  const T U32_12 = t32_15 - omegadot32_3;
  const T t32_16 = omega32_3 * omega32_1;
  const T U32_13 = t32_16 + omegadot32_2;
  const T U32_21 = t32_15 + omegadot32_3;
  const T t32_17 = omega32_1 * omega32_1;
  const T minus_U32_22 = t32_13 + t32_17;
  const T t32_18 = omega32_3 * omega32_2;
  const T U32_23 = t32_18 - omegadot32_1;
  const T U32_31 = t32_16 - omegadot32_2;
  const T U32_32 = t32_18 + omegadot32_1;
  const T minus_U32_33 = t32_14 + t32_17;
  // Pddot32 = R31^T U31 q32 + Pddot31: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t32_19 = U31_12 * T(1.6) - minus_U31_11 * T(0.3) + U31_13 * T(0.1);
  const T t32_20 = U31_21 * T(0.3) - minus_U31_22 * T(1.6) + U31_23 * T(0.1);
  const T t32_21 = U31_31 * T(0.3) + U31_32 * T(1.6) - minus_U31_33 * T(0.1);
  const T Pddot32_1 = R31_11 * t32_19 + R31_21 * t32_20 + R31_31 * t32_21 + Pddot31_1;
  const T Pddot32_2 = R31_12 * t32_19 + R31_22 * t32_20 + R31_32 * t32_21 + Pddot31_2;
  const T Pddot32_3 = R31_13 * t32_19 + R31_23 * t32_20 + R31_33 * t32_21 + Pddot31_3;
  // N31 = R31 R32^T M_torque_32_ + axial(U31 (tr(I31)/2 - I31)) - M_torque_31_: moment balance about the mass centre,
  //   body axes [N m]
  const T t32_22 = R32_11 * u.tau_32_1 + R32_21 * u.tau_32_2 + R32_31 * u.tau_32_3;
  const T t32_23 = R32_12 * u.tau_32_1 + R32_22 * u.tau_32_2 + R32_32 * u.tau_32_3;
  const T t32_24 = R32_13 * u.tau_32_1 + R32_23 * u.tau_32_2 + R32_33 * u.tau_32_3;
  const T N31_1 = R31_11 * t32_22 + R31_12 * t32_23 + R31_13 * t32_24 + T(0.123) * U31_32 - T(0.287) * U31_23 +
      T(0.0164) * (minus_U31_22 - minus_U31_33) - T(0.0205) * U31_31 + T(0.0123) * U31_21 - u.tau_31_1;
  const T N31_2 = R31_21 * t32_22 + R31_22 * t32_23 + R31_23 * t32_24 + T(0.287) * U31_13 - T(0.20500000000000002) *
      U31_31 - T(0.0123) * (minus_U31_33 - minus_U31_11) + T(0.0164) * U31_12 + T(0.0205) * U31_32 - u.tau_31_2;
  const T N31_3 = R31_31 * t32_22 + R31_32 * t32_23 + R31_33 * t32_24 + T(0.20500000000000002) * U31_21 - T(0.123) *
      U31_12 - T(0.0205) * (minus_U31_11 - minus_U31_22) - T(0.0123) * U31_23 - T(0.0164) * U31_13 - u.tau_31_3;
  // a32 = R32^T U32 r32 + Pddot32: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t32_25 = U32_12 * T(0.2) - minus_U32_11 * T(0.1) + U32_13 * T(0.05);
  const T t32_26 = U32_21 * T(0.1) - minus_U32_22 * T(0.2) + U32_23 * T(0.05);
  const T t32_27 = U32_31 * T(0.1) + U32_32 * T(0.2) - minus_U32_33 * T(0.05);
  const T a32_1 = R32_11 * t32_25 + R32_21 * t32_26 + R32_31 * t32_27 + Pddot32_1;
  const T a32_2 = R32_12 * t32_25 + R32_22 * t32_26 + R32_32 * t32_27 + Pddot32_2;
  const T a32_3 = R32_13 * t32_25 + R32_23 * t32_26 + R32_33 * t32_27 + Pddot32_3;
  // G32 = m32 a32: force balance, inertial axes [N]
  const T G32_1 = T(4.2) * a32_1;
  const T G32_2 = T(4.2) * a32_2;
  const T G32_3 = T(4.2) * a32_3;
  // N32 = axial(U32 (tr(I32)/2 - I32)) - M_torque_32_: moment balance about the mass centre, body axes [N m]
  const T N32_1 = T(0.126) * U32_32 - T(0.294) * U32_23 + T(0.0168) * (minus_U32_22 - minus_U32_33) - T(0.021) *
      U32_31 + T(0.0126) * U32_21 - u.tau_32_1;
  const T N32_2 = T(0.294) * U32_13 - T(0.21000000000000002) * U32_31 - T(0.0126) * (minus_U32_33 - minus_U32_11) +
      T(0.0168) * U32_12 + T(0.021) * U32_32 - u.tau_32_2;
  const T N32_3 = T(0.21000000000000002) * U32_21 - T(0.126) * U32_12 - T(0.021) * (minus_U32_11 - minus_U32_22) -
      T(0.0126) * U32_23 - T(0.0168) * U32_13 - u.tau_32_3;

  // ---- body 32 (body_32) and what it carries
  // r_omega32 = r32~ R32 G32 + N32: Kane's equation of omega [N m]
  const T b32_1 = R32_31 * G32_1 + R32_32 * G32_2 + R32_33 * G32_3;
  const T b32_2 = R32_21 * G32_1 + R32_22 * G32_2 + R32_23 * G32_3;
  const T r_omega32_1 = T(0.2) * b32_1 - T(0.05) * b32_2 + N32_1;
  const T b32_3 = R32_11 * G32_1 + R32_12 * G32_2 + R32_13 * G32_3;
  const T r_omega32_2 = T(0.05) * b32_3 - T(0.1) * b32_1 + N32_2;
  const T r_omega32_3 = T(0.1) * b32_2 - T(0.2) * b32_3 + N32_3;
  r[93] = r_omega32_1;
  r[94] = r_omega32_2;
  r[95] = r_omega32_3;

  // ---- body 31 (body_31) and what it carries
  // S31 = G31 + G32: sum of the force balances of the subtree, inertial axes [N]
  const T S31_1 = G31_1 + G32_1;
  const T S31_2 = G31_2 + G32_2;
  const T S31_3 = G31_3 + G32_3;
  // r_omega31 = q32~ R31 G32 + r31~ R31 G31 + N31: Kane's equation of omega [N m]
  const T b31_1 = R31_31 * G32_1 + R31_32 * G32_2 + R31_33 * G32_3;
  const T b31_2 = R31_21 * G32_1 + R31_22 * G32_2 + R31_23 * G32_3;
  const T b31_3 = R31_31 * G31_1 + R31_32 * G31_2 + R31_33 * G31_3;
  const T b31_4 = R31_21 * G31_1 + R31_22 * G31_2 + R31_23 * G31_3;
  const T r_omega31_1 = T(1.6) * b31_1 - T(0.1) * b31_2 + T(0.2) * b31_3 - T(0.05) * b31_4 + N31_1;
  const T b31_5 = R31_11 * G32_1 + R31_12 * G32_2 + R31_13 * G32_3;
  const T b31_6 = R31_11 * G31_1 + R31_12 * G31_2 + R31_13 * G31_3;
  const T r_omega31_2 = T(0.1) * b31_5 - T(0.3) * b31_1 + T(0.05) * b31_6 - T(0.1) * b31_3 + N31_2;
  const T r_omega31_3 = T(0.3) * b31_2 - T(1.6) * b31_5 + T(0.1) * b31_4 - T(0.2) * b31_6 + N31_3;
  r[90] = r_omega31_1;
  r[91] = r_omega31_2;
  r[92] = r_omega31_3;

  // ---- body 30 (body_30) and what it carries
  // S30 = G30 + S31: sum of the force balances of the subtree, inertial axes [N]
  const T S30_1 = G30_1 + S31_1;
  const T S30_2 = G30_2 + S31_2;
  const T S30_3 = G30_3 + S31_3;
  // r_omega30 = q31~ R30 S31 + r30~ R30 G30 + N30: Kane's equation of omega [N m]
  const T b30_1 = R30_31 * S31_1 + R30_32 * S31_2 + R30_33 * S31_3;
  const T b30_2 = R30_21 * S31_1 + R30_22 * S31_2 + R30_23 * S31_3;
  const T b30_3 = R30_31 * G30_1 + R30_32 * G30_2 + R30_33 * G30_3;
  const T b30_4 = R30_21 * G30_1 + R30_22 * G30_2 + R30_23 * G30_3;
  const T r_omega30_1 = T(1.55) * b30_1 - T(0.1) * b30_2 + T(0.2) * b30_3 - T(0.05) * b30_4 + N30_1;
  const T b30_5 = R30_11 * S31_1 + R30_12 * S31_2 + R30_13 * S31_3;
  const T b30_6 = R30_11 * G30_1 + R30_12 * G30_2 + R30_13 * G30_3;
  const T r_omega30_2 = T(0.1) * b30_5 - T(0.3) * b30_1 + T(0.05) * b30_6 - T(0.1) * b30_3 + N30_2;
  const T r_omega30_3 = T(0.3) * b30_2 - T(1.55) * b30_5 + T(0.1) * b30_4 - T(0.2) * b30_6 + N30_3;
  r[87] = r_omega30_1;
  r[88] = r_omega30_2;
  r[89] = r_omega30_3;

  // ---- body 29 (body_29) and what it carries
  // S29 = G29 + S30: sum of the force balances of the subtree, inertial axes [N]
  const T S29_1 = G29_1 + S30_1;
  const T S29_2 = G29_2 + S30_2;
  const T S29_3 = G29_3 + S30_3;
  // r_omega29 = q30~ R29 S30 + r29~ R29 G29 + N29: Kane's equation of omega [N m]
  const T b29_1 = R29_31 * S30_1 + R29_32 * S30_2 + R29_33 * S30_3;
  const T b29_2 = R29_21 * S30_1 + R29_22 * S30_2 + R29_23 * S30_3;
  const T b29_3 = R29_31 * G29_1 + R29_32 * G29_2 + R29_33 * G29_3;
  const T b29_4 = R29_21 * G29_1 + R29_22 * G29_2 + R29_23 * G29_3;
  const T r_omega29_1 = T(1.5) * b29_1 - T(0.1) * b29_2 + T(0.2) * b29_3 - T(0.05) * b29_4 + N29_1;
  const T b29_5 = R29_11 * S30_1 + R29_12 * S30_2 + R29_13 * S30_3;
  const T b29_6 = R29_11 * G29_1 + R29_12 * G29_2 + R29_13 * G29_3;
  const T r_omega29_2 = T(0.1) * b29_5 - T(0.3) * b29_1 + T(0.05) * b29_6 - T(0.1) * b29_3 + N29_2;
  const T r_omega29_3 = T(0.3) * b29_2 - T(1.5) * b29_5 + T(0.1) * b29_4 - T(0.2) * b29_6 + N29_3;
  r[84] = r_omega29_1;
  r[85] = r_omega29_2;
  r[86] = r_omega29_3;

  // ---- body 28 (body_28) and what it carries
  // S28 = G28 + S29: sum of the force balances of the subtree, inertial axes [N]
  const T S28_1 = G28_1 + S29_1;
  const T S28_2 = G28_2 + S29_2;
  const T S28_3 = G28_3 + S29_3;
  // r_omega28 = q29~ R28 S29 + r28~ R28 G28 + N28: Kane's equation of omega [N m]
  const T b28_1 = R28_31 * S29_1 + R28_32 * S29_2 + R28_33 * S29_3;
  const T b28_2 = R28_21 * S29_1 + R28_22 * S29_2 + R28_23 * S29_3;
  const T b28_3 = R28_31 * G28_1 + R28_32 * G28_2 + R28_33 * G28_3;
  const T b28_4 = R28_21 * G28_1 + R28_22 * G28_2 + R28_23 * G28_3;
  const T r_omega28_1 = T(1.45) * b28_1 - T(0.1) * b28_2 + T(0.2) * b28_3 - T(0.05) * b28_4 + N28_1;
  const T b28_5 = R28_11 * S29_1 + R28_12 * S29_2 + R28_13 * S29_3;
  const T b28_6 = R28_11 * G28_1 + R28_12 * G28_2 + R28_13 * G28_3;
  const T r_omega28_2 = T(0.1) * b28_5 - T(0.3) * b28_1 + T(0.05) * b28_6 - T(0.1) * b28_3 + N28_2;
  const T r_omega28_3 = T(0.3) * b28_2 - T(1.45) * b28_5 + T(0.1) * b28_4 - T(0.2) * b28_6 + N28_3;
  r[81] = r_omega28_1;
  r[82] = r_omega28_2;
  r[83] = r_omega28_3;

  // ---- body 27 (body_27) and what it carries
  // S27 = G27 + S28: sum of the force balances of the subtree, inertial axes [N]
  const T S27_1 = G27_1 + S28_1;
  const T S27_2 = G27_2 + S28_2;
  const T S27_3 = G27_3 + S28_3;
  // r_omega27 = q28~ R27 S28 + r27~ R27 G27 + N27: Kane's equation of omega [N m]
  const T b27_1 = R27_31 * S28_1 + R27_32 * S28_2 + R27_33 * S28_3;
  const T b27_2 = R27_21 * S28_1 + R27_22 * S28_2 + R27_23 * S28_3;
  const T b27_3 = R27_31 * G27_1 + R27_32 * G27_2 + R27_33 * G27_3;
  const T b27_4 = R27_21 * G27_1 + R27_22 * G27_2 + R27_23 * G27_3;
  const T r_omega27_1 = T(1.4) * b27_1 - T(0.1) * b27_2 + T(0.2) * b27_3 - T(0.05) * b27_4 + N27_1;
  const T b27_5 = R27_11 * S28_1 + R27_12 * S28_2 + R27_13 * S28_3;
  const T b27_6 = R27_11 * G27_1 + R27_12 * G27_2 + R27_13 * G27_3;
  const T r_omega27_2 = T(0.1) * b27_5 - T(0.3) * b27_1 + T(0.05) * b27_6 - T(0.1) * b27_3 + N27_2;
  const T r_omega27_3 = T(0.3) * b27_2 - T(1.4) * b27_5 + T(0.1) * b27_4 - T(0.2) * b27_6 + N27_3;
  r[78] = r_omega27_1;
  r[79] = r_omega27_2;
  r[80] = r_omega27_3;

  // ---- body 26 (body_26) and what it carries
  // S26 = G26 + S27: sum of the force balances of the subtree, inertial axes [N]
  const T S26_1 = G26_1 + S27_1;
  const T S26_2 = G26_2 + S27_2;
  const T S26_3 = G26_3 + S27_3;
  // r_omega26 = q27~ R26 S27 + r26~ R26 G26 + N26: Kane's equation of omega [N m]
  const T b26_1 = R26_31 * S27_1 + R26_32 * S27_2 + R26_33 * S27_3;
  const T b26_2 = R26_21 * S27_1 + R26_22 * S27_2 + R26_23 * S27_3;
  const T b26_3 = R26_31 * G26_1 + R26_32 * G26_2 + R26_33 * G26_3;
  const T b26_4 = R26_21 * G26_1 + R26_22 * G26_2 + R26_23 * G26_3;
  const T r_omega26_1 = T(1.35) * b26_1 - T(0.1) * b26_2 + T(0.2) * b26_3 - T(0.05) * b26_4 + N26_1;
  const T b26_5 = R26_11 * S27_1 + R26_12 * S27_2 + R26_13 * S27_3;
  const T b26_6 = R26_11 * G26_1 + R26_12 * G26_2 + R26_13 * G26_3;
  const T r_omega26_2 = T(0.1) * b26_5 - T(0.3) * b26_1 + T(0.05) * b26_6 - T(0.1) * b26_3 + N26_2;
  const T r_omega26_3 = T(0.3) * b26_2 - T(1.35) * b26_5 + T(0.1) * b26_4 - T(0.2) * b26_6 + N26_3;
  r[75] = r_omega26_1;
  r[76] = r_omega26_2;
  r[77] = r_omega26_3;

  // ---- body 25 (body_25) and what it carries
  // S25 = G25 + S26: sum of the force balances of the subtree, inertial axes [N]
  const T S25_1 = G25_1 + S26_1;
  const T S25_2 = G25_2 + S26_2;
  const T S25_3 = G25_3 + S26_3;
  // r_omega25 = q26~ R25 S26 + r25~ R25 G25 + N25: Kane's equation of omega [N m]
  const T b25_1 = R25_31 * S26_1 + R25_32 * S26_2 + R25_33 * S26_3;
  const T b25_2 = R25_21 * S26_1 + R25_22 * S26_2 + R25_23 * S26_3;
  const T b25_3 = R25_31 * G25_1 + R25_32 * G25_2 + R25_33 * G25_3;
  const T b25_4 = R25_21 * G25_1 + R25_22 * G25_2 + R25_23 * G25_3;
  const T r_omega25_1 = T(1.3) * b25_1 - T(0.1) * b25_2 + T(0.2) * b25_3 - T(0.05) * b25_4 + N25_1;
  const T b25_5 = R25_11 * S26_1 + R25_12 * S26_2 + R25_13 * S26_3;
  const T b25_6 = R25_11 * G25_1 + R25_12 * G25_2 + R25_13 * G25_3;
  const T r_omega25_2 = T(0.1) * b25_5 - T(0.3) * b25_1 + T(0.05) * b25_6 - T(0.1) * b25_3 + N25_2;
  const T r_omega25_3 = T(0.3) * b25_2 - T(1.3) * b25_5 + T(0.1) * b25_4 - T(0.2) * b25_6 + N25_3;
  r[72] = r_omega25_1;
  r[73] = r_omega25_2;
  r[74] = r_omega25_3;

  // ---- body 24 (body_24) and what it carries
  // S24 = G24 + S25: sum of the force balances of the subtree, inertial axes [N]
  const T S24_1 = G24_1 + S25_1;
  const T S24_2 = G24_2 + S25_2;
  const T S24_3 = G24_3 + S25_3;
  // r_omega24 = q25~ R24 S25 + r24~ R24 G24 + N24: Kane's equation of omega [N m]
  const T b24_1 = R24_31 * S25_1 + R24_32 * S25_2 + R24_33 * S25_3;
  const T b24_2 = R24_21 * S25_1 + R24_22 * S25_2 + R24_23 * S25_3;
  const T b24_3 = R24_31 * G24_1 + R24_32 * G24_2 + R24_33 * G24_3;
  const T b24_4 = R24_21 * G24_1 + R24_22 * G24_2 + R24_23 * G24_3;
  const T r_omega24_1 = T(1.25) * b24_1 - T(0.1) * b24_2 + T(0.2) * b24_3 - T(0.05) * b24_4 + N24_1;
  const T b24_5 = R24_11 * S25_1 + R24_12 * S25_2 + R24_13 * S25_3;
  const T b24_6 = R24_11 * G24_1 + R24_12 * G24_2 + R24_13 * G24_3;
  const T r_omega24_2 = T(0.1) * b24_5 - T(0.3) * b24_1 + T(0.05) * b24_6 - T(0.1) * b24_3 + N24_2;
  const T r_omega24_3 = T(0.3) * b24_2 - T(1.25) * b24_5 + T(0.1) * b24_4 - T(0.2) * b24_6 + N24_3;
  r[69] = r_omega24_1;
  r[70] = r_omega24_2;
  r[71] = r_omega24_3;

  // ---- body 23 (body_23) and what it carries
  // S23 = G23 + S24: sum of the force balances of the subtree, inertial axes [N]
  const T S23_1 = G23_1 + S24_1;
  const T S23_2 = G23_2 + S24_2;
  const T S23_3 = G23_3 + S24_3;
  // r_omega23 = q24~ R23 S24 + r23~ R23 G23 + N23: Kane's equation of omega [N m]
  const T b23_1 = R23_31 * S24_1 + R23_32 * S24_2 + R23_33 * S24_3;
  const T b23_2 = R23_21 * S24_1 + R23_22 * S24_2 + R23_23 * S24_3;
  const T b23_3 = R23_31 * G23_1 + R23_32 * G23_2 + R23_33 * G23_3;
  const T b23_4 = R23_21 * G23_1 + R23_22 * G23_2 + R23_23 * G23_3;
  const T r_omega23_1 = T(1.2) * b23_1 - T(0.1) * b23_2 + T(0.2) * b23_3 - T(0.05) * b23_4 + N23_1;
  const T b23_5 = R23_11 * S24_1 + R23_12 * S24_2 + R23_13 * S24_3;
  const T b23_6 = R23_11 * G23_1 + R23_12 * G23_2 + R23_13 * G23_3;
  const T r_omega23_2 = T(0.1) * b23_5 - T(0.3) * b23_1 + T(0.05) * b23_6 - T(0.1) * b23_3 + N23_2;
  const T r_omega23_3 = T(0.3) * b23_2 - T(1.2) * b23_5 + T(0.1) * b23_4 - T(0.2) * b23_6 + N23_3;
  r[66] = r_omega23_1;
  r[67] = r_omega23_2;
  r[68] = r_omega23_3;

  // ---- body 22 (body_22) and what it carries
  // S22 = G22 + S23: sum of the force balances of the subtree, inertial axes [N]
  const T S22_1 = G22_1 + S23_1;
  const T S22_2 = G22_2 + S23_2;
  const T S22_3 = G22_3 + S23_3;
  // r_omega22 = q23~ R22 S23 + r22~ R22 G22 + N22: Kane's equation of omega [N m]
  const T b22_1 = R22_31 * S23_1 + R22_32 * S23_2 + R22_33 * S23_3;
  const T b22_2 = R22_21 * S23_1 + R22_22 * S23_2 + R22_23 * S23_3;
  const T b22_3 = R22_31 * G22_1 + R22_32 * G22_2 + R22_33 * G22_3;
  const T b22_4 = R22_21 * G22_1 + R22_22 * G22_2 + R22_23 * G22_3;
  const T r_omega22_1 = T(1.15) * b22_1 - T(0.1) * b22_2 + T(0.2) * b22_3 - T(0.05) * b22_4 + N22_1;
  const T b22_5 = R22_11 * S23_1 + R22_12 * S23_2 + R22_13 * S23_3;
  const T b22_6 = R22_11 * G22_1 + R22_12 * G22_2 + R22_13 * G22_3;
  const T r_omega22_2 = T(0.1) * b22_5 - T(0.3) * b22_1 + T(0.05) * b22_6 - T(0.1) * b22_3 + N22_2;
  const T r_omega22_3 = T(0.3) * b22_2 - T(1.15) * b22_5 + T(0.1) * b22_4 - T(0.2) * b22_6 + N22_3;
  r[63] = r_omega22_1;
  r[64] = r_omega22_2;
  r[65] = r_omega22_3;

  // ---- body 21 (body_21) and what it carries
  // S21 = G21 + S22: sum of the force balances of the subtree, inertial axes [N]
  const T S21_1 = G21_1 + S22_1;
  const T S21_2 = G21_2 + S22_2;
  const T S21_3 = G21_3 + S22_3;
  // r_omega21 = q22~ R21 S22 + r21~ R21 G21 + N21: Kane's equation of omega [N m]
  const T b21_1 = R21_31 * S22_1 + R21_32 * S22_2 + R21_33 * S22_3;
  const T b21_2 = R21_21 * S22_1 + R21_22 * S22_2 + R21_23 * S22_3;
  const T b21_3 = R21_31 * G21_1 + R21_32 * G21_2 + R21_33 * G21_3;
  const T b21_4 = R21_21 * G21_1 + R21_22 * G21_2 + R21_23 * G21_3;
  const T r_omega21_1 = T(1.1) * b21_1 - T(0.1) * b21_2 + T(0.2) * b21_3 - T(0.05) * b21_4 + N21_1;
  const T b21_5 = R21_11 * S22_1 + R21_12 * S22_2 + R21_13 * S22_3;
  const T b21_6 = R21_11 * G21_1 + R21_12 * G21_2 + R21_13 * G21_3;
  const T r_omega21_2 = T(0.1) * b21_5 - T(0.3) * b21_1 + T(0.05) * b21_6 - T(0.1) * b21_3 + N21_2;
  const T r_omega21_3 = T(0.3) * b21_2 - T(1.1) * b21_5 + T(0.1) * b21_4 - T(0.2) * b21_6 + N21_3;
  r[60] = r_omega21_1;
  r[61] = r_omega21_2;
  r[62] = r_omega21_3;

  // ---- body 20 (body_20) and what it carries
  // S20 = G20 + S21: sum of the force balances of the subtree, inertial axes [N]
  const T S20_1 = G20_1 + S21_1;
  const T S20_2 = G20_2 + S21_2;
  const T S20_3 = G20_3 + S21_3;
  // r_omega20 = q21~ R20 S21 + r20~ R20 G20 + N20: Kane's equation of omega [N m]
  const T b20_1 = R20_31 * S21_1 + R20_32 * S21_2 + R20_33 * S21_3;
  const T b20_2 = R20_21 * S21_1 + R20_22 * S21_2 + R20_23 * S21_3;
  const T b20_3 = R20_31 * G20_1 + R20_32 * G20_2 + R20_33 * G20_3;
  const T b20_4 = R20_21 * G20_1 + R20_22 * G20_2 + R20_23 * G20_3;
  const T r_omega20_1 = T(1.05) * b20_1 - T(0.1) * b20_2 + T(0.2) * b20_3 - T(0.05) * b20_4 + N20_1;
  const T b20_5 = R20_11 * S21_1 + R20_12 * S21_2 + R20_13 * S21_3;
  const T b20_6 = R20_11 * G20_1 + R20_12 * G20_2 + R20_13 * G20_3;
  const T r_omega20_2 = T(0.1) * b20_5 - T(0.3) * b20_1 + T(0.05) * b20_6 - T(0.1) * b20_3 + N20_2;
  const T r_omega20_3 = T(0.3) * b20_2 - T(1.05) * b20_5 + T(0.1) * b20_4 - T(0.2) * b20_6 + N20_3;
  r[57] = r_omega20_1;
  r[58] = r_omega20_2;
  r[59] = r_omega20_3;

  // ---- body 19 (body_19) and what it carries
  // S19 = G19 + S20: sum of the force balances of the subtree, inertial axes [N]
  const T S19_1 = G19_1 + S20_1;
  const T S19_2 = G19_2 + S20_2;
  const T S19_3 = G19_3 + S20_3;
  // r_omega19 = q20~ R19 S20 + r19~ R19 G19 + N19: Kane's equation of omega [N m]
  const T b19_1 = R19_31 * S20_1 + R19_32 * S20_2 + R19_33 * S20_3;
  const T b19_2 = R19_21 * S20_1 + R19_22 * S20_2 + R19_23 * S20_3;
  const T b19_3 = R19_31 * G19_1 + R19_32 * G19_2 + R19_33 * G19_3;
  const T b19_4 = R19_21 * G19_1 + R19_22 * G19_2 + R19_23 * G19_3;
  const T r_omega19_1 = b19_1 - T(0.1) * b19_2 + T(0.2) * b19_3 - T(0.05) * b19_4 + N19_1;
  const T b19_5 = R19_11 * S20_1 + R19_12 * S20_2 + R19_13 * S20_3;
  const T b19_6 = R19_11 * G19_1 + R19_12 * G19_2 + R19_13 * G19_3;
  const T r_omega19_2 = T(0.1) * b19_5 - T(0.3) * b19_1 + T(0.05) * b19_6 - T(0.1) * b19_3 + N19_2;
  const T r_omega19_3 = T(0.3) * b19_2 - b19_5 + T(0.1) * b19_4 - T(0.2) * b19_6 + N19_3;
  r[54] = r_omega19_1;
  r[55] = r_omega19_2;
  r[56] = r_omega19_3;

  // ---- body 18 (body_18) and what it carries
  // S18 = G18 + S19: sum of the force balances of the subtree, inertial axes [N]
  const T S18_1 = G18_1 + S19_1;
  const T S18_2 = G18_2 + S19_2;
  const T S18_3 = G18_3 + S19_3;
  // r_omega18 = q19~ R18 S19 + r18~ R18 G18 + N18: Kane's equation of omega [N m]
  const T b18_1 = R18_31 * S19_1 + R18_32 * S19_2 + R18_33 * S19_3;
  const T b18_2 = R18_21 * S19_1 + R18_22 * S19_2 + R18_23 * S19_3;
  const T b18_3 = R18_31 * G18_1 + R18_32 * G18_2 + R18_33 * G18_3;
  const T b18_4 = R18_21 * G18_1 + R18_22 * G18_2 + R18_23 * G18_3;
  const T r_omega18_1 = T(0.95) * b18_1 - T(0.1) * b18_2 + T(0.2) * b18_3 - T(0.05) * b18_4 + N18_1;
  const T b18_5 = R18_11 * S19_1 + R18_12 * S19_2 + R18_13 * S19_3;
  const T b18_6 = R18_11 * G18_1 + R18_12 * G18_2 + R18_13 * G18_3;
  const T r_omega18_2 = T(0.1) * b18_5 - T(0.3) * b18_1 + T(0.05) * b18_6 - T(0.1) * b18_3 + N18_2;
  const T r_omega18_3 = T(0.3) * b18_2 - T(0.95) * b18_5 + T(0.1) * b18_4 - T(0.2) * b18_6 + N18_3;
  r[51] = r_omega18_1;
  r[52] = r_omega18_2;
  r[53] = r_omega18_3;

  // ---- body 17 (body_17) and what it carries
  // S17 = G17 + S18: sum of the force balances of the subtree, inertial axes [N]
  const T S17_1 = G17_1 + S18_1;
  const T S17_2 = G17_2 + S18_2;
  const T S17_3 = G17_3 + S18_3;
  // r_omega17 = q18~ R17 S18 + r17~ R17 G17 + N17: Kane's equation of omega [N m]
  const T b17_1 = R17_31 * S18_1 + R17_32 * S18_2 + R17_33 * S18_3;
  const T b17_2 = R17_21 * S18_1 + R17_22 * S18_2 + R17_23 * S18_3;
  const T b17_3 = R17_31 * G17_1 + R17_32 * G17_2 + R17_33 * G17_3;
  const T b17_4 = R17_21 * G17_1 + R17_22 * G17_2 + R17_23 * G17_3;
  const T r_omega17_1 = T(0.9) * b17_1 - T(0.1) * b17_2 + T(0.2) * b17_3 - T(0.05) * b17_4 + N17_1;
  const T b17_5 = R17_11 * S18_1 + R17_12 * S18_2 + R17_13 * S18_3;
  const T b17_6 = R17_11 * G17_1 + R17_12 * G17_2 + R17_13 * G17_3;
  const T r_omega17_2 = T(0.1) * b17_5 - T(0.3) * b17_1 + T(0.05) * b17_6 - T(0.1) * b17_3 + N17_2;
  const T r_omega17_3 = T(0.3) * b17_2 - T(0.9) * b17_5 + T(0.1) * b17_4 - T(0.2) * b17_6 + N17_3;
  r[48] = r_omega17_1;
  r[49] = r_omega17_2;
  r[50] = r_omega17_3;

  // ---- body 16 (body_16) and what it carries
  // S16 = G16 + S17: sum of the force balances of the subtree, inertial axes [N]
  const T S16_1 = G16_1 + S17_1;
  const T S16_2 = G16_2 + S17_2;
  const T S16_3 = G16_3 + S17_3;
  // r_omega16 = q17~ R16 S17 + r16~ R16 G16 + N16: Kane's equation of omega [N m]
  const T b16_1 = R16_31 * S17_1 + R16_32 * S17_2 + R16_33 * S17_3;
  const T b16_2 = R16_21 * S17_1 + R16_22 * S17_2 + R16_23 * S17_3;
  const T b16_3 = R16_31 * G16_1 + R16_32 * G16_2 + R16_33 * G16_3;
  const T b16_4 = R16_21 * G16_1 + R16_22 * G16_2 + R16_23 * G16_3;
  const T r_omega16_1 = T(0.85) * b16_1 - T(0.1) * b16_2 + T(0.2) * b16_3 - T(0.05) * b16_4 + N16_1;
  const T b16_5 = R16_11 * S17_1 + R16_12 * S17_2 + R16_13 * S17_3;
  const T b16_6 = R16_11 * G16_1 + R16_12 * G16_2 + R16_13 * G16_3;
  const T r_omega16_2 = T(0.1) * b16_5 - T(0.3) * b16_1 + T(0.05) * b16_6 - T(0.1) * b16_3 + N16_2;
  const T r_omega16_3 = T(0.3) * b16_2 - T(0.85) * b16_5 + T(0.1) * b16_4 - T(0.2) * b16_6 + N16_3;
  r[45] = r_omega16_1;
  r[46] = r_omega16_2;
  r[47] = r_omega16_3;

  // ---- body 15 (body_15) and what it carries
  // S15 = G15 + S16: sum of the force balances of the subtree, inertial axes [N]
  const T S15_1 = G15_1 + S16_1;
  const T S15_2 = G15_2 + S16_2;
  const T S15_3 = G15_3 + S16_3;
  // r_omega15 = q16~ R15 S16 + r15~ R15 G15 + N15: Kane's equation of omega [N m]
  const T b15_1 = R15_31 * S16_1 + R15_32 * S16_2 + R15_33 * S16_3;
  const T b15_2 = R15_21 * S16_1 + R15_22 * S16_2 + R15_23 * S16_3;
  const T b15_3 = R15_31 * G15_1 + R15_32 * G15_2 + R15_33 * G15_3;
  const T b15_4 = R15_21 * G15_1 + R15_22 * G15_2 + R15_23 * G15_3;
  const T r_omega15_1 = T(0.8) * b15_1 - T(0.1) * b15_2 + T(0.2) * b15_3 - T(0.05) * b15_4 + N15_1;
  const T b15_5 = R15_11 * S16_1 + R15_12 * S16_2 + R15_13 * S16_3;
  const T b15_6 = R15_11 * G15_1 + R15_12 * G15_2 + R15_13 * G15_3;
  const T r_omega15_2 = T(0.1) * b15_5 - T(0.3) * b15_1 + T(0.05) * b15_6 - T(0.1) * b15_3 + N15_2;
  const T r_omega15_3 = T(0.3) * b15_2 - T(0.8) * b15_5 + T(0.1) * b15_4 - T(0.2) * b15_6 + N15_3;
  r[42] = r_omega15_1;
  r[43] = r_omega15_2;
  r[44] = r_omega15_3;

  // ---- body 14 (body_14) and what it carries
  // S14 = G14 + S15: sum of the force balances of the subtree, inertial axes [N]
  const T S14_1 = G14_1 + S15_1;
  const T S14_2 = G14_2 + S15_2;
  const T S14_3 = G14_3 + S15_3;
  // r_omega14 = q15~ R14 S15 + r14~ R14 G14 + N14: Kane's equation of omega [N m]
  const T b14_1 = R14_31 * S15_1 + R14_32 * S15_2 + R14_33 * S15_3;
  const T b14_2 = R14_21 * S15_1 + R14_22 * S15_2 + R14_23 * S15_3;
  const T b14_3 = R14_31 * G14_1 + R14_32 * G14_2 + R14_33 * G14_3;
  const T b14_4 = R14_21 * G14_1 + R14_22 * G14_2 + R14_23 * G14_3;
  const T r_omega14_1 = T(0.75) * b14_1 - T(0.1) * b14_2 + T(0.2) * b14_3 - T(0.05) * b14_4 + N14_1;
  const T b14_5 = R14_11 * S15_1 + R14_12 * S15_2 + R14_13 * S15_3;
  const T b14_6 = R14_11 * G14_1 + R14_12 * G14_2 + R14_13 * G14_3;
  const T r_omega14_2 = T(0.1) * b14_5 - T(0.3) * b14_1 + T(0.05) * b14_6 - T(0.1) * b14_3 + N14_2;
  const T r_omega14_3 = T(0.3) * b14_2 - T(0.75) * b14_5 + T(0.1) * b14_4 - T(0.2) * b14_6 + N14_3;
  r[39] = r_omega14_1;
  r[40] = r_omega14_2;
  r[41] = r_omega14_3;

  // ---- body 13 (body_13) and what it carries
  // S13 = G13 + S14: sum of the force balances of the subtree, inertial axes [N]
  const T S13_1 = G13_1 + S14_1;
  const T S13_2 = G13_2 + S14_2;
  const T S13_3 = G13_3 + S14_3;
  // r_omega13 = q14~ R13 S14 + r13~ R13 G13 + N13: Kane's equation of omega [N m]
  const T b13_1 = R13_31 * S14_1 + R13_32 * S14_2 + R13_33 * S14_3;
  const T b13_2 = R13_21 * S14_1 + R13_22 * S14_2 + R13_23 * S14_3;
  const T b13_3 = R13_31 * G13_1 + R13_32 * G13_2 + R13_33 * G13_3;
  const T b13_4 = R13_21 * G13_1 + R13_22 * G13_2 + R13_23 * G13_3;
  const T r_omega13_1 = T(0.7) * b13_1 - T(0.1) * b13_2 + T(0.2) * b13_3 - T(0.05) * b13_4 + N13_1;
  const T b13_5 = R13_11 * S14_1 + R13_12 * S14_2 + R13_13 * S14_3;
  const T b13_6 = R13_11 * G13_1 + R13_12 * G13_2 + R13_13 * G13_3;
  const T r_omega13_2 = T(0.1) * b13_5 - T(0.3) * b13_1 + T(0.05) * b13_6 - T(0.1) * b13_3 + N13_2;
  const T r_omega13_3 = T(0.3) * b13_2 - T(0.7) * b13_5 + T(0.1) * b13_4 - T(0.2) * b13_6 + N13_3;
  r[36] = r_omega13_1;
  r[37] = r_omega13_2;
  r[38] = r_omega13_3;

  // ---- body 12 (body_12) and what it carries
  // S12 = G12 + S13: sum of the force balances of the subtree, inertial axes [N]
  const T S12_1 = G12_1 + S13_1;
  const T S12_2 = G12_2 + S13_2;
  const T S12_3 = G12_3 + S13_3;
  // r_omega12 = q13~ R12 S13 + r12~ R12 G12 + N12: Kane's equation of omega [N m]
  const T b12_1 = R12_31 * S13_1 + R12_32 * S13_2 + R12_33 * S13_3;
  const T b12_2 = R12_21 * S13_1 + R12_22 * S13_2 + R12_23 * S13_3;
  const T b12_3 = R12_31 * G12_1 + R12_32 * G12_2 + R12_33 * G12_3;
  const T b12_4 = R12_21 * G12_1 + R12_22 * G12_2 + R12_23 * G12_3;
  const T r_omega12_1 = T(0.65) * b12_1 - T(0.1) * b12_2 + T(0.2) * b12_3 - T(0.05) * b12_4 + N12_1;
  const T b12_5 = R12_11 * S13_1 + R12_12 * S13_2 + R12_13 * S13_3;
  const T b12_6 = R12_11 * G12_1 + R12_12 * G12_2 + R12_13 * G12_3;
  const T r_omega12_2 = T(0.1) * b12_5 - T(0.3) * b12_1 + T(0.05) * b12_6 - T(0.1) * b12_3 + N12_2;
  const T r_omega12_3 = T(0.3) * b12_2 - T(0.65) * b12_5 + T(0.1) * b12_4 - T(0.2) * b12_6 + N12_3;
  r[33] = r_omega12_1;
  r[34] = r_omega12_2;
  r[35] = r_omega12_3;

  // ---- body 11 (body_11) and what it carries
  // S11 = G11 + S12: sum of the force balances of the subtree, inertial axes [N]
  const T S11_1 = G11_1 + S12_1;
  const T S11_2 = G11_2 + S12_2;
  const T S11_3 = G11_3 + S12_3;
  // r_omega11 = q12~ R11 S12 + r11~ R11 G11 + N11: Kane's equation of omega [N m]
  const T b11_1 = R11_31 * S12_1 + R11_32 * S12_2 + R11_33 * S12_3;
  const T b11_2 = R11_21 * S12_1 + R11_22 * S12_2 + R11_23 * S12_3;
  const T b11_3 = R11_31 * G11_1 + R11_32 * G11_2 + R11_33 * G11_3;
  const T b11_4 = R11_21 * G11_1 + R11_22 * G11_2 + R11_23 * G11_3;
  const T r_omega11_1 = T(0.6) * b11_1 - T(0.1) * b11_2 + T(0.2) * b11_3 - T(0.05) * b11_4 + N11_1;
  const T b11_5 = R11_11 * S12_1 + R11_12 * S12_2 + R11_13 * S12_3;
  const T b11_6 = R11_11 * G11_1 + R11_12 * G11_2 + R11_13 * G11_3;
  const T r_omega11_2 = T(0.1) * b11_5 - T(0.3) * b11_1 + T(0.05) * b11_6 - T(0.1) * b11_3 + N11_2;
  const T r_omega11_3 = T(0.3) * b11_2 - T(0.6) * b11_5 + T(0.1) * b11_4 - T(0.2) * b11_6 + N11_3;
  r[30] = r_omega11_1;
  r[31] = r_omega11_2;
  r[32] = r_omega11_3;

  // ---- body 10 (body_10) and what it carries
  // S10 = G10 + S11: sum of the force balances of the subtree, inertial axes [N]
  const T S10_1 = G10_1 + S11_1;
  const T S10_2 = G10_2 + S11_2;
  const T S10_3 = G10_3 + S11_3;
  // r_omega10 = q11~ R10 S11 + r10~ R10 G10 + N10: Kane's equation of omega [N m]
  const T b10_1 = R10_31 * S11_1 + R10_32 * S11_2 + R10_33 * S11_3;
  const T b10_2 = R10_21 * S11_1 + R10_22 * S11_2 + R10_23 * S11_3;
  const T b10_3 = R10_31 * G10_1 + R10_32 * G10_2 + R10_33 * G10_3;
  const T b10_4 = R10_21 * G10_1 + R10_22 * G10_2 + R10_23 * G10_3;
  const T r_omega10_1 = T(0.55) * b10_1 - T(0.1) * b10_2 + T(0.2) * b10_3 - T(0.05) * b10_4 + N10_1;
  const T b10_5 = R10_11 * S11_1 + R10_12 * S11_2 + R10_13 * S11_3;
  const T b10_6 = R10_11 * G10_1 + R10_12 * G10_2 + R10_13 * G10_3;
  const T r_omega10_2 = T(0.1) * b10_5 - T(0.3) * b10_1 + T(0.05) * b10_6 - T(0.1) * b10_3 + N10_2;
  const T r_omega10_3 = T(0.3) * b10_2 - T(0.55) * b10_5 + T(0.1) * b10_4 - T(0.2) * b10_6 + N10_3;
  r[27] = r_omega10_1;
  r[28] = r_omega10_2;
  r[29] = r_omega10_3;

  // ---- body 9 (body_9) and what it carries
  // S9 = G9 + S10: sum of the force balances of the subtree, inertial axes [N]
  const T S9_1 = G9_1 + S10_1;
  const T S9_2 = G9_2 + S10_2;
  const T S9_3 = G9_3 + S10_3;
  // r_omega9 = q10~ R9 S10 + r9~ R9 G9 + N9: Kane's equation of omega [N m]
  const T b9_1 = R9_31 * S10_1 + R9_32 * S10_2 + R9_33 * S10_3;
  const T b9_2 = R9_21 * S10_1 + R9_22 * S10_2 + R9_23 * S10_3;
  const T b9_3 = R9_31 * G9_1 + R9_32 * G9_2 + R9_33 * G9_3;
  const T b9_4 = R9_21 * G9_1 + R9_22 * G9_2 + R9_23 * G9_3;
  const T r_omega9_1 = T(0.5) * b9_1 - T(0.1) * b9_2 + T(0.2) * b9_3 - T(0.05) * b9_4 + N9_1;
  const T b9_5 = R9_11 * S10_1 + R9_12 * S10_2 + R9_13 * S10_3;
  const T b9_6 = R9_11 * G9_1 + R9_12 * G9_2 + R9_13 * G9_3;
  const T r_omega9_2 = T(0.1) * b9_5 - T(0.3) * b9_1 + T(0.05) * b9_6 - T(0.1) * b9_3 + N9_2;
  const T r_omega9_3 = T(0.3) * b9_2 - T(0.5) * b9_5 + T(0.1) * b9_4 - T(0.2) * b9_6 + N9_3;
  r[24] = r_omega9_1;
  r[25] = r_omega9_2;
  r[26] = r_omega9_3;

  // ---- body 8 (body_8) and what it carries
  // S8 = G8 + S9: sum of the force balances of the subtree, inertial axes [N]
  const T S8_1 = G8_1 + S9_1;
  const T S8_2 = G8_2 + S9_2;
  const T S8_3 = G8_3 + S9_3;
  // r_omega8 = q9~ R8 S9 + r8~ R8 G8 + N8: Kane's equation of omega [N m]
  const T b8_1 = R8_31 * S9_1 + R8_32 * S9_2 + R8_33 * S9_3;
  const T b8_2 = R8_21 * S9_1 + R8_22 * S9_2 + R8_23 * S9_3;
  const T b8_3 = R8_31 * G8_1 + R8_32 * G8_2 + R8_33 * G8_3;
  const T b8_4 = R8_21 * G8_1 + R8_22 * G8_2 + R8_23 * G8_3;
  const T r_omega8_1 = T(0.45) * b8_1 - T(0.1) * b8_2 + T(0.2) * b8_3 - T(0.05) * b8_4 + N8_1;
  const T b8_5 = R8_11 * S9_1 + R8_12 * S9_2 + R8_13 * S9_3;
  const T b8_6 = R8_11 * G8_1 + R8_12 * G8_2 + R8_13 * G8_3;
  const T r_omega8_2 = T(0.1) * b8_5 - T(0.3) * b8_1 + T(0.05) * b8_6 - T(0.1) * b8_3 + N8_2;
  const T r_omega8_3 = T(0.3) * b8_2 - T(0.45) * b8_5 + T(0.1) * b8_4 - T(0.2) * b8_6 + N8_3;
  r[21] = r_omega8_1;
  r[22] = r_omega8_2;
  r[23] = r_omega8_3;

  // ---- body 7 (body_7) and what it carries
  // S7 = G7 + S8: sum of the force balances of the subtree, inertial axes [N]
  const T S7_1 = G7_1 + S8_1;
  const T S7_2 = G7_2 + S8_2;
  const T S7_3 = G7_3 + S8_3;
  // r_omega7 = q8~ R7 S8 + r7~ R7 G7 + N7: Kane's equation of omega [N m]
  const T b7_1 = R7_31 * S8_1 + R7_32 * S8_2 + R7_33 * S8_3;
  const T b7_2 = R7_21 * S8_1 + R7_22 * S8_2 + R7_23 * S8_3;
  const T b7_3 = R7_31 * G7_1 + R7_32 * G7_2 + R7_33 * G7_3;
  const T b7_4 = R7_21 * G7_1 + R7_22 * G7_2 + R7_23 * G7_3;
  const T r_omega7_1 = T(0.4) * b7_1 - T(0.1) * b7_2 + T(0.2) * b7_3 - T(0.05) * b7_4 + N7_1;
  const T b7_5 = R7_11 * S8_1 + R7_12 * S8_2 + R7_13 * S8_3;
  const T b7_6 = R7_11 * G7_1 + R7_12 * G7_2 + R7_13 * G7_3;
  const T r_omega7_2 = T(0.1) * b7_5 - T(0.3) * b7_1 + T(0.05) * b7_6 - T(0.1) * b7_3 + N7_2;
  const T r_omega7_3 = T(0.3) * b7_2 - T(0.4) * b7_5 + T(0.1) * b7_4 - T(0.2) * b7_6 + N7_3;
  r[18] = r_omega7_1;
  r[19] = r_omega7_2;
  r[20] = r_omega7_3;

  // ---- body 6 (body_6) and what it carries
  // S6 = G6 + S7: sum of the force balances of the subtree, inertial axes [N]
  const T S6_1 = G6_1 + S7_1;
  const T S6_2 = G6_2 + S7_2;
  const T S6_3 = G6_3 + S7_3;
  // r_omega6 = q7~ R6 S7 + r6~ R6 G6 + N6: Kane's equation of omega [N m]
  const T b6_1 = R6_31 * S7_1 + R6_32 * S7_2 + R6_33 * S7_3;
  const T b6_2 = R6_21 * S7_1 + R6_22 * S7_2 + R6_23 * S7_3;
  const T b6_3 = R6_31 * G6_1 + R6_32 * G6_2 + R6_33 * G6_3;
  const T b6_4 = R6_21 * G6_1 + R6_22 * G6_2 + R6_23 * G6_3;
  const T r_omega6_1 = T(0.35) * b6_1 - T(0.1) * b6_2 + T(0.2) * b6_3 - T(0.05) * b6_4 + N6_1;
  const T b6_5 = R6_11 * S7_1 + R6_12 * S7_2 + R6_13 * S7_3;
  const T b6_6 = R6_11 * G6_1 + R6_12 * G6_2 + R6_13 * G6_3;
  const T r_omega6_2 = T(0.1) * b6_5 - T(0.3) * b6_1 + T(0.05) * b6_6 - T(0.1) * b6_3 + N6_2;
  const T r_omega6_3 = T(0.3) * b6_2 - T(0.35) * b6_5 + T(0.1) * b6_4 - T(0.2) * b6_6 + N6_3;
  r[15] = r_omega6_1;
  r[16] = r_omega6_2;
  r[17] = r_omega6_3;

  // ---- body 5 (body_5) and what it carries
  // S5 = G5 + S6: sum of the force balances of the subtree, inertial axes [N]
  const T S5_1 = G5_1 + S6_1;
  const T S5_2 = G5_2 + S6_2;
  const T S5_3 = G5_3 + S6_3;
  // r_omega5 = q6~ R5 S6 + r5~ R5 G5 + N5: Kane's equation of omega [N m]
  const T b5_1 = T(0.3) * (R5_31 * S6_1 + R5_32 * S6_2 + R5_33 * S6_3);
  const T b5_2 = R5_21 * S6_1 + R5_22 * S6_2 + R5_23 * S6_3;
  const T b5_3 = R5_31 * G5_1 + R5_32 * G5_2 + R5_33 * G5_3;
  const T b5_4 = R5_21 * G5_1 + R5_22 * G5_2 + R5_23 * G5_3;
  const T r_omega5_1 = b5_1 - T(0.1) * b5_2 + T(0.2) * b5_3 - T(0.05) * b5_4 + N5_1;
  const T b5_5 = R5_11 * S6_1 + R5_12 * S6_2 + R5_13 * S6_3;
  const T b5_6 = R5_11 * G5_1 + R5_12 * G5_2 + R5_13 * G5_3;
  const T r_omega5_2 = T(0.1) * b5_5 - b5_1 + T(0.05) * b5_6 - T(0.1) * b5_3 + N5_2;
  const T r_omega5_3 = T(0.3) * b5_2 - T(0.3) * b5_5 + T(0.1) * b5_4 - T(0.2) * b5_6 + N5_3;
  r[12] = r_omega5_1;
  r[13] = r_omega5_2;
  r[14] = r_omega5_3;

  // ---- body 4 (body_4) and what it carries
  // S4 = G4 + S5: sum of the force balances of the subtree, inertial axes [N]
  const T S4_1 = G4_1 + S5_1;
  const T S4_2 = G4_2 + S5_2;
  const T S4_3 = G4_3 + S5_3;
  // r_omega4 = q5~ R4 S5 + r4~ R4 G4 + N4: Kane's equation of omega [N m]
  const T b4_1 = R4_31 * S5_1 + R4_32 * S5_2 + R4_33 * S5_3;
  const T b4_2 = R4_21 * S5_1 + R4_22 * S5_2 + R4_23 * S5_3;
  const T b4_3 = R4_31 * G4_1 + R4_32 * G4_2 + R4_33 * G4_3;
  const T b4_4 = R4_21 * G4_1 + R4_22 * G4_2 + R4_23 * G4_3;
  const T r_omega4_1 = T(0.25) * b4_1 - T(0.1) * b4_2 + T(0.2) * b4_3 - T(0.05) * b4_4 + N4_1;
  const T b4_5 = R4_11 * S5_1 + R4_12 * S5_2 + R4_13 * S5_3;
  const T b4_6 = R4_11 * G4_1 + R4_12 * G4_2 + R4_13 * G4_3;
  const T r_omega4_2 = T(0.1) * b4_5 - T(0.3) * b4_1 + T(0.05) * b4_6 - T(0.1) * b4_3 + N4_2;
  const T r_omega4_3 = T(0.3) * b4_2 - T(0.25) * b4_5 + T(0.1) * b4_4 - T(0.2) * b4_6 + N4_3;
  r[9] = r_omega4_1;
  r[10] = r_omega4_2;
  r[11] = r_omega4_3;

  // ---- body 3 (body_3) and what it carries
  // S3 = G3 + S4: sum of the force balances of the subtree, inertial axes [N]
  const T S3_1 = G3_1 + S4_1;
  const T S3_2 = G3_2 + S4_2;
  const T S3_3 = G3_3 + S4_3;
  // r_omega3 = q4~ R3 S4 + r3~ R3 G3 + N3: Kane's equation of omega [N m]
  const T b3_1 = R3_31 * S4_1 + R3_32 * S4_2 + R3_33 * S4_3;
  const T b3_2 = R3_21 * S4_1 + R3_22 * S4_2 + R3_23 * S4_3;
  const T b3_3 = R3_31 * G3_1 + R3_32 * G3_2 + R3_33 * G3_3;
  const T b3_4 = R3_21 * G3_1 + R3_22 * G3_2 + R3_23 * G3_3;
  const T r_omega3_1 = T(0.2) * b3_1 - T(0.1) * b3_2 + T(0.2) * b3_3 - T(0.05) * b3_4 + N3_1;
  const T b3_5 = R3_11 * S4_1 + R3_12 * S4_2 + R3_13 * S4_3;
  const T b3_6 = R3_11 * G3_1 + R3_12 * G3_2 + R3_13 * G3_3;
  const T r_omega3_2 = T(0.1) * b3_5 - T(0.3) * b3_1 + T(0.05) * b3_6 - T(0.1) * b3_3 + N3_2;
  const T r_omega3_3 = T(0.3) * b3_2 - T(0.2) * b3_5 + T(0.1) * b3_4 - T(0.2) * b3_6 + N3_3;
  r[6] = r_omega3_1;
  r[7] = r_omega3_2;
  r[8] = r_omega3_3;

  // ---- body 2 (body_2) and what it carries
  // S2 = G2 + S3: sum of the force balances of the subtree, inertial axes [N]
  const T S2_1 = G2_1 + S3_1;
  const T S2_2 = G2_2 + S3_2;
  const T S2_3 = G2_3 + S3_3;
  // r_omega2 = q3~ R2 S3 + r2~ R2 G2 + N2: Kane's equation of omega [N m]
  const T b2_1 = R2_31 * S3_1 + R2_32 * S3_2 + R2_33 * S3_3;
  const T b2_2 = R2_21 * S3_1 + R2_22 * S3_2 + R2_23 * S3_3;
  const T b2_3 = R2_31 * G2_1 + R2_32 * G2_2 + R2_33 * G2_3;
  const T b2_4 = R2_21 * G2_1 + R2_22 * G2_2 + R2_23 * G2_3;
  const T r_omega2_1 = T(0.15) * b2_1 - T(0.1) * b2_2 + T(0.2) * b2_3 - T(0.05) * b2_4 + N2_1;
  const T b2_5 = R2_11 * S3_1 + R2_12 * S3_2 + R2_13 * S3_3;
  const T b2_6 = R2_11 * G2_1 + R2_12 * G2_2 + R2_13 * G2_3;
  const T r_omega2_2 = T(0.1) * b2_5 - T(0.3) * b2_1 + T(0.05) * b2_6 - T(0.1) * b2_3 + N2_2;
  const T r_omega2_3 = T(0.3) * b2_2 - T(0.15) * b2_5 + T(0.1) * b2_4 - T(0.2) * b2_6 + N2_3;
  r[3] = r_omega2_1;
  r[4] = r_omega2_2;
  r[5] = r_omega2_3;

  // ---- body 1 (body_1) and what it carries
  // r_omega1 = q2~ R1 S2 + r1~ R1 G1 + N1: Kane's equation of omega [N m]
  const T b1_1 = R1_31 * S2_1 + R1_32 * S2_2 + R1_33 * S2_3;
  const T b1_2 = R1_21 * S2_1 + R1_22 * S2_2 + R1_23 * S2_3;
  const T b1_3 = R1_31 * G1_1 + R1_32 * G1_2 + R1_33 * G1_3;
  const T b1_4 = R1_21 * G1_1 + R1_22 * G1_2 + R1_23 * G1_3;
  const T r_omega1_1 = T(0.1) * b1_1 - T(0.1) * b1_2 + T(0.2) * b1_3 - T(0.05) * b1_4 + N1_1;
  const T b1_5 = T(0.1) * (R1_11 * S2_1 + R1_12 * S2_2 + R1_13 * S2_3);
  const T b1_6 = R1_11 * G1_1 + R1_12 * G1_2 + R1_13 * G1_3;
  const T r_omega1_2 = b1_5 - T(0.3) * b1_1 + T(0.05) * b1_6 - T(0.1) * b1_3 + N1_2;
  const T r_omega1_3 = T(0.3) * b1_2 - b1_5 + T(0.1) * b1_4 - T(0.2) * b1_6 + N1_3;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
}

}  // namespace kanec::bench_cb32
