// SPDX-License-Identifier: BSD-3-Clause
// satellite: equations of motion of 4 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 902e52c4611d383e of satellite/scene.toml; functions kinematics poses energy momentum power accelerations
// residual mass_matrix kinematics+accelerations state_matrix input_matrix tip_position tip_acceleration
// bodies and their joints:
//   1 hub on the inertial frame: free
//   2 left_panel on 1: revolute
//   3 right_panel on 1: revolute
//   4 wheel on 1: revolute
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, theta_2, theta_3, theta_4, s_1_1 .. s_1_3)
//   y = (omega_1_1 .. omega_1_3, thetadot_2, thetadot_3, thetadot_4, sdot_1_1 .. sdot_1_3)
//   eps       Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)
//   theta     angle of a joint about its axis [rad]
//   s         translation from the joint point, axes of the lower body [m]
//   omega     absolute angular velocity, body axes [rad/s] (3)
//   thetadot  rate of theta [rad/s]
//   sdot      rate of s [m/s]
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one, and of
// its own or by conversion cos, sin.
//
// operations of one call (adds + multiplies + divides):
//   kinematics                    23 (8 add, 15 multiply)
//   poses                         132 (60 add, 72 multiply, 6 sine or cosine)
//   energy                        230 (99 add, 131 multiply, 6 sine or cosine)
//   momentum                      389 (180 add, 209 multiply, 6 sine or cosine)
//   power                         62 (26 add, 36 multiply)
//   accelerations                 663 (297 add, 360 multiply, 6 divide, 6 sine or cosine)
//   residual                      431 (209 add, 222 multiply, 6 sine or cosine)
//   mass_matrix                   164 (77 add, 87 multiply, 6 sine or cosine)
//   kinematics_and_accelerations  686 (305 add, 375 multiply, 6 divide, 6 sine or cosine)
//   state_matrix                  3411 (1585 add, 1820 multiply, 6 divide, 6 sine or cosine)
//   input_matrix                  402 (175 add, 221 multiply, 6 divide, 6 sine or cosine)
//   tip_position                  40 (16 add, 24 multiply, 2 sine or cosine)
//   tip_acceleration              131 (55 add, 76 multiply, 2 sine or cosine)
#pragma once

#include <cmath>

namespace kanec::satellite {

inline constexpr int n_bodies = 4;
inline constexpr int nx = 10;
inline constexpr int ny = 9;
inline constexpr int n_parameters = 2;
inline constexpr int n_inputs = 2;
inline constexpr char model_hash[] = "902e52c4611d383e";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, theta_2 = 4, theta_3 = 5, theta_4 = 6,
    s_1_1 = 7, s_1_2 = 8, s_1_3 = 9;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, thetadot_2 = 3, thetadot_3 = 4, thetadot_4 = 5,
    sdot_1_1 = 6, sdot_1_2 = 7, sdot_1_3 = 8;
inline constexpr int hub_eps_1 = 0, hub_eps_2 = 1, hub_eps_3 = 2, hub_eps_4 = 3, left_panel_theta = 4,
    right_panel_theta = 5, wheel_theta = 6, hub_s_1 = 7, hub_s_2 = 8, hub_s_3 = 9;
inline constexpr int hub_omega_1 = 0, hub_omega_2 = 1, hub_omega_3 = 2, left_panel_thetadot = 3,
    right_panel_thetadot = 4, wheel_thetadot = 5, hub_sdot_1 = 6, hub_sdot_2 = 7, hub_sdot_3 = 8;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 55;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 3, 3,
    3, 3, 3, 4, 4, 4, 4, 4, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 1, 2, 5, 6, 7, 8, 0, 1, 2, 5, 6, 7, 8, 0,
    3, 6, 7, 8, 0, 4, 6, 7, 8, 0, 1, 2, 5, 0, 1, 2, 3, 4, 6, 0, 1, 2, 3, 4, 7, 0, 1, 2, 3, 4, 8};

// Entries of state_matrix that are not always 0, row by row.
inline constexpr int state_matrix_nonzeros = 105;
inline constexpr int state_matrix_rows[] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 9, 9, 9, 9, 9, 9,
    10, 10, 10, 10, 10, 10, 10, 10, 10, 11, 11, 11, 11, 11, 11, 11, 11, 11, 12, 12, 12, 12, 12, 12, 12, 12, 12, 13,
    13, 13, 13, 13, 13, 13, 13, 13, 14, 14, 14, 14, 14, 14, 14, 14, 14, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15,
    15, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17};
inline constexpr int state_matrix_columns[] = {1, 2, 9, 0, 2, 10, 0, 1, 11, 12, 13, 14, 15, 16, 17, 3, 4, 5, 9, 10,
    11, 12, 13, 14, 3, 4, 5, 9, 10, 11, 12, 13, 14, 3, 4, 5, 9, 10, 11, 12, 13, 14, 3, 4, 5, 9, 10, 11, 12, 13, 14, 3,
    4, 5, 9, 10, 11, 12, 13, 14, 3, 4, 5, 9, 10, 11, 12, 13, 14, 0, 1, 2, 3, 4, 5, 9, 10, 11, 12, 13, 14, 0, 1, 2, 3,
    4, 5, 9, 10, 11, 12, 13, 14, 0, 1, 2, 3, 4, 5, 9, 10, 11, 12, 13, 14};

// Entries of input_matrix that are not always 0, row by row.
inline constexpr int input_matrix_nonzeros = 18;
inline constexpr int input_matrix_rows[] = {9, 9, 10, 10, 11, 11, 12, 12, 13, 13, 14, 14, 15, 15, 16, 16, 17, 17};
inline constexpr int input_matrix_columns[] = {0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1, 0, 1};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T k = T(2);
  T c = T(0.02);
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
  T wheel_torque = T(0.05);
  T thrust = T(0);
};

// What depends on parameters only, computed once for many calls.
template <class T>
struct Prepared {
  Parameters<T> p;
  T c0_1;
};

// prepare: 0 add, 1 multiply
template <class T>
Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  Prepared<T> c{};
  c.p = p;
  const T c0_1 = T(0.08333333333333333) * p.c;
  c.c0_1 = c0_1;
  return c;
}

// kinematics: xdot, the kinematical equations.
// rates of x (nx) [1/s], [rad/s], [m/s]
// 8 add, 15 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* xdot) noexcept {

  // ---- body 1 (hub) on the inertial frame
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
  const T thetadot2 = y[3];
  const T thetadot3 = y[4];
  const T thetadot4 = y[5];
  const T sdot1_1 = y[6], sdot1_2 = y[7], sdot1_3 = y[8];
  xdot[4] = thetadot2;
  xdot[5] = thetadot3;
  xdot[6] = thetadot4;
  xdot[7] = sdot1_1;
  xdot[8] = sdot1_2;
  xdot[9] = sdot1_3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 60 add, 72 multiply, 6 sine or cosine
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hub) on the inertial frame
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
  pose[12] = R1_11;
  pose[24] = R1_11;
  pose[1] = R1_12;
  pose[13] = R1_12;
  pose[25] = R1_12;
  pose[2] = R1_13;
  pose[14] = R1_13;
  pose[26] = R1_13;
  pose[3] = R1_21;
  pose[4] = R1_22;
  pose[5] = R1_23;
  pose[6] = R1_31;
  pose[7] = R1_32;
  pose[8] = R1_33;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T s1_1 = x[7], s1_2 = x[8], s1_3 = x[9];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_21 = R1_21 * E2_22 + R1_31 * E2_23;
  const T R2_22 = R1_22 * E2_22 + R1_32 * E2_23;
  const T R2_23 = R1_23 * E2_22 + R1_33 * E2_23;
  const T R2_31 = R1_31 * E2_22 - R1_21 * E2_23;
  const T R2_32 = R1_32 * E2_22 - R1_22 * E2_23;
  const T R2_33 = R1_33 * E2_22 - R1_23 * E2_23;
  pose[15] = R2_21;
  pose[16] = R2_22;
  pose[17] = R2_23;
  pose[18] = R2_31;
  pose[19] = R2_32;
  pose[20] = R2_33;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_1 = R1_21 * T(0.6);
  const T P2_1 = s1_1 + t2_1;
  const T t2_2 = R1_22 * T(0.6);
  const T P2_2 = s1_2 + t2_2;
  const T t2_3 = R1_23 * T(0.6);
  const T P2_3 = s1_3 + t2_3;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = R2_21 + P2_1;
  const T p2_2 = R2_22 + P2_2;
  const T p2_3 = R2_23 + P2_3;
  pose[21] = p2_1;
  pose[22] = p2_2;
  pose[23] = p2_3;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_21 = R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_31 * E3_22 - R1_21 * E3_23;
  const T R3_32 = R1_32 * E3_22 - R1_22 * E3_23;
  const T R3_33 = R1_33 * E3_22 - R1_23 * E3_23;
  pose[27] = R3_21;
  pose[28] = R3_22;
  pose[29] = R3_23;
  pose[30] = R3_31;
  pose[31] = R3_32;
  pose[32] = R3_33;
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T P3_1 = s1_1 - t2_1;
  const T P3_2 = s1_2 - t2_2;
  const T P3_3 = s1_3 - t2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 - R3_21;
  const T p3_2 = P3_2 - R3_22;
  const T p3_3 = P3_3 - R3_23;
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (wheel) on body 1
  const T theta4 = x[6];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cos(theta4);
  const T E4_11 = t4_1 * T(0.6666666666666666) + T(0.3333333333333334);
  const T t4_2 = sin(theta4) * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;
  // R4^T = R1^T E4^T: R takes inertial components to body components
  const T R4_11 = R1_11 * E4_11 + R1_21 * E4_12 + R1_31 * E4_13;
  const T R4_12 = R1_12 * E4_11 + R1_22 * E4_12 + R1_32 * E4_13;
  const T R4_13 = R1_13 * E4_11 + R1_23 * E4_12 + R1_33 * E4_13;
  const T R4_21 = R1_11 * E4_13 + R1_21 * E4_11 + R1_31 * E4_12;
  const T R4_22 = R1_12 * E4_13 + R1_22 * E4_11 + R1_32 * E4_12;
  const T R4_23 = R1_13 * E4_13 + R1_23 * E4_11 + R1_33 * E4_12;
  const T R4_31 = R1_11 * E4_12 + R1_21 * E4_13 + R1_31 * E4_11;
  const T R4_32 = R1_12 * E4_12 + R1_22 * E4_13 + R1_32 * E4_11;
  const T R4_33 = R1_13 * E4_12 + R1_23 * E4_13 + R1_33 * E4_11;
  pose[36] = R4_11;
  pose[37] = R4_12;
  pose[38] = R4_13;
  pose[39] = R4_21;
  pose[40] = R4_22;
  pose[41] = R4_23;
  pose[42] = R4_31;
  pose[43] = R4_32;
  pose[44] = R4_33;
  // P4 = s1 + R1^T q4: position of the body origin, inertial axes [m]
  const T P4_1 = s1_1 - R1_31 * T(0.2);
  const T P4_2 = s1_2 - R1_32 * T(0.2);
  const T P4_3 = s1_3 - R1_33 * T(0.2);
  pose[45] = P4_1;
  pose[46] = P4_2;
  pose[47] = P4_3;

  // ---- results
  pose[9] = s1_1;
  pose[10] = s1_2;
  pose[11] = s1_3;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 99 add, 131 multiply, 6 sine or cosine
