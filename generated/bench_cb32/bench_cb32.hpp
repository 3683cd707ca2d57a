// SPDX-License-Identifier: BSD-3-Clause
// bench_cb32: equations of motion of 32 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 72007fc3d010fdf5 of bench_cb32/scene.toml; functions kinematics energy accelerations residual
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
//   accelerations           14856 (6802 add, 7961 multiply, 93 divide)
//   residual                6482 (3165 add, 3317 multiply)
//
// functions written as loops over bodies; bytes in double, estimated:
//   accelerations: 96 sections of 25 kinds; 49368 of code, 16800 of stack
//     as a straight line: 133704 of code, 6056 of stack
#pragma once

namespace kanec::bench_cb32 {

inline constexpr int n_bodies = 32;
inline constexpr int nx = 128;
inline constexpr int ny = 96;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 96;
inline constexpr char model_hash[] = "72007fc3d010fdf5";

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
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
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
  const T t6_19 = omega6_2 * T(0.1);
  const T t6_20 = omega6_1 * T(0.2) - t6_19;
  const T v6_1 = Pdot6_1 + R6_11 * t6_17 + R6_21 * t6_18 + R6_31 * t6_20;
  const T v6_2 = Pdot6_2 + R6_12 * t6_17 + R6_22 * t6_18 + R6_32 * t6_20;
  const T v6_3 = Pdot6_3 + R6_13 * t6_17 + R6_23 * t6_18 + R6_33 * t6_20;
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
  const T P7_3 = P6_3 + R6_13 * T(0.3) + R6_23 * T(0.35) + R6_33 * T(0.1);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_3 = P7_3 + R7_13 * T(0.1) + R7_23 * T(0.2) + R7_33 * T(0.05);
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_13 = t6_19 - omega6_3 * T(0.35);
  const T t7_14 = omega6_3 * T(0.3) - omega6_1 * T(0.1);
  const T t7_15 = omega6_1 * T(0.35) - omega6_2 * T(0.3);
  const T Pdot7_1 = Pdot6_1 + R6_11 * t7_13 + R6_21 * t7_14 + R6_31 * t7_15;
  const T Pdot7_2 = Pdot6_2 + R6_12 * t7_13 + R6_22 * t7_14 + R6_32 * t7_15;
  const T Pdot7_3 = Pdot6_3 + R6_13 * t7_13 + R6_23 * t7_14 + R6_33 * t7_15;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_16 = omega7_2 * T(0.05) - omega7_3 * T(0.2);
  const T t7_17 = omega7_3 * T(0.1) - omega7_1 * T(0.05);
  const T t7_18 = omega7_2 * T(0.1);
  const T t7_19 = omega7_1 * T(0.2) - t7_18;
  const T v7_1 = Pdot7_1 + R7_11 * t7_16 + R7_21 * t7_17 + R7_31 * t7_19;
  const T v7_2 = Pdot7_2 + R7_12 * t7_16 + R7_22 * t7_17 + R7_32 * t7_19;
  const T v7_3 = Pdot7_3 + R7_13 * t7_16 + R7_23 * t7_17 + R7_33 * t7_19;
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
  const T P8_3 = P7_3 + R7_13 * T(0.3) + R7_23 * T(0.4) + R7_33 * T(0.1);
  // p8 = R8^T r8 + P8: position of the mass centre, inertial axes [m]
  const T p8_3 = P8_3 + R8_13 * T(0.1) + R8_23 * T(0.2) + R8_33 * T(0.05);
  // Pdot8 = R7^T omega7~ q8 + Pdot7: velocity of the body origin, inertial axes [m/s]
  const T t8_13 = t7_18 - omega7_3 * T(0.4);
  const T t8_14 = omega7_3 * T(0.3) - omega7_1 * T(0.1);
  const T t8_15 = omega7_1 * T(0.4) - omega7_2 * T(0.3);
  const T Pdot8_1 = Pdot7_1 + R7_11 * t8_13 + R7_21 * t8_14 + R7_31 * t8_15;
  const T Pdot8_2 = Pdot7_2 + R7_12 * t8_13 + R7_22 * t8_14 + R7_32 * t8_15;
  const T Pdot8_3 = Pdot7_3 + R7_13 * t8_13 + R7_23 * t8_14 + R7_33 * t8_15;
  // v8 = R8^T omega8~ r8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_16 = omega8_2 * T(0.05) - omega8_3 * T(0.2);
  const T t8_17 = omega8_3 * T(0.1) - omega8_1 * T(0.05);
  const T t8_18 = omega8_2 * T(0.1);
  const T t8_19 = omega8_1 * T(0.2) - t8_18;
  const T v8_1 = Pdot8_1 + R8_11 * t8_16 + R8_21 * t8_17 + R8_31 * t8_19;
  const T v8_2 = Pdot8_2 + R8_12 * t8_16 + R8_22 * t8_17 + R8_32 * t8_19;
  const T v8_3 = Pdot8_3 + R8_13 * t8_16 + R8_23 * t8_17 + R8_33 * t8_19;
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
  const T P9_3 = P8_3 + R8_13 * T(0.3) + R8_23 * T(0.45) + R8_33 * T(0.1);
  // p9 = R9^T r9 + P9: position of the mass centre, inertial axes [m]
  const T p9_3 = P9_3 + R9_13 * T(0.1) + R9_23 * T(0.2) + R9_33 * T(0.05);
  // Pdot9 = R8^T omega8~ q9 + Pdot8: velocity of the body origin, inertial axes [m/s]
  const T t9_13 = t8_18 - omega8_3 * T(0.45);
  const T t9_14 = omega8_3 * T(0.3) - omega8_1 * T(0.1);
  const T t9_15 = omega8_1 * T(0.45) - omega8_2 * T(0.3);
  const T Pdot9_1 = Pdot8_1 + R8_11 * t9_13 + R8_21 * t9_14 + R8_31 * t9_15;
  const T Pdot9_2 = Pdot8_2 + R8_12 * t9_13 + R8_22 * t9_14 + R8_32 * t9_15;
  const T Pdot9_3 = Pdot8_3 + R8_13 * t9_13 + R8_23 * t9_14 + R8_33 * t9_15;
  // v9 = R9^T omega9~ r9 + Pdot9: velocity of the mass centre, inertial axes [m/s]
  const T t9_16 = omega9_2 * T(0.05) - omega9_3 * T(0.2);
  const T t9_17 = omega9_3 * T(0.1) - omega9_1 * T(0.05);
  const T t9_18 = omega9_2 * T(0.1);
  const T t9_19 = omega9_1 * T(0.2) - t9_18;
  const T v9_1 = Pdot9_1 + R9_11 * t9_16 + R9_21 * t9_17 + R9_31 * t9_19;
  const T v9_2 = Pdot9_2 + R9_12 * t9_16 + R9_22 * t9_17 + R9_32 * t9_19;
  const T v9_3 = Pdot9_3 + R9_13 * t9_16 + R9_23 * t9_17 + R9_33 * t9_19;
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
  const T P10_3 = P9_3 + R9_13 * T(0.3) + R9_23 * T(0.5) + R9_33 * T(0.1);
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_3 = P10_3 + R10_13 * T(0.1) + R10_23 * T(0.2) + R10_33 * T(0.05);
  // Pdot10 = R9^T omega9~ q10 + Pdot9: velocity of the body origin, inertial axes [m/s]
  const T t10_13 = t9_18 - T(0.5) * omega9_3;
  const T t10_14 = omega9_3 * T(0.3) - omega9_1 * T(0.1);
  const T t10_15 = T(0.5) * omega9_1 - omega9_2 * T(0.3);
  const T Pdot10_1 = Pdot9_1 + R9_11 * t10_13 + R9_21 * t10_14 + R9_31 * t10_15;
  const T Pdot10_2 = Pdot9_2 + R9_12 * t10_13 + R9_22 * t10_14 + R9_32 * t10_15;
  const T Pdot10_3 = Pdot9_3 + R9_13 * t10_13 + R9_23 * t10_14 + R9_33 * t10_15;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_16 = omega10_2 * T(0.05) - omega10_3 * T(0.2);
  const T t10_17 = omega10_3 * T(0.1) - omega10_1 * T(0.05);
  const T t10_18 = T(0.2) * omega10_1;
  const T t10_19 = omega10_2 * T(0.1);
  const T t10_20 = t10_18 - t10_19;
  const T v10_1 = Pdot10_1 + R10_11 * t10_16 + R10_21 * t10_17 + R10_31 * t10_20;
  const T v10_2 = Pdot10_2 + R10_12 * t10_16 + R10_22 * t10_17 + R10_32 * t10_20;
  const T v10_3 = Pdot10_3 + R10_13 * t10_16 + R10_23 * t10_17 + R10_33 * t10_20;
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
  const T P11_3 = P10_3 + R10_13 * T(0.3) + R10_23 * T(0.55) + R10_33 * T(0.1);
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T p11_3 = P11_3 + R11_13 * T(0.1) + R11_23 * T(0.2) + R11_33 * T(0.05);
  // Pdot11 = R10^T omega10~ q11 + Pdot10: velocity of the body origin, inertial axes [m/s]
  const T t11_13 = t10_19 - omega10_3 * T(0.55);
  const T t11_14 = omega10_3 * T(0.3) - omega10_1 * T(0.1);
  const T t11_15 = omega10_1 * T(0.55) - omega10_2 * T(0.3);
  const T Pdot11_1 = Pdot10_1 + R10_11 * t11_13 + R10_21 * t11_14 + R10_31 * t11_15;
  const T Pdot11_2 = Pdot10_2 + R10_12 * t11_13 + R10_22 * t11_14 + R10_32 * t11_15;
  const T Pdot11_3 = Pdot10_3 + R10_13 * t11_13 + R10_23 * t11_14 + R10_33 * t11_15;
  // v11 = R11^T omega11~ r11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_16 = omega11_2 * T(0.05) - omega11_3 * T(0.2);
  const T t11_17 = omega11_3 * T(0.1) - omega11_1 * T(0.05);
  const T t11_18 = omega11_2 * T(0.1);
  const T t11_19 = omega11_1 * T(0.2) - t11_18;
  const T v11_1 = Pdot11_1 + R11_11 * t11_16 + R11_21 * t11_17 + R11_31 * t11_19;
  const T v11_2 = Pdot11_2 + R11_12 * t11_16 + R11_22 * t11_17 + R11_32 * t11_19;
  const T v11_3 = Pdot11_3 + R11_13 * t11_16 + R11_23 * t11_17 + R11_33 * t11_19;
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
  const T P12_3 = P11_3 + R11_13 * T(0.3) + R11_23 * T(0.6) + R11_33 * T(0.1);
  // p12 = R12^T r12 + P12: position of the mass centre, inertial axes [m]
  const T p12_3 = P12_3 + R12_13 * T(0.1) + R12_23 * T(0.2) + R12_33 * T(0.05);
  // Pdot12 = R11^T omega11~ q12 + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_13 = t11_18 - omega11_3 * T(0.6);
  const T t12_14 = omega11_3 * T(0.3) - omega11_1 * T(0.1);
  const T t12_15 = omega11_1 * T(0.6) - omega11_2 * T(0.3);
  const T Pdot12_1 = Pdot11_1 + R11_11 * t12_13 + R11_21 * t12_14 + R11_31 * t12_15;
  const T Pdot12_2 = Pdot11_2 + R11_12 * t12_13 + R11_22 * t12_14 + R11_32 * t12_15;
  const T Pdot12_3 = Pdot11_3 + R11_13 * t12_13 + R11_23 * t12_14 + R11_33 * t12_15;
  // v12 = R12^T omega12~ r12 + Pdot12: velocity of the mass centre, inertial axes [m/s]
  const T t12_16 = omega12_2 * T(0.05) - omega12_3 * T(0.2);
  const T t12_17 = omega12_3 * T(0.1) - omega12_1 * T(0.05);
  const T t12_18 = omega12_2 * T(0.1);
  const T t12_19 = omega12_1 * T(0.2) - t12_18;
  const T v12_1 = Pdot12_1 + R12_11 * t12_16 + R12_21 * t12_17 + R12_31 * t12_19;
  const T v12_2 = Pdot12_2 + R12_12 * t12_16 + R12_22 * t12_17 + R12_32 * t12_19;
  const T v12_3 = Pdot12_3 + R12_13 * t12_16 + R12_23 * t12_17 + R12_33 * t12_19;
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
  const T P13_3 = P12_3 + R12_13 * T(0.3) + R12_23 * T(0.65) + R12_33 * T(0.1);
  // p13 = R13^T r13 + P13: position of the mass centre, inertial axes [m]
  const T p13_3 = P13_3 + R13_13 * T(0.1) + R13_23 * T(0.2) + R13_33 * T(0.05);
  // Pdot13 = R12^T omega12~ q13 + Pdot12: velocity of the body origin, inertial axes [m/s]
  const T t13_13 = t12_18 - omega12_3 * T(0.65);
  const T t13_14 = omega12_3 * T(0.3) - omega12_1 * T(0.1);
  const T t13_15 = omega12_1 * T(0.65) - omega12_2 * T(0.3);
  const T Pdot13_1 = Pdot12_1 + R12_11 * t13_13 + R12_21 * t13_14 + R12_31 * t13_15;
  const T Pdot13_2 = Pdot12_2 + R12_12 * t13_13 + R12_22 * t13_14 + R12_32 * t13_15;
  const T Pdot13_3 = Pdot12_3 + R12_13 * t13_13 + R12_23 * t13_14 + R12_33 * t13_15;
  // v13 = R13^T omega13~ r13 + Pdot13: velocity of the mass centre, inertial axes [m/s]
  const T t13_16 = omega13_2 * T(0.05) - omega13_3 * T(0.2);
  const T t13_17 = omega13_3 * T(0.1) - omega13_1 * T(0.05);
  const T t13_18 = omega13_2 * T(0.1);
  const T t13_19 = omega13_1 * T(0.2) - t13_18;
  const T v13_1 = Pdot13_1 + R13_11 * t13_16 + R13_21 * t13_17 + R13_31 * t13_19;
  const T v13_2 = Pdot13_2 + R13_12 * t13_16 + R13_22 * t13_17 + R13_32 * t13_19;
  const T v13_3 = Pdot13_3 + R13_13 * t13_16 + R13_23 * t13_17 + R13_33 * t13_19;
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
  const T P14_3 = P13_3 + R13_13 * T(0.3) + R13_23 * T(0.7) + R13_33 * T(0.1);
  // p14 = R14^T r14 + P14: position of the mass centre, inertial axes [m]
  const T p14_3 = P14_3 + R14_13 * T(0.1) + R14_23 * T(0.2) + R14_33 * T(0.05);
  // Pdot14 = R13^T omega13~ q14 + Pdot13: velocity of the body origin, inertial axes [m/s]
  const T t14_13 = t13_18 - omega13_3 * T(0.7);
  const T t14_14 = omega13_3 * T(0.3) - omega13_1 * T(0.1);
  const T t14_15 = omega13_1 * T(0.7) - omega13_2 * T(0.3);
  const T Pdot14_1 = Pdot13_1 + R13_11 * t14_13 + R13_21 * t14_14 + R13_31 * t14_15;
  const T Pdot14_2 = Pdot13_2 + R13_12 * t14_13 + R13_22 * t14_14 + R13_32 * t14_15;
  const T Pdot14_3 = Pdot13_3 + R13_13 * t14_13 + R13_23 * t14_14 + R13_33 * t14_15;
  // v14 = R14^T omega14~ r14 + Pdot14: velocity of the mass centre, inertial axes [m/s]
  const T t14_16 = omega14_2 * T(0.05) - omega14_3 * T(0.2);
  const T t14_17 = omega14_3 * T(0.1) - omega14_1 * T(0.05);
  const T t14_18 = omega14_2 * T(0.1);
  const T t14_19 = omega14_1 * T(0.2) - t14_18;
  const T v14_1 = Pdot14_1 + R14_11 * t14_16 + R14_21 * t14_17 + R14_31 * t14_19;
  const T v14_2 = Pdot14_2 + R14_12 * t14_16 + R14_22 * t14_17 + R14_32 * t14_19;
  const T v14_3 = Pdot14_3 + R14_13 * t14_16 + R14_23 * t14_17 + R14_33 * t14_19;
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
  const T P15_3 = P14_3 + R14_13 * T(0.3) + R14_23 * T(0.75) + R14_33 * T(0.1);
  // p15 = R15^T r15 + P15: position of the mass centre, inertial axes [m]
  const T p15_3 = P15_3 + R15_13 * T(0.1) + R15_23 * T(0.2) + R15_33 * T(0.05);
  // Pdot15 = R14^T omega14~ q15 + Pdot14: velocity of the body origin, inertial axes [m/s]
  const T t15_13 = t14_18 - omega14_3 * T(0.75);
  const T t15_14 = omega14_3 * T(0.3) - omega14_1 * T(0.1);
  const T t15_15 = omega14_1 * T(0.75) - omega14_2 * T(0.3);
  const T Pdot15_1 = Pdot14_1 + R14_11 * t15_13 + R14_21 * t15_14 + R14_31 * t15_15;
  const T Pdot15_2 = Pdot14_2 + R14_12 * t15_13 + R14_22 * t15_14 + R14_32 * t15_15;
  const T Pdot15_3 = Pdot14_3 + R14_13 * t15_13 + R14_23 * t15_14 + R14_33 * t15_15;
  // v15 = R15^T omega15~ r15 + Pdot15: velocity of the mass centre, inertial axes [m/s]
  const T t15_16 = T(0.2) * omega15_3;
  const T t15_17 = omega15_2 * T(0.05) - t15_16;
  const T t15_18 = omega15_3 * T(0.1) - omega15_1 * T(0.05);
  const T t15_19 = omega15_2 * T(0.1);
  const T t15_20 = omega15_1 * T(0.2) - t15_19;
  const T v15_1 = Pdot15_1 + R15_11 * t15_17 + R15_21 * t15_18 + R15_31 * t15_20;
  const T v15_2 = Pdot15_2 + R15_12 * t15_17 + R15_22 * t15_18 + R15_32 * t15_20;
  const T v15_3 = Pdot15_3 + R15_13 * t15_17 + R15_23 * t15_18 + R15_33 * t15_20;
  // T15 = 1/2 omega15 . (I15 omega15) + 1/2 m15 v15 . v15: kinetic energy [J]
  const T t15_21 = T(0.3) * omega15_2;
  const T T15 = T(0.5) * (omega15_1 * (T(0.25) * omega15_1 + T(0.0125) * omega15_2 + T(0.0075) * omega15_3) +
      omega15_2 * (T(0.0125) * omega15_1 + t15_21 - T(0.01) * omega15_3) + omega15_3 * (t15_16 + T(0.0075) * omega15_1
      - T(0.01) * omega15_2)) + T(1.25) * (v15_1 * v15_1 + v15_2 * v15_2 + v15_3 * v15_3);

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
  const T P16_3 = P15_3 + R15_13 * T(0.3) + R15_23 * T(0.8) + R15_33 * T(0.1);
  // p16 = R16^T r16 + P16: position of the mass centre, inertial axes [m]
  const T p16_3 = P16_3 + R16_13 * T(0.1) + R16_23 * T(0.2) + R16_33 * T(0.05);
  // Pdot16 = R15^T omega15~ q16 + Pdot15: velocity of the body origin, inertial axes [m/s]
  const T t16_13 = t15_19 - omega15_3 * T(0.8);
  const T t16_14 = omega15_3 * T(0.3) - omega15_1 * T(0.1);
  const T t16_15 = omega15_1 * T(0.8) - t15_21;
  const T Pdot16_1 = Pdot15_1 + R15_11 * t16_13 + R15_21 * t16_14 + R15_31 * t16_15;
  const T Pdot16_2 = Pdot15_2 + R15_12 * t16_13 + R15_22 * t16_14 + R15_32 * t16_15;
  const T Pdot16_3 = Pdot15_3 + R15_13 * t16_13 + R15_23 * t16_14 + R15_33 * t16_15;
  // v16 = R16^T omega16~ r16 + Pdot16: velocity of the mass centre, inertial axes [m/s]
  const T t16_16 = omega16_2 * T(0.05) - omega16_3 * T(0.2);
  const T t16_17 = omega16_3 * T(0.1) - omega16_1 * T(0.05);
  const T t16_18 = omega16_2 * T(0.1);
  const T t16_19 = omega16_1 * T(0.2) - t16_18;
  const T v16_1 = Pdot16_1 + R16_11 * t16_16 + R16_21 * t16_17 + R16_31 * t16_19;
  const T v16_2 = Pdot16_2 + R16_12 * t16_16 + R16_22 * t16_17 + R16_32 * t16_19;
  const T v16_3 = Pdot16_3 + R16_13 * t16_16 + R16_23 * t16_17 + R16_33 * t16_19;
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
  const T P17_3 = P16_3 + R16_13 * T(0.3) + R16_23 * T(0.85) + R16_33 * T(0.1);
  // p17 = R17^T r17 + P17: position of the mass centre, inertial axes [m]
  const T p17_3 = P17_3 + R17_13 * T(0.1) + R17_23 * T(0.2) + R17_33 * T(0.05);
  // Pdot17 = R16^T omega16~ q17 + Pdot16: velocity of the body origin, inertial axes [m/s]
  const T t17_13 = t16_18 - omega16_3 * T(0.85);
  const T t17_14 = omega16_3 * T(0.3) - omega16_1 * T(0.1);
  const T t17_15 = omega16_1 * T(0.85) - omega16_2 * T(0.3);
  const T Pdot17_1 = Pdot16_1 + R16_11 * t17_13 + R16_21 * t17_14 + R16_31 * t17_15;
  const T Pdot17_2 = Pdot16_2 + R16_12 * t17_13 + R16_22 * t17_14 + R16_32 * t17_15;
  const T Pdot17_3 = Pdot16_3 + R16_13 * t17_13 + R16_23 * t17_14 + R16_33 * t17_15;
  // v17 = R17^T omega17~ r17 + Pdot17: velocity of the mass centre, inertial axes [m/s]
  const T t17_16 = omega17_2 * T(0.05) - omega17_3 * T(0.2);
  const T t17_17 = omega17_3 * T(0.1) - omega17_1 * T(0.05);
  const T t17_18 = omega17_2 * T(0.1);
  const T t17_19 = omega17_1 * T(0.2) - t17_18;
  const T v17_1 = Pdot17_1 + R17_11 * t17_16 + R17_21 * t17_17 + R17_31 * t17_19;
  const T v17_2 = Pdot17_2 + R17_12 * t17_16 + R17_22 * t17_17 + R17_32 * t17_19;
  const T v17_3 = Pdot17_3 + R17_13 * t17_16 + R17_23 * t17_17 + R17_33 * t17_19;
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
  const T P18_3 = P17_3 + R17_13 * T(0.3) + R17_23 * T(0.9) + R17_33 * T(0.1);
  // p18 = R18^T r18 + P18: position of the mass centre, inertial axes [m]
  const T p18_3 = P18_3 + R18_13 * T(0.1) + R18_23 * T(0.2) + R18_33 * T(0.05);
  // Pdot18 = R17^T omega17~ q18 + Pdot17: velocity of the body origin, inertial axes [m/s]
  const T t18_13 = t17_18 - omega17_3 * T(0.9);
  const T t18_14 = omega17_3 * T(0.3) - omega17_1 * T(0.1);
  const T t18_15 = omega17_1 * T(0.9) - omega17_2 * T(0.3);
  const T Pdot18_1 = Pdot17_1 + R17_11 * t18_13 + R17_21 * t18_14 + R17_31 * t18_15;
  const T Pdot18_2 = Pdot17_2 + R17_12 * t18_13 + R17_22 * t18_14 + R17_32 * t18_15;
  const T Pdot18_3 = Pdot17_3 + R17_13 * t18_13 + R17_23 * t18_14 + R17_33 * t18_15;
  // v18 = R18^T omega18~ r18 + Pdot18: velocity of the mass centre, inertial axes [m/s]
  const T t18_16 = omega18_2 * T(0.05) - omega18_3 * T(0.2);
  const T t18_17 = omega18_3 * T(0.1) - omega18_1 * T(0.05);
  const T t18_18 = omega18_2 * T(0.1);
  const T t18_19 = omega18_1 * T(0.2) - t18_18;
  const T v18_1 = Pdot18_1 + R18_11 * t18_16 + R18_21 * t18_17 + R18_31 * t18_19;
  const T v18_2 = Pdot18_2 + R18_12 * t18_16 + R18_22 * t18_17 + R18_32 * t18_19;
  const T v18_3 = Pdot18_3 + R18_13 * t18_16 + R18_23 * t18_17 + R18_33 * t18_19;
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
  const T P19_3 = P18_3 + R18_13 * T(0.3) + R18_23 * T(0.95) + R18_33 * T(0.1);
  // p19 = R19^T r19 + P19: position of the mass centre, inertial axes [m]
  const T p19_3 = P19_3 + R19_13 * T(0.1) + R19_23 * T(0.2) + R19_33 * T(0.05);
  // Pdot19 = R18^T omega18~ q19 + Pdot18: velocity of the body origin, inertial axes [m/s]
  const T t19_13 = t18_18 - omega18_3 * T(0.95);
  const T t19_14 = omega18_3 * T(0.3) - omega18_1 * T(0.1);
  const T t19_15 = omega18_1 * T(0.95) - omega18_2 * T(0.3);
  const T Pdot19_1 = Pdot18_1 + R18_11 * t19_13 + R18_21 * t19_14 + R18_31 * t19_15;
  const T Pdot19_2 = Pdot18_2 + R18_12 * t19_13 + R18_22 * t19_14 + R18_32 * t19_15;
  const T Pdot19_3 = Pdot18_3 + R18_13 * t19_13 + R18_23 * t19_14 + R18_33 * t19_15;
  // v19 = R19^T omega19~ r19 + Pdot19: velocity of the mass centre, inertial axes [m/s]
  const T t19_16 = omega19_2 * T(0.05) - omega19_3 * T(0.2);
  const T t19_17 = omega19_3 * T(0.1) - omega19_1 * T(0.05);
  const T t19_18 = omega19_2 * T(0.1);
  const T t19_19 = omega19_1 * T(0.2) - t19_18;
  const T v19_1 = Pdot19_1 + R19_11 * t19_16 + R19_21 * t19_17 + R19_31 * t19_19;
  const T v19_2 = Pdot19_2 + R19_12 * t19_16 + R19_22 * t19_17 + R19_32 * t19_19;
  const T v19_3 = Pdot19_3 + R19_13 * t19_16 + R19_23 * t19_17 + R19_33 * t19_19;
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
  const T P20_3 = R19_23 + P19_3 + R19_13 * T(0.3) + R19_33 * T(0.1);
  // p20 = R20^T r20 + P20: position of the mass centre, inertial axes [m]
  const T p20_3 = P20_3 + R20_13 * T(0.1) + R20_23 * T(0.2) + R20_33 * T(0.05);
  // Pdot20 = R19^T omega19~ q20 + Pdot19: velocity of the body origin, inertial axes [m/s]
  const T t20_13 = t19_18 - omega19_3;
  const T t20_14 = omega19_3 * T(0.3) - omega19_1 * T(0.1);
  const T t20_15 = omega19_1 - omega19_2 * T(0.3);
  const T Pdot20_1 = Pdot19_1 + R19_11 * t20_13 + R19_21 * t20_14 + R19_31 * t20_15;
  const T Pdot20_2 = Pdot19_2 + R19_12 * t20_13 + R19_22 * t20_14 + R19_32 * t20_15;
  const T Pdot20_3 = Pdot19_3 + R19_13 * t20_13 + R19_23 * t20_14 + R19_33 * t20_15;
  // v20 = R20^T omega20~ r20 + Pdot20: velocity of the mass centre, inertial axes [m/s]
  const T t20_16 = omega20_2 * T(0.05) - omega20_3 * T(0.2);
  const T t20_17 = omega20_3 * T(0.1) - omega20_1 * T(0.05);
  const T t20_18 = omega20_2 * T(0.1);
  const T t20_19 = omega20_1 * T(0.2) - t20_18;
  const T v20_1 = Pdot20_1 + R20_11 * t20_16 + R20_21 * t20_17 + R20_31 * t20_19;
  const T v20_2 = Pdot20_2 + R20_12 * t20_16 + R20_22 * t20_17 + R20_32 * t20_19;
  const T v20_3 = Pdot20_3 + R20_13 * t20_16 + R20_23 * t20_17 + R20_33 * t20_19;
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
  const T P21_3 = P20_3 + R20_13 * T(0.3) + R20_23 * T(1.05) + R20_33 * T(0.1);
  // p21 = R21^T r21 + P21: position of the mass centre, inertial axes [m]
  const T p21_3 = P21_3 + R21_13 * T(0.1) + R21_23 * T(0.2) + R21_33 * T(0.05);
  // Pdot21 = R20^T omega20~ q21 + Pdot20: velocity of the body origin, inertial axes [m/s]
  const T t21_13 = t20_18 - omega20_3 * T(1.05);
  const T t21_14 = omega20_3 * T(0.3) - omega20_1 * T(0.1);
  const T t21_15 = omega20_1 * T(1.05) - omega20_2 * T(0.3);
  const T Pdot21_1 = Pdot20_1 + R20_11 * t21_13 + R20_21 * t21_14 + R20_31 * t21_15;
  const T Pdot21_2 = Pdot20_2 + R20_12 * t21_13 + R20_22 * t21_14 + R20_32 * t21_15;
  const T Pdot21_3 = Pdot20_3 + R20_13 * t21_13 + R20_23 * t21_14 + R20_33 * t21_15;
  // v21 = R21^T omega21~ r21 + Pdot21: velocity of the mass centre, inertial axes [m/s]
  const T t21_16 = omega21_2 * T(0.05) - omega21_3 * T(0.2);
  const T t21_17 = omega21_3 * T(0.1) - omega21_1 * T(0.05);
  const T t21_18 = omega21_2 * T(0.1);
  const T t21_19 = omega21_1 * T(0.2) - t21_18;
  const T v21_1 = Pdot21_1 + R21_11 * t21_16 + R21_21 * t21_17 + R21_31 * t21_19;
  const T v21_2 = Pdot21_2 + R21_12 * t21_16 + R21_22 * t21_17 + R21_32 * t21_19;
  const T v21_3 = Pdot21_3 + R21_13 * t21_16 + R21_23 * t21_17 + R21_33 * t21_19;
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
  const T P22_3 = P21_3 + R21_13 * T(0.3) + R21_23 * T(1.1) + R21_33 * T(0.1);
  // p22 = R22^T r22 + P22: position of the mass centre, inertial axes [m]
  const T p22_3 = P22_3 + R22_13 * T(0.1) + R22_23 * T(0.2) + R22_33 * T(0.05);
  // Pdot22 = R21^T omega21~ q22 + Pdot21: velocity of the body origin, inertial axes [m/s]
  const T t22_13 = t21_18 - omega21_3 * T(1.1);
  const T t22_14 = omega21_3 * T(0.3) - omega21_1 * T(0.1);
  const T t22_15 = omega21_1 * T(1.1) - omega21_2 * T(0.3);
  const T Pdot22_1 = Pdot21_1 + R21_11 * t22_13 + R21_21 * t22_14 + R21_31 * t22_15;
  const T Pdot22_2 = Pdot21_2 + R21_12 * t22_13 + R21_22 * t22_14 + R21_32 * t22_15;
  const T Pdot22_3 = Pdot21_3 + R21_13 * t22_13 + R21_23 * t22_14 + R21_33 * t22_15;
  // v22 = R22^T omega22~ r22 + Pdot22: velocity of the mass centre, inertial axes [m/s]
  const T t22_16 = omega22_2 * T(0.05) - omega22_3 * T(0.2);
  const T t22_17 = omega22_3 * T(0.1) - omega22_1 * T(0.05);
  const T t22_18 = omega22_2 * T(0.1);
  const T t22_19 = omega22_1 * T(0.2) - t22_18;
  const T v22_1 = Pdot22_1 + R22_11 * t22_16 + R22_21 * t22_17 + R22_31 * t22_19;
  const T v22_2 = Pdot22_2 + R22_12 * t22_16 + R22_22 * t22_17 + R22_32 * t22_19;
  const T v22_3 = Pdot22_3 + R22_13 * t22_16 + R22_23 * t22_17 + R22_33 * t22_19;
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
  const T P23_3 = P22_3 + R22_13 * T(0.3) + R22_23 * T(1.15) + R22_33 * T(0.1);
  // p23 = R23^T r23 + P23: position of the mass centre, inertial axes [m]
  const T p23_3 = P23_3 + R23_13 * T(0.1) + R23_23 * T(0.2) + R23_33 * T(0.05);
  // Pdot23 = R22^T omega22~ q23 + Pdot22: velocity of the body origin, inertial axes [m/s]
  const T t23_13 = t22_18 - omega22_3 * T(1.15);
  const T t23_14 = omega22_3 * T(0.3) - omega22_1 * T(0.1);
  const T t23_15 = omega22_1 * T(1.15) - omega22_2 * T(0.3);
  const T Pdot23_1 = Pdot22_1 + R22_11 * t23_13 + R22_21 * t23_14 + R22_31 * t23_15;
  const T Pdot23_2 = Pdot22_2 + R22_12 * t23_13 + R22_22 * t23_14 + R22_32 * t23_15;
  const T Pdot23_3 = Pdot22_3 + R22_13 * t23_13 + R22_23 * t23_14 + R22_33 * t23_15;
  // v23 = R23^T omega23~ r23 + Pdot23: velocity of the mass centre, inertial axes [m/s]
  const T t23_16 = omega23_2 * T(0.05) - omega23_3 * T(0.2);
  const T t23_17 = omega23_3 * T(0.1) - omega23_1 * T(0.05);
  const T t23_18 = omega23_2 * T(0.1);
  const T t23_19 = omega23_1 * T(0.2) - t23_18;
  const T v23_1 = Pdot23_1 + R23_11 * t23_16 + R23_21 * t23_17 + R23_31 * t23_19;
  const T v23_2 = Pdot23_2 + R23_12 * t23_16 + R23_22 * t23_17 + R23_32 * t23_19;
  const T v23_3 = Pdot23_3 + R23_13 * t23_16 + R23_23 * t23_17 + R23_33 * t23_19;
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
  const T P24_3 = P23_3 + R23_13 * T(0.3) + R23_23 * T(1.2) + R23_33 * T(0.1);
  // p24 = R24^T r24 + P24: position of the mass centre, inertial axes [m]
  const T p24_3 = P24_3 + R24_13 * T(0.1) + R24_23 * T(0.2) + R24_33 * T(0.05);
  // Pdot24 = R23^T omega23~ q24 + Pdot23: velocity of the body origin, inertial axes [m/s]
  const T t24_13 = t23_18 - omega23_3 * T(1.2);
  const T t24_14 = omega23_3 * T(0.3) - omega23_1 * T(0.1);
  const T t24_15 = omega23_1 * T(1.2) - omega23_2 * T(0.3);
  const T Pdot24_1 = Pdot23_1 + R23_11 * t24_13 + R23_21 * t24_14 + R23_31 * t24_15;
  const T Pdot24_2 = Pdot23_2 + R23_12 * t24_13 + R23_22 * t24_14 + R23_32 * t24_15;
  const T Pdot24_3 = Pdot23_3 + R23_13 * t24_13 + R23_23 * t24_14 + R23_33 * t24_15;
  // v24 = R24^T omega24~ r24 + Pdot24: velocity of the mass centre, inertial axes [m/s]
  const T t24_16 = omega24_2 * T(0.05) - omega24_3 * T(0.2);
  const T t24_17 = omega24_3 * T(0.1) - omega24_1 * T(0.05);
  const T t24_18 = omega24_2 * T(0.1);
  const T t24_19 = omega24_1 * T(0.2) - t24_18;
  const T v24_1 = Pdot24_1 + R24_11 * t24_16 + R24_21 * t24_17 + R24_31 * t24_19;
  const T v24_2 = Pdot24_2 + R24_12 * t24_16 + R24_22 * t24_17 + R24_32 * t24_19;
  const T v24_3 = Pdot24_3 + R24_13 * t24_16 + R24_23 * t24_17 + R24_33 * t24_19;
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
  const T P25_3 = P24_3 + R24_13 * T(0.3) + R24_23 * T(1.25) + R24_33 * T(0.1);
  // p25 = R25^T r25 + P25: position of the mass centre, inertial axes [m]
  const T p25_3 = P25_3 + R25_13 * T(0.1) + R25_23 * T(0.2) + R25_33 * T(0.05);
  // Pdot25 = R24^T omega24~ q25 + Pdot24: velocity of the body origin, inertial axes [m/s]
  const T t25_13 = t24_18 - omega24_3 * T(1.25);
  const T t25_14 = omega24_3 * T(0.3) - omega24_1 * T(0.1);
  const T t25_15 = omega24_1 * T(1.25) - omega24_2 * T(0.3);
  const T Pdot25_1 = Pdot24_1 + R24_11 * t25_13 + R24_21 * t25_14 + R24_31 * t25_15;
  const T Pdot25_2 = Pdot24_2 + R24_12 * t25_13 + R24_22 * t25_14 + R24_32 * t25_15;
  const T Pdot25_3 = Pdot24_3 + R24_13 * t25_13 + R24_23 * t25_14 + R24_33 * t25_15;
  // v25 = R25^T omega25~ r25 + Pdot25: velocity of the mass centre, inertial axes [m/s]
  const T t25_16 = omega25_2 * T(0.05) - omega25_3 * T(0.2);
  const T t25_17 = omega25_3 * T(0.1) - omega25_1 * T(0.05);
  const T t25_18 = omega25_2 * T(0.1);
  const T t25_19 = omega25_1 * T(0.2) - t25_18;
  const T v25_1 = Pdot25_1 + R25_11 * t25_16 + R25_21 * t25_17 + R25_31 * t25_19;
  const T v25_2 = Pdot25_2 + R25_12 * t25_16 + R25_22 * t25_17 + R25_32 * t25_19;
  const T v25_3 = Pdot25_3 + R25_13 * t25_16 + R25_23 * t25_17 + R25_33 * t25_19;
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
  const T P26_3 = P25_3 + R25_13 * T(0.3) + R25_23 * T(1.3) + R25_33 * T(0.1);
  // p26 = R26^T r26 + P26: position of the mass centre, inertial axes [m]
  const T p26_3 = P26_3 + R26_13 * T(0.1) + R26_23 * T(0.2) + R26_33 * T(0.05);
  // Pdot26 = R25^T omega25~ q26 + Pdot25: velocity of the body origin, inertial axes [m/s]
  const T t26_13 = t25_18 - omega25_3 * T(1.3);
  const T t26_14 = omega25_3 * T(0.3) - omega25_1 * T(0.1);
  const T t26_15 = omega25_1 * T(1.3) - omega25_2 * T(0.3);
  const T Pdot26_1 = Pdot25_1 + R25_11 * t26_13 + R25_21 * t26_14 + R25_31 * t26_15;
  const T Pdot26_2 = Pdot25_2 + R25_12 * t26_13 + R25_22 * t26_14 + R25_32 * t26_15;
  const T Pdot26_3 = Pdot25_3 + R25_13 * t26_13 + R25_23 * t26_14 + R25_33 * t26_15;
  // v26 = R26^T omega26~ r26 + Pdot26: velocity of the mass centre, inertial axes [m/s]
  const T t26_16 = omega26_2 * T(0.05) - omega26_3 * T(0.2);
  const T t26_17 = omega26_3 * T(0.1) - omega26_1 * T(0.05);
  const T t26_18 = omega26_2 * T(0.1);
  const T t26_19 = omega26_1 * T(0.2) - t26_18;
  const T v26_1 = Pdot26_1 + R26_11 * t26_16 + R26_21 * t26_17 + R26_31 * t26_19;
  const T v26_2 = Pdot26_2 + R26_12 * t26_16 + R26_22 * t26_17 + R26_32 * t26_19;
  const T v26_3 = Pdot26_3 + R26_13 * t26_16 + R26_23 * t26_17 + R26_33 * t26_19;
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
  const T P27_3 = P26_3 + R26_13 * T(0.3) + R26_23 * T(1.35) + R26_33 * T(0.1);
  // p27 = R27^T r27 + P27: position of the mass centre, inertial axes [m]
  const T p27_3 = P27_3 + R27_13 * T(0.1) + R27_23 * T(0.2) + R27_33 * T(0.05);
  // Pdot27 = R26^T omega26~ q27 + Pdot26: velocity of the body origin, inertial axes [m/s]
  const T t27_13 = t26_18 - omega26_3 * T(1.35);
  const T t27_14 = omega26_3 * T(0.3) - omega26_1 * T(0.1);
  const T t27_15 = omega26_1 * T(1.35) - omega26_2 * T(0.3);
  const T Pdot27_1 = Pdot26_1 + R26_11 * t27_13 + R26_21 * t27_14 + R26_31 * t27_15;
  const T Pdot27_2 = Pdot26_2 + R26_12 * t27_13 + R26_22 * t27_14 + R26_32 * t27_15;
  const T Pdot27_3 = Pdot26_3 + R26_13 * t27_13 + R26_23 * t27_14 + R26_33 * t27_15;
  // v27 = R27^T omega27~ r27 + Pdot27: velocity of the mass centre, inertial axes [m/s]
  const T t27_16 = omega27_2 * T(0.05) - omega27_3 * T(0.2);
  const T t27_17 = omega27_3 * T(0.1) - omega27_1 * T(0.05);
  const T t27_18 = omega27_2 * T(0.1);
  const T t27_19 = omega27_1 * T(0.2) - t27_18;
  const T v27_1 = Pdot27_1 + R27_11 * t27_16 + R27_21 * t27_17 + R27_31 * t27_19;
  const T v27_2 = Pdot27_2 + R27_12 * t27_16 + R27_22 * t27_17 + R27_32 * t27_19;
  const T v27_3 = Pdot27_3 + R27_13 * t27_16 + R27_23 * t27_17 + R27_33 * t27_19;
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
  const T P28_3 = P27_3 + R27_13 * T(0.3) + R27_23 * T(1.4) + R27_33 * T(0.1);
  // p28 = R28^T r28 + P28: position of the mass centre, inertial axes [m]
  const T p28_3 = P28_3 + R28_13 * T(0.1) + R28_23 * T(0.2) + R28_33 * T(0.05);
  // Pdot28 = R27^T omega27~ q28 + Pdot27: velocity of the body origin, inertial axes [m/s]
  const T t28_13 = t27_18 - omega27_3 * T(1.4);
  const T t28_14 = omega27_3 * T(0.3) - omega27_1 * T(0.1);
  const T t28_15 = omega27_1 * T(1.4) - omega27_2 * T(0.3);
  const T Pdot28_1 = Pdot27_1 + R27_11 * t28_13 + R27_21 * t28_14 + R27_31 * t28_15;
  const T Pdot28_2 = Pdot27_2 + R27_12 * t28_13 + R27_22 * t28_14 + R27_32 * t28_15;
  const T Pdot28_3 = Pdot27_3 + R27_13 * t28_13 + R27_23 * t28_14 + R27_33 * t28_15;
  // v28 = R28^T omega28~ r28 + Pdot28: velocity of the mass centre, inertial axes [m/s]
  const T t28_16 = omega28_2 * T(0.05) - omega28_3 * T(0.2);
  const T t28_17 = omega28_3 * T(0.1) - omega28_1 * T(0.05);
  const T t28_18 = omega28_2 * T(0.1);
  const T t28_19 = omega28_1 * T(0.2) - t28_18;
  const T v28_1 = Pdot28_1 + R28_11 * t28_16 + R28_21 * t28_17 + R28_31 * t28_19;
  const T v28_2 = Pdot28_2 + R28_12 * t28_16 + R28_22 * t28_17 + R28_32 * t28_19;
  const T v28_3 = Pdot28_3 + R28_13 * t28_16 + R28_23 * t28_17 + R28_33 * t28_19;
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
  const T P29_3 = P28_3 + R28_13 * T(0.3) + R28_23 * T(1.45) + R28_33 * T(0.1);
  // p29 = R29^T r29 + P29: position of the mass centre, inertial axes [m]
  const T p29_3 = P29_3 + R29_13 * T(0.1) + R29_23 * T(0.2) + R29_33 * T(0.05);
  // Pdot29 = R28^T omega28~ q29 + Pdot28: velocity of the body origin, inertial axes [m/s]
  const T t29_13 = t28_18 - omega28_3 * T(1.45);
  const T t29_14 = omega28_3 * T(0.3) - omega28_1 * T(0.1);
  const T t29_15 = omega28_1 * T(1.45) - omega28_2 * T(0.3);
  const T Pdot29_1 = Pdot28_1 + R28_11 * t29_13 + R28_21 * t29_14 + R28_31 * t29_15;
  const T Pdot29_2 = Pdot28_2 + R28_12 * t29_13 + R28_22 * t29_14 + R28_32 * t29_15;
  const T Pdot29_3 = Pdot28_3 + R28_13 * t29_13 + R28_23 * t29_14 + R28_33 * t29_15;
  // v29 = R29^T omega29~ r29 + Pdot29: velocity of the mass centre, inertial axes [m/s]
  const T t29_16 = omega29_2 * T(0.05) - omega29_3 * T(0.2);
  const T t29_17 = omega29_3 * T(0.1) - omega29_1 * T(0.05);
  const T t29_18 = omega29_2 * T(0.1);
  const T t29_19 = omega29_1 * T(0.2) - t29_18;
  const T v29_1 = Pdot29_1 + R29_11 * t29_16 + R29_21 * t29_17 + R29_31 * t29_19;
  const T v29_2 = Pdot29_2 + R29_12 * t29_16 + R29_22 * t29_17 + R29_32 * t29_19;
  const T v29_3 = Pdot29_3 + R29_13 * t29_16 + R29_23 * t29_17 + R29_33 * t29_19;
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
  const T P30_3 = P29_3 + R29_13 * T(0.3) + R29_23 * T(1.5) + R29_33 * T(0.1);
  // p30 = R30^T r30 + P30: position of the mass centre, inertial axes [m]
  const T p30_3 = P30_3 + R30_13 * T(0.1) + R30_23 * T(0.2) + R30_33 * T(0.05);
  // Pdot30 = R29^T omega29~ q30 + Pdot29: velocity of the body origin, inertial axes [m/s]
  const T t30_13 = t29_18 - omega29_3 * T(1.5);
  const T t30_14 = omega29_3 * T(0.3) - omega29_1 * T(0.1);
  const T t30_15 = omega29_1 * T(1.5) - omega29_2 * T(0.3);
  const T Pdot30_1 = Pdot29_1 + R29_11 * t30_13 + R29_21 * t30_14 + R29_31 * t30_15;
  const T Pdot30_2 = Pdot29_2 + R29_12 * t30_13 + R29_22 * t30_14 + R29_32 * t30_15;
  const T Pdot30_3 = Pdot29_3 + R29_13 * t30_13 + R29_23 * t30_14 + R29_33 * t30_15;
  // v30 = R30^T omega30~ r30 + Pdot30: velocity of the mass centre, inertial axes [m/s]
  const T t30_16 = omega30_2 * T(0.05) - omega30_3 * T(0.2);
  const T t30_17 = omega30_3 * T(0.1) - omega30_1 * T(0.05);
  const T t30_18 = omega30_2 * T(0.1);
  const T t30_19 = omega30_1 * T(0.2) - t30_18;
  const T v30_1 = Pdot30_1 + R30_11 * t30_16 + R30_21 * t30_17 + R30_31 * t30_19;
  const T v30_2 = Pdot30_2 + R30_12 * t30_16 + R30_22 * t30_17 + R30_32 * t30_19;
  const T v30_3 = Pdot30_3 + R30_13 * t30_16 + R30_23 * t30_17 + R30_33 * t30_19;
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
  const T P31_3 = P30_3 + R30_13 * T(0.3) + R30_23 * T(1.55) + R30_33 * T(0.1);
  // p31 = R31^T r31 + P31: position of the mass centre, inertial axes [m]
  const T p31_3 = P31_3 + R31_13 * T(0.1) + R31_23 * T(0.2) + R31_33 * T(0.05);
  // Pdot31 = R30^T omega30~ q31 + Pdot30: velocity of the body origin, inertial axes [m/s]
  const T t31_13 = t30_18 - omega30_3 * T(1.55);
  const T t31_14 = omega30_3 * T(0.3) - omega30_1 * T(0.1);
  const T t31_15 = omega30_1 * T(1.55) - omega30_2 * T(0.3);
  const T Pdot31_1 = Pdot30_1 + R30_11 * t31_13 + R30_21 * t31_14 + R30_31 * t31_15;
  const T Pdot31_2 = Pdot30_2 + R30_12 * t31_13 + R30_22 * t31_14 + R30_32 * t31_15;
  const T Pdot31_3 = Pdot30_3 + R30_13 * t31_13 + R30_23 * t31_14 + R30_33 * t31_15;
  // v31 = R31^T omega31~ r31 + Pdot31: velocity of the mass centre, inertial axes [m/s]
  const T t31_16 = omega31_2 * T(0.05) - omega31_3 * T(0.2);
  const T t31_17 = omega31_3 * T(0.1) - omega31_1 * T(0.05);
  const T t31_18 = omega31_2 * T(0.1);
  const T t31_19 = omega31_1 * T(0.2) - t31_18;
  const T v31_1 = Pdot31_1 + R31_11 * t31_16 + R31_21 * t31_17 + R31_31 * t31_19;
  const T v31_2 = Pdot31_2 + R31_12 * t31_16 + R31_22 * t31_17 + R31_32 * t31_19;
  const T v31_3 = Pdot31_3 + R31_13 * t31_16 + R31_23 * t31_17 + R31_33 * t31_19;
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
  const T P32_3 = P31_3 + R31_13 * T(0.3) + R31_23 * T(1.6) + R31_33 * T(0.1);
  // p32 = R32^T r32 + P32: position of the mass centre, inertial axes [m]
  const T p32_3 = P32_3 + R32_13 * T(0.1) + R32_23 * T(0.2) + R32_33 * T(0.05);
  // Pdot32 = R31^T omega31~ q32 + Pdot31: velocity of the body origin, inertial axes [m/s]
  const T t32_13 = t31_18 - omega31_3 * T(1.6);
  const T t32_14 = omega31_3 * T(0.3) - omega31_1 * T(0.1);
  const T t32_15 = omega31_1 * T(1.6) - omega31_2 * T(0.3);
  const T Pdot32_1 = Pdot31_1 + R31_11 * t32_13 + R31_21 * t32_14 + R31_31 * t32_15;
  const T Pdot32_2 = Pdot31_2 + R31_12 * t32_13 + R31_22 * t32_14 + R31_32 * t32_15;
  const T Pdot32_3 = Pdot31_3 + R31_13 * t32_13 + R31_23 * t32_14 + R31_33 * t32_15;
  // v32 = R32^T omega32~ r32 + Pdot32: velocity of the mass centre, inertial axes [m/s]
  const T t32_16 = omega32_2 * T(0.05) - omega32_3 * T(0.2);
  const T t32_17 = omega32_3 * T(0.1) - omega32_1 * T(0.05);
  const T t32_18 = omega32_1 * T(0.2) - omega32_2 * T(0.1);
  const T v32_1 = Pdot32_1 + R32_11 * t32_16 + R32_21 * t32_17 + R32_31 * t32_18;
  const T v32_2 = Pdot32_2 + R32_12 * t32_16 + R32_22 * t32_17 + R32_32 * t32_18;
  const T v32_3 = Pdot32_3 + R32_13 * t32_16 + R32_23 * t32_17 + R32_33 * t32_18;
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

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 6802 add, 7961 multiply, 93 divide
// by: articulated; composite would take 172576 add, 186247 multiply, 93 divide
namespace accelerations_sections {

// Results of a body's sections that others read, by their place in the body's frame; fields that no body has both
// of may share one. K, L and J in tables: where the frames of a body, of its lower and of an upper one begin.
namespace frame {
inline constexpr int s_1 = 2, s_2 = 3, minus_U_11 = 4, U_12 = 5, U_13 = 6, s_3 = 7, minus_U_22 = 8, U_23 = 9,
    minus_U_33 = 10, Pddot_1 = 11, Pddot_2 = 12, Pddot_3 = 13, minus_C_11 = 14, C_12 = 15, C_13 = 16, C_21 = 17,
    minus_C_22 = 18, C_23 = 19, C_31 = 20, C_32 = 21, minus_C_33 = 22, N1_1 = 40, N1_2 = 41, N1_3 = 42, G_1 = 23, G_2
    = 24, G_3 = 25, N2_1 = 59, N2_2 = 60, N2_3 = 61, N3_1 = 59, N3_2 = 60, N3_3 = 61, N5_1 = 43, N5_2 = 52, N5_3 = 59,
    N19_1 = 59, N19_2 = 60, N19_3 = 61, N31_1 = 2, N31_2 = 3, N31_3 = 4, N_1 = 5, N_2 = 6, N_3 = 7, w__1 = 0, w__2 =
    1, w__3 = 8, gb_1 = 26, gb_2 = 27, gb_3 = 53, Mb_11 = 54, minus_Mb_12 = 55, Mb_13 = 40, minus_Mb_22 = 56, Mb_23 =
    41, Mb_33 = 42, Hb_11 = 28, Hb_12 = 29, Hb_13 = 30, Hb_21 = 31, Hb_22 = 43, Hb_23 = 32, Hb_31 = 33, Hb_32 = 34,
    minus_Hb_33 = 52, LD_21 = 35, LD_31 = 36, LD_32 = 37, W_11 = 44, W_12 = 45, W_13 = 46, W_21 = 47, W_22 = 53, W_23
    = 48, W_31 = 49, W_32 = 50, minus_W_33 = 54, minus_w__3 = 38, minus_gb_3 = 55, minus_Mb_11 = 56, Mb_12 = 57, Mb_22
    = 58, minus_Hb_22 = 60, Hb_33 = 61, minus_W_22 = 57, W_33 = 58, omegadot_2 = 62, omegadot_1 = 39, beta_1 = 51,
    beta_2 = 63, minus_beta_3 = 64, minus_omegadot_3 = 65, minus_beta_2 = 62, beta_3 = 63, omegadot_3 = 64,
    minus_omegadot_2 = 65;
}  // namespace frame

// how constants stand in tables
template <class T>
struct Constants {
  using Number = double;
};
template <>
struct Constants<float> {
  using Number = float;
};
template <class T>
using Number = typename Constants<T>::Number;

inline constexpr unsigned short outward_3_places[9][5] = {  // L, K, x_at, y_at, u_at
    {63, 129, 4, 6, 0},
    {459, 525, 28, 24, 1},
    {657, 723, 40, 33, 2},
    {855, 921, 52, 42, 3},
    {1053, 1119, 64, 51, 4},
    {1251, 1317, 76, 60, 5},
    {1449, 1515, 88, 69, 6},
    {1647, 1713, 100, 78, 7},
    {1845, 1911, 112, 87, 8},
};
template <class C>
inline constexpr C outward_3_numbers[9][20] = {
    {C(0.15), C(-0.15), C(-0.018000000000000002), C(-0.0024000000000000007), C(0.0168), C(-0.0029999999999999836),
     C(-0.06), C(0.24), C(-0.0168), C(0.014999999999999993), C(-0.12), C(0.06), C(0.012000000000000009),
     C(-0.8400000000000001), C(-4.2), C(1), C(-0.35500000000000004), C(-1), C(0.8400000000000001),
     C(0.35500000000000004)},
    {C(0.45), C(-0.45), C(-0.027000000000000007), C(-0.0036000000000000008), C(0.025200000000000004), C(-0.0045),
     C(-0.09000000000000001), C(0.36000000000000004), C(-0.025200000000000004), C(0.022500000000000003),
     C(-0.18000000000000002), C(0.09000000000000001), C(0.018000000000000002), C(-2.43), C(-6), C(1.42), C(-0.505),
     C(-1.42), C(2.43), C(0.505)},
    {C(0.6), C(-0.6), C(-0.03150000000000001), C(-0.0042000000000000015), C(0.029400000000000003),
     C(-0.0052499999999999795), C(-0.10500000000000001), C(0.42000000000000004), C(-0.029400000000000003),
     C(0.026249999999999978), C(-0.21000000000000002), C(0.10500000000000001), C(0.021), C(-3.495), C(-6.9), C(1.63),
     C(-0.58), C(-1.63), C(3.495), C(0.58)},
    {C(0.75), C(-0.75), C(-0.036000000000000004), C(-0.004800000000000001), C(0.0336), C(-0.005999999999999967),
     C(-0.12), C(0.48), C(-0.0336), C(0.029999999999999985), C(-0.24), C(0.12), C(0.024000000000000018), C(-4.74),
     C(-7.800000000000001), C(1.84), C(-0.655), C(-1.84), C(4.74), C(0.655)},
    {C(0.9), C(-0.9), C(-0.04050000000000001), C(-0.005400000000000003), C(0.03780000000000001),
     C(-0.006749999999999995), C(-0.135), C(0.54), C(-0.03780000000000001), C(0.033750000000000016), C(-0.27),
     C(0.135), C(0.02700000000000002), C(-6.165), C(-8.7), C(2.05), C(-0.73), C(-2.05), C(6.165), C(0.73)},
    {C(1.05), C(-1.05), C(-0.045000000000000005), C(-0.006000000000000003), C(0.042), C(-0.007499999999999983),
     C(-0.15000000000000002), C(0.6000000000000001), C(-0.042), C(0.0375), C(-0.30000000000000004),
     C(0.15000000000000002), C(0.030000000000000013), C(-7.7700000000000005), C(-9.6), C(2.26), C(-0.805), C(-2.26),
     C(7.7700000000000005), C(0.805)},
    {C(1.2), C(-1.2), C(-0.0495), C(-0.0066), C(0.046200000000000005), C(-0.008249999999999999), C(-0.165), C(0.66),
     C(-0.046200000000000005), C(0.04125), C(-0.33), C(0.165), C(0.033), C(-9.555), C(-10.5), C(2.4699999999999998),
     C(-0.88), C(-2.4699999999999998), C(9.555), C(0.88)},
    {C(1.35), C(-1.35), C(-0.05400000000000001), C(-0.0072000000000000015), C(0.05040000000000001), C(-0.009),
     C(-0.18000000000000002), C(0.7200000000000001), C(-0.05040000000000001), C(0.045000000000000005),
     C(-0.36000000000000004), C(0.18000000000000002), C(0.036000000000000004), C(-11.52), C(-11.4),
     C(2.6799999999999997), C(-0.9550000000000001), C(-2.6799999999999997), C(11.52), C(0.9550000000000001)},
    {C(1.5), C(-1.5), C(-0.05850000000000001), C(-0.007800000000000001), C(0.0546), C(-0.009750000000000014),
     C(-0.195), C(0.78), C(-0.0546), C(0.04875000000000001), C(-0.39), C(0.195), C(0.039), C(-13.665000000000001),
     C(-12.3), C(2.8899999999999997), C(-1.03), C(-2.8899999999999997), C(13.665000000000001), C(1.03)},
};
// L, K, x_at, y_at, u_at, u_at2, u_at3, u_at4, u_at5, u_at6
inline constexpr unsigned short outward_4_places[18][10] = {
    {129, 195, 8, 9, 54, 65, 9, 77, 0, 27},
    {195, 261, 12, 12, 55, 66, 65, 78, 54, 77},
    {327, 393, 20, 18, 56, 67, 76, 79, 88, 89},
    {393, 459, 24, 21, 37, 19, 67, 46, 56, 79},
    {525, 591, 32, 27, 57, 68, 10, 80, 1, 28},
    {591, 657, 36, 30, 38, 20, 68, 47, 57, 80},
    {723, 789, 44, 36, 58, 69, 11, 81, 2, 29},
    {789, 855, 48, 39, 39, 21, 69, 48, 58, 81},
    {921, 987, 56, 45, 59, 70, 12, 82, 3, 30},
    {987, 1053, 60, 48, 40, 22, 70, 49, 59, 82},
    {1119, 1185, 68, 54, 60, 71, 13, 83, 4, 31},
    {1317, 1383, 80, 63, 61, 72, 14, 84, 5, 32},
    {1383, 1449, 84, 66, 42, 24, 72, 51, 61, 84},
    {1515, 1581, 92, 72, 62, 73, 15, 85, 6, 33},
    {1581, 1647, 96, 75, 43, 25, 73, 52, 62, 85},
    {1713, 1779, 104, 81, 63, 74, 16, 86, 7, 34},
    {1779, 1845, 108, 84, 44, 26, 74, 53, 63, 86},
    {1911, 1977, 116, 90, 64, 75, 17, 87, 8, 35},
};
template <class C>
inline constexpr C outward_4_numbers[18][19] = {
    {C(0.2), C(-0.2), C(-0.1935), C(-0.0896), C(0.0762), C(0.08375), C(-0.35500000000000004), C(0.8400000000000001),
     C(-0.0762), C(-0.21574999999999997), C(-1), C(0.35500000000000004), C(-0.13199999999999995), C(-0.22), C(-0.655),
     C(0.59), C(-0.59), C(0.655), C(0.22)},
    {C(0.25), C(-0.25), C(-0.1335), C(-0.0478), C(0.057100000000000005), C(0.07525), C(-0.22), C(0.655),
     C(-0.057100000000000005), C(-0.10249999999999998), C(-0.59), C(0.22), C(-0.027249999999999986),
     C(-0.07500000000000001), C(-0.30000000000000004), C(0.15000000000000002), C(-0.15000000000000002),
     C(0.30000000000000004), C(0.07500000000000001)},
    {C(0.35), C(-0.35), C(-0.39149999999999996), C(-0.1082), C(0.1449), C(0.38974999999999993),
     C(-0.43000000000000005), C(1.545), C(-0.1449), C(-0.25999999999999995), C(-1.21), C(0.43000000000000005),
     C(0.12974999999999998), C(-0.265), C(-1.06), C(0.71), C(-0.71), C(1.06), C(0.265)},
    {C(0.4), C(-0.4), C(-0.24150000000000002), C(-0.0574), C(0.09580000000000001), C(0.26575000000000004), C(-0.265),
     C(1.06), C(-0.09580000000000001), C(-0.12274999999999998), C(-0.71), C(0.265), C(0.14300000000000007),
     C(-0.09000000000000001), C(-0.36000000000000004), C(0.18000000000000002), C(-0.18000000000000002),
     C(0.36000000000000004), C(0.09000000000000001)},
    {C(0.5), C(-0.5), C(-0.6435), C(-0.1268), C(0.23160000000000003), C(0.9792500000000001), C(-0.505), C(2.43),
     C(-0.23160000000000003), C(-0.30424999999999996), C(-1.42), C(0.505), C(0.675), C(-0.31000000000000005),
     C(-1.5550000000000002), C(0.83), C(-0.83), C(1.5550000000000002), C(0.31000000000000005)},
    {C(0.55), C(-0.55), C(-0.37650000000000006), C(-0.067), C(0.14350000000000002), C(0.6092500000000002),
     C(-0.31000000000000005), C(1.5550000000000002), C(-0.14350000000000002), C(-0.143), C(-0.83),
     C(0.31000000000000005), C(0.46625000000000016), C(-0.10500000000000001), C(-0.42000000000000004),
     C(0.21000000000000002), C(-0.21000000000000002), C(0.42000000000000004), C(0.10500000000000001)},
    {C(0.65), C(-0.65), C(-0.9494999999999999), C(-0.1454), C(0.3363), C(1.93325), C(-0.58), C(3.495), C(-0.3363),
     C(-0.3484999999999999), C(-1.63), C(0.58), C(1.58475), C(-0.355), C(-2.1399999999999997), C(0.95), C(-0.95),
     C(2.1399999999999997), C(0.355)},
    {C(0.7), C(-0.7), C(-0.5385), C(-0.0766), C(0.2002), C(1.1462499999999998), C(-0.355), C(2.1399999999999997),
     C(-0.2002), C(-0.16324999999999995), C(-0.95), C(0.355), C(0.9829999999999999), C(-0.12), C(-0.48), C(0.24),
     C(-0.24), C(0.48), C(0.12)},
    {C(0.8), C(-0.8), C(-1.3095), C(-0.164), C(0.4590000000000001), C(3.3327500000000008), C(-0.655), C(4.74),
     C(-0.4590000000000001), C(-0.39275), C(-1.84), C(0.655), C(2.9400000000000004), C(-0.4), C(-2.815), C(1.07),
     C(-1.07), C(2.815), C(0.4)},
    {C(0.85), C(-0.85), C(-0.7275), C(-0.08620000000000001), C(0.2659), C(1.9172500000000001), C(-0.4), C(2.815),
     C(-0.2659), C(-0.18349999999999997), C(-1.07), C(0.4), C(1.7337500000000001), C(-0.135), C(-0.54), C(0.27),
     C(-0.27), C(0.54), C(0.135)},
    {C(0.95), C(-0.95), C(-1.7234999999999998), C(-0.1826), C(0.5997), C(5.258749999999999), C(-0.73), C(6.165),
     C(-0.5997), C(-0.43699999999999994), C(-2.05), C(0.73), C(4.82175), C(-0.445), C(-3.58), C(1.19), C(-1.19),
     C(3.58), C(0.445)},
    {C(1.1), C(-1.1), C(-2.1915), C(-0.20120000000000002), C(0.7584000000000001), C(7.792250000000001), C(-0.805),
     C(7.7700000000000005), C(-0.7584000000000001), C(-0.48124999999999996), C(-2.26), C(0.805), C(7.311000000000002),
     C(-0.49), C(-4.435), C(1.31), C(-1.31), C(4.435), C(0.49)},
    {C(1.15), C(-1.15), C(-1.1864999999999999), C(-0.1054), C(0.42429999999999995), C(4.323249999999999), C(-0.49),
     C(4.435), C(-0.42429999999999995), C(-0.22399999999999995), C(-1.31), C(0.49), C(4.099249999999999), C(-0.165),
     C(-0.66), C(0.33), C(-0.33), C(0.66), C(0.165)},
    {C(1.25), C(-1.25), C(-2.7135), C(-0.2198), C(0.9351), C(11.01425), C(-0.88), C(9.555), C(-0.9351), C(-0.5255),
     C(-2.4699999999999998), C(0.88), C(10.48875), C(-0.535), C(-5.38), C(1.43), C(-1.43), C(5.38), C(0.535)},
    {C(1.3), C(-1.3), C(-1.4565000000000001), C(-0.115), C(0.517), C(6.039250000000001), C(-0.535), C(5.38),
     C(-0.517), C(-0.24425000000000002), C(-1.43), C(0.535), C(5.795000000000001), C(-0.18000000000000002),
     C(-0.7200000000000001), C(0.36000000000000004), C(-0.36000000000000004), C(0.7200000000000001),
     C(0.18000000000000002)},
    {C(1.4), C(-1.4), C(-3.2894999999999994), C(-0.2384), C(1.1298), C(15.005749999999997), C(-0.9550000000000001),
     C(11.52), C(-1.1298), C(-0.5697499999999999), C(-2.6799999999999997), C(0.9550000000000001),
     C(14.435999999999998), C(-0.58), C(-6.415), C(1.5499999999999998), C(-1.5499999999999998), C(6.415), C(0.58)},
    {C(1.45), C(-1.45), C(-1.7534999999999998), C(-0.1246), C(0.6187), C(8.15125), C(-0.58), C(6.415), C(-0.6187),
     C(-0.26449999999999996), C(-1.5499999999999998), C(0.58), C(7.886749999999999), C(-0.195), C(-0.78), C(0.39),
     C(-0.39), C(0.78), C(0.195)},
    {C(1.55), C(-1.55), C(-3.9194999999999998), C(-0.257), C(1.3425), C(19.84775), C(-1.03), C(13.665000000000001),
     C(-1.3425), C(-0.6139999999999999), C(-2.8899999999999997), C(1.03), C(19.23375), C(-0.625),
     C(-7.540000000000001), C(1.67), C(-1.67), C(7.540000000000001), C(0.625)},
};
inline constexpr unsigned short inward_2_places[2][3] = {  // J, K, s_at
    {2043, 1977, 2},
    {261, 195, 59},
};
template <class C>
inline constexpr C inward_2_numbers[2][16] = {
    {C(-0.625), C(7.540000000000001), C(0.625), C(-1.67), C(-7.540000000000001), C(1.67), C(1.6),
     C(11.378250000000001), C(-2.0775), C(-1.6), C(-0.1342), C(0.9632499999999999), C(-0.7294000000000002),
     C(11.663000000000002), C(1.55), C(-1.55)},
    {C(-0.22), C(0.655), C(0.22), C(-0.59), C(-0.655), C(0.59), C(0.25), C(0.30825), C(-0.1335), C(-0.25), C(-0.0478),
     C(0.3355), C(-0.057100000000000005), C(0.41075), C(0.2), C(-0.2)},
};
inline constexpr unsigned short inward_3_places[9][2] = {  // J, K
    {1977, 1911},
    {1779, 1713},
    {1581, 1515},
    {1383, 1317},
    {1185, 1119},
    {987, 921},
    {789, 723},
    {591, 525},
    {195, 129},
};
template <class C>
inline constexpr C inward_3_numbers[9][17] = {
    {C(12.3), C(-1.03), C(13.665000000000001), C(1.03), C(-2.8899999999999997), C(-13.665000000000001),
     C(2.8899999999999997), C(1.55), C(20.59375), C(-3.9194999999999998), C(-1.55), C(-0.257), C(1.3599999999999999),
     C(-1.3425), C(21.20775), C(1.5), C(-1.5)},
    {C(11.4), C(-0.9550000000000001), C(11.52), C(0.9550000000000001), C(-2.6799999999999997), C(-11.52),
     C(2.6799999999999997), C(1.4), C(15.696249999999997), C(-3.2894999999999994), C(-1.4), C(-0.2384),
     C(1.2602499999999999), C(-1.1298), C(16.266), C(1.35), C(-1.35)},
    {C(10.5), C(-0.88), C(9.555), C(0.88), C(-2.4699999999999998), C(-9.555), C(2.4699999999999998), C(1.25),
     C(11.64925), C(-2.7135), C(-1.25), C(-0.2198), C(1.1604999999999999), C(-0.9351), C(12.17475), C(1.2), C(-1.2)},
    {C(9.6), C(-0.805), C(7.7700000000000005), C(0.805), C(-2.26), C(-7.7700000000000005), C(2.26), C(1.1),
     C(8.37175), C(-2.1915), C(-1.1), C(-0.20120000000000002), C(1.0607499999999999), C(-0.7584000000000001),
     C(8.853000000000002), C(1.05), C(-1.05)},
    {C(8.7), C(-0.73), C(6.165), C(0.73), C(-2.05), C(-6.165), C(2.05), C(0.95), C(5.782749999999999),
     C(-1.7234999999999998), C(-0.95), C(-0.1826), C(0.961), C(-0.5997), C(6.2197499999999994), C(0.9), C(-0.9)},
    {C(7.800000000000001), C(-0.655), C(4.74), C(0.655), C(-1.84), C(-4.74), C(1.84), C(0.8), C(3.8012500000000005),
     C(-1.3095), C(-0.8), C(-0.164), C(0.86125), C(-0.4590000000000001), C(4.194000000000001), C(0.75), C(-0.75)},
    {C(6.9), C(-0.58), C(3.495), C(0.58), C(-1.63), C(-3.495), C(1.63), C(0.65), C(2.34625), C(-0.9494999999999999),
     C(-0.65), C(-0.1454), C(0.7615), C(-0.3363), C(2.69475), C(0.6), C(-0.6)},
    {C(6), C(-0.505), C(2.43), C(0.505), C(-1.42), C(-2.43), C(1.42), C(0.5), C(1.33675), C(-0.6435), C(-0.5),
     C(-0.1268), C(0.66175), C(-0.23160000000000003), C(1.641), C(0.45), C(-0.45)},
    {C(4.2), C(-0.35500000000000004), C(0.8400000000000001), C(0.35500000000000004), C(-1), C(-0.8400000000000001),
     C(1), C(0.2), C(0.33025000000000004), C(-0.1935), C(-0.2), C(-0.0896), C(0.46225), C(-0.0762), C(0.546), C(0.15),
     C(-0.15)},
};
inline constexpr unsigned short inward_4_places[14][2] = {  // J, K
    {1911, 1845},
    {1845, 1779},
    {1713, 1647},
    {1647, 1581},
    {1515, 1449},
    {1449, 1383},
    {1119, 1053},
    {1053, 987},
    {921, 855},
    {855, 789},
    {723, 657},
    {657, 591},
    {525, 459},
    {459, 393},
};
template <class C>
inline constexpr C inward_4_numbers[14][16] = {
    {C(-0.195), C(0.78), C(0.195), C(-0.39), C(-0.78), C(0.39), C(1.5), C(0.5557500000000001),
     C(-0.05850000000000001), C(-1.5), C(-0.007800000000000001), C(0.51675), C(-0.0546), C(0.507), C(1.45), C(-1.45)},
    {C(-0.58), C(6.415), C(0.58), C(-1.5499999999999998), C(-6.415), C(1.5499999999999998), C(1.45),
     C(8.780249999999999), C(-1.7534999999999998), C(-1.45), C(-0.1246), C(0.8935), C(-0.6187), C(9.044749999999999),
     C(1.4), C(-1.4)},
    {C(-0.18000000000000002), C(0.7200000000000001), C(0.18000000000000002), C(-0.36000000000000004),
     C(-0.7200000000000001), C(0.36000000000000004), C(1.35), C(0.513), C(-0.05400000000000001), C(-1.35),
     C(-0.0072000000000000015), C(0.477), C(-0.05040000000000001), C(0.468), C(1.3), C(-1.3)},
    {C(-0.535), C(5.38), C(0.535), C(-1.43), C(-5.38), C(1.43), C(1.3), C(6.61875), C(-1.4565000000000001), C(-1.3),
     C(-0.115), C(0.82375), C(-0.517), C(6.863), C(1.25), C(-1.25)},
    {C(-0.165), C(0.66), C(0.165), C(-0.33), C(-0.66), C(0.33), C(1.2), C(0.47025), C(-0.0495), C(-1.2), C(-0.0066),
     C(0.43725), C(-0.046200000000000005), C(0.42900000000000005), C(1.15), C(-1.15)},
    {C(-0.49), C(4.435), C(0.49), C(-1.31), C(-4.435), C(1.31), C(1.15), C(4.853249999999999), C(-1.1864999999999999),
     C(-1.15), C(-0.1054), C(0.754), C(-0.42429999999999995), C(5.077249999999999), C(1.1), C(-1.1)},
    {C(-0.135), C(0.54), C(0.135), C(-0.27), C(-0.54), C(0.27), C(0.9), C(0.38475000000000004),
     C(-0.04050000000000001), C(-0.9), C(-0.005400000000000003), C(0.35775), C(-0.03780000000000001),
     C(0.35100000000000003), C(0.85), C(-0.85)},
    {C(-0.4), C(2.815), C(0.4), C(-1.07), C(-2.815), C(1.07), C(0.85), C(2.34825), C(-0.7275), C(-0.85),
     C(-0.08620000000000001), C(0.6145), C(-0.2659), C(2.53175), C(0.8), C(-0.8)},
    {C(-0.12), C(0.48), C(0.12), C(-0.24), C(-0.48), C(0.24), C(0.75), C(0.342), C(-0.036000000000000004), C(-0.75),
     C(-0.004800000000000001), C(0.318), C(-0.0336), C(0.312), C(0.7), C(-0.7)},
    {C(-0.355), C(2.1399999999999997), C(0.355), C(-0.95), C(-2.1399999999999997), C(0.95), C(0.7),
     C(1.5277499999999997), C(-0.5385), C(-0.7), C(-0.0766), C(0.54475), C(-0.2002), C(1.6909999999999998), C(0.65),
     C(-0.65)},
    {C(-0.10500000000000001), C(0.42000000000000004), C(0.10500000000000001), C(-0.21000000000000002),
     C(-0.42000000000000004), C(0.21000000000000002), C(0.6), C(0.29925), C(-0.03150000000000001), C(-0.6),
     C(-0.0042000000000000015), C(0.27825), C(-0.029400000000000003), C(0.273), C(0.55), C(-0.55)},
    {C(-0.31000000000000005), C(1.5550000000000002), C(0.31000000000000005), C(-0.83), C(-1.5550000000000002),
     C(0.83), C(0.55), C(0.9412500000000001), C(-0.37650000000000006), C(-0.55), C(-0.067), C(0.475),
     C(-0.14350000000000002), C(1.0842500000000002), C(0.5), C(-0.5)},
    {C(-0.09000000000000001), C(0.36000000000000004), C(0.09000000000000001), C(-0.18000000000000002),
     C(-0.36000000000000004), C(0.18000000000000002), C(0.45), C(0.2565), C(-0.027000000000000007), C(-0.45),
     C(-0.0036000000000000008), C(0.2385), C(-0.025200000000000004), C(0.234), C(0.4), C(-0.4)},
    {C(-0.265), C(1.06), C(0.265), C(-0.71), C(-1.06), C(0.71), C(0.4), C(0.54825), C(-0.24150000000000002), C(-0.4),
     C(-0.0574), C(0.40525), C(-0.09580000000000001), C(0.671), C(0.35), C(-0.35)},
};
inline constexpr unsigned short solved_3_places[14][3] = {  // K, L, ydot_at
    {129, 63, 6},
    {393, 327, 18},
    {525, 459, 24},
    {657, 591, 30},
    {789, 723, 36},
    {921, 855, 42},
    {1053, 987, 48},
    {1185, 1119, 54},
    {1317, 1251, 60},
    {1449, 1383, 66},
    {1581, 1515, 72},
    {1713, 1647, 78},
    {1845, 1779, 84},
    {1977, 1911, 90},
};
template <class C>
inline constexpr C solved_3_numbers[14][1] = {
    {C(-0.15)},
    {C(-0.35)},
    {C(-0.45)},
    {C(-0.55)},
    {C(-0.65)},
    {C(-0.75)},
    {C(-0.85)},
    {C(-0.95)},
    {C(-1.05)},
    {C(-1.15)},
    {C(-1.25)},
    {C(-1.35)},
    {C(-1.45)},
    {C(-1.55)},
};
inline constexpr unsigned short solved_4_places[12][3] = {  // K, L, ydot_at
    {195, 129, 9},
    {459, 393, 21},
    {591, 525, 27},
    {723, 657, 33},
    {855, 789, 39},
    {987, 921, 45},
    {1119, 1053, 51},
    {1383, 1317, 63},
    {1515, 1449, 69},
    {1647, 1581, 75},
    {1779, 1713, 81},
    {1911, 1845, 87},
};
template <class C>
inline constexpr C solved_4_numbers[12][2] = {
    {C(-0.2), C(0.2)},
    {C(-0.4), C(0.4)},
    {C(-0.5), C(0.5)},
    {C(-0.6), C(0.6)},
    {C(-0.7), C(0.7)},
    {C(-0.8), C(0.8)},
    {C(-0.9), C(0.9)},
    {C(-1.1), C(1.1)},
    {C(-1.2), C(1.2)},
    {C(-1.3), C(1.3)},
    {C(-1.4), C(1.4)},
    {C(-1.5), C(1.5)},
};

// body 1
template <class T>
[[gnu::noinline]] void outward_1(const T* x, const T* y, T* frames) noexcept {
  T* const own = frames + 0;
  const T eps1_1 = x[0];
  const T eps1_3 = x[2];
  const T eps1_2 = x[1];
  const T eps1_4 = x[3];
  const T omega1_3 = y[2];
  const T omega1_2 = y[1];
  const T omega1_1 = y[0];
  // R1^T = 1 + 2 e1~ (eps4_1 + e1~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t1_1 = T(2) * eps1_1;
  const T t1_2 = T(2) * eps1_2;
  const T R1_13 = t1_1 * eps1_3 - t1_2 * eps1_4;
  const T R1_23 = t1_2 * eps1_3 + t1_1 * eps1_4;
  const T minus_R1_33 = t1_1 * eps1_1 - T(1) + t1_2 * eps1_2;
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
  const T minus_Pddot1_3 = minus_R1_33 * T(9.81);
  own[frame::s_1] = t1_3;
  own[frame::s_2] = t1_4;
  own[frame::minus_U_11] = minus_U1_11;
  own[frame::U_12] = U1_12;
  own[frame::U_13] = U1_13;
  own[frame::s_3] = t1_5;
  own[frame::minus_U_22] = minus_U1_22;
  own[frame::U_23] = U1_23;
  own[frame::minus_U_33] = minus_U1_33;
  own[frame::Pddot_1] = Pddot1_1;
  own[frame::Pddot_2] = Pddot1_2;
  own[frame::Pddot_3] = -minus_Pddot1_3;
}

// body 2
template <class T>
[[gnu::noinline]] void outward_2(const T* x, const T* y, const Inputs<T>& u, T* frames) noexcept {
  const T* const of_1 = frames + 0;
  T* const own = frames + 63;
  const T eps1_3 = x[2];
  const T eps2_2 = x[5];
  const T eps1_2 = x[1];
  const T eps2_3 = x[6];
  const T eps1_4 = x[3];
  const T eps2_1 = x[4];
  const T eps2_4 = x[7];
  const T eps1_1 = x[0];
  const T omega2_3 = y[5];
  const T omega2_2 = y[4];
  const T omega2_1 = y[3];
  const T minus_U1_33 = of_1[frame::minus_U_33];
  const T U1_13 = of_1[frame::U_13];
  const T U1_23 = of_1[frame::U_23];
  const T Pddot1_3 = of_1[frame::Pddot_3];
  const T minus_U1_11 = of_1[frame::minus_U_11];
  const T U1_12 = of_1[frame::U_12];
  const T Pddot1_1 = of_1[frame::Pddot_1];
  const T minus_U1_22 = of_1[frame::minus_U_22];
  const T Pddot1_2 = of_1[frame::Pddot_2];
  const T s1_1 = of_1[frame::s_1];
  const T s1_2 = of_1[frame::s_2];
  const T s1_3 = of_1[frame::s_3];
  // erel2 = -e1~ e2 + eps4_1 e2 - eps4_2 e1: Euler parameters relative to the lower body
  const T erel2_1 = eps1_3 * eps2_2 - eps1_2 * eps2_3 + eps1_4 * eps2_1 - eps2_4 * eps1_1;
  const T erel2_2 = eps1_4 * eps2_2 - (eps1_3 * eps2_1 - eps1_1 * eps2_3) - eps2_4 * eps1_2;
  const T erel2_3 = eps1_2 * eps2_1 - eps1_1 * eps2_2 + eps1_4 * eps2_3 - eps2_4 * eps1_3;
  // eps4rel2 = e1 . e2 + eps4_1 eps4_2
  const T eps4rel2 = eps1_1 * eps2_1 + eps1_2 * eps2_2 + eps1_3 * eps2_3 + eps1_4 * eps2_4;
  // C2^T = 1 + 2 erel2~ (eps4rel2 + erel2~): C takes components in the lower body to those in the body
  const T t2_1 = T(2) * erel2_2;
  const T t2_2 = t2_1 * erel2_2;
  const T t2_3 = T(2) * erel2_3;
  const T t2_4 = t2_3 * erel2_3;
  const T minus_C2_11 = t2_2 - T(1) + t2_4;
  const T t2_5 = T(2) * erel2_1;
  const T t2_6 = t2_5 * erel2_2;
  const T t2_7 = t2_3 * eps4rel2;
  const T C2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * erel2_3;
  const T t2_9 = t2_1 * eps4rel2;
  const T C2_13 = t2_8 - t2_9;
  const T C2_21 = t2_6 - t2_7;
  const T t2_10 = t2_5 * erel2_1 - T(1);
  const T minus_C2_22 = t2_10 + t2_4;
  const T t2_11 = t2_1 * erel2_3;
  const T t2_12 = t2_5 * eps4rel2;
  const T C2_23 = t2_11 + t2_12;
  const T C2_31 = t2_8 + t2_9;
  const T C2_32 = t2_11 - t2_12;
  const T minus_C2_33 = t2_10 + t2_2;
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
  const T t2_16 = U1_23 * T(0.1);
  const T t2_17 = t2_16 + Pddot1_3 + U1_13 * T(0.3) - minus_U1_33 * T(0.1);
  const T t2_18 = Pddot1_1 + U1_12 * T(0.1) - minus_U1_11 * T(0.3) + U1_13 * T(0.1);
  const T t2_19 = t2_16 + Pddot1_2 + U1_12 * T(0.3) - minus_U1_22 * T(0.1);
  const T Pddot2_1 = C2_13 * t2_17 - (minus_C2_11 * t2_18 - C2_12 * t2_19);
  const T Pddot2_2 = C2_21 * t2_18 - minus_C2_22 * t2_19 + C2_23 * t2_17;
  const T Pddot2_3 = C2_31 * t2_18 + C2_32 * t2_19 - minus_C2_33 * t2_17;
  // N1 = -C2^T M_torque_2_ - h_all_1~ Pddot1 - omega1~ J_all_1 omega1 + M_torque_1_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T minus_N1_1 = C2_21 * u.tau_2_2 - (u.tau_1_1 + minus_C2_11 * u.tau_2_1) + C2_31 * u.tau_2_3 + T(0.34) *
      Pddot1_3 - T(0.17500000000000002) * Pddot1_2 - T(0.0027500000000000033) * U1_23 + T(0.027400000000000004) *
      (s1_1 - s1_2) - T(0.0382) * U1_12 + T(0.052500000000000005) * U1_13;
  const T minus_N1_2 = C2_32 * u.tau_2_3 - (minus_C2_22 * u.tau_2_2 - (C2_12 * u.tau_2_1 - u.tau_1_2)) +
      T(0.17500000000000002) * Pddot1_1 - T(0.47) * Pddot1_3 - T(0.08224999999999999) * U1_13 - T(0.0382) * (s1_1 -
      s1_3) - T(0.052500000000000005) * U1_23 + T(0.027400000000000004) * U1_12;
  const T N1_3 = minus_C2_33 * u.tau_2_3 - (C2_13 * u.tau_2_1 - u.tau_1_3 + C2_23 * u.tau_2_2) - T(0.47) * Pddot1_2 +
      T(0.34) * Pddot1_1 - T(0.08499999999999999) * U1_12 - T(0.052500000000000005) * (s1_2 - s1_3) +
      T(0.027400000000000004) * U1_13 - T(0.0382) * U1_23;
  // G2 = -U2 h_all_2: applied less inertia force, body axes [N]
  const T G2_1 = minus_U2_11 * T(0.12) - U2_12 * T(0.24) - U2_13 * T(0.06);
  const T G2_2 = minus_U2_22 * T(0.24) - U2_12 * T(0.12) - U2_23 * T(0.06);
  const T G2_3 = minus_U2_33 * T(0.06) - (U2_13 * T(0.12) + U2_23 * T(0.24));
  own[frame::s_1] = t2_13;
  own[frame::s_2] = t2_14;
  own[frame::minus_U_11] = minus_U2_11;
  own[frame::U_12] = U2_12;
  own[frame::U_13] = U2_13;
  own[frame::s_3] = t2_15;
  own[frame::minus_U_22] = minus_U2_22;
  own[frame::U_23] = U2_23;
  own[frame::minus_U_33] = minus_U2_33;
  own[frame::Pddot_1] = Pddot2_1;
  own[frame::Pddot_2] = Pddot2_2;
  own[frame::Pddot_3] = Pddot2_3;
  own[frame::minus_C_11] = minus_C2_11;
  own[frame::C_12] = C2_12;
  own[frame::C_13] = C2_13;
  own[frame::C_21] = C2_21;
  own[frame::minus_C_22] = minus_C2_22;
  own[frame::C_23] = C2_23;
  own[frame::C_31] = C2_31;
  own[frame::C_32] = C2_32;
  own[frame::minus_C_33] = minus_C2_33;
  own[frame::N1_1] = -minus_N1_1;
  own[frame::N1_2] = -minus_N1_2;
  own[frame::N1_3] = N1_3;
  own[frame::G_1] = G2_1;
  own[frame::G_2] = G2_2;
  own[frame::G_3] = G2_3;
}

// bodies 3, 9, 12, 15, 18, 21, 24, 27, 30
template <class T>
[[gnu::noinline]] void outward_3(const T* x, const T* y, const T* inputs, T* frames, int row) noexcept {
  const auto& [L, K, x_at, y_at, u_at] = outward_3_places[row];
  const auto& k = outward_3_numbers<Number<T>>[row];
  const T* const of_L = frames + L;
  T* const own = frames + K;
  const T epsL_3 = x[x_at + 2];
  const T epsK_2 = x[x_at + 5];
  const T epsL_2 = x[x_at + 1];
  const T epsK_3 = x[x_at + 6];
  const T epsL_4 = x[x_at + 3];
  const T epsK_1 = x[x_at + 4];
  const T epsK_4 = x[x_at + 7];
  const T epsL_1 = x[x_at];
  const T omegaK_3 = y[y_at + 2];
  const T omegaK_2 = y[y_at + 1];
  const T omegaK_1 = y[y_at];
  const T minus_UL_33 = of_L[frame::minus_U_33];
  const T UL_23 = of_L[frame::U_23];
  const T UL_13 = of_L[frame::U_13];
  const T PddotL_3 = of_L[frame::Pddot_3];
  const T minus_UL_11 = of_L[frame::minus_U_11];
  const T UL_12 = of_L[frame::U_12];
  const T PddotL_1 = of_L[frame::Pddot_1];
  const T minus_UL_22 = of_L[frame::minus_U_22];
  const T PddotL_2 = of_L[frame::Pddot_2];
  const T sL_1 = of_L[frame::s_1];
  const T sL_2 = of_L[frame::s_2];
  const T tau_K_2 = inputs[u_at];
  const T tau_K_1 = inputs[u_at + 9];
  const T tau_L_1 = inputs[u_at + 18];
  const T tau_K_3 = inputs[u_at + 27];
  const T sL_3 = of_L[frame::s_3];
  const T tau_L_2 = inputs[u_at + 36];
  const T tau_L_3 = inputs[u_at + 45];
  // erelK = -eL~ eK + eps4_L eK - eps4_K eL: Euler parameters relative to the lower body
  const T erelK_1 = epsL_3 * epsK_2 - epsL_2 * epsK_3 + epsL_4 * epsK_1 - epsK_4 * epsL_1;
  const T erelK_2 = epsL_4 * epsK_2 - (epsL_3 * epsK_1 - epsL_1 * epsK_3) - epsK_4 * epsL_2;
  const T erelK_3 = epsL_2 * epsK_1 - epsL_1 * epsK_2 + epsL_4 * epsK_3 - epsK_4 * epsL_3;
  // eps4relK = eL . eK + eps4_L eps4_K
  const T eps4rel3 = epsL_1 * epsK_1 + epsL_2 * epsK_2 + epsL_3 * epsK_3 + epsL_4 * epsK_4;
  // CK^T = 1 + 2 erelK~ (eps4relK + erelK~): C takes components in the lower body to those in the body
  const T tK_1 = T(2) * erelK_2;
  const T tK_2 = tK_1 * erelK_2;
  const T tK_3 = T(2) * erelK_3;
  const T tK_4 = tK_3 * erelK_3;
  const T minus_CK_11 = tK_2 - T(1) + tK_4;
  const T tK_5 = T(2) * erelK_1;
  const T tK_6 = tK_5 * erelK_2;
  const T tK_7 = tK_3 * eps4rel3;
  const T CK_12 = tK_6 + tK_7;
  const T tK_8 = tK_5 * erelK_3;
  const T tK_9 = tK_1 * eps4rel3;
  const T CK_13 = tK_8 - tK_9;
  const T CK_21 = tK_6 - tK_7;
  const T tK_10 = tK_5 * erelK_1 - T(1);
  const T minus_CK_22 = tK_10 + tK_4;
  const T tK_11 = tK_1 * erelK_3;
  const T tK_12 = tK_5 * eps4rel3;
  const T CK_23 = tK_11 + tK_12;
  const T CK_31 = tK_8 + tK_9;
  const T CK_32 = tK_11 - tK_12;
  const T minus_CK_33 = tK_10 + tK_2;
  // UK = omegaK~ omegaK~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T tK_13 = omegaK_3 * omegaK_3;
  const T tK_14 = omegaK_2 * omegaK_2;
  const T minus_UK_11 = tK_13 + tK_14;
  const T UK_12 = omegaK_2 * omegaK_1;
  const T UK_13 = omegaK_3 * omegaK_1;
  const T tK_15 = omegaK_1 * omegaK_1;
  const T minus_UK_22 = tK_13 + tK_15;
  const T UK_23 = omegaK_3 * omegaK_2;
  const T minus_UK_33 = tK_14 + tK_15;
  // PddotK = CK (UL qK + PddotL): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T tK_16 = PddotL_3 + UL_13 * T(0.3) + UL_23 * T(k[0]) - minus_UL_33 * T(0.1);
  const T tK_17 = PddotL_1 + UL_12 * T(k[0]) - minus_UL_11 * T(0.3) + UL_13 * T(0.1);
  const T tK_18 = PddotL_2 + UL_12 * T(0.3) + minus_UL_22 * T(k[1]) + UL_23 * T(0.1);
  const T PddotK_1 = CK_13 * tK_16 - (minus_CK_11 * tK_17 - CK_12 * tK_18);
  const T PddotK_2 = CK_21 * tK_17 - minus_CK_22 * tK_18 + CK_23 * tK_16;
  const T PddotK_3 = CK_31 * tK_17 + CK_32 * tK_18 - minus_CK_33 * tK_16;
  // NL = -CK^T M_torque_K_ - h_all_L~ PddotL - omegaL~ J_all_L omegaL + M_torque_L_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N2_1 = T(k[2]) * UL_13 - (CK_21 * tau_K_2 - (tau_L_1 + minus_CK_11 * tau_K_1) + CK_31 * tau_K_3 + T(k[7]) *
      PddotL_3 + T(k[6]) * PddotL_2 + T(k[5]) * UL_23 + T(k[4]) * (sL_1 - sL_2) + T(k[3]) * UL_12);
  const T N2_2 = T(k[8]) * UL_12 - (CK_32 * tau_K_3 - (minus_CK_22 * tau_K_2 - (CK_12 * tau_K_1 - tau_L_2)) + T(k[11])
      * PddotL_1 + T(k[10]) * PddotL_3 + T(k[9]) * UL_13 + T(k[3]) * (sL_1 - sL_3) + T(k[2]) * UL_23);
  const T N2_3 = minus_CK_33 * tau_K_3 - (CK_13 * tau_K_1 - tau_L_3 + CK_23 * tau_K_2) + T(k[10]) * PddotL_2 + T(k[7])
      * PddotL_1 + T(k[12]) * UL_12 + T(k[2]) * (sL_2 - sL_3) + T(k[4]) * UL_13 + T(k[3]) * UL_23;
  // GK = -m_all_K PddotK - UK h_all_K: applied less inertia force, body axes [N]
  const T GK_1 = T(k[14]) * PddotK_1 + UK_12 * T(k[13]) + minus_UK_11 * T(k[15]) + UK_13 * T(k[16]);
  const T GK_2 = T(k[14]) * PddotK_2 + UK_12 * T(k[17]) + minus_UK_22 * T(k[18]) + UK_23 * T(k[16]);
  const T GK_3 = T(k[14]) * PddotK_3 + UK_13 * T(k[17]) + UK_23 * T(k[13]) + minus_UK_33 * T(k[19]);
  own[frame::s_1] = tK_13;
  own[frame::s_2] = tK_14;
  own[frame::minus_U_11] = minus_UK_11;
  own[frame::U_12] = UK_12;
  own[frame::U_13] = UK_13;
  own[frame::s_3] = tK_15;
  own[frame::minus_U_22] = minus_UK_22;
  own[frame::U_23] = UK_23;
  own[frame::minus_U_33] = minus_UK_33;
  own[frame::Pddot_1] = PddotK_1;
  own[frame::Pddot_2] = PddotK_2;
  own[frame::Pddot_3] = PddotK_3;
  own[frame::minus_C_11] = minus_CK_11;
  own[frame::C_12] = CK_12;
  own[frame::C_13] = CK_13;
  own[frame::C_21] = CK_21;
  own[frame::minus_C_22] = minus_CK_22;
  own[frame::C_23] = CK_23;
  own[frame::C_31] = CK_31;
  own[frame::C_32] = CK_32;
  own[frame::minus_C_33] = minus_CK_33;
  own[frame::G_1] = GK_1;
  own[frame::G_2] = GK_2;
  own[frame::G_3] = GK_3;
  own[frame::N2_1] = N2_1;
  own[frame::N2_2] = N2_2;
  own[frame::N2_3] = N2_3;
}

// bodies 4, 5, 7, 8, 10, 11, 13, 14, 16, 17, 19, 22, 23, 25, 26, 28, 29, 31
template <class T>
[[gnu::noinline]] void outward_4(const T* x, const T* y, const T* inputs, T* frames, int row) noexcept {
  const auto& [L, K, x_at, y_at, u_at, u_at2, u_at3, u_at4, u_at5, u_at6] = outward_4_places[row];
  const auto& k = outward_4_numbers<Number<T>>[row];
  const T* const of_L = frames + L;
  T* const own = frames + K;
  const T epsL_3 = x[x_at + 2];
  const T epsK_2 = x[x_at + 5];
  const T epsL_2 = x[x_at + 1];
  const T epsK_3 = x[x_at + 6];
  const T epsL_4 = x[x_at + 3];
  const T epsK_1 = x[x_at + 4];
  const T epsK_4 = x[x_at + 7];
  const T epsL_1 = x[x_at];
  const T omegaK_3 = y[y_at + 2];
  const T omegaK_2 = y[y_at + 1];
  const T omegaK_1 = y[y_at];
  const T minus_UL_33 = of_L[frame::minus_U_33];
  const T UL_23 = of_L[frame::U_23];
  const T UL_13 = of_L[frame::U_13];
  const T PddotL_3 = of_L[frame::Pddot_3];
  const T minus_UL_11 = of_L[frame::minus_U_11];
  const T UL_12 = of_L[frame::U_12];
  const T PddotL_1 = of_L[frame::Pddot_1];
  const T minus_UL_22 = of_L[frame::minus_U_22];
  const T PddotL_2 = of_L[frame::Pddot_2];
  const T sL_1 = of_L[frame::s_1];
  const T sL_2 = of_L[frame::s_2];
  const T tau_K_2 = inputs[u_at];
  const T tau_K_1 = inputs[u_at2];
  const T tau_L_1 = inputs[u_at3];
  const T tau_K_3 = inputs[u_at4];
  const T sL_3 = of_L[frame::s_3];
  const T tau_L_2 = inputs[u_at5];
  const T tau_L_3 = inputs[u_at6];
  // erelK = -eL~ eK + epsK_L eK - epsK_K eL: Euler parameters relative to the lower body
  const T erelK_1 = epsL_3 * epsK_2 - epsL_2 * epsK_3 + epsL_4 * epsK_1 - epsK_4 * epsL_1;
  const T erelK_2 = epsL_4 * epsK_2 - (epsL_3 * epsK_1 - epsL_1 * epsK_3) - epsK_4 * epsL_2;
  const T erelK_3 = epsL_2 * epsK_1 - epsL_1 * epsK_2 + epsL_4 * epsK_3 - epsK_4 * epsL_3;
  // epsKrelK = eL . eK + epsK_L epsK_K
  const T epsKrel4 = epsL_1 * epsK_1 + epsL_2 * epsK_2 + epsL_3 * epsK_3 + epsL_4 * epsK_4;
  // CK^T = 1 + 2 erelK~ (epsKrelK + erelK~): C takes components in the lower body to those in the body
  const T tK_1 = T(2) * erelK_2;
  const T tK_2 = tK_1 * erelK_2;
  const T tK_3 = T(2) * erelK_3;
  const T tK_4 = tK_3 * erelK_3;
  const T minus_CK_11 = tK_2 - T(1) + tK_4;
  const T tK_5 = T(2) * erelK_1;
  const T tK_6 = tK_5 * erelK_2;
  const T tK_7 = tK_3 * epsKrel4;
  const T CK_12 = tK_6 + tK_7;
  const T tK_8 = tK_5 * erelK_3;
  const T tK_9 = tK_1 * epsKrel4;
  const T CK_13 = tK_8 - tK_9;
  const T CK_21 = tK_6 - tK_7;
  const T tK_10 = tK_5 * erelK_1 - T(1);
  const T minus_CK_22 = tK_10 + tK_4;
  const T tK_11 = tK_1 * erelK_3;
  const T tK_12 = tK_5 * epsKrel4;
  const T CK_23 = tK_11 + tK_12;
  const T CK_31 = tK_8 + tK_9;
  const T CK_32 = tK_11 - tK_12;
  const T minus_CK_33 = tK_10 + tK_2;
  // UK = omegaK~ omegaK~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T tK_13 = omegaK_3 * omegaK_3;
  const T tK_14 = omegaK_2 * omegaK_2;
  const T minus_UK_11 = tK_13 + tK_14;
  const T UK_12 = omegaK_2 * omegaK_1;
  const T UK_13 = omegaK_3 * omegaK_1;
  const T tK_15 = omegaK_1 * omegaK_1;
  const T minus_UK_22 = tK_13 + tK_15;
  const T UK_23 = omegaK_3 * omegaK_2;
  const T minus_UK_33 = tK_14 + tK_15;
  // PddotK = CK (UL qK + PddotL): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T tK_16 = PddotL_3 + UL_13 * T(0.3) + UL_23 * T(k[0]) - minus_UL_33 * T(0.1);
  const T tK_17 = PddotL_1 + UL_12 * T(k[0]) - minus_UL_11 * T(0.3) + UL_13 * T(0.1);
  const T tK_18 = PddotL_2 + UL_12 * T(0.3) + minus_UL_22 * T(k[1]) + UL_23 * T(0.1);
  const T PddotK_1 = CK_13 * tK_16 - (minus_CK_11 * tK_17 - CK_12 * tK_18);
  const T PddotK_2 = CK_21 * tK_17 - minus_CK_22 * tK_18 + CK_23 * tK_16;
  const T PddotK_3 = CK_31 * tK_17 + CK_32 * tK_18 - minus_CK_33 * tK_16;
  // NL = -CK^T M_torque_K_ - h_all_L~ PddotL - omegaL~ J_all_L omegaL + M_torque_L_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N3_1 = T(k[2]) * UL_13 - (CK_21 * tau_K_2 - (tau_L_1 + minus_CK_11 * tau_K_1) + CK_31 * tau_K_3 + T(k[7]) *
      PddotL_3 + T(k[6]) * PddotL_2 + T(k[5]) * UL_23 + T(k[4]) * (sL_1 - sL_2) + T(k[3]) * UL_12);
  const T N3_2 = T(k[8]) * UL_12 - (CK_32 * tau_K_3 - (minus_CK_22 * tau_K_2 - (CK_12 * tau_K_1 - tau_L_2)) + T(k[11])
      * PddotL_1 + T(k[10]) * PddotL_3 + T(k[9]) * UL_13 + T(k[3]) * (sL_1 - sL_3) + T(k[2]) * UL_23);
  const T N3_3 = minus_CK_33 * tau_K_3 - (CK_13 * tau_K_1 - tau_L_3 + CK_23 * tau_K_2) + T(k[10]) * PddotL_2 + T(k[7])
      * PddotL_1 + T(k[12]) * UL_12 + T(k[2]) * (sL_2 - sL_3) + T(k[4]) * UL_13 + T(k[3]) * UL_23;
  // GK = -UK h_all_K: applied less inertia force, body axes [N]
  const T GK_1 = UK_12 * T(k[14]) + minus_UK_11 * T(k[15]) + UK_13 * T(k[13]);
  const T GK_2 = UK_12 * T(k[16]) + minus_UK_22 * T(k[17]) + UK_23 * T(k[13]);
  const T GK_3 = UK_13 * T(k[16]) + UK_23 * T(k[14]) + minus_UK_33 * T(k[18]);
  own[frame::s_1] = tK_13;
  own[frame::s_2] = tK_14;
  own[frame::minus_U_11] = minus_UK_11;
  own[frame::U_12] = UK_12;
  own[frame::U_13] = UK_13;
  own[frame::s_3] = tK_15;
  own[frame::minus_U_22] = minus_UK_22;
  own[frame::U_23] = UK_23;
  own[frame::minus_U_33] = minus_UK_33;
  own[frame::Pddot_1] = PddotK_1;
  own[frame::Pddot_2] = PddotK_2;
  own[frame::Pddot_3] = PddotK_3;
  own[frame::minus_C_11] = minus_CK_11;
  own[frame::C_12] = CK_12;
  own[frame::C_13] = CK_13;
  own[frame::C_21] = CK_21;
  own[frame::minus_C_22] = minus_CK_22;
  own[frame::C_23] = CK_23;
  own[frame::C_31] = CK_31;
  own[frame::C_32] = CK_32;
  own[frame::minus_C_33] = minus_CK_33;
  own[frame::G_1] = GK_1;
  own[frame::G_2] = GK_2;
  own[frame::G_3] = GK_3;
  own[frame::N3_1] = N3_1;
  own[frame::N3_2] = N3_2;
  own[frame::N3_3] = N3_3;
}

// body 6
template <class T>
[[gnu::noinline]] void outward_5(const T* x, const T* y, const Inputs<T>& u, T* frames) noexcept {
  const T* const of_5 = frames + 261;
  T* const own = frames + 327;
  const T eps5_3 = x[18];
  const T eps6_2 = x[21];
  const T eps5_2 = x[17];
  const T eps6_3 = x[22];
  const T eps5_4 = x[19];
  const T eps6_1 = x[20];
  const T eps6_4 = x[23];
  const T eps5_1 = x[16];
  const T omega6_3 = y[17];
  const T omega6_2 = y[16];
  const T omega6_1 = y[15];
  const T minus_U5_33 = of_5[frame::minus_U_33];
  const T U5_23 = of_5[frame::U_23];
  const T U5_13 = of_5[frame::U_13];
  const T Pddot5_3 = of_5[frame::Pddot_3];
  const T minus_U5_11 = of_5[frame::minus_U_11];
  const T U5_12 = of_5[frame::U_12];
  const T Pddot5_1 = of_5[frame::Pddot_1];
  const T minus_U5_22 = of_5[frame::minus_U_22];
  const T Pddot5_2 = of_5[frame::Pddot_2];
  const T s5_1 = of_5[frame::s_1];
  const T s5_2 = of_5[frame::s_2];
  const T s5_3 = of_5[frame::s_3];
  // erel6 = -e5~ e6 + eps4_5 e6 - eps4_6 e5: Euler parameters relative to the lower body
  const T erel6_1 = eps5_3 * eps6_2 - eps5_2 * eps6_3 + eps5_4 * eps6_1 - eps6_4 * eps5_1;
  const T erel6_2 = eps5_4 * eps6_2 - (eps5_3 * eps6_1 - eps5_1 * eps6_3) - eps6_4 * eps5_2;
  const T erel6_3 = eps5_2 * eps6_1 - eps5_1 * eps6_2 + eps5_4 * eps6_3 - eps6_4 * eps5_3;
  // eps4rel6 = e5 . e6 + eps4_5 eps4_6
  const T eps4rel6 = eps5_1 * eps6_1 + eps5_2 * eps6_2 + eps5_3 * eps6_3 + eps5_4 * eps6_4;
  // C6^T = 1 + 2 erel6~ (eps4rel6 + erel6~): C takes components in the lower body to those in the body
  const T t6_1 = T(2) * erel6_2;
  const T t6_2 = t6_1 * erel6_2;
  const T t6_3 = T(2) * erel6_3;
  const T t6_4 = t6_3 * erel6_3;
  const T minus_C6_11 = t6_2 - T(1) + t6_4;
  const T t6_5 = T(2) * erel6_1;
  const T t6_6 = t6_5 * erel6_2;
  const T t6_7 = t6_3 * eps4rel6;
  const T C6_12 = t6_6 + t6_7;
  const T t6_8 = t6_5 * erel6_3;
  const T t6_9 = t6_1 * eps4rel6;
  const T C6_13 = t6_8 - t6_9;
  const T C6_21 = t6_6 - t6_7;
  const T t6_10 = t6_5 * erel6_1 - T(1);
  const T minus_C6_22 = t6_10 + t6_4;
  const T t6_11 = t6_1 * erel6_3;
  const T t6_12 = t6_5 * eps4rel6;
  const T C6_23 = t6_11 + t6_12;
  const T C6_31 = t6_8 + t6_9;
  const T C6_32 = t6_11 - t6_12;
  const T minus_C6_33 = t6_10 + t6_2;
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
  const T t6_16 = Pddot5_3 + U5_13 * T(0.3) + U5_23 * T(0.3) - minus_U5_33 * T(0.1);
  const T t6_17 = U5_12 * T(0.3);
  const T t6_18 = t6_17 + Pddot5_1 - minus_U5_11 * T(0.3) + U5_13 * T(0.1);
  const T t6_19 = t6_17 + Pddot5_2 - minus_U5_22 * T(0.3) + U5_23 * T(0.1);
  const T Pddot6_1 = C6_13 * t6_16 - (minus_C6_11 * t6_18 - C6_12 * t6_19);
  const T Pddot6_2 = C6_21 * t6_18 - minus_C6_22 * t6_19 + C6_23 * t6_16;
  const T Pddot6_3 = C6_31 * t6_18 + C6_32 * t6_19 - minus_C6_33 * t6_16;
  // N5 = -C6^T M_torque_6_ - h_all_5~ Pddot5 - omega5~ J_all_5 omega5 + M_torque_5_: applied less inertia moment
  //   about the body origin, body axes [N m]
  const T minus_N5_1 = C6_21 * u.tau_6_2 - (u.tau_5_1 + minus_C6_11 * u.tau_6_1) + C6_31 * u.tau_6_3 +
      T(0.30000000000000004) * Pddot5_3 - T(0.07500000000000001) * Pddot5_2 - T(0.0037499999999999916) * U5_23 +
      T(0.021) * (s5_1 - s5_2) - T(0.0030000000000000014) * U5_12 + T(0.022500000000000003) * U5_13;
  const T minus_N5_2 = C6_32 * u.tau_6_3 - (minus_C6_22 * u.tau_6_2 - (C6_12 * u.tau_6_1 - u.tau_5_2)) +
      T(0.07500000000000001) * Pddot5_1 - T(0.15000000000000002) * Pddot5_3 + T(0.01875) * U5_13 -
      T(0.0030000000000000014) * (s5_1 - s5_3) - T(0.022500000000000003) * U5_23 + T(0.021) * U5_12;
  const T N5_3 = minus_C6_33 * u.tau_6_3 - (C6_13 * u.tau_6_1 - u.tau_5_3 + C6_23 * u.tau_6_2) -
      T(0.15000000000000002) * Pddot5_2 + T(0.30000000000000004) * Pddot5_1 + T(0.015000000000000006) * U5_12 -
      T(0.022500000000000003) * (s5_2 - s5_3) + T(0.021) * U5_13 - T(0.0030000000000000014) * U5_23;
  // G6 = -m_all_6 Pddot6 - U6 h_all_6: applied less inertia force, body axes [N]
  const T G6_1 = minus_U6_11 * T(1.21) - (T(5.1) * Pddot6_1 + U6_12 * T(1.545)) - U6_13 * T(0.43000000000000005);
  const T G6_2 = minus_U6_22 * T(1.545) - (T(5.1) * Pddot6_2 + U6_12 * T(1.21)) - U6_23 * T(0.43000000000000005);
  const T G6_3 = minus_U6_33 * T(0.43000000000000005) - (T(5.1) * Pddot6_3 + U6_13 * T(1.21) + U6_23 * T(1.545));
  own[frame::s_1] = t6_13;
  own[frame::s_2] = t6_14;
  own[frame::minus_U_11] = minus_U6_11;
  own[frame::U_12] = U6_12;
  own[frame::U_13] = U6_13;
  own[frame::s_3] = t6_15;
  own[frame::minus_U_22] = minus_U6_22;
  own[frame::U_23] = U6_23;
  own[frame::minus_U_33] = minus_U6_33;
  own[frame::Pddot_1] = Pddot6_1;
  own[frame::Pddot_2] = Pddot6_2;
  own[frame::Pddot_3] = Pddot6_3;
  own[frame::minus_C_11] = minus_C6_11;
  own[frame::C_12] = C6_12;
  own[frame::C_13] = C6_13;
  own[frame::C_21] = C6_21;
  own[frame::minus_C_22] = minus_C6_22;
  own[frame::C_23] = C6_23;
  own[frame::C_31] = C6_31;
  own[frame::C_32] = C6_32;
  own[frame::minus_C_33] = minus_C6_33;
  own[frame::G_1] = G6_1;
  own[frame::G_2] = G6_2;
  own[frame::G_3] = G6_3;
  own[frame::N5_1] = -minus_N5_1;
  own[frame::N5_2] = -minus_N5_2;
  own[frame::N5_3] = N5_3;
}

// body 20
template <class T>
[[gnu::noinline]] void outward_6(const T* x, const T* y, const Inputs<T>& u, T* frames) noexcept {
  const T* const of_19 = frames + 1185;
  T* const own = frames + 1251;
  const T eps19_3 = x[74];
  const T eps20_2 = x[77];
  const T eps19_2 = x[73];
  const T eps20_3 = x[78];
  const T eps19_4 = x[75];
  const T eps20_1 = x[76];
  const T eps20_4 = x[79];
  const T eps19_1 = x[72];
  const T omega20_3 = y[59];
  const T omega20_2 = y[58];
  const T omega20_1 = y[57];
  const T minus_U19_33 = of_19[frame::minus_U_33];
  const T U19_13 = of_19[frame::U_13];
  const T U19_23 = of_19[frame::U_23];
  const T Pddot19_3 = of_19[frame::Pddot_3];
  const T U19_12 = of_19[frame::U_12];
  const T minus_U19_22 = of_19[frame::minus_U_22];
  const T Pddot19_2 = of_19[frame::Pddot_2];
  const T minus_U19_11 = of_19[frame::minus_U_11];
  const T Pddot19_1 = of_19[frame::Pddot_1];
  const T s19_1 = of_19[frame::s_1];
  const T s19_2 = of_19[frame::s_2];
  const T s19_3 = of_19[frame::s_3];
  // erel20 = -e19~ e20 + eps4_19 e20 - eps4_20 e19: Euler parameters relative to the lower body
  const T erel20_1 = eps19_3 * eps20_2 - eps19_2 * eps20_3 + eps19_4 * eps20_1 - eps20_4 * eps19_1;
  const T erel20_2 = eps19_4 * eps20_2 - (eps19_3 * eps20_1 - eps19_1 * eps20_3) - eps20_4 * eps19_2;
  const T erel20_3 = eps19_2 * eps20_1 - eps19_1 * eps20_2 + eps19_4 * eps20_3 - eps20_4 * eps19_3;
  // eps4rel20 = e19 . e20 + eps4_19 eps4_20
  const T eps4rel20 = eps19_1 * eps20_1 + eps19_2 * eps20_2 + eps19_3 * eps20_3 + eps19_4 * eps20_4;
  // C20^T = 1 + 2 erel20~ (eps4rel20 + erel20~): C takes components in the lower body to those in the body
  const T t20_1 = T(2) * erel20_2;
  const T t20_2 = t20_1 * erel20_2;
  const T t20_3 = T(2) * erel20_3;
  const T t20_4 = t20_3 * erel20_3;
  const T minus_C20_11 = t20_2 - T(1) + t20_4;
  const T t20_5 = T(2) * erel20_1;
  const T t20_6 = t20_5 * erel20_2;
  const T t20_7 = t20_3 * eps4rel20;
  const T C20_12 = t20_6 + t20_7;
  const T t20_8 = t20_5 * erel20_3;
  const T t20_9 = t20_1 * eps4rel20;
  const T C20_13 = t20_8 - t20_9;
  const T C20_21 = t20_6 - t20_7;
  const T t20_10 = t20_5 * erel20_1 - T(1);
  const T minus_C20_22 = t20_10 + t20_4;
  const T t20_11 = t20_1 * erel20_3;
  const T t20_12 = t20_5 * eps4rel20;
  const T C20_23 = t20_11 + t20_12;
  const T C20_31 = t20_8 + t20_9;
  const T C20_32 = t20_11 - t20_12;
  const T minus_C20_33 = t20_10 + t20_2;
  // U20 = omega20~ omega20~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t20_13 = omega20_3 * omega20_3;
  const T t20_14 = omega20_2 * omega20_2;
  const T minus_U20_11 = t20_13 + t20_14;
  const T U20_12 = omega20_2 * omega20_1;
  const T U20_13 = omega20_3 * omega20_1;
  const T t20_15 = omega20_1 * omega20_1;
  const T minus_U20_22 = t20_13 + t20_15;
  const T U20_23 = omega20_3 * omega20_2;
  const T minus_U20_33 = t20_14 + t20_15;
  // Pddot20 = C20 (U19 q20 + Pddot19): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t20_16 = U19_23 + Pddot19_3 + U19_13 * T(0.3) - minus_U19_33 * T(0.1);
  const T t20_17 = U19_12 + Pddot19_1 - minus_U19_11 * T(0.3) + U19_13 * T(0.1);
  const T t20_18 = minus_U19_22 - Pddot19_2 - U19_12 * T(0.3) - U19_23 * T(0.1);
  const T Pddot20_1 = C20_13 * t20_16 - (minus_C20_11 * t20_17 + C20_12 * t20_18);
  const T Pddot20_2 = C20_21 * t20_17 + minus_C20_22 * t20_18 + C20_23 * t20_16;
  const T Pddot20_3 = C20_31 * t20_17 - C20_32 * t20_18 - minus_C20_33 * t20_16;
  // N19 = -C20^T M_torque_20_ - h_all_19~ Pddot19 - omega19~ J_all_19 omega19 + M_torque_19_: applied less inertia
  //   moment about the body origin, body axes [N m]
  const T minus_N19_1 = C20_21 * u.tau_20_2 - (u.tau_19_1 + minus_C20_11 * u.tau_20_1) + C20_31 * u.tau_20_3 + T(3.58)
      * Pddot19_3 - T(0.445) * Pddot19_2 + T(2.96275) * U19_23 + T(0.3406) * (s19_1 - s19_2) - T(0.09580000000000001)
      * U19_12 + T(0.9435) * U19_13;
  const T minus_N19_2 = C20_32 * u.tau_20_3 - (minus_C20_22 * u.tau_20_2 - (C20_12 * u.tau_20_1 - u.tau_19_2)) +
      T(0.445) * Pddot19_1 - T(1.19) * Pddot19_3 - T(0.20375000000000001) * U19_13 - T(0.09580000000000001) * (s19_1 -
      s19_3) - T(0.9435) * U19_23 + T(0.3406) * U19_12;
  const T N19_3 = minus_C20_33 * u.tau_20_3 - (C20_13 * u.tau_20_1 - u.tau_19_3 + C20_23 * u.tau_20_2) - T(1.19) *
      Pddot19_2 + T(3.58) * Pddot19_1 + T(2.759) * U19_12 - T(0.9435) * (s19_2 - s19_3) + T(0.3406) * U19_13 -
      T(0.09580000000000001) * U19_23;
  // G20 = -U20 h_all_20: applied less inertia force, body axes [N]
  const T G20_1 = minus_U20_11 * T(0.30000000000000004) - U20_12 * T(0.6000000000000001) - U20_13 *
      T(0.15000000000000002);
  const T G20_2 = minus_U20_22 * T(0.6000000000000001) - U20_12 * T(0.30000000000000004) - U20_23 *
      T(0.15000000000000002);
  const T G20_3 = minus_U20_33 * T(0.15000000000000002) - (U20_13 * T(0.30000000000000004) + U20_23 *
      T(0.6000000000000001));
  own[frame::s_1] = t20_13;
  own[frame::s_2] = t20_14;
  own[frame::minus_U_11] = minus_U20_11;
  own[frame::U_12] = U20_12;
  own[frame::U_13] = U20_13;
  own[frame::s_3] = t20_15;
  own[frame::minus_U_22] = minus_U20_22;
  own[frame::U_23] = U20_23;
  own[frame::minus_U_33] = minus_U20_33;
  own[frame::Pddot_1] = Pddot20_1;
  own[frame::Pddot_2] = Pddot20_2;
  own[frame::Pddot_3] = Pddot20_3;
  own[frame::minus_C_11] = minus_C20_11;
  own[frame::C_12] = C20_12;
  own[frame::C_13] = C20_13;
  own[frame::C_21] = C20_21;
  own[frame::minus_C_22] = minus_C20_22;
  own[frame::C_23] = C20_23;
  own[frame::C_31] = C20_31;
  own[frame::C_32] = C20_32;
  own[frame::minus_C_33] = minus_C20_33;
  own[frame::G_1] = G20_1;
  own[frame::G_2] = G20_2;
  own[frame::G_3] = G20_3;
  own[frame::N19_1] = -minus_N19_1;
  own[frame::N19_2] = -minus_N19_2;
  own[frame::N19_3] = N19_3;
}

// body 32
template <class T>
[[gnu::noinline]] void outward_7(const T* x, const T* y, const Inputs<T>& u, T* frames) noexcept {
  const T* const of_31 = frames + 1977;
  T* const own = frames + 2043;
  const T eps31_3 = x[122];
  const T eps32_2 = x[125];
  const T eps31_2 = x[121];
  const T eps32_3 = x[126];
  const T eps31_4 = x[123];
  const T eps32_1 = x[124];
  const T eps32_4 = x[127];
  const T eps31_1 = x[120];
  const T omega32_3 = y[95];
  const T omega32_2 = y[94];
  const T omega32_1 = y[93];
  const T minus_U31_33 = of_31[frame::minus_U_33];
  const T U31_23 = of_31[frame::U_23];
  const T U31_13 = of_31[frame::U_13];
  const T Pddot31_3 = of_31[frame::Pddot_3];
  const T minus_U31_11 = of_31[frame::minus_U_11];
  const T U31_12 = of_31[frame::U_12];
  const T Pddot31_1 = of_31[frame::Pddot_1];
  const T minus_U31_22 = of_31[frame::minus_U_22];
  const T Pddot31_2 = of_31[frame::Pddot_2];
  const T s31_1 = of_31[frame::s_1];
  const T s31_2 = of_31[frame::s_2];
  const T s31_3 = of_31[frame::s_3];
  // erel32 = -e31~ e32 + eps4_31 e32 - eps4_32 e31: Euler parameters relative to the lower body
  const T erel32_1 = eps31_3 * eps32_2 - eps31_2 * eps32_3 + eps31_4 * eps32_1 - eps32_4 * eps31_1;
  const T erel32_2 = eps31_4 * eps32_2 - (eps31_3 * eps32_1 - eps31_1 * eps32_3) - eps32_4 * eps31_2;
  const T erel32_3 = eps31_2 * eps32_1 - eps31_1 * eps32_2 + eps31_4 * eps32_3 - eps32_4 * eps31_3;
  // eps4rel32 = e31 . e32 + eps4_31 eps4_32
  const T eps4rel32 = eps31_1 * eps32_1 + eps31_2 * eps32_2 + eps31_3 * eps32_3 + eps31_4 * eps32_4;
  // C32^T = 1 + 2 erel32~ (eps4rel32 + erel32~): C takes components in the lower body to those in the body
  const T t32_1 = T(2) * erel32_2;
  const T t32_2 = t32_1 * erel32_2;
  const T t32_3 = T(2) * erel32_3;
  const T t32_4 = t32_3 * erel32_3;
  const T minus_C32_11 = t32_2 - T(1) + t32_4;
  const T t32_5 = T(2) * erel32_1;
  const T t32_6 = t32_5 * erel32_2;
  const T t32_7 = t32_3 * eps4rel32;
  const T C32_12 = t32_6 + t32_7;
  const T t32_8 = t32_5 * erel32_3;
  const T t32_9 = t32_1 * eps4rel32;
  const T C32_13 = t32_8 - t32_9;
  const T C32_21 = t32_6 - t32_7;
  const T t32_10 = t32_5 * erel32_1 - T(1);
  const T minus_C32_22 = t32_10 + t32_4;
  const T t32_11 = t32_1 * erel32_3;
  const T t32_12 = t32_5 * eps4rel32;
  const T C32_23 = t32_11 + t32_12;
  const T C32_31 = t32_8 + t32_9;
  const T C32_32 = t32_11 - t32_12;
  const T minus_C32_33 = t32_10 + t32_2;
  // U32 = omega32~ omega32~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t32_13 = omega32_3 * omega32_3;
  const T t32_14 = omega32_2 * omega32_2;
  const T minus_U32_11 = t32_13 + t32_14;
  const T U32_12 = omega32_2 * omega32_1;
  const T U32_13 = omega32_3 * omega32_1;
  const T t32_15 = omega32_1 * omega32_1;
  const T minus_U32_22 = t32_13 + t32_15;
  const T U32_23 = omega32_3 * omega32_2;
  const T minus_U32_33 = t32_14 + t32_15;
  // Pddot32 = C32 (U31 q32 + Pddot31): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t32_16 = Pddot31_3 + U31_13 * T(0.3) + U31_23 * T(1.6) - minus_U31_33 * T(0.1);
  const T t32_17 = Pddot31_1 + U31_12 * T(1.6) - minus_U31_11 * T(0.3) + U31_13 * T(0.1);
  const T t32_18 = Pddot31_2 + U31_12 * T(0.3) - minus_U31_22 * T(1.6) + U31_23 * T(0.1);
  const T Pddot32_1 = C32_13 * t32_16 - (minus_C32_11 * t32_17 - C32_12 * t32_18);
  const T Pddot32_2 = C32_21 * t32_17 - minus_C32_22 * t32_18 + C32_23 * t32_16;
  const T Pddot32_3 = C32_31 * t32_17 + C32_32 * t32_18 - minus_C32_33 * t32_16;
  // N31 = -C32^T M_torque_32_ - h_all_31~ Pddot31 - omega31~ J_all_31 omega31 + M_torque_31_: applied less inertia
  //   moment about the body origin, body axes [N m]
  const T minus_N31_1 = C32_21 * u.tau_32_2 - (u.tau_31_1 + minus_C32_11 * u.tau_32_1) + C32_31 * u.tau_32_3 +
      T(7.540000000000001) * Pddot31_3 - T(0.625) * Pddot31_2 + T(10.699750000000002) * U31_23 + T(0.7294000000000002)
      * (s31_1 - s31_2) - T(0.1342) * U31_12 + T(2.0775) * U31_13;
  const T minus_N31_2 = C32_32 * u.tau_32_3 - (minus_C32_22 * u.tau_32_2 - (C32_12 * u.tau_32_1 - u.tau_31_2)) +
      T(0.625) * Pddot31_1 - T(1.67) * Pddot31_3 - T(0.28475) * U31_13 - T(0.1342) * (s31_1 - s31_3) - T(2.0775) *
      U31_23 + T(0.7294000000000002) * U31_12;
  const T N31_3 = minus_C32_33 * u.tau_32_3 - (C32_13 * u.tau_32_1 - u.tau_31_3 + C32_23 * u.tau_32_2) - T(1.67) *
      Pddot31_2 + T(7.540000000000001) * Pddot31_1 + T(10.415000000000001) * U31_12 - T(2.0775) * (s31_2 - s31_3) +
      T(0.7294000000000002) * U31_13 - T(0.1342) * U31_23;
  // G32 = -U32 h_all_32: applied less inertia force, body axes [N]
  const T G32_1 = minus_U32_11 * T(0.42000000000000004) - U32_12 * T(0.8400000000000001) - U32_13 *
      T(0.21000000000000002);
  const T G32_2 = minus_U32_22 * T(0.8400000000000001) - U32_12 * T(0.42000000000000004) - U32_23 *
      T(0.21000000000000002);
  const T G32_3 = minus_U32_33 * T(0.21000000000000002) - (U32_13 * T(0.42000000000000004) + U32_23 *
      T(0.8400000000000001));
  // N32 = -h_all_32~ Pddot32 - omega32~ J_all_32 omega32 + M_torque_32_: applied less inertia moment about the body
  //   origin, body axes [N m]
  const T N32_1 = u.tau_32_1 + T(0.21000000000000002) * Pddot32_2 - T(0.8400000000000001) * Pddot32_3 +
      T(0.010499999999999959) * U32_23 - T(0.058800000000000005) * (t32_13 - t32_14) + T(0.008400000000000003) *
      U32_12 - T(0.06300000000000001) * U32_13;
  const T N32_2 = u.tau_32_2 + T(0.42000000000000004) * Pddot32_3 - T(0.21000000000000002) * Pddot32_1 -
      T(0.052499999999999956) * U32_13 + T(0.008400000000000003) * (t32_13 - t32_15) + T(0.06300000000000001) * U32_23
      - T(0.058800000000000005) * U32_12;
  const T N32_3 = u.tau_32_3 + T(0.8400000000000001) * Pddot32_1 - T(0.42000000000000004) * Pddot32_2 + T(0.042) *
      U32_12 - T(0.06300000000000001) * (t32_14 - t32_15) + T(0.058800000000000005) * U32_13 - T(0.008400000000000003)
      * U32_23;
  own[frame::minus_C_11] = minus_C32_11;
  own[frame::C_12] = C32_12;
  own[frame::C_13] = C32_13;
  own[frame::C_21] = C32_21;
  own[frame::minus_C_22] = minus_C32_22;
  own[frame::C_23] = C32_23;
  own[frame::C_31] = C32_31;
  own[frame::C_32] = C32_32;
  own[frame::minus_C_33] = minus_C32_33;
  own[frame::G_1] = G32_1;
  own[frame::G_2] = G32_2;
  own[frame::G_3] = G32_3;
  own[frame::N31_1] = -minus_N31_1;
  own[frame::N31_2] = -minus_N31_2;
  own[frame::N31_3] = N31_3;
  own[frame::N_1] = N32_1;
  own[frame::N_2] = N32_2;
  own[frame::N_3] = N32_3;
}

// body 32 and what they carry
template <class T>
[[gnu::noinline]] void inward_1(T* frames) noexcept {
  T* const own = frames + 2043;
  const T N32_1 = own[frame::N_1];
  const T N32_2 = own[frame::N_2];
  const T N32_3 = own[frame::N_3];
  const T G32_1 = own[frame::G_1];
  const T G32_2 = own[frame::G_2];
  const T G32_3 = own[frame::G_3];
  const T C32_31 = own[frame::C_31];
  const T minus_C32_11 = own[frame::minus_C_11];
  const T C32_21 = own[frame::C_21];
  const T C32_32 = own[frame::C_32];
  const T C32_12 = own[frame::C_12];
  const T minus_C32_22 = own[frame::minus_C_22];
  const T minus_C32_33 = own[frame::minus_C_33];
  const T C32_13 = own[frame::C_13];
  const T C32_23 = own[frame::C_23];
  // w_32 = D(LD32)^-1 L(LD32)^-1 N32: D^-1 L^-1 n
  const T w_32_1 = T(1.670843776106934) * N32_1;
  const T b32_1 = N32_2 + T(0.10526315789473686) * N32_1;
  const T w_32_2 = T(1.8186168939937783) * b32_1;
  const T w_32_3 = T(1.8538986277051082) * (N32_3 + T(0.014035087719298251) * N32_1 + T(0.1085427135678392) * b32_1);
  // gb32 = G32 - Y32^T w_32: force with the ball solved [N]
  const T gb32_1 = G32_1 - T(0.21000000000000002) * w_32_2 + T(0.8172060301507539) * w_32_3;
  const T gb32_2 = G32_2 + T(0.022105263157894742) * w_32_2 + T(0.21000000000000002) * w_32_1 - T(0.41465326633165833)
      * w_32_3;
  const T gb32_3 = G32_3 - T(0.8400000000000001) * w_32_1 + T(0.3315789473684211) * w_32_2 + T(0.02420100502512563) *
      w_32_3;
  // Mb32 = C32^T M32 C32: M of the joint, lower body's axes
  const T minus_b32_2 = minus_C32_11 * T(1.3182821458569187) + C32_21 * T(0.6366490158127306) + C32_31 *
      T(0.08996822846291497);
  const T b32_3 = C32_21 * T(0.39332724683197606) + minus_C32_11 * T(0.6366490158127306) - C32_31 *
      T(0.3000109557024432);
  const T b32_4 = minus_C32_11 * T(0.08996822846291497) - C32_21 * T(0.3000109557024432) + C32_31 *
      T(1.3799802797356027);
  const T minus_Mb32_11 = minus_b32_2 * minus_C32_11 + b32_3 * C32_21 + b32_4 * C32_31;
  const T minus_Mb32_12 = b32_4 * C32_32 - (minus_b32_2 * C32_12 + b32_3 * minus_C32_22);
  const T Mb32_13 = b32_4 * minus_C32_33 - (b32_3 * C32_23 - minus_b32_2 * C32_13);
  const T b32_5 = C32_12 * T(1.3182821458569187) + minus_C32_22 * T(0.6366490158127306) - C32_32 *
      T(0.08996822846291497);
  const T minus_b32_6 = minus_C32_22 * T(0.39332724683197606) + C32_12 * T(0.6366490158127306) + C32_32 *
      T(0.3000109557024432);
  const T b32_7 = minus_C32_22 * T(0.3000109557024432) - C32_12 * T(0.08996822846291497) + C32_32 *
      T(1.3799802797356027);
  const T minus_Mb32_22 = b32_5 * C32_12 + minus_b32_6 * minus_C32_22 + b32_7 * C32_32;
  const T Mb32_23 = b32_7 * minus_C32_33 - (b32_5 * C32_13 - minus_b32_6 * C32_23);
  const T Mb32_33 = minus_Mb32_22 - (T(3.0915896724244973) - minus_Mb32_11);
  // Hb32 = q32~ Mb32: H of the joint at the lower body's origin, its axes
  const T b32_8 = T(0.1) * minus_Mb32_12;
  const T b32_9 = T(1.6) * Mb32_13;
  const T Hb32_11 = b32_8 + b32_9;
  const T Hb32_12 = T(0.1) * minus_Mb32_22 + T(1.6) * Mb32_23;
  const T Hb32_13 = T(1.6) * Mb32_33 - T(0.1) * Mb32_23;
  const T minus_Hb32_21 = T(0.3) * Mb32_13 + T(0.1) * minus_Mb32_11;
  const T minus_b32_10 = T(0.3) * Mb32_23;
  const T minus_Hb32_22 = minus_b32_10 + b32_8;
  const T Hb32_23 = T(0.1) * Mb32_13 - T(0.3) * Mb32_33;
  const T Hb32_31 = T(1.6) * minus_Mb32_11 - T(0.3) * minus_Mb32_12;
  const T Hb32_32 = T(1.6) * minus_Mb32_12 - T(0.3) * minus_Mb32_22;
  const T minus_Hb32_33 = b32_9 - minus_b32_10;
  own[frame::w__1] = w_32_1;
  own[frame::w__2] = w_32_2;
  own[frame::w__3] = w_32_3;
  own[frame::gb_1] = gb32_1;
  own[frame::gb_2] = gb32_2;
  own[frame::gb_3] = gb32_3;
  own[frame::Mb_11] = -minus_Mb32_11;
  own[frame::minus_Mb_12] = minus_Mb32_12;
  own[frame::Mb_13] = Mb32_13;
  own[frame::minus_Mb_22] = minus_Mb32_22;
  own[frame::Mb_23] = Mb32_23;
  own[frame::Mb_33] = Mb32_33;
  own[frame::Hb_11] = Hb32_11;
  own[frame::Hb_12] = Hb32_12;
  own[frame::Hb_13] = Hb32_13;
  own[frame::Hb_21] = -minus_Hb32_21;
  own[frame::Hb_22] = -minus_Hb32_22;
  own[frame::Hb_23] = Hb32_23;
  own[frame::Hb_31] = Hb32_31;
  own[frame::Hb_32] = Hb32_32;
  own[frame::minus_Hb_33] = minus_Hb32_33;
}

// bodies 31, 4 and what they carry
template <class T>
[[gnu::noinline]] void inward_2(T* frames, int row) noexcept {
  const auto& [J, K, s_at] = inward_2_places[row];
  const auto& k = inward_2_numbers<Number<T>>[row];
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T HbJ_12 = of_J[frame::Hb_12];
  const T HbJ_13 = of_J[frame::Hb_13];
  const T HbJ_21 = of_J[frame::Hb_21];
  const T HbJ_23 = of_J[frame::Hb_23];
  const T HbJ_31 = of_J[frame::Hb_31];
  const T HbJ_32 = of_J[frame::Hb_32];
  const T HbJ_11 = of_J[frame::Hb_11];
  const T HbJ_22 = of_J[frame::Hb_22];
  const T CJ_31 = of_J[frame::C_31];
  const T gbJ_3 = of_J[frame::gb_3];
  const T minus_CJ_11 = of_J[frame::minus_C_11];
  const T gbJ_1 = of_J[frame::gb_1];
  const T CJ_21 = of_J[frame::C_21];
  const T gbJ_2 = of_J[frame::gb_2];
  const T GK_1 = own[frame::G_1];
  const T CJ_12 = of_J[frame::C_12];
  const T minus_CJ_22 = of_J[frame::minus_C_22];
  const T CJ_32 = of_J[frame::C_32];
  const T GK_2 = own[frame::G_2];
  const T minus_CJ_33 = of_J[frame::minus_C_33];
  const T CJ_13 = of_J[frame::C_13];
  const T CJ_23 = of_J[frame::C_23];
  const T GK_3 = own[frame::G_3];
  const T N31_1 = of_J[s_at];
  const T N31_2 = of_J[s_at + 1];
  const T N31_3 = of_J[s_at + 2];
  const T minus_HbJ_33 = of_J[frame::minus_Hb_33];
  const T MbJ_11 = of_J[frame::Mb_11];
  const T minus_MbJ_12 = of_J[frame::minus_Mb_12];
  const T MbJ_13 = of_J[frame::Mb_13];
  const T minus_MbJ_22 = of_J[frame::minus_Mb_22];
  const T MbJ_23 = of_J[frame::Mb_23];
  const T MbJ_33 = of_J[frame::Mb_33];
  const T CK_31 = own[frame::C_31];
  const T minus_CK_11 = own[frame::minus_C_11];
  const T CK_21 = own[frame::C_21];
  const T CK_12 = own[frame::C_12];
  const T minus_CK_22 = own[frame::minus_C_22];
  const T CK_32 = own[frame::C_32];
  const T CK_13 = own[frame::C_13];
  const T CK_23 = own[frame::C_23];
  const T minus_CK_33 = own[frame::minus_C_33];
  // HAK = h_all_K~ + HbJ: moment for an acceleration of the origin, body axes [kg m]
  const T HAK_12 = HbJ_12 + T(k[0]);
  const T HAK_13 = T(k[1]) + HbJ_13;
  const T HAK_21 = T(k[2]) + HbJ_21;
  const T HAK_23 = T(k[3]) + HbJ_23;
  const T HAK_31 = HbJ_31 + T(k[4]);
  const T HAK_32 = T(k[5]) + HbJ_32;
  // JAK = J_all_K - HbJ qJ~: moment for an angular acceleration, body axes [kg m^2]
  const T JAK_11 = T(k[7]) + HbJ_13 * T(k[6]) - HbJ_12 * T(0.1);
  const T JAK_12 = T(k[8]) - HbJ_13 * T(0.3) + HbJ_11 * T(0.1);
  const T JAK_13 = T(k[10]) + HbJ_11 * T(k[9]) + HbJ_12 * T(0.3);
  const T JAK_22 = T(k[11]) + HbJ_21 * T(0.1) - HbJ_23 * T(0.3);
  const T JAK_23 = T(k[12]) + HbJ_21 * T(k[9]) + HbJ_22 * T(0.3);
  const T JAK_33 = T(k[13]) + HbJ_32 * T(0.3) + HbJ_31 * T(k[9]);
  // gK = CJ^T gbJ + GK: force that drives it, home axes [N]
  const T bK_1 = CJ_31 * gbJ_3 - (minus_CJ_11 * gbJ_1 - CJ_21 * gbJ_2);
  const T gK_1 = bK_1 + GK_1;
  const T bK_2 = CJ_12 * gbJ_1 - minus_CJ_22 * gbJ_2 + CJ_32 * gbJ_3;
  const T gK_2 = bK_2 + GK_2;
  const T bK_3 = minus_CJ_33 * gbJ_3 - (CJ_13 * gbJ_1 + CJ_23 * gbJ_2);
  const T gK_3 = GK_3 - bK_3;
  // nK = qJ~ CJ^T gbJ + NK: moment that drives it, body axes [N m]
  const T nK_1 = N31_1 - T(0.1) * bK_2 + T(k[9]) * bK_3;
  const T nK_2 = N31_2 + T(0.3) * bK_3 + T(0.1) * bK_1;
  const T nK_3 = N31_3 + T(k[9]) * bK_1 + T(0.3) * bK_2;
  // LDK = L D L^T of JAK: L D L^T = JA: L, and 1/D on the diagonal
  const T LDK_11 = T(1) / JAK_11;
  const T LDK_21 = LDK_11 * JAK_12;
  const T LDK_22 = T(1) / (JAK_22 - LDK_21 * JAK_12);
  const T LDK_31 = LDK_11 * JAK_13;
  const T bK_4 = JAK_23 - LDK_21 * JAK_13;
  const T LDK_32 = LDK_22 * bK_4;
  const T minus_LDK_33 = T(1) / (LDK_32 * bK_4 - (JAK_33 - LDK_31 * JAK_13));
  // YK = L(LDK)^-1 HAK: L^-1 HA
  const T YK_21 = HAK_21 - LDK_21 * HbJ_11;
  const T YK_22 = HbJ_22 - LDK_21 * HAK_12;
  const T YK_23 = HAK_23 - LDK_21 * HAK_13;
  const T YK_31 = HAK_31 - LDK_31 * HbJ_11 - LDK_32 * YK_21;
  const T YK_32 = HAK_32 - LDK_31 * HAK_12 - LDK_32 * YK_22;
  const T minus_YK_33 = minus_HbJ_33 + LDK_31 * HAK_13 + LDK_32 * YK_23;
  // WK = D(LDK)^-1 YK: D^-1 L^-1 HA
  const T WK_11 = LDK_11 * HbJ_11;
  const T WK_12 = LDK_11 * HAK_12;
  const T WK_13 = LDK_11 * HAK_13;
  const T WK_21 = LDK_22 * YK_21;
  const T WK_22 = LDK_22 * YK_22;
  const T WK_23 = LDK_22 * YK_23;
  const T minus_WK_31 = minus_LDK_33 * YK_31;
  const T minus_WK_32 = minus_LDK_33 * YK_32;
  const T WK_33 = minus_LDK_33 * minus_YK_33;
  // w_K = D(LDK)^-1 L(LDK)^-1 nK: D^-1 L^-1 n
  const T w_K_1 = LDK_11 * nK_1;
  const T bK_5 = nK_2 - LDK_21 * nK_1;
  const T w_K_2 = LDK_22 * bK_5;
  const T w_K_3 = minus_LDK_33 * (LDK_32 * bK_5 - (nK_3 - LDK_31 * nK_1));
  // MK = MbJ - YK^T WK: MA less what the ball takes up [kg]
  const T minus_MK_11 = YK_21 * WK_21 - (MbJ_11 - HbJ_11 * WK_11) - YK_31 * minus_WK_31;
  const T minus_MK_12 = minus_MbJ_12 + HbJ_11 * WK_12 + YK_21 * WK_22 - YK_31 * minus_WK_32;
  const T minus_MK_13 = YK_21 * WK_23 - (MbJ_13 - HbJ_11 * WK_13) + YK_31 * WK_33;
  const T minus_MK_22 = minus_MbJ_22 + HAK_12 * WK_12 + YK_22 * WK_22 - YK_32 * minus_WK_32;
  const T minus_MK_23 = YK_22 * WK_23 - (MbJ_23 - HAK_12 * WK_13) + YK_32 * WK_33;
  const T minus_MK_33 = YK_23 * WK_23 - (MbJ_33 - HAK_13 * WK_13) - minus_YK_33 * WK_33;
  // gbK = gK - YK^T w_K: force with the ball solved [N]
  const T minus_gbK_1 = YK_21 * w_K_2 - (gK_1 - HbJ_11 * w_K_1) + YK_31 * w_K_3;
  const T minus_gbK_2 = YK_22 * w_K_2 - (gK_2 - HAK_12 * w_K_1) + YK_32 * w_K_3;
  const T minus_gbK_3 = YK_23 * w_K_2 - (gK_3 - HAK_13 * w_K_1) - minus_YK_33 * w_K_3;
  // MbK = CK^T MK CK: M of the joint, lower body's axes
  const T bK_6 = CK_21 * minus_MK_23 - minus_CK_11 * minus_MK_13 + CK_31 * minus_MK_33;
  const T bK_7 = minus_CK_11 * minus_MK_11 - CK_21 * minus_MK_12 - CK_31 * minus_MK_13;
  const T bK_8 = minus_CK_11 * minus_MK_12 - CK_21 * minus_MK_22 - CK_31 * minus_MK_23;
  const T minus_MbK_11 = bK_7 * minus_CK_11 - bK_8 * CK_21 + bK_6 * CK_31;
  const T MbK_12 = bK_7 * CK_12 - bK_8 * minus_CK_22 - bK_6 * CK_32;
  const T MbK_13 = bK_7 * CK_13 + bK_8 * CK_23 + bK_6 * minus_CK_33;
  const T minus_bK_9 = CK_12 * minus_MK_11 - minus_CK_22 * minus_MK_12 + CK_32 * minus_MK_13;
  const T minus_bK_10 = CK_12 * minus_MK_12 - minus_CK_22 * minus_MK_22 + CK_32 * minus_MK_23;
  const T bK_11 = CK_32 * minus_MK_33 - (minus_CK_22 * minus_MK_23 - CK_12 * minus_MK_13);
  const T MbK_22 = minus_bK_10 * minus_CK_22 - minus_bK_9 * CK_12 - bK_11 * CK_32;
  const T MbK_23 = bK_11 * minus_CK_33 - (minus_bK_9 * CK_13 + minus_bK_10 * CK_23);
  const T MbK_33 = minus_MbK_11 - (minus_MK_11 + minus_MK_22 + minus_MK_33) - MbK_22;
  // HbK = qK~ MbK: H of the joint at the lower body's origin, its axes
  const T bK_12 = T(k[14]) * MbK_13;
  const T minus_bK_13 = T(0.1) * MbK_12;
  const T HbK_11 = bK_12 - minus_bK_13;
  const T HbK_12 = T(k[14]) * MbK_23 - T(0.1) * MbK_22;
  const T HbK_13 = T(k[14]) * MbK_33 - T(0.1) * MbK_23;
  const T minus_HbK_21 = T(0.1) * minus_MbK_11 + T(0.3) * MbK_13;
  const T minus_bK_14 = T(0.3) * MbK_23;
  const T HbK_22 = minus_bK_13 - minus_bK_14;
  const T HbK_23 = T(0.1) * MbK_13 - T(0.3) * MbK_33;
  const T HbK_31 = T(0.3) * MbK_12 + T(k[14]) * minus_MbK_11;
  const T HbK_32 = T(0.3) * MbK_22 + T(k[15]) * MbK_12;
  const T minus_HbK_33 = bK_12 - minus_bK_14;
  own[frame::w__1] = w_K_1;
  own[frame::w__2] = w_K_2;
  own[frame::gb_1] = -minus_gbK_1;
  own[frame::gb_2] = -minus_gbK_2;
  own[frame::Mb_13] = MbK_13;
  own[frame::Mb_23] = MbK_23;
  own[frame::Mb_33] = MbK_33;
  own[frame::Hb_11] = HbK_11;
  own[frame::Hb_12] = HbK_12;
  own[frame::Hb_13] = HbK_13;
  own[frame::Hb_21] = -minus_HbK_21;
  own[frame::Hb_22] = HbK_22;
  own[frame::Hb_23] = HbK_23;
  own[frame::Hb_31] = HbK_31;
  own[frame::Hb_32] = HbK_32;
  own[frame::minus_Hb_33] = minus_HbK_33;
  own[frame::LD_21] = LDK_21;
  own[frame::LD_31] = LDK_31;
  own[frame::LD_32] = LDK_32;
  own[frame::W_11] = WK_11;
  own[frame::W_12] = WK_12;
  own[frame::W_13] = WK_13;
  own[frame::W_21] = WK_21;
  own[frame::W_22] = WK_22;
  own[frame::W_23] = WK_23;
  own[frame::W_31] = -minus_WK_31;
  own[frame::W_32] = -minus_WK_32;
  own[frame::minus_W_33] = -WK_33;
  own[frame::minus_w__3] = -w_K_3;
  own[frame::minus_gb_3] = minus_gbK_3;
  own[frame::minus_Mb_11] = minus_MbK_11;
  own[frame::Mb_12] = MbK_12;
  own[frame::Mb_22] = MbK_22;
}

// bodies 30, 27, 24, 21, 18, 15, 12, 9, 3 and what they carry
template <class T>
[[gnu::noinline]] void inward_3(T* frames, int row) noexcept {
  const auto& [J, K] = inward_3_places[row];
  const auto& k = inward_3_numbers<Number<T>>[row];
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T minus_MbJ_11 = of_J[frame::minus_Mb_11];
  const T MbJ_22 = of_J[frame::Mb_22];
  const T MbJ_33 = of_J[frame::Mb_33];
  const T HbJ_12 = of_J[frame::Hb_12];
  const T HbJ_13 = of_J[frame::Hb_13];
  const T HbJ_21 = of_J[frame::Hb_21];
  const T HbJ_23 = of_J[frame::Hb_23];
  const T HbJ_31 = of_J[frame::Hb_31];
  const T HbJ_32 = of_J[frame::Hb_32];
  const T HbJ_11 = of_J[frame::Hb_11];
  const T HbJ_22 = of_J[frame::Hb_22];
  const T minus_CJ_11 = of_J[frame::minus_C_11];
  const T gbJ_1 = of_J[frame::gb_1];
  const T CJ_21 = of_J[frame::C_21];
  const T gbJ_2 = of_J[frame::gb_2];
  const T CJ_31 = of_J[frame::C_31];
  const T minus_gbJ_3 = of_J[frame::minus_gb_3];
  const T GK_1 = own[frame::G_1];
  const T CJ_32 = of_J[frame::C_32];
  const T CJ_12 = of_J[frame::C_12];
  const T minus_CJ_22 = of_J[frame::minus_C_22];
  const T GK_2 = own[frame::G_2];
  const T CJ_13 = of_J[frame::C_13];
  const T CJ_23 = of_J[frame::C_23];
  const T minus_CJ_33 = of_J[frame::minus_C_33];
  const T GK_3 = own[frame::G_3];
  const T N3_1 = of_J[frame::N3_1];
  const T N3_2 = of_J[frame::N3_2];
  const T N3_3 = of_J[frame::N3_3];
  const T minus_HbJ_33 = of_J[frame::minus_Hb_33];
  const T MbJ_12 = of_J[frame::Mb_12];
  const T MbJ_13 = of_J[frame::Mb_13];
  const T MbJ_23 = of_J[frame::Mb_23];
  const T minus_CK_11 = own[frame::minus_C_11];
  const T CK_21 = own[frame::C_21];
  const T CK_31 = own[frame::C_31];
  const T CK_12 = own[frame::C_12];
  const T minus_CK_22 = own[frame::minus_C_22];
  const T CK_32 = own[frame::C_32];
  const T CK_23 = own[frame::C_23];
  const T CK_13 = own[frame::C_13];
  const T minus_CK_33 = own[frame::minus_C_33];
  // MAK = m_all_K one + MbJ: force for an acceleration of the origin, home axes [kg]
  const T MAK_11 = T(k[0]) - minus_MbJ_11;
  const T MAK_22 = T(k[0]) + MbJ_22;
  const T MAK_33 = T(k[0]) + MbJ_33;
  // HAK = h_all_K~ + HbJ: moment for an acceleration of the origin, body axes [kg m]
  const T HAK_12 = HbJ_12 + T(k[1]);
  const T HAK_13 = T(k[2]) + HbJ_13;
  const T HAK_21 = T(k[3]) + HbJ_21;
  const T HAK_23 = HbJ_23 + T(k[4]);
  const T HAK_31 = HbJ_31 + T(k[5]);
  const T HAK_32 = T(k[6]) + HbJ_32;
  // JAK = J_all_K - HbJ qJ~: moment for an angular acceleration, body axes [kg m^2]
  const T JAK_11 = T(k[8]) + HbJ_13 * T(k[7]) - HbJ_12 * T(0.1);
  const T JAK_12 = T(k[9]) - HbJ_13 * T(0.3) + HbJ_11 * T(0.1);
  const T JAK_13 = T(k[11]) + HbJ_11 * T(k[10]) + HbJ_12 * T(0.3);
  const T JAK_22 = T(k[12]) + HbJ_21 * T(0.1) - HbJ_23 * T(0.3);
  const T JAK_23 = T(k[13]) + HbJ_21 * T(k[10]) + HbJ_22 * T(0.3);
  const T JAK_33 = T(k[14]) + HbJ_32 * T(0.3) + HbJ_31 * T(k[10]);
  // gK = CJ^T gbJ + GK: force that drives it, home axes [N]
  const T bK_1 = minus_CJ_11 * gbJ_1 - CJ_21 * gbJ_2 + CJ_31 * minus_gbJ_3;
  const T gK_1 = GK_1 - bK_1;
  const T bK_2 = CJ_32 * minus_gbJ_3 - (CJ_12 * gbJ_1 - minus_CJ_22 * gbJ_2);
  const T gK_2 = GK_2 - bK_2;
  const T bK_3 = CJ_13 * gbJ_1 + CJ_23 * gbJ_2 + minus_CJ_33 * minus_gbJ_3;
  const T gK_3 = GK_3 + bK_3;
  // nK = qJ~ CJ^T gbJ + NK: moment that drives it, body axes [N m]
  const T nK_1 = N3_1 + T(0.1) * bK_2 + T(k[7]) * bK_3;
  const T nK_2 = N3_2 - T(0.3) * bK_3 - T(0.1) * bK_1;
  const T nK_3 = N3_3 + T(k[7]) * bK_1 - T(0.3) * bK_2;
  // LDK = L D L^T of JAK: L D L^T = JA: L, and 1/D on the diagonal
  const T LDK_11 = T(1) / JAK_11;
  const T LDK_21 = LDK_11 * JAK_12;
  const T LDK_22 = T(1) / (JAK_22 - LDK_21 * JAK_12);
  const T LDK_31 = LDK_11 * JAK_13;
  const T bK_4 = JAK_23 - LDK_21 * JAK_13;
  const T LDK_32 = LDK_22 * bK_4;
  const T minus_LDK_33 = T(1) / (LDK_32 * bK_4 - (JAK_33 - LDK_31 * JAK_13));
  // YK = L(LDK)^-1 HAK: L^-1 HA
  const T YK_21 = HAK_21 - LDK_21 * HbJ_11;
  const T YK_22 = HbJ_22 - LDK_21 * HAK_12;
  const T YK_23 = HAK_23 - LDK_21 * HAK_13;
  const T YK_31 = HAK_31 - LDK_31 * HbJ_11 - LDK_32 * YK_21;
  const T YK_32 = HAK_32 - LDK_31 * HAK_12 - LDK_32 * YK_22;
  const T minus_YK_33 = minus_HbJ_33 + LDK_31 * HAK_13 + LDK_32 * YK_23;
  // WK = D(LDK)^-1 YK: D^-1 L^-1 HA
  const T WK_11 = LDK_11 * HbJ_11;
  const T WK_12 = LDK_11 * HAK_12;
  const T WK_13 = LDK_11 * HAK_13;
  const T WK_21 = LDK_22 * YK_21;
  const T WK_22 = LDK_22 * YK_22;
  const T WK_23 = LDK_22 * YK_23;
  const T minus_WK_31 = minus_LDK_33 * YK_31;
  const T minus_WK_32 = minus_LDK_33 * YK_32;
  const T WK_33 = minus_LDK_33 * minus_YK_33;
  // w_K = D(LDK)^-1 L(LDK)^-1 nK: D^-1 L^-1 n
  const T w_K_1 = LDK_11 * nK_1;
  const T bK_5 = nK_2 - LDK_21 * nK_1;
  const T w_K_2 = LDK_22 * bK_5;
  const T w_K_3 = minus_LDK_33 * (LDK_32 * bK_5 - (nK_3 - LDK_31 * nK_1));
  // MK = MAK - YK^T WK: MA less what the ball takes up [kg]
  const T minus_MK_11 = YK_21 * WK_21 - (MAK_11 - HbJ_11 * WK_11) - YK_31 * minus_WK_31;
  const T minus_MK_12 = YK_21 * WK_22 - (MbJ_12 - HbJ_11 * WK_12) - YK_31 * minus_WK_32;
  const T minus_MK_13 = YK_21 * WK_23 - (MbJ_13 - HbJ_11 * WK_13) + YK_31 * WK_33;
  const T minus_MK_22 = YK_22 * WK_22 - (MAK_22 - HAK_12 * WK_12) - YK_32 * minus_WK_32;
  const T minus_MK_23 = YK_22 * WK_23 - (MbJ_23 - HAK_12 * WK_13) + YK_32 * WK_33;
  const T minus_MK_33 = YK_23 * WK_23 - (MAK_33 - HAK_13 * WK_13) - minus_YK_33 * WK_33;
  // gbK = gK - YK^T w_K: force with the ball solved [N]
  const T minus_gbK_1 = YK_21 * w_K_2 - (gK_1 - HbJ_11 * w_K_1) + YK_31 * w_K_3;
  const T minus_gbK_2 = YK_22 * w_K_2 - (gK_2 - HAK_12 * w_K_1) + YK_32 * w_K_3;
  const T minus_gbK_3 = YK_23 * w_K_2 - (gK_3 - HAK_13 * w_K_1) - minus_YK_33 * w_K_3;
  // MbK = CK^T MK CK: M of the joint, lower body's axes
  const T bK_6 = minus_CK_11 * minus_MK_11 - CK_21 * minus_MK_12 - CK_31 * minus_MK_13;
  const T bK_7 = minus_CK_11 * minus_MK_12 - CK_21 * minus_MK_22 - CK_31 * minus_MK_23;
  const T bK_8 = CK_21 * minus_MK_23 - minus_CK_11 * minus_MK_13 + CK_31 * minus_MK_33;
  const T minus_MbK_11 = bK_6 * minus_CK_11 - bK_7 * CK_21 + bK_8 * CK_31;
  const T MbK_12 = bK_6 * CK_12 - bK_7 * minus_CK_22 - bK_8 * CK_32;
  const T MbK_13 = bK_6 * CK_13 + bK_7 * CK_23 + bK_8 * minus_CK_33;
  const T minus_bK_9 = CK_12 * minus_MK_11 - minus_CK_22 * minus_MK_12 + CK_32 * minus_MK_13;
  const T minus_bK_10 = CK_12 * minus_MK_12 - minus_CK_22 * minus_MK_22 + CK_32 * minus_MK_23;
  const T bK_11 = CK_32 * minus_MK_33 - (minus_CK_22 * minus_MK_23 - CK_12 * minus_MK_13);
  const T MbK_22 = minus_bK_10 * minus_CK_22 - minus_bK_9 * CK_12 - bK_11 * CK_32;
  const T MbK_23 = bK_11 * minus_CK_33 - (minus_bK_9 * CK_13 + minus_bK_10 * CK_23);
  const T MbK_33 = minus_MbK_11 - (minus_MK_11 + minus_MK_22 + minus_MK_33) - MbK_22;
  // HbK = qK~ MbK: H of the joint at the lower body's origin, its axes
  const T bK_12 = T(k[15]) * MbK_13;
  const T minus_bK_13 = T(0.1) * MbK_12;
  const T HbK_11 = bK_12 - minus_bK_13;
  const T HbK_12 = T(k[15]) * MbK_23 - T(0.1) * MbK_22;
  const T HbK_13 = T(k[15]) * MbK_33 - T(0.1) * MbK_23;
  const T minus_HbK_21 = T(0.1) * minus_MbK_11 + T(0.3) * MbK_13;
  const T minus_bK_14 = T(0.3) * MbK_23;
  const T HbK_22 = minus_bK_13 - minus_bK_14;
  const T HbK_23 = T(0.1) * MbK_13 - T(0.3) * MbK_33;
  const T HbK_31 = T(0.3) * MbK_12 + T(k[15]) * minus_MbK_11;
  const T HbK_32 = T(0.3) * MbK_22 + T(k[16]) * MbK_12;
  const T minus_HbK_33 = bK_12 - minus_bK_14;
  own[frame::w__1] = w_K_1;
  own[frame::w__2] = w_K_2;
  own[frame::gb_1] = -minus_gbK_1;
  own[frame::gb_2] = -minus_gbK_2;
  own[frame::Mb_13] = MbK_13;
  own[frame::Mb_23] = MbK_23;
  own[frame::Mb_33] = MbK_33;
  own[frame::Hb_11] = HbK_11;
  own[frame::Hb_12] = HbK_12;
  own[frame::Hb_13] = HbK_13;
  own[frame::Hb_21] = -minus_HbK_21;
  own[frame::Hb_22] = HbK_22;
  own[frame::Hb_23] = HbK_23;
  own[frame::Hb_31] = HbK_31;
  own[frame::Hb_32] = HbK_32;
  own[frame::minus_Hb_33] = minus_HbK_33;
  own[frame::LD_21] = LDK_21;
  own[frame::LD_31] = LDK_31;
  own[frame::LD_32] = LDK_32;
  own[frame::W_11] = WK_11;
  own[frame::W_12] = WK_12;
  own[frame::W_13] = WK_13;
  own[frame::W_21] = WK_21;
  own[frame::W_22] = WK_22;
  own[frame::W_23] = WK_23;
  own[frame::W_31] = -minus_WK_31;
  own[frame::W_32] = -minus_WK_32;
  own[frame::minus_W_33] = -WK_33;
  own[frame::minus_w__3] = -w_K_3;
  own[frame::minus_gb_3] = minus_gbK_3;
  own[frame::minus_Mb_11] = minus_MbK_11;
  own[frame::Mb_12] = MbK_12;
  own[frame::Mb_22] = MbK_22;
}

// bodies 29, 28, 26, 25, 23, 22, 17, 16, 14, 13, 11, 10, 8, 7 and what they carry
template <class T>
[[gnu::noinline]] void inward_4(T* frames, int row) noexcept {
  const auto& [J, K] = inward_4_places[row];
  const auto& k = inward_4_numbers<Number<T>>[row];
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T HbJ_12 = of_J[frame::Hb_12];
  const T HbJ_13 = of_J[frame::Hb_13];
  const T HbJ_21 = of_J[frame::Hb_21];
  const T HbJ_23 = of_J[frame::Hb_23];
  const T HbJ_31 = of_J[frame::Hb_31];
  const T HbJ_32 = of_J[frame::Hb_32];
  const T HbJ_11 = of_J[frame::Hb_11];
  const T HbJ_22 = of_J[frame::Hb_22];
  const T minus_CJ_11 = of_J[frame::minus_C_11];
  const T gbJ_1 = of_J[frame::gb_1];
  const T CJ_21 = of_J[frame::C_21];
  const T gbJ_2 = of_J[frame::gb_2];
  const T CJ_31 = of_J[frame::C_31];
  const T minus_gbJ_3 = of_J[frame::minus_gb_3];
  const T GK_1 = own[frame::G_1];
  const T CJ_32 = of_J[frame::C_32];
  const T CJ_12 = of_J[frame::C_12];
  const T minus_CJ_22 = of_J[frame::minus_C_22];
  const T GK_2 = own[frame::G_2];
  const T CJ_13 = of_J[frame::C_13];
  const T CJ_23 = of_J[frame::C_23];
  const T minus_CJ_33 = of_J[frame::minus_C_33];
  const T GK_3 = own[frame::G_3];
  const T N2_1 = of_J[59];
  const T N2_2 = of_J[60];
  const T N2_3 = of_J[61];
  const T minus_HbJ_33 = of_J[frame::minus_Hb_33];
  const T minus_MbJ_11 = of_J[frame::minus_Mb_11];
  const T MbJ_12 = of_J[frame::Mb_12];
  const T MbJ_13 = of_J[frame::Mb_13];
  const T MbJ_22 = of_J[frame::Mb_22];
  const T MbJ_23 = of_J[frame::Mb_23];
  const T MbJ_33 = of_J[frame::Mb_33];
  const T CK_31 = own[frame::C_31];
  const T minus_CK_11 = own[frame::minus_C_11];
  const T CK_21 = own[frame::C_21];
  const T CK_12 = own[frame::C_12];
  const T minus_CK_22 = own[frame::minus_C_22];
  const T CK_32 = own[frame::C_32];
  const T minus_CK_33 = own[frame::minus_C_33];
  const T CK_23 = own[frame::C_23];
  const T CK_13 = own[frame::C_13];
  // HAK = h_all_K~ + HbJ: moment for an acceleration of the origin, body axes [kg m]
  const T HAK_12 = HbJ_12 + T(k[0]);
  const T HAK_13 = T(k[1]) + HbJ_13;
  const T HAK_21 = T(k[2]) + HbJ_21;
  const T HAK_23 = HbJ_23 + T(k[3]);
  const T HAK_31 = HbJ_31 + T(k[4]);
  const T HAK_32 = T(k[5]) + HbJ_32;
  // JAK = J_all_K - HbJ qJ~: moment for an angular acceleration, body axes [kg m^2]
  const T JAK_11 = T(k[7]) + HbJ_13 * T(k[6]) - HbJ_12 * T(0.1);
  const T JAK_12 = T(k[8]) - HbJ_13 * T(0.3) + HbJ_11 * T(0.1);
  const T JAK_13 = T(k[10]) + HbJ_11 * T(k[9]) + HbJ_12 * T(0.3);
  const T JAK_22 = T(k[11]) + HbJ_21 * T(0.1) - HbJ_23 * T(0.3);
  const T JAK_23 = T(k[12]) + HbJ_21 * T(k[9]) + HbJ_22 * T(0.3);
  const T JAK_33 = T(k[13]) + HbJ_32 * T(0.3) + HbJ_31 * T(k[9]);
  // gK = CJ^T gbJ + GK: force that drives it, home axes [N]
  const T bK_1 = minus_CJ_11 * gbJ_1 - CJ_21 * gbJ_2 + CJ_31 * minus_gbJ_3;
  const T gK_1 = GK_1 - bK_1;
  const T bK_2 = CJ_32 * minus_gbJ_3 - (CJ_12 * gbJ_1 - minus_CJ_22 * gbJ_2);
  const T gK_2 = GK_2 - bK_2;
  const T bK_3 = CJ_13 * gbJ_1 + CJ_23 * gbJ_2 + minus_CJ_33 * minus_gbJ_3;
  const T gK_3 = bK_3 + GK_3;
  // nK = qJ~ CJ^T gbJ + NK: moment that drives it, body axes [N m]
  const T nK_1 = N2_1 + T(0.1) * bK_2 + T(k[6]) * bK_3;
  const T nK_2 = N2_2 - T(0.3) * bK_3 - T(0.1) * bK_1;
  const T nK_3 = N2_3 + T(k[6]) * bK_1 - T(0.3) * bK_2;
  // LDK = L D L^T of JAK: L D L^T = JA: L, and 1/D on the diagonal
  const T LDK_11 = T(1) / JAK_11;
  const T LDK_21 = LDK_11 * JAK_12;
  const T LDK_22 = T(1) / (JAK_22 - LDK_21 * JAK_12);
  const T LDK_31 = LDK_11 * JAK_13;
  const T bK_4 = JAK_23 - LDK_21 * JAK_13;
  const T LDK_32 = LDK_22 * bK_4;
  const T minus_LDK_33 = T(1) / (LDK_32 * bK_4 - (JAK_33 - LDK_31 * JAK_13));
  // YK = L(LDK)^-1 HAK: L^-1 HA
  const T YK_21 = HAK_21 - LDK_21 * HbJ_11;
  const T YK_22 = HbJ_22 - LDK_21 * HAK_12;
  const T YK_23 = HAK_23 - LDK_21 * HAK_13;
  const T YK_31 = HAK_31 - LDK_31 * HbJ_11 - LDK_32 * YK_21;
  const T YK_32 = HAK_32 - LDK_31 * HAK_12 - LDK_32 * YK_22;
  const T minus_YK_33 = minus_HbJ_33 + LDK_31 * HAK_13 + LDK_32 * YK_23;
  // WK = D(LDK)^-1 YK: D^-1 L^-1 HA
  const T WK_11 = LDK_11 * HbJ_11;
  const T WK_12 = LDK_11 * HAK_12;
  const T WK_13 = LDK_11 * HAK_13;
  const T WK_21 = LDK_22 * YK_21;
  const T WK_22 = LDK_22 * YK_22;
  const T WK_23 = LDK_22 * YK_23;
  const T minus_WK_31 = minus_LDK_33 * YK_31;
  const T minus_WK_32 = minus_LDK_33 * YK_32;
  const T WK_33 = minus_LDK_33 * minus_YK_33;
  // w_K = D(LDK)^-1 L(LDK)^-1 nK: D^-1 L^-1 n
  const T w_K_1 = LDK_11 * nK_1;
  const T bK_5 = nK_2 - LDK_21 * nK_1;
  const T w_K_2 = LDK_22 * bK_5;
  const T w_K_3 = minus_LDK_33 * (LDK_32 * bK_5 - (nK_3 - LDK_31 * nK_1));
  // MK = MbJ - YK^T WK: MA less what the ball takes up [kg]
  const T minus_MK_11 = minus_MbJ_11 + HbJ_11 * WK_11 + YK_21 * WK_21 - YK_31 * minus_WK_31;
  const T minus_MK_12 = YK_21 * WK_22 - (MbJ_12 - HbJ_11 * WK_12) - YK_31 * minus_WK_32;
  const T minus_MK_13 = YK_21 * WK_23 - (MbJ_13 - HbJ_11 * WK_13) + YK_31 * WK_33;
  const T minus_MK_22 = YK_22 * WK_22 - (MbJ_22 - HAK_12 * WK_12) - YK_32 * minus_WK_32;
  const T minus_MK_23 = YK_22 * WK_23 - (MbJ_23 - HAK_12 * WK_13) + YK_32 * WK_33;
  const T minus_MK_33 = YK_23 * WK_23 - (MbJ_33 - HAK_13 * WK_13) - minus_YK_33 * WK_33;
  // gbK = gK - YK^T w_K: force with the ball solved [N]
  const T minus_gbK_1 = YK_21 * w_K_2 - (gK_1 - HbJ_11 * w_K_1) + YK_31 * w_K_3;
  const T minus_gbK_2 = YK_22 * w_K_2 - (gK_2 - HAK_12 * w_K_1) + YK_32 * w_K_3;
  const T minus_gbK_3 = YK_23 * w_K_2 - (gK_3 - HAK_13 * w_K_1) - minus_YK_33 * w_K_3;
  // MbK = CK^T MK CK: M of the joint, lower body's axes
  const T bK_6 = minus_CK_11 * minus_MK_11 - CK_21 * minus_MK_12 - CK_31 * minus_MK_13;
  const T bK_7 = minus_CK_11 * minus_MK_12 - CK_21 * minus_MK_22 - CK_31 * minus_MK_23;
  const T bK_8 = CK_21 * minus_MK_23 - minus_CK_11 * minus_MK_13 + CK_31 * minus_MK_33;
  const T minus_MbK_11 = bK_6 * minus_CK_11 - bK_7 * CK_21 + bK_8 * CK_31;
  const T MbK_12 = bK_6 * CK_12 - bK_7 * minus_CK_22 - bK_8 * CK_32;
  const T MbK_13 = bK_6 * CK_13 + bK_7 * CK_23 + bK_8 * minus_CK_33;
  const T minus_bK_9 = CK_12 * minus_MK_11 - minus_CK_22 * minus_MK_12 + CK_32 * minus_MK_13;
  const T minus_bK_10 = CK_12 * minus_MK_12 - minus_CK_22 * minus_MK_22 + CK_32 * minus_MK_23;
  const T bK_11 = CK_32 * minus_MK_33 - (minus_CK_22 * minus_MK_23 - CK_12 * minus_MK_13);
  const T MbK_22 = minus_bK_10 * minus_CK_22 - minus_bK_9 * CK_12 - bK_11 * CK_32;
  const T MbK_23 = bK_11 * minus_CK_33 - (minus_bK_9 * CK_13 + minus_bK_10 * CK_23);
  const T MbK_33 = minus_MbK_11 - (minus_MK_11 + minus_MK_22 + minus_MK_33) - MbK_22;
  // HbK = qK~ MbK: H of the joint at the lower body's origin, its axes
  const T bK_12 = T(k[14]) * MbK_13;
  const T minus_bK_13 = T(0.1) * MbK_12;
  const T HbK_11 = bK_12 - minus_bK_13;
  const T HbK_12 = T(k[14]) * MbK_23 - T(0.1) * MbK_22;
  const T HbK_13 = T(k[14]) * MbK_33 - T(0.1) * MbK_23;
  const T minus_HbK_21 = T(0.1) * minus_MbK_11 + T(0.3) * MbK_13;
  const T minus_bK_14 = T(0.3) * MbK_23;
  const T HbK_22 = minus_bK_13 - minus_bK_14;
  const T HbK_23 = T(0.1) * MbK_13 - T(0.3) * MbK_33;
  const T HbK_31 = T(0.3) * MbK_12 + T(k[14]) * minus_MbK_11;
  const T HbK_32 = T(0.3) * MbK_22 + T(k[15]) * MbK_12;
  const T minus_HbK_33 = bK_12 - minus_bK_14;
  own[frame::w__1] = w_K_1;
  own[frame::w__2] = w_K_2;
  own[frame::gb_1] = -minus_gbK_1;
  own[frame::gb_2] = -minus_gbK_2;
  own[frame::Mb_13] = MbK_13;
  own[frame::Mb_23] = MbK_23;
  own[frame::Mb_33] = MbK_33;
  own[frame::Hb_11] = HbK_11;
  own[frame::Hb_12] = HbK_12;
  own[frame::Hb_13] = HbK_13;
  own[frame::Hb_21] = -minus_HbK_21;
  own[frame::Hb_22] = HbK_22;
  own[frame::Hb_23] = HbK_23;
  own[frame::Hb_31] = HbK_31;
  own[frame::Hb_32] = HbK_32;
  own[frame::minus_Hb_33] = minus_HbK_33;
  own[frame::LD_21] = LDK_21;
  own[frame::LD_31] = LDK_31;
  own[frame::LD_32] = LDK_32;
  own[frame::W_11] = WK_11;
  own[frame::W_12] = WK_12;
  own[frame::W_13] = WK_13;
  own[frame::W_21] = WK_21;
  own[frame::W_22] = WK_22;
  own[frame::W_23] = WK_23;
  own[frame::W_31] = -minus_WK_31;
  own[frame::W_32] = -minus_WK_32;
  own[frame::minus_W_33] = -WK_33;
  own[frame::minus_w__3] = -w_K_3;
  own[frame::minus_gb_3] = minus_gbK_3;
  own[frame::minus_Mb_11] = minus_MbK_11;
  own[frame::Mb_12] = MbK_12;
  own[frame::Mb_22] = MbK_22;
}

// body 20 and what they carry
template <class T>
[[gnu::noinline]] void inward_5(T* frames) noexcept {
  const T* const of_21 = frames + 1317;
  T* const own = frames + 1251;
  const T Hb21_12 = of_21[frame::Hb_12];
  const T Hb21_13 = of_21[frame::Hb_13];
  const T Hb21_21 = of_21[frame::Hb_21];
  const T Hb21_23 = of_21[frame::Hb_23];
  const T Hb21_31 = of_21[frame::Hb_31];
  const T Hb21_32 = of_21[frame::Hb_32];
  const T Hb21_11 = of_21[frame::Hb_11];
  const T Hb21_22 = of_21[frame::Hb_22];
  const T minus_C21_11 = of_21[frame::minus_C_11];
  const T gb21_1 = of_21[frame::gb_1];
  const T C21_21 = of_21[frame::C_21];
  const T gb21_2 = of_21[frame::gb_2];
  const T C21_31 = of_21[frame::C_31];
  const T minus_gb21_3 = of_21[frame::minus_gb_3];
  const T G20_1 = own[frame::G_1];
  const T C21_32 = of_21[frame::C_32];
  const T C21_12 = of_21[frame::C_12];
  const T minus_C21_22 = of_21[frame::minus_C_22];
  const T G20_2 = own[frame::G_2];
  const T C21_13 = of_21[frame::C_13];
  const T C21_23 = of_21[frame::C_23];
  const T minus_C21_33 = of_21[frame::minus_C_33];
  const T G20_3 = own[frame::G_3];
  const T N2_1 = of_21[frame::N2_1];
  const T N2_2 = of_21[frame::N2_2];
  const T N2_3 = of_21[frame::N2_3];
  const T minus_Hb21_33 = of_21[frame::minus_Hb_33];
  const T minus_Mb21_11 = of_21[frame::minus_Mb_11];
  const T Mb21_12 = of_21[frame::Mb_12];
  const T Mb21_13 = of_21[frame::Mb_13];
  const T Mb21_22 = of_21[frame::Mb_22];
  const T Mb21_23 = of_21[frame::Mb_23];
  const T Mb21_33 = of_21[frame::Mb_33];
  const T C20_31 = own[frame::C_31];
  const T minus_C20_11 = own[frame::minus_C_11];
  const T C20_21 = own[frame::C_21];
  const T C20_12 = own[frame::C_12];
  const T minus_C20_22 = own[frame::minus_C_22];
  const T C20_32 = own[frame::C_32];
  const T minus_C20_33 = own[frame::minus_C_33];
  const T C20_23 = own[frame::C_23];
  const T C20_13 = own[frame::C_13];
  // HA20 = h_all_20~ + Hb21: moment for an acceleration of the origin, body axes [kg m]
  const T HA20_12 = Hb21_12 - T(0.15000000000000002);
  const T HA20_13 = T(0.6000000000000001) + Hb21_13;
  const T HA20_21 = T(0.15000000000000002) + Hb21_21;
  const T HA20_23 = Hb21_23 - T(0.30000000000000004);
  const T HA20_31 = Hb21_31 - T(0.6000000000000001);
  const T HA20_32 = T(0.30000000000000004) + Hb21_32;
  // JA20 = J_all_20 - Hb21 q21~: moment for an angular acceleration, body axes [kg m^2]
  const T JA20_11 = T(0.4275) + Hb21_13 * T(1.05) - Hb21_12 * T(0.1);
  const T JA20_12 = Hb21_11 * T(0.1) - (T(0.045000000000000005) + Hb21_13 * T(0.3));
  const T JA20_13 = Hb21_12 * T(0.3) - (T(0.006000000000000003) + Hb21_11 * T(1.05));
  const T JA20_22 = T(0.39749999999999996) + Hb21_21 * T(0.1) - Hb21_23 * T(0.3);
  const T JA20_23 = Hb21_22 * T(0.3) - (T(0.042) + Hb21_21 * T(1.05));
  const T JA20_33 = T(0.39) + Hb21_32 * T(0.3) - Hb21_31 * T(1.05);
  // g20 = C21^T gb21 + G20: force that drives it, home axes [N]
  const T b20_1 = minus_C21_11 * gb21_1 - C21_21 * gb21_2 + C21_31 * minus_gb21_3;
  const T g20_1 = G20_1 - b20_1;
  const T b20_2 = C21_32 * minus_gb21_3 - (C21_12 * gb21_1 - minus_C21_22 * gb21_2);
  const T g20_2 = G20_2 - b20_2;
  const T b20_3 = C21_13 * gb21_1 + C21_23 * gb21_2 + minus_C21_33 * minus_gb21_3;
  const T g20_3 = b20_3 + G20_3;
  // n20 = q21~ C21^T gb21 + N20: moment that drives it, body axes [N m]
  const T n20_1 = N2_1 + T(0.1) * b20_2 + T(1.05) * b20_3;
  const T n20_2 = N2_2 - T(0.3) * b20_3 - T(0.1) * b20_1;
  const T n20_3 = N2_3 + T(1.05) * b20_1 - T(0.3) * b20_2;
  // LD20 = L D L^T of JA20: L D L^T = JA: L, and 1/D on the diagonal
  const T LD20_11 = T(1) / JA20_11;
  const T LD20_21 = LD20_11 * JA20_12;
  const T LD20_22 = T(1) / (JA20_22 - LD20_21 * JA20_12);
  const T LD20_31 = LD20_11 * JA20_13;
  const T b20_4 = JA20_23 - LD20_21 * JA20_13;
  const T LD20_32 = LD20_22 * b20_4;
  const T minus_LD20_33 = T(1) / (LD20_32 * b20_4 - (JA20_33 - LD20_31 * JA20_13));
  // Y20 = L(LD20)^-1 HA20: L^-1 HA
  const T Y20_21 = HA20_21 - LD20_21 * Hb21_11;
  const T Y20_22 = Hb21_22 - LD20_21 * HA20_12;
  const T Y20_23 = HA20_23 - LD20_21 * HA20_13;
  const T Y20_31 = HA20_31 - LD20_31 * Hb21_11 - LD20_32 * Y20_21;
  const T Y20_32 = HA20_32 - LD20_31 * HA20_12 - LD20_32 * Y20_22;
  const T minus_Y20_33 = minus_Hb21_33 + LD20_31 * HA20_13 + LD20_32 * Y20_23;
  // W20 = D(LD20)^-1 Y20: D^-1 L^-1 HA
  const T W20_11 = LD20_11 * Hb21_11;
  const T W20_12 = LD20_11 * HA20_12;
  const T W20_13 = LD20_11 * HA20_13;
  const T W20_21 = LD20_22 * Y20_21;
  const T W20_22 = LD20_22 * Y20_22;
  const T W20_23 = LD20_22 * Y20_23;
  const T minus_W20_31 = minus_LD20_33 * Y20_31;
  const T minus_W20_32 = minus_LD20_33 * Y20_32;
  const T W20_33 = minus_LD20_33 * minus_Y20_33;
  // w_20 = D(LD20)^-1 L(LD20)^-1 n20: D^-1 L^-1 n
  const T w_20_1 = LD20_11 * n20_1;
  const T b20_5 = n20_2 - LD20_21 * n20_1;
  const T w_20_2 = LD20_22 * b20_5;
  const T w_20_3 = minus_LD20_33 * (LD20_32 * b20_5 - (n20_3 - LD20_31 * n20_1));
  // M20 = Mb21 - Y20^T W20: MA less what the ball takes up [kg]
  const T minus_M20_11 = minus_Mb21_11 + Hb21_11 * W20_11 + Y20_21 * W20_21 - Y20_31 * minus_W20_31;
  const T minus_M20_12 = Y20_21 * W20_22 - (Mb21_12 - Hb21_11 * W20_12) - Y20_31 * minus_W20_32;
  const T minus_M20_13 = Y20_21 * W20_23 - (Mb21_13 - Hb21_11 * W20_13) + Y20_31 * W20_33;
  const T minus_M20_22 = Y20_22 * W20_22 - (Mb21_22 - HA20_12 * W20_12) - Y20_32 * minus_W20_32;
  const T minus_M20_23 = Y20_22 * W20_23 - (Mb21_23 - HA20_12 * W20_13) + Y20_32 * W20_33;
  const T minus_M20_33 = Y20_23 * W20_23 - (Mb21_33 - HA20_13 * W20_13) - minus_Y20_33 * W20_33;
  // gb20 = g20 - Y20^T w_20: force with the ball solved [N]
  const T minus_gb20_1 = Y20_21 * w_20_2 - (g20_1 - Hb21_11 * w_20_1) + Y20_31 * w_20_3;
  const T minus_gb20_2 = Y20_22 * w_20_2 - (g20_2 - HA20_12 * w_20_1) + Y20_32 * w_20_3;
  const T minus_gb20_3 = Y20_23 * w_20_2 - (g20_3 - HA20_13 * w_20_1) - minus_Y20_33 * w_20_3;
  // Mb20 = C20^T M20 C20: M of the joint, lower body's axes
  const T b20_6 = minus_C20_11 * minus_M20_11 - C20_21 * minus_M20_12 - C20_31 * minus_M20_13;
  const T b20_7 = minus_C20_11 * minus_M20_12 - C20_21 * minus_M20_22 - C20_31 * minus_M20_23;
  const T b20_8 = C20_21 * minus_M20_23 - minus_C20_11 * minus_M20_13 + C20_31 * minus_M20_33;
  const T minus_Mb20_11 = b20_6 * minus_C20_11 - b20_7 * C20_21 + b20_8 * C20_31;
  const T Mb20_12 = b20_6 * C20_12 - b20_7 * minus_C20_22 - b20_8 * C20_32;
  const T Mb20_13 = b20_6 * C20_13 + b20_7 * C20_23 + b20_8 * minus_C20_33;
  const T minus_b20_9 = C20_12 * minus_M20_11 - minus_C20_22 * minus_M20_12 + C20_32 * minus_M20_13;
  const T minus_b20_10 = C20_12 * minus_M20_12 - minus_C20_22 * minus_M20_22 + C20_32 * minus_M20_23;
  const T b20_11 = C20_32 * minus_M20_33 - (minus_C20_22 * minus_M20_23 - C20_12 * minus_M20_13);
  const T Mb20_22 = minus_b20_10 * minus_C20_22 - minus_b20_9 * C20_12 - b20_11 * C20_32;
  const T Mb20_23 = b20_11 * minus_C20_33 - (minus_b20_9 * C20_13 + minus_b20_10 * C20_23);
  const T Mb20_33 = minus_Mb20_11 - (minus_M20_11 + minus_M20_22 + minus_M20_33) - Mb20_22;
  // Hb20 = q20~ Mb20: H of the joint at the lower body's origin, its axes
  const T minus_b20_12 = T(0.1) * Mb20_12;
  const T Hb20_11 = Mb20_13 - minus_b20_12;
  const T Hb20_12 = Mb20_23 - T(0.1) * Mb20_22;
  const T Hb20_13 = Mb20_33 - T(0.1) * Mb20_23;
  const T minus_Hb20_21 = T(0.1) * minus_Mb20_11 + T(0.3) * Mb20_13;
  const T minus_b20_13 = T(0.3) * Mb20_23;
  const T Hb20_22 = minus_b20_12 - minus_b20_13;
  const T Hb20_23 = T(0.1) * Mb20_13 - T(0.3) * Mb20_33;
  const T Hb20_31 = T(0.3) * Mb20_12 + minus_Mb20_11;
  const T Hb20_32 = T(0.3) * Mb20_22 - Mb20_12;
  const T minus_Hb20_33 = Mb20_13 - minus_b20_13;
  own[frame::w__1] = w_20_1;
  own[frame::w__2] = w_20_2;
  own[frame::gb_1] = -minus_gb20_1;
  own[frame::gb_2] = -minus_gb20_2;
  own[frame::Mb_13] = Mb20_13;
  own[frame::Mb_23] = Mb20_23;
  own[frame::Mb_33] = Mb20_33;
  own[frame::Hb_11] = Hb20_11;
  own[frame::Hb_12] = Hb20_12;
  own[frame::Hb_13] = Hb20_13;
  own[frame::Hb_21] = -minus_Hb20_21;
  own[frame::Hb_22] = Hb20_22;
  own[frame::Hb_23] = Hb20_23;
  own[frame::Hb_31] = Hb20_31;
  own[frame::Hb_32] = Hb20_32;
  own[frame::minus_Hb_33] = minus_Hb20_33;
  own[frame::LD_21] = LD20_21;
  own[frame::LD_31] = LD20_31;
  own[frame::LD_32] = LD20_32;
  own[frame::W_11] = W20_11;
  own[frame::W_12] = W20_12;
  own[frame::W_13] = W20_13;
  own[frame::W_21] = W20_21;
  own[frame::W_22] = W20_22;
  own[frame::W_23] = W20_23;
  own[frame::W_31] = -minus_W20_31;
  own[frame::W_32] = -minus_W20_32;
  own[frame::minus_W_33] = -W20_33;
  own[frame::minus_w__3] = -w_20_3;
  own[frame::minus_gb_3] = minus_gb20_3;
  own[frame::minus_Mb_11] = minus_Mb20_11;
  own[frame::Mb_12] = Mb20_12;
  own[frame::Mb_22] = Mb20_22;
}

// body 19 and what they carry
template <class T>
[[gnu::noinline]] void inward_6(T* frames) noexcept {
  const T* const of_20 = frames + 1251;
  T* const own = frames + 1185;
  const T Hb20_12 = of_20[frame::Hb_12];
  const T Hb20_13 = of_20[frame::Hb_13];
  const T Hb20_21 = of_20[frame::Hb_21];
  const T Hb20_23 = of_20[frame::Hb_23];
  const T Hb20_31 = of_20[frame::Hb_31];
  const T Hb20_32 = of_20[frame::Hb_32];
  const T Hb20_11 = of_20[frame::Hb_11];
  const T Hb20_22 = of_20[frame::Hb_22];
  const T minus_C20_11 = of_20[frame::minus_C_11];
  const T gb20_1 = of_20[frame::gb_1];
  const T C20_21 = of_20[frame::C_21];
  const T gb20_2 = of_20[frame::gb_2];
  const T C20_31 = of_20[frame::C_31];
  const T minus_gb20_3 = of_20[frame::minus_gb_3];
  const T G19_1 = own[frame::G_1];
  const T C20_32 = of_20[frame::C_32];
  const T C20_12 = of_20[frame::C_12];
  const T minus_C20_22 = of_20[frame::minus_C_22];
  const T G19_2 = own[frame::G_2];
  const T C20_13 = of_20[frame::C_13];
  const T C20_23 = of_20[frame::C_23];
  const T minus_C20_33 = of_20[frame::minus_C_33];
  const T G19_3 = own[frame::G_3];
  const T N19_1 = of_20[frame::N19_1];
  const T N19_2 = of_20[frame::N19_2];
  const T N19_3 = of_20[frame::N19_3];
  const T minus_Hb20_33 = of_20[frame::minus_Hb_33];
  const T minus_Mb20_11 = of_20[frame::minus_Mb_11];
  const T Mb20_12 = of_20[frame::Mb_12];
  const T Mb20_13 = of_20[frame::Mb_13];
  const T Mb20_22 = of_20[frame::Mb_22];
  const T Mb20_23 = of_20[frame::Mb_23];
  const T Mb20_33 = of_20[frame::Mb_33];
  const T minus_C19_11 = own[frame::minus_C_11];
  const T C19_21 = own[frame::C_21];
  const T C19_31 = own[frame::C_31];
  const T C19_12 = own[frame::C_12];
  const T minus_C19_22 = own[frame::minus_C_22];
  const T C19_32 = own[frame::C_32];
  const T minus_C19_33 = own[frame::minus_C_33];
  const T C19_13 = own[frame::C_13];
  const T C19_23 = own[frame::C_23];
  // HA19 = h_all_19~ + Hb20: moment for an acceleration of the origin, body axes [kg m]
  const T HA19_12 = Hb20_12 - T(0.445);
  const T HA19_13 = T(3.58) + Hb20_13;
  const T HA19_21 = T(0.445) + Hb20_21;
  const T HA19_23 = Hb20_23 - T(1.19);
  const T HA19_31 = Hb20_31 - T(3.58);
  const T HA19_32 = T(1.19) + Hb20_32;
  // JA19 = J_all_19 - Hb20 q20~: moment for an angular acceleration, body axes [kg m^2]
  const T JA19_11 = Hb20_13 + T(3.44325) - Hb20_12 * T(0.1);
  const T JA19_12 = Hb20_11 * T(0.1) - (T(0.9435) + Hb20_13 * T(0.3));
  const T JA19_13 = Hb20_12 * T(0.3) - (T(0.09580000000000001) + Hb20_11);
  const T JA19_22 = T(0.6842499999999999) + Hb20_21 * T(0.1) - Hb20_23 * T(0.3);
  const T JA19_23 = Hb20_22 * T(0.3) - (T(0.3406) + Hb20_21);
  const T JA19_33 = Hb20_32 * T(0.3) - (Hb20_31 - T(3.647));
  // g19 = C20^T gb20 + G19: force that drives it, home axes [N]
  const T b19_1 = minus_C20_11 * gb20_1 - C20_21 * gb20_2 + C20_31 * minus_gb20_3;
  const T g19_1 = G19_1 - b19_1;
  const T b19_2 = C20_32 * minus_gb20_3 - (C20_12 * gb20_1 - minus_C20_22 * gb20_2);
  const T g19_2 = G19_2 - b19_2;
  const T b19_3 = C20_13 * gb20_1 + C20_23 * gb20_2 + minus_C20_33 * minus_gb20_3;
  const T g19_3 = b19_3 + G19_3;
  // n19 = q20~ C20^T gb20 + N19: moment that drives it, body axes [N m]
  const T n19_1 = N19_1 + b19_3 + T(0.1) * b19_2;
  const T n19_2 = N19_2 - T(0.3) * b19_3 - T(0.1) * b19_1;
  const T n19_3 = b19_1 + N19_3 - T(0.3) * b19_2;
  // LD19 = L D L^T of JA19: L D L^T = JA: L, and 1/D on the diagonal
  const T LD19_11 = T(1) / JA19_11;
  const T LD19_21 = LD19_11 * JA19_12;
  const T LD19_22 = T(1) / (JA19_22 - LD19_21 * JA19_12);
  const T LD19_31 = LD19_11 * JA19_13;
  const T b19_4 = JA19_23 - LD19_21 * JA19_13;
  const T LD19_32 = LD19_22 * b19_4;
  const T minus_LD19_33 = T(1) / (LD19_32 * b19_4 - (JA19_33 - LD19_31 * JA19_13));
  // Y19 = L(LD19)^-1 HA19: L^-1 HA
  const T Y19_21 = HA19_21 - LD19_21 * Hb20_11;
  const T Y19_22 = Hb20_22 - LD19_21 * HA19_12;
  const T Y19_23 = HA19_23 - LD19_21 * HA19_13;
  const T Y19_31 = HA19_31 - LD19_31 * Hb20_11 - LD19_32 * Y19_21;
  const T Y19_32 = HA19_32 - LD19_31 * HA19_12 - LD19_32 * Y19_22;
  const T minus_Y19_33 = minus_Hb20_33 + LD19_31 * HA19_13 + LD19_32 * Y19_23;
  // W19 = D(LD19)^-1 Y19: D^-1 L^-1 HA
  const T W19_11 = LD19_11 * Hb20_11;
  const T W19_12 = LD19_11 * HA19_12;
  const T W19_13 = LD19_11 * HA19_13;
  const T W19_21 = LD19_22 * Y19_21;
  const T W19_22 = LD19_22 * Y19_22;
  const T W19_23 = LD19_22 * Y19_23;
  const T minus_W19_31 = minus_LD19_33 * Y19_31;
  const T minus_W19_32 = minus_LD19_33 * Y19_32;
  const T W19_33 = minus_LD19_33 * minus_Y19_33;
  // w_19 = D(LD19)^-1 L(LD19)^-1 n19: D^-1 L^-1 n
  const T w_19_1 = LD19_11 * n19_1;
  const T b19_5 = n19_2 - LD19_21 * n19_1;
  const T w_19_2 = LD19_22 * b19_5;
  const T w_19_3 = minus_LD19_33 * (LD19_32 * b19_5 - (n19_3 - LD19_31 * n19_1));
  // M19 = Mb20 - Y19^T W19: MA less what the ball takes up [kg]
  const T minus_M19_11 = minus_Mb20_11 + Hb20_11 * W19_11 + Y19_21 * W19_21 - Y19_31 * minus_W19_31;
  const T minus_M19_12 = Y19_21 * W19_22 - (Mb20_12 - Hb20_11 * W19_12) - Y19_31 * minus_W19_32;
  const T minus_M19_13 = Y19_21 * W19_23 - (Mb20_13 - Hb20_11 * W19_13) + Y19_31 * W19_33;
  const T minus_M19_22 = Y19_22 * W19_22 - (Mb20_22 - HA19_12 * W19_12) - Y19_32 * minus_W19_32;
  const T minus_M19_23 = Y19_22 * W19_23 - (Mb20_23 - HA19_12 * W19_13) + Y19_32 * W19_33;
  const T minus_M19_33 = Y19_23 * W19_23 - (Mb20_33 - HA19_13 * W19_13) - minus_Y19_33 * W19_33;
  // gb19 = g19 - Y19^T w_19: force with the ball solved [N]
  const T minus_gb19_1 = Y19_21 * w_19_2 - (g19_1 - Hb20_11 * w_19_1) + Y19_31 * w_19_3;
  const T minus_gb19_2 = Y19_22 * w_19_2 - (g19_2 - HA19_12 * w_19_1) + Y19_32 * w_19_3;
  const T minus_gb19_3 = Y19_23 * w_19_2 - (g19_3 - HA19_13 * w_19_1) - minus_Y19_33 * w_19_3;
  // Mb19 = C19^T M19 C19: M of the joint, lower body's axes
  const T b19_6 = minus_C19_11 * minus_M19_11 - C19_21 * minus_M19_12 - C19_31 * minus_M19_13;
  const T b19_7 = minus_C19_11 * minus_M19_12 - C19_21 * minus_M19_22 - C19_31 * minus_M19_23;
  const T b19_8 = C19_21 * minus_M19_23 - minus_C19_11 * minus_M19_13 + C19_31 * minus_M19_33;
  const T minus_Mb19_11 = b19_6 * minus_C19_11 - b19_7 * C19_21 + b19_8 * C19_31;
  const T Mb19_12 = b19_6 * C19_12 - b19_7 * minus_C19_22 - b19_8 * C19_32;
  const T Mb19_13 = b19_6 * C19_13 + b19_7 * C19_23 + b19_8 * minus_C19_33;
  const T minus_b19_9 = C19_12 * minus_M19_11 - minus_C19_22 * minus_M19_12 + C19_32 * minus_M19_13;
  const T minus_b19_10 = C19_12 * minus_M19_12 - minus_C19_22 * minus_M19_22 + C19_32 * minus_M19_23;
  const T b19_11 = C19_32 * minus_M19_33 - (minus_C19_22 * minus_M19_23 - C19_12 * minus_M19_13);
  const T Mb19_22 = minus_b19_10 * minus_C19_22 - minus_b19_9 * C19_12 - b19_11 * C19_32;
  const T Mb19_23 = b19_11 * minus_C19_33 - (minus_b19_9 * C19_13 + minus_b19_10 * C19_23);
  const T Mb19_33 = minus_Mb19_11 - (minus_M19_11 + minus_M19_22 + minus_M19_33) - Mb19_22;
  // Hb19 = q19~ Mb19: H of the joint at the lower body's origin, its axes
  const T b19_12 = T(0.95) * Mb19_13;
  const T minus_b19_13 = T(0.1) * Mb19_12;
  const T Hb19_11 = b19_12 - minus_b19_13;
  const T Hb19_12 = T(0.95) * Mb19_23 - T(0.1) * Mb19_22;
  const T Hb19_13 = T(0.95) * Mb19_33 - T(0.1) * Mb19_23;
  const T minus_Hb19_21 = T(0.1) * minus_Mb19_11 + T(0.3) * Mb19_13;
  const T minus_b19_14 = T(0.3) * Mb19_23;
  const T Hb19_22 = minus_b19_13 - minus_b19_14;
  const T Hb19_23 = T(0.1) * Mb19_13 - T(0.3) * Mb19_33;
  const T Hb19_31 = T(0.3) * Mb19_12 + T(0.95) * minus_Mb19_11;
  const T Hb19_32 = T(0.3) * Mb19_22 - T(0.95) * Mb19_12;
  const T minus_Hb19_33 = b19_12 - minus_b19_14;
  own[frame::w__1] = w_19_1;
  own[frame::w__2] = w_19_2;
  own[frame::gb_1] = -minus_gb19_1;
  own[frame::gb_2] = -minus_gb19_2;
  own[frame::Mb_13] = Mb19_13;
  own[frame::Mb_23] = Mb19_23;
  own[frame::Mb_33] = Mb19_33;
  own[frame::Hb_11] = Hb19_11;
  own[frame::Hb_12] = Hb19_12;
  own[frame::Hb_13] = Hb19_13;
  own[frame::Hb_21] = -minus_Hb19_21;
  own[frame::Hb_22] = Hb19_22;
  own[frame::Hb_23] = Hb19_23;
  own[frame::Hb_31] = Hb19_31;
  own[frame::Hb_32] = Hb19_32;
  own[frame::minus_Hb_33] = minus_Hb19_33;
  own[frame::LD_21] = LD19_21;
  own[frame::LD_31] = LD19_31;
  own[frame::LD_32] = LD19_32;
  own[frame::W_11] = W19_11;
  own[frame::W_12] = W19_12;
  own[frame::W_13] = W19_13;
  own[frame::W_21] = W19_21;
  own[frame::W_22] = W19_22;
  own[frame::W_23] = W19_23;
  own[frame::W_31] = -minus_W19_31;
  own[frame::W_32] = -minus_W19_32;
  own[frame::minus_W_33] = -W19_33;
  own[frame::minus_w__3] = -w_19_3;
  own[frame::minus_gb_3] = minus_gb19_3;
  own[frame::minus_Mb_11] = minus_Mb19_11;
  own[frame::Mb_12] = Mb19_12;
  own[frame::Mb_22] = Mb19_22;
}

// body 6 and what they carry
template <class T>
[[gnu::noinline]] void inward_7(T* frames) noexcept {
  const T* const of_7 = frames + 393;
  T* const own = frames + 327;
  const T minus_Mb7_11 = of_7[frame::minus_Mb_11];
  const T Mb7_22 = of_7[frame::Mb_22];
  const T Mb7_33 = of_7[frame::Mb_33];
  const T Hb7_12 = of_7[frame::Hb_12];
  const T Hb7_13 = of_7[frame::Hb_13];
  const T Hb7_21 = of_7[frame::Hb_21];
  const T Hb7_23 = of_7[frame::Hb_23];
  const T Hb7_31 = of_7[frame::Hb_31];
  const T Hb7_32 = of_7[frame::Hb_32];
  const T Hb7_11 = of_7[frame::Hb_11];
  const T Hb7_22 = of_7[frame::Hb_22];
  const T minus_C7_11 = of_7[frame::minus_C_11];
  const T gb7_1 = of_7[frame::gb_1];
  const T C7_21 = of_7[frame::C_21];
  const T gb7_2 = of_7[frame::gb_2];
  const T C7_31 = of_7[frame::C_31];
  const T minus_gb7_3 = of_7[frame::minus_gb_3];
  const T G6_1 = own[frame::G_1];
  const T C7_32 = of_7[frame::C_32];
  const T C7_12 = of_7[frame::C_12];
  const T minus_C7_22 = of_7[frame::minus_C_22];
  const T G6_2 = own[frame::G_2];
  const T C7_13 = of_7[frame::C_13];
  const T C7_23 = of_7[frame::C_23];
  const T minus_C7_33 = of_7[frame::minus_C_33];
  const T G6_3 = own[frame::G_3];
  const T N3_1 = of_7[frame::N3_1];
  const T N3_2 = of_7[frame::N3_2];
  const T N3_3 = of_7[frame::N3_3];
  const T minus_Hb7_33 = of_7[frame::minus_Hb_33];
  const T Mb7_12 = of_7[frame::Mb_12];
  const T Mb7_13 = of_7[frame::Mb_13];
  const T Mb7_23 = of_7[frame::Mb_23];
  const T minus_C6_11 = own[frame::minus_C_11];
  const T C6_21 = own[frame::C_21];
  const T C6_31 = own[frame::C_31];
  const T C6_12 = own[frame::C_12];
  const T minus_C6_22 = own[frame::minus_C_22];
  const T C6_32 = own[frame::C_32];
  const T C6_23 = own[frame::C_23];
  const T C6_13 = own[frame::C_13];
  const T minus_C6_33 = own[frame::minus_C_33];
  // MA6 = m_all_6 one + Mb7: force for an acceleration of the origin, home axes [kg]
  const T MA6_11 = T(5.1) - minus_Mb7_11;
  const T MA6_22 = T(5.1) + Mb7_22;
  const T MA6_33 = T(5.1) + Mb7_33;
  // HA6 = h_all_6~ + Hb7: moment for an acceleration of the origin, body axes [kg m]
  const T HA6_12 = Hb7_12 - T(0.43000000000000005);
  const T HA6_13 = T(1.545) + Hb7_13;
  const T HA6_21 = T(0.43000000000000005) + Hb7_21;
  const T HA6_23 = Hb7_23 - T(1.21);
  const T HA6_31 = Hb7_31 - T(1.545);
  const T HA6_32 = T(1.21) + Hb7_32;
  // JA6 = J_all_6 - Hb7 q7~: moment for an angular acceleration, body axes [kg m^2]
  const T JA6_11 = T(0.69175) + Hb7_13 * T(0.35) - Hb7_12 * T(0.1);
  const T JA6_12 = Hb7_11 * T(0.1) - (T(0.39149999999999996) + Hb7_13 * T(0.3));
  const T JA6_13 = Hb7_12 * T(0.3) - (T(0.1082) + Hb7_11 * T(0.35));
  const T JA6_22 = T(0.5619999999999999) + Hb7_21 * T(0.1) - Hb7_23 * T(0.3);
  const T JA6_23 = Hb7_22 * T(0.3) - (T(0.1449) + Hb7_21 * T(0.35));
  const T JA6_33 = T(0.95175) + Hb7_32 * T(0.3) - Hb7_31 * T(0.35);
  // g6 = C7^T gb7 + G6: force that drives it, home axes [N]
  const T b6_1 = minus_C7_11 * gb7_1 - C7_21 * gb7_2 + C7_31 * minus_gb7_3;
  const T g6_1 = G6_1 - b6_1;
  const T b6_2 = C7_32 * minus_gb7_3 - (C7_12 * gb7_1 - minus_C7_22 * gb7_2);
  const T g6_2 = G6_2 - b6_2;
  const T b6_3 = C7_13 * gb7_1 + C7_23 * gb7_2 + minus_C7_33 * minus_gb7_3;
  const T g6_3 = b6_3 + G6_3;
  // n6 = q7~ C7^T gb7 + N6: moment that drives it, body axes [N m]
  const T n6_1 = N3_1 + T(0.1) * b6_2 + T(0.35) * b6_3;
  const T n6_2 = N3_2 - T(0.3) * b6_3 - T(0.1) * b6_1;
  const T n6_3 = N3_3 + T(0.35) * b6_1 - T(0.3) * b6_2;
  // LD6 = L D L^T of JA6: L D L^T = JA: L, and 1/D on the diagonal
  const T LD6_11 = T(1) / JA6_11;
  const T LD6_21 = LD6_11 * JA6_12;
  const T LD6_22 = T(1) / (JA6_22 - LD6_21 * JA6_12);
  const T LD6_31 = LD6_11 * JA6_13;
  const T b6_4 = JA6_23 - LD6_21 * JA6_13;
  const T LD6_32 = LD6_22 * b6_4;
  const T minus_LD6_33 = T(1) / (LD6_32 * b6_4 - (JA6_33 - LD6_31 * JA6_13));
  // Y6 = L(LD6)^-1 HA6: L^-1 HA
  const T Y6_21 = HA6_21 - LD6_21 * Hb7_11;
  const T Y6_22 = Hb7_22 - LD6_21 * HA6_12;
  const T Y6_23 = HA6_23 - LD6_21 * HA6_13;
  const T Y6_31 = HA6_31 - LD6_31 * Hb7_11 - LD6_32 * Y6_21;
  const T Y6_32 = HA6_32 - LD6_31 * HA6_12 - LD6_32 * Y6_22;
  const T minus_Y6_33 = minus_Hb7_33 + LD6_31 * HA6_13 + LD6_32 * Y6_23;
  // W6 = D(LD6)^-1 Y6: D^-1 L^-1 HA
  const T W6_11 = LD6_11 * Hb7_11;
  const T W6_12 = LD6_11 * HA6_12;
  const T W6_13 = LD6_11 * HA6_13;
  const T W6_21 = LD6_22 * Y6_21;
  const T W6_22 = LD6_22 * Y6_22;
  const T W6_23 = LD6_22 * Y6_23;
  const T minus_W6_31 = minus_LD6_33 * Y6_31;
  const T minus_W6_32 = minus_LD6_33 * Y6_32;
  const T W6_33 = minus_LD6_33 * minus_Y6_33;
  // w_6 = D(LD6)^-1 L(LD6)^-1 n6: D^-1 L^-1 n
  const T w_6_1 = LD6_11 * n6_1;
  const T b6_5 = n6_2 - LD6_21 * n6_1;
  const T w_6_2 = LD6_22 * b6_5;
  const T w_6_3 = minus_LD6_33 * (LD6_32 * b6_5 - (n6_3 - LD6_31 * n6_1));
  // M6 = MA6 - Y6^T W6: MA less what the ball takes up [kg]
  const T minus_M6_11 = Y6_21 * W6_21 - (MA6_11 - Hb7_11 * W6_11) - Y6_31 * minus_W6_31;
  const T minus_M6_12 = Y6_21 * W6_22 - (Mb7_12 - Hb7_11 * W6_12) - Y6_31 * minus_W6_32;
  const T minus_M6_13 = Y6_21 * W6_23 - (Mb7_13 - Hb7_11 * W6_13) + Y6_31 * W6_33;
  const T minus_M6_22 = Y6_22 * W6_22 - (MA6_22 - HA6_12 * W6_12) - Y6_32 * minus_W6_32;
  const T minus_M6_23 = Y6_22 * W6_23 - (Mb7_23 - HA6_12 * W6_13) + Y6_32 * W6_33;
  const T minus_M6_33 = Y6_23 * W6_23 - (MA6_33 - HA6_13 * W6_13) - minus_Y6_33 * W6_33;
  // gb6 = g6 - Y6^T w_6: force with the ball solved [N]
  const T minus_gb6_1 = Y6_21 * w_6_2 - (g6_1 - Hb7_11 * w_6_1) + Y6_31 * w_6_3;
  const T minus_gb6_2 = Y6_22 * w_6_2 - (g6_2 - HA6_12 * w_6_1) + Y6_32 * w_6_3;
  const T minus_gb6_3 = Y6_23 * w_6_2 - (g6_3 - HA6_13 * w_6_1) - minus_Y6_33 * w_6_3;
  // Mb6 = C6^T M6 C6: M of the joint, lower body's axes
  const T b6_6 = minus_C6_11 * minus_M6_11 - C6_21 * minus_M6_12 - C6_31 * minus_M6_13;
  const T b6_7 = minus_C6_11 * minus_M6_12 - C6_21 * minus_M6_22 - C6_31 * minus_M6_23;
  const T b6_8 = C6_21 * minus_M6_23 - minus_C6_11 * minus_M6_13 + C6_31 * minus_M6_33;
  const T minus_Mb6_11 = b6_6 * minus_C6_11 - b6_7 * C6_21 + b6_8 * C6_31;
  const T Mb6_12 = b6_6 * C6_12 - b6_7 * minus_C6_22 - b6_8 * C6_32;
  const T Mb6_13 = b6_6 * C6_13 + b6_7 * C6_23 + b6_8 * minus_C6_33;
  const T minus_b6_9 = C6_12 * minus_M6_11 - minus_C6_22 * minus_M6_12 + C6_32 * minus_M6_13;
  const T minus_b6_10 = C6_12 * minus_M6_12 - minus_C6_22 * minus_M6_22 + C6_32 * minus_M6_23;
  const T b6_11 = C6_32 * minus_M6_33 - (minus_C6_22 * minus_M6_23 - C6_12 * minus_M6_13);
  const T Mb6_22 = minus_b6_10 * minus_C6_22 - minus_b6_9 * C6_12 - b6_11 * C6_32;
  const T Mb6_23 = b6_11 * minus_C6_33 - (minus_b6_9 * C6_13 + minus_b6_10 * C6_23);
  const T Mb6_33 = minus_Mb6_11 - (minus_M6_11 + minus_M6_22 + minus_M6_33) - Mb6_22;
  // Hb6 = q6~ Mb6: H of the joint at the lower body's origin, its axes
  const T b6_12 = T(0.3) * Mb6_13;
  const T minus_b6_13 = T(0.1) * Mb6_12;
  const T Hb6_11 = b6_12 - minus_b6_13;
  const T b6_14 = T(0.3) * Mb6_23;
  const T Hb6_12 = b6_14 - T(0.1) * Mb6_22;
  const T b6_15 = T(0.3) * Mb6_33;
  const T Hb6_13 = b6_15 - T(0.1) * Mb6_23;
  const T minus_Hb6_21 = T(0.1) * minus_Mb6_11 + b6_12;
  const T minus_Hb6_22 = b6_14 - minus_b6_13;
  const T Hb6_23 = T(0.1) * Mb6_13 - b6_15;
  const T b6_16 = T(0.3) * Mb6_12;
  const T Hb6_31 = b6_16 + T(0.3) * minus_Mb6_11;
  const T Hb6_32 = T(0.3) * Mb6_22 - b6_16;
  const T Hb6_33 = b6_14 - b6_12;
  own[frame::w__1] = w_6_1;
  own[frame::w__2] = w_6_2;
  own[frame::gb_1] = -minus_gb6_1;
  own[frame::gb_2] = -minus_gb6_2;
  own[frame::Mb_13] = Mb6_13;
  own[frame::Mb_23] = Mb6_23;
  own[frame::Mb_33] = Mb6_33;
  own[frame::Hb_11] = Hb6_11;
  own[frame::Hb_12] = Hb6_12;
  own[frame::Hb_13] = Hb6_13;
  own[frame::Hb_21] = -minus_Hb6_21;
  own[frame::Hb_23] = Hb6_23;
  own[frame::Hb_31] = Hb6_31;
  own[frame::Hb_32] = Hb6_32;
  own[frame::LD_21] = LD6_21;
  own[frame::LD_31] = LD6_31;
  own[frame::LD_32] = LD6_32;
  own[frame::W_11] = W6_11;
  own[frame::W_12] = W6_12;
  own[frame::W_13] = W6_13;
  own[frame::W_21] = W6_21;
  own[frame::W_22] = W6_22;
  own[frame::W_23] = W6_23;
  own[frame::W_31] = -minus_W6_31;
  own[frame::W_32] = -minus_W6_32;
  own[frame::minus_W_33] = -W6_33;
  own[frame::minus_w__3] = -w_6_3;
  own[frame::minus_gb_3] = minus_gb6_3;
  own[frame::minus_Mb_11] = minus_Mb6_11;
  own[frame::Mb_12] = Mb6_12;
  own[frame::Mb_22] = Mb6_22;
  own[frame::minus_Hb_22] = minus_Hb6_22;
  own[frame::Hb_33] = Hb6_33;
}

// body 5 and what they carry
template <class T>
[[gnu::noinline]] void inward_8(T* frames) noexcept {
  const T* const of_6 = frames + 327;
  T* const own = frames + 261;
  const T Hb6_12 = of_6[frame::Hb_12];
  const T Hb6_13 = of_6[frame::Hb_13];
  const T Hb6_21 = of_6[frame::Hb_21];
  const T Hb6_23 = of_6[frame::Hb_23];
  const T Hb6_31 = of_6[frame::Hb_31];
  const T Hb6_32 = of_6[frame::Hb_32];
  const T Hb6_11 = of_6[frame::Hb_11];
  const T minus_Hb6_22 = of_6[frame::minus_Hb_22];
  const T minus_C6_11 = of_6[frame::minus_C_11];
  const T gb6_1 = of_6[frame::gb_1];
  const T C6_21 = of_6[frame::C_21];
  const T gb6_2 = of_6[frame::gb_2];
  const T C6_31 = of_6[frame::C_31];
  const T minus_gb6_3 = of_6[frame::minus_gb_3];
  const T G5_1 = own[frame::G_1];
  const T C6_32 = of_6[frame::C_32];
  const T C6_12 = of_6[frame::C_12];
  const T minus_C6_22 = of_6[frame::minus_C_22];
  const T G5_2 = own[frame::G_2];
  const T C6_13 = of_6[frame::C_13];
  const T C6_23 = of_6[frame::C_23];
  const T minus_C6_33 = of_6[frame::minus_C_33];
  const T G5_3 = own[frame::G_3];
  const T N5_1 = of_6[frame::N5_1];
  const T N5_2 = of_6[frame::N5_2];
  const T N5_3 = of_6[frame::N5_3];
  const T Hb6_33 = of_6[frame::Hb_33];
  const T minus_Mb6_11 = of_6[frame::minus_Mb_11];
  const T Mb6_12 = of_6[frame::Mb_12];
  const T Mb6_13 = of_6[frame::Mb_13];
  const T Mb6_22 = of_6[frame::Mb_22];
  const T Mb6_23 = of_6[frame::Mb_23];
  const T Mb6_33 = of_6[frame::Mb_33];
  const T C5_31 = own[frame::C_31];
  const T minus_C5_11 = own[frame::minus_C_11];
  const T C5_21 = own[frame::C_21];
  const T minus_C5_22 = own[frame::minus_C_22];
  const T C5_12 = own[frame::C_12];
  const T C5_32 = own[frame::C_32];
  const T minus_C5_33 = own[frame::minus_C_33];
  const T C5_13 = own[frame::C_13];
  const T C5_23 = own[frame::C_23];
  // HA5 = h_all_5~ + Hb6: moment for an acceleration of the origin, body axes [kg m]
  const T HA5_12 = Hb6_12 - T(0.07500000000000001);
  const T HA5_13 = T(0.30000000000000004) + Hb6_13;
  const T HA5_21 = T(0.07500000000000001) + Hb6_21;
  const T HA5_23 = Hb6_23 - T(0.15000000000000002);
  const T HA5_31 = Hb6_31 - T(0.30000000000000004);
  const T HA5_32 = T(0.15000000000000002) + Hb6_32;
  // JA5 = J_all_5 - Hb6 q6~: moment for an angular acceleration, body axes [kg m^2]
  const T b5_1 = Hb6_13 * T(0.3);
  const T JA5_11 = b5_1 + T(0.21375) - Hb6_12 * T(0.1);
  const T JA5_12 = Hb6_11 * T(0.1) - (T(0.022500000000000003) + b5_1);
  const T JA5_13 = Hb6_12 * T(0.3) - (T(0.0030000000000000014) + Hb6_11 * T(0.3));
  const T JA5_22 = T(0.19874999999999998) + Hb6_21 * T(0.1) - Hb6_23 * T(0.3);
  const T minus_JA5_23 = T(0.021) + Hb6_21 * T(0.3) + minus_Hb6_22 * T(0.3);
  const T JA5_33 = T(0.195) + Hb6_32 * T(0.3) - Hb6_31 * T(0.3);
  // g5 = C6^T gb6 + G5: force that drives it, home axes [N]
  const T b5_2 = minus_C6_11 * gb6_1 - C6_21 * gb6_2 + C6_31 * minus_gb6_3;
  const T g5_1 = G5_1 - b5_2;
  const T b5_3 = C6_32 * minus_gb6_3 - (C6_12 * gb6_1 - minus_C6_22 * gb6_2);
  const T g5_2 = G5_2 - b5_3;
  const T b5_4 = C6_13 * gb6_1 + C6_23 * gb6_2 + minus_C6_33 * minus_gb6_3;
  const T g5_3 = b5_4 + G5_3;
  // n5 = q6~ C6^T gb6 + N5: moment that drives it, body axes [N m]
  const T b5_5 = T(0.3) * b5_4;
  const T n5_1 = N5_1 + b5_5 + T(0.1) * b5_3;
  const T minus_n5_2 = b5_5 - N5_2 + T(0.1) * b5_2;
  const T n5_3 = N5_3 + T(0.3) * b5_2 - T(0.3) * b5_3;
  // LD5 = L D L^T of JA5: L D L^T = JA: L, and 1/D on the diagonal
  const T LD5_11 = T(1) / JA5_11;
  const T LD5_21 = LD5_11 * JA5_12;
  const T LD5_22 = T(1) / (JA5_22 - LD5_21 * JA5_12);
  const T LD5_31 = LD5_11 * JA5_13;
  const T minus_b5_6 = minus_JA5_23 + LD5_21 * JA5_13;
  const T minus_LD5_32 = LD5_22 * minus_b5_6;
  const T minus_LD5_33 = T(1) / (minus_LD5_32 * minus_b5_6 - (JA5_33 - LD5_31 * JA5_13));
  // Y5 = L(LD5)^-1 HA5: L^-1 HA
  const T Y5_21 = HA5_21 - LD5_21 * Hb6_11;
  const T minus_Y5_22 = minus_Hb6_22 + LD5_21 * HA5_12;
  const T Y5_23 = HA5_23 - LD5_21 * HA5_13;
  const T Y5_31 = HA5_31 - LD5_31 * Hb6_11 + minus_LD5_32 * Y5_21;
  const T Y5_32 = HA5_32 - LD5_31 * HA5_12 - minus_LD5_32 * minus_Y5_22;
  const T Y5_33 = Hb6_33 - LD5_31 * HA5_13 + minus_LD5_32 * Y5_23;
  // W5 = D(LD5)^-1 Y5: D^-1 L^-1 HA
  const T W5_11 = LD5_11 * Hb6_11;
  const T W5_12 = LD5_11 * HA5_12;
  const T W5_13 = LD5_11 * HA5_13;
  const T W5_21 = LD5_22 * Y5_21;
  const T minus_W5_22 = LD5_22 * minus_Y5_22;
  const T W5_23 = LD5_22 * Y5_23;
  const T minus_W5_31 = minus_LD5_33 * Y5_31;
  const T minus_W5_32 = minus_LD5_33 * Y5_32;
  const T minus_W5_33 = minus_LD5_33 * Y5_33;
  // w_5 = D(LD5)^-1 L(LD5)^-1 n5: D^-1 L^-1 n
  const T w_5_1 = LD5_11 * n5_1;
  const T minus_b5_7 = minus_n5_2 + LD5_21 * n5_1;
  const T minus_w_5_2 = LD5_22 * minus_b5_7;
  const T w_5_3 = minus_LD5_33 * (minus_LD5_32 * minus_b5_7 - (n5_3 - LD5_31 * n5_1));
  // M5 = Mb6 - Y5^T W5: MA less what the ball takes up [kg]
  const T minus_M5_11 = minus_Mb6_11 + Hb6_11 * W5_11 + Y5_21 * W5_21 - Y5_31 * minus_W5_31;
  const T M5_12 = Mb6_12 - Hb6_11 * W5_12 + Y5_21 * minus_W5_22 + Y5_31 * minus_W5_32;
  const T minus_M5_13 = Y5_21 * W5_23 - (Mb6_13 - Hb6_11 * W5_13) - Y5_31 * minus_W5_33;
  const T minus_M5_22 = minus_Y5_22 * minus_W5_22 - (Mb6_22 - HA5_12 * W5_12) - Y5_32 * minus_W5_32;
  const T M5_23 = Mb6_23 - HA5_12 * W5_13 + minus_Y5_22 * W5_23 + Y5_32 * minus_W5_33;
  const T minus_M5_33 = Y5_23 * W5_23 - (Mb6_33 - HA5_13 * W5_13) - Y5_33 * minus_W5_33;
  // gb5 = g5 - Y5^T w_5: force with the ball solved [N]
  const T gb5_1 = g5_1 - Hb6_11 * w_5_1 + Y5_21 * minus_w_5_2 - Y5_31 * w_5_3;
  const T gb5_2 = g5_2 - HA5_12 * w_5_1 - minus_Y5_22 * minus_w_5_2 - Y5_32 * w_5_3;
  const T gb5_3 = g5_3 - HA5_13 * w_5_1 + Y5_23 * minus_w_5_2 - Y5_33 * w_5_3;
  // Mb5 = C5^T M5 C5: M of the joint, lower body's axes
  const T b5_8 = C5_31 * minus_M5_13 - (minus_C5_11 * minus_M5_11 + C5_21 * M5_12);
  const T b5_9 = C5_31 * M5_23 - (minus_C5_11 * M5_12 + C5_21 * minus_M5_22);
  const T b5_10 = C5_31 * minus_M5_33 - (minus_C5_11 * minus_M5_13 + C5_21 * M5_23);
  const T Mb5_11 = b5_8 * minus_C5_11 + b5_9 * C5_21 - b5_10 * C5_31;
  const T minus_Mb5_12 = b5_8 * C5_12 + b5_9 * minus_C5_22 + b5_10 * C5_32;
  const T Mb5_13 = b5_10 * minus_C5_33 - (b5_8 * C5_13 - b5_9 * C5_23);
  const T b5_11 = C5_12 * minus_M5_11 + minus_C5_22 * M5_12 + C5_32 * minus_M5_13;
  const T b5_12 = C5_12 * M5_12 + minus_C5_22 * minus_M5_22 + C5_32 * M5_23;
  const T b5_13 = C5_12 * minus_M5_13 + minus_C5_22 * M5_23 + C5_32 * minus_M5_33;
  const T minus_Mb5_22 = b5_11 * C5_12 + b5_12 * minus_C5_22 + b5_13 * C5_32;
  const T Mb5_23 = b5_13 * minus_C5_33 - (b5_11 * C5_13 - b5_12 * C5_23);
  const T Mb5_33 = minus_Mb5_22 - (minus_M5_11 + minus_M5_22 + minus_M5_33 + Mb5_11);
  // Hb5 = q5~ Mb5: H of the joint at the lower body's origin, its axes
  const T b5_14 = T(0.25) * Mb5_13;
  const T b5_15 = T(0.1) * minus_Mb5_12;
  const T Hb5_11 = b5_14 + b5_15;
  const T Hb5_12 = T(0.25) * Mb5_23 + T(0.1) * minus_Mb5_22;
  const T Hb5_13 = T(0.25) * Mb5_33 - T(0.1) * Mb5_23;
  const T Hb5_21 = T(0.1) * Mb5_11 - T(0.3) * Mb5_13;
  const T minus_b5_16 = T(0.3) * Mb5_23;
  const T minus_Hb5_22 = minus_b5_16 + b5_15;
  const T Hb5_23 = T(0.1) * Mb5_13 - T(0.3) * Mb5_33;
  const T minus_Hb5_31 = T(0.3) * minus_Mb5_12 + T(0.25) * Mb5_11;
  const T Hb5_32 = T(0.25) * minus_Mb5_12 - T(0.3) * minus_Mb5_22;
  const T minus_Hb5_33 = b5_14 - minus_b5_16;
  own[frame::w__1] = w_5_1;
  own[frame::w__2] = -minus_w_5_2;
  own[frame::gb_1] = gb5_1;
  own[frame::gb_2] = gb5_2;
  own[frame::gb_3] = gb5_3;
  own[frame::Mb_11] = Mb5_11;
  own[frame::minus_Mb_12] = minus_Mb5_12;
  own[frame::Mb_13] = Mb5_13;
  own[frame::minus_Mb_22] = minus_Mb5_22;
  own[frame::Mb_23] = Mb5_23;
  own[frame::Mb_33] = Mb5_33;
  own[frame::Hb_11] = Hb5_11;
  own[frame::Hb_12] = Hb5_12;
  own[frame::Hb_13] = Hb5_13;
  own[frame::Hb_21] = Hb5_21;
  own[frame::Hb_22] = -minus_Hb5_22;
  own[frame::Hb_23] = Hb5_23;
  own[frame::Hb_31] = -minus_Hb5_31;
  own[frame::Hb_32] = Hb5_32;
  own[frame::minus_Hb_33] = minus_Hb5_33;
  own[frame::LD_21] = LD5_21;
  own[frame::LD_31] = LD5_31;
  own[frame::LD_32] = -minus_LD5_32;
  own[frame::W_11] = W5_11;
  own[frame::W_12] = W5_12;
  own[frame::W_13] = W5_13;
  own[frame::W_21] = W5_21;
  own[frame::W_23] = W5_23;
  own[frame::W_31] = -minus_W5_31;
  own[frame::W_32] = -minus_W5_32;
  own[frame::minus_w__3] = -w_5_3;
  own[frame::minus_W_22] = minus_W5_22;
  own[frame::W_33] = -minus_W5_33;
}

// body 2 and what they carry
template <class T>
[[gnu::noinline]] void inward_9(T* frames) noexcept {
  const T* const of_3 = frames + 129;
  T* const own = frames + 63;
  const T Hb3_12 = of_3[frame::Hb_12];
  const T Hb3_13 = of_3[frame::Hb_13];
  const T Hb3_21 = of_3[frame::Hb_21];
  const T Hb3_23 = of_3[frame::Hb_23];
  const T Hb3_31 = of_3[frame::Hb_31];
  const T Hb3_32 = of_3[frame::Hb_32];
  const T Hb3_11 = of_3[frame::Hb_11];
  const T Hb3_22 = of_3[frame::Hb_22];
  const T minus_C3_11 = of_3[frame::minus_C_11];
  const T gb3_1 = of_3[frame::gb_1];
  const T C3_21 = of_3[frame::C_21];
  const T gb3_2 = of_3[frame::gb_2];
  const T C3_31 = of_3[frame::C_31];
  const T minus_gb3_3 = of_3[frame::minus_gb_3];
  const T G2_1 = own[frame::G_1];
  const T C3_32 = of_3[frame::C_32];
  const T C3_12 = of_3[frame::C_12];
  const T minus_C3_22 = of_3[frame::minus_C_22];
  const T G2_2 = own[frame::G_2];
  const T C3_13 = of_3[frame::C_13];
  const T C3_23 = of_3[frame::C_23];
  const T minus_C3_33 = of_3[frame::minus_C_33];
  const T G2_3 = own[frame::G_3];
  const T N2_1 = of_3[frame::N2_1];
  const T N2_2 = of_3[frame::N2_2];
  const T N2_3 = of_3[frame::N2_3];
  const T minus_Hb3_33 = of_3[frame::minus_Hb_33];
  const T minus_Mb3_11 = of_3[frame::minus_Mb_11];
  const T Mb3_12 = of_3[frame::Mb_12];
  const T Mb3_13 = of_3[frame::Mb_13];
  const T Mb3_22 = of_3[frame::Mb_22];
  const T Mb3_23 = of_3[frame::Mb_23];
  const T Mb3_33 = of_3[frame::Mb_33];
  const T C2_31 = own[frame::C_31];
  const T minus_C2_11 = own[frame::minus_C_11];
  const T C2_21 = own[frame::C_21];
  const T C2_12 = own[frame::C_12];
  const T minus_C2_22 = own[frame::minus_C_22];
  const T C2_32 = own[frame::C_32];
  const T minus_C2_33 = own[frame::minus_C_33];
  const T C2_23 = own[frame::C_23];
  const T C2_13 = own[frame::C_13];
  // HA2 = h_all_2~ + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA2_12 = Hb3_12 - T(0.06);
  const T HA2_13 = T(0.24) + Hb3_13;
  const T HA2_21 = T(0.06) + Hb3_21;
  const T HA2_23 = Hb3_23 - T(0.12);
  const T HA2_31 = Hb3_31 - T(0.24);
  const T HA2_32 = T(0.12) + Hb3_32;
  // JA2 = J_all_2 - Hb3 q3~: moment for an angular acceleration, body axes [kg m^2]
  const T JA2_11 = T(0.171) + Hb3_13 * T(0.15) - Hb3_12 * T(0.1);
  const T JA2_12 = Hb3_11 * T(0.1) - (T(0.018000000000000002) + Hb3_13 * T(0.3));
  const T JA2_13 = Hb3_12 * T(0.3) - (T(0.0024000000000000007) + Hb3_11 * T(0.15));
  const T JA2_22 = T(0.159) + Hb3_21 * T(0.1) - Hb3_23 * T(0.3);
  const T JA2_23 = Hb3_22 * T(0.3) - (T(0.0168) + Hb3_21 * T(0.15));
  const T JA2_33 = T(0.156) + Hb3_32 * T(0.3) - Hb3_31 * T(0.15);
  // g2 = C3^T gb3 + G2: force that drives it, home axes [N]
  const T b2_1 = minus_C3_11 * gb3_1 - C3_21 * gb3_2 + C3_31 * minus_gb3_3;
  const T g2_1 = G2_1 - b2_1;
  const T b2_2 = C3_32 * minus_gb3_3 - (C3_12 * gb3_1 - minus_C3_22 * gb3_2);
  const T g2_2 = G2_2 - b2_2;
  const T b2_3 = C3_13 * gb3_1 + C3_23 * gb3_2 + minus_C3_33 * minus_gb3_3;
  const T g2_3 = b2_3 + G2_3;
  // n2 = q3~ C3^T gb3 + N2: moment that drives it, body axes [N m]
  const T n2_1 = N2_1 + T(0.1) * b2_2 + T(0.15) * b2_3;
  const T n2_2 = N2_2 - T(0.3) * b2_3 - T(0.1) * b2_1;
  const T n2_3 = N2_3 + T(0.15) * b2_1 - T(0.3) * b2_2;
  // LD2 = L D L^T of JA2: L D L^T = JA: L, and 1/D on the diagonal
  const T LD2_11 = T(1) / JA2_11;
  const T LD2_21 = LD2_11 * JA2_12;
  const T LD2_22 = T(1) / (JA2_22 - LD2_21 * JA2_12);
  const T LD2_31 = LD2_11 * JA2_13;
  const T b2_4 = JA2_23 - LD2_21 * JA2_13;
  const T LD2_32 = LD2_22 * b2_4;
  const T minus_LD2_33 = T(1) / (LD2_32 * b2_4 - (JA2_33 - LD2_31 * JA2_13));
  // Y2 = L(LD2)^-1 HA2: L^-1 HA
  const T Y2_21 = HA2_21 - LD2_21 * Hb3_11;
  const T Y2_22 = Hb3_22 - LD2_21 * HA2_12;
  const T Y2_23 = HA2_23 - LD2_21 * HA2_13;
  const T Y2_31 = HA2_31 - LD2_31 * Hb3_11 - LD2_32 * Y2_21;
  const T Y2_32 = HA2_32 - LD2_31 * HA2_12 - LD2_32 * Y2_22;
  const T minus_Y2_33 = minus_Hb3_33 + LD2_31 * HA2_13 + LD2_32 * Y2_23;
  // W2 = D(LD2)^-1 Y2: D^-1 L^-1 HA
  const T W2_11 = LD2_11 * Hb3_11;
  const T W2_12 = LD2_11 * HA2_12;
  const T W2_13 = LD2_11 * HA2_13;
  const T W2_21 = LD2_22 * Y2_21;
  const T W2_22 = LD2_22 * Y2_22;
  const T W2_23 = LD2_22 * Y2_23;
  const T minus_W2_31 = minus_LD2_33 * Y2_31;
  const T minus_W2_32 = minus_LD2_33 * Y2_32;
  const T W2_33 = minus_LD2_33 * minus_Y2_33;
  // w_2 = D(LD2)^-1 L(LD2)^-1 n2: D^-1 L^-1 n
  const T w_2_1 = LD2_11 * n2_1;
  const T b2_5 = n2_2 - LD2_21 * n2_1;
  const T w_2_2 = LD2_22 * b2_5;
  const T w_2_3 = minus_LD2_33 * (LD2_32 * b2_5 - (n2_3 - LD2_31 * n2_1));
  // M2 = Mb3 - Y2^T W2: MA less what the ball takes up [kg]
  const T minus_M2_11 = minus_Mb3_11 + Hb3_11 * W2_11 + Y2_21 * W2_21 - Y2_31 * minus_W2_31;
  const T minus_M2_12 = Y2_21 * W2_22 - (Mb3_12 - Hb3_11 * W2_12) - Y2_31 * minus_W2_32;
  const T minus_M2_13 = Y2_21 * W2_23 - (Mb3_13 - Hb3_11 * W2_13) + Y2_31 * W2_33;
  const T minus_M2_22 = Y2_22 * W2_22 - (Mb3_22 - HA2_12 * W2_12) - Y2_32 * minus_W2_32;
  const T minus_M2_23 = Y2_22 * W2_23 - (Mb3_23 - HA2_12 * W2_13) + Y2_32 * W2_33;
  const T minus_M2_33 = Y2_23 * W2_23 - (Mb3_33 - HA2_13 * W2_13) - minus_Y2_33 * W2_33;
  // gb2 = g2 - Y2^T w_2: force with the ball solved [N]
  const T minus_gb2_1 = Y2_21 * w_2_2 - (g2_1 - Hb3_11 * w_2_1) + Y2_31 * w_2_3;
  const T minus_gb2_2 = Y2_22 * w_2_2 - (g2_2 - HA2_12 * w_2_1) + Y2_32 * w_2_3;
  const T minus_gb2_3 = Y2_23 * w_2_2 - (g2_3 - HA2_13 * w_2_1) - minus_Y2_33 * w_2_3;
  // Mb2 = C2^T M2 C2: M of the joint, lower body's axes
  const T b2_6 = minus_C2_11 * minus_M2_11 - C2_21 * minus_M2_12 - C2_31 * minus_M2_13;
  const T b2_7 = minus_C2_11 * minus_M2_12 - C2_21 * minus_M2_22 - C2_31 * minus_M2_23;
  const T b2_8 = C2_21 * minus_M2_23 - minus_C2_11 * minus_M2_13 + C2_31 * minus_M2_33;
  const T minus_Mb2_11 = b2_6 * minus_C2_11 - b2_7 * C2_21 + b2_8 * C2_31;
  const T Mb2_12 = b2_6 * C2_12 - b2_7 * minus_C2_22 - b2_8 * C2_32;
  const T Mb2_13 = b2_6 * C2_13 + b2_7 * C2_23 + b2_8 * minus_C2_33;
  const T minus_b2_9 = C2_12 * minus_M2_11 - minus_C2_22 * minus_M2_12 + C2_32 * minus_M2_13;
  const T minus_b2_10 = C2_12 * minus_M2_12 - minus_C2_22 * minus_M2_22 + C2_32 * minus_M2_23;
  const T b2_11 = C2_32 * minus_M2_33 - (minus_C2_22 * minus_M2_23 - C2_12 * minus_M2_13);
  const T Mb2_22 = minus_b2_10 * minus_C2_22 - minus_b2_9 * C2_12 - b2_11 * C2_32;
  const T Mb2_23 = b2_11 * minus_C2_33 - (minus_b2_9 * C2_13 + minus_b2_10 * C2_23);
  const T Mb2_33 = minus_Mb2_11 - (minus_M2_11 + minus_M2_22 + minus_M2_33) - Mb2_22;
  // Hb2 = q2~ Mb2: H of the joint at the lower body's origin, its axes
  const T b2_12 = T(0.1) * Mb2_13;
  const T minus_b2_13 = T(0.1) * Mb2_12;
  const T Hb2_11 = b2_12 - minus_b2_13;
  const T b2_14 = T(0.1) * Mb2_23;
  const T Hb2_12 = b2_14 - T(0.1) * Mb2_22;
  const T Hb2_13 = T(0.1) * Mb2_33 - b2_14;
  const T minus_b2_15 = T(0.1) * minus_Mb2_11;
  const T minus_Hb2_21 = minus_b2_15 + T(0.3) * Mb2_13;
  const T Hb2_22 = minus_b2_13 - T(0.3) * Mb2_23;
  const T Hb2_23 = b2_12 - T(0.3) * Mb2_33;
  const T Hb2_31 = T(0.3) * Mb2_12 + minus_b2_15;
  const T Hb2_32 = T(0.3) * Mb2_22 - minus_b2_13;
  own[frame::w__1] = w_2_1;
  own[frame::w__2] = w_2_2;
  own[frame::gb_1] = -minus_gb2_1;
  own[frame::gb_2] = -minus_gb2_2;
  own[frame::Hb_11] = Hb2_11;
  own[frame::Hb_12] = Hb2_12;
  own[frame::Hb_13] = Hb2_13;
  own[frame::Hb_21] = -minus_Hb2_21;
  own[frame::Hb_22] = Hb2_22;
  own[frame::Hb_23] = Hb2_23;
  own[frame::Hb_31] = Hb2_31;
  own[frame::Hb_32] = Hb2_32;
  own[frame::LD_21] = LD2_21;
  own[frame::LD_31] = LD2_31;
  own[frame::LD_32] = LD2_32;
  own[frame::W_11] = W2_11;
  own[frame::W_12] = W2_12;
  own[frame::W_13] = W2_13;
  own[frame::W_21] = W2_21;
  own[frame::W_22] = W2_22;
  own[frame::W_23] = W2_23;
  own[frame::W_31] = -minus_W2_31;
  own[frame::W_32] = -minus_W2_32;
  own[frame::minus_W_33] = -W2_33;
  own[frame::minus_w__3] = -w_2_3;
  own[frame::minus_gb_3] = minus_gb2_3;
}

// body 1 and what they carry
template <class T>
[[gnu::noinline]] void inward_10(T* ydot, T* frames) noexcept {
  const T* const of_2 = frames + 63;
  T* const own = frames + 0;
  const T Hb2_12 = of_2[frame::Hb_12];
  const T Hb2_13 = of_2[frame::Hb_13];
  const T Hb2_11 = of_2[frame::Hb_11];
  const T Hb2_23 = of_2[frame::Hb_23];
  const T Hb2_21 = of_2[frame::Hb_21];
  const T Hb2_22 = of_2[frame::Hb_22];
  const T Hb2_31 = of_2[frame::Hb_31];
  const T Hb2_32 = of_2[frame::Hb_32];
  const T C2_32 = of_2[frame::C_32];
  const T minus_gb2_3 = of_2[frame::minus_gb_3];
  const T C2_12 = of_2[frame::C_12];
  const T gb2_1 = of_2[frame::gb_1];
  const T minus_C2_22 = of_2[frame::minus_C_22];
  const T gb2_2 = of_2[frame::gb_2];
  const T N1_1 = of_2[frame::N1_1];
  const T C2_13 = of_2[frame::C_13];
  const T C2_23 = of_2[frame::C_23];
  const T minus_C2_33 = of_2[frame::minus_C_33];
  const T minus_C2_11 = of_2[frame::minus_C_11];
  const T C2_21 = of_2[frame::C_21];
  const T C2_31 = of_2[frame::C_31];
  const T N1_2 = of_2[frame::N1_2];
  const T N1_3 = of_2[frame::N1_3];
  // JA1 = J_all_1 - Hb2 q2~: moment for an angular acceleration, body axes [kg m^2]
  const T JA1_11 = T(0.18075000000000002) + Hb2_13 * T(0.1) - Hb2_12 * T(0.1);
  const T minus_b1_1 = Hb2_11 * T(0.1);
  const T minus_JA1_12 = T(0.052500000000000005) - minus_b1_1 + Hb2_13 * T(0.3);
  const T JA1_13 = Hb2_12 * T(0.3) - (T(0.0382) + minus_b1_1);
  const T b1_2 = Hb2_21 * T(0.1);
  const T JA1_22 = b1_2 + T(0.26575) - Hb2_23 * T(0.3);
  const T JA1_23 = Hb2_22 * T(0.3) - (T(0.027400000000000004) + b1_2);
  const T JA1_33 = T(0.263) + Hb2_32 * T(0.3) - Hb2_31 * T(0.1);
  // n1 = q2~ C2^T gb2 + N1: moment that drives it, body axes [N m]
  const T b1_3 = C2_32 * minus_gb2_3 - (C2_12 * gb2_1 - minus_C2_22 * gb2_2);
  const T b1_4 = C2_13 * gb2_1 + C2_23 * gb2_2 + minus_C2_33 * minus_gb2_3;
  const T n1_1 = N1_1 + T(0.1) * b1_3 + T(0.1) * b1_4;
  const T minus_b1_5 = T(0.1) * (minus_C2_11 * gb2_1 - C2_21 * gb2_2 + C2_31 * minus_gb2_3);
  const T n1_2 = N1_2 - minus_b1_5 - T(0.3) * b1_4;
  const T n1_3 = minus_b1_5 + N1_3 - T(0.3) * b1_3;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T minus_LD1_21 = LD1_11 * minus_JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - minus_LD1_21 * minus_JA1_12);
  const T LD1_31 = LD1_11 * JA1_13;
  const T b1_6 = JA1_23 + minus_LD1_21 * JA1_13;
  const T LD1_32 = LD1_22 * b1_6;
  const T minus_LD1_33 = T(1) / (LD1_32 * b1_6 - (JA1_33 - LD1_31 * JA1_13));
  // w_1 = D(LD1)^-1 L(LD1)^-1 n1: D^-1 L^-1 n
  const T w_1_1 = LD1_11 * n1_1;
  const T b1_7 = n1_2 + minus_LD1_21 * n1_1;
  const T w_1_2 = LD1_22 * b1_7;
  const T w_1_3 = minus_LD1_33 * (LD1_32 * b1_7 - (n1_3 - LD1_31 * n1_1));
  ydot[2] = w_1_3;
  own[frame::w__1] = w_1_1;
  own[frame::w__2] = w_1_2;
  own[frame::LD_21] = -minus_LD1_21;
  own[frame::LD_31] = LD1_31;
  own[frame::LD_32] = LD1_32;
  own[frame::minus_w__3] = -w_1_3;
}

// body 1, solved
template <class T>
[[gnu::noinline]] void solved_1(T* ydot, T* frames) noexcept {
  T* const own = frames + 0;
  const T LD1_32 = own[frame::LD_32];
  const T minus_w_1_3 = own[frame::minus_w__3];
  const T w_1_2 = own[frame::w__2];
  const T LD1_21 = own[frame::LD_21];
  const T w_1_1 = own[frame::w__1];
  const T LD1_31 = own[frame::LD_31];
  // omegadot1 = L(LD1)^-T w_1
  const T z1_1 = w_1_2 + LD1_32 * minus_w_1_3;
  const T omegadot1_1 = w_1_1 - LD1_21 * z1_1 + LD1_31 * minus_w_1_3;
  ydot[0] = omegadot1_1;
  ydot[1] = z1_1;
  own[frame::omegadot_2] = z1_1;
  own[frame::omegadot_1] = omegadot1_1;
}

// body 2, solved
template <class T>
[[gnu::noinline]] void solved_2(T* ydot, T* frames) noexcept {
  const T* const of_1 = frames + 0;
  T* const own = frames + 63;
  const T omegadot1_2 = of_1[frame::omegadot_2];
  const T omegadot1_1 = of_1[frame::omegadot_1];
  const T C2_13 = own[frame::C_13];
  const T minus_w_1_3 = of_1[frame::minus_w__3];
  const T minus_C2_11 = own[frame::minus_C_11];
  const T C2_12 = own[frame::C_12];
  const T C2_23 = own[frame::C_23];
  const T C2_21 = own[frame::C_21];
  const T minus_C2_22 = own[frame::minus_C_22];
  const T minus_C2_33 = own[frame::minus_C_33];
  const T C2_31 = own[frame::C_31];
  const T C2_32 = own[frame::C_32];
  const T W2_32 = own[frame::W_32];
  const T W2_31 = own[frame::W_31];
  const T minus_w_2_3 = own[frame::minus_w__3];
  const T minus_W2_33 = own[frame::minus_W_33];
  const T LD2_31 = own[frame::LD_31];
  const T W2_23 = own[frame::W_23];
  const T W2_22 = own[frame::W_22];
  const T W2_21 = own[frame::W_21];
  const T w_2_2 = own[frame::w__2];
  const T LD2_32 = own[frame::LD_32];
  const T LD2_21 = own[frame::LD_21];
  const T W2_13 = own[frame::W_13];
  const T W2_12 = own[frame::W_12];
  const T W2_11 = own[frame::W_11];
  const T w_2_1 = own[frame::w__1];
  // beta2 = -C2 q2~ omegadot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T minus_z2_1 = T(0.1) * minus_w_1_3 + T(0.1) * omegadot1_2;
  const T z2_2 = T(0.1) * omegadot1_1;
  const T z2_3 = z2_2 + T(0.3) * minus_w_1_3;
  const T z2_4 = z2_2 - T(0.3) * omegadot1_2;
  const T beta2_1 = C2_13 * z2_4 - (minus_C2_11 * minus_z2_1 + C2_12 * z2_3);
  const T beta2_2 = C2_21 * minus_z2_1 + minus_C2_22 * z2_3 + C2_23 * z2_4;
  const T minus_beta2_3 = C2_32 * z2_3 - C2_31 * minus_z2_1 + minus_C2_33 * z2_4;
  // omegadot2 = L(LD2)^-T (-W2 beta2 + w_2)
  const T z2_5 = minus_w_2_3 + W2_31 * beta2_1 + W2_32 * beta2_2 + minus_W2_33 * minus_beta2_3;
  const T z2_6 = W2_23 * minus_beta2_3 - (W2_22 * beta2_2 - (w_2_2 - W2_21 * beta2_1)) + LD2_32 * z2_5;
  const T omegadot2_1 = LD2_31 * z2_5 - (LD2_21 * z2_6 - (W2_13 * minus_beta2_3 - (W2_12 * beta2_2 - (w_2_1 - W2_11 *
      beta2_1))));
  ydot[3] = omegadot2_1;
  ydot[4] = z2_6;
  ydot[5] = -z2_5;
  own[frame::omegadot_2] = z2_6;
  own[frame::omegadot_1] = omegadot2_1;
  own[frame::beta_1] = beta2_1;
  own[frame::beta_2] = beta2_2;
  own[frame::minus_beta_3] = minus_beta2_3;
  own[frame::minus_omegadot_3] = z2_5;
}

// bodies 3, 7, 9, 11, 13, 15, 17, 19, 21, 23, 25, 27, 29, 31, solved
template <class T>
[[gnu::noinline]] void solved_3(T* ydot, T* frames, int row) noexcept {
  const auto& [K, L, ydot_at] = solved_3_places[row];
  const auto& k = solved_3_numbers<Number<T>>[row];
  T* const own = frames + K;
  const T* const of_L = frames + L;
  const T CK_12 = own[frame::C_12];
  const T betaL_2 = of_L[frame::beta_2];
  const T minus_CK_11 = own[frame::minus_C_11];
  const T betaL_1 = of_L[frame::beta_1];
  const T omegadotL_2 = of_L[frame::omegadot_2];
  const T omegadotL_1 = of_L[frame::omegadot_1];
  const T CK_13 = own[frame::C_13];
  const T minus_omegadotL_3 = of_L[frame::minus_omegadot_3];
  const T minus_betaL_3 = of_L[frame::minus_beta_3];
  const T CK_23 = own[frame::C_23];
  const T minus_CK_22 = own[frame::minus_C_22];
  const T CK_21 = own[frame::C_21];
  const T CK_32 = own[frame::C_32];
  const T CK_31 = own[frame::C_31];
  const T minus_CK_33 = own[frame::minus_C_33];
  const T minus_WK_33 = own[frame::minus_W_33];
  const T WK_32 = own[frame::W_32];
  const T WK_31 = own[frame::W_31];
  const T minus_w_K_3 = own[frame::minus_w__3];
  const T LDK_32 = own[frame::LD_32];
  const T WK_23 = own[frame::W_23];
  const T WK_21 = own[frame::W_21];
  const T w_K_2 = own[frame::w__2];
  const T WK_22 = own[frame::W_22];
  const T LDK_21 = own[frame::LD_21];
  const T WK_13 = own[frame::W_13];
  const T WK_11 = own[frame::W_11];
  const T w_K_1 = own[frame::w__1];
  const T WK_12 = own[frame::W_12];
  const T LDK_31 = own[frame::LD_31];
  // betaK = -CK qK~ omegadotL + CK betaL: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T zK_1 = T(0.3) * omegadotL_2 + T(k[0]) * omegadotL_1;
  const T zK_2 = T(k[0]) * minus_omegadotL_3 - T(0.1) * omegadotL_2;
  const T zK_3 = T(0.1) * omegadotL_1 + T(0.3) * minus_omegadotL_3;
  const T betaK_1 = CK_12 * betaL_2 - (CK_13 * zK_1 - (minus_CK_11 * zK_2 - CK_12 * zK_3) + minus_CK_11 * betaL_1) -
      CK_13 * minus_betaL_3;
  const T minus_betaK_2 = minus_CK_22 * betaL_2 - (CK_21 * betaL_1 - (CK_21 * zK_2 - minus_CK_22 * zK_3 + CK_23 *
      zK_1)) + CK_23 * minus_betaL_3;
  const T betaK_3 = minus_CK_33 * zK_1 - (CK_31 * zK_2 + CK_32 * zK_3) + CK_31 * betaL_1 + CK_32 * betaL_2 +
      minus_CK_33 * minus_betaL_3;
  // omegadotK = L(LDK)^-T (-WK betaK + w_K)
  const T zK_4 = WK_32 * minus_betaK_2 - (minus_w_K_3 + WK_31 * betaK_1) + minus_WK_33 * betaK_3;
  const T zK_5 = WK_23 * betaK_3 - (w_K_2 - WK_21 * betaK_1 + WK_22 * minus_betaK_2) + LDK_32 * zK_4;
  const T omegadotK_1 = LDK_21 * zK_5 - (WK_13 * betaK_3 - (w_K_1 - WK_11 * betaK_1 + WK_12 * minus_betaK_2)) - LDK_31
      * zK_4;
  ydot[ydot_at] = omegadotK_1;
  ydot[ydot_at + 1] = -zK_5;
  ydot[ydot_at + 2] = zK_4;
  own[frame::omegadot_1] = omegadotK_1;
  own[frame::beta_1] = betaK_1;
  own[frame::minus_beta_2] = minus_betaK_2;
  own[frame::beta_3] = betaK_3;
  own[frame::omegadot_3] = zK_4;
  own[frame::minus_omegadot_2] = zK_5;
}

// bodies 4, 8, 10, 12, 14, 16, 18, 22, 24, 26, 28, 30, solved
template <class T>
[[gnu::noinline]] void solved_4(T* ydot, T* frames, int row) noexcept {
  const auto& [K, L, ydot_at] = solved_4_places[row];
  const auto& k = solved_4_numbers<Number<T>>[row];
  T* const own = frames + K;
  const T* const of_L = frames + L;
  const T CK_13 = own[frame::C_13];
  const T betaL_3 = of_L[frame::beta_3];
  const T minus_CK_11 = own[frame::minus_C_11];
  const T betaL_1 = of_L[frame::beta_1];
  const T minus_omegadotL_2 = of_L[frame::minus_omegadot_2];
  const T omegadotL_1 = of_L[frame::omegadot_1];
  const T omegadotL_3 = of_L[frame::omegadot_3];
  const T CK_12 = own[frame::C_12];
  const T minus_betaL_2 = of_L[frame::minus_beta_2];
  const T minus_CK_22 = own[frame::minus_C_22];
  const T CK_21 = own[frame::C_21];
  const T CK_23 = own[frame::C_23];
  const T minus_CK_33 = own[frame::minus_C_33];
  const T CK_32 = own[frame::C_32];
  const T CK_31 = own[frame::C_31];
  const T minus_WK_33 = own[frame::minus_W_33];
  const T WK_32 = own[frame::W_32];
  const T WK_31 = own[frame::W_31];
  const T minus_w_K_3 = own[frame::minus_w__3];
  const T LDK_31 = own[frame::LD_31];
  const T WK_23 = own[frame::W_23];
  const T WK_22 = own[frame::W_22];
  const T WK_21 = own[frame::W_21];
  const T w_K_2 = own[frame::w__2];
  const T LDK_32 = own[frame::LD_32];
  const T LDK_21 = own[frame::LD_21];
  const T WK_13 = own[frame::W_13];
  const T WK_12 = own[frame::W_12];
  const T WK_11 = own[frame::W_11];
  const T w_K_1 = own[frame::w__1];
  // betaK = -CK qK~ omegadotL + CK betaL: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T zK_1 = T(k[0]) * omegadotL_1 - T(0.3) * minus_omegadotL_2;
  const T zK_2 = T(k[1]) * omegadotL_3 + T(0.1) * minus_omegadotL_2;
  const T zK_3 = T(0.1) * omegadotL_1 - T(0.3) * omegadotL_3;
  const T betaK_1 = CK_13 * betaL_3 - (CK_13 * zK_1 - (minus_CK_11 * zK_2 - CK_12 * zK_3) + minus_CK_11 * betaL_1 +
      CK_12 * minus_betaL_2);
  const T betaK_2 = CK_21 * betaL_1 - (CK_21 * zK_2 - minus_CK_22 * zK_3 + CK_23 * zK_1) + minus_CK_22 * minus_betaL_2
      + CK_23 * betaL_3;
  const T minus_betaK_3 = CK_32 * minus_betaL_2 - (minus_CK_33 * zK_1 - (CK_31 * zK_2 + CK_32 * zK_3) + CK_31 *
      betaL_1) + minus_CK_33 * betaL_3;
  // omegadotK = L(LDK)^-T (-WK betaK + w_K)
  const T zK_4 = minus_w_K_3 + WK_31 * betaK_1 + WK_32 * betaK_2 + minus_WK_33 * minus_betaK_3;
  const T zK_5 = WK_23 * minus_betaK_3 - (WK_22 * betaK_2 - (w_K_2 - WK_21 * betaK_1)) + LDK_32 * zK_4;
  const T omegadotK_1 = LDK_31 * zK_4 - (LDK_21 * zK_5 - (WK_13 * minus_betaK_3 - (WK_12 * betaK_2 - (w_K_1 - WK_11 *
      betaK_1))));
  ydot[ydot_at] = omegadotK_1;
  ydot[ydot_at + 1] = zK_5;
  ydot[ydot_at + 2] = -zK_4;
  own[frame::omegadot_2] = zK_5;
  own[frame::omegadot_1] = omegadotK_1;
  own[frame::beta_1] = betaK_1;
  own[frame::beta_2] = betaK_2;
  own[frame::minus_beta_3] = minus_betaK_3;
  own[frame::minus_omegadot_3] = zK_4;
}

// body 5, solved
template <class T>
[[gnu::noinline]] void solved_5(T* ydot, T* frames) noexcept {
  T* const own = frames + 261;
  const T* const of_4 = frames + 195;
  const T C5_12 = own[frame::C_12];
  const T beta4_2 = of_4[frame::beta_2];
  const T minus_C5_11 = own[frame::minus_C_11];
  const T beta4_1 = of_4[frame::beta_1];
  const T omegadot4_2 = of_4[frame::omegadot_2];
  const T omegadot4_1 = of_4[frame::omegadot_1];
  const T C5_13 = own[frame::C_13];
  const T minus_omegadot4_3 = of_4[frame::minus_omegadot_3];
  const T minus_beta4_3 = of_4[frame::minus_beta_3];
  const T C5_23 = own[frame::C_23];
  const T minus_C5_22 = own[frame::minus_C_22];
  const T C5_21 = own[frame::C_21];
  const T C5_32 = own[frame::C_32];
  const T C5_31 = own[frame::C_31];
  const T minus_C5_33 = own[frame::minus_C_33];
  const T W5_32 = own[frame::W_32];
  const T W5_31 = own[frame::W_31];
  const T minus_w_5_3 = own[frame::minus_w__3];
  const T W5_33 = own[frame::W_33];
  const T LD5_32 = own[frame::LD_32];
  const T W5_23 = own[frame::W_23];
  const T minus_W5_22 = own[frame::minus_W_22];
  const T W5_21 = own[frame::W_21];
  const T w_5_2 = own[frame::w__2];
  const T LD5_21 = own[frame::LD_21];
  const T W5_13 = own[frame::W_13];
  const T W5_11 = own[frame::W_11];
  const T w_5_1 = own[frame::w__1];
  const T W5_12 = own[frame::W_12];
  const T LD5_31 = own[frame::LD_31];
  // beta5 = -C5 q5~ omegadot4 + C5 beta4: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z5_1 = T(0.3) * omegadot4_2 - T(0.25) * omegadot4_1;
  const T minus_z5_2 = T(0.25) * minus_omegadot4_3 + T(0.1) * omegadot4_2;
  const T z5_3 = T(0.1) * omegadot4_1 + T(0.3) * minus_omegadot4_3;
  const T beta5_1 = C5_12 * beta4_2 - (minus_C5_11 * minus_z5_2 + C5_12 * z5_3 + C5_13 * z5_1 + minus_C5_11 * beta4_1)
      - C5_13 * minus_beta4_3;
  const T minus_beta5_2 = minus_C5_22 * beta4_2 - (C5_21 * beta4_1 - (C5_23 * z5_1 - (C5_21 * minus_z5_2 + minus_C5_22
      * z5_3))) + C5_23 * minus_beta4_3;
  const T beta5_3 = minus_C5_33 * z5_1 - (C5_32 * z5_3 - C5_31 * minus_z5_2) + C5_31 * beta4_1 + C5_32 * beta4_2 +
      minus_C5_33 * minus_beta4_3;
  // omegadot5 = L(LD5)^-T (-W5 beta5 + w_5)
  const T z5_4 = W5_32 * minus_beta5_2 - (minus_w_5_3 + W5_31 * beta5_1) - W5_33 * beta5_3;
  const T z5_5 = minus_W5_22 * minus_beta5_2 - (w_5_2 - W5_21 * beta5_1) + W5_23 * beta5_3 + LD5_32 * z5_4;
  const T omegadot5_1 = LD5_21 * z5_5 - (W5_13 * beta5_3 - (w_5_1 - W5_11 * beta5_1 + W5_12 * minus_beta5_2)) - LD5_31
      * z5_4;
  ydot[12] = omegadot5_1;
  ydot[13] = -z5_5;
  ydot[14] = z5_4;
  own[frame::omegadot_1] = omegadot5_1;
  own[frame::beta_1] = beta5_1;
  own[frame::minus_beta_2] = minus_beta5_2;
  own[frame::beta_3] = beta5_3;
  own[frame::omegadot_3] = z5_4;
  own[frame::minus_omegadot_2] = z5_5;
}

// body 6, solved
template <class T>
[[gnu::noinline]] void solved_6(T* ydot, T* frames) noexcept {
  T* const own = frames + 327;
  const T* const of_5 = frames + 261;
  const T C6_13 = own[frame::C_13];
  const T beta5_3 = of_5[frame::beta_3];
  const T C6_12 = own[frame::C_12];
  const T minus_beta5_2 = of_5[frame::minus_beta_2];
  const T minus_C6_11 = own[frame::minus_C_11];
  const T beta5_1 = of_5[frame::beta_1];
  const T minus_omegadot5_2 = of_5[frame::minus_omegadot_2];
  const T omegadot5_1 = of_5[frame::omegadot_1];
  const T omegadot5_3 = of_5[frame::omegadot_3];
  const T C6_21 = own[frame::C_21];
  const T C6_23 = own[frame::C_23];
  const T minus_C6_22 = own[frame::minus_C_22];
  const T C6_32 = own[frame::C_32];
  const T C6_31 = own[frame::C_31];
  const T minus_C6_33 = own[frame::minus_C_33];
  const T minus_W6_33 = own[frame::minus_W_33];
  const T W6_31 = own[frame::W_31];
  const T minus_w_6_3 = own[frame::minus_w__3];
  const T W6_32 = own[frame::W_32];
  const T LD6_31 = own[frame::LD_31];
  const T W6_23 = own[frame::W_23];
  const T W6_22 = own[frame::W_22];
  const T W6_21 = own[frame::W_21];
  const T w_6_2 = own[frame::w__2];
  const T LD6_32 = own[frame::LD_32];
  const T LD6_21 = own[frame::LD_21];
  const T W6_13 = own[frame::W_13];
  const T W6_12 = own[frame::W_12];
  const T W6_11 = own[frame::W_11];
  const T w_6_1 = own[frame::w__1];
  // beta6 = -C6 q6~ omegadot5 + C6 beta5: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T minus_z6_1 = T(0.3) * minus_omegadot5_2 + T(0.3) * omegadot5_1;
  const T z6_2 = T(0.3) * omegadot5_3;
  const T z6_3 = z6_2 + T(0.1) * minus_omegadot5_2;
  const T z6_4 = z6_2 - T(0.1) * omegadot5_1;
  const T beta6_1 = C6_13 * beta5_3 - (minus_C6_11 * beta5_1 - (minus_C6_11 * z6_3 + C6_12 * z6_4 + C6_13 *
      minus_z6_1) + C6_12 * minus_beta5_2);
  const T beta6_2 = C6_21 * beta5_1 - (C6_21 * z6_3 + minus_C6_22 * z6_4 - C6_23 * minus_z6_1) + minus_C6_22 *
      minus_beta5_2 + C6_23 * beta5_3;
  const T minus_beta6_3 = C6_32 * minus_beta5_2 - (C6_31 * beta5_1 - (C6_31 * z6_3 - C6_32 * z6_4 + minus_C6_33 *
      minus_z6_1)) + minus_C6_33 * beta5_3;
  // omegadot6 = L(LD6)^-T (-W6 beta6 + w_6)
  const T z6_5 = minus_w_6_3 + W6_31 * beta6_1 + W6_32 * beta6_2 + minus_W6_33 * minus_beta6_3;
  const T z6_6 = W6_23 * minus_beta6_3 - (W6_22 * beta6_2 - (w_6_2 - W6_21 * beta6_1)) + LD6_32 * z6_5;
  const T omegadot6_1 = LD6_31 * z6_5 - (LD6_21 * z6_6 - (W6_13 * minus_beta6_3 - (W6_12 * beta6_2 - (w_6_1 - W6_11 *
      beta6_1))));
  ydot[15] = omegadot6_1;
  ydot[16] = z6_6;
  ydot[17] = -z6_5;
  own[frame::omegadot_2] = z6_6;
  own[frame::omegadot_1] = omegadot6_1;
  own[frame::beta_1] = beta6_1;
  own[frame::beta_2] = beta6_2;
  own[frame::minus_beta_3] = minus_beta6_3;
  own[frame::minus_omegadot_3] = z6_5;
}

// body 20, solved
template <class T>
[[gnu::noinline]] void solved_7(T* ydot, T* frames) noexcept {
  T* const own = frames + 1251;
  const T* const of_19 = frames + 1185;
  const T C20_13 = own[frame::C_13];
  const T beta19_3 = of_19[frame::beta_3];
  const T minus_C20_11 = own[frame::minus_C_11];
  const T beta19_1 = of_19[frame::beta_1];
  const T minus_omegadot19_2 = of_19[frame::minus_omegadot_2];
  const T omegadot19_3 = of_19[frame::omegadot_3];
  const T omegadot19_1 = of_19[frame::omegadot_1];
  const T C20_12 = own[frame::C_12];
  const T minus_beta19_2 = of_19[frame::minus_beta_2];
  const T C20_21 = own[frame::C_21];
  const T C20_23 = own[frame::C_23];
  const T minus_C20_22 = own[frame::minus_C_22];
  const T minus_C20_33 = own[frame::minus_C_33];
  const T C20_32 = own[frame::C_32];
  const T C20_31 = own[frame::C_31];
  const T minus_W20_33 = own[frame::minus_W_33];
  const T W20_31 = own[frame::W_31];
  const T minus_w_20_3 = own[frame::minus_w__3];
  const T W20_32 = own[frame::W_32];
  const T LD20_31 = own[frame::LD_31];
  const T W20_23 = own[frame::W_23];
  const T W20_22 = own[frame::W_22];
  const T W20_21 = own[frame::W_21];
  const T w_20_2 = own[frame::w__2];
  const T LD20_32 = own[frame::LD_32];
  const T LD20_21 = own[frame::LD_21];
  const T W20_13 = own[frame::W_13];
  const T W20_12 = own[frame::W_12];
  const T W20_11 = own[frame::W_11];
  const T w_20_1 = own[frame::w__1];
  // beta20 = -C20 q20~ omegadot19 + C20 beta19: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z20_1 = omegadot19_3 + T(0.1) * minus_omegadot19_2;
  const T z20_2 = T(0.1) * omegadot19_1 - T(0.3) * omegadot19_3;
  const T z20_3 = T(0.3) * minus_omegadot19_2 + omegadot19_1;
  const T beta20_1 = C20_13 * beta19_3 - (minus_C20_11 * beta19_1 - (minus_C20_11 * z20_1 - C20_12 * z20_2 + C20_13 *
      z20_3) + C20_12 * minus_beta19_2);
  const T beta20_2 = C20_23 * z20_3 - (C20_21 * z20_1 - minus_C20_22 * z20_2) + C20_21 * beta19_1 + minus_C20_22 *
      minus_beta19_2 + C20_23 * beta19_3;
  const T minus_beta20_3 = C20_32 * minus_beta19_2 - (C20_31 * beta19_1 - (C20_31 * z20_1 + C20_32 * z20_2 +
      minus_C20_33 * z20_3)) + minus_C20_33 * beta19_3;
  // omegadot20 = L(LD20)^-T (-W20 beta20 + w_20)
  const T z20_4 = minus_w_20_3 + W20_31 * beta20_1 + W20_32 * beta20_2 + minus_W20_33 * minus_beta20_3;
  const T z20_5 = W20_23 * minus_beta20_3 - (W20_22 * beta20_2 - (w_20_2 - W20_21 * beta20_1)) + LD20_32 * z20_4;
  const T omegadot20_1 = LD20_31 * z20_4 - (LD20_21 * z20_5 - (W20_13 * minus_beta20_3 - (W20_12 * beta20_2 - (w_20_1
      - W20_11 * beta20_1))));
  ydot[57] = omegadot20_1;
  ydot[58] = z20_5;
  ydot[59] = -z20_4;
  own[frame::omegadot_2] = z20_5;
  own[frame::omegadot_1] = omegadot20_1;
  own[frame::beta_1] = beta20_1;
  own[frame::beta_2] = beta20_2;
  own[frame::minus_beta_3] = minus_beta20_3;
  own[frame::minus_omegadot_3] = z20_4;
}

// body 32, solved
template <class T>
[[gnu::noinline]] void solved_8(T* ydot, T* frames) noexcept {
  T* const own = frames + 2043;
  const T* const of_31 = frames + 1977;
  const T C32_13 = own[frame::C_13];
  const T beta31_3 = of_31[frame::beta_3];
  const T minus_C32_11 = own[frame::minus_C_11];
  const T beta31_1 = of_31[frame::beta_1];
  const T minus_omegadot31_2 = of_31[frame::minus_omegadot_2];
  const T omegadot31_1 = of_31[frame::omegadot_1];
  const T omegadot31_3 = of_31[frame::omegadot_3];
  const T C32_12 = own[frame::C_12];
  const T minus_beta31_2 = of_31[frame::minus_beta_2];
  const T minus_C32_22 = own[frame::minus_C_22];
  const T C32_21 = own[frame::C_21];
  const T C32_23 = own[frame::C_23];
  const T minus_C32_33 = own[frame::minus_C_33];
  const T C32_32 = own[frame::C_32];
  const T C32_31 = own[frame::C_31];
  const T w_32_3 = own[frame::w__3];
  const T w_32_2 = own[frame::w__2];
  const T w_32_1 = own[frame::w__1];
  // beta32 = -C32 q32~ omegadot31 + C32 beta31: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T minus_z32_1 = T(0.3) * minus_omegadot31_2 + T(1.6) * omegadot31_1;
  const T z32_2 = T(1.6) * omegadot31_3 + T(0.1) * minus_omegadot31_2;
  const T z32_3 = T(0.1) * omegadot31_1 - T(0.3) * omegadot31_3;
  const T beta32_1 = C32_13 * beta31_3 - (minus_C32_11 * beta31_1 - (minus_C32_11 * z32_2 - C32_12 * z32_3 + C32_13 *
      minus_z32_1) + C32_12 * minus_beta31_2);
  const T beta32_2 = C32_21 * beta31_1 - (C32_21 * z32_2 - minus_C32_22 * z32_3 - C32_23 * minus_z32_1) + minus_C32_22
      * minus_beta31_2 + C32_23 * beta31_3;
  const T minus_beta32_3 = C32_32 * minus_beta31_2 - (C32_31 * beta31_1 - (C32_31 * z32_2 + C32_32 * z32_3 +
      minus_C32_33 * minus_z32_1)) + minus_C32_33 * beta31_3;
  // omegadot32 = L(LD32)^-T (-W32 beta32 + w_32)
  const T z32_4 = w_32_3 - T(0.768725121425702) * beta32_2 + T(1.5150171378488217) * beta32_1 -
      T(0.044866210005164824) * minus_beta32_3;
  const T z32_5 = w_32_2 - T(0.3819095477386935) * beta32_1 + T(0.040201005025125636) * beta32_2 -
      T(0.6030150753768845) * minus_beta32_3 + T(0.1085427135678392) * z32_4;
  const T omegadot32_1 = w_32_1 + T(1.4035087719298247) * minus_beta32_3 + T(0.3508771929824562) * beta32_2 +
      T(0.10526315789473686) * z32_5 + T(0.014035087719298251) * z32_4;
  ydot[93] = omegadot32_1;
  ydot[94] = z32_5;
  ydot[95] = z32_4;
}

}  // namespace accelerations_sections

template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot)
    noexcept {
  using namespace accelerations_sections;
  [[maybe_unused]] T frames[2100];
  const T inputs[] = {u.tau_3_2, u.tau_9_2, u.tau_12_2, u.tau_15_2, u.tau_18_2, u.tau_21_2, u.tau_24_2, u.tau_27_2,
      u.tau_30_2, u.tau_3_1, u.tau_9_1, u.tau_12_1, u.tau_15_1, u.tau_18_1, u.tau_21_1, u.tau_24_1, u.tau_27_1,
      u.tau_30_1, u.tau_2_1, u.tau_8_1, u.tau_11_1, u.tau_14_1, u.tau_17_1, u.tau_20_1, u.tau_23_1, u.tau_26_1,
      u.tau_29_1, u.tau_3_3, u.tau_9_3, u.tau_12_3, u.tau_15_3, u.tau_18_3, u.tau_21_3, u.tau_24_3, u.tau_27_3,
      u.tau_30_3, u.tau_2_2, u.tau_8_2, u.tau_11_2, u.tau_14_2, u.tau_17_2, u.tau_20_2, u.tau_23_2, u.tau_26_2,
      u.tau_29_2, u.tau_2_3, u.tau_8_3, u.tau_11_3, u.tau_14_3, u.tau_17_3, u.tau_20_3, u.tau_23_3, u.tau_26_3,
      u.tau_29_3, u.tau_4_2, u.tau_5_2, u.tau_7_2, u.tau_10_2, u.tau_13_2, u.tau_16_2, u.tau_19_2, u.tau_22_2,
      u.tau_25_2, u.tau_28_2, u.tau_31_2, u.tau_4_1, u.tau_5_1, u.tau_7_1, u.tau_10_1, u.tau_13_1, u.tau_16_1,
      u.tau_19_1, u.tau_22_1, u.tau_25_1, u.tau_28_1, u.tau_31_1, u.tau_6_1, u.tau_4_3, u.tau_5_3, u.tau_7_3,
      u.tau_10_3, u.tau_13_3, u.tau_16_3, u.tau_19_3, u.tau_22_3, u.tau_25_3, u.tau_28_3, u.tau_31_3, u.tau_6_2,
      u.tau_6_3};
  // kind of section, and row of its tables
  static constexpr unsigned char steps[][2] = {
      {0,0}, {1,0}, {2,0}, {3,0}, {3,1}, {4,0}, {3,2}, {3,3}, {2,1}, {3,4}, {3,5}, {2,2}, {3,6}, {3,7}, {2,3}, {3,8},
      {3,9}, {2,4}, {3,10}, {5,0}, {2,5}, {3,11}, {3,12}, {2,6}, {3,13}, {3,14}, {2,7}, {3,15}, {3,16}, {2,8}, {3,17},
      {6,0}, {7,0}, {8,0}, {9,0}, {10,0}, {10,1}, {9,1}, {10,2}, {10,3}, {9,2}, {10,4}, {10,5}, {9,3}, {11,0}, {12,0},
      {9,4}, {10,6}, {10,7}, {9,5}, {10,8}, {10,9}, {9,6}, {10,10}, {10,11}, {9,7}, {10,12}, {10,13}, {13,0}, {14,0},
      {8,1}, {9,8}, {15,0}, {16,0}, {17,0}, {18,0}, {19,0}, {20,0}, {21,0}, {22,0}, {19,1}, {20,1}, {19,2}, {20,2},
      {19,3}, {20,3}, {19,4}, {20,4}, {19,5}, {20,5}, {19,6}, {20,6}, {19,7}, {23,0}, {19,8}, {20,7}, {19,9}, {20,8},
      {19,10}, {20,9}, {19,11}, {20,10}, {19,12}, {20,11}, {19,13}, {24,0}};
  for (const auto& step : steps) {
    [[maybe_unused]] const int row = step[1];
    switch (step[0]) {
      case 0: outward_1(x, y, frames); break;
      case 1: outward_2(x, y, u, frames); break;
      case 2: outward_3(x, y, inputs, frames, row); break;
      case 3: outward_4(x, y, inputs, frames, row); break;
      case 4: outward_5(x, y, u, frames); break;
      case 5: outward_6(x, y, u, frames); break;
      case 6: outward_7(x, y, u, frames); break;
      case 7: inward_1(frames); break;
      case 8: inward_2(frames, row); break;
      case 9: inward_3(frames, row); break;
      case 10: inward_4(frames, row); break;
      case 11: inward_5(frames); break;
      case 12: inward_6(frames); break;
      case 13: inward_7(frames); break;
      case 14: inward_8(frames); break;
      case 15: inward_9(frames); break;
      case 16: inward_10(ydot, frames); break;
      case 17: solved_1(ydot, frames); break;
      case 18: solved_2(ydot, frames); break;
      case 19: solved_3(ydot, frames, row); break;
      case 20: solved_4(ydot, frames, row); break;
      case 21: solved_5(ydot, frames); break;
      case 22: solved_6(ydot, frames); break;
      case 23: solved_7(ydot, frames); break;
      case 24: solved_8(ydot, frames); break;
    }
  }
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 3165 add, 3317 multiply
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
  const T N1_1 = C2_11 * u.tau_2_1 - u.tau_1_1 + C2_21 * u.tau_2_2 + C2_31 * u.tau_2_3 + T(8.59) * Pddot1_3 - T(8.425)
      * Pddot1_2 + T(0.9140000000000001) * U1_32 - T(0.9167500000000001) * U1_23 + T(0.8524) * (minus_U1_22 -
      minus_U1_33) + T(2.5275) * U1_31 - T(2.5132) * U1_21;
  const T N1_2 = C2_12 * u.tau_2_1 - u.tau_1_2 + C2_22 * u.tau_2_2 + C2_32 * u.tau_2_3 + T(8.425) * Pddot1_1 -
      T(25.22) * Pddot1_3 + T(0.9167500000000001) * U1_13 - T(7.598999999999999) * U1_31 + T(2.5132) * (minus_U1_33 -
      minus_U1_11) + T(0.8524) * U1_12 - T(2.5275) * U1_32;
  const T N1_3 = C2_13 * u.tau_2_1 - u.tau_1_3 + C2_23 * u.tau_2_2 + C2_33 * u.tau_2_3 + T(25.22) * Pddot1_2 - T(8.59)
      * Pddot1_1 + T(7.598999999999999) * U1_21 - T(0.9140000000000001) * U1_12 + T(2.5275) * (minus_U1_11 -
      minus_U1_22) + T(2.5132) * U1_23 - T(0.8524) * U1_13;
  // G2 = U2 h_all_2: inertia less applied force, body axes [N]
  const T G2_1 = U2_12 * T(12.615) - minus_U2_11 * T(24.869999999999997) + U2_13 * T(8.31);
  const T G2_2 = U2_21 * T(24.869999999999997) - minus_U2_22 * T(12.615) + U2_23 * T(8.31);
  const T G2_3 = U2_31 * T(24.869999999999997) + U2_32 * T(12.615) - minus_U2_33 * T(8.31);

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
  const T N2_1 = C3_11 * u.tau_3_1 - u.tau_2_1 + C3_21 * u.tau_3_2 + C3_31 * u.tau_3_3 + T(12.615) * Pddot2_3 -
      T(8.31) * Pddot2_2 + T(1.9402499999999998) * U2_32 - T(0.912) * U2_23 + T(1.2543) * (minus_U2_22 - minus_U2_33)
      + T(3.7304999999999997) * U2_31 - T(2.4774) * U2_21;
  const T N2_2 = C3_12 * u.tau_3_1 - u.tau_2_2 + C3_22 * u.tau_3_2 + C3_32 * u.tau_3_3 + T(8.31) * Pddot2_1 -
      T(24.869999999999997) * Pddot2_3 + T(0.912) * U2_13 - T(7.496999999999999) * U2_31 + T(2.4774) * (minus_U2_33 -
      minus_U2_11) + T(1.2543) * U2_12 - T(3.7304999999999997) * U2_32;
  const T N2_3 = C3_13 * u.tau_3_1 - u.tau_2_3 + C3_23 * u.tau_3_2 + C3_33 * u.tau_3_3 + T(24.869999999999997) *
      Pddot2_2 - T(12.615) * Pddot2_1 + T(7.496999999999999) * U2_21 - T(1.9402499999999998) * U2_12 +
      T(3.7304999999999997) * (minus_U2_11 - minus_U2_22) + T(2.4774) * U2_23 - T(1.2543) * U2_13;
  // G3 = U3 h_all_3: inertia less applied force, body axes [N]
  const T G3_1 = U3_12 * T(16.5) - minus_U3_11 * T(24.49) + U3_13 * T(8.185);
  const T G3_2 = U3_21 * T(24.49) - minus_U3_22 * T(16.5) + U3_23 * T(8.185);
  const T G3_3 = U3_31 * T(24.49) + U3_32 * T(16.5) - minus_U3_33 * T(8.185);

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
  const T N3_1 = C4_11 * u.tau_4_1 - u.tau_3_1 + C4_21 * u.tau_4_2 + C4_31 * u.tau_4_3 + T(16.5) * Pddot3_3 - T(8.185)
      * Pddot3_2 + T(3.3390000000000004) * U3_32 - T(0.9062500000000001) * U3_23 + T(1.6422) * (minus_U3_22 -
      minus_U3_33) + T(4.8915) * U3_31 - T(2.4386) * U3_21;
  const T N3_2 = C4_12 * u.tau_4_1 - u.tau_3_2 + C4_22 * u.tau_4_2 + C4_32 * u.tau_4_3 + T(8.185) * Pddot3_1 -
      T(24.49) * Pddot3_3 + T(0.9062500000000001) * U3_13 - T(7.385999999999999) * U3_31 + T(2.4386) * (minus_U3_33 -
      minus_U3_11) + T(1.6422) * U3_12 - T(4.8915) * U3_32;
  const T N3_3 = C4_13 * u.tau_4_1 - u.tau_3_3 + C4_23 * u.tau_4_2 + C4_33 * u.tau_4_3 + T(24.49) * Pddot3_2 - T(16.5)
      * Pddot3_1 + T(7.385999999999999) * U3_21 - T(3.3390000000000004) * U3_12 + T(4.8915) * (minus_U3_11 -
      minus_U3_22) + T(2.4386) * U3_23 - T(1.6422) * U3_13;
  // G4 = U4 h_all_4: inertia less applied force, body axes [N]
  const T G4_1 = U4_12 * T(20.23) - minus_U4_11 * T(24.08) + U4_13 * T(8.05);
  const T G4_2 = U4_21 * T(24.08) - minus_U4_22 * T(20.23) + U4_23 * T(8.05);
  const T G4_3 = U4_31 * T(24.08) + U4_32 * T(20.23) - minus_U4_33 * T(8.05);

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
  const T N4_1 = C5_11 * u.tau_5_1 - u.tau_4_1 + C5_21 * u.tau_5_2 + C5_31 * u.tau_5_3 + T(20.23) * Pddot4_3 - T(8.05)
      * Pddot4_2 + T(5.0855) * U4_32 - T(0.8995000000000001) * U4_23 + T(2.0146) * (minus_U4_22 - minus_U4_33) +
      T(6.005999999999999) * U4_31 - T(2.3968) * U4_21;
  const T N4_2 = C5_12 * u.tau_5_1 - u.tau_4_2 + C5_22 * u.tau_5_2 + C5_32 * u.tau_5_3 + T(8.05) * Pddot4_1 - T(24.08)
      * Pddot4_3 + T(0.8995000000000001) * U4_13 - T(7.265999999999999) * U4_31 + T(2.3968) * (minus_U4_33 -
      minus_U4_11) + T(2.0146) * U4_12 - T(6.005999999999999) * U4_32;
  const T N4_3 = C5_13 * u.tau_5_1 - u.tau_4_3 + C5_23 * u.tau_5_2 + C5_33 * u.tau_5_3 + T(24.08) * Pddot4_2 -
      T(20.23) * Pddot4_1 + T(7.265999999999999) * U4_21 - T(5.0855) * U4_12 + T(6.005999999999999) * (minus_U4_11 -
      minus_U4_22) + T(2.3968) * U4_23 - T(2.0146) * U4_13;
  // G5 = U5 h_all_5: inertia less applied force, body axes [N]
  const T G5_1 = U5_12 * T(23.79) - minus_U5_11 * T(23.64) + U5_13 * T(7.905);
  const T G5_2 = U5_21 * T(23.64) - minus_U5_22 * T(23.79) + U5_23 * T(7.905);
  const T G5_3 = U5_31 * T(23.64) + U5_32 * T(23.79) - minus_U5_33 * T(7.905);

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
  const T N5_1 = C6_11 * u.tau_6_1 - u.tau_5_1 + C6_21 * u.tau_6_2 + C6_31 * u.tau_6_3 + T(23.79) * Pddot5_3 -
      T(7.905) * Pddot5_2 + T(7.151999999999999) * U5_32 - T(0.89175) * U5_23 + T(2.37) * (minus_U5_22 - minus_U5_33)
      + T(7.0695) * U5_31 - T(2.352) * U5_21;
  const T N5_2 = C6_12 * u.tau_6_1 - u.tau_5_2 + C6_22 * u.tau_6_2 + C6_32 * u.tau_6_3 + T(7.905) * Pddot5_1 -
      T(23.64) * Pddot5_3 + T(0.89175) * U5_13 - T(7.137) * U5_31 + T(2.352) * (minus_U5_33 - minus_U5_11) + T(2.37) *
      U5_12 - T(7.0695) * U5_32;
  const T N5_3 = C6_13 * u.tau_6_1 - u.tau_5_3 + C6_23 * u.tau_6_2 + C6_33 * u.tau_6_3 + T(23.64) * Pddot5_2 -
      T(23.79) * Pddot5_1 + T(7.137) * U5_21 - T(7.151999999999999) * U5_12 + T(7.0695) * (minus_U5_11 - minus_U5_22)
      + T(2.352) * U5_23 - T(2.37) * U5_13;
  // G6 = U6 h_all_6: inertia less applied force, body axes [N]
  const T G6_1 = U6_12 * T(27.165) - minus_U6_11 * T(23.169999999999998) + U6_13 * T(7.75);
  const T G6_2 = U6_21 * T(23.169999999999998) - minus_U6_22 * T(27.165) + U6_23 * T(7.75);
  const T G6_3 = U6_31 * T(23.169999999999998) + U6_32 * T(27.165) - minus_U6_33 * T(7.75);

  // ---- body 7 (body_7) on body 6
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  const T omegadot7_1 = ydot[18], omegadot7_2 = ydot[19], omegadot7_3 = ydot[20];
  // erel7 = -e6~ e7 + eps4_6 e7 - eps4_7 e6: Euler parameters relative to the lower body
  const T erel7_1 = eps6_3 * eps7_2 - eps6_2 * eps7_3 + eps6_4 * eps7_1 - eps7_4 * eps6_1;
  const T erel7_2 = eps6_1 * eps7_3 - eps6_3 * eps7_1 + eps6_4 * eps7_2 - eps7_4 * eps6_2;
  const T erel7_3 = eps6_2 * eps7_1 - eps6_1 * eps7_2 + eps6_4 * eps7_3 - eps7_4 * eps6_3;
  // eps4rel7 = e6 . e7 + eps4_6 eps4_7
  const T eps4rel7 = eps6_1 * eps7_1 + eps6_2 * eps7_2 + eps6_3 * eps7_3 + eps6_4 * eps7_4;
  // C7^T = 1 + 2 erel7~ (eps4rel7 + erel7~): C takes components in the lower body to those in the body
  const T t7_1 = T(2) * erel7_2;
  const T t7_2 = t7_1 * erel7_2;
  const T t7_3 = T(2) * erel7_3;
  const T t7_4 = t7_3 * erel7_3;
  const T C7_11 = T(1) - t7_2 - t7_4;
  const T t7_5 = T(2) * erel7_1;
  const T t7_6 = t7_5 * erel7_2;
  const T t7_7 = t7_3 * eps4rel7;
  const T C7_12 = t7_6 + t7_7;
  const T t7_8 = t7_5 * erel7_3;
  const T t7_9 = t7_1 * eps4rel7;
  const T C7_13 = t7_8 - t7_9;
  const T C7_21 = t7_6 - t7_7;
  const T t7_10 = T(1) - t7_5 * erel7_1;
  const T C7_22 = t7_10 - t7_4;
  const T t7_11 = t7_1 * erel7_3;
  const T t7_12 = t7_5 * eps4rel7;
  const T C7_23 = t7_11 + t7_12;
  const T C7_31 = t7_8 + t7_9;
  const T C7_32 = t7_11 - t7_12;
  const T C7_33 = t7_10 - t7_2;
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
  // Pddot7 = C7 (U6 q7 + Pddot6): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t7_19 = Pddot6_1 + U6_12 * T(0.35) - minus_U6_11 * T(0.3) + U6_13 * T(0.1);
  const T t7_20 = Pddot6_2 + U6_21 * T(0.3) - minus_U6_22 * T(0.35) + U6_23 * T(0.1);
  const T t7_21 = Pddot6_3 + U6_31 * T(0.3) + U6_32 * T(0.35) - minus_U6_33 * T(0.1);
  const T Pddot7_1 = C7_11 * t7_19 + C7_12 * t7_20 + C7_13 * t7_21;
  const T Pddot7_2 = C7_21 * t7_19 + C7_22 * t7_20 + C7_23 * t7_21;
  const T Pddot7_3 = C7_31 * t7_19 + C7_32 * t7_20 + C7_33 * t7_21;
  // N6 = C7^T M_torque_7_ + h_all_6~ Pddot6 + axial(U6 (tr(J_all_6)/2 - J_all_6)) - M_torque_6_: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N6_1 = C7_11 * u.tau_7_1 - u.tau_6_1 + C7_21 * u.tau_7_2 + C7_31 * u.tau_7_3 + T(27.165) * Pddot6_3 -
      T(7.75) * Pddot6_2 + T(9.507749999999998) * U6_32 - T(0.8830000000000001) * U6_23 + T(2.7069) * (minus_U6_22 -
      minus_U6_33) + T(8.077499999999999) * U6_31 - T(2.3042000000000002) * U6_21;
  const T N6_2 = C7_12 * u.tau_7_1 - u.tau_6_2 + C7_22 * u.tau_7_2 + C7_32 * u.tau_7_3 + T(7.75) * Pddot6_1 -
      T(23.169999999999998) * Pddot6_3 + T(0.8830000000000001) * U6_13 - T(6.999) * U6_31 + T(2.3042000000000002) *
      (minus_U6_33 - minus_U6_11) + T(2.7069) * U6_12 - T(8.077499999999999) * U6_32;
  const T N6_3 = C7_13 * u.tau_7_1 - u.tau_6_3 + C7_23 * u.tau_7_2 + C7_33 * u.tau_7_3 + T(23.169999999999998) *
      Pddot6_2 - T(27.165) * Pddot6_1 + T(6.999) * U6_21 - T(9.507749999999998) * U6_12 + T(8.077499999999999) *
      (minus_U6_11 - minus_U6_22) + T(2.3042000000000002) * U6_23 - T(2.7069) * U6_13;
  // G7 = U7 h_all_7: inertia less applied force, body axes [N]
  const T G7_1 = U7_12 * T(30.34) - minus_U7_11 * T(22.669999999999998) + U7_13 * T(7.585);
  const T G7_2 = U7_21 * T(22.669999999999998) - minus_U7_22 * T(30.34) + U7_23 * T(7.585);
  const T G7_3 = U7_31 * T(22.669999999999998) + U7_32 * T(30.34) - minus_U7_33 * T(7.585);

  // ---- body 8 (body_8) on body 7
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  const T omegadot8_1 = ydot[21], omegadot8_2 = ydot[22], omegadot8_3 = ydot[23];
  // erel8 = -e7~ e8 + eps4_7 e8 - eps4_8 e7: Euler parameters relative to the lower body
  const T erel8_1 = eps7_3 * eps8_2 - eps7_2 * eps8_3 + eps7_4 * eps8_1 - eps8_4 * eps7_1;
  const T erel8_2 = eps7_1 * eps8_3 - eps7_3 * eps8_1 + eps7_4 * eps8_2 - eps8_4 * eps7_2;
  const T erel8_3 = eps7_2 * eps8_1 - eps7_1 * eps8_2 + eps7_4 * eps8_3 - eps8_4 * eps7_3;
  // eps4rel8 = e7 . e8 + eps4_7 eps4_8
  const T eps4rel8 = eps7_1 * eps8_1 + eps7_2 * eps8_2 + eps7_3 * eps8_3 + eps7_4 * eps8_4;
  // C8^T = 1 + 2 erel8~ (eps4rel8 + erel8~): C takes components in the lower body to those in the body
  const T t8_1 = T(2) * erel8_2;
  const T t8_2 = t8_1 * erel8_2;
  const T t8_3 = T(2) * erel8_3;
  const T t8_4 = t8_3 * erel8_3;
  const T C8_11 = T(1) - t8_2 - t8_4;
  const T t8_5 = T(2) * erel8_1;
  const T t8_6 = t8_5 * erel8_2;
  const T t8_7 = t8_3 * eps4rel8;
  const T C8_12 = t8_6 + t8_7;
  const T t8_8 = t8_5 * erel8_3;
  const T t8_9 = t8_1 * eps4rel8;
  const T C8_13 = t8_8 - t8_9;
  const T C8_21 = t8_6 - t8_7;
  const T t8_10 = T(1) - t8_5 * erel8_1;
  const T C8_22 = t8_10 - t8_4;
  const T t8_11 = t8_1 * erel8_3;
  const T t8_12 = t8_5 * eps4rel8;
  const T C8_23 = t8_11 + t8_12;
  const T C8_31 = t8_8 + t8_9;
  const T C8_32 = t8_11 - t8_12;
  const T C8_33 = t8_10 - t8_2;
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
  // Pddot8 = C8 (U7 q8 + Pddot7): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t8_19 = Pddot7_1 + U7_12 * T(0.4) - minus_U7_11 * T(0.3) + U7_13 * T(0.1);
  const T t8_20 = Pddot7_2 + U7_21 * T(0.3) - minus_U7_22 * T(0.4) + U7_23 * T(0.1);
  const T t8_21 = Pddot7_3 + U7_31 * T(0.3) + U7_32 * T(0.4) - minus_U7_33 * T(0.1);
  const T Pddot8_1 = C8_11 * t8_19 + C8_12 * t8_20 + C8_13 * t8_21;
  const T Pddot8_2 = C8_21 * t8_19 + C8_22 * t8_20 + C8_23 * t8_21;
  const T Pddot8_3 = C8_31 * t8_19 + C8_32 * t8_20 + C8_33 * t8_21;
  // N7 = C8^T M_torque_8_ + h_all_7~ Pddot7 + axial(U7 (tr(J_all_7)/2 - J_all_7)) - M_torque_7_: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N7_1 = C8_11 * u.tau_8_1 - u.tau_7_1 + C8_21 * u.tau_8_2 + C8_31 * u.tau_8_3 + T(30.34) * Pddot7_3 -
      T(7.585) * Pddot7_2 + T(12.119000000000002) * U7_32 - T(0.8732500000000001) * U7_23 + T(3.0238000000000005) *
      (minus_U7_22 - minus_U7_33) + T(9.025500000000001) * U7_31 - T(2.2534) * U7_21;
  const T N7_2 = C8_12 * u.tau_8_1 - u.tau_7_2 + C8_22 * u.tau_8_2 + C8_32 * u.tau_8_3 + T(7.585) * Pddot7_1 -
      T(22.669999999999998) * Pddot7_3 + T(0.8732500000000001) * U7_13 - T(6.851999999999999) * U7_31 + T(2.2534) *
      (minus_U7_33 - minus_U7_11) + T(3.0238000000000005) * U7_12 - T(9.025500000000001) * U7_32;
  const T N7_3 = C8_13 * u.tau_8_1 - u.tau_7_3 + C8_23 * u.tau_8_2 + C8_33 * u.tau_8_3 + T(22.669999999999998) *
      Pddot7_2 - T(30.34) * Pddot7_1 + T(6.851999999999999) * U7_21 - T(12.119000000000002) * U7_12 +
      T(9.025500000000001) * (minus_U7_11 - minus_U7_22) + T(2.2534) * U7_23 - T(3.0238000000000005) * U7_13;
  // G8 = U8 h_all_8: inertia less applied force, body axes [N]
  const T G8_1 = U8_12 * T(33.300000000000004) - minus_U8_11 * T(22.14) + U8_13 * T(7.41);
  const T G8_2 = U8_21 * T(22.14) - minus_U8_22 * T(33.300000000000004) + U8_23 * T(7.41);
  const T G8_3 = U8_31 * T(22.14) + U8_32 * T(33.300000000000004) - minus_U8_33 * T(7.41);

  // ---- body 9 (body_9) on body 8
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  const T omegadot9_1 = ydot[24], omegadot9_2 = ydot[25], omegadot9_3 = ydot[26];
  // erel9 = -e8~ e9 + eps4_8 e9 - eps4_9 e8: Euler parameters relative to the lower body
  const T erel9_1 = eps8_3 * eps9_2 - eps8_2 * eps9_3 + eps8_4 * eps9_1 - eps9_4 * eps8_1;
  const T erel9_2 = eps8_1 * eps9_3 - eps8_3 * eps9_1 + eps8_4 * eps9_2 - eps9_4 * eps8_2;
  const T erel9_3 = eps8_2 * eps9_1 - eps8_1 * eps9_2 + eps8_4 * eps9_3 - eps9_4 * eps8_3;
  // eps4rel9 = e8 . e9 + eps4_8 eps4_9
  const T eps4rel9 = eps8_1 * eps9_1 + eps8_2 * eps9_2 + eps8_3 * eps9_3 + eps8_4 * eps9_4;
  // C9^T = 1 + 2 erel9~ (eps4rel9 + erel9~): C takes components in the lower body to those in the body
  const T t9_1 = T(2) * erel9_2;
  const T t9_2 = t9_1 * erel9_2;
  const T t9_3 = T(2) * erel9_3;
  const T t9_4 = t9_3 * erel9_3;
  const T C9_11 = T(1) - t9_2 - t9_4;
  const T t9_5 = T(2) * erel9_1;
  const T t9_6 = t9_5 * erel9_2;
  const T t9_7 = t9_3 * eps4rel9;
  const T C9_12 = t9_6 + t9_7;
  const T t9_8 = t9_5 * erel9_3;
  const T t9_9 = t9_1 * eps4rel9;
  const T C9_13 = t9_8 - t9_9;
  const T C9_21 = t9_6 - t9_7;
  const T t9_10 = T(1) - t9_5 * erel9_1;
  const T C9_22 = t9_10 - t9_4;
  const T t9_11 = t9_1 * erel9_3;
  const T t9_12 = t9_5 * eps4rel9;
  const T C9_23 = t9_11 + t9_12;
  const T C9_31 = t9_8 + t9_9;
  const T C9_32 = t9_11 - t9_12;
  const T C9_33 = t9_10 - t9_2;
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
  // Pddot9 = C9 (U8 q9 + Pddot8): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t9_19 = Pddot8_1 + U8_12 * T(0.45) - minus_U8_11 * T(0.3) + U8_13 * T(0.1);
  const T t9_20 = Pddot8_2 + U8_21 * T(0.3) - minus_U8_22 * T(0.45) + U8_23 * T(0.1);
  const T t9_21 = Pddot8_3 + U8_31 * T(0.3) + U8_32 * T(0.45) - minus_U8_33 * T(0.1);
  const T Pddot9_1 = C9_11 * t9_19 + C9_12 * t9_20 + C9_13 * t9_21;
  const T Pddot9_2 = C9_21 * t9_19 + C9_22 * t9_20 + C9_23 * t9_21;
  const T Pddot9_3 = C9_31 * t9_19 + C9_32 * t9_20 + C9_33 * t9_21;
  // N8 = C9^T M_torque_9_ + h_all_8~ Pddot8 + axial(U8 (tr(J_all_8)/2 - J_all_8)) - M_torque_8_: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N8_1 = C9_11 * u.tau_9_1 - u.tau_8_1 + C9_21 * u.tau_9_2 + C9_31 * u.tau_9_3 + T(33.300000000000004) *
      Pddot8_3 - T(7.41) * Pddot8_2 + T(14.949) * U8_32 - T(0.8625) * U8_23 + T(3.3192000000000004) * (minus_U8_22 -
      minus_U8_33) + T(9.909) * U8_31 - T(2.1996) * U8_21;
  const T N8_2 = C9_12 * u.tau_9_1 - u.tau_8_2 + C9_22 * u.tau_9_2 + C9_32 * u.tau_9_3 + T(7.41) * Pddot8_1 - T(22.14)
      * Pddot8_3 + T(0.8625) * U8_13 - T(6.696) * U8_31 + T(2.1996) * (minus_U8_33 - minus_U8_11) +
      T(3.3192000000000004) * U8_12 - T(9.909) * U8_32;
  const T N8_3 = C9_13 * u.tau_9_1 - u.tau_8_3 + C9_23 * u.tau_9_2 + C9_33 * u.tau_9_3 + T(22.14) * Pddot8_2 -
      T(33.300000000000004) * Pddot8_1 + T(6.696) * U8_21 - T(14.949) * U8_12 + T(9.909) * (minus_U8_11 - minus_U8_22)
      + T(2.1996) * U8_23 - T(3.3192000000000004) * U8_13;
  // G9 = U9 h_all_9: inertia less applied force, body axes [N]
  const T G9_1 = U9_12 * T(36.03) - minus_U9_11 * T(21.58) + U9_13 * T(7.2250000000000005);
  const T G9_2 = U9_21 * T(21.58) - minus_U9_22 * T(36.03) + U9_23 * T(7.2250000000000005);
  const T G9_3 = U9_31 * T(21.58) + U9_32 * T(36.03) - minus_U9_33 * T(7.2250000000000005);

  // ---- body 10 (body_10) on body 9
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  const T omegadot10_1 = ydot[27], omegadot10_2 = ydot[28], omegadot10_3 = ydot[29];
  // erel10 = -e9~ e10 + eps4_9 e10 - eps4_10 e9: Euler parameters relative to the lower body
  const T erel10_1 = eps9_3 * eps10_2 - eps9_2 * eps10_3 + eps9_4 * eps10_1 - eps10_4 * eps9_1;
  const T erel10_2 = eps9_1 * eps10_3 - eps9_3 * eps10_1 + eps9_4 * eps10_2 - eps10_4 * eps9_2;
  const T erel10_3 = eps9_2 * eps10_1 - eps9_1 * eps10_2 + eps9_4 * eps10_3 - eps10_4 * eps9_3;
  // eps4rel10 = e9 . e10 + eps4_9 eps4_10
  const T eps4rel10 = eps9_1 * eps10_1 + eps9_2 * eps10_2 + eps9_3 * eps10_3 + eps9_4 * eps10_4;
  // C10^T = 1 + 2 erel10~ (eps4rel10 + erel10~): C takes components in the lower body to those in the body
  const T t10_1 = T(2) * erel10_2;
  const T t10_2 = t10_1 * erel10_2;
  const T t10_3 = T(2) * erel10_3;
  const T t10_4 = t10_3 * erel10_3;
  const T C10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * erel10_1;
  const T t10_6 = t10_5 * erel10_2;
  const T t10_7 = t10_3 * eps4rel10;
  const T C10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * erel10_3;
  const T t10_9 = t10_1 * eps4rel10;
  const T C10_13 = t10_8 - t10_9;
  const T C10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * erel10_1;
  const T C10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * erel10_3;
  const T t10_12 = t10_5 * eps4rel10;
  const T C10_23 = t10_11 + t10_12;
  const T C10_31 = t10_8 + t10_9;
  const T C10_32 = t10_11 - t10_12;
  const T C10_33 = t10_10 - t10_2;
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
  // Pddot10 = C10 (U9 q10 + Pddot9): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t10_19 = Pddot9_1 + U9_12 * T(0.5) - minus_U9_11 * T(0.3) + U9_13 * T(0.1);
  const T t10_20 = Pddot9_2 + U9_21 * T(0.3) - minus_U9_22 * T(0.5) + U9_23 * T(0.1);
  const T t10_21 = Pddot9_3 + U9_31 * T(0.3) + U9_32 * T(0.5) - minus_U9_33 * T(0.1);
  const T Pddot10_1 = C10_11 * t10_19 + C10_12 * t10_20 + C10_13 * t10_21;
  const T Pddot10_2 = C10_21 * t10_19 + C10_22 * t10_20 + C10_23 * t10_21;
  const T Pddot10_3 = C10_31 * t10_19 + C10_32 * t10_20 + C10_33 * t10_21;
  // N9 = C10^T M_torque_10_ + h_all_9~ Pddot9 + axial(U9 (tr(J_all_9)/2 - J_all_9)) - M_torque_9_: inertia less
  //   applied moment about the body origin, body axes [N m]
  const T N9_1 = C10_11 * u.tau_10_1 - u.tau_9_1 + C10_21 * u.tau_10_2 + C10_31 * u.tau_10_3 + T(36.03) * Pddot9_3 -
      T(7.2250000000000005) * Pddot9_2 + T(17.958) * U9_32 - T(0.8507500000000001) * U9_23 + T(3.5916) * (minus_U9_22
      - minus_U9_33) + T(10.7235) * U9_31 - T(2.1428) * U9_21;
  const T N9_2 = C10_12 * u.tau_10_1 - u.tau_9_2 + C10_22 * u.tau_10_2 + C10_32 * u.tau_10_3 + T(7.2250000000000005) *
      Pddot9_1 - T(21.58) * Pddot9_3 + T(0.8507500000000001) * U9_13 - T(6.531) * U9_31 + T(2.1428) * (minus_U9_33 -
      minus_U9_11) + T(3.5916) * U9_12 - T(10.7235) * U9_32;
  const T N9_3 = C10_13 * u.tau_10_1 - u.tau_9_3 + C10_23 * u.tau_10_2 + C10_33 * u.tau_10_3 + T(21.58) * Pddot9_2 -
      T(36.03) * Pddot9_1 + T(6.531) * U9_21 - T(17.958) * U9_12 + T(10.7235) * (minus_U9_11 - minus_U9_22) +
      T(2.1428) * U9_23 - T(3.5916) * U9_13;
  // G10 = U10 h_all_10: inertia less applied force, body axes [N]
  const T G10_1 = U10_12 * T(38.515) - minus_U10_11 * T(20.99) + U10_13 * T(7.03);
  const T G10_2 = U10_21 * T(20.99) - minus_U10_22 * T(38.515) + U10_23 * T(7.03);
  const T G10_3 = U10_31 * T(20.99) + U10_32 * T(38.515) - minus_U10_33 * T(7.03);

  // ---- body 11 (body_11) on body 10
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  const T omegadot11_1 = ydot[30], omegadot11_2 = ydot[31], omegadot11_3 = ydot[32];
  // erel11 = -e10~ e11 + eps4_10 e11 - eps4_11 e10: Euler parameters relative to the lower body
  const T erel11_1 = eps10_3 * eps11_2 - eps10_2 * eps11_3 + eps10_4 * eps11_1 - eps11_4 * eps10_1;
  const T erel11_2 = eps10_1 * eps11_3 - eps10_3 * eps11_1 + eps10_4 * eps11_2 - eps11_4 * eps10_2;
  const T erel11_3 = eps10_2 * eps11_1 - eps10_1 * eps11_2 + eps10_4 * eps11_3 - eps11_4 * eps10_3;
  // eps4rel11 = e10 . e11 + eps4_10 eps4_11
  const T eps4rel11 = eps10_1 * eps11_1 + eps10_2 * eps11_2 + eps10_3 * eps11_3 + eps10_4 * eps11_4;
  // C11^T = 1 + 2 erel11~ (eps4rel11 + erel11~): C takes components in the lower body to those in the body
  const T t11_1 = T(2) * erel11_2;
  const T t11_2 = t11_1 * erel11_2;
  const T t11_3 = T(2) * erel11_3;
  const T t11_4 = t11_3 * erel11_3;
  const T C11_11 = T(1) - t11_2 - t11_4;
  const T t11_5 = T(2) * erel11_1;
  const T t11_6 = t11_5 * erel11_2;
  const T t11_7 = t11_3 * eps4rel11;
  const T C11_12 = t11_6 + t11_7;
  const T t11_8 = t11_5 * erel11_3;
  const T t11_9 = t11_1 * eps4rel11;
  const T C11_13 = t11_8 - t11_9;
  const T C11_21 = t11_6 - t11_7;
  const T t11_10 = T(1) - t11_5 * erel11_1;
  const T C11_22 = t11_10 - t11_4;
  const T t11_11 = t11_1 * erel11_3;
  const T t11_12 = t11_5 * eps4rel11;
  const T C11_23 = t11_11 + t11_12;
  const T C11_31 = t11_8 + t11_9;
  const T C11_32 = t11_11 - t11_12;
  const T C11_33 = t11_10 - t11_2;
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
  // Pddot11 = C11 (U10 q11 + Pddot10): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t11_19 = Pddot10_1 + U10_12 * T(0.55) - minus_U10_11 * T(0.3) + U10_13 * T(0.1);
  const T t11_20 = Pddot10_2 + U10_21 * T(0.3) - minus_U10_22 * T(0.55) + U10_23 * T(0.1);
  const T t11_21 = Pddot10_3 + U10_31 * T(0.3) + U10_32 * T(0.55) - minus_U10_33 * T(0.1);
  const T Pddot11_1 = C11_11 * t11_19 + C11_12 * t11_20 + C11_13 * t11_21;
  const T Pddot11_2 = C11_21 * t11_19 + C11_22 * t11_20 + C11_23 * t11_21;
  const T Pddot11_3 = C11_31 * t11_19 + C11_32 * t11_20 + C11_33 * t11_21;
  // N10 = C11^T M_torque_11_ + h_all_10~ Pddot10 + axial(U10 (tr(J_all_10)/2 - J_all_10)) - M_torque_10_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N10_1 = C11_11 * u.tau_11_1 - u.tau_10_1 + C11_21 * u.tau_11_2 + C11_31 * u.tau_11_3 + T(38.515) * Pddot10_3
      - T(7.03) * Pddot10_2 + T(21.103250000000003) * U10_32 - T(0.8380000000000001) * U10_23 + T(3.8395000000000006)
      * (minus_U10_22 - minus_U10_33) + T(11.464500000000001) * U10_31 - T(2.083) * U10_21;
  const T N10_2 = C11_12 * u.tau_11_1 - u.tau_10_2 + C11_22 * u.tau_11_2 + C11_32 * u.tau_11_3 + T(7.03) * Pddot10_1 -
      T(20.99) * Pddot10_3 + T(0.8380000000000001) * U10_13 - T(6.356999999999999) * U10_31 + T(2.083) * (minus_U10_33
      - minus_U10_11) + T(3.8395000000000006) * U10_12 - T(11.464500000000001) * U10_32;
  const T N10_3 = C11_13 * u.tau_11_1 - u.tau_10_3 + C11_23 * u.tau_11_2 + C11_33 * u.tau_11_3 + T(20.99) * Pddot10_2
      - T(38.515) * Pddot10_1 + T(6.356999999999999) * U10_21 - T(21.103250000000003) * U10_12 + T(11.464500000000001)
      * (minus_U10_11 - minus_U10_22) + T(2.083) * U10_23 - T(3.8395000000000006) * U10_13;
  // G11 = U11 h_all_11: inertia less applied force, body axes [N]
  const T G11_1 = U11_12 * T(40.739999999999995) - minus_U11_11 * T(20.369999999999997) + U11_13 * T(6.825);
  const T G11_2 = U11_21 * T(20.369999999999997) - minus_U11_22 * T(40.739999999999995) + U11_23 * T(6.825);
  const T G11_3 = U11_31 * T(20.369999999999997) + U11_32 * T(40.739999999999995) - minus_U11_33 * T(6.825);

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  const T omegadot12_1 = ydot[33], omegadot12_2 = ydot[34], omegadot12_3 = ydot[35];
  // erel12 = -e11~ e12 + eps4_11 e12 - eps4_12 e11: Euler parameters relative to the lower body
  const T erel12_1 = eps11_3 * eps12_2 - eps11_2 * eps12_3 + eps11_4 * eps12_1 - eps12_4 * eps11_1;
  const T erel12_2 = eps11_1 * eps12_3 - eps11_3 * eps12_1 + eps11_4 * eps12_2 - eps12_4 * eps11_2;
  const T erel12_3 = eps11_2 * eps12_1 - eps11_1 * eps12_2 + eps11_4 * eps12_3 - eps12_4 * eps11_3;
  // eps4rel12 = e11 . e12 + eps4_11 eps4_12
  const T eps4rel12 = eps11_1 * eps12_1 + eps11_2 * eps12_2 + eps11_3 * eps12_3 + eps11_4 * eps12_4;
  // C12^T = 1 + 2 erel12~ (eps4rel12 + erel12~): C takes components in the lower body to those in the body
  const T t12_1 = T(2) * erel12_2;
  const T t12_2 = t12_1 * erel12_2;
  const T t12_3 = T(2) * erel12_3;
  const T t12_4 = t12_3 * erel12_3;
  const T C12_11 = T(1) - t12_2 - t12_4;
  const T t12_5 = T(2) * erel12_1;
  const T t12_6 = t12_5 * erel12_2;
  const T t12_7 = t12_3 * eps4rel12;
  const T C12_12 = t12_6 + t12_7;
  const T t12_8 = t12_5 * erel12_3;
  const T t12_9 = t12_1 * eps4rel12;
  const T C12_13 = t12_8 - t12_9;
  const T C12_21 = t12_6 - t12_7;
  const T t12_10 = T(1) - t12_5 * erel12_1;
  const T C12_22 = t12_10 - t12_4;
  const T t12_11 = t12_1 * erel12_3;
  const T t12_12 = t12_5 * eps4rel12;
  const T C12_23 = t12_11 + t12_12;
  const T C12_31 = t12_8 + t12_9;
  const T C12_32 = t12_11 - t12_12;
  const T C12_33 = t12_10 - t12_2;
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
  // Pddot12 = C12 (U11 q12 + Pddot11): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t12_19 = Pddot11_1 + U11_12 * T(0.6) - minus_U11_11 * T(0.3) + U11_13 * T(0.1);
  const T t12_20 = Pddot11_2 + U11_21 * T(0.3) - minus_U11_22 * T(0.6) + U11_23 * T(0.1);
  const T t12_21 = Pddot11_3 + U11_31 * T(0.3) + U11_32 * T(0.6) - minus_U11_33 * T(0.1);
  const T Pddot12_1 = C12_11 * t12_19 + C12_12 * t12_20 + C12_13 * t12_21;
  const T Pddot12_2 = C12_21 * t12_19 + C12_22 * t12_20 + C12_23 * t12_21;
  const T Pddot12_3 = C12_31 * t12_19 + C12_32 * t12_20 + C12_33 * t12_21;
  // N11 = C12^T M_torque_12_ + h_all_11~ Pddot11 + axial(U11 (tr(J_all_11)/2 - J_all_11)) - M_torque_11_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N11_1 = C12_11 * u.tau_12_1 - u.tau_11_1 + C12_21 * u.tau_12_2 + C12_31 * u.tau_12_3 + T(40.739999999999995)
      * Pddot11_3 - T(6.825) * Pddot11_2 + T(24.339) * U11_32 - T(0.82425) * U11_23 + T(4.0614) * (minus_U11_22 -
      minus_U11_33) + T(12.1275) * U11_31 - T(2.0202) * U11_21;
  const T N11_2 = C12_12 * u.tau_12_1 - u.tau_11_2 + C12_22 * u.tau_12_2 + C12_32 * u.tau_12_3 + T(6.825) * Pddot11_1
      - T(20.369999999999997) * Pddot11_3 + T(0.82425) * U11_13 - T(6.1739999999999995) * U11_31 + T(2.0202) *
      (minus_U11_33 - minus_U11_11) + T(4.0614) * U11_12 - T(12.1275) * U11_32;
  const T N11_3 = C12_13 * u.tau_12_1 - u.tau_11_3 + C12_23 * u.tau_12_2 + C12_33 * u.tau_12_3 + T(20.369999999999997)
      * Pddot11_2 - T(40.739999999999995) * Pddot11_1 + T(6.1739999999999995) * U11_21 - T(24.339) * U11_12 +
      T(12.1275) * (minus_U11_11 - minus_U11_22) + T(2.0202) * U11_23 - T(4.0614) * U11_13;
  // G12 = U12 h_all_12: inertia less applied force, body axes [N]
  const T G12_1 = U12_12 * T(42.69) - minus_U12_11 * T(19.72) + U12_13 * T(6.61);
  const T G12_2 = U12_21 * T(19.72) - minus_U12_22 * T(42.69) + U12_23 * T(6.61);
  const T G12_3 = U12_31 * T(19.72) + U12_32 * T(42.69) - minus_U12_33 * T(6.61);

  // ---- body 13 (body_13) on body 12
  const T eps13_1 = x[48], eps13_2 = x[49], eps13_3 = x[50], eps13_4 = x[51];
  const T omega13_1 = y[36], omega13_2 = y[37], omega13_3 = y[38];
  const T omegadot13_1 = ydot[36], omegadot13_2 = ydot[37], omegadot13_3 = ydot[38];
  // erel13 = -e12~ e13 + eps4_12 e13 - eps4_13 e12: Euler parameters relative to the lower body
  const T erel13_1 = eps12_3 * eps13_2 - eps12_2 * eps13_3 + eps12_4 * eps13_1 - eps13_4 * eps12_1;
  const T erel13_2 = eps12_1 * eps13_3 - eps12_3 * eps13_1 + eps12_4 * eps13_2 - eps13_4 * eps12_2;
  const T erel13_3 = eps12_2 * eps13_1 - eps12_1 * eps13_2 + eps12_4 * eps13_3 - eps13_4 * eps12_3;
  // eps4rel13 = e12 . e13 + eps4_12 eps4_13
  const T eps4rel13 = eps12_1 * eps13_1 + eps12_2 * eps13_2 + eps12_3 * eps13_3 + eps12_4 * eps13_4;
  // C13^T = 1 + 2 erel13~ (eps4rel13 + erel13~): C takes components in the lower body to those in the body
  const T t13_1 = T(2) * erel13_2;
  const T t13_2 = t13_1 * erel13_2;
  const T t13_3 = T(2) * erel13_3;
  const T t13_4 = t13_3 * erel13_3;
  const T C13_11 = T(1) - t13_2 - t13_4;
  const T t13_5 = T(2) * erel13_1;
  const T t13_6 = t13_5 * erel13_2;
  const T t13_7 = t13_3 * eps4rel13;
  const T C13_12 = t13_6 + t13_7;
  const T t13_8 = t13_5 * erel13_3;
  const T t13_9 = t13_1 * eps4rel13;
  const T C13_13 = t13_8 - t13_9;
  const T C13_21 = t13_6 - t13_7;
  const T t13_10 = T(1) - t13_5 * erel13_1;
  const T C13_22 = t13_10 - t13_4;
  const T t13_11 = t13_1 * erel13_3;
  const T t13_12 = t13_5 * eps4rel13;
  const T C13_23 = t13_11 + t13_12;
  const T C13_31 = t13_8 + t13_9;
  const T C13_32 = t13_11 - t13_12;
  const T C13_33 = t13_10 - t13_2;
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
  // Pddot13 = C13 (U12 q13 + Pddot12): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t13_19 = Pddot12_1 + U12_12 * T(0.65) - minus_U12_11 * T(0.3) + U12_13 * T(0.1);
  const T t13_20 = Pddot12_2 + U12_21 * T(0.3) - minus_U12_22 * T(0.65) + U12_23 * T(0.1);
  const T t13_21 = Pddot12_3 + U12_31 * T(0.3) + U12_32 * T(0.65) - minus_U12_33 * T(0.1);
  const T Pddot13_1 = C13_11 * t13_19 + C13_12 * t13_20 + C13_13 * t13_21;
  const T Pddot13_2 = C13_21 * t13_19 + C13_22 * t13_20 + C13_23 * t13_21;
  const T Pddot13_3 = C13_31 * t13_19 + C13_32 * t13_20 + C13_33 * t13_21;
  // N12 = C13^T M_torque_13_ + h_all_12~ Pddot12 + axial(U12 (tr(J_all_12)/2 - J_all_12)) - M_torque_12_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N12_1 = C13_11 * u.tau_13_1 - u.tau_12_1 + C13_21 * u.tau_13_2 + C13_31 * u.tau_13_3 + T(42.69) * Pddot12_3
      - T(6.61) * Pddot12_2 + T(27.616500000000002) * U12_32 - T(0.8095000000000001) * U12_23 + T(4.255800000000001) *
      (minus_U12_22 - minus_U12_33) + T(12.708) * U12_31 - T(1.9544) * U12_21;
  const T N12_2 = C13_12 * u.tau_13_1 - u.tau_12_2 + C13_22 * u.tau_13_2 + C13_32 * u.tau_13_3 + T(6.61) * Pddot12_1 -
      T(19.72) * Pddot12_3 + T(0.8095000000000001) * U12_13 - T(5.981999999999999) * U12_31 + T(1.9544) *
      (minus_U12_33 - minus_U12_11) + T(4.255800000000001) * U12_12 - T(12.708) * U12_32;
  const T N12_3 = C13_13 * u.tau_13_1 - u.tau_12_3 + C13_23 * u.tau_13_2 + C13_33 * u.tau_13_3 + T(19.72) * Pddot12_2
      - T(42.69) * Pddot12_1 + T(5.981999999999999) * U12_21 - T(27.616500000000002) * U12_12 + T(12.708) *
      (minus_U12_11 - minus_U12_22) + T(1.9544) * U12_23 - T(4.255800000000001) * U12_13;
  // G13 = U13 h_all_13: inertia less applied force, body axes [N]
  const T G13_1 = U13_12 * T(44.349999999999994) - minus_U13_11 * T(19.04) + U13_13 * T(6.385000000000001);
  const T G13_2 = U13_21 * T(19.04) - minus_U13_22 * T(44.349999999999994) + U13_23 * T(6.385000000000001);
  const T G13_3 = U13_31 * T(19.04) + U13_32 * T(44.349999999999994) - minus_U13_33 * T(6.385000000000001);

  // ---- body 14 (body_14) on body 13
  const T eps14_1 = x[52], eps14_2 = x[53], eps14_3 = x[54], eps14_4 = x[55];
  const T omega14_1 = y[39], omega14_2 = y[40], omega14_3 = y[41];
  const T omegadot14_1 = ydot[39], omegadot14_2 = ydot[40], omegadot14_3 = ydot[41];
  // erel14 = -e13~ e14 + eps4_13 e14 - eps4_14 e13: Euler parameters relative to the lower body
  const T erel14_1 = eps13_3 * eps14_2 - eps13_2 * eps14_3 + eps13_4 * eps14_1 - eps14_4 * eps13_1;
  const T erel14_2 = eps13_1 * eps14_3 - eps13_3 * eps14_1 + eps13_4 * eps14_2 - eps14_4 * eps13_2;
  const T erel14_3 = eps13_2 * eps14_1 - eps13_1 * eps14_2 + eps13_4 * eps14_3 - eps14_4 * eps13_3;
  // eps4rel14 = e13 . e14 + eps4_13 eps4_14
  const T eps4rel14 = eps13_1 * eps14_1 + eps13_2 * eps14_2 + eps13_3 * eps14_3 + eps13_4 * eps14_4;
  // C14^T = 1 + 2 erel14~ (eps4rel14 + erel14~): C takes components in the lower body to those in the body
  const T t14_1 = T(2) * erel14_2;
  const T t14_2 = t14_1 * erel14_2;
  const T t14_3 = T(2) * erel14_3;
  const T t14_4 = t14_3 * erel14_3;
  const T C14_11 = T(1) - t14_2 - t14_4;
  const T t14_5 = T(2) * erel14_1;
  const T t14_6 = t14_5 * erel14_2;
  const T t14_7 = t14_3 * eps4rel14;
  const T C14_12 = t14_6 + t14_7;
  const T t14_8 = t14_5 * erel14_3;
  const T t14_9 = t14_1 * eps4rel14;
  const T C14_13 = t14_8 - t14_9;
  const T C14_21 = t14_6 - t14_7;
  const T t14_10 = T(1) - t14_5 * erel14_1;
  const T C14_22 = t14_10 - t14_4;
  const T t14_11 = t14_1 * erel14_3;
  const T t14_12 = t14_5 * eps4rel14;
  const T C14_23 = t14_11 + t14_12;
  const T C14_31 = t14_8 + t14_9;
  const T C14_32 = t14_11 - t14_12;
  const T C14_33 = t14_10 - t14_2;
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
  // Pddot14 = C14 (U13 q14 + Pddot13): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t14_19 = Pddot13_1 + U13_12 * T(0.7) - minus_U13_11 * T(0.3) + U13_13 * T(0.1);
  const T t14_20 = Pddot13_2 + U13_21 * T(0.3) - minus_U13_22 * T(0.7) + U13_23 * T(0.1);
  const T t14_21 = Pddot13_3 + U13_31 * T(0.3) + U13_32 * T(0.7) - minus_U13_33 * T(0.1);
  const T Pddot14_1 = C14_11 * t14_19 + C14_12 * t14_20 + C14_13 * t14_21;
  const T Pddot14_2 = C14_21 * t14_19 + C14_22 * t14_20 + C14_23 * t14_21;
  const T Pddot14_3 = C14_31 * t14_19 + C14_32 * t14_20 + C14_33 * t14_21;
  // N13 = C14^T M_torque_14_ + h_all_13~ Pddot13 + axial(U13 (tr(J_all_13)/2 - J_all_13)) - M_torque_13_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N13_1 = C14_11 * u.tau_14_1 - u.tau_13_1 + C14_21 * u.tau_14_2 + C14_31 * u.tau_14_3 + T(44.349999999999994)
      * Pddot13_3 - T(6.385000000000001) * Pddot13_2 + T(30.883999999999997) * U13_32 - T(0.7937500000000001) * U13_23
      + T(4.4212) * (minus_U13_22 - minus_U13_33) + T(13.2015) * U13_31 - T(1.8856) * U13_21;
  const T N13_2 = C14_12 * u.tau_14_1 - u.tau_13_2 + C14_22 * u.tau_14_2 + C14_32 * u.tau_14_3 + T(6.385000000000001)
      * Pddot13_1 - T(19.04) * Pddot13_3 + T(0.7937500000000001) * U13_13 - T(5.781) * U13_31 + T(1.8856) *
      (minus_U13_33 - minus_U13_11) + T(4.4212) * U13_12 - T(13.2015) * U13_32;
  const T N13_3 = C14_13 * u.tau_14_1 - u.tau_13_3 + C14_23 * u.tau_14_2 + C14_33 * u.tau_14_3 + T(19.04) * Pddot13_2
      - T(44.349999999999994) * Pddot13_1 + T(5.781) * U13_21 - T(30.883999999999997) * U13_12 + T(13.2015) *
      (minus_U13_11 - minus_U13_22) + T(1.8856) * U13_23 - T(4.4212) * U13_13;
  // G14 = U14 h_all_14: inertia less applied force, body axes [N]
  const T G14_1 = U14_12 * T(45.705) - minus_U14_11 * T(18.33) + U14_13 * T(6.15);
  const T G14_2 = U14_21 * T(18.33) - minus_U14_22 * T(45.705) + U14_23 * T(6.15);
  const T G14_3 = U14_31 * T(18.33) + U14_32 * T(45.705) - minus_U14_33 * T(6.15);

  // ---- body 15 (body_15) on body 14
  const T eps15_1 = x[56], eps15_2 = x[57], eps15_3 = x[58], eps15_4 = x[59];
  const T omega15_1 = y[42], omega15_2 = y[43], omega15_3 = y[44];
  const T omegadot15_1 = ydot[42], omegadot15_2 = ydot[43], omegadot15_3 = ydot[44];
  // erel15 = -e14~ e15 + eps4_14 e15 - eps4_15 e14: Euler parameters relative to the lower body
  const T erel15_1 = eps14_3 * eps15_2 - eps14_2 * eps15_3 + eps14_4 * eps15_1 - eps15_4 * eps14_1;
  const T erel15_2 = eps14_1 * eps15_3 - eps14_3 * eps15_1 + eps14_4 * eps15_2 - eps15_4 * eps14_2;
  const T erel15_3 = eps14_2 * eps15_1 - eps14_1 * eps15_2 + eps14_4 * eps15_3 - eps15_4 * eps14_3;
  // eps4rel15 = e14 . e15 + eps4_14 eps4_15
  const T eps4rel15 = eps14_1 * eps15_1 + eps14_2 * eps15_2 + eps14_3 * eps15_3 + eps14_4 * eps15_4;
  // C15^T = 1 + 2 erel15~ (eps4rel15 + erel15~): C takes components in the lower body to those in the body
  const T t15_1 = T(2) * erel15_2;
  const T t15_2 = t15_1 * erel15_2;
  const T t15_3 = T(2) * erel15_3;
  const T t15_4 = t15_3 * erel15_3;
  const T C15_11 = T(1) - t15_2 - t15_4;
  const T t15_5 = T(2) * erel15_1;
  const T t15_6 = t15_5 * erel15_2;
  const T t15_7 = t15_3 * eps4rel15;
  const T C15_12 = t15_6 + t15_7;
  const T t15_8 = t15_5 * erel15_3;
  const T t15_9 = t15_1 * eps4rel15;
  const T C15_13 = t15_8 - t15_9;
  const T C15_21 = t15_6 - t15_7;
  const T t15_10 = T(1) - t15_5 * erel15_1;
  const T C15_22 = t15_10 - t15_4;
  const T t15_11 = t15_1 * erel15_3;
  const T t15_12 = t15_5 * eps4rel15;
  const T C15_23 = t15_11 + t15_12;
  const T C15_31 = t15_8 + t15_9;
  const T C15_32 = t15_11 - t15_12;
  const T C15_33 = t15_10 - t15_2;
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
  // Pddot15 = C15 (U14 q15 + Pddot14): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t15_19 = Pddot14_1 + U14_12 * T(0.75) - minus_U14_11 * T(0.3) + U14_13 * T(0.1);
  const T t15_20 = Pddot14_2 + U14_21 * T(0.3) - minus_U14_22 * T(0.75) + U14_23 * T(0.1);
  const T t15_21 = Pddot14_3 + U14_31 * T(0.3) + U14_32 * T(0.75) - minus_U14_33 * T(0.1);
  const T Pddot15_1 = C15_11 * t15_19 + C15_12 * t15_20 + C15_13 * t15_21;
  const T Pddot15_2 = C15_21 * t15_19 + C15_22 * t15_20 + C15_23 * t15_21;
  const T Pddot15_3 = C15_31 * t15_19 + C15_32 * t15_20 + C15_33 * t15_21;
  // N14 = C15^T M_torque_15_ + h_all_14~ Pddot14 + axial(U14 (tr(J_all_14)/2 - J_all_14)) - M_torque_14_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N14_1 = C15_11 * u.tau_15_1 - u.tau_14_1 + C15_21 * u.tau_15_2 + C15_31 * u.tau_15_3 + T(45.705) * Pddot14_3
      - T(6.15) * Pddot14_2 + T(34.08675) * U14_32 - T(0.777) * U14_23 + T(4.5561) * (minus_U14_22 - minus_U14_33) +
      T(13.603499999999999) * U14_31 - T(1.8138) * U14_21;
  const T N14_2 = C15_12 * u.tau_15_1 - u.tau_14_2 + C15_22 * u.tau_15_2 + C15_32 * u.tau_15_3 + T(6.15) * Pddot14_1 -
      T(18.33) * Pddot14_3 + T(0.777) * U14_13 - T(5.571) * U14_31 + T(1.8138) * (minus_U14_33 - minus_U14_11) +
      T(4.5561) * U14_12 - T(13.603499999999999) * U14_32;
  const T N14_3 = C15_13 * u.tau_15_1 - u.tau_14_3 + C15_23 * u.tau_15_2 + C15_33 * u.tau_15_3 + T(18.33) * Pddot14_2
      - T(45.705) * Pddot14_1 + T(5.571) * U14_21 - T(34.08675) * U14_12 + T(13.603499999999999) * (minus_U14_11 -
      minus_U14_22) + T(1.8138) * U14_23 - T(4.5561) * U14_13;
  // G15 = U15 h_all_15: inertia less applied force, body axes [N]
  const T G15_1 = U15_12 * T(46.74) - minus_U15_11 * T(17.59) + U15_13 * T(5.905);
  const T G15_2 = U15_21 * T(17.59) - minus_U15_22 * T(46.74) + U15_23 * T(5.905);
  const T G15_3 = U15_31 * T(17.59) + U15_32 * T(46.74) - minus_U15_33 * T(5.905);

  // ---- body 16 (body_16) on body 15
  const T eps16_1 = x[60], eps16_2 = x[61], eps16_3 = x[62], eps16_4 = x[63];
  const T omega16_1 = y[45], omega16_2 = y[46], omega16_3 = y[47];
  const T omegadot16_1 = ydot[45], omegadot16_2 = ydot[46], omegadot16_3 = ydot[47];
  // erel16 = -e15~ e16 + eps4_15 e16 - eps4_16 e15: Euler parameters relative to the lower body
  const T erel16_1 = eps15_3 * eps16_2 - eps15_2 * eps16_3 + eps15_4 * eps16_1 - eps16_4 * eps15_1;
  const T erel16_2 = eps15_1 * eps16_3 - eps15_3 * eps16_1 + eps15_4 * eps16_2 - eps16_4 * eps15_2;
  const T erel16_3 = eps15_2 * eps16_1 - eps15_1 * eps16_2 + eps15_4 * eps16_3 - eps16_4 * eps15_3;
  // eps4rel16 = e15 . e16 + eps4_15 eps4_16
  const T eps4rel16 = eps15_1 * eps16_1 + eps15_2 * eps16_2 + eps15_3 * eps16_3 + eps15_4 * eps16_4;
  // C16^T = 1 + 2 erel16~ (eps4rel16 + erel16~): C takes components in the lower body to those in the body
  const T t16_1 = T(2) * erel16_2;
  const T t16_2 = t16_1 * erel16_2;
  const T t16_3 = T(2) * erel16_3;
  const T t16_4 = t16_3 * erel16_3;
  const T C16_11 = T(1) - t16_2 - t16_4;
  const T t16_5 = T(2) * erel16_1;
  const T t16_6 = t16_5 * erel16_2;
  const T t16_7 = t16_3 * eps4rel16;
  const T C16_12 = t16_6 + t16_7;
  const T t16_8 = t16_5 * erel16_3;
  const T t16_9 = t16_1 * eps4rel16;
  const T C16_13 = t16_8 - t16_9;
  const T C16_21 = t16_6 - t16_7;
  const T t16_10 = T(1) - t16_5 * erel16_1;
  const T C16_22 = t16_10 - t16_4;
  const T t16_11 = t16_1 * erel16_3;
  const T t16_12 = t16_5 * eps4rel16;
  const T C16_23 = t16_11 + t16_12;
  const T C16_31 = t16_8 + t16_9;
  const T C16_32 = t16_11 - t16_12;
  const T C16_33 = t16_10 - t16_2;
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
  // Pddot16 = C16 (U15 q16 + Pddot15): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t16_19 = Pddot15_1 + U15_12 * T(0.8) - minus_U15_11 * T(0.3) + U15_13 * T(0.1);
  const T t16_20 = Pddot15_2 + U15_21 * T(0.3) - minus_U15_22 * T(0.8) + U15_23 * T(0.1);
  const T t16_21 = Pddot15_3 + U15_31 * T(0.3) + U15_32 * T(0.8) - minus_U15_33 * T(0.1);
  const T Pddot16_1 = C16_11 * t16_19 + C16_12 * t16_20 + C16_13 * t16_21;
  const T Pddot16_2 = C16_21 * t16_19 + C16_22 * t16_20 + C16_23 * t16_21;
  const T Pddot16_3 = C16_31 * t16_19 + C16_32 * t16_20 + C16_33 * t16_21;
  // N15 = C16^T M_torque_16_ + h_all_15~ Pddot15 + axial(U15 (tr(J_all_15)/2 - J_all_15)) - M_torque_15_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N15_1 = C16_11 * u.tau_16_1 - u.tau_15_1 + C16_21 * u.tau_16_2 + C16_31 * u.tau_16_3 + T(46.74) * Pddot15_3
      - T(5.905) * Pddot15_2 + T(37.167) * U15_32 - T(0.7592500000000001) * U15_23 + T(4.659000000000001) *
      (minus_U15_22 - minus_U15_33) + T(13.9095) * U15_31 - T(1.739) * U15_21;
  const T N15_2 = C16_12 * u.tau_16_1 - u.tau_15_2 + C16_22 * u.tau_16_2 + C16_32 * u.tau_16_3 + T(5.905) * Pddot15_1
      - T(17.59) * Pddot15_3 + T(0.7592500000000001) * U15_13 - T(5.351999999999999) * U15_31 + T(1.739) *
      (minus_U15_33 - minus_U15_11) + T(4.659000000000001) * U15_12 - T(13.9095) * U15_32;
  const T N15_3 = C16_13 * u.tau_16_1 - u.tau_15_3 + C16_23 * u.tau_16_2 + C16_33 * u.tau_16_3 + T(17.59) * Pddot15_2
      - T(46.74) * Pddot15_1 + T(5.351999999999999) * U15_21 - T(37.167) * U15_12 + T(13.9095) * (minus_U15_11 -
      minus_U15_22) + T(1.739) * U15_23 - T(4.659000000000001) * U15_13;
  // G16 = U16 h_all_16: inertia less applied force, body axes [N]
  const T G16_1 = U16_12 * T(47.44) - minus_U16_11 * T(16.82) + U16_13 * T(5.65);
  const T G16_2 = U16_21 * T(16.82) - minus_U16_22 * T(47.44) + U16_23 * T(5.65);
  const T G16_3 = U16_31 * T(16.82) + U16_32 * T(47.44) - minus_U16_33 * T(5.65);

  // ---- body 17 (body_17) on body 16
  const T eps17_1 = x[64], eps17_2 = x[65], eps17_3 = x[66], eps17_4 = x[67];
  const T omega17_1 = y[48], omega17_2 = y[49], omega17_3 = y[50];
  const T omegadot17_1 = ydot[48], omegadot17_2 = ydot[49], omegadot17_3 = ydot[50];
  // erel17 = -e16~ e17 + eps4_16 e17 - eps4_17 e16: Euler parameters relative to the lower body
  const T erel17_1 = eps16_3 * eps17_2 - eps16_2 * eps17_3 + eps16_4 * eps17_1 - eps17_4 * eps16_1;
  const T erel17_2 = eps16_1 * eps17_3 - eps16_3 * eps17_1 + eps16_4 * eps17_2 - eps17_4 * eps16_2;
  const T erel17_3 = eps16_2 * eps17_1 - eps16_1 * eps17_2 + eps16_4 * eps17_3 - eps17_4 * eps16_3;
  // eps4rel17 = e16 . e17 + eps4_16 eps4_17
  const T eps4rel17 = eps16_1 * eps17_1 + eps16_2 * eps17_2 + eps16_3 * eps17_3 + eps16_4 * eps17_4;
  // C17^T = 1 + 2 erel17~ (eps4rel17 + erel17~): C takes components in the lower body to those in the body
  const T t17_1 = T(2) * erel17_2;
  const T t17_2 = t17_1 * erel17_2;
  const T t17_3 = T(2) * erel17_3;
  const T t17_4 = t17_3 * erel17_3;
  const T C17_11 = T(1) - t17_2 - t17_4;
  const T t17_5 = T(2) * erel17_1;
  const T t17_6 = t17_5 * erel17_2;
  const T t17_7 = t17_3 * eps4rel17;
  const T C17_12 = t17_6 + t17_7;
  const T t17_8 = t17_5 * erel17_3;
  const T t17_9 = t17_1 * eps4rel17;
  const T C17_13 = t17_8 - t17_9;
  const T C17_21 = t17_6 - t17_7;
  const T t17_10 = T(1) - t17_5 * erel17_1;
  const T C17_22 = t17_10 - t17_4;
  const T t17_11 = t17_1 * erel17_3;
  const T t17_12 = t17_5 * eps4rel17;
  const T C17_23 = t17_11 + t17_12;
  const T C17_31 = t17_8 + t17_9;
  const T C17_32 = t17_11 - t17_12;
  const T C17_33 = t17_10 - t17_2;
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
  // Pddot17 = C17 (U16 q17 + Pddot16): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t17_19 = Pddot16_1 + U16_12 * T(0.85) - minus_U16_11 * T(0.3) + U16_13 * T(0.1);
  const T t17_20 = Pddot16_2 + U16_21 * T(0.3) - minus_U16_22 * T(0.85) + U16_23 * T(0.1);
  const T t17_21 = Pddot16_3 + U16_31 * T(0.3) + U16_32 * T(0.85) - minus_U16_33 * T(0.1);
  const T Pddot17_1 = C17_11 * t17_19 + C17_12 * t17_20 + C17_13 * t17_21;
  const T Pddot17_2 = C17_21 * t17_19 + C17_22 * t17_20 + C17_23 * t17_21;
  const T Pddot17_3 = C17_31 * t17_19 + C17_32 * t17_20 + C17_33 * t17_21;
  // N16 = C17^T M_torque_17_ + h_all_16~ Pddot16 + axial(U16 (tr(J_all_16)/2 - J_all_16)) - M_torque_16_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N16_1 = C17_11 * u.tau_17_1 - u.tau_16_1 + C17_21 * u.tau_17_2 + C17_31 * u.tau_17_3 + T(47.44) * Pddot16_3
      - T(5.65) * Pddot16_2 + T(40.064) * U16_32 - T(0.7405) * U16_23 + T(4.7284) * (minus_U16_22 - minus_U16_33) +
      T(14.114999999999998) * U16_31 - T(1.6612) * U16_21;
  const T N16_2 = C17_12 * u.tau_17_1 - u.tau_16_2 + C17_22 * u.tau_17_2 + C17_32 * u.tau_17_3 + T(5.65) * Pddot16_1 -
      T(16.82) * Pddot16_3 + T(0.7405) * U16_13 - T(5.124) * U16_31 + T(1.6612) * (minus_U16_33 - minus_U16_11) +
      T(4.7284) * U16_12 - T(14.114999999999998) * U16_32;
  const T N16_3 = C17_13 * u.tau_17_1 - u.tau_16_3 + C17_23 * u.tau_17_2 + C17_33 * u.tau_17_3 + T(16.82) * Pddot16_2
      - T(47.44) * Pddot16_1 + T(5.124) * U16_21 - T(40.064) * U16_12 + T(14.114999999999998) * (minus_U16_11 -
      minus_U16_22) + T(1.6612) * U16_23 - T(4.7284) * U16_13;
  // G17 = U17 h_all_17: inertia less applied force, body axes [N]
  const T G17_1 = U17_12 * T(47.79) - minus_U17_11 * T(16.02) + U17_13 * T(5.385000000000001);
  const T G17_2 = U17_21 * T(16.02) - minus_U17_22 * T(47.79) + U17_23 * T(5.385000000000001);
  const T G17_3 = U17_31 * T(16.02) + U17_32 * T(47.79) - minus_U17_33 * T(5.385000000000001);

  // ---- body 18 (body_18) on body 17
  const T eps18_1 = x[68], eps18_2 = x[69], eps18_3 = x[70], eps18_4 = x[71];
  const T omega18_1 = y[51], omega18_2 = y[52], omega18_3 = y[53];
  const T omegadot18_1 = ydot[51], omegadot18_2 = ydot[52], omegadot18_3 = ydot[53];
  // erel18 = -e17~ e18 + eps4_17 e18 - eps4_18 e17: Euler parameters relative to the lower body
  const T erel18_1 = eps17_3 * eps18_2 - eps17_2 * eps18_3 + eps17_4 * eps18_1 - eps18_4 * eps17_1;
  const T erel18_2 = eps17_1 * eps18_3 - eps17_3 * eps18_1 + eps17_4 * eps18_2 - eps18_4 * eps17_2;
  const T erel18_3 = eps17_2 * eps18_1 - eps17_1 * eps18_2 + eps17_4 * eps18_3 - eps18_4 * eps17_3;
  // eps4rel18 = e17 . e18 + eps4_17 eps4_18
  const T eps4rel18 = eps17_1 * eps18_1 + eps17_2 * eps18_2 + eps17_3 * eps18_3 + eps17_4 * eps18_4;
  // C18^T = 1 + 2 erel18~ (eps4rel18 + erel18~): C takes components in the lower body to those in the body
  const T t18_1 = T(2) * erel18_2;
  const T t18_2 = t18_1 * erel18_2;
  const T t18_3 = T(2) * erel18_3;
  const T t18_4 = t18_3 * erel18_3;
  const T C18_11 = T(1) - t18_2 - t18_4;
  const T t18_5 = T(2) * erel18_1;
  const T t18_6 = t18_5 * erel18_2;
  const T t18_7 = t18_3 * eps4rel18;
  const T C18_12 = t18_6 + t18_7;
  const T t18_8 = t18_5 * erel18_3;
  const T t18_9 = t18_1 * eps4rel18;
  const T C18_13 = t18_8 - t18_9;
  const T C18_21 = t18_6 - t18_7;
  const T t18_10 = T(1) - t18_5 * erel18_1;
  const T C18_22 = t18_10 - t18_4;
  const T t18_11 = t18_1 * erel18_3;
  const T t18_12 = t18_5 * eps4rel18;
  const T C18_23 = t18_11 + t18_12;
  const T C18_31 = t18_8 + t18_9;
  const T C18_32 = t18_11 - t18_12;
  const T C18_33 = t18_10 - t18_2;
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
  // Pddot18 = C18 (U17 q18 + Pddot17): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t18_19 = Pddot17_1 + U17_12 * T(0.9) - minus_U17_11 * T(0.3) + U17_13 * T(0.1);
  const T t18_20 = Pddot17_2 + U17_21 * T(0.3) - minus_U17_22 * T(0.9) + U17_23 * T(0.1);
  const T t18_21 = Pddot17_3 + U17_31 * T(0.3) + U17_32 * T(0.9) - minus_U17_33 * T(0.1);
  const T Pddot18_1 = C18_11 * t18_19 + C18_12 * t18_20 + C18_13 * t18_21;
  const T Pddot18_2 = C18_21 * t18_19 + C18_22 * t18_20 + C18_23 * t18_21;
  const T Pddot18_3 = C18_31 * t18_19 + C18_32 * t18_20 + C18_33 * t18_21;
  // N17 = C18^T M_torque_18_ + h_all_17~ Pddot17 + axial(U17 (tr(J_all_17)/2 - J_all_17)) - M_torque_17_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N17_1 = C18_11 * u.tau_18_1 - u.tau_17_1 + C18_21 * u.tau_18_2 + C18_31 * u.tau_18_3 + T(47.79) * Pddot17_3
      - T(5.385000000000001) * Pddot17_2 + T(42.714) * U17_32 - T(0.7207500000000001) * U17_23 + T(4.7628) *
      (minus_U17_22 - minus_U17_33) + T(14.2155) * U17_31 - T(1.5804) * U17_21;
  const T N17_2 = C18_12 * u.tau_18_1 - u.tau_17_2 + C18_22 * u.tau_18_2 + C18_32 * u.tau_18_3 + T(5.385000000000001)
      * Pddot17_1 - T(16.02) * Pddot17_3 + T(0.7207500000000001) * U17_13 - T(4.887) * U17_31 + T(1.5804) *
      (minus_U17_33 - minus_U17_11) + T(4.7628) * U17_12 - T(14.2155) * U17_32;
  const T N17_3 = C18_13 * u.tau_18_1 - u.tau_17_3 + C18_23 * u.tau_18_2 + C18_33 * u.tau_18_3 + T(16.02) * Pddot17_2
      - T(47.79) * Pddot17_1 + T(4.887) * U17_21 - T(42.714) * U17_12 + T(14.2155) * (minus_U17_11 - minus_U17_22) +
      T(1.5804) * U17_23 - T(4.7628) * U17_13;
  // G18 = U18 h_all_18: inertia less applied force, body axes [N]
  const T G18_1 = U18_12 * T(47.775) - minus_U18_11 * T(15.19) + U18_13 * T(5.11);
  const T G18_2 = U18_21 * T(15.19) - minus_U18_22 * T(47.775) + U18_23 * T(5.11);
  const T G18_3 = U18_31 * T(15.19) + U18_32 * T(47.775) - minus_U18_33 * T(5.11);

  // ---- body 19 (body_19) on body 18
  const T eps19_1 = x[72], eps19_2 = x[73], eps19_3 = x[74], eps19_4 = x[75];
  const T omega19_1 = y[54], omega19_2 = y[55], omega19_3 = y[56];
  const T omegadot19_1 = ydot[54], omegadot19_2 = ydot[55], omegadot19_3 = ydot[56];
  // erel19 = -e18~ e19 + eps4_18 e19 - eps4_19 e18: Euler parameters relative to the lower body
  const T erel19_1 = eps18_3 * eps19_2 - eps18_2 * eps19_3 + eps18_4 * eps19_1 - eps19_4 * eps18_1;
  const T erel19_2 = eps18_1 * eps19_3 - eps18_3 * eps19_1 + eps18_4 * eps19_2 - eps19_4 * eps18_2;
  const T erel19_3 = eps18_2 * eps19_1 - eps18_1 * eps19_2 + eps18_4 * eps19_3 - eps19_4 * eps18_3;
  // eps4rel19 = e18 . e19 + eps4_18 eps4_19
  const T eps4rel19 = eps18_1 * eps19_1 + eps18_2 * eps19_2 + eps18_3 * eps19_3 + eps18_4 * eps19_4;
  // C19^T = 1 + 2 erel19~ (eps4rel19 + erel19~): C takes components in the lower body to those in the body
  const T t19_1 = T(2) * erel19_2;
  const T t19_2 = t19_1 * erel19_2;
  const T t19_3 = T(2) * erel19_3;
  const T t19_4 = t19_3 * erel19_3;
  const T C19_11 = T(1) - t19_2 - t19_4;
  const T t19_5 = T(2) * erel19_1;
  const T t19_6 = t19_5 * erel19_2;
  const T t19_7 = t19_3 * eps4rel19;
  const T C19_12 = t19_6 + t19_7;
  const T t19_8 = t19_5 * erel19_3;
  const T t19_9 = t19_1 * eps4rel19;
  const T C19_13 = t19_8 - t19_9;
  const T C19_21 = t19_6 - t19_7;
  const T t19_10 = T(1) - t19_5 * erel19_1;
  const T C19_22 = t19_10 - t19_4;
  const T t19_11 = t19_1 * erel19_3;
  const T t19_12 = t19_5 * eps4rel19;
  const T C19_23 = t19_11 + t19_12;
  const T C19_31 = t19_8 + t19_9;
  const T C19_32 = t19_11 - t19_12;
  const T C19_33 = t19_10 - t19_2;
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
  // Pddot19 = C19 (U18 q19 + Pddot18): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t19_19 = Pddot18_1 + U18_12 * T(0.95) - minus_U18_11 * T(0.3) + U18_13 * T(0.1);
  const T t19_20 = Pddot18_2 + U18_21 * T(0.3) - minus_U18_22 * T(0.95) + U18_23 * T(0.1);
  const T t19_21 = Pddot18_3 + U18_31 * T(0.3) + U18_32 * T(0.95) - minus_U18_33 * T(0.1);
  const T Pddot19_1 = C19_11 * t19_19 + C19_12 * t19_20 + C19_13 * t19_21;
  const T Pddot19_2 = C19_21 * t19_19 + C19_22 * t19_20 + C19_23 * t19_21;
  const T Pddot19_3 = C19_31 * t19_19 + C19_32 * t19_20 + C19_33 * t19_21;
  // N18 = C19^T M_torque_19_ + h_all_18~ Pddot18 + axial(U18 (tr(J_all_18)/2 - J_all_18)) - M_torque_18_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N18_1 = C19_11 * u.tau_19_1 - u.tau_18_1 + C19_21 * u.tau_19_2 + C19_31 * u.tau_19_3 + T(47.775) * Pddot18_3
      - T(5.11) * Pddot18_2 + T(45.05025) * U18_32 - T(0.7000000000000001) * U18_23 + T(4.7607) * (minus_U18_22 -
      minus_U18_33) + T(14.206499999999998) * U18_31 - T(1.4966) * U18_21;
  const T N18_2 = C19_12 * u.tau_19_1 - u.tau_18_2 + C19_22 * u.tau_19_2 + C19_32 * u.tau_19_3 + T(5.11) * Pddot18_1 -
      T(15.19) * Pddot18_3 + T(0.7000000000000001) * U18_13 - T(4.641) * U18_31 + T(1.4966) * (minus_U18_33 -
      minus_U18_11) + T(4.7607) * U18_12 - T(14.206499999999998) * U18_32;
  const T N18_3 = C19_13 * u.tau_19_1 - u.tau_18_3 + C19_23 * u.tau_19_2 + C19_33 * u.tau_19_3 + T(15.19) * Pddot18_2
      - T(47.775) * Pddot18_1 + T(4.641) * U18_21 - T(45.05025) * U18_12 + T(14.206499999999998) * (minus_U18_11 -
      minus_U18_22) + T(1.4966) * U18_23 - T(4.7607) * U18_13;
  // G19 = U19 h_all_19: inertia less applied force, body axes [N]
  const T G19_1 = U19_12 * T(47.38) - minus_U19_11 * T(14.33) + U19_13 * T(4.825);
  const T G19_2 = U19_21 * T(14.33) - minus_U19_22 * T(47.38) + U19_23 * T(4.825);
  const T G19_3 = U19_31 * T(14.33) + U19_32 * T(47.38) - minus_U19_33 * T(4.825);

  // ---- body 20 (body_20) on body 19
  const T eps20_1 = x[76], eps20_2 = x[77], eps20_3 = x[78], eps20_4 = x[79];
  const T omega20_1 = y[57], omega20_2 = y[58], omega20_3 = y[59];
  const T omegadot20_1 = ydot[57], omegadot20_2 = ydot[58], omegadot20_3 = ydot[59];
  // erel20 = -e19~ e20 + eps4_19 e20 - eps4_20 e19: Euler parameters relative to the lower body
  const T erel20_1 = eps19_3 * eps20_2 - eps19_2 * eps20_3 + eps19_4 * eps20_1 - eps20_4 * eps19_1;
  const T erel20_2 = eps19_1 * eps20_3 - eps19_3 * eps20_1 + eps19_4 * eps20_2 - eps20_4 * eps19_2;
  const T erel20_3 = eps19_2 * eps20_1 - eps19_1 * eps20_2 + eps19_4 * eps20_3 - eps20_4 * eps19_3;
  // eps4rel20 = e19 . e20 + eps4_19 eps4_20
  const T eps4rel20 = eps19_1 * eps20_1 + eps19_2 * eps20_2 + eps19_3 * eps20_3 + eps19_4 * eps20_4;
  // C20^T = 1 + 2 erel20~ (eps4rel20 + erel20~): C takes components in the lower body to those in the body
  const T t20_1 = T(2) * erel20_2;
  const T t20_2 = t20_1 * erel20_2;
  const T t20_3 = T(2) * erel20_3;
  const T t20_4 = t20_3 * erel20_3;
  const T C20_11 = T(1) - t20_2 - t20_4;
  const T t20_5 = T(2) * erel20_1;
  const T t20_6 = t20_5 * erel20_2;
  const T t20_7 = t20_3 * eps4rel20;
  const T C20_12 = t20_6 + t20_7;
  const T t20_8 = t20_5 * erel20_3;
  const T t20_9 = t20_1 * eps4rel20;
  const T C20_13 = t20_8 - t20_9;
  const T C20_21 = t20_6 - t20_7;
  const T t20_10 = T(1) - t20_5 * erel20_1;
  const T C20_22 = t20_10 - t20_4;
  const T t20_11 = t20_1 * erel20_3;
  const T t20_12 = t20_5 * eps4rel20;
  const T C20_23 = t20_11 + t20_12;
  const T C20_31 = t20_8 + t20_9;
  const T C20_32 = t20_11 - t20_12;
  const T C20_33 = t20_10 - t20_2;
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
  // Pddot20 = C20 (U19 q20 + Pddot19): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t20_19 = U19_12 + Pddot19_1 - minus_U19_11 * T(0.3) + U19_13 * T(0.1);
  const T t20_20 = Pddot19_2 - minus_U19_22 + U19_21 * T(0.3) + U19_23 * T(0.1);
  const T t20_21 = U19_32 + Pddot19_3 + U19_31 * T(0.3) - minus_U19_33 * T(0.1);
  const T Pddot20_1 = C20_11 * t20_19 + C20_12 * t20_20 + C20_13 * t20_21;
  const T Pddot20_2 = C20_21 * t20_19 + C20_22 * t20_20 + C20_23 * t20_21;
  const T Pddot20_3 = C20_31 * t20_19 + C20_32 * t20_20 + C20_33 * t20_21;
  // N19 = C20^T M_torque_20_ + h_all_19~ Pddot19 + axial(U19 (tr(J_all_19)/2 - J_all_19)) - M_torque_19_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N19_1 = C20_11 * u.tau_20_1 - u.tau_19_1 + C20_21 * u.tau_20_2 + C20_31 * u.tau_20_3 + T(47.38) * Pddot19_3
      - T(4.825) * Pddot19_2 + T(47.003) * U19_32 - T(0.67825) * U19_23 + T(4.7206) * (minus_U19_22 - minus_U19_33) +
      T(14.083499999999999) * U19_31 - T(1.4098) * U19_21;
  const T N19_2 = C20_12 * u.tau_20_1 - u.tau_19_2 + C20_22 * u.tau_20_2 + C20_32 * u.tau_20_3 + T(4.825) * Pddot19_1
      - T(14.33) * Pddot19_3 + T(0.67825) * U19_13 - T(4.386) * U19_31 + T(1.4098) * (minus_U19_33 - minus_U19_11) +
      T(4.7206) * U19_12 - T(14.083499999999999) * U19_32;
  const T N19_3 = C20_13 * u.tau_20_1 - u.tau_19_3 + C20_23 * u.tau_20_2 + C20_33 * u.tau_20_3 + T(14.33) * Pddot19_2
      - T(47.38) * Pddot19_1 + T(4.386) * U19_21 - T(47.003) * U19_12 + T(14.083499999999999) * (minus_U19_11 -
      minus_U19_22) + T(1.4098) * U19_23 - T(4.7206) * U19_13;
  // G20 = U20 h_all_20: inertia less applied force, body axes [N]
  const T G20_1 = U20_12 * T(46.59) - minus_U20_11 * T(13.44) + U20_13 * T(4.53);
  const T G20_2 = U20_21 * T(13.44) - minus_U20_22 * T(46.59) + U20_23 * T(4.53);
  const T G20_3 = U20_31 * T(13.44) + U20_32 * T(46.59) - minus_U20_33 * T(4.53);

  // ---- body 21 (body_21) on body 20
  const T eps21_1 = x[80], eps21_2 = x[81], eps21_3 = x[82], eps21_4 = x[83];
  const T omega21_1 = y[60], omega21_2 = y[61], omega21_3 = y[62];
  const T omegadot21_1 = ydot[60], omegadot21_2 = ydot[61], omegadot21_3 = ydot[62];
  // erel21 = -e20~ e21 + eps4_20 e21 - eps4_21 e20: Euler parameters relative to the lower body
  const T erel21_1 = eps20_3 * eps21_2 - eps20_2 * eps21_3 + eps20_4 * eps21_1 - eps21_4 * eps20_1;
  const T erel21_2 = eps20_1 * eps21_3 - eps20_3 * eps21_1 + eps20_4 * eps21_2 - eps21_4 * eps20_2;
  const T erel21_3 = eps20_2 * eps21_1 - eps20_1 * eps21_2 + eps20_4 * eps21_3 - eps21_4 * eps20_3;
  // eps4rel21 = e20 . e21 + eps4_20 eps4_21
  const T eps4rel21 = eps20_1 * eps21_1 + eps20_2 * eps21_2 + eps20_3 * eps21_3 + eps20_4 * eps21_4;
  // C21^T = 1 + 2 erel21~ (eps4rel21 + erel21~): C takes components in the lower body to those in the body
  const T t21_1 = T(2) * erel21_2;
  const T t21_2 = t21_1 * erel21_2;
  const T t21_3 = T(2) * erel21_3;
  const T t21_4 = t21_3 * erel21_3;
  const T C21_11 = T(1) - t21_2 - t21_4;
  const T t21_5 = T(2) * erel21_1;
  const T t21_6 = t21_5 * erel21_2;
  const T t21_7 = t21_3 * eps4rel21;
  const T C21_12 = t21_6 + t21_7;
  const T t21_8 = t21_5 * erel21_3;
  const T t21_9 = t21_1 * eps4rel21;
  const T C21_13 = t21_8 - t21_9;
  const T C21_21 = t21_6 - t21_7;
  const T t21_10 = T(1) - t21_5 * erel21_1;
  const T C21_22 = t21_10 - t21_4;
  const T t21_11 = t21_1 * erel21_3;
  const T t21_12 = t21_5 * eps4rel21;
  const T C21_23 = t21_11 + t21_12;
  const T C21_31 = t21_8 + t21_9;
  const T C21_32 = t21_11 - t21_12;
  const T C21_33 = t21_10 - t21_2;
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
  // Pddot21 = C21 (U20 q21 + Pddot20): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t21_19 = Pddot20_1 + U20_12 * T(1.05) - minus_U20_11 * T(0.3) + U20_13 * T(0.1);
  const T t21_20 = Pddot20_2 + U20_21 * T(0.3) - minus_U20_22 * T(1.05) + U20_23 * T(0.1);
  const T t21_21 = Pddot20_3 + U20_31 * T(0.3) + U20_32 * T(1.05) - minus_U20_33 * T(0.1);
  const T Pddot21_1 = C21_11 * t21_19 + C21_12 * t21_20 + C21_13 * t21_21;
  const T Pddot21_2 = C21_21 * t21_19 + C21_22 * t21_20 + C21_23 * t21_21;
  const T Pddot21_3 = C21_31 * t21_19 + C21_32 * t21_20 + C21_33 * t21_21;
  // N20 = C21^T M_torque_21_ + h_all_20~ Pddot20 + axial(U20 (tr(J_all_20)/2 - J_all_20)) - M_torque_20_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N20_1 = C21_11 * u.tau_21_1 - u.tau_20_1 + C21_21 * u.tau_21_2 + C21_31 * u.tau_21_3 + T(46.59) * Pddot20_3
      - T(4.53) * Pddot20_2 + T(48.499500000000005) * U20_32 - T(0.6555000000000001) * U20_23 + T(4.641) *
      (minus_U20_22 - minus_U20_33) + T(13.842) * U20_31 - T(1.32) * U20_21;
  const T N20_2 = C21_12 * u.tau_21_1 - u.tau_20_2 + C21_22 * u.tau_21_2 + C21_32 * u.tau_21_3 + T(4.53) * Pddot20_1 -
      T(13.44) * Pddot20_3 + T(0.6555000000000001) * U20_13 - T(4.122) * U20_31 + T(1.32) * (minus_U20_33 -
      minus_U20_11) + T(4.641) * U20_12 - T(13.842) * U20_32;
  const T N20_3 = C21_13 * u.tau_21_1 - u.tau_20_3 + C21_23 * u.tau_21_2 + C21_33 * u.tau_21_3 + T(13.44) * Pddot20_2
      - T(46.59) * Pddot20_1 + T(4.122) * U20_21 - T(48.499500000000005) * U20_12 + T(13.842) * (minus_U20_11 -
      minus_U20_22) + T(1.32) * U20_23 - T(4.641) * U20_13;
  // G21 = U21 h_all_21: inertia less applied force, body axes [N]
  const T G21_1 = U21_12 * T(45.39) - minus_U21_11 * T(12.52) + U21_13 * T(4.2250000000000005);
  const T G21_2 = U21_21 * T(12.52) - minus_U21_22 * T(45.39) + U21_23 * T(4.2250000000000005);
  const T G21_3 = U21_31 * T(12.52) + U21_32 * T(45.39) - minus_U21_33 * T(4.2250000000000005);

  // ---- body 22 (body_22) on body 21
  const T eps22_1 = x[84], eps22_2 = x[85], eps22_3 = x[86], eps22_4 = x[87];
  const T omega22_1 = y[63], omega22_2 = y[64], omega22_3 = y[65];
  const T omegadot22_1 = ydot[63], omegadot22_2 = ydot[64], omegadot22_3 = ydot[65];
  // erel22 = -e21~ e22 + eps4_21 e22 - eps4_22 e21: Euler parameters relative to the lower body
  const T erel22_1 = eps21_3 * eps22_2 - eps21_2 * eps22_3 + eps21_4 * eps22_1 - eps22_4 * eps21_1;
  const T erel22_2 = eps21_1 * eps22_3 - eps21_3 * eps22_1 + eps21_4 * eps22_2 - eps22_4 * eps21_2;
  const T erel22_3 = eps21_2 * eps22_1 - eps21_1 * eps22_2 + eps21_4 * eps22_3 - eps22_4 * eps21_3;
  // eps4rel22 = e21 . e22 + eps4_21 eps4_22
  const T eps4rel22 = eps21_1 * eps22_1 + eps21_2 * eps22_2 + eps21_3 * eps22_3 + eps21_4 * eps22_4;
  // C22^T = 1 + 2 erel22~ (eps4rel22 + erel22~): C takes components in the lower body to those in the body
  const T t22_1 = T(2) * erel22_2;
  const T t22_2 = t22_1 * erel22_2;
  const T t22_3 = T(2) * erel22_3;
  const T t22_4 = t22_3 * erel22_3;
  const T C22_11 = T(1) - t22_2 - t22_4;
  const T t22_5 = T(2) * erel22_1;
  const T t22_6 = t22_5 * erel22_2;
  const T t22_7 = t22_3 * eps4rel22;
  const T C22_12 = t22_6 + t22_7;
  const T t22_8 = t22_5 * erel22_3;
  const T t22_9 = t22_1 * eps4rel22;
  const T C22_13 = t22_8 - t22_9;
  const T C22_21 = t22_6 - t22_7;
  const T t22_10 = T(1) - t22_5 * erel22_1;
  const T C22_22 = t22_10 - t22_4;
  const T t22_11 = t22_1 * erel22_3;
  const T t22_12 = t22_5 * eps4rel22;
  const T C22_23 = t22_11 + t22_12;
  const T C22_31 = t22_8 + t22_9;
  const T C22_32 = t22_11 - t22_12;
  const T C22_33 = t22_10 - t22_2;
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
  // Pddot22 = C22 (U21 q22 + Pddot21): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t22_19 = Pddot21_1 + U21_12 * T(1.1) - minus_U21_11 * T(0.3) + U21_13 * T(0.1);
  const T t22_20 = Pddot21_2 + U21_21 * T(0.3) - minus_U21_22 * T(1.1) + U21_23 * T(0.1);
  const T t22_21 = Pddot21_3 + U21_31 * T(0.3) + U21_32 * T(1.1) - minus_U21_33 * T(0.1);
  const T Pddot22_1 = C22_11 * t22_19 + C22_12 * t22_20 + C22_13 * t22_21;
  const T Pddot22_2 = C22_21 * t22_19 + C22_22 * t22_20 + C22_23 * t22_21;
  const T Pddot22_3 = C22_31 * t22_19 + C22_32 * t22_20 + C22_33 * t22_21;
  // N21 = C22^T M_torque_22_ + h_all_21~ Pddot21 + axial(U21 (tr(J_all_21)/2 - J_all_21)) - M_torque_21_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N21_1 = C22_11 * u.tau_22_1 - u.tau_21_1 + C22_21 * u.tau_22_2 + C22_31 * u.tau_22_3 + T(45.39) * Pddot21_3
      - T(4.2250000000000005) * Pddot21_2 + T(49.464000000000006) * U21_32 - T(0.63175) * U21_23 + T(4.5204) *
      (minus_U21_22 - minus_U21_33) + T(13.477500000000001) * U21_31 - T(1.2272) * U21_21;
  const T N21_2 = C22_12 * u.tau_22_1 - u.tau_21_2 + C22_22 * u.tau_22_2 + C22_32 * u.tau_22_3 + T(4.2250000000000005)
      * Pddot21_1 - T(12.52) * Pddot21_3 + T(0.63175) * U21_13 - T(3.8489999999999998) * U21_31 + T(1.2272) *
      (minus_U21_33 - minus_U21_11) + T(4.5204) * U21_12 - T(13.477500000000001) * U21_32;
  const T N21_3 = C22_13 * u.tau_22_1 - u.tau_21_3 + C22_23 * u.tau_22_2 + C22_33 * u.tau_22_3 + T(12.52) * Pddot21_2
      - T(45.39) * Pddot21_1 + T(3.8489999999999998) * U21_21 - T(49.464000000000006) * U21_12 + T(13.477500000000001)
      * (minus_U21_11 - minus_U21_22) + T(1.2272) * U21_23 - T(4.5204) * U21_13;
  // G22 = U22 h_all_22: inertia less applied force, body axes [N]
  const T G22_1 = U22_12 * T(43.76499999999999) - minus_U22_11 * T(11.57) + U22_13 * T(3.91);
  const T G22_2 = U22_21 * T(11.57) - minus_U22_22 * T(43.76499999999999) + U22_23 * T(3.91);
  const T G22_3 = U22_31 * T(11.57) + U22_32 * T(43.76499999999999) - minus_U22_33 * T(3.91);

  // ---- body 23 (body_23) on body 22
  const T eps23_1 = x[88], eps23_2 = x[89], eps23_3 = x[90], eps23_4 = x[91];
  const T omega23_1 = y[66], omega23_2 = y[67], omega23_3 = y[68];
  const T omegadot23_1 = ydot[66], omegadot23_2 = ydot[67], omegadot23_3 = ydot[68];
  // erel23 = -e22~ e23 + eps4_22 e23 - eps4_23 e22: Euler parameters relative to the lower body
  const T erel23_1 = eps22_3 * eps23_2 - eps22_2 * eps23_3 + eps22_4 * eps23_1 - eps23_4 * eps22_1;
  const T erel23_2 = eps22_1 * eps23_3 - eps22_3 * eps23_1 + eps22_4 * eps23_2 - eps23_4 * eps22_2;
  const T erel23_3 = eps22_2 * eps23_1 - eps22_1 * eps23_2 + eps22_4 * eps23_3 - eps23_4 * eps22_3;
  // eps4rel23 = e22 . e23 + eps4_22 eps4_23
  const T eps4rel23 = eps22_1 * eps23_1 + eps22_2 * eps23_2 + eps22_3 * eps23_3 + eps22_4 * eps23_4;
  // C23^T = 1 + 2 erel23~ (eps4rel23 + erel23~): C takes components in the lower body to those in the body
  const T t23_1 = T(2) * erel23_2;
  const T t23_2 = t23_1 * erel23_2;
  const T t23_3 = T(2) * erel23_3;
  const T t23_4 = t23_3 * erel23_3;
  const T C23_11 = T(1) - t23_2 - t23_4;
  const T t23_5 = T(2) * erel23_1;
  const T t23_6 = t23_5 * erel23_2;
  const T t23_7 = t23_3 * eps4rel23;
  const T C23_12 = t23_6 + t23_7;
  const T t23_8 = t23_5 * erel23_3;
  const T t23_9 = t23_1 * eps4rel23;
  const T C23_13 = t23_8 - t23_9;
  const T C23_21 = t23_6 - t23_7;
  const T t23_10 = T(1) - t23_5 * erel23_1;
  const T C23_22 = t23_10 - t23_4;
  const T t23_11 = t23_1 * erel23_3;
  const T t23_12 = t23_5 * eps4rel23;
  const T C23_23 = t23_11 + t23_12;
  const T C23_31 = t23_8 + t23_9;
  const T C23_32 = t23_11 - t23_12;
  const T C23_33 = t23_10 - t23_2;
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
  // Pddot23 = C23 (U22 q23 + Pddot22): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t23_19 = Pddot22_1 + U22_12 * T(1.15) - minus_U22_11 * T(0.3) + U22_13 * T(0.1);
  const T t23_20 = Pddot22_2 + U22_21 * T(0.3) - minus_U22_22 * T(1.15) + U22_23 * T(0.1);
  const T t23_21 = Pddot22_3 + U22_31 * T(0.3) + U22_32 * T(1.15) - minus_U22_33 * T(0.1);
  const T Pddot23_1 = C23_11 * t23_19 + C23_12 * t23_20 + C23_13 * t23_21;
  const T Pddot23_2 = C23_21 * t23_19 + C23_22 * t23_20 + C23_23 * t23_21;
  const T Pddot23_3 = C23_31 * t23_19 + C23_32 * t23_20 + C23_33 * t23_21;
  // N22 = C23^T M_torque_23_ + h_all_22~ Pddot22 + axial(U22 (tr(J_all_22)/2 - J_all_22)) - M_torque_22_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N22_1 = C23_11 * u.tau_23_1 - u.tau_22_1 + C23_21 * u.tau_23_2 + C23_31 * u.tau_23_3 + T(43.76499999999999)
      * Pddot22_3 - T(3.91) * Pddot22_2 + T(49.81774999999999) * U22_32 - T(0.6070000000000001) * U22_23 +
      T(4.3572999999999995) * (minus_U22_22 - minus_U22_33) + T(12.985499999999998) * U22_31 - T(1.1314) * U22_21;
  const T N22_2 = C23_12 * u.tau_23_1 - u.tau_22_2 + C23_22 * u.tau_23_2 + C23_32 * u.tau_23_3 + T(3.91) * Pddot22_1 -
      T(11.57) * Pddot22_3 + T(0.6070000000000001) * U22_13 - T(3.5669999999999997) * U22_31 + T(1.1314) *
      (minus_U22_33 - minus_U22_11) + T(4.3572999999999995) * U22_12 - T(12.985499999999998) * U22_32;
  const T N22_3 = C23_13 * u.tau_23_1 - u.tau_22_3 + C23_23 * u.tau_23_2 + C23_33 * u.tau_23_3 + T(11.57) * Pddot22_2
      - T(43.76499999999999) * Pddot22_1 + T(3.5669999999999997) * U22_21 - T(49.81774999999999) * U22_12 +
      T(12.985499999999998) * (minus_U22_11 - minus_U22_22) + T(1.1314) * U22_23 - T(4.3572999999999995) * U22_13;
  // G23 = U23 h_all_23: inertia less applied force, body axes [N]
  const T G23_1 = U23_12 * T(41.699999999999996) - minus_U23_11 * T(10.59) + U23_13 * T(3.585);
  const T G23_2 = U23_21 * T(10.59) - minus_U23_22 * T(41.699999999999996) + U23_23 * T(3.585);
  const T G23_3 = U23_31 * T(10.59) + U23_32 * T(41.699999999999996) - minus_U23_33 * T(3.585);

  // ---- body 24 (body_24) on body 23
  const T eps24_1 = x[92], eps24_2 = x[93], eps24_3 = x[94], eps24_4 = x[95];
  const T omega24_1 = y[69], omega24_2 = y[70], omega24_3 = y[71];
  const T omegadot24_1 = ydot[69], omegadot24_2 = ydot[70], omegadot24_3 = ydot[71];
  // erel24 = -e23~ e24 + eps4_23 e24 - eps4_24 e23: Euler parameters relative to the lower body
  const T erel24_1 = eps23_3 * eps24_2 - eps23_2 * eps24_3 + eps23_4 * eps24_1 - eps24_4 * eps23_1;
  const T erel24_2 = eps23_1 * eps24_3 - eps23_3 * eps24_1 + eps23_4 * eps24_2 - eps24_4 * eps23_2;
  const T erel24_3 = eps23_2 * eps24_1 - eps23_1 * eps24_2 + eps23_4 * eps24_3 - eps24_4 * eps23_3;
  // eps4rel24 = e23 . e24 + eps4_23 eps4_24
  const T eps4rel24 = eps23_1 * eps24_1 + eps23_2 * eps24_2 + eps23_3 * eps24_3 + eps23_4 * eps24_4;
  // C24^T = 1 + 2 erel24~ (eps4rel24 + erel24~): C takes components in the lower body to those in the body
  const T t24_1 = T(2) * erel24_2;
  const T t24_2 = t24_1 * erel24_2;
  const T t24_3 = T(2) * erel24_3;
  const T t24_4 = t24_3 * erel24_3;
  const T C24_11 = T(1) - t24_2 - t24_4;
  const T t24_5 = T(2) * erel24_1;
  const T t24_6 = t24_5 * erel24_2;
  const T t24_7 = t24_3 * eps4rel24;
  const T C24_12 = t24_6 + t24_7;
  const T t24_8 = t24_5 * erel24_3;
  const T t24_9 = t24_1 * eps4rel24;
  const T C24_13 = t24_8 - t24_9;
  const T C24_21 = t24_6 - t24_7;
  const T t24_10 = T(1) - t24_5 * erel24_1;
  const T C24_22 = t24_10 - t24_4;
  const T t24_11 = t24_1 * erel24_3;
  const T t24_12 = t24_5 * eps4rel24;
  const T C24_23 = t24_11 + t24_12;
  const T C24_31 = t24_8 + t24_9;
  const T C24_32 = t24_11 - t24_12;
  const T C24_33 = t24_10 - t24_2;
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
  // Pddot24 = C24 (U23 q24 + Pddot23): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t24_19 = Pddot23_1 + U23_12 * T(1.2) - minus_U23_11 * T(0.3) + U23_13 * T(0.1);
  const T t24_20 = Pddot23_2 + U23_21 * T(0.3) - minus_U23_22 * T(1.2) + U23_23 * T(0.1);
  const T t24_21 = Pddot23_3 + U23_31 * T(0.3) + U23_32 * T(1.2) - minus_U23_33 * T(0.1);
  const T Pddot24_1 = C24_11 * t24_19 + C24_12 * t24_20 + C24_13 * t24_21;
  const T Pddot24_2 = C24_21 * t24_19 + C24_22 * t24_20 + C24_23 * t24_21;
  const T Pddot24_3 = C24_31 * t24_19 + C24_32 * t24_20 + C24_33 * t24_21;
  // N23 = C24^T M_torque_24_ + h_all_23~ Pddot23 + axial(U23 (tr(J_all_23)/2 - J_all_23)) - M_torque_23_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N23_1 = C24_11 * u.tau_24_1 - u.tau_23_1 + C24_21 * u.tau_24_2 + C24_31 * u.tau_24_3 + T(41.699999999999996)
      * Pddot23_3 - T(3.585) * Pddot23_2 + T(49.479) * U23_32 - T(0.58125) * U23_23 + T(4.1502) * (minus_U23_22 -
      minus_U23_33) + T(12.3615) * U23_31 - T(1.0326) * U23_21;
  const T N23_2 = C24_12 * u.tau_24_1 - u.tau_23_2 + C24_22 * u.tau_24_2 + C24_32 * u.tau_24_3 + T(3.585) * Pddot23_1
      - T(10.59) * Pddot23_3 + T(0.58125) * U23_13 - T(3.276) * U23_31 + T(1.0326) * (minus_U23_33 - minus_U23_11) +
      T(4.1502) * U23_12 - T(12.3615) * U23_32;
  const T N23_3 = C24_13 * u.tau_24_1 - u.tau_23_3 + C24_23 * u.tau_24_2 + C24_33 * u.tau_24_3 + T(10.59) * Pddot23_2
      - T(41.699999999999996) * Pddot23_1 + T(3.276) * U23_21 - T(49.479) * U23_12 + T(12.3615) * (minus_U23_11 -
      minus_U23_22) + T(1.0326) * U23_23 - T(4.1502) * U23_13;
  // G24 = U24 h_all_24: inertia less applied force, body axes [N]
  const T G24_1 = U24_12 * T(39.18) - minus_U24_11 * T(9.58) + U24_13 * T(3.25);
  const T G24_2 = U24_21 * T(9.58) - minus_U24_22 * T(39.18) + U24_23 * T(3.25);
  const T G24_3 = U24_31 * T(9.58) + U24_32 * T(39.18) - minus_U24_33 * T(3.25);

  // ---- body 25 (body_25) on body 24
  const T eps25_1 = x[96], eps25_2 = x[97], eps25_3 = x[98], eps25_4 = x[99];
  const T omega25_1 = y[72], omega25_2 = y[73], omega25_3 = y[74];
  const T omegadot25_1 = ydot[72], omegadot25_2 = ydot[73], omegadot25_3 = ydot[74];
  // erel25 = -e24~ e25 + eps4_24 e25 - eps4_25 e24: Euler parameters relative to the lower body
  const T erel25_1 = eps24_3 * eps25_2 - eps24_2 * eps25_3 + eps24_4 * eps25_1 - eps25_4 * eps24_1;
  const T erel25_2 = eps24_1 * eps25_3 - eps24_3 * eps25_1 + eps24_4 * eps25_2 - eps25_4 * eps24_2;
  const T erel25_3 = eps24_2 * eps25_1 - eps24_1 * eps25_2 + eps24_4 * eps25_3 - eps25_4 * eps24_3;
  // eps4rel25 = e24 . e25 + eps4_24 eps4_25
  const T eps4rel25 = eps24_1 * eps25_1 + eps24_2 * eps25_2 + eps24_3 * eps25_3 + eps24_4 * eps25_4;
  // C25^T = 1 + 2 erel25~ (eps4rel25 + erel25~): C takes components in the lower body to those in the body
  const T t25_1 = T(2) * erel25_2;
  const T t25_2 = t25_1 * erel25_2;
  const T t25_3 = T(2) * erel25_3;
  const T t25_4 = t25_3 * erel25_3;
  const T C25_11 = T(1) - t25_2 - t25_4;
  const T t25_5 = T(2) * erel25_1;
  const T t25_6 = t25_5 * erel25_2;
  const T t25_7 = t25_3 * eps4rel25;
  const T C25_12 = t25_6 + t25_7;
  const T t25_8 = t25_5 * erel25_3;
  const T t25_9 = t25_1 * eps4rel25;
  const T C25_13 = t25_8 - t25_9;
  const T C25_21 = t25_6 - t25_7;
  const T t25_10 = T(1) - t25_5 * erel25_1;
  const T C25_22 = t25_10 - t25_4;
  const T t25_11 = t25_1 * erel25_3;
  const T t25_12 = t25_5 * eps4rel25;
  const T C25_23 = t25_11 + t25_12;
  const T C25_31 = t25_8 + t25_9;
  const T C25_32 = t25_11 - t25_12;
  const T C25_33 = t25_10 - t25_2;
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
  // Pddot25 = C25 (U24 q25 + Pddot24): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t25_19 = Pddot24_1 + U24_12 * T(1.25) - minus_U24_11 * T(0.3) + U24_13 * T(0.1);
  const T t25_20 = Pddot24_2 + U24_21 * T(0.3) - minus_U24_22 * T(1.25) + U24_23 * T(0.1);
  const T t25_21 = Pddot24_3 + U24_31 * T(0.3) + U24_32 * T(1.25) - minus_U24_33 * T(0.1);
  const T Pddot25_1 = C25_11 * t25_19 + C25_12 * t25_20 + C25_13 * t25_21;
  const T Pddot25_2 = C25_21 * t25_19 + C25_22 * t25_20 + C25_23 * t25_21;
  const T Pddot25_3 = C25_31 * t25_19 + C25_32 * t25_20 + C25_33 * t25_21;
  // N24 = C25^T M_torque_25_ + h_all_24~ Pddot24 + axial(U24 (tr(J_all_24)/2 - J_all_24)) - M_torque_24_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N24_1 = C25_11 * u.tau_25_1 - u.tau_24_1 + C25_21 * u.tau_25_2 + C25_31 * u.tau_25_3 + T(39.18) * Pddot24_3
      - T(3.25) * Pddot24_2 + T(48.363) * U24_32 - T(0.5545) * U24_23 + T(3.8976) * (minus_U24_22 - minus_U24_33) +
      T(11.600999999999999) * U24_31 - T(0.9308) * U24_21;
  const T N24_2 = C25_12 * u.tau_25_1 - u.tau_24_2 + C25_22 * u.tau_25_2 + C25_32 * u.tau_25_3 + T(3.25) * Pddot24_1 -
      T(9.58) * Pddot24_3 + T(0.5545) * U24_13 - T(2.976) * U24_31 + T(0.9308) * (minus_U24_33 - minus_U24_11) +
      T(3.8976) * U24_12 - T(11.600999999999999) * U24_32;
  const T N24_3 = C25_13 * u.tau_25_1 - u.tau_24_3 + C25_23 * u.tau_25_2 + C25_33 * u.tau_25_3 + T(9.58) * Pddot24_2 -
      T(39.18) * Pddot24_1 + T(2.976) * U24_21 - T(48.363) * U24_12 + T(11.600999999999999) * (minus_U24_11 -
      minus_U24_22) + T(0.9308) * U24_23 - T(3.8976) * U24_13;
  // G25 = U25 h_all_25: inertia less applied force, body axes [N]
  const T G25_1 = U25_12 * T(36.19) - minus_U25_11 * T(8.54) + U25_13 * T(2.9050000000000002);
  const T G25_2 = U25_21 * T(8.54) - minus_U25_22 * T(36.19) + U25_23 * T(2.9050000000000002);
  const T G25_3 = U25_31 * T(8.54) + U25_32 * T(36.19) - minus_U25_33 * T(2.9050000000000002);

  // ---- body 26 (body_26) on body 25
  const T eps26_1 = x[100], eps26_2 = x[101], eps26_3 = x[102], eps26_4 = x[103];
  const T omega26_1 = y[75], omega26_2 = y[76], omega26_3 = y[77];
  const T omegadot26_1 = ydot[75], omegadot26_2 = ydot[76], omegadot26_3 = ydot[77];
  // erel26 = -e25~ e26 + eps4_25 e26 - eps4_26 e25: Euler parameters relative to the lower body
  const T erel26_1 = eps25_3 * eps26_2 - eps25_2 * eps26_3 + eps25_4 * eps26_1 - eps26_4 * eps25_1;
  const T erel26_2 = eps25_1 * eps26_3 - eps25_3 * eps26_1 + eps25_4 * eps26_2 - eps26_4 * eps25_2;
  const T erel26_3 = eps25_2 * eps26_1 - eps25_1 * eps26_2 + eps25_4 * eps26_3 - eps26_4 * eps25_3;
  // eps4rel26 = e25 . e26 + eps4_25 eps4_26
  const T eps4rel26 = eps25_1 * eps26_1 + eps25_2 * eps26_2 + eps25_3 * eps26_3 + eps25_4 * eps26_4;
  // C26^T = 1 + 2 erel26~ (eps4rel26 + erel26~): C takes components in the lower body to those in the body
  const T t26_1 = T(2) * erel26_2;
  const T t26_2 = t26_1 * erel26_2;
  const T t26_3 = T(2) * erel26_3;
  const T t26_4 = t26_3 * erel26_3;
  const T C26_11 = T(1) - t26_2 - t26_4;
  const T t26_5 = T(2) * erel26_1;
  const T t26_6 = t26_5 * erel26_2;
  const T t26_7 = t26_3 * eps4rel26;
  const T C26_12 = t26_6 + t26_7;
  const T t26_8 = t26_5 * erel26_3;
  const T t26_9 = t26_1 * eps4rel26;
  const T C26_13 = t26_8 - t26_9;
  const T C26_21 = t26_6 - t26_7;
  const T t26_10 = T(1) - t26_5 * erel26_1;
  const T C26_22 = t26_10 - t26_4;
  const T t26_11 = t26_1 * erel26_3;
  const T t26_12 = t26_5 * eps4rel26;
  const T C26_23 = t26_11 + t26_12;
  const T C26_31 = t26_8 + t26_9;
  const T C26_32 = t26_11 - t26_12;
  const T C26_33 = t26_10 - t26_2;
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
  // Pddot26 = C26 (U25 q26 + Pddot25): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t26_19 = Pddot25_1 + U25_12 * T(1.3) - minus_U25_11 * T(0.3) + U25_13 * T(0.1);
  const T t26_20 = Pddot25_2 + U25_21 * T(0.3) - minus_U25_22 * T(1.3) + U25_23 * T(0.1);
  const T t26_21 = Pddot25_3 + U25_31 * T(0.3) + U25_32 * T(1.3) - minus_U25_33 * T(0.1);
  const T Pddot26_1 = C26_11 * t26_19 + C26_12 * t26_20 + C26_13 * t26_21;
  const T Pddot26_2 = C26_21 * t26_19 + C26_22 * t26_20 + C26_23 * t26_21;
  const T Pddot26_3 = C26_31 * t26_19 + C26_32 * t26_20 + C26_33 * t26_21;
  // N25 = C26^T M_torque_26_ + h_all_25~ Pddot25 + axial(U25 (tr(J_all_25)/2 - J_all_25)) - M_torque_25_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N25_1 = C26_11 * u.tau_26_1 - u.tau_25_1 + C26_21 * u.tau_26_2 + C26_31 * u.tau_26_3 + T(36.19) * Pddot25_3
      - T(2.9050000000000002) * Pddot25_2 + T(46.382000000000005) * U25_32 - T(0.52675) * U25_23 +
      T(3.5980000000000003) * (minus_U25_22 - minus_U25_33) + T(10.6995) * U25_31 - T(0.826) * U25_21;
  const T N25_2 = C26_12 * u.tau_26_1 - u.tau_25_2 + C26_22 * u.tau_26_2 + C26_32 * u.tau_26_3 + T(2.9050000000000002)
      * Pddot25_1 - T(8.54) * Pddot25_3 + T(0.52675) * U25_13 - T(2.667) * U25_31 + T(0.826) * (minus_U25_33 -
      minus_U25_11) + T(3.5980000000000003) * U25_12 - T(10.6995) * U25_32;
  const T N25_3 = C26_13 * u.tau_26_1 - u.tau_25_3 + C26_23 * u.tau_26_2 + C26_33 * u.tau_26_3 + T(8.54) * Pddot25_2 -
      T(36.19) * Pddot25_1 + T(2.667) * U25_21 - T(46.382000000000005) * U25_12 + T(10.6995) * (minus_U25_11 -
      minus_U25_22) + T(0.826) * U25_23 - T(3.5980000000000003) * U25_13;
  // G26 = U26 h_all_26: inertia less applied force, body axes [N]
  const T G26_1 = U26_12 * T(32.715) - minus_U26_11 * T(7.47) + U26_13 * T(2.5500000000000003);
  const T G26_2 = U26_21 * T(7.47) - minus_U26_22 * T(32.715) + U26_23 * T(2.5500000000000003);
  const T G26_3 = U26_31 * T(7.47) + U26_32 * T(32.715) - minus_U26_33 * T(2.5500000000000003);

  // ---- body 27 (body_27) on body 26
  const T eps27_1 = x[104], eps27_2 = x[105], eps27_3 = x[106], eps27_4 = x[107];
  const T omega27_1 = y[78], omega27_2 = y[79], omega27_3 = y[80];
  const T omegadot27_1 = ydot[78], omegadot27_2 = ydot[79], omegadot27_3 = ydot[80];
  // erel27 = -e26~ e27 + eps4_26 e27 - eps4_27 e26: Euler parameters relative to the lower body
  const T erel27_1 = eps26_3 * eps27_2 - eps26_2 * eps27_3 + eps26_4 * eps27_1 - eps27_4 * eps26_1;
  const T erel27_2 = eps26_1 * eps27_3 - eps26_3 * eps27_1 + eps26_4 * eps27_2 - eps27_4 * eps26_2;
  const T erel27_3 = eps26_2 * eps27_1 - eps26_1 * eps27_2 + eps26_4 * eps27_3 - eps27_4 * eps26_3;
  // eps4rel27 = e26 . e27 + eps4_26 eps4_27
  const T eps4rel27 = eps26_1 * eps27_1 + eps26_2 * eps27_2 + eps26_3 * eps27_3 + eps26_4 * eps27_4;
  // C27^T = 1 + 2 erel27~ (eps4rel27 + erel27~): C takes components in the lower body to those in the body
  const T t27_1 = T(2) * erel27_2;
  const T t27_2 = t27_1 * erel27_2;
  const T t27_3 = T(2) * erel27_3;
  const T t27_4 = t27_3 * erel27_3;
  const T C27_11 = T(1) - t27_2 - t27_4;
  const T t27_5 = T(2) * erel27_1;
  const T t27_6 = t27_5 * erel27_2;
  const T t27_7 = t27_3 * eps4rel27;
  const T C27_12 = t27_6 + t27_7;
  const T t27_8 = t27_5 * erel27_3;
  const T t27_9 = t27_1 * eps4rel27;
  const T C27_13 = t27_8 - t27_9;
  const T C27_21 = t27_6 - t27_7;
  const T t27_10 = T(1) - t27_5 * erel27_1;
  const T C27_22 = t27_10 - t27_4;
  const T t27_11 = t27_1 * erel27_3;
  const T t27_12 = t27_5 * eps4rel27;
  const T C27_23 = t27_11 + t27_12;
  const T C27_31 = t27_8 + t27_9;
  const T C27_32 = t27_11 - t27_12;
  const T C27_33 = t27_10 - t27_2;
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
  // Pddot27 = C27 (U26 q27 + Pddot26): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t27_19 = Pddot26_1 + U26_12 * T(1.35) - minus_U26_11 * T(0.3) + U26_13 * T(0.1);
  const T t27_20 = Pddot26_2 + U26_21 * T(0.3) - minus_U26_22 * T(1.35) + U26_23 * T(0.1);
  const T t27_21 = Pddot26_3 + U26_31 * T(0.3) + U26_32 * T(1.35) - minus_U26_33 * T(0.1);
  const T Pddot27_1 = C27_11 * t27_19 + C27_12 * t27_20 + C27_13 * t27_21;
  const T Pddot27_2 = C27_21 * t27_19 + C27_22 * t27_20 + C27_23 * t27_21;
  const T Pddot27_3 = C27_31 * t27_19 + C27_32 * t27_20 + C27_33 * t27_21;
  // N26 = C27^T M_torque_27_ + h_all_26~ Pddot26 + axial(U26 (tr(J_all_26)/2 - J_all_26)) - M_torque_26_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N26_1 = C27_11 * u.tau_27_1 - u.tau_26_1 + C27_21 * u.tau_27_2 + C27_31 * u.tau_27_3 + T(32.715) * Pddot26_3
      - T(2.5500000000000003) * Pddot26_2 + T(43.44525000000001) * U26_32 - T(0.49800000000000005) * U26_23 +
      T(3.2499000000000002) * (minus_U26_22 - minus_U26_33) + T(9.6525) * U26_31 - T(0.7182000000000001) * U26_21;
  const T N26_2 = C27_12 * u.tau_27_1 - u.tau_26_2 + C27_22 * u.tau_27_2 + C27_32 * u.tau_27_3 + T(2.5500000000000003)
      * Pddot26_1 - T(7.47) * Pddot26_3 + T(0.49800000000000005) * U26_13 - T(2.3489999999999998) * U26_31 +
      T(0.7182000000000001) * (minus_U26_33 - minus_U26_11) + T(3.2499000000000002) * U26_12 - T(9.6525) * U26_32;
  const T N26_3 = C27_13 * u.tau_27_1 - u.tau_26_3 + C27_23 * u.tau_27_2 + C27_33 * u.tau_27_3 + T(7.47) * Pddot26_2 -
      T(32.715) * Pddot26_1 + T(2.3489999999999998) * U26_21 - T(43.44525000000001) * U26_12 + T(9.6525) *
      (minus_U26_11 - minus_U26_22) + T(0.7182000000000001) * U26_23 - T(3.2499000000000002) * U26_13;
  // G27 = U27 h_all_27: inertia less applied force, body axes [N]
  const T G27_1 = U27_12 * T(28.74) - minus_U27_11 * T(6.37) + U27_13 * T(2.185);
  const T G27_2 = U27_21 * T(6.37) - minus_U27_22 * T(28.74) + U27_23 * T(2.185);
  const T G27_3 = U27_31 * T(6.37) + U27_32 * T(28.74) - minus_U27_33 * T(2.185);

  // ---- body 28 (body_28) on body 27
  const T eps28_1 = x[108], eps28_2 = x[109], eps28_3 = x[110], eps28_4 = x[111];
  const T omega28_1 = y[81], omega28_2 = y[82], omega28_3 = y[83];
  const T omegadot28_1 = ydot[81], omegadot28_2 = ydot[82], omegadot28_3 = ydot[83];
  // erel28 = -e27~ e28 + eps4_27 e28 - eps4_28 e27: Euler parameters relative to the lower body
  const T erel28_1 = eps27_3 * eps28_2 - eps27_2 * eps28_3 + eps27_4 * eps28_1 - eps28_4 * eps27_1;
  const T erel28_2 = eps27_1 * eps28_3 - eps27_3 * eps28_1 + eps27_4 * eps28_2 - eps28_4 * eps27_2;
  const T erel28_3 = eps27_2 * eps28_1 - eps27_1 * eps28_2 + eps27_4 * eps28_3 - eps28_4 * eps27_3;
  // eps4rel28 = e27 . e28 + eps4_27 eps4_28
  const T eps4rel28 = eps27_1 * eps28_1 + eps27_2 * eps28_2 + eps27_3 * eps28_3 + eps27_4 * eps28_4;
  // C28^T = 1 + 2 erel28~ (eps4rel28 + erel28~): C takes components in the lower body to those in the body
  const T t28_1 = T(2) * erel28_2;
  const T t28_2 = t28_1 * erel28_2;
  const T t28_3 = T(2) * erel28_3;
  const T t28_4 = t28_3 * erel28_3;
  const T C28_11 = T(1) - t28_2 - t28_4;
  const T t28_5 = T(2) * erel28_1;
  const T t28_6 = t28_5 * erel28_2;
  const T t28_7 = t28_3 * eps4rel28;
  const T C28_12 = t28_6 + t28_7;
  const T t28_8 = t28_5 * erel28_3;
  const T t28_9 = t28_1 * eps4rel28;
  const T C28_13 = t28_8 - t28_9;
  const T C28_21 = t28_6 - t28_7;
  const T t28_10 = T(1) - t28_5 * erel28_1;
  const T C28_22 = t28_10 - t28_4;
  const T t28_11 = t28_1 * erel28_3;
  const T t28_12 = t28_5 * eps4rel28;
  const T C28_23 = t28_11 + t28_12;
  const T C28_31 = t28_8 + t28_9;
  const T C28_32 = t28_11 - t28_12;
  const T C28_33 = t28_10 - t28_2;
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
  // Pddot28 = C28 (U27 q28 + Pddot27): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t28_19 = Pddot27_1 + U27_12 * T(1.4) - minus_U27_11 * T(0.3) + U27_13 * T(0.1);
  const T t28_20 = Pddot27_2 + U27_21 * T(0.3) - minus_U27_22 * T(1.4) + U27_23 * T(0.1);
  const T t28_21 = Pddot27_3 + U27_31 * T(0.3) + U27_32 * T(1.4) - minus_U27_33 * T(0.1);
  const T Pddot28_1 = C28_11 * t28_19 + C28_12 * t28_20 + C28_13 * t28_21;
  const T Pddot28_2 = C28_21 * t28_19 + C28_22 * t28_20 + C28_23 * t28_21;
  const T Pddot28_3 = C28_31 * t28_19 + C28_32 * t28_20 + C28_33 * t28_21;
  // N27 = C28^T M_torque_28_ + h_all_27~ Pddot27 + axial(U27 (tr(J_all_27)/2 - J_all_27)) - M_torque_27_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N27_1 = C28_11 * u.tau_28_1 - u.tau_27_1 + C28_21 * u.tau_28_2 + C28_31 * u.tau_28_3 + T(28.74) * Pddot27_3
      - T(2.185) * Pddot27_2 + T(39.458999999999996) * U27_32 - T(0.46825) * U27_23 + T(2.8518) * (minus_U27_22 -
      minus_U27_33) + T(8.455499999999999) * U27_31 - T(0.6074) * U27_21;
  const T N27_2 = C28_12 * u.tau_28_1 - u.tau_27_2 + C28_22 * u.tau_28_2 + C28_32 * u.tau_28_3 + T(2.185) * Pddot27_1
      - T(6.37) * Pddot27_3 + T(0.46825) * U27_13 - T(2.022) * U27_31 + T(0.6074) * (minus_U27_33 - minus_U27_11) +
      T(2.8518) * U27_12 - T(8.455499999999999) * U27_32;
  const T N27_3 = C28_13 * u.tau_28_1 - u.tau_27_3 + C28_23 * u.tau_28_2 + C28_33 * u.tau_28_3 + T(6.37) * Pddot27_2 -
      T(28.74) * Pddot27_1 + T(2.022) * U27_21 - T(39.458999999999996) * U27_12 + T(8.455499999999999) * (minus_U27_11
      - minus_U27_22) + T(0.6074) * U27_23 - T(2.8518) * U27_13;
  // G28 = U28 h_all_28: inertia less applied force, body axes [N]
  const T G28_1 = U28_12 * T(24.25) - minus_U28_11 * T(5.239999999999999) + U28_13 * T(1.81);
  const T G28_2 = U28_21 * T(5.239999999999999) - minus_U28_22 * T(24.25) + U28_23 * T(1.81);
  const T G28_3 = U28_31 * T(5.239999999999999) + U28_32 * T(24.25) - minus_U28_33 * T(1.81);

  // ---- body 29 (body_29) on body 28
  const T eps29_1 = x[112], eps29_2 = x[113], eps29_3 = x[114], eps29_4 = x[115];
  const T omega29_1 = y[84], omega29_2 = y[85], omega29_3 = y[86];
  const T omegadot29_1 = ydot[84], omegadot29_2 = ydot[85], omegadot29_3 = ydot[86];
  // erel29 = -e28~ e29 + eps4_28 e29 - eps4_29 e28: Euler parameters relative to the lower body
  const T erel29_1 = eps28_3 * eps29_2 - eps28_2 * eps29_3 + eps28_4 * eps29_1 - eps29_4 * eps28_1;
  const T erel29_2 = eps28_1 * eps29_3 - eps28_3 * eps29_1 + eps28_4 * eps29_2 - eps29_4 * eps28_2;
  const T erel29_3 = eps28_2 * eps29_1 - eps28_1 * eps29_2 + eps28_4 * eps29_3 - eps29_4 * eps28_3;
  // eps4rel29 = e28 . e29 + eps4_28 eps4_29
  const T eps4rel29 = eps28_1 * eps29_1 + eps28_2 * eps29_2 + eps28_3 * eps29_3 + eps28_4 * eps29_4;
  // C29^T = 1 + 2 erel29~ (eps4rel29 + erel29~): C takes components in the lower body to those in the body
  const T t29_1 = T(2) * erel29_2;
  const T t29_2 = t29_1 * erel29_2;
  const T t29_3 = T(2) * erel29_3;
  const T t29_4 = t29_3 * erel29_3;
  const T C29_11 = T(1) - t29_2 - t29_4;
  const T t29_5 = T(2) * erel29_1;
  const T t29_6 = t29_5 * erel29_2;
  const T t29_7 = t29_3 * eps4rel29;
  const T C29_12 = t29_6 + t29_7;
  const T t29_8 = t29_5 * erel29_3;
  const T t29_9 = t29_1 * eps4rel29;
  const T C29_13 = t29_8 - t29_9;
  const T C29_21 = t29_6 - t29_7;
  const T t29_10 = T(1) - t29_5 * erel29_1;
  const T C29_22 = t29_10 - t29_4;
  const T t29_11 = t29_1 * erel29_3;
  const T t29_12 = t29_5 * eps4rel29;
  const T C29_23 = t29_11 + t29_12;
  const T C29_31 = t29_8 + t29_9;
  const T C29_32 = t29_11 - t29_12;
  const T C29_33 = t29_10 - t29_2;
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
  // Pddot29 = C29 (U28 q29 + Pddot28): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t29_19 = Pddot28_1 + U28_12 * T(1.45) - minus_U28_11 * T(0.3) + U28_13 * T(0.1);
  const T t29_20 = Pddot28_2 + U28_21 * T(0.3) - minus_U28_22 * T(1.45) + U28_23 * T(0.1);
  const T t29_21 = Pddot28_3 + U28_31 * T(0.3) + U28_32 * T(1.45) - minus_U28_33 * T(0.1);
  const T Pddot29_1 = C29_11 * t29_19 + C29_12 * t29_20 + C29_13 * t29_21;
  const T Pddot29_2 = C29_21 * t29_19 + C29_22 * t29_20 + C29_23 * t29_21;
  const T Pddot29_3 = C29_31 * t29_19 + C29_32 * t29_20 + C29_33 * t29_21;
  // N28 = C29^T M_torque_29_ + h_all_28~ Pddot28 + axial(U28 (tr(J_all_28)/2 - J_all_28)) - M_torque_28_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N28_1 = C29_11 * u.tau_29_1 - u.tau_28_1 + C29_21 * u.tau_29_2 + C29_31 * u.tau_29_3 + T(24.25) * Pddot28_3
      - T(1.81) * Pddot28_2 + T(34.326499999999996) * U28_32 - T(0.43750000000000006) * U28_23 + T(2.4022) *
      (minus_U28_22 - minus_U28_33) + T(7.103999999999999) * U28_31 - T(0.4936) * U28_21;
  const T N28_2 = C29_12 * u.tau_29_1 - u.tau_28_2 + C29_22 * u.tau_29_2 + C29_32 * u.tau_29_3 + T(1.81) * Pddot28_1 -
      T(5.239999999999999) * Pddot28_3 + T(0.43750000000000006) * U28_13 - T(1.686) * U28_31 + T(0.4936) *
      (minus_U28_33 - minus_U28_11) + T(2.4022) * U28_12 - T(7.103999999999999) * U28_32;
  const T N28_3 = C29_13 * u.tau_29_1 - u.tau_28_3 + C29_23 * u.tau_29_2 + C29_33 * u.tau_29_3 + T(5.239999999999999)
      * Pddot28_2 - T(24.25) * Pddot28_1 + T(1.686) * U28_21 - T(34.326499999999996) * U28_12 + T(7.103999999999999) *
      (minus_U28_11 - minus_U28_22) + T(0.4936) * U28_23 - T(2.4022) * U28_13;
  // G29 = U29 h_all_29: inertia less applied force, body axes [N]
  const T G29_1 = U29_12 * T(19.23) - minus_U29_11 * T(4.08) + U29_13 * T(1.425);
  const T G29_2 = U29_21 * T(4.08) - minus_U29_22 * T(19.23) + U29_23 * T(1.425);
  const T G29_3 = U29_31 * T(4.08) + U29_32 * T(19.23) - minus_U29_33 * T(1.425);

  // ---- body 30 (body_30) on body 29
  const T eps30_1 = x[116], eps30_2 = x[117], eps30_3 = x[118], eps30_4 = x[119];
  const T omega30_1 = y[87], omega30_2 = y[88], omega30_3 = y[89];
  const T omegadot30_1 = ydot[87], omegadot30_2 = ydot[88], omegadot30_3 = ydot[89];
  // erel30 = -e29~ e30 + eps4_29 e30 - eps4_30 e29: Euler parameters relative to the lower body
  const T erel30_1 = eps29_3 * eps30_2 - eps29_2 * eps30_3 + eps29_4 * eps30_1 - eps30_4 * eps29_1;
  const T erel30_2 = eps29_1 * eps30_3 - eps29_3 * eps30_1 + eps29_4 * eps30_2 - eps30_4 * eps29_2;
  const T erel30_3 = eps29_2 * eps30_1 - eps29_1 * eps30_2 + eps29_4 * eps30_3 - eps30_4 * eps29_3;
  // eps4rel30 = e29 . e30 + eps4_29 eps4_30
  const T eps4rel30 = eps29_1 * eps30_1 + eps29_2 * eps30_2 + eps29_3 * eps30_3 + eps29_4 * eps30_4;
  // C30^T = 1 + 2 erel30~ (eps4rel30 + erel30~): C takes components in the lower body to those in the body
  const T t30_1 = T(2) * erel30_2;
  const T t30_2 = t30_1 * erel30_2;
  const T t30_3 = T(2) * erel30_3;
  const T t30_4 = t30_3 * erel30_3;
  const T C30_11 = T(1) - t30_2 - t30_4;
  const T t30_5 = T(2) * erel30_1;
  const T t30_6 = t30_5 * erel30_2;
  const T t30_7 = t30_3 * eps4rel30;
  const T C30_12 = t30_6 + t30_7;
  const T t30_8 = t30_5 * erel30_3;
  const T t30_9 = t30_1 * eps4rel30;
  const T C30_13 = t30_8 - t30_9;
  const T C30_21 = t30_6 - t30_7;
  const T t30_10 = T(1) - t30_5 * erel30_1;
  const T C30_22 = t30_10 - t30_4;
  const T t30_11 = t30_1 * erel30_3;
  const T t30_12 = t30_5 * eps4rel30;
  const T C30_23 = t30_11 + t30_12;
  const T C30_31 = t30_8 + t30_9;
  const T C30_32 = t30_11 - t30_12;
  const T C30_33 = t30_10 - t30_2;
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
  // Pddot30 = C30 (U29 q30 + Pddot29): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t30_19 = Pddot29_1 + U29_12 * T(1.5) - minus_U29_11 * T(0.3) + U29_13 * T(0.1);
  const T t30_20 = Pddot29_2 + U29_21 * T(0.3) - minus_U29_22 * T(1.5) + U29_23 * T(0.1);
  const T t30_21 = Pddot29_3 + U29_31 * T(0.3) + U29_32 * T(1.5) - minus_U29_33 * T(0.1);
  const T Pddot30_1 = C30_11 * t30_19 + C30_12 * t30_20 + C30_13 * t30_21;
  const T Pddot30_2 = C30_21 * t30_19 + C30_22 * t30_20 + C30_23 * t30_21;
  const T Pddot30_3 = C30_31 * t30_19 + C30_32 * t30_20 + C30_33 * t30_21;
  // N29 = C30^T M_torque_30_ + h_all_29~ Pddot29 + axial(U29 (tr(J_all_29)/2 - J_all_29)) - M_torque_29_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N29_1 = C30_11 * u.tau_30_1 - u.tau_29_1 + C30_21 * u.tau_30_2 + C30_31 * u.tau_30_3 + T(19.23) * Pddot29_3
      - T(1.425) * Pddot29_2 + T(27.948) * U29_32 - T(0.40575000000000006) * U29_23 + T(1.8996000000000002) *
      (minus_U29_22 - minus_U29_33) + T(5.5935) * U29_31 - T(0.3768) * U29_21;
  const T N29_2 = C30_12 * u.tau_30_1 - u.tau_29_2 + C30_22 * u.tau_30_2 + C30_32 * u.tau_30_3 + T(1.425) * Pddot29_1
      - T(4.08) * Pddot29_3 + T(0.40575000000000006) * U29_13 - T(1.341) * U29_31 + T(0.3768) * (minus_U29_33 -
      minus_U29_11) + T(1.8996000000000002) * U29_12 - T(5.5935) * U29_32;
  const T N29_3 = C30_13 * u.tau_30_1 - u.tau_29_3 + C30_23 * u.tau_30_2 + C30_33 * u.tau_30_3 + T(4.08) * Pddot29_2 -
      T(19.23) * Pddot29_1 + T(1.341) * U29_21 - T(27.948) * U29_12 + T(5.5935) * (minus_U29_11 - minus_U29_22) +
      T(0.3768) * U29_23 - T(1.8996000000000002) * U29_13;
  // G30 = U30 h_all_30: inertia less applied force, body axes [N]
  const T G30_1 = U30_12 * T(13.665000000000001) - minus_U30_11 * T(2.8899999999999997) + U30_13 * T(1.03);
  const T G30_2 = U30_21 * T(2.8899999999999997) - minus_U30_22 * T(13.665000000000001) + U30_23 * T(1.03);
  const T G30_3 = U30_31 * T(2.8899999999999997) + U30_32 * T(13.665000000000001) - minus_U30_33 * T(1.03);

  // ---- body 31 (body_31) on body 30
  const T eps31_1 = x[120], eps31_2 = x[121], eps31_3 = x[122], eps31_4 = x[123];
  const T omega31_1 = y[90], omega31_2 = y[91], omega31_3 = y[92];
  const T omegadot31_1 = ydot[90], omegadot31_2 = ydot[91], omegadot31_3 = ydot[92];
  // erel31 = -e30~ e31 + eps4_30 e31 - eps4_31 e30: Euler parameters relative to the lower body
  const T erel31_1 = eps30_3 * eps31_2 - eps30_2 * eps31_3 + eps30_4 * eps31_1 - eps31_4 * eps30_1;
  const T erel31_2 = eps30_1 * eps31_3 - eps30_3 * eps31_1 + eps30_4 * eps31_2 - eps31_4 * eps30_2;
  const T erel31_3 = eps30_2 * eps31_1 - eps30_1 * eps31_2 + eps30_4 * eps31_3 - eps31_4 * eps30_3;
  // eps4rel31 = e30 . e31 + eps4_30 eps4_31
  const T eps4rel31 = eps30_1 * eps31_1 + eps30_2 * eps31_2 + eps30_3 * eps31_3 + eps30_4 * eps31_4;
  // C31^T = 1 + 2 erel31~ (eps4rel31 + erel31~): C takes components in the lower body to those in the body
  const T t31_1 = T(2) * erel31_2;
  const T t31_2 = t31_1 * erel31_2;
  const T t31_3 = T(2) * erel31_3;
  const T t31_4 = t31_3 * erel31_3;
  const T C31_11 = T(1) - t31_2 - t31_4;
  const T t31_5 = T(2) * erel31_1;
  const T t31_6 = t31_5 * erel31_2;
  const T t31_7 = t31_3 * eps4rel31;
  const T C31_12 = t31_6 + t31_7;
  const T t31_8 = t31_5 * erel31_3;
  const T t31_9 = t31_1 * eps4rel31;
  const T C31_13 = t31_8 - t31_9;
  const T C31_21 = t31_6 - t31_7;
  const T t31_10 = T(1) - t31_5 * erel31_1;
  const T C31_22 = t31_10 - t31_4;
  const T t31_11 = t31_1 * erel31_3;
  const T t31_12 = t31_5 * eps4rel31;
  const T C31_23 = t31_11 + t31_12;
  const T C31_31 = t31_8 + t31_9;
  const T C31_32 = t31_11 - t31_12;
  const T C31_33 = t31_10 - t31_2;
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
  // Pddot31 = C31 (U30 q31 + Pddot30): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t31_19 = Pddot30_1 + U30_12 * T(1.55) - minus_U30_11 * T(0.3) + U30_13 * T(0.1);
  const T t31_20 = Pddot30_2 + U30_21 * T(0.3) - minus_U30_22 * T(1.55) + U30_23 * T(0.1);
  const T t31_21 = Pddot30_3 + U30_31 * T(0.3) + U30_32 * T(1.55) - minus_U30_33 * T(0.1);
  const T Pddot31_1 = C31_11 * t31_19 + C31_12 * t31_20 + C31_13 * t31_21;
  const T Pddot31_2 = C31_21 * t31_19 + C31_22 * t31_20 + C31_23 * t31_21;
  const T Pddot31_3 = C31_31 * t31_19 + C31_32 * t31_20 + C31_33 * t31_21;
  // N30 = C31^T M_torque_31_ + h_all_30~ Pddot30 + axial(U30 (tr(J_all_30)/2 - J_all_30)) - M_torque_30_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N30_1 = C31_11 * u.tau_31_1 - u.tau_30_1 + C31_21 * u.tau_31_2 + C31_31 * u.tau_31_3 + T(13.665000000000001)
      * Pddot30_3 - T(1.03) * Pddot30_2 + T(20.220750000000002) * U30_32 - T(0.373) * U30_23 + T(1.3425) *
      (minus_U30_22 - minus_U30_33) + T(3.9194999999999998) * U30_31 - T(0.257) * U30_21;
  const T N30_2 = C31_12 * u.tau_31_1 - u.tau_30_2 + C31_22 * u.tau_31_2 + C31_32 * u.tau_31_3 + T(1.03) * Pddot30_1 -
      T(2.8899999999999997) * Pddot30_3 + T(0.373) * U30_13 - T(0.9869999999999999) * U30_31 + T(0.257) *
      (minus_U30_33 - minus_U30_11) + T(1.3425) * U30_12 - T(3.9194999999999998) * U30_32;
  const T N30_3 = C31_13 * u.tau_31_1 - u.tau_30_3 + C31_23 * u.tau_31_2 + C31_33 * u.tau_31_3 + T(2.8899999999999997)
      * Pddot30_2 - T(13.665000000000001) * Pddot30_1 + T(0.9869999999999999) * U30_21 - T(20.220750000000002) *
      U30_12 + T(3.9194999999999998) * (minus_U30_11 - minus_U30_22) + T(0.257) * U30_23 - T(1.3425) * U30_13;
  // G31 = U31 h_all_31: inertia less applied force, body axes [N]
  const T G31_1 = U31_12 * T(7.540000000000001) - minus_U31_11 * T(1.67) + U31_13 * T(0.625);
  const T G31_2 = U31_21 * T(1.67) - minus_U31_22 * T(7.540000000000001) + U31_23 * T(0.625);
  const T G31_3 = U31_31 * T(1.67) + U31_32 * T(7.540000000000001) - minus_U31_33 * T(0.625);

  // ---- body 32 (body_32) on body 31
  const T eps32_1 = x[124], eps32_2 = x[125], eps32_3 = x[126], eps32_4 = x[127];
  const T omega32_1 = y[93], omega32_2 = y[94], omega32_3 = y[95];
  const T omegadot32_1 = ydot[93], omegadot32_2 = ydot[94], omegadot32_3 = ydot[95];
  // erel32 = -e31~ e32 + eps4_31 e32 - eps4_32 e31: Euler parameters relative to the lower body
  const T erel32_1 = eps31_3 * eps32_2 - eps31_2 * eps32_3 + eps31_4 * eps32_1 - eps32_4 * eps31_1;
  const T erel32_2 = eps31_1 * eps32_3 - eps31_3 * eps32_1 + eps31_4 * eps32_2 - eps32_4 * eps31_2;
  const T erel32_3 = eps31_2 * eps32_1 - eps31_1 * eps32_2 + eps31_4 * eps32_3 - eps32_4 * eps31_3;
  // eps4rel32 = e31 . e32 + eps4_31 eps4_32
  const T eps4rel32 = eps31_1 * eps32_1 + eps31_2 * eps32_2 + eps31_3 * eps32_3 + eps31_4 * eps32_4;
  // C32^T = 1 + 2 erel32~ (eps4rel32 + erel32~): C takes components in the lower body to those in the body
  const T t32_1 = T(2) * erel32_2;
  const T t32_2 = t32_1 * erel32_2;
  const T t32_3 = T(2) * erel32_3;
  const T t32_4 = t32_3 * erel32_3;
  const T C32_11 = T(1) - t32_2 - t32_4;
  const T t32_5 = T(2) * erel32_1;
  const T t32_6 = t32_5 * erel32_2;
  const T t32_7 = t32_3 * eps4rel32;
  const T C32_12 = t32_6 + t32_7;
  const T t32_8 = t32_5 * erel32_3;
  const T t32_9 = t32_1 * eps4rel32;
  const T C32_13 = t32_8 - t32_9;
  const T C32_21 = t32_6 - t32_7;
  const T t32_10 = T(1) - t32_5 * erel32_1;
  const T C32_22 = t32_10 - t32_4;
  const T t32_11 = t32_1 * erel32_3;
  const T t32_12 = t32_5 * eps4rel32;
  const T C32_23 = t32_11 + t32_12;
  const T C32_31 = t32_8 + t32_9;
  const T C32_32 = t32_11 - t32_12;
  const T C32_33 = t32_10 - t32_2;
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
  // Pddot32 = C32 (U31 q32 + Pddot31): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t32_19 = Pddot31_1 + U31_12 * T(1.6) - minus_U31_11 * T(0.3) + U31_13 * T(0.1);
  const T t32_20 = Pddot31_2 + U31_21 * T(0.3) - minus_U31_22 * T(1.6) + U31_23 * T(0.1);
  const T t32_21 = Pddot31_3 + U31_31 * T(0.3) + U31_32 * T(1.6) - minus_U31_33 * T(0.1);
  const T Pddot32_1 = C32_11 * t32_19 + C32_12 * t32_20 + C32_13 * t32_21;
  const T Pddot32_2 = C32_21 * t32_19 + C32_22 * t32_20 + C32_23 * t32_21;
  const T Pddot32_3 = C32_31 * t32_19 + C32_32 * t32_20 + C32_33 * t32_21;
  // N31 = C32^T M_torque_32_ + h_all_31~ Pddot31 + axial(U31 (tr(J_all_31)/2 - J_all_31)) - M_torque_31_: inertia
  //   less applied moment about the body origin, body axes [N m]
  const T N31_1 = C32_11 * u.tau_32_1 - u.tau_31_1 + C32_21 * u.tau_32_2 + C32_31 * u.tau_32_3 + T(7.540000000000001)
      * Pddot31_3 - T(0.625) * Pddot31_2 + T(11.039000000000001) * U31_32 - T(0.33925) * U31_23 +
      T(0.7294000000000002) * (minus_U31_22 - minus_U31_33) + T(2.0775) * U31_31 - T(0.1342) * U31_21;
  const T N31_2 = C32_12 * u.tau_32_1 - u.tau_31_2 + C32_22 * u.tau_32_2 + C32_32 * u.tau_32_3 + T(0.625) * Pddot31_1
      - T(1.67) * Pddot31_3 + T(0.33925) * U31_13 - T(0.624) * U31_31 + T(0.1342) * (minus_U31_33 - minus_U31_11) +
      T(0.7294000000000002) * U31_12 - T(2.0775) * U31_32;
  const T N31_3 = C32_13 * u.tau_32_1 - u.tau_31_3 + C32_23 * u.tau_32_2 + C32_33 * u.tau_32_3 + T(1.67) * Pddot31_2 -
      T(7.540000000000001) * Pddot31_1 + T(0.624) * U31_21 - T(11.039000000000001) * U31_12 + T(2.0775) *
      (minus_U31_11 - minus_U31_22) + T(0.1342) * U31_23 - T(0.7294000000000002) * U31_13;
  // G32 = U32 h_all_32: inertia less applied force, body axes [N]
  const T G32_1 = U32_12 * T(0.8400000000000001) - minus_U32_11 * T(0.42000000000000004) + U32_13 *
      T(0.21000000000000002);
  const T G32_2 = U32_21 * T(0.42000000000000004) - minus_U32_22 * T(0.8400000000000001) + U32_23 *
      T(0.21000000000000002);
  const T G32_3 = U32_31 * T(0.42000000000000004) + U32_32 * T(0.8400000000000001) - minus_U32_33 *
      T(0.21000000000000002);
  // N32 = h_all_32~ Pddot32 + axial(U32 (tr(J_all_32)/2 - J_all_32)) - M_torque_32_: inertia less applied moment
  //   about the body origin, body axes [N m]
  const T N32_1 = T(0.8400000000000001) * Pddot32_3 - u.tau_32_1 - T(0.21000000000000002) * Pddot32_2 +
      T(0.29400000000000004) * U32_32 - T(0.3045) * U32_23 + T(0.058800000000000005) * (minus_U32_22 - minus_U32_33) +
      T(0.06300000000000001) * U32_31 - T(0.008400000000000003) * U32_21;
  const T N32_2 = T(0.21000000000000002) * Pddot32_1 - u.tau_32_2 - T(0.42000000000000004) * Pddot32_3 + T(0.3045) *
      U32_13 - T(0.252) * U32_31 + T(0.008400000000000003) * (minus_U32_33 - minus_U32_11) + T(0.058800000000000005) *
      U32_12 - T(0.06300000000000001) * U32_32;
  const T N32_3 = T(0.42000000000000004) * Pddot32_2 - u.tau_32_3 - T(0.8400000000000001) * Pddot32_1 + T(0.252) *
      U32_21 - T(0.29400000000000004) * U32_12 + T(0.06300000000000001) * (minus_U32_11 - minus_U32_22) +
      T(0.008400000000000003) * U32_23 - T(0.058800000000000005) * U32_13;
  r[93] = N32_1;
  r[94] = N32_2;
  r[95] = N32_3;

  // ---- body 31 (body_31) and what it carries
  // S31 = C32^T G32 + G31: sum of the force balances of the subtree, body axes [N]
  const T b31_1 = C32_11 * G32_1 + C32_21 * G32_2 + C32_31 * G32_3;
  const T S31_1 = b31_1 + G31_1;
  const T b31_2 = C32_12 * G32_1 + C32_22 * G32_2 + C32_32 * G32_3;
  const T S31_2 = b31_2 + G31_2;
  const T b31_3 = C32_13 * G32_1 + C32_23 * G32_2 + C32_33 * G32_3;
  const T S31_3 = b31_3 + G31_3;
  // r_omega31 = q32~ C32^T G32 + N31: Kane's equation of omega [N m]
  const T r_omega31_1 = N31_1 + T(1.6) * b31_3 - T(0.1) * b31_2;
  const T r_omega31_2 = N31_2 + T(0.1) * b31_1 - T(0.3) * b31_3;
  const T r_omega31_3 = N31_3 + T(0.3) * b31_2 - T(1.6) * b31_1;
  r[90] = r_omega31_1;
  r[91] = r_omega31_2;
  r[92] = r_omega31_3;

  // ---- body 30 (body_30) and what it carries
  // S30 = C31^T S31 + G30: sum of the force balances of the subtree, body axes [N]
  const T b30_1 = C31_11 * S31_1 + C31_21 * S31_2 + C31_31 * S31_3;
  const T S30_1 = b30_1 + G30_1;
  const T b30_2 = C31_12 * S31_1 + C31_22 * S31_2 + C31_32 * S31_3;
  const T S30_2 = b30_2 + G30_2;
  const T b30_3 = C31_13 * S31_1 + C31_23 * S31_2 + C31_33 * S31_3;
  const T S30_3 = b30_3 + G30_3;
  // r_omega30 = q31~ C31^T S31 + N30: Kane's equation of omega [N m]
  const T r_omega30_1 = N30_1 + T(1.55) * b30_3 - T(0.1) * b30_2;
  const T r_omega30_2 = N30_2 + T(0.1) * b30_1 - T(0.3) * b30_3;
  const T r_omega30_3 = N30_3 + T(0.3) * b30_2 - T(1.55) * b30_1;
  r[87] = r_omega30_1;
  r[88] = r_omega30_2;
  r[89] = r_omega30_3;

  // ---- body 29 (body_29) and what it carries
  // S29 = C30^T S30 + G29: sum of the force balances of the subtree, body axes [N]
  const T b29_1 = C30_11 * S30_1 + C30_21 * S30_2 + C30_31 * S30_3;
  const T S29_1 = b29_1 + G29_1;
  const T b29_2 = C30_12 * S30_1 + C30_22 * S30_2 + C30_32 * S30_3;
  const T S29_2 = b29_2 + G29_2;
  const T b29_3 = C30_13 * S30_1 + C30_23 * S30_2 + C30_33 * S30_3;
  const T S29_3 = b29_3 + G29_3;
  // r_omega29 = q30~ C30^T S30 + N29: Kane's equation of omega [N m]
  const T r_omega29_1 = N29_1 + T(1.5) * b29_3 - T(0.1) * b29_2;
  const T r_omega29_2 = N29_2 + T(0.1) * b29_1 - T(0.3) * b29_3;
  const T r_omega29_3 = N29_3 + T(0.3) * b29_2 - T(1.5) * b29_1;
  r[84] = r_omega29_1;
  r[85] = r_omega29_2;
  r[86] = r_omega29_3;

  // ---- body 28 (body_28) and what it carries
  // S28 = C29^T S29 + G28: sum of the force balances of the subtree, body axes [N]
  const T b28_1 = C29_11 * S29_1 + C29_21 * S29_2 + C29_31 * S29_3;
  const T S28_1 = b28_1 + G28_1;
  const T b28_2 = C29_12 * S29_1 + C29_22 * S29_2 + C29_32 * S29_3;
  const T S28_2 = b28_2 + G28_2;
  const T b28_3 = C29_13 * S29_1 + C29_23 * S29_2 + C29_33 * S29_3;
  const T S28_3 = b28_3 + G28_3;
  // r_omega28 = q29~ C29^T S29 + N28: Kane's equation of omega [N m]
  const T r_omega28_1 = N28_1 + T(1.45) * b28_3 - T(0.1) * b28_2;
  const T r_omega28_2 = N28_2 + T(0.1) * b28_1 - T(0.3) * b28_3;
  const T r_omega28_3 = N28_3 + T(0.3) * b28_2 - T(1.45) * b28_1;
  r[81] = r_omega28_1;
  r[82] = r_omega28_2;
  r[83] = r_omega28_3;

  // ---- body 27 (body_27) and what it carries
  // S27 = C28^T S28 + G27: sum of the force balances of the subtree, body axes [N]
  const T b27_1 = C28_11 * S28_1 + C28_21 * S28_2 + C28_31 * S28_3;
  const T S27_1 = b27_1 + G27_1;
  const T b27_2 = C28_12 * S28_1 + C28_22 * S28_2 + C28_32 * S28_3;
  const T S27_2 = b27_2 + G27_2;
  const T b27_3 = C28_13 * S28_1 + C28_23 * S28_2 + C28_33 * S28_3;
  const T S27_3 = b27_3 + G27_3;
  // r_omega27 = q28~ C28^T S28 + N27: Kane's equation of omega [N m]
  const T r_omega27_1 = N27_1 + T(1.4) * b27_3 - T(0.1) * b27_2;
  const T r_omega27_2 = N27_2 + T(0.1) * b27_1 - T(0.3) * b27_3;
  const T r_omega27_3 = N27_3 + T(0.3) * b27_2 - T(1.4) * b27_1;
  r[78] = r_omega27_1;
  r[79] = r_omega27_2;
  r[80] = r_omega27_3;

  // ---- body 26 (body_26) and what it carries
  // S26 = C27^T S27 + G26: sum of the force balances of the subtree, body axes [N]
  const T b26_1 = C27_11 * S27_1 + C27_21 * S27_2 + C27_31 * S27_3;
  const T S26_1 = b26_1 + G26_1;
  const T b26_2 = C27_12 * S27_1 + C27_22 * S27_2 + C27_32 * S27_3;
  const T S26_2 = b26_2 + G26_2;
  const T b26_3 = C27_13 * S27_1 + C27_23 * S27_2 + C27_33 * S27_3;
  const T S26_3 = b26_3 + G26_3;
  // r_omega26 = q27~ C27^T S27 + N26: Kane's equation of omega [N m]
  const T r_omega26_1 = N26_1 + T(1.35) * b26_3 - T(0.1) * b26_2;
  const T r_omega26_2 = N26_2 + T(0.1) * b26_1 - T(0.3) * b26_3;
  const T r_omega26_3 = N26_3 + T(0.3) * b26_2 - T(1.35) * b26_1;
  r[75] = r_omega26_1;
  r[76] = r_omega26_2;
  r[77] = r_omega26_3;

  // ---- body 25 (body_25) and what it carries
  // S25 = C26^T S26 + G25: sum of the force balances of the subtree, body axes [N]
  const T b25_1 = C26_11 * S26_1 + C26_21 * S26_2 + C26_31 * S26_3;
  const T S25_1 = b25_1 + G25_1;
  const T b25_2 = C26_12 * S26_1 + C26_22 * S26_2 + C26_32 * S26_3;
  const T S25_2 = b25_2 + G25_2;
  const T b25_3 = C26_13 * S26_1 + C26_23 * S26_2 + C26_33 * S26_3;
  const T S25_3 = b25_3 + G25_3;
  // r_omega25 = q26~ C26^T S26 + N25: Kane's equation of omega [N m]
  const T r_omega25_1 = N25_1 + T(1.3) * b25_3 - T(0.1) * b25_2;
  const T r_omega25_2 = N25_2 + T(0.1) * b25_1 - T(0.3) * b25_3;
  const T r_omega25_3 = N25_3 + T(0.3) * b25_2 - T(1.3) * b25_1;
  r[72] = r_omega25_1;
  r[73] = r_omega25_2;
  r[74] = r_omega25_3;

  // ---- body 24 (body_24) and what it carries
  // S24 = C25^T S25 + G24: sum of the force balances of the subtree, body axes [N]
  const T b24_1 = C25_11 * S25_1 + C25_21 * S25_2 + C25_31 * S25_3;
  const T S24_1 = b24_1 + G24_1;
  const T b24_2 = C25_12 * S25_1 + C25_22 * S25_2 + C25_32 * S25_3;
  const T S24_2 = b24_2 + G24_2;
  const T b24_3 = C25_13 * S25_1 + C25_23 * S25_2 + C25_33 * S25_3;
  const T S24_3 = b24_3 + G24_3;
  // r_omega24 = q25~ C25^T S25 + N24: Kane's equation of omega [N m]
  const T r_omega24_1 = N24_1 + T(1.25) * b24_3 - T(0.1) * b24_2;
  const T r_omega24_2 = N24_2 + T(0.1) * b24_1 - T(0.3) * b24_3;
  const T r_omega24_3 = N24_3 + T(0.3) * b24_2 - T(1.25) * b24_1;
  r[69] = r_omega24_1;
  r[70] = r_omega24_2;
  r[71] = r_omega24_3;

  // ---- body 23 (body_23) and what it carries
  // S23 = C24^T S24 + G23: sum of the force balances of the subtree, body axes [N]
  const T b23_1 = C24_11 * S24_1 + C24_21 * S24_2 + C24_31 * S24_3;
  const T S23_1 = b23_1 + G23_1;
  const T b23_2 = C24_12 * S24_1 + C24_22 * S24_2 + C24_32 * S24_3;
  const T S23_2 = b23_2 + G23_2;
  const T b23_3 = C24_13 * S24_1 + C24_23 * S24_2 + C24_33 * S24_3;
  const T S23_3 = b23_3 + G23_3;
  // r_omega23 = q24~ C24^T S24 + N23: Kane's equation of omega [N m]
  const T r_omega23_1 = N23_1 + T(1.2) * b23_3 - T(0.1) * b23_2;
  const T r_omega23_2 = N23_2 + T(0.1) * b23_1 - T(0.3) * b23_3;
  const T r_omega23_3 = N23_3 + T(0.3) * b23_2 - T(1.2) * b23_1;
  r[66] = r_omega23_1;
  r[67] = r_omega23_2;
  r[68] = r_omega23_3;

  // ---- body 22 (body_22) and what it carries
  // S22 = C23^T S23 + G22: sum of the force balances of the subtree, body axes [N]
  const T b22_1 = C23_11 * S23_1 + C23_21 * S23_2 + C23_31 * S23_3;
  const T S22_1 = b22_1 + G22_1;
  const T b22_2 = C23_12 * S23_1 + C23_22 * S23_2 + C23_32 * S23_3;
  const T S22_2 = b22_2 + G22_2;
  const T b22_3 = C23_13 * S23_1 + C23_23 * S23_2 + C23_33 * S23_3;
  const T S22_3 = b22_3 + G22_3;
  // r_omega22 = q23~ C23^T S23 + N22: Kane's equation of omega [N m]
  const T r_omega22_1 = N22_1 + T(1.15) * b22_3 - T(0.1) * b22_2;
  const T r_omega22_2 = N22_2 + T(0.1) * b22_1 - T(0.3) * b22_3;
  const T r_omega22_3 = N22_3 + T(0.3) * b22_2 - T(1.15) * b22_1;
  r[63] = r_omega22_1;
  r[64] = r_omega22_2;
  r[65] = r_omega22_3;

  // ---- body 21 (body_21) and what it carries
  // S21 = C22^T S22 + G21: sum of the force balances of the subtree, body axes [N]
  const T b21_1 = C22_11 * S22_1 + C22_21 * S22_2 + C22_31 * S22_3;
  const T S21_1 = b21_1 + G21_1;
  const T b21_2 = C22_12 * S22_1 + C22_22 * S22_2 + C22_32 * S22_3;
  const T S21_2 = b21_2 + G21_2;
  const T b21_3 = C22_13 * S22_1 + C22_23 * S22_2 + C22_33 * S22_3;
  const T S21_3 = b21_3 + G21_3;
  // r_omega21 = q22~ C22^T S22 + N21: Kane's equation of omega [N m]
  const T r_omega21_1 = N21_1 + T(1.1) * b21_3 - T(0.1) * b21_2;
  const T r_omega21_2 = N21_2 + T(0.1) * b21_1 - T(0.3) * b21_3;
  const T r_omega21_3 = N21_3 + T(0.3) * b21_2 - T(1.1) * b21_1;
  r[60] = r_omega21_1;
  r[61] = r_omega21_2;
  r[62] = r_omega21_3;

  // ---- body 20 (body_20) and what it carries
  // S20 = C21^T S21 + G20: sum of the force balances of the subtree, body axes [N]
  const T b20_1 = C21_11 * S21_1 + C21_21 * S21_2 + C21_31 * S21_3;
  const T S20_1 = b20_1 + G20_1;
  const T b20_2 = C21_12 * S21_1 + C21_22 * S21_2 + C21_32 * S21_3;
  const T S20_2 = b20_2 + G20_2;
  const T b20_3 = C21_13 * S21_1 + C21_23 * S21_2 + C21_33 * S21_3;
  const T S20_3 = b20_3 + G20_3;
  // r_omega20 = q21~ C21^T S21 + N20: Kane's equation of omega [N m]
  const T r_omega20_1 = N20_1 + T(1.05) * b20_3 - T(0.1) * b20_2;
  const T r_omega20_2 = N20_2 + T(0.1) * b20_1 - T(0.3) * b20_3;
  const T r_omega20_3 = N20_3 + T(0.3) * b20_2 - T(1.05) * b20_1;
  r[57] = r_omega20_1;
  r[58] = r_omega20_2;
  r[59] = r_omega20_3;

  // ---- body 19 (body_19) and what it carries
  // S19 = C20^T S20 + G19: sum of the force balances of the subtree, body axes [N]
  const T b19_1 = C20_11 * S20_1 + C20_21 * S20_2 + C20_31 * S20_3;
  const T S19_1 = b19_1 + G19_1;
  const T b19_2 = C20_12 * S20_1 + C20_22 * S20_2 + C20_32 * S20_3;
  const T S19_2 = b19_2 + G19_2;
  const T b19_3 = C20_13 * S20_1 + C20_23 * S20_2 + C20_33 * S20_3;
  const T S19_3 = b19_3 + G19_3;
  // r_omega19 = q20~ C20^T S20 + N19: Kane's equation of omega [N m]
  const T r_omega19_1 = b19_3 + N19_1 - T(0.1) * b19_2;
  const T r_omega19_2 = N19_2 + T(0.1) * b19_1 - T(0.3) * b19_3;
  const T r_omega19_3 = N19_3 - b19_1 + T(0.3) * b19_2;
  r[54] = r_omega19_1;
  r[55] = r_omega19_2;
  r[56] = r_omega19_3;

  // ---- body 18 (body_18) and what it carries
  // S18 = C19^T S19 + G18: sum of the force balances of the subtree, body axes [N]
  const T b18_1 = C19_11 * S19_1 + C19_21 * S19_2 + C19_31 * S19_3;
  const T S18_1 = b18_1 + G18_1;
  const T b18_2 = C19_12 * S19_1 + C19_22 * S19_2 + C19_32 * S19_3;
  const T S18_2 = b18_2 + G18_2;
  const T b18_3 = C19_13 * S19_1 + C19_23 * S19_2 + C19_33 * S19_3;
  const T S18_3 = b18_3 + G18_3;
  // r_omega18 = q19~ C19^T S19 + N18: Kane's equation of omega [N m]
  const T r_omega18_1 = N18_1 + T(0.95) * b18_3 - T(0.1) * b18_2;
  const T r_omega18_2 = N18_2 + T(0.1) * b18_1 - T(0.3) * b18_3;
  const T r_omega18_3 = N18_3 + T(0.3) * b18_2 - T(0.95) * b18_1;
  r[51] = r_omega18_1;
  r[52] = r_omega18_2;
  r[53] = r_omega18_3;

  // ---- body 17 (body_17) and what it carries
  // S17 = C18^T S18 + G17: sum of the force balances of the subtree, body axes [N]
  const T b17_1 = C18_11 * S18_1 + C18_21 * S18_2 + C18_31 * S18_3;
  const T S17_1 = b17_1 + G17_1;
  const T b17_2 = C18_12 * S18_1 + C18_22 * S18_2 + C18_32 * S18_3;
  const T S17_2 = b17_2 + G17_2;
  const T b17_3 = C18_13 * S18_1 + C18_23 * S18_2 + C18_33 * S18_3;
  const T S17_3 = b17_3 + G17_3;
  // r_omega17 = q18~ C18^T S18 + N17: Kane's equation of omega [N m]
  const T r_omega17_1 = N17_1 + T(0.9) * b17_3 - T(0.1) * b17_2;
  const T r_omega17_2 = N17_2 + T(0.1) * b17_1 - T(0.3) * b17_3;
  const T r_omega17_3 = N17_3 + T(0.3) * b17_2 - T(0.9) * b17_1;
  r[48] = r_omega17_1;
  r[49] = r_omega17_2;
  r[50] = r_omega17_3;

  // ---- body 16 (body_16) and what it carries
  // S16 = C17^T S17 + G16: sum of the force balances of the subtree, body axes [N]
  const T b16_1 = C17_11 * S17_1 + C17_21 * S17_2 + C17_31 * S17_3;
  const T S16_1 = b16_1 + G16_1;
  const T b16_2 = C17_12 * S17_1 + C17_22 * S17_2 + C17_32 * S17_3;
  const T S16_2 = b16_2 + G16_2;
  const T b16_3 = C17_13 * S17_1 + C17_23 * S17_2 + C17_33 * S17_3;
  const T S16_3 = b16_3 + G16_3;
  // r_omega16 = q17~ C17^T S17 + N16: Kane's equation of omega [N m]
  const T r_omega16_1 = N16_1 + T(0.85) * b16_3 - T(0.1) * b16_2;
  const T r_omega16_2 = N16_2 + T(0.1) * b16_1 - T(0.3) * b16_3;
  const T r_omega16_3 = N16_3 + T(0.3) * b16_2 - T(0.85) * b16_1;
  r[45] = r_omega16_1;
  r[46] = r_omega16_2;
  r[47] = r_omega16_3;

  // ---- body 15 (body_15) and what it carries
  // S15 = C16^T S16 + G15: sum of the force balances of the subtree, body axes [N]
  const T b15_1 = C16_11 * S16_1 + C16_21 * S16_2 + C16_31 * S16_3;
  const T S15_1 = b15_1 + G15_1;
  const T b15_2 = C16_12 * S16_1 + C16_22 * S16_2 + C16_32 * S16_3;
  const T S15_2 = b15_2 + G15_2;
  const T b15_3 = C16_13 * S16_1 + C16_23 * S16_2 + C16_33 * S16_3;
  const T S15_3 = b15_3 + G15_3;
  // r_omega15 = q16~ C16^T S16 + N15: Kane's equation of omega [N m]
  const T r_omega15_1 = N15_1 + T(0.8) * b15_3 - T(0.1) * b15_2;
  const T r_omega15_2 = N15_2 + T(0.1) * b15_1 - T(0.3) * b15_3;
  const T r_omega15_3 = N15_3 + T(0.3) * b15_2 - T(0.8) * b15_1;
  r[42] = r_omega15_1;
  r[43] = r_omega15_2;
  r[44] = r_omega15_3;

  // ---- body 14 (body_14) and what it carries
  // S14 = C15^T S15 + G14: sum of the force balances of the subtree, body axes [N]
  const T b14_1 = C15_11 * S15_1 + C15_21 * S15_2 + C15_31 * S15_3;
  const T S14_1 = b14_1 + G14_1;
  const T b14_2 = C15_12 * S15_1 + C15_22 * S15_2 + C15_32 * S15_3;
  const T S14_2 = b14_2 + G14_2;
  const T b14_3 = C15_13 * S15_1 + C15_23 * S15_2 + C15_33 * S15_3;
  const T S14_3 = b14_3 + G14_3;
  // r_omega14 = q15~ C15^T S15 + N14: Kane's equation of omega [N m]
  const T r_omega14_1 = N14_1 + T(0.75) * b14_3 - T(0.1) * b14_2;
  const T r_omega14_2 = N14_2 + T(0.1) * b14_1 - T(0.3) * b14_3;
  const T r_omega14_3 = N14_3 + T(0.3) * b14_2 - T(0.75) * b14_1;
  r[39] = r_omega14_1;
  r[40] = r_omega14_2;
  r[41] = r_omega14_3;

  // ---- body 13 (body_13) and what it carries
  // S13 = C14^T S14 + G13: sum of the force balances of the subtree, body axes [N]
  const T b13_1 = C14_11 * S14_1 + C14_21 * S14_2 + C14_31 * S14_3;
  const T S13_1 = b13_1 + G13_1;
  const T b13_2 = C14_12 * S14_1 + C14_22 * S14_2 + C14_32 * S14_3;
  const T S13_2 = b13_2 + G13_2;
  const T b13_3 = C14_13 * S14_1 + C14_23 * S14_2 + C14_33 * S14_3;
  const T S13_3 = b13_3 + G13_3;
  // r_omega13 = q14~ C14^T S14 + N13: Kane's equation of omega [N m]
  const T r_omega13_1 = N13_1 + T(0.7) * b13_3 - T(0.1) * b13_2;
  const T r_omega13_2 = N13_2 + T(0.1) * b13_1 - T(0.3) * b13_3;
  const T r_omega13_3 = N13_3 + T(0.3) * b13_2 - T(0.7) * b13_1;
  r[36] = r_omega13_1;
  r[37] = r_omega13_2;
  r[38] = r_omega13_3;

  // ---- body 12 (body_12) and what it carries
  // S12 = C13^T S13 + G12: sum of the force balances of the subtree, body axes [N]
  const T b12_1 = C13_11 * S13_1 + C13_21 * S13_2 + C13_31 * S13_3;
  const T S12_1 = b12_1 + G12_1;
  const T b12_2 = C13_12 * S13_1 + C13_22 * S13_2 + C13_32 * S13_3;
  const T S12_2 = b12_2 + G12_2;
  const T b12_3 = C13_13 * S13_1 + C13_23 * S13_2 + C13_33 * S13_3;
  const T S12_3 = b12_3 + G12_3;
  // r_omega12 = q13~ C13^T S13 + N12: Kane's equation of omega [N m]
  const T r_omega12_1 = N12_1 + T(0.65) * b12_3 - T(0.1) * b12_2;
  const T r_omega12_2 = N12_2 + T(0.1) * b12_1 - T(0.3) * b12_3;
  const T r_omega12_3 = N12_3 + T(0.3) * b12_2 - T(0.65) * b12_1;
  r[33] = r_omega12_1;
  r[34] = r_omega12_2;
  r[35] = r_omega12_3;

  // ---- body 11 (body_11) and what it carries
  // S11 = C12^T S12 + G11: sum of the force balances of the subtree, body axes [N]
  const T b11_1 = C12_11 * S12_1 + C12_21 * S12_2 + C12_31 * S12_3;
  const T S11_1 = b11_1 + G11_1;
  const T b11_2 = C12_12 * S12_1 + C12_22 * S12_2 + C12_32 * S12_3;
  const T S11_2 = b11_2 + G11_2;
  const T b11_3 = C12_13 * S12_1 + C12_23 * S12_2 + C12_33 * S12_3;
  const T S11_3 = b11_3 + G11_3;
  // r_omega11 = q12~ C12^T S12 + N11: Kane's equation of omega [N m]
  const T r_omega11_1 = N11_1 + T(0.6) * b11_3 - T(0.1) * b11_2;
  const T r_omega11_2 = N11_2 + T(0.1) * b11_1 - T(0.3) * b11_3;
  const T r_omega11_3 = N11_3 + T(0.3) * b11_2 - T(0.6) * b11_1;
  r[30] = r_omega11_1;
  r[31] = r_omega11_2;
  r[32] = r_omega11_3;

  // ---- body 10 (body_10) and what it carries
  // S10 = C11^T S11 + G10: sum of the force balances of the subtree, body axes [N]
  const T b10_1 = C11_11 * S11_1 + C11_21 * S11_2 + C11_31 * S11_3;
  const T S10_1 = b10_1 + G10_1;
  const T b10_2 = C11_12 * S11_1 + C11_22 * S11_2 + C11_32 * S11_3;
  const T S10_2 = b10_2 + G10_2;
  const T b10_3 = C11_13 * S11_1 + C11_23 * S11_2 + C11_33 * S11_3;
  const T S10_3 = b10_3 + G10_3;
  // r_omega10 = q11~ C11^T S11 + N10: Kane's equation of omega [N m]
  const T r_omega10_1 = N10_1 + T(0.55) * b10_3 - T(0.1) * b10_2;
  const T r_omega10_2 = N10_2 + T(0.1) * b10_1 - T(0.3) * b10_3;
  const T r_omega10_3 = N10_3 + T(0.3) * b10_2 - T(0.55) * b10_1;
  r[27] = r_omega10_1;
  r[28] = r_omega10_2;
  r[29] = r_omega10_3;

  // ---- body 9 (body_9) and what it carries
  // S9 = C10^T S10 + G9: sum of the force balances of the subtree, body axes [N]
  const T b9_1 = C10_11 * S10_1 + C10_21 * S10_2 + C10_31 * S10_3;
  const T S9_1 = b9_1 + G9_1;
  const T b9_2 = C10_12 * S10_1 + C10_22 * S10_2 + C10_32 * S10_3;
  const T S9_2 = b9_2 + G9_2;
  const T b9_3 = C10_13 * S10_1 + C10_23 * S10_2 + C10_33 * S10_3;
  const T S9_3 = b9_3 + G9_3;
  // r_omega9 = q10~ C10^T S10 + N9: Kane's equation of omega [N m]
  const T r_omega9_1 = N9_1 + T(0.5) * b9_3 - T(0.1) * b9_2;
  const T r_omega9_2 = N9_2 + T(0.1) * b9_1 - T(0.3) * b9_3;
  const T r_omega9_3 = N9_3 + T(0.3) * b9_2 - T(0.5) * b9_1;
  r[24] = r_omega9_1;
  r[25] = r_omega9_2;
  r[26] = r_omega9_3;

  // ---- body 8 (body_8) and what it carries
  // S8 = C9^T S9 + G8: sum of the force balances of the subtree, body axes [N]
  const T b8_1 = C9_11 * S9_1 + C9_21 * S9_2 + C9_31 * S9_3;
  const T S8_1 = b8_1 + G8_1;
  const T b8_2 = C9_12 * S9_1 + C9_22 * S9_2 + C9_32 * S9_3;
  const T S8_2 = b8_2 + G8_2;
  const T b8_3 = C9_13 * S9_1 + C9_23 * S9_2 + C9_33 * S9_3;
  const T S8_3 = b8_3 + G8_3;
  // r_omega8 = q9~ C9^T S9 + N8: Kane's equation of omega [N m]
  const T r_omega8_1 = N8_1 + T(0.45) * b8_3 - T(0.1) * b8_2;
  const T r_omega8_2 = N8_2 + T(0.1) * b8_1 - T(0.3) * b8_3;
  const T r_omega8_3 = N8_3 + T(0.3) * b8_2 - T(0.45) * b8_1;
  r[21] = r_omega8_1;
  r[22] = r_omega8_2;
  r[23] = r_omega8_3;

  // ---- body 7 (body_7) and what it carries
  // S7 = C8^T S8 + G7: sum of the force balances of the subtree, body axes [N]
  const T b7_1 = C8_11 * S8_1 + C8_21 * S8_2 + C8_31 * S8_3;
  const T S7_1 = b7_1 + G7_1;
  const T b7_2 = C8_12 * S8_1 + C8_22 * S8_2 + C8_32 * S8_3;
  const T S7_2 = b7_2 + G7_2;
  const T b7_3 = C8_13 * S8_1 + C8_23 * S8_2 + C8_33 * S8_3;
  const T S7_3 = b7_3 + G7_3;
  // r_omega7 = q8~ C8^T S8 + N7: Kane's equation of omega [N m]
  const T r_omega7_1 = N7_1 + T(0.4) * b7_3 - T(0.1) * b7_2;
  const T r_omega7_2 = N7_2 + T(0.1) * b7_1 - T(0.3) * b7_3;
  const T r_omega7_3 = N7_3 + T(0.3) * b7_2 - T(0.4) * b7_1;
  r[18] = r_omega7_1;
  r[19] = r_omega7_2;
  r[20] = r_omega7_3;

  // ---- body 6 (body_6) and what it carries
  // S6 = C7^T S7 + G6: sum of the force balances of the subtree, body axes [N]
  const T b6_1 = C7_11 * S7_1 + C7_21 * S7_2 + C7_31 * S7_3;
  const T S6_1 = b6_1 + G6_1;
  const T b6_2 = C7_12 * S7_1 + C7_22 * S7_2 + C7_32 * S7_3;
  const T S6_2 = b6_2 + G6_2;
  const T b6_3 = C7_13 * S7_1 + C7_23 * S7_2 + C7_33 * S7_3;
  const T S6_3 = b6_3 + G6_3;
  // r_omega6 = q7~ C7^T S7 + N6: Kane's equation of omega [N m]
  const T r_omega6_1 = N6_1 + T(0.35) * b6_3 - T(0.1) * b6_2;
  const T r_omega6_2 = N6_2 + T(0.1) * b6_1 - T(0.3) * b6_3;
  const T r_omega6_3 = N6_3 + T(0.3) * b6_2 - T(0.35) * b6_1;
  r[15] = r_omega6_1;
  r[16] = r_omega6_2;
  r[17] = r_omega6_3;

  // ---- body 5 (body_5) and what it carries
  // S5 = C6^T S6 + G5: sum of the force balances of the subtree, body axes [N]
  const T b5_1 = C6_11 * S6_1 + C6_21 * S6_2 + C6_31 * S6_3;
  const T S5_1 = b5_1 + G5_1;
  const T b5_2 = C6_12 * S6_1 + C6_22 * S6_2 + C6_32 * S6_3;
  const T S5_2 = b5_2 + G5_2;
  const T b5_3 = C6_13 * S6_1 + C6_23 * S6_2 + C6_33 * S6_3;
  const T S5_3 = b5_3 + G5_3;
  // r_omega5 = q6~ C6^T S6 + N5: Kane's equation of omega [N m]
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

}  // namespace kanec::bench_cb32
