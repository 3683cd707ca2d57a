// SPDX-License-Identifier: BSD-3-Clause
// satellite: equations of motion of 4 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model a9f56e73381382c2 of satellite/scene.toml; functions kinematics poses energy momentum power accelerations
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
//   state_matrix                  3409 (1583 add, 1820 multiply, 6 divide, 6 sine or cosine)
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
inline constexpr char model_hash[] = "a9f56e73381382c2";

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
  const T b0_1 = T(0.1) * omega1_1 + T(0.5) * omega1_2;
  const T b0_2 = T(0.1) * omega1_3;
  const T b0_3 = T(0.5) * omega1_3;
  const T power = R1_11 * u.thrust * (sdot1_1 + R1_31 * b0_1 - R1_11 * b0_2 - R1_21 * b0_3) + R1_12 * u.thrust *
      (sdot1_2 + R1_32 * b0_1 - R1_12 * b0_2 - R1_22 * b0_3) + R1_13 * u.thrust * (sdot1_3 + R1_33 * b0_1 - R1_13 *
      b0_2 - R1_23 * b0_3) - thetadot2 * minus_damping_left_panel_2 - thetadot3 * minus_damping_right_panel_3 +
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
  const T minus_N1_2 = T(0.2) * t1_13 - T(2) * t1_17 - T(0.1) * (t1_15 - t1_18) - T(0.3) * t1_16;
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
  const T Pddot4_1 = E4_13 * t4_19 - E4_11 * t4_20 - E4_12 * t4_21;
  const T Pddot4_2 = E4_12 * t4_19 - E4_13 * t4_20 - E4_11 * t4_21;
  const T Pddot4_3 = E4_11 * t4_19 - E4_12 * t4_20 - E4_13 * t4_21;
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
  const T S1_3 = b1_3 - b1_4 - E4_13 * minus_G4_1 - E4_12 * minus_G4_2 - E4_11 * minus_G4_3;
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
  const T z1_1 = u.wheel_torque - T(0.5773502691896257) * minus_N4_1 - T(0.5773502691896257) * minus_N4_2 -
      T(0.5773502691896257) * minus_N4_3;
  const T z1_2 = b1_25 * z1_1;
  const T z1_3 = minus_rho3_1 + minus_effort_right_panel_3;
  const T z1_4 = minus_rho2_1 + minus_effort_left_panel_2;
  const T z1_5 = b1_27 * z1_3 - minus_f_omega1_1 - z1_2 + b1_28 * z1_4;
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
  const T thetaddot2 = b1_42 * z1_11 - z1_4 * T(0.08333333333333333) - b1_28 * omegadot1_1 - b1_53 * z1_10;
  ydot[3] = thetaddot2;

  // ---- body 3 (right_panel), solved
  // thetaddot3: from A ydot = f by elimination
  const T thetaddot3 = b1_52 * z1_10 - z1_3 * T(0.08333333333333333) - b1_27 * omegadot1_1 - b1_41 * z1_11;
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
  const T r_omega1_2 = E4_12 * N4_1 + E4_11 * N4_2 + E4_13 * N4_3 - E2_22 * minus_N2_2 - E2_23 * rho2_3 - E3_22 *
      minus_N3_2 - E3_23 * rho3_3 - T(0.2) * b1_1 + N1_2;
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
  const T J1_23 = T(0.3) - T(0.6) * hc2_3 - (T(0.6) * minus_hc3_3 - (b1_17 * E2_23 - b1_18 * E2_22)) + (b1_19 * E3_23
      - b1_20 * E3_22 + (b1_16 + b1_14 + b1_15));
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
  const T minus_N1_2 = T(0.2) * t1_13 - T(2) * t1_17 - T(0.1) * (t1_15 - t1_18) - T(0.3) * t1_16;
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
  const T Pddot4_1 = E4_13 * t4_19 - E4_11 * t4_20 - E4_12 * t4_21;
  const T Pddot4_2 = E4_12 * t4_19 - E4_13 * t4_20 - E4_11 * t4_21;
  const T Pddot4_3 = E4_11 * t4_19 - E4_12 * t4_20 - E4_13 * t4_21;
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
  const T S1_3 = b1_3 - b1_4 - E4_13 * minus_G4_1 - E4_12 * minus_G4_2 - E4_11 * minus_G4_3;
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
  const T z1_1 = u.wheel_torque - T(0.5773502691896257) * minus_N4_1 - T(0.5773502691896257) * minus_N4_2 -
      T(0.5773502691896257) * minus_N4_3;
  const T z1_2 = b1_25 * z1_1;
  const T z1_3 = minus_rho3_1 + minus_effort_right_panel_3;
  const T z1_4 = minus_rho2_1 + minus_effort_left_panel_2;
  const T z1_5 = b1_27 * z1_3 - minus_f_omega1_1 - z1_2 + b1_28 * z1_4;
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
  const T thetaddot2 = b1_42 * z1_11 - z1_4 * T(0.08333333333333333) - b1_28 * omegadot1_1 - b1_53 * z1_10;
  ydot[3] = thetaddot2;

  // ---- body 3 (right_panel), solved
  // thetaddot3: from A ydot = f by elimination
  const T thetaddot3 = b1_52 * z1_10 - z1_3 * T(0.08333333333333333) - b1_27 * omegadot1_1 - b1_41 * z1_11;
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
// 1583 add, 1820 multiply, 6 divide, 6 sine or cosine
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
  const T minus_N1_2 = T(0.2) * t1_13 - T(2) * t1_17 - T(0.1) * (t1_15 - t1_18) - T(0.3) * t1_16;
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
  const T Pddot4_1 = E4_13 * t4_23 - E4_11 * t4_24 - E4_12 * t4_25;
  const T Pddot4_2 = E4_12 * t4_23 - E4_13 * t4_24 - E4_11 * t4_25;
  const T Pddot4_3 = E4_11 * t4_23 - E4_12 * t4_24 - E4_13 * t4_25;
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
  const T S1_3 = b1_5 - b1_6 - E4_13 * minus_G4_1 - E4_12 * minus_G4_2 - E4_11 * minus_G4_3;
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
  const T z1_1 = u.wheel_torque - T(0.5773502691896257) * minus_N4_1 - T(0.5773502691896257) * minus_N4_2 -
      T(0.5773502691896257) * minus_N4_3;
  const T z1_2 = b1_43 * z1_1;
  const T z1_3 = minus_rho3_1 + minus_effort_right_panel_3;
  const T z1_4 = minus_rho2_1 + minus_effort_left_panel_2;
  const T z1_5 = b1_45 * z1_3 - minus_f_omega1_1 - z1_2 + b1_46 * z1_4;
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
  const T t1 = t2_3 - omega2_2 * omega2_2;
  const T t2 = T(9) * (t1 - Pddot2_2);
  const T t3 = t2 + T(3) * t1;
  const T t4 = t3 + c.p.k;
  const T t5 = T(9) * (a2_3 + U2_23);
  const T t6 = E2_22 * t2 - b1_3 + E2_23 * t5;
  const T t7 = T(0.08333333333333333) * b1_34;
  const T t8 = b1_46 * t4 - (T(0.6) * t6 + t3 + z1_4 * t7);
  const T t9 = b1_48 * b1_48;
  const T t10 = T(1.2) * hc2_3;
  const T t11 = t9 * (b1_12 * t7 + b1_46 * b1_34 - t10);
  const T t12 = b1_64 + b1_76 * b1_34 - hc2_3;
  const T t13 = b1_48 * t12 - b1_80 * t11;
  const T t14 = b1_47 * t13;
  const T t15 = b1_53 * b1_53;
  const T t16 = E2_23 * b1_37 - b1_33 - E2_22 * b1_38;
  const T t17 = b1_47 * t11;
  const T t18 = t15 * (t16 + b1_47 * t17);
  const T t19 = b1_53 * t14 - b1_82 * t18;
  const T t20 = N2_2 - T(12) * U2_13;
  const T t21 = E2_22 * t2_8 + b1_9 - E2_23 * t20 + b1_49 * t8 - z1_5 * t17;
  const T t22 = b1_50 * t11;
  const T t23 = b1_29 - b1_39 + b1_47 * t22;
  const T t24 = b1_52 * t19 + b1_83 * t23 - b1_50 * t13;
  const T t25 = b1_57 * b1_57;
  const T t26 = b1_53 * t23 - b1_52 * t18;
  const T t27 = t25 * (b1_50 * t22 - t16 - t10 - b1_52 * t26 - b1_54 * t23);
  const T t28 = b1_57 * t24 - b1_84 * t27;
  const T t29 = T(9) * U2_13;
  const T t30 = b1_7 - E2_23 * t2_8 - E2_22 * t20 + T(0.6) * t29 - b1_51 * t8 + z1_5 * t22 - z1_6 * t26 + b1_54 * t21;
  const T t31 = b1_53 * hc2_2 - h1_3 * t18;
  const T t32 = b1_52 * t31 + b1_55 * t23 - hc2_3;
  const T t33 = h1_3 * t19 + b1_83 * hc2_2 + b1_56 * t28 + b1_85 * t32;
  const T t34 = b1_72 * b1_72;
  const T t35 = b1_57 * t32 - b1_56 * t27;
  const T t36 = t34 * (h1_3 * t31 + b1_55 * hc2_2 + b1_56 * t35 + b1_58 * t32);
  const T t37 = b1_72 * t33 + b1_86 * t36;
  const T t38 = z1_7 * t35 + b1_58 * t30 - t29 - z1_6 * t31 + b1_55 * t21;
  const T t39 = hc2_2 + b1_61 * b1_34 - b1_79;
  const T t40 = b1_48 * t39 - b1_65 * t11;
  const T t41 = b1_47 * t40;
  const T t42 = b1_53 * t41 - b1_67 * t18;
  const T t43 = b1_50 * t40 - b1_52 * t42 - b1_68 * t23;
  const T t44 = b1_57 * t43 - b1_69 * t27;
  const T t45 = b1_56 * t44 + b1_70 * t32 - h1_3 * t42 - b1_68 * hc2_2;
  const T t46 = b1_65 * t13 + b1_81 * t39 - b1_62 + b1_77 + b1_67 * t19 + b1_83 * t41 - b1_69 * t28 - b1_85 * t43 -
      b1_71 * t37 - b1_87 * t45;
  const T t47 = b1_91 * b1_91;
  const T t48 = b1_89 + b1_61 * hc2_2;
  const T t49 = b1_72 * t45 + b1_71 * t36;
  const T t50 = t47 * (t48 + b1_65 * t40 + b1_66 * t39 + b1_67 * t42 + b1_68 * t41 + b1_69 * t44 + b1_70 * t43 + b1_71
      * t49 + b1_73 * t45);
  const T t51 = b1_91 * t46 + b1_90 * t50;
  const T t52 = b1_6 - E2_22 * t5 + E2_23 * t2 - z1_13 - b1_61 * t4 + z1_5 * t40 + b1_66 * t8 - z1_6 * t42 + b1_68 *
      t21 - z1_7 * t44 - b1_70 * t30 - z1_8 * t49 - b1_73 * t38;
  const T t53 = z1_15 * z1_15;
  const T t54 = z1_15 * (b1_76 * t4 - (t6 + z1_10) - z1_5 * t13 - b1_81 * t8 + z1_6 * t19 - b1_83 * t21 - z1_7 * t28 -
      b1_85 * t30 - z1_8 * t37 - b1_87 * t38 - z1_11 * t51 - b1_92 * t52) + t53 * (b1_80 * t13 + b1_81 * t12 - t48 +
      b1_82 * t19 + b1_83 * t14 + b1_84 * t28 + b1_85 * t24 + b1_86 * t37 + b1_87 * t33 + b1_90 * t51 + b1_92 * t46) *
      z1_14;
  const T t55 = b1_91 * t52 + z1_11 * t50 - z1_16 * t51 - b1_92 * t54;
  const T t56 = b1_72 * t38 + z1_8 * t36 - z1_17 * t49 - b1_73 * t55 - z1_16 * t37 - b1_87 * t54;
  const T t57 = b1_57 * t30 - z1_7 * t27 + Pddot1_1 * t35 + b1_58 * t56 - z1_17 * t44 - b1_70 * t55 - z1_16 * t28 -
      b1_85 * t54;
  const T t58 = z1_16 * t19 + b1_83 * t54 - b1_53 * t21 - z1_6 * t18 - z1_18 * t26 - b1_54 * t57 - Pddot1_1 * t31 -
      b1_55 * t56 - z1_17 * t42 - b1_68 * t55;
  const T t59 = b1_48 * t8 - z1_5 * t11 - b1_49 * t58 + z1_19 * t17 - b1_51 * t57 + z1_18 * t22 + z1_17 * t40 + b1_66
      * t55 - z1_16 * t13 - b1_81 * t54;
  S[165] = t59;
  const T t60 = b1_78 - b1_59 * b1_35 - minus_hc3_2;
  const T t61 = T(0.08333333333333333) * b1_35;
  const T t62 = T(1.2) * minus_hc3_3;
  const T t63 = t9 * (K_thetadot3_1_1 * t61 + b1_45 * b1_35 - t62);
  const T t64 = b1_48 * t60 - b1_65 * t63;
  const T t65 = T(9) * (minus_a3_3 + U3_23);
  const T t66 = t3_3 - omega3_2 * omega3_2;
  const T t67 = T(9) * (Pddot3_2 + t66);
  const T t68 = T(3) * t66 + t67;
  const T t69 = t68 + c.p.k;
  const T t70 = E3_23 * t65 - b1_2 + E3_22 * t67;
  const T t71 = T(0.6) * t70 + t68 + z1_3 * t61 - b1_45 * t69;
  const T t72 = b1_47 * t64;
  const T t73 = E3_23 * b1_40 - b1_36 - E3_22 * b1_41;
  const T t74 = b1_47 * t63;
  const T t75 = t15 * (t73 + b1_47 * t74);
  const T t76 = b1_53 * t72 - b1_67 * t75;
  const T t77 = T(12) * U3_13 - N3_2;
  const T t78 = z1_5 * t74 + b1_49 * t71 - E3_22 * t3_4 - b1_10 - E3_23 * t77;
  const T t79 = b1_50 * t63;
  const T t80 = b1_32 - b1_42 + b1_47 * t79;
  const T t81 = b1_50 * t64 - b1_52 * t76 - b1_68 * t80;
  const T t82 = b1_53 * t80 - b1_52 * t75;
  const T t83 = t25 * (b1_50 * t79 - t73 - t62 - b1_52 * t82 - b1_54 * t80);
  const T t84 = b1_57 * t81 - b1_69 * t83;
  const T t85 = T(9) * U3_13;
  const T t86 = b1_8 - E3_23 * t3_4 + E3_22 * t77 + T(0.6) * t85 + z1_5 * t79 + b1_51 * t71 - z1_6 * t82 - b1_54 *
      t78;
  const T t87 = b1_53 * minus_hc3_2 + h1_3 * t75;
  const T t88 = minus_hc3_3 + b1_55 * t80 - b1_52 * t87;
  const T t89 = b1_56 * t84 + b1_70 * t88 - h1_3 * t76 + b1_68 * minus_hc3_2;
  const T t90 = b1_57 * t88 - b1_56 * t83;
  const T t91 = t34 * (h1_3 * t87 + b1_55 * minus_hc3_2 - b1_56 * t90 - b1_58 * t88);
  const T t92 = b1_72 * t89 - b1_71 * t91;
  const T t93 = t85 - b1_55 * t78 + z1_6 * t87 + z1_7 * t90 + b1_58 * t86;
  const T t94 = E3_22 * t65 - b1_5 - E3_23 * t67 + z1_12 + b1_59 * t69 + z1_5 * t64 - b1_66 * t71 - z1_6 * t76 - b1_68
      * t78 - z1_7 * t84 - b1_70 * t86 - z1_8 * t92 - b1_73 * t93;
  const T t95 = b1_88 + b1_59 * minus_hc3_2;
  const T t96 = t47 * (t95 + b1_65 * t64 + b1_66 * t60 + b1_67 * t76 + b1_68 * t72 + b1_69 * t84 + b1_70 * t81 + b1_71
      * t92 + b1_73 * t89);
  const T t97 = minus_hc3_3 - b1_63 - b1_74 * b1_35;
  const T t98 = b1_48 * t97 - b1_80 * t63;
  const T t99 = b1_47 * t98;
  const T t100 = b1_53 * t99 - b1_82 * t75;
  const T t101 = b1_52 * t100 + b1_83 * t80 - b1_50 * t98;
  const T t102 = b1_57 * t101 - b1_84 * t83;
  const T t103 = h1_3 * t100 - b1_83 * minus_hc3_2 + b1_56 * t102 + b1_85 * t88;
  const T t104 = b1_72 * t103 - b1_86 * t91;
  const T t105 = b1_65 * t98 + b1_81 * t60 - b1_60 + b1_75 + b1_67 * t100 + b1_83 * t72 - b1_69 * t102 - b1_85 * t81 -
      b1_71 * t104 - b1_87 * t89;
  const T t106 = b1_91 * t105 + b1_90 * t96;
  const T t107 = z1_15 * (t70 - b1_74 * t69 + z1_9 - z1_5 * t98 + b1_81 * t71 + z1_6 * t100 + b1_83 * t78 - z1_7 *
      t102 - b1_85 * t86 - z1_8 * t104 - b1_87 * t93 - z1_11 * t106 - b1_92 * t94) + t53 * (b1_80 * t98 + b1_81 * t97
      - t95 + b1_82 * t100 + b1_83 * t99 + b1_84 * t102 + b1_85 * t101 + b1_86 * t104 + b1_87 * t103 + b1_90 * t106 +
      b1_92 * t105) * z1_14;
  const T t108 = b1_91 * t94 + z1_11 * t96 - z1_16 * t106 - b1_92 * t107;
  const T t109 = b1_72 * t93 - z1_8 * t91 - z1_17 * t92 - b1_73 * t108 - z1_16 * t104 - b1_87 * t107;
  const T t110 = b1_57 * t86 - z1_7 * t83 + Pddot1_1 * t90 + b1_58 * t109 - z1_17 * t84 - b1_70 * t108 - z1_16 * t102
      - b1_85 * t107;
  const T t111 = b1_53 * t78 - z1_6 * t75 - z1_18 * t82 - b1_54 * t110 - b1_55 * t109 + Pddot1_1 * t87 - z1_17 * t76 -
      b1_68 * t108 + z1_16 * t100 + b1_83 * t107;
  const T t112 = z1_17 * t64 + b1_66 * t108 - b1_48 * t71 - z1_5 * t63 - b1_49 * t111 + z1_19 * t74 - b1_51 * t110 +
      z1_18 * t79 - z1_16 * t98 - b1_81 * t107;
  S[166] = t112;
  const T t113 = T(0.6666666666666666) * t4_2;
  const T t114 = T(0.5773502691896257) * t4_1;
  const T t115 = T(0.3333333333333333) * t4_2;
  const T t116 = t114 - t115;
  const T t117 = t114 + t115;
  const T t118 = T(4) * (t4_25 * t113 + t4_24 * t116 + t4_23 * t117);
  const T t119 = T(4) * (t4_24 * t113 - t4_25 * t117 - t4_23 * t116);
  const T t120 = T(4) * (t4_25 * t116 - t4_24 * t117 - t4_23 * t113);
  const T t121 = minus_G4_2 * t113 - E4_11 * t118 - minus_G4_1 * t117 - E4_12 * t119 + minus_G4_3 * t116 - E4_13 *
      t120;
  const T t122 = T(0.0021) * t116;
  const T t123 = T(0.0021) * t113;
  const T t124 = T(0.0158) * t117 - t122 - t123;
  const T t125 = E4_12 * t124;
  const T t126 = T(0.0021) * t117;
  const T t127 = t123 - t126 + T(0.0158) * t116;
  const T t128 = E4_13 * t127;
  const T t129 = t122 - t126 + T(0.0158) * t113;
  const T t130 = E4_11 * t129;
  const T t131 = t125 - t128 - t130;
  const T t132 = b1_16 * t113;
  const T t133 = b1_19 * t116;
  const T t134 = b1_21 * t117;
  const T t135 = T(0.011547005383792516) * t117 - T(0.011547005383792516) * t116 - T(0.011547005383792516) * t113;
  const T t136 = T(50) * t135;
  const T t137 = K_thetadot4_1_1 * t136;
  const T t138 = b1_43 * t135;
  const T t139 = t9 * (t131 - t132 - t133 + t134 - t137 - t138);
  const T t140 = b1_65 * t139;
  const T t141 = omega1_1 * t117 - omega1_2 * t116 - omega1_3 * t113;
  const T t142 = omega1_3 * t117 - omega1_2 * t113 - omega1_1 * t116;
  const T t143 = omega4_2 * t141 + omega4_3 * t142;
  const T t144 = T(0.5773502691896257) * t141;
  const T t145 = T(0.5773502691896257) * t142;
  const T t146 = thetadot4 * (t144 - t145);
  const T t147 = t143 - t146;
  const T t148 = t143 + t146;
  const T t149 = omega4_3 * t141;
  const T t150 = t149 + t149;
  const T t151 = omega1_2 * t117 - omega1_1 * t113 - omega1_3 * t116;
  const T t152 = omega4_1 * t151;
  const T t153 = t152 + t152;
  const T t154 = t150 + t153;
  const T t155 = omega4_2 * t142;
  const T t156 = t155 + t155;
  const T t157 = t156 + t153;
  const T t158 = omega4_1 * t141 + omega4_3 * t151;
  const T t159 = T(0.5773502691896257) * t151;
  const T t160 = thetadot4 * (t159 - t144);
  const T t161 = t158 + t160;
  const T t162 = omega4_1 * t142 + omega4_2 * t151;
  const T t163 = thetadot4 * (t145 - t159);
  const T t164 = t162 - t163;
  const T t165 = T(0.0079) * t147 - T(0.0079) * t148 - T(0.0021) * (t154 - t157) - T(0.0021) * t161 + T(0.0021) *
      t164;
  const T t166 = t158 - t160;
  const T t167 = t150 + t156;
  const T t168 = t162 + t163;
  const T t169 = T(0.0079) * t166 - T(0.0079) * t161 - T(0.0021) * (t157 - t167) - T(0.0021) * t168 + T(0.0021) *
      t147;
  const T t170 = T(0.0079) * t164 - T(0.0079) * t168 - T(0.0021) * (t167 - t154) - T(0.0021) * t148 + T(0.0021) *
      t166;
  const T t171 = z1_1 * t136;
  const T t172 = T(0.5773502691896257) * t165 + T(0.5773502691896257) * t169 + T(0.5773502691896257) * t170;
  const T t173 = b1_43 * t172;
  const T t174 = E4_11 * t165 - minus_N4_1 * t113 + E4_13 * t169 - minus_N4_2 * t116 + minus_N4_3 * t117 + E4_12 *
      t170 - T(0.2) * t121 + t171 - t173;
  const T t175 = E4_13 * t124 - E4_11 * t127 - E4_12 * t129;
  const T t176 = b1_16 * t117;
  const T t177 = b1_19 * t113;
  const T t178 = b1_21 * t116;
  const T t179 = t175 + t176 - t177 - t178 - t137 - t138;
  const T t180 = b1_66 * t179 - b1_47 * t140;
  const T t181 = b1_48 * t179 - b1_47 * t139;
  const T t182 = t15 * (t131 + t134 - t132 - t133 - t137 - t138 - b1_47 * t181 - b1_49 * t179);
  const T t183 = b1_53 * t180 - b1_67 * t182;
  const T t184 = minus_G4_1 * t113 - E4_11 * t119 + minus_G4_2 * t116 - E4_13 * t118 - minus_G4_3 * t117 - E4_12 *
      t120;
  const T t185 = T(0.2) * t184 + minus_N4_1 * t117 + E4_12 * t165 + E4_11 * t169 - minus_N4_2 * t113 + E4_13 * t170 -
      minus_N4_3 * t116 + t171 - t173 + z1_5 * t181 - b1_49 * t174;
  const T t186 = b1_19 * t117 - (E4_13 * t129 + b1_16 * t116 + E4_12 * t127) + E4_11 * t124 - b1_21 * t113 - t137 -
      t138;
  const T t187 = b1_48 * t186 - b1_50 * t139;
  const T t188 = t175 - t178 + t176 - t177 - t137 - t138 - b1_47 * t187 - b1_51 * t179;
  const T t189 = b1_66 * t186 - b1_50 * t140 - b1_52 * t183 - b1_68 * t188;
  const T t190 = b1_53 * t188 - b1_52 * t182;
  const T t191 = t25 * (t125 - (t128 + t133) + t134 - t130 - t132 - t137 - t138 - b1_50 * t187 - b1_51 * t186 - b1_52
      * t190 - b1_54 * t188);
  const T t192 = b1_57 * t189 - b1_69 * t191;
  const T t193 = E4_13 * t165 - minus_N4_1 * t116 + minus_N4_2 * t117 + E4_12 * t169 + E4_11 * t170 - minus_N4_3 *
      t113 + t171 - t173 + z1_5 * t187 - b1_51 * t174 + z1_6 * t190 - b1_54 * t185;
  const T t194 = h1_3 * t182;
  const T t195 = b1_55 * t188 - b1_52 * t194;
  const T t196 = b1_56 * t192 + b1_70 * t195 - h1_3 * t183;
  const T t197 = b1_57 * t195 - b1_56 * t191;
  const T t198 = t34 * (h1_3 * t194 - b1_56 * t197 - b1_58 * t195);
  const T t199 = b1_72 * t196 - b1_71 * t198;
  const T t200 = t184 + b1_55 * t185 + z1_6 * t194 + z1_7 * t197 - b1_58 * t193;
  const T t201 = t121 - z1_5 * t140 - b1_66 * t174 - z1_6 * t183 + b1_68 * t185 - z1_7 * t192 + b1_70 * t193 - z1_8 *
      t199 - b1_73 * t200;
  const T t202 = t47 * (b1_65 * t140 - b1_67 * t183 - b1_68 * t180 - b1_69 * t192 - b1_70 * t189 - b1_71 * t199 -
      b1_73 * t196);
  const T t203 = b1_80 * t139;
  const T t204 = b1_81 * t179 - b1_47 * t203;
  const T t205 = b1_53 * t204 - b1_82 * t182;
  const T t206 = b1_52 * t205 + b1_83 * t188 - b1_81 * t186 + b1_50 * t203;
  const T t207 = b1_57 * t206 - b1_84 * t191;
  const T t208 = h1_3 * t205 + b1_56 * t207 + b1_85 * t195;
  const T t209 = b1_72 * t208 - b1_86 * t198;
  const T t210 = b1_67 * t205 + b1_83 * t180 - b1_65 * t203 - b1_69 * t207 - b1_85 * t189 - b1_71 * t209 - b1_87 *
      t196;
  const T t211 = b1_91 * t210 - b1_90 * t202;
  const T t212 = z1_15 * (minus_G4_1 * t116 - E4_13 * t119 - minus_G4_2 * t117 - E4_12 * t118 + minus_G4_3 * t113 -
      E4_11 * t120 + z1_5 * t203 + b1_81 * t174 + z1_6 * t205 - b1_83 * t185 - z1_7 * t207 + b1_85 * t193 - z1_8 *
      t209 - b1_87 * t200 - z1_11 * t211 - b1_92 * t201) - t53 * (b1_80 * t203 - b1_82 * t205 - b1_83 * t204 - b1_84 *
      t207 - b1_85 * t206 - b1_86 * t209 - b1_87 * t208 - b1_90 * t211 - b1_92 * t210) * z1_14;
  const T t213 = b1_91 * t201 - z1_11 * t202 - z1_16 * t211 - b1_92 * t212;
  const T t214 = b1_72 * t200 - z1_8 * t198 - z1_17 * t199 - b1_73 * t213 - z1_16 * t209 - b1_87 * t212;
  const T t215 = Pddot1_1 * t197 + b1_58 * t214 - b1_57 * t193 - z1_7 * t191 - z1_17 * t192 - b1_70 * t213 - z1_16 *
      t207 - b1_85 * t212;
  const T t216 = z1_16 * t205 + b1_83 * t212 - b1_53 * t185 - z1_6 * t182 - z1_18 * t190 - b1_54 * t215 - b1_55 * t214
      + Pddot1_1 * t194 - z1_17 * t183 - b1_68 * t213;
  const T t217 = b1_66 * t213 - z1_17 * t140 - b1_48 * t174 - z1_5 * t139 - z1_19 * t181 - b1_49 * t216 - z1_18 * t187
      - b1_51 * t215 - b1_81 * t212 + z1_16 * t203;
  S[167] = t217;
  const T t218 = T(1.2) * omega1_1;
  const T t219 = omega2_1 + omega2_1;
  const T t220 = T(9) * (E2_22 * t218 + t219);
  const T t221 = E2_23 * t218 * T(9);
  const T t222 = E2_23 * t220 - E2_22 * t221;
  const T t223 = E3_23 * t218 * T(9);
  const T t224 = omega3_1 + omega3_1;
  const T t225 = T(9) * (t224 + E3_22 * t218);
  const T t226 = E3_22 * t223 - E3_23 * t225;
  const T t227 = T(0.4) * omega1_1;
  const T t228 = T(0.2) * omega1_3;
  const T t229 = E4_11 * t228;
  const T t230 = T(4) * (E4_13 * t227 - t229);
  const T t231 = E4_13 * t228;
  const T t232 = T(4) * (E4_12 * t227 - t231);
  const T t233 = E4_12 * t228;
  const T t234 = T(4) * (E4_11 * t227 - t233);
  const T t235 = E4_12 * t230 + E4_11 * t232 + E4_13 * t234;
  const T t236 = omega4_2 * E4_12;
  const T t237 = omega4_3 * E4_13;
  const T t238 = t236 + t237;
  const T t239 = T(0.5773502691896257) * E4_12;
  const T t240 = T(0.5773502691896257) * E4_13;
  const T t241 = thetadot4 * (t239 - t240);
  const T t242 = t238 - t241;
  const T t243 = t238 + t241;
  const T t244 = omega4_3 * E4_12;
  const T t245 = t244 + t244;
  const T t246 = omega4_1 * E4_11;
  const T t247 = t246 + t246;
  const T t248 = t245 + t247;
  const T t249 = omega4_2 * E4_13;
  const T t250 = t249 + t249;
  const T t251 = t250 + t247;
  const T t252 = omega4_1 * E4_12;
  const T t253 = omega4_3 * E4_11;
  const T t254 = t252 + t253;
  const T t255 = T(0.5773502691896257) * E4_11;
  const T t256 = thetadot4 * (t255 - t239);
  const T t257 = t254 + t256;
  const T t258 = omega4_1 * E4_13;
  const T t259 = omega4_2 * E4_11;
  const T t260 = t258 + t259;
  const T t261 = thetadot4 * (t240 - t255);
  const T t262 = t260 - t261;
  const T t263 = T(0.0079) * t242 - T(0.0079) * t243 - T(0.0021) * (t248 - t251) - T(0.0021) * t257 + T(0.0021) *
      t262;
  const T t264 = t254 - t256;
  const T t265 = t245 + t250;
  const T t266 = t260 + t261;
  const T t267 = T(0.0079) * t264 - T(0.0079) * t257 - T(0.0021) * (t251 - t265) - T(0.0021) * t266 + T(0.0021) *
      t242;
  const T t268 = T(0.0079) * t262 - T(0.0079) * t266 - T(0.0021) * (t265 - t248) - T(0.0021) * t243 + T(0.0021) *
      t264;
  const T t269 = T(0.1) * omega1_2;
  const T t270 = T(0.5773502691896257) * t263 + T(0.5773502691896257) * t267 + T(0.5773502691896257) * t268;
  const T t271 = b1_43 * t270;
  const T t272 = T(0.6) * t222 - t221 - T(0.6) * t226 - t223 - T(0.2) * t235 - E4_11 * t263 - E4_13 * t267 - E4_12 *
      t268 + t269 + t228 + t271 + b1_45 * t223 + b1_46 * t221;
  const T t273 = T(0.75) * omega2_3;
  const T t274 = omega1_2 * T(0.6);
  const T t275 = T(9) * (omega2_2 + t274);
  const T t276 = T(2.25) * omega2_2 + t275;
  const T t277 = T(0.75) * omega3_3;
  const T t278 = T(9) * (t274 + omega3_2);
  const T t279 = t278 + T(2.25) * omega3_2;
  const T t280 = E4_11 * t230 + E4_13 * t232 + E4_12 * t234;
  const T t281 = omega1_1 + omega1_1;
  const T t282 = E2_22 * t273 - E2_23 * t276 + E3_22 * t277 - E3_23 * t279 + T(0.2) * t280 - E4_12 * t263 - E4_11 *
      t267 - E4_13 * t268 - T(0.1) * t281 + T(2) * omega1_3 + T(0.3) * omega1_2 + t271 - b1_49 * t272;
  const T t283 = E2_23 * t273 + E2_22 * t276 + T(0.6) * t275 + T(0.6) * t278 + E3_22 * t279 + E3_23 * t277 - E4_13 *
      t263 - E4_12 * t267 - E4_11 * t268 - T(0.2) * t281 + T(2) * omega1_2 - T(0.3) * omega1_3 + t271 - b1_51 * t272 -
      b1_54 * t282;
  const T t284 = t278 - t275 - t280 - b1_55 * t282 + b1_58 * t283;
  const T t285 = E2_22 * t220 + E2_23 * t221 - E3_22 * t225 - E3_23 * t223 - t235 + b1_59 * t223 - b1_61 * t221 +
      b1_66 * t272 - b1_68 * t282 - b1_70 * t283 - b1_73 * t284;
  const T t286 = z1_15 * (t222 + t226 - E4_13 * t230 - E4_12 * t232 - E4_11 * t234 - b1_74 * t223 + b1_76 * t221 -
      b1_81 * t272 + b1_83 * t282 - b1_85 * t283 - b1_87 * t284 - b1_92 * t285);
  const T t287 = b1_91 * t285 - b1_92 * t286;
  const T t288 = b1_72 * t284 - b1_73 * t287 - b1_87 * t286;
  const T t289 = b1_57 * t283 + b1_58 * t288 - b1_70 * t287 - b1_85 * t286;
  const T t290 = b1_53 * t282 - b1_54 * t289 - b1_55 * t288 - b1_68 * t287 + b1_83 * t286;
  const T t291 = b1_48 * t272 - b1_49 * t290 - b1_51 * t289 + b1_66 * t287 - b1_81 * t286;
  S[171] = t291;
  const T t292 = t249 + t253;
  const T t293 = t292 - t261;
  const T t294 = t292 + t261;
  const T t295 = t237 + t237;
  const T t296 = t252 + t252;
  const T t297 = t295 + t296;
  const T t298 = t259 + t259;
  const T t299 = t298 + t296;
  const T t300 = t258 + t244;
  const T t301 = t300 + t241;
  const T t302 = t246 + t236;
  const T t303 = t302 - t256;
  const T t304 = T(0.0079) * t293 - T(0.0079) * t294 - T(0.0021) * (t297 - t299) - T(0.0021) * t301 + T(0.0021) *
      t303;
  const T t305 = t300 - t241;
  const T t306 = t295 + t298;
  const T t307 = t302 + t256;
  const T t308 = T(0.0079) * t305 - T(0.0079) * t301 - T(0.0021) * (t299 - t306) - T(0.0021) * t307 + T(0.0021) *
      t293;
  const T t309 = T(0.0079) * t303 - T(0.0079) * t307 - T(0.0021) * (t306 - t297) - T(0.0021) * t294 + T(0.0021) *
      t305;
  const T t310 = T(0.5773502691896257) * t304 + T(0.5773502691896257) * t308 + T(0.5773502691896257) * t309;
  const T t311 = b1_43 * t310;
  const T t312 = omega2_3 * E2_23;
  const T t313 = T(9) * (E2_23 * t2_5 + t312 + t312);
  const T t314 = omega2_3 * E2_22;
  const T t315 = t314 - omega2_2 * E2_23;
  const T t316 = T(9) * (t315 + E2_22 * t2_5);
  const T t317 = E2_23 * t313 + E2_22 * t316;
  const T t318 = t316 + T(3) * t315;
  const T t319 = omega3_3 * E3_23;
  const T t320 = T(9) * (t319 + t319 + E3_23 * t2_5);
  const T t321 = omega3_3 * E3_22;
  const T t322 = t321 - omega3_2 * E3_23;
  const T t323 = T(9) * (E3_22 * t2_5 + t322);
  const T t324 = E3_23 * t320 + E3_22 * t323;
  const T t325 = t323 + T(3) * t322;
  const T t326 = T(0.4) * omega1_2;
  const T t327 = T(4) * (E4_13 * t326 - t233);
  const T t328 = T(4) * (E4_12 * t326 - t229);
  const T t329 = T(4) * (E4_11 * t326 - t231);
  const T t330 = E4_12 * t327 + E4_11 * t328 + E4_13 * t329;
  const T t331 = omega1_2 + omega1_2;
  const T t332 = t311 - T(0.6) * t317 - t318 - T(0.6) * t324 - t325 - T(0.2) * t330 - E4_11 * t304 - E4_13 * t308 -
      E4_12 * t309 - T(4) * omega1_3 - T(0.3) * t331 + T(0.1) * omega1_1 + b1_45 * t325 + b1_46 * t318;
  const T t333 = thetadot2 * E2_23;
  const T t334 = omega2_1 * E2_23;
  const T t335 = T(0.75) * (t333 - t334);
  const T t336 = omega2_1 * E2_22;
  const T t337 = thetadot2 * E2_22;
  const T t338 = T(0.75) * (t336 - t337);
  const T t339 = t336 + t337;
  const T t340 = T(9) * (t339 + t2_4);
  const T t341 = t338 - T(3) * t339 - t340;
  const T t342 = thetadot3 * E3_23;
  const T t343 = omega3_1 * E3_23;
  const T t344 = T(0.75) * (t342 - t343);
  const T t345 = omega3_1 * E3_22;
  const T t346 = thetadot3 * E3_22;
  const T t347 = t345 + t346;
  const T t348 = T(9) * (t2_4 + t347);
  const T t349 = T(0.75) * (t345 - t346);
  const T t350 = t348 - t349 + T(3) * t347;
  const T t351 = E4_11 * t327 + E4_13 * t328 + E4_12 * t329;
  const T t352 = T(0.3) * omega1_1;
  const T t353 = E2_22 * t335 + E2_23 * t341 + E3_22 * t344 - E3_23 * t350 + T(0.2) * t351 - E4_12 * t304 - E4_11 *
      t308 - E4_13 * t309 - t228 + t352 + t311 - b1_49 * t332;
  const T t354 = T(2) * omega1_1;
  const T t355 = E2_23 * t335 - E2_22 * t341 + T(0.6) * t340 + T(0.6) * t348 + E3_22 * t350 + E3_23 * t344 - E4_13 *
      t304 - E4_12 * t308 - E4_11 * t309 - T(0.1) * omega1_3 + t354 + T(0.2) * t331 + t311 - b1_51 * t332 - b1_54 *
      t353;
  const T t356 = t348 - t340 - t351 - b1_55 * t353 + b1_58 * t355;
  const T t357 = E2_23 * t316 - E2_22 * t313 + E3_22 * t320 - E3_23 * t323 - t330 + b1_59 * t325 - b1_61 * t318 +
      b1_66 * t332 - b1_68 * t353 - b1_70 * t355 - b1_73 * t356;
  const T t358 = z1_15 * (t324 - t317 - E4_13 * t327 - E4_12 * t328 - E4_11 * t329 - b1_74 * t325 + b1_76 * t318 -
      b1_81 * t332 + b1_83 * t353 - b1_85 * t355 - b1_87 * t356 - b1_92 * t357);
  const T t359 = b1_91 * t357 - b1_92 * t358;
  const T t360 = b1_72 * t356 - b1_73 * t359 - b1_87 * t358;
  const T t361 = b1_57 * t355 + b1_58 * t360 - b1_70 * t359 - b1_85 * t358;
  const T t362 = b1_53 * t353 - b1_54 * t361 - b1_55 * t360 - b1_68 * t359 + b1_83 * t358;
  const T t363 = b1_48 * t332 - b1_49 * t362 - b1_51 * t361 + b1_66 * t359 - b1_81 * t358;
  S[172] = t363;
  const T t364 = T(4) * (E4_12 * t4_22 + E4_11 * t4_21);
  const T t365 = T(4) * (E4_11 * t4_22 + E4_13 * t4_21);
  const T t366 = T(4) * (E4_13 * t4_22 + E4_12 * t4_21);
  const T t367 = E4_12 * t364 + E4_11 * t365 + E4_13 * t366;
  const T t368 = T(1.2) * omega1_3;
  const T t369 = T(9) * (E2_23 * t274 - E2_22 * t368 - t314 - t314);
  const T t370 = omega2_2 * E2_22 + t312;
  const T t371 = T(9) * (t370 + E2_23 * t368 + E2_22 * t274);
  const T t372 = E2_23 * t369 + E2_22 * t371;
  const T t373 = t371 + T(3) * t370;
  const T t374 = omega3_2 * E3_22 + t319;
  const T t375 = T(9) * (E3_23 * t368 + E3_22 * t274 + t374);
  const T t376 = T(9) * (t321 + t321 + E3_22 * t368 - E3_23 * t274);
  const T t377 = E3_22 * t375 - E3_23 * t376;
  const T t378 = t375 + T(3) * t374;
  const T t379 = t259 + t244;
  const T t380 = t379 - t256;
  const T t381 = t379 + t256;
  const T t382 = t253 + t253;
  const T t383 = t258 + t258;
  const T t384 = t382 + t383;
  const T t385 = t236 + t236;
  const T t386 = t385 + t383;
  const T t387 = t246 + t237;
  const T t388 = t387 + t261;
  const T t389 = t252 + t249;
  const T t390 = t389 - t241;
  const T t391 = T(0.0079) * t380 - T(0.0079) * t381 - T(0.0021) * (t384 - t386) - T(0.0021) * t388 + T(0.0021) *
      t390;
  const T t392 = t387 - t261;
  const T t393 = t382 + t385;
  const T t394 = t389 + t241;
  const T t395 = T(0.0079) * t392 - T(0.0079) * t388 - T(0.0021) * (t386 - t393) - T(0.0021) * t394 + T(0.0021) *
      t380;
  const T t396 = T(0.0079) * t390 - T(0.0079) * t394 - T(0.0021) * (t393 - t384) - T(0.0021) * t381 + T(0.0021) *
      t392;
  const T t397 = omega1_3 + omega1_3;
  const T t398 = T(0.5773502691896257) * t391 + T(0.5773502691896257) * t395 + T(0.5773502691896257) * t396;
  const T t399 = b1_43 * t398;
  const T t400 = T(0.2) * t367 - T(0.6) * t372 - t373 - T(0.6) * t377 - t378 - E4_11 * t391 - E4_13 * t395 - E4_12 *
      t396 - T(4) * omega1_2 + T(0.3) * t397 + t4_21 + t399 + b1_45 * t378 + b1_46 * t373;
  const T t401 = t334 + t333;
  const T t402 = t335 + T(12) * t401;
  const T t403 = t343 + t342;
  const T t404 = T(12) * t403 + t344;
  const T t405 = E4_11 * t364 + E4_13 * t365 + E4_12 * t366;
  const T t406 = E2_22 * t338 - E2_23 * t402 + E3_22 * t349 - E3_23 * t404 - T(0.2) * t405 - E4_12 * t391 - E4_11 *
      t395 - E4_13 * t396 - t4_22 + t354 + T(0.1) * t397 + t399 - b1_49 * t400;
  const T t407 = T(9) * t401;
  const T t408 = T(9) * t403;
  const T t409 = E2_23 * t338 + E2_22 * t402 + T(0.6) * t407 + T(0.6) * t408 + E3_22 * t404 + E3_23 * t349 - E4_13 *
      t391 - E4_12 * t395 - E4_11 * t396 - t352 - t269 + t399 - b1_51 * t400 - b1_54 * t406;
  const T t410 = t408 - t407 + t405 - b1_55 * t406 + b1_58 * t409;
  const T t411 = E2_23 * t371 - E2_22 * t369 - E3_22 * t376 - E3_23 * t375 + t367 + b1_59 * t378 - b1_61 * t373 +
      b1_66 * t400 - b1_68 * t406 - b1_70 * t409 - b1_73 * t410;
  const T t412 = z1_15 * (t377 - t372 + E4_13 * t364 + E4_12 * t365 + E4_11 * t366 - b1_74 * t378 + b1_76 * t373 -
      b1_81 * t400 + b1_83 * t406 - b1_85 * t409 - b1_87 * t410 - b1_92 * t411);
  const T t413 = b1_91 * t411 - b1_92 * t412;
  const T t414 = b1_72 * t410 - b1_73 * t413 - b1_87 * t412;
  const T t415 = b1_57 * t409 + b1_58 * t414 - b1_70 * t413 - b1_85 * t412;
  const T t416 = b1_53 * t406 - b1_54 * t415 - b1_55 * t414 - b1_68 * t413 + b1_83 * t412;
  const T t417 = b1_48 * t400 - b1_49 * t416 - b1_51 * t415 + b1_66 * t413 - b1_81 * t412;
  S[173] = t417;
  const T t418 = T(9) * t219;
  const T t419 = E2_23 * t418;
  const T t420 = T(0.6) * t419 + b1_46 * c.p.c;
  const T t421 = omega2_2 + omega2_2;
  const T t422 = T(12) * t421;
  const T t423 = E2_23 * t422 + b1_49 * t420;
  const T t424 = T(9) * t421;
  const T t425 = E2_22 * t422 + T(0.6) * t424 - b1_51 * t420 + b1_54 * t423;
  const T t426 = b1_58 * t425 - t424 + b1_55 * t423;
  const T t427 = E2_22 * t418 - b1_61 * c.p.c + b1_66 * t420 + b1_68 * t423 - b1_70 * t425 - b1_73 * t426;
  const T t428 = z1_15 * (t419 + b1_76 * c.p.c - b1_81 * t420 - b1_83 * t423 - b1_85 * t425 - b1_87 * t426 - b1_92 *
      t427);
  const T t429 = b1_91 * t427 - b1_92 * t428;
  const T t430 = b1_72 * t426 - b1_73 * t429 - b1_87 * t428;
  const T t431 = b1_57 * t425 + b1_58 * t430 - b1_70 * t429 - b1_85 * t428;
  const T t432 = b1_83 * t428 - b1_53 * t423 - b1_54 * t431 - b1_55 * t430 - b1_68 * t429;
  const T t433 = b1_48 * t420 - b1_49 * t432 - b1_51 * t431 + b1_66 * t429 - b1_81 * t428;
  S[174] = t433;
  const T t434 = T(9) * t224;
  const T t435 = E3_23 * t434;
  const T t436 = T(0.6) * t435 + b1_45 * c.p.c;
  const T t437 = omega3_2 + omega3_2;
  const T t438 = T(12) * t437;
  const T t439 = E3_23 * t438 + b1_49 * t436;
  const T t440 = T(9) * t437;
  const T t441 = E3_22 * t438 + T(0.6) * t440 - b1_51 * t436 + b1_54 * t439;
  const T t442 = t440 + b1_55 * t439 + b1_58 * t441;
  const T t443 = b1_59 * c.p.c - E3_22 * t434 + b1_66 * t436 + b1_68 * t439 - b1_70 * t441 - b1_73 * t442;
  const T t444 = z1_15 * (b1_83 * t439 + t435 + b1_74 * c.p.c + b1_81 * t436 + b1_85 * t441 + b1_87 * t442 + b1_92 *
      t443);
  const T t445 = b1_91 * t443 + b1_92 * t444;
  const T t446 = b1_72 * t442 - b1_73 * t445 + b1_87 * t444;
  const T t447 = b1_57 * t441 + b1_58 * t446 - b1_70 * t445 + b1_85 * t444;
  const T t448 = b1_53 * t439 + b1_54 * t447 + b1_55 * t446 + b1_68 * t445 + b1_83 * t444;
  const T t449 = b1_48 * t436 + b1_49 * t448 - b1_51 * t447 + b1_66 * t445 + b1_81 * t444;
  S[175] = t449;
  const T t450 = omega4_2 * T(0.5773502691896257);
  const T t451 = omega4_3 * T(0.5773502691896257);
  const T t452 = t450 + t451;
  const T t453 = t452 - t4_11;
  const T t454 = t452 + t4_11;
  const T t455 = T(1.1547005383792515) * omega4_3;
  const T t456 = T(1.1547005383792515) * omega4_1;
  const T t457 = t455 + t456;
  const T t458 = T(1.1547005383792515) * omega4_2;
  const T t459 = t458 + t456;
  const T t460 = omega4_1 * T(0.5773502691896257);
  const T t461 = t460 + t451;
  const T t462 = t461 + t4_13;
  const T t463 = t460 + t450;
  const T t464 = t463 - t4_14;
  const T t465 = T(0.0079) * t453 - T(0.0079) * t454 - T(0.0021) * (t457 - t459) - T(0.0021) * t462 + T(0.0021) *
      t464;
  const T t466 = t461 - t4_13;
  const T t467 = t455 + t458;
  const T t468 = t463 + t4_14;
  const T t469 = T(0.0079) * t466 - T(0.0079) * t462 - T(0.0021) * (t459 - t467) - T(0.0021) * t468 + T(0.0021) *
      t453;
  const T t470 = T(0.0079) * t464 - T(0.0079) * t468 - T(0.0021) * (t467 - t457) - T(0.0021) * t454 + T(0.0021) *
      t466;
  const T t471 = T(0.5773502691896257) * t465 + T(0.5773502691896257) * t469 + T(0.5773502691896257) * t470;
  const T t472 = b1_43 * t471;
  const T t473 = t472 - E4_11 * t465 - E4_13 * t469 - E4_12 * t470;
  const T t474 = t472 - E4_12 * t465 - E4_11 * t469 - E4_13 * t470 - b1_49 * t473;
  const T t475 = t472 - E4_13 * t465 - E4_12 * t469 - E4_11 * t470 - b1_51 * t473 - b1_54 * t474;
  const T t476 = b1_58 * t475 - b1_55 * t474;
  const T t477 = b1_66 * t473 - b1_68 * t474 - b1_70 * t475 - b1_73 * t476;
  const T t478 = z1_15 * (b1_83 * t474 - b1_81 * t473 - b1_85 * t475 - b1_87 * t476 - b1_92 * t477);
  const T t479 = b1_91 * t477 - b1_92 * t478;
  const T t480 = b1_72 * t476 - b1_73 * t479 - b1_87 * t478;
  const T t481 = b1_57 * t475 + b1_58 * t480 - b1_70 * t479 - b1_85 * t478;
  const T t482 = b1_53 * t474 - b1_54 * t481 - b1_55 * t480 - b1_68 * t479 + b1_83 * t478;
  const T t483 = b1_48 * t473 - b1_49 * t482 - b1_51 * t481 + b1_66 * t479 - b1_81 * t478;
  S[176] = t483;
  S[183] = t58;
  S[184] = t111;
  S[185] = t216;
  S[189] = t290;
  S[190] = t362;
  S[191] = t416;
  S[192] = t432;
  S[193] = -t448;
  S[194] = t482;
  S[201] = t57;
  S[202] = t110;
  S[203] = t215;
  S[207] = t289;
  S[208] = t361;
  S[209] = t415;
  S[210] = t431;
  S[211] = t447;
  S[212] = t481;
  S[219] = z1_17 * b1_76 + b1_61 * t55 - T(0.08333333333333333) * t4 - b1_46 * t59 + omegadot1_1 * t7 - b1_76 * t54 +
      z1_16 * b1_61;
  S[220] = -(b1_46 * t112 - b1_61 * t108 + b1_76 * t107);
  S[221] = -(b1_46 * t217 - b1_61 * t213 + b1_76 * t212);
  S[225] = b1_61 * t287 - T(0.08333333333333333) * t221 - b1_46 * t291 - b1_76 * t286;
  S[226] = b1_61 * t359 - T(0.08333333333333333) * t318 - b1_46 * t363 - b1_76 * t358;
  S[227] = b1_61 * t413 - T(0.08333333333333333) * t373 - b1_46 * t417 - b1_76 * t412;
  S[228] = b1_61 * t429 - c.c0_1 - b1_46 * t433 - b1_76 * t428;
  S[229] = -(b1_46 * t449 - b1_61 * t445 - b1_76 * t444);
  S[230] = -(b1_46 * t483 - b1_61 * t479 + b1_76 * t478);
  S[237] = -(b1_45 * t59 + b1_59 * t55 - b1_74 * t54);
  S[238] = -(T(0.08333333333333333) * t69 + b1_45 * t112 - omegadot1_1 * t61 + z1_17 * b1_74 + b1_59 * t108 + z1_16 *
      b1_59 - b1_74 * t107);
  S[239] = -(b1_45 * t217 + b1_59 * t213 - b1_74 * t212);
  S[243] = -(T(0.08333333333333333) * t223 + b1_45 * t291 + b1_59 * t287 - b1_74 * t286);
  S[244] = -(T(0.08333333333333333) * t325 + b1_45 * t363 + b1_59 * t359 - b1_74 * t358);
  S[245] = -(T(0.08333333333333333) * t378 + b1_45 * t417 + b1_59 * t413 - b1_74 * t412);
  S[246] = -(b1_45 * t433 + b1_59 * t429 - b1_74 * t428);
  S[247] = -(b1_74 * t444 + c.c0_1 + b1_45 * t449 + b1_59 * t445);
  S[248] = -(b1_45 * t483 + b1_59 * t479 - b1_74 * t478);
  S[255] = -(b1_43 * t59 + b1_43 * t58 + b1_43 * t57);
  S[256] = -(b1_43 * t112 + b1_43 * t111 + b1_43 * t110);
  S[257] = -(T(50) * t172 + omegadot1_1 * t136 + b1_43 * t217 + z1_19 * t136 + b1_43 * t216 + z1_18 * t136 + b1_43 *
      t215);
  S[261] = -(T(50) * t270 + b1_43 * t291 + b1_43 * t290 + b1_43 * t289);
  S[262] = -(T(50) * t310 + b1_43 * t363 + b1_43 * t362 + b1_43 * t361);
  S[263] = -(T(50) * t398 + b1_43 * t417 + b1_43 * t416 + b1_43 * t415);
  S[264] = -(b1_43 * t433 + b1_43 * t432 + b1_43 * t431);
  S[265] = -(b1_43 * t449 - b1_43 * t448 + b1_43 * t447);
  S[266] = -(T(50) * t471 + b1_43 * t483 + b1_43 * t482 + b1_43 * t481);
  const T t484 = T(0.5) * eps1_2;
  const T t485 = T(2) * t484;
  const T t486 = eps1_3 * t485;
  const T t487 = t1_3 * t484;
  const T t488 = t486 + t487;
  const T t489 = T(0.5) * eps1_3;
  const T t490 = T(2) * t489;
  const T t491 = eps1_2 * t490;
  const T t492 = t1_1 * t489;
  const T t493 = t491 + t492;
  const T t494 = T(0.5) * eps1_4;
  const T t495 = T(2) * t494;
  const T t496 = eps1_2 * t495;
  const T t497 = t1_5 * t489;
  const T t498 = t496 + t497;
  const T t499 = eps1_4 * t485;
  const T t500 = T(0.5) * eps1_1;
  const T t501 = t1_3 * t500;
  const T t502 = t499 + t501;
  const T t503 = eps1_3 * t495;
  const T t504 = t1_5 * t484;
  const T t505 = t503 - t504;
  const T t506 = eps1_4 * t490;
  const T t507 = t1_1 * t500;
  const T t508 = t506 - t507;
  S[270] = Pddot1_1 * (t488 - t493) + z1_17 * (t498 + t502) + z1_16 * (t505 + t508);
  const T t509 = t1_5 * t494;
  const T t510 = t509 - t491;
  const T t511 = T(2) * t500;
  const T t512 = eps1_4 * t511;
  const T t513 = t512 - t487;
  const T t514 = t1_1 * t494;
  const T t515 = t496 + t514;
  const T t516 = eps1_3 * t511;
  const T t517 = t516 + t501;
  const T t518 = t1_5 * t500;
  const T t519 = eps1_3 * t490;
  const T t520 = t518 - t519;
  const T t521 = eps1_4 * t495;
  const T t522 = t1_1 * t484;
  const T t523 = t521 - t522;
  S[271] = z1_17 * (t510 - t513) - Pddot1_1 * (t515 + t517) + z1_16 * (t520 + t523);
  const T t524 = eps1_2 * t511 + t507;
  const T t525 = t503 + t1_3 * t494;
  const T t526 = eps1_2 * t485 - t518;
  const T t527 = t521 - t1_3 * t489;
  const T t528 = t486 + t509;
  const T t529 = t512 + t492;
  S[272] = Pddot1_1 * (t524 - t525) + z1_17 * (t526 - t527) + z1_16 * (t528 - t529);
  S[273] = R1_11 * t56 + R1_21 * t55 + R1_31 * t54;
  S[274] = R1_11 * t109 + R1_21 * t108 + R1_31 * t107;
  S[275] = R1_11 * t214 + R1_21 * t213 + R1_31 * t212;
  S[279] = R1_11 * t288 + R1_21 * t287 + R1_31 * t286;
  S[280] = R1_11 * t360 + R1_21 * t359 + R1_31 * t358;
  S[281] = R1_11 * t414 + R1_21 * t413 + R1_31 * t412;
  S[282] = R1_11 * t430 + R1_21 * t429 + R1_31 * t428;
  S[283] = R1_11 * t446 + R1_21 * t445 - R1_31 * t444;
  S[284] = R1_11 * t480 + R1_21 * t479 + R1_31 * t478;
  const T t530 = eps1_1 * t495 + t509;
  const T t531 = t519 - t522;
  const T t532 = t521 - t518;
  S[288] = Pddot1_1 * (t498 - t502) + z1_17 * (t488 - t530) + z1_16 * (t531 - t532);
  const T t533 = eps1_1 * t490 + t497;
  const T t534 = t503 + t507;
  const T t535 = t506 + t504;
  S[289] = Pddot1_1 * (t510 + t513) + z1_17 * (t533 - t517) + z1_16 * (t534 + t535);
  const T t536 = eps1_1 * t485 + t504;
  const T t537 = t514 - t516;
  const T t538 = t499 - t497;
  S[290] = Pddot1_1 * (t526 + t527) - z1_17 * (t536 + t525) + z1_16 * (t537 - t538);
  S[291] = R1_12 * t56 + R1_22 * t55 + R1_32 * t54;
  S[292] = R1_12 * t109 + R1_22 * t108 + R1_32 * t107;
  S[293] = R1_12 * t214 + R1_22 * t213 + R1_32 * t212;
  S[297] = R1_12 * t288 + R1_22 * t287 + R1_32 * t286;
  S[298] = R1_12 * t360 + R1_22 * t359 + R1_32 * t358;
  S[299] = R1_12 * t414 + R1_22 * t413 + R1_32 * t412;
  S[300] = R1_12 * t430 + R1_22 * t429 + R1_32 * t428;
  S[301] = R1_12 * t446 + R1_22 * t445 - R1_32 * t444;
  S[302] = R1_12 * t480 + R1_22 * t479 + R1_32 * t478;
  S[306] = Pddot1_1 * (t505 - t508) + z1_17 * (t531 + t532) - z1_16 * (t530 + t493);
  S[307] = Pddot1_1 * (t520 - t523) + z1_17 * (t534 - t535) + z1_16 * (t533 - t515);
  S[308] = Pddot1_1 * (t528 + t529) + z1_17 * (t537 + t538) + z1_16 * (t524 - t536);
  S[309] = R1_13 * t56 + R1_23 * t55 + R1_33 * t54;
  S[310] = R1_13 * t109 + R1_23 * t108 + R1_33 * t107;
  S[311] = R1_13 * t214 + R1_23 * t213 + R1_33 * t212;
  S[315] = R1_13 * t288 + R1_23 * t287 + R1_33 * t286;
  S[316] = R1_13 * t360 + R1_23 * t359 + R1_33 * t358;
  S[317] = R1_13 * t414 + R1_23 * t413 + R1_33 * t412;
  S[318] = R1_13 * t430 + R1_23 * t429 + R1_33 * t428;
  S[319] = R1_13 * t446 + R1_23 * t445 - R1_33 * t444;
  S[320] = R1_13 * t480 + R1_23 * t479 + R1_33 * t478;
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
  const T t18 = b1_53 * t14 - b1_32 * t17 - b1_33 * t16 - b1_42 * t15;
  const T t19 = b1_40 * t15 - b1_27 * t18 - b1_29 * t17 - b1_51 * t14;
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