template <class T>
void energy(const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hub) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T theta2 = x[4];
  const T theta3 = x[5];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[6], sdot1_2 = y[7], sdot1_3 = y[8];
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
  // T1 = 1/2 sdot1 . sdot1 m1 + 1/2 omega1 . (I1 omega1): kinetic energy [J]
  const T t1_13 = T(0.2) * omega1_2;
  const T t1_14 = T(0.2) * omega1_1;
  const T T1 = T(0.5) * (sdot1_1 * sdot1_1 + sdot1_2 * sdot1_2 + sdot1_3 * sdot1_3) * T(120) + T(0.5) * (omega1_1 *
      (T(16) * omega1_1 + t1_13 - T(0.1) * omega1_3) + omega1_2 * (t1_14 + T(14) * omega1_2 + T(0.3) * omega1_3) +
      omega1_3 * (T(0.3) * omega1_2 - T(0.1) * omega1_1 + T(18) * omega1_3));
  // potential = 1/2 theta2^2 k_left_panel_ + 1/2 theta3^2 k_right_panel_: potential energy of gravity and springs [J]
  const T potential = theta2 * theta2 * T(0.5) * c.p.k + theta3 * theta3 * T(0.5) * c.p.k;
  energy[1] = potential;

  // ---- body 2 (left_panel) on body 1
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_31 = R1_31 * E2_22 - R1_21 * E2_23;
  const T R2_32 = R1_32 * E2_22 - R1_22 * E2_23;
  const T R2_33 = R1_33 * E2_22 - R1_23 * E2_23;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_1 = omega1_1 * T(0.6);
  const T t2_2 = omega1_3 * T(0.6);
  const T t2_3 = R1_31 * t2_1 - R1_11 * t2_2;
  const T Pdot2_1 = sdot1_1 + t2_3;
  const T t2_4 = R1_32 * t2_1 - R1_12 * t2_2;
  const T Pdot2_2 = sdot1_2 + t2_4;
  const T t2_5 = R1_33 * t2_1 - R1_13 * t2_2;
  const T Pdot2_3 = sdot1_3 + t2_5;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T v2_1 = R2_31 * omega2_1 - R1_11 * omega2_3 + Pdot2_1;
  const T v2_2 = R2_32 * omega2_1 - R1_12 * omega2_3 + Pdot2_2;
  const T v2_3 = R2_33 * omega2_1 - R1_13 * omega2_3 + Pdot2_3;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (T(3) * omega2_1 * omega2_1 + T(0.75) * omega2_2 * omega2_2 + T(3.75) * omega2_3 * omega2_3) +
      T(4.5) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (right_panel) on body 1
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_31 = R1_31 * E3_22 - R1_21 * E3_23;
  const T R3_32 = R1_32 * E3_22 - R1_22 * E3_23;
  const T R3_33 = R1_33 * E3_22 - R1_23 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // Pdot3 = sdot1 + R1^T omega1~ q3: velocity of the body origin, inertial axes [m/s]
  const T Pdot3_1 = sdot1_1 - t2_3;
  const T Pdot3_2 = sdot1_2 - t2_4;
  const T Pdot3_3 = sdot1_3 - t2_5;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T v3_1 = R1_11 * omega3_3 - R3_31 * omega3_1 + Pdot3_1;
  const T v3_2 = R1_12 * omega3_3 - R3_32 * omega3_1 + Pdot3_2;
  const T v3_3 = R1_13 * omega3_3 - R3_33 * omega3_1 + Pdot3_3;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (T(3) * omega3_1 * omega3_1 + T(0.75) * omega3_2 * omega3_2 + T(3.75) * omega3_3 * omega3_3) +
      T(4.5) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (wheel) on body 1
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cos(theta4);
  const T E4_11 = t4_1 * T(0.6666666666666666) + T(0.3333333333333334);
  const T t4_2 = sin(theta4) * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;
  // omega4 = thetadot4 b4 + E4 omega1: absolute angular velocity, body axes [rad/s]
  const T t4_4 = thetadot4 * T(0.5773502691896257);
  const T omega4_1 = t4_4 + E4_11 * omega1_1 + E4_12 * omega1_2 + E4_13 * omega1_3;
  const T omega4_2 = t4_4 + E4_13 * omega1_1 + E4_11 * omega1_2 + E4_12 * omega1_3;
  const T omega4_3 = t4_4 + E4_12 * omega1_1 + E4_13 * omega1_2 + E4_11 * omega1_3;
  // Pdot4 = sdot1 + R1^T omega1~ q4: velocity of the body origin, inertial axes [m/s]
  const T Pdot4_1 = sdot1_1 + R1_21 * t1_14 - R1_11 * t1_13;
  const T Pdot4_2 = sdot1_2 + R1_22 * t1_14 - R1_12 * t1_13;
  const T Pdot4_3 = sdot1_3 + R1_23 * t1_14 - R1_13 * t1_13;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 Pdot4 . Pdot4: kinetic energy [J]
  const T t4_5 = T(0.0021) * omega4_2;
  const T t4_6 = T(0.0021) * omega4_3;
  const T t4_7 = T(0.0021) * omega4_1;
  const T T4 = T(0.5) * (omega4_1 * (T(0.0158) * omega4_1 + t4_5 + t4_6) + omega4_2 * (t4_7 + T(0.0158) * omega4_2 +
      t4_6) + omega4_3 * (t4_7 + t4_5 + T(0.0158) * omega4_3)) + T(2) * (Pdot4_1 * Pdot4_1 + Pdot4_2 * Pdot4_2 +
      Pdot4_3 * Pdot4_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4;
  energy[0] = kinetic;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 180 add, 209 multiply, 6 sine or cosine
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hub) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[7], s1_2 = x[8], s1_3 = x[9];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[6], sdot1_2 = y[7], sdot1_3 = y[8];
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
  // l1 = m1 sdot1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(120) * sdot1_1;
  const T l1_2 = T(120) * sdot1_2;
  const T l1_3 = T(120) * sdot1_3;
  // H1 = s1~ l1 + R1^T I1 omega1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_13 = T(0.2) * omega1_2;
  const T t1_14 = T(16) * omega1_1 + t1_13 - T(0.1) * omega1_3;
  const T t1_15 = T(0.2) * omega1_1;
  const T t1_16 = t1_15 + T(14) * omega1_2 + T(0.3) * omega1_3;
  const T t1_17 = T(0.3) * omega1_2 - T(0.1) * omega1_1 + T(18) * omega1_3;
  const T H1_1 = s1_2 * l1_3 - s1_3 * l1_2 + R1_11 * t1_14 + R1_21 * t1_16 + R1_31 * t1_17;
  const T H1_2 = s1_3 * l1_1 - s1_1 * l1_3 + R1_12 * t1_14 + R1_22 * t1_16 + R1_32 * t1_17;
  const T H1_3 = s1_1 * l1_2 - s1_2 * l1_1 + R1_13 * t1_14 + R1_23 * t1_16 + R1_33 * t1_17;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_21 = R1_21 * E2_22 + R1_31 * E2_23;
  const T R2_22 = R1_22 * E2_22 + R1_32 * E2_23;
  const T R2_23 = R1_23 * E2_22 + R1_33 * E2_23;
  const T R2_31 = R1_31 * E2_22 - R1_21 * E2_23;
  const T R2_32 = R1_32 * E2_22 - R1_22 * E2_23;
  const T R2_33 = R1_33 * E2_22 - R1_23 * E2_23;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_1 = R1_21 * T(0.6);
  const T P2_1 = s1_1 + t2_1;
  const T t2_2 = R1_22 * T(0.6);
  const T P2_2 = s1_2 + t2_2;
  const T t2_3 = R1_23 * T(0.6);
  const T P2_3 = s1_3 + t2_3;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = R2_21 + P2_1;
  const T p2_2 = R2_22 + P2_2;
  const T p2_3 = R2_23 + P2_3;
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_4 = omega1_1 * T(0.6);
  const T t2_5 = omega1_3 * T(0.6);
  const T t2_6 = R1_31 * t2_4 - R1_11 * t2_5;
  const T Pdot2_1 = sdot1_1 + t2_6;
  const T t2_7 = R1_32 * t2_4 - R1_12 * t2_5;
  const T Pdot2_2 = sdot1_2 + t2_7;
  const T t2_8 = R1_33 * t2_4 - R1_13 * t2_5;
  const T Pdot2_3 = sdot1_3 + t2_8;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T v2_1 = R2_31 * omega2_1 - R1_11 * omega2_3 + Pdot2_1;
  const T v2_2 = R2_32 * omega2_1 - R1_12 * omega2_3 + Pdot2_2;
  const T v2_3 = R2_33 * omega2_1 - R1_13 * omega2_3 + Pdot2_3;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(9) * v2_1;
  const T l2_2 = T(9) * v2_2;
  const T l2_3 = T(9) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_9 = T(3) * omega2_1;
  const T t2_10 = T(0.75) * omega2_2;
  const T t2_11 = T(3.75) * omega2_3;
  const T H2_1 = R1_11 * t2_9 + R2_21 * t2_10 + R2_31 * t2_11 + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = R1_12 * t2_9 + R2_22 * t2_10 + R2_32 * t2_11 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = R1_13 * t2_9 + R2_23 * t2_10 + R2_33 * t2_11 + p2_1 * l2_2 - p2_2 * l2_1;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_21 = R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_31 * E3_22 - R1_21 * E3_23;
  const T R3_32 = R1_32 * E3_22 - R1_22 * E3_23;
  const T R3_33 = R1_33 * E3_22 - R1_23 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T P3_1 = s1_1 - t2_1;
  const T P3_2 = s1_2 - t2_2;
  const T P3_3 = s1_3 - t2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 - R3_21;
  const T p3_2 = P3_2 - R3_22;
  const T p3_3 = P3_3 - R3_23;
  // Pdot3 = sdot1 + R1^T omega1~ q3: velocity of the body origin, inertial axes [m/s]
  const T Pdot3_1 = sdot1_1 - t2_6;
  const T Pdot3_2 = sdot1_2 - t2_7;
  const T Pdot3_3 = sdot1_3 - t2_8;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T v3_1 = R1_11 * omega3_3 - R3_31 * omega3_1 + Pdot3_1;
  const T v3_2 = R1_12 * omega3_3 - R3_32 * omega3_1 + Pdot3_2;
  const T v3_3 = R1_13 * omega3_3 - R3_33 * omega3_1 + Pdot3_3;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(9) * v3_1;
  const T l3_2 = T(9) * v3_2;
  const T l3_3 = T(9) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_1 = T(3) * omega3_1;
  const T t3_2 = T(0.75) * omega3_2;
  const T t3_3 = T(3.75) * omega3_3;
  const T H3_1 = R1_11 * t3_1 + R3_21 * t3_2 + R3_31 * t3_3 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = R1_12 * t3_1 + R3_22 * t3_2 + R3_32 * t3_3 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R1_13 * t3_1 + R3_23 * t3_2 + R3_33 * t3_3 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (wheel) on body 1
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cos(theta4);
  const T E4_11 = t4_1 * T(0.6666666666666666) + T(0.3333333333333334);
  const T t4_2 = sin(theta4) * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;
  // R4^T = R1^T E4^T: R takes inertial components to body components
  const T R4_11 = R1_11 * E4_11 + R1_21 * E4_12 + R1_31 * E4_13;
  const T R4_12 = R1_12 * E4_11 + R1_22 * E4_12 + R1_32 * E4_13;
  const T R4_13 = R1_13 * E4_11 + R1_23 * E4_12 + R1_33 * E4_13;
  const T R4_21 = R1_11 * E4_13 + R1_21 * E4_11 + R1_31 * E4_12;
  const T R4_22 = R1_12 * E4_13 + R1_22 * E4_11 + R1_32 * E4_12;
  const T R4_23 = R1_13 * E4_13 + R1_23 * E4_11 + R1_33 * E4_12;
  const T R4_31 = R1_11 * E4_12 + R1_21 * E4_13 + R1_31 * E4_11;
  const T R4_32 = R1_12 * E4_12 + R1_22 * E4_13 + R1_32 * E4_11;
  const T R4_33 = R1_13 * E4_12 + R1_23 * E4_13 + R1_33 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega1: absolute angular velocity, body axes [rad/s]
  const T t4_4 = thetadot4 * T(0.5773502691896257);
  const T omega4_1 = t4_4 + E4_11 * omega1_1 + E4_12 * omega1_2 + E4_13 * omega1_3;
  const T omega4_2 = t4_4 + E4_13 * omega1_1 + E4_11 * omega1_2 + E4_12 * omega1_3;
  const T omega4_3 = t4_4 + E4_12 * omega1_1 + E4_13 * omega1_2 + E4_11 * omega1_3;
  // P4 = s1 + R1^T q4: position of the body origin, inertial axes [m]
  const T P4_1 = s1_1 - R1_31 * T(0.2);
  const T P4_2 = s1_2 - R1_32 * T(0.2);
  const T P4_3 = s1_3 - R1_33 * T(0.2);
  // Pdot4 = sdot1 + R1^T omega1~ q4: velocity of the body origin, inertial axes [m/s]
  const T Pdot4_1 = sdot1_1 + R1_21 * t1_15 - R1_11 * t1_13;
  const T Pdot4_2 = sdot1_2 + R1_22 * t1_15 - R1_12 * t1_13;
  const T Pdot4_3 = sdot1_3 + R1_23 * t1_15 - R1_13 * t1_13;
  // l4 = m4 Pdot4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(4) * Pdot4_1;
  const T l4_2 = T(4) * Pdot4_2;
  const T l4_3 = T(4) * Pdot4_3;
  // H4 = R4^T I4 omega4 + P4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_5 = T(0.0021) * omega4_2;
  const T t4_6 = T(0.0021) * omega4_3;
  const T t4_7 = T(0.0158) * omega4_1 + t4_5 + t4_6;
  const T t4_8 = T(0.0021) * omega4_1;
  const T t4_9 = t4_8 + T(0.0158) * omega4_2 + t4_6;
  const T t4_10 = t4_8 + t4_5 + T(0.0158) * omega4_3;
  const T H4_1 = R4_11 * t4_7 + R4_21 * t4_9 + R4_31 * t4_10 + P4_2 * l4_3 - P4_3 * l4_2;
  const T H4_2 = R4_12 * t4_7 + R4_22 * t4_9 + R4_32 * t4_10 + P4_3 * l4_1 - P4_1 * l4_3;
  const T H4_3 = R4_13 * t4_7 + R4_23 * t4_9 + R4_33 * t4_10 + P4_1 * l4_2 - P4_2 * l4_1;

  // ---- whole system
  // linear = l1 + l2 + l3 + l4: linear momentum of the system [kg m/s]
  const T linear_1 = l1_1 + l2_1 + l3_1 + l4_1;
  const T linear_2 = l1_2 + l2_2 + l3_2 + l4_2;
  const T linear_3 = l1_3 + l2_3 + l3_3 + l4_3;
  momentum[0] = linear_1;
  momentum[1] = linear_2;
  momentum[2] = linear_3;
  // angular = H1 + H2 + H3 + H4: angular momentum of the system about the inertial origin [kg m^2/s]
  const T angular_1 = H1_1 + H2_1 + H3_1 + H4_1;
  const T angular_2 = H1_2 + H2_2 + H3_2 + H4_2;
  const T angular_3 = H1_3 + H2_3 + H3_3 + H4_3;
  momentum[3] = angular_1;
  momentum[4] = angular_2;
  momentum[5] = angular_3;
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 26 add, 36 multiply
template <class T>
void power(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* out) noexcept {

  // ---- body 1 (hub) on the inertial frame
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

  // ---- body 2 (left_panel) on body 1
  const T thetadot2 = y[3];
  // damping_left_panel_2 = -thetadot2 c_left_panel_: along the coordinate [N m], [N]
  const T minus_damping_left_panel_2 = thetadot2 * c.p.c;

  // ---- body 3 (right_panel) on body 1
  const T thetadot3 = y[4];
  // damping_right_panel_3 = -thetadot3 c_right_panel_: along the coordinate [N m], [N]
  const T minus_damping_right_panel_3 = thetadot3 * c.p.c;

  // ---- whole system
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T thetadot4 = y[5];
  const T sdot1_1 = y[6], sdot1_2 = y[7], sdot1_3 = y[8];
  // power = (R1^T F_thruster_) . (sdot1 + R1^T omega1~ r_thruster_) + thetadot2 damping_left_panel_2 + thetadot3
  //   damping_right_panel_3 + thetadot4 tau_wheel_: power of the applied loads [W]
  const T b0_1 = T(0.1) * omega1_3;
  const T b0_2 = T(0.5) * omega1_3;
  const T b0_3 = T(0.1) * omega1_1 + T(0.5) * omega1_2;
  const T power = R1_11 * u.thrust * (sdot1_1 - R1_11 * b0_1 - R1_21 * b0_2 + R1_31 * b0_3) + R1_12 * u.thrust *
      (sdot1_2 - R1_12 * b0_1 - R1_22 * b0_2 + R1_32 * b0_3) + R1_13 * u.thrust * (sdot1_3 - R1_13 * b0_1 - R1_23 *
      b0_2 + R1_33 * b0_3) - thetadot2 * minus_damping_left_panel_2 - thetadot3 * minus_damping_right_panel_3 +
      thetadot4 * u.wheel_torque;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 297 add, 360 multiply, 6 divide, 6 sine or cosine
template <class T>
void accelerations(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hub) on the inertial frame
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
  // N1 = -omega1~ I1 omega1 + r_thruster_~ F_thruster_: applied less inertia moment at ydot = 0, body axes [N m]
  const T t1_13 = omega1_2 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T t1_15 = omega1_3 * omega1_3;
  const T t1_16 = omega1_1 * omega1_2;
  const T t1_17 = omega1_1 * omega1_3;
  const T minus_N1_1 = T(4) * t1_13 + T(0.3) * (t1_14 - t1_15) - T(0.1) * t1_16 - T(0.2) * t1_17;
  const T t1_18 = omega1_1 * omega1_1;
  const T minus_N1_2 = T(0.2) * t1_13 - (T(2) * t1_17 + T(0.1) * (t1_15 - t1_18)) - T(0.3) * t1_16;
  const T minus_N1_3 = T(0.1) * u.thrust + T(0.2) * (t1_18 - t1_14) - T(2) * t1_16 + T(0.3) * t1_17 + T(0.1) * t1_13;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_2 = thetadot2 * omega2_3;
  const T minus_omegadot2_3 = thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_2 * omega2_1;
  const T U2_12 = t2_1 + minus_omegadot2_3;
  const T U2_21 = t2_1 - minus_omegadot2_3;
  const T minus_U2_22 = omega2_3 * omega2_3 + omega2_1 * omega2_1;
  const T U2_23 = omega2_3 * omega2_2;
  const T U2_31 = omega2_3 * omega2_1 - omegadot2_2;
  // Pddot2 = E2 omega1~ omega1~ q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_2 = omega1_1 * T(0.6);
  const T Pddot2_1 = omega1_2 * t2_2;
  const T t2_3 = omega1_3 * T(0.6);
  const T t2_4 = omega1_2 * t2_3;
  const T t2_5 = omega1_3 * t2_3 + omega1_1 * t2_2;
  const T Pddot2_2 = E2_23 * t2_4 - E2_22 * t2_5;
  const T Pddot2_3 = E2_23 * t2_5 + E2_22 * t2_4;
  // effort_left_panel_2 = -theta2 k_left_panel_ - thetadot2 c_left_panel_: along the coordinate [N m], [N]
  const T minus_effort_left_panel_2 = theta2 * c.p.k + thetadot2 * c.p.c;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a2_1 = U2_12 + Pddot2_1;
  const T a2_2 = Pddot2_2 - minus_U2_22;
  const T a2_3 = U2_23 + Pddot2_3;
  // G2 = -m2 a2: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G2_1 = T(9) * a2_1;
  const T minus_G2_2 = T(9) * a2_2;
  const T minus_G2_3 = T(9) * a2_3;
  // N2 = -axial(U2 (tr(I2)/2 - I2)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N2_1 = T(3) * U2_23;
  const T N2_2 = T(0.75) * U2_31;
  const T minus_N2_3 = T(0.75) * U2_21 - T(3) * U2_12;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // omegadot3 = -thetadot3 b3~ E3 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot3_2 = thetadot3 * omega3_3;
  const T minus_omegadot3_3 = thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_2 * omega3_1;
  const T U3_12 = t3_1 + minus_omegadot3_3;
  const T U3_21 = t3_1 - minus_omegadot3_3;
  const T minus_U3_22 = omega3_3 * omega3_3 + omega3_1 * omega3_1;
  const T U3_23 = omega3_3 * omega3_2;
  const T U3_31 = omega3_3 * omega3_1 - omegadot3_2;
  // Pddot3 = E3 omega1~ omega1~ q3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot3_2 = E3_22 * t2_5 - E3_23 * t2_4;
  const T minus_Pddot3_3 = E3_23 * t2_5 + E3_22 * t2_4;
  // effort_right_panel_3 = -theta3 k_right_panel_ - thetadot3 c_right_panel_: along the coordinate [N m], [N]
  const T minus_effort_right_panel_3 = theta3 * c.p.k + thetadot3 * c.p.c;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T minus_a3_1 = U3_12 + Pddot2_1;
  const T a3_2 = minus_U3_22 + Pddot3_2;
  const T minus_a3_3 = U3_23 + minus_Pddot3_3;
  // G3 = -m3 a3: applied less inertia force at ydot = 0, body axes [N]
  const T G3_1 = T(9) * minus_a3_1;
  const T minus_G3_2 = T(9) * a3_2;
  const T G3_3 = T(9) * minus_a3_3;
  // N3 = -axial(U3 (tr(I3)/2 - I3)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N3_1 = T(3) * U3_23;
  const T N3_2 = T(0.75) * U3_31;
  const T minus_N3_3 = T(0.75) * U3_21 - T(3) * U3_12;

  // ---- body 4 (wheel) on body 1
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cos(theta4);
  const T E4_11 = t4_1 * T(0.6666666666666666) + T(0.3333333333333334);
  const T t4_2 = sin(theta4) * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;
  // omega4 = thetadot4 b4 + E4 omega1: absolute angular velocity, body axes [rad/s]
  const T t4_4 = thetadot4 * T(0.5773502691896257);
  const T t4_5 = E4_11 * omega1_1 + E4_12 * omega1_2 + E4_13 * omega1_3;
  const T omega4_1 = t4_4 + t4_5;
  const T t4_6 = E4_13 * omega1_1 + E4_11 * omega1_2 + E4_12 * omega1_3;
  const T omega4_2 = t4_4 + t4_6;
  const T t4_7 = E4_12 * omega1_1 + E4_13 * omega1_2 + E4_11 * omega1_3;
  const T omega4_3 = t4_4 + t4_7;
  // omegadot4 = -thetadot4 b4~ E4 omega1: angular acceleration, body axes [rad/s^2]
  const T t4_8 = T(0.5773502691896257) * t4_7;
  const T t4_9 = T(0.5773502691896257) * t4_6;
  const T minus_omegadot4_1 = thetadot4 * (t4_8 - t4_9);
  const T t4_10 = T(0.5773502691896257) * t4_5;
  const T minus_omegadot4_2 = thetadot4 * (t4_10 - t4_8);
  const T minus_omegadot4_3 = thetadot4 * (t4_9 - t4_10);
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_11 = omega4_3 * omega4_3;
  const T t4_12 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_11 + t4_12;
  const T t4_13 = omega4_2 * omega4_1;
  const T U4_12 = t4_13 + minus_omegadot4_3;
  const T t4_14 = omega4_3 * omega4_1;
  const T U4_13 = t4_14 - minus_omegadot4_2;
  const T U4_21 = t4_13 - minus_omegadot4_3;
  const T t4_15 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_11 + t4_15;
  const T t4_16 = omega4_3 * omega4_2;
  const T U4_23 = t4_16 + minus_omegadot4_1;
  const T U4_31 = t4_14 + minus_omegadot4_2;
  const T U4_32 = t4_16 - minus_omegadot4_1;
  const T minus_U4_33 = t4_12 + t4_15;
  // Pddot4 = E4 omega1~ omega1~ q4: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_17 = T(0.2) * omega1_1;
  const T t4_18 = T(0.2) * omega1_2;
  const T t4_19 = omega1_1 * t4_17 + omega1_2 * t4_18;
  const T t4_20 = omega1_3 * t4_17;
  const T t4_21 = omega1_3 * t4_18;
  const T Pddot4_1 = E4_13 * t4_19 - (E4_11 * t4_20 + E4_12 * t4_21);
  const T Pddot4_2 = E4_12 * t4_19 - (E4_13 * t4_20 + E4_11 * t4_21);
  const T Pddot4_3 = E4_11 * t4_19 - (E4_12 * t4_20 + E4_13 * t4_21);
  // G4 = -m4 Pddot4: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G4_1 = T(4) * Pddot4_1;
  const T minus_G4_2 = T(4) * Pddot4_2;
  const T minus_G4_3 = T(4) * Pddot4_3;
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N4_1 = T(0.0079) * U4_32 - T(0.0079) * U4_23 - T(0.0021) * (minus_U4_22 - minus_U4_33) - T(0.0021) *
      U4_31 + T(0.0021) * U4_21;
  const T minus_N4_2 = T(0.0079) * U4_13 - T(0.0079) * U4_31 - T(0.0021) * (minus_U4_33 - minus_U4_11) - T(0.0021) *
      U4_12 + T(0.0021) * U4_32;
  const T minus_N4_3 = T(0.0079) * U4_21 - T(0.0079) * U4_12 - T(0.0021) * (minus_U4_11 - minus_U4_22) - T(0.0021) *
      U4_23 + T(0.0021) * U4_13;

  // ---- body 3 (right_panel) and what it carries
  // rho3 = r3~ G3 + N3: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T minus_rho3_1 = G3_3 + minus_N3_1;
  const T rho3_3 = G3_1 - minus_N3_3;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc3_2 = E3_22 * T(9);
  const T minus_hc3_3 = E3_23 * T(9);

  // ---- body 2 (left_panel) and what it carries
  // rho2 = r2~ G2 + N2: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T minus_rho2_1 = minus_G2_3 + minus_N2_1;
  const T rho2_3 = minus_G2_1 - minus_N2_3;
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_2 = E2_22 * T(9);
  const T hc2_3 = E2_23 * T(9);

  // ---- body 1 (hub) and what it carries
  // S1 = E2^T G2 + E3^T G3 + E4^T G4 + F_thruster_: sum of the force balances of the subtree, body axes [N]
  const T b1_1 = E4_11 * minus_G4_1 + E4_13 * minus_G4_2 + E4_12 * minus_G4_3;
  const T S1_1 = G3_1 - minus_G2_1 - b1_1 + u.thrust;
  const T b1_2 = E4_12 * minus_G4_1 + E4_11 * minus_G4_2 + E4_13 * minus_G4_3;
  const T S1_2 = E2_23 * minus_G2_3 - E2_22 * minus_G2_2 - E3_22 * minus_G3_2 - E3_23 * G3_3 - b1_2;
  const T b1_3 = E3_22 * G3_3 - E3_23 * minus_G3_2;
  const T b1_4 = E2_23 * minus_G2_2 + E2_22 * minus_G2_3;
  const T S1_3 = b1_3 - (E4_13 * minus_G4_1 + E4_12 * minus_G4_2 + E4_11 * minus_G4_3) - b1_4;
  // f_omega1 = q2~ E2^T G2 + E2^T rho2 + q3~ E3^T G3 + E3^T rho3 + q4~ E4^T G4 + E4^T N4 + N1: Kane's equation of
  //   omega [N m]
  const T minus_f_omega1_1 = T(0.6) * b1_4 + minus_rho2_1 + T(0.6) * b1_3 + minus_rho3_1 + T(0.2) * b1_2 + E4_11 *
      minus_N4_1 + E4_13 * minus_N4_2 + E4_12 * minus_N4_3 + minus_N1_1;
  const T f_omega1_2 = E2_22 * N2_2 - E2_23 * rho2_3 + E3_22 * N3_2 - E3_23 * rho3_3 + T(0.2) * b1_1 - E4_12 *
      minus_N4_1 - E4_11 * minus_N4_2 - E4_13 * minus_N4_3 - minus_N1_2;
  const T f_omega1_3 = T(0.6) * minus_G2_1 + E2_23 * N2_2 + E2_22 * rho2_3 + T(0.6) * G3_1 + E3_23 * N3_2 + E3_22 *
      rho3_3 - E4_13 * minus_N4_1 - E4_12 * minus_N4_2 - E4_11 * minus_N4_3 - minus_N1_3;
  // h1 = m2 q2 + m3 q3 + m4 q4 + hc2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h1_2 = hc2_2 - minus_hc3_2;
  const T h1_3 = hc2_3 - T(0.8) - minus_hc3_3;
  // J1 = -q2~ hc2~ + E2^T J2 E2 - q3~ hc3~ + E3^T J3 E3 + E4^T I4 E4 + I1 + (-m2 q2~ - hc2~) q2~ + (-m3 q3~ - hc3~)
  //   q3~ - m4 q4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b1_5 = T(0.6) * hc2_2;
  const T b1_6 = b1_5 + T(12);
  const T b1_7 = T(0.6) * minus_hc3_2;
  const T b1_8 = b1_7 + (T(5.3999999999999995) + hc2_2) * T(0.6) + (T(5.3999999999999995) + minus_hc3_2) * T(0.6);
  const T b1_9 = E4_13 * T(0.0021);
  const T b1_10 = E4_12 * T(0.0021);
  const T b1_11 = E4_11 * T(0.0158) + b1_9 + b1_10;
  const T b1_12 = b1_11 * E4_11;
  const T b1_13 = E4_11 * T(0.0021);
  const T b1_14 = b1_10 + b1_13 + E4_13 * T(0.0158);
  const T b1_15 = b1_14 * E4_13;
  const T b1_16 = b1_9 + b1_13 + E4_12 * T(0.0158);
  const T b1_17 = b1_16 * E4_12;
  const T J1_11 = b1_6 + b1_8 + T(28.16) + b1_12 + b1_15 + b1_17;
  const T b1_18 = b1_11 * E4_12;
  const T b1_19 = b1_14 * E4_11;
  const T b1_20 = b1_16 * E4_13;
  const T J1_12 = b1_18 + b1_19 + b1_20 + T(0.2);
  const T J1_13 = b1_11 * E4_13 + b1_14 * E4_12 + b1_16 * E4_11 - T(0.1);
  const T b1_21 = E2_22 * T(0.75);
  const T b1_22 = E2_23 * T(12.75);
  const T b1_23 = E3_22 * T(0.75);
  const T b1_24 = E3_23 * T(12.75);
  const T J1_22 = b1_21 * E2_22 + b1_22 * E2_23 + b1_23 * E3_22 + b1_24 * E3_23 + b1_17 + b1_12 + b1_15 + T(14.16);
  const T J1_32 = b1_21 * E2_23 - b1_22 * E2_22 - T(0.6) * hc2_3 - T(0.6) * minus_hc3_3 + b1_23 * E3_23 - b1_24 *
      E3_22 + b1_20 + b1_18 + b1_19 + T(0.3);
  const T J1_33 = E2_23 * T(0.75) * E2_23 + E2_22 * T(12.75) * E2_22 + b1_5 + b1_8 + E3_23 * T(0.75) * E3_23 + E3_22 *
      T(12.75) * E3_22 + b1_15 + b1_17 + b1_12 + T(18);
  // K_thetadot4_1 = E4^T K_thetadot4_4
  const T K_thetadot4_1_1 = E4_11 * T(0.011547005383792516) + E4_13 * T(0.011547005383792516) + E4_12 *
      T(0.011547005383792516);
  // K_thetadot3_1 = q3~ E3^T B_thetadot3_3 + E3^T K_thetadot3_3
  const T K_thetadot3_1_1 = b1_7 + T(12);
  // D_omegadot1: pivots of L D L^T
  const T b1_25 = K_thetadot4_1_1 * T(50);
  const T b1_26 = b1_25 * K_thetadot4_1_1;
  const T b1_27 = K_thetadot3_1_1 * T(0.08333333333333333);
  const T b1_28 = b1_6 * T(0.08333333333333333);
  const T D_omegadot1_1 = J1_11 - b1_26 - b1_27 * K_thetadot3_1_1 - b1_28 * b1_6;
  const T b1_29 = J1_12 - b1_26;
  const T b1_30 = T(1) / D_omegadot1_1;
  const T b1_31 = b1_29 * b1_30;
  const T D_omegadot1_2 = J1_22 - b1_26 - b1_31 * b1_29;
  const T b1_32 = J1_13 - b1_26;
  const T b1_33 = b1_32 * b1_30;
  const T b1_34 = J1_32 - b1_26 - b1_33 * b1_29;
  const T b1_35 = T(1) / D_omegadot1_2;
  const T b1_36 = b1_34 * b1_35;
  const T D_omegadot1_3 = J1_33 - b1_26 - b1_33 * b1_32 - b1_36 * b1_34;
  // D_Pddot1: pivots of L D L^T
  const T b1_37 = h1_3 * b1_35;
  const T b1_38 = h1_2 + b1_37 * b1_34;
  const T b1_39 = T(1) / D_omegadot1_3;
  const T b1_40 = b1_38 * b1_39;
  const T D_Pddot1_1 = T(142) - b1_37 * h1_3 - b1_40 * b1_38;
  const T b1_41 = minus_hc3_3 * T(0.08333333333333333);
  const T b1_42 = hc2_3 * T(0.08333333333333333);
  const T b1_43 = h1_3 + b1_41 * K_thetadot3_1_1 - b1_42 * b1_6;
  const T b1_44 = b1_43 * b1_30;
  const T b1_45 = b1_44 * b1_29;
  const T b1_46 = b1_45 * b1_35;
  const T b1_47 = b1_44 * b1_32 - b1_46 * b1_34;
  const T b1_48 = b1_47 * b1_39;
  const T b1_49 = b1_48 * b1_38 - b1_46 * h1_3;
  const T b1_50 = T(1) / D_Pddot1_1;
  const T b1_51 = b1_49 * b1_50;
  const T D_Pddot1_2 = T(142) - b1_41 * minus_hc3_3 - b1_42 * hc2_3 - b1_44 * b1_43 - b1_46 * b1_45 - b1_48 * b1_47 -
      b1_51 * b1_49;
  const T b1_52 = minus_hc3_2 * T(0.08333333333333333);
  const T b1_53 = hc2_2 * T(0.08333333333333333);
  const T b1_54 = h1_2 + b1_52 * K_thetadot3_1_1 - b1_53 * b1_6;
  const T b1_55 = b1_54 * b1_30;
  const T b1_56 = b1_55 * b1_29;
  const T b1_57 = b1_56 * b1_35;
  const T b1_58 = b1_57 * b1_34 - b1_55 * b1_32;
  const T b1_59 = b1_58 * b1_39;
  const T b1_60 = b1_57 * h1_3 + b1_59 * b1_38;
  const T b1_61 = b1_60 * b1_50;
  const T b1_62 = b1_52 * minus_hc3_3 + b1_53 * hc2_3 + b1_55 * b1_43 + b1_57 * b1_45 - b1_59 * b1_47 - b1_61 * b1_49;
  const T b1_63 = T(1) / D_Pddot1_2;
  const T b1_64 = b1_62 * b1_63;
  const T D_Pddot1_3 = T(142) - b1_52 * minus_hc3_2 - b1_53 * hc2_2 - b1_55 * b1_54 - b1_57 * b1_56 - b1_59 * b1_58 -
      b1_61 * b1_60 - b1_64 * b1_62;

  // ---- body 1 (hub), solved
  // Pddot1: from A ydot = f by elimination
  const T z1_1 = u.wheel_torque - (T(0.5773502691896257) * minus_N4_1 + T(0.5773502691896257) * minus_N4_2 +
      T(0.5773502691896257) * minus_N4_3);
  const T z1_2 = b1_25 * z1_1;
  const T z1_3 = minus_rho3_1 + minus_effort_right_panel_3;
  const T z1_4 = minus_rho2_1 + minus_effort_left_panel_2;
  const T z1_5 = b1_27 * z1_3 - (minus_f_omega1_1 + z1_2) + b1_28 * z1_4;
  const T z1_6 = f_omega1_2 - z1_2 - b1_31 * z1_5;
  const T z1_7 = f_omega1_3 - z1_2 - b1_33 * z1_5 - b1_36 * z1_6;
  const T z1_8 = S1_1 - b1_37 * z1_6 + b1_40 * z1_7;
  const T z1_9 = S1_2 + b1_41 * z1_3 - b1_42 * z1_4 + b1_44 * z1_5 - b1_46 * z1_6 - b1_48 * z1_7 - b1_51 * z1_8;
  const T z1_10 = T(1) / D_Pddot1_3 * (S1_3 - b1_52 * z1_3 + b1_53 * z1_4 - b1_55 * z1_5 + b1_57 * z1_6 - b1_59 * z1_7
      - b1_61 * z1_8 - b1_64 * z1_9);
  const T z1_11 = z1_9 * b1_63 - b1_64 * z1_10;
  const T Pddot1_1 = z1_8 * b1_50 - b1_51 * z1_11 - b1_61 * z1_10;
  // omegadot1: from A ydot = f by elimination
  const T z1_12 = z1_7 * b1_39 + b1_40 * Pddot1_1 - b1_48 * z1_11 - b1_59 * z1_10;
  const T z1_13 = z1_6 * b1_35 - b1_36 * z1_12 - b1_37 * Pddot1_1 - b1_46 * z1_11 + b1_57 * z1_10;
  const T omegadot1_1 = z1_5 * b1_30 - b1_31 * z1_13 - b1_33 * z1_12 + b1_44 * z1_11 - b1_55 * z1_10;
  ydot[0] = omegadot1_1;
  ydot[1] = z1_13;
  ydot[2] = z1_12;
  // sddot1 = R1^T Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_1 = R1_11 * Pddot1_1 + R1_21 * z1_11 + R1_31 * z1_10;
  const T sddot1_2 = R1_12 * Pddot1_1 + R1_22 * z1_11 + R1_32 * z1_10;
  const T sddot1_3 = R1_13 * Pddot1_1 + R1_23 * z1_11 + R1_33 * z1_10;
  ydot[6] = sddot1_1;
  ydot[7] = sddot1_2;
  ydot[8] = sddot1_3;

  // ---- body 2 (left_panel), solved
  // thetaddot2: from A ydot = f by elimination
  const T thetaddot2 = b1_42 * z1_11 - (z1_4 * T(0.08333333333333333) + b1_28 * omegadot1_1) - b1_53 * z1_10;
  ydot[3] = thetaddot2;

  // ---- body 3 (right_panel), solved
  // thetaddot3: from A ydot = f by elimination
  const T thetaddot3 = b1_52 * z1_10 - (z1_3 * T(0.08333333333333333) + b1_27 * omegadot1_1 + b1_41 * z1_11);
  ydot[4] = thetaddot3;

  // ---- body 4 (wheel), solved
  // thetaddot4: from A ydot = f by elimination
  const T thetaddot4 = z1_1 * T(50) - b1_25 * omegadot1_1 - b1_25 * z1_13 - b1_25 * z1_12;
  ydot[5] = thetaddot4;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 209 add, 222 multiply, 6 sine or cosine
template <class T>
void residual(const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hub) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[6], sddot1_2 = ydot[7], sddot1_3 = ydot[8];
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
  // Pddot1 = R1 sddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1 = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * sddot1_3;
  const T Pddot1_2 = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * sddot1_3;
  const T Pddot1_3 = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * sddot1_3;
  // G1 = m1 Pddot1 - F_thruster_: force balance, body axes [N]
  const T G1_1 = T(120) * Pddot1_1 - u.thrust;
  const T G1_2 = T(120) * Pddot1_2;
  const T G1_3 = T(120) * Pddot1_3;
  // N1 = -r_thruster_~ F_thruster_ + axial(U1 (tr(I1)/2 - I1)): moment balance about the mass centre, body axes [N m]
  const T N1_1 = T(10) * U1_32 - T(6) * U1_23 - T(0.3) * (minus_U1_22 - minus_U1_33) - T(0.2) * U1_31 - T(0.1) *
      U1_21;
  const T N1_2 = T(6) * U1_13 - T(8) * U1_31 + T(0.1) * (minus_U1_33 - minus_U1_11) - T(0.3) * U1_12 + T(0.2) * U1_32;
  const T N1_3 = T(8) * U1_21 - T(10) * U1_12 - T(0.2) * (minus_U1_11 - minus_U1_22) + T(0.1) * U1_23 + T(0.3) * U1_13
      + T(0.1) * u.thrust;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  const T thetaddot2 = ydot[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // effort_left_panel_2 = -theta2 k_left_panel_ - thetadot2 c_left_panel_: along the coordinate [N m], [N]
  const T minus_effort_left_panel_2 = theta2 * c.p.k + thetadot2 * c.p.c;
  // omegadot2 = -thetadot2 b2~ E2 omega1 + thetaddot2 b2 + E2 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_1 = thetaddot2 + omegadot1_1;
  const T omegadot2_2 = thetadot2 * omega2_3 + E2_22 * omegadot1_2 + E2_23 * omegadot1_3;
  const T omegadot2_3 = E2_22 * omegadot1_3 - E2_23 * omegadot1_2 - thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_2 * omega2_1;
  const T U2_12 = t2_1 - omegadot2_3;
  const T U2_21 = t2_1 + omegadot2_3;
  const T minus_U2_22 = omega2_3 * omega2_3 + omega2_1 * omega2_1;
  const T U2_31 = omega2_3 * omega2_1 - omegadot2_2;
  const T U2_32 = omega2_3 * omega2_2 + omegadot2_1;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_2 = U1_12 * T(0.6);
  const T Pddot2_1 = t2_2 + Pddot1_1;
  const T t2_3 = minus_U1_22 * T(0.6);
  const T t2_4 = Pddot1_2 - t2_3;
  const T t2_5 = U1_32 * T(0.6);
  const T t2_6 = t2_5 + Pddot1_3;
  const T Pddot2_2 = E2_22 * t2_4 + E2_23 * t2_6;
  const T Pddot2_3 = E2_22 * t2_6 - E2_23 * t2_4;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a2_1 = U2_12 + Pddot2_1;
  const T a2_2 = Pddot2_2 - minus_U2_22;
  const T a2_3 = U2_32 + Pddot2_3;
  // G2 = m2 a2: force balance, body axes [N]
  const T G2_1 = T(9) * a2_1;
  const T G2_2 = T(9) * a2_2;
  const T G2_3 = T(9) * a2_3;
  // N2 = axial(U2 (tr(I2)/2 - I2)): moment balance about the mass centre, body axes [N m]
  const T N2_1 = T(3) * U2_32;
  const T minus_N2_2 = T(0.75) * U2_31;
  const T N2_3 = T(0.75) * U2_21 - T(3) * U2_12;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  const T thetaddot3 = ydot[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // effort_right_panel_3 = -theta3 k_right_panel_ - thetadot3 c_right_panel_: along the coordinate [N m], [N]
  const T minus_effort_right_panel_3 = theta3 * c.p.k + thetadot3 * c.p.c;
  // omegadot3 = -thetadot3 b3~ E3 omega1 + thetaddot3 b3 + E3 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = thetaddot3 + omegadot1_1;
  const T omegadot3_2 = thetadot3 * omega3_3 + E3_22 * omegadot1_2 + E3_23 * omegadot1_3;
  const T omegadot3_3 = E3_22 * omegadot1_3 - E3_23 * omegadot1_2 - thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_2 * omega3_1;
  const T U3_12 = t3_1 - omegadot3_3;
  const T U3_21 = t3_1 + omegadot3_3;
  const T minus_U3_22 = omega3_3 * omega3_3 + omega3_1 * omega3_1;
  const T U3_31 = omega3_3 * omega3_1 - omegadot3_2;
  const T U3_32 = omega3_3 * omega3_2 + omegadot3_1;
  // Pddot3 = E3 (U1 q3 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot3_1 = Pddot1_1 - t2_2;
  const T t3_2 = t2_3 + Pddot1_2;
  const T t3_3 = Pddot1_3 - t2_5;
  const T Pddot3_2 = E3_22 * t3_2 + E3_23 * t3_3;
  const T Pddot3_3 = E3_22 * t3_3 - E3_23 * t3_2;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a3_1 = Pddot3_1 - U3_12;
  const T a3_2 = minus_U3_22 + Pddot3_2;
  const T a3_3 = Pddot3_3 - U3_32;
  // G3 = m3 a3: force balance, body axes [N]
  const T G3_1 = T(9) * a3_1;
  const T G3_2 = T(9) * a3_2;
  const T G3_3 = T(9) * a3_3;
  // N3 = axial(U3 (tr(I3)/2 - I3)): moment balance about the mass centre, body axes [N m]
  const T N3_1 = T(3) * U3_32;
  const T minus_N3_2 = T(0.75) * U3_31;
  const T N3_3 = T(0.75) * U3_21 - T(3) * U3_12;

  // ---- body 4 (wheel) on body 1
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  const T thetaddot4 = ydot[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cos(theta4);
  const T E4_11 = t4_1 * T(0.6666666666666666) + T(0.3333333333333334);
  const T t4_2 = sin(theta4) * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;
  // omega4 = thetadot4 b4 + E4 omega1: absolute angular velocity, body axes [rad/s]
  const T t4_4 = thetadot4 * T(0.5773502691896257);
  const T t4_5 = E4_11 * omega1_1 + E4_12 * omega1_2 + E4_13 * omega1_3;
  const T omega4_1 = t4_4 + t4_5;
  const T t4_6 = E4_13 * omega1_1 + E4_11 * omega1_2 + E4_12 * omega1_3;
  const T omega4_2 = t4_4 + t4_6;
  const T t4_7 = E4_12 * omega1_1 + E4_13 * omega1_2 + E4_11 * omega1_3;
  const T omega4_3 = t4_4 + t4_7;
  // omegadot4 = -thetadot4 b4~ E4 omega1 + thetaddot4 b4 + E4 omegadot1: angular acceleration, body axes [rad/s^2]
  const T t4_8 = thetaddot4 * T(0.5773502691896257);
  const T t4_9 = T(0.5773502691896257) * t4_7;
  const T t4_10 = T(0.5773502691896257) * t4_6;
  const T omegadot4_1 = t4_8 - thetadot4 * (t4_9 - t4_10) + E4_11 * omegadot1_1 + E4_12 * omegadot1_2 + E4_13 *
      omegadot1_3;
  const T t4_11 = T(0.5773502691896257) * t4_5;
  const T omegadot4_2 = t4_8 - thetadot4 * (t4_11 - t4_9) + E4_13 * omegadot1_1 + E4_11 * omegadot1_2 + E4_12 *
      omegadot1_3;
  const T omegadot4_3 = t4_8 - thetadot4 * (t4_10 - t4_11) + E4_12 * omegadot1_1 + E4_13 * omegadot1_2 + E4_11 *
      omegadot1_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_12 = omega4_3 * omega4_3;
  const T t4_13 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_12 + t4_13;
  const T t4_14 = omega4_2 * omega4_1;
  const T U4_12 = t4_14 - omegadot4_3;
  const T t4_15 = omega4_3 * omega4_1;
  const T U4_13 = t4_15 + omegadot4_2;
  const T U4_21 = t4_14 + omegadot4_3;
  const T t4_16 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_12 + t4_16;
  const T t4_17 = omega4_3 * omega4_2;
  const T U4_23 = t4_17 - omegadot4_1;
  const T U4_31 = t4_15 - omegadot4_2;
  const T U4_32 = t4_17 + omegadot4_1;
  const T minus_U4_33 = t4_13 + t4_16;
  // Pddot4 = E4 (U1 q4 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_18 = Pddot1_1 - U1_13 * T(0.2);
  const T t4_19 = Pddot1_2 - U1_23 * T(0.2);
  const T t4_20 = minus_U1_33 * T(0.2) + Pddot1_3;
  const T Pddot4_1 = E4_11 * t4_18 + E4_12 * t4_19 + E4_13 * t4_20;
  const T Pddot4_2 = E4_13 * t4_18 + E4_11 * t4_19 + E4_12 * t4_20;
  const T Pddot4_3 = E4_12 * t4_18 + E4_13 * t4_19 + E4_11 * t4_20;
  // G4 = m4 Pddot4: force balance, body axes [N]
  const T G4_1 = T(4) * Pddot4_1;
  const T G4_2 = T(4) * Pddot4_2;
  const T G4_3 = T(4) * Pddot4_3;
  // N4 = axial(U4 (tr(I4)/2 - I4)): moment balance about the mass centre, body axes [N m]
  const T N4_1 = T(0.0079) * U4_32 - T(0.0079) * U4_23 - T(0.0021) * (minus_U4_22 - minus_U4_33) - T(0.0021) * U4_31 +
      T(0.0021) * U4_21;
  const T N4_2 = T(0.0079) * U4_13 - T(0.0079) * U4_31 - T(0.0021) * (minus_U4_33 - minus_U4_11) - T(0.0021) * U4_12 +
      T(0.0021) * U4_32;
  const T N4_3 = T(0.0079) * U4_21 - T(0.0079) * U4_12 - T(0.0021) * (minus_U4_11 - minus_U4_22) - T(0.0021) * U4_23 +
      T(0.0021) * U4_13;

  // ---- body 4 (wheel) and what it carries
  // r_theta4 = b4 . N4 - tau_wheel_: Kane's equation of the angle [N m]
  const T r_theta4 = T(0.5773502691896257) * N4_1 + T(0.5773502691896257) * N4_2 + T(0.5773502691896257) * N4_3 -
      u.wheel_torque;
  r[5] = r_theta4;

  // ---- body 3 (right_panel) and what it carries
  // rho3 = r3~ G3 + N3: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho3_1 = N3_1 - G3_3;
  const T rho3_3 = G3_1 + N3_3;
  // r_theta3 = b3 . rho3 - effort_right_panel_3: Kane's equation of the angle [N m]
  const T r_theta3 = rho3_1 + minus_effort_right_panel_3;
  r[4] = r_theta3;

  // ---- body 2 (left_panel) and what it carries
  // rho2 = r2~ G2 + N2: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho2_1 = G2_3 + N2_1;
  const T rho2_3 = N2_3 - G2_1;
  // r_theta2 = b2 . rho2 - effort_left_panel_2: Kane's equation of the angle [N m]
  const T r_theta2 = rho2_1 + minus_effort_left_panel_2;
  r[3] = r_theta2;

  // ---- body 1 (hub) and what it carries
  // S1 = E2^T G2 + E3^T G3 + E4^T G4 + G1: sum of the force balances of the subtree, body axes [N]
  const T b1_1 = E4_11 * G4_1 + E4_13 * G4_2 + E4_12 * G4_3;
  const T S1_1 = G2_1 + G3_1 + b1_1 + G1_1;
  const T b1_2 = E4_12 * G4_1 + E4_11 * G4_2 + E4_13 * G4_3;
  const T S1_2 = E2_22 * G2_2 - E2_23 * G2_3 + E3_22 * G3_2 - E3_23 * G3_3 + b1_2 + G1_2;
  const T b1_3 = E2_23 * G2_2 + E2_22 * G2_3;
  const T b1_4 = E3_23 * G3_2 + E3_22 * G3_3;
  const T S1_3 = b1_3 + b1_4 + E4_13 * G4_1 + E4_12 * G4_2 + E4_11 * G4_3 + G1_3;
  // r_omega1 = q2~ E2^T G2 + E2^T rho2 + q3~ E3^T G3 + E3^T rho3 + q4~ E4^T G4 + E4^T N4 + N1: Kane's equation of
  //   omega [N m]
  const T r_omega1_1 = T(0.6) * b1_3 + rho2_1 - T(0.6) * b1_4 + rho3_1 + T(0.2) * b1_2 + E4_11 * N4_1 + E4_13 * N4_2 +
      E4_12 * N4_3 + N1_1;
  const T r_omega1_2 = E4_12 * N4_1 - (E2_22 * minus_N2_2 + E2_23 * rho2_3 + E3_22 * minus_N3_2 + E3_23 * rho3_3 +
      T(0.2) * b1_1) + E4_11 * N4_2 + E4_13 * N4_3 + N1_2;
  const T r_omega1_3 = E2_22 * rho2_3 - E2_23 * minus_N2_2 - T(0.6) * G2_1 + T(0.6) * G3_1 + E3_22 * rho3_3 - E3_23 *
      minus_N3_2 + E4_13 * N4_1 + E4_12 * N4_2 + E4_11 * N4_3 + N1_3;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
  // r_sdot1 = R1^T S1: Kane's equation of sdot [N]
  const T r_sdot1_1 = R1_11 * S1_1 + R1_21 * S1_2 + R1_31 * S1_3;
  const T r_sdot1_2 = R1_12 * S1_1 + R1_22 * S1_2 + R1_32 * S1_3;
  const T r_sdot1_3 = R1_13 * S1_1 + R1_23 * S1_2 + R1_33 * S1_3;
  r[6] = r_sdot1_1;
  r[7] = r_sdot1_2;
  r[8] = r_sdot1_3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 77 add, 87 multiply, 6 sine or cosine
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 81; ++i) A[i] = T(0);

  // ---- body 1 (hub) on the inertial frame
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

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);

  // ---- body 4 (wheel) on body 1
  const T theta4 = x[6];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cos(theta4);
  const T E4_11 = t4_1 * T(0.6666666666666666) + T(0.3333333333333334);
  const T t4_2 = sin(theta4) * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;

  // ---- body 3 (right_panel) and what it carries
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc3_2 = E3_22 * T(9);
  const T minus_hc3_3 = E3_23 * T(9);

  // ---- body 2 (left_panel) and what it carries
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_2 = E2_22 * T(9);
  const T hc2_3 = E2_23 * T(9);

  // ---- body 1 (hub) and what it carries
  // h1 = m2 q2 + m3 q3 + m4 q4 + hc2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h1_2 = hc2_2 - minus_hc3_2;
  const T h1_3 = hc2_3 - T(0.8) - minus_hc3_3;
  // J1 = -q2~ hc2~ + E2^T J2 E2 - q3~ hc3~ + E3^T J3 E3 + E4^T I4 E4 + I1 + (-m2 q2~ - hc2~) q2~ + (-m3 q3~ - hc3~)
  //   q3~ - m4 q4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b1_1 = T(0.6) * hc2_2;
  const T b1_2 = b1_1 + T(12);
  const T b1_3 = T(0.6) * minus_hc3_2;
  const T b1_4 = b1_3 + (T(5.3999999999999995) + hc2_2) * T(0.6) + (T(5.3999999999999995) + minus_hc3_2) * T(0.6);
  const T b1_5 = E4_13 * T(0.0021);
  const T b1_6 = E4_12 * T(0.0021);
  const T b1_7 = E4_11 * T(0.0158) + b1_5 + b1_6;
  const T b1_8 = b1_7 * E4_11;
  const T b1_9 = E4_11 * T(0.0021);
  const T b1_10 = b1_6 + b1_9 + E4_13 * T(0.0158);
  const T b1_11 = b1_10 * E4_13;
  const T b1_12 = b1_5 + b1_9 + E4_12 * T(0.0158);
  const T b1_13 = b1_12 * E4_12;
  const T J1_11 = b1_2 + b1_4 + T(28.16) + b1_8 + b1_11 + b1_13;
  const T b1_14 = b1_7 * E4_12;
  const T b1_15 = b1_10 * E4_11;
  const T b1_16 = b1_12 * E4_13;
  const T J1_12 = b1_14 + b1_15 + b1_16 + T(0.2);
  const T J1_13 = b1_7 * E4_13 + b1_10 * E4_12 + b1_12 * E4_11 - T(0.1);
  const T b1_17 = E2_22 * T(0.75);
  const T b1_18 = E2_23 * T(12.75);
  const T b1_19 = E3_22 * T(0.75);
  const T b1_20 = E3_23 * T(12.75);
  const T J1_22 = b1_17 * E2_22 + b1_18 * E2_23 + b1_19 * E3_22 + b1_20 * E3_23 + b1_13 + b1_8 + b1_11 + T(14.16);
  const T J1_23 = T(0.3) - T(0.6) * hc2_3 + (b1_17 * E2_23 - b1_18 * E2_22 - T(0.6) * minus_hc3_3) + (b1_19 * E3_23 -
      b1_20 * E3_22 + (b1_16 + b1_14 + b1_15));
  const T J1_33 = E2_23 * T(0.75) * E2_23 + E2_22 * T(12.75) * E2_22 + b1_1 + b1_4 + E3_23 * T(0.75) * E3_23 + E3_22 *
      T(12.75) * E3_22 + b1_11 + b1_13 + b1_8 + T(18);
  A[0] = J1_11;
  A[1] = J1_12;
  A[9] = J1_12;
  A[2] = J1_13;
  A[18] = J1_13;
  A[10] = J1_22;
  A[11] = J1_23;
  A[19] = J1_23;
  A[20] = J1_33;
  // K_thetadot4_1 = E4^T K_thetadot4_4
  const T K_thetadot4_1_1 = E4_11 * T(0.011547005383792516) + E4_13 * T(0.011547005383792516) + E4_12 *
      T(0.011547005383792516);
  A[5] = K_thetadot4_1_1;
  A[14] = K_thetadot4_1_1;
  A[23] = K_thetadot4_1_1;
  A[45] = K_thetadot4_1_1;
  A[46] = K_thetadot4_1_1;
  A[47] = K_thetadot4_1_1;
  // K_thetadot3_1 = q3~ E3^T B_thetadot3_3 + E3^T K_thetadot3_3
  const T K_thetadot3_1_1 = b1_3 + T(12);
  A[4] = K_thetadot3_1_1;
  A[36] = K_thetadot3_1_1;
  A[3] = b1_2;
  A[27] = b1_2;

  // ---- results
  const T t1 = h1_2 * R1_31 - h1_3 * R1_21;
  A[6] = t1;
  A[54] = t1;
  const T t2 = h1_2 * R1_32 - h1_3 * R1_22;
  A[7] = t2;
  A[63] = t2;
  const T t3 = h1_2 * R1_33 - h1_3 * R1_23;
  A[8] = t3;
  A[72] = t3;
  const T t4 = h1_3 * R1_11;
  A[15] = t4;
  A[55] = t4;
  const T t5 = h1_3 * R1_12;
  A[16] = t5;
  A[64] = t5;
  const T t6 = h1_3 * R1_13;
  A[17] = t6;
  A[73] = t6;
  const T t7 = h1_2 * R1_11;
  A[24] = -t7;
  A[56] = -t7;
  const T t8 = h1_2 * R1_12;
  A[25] = -t8;
  A[65] = -t8;
  const T t9 = h1_2 * R1_13;
  A[26] = -t9;
  A[74] = -t9;
  A[30] = T(12);
  A[40] = T(12);
  const T t10 = R1_31 * hc2_2 - R1_21 * hc2_3;
  A[33] = t10;
  A[57] = t10;
  const T t11 = R1_32 * hc2_2 - R1_22 * hc2_3;
  A[34] = t11;
  A[66] = t11;
  const T t12 = R1_33 * hc2_2 - R1_23 * hc2_3;
  A[35] = t12;
  A[75] = t12;
  const T t13 = R1_21 * minus_hc3_3 - R1_31 * minus_hc3_2;
  A[42] = t13;
  A[58] = t13;
  const T t14 = R1_22 * minus_hc3_3 - R1_32 * minus_hc3_2;
  A[43] = t14;
  A[67] = t14;
  const T t15 = R1_23 * minus_hc3_3 - R1_33 * minus_hc3_2;
  A[44] = t15;
  A[76] = t15;
  A[50] = T(0.02);
  A[60] = T(142);
  A[70] = T(142);
  A[80] = T(142);
}

// kinematics_and_accelerations: xdot, the kinematical equations; ydot from A ydot = f.
// xdot: rates of x (nx) [1/s], [rad/s], [m/s]
// ydot: rates of y (ny) [rad/s^2], [m/s^2]
// 305 add, 375 multiply, 6 divide, 6 sine or cosine
template <class T>
void kinematics_and_accelerations(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* xdot, T* ydot)
    noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hub) on the inertial frame
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
  // N1 = -omega1~ I1 omega1 + r_thruster_~ F_thruster_: applied less inertia moment at ydot = 0, body axes [N m]
  const T t1_13 = omega1_2 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T t1_15 = omega1_3 * omega1_3;
  const T t1_16 = omega1_1 * omega1_2;
  const T t1_17 = omega1_1 * omega1_3;
  const T minus_N1_1 = T(4) * t1_13 + T(0.3) * (t1_14 - t1_15) - T(0.1) * t1_16 - T(0.2) * t1_17;
  const T t1_18 = omega1_1 * omega1_1;
  const T minus_N1_2 = T(0.2) * t1_13 - (T(2) * t1_17 + T(0.1) * (t1_15 - t1_18)) - T(0.3) * t1_16;
  const T minus_N1_3 = T(0.1) * u.thrust + T(0.2) * (t1_18 - t1_14) - T(2) * t1_16 + T(0.3) * t1_17 + T(0.1) * t1_13;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_2 = thetadot2 * omega2_3;
  const T minus_omegadot2_3 = thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_2 * omega2_1;
  const T U2_12 = t2_1 + minus_omegadot2_3;
  const T U2_21 = t2_1 - minus_omegadot2_3;
  const T minus_U2_22 = omega2_3 * omega2_3 + omega2_1 * omega2_1;
  const T U2_23 = omega2_3 * omega2_2;
  const T U2_31 = omega2_3 * omega2_1 - omegadot2_2;
  // Pddot2 = E2 omega1~ omega1~ q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_2 = omega1_1 * T(0.6);
  const T Pddot2_1 = omega1_2 * t2_2;
  const T t2_3 = omega1_3 * T(0.6);
  const T t2_4 = omega1_2 * t2_3;
  const T t2_5 = omega1_3 * t2_3 + omega1_1 * t2_2;
  const T Pddot2_2 = E2_23 * t2_4 - E2_22 * t2_5;
  const T Pddot2_3 = E2_23 * t2_5 + E2_22 * t2_4;
  // effort_left_panel_2 = -theta2 k_left_panel_ - thetadot2 c_left_panel_: along the coordinate [N m], [N]
  const T minus_effort_left_panel_2 = theta2 * c.p.k + thetadot2 * c.p.c;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a2_1 = U2_12 + Pddot2_1;
  const T a2_2 = Pddot2_2 - minus_U2_22;
  const T a2_3 = U2_23 + Pddot2_3;
  // G2 = -m2 a2: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G2_1 = T(9) * a2_1;
  const T minus_G2_2 = T(9) * a2_2;
  const T minus_G2_3 = T(9) * a2_3;
  // N2 = -axial(U2 (tr(I2)/2 - I2)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N2_1 = T(3) * U2_23;
  const T N2_2 = T(0.75) * U2_31;
  const T minus_N2_3 = T(0.75) * U2_21 - T(3) * U2_12;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // omegadot3 = -thetadot3 b3~ E3 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot3_2 = thetadot3 * omega3_3;
  const T minus_omegadot3_3 = thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_2 * omega3_1;
  const T U3_12 = t3_1 + minus_omegadot3_3;
  const T U3_21 = t3_1 - minus_omegadot3_3;
  const T minus_U3_22 = omega3_3 * omega3_3 + omega3_1 * omega3_1;
  const T U3_23 = omega3_3 * omega3_2;
  const T U3_31 = omega3_3 * omega3_1 - omegadot3_2;
  // Pddot3 = E3 omega1~ omega1~ q3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot3_2 = E3_22 * t2_5 - E3_23 * t2_4;
  const T minus_Pddot3_3 = E3_23 * t2_5 + E3_22 * t2_4;
  // effort_right_panel_3 = -theta3 k_right_panel_ - thetadot3 c_right_panel_: along the coordinate [N m], [N]
  const T minus_effort_right_panel_3 = theta3 * c.p.k + thetadot3 * c.p.c;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T minus_a3_1 = U3_12 + Pddot2_1;
  const T a3_2 = minus_U3_22 + Pddot3_2;
  const T minus_a3_3 = U3_23 + minus_Pddot3_3;
  // G3 = -m3 a3: applied less inertia force at ydot = 0, body axes [N]
  const T G3_1 = T(9) * minus_a3_1;
  const T minus_G3_2 = T(9) * a3_2;
  const T G3_3 = T(9) * minus_a3_3;
  // N3 = -axial(U3 (tr(I3)/2 - I3)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N3_1 = T(3) * U3_23;
  const T N3_2 = T(0.75) * U3_31;
  const T minus_N3_3 = T(0.75) * U3_21 - T(3) * U3_12;

  // ---- body 4 (wheel) on body 1
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cos(theta4);
  const T E4_11 = t4_1 * T(0.6666666666666666) + T(0.3333333333333334);
  const T t4_2 = sin(theta4) * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;
  // omega4 = thetadot4 b4 + E4 omega1: absolute angular velocity, body axes [rad/s]
  const T t4_4 = thetadot4 * T(0.5773502691896257);
  const T t4_5 = E4_11 * omega1_1 + E4_12 * omega1_2 + E4_13 * omega1_3;
  const T omega4_1 = t4_4 + t4_5;
  const T t4_6 = E4_13 * omega1_1 + E4_11 * omega1_2 + E4_12 * omega1_3;
  const T omega4_2 = t4_4 + t4_6;
  const T t4_7 = E4_12 * omega1_1 + E4_13 * omega1_2 + E4_11 * omega1_3;
  const T omega4_3 = t4_4 + t4_7;
  // omegadot4 = -thetadot4 b4~ E4 omega1: angular acceleration, body axes [rad/s^2]
  const T t4_8 = T(0.5773502691896257) * t4_7;
  const T t4_9 = T(0.5773502691896257) * t4_6;
  const T minus_omegadot4_1 = thetadot4 * (t4_8 - t4_9);
  const T t4_10 = T(0.5773502691896257) * t4_5;
  const T minus_omegadot4_2 = thetadot4 * (t4_10 - t4_8);
  const T minus_omegadot4_3 = thetadot4 * (t4_9 - t4_10);
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_11 = omega4_3 * omega4_3;
  const T t4_12 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_11 + t4_12;
  const T t4_13 = omega4_2 * omega4_1;
  const T U4_12 = t4_13 + minus_omegadot4_3;
  const T t4_14 = omega4_3 * omega4_1;
  const T U4_13 = t4_14 - minus_omegadot4_2;
  const T U4_21 = t4_13 - minus_omegadot4_3;
  const T t4_15 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_11 + t4_15;
  const T t4_16 = omega4_3 * omega4_2;
  const T U4_23 = t4_16 + minus_omegadot4_1;
  const T U4_31 = t4_14 + minus_omegadot4_2;
  const T U4_32 = t4_16 - minus_omegadot4_1;
  const T minus_U4_33 = t4_12 + t4_15;
  // Pddot4 = E4 omega1~ omega1~ q4: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_17 = T(0.2) * omega1_1;
  const T t4_18 = T(0.2) * omega1_2;
  const T t4_19 = omega1_1 * t4_17 + omega1_2 * t4_18;
  const T t4_20 = omega1_3 * t4_17;
  const T t4_21 = omega1_3 * t4_18;
  const T Pddot4_1 = E4_13 * t4_19 - (E4_11 * t4_20 + E4_12 * t4_21);
  const T Pddot4_2 = E4_12 * t4_19 - (E4_13 * t4_20 + E4_11 * t4_21);
  const T Pddot4_3 = E4_11 * t4_19 - (E4_12 * t4_20 + E4_13 * t4_21);
  // G4 = -m4 Pddot4: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G4_1 = T(4) * Pddot4_1;
  const T minus_G4_2 = T(4) * Pddot4_2;
  const T minus_G4_3 = T(4) * Pddot4_3;
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N4_1 = T(0.0079) * U4_32 - T(0.0079) * U4_23 - T(0.0021) * (minus_U4_22 - minus_U4_33) - T(0.0021) *
      U4_31 + T(0.0021) * U4_21;
  const T minus_N4_2 = T(0.0079) * U4_13 - T(0.0079) * U4_31 - T(0.0021) * (minus_U4_33 - minus_U4_11) - T(0.0021) *
      U4_12 + T(0.0021) * U4_32;
  const T minus_N4_3 = T(0.0079) * U4_21 - T(0.0079) * U4_12 - T(0.0021) * (minus_U4_11 - minus_U4_22) - T(0.0021) *
      U4_23 + T(0.0021) * U4_13;

  // ---- body 3 (right_panel) and what it carries
  // rho3 = r3~ G3 + N3: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T minus_rho3_1 = G3_3 + minus_N3_1;
  const T rho3_3 = G3_1 - minus_N3_3;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc3_2 = E3_22 * T(9);
  const T minus_hc3_3 = E3_23 * T(9);

  // ---- body 2 (left_panel) and what it carries
  // rho2 = r2~ G2 + N2: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T minus_rho2_1 = minus_G2_3 + minus_N2_1;
  const T rho2_3 = minus_G2_1 - minus_N2_3;
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_2 = E2_22 * T(9);
  const T hc2_3 = E2_23 * T(9);

  // ---- body 1 (hub) and what it carries
  // S1 = E2^T G2 + E3^T G3 + E4^T G4 + F_thruster_: sum of the force balances of the subtree, body axes [N]
  const T b1_1 = E4_11 * minus_G4_1 + E4_13 * minus_G4_2 + E4_12 * minus_G4_3;
  const T S1_1 = G3_1 - minus_G2_1 - b1_1 + u.thrust;
  const T b1_2 = E4_12 * minus_G4_1 + E4_11 * minus_G4_2 + E4_13 * minus_G4_3;
  const T S1_2 = E2_23 * minus_G2_3 - E2_22 * minus_G2_2 - E3_22 * minus_G3_2 - E3_23 * G3_3 - b1_2;
  const T b1_3 = E3_22 * G3_3 - E3_23 * minus_G3_2;
  const T b1_4 = E2_23 * minus_G2_2 + E2_22 * minus_G2_3;
  const T S1_3 = b1_3 - (E4_13 * minus_G4_1 + E4_12 * minus_G4_2 + E4_11 * minus_G4_3) - b1_4;
  // f_omega1 = q2~ E2^T G2 + E2^T rho2 + q3~ E3^T G3 + E3^T rho3 + q4~ E4^T G4 + E4^T N4 + N1: Kane's equation of
  //   omega [N m]
  const T minus_f_omega1_1 = T(0.6) * b1_4 + minus_rho2_1 + T(0.6) * b1_3 + minus_rho3_1 + T(0.2) * b1_2 + E4_11 *
      minus_N4_1 + E4_13 * minus_N4_2 + E4_12 * minus_N4_3 + minus_N1_1;
  const T f_omega1_2 = E2_22 * N2_2 - E2_23 * rho2_3 + E3_22 * N3_2 - E3_23 * rho3_3 + T(0.2) * b1_1 - E4_12 *
      minus_N4_1 - E4_11 * minus_N4_2 - E4_13 * minus_N4_3 - minus_N1_2;
  const T f_omega1_3 = T(0.6) * minus_G2_1 + E2_23 * N2_2 + E2_22 * rho2_3 + T(0.6) * G3_1 + E3_23 * N3_2 + E3_22 *
      rho3_3 - E4_13 * minus_N4_1 - E4_12 * minus_N4_2 - E4_11 * minus_N4_3 - minus_N1_3;
  // h1 = m2 q2 + m3 q3 + m4 q4 + hc2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h1_2 = hc2_2 - minus_hc3_2;
  const T h1_3 = hc2_3 - T(0.8) - minus_hc3_3;
  // J1 = -q2~ hc2~ + E2^T J2 E2 - q3~ hc3~ + E3^T J3 E3 + E4^T I4 E4 + I1 + (-m2 q2~ - hc2~) q2~ + (-m3 q3~ - hc3~)
  //   q3~ - m4 q4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b1_5 = T(0.6) * hc2_2;
  const T b1_6 = b1_5 + T(12);
  const T b1_7 = T(0.6) * minus_hc3_2;
  const T b1_8 = b1_7 + (T(5.3999999999999995) + hc2_2) * T(0.6) + (T(5.3999999999999995) + minus_hc3_2) * T(0.6);
  const T b1_9 = E4_13 * T(0.0021);
  const T b1_10 = E4_12 * T(0.0021);
  const T b1_11 = E4_11 * T(0.0158) + b1_9 + b1_10;
  const T b1_12 = b1_11 * E4_11;
  const T b1_13 = E4_11 * T(0.0021);
  const T b1_14 = b1_10 + b1_13 + E4_13 * T(0.0158);
  const T b1_15 = b1_14 * E4_13;
  const T b1_16 = b1_9 + b1_13 + E4_12 * T(0.0158);
  const T b1_17 = b1_16 * E4_12;
  const T J1_11 = b1_6 + b1_8 + T(28.16) + b1_12 + b1_15 + b1_17;
  const T b1_18 = b1_11 * E4_12;
  const T b1_19 = b1_14 * E4_11;
  const T b1_20 = b1_16 * E4_13;
  const T J1_12 = b1_18 + b1_19 + b1_20 + T(0.2);
  const T J1_13 = b1_11 * E4_13 + b1_14 * E4_12 + b1_16 * E4_11 - T(0.1);
  const T b1_21 = E2_22 * T(0.75);
  const T b1_22 = E2_23 * T(12.75);
  const T b1_23 = E3_22 * T(0.75);
  const T b1_24 = E3_23 * T(12.75);
  const T J1_22 = b1_21 * E2_22 + b1_22 * E2_23 + b1_23 * E3_22 + b1_24 * E3_23 + b1_17 + b1_12 + b1_15 + T(14.16);
  const T J1_32 = b1_21 * E2_23 - b1_22 * E2_22 - T(0.6) * hc2_3 - T(0.6) * minus_hc3_3 + b1_23 * E3_23 - b1_24 *
      E3_22 + b1_20 + b1_18 + b1_19 + T(0.3);
  const T J1_33 = E2_23 * T(0.75) * E2_23 + E2_22 * T(12.75) * E2_22 + b1_5 + b1_8 + E3_23 * T(0.75) * E3_23 + E3_22 *
      T(12.75) * E3_22 + b1_15 + b1_17 + b1_12 + T(18);
  // K_thetadot4_1 = E4^T K_thetadot4_4
  const T K_thetadot4_1_1 = E4_11 * T(0.011547005383792516) + E4_13 * T(0.011547005383792516) + E4_12 *
      T(0.011547005383792516);
  // K_thetadot3_1 = q3~ E3^T B_thetadot3_3 + E3^T K_thetadot3_3
  const T K_thetadot3_1_1 = b1_7 + T(12);
  // D_omegadot1: pivots of L D L^T
  const T b1_25 = K_thetadot4_1_1 * T(50);
  const T b1_26 = b1_25 * K_thetadot4_1_1;
  const T b1_27 = K_thetadot3_1_1 * T(0.08333333333333333);
  const T b1_28 = b1_6 * T(0.08333333333333333);
  const T D_omegadot1_1 = J1_11 - b1_26 - b1_27 * K_thetadot3_1_1 - b1_28 * b1_6;
  const T b1_29 = J1_12 - b1_26;
  const T b1_30 = T(1) / D_omegadot1_1;
  const T b1_31 = b1_29 * b1_30;
  const T D_omegadot1_2 = J1_22 - b1_26 - b1_31 * b1_29;
  const T b1_32 = J1_13 - b1_26;
  const T b1_33 = b1_32 * b1_30;
  const T b1_34 = J1_32 - b1_26 - b1_33 * b1_29;
  const T b1_35 = T(1) / D_omegadot1_2;
  const T b1_36 = b1_34 * b1_35;
  const T D_omegadot1_3 = J1_33 - b1_26 - b1_33 * b1_32 - b1_36 * b1_34;
  // D_Pddot1: pivots of L D L^T
  const T b1_37 = h1_3 * b1_35;
  const T b1_38 = h1_2 + b1_37 * b1_34;
  const T b1_39 = T(1) / D_omegadot1_3;
  const T b1_40 = b1_38 * b1_39;
  const T D_Pddot1_1 = T(142) - b1_37 * h1_3 - b1_40 * b1_38;
  const T b1_41 = minus_hc3_3 * T(0.08333333333333333);
  const T b1_42 = hc2_3 * T(0.08333333333333333);
  const T b1_43 = h1_3 + b1_41 * K_thetadot3_1_1 - b1_42 * b1_6;
  const T b1_44 = b1_43 * b1_30;
  const T b1_45 = b1_44 * b1_29;
  const T b1_46 = b1_45 * b1_35;
  const T b1_47 = b1_44 * b1_32 - b1_46 * b1_34;
  const T b1_48 = b1_47 * b1_39;
  const T b1_49 = b1_48 * b1_38 - b1_46 * h1_3;
  const T b1_50 = T(1) / D_Pddot1_1;
  const T b1_51 = b1_49 * b1_50;
  const T D_Pddot1_2 = T(142) - b1_41 * minus_hc3_3 - b1_42 * hc2_3 - b1_44 * b1_43 - b1_46 * b1_45 - b1_48 * b1_47 -
      b1_51 * b1_49;
  const T b1_52 = minus_hc3_2 * T(0.08333333333333333);
  const T b1_53 = hc2_2 * T(0.08333333333333333);
  const T b1_54 = h1_2 + b1_52 * K_thetadot3_1_1 - b1_53 * b1_6;
  const T b1_55 = b1_54 * b1_30;
  const T b1_56 = b1_55 * b1_29;
  const T b1_57 = b1_56 * b1_35;
  const T b1_58 = b1_57 * b1_34 - b1_55 * b1_32;
  const T b1_59 = b1_58 * b1_39;
  const T b1_60 = b1_57 * h1_3 + b1_59 * b1_38;
  const T b1_61 = b1_60 * b1_50;
  const T b1_62 = b1_52 * minus_hc3_3 + b1_53 * hc2_3 + b1_55 * b1_43 + b1_57 * b1_45 - b1_59 * b1_47 - b1_61 * b1_49;
  const T b1_63 = T(1) / D_Pddot1_2;
  const T b1_64 = b1_62 * b1_63;
  const T D_Pddot1_3 = T(142) - b1_52 * minus_hc3_2 - b1_53 * hc2_2 - b1_55 * b1_54 - b1_57 * b1_56 - b1_59 * b1_58 -
      b1_61 * b1_60 - b1_64 * b1_62;

  // ---- body 1 (hub), solved
  // Pddot1: from A ydot = f by elimination
  const T z1_1 = u.wheel_torque - (T(0.5773502691896257) * minus_N4_1 + T(0.5773502691896257) * minus_N4_2 +
      T(0.5773502691896257) * minus_N4_3);
  const T z1_2 = b1_25 * z1_1;
  const T z1_3 = minus_rho3_1 + minus_effort_right_panel_3;
  const T z1_4 = minus_rho2_1 + minus_effort_left_panel_2;
  const T z1_5 = b1_27 * z1_3 - (minus_f_omega1_1 + z1_2) + b1_28 * z1_4;
  const T z1_6 = f_omega1_2 - z1_2 - b1_31 * z1_5;
  const T z1_7 = f_omega1_3 - z1_2 - b1_33 * z1_5 - b1_36 * z1_6;
  const T z1_8 = S1_1 - b1_37 * z1_6 + b1_40 * z1_7;
  const T z1_9 = S1_2 + b1_41 * z1_3 - b1_42 * z1_4 + b1_44 * z1_5 - b1_46 * z1_6 - b1_48 * z1_7 - b1_51 * z1_8;
  const T z1_10 = T(1) / D_Pddot1_3 * (S1_3 - b1_52 * z1_3 + b1_53 * z1_4 - b1_55 * z1_5 + b1_57 * z1_6 - b1_59 * z1_7
      - b1_61 * z1_8 - b1_64 * z1_9);
  const T z1_11 = z1_9 * b1_63 - b1_64 * z1_10;
  const T Pddot1_1 = z1_8 * b1_50 - b1_51 * z1_11 - b1_61 * z1_10;
  // omegadot1: from A ydot = f by elimination
  const T z1_12 = z1_7 * b1_39 + b1_40 * Pddot1_1 - b1_48 * z1_11 - b1_59 * z1_10;
  const T z1_13 = z1_6 * b1_35 - b1_36 * z1_12 - b1_37 * Pddot1_1 - b1_46 * z1_11 + b1_57 * z1_10;
  const T omegadot1_1 = z1_5 * b1_30 - b1_31 * z1_13 - b1_33 * z1_12 + b1_44 * z1_11 - b1_55 * z1_10;
  ydot[0] = omegadot1_1;
  ydot[1] = z1_13;
  ydot[2] = z1_12;
  // sddot1 = R1^T Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_1 = R1_11 * Pddot1_1 + R1_21 * z1_11 + R1_31 * z1_10;
  const T sddot1_2 = R1_12 * Pddot1_1 + R1_22 * z1_11 + R1_32 * z1_10;
  const T sddot1_3 = R1_13 * Pddot1_1 + R1_23 * z1_11 + R1_33 * z1_10;
  ydot[6] = sddot1_1;
  ydot[7] = sddot1_2;
  ydot[8] = sddot1_3;

  // ---- body 2 (left_panel), solved
  // thetaddot2: from A ydot = f by elimination
  const T thetaddot2 = b1_42 * z1_11 - (z1_4 * T(0.08333333333333333) + b1_28 * omegadot1_1) - b1_53 * z1_10;
  ydot[3] = thetaddot2;

  // ---- body 3 (right_panel), solved
  // thetaddot3: from A ydot = f by elimination
  const T thetaddot3 = b1_52 * z1_10 - (z1_3 * T(0.08333333333333333) + b1_27 * omegadot1_1 + b1_41 * z1_11);
  ydot[4] = thetaddot3;

  // ---- body 4 (wheel), solved
  // thetaddot4: from A ydot = f by elimination
  const T thetaddot4 = z1_1 * T(50) - b1_25 * omegadot1_1 - b1_25 * z1_13 - b1_25 * z1_12;
  ydot[5] = thetaddot4;

  // ---- body 1 (hub) on the inertial frame
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
  const T sdot1_1 = y[6], sdot1_2 = y[7], sdot1_3 = y[8];
  xdot[4] = thetadot2;
  xdot[5] = thetadot3;
  xdot[6] = thetadot4;
  xdot[7] = sdot1_1;
  xdot[8] = sdot1_2;
  xdot[9] = sdot1_3;
}

