// SPDX-License-Identifier: BSD-3-Clause
// random_12: equations of motion of 12 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model b41848d7debea77d; all functions
// bodies, each with a free joint:
//   1 body_1 on the inertial frame
//   2 body_2 on 1
//   3 body_3 on 2
//   4 body_4 on 3
//   5 body_5 on 3
//   6 body_6 on 2
//   7 body_7 on 4
//   8 body_8 on 1
//   9 body_9 on 6
//   10 body_10 on 8
//   11 body_11 on 5
//   12 body_12 on 11
//
// Units SI, angles in rad. x = (eps_1 .. eps_N ; s_1 .. s_N), y = (omega_1 .. omega_N ; sdot_1 .. sdot_N):
//   eps    Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)
//   s      translation from the joint point, axes of the lower body [m] (3)
//   omega  absolute angular velocity, body axes [rad/s] (3)
//   sdot   rate of s [m/s] (3)
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              276 (96 add, 180 multiply)
//   poses                   717 (369 add, 348 multiply)
//   energy                  1466 (694 add, 772 multiply)
//   momentum                1973 (958 add, 1015 multiply)
//   power                   1102 (543 add, 559 multiply)
//   accelerations           1936 (967 add, 969 multiply)
//   residual                2550 (1274 add, 1276 multiply)
//   forcing                 2311 (1058 add, 1253 multiply)
//   mass_matrix             5060 (1628 add, 3432 multiply)
//   partial_velocities      918 (366 add, 552 multiply)
//   partial_velocity_rates  1638 (672 add, 966 multiply)
#pragma once

namespace kanec::random_12 {

inline constexpr int n_bodies = 12;
inline constexpr int nx = 84;
inline constexpr int ny = 72;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 0;
inline constexpr char model_hash[] = "b41848d7debea77d";

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
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
// 96 add, 180 multiply
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

  // ---- body 5 (body_5) on body 3
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

  // ---- body 6 (body_6) on body 2
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

  // ---- body 7 (body_7) on body 4
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

  // ---- body 8 (body_8) on body 1
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

  // ---- body 9 (body_9) on body 6
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

  // ---- body 10 (body_10) on body 8
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

  // ---- body 11 (body_11) on body 5
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

  // ---- results
  const T sdot1_1 = y[36], sdot1_2 = y[37], sdot1_3 = y[38];
  const T sdot2_1 = y[39], sdot2_2 = y[40], sdot2_3 = y[41];
  const T sdot3_1 = y[42], sdot3_2 = y[43], sdot3_3 = y[44];
  const T sdot4_1 = y[45], sdot4_2 = y[46], sdot4_3 = y[47];
  const T sdot5_1 = y[48], sdot5_2 = y[49], sdot5_3 = y[50];
  const T sdot6_1 = y[51], sdot6_2 = y[52], sdot6_3 = y[53];
  const T sdot7_1 = y[54], sdot7_2 = y[55], sdot7_3 = y[56];
  const T sdot8_1 = y[57], sdot8_2 = y[58], sdot8_3 = y[59];
  const T sdot9_1 = y[60], sdot9_2 = y[61], sdot9_3 = y[62];
  const T sdot10_1 = y[63], sdot10_2 = y[64], sdot10_3 = y[65];
  const T sdot11_1 = y[66], sdot11_2 = y[67], sdot11_3 = y[68];
  const T sdot12_1 = y[69], sdot12_2 = y[70], sdot12_3 = y[71];
  xdot[48] = sdot1_1;
  xdot[49] = sdot1_2;
  xdot[50] = sdot1_3;
  xdot[51] = sdot2_1;
  xdot[52] = sdot2_2;
  xdot[53] = sdot2_3;
  xdot[54] = sdot3_1;
  xdot[55] = sdot3_2;
  xdot[56] = sdot3_3;
  xdot[57] = sdot4_1;
  xdot[58] = sdot4_2;
  xdot[59] = sdot4_3;
  xdot[60] = sdot5_1;
  xdot[61] = sdot5_2;
  xdot[62] = sdot5_3;
  xdot[63] = sdot6_1;
  xdot[64] = sdot6_2;
  xdot[65] = sdot6_3;
  xdot[66] = sdot7_1;
  xdot[67] = sdot7_2;
  xdot[68] = sdot7_3;
  xdot[69] = sdot8_1;
  xdot[70] = sdot8_2;
  xdot[71] = sdot8_3;
  xdot[72] = sdot9_1;
  xdot[73] = sdot9_2;
  xdot[74] = sdot9_3;
  xdot[75] = sdot10_1;
  xdot[76] = sdot10_2;
  xdot[77] = sdot10_3;
  xdot[78] = sdot11_1;
  xdot[79] = sdot11_2;
  xdot[80] = sdot11_3;
  xdot[81] = sdot12_1;
  xdot[82] = sdot12_2;
  xdot[83] = sdot12_3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 369 add, 348 multiply
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[48], s1_2 = x[49], s1_3 = x[50];
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
  const T p1_1 = s1_1 + R1_11 * T(0.187) - R1_21 * T(0.163) - R1_31 * T(0.095);
  const T p1_2 = s1_2 + R1_12 * T(0.187) - R1_22 * T(0.163) - R1_32 * T(0.095);
  const T p1_3 = s1_3 + R1_13 * T(0.187) - R1_23 * T(0.163) - R1_33 * T(0.095);
  pose[9] = p1_1;
  pose[10] = p1_2;
  pose[11] = p1_3;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
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
  // d2 = q2 + s2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = s2_1 - T(0.472);
  const T d2_2 = T(0.323) + s2_2;
  const T d2_3 = s2_3 - T(0.07);
  // P2 = s1 + R1^T d2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * d2_1 + R1_21 * d2_2 + R1_31 * d2_3;
  const T P2_2 = s1_2 + R1_12 * d2_1 + R1_22 * d2_2 + R1_32 * d2_3;
  const T P2_3 = s1_3 + R1_13 * d2_1 + R1_23 * d2_2 + R1_33 * d2_3;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = R2_11 * T(0.011) + R2_21 * T(0.31) + P2_1;
  const T p2_2 = R2_12 * T(0.011) + R2_22 * T(0.31) + P2_2;
  const T p2_3 = R2_13 * T(0.011) + R2_23 * T(0.31) + P2_3;
  pose[21] = p2_1;
  pose[22] = p2_2;
  pose[23] = p2_3;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
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
  // d3 = q3 + s3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = s3_1 - T(0.476);
  const T d3_2 = s3_2 - T(0.178);
  const T d3_3 = T(0.287) + s3_3;
  // P3 = R2^T d3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = R2_11 * d3_1 + R2_21 * d3_2 + R2_31 * d3_3 + P2_1;
  const T P3_2 = R2_12 * d3_1 + R2_22 * d3_2 + R2_32 * d3_3 + P2_2;
  const T P3_3 = R2_13 * d3_1 + R2_23 * d3_2 + R2_33 * d3_3 + P2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = R3_11 * T(0.484) + R3_21 * T(0.498) + R3_31 * T(0.004) + P3_1;
  const T p3_2 = R3_12 * T(0.484) + R3_22 * T(0.498) + R3_32 * T(0.004) + P3_2;
  const T p3_3 = R3_13 * T(0.484) + R3_23 * T(0.498) + R3_33 * T(0.004) + P3_3;
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
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
  // d4 = q4 + s4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = s4_1 - T(0.153);
  const T d4_2 = s4_2 - T(0.132);
  const T d4_3 = T(0.236) + s4_3;
  // P4 = R3^T d4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = R3_11 * d4_1 + R3_21 * d4_2 + R3_31 * d4_3 + P3_1;
  const T P4_2 = R3_12 * d4_1 + R3_22 * d4_2 + R3_32 * d4_3 + P3_2;
  const T P4_3 = R3_13 * d4_1 + R3_23 * d4_2 + R3_33 * d4_3 + P3_3;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = R4_11 * T(0.401) + R4_21 * T(0.289) + R4_31 * T(0.08) + P4_1;
  const T p4_2 = R4_12 * T(0.401) + R4_22 * T(0.289) + R4_32 * T(0.08) + P4_2;
  const T p4_3 = R4_13 * T(0.401) + R4_23 * T(0.289) + R4_33 * T(0.08) + P4_3;
  pose[45] = p4_1;
  pose[46] = p4_2;
  pose[47] = p4_3;

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
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
  // d5 = q5 + s5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = s5_1 - T(0.159);
  const T d5_2 = s5_2 - T(0.262);
  const T d5_3 = s5_3 - T(0.173);
  // P5 = R3^T d5 + P3: position of the body origin, inertial axes [m]
  const T P5_1 = R3_11 * d5_1 + R3_21 * d5_2 + R3_31 * d5_3 + P3_1;
  const T P5_2 = R3_12 * d5_1 + R3_22 * d5_2 + R3_32 * d5_3 + P3_2;
  const T P5_3 = R3_13 * d5_1 + R3_23 * d5_2 + R3_33 * d5_3 + P3_3;
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_1 = R5_31 * T(0.167) - R5_11 * T(0.056) - R5_21 * T(0.321) + P5_1;
  const T p5_2 = R5_32 * T(0.167) - R5_12 * T(0.056) - R5_22 * T(0.321) + P5_2;
  const T p5_3 = R5_33 * T(0.167) - R5_13 * T(0.056) - R5_23 * T(0.321) + P5_3;
  pose[57] = p5_1;
  pose[58] = p5_2;
  pose[59] = p5_3;

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
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
  // d6 = q6 + s6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.304) + s6_1;
  const T d6_2 = s6_2 - T(0.214);
  const T d6_3 = T(0.436) + s6_3;
  // P6 = R2^T d6 + P2: position of the body origin, inertial axes [m]
  const T P6_1 = R2_11 * d6_1 + R2_21 * d6_2 + R2_31 * d6_3 + P2_1;
  const T P6_2 = R2_12 * d6_1 + R2_22 * d6_2 + R2_32 * d6_3 + P2_2;
  const T P6_3 = R2_13 * d6_1 + R2_23 * d6_2 + R2_33 * d6_3 + P2_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = R6_11 * T(0.044) - R6_21 * T(0.248) - R6_31 * T(0.454) + P6_1;
  const T p6_2 = R6_12 * T(0.044) - R6_22 * T(0.248) - R6_32 * T(0.454) + P6_2;
  const T p6_3 = R6_13 * T(0.044) - R6_23 * T(0.248) - R6_33 * T(0.454) + P6_3;
  pose[69] = p6_1;
  pose[70] = p6_2;
  pose[71] = p6_3;

  // ---- body 7 (body_7) on body 4
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
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
  pose[72] = R7_11;
  pose[73] = R7_12;
  pose[74] = R7_13;
  pose[75] = R7_21;
  pose[76] = R7_22;
  pose[77] = R7_23;
  pose[78] = R7_31;
  pose[79] = R7_32;
  pose[80] = R7_33;
  // d7 = q7 + s7: joint offset q + s, axes of the lower body [m]
  const T d7_1 = s7_1 - T(0.329);
  const T d7_2 = s7_2 - T(0.337);
  const T d7_3 = T(0.216) + s7_3;
  // P7 = R4^T d7 + P4: position of the body origin, inertial axes [m]
  const T P7_1 = R4_11 * d7_1 + R4_21 * d7_2 + R4_31 * d7_3 + P4_1;
  const T P7_2 = R4_12 * d7_1 + R4_22 * d7_2 + R4_32 * d7_3 + P4_2;
  const T P7_3 = R4_13 * d7_1 + R4_23 * d7_2 + R4_33 * d7_3 + P4_3;
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_1 = P7_1 - R7_11 * T(0.475) - R7_21 * T(0.192) - R7_31 * T(0.487);
  const T p7_2 = P7_2 - R7_12 * T(0.475) - R7_22 * T(0.192) - R7_32 * T(0.487);
  const T p7_3 = P7_3 - R7_13 * T(0.475) - R7_23 * T(0.192) - R7_33 * T(0.487);
  pose[81] = p7_1;
  pose[82] = p7_2;
  pose[83] = p7_3;

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
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
  pose[84] = R8_11;
  pose[85] = R8_12;
  pose[86] = R8_13;
  pose[87] = R8_21;
  pose[88] = R8_22;
  pose[89] = R8_23;
  pose[90] = R8_31;
  pose[91] = R8_32;
  pose[92] = R8_33;
  // d8 = q8 + s8: joint offset q + s, axes of the lower body [m]
  const T d8_1 = s8_1 - T(0.492);
  const T d8_2 = s8_2 - T(0.25);
  const T d8_3 = s8_3 - T(0.387);
  // P8 = s1 + R1^T d8: position of the body origin, inertial axes [m]
  const T P8_1 = s1_1 + R1_11 * d8_1 + R1_21 * d8_2 + R1_31 * d8_3;
  const T P8_2 = s1_2 + R1_12 * d8_1 + R1_22 * d8_2 + R1_32 * d8_3;
  const T P8_3 = s1_3 + R1_13 * d8_1 + R1_23 * d8_2 + R1_33 * d8_3;
  // p8 = R8^T r8 + P8: position of the mass centre, inertial axes [m]
  const T p8_1 = P8_1 - R8_11 * T(0.392) - R8_21 * T(0.416) - R8_31 * T(0.444);
  const T p8_2 = P8_2 - R8_12 * T(0.392) - R8_22 * T(0.416) - R8_32 * T(0.444);
  const T p8_3 = P8_3 - R8_13 * T(0.392) - R8_23 * T(0.416) - R8_33 * T(0.444);
  pose[93] = p8_1;
  pose[94] = p8_2;
  pose[95] = p8_3;

  // ---- body 9 (body_9) on body 6
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
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
  pose[96] = R9_11;
  pose[97] = R9_12;
  pose[98] = R9_13;
  pose[99] = R9_21;
  pose[100] = R9_22;
  pose[101] = R9_23;
  pose[102] = R9_31;
  pose[103] = R9_32;
  pose[104] = R9_33;
  // d9 = q9 + s9: joint offset q + s, axes of the lower body [m]
  const T d9_1 = s9_1 - T(0.305);
  const T d9_2 = T(0.124) + s9_2;
  const T d9_3 = T(0.036) + s9_3;
  // P9 = R6^T d9 + P6: position of the body origin, inertial axes [m]
  const T P9_1 = R6_11 * d9_1 + R6_21 * d9_2 + R6_31 * d9_3 + P6_1;
  const T P9_2 = R6_12 * d9_1 + R6_22 * d9_2 + R6_32 * d9_3 + P6_2;
  const T P9_3 = R6_13 * d9_1 + R6_23 * d9_2 + R6_33 * d9_3 + P6_3;
  // p9 = R9^T r9 + P9: position of the mass centre, inertial axes [m]
  const T p9_1 = R9_11 * T(0.362) + R9_21 * T(0.49) - R9_31 * T(0.015) + P9_1;
  const T p9_2 = R9_12 * T(0.362) + R9_22 * T(0.49) - R9_32 * T(0.015) + P9_2;
  const T p9_3 = R9_13 * T(0.362) + R9_23 * T(0.49) - R9_33 * T(0.015) + P9_3;
  pose[105] = p9_1;
  pose[106] = p9_2;
  pose[107] = p9_3;

  // ---- body 10 (body_10) on body 8
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
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
  pose[108] = R10_11;
  pose[109] = R10_12;
  pose[110] = R10_13;
  pose[111] = R10_21;
  pose[112] = R10_22;
  pose[113] = R10_23;
  pose[114] = R10_31;
  pose[115] = R10_32;
  pose[116] = R10_33;
  // d10 = q10 + s10: joint offset q + s, axes of the lower body [m]
  const T d10_1 = T(0.172) + s10_1;
  const T d10_2 = s10_2 - T(0.399);
  const T d10_3 = s10_3 - T(0.25);
  // P10 = R8^T d10 + P8: position of the body origin, inertial axes [m]
  const T P10_1 = R8_11 * d10_1 + R8_21 * d10_2 + R8_31 * d10_3 + P8_1;
  const T P10_2 = R8_12 * d10_1 + R8_22 * d10_2 + R8_32 * d10_3 + P8_2;
  const T P10_3 = R8_13 * d10_1 + R8_23 * d10_2 + R8_33 * d10_3 + P8_3;
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_1 = R10_11 * T(0.016) + R10_21 * T(0.148) - R10_31 * T(0.426) + P10_1;
  const T p10_2 = R10_12 * T(0.016) + R10_22 * T(0.148) - R10_32 * T(0.426) + P10_2;
  const T p10_3 = R10_13 * T(0.016) + R10_23 * T(0.148) - R10_33 * T(0.426) + P10_3;
  pose[117] = p10_1;
  pose[118] = p10_2;
  pose[119] = p10_3;

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
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
  pose[120] = R11_11;
  pose[121] = R11_12;
  pose[122] = R11_13;
  pose[123] = R11_21;
  pose[124] = R11_22;
  pose[125] = R11_23;
  pose[126] = R11_31;
  pose[127] = R11_32;
  pose[128] = R11_33;
  // d11 = q11 + s11: joint offset q + s, axes of the lower body [m]
  const T d11_1 = s11_1 - T(0.079);
  const T d11_2 = s11_2 - T(0.186);
  const T d11_3 = s11_3 - T(0.241);
  // P11 = R5^T d11 + P5: position of the body origin, inertial axes [m]
  const T P11_1 = R5_11 * d11_1 + R5_21 * d11_2 + R5_31 * d11_3 + P5_1;
  const T P11_2 = R5_12 * d11_1 + R5_22 * d11_2 + R5_32 * d11_3 + P5_2;
  const T P11_3 = R5_13 * d11_1 + R5_23 * d11_2 + R5_33 * d11_3 + P5_3;
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T p11_1 = R11_11 * T(0.402) - R11_21 * T(0.348) + R11_31 * T(0.337) + P11_1;
  const T p11_2 = R11_12 * T(0.402) - R11_22 * T(0.348) + R11_32 * T(0.337) + P11_2;
  const T p11_3 = R11_13 * T(0.402) - R11_23 * T(0.348) + R11_33 * T(0.337) + P11_3;
  pose[129] = p11_1;
  pose[130] = p11_2;
  pose[131] = p11_3;

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
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
  pose[132] = R12_11;
  pose[133] = R12_12;
  pose[134] = R12_13;
  pose[135] = R12_21;
  pose[136] = R12_22;
  pose[137] = R12_23;
  pose[138] = R12_31;
  pose[139] = R12_32;
  pose[140] = R12_33;
  // d12 = q12 + s12: joint offset q + s, axes of the lower body [m]
  const T d12_1 = s12_1 - T(0.422);
  const T d12_2 = T(0.42) + s12_2;
  const T d12_3 = T(0.022) + s12_3;
  // P12 = R11^T d12 + P11: position of the body origin, inertial axes [m]
  const T P12_1 = R11_11 * d12_1 + R11_21 * d12_2 + R11_31 * d12_3 + P11_1;
  const T P12_2 = R11_12 * d12_1 + R11_22 * d12_2 + R11_32 * d12_3 + P11_2;
  const T P12_3 = R11_13 * d12_1 + R11_23 * d12_2 + R11_33 * d12_3 + P11_3;
  // p12 = R12^T r12 + P12: position of the mass centre, inertial axes [m]
  const T p12_1 = P12_1 - R12_11 * T(0.006) - R12_21 * T(0.141) - R12_31 * T(0.1);
  const T p12_2 = P12_2 - R12_12 * T(0.006) - R12_22 * T(0.141) - R12_32 * T(0.1);
  const T p12_3 = P12_3 - R12_13 * T(0.006) - R12_23 * T(0.141) - R12_33 * T(0.1);
  pose[141] = p12_1;
  pose[142] = p12_2;
  pose[143] = p12_3;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 694 add, 772 multiply
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_3 = x[50];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[36], sdot1_2 = y[37], sdot1_3 = y[38];
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
  const T p1_3 = s1_3 + R1_13 * T(0.187) - R1_23 * T(0.163) - R1_33 * T(0.095);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_3 * T(0.163) - omega1_2 * T(0.095);
  const T t1_14 = omega1_3 * T(0.187) + omega1_1 * T(0.095);
  const T t1_15 = omega1_1 * T(0.163) + omega1_2 * T(0.187);
  const T v1_1 = sdot1_1 + R1_11 * t1_13 + R1_21 * t1_14 - R1_31 * t1_15;
  const T v1_2 = sdot1_2 + R1_12 * t1_13 + R1_22 * t1_14 - R1_32 * t1_15;
  const T v1_3 = sdot1_3 + R1_13 * t1_13 + R1_23 * t1_14 - R1_33 * t1_15;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.5) * (omega1_1 * (T(0.4836) * omega1_1 + T(0.0043) * omega1_2 + T(0.0129) * omega1_3) + omega1_2 *
      (T(0.0043) * omega1_1 + T(0.4244) * omega1_2 - T(0.0128) * omega1_3) + omega1_3 * (T(0.0129) * omega1_1 -
      T(0.0128) * omega1_2 + T(0.4825) * omega1_3)) + T(2.075) * (v1_1 * v1_1 + v1_2 * v1_2 + v1_3 * v1_3);

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[39], sdot2_2 = y[40], sdot2_3 = y[41];
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
  // d2 = q2 + s2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = s2_1 - T(0.472);
  const T d2_2 = T(0.323) + s2_2;
  const T d2_3 = s2_3 - T(0.07);
  // P2 = s1 + R1^T d2: position of the body origin, inertial axes [m]
  const T P2_3 = s1_3 + R1_13 * d2_1 + R1_23 * d2_2 + R1_33 * d2_3;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_3 = R2_13 * T(0.011) + R2_23 * T(0.31) + P2_3;
  // Pdot2 = sdot1 + R1^T (omega1~ d2 + sdot2): velocity of the body origin, inertial axes [m/s]
  const T t2_13 = omega1_2 * d2_3 - omega1_3 * d2_2 + sdot2_1;
  const T t2_14 = omega1_3 * d2_1 - omega1_1 * d2_3 + sdot2_2;
  const T t2_15 = omega1_1 * d2_2 - omega1_2 * d2_1 + sdot2_3;
  const T Pdot2_1 = sdot1_1 + R1_11 * t2_13 + R1_21 * t2_14 + R1_31 * t2_15;
  const T Pdot2_2 = sdot1_2 + R1_12 * t2_13 + R1_22 * t2_14 + R1_32 * t2_15;
  const T Pdot2_3 = sdot1_3 + R1_13 * t2_13 + R1_23 * t2_14 + R1_33 * t2_15;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_16 = omega2_3 * T(0.011);
  const T t2_17 = omega2_3 * T(0.31);
  const T t2_18 = omega2_1 * T(0.31) - omega2_2 * T(0.011);
  const T v2_1 = R2_21 * t2_16 - R2_11 * t2_17 + R2_31 * t2_18 + Pdot2_1;
  const T v2_2 = R2_22 * t2_16 - R2_12 * t2_17 + R2_32 * t2_18 + Pdot2_2;
  const T v2_3 = R2_23 * t2_16 - R2_13 * t2_17 + R2_33 * t2_18 + Pdot2_3;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (omega2_1 * (T(0.1195) * omega2_1 + T(1e-04) * omega2_2 + T(0.0037) * omega2_3) + omega2_2 *
      (T(1e-04) * omega2_1 + T(0.1199) * omega2_2 + T(0.0049) * omega2_3) + omega2_3 * (T(0.0037) * omega2_1 +
      T(0.0049) * omega2_2 + T(0.1451) * omega2_3)) + T(0.32) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[42], sdot3_2 = y[43], sdot3_3 = y[44];
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
  // d3 = q3 + s3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = s3_1 - T(0.476);
  const T d3_2 = s3_2 - T(0.178);
  const T d3_3 = T(0.287) + s3_3;
  // P3 = R2^T d3 + P2: position of the body origin, inertial axes [m]
  const T P3_3 = R2_13 * d3_1 + R2_23 * d3_2 + R2_33 * d3_3 + P2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_3 = R3_13 * T(0.484) + R3_23 * T(0.498) + R3_33 * T(0.004) + P3_3;
  // Pdot3 = R2^T (omega2~ d3 + sdot3) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_13 = omega2_2 * d3_3 - omega2_3 * d3_2 + sdot3_1;
  const T t3_14 = omega2_3 * d3_1 - omega2_1 * d3_3 + sdot3_2;
  const T t3_15 = omega2_1 * d3_2 - omega2_2 * d3_1 + sdot3_3;
  const T Pdot3_1 = R2_11 * t3_13 + R2_21 * t3_14 + R2_31 * t3_15 + Pdot2_1;
  const T Pdot3_2 = R2_12 * t3_13 + R2_22 * t3_14 + R2_32 * t3_15 + Pdot2_2;
  const T Pdot3_3 = R2_13 * t3_13 + R2_23 * t3_14 + R2_33 * t3_15 + Pdot2_3;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_16 = omega3_2 * T(0.004) - omega3_3 * T(0.498);
  const T t3_17 = omega3_3 * T(0.484) - omega3_1 * T(0.004);
  const T t3_18 = omega3_1 * T(0.498) - omega3_2 * T(0.484);
  const T v3_1 = R3_11 * t3_16 + R3_21 * t3_17 + R3_31 * t3_18 + Pdot3_1;
  const T v3_2 = R3_12 * t3_16 + R3_22 * t3_17 + R3_32 * t3_18 + Pdot3_2;
  const T v3_3 = R3_13 * t3_16 + R3_23 * t3_17 + R3_33 * t3_18 + Pdot3_3;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (omega3_1 * (T(0.3616) * omega3_1 + T(0.0388) * omega3_2 + T(0.038) * omega3_3) + omega3_2 *
      (T(0.0388) * omega3_1 + T(0.1986) * omega3_2 - T(0.0036) * omega3_3) + omega3_3 * (T(0.038) * omega3_1 -
      T(0.0036) * omega3_2 + T(0.2558) * omega3_3)) + T(1.07) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[45], sdot4_2 = y[46], sdot4_3 = y[47];
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
  // d4 = q4 + s4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = s4_1 - T(0.153);
  const T d4_2 = s4_2 - T(0.132);
  const T d4_3 = T(0.236) + s4_3;
  // P4 = R3^T d4 + P3: position of the body origin, inertial axes [m]
  const T P4_3 = R3_13 * d4_1 + R3_23 * d4_2 + R3_33 * d4_3 + P3_3;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_3 = R4_13 * T(0.401) + R4_23 * T(0.289) + R4_33 * T(0.08) + P4_3;
  // Pdot4 = R3^T (omega3~ d4 + sdot4) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = omega3_2 * d4_3 - omega3_3 * d4_2 + sdot4_1;
  const T t4_14 = omega3_3 * d4_1 - omega3_1 * d4_3 + sdot4_2;
  const T t4_15 = omega3_1 * d4_2 - omega3_2 * d4_1 + sdot4_3;
  const T Pdot4_1 = R3_11 * t4_13 + R3_21 * t4_14 + R3_31 * t4_15 + Pdot3_1;
  const T Pdot4_2 = R3_12 * t4_13 + R3_22 * t4_14 + R3_32 * t4_15 + Pdot3_2;
  const T Pdot4_3 = R3_13 * t4_13 + R3_23 * t4_14 + R3_33 * t4_15 + Pdot3_3;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_16 = omega4_2 * T(0.08) - omega4_3 * T(0.289);
  const T t4_17 = omega4_3 * T(0.401) - omega4_1 * T(0.08);
  const T t4_18 = omega4_1 * T(0.289) - omega4_2 * T(0.401);
  const T v4_1 = R4_11 * t4_16 + R4_21 * t4_17 + R4_31 * t4_18 + Pdot4_1;
  const T v4_2 = R4_12 * t4_16 + R4_22 * t4_17 + R4_32 * t4_18 + Pdot4_2;
  const T v4_3 = R4_13 * t4_16 + R4_23 * t4_17 + R4_33 * t4_18 + Pdot4_3;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (omega4_1 * (T(0.2551) * omega4_1 + T(0.0225) * omega4_2 - T(0.0283) * omega4_3) + omega4_2 *
      (T(0.0225) * omega4_1 + T(0.2397) * omega4_2 - T(0.0221) * omega4_3) + omega4_3 * (T(0.2408) * omega4_3 -
      T(0.0283) * omega4_1 - T(0.0221) * omega4_2)) + T(2.245) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[48], sdot5_2 = y[49], sdot5_3 = y[50];
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
  // d5 = q5 + s5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = s5_1 - T(0.159);
  const T d5_2 = s5_2 - T(0.262);
  const T d5_3 = s5_3 - T(0.173);
  // P5 = R3^T d5 + P3: position of the body origin, inertial axes [m]
  const T P5_3 = R3_13 * d5_1 + R3_23 * d5_2 + R3_33 * d5_3 + P3_3;
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_3 = R5_33 * T(0.167) - R5_13 * T(0.056) - R5_23 * T(0.321) + P5_3;
  // Pdot5 = R3^T (omega3~ d5 + sdot5) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t5_13 = omega3_2 * d5_3 - omega3_3 * d5_2 + sdot5_1;
  const T t5_14 = omega3_3 * d5_1 - omega3_1 * d5_3 + sdot5_2;
  const T t5_15 = omega3_1 * d5_2 - omega3_2 * d5_1 + sdot5_3;
  const T Pdot5_1 = R3_11 * t5_13 + R3_21 * t5_14 + R3_31 * t5_15 + Pdot3_1;
  const T Pdot5_2 = R3_12 * t5_13 + R3_22 * t5_14 + R3_32 * t5_15 + Pdot3_2;
  const T Pdot5_3 = R3_13 * t5_13 + R3_23 * t5_14 + R3_33 * t5_15 + Pdot3_3;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_16 = omega5_3 * T(0.321) + omega5_2 * T(0.167);
  const T t5_17 = omega5_3 * T(0.056) + omega5_1 * T(0.167);
  const T t5_18 = omega5_2 * T(0.056) - omega5_1 * T(0.321);
  const T v5_1 = R5_11 * t5_16 - R5_21 * t5_17 + R5_31 * t5_18 + Pdot5_1;
  const T v5_2 = R5_12 * t5_16 - R5_22 * t5_17 + R5_32 * t5_18 + Pdot5_2;
  const T v5_3 = R5_13 * t5_16 - R5_23 * t5_17 + R5_33 * t5_18 + Pdot5_3;
  // T5 = 1/2 omega5 . (I5 omega5) + 1/2 m5 v5 . v5: kinetic energy [J]
  const T T5 = T(0.5) * (omega5_1 * (T(0.0514) * omega5_1 + T(0.0396) * omega5_2 + T(0.0143) * omega5_3) + omega5_2 *
      (T(0.0396) * omega5_1 + T(0.1293) * omega5_2 - T(0.0036) * omega5_3) + omega5_3 * (T(0.0143) * omega5_1 -
      T(0.0036) * omega5_2 + T(0.141) * omega5_3)) + T(0.98) * (v5_1 * v5_1 + v5_2 * v5_2 + v5_3 * v5_3);

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[51], sdot6_2 = y[52], sdot6_3 = y[53];
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
  // d6 = q6 + s6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.304) + s6_1;
  const T d6_2 = s6_2 - T(0.214);
  const T d6_3 = T(0.436) + s6_3;
  // P6 = R2^T d6 + P2: position of the body origin, inertial axes [m]
  const T P6_3 = R2_13 * d6_1 + R2_23 * d6_2 + R2_33 * d6_3 + P2_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_3 = R6_13 * T(0.044) - R6_23 * T(0.248) - R6_33 * T(0.454) + P6_3;
  // Pdot6 = R2^T (omega2~ d6 + sdot6) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = omega2_2 * d6_3 - omega2_3 * d6_2 + sdot6_1;
  const T t6_14 = omega2_3 * d6_1 - omega2_1 * d6_3 + sdot6_2;
  const T t6_15 = omega2_1 * d6_2 - omega2_2 * d6_1 + sdot6_3;
  const T Pdot6_1 = R2_11 * t6_13 + R2_21 * t6_14 + R2_31 * t6_15 + Pdot2_1;
  const T Pdot6_2 = R2_12 * t6_13 + R2_22 * t6_14 + R2_32 * t6_15 + Pdot2_2;
  const T Pdot6_3 = R2_13 * t6_13 + R2_23 * t6_14 + R2_33 * t6_15 + Pdot2_3;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_16 = omega6_3 * T(0.248) - omega6_2 * T(0.454);
  const T t6_17 = omega6_3 * T(0.044) + omega6_1 * T(0.454);
  const T t6_18 = omega6_1 * T(0.248) + omega6_2 * T(0.044);
  const T v6_1 = R6_11 * t6_16 + R6_21 * t6_17 - R6_31 * t6_18 + Pdot6_1;
  const T v6_2 = R6_12 * t6_16 + R6_22 * t6_17 - R6_32 * t6_18 + Pdot6_2;
  const T v6_3 = R6_13 * t6_16 + R6_23 * t6_17 - R6_33 * t6_18 + Pdot6_3;
  // T6 = 1/2 omega6 . (I6 omega6) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (omega6_1 * (T(0.407) * omega6_1 + T(0.035) * omega6_2 + T(0.0493) * omega6_3) + omega6_2 *
      (T(0.035) * omega6_1 + T(0.5923) * omega6_2 + T(0.0219) * omega6_3) + omega6_3 * (T(0.0493) * omega6_1 +
      T(0.0219) * omega6_2 + T(0.5776) * omega6_3)) + T(1.74) * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- body 7 (body_7) on body 4
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  const T sdot7_1 = y[54], sdot7_2 = y[55], sdot7_3 = y[56];
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
  // d7 = q7 + s7: joint offset q + s, axes of the lower body [m]
  const T d7_1 = s7_1 - T(0.329);
  const T d7_2 = s7_2 - T(0.337);
  const T d7_3 = T(0.216) + s7_3;
  // P7 = R4^T d7 + P4: position of the body origin, inertial axes [m]
  const T P7_3 = R4_13 * d7_1 + R4_23 * d7_2 + R4_33 * d7_3 + P4_3;
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_3 = P7_3 - R7_13 * T(0.475) - R7_23 * T(0.192) - R7_33 * T(0.487);
  // Pdot7 = R4^T (omega4~ d7 + sdot7) + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t7_13 = omega4_2 * d7_3 - omega4_3 * d7_2 + sdot7_1;
  const T t7_14 = omega4_3 * d7_1 - omega4_1 * d7_3 + sdot7_2;
  const T t7_15 = omega4_1 * d7_2 - omega4_2 * d7_1 + sdot7_3;
  const T Pdot7_1 = R4_11 * t7_13 + R4_21 * t7_14 + R4_31 * t7_15 + Pdot4_1;
  const T Pdot7_2 = R4_12 * t7_13 + R4_22 * t7_14 + R4_32 * t7_15 + Pdot4_2;
  const T Pdot7_3 = R4_13 * t7_13 + R4_23 * t7_14 + R4_33 * t7_15 + Pdot4_3;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_16 = omega7_3 * T(0.192) - omega7_2 * T(0.487);
  const T t7_17 = omega7_1 * T(0.487) - omega7_3 * T(0.475);
  const T t7_18 = omega7_2 * T(0.475) - omega7_1 * T(0.192);
  const T v7_1 = R7_11 * t7_16 + R7_21 * t7_17 + R7_31 * t7_18 + Pdot7_1;
  const T v7_2 = R7_12 * t7_16 + R7_22 * t7_17 + R7_32 * t7_18 + Pdot7_2;
  const T v7_3 = R7_13 * t7_16 + R7_23 * t7_17 + R7_33 * t7_18 + Pdot7_3;
  // T7 = 1/2 omega7 . (I7 omega7) + 1/2 m7 v7 . v7: kinetic energy [J]
  const T T7 = T(0.5) * (omega7_1 * (T(0.133) * omega7_1 - T(7e-04) * omega7_2 + T(0.0025) * omega7_3) + omega7_2 *
      (T(0.136) * omega7_2 - T(7e-04) * omega7_1 + T(0.0017) * omega7_3) + omega7_3 * (T(0.0025) * omega7_1 +
      T(0.0017) * omega7_2 + T(0.1339) * omega7_3)) + T(0.37) * (v7_1 * v7_1 + v7_2 * v7_2 + v7_3 * v7_3);

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  const T sdot8_1 = y[57], sdot8_2 = y[58], sdot8_3 = y[59];
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
  // d8 = q8 + s8: joint offset q + s, axes of the lower body [m]
  const T d8_1 = s8_1 - T(0.492);
  const T d8_2 = s8_2 - T(0.25);
  const T d8_3 = s8_3 - T(0.387);
  // P8 = s1 + R1^T d8: position of the body origin, inertial axes [m]
  const T P8_3 = s1_3 + R1_13 * d8_1 + R1_23 * d8_2 + R1_33 * d8_3;
  // p8 = R8^T r8 + P8: position of the mass centre, inertial axes [m]
  const T p8_3 = P8_3 - R8_13 * T(0.392) - R8_23 * T(0.416) - R8_33 * T(0.444);
  // Pdot8 = sdot1 + R1^T (omega1~ d8 + sdot8): velocity of the body origin, inertial axes [m/s]
  const T t8_13 = omega1_2 * d8_3 - omega1_3 * d8_2 + sdot8_1;
  const T t8_14 = omega1_3 * d8_1 - omega1_1 * d8_3 + sdot8_2;
  const T t8_15 = omega1_1 * d8_2 - omega1_2 * d8_1 + sdot8_3;
  const T Pdot8_1 = sdot1_1 + R1_11 * t8_13 + R1_21 * t8_14 + R1_31 * t8_15;
  const T Pdot8_2 = sdot1_2 + R1_12 * t8_13 + R1_22 * t8_14 + R1_32 * t8_15;
  const T Pdot8_3 = sdot1_3 + R1_13 * t8_13 + R1_23 * t8_14 + R1_33 * t8_15;
  // v8 = R8^T omega8~ r8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_16 = omega8_3 * T(0.416) - omega8_2 * T(0.444);
  const T t8_17 = omega8_1 * T(0.444) - omega8_3 * T(0.392);
  const T t8_18 = omega8_2 * T(0.392) - omega8_1 * T(0.416);
  const T v8_1 = R8_11 * t8_16 + R8_21 * t8_17 + R8_31 * t8_18 + Pdot8_1;
  const T v8_2 = R8_12 * t8_16 + R8_22 * t8_17 + R8_32 * t8_18 + Pdot8_2;
  const T v8_3 = R8_13 * t8_16 + R8_23 * t8_17 + R8_33 * t8_18 + Pdot8_3;
  // T8 = 1/2 omega8 . (I8 omega8) + 1/2 m8 v8 . v8: kinetic energy [J]
  const T T8 = T(0.5) * (omega8_1 * (T(0.4492) * omega8_1 - T(0.0147) * omega8_2 - T(0.0399) * omega8_3) + omega8_2 *
      (T(0.4994) * omega8_2 - T(0.0147) * omega8_1 + T(0.028) * omega8_3) + omega8_3 * (T(0.028) * omega8_2 -
      T(0.0399) * omega8_1 + T(0.5166) * omega8_3)) + T(1.355) * (v8_1 * v8_1 + v8_2 * v8_2 + v8_3 * v8_3);

  // ---- body 9 (body_9) on body 6
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  const T sdot9_1 = y[60], sdot9_2 = y[61], sdot9_3 = y[62];
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
  // d9 = q9 + s9: joint offset q + s, axes of the lower body [m]
  const T d9_1 = s9_1 - T(0.305);
  const T d9_2 = T(0.124) + s9_2;
  const T d9_3 = T(0.036) + s9_3;
  // P9 = R6^T d9 + P6: position of the body origin, inertial axes [m]
  const T P9_3 = R6_13 * d9_1 + R6_23 * d9_2 + R6_33 * d9_3 + P6_3;
  // p9 = R9^T r9 + P9: position of the mass centre, inertial axes [m]
  const T p9_3 = R9_13 * T(0.362) + R9_23 * T(0.49) - R9_33 * T(0.015) + P9_3;
  // Pdot9 = R6^T (omega6~ d9 + sdot9) + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t9_13 = omega6_2 * d9_3 - omega6_3 * d9_2 + sdot9_1;
  const T t9_14 = omega6_3 * d9_1 - omega6_1 * d9_3 + sdot9_2;
  const T t9_15 = omega6_1 * d9_2 - omega6_2 * d9_1 + sdot9_3;
  const T Pdot9_1 = R6_11 * t9_13 + R6_21 * t9_14 + R6_31 * t9_15 + Pdot6_1;
  const T Pdot9_2 = R6_12 * t9_13 + R6_22 * t9_14 + R6_32 * t9_15 + Pdot6_2;
  const T Pdot9_3 = R6_13 * t9_13 + R6_23 * t9_14 + R6_33 * t9_15 + Pdot6_3;
  // v9 = R9^T omega9~ r9 + Pdot9: velocity of the mass centre, inertial axes [m/s]
  const T t9_16 = omega9_3 * T(0.362) + omega9_1 * T(0.015);
  const T t9_17 = omega9_3 * T(0.49) + omega9_2 * T(0.015);
  const T t9_18 = omega9_1 * T(0.49) - omega9_2 * T(0.362);
  const T v9_1 = R9_21 * t9_16 - R9_11 * t9_17 + R9_31 * t9_18 + Pdot9_1;
  const T v9_2 = R9_22 * t9_16 - R9_12 * t9_17 + R9_32 * t9_18 + Pdot9_2;
  const T v9_3 = R9_23 * t9_16 - R9_13 * t9_17 + R9_33 * t9_18 + Pdot9_3;
  // T9 = 1/2 omega9 . (I9 omega9) + 1/2 m9 v9 . v9: kinetic energy [J]
  const T T9 = T(0.5) * (omega9_1 * (T(0.231) * omega9_1 + T(0.0215) * omega9_2 + T(0.0257) * omega9_3) + omega9_2 *
      (T(0.0215) * omega9_1 + T(0.3032) * omega9_2 - T(0.0093) * omega9_3) + omega9_3 * (T(0.0257) * omega9_1 -
      T(0.0093) * omega9_2 + T(0.2809) * omega9_3)) + T(0.92) * (v9_1 * v9_1 + v9_2 * v9_2 + v9_3 * v9_3);

  // ---- body 10 (body_10) on body 8
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  const T sdot10_1 = y[63], sdot10_2 = y[64], sdot10_3 = y[65];
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
  // d10 = q10 + s10: joint offset q + s, axes of the lower body [m]
  const T d10_1 = T(0.172) + s10_1;
  const T d10_2 = s10_2 - T(0.399);
  const T d10_3 = s10_3 - T(0.25);
  // P10 = R8^T d10 + P8: position of the body origin, inertial axes [m]
  const T P10_3 = R8_13 * d10_1 + R8_23 * d10_2 + R8_33 * d10_3 + P8_3;
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_3 = R10_13 * T(0.016) + R10_23 * T(0.148) - R10_33 * T(0.426) + P10_3;
  // Pdot10 = R8^T (omega8~ d10 + sdot10) + Pdot8: velocity of the body origin, inertial axes [m/s]
  const T t10_13 = omega8_2 * d10_3 - omega8_3 * d10_2 + sdot10_1;
  const T t10_14 = omega8_3 * d10_1 - omega8_1 * d10_3 + sdot10_2;
  const T t10_15 = omega8_1 * d10_2 - omega8_2 * d10_1 + sdot10_3;
  const T Pdot10_1 = R8_11 * t10_13 + R8_21 * t10_14 + R8_31 * t10_15 + Pdot8_1;
  const T Pdot10_2 = R8_12 * t10_13 + R8_22 * t10_14 + R8_32 * t10_15 + Pdot8_2;
  const T Pdot10_3 = R8_13 * t10_13 + R8_23 * t10_14 + R8_33 * t10_15 + Pdot8_3;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_16 = omega10_3 * T(0.016) + omega10_1 * T(0.426);
  const T t10_17 = omega10_3 * T(0.148) + omega10_2 * T(0.426);
  const T t10_18 = omega10_1 * T(0.148) - omega10_2 * T(0.016);
  const T v10_1 = R10_21 * t10_16 - R10_11 * t10_17 + R10_31 * t10_18 + Pdot10_1;
  const T v10_2 = R10_22 * t10_16 - R10_12 * t10_17 + R10_32 * t10_18 + Pdot10_2;
  const T v10_3 = R10_23 * t10_16 - R10_13 * t10_17 + R10_33 * t10_18 + Pdot10_3;
  // T10 = 1/2 omega10 . (I10 omega10) + 1/2 m10 v10 . v10: kinetic energy [J]
  const T T10 = T(0.5) * (omega10_1 * (T(0.0833) * omega10_1 + T(0.0191) * omega10_2 + T(0.0097) * omega10_3) +
      omega10_2 * (T(0.0191) * omega10_1 + T(0.0917) * omega10_2 - T(0.0065) * omega10_3) + omega10_3 * (T(0.0097) *
      omega10_1 - T(0.0065) * omega10_2 + T(0.1089) * omega10_3)) + T(1.285) * (v10_1 * v10_1 + v10_2 * v10_2 + v10_3
      * v10_3);

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  const T sdot11_1 = y[66], sdot11_2 = y[67], sdot11_3 = y[68];
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
  // d11 = q11 + s11: joint offset q + s, axes of the lower body [m]
  const T d11_1 = s11_1 - T(0.079);
  const T d11_2 = s11_2 - T(0.186);
  const T d11_3 = s11_3 - T(0.241);
  // P11 = R5^T d11 + P5: position of the body origin, inertial axes [m]
  const T P11_3 = R5_13 * d11_1 + R5_23 * d11_2 + R5_33 * d11_3 + P5_3;
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T p11_3 = R11_13 * T(0.402) - R11_23 * T(0.348) + R11_33 * T(0.337) + P11_3;
  // Pdot11 = R5^T (omega5~ d11 + sdot11) + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t11_13 = omega5_2 * d11_3 - omega5_3 * d11_2 + sdot11_1;
  const T t11_14 = omega5_3 * d11_1 - omega5_1 * d11_3 + sdot11_2;
  const T t11_15 = omega5_1 * d11_2 - omega5_2 * d11_1 + sdot11_3;
  const T Pdot11_1 = R5_11 * t11_13 + R5_21 * t11_14 + R5_31 * t11_15 + Pdot5_1;
  const T Pdot11_2 = R5_12 * t11_13 + R5_22 * t11_14 + R5_32 * t11_15 + Pdot5_2;
  const T Pdot11_3 = R5_13 * t11_13 + R5_23 * t11_14 + R5_33 * t11_15 + Pdot5_3;
  // v11 = R11^T omega11~ r11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_16 = omega11_3 * T(0.348) + omega11_2 * T(0.337);
  const T t11_17 = omega11_3 * T(0.402) - omega11_1 * T(0.337);
  const T t11_18 = omega11_1 * T(0.348) + omega11_2 * T(0.402);
  const T v11_1 = R11_11 * t11_16 + R11_21 * t11_17 - R11_31 * t11_18 + Pdot11_1;
  const T v11_2 = R11_12 * t11_16 + R11_22 * t11_17 - R11_32 * t11_18 + Pdot11_2;
  const T v11_3 = R11_13 * t11_16 + R11_23 * t11_17 - R11_33 * t11_18 + Pdot11_3;
  // T11 = 1/2 omega11 . (I11 omega11) + 1/2 m11 v11 . v11: kinetic energy [J]
  const T T11 = T(0.5) * (omega11_1 * (T(0.3729) * omega11_1 - T(3e-04) * omega11_2 - T(0.0238) * omega11_3) +
      omega11_2 * (T(0.3903) * omega11_2 - T(3e-04) * omega11_1 + T(0.0124) * omega11_3) + omega11_3 * (T(0.0124) *
      omega11_2 - T(0.0238) * omega11_1 + T(0.4319) * omega11_3)) + T(1.885) * (v11_1 * v11_1 + v11_2 * v11_2 + v11_3
      * v11_3);

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  const T sdot12_1 = y[69], sdot12_2 = y[70], sdot12_3 = y[71];
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
  // d12 = q12 + s12: joint offset q + s, axes of the lower body [m]
  const T d12_1 = s12_1 - T(0.422);
  const T d12_2 = T(0.42) + s12_2;
  const T d12_3 = T(0.022) + s12_3;
  // P12 = R11^T d12 + P11: position of the body origin, inertial axes [m]
  const T P12_3 = R11_13 * d12_1 + R11_23 * d12_2 + R11_33 * d12_3 + P11_3;
  // p12 = R12^T r12 + P12: position of the mass centre, inertial axes [m]
  const T p12_3 = P12_3 - R12_13 * T(0.006) - R12_23 * T(0.141) - R12_33 * T(0.1);
  // Pdot12 = R11^T (omega11~ d12 + sdot12) + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_13 = omega11_2 * d12_3 - omega11_3 * d12_2 + sdot12_1;
  const T t12_14 = omega11_3 * d12_1 - omega11_1 * d12_3 + sdot12_2;
  const T t12_15 = omega11_1 * d12_2 - omega11_2 * d12_1 + sdot12_3;
  const T Pdot12_1 = R11_11 * t12_13 + R11_21 * t12_14 + R11_31 * t12_15 + Pdot11_1;
  const T Pdot12_2 = R11_12 * t12_13 + R11_22 * t12_14 + R11_32 * t12_15 + Pdot11_2;
  const T Pdot12_3 = R11_13 * t12_13 + R11_23 * t12_14 + R11_33 * t12_15 + Pdot11_3;
  // v12 = R12^T omega12~ r12 + Pdot12: velocity of the mass centre, inertial axes [m/s]
  const T t12_16 = omega12_3 * T(0.141) - omega12_2 * T(0.1);
  const T t12_17 = omega12_1 * T(0.1) - omega12_3 * T(0.006);
  const T t12_18 = omega12_2 * T(0.006) - omega12_1 * T(0.141);
  const T v12_1 = R12_11 * t12_16 + R12_21 * t12_17 + R12_31 * t12_18 + Pdot12_1;
  const T v12_2 = R12_12 * t12_16 + R12_22 * t12_17 + R12_32 * t12_18 + Pdot12_2;
  const T v12_3 = R12_13 * t12_16 + R12_23 * t12_17 + R12_33 * t12_18 + Pdot12_3;
  // T12 = 1/2 omega12 . (I12 omega12) + 1/2 m12 v12 . v12: kinetic energy [J]
  const T T12 = T(0.5) * (omega12_1 * (T(0.4137) * omega12_1 + T(0.0121) * omega12_2 - T(0.1084) * omega12_3) +
      omega12_2 * (T(0.0121) * omega12_1 + T(0.5952) * omega12_2 - T(0.0023) * omega12_3) + omega12_3 * (T(0.3276) *
      omega12_3 - T(0.1084) * omega12_1 - T(0.0023) * omega12_2)) + T(2.03) * (v12_1 * v12_1 + v12_2 * v12_2 + v12_3 *
      v12_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6 + m7 p7 + m8 p8 + m9 p9 + m10 p10 + m11 p11 + m12 p12: first
  //   moment of mass, inertial axes [kg m]
  const T mp_3 = T(4.15) * p1_3 + T(0.64) * p2_3 + T(2.14) * p3_3 + T(4.49) * p4_3 + T(1.96) * p5_3 + T(3.48) * p6_3 +
      T(0.74) * p7_3 + T(2.71) * p8_3 + T(1.84) * p9_3 + T(2.57) * p10_3 + T(3.77) * p11_3 + T(4.06) * p12_3;
  // potential = -g . mp: potential energy of gravity [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 958 add, 1015 multiply
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[48], s1_2 = x[49], s1_3 = x[50];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[36], sdot1_2 = y[37], sdot1_3 = y[38];
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
  const T p1_1 = s1_1 + R1_11 * T(0.187) - R1_21 * T(0.163) - R1_31 * T(0.095);
  const T p1_2 = s1_2 + R1_12 * T(0.187) - R1_22 * T(0.163) - R1_32 * T(0.095);
  const T p1_3 = s1_3 + R1_13 * T(0.187) - R1_23 * T(0.163) - R1_33 * T(0.095);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_3 * T(0.163) - omega1_2 * T(0.095);
  const T t1_14 = omega1_3 * T(0.187) + omega1_1 * T(0.095);
  const T t1_15 = omega1_1 * T(0.163) + omega1_2 * T(0.187);
  const T v1_1 = sdot1_1 + R1_11 * t1_13 + R1_21 * t1_14 - R1_31 * t1_15;
  const T v1_2 = sdot1_2 + R1_12 * t1_13 + R1_22 * t1_14 - R1_32 * t1_15;
  const T v1_3 = sdot1_3 + R1_13 * t1_13 + R1_23 * t1_14 - R1_33 * t1_15;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(4.15) * v1_1;
  const T l1_2 = T(4.15) * v1_2;
  const T l1_3 = T(4.15) * v1_3;
  // H1 = R1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_16 = T(0.4836) * omega1_1 + T(0.0043) * omega1_2 + T(0.0129) * omega1_3;
  const T t1_17 = T(0.0043) * omega1_1 + T(0.4244) * omega1_2 - T(0.0128) * omega1_3;
  const T t1_18 = T(0.0129) * omega1_1 - T(0.0128) * omega1_2 + T(0.4825) * omega1_3;
  const T H1_1 = R1_11 * t1_16 + R1_21 * t1_17 + R1_31 * t1_18 + p1_2 * l1_3 - p1_3 * l1_2;
  const T H1_2 = R1_12 * t1_16 + R1_22 * t1_17 + R1_32 * t1_18 + p1_3 * l1_1 - p1_1 * l1_3;
  const T H1_3 = R1_13 * t1_16 + R1_23 * t1_17 + R1_33 * t1_18 + p1_1 * l1_2 - p1_2 * l1_1;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[39], sdot2_2 = y[40], sdot2_3 = y[41];
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
  // d2 = q2 + s2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = s2_1 - T(0.472);
  const T d2_2 = T(0.323) + s2_2;
  const T d2_3 = s2_3 - T(0.07);
  // P2 = s1 + R1^T d2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * d2_1 + R1_21 * d2_2 + R1_31 * d2_3;
  const T P2_2 = s1_2 + R1_12 * d2_1 + R1_22 * d2_2 + R1_32 * d2_3;
  const T P2_3 = s1_3 + R1_13 * d2_1 + R1_23 * d2_2 + R1_33 * d2_3;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = R2_11 * T(0.011) + R2_21 * T(0.31) + P2_1;
  const T p2_2 = R2_12 * T(0.011) + R2_22 * T(0.31) + P2_2;
  const T p2_3 = R2_13 * T(0.011) + R2_23 * T(0.31) + P2_3;
  // Pdot2 = sdot1 + R1^T (omega1~ d2 + sdot2): velocity of the body origin, inertial axes [m/s]
  const T t2_13 = omega1_2 * d2_3 - omega1_3 * d2_2 + sdot2_1;
  const T t2_14 = omega1_3 * d2_1 - omega1_1 * d2_3 + sdot2_2;
  const T t2_15 = omega1_1 * d2_2 - omega1_2 * d2_1 + sdot2_3;
  const T Pdot2_1 = sdot1_1 + R1_11 * t2_13 + R1_21 * t2_14 + R1_31 * t2_15;
  const T Pdot2_2 = sdot1_2 + R1_12 * t2_13 + R1_22 * t2_14 + R1_32 * t2_15;
  const T Pdot2_3 = sdot1_3 + R1_13 * t2_13 + R1_23 * t2_14 + R1_33 * t2_15;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_16 = omega2_3 * T(0.011);
  const T t2_17 = omega2_3 * T(0.31);
  const T t2_18 = omega2_1 * T(0.31) - omega2_2 * T(0.011);
  const T v2_1 = R2_21 * t2_16 - R2_11 * t2_17 + R2_31 * t2_18 + Pdot2_1;
  const T v2_2 = R2_22 * t2_16 - R2_12 * t2_17 + R2_32 * t2_18 + Pdot2_2;
  const T v2_3 = R2_23 * t2_16 - R2_13 * t2_17 + R2_33 * t2_18 + Pdot2_3;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(0.64) * v2_1;
  const T l2_2 = T(0.64) * v2_2;
  const T l2_3 = T(0.64) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_19 = T(0.1195) * omega2_1 + T(1e-04) * omega2_2 + T(0.0037) * omega2_3;
  const T t2_20 = T(1e-04) * omega2_1 + T(0.1199) * omega2_2 + T(0.0049) * omega2_3;
  const T t2_21 = T(0.0037) * omega2_1 + T(0.0049) * omega2_2 + T(0.1451) * omega2_3;
  const T H2_1 = R2_11 * t2_19 + R2_21 * t2_20 + R2_31 * t2_21 + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = R2_12 * t2_19 + R2_22 * t2_20 + R2_32 * t2_21 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = R2_13 * t2_19 + R2_23 * t2_20 + R2_33 * t2_21 + p2_1 * l2_2 - p2_2 * l2_1;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[42], sdot3_2 = y[43], sdot3_3 = y[44];
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
  // d3 = q3 + s3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = s3_1 - T(0.476);
  const T d3_2 = s3_2 - T(0.178);
  const T d3_3 = T(0.287) + s3_3;
  // P3 = R2^T d3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = R2_11 * d3_1 + R2_21 * d3_2 + R2_31 * d3_3 + P2_1;
  const T P3_2 = R2_12 * d3_1 + R2_22 * d3_2 + R2_32 * d3_3 + P2_2;
  const T P3_3 = R2_13 * d3_1 + R2_23 * d3_2 + R2_33 * d3_3 + P2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = R3_11 * T(0.484) + R3_21 * T(0.498) + R3_31 * T(0.004) + P3_1;
  const T p3_2 = R3_12 * T(0.484) + R3_22 * T(0.498) + R3_32 * T(0.004) + P3_2;
  const T p3_3 = R3_13 * T(0.484) + R3_23 * T(0.498) + R3_33 * T(0.004) + P3_3;
  // Pdot3 = R2^T (omega2~ d3 + sdot3) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_13 = omega2_2 * d3_3 - omega2_3 * d3_2 + sdot3_1;
  const T t3_14 = omega2_3 * d3_1 - omega2_1 * d3_3 + sdot3_2;
  const T t3_15 = omega2_1 * d3_2 - omega2_2 * d3_1 + sdot3_3;
  const T Pdot3_1 = R2_11 * t3_13 + R2_21 * t3_14 + R2_31 * t3_15 + Pdot2_1;
  const T Pdot3_2 = R2_12 * t3_13 + R2_22 * t3_14 + R2_32 * t3_15 + Pdot2_2;
  const T Pdot3_3 = R2_13 * t3_13 + R2_23 * t3_14 + R2_33 * t3_15 + Pdot2_3;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_16 = omega3_2 * T(0.004) - omega3_3 * T(0.498);
  const T t3_17 = omega3_3 * T(0.484) - omega3_1 * T(0.004);
  const T t3_18 = omega3_1 * T(0.498) - omega3_2 * T(0.484);
  const T v3_1 = R3_11 * t3_16 + R3_21 * t3_17 + R3_31 * t3_18 + Pdot3_1;
  const T v3_2 = R3_12 * t3_16 + R3_22 * t3_17 + R3_32 * t3_18 + Pdot3_2;
  const T v3_3 = R3_13 * t3_16 + R3_23 * t3_17 + R3_33 * t3_18 + Pdot3_3;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(2.14) * v3_1;
  const T l3_2 = T(2.14) * v3_2;
  const T l3_3 = T(2.14) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_19 = T(0.3616) * omega3_1 + T(0.0388) * omega3_2 + T(0.038) * omega3_3;
  const T t3_20 = T(0.0388) * omega3_1 + T(0.1986) * omega3_2 - T(0.0036) * omega3_3;
  const T t3_21 = T(0.038) * omega3_1 - T(0.0036) * omega3_2 + T(0.2558) * omega3_3;
  const T H3_1 = R3_11 * t3_19 + R3_21 * t3_20 + R3_31 * t3_21 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = R3_12 * t3_19 + R3_22 * t3_20 + R3_32 * t3_21 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R3_13 * t3_19 + R3_23 * t3_20 + R3_33 * t3_21 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[45], sdot4_2 = y[46], sdot4_3 = y[47];
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
  // d4 = q4 + s4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = s4_1 - T(0.153);
  const T d4_2 = s4_2 - T(0.132);
  const T d4_3 = T(0.236) + s4_3;
  // P4 = R3^T d4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = R3_11 * d4_1 + R3_21 * d4_2 + R3_31 * d4_3 + P3_1;
  const T P4_2 = R3_12 * d4_1 + R3_22 * d4_2 + R3_32 * d4_3 + P3_2;
  const T P4_3 = R3_13 * d4_1 + R3_23 * d4_2 + R3_33 * d4_3 + P3_3;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = R4_11 * T(0.401) + R4_21 * T(0.289) + R4_31 * T(0.08) + P4_1;
  const T p4_2 = R4_12 * T(0.401) + R4_22 * T(0.289) + R4_32 * T(0.08) + P4_2;
  const T p4_3 = R4_13 * T(0.401) + R4_23 * T(0.289) + R4_33 * T(0.08) + P4_3;
  // Pdot4 = R3^T (omega3~ d4 + sdot4) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = omega3_2 * d4_3 - omega3_3 * d4_2 + sdot4_1;
  const T t4_14 = omega3_3 * d4_1 - omega3_1 * d4_3 + sdot4_2;
  const T t4_15 = omega3_1 * d4_2 - omega3_2 * d4_1 + sdot4_3;
  const T Pdot4_1 = R3_11 * t4_13 + R3_21 * t4_14 + R3_31 * t4_15 + Pdot3_1;
  const T Pdot4_2 = R3_12 * t4_13 + R3_22 * t4_14 + R3_32 * t4_15 + Pdot3_2;
  const T Pdot4_3 = R3_13 * t4_13 + R3_23 * t4_14 + R3_33 * t4_15 + Pdot3_3;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_16 = omega4_2 * T(0.08) - omega4_3 * T(0.289);
  const T t4_17 = omega4_3 * T(0.401) - omega4_1 * T(0.08);
  const T t4_18 = omega4_1 * T(0.289) - omega4_2 * T(0.401);
  const T v4_1 = R4_11 * t4_16 + R4_21 * t4_17 + R4_31 * t4_18 + Pdot4_1;
  const T v4_2 = R4_12 * t4_16 + R4_22 * t4_17 + R4_32 * t4_18 + Pdot4_2;
  const T v4_3 = R4_13 * t4_16 + R4_23 * t4_17 + R4_33 * t4_18 + Pdot4_3;
  // l4 = m4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(4.49) * v4_1;
  const T l4_2 = T(4.49) * v4_2;
  const T l4_3 = T(4.49) * v4_3;
  // H4 = R4^T I4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_19 = T(0.2551) * omega4_1 + T(0.0225) * omega4_2 - T(0.0283) * omega4_3;
  const T t4_20 = T(0.0225) * omega4_1 + T(0.2397) * omega4_2 - T(0.0221) * omega4_3;
  const T t4_21 = T(0.2408) * omega4_3 - T(0.0283) * omega4_1 - T(0.0221) * omega4_2;
  const T H4_1 = R4_11 * t4_19 + R4_21 * t4_20 + R4_31 * t4_21 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_19 + R4_22 * t4_20 + R4_32 * t4_21 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R4_13 * t4_19 + R4_23 * t4_20 + R4_33 * t4_21 + p4_1 * l4_2 - p4_2 * l4_1;

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[48], sdot5_2 = y[49], sdot5_3 = y[50];
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
  // d5 = q5 + s5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = s5_1 - T(0.159);
  const T d5_2 = s5_2 - T(0.262);
  const T d5_3 = s5_3 - T(0.173);
  // P5 = R3^T d5 + P3: position of the body origin, inertial axes [m]
  const T P5_1 = R3_11 * d5_1 + R3_21 * d5_2 + R3_31 * d5_3 + P3_1;
  const T P5_2 = R3_12 * d5_1 + R3_22 * d5_2 + R3_32 * d5_3 + P3_2;
  const T P5_3 = R3_13 * d5_1 + R3_23 * d5_2 + R3_33 * d5_3 + P3_3;
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_1 = R5_31 * T(0.167) - R5_11 * T(0.056) - R5_21 * T(0.321) + P5_1;
  const T p5_2 = R5_32 * T(0.167) - R5_12 * T(0.056) - R5_22 * T(0.321) + P5_2;
  const T p5_3 = R5_33 * T(0.167) - R5_13 * T(0.056) - R5_23 * T(0.321) + P5_3;
  // Pdot5 = R3^T (omega3~ d5 + sdot5) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t5_13 = omega3_2 * d5_3 - omega3_3 * d5_2 + sdot5_1;
  const T t5_14 = omega3_3 * d5_1 - omega3_1 * d5_3 + sdot5_2;
  const T t5_15 = omega3_1 * d5_2 - omega3_2 * d5_1 + sdot5_3;
  const T Pdot5_1 = R3_11 * t5_13 + R3_21 * t5_14 + R3_31 * t5_15 + Pdot3_1;
  const T Pdot5_2 = R3_12 * t5_13 + R3_22 * t5_14 + R3_32 * t5_15 + Pdot3_2;
  const T Pdot5_3 = R3_13 * t5_13 + R3_23 * t5_14 + R3_33 * t5_15 + Pdot3_3;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_16 = omega5_3 * T(0.321) + omega5_2 * T(0.167);
  const T t5_17 = omega5_3 * T(0.056) + omega5_1 * T(0.167);
  const T t5_18 = omega5_2 * T(0.056) - omega5_1 * T(0.321);
  const T v5_1 = R5_11 * t5_16 - R5_21 * t5_17 + R5_31 * t5_18 + Pdot5_1;
  const T v5_2 = R5_12 * t5_16 - R5_22 * t5_17 + R5_32 * t5_18 + Pdot5_2;
  const T v5_3 = R5_13 * t5_16 - R5_23 * t5_17 + R5_33 * t5_18 + Pdot5_3;
  // l5 = m5 v5: linear momentum, inertial axes [kg m/s]
  const T l5_1 = T(1.96) * v5_1;
  const T l5_2 = T(1.96) * v5_2;
  const T l5_3 = T(1.96) * v5_3;
  // H5 = R5^T I5 omega5 + p5~ l5: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t5_19 = T(0.0514) * omega5_1 + T(0.0396) * omega5_2 + T(0.0143) * omega5_3;
  const T t5_20 = T(0.0396) * omega5_1 + T(0.1293) * omega5_2 - T(0.0036) * omega5_3;
  const T t5_21 = T(0.0143) * omega5_1 - T(0.0036) * omega5_2 + T(0.141) * omega5_3;
  const T H5_1 = R5_11 * t5_19 + R5_21 * t5_20 + R5_31 * t5_21 + p5_2 * l5_3 - p5_3 * l5_2;
  const T H5_2 = R5_12 * t5_19 + R5_22 * t5_20 + R5_32 * t5_21 + p5_3 * l5_1 - p5_1 * l5_3;
  const T H5_3 = R5_13 * t5_19 + R5_23 * t5_20 + R5_33 * t5_21 + p5_1 * l5_2 - p5_2 * l5_1;

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[51], sdot6_2 = y[52], sdot6_3 = y[53];
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
  // d6 = q6 + s6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.304) + s6_1;
  const T d6_2 = s6_2 - T(0.214);
  const T d6_3 = T(0.436) + s6_3;
  // P6 = R2^T d6 + P2: position of the body origin, inertial axes [m]
  const T P6_1 = R2_11 * d6_1 + R2_21 * d6_2 + R2_31 * d6_3 + P2_1;
  const T P6_2 = R2_12 * d6_1 + R2_22 * d6_2 + R2_32 * d6_3 + P2_2;
  const T P6_3 = R2_13 * d6_1 + R2_23 * d6_2 + R2_33 * d6_3 + P2_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = R6_11 * T(0.044) - R6_21 * T(0.248) - R6_31 * T(0.454) + P6_1;
  const T p6_2 = R6_12 * T(0.044) - R6_22 * T(0.248) - R6_32 * T(0.454) + P6_2;
  const T p6_3 = R6_13 * T(0.044) - R6_23 * T(0.248) - R6_33 * T(0.454) + P6_3;
  // Pdot6 = R2^T (omega2~ d6 + sdot6) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = omega2_2 * d6_3 - omega2_3 * d6_2 + sdot6_1;
  const T t6_14 = omega2_3 * d6_1 - omega2_1 * d6_3 + sdot6_2;
  const T t6_15 = omega2_1 * d6_2 - omega2_2 * d6_1 + sdot6_3;
  const T Pdot6_1 = R2_11 * t6_13 + R2_21 * t6_14 + R2_31 * t6_15 + Pdot2_1;
  const T Pdot6_2 = R2_12 * t6_13 + R2_22 * t6_14 + R2_32 * t6_15 + Pdot2_2;
  const T Pdot6_3 = R2_13 * t6_13 + R2_23 * t6_14 + R2_33 * t6_15 + Pdot2_3;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_16 = omega6_3 * T(0.248) - omega6_2 * T(0.454);
  const T t6_17 = omega6_3 * T(0.044) + omega6_1 * T(0.454);
  const T t6_18 = omega6_1 * T(0.248) + omega6_2 * T(0.044);
  const T v6_1 = R6_11 * t6_16 + R6_21 * t6_17 - R6_31 * t6_18 + Pdot6_1;
  const T v6_2 = R6_12 * t6_16 + R6_22 * t6_17 - R6_32 * t6_18 + Pdot6_2;
  const T v6_3 = R6_13 * t6_16 + R6_23 * t6_17 - R6_33 * t6_18 + Pdot6_3;
  // l6 = m6 v6: linear momentum, inertial axes [kg m/s]
  const T l6_1 = T(3.48) * v6_1;
  const T l6_2 = T(3.48) * v6_2;
  const T l6_3 = T(3.48) * v6_3;
  // H6 = R6^T I6 omega6 + p6~ l6: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t6_19 = T(0.407) * omega6_1 + T(0.035) * omega6_2 + T(0.0493) * omega6_3;
  const T t6_20 = T(0.035) * omega6_1 + T(0.5923) * omega6_2 + T(0.0219) * omega6_3;
  const T t6_21 = T(0.0493) * omega6_1 + T(0.0219) * omega6_2 + T(0.5776) * omega6_3;
  const T H6_1 = R6_11 * t6_19 + R6_21 * t6_20 + R6_31 * t6_21 + p6_2 * l6_3 - p6_3 * l6_2;
  const T H6_2 = R6_12 * t6_19 + R6_22 * t6_20 + R6_32 * t6_21 + p6_3 * l6_1 - p6_1 * l6_3;
  const T H6_3 = R6_13 * t6_19 + R6_23 * t6_20 + R6_33 * t6_21 + p6_1 * l6_2 - p6_2 * l6_1;

  // ---- body 7 (body_7) on body 4
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  const T sdot7_1 = y[54], sdot7_2 = y[55], sdot7_3 = y[56];
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
  // d7 = q7 + s7: joint offset q + s, axes of the lower body [m]
  const T d7_1 = s7_1 - T(0.329);
  const T d7_2 = s7_2 - T(0.337);
  const T d7_3 = T(0.216) + s7_3;
  // P7 = R4^T d7 + P4: position of the body origin, inertial axes [m]
  const T P7_1 = R4_11 * d7_1 + R4_21 * d7_2 + R4_31 * d7_3 + P4_1;
  const T P7_2 = R4_12 * d7_1 + R4_22 * d7_2 + R4_32 * d7_3 + P4_2;
  const T P7_3 = R4_13 * d7_1 + R4_23 * d7_2 + R4_33 * d7_3 + P4_3;
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_1 = P7_1 - R7_11 * T(0.475) - R7_21 * T(0.192) - R7_31 * T(0.487);
  const T p7_2 = P7_2 - R7_12 * T(0.475) - R7_22 * T(0.192) - R7_32 * T(0.487);
  const T p7_3 = P7_3 - R7_13 * T(0.475) - R7_23 * T(0.192) - R7_33 * T(0.487);
  // Pdot7 = R4^T (omega4~ d7 + sdot7) + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t7_13 = omega4_2 * d7_3 - omega4_3 * d7_2 + sdot7_1;
  const T t7_14 = omega4_3 * d7_1 - omega4_1 * d7_3 + sdot7_2;
  const T t7_15 = omega4_1 * d7_2 - omega4_2 * d7_1 + sdot7_3;
  const T Pdot7_1 = R4_11 * t7_13 + R4_21 * t7_14 + R4_31 * t7_15 + Pdot4_1;
  const T Pdot7_2 = R4_12 * t7_13 + R4_22 * t7_14 + R4_32 * t7_15 + Pdot4_2;
  const T Pdot7_3 = R4_13 * t7_13 + R4_23 * t7_14 + R4_33 * t7_15 + Pdot4_3;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_16 = omega7_3 * T(0.192) - omega7_2 * T(0.487);
  const T t7_17 = omega7_1 * T(0.487) - omega7_3 * T(0.475);
  const T t7_18 = omega7_2 * T(0.475) - omega7_1 * T(0.192);
  const T v7_1 = R7_11 * t7_16 + R7_21 * t7_17 + R7_31 * t7_18 + Pdot7_1;
  const T v7_2 = R7_12 * t7_16 + R7_22 * t7_17 + R7_32 * t7_18 + Pdot7_2;
  const T v7_3 = R7_13 * t7_16 + R7_23 * t7_17 + R7_33 * t7_18 + Pdot7_3;
  // l7 = m7 v7: linear momentum, inertial axes [kg m/s]
  const T l7_1 = T(0.74) * v7_1;
  const T l7_2 = T(0.74) * v7_2;
  const T l7_3 = T(0.74) * v7_3;
  // H7 = R7^T I7 omega7 + p7~ l7: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t7_19 = T(0.133) * omega7_1 - T(7e-04) * omega7_2 + T(0.0025) * omega7_3;
  const T t7_20 = T(0.136) * omega7_2 - T(7e-04) * omega7_1 + T(0.0017) * omega7_3;
  const T t7_21 = T(0.0025) * omega7_1 + T(0.0017) * omega7_2 + T(0.1339) * omega7_3;
  const T H7_1 = R7_11 * t7_19 + R7_21 * t7_20 + R7_31 * t7_21 + p7_2 * l7_3 - p7_3 * l7_2;
  const T H7_2 = R7_12 * t7_19 + R7_22 * t7_20 + R7_32 * t7_21 + p7_3 * l7_1 - p7_1 * l7_3;
  const T H7_3 = R7_13 * t7_19 + R7_23 * t7_20 + R7_33 * t7_21 + p7_1 * l7_2 - p7_2 * l7_1;

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  const T sdot8_1 = y[57], sdot8_2 = y[58], sdot8_3 = y[59];
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
  // d8 = q8 + s8: joint offset q + s, axes of the lower body [m]
  const T d8_1 = s8_1 - T(0.492);
  const T d8_2 = s8_2 - T(0.25);
  const T d8_3 = s8_3 - T(0.387);
  // P8 = s1 + R1^T d8: position of the body origin, inertial axes [m]
  const T P8_1 = s1_1 + R1_11 * d8_1 + R1_21 * d8_2 + R1_31 * d8_3;
  const T P8_2 = s1_2 + R1_12 * d8_1 + R1_22 * d8_2 + R1_32 * d8_3;
  const T P8_3 = s1_3 + R1_13 * d8_1 + R1_23 * d8_2 + R1_33 * d8_3;
  // p8 = R8^T r8 + P8: position of the mass centre, inertial axes [m]
  const T p8_1 = P8_1 - R8_11 * T(0.392) - R8_21 * T(0.416) - R8_31 * T(0.444);
  const T p8_2 = P8_2 - R8_12 * T(0.392) - R8_22 * T(0.416) - R8_32 * T(0.444);
  const T p8_3 = P8_3 - R8_13 * T(0.392) - R8_23 * T(0.416) - R8_33 * T(0.444);
  // Pdot8 = sdot1 + R1^T (omega1~ d8 + sdot8): velocity of the body origin, inertial axes [m/s]
  const T t8_13 = omega1_2 * d8_3 - omega1_3 * d8_2 + sdot8_1;
  const T t8_14 = omega1_3 * d8_1 - omega1_1 * d8_3 + sdot8_2;
  const T t8_15 = omega1_1 * d8_2 - omega1_2 * d8_1 + sdot8_3;
  const T Pdot8_1 = sdot1_1 + R1_11 * t8_13 + R1_21 * t8_14 + R1_31 * t8_15;
  const T Pdot8_2 = sdot1_2 + R1_12 * t8_13 + R1_22 * t8_14 + R1_32 * t8_15;
  const T Pdot8_3 = sdot1_3 + R1_13 * t8_13 + R1_23 * t8_14 + R1_33 * t8_15;
  // v8 = R8^T omega8~ r8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_16 = omega8_3 * T(0.416) - omega8_2 * T(0.444);
  const T t8_17 = omega8_1 * T(0.444) - omega8_3 * T(0.392);
  const T t8_18 = omega8_2 * T(0.392) - omega8_1 * T(0.416);
  const T v8_1 = R8_11 * t8_16 + R8_21 * t8_17 + R8_31 * t8_18 + Pdot8_1;
  const T v8_2 = R8_12 * t8_16 + R8_22 * t8_17 + R8_32 * t8_18 + Pdot8_2;
  const T v8_3 = R8_13 * t8_16 + R8_23 * t8_17 + R8_33 * t8_18 + Pdot8_3;
  // l8 = m8 v8: linear momentum, inertial axes [kg m/s]
  const T l8_1 = T(2.71) * v8_1;
  const T l8_2 = T(2.71) * v8_2;
  const T l8_3 = T(2.71) * v8_3;
  // H8 = R8^T I8 omega8 + p8~ l8: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t8_19 = T(0.4492) * omega8_1 - T(0.0147) * omega8_2 - T(0.0399) * omega8_3;
  const T t8_20 = T(0.4994) * omega8_2 - T(0.0147) * omega8_1 + T(0.028) * omega8_3;
  const T t8_21 = T(0.028) * omega8_2 - T(0.0399) * omega8_1 + T(0.5166) * omega8_3;
  const T H8_1 = R8_11 * t8_19 + R8_21 * t8_20 + R8_31 * t8_21 + p8_2 * l8_3 - p8_3 * l8_2;
  const T H8_2 = R8_12 * t8_19 + R8_22 * t8_20 + R8_32 * t8_21 + p8_3 * l8_1 - p8_1 * l8_3;
  const T H8_3 = R8_13 * t8_19 + R8_23 * t8_20 + R8_33 * t8_21 + p8_1 * l8_2 - p8_2 * l8_1;

  // ---- body 9 (body_9) on body 6
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  const T sdot9_1 = y[60], sdot9_2 = y[61], sdot9_3 = y[62];
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
  // d9 = q9 + s9: joint offset q + s, axes of the lower body [m]
  const T d9_1 = s9_1 - T(0.305);
  const T d9_2 = T(0.124) + s9_2;
  const T d9_3 = T(0.036) + s9_3;
  // P9 = R6^T d9 + P6: position of the body origin, inertial axes [m]
  const T P9_1 = R6_11 * d9_1 + R6_21 * d9_2 + R6_31 * d9_3 + P6_1;
  const T P9_2 = R6_12 * d9_1 + R6_22 * d9_2 + R6_32 * d9_3 + P6_2;
  const T P9_3 = R6_13 * d9_1 + R6_23 * d9_2 + R6_33 * d9_3 + P6_3;
  // p9 = R9^T r9 + P9: position of the mass centre, inertial axes [m]
  const T p9_1 = R9_11 * T(0.362) + R9_21 * T(0.49) - R9_31 * T(0.015) + P9_1;
  const T p9_2 = R9_12 * T(0.362) + R9_22 * T(0.49) - R9_32 * T(0.015) + P9_2;
  const T p9_3 = R9_13 * T(0.362) + R9_23 * T(0.49) - R9_33 * T(0.015) + P9_3;
  // Pdot9 = R6^T (omega6~ d9 + sdot9) + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t9_13 = omega6_2 * d9_3 - omega6_3 * d9_2 + sdot9_1;
  const T t9_14 = omega6_3 * d9_1 - omega6_1 * d9_3 + sdot9_2;
  const T t9_15 = omega6_1 * d9_2 - omega6_2 * d9_1 + sdot9_3;
  const T Pdot9_1 = R6_11 * t9_13 + R6_21 * t9_14 + R6_31 * t9_15 + Pdot6_1;
  const T Pdot9_2 = R6_12 * t9_13 + R6_22 * t9_14 + R6_32 * t9_15 + Pdot6_2;
  const T Pdot9_3 = R6_13 * t9_13 + R6_23 * t9_14 + R6_33 * t9_15 + Pdot6_3;
  // v9 = R9^T omega9~ r9 + Pdot9: velocity of the mass centre, inertial axes [m/s]
  const T t9_16 = omega9_3 * T(0.362) + omega9_1 * T(0.015);
  const T t9_17 = omega9_3 * T(0.49) + omega9_2 * T(0.015);
  const T t9_18 = omega9_1 * T(0.49) - omega9_2 * T(0.362);
  const T v9_1 = R9_21 * t9_16 - R9_11 * t9_17 + R9_31 * t9_18 + Pdot9_1;
  const T v9_2 = R9_22 * t9_16 - R9_12 * t9_17 + R9_32 * t9_18 + Pdot9_2;
  const T v9_3 = R9_23 * t9_16 - R9_13 * t9_17 + R9_33 * t9_18 + Pdot9_3;
  // l9 = m9 v9: linear momentum, inertial axes [kg m/s]
  const T l9_1 = T(1.84) * v9_1;
  const T l9_2 = T(1.84) * v9_2;
  const T l9_3 = T(1.84) * v9_3;
  // H9 = R9^T I9 omega9 + p9~ l9: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t9_19 = T(0.231) * omega9_1 + T(0.0215) * omega9_2 + T(0.0257) * omega9_3;
  const T t9_20 = T(0.0215) * omega9_1 + T(0.3032) * omega9_2 - T(0.0093) * omega9_3;
  const T t9_21 = T(0.0257) * omega9_1 - T(0.0093) * omega9_2 + T(0.2809) * omega9_3;
  const T H9_1 = R9_11 * t9_19 + R9_21 * t9_20 + R9_31 * t9_21 + p9_2 * l9_3 - p9_3 * l9_2;
  const T H9_2 = R9_12 * t9_19 + R9_22 * t9_20 + R9_32 * t9_21 + p9_3 * l9_1 - p9_1 * l9_3;
  const T H9_3 = R9_13 * t9_19 + R9_23 * t9_20 + R9_33 * t9_21 + p9_1 * l9_2 - p9_2 * l9_1;

  // ---- body 10 (body_10) on body 8
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  const T sdot10_1 = y[63], sdot10_2 = y[64], sdot10_3 = y[65];
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
  // d10 = q10 + s10: joint offset q + s, axes of the lower body [m]
  const T d10_1 = T(0.172) + s10_1;
  const T d10_2 = s10_2 - T(0.399);
  const T d10_3 = s10_3 - T(0.25);
  // P10 = R8^T d10 + P8: position of the body origin, inertial axes [m]
  const T P10_1 = R8_11 * d10_1 + R8_21 * d10_2 + R8_31 * d10_3 + P8_1;
  const T P10_2 = R8_12 * d10_1 + R8_22 * d10_2 + R8_32 * d10_3 + P8_2;
  const T P10_3 = R8_13 * d10_1 + R8_23 * d10_2 + R8_33 * d10_3 + P8_3;
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_1 = R10_11 * T(0.016) + R10_21 * T(0.148) - R10_31 * T(0.426) + P10_1;
  const T p10_2 = R10_12 * T(0.016) + R10_22 * T(0.148) - R10_32 * T(0.426) + P10_2;
  const T p10_3 = R10_13 * T(0.016) + R10_23 * T(0.148) - R10_33 * T(0.426) + P10_3;
  // Pdot10 = R8^T (omega8~ d10 + sdot10) + Pdot8: velocity of the body origin, inertial axes [m/s]
  const T t10_13 = omega8_2 * d10_3 - omega8_3 * d10_2 + sdot10_1;
  const T t10_14 = omega8_3 * d10_1 - omega8_1 * d10_3 + sdot10_2;
  const T t10_15 = omega8_1 * d10_2 - omega8_2 * d10_1 + sdot10_3;
  const T Pdot10_1 = R8_11 * t10_13 + R8_21 * t10_14 + R8_31 * t10_15 + Pdot8_1;
  const T Pdot10_2 = R8_12 * t10_13 + R8_22 * t10_14 + R8_32 * t10_15 + Pdot8_2;
  const T Pdot10_3 = R8_13 * t10_13 + R8_23 * t10_14 + R8_33 * t10_15 + Pdot8_3;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_16 = omega10_3 * T(0.016) + omega10_1 * T(0.426);
  const T t10_17 = omega10_3 * T(0.148) + omega10_2 * T(0.426);
  const T t10_18 = omega10_1 * T(0.148) - omega10_2 * T(0.016);
  const T v10_1 = R10_21 * t10_16 - R10_11 * t10_17 + R10_31 * t10_18 + Pdot10_1;
  const T v10_2 = R10_22 * t10_16 - R10_12 * t10_17 + R10_32 * t10_18 + Pdot10_2;
  const T v10_3 = R10_23 * t10_16 - R10_13 * t10_17 + R10_33 * t10_18 + Pdot10_3;
  // l10 = m10 v10: linear momentum, inertial axes [kg m/s]
  const T l10_1 = T(2.57) * v10_1;
  const T l10_2 = T(2.57) * v10_2;
  const T l10_3 = T(2.57) * v10_3;
  // H10 = R10^T I10 omega10 + p10~ l10: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t10_19 = T(0.0833) * omega10_1 + T(0.0191) * omega10_2 + T(0.0097) * omega10_3;
  const T t10_20 = T(0.0191) * omega10_1 + T(0.0917) * omega10_2 - T(0.0065) * omega10_3;
  const T t10_21 = T(0.0097) * omega10_1 - T(0.0065) * omega10_2 + T(0.1089) * omega10_3;
  const T H10_1 = R10_11 * t10_19 + R10_21 * t10_20 + R10_31 * t10_21 + p10_2 * l10_3 - p10_3 * l10_2;
  const T H10_2 = R10_12 * t10_19 + R10_22 * t10_20 + R10_32 * t10_21 + p10_3 * l10_1 - p10_1 * l10_3;
  const T H10_3 = R10_13 * t10_19 + R10_23 * t10_20 + R10_33 * t10_21 + p10_1 * l10_2 - p10_2 * l10_1;

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  const T sdot11_1 = y[66], sdot11_2 = y[67], sdot11_3 = y[68];
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
  // d11 = q11 + s11: joint offset q + s, axes of the lower body [m]
  const T d11_1 = s11_1 - T(0.079);
  const T d11_2 = s11_2 - T(0.186);
  const T d11_3 = s11_3 - T(0.241);
  // P11 = R5^T d11 + P5: position of the body origin, inertial axes [m]
  const T P11_1 = R5_11 * d11_1 + R5_21 * d11_2 + R5_31 * d11_3 + P5_1;
  const T P11_2 = R5_12 * d11_1 + R5_22 * d11_2 + R5_32 * d11_3 + P5_2;
  const T P11_3 = R5_13 * d11_1 + R5_23 * d11_2 + R5_33 * d11_3 + P5_3;
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T p11_1 = R11_11 * T(0.402) - R11_21 * T(0.348) + R11_31 * T(0.337) + P11_1;
  const T p11_2 = R11_12 * T(0.402) - R11_22 * T(0.348) + R11_32 * T(0.337) + P11_2;
  const T p11_3 = R11_13 * T(0.402) - R11_23 * T(0.348) + R11_33 * T(0.337) + P11_3;
  // Pdot11 = R5^T (omega5~ d11 + sdot11) + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t11_13 = omega5_2 * d11_3 - omega5_3 * d11_2 + sdot11_1;
  const T t11_14 = omega5_3 * d11_1 - omega5_1 * d11_3 + sdot11_2;
  const T t11_15 = omega5_1 * d11_2 - omega5_2 * d11_1 + sdot11_3;
  const T Pdot11_1 = R5_11 * t11_13 + R5_21 * t11_14 + R5_31 * t11_15 + Pdot5_1;
  const T Pdot11_2 = R5_12 * t11_13 + R5_22 * t11_14 + R5_32 * t11_15 + Pdot5_2;
  const T Pdot11_3 = R5_13 * t11_13 + R5_23 * t11_14 + R5_33 * t11_15 + Pdot5_3;
  // v11 = R11^T omega11~ r11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_16 = omega11_3 * T(0.348) + omega11_2 * T(0.337);
  const T t11_17 = omega11_3 * T(0.402) - omega11_1 * T(0.337);
  const T t11_18 = omega11_1 * T(0.348) + omega11_2 * T(0.402);
  const T v11_1 = R11_11 * t11_16 + R11_21 * t11_17 - R11_31 * t11_18 + Pdot11_1;
  const T v11_2 = R11_12 * t11_16 + R11_22 * t11_17 - R11_32 * t11_18 + Pdot11_2;
  const T v11_3 = R11_13 * t11_16 + R11_23 * t11_17 - R11_33 * t11_18 + Pdot11_3;
  // l11 = m11 v11: linear momentum, inertial axes [kg m/s]
  const T l11_1 = T(3.77) * v11_1;
  const T l11_2 = T(3.77) * v11_2;
  const T l11_3 = T(3.77) * v11_3;
  // H11 = R11^T I11 omega11 + p11~ l11: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t11_19 = T(0.3729) * omega11_1 - T(3e-04) * omega11_2 - T(0.0238) * omega11_3;
  const T t11_20 = T(0.3903) * omega11_2 - T(3e-04) * omega11_1 + T(0.0124) * omega11_3;
  const T t11_21 = T(0.0124) * omega11_2 - T(0.0238) * omega11_1 + T(0.4319) * omega11_3;
  const T H11_1 = R11_11 * t11_19 + R11_21 * t11_20 + R11_31 * t11_21 + p11_2 * l11_3 - p11_3 * l11_2;
  const T H11_2 = R11_12 * t11_19 + R11_22 * t11_20 + R11_32 * t11_21 + p11_3 * l11_1 - p11_1 * l11_3;
  const T H11_3 = R11_13 * t11_19 + R11_23 * t11_20 + R11_33 * t11_21 + p11_1 * l11_2 - p11_2 * l11_1;

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  const T sdot12_1 = y[69], sdot12_2 = y[70], sdot12_3 = y[71];
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
  // d12 = q12 + s12: joint offset q + s, axes of the lower body [m]
  const T d12_1 = s12_1 - T(0.422);
  const T d12_2 = T(0.42) + s12_2;
  const T d12_3 = T(0.022) + s12_3;
  // P12 = R11^T d12 + P11: position of the body origin, inertial axes [m]
  const T P12_1 = R11_11 * d12_1 + R11_21 * d12_2 + R11_31 * d12_3 + P11_1;
  const T P12_2 = R11_12 * d12_1 + R11_22 * d12_2 + R11_32 * d12_3 + P11_2;
  const T P12_3 = R11_13 * d12_1 + R11_23 * d12_2 + R11_33 * d12_3 + P11_3;
  // p12 = R12^T r12 + P12: position of the mass centre, inertial axes [m]
  const T p12_1 = P12_1 - R12_11 * T(0.006) - R12_21 * T(0.141) - R12_31 * T(0.1);
  const T p12_2 = P12_2 - R12_12 * T(0.006) - R12_22 * T(0.141) - R12_32 * T(0.1);
  const T p12_3 = P12_3 - R12_13 * T(0.006) - R12_23 * T(0.141) - R12_33 * T(0.1);
  // Pdot12 = R11^T (omega11~ d12 + sdot12) + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_13 = omega11_2 * d12_3 - omega11_3 * d12_2 + sdot12_1;
  const T t12_14 = omega11_3 * d12_1 - omega11_1 * d12_3 + sdot12_2;
  const T t12_15 = omega11_1 * d12_2 - omega11_2 * d12_1 + sdot12_3;
  const T Pdot12_1 = R11_11 * t12_13 + R11_21 * t12_14 + R11_31 * t12_15 + Pdot11_1;
  const T Pdot12_2 = R11_12 * t12_13 + R11_22 * t12_14 + R11_32 * t12_15 + Pdot11_2;
  const T Pdot12_3 = R11_13 * t12_13 + R11_23 * t12_14 + R11_33 * t12_15 + Pdot11_3;
  // v12 = R12^T omega12~ r12 + Pdot12: velocity of the mass centre, inertial axes [m/s]
  const T t12_16 = omega12_3 * T(0.141) - omega12_2 * T(0.1);
  const T t12_17 = omega12_1 * T(0.1) - omega12_3 * T(0.006);
  const T t12_18 = omega12_2 * T(0.006) - omega12_1 * T(0.141);
  const T v12_1 = R12_11 * t12_16 + R12_21 * t12_17 + R12_31 * t12_18 + Pdot12_1;
  const T v12_2 = R12_12 * t12_16 + R12_22 * t12_17 + R12_32 * t12_18 + Pdot12_2;
  const T v12_3 = R12_13 * t12_16 + R12_23 * t12_17 + R12_33 * t12_18 + Pdot12_3;
  // l12 = m12 v12: linear momentum, inertial axes [kg m/s]
  const T l12_1 = T(4.06) * v12_1;
  const T l12_2 = T(4.06) * v12_2;
  const T l12_3 = T(4.06) * v12_3;
  // H12 = R12^T I12 omega12 + p12~ l12: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t12_19 = T(0.4137) * omega12_1 + T(0.0121) * omega12_2 - T(0.1084) * omega12_3;
  const T t12_20 = T(0.0121) * omega12_1 + T(0.5952) * omega12_2 - T(0.0023) * omega12_3;
  const T t12_21 = T(0.3276) * omega12_3 - T(0.1084) * omega12_1 - T(0.0023) * omega12_2;
  const T H12_1 = R12_11 * t12_19 + R12_21 * t12_20 + R12_31 * t12_21 + p12_2 * l12_3 - p12_3 * l12_2;
  const T H12_2 = R12_12 * t12_19 + R12_22 * t12_20 + R12_32 * t12_21 + p12_3 * l12_1 - p12_1 * l12_3;
  const T H12_3 = R12_13 * t12_19 + R12_23 * t12_20 + R12_33 * t12_21 + p12_1 * l12_2 - p12_2 * l12_1;

  // ---- whole system
  // linear = l1 + l2 + l3 + l4 + l5 + l6 + l7 + l8 + l9 + l10 + l11 + l12: linear momentum of the system [kg m/s]
  const T linear_1 = l1_1 + l2_1 + l3_1 + l4_1 + l5_1 + l6_1 + l7_1 + l8_1 + l9_1 + l10_1 + l11_1 + l12_1;
  const T linear_2 = l1_2 + l2_2 + l3_2 + l4_2 + l5_2 + l6_2 + l7_2 + l8_2 + l9_2 + l10_2 + l11_2 + l12_2;
  const T linear_3 = l1_3 + l2_3 + l3_3 + l4_3 + l5_3 + l6_3 + l7_3 + l8_3 + l9_3 + l10_3 + l11_3 + l12_3;
  momentum[0] = linear_1;
  momentum[1] = linear_2;
  momentum[2] = linear_3;
  // angular = H1 + H2 + H3 + H4 + H5 + H6 + H7 + H8 + H9 + H10 + H11 + H12: angular momentum of the system about the
  //   inertial origin [kg m^2/s]
  const T angular_1 = H1_1 + H2_1 + H3_1 + H4_1 + H5_1 + H6_1 + H7_1 + H8_1 + H9_1 + H10_1 + H11_1 + H12_1;
  const T angular_2 = H1_2 + H2_2 + H3_2 + H4_2 + H5_2 + H6_2 + H7_2 + H8_2 + H9_2 + H10_2 + H11_2 + H12_2;
  const T angular_3 = H1_3 + H2_3 + H3_3 + H4_3 + H5_3 + H6_3 + H7_3 + H8_3 + H9_3 + H10_3 + H11_3 + H12_3;
  momentum[3] = angular_1;
  momentum[4] = angular_2;
  momentum[5] = angular_3;
}

// power: power of the applied loads, without gravity [W].
// power (1) [W]
// 543 add, 559 multiply
template <class T>
void power([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, [[maybe_unused]] const Inputs<T>& u, T* out)
    noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[36], sdot1_2 = y[37], sdot1_3 = y[38];
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
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_3 * T(0.163) - omega1_2 * T(0.095);
  const T t1_14 = omega1_3 * T(0.187) + omega1_1 * T(0.095);
  const T t1_15 = omega1_1 * T(0.163) + omega1_2 * T(0.187);
  const T v1_1 = sdot1_1 + R1_11 * t1_13 + R1_21 * t1_14 - R1_31 * t1_15;
  const T v1_2 = sdot1_2 + R1_12 * t1_13 + R1_22 * t1_14 - R1_32 * t1_15;
  const T v1_3 = sdot1_3 + R1_13 * t1_13 + R1_23 * t1_14 - R1_33 * t1_15;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[39], sdot2_2 = y[40], sdot2_3 = y[41];
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
  // d2 = q2 + s2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = s2_1 - T(0.472);
  const T d2_2 = T(0.323) + s2_2;
  const T d2_3 = s2_3 - T(0.07);
  // Pdot2 = sdot1 + R1^T (omega1~ d2 + sdot2): velocity of the body origin, inertial axes [m/s]
  const T t2_13 = omega1_2 * d2_3 - omega1_3 * d2_2 + sdot2_1;
  const T t2_14 = omega1_3 * d2_1 - omega1_1 * d2_3 + sdot2_2;
  const T t2_15 = omega1_1 * d2_2 - omega1_2 * d2_1 + sdot2_3;
  const T Pdot2_1 = sdot1_1 + R1_11 * t2_13 + R1_21 * t2_14 + R1_31 * t2_15;
  const T Pdot2_2 = sdot1_2 + R1_12 * t2_13 + R1_22 * t2_14 + R1_32 * t2_15;
  const T Pdot2_3 = sdot1_3 + R1_13 * t2_13 + R1_23 * t2_14 + R1_33 * t2_15;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_16 = omega2_3 * T(0.011);
  const T t2_17 = omega2_3 * T(0.31);
  const T t2_18 = omega2_1 * T(0.31) - omega2_2 * T(0.011);
  const T v2_1 = R2_21 * t2_16 - R2_11 * t2_17 + R2_31 * t2_18 + Pdot2_1;
  const T v2_2 = R2_22 * t2_16 - R2_12 * t2_17 + R2_32 * t2_18 + Pdot2_2;
  const T v2_3 = R2_23 * t2_16 - R2_13 * t2_17 + R2_33 * t2_18 + Pdot2_3;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[42], sdot3_2 = y[43], sdot3_3 = y[44];
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
  // d3 = q3 + s3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = s3_1 - T(0.476);
  const T d3_2 = s3_2 - T(0.178);
  const T d3_3 = T(0.287) + s3_3;
  // Pdot3 = R2^T (omega2~ d3 + sdot3) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_13 = omega2_2 * d3_3 - omega2_3 * d3_2 + sdot3_1;
  const T t3_14 = omega2_3 * d3_1 - omega2_1 * d3_3 + sdot3_2;
  const T t3_15 = omega2_1 * d3_2 - omega2_2 * d3_1 + sdot3_3;
  const T Pdot3_1 = R2_11 * t3_13 + R2_21 * t3_14 + R2_31 * t3_15 + Pdot2_1;
  const T Pdot3_2 = R2_12 * t3_13 + R2_22 * t3_14 + R2_32 * t3_15 + Pdot2_2;
  const T Pdot3_3 = R2_13 * t3_13 + R2_23 * t3_14 + R2_33 * t3_15 + Pdot2_3;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_16 = omega3_2 * T(0.004) - omega3_3 * T(0.498);
  const T t3_17 = omega3_3 * T(0.484) - omega3_1 * T(0.004);
  const T t3_18 = omega3_1 * T(0.498) - omega3_2 * T(0.484);
  const T v3_1 = R3_11 * t3_16 + R3_21 * t3_17 + R3_31 * t3_18 + Pdot3_1;
  const T v3_2 = R3_12 * t3_16 + R3_22 * t3_17 + R3_32 * t3_18 + Pdot3_2;
  const T v3_3 = R3_13 * t3_16 + R3_23 * t3_17 + R3_33 * t3_18 + Pdot3_3;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[45], sdot4_2 = y[46], sdot4_3 = y[47];
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
  // d4 = q4 + s4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = s4_1 - T(0.153);
  const T d4_2 = s4_2 - T(0.132);
  const T d4_3 = T(0.236) + s4_3;
  // Pdot4 = R3^T (omega3~ d4 + sdot4) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = omega3_2 * d4_3 - omega3_3 * d4_2 + sdot4_1;
  const T t4_14 = omega3_3 * d4_1 - omega3_1 * d4_3 + sdot4_2;
  const T t4_15 = omega3_1 * d4_2 - omega3_2 * d4_1 + sdot4_3;
  const T Pdot4_1 = R3_11 * t4_13 + R3_21 * t4_14 + R3_31 * t4_15 + Pdot3_1;
  const T Pdot4_2 = R3_12 * t4_13 + R3_22 * t4_14 + R3_32 * t4_15 + Pdot3_2;
  const T Pdot4_3 = R3_13 * t4_13 + R3_23 * t4_14 + R3_33 * t4_15 + Pdot3_3;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_16 = omega4_2 * T(0.08) - omega4_3 * T(0.289);
  const T t4_17 = omega4_3 * T(0.401) - omega4_1 * T(0.08);
  const T t4_18 = omega4_1 * T(0.289) - omega4_2 * T(0.401);
  const T v4_1 = R4_11 * t4_16 + R4_21 * t4_17 + R4_31 * t4_18 + Pdot4_1;
  const T v4_2 = R4_12 * t4_16 + R4_22 * t4_17 + R4_32 * t4_18 + Pdot4_2;
  const T v4_3 = R4_13 * t4_16 + R4_23 * t4_17 + R4_33 * t4_18 + Pdot4_3;

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[48], sdot5_2 = y[49], sdot5_3 = y[50];
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
  // d5 = q5 + s5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = s5_1 - T(0.159);
  const T d5_2 = s5_2 - T(0.262);
  const T d5_3 = s5_3 - T(0.173);
  // Pdot5 = R3^T (omega3~ d5 + sdot5) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t5_13 = omega3_2 * d5_3 - omega3_3 * d5_2 + sdot5_1;
  const T t5_14 = omega3_3 * d5_1 - omega3_1 * d5_3 + sdot5_2;
  const T t5_15 = omega3_1 * d5_2 - omega3_2 * d5_1 + sdot5_3;
  const T Pdot5_1 = R3_11 * t5_13 + R3_21 * t5_14 + R3_31 * t5_15 + Pdot3_1;
  const T Pdot5_2 = R3_12 * t5_13 + R3_22 * t5_14 + R3_32 * t5_15 + Pdot3_2;
  const T Pdot5_3 = R3_13 * t5_13 + R3_23 * t5_14 + R3_33 * t5_15 + Pdot3_3;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_16 = omega5_3 * T(0.321) + omega5_2 * T(0.167);
  const T t5_17 = omega5_3 * T(0.056) + omega5_1 * T(0.167);
  const T t5_18 = omega5_2 * T(0.056) - omega5_1 * T(0.321);
  const T v5_1 = R5_11 * t5_16 - R5_21 * t5_17 + R5_31 * t5_18 + Pdot5_1;
  const T v5_2 = R5_12 * t5_16 - R5_22 * t5_17 + R5_32 * t5_18 + Pdot5_2;
  const T v5_3 = R5_13 * t5_16 - R5_23 * t5_17 + R5_33 * t5_18 + Pdot5_3;

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[51], sdot6_2 = y[52], sdot6_3 = y[53];
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
  // d6 = q6 + s6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.304) + s6_1;
  const T d6_2 = s6_2 - T(0.214);
  const T d6_3 = T(0.436) + s6_3;
  // Pdot6 = R2^T (omega2~ d6 + sdot6) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = omega2_2 * d6_3 - omega2_3 * d6_2 + sdot6_1;
  const T t6_14 = omega2_3 * d6_1 - omega2_1 * d6_3 + sdot6_2;
  const T t6_15 = omega2_1 * d6_2 - omega2_2 * d6_1 + sdot6_3;
  const T Pdot6_1 = R2_11 * t6_13 + R2_21 * t6_14 + R2_31 * t6_15 + Pdot2_1;
  const T Pdot6_2 = R2_12 * t6_13 + R2_22 * t6_14 + R2_32 * t6_15 + Pdot2_2;
  const T Pdot6_3 = R2_13 * t6_13 + R2_23 * t6_14 + R2_33 * t6_15 + Pdot2_3;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_16 = omega6_3 * T(0.248) - omega6_2 * T(0.454);
  const T t6_17 = omega6_3 * T(0.044) + omega6_1 * T(0.454);
  const T t6_18 = omega6_1 * T(0.248) + omega6_2 * T(0.044);
  const T v6_1 = R6_11 * t6_16 + R6_21 * t6_17 - R6_31 * t6_18 + Pdot6_1;
  const T v6_2 = R6_12 * t6_16 + R6_22 * t6_17 - R6_32 * t6_18 + Pdot6_2;
  const T v6_3 = R6_13 * t6_16 + R6_23 * t6_17 - R6_33 * t6_18 + Pdot6_3;

  // ---- body 7 (body_7) on body 4
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  const T sdot7_1 = y[54], sdot7_2 = y[55], sdot7_3 = y[56];
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
  // d7 = q7 + s7: joint offset q + s, axes of the lower body [m]
  const T d7_1 = s7_1 - T(0.329);
  const T d7_2 = s7_2 - T(0.337);
  const T d7_3 = T(0.216) + s7_3;
  // Pdot7 = R4^T (omega4~ d7 + sdot7) + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t7_13 = omega4_2 * d7_3 - omega4_3 * d7_2 + sdot7_1;
  const T t7_14 = omega4_3 * d7_1 - omega4_1 * d7_3 + sdot7_2;
  const T t7_15 = omega4_1 * d7_2 - omega4_2 * d7_1 + sdot7_3;
  const T Pdot7_1 = R4_11 * t7_13 + R4_21 * t7_14 + R4_31 * t7_15 + Pdot4_1;
  const T Pdot7_2 = R4_12 * t7_13 + R4_22 * t7_14 + R4_32 * t7_15 + Pdot4_2;
  const T Pdot7_3 = R4_13 * t7_13 + R4_23 * t7_14 + R4_33 * t7_15 + Pdot4_3;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_16 = omega7_3 * T(0.192) - omega7_2 * T(0.487);
  const T t7_17 = omega7_1 * T(0.487) - omega7_3 * T(0.475);
  const T t7_18 = omega7_2 * T(0.475) - omega7_1 * T(0.192);
  const T v7_1 = R7_11 * t7_16 + R7_21 * t7_17 + R7_31 * t7_18 + Pdot7_1;
  const T v7_2 = R7_12 * t7_16 + R7_22 * t7_17 + R7_32 * t7_18 + Pdot7_2;
  const T v7_3 = R7_13 * t7_16 + R7_23 * t7_17 + R7_33 * t7_18 + Pdot7_3;

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  const T sdot8_1 = y[57], sdot8_2 = y[58], sdot8_3 = y[59];
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
  // d8 = q8 + s8: joint offset q + s, axes of the lower body [m]
  const T d8_1 = s8_1 - T(0.492);
  const T d8_2 = s8_2 - T(0.25);
  const T d8_3 = s8_3 - T(0.387);
  // Pdot8 = sdot1 + R1^T (omega1~ d8 + sdot8): velocity of the body origin, inertial axes [m/s]
  const T t8_13 = omega1_2 * d8_3 - omega1_3 * d8_2 + sdot8_1;
  const T t8_14 = omega1_3 * d8_1 - omega1_1 * d8_3 + sdot8_2;
  const T t8_15 = omega1_1 * d8_2 - omega1_2 * d8_1 + sdot8_3;
  const T Pdot8_1 = sdot1_1 + R1_11 * t8_13 + R1_21 * t8_14 + R1_31 * t8_15;
  const T Pdot8_2 = sdot1_2 + R1_12 * t8_13 + R1_22 * t8_14 + R1_32 * t8_15;
  const T Pdot8_3 = sdot1_3 + R1_13 * t8_13 + R1_23 * t8_14 + R1_33 * t8_15;
  // v8 = R8^T omega8~ r8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_16 = omega8_3 * T(0.416) - omega8_2 * T(0.444);
  const T t8_17 = omega8_1 * T(0.444) - omega8_3 * T(0.392);
  const T t8_18 = omega8_2 * T(0.392) - omega8_1 * T(0.416);
  const T v8_1 = R8_11 * t8_16 + R8_21 * t8_17 + R8_31 * t8_18 + Pdot8_1;
  const T v8_2 = R8_12 * t8_16 + R8_22 * t8_17 + R8_32 * t8_18 + Pdot8_2;
  const T v8_3 = R8_13 * t8_16 + R8_23 * t8_17 + R8_33 * t8_18 + Pdot8_3;

  // ---- body 9 (body_9) on body 6
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  const T sdot9_1 = y[60], sdot9_2 = y[61], sdot9_3 = y[62];
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
  // d9 = q9 + s9: joint offset q + s, axes of the lower body [m]
  const T d9_1 = s9_1 - T(0.305);
  const T d9_2 = T(0.124) + s9_2;
  const T d9_3 = T(0.036) + s9_3;
  // Pdot9 = R6^T (omega6~ d9 + sdot9) + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t9_13 = omega6_2 * d9_3 - omega6_3 * d9_2 + sdot9_1;
  const T t9_14 = omega6_3 * d9_1 - omega6_1 * d9_3 + sdot9_2;
  const T t9_15 = omega6_1 * d9_2 - omega6_2 * d9_1 + sdot9_3;
  const T Pdot9_1 = R6_11 * t9_13 + R6_21 * t9_14 + R6_31 * t9_15 + Pdot6_1;
  const T Pdot9_2 = R6_12 * t9_13 + R6_22 * t9_14 + R6_32 * t9_15 + Pdot6_2;
  const T Pdot9_3 = R6_13 * t9_13 + R6_23 * t9_14 + R6_33 * t9_15 + Pdot6_3;
  // v9 = R9^T omega9~ r9 + Pdot9: velocity of the mass centre, inertial axes [m/s]
  const T t9_16 = omega9_3 * T(0.362) + omega9_1 * T(0.015);
  const T t9_17 = omega9_3 * T(0.49) + omega9_2 * T(0.015);
  const T t9_18 = omega9_1 * T(0.49) - omega9_2 * T(0.362);
  const T v9_1 = R9_21 * t9_16 - R9_11 * t9_17 + R9_31 * t9_18 + Pdot9_1;
  const T v9_2 = R9_22 * t9_16 - R9_12 * t9_17 + R9_32 * t9_18 + Pdot9_2;
  const T v9_3 = R9_23 * t9_16 - R9_13 * t9_17 + R9_33 * t9_18 + Pdot9_3;

  // ---- body 10 (body_10) on body 8
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  const T sdot10_1 = y[63], sdot10_2 = y[64], sdot10_3 = y[65];
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
  // d10 = q10 + s10: joint offset q + s, axes of the lower body [m]
  const T d10_1 = T(0.172) + s10_1;
  const T d10_2 = s10_2 - T(0.399);
  const T d10_3 = s10_3 - T(0.25);
  // Pdot10 = R8^T (omega8~ d10 + sdot10) + Pdot8: velocity of the body origin, inertial axes [m/s]
  const T t10_13 = omega8_2 * d10_3 - omega8_3 * d10_2 + sdot10_1;
  const T t10_14 = omega8_3 * d10_1 - omega8_1 * d10_3 + sdot10_2;
  const T t10_15 = omega8_1 * d10_2 - omega8_2 * d10_1 + sdot10_3;
  const T Pdot10_1 = R8_11 * t10_13 + R8_21 * t10_14 + R8_31 * t10_15 + Pdot8_1;
  const T Pdot10_2 = R8_12 * t10_13 + R8_22 * t10_14 + R8_32 * t10_15 + Pdot8_2;
  const T Pdot10_3 = R8_13 * t10_13 + R8_23 * t10_14 + R8_33 * t10_15 + Pdot8_3;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_16 = omega10_3 * T(0.016) + omega10_1 * T(0.426);
  const T t10_17 = omega10_3 * T(0.148) + omega10_2 * T(0.426);
  const T t10_18 = omega10_1 * T(0.148) - omega10_2 * T(0.016);
  const T v10_1 = R10_21 * t10_16 - R10_11 * t10_17 + R10_31 * t10_18 + Pdot10_1;
  const T v10_2 = R10_22 * t10_16 - R10_12 * t10_17 + R10_32 * t10_18 + Pdot10_2;
  const T v10_3 = R10_23 * t10_16 - R10_13 * t10_17 + R10_33 * t10_18 + Pdot10_3;

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  const T sdot11_1 = y[66], sdot11_2 = y[67], sdot11_3 = y[68];
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
  // d11 = q11 + s11: joint offset q + s, axes of the lower body [m]
  const T d11_1 = s11_1 - T(0.079);
  const T d11_2 = s11_2 - T(0.186);
  const T d11_3 = s11_3 - T(0.241);
  // Pdot11 = R5^T (omega5~ d11 + sdot11) + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t11_13 = omega5_2 * d11_3 - omega5_3 * d11_2 + sdot11_1;
  const T t11_14 = omega5_3 * d11_1 - omega5_1 * d11_3 + sdot11_2;
  const T t11_15 = omega5_1 * d11_2 - omega5_2 * d11_1 + sdot11_3;
  const T Pdot11_1 = R5_11 * t11_13 + R5_21 * t11_14 + R5_31 * t11_15 + Pdot5_1;
  const T Pdot11_2 = R5_12 * t11_13 + R5_22 * t11_14 + R5_32 * t11_15 + Pdot5_2;
  const T Pdot11_3 = R5_13 * t11_13 + R5_23 * t11_14 + R5_33 * t11_15 + Pdot5_3;
  // v11 = R11^T omega11~ r11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_16 = omega11_3 * T(0.348) + omega11_2 * T(0.337);
  const T t11_17 = omega11_3 * T(0.402) - omega11_1 * T(0.337);
  const T t11_18 = omega11_1 * T(0.348) + omega11_2 * T(0.402);
  const T v11_1 = R11_11 * t11_16 + R11_21 * t11_17 - R11_31 * t11_18 + Pdot11_1;
  const T v11_2 = R11_12 * t11_16 + R11_22 * t11_17 - R11_32 * t11_18 + Pdot11_2;
  const T v11_3 = R11_13 * t11_16 + R11_23 * t11_17 - R11_33 * t11_18 + Pdot11_3;

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  const T sdot12_1 = y[69], sdot12_2 = y[70], sdot12_3 = y[71];
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
  // d12 = q12 + s12: joint offset q + s, axes of the lower body [m]
  const T d12_1 = s12_1 - T(0.422);
  const T d12_2 = T(0.42) + s12_2;
  const T d12_3 = T(0.022) + s12_3;
  // Pdot12 = R11^T (omega11~ d12 + sdot12) + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_13 = omega11_2 * d12_3 - omega11_3 * d12_2 + sdot12_1;
  const T t12_14 = omega11_3 * d12_1 - omega11_1 * d12_3 + sdot12_2;
  const T t12_15 = omega11_1 * d12_2 - omega11_2 * d12_1 + sdot12_3;
  const T Pdot12_1 = R11_11 * t12_13 + R11_21 * t12_14 + R11_31 * t12_15 + Pdot11_1;
  const T Pdot12_2 = R11_12 * t12_13 + R11_22 * t12_14 + R11_32 * t12_15 + Pdot11_2;
  const T Pdot12_3 = R11_13 * t12_13 + R11_23 * t12_14 + R11_33 * t12_15 + Pdot11_3;
  // v12 = R12^T omega12~ r12 + Pdot12: velocity of the mass centre, inertial axes [m/s]
  const T t12_16 = omega12_3 * T(0.141) - omega12_2 * T(0.1);
  const T t12_17 = omega12_1 * T(0.1) - omega12_3 * T(0.006);
  const T t12_18 = omega12_2 * T(0.006) - omega12_1 * T(0.141);
  const T v12_1 = R12_11 * t12_16 + R12_21 * t12_17 + R12_31 * t12_18 + Pdot12_1;
  const T v12_2 = R12_12 * t12_16 + R12_22 * t12_17 + R12_32 * t12_18 + Pdot12_2;
  const T v12_3 = R12_13 * t12_16 + R12_23 * t12_17 + R12_33 * t12_18 + Pdot12_3;

  // ---- whole system
  // power = F1 . v1 + M1 . omega1 + F2 . v2 + M2 . omega2 + F3 . v3 + M3 . omega3 + F4 . v4 + M4 . omega4 + F5 . v5 +
  //   M5 . omega5 + F6 . v6 + M6 . omega6 + F7 . v7 + M7 . omega7 + F8 . v8 + M8 . omega8 + F9 . v9 + M9 . omega9 +
  //   F10 . v10 + M10 . omega10 + F11 . v11 + M11 . omega11 + F12 . v12 + M12 . omega12: power of the applied loads
  //   [W]
  const T power = T(1.37) * v1_1 - T(1.93) * v1_2 - T(1.76) * v1_3 + T(0.083) * omega1_1 + T(0.002) * omega1_2 -
      T(0.082) * omega1_3 + T(0.08) * v2_1 - T(1.11) * v2_2 - T(0.29) * v2_3 + T(0.054) * omega2_2 - T(0.022) *
      omega2_1 - T(0.079) * omega2_3 + T(1.33) * v3_1 + T(0.56) * v3_2 - T(1.08) * v3_3 + T(0.005) * omega3_1 -
      T(0.005) * omega3_2 + T(0.025) * omega3_3 + T(0.25) * v4_1 - T(1.93) * v4_2 + T(0.84) * v4_3 + T(0.081) *
      omega4_1 + T(0.06) * omega4_2 + T(0.079) * omega4_3 + T(1.78) * v5_1 - T(1.97) * v5_2 - T(0.56) * v5_3 -
      T(0.044) * omega5_1 - T(0.06) * omega5_2 - T(0.014) * omega5_3 + T(0.4) * v6_1 - T(0.44) * v6_2 + T(1.49) * v6_3
      + T(0.079) * omega6_1 - T(0.036) * omega6_2 - T(0.075) * omega6_3 - T(0.81) * v7_1 - T(1.24) * v7_2 - T(1.26) *
      v7_3 + T(0.072) * omega7_2 - T(0.038) * omega7_1 + T(0.021) * omega7_3 + T(0.74) * v8_1 + T(0.46) * v8_2 +
      T(1.86) * v8_3 + T(0.092) * omega8_1 + T(0.049) * omega8_2 + T(0.09) * omega8_3 - T(0.55) * v9_1 - T(1.08) *
      v9_2 - T(0.46) * v9_3 + T(0.022) * omega9_1 - T(0.075) * omega9_2 + T(0.008) * omega9_3 + T(1.24) * v10_1 +
      T(1.96) * v10_2 + T(0.69) * v10_3 - T(0.066) * omega10_1 - T(0.012) * omega10_2 - T(0.043) * omega10_3 - T(0.34)
      * v11_1 - T(1.79) * v11_2 - T(1.8) * v11_3 - T(0.077) * omega11_1 - T(0.039) * omega11_2 - T(0.068) * omega11_3
      + T(0.25) * v12_1 + T(1.37) * v12_2 + T(1.59) * v12_3 + T(0.01) * omega12_1 + T(0.009) * omega12_2 + T(0.069) *
      omega12_3;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 967 add, 969 multiply
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, [[maybe_unused]] const Inputs<T>& u,
    T* ydot) noexcept {

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
  // N1 = -omega1~ I1 omega1 + M1: applied less gyroscopic moment, body axes [N m]
  const T t1_13 = omega1_2 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T t1_15 = omega1_3 * omega1_3;
  const T t1_16 = omega1_1 * omega1_2;
  const T t1_17 = omega1_1 * omega1_3;
  const T N1_1 = T(0.083) - T(0.058099999999999985) * t1_13 + T(0.0128) * (t1_14 - t1_15) - T(0.0129) * t1_16 +
      T(0.0043) * t1_17;
  const T t1_18 = omega1_1 * omega1_1;
  const T N1_2 = T(0.002) - T(0.0010999999999999899) * t1_17 - T(0.0129) * (t1_15 - t1_18) - T(0.0043) * t1_13 -
      T(0.0128) * t1_16;
  const T minus_N1_3 = T(0.082) + T(0.0043) * (t1_18 - t1_14) - T(0.059199999999999975) * t1_16 - T(0.0128) * t1_17 -
      T(0.0129) * t1_13;
  // omegadot1 = Iinv1 N1: I omegadot + omega~ I omega = M
  const T omegadot1_1 = T(2.0695180493938974) * N1_1 - T(0.022655150890096558) * N1_2 + T(0.055931126981501586) *
      minus_N1_3;
  const T omegadot1_2 = T(2.3584024517417705) * N1_2 - T(0.022655150890096558) * N1_1 - T(0.0631705758109366) *
      minus_N1_3;
  const T omegadot1_3 = T(0.0631705758109366) * N1_2 - T(0.055931126981501586) * N1_1 - T(2.0757100412610185) *
      minus_N1_3;
  ydot[0] = omegadot1_1;
  ydot[1] = omegadot1_2;
  ydot[2] = omegadot1_3;
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U1_11 = t1_15 + t1_14;
  const T U1_12 = t1_16 - omegadot1_3;
  const T U1_13 = t1_17 + omegadot1_2;
  const T U1_21 = t1_16 + omegadot1_3;
  const T minus_U1_22 = t1_15 + t1_18;
  const T U1_23 = t1_13 - omegadot1_1;
  const T U1_31 = t1_17 - omegadot1_2;
  const T U1_32 = t1_13 + omegadot1_1;
  const T minus_U1_33 = t1_14 + t1_18;
  // Pddot1 = -R1^T U1 r1 + a1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t1_19 = U1_21 * T(0.187) + minus_U1_22 * T(0.163) - U1_23 * T(0.095);
  const T t1_20 = minus_U1_11 * T(0.187) + U1_12 * T(0.163) + U1_13 * T(0.095);
  const T t1_21 = U1_31 * T(0.187) - U1_32 * T(0.163) + minus_U1_33 * T(0.095);
  const T Pddot1_1 = T(0.3301204819277108) - R1_21 * t1_19 + R1_11 * t1_20 - R1_31 * t1_21;
  const T minus_Pddot1_2 = T(0.46506024096385534) + R1_22 * t1_19 - R1_12 * t1_20 + R1_32 * t1_21;
  const T minus_Pddot1_3 = T(0.42409638554216866) + R1_23 * t1_19 - R1_13 * t1_20 + R1_33 * t1_21;
  ydot[36] = Pddot1_1;
  ydot[37] = -minus_Pddot1_2;
  // sddot1 = g + Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T minus_sddot1_3 = T(9.81) + minus_Pddot1_3;
  ydot[38] = -minus_sddot1_3;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[39], sdot2_2 = y[40], sdot2_3 = y[41];
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
  // d2 = q2 + s2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = s2_1 - T(0.472);
  const T d2_2 = T(0.323) + s2_2;
  const T d2_3 = s2_3 - T(0.07);
  // N2 = -omega2~ I2 omega2 + M2: applied less gyroscopic moment, body axes [N m]
  const T t2_13 = omega2_2 * omega2_3;
  const T t2_14 = omega2_2 * omega2_2;
  const T t2_15 = omega2_3 * omega2_3;
  const T t2_16 = omega2_1 * omega2_2;
  const T t2_17 = omega2_1 * omega2_3;
  const T minus_N2_1 = T(0.022) + T(0.0252) * t2_13 + T(0.0049) * (t2_14 - t2_15) + T(0.0037) * t2_16 - T(1e-04) *
      t2_17;
  const T t2_18 = omega2_1 * omega2_1;
  const T N2_2 = T(0.054) - T(0.0037) * (t2_15 - t2_18) + T(0.02560000000000001) * t2_17 - T(1e-04) * t2_13 +
      T(0.0049) * t2_16;
  const T minus_N2_3 = T(0.079) + T(0.00040000000000001146) * t2_16 + T(1e-04) * (t2_18 - t2_14) + T(0.0049) * t2_17 -
      T(0.0037) * t2_13;
  // omegadot2 = Iinv2 N2: I omegadot + omega~ I omega = M
  const T omegadot2_1 = T(0.001745005857348362) * N2_2 - T(8.374813359813434) * minus_N2_1 + T(0.21361378332192085) *
      minus_N2_3;
  const T omegadot2_2 = T(8.35181013342872) * N2_2 - T(0.001745005857348362) * minus_N2_1 + T(0.2820835711610814) *
      minus_N2_3;
  const T omegadot2_3 = T(0.21361378332192085) * minus_N2_1 - T(0.2820835711610814) * N2_2 - T(6.906771747050175) *
      minus_N2_3;
  ydot[3] = omegadot2_1;
  ydot[4] = omegadot2_2;
  ydot[5] = omegadot2_3;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U2_11 = t2_15 + t2_14;
  const T U2_12 = t2_16 - omegadot2_3;
  const T U2_13 = t2_17 + omegadot2_2;
  const T U2_21 = t2_16 + omegadot2_3;
  const T minus_U2_22 = t2_15 + t2_18;
  const T U2_23 = t2_13 - omegadot2_1;
  const T U2_31 = t2_17 - omegadot2_2;
  const T U2_32 = t2_13 + omegadot2_1;
  const T minus_U2_33 = t2_14 + t2_18;
  // Pddot2 = -R2^T U2 r2 + a2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t2_19 = U2_12 * T(0.31) - minus_U2_11 * T(0.011);
  const T t2_20 = U2_21 * T(0.011) - minus_U2_22 * T(0.31);
  const T t2_21 = U2_31 * T(0.011) + U2_32 * T(0.31);
  const T Pddot2_1 = T(0.125) - R2_11 * t2_19 - R2_21 * t2_20 - R2_31 * t2_21;
  const T minus_Pddot2_2 = T(1.7343750000000002) + R2_12 * t2_19 + R2_22 * t2_20 + R2_32 * t2_21;
  const T minus_Pddot2_3 = T(0.45312499999999994) + R2_13 * t2_19 + R2_23 * t2_20 + R2_33 * t2_21;
  // sddot2 = R1 (-Pddot1 + Pddot2) - 2 omega1~ sdot2 - U1 d2: relative acceleration, axes of the lower body [m/s^2]
  const T t2_22 = Pddot2_1 - Pddot1_1;
  const T t2_23 = minus_Pddot1_2 - minus_Pddot2_2;
  const T t2_24 = minus_Pddot1_3 - minus_Pddot2_3;
  const T t2_25 = T(2) * omega1_3;
  const T t2_26 = T(2) * omega1_2;
  const T sddot2_1 = R1_11 * t2_22 + R1_12 * t2_23 + R1_13 * t2_24 + t2_25 * sdot2_2 - t2_26 * sdot2_3 - U1_12 * d2_2
      + minus_U1_11 * d2_1 - U1_13 * d2_3;
  const T t2_27 = T(2) * omega1_1;
  const T sddot2_2 = R1_21 * t2_22 + R1_22 * t2_23 + R1_23 * t2_24 + t2_27 * sdot2_3 - t2_25 * sdot2_1 - U1_21 * d2_1
      + minus_U1_22 * d2_2 - U1_23 * d2_3;
  const T sddot2_3 = R1_31 * t2_22 + R1_32 * t2_23 + R1_33 * t2_24 + t2_26 * sdot2_1 - t2_27 * sdot2_2 - U1_31 * d2_1
      - U1_32 * d2_2 + minus_U1_33 * d2_3;
  ydot[39] = sddot2_1;
  ydot[40] = sddot2_2;
  ydot[41] = sddot2_3;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[42], sdot3_2 = y[43], sdot3_3 = y[44];
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
  // d3 = q3 + s3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = s3_1 - T(0.476);
  const T d3_2 = s3_2 - T(0.178);
  const T d3_3 = T(0.287) + s3_3;
  // N3 = -omega3~ I3 omega3 + M3: applied less gyroscopic moment, body axes [N m]
  const T t3_13 = omega3_2 * omega3_3;
  const T t3_14 = omega3_2 * omega3_2;
  const T t3_15 = omega3_3 * omega3_3;
  const T t3_16 = omega3_1 * omega3_2;
  const T t3_17 = omega3_1 * omega3_3;
  const T N3_1 = T(0.005) - T(0.05720000000000003) * t3_13 + T(0.0036) * (t3_14 - t3_15) - T(0.038) * t3_16 +
      T(0.0388) * t3_17;
  const T t3_18 = omega3_1 * omega3_1;
  const T minus_N3_2 = T(0.005) + T(0.10579999999999995) * t3_17 + T(0.038) * (t3_15 - t3_18) + T(0.0388) * t3_13 +
      T(0.0036) * t3_16;
  const T N3_3 = T(0.025) - T(0.0388) * (t3_18 - t3_14) + T(0.16299999999999998) * t3_16 + T(0.0036) * t3_17 +
      T(0.038) * t3_13;
  // omegadot3 = Iinv3 N3: I omegadot + omega~ I omega = M
  const T omegadot3_1 = T(2.872223569018402) * N3_1 + T(0.5690188725354294) * minus_N3_2 - T(0.4346871132284082) *
      N3_3;
  const T omegadot3_2 = T(0.15699786849899794) * N3_3 - T(0.5690188725354294) * N3_1 - T(5.149260446027045) *
      minus_N3_2;
  const T omegadot3_3 = T(3.976087969621876) * N3_3 - T(0.4346871132284082) * N3_1 - T(0.15699786849899794) *
      minus_N3_2;
  ydot[6] = omegadot3_1;
  ydot[7] = omegadot3_2;
  ydot[8] = omegadot3_3;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U3_11 = t3_15 + t3_14;
  const T U3_12 = t3_16 - omegadot3_3;
  const T U3_13 = t3_17 + omegadot3_2;
  const T U3_21 = t3_16 + omegadot3_3;
  const T minus_U3_22 = t3_15 + t3_18;
  const T U3_23 = t3_13 - omegadot3_1;
  const T U3_31 = t3_17 - omegadot3_2;
  const T U3_32 = t3_13 + omegadot3_1;
  const T minus_U3_33 = t3_14 + t3_18;
  // Pddot3 = -R3^T U3 r3 + a3: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t3_19 = U3_12 * T(0.498) - minus_U3_11 * T(0.484) + U3_13 * T(0.004);
  const T t3_20 = U3_21 * T(0.484) - minus_U3_22 * T(0.498) + U3_23 * T(0.004);
  const T t3_21 = U3_31 * T(0.484) + U3_32 * T(0.498) - minus_U3_33 * T(0.004);
  const T Pddot3_1 = T(0.6214953271028038) - R3_11 * t3_19 - R3_21 * t3_20 - R3_31 * t3_21;
  const T Pddot3_2 = T(0.26168224299065423) - R3_12 * t3_19 - R3_22 * t3_20 - R3_32 * t3_21;
  const T minus_Pddot3_3 = T(0.5046728971962617) + R3_13 * t3_19 + R3_23 * t3_20 + R3_33 * t3_21;
  // sddot3 = R2 (-Pddot2 + Pddot3) - 2 omega2~ sdot3 - U2 d3: relative acceleration, axes of the lower body [m/s^2]
  const T t3_22 = Pddot3_1 - Pddot2_1;
  const T t3_23 = Pddot3_2 + minus_Pddot2_2;
  const T t3_24 = minus_Pddot2_3 - minus_Pddot3_3;
  const T t3_25 = T(2) * omega2_3;
  const T t3_26 = T(2) * omega2_2;
  const T sddot3_1 = R2_11 * t3_22 + R2_12 * t3_23 + R2_13 * t3_24 + t3_25 * sdot3_2 - t3_26 * sdot3_3 - U2_12 * d3_2
      + minus_U2_11 * d3_1 - U2_13 * d3_3;
  const T t3_27 = T(2) * omega2_1;
  const T sddot3_2 = R2_21 * t3_22 + R2_22 * t3_23 + R2_23 * t3_24 + t3_27 * sdot3_3 - t3_25 * sdot3_1 - U2_21 * d3_1
      + minus_U2_22 * d3_2 - U2_23 * d3_3;
  const T sddot3_3 = R2_31 * t3_22 + R2_32 * t3_23 + R2_33 * t3_24 + t3_26 * sdot3_1 - t3_27 * sdot3_2 - U2_31 * d3_1
      - U2_32 * d3_2 + minus_U2_33 * d3_3;
  ydot[42] = sddot3_1;
  ydot[43] = sddot3_2;
  ydot[44] = sddot3_3;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[45], sdot4_2 = y[46], sdot4_3 = y[47];
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
  // d4 = q4 + s4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = s4_1 - T(0.153);
  const T d4_2 = s4_2 - T(0.132);
  const T d4_3 = T(0.236) + s4_3;
  // N4 = -omega4~ I4 omega4 + M4: applied less gyroscopic moment, body axes [N m]
  const T t4_13 = omega4_2 * omega4_3;
  const T t4_14 = omega4_2 * omega4_2;
  const T t4_15 = omega4_3 * omega4_3;
  const T t4_16 = omega4_1 * omega4_2;
  const T t4_17 = omega4_1 * omega4_3;
  const T N4_1 = T(0.081) - T(0.0010999999999999899) * t4_13 + T(0.0221) * (t4_14 - t4_15) + T(0.0283) * t4_16 +
      T(0.0225) * t4_17;
  const T t4_18 = omega4_1 * omega4_1;
  const T N4_2 = T(0.06) - T(0.014300000000000007) * t4_17 + T(0.0283) * (t4_15 - t4_18) - T(0.0225) * t4_13 -
      T(0.0221) * t4_16;
  const T N4_3 = T(0.079) - T(0.0225) * (t4_18 - t4_14) + T(0.015399999999999997) * t4_16 + T(0.0221) * t4_17 -
      T(0.0283) * t4_13;
  // omegadot4 = Iinv4 N4: I omegadot + omega~ I omega = M
  const T omegadot4_1 = T(3.9982825460034723) * N4_1 - T(0.33481735065658697) * N4_2 + T(0.43916915532553025) * N4_3;
  const T omegadot4_2 = T(4.235521887745724) * N4_2 - T(0.33481735065658697) * N4_1 + T(0.3493758417591325) * N4_3;
  const T omegadot4_3 = T(0.43916915532553025) * N4_1 + T(0.3493758417591325) * N4_2 + T(4.2365020481669) * N4_3;
  ydot[9] = omegadot4_1;
  ydot[10] = omegadot4_2;
  ydot[11] = omegadot4_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U4_11 = t4_15 + t4_14;
  const T U4_12 = t4_16 - omegadot4_3;
  const T U4_13 = t4_17 + omegadot4_2;
  const T U4_21 = t4_16 + omegadot4_3;
  const T minus_U4_22 = t4_15 + t4_18;
  const T U4_23 = t4_13 - omegadot4_1;
  const T U4_31 = t4_17 - omegadot4_2;
  const T U4_32 = t4_13 + omegadot4_1;
  const T minus_U4_33 = t4_14 + t4_18;
  // Pddot4 = -R4^T U4 r4 + a4: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t4_19 = U4_12 * T(0.289) - minus_U4_11 * T(0.401) + U4_13 * T(0.08);
  const T t4_20 = U4_21 * T(0.401) - minus_U4_22 * T(0.289) + U4_23 * T(0.08);
  const T t4_21 = U4_31 * T(0.401) + U4_32 * T(0.289) - minus_U4_33 * T(0.08);
  const T Pddot4_1 = T(0.05567928730512249) - R4_11 * t4_19 - R4_21 * t4_20 - R4_31 * t4_21;
  const T minus_Pddot4_2 = T(0.4298440979955456) + R4_12 * t4_19 + R4_22 * t4_20 + R4_32 * t4_21;
  const T Pddot4_3 = T(0.18708240534521156) - R4_13 * t4_19 - R4_23 * t4_20 - R4_33 * t4_21;
  // sddot4 = R3 (-Pddot3 + Pddot4) - 2 omega3~ sdot4 - U3 d4: relative acceleration, axes of the lower body [m/s^2]
  const T t4_22 = Pddot4_1 - Pddot3_1;
  const T t4_23 = minus_Pddot4_2 + Pddot3_2;
  const T t4_24 = Pddot4_3 + minus_Pddot3_3;
  const T t4_25 = T(2) * omega3_3;
  const T t4_26 = T(2) * omega3_2;
  const T sddot4_1 = R3_11 * t4_22 - R3_12 * t4_23 + R3_13 * t4_24 + t4_25 * sdot4_2 - t4_26 * sdot4_3 - U3_12 * d4_2
      + minus_U3_11 * d4_1 - U3_13 * d4_3;
  const T t4_27 = T(2) * omega3_1;
  const T sddot4_2 = R3_21 * t4_22 - R3_22 * t4_23 + R3_23 * t4_24 + t4_27 * sdot4_3 - t4_25 * sdot4_1 - U3_21 * d4_1
      + minus_U3_22 * d4_2 - U3_23 * d4_3;
  const T sddot4_3 = R3_31 * t4_22 - R3_32 * t4_23 + R3_33 * t4_24 + t4_26 * sdot4_1 - t4_27 * sdot4_2 - U3_31 * d4_1
      - U3_32 * d4_2 + minus_U3_33 * d4_3;
  ydot[45] = sddot4_1;
  ydot[46] = sddot4_2;
  ydot[47] = sddot4_3;

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[48], sdot5_2 = y[49], sdot5_3 = y[50];
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
  // d5 = q5 + s5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = s5_1 - T(0.159);
  const T d5_2 = s5_2 - T(0.262);
  const T d5_3 = s5_3 - T(0.173);
  // N5 = -omega5~ I5 omega5 + M5: applied less gyroscopic moment, body axes [N m]
  const T t5_13 = omega5_2 * omega5_3;
  const T t5_14 = omega5_2 * omega5_2;
  const T t5_15 = omega5_3 * omega5_3;
  const T t5_16 = omega5_1 * omega5_2;
  const T t5_17 = omega5_1 * omega5_3;
  const T minus_N5_1 = T(0.044) + T(0.011699999999999988) * t5_13 - T(0.0036) * (t5_14 - t5_15) + T(0.0143) * t5_16 -
      T(0.0396) * t5_17;
  const T t5_18 = omega5_1 * omega5_1;
  const T minus_N5_2 = T(0.06) + T(0.0143) * (t5_15 - t5_18) - T(0.08959999999999999) * t5_17 + T(0.0396) * t5_13 +
      T(0.0036) * t5_16;
  const T minus_N5_3 = T(0.014) + T(0.0779) * t5_16 + T(0.0396) * (t5_18 - t5_14) - T(0.0036) * t5_17 - T(0.0143) *
      t5_13;
  // omegadot5 = Iinv5 N5: I omegadot + omega~ I omega = M
  const T omegadot5_1 = T(8.228864706027515) * minus_N5_2 - T(26.604104117139297) * minus_N5_1 + T(2.908245402955965)
      * minus_N5_3;
  const T omegadot5_2 = T(8.228864706027515) * minus_N5_1 - T(10.284708207643591) * minus_N5_2 - T(1.0971469137851804)
      * minus_N5_3;
  const T omegadot5_3 = T(2.908245402955965) * minus_N5_1 - T(1.0971469137851804) * minus_N5_2 - T(7.415160554268773)
      * minus_N5_3;
  ydot[12] = omegadot5_1;
  ydot[13] = omegadot5_2;
  ydot[14] = omegadot5_3;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U5_11 = t5_15 + t5_14;
  const T U5_12 = t5_16 - omegadot5_3;
  const T U5_13 = t5_17 + omegadot5_2;
  const T U5_21 = t5_16 + omegadot5_3;
  const T minus_U5_22 = t5_15 + t5_18;
  const T U5_23 = t5_13 - omegadot5_1;
  const T U5_31 = t5_17 - omegadot5_2;
  const T U5_32 = t5_13 + omegadot5_1;
  const T minus_U5_33 = t5_14 + t5_18;
  // Pddot5 = -R5^T U5 r5 + a5: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t5_19 = minus_U5_11 * T(0.056) - U5_12 * T(0.321) + U5_13 * T(0.167);
  const T t5_20 = minus_U5_22 * T(0.321) - U5_21 * T(0.056) + U5_23 * T(0.167);
  const T t5_21 = U5_31 * T(0.056) + U5_32 * T(0.321) + minus_U5_33 * T(0.167);
  const T Pddot5_1 = T(0.9081632653061225) - R5_11 * t5_19 - R5_21 * t5_20 + R5_31 * t5_21;
  const T minus_Pddot5_2 = T(1.0051020408163265) + R5_12 * t5_19 + R5_22 * t5_20 - R5_32 * t5_21;
  const T minus_Pddot5_3 = T(0.28571428571428575) + R5_13 * t5_19 + R5_23 * t5_20 - R5_33 * t5_21;
  // sddot5 = R3 (-Pddot3 + Pddot5) - 2 omega3~ sdot5 - U3 d5: relative acceleration, axes of the lower body [m/s^2]
  const T t5_22 = Pddot5_1 - Pddot3_1;
  const T t5_23 = minus_Pddot5_2 + Pddot3_2;
  const T t5_24 = minus_Pddot3_3 - minus_Pddot5_3;
  const T sddot5_1 = R3_11 * t5_22 - R3_12 * t5_23 + R3_13 * t5_24 + t4_25 * sdot5_2 - t4_26 * sdot5_3 - U3_12 * d5_2
      + minus_U3_11 * d5_1 - U3_13 * d5_3;
  const T sddot5_2 = R3_21 * t5_22 - R3_22 * t5_23 + R3_23 * t5_24 + t4_27 * sdot5_3 - t4_25 * sdot5_1 - U3_21 * d5_1
      + minus_U3_22 * d5_2 - U3_23 * d5_3;
  const T sddot5_3 = R3_31 * t5_22 - R3_32 * t5_23 + R3_33 * t5_24 + t4_26 * sdot5_1 - t4_27 * sdot5_2 - U3_31 * d5_1
      - U3_32 * d5_2 + minus_U3_33 * d5_3;
  ydot[48] = sddot5_1;
  ydot[49] = sddot5_2;
  ydot[50] = sddot5_3;

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[51], sdot6_2 = y[52], sdot6_3 = y[53];
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
  // d6 = q6 + s6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.304) + s6_1;
  const T d6_2 = s6_2 - T(0.214);
  const T d6_3 = T(0.436) + s6_3;
  // N6 = -omega6~ I6 omega6 + M6: applied less gyroscopic moment, body axes [N m]
  const T t6_13 = omega6_2 * omega6_2;
  const T t6_14 = omega6_3 * omega6_3;
  const T t6_15 = omega6_2 * omega6_3;
  const T t6_16 = omega6_1 * omega6_2;
  const T t6_17 = omega6_1 * omega6_3;
  const T N6_1 = T(0.079) - T(0.0219) * (t6_13 - t6_14) + T(0.014700000000000046) * t6_15 - T(0.0493) * t6_16 +
      T(0.035) * t6_17;
  const T t6_18 = omega6_1 * omega6_1;
  const T minus_N6_2 = T(0.036) + T(0.0493) * (t6_14 - t6_18) - T(0.17060000000000003) * t6_17 + T(0.035) * t6_15 -
      T(0.0219) * t6_16;
  const T minus_N6_3 = T(0.075) + T(0.18530000000000008) * t6_16 + T(0.035) * (t6_18 - t6_13) + T(0.0219) * t6_17 -
      T(0.0493) * t6_15;
  // omegadot6 = Iinv6 N6: I omegadot + omega~ I omega = M
  const T omegadot6_1 = T(2.4941618471124003) * N6_1 + T(0.13970875864419147) * minus_N6_2 + T(0.2075875298620733) *
      minus_N6_3;
  const T omegadot6_2 = T(0.05247602938404173) * minus_N6_3 - T(0.13970875864419147) * N6_1 - T(1.6985295147662622) *
      minus_N6_2;
  const T omegadot6_3 = T(0.05247602938404173) * minus_N6_2 - T(0.2075875298620733) * N6_1 - T(1.7510098515680588) *
      minus_N6_3;
  ydot[15] = omegadot6_1;
  ydot[16] = omegadot6_2;
  ydot[17] = omegadot6_3;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U6_11 = t6_14 + t6_13;
  const T U6_12 = t6_16 - omegadot6_3;
  const T U6_13 = t6_17 + omegadot6_2;
  const T U6_21 = t6_16 + omegadot6_3;
  const T minus_U6_22 = t6_14 + t6_18;
  const T U6_23 = t6_15 - omegadot6_1;
  const T U6_31 = t6_17 - omegadot6_2;
  const T U6_32 = t6_15 + omegadot6_1;
  const T minus_U6_33 = t6_13 + t6_18;
  // Pddot6 = -R6^T U6 r6 + a6: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t6_19 = U6_21 * T(0.044) + minus_U6_22 * T(0.248) - U6_23 * T(0.454);
  const T t6_20 = minus_U6_11 * T(0.044) + U6_12 * T(0.248) + U6_13 * T(0.454);
  const T t6_21 = U6_31 * T(0.044) - U6_32 * T(0.248) + minus_U6_33 * T(0.454);
  const T Pddot6_1 = T(0.1149425287356322) - R6_21 * t6_19 + R6_11 * t6_20 - R6_31 * t6_21;
  const T minus_Pddot6_2 = T(0.12643678160919541) + R6_22 * t6_19 - R6_12 * t6_20 + R6_32 * t6_21;
  const T Pddot6_3 = T(0.4281609195402299) - R6_23 * t6_19 + R6_13 * t6_20 - R6_33 * t6_21;
  // sddot6 = R2 (-Pddot2 + Pddot6) - 2 omega2~ sdot6 - U2 d6: relative acceleration, axes of the lower body [m/s^2]
  const T t6_22 = Pddot6_1 - Pddot2_1;
  const T t6_23 = minus_Pddot2_2 - minus_Pddot6_2;
  const T t6_24 = Pddot6_3 + minus_Pddot2_3;
  const T sddot6_1 = R2_11 * t6_22 + R2_12 * t6_23 + R2_13 * t6_24 + t3_25 * sdot6_2 - t3_26 * sdot6_3 - U2_12 * d6_2
      + minus_U2_11 * d6_1 - U2_13 * d6_3;
  const T sddot6_2 = R2_21 * t6_22 + R2_22 * t6_23 + R2_23 * t6_24 + t3_27 * sdot6_3 - t3_25 * sdot6_1 - U2_21 * d6_1
      + minus_U2_22 * d6_2 - U2_23 * d6_3;
  const T sddot6_3 = R2_31 * t6_22 + R2_32 * t6_23 + R2_33 * t6_24 + t3_26 * sdot6_1 - t3_27 * sdot6_2 - U2_31 * d6_1
      - U2_32 * d6_2 + minus_U2_33 * d6_3;
  ydot[51] = sddot6_1;
  ydot[52] = sddot6_2;
  ydot[53] = sddot6_3;

  // ---- body 7 (body_7) on body 4
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  const T sdot7_1 = y[54], sdot7_2 = y[55], sdot7_3 = y[56];
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
  // d7 = q7 + s7: joint offset q + s, axes of the lower body [m]
  const T d7_1 = s7_1 - T(0.329);
  const T d7_2 = s7_2 - T(0.337);
  const T d7_3 = T(0.216) + s7_3;
  // N7 = -omega7~ I7 omega7 + M7: applied less gyroscopic moment, body axes [N m]
  const T t7_13 = omega7_2 * omega7_2;
  const T t7_14 = omega7_3 * omega7_3;
  const T t7_15 = omega7_2 * omega7_3;
  const T t7_16 = omega7_1 * omega7_2;
  const T t7_17 = omega7_1 * omega7_3;
  const T minus_N7_1 = T(0.038) + T(0.0017) * (t7_13 - t7_14) - T(0.0021000000000000185) * t7_15 + T(0.0025) * t7_16 +
      T(7e-04) * t7_17;
  const T t7_18 = omega7_1 * omega7_1;
  const T N7_2 = T(0.072) - T(0.0025) * (t7_14 - t7_18) + T(0.0008999999999999841) * t7_17 + T(7e-04) * t7_15 +
      T(0.0017) * t7_16;
  const T N7_3 = T(0.021) - T(0.0030000000000000027) * t7_16 + T(7e-04) * (t7_18 - t7_13) - T(0.0017) * t7_17 +
      T(0.0025) * t7_15;
  // omegadot7 = Iinv7 N7: I omegadot + omega~ I omega = M
  const T omegadot7_1 = T(0.0404762754848672) * N7_2 - T(7.521659426959323) * minus_N7_1 - T(0.14094815710024333) *
      N7_3;
  const T omegadot7_2 = T(7.354326092116494) * N7_2 - T(0.0404762754848672) * minus_N7_1 - T(0.09412655000231672) *
      N7_3;
  const T omegadot7_3 = T(0.14094815710024333) * minus_N7_1 - T(0.09412655000231672) * N7_2 + T(7.4720865237322975) *
      N7_3;
  ydot[18] = omegadot7_1;
  ydot[19] = omegadot7_2;
  ydot[20] = omegadot7_3;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U7_11 = t7_14 + t7_13;
  const T U7_12 = t7_16 - omegadot7_3;
  const T U7_13 = t7_17 + omegadot7_2;
  const T U7_21 = t7_16 + omegadot7_3;
  const T minus_U7_22 = t7_14 + t7_18;
  const T U7_23 = t7_15 - omegadot7_1;
  const T U7_31 = t7_17 - omegadot7_2;
  const T U7_32 = t7_15 + omegadot7_1;
  const T minus_U7_33 = t7_13 + t7_18;
  // Pddot7 = -R7^T U7 r7 + a7: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t7_19 = minus_U7_11 * T(0.475) - U7_12 * T(0.192) - U7_13 * T(0.487);
  const T t7_20 = minus_U7_22 * T(0.192) - U7_21 * T(0.475) - U7_23 * T(0.487);
  const T t7_21 = minus_U7_33 * T(0.487) - U7_31 * T(0.475) - U7_32 * T(0.192);
  const T minus_Pddot7_1 = T(1.0945945945945947) + R7_11 * t7_19 + R7_21 * t7_20 + R7_31 * t7_21;
  const T minus_Pddot7_2 = T(1.6756756756756757) + R7_12 * t7_19 + R7_22 * t7_20 + R7_32 * t7_21;
  const T minus_Pddot7_3 = T(1.7027027027027026) + R7_13 * t7_19 + R7_23 * t7_20 + R7_33 * t7_21;
  // sddot7 = R4 (-Pddot4 + Pddot7) - 2 omega4~ sdot7 - U4 d7: relative acceleration, axes of the lower body [m/s^2]
  const T t7_22 = minus_Pddot4_2 - minus_Pddot7_2;
  const T t7_23 = minus_Pddot7_1 + Pddot4_1;
  const T t7_24 = minus_Pddot7_3 + Pddot4_3;
  const T t7_25 = T(2) * omega4_3;
  const T t7_26 = T(2) * omega4_2;
  const T sddot7_1 = R4_12 * t7_22 - R4_11 * t7_23 - R4_13 * t7_24 + t7_25 * sdot7_2 - t7_26 * sdot7_3 - U4_12 * d7_2
      + minus_U4_11 * d7_1 - U4_13 * d7_3;
  const T t7_27 = T(2) * omega4_1;
  const T sddot7_2 = R4_22 * t7_22 - R4_21 * t7_23 - R4_23 * t7_24 + t7_27 * sdot7_3 - t7_25 * sdot7_1 - U4_21 * d7_1
      + minus_U4_22 * d7_2 - U4_23 * d7_3;
  const T sddot7_3 = R4_32 * t7_22 - R4_31 * t7_23 - R4_33 * t7_24 + t7_26 * sdot7_1 - t7_27 * sdot7_2 - U4_31 * d7_1
      - U4_32 * d7_2 + minus_U4_33 * d7_3;
  ydot[54] = sddot7_1;
  ydot[55] = sddot7_2;
  ydot[56] = sddot7_3;

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  const T sdot8_1 = y[57], sdot8_2 = y[58], sdot8_3 = y[59];
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
  // d8 = q8 + s8: joint offset q + s, axes of the lower body [m]
  const T d8_1 = s8_1 - T(0.492);
  const T d8_2 = s8_2 - T(0.25);
  const T d8_3 = s8_3 - T(0.387);
  // N8 = -omega8~ I8 omega8 + M8: applied less gyroscopic moment, body axes [N m]
  const T t8_13 = omega8_2 * omega8_3;
  const T t8_14 = omega8_2 * omega8_2;
  const T t8_15 = omega8_3 * omega8_3;
  const T t8_16 = omega8_1 * omega8_2;
  const T t8_17 = omega8_1 * omega8_3;
  const T N8_1 = T(0.092) - T(0.017199999999999938) * t8_13 - T(0.028) * (t8_14 - t8_15) + T(0.0399) * t8_16 -
      T(0.0147) * t8_17;
  const T t8_18 = omega8_1 * omega8_1;
  const T N8_2 = T(0.049) + T(0.06739999999999996) * t8_17 + T(0.0399) * (t8_15 - t8_18) + T(0.0147) * t8_13 +
      T(0.028) * t8_16;
  const T N8_3 = T(0.09) - T(0.05020000000000002) * t8_16 + T(0.0147) * (t8_18 - t8_14) - T(0.028) * t8_17 - T(0.0399)
      * t8_13;
  // omegadot8 = Iinv8 N8: I omegadot + omega~ I omega = M
  const T omegadot8_1 = T(2.2431453707099713) * N8_1 + T(0.05648564396046748) * N8_2 + T(0.1701895126992543) * N8_3;
  const T omegadot8_2 = T(0.05648564396046748) * N8_1 + T(2.0099288778308475) * N8_2 - T(0.10457652223236756) * N8_3;
  const T omegadot8_3 = T(0.1701895126992543) * N8_1 - T(0.10457652223236756) * N8_2 + T(1.9545464656972642) * N8_3;
  ydot[21] = omegadot8_1;
  ydot[22] = omegadot8_2;
  ydot[23] = omegadot8_3;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U8_11 = t8_15 + t8_14;
  const T U8_12 = t8_16 - omegadot8_3;
  const T U8_13 = t8_17 + omegadot8_2;
  const T U8_21 = t8_16 + omegadot8_3;
  const T minus_U8_22 = t8_15 + t8_18;
  const T U8_23 = t8_13 - omegadot8_1;
  const T U8_31 = t8_17 - omegadot8_2;
  const T U8_32 = t8_13 + omegadot8_1;
  const T minus_U8_33 = t8_14 + t8_18;
  // Pddot8 = -R8^T U8 r8 + a8: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t8_19 = minus_U8_11 * T(0.392) - U8_12 * T(0.416) - U8_13 * T(0.444);
  const T t8_20 = minus_U8_22 * T(0.416) - U8_21 * T(0.392) - U8_23 * T(0.444);
  const T t8_21 = minus_U8_33 * T(0.444) - U8_31 * T(0.392) - U8_32 * T(0.416);
  const T Pddot8_1 = T(0.2730627306273063) - R8_11 * t8_19 - R8_21 * t8_20 - R8_31 * t8_21;
  const T Pddot8_2 = T(0.16974169741697417) - R8_12 * t8_19 - R8_22 * t8_20 - R8_32 * t8_21;
  const T Pddot8_3 = T(0.6863468634686347) - R8_13 * t8_19 - R8_23 * t8_20 - R8_33 * t8_21;
  // sddot8 = R1 (-Pddot1 + Pddot8) - 2 omega1~ sdot8 - U1 d8: relative acceleration, axes of the lower body [m/s^2]
  const T t8_22 = Pddot8_1 - Pddot1_1;
  const T t8_23 = Pddot8_2 + minus_Pddot1_2;
  const T t8_24 = Pddot8_3 + minus_Pddot1_3;
  const T sddot8_1 = R1_11 * t8_22 + R1_12 * t8_23 + R1_13 * t8_24 + t2_25 * sdot8_2 - t2_26 * sdot8_3 - U1_12 * d8_2
      + minus_U1_11 * d8_1 - U1_13 * d8_3;
  const T sddot8_2 = R1_21 * t8_22 + R1_22 * t8_23 + R1_23 * t8_24 + t2_27 * sdot8_3 - t2_25 * sdot8_1 - U1_21 * d8_1
      + minus_U1_22 * d8_2 - U1_23 * d8_3;
  const T sddot8_3 = R1_31 * t8_22 + R1_32 * t8_23 + R1_33 * t8_24 + t2_26 * sdot8_1 - t2_27 * sdot8_2 - U1_31 * d8_1
      - U1_32 * d8_2 + minus_U1_33 * d8_3;
  ydot[57] = sddot8_1;
  ydot[58] = sddot8_2;
  ydot[59] = sddot8_3;

  // ---- body 9 (body_9) on body 6
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  const T sdot9_1 = y[60], sdot9_2 = y[61], sdot9_3 = y[62];
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
  // d9 = q9 + s9: joint offset q + s, axes of the lower body [m]
  const T d9_1 = s9_1 - T(0.305);
  const T d9_2 = T(0.124) + s9_2;
  const T d9_3 = T(0.036) + s9_3;
  // N9 = -omega9~ I9 omega9 + M9: applied less gyroscopic moment, body axes [N m]
  const T t9_13 = omega9_1 * omega9_2;
  const T t9_14 = omega9_2 * omega9_3;
  const T t9_15 = omega9_2 * omega9_2;
  const T t9_16 = omega9_3 * omega9_3;
  const T t9_17 = omega9_1 * omega9_3;
  const T N9_1 = T(0.022) - T(0.0257) * t9_13 + T(0.022300000000000042) * t9_14 + T(0.0093) * (t9_15 - t9_16) +
      T(0.0215) * t9_17;
  const T t9_18 = omega9_1 * omega9_1;
  const T minus_N9_2 = T(0.075) + T(0.0257) * (t9_16 - t9_18) - T(0.04989999999999997) * t9_17 + T(0.0215) * t9_14 +
      T(0.0093) * t9_13;
  const T N9_3 = T(0.008) - T(0.07220000000000001) * t9_13 - T(0.0215) * (t9_18 - t9_15) + T(0.0093) * t9_17 +
      T(0.0257) * t9_14;
  // omegadot9 = Iinv9 N9: I omegadot + omega~ I omega = M
  const T omegadot9_1 = T(4.405298766180525) * N9_1 + T(0.32507374982810383) * minus_N9_2 - T(0.4138104811827728) *
      N9_3;
  const T omegadot9_2 = T(0.13984152505164316) * N9_3 - T(0.32507374982810383) * N9_1 - T(3.325493442626268) *
      minus_N9_2;
  const T omegadot9_3 = T(3.602475811852537) * N9_3 - T(0.4138104811827728) * N9_1 - T(0.13984152505164316) *
      minus_N9_2;
  ydot[24] = omegadot9_1;
  ydot[25] = omegadot9_2;
  ydot[26] = omegadot9_3;
  // U9 = omega9~ omega9~ + omegadot9~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U9_11 = t9_16 + t9_15;
  const T U9_12 = t9_13 - omegadot9_3;
  const T U9_13 = t9_17 + omegadot9_2;
  const T U9_21 = t9_13 + omegadot9_3;
  const T minus_U9_22 = t9_16 + t9_18;
  const T U9_23 = t9_14 - omegadot9_1;
  const T U9_31 = t9_17 - omegadot9_2;
  const T U9_32 = t9_14 + omegadot9_1;
  const T minus_U9_33 = t9_15 + t9_18;
  // Pddot9 = -R9^T U9 r9 + a9: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t9_19 = U9_12 * T(0.49) - minus_U9_11 * T(0.362) - U9_13 * T(0.015);
  const T t9_20 = U9_21 * T(0.362) - minus_U9_22 * T(0.49) - U9_23 * T(0.015);
  const T t9_21 = U9_31 * T(0.362) + U9_32 * T(0.49) + minus_U9_33 * T(0.015);
  const T minus_Pddot9_1 = T(0.29891304347826086) + R9_11 * t9_19 + R9_21 * t9_20 + R9_31 * t9_21;
  const T minus_Pddot9_2 = T(0.5869565217391305) + R9_12 * t9_19 + R9_22 * t9_20 + R9_32 * t9_21;
  const T minus_Pddot9_3 = T(0.25) + R9_13 * t9_19 + R9_23 * t9_20 + R9_33 * t9_21;
  // sddot9 = R6 (-Pddot6 + Pddot9) - 2 omega6~ sdot9 - U6 d9: relative acceleration, axes of the lower body [m/s^2]
  const T t9_22 = minus_Pddot6_2 - minus_Pddot9_2;
  const T t9_23 = minus_Pddot9_1 + Pddot6_1;
  const T t9_24 = minus_Pddot9_3 + Pddot6_3;
  const T t9_25 = T(2) * omega6_3;
  const T t9_26 = T(2) * omega6_2;
  const T sddot9_1 = R6_12 * t9_22 - R6_11 * t9_23 - R6_13 * t9_24 + t9_25 * sdot9_2 - t9_26 * sdot9_3 - U6_12 * d9_2
      + minus_U6_11 * d9_1 - U6_13 * d9_3;
  const T t9_27 = T(2) * omega6_1;
  const T sddot9_2 = R6_22 * t9_22 - R6_21 * t9_23 - R6_23 * t9_24 + t9_27 * sdot9_3 - t9_25 * sdot9_1 - U6_21 * d9_1
      + minus_U6_22 * d9_2 - U6_23 * d9_3;
  const T sddot9_3 = R6_32 * t9_22 - R6_31 * t9_23 - R6_33 * t9_24 + t9_26 * sdot9_1 - t9_27 * sdot9_2 - U6_31 * d9_1
      - U6_32 * d9_2 + minus_U6_33 * d9_3;
  ydot[60] = sddot9_1;
  ydot[61] = sddot9_2;
  ydot[62] = sddot9_3;

  // ---- body 10 (body_10) on body 8
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  const T sdot10_1 = y[63], sdot10_2 = y[64], sdot10_3 = y[65];
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
  // d10 = q10 + s10: joint offset q + s, axes of the lower body [m]
  const T d10_1 = T(0.172) + s10_1;
  const T d10_2 = s10_2 - T(0.399);
  const T d10_3 = s10_3 - T(0.25);
  // N10 = -omega10~ I10 omega10 + M10: applied less gyroscopic moment, body axes [N m]
  const T t10_13 = omega10_2 * omega10_3;
  const T t10_14 = omega10_2 * omega10_2;
  const T t10_15 = omega10_3 * omega10_3;
  const T t10_16 = omega10_1 * omega10_2;
  const T t10_17 = omega10_1 * omega10_3;
  const T minus_N10_1 = T(0.066) + T(0.017199999999999993) * t10_13 - T(0.0065) * (t10_14 - t10_15) + T(0.0097) *
      t10_16 - T(0.0191) * t10_17;
  const T t10_18 = omega10_1 * omega10_1;
  const T minus_N10_2 = T(0.012) + T(0.0097) * (t10_15 - t10_18) - T(0.025599999999999998) * t10_17 + T(0.0191) *
      t10_13 + T(0.0065) * t10_16;
  const T minus_N10_3 = T(0.043) + T(0.008400000000000005) * t10_16 + T(0.0191) * (t10_18 - t10_14) - T(0.0065) *
      t10_17 - T(0.0097) * t10_13;
  // omegadot10 = Iinv10 N10: I omegadot + omega~ I omega = M
  const T omegadot10_1 = T(2.7561059042644778) * minus_N10_2 - T(12.788555686920198) * minus_N10_1 +
      T(1.3036150462887515) * minus_N10_3;
  const T omegadot10_2 = T(2.7561059042644778) * minus_N10_1 - T(11.54543751504191) * minus_N10_2 -
      T(0.9346149781371703) * minus_N10_3;
  const T omegadot10_3 = T(1.3036150462887515) * minus_N10_1 - T(0.9346149781371703) * minus_N10_2 -
      T(9.35463786324052) * minus_N10_3;
  ydot[27] = omegadot10_1;
  ydot[28] = omegadot10_2;
  ydot[29] = omegadot10_3;
  // U10 = omega10~ omega10~ + omegadot10~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T minus_U10_11 = t10_15 + t10_14;
  const T U10_12 = t10_16 - omegadot10_3;
  const T U10_13 = t10_17 + omegadot10_2;
  const T U10_21 = t10_16 + omegadot10_3;
  const T minus_U10_22 = t10_15 + t10_18;
  const T U10_23 = t10_13 - omegadot10_1;
  const T U10_31 = t10_17 - omegadot10_2;
  const T U10_32 = t10_13 + omegadot10_1;
  const T minus_U10_33 = t10_14 + t10_18;
  // Pddot10 = -R10^T U10 r10 + a10: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t10_19 = U10_12 * T(0.148) - minus_U10_11 * T(0.016) - U10_13 * T(0.426);
  const T t10_20 = U10_21 * T(0.016) - minus_U10_22 * T(0.148) - U10_23 * T(0.426);
  const T t10_21 = U10_31 * T(0.016) + U10_32 * T(0.148) + minus_U10_33 * T(0.426);
  const T Pddot10_1 = T(0.48249027237354086) - R10_11 * t10_19 - R10_21 * t10_20 - R10_31 * t10_21;
  const T Pddot10_2 = T(0.7626459143968872) - R10_12 * t10_19 - R10_22 * t10_20 - R10_32 * t10_21;
  const T Pddot10_3 = T(0.26848249027237353) - R10_13 * t10_19 - R10_23 * t10_20 - R10_33 * t10_21;
  // sddot10 = R8 (-Pddot8 + Pddot10) - 2 omega8~ sdot10 - U8 d10: relative acceleration, axes of the lower body
  //   [m/s^2]
  const T t10_22 = Pddot10_1 - Pddot8_1;
  const T t10_23 = Pddot10_2 - Pddot8_2;
  const T t10_24 = Pddot10_3 - Pddot8_3;
  const T t10_25 = T(2) * omega8_3;
  const T t10_26 = T(2) * omega8_2;
  const T sddot10_1 = R8_11 * t10_22 + R8_12 * t10_23 + R8_13 * t10_24 + t10_25 * sdot10_2 - t10_26 * sdot10_3 - U8_12
      * d10_2 + minus_U8_11 * d10_1 - U8_13 * d10_3;
  const T t10_27 = T(2) * omega8_1;
  const T sddot10_2 = R8_21 * t10_22 + R8_22 * t10_23 + R8_23 * t10_24 + t10_27 * sdot10_3 - t10_25 * sdot10_1 - U8_21
      * d10_1 + minus_U8_22 * d10_2 - U8_23 * d10_3;
  const T sddot10_3 = R8_31 * t10_22 + R8_32 * t10_23 + R8_33 * t10_24 + t10_26 * sdot10_1 - t10_27 * sdot10_2 - U8_31
      * d10_1 - U8_32 * d10_2 + minus_U8_33 * d10_3;
  ydot[63] = sddot10_1;
  ydot[64] = sddot10_2;
  ydot[65] = sddot10_3;

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  const T sdot11_1 = y[66], sdot11_2 = y[67], sdot11_3 = y[68];
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
  // d11 = q11 + s11: joint offset q + s, axes of the lower body [m]
  const T d11_1 = s11_1 - T(0.079);
  const T d11_2 = s11_2 - T(0.186);
  const T d11_3 = s11_3 - T(0.241);
  // N11 = -omega11~ I11 omega11 + M11: applied less gyroscopic moment, body axes [N m]
  const T t11_13 = omega11_2 * omega11_3;
  const T t11_14 = omega11_2 * omega11_2;
  const T t11_15 = omega11_3 * omega11_3;
  const T t11_16 = omega11_1 * omega11_2;
  const T t11_17 = omega11_1 * omega11_3;
  const T minus_N11_1 = T(0.077) + T(0.041600000000000026) * t11_13 + T(0.0124) * (t11_14 - t11_15) - T(0.0238) *
      t11_16 + T(3e-04) * t11_17;
  const T t11_18 = omega11_1 * omega11_1;
  const T N11_2 = T(0.059) * t11_17 + T(0.0238) * (t11_15 - t11_18) + T(3e-04) * t11_13 + T(0.0124) * t11_16 -
      T(0.039);
  const T minus_N11_3 = T(0.068) + T(0.01739999999999997) * t11_16 - T(3e-04) * (t11_18 - t11_14) + T(0.0124) * t11_17
      + T(0.0238) * t11_13;
  // omegadot11 = Iinv11 N11: I omegadot + omega~ I omega = M
  const T minus_omegadot11_1 = T(2.691151727257649) * minus_N11_1 + T(0.002645342637991444) * N11_2 +
      T(0.14837280240204478) * minus_N11_3;
  const T omegadot11_2 = T(0.002645342637991444) * minus_N11_1 + T(2.5644734509368377) * N11_2 +
      T(0.07377270189025466) * minus_N11_3;
  const T minus_omegadot11_3 = T(0.14837280240204478) * minus_N11_1 + T(0.07377270189025466) * N11_2 +
      T(2.3256449506844357) * minus_N11_3;
  ydot[30] = -minus_omegadot11_1;
  ydot[31] = omegadot11_2;
  ydot[32] = -minus_omegadot11_3;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T minus_U11_11 = t11_15 + t11_14;
  const T U11_12 = t11_16 + minus_omegadot11_3;
  const T U11_13 = t11_17 + omegadot11_2;
  const T U11_21 = t11_16 - minus_omegadot11_3;
  const T minus_U11_22 = t11_15 + t11_18;
  const T U11_23 = t11_13 + minus_omegadot11_1;
  const T U11_31 = t11_17 - omegadot11_2;
  const T U11_32 = t11_13 - minus_omegadot11_1;
  const T minus_U11_33 = t11_14 + t11_18;
  // Pddot11 = -R11^T U11 r11 + a11: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t11_19 = U11_13 * T(0.337) - minus_U11_11 * T(0.402) - U11_12 * T(0.348);
  const T t11_20 = U11_21 * T(0.402) + minus_U11_22 * T(0.348) + U11_23 * T(0.337);
  const T t11_21 = U11_31 * T(0.402) - U11_32 * T(0.348) - minus_U11_33 * T(0.337);
  const T minus_Pddot11_1 = T(0.09018567639257295) + R11_11 * t11_19 + R11_21 * t11_20 + R11_31 * t11_21;
  const T minus_Pddot11_2 = T(0.47480106100795755) + R11_12 * t11_19 + R11_22 * t11_20 + R11_32 * t11_21;
  const T minus_Pddot11_3 = T(0.4774535809018568) + R11_13 * t11_19 + R11_23 * t11_20 + R11_33 * t11_21;
  // sddot11 = R5 (-Pddot5 + Pddot11) - 2 omega5~ sdot11 - U5 d11: relative acceleration, axes of the lower body
  //   [m/s^2]
  const T t11_22 = minus_Pddot5_2 - minus_Pddot11_2;
  const T t11_23 = minus_Pddot11_1 + Pddot5_1;
  const T t11_24 = minus_Pddot5_3 - minus_Pddot11_3;
  const T t11_25 = T(2) * omega5_3;
  const T t11_26 = T(2) * omega5_2;
  const T sddot11_1 = R5_12 * t11_22 - R5_11 * t11_23 + R5_13 * t11_24 + t11_25 * sdot11_2 - t11_26 * sdot11_3 - U5_12
      * d11_2 + minus_U5_11 * d11_1 - U5_13 * d11_3;
  const T t11_27 = T(2) * omega5_1;
  const T sddot11_2 = R5_22 * t11_22 - R5_21 * t11_23 + R5_23 * t11_24 + t11_27 * sdot11_3 - t11_25 * sdot11_1 - U5_21
      * d11_1 + minus_U5_22 * d11_2 - U5_23 * d11_3;
  const T sddot11_3 = R5_32 * t11_22 - R5_31 * t11_23 + R5_33 * t11_24 + t11_26 * sdot11_1 - t11_27 * sdot11_2 - U5_31
      * d11_1 - U5_32 * d11_2 + minus_U5_33 * d11_3;
  ydot[66] = sddot11_1;
  ydot[67] = sddot11_2;
  ydot[68] = sddot11_3;

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  const T sdot12_1 = y[69], sdot12_2 = y[70], sdot12_3 = y[71];
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
  // d12 = q12 + s12: joint offset q + s, axes of the lower body [m]
  const T d12_1 = s12_1 - T(0.422);
  const T d12_2 = T(0.42) + s12_2;
  const T d12_3 = T(0.022) + s12_3;
  // N12 = -omega12~ I12 omega12 + M12: applied less gyroscopic moment, body axes [N m]
  const T t12_13 = omega12_2 * omega12_3;
  const T t12_14 = omega12_2 * omega12_2;
  const T t12_15 = omega12_3 * omega12_3;
  const T t12_16 = omega12_1 * omega12_2;
  const T t12_17 = omega12_1 * omega12_3;
  const T N12_1 = T(0.01) + T(0.26759999999999995) * t12_13 + T(0.0023) * (t12_14 - t12_15) + T(0.1084) * t12_16 +
      T(0.0121) * t12_17;
  const T t12_18 = omega12_1 * omega12_1;
  const T N12_2 = T(0.009) - T(0.08610000000000001) * t12_17 + T(0.1084) * (t12_15 - t12_18) - T(0.0121) * t12_13 -
      T(0.0023) * t12_16;
  const T N12_3 = T(0.069) - T(0.18149999999999994) * t12_16 - T(0.0121) * (t12_18 - t12_14) + T(0.0023) * t12_17 -
      T(0.1084) * t12_13;
  // omegadot12 = Iinv12 N12: I omegadot + omega~ I omega = M
  const T omegadot12_1 = T(2.6481973653496103) * N12_1 - T(0.050451263488074154) * N12_2 + T(0.8759113446211086) *
      N12_3;
  const T omegadot12_2 = T(1.681114265035349) * N12_2 - T(0.050451263488074154) * N12_1 - T(0.004891190941776361) *
      N12_3;
  const T omegadot12_3 = T(0.8759113446211086) * N12_1 - T(0.004891190941776361) * N12_2 + T(3.342300183204402) *
      N12_3;
  ydot[33] = omegadot12_1;
  ydot[34] = omegadot12_2;
  ydot[35] = omegadot12_3;
  // U12 = omega12~ omega12~ + omegadot12~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T minus_U12_11 = t12_15 + t12_14;
  const T U12_12 = t12_16 - omegadot12_3;
  const T U12_13 = t12_17 + omegadot12_2;
  const T U12_21 = t12_16 + omegadot12_3;
  const T minus_U12_22 = t12_15 + t12_18;
  const T U12_23 = t12_13 - omegadot12_1;
  const T U12_31 = t12_17 - omegadot12_2;
  const T U12_32 = t12_13 + omegadot12_1;
  const T minus_U12_33 = t12_14 + t12_18;
  // Pddot12 = -R12^T U12 r12 + a12: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t12_19 = minus_U12_11 * T(0.006) - U12_12 * T(0.141) - U12_13 * T(0.1);
  const T t12_20 = minus_U12_22 * T(0.141) - U12_21 * T(0.006) - U12_23 * T(0.1);
  const T t12_21 = minus_U12_33 * T(0.1) - U12_31 * T(0.006) - U12_32 * T(0.141);
  const T Pddot12_1 = T(0.061576354679802964) - R12_11 * t12_19 - R12_21 * t12_20 - R12_31 * t12_21;
  const T Pddot12_2 = T(0.33743842364532023) - R12_12 * t12_19 - R12_22 * t12_20 - R12_32 * t12_21;
  const T Pddot12_3 = T(0.3916256157635469) - R12_13 * t12_19 - R12_23 * t12_20 - R12_33 * t12_21;
  // sddot12 = R11 (-Pddot11 + Pddot12) - 2 omega11~ sdot12 - U11 d12: relative acceleration, axes of the lower body
  //   [m/s^2]
  const T t12_22 = Pddot12_1 + minus_Pddot11_1;
  const T t12_23 = Pddot12_2 + minus_Pddot11_2;
  const T t12_24 = Pddot12_3 + minus_Pddot11_3;
  const T t12_25 = T(2) * omega11_3;
  const T t12_26 = T(2) * omega11_2;
  const T sddot12_1 = R11_11 * t12_22 + R11_12 * t12_23 + R11_13 * t12_24 + t12_25 * sdot12_2 - t12_26 * sdot12_3 -
      U11_12 * d12_2 + minus_U11_11 * d12_1 - U11_13 * d12_3;
  const T t12_27 = T(2) * omega11_1;
  const T sddot12_2 = R11_21 * t12_22 + R11_22 * t12_23 + R11_23 * t12_24 + t12_27 * sdot12_3 - t12_25 * sdot12_1 -
      U11_21 * d12_1 + minus_U11_22 * d12_2 - U11_23 * d12_3;
  const T sddot12_3 = R11_31 * t12_22 + R11_32 * t12_23 + R11_33 * t12_24 + t12_26 * sdot12_1 - t12_27 * sdot12_2 -
      U11_31 * d12_1 - U11_32 * d12_2 + minus_U11_33 * d12_3;
  ydot[69] = sddot12_1;
  ydot[70] = sddot12_2;
  ydot[71] = sddot12_3;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 1274 add, 1276 multiply
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, [[maybe_unused]] const
    Inputs<T>& u, T* r) noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[36], sddot1_2 = ydot[37], sddot1_3 = ydot[38];
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
  const T t1_19 = U1_21 * T(0.187) + minus_U1_22 * T(0.163) - U1_23 * T(0.095);
  const T t1_20 = minus_U1_11 * T(0.187) + U1_12 * T(0.163) + U1_13 * T(0.095);
  const T t1_21 = U1_31 * T(0.187) - U1_32 * T(0.163) + minus_U1_33 * T(0.095);
  const T a1_1 = R1_21 * t1_19 - R1_11 * t1_20 + R1_31 * t1_21 + sddot1_1;
  const T a1_2 = R1_22 * t1_19 - R1_12 * t1_20 + R1_32 * t1_21 + sddot1_2;
  const T a1_3 = R1_23 * t1_19 - R1_13 * t1_20 + R1_33 * t1_21 + Pddot1_3;
  // G1 = m1 a1 - F1: force balance, inertial axes [N]
  const T G1_1 = T(4.15) * a1_1 - T(1.37);
  const T G1_2 = T(4.15) * a1_2 + T(1.93);
  const T G1_3 = T(4.15) * a1_3 + T(1.76);
  // N1 = -M1 + axial(U1 (tr(I1)/2 - I1)): moment balance about the mass centre, body axes [N m]
  const T N1_1 = T(0.27085) * U1_32 - T(0.21275) * U1_23 + T(0.0128) * (minus_U1_22 - minus_U1_33) - T(0.0043) * U1_31
      + T(0.0129) * U1_21 - T(0.083);
  const T N1_2 = T(0.21275) * U1_13 - T(0.21165) * U1_31 - T(0.0129) * (minus_U1_33 - minus_U1_11) + T(0.0128) * U1_12
      + T(0.0043) * U1_32 - T(0.002);
  const T N1_3 = T(0.21165) * U1_21 - T(0.27085) * U1_12 - T(0.0043) * (minus_U1_11 - minus_U1_22) - T(0.0129) * U1_23
      - T(0.0128) * U1_13 + T(0.082);

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[39], sdot2_2 = y[40], sdot2_3 = y[41];
  const T omegadot2_1 = ydot[3], omegadot2_2 = ydot[4], omegadot2_3 = ydot[5];
  const T sddot2_1 = ydot[39], sddot2_2 = ydot[40], sddot2_3 = ydot[41];
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
  // d2 = q2 + s2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = s2_1 - T(0.472);
  const T d2_2 = T(0.323) + s2_2;
  const T d2_3 = s2_3 - T(0.07);
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
  // Pddot2 = R1^T (2 omega1~ sdot2 + sddot2 + U1 d2) + Pddot1: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t2_19 = T(2) * omega1_3;
  const T t2_20 = T(2) * omega1_2;
  const T t2_21 = sddot2_1 - t2_19 * sdot2_2 + t2_20 * sdot2_3 + U1_12 * d2_2 - minus_U1_11 * d2_1 + U1_13 * d2_3;
  const T t2_22 = T(2) * omega1_1;
  const T t2_23 = sddot2_2 - t2_22 * sdot2_3 + t2_19 * sdot2_1 + U1_21 * d2_1 - minus_U1_22 * d2_2 + U1_23 * d2_3;
  const T t2_24 = sddot2_3 - t2_20 * sdot2_1 + t2_22 * sdot2_2 + U1_31 * d2_1 + U1_32 * d2_2 - minus_U1_33 * d2_3;
  const T Pddot2_1 = R1_11 * t2_21 + R1_21 * t2_23 + R1_31 * t2_24 + sddot1_1;
  const T Pddot2_2 = R1_12 * t2_21 + R1_22 * t2_23 + R1_32 * t2_24 + sddot1_2;
  const T Pddot2_3 = R1_13 * t2_21 + R1_23 * t2_23 + R1_33 * t2_24 + Pddot1_3;
  // a2 = R2^T U2 r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_25 = U2_12 * T(0.31) - minus_U2_11 * T(0.011);
  const T t2_26 = U2_21 * T(0.011) - minus_U2_22 * T(0.31);
  const T t2_27 = U2_31 * T(0.011) + U2_32 * T(0.31);
  const T a2_1 = R2_11 * t2_25 + R2_21 * t2_26 + R2_31 * t2_27 + Pddot2_1;
  const T a2_2 = R2_12 * t2_25 + R2_22 * t2_26 + R2_32 * t2_27 + Pddot2_2;
  const T a2_3 = R2_13 * t2_25 + R2_23 * t2_26 + R2_33 * t2_27 + Pddot2_3;
  // G2 = m2 a2 - F2: force balance, inertial axes [N]
  const T G2_1 = T(0.64) * a2_1 - T(0.08);
  const T G2_2 = T(0.64) * a2_2 + T(1.11);
  const T G2_3 = T(0.64) * a2_3 + T(0.29);
  // N2 = -M2 + axial(U2 (tr(I2)/2 - I2)): moment balance about the mass centre, body axes [N m]
  const T N2_1 = T(0.07235) * U2_32 - T(0.04715) * U2_23 - T(0.0049) * (minus_U2_22 - minus_U2_33) - T(1e-04) * U2_31
      + T(0.0037) * U2_21 + T(0.022);
  const T N2_2 = T(0.04715) * U2_13 - T(0.07275000000000001) * U2_31 - T(0.0037) * (minus_U2_33 - minus_U2_11) -
      T(0.0049) * U2_12 + T(1e-04) * U2_32 - T(0.054);
  const T N2_3 = T(0.07275000000000001) * U2_21 - T(0.07235) * U2_12 - T(1e-04) * (minus_U2_11 - minus_U2_22) -
      T(0.0037) * U2_23 + T(0.0049) * U2_13 + T(0.079);

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[42], sdot3_2 = y[43], sdot3_3 = y[44];
  const T omegadot3_1 = ydot[6], omegadot3_2 = ydot[7], omegadot3_3 = ydot[8];
  const T sddot3_1 = ydot[42], sddot3_2 = ydot[43], sddot3_3 = ydot[44];
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
  // d3 = q3 + s3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = s3_1 - T(0.476);
  const T d3_2 = s3_2 - T(0.178);
  const T d3_3 = T(0.287) + s3_3;
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
  // Pddot3 = R2^T (2 omega2~ sdot3 + sddot3 + U2 d3) + Pddot2: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t3_19 = T(2) * omega2_3;
  const T t3_20 = T(2) * omega2_2;
  const T t3_21 = sddot3_1 - t3_19 * sdot3_2 + t3_20 * sdot3_3 + U2_12 * d3_2 - minus_U2_11 * d3_1 + U2_13 * d3_3;
  const T t3_22 = T(2) * omega2_1;
  const T t3_23 = sddot3_2 - t3_22 * sdot3_3 + t3_19 * sdot3_1 + U2_21 * d3_1 - minus_U2_22 * d3_2 + U2_23 * d3_3;
  const T t3_24 = sddot3_3 - t3_20 * sdot3_1 + t3_22 * sdot3_2 + U2_31 * d3_1 + U2_32 * d3_2 - minus_U2_33 * d3_3;
  const T Pddot3_1 = R2_11 * t3_21 + R2_21 * t3_23 + R2_31 * t3_24 + Pddot2_1;
  const T Pddot3_2 = R2_12 * t3_21 + R2_22 * t3_23 + R2_32 * t3_24 + Pddot2_2;
  const T Pddot3_3 = R2_13 * t3_21 + R2_23 * t3_23 + R2_33 * t3_24 + Pddot2_3;
  // a3 = R3^T U3 r3 + Pddot3: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t3_25 = U3_12 * T(0.498) - minus_U3_11 * T(0.484) + U3_13 * T(0.004);
  const T t3_26 = U3_21 * T(0.484) - minus_U3_22 * T(0.498) + U3_23 * T(0.004);
  const T t3_27 = U3_31 * T(0.484) + U3_32 * T(0.498) - minus_U3_33 * T(0.004);
  const T a3_1 = R3_11 * t3_25 + R3_21 * t3_26 + R3_31 * t3_27 + Pddot3_1;
  const T a3_2 = R3_12 * t3_25 + R3_22 * t3_26 + R3_32 * t3_27 + Pddot3_2;
  const T a3_3 = R3_13 * t3_25 + R3_23 * t3_26 + R3_33 * t3_27 + Pddot3_3;
  // G3 = m3 a3 - F3: force balance, inertial axes [N]
  const T G3_1 = T(2.14) * a3_1 - T(1.33);
  const T G3_2 = T(2.14) * a3_2 - T(0.56);
  const T G3_3 = T(2.14) * a3_3 + T(1.08);
  // N3 = -M3 + axial(U3 (tr(I3)/2 - I3)): moment balance about the mass centre, body axes [N m]
  const T N3_1 = T(0.2094) * U3_32 - T(0.15219999999999997) * U3_23 + T(0.0036) * (minus_U3_22 - minus_U3_33) -
      T(0.0388) * U3_31 + T(0.038) * U3_21 - T(0.005);
  const T N3_2 = T(0.15219999999999997) * U3_13 - T(0.046400000000000025) * U3_31 - T(0.038) * (minus_U3_33 -
      minus_U3_11) + T(0.0036) * U3_12 + T(0.0388) * U3_32 + T(0.005);
  const T N3_3 = T(0.046400000000000025) * U3_21 - T(0.2094) * U3_12 - T(0.0388) * (minus_U3_11 - minus_U3_22) -
      T(0.038) * U3_23 - T(0.0036) * U3_13 - T(0.025);

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[45], sdot4_2 = y[46], sdot4_3 = y[47];
  const T omegadot4_1 = ydot[9], omegadot4_2 = ydot[10], omegadot4_3 = ydot[11];
  const T sddot4_1 = ydot[45], sddot4_2 = ydot[46], sddot4_3 = ydot[47];
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
  // d4 = q4 + s4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = s4_1 - T(0.153);
  const T d4_2 = s4_2 - T(0.132);
  const T d4_3 = T(0.236) + s4_3;
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
  // Pddot4 = R3^T (2 omega3~ sdot4 + sddot4 + U3 d4) + Pddot3: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t4_19 = T(2) * omega3_3;
  const T t4_20 = T(2) * omega3_2;
  const T t4_21 = sddot4_1 - t4_19 * sdot4_2 + t4_20 * sdot4_3 + U3_12 * d4_2 - minus_U3_11 * d4_1 + U3_13 * d4_3;
  const T t4_22 = T(2) * omega3_1;
  const T t4_23 = sddot4_2 - t4_22 * sdot4_3 + t4_19 * sdot4_1 + U3_21 * d4_1 - minus_U3_22 * d4_2 + U3_23 * d4_3;
  const T t4_24 = sddot4_3 - t4_20 * sdot4_1 + t4_22 * sdot4_2 + U3_31 * d4_1 + U3_32 * d4_2 - minus_U3_33 * d4_3;
  const T Pddot4_1 = R3_11 * t4_21 + R3_21 * t4_23 + R3_31 * t4_24 + Pddot3_1;
  const T Pddot4_2 = R3_12 * t4_21 + R3_22 * t4_23 + R3_32 * t4_24 + Pddot3_2;
  const T Pddot4_3 = R3_13 * t4_21 + R3_23 * t4_23 + R3_33 * t4_24 + Pddot3_3;
  // a4 = R4^T U4 r4 + Pddot4: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t4_25 = U4_12 * T(0.289) - minus_U4_11 * T(0.401) + U4_13 * T(0.08);
  const T t4_26 = U4_21 * T(0.401) - minus_U4_22 * T(0.289) + U4_23 * T(0.08);
  const T t4_27 = U4_31 * T(0.401) + U4_32 * T(0.289) - minus_U4_33 * T(0.08);
  const T a4_1 = R4_11 * t4_25 + R4_21 * t4_26 + R4_31 * t4_27 + Pddot4_1;
  const T a4_2 = R4_12 * t4_25 + R4_22 * t4_26 + R4_32 * t4_27 + Pddot4_2;
  const T a4_3 = R4_13 * t4_25 + R4_23 * t4_26 + R4_33 * t4_27 + Pddot4_3;
  // G4 = m4 a4 - F4: force balance, inertial axes [N]
  const T G4_1 = T(4.49) * a4_1 - T(0.25);
  const T G4_2 = T(4.49) * a4_2 + T(1.93);
  const T G4_3 = T(4.49) * a4_3 - T(0.84);
  // N4 = -M4 + axial(U4 (tr(I4)/2 - I4)): moment balance about the mass centre, body axes [N m]
  const T N4_1 = T(0.1281) * U4_32 - T(0.127) * U4_23 + T(0.0221) * (minus_U4_22 - minus_U4_33) - T(0.0225) * U4_31 -
      T(0.0283) * U4_21 - T(0.081);
  const T N4_2 = T(0.127) * U4_13 - T(0.1127) * U4_31 + T(0.0283) * (minus_U4_33 - minus_U4_11) + T(0.0221) * U4_12 +
      T(0.0225) * U4_32 - T(0.06);
  const T N4_3 = T(0.1127) * U4_21 - T(0.1281) * U4_12 - T(0.0225) * (minus_U4_11 - minus_U4_22) + T(0.0283) * U4_23 -
      T(0.0221) * U4_13 - T(0.079);

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[48], sdot5_2 = y[49], sdot5_3 = y[50];
  const T omegadot5_1 = ydot[12], omegadot5_2 = ydot[13], omegadot5_3 = ydot[14];
  const T sddot5_1 = ydot[48], sddot5_2 = ydot[49], sddot5_3 = ydot[50];
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
  // d5 = q5 + s5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = s5_1 - T(0.159);
  const T d5_2 = s5_2 - T(0.262);
  const T d5_3 = s5_3 - T(0.173);
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
  // Pddot5 = R3^T (2 omega3~ sdot5 + sddot5 + U3 d5) + Pddot3: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t5_19 = sddot5_1 - t4_19 * sdot5_2 + t4_20 * sdot5_3 + U3_12 * d5_2 - minus_U3_11 * d5_1 + U3_13 * d5_3;
  const T t5_20 = sddot5_2 - t4_22 * sdot5_3 + t4_19 * sdot5_1 + U3_21 * d5_1 - minus_U3_22 * d5_2 + U3_23 * d5_3;
  const T t5_21 = sddot5_3 - t4_20 * sdot5_1 + t4_22 * sdot5_2 + U3_31 * d5_1 + U3_32 * d5_2 - minus_U3_33 * d5_3;
  const T Pddot5_1 = R3_11 * t5_19 + R3_21 * t5_20 + R3_31 * t5_21 + Pddot3_1;
  const T Pddot5_2 = R3_12 * t5_19 + R3_22 * t5_20 + R3_32 * t5_21 + Pddot3_2;
  const T Pddot5_3 = R3_13 * t5_19 + R3_23 * t5_20 + R3_33 * t5_21 + Pddot3_3;
  // a5 = R5^T U5 r5 + Pddot5: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t5_22 = minus_U5_11 * T(0.056) - U5_12 * T(0.321) + U5_13 * T(0.167);
  const T t5_23 = minus_U5_22 * T(0.321) - U5_21 * T(0.056) + U5_23 * T(0.167);
  const T t5_24 = U5_31 * T(0.056) + U5_32 * T(0.321) + minus_U5_33 * T(0.167);
  const T a5_1 = R5_11 * t5_22 + R5_21 * t5_23 - R5_31 * t5_24 + Pddot5_1;
  const T a5_2 = R5_12 * t5_22 + R5_22 * t5_23 - R5_32 * t5_24 + Pddot5_2;
  const T a5_3 = R5_13 * t5_22 + R5_23 * t5_23 - R5_33 * t5_24 + Pddot5_3;
  // G5 = m5 a5 - F5: force balance, inertial axes [N]
  const T G5_1 = T(1.96) * a5_1 - T(1.78);
  const T G5_2 = T(1.96) * a5_2 + T(1.97);
  const T G5_3 = T(1.96) * a5_3 + T(0.56);
  // N5 = -M5 + axial(U5 (tr(I5)/2 - I5)): moment balance about the mass centre, body axes [N m]
  const T N5_1 = T(0.031549999999999995) * U5_32 - T(0.019850000000000007) * U5_23 + T(0.0036) * (minus_U5_22 -
      minus_U5_33) - T(0.0396) * U5_31 + T(0.0143) * U5_21 + T(0.044);
  const T N5_2 = T(0.019850000000000007) * U5_13 - T(0.10944999999999999) * U5_31 - T(0.0143) * (minus_U5_33 -
      minus_U5_11) + T(0.0036) * U5_12 + T(0.0396) * U5_32 + T(0.06);
  const T N5_3 = T(0.10944999999999999) * U5_21 - T(0.031549999999999995) * U5_12 - T(0.0396) * (minus_U5_11 -
      minus_U5_22) - T(0.0143) * U5_23 - T(0.0036) * U5_13 + T(0.014);

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[51], sdot6_2 = y[52], sdot6_3 = y[53];
  const T omegadot6_1 = ydot[15], omegadot6_2 = ydot[16], omegadot6_3 = ydot[17];
  const T sddot6_1 = ydot[51], sddot6_2 = ydot[52], sddot6_3 = ydot[53];
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
  // d6 = q6 + s6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.304) + s6_1;
  const T d6_2 = s6_2 - T(0.214);
  const T d6_3 = T(0.436) + s6_3;
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
  // Pddot6 = R2^T (2 omega2~ sdot6 + sddot6 + U2 d6) + Pddot2: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t6_19 = sddot6_1 - t3_19 * sdot6_2 + t3_20 * sdot6_3 + U2_12 * d6_2 - minus_U2_11 * d6_1 + U2_13 * d6_3;
  const T t6_20 = sddot6_2 - t3_22 * sdot6_3 + t3_19 * sdot6_1 + U2_21 * d6_1 - minus_U2_22 * d6_2 + U2_23 * d6_3;
  const T t6_21 = sddot6_3 - t3_20 * sdot6_1 + t3_22 * sdot6_2 + U2_31 * d6_1 + U2_32 * d6_2 - minus_U2_33 * d6_3;
  const T Pddot6_1 = R2_11 * t6_19 + R2_21 * t6_20 + R2_31 * t6_21 + Pddot2_1;
  const T Pddot6_2 = R2_12 * t6_19 + R2_22 * t6_20 + R2_32 * t6_21 + Pddot2_2;
  const T Pddot6_3 = R2_13 * t6_19 + R2_23 * t6_20 + R2_33 * t6_21 + Pddot2_3;
  // a6 = R6^T U6 r6 + Pddot6: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t6_22 = U6_21 * T(0.044) + minus_U6_22 * T(0.248) - U6_23 * T(0.454);
  const T t6_23 = minus_U6_11 * T(0.044) + U6_12 * T(0.248) + U6_13 * T(0.454);
  const T t6_24 = U6_31 * T(0.044) - U6_32 * T(0.248) + minus_U6_33 * T(0.454);
  const T a6_1 = R6_21 * t6_22 - R6_11 * t6_23 + R6_31 * t6_24 + Pddot6_1;
  const T a6_2 = R6_22 * t6_22 - R6_12 * t6_23 + R6_32 * t6_24 + Pddot6_2;
  const T a6_3 = R6_23 * t6_22 - R6_13 * t6_23 + R6_33 * t6_24 + Pddot6_3;
  // G6 = m6 a6 - F6: force balance, inertial axes [N]
  const T G6_1 = T(3.48) * a6_1 - T(0.4);
  const T G6_2 = T(3.48) * a6_2 + T(0.44);
  const T G6_3 = T(3.48) * a6_3 - T(1.49);
  // N6 = -M6 + axial(U6 (tr(I6)/2 - I6)): moment balance about the mass centre, body axes [N m]
  const T N6_1 = T(0.19614999999999996) * U6_32 - T(0.21085) * U6_23 - T(0.0219) * (minus_U6_22 - minus_U6_33) -
      T(0.035) * U6_31 + T(0.0493) * U6_21 - T(0.079);
  const T N6_2 = T(0.21085) * U6_13 - T(0.38145000000000007) * U6_31 - T(0.0493) * (minus_U6_33 - minus_U6_11) -
      T(0.0219) * U6_12 + T(0.035) * U6_32 + T(0.036);
  const T N6_3 = T(0.38145000000000007) * U6_21 - T(0.19614999999999996) * U6_12 - T(0.035) * (minus_U6_11 -
      minus_U6_22) - T(0.0493) * U6_23 + T(0.0219) * U6_13 + T(0.075);

  // ---- body 7 (body_7) on body 4
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  const T sdot7_1 = y[54], sdot7_2 = y[55], sdot7_3 = y[56];
  const T omegadot7_1 = ydot[18], omegadot7_2 = ydot[19], omegadot7_3 = ydot[20];
  const T sddot7_1 = ydot[54], sddot7_2 = ydot[55], sddot7_3 = ydot[56];
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
  // d7 = q7 + s7: joint offset q + s, axes of the lower body [m]
  const T d7_1 = s7_1 - T(0.329);
  const T d7_2 = s7_2 - T(0.337);
  const T d7_3 = T(0.216) + s7_3;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t7_13 = omega7_3 * omega7_3;
  const T t7_14 = omega7_2 * omega7_2;
  const T minus_U7_11 = t7_13 + t7_14;
  const T t7_15 = omega7_1 * omega7_2;
  const T U7_12 = t7_15 - omegadot7_3;
  const T t7_16 = omega7_1 * omega7_3;
  const T U7_13 = t7_16 + omegadot7_2;
  const T U7_21 = t7_15 + omegadot7_3;
  const T t7_17 = omega7_1 * omega7_1;
  const T minus_U7_22 = t7_13 + t7_17;
  const T t7_18 = omega7_2 * omega7_3;
  const T U7_23 = t7_18 - omegadot7_1;
  const T U7_31 = t7_16 - omegadot7_2;
  const T U7_32 = t7_18 + omegadot7_1;
  const T minus_U7_33 = t7_14 + t7_17;
  // Pddot7 = R4^T (2 omega4~ sdot7 + sddot7 + U4 d7) + Pddot4: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t7_19 = T(2) * omega4_3;
  const T t7_20 = T(2) * omega4_2;
  const T t7_21 = sddot7_1 - t7_19 * sdot7_2 + t7_20 * sdot7_3 + U4_12 * d7_2 - minus_U4_11 * d7_1 + U4_13 * d7_3;
  const T t7_22 = T(2) * omega4_1;
  const T t7_23 = sddot7_2 - t7_22 * sdot7_3 + t7_19 * sdot7_1 + U4_21 * d7_1 - minus_U4_22 * d7_2 + U4_23 * d7_3;
  const T t7_24 = sddot7_3 - t7_20 * sdot7_1 + t7_22 * sdot7_2 + U4_31 * d7_1 + U4_32 * d7_2 - minus_U4_33 * d7_3;
  const T Pddot7_1 = R4_11 * t7_21 + R4_21 * t7_23 + R4_31 * t7_24 + Pddot4_1;
  const T Pddot7_2 = R4_12 * t7_21 + R4_22 * t7_23 + R4_32 * t7_24 + Pddot4_2;
  const T Pddot7_3 = R4_13 * t7_21 + R4_23 * t7_23 + R4_33 * t7_24 + Pddot4_3;
  // a7 = R7^T U7 r7 + Pddot7: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t7_25 = minus_U7_11 * T(0.475) - U7_12 * T(0.192) - U7_13 * T(0.487);
  const T t7_26 = minus_U7_22 * T(0.192) - U7_21 * T(0.475) - U7_23 * T(0.487);
  const T t7_27 = minus_U7_33 * T(0.487) - U7_31 * T(0.475) - U7_32 * T(0.192);
  const T a7_1 = R7_11 * t7_25 + R7_21 * t7_26 + R7_31 * t7_27 + Pddot7_1;
  const T a7_2 = R7_12 * t7_25 + R7_22 * t7_26 + R7_32 * t7_27 + Pddot7_2;
  const T a7_3 = R7_13 * t7_25 + R7_23 * t7_26 + R7_33 * t7_27 + Pddot7_3;
  // G7 = m7 a7 - F7: force balance, inertial axes [N]
  const T G7_1 = T(0.74) * a7_1 + T(0.81);
  const T G7_2 = T(0.74) * a7_2 + T(1.24);
  const T G7_3 = T(0.74) * a7_3 + T(1.26);
  // N7 = -M7 + axial(U7 (tr(I7)/2 - I7)): moment balance about the mass centre, body axes [N m]
  const T N7_1 = T(0.06545) * U7_32 - T(0.06755000000000001) * U7_23 - T(0.0017) * (minus_U7_22 - minus_U7_33) +
      T(7e-04) * U7_31 + T(0.0025) * U7_21 + T(0.038);
  const T N7_2 = T(0.06755000000000001) * U7_13 - T(0.06845) * U7_31 - T(0.0025) * (minus_U7_33 - minus_U7_11) -
      T(0.0017) * U7_12 - T(7e-04) * U7_32 - T(0.072);
  const T N7_3 = T(0.06845) * U7_21 - T(0.06545) * U7_12 + T(7e-04) * (minus_U7_11 - minus_U7_22) - T(0.0025) * U7_23
      + T(0.0017) * U7_13 - T(0.021);

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  const T sdot8_1 = y[57], sdot8_2 = y[58], sdot8_3 = y[59];
  const T omegadot8_1 = ydot[21], omegadot8_2 = ydot[22], omegadot8_3 = ydot[23];
  const T sddot8_1 = ydot[57], sddot8_2 = ydot[58], sddot8_3 = ydot[59];
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
  // d8 = q8 + s8: joint offset q + s, axes of the lower body [m]
  const T d8_1 = s8_1 - T(0.492);
  const T d8_2 = s8_2 - T(0.25);
  const T d8_3 = s8_3 - T(0.387);
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_13 = omega8_3 * omega8_3;
  const T t8_14 = omega8_2 * omega8_2;
  const T minus_U8_11 = t8_13 + t8_14;
  const T t8_15 = omega8_1 * omega8_2;
  const T U8_12 = t8_15 - omegadot8_3;
  const T t8_16 = omega8_1 * omega8_3;
  const T U8_13 = t8_16 + omegadot8_2;
  const T U8_21 = t8_15 + omegadot8_3;
  const T t8_17 = omega8_1 * omega8_1;
  const T minus_U8_22 = t8_13 + t8_17;
  const T t8_18 = omega8_2 * omega8_3;
  const T U8_23 = t8_18 - omegadot8_1;
  const T U8_31 = t8_16 - omegadot8_2;
  const T U8_32 = t8_18 + omegadot8_1;
  const T minus_U8_33 = t8_14 + t8_17;
  // Pddot8 = R1^T (2 omega1~ sdot8 + sddot8 + U1 d8) + Pddot1: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t8_19 = sddot8_1 - t2_19 * sdot8_2 + t2_20 * sdot8_3 + U1_12 * d8_2 - minus_U1_11 * d8_1 + U1_13 * d8_3;
  const T t8_20 = sddot8_2 - t2_22 * sdot8_3 + t2_19 * sdot8_1 + U1_21 * d8_1 - minus_U1_22 * d8_2 + U1_23 * d8_3;
  const T t8_21 = sddot8_3 - t2_20 * sdot8_1 + t2_22 * sdot8_2 + U1_31 * d8_1 + U1_32 * d8_2 - minus_U1_33 * d8_3;
  const T Pddot8_1 = R1_11 * t8_19 + R1_21 * t8_20 + R1_31 * t8_21 + sddot1_1;
  const T Pddot8_2 = R1_12 * t8_19 + R1_22 * t8_20 + R1_32 * t8_21 + sddot1_2;
  const T Pddot8_3 = R1_13 * t8_19 + R1_23 * t8_20 + R1_33 * t8_21 + Pddot1_3;
  // a8 = R8^T U8 r8 + Pddot8: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t8_22 = minus_U8_11 * T(0.392) - U8_12 * T(0.416) - U8_13 * T(0.444);
  const T t8_23 = minus_U8_22 * T(0.416) - U8_21 * T(0.392) - U8_23 * T(0.444);
  const T t8_24 = minus_U8_33 * T(0.444) - U8_31 * T(0.392) - U8_32 * T(0.416);
  const T a8_1 = R8_11 * t8_22 + R8_21 * t8_23 + R8_31 * t8_24 + Pddot8_1;
  const T a8_2 = R8_12 * t8_22 + R8_22 * t8_23 + R8_32 * t8_24 + Pddot8_2;
  const T a8_3 = R8_13 * t8_22 + R8_23 * t8_23 + R8_33 * t8_24 + Pddot8_3;
  // G8 = m8 a8 - F8: force balance, inertial axes [N]
  const T G8_1 = T(2.71) * a8_1 - T(0.74);
  const T G8_2 = T(2.71) * a8_2 - T(0.46);
  const T G8_3 = T(2.71) * a8_3 - T(1.86);
  // N8 = -M8 + axial(U8 (tr(I8)/2 - I8)): moment balance about the mass centre, body axes [N m]
  const T N8_1 = T(0.23319999999999996) * U8_32 - T(0.21600000000000003) * U8_23 - T(0.028) * (minus_U8_22 -
      minus_U8_33) + T(0.0147) * U8_31 - T(0.0399) * U8_21 - T(0.092);
  const T N8_2 = T(0.21600000000000003) * U8_13 - T(0.2834) * U8_31 + T(0.0399) * (minus_U8_33 - minus_U8_11) -
      T(0.028) * U8_12 - T(0.0147) * U8_32 - T(0.049);
  const T N8_3 = T(0.2834) * U8_21 - T(0.23319999999999996) * U8_12 + T(0.0147) * (minus_U8_11 - minus_U8_22) +
      T(0.0399) * U8_23 + T(0.028) * U8_13 - T(0.09);

  // ---- body 9 (body_9) on body 6
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  const T sdot9_1 = y[60], sdot9_2 = y[61], sdot9_3 = y[62];
  const T omegadot9_1 = ydot[24], omegadot9_2 = ydot[25], omegadot9_3 = ydot[26];
  const T sddot9_1 = ydot[60], sddot9_2 = ydot[61], sddot9_3 = ydot[62];
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
  // d9 = q9 + s9: joint offset q + s, axes of the lower body [m]
  const T d9_1 = s9_1 - T(0.305);
  const T d9_2 = T(0.124) + s9_2;
  const T d9_3 = T(0.036) + s9_3;
  // U9 = omega9~ omega9~ + omegadot9~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t9_13 = omega9_3 * omega9_3;
  const T t9_14 = omega9_2 * omega9_2;
  const T minus_U9_11 = t9_13 + t9_14;
  const T t9_15 = omega9_1 * omega9_2;
  const T U9_12 = t9_15 - omegadot9_3;
  const T t9_16 = omega9_1 * omega9_3;
  const T U9_13 = t9_16 + omegadot9_2;
  const T U9_21 = t9_15 + omegadot9_3;
  const T t9_17 = omega9_1 * omega9_1;
  const T minus_U9_22 = t9_13 + t9_17;
  const T t9_18 = omega9_2 * omega9_3;
  const T U9_23 = t9_18 - omegadot9_1;
  const T U9_31 = t9_16 - omegadot9_2;
  const T U9_32 = t9_18 + omegadot9_1;
  const T minus_U9_33 = t9_14 + t9_17;
  // Pddot9 = R6^T (2 omega6~ sdot9 + sddot9 + U6 d9) + Pddot6: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t9_19 = T(2) * omega6_3;
  const T t9_20 = T(2) * omega6_2;
  const T t9_21 = sddot9_1 - t9_19 * sdot9_2 + t9_20 * sdot9_3 + U6_12 * d9_2 - minus_U6_11 * d9_1 + U6_13 * d9_3;
  const T t9_22 = T(2) * omega6_1;
  const T t9_23 = sddot9_2 - t9_22 * sdot9_3 + t9_19 * sdot9_1 + U6_21 * d9_1 - minus_U6_22 * d9_2 + U6_23 * d9_3;
  const T t9_24 = sddot9_3 - t9_20 * sdot9_1 + t9_22 * sdot9_2 + U6_31 * d9_1 + U6_32 * d9_2 - minus_U6_33 * d9_3;
  const T Pddot9_1 = R6_11 * t9_21 + R6_21 * t9_23 + R6_31 * t9_24 + Pddot6_1;
  const T Pddot9_2 = R6_12 * t9_21 + R6_22 * t9_23 + R6_32 * t9_24 + Pddot6_2;
  const T Pddot9_3 = R6_13 * t9_21 + R6_23 * t9_23 + R6_33 * t9_24 + Pddot6_3;
  // a9 = R9^T U9 r9 + Pddot9: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t9_25 = U9_12 * T(0.49) - minus_U9_11 * T(0.362) - U9_13 * T(0.015);
  const T t9_26 = U9_21 * T(0.362) - minus_U9_22 * T(0.49) - U9_23 * T(0.015);
  const T t9_27 = U9_31 * T(0.362) + U9_32 * T(0.49) + minus_U9_33 * T(0.015);
  const T a9_1 = R9_11 * t9_25 + R9_21 * t9_26 + R9_31 * t9_27 + Pddot9_1;
  const T a9_2 = R9_12 * t9_25 + R9_22 * t9_26 + R9_32 * t9_27 + Pddot9_2;
  const T a9_3 = R9_13 * t9_25 + R9_23 * t9_26 + R9_33 * t9_27 + Pddot9_3;
  // G9 = m9 a9 - F9: force balance, inertial axes [N]
  const T G9_1 = T(1.84) * a9_1 + T(0.55);
  const T G9_2 = T(1.84) * a9_2 + T(1.08);
  const T G9_3 = T(1.84) * a9_3 + T(0.46);
  // N9 = -M9 + axial(U9 (tr(I9)/2 - I9)): moment balance about the mass centre, body axes [N m]
  const T N9_1 = T(0.10434999999999998) * U9_32 - T(0.12665000000000004) * U9_23 + T(0.0093) * (minus_U9_22 -
      minus_U9_33) - T(0.0215) * U9_31 + T(0.0257) * U9_21 - T(0.022);
  const T N9_2 = T(0.12665000000000004) * U9_13 - T(0.17654999999999998) * U9_31 - T(0.0257) * (minus_U9_33 -
      minus_U9_11) + T(0.0093) * U9_12 + T(0.0215) * U9_32 + T(0.075);
  const T N9_3 = T(0.17654999999999998) * U9_21 - T(0.10434999999999998) * U9_12 - T(0.0215) * (minus_U9_11 -
      minus_U9_22) - T(0.0257) * U9_23 - T(0.0093) * U9_13 - T(0.008);

  // ---- body 10 (body_10) on body 8
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  const T sdot10_1 = y[63], sdot10_2 = y[64], sdot10_3 = y[65];
  const T omegadot10_1 = ydot[27], omegadot10_2 = ydot[28], omegadot10_3 = ydot[29];
  const T sddot10_1 = ydot[63], sddot10_2 = ydot[64], sddot10_3 = ydot[65];
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
  // d10 = q10 + s10: joint offset q + s, axes of the lower body [m]
  const T d10_1 = T(0.172) + s10_1;
  const T d10_2 = s10_2 - T(0.399);
  const T d10_3 = s10_3 - T(0.25);
  // U10 = omega10~ omega10~ + omegadot10~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t10_13 = omega10_3 * omega10_3;
  const T t10_14 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_13 + t10_14;
  const T t10_15 = omega10_1 * omega10_2;
  const T U10_12 = t10_15 - omegadot10_3;
  const T t10_16 = omega10_1 * omega10_3;
  const T U10_13 = t10_16 + omegadot10_2;
  const T U10_21 = t10_15 + omegadot10_3;
  const T t10_17 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_13 + t10_17;
  const T t10_18 = omega10_2 * omega10_3;
  const T U10_23 = t10_18 - omegadot10_1;
  const T U10_31 = t10_16 - omegadot10_2;
  const T U10_32 = t10_18 + omegadot10_1;
  const T minus_U10_33 = t10_14 + t10_17;
  // Pddot10 = R8^T (2 omega8~ sdot10 + sddot10 + U8 d10) + Pddot8: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t10_19 = T(2) * omega8_3;
  const T t10_20 = T(2) * omega8_2;
  const T t10_21 = sddot10_1 - t10_19 * sdot10_2 + t10_20 * sdot10_3 + U8_12 * d10_2 - minus_U8_11 * d10_1 + U8_13 *
      d10_3;
  const T t10_22 = T(2) * omega8_1;
  const T t10_23 = sddot10_2 - t10_22 * sdot10_3 + t10_19 * sdot10_1 + U8_21 * d10_1 - minus_U8_22 * d10_2 + U8_23 *
      d10_3;
  const T t10_24 = sddot10_3 - t10_20 * sdot10_1 + t10_22 * sdot10_2 + U8_31 * d10_1 + U8_32 * d10_2 - minus_U8_33 *
      d10_3;
  const T Pddot10_1 = R8_11 * t10_21 + R8_21 * t10_23 + R8_31 * t10_24 + Pddot8_1;
  const T Pddot10_2 = R8_12 * t10_21 + R8_22 * t10_23 + R8_32 * t10_24 + Pddot8_2;
  const T Pddot10_3 = R8_13 * t10_21 + R8_23 * t10_23 + R8_33 * t10_24 + Pddot8_3;
  // a10 = R10^T U10 r10 + Pddot10: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t10_25 = U10_12 * T(0.148) - minus_U10_11 * T(0.016) - U10_13 * T(0.426);
  const T t10_26 = U10_21 * T(0.016) - minus_U10_22 * T(0.148) - U10_23 * T(0.426);
  const T t10_27 = U10_31 * T(0.016) + U10_32 * T(0.148) + minus_U10_33 * T(0.426);
  const T a10_1 = R10_11 * t10_25 + R10_21 * t10_26 + R10_31 * t10_27 + Pddot10_1;
  const T a10_2 = R10_12 * t10_25 + R10_22 * t10_26 + R10_32 * t10_27 + Pddot10_2;
  const T a10_3 = R10_13 * t10_25 + R10_23 * t10_26 + R10_33 * t10_27 + Pddot10_3;
  // G10 = m10 a10 - F10: force balance, inertial axes [N]
  const T G10_1 = T(2.57) * a10_1 - T(1.24);
  const T G10_2 = T(2.57) * a10_2 - T(1.96);
  const T G10_3 = T(2.57) * a10_3 - T(0.69);
  // N10 = -M10 + axial(U10 (tr(I10)/2 - I10)): moment balance about the mass centre, body axes [N m]
  const T N10_1 = T(0.050249999999999996) * U10_32 - T(0.03305) * U10_23 + T(0.0065) * (minus_U10_22 - minus_U10_33) -
      T(0.0191) * U10_31 + T(0.0097) * U10_21 + T(0.066);
  const T N10_2 = T(0.03305) * U10_13 - T(0.05865) * U10_31 - T(0.0097) * (minus_U10_33 - minus_U10_11) + T(0.0065) *
      U10_12 + T(0.0191) * U10_32 + T(0.012);
  const T N10_3 = T(0.05865) * U10_21 - T(0.050249999999999996) * U10_12 - T(0.0191) * (minus_U10_11 - minus_U10_22) -
      T(0.0097) * U10_23 - T(0.0065) * U10_13 + T(0.043);

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  const T sdot11_1 = y[66], sdot11_2 = y[67], sdot11_3 = y[68];
  const T omegadot11_1 = ydot[30], omegadot11_2 = ydot[31], omegadot11_3 = ydot[32];
  const T sddot11_1 = ydot[66], sddot11_2 = ydot[67], sddot11_3 = ydot[68];
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
  // d11 = q11 + s11: joint offset q + s, axes of the lower body [m]
  const T d11_1 = s11_1 - T(0.079);
  const T d11_2 = s11_2 - T(0.186);
  const T d11_3 = s11_3 - T(0.241);
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_13 = omega11_3 * omega11_3;
  const T t11_14 = omega11_2 * omega11_2;
  const T minus_U11_11 = t11_13 + t11_14;
  const T t11_15 = omega11_1 * omega11_2;
  const T U11_12 = t11_15 - omegadot11_3;
  const T t11_16 = omega11_1 * omega11_3;
  const T U11_13 = t11_16 + omegadot11_2;
  const T U11_21 = t11_15 + omegadot11_3;
  const T t11_17 = omega11_1 * omega11_1;
  const T minus_U11_22 = t11_13 + t11_17;
  const T t11_18 = omega11_2 * omega11_3;
  const T U11_23 = t11_18 - omegadot11_1;
  const T U11_31 = t11_16 - omegadot11_2;
  const T U11_32 = t11_18 + omegadot11_1;
  const T minus_U11_33 = t11_14 + t11_17;
  // Pddot11 = R5^T (2 omega5~ sdot11 + sddot11 + U5 d11) + Pddot5: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t11_19 = T(2) * omega5_3;
  const T t11_20 = T(2) * omega5_2;
  const T t11_21 = sddot11_1 - t11_19 * sdot11_2 + t11_20 * sdot11_3 + U5_12 * d11_2 - minus_U5_11 * d11_1 + U5_13 *
      d11_3;
  const T t11_22 = T(2) * omega5_1;
  const T t11_23 = sddot11_2 - t11_22 * sdot11_3 + t11_19 * sdot11_1 + U5_21 * d11_1 - minus_U5_22 * d11_2 + U5_23 *
      d11_3;
  const T t11_24 = sddot11_3 - t11_20 * sdot11_1 + t11_22 * sdot11_2 + U5_31 * d11_1 + U5_32 * d11_2 - minus_U5_33 *
      d11_3;
  const T Pddot11_1 = R5_11 * t11_21 + R5_21 * t11_23 + R5_31 * t11_24 + Pddot5_1;
  const T Pddot11_2 = R5_12 * t11_21 + R5_22 * t11_23 + R5_32 * t11_24 + Pddot5_2;
  const T Pddot11_3 = R5_13 * t11_21 + R5_23 * t11_23 + R5_33 * t11_24 + Pddot5_3;
  // a11 = R11^T U11 r11 + Pddot11: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t11_25 = U11_13 * T(0.337) - minus_U11_11 * T(0.402) - U11_12 * T(0.348);
  const T t11_26 = U11_21 * T(0.402) + minus_U11_22 * T(0.348) + U11_23 * T(0.337);
  const T t11_27 = U11_31 * T(0.402) - U11_32 * T(0.348) - minus_U11_33 * T(0.337);
  const T a11_1 = R11_11 * t11_25 + R11_21 * t11_26 + R11_31 * t11_27 + Pddot11_1;
  const T a11_2 = R11_12 * t11_25 + R11_22 * t11_26 + R11_32 * t11_27 + Pddot11_2;
  const T a11_3 = R11_13 * t11_25 + R11_23 * t11_26 + R11_33 * t11_27 + Pddot11_3;
  // G11 = m11 a11 - F11: force balance, inertial axes [N]
  const T G11_1 = T(3.77) * a11_1 + T(0.34);
  const T G11_2 = T(3.77) * a11_2 + T(1.79);
  const T G11_3 = T(3.77) * a11_3 + T(1.8);
  // N11 = -M11 + axial(U11 (tr(I11)/2 - I11)): moment balance about the mass centre, body axes [N m]
  const T N11_1 = T(0.20725000000000002) * U11_32 - T(0.16565) * U11_23 - T(0.0124) * (minus_U11_22 - minus_U11_33) +
      T(3e-04) * U11_31 - T(0.0238) * U11_21 + T(0.077);
  const T N11_2 = T(0.16565) * U11_13 - T(0.22465) * U11_31 + T(0.0238) * (minus_U11_33 - minus_U11_11) - T(0.0124) *
      U11_12 - T(3e-04) * U11_32 + T(0.039);
  const T N11_3 = T(0.22465) * U11_21 - T(0.20725000000000002) * U11_12 + T(3e-04) * (minus_U11_11 - minus_U11_22) +
      T(0.0238) * U11_23 + T(0.0124) * U11_13 + T(0.068);

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  const T sdot12_1 = y[69], sdot12_2 = y[70], sdot12_3 = y[71];
  const T omegadot12_1 = ydot[33], omegadot12_2 = ydot[34], omegadot12_3 = ydot[35];
  const T sddot12_1 = ydot[69], sddot12_2 = ydot[70], sddot12_3 = ydot[71];
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
  // d12 = q12 + s12: joint offset q + s, axes of the lower body [m]
  const T d12_1 = s12_1 - T(0.422);
  const T d12_2 = T(0.42) + s12_2;
  const T d12_3 = T(0.022) + s12_3;
  // U12 = omega12~ omega12~ + omegadot12~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t12_13 = omega12_3 * omega12_3;
  const T t12_14 = omega12_2 * omega12_2;
  const T minus_U12_11 = t12_13 + t12_14;
  const T t12_15 = omega12_1 * omega12_2;
  const T U12_12 = t12_15 - omegadot12_3;
  const T t12_16 = omega12_1 * omega12_3;
  const T U12_13 = t12_16 + omegadot12_2;
  const T U12_21 = t12_15 + omegadot12_3;
  const T t12_17 = omega12_1 * omega12_1;
  const T minus_U12_22 = t12_13 + t12_17;
  const T t12_18 = omega12_2 * omega12_3;
  const T U12_23 = t12_18 - omegadot12_1;
  const T U12_31 = t12_16 - omegadot12_2;
  const T U12_32 = t12_18 + omegadot12_1;
  const T minus_U12_33 = t12_14 + t12_17;
  // Pddot12 = R11^T (2 omega11~ sdot12 + sddot12 + U11 d12) + Pddot11: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t12_19 = T(2) * omega11_3;
  const T t12_20 = T(2) * omega11_2;
  const T t12_21 = sddot12_1 - t12_19 * sdot12_2 + t12_20 * sdot12_3 + U11_12 * d12_2 - minus_U11_11 * d12_1 + U11_13
      * d12_3;
  const T t12_22 = T(2) * omega11_1;
  const T t12_23 = sddot12_2 - t12_22 * sdot12_3 + t12_19 * sdot12_1 + U11_21 * d12_1 - minus_U11_22 * d12_2 + U11_23
      * d12_3;
  const T t12_24 = sddot12_3 - t12_20 * sdot12_1 + t12_22 * sdot12_2 + U11_31 * d12_1 + U11_32 * d12_2 - minus_U11_33
      * d12_3;
  const T Pddot12_1 = R11_11 * t12_21 + R11_21 * t12_23 + R11_31 * t12_24 + Pddot11_1;
  const T Pddot12_2 = R11_12 * t12_21 + R11_22 * t12_23 + R11_32 * t12_24 + Pddot11_2;
  const T Pddot12_3 = R11_13 * t12_21 + R11_23 * t12_23 + R11_33 * t12_24 + Pddot11_3;
  // a12 = R12^T U12 r12 + Pddot12: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t12_25 = minus_U12_11 * T(0.006) - U12_12 * T(0.141) - U12_13 * T(0.1);
  const T t12_26 = minus_U12_22 * T(0.141) - U12_21 * T(0.006) - U12_23 * T(0.1);
  const T t12_27 = minus_U12_33 * T(0.1) - U12_31 * T(0.006) - U12_32 * T(0.141);
  const T a12_1 = R12_11 * t12_25 + R12_21 * t12_26 + R12_31 * t12_27 + Pddot12_1;
  const T a12_2 = R12_12 * t12_25 + R12_22 * t12_26 + R12_32 * t12_27 + Pddot12_2;
  const T a12_3 = R12_13 * t12_25 + R12_23 * t12_26 + R12_33 * t12_27 + Pddot12_3;
  // G12 = m12 a12 - F12: force balance, inertial axes [N]
  const T G12_1 = T(4.06) * a12_1 - T(0.25);
  const T G12_2 = T(4.06) * a12_2 - T(1.37);
  const T G12_3 = T(4.06) * a12_3 - T(1.59);
  // N12 = -M12 + axial(U12 (tr(I12)/2 - I12)): moment balance about the mass centre, body axes [N m]
  const T N12_1 = T(0.07305000000000003) * U12_32 - T(0.34065) * U12_23 + T(0.0023) * (minus_U12_22 - minus_U12_33) -
      T(0.0121) * U12_31 - T(0.1084) * U12_21 - T(0.01);
  const T N12_2 = T(0.34065) * U12_13 - T(0.25454999999999994) * U12_31 + T(0.1084) * (minus_U12_33 - minus_U12_11) +
      T(0.0023) * U12_12 + T(0.0121) * U12_32 - T(0.009);
  const T N12_3 = T(0.25454999999999994) * U12_21 - T(0.07305000000000003) * U12_12 - T(0.0121) * (minus_U12_11 -
      minus_U12_22) + T(0.1084) * U12_23 - T(0.0023) * U12_13 - T(0.069);

  // ---- body 12 (body_12) and what it carries
  // r_omega12 = r12~ R12 G12 + N12: Kane's equation of omega [N m]
  const T b12_1 = R12_21 * G12_1 + R12_22 * G12_2 + R12_23 * G12_3;
  const T b12_2 = R12_31 * G12_1 + R12_32 * G12_2 + R12_33 * G12_3;
  const T r_omega12_1 = T(0.1) * b12_1 - T(0.141) * b12_2 + N12_1;
  const T b12_3 = R12_11 * G12_1 + R12_12 * G12_2 + R12_13 * G12_3;
  const T r_omega12_2 = T(0.006) * b12_2 - T(0.1) * b12_3 + N12_2;
  const T r_omega12_3 = T(0.141) * b12_3 - T(0.006) * b12_1 + N12_3;
  r[33] = r_omega12_1;
  r[34] = r_omega12_2;
  r[35] = r_omega12_3;
  // r_sdot12 = R11 G12: Kane's equation of sdot [N]
  const T r_sdot12_1 = R11_11 * G12_1 + R11_12 * G12_2 + R11_13 * G12_3;
  const T r_sdot12_2 = R11_21 * G12_1 + R11_22 * G12_2 + R11_23 * G12_3;
  const T r_sdot12_3 = R11_31 * G12_1 + R11_32 * G12_2 + R11_33 * G12_3;
  r[69] = r_sdot12_1;
  r[70] = r_sdot12_2;
  r[71] = r_sdot12_3;

  // ---- body 11 (body_11) and what it carries
  // r_omega11 = r11~ R11 G11 + d12~ R11 G12 + N11: Kane's equation of omega [N m]
  const T b11_1 = R11_21 * G11_1 + R11_22 * G11_2 + R11_23 * G11_3;
  const T b11_2 = R11_31 * G11_1 + R11_32 * G11_2 + R11_33 * G11_3;
  const T r_omega11_1 = d12_2 * r_sdot12_3 - d12_3 * r_sdot12_2 - T(0.337) * b11_1 - T(0.348) * b11_2 + N11_1;
  const T b11_3 = R11_11 * G11_1 + R11_12 * G11_2 + R11_13 * G11_3;
  const T r_omega11_2 = T(0.337) * b11_3 - T(0.402) * b11_2 + d12_3 * r_sdot12_1 - d12_1 * r_sdot12_3 + N11_2;
  const T r_omega11_3 = T(0.402) * b11_1 + T(0.348) * b11_3 + d12_1 * r_sdot12_2 - d12_2 * r_sdot12_1 + N11_3;
  r[30] = r_omega11_1;
  r[31] = r_omega11_2;
  r[32] = r_omega11_3;
  // S11 = G11 + G12: sum of the force balances of the subtree, inertial axes [N]
  const T S11_1 = G11_1 + G12_1;
  const T S11_2 = G11_2 + G12_2;
  const T S11_3 = G11_3 + G12_3;
  // r_sdot11 = R5 S11: Kane's equation of sdot [N]
  const T r_sdot11_1 = R5_11 * S11_1 + R5_12 * S11_2 + R5_13 * S11_3;
  const T r_sdot11_2 = R5_21 * S11_1 + R5_22 * S11_2 + R5_23 * S11_3;
  const T r_sdot11_3 = R5_31 * S11_1 + R5_32 * S11_2 + R5_33 * S11_3;
  r[66] = r_sdot11_1;
  r[67] = r_sdot11_2;
  r[68] = r_sdot11_3;

  // ---- body 10 (body_10) and what it carries
  // r_omega10 = r10~ R10 G10 + N10: Kane's equation of omega [N m]
  const T b10_1 = R10_21 * G10_1 + R10_22 * G10_2 + R10_23 * G10_3;
  const T b10_2 = R10_31 * G10_1 + R10_32 * G10_2 + R10_33 * G10_3;
  const T r_omega10_1 = T(0.426) * b10_1 + T(0.148) * b10_2 + N10_1;
  const T b10_3 = R10_11 * G10_1 + R10_12 * G10_2 + R10_13 * G10_3;
  const T r_omega10_2 = N10_2 - T(0.426) * b10_3 - T(0.016) * b10_2;
  const T r_omega10_3 = T(0.016) * b10_1 - T(0.148) * b10_3 + N10_3;
  r[27] = r_omega10_1;
  r[28] = r_omega10_2;
  r[29] = r_omega10_3;
  // r_sdot10 = R8 G10: Kane's equation of sdot [N]
  const T r_sdot10_1 = R8_11 * G10_1 + R8_12 * G10_2 + R8_13 * G10_3;
  const T r_sdot10_2 = R8_21 * G10_1 + R8_22 * G10_2 + R8_23 * G10_3;
  const T r_sdot10_3 = R8_31 * G10_1 + R8_32 * G10_2 + R8_33 * G10_3;
  r[63] = r_sdot10_1;
  r[64] = r_sdot10_2;
  r[65] = r_sdot10_3;

  // ---- body 9 (body_9) and what it carries
  // r_omega9 = r9~ R9 G9 + N9: Kane's equation of omega [N m]
  const T b9_1 = R9_21 * G9_1 + R9_22 * G9_2 + R9_23 * G9_3;
  const T b9_2 = R9_31 * G9_1 + R9_32 * G9_2 + R9_33 * G9_3;
  const T r_omega9_1 = T(0.015) * b9_1 + T(0.49) * b9_2 + N9_1;
  const T b9_3 = R9_11 * G9_1 + R9_12 * G9_2 + R9_13 * G9_3;
  const T r_omega9_2 = N9_2 - T(0.015) * b9_3 - T(0.362) * b9_2;
  const T r_omega9_3 = T(0.362) * b9_1 - T(0.49) * b9_3 + N9_3;
  r[24] = r_omega9_1;
  r[25] = r_omega9_2;
  r[26] = r_omega9_3;
  // r_sdot9 = R6 G9: Kane's equation of sdot [N]
  const T r_sdot9_1 = R6_11 * G9_1 + R6_12 * G9_2 + R6_13 * G9_3;
  const T r_sdot9_2 = R6_21 * G9_1 + R6_22 * G9_2 + R6_23 * G9_3;
  const T r_sdot9_3 = R6_31 * G9_1 + R6_32 * G9_2 + R6_33 * G9_3;
  r[60] = r_sdot9_1;
  r[61] = r_sdot9_2;
  r[62] = r_sdot9_3;

  // ---- body 8 (body_8) and what it carries
  // r_omega8 = r8~ R8 G8 + d10~ R8 G10 + N8: Kane's equation of omega [N m]
  const T b8_1 = R8_21 * G8_1 + R8_22 * G8_2 + R8_23 * G8_3;
  const T b8_2 = R8_31 * G8_1 + R8_32 * G8_2 + R8_33 * G8_3;
  const T r_omega8_1 = T(0.444) * b8_1 - T(0.416) * b8_2 + d10_2 * r_sdot10_3 - d10_3 * r_sdot10_2 + N8_1;
  const T b8_3 = R8_11 * G8_1 + R8_12 * G8_2 + R8_13 * G8_3;
  const T r_omega8_2 = T(0.392) * b8_2 - T(0.444) * b8_3 + d10_3 * r_sdot10_1 - d10_1 * r_sdot10_3 + N8_2;
  const T r_omega8_3 = T(0.416) * b8_3 - T(0.392) * b8_1 + d10_1 * r_sdot10_2 - d10_2 * r_sdot10_1 + N8_3;
  r[21] = r_omega8_1;
  r[22] = r_omega8_2;
  r[23] = r_omega8_3;
  // S8 = G8 + G10: sum of the force balances of the subtree, inertial axes [N]
  const T S8_1 = G8_1 + G10_1;
  const T S8_2 = G8_2 + G10_2;
  const T S8_3 = G8_3 + G10_3;
  // r_sdot8 = R1 S8: Kane's equation of sdot [N]
  const T r_sdot8_1 = R1_11 * S8_1 + R1_12 * S8_2 + R1_13 * S8_3;
  const T r_sdot8_2 = R1_21 * S8_1 + R1_22 * S8_2 + R1_23 * S8_3;
  const T r_sdot8_3 = R1_31 * S8_1 + R1_32 * S8_2 + R1_33 * S8_3;
  r[57] = r_sdot8_1;
  r[58] = r_sdot8_2;
  r[59] = r_sdot8_3;

  // ---- body 7 (body_7) and what it carries
  // r_omega7 = r7~ R7 G7 + N7: Kane's equation of omega [N m]
  const T b7_1 = R7_21 * G7_1 + R7_22 * G7_2 + R7_23 * G7_3;
  const T b7_2 = R7_31 * G7_1 + R7_32 * G7_2 + R7_33 * G7_3;
  const T r_omega7_1 = T(0.487) * b7_1 - T(0.192) * b7_2 + N7_1;
  const T b7_3 = R7_11 * G7_1 + R7_12 * G7_2 + R7_13 * G7_3;
  const T r_omega7_2 = T(0.475) * b7_2 - T(0.487) * b7_3 + N7_2;
  const T r_omega7_3 = T(0.192) * b7_3 - T(0.475) * b7_1 + N7_3;
  r[18] = r_omega7_1;
  r[19] = r_omega7_2;
  r[20] = r_omega7_3;
  // r_sdot7 = R4 G7: Kane's equation of sdot [N]
  const T r_sdot7_1 = R4_11 * G7_1 + R4_12 * G7_2 + R4_13 * G7_3;
  const T r_sdot7_2 = R4_21 * G7_1 + R4_22 * G7_2 + R4_23 * G7_3;
  const T r_sdot7_3 = R4_31 * G7_1 + R4_32 * G7_2 + R4_33 * G7_3;
  r[54] = r_sdot7_1;
  r[55] = r_sdot7_2;
  r[56] = r_sdot7_3;

  // ---- body 6 (body_6) and what it carries
  // r_omega6 = r6~ R6 G6 + d9~ R6 G9 + N6: Kane's equation of omega [N m]
  const T b6_1 = R6_21 * G6_1 + R6_22 * G6_2 + R6_23 * G6_3;
  const T b6_2 = R6_31 * G6_1 + R6_32 * G6_2 + R6_33 * G6_3;
  const T r_omega6_1 = T(0.454) * b6_1 - T(0.248) * b6_2 + d9_2 * r_sdot9_3 - d9_3 * r_sdot9_2 + N6_1;
  const T b6_3 = R6_11 * G6_1 + R6_12 * G6_2 + R6_13 * G6_3;
  const T r_omega6_2 = d9_3 * r_sdot9_1 - d9_1 * r_sdot9_3 - T(0.454) * b6_3 - T(0.044) * b6_2 + N6_2;
  const T r_omega6_3 = T(0.044) * b6_1 + T(0.248) * b6_3 + d9_1 * r_sdot9_2 - d9_2 * r_sdot9_1 + N6_3;
  r[15] = r_omega6_1;
  r[16] = r_omega6_2;
  r[17] = r_omega6_3;
  // S6 = G6 + G9: sum of the force balances of the subtree, inertial axes [N]
  const T S6_1 = G6_1 + G9_1;
  const T S6_2 = G6_2 + G9_2;
  const T S6_3 = G6_3 + G9_3;
  // r_sdot6 = R2 S6: Kane's equation of sdot [N]
  const T r_sdot6_1 = R2_11 * S6_1 + R2_12 * S6_2 + R2_13 * S6_3;
  const T r_sdot6_2 = R2_21 * S6_1 + R2_22 * S6_2 + R2_23 * S6_3;
  const T r_sdot6_3 = R2_31 * S6_1 + R2_32 * S6_2 + R2_33 * S6_3;
  r[51] = r_sdot6_1;
  r[52] = r_sdot6_2;
  r[53] = r_sdot6_3;

  // ---- body 5 (body_5) and what it carries
  // r_omega5 = r5~ R5 G5 + d11~ R5 S11 + N5: Kane's equation of omega [N m]
  const T b5_1 = R5_21 * G5_1 + R5_22 * G5_2 + R5_23 * G5_3;
  const T b5_2 = R5_31 * G5_1 + R5_32 * G5_2 + R5_33 * G5_3;
  const T r_omega5_1 = d11_2 * r_sdot11_3 - d11_3 * r_sdot11_2 - T(0.167) * b5_1 - T(0.321) * b5_2 + N5_1;
  const T b5_3 = R5_11 * G5_1 + R5_12 * G5_2 + R5_13 * G5_3;
  const T r_omega5_2 = T(0.167) * b5_3 + T(0.056) * b5_2 + d11_3 * r_sdot11_1 - d11_1 * r_sdot11_3 + N5_2;
  const T r_omega5_3 = T(0.321) * b5_3 - T(0.056) * b5_1 + d11_1 * r_sdot11_2 - d11_2 * r_sdot11_1 + N5_3;
  r[12] = r_omega5_1;
  r[13] = r_omega5_2;
  r[14] = r_omega5_3;
  // S5 = G5 + S11: sum of the force balances of the subtree, inertial axes [N]
  const T S5_1 = G5_1 + S11_1;
  const T S5_2 = G5_2 + S11_2;
  const T S5_3 = G5_3 + S11_3;
  // r_sdot5 = R3 S5: Kane's equation of sdot [N]
  const T r_sdot5_1 = R3_11 * S5_1 + R3_12 * S5_2 + R3_13 * S5_3;
  const T r_sdot5_2 = R3_21 * S5_1 + R3_22 * S5_2 + R3_23 * S5_3;
  const T r_sdot5_3 = R3_31 * S5_1 + R3_32 * S5_2 + R3_33 * S5_3;
  r[48] = r_sdot5_1;
  r[49] = r_sdot5_2;
  r[50] = r_sdot5_3;

  // ---- body 4 (body_4) and what it carries
  // r_omega4 = r4~ R4 G4 + d7~ R4 G7 + N4: Kane's equation of omega [N m]
  const T b4_1 = R4_31 * G4_1 + R4_32 * G4_2 + R4_33 * G4_3;
  const T b4_2 = R4_21 * G4_1 + R4_22 * G4_2 + R4_23 * G4_3;
  const T r_omega4_1 = T(0.289) * b4_1 - T(0.08) * b4_2 + d7_2 * r_sdot7_3 - d7_3 * r_sdot7_2 + N4_1;
  const T b4_3 = R4_11 * G4_1 + R4_12 * G4_2 + R4_13 * G4_3;
  const T r_omega4_2 = T(0.08) * b4_3 - T(0.401) * b4_1 + d7_3 * r_sdot7_1 - d7_1 * r_sdot7_3 + N4_2;
  const T r_omega4_3 = T(0.401) * b4_2 - T(0.289) * b4_3 + d7_1 * r_sdot7_2 - d7_2 * r_sdot7_1 + N4_3;
  r[9] = r_omega4_1;
  r[10] = r_omega4_2;
  r[11] = r_omega4_3;
  // S4 = G4 + G7: sum of the force balances of the subtree, inertial axes [N]
  const T S4_1 = G4_1 + G7_1;
  const T S4_2 = G4_2 + G7_2;
  const T S4_3 = G4_3 + G7_3;
  // r_sdot4 = R3 S4: Kane's equation of sdot [N]
  const T r_sdot4_1 = R3_11 * S4_1 + R3_12 * S4_2 + R3_13 * S4_3;
  const T r_sdot4_2 = R3_21 * S4_1 + R3_22 * S4_2 + R3_23 * S4_3;
  const T r_sdot4_3 = R3_31 * S4_1 + R3_32 * S4_2 + R3_33 * S4_3;
  r[45] = r_sdot4_1;
  r[46] = r_sdot4_2;
  r[47] = r_sdot4_3;

  // ---- body 3 (body_3) and what it carries
  // r_omega3 = r3~ R3 G3 + d4~ R3 S4 + d5~ R3 S5 + N3: Kane's equation of omega [N m]
  const T b3_1 = R3_31 * G3_1 + R3_32 * G3_2 + R3_33 * G3_3;
  const T b3_2 = R3_21 * G3_1 + R3_22 * G3_2 + R3_23 * G3_3;
  const T r_omega3_1 = T(0.498) * b3_1 - T(0.004) * b3_2 + d4_2 * r_sdot4_3 - d4_3 * r_sdot4_2 + d5_2 * r_sdot5_3 -
      d5_3 * r_sdot5_2 + N3_1;
  const T b3_3 = R3_11 * G3_1 + R3_12 * G3_2 + R3_13 * G3_3;
  const T r_omega3_2 = T(0.004) * b3_3 - T(0.484) * b3_1 + d4_3 * r_sdot4_1 - d4_1 * r_sdot4_3 + d5_3 * r_sdot5_1 -
      d5_1 * r_sdot5_3 + N3_2;
  const T r_omega3_3 = T(0.484) * b3_2 - T(0.498) * b3_3 + d4_1 * r_sdot4_2 - d4_2 * r_sdot4_1 + d5_1 * r_sdot5_2 -
      d5_2 * r_sdot5_1 + N3_3;
  r[6] = r_omega3_1;
  r[7] = r_omega3_2;
  r[8] = r_omega3_3;
  // S3 = G3 + S5 + S4: sum of the force balances of the subtree, inertial axes [N]
  const T S3_1 = G3_1 + S5_1 + S4_1;
  const T S3_2 = G3_2 + S5_2 + S4_2;
  const T S3_3 = G3_3 + S5_3 + S4_3;
  // r_sdot3 = R2 S3: Kane's equation of sdot [N]
  const T r_sdot3_1 = R2_11 * S3_1 + R2_12 * S3_2 + R2_13 * S3_3;
  const T r_sdot3_2 = R2_21 * S3_1 + R2_22 * S3_2 + R2_23 * S3_3;
  const T r_sdot3_3 = R2_31 * S3_1 + R2_32 * S3_2 + R2_33 * S3_3;
  r[42] = r_sdot3_1;
  r[43] = r_sdot3_2;
  r[44] = r_sdot3_3;

  // ---- body 2 (body_2) and what it carries
  // r_omega2 = r2~ R2 G2 + d3~ R2 S3 + d6~ R2 S6 + N2: Kane's equation of omega [N m]
  const T b2_1 = R2_31 * G2_1 + R2_32 * G2_2 + R2_33 * G2_3;
  const T r_omega2_1 = T(0.31) * b2_1 + d3_2 * r_sdot3_3 - d3_3 * r_sdot3_2 + d6_2 * r_sdot6_3 - d6_3 * r_sdot6_2 +
      N2_1;
  const T r_omega2_2 = d3_3 * r_sdot3_1 - d3_1 * r_sdot3_3 - T(0.011) * b2_1 + d6_3 * r_sdot6_1 - d6_1 * r_sdot6_3 +
      N2_2;
  const T r_omega2_3 = T(0.011) * (R2_21 * G2_1 + R2_22 * G2_2 + R2_23 * G2_3) - T(0.31) * (R2_11 * G2_1 + R2_12 *
      G2_2 + R2_13 * G2_3) + d3_1 * r_sdot3_2 - d3_2 * r_sdot3_1 + d6_1 * r_sdot6_2 - d6_2 * r_sdot6_1 + N2_3;
  r[3] = r_omega2_1;
  r[4] = r_omega2_2;
  r[5] = r_omega2_3;
  // S2 = G2 + S6 + S3: sum of the force balances of the subtree, inertial axes [N]
  const T S2_1 = G2_1 + S6_1 + S3_1;
  const T S2_2 = G2_2 + S6_2 + S3_2;
  const T S2_3 = G2_3 + S6_3 + S3_3;
  // r_sdot2 = R1 S2: Kane's equation of sdot [N]
  const T r_sdot2_1 = R1_11 * S2_1 + R1_12 * S2_2 + R1_13 * S2_3;
  const T r_sdot2_2 = R1_21 * S2_1 + R1_22 * S2_2 + R1_23 * S2_3;
  const T r_sdot2_3 = R1_31 * S2_1 + R1_32 * S2_2 + R1_33 * S2_3;
  r[39] = r_sdot2_1;
  r[40] = r_sdot2_2;
  r[41] = r_sdot2_3;

  // ---- body 1 (body_1) and what it carries
  // r_omega1 = r1~ R1 G1 + d2~ R1 S2 + d8~ R1 S8 + N1: Kane's equation of omega [N m]
  const T b1_1 = R1_21 * G1_1 + R1_22 * G1_2 + R1_23 * G1_3;
  const T b1_2 = R1_31 * G1_1 + R1_32 * G1_2 + R1_33 * G1_3;
  const T r_omega1_1 = T(0.095) * b1_1 - T(0.163) * b1_2 + d2_2 * r_sdot2_3 - d2_3 * r_sdot2_2 + d8_2 * r_sdot8_3 -
      d8_3 * r_sdot8_2 + N1_1;
  const T b1_3 = R1_11 * G1_1 + R1_12 * G1_2 + R1_13 * G1_3;
  const T r_omega1_2 = d2_3 * r_sdot2_1 - d2_1 * r_sdot2_3 - T(0.095) * b1_3 - T(0.187) * b1_2 + d8_3 * r_sdot8_1 -
      d8_1 * r_sdot8_3 + N1_2;
  const T r_omega1_3 = T(0.187) * b1_1 + T(0.163) * b1_3 + d2_1 * r_sdot2_2 - d2_2 * r_sdot2_1 + d8_1 * r_sdot8_2 -
      d8_2 * r_sdot8_1 + N1_3;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
  // S1 = G1 + S8 + S2: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = G1_1 + S8_1 + S2_1;
  const T S1_2 = G1_2 + S8_2 + S2_2;
  const T S1_3 = G1_3 + S8_3 + S2_3;
  r[36] = S1_1;
  r[37] = S1_2;
  r[38] = S1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 1058 add, 1253 multiply
template <class T>
void forcing([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, [[maybe_unused]] const Inputs<T>& u, T* f)
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
  // a1 = R1^T omega1~ omega1~ r1 + Pddot1: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t1_13 = omega1_3 * T(0.163) - omega1_2 * T(0.095);
  const T t1_14 = omega1_1 * T(0.163) + omega1_2 * T(0.187);
  const T t1_15 = omega1_3 * t1_13 + omega1_1 * t1_14;
  const T t1_16 = omega1_3 * T(0.187) + omega1_1 * T(0.095);
  const T t1_17 = omega1_3 * t1_16 + omega1_2 * t1_14;
  const T t1_18 = omega1_1 * t1_16 - omega1_2 * t1_13;
  const T a1_1 = R1_21 * t1_15 - R1_11 * t1_17 + R1_31 * t1_18;
  const T a1_2 = R1_22 * t1_15 - R1_12 * t1_17 + R1_32 * t1_18;
  const T a1_3 = R1_23 * t1_15 - R1_13 * t1_17 + R1_33 * t1_18 + T(9.81);
  // G1 = -m1 a1 + F1: applied less inertia force at ydot = 0, inertial axes [N]
  const T G1_1 = T(1.37) - T(4.15) * a1_1;
  const T minus_G1_2 = T(4.15) * a1_2 + T(1.93);
  const T minus_G1_3 = T(4.15) * a1_3 + T(1.76);
  // N1 = -omega1~ I1 omega1 + M1: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t1_19 = omega1_2 * omega1_3;
  const T t1_20 = omega1_2 * omega1_2;
  const T t1_21 = omega1_3 * omega1_3;
  const T t1_22 = omega1_1 * omega1_2;
  const T t1_23 = omega1_1 * omega1_3;
  const T N1_1 = T(0.083) - T(0.058099999999999985) * t1_19 + T(0.0128) * (t1_20 - t1_21) - T(0.0129) * t1_22 +
      T(0.0043) * t1_23;
  const T t1_24 = omega1_1 * omega1_1;
  const T N1_2 = T(0.002) - T(0.0010999999999999899) * t1_23 - T(0.0129) * (t1_21 - t1_24) - T(0.0043) * t1_19 -
      T(0.0128) * t1_22;
  const T minus_N1_3 = T(0.082) + T(0.0043) * (t1_24 - t1_20) - T(0.059199999999999975) * t1_22 - T(0.0128) * t1_23 -
      T(0.0129) * t1_19;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[39], sdot2_2 = y[40], sdot2_3 = y[41];
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
  // d2 = q2 + s2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = s2_1 - T(0.472);
  const T d2_2 = T(0.323) + s2_2;
  const T d2_3 = s2_3 - T(0.07);
  // Pddot2 = R1^T omega1~ (omega1~ d2 + 2 sdot2) + Pddot1: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t2_13 = omega1_1 * d2_2 - omega1_2 * d2_1 + T(2) * sdot2_3;
  const T t2_14 = omega1_3 * d2_1 - omega1_1 * d2_3 + T(2) * sdot2_2;
  const T t2_15 = omega1_2 * t2_13 - omega1_3 * t2_14;
  const T t2_16 = omega1_2 * d2_3 - omega1_3 * d2_2 + T(2) * sdot2_1;
  const T t2_17 = omega1_3 * t2_16 - omega1_1 * t2_13;
  const T t2_18 = omega1_1 * t2_14 - omega1_2 * t2_16;
  const T Pddot2_1 = R1_11 * t2_15 + R1_21 * t2_17 + R1_31 * t2_18;
  const T Pddot2_2 = R1_12 * t2_15 + R1_22 * t2_17 + R1_32 * t2_18;
  const T Pddot2_3 = R1_13 * t2_15 + R1_23 * t2_17 + R1_33 * t2_18 + T(9.81);
  // a2 = R2^T omega2~ omega2~ r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_19 = omega2_1 * T(0.31) - omega2_2 * T(0.011);
  const T t2_20 = omega2_3 * T(0.011);
  const T t2_21 = omega2_2 * t2_19 - omega2_3 * t2_20;
  const T t2_22 = omega2_3 * T(0.31);
  const T t2_23 = omega2_3 * t2_22 + omega2_1 * t2_19;
  const T t2_24 = omega2_1 * t2_20 + omega2_2 * t2_22;
  const T a2_1 = R2_11 * t2_21 - R2_21 * t2_23 + R2_31 * t2_24 + Pddot2_1;
  const T a2_2 = R2_12 * t2_21 - R2_22 * t2_23 + R2_32 * t2_24 + Pddot2_2;
  const T a2_3 = R2_13 * t2_21 - R2_23 * t2_23 + R2_33 * t2_24 + Pddot2_3;
  // G2 = -m2 a2 + F2: applied less inertia force at ydot = 0, inertial axes [N]
  const T G2_1 = T(0.08) - T(0.64) * a2_1;
  const T minus_G2_2 = T(0.64) * a2_2 + T(1.11);
  const T minus_G2_3 = T(0.64) * a2_3 + T(0.29);
  // N2 = -omega2~ I2 omega2 + M2: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t2_25 = omega2_2 * omega2_3;
  const T t2_26 = omega2_2 * omega2_2;
  const T t2_27 = omega2_3 * omega2_3;
  const T t2_28 = omega2_1 * omega2_2;
  const T t2_29 = omega2_1 * omega2_3;
  const T minus_N2_1 = T(0.022) + T(0.0252) * t2_25 + T(0.0049) * (t2_26 - t2_27) + T(0.0037) * t2_28 - T(1e-04) *
      t2_29;
  const T t2_30 = omega2_1 * omega2_1;
  const T N2_2 = T(0.054) - T(0.0037) * (t2_27 - t2_30) + T(0.02560000000000001) * t2_29 - T(1e-04) * t2_25 +
      T(0.0049) * t2_28;
  const T minus_N2_3 = T(0.079) + T(0.00040000000000001146) * t2_28 + T(1e-04) * (t2_30 - t2_26) + T(0.0049) * t2_29 -
      T(0.0037) * t2_25;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[42], sdot3_2 = y[43], sdot3_3 = y[44];
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
  // d3 = q3 + s3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = s3_1 - T(0.476);
  const T d3_2 = s3_2 - T(0.178);
  const T d3_3 = T(0.287) + s3_3;
  // Pddot3 = R2^T omega2~ (omega2~ d3 + 2 sdot3) + Pddot2: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t3_13 = omega2_1 * d3_2 - omega2_2 * d3_1 + T(2) * sdot3_3;
  const T t3_14 = omega2_3 * d3_1 - omega2_1 * d3_3 + T(2) * sdot3_2;
  const T t3_15 = omega2_2 * t3_13 - omega2_3 * t3_14;
  const T t3_16 = omega2_2 * d3_3 - omega2_3 * d3_2 + T(2) * sdot3_1;
  const T t3_17 = omega2_3 * t3_16 - omega2_1 * t3_13;
  const T t3_18 = omega2_1 * t3_14 - omega2_2 * t3_16;
  const T Pddot3_1 = R2_11 * t3_15 + R2_21 * t3_17 + R2_31 * t3_18 + Pddot2_1;
  const T Pddot3_2 = R2_12 * t3_15 + R2_22 * t3_17 + R2_32 * t3_18 + Pddot2_2;
  const T Pddot3_3 = R2_13 * t3_15 + R2_23 * t3_17 + R2_33 * t3_18 + Pddot2_3;
  // a3 = R3^T omega3~ omega3~ r3 + Pddot3: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t3_19 = omega3_1 * T(0.498) - omega3_2 * T(0.484);
  const T t3_20 = omega3_3 * T(0.484) - omega3_1 * T(0.004);
  const T t3_21 = omega3_2 * t3_19 - omega3_3 * t3_20;
  const T t3_22 = omega3_2 * T(0.004) - omega3_3 * T(0.498);
  const T t3_23 = omega3_3 * t3_22 - omega3_1 * t3_19;
  const T t3_24 = omega3_1 * t3_20 - omega3_2 * t3_22;
  const T a3_1 = R3_11 * t3_21 + R3_21 * t3_23 + R3_31 * t3_24 + Pddot3_1;
  const T a3_2 = R3_12 * t3_21 + R3_22 * t3_23 + R3_32 * t3_24 + Pddot3_2;
  const T a3_3 = R3_13 * t3_21 + R3_23 * t3_23 + R3_33 * t3_24 + Pddot3_3;
  // G3 = -m3 a3 + F3: applied less inertia force at ydot = 0, inertial axes [N]
  const T G3_1 = T(1.33) - T(2.14) * a3_1;
  const T G3_2 = T(0.56) - T(2.14) * a3_2;
  const T minus_G3_3 = T(2.14) * a3_3 + T(1.08);
  // N3 = -omega3~ I3 omega3 + M3: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t3_25 = omega3_2 * omega3_3;
  const T t3_26 = omega3_2 * omega3_2;
  const T t3_27 = omega3_3 * omega3_3;
  const T t3_28 = omega3_1 * omega3_2;
  const T t3_29 = omega3_1 * omega3_3;
  const T N3_1 = T(0.005) - T(0.05720000000000003) * t3_25 + T(0.0036) * (t3_26 - t3_27) - T(0.038) * t3_28 +
      T(0.0388) * t3_29;
  const T t3_30 = omega3_1 * omega3_1;
  const T minus_N3_2 = T(0.005) + T(0.10579999999999995) * t3_29 + T(0.038) * (t3_27 - t3_30) + T(0.0388) * t3_25 +
      T(0.0036) * t3_28;
  const T N3_3 = T(0.025) - T(0.0388) * (t3_30 - t3_26) + T(0.16299999999999998) * t3_28 + T(0.0036) * t3_29 +
      T(0.038) * t3_25;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[45], sdot4_2 = y[46], sdot4_3 = y[47];
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
  // d4 = q4 + s4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = s4_1 - T(0.153);
  const T d4_2 = s4_2 - T(0.132);
  const T d4_3 = T(0.236) + s4_3;
  // Pddot4 = R3^T omega3~ (omega3~ d4 + 2 sdot4) + Pddot3: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t4_13 = omega3_1 * d4_2 - omega3_2 * d4_1 + T(2) * sdot4_3;
  const T t4_14 = omega3_3 * d4_1 - omega3_1 * d4_3 + T(2) * sdot4_2;
  const T t4_15 = omega3_2 * t4_13 - omega3_3 * t4_14;
  const T t4_16 = omega3_2 * d4_3 - omega3_3 * d4_2 + T(2) * sdot4_1;
  const T t4_17 = omega3_3 * t4_16 - omega3_1 * t4_13;
  const T t4_18 = omega3_1 * t4_14 - omega3_2 * t4_16;
  const T Pddot4_1 = R3_11 * t4_15 + R3_21 * t4_17 + R3_31 * t4_18 + Pddot3_1;
  const T Pddot4_2 = R3_12 * t4_15 + R3_22 * t4_17 + R3_32 * t4_18 + Pddot3_2;
  const T Pddot4_3 = R3_13 * t4_15 + R3_23 * t4_17 + R3_33 * t4_18 + Pddot3_3;
  // a4 = R4^T omega4~ omega4~ r4 + Pddot4: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t4_19 = omega4_1 * T(0.289) - omega4_2 * T(0.401);
  const T t4_20 = omega4_3 * T(0.401) - omega4_1 * T(0.08);
  const T t4_21 = omega4_2 * t4_19 - omega4_3 * t4_20;
  const T t4_22 = omega4_2 * T(0.08) - omega4_3 * T(0.289);
  const T t4_23 = omega4_3 * t4_22 - omega4_1 * t4_19;
  const T t4_24 = omega4_1 * t4_20 - omega4_2 * t4_22;
  const T a4_1 = R4_11 * t4_21 + R4_21 * t4_23 + R4_31 * t4_24 + Pddot4_1;
  const T a4_2 = R4_12 * t4_21 + R4_22 * t4_23 + R4_32 * t4_24 + Pddot4_2;
  const T a4_3 = R4_13 * t4_21 + R4_23 * t4_23 + R4_33 * t4_24 + Pddot4_3;
  // G4 = -m4 a4 + F4: applied less inertia force at ydot = 0, inertial axes [N]
  const T G4_1 = T(0.25) - T(4.49) * a4_1;
  const T minus_G4_2 = T(4.49) * a4_2 + T(1.93);
  const T G4_3 = T(0.84) - T(4.49) * a4_3;
  // N4 = -omega4~ I4 omega4 + M4: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t4_25 = omega4_2 * omega4_3;
  const T t4_26 = omega4_2 * omega4_2;
  const T t4_27 = omega4_3 * omega4_3;
  const T t4_28 = omega4_1 * omega4_2;
  const T t4_29 = omega4_1 * omega4_3;
  const T N4_1 = T(0.081) - T(0.0010999999999999899) * t4_25 + T(0.0221) * (t4_26 - t4_27) + T(0.0283) * t4_28 +
      T(0.0225) * t4_29;
  const T t4_30 = omega4_1 * omega4_1;
  const T N4_2 = T(0.06) - T(0.014300000000000007) * t4_29 + T(0.0283) * (t4_27 - t4_30) - T(0.0225) * t4_25 -
      T(0.0221) * t4_28;
  const T N4_3 = T(0.079) - T(0.0225) * (t4_30 - t4_26) + T(0.015399999999999997) * t4_28 + T(0.0221) * t4_29 -
      T(0.0283) * t4_25;

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[48], sdot5_2 = y[49], sdot5_3 = y[50];
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
  // d5 = q5 + s5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = s5_1 - T(0.159);
  const T d5_2 = s5_2 - T(0.262);
  const T d5_3 = s5_3 - T(0.173);
  // Pddot5 = R3^T omega3~ (omega3~ d5 + 2 sdot5) + Pddot3: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t5_13 = omega3_1 * d5_2 - omega3_2 * d5_1 + T(2) * sdot5_3;
  const T t5_14 = omega3_3 * d5_1 - omega3_1 * d5_3 + T(2) * sdot5_2;
  const T t5_15 = omega3_2 * t5_13 - omega3_3 * t5_14;
  const T t5_16 = omega3_2 * d5_3 - omega3_3 * d5_2 + T(2) * sdot5_1;
  const T t5_17 = omega3_3 * t5_16 - omega3_1 * t5_13;
  const T t5_18 = omega3_1 * t5_14 - omega3_2 * t5_16;
  const T Pddot5_1 = R3_11 * t5_15 + R3_21 * t5_17 + R3_31 * t5_18 + Pddot3_1;
  const T Pddot5_2 = R3_12 * t5_15 + R3_22 * t5_17 + R3_32 * t5_18 + Pddot3_2;
  const T Pddot5_3 = R3_13 * t5_15 + R3_23 * t5_17 + R3_33 * t5_18 + Pddot3_3;
  // a5 = R5^T omega5~ omega5~ r5 + Pddot5: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t5_19 = omega5_3 * T(0.056) + omega5_1 * T(0.167);
  const T t5_20 = omega5_2 * T(0.056) - omega5_1 * T(0.321);
  const T t5_21 = omega5_3 * t5_19 + omega5_2 * t5_20;
  const T t5_22 = omega5_3 * T(0.321) + omega5_2 * T(0.167);
  const T t5_23 = omega5_3 * t5_22 - omega5_1 * t5_20;
  const T t5_24 = omega5_1 * t5_19 + omega5_2 * t5_22;
  const T a5_1 = R5_11 * t5_21 + R5_21 * t5_23 - R5_31 * t5_24 + Pddot5_1;
  const T a5_2 = R5_12 * t5_21 + R5_22 * t5_23 - R5_32 * t5_24 + Pddot5_2;
  const T a5_3 = R5_13 * t5_21 + R5_23 * t5_23 - R5_33 * t5_24 + Pddot5_3;
  // G5 = -m5 a5 + F5: applied less inertia force at ydot = 0, inertial axes [N]
  const T G5_1 = T(1.78) - T(1.96) * a5_1;
  const T minus_G5_2 = T(1.96) * a5_2 + T(1.97);
  const T minus_G5_3 = T(1.96) * a5_3 + T(0.56);
  // N5 = -omega5~ I5 omega5 + M5: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t5_25 = omega5_2 * omega5_3;
  const T t5_26 = omega5_2 * omega5_2;
  const T t5_27 = omega5_3 * omega5_3;
  const T t5_28 = omega5_1 * omega5_2;
  const T t5_29 = omega5_1 * omega5_3;
  const T minus_N5_1 = T(0.044) + T(0.011699999999999988) * t5_25 - T(0.0036) * (t5_26 - t5_27) + T(0.0143) * t5_28 -
      T(0.0396) * t5_29;
  const T t5_30 = omega5_1 * omega5_1;
  const T minus_N5_2 = T(0.06) + T(0.0143) * (t5_27 - t5_30) - T(0.08959999999999999) * t5_29 + T(0.0396) * t5_25 +
      T(0.0036) * t5_28;
  const T minus_N5_3 = T(0.014) + T(0.0779) * t5_28 + T(0.0396) * (t5_30 - t5_26) - T(0.0036) * t5_29 - T(0.0143) *
      t5_25;

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[51], sdot6_2 = y[52], sdot6_3 = y[53];
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
  // d6 = q6 + s6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.304) + s6_1;
  const T d6_2 = s6_2 - T(0.214);
  const T d6_3 = T(0.436) + s6_3;
  // Pddot6 = R2^T omega2~ (omega2~ d6 + 2 sdot6) + Pddot2: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t6_13 = omega2_1 * d6_2 - omega2_2 * d6_1 + T(2) * sdot6_3;
  const T t6_14 = omega2_3 * d6_1 - omega2_1 * d6_3 + T(2) * sdot6_2;
  const T t6_15 = omega2_2 * t6_13 - omega2_3 * t6_14;
  const T t6_16 = omega2_2 * d6_3 - omega2_3 * d6_2 + T(2) * sdot6_1;
  const T t6_17 = omega2_3 * t6_16 - omega2_1 * t6_13;
  const T t6_18 = omega2_1 * t6_14 - omega2_2 * t6_16;
  const T Pddot6_1 = R2_11 * t6_15 + R2_21 * t6_17 + R2_31 * t6_18 + Pddot2_1;
  const T Pddot6_2 = R2_12 * t6_15 + R2_22 * t6_17 + R2_32 * t6_18 + Pddot2_2;
  const T Pddot6_3 = R2_13 * t6_15 + R2_23 * t6_17 + R2_33 * t6_18 + Pddot2_3;
  // a6 = R6^T omega6~ omega6~ r6 + Pddot6: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t6_19 = omega6_3 * T(0.248) - omega6_2 * T(0.454);
  const T t6_20 = omega6_1 * T(0.248) + omega6_2 * T(0.044);
  const T t6_21 = omega6_3 * t6_19 + omega6_1 * t6_20;
  const T t6_22 = omega6_3 * T(0.044) + omega6_1 * T(0.454);
  const T t6_23 = omega6_3 * t6_22 + omega6_2 * t6_20;
  const T t6_24 = omega6_1 * t6_22 - omega6_2 * t6_19;
  const T a6_1 = R6_21 * t6_21 - R6_11 * t6_23 + R6_31 * t6_24 + Pddot6_1;
  const T a6_2 = R6_22 * t6_21 - R6_12 * t6_23 + R6_32 * t6_24 + Pddot6_2;
  const T a6_3 = R6_23 * t6_21 - R6_13 * t6_23 + R6_33 * t6_24 + Pddot6_3;
  // G6 = -m6 a6 + F6: applied less inertia force at ydot = 0, inertial axes [N]
  const T G6_1 = T(0.4) - T(3.48) * a6_1;
  const T minus_G6_2 = T(3.48) * a6_2 + T(0.44);
  const T G6_3 = T(1.49) - T(3.48) * a6_3;
  // N6 = -omega6~ I6 omega6 + M6: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t6_25 = omega6_2 * omega6_2;
  const T t6_26 = omega6_3 * omega6_3;
  const T t6_27 = omega6_2 * omega6_3;
  const T t6_28 = omega6_1 * omega6_2;
  const T t6_29 = omega6_1 * omega6_3;
  const T N6_1 = T(0.079) - T(0.0219) * (t6_25 - t6_26) + T(0.014700000000000046) * t6_27 - T(0.0493) * t6_28 +
      T(0.035) * t6_29;
  const T t6_30 = omega6_1 * omega6_1;
  const T minus_N6_2 = T(0.036) + T(0.0493) * (t6_26 - t6_30) - T(0.17060000000000003) * t6_29 + T(0.035) * t6_27 -
      T(0.0219) * t6_28;
  const T minus_N6_3 = T(0.075) + T(0.18530000000000008) * t6_28 + T(0.035) * (t6_30 - t6_25) + T(0.0219) * t6_29 -
      T(0.0493) * t6_27;

  // ---- body 7 (body_7) on body 4
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
  const T omega7_1 = y[18], omega7_2 = y[19], omega7_3 = y[20];
  const T sdot7_1 = y[54], sdot7_2 = y[55], sdot7_3 = y[56];
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
  // d7 = q7 + s7: joint offset q + s, axes of the lower body [m]
  const T d7_1 = s7_1 - T(0.329);
  const T d7_2 = s7_2 - T(0.337);
  const T d7_3 = T(0.216) + s7_3;
  // Pddot7 = R4^T omega4~ (omega4~ d7 + 2 sdot7) + Pddot4: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t7_13 = omega4_1 * d7_2 - omega4_2 * d7_1 + T(2) * sdot7_3;
  const T t7_14 = omega4_3 * d7_1 - omega4_1 * d7_3 + T(2) * sdot7_2;
  const T t7_15 = omega4_2 * t7_13 - omega4_3 * t7_14;
  const T t7_16 = omega4_2 * d7_3 - omega4_3 * d7_2 + T(2) * sdot7_1;
  const T t7_17 = omega4_3 * t7_16 - omega4_1 * t7_13;
  const T t7_18 = omega4_1 * t7_14 - omega4_2 * t7_16;
  const T Pddot7_1 = R4_11 * t7_15 + R4_21 * t7_17 + R4_31 * t7_18 + Pddot4_1;
  const T Pddot7_2 = R4_12 * t7_15 + R4_22 * t7_17 + R4_32 * t7_18 + Pddot4_2;
  const T Pddot7_3 = R4_13 * t7_15 + R4_23 * t7_17 + R4_33 * t7_18 + Pddot4_3;
  // a7 = R7^T omega7~ omega7~ r7 + Pddot7: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t7_19 = omega7_2 * T(0.475) - omega7_1 * T(0.192);
  const T t7_20 = omega7_1 * T(0.487) - omega7_3 * T(0.475);
  const T t7_21 = omega7_2 * t7_19 - omega7_3 * t7_20;
  const T t7_22 = omega7_3 * T(0.192) - omega7_2 * T(0.487);
  const T t7_23 = omega7_3 * t7_22 - omega7_1 * t7_19;
  const T t7_24 = omega7_1 * t7_20 - omega7_2 * t7_22;
  const T a7_1 = R7_11 * t7_21 + R7_21 * t7_23 + R7_31 * t7_24 + Pddot7_1;
  const T a7_2 = R7_12 * t7_21 + R7_22 * t7_23 + R7_32 * t7_24 + Pddot7_2;
  const T a7_3 = R7_13 * t7_21 + R7_23 * t7_23 + R7_33 * t7_24 + Pddot7_3;
  // G7 = -m7 a7 + F7: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G7_1 = T(0.74) * a7_1 + T(0.81);
  const T minus_G7_2 = T(0.74) * a7_2 + T(1.24);
  const T minus_G7_3 = T(0.74) * a7_3 + T(1.26);
  // N7 = -omega7~ I7 omega7 + M7: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t7_25 = omega7_2 * omega7_2;
  const T t7_26 = omega7_3 * omega7_3;
  const T t7_27 = omega7_2 * omega7_3;
  const T t7_28 = omega7_1 * omega7_2;
  const T t7_29 = omega7_1 * omega7_3;
  const T minus_N7_1 = T(0.038) + T(0.0017) * (t7_25 - t7_26) - T(0.0021000000000000185) * t7_27 + T(0.0025) * t7_28 +
      T(7e-04) * t7_29;
  const T t7_30 = omega7_1 * omega7_1;
  const T N7_2 = T(0.072) - T(0.0025) * (t7_26 - t7_30) + T(0.0008999999999999841) * t7_29 + T(7e-04) * t7_27 +
      T(0.0017) * t7_28;
  const T N7_3 = T(0.021) - T(0.0030000000000000027) * t7_28 + T(7e-04) * (t7_30 - t7_25) - T(0.0017) * t7_29 +
      T(0.0025) * t7_27;

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  const T sdot8_1 = y[57], sdot8_2 = y[58], sdot8_3 = y[59];
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
  // d8 = q8 + s8: joint offset q + s, axes of the lower body [m]
  const T d8_1 = s8_1 - T(0.492);
  const T d8_2 = s8_2 - T(0.25);
  const T d8_3 = s8_3 - T(0.387);
  // Pddot8 = R1^T omega1~ (omega1~ d8 + 2 sdot8) + Pddot1: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t8_13 = omega1_1 * d8_2 - omega1_2 * d8_1 + T(2) * sdot8_3;
  const T t8_14 = omega1_3 * d8_1 - omega1_1 * d8_3 + T(2) * sdot8_2;
  const T t8_15 = omega1_2 * t8_13 - omega1_3 * t8_14;
  const T t8_16 = omega1_2 * d8_3 - omega1_3 * d8_2 + T(2) * sdot8_1;
  const T t8_17 = omega1_3 * t8_16 - omega1_1 * t8_13;
  const T t8_18 = omega1_1 * t8_14 - omega1_2 * t8_16;
  const T Pddot8_1 = R1_11 * t8_15 + R1_21 * t8_17 + R1_31 * t8_18;
  const T Pddot8_2 = R1_12 * t8_15 + R1_22 * t8_17 + R1_32 * t8_18;
  const T Pddot8_3 = R1_13 * t8_15 + R1_23 * t8_17 + R1_33 * t8_18 + T(9.81);
  // a8 = R8^T omega8~ omega8~ r8 + Pddot8: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t8_19 = omega8_2 * T(0.392) - omega8_1 * T(0.416);
  const T t8_20 = omega8_1 * T(0.444) - omega8_3 * T(0.392);
  const T t8_21 = omega8_2 * t8_19 - omega8_3 * t8_20;
  const T t8_22 = omega8_3 * T(0.416) - omega8_2 * T(0.444);
  const T t8_23 = omega8_3 * t8_22 - omega8_1 * t8_19;
  const T t8_24 = omega8_1 * t8_20 - omega8_2 * t8_22;
  const T a8_1 = R8_11 * t8_21 + R8_21 * t8_23 + R8_31 * t8_24 + Pddot8_1;
  const T a8_2 = R8_12 * t8_21 + R8_22 * t8_23 + R8_32 * t8_24 + Pddot8_2;
  const T a8_3 = R8_13 * t8_21 + R8_23 * t8_23 + R8_33 * t8_24 + Pddot8_3;
  // G8 = -m8 a8 + F8: applied less inertia force at ydot = 0, inertial axes [N]
  const T G8_1 = T(0.74) - T(2.71) * a8_1;
  const T G8_2 = T(0.46) - T(2.71) * a8_2;
  const T G8_3 = T(1.86) - T(2.71) * a8_3;
  // N8 = -omega8~ I8 omega8 + M8: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t8_25 = omega8_2 * omega8_3;
  const T t8_26 = omega8_2 * omega8_2;
  const T t8_27 = omega8_3 * omega8_3;
  const T t8_28 = omega8_1 * omega8_2;
  const T t8_29 = omega8_1 * omega8_3;
  const T N8_1 = T(0.092) - T(0.017199999999999938) * t8_25 - T(0.028) * (t8_26 - t8_27) + T(0.0399) * t8_28 -
      T(0.0147) * t8_29;
  const T t8_30 = omega8_1 * omega8_1;
  const T N8_2 = T(0.049) + T(0.06739999999999996) * t8_29 + T(0.0399) * (t8_27 - t8_30) + T(0.0147) * t8_25 +
      T(0.028) * t8_28;
  const T N8_3 = T(0.09) - T(0.05020000000000002) * t8_28 + T(0.0147) * (t8_30 - t8_26) - T(0.028) * t8_29 - T(0.0399)
      * t8_25;

  // ---- body 9 (body_9) on body 6
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
  const T omega9_1 = y[24], omega9_2 = y[25], omega9_3 = y[26];
  const T sdot9_1 = y[60], sdot9_2 = y[61], sdot9_3 = y[62];
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
  // d9 = q9 + s9: joint offset q + s, axes of the lower body [m]
  const T d9_1 = s9_1 - T(0.305);
  const T d9_2 = T(0.124) + s9_2;
  const T d9_3 = T(0.036) + s9_3;
  // Pddot9 = R6^T omega6~ (omega6~ d9 + 2 sdot9) + Pddot6: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t9_13 = omega6_1 * d9_2 - omega6_2 * d9_1 + T(2) * sdot9_3;
  const T t9_14 = omega6_3 * d9_1 - omega6_1 * d9_3 + T(2) * sdot9_2;
  const T t9_15 = omega6_2 * t9_13 - omega6_3 * t9_14;
  const T t9_16 = omega6_2 * d9_3 - omega6_3 * d9_2 + T(2) * sdot9_1;
  const T t9_17 = omega6_3 * t9_16 - omega6_1 * t9_13;
  const T t9_18 = omega6_1 * t9_14 - omega6_2 * t9_16;
  const T Pddot9_1 = R6_11 * t9_15 + R6_21 * t9_17 + R6_31 * t9_18 + Pddot6_1;
  const T Pddot9_2 = R6_12 * t9_15 + R6_22 * t9_17 + R6_32 * t9_18 + Pddot6_2;
  const T Pddot9_3 = R6_13 * t9_15 + R6_23 * t9_17 + R6_33 * t9_18 + Pddot6_3;
  // a9 = R9^T omega9~ omega9~ r9 + Pddot9: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t9_19 = omega9_1 * T(0.49) - omega9_2 * T(0.362);
  const T t9_20 = omega9_3 * T(0.362) + omega9_1 * T(0.015);
  const T t9_21 = omega9_2 * t9_19 - omega9_3 * t9_20;
  const T t9_22 = omega9_3 * T(0.49) + omega9_2 * T(0.015);
  const T t9_23 = omega9_3 * t9_22 + omega9_1 * t9_19;
  const T t9_24 = omega9_1 * t9_20 + omega9_2 * t9_22;
  const T a9_1 = R9_11 * t9_21 - R9_21 * t9_23 + R9_31 * t9_24 + Pddot9_1;
  const T a9_2 = R9_12 * t9_21 - R9_22 * t9_23 + R9_32 * t9_24 + Pddot9_2;
  const T a9_3 = R9_13 * t9_21 - R9_23 * t9_23 + R9_33 * t9_24 + Pddot9_3;
  // G9 = -m9 a9 + F9: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G9_1 = T(1.84) * a9_1 + T(0.55);
  const T minus_G9_2 = T(1.84) * a9_2 + T(1.08);
  const T minus_G9_3 = T(1.84) * a9_3 + T(0.46);
  // N9 = -omega9~ I9 omega9 + M9: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t9_25 = omega9_1 * omega9_2;
  const T t9_26 = omega9_2 * omega9_3;
  const T t9_27 = omega9_2 * omega9_2;
  const T t9_28 = omega9_3 * omega9_3;
  const T t9_29 = omega9_1 * omega9_3;
  const T N9_1 = T(0.022) - T(0.0257) * t9_25 + T(0.022300000000000042) * t9_26 + T(0.0093) * (t9_27 - t9_28) +
      T(0.0215) * t9_29;
  const T t9_30 = omega9_1 * omega9_1;
  const T minus_N9_2 = T(0.075) + T(0.0257) * (t9_28 - t9_30) - T(0.04989999999999997) * t9_29 + T(0.0215) * t9_26 +
      T(0.0093) * t9_25;
  const T N9_3 = T(0.008) - T(0.07220000000000001) * t9_25 - T(0.0215) * (t9_30 - t9_27) + T(0.0093) * t9_29 +
      T(0.0257) * t9_26;

  // ---- body 10 (body_10) on body 8
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
  const T omega10_1 = y[27], omega10_2 = y[28], omega10_3 = y[29];
  const T sdot10_1 = y[63], sdot10_2 = y[64], sdot10_3 = y[65];
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
  // d10 = q10 + s10: joint offset q + s, axes of the lower body [m]
  const T d10_1 = T(0.172) + s10_1;
  const T d10_2 = s10_2 - T(0.399);
  const T d10_3 = s10_3 - T(0.25);
  // Pddot10 = R8^T omega8~ (omega8~ d10 + 2 sdot10) + Pddot8: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t10_13 = omega8_1 * d10_2 - omega8_2 * d10_1 + T(2) * sdot10_3;
  const T t10_14 = omega8_3 * d10_1 - omega8_1 * d10_3 + T(2) * sdot10_2;
  const T t10_15 = omega8_2 * t10_13 - omega8_3 * t10_14;
  const T t10_16 = omega8_2 * d10_3 - omega8_3 * d10_2 + T(2) * sdot10_1;
  const T t10_17 = omega8_3 * t10_16 - omega8_1 * t10_13;
  const T t10_18 = omega8_1 * t10_14 - omega8_2 * t10_16;
  const T Pddot10_1 = R8_11 * t10_15 + R8_21 * t10_17 + R8_31 * t10_18 + Pddot8_1;
  const T Pddot10_2 = R8_12 * t10_15 + R8_22 * t10_17 + R8_32 * t10_18 + Pddot8_2;
  const T Pddot10_3 = R8_13 * t10_15 + R8_23 * t10_17 + R8_33 * t10_18 + Pddot8_3;
  // a10 = R10^T omega10~ omega10~ r10 + Pddot10: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t10_19 = omega10_1 * T(0.148) - omega10_2 * T(0.016);
  const T t10_20 = omega10_3 * T(0.016) + omega10_1 * T(0.426);
  const T t10_21 = omega10_2 * t10_19 - omega10_3 * t10_20;
  const T t10_22 = omega10_3 * T(0.148) + omega10_2 * T(0.426);
  const T t10_23 = omega10_3 * t10_22 + omega10_1 * t10_19;
  const T t10_24 = omega10_1 * t10_20 + omega10_2 * t10_22;
  const T a10_1 = R10_11 * t10_21 - R10_21 * t10_23 + R10_31 * t10_24 + Pddot10_1;
  const T a10_2 = R10_12 * t10_21 - R10_22 * t10_23 + R10_32 * t10_24 + Pddot10_2;
  const T a10_3 = R10_13 * t10_21 - R10_23 * t10_23 + R10_33 * t10_24 + Pddot10_3;
  // G10 = -m10 a10 + F10: applied less inertia force at ydot = 0, inertial axes [N]
  const T G10_1 = T(1.24) - T(2.57) * a10_1;
  const T G10_2 = T(1.96) - T(2.57) * a10_2;
  const T G10_3 = T(0.69) - T(2.57) * a10_3;
  // N10 = -omega10~ I10 omega10 + M10: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t10_25 = omega10_2 * omega10_3;
  const T t10_26 = omega10_2 * omega10_2;
  const T t10_27 = omega10_3 * omega10_3;
  const T t10_28 = omega10_1 * omega10_2;
  const T t10_29 = omega10_1 * omega10_3;
  const T minus_N10_1 = T(0.066) + T(0.017199999999999993) * t10_25 - T(0.0065) * (t10_26 - t10_27) + T(0.0097) *
      t10_28 - T(0.0191) * t10_29;
  const T t10_30 = omega10_1 * omega10_1;
  const T minus_N10_2 = T(0.012) + T(0.0097) * (t10_27 - t10_30) - T(0.025599999999999998) * t10_29 + T(0.0191) *
      t10_25 + T(0.0065) * t10_28;
  const T minus_N10_3 = T(0.043) + T(0.008400000000000005) * t10_28 + T(0.0191) * (t10_30 - t10_26) - T(0.0065) *
      t10_29 - T(0.0097) * t10_25;

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  const T sdot11_1 = y[66], sdot11_2 = y[67], sdot11_3 = y[68];
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
  // d11 = q11 + s11: joint offset q + s, axes of the lower body [m]
  const T d11_1 = s11_1 - T(0.079);
  const T d11_2 = s11_2 - T(0.186);
  const T d11_3 = s11_3 - T(0.241);
  // Pddot11 = R5^T omega5~ (omega5~ d11 + 2 sdot11) + Pddot5: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t11_13 = omega5_1 * d11_2 - omega5_2 * d11_1 + T(2) * sdot11_3;
  const T t11_14 = omega5_3 * d11_1 - omega5_1 * d11_3 + T(2) * sdot11_2;
  const T t11_15 = omega5_2 * t11_13 - omega5_3 * t11_14;
  const T t11_16 = omega5_2 * d11_3 - omega5_3 * d11_2 + T(2) * sdot11_1;
  const T t11_17 = omega5_3 * t11_16 - omega5_1 * t11_13;
  const T t11_18 = omega5_1 * t11_14 - omega5_2 * t11_16;
  const T Pddot11_1 = R5_11 * t11_15 + R5_21 * t11_17 + R5_31 * t11_18 + Pddot5_1;
  const T Pddot11_2 = R5_12 * t11_15 + R5_22 * t11_17 + R5_32 * t11_18 + Pddot5_2;
  const T Pddot11_3 = R5_13 * t11_15 + R5_23 * t11_17 + R5_33 * t11_18 + Pddot5_3;
  // a11 = R11^T omega11~ omega11~ r11 + Pddot11: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t11_19 = omega11_3 * T(0.348) + omega11_2 * T(0.337);
  const T t11_20 = omega11_1 * T(0.348) + omega11_2 * T(0.402);
  const T t11_21 = omega11_3 * t11_19 + omega11_1 * t11_20;
  const T t11_22 = omega11_3 * T(0.402) - omega11_1 * T(0.337);
  const T t11_23 = omega11_3 * t11_22 + omega11_2 * t11_20;
  const T t11_24 = omega11_1 * t11_22 - omega11_2 * t11_19;
  const T a11_1 = R11_21 * t11_21 - R11_11 * t11_23 + R11_31 * t11_24 + Pddot11_1;
  const T a11_2 = R11_22 * t11_21 - R11_12 * t11_23 + R11_32 * t11_24 + Pddot11_2;
  const T a11_3 = R11_23 * t11_21 - R11_13 * t11_23 + R11_33 * t11_24 + Pddot11_3;
  // G11 = -m11 a11 + F11: applied less inertia force at ydot = 0, inertial axes [N]
  const T minus_G11_1 = T(3.77) * a11_1 + T(0.34);
  const T minus_G11_2 = T(3.77) * a11_2 + T(1.79);
  const T minus_G11_3 = T(3.77) * a11_3 + T(1.8);
  // N11 = -omega11~ I11 omega11 + M11: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t11_25 = omega11_2 * omega11_3;
  const T t11_26 = omega11_2 * omega11_2;
  const T t11_27 = omega11_3 * omega11_3;
  const T t11_28 = omega11_1 * omega11_2;
  const T t11_29 = omega11_1 * omega11_3;
  const T minus_N11_1 = T(0.077) + T(0.041600000000000026) * t11_25 + T(0.0124) * (t11_26 - t11_27) - T(0.0238) *
      t11_28 + T(3e-04) * t11_29;
  const T t11_30 = omega11_1 * omega11_1;
  const T N11_2 = T(0.059) * t11_29 + T(0.0238) * (t11_27 - t11_30) + T(3e-04) * t11_25 + T(0.0124) * t11_28 -
      T(0.039);
  const T minus_N11_3 = T(0.068) + T(0.01739999999999997) * t11_28 - T(3e-04) * (t11_30 - t11_26) + T(0.0124) * t11_29
      + T(0.0238) * t11_25;

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
  const T omega12_1 = y[33], omega12_2 = y[34], omega12_3 = y[35];
  const T sdot12_1 = y[69], sdot12_2 = y[70], sdot12_3 = y[71];
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
  // d12 = q12 + s12: joint offset q + s, axes of the lower body [m]
  const T d12_1 = s12_1 - T(0.422);
  const T d12_2 = T(0.42) + s12_2;
  const T d12_3 = T(0.022) + s12_3;
  // Pddot12 = R11^T omega11~ (omega11~ d12 + 2 sdot12) + Pddot11: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t12_13 = omega11_1 * d12_2 - omega11_2 * d12_1 + T(2) * sdot12_3;
  const T t12_14 = omega11_3 * d12_1 - omega11_1 * d12_3 + T(2) * sdot12_2;
  const T t12_15 = omega11_2 * t12_13 - omega11_3 * t12_14;
  const T t12_16 = omega11_2 * d12_3 - omega11_3 * d12_2 + T(2) * sdot12_1;
  const T t12_17 = omega11_3 * t12_16 - omega11_1 * t12_13;
  const T t12_18 = omega11_1 * t12_14 - omega11_2 * t12_16;
  const T Pddot12_1 = R11_11 * t12_15 + R11_21 * t12_17 + R11_31 * t12_18 + Pddot11_1;
  const T Pddot12_2 = R11_12 * t12_15 + R11_22 * t12_17 + R11_32 * t12_18 + Pddot11_2;
  const T Pddot12_3 = R11_13 * t12_15 + R11_23 * t12_17 + R11_33 * t12_18 + Pddot11_3;
  // a12 = R12^T omega12~ omega12~ r12 + Pddot12: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t12_19 = omega12_2 * T(0.006) - omega12_1 * T(0.141);
  const T t12_20 = omega12_1 * T(0.1) - omega12_3 * T(0.006);
  const T t12_21 = omega12_2 * t12_19 - omega12_3 * t12_20;
  const T t12_22 = omega12_3 * T(0.141) - omega12_2 * T(0.1);
  const T t12_23 = omega12_3 * t12_22 - omega12_1 * t12_19;
  const T t12_24 = omega12_1 * t12_20 - omega12_2 * t12_22;
  const T a12_1 = R12_11 * t12_21 + R12_21 * t12_23 + R12_31 * t12_24 + Pddot12_1;
  const T a12_2 = R12_12 * t12_21 + R12_22 * t12_23 + R12_32 * t12_24 + Pddot12_2;
  const T a12_3 = R12_13 * t12_21 + R12_23 * t12_23 + R12_33 * t12_24 + Pddot12_3;
  // G12 = -m12 a12 + F12: applied less inertia force at ydot = 0, inertial axes [N]
  const T G12_1 = T(0.25) - T(4.06) * a12_1;
  const T G12_2 = T(1.37) - T(4.06) * a12_2;
  const T G12_3 = T(1.59) - T(4.06) * a12_3;
  // N12 = -omega12~ I12 omega12 + M12: applied less inertia moment at omegadot = 0, body axes [N m]
  const T t12_25 = omega12_2 * omega12_3;
  const T t12_26 = omega12_2 * omega12_2;
  const T t12_27 = omega12_3 * omega12_3;
  const T t12_28 = omega12_1 * omega12_2;
  const T t12_29 = omega12_1 * omega12_3;
  const T N12_1 = T(0.01) + T(0.26759999999999995) * t12_25 + T(0.0023) * (t12_26 - t12_27) + T(0.1084) * t12_28 +
      T(0.0121) * t12_29;
  const T t12_30 = omega12_1 * omega12_1;
  const T N12_2 = T(0.009) - T(0.08610000000000001) * t12_29 + T(0.1084) * (t12_27 - t12_30) - T(0.0121) * t12_25 -
      T(0.0023) * t12_28;
  const T N12_3 = T(0.069) - T(0.18149999999999994) * t12_28 - T(0.0121) * (t12_30 - t12_26) + T(0.0023) * t12_29 -
      T(0.1084) * t12_25;

  // ---- body 12 (body_12) and what it carries
  // f_omega12 = r12~ R12 G12 + N12: Kane's equation of omega [N m]
  const T b12_1 = R12_21 * G12_1 + R12_22 * G12_2 + R12_23 * G12_3;
  const T b12_2 = R12_31 * G12_1 + R12_32 * G12_2 + R12_33 * G12_3;
  const T f_omega12_1 = T(0.1) * b12_1 - T(0.141) * b12_2 + N12_1;
  const T b12_3 = R12_11 * G12_1 + R12_12 * G12_2 + R12_13 * G12_3;
  const T f_omega12_2 = T(0.006) * b12_2 - T(0.1) * b12_3 + N12_2;
  const T f_omega12_3 = T(0.141) * b12_3 - T(0.006) * b12_1 + N12_3;
  f[33] = f_omega12_1;
  f[34] = f_omega12_2;
  f[35] = f_omega12_3;
  // f_sdot12 = R11 G12: Kane's equation of sdot [N]
  const T f_sdot12_1 = R11_11 * G12_1 + R11_12 * G12_2 + R11_13 * G12_3;
  const T f_sdot12_2 = R11_21 * G12_1 + R11_22 * G12_2 + R11_23 * G12_3;
  const T f_sdot12_3 = R11_31 * G12_1 + R11_32 * G12_2 + R11_33 * G12_3;
  f[69] = f_sdot12_1;
  f[70] = f_sdot12_2;
  f[71] = f_sdot12_3;

  // ---- body 11 (body_11) and what it carries
  // f_omega11 = r11~ R11 G11 + d12~ R11 G12 + N11: Kane's equation of omega [N m]
  const T b11_1 = R11_21 * minus_G11_1 + R11_22 * minus_G11_2 + R11_23 * minus_G11_3;
  const T b11_2 = R11_31 * minus_G11_1 + R11_32 * minus_G11_2 + R11_33 * minus_G11_3;
  const T f_omega11_1 = T(0.337) * b11_1 + T(0.348) * b11_2 + d12_2 * f_sdot12_3 - d12_3 * f_sdot12_2 - minus_N11_1;
  const T b11_3 = R11_11 * minus_G11_1 + R11_12 * minus_G11_2 + R11_13 * minus_G11_3;
  const T f_omega11_2 = T(0.402) * b11_2 - T(0.337) * b11_3 + d12_3 * f_sdot12_1 - d12_1 * f_sdot12_3 + N11_2;
  const T f_omega11_3 = d12_1 * f_sdot12_2 - d12_2 * f_sdot12_1 - T(0.402) * b11_1 - T(0.348) * b11_3 - minus_N11_3;
  f[30] = f_omega11_1;
  f[31] = f_omega11_2;
  f[32] = f_omega11_3;
  // S11 = G11 + G12: sum of the force balances of the subtree, inertial axes [N]
  const T S11_1 = G12_1 - minus_G11_1;
  const T S11_2 = G12_2 - minus_G11_2;
  const T S11_3 = G12_3 - minus_G11_3;
  // f_sdot11 = R5 S11: Kane's equation of sdot [N]
  const T f_sdot11_1 = R5_11 * S11_1 + R5_12 * S11_2 + R5_13 * S11_3;
  const T f_sdot11_2 = R5_21 * S11_1 + R5_22 * S11_2 + R5_23 * S11_3;
  const T f_sdot11_3 = R5_31 * S11_1 + R5_32 * S11_2 + R5_33 * S11_3;
  f[66] = f_sdot11_1;
  f[67] = f_sdot11_2;
  f[68] = f_sdot11_3;

  // ---- body 10 (body_10) and what it carries
  // f_omega10 = r10~ R10 G10 + N10: Kane's equation of omega [N m]
  const T b10_1 = R10_21 * G10_1 + R10_22 * G10_2 + R10_23 * G10_3;
  const T b10_2 = R10_31 * G10_1 + R10_32 * G10_2 + R10_33 * G10_3;
  const T f_omega10_1 = T(0.426) * b10_1 + T(0.148) * b10_2 - minus_N10_1;
  const T b10_3 = R10_11 * G10_1 + R10_12 * G10_2 + R10_13 * G10_3;
  const T minus_f_omega10_2 = T(0.426) * b10_3 + T(0.016) * b10_2 + minus_N10_2;
  const T f_omega10_3 = T(0.016) * b10_1 - T(0.148) * b10_3 - minus_N10_3;
  f[27] = f_omega10_1;
  f[28] = -minus_f_omega10_2;
  f[29] = f_omega10_3;
  // f_sdot10 = R8 G10: Kane's equation of sdot [N]
  const T f_sdot10_1 = R8_11 * G10_1 + R8_12 * G10_2 + R8_13 * G10_3;
  const T f_sdot10_2 = R8_21 * G10_1 + R8_22 * G10_2 + R8_23 * G10_3;
  const T f_sdot10_3 = R8_31 * G10_1 + R8_32 * G10_2 + R8_33 * G10_3;
  f[63] = f_sdot10_1;
  f[64] = f_sdot10_2;
  f[65] = f_sdot10_3;

  // ---- body 9 (body_9) and what it carries
  // f_omega9 = r9~ R9 G9 + N9: Kane's equation of omega [N m]
  const T b9_1 = R9_21 * minus_G9_1 + R9_22 * minus_G9_2 + R9_23 * minus_G9_3;
  const T b9_2 = R9_31 * minus_G9_1 + R9_32 * minus_G9_2 + R9_33 * minus_G9_3;
  const T f_omega9_1 = N9_1 - T(0.015) * b9_1 - T(0.49) * b9_2;
  const T b9_3 = R9_11 * minus_G9_1 + R9_12 * minus_G9_2 + R9_13 * minus_G9_3;
  const T f_omega9_2 = T(0.015) * b9_3 + T(0.362) * b9_2 - minus_N9_2;
  const T f_omega9_3 = T(0.49) * b9_3 - T(0.362) * b9_1 + N9_3;
  f[24] = f_omega9_1;
  f[25] = f_omega9_2;
  f[26] = f_omega9_3;
  // f_sdot9 = R6 G9: Kane's equation of sdot [N]
  const T minus_f_sdot9_1 = R6_11 * minus_G9_1 + R6_12 * minus_G9_2 + R6_13 * minus_G9_3;
  const T minus_f_sdot9_2 = R6_21 * minus_G9_1 + R6_22 * minus_G9_2 + R6_23 * minus_G9_3;
  const T minus_f_sdot9_3 = R6_31 * minus_G9_1 + R6_32 * minus_G9_2 + R6_33 * minus_G9_3;
  f[60] = -minus_f_sdot9_1;
  f[61] = -minus_f_sdot9_2;
  f[62] = -minus_f_sdot9_3;

  // ---- body 8 (body_8) and what it carries
  // f_omega8 = r8~ R8 G8 + d10~ R8 G10 + N8: Kane's equation of omega [N m]
  const T b8_1 = R8_21 * G8_1 + R8_22 * G8_2 + R8_23 * G8_3;
  const T b8_2 = R8_31 * G8_1 + R8_32 * G8_2 + R8_33 * G8_3;
  const T f_omega8_1 = T(0.444) * b8_1 - T(0.416) * b8_2 + d10_2 * f_sdot10_3 - d10_3 * f_sdot10_2 + N8_1;
  const T b8_3 = R8_11 * G8_1 + R8_12 * G8_2 + R8_13 * G8_3;
  const T f_omega8_2 = T(0.392) * b8_2 - T(0.444) * b8_3 + d10_3 * f_sdot10_1 - d10_1 * f_sdot10_3 + N8_2;
  const T f_omega8_3 = T(0.416) * b8_3 - T(0.392) * b8_1 + d10_1 * f_sdot10_2 - d10_2 * f_sdot10_1 + N8_3;
  f[21] = f_omega8_1;
  f[22] = f_omega8_2;
  f[23] = f_omega8_3;
  // S8 = G8 + G10: sum of the force balances of the subtree, inertial axes [N]
  const T S8_1 = G8_1 + G10_1;
  const T S8_2 = G8_2 + G10_2;
  const T S8_3 = G8_3 + G10_3;
  // f_sdot8 = R1 S8: Kane's equation of sdot [N]
  const T f_sdot8_1 = R1_11 * S8_1 + R1_12 * S8_2 + R1_13 * S8_3;
  const T f_sdot8_2 = R1_21 * S8_1 + R1_22 * S8_2 + R1_23 * S8_3;
  const T f_sdot8_3 = R1_31 * S8_1 + R1_32 * S8_2 + R1_33 * S8_3;
  f[57] = f_sdot8_1;
  f[58] = f_sdot8_2;
  f[59] = f_sdot8_3;

  // ---- body 7 (body_7) and what it carries
  // f_omega7 = r7~ R7 G7 + N7: Kane's equation of omega [N m]
  const T b7_1 = R7_31 * minus_G7_1 + R7_32 * minus_G7_2 + R7_33 * minus_G7_3;
  const T b7_2 = R7_21 * minus_G7_1 + R7_22 * minus_G7_2 + R7_23 * minus_G7_3;
  const T f_omega7_1 = T(0.192) * b7_1 - T(0.487) * b7_2 - minus_N7_1;
  const T b7_3 = R7_11 * minus_G7_1 + R7_12 * minus_G7_2 + R7_13 * minus_G7_3;
  const T f_omega7_2 = T(0.487) * b7_3 - T(0.475) * b7_1 + N7_2;
  const T f_omega7_3 = T(0.475) * b7_2 - T(0.192) * b7_3 + N7_3;
  f[18] = f_omega7_1;
  f[19] = f_omega7_2;
  f[20] = f_omega7_3;
  // f_sdot7 = R4 G7: Kane's equation of sdot [N]
  const T minus_f_sdot7_1 = R4_11 * minus_G7_1 + R4_12 * minus_G7_2 + R4_13 * minus_G7_3;
  const T minus_f_sdot7_2 = R4_21 * minus_G7_1 + R4_22 * minus_G7_2 + R4_23 * minus_G7_3;
  const T minus_f_sdot7_3 = R4_31 * minus_G7_1 + R4_32 * minus_G7_2 + R4_33 * minus_G7_3;
  f[54] = -minus_f_sdot7_1;
  f[55] = -minus_f_sdot7_2;
  f[56] = -minus_f_sdot7_3;

  // ---- body 6 (body_6) and what it carries
  // f_omega6 = r6~ R6 G6 + d9~ R6 G9 + N6: Kane's equation of omega [N m]
  const T b6_1 = R6_21 * G6_1 - R6_22 * minus_G6_2 + R6_23 * G6_3;
  const T b6_2 = R6_31 * G6_1 - R6_32 * minus_G6_2 + R6_33 * G6_3;
  const T f_omega6_1 = T(0.454) * b6_1 - T(0.248) * b6_2 + d9_3 * minus_f_sdot9_2 - d9_2 * minus_f_sdot9_3 + N6_1;
  const T b6_3 = R6_11 * G6_1 - R6_12 * minus_G6_2 + R6_13 * G6_3;
  const T f_omega6_2 = d9_1 * minus_f_sdot9_3 - d9_3 * minus_f_sdot9_1 - T(0.454) * b6_3 - T(0.044) * b6_2 -
      minus_N6_2;
  const T f_omega6_3 = T(0.044) * b6_1 + T(0.248) * b6_3 + d9_2 * minus_f_sdot9_1 - d9_1 * minus_f_sdot9_2 -
      minus_N6_3;
  f[15] = f_omega6_1;
  f[16] = f_omega6_2;
  f[17] = f_omega6_3;
  // S6 = G6 + G9: sum of the force balances of the subtree, inertial axes [N]
  const T S6_1 = G6_1 - minus_G9_1;
  const T minus_S6_2 = minus_G6_2 + minus_G9_2;
  const T S6_3 = G6_3 - minus_G9_3;
  // f_sdot6 = R2 S6: Kane's equation of sdot [N]
  const T f_sdot6_1 = R2_11 * S6_1 - R2_12 * minus_S6_2 + R2_13 * S6_3;
  const T f_sdot6_2 = R2_21 * S6_1 - R2_22 * minus_S6_2 + R2_23 * S6_3;
  const T f_sdot6_3 = R2_31 * S6_1 - R2_32 * minus_S6_2 + R2_33 * S6_3;
  f[51] = f_sdot6_1;
  f[52] = f_sdot6_2;
  f[53] = f_sdot6_3;

  // ---- body 5 (body_5) and what it carries
  // f_omega5 = r5~ R5 G5 + d11~ R5 S11 + N5: Kane's equation of omega [N m]
  const T b5_1 = R5_21 * G5_1 - R5_22 * minus_G5_2 - R5_23 * minus_G5_3;
  const T b5_2 = R5_31 * G5_1 - R5_32 * minus_G5_2 - R5_33 * minus_G5_3;
  const T f_omega5_1 = d11_2 * f_sdot11_3 - d11_3 * f_sdot11_2 - T(0.167) * b5_1 - T(0.321) * b5_2 - minus_N5_1;
  const T b5_3 = R5_11 * G5_1 - R5_12 * minus_G5_2 - R5_13 * minus_G5_3;
  const T f_omega5_2 = T(0.167) * b5_3 + T(0.056) * b5_2 + d11_3 * f_sdot11_1 - d11_1 * f_sdot11_3 - minus_N5_2;
  const T f_omega5_3 = T(0.321) * b5_3 - T(0.056) * b5_1 + d11_1 * f_sdot11_2 - d11_2 * f_sdot11_1 - minus_N5_3;
  f[12] = f_omega5_1;
  f[13] = f_omega5_2;
  f[14] = f_omega5_3;
  // S5 = G5 + S11: sum of the force balances of the subtree, inertial axes [N]
  const T S5_1 = G5_1 + S11_1;
  const T S5_2 = S11_2 - minus_G5_2;
  const T S5_3 = S11_3 - minus_G5_3;
  // f_sdot5 = R3 S5: Kane's equation of sdot [N]
  const T f_sdot5_1 = R3_11 * S5_1 + R3_12 * S5_2 + R3_13 * S5_3;
  const T f_sdot5_2 = R3_21 * S5_1 + R3_22 * S5_2 + R3_23 * S5_3;
  const T f_sdot5_3 = R3_31 * S5_1 + R3_32 * S5_2 + R3_33 * S5_3;
  f[48] = f_sdot5_1;
  f[49] = f_sdot5_2;
  f[50] = f_sdot5_3;

  // ---- body 4 (body_4) and what it carries
  // f_omega4 = r4~ R4 G4 + d7~ R4 G7 + N4: Kane's equation of omega [N m]
  const T b4_1 = R4_31 * G4_1 - R4_32 * minus_G4_2 + R4_33 * G4_3;
  const T b4_2 = R4_21 * G4_1 - R4_22 * minus_G4_2 + R4_23 * G4_3;
  const T f_omega4_1 = T(0.289) * b4_1 - T(0.08) * b4_2 + d7_3 * minus_f_sdot7_2 - d7_2 * minus_f_sdot7_3 + N4_1;
  const T b4_3 = R4_11 * G4_1 - R4_12 * minus_G4_2 + R4_13 * G4_3;
  const T f_omega4_2 = T(0.08) * b4_3 - T(0.401) * b4_1 + d7_1 * minus_f_sdot7_3 - d7_3 * minus_f_sdot7_1 + N4_2;
  const T f_omega4_3 = T(0.401) * b4_2 - T(0.289) * b4_3 + d7_2 * minus_f_sdot7_1 - d7_1 * minus_f_sdot7_2 + N4_3;
  f[9] = f_omega4_1;
  f[10] = f_omega4_2;
  f[11] = f_omega4_3;
  // S4 = G4 + G7: sum of the force balances of the subtree, inertial axes [N]
  const T S4_1 = G4_1 - minus_G7_1;
  const T minus_S4_2 = minus_G4_2 + minus_G7_2;
  const T S4_3 = G4_3 - minus_G7_3;
  // f_sdot4 = R3 S4: Kane's equation of sdot [N]
  const T f_sdot4_1 = R3_11 * S4_1 - R3_12 * minus_S4_2 + R3_13 * S4_3;
  const T f_sdot4_2 = R3_21 * S4_1 - R3_22 * minus_S4_2 + R3_23 * S4_3;
  const T f_sdot4_3 = R3_31 * S4_1 - R3_32 * minus_S4_2 + R3_33 * S4_3;
  f[45] = f_sdot4_1;
  f[46] = f_sdot4_2;
  f[47] = f_sdot4_3;

  // ---- body 3 (body_3) and what it carries
  // f_omega3 = r3~ R3 G3 + d4~ R3 S4 + d5~ R3 S5 + N3: Kane's equation of omega [N m]
  const T b3_1 = R3_31 * G3_1 + R3_32 * G3_2 - R3_33 * minus_G3_3;
  const T b3_2 = R3_21 * G3_1 + R3_22 * G3_2 - R3_23 * minus_G3_3;
  const T f_omega3_1 = T(0.498) * b3_1 - T(0.004) * b3_2 + d4_2 * f_sdot4_3 - d4_3 * f_sdot4_2 + d5_2 * f_sdot5_3 -
      d5_3 * f_sdot5_2 + N3_1;
  const T b3_3 = R3_11 * G3_1 + R3_12 * G3_2 - R3_13 * minus_G3_3;
  const T f_omega3_2 = T(0.004) * b3_3 - T(0.484) * b3_1 + d4_3 * f_sdot4_1 - d4_1 * f_sdot4_3 + d5_3 * f_sdot5_1 -
      d5_1 * f_sdot5_3 - minus_N3_2;
  const T f_omega3_3 = T(0.484) * b3_2 - T(0.498) * b3_3 + d4_1 * f_sdot4_2 - d4_2 * f_sdot4_1 + d5_1 * f_sdot5_2 -
      d5_2 * f_sdot5_1 + N3_3;
  f[6] = f_omega3_1;
  f[7] = f_omega3_2;
  f[8] = f_omega3_3;
  // S3 = G3 + S5 + S4: sum of the force balances of the subtree, inertial axes [N]
  const T S3_1 = G3_1 + S5_1 + S4_1;
  const T S3_2 = G3_2 + S5_2 - minus_S4_2;
  const T S3_3 = S5_3 - minus_G3_3 + S4_3;
  // f_sdot3 = R2 S3: Kane's equation of sdot [N]
  const T f_sdot3_1 = R2_11 * S3_1 + R2_12 * S3_2 + R2_13 * S3_3;
  const T f_sdot3_2 = R2_21 * S3_1 + R2_22 * S3_2 + R2_23 * S3_3;
  const T f_sdot3_3 = R2_31 * S3_1 + R2_32 * S3_2 + R2_33 * S3_3;
  f[42] = f_sdot3_1;
  f[43] = f_sdot3_2;
  f[44] = f_sdot3_3;

  // ---- body 2 (body_2) and what it carries
  // f_omega2 = r2~ R2 G2 + d3~ R2 S3 + d6~ R2 S6 + N2: Kane's equation of omega [N m]
  const T b2_1 = R2_31 * G2_1 - R2_32 * minus_G2_2 - R2_33 * minus_G2_3;
  const T f_omega2_1 = T(0.31) * b2_1 + d3_2 * f_sdot3_3 - d3_3 * f_sdot3_2 + d6_2 * f_sdot6_3 - d6_3 * f_sdot6_2 -
      minus_N2_1;
  const T f_omega2_2 = d3_3 * f_sdot3_1 - d3_1 * f_sdot3_3 - T(0.011) * b2_1 + d6_3 * f_sdot6_1 - d6_1 * f_sdot6_3 +
      N2_2;
  const T f_omega2_3 = T(0.011) * (R2_21 * G2_1 - R2_22 * minus_G2_2 - R2_23 * minus_G2_3) - T(0.31) * (R2_11 * G2_1 -
      R2_12 * minus_G2_2 - R2_13 * minus_G2_3) + d3_1 * f_sdot3_2 - d3_2 * f_sdot3_1 + d6_1 * f_sdot6_2 - d6_2 *
      f_sdot6_1 - minus_N2_3;
  f[3] = f_omega2_1;
  f[4] = f_omega2_2;
  f[5] = f_omega2_3;
  // S2 = G2 + S6 + S3: sum of the force balances of the subtree, inertial axes [N]
  const T S2_1 = G2_1 + S6_1 + S3_1;
  const T S2_2 = S3_2 - minus_G2_2 - minus_S6_2;
  const T S2_3 = S6_3 - minus_G2_3 + S3_3;
  // f_sdot2 = R1 S2: Kane's equation of sdot [N]
  const T f_sdot2_1 = R1_11 * S2_1 + R1_12 * S2_2 + R1_13 * S2_3;
  const T f_sdot2_2 = R1_21 * S2_1 + R1_22 * S2_2 + R1_23 * S2_3;
  const T f_sdot2_3 = R1_31 * S2_1 + R1_32 * S2_2 + R1_33 * S2_3;
  f[39] = f_sdot2_1;
  f[40] = f_sdot2_2;
  f[41] = f_sdot2_3;

  // ---- body 1 (body_1) and what it carries
  // f_omega1 = r1~ R1 G1 + d2~ R1 S2 + d8~ R1 S8 + N1: Kane's equation of omega [N m]
  const T b1_1 = R1_21 * G1_1 - R1_22 * minus_G1_2 - R1_23 * minus_G1_3;
  const T b1_2 = R1_31 * G1_1 - R1_32 * minus_G1_2 - R1_33 * minus_G1_3;
  const T f_omega1_1 = T(0.095) * b1_1 - T(0.163) * b1_2 + d2_2 * f_sdot2_3 - d2_3 * f_sdot2_2 + d8_2 * f_sdot8_3 -
      d8_3 * f_sdot8_2 + N1_1;
  const T b1_3 = R1_11 * G1_1 - R1_12 * minus_G1_2 - R1_13 * minus_G1_3;
  const T f_omega1_2 = d2_3 * f_sdot2_1 - d2_1 * f_sdot2_3 - T(0.095) * b1_3 - T(0.187) * b1_2 + d8_3 * f_sdot8_1 -
      d8_1 * f_sdot8_3 + N1_2;
  const T f_omega1_3 = T(0.187) * b1_1 + T(0.163) * b1_3 + d2_1 * f_sdot2_2 - d2_2 * f_sdot2_1 + d8_1 * f_sdot8_2 -
      d8_2 * f_sdot8_1 - minus_N1_3;
  f[0] = f_omega1_1;
  f[1] = f_omega1_2;
  f[2] = f_omega1_3;
  // S1 = G1 + S8 + S2: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = G1_1 + S8_1 + S2_1;
  const T S1_2 = S8_2 - minus_G1_2 + S2_2;
  const T S1_3 = S8_3 - minus_G1_3 + S2_3;
  f[36] = S1_1;
  f[37] = S1_2;
  f[38] = S1_3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 1628 add, 3432 multiply
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  for (int i = 0; i < 5184; ++i) A[i] = T(0);

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
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
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
  // d2 = q2 + s2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = s2_1 - T(0.472);
  const T d2_2 = T(0.323) + s2_2;
  const T d2_3 = s2_3 - T(0.07);
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
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
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
  // d3 = q3 + s3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = s3_1 - T(0.476);
  const T d3_2 = s3_2 - T(0.178);
  const T d3_3 = T(0.287) + s3_3;
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

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
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
  // d4 = q4 + s4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = s4_1 - T(0.153);
  const T d4_2 = s4_2 - T(0.132);
  const T d4_3 = T(0.236) + s4_3;
  // C3_4 = R3 R4^T: takes components in the body to those in body 3
  const T C3_4_11 = R3_11 * R4_11 + R3_12 * R4_12 + R3_13 * R4_13;
  const T C3_4_12 = R3_11 * R4_21 + R3_12 * R4_22 + R3_13 * R4_23;
  const T C3_4_13 = R3_11 * R4_31 + R3_12 * R4_32 + R3_13 * R4_33;
  const T C3_4_21 = R3_21 * R4_11 + R3_22 * R4_12 + R3_23 * R4_13;
  const T C3_4_22 = R3_21 * R4_21 + R3_22 * R4_22 + R3_23 * R4_23;
  const T C3_4_23 = R3_21 * R4_31 + R3_22 * R4_32 + R3_23 * R4_33;
  const T C3_4_31 = R3_31 * R4_11 + R3_32 * R4_12 + R3_33 * R4_13;
  const T C3_4_32 = R3_31 * R4_21 + R3_32 * R4_22 + R3_33 * R4_23;
  const T C3_4_33 = R3_31 * R4_31 + R3_32 * R4_32 + R3_33 * R4_33;
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

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
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
  // d5 = q5 + s5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = s5_1 - T(0.159);
  const T d5_2 = s5_2 - T(0.262);
  const T d5_3 = s5_3 - T(0.173);
  // C3_5 = R3 R5^T: takes components in the body to those in body 3
  const T C3_5_11 = R3_11 * R5_11 + R3_12 * R5_12 + R3_13 * R5_13;
  const T C3_5_12 = R3_11 * R5_21 + R3_12 * R5_22 + R3_13 * R5_23;
  const T C3_5_13 = R3_11 * R5_31 + R3_12 * R5_32 + R3_13 * R5_33;
  const T C3_5_21 = R3_21 * R5_11 + R3_22 * R5_12 + R3_23 * R5_13;
  const T C3_5_22 = R3_21 * R5_21 + R3_22 * R5_22 + R3_23 * R5_23;
  const T C3_5_23 = R3_21 * R5_31 + R3_22 * R5_32 + R3_23 * R5_33;
  const T C3_5_31 = R3_31 * R5_11 + R3_32 * R5_12 + R3_33 * R5_13;
  const T C3_5_32 = R3_31 * R5_21 + R3_32 * R5_22 + R3_33 * R5_23;
  const T C3_5_33 = R3_31 * R5_31 + R3_32 * R5_32 + R3_33 * R5_33;
  // C2_5 = R2 R5^T: takes components in the body to those in body 2
  const T C2_5_11 = R2_11 * R5_11 + R2_12 * R5_12 + R2_13 * R5_13;
  const T C2_5_12 = R2_11 * R5_21 + R2_12 * R5_22 + R2_13 * R5_23;
  const T C2_5_13 = R2_11 * R5_31 + R2_12 * R5_32 + R2_13 * R5_33;
  const T C2_5_21 = R2_21 * R5_11 + R2_22 * R5_12 + R2_23 * R5_13;
  const T C2_5_22 = R2_21 * R5_21 + R2_22 * R5_22 + R2_23 * R5_23;
  const T C2_5_23 = R2_21 * R5_31 + R2_22 * R5_32 + R2_23 * R5_33;
  const T C2_5_31 = R2_31 * R5_11 + R2_32 * R5_12 + R2_33 * R5_13;
  const T C2_5_32 = R2_31 * R5_21 + R2_32 * R5_22 + R2_33 * R5_23;
  const T C2_5_33 = R2_31 * R5_31 + R2_32 * R5_32 + R2_33 * R5_33;
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

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
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
  // d6 = q6 + s6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.304) + s6_1;
  const T d6_2 = s6_2 - T(0.214);
  const T d6_3 = T(0.436) + s6_3;
  // C2_6 = R2 R6^T: takes components in the body to those in body 2
  const T C2_6_11 = R2_11 * R6_11 + R2_12 * R6_12 + R2_13 * R6_13;
  const T C2_6_12 = R2_11 * R6_21 + R2_12 * R6_22 + R2_13 * R6_23;
  const T C2_6_13 = R2_11 * R6_31 + R2_12 * R6_32 + R2_13 * R6_33;
  const T C2_6_21 = R2_21 * R6_11 + R2_22 * R6_12 + R2_23 * R6_13;
  const T C2_6_22 = R2_21 * R6_21 + R2_22 * R6_22 + R2_23 * R6_23;
  const T C2_6_23 = R2_21 * R6_31 + R2_22 * R6_32 + R2_23 * R6_33;
  const T C2_6_31 = R2_31 * R6_11 + R2_32 * R6_12 + R2_33 * R6_13;
  const T C2_6_32 = R2_31 * R6_21 + R2_32 * R6_22 + R2_33 * R6_23;
  const T C2_6_33 = R2_31 * R6_31 + R2_32 * R6_32 + R2_33 * R6_33;
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

  // ---- body 7 (body_7) on body 4
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
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
  // d7 = q7 + s7: joint offset q + s, axes of the lower body [m]
  const T d7_1 = s7_1 - T(0.329);
  const T d7_2 = s7_2 - T(0.337);
  const T d7_3 = T(0.216) + s7_3;
  // C1_7 = R1 R7^T: takes components in the body to those in body 1
  const T C1_7_11 = R1_11 * R7_11 + R1_12 * R7_12 + R1_13 * R7_13;
  const T C1_7_12 = R1_11 * R7_21 + R1_12 * R7_22 + R1_13 * R7_23;
  const T C1_7_13 = R1_11 * R7_31 + R1_12 * R7_32 + R1_13 * R7_33;
  const T C1_7_21 = R1_21 * R7_11 + R1_22 * R7_12 + R1_23 * R7_13;
  const T C1_7_22 = R1_21 * R7_21 + R1_22 * R7_22 + R1_23 * R7_23;
  const T C1_7_23 = R1_21 * R7_31 + R1_22 * R7_32 + R1_23 * R7_33;
  const T C1_7_31 = R1_31 * R7_11 + R1_32 * R7_12 + R1_33 * R7_13;
  const T C1_7_32 = R1_31 * R7_21 + R1_32 * R7_22 + R1_33 * R7_23;
  const T C1_7_33 = R1_31 * R7_31 + R1_32 * R7_32 + R1_33 * R7_33;
  // C2_7 = R2 R7^T: takes components in the body to those in body 2
  const T C2_7_11 = R2_11 * R7_11 + R2_12 * R7_12 + R2_13 * R7_13;
  const T C2_7_12 = R2_11 * R7_21 + R2_12 * R7_22 + R2_13 * R7_23;
  const T C2_7_13 = R2_11 * R7_31 + R2_12 * R7_32 + R2_13 * R7_33;
  const T C2_7_21 = R2_21 * R7_11 + R2_22 * R7_12 + R2_23 * R7_13;
  const T C2_7_22 = R2_21 * R7_21 + R2_22 * R7_22 + R2_23 * R7_23;
  const T C2_7_23 = R2_21 * R7_31 + R2_22 * R7_32 + R2_23 * R7_33;
  const T C2_7_31 = R2_31 * R7_11 + R2_32 * R7_12 + R2_33 * R7_13;
  const T C2_7_32 = R2_31 * R7_21 + R2_32 * R7_22 + R2_33 * R7_23;
  const T C2_7_33 = R2_31 * R7_31 + R2_32 * R7_32 + R2_33 * R7_33;
  // C3_7 = R3 R7^T: takes components in the body to those in body 3
  const T C3_7_11 = R3_11 * R7_11 + R3_12 * R7_12 + R3_13 * R7_13;
  const T C3_7_12 = R3_11 * R7_21 + R3_12 * R7_22 + R3_13 * R7_23;
  const T C3_7_13 = R3_11 * R7_31 + R3_12 * R7_32 + R3_13 * R7_33;
  const T C3_7_21 = R3_21 * R7_11 + R3_22 * R7_12 + R3_23 * R7_13;
  const T C3_7_22 = R3_21 * R7_21 + R3_22 * R7_22 + R3_23 * R7_23;
  const T C3_7_23 = R3_21 * R7_31 + R3_22 * R7_32 + R3_23 * R7_33;
  const T C3_7_31 = R3_31 * R7_11 + R3_32 * R7_12 + R3_33 * R7_13;
  const T C3_7_32 = R3_31 * R7_21 + R3_32 * R7_22 + R3_33 * R7_23;
  const T C3_7_33 = R3_31 * R7_31 + R3_32 * R7_32 + R3_33 * R7_33;
  // C4_7 = R4 R7^T: takes components in the body to those in body 4
  const T C4_7_11 = R4_11 * R7_11 + R4_12 * R7_12 + R4_13 * R7_13;
  const T C4_7_12 = R4_11 * R7_21 + R4_12 * R7_22 + R4_13 * R7_23;
  const T C4_7_13 = R4_11 * R7_31 + R4_12 * R7_32 + R4_13 * R7_33;
  const T C4_7_21 = R4_21 * R7_11 + R4_22 * R7_12 + R4_23 * R7_13;
  const T C4_7_22 = R4_21 * R7_21 + R4_22 * R7_22 + R4_23 * R7_23;
  const T C4_7_23 = R4_21 * R7_31 + R4_22 * R7_32 + R4_23 * R7_33;
  const T C4_7_31 = R4_31 * R7_11 + R4_32 * R7_12 + R4_33 * R7_13;
  const T C4_7_32 = R4_31 * R7_21 + R4_32 * R7_22 + R4_33 * R7_23;
  const T C4_7_33 = R4_31 * R7_31 + R4_32 * R7_32 + R4_33 * R7_33;

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
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
  // d8 = q8 + s8: joint offset q + s, axes of the lower body [m]
  const T d8_1 = s8_1 - T(0.492);
  const T d8_2 = s8_2 - T(0.25);
  const T d8_3 = s8_3 - T(0.387);
  // C1_8 = R1 R8^T: takes components in the body to those in body 1
  const T C1_8_11 = R1_11 * R8_11 + R1_12 * R8_12 + R1_13 * R8_13;
  const T C1_8_12 = R1_11 * R8_21 + R1_12 * R8_22 + R1_13 * R8_23;
  const T C1_8_13 = R1_11 * R8_31 + R1_12 * R8_32 + R1_13 * R8_33;
  const T C1_8_21 = R1_21 * R8_11 + R1_22 * R8_12 + R1_23 * R8_13;
  const T C1_8_22 = R1_21 * R8_21 + R1_22 * R8_22 + R1_23 * R8_23;
  const T C1_8_23 = R1_21 * R8_31 + R1_22 * R8_32 + R1_23 * R8_33;
  const T C1_8_31 = R1_31 * R8_11 + R1_32 * R8_12 + R1_33 * R8_13;
  const T C1_8_32 = R1_31 * R8_21 + R1_32 * R8_22 + R1_33 * R8_23;
  const T C1_8_33 = R1_31 * R8_31 + R1_32 * R8_32 + R1_33 * R8_33;

  // ---- body 9 (body_9) on body 6
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
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
  // d9 = q9 + s9: joint offset q + s, axes of the lower body [m]
  const T d9_1 = s9_1 - T(0.305);
  const T d9_2 = T(0.124) + s9_2;
  const T d9_3 = T(0.036) + s9_3;
  // C1_9 = R1 R9^T: takes components in the body to those in body 1
  const T C1_9_11 = R1_11 * R9_11 + R1_12 * R9_12 + R1_13 * R9_13;
  const T C1_9_12 = R1_11 * R9_21 + R1_12 * R9_22 + R1_13 * R9_23;
  const T C1_9_13 = R1_11 * R9_31 + R1_12 * R9_32 + R1_13 * R9_33;
  const T C1_9_21 = R1_21 * R9_11 + R1_22 * R9_12 + R1_23 * R9_13;
  const T C1_9_22 = R1_21 * R9_21 + R1_22 * R9_22 + R1_23 * R9_23;
  const T C1_9_23 = R1_21 * R9_31 + R1_22 * R9_32 + R1_23 * R9_33;
  const T C1_9_31 = R1_31 * R9_11 + R1_32 * R9_12 + R1_33 * R9_13;
  const T C1_9_32 = R1_31 * R9_21 + R1_32 * R9_22 + R1_33 * R9_23;
  const T C1_9_33 = R1_31 * R9_31 + R1_32 * R9_32 + R1_33 * R9_33;
  // C2_9 = R2 R9^T: takes components in the body to those in body 2
  const T C2_9_11 = R2_11 * R9_11 + R2_12 * R9_12 + R2_13 * R9_13;
  const T C2_9_12 = R2_11 * R9_21 + R2_12 * R9_22 + R2_13 * R9_23;
  const T C2_9_13 = R2_11 * R9_31 + R2_12 * R9_32 + R2_13 * R9_33;
  const T C2_9_21 = R2_21 * R9_11 + R2_22 * R9_12 + R2_23 * R9_13;
  const T C2_9_22 = R2_21 * R9_21 + R2_22 * R9_22 + R2_23 * R9_23;
  const T C2_9_23 = R2_21 * R9_31 + R2_22 * R9_32 + R2_23 * R9_33;
  const T C2_9_31 = R2_31 * R9_11 + R2_32 * R9_12 + R2_33 * R9_13;
  const T C2_9_32 = R2_31 * R9_21 + R2_32 * R9_22 + R2_33 * R9_23;
  const T C2_9_33 = R2_31 * R9_31 + R2_32 * R9_32 + R2_33 * R9_33;
  // C6_9 = R6 R9^T: takes components in the body to those in body 6
  const T C6_9_11 = R6_11 * R9_11 + R6_12 * R9_12 + R6_13 * R9_13;
  const T C6_9_12 = R6_11 * R9_21 + R6_12 * R9_22 + R6_13 * R9_23;
  const T C6_9_13 = R6_11 * R9_31 + R6_12 * R9_32 + R6_13 * R9_33;
  const T C6_9_21 = R6_21 * R9_11 + R6_22 * R9_12 + R6_23 * R9_13;
  const T C6_9_22 = R6_21 * R9_21 + R6_22 * R9_22 + R6_23 * R9_23;
  const T C6_9_23 = R6_21 * R9_31 + R6_22 * R9_32 + R6_23 * R9_33;
  const T C6_9_31 = R6_31 * R9_11 + R6_32 * R9_12 + R6_33 * R9_13;
  const T C6_9_32 = R6_31 * R9_21 + R6_32 * R9_22 + R6_33 * R9_23;
  const T C6_9_33 = R6_31 * R9_31 + R6_32 * R9_32 + R6_33 * R9_33;

  // ---- body 10 (body_10) on body 8
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
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
  // d10 = q10 + s10: joint offset q + s, axes of the lower body [m]
  const T d10_1 = T(0.172) + s10_1;
  const T d10_2 = s10_2 - T(0.399);
  const T d10_3 = s10_3 - T(0.25);
  // C1_10 = R1 R10^T: takes components in the body to those in body 1
  const T C1_10_11 = R1_11 * R10_11 + R1_12 * R10_12 + R1_13 * R10_13;
  const T C1_10_12 = R1_11 * R10_21 + R1_12 * R10_22 + R1_13 * R10_23;
  const T C1_10_13 = R1_11 * R10_31 + R1_12 * R10_32 + R1_13 * R10_33;
  const T C1_10_21 = R1_21 * R10_11 + R1_22 * R10_12 + R1_23 * R10_13;
  const T C1_10_22 = R1_21 * R10_21 + R1_22 * R10_22 + R1_23 * R10_23;
  const T C1_10_23 = R1_21 * R10_31 + R1_22 * R10_32 + R1_23 * R10_33;
  const T C1_10_31 = R1_31 * R10_11 + R1_32 * R10_12 + R1_33 * R10_13;
  const T C1_10_32 = R1_31 * R10_21 + R1_32 * R10_22 + R1_33 * R10_23;
  const T C1_10_33 = R1_31 * R10_31 + R1_32 * R10_32 + R1_33 * R10_33;
  // C8_10 = R8 R10^T: takes components in the body to those in body 8
  const T C8_10_11 = R8_11 * R10_11 + R8_12 * R10_12 + R8_13 * R10_13;
  const T C8_10_12 = R8_11 * R10_21 + R8_12 * R10_22 + R8_13 * R10_23;
  const T C8_10_13 = R8_11 * R10_31 + R8_12 * R10_32 + R8_13 * R10_33;
  const T C8_10_21 = R8_21 * R10_11 + R8_22 * R10_12 + R8_23 * R10_13;
  const T C8_10_22 = R8_21 * R10_21 + R8_22 * R10_22 + R8_23 * R10_23;
  const T C8_10_23 = R8_21 * R10_31 + R8_22 * R10_32 + R8_23 * R10_33;
  const T C8_10_31 = R8_31 * R10_11 + R8_32 * R10_12 + R8_33 * R10_13;
  const T C8_10_32 = R8_31 * R10_21 + R8_32 * R10_22 + R8_33 * R10_23;
  const T C8_10_33 = R8_31 * R10_31 + R8_32 * R10_32 + R8_33 * R10_33;

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
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
  // d11 = q11 + s11: joint offset q + s, axes of the lower body [m]
  const T d11_1 = s11_1 - T(0.079);
  const T d11_2 = s11_2 - T(0.186);
  const T d11_3 = s11_3 - T(0.241);
  // C5_11 = R5 R11^T: takes components in the body to those in body 5
  const T C5_11_11 = R5_11 * R11_11 + R5_12 * R11_12 + R5_13 * R11_13;
  const T C5_11_12 = R5_11 * R11_21 + R5_12 * R11_22 + R5_13 * R11_23;
  const T C5_11_13 = R5_11 * R11_31 + R5_12 * R11_32 + R5_13 * R11_33;
  const T C5_11_21 = R5_21 * R11_11 + R5_22 * R11_12 + R5_23 * R11_13;
  const T C5_11_22 = R5_21 * R11_21 + R5_22 * R11_22 + R5_23 * R11_23;
  const T C5_11_23 = R5_21 * R11_31 + R5_22 * R11_32 + R5_23 * R11_33;
  const T C5_11_31 = R5_31 * R11_11 + R5_32 * R11_12 + R5_33 * R11_13;
  const T C5_11_32 = R5_31 * R11_21 + R5_32 * R11_22 + R5_33 * R11_23;
  const T C5_11_33 = R5_31 * R11_31 + R5_32 * R11_32 + R5_33 * R11_33;
  // C3_11 = R3 R11^T: takes components in the body to those in body 3
  const T C3_11_11 = R3_11 * R11_11 + R3_12 * R11_12 + R3_13 * R11_13;
  const T C3_11_12 = R3_11 * R11_21 + R3_12 * R11_22 + R3_13 * R11_23;
  const T C3_11_13 = R3_11 * R11_31 + R3_12 * R11_32 + R3_13 * R11_33;
  const T C3_11_21 = R3_21 * R11_11 + R3_22 * R11_12 + R3_23 * R11_13;
  const T C3_11_22 = R3_21 * R11_21 + R3_22 * R11_22 + R3_23 * R11_23;
  const T C3_11_23 = R3_21 * R11_31 + R3_22 * R11_32 + R3_23 * R11_33;
  const T C3_11_31 = R3_31 * R11_11 + R3_32 * R11_12 + R3_33 * R11_13;
  const T C3_11_32 = R3_31 * R11_21 + R3_32 * R11_22 + R3_33 * R11_23;
  const T C3_11_33 = R3_31 * R11_31 + R3_32 * R11_32 + R3_33 * R11_33;
  // C2_11 = R2 R11^T: takes components in the body to those in body 2
  const T C2_11_11 = R2_11 * R11_11 + R2_12 * R11_12 + R2_13 * R11_13;
  const T C2_11_12 = R2_11 * R11_21 + R2_12 * R11_22 + R2_13 * R11_23;
  const T C2_11_13 = R2_11 * R11_31 + R2_12 * R11_32 + R2_13 * R11_33;
  const T C2_11_21 = R2_21 * R11_11 + R2_22 * R11_12 + R2_23 * R11_13;
  const T C2_11_22 = R2_21 * R11_21 + R2_22 * R11_22 + R2_23 * R11_23;
  const T C2_11_23 = R2_21 * R11_31 + R2_22 * R11_32 + R2_23 * R11_33;
  const T C2_11_31 = R2_31 * R11_11 + R2_32 * R11_12 + R2_33 * R11_13;
  const T C2_11_32 = R2_31 * R11_21 + R2_32 * R11_22 + R2_33 * R11_23;
  const T C2_11_33 = R2_31 * R11_31 + R2_32 * R11_32 + R2_33 * R11_33;
  // C1_11 = R1 R11^T: takes components in the body to those in body 1
  const T C1_11_11 = R1_11 * R11_11 + R1_12 * R11_12 + R1_13 * R11_13;
  const T C1_11_12 = R1_11 * R11_21 + R1_12 * R11_22 + R1_13 * R11_23;
  const T C1_11_13 = R1_11 * R11_31 + R1_12 * R11_32 + R1_13 * R11_33;
  const T C1_11_21 = R1_21 * R11_11 + R1_22 * R11_12 + R1_23 * R11_13;
  const T C1_11_22 = R1_21 * R11_21 + R1_22 * R11_22 + R1_23 * R11_23;
  const T C1_11_23 = R1_21 * R11_31 + R1_22 * R11_32 + R1_23 * R11_33;
  const T C1_11_31 = R1_31 * R11_11 + R1_32 * R11_12 + R1_33 * R11_13;
  const T C1_11_32 = R1_31 * R11_21 + R1_32 * R11_22 + R1_33 * R11_23;
  const T C1_11_33 = R1_31 * R11_31 + R1_32 * R11_32 + R1_33 * R11_33;

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
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
  // d12 = q12 + s12: joint offset q + s, axes of the lower body [m]
  const T d12_1 = s12_1 - T(0.422);
  const T d12_2 = T(0.42) + s12_2;
  const T d12_3 = T(0.022) + s12_3;
  // C1_12 = R1 R12^T: takes components in the body to those in body 1
  const T C1_12_11 = R1_11 * R12_11 + R1_12 * R12_12 + R1_13 * R12_13;
  const T C1_12_12 = R1_11 * R12_21 + R1_12 * R12_22 + R1_13 * R12_23;
  const T C1_12_13 = R1_11 * R12_31 + R1_12 * R12_32 + R1_13 * R12_33;
  const T C1_12_21 = R1_21 * R12_11 + R1_22 * R12_12 + R1_23 * R12_13;
  const T C1_12_22 = R1_21 * R12_21 + R1_22 * R12_22 + R1_23 * R12_23;
  const T C1_12_23 = R1_21 * R12_31 + R1_22 * R12_32 + R1_23 * R12_33;
  const T C1_12_31 = R1_31 * R12_11 + R1_32 * R12_12 + R1_33 * R12_13;
  const T C1_12_32 = R1_31 * R12_21 + R1_32 * R12_22 + R1_33 * R12_23;
  const T C1_12_33 = R1_31 * R12_31 + R1_32 * R12_32 + R1_33 * R12_33;
  // C2_12 = R2 R12^T: takes components in the body to those in body 2
  const T C2_12_11 = R2_11 * R12_11 + R2_12 * R12_12 + R2_13 * R12_13;
  const T C2_12_12 = R2_11 * R12_21 + R2_12 * R12_22 + R2_13 * R12_23;
  const T C2_12_13 = R2_11 * R12_31 + R2_12 * R12_32 + R2_13 * R12_33;
  const T C2_12_21 = R2_21 * R12_11 + R2_22 * R12_12 + R2_23 * R12_13;
  const T C2_12_22 = R2_21 * R12_21 + R2_22 * R12_22 + R2_23 * R12_23;
  const T C2_12_23 = R2_21 * R12_31 + R2_22 * R12_32 + R2_23 * R12_33;
  const T C2_12_31 = R2_31 * R12_11 + R2_32 * R12_12 + R2_33 * R12_13;
  const T C2_12_32 = R2_31 * R12_21 + R2_32 * R12_22 + R2_33 * R12_23;
  const T C2_12_33 = R2_31 * R12_31 + R2_32 * R12_32 + R2_33 * R12_33;
  // C3_12 = R3 R12^T: takes components in the body to those in body 3
  const T C3_12_11 = R3_11 * R12_11 + R3_12 * R12_12 + R3_13 * R12_13;
  const T C3_12_12 = R3_11 * R12_21 + R3_12 * R12_22 + R3_13 * R12_23;
  const T C3_12_13 = R3_11 * R12_31 + R3_12 * R12_32 + R3_13 * R12_33;
  const T C3_12_21 = R3_21 * R12_11 + R3_22 * R12_12 + R3_23 * R12_13;
  const T C3_12_22 = R3_21 * R12_21 + R3_22 * R12_22 + R3_23 * R12_23;
  const T C3_12_23 = R3_21 * R12_31 + R3_22 * R12_32 + R3_23 * R12_33;
  const T C3_12_31 = R3_31 * R12_11 + R3_32 * R12_12 + R3_33 * R12_13;
  const T C3_12_32 = R3_31 * R12_21 + R3_32 * R12_22 + R3_33 * R12_23;
  const T C3_12_33 = R3_31 * R12_31 + R3_32 * R12_32 + R3_33 * R12_33;
  // C5_12 = R5 R12^T: takes components in the body to those in body 5
  const T C5_12_11 = R5_11 * R12_11 + R5_12 * R12_12 + R5_13 * R12_13;
  const T C5_12_12 = R5_11 * R12_21 + R5_12 * R12_22 + R5_13 * R12_23;
  const T C5_12_13 = R5_11 * R12_31 + R5_12 * R12_32 + R5_13 * R12_33;
  const T C5_12_21 = R5_21 * R12_11 + R5_22 * R12_12 + R5_23 * R12_13;
  const T C5_12_22 = R5_21 * R12_21 + R5_22 * R12_22 + R5_23 * R12_23;
  const T C5_12_23 = R5_21 * R12_31 + R5_22 * R12_32 + R5_23 * R12_33;
  const T C5_12_31 = R5_31 * R12_11 + R5_32 * R12_12 + R5_33 * R12_13;
  const T C5_12_32 = R5_31 * R12_21 + R5_32 * R12_22 + R5_33 * R12_23;
  const T C5_12_33 = R5_31 * R12_31 + R5_32 * R12_32 + R5_33 * R12_33;
  // C11_12 = R11 R12^T: takes components in the body to those in body 11
  const T C11_12_11 = R11_11 * R12_11 + R11_12 * R12_12 + R11_13 * R12_13;
  const T C11_12_12 = R11_11 * R12_21 + R11_12 * R12_22 + R11_13 * R12_23;
  const T C11_12_13 = R11_11 * R12_31 + R11_12 * R12_32 + R11_13 * R12_33;
  const T C11_12_21 = R11_21 * R12_11 + R11_22 * R12_12 + R11_23 * R12_13;
  const T C11_12_22 = R11_21 * R12_21 + R11_22 * R12_22 + R11_23 * R12_23;
  const T C11_12_23 = R11_21 * R12_31 + R11_22 * R12_32 + R11_23 * R12_33;
  const T C11_12_31 = R11_31 * R12_11 + R11_32 * R12_12 + R11_33 * R12_13;
  const T C11_12_32 = R11_31 * R12_21 + R11_32 * R12_22 + R11_33 * R12_23;
  const T C11_12_33 = R11_31 * R12_31 + R11_32 * R12_32 + R11_33 * R12_33;

  // ---- body 11 (body_11) and what it carries
  // h11 = m11 r11 + m12 d12: first moment of mass carried, about the body origin, body axes [kg m]
  const T b11_1 = T(4.06) * d12_1;
  const T h11_1 = T(1.51554) + b11_1;
  const T b11_2 = T(4.06) * d12_2;
  const T h11_2 = b11_2 - T(1.31196);
  const T b11_3 = T(4.06) * d12_3;
  const T h11_3 = T(1.2704900000000001) + b11_3;

  // ---- body 8 (body_8) and what it carries
  // h8 = m8 r8 + m10 d10: first moment of mass carried, about the body origin, body axes [kg m]
  const T b8_1 = T(2.57) * d10_1;
  const T h8_1 = b8_1 - T(1.06232);
  const T b8_2 = T(2.57) * d10_2;
  const T h8_2 = b8_2 - T(1.12736);
  const T b8_3 = T(2.57) * d10_3;
  const T h8_3 = b8_3 - T(1.20324);

  // ---- body 6 (body_6) and what it carries
  // h6 = m6 r6 + m9 d9: first moment of mass carried, about the body origin, body axes [kg m]
  const T b6_1 = T(1.84) * d9_1;
  const T h6_1 = T(0.15311999999999998) + b6_1;
  const T b6_2 = T(1.84) * d9_2;
  const T h6_2 = b6_2 - T(0.86304);
  const T b6_3 = T(1.84) * d9_3;
  const T h6_3 = b6_3 - T(1.57992);

  // ---- body 5 (body_5) and what it carries
  // h5 = m5 r5 + m_sub11 d11: first moment of mass carried, about the body origin, body axes [kg m]
  const T b5_1 = T(7.83) * d11_1;
  const T h5_1 = b5_1 - T(0.10976);
  const T b5_2 = T(7.83) * d11_2;
  const T h5_2 = b5_2 - T(0.62916);
  const T b5_3 = T(7.83) * d11_3;
  const T h5_3 = T(0.32732) + b5_3;

  // ---- body 4 (body_4) and what it carries
  // h4 = m4 r4 + m7 d7: first moment of mass carried, about the body origin, body axes [kg m]
  const T b4_1 = T(0.74) * d7_1;
  const T h4_1 = T(1.8004900000000001) + b4_1;
  const T b4_2 = T(0.74) * d7_2;
  const T h4_2 = T(1.29761) + b4_2;
  const T b4_3 = T(0.74) * d7_3;
  const T h4_3 = T(0.3592) + b4_3;

  // ---- body 3 (body_3) and what it carries
  // h3 = m3 r3 + m_sub5 d5 + m_sub4 d4: first moment of mass carried, about the body origin, body axes [kg m]
  const T b3_1 = T(9.79) * d5_1;
  const T b3_2 = T(5.23) * d4_1;
  const T h3_1 = T(1.03576) + b3_1 + b3_2;
  const T b3_3 = T(9.79) * d5_2;
  const T b3_4 = T(5.23) * d4_2;
  const T h3_2 = T(1.06572) + b3_3 + b3_4;
  const T b3_5 = T(9.79) * d5_3;
  const T b3_6 = T(5.23) * d4_3;
  const T h3_3 = T(0.00856) + b3_5 + b3_6;

  // ---- body 2 (body_2) and what it carries
  // h2 = m2 r2 + m_sub6 d6 + m_sub3 d3: first moment of mass carried, about the body origin, body axes [kg m]
  const T b2_1 = T(5.32) * d6_1;
  const T b2_2 = T(17.16) * d3_1;
  const T h2_1 = T(0.007039999999999999) + b2_1 + b2_2;
  const T b2_3 = T(5.32) * d6_2;
  const T b2_4 = T(17.16) * d3_2;
  const T h2_2 = T(0.1984) + b2_3 + b2_4;
  const T b2_5 = T(5.32) * d6_3;
  const T b2_6 = T(17.16) * d3_3;
  const T h2_3 = b2_5 + b2_6;

  // ---- body 1 (body_1) and what it carries
  // h1 = m1 r1 + m_sub8 d8 + m_sub2 d2: first moment of mass carried, about the body origin, body axes [kg m]
  const T b1_1 = T(5.279999999999999) * d8_1;
  const T b1_2 = T(23.12) * d2_1;
  const T h1_1 = T(0.77605) + b1_1 + b1_2;
  const T b1_3 = T(5.279999999999999) * d8_2;
  const T b1_4 = T(23.12) * d2_2;
  const T h1_2 = b1_3 - T(0.6764500000000001) + b1_4;
  const T b1_5 = T(5.279999999999999) * d8_3;
  const T b1_6 = T(23.12) * d2_3;
  const T h1_3 = b1_5 - T(0.39425000000000004) + b1_6;

  // ---- results
  const T t1 = d8_3 * d8_3;
  const T t2 = d8_2 * d8_2;
  const T t3 = d2_3 * d2_3;
  const T t4 = d2_2 * d2_2;
  A[0] = T(0.6313151) + T(5.279999999999999) * (t1 + t2) + T(23.12) * (t3 + t4);
  const T t5 = T(0.13079615000000003) - d8_2 * d8_1 * T(5.279999999999999) - d2_2 * d2_1 * T(23.12);
  A[1] = t5;
  A[72] = t5;
  const T t6 = T(0.08662475) - d8_3 * d8_1 * T(5.279999999999999) - d2_3 * d2_1 * T(23.12);
  A[2] = t6;
  A[144] = t6;
  const T t7 = h2_2 * C1_2_23 - h2_3 * C1_2_22;
  const T t8 = h2_2 * C1_2_33 - h2_3 * C1_2_32;
  const T t9 = d2_3 * t7 - d2_2 * t8;
  A[3] = -t9;
  A[216] = -t9;
  const T t10 = h2_3 * C1_2_21 - h2_1 * C1_2_23;
  const T t11 = h2_3 * C1_2_31 - h2_1 * C1_2_33;
  const T t12 = d2_3 * t10 - d2_2 * t11;
  A[4] = -t12;
  A[288] = -t12;
  const T t13 = h2_1 * C1_2_22 - h2_2 * C1_2_21;
  const T t14 = h2_1 * C1_2_32 - h2_2 * C1_2_31;
  const T t15 = d2_3 * t13 - d2_2 * t14;
  A[5] = -t15;
  A[360] = -t15;
  const T t16 = h3_2 * C1_3_23 - h3_3 * C1_3_22;
  const T t17 = h3_2 * C1_3_33 - h3_3 * C1_3_32;
  const T t18 = d2_3 * t16 - d2_2 * t17;
  A[6] = -t18;
  A[432] = -t18;
  const T t19 = h3_3 * C1_3_21 - h3_1 * C1_3_23;
  const T t20 = h3_3 * C1_3_31 - h3_1 * C1_3_33;
  const T t21 = d2_3 * t19 - d2_2 * t20;
  A[7] = -t21;
  A[504] = -t21;
  const T t22 = h3_1 * C1_3_22 - h3_2 * C1_3_21;
  const T t23 = h3_1 * C1_3_32 - h3_2 * C1_3_31;
  const T t24 = d2_3 * t22 - d2_2 * t23;
  A[8] = -t24;
  A[576] = -t24;
  const T t25 = h4_2 * C1_4_23 - h4_3 * C1_4_22;
  const T t26 = h4_2 * C1_4_33 - h4_3 * C1_4_32;
  const T t27 = d2_3 * t25 - d2_2 * t26;
  A[9] = -t27;
  A[648] = -t27;
  const T t28 = h4_3 * C1_4_21 - h4_1 * C1_4_23;
  const T t29 = h4_3 * C1_4_31 - h4_1 * C1_4_33;
  const T t30 = d2_3 * t28 - d2_2 * t29;
  A[10] = -t30;
  A[720] = -t30;
  const T t31 = h4_1 * C1_4_22 - h4_2 * C1_4_21;
  const T t32 = h4_1 * C1_4_32 - h4_2 * C1_4_31;
  const T t33 = d2_3 * t31 - d2_2 * t32;
  A[11] = -t33;
  A[792] = -t33;
  const T t34 = h5_2 * C1_5_23 - h5_3 * C1_5_22;
  const T t35 = h5_2 * C1_5_33 - h5_3 * C1_5_32;
  const T t36 = d2_3 * t34 - d2_2 * t35;
  A[12] = -t36;
  A[864] = -t36;
  const T t37 = h5_3 * C1_5_21 - h5_1 * C1_5_23;
  const T t38 = h5_3 * C1_5_31 - h5_1 * C1_5_33;
  const T t39 = d2_3 * t37 - d2_2 * t38;
  A[13] = -t39;
  A[936] = -t39;
  const T t40 = h5_1 * C1_5_22 - h5_2 * C1_5_21;
  const T t41 = h5_1 * C1_5_32 - h5_2 * C1_5_31;
  const T t42 = d2_3 * t40 - d2_2 * t41;
  A[14] = -t42;
  A[1008] = -t42;
  const T t43 = h6_2 * C1_6_23 - h6_3 * C1_6_22;
  const T t44 = h6_2 * C1_6_33 - h6_3 * C1_6_32;
  const T t45 = d2_3 * t43 - d2_2 * t44;
  A[15] = -t45;
  A[1080] = -t45;
  const T t46 = h6_3 * C1_6_21 - h6_1 * C1_6_23;
  const T t47 = h6_3 * C1_6_31 - h6_1 * C1_6_33;
  const T t48 = d2_3 * t46 - d2_2 * t47;
  A[16] = -t48;
  A[1152] = -t48;
  const T t49 = h6_1 * C1_6_22 - h6_2 * C1_6_21;
  const T t50 = h6_1 * C1_6_32 - h6_2 * C1_6_31;
  const T t51 = d2_3 * t49 - d2_2 * t50;
  A[17] = -t51;
  A[1224] = -t51;
  const T t52 = T(0.487) * C1_7_22 - T(0.192) * C1_7_23;
  const T t53 = T(0.487) * C1_7_32 - T(0.192) * C1_7_33;
  const T t54 = T(0.74) * (d2_3 * t52 - d2_2 * t53);
  A[18] = -t54;
  A[1296] = -t54;
  const T t55 = T(0.475) * C1_7_23 - T(0.487) * C1_7_21;
  const T t56 = T(0.475) * C1_7_33 - T(0.487) * C1_7_31;
  const T t57 = T(0.74) * (d2_3 * t55 - d2_2 * t56);
  A[19] = -t57;
  A[1368] = -t57;
  const T t58 = T(0.192) * C1_7_21 - T(0.475) * C1_7_22;
  const T t59 = T(0.192) * C1_7_31 - T(0.475) * C1_7_32;
  const T t60 = T(0.74) * (d2_3 * t58 - d2_2 * t59);
  A[20] = -t60;
  A[1440] = -t60;
  const T t61 = h8_2 * C1_8_23 - h8_3 * C1_8_22;
  const T t62 = h8_2 * C1_8_33 - h8_3 * C1_8_32;
  const T t63 = d8_3 * t61 - d8_2 * t62;
  A[21] = -t63;
  A[1512] = -t63;
  const T t64 = h8_3 * C1_8_21 - h8_1 * C1_8_23;
  const T t65 = h8_3 * C1_8_31 - h8_1 * C1_8_33;
  const T t66 = d8_3 * t64 - d8_2 * t65;
  A[22] = -t66;
  A[1584] = -t66;
  const T t67 = h8_1 * C1_8_22 - h8_2 * C1_8_21;
  const T t68 = h8_1 * C1_8_32 - h8_2 * C1_8_31;
  const T t69 = d8_3 * t67 - d8_2 * t68;
  A[23] = -t69;
  A[1656] = -t69;
  const T t70 = T(0.015) * C1_9_22 + T(0.49) * C1_9_23;
  const T t71 = T(0.015) * C1_9_32 + T(0.49) * C1_9_33;
  const T t72 = T(1.84) * (d2_3 * t70 - d2_2 * t71);
  A[24] = -t72;
  A[1728] = -t72;
  const T t73 = T(0.015) * C1_9_31 + T(0.362) * C1_9_33;
  const T t74 = T(0.015) * C1_9_21 + T(0.362) * C1_9_23;
  const T t75 = T(1.84) * (d2_2 * t73 - d2_3 * t74);
  A[25] = -t75;
  A[1800] = -t75;
  const T t76 = T(0.362) * C1_9_22 - T(0.49) * C1_9_21;
  const T t77 = T(0.362) * C1_9_32 - T(0.49) * C1_9_31;
  const T t78 = T(1.84) * (d2_3 * t76 - d2_2 * t77);
  A[26] = -t78;
  A[1872] = -t78;
  const T t79 = T(0.426) * C1_10_22 + T(0.148) * C1_10_23;
  const T t80 = T(0.426) * C1_10_32 + T(0.148) * C1_10_33;
  const T t81 = T(2.57) * (d8_3 * t79 - d8_2 * t80);
  A[27] = -t81;
  A[1944] = -t81;
  const T t82 = T(0.426) * C1_10_31 + T(0.016) * C1_10_33;
  const T t83 = T(0.426) * C1_10_21 + T(0.016) * C1_10_23;
  const T t84 = T(2.57) * (d8_2 * t82 - d8_3 * t83);
  A[28] = -t84;
  A[2016] = -t84;
  const T t85 = T(0.016) * C1_10_22 - T(0.148) * C1_10_21;
  const T t86 = T(0.016) * C1_10_32 - T(0.148) * C1_10_31;
  const T t87 = T(2.57) * (d8_3 * t85 - d8_2 * t86);
  A[29] = -t87;
  A[2088] = -t87;
  const T t88 = h11_2 * C1_11_23 - h11_3 * C1_11_22;
  const T t89 = h11_2 * C1_11_33 - h11_3 * C1_11_32;
  const T t90 = d2_3 * t88 - d2_2 * t89;
  A[30] = -t90;
  A[2160] = -t90;
  const T t91 = h11_3 * C1_11_21 - h11_1 * C1_11_23;
  const T t92 = h11_3 * C1_11_31 - h11_1 * C1_11_33;
  const T t93 = d2_3 * t91 - d2_2 * t92;
  A[31] = -t93;
  A[2232] = -t93;
  const T t94 = h11_1 * C1_11_22 - h11_2 * C1_11_21;
  const T t95 = h11_1 * C1_11_32 - h11_2 * C1_11_31;
  const T t96 = d2_3 * t94 - d2_2 * t95;
  A[32] = -t96;
  A[2304] = -t96;
  const T t97 = T(0.1) * C1_12_22 - T(0.141) * C1_12_23;
  const T t98 = T(0.1) * C1_12_32 - T(0.141) * C1_12_33;
  const T t99 = T(4.06) * (d2_3 * t97 - d2_2 * t98);
  A[33] = -t99;
  A[2376] = -t99;
  const T t100 = T(0.006) * C1_12_23 - T(0.1) * C1_12_21;
  const T t101 = T(0.006) * C1_12_33 - T(0.1) * C1_12_31;
  const T t102 = T(4.06) * (d2_3 * t100 - d2_2 * t101);
  A[34] = -t102;
  A[2448] = -t102;
  const T t103 = T(0.141) * C1_12_21 - T(0.006) * C1_12_22;
  const T t104 = T(0.141) * C1_12_31 - T(0.006) * C1_12_32;
  const T t105 = T(4.06) * (d2_3 * t103 - d2_2 * t104);
  A[35] = -t105;
  A[2520] = -t105;
  const T t106 = h1_2 * R1_31 - h1_3 * R1_21;
  A[36] = t106;
  A[2592] = t106;
  const T t107 = h1_2 * R1_32 - h1_3 * R1_22;
  A[37] = t107;
  A[2664] = t107;
  const T t108 = h1_2 * R1_33 - h1_3 * R1_23;
  A[38] = t108;
  A[2736] = t108;
  A[40] = -b1_6;
  A[111] = b1_6;
  A[2809] = b1_6;
  A[2880] = -b1_6;
  A[41] = b1_4;
  A[183] = -b1_4;
  A[2810] = -b1_4;
  A[2952] = b1_4;
  const T t109 = d2_2 * C1_2_31 - d2_3 * C1_2_21;
  const T t110 = T(17.16) * t109;
  A[42] = t110;
  A[3024] = t110;
  const T t111 = d2_2 * C1_2_32 - d2_3 * C1_2_22;
  const T t112 = T(17.16) * t111;
  A[43] = t112;
  A[3096] = t112;
  const T t113 = d2_2 * C1_2_33 - d2_3 * C1_2_23;
  const T t114 = T(17.16) * t113;
  A[44] = t114;
  A[3168] = t114;
  const T t115 = d2_2 * C1_3_31 - d2_3 * C1_3_21;
  const T t116 = T(5.23) * t115;
  A[45] = t116;
  A[3240] = t116;
  const T t117 = d2_2 * C1_3_32 - d2_3 * C1_3_22;
  const T t118 = T(5.23) * t117;
  A[46] = t118;
  A[3312] = t118;
  const T t119 = d2_2 * C1_3_33 - d2_3 * C1_3_23;
  const T t120 = T(5.23) * t119;
  A[47] = t120;
  A[3384] = t120;
  const T t121 = T(9.79) * t115;
  A[48] = t121;
  A[3456] = t121;
  const T t122 = T(9.79) * t117;
  A[49] = t122;
  A[3528] = t122;
  const T t123 = T(9.79) * t119;
  A[50] = t123;
  A[3600] = t123;
  const T t124 = T(5.32) * t109;
  A[51] = t124;
  A[3672] = t124;
  const T t125 = T(5.32) * t111;
  A[52] = t125;
  A[3744] = t125;
  const T t126 = T(5.32) * t113;
  A[53] = t126;
  A[3816] = t126;
  const T t127 = T(0.74) * (d2_2 * C1_4_31 - d2_3 * C1_4_21);
  A[54] = t127;
  A[3888] = t127;
  const T t128 = T(0.74) * (d2_2 * C1_4_32 - d2_3 * C1_4_22);
  A[55] = t128;
  A[3960] = t128;
  const T t129 = T(0.74) * (d2_2 * C1_4_33 - d2_3 * C1_4_23);
  A[56] = t129;
  A[4032] = t129;
  A[58] = -b1_5;
  A[129] = b1_5;
  A[4105] = b1_5;
  A[4176] = -b1_5;
  A[59] = b1_3;
  A[201] = -b1_3;
  A[4106] = -b1_3;
  A[4248] = b1_3;
  const T t130 = T(1.84) * (d2_2 * C1_6_31 - d2_3 * C1_6_21);
  A[60] = t130;
  A[4320] = t130;
  const T t131 = T(1.84) * (d2_2 * C1_6_32 - d2_3 * C1_6_22);
  A[61] = t131;
  A[4392] = t131;
  const T t132 = T(1.84) * (d2_2 * C1_6_33 - d2_3 * C1_6_23);
  A[62] = t132;
  A[4464] = t132;
  const T t133 = T(2.57) * (d8_2 * C1_8_31 - d8_3 * C1_8_21);
  A[63] = t133;
  A[4536] = t133;
  const T t134 = T(2.57) * (d8_2 * C1_8_32 - d8_3 * C1_8_22);
  A[64] = t134;
  A[4608] = t134;
  const T t135 = T(2.57) * (d8_2 * C1_8_33 - d8_3 * C1_8_23);
  A[65] = t135;
  A[4680] = t135;
  const T t136 = T(7.83) * (d2_2 * C1_5_31 - d2_3 * C1_5_21);
  A[66] = t136;
  A[4752] = t136;
  const T t137 = T(7.83) * (d2_2 * C1_5_32 - d2_3 * C1_5_22);
  A[67] = t137;
  A[4824] = t137;
  const T t138 = T(7.83) * (d2_2 * C1_5_33 - d2_3 * C1_5_23);
  A[68] = t138;
  A[4896] = t138;
  const T t139 = T(4.06) * (d2_2 * C1_11_31 - d2_3 * C1_11_21);
  A[69] = t139;
  A[4968] = t139;
  const T t140 = T(4.06) * (d2_2 * C1_11_32 - d2_3 * C1_11_22);
  A[70] = t140;
  A[5040] = t140;
  const T t141 = T(4.06) * (d2_2 * C1_11_33 - d2_3 * C1_11_23);
  A[71] = t141;
  A[5112] = t141;
  const T t142 = d8_1 * d8_1;
  const T t143 = d2_1 * d2_1;
  A[73] = T(0.6069751) + T(5.279999999999999) * (t1 + t142) + T(23.12) * (t3 + t143);
  const T t144 = T(0.07706275000000001) + d8_3 * d8_2 * T(5.279999999999999) + d2_3 * d2_2 * T(23.12);
  A[74] = -t144;
  A[145] = -t144;
  const T t145 = h2_2 * C1_2_13 - h2_3 * C1_2_12;
  const T t146 = d2_1 * t8 - d2_3 * t145;
  A[75] = -t146;
  A[217] = -t146;
  const T t147 = h2_3 * C1_2_11 - h2_1 * C1_2_13;
  const T t148 = d2_1 * t11 - d2_3 * t147;
  A[76] = -t148;
  A[289] = -t148;
  const T t149 = h2_1 * C1_2_12 - h2_2 * C1_2_11;
  const T t150 = d2_1 * t14 - d2_3 * t149;
  A[77] = -t150;
  A[361] = -t150;
  const T t151 = h3_2 * C1_3_13 - h3_3 * C1_3_12;
  const T t152 = d2_1 * t17 - d2_3 * t151;
  A[78] = -t152;
  A[433] = -t152;
  const T t153 = h3_3 * C1_3_11 - h3_1 * C1_3_13;
  const T t154 = d2_1 * t20 - d2_3 * t153;
  A[79] = -t154;
  A[505] = -t154;
  const T t155 = h3_1 * C1_3_12 - h3_2 * C1_3_11;
  const T t156 = d2_1 * t23 - d2_3 * t155;
  A[80] = -t156;
  A[577] = -t156;
  const T t157 = h4_2 * C1_4_13 - h4_3 * C1_4_12;
  const T t158 = d2_1 * t26 - d2_3 * t157;
  A[81] = -t158;
  A[649] = -t158;
  const T t159 = h4_3 * C1_4_11 - h4_1 * C1_4_13;
  const T t160 = d2_1 * t29 - d2_3 * t159;
  A[82] = -t160;
  A[721] = -t160;
  const T t161 = h4_1 * C1_4_12 - h4_2 * C1_4_11;
  const T t162 = d2_1 * t32 - d2_3 * t161;
  A[83] = -t162;
  A[793] = -t162;
  const T t163 = h5_2 * C1_5_13 - h5_3 * C1_5_12;
  const T t164 = d2_1 * t35 - d2_3 * t163;
  A[84] = -t164;
  A[865] = -t164;
  const T t165 = h5_3 * C1_5_11 - h5_1 * C1_5_13;
  const T t166 = d2_1 * t38 - d2_3 * t165;
  A[85] = -t166;
  A[937] = -t166;
  const T t167 = h5_1 * C1_5_12 - h5_2 * C1_5_11;
  const T t168 = d2_1 * t41 - d2_3 * t167;
  A[86] = -t168;
  A[1009] = -t168;
  const T t169 = h6_2 * C1_6_13 - h6_3 * C1_6_12;
  const T t170 = d2_1 * t44 - d2_3 * t169;
  A[87] = -t170;
  A[1081] = -t170;
  const T t171 = h6_3 * C1_6_11 - h6_1 * C1_6_13;
  const T t172 = d2_1 * t47 - d2_3 * t171;
  A[88] = -t172;
  A[1153] = -t172;
  const T t173 = h6_1 * C1_6_12 - h6_2 * C1_6_11;
  const T t174 = d2_1 * t50 - d2_3 * t173;
  A[89] = -t174;
  A[1225] = -t174;
  const T t175 = T(0.487) * C1_7_12 - T(0.192) * C1_7_13;
  const T t176 = T(0.74) * (d2_1 * t53 - d2_3 * t175);
  A[90] = -t176;
  A[1297] = -t176;
  const T t177 = T(0.475) * C1_7_13 - T(0.487) * C1_7_11;
  const T t178 = T(0.74) * (d2_1 * t56 - d2_3 * t177);
  A[91] = -t178;
  A[1369] = -t178;
  const T t179 = T(0.192) * C1_7_11 - T(0.475) * C1_7_12;
  const T t180 = T(0.74) * (d2_1 * t59 - d2_3 * t179);
  A[92] = -t180;
  A[1441] = -t180;
  const T t181 = h8_2 * C1_8_13 - h8_3 * C1_8_12;
  const T t182 = d8_1 * t62 - d8_3 * t181;
  A[93] = -t182;
  A[1513] = -t182;
  const T t183 = h8_3 * C1_8_11 - h8_1 * C1_8_13;
  const T t184 = d8_1 * t65 - d8_3 * t183;
  A[94] = -t184;
  A[1585] = -t184;
  const T t185 = h8_1 * C1_8_12 - h8_2 * C1_8_11;
  const T t186 = d8_1 * t68 - d8_3 * t185;
  A[95] = -t186;
  A[1657] = -t186;
  const T t187 = T(0.015) * C1_9_12 + T(0.49) * C1_9_13;
  const T t188 = T(1.84) * (d2_1 * t71 - d2_3 * t187);
  A[96] = -t188;
  A[1729] = -t188;
  const T t189 = T(0.015) * C1_9_11 + T(0.362) * C1_9_13;
  const T t190 = T(1.84) * (d2_3 * t189 - d2_1 * t73);
  A[97] = -t190;
  A[1801] = -t190;
  const T t191 = T(0.362) * C1_9_12 - T(0.49) * C1_9_11;
  const T t192 = T(1.84) * (d2_1 * t77 - d2_3 * t191);
  A[98] = -t192;
  A[1873] = -t192;
  const T t193 = T(0.426) * C1_10_12 + T(0.148) * C1_10_13;
  const T t194 = T(2.57) * (d8_1 * t80 - d8_3 * t193);
  A[99] = -t194;
  A[1945] = -t194;
  const T t195 = T(0.426) * C1_10_11 + T(0.016) * C1_10_13;
  const T t196 = T(2.57) * (d8_3 * t195 - d8_1 * t82);
  A[100] = -t196;
  A[2017] = -t196;
  const T t197 = T(0.016) * C1_10_12 - T(0.148) * C1_10_11;
  const T t198 = T(2.57) * (d8_1 * t86 - d8_3 * t197);
  A[101] = -t198;
  A[2089] = -t198;
  const T t199 = h11_2 * C1_11_13 - h11_3 * C1_11_12;
  const T t200 = d2_1 * t89 - d2_3 * t199;
  A[102] = -t200;
  A[2161] = -t200;
  const T t201 = h11_3 * C1_11_11 - h11_1 * C1_11_13;
  const T t202 = d2_1 * t92 - d2_3 * t201;
  A[103] = -t202;
  A[2233] = -t202;
  const T t203 = h11_1 * C1_11_12 - h11_2 * C1_11_11;
  const T t204 = d2_1 * t95 - d2_3 * t203;
  A[104] = -t204;
  A[2305] = -t204;
  const T t205 = T(0.1) * C1_12_12 - T(0.141) * C1_12_13;
  const T t206 = T(4.06) * (d2_1 * t98 - d2_3 * t205);
  A[105] = -t206;
  A[2377] = -t206;
  const T t207 = T(0.006) * C1_12_13 - T(0.1) * C1_12_11;
  const T t208 = T(4.06) * (d2_1 * t101 - d2_3 * t207);
  A[106] = -t208;
  A[2449] = -t208;
  const T t209 = T(0.141) * C1_12_11 - T(0.006) * C1_12_12;
  const T t210 = T(4.06) * (d2_1 * t104 - d2_3 * t209);
  A[107] = -t210;
  A[2521] = -t210;
  const T t211 = h1_3 * R1_11 - h1_1 * R1_31;
  A[108] = t211;
  A[2593] = t211;
  const T t212 = h1_3 * R1_12 - h1_1 * R1_32;
  A[109] = t212;
  A[2665] = t212;
  const T t213 = h1_3 * R1_13 - h1_1 * R1_33;
  A[110] = t213;
  A[2737] = t213;
  A[113] = -b1_2;
  A[184] = b1_2;
  A[2882] = b1_2;
  A[2953] = -b1_2;
  const T t214 = d2_3 * C1_2_11 - d2_1 * C1_2_31;
  const T t215 = T(17.16) * t214;
  A[114] = t215;
  A[3025] = t215;
  const T t216 = d2_3 * C1_2_12 - d2_1 * C1_2_32;
  const T t217 = T(17.16) * t216;
  A[115] = t217;
  A[3097] = t217;
  const T t218 = d2_3 * C1_2_13 - d2_1 * C1_2_33;
  const T t219 = T(17.16) * t218;
  A[116] = t219;
  A[3169] = t219;
  const T t220 = d2_3 * C1_3_11 - d2_1 * C1_3_31;
  const T t221 = T(5.23) * t220;
  A[117] = t221;
  A[3241] = t221;
  const T t222 = d2_3 * C1_3_12 - d2_1 * C1_3_32;
  const T t223 = T(5.23) * t222;
  A[118] = t223;
  A[3313] = t223;
  const T t224 = d2_3 * C1_3_13 - d2_1 * C1_3_33;
  const T t225 = T(5.23) * t224;
  A[119] = t225;
  A[3385] = t225;
  const T t226 = T(9.79) * t220;
  A[120] = t226;
  A[3457] = t226;
  const T t227 = T(9.79) * t222;
  A[121] = t227;
  A[3529] = t227;
  const T t228 = T(9.79) * t224;
  A[122] = t228;
  A[3601] = t228;
  const T t229 = T(5.32) * t214;
  A[123] = t229;
  A[3673] = t229;
  const T t230 = T(5.32) * t216;
  A[124] = t230;
  A[3745] = t230;
  const T t231 = T(5.32) * t218;
  A[125] = t231;
  A[3817] = t231;
  const T t232 = T(0.74) * (d2_3 * C1_4_11 - d2_1 * C1_4_31);
  A[126] = t232;
  A[3889] = t232;
  const T t233 = T(0.74) * (d2_3 * C1_4_12 - d2_1 * C1_4_32);
  A[127] = t233;
  A[3961] = t233;
  const T t234 = T(0.74) * (d2_3 * C1_4_13 - d2_1 * C1_4_33);
  A[128] = t234;
  A[4033] = t234;
  A[131] = -b1_1;
  A[202] = b1_1;
  A[4178] = b1_1;
  A[4249] = -b1_1;
  const T t235 = T(1.84) * (d2_3 * C1_6_11 - d2_1 * C1_6_31);
  A[132] = t235;
  A[4321] = t235;
  const T t236 = T(1.84) * (d2_3 * C1_6_12 - d2_1 * C1_6_32);
  A[133] = t236;
  A[4393] = t236;
  const T t237 = T(1.84) * (d2_3 * C1_6_13 - d2_1 * C1_6_33);
  A[134] = t237;
  A[4465] = t237;
  const T t238 = T(2.57) * (d8_3 * C1_8_11 - d8_1 * C1_8_31);
  A[135] = t238;
  A[4537] = t238;
  const T t239 = T(2.57) * (d8_3 * C1_8_12 - d8_1 * C1_8_32);
  A[136] = t239;
  A[4609] = t239;
  const T t240 = T(2.57) * (d8_3 * C1_8_13 - d8_1 * C1_8_33);
  A[137] = t240;
  A[4681] = t240;
  const T t241 = T(7.83) * (d2_3 * C1_5_11 - d2_1 * C1_5_31);
  A[138] = t241;
  A[4753] = t241;
  const T t242 = T(7.83) * (d2_3 * C1_5_12 - d2_1 * C1_5_32);
  A[139] = t242;
  A[4825] = t242;
  const T t243 = T(7.83) * (d2_3 * C1_5_13 - d2_1 * C1_5_33);
  A[140] = t243;
  A[4897] = t243;
  const T t244 = T(4.06) * (d2_3 * C1_11_11 - d2_1 * C1_11_31);
  A[141] = t244;
  A[4969] = t244;
  const T t245 = T(4.06) * (d2_3 * C1_11_12 - d2_1 * C1_11_32);
  A[142] = t245;
  A[5041] = t245;
  const T t246 = T(4.06) * (d2_3 * C1_11_13 - d2_1 * C1_11_33);
  A[143] = t246;
  A[5113] = t246;
  A[146] = T(0.7378827) + T(5.279999999999999) * (t2 + t142) + T(23.12) * (t4 + t143);
  const T t247 = d2_2 * t145 - d2_1 * t7;
  A[147] = -t247;
  A[218] = -t247;
  const T t248 = d2_2 * t147 - d2_1 * t10;
  A[148] = -t248;
  A[290] = -t248;
  const T t249 = d2_2 * t149 - d2_1 * t13;
  A[149] = -t249;
  A[362] = -t249;
  const T t250 = d2_2 * t151 - d2_1 * t16;
  A[150] = -t250;
  A[434] = -t250;
  const T t251 = d2_2 * t153 - d2_1 * t19;
  A[151] = -t251;
  A[506] = -t251;
  const T t252 = d2_2 * t155 - d2_1 * t22;
  A[152] = -t252;
  A[578] = -t252;
  const T t253 = d2_2 * t157 - d2_1 * t25;
  A[153] = -t253;
  A[650] = -t253;
  const T t254 = d2_2 * t159 - d2_1 * t28;
  A[154] = -t254;
  A[722] = -t254;
  const T t255 = d2_2 * t161 - d2_1 * t31;
  A[155] = -t255;
  A[794] = -t255;
  const T t256 = d2_2 * t163 - d2_1 * t34;
  A[156] = -t256;
  A[866] = -t256;
  const T t257 = d2_2 * t165 - d2_1 * t37;
  A[157] = -t257;
  A[938] = -t257;
  const T t258 = d2_2 * t167 - d2_1 * t40;
  A[158] = -t258;
  A[1010] = -t258;
  const T t259 = d2_2 * t169 - d2_1 * t43;
  A[159] = -t259;
  A[1082] = -t259;
  const T t260 = d2_2 * t171 - d2_1 * t46;
  A[160] = -t260;
  A[1154] = -t260;
  const T t261 = d2_2 * t173 - d2_1 * t49;
  A[161] = -t261;
  A[1226] = -t261;
  const T t262 = T(0.74) * (d2_2 * t175 - d2_1 * t52);
  A[162] = -t262;
  A[1298] = -t262;
  const T t263 = T(0.74) * (d2_2 * t177 - d2_1 * t55);
  A[163] = -t263;
  A[1370] = -t263;
  const T t264 = T(0.74) * (d2_2 * t179 - d2_1 * t58);
  A[164] = -t264;
  A[1442] = -t264;
  const T t265 = d8_2 * t181 - d8_1 * t61;
  A[165] = -t265;
  A[1514] = -t265;
  const T t266 = d8_2 * t183 - d8_1 * t64;
  A[166] = -t266;
  A[1586] = -t266;
  const T t267 = d8_2 * t185 - d8_1 * t67;
  A[167] = -t267;
  A[1658] = -t267;
  const T t268 = T(1.84) * (d2_2 * t187 - d2_1 * t70);
  A[168] = -t268;
  A[1730] = -t268;
  const T t269 = T(1.84) * (d2_1 * t74 - d2_2 * t189);
  A[169] = -t269;
  A[1802] = -t269;
  const T t270 = T(1.84) * (d2_2 * t191 - d2_1 * t76);
  A[170] = -t270;
  A[1874] = -t270;
  const T t271 = T(2.57) * (d8_2 * t193 - d8_1 * t79);
  A[171] = -t271;
  A[1946] = -t271;
  const T t272 = T(2.57) * (d8_1 * t83 - d8_2 * t195);
  A[172] = -t272;
  A[2018] = -t272;
  const T t273 = T(2.57) * (d8_2 * t197 - d8_1 * t85);
  A[173] = -t273;
  A[2090] = -t273;
  const T t274 = d2_2 * t199 - d2_1 * t88;
  A[174] = -t274;
  A[2162] = -t274;
  const T t275 = d2_2 * t201 - d2_1 * t91;
  A[175] = -t275;
  A[2234] = -t275;
  const T t276 = d2_2 * t203 - d2_1 * t94;
  A[176] = -t276;
  A[2306] = -t276;
  const T t277 = T(4.06) * (d2_2 * t205 - d2_1 * t97);
  A[177] = -t277;
  A[2378] = -t277;
  const T t278 = T(4.06) * (d2_2 * t207 - d2_1 * t100);
  A[178] = -t278;
  A[2450] = -t278;
  const T t279 = T(4.06) * (d2_2 * t209 - d2_1 * t103);
  A[179] = -t279;
  A[2522] = -t279;
  const T t280 = h1_1 * R1_21 - h1_2 * R1_11;
  A[180] = t280;
  A[2594] = t280;
  const T t281 = h1_1 * R1_22 - h1_2 * R1_12;
  A[181] = t281;
  A[2666] = t281;
  const T t282 = h1_1 * R1_23 - h1_2 * R1_13;
  A[182] = t282;
  A[2738] = t282;
  const T t283 = d2_1 * C1_2_21 - d2_2 * C1_2_11;
  const T t284 = T(17.16) * t283;
  A[186] = t284;
  A[3026] = t284;
  const T t285 = d2_1 * C1_2_22 - d2_2 * C1_2_12;
  const T t286 = T(17.16) * t285;
  A[187] = t286;
  A[3098] = t286;
  const T t287 = d2_1 * C1_2_23 - d2_2 * C1_2_13;
  const T t288 = T(17.16) * t287;
  A[188] = t288;
  A[3170] = t288;
  const T t289 = d2_1 * C1_3_21 - d2_2 * C1_3_11;
  const T t290 = T(5.23) * t289;
  A[189] = t290;
  A[3242] = t290;
  const T t291 = d2_1 * C1_3_22 - d2_2 * C1_3_12;
  const T t292 = T(5.23) * t291;
  A[190] = t292;
  A[3314] = t292;
  const T t293 = d2_1 * C1_3_23 - d2_2 * C1_3_13;
  const T t294 = T(5.23) * t293;
  A[191] = t294;
  A[3386] = t294;
  const T t295 = T(9.79) * t289;
  A[192] = t295;
  A[3458] = t295;
  const T t296 = T(9.79) * t291;
  A[193] = t296;
  A[3530] = t296;
  const T t297 = T(9.79) * t293;
  A[194] = t297;
  A[3602] = t297;
  const T t298 = T(5.32) * t283;
  A[195] = t298;
  A[3674] = t298;
  const T t299 = T(5.32) * t285;
  A[196] = t299;
  A[3746] = t299;
  const T t300 = T(5.32) * t287;
  A[197] = t300;
  A[3818] = t300;
  const T t301 = T(0.74) * (d2_1 * C1_4_21 - d2_2 * C1_4_11);
  A[198] = t301;
  A[3890] = t301;
  const T t302 = T(0.74) * (d2_1 * C1_4_22 - d2_2 * C1_4_12);
  A[199] = t302;
  A[3962] = t302;
  const T t303 = T(0.74) * (d2_1 * C1_4_23 - d2_2 * C1_4_13);
  A[200] = t303;
  A[4034] = t303;
  const T t304 = T(1.84) * (d2_1 * C1_6_21 - d2_2 * C1_6_11);
  A[204] = t304;
  A[4322] = t304;
  const T t305 = T(1.84) * (d2_1 * C1_6_22 - d2_2 * C1_6_12);
  A[205] = t305;
  A[4394] = t305;
  const T t306 = T(1.84) * (d2_1 * C1_6_23 - d2_2 * C1_6_13);
  A[206] = t306;
  A[4466] = t306;
  const T t307 = T(2.57) * (d8_1 * C1_8_21 - d8_2 * C1_8_11);
  A[207] = t307;
  A[4538] = t307;
  const T t308 = T(2.57) * (d8_1 * C1_8_22 - d8_2 * C1_8_12);
  A[208] = t308;
  A[4610] = t308;
  const T t309 = T(2.57) * (d8_1 * C1_8_23 - d8_2 * C1_8_13);
  A[209] = t309;
  A[4682] = t309;
  const T t310 = T(7.83) * (d2_1 * C1_5_21 - d2_2 * C1_5_11);
  A[210] = t310;
  A[4754] = t310;
  const T t311 = T(7.83) * (d2_1 * C1_5_22 - d2_2 * C1_5_12);
  A[211] = t311;
  A[4826] = t311;
  const T t312 = T(7.83) * (d2_1 * C1_5_23 - d2_2 * C1_5_13);
  A[212] = t312;
  A[4898] = t312;
  const T t313 = T(4.06) * (d2_1 * C1_11_21 - d2_2 * C1_11_11);
  A[213] = t313;
  A[4970] = t313;
  const T t314 = T(4.06) * (d2_1 * C1_11_22 - d2_2 * C1_11_12);
  A[214] = t314;
  A[5042] = t314;
  const T t315 = T(4.06) * (d2_1 * C1_11_23 - d2_2 * C1_11_13);
  A[215] = t315;
  A[5114] = t315;
  const T t316 = d6_3 * d6_3;
  const T t317 = d6_2 * d6_2;
  const T t318 = d3_3 * d3_3;
  const T t319 = d3_2 * d3_2;
  A[219] = T(0.181004) + T(5.32) * (t316 + t317) + T(17.16) * (t318 + t319);
  const T t320 = T(0.0020824) + d6_2 * d6_1 * T(5.32) + d3_2 * d3_1 * T(17.16);
  A[220] = -t320;
  A[291] = -t320;
  const T t321 = T(0.0037) - d6_3 * d6_1 * T(5.32) - d3_3 * d3_1 * T(17.16);
  A[221] = t321;
  A[363] = t321;
  const T t322 = h3_2 * C2_3_23 - h3_3 * C2_3_22;
  const T t323 = h3_2 * C2_3_33 - h3_3 * C2_3_32;
  const T t324 = d3_3 * t322 - d3_2 * t323;
  A[222] = -t324;
  A[435] = -t324;
  const T t325 = h3_3 * C2_3_21 - h3_1 * C2_3_23;
  const T t326 = h3_3 * C2_3_31 - h3_1 * C2_3_33;
  const T t327 = d3_3 * t325 - d3_2 * t326;
  A[223] = -t327;
  A[507] = -t327;
  const T t328 = h3_1 * C2_3_22 - h3_2 * C2_3_21;
  const T t329 = h3_1 * C2_3_32 - h3_2 * C2_3_31;
  const T t330 = d3_3 * t328 - d3_2 * t329;
  A[224] = -t330;
  A[579] = -t330;
  const T t331 = h4_2 * C2_4_23 - h4_3 * C2_4_22;
  const T t332 = h4_2 * C2_4_33 - h4_3 * C2_4_32;
  const T t333 = d3_3 * t331 - d3_2 * t332;
  A[225] = -t333;
  A[651] = -t333;
  const T t334 = h4_3 * C2_4_21 - h4_1 * C2_4_23;
  const T t335 = h4_3 * C2_4_31 - h4_1 * C2_4_33;
  const T t336 = d3_3 * t334 - d3_2 * t335;
  A[226] = -t336;
  A[723] = -t336;
  const T t337 = h4_1 * C2_4_22 - h4_2 * C2_4_21;
  const T t338 = h4_1 * C2_4_32 - h4_2 * C2_4_31;
  const T t339 = d3_3 * t337 - d3_2 * t338;
  A[227] = -t339;
  A[795] = -t339;
  const T t340 = h5_2 * C2_5_23 - h5_3 * C2_5_22;
  const T t341 = h5_2 * C2_5_33 - h5_3 * C2_5_32;
  const T t342 = d3_3 * t340 - d3_2 * t341;
  A[228] = -t342;
  A[867] = -t342;
  const T t343 = h5_3 * C2_5_21 - h5_1 * C2_5_23;
  const T t344 = h5_3 * C2_5_31 - h5_1 * C2_5_33;
  const T t345 = d3_3 * t343 - d3_2 * t344;
  A[229] = -t345;
  A[939] = -t345;
  const T t346 = h5_1 * C2_5_22 - h5_2 * C2_5_21;
  const T t347 = h5_1 * C2_5_32 - h5_2 * C2_5_31;
  const T t348 = d3_3 * t346 - d3_2 * t347;
  A[230] = -t348;
  A[1011] = -t348;
  const T t349 = h6_2 * C2_6_23 - h6_3 * C2_6_22;
  const T t350 = h6_2 * C2_6_33 - h6_3 * C2_6_32;
  const T t351 = d6_3 * t349 - d6_2 * t350;
  A[231] = -t351;
  A[1083] = -t351;
  const T t352 = h6_3 * C2_6_21 - h6_1 * C2_6_23;
  const T t353 = h6_3 * C2_6_31 - h6_1 * C2_6_33;
  const T t354 = d6_3 * t352 - d6_2 * t353;
  A[232] = -t354;
  A[1155] = -t354;
  const T t355 = h6_1 * C2_6_22 - h6_2 * C2_6_21;
  const T t356 = h6_1 * C2_6_32 - h6_2 * C2_6_31;
  const T t357 = d6_3 * t355 - d6_2 * t356;
  A[233] = -t357;
  A[1227] = -t357;
  const T t358 = T(0.487) * C2_7_22 - T(0.192) * C2_7_23;
  const T t359 = T(0.487) * C2_7_32 - T(0.192) * C2_7_33;
  const T t360 = T(0.74) * (d3_3 * t358 - d3_2 * t359);
  A[234] = -t360;
  A[1299] = -t360;
  const T t361 = T(0.475) * C2_7_23 - T(0.487) * C2_7_21;
  const T t362 = T(0.475) * C2_7_33 - T(0.487) * C2_7_31;
  const T t363 = T(0.74) * (d3_3 * t361 - d3_2 * t362);
  A[235] = -t363;
  A[1371] = -t363;
  const T t364 = T(0.192) * C2_7_21 - T(0.475) * C2_7_22;
  const T t365 = T(0.192) * C2_7_31 - T(0.475) * C2_7_32;
  const T t366 = T(0.74) * (d3_3 * t364 - d3_2 * t365);
  A[236] = -t366;
  A[1443] = -t366;
  const T t367 = T(0.015) * C2_9_22 + T(0.49) * C2_9_23;
  const T t368 = T(0.015) * C2_9_32 + T(0.49) * C2_9_33;
  const T t369 = T(1.84) * (d6_3 * t367 - d6_2 * t368);
  A[240] = -t369;
  A[1731] = -t369;
  const T t370 = T(0.015) * C2_9_31 + T(0.362) * C2_9_33;
  const T t371 = T(0.015) * C2_9_21 + T(0.362) * C2_9_23;
  const T t372 = T(1.84) * (d6_2 * t370 - d6_3 * t371);
  A[241] = -t372;
  A[1803] = -t372;
  const T t373 = T(0.362) * C2_9_22 - T(0.49) * C2_9_21;
  const T t374 = T(0.362) * C2_9_32 - T(0.49) * C2_9_31;
  const T t375 = T(1.84) * (d6_3 * t373 - d6_2 * t374);
  A[242] = -t375;
  A[1875] = -t375;
  const T t376 = h11_2 * C2_11_23 - h11_3 * C2_11_22;
  const T t377 = h11_2 * C2_11_33 - h11_3 * C2_11_32;
  const T t378 = d3_3 * t376 - d3_2 * t377;
  A[246] = -t378;
  A[2163] = -t378;
  const T t379 = h11_3 * C2_11_21 - h11_1 * C2_11_23;
  const T t380 = h11_3 * C2_11_31 - h11_1 * C2_11_33;
  const T t381 = d3_3 * t379 - d3_2 * t380;
  A[247] = -t381;
  A[2235] = -t381;
  const T t382 = h11_1 * C2_11_22 - h11_2 * C2_11_21;
  const T t383 = h11_1 * C2_11_32 - h11_2 * C2_11_31;
  const T t384 = d3_3 * t382 - d3_2 * t383;
  A[248] = -t384;
  A[2307] = -t384;
  const T t385 = T(0.1) * C2_12_22 - T(0.141) * C2_12_23;
  const T t386 = T(0.1) * C2_12_32 - T(0.141) * C2_12_33;
  const T t387 = T(4.06) * (d3_3 * t385 - d3_2 * t386);
  A[249] = -t387;
  A[2379] = -t387;
  const T t388 = T(0.006) * C2_12_23 - T(0.1) * C2_12_21;
  const T t389 = T(0.006) * C2_12_33 - T(0.1) * C2_12_31;
  const T t390 = T(4.06) * (d3_3 * t388 - d3_2 * t389);
  A[250] = -t390;
  A[2451] = -t390;
  const T t391 = T(0.141) * C2_12_21 - T(0.006) * C2_12_22;
  const T t392 = T(0.141) * C2_12_31 - T(0.006) * C2_12_32;
  const T t393 = T(4.06) * (d3_3 * t391 - d3_2 * t392);
  A[251] = -t393;
  A[2523] = -t393;
  const T t394 = h2_2 * R2_31 - h2_3 * R2_21;
  A[252] = t394;
  A[2595] = t394;
  const T t395 = h2_2 * R2_32 - h2_3 * R2_22;
  A[253] = t395;
  A[2667] = t395;
  const T t396 = h2_2 * R2_33 - h2_3 * R2_23;
  A[254] = t396;
  A[2739] = t396;
  A[255] = t145;
  A[2811] = t145;
  A[256] = t7;
  A[2883] = t7;
  A[257] = t8;
  A[2955] = t8;
  A[259] = -b2_6;
  A[330] = b2_6;
  A[3028] = b2_6;
  A[3099] = -b2_6;
  A[260] = b2_4;
  A[402] = -b2_4;
  A[3029] = -b2_4;
  A[3171] = b2_4;
  const T t397 = d3_2 * C2_3_31 - d3_3 * C2_3_21;
  const T t398 = T(5.23) * t397;
  A[261] = t398;
  A[3243] = t398;
  const T t399 = d3_2 * C2_3_32 - d3_3 * C2_3_22;
  const T t400 = T(5.23) * t399;
  A[262] = t400;
  A[3315] = t400;
  const T t401 = d3_2 * C2_3_33 - d3_3 * C2_3_23;
  const T t402 = T(5.23) * t401;
  A[263] = t402;
  A[3387] = t402;
  const T t403 = T(9.79) * t397;
  A[264] = t403;
  A[3459] = t403;
  const T t404 = T(9.79) * t399;
  A[265] = t404;
  A[3531] = t404;
  const T t405 = T(9.79) * t401;
  A[266] = t405;
  A[3603] = t405;
  A[268] = -b2_5;
  A[339] = b2_5;
  A[3676] = b2_5;
  A[3747] = -b2_5;
  A[269] = b2_3;
  A[411] = -b2_3;
  A[3677] = -b2_3;
  A[3819] = b2_3;
  const T t406 = T(0.74) * (d3_2 * C2_4_31 - d3_3 * C2_4_21);
  A[270] = t406;
  A[3891] = t406;
  const T t407 = T(0.74) * (d3_2 * C2_4_32 - d3_3 * C2_4_22);
  A[271] = t407;
  A[3963] = t407;
  const T t408 = T(0.74) * (d3_2 * C2_4_33 - d3_3 * C2_4_23);
  A[272] = t408;
  A[4035] = t408;
  const T t409 = T(1.84) * (d6_2 * C2_6_31 - d6_3 * C2_6_21);
  A[276] = t409;
  A[4323] = t409;
  const T t410 = T(1.84) * (d6_2 * C2_6_32 - d6_3 * C2_6_22);
  A[277] = t410;
  A[4395] = t410;
  const T t411 = T(1.84) * (d6_2 * C2_6_33 - d6_3 * C2_6_23);
  A[278] = t411;
  A[4467] = t411;
  const T t412 = T(7.83) * (d3_2 * C2_5_31 - d3_3 * C2_5_21);
  A[282] = t412;
  A[4755] = t412;
  const T t413 = T(7.83) * (d3_2 * C2_5_32 - d3_3 * C2_5_22);
  A[283] = t413;
  A[4827] = t413;
  const T t414 = T(7.83) * (d3_2 * C2_5_33 - d3_3 * C2_5_23);
  A[284] = t414;
  A[4899] = t414;
  const T t415 = T(4.06) * (d3_2 * C2_11_31 - d3_3 * C2_11_21);
  A[285] = t415;
  A[4971] = t415;
  const T t416 = T(4.06) * (d3_2 * C2_11_32 - d3_3 * C2_11_22);
  A[286] = t416;
  A[5043] = t416;
  const T t417 = T(4.06) * (d3_2 * C2_11_33 - d3_3 * C2_11_23);
  A[287] = t417;
  A[5115] = t417;
  const T t418 = d6_1 * d6_1;
  const T t419 = d3_1 * d3_1;
  A[292] = T(0.11997744) + T(5.32) * (t316 + t418) + T(17.16) * (t318 + t419);
  const T t420 = T(0.0049) - d6_3 * d6_2 * T(5.32) - d3_3 * d3_2 * T(17.16);
  A[293] = t420;
  A[364] = t420;
  const T t421 = h3_2 * C2_3_13 - h3_3 * C2_3_12;
  const T t422 = d3_1 * t323 - d3_3 * t421;
  A[294] = -t422;
  A[436] = -t422;
  const T t423 = h3_3 * C2_3_11 - h3_1 * C2_3_13;
  const T t424 = d3_1 * t326 - d3_3 * t423;
  A[295] = -t424;
  A[508] = -t424;
  const T t425 = h3_1 * C2_3_12 - h3_2 * C2_3_11;
  const T t426 = d3_1 * t329 - d3_3 * t425;
  A[296] = -t426;
  A[580] = -t426;
  const T t427 = h4_2 * C2_4_13 - h4_3 * C2_4_12;
  const T t428 = d3_1 * t332 - d3_3 * t427;
  A[297] = -t428;
  A[652] = -t428;
  const T t429 = h4_3 * C2_4_11 - h4_1 * C2_4_13;
  const T t430 = d3_1 * t335 - d3_3 * t429;
  A[298] = -t430;
  A[724] = -t430;
  const T t431 = h4_1 * C2_4_12 - h4_2 * C2_4_11;
  const T t432 = d3_1 * t338 - d3_3 * t431;
  A[299] = -t432;
  A[796] = -t432;
  const T t433 = h5_2 * C2_5_13 - h5_3 * C2_5_12;
  const T t434 = d3_1 * t341 - d3_3 * t433;
  A[300] = -t434;
  A[868] = -t434;
  const T t435 = h5_3 * C2_5_11 - h5_1 * C2_5_13;
  const T t436 = d3_1 * t344 - d3_3 * t435;
  A[301] = -t436;
  A[940] = -t436;
  const T t437 = h5_1 * C2_5_12 - h5_2 * C2_5_11;
  const T t438 = d3_1 * t347 - d3_3 * t437;
  A[302] = -t438;
  A[1012] = -t438;
  const T t439 = h6_2 * C2_6_13 - h6_3 * C2_6_12;
  const T t440 = d6_1 * t350 - d6_3 * t439;
  A[303] = -t440;
  A[1084] = -t440;
  const T t441 = h6_3 * C2_6_11 - h6_1 * C2_6_13;
  const T t442 = d6_1 * t353 - d6_3 * t441;
  A[304] = -t442;
  A[1156] = -t442;
  const T t443 = h6_1 * C2_6_12 - h6_2 * C2_6_11;
  const T t444 = d6_1 * t356 - d6_3 * t443;
  A[305] = -t444;
  A[1228] = -t444;
  const T t445 = T(0.487) * C2_7_12 - T(0.192) * C2_7_13;
  const T t446 = T(0.74) * (d3_1 * t359 - d3_3 * t445);
  A[306] = -t446;
  A[1300] = -t446;
  const T t447 = T(0.475) * C2_7_13 - T(0.487) * C2_7_11;
  const T t448 = T(0.74) * (d3_1 * t362 - d3_3 * t447);
  A[307] = -t448;
  A[1372] = -t448;
  const T t449 = T(0.192) * C2_7_11 - T(0.475) * C2_7_12;
  const T t450 = T(0.74) * (d3_1 * t365 - d3_3 * t449);
  A[308] = -t450;
  A[1444] = -t450;
  const T t451 = T(0.015) * C2_9_12 + T(0.49) * C2_9_13;
  const T t452 = T(1.84) * (d6_1 * t368 - d6_3 * t451);
  A[312] = -t452;
  A[1732] = -t452;
  const T t453 = T(0.015) * C2_9_11 + T(0.362) * C2_9_13;
  const T t454 = T(1.84) * (d6_3 * t453 - d6_1 * t370);
  A[313] = -t454;
  A[1804] = -t454;
  const T t455 = T(0.362) * C2_9_12 - T(0.49) * C2_9_11;
  const T t456 = T(1.84) * (d6_1 * t374 - d6_3 * t455);
  A[314] = -t456;
  A[1876] = -t456;
  const T t457 = h11_2 * C2_11_13 - h11_3 * C2_11_12;
  const T t458 = d3_1 * t377 - d3_3 * t457;
  A[318] = -t458;
  A[2164] = -t458;
  const T t459 = h11_3 * C2_11_11 - h11_1 * C2_11_13;
  const T t460 = d3_1 * t380 - d3_3 * t459;
  A[319] = -t460;
  A[2236] = -t460;
  const T t461 = h11_1 * C2_11_12 - h11_2 * C2_11_11;
  const T t462 = d3_1 * t383 - d3_3 * t461;
  A[320] = -t462;
  A[2308] = -t462;
  const T t463 = T(0.1) * C2_12_12 - T(0.141) * C2_12_13;
  const T t464 = T(4.06) * (d3_1 * t386 - d3_3 * t463);
  A[321] = -t464;
  A[2380] = -t464;
  const T t465 = T(0.006) * C2_12_13 - T(0.1) * C2_12_11;
  const T t466 = T(4.06) * (d3_1 * t389 - d3_3 * t465);
  A[322] = -t466;
  A[2452] = -t466;
  const T t467 = T(0.141) * C2_12_11 - T(0.006) * C2_12_12;
  const T t468 = T(4.06) * (d3_1 * t392 - d3_3 * t467);
  A[323] = -t468;
  A[2524] = -t468;
  const T t469 = h2_3 * R2_11 - h2_1 * R2_31;
  A[324] = t469;
  A[2596] = t469;
  const T t470 = h2_3 * R2_12 - h2_1 * R2_32;
  A[325] = t470;
  A[2668] = t470;
  const T t471 = h2_3 * R2_13 - h2_1 * R2_33;
  A[326] = t471;
  A[2740] = t471;
  A[327] = t147;
  A[2812] = t147;
  A[328] = t10;
  A[2884] = t10;
  A[329] = t11;
  A[2956] = t11;
  A[332] = -b2_2;
  A[403] = b2_2;
  A[3101] = b2_2;
  A[3172] = -b2_2;
  const T t472 = d3_3 * C2_3_11 - d3_1 * C2_3_31;
  const T t473 = T(5.23) * t472;
  A[333] = t473;
  A[3244] = t473;
  const T t474 = d3_3 * C2_3_12 - d3_1 * C2_3_32;
  const T t475 = T(5.23) * t474;
  A[334] = t475;
  A[3316] = t475;
  const T t476 = d3_3 * C2_3_13 - d3_1 * C2_3_33;
  const T t477 = T(5.23) * t476;
  A[335] = t477;
  A[3388] = t477;
  const T t478 = T(9.79) * t472;
  A[336] = t478;
  A[3460] = t478;
  const T t479 = T(9.79) * t474;
  A[337] = t479;
  A[3532] = t479;
  const T t480 = T(9.79) * t476;
  A[338] = t480;
  A[3604] = t480;
  A[341] = -b2_1;
  A[412] = b2_1;
  A[3749] = b2_1;
  A[3820] = -b2_1;
  const T t481 = T(0.74) * (d3_3 * C2_4_11 - d3_1 * C2_4_31);
  A[342] = t481;
  A[3892] = t481;
  const T t482 = T(0.74) * (d3_3 * C2_4_12 - d3_1 * C2_4_32);
  A[343] = t482;
  A[3964] = t482;
  const T t483 = T(0.74) * (d3_3 * C2_4_13 - d3_1 * C2_4_33);
  A[344] = t483;
  A[4036] = t483;
  const T t484 = T(1.84) * (d6_3 * C2_6_11 - d6_1 * C2_6_31);
  A[348] = t484;
  A[4324] = t484;
  const T t485 = T(1.84) * (d6_3 * C2_6_12 - d6_1 * C2_6_32);
  A[349] = t485;
  A[4396] = t485;
  const T t486 = T(1.84) * (d6_3 * C2_6_13 - d6_1 * C2_6_33);
  A[350] = t486;
  A[4468] = t486;
  const T t487 = T(7.83) * (d3_3 * C2_5_11 - d3_1 * C2_5_31);
  A[354] = t487;
  A[4756] = t487;
  const T t488 = T(7.83) * (d3_3 * C2_5_12 - d3_1 * C2_5_32);
  A[355] = t488;
  A[4828] = t488;
  const T t489 = T(7.83) * (d3_3 * C2_5_13 - d3_1 * C2_5_33);
  A[356] = t489;
  A[4900] = t489;
  const T t490 = T(4.06) * (d3_3 * C2_11_11 - d3_1 * C2_11_31);
  A[357] = t490;
  A[4972] = t490;
  const T t491 = T(4.06) * (d3_3 * C2_11_12 - d3_1 * C2_11_32);
  A[358] = t491;
  A[5044] = t491;
  const T t492 = T(4.06) * (d3_3 * C2_11_13 - d3_1 * C2_11_33);
  A[359] = t492;
  A[5116] = t492;
  A[365] = T(0.20668144) + T(5.32) * (t317 + t418) + T(17.16) * (t319 + t419);
  const T t493 = d3_2 * t421 - d3_1 * t322;
  A[366] = -t493;
  A[437] = -t493;
  const T t494 = d3_2 * t423 - d3_1 * t325;
  A[367] = -t494;
  A[509] = -t494;
  const T t495 = d3_2 * t425 - d3_1 * t328;
  A[368] = -t495;
  A[581] = -t495;
  const T t496 = d3_2 * t427 - d3_1 * t331;
  A[369] = -t496;
  A[653] = -t496;
  const T t497 = d3_2 * t429 - d3_1 * t334;
  A[370] = -t497;
  A[725] = -t497;
  const T t498 = d3_2 * t431 - d3_1 * t337;
  A[371] = -t498;
  A[797] = -t498;
  const T t499 = d3_2 * t433 - d3_1 * t340;
  A[372] = -t499;
  A[869] = -t499;
  const T t500 = d3_2 * t435 - d3_1 * t343;
  A[373] = -t500;
  A[941] = -t500;
  const T t501 = d3_2 * t437 - d3_1 * t346;
  A[374] = -t501;
  A[1013] = -t501;
  const T t502 = d6_2 * t439 - d6_1 * t349;
  A[375] = -t502;
  A[1085] = -t502;
  const T t503 = d6_2 * t441 - d6_1 * t352;
  A[376] = -t503;
  A[1157] = -t503;
  const T t504 = d6_2 * t443 - d6_1 * t355;
  A[377] = -t504;
  A[1229] = -t504;
  const T t505 = T(0.74) * (d3_2 * t445 - d3_1 * t358);
  A[378] = -t505;
  A[1301] = -t505;
  const T t506 = T(0.74) * (d3_2 * t447 - d3_1 * t361);
  A[379] = -t506;
  A[1373] = -t506;
  const T t507 = T(0.74) * (d3_2 * t449 - d3_1 * t364);
  A[380] = -t507;
  A[1445] = -t507;
  const T t508 = T(1.84) * (d6_2 * t451 - d6_1 * t367);
  A[384] = -t508;
  A[1733] = -t508;
  const T t509 = T(1.84) * (d6_1 * t371 - d6_2 * t453);
  A[385] = -t509;
  A[1805] = -t509;
  const T t510 = T(1.84) * (d6_2 * t455 - d6_1 * t373);
  A[386] = -t510;
  A[1877] = -t510;
  const T t511 = d3_2 * t457 - d3_1 * t376;
  A[390] = -t511;
  A[2165] = -t511;
  const T t512 = d3_2 * t459 - d3_1 * t379;
  A[391] = -t512;
  A[2237] = -t512;
  const T t513 = d3_2 * t461 - d3_1 * t382;
  A[392] = -t513;
  A[2309] = -t513;
  const T t514 = T(4.06) * (d3_2 * t463 - d3_1 * t385);
  A[393] = -t514;
  A[2381] = -t514;
  const T t515 = T(4.06) * (d3_2 * t465 - d3_1 * t388);
  A[394] = -t515;
  A[2453] = -t515;
  const T t516 = T(4.06) * (d3_2 * t467 - d3_1 * t391);
  A[395] = -t516;
  A[2525] = -t516;
  const T t517 = h2_1 * R2_21 - h2_2 * R2_11;
  A[396] = t517;
  A[2597] = t517;
  const T t518 = h2_1 * R2_22 - h2_2 * R2_12;
  A[397] = t518;
  A[2669] = t518;
  const T t519 = h2_1 * R2_23 - h2_2 * R2_13;
  A[398] = t519;
  A[2741] = t519;
  A[399] = t149;
  A[2813] = t149;
  A[400] = t13;
  A[2885] = t13;
  A[401] = t14;
  A[2957] = t14;
  const T t520 = d3_1 * C2_3_21 - d3_2 * C2_3_11;
  const T t521 = T(5.23) * t520;
  A[405] = t521;
  A[3245] = t521;
  const T t522 = d3_1 * C2_3_22 - d3_2 * C2_3_12;
  const T t523 = T(5.23) * t522;
  A[406] = t523;
  A[3317] = t523;
  const T t524 = d3_1 * C2_3_23 - d3_2 * C2_3_13;
  const T t525 = T(5.23) * t524;
  A[407] = t525;
  A[3389] = t525;
  const T t526 = T(9.79) * t520;
  A[408] = t526;
  A[3461] = t526;
  const T t527 = T(9.79) * t522;
  A[409] = t527;
  A[3533] = t527;
  const T t528 = T(9.79) * t524;
  A[410] = t528;
  A[3605] = t528;
  const T t529 = T(0.74) * (d3_1 * C2_4_21 - d3_2 * C2_4_11);
  A[414] = t529;
  A[3893] = t529;
  const T t530 = T(0.74) * (d3_1 * C2_4_22 - d3_2 * C2_4_12);
  A[415] = t530;
  A[3965] = t530;
  const T t531 = T(0.74) * (d3_1 * C2_4_23 - d3_2 * C2_4_13);
  A[416] = t531;
  A[4037] = t531;
  const T t532 = T(1.84) * (d6_1 * C2_6_21 - d6_2 * C2_6_11);
  A[420] = t532;
  A[4325] = t532;
  const T t533 = T(1.84) * (d6_1 * C2_6_22 - d6_2 * C2_6_12);
  A[421] = t533;
  A[4397] = t533;
  const T t534 = T(1.84) * (d6_1 * C2_6_23 - d6_2 * C2_6_13);
  A[422] = t534;
  A[4469] = t534;
  const T t535 = T(7.83) * (d3_1 * C2_5_21 - d3_2 * C2_5_11);
  A[426] = t535;
  A[4757] = t535;
  const T t536 = T(7.83) * (d3_1 * C2_5_22 - d3_2 * C2_5_12);
  A[427] = t536;
  A[4829] = t536;
  const T t537 = T(7.83) * (d3_1 * C2_5_23 - d3_2 * C2_5_13);
  A[428] = t537;
  A[4901] = t537;
  const T t538 = T(4.06) * (d3_1 * C2_11_21 - d3_2 * C2_11_11);
  A[429] = t538;
  A[4973] = t538;
  const T t539 = T(4.06) * (d3_1 * C2_11_22 - d3_2 * C2_11_12);
  A[430] = t539;
  A[5045] = t539;
  const T t540 = T(4.06) * (d3_1 * C2_11_23 - d3_2 * C2_11_13);
  A[431] = t540;
  A[5117] = t540;
  const T t541 = d5_3 * d5_3;
  const T t542 = d5_2 * d5_2;
  const T t543 = d4_3 * d4_3;
  const T t544 = d4_2 * d4_2;
  A[438] = T(0.8923628) + T(9.79) * (t541 + t542) + T(5.23) * (t543 + t544);
  const T t545 = T(0.47700848) + d5_2 * d5_1 * T(9.79) + d4_2 * d4_1 * T(5.23);
  A[439] = -t545;
  A[510] = -t545;
  const T t546 = T(0.03385696) - d5_3 * d5_1 * T(9.79) - d4_3 * d4_1 * T(5.23);
  A[440] = t546;
  A[582] = t546;
  const T t547 = h4_2 * C3_4_23 - h4_3 * C3_4_22;
  const T t548 = h4_2 * C3_4_33 - h4_3 * C3_4_32;
  const T t549 = d4_3 * t547 - d4_2 * t548;
  A[441] = -t549;
  A[654] = -t549;
  const T t550 = h4_3 * C3_4_21 - h4_1 * C3_4_23;
  const T t551 = h4_3 * C3_4_31 - h4_1 * C3_4_33;
  const T t552 = d4_3 * t550 - d4_2 * t551;
  A[442] = -t552;
  A[726] = -t552;
  const T t553 = h4_1 * C3_4_22 - h4_2 * C3_4_21;
  const T t554 = h4_1 * C3_4_32 - h4_2 * C3_4_31;
  const T t555 = d4_3 * t553 - d4_2 * t554;
  A[443] = -t555;
  A[798] = -t555;
  const T t556 = h5_2 * C3_5_23 - h5_3 * C3_5_22;
  const T t557 = h5_2 * C3_5_33 - h5_3 * C3_5_32;
  const T t558 = d5_3 * t556 - d5_2 * t557;
  A[444] = -t558;
  A[870] = -t558;
  const T t559 = h5_3 * C3_5_21 - h5_1 * C3_5_23;
  const T t560 = h5_3 * C3_5_31 - h5_1 * C3_5_33;
  const T t561 = d5_3 * t559 - d5_2 * t560;
  A[445] = -t561;
  A[942] = -t561;
  const T t562 = h5_1 * C3_5_22 - h5_2 * C3_5_21;
  const T t563 = h5_1 * C3_5_32 - h5_2 * C3_5_31;
  const T t564 = d5_3 * t562 - d5_2 * t563;
  A[446] = -t564;
  A[1014] = -t564;
  const T t565 = T(0.487) * C3_7_22 - T(0.192) * C3_7_23;
  const T t566 = T(0.487) * C3_7_32 - T(0.192) * C3_7_33;
  const T t567 = T(0.74) * (d4_3 * t565 - d4_2 * t566);
  A[450] = -t567;
  A[1302] = -t567;
  const T t568 = T(0.475) * C3_7_23 - T(0.487) * C3_7_21;
  const T t569 = T(0.475) * C3_7_33 - T(0.487) * C3_7_31;
  const T t570 = T(0.74) * (d4_3 * t568 - d4_2 * t569);
  A[451] = -t570;
  A[1374] = -t570;
  const T t571 = T(0.192) * C3_7_21 - T(0.475) * C3_7_22;
  const T t572 = T(0.192) * C3_7_31 - T(0.475) * C3_7_32;
  const T t573 = T(0.74) * (d4_3 * t571 - d4_2 * t572);
  A[452] = -t573;
  A[1446] = -t573;
  const T t574 = h11_2 * C3_11_23 - h11_3 * C3_11_22;
  const T t575 = h11_2 * C3_11_33 - h11_3 * C3_11_32;
  const T t576 = d5_3 * t574 - d5_2 * t575;
  A[462] = -t576;
  A[2166] = -t576;
  const T t577 = h11_3 * C3_11_21 - h11_1 * C3_11_23;
  const T t578 = h11_3 * C3_11_31 - h11_1 * C3_11_33;
  const T t579 = d5_3 * t577 - d5_2 * t578;
  A[463] = -t579;
  A[2238] = -t579;
  const T t580 = h11_1 * C3_11_22 - h11_2 * C3_11_21;
  const T t581 = h11_1 * C3_11_32 - h11_2 * C3_11_31;
  const T t582 = d5_3 * t580 - d5_2 * t581;
  A[464] = -t582;
  A[2310] = -t582;
  const T t583 = T(0.1) * C3_12_22 - T(0.141) * C3_12_23;
  const T t584 = T(0.1) * C3_12_32 - T(0.141) * C3_12_33;
  const T t585 = T(4.06) * (d5_3 * t583 - d5_2 * t584);
  A[465] = -t585;
  A[2382] = -t585;
  const T t586 = T(0.006) * C3_12_23 - T(0.1) * C3_12_21;
  const T t587 = T(0.006) * C3_12_33 - T(0.1) * C3_12_31;
  const T t588 = T(4.06) * (d5_3 * t586 - d5_2 * t587);
  A[466] = -t588;
  A[2454] = -t588;
  const T t589 = T(0.141) * C3_12_21 - T(0.006) * C3_12_22;
  const T t590 = T(0.141) * C3_12_31 - T(0.006) * C3_12_32;
  const T t591 = T(4.06) * (d5_3 * t589 - d5_2 * t590);
  A[467] = -t591;
  A[2526] = -t591;
  const T t592 = h3_2 * R3_31 - h3_3 * R3_21;
  A[468] = t592;
  A[2598] = t592;
  const T t593 = h3_2 * R3_32 - h3_3 * R3_22;
  A[469] = t593;
  A[2670] = t593;
  const T t594 = h3_2 * R3_33 - h3_3 * R3_23;
  A[470] = t594;
  A[2742] = t594;
  A[471] = t151;
  A[2814] = t151;
  A[472] = t16;
  A[2886] = t16;
  A[473] = t17;
  A[2958] = t17;
  A[474] = t421;
  A[3030] = t421;
  A[475] = t322;
  A[3102] = t322;
  A[476] = t323;
  A[3174] = t323;
  A[478] = -b3_6;
  A[549] = b3_6;
  A[3247] = b3_6;
  A[3318] = -b3_6;
  A[479] = b3_4;
  A[621] = -b3_4;
  A[3248] = -b3_4;
  A[3390] = b3_4;
  A[481] = -b3_5;
  A[552] = b3_5;
  A[3463] = b3_5;
  A[3534] = -b3_5;
  A[482] = b3_3;
  A[624] = -b3_3;
  A[3464] = -b3_3;
  A[3606] = b3_3;
  const T t595 = T(0.74) * (d4_2 * C3_4_31 - d4_3 * C3_4_21);
  A[486] = t595;
  A[3894] = t595;
  const T t596 = T(0.74) * (d4_2 * C3_4_32 - d4_3 * C3_4_22);
  A[487] = t596;
  A[3966] = t596;
  const T t597 = T(0.74) * (d4_2 * C3_4_33 - d4_3 * C3_4_23);
  A[488] = t597;
  A[4038] = t597;
  const T t598 = T(7.83) * (d5_2 * C3_5_31 - d5_3 * C3_5_21);
  A[498] = t598;
  A[4758] = t598;
  const T t599 = T(7.83) * (d5_2 * C3_5_32 - d5_3 * C3_5_22);
  A[499] = t599;
  A[4830] = t599;
  const T t600 = T(7.83) * (d5_2 * C3_5_33 - d5_3 * C3_5_23);
  A[500] = t600;
  A[4902] = t600;
  const T t601 = T(4.06) * (d5_2 * C3_11_31 - d5_3 * C3_11_21);
  A[501] = t601;
  A[4974] = t601;
  const T t602 = T(4.06) * (d5_2 * C3_11_32 - d5_3 * C3_11_22);
  A[502] = t602;
  A[5046] = t602;
  const T t603 = T(4.06) * (d5_2 * C3_11_33 - d5_3 * C3_11_23);
  A[503] = t603;
  A[5118] = t603;
  const T t604 = d5_1 * d5_1;
  const T t605 = d4_1 * d4_1;
  A[511] = T(0.69994208) + T(9.79) * (t541 + t604) + T(5.23) * (t543 + t605);
  const T t606 = T(0.007862880000000001) + d5_3 * d5_2 * T(9.79) + d4_3 * d4_2 * T(5.23);
  A[512] = -t606;
  A[583] = -t606;
  const T t607 = h4_2 * C3_4_13 - h4_3 * C3_4_12;
  const T t608 = d4_1 * t548 - d4_3 * t607;
  A[513] = -t608;
  A[655] = -t608;
  const T t609 = h4_3 * C3_4_11 - h4_1 * C3_4_13;
  const T t610 = d4_1 * t551 - d4_3 * t609;
  A[514] = -t610;
  A[727] = -t610;
  const T t611 = h4_1 * C3_4_12 - h4_2 * C3_4_11;
  const T t612 = d4_1 * t554 - d4_3 * t611;
  A[515] = -t612;
  A[799] = -t612;
  const T t613 = h5_2 * C3_5_13 - h5_3 * C3_5_12;
  const T t614 = d5_1 * t557 - d5_3 * t613;
  A[516] = -t614;
  A[871] = -t614;
  const T t615 = h5_3 * C3_5_11 - h5_1 * C3_5_13;
  const T t616 = d5_1 * t560 - d5_3 * t615;
  A[517] = -t616;
  A[943] = -t616;
  const T t617 = h5_1 * C3_5_12 - h5_2 * C3_5_11;
  const T t618 = d5_1 * t563 - d5_3 * t617;
  A[518] = -t618;
  A[1015] = -t618;
  const T t619 = T(0.487) * C3_7_12 - T(0.192) * C3_7_13;
  const T t620 = T(0.74) * (d4_1 * t566 - d4_3 * t619);
  A[522] = -t620;
  A[1303] = -t620;
  const T t621 = T(0.475) * C3_7_13 - T(0.487) * C3_7_11;
  const T t622 = T(0.74) * (d4_1 * t569 - d4_3 * t621);
  A[523] = -t622;
  A[1375] = -t622;
  const T t623 = T(0.192) * C3_7_11 - T(0.475) * C3_7_12;
  const T t624 = T(0.74) * (d4_1 * t572 - d4_3 * t623);
  A[524] = -t624;
  A[1447] = -t624;
  const T t625 = h11_2 * C3_11_13 - h11_3 * C3_11_12;
  const T t626 = d5_1 * t575 - d5_3 * t625;
  A[534] = -t626;
  A[2167] = -t626;
  const T t627 = h11_3 * C3_11_11 - h11_1 * C3_11_13;
  const T t628 = d5_1 * t578 - d5_3 * t627;
  A[535] = -t628;
  A[2239] = -t628;
  const T t629 = h11_1 * C3_11_12 - h11_2 * C3_11_11;
  const T t630 = d5_1 * t581 - d5_3 * t629;
  A[536] = -t630;
  A[2311] = -t630;
  const T t631 = T(0.1) * C3_12_12 - T(0.141) * C3_12_13;
  const T t632 = T(4.06) * (d5_1 * t584 - d5_3 * t631);
  A[537] = -t632;
  A[2383] = -t632;
  const T t633 = T(0.006) * C3_12_13 - T(0.1) * C3_12_11;
  const T t634 = T(4.06) * (d5_1 * t587 - d5_3 * t633);
  A[538] = -t634;
  A[2455] = -t634;
  const T t635 = T(0.141) * C3_12_11 - T(0.006) * C3_12_12;
  const T t636 = T(4.06) * (d5_1 * t590 - d5_3 * t635);
  A[539] = -t636;
  A[2527] = -t636;
  const T t637 = h3_3 * R3_11 - h3_1 * R3_31;
  A[540] = t637;
  A[2599] = t637;
  const T t638 = h3_3 * R3_12 - h3_1 * R3_32;
  A[541] = t638;
  A[2671] = t638;
  const T t639 = h3_3 * R3_13 - h3_1 * R3_33;
  A[542] = t639;
  A[2743] = t639;
  A[543] = t153;
  A[2815] = t153;
  A[544] = t19;
  A[2887] = t19;
  A[545] = t20;
  A[2959] = t20;
  A[546] = t423;
  A[3031] = t423;
  A[547] = t325;
  A[3103] = t325;
  A[548] = t326;
  A[3175] = t326;
  A[551] = -b3_2;
  A[622] = b3_2;
  A[3320] = b3_2;
  A[3391] = -b3_2;
  A[554] = -b3_1;
  A[625] = b3_1;
  A[3536] = b3_1;
  A[3607] = -b3_1;
  const T t640 = T(0.74) * (d4_3 * C3_4_11 - d4_1 * C3_4_31);
  A[558] = t640;
  A[3895] = t640;
  const T t641 = T(0.74) * (d4_3 * C3_4_12 - d4_1 * C3_4_32);
  A[559] = t641;
  A[3967] = t641;
  const T t642 = T(0.74) * (d4_3 * C3_4_13 - d4_1 * C3_4_33);
  A[560] = t642;
  A[4039] = t642;
  const T t643 = T(7.83) * (d5_3 * C3_5_11 - d5_1 * C3_5_31);
  A[570] = t643;
  A[4759] = t643;
  const T t644 = T(7.83) * (d5_3 * C3_5_12 - d5_1 * C3_5_32);
  A[571] = t644;
  A[4831] = t644;
  const T t645 = T(7.83) * (d5_3 * C3_5_13 - d5_1 * C3_5_33);
  A[572] = t645;
  A[4903] = t645;
  const T t646 = T(4.06) * (d5_3 * C3_11_11 - d5_1 * C3_11_31);
  A[573] = t646;
  A[4975] = t646;
  const T t647 = T(4.06) * (d5_3 * C3_11_12 - d5_1 * C3_11_32);
  A[574] = t647;
  A[5047] = t647;
  const T t648 = T(4.06) * (d5_3 * C3_11_13 - d5_1 * C3_11_33);
  A[575] = t648;
  A[5119] = t648;
  A[584] = T(1.2878364) + T(9.79) * (t542 + t604) + T(5.23) * (t544 + t605);
  const T t649 = d4_2 * t607 - d4_1 * t547;
  A[585] = -t649;
  A[656] = -t649;
  const T t650 = d4_2 * t609 - d4_1 * t550;
  A[586] = -t650;
  A[728] = -t650;
  const T t651 = d4_2 * t611 - d4_1 * t553;
  A[587] = -t651;
  A[800] = -t651;
  const T t652 = d5_2 * t613 - d5_1 * t556;
  A[588] = -t652;
  A[872] = -t652;
  const T t653 = d5_2 * t615 - d5_1 * t559;
  A[589] = -t653;
  A[944] = -t653;
  const T t654 = d5_2 * t617 - d5_1 * t562;
  A[590] = -t654;
  A[1016] = -t654;
  const T t655 = T(0.74) * (d4_2 * t619 - d4_1 * t565);
  A[594] = -t655;
  A[1304] = -t655;
  const T t656 = T(0.74) * (d4_2 * t621 - d4_1 * t568);
  A[595] = -t656;
  A[1376] = -t656;
  const T t657 = T(0.74) * (d4_2 * t623 - d4_1 * t571);
  A[596] = -t657;
  A[1448] = -t657;
  const T t658 = d5_2 * t625 - d5_1 * t574;
  A[606] = -t658;
  A[2168] = -t658;
  const T t659 = d5_2 * t627 - d5_1 * t577;
  A[607] = -t659;
  A[2240] = -t659;
  const T t660 = d5_2 * t629 - d5_1 * t580;
  A[608] = -t660;
  A[2312] = -t660;
  const T t661 = T(4.06) * (d5_2 * t631 - d5_1 * t583);
  A[609] = -t661;
  A[2384] = -t661;
  const T t662 = T(4.06) * (d5_2 * t633 - d5_1 * t586);
  A[610] = -t662;
  A[2456] = -t662;
  const T t663 = T(4.06) * (d5_2 * t635 - d5_1 * t589);
  A[611] = -t663;
  A[2528] = -t663;
  const T t664 = h3_1 * R3_21 - h3_2 * R3_11;
  A[612] = t664;
  A[2600] = t664;
  const T t665 = h3_1 * R3_22 - h3_2 * R3_12;
  A[613] = t665;
  A[2672] = t665;
  const T t666 = h3_1 * R3_23 - h3_2 * R3_13;
  A[614] = t666;
  A[2744] = t666;
  A[615] = t155;
  A[2816] = t155;
  A[616] = t22;
  A[2888] = t22;
  A[617] = t23;
  A[2960] = t23;
  A[618] = t425;
  A[3032] = t425;
  A[619] = t328;
  A[3104] = t328;
  A[620] = t329;
  A[3176] = t329;
  const T t667 = T(0.74) * (d4_1 * C3_4_21 - d4_2 * C3_4_11);
  A[630] = t667;
  A[3896] = t667;
  const T t668 = T(0.74) * (d4_1 * C3_4_22 - d4_2 * C3_4_12);
  A[631] = t668;
  A[3968] = t668;
  const T t669 = T(0.74) * (d4_1 * C3_4_23 - d4_2 * C3_4_13);
  A[632] = t669;
  A[4040] = t669;
  const T t670 = T(7.83) * (d5_1 * C3_5_21 - d5_2 * C3_5_11);
  A[642] = t670;
  A[4760] = t670;
  const T t671 = T(7.83) * (d5_1 * C3_5_22 - d5_2 * C3_5_12);
  A[643] = t671;
  A[4832] = t671;
  const T t672 = T(7.83) * (d5_1 * C3_5_23 - d5_2 * C3_5_13);
  A[644] = t672;
  A[4904] = t672;
  const T t673 = T(4.06) * (d5_1 * C3_11_21 - d5_2 * C3_11_11);
  A[645] = t673;
  A[4976] = t673;
  const T t674 = T(4.06) * (d5_1 * C3_11_22 - d5_2 * C3_11_12);
  A[646] = t674;
  A[5048] = t674;
  const T t675 = T(4.06) * (d5_1 * C3_11_23 - d5_2 * C3_11_13);
  A[647] = t675;
  A[5120] = t675;
  const T t676 = d7_3 * d7_3;
  const T t677 = d7_2 * d7_2;
  A[657] = T(0.6588452899999999) + T(0.74) * (t676 + t677);
  const T t678 = T(0.49784161000000005) + d7_2 * d7_1 * T(0.74);
  A[658] = -t678;
  A[729] = -t678;
  const T t679 = T(0.17233920000000003) + d7_3 * d7_1 * T(0.74);
  A[659] = -t679;
  A[801] = -t679;
  const T t680 = T(0.487) * C4_7_22 - T(0.192) * C4_7_23;
  const T t681 = T(0.487) * C4_7_32 - T(0.192) * C4_7_33;
  const T t682 = T(0.74) * (d7_3 * t680 - d7_2 * t681);
  A[666] = -t682;
  A[1305] = -t682;
  const T t683 = T(0.475) * C4_7_23 - T(0.487) * C4_7_21;
  const T t684 = T(0.475) * C4_7_33 - T(0.487) * C4_7_31;
  const T t685 = T(0.74) * (d7_3 * t683 - d7_2 * t684);
  A[667] = -t685;
  A[1377] = -t685;
  const T t686 = T(0.192) * C4_7_21 - T(0.475) * C4_7_22;
  const T t687 = T(0.192) * C4_7_31 - T(0.475) * C4_7_32;
  const T t688 = T(0.74) * (d7_3 * t686 - d7_2 * t687);
  A[668] = -t688;
  A[1449] = -t688;
  const T t689 = h4_2 * R4_31 - h4_3 * R4_21;
  A[684] = t689;
  A[2601] = t689;
  const T t690 = h4_2 * R4_32 - h4_3 * R4_22;
  A[685] = t690;
  A[2673] = t690;
  const T t691 = h4_2 * R4_33 - h4_3 * R4_23;
  A[686] = t691;
  A[2745] = t691;
  A[687] = t157;
  A[2817] = t157;
  A[688] = t25;
  A[2889] = t25;
  A[689] = t26;
  A[2961] = t26;
  A[690] = t427;
  A[3033] = t427;
  A[691] = t331;
  A[3105] = t331;
  A[692] = t332;
  A[3177] = t332;
  A[693] = t607;
  A[3249] = t607;
  A[694] = t547;
  A[3321] = t547;
  A[695] = t548;
  A[3393] = t548;
  A[703] = -b4_3;
  A[774] = b4_3;
  A[3898] = b4_3;
  A[3969] = -b4_3;
  A[704] = b4_2;
  A[846] = -b4_2;
  A[3899] = -b4_2;
  A[4041] = b4_2;
  const T t692 = d7_1 * d7_1;
  A[730] = T(0.9904324900000001) + T(0.74) * (t676 + t692);
  const T t693 = T(0.1259088) + d7_3 * d7_2 * T(0.74);
  A[731] = -t693;
  A[802] = -t693;
  const T t694 = T(0.487) * C4_7_12 - T(0.192) * C4_7_13;
  const T t695 = T(0.74) * (d7_1 * t681 - d7_3 * t694);
  A[738] = -t695;
  A[1306] = -t695;
  const T t696 = T(0.475) * C4_7_13 - T(0.487) * C4_7_11;
  const T t697 = T(0.74) * (d7_1 * t684 - d7_3 * t696);
  A[739] = -t697;
  A[1378] = -t697;
  const T t698 = T(0.192) * C4_7_11 - T(0.475) * C4_7_12;
  const T t699 = T(0.74) * (d7_1 * t687 - d7_3 * t698);
  A[740] = -t699;
  A[1450] = -t699;
  const T t700 = h4_3 * R4_11 - h4_1 * R4_31;
  A[756] = t700;
  A[2602] = t700;
  const T t701 = h4_3 * R4_12 - h4_1 * R4_32;
  A[757] = t701;
  A[2674] = t701;
  const T t702 = h4_3 * R4_13 - h4_1 * R4_33;
  A[758] = t702;
  A[2746] = t702;
  A[759] = t159;
  A[2818] = t159;
  A[760] = t28;
  A[2890] = t28;
  A[761] = t29;
  A[2962] = t29;
  A[762] = t429;
  A[3034] = t429;
  A[763] = t334;
  A[3106] = t334;
  A[764] = t335;
  A[3178] = t335;
  A[765] = t609;
  A[3250] = t609;
  A[766] = t550;
  A[3322] = t550;
  A[767] = t551;
  A[3394] = t551;
  A[776] = -b4_1;
  A[847] = b4_1;
  A[3971] = b4_1;
  A[4042] = -b4_1;
  A[803] = T(1.33780578) + T(0.74) * (t677 + t692);
  const T t703 = T(0.74) * (d7_2 * t694 - d7_1 * t680);
  A[810] = -t703;
  A[1307] = -t703;
  const T t704 = T(0.74) * (d7_2 * t696 - d7_1 * t683);
  A[811] = -t704;
  A[1379] = -t704;
  const T t705 = T(0.74) * (d7_2 * t698 - d7_1 * t686);
  A[812] = -t705;
  A[1451] = -t705;
  const T t706 = h4_1 * R4_21 - h4_2 * R4_11;
  A[828] = t706;
  A[2603] = t706;
  const T t707 = h4_1 * R4_22 - h4_2 * R4_12;
  A[829] = t707;
  A[2675] = t707;
  const T t708 = h4_1 * R4_23 - h4_2 * R4_13;
  A[830] = t708;
  A[2747] = t708;
  A[831] = t161;
  A[2819] = t161;
  A[832] = t31;
  A[2891] = t31;
  A[833] = t32;
  A[2963] = t32;
  A[834] = t431;
  A[3035] = t431;
  A[835] = t337;
  A[3107] = t337;
  A[836] = t338;
  A[3179] = t338;
  A[837] = t611;
  A[3251] = t611;
  A[838] = t553;
  A[3323] = t553;
  A[839] = t554;
  A[3395] = t554;
  const T t709 = d11_3 * d11_3;
  const T t710 = d11_2 * d11_2;
  A[876] = T(0.3080228) + T(7.83) * (t709 + t710);
  const T t711 = T(0.004367040000000003) - d11_2 * d11_1 * T(7.83);
  A[877] = t711;
  A[948] = t711;
  const T t712 = T(0.03262992) - d11_3 * d11_1 * T(7.83);
  A[878] = t712;
  A[1020] = t712;
  const T t713 = h11_2 * C5_11_23 - h11_3 * C5_11_22;
  const T t714 = h11_2 * C5_11_33 - h11_3 * C5_11_32;
  const T t715 = d11_3 * t713 - d11_2 * t714;
  A[894] = -t715;
  A[2172] = -t715;
  const T t716 = h11_3 * C5_11_21 - h11_1 * C5_11_23;
  const T t717 = h11_3 * C5_11_31 - h11_1 * C5_11_33;
  const T t718 = d11_3 * t716 - d11_2 * t717;
  A[895] = -t718;
  A[2244] = -t718;
  const T t719 = h11_1 * C5_11_22 - h11_2 * C5_11_21;
  const T t720 = h11_1 * C5_11_32 - h11_2 * C5_11_31;
  const T t721 = d11_3 * t719 - d11_2 * t720;
  A[896] = -t721;
  A[2316] = -t721;
  const T t722 = T(0.1) * C5_12_22 - T(0.141) * C5_12_23;
  const T t723 = T(0.1) * C5_12_32 - T(0.141) * C5_12_33;
  const T t724 = T(4.06) * (d11_3 * t722 - d11_2 * t723);
  A[897] = -t724;
  A[2388] = -t724;
  const T t725 = T(0.006) * C5_12_23 - T(0.1) * C5_12_21;
  const T t726 = T(0.006) * C5_12_33 - T(0.1) * C5_12_31;
  const T t727 = T(4.06) * (d11_3 * t725 - d11_2 * t726);
  A[898] = -t727;
  A[2460] = -t727;
  const T t728 = T(0.141) * C5_12_21 - T(0.006) * C5_12_22;
  const T t729 = T(0.141) * C5_12_31 - T(0.006) * C5_12_32;
  const T t730 = T(4.06) * (d11_3 * t728 - d11_2 * t729);
  A[899] = -t730;
  A[2532] = -t730;
  const T t731 = h5_2 * R5_31 - h5_3 * R5_21;
  A[900] = t731;
  A[2604] = t731;
  const T t732 = h5_2 * R5_32 - h5_3 * R5_22;
  A[901] = t732;
  A[2676] = t732;
  const T t733 = h5_2 * R5_33 - h5_3 * R5_23;
  A[902] = t733;
  A[2748] = t733;
  A[903] = t163;
  A[2820] = t163;
  A[904] = t34;
  A[2892] = t34;
  A[905] = t35;
  A[2964] = t35;
  A[906] = t433;
  A[3036] = t433;
  A[907] = t340;
  A[3108] = t340;
  A[908] = t341;
  A[3180] = t341;
  A[912] = t613;
  A[3468] = t613;
  A[913] = t556;
  A[3540] = t556;
  A[914] = t557;
  A[3612] = t557;
  A[931] = -b5_3;
  A[1002] = b5_3;
  A[4765] = b5_3;
  A[4836] = -b5_3;
  A[932] = b5_2;
  A[1074] = -b5_2;
  A[4766] = -b5_2;
  A[4908] = b5_2;
  const T t734 = T(4.06) * (d11_2 * C5_11_31 - d11_3 * C5_11_21);
  A[933] = t734;
  A[4980] = t734;
  const T t735 = T(4.06) * (d11_2 * C5_11_32 - d11_3 * C5_11_22);
  A[934] = t735;
  A[5052] = t735;
  const T t736 = T(4.06) * (d11_2 * C5_11_33 - d11_3 * C5_11_23);
  A[935] = t736;
  A[5124] = t736;
  const T t737 = d11_1 * d11_1;
  A[949] = T(0.190109) + T(7.83) * (t709 + t737);
  const T t738 = T(0.10146972000000001) - d11_3 * d11_2 * T(7.83);
  A[950] = t738;
  A[1021] = t738;
  const T t739 = h11_2 * C5_11_13 - h11_3 * C5_11_12;
  const T t740 = d11_1 * t714 - d11_3 * t739;
  A[966] = -t740;
  A[2173] = -t740;
  const T t741 = h11_3 * C5_11_11 - h11_1 * C5_11_13;
  const T t742 = d11_1 * t717 - d11_3 * t741;
  A[967] = -t742;
  A[2245] = -t742;
  const T t743 = h11_1 * C5_11_12 - h11_2 * C5_11_11;
  const T t744 = d11_1 * t720 - d11_3 * t743;
  A[968] = -t744;
  A[2317] = -t744;
  const T t745 = T(0.1) * C5_12_12 - T(0.141) * C5_12_13;
  const T t746 = T(4.06) * (d11_1 * t723 - d11_3 * t745);
  A[969] = -t746;
  A[2389] = -t746;
  const T t747 = T(0.006) * C5_12_13 - T(0.1) * C5_12_11;
  const T t748 = T(4.06) * (d11_1 * t726 - d11_3 * t747);
  A[970] = -t748;
  A[2461] = -t748;
  const T t749 = T(0.141) * C5_12_11 - T(0.006) * C5_12_12;
  const T t750 = T(4.06) * (d11_1 * t729 - d11_3 * t749);
  A[971] = -t750;
  A[2533] = -t750;
  const T t751 = h5_3 * R5_11 - h5_1 * R5_31;
  A[972] = t751;
  A[2605] = t751;
  const T t752 = h5_3 * R5_12 - h5_1 * R5_32;
  A[973] = t752;
  A[2677] = t752;
  const T t753 = h5_3 * R5_13 - h5_1 * R5_33;
  A[974] = t753;
  A[2749] = t753;
  A[975] = t165;
  A[2821] = t165;
  A[976] = t37;
  A[2893] = t37;
  A[977] = t38;
  A[2965] = t38;
  A[978] = t435;
  A[3037] = t435;
  A[979] = t343;
  A[3109] = t343;
  A[980] = t344;
  A[3181] = t344;
  A[984] = t615;
  A[3469] = t615;
  A[985] = t559;
  A[3541] = t559;
  A[986] = t560;
  A[3613] = t560;
  A[1004] = -b5_1;
  A[1075] = b5_1;
  A[4838] = b5_1;
  A[4909] = -b5_1;
  const T t754 = T(4.06) * (d11_3 * C5_11_11 - d11_1 * C5_11_31);
  A[1005] = t754;
  A[4981] = t754;
  const T t755 = T(4.06) * (d11_3 * C5_11_12 - d11_1 * C5_11_32);
  A[1006] = t755;
  A[5053] = t755;
  const T t756 = T(4.06) * (d11_3 * C5_11_13 - d11_1 * C5_11_33);
  A[1007] = t756;
  A[5125] = t756;
  A[1022] = T(0.34910692) + T(7.83) * (t710 + t737);
  const T t757 = d11_2 * t739 - d11_1 * t713;
  A[1038] = -t757;
  A[2174] = -t757;
  const T t758 = d11_2 * t741 - d11_1 * t716;
  A[1039] = -t758;
  A[2246] = -t758;
  const T t759 = d11_2 * t743 - d11_1 * t719;
  A[1040] = -t759;
  A[2318] = -t759;
  const T t760 = T(4.06) * (d11_2 * t745 - d11_1 * t722);
  A[1041] = -t760;
  A[2390] = -t760;
  const T t761 = T(4.06) * (d11_2 * t747 - d11_1 * t725);
  A[1042] = -t761;
  A[2462] = -t761;
  const T t762 = T(4.06) * (d11_2 * t749 - d11_1 * t728);
  A[1043] = -t762;
  A[2534] = -t762;
  const T t763 = h5_1 * R5_21 - h5_2 * R5_11;
  A[1044] = t763;
  A[2606] = t763;
  const T t764 = h5_1 * R5_22 - h5_2 * R5_12;
  A[1045] = t764;
  A[2678] = t764;
  const T t765 = h5_1 * R5_23 - h5_2 * R5_13;
  A[1046] = t765;
  A[2750] = t765;
  A[1047] = t167;
  A[2822] = t167;
  A[1048] = t40;
  A[2894] = t40;
  A[1049] = t41;
  A[2966] = t41;
  A[1050] = t437;
  A[3038] = t437;
  A[1051] = t346;
  A[3110] = t346;
  A[1052] = t347;
  A[3182] = t347;
  A[1056] = t617;
  A[3470] = t617;
  A[1057] = t562;
  A[3542] = t562;
  A[1058] = t563;
  A[3614] = t563;
  const T t766 = T(4.06) * (d11_1 * C5_11_21 - d11_2 * C5_11_11);
  A[1077] = t766;
  A[4982] = t766;
  const T t767 = T(4.06) * (d11_1 * C5_11_22 - d11_2 * C5_11_12);
  A[1078] = t767;
  A[5054] = t767;
  const T t768 = T(4.06) * (d11_1 * C5_11_23 - d11_2 * C5_11_13);
  A[1079] = t768;
  A[5126] = t768;
  const T t769 = d9_3 * d9_3;
  const T t770 = d9_2 * d9_2;
  A[1095] = T(1.3383176) + T(1.84) * (t769 + t770);
  const T t771 = T(0.07297376) - d9_2 * d9_1 * T(1.84);
  A[1096] = t771;
  A[1167] = t771;
  const T t772 = T(0.11881647999999999) - d9_3 * d9_1 * T(1.84);
  A[1097] = t772;
  A[1239] = t772;
  const T t773 = T(0.015) * C6_9_22 + T(0.49) * C6_9_23;
  const T t774 = T(0.015) * C6_9_32 + T(0.49) * C6_9_33;
  const T t775 = T(1.84) * (d9_3 * t773 - d9_2 * t774);
  A[1104] = -t775;
  A[1743] = -t775;
  const T t776 = T(0.015) * C6_9_31 + T(0.362) * C6_9_33;
  const T t777 = T(0.015) * C6_9_21 + T(0.362) * C6_9_23;
  const T t778 = T(1.84) * (d9_2 * t776 - d9_3 * t777);
  A[1105] = -t778;
  A[1815] = -t778;
  const T t779 = T(0.362) * C6_9_22 - T(0.49) * C6_9_21;
  const T t780 = T(0.362) * C6_9_32 - T(0.49) * C6_9_31;
  const T t781 = T(1.84) * (d9_3 * t779 - d9_2 * t780);
  A[1106] = -t781;
  A[1887] = -t781;
  const T t782 = h6_2 * R6_31 - h6_3 * R6_21;
  A[1116] = t782;
  A[2607] = t782;
  const T t783 = h6_2 * R6_32 - h6_3 * R6_22;
  A[1117] = t783;
  A[2679] = t783;
  const T t784 = h6_2 * R6_33 - h6_3 * R6_23;
  A[1118] = t784;
  A[2751] = t784;
  A[1119] = t169;
  A[2823] = t169;
  A[1120] = t43;
  A[2895] = t43;
  A[1121] = t44;
  A[2967] = t44;
  A[1131] = t439;
  A[3687] = t439;
  A[1132] = t349;
  A[3759] = t349;
  A[1133] = t350;
  A[3831] = t350;
  A[1141] = -b6_3;
  A[1212] = b6_3;
  A[4336] = b6_3;
  A[4407] = -b6_3;
  A[1142] = b6_2;
  A[1284] = -b6_2;
  A[4337] = -b6_2;
  A[4479] = b6_2;
  const T t785 = d9_1 * d9_1;
  A[1168] = T(1.31632096) + T(1.84) * (t769 + t785);
  const T t786 = T(0.36992016) + d9_3 * d9_2 * T(1.84);
  A[1169] = -t786;
  A[1240] = -t786;
  const T t787 = T(0.015) * C6_9_12 + T(0.49) * C6_9_13;
  const T t788 = T(1.84) * (d9_1 * t774 - d9_3 * t787);
  A[1176] = -t788;
  A[1744] = -t788;
  const T t789 = T(0.015) * C6_9_11 + T(0.362) * C6_9_13;
  const T t790 = T(1.84) * (d9_3 * t789 - d9_1 * t776);
  A[1177] = -t790;
  A[1816] = -t790;
  const T t791 = T(0.362) * C6_9_12 - T(0.49) * C6_9_11;
  const T t792 = T(1.84) * (d9_1 * t780 - d9_3 * t791);
  A[1178] = -t792;
  A[1888] = -t792;
  const T t793 = h6_3 * R6_11 - h6_1 * R6_31;
  A[1188] = t793;
  A[2608] = t793;
  const T t794 = h6_3 * R6_12 - h6_1 * R6_32;
  A[1189] = t794;
  A[2680] = t794;
  const T t795 = h6_3 * R6_13 - h6_1 * R6_33;
  A[1190] = t795;
  A[2752] = t795;
  A[1191] = t171;
  A[2824] = t171;
  A[1192] = t46;
  A[2896] = t46;
  A[1193] = t47;
  A[2968] = t47;
  A[1203] = t441;
  A[3688] = t441;
  A[1204] = t352;
  A[3760] = t352;
  A[1205] = t353;
  A[3832] = t353;
  A[1214] = -b6_1;
  A[1285] = b6_1;
  A[4409] = b6_1;
  A[4480] = -b6_1;
  A[1241] = T(0.7983712) + T(1.84) * (t770 + t785);
  const T t796 = T(1.84) * (d9_2 * t787 - d9_1 * t773);
  A[1248] = -t796;
  A[1745] = -t796;
  const T t797 = T(1.84) * (d9_1 * t777 - d9_2 * t789);
  A[1249] = -t797;
  A[1817] = -t797;
  const T t798 = T(1.84) * (d9_2 * t791 - d9_1 * t779);
  A[1250] = -t798;
  A[1889] = -t798;
  const T t799 = h6_1 * R6_21 - h6_2 * R6_11;
  A[1260] = t799;
  A[2609] = t799;
  const T t800 = h6_1 * R6_22 - h6_2 * R6_12;
  A[1261] = t800;
  A[2681] = t800;
  const T t801 = h6_1 * R6_23 - h6_2 * R6_13;
  A[1262] = t801;
  A[2753] = t801;
  A[1263] = t173;
  A[2825] = t173;
  A[1264] = t49;
  A[2897] = t49;
  A[1265] = t50;
  A[2969] = t50;
  A[1275] = t443;
  A[3689] = t443;
  A[1276] = t355;
  A[3761] = t355;
  A[1277] = t356;
  A[3833] = t356;
  A[1314] = T(0.33578442);
  A[1315] = -T(0.068188);
  A[1386] = -T(0.068188);
  A[1316] = -T(0.16868049999999998);
  A[1458] = -T(0.16868049999999998);
  const T t802 = T(0.74) * (T(0.487) * R7_21 - T(0.192) * R7_31);
  A[1332] = t802;
  A[2610] = t802;
  const T t803 = T(0.74) * (T(0.487) * R7_22 - T(0.192) * R7_32);
  A[1333] = t803;
  A[2682] = t803;
  const T t804 = T(0.74) * (T(0.487) * R7_23 - T(0.192) * R7_33);
  A[1334] = t804;
  A[2754] = t804;
  const T t805 = T(0.74) * t175;
  A[1335] = t805;
  A[2826] = t805;
  const T t806 = T(0.74) * t52;
  A[1336] = t806;
  A[2898] = t806;
  const T t807 = T(0.74) * t53;
  A[1337] = t807;
  A[2970] = t807;
  const T t808 = T(0.74) * t445;
  A[1338] = t808;
  A[3042] = t808;
  const T t809 = T(0.74) * t358;
  A[1339] = t809;
  A[3114] = t809;
  const T t810 = T(0.74) * t359;
  A[1340] = t810;
  A[3186] = t810;
  const T t811 = T(0.74) * t619;
  A[1341] = t811;
  A[3258] = t811;
  const T t812 = T(0.74) * t565;
  A[1342] = t812;
  A[3330] = t812;
  const T t813 = T(0.74) * t566;
  A[1343] = t813;
  A[3402] = t813;
  const T t814 = T(0.74) * t694;
  A[1350] = t814;
  A[3906] = t814;
  const T t815 = T(0.74) * t680;
  A[1351] = t815;
  A[3978] = t815;
  const T t816 = T(0.74) * t681;
  A[1352] = t816;
  A[4050] = t816;
  A[1387] = T(0.47846755999999996);
  A[1388] = -T(0.06749296);
  A[1459] = -T(0.06749296);
  const T t817 = T(0.74) * (T(0.475) * R7_31 - T(0.487) * R7_11);
  A[1404] = t817;
  A[2611] = t817;
  const T t818 = T(0.74) * (T(0.475) * R7_32 - T(0.487) * R7_12);
  A[1405] = t818;
  A[2683] = t818;
  const T t819 = T(0.74) * (T(0.475) * R7_33 - T(0.487) * R7_13);
  A[1406] = t819;
  A[2755] = t819;
  const T t820 = T(0.74) * t177;
  A[1407] = t820;
  A[2827] = t820;
  const T t821 = T(0.74) * t55;
  A[1408] = t821;
  A[2899] = t821;
  const T t822 = T(0.74) * t56;
  A[1409] = t822;
  A[2971] = t822;
  const T t823 = T(0.74) * t447;
  A[1410] = t823;
  A[3043] = t823;
  const T t824 = T(0.74) * t361;
  A[1411] = t824;
  A[3115] = t824;
  const T t825 = T(0.74) * t362;
  A[1412] = t825;
  A[3187] = t825;
  const T t826 = T(0.74) * t621;
  A[1413] = t826;
  A[3259] = t826;
  const T t827 = T(0.74) * t568;
  A[1414] = t827;
  A[3331] = t827;
  const T t828 = T(0.74) * t569;
  A[1415] = t828;
  A[3403] = t828;
  const T t829 = T(0.74) * t696;
  A[1422] = t829;
  A[3907] = t829;
  const T t830 = T(0.74) * t683;
  A[1423] = t830;
  A[3979] = t830;
  const T t831 = T(0.74) * t684;
  A[1424] = t831;
  A[4051] = t831;
  A[1460] = T(0.32814185999999995);
  const T t832 = T(0.74) * (T(0.192) * R7_11 - T(0.475) * R7_21);
  A[1476] = t832;
  A[2612] = t832;
  const T t833 = T(0.74) * (T(0.192) * R7_12 - T(0.475) * R7_22);
  A[1477] = t833;
  A[2684] = t833;
  const T t834 = T(0.74) * (T(0.192) * R7_13 - T(0.475) * R7_23);
  A[1478] = t834;
  A[2756] = t834;
  const T t835 = T(0.74) * t179;
  A[1479] = t835;
  A[2828] = t835;
  const T t836 = T(0.74) * t58;
  A[1480] = t836;
  A[2900] = t836;
  const T t837 = T(0.74) * t59;
  A[1481] = t837;
  A[2972] = t837;
  const T t838 = T(0.74) * t449;
  A[1482] = t838;
  A[3044] = t838;
  const T t839 = T(0.74) * t364;
  A[1483] = t839;
  A[3116] = t839;
  const T t840 = T(0.74) * t365;
  A[1484] = t840;
  A[3188] = t840;
  const T t841 = T(0.74) * t623;
  A[1485] = t841;
  A[3260] = t841;
  const T t842 = T(0.74) * t571;
  A[1486] = t842;
  A[3332] = t842;
  const T t843 = T(0.74) * t572;
  A[1487] = t843;
  A[3404] = t843;
  const T t844 = T(0.74) * t698;
  A[1494] = t844;
  A[3908] = t844;
  const T t845 = T(0.74) * t686;
  A[1495] = t845;
  A[3980] = t845;
  const T t846 = T(0.74) * t687;
  A[1496] = t846;
  A[4052] = t846;
  const T t847 = d10_3 * d10_3;
  const T t848 = d10_2 * d10_2;
  A[1533] = T(1.4524203199999999) + T(2.57) * (t847 + t848);
  const T t849 = T(0.45662512) + d10_2 * d10_1 * T(2.57);
  A[1534] = -t849;
  A[1605] = -t849;
  const T t850 = T(0.51157008) + d10_3 * d10_1 * T(2.57);
  A[1535] = -t850;
  A[1677] = -t850;
  const T t851 = T(0.426) * C8_10_22 + T(0.148) * C8_10_23;
  const T t852 = T(0.426) * C8_10_32 + T(0.148) * C8_10_33;
  const T t853 = T(2.57) * (d10_3 * t851 - d10_2 * t852);
  A[1539] = -t853;
  A[1965] = -t853;
  const T t854 = T(0.426) * C8_10_31 + T(0.016) * C8_10_33;
  const T t855 = T(0.426) * C8_10_21 + T(0.016) * C8_10_23;
  const T t856 = T(2.57) * (d10_2 * t854 - d10_3 * t855);
  A[1540] = -t856;
  A[2037] = -t856;
  const T t857 = T(0.016) * C8_10_22 - T(0.148) * C8_10_21;
  const T t858 = T(0.016) * C8_10_32 - T(0.148) * C8_10_31;
  const T t859 = T(2.57) * (d10_3 * t857 - d10_2 * t858);
  A[1541] = -t859;
  A[2109] = -t859;
  const T t860 = h8_2 * R8_31 - h8_3 * R8_21;
  A[1548] = t860;
  A[2613] = t860;
  const T t861 = h8_2 * R8_32 - h8_3 * R8_22;
  A[1549] = t861;
  A[2685] = t861;
  const T t862 = h8_2 * R8_33 - h8_3 * R8_23;
  A[1550] = t862;
  A[2757] = t862;
  A[1569] = t181;
  A[4125] = t181;
  A[1570] = t61;
  A[4197] = t61;
  A[1571] = t62;
  A[4269] = t62;
  A[1576] = -b8_3;
  A[1647] = b8_3;
  A[4558] = b8_3;
  A[4629] = -b8_3;
  A[1577] = b8_2;
  A[1719] = -b8_2;
  A[4559] = -b8_2;
  A[4701] = b8_2;
  const T t863 = d10_1 * d10_1;
  A[1606] = T(1.4500680000000001) + T(2.57) * (t847 + t863);
  const T t864 = T(0.47254784) + d10_3 * d10_2 * T(2.57);
  A[1607] = -t864;
  A[1678] = -t864;
  const T t865 = T(0.426) * C8_10_12 + T(0.148) * C8_10_13;
  const T t866 = T(2.57) * (d10_1 * t852 - d10_3 * t865);
  A[1611] = -t866;
  A[1966] = -t866;
  const T t867 = T(0.426) * C8_10_11 + T(0.016) * C8_10_13;
  const T t868 = T(2.57) * (d10_3 * t867 - d10_1 * t854);
  A[1612] = -t868;
  A[2038] = -t868;
  const T t869 = T(0.016) * C8_10_12 - T(0.148) * C8_10_11;
  const T t870 = T(2.57) * (d10_1 * t858 - d10_3 * t869);
  A[1613] = -t870;
  A[2110] = -t870;
  const T t871 = h8_3 * R8_11 - h8_1 * R8_31;
  A[1620] = t871;
  A[2614] = t871;
  const T t872 = h8_3 * R8_12 - h8_1 * R8_32;
  A[1621] = t872;
  A[2686] = t872;
  const T t873 = h8_3 * R8_13 - h8_1 * R8_33;
  A[1622] = t873;
  A[2758] = t873;
  A[1641] = t183;
  A[4126] = t183;
  A[1642] = t64;
  A[4198] = t64;
  A[1643] = t65;
  A[4270] = t65;
  A[1649] = -b8_1;
  A[1720] = b8_1;
  A[4631] = b8_1;
  A[4702] = -b8_1;
  A[1679] = T(1.4020112) + T(2.57) * (t848 + t863);
  const T t874 = T(2.57) * (d10_2 * t865 - d10_1 * t851);
  A[1683] = -t874;
  A[1967] = -t874;
  const T t875 = T(2.57) * (d10_1 * t855 - d10_2 * t867);
  A[1684] = -t875;
  A[2039] = -t875;
  const T t876 = T(2.57) * (d10_2 * t869 - d10_1 * t857);
  A[1685] = -t876;
  A[2111] = -t876;
  const T t877 = h8_1 * R8_21 - h8_2 * R8_11;
  A[1692] = t877;
  A[2615] = t877;
  const T t878 = h8_1 * R8_22 - h8_2 * R8_12;
  A[1693] = t878;
  A[2687] = t878;
  const T t879 = h8_1 * R8_23 - h8_2 * R8_13;
  A[1694] = t879;
  A[2759] = t879;
  A[1713] = t185;
  A[4127] = t185;
  A[1714] = t67;
  A[4199] = t67;
  A[1715] = t68;
  A[4271] = t68;
  A[1752] = T(0.673198);
  A[1753] = -T(0.3048792);
  A[1824] = -T(0.3048792);
  A[1754] = T(0.0356912);
  A[1896] = T(0.0356912);
  const T t880 = T(1.84) * (T(0.015) * R9_21 + T(0.49) * R9_31);
  A[1764] = t880;
  A[2616] = t880;
  const T t881 = T(1.84) * (T(0.015) * R9_22 + T(0.49) * R9_32);
  A[1765] = t881;
  A[2688] = t881;
  const T t882 = T(1.84) * (T(0.015) * R9_23 + T(0.49) * R9_33);
  A[1766] = t882;
  A[2760] = t882;
  const T t883 = T(1.84) * t187;
  A[1767] = t883;
  A[2832] = t883;
  const T t884 = T(1.84) * t70;
  A[1768] = t884;
  A[2904] = t884;
  const T t885 = T(1.84) * t71;
  A[1769] = t885;
  A[2976] = t885;
  const T t886 = T(1.84) * t451;
  A[1779] = t886;
  A[3696] = t886;
  const T t887 = T(1.84) * t367;
  A[1780] = t887;
  A[3768] = t887;
  const T t888 = T(1.84) * t368;
  A[1781] = t888;
  A[3840] = t888;
  const T t889 = T(1.84) * t787;
  A[1788] = t889;
  A[4344] = t889;
  const T t890 = T(1.84) * t773;
  A[1789] = t890;
  A[4416] = t890;
  const T t891 = T(1.84) * t774;
  A[1790] = t891;
  A[4488] = t891;
  A[1825] = T(0.54473496);
  A[1826] = T(0.004224);
  A[1897] = T(0.004224);
  const T t892 = T(1.84) * (T(0.015) * R9_11 + T(0.362) * R9_31);
  A[1836] = -t892;
  A[2617] = -t892;
  const T t893 = T(1.84) * (T(0.015) * R9_12 + T(0.362) * R9_32);
  A[1837] = -t893;
  A[2689] = -t893;
  const T t894 = T(1.84) * (T(0.015) * R9_13 + T(0.362) * R9_33);
  A[1838] = -t894;
  A[2761] = -t894;
  const T t895 = T(1.84) * t189;
  A[1839] = -t895;
  A[2833] = -t895;
  const T t896 = T(1.84) * t74;
  A[1840] = -t896;
  A[2905] = -t896;
  const T t897 = T(1.84) * t73;
  A[1841] = -t897;
  A[2977] = -t897;
  const T t898 = T(1.84) * t453;
  A[1851] = -t898;
  A[3697] = -t898;
  const T t899 = T(1.84) * t371;
  A[1852] = -t899;
  A[3769] = -t899;
  const T t900 = T(1.84) * t370;
  A[1853] = -t900;
  A[3841] = -t900;
  const T t901 = T(1.84) * t789;
  A[1860] = -t901;
  A[4345] = -t901;
  const T t902 = T(1.84) * t777;
  A[1861] = -t902;
  A[4417] = -t902;
  const T t903 = T(1.84) * t776;
  A[1862] = -t903;
  A[4489] = -t903;
  A[1898] = T(0.9638049599999999);
  const T t904 = T(1.84) * (T(0.362) * R9_21 - T(0.49) * R9_11);
  A[1908] = t904;
  A[2618] = t904;
  const T t905 = T(1.84) * (T(0.362) * R9_22 - T(0.49) * R9_12);
  A[1909] = t905;
  A[2690] = t905;
  const T t906 = T(1.84) * (T(0.362) * R9_23 - T(0.49) * R9_13);
  A[1910] = t906;
  A[2762] = t906;
  const T t907 = T(1.84) * t191;
  A[1911] = t907;
  A[2834] = t907;
  const T t908 = T(1.84) * t76;
  A[1912] = t908;
  A[2906] = t908;
  const T t909 = T(1.84) * t77;
  A[1913] = t909;
  A[2978] = t909;
  const T t910 = T(1.84) * t455;
  A[1923] = t910;
  A[3698] = t910;
  const T t911 = T(1.84) * t373;
  A[1924] = t911;
  A[3770] = t911;
  const T t912 = T(1.84) * t374;
  A[1925] = t912;
  A[3842] = t912;
  const T t913 = T(1.84) * t791;
  A[1932] = t913;
  A[4346] = t913;
  const T t914 = T(1.84) * t779;
  A[1933] = t914;
  A[4418] = t914;
  const T t915 = T(1.84) * t780;
  A[1934] = t915;
  A[4490] = t915;
  A[1971] = T(0.6059865999999999);
  A[1972] = T(0.01301424);
  A[2043] = T(0.01301424);
  A[1973] = T(0.027217119999999997);
  A[2115] = T(0.027217119999999997);
  const T t916 = T(2.57) * (T(0.426) * R10_21 + T(0.148) * R10_31);
  A[1980] = t916;
  A[2619] = t916;
  const T t917 = T(2.57) * (T(0.426) * R10_22 + T(0.148) * R10_32);
  A[1981] = t917;
  A[2691] = t917;
  const T t918 = T(2.57) * (T(0.426) * R10_23 + T(0.148) * R10_33);
  A[1982] = t918;
  A[2763] = t918;
  const T t919 = T(2.57) * t193;
  A[2001] = t919;
  A[4131] = t919;
  const T t920 = T(2.57) * t79;
  A[2002] = t920;
  A[4203] = t920;
  const T t921 = T(2.57) * t80;
  A[2003] = t921;
  A[4275] = t921;
  const T t922 = T(2.57) * t865;
  A[2007] = t922;
  A[4563] = t922;
  const T t923 = T(2.57) * t851;
  A[2008] = t923;
  A[4635] = t923;
  const T t924 = T(2.57) * t852;
  A[2009] = t924;
  A[4707] = t924;
  A[2044] = T(0.55875124);
  A[2045] = T(0.15553335999999998);
  A[2116] = T(0.15553335999999998);
  const T t925 = T(2.57) * (T(0.426) * R10_11 + T(0.016) * R10_31);
  A[2052] = -t925;
  A[2620] = -t925;
  const T t926 = T(2.57) * (T(0.426) * R10_12 + T(0.016) * R10_32);
  A[2053] = -t926;
  A[2692] = -t926;
  const T t927 = T(2.57) * (T(0.426) * R10_13 + T(0.016) * R10_33);
  A[2054] = -t927;
  A[2764] = -t927;
  const T t928 = T(2.57) * t195;
  A[2073] = -t928;
  A[4132] = -t928;
  const T t929 = T(2.57) * t83;
  A[2074] = -t929;
  A[4204] = -t929;
  const T t930 = T(2.57) * t82;
  A[2075] = -t930;
  A[4276] = -t930;
  const T t931 = T(2.57) * t867;
  A[2079] = -t931;
  A[4564] = -t931;
  const T t932 = T(2.57) * t855;
  A[2080] = -t932;
  A[4636] = -t932;
  const T t933 = T(2.57) * t854;
  A[2081] = -t933;
  A[4708] = -t933;
  A[2117] = T(0.16585119999999998);
  const T t934 = T(2.57) * (T(0.016) * R10_21 - T(0.148) * R10_11);
  A[2124] = t934;
  A[2621] = t934;
  const T t935 = T(2.57) * (T(0.016) * R10_22 - T(0.148) * R10_12);
  A[2125] = t935;
  A[2693] = t935;
  const T t936 = T(2.57) * (T(0.016) * R10_23 - T(0.148) * R10_13);
  A[2126] = t936;
  A[2765] = t936;
  const T t937 = T(2.57) * t197;
  A[2145] = t937;
  A[4133] = t937;
  const T t938 = T(2.57) * t85;
  A[2146] = t938;
  A[4205] = t938;
  const T t939 = T(2.57) * t86;
  A[2147] = t939;
  A[4277] = t939;
  const T t940 = T(2.57) * t869;
  A[2151] = t940;
  A[4565] = t940;
  const T t941 = T(2.57) * t857;
  A[2152] = t941;
  A[4637] = t941;
  const T t942 = T(2.57) * t858;
  A[2153] = t942;
  A[4709] = t942;
  const T t943 = d12_3 * d12_3;
  const T t944 = d12_2 * d12_2;
  A[2190] = T(1.25761721) + T(4.06) * (t943 + t944);
  const T t945 = T(0.52710792) - d12_2 * d12_1 * T(4.06);
  A[2191] = t945;
  A[2262] = t945;
  const T t946 = T(0.53453698) + d12_3 * d12_1 * T(4.06);
  A[2192] = -t946;
  A[2334] = -t946;
  const T t947 = T(0.1) * C11_12_22 - T(0.141) * C11_12_23;
  const T t948 = T(0.1) * C11_12_32 - T(0.141) * C11_12_33;
  const T t949 = T(4.06) * (d12_3 * t947 - d12_2 * t948);
  A[2193] = -t949;
  A[2406] = -t949;
  const T t950 = T(0.006) * C11_12_23 - T(0.1) * C11_12_21;
  const T t951 = T(0.006) * C11_12_33 - T(0.1) * C11_12_31;
  const T t952 = T(4.06) * (d12_3 * t950 - d12_2 * t951);
  A[2194] = -t952;
  A[2478] = -t952;
  const T t953 = T(0.141) * C11_12_21 - T(0.006) * C11_12_22;
  const T t954 = T(0.141) * C11_12_31 - T(0.006) * C11_12_32;
  const T t955 = T(4.06) * (d12_3 * t953 - d12_2 * t954);
  A[2195] = -t955;
  A[2550] = -t955;
  const T t956 = h11_2 * R11_31 - h11_3 * R11_21;
  A[2196] = t956;
  A[2622] = t956;
  const T t957 = h11_2 * R11_32 - h11_3 * R11_22;
  A[2197] = t957;
  A[2694] = t957;
  const T t958 = h11_2 * R11_33 - h11_3 * R11_23;
  A[2198] = t958;
  A[2766] = t958;
  A[2199] = t199;
  A[2838] = t199;
  A[2200] = t88;
  A[2910] = t88;
  A[2201] = t89;
  A[2982] = t89;
  A[2202] = t457;
  A[3054] = t457;
  A[2203] = t376;
  A[3126] = t376;
  A[2204] = t377;
  A[3198] = t377;
  A[2208] = t625;
  A[3486] = t625;
  A[2209] = t574;
  A[3558] = t574;
  A[2210] = t575;
  A[3630] = t575;
  A[2226] = t739;
  A[4782] = t739;
  A[2227] = t713;
  A[4854] = t713;
  A[2228] = t714;
  A[4926] = t714;
  A[2230] = -b11_3;
  A[2301] = b11_3;
  A[4999] = b11_3;
  A[5070] = -b11_3;
  A[2231] = b11_2;
  A[2373] = -b11_2;
  A[5000] = -b11_2;
  A[5142] = b11_2;
  const T t959 = d12_1 * d12_1;
  A[2263] = T(1.42770221) + T(4.06) * (t943 + t959);
  const T t960 = T(0.45453052) - d12_3 * d12_2 * T(4.06);
  A[2264] = t960;
  A[2335] = t960;
  const T t961 = T(0.1) * C11_12_12 - T(0.141) * C11_12_13;
  const T t962 = T(4.06) * (d12_1 * t948 - d12_3 * t961);
  A[2265] = -t962;
  A[2407] = -t962;
  const T t963 = T(0.006) * C11_12_13 - T(0.1) * C11_12_11;
  const T t964 = T(4.06) * (d12_1 * t951 - d12_3 * t963);
  A[2266] = -t964;
  A[2479] = -t964;
  const T t965 = T(0.141) * C11_12_11 - T(0.006) * C11_12_12;
  const T t966 = T(4.06) * (d12_1 * t954 - d12_3 * t965);
  A[2267] = -t966;
  A[2551] = -t966;
  const T t967 = h11_3 * R11_11 - h11_1 * R11_31;
  A[2268] = t967;
  A[2623] = t967;
  const T t968 = h11_3 * R11_12 - h11_1 * R11_32;
  A[2269] = t968;
  A[2695] = t968;
  const T t969 = h11_3 * R11_13 - h11_1 * R11_33;
  A[2270] = t969;
  A[2767] = t969;
  A[2271] = t201;
  A[2839] = t201;
  A[2272] = t91;
  A[2911] = t91;
  A[2273] = t92;
  A[2983] = t92;
  A[2274] = t459;
  A[3055] = t459;
  A[2275] = t379;
  A[3127] = t379;
  A[2276] = t380;
  A[3199] = t380;
  A[2280] = t627;
  A[3487] = t627;
  A[2281] = t577;
  A[3559] = t577;
  A[2282] = t578;
  A[3631] = t578;
  A[2298] = t741;
  A[4783] = t741;
  A[2299] = t716;
  A[4855] = t716;
  A[2300] = t717;
  A[4927] = t717;
  A[2303] = -b11_1;
  A[2374] = b11_1;
  A[5072] = b11_1;
  A[5143] = -b11_1;
  A[2336] = T(1.49770916) + T(4.06) * (t944 + t959);
  const T t970 = T(4.06) * (d12_2 * t961 - d12_1 * t947);
  A[2337] = -t970;
  A[2408] = -t970;
  const T t971 = T(4.06) * (d12_2 * t963 - d12_1 * t950);
  A[2338] = -t971;
  A[2480] = -t971;
  const T t972 = T(4.06) * (d12_2 * t965 - d12_1 * t953);
  A[2339] = -t972;
  A[2552] = -t972;
  const T t973 = h11_1 * R11_21 - h11_2 * R11_11;
  A[2340] = t973;
  A[2624] = t973;
  const T t974 = h11_1 * R11_22 - h11_2 * R11_12;
  A[2341] = t974;
  A[2696] = t974;
  const T t975 = h11_1 * R11_23 - h11_2 * R11_13;
  A[2342] = t975;
  A[2768] = t975;
  A[2343] = t203;
  A[2840] = t203;
  A[2344] = t94;
  A[2912] = t94;
  A[2345] = t95;
  A[2984] = t95;
  A[2346] = t461;
  A[3056] = t461;
  A[2347] = t382;
  A[3128] = t382;
  A[2348] = t383;
  A[3200] = t383;
  A[2352] = t629;
  A[3488] = t629;
  A[2353] = t580;
  A[3560] = t580;
  A[2354] = t581;
  A[3632] = t581;
  A[2370] = t743;
  A[4784] = t743;
  A[2371] = t719;
  A[4856] = t719;
  A[2372] = t720;
  A[4928] = t720;
  A[2409] = T(0.53501686);
  A[2410] = T(0.00866524);
  A[2481] = T(0.00866524);
  A[2411] = -T(0.11083599999999999);
  A[2553] = -T(0.11083599999999999);
  const T t976 = T(4.06) * (T(0.1) * R12_21 - T(0.141) * R12_31);
  A[2412] = t976;
  A[2625] = t976;
  const T t977 = T(4.06) * (T(0.1) * R12_22 - T(0.141) * R12_32);
  A[2413] = t977;
  A[2697] = t977;
  const T t978 = T(4.06) * (T(0.1) * R12_23 - T(0.141) * R12_33);
  A[2414] = t978;
  A[2769] = t978;
  const T t979 = T(4.06) * t205;
  A[2415] = t979;
  A[2841] = t979;
  const T t980 = T(4.06) * t97;
  A[2416] = t980;
  A[2913] = t980;
  const T t981 = T(4.06) * t98;
  A[2417] = t981;
  A[2985] = t981;
  const T t982 = T(4.06) * t463;
  A[2418] = t982;
  A[3057] = t982;
  const T t983 = T(4.06) * t385;
  A[2419] = t983;
  A[3129] = t983;
  const T t984 = T(4.06) * t386;
  A[2420] = t984;
  A[3201] = t984;
  const T t985 = T(4.06) * t631;
  A[2424] = t985;
  A[3489] = t985;
  const T t986 = T(4.06) * t583;
  A[2425] = t986;
  A[3561] = t986;
  const T t987 = T(4.06) * t584;
  A[2426] = t987;
  A[3633] = t987;
  const T t988 = T(4.06) * t745;
  A[2442] = t988;
  A[4785] = t988;
  const T t989 = T(4.06) * t722;
  A[2443] = t989;
  A[4857] = t989;
  const T t990 = T(4.06) * t723;
  A[2444] = t990;
  A[4929] = t990;
  const T t991 = T(4.06) * t961;
  A[2445] = t991;
  A[5001] = t991;
  const T t992 = T(4.06) * t947;
  A[2446] = t992;
  A[5073] = t992;
  const T t993 = T(4.06) * t948;
  A[2447] = t993;
  A[5145] = t993;
  A[2482] = T(0.6359461599999999);
  A[2483] = -T(0.059545999999999995);
  A[2554] = -T(0.059545999999999995);
  const T t994 = T(4.06) * (T(0.006) * R12_31 - T(0.1) * R12_11);
  A[2484] = t994;
  A[2626] = t994;
  const T t995 = T(4.06) * (T(0.006) * R12_32 - T(0.1) * R12_12);
  A[2485] = t995;
  A[2698] = t995;
  const T t996 = T(4.06) * (T(0.006) * R12_33 - T(0.1) * R12_13);
  A[2486] = t996;
  A[2770] = t996;
  const T t997 = T(4.06) * t207;
  A[2487] = t997;
  A[2842] = t997;
  const T t998 = T(4.06) * t100;
  A[2488] = t998;
  A[2914] = t998;
  const T t999 = T(4.06) * t101;
  A[2489] = t999;
  A[2986] = t999;
  const T t1000 = T(4.06) * t465;
  A[2490] = t1000;
  A[3058] = t1000;
  const T t1001 = T(4.06) * t388;
  A[2491] = t1001;
  A[3130] = t1001;
  const T t1002 = T(4.06) * t389;
  A[2492] = t1002;
  A[3202] = t1002;
  const T t1003 = T(4.06) * t633;
  A[2496] = t1003;
  A[3490] = t1003;
  const T t1004 = T(4.06) * t586;
  A[2497] = t1004;
  A[3562] = t1004;
  const T t1005 = T(4.06) * t587;
  A[2498] = t1005;
  A[3634] = t1005;
  const T t1006 = T(4.06) * t747;
  A[2514] = t1006;
  A[4786] = t1006;
  const T t1007 = T(4.06) * t725;
  A[2515] = t1007;
  A[4858] = t1007;
  const T t1008 = T(4.06) * t726;
  A[2516] = t1008;
  A[4930] = t1008;
  const T t1009 = T(4.06) * t963;
  A[2517] = t1009;
  A[5002] = t1009;
  const T t1010 = T(4.06) * t950;
  A[2518] = t1010;
  A[5074] = t1010;
  const T t1011 = T(4.06) * t951;
  A[2519] = t1011;
  A[5146] = t1011;
  A[2555] = T(0.40846301999999995);
  const T t1012 = T(4.06) * (T(0.141) * R12_11 - T(0.006) * R12_21);
  A[2556] = t1012;
  A[2627] = t1012;
  const T t1013 = T(4.06) * (T(0.141) * R12_12 - T(0.006) * R12_22);
  A[2557] = t1013;
  A[2699] = t1013;
  const T t1014 = T(4.06) * (T(0.141) * R12_13 - T(0.006) * R12_23);
  A[2558] = t1014;
  A[2771] = t1014;
  const T t1015 = T(4.06) * t209;
  A[2559] = t1015;
  A[2843] = t1015;
  const T t1016 = T(4.06) * t103;
  A[2560] = t1016;
  A[2915] = t1016;
  const T t1017 = T(4.06) * t104;
  A[2561] = t1017;
  A[2987] = t1017;
  const T t1018 = T(4.06) * t467;
  A[2562] = t1018;
  A[3059] = t1018;
  const T t1019 = T(4.06) * t391;
  A[2563] = t1019;
  A[3131] = t1019;
  const T t1020 = T(4.06) * t392;
  A[2564] = t1020;
  A[3203] = t1020;
  const T t1021 = T(4.06) * t635;
  A[2568] = t1021;
  A[3491] = t1021;
  const T t1022 = T(4.06) * t589;
  A[2569] = t1022;
  A[3563] = t1022;
  const T t1023 = T(4.06) * t590;
  A[2570] = t1023;
  A[3635] = t1023;
  const T t1024 = T(4.06) * t749;
  A[2586] = t1024;
  A[4787] = t1024;
  const T t1025 = T(4.06) * t728;
  A[2587] = t1025;
  A[4859] = t1025;
  const T t1026 = T(4.06) * t729;
  A[2588] = t1026;
  A[4931] = t1026;
  const T t1027 = T(4.06) * t965;
  A[2589] = t1027;
  A[5003] = t1027;
  const T t1028 = T(4.06) * t953;
  A[2590] = t1028;
  A[5075] = t1028;
  const T t1029 = T(4.06) * t954;
  A[2591] = t1029;
  A[5147] = t1029;
  A[2628] = T(32.55);
  A[2701] = T(32.55);
  A[2774] = T(32.55);
  const T t1030 = T(23.12) * R1_11;
  A[2631] = t1030;
  A[2844] = t1030;
  const T t1031 = T(23.12) * R1_21;
  A[2632] = t1031;
  A[2916] = t1031;
  const T t1032 = T(23.12) * R1_31;
  A[2633] = t1032;
  A[2988] = t1032;
  const T t1033 = T(17.16) * R2_11;
  A[2634] = t1033;
  A[3060] = t1033;
  const T t1034 = T(17.16) * R2_21;
  A[2635] = t1034;
  A[3132] = t1034;
  const T t1035 = T(17.16) * R2_31;
  A[2636] = t1035;
  A[3204] = t1035;
  const T t1036 = T(5.23) * R3_11;
  A[2637] = t1036;
  A[3276] = t1036;
  const T t1037 = T(5.23) * R3_21;
  A[2638] = t1037;
  A[3348] = t1037;
  const T t1038 = T(5.23) * R3_31;
  A[2639] = t1038;
  A[3420] = t1038;
  const T t1039 = T(9.79) * R3_11;
  A[2640] = t1039;
  A[3492] = t1039;
  const T t1040 = T(9.79) * R3_21;
  A[2641] = t1040;
  A[3564] = t1040;
  const T t1041 = T(9.79) * R3_31;
  A[2642] = t1041;
  A[3636] = t1041;
  const T t1042 = T(5.32) * R2_11;
  A[2643] = t1042;
  A[3708] = t1042;
  const T t1043 = T(5.32) * R2_21;
  A[2644] = t1043;
  A[3780] = t1043;
  const T t1044 = T(5.32) * R2_31;
  A[2645] = t1044;
  A[3852] = t1044;
  const T t1045 = T(0.74) * R4_11;
  A[2646] = t1045;
  A[3924] = t1045;
  const T t1046 = T(0.74) * R4_21;
  A[2647] = t1046;
  A[3996] = t1046;
  const T t1047 = T(0.74) * R4_31;
  A[2648] = t1047;
  A[4068] = t1047;
  const T t1048 = T(5.279999999999999) * R1_11;
  A[2649] = t1048;
  A[4140] = t1048;
  const T t1049 = T(5.279999999999999) * R1_21;
  A[2650] = t1049;
  A[4212] = t1049;
  const T t1050 = T(5.279999999999999) * R1_31;
  A[2651] = t1050;
  A[4284] = t1050;
  const T t1051 = T(1.84) * R6_11;
  A[2652] = t1051;
  A[4356] = t1051;
  const T t1052 = T(1.84) * R6_21;
  A[2653] = t1052;
  A[4428] = t1052;
  const T t1053 = T(1.84) * R6_31;
  A[2654] = t1053;
  A[4500] = t1053;
  const T t1054 = T(2.57) * R8_11;
  A[2655] = t1054;
  A[4572] = t1054;
  const T t1055 = T(2.57) * R8_21;
  A[2656] = t1055;
  A[4644] = t1055;
  const T t1056 = T(2.57) * R8_31;
  A[2657] = t1056;
  A[4716] = t1056;
  const T t1057 = T(7.83) * R5_11;
  A[2658] = t1057;
  A[4788] = t1057;
  const T t1058 = T(7.83) * R5_21;
  A[2659] = t1058;
  A[4860] = t1058;
  const T t1059 = T(7.83) * R5_31;
  A[2660] = t1059;
  A[4932] = t1059;
  const T t1060 = T(4.06) * R11_11;
  A[2661] = t1060;
  A[5004] = t1060;
  const T t1061 = T(4.06) * R11_21;
  A[2662] = t1061;
  A[5076] = t1061;
  const T t1062 = T(4.06) * R11_31;
  A[2663] = t1062;
  A[5148] = t1062;
  const T t1063 = T(23.12) * R1_12;
  A[2703] = t1063;
  A[2845] = t1063;
  const T t1064 = T(23.12) * R1_22;
  A[2704] = t1064;
  A[2917] = t1064;
  const T t1065 = T(23.12) * R1_32;
  A[2705] = t1065;
  A[2989] = t1065;
  const T t1066 = T(17.16) * R2_12;
  A[2706] = t1066;
  A[3061] = t1066;
  const T t1067 = T(17.16) * R2_22;
  A[2707] = t1067;
  A[3133] = t1067;
  const T t1068 = T(17.16) * R2_32;
  A[2708] = t1068;
  A[3205] = t1068;
  const T t1069 = T(5.23) * R3_12;
  A[2709] = t1069;
  A[3277] = t1069;
  const T t1070 = T(5.23) * R3_22;
  A[2710] = t1070;
  A[3349] = t1070;
  const T t1071 = T(5.23) * R3_32;
  A[2711] = t1071;
  A[3421] = t1071;
  const T t1072 = T(9.79) * R3_12;
  A[2712] = t1072;
  A[3493] = t1072;
  const T t1073 = T(9.79) * R3_22;
  A[2713] = t1073;
  A[3565] = t1073;
  const T t1074 = T(9.79) * R3_32;
  A[2714] = t1074;
  A[3637] = t1074;
  const T t1075 = T(5.32) * R2_12;
  A[2715] = t1075;
  A[3709] = t1075;
  const T t1076 = T(5.32) * R2_22;
  A[2716] = t1076;
  A[3781] = t1076;
  const T t1077 = T(5.32) * R2_32;
  A[2717] = t1077;
  A[3853] = t1077;
  const T t1078 = T(0.74) * R4_12;
  A[2718] = t1078;
  A[3925] = t1078;
  const T t1079 = T(0.74) * R4_22;
  A[2719] = t1079;
  A[3997] = t1079;
  const T t1080 = T(0.74) * R4_32;
  A[2720] = t1080;
  A[4069] = t1080;
  const T t1081 = T(5.279999999999999) * R1_12;
  A[2721] = t1081;
  A[4141] = t1081;
  const T t1082 = T(5.279999999999999) * R1_22;
  A[2722] = t1082;
  A[4213] = t1082;
  const T t1083 = T(5.279999999999999) * R1_32;
  A[2723] = t1083;
  A[4285] = t1083;
  const T t1084 = T(1.84) * R6_12;
  A[2724] = t1084;
  A[4357] = t1084;
  const T t1085 = T(1.84) * R6_22;
  A[2725] = t1085;
  A[4429] = t1085;
  const T t1086 = T(1.84) * R6_32;
  A[2726] = t1086;
  A[4501] = t1086;
  const T t1087 = T(2.57) * R8_12;
  A[2727] = t1087;
  A[4573] = t1087;
  const T t1088 = T(2.57) * R8_22;
  A[2728] = t1088;
  A[4645] = t1088;
  const T t1089 = T(2.57) * R8_32;
  A[2729] = t1089;
  A[4717] = t1089;
  const T t1090 = T(7.83) * R5_12;
  A[2730] = t1090;
  A[4789] = t1090;
  const T t1091 = T(7.83) * R5_22;
  A[2731] = t1091;
  A[4861] = t1091;
  const T t1092 = T(7.83) * R5_32;
  A[2732] = t1092;
  A[4933] = t1092;
  const T t1093 = T(4.06) * R11_12;
  A[2733] = t1093;
  A[5005] = t1093;
  const T t1094 = T(4.06) * R11_22;
  A[2734] = t1094;
  A[5077] = t1094;
  const T t1095 = T(4.06) * R11_32;
  A[2735] = t1095;
  A[5149] = t1095;
  const T t1096 = T(23.12) * R1_13;
  A[2775] = t1096;
  A[2846] = t1096;
  const T t1097 = T(23.12) * R1_23;
  A[2776] = t1097;
  A[2918] = t1097;
  const T t1098 = T(23.12) * R1_33;
  A[2777] = t1098;
  A[2990] = t1098;
  const T t1099 = T(17.16) * R2_13;
  A[2778] = t1099;
  A[3062] = t1099;
  const T t1100 = T(17.16) * R2_23;
  A[2779] = t1100;
  A[3134] = t1100;
  const T t1101 = T(17.16) * R2_33;
  A[2780] = t1101;
  A[3206] = t1101;
  const T t1102 = T(5.23) * R3_13;
  A[2781] = t1102;
  A[3278] = t1102;
  const T t1103 = T(5.23) * R3_23;
  A[2782] = t1103;
  A[3350] = t1103;
  const T t1104 = T(5.23) * R3_33;
  A[2783] = t1104;
  A[3422] = t1104;
  const T t1105 = T(9.79) * R3_13;
  A[2784] = t1105;
  A[3494] = t1105;
  const T t1106 = T(9.79) * R3_23;
  A[2785] = t1106;
  A[3566] = t1106;
  const T t1107 = T(9.79) * R3_33;
  A[2786] = t1107;
  A[3638] = t1107;
  const T t1108 = T(5.32) * R2_13;
  A[2787] = t1108;
  A[3710] = t1108;
  const T t1109 = T(5.32) * R2_23;
  A[2788] = t1109;
  A[3782] = t1109;
  const T t1110 = T(5.32) * R2_33;
  A[2789] = t1110;
  A[3854] = t1110;
  const T t1111 = T(0.74) * R4_13;
  A[2790] = t1111;
  A[3926] = t1111;
  const T t1112 = T(0.74) * R4_23;
  A[2791] = t1112;
  A[3998] = t1112;
  const T t1113 = T(0.74) * R4_33;
  A[2792] = t1113;
  A[4070] = t1113;
  const T t1114 = T(5.279999999999999) * R1_13;
  A[2793] = t1114;
  A[4142] = t1114;
  const T t1115 = T(5.279999999999999) * R1_23;
  A[2794] = t1115;
  A[4214] = t1115;
  const T t1116 = T(5.279999999999999) * R1_33;
  A[2795] = t1116;
  A[4286] = t1116;
  const T t1117 = T(1.84) * R6_13;
  A[2796] = t1117;
  A[4358] = t1117;
  const T t1118 = T(1.84) * R6_23;
  A[2797] = t1118;
  A[4430] = t1118;
  const T t1119 = T(1.84) * R6_33;
  A[2798] = t1119;
  A[4502] = t1119;
  const T t1120 = T(2.57) * R8_13;
  A[2799] = t1120;
  A[4574] = t1120;
  const T t1121 = T(2.57) * R8_23;
  A[2800] = t1121;
  A[4646] = t1121;
  const T t1122 = T(2.57) * R8_33;
  A[2801] = t1122;
  A[4718] = t1122;
  const T t1123 = T(7.83) * R5_13;
  A[2802] = t1123;
  A[4790] = t1123;
  const T t1124 = T(7.83) * R5_23;
  A[2803] = t1124;
  A[4862] = t1124;
  const T t1125 = T(7.83) * R5_33;
  A[2804] = t1125;
  A[4934] = t1125;
  const T t1126 = T(4.06) * R11_13;
  A[2805] = t1126;
  A[5006] = t1126;
  const T t1127 = T(4.06) * R11_23;
  A[2806] = t1127;
  A[5078] = t1127;
  const T t1128 = T(4.06) * R11_33;
  A[2807] = t1128;
  A[5150] = t1128;
  A[2847] = T(23.12);
  A[2920] = T(23.12);
  A[2993] = T(23.12);
  const T t1129 = T(17.16) * C1_2_11;
  A[2850] = t1129;
  A[3063] = t1129;
  const T t1130 = T(17.16) * C1_2_12;
  A[2851] = t1130;
  A[3135] = t1130;
  const T t1131 = T(17.16) * C1_2_13;
  A[2852] = t1131;
  A[3207] = t1131;
  const T t1132 = T(5.23) * C1_3_11;
  A[2853] = t1132;
  A[3279] = t1132;
  const T t1133 = T(5.23) * C1_3_12;
  A[2854] = t1133;
  A[3351] = t1133;
  const T t1134 = T(5.23) * C1_3_13;
  A[2855] = t1134;
  A[3423] = t1134;
  const T t1135 = T(9.79) * C1_3_11;
  A[2856] = t1135;
  A[3495] = t1135;
  const T t1136 = T(9.79) * C1_3_12;
  A[2857] = t1136;
  A[3567] = t1136;
  const T t1137 = T(9.79) * C1_3_13;
  A[2858] = t1137;
  A[3639] = t1137;
  const T t1138 = T(5.32) * C1_2_11;
  A[2859] = t1138;
  A[3711] = t1138;
  const T t1139 = T(5.32) * C1_2_12;
  A[2860] = t1139;
  A[3783] = t1139;
  const T t1140 = T(5.32) * C1_2_13;
  A[2861] = t1140;
  A[3855] = t1140;
  const T t1141 = T(0.74) * C1_4_11;
  A[2862] = t1141;
  A[3927] = t1141;
  const T t1142 = T(0.74) * C1_4_12;
  A[2863] = t1142;
  A[3999] = t1142;
  const T t1143 = T(0.74) * C1_4_13;
  A[2864] = t1143;
  A[4071] = t1143;
  const T t1144 = T(1.84) * C1_6_11;
  A[2868] = t1144;
  A[4359] = t1144;
  const T t1145 = T(1.84) * C1_6_12;
  A[2869] = t1145;
  A[4431] = t1145;
  const T t1146 = T(1.84) * C1_6_13;
  A[2870] = t1146;
  A[4503] = t1146;
  const T t1147 = T(7.83) * C1_5_11;
  A[2874] = t1147;
  A[4791] = t1147;
  const T t1148 = T(7.83) * C1_5_12;
  A[2875] = t1148;
  A[4863] = t1148;
  const T t1149 = T(7.83) * C1_5_13;
  A[2876] = t1149;
  A[4935] = t1149;
  const T t1150 = T(4.06) * C1_11_11;
  A[2877] = t1150;
  A[5007] = t1150;
  const T t1151 = T(4.06) * C1_11_12;
  A[2878] = t1151;
  A[5079] = t1151;
  const T t1152 = T(4.06) * C1_11_13;
  A[2879] = t1152;
  A[5151] = t1152;
  const T t1153 = T(17.16) * C1_2_21;
  A[2922] = t1153;
  A[3064] = t1153;
  const T t1154 = T(17.16) * C1_2_22;
  A[2923] = t1154;
  A[3136] = t1154;
  const T t1155 = T(17.16) * C1_2_23;
  A[2924] = t1155;
  A[3208] = t1155;
  const T t1156 = T(5.23) * C1_3_21;
  A[2925] = t1156;
  A[3280] = t1156;
  const T t1157 = T(5.23) * C1_3_22;
  A[2926] = t1157;
  A[3352] = t1157;
  const T t1158 = T(5.23) * C1_3_23;
  A[2927] = t1158;
  A[3424] = t1158;
  const T t1159 = T(9.79) * C1_3_21;
  A[2928] = t1159;
  A[3496] = t1159;
  const T t1160 = T(9.79) * C1_3_22;
  A[2929] = t1160;
  A[3568] = t1160;
  const T t1161 = T(9.79) * C1_3_23;
  A[2930] = t1161;
  A[3640] = t1161;
  const T t1162 = T(5.32) * C1_2_21;
  A[2931] = t1162;
  A[3712] = t1162;
  const T t1163 = T(5.32) * C1_2_22;
  A[2932] = t1163;
  A[3784] = t1163;
  const T t1164 = T(5.32) * C1_2_23;
  A[2933] = t1164;
  A[3856] = t1164;
  const T t1165 = T(0.74) * C1_4_21;
  A[2934] = t1165;
  A[3928] = t1165;
  const T t1166 = T(0.74) * C1_4_22;
  A[2935] = t1166;
  A[4000] = t1166;
  const T t1167 = T(0.74) * C1_4_23;
  A[2936] = t1167;
  A[4072] = t1167;
  const T t1168 = T(1.84) * C1_6_21;
  A[2940] = t1168;
  A[4360] = t1168;
  const T t1169 = T(1.84) * C1_6_22;
  A[2941] = t1169;
  A[4432] = t1169;
  const T t1170 = T(1.84) * C1_6_23;
  A[2942] = t1170;
  A[4504] = t1170;
  const T t1171 = T(7.83) * C1_5_21;
  A[2946] = t1171;
  A[4792] = t1171;
  const T t1172 = T(7.83) * C1_5_22;
  A[2947] = t1172;
  A[4864] = t1172;
  const T t1173 = T(7.83) * C1_5_23;
  A[2948] = t1173;
  A[4936] = t1173;
  const T t1174 = T(4.06) * C1_11_21;
  A[2949] = t1174;
  A[5008] = t1174;
  const T t1175 = T(4.06) * C1_11_22;
  A[2950] = t1175;
  A[5080] = t1175;
  const T t1176 = T(4.06) * C1_11_23;
  A[2951] = t1176;
  A[5152] = t1176;
  const T t1177 = T(17.16) * C1_2_31;
  A[2994] = t1177;
  A[3065] = t1177;
  const T t1178 = T(17.16) * C1_2_32;
  A[2995] = t1178;
  A[3137] = t1178;
  const T t1179 = T(17.16) * C1_2_33;
  A[2996] = t1179;
  A[3209] = t1179;
  const T t1180 = T(5.23) * C1_3_31;
  A[2997] = t1180;
  A[3281] = t1180;
  const T t1181 = T(5.23) * C1_3_32;
  A[2998] = t1181;
  A[3353] = t1181;
  const T t1182 = T(5.23) * C1_3_33;
  A[2999] = t1182;
  A[3425] = t1182;
  const T t1183 = T(9.79) * C1_3_31;
  A[3000] = t1183;
  A[3497] = t1183;
  const T t1184 = T(9.79) * C1_3_32;
  A[3001] = t1184;
  A[3569] = t1184;
  const T t1185 = T(9.79) * C1_3_33;
  A[3002] = t1185;
  A[3641] = t1185;
  const T t1186 = T(5.32) * C1_2_31;
  A[3003] = t1186;
  A[3713] = t1186;
  const T t1187 = T(5.32) * C1_2_32;
  A[3004] = t1187;
  A[3785] = t1187;
  const T t1188 = T(5.32) * C1_2_33;
  A[3005] = t1188;
  A[3857] = t1188;
  const T t1189 = T(0.74) * C1_4_31;
  A[3006] = t1189;
  A[3929] = t1189;
  const T t1190 = T(0.74) * C1_4_32;
  A[3007] = t1190;
  A[4001] = t1190;
  const T t1191 = T(0.74) * C1_4_33;
  A[3008] = t1191;
  A[4073] = t1191;
  const T t1192 = T(1.84) * C1_6_31;
  A[3012] = t1192;
  A[4361] = t1192;
  const T t1193 = T(1.84) * C1_6_32;
  A[3013] = t1193;
  A[4433] = t1193;
  const T t1194 = T(1.84) * C1_6_33;
  A[3014] = t1194;
  A[4505] = t1194;
  const T t1195 = T(7.83) * C1_5_31;
  A[3018] = t1195;
  A[4793] = t1195;
  const T t1196 = T(7.83) * C1_5_32;
  A[3019] = t1196;
  A[4865] = t1196;
  const T t1197 = T(7.83) * C1_5_33;
  A[3020] = t1197;
  A[4937] = t1197;
  const T t1198 = T(4.06) * C1_11_31;
  A[3021] = t1198;
  A[5009] = t1198;
  const T t1199 = T(4.06) * C1_11_32;
  A[3022] = t1199;
  A[5081] = t1199;
  const T t1200 = T(4.06) * C1_11_33;
  A[3023] = t1200;
  A[5153] = t1200;
  A[3066] = T(17.16);
  A[3139] = T(17.16);
  A[3212] = T(17.16);
  const T t1201 = T(5.23) * C2_3_11;
  A[3069] = t1201;
  A[3282] = t1201;
  const T t1202 = T(5.23) * C2_3_12;
  A[3070] = t1202;
  A[3354] = t1202;
  const T t1203 = T(5.23) * C2_3_13;
  A[3071] = t1203;
  A[3426] = t1203;
  const T t1204 = T(9.79) * C2_3_11;
  A[3072] = t1204;
  A[3498] = t1204;
  const T t1205 = T(9.79) * C2_3_12;
  A[3073] = t1205;
  A[3570] = t1205;
  const T t1206 = T(9.79) * C2_3_13;
  A[3074] = t1206;
  A[3642] = t1206;
  const T t1207 = T(0.74) * C2_4_11;
  A[3078] = t1207;
  A[3930] = t1207;
  const T t1208 = T(0.74) * C2_4_12;
  A[3079] = t1208;
  A[4002] = t1208;
  const T t1209 = T(0.74) * C2_4_13;
  A[3080] = t1209;
  A[4074] = t1209;
  const T t1210 = T(7.83) * C2_5_11;
  A[3090] = t1210;
  A[4794] = t1210;
  const T t1211 = T(7.83) * C2_5_12;
  A[3091] = t1211;
  A[4866] = t1211;
  const T t1212 = T(7.83) * C2_5_13;
  A[3092] = t1212;
  A[4938] = t1212;
  const T t1213 = T(4.06) * C2_11_11;
  A[3093] = t1213;
  A[5010] = t1213;
  const T t1214 = T(4.06) * C2_11_12;
  A[3094] = t1214;
  A[5082] = t1214;
  const T t1215 = T(4.06) * C2_11_13;
  A[3095] = t1215;
  A[5154] = t1215;
  const T t1216 = T(5.23) * C2_3_21;
  A[3141] = t1216;
  A[3283] = t1216;
  const T t1217 = T(5.23) * C2_3_22;
  A[3142] = t1217;
  A[3355] = t1217;
  const T t1218 = T(5.23) * C2_3_23;
  A[3143] = t1218;
  A[3427] = t1218;
  const T t1219 = T(9.79) * C2_3_21;
  A[3144] = t1219;
  A[3499] = t1219;
  const T t1220 = T(9.79) * C2_3_22;
  A[3145] = t1220;
  A[3571] = t1220;
  const T t1221 = T(9.79) * C2_3_23;
  A[3146] = t1221;
  A[3643] = t1221;
  const T t1222 = T(0.74) * C2_4_21;
  A[3150] = t1222;
  A[3931] = t1222;
  const T t1223 = T(0.74) * C2_4_22;
  A[3151] = t1223;
  A[4003] = t1223;
  const T t1224 = T(0.74) * C2_4_23;
  A[3152] = t1224;
  A[4075] = t1224;
  const T t1225 = T(7.83) * C2_5_21;
  A[3162] = t1225;
  A[4795] = t1225;
  const T t1226 = T(7.83) * C2_5_22;
  A[3163] = t1226;
  A[4867] = t1226;
  const T t1227 = T(7.83) * C2_5_23;
  A[3164] = t1227;
  A[4939] = t1227;
  const T t1228 = T(4.06) * C2_11_21;
  A[3165] = t1228;
  A[5011] = t1228;
  const T t1229 = T(4.06) * C2_11_22;
  A[3166] = t1229;
  A[5083] = t1229;
  const T t1230 = T(4.06) * C2_11_23;
  A[3167] = t1230;
  A[5155] = t1230;
  const T t1231 = T(5.23) * C2_3_31;
  A[3213] = t1231;
  A[3284] = t1231;
  const T t1232 = T(5.23) * C2_3_32;
  A[3214] = t1232;
  A[3356] = t1232;
  const T t1233 = T(5.23) * C2_3_33;
  A[3215] = t1233;
  A[3428] = t1233;
  const T t1234 = T(9.79) * C2_3_31;
  A[3216] = t1234;
  A[3500] = t1234;
  const T t1235 = T(9.79) * C2_3_32;
  A[3217] = t1235;
  A[3572] = t1235;
  const T t1236 = T(9.79) * C2_3_33;
  A[3218] = t1236;
  A[3644] = t1236;
  const T t1237 = T(0.74) * C2_4_31;
  A[3222] = t1237;
  A[3932] = t1237;
  const T t1238 = T(0.74) * C2_4_32;
  A[3223] = t1238;
  A[4004] = t1238;
  const T t1239 = T(0.74) * C2_4_33;
  A[3224] = t1239;
  A[4076] = t1239;
  const T t1240 = T(7.83) * C2_5_31;
  A[3234] = t1240;
  A[4796] = t1240;
  const T t1241 = T(7.83) * C2_5_32;
  A[3235] = t1241;
  A[4868] = t1241;
  const T t1242 = T(7.83) * C2_5_33;
  A[3236] = t1242;
  A[4940] = t1242;
  const T t1243 = T(4.06) * C2_11_31;
  A[3237] = t1243;
  A[5012] = t1243;
  const T t1244 = T(4.06) * C2_11_32;
  A[3238] = t1244;
  A[5084] = t1244;
  const T t1245 = T(4.06) * C2_11_33;
  A[3239] = t1245;
  A[5156] = t1245;
  A[3285] = T(5.23);
  A[3358] = T(5.23);
  A[3431] = T(5.23);
  const T t1246 = T(0.74) * C3_4_11;
  A[3294] = t1246;
  A[3933] = t1246;
  const T t1247 = T(0.74) * C3_4_12;
  A[3295] = t1247;
  A[4005] = t1247;
  const T t1248 = T(0.74) * C3_4_13;
  A[3296] = t1248;
  A[4077] = t1248;
  const T t1249 = T(0.74) * C3_4_21;
  A[3366] = t1249;
  A[3934] = t1249;
  const T t1250 = T(0.74) * C3_4_22;
  A[3367] = t1250;
  A[4006] = t1250;
  const T t1251 = T(0.74) * C3_4_23;
  A[3368] = t1251;
  A[4078] = t1251;
  const T t1252 = T(0.74) * C3_4_31;
  A[3438] = t1252;
  A[3935] = t1252;
  const T t1253 = T(0.74) * C3_4_32;
  A[3439] = t1253;
  A[4007] = t1253;
  const T t1254 = T(0.74) * C3_4_33;
  A[3440] = t1254;
  A[4079] = t1254;
  A[3504] = T(9.79);
  A[3577] = T(9.79);
  A[3650] = T(9.79);
  const T t1255 = T(7.83) * C3_5_11;
  A[3522] = t1255;
  A[4800] = t1255;
  const T t1256 = T(7.83) * C3_5_12;
  A[3523] = t1256;
  A[4872] = t1256;
  const T t1257 = T(7.83) * C3_5_13;
  A[3524] = t1257;
  A[4944] = t1257;
  const T t1258 = T(4.06) * C3_11_11;
  A[3525] = t1258;
  A[5016] = t1258;
  const T t1259 = T(4.06) * C3_11_12;
  A[3526] = t1259;
  A[5088] = t1259;
  const T t1260 = T(4.06) * C3_11_13;
  A[3527] = t1260;
  A[5160] = t1260;
  const T t1261 = T(7.83) * C3_5_21;
  A[3594] = t1261;
  A[4801] = t1261;
  const T t1262 = T(7.83) * C3_5_22;
  A[3595] = t1262;
  A[4873] = t1262;
  const T t1263 = T(7.83) * C3_5_23;
  A[3596] = t1263;
  A[4945] = t1263;
  const T t1264 = T(4.06) * C3_11_21;
  A[3597] = t1264;
  A[5017] = t1264;
  const T t1265 = T(4.06) * C3_11_22;
  A[3598] = t1265;
  A[5089] = t1265;
  const T t1266 = T(4.06) * C3_11_23;
  A[3599] = t1266;
  A[5161] = t1266;
  const T t1267 = T(7.83) * C3_5_31;
  A[3666] = t1267;
  A[4802] = t1267;
  const T t1268 = T(7.83) * C3_5_32;
  A[3667] = t1268;
  A[4874] = t1268;
  const T t1269 = T(7.83) * C3_5_33;
  A[3668] = t1269;
  A[4946] = t1269;
  const T t1270 = T(4.06) * C3_11_31;
  A[3669] = t1270;
  A[5018] = t1270;
  const T t1271 = T(4.06) * C3_11_32;
  A[3670] = t1271;
  A[5090] = t1271;
  const T t1272 = T(4.06) * C3_11_33;
  A[3671] = t1272;
  A[5162] = t1272;
  A[3723] = T(5.32);
  A[3796] = T(5.32);
  A[3869] = T(5.32);
  const T t1273 = T(1.84) * C2_6_11;
  A[3732] = t1273;
  A[4371] = t1273;
  const T t1274 = T(1.84) * C2_6_12;
  A[3733] = t1274;
  A[4443] = t1274;
  const T t1275 = T(1.84) * C2_6_13;
  A[3734] = t1275;
  A[4515] = t1275;
  const T t1276 = T(1.84) * C2_6_21;
  A[3804] = t1276;
  A[4372] = t1276;
  const T t1277 = T(1.84) * C2_6_22;
  A[3805] = t1277;
  A[4444] = t1277;
  const T t1278 = T(1.84) * C2_6_23;
  A[3806] = t1278;
  A[4516] = t1278;
  const T t1279 = T(1.84) * C2_6_31;
  A[3876] = t1279;
  A[4373] = t1279;
  const T t1280 = T(1.84) * C2_6_32;
  A[3877] = t1280;
  A[4445] = t1280;
  const T t1281 = T(1.84) * C2_6_33;
  A[3878] = t1281;
  A[4517] = t1281;
  A[3942] = T(0.74);
  A[4015] = T(0.74);
  A[4088] = T(0.74);
  A[4161] = T(5.279999999999999);
  A[4234] = T(5.279999999999999);
  A[4307] = T(5.279999999999999);
  const T t1282 = T(2.57) * C1_8_11;
  A[4167] = t1282;
  A[4593] = t1282;
  const T t1283 = T(2.57) * C1_8_12;
  A[4168] = t1283;
  A[4665] = t1283;
  const T t1284 = T(2.57) * C1_8_13;
  A[4169] = t1284;
  A[4737] = t1284;
  const T t1285 = T(2.57) * C1_8_21;
  A[4239] = t1285;
  A[4594] = t1285;
  const T t1286 = T(2.57) * C1_8_22;
  A[4240] = t1286;
  A[4666] = t1286;
  const T t1287 = T(2.57) * C1_8_23;
  A[4241] = t1287;
  A[4738] = t1287;
  const T t1288 = T(2.57) * C1_8_31;
  A[4311] = t1288;
  A[4595] = t1288;
  const T t1289 = T(2.57) * C1_8_32;
  A[4312] = t1289;
  A[4667] = t1289;
  const T t1290 = T(2.57) * C1_8_33;
  A[4313] = t1290;
  A[4739] = t1290;
  A[4380] = T(1.84);
  A[4453] = T(1.84);
  A[4526] = T(1.84);
  A[4599] = T(2.57);
  A[4672] = T(2.57);
  A[4745] = T(2.57);
  A[4818] = T(7.83);
  A[4891] = T(7.83);
  A[4964] = T(7.83);
  const T t1291 = T(4.06) * C5_11_11;
  A[4821] = t1291;
  A[5034] = t1291;
  const T t1292 = T(4.06) * C5_11_12;
  A[4822] = t1292;
  A[5106] = t1292;
  const T t1293 = T(4.06) * C5_11_13;
  A[4823] = t1293;
  A[5178] = t1293;
  const T t1294 = T(4.06) * C5_11_21;
  A[4893] = t1294;
  A[5035] = t1294;
  const T t1295 = T(4.06) * C5_11_22;
  A[4894] = t1295;
  A[5107] = t1295;
  const T t1296 = T(4.06) * C5_11_23;
  A[4895] = t1296;
  A[5179] = t1296;
  const T t1297 = T(4.06) * C5_11_31;
  A[4965] = t1297;
  A[5036] = t1297;
  const T t1298 = T(4.06) * C5_11_32;
  A[4966] = t1298;
  A[5108] = t1298;
  const T t1299 = T(4.06) * C5_11_33;
  A[4967] = t1299;
  A[5180] = t1299;
  A[5037] = T(4.06);
  A[5110] = T(4.06);
  A[5183] = T(4.06);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 366 add, 552 multiply
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  T block[288];

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
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
  block[36] = R1_11;
  block[39] = R1_12;
  block[42] = R1_13;
  block[37] = R1_21;
  block[40] = R1_22;
  block[43] = R1_23;
  block[38] = R1_31;
  block[41] = R1_32;
  block[44] = R1_33;
  // B1_1 = -R1^T r1~
  const T minus_B1_1_11 = R1_31 * T(0.163) - R1_21 * T(0.095);
  const T minus_B1_1_12 = R1_11 * T(0.095) + R1_31 * T(0.187);
  const T B1_1_13 = R1_11 * T(0.163) + R1_21 * T(0.187);
  const T minus_B1_1_21 = R1_32 * T(0.163) - R1_22 * T(0.095);
  const T minus_B1_1_22 = R1_12 * T(0.095) + R1_32 * T(0.187);
  const T B1_1_23 = R1_12 * T(0.163) + R1_22 * T(0.187);
  const T minus_B1_1_31 = R1_33 * T(0.163) - R1_23 * T(0.095);
  const T minus_B1_1_32 = R1_13 * T(0.095) + R1_33 * T(0.187);
  const T B1_1_33 = R1_13 * T(0.163) + R1_23 * T(0.187);
  block[0] = -minus_B1_1_11;
  block[1] = -minus_B1_1_12;
  block[2] = B1_1_13;
  block[3] = -minus_B1_1_21;
  block[4] = -minus_B1_1_22;
  block[5] = B1_1_23;
  block[6] = -minus_B1_1_31;
  block[7] = -minus_B1_1_32;
  block[8] = B1_1_33;
  // B3_1 = -R1^T d2~
  const T t1_13 = s2_3 - T(0.07);
  const T t1_14 = T(0.323) + s2_2;
  const T minus_B3_1_11 = R1_21 * t1_13 - R1_31 * t1_14;
  const T t1_15 = s2_1 - T(0.472);
  const T minus_B3_1_12 = R1_31 * t1_15 - R1_11 * t1_13;
  const T minus_B3_1_13 = R1_11 * t1_14 - R1_21 * t1_15;
  const T minus_B3_1_21 = R1_22 * t1_13 - R1_32 * t1_14;
  const T minus_B3_1_22 = R1_32 * t1_15 - R1_12 * t1_13;
  const T minus_B3_1_23 = R1_12 * t1_14 - R1_22 * t1_15;
  const T minus_B3_1_31 = R1_23 * t1_13 - R1_33 * t1_14;
  const T minus_B3_1_32 = R1_33 * t1_15 - R1_13 * t1_13;
  const T minus_B3_1_33 = R1_13 * t1_14 - R1_23 * t1_15;
  block[18] = -minus_B3_1_11;
  block[19] = -minus_B3_1_12;
  block[20] = -minus_B3_1_13;
  block[21] = -minus_B3_1_21;
  block[22] = -minus_B3_1_22;
  block[23] = -minus_B3_1_23;
  block[24] = -minus_B3_1_31;
  block[25] = -minus_B3_1_32;
  block[26] = -minus_B3_1_33;
  // B19_1 = -R1^T d8~
  const T t1_16 = s8_3 - T(0.387);
  const T t1_17 = s8_2 - T(0.25);
  const T minus_B19_1_11 = R1_21 * t1_16 - R1_31 * t1_17;
  const T t1_18 = s8_1 - T(0.492);
  const T minus_B19_1_12 = R1_31 * t1_18 - R1_11 * t1_16;
  const T minus_B19_1_13 = R1_11 * t1_17 - R1_21 * t1_18;
  const T minus_B19_1_21 = R1_22 * t1_16 - R1_32 * t1_17;
  const T minus_B19_1_22 = R1_32 * t1_18 - R1_12 * t1_16;
  const T minus_B19_1_23 = R1_12 * t1_17 - R1_22 * t1_18;
  const T minus_B19_1_31 = R1_23 * t1_16 - R1_33 * t1_17;
  const T minus_B19_1_32 = R1_33 * t1_18 - R1_13 * t1_16;
  const T minus_B19_1_33 = R1_13 * t1_17 - R1_23 * t1_18;
  block[162] = -minus_B19_1_11;
  block[163] = -minus_B19_1_12;
  block[164] = -minus_B19_1_13;
  block[165] = -minus_B19_1_21;
  block[166] = -minus_B19_1_22;
  block[167] = -minus_B19_1_23;
  block[168] = -minus_B19_1_31;
  block[169] = -minus_B19_1_32;
  block[170] = -minus_B19_1_33;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
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
  block[63] = R2_11;
  block[66] = R2_12;
  block[69] = R2_13;
  block[64] = R2_21;
  block[67] = R2_22;
  block[70] = R2_23;
  block[65] = R2_31;
  block[68] = R2_32;
  block[71] = R2_33;
  // B4_2 = -R2^T r2~
  const T B4_2_11 = R2_31 * T(0.31);
  const T minus_B4_2_12 = R2_31 * T(0.011);
  const T minus_B4_2_13 = R2_11 * T(0.31) - R2_21 * T(0.011);
  const T B4_2_21 = R2_32 * T(0.31);
  const T minus_B4_2_22 = R2_32 * T(0.011);
  const T minus_B4_2_23 = R2_12 * T(0.31) - R2_22 * T(0.011);
  const T B4_2_31 = R2_33 * T(0.31);
  const T minus_B4_2_32 = R2_33 * T(0.011);
  const T minus_B4_2_33 = R2_13 * T(0.31) - R2_23 * T(0.011);
  block[27] = B4_2_11;
  block[28] = -minus_B4_2_12;
  block[29] = -minus_B4_2_13;
  block[30] = B4_2_21;
  block[31] = -minus_B4_2_22;
  block[32] = -minus_B4_2_23;
  block[33] = B4_2_31;
  block[34] = -minus_B4_2_32;
  block[35] = -minus_B4_2_33;
  // B6_2 = -R2^T d3~
  const T t2_13 = T(0.287) + s3_3;
  const T t2_14 = s3_2 - T(0.178);
  const T minus_B6_2_11 = R2_21 * t2_13 - R2_31 * t2_14;
  const T t2_15 = s3_1 - T(0.476);
  const T minus_B6_2_12 = R2_31 * t2_15 - R2_11 * t2_13;
  const T minus_B6_2_13 = R2_11 * t2_14 - R2_21 * t2_15;
  const T minus_B6_2_21 = R2_22 * t2_13 - R2_32 * t2_14;
  const T minus_B6_2_22 = R2_32 * t2_15 - R2_12 * t2_13;
  const T minus_B6_2_23 = R2_12 * t2_14 - R2_22 * t2_15;
  const T minus_B6_2_31 = R2_23 * t2_13 - R2_33 * t2_14;
  const T minus_B6_2_32 = R2_33 * t2_15 - R2_13 * t2_13;
  const T minus_B6_2_33 = R2_13 * t2_14 - R2_23 * t2_15;
  block[45] = -minus_B6_2_11;
  block[46] = -minus_B6_2_12;
  block[47] = -minus_B6_2_13;
  block[48] = -minus_B6_2_21;
  block[49] = -minus_B6_2_22;
  block[50] = -minus_B6_2_23;
  block[51] = -minus_B6_2_31;
  block[52] = -minus_B6_2_32;
  block[53] = -minus_B6_2_33;
  // B14_2 = -R2^T d6~
  const T t2_16 = T(0.436) + s6_3;
  const T t2_17 = s6_2 - T(0.214);
  const T minus_B14_2_11 = R2_21 * t2_16 - R2_31 * t2_17;
  const T t2_18 = T(0.304) + s6_1;
  const T minus_B14_2_12 = R2_31 * t2_18 - R2_11 * t2_16;
  const T minus_B14_2_13 = R2_11 * t2_17 - R2_21 * t2_18;
  const T minus_B14_2_21 = R2_22 * t2_16 - R2_32 * t2_17;
  const T minus_B14_2_22 = R2_32 * t2_18 - R2_12 * t2_16;
  const T minus_B14_2_23 = R2_12 * t2_17 - R2_22 * t2_18;
  const T minus_B14_2_31 = R2_23 * t2_16 - R2_33 * t2_17;
  const T minus_B14_2_32 = R2_33 * t2_18 - R2_13 * t2_16;
  const T minus_B14_2_33 = R2_13 * t2_17 - R2_23 * t2_18;
  block[117] = -minus_B14_2_11;
  block[118] = -minus_B14_2_12;
  block[119] = -minus_B14_2_13;
  block[120] = -minus_B14_2_21;
  block[121] = -minus_B14_2_22;
  block[122] = -minus_B14_2_23;
  block[123] = -minus_B14_2_31;
  block[124] = -minus_B14_2_32;
  block[125] = -minus_B14_2_33;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
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
  block[90] = R3_11;
  block[93] = R3_12;
  block[96] = R3_13;
  block[91] = R3_21;
  block[94] = R3_22;
  block[97] = R3_23;
  block[92] = R3_31;
  block[95] = R3_32;
  block[98] = R3_33;
  // B7_3 = -R3^T r3~
  const T minus_B7_3_11 = R3_21 * T(0.004) - R3_31 * T(0.498);
  const T minus_B7_3_12 = R3_31 * T(0.484) - R3_11 * T(0.004);
  const T minus_B7_3_13 = R3_11 * T(0.498) - R3_21 * T(0.484);
  const T minus_B7_3_21 = R3_22 * T(0.004) - R3_32 * T(0.498);
  const T minus_B7_3_22 = R3_32 * T(0.484) - R3_12 * T(0.004);
  const T minus_B7_3_23 = R3_12 * T(0.498) - R3_22 * T(0.484);
  const T minus_B7_3_31 = R3_23 * T(0.004) - R3_33 * T(0.498);
  const T minus_B7_3_32 = R3_33 * T(0.484) - R3_13 * T(0.004);
  const T minus_B7_3_33 = R3_13 * T(0.498) - R3_23 * T(0.484);
  block[54] = -minus_B7_3_11;
  block[55] = -minus_B7_3_12;
  block[56] = -minus_B7_3_13;
  block[57] = -minus_B7_3_21;
  block[58] = -minus_B7_3_22;
  block[59] = -minus_B7_3_23;
  block[60] = -minus_B7_3_31;
  block[61] = -minus_B7_3_32;
  block[62] = -minus_B7_3_33;
  // B9_3 = -R3^T d4~
  const T t3_13 = T(0.236) + s4_3;
  const T t3_14 = s4_2 - T(0.132);
  const T minus_B9_3_11 = R3_21 * t3_13 - R3_31 * t3_14;
  const T t3_15 = s4_1 - T(0.153);
  const T minus_B9_3_12 = R3_31 * t3_15 - R3_11 * t3_13;
  const T minus_B9_3_13 = R3_11 * t3_14 - R3_21 * t3_15;
  const T minus_B9_3_21 = R3_22 * t3_13 - R3_32 * t3_14;
  const T minus_B9_3_22 = R3_32 * t3_15 - R3_12 * t3_13;
  const T minus_B9_3_23 = R3_12 * t3_14 - R3_22 * t3_15;
  const T minus_B9_3_31 = R3_23 * t3_13 - R3_33 * t3_14;
  const T minus_B9_3_32 = R3_33 * t3_15 - R3_13 * t3_13;
  const T minus_B9_3_33 = R3_13 * t3_14 - R3_23 * t3_15;
  block[72] = -minus_B9_3_11;
  block[73] = -minus_B9_3_12;
  block[74] = -minus_B9_3_13;
  block[75] = -minus_B9_3_21;
  block[76] = -minus_B9_3_22;
  block[77] = -minus_B9_3_23;
  block[78] = -minus_B9_3_31;
  block[79] = -minus_B9_3_32;
  block[80] = -minus_B9_3_33;
  // B12_3 = -R3^T d5~
  const T t3_16 = s5_3 - T(0.173);
  const T t3_17 = s5_2 - T(0.262);
  const T minus_B12_3_11 = R3_21 * t3_16 - R3_31 * t3_17;
  const T t3_18 = s5_1 - T(0.159);
  const T minus_B12_3_12 = R3_31 * t3_18 - R3_11 * t3_16;
  const T minus_B12_3_13 = R3_11 * t3_17 - R3_21 * t3_18;
  const T minus_B12_3_21 = R3_22 * t3_16 - R3_32 * t3_17;
  const T minus_B12_3_22 = R3_32 * t3_18 - R3_12 * t3_16;
  const T minus_B12_3_23 = R3_12 * t3_17 - R3_22 * t3_18;
  const T minus_B12_3_31 = R3_23 * t3_16 - R3_33 * t3_17;
  const T minus_B12_3_32 = R3_33 * t3_18 - R3_13 * t3_16;
  const T minus_B12_3_33 = R3_13 * t3_17 - R3_23 * t3_18;
  block[99] = -minus_B12_3_11;
  block[100] = -minus_B12_3_12;
  block[101] = -minus_B12_3_13;
  block[102] = -minus_B12_3_21;
  block[103] = -minus_B12_3_22;
  block[104] = -minus_B12_3_23;
  block[105] = -minus_B12_3_31;
  block[106] = -minus_B12_3_32;
  block[107] = -minus_B12_3_33;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
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
  block[153] = R4_11;
  block[156] = R4_12;
  block[159] = R4_13;
  block[154] = R4_21;
  block[157] = R4_22;
  block[160] = R4_23;
  block[155] = R4_31;
  block[158] = R4_32;
  block[161] = R4_33;
  // B10_4 = -R4^T r4~
  const T minus_B10_4_11 = R4_21 * T(0.08) - R4_31 * T(0.289);
  const T minus_B10_4_12 = R4_31 * T(0.401) - R4_11 * T(0.08);
  const T minus_B10_4_13 = R4_11 * T(0.289) - R4_21 * T(0.401);
  const T minus_B10_4_21 = R4_22 * T(0.08) - R4_32 * T(0.289);
  const T minus_B10_4_22 = R4_32 * T(0.401) - R4_12 * T(0.08);
  const T minus_B10_4_23 = R4_12 * T(0.289) - R4_22 * T(0.401);
  const T minus_B10_4_31 = R4_23 * T(0.08) - R4_33 * T(0.289);
  const T minus_B10_4_32 = R4_33 * T(0.401) - R4_13 * T(0.08);
  const T minus_B10_4_33 = R4_13 * T(0.289) - R4_23 * T(0.401);
  block[81] = -minus_B10_4_11;
  block[82] = -minus_B10_4_12;
  block[83] = -minus_B10_4_13;
  block[84] = -minus_B10_4_21;
  block[85] = -minus_B10_4_22;
  block[86] = -minus_B10_4_23;
  block[87] = -minus_B10_4_31;
  block[88] = -minus_B10_4_32;
  block[89] = -minus_B10_4_33;
  // B16_4 = -R4^T d7~
  const T t4_13 = T(0.216) + s7_3;
  const T t4_14 = s7_2 - T(0.337);
  const T minus_B16_4_11 = R4_21 * t4_13 - R4_31 * t4_14;
  const T t4_15 = s7_1 - T(0.329);
  const T minus_B16_4_12 = R4_31 * t4_15 - R4_11 * t4_13;
  const T minus_B16_4_13 = R4_11 * t4_14 - R4_21 * t4_15;
  const T minus_B16_4_21 = R4_22 * t4_13 - R4_32 * t4_14;
  const T minus_B16_4_22 = R4_32 * t4_15 - R4_12 * t4_13;
  const T minus_B16_4_23 = R4_12 * t4_14 - R4_22 * t4_15;
  const T minus_B16_4_31 = R4_23 * t4_13 - R4_33 * t4_14;
  const T minus_B16_4_32 = R4_33 * t4_15 - R4_13 * t4_13;
  const T minus_B16_4_33 = R4_13 * t4_14 - R4_23 * t4_15;
  block[135] = -minus_B16_4_11;
  block[136] = -minus_B16_4_12;
  block[137] = -minus_B16_4_13;
  block[138] = -minus_B16_4_21;
  block[139] = -minus_B16_4_22;
  block[140] = -minus_B16_4_23;
  block[141] = -minus_B16_4_31;
  block[142] = -minus_B16_4_32;
  block[143] = -minus_B16_4_33;

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
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
  block[252] = R5_11;
  block[255] = R5_12;
  block[258] = R5_13;
  block[253] = R5_21;
  block[256] = R5_22;
  block[259] = R5_23;
  block[254] = R5_31;
  block[257] = R5_32;
  block[260] = R5_33;
  // B13_5 = -R5^T r5~
  const T minus_B13_5_11 = R5_21 * T(0.167) + R5_31 * T(0.321);
  const T B13_5_12 = R5_11 * T(0.167) + R5_31 * T(0.056);
  const T minus_B13_5_13 = R5_21 * T(0.056) - R5_11 * T(0.321);
  const T minus_B13_5_21 = R5_22 * T(0.167) + R5_32 * T(0.321);
  const T B13_5_22 = R5_12 * T(0.167) + R5_32 * T(0.056);
  const T minus_B13_5_23 = R5_22 * T(0.056) - R5_12 * T(0.321);
  const T minus_B13_5_31 = R5_23 * T(0.167) + R5_33 * T(0.321);
  const T B13_5_32 = R5_13 * T(0.167) + R5_33 * T(0.056);
  const T minus_B13_5_33 = R5_23 * T(0.056) - R5_13 * T(0.321);
  block[108] = -minus_B13_5_11;
  block[109] = B13_5_12;
  block[110] = -minus_B13_5_13;
  block[111] = -minus_B13_5_21;
  block[112] = B13_5_22;
  block[113] = -minus_B13_5_23;
  block[114] = -minus_B13_5_31;
  block[115] = B13_5_32;
  block[116] = -minus_B13_5_33;
  // B27_5 = -R5^T d11~
  const T t5_13 = s11_3 - T(0.241);
  const T t5_14 = s11_2 - T(0.186);
  const T minus_B27_5_11 = R5_21 * t5_13 - R5_31 * t5_14;
  const T t5_15 = s11_1 - T(0.079);
  const T minus_B27_5_12 = R5_31 * t5_15 - R5_11 * t5_13;
  const T minus_B27_5_13 = R5_11 * t5_14 - R5_21 * t5_15;
  const T minus_B27_5_21 = R5_22 * t5_13 - R5_32 * t5_14;
  const T minus_B27_5_22 = R5_32 * t5_15 - R5_12 * t5_13;
  const T minus_B27_5_23 = R5_12 * t5_14 - R5_22 * t5_15;
  const T minus_B27_5_31 = R5_23 * t5_13 - R5_33 * t5_14;
  const T minus_B27_5_32 = R5_33 * t5_15 - R5_13 * t5_13;
  const T minus_B27_5_33 = R5_13 * t5_14 - R5_23 * t5_15;
  block[234] = -minus_B27_5_11;
  block[235] = -minus_B27_5_12;
  block[236] = -minus_B27_5_13;
  block[237] = -minus_B27_5_21;
  block[238] = -minus_B27_5_22;
  block[239] = -minus_B27_5_23;
  block[240] = -minus_B27_5_31;
  block[241] = -minus_B27_5_32;
  block[242] = -minus_B27_5_33;

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
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
  block[198] = R6_11;
  block[201] = R6_12;
  block[204] = R6_13;
  block[199] = R6_21;
  block[202] = R6_22;
  block[205] = R6_23;
  block[200] = R6_31;
  block[203] = R6_32;
  block[206] = R6_33;
  // B15_6 = -R6^T r6~
  const T minus_B15_6_11 = R6_31 * T(0.248) - R6_21 * T(0.454);
  const T minus_B15_6_12 = R6_11 * T(0.454) + R6_31 * T(0.044);
  const T B15_6_13 = R6_11 * T(0.248) + R6_21 * T(0.044);
  const T minus_B15_6_21 = R6_32 * T(0.248) - R6_22 * T(0.454);
  const T minus_B15_6_22 = R6_12 * T(0.454) + R6_32 * T(0.044);
  const T B15_6_23 = R6_12 * T(0.248) + R6_22 * T(0.044);
  const T minus_B15_6_31 = R6_33 * T(0.248) - R6_23 * T(0.454);
  const T minus_B15_6_32 = R6_13 * T(0.454) + R6_33 * T(0.044);
  const T B15_6_33 = R6_13 * T(0.248) + R6_23 * T(0.044);
  block[126] = -minus_B15_6_11;
  block[127] = -minus_B15_6_12;
  block[128] = B15_6_13;
  block[129] = -minus_B15_6_21;
  block[130] = -minus_B15_6_22;
  block[131] = B15_6_23;
  block[132] = -minus_B15_6_31;
  block[133] = -minus_B15_6_32;
  block[134] = B15_6_33;
  // B21_6 = -R6^T d9~
  const T t6_13 = T(0.036) + s9_3;
  const T t6_14 = T(0.124) + s9_2;
  const T minus_B21_6_11 = R6_21 * t6_13 - R6_31 * t6_14;
  const T t6_15 = s9_1 - T(0.305);
  const T minus_B21_6_12 = R6_31 * t6_15 - R6_11 * t6_13;
  const T minus_B21_6_13 = R6_11 * t6_14 - R6_21 * t6_15;
  const T minus_B21_6_21 = R6_22 * t6_13 - R6_32 * t6_14;
  const T minus_B21_6_22 = R6_32 * t6_15 - R6_12 * t6_13;
  const T minus_B21_6_23 = R6_12 * t6_14 - R6_22 * t6_15;
  const T minus_B21_6_31 = R6_23 * t6_13 - R6_33 * t6_14;
  const T minus_B21_6_32 = R6_33 * t6_15 - R6_13 * t6_13;
  const T minus_B21_6_33 = R6_13 * t6_14 - R6_23 * t6_15;
  block[180] = -minus_B21_6_11;
  block[181] = -minus_B21_6_12;
  block[182] = -minus_B21_6_13;
  block[183] = -minus_B21_6_21;
  block[184] = -minus_B21_6_22;
  block[185] = -minus_B21_6_23;
  block[186] = -minus_B21_6_31;
  block[187] = -minus_B21_6_32;
  block[188] = -minus_B21_6_33;

  // ---- body 7 (body_7) on body 4
  const T eps7_1 = x[24], eps7_2 = x[25], eps7_3 = x[26], eps7_4 = x[27];
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
  // B17_7 = -R7^T r7~
  const T B17_7_11 = T(0.487) * R7_21 - T(0.192) * R7_31;
  const T B17_7_12 = T(0.475) * R7_31 - T(0.487) * R7_11;
  const T B17_7_13 = T(0.192) * R7_11 - T(0.475) * R7_21;
  const T B17_7_21 = T(0.487) * R7_22 - T(0.192) * R7_32;
  const T B17_7_22 = T(0.475) * R7_32 - T(0.487) * R7_12;
  const T B17_7_23 = T(0.192) * R7_12 - T(0.475) * R7_22;
  const T B17_7_31 = T(0.487) * R7_23 - T(0.192) * R7_33;
  const T B17_7_32 = T(0.475) * R7_33 - T(0.487) * R7_13;
  const T B17_7_33 = T(0.192) * R7_13 - T(0.475) * R7_23;
  block[144] = B17_7_11;
  block[145] = B17_7_12;
  block[146] = B17_7_13;
  block[147] = B17_7_21;
  block[148] = B17_7_22;
  block[149] = B17_7_23;
  block[150] = B17_7_31;
  block[151] = B17_7_32;
  block[152] = B17_7_33;

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
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
  block[225] = R8_11;
  block[228] = R8_12;
  block[231] = R8_13;
  block[226] = R8_21;
  block[229] = R8_22;
  block[232] = R8_23;
  block[227] = R8_31;
  block[230] = R8_32;
  block[233] = R8_33;
  // B20_8 = -R8^T r8~
  const T minus_B20_8_11 = R8_31 * T(0.416) - R8_21 * T(0.444);
  const T minus_B20_8_12 = R8_11 * T(0.444) - R8_31 * T(0.392);
  const T minus_B20_8_13 = R8_21 * T(0.392) - R8_11 * T(0.416);
  const T minus_B20_8_21 = R8_32 * T(0.416) - R8_22 * T(0.444);
  const T minus_B20_8_22 = R8_12 * T(0.444) - R8_32 * T(0.392);
  const T minus_B20_8_23 = R8_22 * T(0.392) - R8_12 * T(0.416);
  const T minus_B20_8_31 = R8_33 * T(0.416) - R8_23 * T(0.444);
  const T minus_B20_8_32 = R8_13 * T(0.444) - R8_33 * T(0.392);
  const T minus_B20_8_33 = R8_23 * T(0.392) - R8_13 * T(0.416);
  block[171] = -minus_B20_8_11;
  block[172] = -minus_B20_8_12;
  block[173] = -minus_B20_8_13;
  block[174] = -minus_B20_8_21;
  block[175] = -minus_B20_8_22;
  block[176] = -minus_B20_8_23;
  block[177] = -minus_B20_8_31;
  block[178] = -minus_B20_8_32;
  block[179] = -minus_B20_8_33;
  // B24_8 = -R8^T d10~
  const T t8_13 = s10_3 - T(0.25);
  const T t8_14 = s10_2 - T(0.399);
  const T minus_B24_8_11 = R8_21 * t8_13 - R8_31 * t8_14;
  const T t8_15 = T(0.172) + s10_1;
  const T minus_B24_8_12 = R8_31 * t8_15 - R8_11 * t8_13;
  const T minus_B24_8_13 = R8_11 * t8_14 - R8_21 * t8_15;
  const T minus_B24_8_21 = R8_22 * t8_13 - R8_32 * t8_14;
  const T minus_B24_8_22 = R8_32 * t8_15 - R8_12 * t8_13;
  const T minus_B24_8_23 = R8_12 * t8_14 - R8_22 * t8_15;
  const T minus_B24_8_31 = R8_23 * t8_13 - R8_33 * t8_14;
  const T minus_B24_8_32 = R8_33 * t8_15 - R8_13 * t8_13;
  const T minus_B24_8_33 = R8_13 * t8_14 - R8_23 * t8_15;
  block[207] = -minus_B24_8_11;
  block[208] = -minus_B24_8_12;
  block[209] = -minus_B24_8_13;
  block[210] = -minus_B24_8_21;
  block[211] = -minus_B24_8_22;
  block[212] = -minus_B24_8_23;
  block[213] = -minus_B24_8_31;
  block[214] = -minus_B24_8_32;
  block[215] = -minus_B24_8_33;

  // ---- body 9 (body_9) on body 6
  const T eps9_1 = x[32], eps9_2 = x[33], eps9_3 = x[34], eps9_4 = x[35];
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
  // B22_9 = -R9^T r9~
  const T B22_9_11 = T(0.015) * R9_21 + T(0.49) * R9_31;
  const T minus_B22_9_12 = T(0.015) * R9_11 + T(0.362) * R9_31;
  const T B22_9_13 = T(0.362) * R9_21 - T(0.49) * R9_11;
  const T B22_9_21 = T(0.015) * R9_22 + T(0.49) * R9_32;
  const T minus_B22_9_22 = T(0.015) * R9_12 + T(0.362) * R9_32;
  const T B22_9_23 = T(0.362) * R9_22 - T(0.49) * R9_12;
  const T B22_9_31 = T(0.015) * R9_23 + T(0.49) * R9_33;
  const T minus_B22_9_32 = T(0.015) * R9_13 + T(0.362) * R9_33;
  const T B22_9_33 = T(0.362) * R9_23 - T(0.49) * R9_13;
  block[189] = B22_9_11;
  block[190] = -minus_B22_9_12;
  block[191] = B22_9_13;
  block[192] = B22_9_21;
  block[193] = -minus_B22_9_22;
  block[194] = B22_9_23;
  block[195] = B22_9_31;
  block[196] = -minus_B22_9_32;
  block[197] = B22_9_33;

  // ---- body 10 (body_10) on body 8
  const T eps10_1 = x[36], eps10_2 = x[37], eps10_3 = x[38], eps10_4 = x[39];
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
  // B25_10 = -R10^T r10~
  const T B25_10_11 = T(0.426) * R10_21 + T(0.148) * R10_31;
  const T minus_B25_10_12 = T(0.426) * R10_11 + T(0.016) * R10_31;
  const T B25_10_13 = T(0.016) * R10_21 - T(0.148) * R10_11;
  const T B25_10_21 = T(0.426) * R10_22 + T(0.148) * R10_32;
  const T minus_B25_10_22 = T(0.426) * R10_12 + T(0.016) * R10_32;
  const T B25_10_23 = T(0.016) * R10_22 - T(0.148) * R10_12;
  const T B25_10_31 = T(0.426) * R10_23 + T(0.148) * R10_33;
  const T minus_B25_10_32 = T(0.426) * R10_13 + T(0.016) * R10_33;
  const T B25_10_33 = T(0.016) * R10_23 - T(0.148) * R10_13;
  block[216] = B25_10_11;
  block[217] = -minus_B25_10_12;
  block[218] = B25_10_13;
  block[219] = B25_10_21;
  block[220] = -minus_B25_10_22;
  block[221] = B25_10_23;
  block[222] = B25_10_31;
  block[223] = -minus_B25_10_32;
  block[224] = B25_10_33;

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
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
  block[279] = R11_11;
  block[282] = R11_12;
  block[285] = R11_13;
  block[280] = R11_21;
  block[283] = R11_22;
  block[286] = R11_23;
  block[281] = R11_31;
  block[284] = R11_32;
  block[287] = R11_33;
  // B28_11 = -R11^T r11~
  const T minus_B28_11_11 = R11_21 * T(0.337) + R11_31 * T(0.348);
  const T minus_B28_11_12 = R11_31 * T(0.402) - R11_11 * T(0.337);
  const T B28_11_13 = R11_11 * T(0.348) + R11_21 * T(0.402);
  const T minus_B28_11_21 = R11_22 * T(0.337) + R11_32 * T(0.348);
  const T minus_B28_11_22 = R11_32 * T(0.402) - R11_12 * T(0.337);
  const T B28_11_23 = R11_12 * T(0.348) + R11_22 * T(0.402);
  const T minus_B28_11_31 = R11_23 * T(0.337) + R11_33 * T(0.348);
  const T minus_B28_11_32 = R11_33 * T(0.402) - R11_13 * T(0.337);
  const T B28_11_33 = R11_13 * T(0.348) + R11_23 * T(0.402);
  block[243] = -minus_B28_11_11;
  block[244] = -minus_B28_11_12;
  block[245] = B28_11_13;
  block[246] = -minus_B28_11_21;
  block[247] = -minus_B28_11_22;
  block[248] = B28_11_23;
  block[249] = -minus_B28_11_31;
  block[250] = -minus_B28_11_32;
  block[251] = B28_11_33;
  // B30_11 = -R11^T d12~
  const T t11_13 = T(0.022) + s12_3;
  const T t11_14 = T(0.42) + s12_2;
  const T minus_B30_11_11 = R11_21 * t11_13 - R11_31 * t11_14;
  const T t11_15 = s12_1 - T(0.422);
  const T minus_B30_11_12 = R11_31 * t11_15 - R11_11 * t11_13;
  const T minus_B30_11_13 = R11_11 * t11_14 - R11_21 * t11_15;
  const T minus_B30_11_21 = R11_22 * t11_13 - R11_32 * t11_14;
  const T minus_B30_11_22 = R11_32 * t11_15 - R11_12 * t11_13;
  const T minus_B30_11_23 = R11_12 * t11_14 - R11_22 * t11_15;
  const T minus_B30_11_31 = R11_23 * t11_13 - R11_33 * t11_14;
  const T minus_B30_11_32 = R11_33 * t11_15 - R11_13 * t11_13;
  const T minus_B30_11_33 = R11_13 * t11_14 - R11_23 * t11_15;
  block[261] = -minus_B30_11_11;
  block[262] = -minus_B30_11_12;
  block[263] = -minus_B30_11_13;
  block[264] = -minus_B30_11_21;
  block[265] = -minus_B30_11_22;
  block[266] = -minus_B30_11_23;
  block[267] = -minus_B30_11_31;
  block[268] = -minus_B30_11_32;
  block[269] = -minus_B30_11_33;

  // ---- body 12 (body_12) on body 11
  const T eps12_1 = x[44], eps12_2 = x[45], eps12_3 = x[46], eps12_4 = x[47];
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
  // B31_12 = -R12^T r12~
  const T B31_12_11 = T(0.1) * R12_21 - T(0.141) * R12_31;
  const T B31_12_12 = T(0.006) * R12_31 - T(0.1) * R12_11;
  const T B31_12_13 = T(0.141) * R12_11 - T(0.006) * R12_21;
  const T B31_12_21 = T(0.1) * R12_22 - T(0.141) * R12_32;
  const T B31_12_22 = T(0.006) * R12_32 - T(0.1) * R12_12;
  const T B31_12_23 = T(0.141) * R12_12 - T(0.006) * R12_22;
  const T B31_12_31 = T(0.1) * R12_23 - T(0.141) * R12_33;
  const T B31_12_32 = T(0.006) * R12_33 - T(0.1) * R12_13;
  const T B31_12_33 = T(0.141) * R12_13 - T(0.006) * R12_23;
  block[270] = B31_12_11;
  block[271] = B31_12_12;
  block[272] = B31_12_13;
  block[273] = B31_12_21;
  block[274] = B31_12_22;
  block[275] = B31_12_23;
  block[276] = B31_12_31;
  block[277] = B31_12_32;
  block[278] = B31_12_33;

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
      {0,0}, {1,36}, {2,216}, {3,219}, {1,252}, {4,255}, {2,432}, {5,435}, {6,438}, {1,468}, {4,471}, {7,474},
      {2,648}, {5,651}, {8,654}, {9,657}, {1,684}, {4,687}, {7,690}, {10,693}, {2,864}, {5,867}, {11,870}, {12,876},
      {1,900}, {4,903}, {7,906}, {10,912}, {2,1080}, {13,1083}, {14,1095}, {1,1116}, {4,1119}, {7,1131}, {2,1296},
      {5,1299}, {8,1302}, {15,1305}, {16,1314}, {1,1332}, {4,1335}, {7,1338}, {10,1341}, {17,1350}, {18,1512},
      {19,1533}, {1,1548}, {4,1569}, {2,1728}, {13,1731}, {20,1743}, {21,1752}, {1,1764}, {4,1767}, {7,1779},
      {22,1788}, {18,1944}, {23,1965}, {24,1971}, {1,1980}, {4,2001}, {25,2007}, {2,2160}, {5,2163}, {11,2166},
      {26,2172}, {27,2190}, {1,2196}, {4,2199}, {7,2202}, {10,2208}, {28,2226}, {2,2376}, {5,2379}, {11,2382},
      {26,2388}, {29,2406}, {30,2409}, {1,2412}, {4,2415}, {7,2418}, {10,2424}, {28,2442}, {31,2445},
  };
  for (int i = 0; i < 2592; ++i) v_y[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y[place[1] + i * 72 + j] = block[9 * place[0] + 3 * i + j];
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 672 add, 966 multiply
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  T block[279];

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s2_1 = x[51], s2_2 = x[52], s2_3 = x[53];
  const T s8_1 = x[69], s8_2 = x[70], s8_3 = x[71];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot2_1 = y[39], sdot2_2 = y[40], sdot2_3 = y[41];
  const T sdot8_1 = y[57], sdot8_2 = y[58], sdot8_3 = y[59];
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
  const T t1_14 = R1_31 * omega1_1 - R1_11 * omega1_3;
  const T minus_B1_1_11 = t1_13 * T(0.163) - t1_14 * T(0.095);
  const T t1_15 = R1_21 * omega1_3 - R1_31 * omega1_2;
  const T minus_B1_1_12 = t1_15 * T(0.095) + t1_13 * T(0.187);
  const T B1_1_13 = t1_15 * T(0.163) + t1_14 * T(0.187);
  const T t1_16 = R1_12 * omega1_2 - R1_22 * omega1_1;
  const T t1_17 = R1_32 * omega1_1 - R1_12 * omega1_3;
  const T minus_B1_1_21 = t1_16 * T(0.163) - t1_17 * T(0.095);
  const T t1_18 = R1_22 * omega1_3 - R1_32 * omega1_2;
  const T minus_B1_1_22 = t1_18 * T(0.095) + t1_16 * T(0.187);
  const T B1_1_23 = t1_18 * T(0.163) + t1_17 * T(0.187);
  const T t1_19 = R1_13 * omega1_2 - R1_23 * omega1_1;
  const T t1_20 = R1_33 * omega1_1 - R1_13 * omega1_3;
  const T minus_B1_1_31 = t1_19 * T(0.163) - t1_20 * T(0.095);
  const T t1_21 = R1_23 * omega1_3 - R1_33 * omega1_2;
  const T minus_B1_1_32 = t1_21 * T(0.095) + t1_19 * T(0.187);
  const T B1_1_33 = t1_21 * T(0.163) + t1_20 * T(0.187);
  block[0] = -minus_B1_1_11;
  block[1] = -minus_B1_1_12;
  block[2] = B1_1_13;
  block[3] = -minus_B1_1_21;
  block[4] = -minus_B1_1_22;
  block[5] = B1_1_23;
  block[6] = -minus_B1_1_31;
  block[7] = -minus_B1_1_32;
  block[8] = B1_1_33;
  // B2_1 = -R1^T omega1~ d2~ - R1^T sdot2~
  const T t1_22 = s2_3 - T(0.07);
  const T t1_23 = T(0.323) + s2_2;
  const T minus_B2_1_11 = t1_14 * t1_22 - t1_13 * t1_23 + R1_21 * sdot2_3 - R1_31 * sdot2_2;
  const T t1_24 = s2_1 - T(0.472);
  const T minus_B2_1_12 = t1_13 * t1_24 - t1_15 * t1_22 + R1_31 * sdot2_1 - R1_11 * sdot2_3;
  const T minus_B2_1_13 = t1_15 * t1_23 - t1_14 * t1_24 + R1_11 * sdot2_2 - R1_21 * sdot2_1;
  const T minus_B2_1_21 = t1_17 * t1_22 - t1_16 * t1_23 + R1_22 * sdot2_3 - R1_32 * sdot2_2;
  const T minus_B2_1_22 = t1_16 * t1_24 - t1_18 * t1_22 + R1_32 * sdot2_1 - R1_12 * sdot2_3;
  const T minus_B2_1_23 = t1_18 * t1_23 - t1_17 * t1_24 + R1_12 * sdot2_2 - R1_22 * sdot2_1;
  const T minus_B2_1_31 = t1_20 * t1_22 - t1_19 * t1_23 + R1_23 * sdot2_3 - R1_33 * sdot2_2;
  const T minus_B2_1_32 = t1_19 * t1_24 - t1_21 * t1_22 + R1_33 * sdot2_1 - R1_13 * sdot2_3;
  const T minus_B2_1_33 = t1_21 * t1_23 - t1_20 * t1_24 + R1_13 * sdot2_2 - R1_23 * sdot2_1;
  block[9] = -minus_B2_1_11;
  block[10] = -minus_B2_1_12;
  block[11] = -minus_B2_1_13;
  block[12] = -minus_B2_1_21;
  block[13] = -minus_B2_1_22;
  block[14] = -minus_B2_1_23;
  block[15] = -minus_B2_1_31;
  block[16] = -minus_B2_1_32;
  block[17] = -minus_B2_1_33;
  block[27] = t1_15;
  block[28] = t1_14;
  block[29] = t1_13;
  block[30] = t1_18;
  block[31] = t1_17;
  block[32] = t1_16;
  block[33] = t1_21;
  block[34] = t1_20;
  block[35] = t1_19;
  // B18_1 = -R1^T omega1~ d8~ - R1^T sdot8~
  const T t1_25 = s8_3 - T(0.387);
  const T t1_26 = s8_2 - T(0.25);
  const T minus_B18_1_11 = t1_14 * t1_25 - t1_13 * t1_26 + R1_21 * sdot8_3 - R1_31 * sdot8_2;
  const T t1_27 = s8_1 - T(0.492);
  const T minus_B18_1_12 = t1_13 * t1_27 - t1_15 * t1_25 + R1_31 * sdot8_1 - R1_11 * sdot8_3;
  const T minus_B18_1_13 = t1_15 * t1_26 - t1_14 * t1_27 + R1_11 * sdot8_2 - R1_21 * sdot8_1;
  const T minus_B18_1_21 = t1_17 * t1_25 - t1_16 * t1_26 + R1_22 * sdot8_3 - R1_32 * sdot8_2;
  const T minus_B18_1_22 = t1_16 * t1_27 - t1_18 * t1_25 + R1_32 * sdot8_1 - R1_12 * sdot8_3;
  const T minus_B18_1_23 = t1_18 * t1_26 - t1_17 * t1_27 + R1_12 * sdot8_2 - R1_22 * sdot8_1;
  const T minus_B18_1_31 = t1_20 * t1_25 - t1_19 * t1_26 + R1_23 * sdot8_3 - R1_33 * sdot8_2;
  const T minus_B18_1_32 = t1_19 * t1_27 - t1_21 * t1_25 + R1_33 * sdot8_1 - R1_13 * sdot8_3;
  const T minus_B18_1_33 = t1_21 * t1_26 - t1_20 * t1_27 + R1_13 * sdot8_2 - R1_23 * sdot8_1;
  block[153] = -minus_B18_1_11;
  block[154] = -minus_B18_1_12;
  block[155] = -minus_B18_1_13;
  block[156] = -minus_B18_1_21;
  block[157] = -minus_B18_1_22;
  block[158] = -minus_B18_1_23;
  block[159] = -minus_B18_1_31;
  block[160] = -minus_B18_1_32;
  block[161] = -minus_B18_1_33;

  // ---- body 2 (body_2) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s3_1 = x[54], s3_2 = x[55], s3_3 = x[56];
  const T s6_1 = x[63], s6_2 = x[64], s6_3 = x[65];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot3_1 = y[42], sdot3_2 = y[43], sdot3_3 = y[44];
  const T sdot6_1 = y[51], sdot6_2 = y[52], sdot6_3 = y[53];
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
  const T t2_13 = R2_11 * omega2_2 - R2_21 * omega2_1;
  const T B3_2_11 = t2_13 * T(0.31);
  const T minus_B3_2_12 = t2_13 * T(0.011);
  const T t2_14 = R2_21 * omega2_3 - R2_31 * omega2_2;
  const T t2_15 = R2_31 * omega2_1 - R2_11 * omega2_3;
  const T minus_B3_2_13 = t2_14 * T(0.31) - t2_15 * T(0.011);
  const T t2_16 = R2_12 * omega2_2 - R2_22 * omega2_1;
  const T B3_2_21 = t2_16 * T(0.31);
  const T minus_B3_2_22 = t2_16 * T(0.011);
  const T t2_17 = R2_22 * omega2_3 - R2_32 * omega2_2;
  const T t2_18 = R2_32 * omega2_1 - R2_12 * omega2_3;
  const T minus_B3_2_23 = t2_17 * T(0.31) - t2_18 * T(0.011);
  const T t2_19 = R2_13 * omega2_2 - R2_23 * omega2_1;
  const T B3_2_31 = t2_19 * T(0.31);
  const T minus_B3_2_32 = t2_19 * T(0.011);
  const T t2_20 = R2_23 * omega2_3 - R2_33 * omega2_2;
  const T t2_21 = R2_33 * omega2_1 - R2_13 * omega2_3;
  const T minus_B3_2_33 = t2_20 * T(0.31) - t2_21 * T(0.011);
  block[18] = B3_2_11;
  block[19] = -minus_B3_2_12;
  block[20] = -minus_B3_2_13;
  block[21] = B3_2_21;
  block[22] = -minus_B3_2_22;
  block[23] = -minus_B3_2_23;
  block[24] = B3_2_31;
  block[25] = -minus_B3_2_32;
  block[26] = -minus_B3_2_33;
  // B5_2 = -R2^T omega2~ d3~ - R2^T sdot3~
  const T t2_22 = T(0.287) + s3_3;
  const T t2_23 = s3_2 - T(0.178);
  const T minus_B5_2_11 = t2_15 * t2_22 - t2_13 * t2_23 + R2_21 * sdot3_3 - R2_31 * sdot3_2;
  const T t2_24 = s3_1 - T(0.476);
  const T minus_B5_2_12 = t2_13 * t2_24 - t2_14 * t2_22 + R2_31 * sdot3_1 - R2_11 * sdot3_3;
  const T minus_B5_2_13 = t2_14 * t2_23 - t2_15 * t2_24 + R2_11 * sdot3_2 - R2_21 * sdot3_1;
  const T minus_B5_2_21 = t2_18 * t2_22 - t2_16 * t2_23 + R2_22 * sdot3_3 - R2_32 * sdot3_2;
  const T minus_B5_2_22 = t2_16 * t2_24 - t2_17 * t2_22 + R2_32 * sdot3_1 - R2_12 * sdot3_3;
  const T minus_B5_2_23 = t2_17 * t2_23 - t2_18 * t2_24 + R2_12 * sdot3_2 - R2_22 * sdot3_1;
  const T minus_B5_2_31 = t2_21 * t2_22 - t2_19 * t2_23 + R2_23 * sdot3_3 - R2_33 * sdot3_2;
  const T minus_B5_2_32 = t2_19 * t2_24 - t2_20 * t2_22 + R2_33 * sdot3_1 - R2_13 * sdot3_3;
  const T minus_B5_2_33 = t2_20 * t2_23 - t2_21 * t2_24 + R2_13 * sdot3_2 - R2_23 * sdot3_1;
  block[36] = -minus_B5_2_11;
  block[37] = -minus_B5_2_12;
  block[38] = -minus_B5_2_13;
  block[39] = -minus_B5_2_21;
  block[40] = -minus_B5_2_22;
  block[41] = -minus_B5_2_23;
  block[42] = -minus_B5_2_31;
  block[43] = -minus_B5_2_32;
  block[44] = -minus_B5_2_33;
  block[54] = t2_14;
  block[55] = t2_15;
  block[56] = t2_13;
  block[57] = t2_17;
  block[58] = t2_18;
  block[59] = t2_16;
  block[60] = t2_20;
  block[61] = t2_21;
  block[62] = t2_19;
  // B13_2 = -R2^T omega2~ d6~ - R2^T sdot6~
  const T t2_25 = T(0.436) + s6_3;
  const T t2_26 = s6_2 - T(0.214);
  const T minus_B13_2_11 = t2_15 * t2_25 - t2_13 * t2_26 + R2_21 * sdot6_3 - R2_31 * sdot6_2;
  const T t2_27 = T(0.304) + s6_1;
  const T minus_B13_2_12 = t2_13 * t2_27 - t2_14 * t2_25 + R2_31 * sdot6_1 - R2_11 * sdot6_3;
  const T minus_B13_2_13 = t2_14 * t2_26 - t2_15 * t2_27 + R2_11 * sdot6_2 - R2_21 * sdot6_1;
  const T minus_B13_2_21 = t2_18 * t2_25 - t2_16 * t2_26 + R2_22 * sdot6_3 - R2_32 * sdot6_2;
  const T minus_B13_2_22 = t2_16 * t2_27 - t2_17 * t2_25 + R2_32 * sdot6_1 - R2_12 * sdot6_3;
  const T minus_B13_2_23 = t2_17 * t2_26 - t2_18 * t2_27 + R2_12 * sdot6_2 - R2_22 * sdot6_1;
  const T minus_B13_2_31 = t2_21 * t2_25 - t2_19 * t2_26 + R2_23 * sdot6_3 - R2_33 * sdot6_2;
  const T minus_B13_2_32 = t2_19 * t2_27 - t2_20 * t2_25 + R2_33 * sdot6_1 - R2_13 * sdot6_3;
  const T minus_B13_2_33 = t2_20 * t2_26 - t2_21 * t2_27 + R2_13 * sdot6_2 - R2_23 * sdot6_1;
  block[108] = -minus_B13_2_11;
  block[109] = -minus_B13_2_12;
  block[110] = -minus_B13_2_13;
  block[111] = -minus_B13_2_21;
  block[112] = -minus_B13_2_22;
  block[113] = -minus_B13_2_23;
  block[114] = -minus_B13_2_31;
  block[115] = -minus_B13_2_32;
  block[116] = -minus_B13_2_33;

  // ---- body 3 (body_3) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s4_1 = x[57], s4_2 = x[58], s4_3 = x[59];
  const T s5_1 = x[60], s5_2 = x[61], s5_3 = x[62];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot4_1 = y[45], sdot4_2 = y[46], sdot4_3 = y[47];
  const T sdot5_1 = y[48], sdot5_2 = y[49], sdot5_3 = y[50];
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
  // B6_3 = -R3^T omega3~ r3~
  const T t3_13 = R3_31 * omega3_1 - R3_11 * omega3_3;
  const T t3_14 = R3_11 * omega3_2 - R3_21 * omega3_1;
  const T minus_B6_3_11 = t3_13 * T(0.004) - t3_14 * T(0.498);
  const T t3_15 = R3_21 * omega3_3 - R3_31 * omega3_2;
  const T minus_B6_3_12 = t3_14 * T(0.484) - t3_15 * T(0.004);
  const T minus_B6_3_13 = t3_15 * T(0.498) - t3_13 * T(0.484);
  const T t3_16 = R3_32 * omega3_1 - R3_12 * omega3_3;
  const T t3_17 = R3_12 * omega3_2 - R3_22 * omega3_1;
  const T minus_B6_3_21 = t3_16 * T(0.004) - t3_17 * T(0.498);
  const T t3_18 = R3_22 * omega3_3 - R3_32 * omega3_2;
  const T minus_B6_3_22 = t3_17 * T(0.484) - t3_18 * T(0.004);
  const T minus_B6_3_23 = t3_18 * T(0.498) - t3_16 * T(0.484);
  const T t3_19 = R3_33 * omega3_1 - R3_13 * omega3_3;
  const T t3_20 = R3_13 * omega3_2 - R3_23 * omega3_1;
  const T minus_B6_3_31 = t3_19 * T(0.004) - t3_20 * T(0.498);
  const T t3_21 = R3_23 * omega3_3 - R3_33 * omega3_2;
  const T minus_B6_3_32 = t3_20 * T(0.484) - t3_21 * T(0.004);
  const T minus_B6_3_33 = t3_21 * T(0.498) - t3_19 * T(0.484);
  block[45] = -minus_B6_3_11;
  block[46] = -minus_B6_3_12;
  block[47] = -minus_B6_3_13;
  block[48] = -minus_B6_3_21;
  block[49] = -minus_B6_3_22;
  block[50] = -minus_B6_3_23;
  block[51] = -minus_B6_3_31;
  block[52] = -minus_B6_3_32;
  block[53] = -minus_B6_3_33;
  // B8_3 = -R3^T omega3~ d4~ - R3^T sdot4~
  const T t3_22 = T(0.236) + s4_3;
  const T t3_23 = s4_2 - T(0.132);
  const T minus_B8_3_11 = t3_13 * t3_22 - t3_14 * t3_23 + R3_21 * sdot4_3 - R3_31 * sdot4_2;
  const T t3_24 = s4_1 - T(0.153);
  const T minus_B8_3_12 = t3_14 * t3_24 - t3_15 * t3_22 + R3_31 * sdot4_1 - R3_11 * sdot4_3;
  const T minus_B8_3_13 = t3_15 * t3_23 - t3_13 * t3_24 + R3_11 * sdot4_2 - R3_21 * sdot4_1;
  const T minus_B8_3_21 = t3_16 * t3_22 - t3_17 * t3_23 + R3_22 * sdot4_3 - R3_32 * sdot4_2;
  const T minus_B8_3_22 = t3_17 * t3_24 - t3_18 * t3_22 + R3_32 * sdot4_1 - R3_12 * sdot4_3;
  const T minus_B8_3_23 = t3_18 * t3_23 - t3_16 * t3_24 + R3_12 * sdot4_2 - R3_22 * sdot4_1;
  const T minus_B8_3_31 = t3_19 * t3_22 - t3_20 * t3_23 + R3_23 * sdot4_3 - R3_33 * sdot4_2;
  const T minus_B8_3_32 = t3_20 * t3_24 - t3_21 * t3_22 + R3_33 * sdot4_1 - R3_13 * sdot4_3;
  const T minus_B8_3_33 = t3_21 * t3_23 - t3_19 * t3_24 + R3_13 * sdot4_2 - R3_23 * sdot4_1;
  block[63] = -minus_B8_3_11;
  block[64] = -minus_B8_3_12;
  block[65] = -minus_B8_3_13;
  block[66] = -minus_B8_3_21;
  block[67] = -minus_B8_3_22;
  block[68] = -minus_B8_3_23;
  block[69] = -minus_B8_3_31;
  block[70] = -minus_B8_3_32;
  block[71] = -minus_B8_3_33;
  block[81] = t3_15;
  block[82] = t3_13;
  block[83] = t3_14;
  block[84] = t3_18;
  block[85] = t3_16;
  block[86] = t3_17;
  block[87] = t3_21;
  block[88] = t3_19;
  block[89] = t3_20;
  // B11_3 = -R3^T omega3~ d5~ - R3^T sdot5~
  const T t3_25 = s5_3 - T(0.173);
  const T t3_26 = s5_2 - T(0.262);
  const T minus_B11_3_11 = t3_13 * t3_25 - t3_14 * t3_26 + R3_21 * sdot5_3 - R3_31 * sdot5_2;
  const T t3_27 = s5_1 - T(0.159);
  const T minus_B11_3_12 = t3_14 * t3_27 - t3_15 * t3_25 + R3_31 * sdot5_1 - R3_11 * sdot5_3;
  const T minus_B11_3_13 = t3_15 * t3_26 - t3_13 * t3_27 + R3_11 * sdot5_2 - R3_21 * sdot5_1;
  const T minus_B11_3_21 = t3_16 * t3_25 - t3_17 * t3_26 + R3_22 * sdot5_3 - R3_32 * sdot5_2;
  const T minus_B11_3_22 = t3_17 * t3_27 - t3_18 * t3_25 + R3_32 * sdot5_1 - R3_12 * sdot5_3;
  const T minus_B11_3_23 = t3_18 * t3_26 - t3_16 * t3_27 + R3_12 * sdot5_2 - R3_22 * sdot5_1;
  const T minus_B11_3_31 = t3_19 * t3_25 - t3_20 * t3_26 + R3_23 * sdot5_3 - R3_33 * sdot5_2;
  const T minus_B11_3_32 = t3_20 * t3_27 - t3_21 * t3_25 + R3_33 * sdot5_1 - R3_13 * sdot5_3;
  const T minus_B11_3_33 = t3_21 * t3_26 - t3_19 * t3_27 + R3_13 * sdot5_2 - R3_23 * sdot5_1;
  block[90] = -minus_B11_3_11;
  block[91] = -minus_B11_3_12;
  block[92] = -minus_B11_3_13;
  block[93] = -minus_B11_3_21;
  block[94] = -minus_B11_3_22;
  block[95] = -minus_B11_3_23;
  block[96] = -minus_B11_3_31;
  block[97] = -minus_B11_3_32;
  block[98] = -minus_B11_3_33;

  // ---- body 4 (body_4) on body 3
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s7_1 = x[66], s7_2 = x[67], s7_3 = x[68];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot7_1 = y[54], sdot7_2 = y[55], sdot7_3 = y[56];
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
  // B9_4 = -R4^T omega4~ r4~
  const T t4_13 = R4_31 * omega4_1 - R4_11 * omega4_3;
  const T t4_14 = R4_11 * omega4_2 - R4_21 * omega4_1;
  const T minus_B9_4_11 = t4_13 * T(0.08) - t4_14 * T(0.289);
  const T t4_15 = R4_21 * omega4_3 - R4_31 * omega4_2;
  const T minus_B9_4_12 = t4_14 * T(0.401) - t4_15 * T(0.08);
  const T minus_B9_4_13 = t4_15 * T(0.289) - t4_13 * T(0.401);
  const T t4_16 = R4_32 * omega4_1 - R4_12 * omega4_3;
  const T t4_17 = R4_12 * omega4_2 - R4_22 * omega4_1;
  const T minus_B9_4_21 = t4_16 * T(0.08) - t4_17 * T(0.289);
  const T t4_18 = R4_22 * omega4_3 - R4_32 * omega4_2;
  const T minus_B9_4_22 = t4_17 * T(0.401) - t4_18 * T(0.08);
  const T minus_B9_4_23 = t4_18 * T(0.289) - t4_16 * T(0.401);
  const T t4_19 = R4_33 * omega4_1 - R4_13 * omega4_3;
  const T t4_20 = R4_13 * omega4_2 - R4_23 * omega4_1;
  const T minus_B9_4_31 = t4_19 * T(0.08) - t4_20 * T(0.289);
  const T t4_21 = R4_23 * omega4_3 - R4_33 * omega4_2;
  const T minus_B9_4_32 = t4_20 * T(0.401) - t4_21 * T(0.08);
  const T minus_B9_4_33 = t4_21 * T(0.289) - t4_19 * T(0.401);
  block[72] = -minus_B9_4_11;
  block[73] = -minus_B9_4_12;
  block[74] = -minus_B9_4_13;
  block[75] = -minus_B9_4_21;
  block[76] = -minus_B9_4_22;
  block[77] = -minus_B9_4_23;
  block[78] = -minus_B9_4_31;
  block[79] = -minus_B9_4_32;
  block[80] = -minus_B9_4_33;
  // B15_4 = -R4^T omega4~ d7~ - R4^T sdot7~
  const T t4_22 = T(0.216) + s7_3;
  const T t4_23 = s7_2 - T(0.337);
  const T minus_B15_4_11 = t4_13 * t4_22 - t4_14 * t4_23 + R4_21 * sdot7_3 - R4_31 * sdot7_2;
  const T t4_24 = s7_1 - T(0.329);
  const T minus_B15_4_12 = t4_14 * t4_24 - t4_15 * t4_22 + R4_31 * sdot7_1 - R4_11 * sdot7_3;
  const T minus_B15_4_13 = t4_15 * t4_23 - t4_13 * t4_24 + R4_11 * sdot7_2 - R4_21 * sdot7_1;
  const T minus_B15_4_21 = t4_16 * t4_22 - t4_17 * t4_23 + R4_22 * sdot7_3 - R4_32 * sdot7_2;
  const T minus_B15_4_22 = t4_17 * t4_24 - t4_18 * t4_22 + R4_32 * sdot7_1 - R4_12 * sdot7_3;
  const T minus_B15_4_23 = t4_18 * t4_23 - t4_16 * t4_24 + R4_12 * sdot7_2 - R4_22 * sdot7_1;
  const T minus_B15_4_31 = t4_19 * t4_22 - t4_20 * t4_23 + R4_23 * sdot7_3 - R4_33 * sdot7_2;
  const T minus_B15_4_32 = t4_20 * t4_24 - t4_21 * t4_22 + R4_33 * sdot7_1 - R4_13 * sdot7_3;
  const T minus_B15_4_33 = t4_21 * t4_23 - t4_19 * t4_24 + R4_13 * sdot7_2 - R4_23 * sdot7_1;
  block[126] = -minus_B15_4_11;
  block[127] = -minus_B15_4_12;
  block[128] = -minus_B15_4_13;
  block[129] = -minus_B15_4_21;
  block[130] = -minus_B15_4_22;
  block[131] = -minus_B15_4_23;
  block[132] = -minus_B15_4_31;
  block[133] = -minus_B15_4_32;
  block[134] = -minus_B15_4_33;
  block[144] = t4_15;
  block[145] = t4_13;
  block[146] = t4_14;
  block[147] = t4_18;
  block[148] = t4_16;
  block[149] = t4_17;
  block[150] = t4_21;
  block[151] = t4_19;
  block[152] = t4_20;

  // ---- body 5 (body_5) on body 3
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s11_1 = x[78], s11_2 = x[79], s11_3 = x[80];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot11_1 = y[66], sdot11_2 = y[67], sdot11_3 = y[68];
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
  // B12_5 = -R5^T omega5~ r5~
  const T t5_13 = R5_31 * omega5_1 - R5_11 * omega5_3;
  const T t5_14 = R5_11 * omega5_2 - R5_21 * omega5_1;
  const T minus_B12_5_11 = t5_13 * T(0.167) + t5_14 * T(0.321);
  const T t5_15 = R5_21 * omega5_3 - R5_31 * omega5_2;
  const T B12_5_12 = t5_15 * T(0.167) + t5_14 * T(0.056);
  const T minus_B12_5_13 = t5_13 * T(0.056) - t5_15 * T(0.321);
  const T t5_16 = R5_32 * omega5_1 - R5_12 * omega5_3;
  const T t5_17 = R5_12 * omega5_2 - R5_22 * omega5_1;
  const T minus_B12_5_21 = t5_16 * T(0.167) + t5_17 * T(0.321);
  const T t5_18 = R5_22 * omega5_3 - R5_32 * omega5_2;
  const T B12_5_22 = t5_18 * T(0.167) + t5_17 * T(0.056);
  const T minus_B12_5_23 = t5_16 * T(0.056) - t5_18 * T(0.321);
  const T t5_19 = R5_33 * omega5_1 - R5_13 * omega5_3;
  const T t5_20 = R5_13 * omega5_2 - R5_23 * omega5_1;
  const T minus_B12_5_31 = t5_19 * T(0.167) + t5_20 * T(0.321);
  const T t5_21 = R5_23 * omega5_3 - R5_33 * omega5_2;
  const T B12_5_32 = t5_21 * T(0.167) + t5_20 * T(0.056);
  const T minus_B12_5_33 = t5_19 * T(0.056) - t5_21 * T(0.321);
  block[99] = -minus_B12_5_11;
  block[100] = B12_5_12;
  block[101] = -minus_B12_5_13;
  block[102] = -minus_B12_5_21;
  block[103] = B12_5_22;
  block[104] = -minus_B12_5_23;
  block[105] = -minus_B12_5_31;
  block[106] = B12_5_32;
  block[107] = -minus_B12_5_33;
  // B26_5 = -R5^T omega5~ d11~ - R5^T sdot11~
  const T t5_22 = s11_3 - T(0.241);
  const T t5_23 = s11_2 - T(0.186);
  const T minus_B26_5_11 = t5_13 * t5_22 - t5_14 * t5_23 + R5_21 * sdot11_3 - R5_31 * sdot11_2;
  const T t5_24 = s11_1 - T(0.079);
  const T minus_B26_5_12 = t5_14 * t5_24 - t5_15 * t5_22 + R5_31 * sdot11_1 - R5_11 * sdot11_3;
  const T minus_B26_5_13 = t5_15 * t5_23 - t5_13 * t5_24 + R5_11 * sdot11_2 - R5_21 * sdot11_1;
  const T minus_B26_5_21 = t5_16 * t5_22 - t5_17 * t5_23 + R5_22 * sdot11_3 - R5_32 * sdot11_2;
  const T minus_B26_5_22 = t5_17 * t5_24 - t5_18 * t5_22 + R5_32 * sdot11_1 - R5_12 * sdot11_3;
  const T minus_B26_5_23 = t5_18 * t5_23 - t5_16 * t5_24 + R5_12 * sdot11_2 - R5_22 * sdot11_1;
  const T minus_B26_5_31 = t5_19 * t5_22 - t5_20 * t5_23 + R5_23 * sdot11_3 - R5_33 * sdot11_2;
  const T minus_B26_5_32 = t5_20 * t5_24 - t5_21 * t5_22 + R5_33 * sdot11_1 - R5_13 * sdot11_3;
  const T minus_B26_5_33 = t5_21 * t5_23 - t5_19 * t5_24 + R5_13 * sdot11_2 - R5_23 * sdot11_1;
  block[225] = -minus_B26_5_11;
  block[226] = -minus_B26_5_12;
  block[227] = -minus_B26_5_13;
  block[228] = -minus_B26_5_21;
  block[229] = -minus_B26_5_22;
  block[230] = -minus_B26_5_23;
  block[231] = -minus_B26_5_31;
  block[232] = -minus_B26_5_32;
  block[233] = -minus_B26_5_33;
  block[243] = t5_15;
  block[244] = t5_13;
  block[245] = t5_14;
  block[246] = t5_18;
  block[247] = t5_16;
  block[248] = t5_17;
  block[249] = t5_21;
  block[250] = t5_19;
  block[251] = t5_20;

  // ---- body 6 (body_6) on body 2
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s9_1 = x[72], s9_2 = x[73], s9_3 = x[74];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot9_1 = y[60], sdot9_2 = y[61], sdot9_3 = y[62];
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
  // B14_6 = -R6^T omega6~ r6~
  const T t6_13 = R6_11 * omega6_2 - R6_21 * omega6_1;
  const T t6_14 = R6_31 * omega6_1 - R6_11 * omega6_3;
  const T minus_B14_6_11 = t6_13 * T(0.248) - t6_14 * T(0.454);
  const T t6_15 = R6_21 * omega6_3 - R6_31 * omega6_2;
  const T minus_B14_6_12 = t6_15 * T(0.454) + t6_13 * T(0.044);
  const T B14_6_13 = t6_15 * T(0.248) + t6_14 * T(0.044);
  const T t6_16 = R6_12 * omega6_2 - R6_22 * omega6_1;
  const T t6_17 = R6_32 * omega6_1 - R6_12 * omega6_3;
  const T minus_B14_6_21 = t6_16 * T(0.248) - t6_17 * T(0.454);
  const T t6_18 = R6_22 * omega6_3 - R6_32 * omega6_2;
  const T minus_B14_6_22 = t6_18 * T(0.454) + t6_16 * T(0.044);
  const T B14_6_23 = t6_18 * T(0.248) + t6_17 * T(0.044);
  const T t6_19 = R6_13 * omega6_2 - R6_23 * omega6_1;
  const T t6_20 = R6_33 * omega6_1 - R6_13 * omega6_3;
  const T minus_B14_6_31 = t6_19 * T(0.248) - t6_20 * T(0.454);
  const T t6_21 = R6_23 * omega6_3 - R6_33 * omega6_2;
  const T minus_B14_6_32 = t6_21 * T(0.454) + t6_19 * T(0.044);
  const T B14_6_33 = t6_21 * T(0.248) + t6_20 * T(0.044);
  block[117] = -minus_B14_6_11;
  block[118] = -minus_B14_6_12;
  block[119] = B14_6_13;
  block[120] = -minus_B14_6_21;
  block[121] = -minus_B14_6_22;
  block[122] = B14_6_23;
  block[123] = -minus_B14_6_31;
  block[124] = -minus_B14_6_32;
  block[125] = B14_6_33;
  // B20_6 = -R6^T omega6~ d9~ - R6^T sdot9~
  const T t6_22 = T(0.036) + s9_3;
  const T t6_23 = T(0.124) + s9_2;
  const T minus_B20_6_11 = t6_14 * t6_22 - t6_13 * t6_23 + R6_21 * sdot9_3 - R6_31 * sdot9_2;
  const T t6_24 = s9_1 - T(0.305);
  const T minus_B20_6_12 = t6_13 * t6_24 - t6_15 * t6_22 + R6_31 * sdot9_1 - R6_11 * sdot9_3;
  const T minus_B20_6_13 = t6_15 * t6_23 - t6_14 * t6_24 + R6_11 * sdot9_2 - R6_21 * sdot9_1;
  const T minus_B20_6_21 = t6_17 * t6_22 - t6_16 * t6_23 + R6_22 * sdot9_3 - R6_32 * sdot9_2;
  const T minus_B20_6_22 = t6_16 * t6_24 - t6_18 * t6_22 + R6_32 * sdot9_1 - R6_12 * sdot9_3;
  const T minus_B20_6_23 = t6_18 * t6_23 - t6_17 * t6_24 + R6_12 * sdot9_2 - R6_22 * sdot9_1;
  const T minus_B20_6_31 = t6_20 * t6_22 - t6_19 * t6_23 + R6_23 * sdot9_3 - R6_33 * sdot9_2;
  const T minus_B20_6_32 = t6_19 * t6_24 - t6_21 * t6_22 + R6_33 * sdot9_1 - R6_13 * sdot9_3;
  const T minus_B20_6_33 = t6_21 * t6_23 - t6_20 * t6_24 + R6_13 * sdot9_2 - R6_23 * sdot9_1;
  block[171] = -minus_B20_6_11;
  block[172] = -minus_B20_6_12;
  block[173] = -minus_B20_6_13;
  block[174] = -minus_B20_6_21;
  block[175] = -minus_B20_6_22;
  block[176] = -minus_B20_6_23;
  block[177] = -minus_B20_6_31;
  block[178] = -minus_B20_6_32;
  block[179] = -minus_B20_6_33;
  block[189] = t6_15;
  block[190] = t6_14;
  block[191] = t6_13;
  block[192] = t6_18;
  block[193] = t6_17;
  block[194] = t6_16;
  block[195] = t6_21;
  block[196] = t6_20;
  block[197] = t6_19;

  // ---- body 7 (body_7) on body 4
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
  // B16_7 = -R7^T omega7~ r7~
  const T t7_13 = R7_11 * omega7_2 - R7_21 * omega7_1;
  const T t7_14 = R7_31 * omega7_1 - R7_11 * omega7_3;
  const T minus_B16_7_11 = t7_13 * T(0.192) - t7_14 * T(0.487);
  const T t7_15 = R7_21 * omega7_3 - R7_31 * omega7_2;
  const T minus_B16_7_12 = t7_15 * T(0.487) - t7_13 * T(0.475);
  const T minus_B16_7_13 = t7_14 * T(0.475) - t7_15 * T(0.192);
  const T t7_16 = R7_12 * omega7_2 - R7_22 * omega7_1;
  const T t7_17 = R7_32 * omega7_1 - R7_12 * omega7_3;
  const T minus_B16_7_21 = t7_16 * T(0.192) - t7_17 * T(0.487);
  const T t7_18 = R7_22 * omega7_3 - R7_32 * omega7_2;
  const T minus_B16_7_22 = t7_18 * T(0.487) - t7_16 * T(0.475);
  const T minus_B16_7_23 = t7_17 * T(0.475) - t7_18 * T(0.192);
  const T t7_19 = R7_13 * omega7_2 - R7_23 * omega7_1;
  const T t7_20 = R7_33 * omega7_1 - R7_13 * omega7_3;
  const T minus_B16_7_31 = t7_19 * T(0.192) - t7_20 * T(0.487);
  const T t7_21 = R7_23 * omega7_3 - R7_33 * omega7_2;
  const T minus_B16_7_32 = t7_21 * T(0.487) - t7_19 * T(0.475);
  const T minus_B16_7_33 = t7_20 * T(0.475) - t7_21 * T(0.192);
  block[135] = -minus_B16_7_11;
  block[136] = -minus_B16_7_12;
  block[137] = -minus_B16_7_13;
  block[138] = -minus_B16_7_21;
  block[139] = -minus_B16_7_22;
  block[140] = -minus_B16_7_23;
  block[141] = -minus_B16_7_31;
  block[142] = -minus_B16_7_32;
  block[143] = -minus_B16_7_33;

  // ---- body 8 (body_8) on body 1
  const T eps8_1 = x[28], eps8_2 = x[29], eps8_3 = x[30], eps8_4 = x[31];
  const T s10_1 = x[75], s10_2 = x[76], s10_3 = x[77];
  const T omega8_1 = y[21], omega8_2 = y[22], omega8_3 = y[23];
  const T sdot10_1 = y[63], sdot10_2 = y[64], sdot10_3 = y[65];
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
  // B19_8 = -R8^T omega8~ r8~
  const T t8_13 = R8_11 * omega8_2 - R8_21 * omega8_1;
  const T t8_14 = R8_31 * omega8_1 - R8_11 * omega8_3;
  const T minus_B19_8_11 = t8_13 * T(0.416) - t8_14 * T(0.444);
  const T t8_15 = R8_21 * omega8_3 - R8_31 * omega8_2;
  const T minus_B19_8_12 = t8_15 * T(0.444) - t8_13 * T(0.392);
  const T minus_B19_8_13 = t8_14 * T(0.392) - t8_15 * T(0.416);
  const T t8_16 = R8_12 * omega8_2 - R8_22 * omega8_1;
  const T t8_17 = R8_32 * omega8_1 - R8_12 * omega8_3;
  const T minus_B19_8_21 = t8_16 * T(0.416) - t8_17 * T(0.444);
  const T t8_18 = R8_22 * omega8_3 - R8_32 * omega8_2;
  const T minus_B19_8_22 = t8_18 * T(0.444) - t8_16 * T(0.392);
  const T minus_B19_8_23 = t8_17 * T(0.392) - t8_18 * T(0.416);
  const T t8_19 = R8_13 * omega8_2 - R8_23 * omega8_1;
  const T t8_20 = R8_33 * omega8_1 - R8_13 * omega8_3;
  const T minus_B19_8_31 = t8_19 * T(0.416) - t8_20 * T(0.444);
  const T t8_21 = R8_23 * omega8_3 - R8_33 * omega8_2;
  const T minus_B19_8_32 = t8_21 * T(0.444) - t8_19 * T(0.392);
  const T minus_B19_8_33 = t8_20 * T(0.392) - t8_21 * T(0.416);
  block[162] = -minus_B19_8_11;
  block[163] = -minus_B19_8_12;
  block[164] = -minus_B19_8_13;
  block[165] = -minus_B19_8_21;
  block[166] = -minus_B19_8_22;
  block[167] = -minus_B19_8_23;
  block[168] = -minus_B19_8_31;
  block[169] = -minus_B19_8_32;
  block[170] = -minus_B19_8_33;
  // B23_8 = -R8^T omega8~ d10~ - R8^T sdot10~
  const T t8_22 = s10_3 - T(0.25);
  const T t8_23 = s10_2 - T(0.399);
  const T minus_B23_8_11 = t8_14 * t8_22 - t8_13 * t8_23 + R8_21 * sdot10_3 - R8_31 * sdot10_2;
  const T t8_24 = T(0.172) + s10_1;
  const T minus_B23_8_12 = t8_13 * t8_24 - t8_15 * t8_22 + R8_31 * sdot10_1 - R8_11 * sdot10_3;
  const T minus_B23_8_13 = t8_15 * t8_23 - t8_14 * t8_24 + R8_11 * sdot10_2 - R8_21 * sdot10_1;
  const T minus_B23_8_21 = t8_17 * t8_22 - t8_16 * t8_23 + R8_22 * sdot10_3 - R8_32 * sdot10_2;
  const T minus_B23_8_22 = t8_16 * t8_24 - t8_18 * t8_22 + R8_32 * sdot10_1 - R8_12 * sdot10_3;
  const T minus_B23_8_23 = t8_18 * t8_23 - t8_17 * t8_24 + R8_12 * sdot10_2 - R8_22 * sdot10_1;
  const T minus_B23_8_31 = t8_20 * t8_22 - t8_19 * t8_23 + R8_23 * sdot10_3 - R8_33 * sdot10_2;
  const T minus_B23_8_32 = t8_19 * t8_24 - t8_21 * t8_22 + R8_33 * sdot10_1 - R8_13 * sdot10_3;
  const T minus_B23_8_33 = t8_21 * t8_23 - t8_20 * t8_24 + R8_13 * sdot10_2 - R8_23 * sdot10_1;
  block[198] = -minus_B23_8_11;
  block[199] = -minus_B23_8_12;
  block[200] = -minus_B23_8_13;
  block[201] = -minus_B23_8_21;
  block[202] = -minus_B23_8_22;
  block[203] = -minus_B23_8_23;
  block[204] = -minus_B23_8_31;
  block[205] = -minus_B23_8_32;
  block[206] = -minus_B23_8_33;
  block[216] = t8_15;
  block[217] = t8_14;
  block[218] = t8_13;
  block[219] = t8_18;
  block[220] = t8_17;
  block[221] = t8_16;
  block[222] = t8_21;
  block[223] = t8_20;
  block[224] = t8_19;

  // ---- body 9 (body_9) on body 6
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
  // B21_9 = -R9^T omega9~ r9~
  const T t9_13 = R9_31 * omega9_1 - R9_11 * omega9_3;
  const T t9_14 = R9_11 * omega9_2 - R9_21 * omega9_1;
  const T B21_9_11 = t9_13 * T(0.015) + t9_14 * T(0.49);
  const T t9_15 = R9_21 * omega9_3 - R9_31 * omega9_2;
  const T minus_B21_9_12 = t9_15 * T(0.015) + t9_14 * T(0.362);
  const T minus_B21_9_13 = t9_15 * T(0.49) - t9_13 * T(0.362);
  const T t9_16 = R9_32 * omega9_1 - R9_12 * omega9_3;
  const T t9_17 = R9_12 * omega9_2 - R9_22 * omega9_1;
  const T B21_9_21 = t9_16 * T(0.015) + t9_17 * T(0.49);
  const T t9_18 = R9_22 * omega9_3 - R9_32 * omega9_2;
  const T minus_B21_9_22 = t9_18 * T(0.015) + t9_17 * T(0.362);
  const T minus_B21_9_23 = t9_18 * T(0.49) - t9_16 * T(0.362);
  const T t9_19 = R9_33 * omega9_1 - R9_13 * omega9_3;
  const T t9_20 = R9_13 * omega9_2 - R9_23 * omega9_1;
  const T B21_9_31 = t9_19 * T(0.015) + t9_20 * T(0.49);
  const T t9_21 = R9_23 * omega9_3 - R9_33 * omega9_2;
  const T minus_B21_9_32 = t9_21 * T(0.015) + t9_20 * T(0.362);
  const T minus_B21_9_33 = t9_21 * T(0.49) - t9_19 * T(0.362);
  block[180] = B21_9_11;
  block[181] = -minus_B21_9_12;
  block[182] = -minus_B21_9_13;
  block[183] = B21_9_21;
  block[184] = -minus_B21_9_22;
  block[185] = -minus_B21_9_23;
  block[186] = B21_9_31;
  block[187] = -minus_B21_9_32;
  block[188] = -minus_B21_9_33;

  // ---- body 10 (body_10) on body 8
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
  // B24_10 = -R10^T omega10~ r10~
  const T t10_13 = R10_31 * omega10_1 - R10_11 * omega10_3;
  const T t10_14 = R10_11 * omega10_2 - R10_21 * omega10_1;
  const T B24_10_11 = t10_13 * T(0.426) + t10_14 * T(0.148);
  const T t10_15 = R10_21 * omega10_3 - R10_31 * omega10_2;
  const T minus_B24_10_12 = t10_15 * T(0.426) + t10_14 * T(0.016);
  const T minus_B24_10_13 = t10_15 * T(0.148) - t10_13 * T(0.016);
  const T t10_16 = R10_32 * omega10_1 - R10_12 * omega10_3;
  const T t10_17 = R10_12 * omega10_2 - R10_22 * omega10_1;
  const T B24_10_21 = t10_16 * T(0.426) + t10_17 * T(0.148);
  const T t10_18 = R10_22 * omega10_3 - R10_32 * omega10_2;
  const T minus_B24_10_22 = t10_18 * T(0.426) + t10_17 * T(0.016);
  const T minus_B24_10_23 = t10_18 * T(0.148) - t10_16 * T(0.016);
  const T t10_19 = R10_33 * omega10_1 - R10_13 * omega10_3;
  const T t10_20 = R10_13 * omega10_2 - R10_23 * omega10_1;
  const T B24_10_31 = t10_19 * T(0.426) + t10_20 * T(0.148);
  const T t10_21 = R10_23 * omega10_3 - R10_33 * omega10_2;
  const T minus_B24_10_32 = t10_21 * T(0.426) + t10_20 * T(0.016);
  const T minus_B24_10_33 = t10_21 * T(0.148) - t10_19 * T(0.016);
  block[207] = B24_10_11;
  block[208] = -minus_B24_10_12;
  block[209] = -minus_B24_10_13;
  block[210] = B24_10_21;
  block[211] = -minus_B24_10_22;
  block[212] = -minus_B24_10_23;
  block[213] = B24_10_31;
  block[214] = -minus_B24_10_32;
  block[215] = -minus_B24_10_33;

  // ---- body 11 (body_11) on body 5
  const T eps11_1 = x[40], eps11_2 = x[41], eps11_3 = x[42], eps11_4 = x[43];
  const T s12_1 = x[81], s12_2 = x[82], s12_3 = x[83];
  const T omega11_1 = y[30], omega11_2 = y[31], omega11_3 = y[32];
  const T sdot12_1 = y[69], sdot12_2 = y[70], sdot12_3 = y[71];
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
  // B27_11 = -R11^T omega11~ r11~
  const T t11_13 = R11_31 * omega11_1 - R11_11 * omega11_3;
  const T t11_14 = R11_11 * omega11_2 - R11_21 * omega11_1;
  const T minus_B27_11_11 = t11_13 * T(0.337) + t11_14 * T(0.348);
  const T t11_15 = R11_21 * omega11_3 - R11_31 * omega11_2;
  const T minus_B27_11_12 = t11_14 * T(0.402) - t11_15 * T(0.337);
  const T B27_11_13 = t11_15 * T(0.348) + t11_13 * T(0.402);
  const T t11_16 = R11_32 * omega11_1 - R11_12 * omega11_3;
  const T t11_17 = R11_12 * omega11_2 - R11_22 * omega11_1;
  const T minus_B27_11_21 = t11_16 * T(0.337) + t11_17 * T(0.348);
  const T t11_18 = R11_22 * omega11_3 - R11_32 * omega11_2;
  const T minus_B27_11_22 = t11_17 * T(0.402) - t11_18 * T(0.337);
  const T B27_11_23 = t11_18 * T(0.348) + t11_16 * T(0.402);
  const T t11_19 = R11_33 * omega11_1 - R11_13 * omega11_3;
  const T t11_20 = R11_13 * omega11_2 - R11_23 * omega11_1;
  const T minus_B27_11_31 = t11_19 * T(0.337) + t11_20 * T(0.348);
  const T t11_21 = R11_23 * omega11_3 - R11_33 * omega11_2;
  const T minus_B27_11_32 = t11_20 * T(0.402) - t11_21 * T(0.337);
  const T B27_11_33 = t11_21 * T(0.348) + t11_19 * T(0.402);
  block[234] = -minus_B27_11_11;
  block[235] = -minus_B27_11_12;
  block[236] = B27_11_13;
  block[237] = -minus_B27_11_21;
  block[238] = -minus_B27_11_22;
  block[239] = B27_11_23;
  block[240] = -minus_B27_11_31;
  block[241] = -minus_B27_11_32;
  block[242] = B27_11_33;
  // B29_11 = -R11^T omega11~ d12~ - R11^T sdot12~
  const T t11_22 = T(0.022) + s12_3;
  const T t11_23 = T(0.42) + s12_2;
  const T minus_B29_11_11 = t11_13 * t11_22 - t11_14 * t11_23 + R11_21 * sdot12_3 - R11_31 * sdot12_2;
  const T t11_24 = s12_1 - T(0.422);
  const T minus_B29_11_12 = t11_14 * t11_24 - t11_15 * t11_22 + R11_31 * sdot12_1 - R11_11 * sdot12_3;
  const T minus_B29_11_13 = t11_15 * t11_23 - t11_13 * t11_24 + R11_11 * sdot12_2 - R11_21 * sdot12_1;
  const T minus_B29_11_21 = t11_16 * t11_22 - t11_17 * t11_23 + R11_22 * sdot12_3 - R11_32 * sdot12_2;
  const T minus_B29_11_22 = t11_17 * t11_24 - t11_18 * t11_22 + R11_32 * sdot12_1 - R11_12 * sdot12_3;
  const T minus_B29_11_23 = t11_18 * t11_23 - t11_16 * t11_24 + R11_12 * sdot12_2 - R11_22 * sdot12_1;
  const T minus_B29_11_31 = t11_19 * t11_22 - t11_20 * t11_23 + R11_23 * sdot12_3 - R11_33 * sdot12_2;
  const T minus_B29_11_32 = t11_20 * t11_24 - t11_21 * t11_22 + R11_33 * sdot12_1 - R11_13 * sdot12_3;
  const T minus_B29_11_33 = t11_21 * t11_23 - t11_19 * t11_24 + R11_13 * sdot12_2 - R11_23 * sdot12_1;
  block[252] = -minus_B29_11_11;
  block[253] = -minus_B29_11_12;
  block[254] = -minus_B29_11_13;
  block[255] = -minus_B29_11_21;
  block[256] = -minus_B29_11_22;
  block[257] = -minus_B29_11_23;
  block[258] = -minus_B29_11_31;
  block[259] = -minus_B29_11_32;
  block[260] = -minus_B29_11_33;
  block[270] = t11_15;
  block[271] = t11_13;
  block[272] = t11_14;
  block[273] = t11_18;
  block[274] = t11_16;
  block[275] = t11_17;
  block[276] = t11_21;
  block[277] = t11_19;
  block[278] = t11_20;

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
  // B30_12 = -R12^T omega12~ r12~
  const T t12_13 = R12_11 * omega12_2 - R12_21 * omega12_1;
  const T t12_14 = R12_31 * omega12_1 - R12_11 * omega12_3;
  const T minus_B30_12_11 = t12_13 * T(0.141) - t12_14 * T(0.1);
  const T t12_15 = R12_21 * omega12_3 - R12_31 * omega12_2;
  const T minus_B30_12_12 = t12_15 * T(0.1) - t12_13 * T(0.006);
  const T minus_B30_12_13 = t12_14 * T(0.006) - t12_15 * T(0.141);
  const T t12_16 = R12_12 * omega12_2 - R12_22 * omega12_1;
  const T t12_17 = R12_32 * omega12_1 - R12_12 * omega12_3;
  const T minus_B30_12_21 = t12_16 * T(0.141) - t12_17 * T(0.1);
  const T t12_18 = R12_22 * omega12_3 - R12_32 * omega12_2;
  const T minus_B30_12_22 = t12_18 * T(0.1) - t12_16 * T(0.006);
  const T minus_B30_12_23 = t12_17 * T(0.006) - t12_18 * T(0.141);
  const T t12_19 = R12_13 * omega12_2 - R12_23 * omega12_1;
  const T t12_20 = R12_33 * omega12_1 - R12_13 * omega12_3;
  const T minus_B30_12_31 = t12_19 * T(0.141) - t12_20 * T(0.1);
  const T t12_21 = R12_23 * omega12_3 - R12_33 * omega12_2;
  const T minus_B30_12_32 = t12_21 * T(0.1) - t12_19 * T(0.006);
  const T minus_B30_12_33 = t12_20 * T(0.006) - t12_21 * T(0.141);
  block[261] = -minus_B30_12_11;
  block[262] = -minus_B30_12_12;
  block[263] = -minus_B30_12_13;
  block[264] = -minus_B30_12_21;
  block[265] = -minus_B30_12_22;
  block[266] = -minus_B30_12_23;
  block[267] = -minus_B30_12_31;
  block[268] = -minus_B30_12_32;
  block[269] = -minus_B30_12_33;

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,0}, {1,216}, {2,219}, {3,255}, {1,432}, {4,435}, {5,438}, {3,471}, {6,474}, {1,648}, {4,651}, {7,654},
      {8,657}, {3,687}, {6,690}, {9,693}, {1,864}, {4,867}, {10,870}, {11,876}, {3,903}, {6,906}, {9,912}, {1,1080},
      {12,1083}, {13,1095}, {3,1119}, {6,1131}, {1,1296}, {4,1299}, {7,1302}, {14,1305}, {15,1314}, {3,1335},
      {6,1338}, {9,1341}, {16,1350}, {17,1512}, {18,1533}, {3,1569}, {1,1728}, {12,1731}, {19,1743}, {20,1752},
      {3,1767}, {6,1779}, {21,1788}, {17,1944}, {22,1965}, {23,1971}, {3,2001}, {24,2007}, {1,2160}, {4,2163},
      {10,2166}, {25,2172}, {26,2190}, {3,2199}, {6,2202}, {9,2208}, {27,2226}, {1,2376}, {4,2379}, {10,2382},
      {25,2388}, {28,2406}, {29,2409}, {3,2415}, {6,2418}, {9,2424}, {27,2442}, {30,2445},
  };
  for (int i = 0; i < 2592; ++i) v_y_dot[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y_dot[place[1] + i * 72 + j] = block[9 * place[0] + 3 * i + j];
}

}  // namespace kanec::random_12