// state_matrix: S of d(xi, y)/dt = S (xi, y) for small changes of the tangent xi and of y.
// S (2 ny x 2 ny)
// 1585 add, 1820 multiply, 6 divide, 6 sine or cosine
template <class T>
void state_matrix(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* S) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 324; ++i) S[i] = T(0);

  // ---- body 1 (hub) on the inertial frame
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
  // N1 = -omega1~ I1 omega1 + r_thruster_~ F_thruster_: applied less inertia moment at ydot = 0, body axes [N m]
  const T t1_13 = omega1_2 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T t1_15 = omega1_3 * omega1_3;
  const T t1_16 = omega1_1 * omega1_2;
  const T t1_17 = omega1_1 * omega1_3;
  const T minus_N1_1 = T(4) * t1_13 + T(0.3) * (t1_14 - t1_15) - T(0.1) * t1_16 - T(0.2) * t1_17;
  const T t1_18 = omega1_1 * omega1_1;
  const T minus_N1_2 = T(0.2) * t1_13 - (T(2) * t1_17 + T(0.1) * (t1_15 - t1_18)) - T(0.3) * t1_16;
  const T minus_N1_3 = T(0.1) * u.thrust + T(0.2) * (t1_18 - t1_14) - T(2) * t1_16 + T(0.3) * t1_17 + T(0.1) * t1_13;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_2 = thetadot2 * omega2_3;
  const T minus_omegadot2_3 = thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_2 * omega2_1;
  const T U2_12 = t2_1 + minus_omegadot2_3;
  const T t2_2 = omega2_3 * omega2_1;
  const T U2_13 = t2_2 + omegadot2_2;
  const T U2_21 = t2_1 - minus_omegadot2_3;
  const T t2_3 = omega2_3 * omega2_3;
  const T minus_U2_22 = t2_3 + omega2_1 * omega2_1;
  const T U2_23 = omega2_3 * omega2_2;
  const T U2_31 = t2_2 - omegadot2_2;
  // Pddot2 = E2 omega1~ omega1~ q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_4 = omega1_1 * T(0.6);
  const T Pddot2_1 = omega1_2 * t2_4;
  const T t2_5 = omega1_3 * T(0.6);
  const T t2_6 = omega1_2 * t2_5;
  const T t2_7 = omega1_3 * t2_5 + omega1_1 * t2_4;
  const T Pddot2_2 = E2_23 * t2_6 - E2_22 * t2_7;
  const T Pddot2_3 = E2_23 * t2_7 + E2_22 * t2_6;
  // effort_left_panel_2 = -theta2 k_left_panel_ - thetadot2 c_left_panel_: along the coordinate [N m], [N]
  const T minus_effort_left_panel_2 = theta2 * c.p.k + thetadot2 * c.p.c;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a2_1 = U2_12 + Pddot2_1;
  const T a2_2 = Pddot2_2 - minus_U2_22;
  const T a2_3 = U2_23 + Pddot2_3;
  // G2 = -m2 a2: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G2_1 = T(9) * a2_1;
  const T minus_G2_2 = T(9) * a2_2;
  const T minus_G2_3 = T(9) * a2_3;
  // N2 = -axial(U2 (tr(I2)/2 - I2)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N2_1 = T(3) * U2_23;
  const T N2_2 = T(0.75) * U2_31;
  const T t2_8 = T(0.75) * U2_21;
  const T minus_N2_3 = t2_8 - T(3) * U2_12;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // omegadot3 = -thetadot3 b3~ E3 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot3_2 = thetadot3 * omega3_3;
  const T minus_omegadot3_3 = thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_2 * omega3_1;
  const T U3_12 = t3_1 + minus_omegadot3_3;
  const T t3_2 = omega3_3 * omega3_1;
  const T U3_13 = t3_2 + omegadot3_2;
  const T U3_21 = t3_1 - minus_omegadot3_3;
  const T t3_3 = omega3_3 * omega3_3;
  const T minus_U3_22 = t3_3 + omega3_1 * omega3_1;
  const T U3_23 = omega3_3 * omega3_2;
  const T U3_31 = t3_2 - omegadot3_2;
  // Pddot3 = E3 omega1~ omega1~ q3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot3_2 = E3_22 * t2_7 - E3_23 * t2_6;
  const T minus_Pddot3_3 = E3_23 * t2_7 + E3_22 * t2_6;
  // effort_right_panel_3 = -theta3 k_right_panel_ - thetadot3 c_right_panel_: along the coordinate [N m], [N]
  const T minus_effort_right_panel_3 = theta3 * c.p.k + thetadot3 * c.p.c;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T minus_a3_1 = U3_12 + Pddot2_1;
  const T a3_2 = minus_U3_22 + Pddot3_2;
  const T minus_a3_3 = U3_23 + minus_Pddot3_3;
  // G3 = -m3 a3: applied less inertia force at ydot = 0, body axes [N]
  const T G3_1 = T(9) * minus_a3_1;
  const T minus_G3_2 = T(9) * a3_2;
  const T G3_3 = T(9) * minus_a3_3;
  // N3 = -axial(U3 (tr(I3)/2 - I3)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N3_1 = T(3) * U3_23;
  const T N3_2 = T(0.75) * U3_31;
  const T t3_4 = T(0.75) * U3_21;
  const T minus_N3_3 = t3_4 - T(3) * U3_12;

  // ---- body 4 (wheel) on body 1
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cos(theta4);
  const T E4_11 = t4_1 * T(0.6666666666666666) + T(0.3333333333333334);
  const T t4_2 = sin(theta4);
  const T t4_3 = t4_2 * T(0.5773502691896257);
  const T t4_4 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_3 + t4_4;
  const T E4_13 = t4_4 - t4_3;
  // omega4 = thetadot4 b4 + E4 omega1: absolute angular velocity, body axes [rad/s]
  const T t4_5 = thetadot4 * T(0.5773502691896257);
  const T t4_6 = E4_11 * omega1_1 + E4_12 * omega1_2 + E4_13 * omega1_3;
  const T omega4_1 = t4_5 + t4_6;
  const T t4_7 = E4_13 * omega1_1 + E4_11 * omega1_2 + E4_12 * omega1_3;
  const T omega4_2 = t4_5 + t4_7;
  const T t4_8 = E4_12 * omega1_1 + E4_13 * omega1_2 + E4_11 * omega1_3;
  const T omega4_3 = t4_5 + t4_8;
  // omegadot4 = -thetadot4 b4~ E4 omega1: angular acceleration, body axes [rad/s^2]
  const T t4_9 = T(0.5773502691896257) * t4_8;
  const T t4_10 = T(0.5773502691896257) * t4_7;
  const T t4_11 = t4_9 - t4_10;
  const T minus_omegadot4_1 = thetadot4 * t4_11;
  const T t4_12 = T(0.5773502691896257) * t4_6;
  const T t4_13 = t4_12 - t4_9;
  const T minus_omegadot4_2 = thetadot4 * t4_13;
  const T t4_14 = t4_10 - t4_12;
  const T minus_omegadot4_3 = thetadot4 * t4_14;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_15 = omega4_3 * omega4_3;
  const T t4_16 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_15 + t4_16;
  const T t4_17 = omega4_2 * omega4_1;
  const T U4_12 = t4_17 + minus_omegadot4_3;
  const T t4_18 = omega4_3 * omega4_1;
  const T U4_13 = t4_18 - minus_omegadot4_2;
  const T U4_21 = t4_17 - minus_omegadot4_3;
  const T t4_19 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_15 + t4_19;
  const T t4_20 = omega4_3 * omega4_2;
  const T U4_23 = t4_20 + minus_omegadot4_1;
  const T U4_31 = t4_18 + minus_omegadot4_2;
  const T U4_32 = t4_20 - minus_omegadot4_1;
  const T minus_U4_33 = t4_16 + t4_19;
  // Pddot4 = E4 omega1~ omega1~ q4: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_21 = T(0.2) * omega1_1;
  const T t4_22 = T(0.2) * omega1_2;
  const T t4_23 = omega1_1 * t4_21 + omega1_2 * t4_22;
  const T t4_24 = omega1_3 * t4_21;
  const T t4_25 = omega1_3 * t4_22;
  const T Pddot4_1 = E4_13 * t4_23 - (E4_11 * t4_24 + E4_12 * t4_25);
  const T Pddot4_2 = E4_12 * t4_23 - (E4_13 * t4_24 + E4_11 * t4_25);
  const T Pddot4_3 = E4_11 * t4_23 - (E4_12 * t4_24 + E4_13 * t4_25);
  // G4 = -m4 Pddot4: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G4_1 = T(4) * Pddot4_1;
  const T minus_G4_2 = T(4) * Pddot4_2;
  const T minus_G4_3 = T(4) * Pddot4_3;
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N4_1 = T(0.0079) * U4_32 - T(0.0079) * U4_23 - T(0.0021) * (minus_U4_22 - minus_U4_33) - T(0.0021) *
      U4_31 + T(0.0021) * U4_21;
  const T minus_N4_2 = T(0.0079) * U4_13 - T(0.0079) * U4_31 - T(0.0021) * (minus_U4_33 - minus_U4_11) - T(0.0021) *
      U4_12 + T(0.0021) * U4_32;
  const T minus_N4_3 = T(0.0079) * U4_21 - T(0.0079) * U4_12 - T(0.0021) * (minus_U4_11 - minus_U4_22) - T(0.0021) *
      U4_23 + T(0.0021) * U4_13;

  // ---- body 3 (right_panel) and what it carries
  // rho3 = r3~ G3 + N3: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T minus_rho3_1 = G3_3 + minus_N3_1;
  const T rho3_3 = G3_1 - minus_N3_3;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc3_2 = E3_22 * T(9);
  const T minus_hc3_3 = E3_23 * T(9);

  // ---- body 2 (left_panel) and what it carries
  // rho2 = r2~ G2 + N2: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T minus_rho2_1 = minus_G2_3 + minus_N2_1;
  const T rho2_3 = minus_G2_1 - minus_N2_3;
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_2 = E2_22 * T(9);
  const T hc2_3 = E2_23 * T(9);

  // ---- body 1 (hub) and what it carries
  // S1 = E2^T G2 + E3^T G3 + E4^T G4 + F_thruster_: sum of the force balances of the subtree, body axes [N]
  const T b1_1 = E4_11 * minus_G4_1 + E4_13 * minus_G4_2 + E4_12 * minus_G4_3;
  const T S1_1 = G3_1 - minus_G2_1 - b1_1 + u.thrust;
  const T b1_2 = E3_22 * minus_G3_2 + E3_23 * G3_3;
  const T b1_3 = E2_23 * minus_G2_3 - E2_22 * minus_G2_2;
  const T b1_4 = E4_12 * minus_G4_1 + E4_11 * minus_G4_2 + E4_13 * minus_G4_3;
  const T minus_S1_2 = b1_2 - b1_3 + b1_4;
  const T b1_5 = E3_22 * G3_3 - E3_23 * minus_G3_2;
  const T b1_6 = E2_23 * minus_G2_2 + E2_22 * minus_G2_3;
  const T S1_3 = b1_5 - (E4_13 * minus_G4_1 + E4_12 * minus_G4_2 + E4_11 * minus_G4_3) - b1_6;
  // f_omega1 = q2~ E2^T G2 + E2^T rho2 + q3~ E3^T G3 + E3^T rho3 + q4~ E4^T G4 + E4^T N4 + N1: Kane's equation of
  //   omega [N m]
  const T minus_f_omega1_1 = T(0.6) * b1_6 + minus_rho2_1 + T(0.6) * b1_5 + minus_rho3_1 + T(0.2) * b1_4 + E4_11 *
      minus_N4_1 + E4_13 * minus_N4_2 + E4_12 * minus_N4_3 + minus_N1_1;
  const T b1_7 = E2_22 * N2_2 - E2_23 * rho2_3;
  const T b1_8 = E3_22 * N3_2 - E3_23 * rho3_3;
  const T f_omega1_2 = b1_7 + b1_8 + T(0.2) * b1_1 - E4_12 * minus_N4_1 - E4_11 * minus_N4_2 - E4_13 * minus_N4_3 -
      minus_N1_2;
  const T b1_9 = E2_23 * N2_2 + E2_22 * rho2_3;
  const T b1_10 = E3_23 * N3_2 + E3_22 * rho3_3;
  const T f_omega1_3 = T(0.6) * minus_G2_1 + b1_9 + T(0.6) * G3_1 + b1_10 - E4_13 * minus_N4_1 - E4_12 * minus_N4_2 -
      E4_11 * minus_N4_3 - minus_N1_3;
  // h1 = m2 q2 + m3 q3 + m4 q4 + hc2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h1_2 = hc2_2 - minus_hc3_2;
  const T h1_3 = hc2_3 - T(0.8) - minus_hc3_3;
  // J1 = -q2~ hc2~ + E2^T J2 E2 - q3~ hc3~ + E3^T J3 E3 + E4^T I4 E4 + I1 + (-m2 q2~ - hc2~) q2~ + (-m3 q3~ - hc3~)
  //   q3~ - m4 q4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b1_11 = T(0.6) * hc2_2;
  const T b1_12 = b1_11 + T(12);
  const T b1_13 = T(0.6) * minus_hc3_2;
  const T b1_14 = E4_13 * T(0.0021);
  const T b1_15 = E4_12 * T(0.0021);
  const T b1_16 = E4_11 * T(0.0158) + b1_14 + b1_15;
  const T b1_17 = b1_16 * E4_11;
  const T b1_18 = E4_11 * T(0.0021);
  const T b1_19 = b1_15 + b1_18 + E4_13 * T(0.0158);
  const T b1_20 = b1_19 * E4_13;
  const T b1_21 = b1_14 + b1_18 + E4_12 * T(0.0158);
  const T b1_22 = b1_21 * E4_12;
  const T b1_23 = (T(5.3999999999999995) + hc2_2) * T(0.6) + (T(5.3999999999999995) + minus_hc3_2) * T(0.6);
  const T J1_11 = b1_12 + b1_13 + T(28.16) + b1_17 + b1_20 + b1_22 + b1_23;
  const T b1_24 = b1_16 * E4_12;
  const T b1_25 = b1_19 * E4_11;
  const T b1_26 = b1_21 * E4_13;
  const T J1_12 = b1_24 + b1_25 + b1_26 + T(0.2);
  const T J1_13 = b1_16 * E4_13 + b1_19 * E4_12 + b1_21 * E4_11 - T(0.1);
  const T b1_27 = E2_22 * T(0.75);
  const T b1_28 = E2_23 * T(12.75);
  const T b1_29 = b1_27 * E2_22 + b1_28 * E2_23;
  const T b1_30 = E3_22 * T(0.75);
  const T b1_31 = E3_23 * T(12.75);
  const T b1_32 = b1_30 * E3_22 + b1_31 * E3_23;
  const T J1_22 = b1_29 + b1_32 + b1_22 + b1_17 + b1_20 + T(14.16);
  const T b1_33 = b1_27 * E2_23 - b1_28 * E2_22;
  const T b1_34 = T(0.6) * hc2_3;
  const T b1_35 = T(0.6) * minus_hc3_3;
  const T b1_36 = b1_30 * E3_23 - b1_31 * E3_22;
  const T J1_32 = b1_33 - b1_34 - b1_35 + b1_36 + b1_26 + b1_24 + b1_25 + T(0.3);
  const T b1_37 = E2_22 * T(12.75);
  const T b1_38 = E2_23 * T(0.75);
  const T b1_39 = b1_11 + b1_38 * E2_23 + b1_37 * E2_22;
  const T b1_40 = E3_22 * T(12.75);
  const T b1_41 = E3_23 * T(0.75);
  const T b1_42 = b1_13 + b1_41 * E3_23 + b1_40 * E3_22;
  const T J1_33 = b1_39 + b1_42 + b1_20 + b1_22 + b1_17 + T(18) + b1_23;
  // K_thetadot4_1 = E4^T K_thetadot4_4
  const T K_thetadot4_1_1 = E4_11 * T(0.011547005383792516) + E4_13 * T(0.011547005383792516) + E4_12 *
      T(0.011547005383792516);
  // K_thetadot3_1 = q3~ E3^T B_thetadot3_3 + E3^T K_thetadot3_3
  const T K_thetadot3_1_1 = b1_13 + T(12);
  // D_omegadot1: pivots of L D L^T
  const T b1_43 = K_thetadot4_1_1 * T(50);
  const T b1_44 = b1_43 * K_thetadot4_1_1;
  const T b1_45 = K_thetadot3_1_1 * T(0.08333333333333333);
  const T b1_46 = b1_12 * T(0.08333333333333333);
  const T D_omegadot1_1 = J1_11 - b1_44 - b1_45 * K_thetadot3_1_1 - b1_46 * b1_12;
  const T b1_47 = J1_12 - b1_44;
  const T b1_48 = T(1) / D_omegadot1_1;
  const T b1_49 = b1_47 * b1_48;
  const T D_omegadot1_2 = J1_22 - b1_44 - b1_49 * b1_47;
  const T b1_50 = J1_13 - b1_44;
  const T b1_51 = b1_50 * b1_48;
  const T b1_52 = J1_32 - b1_44 - b1_51 * b1_47;
  const T b1_53 = T(1) / D_omegadot1_2;
  const T b1_54 = b1_52 * b1_53;
  const T D_omegadot1_3 = J1_33 - b1_44 - b1_51 * b1_50 - b1_54 * b1_52;
  // D_Pddot1: pivots of L D L^T
  const T b1_55 = h1_3 * b1_53;
  const T b1_56 = h1_2 + b1_55 * b1_52;
  const T b1_57 = T(1) / D_omegadot1_3;
  const T b1_58 = b1_56 * b1_57;
  const T D_Pddot1_1 = T(142) - b1_55 * h1_3 - b1_58 * b1_56;
  const T b1_59 = minus_hc3_3 * T(0.08333333333333333);
  const T b1_60 = b1_59 * minus_hc3_3;
  const T b1_61 = hc2_3 * T(0.08333333333333333);
  const T b1_62 = b1_61 * hc2_3;
  const T b1_63 = b1_59 * K_thetadot3_1_1;
  const T b1_64 = b1_61 * b1_12;
  const T b1_65 = h1_3 + b1_63 - b1_64;
  const T b1_66 = b1_65 * b1_48;
  const T b1_67 = b1_66 * b1_47;
  const T b1_68 = b1_67 * b1_53;
  const T b1_69 = b1_66 * b1_50 - b1_68 * b1_52;
  const T b1_70 = b1_69 * b1_57;
  const T b1_71 = b1_70 * b1_56 - b1_68 * h1_3;
  const T b1_72 = T(1) / D_Pddot1_1;
  const T b1_73 = b1_71 * b1_72;
  const T D_Pddot1_2 = T(142) - b1_60 - b1_62 - b1_66 * b1_65 - b1_68 * b1_67 - b1_70 * b1_69 - b1_73 * b1_71;
  const T b1_74 = minus_hc3_2 * T(0.08333333333333333);
  const T b1_75 = b1_74 * minus_hc3_2;
  const T b1_76 = hc2_2 * T(0.08333333333333333);
  const T b1_77 = b1_76 * hc2_2;
  const T b1_78 = b1_74 * K_thetadot3_1_1;
  const T b1_79 = b1_76 * b1_12;
  const T b1_80 = h1_2 + b1_78 - b1_79;
  const T b1_81 = b1_80 * b1_48;
  const T b1_82 = b1_81 * b1_47;
  const T b1_83 = b1_82 * b1_53;
  const T b1_84 = b1_83 * b1_52 - b1_81 * b1_50;
  const T b1_85 = b1_84 * b1_57;
  const T b1_86 = b1_83 * h1_3 + b1_85 * b1_56;
  const T b1_87 = b1_86 * b1_72;
  const T b1_88 = b1_74 * minus_hc3_3;
  const T b1_89 = b1_76 * hc2_3;
  const T b1_90 = b1_88 + b1_89 + b1_81 * b1_65 + b1_83 * b1_67 - b1_85 * b1_69 - b1_87 * b1_71;
  const T b1_91 = T(1) / D_Pddot1_2;
  const T b1_92 = b1_90 * b1_91;
  const T D_Pddot1_3 = T(142) - b1_75 - b1_77 - b1_81 * b1_80 - b1_83 * b1_82 - b1_85 * b1_84 - b1_87 * b1_86 - b1_92
      * b1_90;

  // ---- body 1 (hub), solved
  // Pddot1: from A ydot = f by elimination
  const T z1_1 = u.wheel_torque - (T(0.5773502691896257) * minus_N4_1 + T(0.5773502691896257) * minus_N4_2 +
      T(0.5773502691896257) * minus_N4_3);
  const T z1_2 = b1_43 * z1_1;
  const T z1_3 = minus_rho3_1 + minus_effort_right_panel_3;
  const T z1_4 = minus_rho2_1 + minus_effort_left_panel_2;
  const T z1_5 = b1_45 * z1_3 - (minus_f_omega1_1 + z1_2) + b1_46 * z1_4;
  const T z1_6 = f_omega1_2 - z1_2 - b1_49 * z1_5;
  const T z1_7 = f_omega1_3 - z1_2 - b1_51 * z1_5 - b1_54 * z1_6;
  const T z1_8 = S1_1 - b1_55 * z1_6 + b1_58 * z1_7;
  const T z1_9 = b1_59 * z1_3;
  const T z1_10 = b1_61 * z1_4;
  const T z1_11 = z1_9 - minus_S1_2 - z1_10 + b1_66 * z1_5 - b1_68 * z1_6 - b1_70 * z1_7 - b1_73 * z1_8;
  const T z1_12 = b1_74 * z1_3;
  const T z1_13 = b1_76 * z1_4;
  const T z1_14 = S1_3 - z1_12 + z1_13 - b1_81 * z1_5 + b1_83 * z1_6 - b1_85 * z1_7 - b1_87 * z1_8 - b1_92 * z1_11;
  const T z1_15 = T(1) / D_Pddot1_3;
  const T z1_16 = z1_14 * z1_15;
  const T z1_17 = z1_11 * b1_91 - b1_92 * z1_16;
  const T Pddot1_1 = z1_8 * b1_72 - b1_73 * z1_17 - b1_87 * z1_16;
  // omegadot1: from A ydot = f by elimination
  const T z1_18 = z1_7 * b1_57 + b1_58 * Pddot1_1 - b1_70 * z1_17 - b1_85 * z1_16;
  const T z1_19 = z1_6 * b1_53 - b1_54 * z1_18 - b1_55 * Pddot1_1 - b1_68 * z1_17 + b1_83 * z1_16;
  const T omegadot1_1 = z1_5 * b1_48 - b1_49 * z1_19 - b1_51 * z1_18 + b1_66 * z1_17 - b1_81 * z1_16;

  // ---- results
  S[1] = omega1_3;
  S[18] = -omega1_3;
  S[2] = -omega1_2;
  S[36] = omega1_2;
  S[9] = T(1);
  S[28] = T(1);
  S[47] = T(1);
  S[66] = T(1);
  S[85] = T(1);
  S[104] = T(1);
  S[123] = T(1);
  S[142] = T(1);
  S[161] = T(1);
  S[20] = omega1_1;
  S[37] = -omega1_1;
  const T t1 = b1_48 * b1_48;
  const T t2 = T(0.08333333333333333) * b1_34;
  const T t3 = T(1.2) * hc2_3;
  const T t4 = t1 * (b1_12 * t2 + b1_46 * b1_34 - t3);
  const T t5 = b1_50 * t4;
  const T t6 = b1_64 + b1_76 * b1_34 - hc2_3;
  const T t7 = b1_48 * t6 - b1_80 * t4;
  const T t8 = t2_3 - omega2_2 * omega2_2;
  const T t9 = T(9) * (t8 - Pddot2_2);
  const T t10 = t9 + T(3) * t8;
  const T t11 = t10 + c.p.k;
  const T t12 = b1_47 * t7;
  const T t13 = b1_53 * b1_53;
  const T t14 = E2_23 * b1_37 - b1_33 - E2_22 * b1_38;
  const T t15 = b1_47 * t4;
  const T t16 = t13 * (t14 + b1_47 * t15);
  const T t17 = b1_53 * t12 - b1_82 * t16;
  const T t18 = b1_29 - b1_39 + b1_47 * t5;
  const T t19 = b1_52 * t17 + b1_83 * t18 - b1_50 * t7;
  const T t20 = b1_57 * b1_57;
  const T t21 = b1_53 * t18 - b1_52 * t16;
  const T t22 = t20 * (b1_50 * t5 - t14 - t3 - b1_52 * t21 - b1_54 * t18);
  const T t23 = b1_57 * t19 - b1_84 * t22;
  const T t24 = b1_53 * hc2_2 - h1_3 * t16;
  const T t25 = b1_52 * t24 + b1_55 * t18 - hc2_3;
  const T t26 = h1_3 * t17 + b1_83 * hc2_2 + b1_56 * t23 + b1_85 * t25;
  const T t27 = b1_72 * b1_72;
  const T t28 = b1_57 * t25 - b1_56 * t22;
  const T t29 = t27 * (h1_3 * t24 + b1_55 * hc2_2 + b1_56 * t28 + b1_58 * t25);
  const T t30 = b1_72 * t26 + b1_86 * t29;
  const T t31 = hc2_2 + b1_61 * b1_34 - b1_79;
  const T t32 = b1_48 * t31 - b1_65 * t4;
  const T t33 = b1_47 * t32;
  const T t34 = b1_53 * t33 - b1_67 * t16;
  const T t35 = b1_50 * t32 - (b1_52 * t34 + b1_68 * t18);
  const T t36 = b1_57 * t35 - b1_69 * t22;
  const T t37 = b1_56 * t36 + b1_70 * t25 - h1_3 * t34 - b1_68 * hc2_2;
  const T t38 = b1_65 * t7 - (b1_71 * t30 + b1_87 * t37 + b1_69 * t23 + b1_85 * t35) + b1_81 * t31 - b1_62 + b1_77 +
      b1_67 * t17 + b1_83 * t33;
  const T t39 = b1_91 * b1_91;
  const T t40 = b1_89 + b1_61 * hc2_2;
  const T t41 = b1_72 * t37 + b1_71 * t29;
  const T t42 = t39 * (t40 + b1_65 * t32 + b1_66 * t31 + b1_67 * t34 + b1_68 * t33 + b1_69 * t36 + b1_70 * t35 + b1_71
      * t41 + b1_73 * t37);
  const T t43 = b1_91 * t38 + b1_90 * t42;
  const T t44 = N2_2 - T(12) * U2_13;
  const T t45 = T(9) * (a2_3 + U2_23);
  const T t46 = E2_22 * t9 - b1_3 + E2_23 * t45;
  const T t47 = b1_46 * t11 - z1_4 * t2 - T(0.6) * t46 - t10;
  const T t48 = E2_22 * t2_8 + b1_9 - E2_23 * t44 + b1_49 * t47 - z1_5 * t15;
  const T t49 = T(9) * U2_13;
  const T t50 = b1_54 * t48 - z1_6 * t21 - b1_51 * t47 + z1_5 * t5 + b1_7 - E2_22 * t44 - E2_23 * t2_8 + T(0.6) * t49;
  const T t51 = z1_7 * t28 + b1_58 * t50 - t49 - z1_6 * t24 + b1_55 * t48;
  const T t52 = b1_68 * t48 - (z1_8 * t41 + b1_73 * t51 + z1_7 * t36 + b1_70 * t50 + z1_6 * t34) + b1_6 - E2_22 * t45
      + E2_23 * t9 - z1_13 - b1_61 * t11 + z1_5 * t32 + b1_66 * t47;
  const T t53 = z1_15 * z1_15;
  const T t54 = z1_15 * (b1_76 * t11 - (z1_11 * t43 + b1_92 * t52 + z1_8 * t30 + b1_87 * t51 + z1_7 * t23 + b1_85 *
      t50 + z1_5 * t7 + b1_81 * t47 + z1_10) - t46 + z1_6 * t17 - b1_83 * t48) + t53 * (b1_80 * t7 + b1_81 * t6 - t40
      + b1_82 * t17 + b1_83 * t12 + b1_84 * t23 + b1_85 * t19 + b1_86 * t30 + b1_87 * t26 + b1_90 * t43 + b1_92 * t38)
      * z1_14;
  const T t55 = b1_91 * t52 - (z1_16 * t43 + b1_92 * t54) + z1_11 * t42;
  const T t56 = b1_72 * t51 - (z1_16 * t30 + b1_87 * t54 + z1_17 * t41 + b1_73 * t55) + z1_8 * t29;
  const T t57 = b1_57 * t50 - (z1_16 * t23 + b1_85 * t54 + z1_17 * t36 + b1_70 * t55) - z1_7 * t22 + Pddot1_1 * t28 +
      b1_58 * t56;
  const T t58 = z1_16 * t17 + b1_83 * t54 - b1_53 * t48 - z1_6 * t16 - z1_18 * t21 - b1_54 * t57 - Pddot1_1 * t24 -
      b1_55 * t56 - z1_17 * t34 - b1_68 * t55;
  const T t59 = z1_18 * t5 - (z1_16 * t7 + b1_81 * t54 + b1_51 * t57) - b1_49 * t58 + z1_19 * t15 + b1_48 * t47 - z1_5
      * t4 + z1_17 * t32 + b1_66 * t55;
  S[165] = t59;
  const T t60 = b1_78 - b1_59 * b1_35 - minus_hc3_2;
  const T t61 = T(0.08333333333333333) * b1_35;
  const T t62 = T(1.2) * minus_hc3_3;
  const T t63 = t1 * (K_thetadot3_1_1 * t61 + b1_45 * b1_35 - t62);
  const T t64 = b1_48 * t60 - b1_65 * t63;
  const T t65 = minus_hc3_3 - (b1_63 + b1_74 * b1_35);
  const T t66 = b1_48 * t65 - b1_80 * t63;
  const T t67 = t3_3 - omega3_2 * omega3_2;
  const T t68 = T(9) * (Pddot3_2 + t67);
  const T t69 = T(9) * (minus_a3_3 + U3_23);
  const T t70 = E3_22 * t68 - b1_2 + E3_23 * t69;
  const T t71 = T(3) * t67 + t68;
  const T t72 = t71 + c.p.k;
  const T t73 = T(0.6) * t70 + t71 + z1_3 * t61 - b1_45 * t72;
  const T t74 = b1_47 * t66;
  const T t75 = E3_23 * b1_40 - b1_36 - E3_22 * b1_41;
  const T t76 = b1_47 * t63;
  const T t77 = t13 * (t75 + b1_47 * t76);
  const T t78 = b1_53 * t74 - b1_82 * t77;
  const T t79 = b1_50 * t63;
  const T t80 = b1_32 - b1_42 + b1_47 * t79;
  const T t81 = b1_52 * t78 + b1_83 * t80 - b1_50 * t66;
  const T t82 = b1_53 * t80 - b1_52 * t77;
  const T t83 = t20 * (b1_50 * t79 - t75 - t62 - b1_52 * t82 - b1_54 * t80);
  const T t84 = b1_57 * t81 - b1_84 * t83;
  const T t85 = b1_53 * minus_hc3_2 + h1_3 * t77;
  const T t86 = minus_hc3_3 + b1_55 * t80 - b1_52 * t85;
  const T t87 = h1_3 * t78 - b1_83 * minus_hc3_2 + b1_56 * t84 + b1_85 * t86;
  const T t88 = b1_57 * t86 - b1_56 * t83;
  const T t89 = t27 * (h1_3 * t85 - (b1_56 * t88 + b1_58 * t86) + b1_55 * minus_hc3_2);
  const T t90 = b1_72 * t87 - b1_86 * t89;
  const T t91 = b1_47 * t64;
  const T t92 = b1_53 * t91 - b1_67 * t77;
  const T t93 = b1_50 * t64 - (b1_52 * t92 + b1_68 * t80);
  const T t94 = b1_57 * t93 - b1_69 * t83;
  const T t95 = b1_56 * t94 + b1_70 * t86 - h1_3 * t92 + b1_68 * minus_hc3_2;
  const T t96 = b1_65 * t66 - (b1_71 * t90 + b1_87 * t95 + b1_69 * t84 + b1_85 * t93) + b1_81 * t60 - b1_60 + b1_75 +
      b1_67 * t78 + b1_83 * t91;
  const T t97 = b1_88 + b1_59 * minus_hc3_2;
  const T t98 = b1_72 * t95 - b1_71 * t89;
  const T t99 = t39 * (t97 + b1_65 * t64 + b1_66 * t60 + b1_67 * t92 + b1_68 * t91 + b1_69 * t94 + b1_70 * t93 + b1_71
      * t98 + b1_73 * t95);
  const T t100 = b1_91 * t96 + b1_90 * t99;
  const T t101 = T(12) * U3_13 - N3_2;
  const T t102 = z1_5 * t76 + b1_49 * t73 - E3_22 * t3_4 - b1_10 - E3_23 * t101;
  const T t103 = T(9) * U3_13;
  const T t104 = b1_8 - (z1_6 * t82 + b1_54 * t102) - E3_23 * t3_4 + E3_22 * t101 + T(0.6) * t103 + z1_5 * t79 + b1_51
      * t73;
  const T t105 = z1_6 * t85 - b1_55 * t102 + t103 + z1_7 * t88 + b1_58 * t104;
  const T t106 = E3_22 * t69 - (z1_8 * t98 + b1_73 * t105 + z1_7 * t94 + b1_70 * t104 + z1_6 * t92 + b1_68 * t102 +
      E3_23 * t68 + b1_5) + z1_12 + b1_59 * t72 + z1_5 * t64 - b1_66 * t73;
  const T t107 = z1_15 * (b1_81 * t73 - (z1_11 * t100 + b1_92 * t106 + z1_8 * t90 + b1_87 * t105 + z1_7 * t84 + b1_85
      * t104 + z1_5 * t66) - b1_74 * t72 + z1_9 + t70 + z1_6 * t78 + b1_83 * t102) + t53 * (b1_80 * t66 + b1_81 * t65
      - t97 + b1_82 * t78 + b1_83 * t74 + b1_84 * t84 + b1_85 * t81 + b1_86 * t90 + b1_87 * t87 + b1_90 * t100 + b1_92
      * t96) * z1_14;
  const T t108 = b1_91 * t106 - (z1_16 * t100 + b1_92 * t107) + z1_11 * t99;
  const T t109 = b1_72 * t105 - (z1_16 * t90 + b1_87 * t107 + z1_17 * t98 + b1_73 * t108) - z1_8 * t89;
  const T t110 = b1_57 * t104 - (z1_16 * t84 + b1_85 * t107 + z1_17 * t94 + b1_70 * t108) - z1_7 * t83 + Pddot1_1 *
      t88 + b1_58 * t109;
  const T t111 = Pddot1_1 * t85 - (z1_17 * t92 + b1_68 * t108 + b1_55 * t109) - z1_18 * t82 - b1_54 * t110 + b1_53 *
      t102 - z1_6 * t77 + z1_16 * t78 + b1_83 * t107;
  const T t112 = z1_17 * t64 - (z1_16 * t66 + b1_81 * t107) + b1_66 * t108 - b1_48 * t73 - z1_5 * t63 - b1_49 * t111 +
      z1_19 * t76 - b1_51 * t110 + z1_18 * t79;
  S[166] = t112;
  const T t113 = T(0.5773502691896257) * t4_1;
  const T t114 = T(0.3333333333333333) * t4_2;
  const T t115 = t113 + t114;
  const T t116 = t113 - t114;
  const T t117 = T(0.0021) * t116;
  const T t118 = T(0.6666666666666666) * t4_2;
  const T t119 = T(0.0021) * t118;
  const T t120 = T(0.0158) * t115 - t117 - t119;
  const T t121 = E4_12 * t120;
  const T t122 = T(0.011547005383792516) * t115 - T(0.011547005383792516) * t116 - T(0.011547005383792516) * t118;
  const T t123 = T(50) * t122;
  const T t124 = K_thetadot4_1_1 * t123;
  const T t125 = b1_43 * t122;
  const T t126 = t124 + t125;
  const T t127 = T(0.0021) * t115;
  const T t128 = t117 - t127 + T(0.0158) * t118;
  const T t129 = E4_11 * t128;
  const T t130 = b1_16 * t118;
  const T t131 = t119 - t127 + T(0.0158) * t116;
  const T t132 = E4_13 * t131;
  const T t133 = b1_19 * t116;
  const T t134 = b1_21 * t115;
  const T t135 = t1 * (t121 - (t126 + t129 + t130 + t132 + t133) + t134);
  const T t136 = b1_80 * t135;
  const T t137 = omega1_1 * t115 - omega1_2 * t116 - omega1_3 * t118;
  const T t138 = omega1_3 * t115 - (omega1_2 * t118 + omega1_1 * t116);
  const T t139 = omega4_2 * t137 + omega4_3 * t138;
  const T t140 = T(0.5773502691896257) * t137;
  const T t141 = T(0.5773502691896257) * t138;
  const T t142 = thetadot4 * (t140 - t141);
  const T t143 = t139 - t142;
  const T t144 = t139 + t142;
  const T t145 = omega4_3 * t137;
  const T t146 = t145 + t145;
  const T t147 = omega1_2 * t115 - omega1_1 * t118 - omega1_3 * t116;
  const T t148 = omega4_1 * t147;
  const T t149 = t148 + t148;
  const T t150 = t146 + t149;
  const T t151 = omega4_2 * t138;
  const T t152 = t151 + t151;
  const T t153 = t152 + t149;
  const T t154 = omega4_1 * t137 + omega4_3 * t147;
  const T t155 = T(0.5773502691896257) * t147;
  const T t156 = thetadot4 * (t155 - t140);
  const T t157 = t154 + t156;
  const T t158 = omega4_1 * t138 + omega4_2 * t147;
  const T t159 = thetadot4 * (t141 - t155);
  const T t160 = t158 - t159;
  const T t161 = T(0.0079) * t143 - T(0.0079) * t144 - T(0.0021) * (t150 - t153) - T(0.0021) * t157 + T(0.0021) *
      t160;
  const T t162 = t154 - t156;
  const T t163 = t146 + t152;
  const T t164 = t158 + t159;
  const T t165 = T(0.0079) * t162 - T(0.0079) * t157 - T(0.0021) * (t153 - t163) - T(0.0021) * t164 + T(0.0021) *
      t143;
  const T t166 = T(0.0079) * t160 - T(0.0079) * t164 - T(0.0021) * (t163 - t150) - T(0.0021) * t144 + T(0.0021) *
      t162;
  const T t167 = z1_1 * t123;
  const T t168 = T(0.5773502691896257) * t161 + T(0.5773502691896257) * t165 + T(0.5773502691896257) * t166;
  const T t169 = b1_43 * t168;
  const T t170 = b1_19 * t115 - (t126 + E4_13 * t128 + b1_16 * t116 + E4_12 * t131) + E4_11 * t120 - b1_21 * t118;
  const T t171 = b1_48 * t170 - b1_50 * t135;
  const T t172 = T(4) * (t4_25 * t118 + t4_24 * t116 + t4_23 * t115);
  const T t173 = T(4) * (t4_24 * t118 - t4_25 * t115 - t4_23 * t116);
  const T t174 = T(4) * (t4_25 * t116 - t4_24 * t115 - t4_23 * t118);
  const T t175 = minus_G4_2 * t118 - E4_11 * t172 - minus_G4_1 * t115 - E4_12 * t173 + minus_G4_3 * t116 - E4_13 *
      t174;
  const T t176 = E4_11 * t161 - minus_N4_1 * t118 + E4_13 * t165 - minus_N4_2 * t116 + minus_N4_3 * t115 + E4_12 *
      t166 - T(0.2) * t175 + t167 - t169;
  const T t177 = E4_13 * t120;
  const T t178 = b1_16 * t115;
  const T t179 = E4_12 * t128;
  const T t180 = E4_11 * t131;
  const T t181 = b1_19 * t118;
  const T t182 = b1_21 * t116;
  const T t183 = t178 - (t126 + t179) - t180 - t181 + t177 - t182;
  const T t184 = t177 - (b1_47 * t171 + b1_51 * t183 + t124 + t125) - t182 - t179 + t178 - t180 - t181;
  const T t185 = b1_48 * t183 - b1_47 * t135;
  const T t186 = t13 * (t121 - (b1_47 * t185 + b1_49 * t183 + t124 + t125) + t134 - t129 - t130 - t132 - t133);
  const T t187 = b1_53 * t184 - b1_52 * t186;
  const T t188 = minus_G4_1 * t118 - (minus_G4_3 * t115 + E4_12 * t174) - E4_11 * t173 + minus_G4_2 * t116 - E4_13 *
      t172;
  const T t189 = T(0.2) * t188 + minus_N4_1 * t115 + E4_12 * t161 + E4_11 * t165 - minus_N4_2 * t118 + E4_13 * t166 -
      minus_N4_3 * t116 + t167 - t169 + z1_5 * t185 - b1_49 * t176;
  const T t190 = E4_13 * t161 - minus_N4_1 * t116 + minus_N4_2 * t115 + E4_12 * t165 + E4_11 * t166 - minus_N4_3 *
      t118 + t167 - t169 + z1_5 * t171 - b1_51 * t176 + z1_6 * t187 - b1_54 * t189;
  const T t191 = b1_81 * t183 - b1_47 * t136;
  const T t192 = b1_53 * t191 - b1_82 * t186;
  const T t193 = b1_52 * t192 + b1_83 * t184 - b1_81 * t170 + b1_50 * t136;
  const T t194 = t20 * (t121 - (b1_52 * t187 + b1_54 * t184 + b1_50 * t171 + b1_51 * t170 + t124 + t125 + t132 + t133)
      + t134 - t129 - t130);
  const T t195 = b1_57 * t193 - b1_84 * t194;
  const T t196 = h1_3 * t186;
  const T t197 = b1_55 * t184 - b1_52 * t196;
  const T t198 = h1_3 * t192 + b1_56 * t195 + b1_85 * t197;
  const T t199 = b1_57 * t197 - b1_56 * t194;
  const T t200 = t27 * (h1_3 * t196 - (b1_56 * t199 + b1_58 * t197));
  const T t201 = b1_72 * t198 - b1_86 * t200;
  const T t202 = b1_65 * t135;
  const T t203 = b1_66 * t183 - b1_47 * t202;
  const T t204 = b1_53 * t203 - b1_67 * t186;
  const T t205 = b1_66 * t170 - (b1_52 * t204 + b1_68 * t184) - b1_50 * t202;
  const T t206 = b1_57 * t205 - b1_69 * t194;
  const T t207 = b1_56 * t206 + b1_70 * t197 - h1_3 * t204;
  const T t208 = b1_67 * t192 - (b1_71 * t201 + b1_87 * t207 + b1_69 * t195 + b1_85 * t205) + b1_83 * t203 - b1_65 *
      t136;
  const T t209 = b1_72 * t207 - b1_71 * t200;
  const T t210 = t39 * (b1_65 * t202 - (b1_71 * t209 + b1_73 * t207 + b1_69 * t206 + b1_70 * t205 + b1_67 * t204 +
      b1_68 * t203));
  const T t211 = b1_91 * t208 - b1_90 * t210;
  const T t212 = t188 + b1_55 * t189 + z1_6 * t196 + z1_7 * t199 - b1_58 * t190;
  const T t213 = b1_70 * t190 - (z1_8 * t209 + b1_73 * t212 + z1_7 * t206) - z1_6 * t204 + b1_68 * t189 - z1_5 * t202
      - b1_66 * t176 + t175;
  const T t214 = z1_15 * (b1_85 * t190 - (z1_11 * t211 + b1_92 * t213 + z1_8 * t201 + b1_87 * t212 + z1_7 * t195) -
      minus_G4_2 * t115 - E4_12 * t172 + minus_G4_1 * t116 - E4_13 * t173 + minus_G4_3 * t118 - E4_11 * t174 + z1_5 *
      t136 + b1_81 * t176 + z1_6 * t192 - b1_83 * t189) - t53 * (b1_80 * t136 - (b1_90 * t211 + b1_92 * t208 + b1_86 *
      t201 + b1_87 * t198 + b1_84 * t195 + b1_85 * t193 + b1_82 * t192 + b1_83 * t191)) * z1_14;
  const T t215 = b1_91 * t213 - (z1_16 * t211 + b1_92 * t214) - z1_11 * t210;
  const T t216 = b1_72 * t212 - (z1_16 * t201 + b1_87 * t214 + z1_17 * t209 + b1_73 * t215) - z1_8 * t200;
  const T t217 = Pddot1_1 * t199 - (z1_16 * t195 + b1_85 * t214 + z1_17 * t206 + b1_70 * t215) + b1_58 * t216 - b1_57
      * t190 - z1_7 * t194;
  const T t218 = z1_16 * t192 + b1_83 * t214 - b1_53 * t189 - z1_6 * t186 - z1_18 * t187 - b1_54 * t217 - b1_55 * t216
      + Pddot1_1 * t196 - z1_17 * t204 - b1_68 * t215;
  const T t219 = z1_16 * t136 - b1_81 * t214 + b1_66 * t215 - z1_17 * t202 - b1_48 * t176 - z1_5 * t135 - z1_19 * t185
      - b1_49 * t218 - z1_18 * t171 - b1_51 * t217;
  S[167] = t219;
  const T t220 = T(1.2) * omega1_1;
  const T t221 = omega2_1 + omega2_1;
  const T t222 = T(9) * (E2_22 * t220 + t221);
  const T t223 = E2_23 * t220 * T(9);
  const T t224 = E2_23 * t222 - E2_22 * t223;
  const T t225 = omega4_2 * E4_12;
  const T t226 = omega4_3 * E4_13;
  const T t227 = t225 + t226;
  const T t228 = T(0.5773502691896257) * E4_12;
  const T t229 = T(0.5773502691896257) * E4_13;
  const T t230 = thetadot4 * (t228 - t229);
  const T t231 = t227 - t230;
  const T t232 = t227 + t230;
  const T t233 = omega4_3 * E4_12;
  const T t234 = t233 + t233;
  const T t235 = omega4_1 * E4_11;
  const T t236 = t235 + t235;
  const T t237 = t234 + t236;
  const T t238 = omega4_2 * E4_13;
  const T t239 = t238 + t238;
  const T t240 = t239 + t236;
  const T t241 = omega4_1 * E4_12;
  const T t242 = omega4_3 * E4_11;
  const T t243 = t241 + t242;
  const T t244 = T(0.5773502691896257) * E4_11;
  const T t245 = thetadot4 * (t244 - t228);
  const T t246 = t243 + t245;
  const T t247 = omega4_1 * E4_13;
  const T t248 = omega4_2 * E4_11;
  const T t249 = t247 + t248;
  const T t250 = thetadot4 * (t229 - t244);
  const T t251 = t249 - t250;
  const T t252 = T(0.0079) * t231 - T(0.0079) * t232 - T(0.0021) * (t237 - t240) - T(0.0021) * t246 + T(0.0021) *
      t251;
  const T t253 = t243 - t245;
  const T t254 = t234 + t239;
  const T t255 = t249 + t250;
  const T t256 = T(0.0079) * t253 - T(0.0079) * t246 - T(0.0021) * (t240 - t254) - T(0.0021) * t255 + T(0.0021) *
      t231;
  const T t257 = T(0.0079) * t251 - T(0.0079) * t255 - T(0.0021) * (t254 - t237) - T(0.0021) * t232 + T(0.0021) *
      t253;
  const T t258 = E3_23 * t220 * T(9);
  const T t259 = omega3_1 + omega3_1;
  const T t260 = T(9) * (t259 + E3_22 * t220);
  const T t261 = E3_22 * t258 - E3_23 * t260;
  const T t262 = T(0.4) * omega1_1;
  const T t263 = T(0.2) * omega1_3;
  const T t264 = E4_11 * t263;
  const T t265 = T(4) * (E4_13 * t262 - t264);
  const T t266 = E4_13 * t263;
  const T t267 = T(4) * (E4_12 * t262 - t266);
  const T t268 = E4_12 * t263;
  const T t269 = T(4) * (E4_11 * t262 - t268);
  const T t270 = E4_12 * t265 + E4_11 * t267 + E4_13 * t269;
  const T t271 = T(0.1) * omega1_2;
  const T t272 = T(0.5773502691896257) * t252 + T(0.5773502691896257) * t256 + T(0.5773502691896257) * t257;
  const T t273 = b1_43 * t272;
  const T t274 = T(0.6) * t224 - (E4_11 * t252 + E4_13 * t256 + E4_12 * t257) - t223 - T(0.6) * t261 - t258 - T(0.2) *
      t270 + t271 + t263 + t273 + b1_45 * t258 + b1_46 * t223;
  const T t275 = omega1_1 + omega1_1;
  const T t276 = T(0.75) * omega2_3;
  const T t277 = omega1_2 * T(0.6);
  const T t278 = T(9) * (omega2_2 + t277);
  const T t279 = T(2.25) * omega2_2 + t278;
  const T t280 = T(0.75) * omega3_3;
  const T t281 = T(9) * (t277 + omega3_2);
  const T t282 = t281 + T(2.25) * omega3_2;
  const T t283 = E4_11 * t265 + E4_13 * t267 + E4_12 * t269;
  const T t284 = T(2) * omega1_3 - T(0.1) * t275 + T(0.3) * omega1_2 - E4_12 * t252 - E4_11 * t256 - E4_13 * t257 +
      E2_22 * t276 - E2_23 * t279 + E3_22 * t280 - E3_23 * t282 + T(0.2) * t283 + t273 - b1_49 * t274;
  const T t285 = T(2) * omega1_2 - T(0.2) * t275 - T(0.3) * omega1_3 - E4_13 * t252 - E4_12 * t256 - E4_11 * t257 +
      E2_23 * t276 + E2_22 * t279 + T(0.6) * t278 + T(0.6) * t281 + E3_22 * t282 + E3_23 * t280 + t273 - b1_51 * t274
      - b1_54 * t284;
  const T t286 = t281 - t278 - t283 - b1_55 * t284 + b1_58 * t285;
  const T t287 = E2_22 * t222 - (E3_22 * t260 + E3_23 * t258) + E2_23 * t223 - t270 + b1_59 * t258 - b1_61 * t223 +
      b1_66 * t274 - b1_68 * t284 - b1_70 * t285 - b1_73 * t286;
  const T t288 = z1_15 * (t224 - (E4_13 * t265 + E4_12 * t267 + E4_11 * t269) + t261 - b1_74 * t258 + b1_76 * t223 -
      b1_81 * t274 + b1_83 * t284 - b1_85 * t285 - b1_87 * t286 - b1_92 * t287);
  const T t289 = b1_91 * t287 - b1_92 * t288;
  const T t290 = b1_72 * t286 - b1_73 * t289 - b1_87 * t288;
  const T t291 = b1_57 * t285 + b1_58 * t290 - b1_70 * t289 - b1_85 * t288;
  const T t292 = b1_53 * t284 - b1_54 * t291 - b1_55 * t290 - b1_68 * t289 + b1_83 * t288;
  const T t293 = b1_48 * t274 - b1_49 * t292 - b1_51 * t291 + b1_66 * t289 - b1_81 * t288;
  S[171] = t293;
  const T t294 = omega2_3 * E2_23;
  const T t295 = T(9) * (E2_23 * t2_5 + t294 + t294);
  const T t296 = omega2_3 * E2_22;
  const T t297 = t296 - omega2_2 * E2_23;
  const T t298 = T(9) * (t297 + E2_22 * t2_5);
  const T t299 = E2_23 * t295 + E2_22 * t298;
  const T t300 = t298 + T(3) * t297;
  const T t301 = omega3_3 * E3_23;
  const T t302 = T(9) * (t301 + t301 + E3_23 * t2_5);
  const T t303 = omega3_3 * E3_22;
  const T t304 = t303 - omega3_2 * E3_23;
  const T t305 = T(9) * (E3_22 * t2_5 + t304);
  const T t306 = E3_23 * t302 + E3_22 * t305;
  const T t307 = t305 + T(3) * t304;
  const T t308 = T(0.4) * omega1_2;
  const T t309 = T(4) * (E4_13 * t308 - t268);
  const T t310 = T(4) * (E4_12 * t308 - t264);
  const T t311 = T(4) * (E4_11 * t308 - t266);
  const T t312 = E4_12 * t309 + E4_11 * t310 + E4_13 * t311;
  const T t313 = t238 + t242;
  const T t314 = t313 - t250;
  const T t315 = t313 + t250;
  const T t316 = t226 + t226;
  const T t317 = t241 + t241;
  const T t318 = t316 + t317;
  const T t319 = t248 + t248;
  const T t320 = t319 + t317;
  const T t321 = t247 + t233;
  const T t322 = t321 + t230;
  const T t323 = t235 + t225;
  const T t324 = t323 - t245;
  const T t325 = T(0.0079) * t314 - T(0.0079) * t315 - T(0.0021) * (t318 - t320) - T(0.0021) * t322 + T(0.0021) *
      t324;
  const T t326 = t321 - t230;
  const T t327 = t316 + t319;
  const T t328 = t323 + t245;
  const T t329 = T(0.0079) * t326 - T(0.0079) * t322 - T(0.0021) * (t320 - t327) - T(0.0021) * t328 + T(0.0021) *
      t314;
  const T t330 = T(0.0079) * t324 - T(0.0079) * t328 - T(0.0021) * (t327 - t318) - T(0.0021) * t315 + T(0.0021) *
      t326;
  const T t331 = omega1_2 + omega1_2;
  const T t332 = T(0.5773502691896257) * t325 + T(0.5773502691896257) * t329 + T(0.5773502691896257) * t330;
  const T t333 = b1_43 * t332;
  const T t334 = T(0.1) * omega1_1 - (T(0.6) * t299 + t300 + T(0.6) * t306 + t307 + T(0.2) * t312 + E4_11 * t325 +
      E4_13 * t329 + E4_12 * t330 + T(4) * omega1_3 + T(0.3) * t331) + t333 + b1_45 * t307 + b1_46 * t300;
  const T t335 = T(0.3) * omega1_1;
  const T t336 = thetadot2 * E2_23;
  const T t337 = omega2_1 * E2_23;
  const T t338 = T(0.75) * (t336 - t337);
  const T t339 = omega2_1 * E2_22;
  const T t340 = thetadot2 * E2_22;
  const T t341 = T(0.75) * (t339 - t340);
  const T t342 = t339 + t340;
  const T t343 = T(9) * (t342 + t2_4);
  const T t344 = t341 - T(3) * t342 - t343;
  const T t345 = thetadot3 * E3_23;
  const T t346 = omega3_1 * E3_23;
  const T t347 = T(0.75) * (t345 - t346);
  const T t348 = omega3_1 * E3_22;
  const T t349 = thetadot3 * E3_22;
  const T t350 = t348 + t349;
  const T t351 = T(0.75) * (t348 - t349);
  const T t352 = T(9) * (t2_4 + t350);
  const T t353 = T(3) * t350 - t351 + t352;
  const T t354 = E4_11 * t309 + E4_13 * t310 + E4_12 * t311;
  const T t355 = t335 - t263 - E4_12 * t325 - E4_11 * t329 - E4_13 * t330 + E2_22 * t338 + E2_23 * t344 + E3_22 * t347
      - E3_23 * t353 + T(0.2) * t354 + t333 - b1_49 * t334;
  const T t356 = T(2) * omega1_1;
  const T t357 = t356 + T(0.2) * t331 - T(0.1) * omega1_3 - E4_13 * t325 - E4_12 * t329 - E4_11 * t330 + E2_23 * t338
      - E2_22 * t344 + T(0.6) * t343 + T(0.6) * t352 + E3_22 * t353 + E3_23 * t347 + t333 - b1_51 * t334 - b1_54 *
      t355;
  const T t358 = t352 - t343 - t354 - b1_55 * t355 + b1_58 * t357;
  const T t359 = E2_23 * t298 - E2_22 * t295 + E3_22 * t302 - E3_23 * t305 - t312 + b1_59 * t307 - b1_61 * t300 +
      b1_66 * t334 - b1_68 * t355 - b1_70 * t357 - b1_73 * t358;
  const T t360 = z1_15 * (t306 - (E4_13 * t309 + E4_12 * t310 + E4_11 * t311) - t299 - b1_74 * t307 + b1_76 * t300 -
      b1_81 * t334 + b1_83 * t355 - b1_85 * t357 - b1_87 * t358 - b1_92 * t359);
  const T t361 = b1_91 * t359 - b1_92 * t360;
  const T t362 = b1_72 * t358 - b1_73 * t361 - b1_87 * t360;
  const T t363 = b1_57 * t357 + b1_58 * t362 - b1_70 * t361 - b1_85 * t360;
  const T t364 = b1_53 * t355 - b1_54 * t363 - b1_55 * t362 - b1_68 * t361 + b1_83 * t360;
  const T t365 = b1_48 * t334 - b1_49 * t364 - b1_51 * t363 + b1_66 * t361 - b1_81 * t360;
  S[172] = t365;
  const T t366 = omega1_3 + omega1_3;
  const T t367 = t248 + t233;
  const T t368 = t367 - t245;
  const T t369 = t367 + t245;
  const T t370 = t242 + t242;
  const T t371 = t247 + t247;
  const T t372 = t370 + t371;
  const T t373 = t225 + t225;
  const T t374 = t373 + t371;
  const T t375 = t235 + t226;
  const T t376 = t375 + t250;
  const T t377 = t241 + t238;
  const T t378 = t377 - t230;
  const T t379 = T(0.0079) * t368 - T(0.0079) * t369 - T(0.0021) * (t372 - t374) - T(0.0021) * t376 + T(0.0021) *
      t378;
  const T t380 = t375 - t250;
  const T t381 = t370 + t373;
  const T t382 = t377 + t230;
  const T t383 = T(0.0079) * t380 - T(0.0079) * t376 - T(0.0021) * (t374 - t381) - T(0.0021) * t382 + T(0.0021) *
      t368;
  const T t384 = T(0.0079) * t378 - T(0.0079) * t382 - T(0.0021) * (t381 - t372) - T(0.0021) * t369 + T(0.0021) *
      t380;
  const T t385 = T(1.2) * omega1_3;
  const T t386 = T(9) * (E2_23 * t277 - (t296 + t296) - E2_22 * t385);
  const T t387 = omega2_2 * E2_22 + t294;
  const T t388 = T(9) * (t387 + E2_23 * t385 + E2_22 * t277);
  const T t389 = E2_23 * t386 + E2_22 * t388;
  const T t390 = t388 + T(3) * t387;
  const T t391 = omega3_2 * E3_22 + t301;
  const T t392 = T(9) * (E3_23 * t385 + E3_22 * t277 + t391);
  const T t393 = T(9) * (t303 + t303 + E3_22 * t385 - E3_23 * t277);
  const T t394 = E3_22 * t392 - E3_23 * t393;
  const T t395 = t392 + T(3) * t391;
  const T t396 = T(4) * (E4_12 * t4_22 + E4_11 * t4_21);
  const T t397 = T(4) * (E4_11 * t4_22 + E4_13 * t4_21);
  const T t398 = T(4) * (E4_13 * t4_22 + E4_12 * t4_21);
  const T t399 = E4_12 * t396 + E4_11 * t397 + E4_13 * t398;
  const T t400 = T(0.5773502691896257) * t379 + T(0.5773502691896257) * t383 + T(0.5773502691896257) * t384;
  const T t401 = b1_43 * t400;
  const T t402 = T(0.3) * t366 - T(4) * omega1_2 + t4_21 - E4_11 * t379 - E4_13 * t383 - E4_12 * t384 - T(0.6) * t389
      - t390 - T(0.6) * t394 - t395 + T(0.2) * t399 + t401 + b1_45 * t395 + b1_46 * t390;
  const T t403 = t337 + t336;
  const T t404 = t338 + T(12) * t403;
  const T t405 = t346 + t345;
  const T t406 = T(12) * t405 + t347;
  const T t407 = E4_11 * t396 + E4_13 * t397 + E4_12 * t398;
  const T t408 = t356 + T(0.1) * t366 - t4_22 - E4_12 * t379 - E4_11 * t383 - E4_13 * t384 + E2_22 * t341 - E2_23 *
      t404 + E3_22 * t351 - E3_23 * t406 - T(0.2) * t407 + t401 - b1_49 * t402;
  const T t409 = T(9) * t403;
  const T t410 = T(9) * t405;
  const T t411 = E2_23 * t341 - (t335 + t271 + E4_13 * t379 + E4_12 * t383 + E4_11 * t384) + E2_22 * t404 + T(0.6) *
      t409 + T(0.6) * t410 + E3_22 * t406 + E3_23 * t351 + t401 - b1_51 * t402 - b1_54 * t408;
  const T t412 = t410 - t409 + t407 - b1_55 * t408 + b1_58 * t411;
  const T t413 = E2_23 * t388 - (E3_22 * t393 + E3_23 * t392) - E2_22 * t386 + t399 + b1_59 * t395 - b1_61 * t390 +
      b1_66 * t402 - b1_68 * t408 - b1_70 * t411 - b1_73 * t412;
  const T t414 = z1_15 * (t394 - t389 + E4_13 * t396 + E4_12 * t397 + E4_11 * t398 - b1_74 * t395 + b1_76 * t390 -
      b1_81 * t402 + b1_83 * t408 - b1_85 * t411 - b1_87 * t412 - b1_92 * t413);
  const T t415 = b1_91 * t413 - b1_92 * t414;
  const T t416 = b1_72 * t412 - b1_73 * t415 - b1_87 * t414;
  const T t417 = b1_57 * t411 + b1_58 * t416 - b1_70 * t415 - b1_85 * t414;
  const T t418 = b1_53 * t408 - b1_54 * t417 - b1_55 * t416 - b1_68 * t415 + b1_83 * t414;
  const T t419 = b1_48 * t402 - b1_49 * t418 - b1_51 * t417 + b1_66 * t415 - b1_81 * t414;
  S[173] = t419;
  const T t420 = T(9) * t221;
  const T t421 = E2_23 * t420;
  const T t422 = T(0.6) * t421 + b1_46 * c.p.c;
  const T t423 = omega2_2 + omega2_2;
  const T t424 = T(12) * t423;
  const T t425 = E2_23 * t424 + b1_49 * t422;
  const T t426 = T(9) * t423;
  const T t427 = E2_22 * t424 + T(0.6) * t426 - b1_51 * t422 + b1_54 * t425;
  const T t428 = b1_55 * t425 - t426 + b1_58 * t427;
  const T t429 = E2_22 * t420 - b1_61 * c.p.c + b1_66 * t422 + b1_68 * t425 - b1_70 * t427 - b1_73 * t428;
  const T t430 = z1_15 * (t421 + b1_76 * c.p.c - b1_81 * t422 - b1_83 * t425 - b1_85 * t427 - b1_87 * t428 - b1_92 *
      t429);
  const T t431 = b1_91 * t429 - b1_92 * t430;
  const T t432 = b1_72 * t428 - b1_73 * t431 - b1_87 * t430;
  const T t433 = b1_57 * t427 + b1_58 * t432 - b1_70 * t431 - b1_85 * t430;
  const T t434 = b1_83 * t430 - (b1_53 * t425 + b1_54 * t433 + b1_55 * t432 + b1_68 * t431);
  const T t435 = b1_48 * t422 - b1_49 * t434 - b1_51 * t433 + b1_66 * t431 - b1_81 * t430;
  S[174] = t435;
  const T t436 = T(9) * t259;
  const T t437 = E3_23 * t436;
  const T t438 = T(0.6) * t437 + b1_45 * c.p.c;
  const T t439 = omega3_2 + omega3_2;
  const T t440 = T(12) * t439;
  const T t441 = E3_23 * t440 + b1_49 * t438;
  const T t442 = T(9) * t439;
  const T t443 = E3_22 * t440 + T(0.6) * t442 - b1_51 * t438 + b1_54 * t441;
  const T t444 = t442 + b1_55 * t441 + b1_58 * t443;
  const T t445 = b1_59 * c.p.c - E3_22 * t436 + b1_66 * t438 + b1_68 * t441 - b1_70 * t443 - b1_73 * t444;
  const T t446 = z1_15 * (b1_83 * t441 + t437 + b1_74 * c.p.c + b1_81 * t438 + b1_85 * t443 + b1_87 * t444 + b1_92 *
      t445);
  const T t447 = b1_91 * t445 + b1_92 * t446;
  const T t448 = b1_72 * t444 - b1_73 * t447 + b1_87 * t446;
  const T t449 = b1_57 * t443 + b1_58 * t448 - b1_70 * t447 + b1_85 * t446;
  const T t450 = b1_53 * t441 + b1_54 * t449 + b1_55 * t448 + b1_68 * t447 + b1_83 * t446;
  const T t451 = b1_48 * t438 + b1_49 * t450 - b1_51 * t449 + b1_66 * t447 + b1_81 * t446;
  S[175] = t451;
  const T t452 = omega4_2 * T(0.5773502691896257);
  const T t453 = omega4_3 * T(0.5773502691896257);
  const T t454 = t452 + t453;
  const T t455 = t454 - t4_11;
  const T t456 = t454 + t4_11;
  const T t457 = T(1.1547005383792515) * omega4_3;
  const T t458 = T(1.1547005383792515) * omega4_1;
  const T t459 = t457 + t458;
  const T t460 = T(1.1547005383792515) * omega4_2;
  const T t461 = t460 + t458;
  const T t462 = omega4_1 * T(0.5773502691896257);
  const T t463 = t462 + t453;
  const T t464 = t463 + t4_13;
  const T t465 = t462 + t452;
  const T t466 = t465 - t4_14;
  const T t467 = T(0.0079) * t455 - T(0.0079) * t456 - T(0.0021) * (t459 - t461) - T(0.0021) * t464 + T(0.0021) *
      t466;
  const T t468 = t463 - t4_13;
  const T t469 = t457 + t460;
  const T t470 = t465 + t4_14;
  const T t471 = T(0.0079) * t468 - T(0.0079) * t464 - T(0.0021) * (t461 - t469) - T(0.0021) * t470 + T(0.0021) *
      t455;
  const T t472 = T(0.0079) * t466 - T(0.0079) * t470 - T(0.0021) * (t469 - t459) - T(0.0021) * t456 + T(0.0021) *
      t468;
  const T t473 = T(0.5773502691896257) * t467 + T(0.5773502691896257) * t471 + T(0.5773502691896257) * t472;
  const T t474 = b1_43 * t473;
  const T t475 = t474 - (E4_11 * t467 + E4_13 * t471 + E4_12 * t472);
  const T t476 = t474 - (E4_12 * t467 + E4_11 * t471 + E4_13 * t472) - b1_49 * t475;
  const T t477 = t474 - (E4_13 * t467 + E4_12 * t471 + E4_11 * t472) - b1_51 * t475 - b1_54 * t476;
  const T t478 = b1_58 * t477 - b1_55 * t476;
  const T t479 = b1_66 * t475 - b1_68 * t476 - b1_70 * t477 - b1_73 * t478;
  const T t480 = z1_15 * (b1_83 * t476 - b1_81 * t475 - b1_85 * t477 - b1_87 * t478 - b1_92 * t479);
  const T t481 = b1_91 * t479 - b1_92 * t480;
  const T t482 = b1_72 * t478 - b1_73 * t481 - b1_87 * t480;
  const T t483 = b1_57 * t477 + b1_58 * t482 - b1_70 * t481 - b1_85 * t480;
  const T t484 = b1_53 * t476 - b1_54 * t483 - b1_55 * t482 - b1_68 * t481 + b1_83 * t480;
  const T t485 = b1_48 * t475 - b1_49 * t484 - b1_51 * t483 + b1_66 * t481 - b1_81 * t480;
  S[176] = t485;
  S[183] = t58;
  S[184] = t111;
  S[185] = t218;
  S[189] = t292;
  S[190] = t364;
  S[191] = t418;
  S[192] = t434;
  S[193] = -t450;
  S[194] = t484;
  S[201] = t57;
  S[202] = t110;
  S[203] = t217;
  S[207] = t291;
  S[208] = t363;
  S[209] = t417;
  S[210] = t433;
  S[211] = t449;
  S[212] = t483;
  S[219] = z1_16 * b1_61 - b1_76 * t54 + z1_17 * b1_76 + b1_61 * t55 - T(0.08333333333333333) * t11 - b1_46 * t59 +
      omegadot1_1 * t2;
  S[220] = -(b1_46 * t112 - b1_61 * t108 + b1_76 * t107);
  S[221] = -(b1_46 * t219 - b1_61 * t215 + b1_76 * t214);
  S[225] = b1_61 * t289 - (T(0.08333333333333333) * t223 + b1_46 * t293) - b1_76 * t288;
  S[226] = b1_61 * t361 - (T(0.08333333333333333) * t300 + b1_46 * t365) - b1_76 * t360;
  S[227] = b1_61 * t415 - (T(0.08333333333333333) * t390 + b1_46 * t419) - b1_76 * t414;
  S[228] = b1_61 * t431 - (c.c0_1 + b1_46 * t435) - b1_76 * t430;
  S[229] = -(b1_46 * t451 - b1_61 * t447 - b1_76 * t446);
  S[230] = -(b1_46 * t485 - b1_61 * t481 + b1_76 * t480);
  S[237] = -(b1_45 * t59 + b1_59 * t55 - b1_74 * t54);
  S[238] = -(T(0.08333333333333333) * t72 + b1_45 * t112 - omegadot1_1 * t61 + z1_17 * b1_74 + b1_59 * t108 + z1_16 *
      b1_59 - b1_74 * t107);
  S[239] = -(b1_45 * t219 + b1_59 * t215 - b1_74 * t214);
  S[243] = -(T(0.08333333333333333) * t258 + b1_45 * t293 + b1_59 * t289 - b1_74 * t288);
  S[244] = -(T(0.08333333333333333) * t307 + b1_45 * t365 + b1_59 * t361 - b1_74 * t360);
  S[245] = -(T(0.08333333333333333) * t395 + b1_45 * t419 + b1_59 * t415 - b1_74 * t414);
  S[246] = -(b1_45 * t435 + b1_59 * t431 - b1_74 * t430);
  S[247] = -(b1_74 * t446 + c.c0_1 + b1_45 * t451 + b1_59 * t447);
  S[248] = -(b1_45 * t485 + b1_59 * t481 - b1_74 * t480);
  S[255] = -(b1_43 * t59 + b1_43 * t58 + b1_43 * t57);
  S[256] = -(b1_43 * t112 + b1_43 * t111 + b1_43 * t110);
  S[257] = -(T(50) * t168 + omegadot1_1 * t123 + b1_43 * t219 + z1_19 * t123 + b1_43 * t218 + z1_18 * t123 + b1_43 *
      t217);
  S[261] = -(T(50) * t272 + b1_43 * t293 + b1_43 * t292 + b1_43 * t291);
  S[262] = -(T(50) * t332 + b1_43 * t365 + b1_43 * t364 + b1_43 * t363);
  S[263] = -(T(50) * t400 + b1_43 * t419 + b1_43 * t418 + b1_43 * t417);
  S[264] = -(b1_43 * t435 + b1_43 * t434 + b1_43 * t433);
  S[265] = -(b1_43 * t451 - b1_43 * t450 + b1_43 * t449);
  S[266] = -(T(50) * t473 + b1_43 * t485 + b1_43 * t484 + b1_43 * t483);
  const T t486 = T(0.5) * eps1_2;
  const T t487 = T(2) * t486;
  const T t488 = eps1_3 * t487;
  const T t489 = t1_3 * t486;
  const T t490 = t488 + t489;
  const T t491 = T(0.5) * eps1_3;
  const T t492 = T(2) * t491;
  const T t493 = eps1_2 * t492;
  const T t494 = t1_1 * t491;
  const T t495 = t493 + t494;
  const T t496 = T(0.5) * eps1_4;
  const T t497 = T(2) * t496;
  const T t498 = eps1_2 * t497;
  const T t499 = t1_5 * t491;
  const T t500 = t498 + t499;
  const T t501 = eps1_4 * t487;
  const T t502 = T(0.5) * eps1_1;
  const T t503 = t1_3 * t502;
  const T t504 = t501 + t503;
  const T t505 = eps1_3 * t497;
  const T t506 = t1_5 * t486;
  const T t507 = t505 - t506;
  const T t508 = eps1_4 * t492;
  const T t509 = t1_1 * t502;
  const T t510 = t508 - t509;
  S[270] = Pddot1_1 * (t490 - t495) + z1_17 * (t500 + t504) + z1_16 * (t507 + t510);
  const T t511 = t1_5 * t496;
  const T t512 = t511 - t493;
  const T t513 = T(2) * t502;
  const T t514 = eps1_4 * t513;
  const T t515 = t514 - t489;
  const T t516 = t1_1 * t496;
  const T t517 = t498 + t516;
  const T t518 = eps1_3 * t513;
  const T t519 = t518 + t503;
  const T t520 = t1_5 * t502;
  const T t521 = eps1_3 * t492;
  const T t522 = t520 - t521;
  const T t523 = eps1_4 * t497;
  const T t524 = t1_1 * t486;
  const T t525 = t523 - t524;
  S[271] = z1_17 * (t512 - t515) - Pddot1_1 * (t517 + t519) + z1_16 * (t522 + t525);
  const T t526 = eps1_2 * t513 + t509;
  const T t527 = t505 + t1_3 * t496;
  const T t528 = eps1_2 * t487 - t520;
  const T t529 = t523 - t1_3 * t491;
  const T t530 = t488 + t511;
  const T t531 = t514 + t494;
  S[272] = Pddot1_1 * (t526 - t527) + z1_17 * (t528 - t529) + z1_16 * (t530 - t531);
  S[273] = R1_11 * t56 + R1_21 * t55 + R1_31 * t54;
  S[274] = R1_11 * t109 + R1_21 * t108 + R1_31 * t107;
  S[275] = R1_11 * t216 + R1_21 * t215 + R1_31 * t214;
  S[279] = R1_11 * t290 + R1_21 * t289 + R1_31 * t288;
  S[280] = R1_11 * t362 + R1_21 * t361 + R1_31 * t360;
  S[281] = R1_11 * t416 + R1_21 * t415 + R1_31 * t414;
  S[282] = R1_11 * t432 + R1_21 * t431 + R1_31 * t430;
  S[283] = R1_11 * t448 + R1_21 * t447 - R1_31 * t446;
  S[284] = R1_11 * t482 + R1_21 * t481 + R1_31 * t480;
  const T t532 = eps1_1 * t497 + t511;
  const T t533 = t521 - t524;
  const T t534 = t523 - t520;
  S[288] = Pddot1_1 * (t500 - t504) + z1_17 * (t490 - t532) + z1_16 * (t533 - t534);
  const T t535 = eps1_1 * t492 + t499;
  const T t536 = t505 + t509;
  const T t537 = t508 + t506;
  S[289] = Pddot1_1 * (t512 + t515) + z1_17 * (t535 - t519) + z1_16 * (t536 + t537);
  const T t538 = eps1_1 * t487 + t506;
  const T t539 = t516 - t518;
  const T t540 = t501 - t499;
  S[290] = Pddot1_1 * (t528 + t529) - z1_17 * (t538 + t527) + z1_16 * (t539 - t540);
  S[291] = R1_12 * t56 + R1_22 * t55 + R1_32 * t54;
  S[292] = R1_12 * t109 + R1_22 * t108 + R1_32 * t107;
  S[293] = R1_12 * t216 + R1_22 * t215 + R1_32 * t214;
  S[297] = R1_12 * t290 + R1_22 * t289 + R1_32 * t288;
  S[298] = R1_12 * t362 + R1_22 * t361 + R1_32 * t360;
  S[299] = R1_12 * t416 + R1_22 * t415 + R1_32 * t414;
  S[300] = R1_12 * t432 + R1_22 * t431 + R1_32 * t430;
  S[301] = R1_12 * t448 + R1_22 * t447 - R1_32 * t446;
  S[302] = R1_12 * t482 + R1_22 * t481 + R1_32 * t480;
  S[306] = Pddot1_1 * (t507 - t510) + z1_17 * (t533 + t534) - z1_16 * (t532 + t495);
  S[307] = Pddot1_1 * (t522 - t525) + z1_17 * (t536 - t537) + z1_16 * (t535 - t517);
  S[308] = Pddot1_1 * (t530 + t531) + z1_17 * (t539 + t540) + z1_16 * (t526 - t538);
  S[309] = R1_13 * t56 + R1_23 * t55 + R1_33 * t54;
  S[310] = R1_13 * t109 + R1_23 * t108 + R1_33 * t107;
  S[311] = R1_13 * t216 + R1_23 * t215 + R1_33 * t214;
  S[315] = R1_13 * t290 + R1_23 * t289 + R1_33 * t288;
  S[316] = R1_13 * t362 + R1_23 * t361 + R1_33 * t360;
  S[317] = R1_13 * t416 + R1_23 * t415 + R1_33 * t414;
  S[318] = R1_13 * t432 + R1_23 * t431 + R1_33 * t430;
  S[319] = R1_13 * t448 + R1_23 * t447 - R1_33 * t446;
  S[320] = R1_13 * t482 + R1_23 * t481 + R1_33 * t480;
}

// input_matrix: rates of (xi, y) for small changes of the inputs.
// B (2 ny x n_inputs)
// 175 add, 221 multiply, 6 divide, 6 sine or cosine
template <class T>
void input_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, [[maybe_unused]] const T* y, [[maybe_unused]]
    const Inputs<T>& u, T* B) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 36; ++i) B[i] = T(0);

  // ---- body 1 (hub) on the inertial frame
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

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);

  // ---- body 4 (wheel) on body 1
  const T theta4 = x[6];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cos(theta4);
  const T E4_11 = t4_1 * T(0.6666666666666666) + T(0.3333333333333334);
  const T t4_2 = sin(theta4) * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;

  // ---- body 3 (right_panel) and what it carries
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc3_2 = E3_22 * T(9);
  const T minus_hc3_3 = E3_23 * T(9);

  // ---- body 2 (left_panel) and what it carries
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_2 = E2_22 * T(9);
  const T hc2_3 = E2_23 * T(9);

  // ---- body 1 (hub) and what it carries
  // h1 = m2 q2 + m3 q3 + m4 q4 + hc2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h1_2 = hc2_2 - minus_hc3_2;
  const T h1_3 = hc2_3 - T(0.8) - minus_hc3_3;
  // J1 = -q2~ hc2~ + E2^T J2 E2 - q3~ hc3~ + E3^T J3 E3 + E4^T I4 E4 + I1 + (-m2 q2~ - hc2~) q2~ + (-m3 q3~ - hc3~)
  //   q3~ - m4 q4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b1_1 = T(0.6) * hc2_2;
  const T b1_2 = b1_1 + T(12);
  const T b1_3 = T(0.6) * minus_hc3_2;
  const T b1_4 = b1_3 + (T(5.3999999999999995) + hc2_2) * T(0.6) + (T(5.3999999999999995) + minus_hc3_2) * T(0.6);
  const T b1_5 = E4_13 * T(0.0021);
  const T b1_6 = E4_12 * T(0.0021);
  const T b1_7 = E4_11 * T(0.0158) + b1_5 + b1_6;
  const T b1_8 = b1_7 * E4_11;
  const T b1_9 = E4_11 * T(0.0021);
  const T b1_10 = b1_6 + b1_9 + E4_13 * T(0.0158);
  const T b1_11 = b1_10 * E4_13;
  const T b1_12 = b1_5 + b1_9 + E4_12 * T(0.0158);
  const T b1_13 = b1_12 * E4_12;
  const T J1_11 = b1_2 + b1_4 + T(28.16) + b1_8 + b1_11 + b1_13;
  const T b1_14 = b1_7 * E4_12;
  const T b1_15 = b1_10 * E4_11;
  const T b1_16 = b1_12 * E4_13;
  const T J1_12 = b1_14 + b1_15 + b1_16 + T(0.2);
  const T J1_13 = b1_7 * E4_13 + b1_10 * E4_12 + b1_12 * E4_11 - T(0.1);
  const T b1_17 = E2_22 * T(0.75);
  const T b1_18 = E2_23 * T(12.75);
  const T b1_19 = E3_22 * T(0.75);
  const T b1_20 = E3_23 * T(12.75);
  const T J1_22 = b1_17 * E2_22 + b1_18 * E2_23 + b1_19 * E3_22 + b1_20 * E3_23 + b1_13 + b1_8 + b1_11 + T(14.16);
  const T J1_32 = b1_17 * E2_23 - b1_18 * E2_22 - T(0.6) * hc2_3 - T(0.6) * minus_hc3_3 + b1_19 * E3_23 - b1_20 *
      E3_22 + b1_16 + b1_14 + b1_15 + T(0.3);
  const T J1_33 = E2_23 * T(0.75) * E2_23 + E2_22 * T(12.75) * E2_22 + b1_1 + b1_4 + E3_23 * T(0.75) * E3_23 + E3_22 *
      T(12.75) * E3_22 + b1_11 + b1_13 + b1_8 + T(18);
  // K_thetadot4_1 = E4^T K_thetadot4_4
  const T K_thetadot4_1_1 = E4_11 * T(0.011547005383792516) + E4_13 * T(0.011547005383792516) + E4_12 *
      T(0.011547005383792516);
  // K_thetadot3_1 = q3~ E3^T B_thetadot3_3 + E3^T K_thetadot3_3
  const T K_thetadot3_1_1 = b1_3 + T(12);
  // D_omegadot1: pivots of L D L^T
  const T b1_21 = K_thetadot4_1_1 * T(50);
  const T b1_22 = b1_21 * K_thetadot4_1_1;
  const T b1_23 = K_thetadot3_1_1 * T(0.08333333333333333);
  const T b1_24 = b1_2 * T(0.08333333333333333);
  const T D_omegadot1_1 = J1_11 - b1_22 - b1_23 * K_thetadot3_1_1 - b1_24 * b1_2;
  const T b1_25 = J1_12 - b1_22;
  const T b1_26 = T(1) / D_omegadot1_1;
  const T b1_27 = b1_25 * b1_26;
  const T D_omegadot1_2 = J1_22 - b1_22 - b1_27 * b1_25;
  const T b1_28 = J1_13 - b1_22;
  const T b1_29 = b1_28 * b1_26;
  const T b1_30 = J1_32 - b1_22 - b1_29 * b1_25;
  const T b1_31 = T(1) / D_omegadot1_2;
  const T b1_32 = b1_30 * b1_31;
  const T D_omegadot1_3 = J1_33 - b1_22 - b1_29 * b1_28 - b1_32 * b1_30;
  // D_Pddot1: pivots of L D L^T
  const T b1_33 = h1_3 * b1_31;
  const T b1_34 = h1_2 + b1_33 * b1_30;
  const T b1_35 = T(1) / D_omegadot1_3;
  const T b1_36 = b1_34 * b1_35;
  const T D_Pddot1_1 = T(142) - b1_33 * h1_3 - b1_36 * b1_34;
  const T b1_37 = minus_hc3_3 * T(0.08333333333333333);
  const T b1_38 = hc2_3 * T(0.08333333333333333);
  const T b1_39 = h1_3 + b1_37 * K_thetadot3_1_1 - b1_38 * b1_2;
  const T b1_40 = b1_39 * b1_26;
  const T b1_41 = b1_40 * b1_25;
  const T b1_42 = b1_41 * b1_31;
  const T b1_43 = b1_40 * b1_28 - b1_42 * b1_30;
  const T b1_44 = b1_43 * b1_35;
  const T b1_45 = b1_44 * b1_34 - b1_42 * h1_3;
  const T b1_46 = T(1) / D_Pddot1_1;
  const T b1_47 = b1_45 * b1_46;
  const T D_Pddot1_2 = T(142) - b1_37 * minus_hc3_3 - b1_38 * hc2_3 - b1_40 * b1_39 - b1_42 * b1_41 - b1_44 * b1_43 -
      b1_47 * b1_45;
  const T b1_48 = minus_hc3_2 * T(0.08333333333333333);
  const T b1_49 = hc2_2 * T(0.08333333333333333);
  const T b1_50 = h1_2 + b1_48 * K_thetadot3_1_1 - b1_49 * b1_2;
  const T b1_51 = b1_50 * b1_26;
  const T b1_52 = b1_51 * b1_25;
  const T b1_53 = b1_52 * b1_31;
  const T b1_54 = b1_53 * b1_30 - b1_51 * b1_28;
  const T b1_55 = b1_54 * b1_35;
  const T b1_56 = b1_53 * h1_3 + b1_55 * b1_34;
  const T b1_57 = b1_56 * b1_46;
  const T b1_58 = b1_48 * minus_hc3_3 + b1_49 * hc2_3 + b1_51 * b1_39 + b1_53 * b1_41 - b1_55 * b1_43 - b1_57 * b1_45;
  const T b1_59 = T(1) / D_Pddot1_2;
  const T b1_60 = b1_58 * b1_59;
  const T D_Pddot1_3 = T(142) - b1_48 * minus_hc3_2 - b1_49 * hc2_2 - b1_51 * b1_50 - b1_53 * b1_52 - b1_55 * b1_54 -
      b1_57 * b1_56 - b1_60 * b1_58;

  // ---- results
  const T t1 = b1_27 * b1_21 - b1_21;
  const T t2 = b1_29 * b1_21 - b1_21 - b1_32 * t1;
  const T t3 = b1_36 * t2 - b1_33 * t1;
  const T t4 = b1_40 * b1_21 + b1_42 * t1 + b1_44 * t2 + b1_47 * t3;
  const T t5 = T(1) / D_Pddot1_3;
  const T t6 = t5 * (b1_51 * b1_21 + b1_53 * t1 - b1_55 * t2 - b1_57 * t3 + b1_60 * t4);
  const T t7 = b1_59 * t4 + b1_60 * t6;
  const T t8 = b1_46 * t3 + b1_47 * t7 - b1_57 * t6;
  const T t9 = b1_35 * t2 + b1_36 * t8 + b1_44 * t7 - b1_55 * t6;
  const T t10 = b1_31 * t1 - b1_32 * t9 - b1_33 * t8 + b1_42 * t7 + b1_53 * t6;
  const T t11 = b1_26 * b1_21 + b1_27 * t10 + b1_29 * t9 + b1_40 * t7 + b1_51 * t6;
  B[18] = -t11;
  const T t12 = T(1) - b1_36 * T(0.1);
  const T t13 = b1_44 * T(0.1) - b1_47 * t12;
  const T t14 = t5 * (b1_55 * T(0.1) - b1_57 * t12 - b1_60 * t13);
  const T t15 = b1_59 * t13 - b1_60 * t14;
  const T t16 = b1_46 * t12 - b1_47 * t15 - b1_57 * t14;
  const T t17 = b1_36 * t16 - b1_35 * T(0.1) - b1_44 * t15 - b1_55 * t14;
  const T t18 = b1_53 * t14 - (b1_32 * t17 + b1_33 * t16 + b1_42 * t15);
  const T t19 = b1_40 * t15 - (b1_27 * t18 + b1_29 * t17) - b1_51 * t14;
  B[19] = t19;
  B[20] = t10;
  B[21] = t18;
  B[22] = t9;
  B[23] = t17;
  B[24] = b1_24 * t11 - b1_38 * t7 - b1_49 * t6;
  B[25] = -(b1_24 * t19 - b1_38 * t15 + b1_49 * t14);
  B[26] = b1_23 * t11 + b1_37 * t7 + b1_48 * t6;
  B[27] = -(b1_23 * t19 + b1_37 * t15 - b1_48 * t14);
  B[28] = T(50) + b1_21 * t11 - b1_21 * t10 - b1_21 * t9;
  B[29] = -(b1_21 * t19 + b1_21 * t18 + b1_21 * t17);
  B[30] = R1_11 * t8 - R1_21 * t7 + R1_31 * t6;
  B[31] = R1_11 * t16 + R1_21 * t15 + R1_31 * t14;
  B[32] = R1_12 * t8 - R1_22 * t7 + R1_32 * t6;
  B[33] = R1_12 * t16 + R1_22 * t15 + R1_32 * t14;
  B[34] = R1_13 * t8 - R1_23 * t7 + R1_33 * t6;
  B[35] = R1_13 * t16 + R1_23 * t15 + R1_33 * t14;
}

// tip_position: position of tip, inertial axes.
// (3) [m]
// 16 add, 24 multiply, 2 sine or cosine
template <class T>
void tip_position([[maybe_unused]] const Prepared<T>& c, const T* x, T* position) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hub) on the inertial frame
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

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T s1_1 = x[7], s1_2 = x[8], s1_3 = x[9];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_21 = R1_21 * E2_22 + R1_31 * E2_23;
  const T R2_22 = R1_22 * E2_22 + R1_32 * E2_23;
  const T R2_23 = R1_23 * E2_22 + R1_33 * E2_23;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_21 * T(0.6);
  const T P2_2 = s1_2 + R1_22 * T(0.6);
  const T P2_3 = s1_3 + R1_23 * T(0.6);

  // ---- results
  position[0] = R2_21 * T(2) + P2_1;
  position[1] = R2_22 * T(2) + P2_2;
  position[2] = R2_23 * T(2) + P2_3;
}

// tip_acceleration: acceleration of tip, inertial axes.
// (3) [m/s^2]
// 55 add, 76 multiply, 2 sine or cosine
template <class T>
void tip_acceleration([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, T* acceleration)
    noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hub) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[6], sddot1_2 = ydot[7], sddot1_3 = ydot[8];
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
  const T U1_12 = omega1_1 * omega1_2 - omegadot1_3;
  const T minus_U1_22 = omega1_3 * omega1_3 + omega1_1 * omega1_1;
  const T U1_32 = omega1_2 * omega1_3 + omegadot1_1;
  // Pddot1 = R1 sddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1 = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * sddot1_3;
  const T Pddot1_2 = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * sddot1_3;
  const T Pddot1_3 = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * sddot1_3;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  const T omegadot1_2 = ydot[1];
  const T thetaddot2 = ydot[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cos(theta2);
  const T E2_23 = sin(theta2);
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_21 = R1_21 * E2_22 + R1_31 * E2_23;
  const T R2_22 = R1_22 * E2_22 + R1_32 * E2_23;
  const T R2_23 = R1_23 * E2_22 + R1_33 * E2_23;
  const T R2_31 = R1_31 * E2_22 - R1_21 * E2_23;
  const T R2_32 = R1_32 * E2_22 - R1_22 * E2_23;
  const T R2_33 = R1_33 * E2_22 - R1_23 * E2_23;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // omegadot2 = -thetadot2 b2~ E2 omega1 + thetaddot2 b2 + E2 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_1 = thetaddot2 + omegadot1_1;
  const T omegadot2_3 = E2_22 * omegadot1_3 - E2_23 * omegadot1_2 - thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U2_12 = omega2_2 * omega2_1 - omegadot2_3;
  const T minus_U2_22 = omega2_3 * omega2_3 + omega2_1 * omega2_1;
  const T U2_32 = omega2_3 * omega2_2 + omegadot2_1;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot2_1 = U1_12 * T(0.6) + Pddot1_1;
  const T t2_1 = Pddot1_2 - minus_U1_22 * T(0.6);
  const T t2_2 = U1_32 * T(0.6) + Pddot1_3;
  const T Pddot2_2 = E2_22 * t2_1 + E2_23 * t2_2;
  const T Pddot2_3 = E2_22 * t2_2 - E2_23 * t2_1;

  // ---- results
  const T t1 = U2_12 * T(2);
  const T t2 = minus_U2_22 * T(2);
  const T t3 = U2_32 * T(2);
  acceleration[0] = R1_11 * t1 - R2_21 * t2 + R2_31 * t3 + R1_11 * Pddot2_1 + R2_21 * Pddot2_2 + R2_31 * Pddot2_3;
  acceleration[1] = R1_12 * t1 - R2_22 * t2 + R2_32 * t3 + R1_12 * Pddot2_1 + R2_22 * Pddot2_2 + R2_32 * Pddot2_3;
  acceleration[2] = R1_13 * t1 - R2_23 * t2 + R2_33 * t3 + R1_13 * Pddot2_1 + R2_23 * Pddot2_2 + R2_33 * Pddot2_3;
}

}  // namespace kanec::satellite
