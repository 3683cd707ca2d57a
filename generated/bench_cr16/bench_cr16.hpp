// SPDX-License-Identifier: BSD-3-Clause
// bench_cr16: equations of motion of 16 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model df8d578e4eee72e8 of bench_cr16/scene.toml; functions kinematics energy accelerations residual mass_matrix
// bodies and their joints:
//   1 body_1 on the inertial frame: revolute
//   2 body_2 on 1: revolute
//   3 body_3 on 2: revolute
//   4 body_4 on 3: revolute
//   5 body_5 on 4: revolute
//   6 body_6 on 5: revolute
//   7 body_7 on 6: revolute
//   8 body_8 on 7: revolute
//   9 body_9 on 8: revolute
//   10 body_10 on 9: revolute
//   11 body_11 on 10: revolute
//   12 body_12 on 11: revolute
//   13 body_13 on 12: revolute
//   14 body_14 on 13: revolute
//   15 body_15 on 14: revolute
//   16 body_16 on 15: revolute
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (theta_1, theta_2, theta_3, theta_4, theta_5, theta_6, theta_7, theta_8, theta_9, theta_10, theta_11,
//   theta_12, theta_13, theta_14, theta_15, theta_16)
//   y = (thetadot_1, thetadot_2, thetadot_3, thetadot_4, thetadot_5, thetadot_6, thetadot_7, thetadot_8, thetadot_9,
//   thetadot_10, thetadot_11, thetadot_12, thetadot_13, thetadot_14, thetadot_15, thetadot_16)
//   theta     angle of a joint about its axis [rad]
//   thetadot  rate of theta [rad/s]
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one, and of
// its own or by conversion cos, sin.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              0 (0 add, 0 multiply)
//   energy                  1749 (757 add, 992 multiply, 32 sine or cosine)
//   accelerations           7540 (3598 add, 3927 multiply, 15 divide, 32 sine or cosine)
//   residual                2229 (1105 add, 1124 multiply, 32 sine or cosine)
//   mass_matrix             3371 (1609 add, 1762 multiply, 30 sine or cosine)
#pragma once

#include <cmath>

namespace kanec::bench_cr16 {

inline constexpr int n_bodies = 16;
inline constexpr int nx = 16;
inline constexpr int ny = 16;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 16;
inline constexpr char model_hash[] = "df8d578e4eee72e8";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_1 = 0, theta_2 = 1, theta_3 = 2, theta_4 = 3, theta_5 = 4, theta_6 = 5, theta_7 = 6,
    theta_8 = 7, theta_9 = 8, theta_10 = 9, theta_11 = 10, theta_12 = 11, theta_13 = 12, theta_14 = 13, theta_15 = 14,
    theta_16 = 15;
inline constexpr int thetadot_1 = 0, thetadot_2 = 1, thetadot_3 = 2, thetadot_4 = 3, thetadot_5 = 4, thetadot_6 = 5,
    thetadot_7 = 6, thetadot_8 = 7, thetadot_9 = 8, thetadot_10 = 9, thetadot_11 = 10, thetadot_12 = 11,
    thetadot_13 = 12, thetadot_14 = 13, thetadot_15 = 14, thetadot_16 = 15;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 256;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6,
    6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8,
    8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10,
    10, 10, 10, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 12, 12, 12, 12, 12, 12, 12, 12, 12,
    12, 12, 12, 12, 12, 12, 12, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 14, 14, 14, 14, 14,
    14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5,
    6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7,
    8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9,
    10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
    11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11,
    12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12,
    13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13,
    14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14,
    15};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
  T tau_1 = T(0);
  T tau_2 = T(0);
  T tau_3 = T(0);
  T tau_4 = T(0);
  T tau_5 = T(0);
  T tau_6 = T(0);
  T tau_7 = T(0);
  T tau_8 = T(0);
  T tau_9 = T(0);
  T tau_10 = T(0);
  T tau_11 = T(0);
  T tau_12 = T(0);
  T tau_13 = T(0);
  T tau_14 = T(0);
  T tau_15 = T(0);
  T tau_16 = T(0);
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
// 0 add, 0 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* xdot) noexcept {
  const T thetadot1 = y[0];
  const T thetadot2 = y[1];
  const T thetadot3 = y[2];
  const T thetadot4 = y[3];
  const T thetadot5 = y[4];
  const T thetadot6 = y[5];
  const T thetadot7 = y[6];
  const T thetadot8 = y[7];
  const T thetadot9 = y[8];
  const T thetadot10 = y[9];
  const T thetadot11 = y[10];
  const T thetadot12 = y[11];
  const T thetadot13 = y[12];
  const T thetadot14 = y[13];
  const T thetadot15 = y[14];
  const T thetadot16 = y[15];
  xdot[0] = thetadot1;
  xdot[1] = thetadot2;
  xdot[2] = thetadot3;
  xdot[3] = thetadot4;
  xdot[4] = thetadot5;
  xdot[5] = thetadot6;
  xdot[6] = thetadot7;
  xdot[7] = thetadot8;
  xdot[8] = thetadot9;
  xdot[9] = thetadot10;
  xdot[10] = thetadot11;
  xdot[11] = thetadot12;
  xdot[12] = thetadot13;
  xdot[13] = thetadot14;
  xdot[14] = thetadot15;
  xdot[15] = thetadot16;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 757 add, 992 multiply, 32 sine or cosine
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (body_1) on the inertial frame
  const T theta1 = x[0];
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T t1_1 = E1_11 * T(0.05);
  const T p1_3 = t1_1 - minus_E1_13 * T(0.1);
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_2 = thetadot1 * T(0.05);
  const T t1_3 = thetadot1 * T(0.1);
  const T t1_4 = minus_E1_13 * t1_3;
  const T v1_1 = E1_11 * t1_2 - t1_4;
  const T t1_5 = E1_11 * t1_3;
  const T minus_v1_3 = minus_E1_13 * t1_2 + t1_5;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.132) * thetadot1 * thetadot1 * T(0.5) + T(0.55) * (v1_1 * v1_1 + minus_v1_3 * minus_v1_3);

  // ---- body 2 (body_2) on body 1
  const T theta2 = x[1];
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T E2_12 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T minus_R2_13 = minus_E1_13 * E2_11;
  const T minus_R2_21 = E1_11 * E2_12;
  const T R2_23 = minus_E1_13 * E2_12;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = E2_12 * thetadot1;
  const T omega2_2 = E2_11 * thetadot1;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T t2_1 = E1_11 * T(0.1);
  const T P2_3 = t2_1 - minus_E1_13 * T(0.3);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_2 = minus_R2_13 * T(0.1);
  const T p2_3 = R2_23 * T(0.2) - t2_2 + t1_1 + P2_3;
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_3 = thetadot1 * T(0.3);
  const T Pdot2_1 = t1_5 - minus_E1_13 * t2_3;
  const T minus_Pdot2_3 = t1_4 + E1_11 * t2_3;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_4 = omega2_2 * T(0.05) - thetadot2 * T(0.2);
  const T t2_5 = thetadot2 * T(0.1) - omega2_1 * T(0.05);
  const T t2_6 = omega2_2 * T(0.1);
  const T t2_7 = omega2_1 * T(0.2) - t2_6;
  const T v2_1 = R2_11 * t2_4 - minus_R2_21 * t2_5 + minus_E1_13 * t2_7 + Pdot2_1;
  const T v2_2 = E2_12 * t2_4 + E2_11 * t2_5;
  const T v2_3 = R2_23 * t2_5 - minus_R2_13 * t2_4 + E1_11 * t2_7 - minus_Pdot2_3;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (omega2_1 * (T(0.12) * omega2_1 + T(0.006) * omega2_2 + T(0.0036) * thetadot2) + omega2_2 *
      (T(0.006) * omega2_1 + T(0.144) * omega2_2 - T(0.0048) * thetadot2) + thetadot2 * (T(0.0036) * omega2_1 -
      T(0.0048) * omega2_2 + T(0.096) * thetadot2)) + T(0.6) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (body_3) on body 2
  const T theta3 = x[2];
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_21 = minus_E1_13 * E3_23 - minus_R2_21 * E3_22;
  const T R3_22 = E2_11 * E3_22;
  const T R3_23 = R2_23 * E3_22 + E1_11 * E3_23;
  const T R3_31 = minus_R2_21 * E3_23 + minus_E1_13 * E3_22;
  const T minus_R3_32 = E2_11 * E3_23;
  const T R3_33 = E1_11 * E3_22 - R2_23 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega2_1;
  const T omega3_2 = E3_22 * omega2_2 + E3_23 * thetadot2;
  const T omega3_3 = E3_22 * thetadot2 - E3_23 * omega2_2;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T t3_1 = minus_R2_13 * T(0.3);
  const T P3_3 = R2_23 * T(0.15) - t3_1 + t2_1 + P2_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T t3_2 = R3_23 * T(0.2);
  const T t3_3 = t3_2 + P3_3;
  const T p3_3 = t3_3 - t2_2 + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_4 = t2_6 - thetadot2 * T(0.15);
  const T t3_5 = thetadot2 * T(0.3) - omega2_1 * T(0.1);
  const T t3_6 = omega2_1 * T(0.15) - omega2_2 * T(0.3);
  const T Pdot3_1 = R2_11 * t3_4 - minus_R2_21 * t3_5 + minus_E1_13 * t3_6 + Pdot2_1;
  const T Pdot3_2 = E2_12 * t3_4 + E2_11 * t3_5;
  const T Pdot3_3 = R2_23 * t3_5 - minus_R2_13 * t3_4 + E1_11 * t3_6 - minus_Pdot2_3;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_7 = omega3_3 * T(0.2);
  const T t3_8 = omega3_2 * T(0.05) - t3_7;
  const T t3_9 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_10 = omega3_1 * T(0.2);
  const T t3_11 = omega3_2 * T(0.1);
  const T t3_12 = t3_10 - t3_11;
  const T v3_1 = R2_11 * t3_8 + R3_21 * t3_9 + R3_31 * t3_12 + Pdot3_1;
  const T v3_2 = E2_12 * t3_8 + R3_22 * t3_9 - minus_R3_32 * t3_12 + Pdot3_2;
  const T v3_3 = R3_23 * t3_9 - minus_R2_13 * t3_8 + R3_33 * t3_12 + Pdot3_3;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (omega3_1 * (T(0.13) * omega3_1 + T(0.0065) * omega3_2 + T(0.0039) * omega3_3) + omega3_2 *
      (T(0.0065) * omega3_1 + T(0.156) * omega3_2 - T(0.0052) * omega3_3) + omega3_3 * (T(0.0039) * omega3_1 -
      T(0.0052) * omega3_2 + T(0.104) * omega3_3)) + T(0.65) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (body_4) on body 3
  const T theta4 = x[3];
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cos(theta4);
  const T minus_E4_13 = sin(theta4);
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R2_11 * E4_11 - R3_31 * minus_E4_13;
  const T R4_12 = E2_12 * E4_11 + minus_R3_32 * minus_E4_13;
  const T minus_R4_13 = minus_R2_13 * E4_11 + R3_33 * minus_E4_13;
  const T R4_31 = R2_11 * minus_E4_13 + R3_31 * E4_11;
  const T R4_32 = E2_12 * minus_E4_13 - minus_R3_32 * E4_11;
  const T R4_33 = R3_33 * E4_11 - minus_R2_13 * minus_E4_13;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 - minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  const T omega4_3 = minus_E4_13 * omega3_1 + E4_11 * omega3_3;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_3 = t3_3 - t3_1 + R3_33 * T(0.1);
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T t4_1 = R4_33 * T(0.05);
  const T p4_3 = t3_2 - minus_R4_13 * T(0.1) + t4_1 + P4_3;
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_2 = t3_11 - t3_7;
  const T t4_3 = omega3_3 * T(0.3) - omega3_1 * T(0.1);
  const T t4_4 = t3_10 - omega3_2 * T(0.3);
  const T Pdot4_1 = R2_11 * t4_2 + R3_21 * t4_3 + R3_31 * t4_4 + Pdot3_1;
  const T Pdot4_2 = E2_12 * t4_2 + R3_22 * t4_3 - minus_R3_32 * t4_4 + Pdot3_2;
  const T Pdot4_3 = R3_23 * t4_3 - minus_R2_13 * t4_2 + R3_33 * t4_4 + Pdot3_3;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_5 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_6 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_7 = omega4_2 * T(0.1);
  const T t4_8 = omega4_1 * T(0.2) - t4_7;
  const T v4_1 = R4_11 * t4_5 + R3_21 * t4_6 + R4_31 * t4_8 + Pdot4_1;
  const T v4_2 = R4_12 * t4_5 + R3_22 * t4_6 + R4_32 * t4_8 + Pdot4_2;
  const T v4_3 = R3_23 * t4_6 - minus_R4_13 * t4_5 + R4_33 * t4_8 + Pdot4_3;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (omega4_1 * (T(0.14) * omega4_1 + T(0.007) * omega4_2 + T(0.0042) * omega4_3) + omega4_2 *
      (T(0.007) * omega4_1 + T(0.168) * omega4_2 - T(0.0056) * omega4_3) + omega4_3 * (T(0.0042) * omega4_1 -
      T(0.0056) * omega4_2 + T(0.112) * omega4_3)) + T(0.7) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (body_5) on body 4
  const T theta5 = x[4];
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cos(theta5);
  const T E5_12 = sin(theta5);
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 + R3_21 * E5_12;
  const T R5_12 = R4_12 * E5_11 + R3_22 * E5_12;
  const T R5_13 = R3_23 * E5_12 - minus_R4_13 * E5_11;
  const T R5_21 = R3_21 * E5_11 - R4_11 * E5_12;
  const T R5_22 = R3_22 * E5_11 - R4_12 * E5_12;
  const T R5_23 = minus_R4_13 * E5_12 + R3_23 * E5_11;
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 + E5_12 * omega4_2;
  const T omega5_2 = E5_11 * omega4_2 - E5_12 * omega4_1;
  const T omega5_3 = thetadot5 + omega4_3;
  // P5 = R4^T q5 + P4: position of the body origin, inertial axes [m]
  const T t5_1 = R4_33 * T(0.1);
  const T P5_3 = R3_23 * T(0.25) - minus_R4_13 * T(0.3) + t5_1 + P4_3;
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T t5_2 = R5_13 * T(0.1);
  const T p5_3 = t5_2 + R5_23 * T(0.2) + t4_1 + P5_3;
  // Pdot5 = R4^T omega4~ q5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t5_3 = t4_7 - omega4_3 * T(0.25);
  const T t5_4 = omega4_3 * T(0.3) - omega4_1 * T(0.1);
  const T t5_5 = omega4_1 * T(0.25) - omega4_2 * T(0.3);
  const T Pdot5_1 = R4_11 * t5_3 + R3_21 * t5_4 + R4_31 * t5_5 + Pdot4_1;
  const T Pdot5_2 = R4_12 * t5_3 + R3_22 * t5_4 + R4_32 * t5_5 + Pdot4_2;
  const T Pdot5_3 = R3_23 * t5_4 - minus_R4_13 * t5_3 + R4_33 * t5_5 + Pdot4_3;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_6 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_7 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_8 = omega5_2 * T(0.1);
  const T t5_9 = omega5_1 * T(0.2) - t5_8;
  const T v5_1 = R5_11 * t5_6 + R5_21 * t5_7 + R4_31 * t5_9 + Pdot5_1;
  const T v5_2 = R5_12 * t5_6 + R5_22 * t5_7 + R4_32 * t5_9 + Pdot5_2;
  const T v5_3 = R5_13 * t5_6 + R5_23 * t5_7 + R4_33 * t5_9 + Pdot5_3;
  // T5 = 1/2 omega5 . (I5 omega5) + 1/2 m5 v5 . v5: kinetic energy [J]
  const T T5 = T(0.5) * (omega5_1 * (T(0.15) * omega5_1 + T(0.0075) * omega5_2 + T(0.0045) * omega5_3) + omega5_2 *
      (T(0.0075) * omega5_1 + T(0.18) * omega5_2 - T(0.006) * omega5_3) + omega5_3 * (T(0.0045) * omega5_1 - T(0.006)
      * omega5_2 + T(0.12) * omega5_3)) + T(0.75) * (v5_1 * v5_1 + v5_2 * v5_2 + v5_3 * v5_3);

  // ---- body 6 (body_6) on body 5
  const T theta6 = x[5];
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cos(theta6);
  const T E6_23 = sin(theta6);
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_21 = R5_21 * E6_22 + R4_31 * E6_23;
  const T R6_22 = R5_22 * E6_22 + R4_32 * E6_23;
  const T R6_23 = R5_23 * E6_22 + R4_33 * E6_23;
  const T R6_31 = R4_31 * E6_22 - R5_21 * E6_23;
  const T R6_32 = R4_32 * E6_22 - R5_22 * E6_23;
  const T R6_33 = R4_33 * E6_22 - R5_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega5_1;
  const T omega6_2 = E6_22 * omega5_2 + E6_23 * omega5_3;
  const T omega6_3 = E6_22 * omega5_3 - E6_23 * omega5_2;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T t6_1 = R5_13 * T(0.3);
  const T P6_3 = t6_1 + R5_23 * T(0.3) + t5_1 + P5_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T t6_2 = R6_23 * T(0.2);
  const T p6_3 = t5_2 + t6_2 + R6_33 * T(0.05) + P6_3;
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_3 = omega5_3 * T(0.3);
  const T t6_4 = t5_8 - t6_3;
  const T t6_5 = t6_3 - omega5_1 * T(0.1);
  const T t6_6 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = R5_11 * t6_4 + R5_21 * t6_5 + R4_31 * t6_6 + Pdot5_1;
  const T Pdot6_2 = R5_12 * t6_4 + R5_22 * t6_5 + R4_32 * t6_6 + Pdot5_2;
  const T Pdot6_3 = R5_13 * t6_4 + R5_23 * t6_5 + R4_33 * t6_6 + Pdot5_3;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_7 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_8 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_9 = omega6_2 * T(0.1);
  const T t6_10 = omega6_1 * T(0.2) - t6_9;
  const T v6_1 = R5_11 * t6_7 + R6_21 * t6_8 + R6_31 * t6_10 + Pdot6_1;
  const T v6_2 = R5_12 * t6_7 + R6_22 * t6_8 + R6_32 * t6_10 + Pdot6_2;
  const T v6_3 = R5_13 * t6_7 + R6_23 * t6_8 + R6_33 * t6_10 + Pdot6_3;
  // T6 = 1/2 omega6 . (I6 omega6) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (omega6_1 * (T(0.16) * omega6_1 + T(0.008) * omega6_2 + T(0.0048) * omega6_3) + omega6_2 *
      (T(0.008) * omega6_1 + T(0.192) * omega6_2 - T(0.0064) * omega6_3) + omega6_3 * (T(0.0048) * omega6_1 -
      T(0.0064) * omega6_2 + T(0.128) * omega6_3)) + T(0.8) * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- body 7 (body_7) on body 6
  const T theta7 = x[6];
  const T thetadot7 = y[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cos(theta7);
  const T minus_E7_13 = sin(theta7);
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R5_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R5_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R5_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R5_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R5_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R5_13 * minus_E7_13 + R6_33 * E7_11;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // P7 = R6^T q7 + P6: position of the body origin, inertial axes [m]
  const T P7_3 = t6_1 + R6_23 * T(0.35) + R6_33 * T(0.1) + P6_3;
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T t7_1 = R7_33 * T(0.05);
  const T p7_3 = R7_13 * T(0.1) + t6_2 + t7_1 + P7_3;
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_2 = t6_9 - omega6_3 * T(0.35);
  const T t7_3 = omega6_3 * T(0.3) - omega6_1 * T(0.1);
  const T t7_4 = omega6_1 * T(0.35) - omega6_2 * T(0.3);
  const T Pdot7_1 = R5_11 * t7_2 + R6_21 * t7_3 + R6_31 * t7_4 + Pdot6_1;
  const T Pdot7_2 = R5_12 * t7_2 + R6_22 * t7_3 + R6_32 * t7_4 + Pdot6_2;
  const T Pdot7_3 = R5_13 * t7_2 + R6_23 * t7_3 + R6_33 * t7_4 + Pdot6_3;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_5 = omega7_2 * T(0.05) - omega7_3 * T(0.2);
  const T t7_6 = omega7_3 * T(0.1) - omega7_1 * T(0.05);
  const T t7_7 = omega7_2 * T(0.1);
  const T t7_8 = omega7_1 * T(0.2) - t7_7;
  const T v7_1 = R7_11 * t7_5 + R6_21 * t7_6 + R7_31 * t7_8 + Pdot7_1;
  const T v7_2 = R7_12 * t7_5 + R6_22 * t7_6 + R7_32 * t7_8 + Pdot7_2;
  const T v7_3 = R7_13 * t7_5 + R6_23 * t7_6 + R7_33 * t7_8 + Pdot7_3;
  // T7 = 1/2 omega7 . (I7 omega7) + 1/2 m7 v7 . v7: kinetic energy [J]
  const T T7 = T(0.5) * (omega7_1 * (T(0.17) * omega7_1 + T(0.0085) * omega7_2 + T(0.0051) * omega7_3) + omega7_2 *
      (T(0.0085) * omega7_1 + T(0.204) * omega7_2 - T(0.0068) * omega7_3) + omega7_3 * (T(0.0051) * omega7_1 -
      T(0.0068) * omega7_2 + T(0.136) * omega7_3)) + T(0.85) * (v7_1 * v7_1 + v7_2 * v7_2 + v7_3 * v7_3);

  // ---- body 8 (body_8) on body 7
  const T theta8 = x[7];
  const T thetadot8 = y[7];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cos(theta8);
  const T E8_12 = sin(theta8);
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T R8_11 = R7_11 * E8_11 + R6_21 * E8_12;
  const T R8_12 = R7_12 * E8_11 + R6_22 * E8_12;
  const T R8_13 = R7_13 * E8_11 + R6_23 * E8_12;
  const T R8_21 = R6_21 * E8_11 - R7_11 * E8_12;
  const T R8_22 = R6_22 * E8_11 - R7_12 * E8_12;
  const T R8_23 = R6_23 * E8_11 - R7_13 * E8_12;
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega7_1 + E8_12 * omega7_2;
  const T omega8_2 = E8_11 * omega7_2 - E8_12 * omega7_1;
  const T omega8_3 = thetadot8 + omega7_3;
  // P8 = R7^T q8 + P7: position of the body origin, inertial axes [m]
  const T t8_1 = R7_33 * T(0.1);
  const T P8_3 = R7_13 * T(0.3) + R6_23 * T(0.4) + t8_1 + P7_3;
  // p8 = R8^T r8 + P8: position of the mass centre, inertial axes [m]
  const T t8_2 = R8_13 * T(0.1);
  const T p8_3 = t8_2 + R8_23 * T(0.2) + t7_1 + P8_3;
  // Pdot8 = R7^T omega7~ q8 + Pdot7: velocity of the body origin, inertial axes [m/s]
  const T t8_3 = t7_7 - omega7_3 * T(0.4);
  const T t8_4 = omega7_3 * T(0.3) - omega7_1 * T(0.1);
  const T t8_5 = omega7_1 * T(0.4) - omega7_2 * T(0.3);
  const T Pdot8_1 = R7_11 * t8_3 + R6_21 * t8_4 + R7_31 * t8_5 + Pdot7_1;
  const T Pdot8_2 = R7_12 * t8_3 + R6_22 * t8_4 + R7_32 * t8_5 + Pdot7_2;
  const T Pdot8_3 = R7_13 * t8_3 + R6_23 * t8_4 + R7_33 * t8_5 + Pdot7_3;
  // v8 = R8^T omega8~ r8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_6 = omega8_2 * T(0.05) - omega8_3 * T(0.2);
  const T t8_7 = omega8_3 * T(0.1) - omega8_1 * T(0.05);
  const T t8_8 = omega8_2 * T(0.1);
  const T t8_9 = omega8_1 * T(0.2) - t8_8;
  const T v8_1 = R8_11 * t8_6 + R8_21 * t8_7 + R7_31 * t8_9 + Pdot8_1;
  const T v8_2 = R8_12 * t8_6 + R8_22 * t8_7 + R7_32 * t8_9 + Pdot8_2;
  const T v8_3 = R8_13 * t8_6 + R8_23 * t8_7 + R7_33 * t8_9 + Pdot8_3;
  // T8 = 1/2 omega8 . (I8 omega8) + 1/2 m8 v8 . v8: kinetic energy [J]
  const T T8 = T(0.5) * (omega8_1 * (T(0.18) * omega8_1 + T(0.009) * omega8_2 + T(0.0054) * omega8_3) + omega8_2 *
      (T(0.009) * omega8_1 + T(0.216) * omega8_2 - T(0.0072) * omega8_3) + omega8_3 * (T(0.0054) * omega8_1 -
      T(0.0072) * omega8_2 + T(0.144) * omega8_3)) + T(0.9) * (v8_1 * v8_1 + v8_2 * v8_2 + v8_3 * v8_3);

  // ---- body 9 (body_9) on body 8
  const T theta9 = x[8];
  const T thetadot9 = y[8];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_22 = cos(theta9);
  const T E9_23 = sin(theta9);
  // R9^T = R8^T E9^T: R takes inertial components to body components
  const T R9_21 = R8_21 * E9_22 + R7_31 * E9_23;
  const T R9_22 = R8_22 * E9_22 + R7_32 * E9_23;
  const T R9_23 = R8_23 * E9_22 + R7_33 * E9_23;
  const T R9_31 = R7_31 * E9_22 - R8_21 * E9_23;
  const T R9_32 = R7_32 * E9_22 - R8_22 * E9_23;
  const T R9_33 = R7_33 * E9_22 - R8_23 * E9_23;
  // omega9 = thetadot9 b9 + E9 omega8: absolute angular velocity, body axes [rad/s]
  const T omega9_1 = thetadot9 + omega8_1;
  const T omega9_2 = E9_22 * omega8_2 + E9_23 * omega8_3;
  const T omega9_3 = E9_22 * omega8_3 - E9_23 * omega8_2;
  // P9 = R8^T q9 + P8: position of the body origin, inertial axes [m]
  const T t9_1 = R8_13 * T(0.3);
  const T P9_3 = t9_1 + R8_23 * T(0.45) + t8_1 + P8_3;
  // p9 = R9^T r9 + P9: position of the mass centre, inertial axes [m]
  const T t9_2 = R9_23 * T(0.2);
  const T p9_3 = t8_2 + t9_2 + R9_33 * T(0.05) + P9_3;
  // Pdot9 = R8^T omega8~ q9 + Pdot8: velocity of the body origin, inertial axes [m/s]
  const T t9_3 = t8_8 - omega8_3 * T(0.45);
  const T t9_4 = omega8_3 * T(0.3) - omega8_1 * T(0.1);
  const T t9_5 = omega8_1 * T(0.45) - omega8_2 * T(0.3);
  const T Pdot9_1 = R8_11 * t9_3 + R8_21 * t9_4 + R7_31 * t9_5 + Pdot8_1;
  const T Pdot9_2 = R8_12 * t9_3 + R8_22 * t9_4 + R7_32 * t9_5 + Pdot8_2;
  const T Pdot9_3 = R8_13 * t9_3 + R8_23 * t9_4 + R7_33 * t9_5 + Pdot8_3;
  // v9 = R9^T omega9~ r9 + Pdot9: velocity of the mass centre, inertial axes [m/s]
  const T t9_6 = omega9_2 * T(0.05) - omega9_3 * T(0.2);
  const T t9_7 = omega9_3 * T(0.1) - omega9_1 * T(0.05);
  const T t9_8 = omega9_2 * T(0.1);
  const T t9_9 = omega9_1 * T(0.2) - t9_8;
  const T v9_1 = R8_11 * t9_6 + R9_21 * t9_7 + R9_31 * t9_9 + Pdot9_1;
  const T v9_2 = R8_12 * t9_6 + R9_22 * t9_7 + R9_32 * t9_9 + Pdot9_2;
  const T v9_3 = R8_13 * t9_6 + R9_23 * t9_7 + R9_33 * t9_9 + Pdot9_3;
  // T9 = 1/2 omega9 . (I9 omega9) + 1/2 m9 v9 . v9: kinetic energy [J]
  const T T9 = T(0.5) * (omega9_1 * (T(0.19) * omega9_1 + T(0.0095) * omega9_2 + T(0.0057) * omega9_3) + omega9_2 *
      (T(0.0095) * omega9_1 + T(0.228) * omega9_2 - T(0.0076) * omega9_3) + omega9_3 * (T(0.0057) * omega9_1 -
      T(0.0076) * omega9_2 + T(0.152) * omega9_3)) + T(0.95) * (v9_1 * v9_1 + v9_2 * v9_2 + v9_3 * v9_3);

  // ---- body 10 (body_10) on body 9
  const T theta10 = x[9];
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_11 = cos(theta10);
  const T minus_E10_13 = sin(theta10);
  // R10^T = R9^T E10^T: R takes inertial components to body components
  const T R10_11 = R8_11 * E10_11 - R9_31 * minus_E10_13;
  const T R10_12 = R8_12 * E10_11 - R9_32 * minus_E10_13;
  const T R10_13 = R8_13 * E10_11 - R9_33 * minus_E10_13;
  const T R10_31 = R8_11 * minus_E10_13 + R9_31 * E10_11;
  const T R10_32 = R8_12 * minus_E10_13 + R9_32 * E10_11;
  const T R10_33 = R8_13 * minus_E10_13 + R9_33 * E10_11;
  // omega10 = thetadot10 b10 + E10 omega9: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = E10_11 * omega9_1 - minus_E10_13 * omega9_3;
  const T omega10_2 = thetadot10 + omega9_2;
  const T omega10_3 = minus_E10_13 * omega9_1 + E10_11 * omega9_3;
  // P10 = R9^T q10 + P9: position of the body origin, inertial axes [m]
  const T P10_3 = t9_1 + R9_23 * T(0.5) + R9_33 * T(0.1) + P9_3;
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T t10_1 = R10_33 * T(0.05);
  const T p10_3 = R10_13 * T(0.1) + t9_2 + t10_1 + P10_3;
  // Pdot10 = R9^T omega9~ q10 + Pdot9: velocity of the body origin, inertial axes [m/s]
  const T t10_2 = t9_8 - omega9_3 * T(0.5);
  const T t10_3 = omega9_3 * T(0.3) - omega9_1 * T(0.1);
  const T t10_4 = omega9_1 * T(0.5) - omega9_2 * T(0.3);
  const T Pdot10_1 = R8_11 * t10_2 + R9_21 * t10_3 + R9_31 * t10_4 + Pdot9_1;
  const T Pdot10_2 = R8_12 * t10_2 + R9_22 * t10_3 + R9_32 * t10_4 + Pdot9_2;
  const T Pdot10_3 = R8_13 * t10_2 + R9_23 * t10_3 + R9_33 * t10_4 + Pdot9_3;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_5 = omega10_2 * T(0.05) - omega10_3 * T(0.2);
  const T t10_6 = omega10_3 * T(0.1) - omega10_1 * T(0.05);
  const T t10_7 = T(0.2) * omega10_1;
  const T t10_8 = omega10_2 * T(0.1);
  const T t10_9 = t10_7 - t10_8;
  const T v10_1 = R10_11 * t10_5 + R9_21 * t10_6 + R10_31 * t10_9 + Pdot10_1;
  const T v10_2 = R10_12 * t10_5 + R9_22 * t10_6 + R10_32 * t10_9 + Pdot10_2;
  const T v10_3 = R10_13 * t10_5 + R9_23 * t10_6 + R10_33 * t10_9 + Pdot10_3;
  // T10 = 1/2 omega10 . (I10 omega10) + 1/2 m10 v10 . v10: kinetic energy [J]
  const T T10 = T(0.5) * (omega10_1 * (t10_7 + T(0.01) * omega10_2 + T(0.006) * omega10_3) + omega10_2 * (T(0.01) *
      omega10_1 + T(0.24) * omega10_2 - T(0.008) * omega10_3) + omega10_3 * (T(0.006) * omega10_1 - T(0.008) *
      omega10_2 + T(0.16) * omega10_3)) + v10_1 * v10_1 + v10_2 * v10_2 + v10_3 * v10_3;

  // ---- body 11 (body_11) on body 10
  const T theta11 = x[10];
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cos(theta11);
  const T E11_12 = sin(theta11);
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R10_11 * E11_11 + R9_21 * E11_12;
  const T R11_12 = R10_12 * E11_11 + R9_22 * E11_12;
  const T R11_13 = R10_13 * E11_11 + R9_23 * E11_12;
  const T R11_21 = R9_21 * E11_11 - R10_11 * E11_12;
  const T R11_22 = R9_22 * E11_11 - R10_12 * E11_12;
  const T R11_23 = R9_23 * E11_11 - R10_13 * E11_12;
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 + E11_12 * omega10_2;
  const T omega11_2 = E11_11 * omega10_2 - E11_12 * omega10_1;
  const T omega11_3 = thetadot11 + omega10_3;
  // P11 = R10^T q11 + P10: position of the body origin, inertial axes [m]
  const T t11_1 = R10_33 * T(0.1);
  const T P11_3 = R10_13 * T(0.3) + R9_23 * T(0.55) + t11_1 + P10_3;
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T t11_2 = R11_13 * T(0.1);
  const T p11_3 = t11_2 + R11_23 * T(0.2) + t10_1 + P11_3;
  // Pdot11 = R10^T omega10~ q11 + Pdot10: velocity of the body origin, inertial axes [m/s]
  const T t11_3 = t10_8 - omega10_3 * T(0.55);
  const T t11_4 = omega10_3 * T(0.3) - omega10_1 * T(0.1);
  const T t11_5 = omega10_1 * T(0.55) - omega10_2 * T(0.3);
  const T Pdot11_1 = R10_11 * t11_3 + R9_21 * t11_4 + R10_31 * t11_5 + Pdot10_1;
  const T Pdot11_2 = R10_12 * t11_3 + R9_22 * t11_4 + R10_32 * t11_5 + Pdot10_2;
  const T Pdot11_3 = R10_13 * t11_3 + R9_23 * t11_4 + R10_33 * t11_5 + Pdot10_3;
  // v11 = R11^T omega11~ r11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_6 = omega11_2 * T(0.05) - omega11_3 * T(0.2);
  const T t11_7 = omega11_3 * T(0.1) - omega11_1 * T(0.05);
  const T t11_8 = omega11_2 * T(0.1);
  const T t11_9 = omega11_1 * T(0.2) - t11_8;
  const T v11_1 = R11_11 * t11_6 + R11_21 * t11_7 + R10_31 * t11_9 + Pdot11_1;
  const T v11_2 = R11_12 * t11_6 + R11_22 * t11_7 + R10_32 * t11_9 + Pdot11_2;
  const T v11_3 = R11_13 * t11_6 + R11_23 * t11_7 + R10_33 * t11_9 + Pdot11_3;
  // T11 = 1/2 omega11 . (I11 omega11) + 1/2 m11 v11 . v11: kinetic energy [J]
  const T T11 = T(0.5) * (omega11_1 * (T(0.21) * omega11_1 + T(0.0105) * omega11_2 + T(0.0063) * omega11_3) +
      omega11_2 * (T(0.0105) * omega11_1 + T(0.252) * omega11_2 - T(0.0084) * omega11_3) + omega11_3 * (T(0.0063) *
      omega11_1 - T(0.0084) * omega11_2 + T(0.168) * omega11_3)) + T(1.05) * (v11_1 * v11_1 + v11_2 * v11_2 + v11_3 *
      v11_3);

  // ---- body 12 (body_12) on body 11
  const T theta12 = x[11];
  const T thetadot12 = y[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_22 = cos(theta12);
  const T E12_23 = sin(theta12);
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T R12_21 = R11_21 * E12_22 + R10_31 * E12_23;
  const T R12_22 = R11_22 * E12_22 + R10_32 * E12_23;
  const T R12_23 = R11_23 * E12_22 + R10_33 * E12_23;
  const T R12_31 = R10_31 * E12_22 - R11_21 * E12_23;
  const T R12_32 = R10_32 * E12_22 - R11_22 * E12_23;
  const T R12_33 = R10_33 * E12_22 - R11_23 * E12_23;
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T omega12_1 = thetadot12 + omega11_1;
  const T omega12_2 = E12_22 * omega11_2 + E12_23 * omega11_3;
  const T omega12_3 = E12_22 * omega11_3 - E12_23 * omega11_2;
  // P12 = R11^T q12 + P11: position of the body origin, inertial axes [m]
  const T t12_1 = R11_13 * T(0.3);
  const T P12_3 = t12_1 + R11_23 * T(0.6) + t11_1 + P11_3;
  // p12 = R12^T r12 + P12: position of the mass centre, inertial axes [m]
  const T t12_2 = R12_23 * T(0.2);
  const T p12_3 = t11_2 + t12_2 + R12_33 * T(0.05) + P12_3;
  // Pdot12 = R11^T omega11~ q12 + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_3 = t11_8 - omega11_3 * T(0.6);
  const T t12_4 = omega11_3 * T(0.3) - omega11_1 * T(0.1);
  const T t12_5 = omega11_1 * T(0.6) - omega11_2 * T(0.3);
  const T Pdot12_1 = R11_11 * t12_3 + R11_21 * t12_4 + R10_31 * t12_5 + Pdot11_1;
  const T Pdot12_2 = R11_12 * t12_3 + R11_22 * t12_4 + R10_32 * t12_5 + Pdot11_2;
  const T Pdot12_3 = R11_13 * t12_3 + R11_23 * t12_4 + R10_33 * t12_5 + Pdot11_3;
  // v12 = R12^T omega12~ r12 + Pdot12: velocity of the mass centre, inertial axes [m/s]
  const T t12_6 = omega12_2 * T(0.05) - omega12_3 * T(0.2);
  const T t12_7 = omega12_3 * T(0.1) - omega12_1 * T(0.05);
  const T t12_8 = omega12_2 * T(0.1);
  const T t12_9 = omega12_1 * T(0.2) - t12_8;
  const T v12_1 = R11_11 * t12_6 + R12_21 * t12_7 + R12_31 * t12_9 + Pdot12_1;
  const T v12_2 = R11_12 * t12_6 + R12_22 * t12_7 + R12_32 * t12_9 + Pdot12_2;
  const T v12_3 = R11_13 * t12_6 + R12_23 * t12_7 + R12_33 * t12_9 + Pdot12_3;
  // T12 = 1/2 omega12 . (I12 omega12) + 1/2 m12 v12 . v12: kinetic energy [J]
  const T T12 = T(0.5) * (omega12_1 * (T(0.22) * omega12_1 + T(0.011) * omega12_2 + T(0.0066) * omega12_3) + omega12_2
      * (T(0.011) * omega12_1 + T(0.264) * omega12_2 - T(0.0088) * omega12_3) + omega12_3 * (T(0.0066) * omega12_1 -
      T(0.0088) * omega12_2 + T(0.176) * omega12_3)) + T(1.1) * (v12_1 * v12_1 + v12_2 * v12_2 + v12_3 * v12_3);

  // ---- body 13 (body_13) on body 12
  const T theta13 = x[12];
  const T thetadot13 = y[12];
  // E13^T = Rot(b13, theta13): E takes components in the lower body to those in the body
  const T E13_11 = cos(theta13);
  const T minus_E13_13 = sin(theta13);
  // R13^T = R12^T E13^T: R takes inertial components to body components
  const T R13_11 = R11_11 * E13_11 - R12_31 * minus_E13_13;
  const T R13_12 = R11_12 * E13_11 - R12_32 * minus_E13_13;
  const T R13_13 = R11_13 * E13_11 - R12_33 * minus_E13_13;
  const T R13_31 = R11_11 * minus_E13_13 + R12_31 * E13_11;
  const T R13_32 = R11_12 * minus_E13_13 + R12_32 * E13_11;
  const T R13_33 = R11_13 * minus_E13_13 + R12_33 * E13_11;
  // omega13 = thetadot13 b13 + E13 omega12: absolute angular velocity, body axes [rad/s]
  const T omega13_1 = E13_11 * omega12_1 - minus_E13_13 * omega12_3;
  const T omega13_2 = thetadot13 + omega12_2;
  const T omega13_3 = minus_E13_13 * omega12_1 + E13_11 * omega12_3;
  // P13 = R12^T q13 + P12: position of the body origin, inertial axes [m]
  const T P13_3 = t12_1 + R12_23 * T(0.65) + R12_33 * T(0.1) + P12_3;
  // p13 = R13^T r13 + P13: position of the mass centre, inertial axes [m]
  const T t13_1 = R13_33 * T(0.05);
  const T p13_3 = R13_13 * T(0.1) + t12_2 + t13_1 + P13_3;
  // Pdot13 = R12^T omega12~ q13 + Pdot12: velocity of the body origin, inertial axes [m/s]
  const T t13_2 = t12_8 - omega12_3 * T(0.65);
  const T t13_3 = omega12_3 * T(0.3) - omega12_1 * T(0.1);
  const T t13_4 = omega12_1 * T(0.65) - omega12_2 * T(0.3);
  const T Pdot13_1 = R11_11 * t13_2 + R12_21 * t13_3 + R12_31 * t13_4 + Pdot12_1;
  const T Pdot13_2 = R11_12 * t13_2 + R12_22 * t13_3 + R12_32 * t13_4 + Pdot12_2;
  const T Pdot13_3 = R11_13 * t13_2 + R12_23 * t13_3 + R12_33 * t13_4 + Pdot12_3;
  // v13 = R13^T omega13~ r13 + Pdot13: velocity of the mass centre, inertial axes [m/s]
  const T t13_5 = omega13_2 * T(0.05) - omega13_3 * T(0.2);
  const T t13_6 = omega13_3 * T(0.1) - omega13_1 * T(0.05);
  const T t13_7 = omega13_2 * T(0.1);
  const T t13_8 = omega13_1 * T(0.2) - t13_7;
  const T v13_1 = R13_11 * t13_5 + R12_21 * t13_6 + R13_31 * t13_8 + Pdot13_1;
  const T v13_2 = R13_12 * t13_5 + R12_22 * t13_6 + R13_32 * t13_8 + Pdot13_2;
  const T v13_3 = R13_13 * t13_5 + R12_23 * t13_6 + R13_33 * t13_8 + Pdot13_3;
  // T13 = 1/2 omega13 . (I13 omega13) + 1/2 m13 v13 . v13: kinetic energy [J]
  const T T13 = T(0.5) * (omega13_1 * (T(0.23) * omega13_1 + T(0.0115) * omega13_2 + T(0.0069) * omega13_3) +
      omega13_2 * (T(0.0115) * omega13_1 + T(0.276) * omega13_2 - T(0.0092) * omega13_3) + omega13_3 * (T(0.0069) *
      omega13_1 - T(0.0092) * omega13_2 + T(0.184) * omega13_3)) + T(1.15) * (v13_1 * v13_1 + v13_2 * v13_2 + v13_3 *
      v13_3);

  // ---- body 14 (body_14) on body 13
  const T theta14 = x[13];
  const T thetadot14 = y[13];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_11 = cos(theta14);
  const T E14_12 = sin(theta14);
  // R14^T = R13^T E14^T: R takes inertial components to body components
  const T R14_11 = R13_11 * E14_11 + R12_21 * E14_12;
  const T R14_12 = R13_12 * E14_11 + R12_22 * E14_12;
  const T R14_13 = R13_13 * E14_11 + R12_23 * E14_12;
  const T R14_21 = R12_21 * E14_11 - R13_11 * E14_12;
  const T R14_22 = R12_22 * E14_11 - R13_12 * E14_12;
  const T R14_23 = R12_23 * E14_11 - R13_13 * E14_12;
  // omega14 = thetadot14 b14 + E14 omega13: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = E14_11 * omega13_1 + E14_12 * omega13_2;
  const T omega14_2 = E14_11 * omega13_2 - E14_12 * omega13_1;
  const T omega14_3 = thetadot14 + omega13_3;
  // P14 = R13^T q14 + P13: position of the body origin, inertial axes [m]
  const T t14_1 = R13_33 * T(0.1);
  const T P14_3 = R13_13 * T(0.3) + R12_23 * T(0.7) + t14_1 + P13_3;
  // p14 = R14^T r14 + P14: position of the mass centre, inertial axes [m]
  const T t14_2 = R14_13 * T(0.1);
  const T p14_3 = t14_2 + R14_23 * T(0.2) + t13_1 + P14_3;
  // Pdot14 = R13^T omega13~ q14 + Pdot13: velocity of the body origin, inertial axes [m/s]
  const T t14_3 = t13_7 - omega13_3 * T(0.7);
  const T t14_4 = omega13_3 * T(0.3) - omega13_1 * T(0.1);
  const T t14_5 = omega13_1 * T(0.7) - omega13_2 * T(0.3);
  const T Pdot14_1 = R13_11 * t14_3 + R12_21 * t14_4 + R13_31 * t14_5 + Pdot13_1;
  const T Pdot14_2 = R13_12 * t14_3 + R12_22 * t14_4 + R13_32 * t14_5 + Pdot13_2;
  const T Pdot14_3 = R13_13 * t14_3 + R12_23 * t14_4 + R13_33 * t14_5 + Pdot13_3;
  // v14 = R14^T omega14~ r14 + Pdot14: velocity of the mass centre, inertial axes [m/s]
  const T t14_6 = omega14_2 * T(0.05) - omega14_3 * T(0.2);
  const T t14_7 = omega14_3 * T(0.1) - omega14_1 * T(0.05);
  const T t14_8 = omega14_2 * T(0.1);
  const T t14_9 = omega14_1 * T(0.2) - t14_8;
  const T v14_1 = R14_11 * t14_6 + R14_21 * t14_7 + R13_31 * t14_9 + Pdot14_1;
  const T v14_2 = R14_12 * t14_6 + R14_22 * t14_7 + R13_32 * t14_9 + Pdot14_2;
  const T v14_3 = R14_13 * t14_6 + R14_23 * t14_7 + R13_33 * t14_9 + Pdot14_3;
  // T14 = 1/2 omega14 . (I14 omega14) + 1/2 m14 v14 . v14: kinetic energy [J]
  const T T14 = T(0.5) * (omega14_1 * (T(0.24) * omega14_1 + T(0.012) * omega14_2 + T(0.0072) * omega14_3) + omega14_2
      * (T(0.012) * omega14_1 + T(0.288) * omega14_2 - T(0.0096) * omega14_3) + omega14_3 * (T(0.0072) * omega14_1 -
      T(0.0096) * omega14_2 + T(0.192) * omega14_3)) + T(1.2) * (v14_1 * v14_1 + v14_2 * v14_2 + v14_3 * v14_3);

  // ---- body 15 (body_15) on body 14
  const T theta15 = x[14];
  const T thetadot15 = y[14];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_22 = cos(theta15);
  const T E15_23 = sin(theta15);
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_21 = R14_21 * E15_22 + R13_31 * E15_23;
  const T R15_22 = R14_22 * E15_22 + R13_32 * E15_23;
  const T R15_23 = R14_23 * E15_22 + R13_33 * E15_23;
  const T R15_31 = R13_31 * E15_22 - R14_21 * E15_23;
  const T R15_32 = R13_32 * E15_22 - R14_22 * E15_23;
  const T R15_33 = R13_33 * E15_22 - R14_23 * E15_23;
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = thetadot15 + omega14_1;
  const T omega15_2 = E15_22 * omega14_2 + E15_23 * omega14_3;
  const T omega15_3 = E15_22 * omega14_3 - E15_23 * omega14_2;
  // P15 = R14^T q15 + P14: position of the body origin, inertial axes [m]
  const T t15_1 = R14_13 * T(0.3);
  const T P15_3 = t15_1 + R14_23 * T(0.75) + t14_1 + P14_3;
  // p15 = R15^T r15 + P15: position of the mass centre, inertial axes [m]
  const T t15_2 = R15_23 * T(0.2);
  const T p15_3 = t14_2 + t15_2 + R15_33 * T(0.05) + P15_3;
  // Pdot15 = R14^T omega14~ q15 + Pdot14: velocity of the body origin, inertial axes [m/s]
  const T t15_3 = t14_8 - omega14_3 * T(0.75);
  const T t15_4 = omega14_3 * T(0.3) - omega14_1 * T(0.1);
  const T t15_5 = omega14_1 * T(0.75) - omega14_2 * T(0.3);
  const T Pdot15_1 = R14_11 * t15_3 + R14_21 * t15_4 + R13_31 * t15_5 + Pdot14_1;
  const T Pdot15_2 = R14_12 * t15_3 + R14_22 * t15_4 + R13_32 * t15_5 + Pdot14_2;
  const T Pdot15_3 = R14_13 * t15_3 + R14_23 * t15_4 + R13_33 * t15_5 + Pdot14_3;
  // v15 = R15^T omega15~ r15 + Pdot15: velocity of the mass centre, inertial axes [m/s]
  const T t15_6 = T(0.2) * omega15_3;
  const T t15_7 = omega15_2 * T(0.05) - t15_6;
  const T t15_8 = omega15_3 * T(0.1) - omega15_1 * T(0.05);
  const T t15_9 = omega15_2 * T(0.1);
  const T t15_10 = omega15_1 * T(0.2) - t15_9;
  const T v15_1 = R14_11 * t15_7 + R15_21 * t15_8 + R15_31 * t15_10 + Pdot15_1;
  const T v15_2 = R14_12 * t15_7 + R15_22 * t15_8 + R15_32 * t15_10 + Pdot15_2;
  const T v15_3 = R14_13 * t15_7 + R15_23 * t15_8 + R15_33 * t15_10 + Pdot15_3;
  // T15 = 1/2 omega15 . (I15 omega15) + 1/2 m15 v15 . v15: kinetic energy [J]
  const T t15_11 = T(0.3) * omega15_2;
  const T T15 = T(0.5) * (omega15_1 * (T(0.25) * omega15_1 + T(0.0125) * omega15_2 + T(0.0075) * omega15_3) +
      omega15_2 * (T(0.0125) * omega15_1 + t15_11 - T(0.01) * omega15_3) + omega15_3 * (T(0.0075) * omega15_1 -
      T(0.01) * omega15_2 + t15_6)) + T(1.25) * (v15_1 * v15_1 + v15_2 * v15_2 + v15_3 * v15_3);

  // ---- body 16 (body_16) on body 15
  const T theta16 = x[15];
  const T thetadot16 = y[15];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cos(theta16);
  const T minus_E16_13 = sin(theta16);
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T R16_11 = R14_11 * E16_11 - R15_31 * minus_E16_13;
  const T R16_12 = R14_12 * E16_11 - R15_32 * minus_E16_13;
  const T R16_13 = R14_13 * E16_11 - R15_33 * minus_E16_13;
  const T R16_31 = R14_11 * minus_E16_13 + R15_31 * E16_11;
  const T R16_32 = R14_12 * minus_E16_13 + R15_32 * E16_11;
  const T R16_33 = R14_13 * minus_E16_13 + R15_33 * E16_11;
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T omega16_1 = E16_11 * omega15_1 - minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 + E16_11 * omega15_3;
  // P16 = R15^T q16 + P15: position of the body origin, inertial axes [m]
  const T P16_3 = t15_1 + R15_23 * T(0.8) + R15_33 * T(0.1) + P15_3;
  // p16 = R16^T r16 + P16: position of the mass centre, inertial axes [m]
  const T p16_3 = R16_13 * T(0.1) + t15_2 + R16_33 * T(0.05) + P16_3;
  // Pdot16 = R15^T omega15~ q16 + Pdot15: velocity of the body origin, inertial axes [m/s]
  const T t16_1 = t15_9 - omega15_3 * T(0.8);
  const T t16_2 = omega15_3 * T(0.3) - omega15_1 * T(0.1);
  const T t16_3 = omega15_1 * T(0.8) - t15_11;
  const T Pdot16_1 = R14_11 * t16_1 + R15_21 * t16_2 + R15_31 * t16_3 + Pdot15_1;
  const T Pdot16_2 = R14_12 * t16_1 + R15_22 * t16_2 + R15_32 * t16_3 + Pdot15_2;
  const T Pdot16_3 = R14_13 * t16_1 + R15_23 * t16_2 + R15_33 * t16_3 + Pdot15_3;
  // v16 = R16^T omega16~ r16 + Pdot16: velocity of the mass centre, inertial axes [m/s]
  const T t16_4 = omega16_2 * T(0.05) - omega16_3 * T(0.2);
  const T t16_5 = omega16_3 * T(0.1) - omega16_1 * T(0.05);
  const T t16_6 = omega16_1 * T(0.2) - omega16_2 * T(0.1);
  const T v16_1 = R16_11 * t16_4 + R15_21 * t16_5 + R16_31 * t16_6 + Pdot16_1;
  const T v16_2 = R16_12 * t16_4 + R15_22 * t16_5 + R16_32 * t16_6 + Pdot16_2;
  const T v16_3 = R16_13 * t16_4 + R15_23 * t16_5 + R16_33 * t16_6 + Pdot16_3;
  // T16 = 1/2 omega16 . (I16 omega16) + 1/2 m16 v16 . v16: kinetic energy [J]
  const T T16 = T(0.5) * (omega16_1 * (T(0.26) * omega16_1 + T(0.013) * omega16_2 + T(0.0078) * omega16_3) + omega16_2
      * (T(0.013) * omega16_1 + T(0.312) * omega16_2 - T(0.0104) * omega16_3) + omega16_3 * (T(0.0078) * omega16_1 -
      T(0.0104) * omega16_2 + T(0.208) * omega16_3)) + T(1.3) * (v16_1 * v16_1 + v16_2 * v16_2 + v16_3 * v16_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12 + T13 + T14 + T15 + T16: kinetic energy of
  //   the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12 + T13 + T14 + T15 + T16;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6 + m7 p7 + m8 p8 + m9 p9 + m10 p10 + m11 p11 + m12 p12 + m13
  //   p13 + m14 p14 + m15 p15 + m16 p16: first moment of mass, inertial axes [kg m]
  const T mp_3 = T(1.1) * p1_3 + T(1.2) * p2_3 + T(1.3) * p3_3 + T(1.4) * p4_3 + T(1.5) * p5_3 + T(1.6) * p6_3 +
      T(1.7) * p7_3 + T(1.8) * p8_3 + T(1.9) * p9_3 + T(2) * p10_3 + T(2.1) * p11_3 + T(2.2) * p12_3 + T(2.3) * p13_3
      + T(2.4) * p14_3 + T(2.5) * p15_3 + T(2.6) * p16_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 3598 add, 3927 multiply, 15 divide, 32 sine or cosine
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot)
    noexcept {
  using std::cos, std::sin;

  // ---- body 1 (body_1) on the inertial frame
  const T theta1 = x[0];
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  const T Pddot1_3 = E1_11 * T(9.81);
  // a1 = omega1~ omega1~ r1 + Pddot1: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T t1_1 = thetadot1 * T(0.1) * thetadot1;
  const T minus_a1_1 = t1_1 + minus_Pddot1_1;
  const T a1_3 = Pddot1_3 - thetadot1 * T(0.05) * thetadot1;
  // G1 = -m1 a1: applied less inertia force at ydot = 0, body axes [N]
  const T G1_1 = T(1.1) * minus_a1_1;
  const T minus_G1_3 = T(1.1) * a1_3;

  // ---- body 2 (body_2) on body 1
  const T theta2 = x[1];
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T E2_12 = sin(theta2);
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = E2_12 * thetadot1;
  const T omega2_2 = E2_11 * thetadot1;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_1 = thetadot2 * omega2_2;
  const T minus_omegadot2_2 = thetadot2 * omega2_1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = thetadot2 * thetadot2;
  const T t2_2 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_1 + t2_2;
  const T U2_12 = omega2_2 * omega2_1;
  const T t2_3 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_1 + t2_3;
  const T U2_31 = minus_omegadot2_2 + minus_omegadot2_2;
  const T U2_32 = omegadot2_1 + omegadot2_1;
  const T minus_U2_33 = t2_2 + t2_3;
  // Pddot2 = E2 (omega1~ omega1~ q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_4 = thetadot1 * T(0.3) * thetadot1 + minus_Pddot1_1;
  const T minus_Pddot2_1 = E2_11 * t2_4;
  const T Pddot2_2 = E2_12 * t2_4;
  const T Pddot2_3 = Pddot1_3 - t1_1;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a2_1 = U2_12 * T(0.2) - minus_U2_11 * T(0.1) - minus_Pddot2_1;
  const T a2_2 = U2_12 * T(0.1) - minus_U2_22 * T(0.2) + Pddot2_2;
  const T a2_3 = U2_31 * T(0.1) + U2_32 * T(0.2) - minus_U2_33 * T(0.05) + Pddot2_3;
  // G2 = -m2 a2: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G2_1 = T(1.2) * a2_1;
  const T minus_G2_2 = T(1.2) * a2_2;
  const T minus_G2_3 = T(1.2) * a2_3;
  // N2 = -axial(U2 (tr(I2)/2 - I2)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N2_1 = T(0.036000000000000004) * U2_32 + T(0.0048) * (minus_U2_22 - minus_U2_33) - T(0.006) * U2_31 +
      T(0.0036) * U2_12;
  const T minus_N2_2 = T(0.0048) * U2_12 - T(0.06) * U2_31 - T(0.0036) * (minus_U2_33 - minus_U2_11) + T(0.006) *
      U2_32;
  const T minus_N2_3 = T(0.023999999999999994) * U2_12 - T(0.006) * (minus_U2_11 - minus_U2_22);

  // ---- body 3 (body_3) on body 2
  const T theta3 = x[2];
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega2_1;
  const T omega3_2 = E3_22 * omega2_2 + E3_23 * thetadot2;
  const T omega3_3 = E3_22 * thetadot2 - E3_23 * omega2_2;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_2 = thetadot3 * omega3_3 - E3_22 * minus_omegadot2_2;
  const T omegadot3_3 = E3_23 * minus_omegadot2_2 - thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_3 * omega3_3;
  const T t3_2 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_1 + t3_2;
  const T t3_3 = omega3_2 * omega3_1;
  const T U3_12 = t3_3 - omegadot3_3;
  const T t3_4 = omega3_3 * omega3_1;
  const T U3_13 = t3_4 + omegadot3_2;
  const T U3_21 = t3_3 + omegadot3_3;
  const T t3_5 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_1 + t3_5;
  const T t3_6 = omega3_3 * omega3_2;
  const T U3_23 = t3_6 - omegadot2_1;
  const T U3_31 = t3_4 - omegadot3_2;
  const T U3_32 = t3_6 + omegadot2_1;
  const T minus_U3_33 = t3_2 + t3_5;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot3_1 = U2_12 * T(0.15) - minus_U2_11 * T(0.3) - minus_Pddot2_1;
  const T t3_7 = U2_12 * T(0.3) - minus_U2_22 * T(0.15) + Pddot2_2;
  const T t3_8 = U2_31 * T(0.3) + U2_32 * T(0.15) - minus_U2_33 * T(0.1) + Pddot2_3;
  const T Pddot3_2 = E3_22 * t3_7 + E3_23 * t3_8;
  const T Pddot3_3 = E3_22 * t3_8 - E3_23 * t3_7;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T t3_9 = U3_12 * T(0.2) + Pddot3_1;
  const T a3_1 = t3_9 - minus_U3_11 * T(0.1) + U3_13 * T(0.05);
  const T t3_10 = minus_U3_22 * T(0.2) - Pddot3_2;
  const T a3_2 = U3_21 * T(0.1) - t3_10 + U3_23 * T(0.05);
  const T t3_11 = U3_32 * T(0.2) + Pddot3_3;
  const T a3_3 = U3_31 * T(0.1) + t3_11 - minus_U3_33 * T(0.05);
  // G3 = -m3 a3: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G3_1 = T(1.3) * a3_1;
  const T minus_G3_2 = T(1.3) * a3_2;
  const T minus_G3_3 = T(1.3) * a3_3;
  // N3 = -axial(U3 (tr(I3)/2 - I3)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N3_1 = T(0.039) * U3_32 - T(0.091) * U3_23 + T(0.0052) * (minus_U3_22 - minus_U3_33) - T(0.0065) *
      U3_31 + T(0.0039) * U3_21;
  const T minus_N3_2 = T(0.091) * U3_13 - T(0.065) * U3_31 - T(0.0039) * (minus_U3_33 - minus_U3_11) + T(0.0052) *
      U3_12 + T(0.0065) * U3_32;
  const T minus_N3_3 = T(0.065) * U3_21 - T(0.039) * U3_12 - T(0.0065) * (minus_U3_11 - minus_U3_22) - T(0.0039) *
      U3_23 - T(0.0052) * U3_13;

  // ---- body 4 (body_4) on body 3
  const T theta4 = x[3];
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cos(theta4);
  const T minus_E4_13 = sin(theta4);
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 - minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  const T omega4_3 = minus_E4_13 * omega3_1 + E4_11 * omega3_3;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = E4_11 * omegadot2_1 - minus_E4_13 * omegadot3_3 - thetadot4 * omega4_3;
  const T omegadot4_3 = thetadot4 * omega4_1 + minus_E4_13 * omegadot2_1 + E4_11 * omegadot3_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_1 = omega4_3 * omega4_3;
  const T t4_2 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_1 + t4_2;
  const T t4_3 = omega4_2 * omega4_1;
  const T U4_12 = t4_3 - omegadot4_3;
  const T t4_4 = omega4_3 * omega4_1;
  const T U4_13 = t4_4 + omegadot3_2;
  const T U4_21 = t4_3 + omegadot4_3;
  const T t4_5 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_1 + t4_5;
  const T t4_6 = omega4_3 * omega4_2;
  const T U4_23 = t4_6 - omegadot4_1;
  const T U4_31 = t4_4 - omegadot3_2;
  const T U4_32 = t4_6 + omegadot4_1;
  const T minus_U4_33 = t4_2 + t4_5;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_7 = t3_9 - minus_U3_11 * T(0.3) + U3_13 * T(0.1);
  const T t4_8 = U3_31 * T(0.3) + t3_11 - minus_U3_33 * T(0.1);
  const T Pddot4_1 = E4_11 * t4_7 - minus_E4_13 * t4_8;
  const T Pddot4_2 = U3_21 * T(0.3) - t3_10 + U3_23 * T(0.1);
  const T Pddot4_3 = minus_E4_13 * t4_7 + E4_11 * t4_8;
  // a4 = U4 r4 + Pddot4: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a4_1 = U4_12 * T(0.2) - minus_U4_11 * T(0.1) + U4_13 * T(0.05) + Pddot4_1;
  const T a4_2 = U4_21 * T(0.1) - minus_U4_22 * T(0.2) + U4_23 * T(0.05) + Pddot4_2;
  const T a4_3 = U4_31 * T(0.1) + U4_32 * T(0.2) - minus_U4_33 * T(0.05) + Pddot4_3;
  // G4 = -m4 a4: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G4_1 = T(1.4) * a4_1;
  const T minus_G4_2 = T(1.4) * a4_2;
  const T minus_G4_3 = T(1.4) * a4_3;
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N4_1 = T(0.042) * U4_32 - T(0.098) * U4_23 + T(0.0056) * (minus_U4_22 - minus_U4_33) - T(0.007) *
      U4_31 + T(0.0042) * U4_21;
  const T minus_N4_2 = T(0.098) * U4_13 - T(0.07) * U4_31 - T(0.0042) * (minus_U4_33 - minus_U4_11) + T(0.0056) *
      U4_12 + T(0.007) * U4_32;
  const T minus_N4_3 = T(0.07) * U4_21 - T(0.042) * U4_12 - T(0.007) * (minus_U4_11 - minus_U4_22) - T(0.0042) * U4_23
      - T(0.0056) * U4_13;

  // ---- body 5 (body_5) on body 4
  const T theta5 = x[4];
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cos(theta5);
  const T E5_12 = sin(theta5);
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 + E5_12 * omega4_2;
  const T omega5_2 = E5_11 * omega4_2 - E5_12 * omega4_1;
  const T omega5_3 = thetadot5 + omega4_3;
  // omegadot5 = -thetadot5 b5~ E5 omega4 + E5 omegadot4: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = thetadot5 * omega5_2 + E5_11 * omegadot4_1 + E5_12 * omegadot3_2;
  const T omegadot5_2 = E5_11 * omegadot3_2 - E5_12 * omegadot4_1 - thetadot5 * omega5_1;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_1 = omega5_3 * omega5_3;
  const T t5_2 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_1 + t5_2;
  const T t5_3 = omega5_2 * omega5_1;
  const T U5_12 = t5_3 - omegadot4_3;
  const T t5_4 = omega5_3 * omega5_1;
  const T U5_13 = t5_4 + omegadot5_2;
  const T U5_21 = t5_3 + omegadot4_3;
  const T t5_5 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_1 + t5_5;
  const T t5_6 = omega5_3 * omega5_2;
  const T U5_23 = t5_6 - omegadot5_1;
  const T U5_31 = t5_4 - omegadot5_2;
  const T U5_32 = t5_6 + omegadot5_1;
  const T minus_U5_33 = t5_2 + t5_5;
  // Pddot5 = E5 (U4 q5 + Pddot4): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_7 = U4_12 * T(0.25) - minus_U4_11 * T(0.3) + U4_13 * T(0.1) + Pddot4_1;
  const T t5_8 = U4_21 * T(0.3) - minus_U4_22 * T(0.25) + U4_23 * T(0.1) + Pddot4_2;
  const T Pddot5_1 = E5_11 * t5_7 + E5_12 * t5_8;
  const T Pddot5_2 = E5_11 * t5_8 - E5_12 * t5_7;
  const T Pddot5_3 = U4_31 * T(0.3) + U4_32 * T(0.25) - minus_U4_33 * T(0.1) + Pddot4_3;
  // a5 = U5 r5 + Pddot5: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a5_1 = U5_12 * T(0.2) - minus_U5_11 * T(0.1) + U5_13 * T(0.05) + Pddot5_1;
  const T a5_2 = U5_21 * T(0.1) - minus_U5_22 * T(0.2) + U5_23 * T(0.05) + Pddot5_2;
  const T a5_3 = U5_31 * T(0.1) + U5_32 * T(0.2) - minus_U5_33 * T(0.05) + Pddot5_3;
  // G5 = -m5 a5: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G5_1 = T(1.5) * a5_1;
  const T minus_G5_2 = T(1.5) * a5_2;
  const T minus_G5_3 = T(1.5) * a5_3;
  // N5 = -axial(U5 (tr(I5)/2 - I5)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N5_1 = T(0.045) * U5_32 - T(0.105) * U5_23 + T(0.006) * (minus_U5_22 - minus_U5_33) - T(0.0075) *
      U5_31 + T(0.0045) * U5_21;
  const T minus_N5_2 = T(0.105) * U5_13 - T(0.075) * U5_31 - T(0.0045) * (minus_U5_33 - minus_U5_11) + T(0.006) *
      U5_12 + T(0.0075) * U5_32;
  const T minus_N5_3 = T(0.075) * U5_21 - T(0.045) * U5_12 - T(0.0075) * (minus_U5_11 - minus_U5_22) - T(0.0045) *
      U5_23 - T(0.006) * U5_13;

  // ---- body 6 (body_6) on body 5
  const T theta6 = x[5];
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cos(theta6);
  const T E6_23 = sin(theta6);
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega5_1;
  const T omega6_2 = E6_22 * omega5_2 + E6_23 * omega5_3;
  const T omega6_3 = E6_22 * omega5_3 - E6_23 * omega5_2;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_2 = thetadot6 * omega6_3 + E6_22 * omegadot5_2 + E6_23 * omegadot4_3;
  const T omegadot6_3 = E6_22 * omegadot4_3 - E6_23 * omegadot5_2 - thetadot6 * omega6_2;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_3 * omega6_3;
  const T t6_2 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_1 + t6_2;
  const T t6_3 = omega6_2 * omega6_1;
  const T U6_12 = t6_3 - omegadot6_3;
  const T t6_4 = omega6_3 * omega6_1;
  const T U6_13 = t6_4 + omegadot6_2;
  const T U6_21 = t6_3 + omegadot6_3;
  const T t6_5 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_1 + t6_5;
  const T t6_6 = omega6_3 * omega6_2;
  const T U6_23 = t6_6 - omegadot5_1;
  const T U6_31 = t6_4 - omegadot6_2;
  const T U6_32 = t6_6 + omegadot5_1;
  const T minus_U6_33 = t6_2 + t6_5;
  // Pddot6 = E6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = U5_12 * T(0.3) - minus_U5_11 * T(0.3) + U5_13 * T(0.1) + Pddot5_1;
  const T t6_7 = U5_21 * T(0.3) - minus_U5_22 * T(0.3) + U5_23 * T(0.1) + Pddot5_2;
  const T t6_8 = U5_31 * T(0.3) + U5_32 * T(0.3) - minus_U5_33 * T(0.1) + Pddot5_3;
  const T Pddot6_2 = E6_22 * t6_7 + E6_23 * t6_8;
  const T Pddot6_3 = E6_22 * t6_8 - E6_23 * t6_7;
  // a6 = U6 r6 + Pddot6: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a6_1 = U6_12 * T(0.2) - minus_U6_11 * T(0.1) + U6_13 * T(0.05) + Pddot6_1;
  const T a6_2 = U6_21 * T(0.1) - minus_U6_22 * T(0.2) + U6_23 * T(0.05) + Pddot6_2;
  const T a6_3 = U6_31 * T(0.1) + U6_32 * T(0.2) - minus_U6_33 * T(0.05) + Pddot6_3;
  // G6 = -m6 a6: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G6_1 = T(1.6) * a6_1;
  const T minus_G6_2 = T(1.6) * a6_2;
  const T minus_G6_3 = T(1.6) * a6_3;
  // N6 = -axial(U6 (tr(I6)/2 - I6)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N6_1 = T(0.048) * U6_32 - T(0.112) * U6_23 + T(0.0064) * (minus_U6_22 - minus_U6_33) - T(0.008) *
      U6_31 + T(0.0048) * U6_21;
  const T minus_N6_2 = T(0.112) * U6_13 - T(0.08) * U6_31 - T(0.0048) * (minus_U6_33 - minus_U6_11) + T(0.0064) *
      U6_12 + T(0.008) * U6_32;
  const T minus_N6_3 = T(0.08) * U6_21 - T(0.048) * U6_12 - T(0.008) * (minus_U6_11 - minus_U6_22) - T(0.0048) * U6_23
      - T(0.0064) * U6_13;

  // ---- body 7 (body_7) on body 6
  const T theta7 = x[6];
  const T thetadot7 = y[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cos(theta7);
  const T minus_E7_13 = sin(theta7);
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // omegadot7 = -thetadot7 b7~ E7 omega6 + E7 omegadot6: angular acceleration, body axes [rad/s^2]
  const T omegadot7_1 = E7_11 * omegadot5_1 - minus_E7_13 * omegadot6_3 - thetadot7 * omega7_3;
  const T omegadot7_3 = thetadot7 * omega7_1 + minus_E7_13 * omegadot5_1 + E7_11 * omegadot6_3;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t7_1 = omega7_3 * omega7_3;
  const T t7_2 = omega7_2 * omega7_2;
  const T minus_U7_11 = t7_1 + t7_2;
  const T t7_3 = omega7_2 * omega7_1;
  const T U7_12 = t7_3 - omegadot7_3;
  const T t7_4 = omega7_3 * omega7_1;
  const T U7_13 = t7_4 + omegadot6_2;
  const T U7_21 = t7_3 + omegadot7_3;
  const T t7_5 = omega7_1 * omega7_1;
  const T minus_U7_22 = t7_1 + t7_5;
  const T t7_6 = omega7_3 * omega7_2;
  const T U7_23 = t7_6 - omegadot7_1;
  const T U7_31 = t7_4 - omegadot6_2;
  const T U7_32 = t7_6 + omegadot7_1;
  const T minus_U7_33 = t7_2 + t7_5;
  // Pddot7 = E7 (U6 q7 + Pddot6): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t7_7 = U6_12 * T(0.35) - minus_U6_11 * T(0.3) + U6_13 * T(0.1) + Pddot6_1;
  const T t7_8 = U6_31 * T(0.3) + U6_32 * T(0.35) - minus_U6_33 * T(0.1) + Pddot6_3;
  const T Pddot7_1 = E7_11 * t7_7 - minus_E7_13 * t7_8;
  const T Pddot7_2 = U6_21 * T(0.3) - minus_U6_22 * T(0.35) + U6_23 * T(0.1) + Pddot6_2;
  const T Pddot7_3 = minus_E7_13 * t7_7 + E7_11 * t7_8;
  // a7 = U7 r7 + Pddot7: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a7_1 = U7_12 * T(0.2) - minus_U7_11 * T(0.1) + U7_13 * T(0.05) + Pddot7_1;
  const T a7_2 = U7_21 * T(0.1) - minus_U7_22 * T(0.2) + U7_23 * T(0.05) + Pddot7_2;
  const T a7_3 = U7_31 * T(0.1) + U7_32 * T(0.2) - minus_U7_33 * T(0.05) + Pddot7_3;
  // G7 = -m7 a7: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G7_1 = T(1.7) * a7_1;
  const T minus_G7_2 = T(1.7) * a7_2;
  const T minus_G7_3 = T(1.7) * a7_3;
  // N7 = -axial(U7 (tr(I7)/2 - I7)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N7_1 = T(0.05100000000000002) * U7_32 - T(0.119) * U7_23 + T(0.0068) * (minus_U7_22 - minus_U7_33) -
      T(0.0085) * U7_31 + T(0.0051) * U7_21;
  const T minus_N7_2 = T(0.119) * U7_13 - T(0.08499999999999999) * U7_31 - T(0.0051) * (minus_U7_33 - minus_U7_11) +
      T(0.0068) * U7_12 + T(0.0085) * U7_32;
  const T minus_N7_3 = T(0.08499999999999999) * U7_21 - T(0.05100000000000002) * U7_12 - T(0.0085) * (minus_U7_11 -
      minus_U7_22) - T(0.0051) * U7_23 - T(0.0068) * U7_13;

  // ---- body 8 (body_8) on body 7
  const T theta8 = x[7];
  const T thetadot8 = y[7];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cos(theta8);
  const T E8_12 = sin(theta8);
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega7_1 + E8_12 * omega7_2;
  const T omega8_2 = E8_11 * omega7_2 - E8_12 * omega7_1;
  const T omega8_3 = thetadot8 + omega7_3;
  // omegadot8 = -thetadot8 b8~ E8 omega7 + E8 omegadot7: angular acceleration, body axes [rad/s^2]
  const T omegadot8_1 = thetadot8 * omega8_2 + E8_11 * omegadot7_1 + E8_12 * omegadot6_2;
  const T omegadot8_2 = E8_11 * omegadot6_2 - E8_12 * omegadot7_1 - thetadot8 * omega8_1;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_1 = omega8_3 * omega8_3;
  const T t8_2 = omega8_2 * omega8_2;
  const T minus_U8_11 = t8_1 + t8_2;
  const T t8_3 = omega8_2 * omega8_1;
  const T U8_12 = t8_3 - omegadot7_3;
  const T t8_4 = omega8_3 * omega8_1;
  const T U8_13 = t8_4 + omegadot8_2;
  const T U8_21 = t8_3 + omegadot7_3;
  const T t8_5 = omega8_1 * omega8_1;
  const T minus_U8_22 = t8_1 + t8_5;
  const T t8_6 = omega8_3 * omega8_2;
  const T U8_23 = t8_6 - omegadot8_1;
  const T U8_31 = t8_4 - omegadot8_2;
  const T U8_32 = t8_6 + omegadot8_1;
  const T minus_U8_33 = t8_2 + t8_5;
  // Pddot8 = E8 (U7 q8 + Pddot7): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t8_7 = U7_12 * T(0.4) - minus_U7_11 * T(0.3) + U7_13 * T(0.1) + Pddot7_1;
  const T t8_8 = U7_21 * T(0.3) - minus_U7_22 * T(0.4) + U7_23 * T(0.1) + Pddot7_2;
  const T Pddot8_1 = E8_11 * t8_7 + E8_12 * t8_8;
  const T Pddot8_2 = E8_11 * t8_8 - E8_12 * t8_7;
  const T Pddot8_3 = U7_31 * T(0.3) + U7_32 * T(0.4) - minus_U7_33 * T(0.1) + Pddot7_3;
  // a8 = U8 r8 + Pddot8: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a8_1 = U8_12 * T(0.2) - minus_U8_11 * T(0.1) + U8_13 * T(0.05) + Pddot8_1;
  const T a8_2 = U8_21 * T(0.1) - minus_U8_22 * T(0.2) + U8_23 * T(0.05) + Pddot8_2;
  const T a8_3 = U8_31 * T(0.1) + U8_32 * T(0.2) - minus_U8_33 * T(0.05) + Pddot8_3;
  // G8 = -m8 a8: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G8_1 = T(1.8) * a8_1;
  const T minus_G8_2 = T(1.8) * a8_2;
  const T minus_G8_3 = T(1.8) * a8_3;
  // N8 = -axial(U8 (tr(I8)/2 - I8)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N8_1 = T(0.05399999999999999) * U8_32 - T(0.126) * U8_23 + T(0.0072) * (minus_U8_22 - minus_U8_33) -
      T(0.009) * U8_31 + T(0.0054) * U8_21;
  const T minus_N8_2 = T(0.126) * U8_13 - T(0.09) * U8_31 - T(0.0054) * (minus_U8_33 - minus_U8_11) + T(0.0072) *
      U8_12 + T(0.009) * U8_32;
  const T minus_N8_3 = T(0.09) * U8_21 - T(0.05399999999999999) * U8_12 - T(0.009) * (minus_U8_11 - minus_U8_22) -
      T(0.0054) * U8_23 - T(0.0072) * U8_13;

  // ---- body 9 (body_9) on body 8
  const T theta9 = x[8];
  const T thetadot9 = y[8];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_22 = cos(theta9);
  const T E9_23 = sin(theta9);
  // omega9 = thetadot9 b9 + E9 omega8: absolute angular velocity, body axes [rad/s]
  const T omega9_1 = thetadot9 + omega8_1;
  const T omega9_2 = E9_22 * omega8_2 + E9_23 * omega8_3;
  const T omega9_3 = E9_22 * omega8_3 - E9_23 * omega8_2;
  // omegadot9 = -thetadot9 b9~ E9 omega8 + E9 omegadot8: angular acceleration, body axes [rad/s^2]
  const T omegadot9_2 = thetadot9 * omega9_3 + E9_22 * omegadot8_2 + E9_23 * omegadot7_3;
  const T omegadot9_3 = E9_22 * omegadot7_3 - E9_23 * omegadot8_2 - thetadot9 * omega9_2;
  // U9 = omega9~ omega9~ + omegadot9~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t9_1 = omega9_3 * omega9_3;
  const T t9_2 = omega9_2 * omega9_2;
  const T minus_U9_11 = t9_1 + t9_2;
  const T t9_3 = omega9_2 * omega9_1;
  const T U9_12 = t9_3 - omegadot9_3;
  const T t9_4 = omega9_3 * omega9_1;
  const T U9_13 = t9_4 + omegadot9_2;
  const T U9_21 = t9_3 + omegadot9_3;
  const T t9_5 = omega9_1 * omega9_1;
  const T minus_U9_22 = t9_1 + t9_5;
  const T t9_6 = omega9_3 * omega9_2;
  const T U9_23 = t9_6 - omegadot8_1;
  const T U9_31 = t9_4 - omegadot9_2;
  const T U9_32 = t9_6 + omegadot8_1;
  const T minus_U9_33 = t9_2 + t9_5;
  // Pddot9 = E9 (U8 q9 + Pddot8): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot9_1 = U8_12 * T(0.45) - minus_U8_11 * T(0.3) + U8_13 * T(0.1) + Pddot8_1;
  const T t9_7 = U8_21 * T(0.3) - minus_U8_22 * T(0.45) + U8_23 * T(0.1) + Pddot8_2;
  const T t9_8 = U8_31 * T(0.3) + U8_32 * T(0.45) - minus_U8_33 * T(0.1) + Pddot8_3;
  const T Pddot9_2 = E9_22 * t9_7 + E9_23 * t9_8;
  const T Pddot9_3 = E9_22 * t9_8 - E9_23 * t9_7;
  // a9 = U9 r9 + Pddot9: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a9_1 = U9_12 * T(0.2) - minus_U9_11 * T(0.1) + U9_13 * T(0.05) + Pddot9_1;
  const T a9_2 = U9_21 * T(0.1) - minus_U9_22 * T(0.2) + U9_23 * T(0.05) + Pddot9_2;
  const T a9_3 = U9_31 * T(0.1) + U9_32 * T(0.2) - minus_U9_33 * T(0.05) + Pddot9_3;
  // G9 = -m9 a9: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G9_1 = T(1.9) * a9_1;
  const T minus_G9_2 = T(1.9) * a9_2;
  const T minus_G9_3 = T(1.9) * a9_3;
  // N9 = -axial(U9 (tr(I9)/2 - I9)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N9_1 = T(0.056999999999999995) * U9_32 - T(0.133) * U9_23 + T(0.0076) * (minus_U9_22 - minus_U9_33) -
      T(0.0095) * U9_31 + T(0.0057) * U9_21;
  const T minus_N9_2 = T(0.133) * U9_13 - T(0.095) * U9_31 - T(0.0057) * (minus_U9_33 - minus_U9_11) + T(0.0076) *
      U9_12 + T(0.0095) * U9_32;
  const T minus_N9_3 = T(0.095) * U9_21 - T(0.056999999999999995) * U9_12 - T(0.0095) * (minus_U9_11 - minus_U9_22) -
      T(0.0057) * U9_23 - T(0.0076) * U9_13;

  // ---- body 10 (body_10) on body 9
  const T theta10 = x[9];
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_11 = cos(theta10);
  const T minus_E10_13 = sin(theta10);
  // omega10 = thetadot10 b10 + E10 omega9: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = E10_11 * omega9_1 - minus_E10_13 * omega9_3;
  const T omega10_2 = thetadot10 + omega9_2;
  const T omega10_3 = minus_E10_13 * omega9_1 + E10_11 * omega9_3;
  // omegadot10 = -thetadot10 b10~ E10 omega9 + E10 omegadot9: angular acceleration, body axes [rad/s^2]
  const T omegadot10_1 = E10_11 * omegadot8_1 - minus_E10_13 * omegadot9_3 - thetadot10 * omega10_3;
  const T omegadot10_3 = thetadot10 * omega10_1 + minus_E10_13 * omegadot8_1 + E10_11 * omegadot9_3;
  // U10 = omega10~ omega10~ + omegadot10~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t10_1 = omega10_3 * omega10_3;
  const T t10_2 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_1 + t10_2;
  const T t10_3 = omega10_2 * omega10_1;
  const T U10_12 = t10_3 - omegadot10_3;
  const T t10_4 = omega10_3 * omega10_1;
  const T U10_13 = t10_4 + omegadot9_2;
  const T U10_21 = t10_3 + omegadot10_3;
  const T t10_5 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_1 + t10_5;
  const T t10_6 = omega10_3 * omega10_2;
  const T U10_23 = t10_6 - omegadot10_1;
  const T U10_31 = t10_4 - omegadot9_2;
  const T U10_32 = t10_6 + omegadot10_1;
  const T minus_U10_33 = t10_2 + t10_5;
  // Pddot10 = E10 (U9 q10 + Pddot9): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t10_7 = U9_12 * T(0.5) - minus_U9_11 * T(0.3) + U9_13 * T(0.1) + Pddot9_1;
  const T t10_8 = U9_31 * T(0.3) + U9_32 * T(0.5) - minus_U9_33 * T(0.1) + Pddot9_3;
  const T Pddot10_1 = E10_11 * t10_7 - minus_E10_13 * t10_8;
  const T Pddot10_2 = U9_21 * T(0.3) - minus_U9_22 * T(0.5) + U9_23 * T(0.1) + Pddot9_2;
  const T Pddot10_3 = minus_E10_13 * t10_7 + E10_11 * t10_8;
  // a10 = U10 r10 + Pddot10: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a10_1 = U10_12 * T(0.2) - minus_U10_11 * T(0.1) + U10_13 * T(0.05) + Pddot10_1;
  const T a10_2 = U10_21 * T(0.1) - minus_U10_22 * T(0.2) + U10_23 * T(0.05) + Pddot10_2;
  const T a10_3 = U10_31 * T(0.1) + U10_32 * T(0.2) - minus_U10_33 * T(0.05) + Pddot10_3;
  // G10 = -m10 a10: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G10_1 = T(2) * a10_1;
  const T minus_G10_2 = T(2) * a10_2;
  const T minus_G10_3 = T(2) * a10_3;
  // N10 = -axial(U10 (tr(I10)/2 - I10)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N10_1 = T(0.06000000000000001) * U10_32 - T(0.14) * U10_23 + T(0.008) * (minus_U10_22 - minus_U10_33)
      - T(0.01) * U10_31 + T(0.006) * U10_21;
  const T minus_N10_2 = T(0.14) * U10_13 - T(0.09999999999999999) * U10_31 - T(0.006) * (minus_U10_33 - minus_U10_11)
      + T(0.008) * U10_12 + T(0.01) * U10_32;
  const T minus_N10_3 = T(0.09999999999999999) * U10_21 - T(0.06000000000000001) * U10_12 - T(0.01) * (minus_U10_11 -
      minus_U10_22) - T(0.006) * U10_23 - T(0.008) * U10_13;

  // ---- body 11 (body_11) on body 10
  const T theta11 = x[10];
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cos(theta11);
  const T E11_12 = sin(theta11);
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 + E11_12 * omega10_2;
  const T omega11_2 = E11_11 * omega10_2 - E11_12 * omega10_1;
  const T omega11_3 = thetadot11 + omega10_3;
  // omegadot11 = -thetadot11 b11~ E11 omega10 + E11 omegadot10: angular acceleration, body axes [rad/s^2]
  const T omegadot11_1 = thetadot11 * omega11_2 + E11_11 * omegadot10_1 + E11_12 * omegadot9_2;
  const T omegadot11_2 = E11_11 * omegadot9_2 - E11_12 * omegadot10_1 - thetadot11 * omega11_1;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_1 = omega11_3 * omega11_3;
  const T t11_2 = omega11_2 * omega11_2;
  const T minus_U11_11 = t11_1 + t11_2;
  const T t11_3 = omega11_2 * omega11_1;
  const T U11_12 = t11_3 - omegadot10_3;
  const T t11_4 = omega11_3 * omega11_1;
  const T U11_13 = t11_4 + omegadot11_2;
  const T U11_21 = t11_3 + omegadot10_3;
  const T t11_5 = omega11_1 * omega11_1;
  const T minus_U11_22 = t11_1 + t11_5;
  const T t11_6 = omega11_3 * omega11_2;
  const T U11_23 = t11_6 - omegadot11_1;
  const T U11_31 = t11_4 - omegadot11_2;
  const T U11_32 = t11_6 + omegadot11_1;
  const T minus_U11_33 = t11_2 + t11_5;
  // Pddot11 = E11 (U10 q11 + Pddot10): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t11_7 = U10_12 * T(0.55) - minus_U10_11 * T(0.3) + U10_13 * T(0.1) + Pddot10_1;
  const T t11_8 = U10_21 * T(0.3) - minus_U10_22 * T(0.55) + U10_23 * T(0.1) + Pddot10_2;
  const T Pddot11_1 = E11_11 * t11_7 + E11_12 * t11_8;
  const T Pddot11_2 = E11_11 * t11_8 - E11_12 * t11_7;
  const T Pddot11_3 = U10_31 * T(0.3) + U10_32 * T(0.55) - minus_U10_33 * T(0.1) + Pddot10_3;
  // a11 = U11 r11 + Pddot11: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a11_1 = U11_12 * T(0.2) - minus_U11_11 * T(0.1) + U11_13 * T(0.05) + Pddot11_1;
  const T a11_2 = U11_21 * T(0.1) - minus_U11_22 * T(0.2) + U11_23 * T(0.05) + Pddot11_2;
  const T a11_3 = U11_31 * T(0.1) + U11_32 * T(0.2) - minus_U11_33 * T(0.05) + Pddot11_3;
  // G11 = -m11 a11: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G11_1 = T(2.1) * a11_1;
  const T minus_G11_2 = T(2.1) * a11_2;
  const T minus_G11_3 = T(2.1) * a11_3;
  // N11 = -axial(U11 (tr(I11)/2 - I11)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N11_1 = T(0.063) * U11_32 - T(0.147) * U11_23 + T(0.0084) * (minus_U11_22 - minus_U11_33) - T(0.0105)
      * U11_31 + T(0.0063) * U11_21;
  const T minus_N11_2 = T(0.147) * U11_13 - T(0.10500000000000001) * U11_31 - T(0.0063) * (minus_U11_33 -
      minus_U11_11) + T(0.0084) * U11_12 + T(0.0105) * U11_32;
  const T minus_N11_3 = T(0.10500000000000001) * U11_21 - T(0.063) * U11_12 - T(0.0105) * (minus_U11_11 -
      minus_U11_22) - T(0.0063) * U11_23 - T(0.0084) * U11_13;

  // ---- body 12 (body_12) on body 11
  const T theta12 = x[11];
  const T thetadot12 = y[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_22 = cos(theta12);
  const T E12_23 = sin(theta12);
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T omega12_1 = thetadot12 + omega11_1;
  const T omega12_2 = E12_22 * omega11_2 + E12_23 * omega11_3;
  const T omega12_3 = E12_22 * omega11_3 - E12_23 * omega11_2;
  // omegadot12 = -thetadot12 b12~ E12 omega11 + E12 omegadot11: angular acceleration, body axes [rad/s^2]
  const T omegadot12_2 = thetadot12 * omega12_3 + E12_22 * omegadot11_2 + E12_23 * omegadot10_3;
  const T omegadot12_3 = E12_22 * omegadot10_3 - E12_23 * omegadot11_2 - thetadot12 * omega12_2;
  // U12 = omega12~ omega12~ + omegadot12~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t12_1 = omega12_3 * omega12_3;
  const T t12_2 = omega12_2 * omega12_2;
  const T minus_U12_11 = t12_1 + t12_2;
  const T t12_3 = omega12_2 * omega12_1;
  const T U12_12 = t12_3 - omegadot12_3;
  const T t12_4 = omega12_3 * omega12_1;
  const T U12_13 = t12_4 + omegadot12_2;
  const T U12_21 = t12_3 + omegadot12_3;
  const T t12_5 = omega12_1 * omega12_1;
  const T minus_U12_22 = t12_1 + t12_5;
  const T t12_6 = omega12_3 * omega12_2;
  const T U12_23 = t12_6 - omegadot11_1;
  const T U12_31 = t12_4 - omegadot12_2;
  const T U12_32 = t12_6 + omegadot11_1;
  const T minus_U12_33 = t12_2 + t12_5;
  // Pddot12 = E12 (U11 q12 + Pddot11): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot12_1 = U11_12 * T(0.6) - minus_U11_11 * T(0.3) + U11_13 * T(0.1) + Pddot11_1;
  const T t12_7 = U11_21 * T(0.3) - minus_U11_22 * T(0.6) + U11_23 * T(0.1) + Pddot11_2;
  const T t12_8 = U11_31 * T(0.3) + U11_32 * T(0.6) - minus_U11_33 * T(0.1) + Pddot11_3;
  const T Pddot12_2 = E12_22 * t12_7 + E12_23 * t12_8;
  const T Pddot12_3 = E12_22 * t12_8 - E12_23 * t12_7;
  // a12 = U12 r12 + Pddot12: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a12_1 = U12_12 * T(0.2) - minus_U12_11 * T(0.1) + U12_13 * T(0.05) + Pddot12_1;
  const T a12_2 = U12_21 * T(0.1) - minus_U12_22 * T(0.2) + U12_23 * T(0.05) + Pddot12_2;
  const T a12_3 = U12_31 * T(0.1) + U12_32 * T(0.2) - minus_U12_33 * T(0.05) + Pddot12_3;
  // G12 = -m12 a12: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G12_1 = T(2.2) * a12_1;
  const T minus_G12_2 = T(2.2) * a12_2;
  const T minus_G12_3 = T(2.2) * a12_3;
  // N12 = -axial(U12 (tr(I12)/2 - I12)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N12_1 = T(0.06599999999999999) * U12_32 - T(0.15400000000000003) * U12_23 + T(0.0088) * (minus_U12_22
      - minus_U12_33) - T(0.011) * U12_31 + T(0.0066) * U12_21;
  const T minus_N12_2 = T(0.15400000000000003) * U12_13 - T(0.11) * U12_31 - T(0.0066) * (minus_U12_33 - minus_U12_11)
      + T(0.0088) * U12_12 + T(0.011) * U12_32;
  const T minus_N12_3 = T(0.11) * U12_21 - T(0.06599999999999999) * U12_12 - T(0.011) * (minus_U12_11 - minus_U12_22)
      - T(0.0066) * U12_23 - T(0.0088) * U12_13;

  // ---- body 13 (body_13) on body 12
  const T theta13 = x[12];
  const T thetadot13 = y[12];
  // E13^T = Rot(b13, theta13): E takes components in the lower body to those in the body
  const T E13_11 = cos(theta13);
  const T minus_E13_13 = sin(theta13);
  // omega13 = thetadot13 b13 + E13 omega12: absolute angular velocity, body axes [rad/s]
  const T omega13_1 = E13_11 * omega12_1 - minus_E13_13 * omega12_3;
  const T omega13_2 = thetadot13 + omega12_2;
  const T omega13_3 = minus_E13_13 * omega12_1 + E13_11 * omega12_3;
  // omegadot13 = -thetadot13 b13~ E13 omega12 + E13 omegadot12: angular acceleration, body axes [rad/s^2]
  const T omegadot13_1 = E13_11 * omegadot11_1 - minus_E13_13 * omegadot12_3 - thetadot13 * omega13_3;
  const T omegadot13_3 = thetadot13 * omega13_1 + minus_E13_13 * omegadot11_1 + E13_11 * omegadot12_3;
  // U13 = omega13~ omega13~ + omegadot13~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t13_1 = omega13_3 * omega13_3;
  const T t13_2 = omega13_2 * omega13_2;
  const T minus_U13_11 = t13_1 + t13_2;
  const T t13_3 = omega13_2 * omega13_1;
  const T U13_12 = t13_3 - omegadot13_3;
  const T t13_4 = omega13_3 * omega13_1;
  const T U13_13 = t13_4 + omegadot12_2;
  const T U13_21 = t13_3 + omegadot13_3;
  const T t13_5 = omega13_1 * omega13_1;
  const T minus_U13_22 = t13_1 + t13_5;
  const T t13_6 = omega13_3 * omega13_2;
  const T U13_23 = t13_6 - omegadot13_1;
  const T U13_31 = t13_4 - omegadot12_2;
  const T U13_32 = t13_6 + omegadot13_1;
  const T minus_U13_33 = t13_2 + t13_5;
  // Pddot13 = E13 (U12 q13 + Pddot12): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t13_7 = U12_12 * T(0.65) - minus_U12_11 * T(0.3) + U12_13 * T(0.1) + Pddot12_1;
  const T t13_8 = U12_31 * T(0.3) + U12_32 * T(0.65) - minus_U12_33 * T(0.1) + Pddot12_3;
  const T Pddot13_1 = E13_11 * t13_7 - minus_E13_13 * t13_8;
  const T Pddot13_2 = U12_21 * T(0.3) - minus_U12_22 * T(0.65) + U12_23 * T(0.1) + Pddot12_2;
  const T Pddot13_3 = minus_E13_13 * t13_7 + E13_11 * t13_8;
  // a13 = U13 r13 + Pddot13: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a13_1 = U13_12 * T(0.2) - minus_U13_11 * T(0.1) + U13_13 * T(0.05) + Pddot13_1;
  const T a13_2 = U13_21 * T(0.1) - minus_U13_22 * T(0.2) + U13_23 * T(0.05) + Pddot13_2;
  const T a13_3 = U13_31 * T(0.1) + U13_32 * T(0.2) - minus_U13_33 * T(0.05) + Pddot13_3;
  // G13 = -m13 a13: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G13_1 = T(2.3) * a13_1;
  const T minus_G13_2 = T(2.3) * a13_2;
  const T minus_G13_3 = T(2.3) * a13_3;
  // N13 = -axial(U13 (tr(I13)/2 - I13)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N13_1 = T(0.06899999999999999) * U13_32 - T(0.16100000000000003) * U13_23 + T(0.0092) * (minus_U13_22
      - minus_U13_33) - T(0.0115) * U13_31 + T(0.0069) * U13_21;
  const T minus_N13_2 = T(0.16100000000000003) * U13_13 - T(0.115) * U13_31 - T(0.0069) * (minus_U13_33 -
      minus_U13_11) + T(0.0092) * U13_12 + T(0.0115) * U13_32;
  const T minus_N13_3 = T(0.115) * U13_21 - T(0.06899999999999999) * U13_12 - T(0.0115) * (minus_U13_11 -
      minus_U13_22) - T(0.0069) * U13_23 - T(0.0092) * U13_13;

  // ---- body 14 (body_14) on body 13
  const T theta14 = x[13];
  const T thetadot14 = y[13];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_11 = cos(theta14);
  const T E14_12 = sin(theta14);
  // omega14 = thetadot14 b14 + E14 omega13: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = E14_11 * omega13_1 + E14_12 * omega13_2;
  const T omega14_2 = E14_11 * omega13_2 - E14_12 * omega13_1;
  const T omega14_3 = thetadot14 + omega13_3;
  // omegadot14 = -thetadot14 b14~ E14 omega13 + E14 omegadot13: angular acceleration, body axes [rad/s^2]
  const T omegadot14_1 = thetadot14 * omega14_2 + E14_11 * omegadot13_1 + E14_12 * omegadot12_2;
  const T omegadot14_2 = E14_11 * omegadot12_2 - E14_12 * omegadot13_1 - thetadot14 * omega14_1;
  // U14 = omega14~ omega14~ + omegadot14~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t14_1 = omega14_3 * omega14_3;
  const T t14_2 = omega14_2 * omega14_2;
  const T minus_U14_11 = t14_1 + t14_2;
  const T t14_3 = omega14_2 * omega14_1;
  const T U14_12 = t14_3 - omegadot13_3;
  const T t14_4 = omega14_3 * omega14_1;
  const T U14_13 = t14_4 + omegadot14_2;
  const T U14_21 = t14_3 + omegadot13_3;
  const T t14_5 = omega14_1 * omega14_1;
  const T minus_U14_22 = t14_1 + t14_5;
  const T t14_6 = omega14_3 * omega14_2;
  const T U14_23 = t14_6 - omegadot14_1;
  const T U14_31 = t14_4 - omegadot14_2;
  const T U14_32 = t14_6 + omegadot14_1;
  const T minus_U14_33 = t14_2 + t14_5;
  // Pddot14 = E14 (U13 q14 + Pddot13): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t14_7 = U13_12 * T(0.7) - minus_U13_11 * T(0.3) + U13_13 * T(0.1) + Pddot13_1;
  const T t14_8 = U13_21 * T(0.3) - minus_U13_22 * T(0.7) + U13_23 * T(0.1) + Pddot13_2;
  const T Pddot14_1 = E14_11 * t14_7 + E14_12 * t14_8;
  const T Pddot14_2 = E14_11 * t14_8 - E14_12 * t14_7;
  const T Pddot14_3 = U13_31 * T(0.3) + U13_32 * T(0.7) - minus_U13_33 * T(0.1) + Pddot13_3;
  // a14 = U14 r14 + Pddot14: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a14_1 = U14_12 * T(0.2) - minus_U14_11 * T(0.1) + U14_13 * T(0.05) + Pddot14_1;
  const T a14_2 = U14_21 * T(0.1) - minus_U14_22 * T(0.2) + U14_23 * T(0.05) + Pddot14_2;
  const T a14_3 = U14_31 * T(0.1) + U14_32 * T(0.2) - minus_U14_33 * T(0.05) + Pddot14_3;
  // G14 = -m14 a14: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G14_1 = T(2.4) * a14_1;
  const T minus_G14_2 = T(2.4) * a14_2;
  const T minus_G14_3 = T(2.4) * a14_3;
  // N14 = -axial(U14 (tr(I14)/2 - I14)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N14_1 = T(0.07200000000000001) * U14_32 - T(0.16799999999999998) * U14_23 + T(0.0096) * (minus_U14_22
      - minus_U14_33) - T(0.012) * U14_31 + T(0.0072) * U14_21;
  const T minus_N14_2 = T(0.16799999999999998) * U14_13 - T(0.12) * U14_31 - T(0.0072) * (minus_U14_33 - minus_U14_11)
      + T(0.0096) * U14_12 + T(0.012) * U14_32;
  const T minus_N14_3 = T(0.12) * U14_21 - T(0.07200000000000001) * U14_12 - T(0.012) * (minus_U14_11 - minus_U14_22)
      - T(0.0072) * U14_23 - T(0.0096) * U14_13;

  // ---- body 15 (body_15) on body 14
  const T theta15 = x[14];
  const T thetadot15 = y[14];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_22 = cos(theta15);
  const T E15_23 = sin(theta15);
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = thetadot15 + omega14_1;
  const T omega15_2 = E15_22 * omega14_2 + E15_23 * omega14_3;
  const T omega15_3 = E15_22 * omega14_3 - E15_23 * omega14_2;
  // omegadot15 = -thetadot15 b15~ E15 omega14 + E15 omegadot14: angular acceleration, body axes [rad/s^2]
  const T omegadot15_2 = thetadot15 * omega15_3 + E15_22 * omegadot14_2 + E15_23 * omegadot13_3;
  const T omegadot15_3 = E15_22 * omegadot13_3 - E15_23 * omegadot14_2 - thetadot15 * omega15_2;
  // U15 = omega15~ omega15~ + omegadot15~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t15_1 = omega15_3 * omega15_3;
  const T t15_2 = omega15_2 * omega15_2;
  const T minus_U15_11 = t15_1 + t15_2;
  const T t15_3 = omega15_2 * omega15_1;
  const T U15_12 = t15_3 - omegadot15_3;
  const T t15_4 = omega15_3 * omega15_1;
  const T U15_13 = t15_4 + omegadot15_2;
  const T U15_21 = t15_3 + omegadot15_3;
  const T t15_5 = omega15_1 * omega15_1;
  const T minus_U15_22 = t15_1 + t15_5;
  const T t15_6 = omega15_3 * omega15_2;
  const T U15_23 = t15_6 - omegadot14_1;
  const T U15_31 = t15_4 - omegadot15_2;
  const T U15_32 = t15_6 + omegadot14_1;
  const T minus_U15_33 = t15_2 + t15_5;
  // Pddot15 = E15 (U14 q15 + Pddot14): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot15_1 = U14_12 * T(0.75) - minus_U14_11 * T(0.3) + U14_13 * T(0.1) + Pddot14_1;
  const T t15_7 = U14_21 * T(0.3) - minus_U14_22 * T(0.75) + U14_23 * T(0.1) + Pddot14_2;
  const T t15_8 = U14_31 * T(0.3) + U14_32 * T(0.75) - minus_U14_33 * T(0.1) + Pddot14_3;
  const T Pddot15_2 = E15_22 * t15_7 + E15_23 * t15_8;
  const T Pddot15_3 = E15_22 * t15_8 - E15_23 * t15_7;
  // a15 = U15 r15 + Pddot15: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a15_1 = U15_12 * T(0.2) - minus_U15_11 * T(0.1) + U15_13 * T(0.05) + Pddot15_1;
  const T a15_2 = U15_21 * T(0.1) - minus_U15_22 * T(0.2) + U15_23 * T(0.05) + Pddot15_2;
  const T a15_3 = U15_31 * T(0.1) + U15_32 * T(0.2) - minus_U15_33 * T(0.05) + Pddot15_3;
  // G15 = -m15 a15: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G15_1 = T(2.5) * a15_1;
  const T minus_G15_2 = T(2.5) * a15_2;
  const T minus_G15_3 = T(2.5) * a15_3;
  // N15 = -axial(U15 (tr(I15)/2 - I15)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N15_1 = T(0.07500000000000001) * U15_32 - T(0.175) * U15_23 + T(0.01) * (minus_U15_22 - minus_U15_33)
      - T(0.0125) * U15_31 + T(0.0075) * U15_21;
  const T minus_N15_2 = T(0.175) * U15_13 - T(0.125) * U15_31 - T(0.0075) * (minus_U15_33 - minus_U15_11) + T(0.01) *
      U15_12 + T(0.0125) * U15_32;
  const T minus_N15_3 = T(0.125) * U15_21 - T(0.07500000000000001) * U15_12 - T(0.0125) * (minus_U15_11 -
      minus_U15_22) - T(0.0075) * U15_23 - T(0.01) * U15_13;

  // ---- body 16 (body_16) on body 15
  const T theta16 = x[15];
  const T thetadot16 = y[15];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cos(theta16);
  const T minus_E16_13 = sin(theta16);
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T omega16_1 = E16_11 * omega15_1 - minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 + E16_11 * omega15_3;
  // omegadot16 = -thetadot16 b16~ E16 omega15 + E16 omegadot15: angular acceleration, body axes [rad/s^2]
  const T omegadot16_1 = E16_11 * omegadot14_1 - minus_E16_13 * omegadot15_3 - thetadot16 * omega16_3;
  const T omegadot16_3 = thetadot16 * omega16_1 + minus_E16_13 * omegadot14_1 + E16_11 * omegadot15_3;
  // U16 = omega16~ omega16~ + omegadot16~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t16_1 = omega16_3 * omega16_3;
  const T t16_2 = omega16_2 * omega16_2;
  const T minus_U16_11 = t16_1 + t16_2;
  const T t16_3 = omega16_2 * omega16_1;
  const T U16_12 = t16_3 - omegadot16_3;
  const T t16_4 = omega16_3 * omega16_1;
  const T U16_13 = t16_4 + omegadot15_2;
  const T U16_21 = t16_3 + omegadot16_3;
  const T t16_5 = omega16_1 * omega16_1;
  const T minus_U16_22 = t16_1 + t16_5;
  const T t16_6 = omega16_3 * omega16_2;
  const T U16_23 = t16_6 - omegadot16_1;
  const T U16_31 = t16_4 - omegadot15_2;
  const T U16_32 = t16_6 + omegadot16_1;
  const T minus_U16_33 = t16_2 + t16_5;
  // Pddot16 = E16 (U15 q16 + Pddot15): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t16_7 = U15_12 * T(0.8) - minus_U15_11 * T(0.3) + U15_13 * T(0.1) + Pddot15_1;
  const T t16_8 = U15_31 * T(0.3) + U15_32 * T(0.8) - minus_U15_33 * T(0.1) + Pddot15_3;
  const T Pddot16_1 = E16_11 * t16_7 - minus_E16_13 * t16_8;
  const T Pddot16_2 = U15_21 * T(0.3) - minus_U15_22 * T(0.8) + U15_23 * T(0.1) + Pddot15_2;
  const T Pddot16_3 = minus_E16_13 * t16_7 + E16_11 * t16_8;
  // a16 = U16 r16 + Pddot16: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a16_1 = U16_12 * T(0.2) - minus_U16_11 * T(0.1) + U16_13 * T(0.05) + Pddot16_1;
  const T a16_2 = U16_21 * T(0.1) - minus_U16_22 * T(0.2) + U16_23 * T(0.05) + Pddot16_2;
  const T a16_3 = U16_31 * T(0.1) + U16_32 * T(0.2) - minus_U16_33 * T(0.05) + Pddot16_3;
  // G16 = -m16 a16: applied less inertia force at ydot = 0, body axes [N]
  const T minus_G16_1 = T(2.6) * a16_1;
  const T minus_G16_2 = T(2.6) * a16_2;
  const T minus_G16_3 = T(2.6) * a16_3;
  // N16 = -axial(U16 (tr(I16)/2 - I16)): applied less inertia moment at ydot = 0, body axes [N m]
  const T minus_N16_1 = T(0.078) * U16_32 - T(0.182) * U16_23 + T(0.0104) * (minus_U16_22 - minus_U16_33) - T(0.013) *
      U16_31 + T(0.0078) * U16_21;
  const T minus_N16_2 = T(0.182) * U16_13 - T(0.13) * U16_31 - T(0.0078) * (minus_U16_33 - minus_U16_11) + T(0.0104) *
      U16_12 + T(0.013) * U16_32;
  const T minus_N16_3 = T(0.13) * U16_21 - T(0.078) * U16_12 - T(0.013) * (minus_U16_11 - minus_U16_22) - T(0.0078) *
      U16_23 - T(0.0104) * U16_13;

  // ---- body 16 (body_16) and what it carries
  // rho16 = r16~ G16 + N16: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho16_1 = T(0.05) * minus_G16_2 - T(0.2) * minus_G16_3 - minus_N16_1;
  const T rho16_2 = T(0.1) * minus_G16_3 - T(0.05) * minus_G16_1 - minus_N16_2;
  const T b16_1 = T(0.1) * minus_G16_2;
  const T rho16_3 = T(0.2) * minus_G16_1 - b16_1 - minus_N16_3;
  // hc16 = E16^T h16: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc16_1 = minus_E16_13 * T(0.13) + E16_11 * T(0.26);
  const T hc16_3 = E16_11 * T(0.13) - minus_E16_13 * T(0.26);

  // ---- body 15 (body_15) and what it carries
  // S15 = E16^T G16 + G15: sum of the force balances of the subtree, body axes [N]
  const T b15_1 = E16_11 * minus_G16_1 + minus_E16_13 * minus_G16_3;
  const T minus_S15_1 = b15_1 + minus_G15_1;
  const T minus_S15_2 = minus_G16_2 + minus_G15_2;
  const T b15_2 = minus_E16_13 * minus_G16_1 - E16_11 * minus_G16_3;
  const T S15_3 = b15_2 - minus_G15_3;
  // rho15 = q16~ E16^T G16 + E16^T rho16 + r15~ G15 + N15: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho15_1 = b16_1 + T(0.8) * b15_2 + E16_11 * rho16_1 + minus_E16_13 * rho16_3 + T(0.05) * minus_G15_2 -
      T(0.2) * minus_G15_3 - minus_N15_1;
  const T rho15_2 = rho16_2 - T(0.1) * b15_1 - T(0.3) * b15_2 + T(0.1) * minus_G15_3 - T(0.05) * minus_G15_1 -
      minus_N15_2;
  const T rho15_3 = T(0.8) * b15_1 - T(0.3) * minus_G16_2 + E16_11 * rho16_3 - minus_E16_13 * rho16_1 + T(0.2) *
      minus_G15_1 - T(0.1) * minus_G15_2 - minus_N15_3;
  // h15 = m15 r15 + m16 q16 + hc16: first moment of mass carried, about the body origin, body axes [kg m]
  const T h15_1 = T(1.03) + hc16_1;
  const T h15_3 = T(0.385) + hc16_3;
  // J15 = -q16~ hc16~ + E16^T J16 E16 - m15 r15~ r15~ + I15 + (-m16 q16~ - hc16~) q16~: inertia carried, about the
  //   body origin, body axes [kg m^2]
  const T b15_3 = minus_E16_13 * T(0.005200000000000002);
  const T b15_4 = E16_11 * T(0.37050000000000005) - b15_3;
  const T b15_5 = E16_11 * T(0.005200000000000002);
  const T b15_6 = minus_E16_13 * T(0.338) - b15_5;
  const T b15_7 = T(0.1) * hc16_3;
  const T b15_8 = hc16_3 + T(0.26);
  const T b15_9 = b15_8 * T(0.1);
  const T J15_11 = b15_4 * E16_11 + b15_6 * minus_E16_13 + b15_7 + T(2.85225) + b15_9;
  const T b15_10 = E16_11 * T(0.03900000000000001) + minus_E16_13 * T(0.0364);
  const T b15_11 = T(0.8) * hc16_1 + b15_10;
  const T minus_J15_12 = T(0.8175) + b15_11;
  const T b15_12 = b15_6 * E16_11 - b15_4 * minus_E16_13 - T(0.005000000000000002);
  const T J15_13 = b15_12 - T(0.1) * hc16_1 - b15_8 * T(0.3);
  const T b15_13 = hc16_1 + T(0.78);
  const T minus_J15_21 = T(0.1935) + b15_10 + b15_13 * T(0.8);
  const T b15_14 = T(0.3) * hc16_1;
  const T b15_15 = b15_7 + b15_14 + T(0.34450000000000003);
  const T b15_16 = b15_13 * T(0.3);
  const T J15_22 = b15_15 + T(0.33125) + b15_9 + b15_16;
  const T b15_17 = minus_E16_13 * T(0.03900000000000001) - E16_11 * T(0.0364);
  const T J15_23 = b15_17 - T(0.08700000000000001) - b15_8 * T(0.8);
  const T J15_31 = b15_12 - T(0.3) * hc16_3 - b15_13 * T(0.1);
  const T b15_18 = b15_17 - T(0.8) * hc16_3;
  const T J15_32 = b15_18 - T(0.29500000000000004);
  const T J15_33 = (minus_E16_13 * T(0.37050000000000005) + b15_5) * minus_E16_13 + (b15_3 + E16_11 * T(0.338)) *
      E16_11 + T(2.821) + b15_14 + b15_16;
  // hc15 = E15^T h15: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc15_2 = E15_22 * T(3.1) - E15_23 * h15_3;
  const T hc15_3 = E15_22 * h15_3 + E15_23 * T(3.1);
  // D_thetaddot15: pivots of L D L^T
  const T b15_19 = b15_11 * T(2.9027576197387517);
  const T D_thetaddot15 = J15_11 - b15_19 * b15_11;

  // ---- body 14 (body_14) and what it carries
  // S14 = E15^T S15 + G14: sum of the force balances of the subtree, body axes [N]
  const T minus_S14_1 = minus_S15_1 + minus_G14_1;
  const T b14_1 = E15_22 * minus_S15_2 + E15_23 * S15_3;
  const T minus_S14_2 = b14_1 + minus_G14_2;
  const T b14_2 = E15_22 * S15_3 - E15_23 * minus_S15_2;
  const T S14_3 = b14_2 - minus_G14_3;
  // rho14 = q15~ E15^T S15 + E15^T rho15 + r14~ G14 + N14: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho14_1 = T(0.1) * b14_1 + T(0.75) * b14_2 + rho15_1 + T(0.05) * minus_G14_2 - T(0.2) * minus_G14_3 -
      minus_N14_1;
  const T rho14_2 = E15_22 * rho15_2 - E15_23 * rho15_3 - T(0.1) * minus_S15_1 - T(0.3) * b14_2 + T(0.1) * minus_G14_3
      - T(0.05) * minus_G14_1 - minus_N14_2;
  const T rho14_3 = T(0.75) * minus_S15_1 - T(0.3) * b14_1 + E15_23 * rho15_2 + E15_22 * rho15_3 + T(0.2) *
      minus_G14_1 - T(0.1) * minus_G14_2 - minus_N14_3;
  // h14 = m14 r14 + m_sub15 q15 + hc15: first moment of mass carried, about the body origin, body axes [kg m]
  const T h14_1 = T(1.77) + h15_1;
  const T h14_2 = T(4.305) + hc15_2;
  const T h14_3 = T(0.63) + hc15_3;
  // J14 = -q15~ hc15~ + E15^T J15 E15 - m14 r14~ r14~ + I14 + (-m_sub15 q15~ - hc15~) q15~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b14_3 = T(0.1) * hc15_3;
  const T b14_4 = T(0.75) * hc15_2;
  const T b14_5 = b14_3 + b14_4 + J15_11;
  const T b14_6 = hc15_3 + T(0.51);
  const T b14_7 = b14_6 * T(0.1);
  const T b14_8 = T(3.825) + hc15_2;
  const T b14_9 = b14_8 * T(0.75);
  const T J14_11 = b14_5 + T(0.342) + b14_7 + b14_9;
  const T b14_10 = minus_J15_12 * E15_22 + J15_13 * E15_23 + T(0.036000000000000004);
  const T minus_J14_12 = b14_10 + T(0.75) * h15_1 + b14_8 * T(0.3);
  const T J14_13 = J15_13 * E15_22 - minus_J15_12 * E15_23 - T(0.1) * h15_1 - T(0.004800000000000001) - b14_6 *
      T(0.3);
  const T b14_11 = T(0.3) * hc15_2;
  const T b14_12 = h15_1 + T(1.53);
  const T minus_J14_21 = b14_10 + b14_11 + b14_12 * T(0.75);
  const T b14_13 = E15_22 * J15_22 - E15_23 * J15_32;
  const T b14_14 = E15_22 * J15_23 - E15_23 * J15_33;
  const T b14_15 = T(0.3) * h15_1 + b14_12 * T(0.3);
  const T J14_22 = b14_13 * E15_22 - b14_14 * E15_23 + b14_3 + b14_15 + T(0.318) + b14_7;
  const T J14_23 = b14_13 * E15_23 + b14_14 * E15_22 - T(0.1) * hc15_2 - T(0.0336) - b14_6 * T(0.75);
  const T J14_33 = (E15_23 * J15_22 + E15_22 * J15_32) * E15_23 + (E15_23 * J15_23 + E15_22 * J15_33) * E15_22 + b14_4
      + b14_15 + T(0.312) + b14_9;
  // hc14 = E14^T h14: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc14_1 = E14_11 * h14_1 - E14_12 * h14_2;
  const T hc14_2 = E14_11 * h14_2 + E14_12 * h14_1;
  // B_thetadot16_14 = E15^T B_thetadot16_15
  const T B_thetadot16_14_2 = E15_23 * hc16_1;
  const T minus_B_thetadot16_14_3 = E15_22 * hc16_1;
  // K_thetadot16_14 = q15~ E15^T B_thetadot16_15 + E15^T K_thetadot16_15
  const T minus_K_thetadot16_14_1 = T(0.1) * B_thetadot16_14_2 + T(0.75) * minus_B_thetadot16_14_3 + b15_11;
  const T b14_16 = T(0.3) * minus_B_thetadot16_14_3;
  const T K_thetadot16_14_2 = b15_7 + b14_16 + E15_22 * b15_15 - E15_23 * b15_18;
  const T K_thetadot16_14_3 = T(0.3) * B_thetadot16_14_2 - T(0.75) * hc16_3 + E15_23 * b15_15 + E15_22 * b15_18;
  // K_thetadot15_14 = q15~ E15^T B_thetadot15_15 + E15^T K_thetadot15_15
  const T minus_K_thetadot15_14_2 = E15_22 * minus_J15_21 + E15_23 * J15_31 + b14_11;
  const T K_thetadot15_14_3 = E15_22 * J15_31 - E15_23 * minus_J15_21 - T(0.3) * hc15_3;
  // D_thetaddot14: pivots of L D L^T
  const T b14_17 = K_thetadot16_14_3 * T(2.9027576197387517);
  const T b14_18 = K_thetadot15_14_3 + b14_17 * b15_11;
  const T b14_19 = T(1) / D_thetaddot15;
  const T b14_20 = b14_18 * b14_19;
  const T D_thetaddot14 = J14_33 - b14_17 * K_thetadot16_14_3 - b14_20 * b14_18;

  // ---- body 13 (body_13) and what it carries
  // S13 = E14^T S14 + G13: sum of the force balances of the subtree, body axes [N]
  const T b13_1 = E14_12 * minus_S14_2 - E14_11 * minus_S14_1;
  const T S13_1 = b13_1 - minus_G13_1;
  const T b13_2 = E14_12 * minus_S14_1 + E14_11 * minus_S14_2;
  const T minus_S13_2 = b13_2 + minus_G13_2;
  const T S13_3 = S14_3 - minus_G13_3;
  // rho13 = q14~ E14^T S14 + E14^T rho14 + r13~ G13 + N13: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho13_1 = T(0.1) * b13_2 + T(0.7) * S14_3 + E14_11 * rho14_1 - E14_12 * rho14_2 + T(0.05) * minus_G13_2 -
      T(0.2) * minus_G13_3 - minus_N13_1;
  const T rho13_2 = T(0.1) * b13_1 - T(0.3) * S14_3 + E14_12 * rho14_1 + E14_11 * rho14_2 + T(0.1) * minus_G13_3 -
      T(0.05) * minus_G13_1 - minus_N13_2;
  const T rho13_3 = rho14_3 - T(0.3) * b13_2 - T(0.7) * b13_1 + T(0.2) * minus_G13_1 - T(0.1) * minus_G13_2 -
      minus_N13_3;
  // h13 = m13 r13 + m_sub14 q14 + hc14: first moment of mass carried, about the body origin, body axes [kg m]
  const T h13_1 = T(2.48) + hc14_1;
  const T h13_2 = T(5.71) + hc14_2;
  const T h13_3 = T(0.865) + h14_3;
  // J13 = -q14~ hc14~ + E14^T J14 E14 - m13 r13~ r13~ + I13 + (-m_sub14 q14~ - hc14~) q14~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b13_3 = E14_11 * J14_11 + E14_12 * minus_J14_21;
  const T b13_4 = E14_11 * minus_J14_12 + E14_12 * J14_22;
  const T b13_5 = h14_3 + T(0.75);
  const T b13_6 = T(0.1) * h14_3 + b13_5 * T(0.1);
  const T b13_7 = T(0.7) * hc14_2;
  const T b13_8 = T(5.25) + hc14_2;
  const T b13_9 = b13_8 * T(0.7);
  const T J13_11 = b13_3 * E14_11 + b13_4 * E14_12 + b13_6 + b13_7 + T(0.32775) + b13_9;
  const T b13_10 = b13_3 * E14_12 - b13_4 * E14_11 - T(0.0345);
  const T J13_12 = b13_10 - T(0.7) * hc14_1 - b13_8 * T(0.3);
  const T b13_11 = E14_11 * J14_13 - E14_12 * J14_23;
  const T b13_12 = T(0.1) * hc14_1;
  const T b13_13 = b13_11 - b13_12;
  const T J13_13 = b13_13 - T(0.004600000000000001) - b13_5 * T(0.3);
  const T b13_14 = hc14_1 + T(2.25);
  const T J13_21 = b13_10 - T(0.3) * hc14_2 - b13_14 * T(0.7);
  const T b13_15 = T(0.3) * hc14_1;
  const T b13_16 = b13_14 * T(0.3);
  const T J13_22 = (E14_12 * J14_11 - E14_11 * minus_J14_21) * E14_12 + (E14_11 * J14_22 - E14_12 * minus_J14_12) *
      E14_11 + b13_6 + b13_15 + T(0.30475) + b13_16;
  const T b13_17 = E14_12 * J14_13 + E14_11 * J14_23;
  const T b13_18 = b13_17 - T(0.1) * hc14_2;
  const T J13_23 = b13_18 - T(0.0322) - b13_5 * T(0.7);
  const T J13_31 = b13_11 - T(0.3) * h14_3 - T(0.004600000000000001) - b13_14 * T(0.1);
  const T J13_32 = b13_17 - T(0.7) * h14_3 - T(0.0322) - b13_8 * T(0.1);
  const T b13_19 = b13_15 + b13_7 + J14_33;
  const T J13_33 = b13_19 + T(0.299) + b13_9 + b13_16;
  // hc13 = E13^T h13: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc13_1 = minus_E13_13 * h13_3 + E13_11 * h13_1;
  const T hc13_3 = E13_11 * h13_3 - minus_E13_13 * h13_1;
  // B_thetadot16_13 = E14^T B_thetadot16_14
  const T B_thetadot16_13_1 = E14_11 * hc16_3 - E14_12 * B_thetadot16_14_2;
  const T B_thetadot16_13_2 = E14_12 * hc16_3 + E14_11 * B_thetadot16_14_2;
  // K_thetadot16_13 = q14~ E14^T B_thetadot16_14 + E14^T K_thetadot16_14
  const T b13_20 = T(0.1) * B_thetadot16_13_2;
  const T minus_K_thetadot16_13_1 = b13_20 + T(0.7) * minus_B_thetadot16_14_3 + E14_11 * minus_K_thetadot16_14_1 +
      E14_12 * K_thetadot16_14_2;
  const T K_thetadot16_13_2 = T(0.1) * B_thetadot16_13_1 + b14_16 + E14_11 * K_thetadot16_14_2 - E14_12 *
      minus_K_thetadot16_14_1;
  const T b13_21 = T(0.3) * B_thetadot16_13_2;
  const T K_thetadot16_13_3 = b13_21 - T(0.7) * B_thetadot16_13_1 + K_thetadot16_14_3;
  // B_thetadot15_13 = E14^T B_thetadot15_14
  const T B_thetadot15_13_1 = E14_12 * hc15_3;
  const T minus_B_thetadot15_13_2 = E14_11 * hc15_3;
  // K_thetadot15_13 = q14~ E14^T B_thetadot15_14 + E14^T K_thetadot15_14
  const T b13_22 = T(0.1) * minus_B_thetadot15_13_2;
  const T K_thetadot15_13_1 = b13_22 + T(0.7) * hc15_2 + E14_11 * b14_5 + E14_12 * minus_K_thetadot15_14_2;
  const T K_thetadot15_13_2 = T(0.1) * B_thetadot15_13_1 - b14_11 + E14_12 * b14_5 - E14_11 * minus_K_thetadot15_14_2;
  const T b13_23 = T(0.3) * minus_B_thetadot15_13_2;
  const T K_thetadot15_13_3 = K_thetadot15_14_3 - b13_23 - T(0.7) * B_thetadot15_13_1;
  // D_thetaddot13: pivots of L D L^T
  const T b13_24 = K_thetadot16_13_2 * T(2.9027576197387517);
  const T b13_25 = K_thetadot15_13_2 + b13_24 * b15_11;
  const T b13_26 = b13_25 * b14_19;
  const T b13_27 = b13_18 - b13_24 * K_thetadot16_14_3 - b13_26 * b14_18;
  const T b13_28 = T(1) / D_thetaddot14;
  const T b13_29 = b13_27 * b13_28;
  const T D_thetaddot13 = J13_22 - b13_24 * K_thetadot16_13_2 - b13_26 * b13_25 - b13_29 * b13_27;

  // ---- body 12 (body_12) and what it carries
  // S12 = E13^T S13 + G12: sum of the force balances of the subtree, body axes [N]
  const T b12_1 = E13_11 * S13_1 + minus_E13_13 * S13_3;
  const T S12_1 = b12_1 - minus_G12_1;
  const T minus_S12_2 = minus_S13_2 + minus_G12_2;
  const T b12_2 = E13_11 * S13_3 - minus_E13_13 * S13_1;
  const T S12_3 = b12_2 - minus_G12_3;
  // rho12 = q13~ E13^T S13 + E13^T rho13 + r12~ G12 + N12: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho12_1 = T(0.1) * minus_S13_2 + T(0.65) * b12_2 + E13_11 * rho13_1 + minus_E13_13 * rho13_3 + T(0.05) *
      minus_G12_2 - T(0.2) * minus_G12_3 - minus_N12_1;
  const T rho12_2 = T(0.1) * b12_1 - T(0.3) * b12_2 + rho13_2 + T(0.1) * minus_G12_3 - T(0.05) * minus_G12_1 -
      minus_N12_2;
  const T rho12_3 = E13_11 * rho13_3 - minus_E13_13 * rho13_1 - T(0.3) * minus_S13_2 - T(0.65) * b12_1 + T(0.2) *
      minus_G12_1 - T(0.1) * minus_G12_2 - minus_N12_3;
  // h12 = m12 r12 + m_sub13 q13 + hc13: first moment of mass carried, about the body origin, body axes [kg m]
  const T h12_1 = T(3.1599999999999997) + hc13_1;
  const T h12_2 = T(6.8100000000000005) + h13_2;
  const T h12_3 = T(1.09) + hc13_3;
  // J12 = -q13~ hc13~ + E13^T J13 E13 - m12 r12~ r12~ + I12 + (-m_sub13 q13~ - hc13~) q13~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b12_3 = E13_11 * J13_11 + minus_E13_13 * J13_31;
  const T b12_4 = E13_11 * J13_13 + minus_E13_13 * J13_33;
  const T b12_5 = T(0.1) * hc13_3;
  const T b12_6 = T(6.37) + h13_2;
  const T b12_7 = T(0.65) * h13_2 + b12_6 * T(0.65);
  const T b12_8 = hc13_3 + T(0.98);
  const T b12_9 = b12_8 * T(0.1);
  const T J12_11 = b12_3 * E13_11 + b12_4 * minus_E13_13 + b12_5 + b12_7 + T(0.3135) + b12_9;
  const T b12_10 = E13_11 * J13_12 + minus_E13_13 * J13_32;
  const T b12_11 = b12_10 - T(0.65) * hc13_1;
  const T J12_12 = b12_11 - T(0.03300000000000001) - b12_6 * T(0.3);
  const T b12_12 = b12_4 * E13_11 - b12_3 * minus_E13_13 - T(0.004400000000000002);
  const T J12_13 = b12_12 - T(0.1) * hc13_1 - b12_8 * T(0.3);
  const T b12_13 = hc13_1 + T(2.94);
  const T J12_21 = b12_10 - T(0.3) * h13_2 - T(0.03300000000000001) - b12_13 * T(0.65);
  const T b12_14 = T(0.3) * hc13_1;
  const T b12_15 = b12_5 + b12_14 + J13_22;
  const T b12_16 = b12_13 * T(0.3);
  const T J12_22 = b12_15 + T(0.29150000000000004) + b12_9 + b12_16;
  const T b12_17 = J13_23 * E13_11 - J13_21 * minus_E13_13 - T(0.030800000000000004);
  const T J12_23 = b12_17 - T(0.1) * h13_2 - b12_8 * T(0.65);
  const T J12_31 = b12_12 - T(0.3) * hc13_3 - b12_13 * T(0.1);
  const T b12_18 = T(0.65) * hc13_3;
  const T J12_32 = b12_17 - b12_18 - b12_6 * T(0.1);
  const T J12_33 = (E13_11 * J13_33 - minus_E13_13 * J13_13) * E13_11 - (E13_11 * J13_31 - minus_E13_13 * J13_11) *
      minus_E13_13 + b12_7 + b12_14 + T(0.28600000000000003) + b12_16;
  // hc12 = E12^T h12: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc12_2 = E12_22 * h12_2 - E12_23 * h12_3;
  const T hc12_3 = E12_22 * h12_3 + E12_23 * h12_2;
  // B_thetadot16_12 = E13^T B_thetadot16_13
  const T B_thetadot16_12_1 = E13_11 * B_thetadot16_13_1 - minus_E13_13 * minus_B_thetadot16_14_3;
  const T minus_B_thetadot16_12_3 = minus_E13_13 * B_thetadot16_13_1 + E13_11 * minus_B_thetadot16_14_3;
  // K_thetadot16_12 = q13~ E13^T B_thetadot16_13 + E13^T K_thetadot16_13
  const T K_thetadot16_12_1 = minus_E13_13 * K_thetadot16_13_3 - E13_11 * minus_K_thetadot16_13_1 - b13_20 - T(0.65) *
      minus_B_thetadot16_12_3;
  const T b12_19 = T(0.1) * B_thetadot16_12_1;
  const T K_thetadot16_12_2 = b12_19 + T(0.3) * minus_B_thetadot16_12_3 + K_thetadot16_13_2;
  const T K_thetadot16_12_3 = b13_21 - T(0.65) * B_thetadot16_12_1 + minus_E13_13 * minus_K_thetadot16_13_1 + E13_11 *
      K_thetadot16_13_3;
  // B_thetadot15_12 = E13^T B_thetadot15_13
  const T B_thetadot15_12_1 = E13_11 * B_thetadot15_13_1 + minus_E13_13 * hc15_2;
  const T B_thetadot15_12_3 = E13_11 * hc15_2 - minus_E13_13 * B_thetadot15_13_1;
  // K_thetadot15_12 = q13~ E13^T B_thetadot15_13 + E13^T K_thetadot15_13
  const T K_thetadot15_12_1 = b13_22 + T(0.65) * B_thetadot15_12_3 + E13_11 * K_thetadot15_13_1 + minus_E13_13 *
      K_thetadot15_13_3;
  const T b12_20 = T(0.1) * B_thetadot15_12_1;
  const T K_thetadot15_12_2 = b12_20 - T(0.3) * B_thetadot15_12_3 + K_thetadot15_13_2;
  const T K_thetadot15_12_3 = E13_11 * K_thetadot15_13_3 - minus_E13_13 * K_thetadot15_13_1 - b13_23 - T(0.65) *
      B_thetadot15_12_1;
  // B_thetadot14_12 = E13^T B_thetadot14_13
  const T minus_B_thetadot14_12_1 = E13_11 * hc14_2;
  const T B_thetadot14_12_3 = minus_E13_13 * hc14_2;
  // K_thetadot14_12 = q13~ E13^T B_thetadot14_13 + E13^T K_thetadot14_13
  const T K_thetadot14_12_1 = T(0.65) * B_thetadot14_12_3 - b13_12 + E13_11 * b13_13 + minus_E13_13 * b13_19;
  const T b12_21 = T(0.1) * minus_B_thetadot14_12_1;
  const T K_thetadot14_12_2 = b13_18 - b12_21 - T(0.3) * B_thetadot14_12_3;
  const T K_thetadot14_12_3 = b13_15 + T(0.65) * minus_B_thetadot14_12_1 + E13_11 * b13_19 - minus_E13_13 * b13_13;
  // K_thetadot13_12 = q13~ E13^T B_thetadot13_13 + E13^T K_thetadot13_13
  const T K_thetadot13_12_3 = E13_11 * J13_32 - minus_E13_13 * J13_12 - b12_18;
  // D_thetaddot12: pivots of L D L^T
  const T b12_22 = K_thetadot16_12_1 * T(2.9027576197387517);
  const T b12_23 = K_thetadot15_12_1 + b12_22 * b15_11;
  const T b12_24 = b12_23 * b14_19;
  const T b12_25 = K_thetadot14_12_1 - b12_22 * K_thetadot16_14_3 - b12_24 * b14_18;
  const T b12_26 = b12_25 * b13_28;
  const T b12_27 = b12_11 - b12_22 * K_thetadot16_13_2 - b12_24 * b13_25 - b12_26 * b13_27;
  const T b12_28 = T(1) / D_thetaddot13;
  const T b12_29 = b12_27 * b12_28;
  const T D_thetaddot12 = J12_11 - b12_22 * K_thetadot16_12_1 - b12_24 * b12_23 - b12_26 * b12_25 - b12_29 * b12_27;

  // ---- body 11 (body_11) and what it carries
  // S11 = E12^T S12 + G11: sum of the force balances of the subtree, body axes [N]
  const T S11_1 = S12_1 - minus_G11_1;
  const T b11_1 = E12_22 * minus_S12_2 + E12_23 * S12_3;
  const T minus_S11_2 = b11_1 + minus_G11_2;
  const T b11_2 = E12_22 * S12_3 - E12_23 * minus_S12_2;
  const T S11_3 = b11_2 - minus_G11_3;
  // rho11 = q12~ E12^T S12 + E12^T rho12 + r11~ G11 + N11: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho11_1 = T(0.1) * b11_1 + T(0.6) * b11_2 + rho12_1 + T(0.05) * minus_G11_2 - T(0.2) * minus_G11_3 -
      minus_N11_1;
  const T rho11_2 = T(0.1) * S12_1 - T(0.3) * b11_2 + E12_22 * rho12_2 - E12_23 * rho12_3 + T(0.1) * minus_G11_3 -
      T(0.05) * minus_G11_1 - minus_N11_2;
  const T rho11_3 = E12_23 * rho12_2 + E12_22 * rho12_3 - T(0.3) * b11_1 - T(0.6) * S12_1 + T(0.2) * minus_G11_1 -
      T(0.1) * minus_G11_2 - minus_N11_3;
  // h11 = m11 r11 + m_sub12 q12 + hc12: first moment of mass carried, about the body origin, body axes [kg m]
  const T h11_1 = T(3.81) + h12_1;
  const T h11_2 = T(7.62) + hc12_2;
  const T h11_3 = T(1.3050000000000002) + hc12_3;
  // J11 = -q12~ hc12~ + E12^T J12 E12 - m11 r11~ r11~ + I11 + (-m_sub12 q12~ - hc12~) q12~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b11_3 = T(0.1) * hc12_3;
  const T b11_4 = T(0.6) * hc12_2;
  const T b11_5 = b11_3 + b11_4 + J12_11;
  const T b11_6 = hc12_3 + T(1.2000000000000002);
  const T b11_7 = b11_6 * T(0.1);
  const T b11_8 = T(7.199999999999999) + hc12_2;
  const T b11_9 = b11_8 * T(0.6);
  const T J11_11 = b11_5 + T(0.29925) + b11_7 + b11_9;
  const T b11_10 = J12_12 * E12_22 - J12_13 * E12_23 - T(0.03150000000000001);
  const T J11_12 = b11_10 - T(0.6) * h12_1 - b11_8 * T(0.3);
  const T J11_13 = J12_12 * E12_23 + J12_13 * E12_22 - T(0.1) * h12_1 - T(0.0042000000000000015) - b11_6 * T(0.3);
  const T b11_11 = T(0.3) * hc12_2;
  const T b11_12 = h12_1 + T(3.5999999999999996);
  const T J11_21 = b11_10 - b11_11 - b11_12 * T(0.6);
  const T b11_13 = E12_22 * J12_22 - E12_23 * J12_32;
  const T b11_14 = E12_22 * J12_23 - E12_23 * J12_33;
  const T b11_15 = T(0.3) * h12_1 + b11_12 * T(0.3);
  const T J11_22 = b11_13 * E12_22 - b11_14 * E12_23 + b11_3 + b11_15 + T(0.27825) + b11_7;
  const T J11_23 = b11_13 * E12_23 + b11_14 * E12_22 - T(0.1) * hc12_2 - T(0.029400000000000003) - b11_6 * T(0.6);
  const T J11_33 = (E12_23 * J12_22 + E12_22 * J12_32) * E12_23 + (E12_23 * J12_23 + E12_22 * J12_33) * E12_22 + b11_4
      + b11_15 + T(0.273) + b11_9;
  // hc11 = E11^T h11: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc11_1 = E11_11 * h11_1 - E11_12 * h11_2;
  const T hc11_2 = E11_11 * h11_2 + E11_12 * h11_1;
  // B_thetadot16_11 = E12^T B_thetadot16_12
  const T B_thetadot16_11_2 = E12_22 * B_thetadot16_13_2 + E12_23 * minus_B_thetadot16_12_3;
  const T B_thetadot16_11_3 = E12_23 * B_thetadot16_13_2 - E12_22 * minus_B_thetadot16_12_3;
  // K_thetadot16_11 = q12~ E12^T B_thetadot16_12 + E12^T K_thetadot16_12
  const T K_thetadot16_11_1 = T(0.6) * B_thetadot16_11_3 - T(0.1) * B_thetadot16_11_2 + K_thetadot16_12_1;
  const T b11_16 = T(0.3) * B_thetadot16_11_3;
  const T K_thetadot16_11_2 = b12_19 - b11_16 + E12_22 * K_thetadot16_12_2 - E12_23 * K_thetadot16_12_3;
  const T K_thetadot16_11_3 = T(0.3) * B_thetadot16_11_2 - T(0.6) * B_thetadot16_12_1 + E12_23 * K_thetadot16_12_2 +
      E12_22 * K_thetadot16_12_3;
  // B_thetadot15_11 = E12^T B_thetadot15_12
  const T minus_B_thetadot15_11_2 = E12_22 * minus_B_thetadot15_13_2 + E12_23 * B_thetadot15_12_3;
  const T B_thetadot15_11_3 = E12_22 * B_thetadot15_12_3 - E12_23 * minus_B_thetadot15_13_2;
  // K_thetadot15_11 = q12~ E12^T B_thetadot15_12 + E12^T K_thetadot15_12
  const T K_thetadot15_11_1 = T(0.1) * minus_B_thetadot15_11_2 + T(0.6) * B_thetadot15_11_3 + K_thetadot15_12_1;
  const T b11_17 = T(0.3) * B_thetadot15_11_3;
  const T K_thetadot15_11_2 = b12_20 - b11_17 + E12_22 * K_thetadot15_12_2 - E12_23 * K_thetadot15_12_3;
  const T K_thetadot15_11_3 = E12_23 * K_thetadot15_12_2 + E12_22 * K_thetadot15_12_3 - T(0.3) *
      minus_B_thetadot15_11_2 - T(0.6) * B_thetadot15_12_1;
  // B_thetadot14_11 = E12^T B_thetadot14_12
  const T B_thetadot14_11_2 = E12_22 * hc14_1 - E12_23 * B_thetadot14_12_3;
  const T B_thetadot14_11_3 = E12_23 * hc14_1 + E12_22 * B_thetadot14_12_3;
  // K_thetadot14_11 = q12~ E12^T B_thetadot14_12 + E12^T K_thetadot14_12
  const T K_thetadot14_11_1 = T(0.6) * B_thetadot14_11_3 - T(0.1) * B_thetadot14_11_2 + K_thetadot14_12_1;
  const T b11_18 = T(0.3) * B_thetadot14_11_3;
  const T K_thetadot14_11_2 = E12_22 * K_thetadot14_12_2 - E12_23 * K_thetadot14_12_3 - b12_21 - b11_18;
  const T K_thetadot14_11_3 = T(0.3) * B_thetadot14_11_2 + T(0.6) * minus_B_thetadot14_12_1 + E12_23 *
      K_thetadot14_12_2 + E12_22 * K_thetadot14_12_3;
  // B_thetadot13_11 = E12^T B_thetadot13_12
  const T B_thetadot13_11_2 = E12_23 * hc13_1;
  const T minus_B_thetadot13_11_3 = E12_22 * hc13_1;
  // K_thetadot13_11 = q12~ E12^T B_thetadot13_12 + E12^T K_thetadot13_12
  const T K_thetadot13_11_1 = b12_11 - T(0.1) * B_thetadot13_11_2 - T(0.6) * minus_B_thetadot13_11_3;
  const T b11_19 = T(0.3) * minus_B_thetadot13_11_3;
  const T K_thetadot13_11_2 = b12_5 + b11_19 + E12_22 * b12_15 - E12_23 * K_thetadot13_12_3;
  const T K_thetadot13_11_3 = T(0.3) * B_thetadot13_11_2 - T(0.6) * hc13_3 + E12_23 * b12_15 + E12_22 *
      K_thetadot13_12_3;
  // K_thetadot12_11 = q12~ E12^T B_thetadot12_12 + E12^T K_thetadot12_12
  const T K_thetadot12_11_2 = E12_22 * J12_21 - E12_23 * J12_31 - b11_11;
  const T K_thetadot12_11_3 = E12_23 * J12_21 + E12_22 * J12_31 - T(0.3) * hc12_3;
  // D_thetaddot11: pivots of L D L^T
  const T b11_20 = K_thetadot16_11_3 * T(2.9027576197387517);
  const T b11_21 = K_thetadot15_11_3 + b11_20 * b15_11;
  const T b11_22 = b11_21 * b14_19;
  const T b11_23 = K_thetadot14_11_3 - b11_20 * K_thetadot16_14_3 - b11_22 * b14_18;
  const T b11_24 = b11_23 * b13_28;
  const T b11_25 = K_thetadot13_11_3 - b11_20 * K_thetadot16_13_2 - b11_22 * b13_25 - b11_24 * b13_27;
  const T b11_26 = b11_25 * b12_28;
  const T b11_27 = K_thetadot12_11_3 - b11_20 * K_thetadot16_12_1 - b11_22 * b12_23 - b11_24 * b12_25 - b11_26 *
      b12_27;
  const T b11_28 = T(1) / D_thetaddot12;
  const T b11_29 = b11_27 * b11_28;
  const T D_thetaddot11 = J11_33 - b11_20 * K_thetadot16_11_3 - b11_22 * b11_21 - b11_24 * b11_23 - b11_26 * b11_25 -
      b11_29 * b11_27;

  // ---- body 10 (body_10) and what it carries
  // S10 = E11^T S11 + G10: sum of the force balances of the subtree, body axes [N]
  const T b10_1 = E11_11 * S11_1 + E11_12 * minus_S11_2;
  const T S10_1 = b10_1 - minus_G10_1;
  const T b10_2 = E11_12 * S11_1 - E11_11 * minus_S11_2;
  const T S10_2 = b10_2 - minus_G10_2;
  const T S10_3 = S11_3 - minus_G10_3;
  // rho10 = q11~ E11^T S11 + E11^T rho11 + r10~ G10 + N10: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho10_1 = T(0.55) * S11_3 - T(0.1) * b10_2 + E11_11 * rho11_1 - E11_12 * rho11_2 + T(0.05) * minus_G10_2 -
      T(0.2) * minus_G10_3 - minus_N10_1;
  const T rho10_2 = T(0.1) * b10_1 - T(0.3) * S11_3 + E11_12 * rho11_1 + E11_11 * rho11_2 + T(0.1) * minus_G10_3 -
      T(0.05) * minus_G10_1 - minus_N10_2;
  const T rho10_3 = T(0.3) * b10_2 - T(0.55) * b10_1 + rho11_3 + T(0.2) * minus_G10_1 - T(0.1) * minus_G10_2 -
      minus_N10_3;
  // h10 = m10 r10 + m_sub11 q11 + hc11: first moment of mass carried, about the body origin, body axes [kg m]
  const T h10_1 = T(4.43) + hc11_1;
  const T h10_2 = T(8.155000000000001) + hc11_2;
  const T h10_3 = T(1.51) + h11_3;
  // J10 = -q11~ hc11~ + E11^T J11 E11 - m10 r10~ r10~ + I10 + (-m_sub11 q11~ - hc11~) q11~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b10_3 = E11_11 * J11_11 - E11_12 * J11_21;
  const T b10_4 = E11_11 * J11_12 - E11_12 * J11_22;
  const T b10_5 = h11_3 + T(1.4100000000000001);
  const T b10_6 = T(0.1) * h11_3 + b10_5 * T(0.1);
  const T b10_7 = T(0.55) * hc11_2;
  const T b10_8 = T(7.755000000000001) + hc11_2;
  const T b10_9 = b10_8 * T(0.55);
  const T J10_11 = b10_3 * E11_11 - b10_4 * E11_12 + b10_6 + b10_7 + T(0.28500000000000003) + b10_9;
  const T b10_10 = b10_3 * E11_12 + b10_4 * E11_11 - T(0.030000000000000006);
  const T J10_12 = b10_10 - T(0.55) * hc11_1 - b10_8 * T(0.3);
  const T b10_11 = E11_11 * J11_13 - E11_12 * J11_23;
  const T b10_12 = T(0.1) * hc11_1;
  const T b10_13 = b10_11 - b10_12;
  const T J10_13 = b10_13 - T(0.004000000000000001) - b10_5 * T(0.3);
  const T b10_14 = hc11_1 + T(4.2299999999999995);
  const T J10_21 = b10_10 - T(0.3) * hc11_2 - b10_14 * T(0.55);
  const T b10_15 = T(0.3) * hc11_1;
  const T b10_16 = b10_14 * T(0.3);
  const T J10_22 = (E11_12 * J11_11 + E11_11 * J11_21) * E11_12 + (E11_12 * J11_12 + E11_11 * J11_22) * E11_11 + b10_6
      + b10_15 + T(0.265) + b10_16;
  const T b10_17 = E11_12 * J11_13 + E11_11 * J11_23;
  const T b10_18 = b10_17 - T(0.1) * hc11_2;
  const T J10_23 = b10_18 - T(0.028000000000000004) - b10_5 * T(0.55);
  const T J10_31 = b10_11 - T(0.3) * h11_3 - T(0.004000000000000001) - b10_14 * T(0.1);
  const T J10_32 = b10_17 - T(0.55) * h11_3 - T(0.028000000000000004) - b10_8 * T(0.1);
  const T b10_19 = b10_15 + b10_7 + J11_33;
  const T J10_33 = b10_19 + T(0.26) + b10_9 + b10_16;
  // hc10 = E10^T h10: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc10_1 = minus_E10_13 * h10_3 + E10_11 * h10_1;
  const T hc10_3 = E10_11 * h10_3 - minus_E10_13 * h10_1;
  // B_thetadot16_10 = E11^T B_thetadot16_11
  const T B_thetadot16_10_1 = E11_11 * B_thetadot16_12_1 - E11_12 * B_thetadot16_11_2;
  const T B_thetadot16_10_2 = E11_12 * B_thetadot16_12_1 + E11_11 * B_thetadot16_11_2;
  // K_thetadot16_10 = q11~ E11^T B_thetadot16_11 + E11^T K_thetadot16_11
  const T b10_20 = T(0.1) * B_thetadot16_10_2;
  const T K_thetadot16_10_1 = T(0.55) * B_thetadot16_11_3 - b10_20 + E11_11 * K_thetadot16_11_1 - E11_12 *
      K_thetadot16_11_2;
  const T K_thetadot16_10_2 = T(0.1) * B_thetadot16_10_1 - b11_16 + E11_12 * K_thetadot16_11_1 + E11_11 *
      K_thetadot16_11_2;
  const T b10_21 = T(0.3) * B_thetadot16_10_2;
  const T K_thetadot16_10_3 = b10_21 - T(0.55) * B_thetadot16_10_1 + K_thetadot16_11_3;
  // B_thetadot15_10 = E11^T B_thetadot15_11
  const T B_thetadot15_10_1 = E11_11 * B_thetadot15_12_1 + E11_12 * minus_B_thetadot15_11_2;
  const T B_thetadot15_10_2 = E11_12 * B_thetadot15_12_1 - E11_11 * minus_B_thetadot15_11_2;
  // K_thetadot15_10 = q11~ E11^T B_thetadot15_11 + E11^T K_thetadot15_11
  const T b10_22 = T(0.1) * B_thetadot15_10_2;
  const T K_thetadot15_10_1 = T(0.55) * B_thetadot15_11_3 - b10_22 + E11_11 * K_thetadot15_11_1 - E11_12 *
      K_thetadot15_11_2;
  const T K_thetadot15_10_2 = T(0.1) * B_thetadot15_10_1 - b11_17 + E11_12 * K_thetadot15_11_1 + E11_11 *
      K_thetadot15_11_2;
  const T b10_23 = T(0.3) * B_thetadot15_10_2;
  const T K_thetadot15_10_3 = b10_23 - T(0.55) * B_thetadot15_10_1 + K_thetadot15_11_3;
  // B_thetadot14_10 = E11^T B_thetadot14_11
  const T minus_B_thetadot14_10_1 = E11_11 * minus_B_thetadot14_12_1 + E11_12 * B_thetadot14_11_2;
  const T B_thetadot14_10_2 = E11_11 * B_thetadot14_11_2 - E11_12 * minus_B_thetadot14_12_1;
  // K_thetadot14_10 = q11~ E11^T B_thetadot14_11 + E11^T K_thetadot14_11
  const T b10_24 = T(0.1) * B_thetadot14_10_2;
  const T K_thetadot14_10_1 = T(0.55) * B_thetadot14_11_3 - b10_24 + E11_11 * K_thetadot14_11_1 - E11_12 *
      K_thetadot14_11_2;
  const T K_thetadot14_10_2 = E11_12 * K_thetadot14_11_1 + E11_11 * K_thetadot14_11_2 - T(0.1) *
      minus_B_thetadot14_10_1 - b11_18;
  const T b10_25 = T(0.3) * B_thetadot14_10_2;
  const T K_thetadot14_10_3 = b10_25 + T(0.55) * minus_B_thetadot14_10_1 + K_thetadot14_11_3;
  // B_thetadot13_10 = E11^T B_thetadot13_11
  const T B_thetadot13_10_1 = E11_11 * hc13_3 - E11_12 * B_thetadot13_11_2;
  const T B_thetadot13_10_2 = E11_12 * hc13_3 + E11_11 * B_thetadot13_11_2;
  // K_thetadot13_10 = q11~ E11^T B_thetadot13_11 + E11^T K_thetadot13_11
  const T b10_26 = T(0.1) * B_thetadot13_10_2;
  const T K_thetadot13_10_1 = E11_11 * K_thetadot13_11_1 - E11_12 * K_thetadot13_11_2 - b10_26 - T(0.55) *
      minus_B_thetadot13_11_3;
  const T K_thetadot13_10_2 = T(0.1) * B_thetadot13_10_1 + b11_19 + E11_12 * K_thetadot13_11_1 + E11_11 *
      K_thetadot13_11_2;
  const T b10_27 = T(0.3) * B_thetadot13_10_2;
  const T K_thetadot13_10_3 = b10_27 - T(0.55) * B_thetadot13_10_1 + K_thetadot13_11_3;
  // B_thetadot12_10 = E11^T B_thetadot12_11
  const T B_thetadot12_10_1 = E11_12 * hc12_3;
  const T minus_B_thetadot12_10_2 = E11_11 * hc12_3;
  // K_thetadot12_10 = q11~ E11^T B_thetadot12_11 + E11^T K_thetadot12_11
  const T b10_28 = T(0.1) * minus_B_thetadot12_10_2;
  const T K_thetadot12_10_1 = b10_28 + T(0.55) * hc12_2 + E11_11 * b11_5 - E11_12 * K_thetadot12_11_2;
  const T K_thetadot12_10_2 = T(0.1) * B_thetadot12_10_1 - b11_11 + E11_12 * b11_5 + E11_11 * K_thetadot12_11_2;
  const T b10_29 = T(0.3) * minus_B_thetadot12_10_2;
  const T K_thetadot12_10_3 = K_thetadot12_11_3 - b10_29 - T(0.55) * B_thetadot12_10_1;
  // D_thetaddot10: pivots of L D L^T
  const T b10_30 = K_thetadot16_10_2 * T(2.9027576197387517);
  const T b10_31 = K_thetadot15_10_2 + b10_30 * b15_11;
  const T b10_32 = b10_31 * b14_19;
  const T b10_33 = K_thetadot14_10_2 - b10_30 * K_thetadot16_14_3 - b10_32 * b14_18;
  const T b10_34 = b10_33 * b13_28;
  const T b10_35 = K_thetadot13_10_2 - b10_30 * K_thetadot16_13_2 - b10_32 * b13_25 - b10_34 * b13_27;
  const T b10_36 = b10_35 * b12_28;
  const T b10_37 = K_thetadot12_10_2 - b10_30 * K_thetadot16_12_1 - b10_32 * b12_23 - b10_34 * b12_25 - b10_36 *
      b12_27;
  const T b10_38 = b10_37 * b11_28;
  const T b10_39 = b10_18 - b10_30 * K_thetadot16_11_3 - b10_32 * b11_21 - b10_34 * b11_23 - b10_36 * b11_25 - b10_38
      * b11_27;
  const T b10_40 = T(1) / D_thetaddot11;
  const T b10_41 = b10_39 * b10_40;
  const T D_thetaddot10 = J10_22 - b10_30 * K_thetadot16_10_2 - b10_32 * b10_31 - b10_34 * b10_33 - b10_36 * b10_35 -
      b10_38 * b10_37 - b10_41 * b10_39;

  // ---- body 9 (body_9) and what it carries
  // S9 = E10^T S10 + G9: sum of the force balances of the subtree, body axes [N]
  const T b9_1 = E10_11 * S10_1 + minus_E10_13 * S10_3;
  const T S9_1 = b9_1 - minus_G9_1;
  const T S9_2 = S10_2 - minus_G9_2;
  const T b9_2 = E10_11 * S10_3 - minus_E10_13 * S10_1;
  const T S9_3 = b9_2 - minus_G9_3;
  // rho9 = q10~ E10^T S10 + E10^T rho10 + r9~ G9 + N9: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho9_1 = T(0.5) * b9_2 - T(0.1) * S10_2 + E10_11 * rho10_1 + minus_E10_13 * rho10_3 + T(0.05) * minus_G9_2 -
      T(0.2) * minus_G9_3 - minus_N9_1;
  const T rho9_2 = T(0.1) * b9_1 - T(0.3) * b9_2 + rho10_2 + T(0.1) * minus_G9_3 - T(0.05) * minus_G9_1 - minus_N9_2;
  const T rho9_3 = T(0.3) * S10_2 - T(0.5) * b9_1 + E10_11 * rho10_3 - minus_E10_13 * rho10_1 + T(0.2) * minus_G9_1 -
      T(0.1) * minus_G9_2 - minus_N9_3;
  // h9 = m9 r9 + m_sub10 q10 + hc10: first moment of mass carried, about the body origin, body axes [kg m]
  const T h9_1 = T(5.02) + hc10_1;
  const T h9_2 = T(8.43) + h10_2;
  const T h9_3 = T(1.705) + hc10_3;
  // J9 = -q10~ hc10~ + E10^T J10 E10 - m9 r9~ r9~ + I9 + (-m_sub10 q10~ - hc10~) q10~: inertia carried, about the
  //   body origin, body axes [kg m^2]
  const T b9_3 = E10_11 * J10_11 + minus_E10_13 * J10_31;
  const T b9_4 = E10_11 * J10_13 + minus_E10_13 * J10_33;
  const T b9_5 = T(0.1) * hc10_3;
  const T b9_6 = T(8.05) + h10_2;
  const T b9_7 = T(0.5) * h10_2 + b9_6 * T(0.5);
  const T b9_8 = hc10_3 + T(1.61);
  const T b9_9 = b9_8 * T(0.1);
  const T J9_11 = b9_3 * E10_11 + b9_4 * minus_E10_13 + b9_5 + b9_7 + T(0.27075) + b9_9;
  const T b9_10 = E10_11 * J10_12 + minus_E10_13 * J10_32;
  const T b9_11 = b9_10 - T(0.5) * hc10_1;
  const T J9_12 = b9_11 - T(0.0285) - b9_6 * T(0.3);
  const T b9_12 = b9_4 * E10_11 - b9_3 * minus_E10_13 - T(0.0038000000000000004);
  const T J9_13 = b9_12 - T(0.1) * hc10_1 - b9_8 * T(0.3);
  const T b9_13 = hc10_1 + T(4.83);
  const T J9_21 = b9_10 - T(0.3) * h10_2 - T(0.0285) - b9_13 * T(0.5);
  const T b9_14 = T(0.3) * hc10_1;
  const T b9_15 = b9_5 + b9_14 + J10_22;
  const T b9_16 = b9_13 * T(0.3);
  const T J9_22 = b9_15 + T(0.25175000000000003) + b9_9 + b9_16;
  const T b9_17 = J10_23 * E10_11 - J10_21 * minus_E10_13 - T(0.026600000000000002);
  const T J9_23 = b9_17 - T(0.1) * h10_2 - b9_8 * T(0.5);
  const T J9_31 = b9_12 - T(0.3) * hc10_3 - b9_13 * T(0.1);
  const T b9_18 = T(0.5) * hc10_3;
  const T J9_32 = b9_17 - b9_18 - b9_6 * T(0.1);
  const T J9_33 = (E10_11 * J10_33 - minus_E10_13 * J10_13) * E10_11 - (E10_11 * J10_31 - minus_E10_13 * J10_11) *
      minus_E10_13 + b9_7 + b9_14 + T(0.247) + b9_16;
  // hc9 = E9^T h9: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc9_2 = E9_22 * h9_2 - E9_23 * h9_3;
  const T hc9_3 = E9_22 * h9_3 + E9_23 * h9_2;
  // B_thetadot16_9 = E10^T B_thetadot16_10
  const T B_thetadot16_9_1 = E10_11 * B_thetadot16_10_1 + minus_E10_13 * B_thetadot16_11_3;
  const T B_thetadot16_9_3 = E10_11 * B_thetadot16_11_3 - minus_E10_13 * B_thetadot16_10_1;
  // K_thetadot16_9 = q10~ E10^T B_thetadot16_10 + E10^T K_thetadot16_10
  const T K_thetadot16_9_1 = T(0.5) * B_thetadot16_9_3 - b10_20 + E10_11 * K_thetadot16_10_1 + minus_E10_13 *
      K_thetadot16_10_3;
  const T b9_19 = T(0.1) * B_thetadot16_9_1;
  const T K_thetadot16_9_2 = b9_19 - T(0.3) * B_thetadot16_9_3 + K_thetadot16_10_2;
  const T K_thetadot16_9_3 = b10_21 - T(0.5) * B_thetadot16_9_1 + E10_11 * K_thetadot16_10_3 - minus_E10_13 *
      K_thetadot16_10_1;
  // B_thetadot15_9 = E10^T B_thetadot15_10
  const T B_thetadot15_9_1 = E10_11 * B_thetadot15_10_1 + minus_E10_13 * B_thetadot15_11_3;
  const T B_thetadot15_9_3 = E10_11 * B_thetadot15_11_3 - minus_E10_13 * B_thetadot15_10_1;
  // K_thetadot15_9 = q10~ E10^T B_thetadot15_10 + E10^T K_thetadot15_10
  const T K_thetadot15_9_1 = T(0.5) * B_thetadot15_9_3 - b10_22 + E10_11 * K_thetadot15_10_1 + minus_E10_13 *
      K_thetadot15_10_3;
  const T b9_20 = T(0.1) * B_thetadot15_9_1;
  const T K_thetadot15_9_2 = b9_20 - T(0.3) * B_thetadot15_9_3 + K_thetadot15_10_2;
  const T K_thetadot15_9_3 = b10_23 - T(0.5) * B_thetadot15_9_1 + E10_11 * K_thetadot15_10_3 - minus_E10_13 *
      K_thetadot15_10_1;
  // B_thetadot14_9 = E10^T B_thetadot14_10
  const T B_thetadot14_9_1 = minus_E10_13 * B_thetadot14_11_3 - E10_11 * minus_B_thetadot14_10_1;
  const T B_thetadot14_9_3 = minus_E10_13 * minus_B_thetadot14_10_1 + E10_11 * B_thetadot14_11_3;
  // K_thetadot14_9 = q10~ E10^T B_thetadot14_10 + E10^T K_thetadot14_10
  const T K_thetadot14_9_1 = T(0.5) * B_thetadot14_9_3 - b10_24 + E10_11 * K_thetadot14_10_1 + minus_E10_13 *
      K_thetadot14_10_3;
  const T b9_21 = T(0.1) * B_thetadot14_9_1;
  const T K_thetadot14_9_2 = b9_21 - T(0.3) * B_thetadot14_9_3 + K_thetadot14_10_2;
  const T K_thetadot14_9_3 = b10_25 - T(0.5) * B_thetadot14_9_1 + E10_11 * K_thetadot14_10_3 - minus_E10_13 *
      K_thetadot14_10_1;
  // B_thetadot13_9 = E10^T B_thetadot13_10
  const T B_thetadot13_9_1 = E10_11 * B_thetadot13_10_1 - minus_E10_13 * minus_B_thetadot13_11_3;
  const T minus_B_thetadot13_9_3 = minus_E10_13 * B_thetadot13_10_1 + E10_11 * minus_B_thetadot13_11_3;
  // K_thetadot13_9 = q10~ E10^T B_thetadot13_10 + E10^T K_thetadot13_10
  const T K_thetadot13_9_1 = E10_11 * K_thetadot13_10_1 + minus_E10_13 * K_thetadot13_10_3 - b10_26 - T(0.5) *
      minus_B_thetadot13_9_3;
  const T b9_22 = T(0.1) * B_thetadot13_9_1;
  const T K_thetadot13_9_2 = b9_22 + T(0.3) * minus_B_thetadot13_9_3 + K_thetadot13_10_2;
  const T K_thetadot13_9_3 = b10_27 - T(0.5) * B_thetadot13_9_1 + E10_11 * K_thetadot13_10_3 - minus_E10_13 *
      K_thetadot13_10_1;
  // B_thetadot12_9 = E10^T B_thetadot12_10
  const T B_thetadot12_9_1 = E10_11 * B_thetadot12_10_1 + minus_E10_13 * hc12_2;
  const T B_thetadot12_9_3 = E10_11 * hc12_2 - minus_E10_13 * B_thetadot12_10_1;
  // K_thetadot12_9 = q10~ E10^T B_thetadot12_10 + E10^T K_thetadot12_10
  const T K_thetadot12_9_1 = b10_28 + T(0.5) * B_thetadot12_9_3 + E10_11 * K_thetadot12_10_1 + minus_E10_13 *
      K_thetadot12_10_3;
  const T b9_23 = T(0.1) * B_thetadot12_9_1;
  const T K_thetadot12_9_2 = b9_23 - T(0.3) * B_thetadot12_9_3 + K_thetadot12_10_2;
  const T K_thetadot12_9_3 = E10_11 * K_thetadot12_10_3 - minus_E10_13 * K_thetadot12_10_1 - b10_29 - T(0.5) *
      B_thetadot12_9_1;
  // B_thetadot11_9 = E10^T B_thetadot11_10
  const T minus_B_thetadot11_9_1 = E10_11 * hc11_2;
  const T B_thetadot11_9_3 = minus_E10_13 * hc11_2;
  // K_thetadot11_9 = q10~ E10^T B_thetadot11_10 + E10^T K_thetadot11_10
  const T K_thetadot11_9_1 = T(0.5) * B_thetadot11_9_3 - b10_12 + E10_11 * b10_13 + minus_E10_13 * b10_19;
  const T b9_24 = T(0.1) * minus_B_thetadot11_9_1;
  const T K_thetadot11_9_2 = b10_18 - b9_24 - T(0.3) * B_thetadot11_9_3;
  const T K_thetadot11_9_3 = b10_15 + T(0.5) * minus_B_thetadot11_9_1 + E10_11 * b10_19 - minus_E10_13 * b10_13;
  // K_thetadot10_9 = q10~ E10^T B_thetadot10_10 + E10^T K_thetadot10_10
  const T K_thetadot10_9_3 = E10_11 * J10_32 - minus_E10_13 * J10_12 - b9_18;
  // D_thetaddot9: pivots of L D L^T
  const T b9_25 = K_thetadot16_9_1 * T(2.9027576197387517);
  const T b9_26 = K_thetadot15_9_1 + b9_25 * b15_11;
  const T b9_27 = b9_26 * b14_19;
  const T b9_28 = K_thetadot14_9_1 - b9_25 * K_thetadot16_14_3 - b9_27 * b14_18;
  const T b9_29 = b9_28 * b13_28;
  const T b9_30 = K_thetadot13_9_1 - b9_25 * K_thetadot16_13_2 - b9_27 * b13_25 - b9_29 * b13_27;
  const T b9_31 = b9_30 * b12_28;
  const T b9_32 = K_thetadot12_9_1 - b9_25 * K_thetadot16_12_1 - b9_27 * b12_23 - b9_29 * b12_25 - b9_31 * b12_27;
  const T b9_33 = b9_32 * b11_28;
  const T b9_34 = K_thetadot11_9_1 - b9_25 * K_thetadot16_11_3 - b9_27 * b11_21 - b9_29 * b11_23 - b9_31 * b11_25 -
      b9_33 * b11_27;
  const T b9_35 = b9_34 * b10_40;
  const T b9_36 = b9_11 - b9_25 * K_thetadot16_10_2 - b9_27 * b10_31 - b9_29 * b10_33 - b9_31 * b10_35 - b9_33 *
      b10_37 - b9_35 * b10_39;
  const T b9_37 = T(1) / D_thetaddot10;
  const T b9_38 = b9_36 * b9_37;
  const T D_thetaddot9 = J9_11 - b9_25 * K_thetadot16_9_1 - b9_27 * b9_26 - b9_29 * b9_28 - b9_31 * b9_30 - b9_33 *
      b9_32 - b9_35 * b9_34 - b9_38 * b9_36;

  // ---- body 8 (body_8) and what it carries
  // S8 = E9^T S9 + G8: sum of the force balances of the subtree, body axes [N]
  const T S8_1 = S9_1 - minus_G8_1;
  const T b8_1 = E9_22 * S9_2 - E9_23 * S9_3;
  const T S8_2 = b8_1 - minus_G8_2;
  const T b8_2 = E9_23 * S9_2 + E9_22 * S9_3;
  const T S8_3 = b8_2 - minus_G8_3;
  // rho8 = q9~ E9^T S9 + E9^T rho9 + r8~ G8 + N8: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho8_1 = T(0.45) * b8_2 - T(0.1) * b8_1 + rho9_1 + T(0.05) * minus_G8_2 - T(0.2) * minus_G8_3 - minus_N8_1;
  const T rho8_2 = T(0.1) * S9_1 - T(0.3) * b8_2 + E9_22 * rho9_2 - E9_23 * rho9_3 + T(0.1) * minus_G8_3 - T(0.05) *
      minus_G8_1 - minus_N8_2;
  const T rho8_3 = T(0.3) * b8_1 - T(0.45) * S9_1 + E9_23 * rho9_2 + E9_22 * rho9_3 + T(0.2) * minus_G8_1 - T(0.1) *
      minus_G8_2 - minus_N8_3;
  // h8 = m8 r8 + m_sub9 q9 + hc9: first moment of mass carried, about the body origin, body axes [kg m]
  const T h8_1 = T(5.58) + h9_1;
  const T h8_2 = T(8.46) + hc9_2;
  const T h8_3 = T(1.8900000000000001) + hc9_3;
  // J8 = -q9~ hc9~ + E9^T J9 E9 - m8 r8~ r8~ + I8 + (-m_sub9 q9~ - hc9~) q9~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b8_3 = T(0.1) * hc9_3;
  const T b8_4 = T(0.45) * hc9_2;
  const T b8_5 = b8_3 + b8_4 + J9_11;
  const T b8_6 = hc9_3 + T(1.8);
  const T b8_7 = b8_6 * T(0.1);
  const T b8_8 = T(8.1) + hc9_2;
  const T b8_9 = b8_8 * T(0.45);
  const T J8_11 = b8_5 + T(0.2565) + b8_7 + b8_9;
  const T b8_10 = J9_12 * E9_22 - J9_13 * E9_23 - T(0.027000000000000007);
  const T J8_12 = b8_10 - T(0.45) * h9_1 - b8_8 * T(0.3);
  const T J8_13 = J9_12 * E9_23 + J9_13 * E9_22 - T(0.1) * h9_1 - T(0.0036000000000000008) - b8_6 * T(0.3);
  const T b8_11 = T(0.3) * hc9_2;
  const T b8_12 = h9_1 + T(5.3999999999999995);
  const T J8_21 = b8_10 - b8_11 - b8_12 * T(0.45);
  const T b8_13 = E9_22 * J9_22 - E9_23 * J9_32;
  const T b8_14 = E9_22 * J9_23 - E9_23 * J9_33;
  const T b8_15 = T(0.3) * h9_1 + b8_12 * T(0.3);
  const T J8_22 = b8_13 * E9_22 - b8_14 * E9_23 + b8_3 + b8_15 + T(0.2385) + b8_7;
  const T J8_23 = b8_13 * E9_23 + b8_14 * E9_22 - T(0.1) * hc9_2 - T(0.025200000000000004) - b8_6 * T(0.45);
  const T J8_33 = (E9_23 * J9_22 + E9_22 * J9_32) * E9_23 + (E9_23 * J9_23 + E9_22 * J9_33) * E9_22 + b8_4 + b8_15 +
      T(0.234) + b8_9;
  // hc8 = E8^T h8: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc8_1 = E8_11 * h8_1 - E8_12 * h8_2;
  const T hc8_2 = E8_11 * h8_2 + E8_12 * h8_1;
  // B_thetadot16_8 = E9^T B_thetadot16_9
  const T B_thetadot16_8_2 = E9_22 * B_thetadot16_10_2 - E9_23 * B_thetadot16_9_3;
  const T B_thetadot16_8_3 = E9_23 * B_thetadot16_10_2 + E9_22 * B_thetadot16_9_3;
  // K_thetadot16_8 = q9~ E9^T B_thetadot16_9 + E9^T K_thetadot16_9
  const T K_thetadot16_8_1 = T(0.45) * B_thetadot16_8_3 - T(0.1) * B_thetadot16_8_2 + K_thetadot16_9_1;
  const T b8_16 = T(0.3) * B_thetadot16_8_3;
  const T K_thetadot16_8_2 = b9_19 - b8_16 + E9_22 * K_thetadot16_9_2 - E9_23 * K_thetadot16_9_3;
  const T K_thetadot16_8_3 = T(0.3) * B_thetadot16_8_2 - T(0.45) * B_thetadot16_9_1 + E9_23 * K_thetadot16_9_2 + E9_22
      * K_thetadot16_9_3;
  // B_thetadot15_8 = E9^T B_thetadot15_9
  const T B_thetadot15_8_2 = E9_22 * B_thetadot15_10_2 - E9_23 * B_thetadot15_9_3;
  const T B_thetadot15_8_3 = E9_23 * B_thetadot15_10_2 + E9_22 * B_thetadot15_9_3;
  // K_thetadot15_8 = q9~ E9^T B_thetadot15_9 + E9^T K_thetadot15_9
  const T K_thetadot15_8_1 = T(0.45) * B_thetadot15_8_3 - T(0.1) * B_thetadot15_8_2 + K_thetadot15_9_1;
  const T b8_17 = T(0.3) * B_thetadot15_8_3;
  const T K_thetadot15_8_2 = b9_20 - b8_17 + E9_22 * K_thetadot15_9_2 - E9_23 * K_thetadot15_9_3;
  const T K_thetadot15_8_3 = T(0.3) * B_thetadot15_8_2 - T(0.45) * B_thetadot15_9_1 + E9_23 * K_thetadot15_9_2 + E9_22
      * K_thetadot15_9_3;
  // B_thetadot14_8 = E9^T B_thetadot14_9
  const T B_thetadot14_8_2 = E9_22 * B_thetadot14_10_2 - E9_23 * B_thetadot14_9_3;
  const T B_thetadot14_8_3 = E9_23 * B_thetadot14_10_2 + E9_22 * B_thetadot14_9_3;
  // K_thetadot14_8 = q9~ E9^T B_thetadot14_9 + E9^T K_thetadot14_9
  const T K_thetadot14_8_1 = T(0.45) * B_thetadot14_8_3 - T(0.1) * B_thetadot14_8_2 + K_thetadot14_9_1;
  const T b8_18 = T(0.3) * B_thetadot14_8_3;
  const T K_thetadot14_8_2 = b9_21 - b8_18 + E9_22 * K_thetadot14_9_2 - E9_23 * K_thetadot14_9_3;
  const T K_thetadot14_8_3 = T(0.3) * B_thetadot14_8_2 - T(0.45) * B_thetadot14_9_1 + E9_23 * K_thetadot14_9_2 + E9_22
      * K_thetadot14_9_3;
  // B_thetadot13_8 = E9^T B_thetadot13_9
  const T B_thetadot13_8_2 = E9_22 * B_thetadot13_10_2 + E9_23 * minus_B_thetadot13_9_3;
  const T B_thetadot13_8_3 = E9_23 * B_thetadot13_10_2 - E9_22 * minus_B_thetadot13_9_3;
  // K_thetadot13_8 = q9~ E9^T B_thetadot13_9 + E9^T K_thetadot13_9
  const T K_thetadot13_8_1 = T(0.45) * B_thetadot13_8_3 - T(0.1) * B_thetadot13_8_2 + K_thetadot13_9_1;
  const T b8_19 = T(0.3) * B_thetadot13_8_3;
  const T K_thetadot13_8_2 = b9_22 - b8_19 + E9_22 * K_thetadot13_9_2 - E9_23 * K_thetadot13_9_3;
  const T K_thetadot13_8_3 = T(0.3) * B_thetadot13_8_2 - T(0.45) * B_thetadot13_9_1 + E9_23 * K_thetadot13_9_2 + E9_22
      * K_thetadot13_9_3;
  // B_thetadot12_8 = E9^T B_thetadot12_9
  const T minus_B_thetadot12_8_2 = E9_22 * minus_B_thetadot12_10_2 + E9_23 * B_thetadot12_9_3;
  const T B_thetadot12_8_3 = E9_22 * B_thetadot12_9_3 - E9_23 * minus_B_thetadot12_10_2;
  // K_thetadot12_8 = q9~ E9^T B_thetadot12_9 + E9^T K_thetadot12_9
  const T K_thetadot12_8_1 = T(0.1) * minus_B_thetadot12_8_2 + T(0.45) * B_thetadot12_8_3 + K_thetadot12_9_1;
  const T b8_20 = T(0.3) * B_thetadot12_8_3;
  const T K_thetadot12_8_2 = b9_23 - b8_20 + E9_22 * K_thetadot12_9_2 - E9_23 * K_thetadot12_9_3;
  const T K_thetadot12_8_3 = E9_23 * K_thetadot12_9_2 + E9_22 * K_thetadot12_9_3 - T(0.3) * minus_B_thetadot12_8_2 -
      T(0.45) * B_thetadot12_9_1;
  // B_thetadot11_8 = E9^T B_thetadot11_9
  const T B_thetadot11_8_2 = E9_22 * hc11_1 - E9_23 * B_thetadot11_9_3;
  const T B_thetadot11_8_3 = E9_23 * hc11_1 + E9_22 * B_thetadot11_9_3;
  // K_thetadot11_8 = q9~ E9^T B_thetadot11_9 + E9^T K_thetadot11_9
  const T K_thetadot11_8_1 = T(0.45) * B_thetadot11_8_3 - T(0.1) * B_thetadot11_8_2 + K_thetadot11_9_1;
  const T b8_21 = T(0.3) * B_thetadot11_8_3;
  const T K_thetadot11_8_2 = E9_22 * K_thetadot11_9_2 - E9_23 * K_thetadot11_9_3 - b9_24 - b8_21;
  const T K_thetadot11_8_3 = T(0.3) * B_thetadot11_8_2 + T(0.45) * minus_B_thetadot11_9_1 + E9_23 * K_thetadot11_9_2 +
      E9_22 * K_thetadot11_9_3;
  // B_thetadot10_8 = E9^T B_thetadot10_9
  const T B_thetadot10_8_2 = E9_23 * hc10_1;
  const T minus_B_thetadot10_8_3 = E9_22 * hc10_1;
  // K_thetadot10_8 = q9~ E9^T B_thetadot10_9 + E9^T K_thetadot10_9
  const T K_thetadot10_8_1 = b9_11 - T(0.1) * B_thetadot10_8_2 - T(0.45) * minus_B_thetadot10_8_3;
  const T b8_22 = T(0.3) * minus_B_thetadot10_8_3;
  const T K_thetadot10_8_2 = b9_5 + b8_22 + E9_22 * b9_15 - E9_23 * K_thetadot10_9_3;
  const T K_thetadot10_8_3 = T(0.3) * B_thetadot10_8_2 - T(0.45) * hc10_3 + E9_23 * b9_15 + E9_22 * K_thetadot10_9_3;
  // K_thetadot9_8 = q9~ E9^T B_thetadot9_9 + E9^T K_thetadot9_9
  const T K_thetadot9_8_2 = E9_22 * J9_21 - E9_23 * J9_31 - b8_11;
  const T K_thetadot9_8_3 = E9_23 * J9_21 + E9_22 * J9_31 - T(0.3) * hc9_3;
  // D_thetaddot8: pivots of L D L^T
  const T b8_23 = K_thetadot16_8_3 * T(2.9027576197387517);
  const T b8_24 = K_thetadot15_8_3 + b8_23 * b15_11;
  const T b8_25 = b8_24 * b14_19;
  const T b8_26 = K_thetadot14_8_3 - b8_23 * K_thetadot16_14_3 - b8_25 * b14_18;
  const T b8_27 = b8_26 * b13_28;
  const T b8_28 = K_thetadot13_8_3 - b8_23 * K_thetadot16_13_2 - b8_25 * b13_25 - b8_27 * b13_27;
  const T b8_29 = b8_28 * b12_28;
  const T b8_30 = K_thetadot12_8_3 - b8_23 * K_thetadot16_12_1 - b8_25 * b12_23 - b8_27 * b12_25 - b8_29 * b12_27;
  const T b8_31 = b8_30 * b11_28;
  const T b8_32 = K_thetadot11_8_3 - b8_23 * K_thetadot16_11_3 - b8_25 * b11_21 - b8_27 * b11_23 - b8_29 * b11_25 -
      b8_31 * b11_27;
  const T b8_33 = b8_32 * b10_40;
  const T b8_34 = K_thetadot10_8_3 - b8_23 * K_thetadot16_10_2 - b8_25 * b10_31 - b8_27 * b10_33 - b8_29 * b10_35 -
      b8_31 * b10_37 - b8_33 * b10_39;
  const T b8_35 = b8_34 * b9_37;
  const T b8_36 = K_thetadot9_8_3 - b8_23 * K_thetadot16_9_1 - b8_25 * b9_26 - b8_27 * b9_28 - b8_29 * b9_30 - b8_31 *
      b9_32 - b8_33 * b9_34 - b8_35 * b9_36;
  const T b8_37 = T(1) / D_thetaddot9;
  const T b8_38 = b8_36 * b8_37;
  const T D_thetaddot8 = J8_33 - b8_23 * K_thetadot16_8_3 - b8_25 * b8_24 - b8_27 * b8_26 - b8_29 * b8_28 - b8_31 *
      b8_30 - b8_33 * b8_32 - b8_35 * b8_34 - b8_38 * b8_36;

  // ---- body 7 (body_7) and what it carries
  // S7 = E8^T S8 + G7: sum of the force balances of the subtree, body axes [N]
  const T b7_1 = E8_11 * S8_1 - E8_12 * S8_2;
  const T S7_1 = b7_1 - minus_G7_1;
  const T b7_2 = E8_12 * S8_1 + E8_11 * S8_2;
  const T S7_2 = b7_2 - minus_G7_2;
  const T S7_3 = S8_3 - minus_G7_3;
  // rho7 = q8~ E8^T S8 + E8^T rho8 + r7~ G7 + N7: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho7_1 = T(0.4) * S8_3 - T(0.1) * b7_2 + E8_11 * rho8_1 - E8_12 * rho8_2 + T(0.05) * minus_G7_2 - T(0.2) *
      minus_G7_3 - minus_N7_1;
  const T rho7_2 = T(0.1) * b7_1 - T(0.3) * S8_3 + E8_12 * rho8_1 + E8_11 * rho8_2 + T(0.1) * minus_G7_3 - T(0.05) *
      minus_G7_1 - minus_N7_2;
  const T rho7_3 = T(0.3) * b7_2 - T(0.4) * b7_1 + rho8_3 + T(0.2) * minus_G7_1 - T(0.1) * minus_G7_2 - minus_N7_3;
  // h7 = m7 r7 + m_sub8 q8 + hc8: first moment of mass carried, about the body origin, body axes [kg m]
  const T h7_1 = T(6.109999999999999) + hc8_1;
  const T h7_2 = T(8.26) + hc8_2;
  const T h7_3 = T(2.065) + h8_3;
  // J7 = -q8~ hc8~ + E8^T J8 E8 - m7 r7~ r7~ + I7 + (-m_sub8 q8~ - hc8~) q8~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b7_3 = E8_11 * J8_11 - E8_12 * J8_21;
  const T b7_4 = E8_11 * J8_12 - E8_12 * J8_22;
  const T b7_5 = h8_3 + T(1.9800000000000002);
  const T b7_6 = T(0.1) * h8_3 + b7_5 * T(0.1);
  const T b7_7 = T(0.4) * hc8_2;
  const T b7_8 = T(7.920000000000001) + hc8_2;
  const T b7_9 = b7_8 * T(0.4);
  const T J7_11 = b7_3 * E8_11 - b7_4 * E8_12 + b7_6 + b7_7 + T(0.24225000000000002) + b7_9;
  const T b7_10 = b7_3 * E8_12 + b7_4 * E8_11 - T(0.025500000000000002);
  const T J7_12 = b7_10 - T(0.4) * hc8_1 - b7_8 * T(0.3);
  const T b7_11 = E8_11 * J8_13 - E8_12 * J8_23;
  const T b7_12 = T(0.1) * hc8_1;
  const T b7_13 = b7_11 - b7_12;
  const T J7_13 = b7_13 - T(0.0034000000000000002) - b7_5 * T(0.3);
  const T b7_14 = hc8_1 + T(5.9399999999999995);
  const T J7_21 = b7_10 - T(0.3) * hc8_2 - b7_14 * T(0.4);
  const T b7_15 = T(0.3) * hc8_1;
  const T b7_16 = b7_14 * T(0.3);
  const T J7_22 = (E8_12 * J8_11 + E8_11 * J8_21) * E8_12 + (E8_12 * J8_12 + E8_11 * J8_22) * E8_11 + b7_6 + b7_15 +
      T(0.22524999999999998) + b7_16;
  const T b7_17 = E8_12 * J8_13 + E8_11 * J8_23;
  const T b7_18 = b7_17 - T(0.1) * hc8_2;
  const T J7_23 = b7_18 - T(0.0238) - b7_5 * T(0.4);
  const T J7_31 = b7_11 - T(0.3) * h8_3 - T(0.0034000000000000002) - b7_14 * T(0.1);
  const T J7_32 = b7_17 - T(0.4) * h8_3 - T(0.0238) - b7_8 * T(0.1);
  const T b7_19 = b7_15 + b7_7 + J8_33;
  const T J7_33 = b7_19 + T(0.22100000000000003) + b7_9 + b7_16;
  // hc7 = E7^T h7: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc7_1 = minus_E7_13 * h7_3 + E7_11 * h7_1;
  const T hc7_3 = E7_11 * h7_3 - minus_E7_13 * h7_1;
  // B_thetadot16_7 = E8^T B_thetadot16_8
  const T B_thetadot16_7_1 = E8_11 * B_thetadot16_9_1 - E8_12 * B_thetadot16_8_2;
  const T B_thetadot16_7_2 = E8_12 * B_thetadot16_9_1 + E8_11 * B_thetadot16_8_2;
  // K_thetadot16_7 = q8~ E8^T B_thetadot16_8 + E8^T K_thetadot16_8
  const T b7_20 = T(0.1) * B_thetadot16_7_2;
  const T K_thetadot16_7_1 = T(0.4) * B_thetadot16_8_3 - b7_20 + E8_11 * K_thetadot16_8_1 - E8_12 * K_thetadot16_8_2;
  const T K_thetadot16_7_2 = T(0.1) * B_thetadot16_7_1 - b8_16 + E8_12 * K_thetadot16_8_1 + E8_11 * K_thetadot16_8_2;
  const T b7_21 = T(0.3) * B_thetadot16_7_2;
  const T K_thetadot16_7_3 = b7_21 - T(0.4) * B_thetadot16_7_1 + K_thetadot16_8_3;
  // B_thetadot15_7 = E8^T B_thetadot15_8
  const T B_thetadot15_7_1 = E8_11 * B_thetadot15_9_1 - E8_12 * B_thetadot15_8_2;
  const T B_thetadot15_7_2 = E8_12 * B_thetadot15_9_1 + E8_11 * B_thetadot15_8_2;
  // K_thetadot15_7 = q8~ E8^T B_thetadot15_8 + E8^T K_thetadot15_8
  const T b7_22 = T(0.1) * B_thetadot15_7_2;
  const T K_thetadot15_7_1 = T(0.4) * B_thetadot15_8_3 - b7_22 + E8_11 * K_thetadot15_8_1 - E8_12 * K_thetadot15_8_2;
  const T K_thetadot15_7_2 = T(0.1) * B_thetadot15_7_1 - b8_17 + E8_12 * K_thetadot15_8_1 + E8_11 * K_thetadot15_8_2;
  const T b7_23 = T(0.3) * B_thetadot15_7_2;
  const T K_thetadot15_7_3 = b7_23 - T(0.4) * B_thetadot15_7_1 + K_thetadot15_8_3;
  // B_thetadot14_7 = E8^T B_thetadot14_8
  const T B_thetadot14_7_1 = E8_11 * B_thetadot14_9_1 - E8_12 * B_thetadot14_8_2;
  const T B_thetadot14_7_2 = E8_12 * B_thetadot14_9_1 + E8_11 * B_thetadot14_8_2;
  // K_thetadot14_7 = q8~ E8^T B_thetadot14_8 + E8^T K_thetadot14_8
  const T b7_24 = T(0.1) * B_thetadot14_7_2;
  const T K_thetadot14_7_1 = T(0.4) * B_thetadot14_8_3 - b7_24 + E8_11 * K_thetadot14_8_1 - E8_12 * K_thetadot14_8_2;
  const T K_thetadot14_7_2 = T(0.1) * B_thetadot14_7_1 - b8_18 + E8_12 * K_thetadot14_8_1 + E8_11 * K_thetadot14_8_2;
  const T b7_25 = T(0.3) * B_thetadot14_7_2;
  const T K_thetadot14_7_3 = b7_25 - T(0.4) * B_thetadot14_7_1 + K_thetadot14_8_3;
  // B_thetadot13_7 = E8^T B_thetadot13_8
  const T B_thetadot13_7_1 = E8_11 * B_thetadot13_9_1 - E8_12 * B_thetadot13_8_2;
  const T B_thetadot13_7_2 = E8_12 * B_thetadot13_9_1 + E8_11 * B_thetadot13_8_2;
  // K_thetadot13_7 = q8~ E8^T B_thetadot13_8 + E8^T K_thetadot13_8
  const T b7_26 = T(0.1) * B_thetadot13_7_2;
  const T K_thetadot13_7_1 = T(0.4) * B_thetadot13_8_3 - b7_26 + E8_11 * K_thetadot13_8_1 - E8_12 * K_thetadot13_8_2;
  const T K_thetadot13_7_2 = T(0.1) * B_thetadot13_7_1 - b8_19 + E8_12 * K_thetadot13_8_1 + E8_11 * K_thetadot13_8_2;
  const T b7_27 = T(0.3) * B_thetadot13_7_2;
  const T K_thetadot13_7_3 = b7_27 - T(0.4) * B_thetadot13_7_1 + K_thetadot13_8_3;
  // B_thetadot12_7 = E8^T B_thetadot12_8
  const T B_thetadot12_7_1 = E8_11 * B_thetadot12_9_1 + E8_12 * minus_B_thetadot12_8_2;
  const T B_thetadot12_7_2 = E8_12 * B_thetadot12_9_1 - E8_11 * minus_B_thetadot12_8_2;
  // K_thetadot12_7 = q8~ E8^T B_thetadot12_8 + E8^T K_thetadot12_8
  const T b7_28 = T(0.1) * B_thetadot12_7_2;
  const T K_thetadot12_7_1 = T(0.4) * B_thetadot12_8_3 - b7_28 + E8_11 * K_thetadot12_8_1 - E8_12 * K_thetadot12_8_2;
  const T K_thetadot12_7_2 = T(0.1) * B_thetadot12_7_1 - b8_20 + E8_12 * K_thetadot12_8_1 + E8_11 * K_thetadot12_8_2;
  const T b7_29 = T(0.3) * B_thetadot12_7_2;
  const T K_thetadot12_7_3 = b7_29 - T(0.4) * B_thetadot12_7_1 + K_thetadot12_8_3;
  // B_thetadot11_7 = E8^T B_thetadot11_8
  const T minus_B_thetadot11_7_1 = E8_11 * minus_B_thetadot11_9_1 + E8_12 * B_thetadot11_8_2;
  const T B_thetadot11_7_2 = E8_11 * B_thetadot11_8_2 - E8_12 * minus_B_thetadot11_9_1;
  // K_thetadot11_7 = q8~ E8^T B_thetadot11_8 + E8^T K_thetadot11_8
  const T b7_30 = T(0.1) * B_thetadot11_7_2;
  const T K_thetadot11_7_1 = T(0.4) * B_thetadot11_8_3 - b7_30 + E8_11 * K_thetadot11_8_1 - E8_12 * K_thetadot11_8_2;
  const T K_thetadot11_7_2 = E8_12 * K_thetadot11_8_1 + E8_11 * K_thetadot11_8_2 - T(0.1) * minus_B_thetadot11_7_1 -
      b8_21;
  const T b7_31 = T(0.3) * B_thetadot11_7_2;
  const T K_thetadot11_7_3 = b7_31 + T(0.4) * minus_B_thetadot11_7_1 + K_thetadot11_8_3;
  // B_thetadot10_7 = E8^T B_thetadot10_8
  const T B_thetadot10_7_1 = E8_11 * hc10_3 - E8_12 * B_thetadot10_8_2;
  const T B_thetadot10_7_2 = E8_12 * hc10_3 + E8_11 * B_thetadot10_8_2;
  // K_thetadot10_7 = q8~ E8^T B_thetadot10_8 + E8^T K_thetadot10_8
  const T b7_32 = T(0.1) * B_thetadot10_7_2;
  const T K_thetadot10_7_1 = E8_11 * K_thetadot10_8_1 - E8_12 * K_thetadot10_8_2 - b7_32 - T(0.4) *
      minus_B_thetadot10_8_3;
  const T K_thetadot10_7_2 = T(0.1) * B_thetadot10_7_1 + b8_22 + E8_12 * K_thetadot10_8_1 + E8_11 * K_thetadot10_8_2;
  const T b7_33 = T(0.3) * B_thetadot10_7_2;
  const T K_thetadot10_7_3 = b7_33 - T(0.4) * B_thetadot10_7_1 + K_thetadot10_8_3;
  // B_thetadot9_7 = E8^T B_thetadot9_8
  const T B_thetadot9_7_1 = E8_12 * hc9_3;
  const T minus_B_thetadot9_7_2 = E8_11 * hc9_3;
  // K_thetadot9_7 = q8~ E8^T B_thetadot9_8 + E8^T K_thetadot9_8
  const T b7_34 = T(0.1) * minus_B_thetadot9_7_2;
  const T K_thetadot9_7_1 = b7_34 + T(0.4) * hc9_2 + E8_11 * b8_5 - E8_12 * K_thetadot9_8_2;
  const T K_thetadot9_7_2 = T(0.1) * B_thetadot9_7_1 - b8_11 + E8_12 * b8_5 + E8_11 * K_thetadot9_8_2;
  const T b7_35 = T(0.3) * minus_B_thetadot9_7_2;
  const T K_thetadot9_7_3 = K_thetadot9_8_3 - b7_35 - T(0.4) * B_thetadot9_7_1;
  // D_thetaddot7: pivots of L D L^T
  const T b7_36 = K_thetadot16_7_2 * T(2.9027576197387517);
  const T b7_37 = K_thetadot15_7_2 + b7_36 * b15_11;
  const T b7_38 = b7_37 * b14_19;
  const T b7_39 = K_thetadot14_7_2 - b7_36 * K_thetadot16_14_3 - b7_38 * b14_18;
  const T b7_40 = b7_39 * b13_28;
  const T b7_41 = K_thetadot13_7_2 - b7_36 * K_thetadot16_13_2 - b7_38 * b13_25 - b7_40 * b13_27;
  const T b7_42 = b7_41 * b12_28;
  const T b7_43 = K_thetadot12_7_2 - b7_36 * K_thetadot16_12_1 - b7_38 * b12_23 - b7_40 * b12_25 - b7_42 * b12_27;
  const T b7_44 = b7_43 * b11_28;
  const T b7_45 = K_thetadot11_7_2 - b7_36 * K_thetadot16_11_3 - b7_38 * b11_21 - b7_40 * b11_23 - b7_42 * b11_25 -
      b7_44 * b11_27;
  const T b7_46 = b7_45 * b10_40;
  const T b7_47 = K_thetadot10_7_2 - b7_36 * K_thetadot16_10_2 - b7_38 * b10_31 - b7_40 * b10_33 - b7_42 * b10_35 -
      b7_44 * b10_37 - b7_46 * b10_39;
  const T b7_48 = b7_47 * b9_37;
  const T b7_49 = K_thetadot9_7_2 - b7_36 * K_thetadot16_9_1 - b7_38 * b9_26 - b7_40 * b9_28 - b7_42 * b9_30 - b7_44 *
      b9_32 - b7_46 * b9_34 - b7_48 * b9_36;
  const T b7_50 = b7_49 * b8_37;
  const T b7_51 = b7_18 - b7_36 * K_thetadot16_8_3 - b7_38 * b8_24 - b7_40 * b8_26 - b7_42 * b8_28 - b7_44 * b8_30 -
      b7_46 * b8_32 - b7_48 * b8_34 - b7_50 * b8_36;
  const T b7_52 = T(1) / D_thetaddot8;
  const T b7_53 = b7_51 * b7_52;
  const T D_thetaddot7 = J7_22 - b7_36 * K_thetadot16_7_2 - b7_38 * b7_37 - b7_40 * b7_39 - b7_42 * b7_41 - b7_44 *
      b7_43 - b7_46 * b7_45 - b7_48 * b7_47 - b7_50 * b7_49 - b7_53 * b7_51;

  // ---- body 6 (body_6) and what it carries
  // S6 = E7^T S7 + G6: sum of the force balances of the subtree, body axes [N]
  const T b6_1 = E7_11 * S7_1 + minus_E7_13 * S7_3;
  const T S6_1 = b6_1 - minus_G6_1;
  const T S6_2 = S7_2 - minus_G6_2;
  const T b6_2 = E7_11 * S7_3 - minus_E7_13 * S7_1;
  const T S6_3 = b6_2 - minus_G6_3;
  // rho6 = q7~ E7^T S7 + E7^T rho7 + r6~ G6 + N6: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho6_1 = T(0.35) * b6_2 - T(0.1) * S7_2 + E7_11 * rho7_1 + minus_E7_13 * rho7_3 + T(0.05) * minus_G6_2 -
      T(0.2) * minus_G6_3 - minus_N6_1;
  const T rho6_2 = T(0.1) * b6_1 - T(0.3) * b6_2 + rho7_2 + T(0.1) * minus_G6_3 - T(0.05) * minus_G6_1 - minus_N6_2;
  const T rho6_3 = T(0.3) * S7_2 - T(0.35) * b6_1 + E7_11 * rho7_3 - minus_E7_13 * rho7_1 + T(0.2) * minus_G6_1 -
      T(0.1) * minus_G6_2 - minus_N6_3;
  // h6 = m6 r6 + m_sub7 q7 + hc7: first moment of mass carried, about the body origin, body axes [kg m]
  const T h6_1 = T(6.609999999999999) + hc7_1;
  const T h6_2 = T(7.845) + h7_2;
  const T h6_3 = T(2.23) + hc7_3;
  // J6 = -q7~ hc7~ + E7^T J7 E7 - m6 r6~ r6~ + I6 + (-m_sub7 q7~ - hc7~) q7~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b6_3 = E7_11 * J7_11 + minus_E7_13 * J7_31;
  const T b6_4 = E7_11 * J7_13 + minus_E7_13 * J7_33;
  const T b6_5 = T(0.1) * hc7_3;
  const T b6_6 = T(7.5249999999999995) + h7_2;
  const T b6_7 = T(0.35) * h7_2 + b6_6 * T(0.35);
  const T b6_8 = hc7_3 + T(2.15);
  const T b6_9 = b6_8 * T(0.1);
  const T J6_11 = b6_3 * E7_11 + b6_4 * minus_E7_13 + b6_5 + b6_7 + T(0.228) + b6_9;
  const T b6_10 = E7_11 * J7_12 + minus_E7_13 * J7_32;
  const T b6_11 = b6_10 - T(0.35) * hc7_1;
  const T J6_12 = b6_11 - T(0.024000000000000004) - b6_6 * T(0.3);
  const T b6_12 = b6_4 * E7_11 - b6_3 * minus_E7_13 - T(0.003200000000000002);
  const T J6_13 = b6_12 - T(0.1) * hc7_1 - b6_8 * T(0.3);
  const T b6_13 = hc7_1 + T(6.45);
  const T J6_21 = b6_10 - T(0.3) * h7_2 - T(0.024000000000000004) - b6_13 * T(0.35);
  const T b6_14 = T(0.3) * hc7_1;
  const T b6_15 = b6_5 + b6_14 + J7_22;
  const T b6_16 = b6_13 * T(0.3);
  const T J6_22 = b6_15 + T(0.212) + b6_9 + b6_16;
  const T b6_17 = J7_23 * E7_11 - J7_21 * minus_E7_13 - T(0.022400000000000003);
  const T J6_23 = b6_17 - T(0.1) * h7_2 - b6_8 * T(0.35);
  const T b6_18 = T(0.3) * hc7_3;
  const T J6_31 = b6_12 - b6_18 - b6_13 * T(0.1);
  const T b6_19 = T(0.35) * hc7_3;
  const T J6_32 = b6_17 - b6_19 - b6_6 * T(0.1);
  const T J6_33 = (E7_11 * J7_33 - minus_E7_13 * J7_13) * E7_11 - (E7_11 * J7_31 - minus_E7_13 * J7_11) * minus_E7_13
      + b6_7 + b6_14 + T(0.20800000000000002) + b6_16;
  // hc6 = E6^T h6: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc6_2 = E6_22 * h6_2 - E6_23 * h6_3;
  const T hc6_3 = E6_22 * h6_3 + E6_23 * h6_2;
  // B_thetadot16_6 = E7^T B_thetadot16_7
  const T B_thetadot16_6_1 = E7_11 * B_thetadot16_7_1 + minus_E7_13 * B_thetadot16_8_3;
  const T B_thetadot16_6_3 = E7_11 * B_thetadot16_8_3 - minus_E7_13 * B_thetadot16_7_1;
  // K_thetadot16_6 = q7~ E7^T B_thetadot16_7 + E7^T K_thetadot16_7
  const T K_thetadot16_6_1 = T(0.35) * B_thetadot16_6_3 - b7_20 + E7_11 * K_thetadot16_7_1 + minus_E7_13 *
      K_thetadot16_7_3;
  const T b6_20 = T(0.1) * B_thetadot16_6_1;
  const T K_thetadot16_6_2 = b6_20 - T(0.3) * B_thetadot16_6_3 + K_thetadot16_7_2;
  const T K_thetadot16_6_3 = b7_21 - T(0.35) * B_thetadot16_6_1 + E7_11 * K_thetadot16_7_3 - minus_E7_13 *
      K_thetadot16_7_1;
  // B_thetadot15_6 = E7^T B_thetadot15_7
  const T B_thetadot15_6_1 = E7_11 * B_thetadot15_7_1 + minus_E7_13 * B_thetadot15_8_3;
  const T B_thetadot15_6_3 = E7_11 * B_thetadot15_8_3 - minus_E7_13 * B_thetadot15_7_1;
  // K_thetadot15_6 = q7~ E7^T B_thetadot15_7 + E7^T K_thetadot15_7
  const T K_thetadot15_6_1 = T(0.35) * B_thetadot15_6_3 - b7_22 + E7_11 * K_thetadot15_7_1 + minus_E7_13 *
      K_thetadot15_7_3;
  const T b6_21 = T(0.1) * B_thetadot15_6_1;
  const T K_thetadot15_6_2 = b6_21 - T(0.3) * B_thetadot15_6_3 + K_thetadot15_7_2;
  const T K_thetadot15_6_3 = b7_23 - T(0.35) * B_thetadot15_6_1 + E7_11 * K_thetadot15_7_3 - minus_E7_13 *
      K_thetadot15_7_1;
  // B_thetadot14_6 = E7^T B_thetadot14_7
  const T B_thetadot14_6_1 = E7_11 * B_thetadot14_7_1 + minus_E7_13 * B_thetadot14_8_3;
  const T B_thetadot14_6_3 = E7_11 * B_thetadot14_8_3 - minus_E7_13 * B_thetadot14_7_1;
  // K_thetadot14_6 = q7~ E7^T B_thetadot14_7 + E7^T K_thetadot14_7
  const T K_thetadot14_6_1 = T(0.35) * B_thetadot14_6_3 - b7_24 + E7_11 * K_thetadot14_7_1 + minus_E7_13 *
      K_thetadot14_7_3;
  const T b6_22 = T(0.1) * B_thetadot14_6_1;
  const T K_thetadot14_6_2 = b6_22 - T(0.3) * B_thetadot14_6_3 + K_thetadot14_7_2;
  const T K_thetadot14_6_3 = b7_25 - T(0.35) * B_thetadot14_6_1 + E7_11 * K_thetadot14_7_3 - minus_E7_13 *
      K_thetadot14_7_1;
  // B_thetadot13_6 = E7^T B_thetadot13_7
  const T B_thetadot13_6_1 = E7_11 * B_thetadot13_7_1 + minus_E7_13 * B_thetadot13_8_3;
  const T B_thetadot13_6_3 = E7_11 * B_thetadot13_8_3 - minus_E7_13 * B_thetadot13_7_1;
  // K_thetadot13_6 = q7~ E7^T B_thetadot13_7 + E7^T K_thetadot13_7
  const T K_thetadot13_6_1 = T(0.35) * B_thetadot13_6_3 - b7_26 + E7_11 * K_thetadot13_7_1 + minus_E7_13 *
      K_thetadot13_7_3;
  const T b6_23 = T(0.1) * B_thetadot13_6_1;
  const T K_thetadot13_6_2 = b6_23 - T(0.3) * B_thetadot13_6_3 + K_thetadot13_7_2;
  const T K_thetadot13_6_3 = b7_27 - T(0.35) * B_thetadot13_6_1 + E7_11 * K_thetadot13_7_3 - minus_E7_13 *
      K_thetadot13_7_1;
  // B_thetadot12_6 = E7^T B_thetadot12_7
  const T B_thetadot12_6_1 = E7_11 * B_thetadot12_7_1 + minus_E7_13 * B_thetadot12_8_3;
  const T B_thetadot12_6_3 = E7_11 * B_thetadot12_8_3 - minus_E7_13 * B_thetadot12_7_1;
  // K_thetadot12_6 = q7~ E7^T B_thetadot12_7 + E7^T K_thetadot12_7
  const T K_thetadot12_6_1 = T(0.35) * B_thetadot12_6_3 - b7_28 + E7_11 * K_thetadot12_7_1 + minus_E7_13 *
      K_thetadot12_7_3;
  const T b6_24 = T(0.1) * B_thetadot12_6_1;
  const T K_thetadot12_6_2 = b6_24 - T(0.3) * B_thetadot12_6_3 + K_thetadot12_7_2;
  const T K_thetadot12_6_3 = b7_29 - T(0.35) * B_thetadot12_6_1 + E7_11 * K_thetadot12_7_3 - minus_E7_13 *
      K_thetadot12_7_1;
  // B_thetadot11_6 = E7^T B_thetadot11_7
  const T B_thetadot11_6_1 = minus_E7_13 * B_thetadot11_8_3 - E7_11 * minus_B_thetadot11_7_1;
  const T B_thetadot11_6_3 = minus_E7_13 * minus_B_thetadot11_7_1 + E7_11 * B_thetadot11_8_3;
  // K_thetadot11_6 = q7~ E7^T B_thetadot11_7 + E7^T K_thetadot11_7
  const T K_thetadot11_6_1 = T(0.35) * B_thetadot11_6_3 - b7_30 + E7_11 * K_thetadot11_7_1 + minus_E7_13 *
      K_thetadot11_7_3;
  const T b6_25 = T(0.1) * B_thetadot11_6_1;
  const T K_thetadot11_6_2 = b6_25 - T(0.3) * B_thetadot11_6_3 + K_thetadot11_7_2;
  const T K_thetadot11_6_3 = b7_31 - T(0.35) * B_thetadot11_6_1 + E7_11 * K_thetadot11_7_3 - minus_E7_13 *
      K_thetadot11_7_1;
  // B_thetadot10_6 = E7^T B_thetadot10_7
  const T B_thetadot10_6_1 = E7_11 * B_thetadot10_7_1 - minus_E7_13 * minus_B_thetadot10_8_3;
  const T minus_B_thetadot10_6_3 = minus_E7_13 * B_thetadot10_7_1 + E7_11 * minus_B_thetadot10_8_3;
  // K_thetadot10_6 = q7~ E7^T B_thetadot10_7 + E7^T K_thetadot10_7
  const T K_thetadot10_6_1 = E7_11 * K_thetadot10_7_1 + minus_E7_13 * K_thetadot10_7_3 - b7_32 - T(0.35) *
      minus_B_thetadot10_6_3;
  const T b6_26 = T(0.1) * B_thetadot10_6_1;
  const T K_thetadot10_6_2 = b6_26 + T(0.3) * minus_B_thetadot10_6_3 + K_thetadot10_7_2;
  const T K_thetadot10_6_3 = b7_33 - T(0.35) * B_thetadot10_6_1 + E7_11 * K_thetadot10_7_3 - minus_E7_13 *
      K_thetadot10_7_1;
  // B_thetadot9_6 = E7^T B_thetadot9_7
  const T B_thetadot9_6_1 = E7_11 * B_thetadot9_7_1 + minus_E7_13 * hc9_2;
  const T B_thetadot9_6_3 = E7_11 * hc9_2 - minus_E7_13 * B_thetadot9_7_1;
  // K_thetadot9_6 = q7~ E7^T B_thetadot9_7 + E7^T K_thetadot9_7
  const T K_thetadot9_6_1 = b7_34 + T(0.35) * B_thetadot9_6_3 + E7_11 * K_thetadot9_7_1 + minus_E7_13 *
      K_thetadot9_7_3;
  const T b6_27 = T(0.1) * B_thetadot9_6_1;
  const T K_thetadot9_6_2 = b6_27 - T(0.3) * B_thetadot9_6_3 + K_thetadot9_7_2;
  const T K_thetadot9_6_3 = E7_11 * K_thetadot9_7_3 - minus_E7_13 * K_thetadot9_7_1 - b7_35 - T(0.35) *
      B_thetadot9_6_1;
  // B_thetadot8_6 = E7^T B_thetadot8_7
  const T minus_B_thetadot8_6_1 = E7_11 * hc8_2;
  const T B_thetadot8_6_3 = minus_E7_13 * hc8_2;
  // K_thetadot8_6 = q7~ E7^T B_thetadot8_7 + E7^T K_thetadot8_7
  const T K_thetadot8_6_1 = T(0.35) * B_thetadot8_6_3 - b7_12 + E7_11 * b7_13 + minus_E7_13 * b7_19;
  const T b6_28 = T(0.1) * minus_B_thetadot8_6_1;
  const T K_thetadot8_6_2 = b7_18 - b6_28 - T(0.3) * B_thetadot8_6_3;
  const T K_thetadot8_6_3 = b7_15 + T(0.35) * minus_B_thetadot8_6_1 + E7_11 * b7_19 - minus_E7_13 * b7_13;
  // K_thetadot7_6 = q7~ E7^T B_thetadot7_7 + E7^T K_thetadot7_7
  const T K_thetadot7_6_3 = E7_11 * J7_32 - minus_E7_13 * J7_12 - b6_19;
  // D_thetaddot6: pivots of L D L^T
  const T b6_29 = K_thetadot16_6_1 * T(2.9027576197387517);
  const T b6_30 = K_thetadot15_6_1 + b6_29 * b15_11;
  const T b6_31 = b6_30 * b14_19;
  const T b6_32 = K_thetadot14_6_1 - b6_29 * K_thetadot16_14_3 - b6_31 * b14_18;
  const T b6_33 = b6_32 * b13_28;
  const T b6_34 = K_thetadot13_6_1 - b6_29 * K_thetadot16_13_2 - b6_31 * b13_25 - b6_33 * b13_27;
  const T b6_35 = b6_34 * b12_28;
  const T b6_36 = K_thetadot12_6_1 - b6_29 * K_thetadot16_12_1 - b6_31 * b12_23 - b6_33 * b12_25 - b6_35 * b12_27;
  const T b6_37 = b6_36 * b11_28;
  const T b6_38 = K_thetadot11_6_1 - b6_29 * K_thetadot16_11_3 - b6_31 * b11_21 - b6_33 * b11_23 - b6_35 * b11_25 -
      b6_37 * b11_27;
  const T b6_39 = b6_38 * b10_40;
  const T b6_40 = K_thetadot10_6_1 - b6_29 * K_thetadot16_10_2 - b6_31 * b10_31 - b6_33 * b10_33 - b6_35 * b10_35 -
      b6_37 * b10_37 - b6_39 * b10_39;
  const T b6_41 = b6_40 * b9_37;
  const T b6_42 = K_thetadot9_6_1 - b6_29 * K_thetadot16_9_1 - b6_31 * b9_26 - b6_33 * b9_28 - b6_35 * b9_30 - b6_37 *
      b9_32 - b6_39 * b9_34 - b6_41 * b9_36;
  const T b6_43 = b6_42 * b8_37;
  const T b6_44 = K_thetadot8_6_1 - b6_29 * K_thetadot16_8_3 - b6_31 * b8_24 - b6_33 * b8_26 - b6_35 * b8_28 - b6_37 *
      b8_30 - b6_39 * b8_32 - b6_41 * b8_34 - b6_43 * b8_36;
  const T b6_45 = b6_44 * b7_52;
  const T b6_46 = b6_11 - b6_29 * K_thetadot16_7_2 - b6_31 * b7_37 - b6_33 * b7_39 - b6_35 * b7_41 - b6_37 * b7_43 -
      b6_39 * b7_45 - b6_41 * b7_47 - b6_43 * b7_49 - b6_45 * b7_51;
  const T b6_47 = T(1) / D_thetaddot7;
  const T b6_48 = b6_46 * b6_47;
  const T D_thetaddot6 = J6_11 - b6_29 * K_thetadot16_6_1 - b6_31 * b6_30 - b6_33 * b6_32 - b6_35 * b6_34 - b6_37 *
      b6_36 - b6_39 * b6_38 - b6_41 * b6_40 - b6_43 * b6_42 - b6_45 * b6_44 - b6_48 * b6_46;

  // ---- body 5 (body_5) and what it carries
  // S5 = E6^T S6 + G5: sum of the force balances of the subtree, body axes [N]
  const T S5_1 = S6_1 - minus_G5_1;
  const T b5_1 = E6_22 * S6_2 - E6_23 * S6_3;
  const T S5_2 = b5_1 - minus_G5_2;
  const T b5_2 = E6_23 * S6_2 + E6_22 * S6_3;
  const T S5_3 = b5_2 - minus_G5_3;
  // rho5 = q6~ E6^T S6 + E6^T rho6 + r5~ G5 + N5: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T b5_3 = T(0.3) * b5_2;
  const T rho5_1 = b5_3 - T(0.1) * b5_1 + rho6_1 + T(0.05) * minus_G5_2 - T(0.2) * minus_G5_3 - minus_N5_1;
  const T rho5_2 = T(0.1) * S6_1 - b5_3 + E6_22 * rho6_2 - E6_23 * rho6_3 + T(0.1) * minus_G5_3 - T(0.05) * minus_G5_1
      - minus_N5_2;
  const T rho5_3 = T(0.3) * b5_1 - T(0.3) * S6_1 + E6_23 * rho6_2 + E6_22 * rho6_3 + T(0.2) * minus_G5_1 - T(0.1) *
      minus_G5_2 - minus_N5_3;
  // h5 = m5 r5 + m_sub6 q6 + hc6: first moment of mass carried, about the body origin, body axes [kg m]
  const T h5_1 = T(7.08) + h6_1;
  const T h5_2 = T(7.2299999999999995) + hc6_2;
  const T h5_3 = T(2.3850000000000002) + hc6_3;
  // J5 = -q6~ hc6~ + E6^T J6 E6 - m5 r5~ r5~ + I5 + (-m_sub6 q6~ - hc6~) q6~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b5_4 = T(0.1) * hc6_3;
  const T b5_5 = T(0.3) * hc6_2;
  const T b5_6 = b5_4 + b5_5 + J6_11;
  const T b5_7 = hc6_3 + T(2.31);
  const T b5_8 = b5_7 * T(0.1);
  const T b5_9 = (T(6.93) + hc6_2) * T(0.3);
  const T J5_11 = b5_6 + T(0.21375) + b5_8 + b5_9;
  const T b5_10 = J6_12 * E6_22 - J6_13 * E6_23 - T(0.022500000000000003);
  const T b5_11 = T(0.3) * h6_1;
  const T b5_12 = b5_11 + b5_9;
  const T J5_12 = b5_10 - b5_12;
  const T b5_13 = b5_7 * T(0.3);
  const T J5_13 = J6_12 * E6_23 + J6_13 * E6_22 - T(0.1) * h6_1 - T(0.0030000000000000014) - b5_13;
  const T b5_14 = (h6_1 + T(6.93)) * T(0.3);
  const T b5_15 = b5_5 + b5_14;
  const T J5_21 = b5_10 - b5_15;
  const T b5_16 = E6_22 * J6_22 - E6_23 * J6_32;
  const T b5_17 = E6_22 * J6_23 - E6_23 * J6_33;
  const T J5_22 = b5_16 * E6_22 - b5_17 * E6_23 + b5_4 + b5_11 + T(0.19874999999999998) + b5_8 + b5_14;
  const T J5_23 = b5_16 * E6_23 + b5_17 * E6_22 - T(0.1) * hc6_2 - T(0.021) - b5_13;
  const T J5_33 = (E6_23 * J6_22 + E6_22 * J6_32) * E6_23 + (E6_23 * J6_23 + E6_22 * J6_33) * E6_22 + b5_15 + b5_12 +
      T(0.195);
  // hc5 = E5^T h5: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc5_1 = E5_11 * h5_1 - E5_12 * h5_2;
  const T hc5_2 = E5_11 * h5_2 + E5_12 * h5_1;
  // B_thetadot16_5 = E6^T B_thetadot16_6
  const T B_thetadot16_5_2 = E6_22 * B_thetadot16_7_2 - E6_23 * B_thetadot16_6_3;
  const T B_thetadot16_5_3 = E6_23 * B_thetadot16_7_2 + E6_22 * B_thetadot16_6_3;
  // K_thetadot16_5 = q6~ E6^T B_thetadot16_6 + E6^T K_thetadot16_6
  const T b5_18 = T(0.3) * B_thetadot16_5_3;
  const T K_thetadot16_5_1 = b5_18 - T(0.1) * B_thetadot16_5_2 + K_thetadot16_6_1;
  const T K_thetadot16_5_2 = b6_20 - b5_18 + E6_22 * K_thetadot16_6_2 - E6_23 * K_thetadot16_6_3;
  const T K_thetadot16_5_3 = T(0.3) * B_thetadot16_5_2 - T(0.3) * B_thetadot16_6_1 + E6_23 * K_thetadot16_6_2 + E6_22
      * K_thetadot16_6_3;
  // B_thetadot15_5 = E6^T B_thetadot15_6
  const T B_thetadot15_5_2 = E6_22 * B_thetadot15_7_2 - E6_23 * B_thetadot15_6_3;
  const T B_thetadot15_5_3 = E6_23 * B_thetadot15_7_2 + E6_22 * B_thetadot15_6_3;
  // K_thetadot15_5 = q6~ E6^T B_thetadot15_6 + E6^T K_thetadot15_6
  const T b5_19 = T(0.3) * B_thetadot15_5_3;
  const T K_thetadot15_5_1 = b5_19 - T(0.1) * B_thetadot15_5_2 + K_thetadot15_6_1;
  const T K_thetadot15_5_2 = b6_21 - b5_19 + E6_22 * K_thetadot15_6_2 - E6_23 * K_thetadot15_6_3;
  const T K_thetadot15_5_3 = T(0.3) * B_thetadot15_5_2 - T(0.3) * B_thetadot15_6_1 + E6_23 * K_thetadot15_6_2 + E6_22
      * K_thetadot15_6_3;
  // B_thetadot14_5 = E6^T B_thetadot14_6
  const T B_thetadot14_5_2 = E6_22 * B_thetadot14_7_2 - E6_23 * B_thetadot14_6_3;
  const T B_thetadot14_5_3 = E6_23 * B_thetadot14_7_2 + E6_22 * B_thetadot14_6_3;
  // K_thetadot14_5 = q6~ E6^T B_thetadot14_6 + E6^T K_thetadot14_6
  const T b5_20 = T(0.3) * B_thetadot14_5_3;
  const T K_thetadot14_5_1 = b5_20 - T(0.1) * B_thetadot14_5_2 + K_thetadot14_6_1;
  const T K_thetadot14_5_2 = b6_22 - b5_20 + E6_22 * K_thetadot14_6_2 - E6_23 * K_thetadot14_6_3;
  const T K_thetadot14_5_3 = T(0.3) * B_thetadot14_5_2 - T(0.3) * B_thetadot14_6_1 + E6_23 * K_thetadot14_6_2 + E6_22
      * K_thetadot14_6_3;
  // B_thetadot13_5 = E6^T B_thetadot13_6
  const T B_thetadot13_5_2 = E6_22 * B_thetadot13_7_2 - E6_23 * B_thetadot13_6_3;
  const T B_thetadot13_5_3 = E6_23 * B_thetadot13_7_2 + E6_22 * B_thetadot13_6_3;
  // K_thetadot13_5 = q6~ E6^T B_thetadot13_6 + E6^T K_thetadot13_6
  const T b5_21 = T(0.3) * B_thetadot13_5_3;
  const T K_thetadot13_5_1 = b5_21 - T(0.1) * B_thetadot13_5_2 + K_thetadot13_6_1;
  const T K_thetadot13_5_2 = b6_23 - b5_21 + E6_22 * K_thetadot13_6_2 - E6_23 * K_thetadot13_6_3;
  const T K_thetadot13_5_3 = T(0.3) * B_thetadot13_5_2 - T(0.3) * B_thetadot13_6_1 + E6_23 * K_thetadot13_6_2 + E6_22
      * K_thetadot13_6_3;
  // B_thetadot12_5 = E6^T B_thetadot12_6
  const T B_thetadot12_5_2 = E6_22 * B_thetadot12_7_2 - E6_23 * B_thetadot12_6_3;
  const T B_thetadot12_5_3 = E6_23 * B_thetadot12_7_2 + E6_22 * B_thetadot12_6_3;
  // K_thetadot12_5 = q6~ E6^T B_thetadot12_6 + E6^T K_thetadot12_6
  const T b5_22 = T(0.3) * B_thetadot12_5_3;
  const T K_thetadot12_5_1 = b5_22 - T(0.1) * B_thetadot12_5_2 + K_thetadot12_6_1;
  const T K_thetadot12_5_2 = b6_24 - b5_22 + E6_22 * K_thetadot12_6_2 - E6_23 * K_thetadot12_6_3;
  const T K_thetadot12_5_3 = T(0.3) * B_thetadot12_5_2 - T(0.3) * B_thetadot12_6_1 + E6_23 * K_thetadot12_6_2 + E6_22
      * K_thetadot12_6_3;
  // B_thetadot11_5 = E6^T B_thetadot11_6
  const T B_thetadot11_5_2 = E6_22 * B_thetadot11_7_2 - E6_23 * B_thetadot11_6_3;
  const T B_thetadot11_5_3 = E6_23 * B_thetadot11_7_2 + E6_22 * B_thetadot11_6_3;
  // K_thetadot11_5 = q6~ E6^T B_thetadot11_6 + E6^T K_thetadot11_6
  const T b5_23 = T(0.3) * B_thetadot11_5_3;
  const T K_thetadot11_5_1 = b5_23 - T(0.1) * B_thetadot11_5_2 + K_thetadot11_6_1;
  const T K_thetadot11_5_2 = b6_25 - b5_23 + E6_22 * K_thetadot11_6_2 - E6_23 * K_thetadot11_6_3;
  const T K_thetadot11_5_3 = T(0.3) * B_thetadot11_5_2 - T(0.3) * B_thetadot11_6_1 + E6_23 * K_thetadot11_6_2 + E6_22
      * K_thetadot11_6_3;
  // B_thetadot10_5 = E6^T B_thetadot10_6
  const T B_thetadot10_5_2 = E6_22 * B_thetadot10_7_2 + E6_23 * minus_B_thetadot10_6_3;
  const T B_thetadot10_5_3 = E6_23 * B_thetadot10_7_2 - E6_22 * minus_B_thetadot10_6_3;
  // K_thetadot10_5 = q6~ E6^T B_thetadot10_6 + E6^T K_thetadot10_6
  const T b5_24 = T(0.3) * B_thetadot10_5_3;
  const T K_thetadot10_5_1 = b5_24 - T(0.1) * B_thetadot10_5_2 + K_thetadot10_6_1;
  const T K_thetadot10_5_2 = b6_26 - b5_24 + E6_22 * K_thetadot10_6_2 - E6_23 * K_thetadot10_6_3;
  const T K_thetadot10_5_3 = T(0.3) * B_thetadot10_5_2 - T(0.3) * B_thetadot10_6_1 + E6_23 * K_thetadot10_6_2 + E6_22
      * K_thetadot10_6_3;
  // B_thetadot9_5 = E6^T B_thetadot9_6
  const T minus_B_thetadot9_5_2 = E6_22 * minus_B_thetadot9_7_2 + E6_23 * B_thetadot9_6_3;
  const T B_thetadot9_5_3 = E6_22 * B_thetadot9_6_3 - E6_23 * minus_B_thetadot9_7_2;
  // K_thetadot9_5 = q6~ E6^T B_thetadot9_6 + E6^T K_thetadot9_6
  const T b5_25 = T(0.3) * B_thetadot9_5_3;
  const T K_thetadot9_5_1 = T(0.1) * minus_B_thetadot9_5_2 + b5_25 + K_thetadot9_6_1;
  const T K_thetadot9_5_2 = b6_27 - b5_25 + E6_22 * K_thetadot9_6_2 - E6_23 * K_thetadot9_6_3;
  const T K_thetadot9_5_3 = E6_23 * K_thetadot9_6_2 + E6_22 * K_thetadot9_6_3 - T(0.3) * minus_B_thetadot9_5_2 -
      T(0.3) * B_thetadot9_6_1;
  // B_thetadot8_5 = E6^T B_thetadot8_6
  const T B_thetadot8_5_2 = E6_22 * hc8_1 - E6_23 * B_thetadot8_6_3;
  const T B_thetadot8_5_3 = E6_23 * hc8_1 + E6_22 * B_thetadot8_6_3;
  // K_thetadot8_5 = q6~ E6^T B_thetadot8_6 + E6^T K_thetadot8_6
  const T b5_26 = T(0.3) * B_thetadot8_5_3;
  const T K_thetadot8_5_1 = b5_26 - T(0.1) * B_thetadot8_5_2 + K_thetadot8_6_1;
  const T K_thetadot8_5_2 = E6_22 * K_thetadot8_6_2 - E6_23 * K_thetadot8_6_3 - b6_28 - b5_26;
  const T K_thetadot8_5_3 = T(0.3) * B_thetadot8_5_2 + T(0.3) * minus_B_thetadot8_6_1 + E6_23 * K_thetadot8_6_2 +
      E6_22 * K_thetadot8_6_3;
  // B_thetadot7_5 = E6^T B_thetadot7_6
  const T B_thetadot7_5_2 = E6_23 * hc7_1;
  const T minus_B_thetadot7_5_3 = E6_22 * hc7_1;
  // K_thetadot7_5 = q6~ E6^T B_thetadot7_6 + E6^T K_thetadot7_6
  const T b5_27 = T(0.3) * minus_B_thetadot7_5_3;
  const T K_thetadot7_5_1 = b6_11 - T(0.1) * B_thetadot7_5_2 - b5_27;
  const T K_thetadot7_5_2 = b6_5 + b5_27 + E6_22 * b6_15 - E6_23 * K_thetadot7_6_3;
  const T K_thetadot7_5_3 = T(0.3) * B_thetadot7_5_2 - b6_18 + E6_23 * b6_15 + E6_22 * K_thetadot7_6_3;
  // K_thetadot6_5 = q6~ E6^T B_thetadot6_6 + E6^T K_thetadot6_6
  const T K_thetadot6_5_2 = E6_22 * J6_21 - E6_23 * J6_31 - b5_5;
  const T K_thetadot6_5_3 = E6_23 * J6_21 + E6_22 * J6_31 - T(0.3) * hc6_3;
  // D_thetaddot5: pivots of L D L^T
  const T b5_28 = K_thetadot16_5_3 * T(2.9027576197387517);
  const T b5_29 = K_thetadot15_5_3 + b5_28 * b15_11;
  const T b5_30 = b5_29 * b14_19;
  const T b5_31 = K_thetadot14_5_3 - b5_28 * K_thetadot16_14_3 - b5_30 * b14_18;
  const T b5_32 = b5_31 * b13_28;
  const T b5_33 = K_thetadot13_5_3 - b5_28 * K_thetadot16_13_2 - b5_30 * b13_25 - b5_32 * b13_27;
  const T b5_34 = b5_33 * b12_28;
  const T b5_35 = K_thetadot12_5_3 - b5_28 * K_thetadot16_12_1 - b5_30 * b12_23 - b5_32 * b12_25 - b5_34 * b12_27;
  const T b5_36 = b5_35 * b11_28;
  const T b5_37 = K_thetadot11_5_3 - b5_28 * K_thetadot16_11_3 - b5_30 * b11_21 - b5_32 * b11_23 - b5_34 * b11_25 -
      b5_36 * b11_27;
  const T b5_38 = b5_37 * b10_40;
  const T b5_39 = K_thetadot10_5_3 - b5_28 * K_thetadot16_10_2 - b5_30 * b10_31 - b5_32 * b10_33 - b5_34 * b10_35 -
      b5_36 * b10_37 - b5_38 * b10_39;
  const T b5_40 = b5_39 * b9_37;
  const T b5_41 = K_thetadot9_5_3 - b5_28 * K_thetadot16_9_1 - b5_30 * b9_26 - b5_32 * b9_28 - b5_34 * b9_30 - b5_36 *
      b9_32 - b5_38 * b9_34 - b5_40 * b9_36;
  const T b5_42 = b5_41 * b8_37;
  const T b5_43 = K_thetadot8_5_3 - b5_28 * K_thetadot16_8_3 - b5_30 * b8_24 - b5_32 * b8_26 - b5_34 * b8_28 - b5_36 *
      b8_30 - b5_38 * b8_32 - b5_40 * b8_34 - b5_42 * b8_36;
  const T b5_44 = b5_43 * b7_52;
  const T b5_45 = K_thetadot7_5_3 - b5_28 * K_thetadot16_7_2 - b5_30 * b7_37 - b5_32 * b7_39 - b5_34 * b7_41 - b5_36 *
      b7_43 - b5_38 * b7_45 - b5_40 * b7_47 - b5_42 * b7_49 - b5_44 * b7_51;
  const T b5_46 = b5_45 * b6_47;
  const T b5_47 = K_thetadot6_5_3 - b5_28 * K_thetadot16_6_1 - b5_30 * b6_30 - b5_32 * b6_32 - b5_34 * b6_34 - b5_36 *
      b6_36 - b5_38 * b6_38 - b5_40 * b6_40 - b5_42 * b6_42 - b5_44 * b6_44 - b5_46 * b6_46;
  const T b5_48 = T(1) / D_thetaddot6;
  const T b5_49 = b5_47 * b5_48;
  const T D_thetaddot5 = J5_33 - b5_28 * K_thetadot16_5_3 - b5_30 * b5_29 - b5_32 * b5_31 - b5_34 * b5_33 - b5_36 *
      b5_35 - b5_38 * b5_37 - b5_40 * b5_39 - b5_42 * b5_41 - b5_44 * b5_43 - b5_46 * b5_45 - b5_49 * b5_47;

  // ---- body 4 (body_4) and what it carries
  // S4 = E5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T b4_1 = E5_11 * S5_1 - E5_12 * S5_2;
  const T S4_1 = b4_1 - minus_G4_1;
  const T b4_2 = E5_12 * S5_1 + E5_11 * S5_2;
  const T S4_2 = b4_2 - minus_G4_2;
  const T S4_3 = S5_3 - minus_G4_3;
  // rho4 = q5~ E5^T S5 + E5^T rho5 + r4~ G4 + N4: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho4_1 = T(0.25) * S5_3 - T(0.1) * b4_2 + E5_11 * rho5_1 - E5_12 * rho5_2 + T(0.05) * minus_G4_2 - T(0.2) *
      minus_G4_3 - minus_N4_1;
  const T rho4_2 = T(0.1) * b4_1 - T(0.3) * S5_3 + E5_12 * rho5_1 + E5_11 * rho5_2 + T(0.1) * minus_G4_3 - T(0.05) *
      minus_G4_1 - minus_N4_2;
  const T rho4_3 = T(0.3) * b4_2 - T(0.25) * b4_1 + rho5_3 + T(0.2) * minus_G4_1 - T(0.1) * minus_G4_2 - minus_N4_3;
  // h4 = m4 r4 + m_sub5 q5 + hc5: first moment of mass carried, about the body origin, body axes [kg m]
  const T h4_1 = T(7.52) + hc5_1;
  const T h4_2 = T(6.43) + hc5_2;
  const T h4_3 = T(2.5300000000000002) + h5_3;
  // J4 = -q5~ hc5~ + E5^T J5 E5 - m4 r4~ r4~ + I4 + (-m_sub5 q5~ - hc5~) q5~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b4_3 = E5_11 * J5_11 - E5_12 * J5_21;
  const T b4_4 = E5_11 * J5_12 - E5_12 * J5_22;
  const T b4_5 = h5_3 + T(2.46);
  const T b4_6 = T(0.1) * h5_3 + b4_5 * T(0.1);
  const T b4_7 = T(0.25) * hc5_2;
  const T b4_8 = T(6.15) + hc5_2;
  const T b4_9 = b4_8 * T(0.25);
  const T J4_11 = b4_3 * E5_11 - b4_4 * E5_12 + b4_6 + b4_7 + T(0.1995) + b4_9;
  const T b4_10 = b4_3 * E5_12 + b4_4 * E5_11 - T(0.021);
  const T J4_12 = b4_10 - T(0.25) * hc5_1 - b4_8 * T(0.3);
  const T b4_11 = E5_11 * J5_13 - E5_12 * J5_23;
  const T b4_12 = T(0.1) * hc5_1;
  const T b4_13 = b4_11 - b4_12;
  const T J4_13 = b4_13 - T(0.0028000000000000004) - b4_5 * T(0.3);
  const T b4_14 = hc5_1 + T(7.38);
  const T J4_21 = b4_10 - T(0.3) * hc5_2 - b4_14 * T(0.25);
  const T b4_15 = T(0.3) * hc5_1;
  const T b4_16 = b4_14 * T(0.3);
  const T J4_22 = (E5_12 * J5_11 + E5_11 * J5_21) * E5_12 + (E5_12 * J5_12 + E5_11 * J5_22) * E5_11 + b4_6 + b4_15 +
      T(0.1855) + b4_16;
  const T b4_17 = E5_12 * J5_13 + E5_11 * J5_23;
  const T b4_18 = b4_17 - T(0.1) * hc5_2;
  const T J4_23 = b4_18 - T(0.0196) - b4_5 * T(0.25);
  const T J4_31 = b4_11 - T(0.3) * h5_3 - T(0.0028000000000000004) - b4_14 * T(0.1);
  const T J4_32 = b4_17 - T(0.25) * h5_3 - T(0.0196) - b4_8 * T(0.1);
  const T b4_19 = b4_15 + b4_7 + J5_33;
  const T J4_33 = b4_19 + T(0.182) + b4_9 + b4_16;
  // hc4 = E4^T h4: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4_1 = minus_E4_13 * h4_3 + E4_11 * h4_1;
  const T hc4_3 = E4_11 * h4_3 - minus_E4_13 * h4_1;
  // B_thetadot16_4 = E5^T B_thetadot16_5
  const T B_thetadot16_4_1 = E5_11 * B_thetadot16_6_1 - E5_12 * B_thetadot16_5_2;
  const T B_thetadot16_4_2 = E5_12 * B_thetadot16_6_1 + E5_11 * B_thetadot16_5_2;
  // K_thetadot16_4 = q5~ E5^T B_thetadot16_5 + E5^T K_thetadot16_5
  const T b4_20 = T(0.1) * B_thetadot16_4_2;
  const T K_thetadot16_4_1 = T(0.25) * B_thetadot16_5_3 - b4_20 + E5_11 * K_thetadot16_5_1 - E5_12 * K_thetadot16_5_2;
  const T K_thetadot16_4_2 = T(0.1) * B_thetadot16_4_1 - b5_18 + E5_12 * K_thetadot16_5_1 + E5_11 * K_thetadot16_5_2;
  const T b4_21 = T(0.3) * B_thetadot16_4_2;
  const T K_thetadot16_4_3 = b4_21 - T(0.25) * B_thetadot16_4_1 + K_thetadot16_5_3;
  // B_thetadot15_4 = E5^T B_thetadot15_5
  const T B_thetadot15_4_1 = E5_11 * B_thetadot15_6_1 - E5_12 * B_thetadot15_5_2;
  const T B_thetadot15_4_2 = E5_12 * B_thetadot15_6_1 + E5_11 * B_thetadot15_5_2;
  // K_thetadot15_4 = q5~ E5^T B_thetadot15_5 + E5^T K_thetadot15_5
  const T b4_22 = T(0.1) * B_thetadot15_4_2;
  const T K_thetadot15_4_1 = T(0.25) * B_thetadot15_5_3 - b4_22 + E5_11 * K_thetadot15_5_1 - E5_12 * K_thetadot15_5_2;
  const T K_thetadot15_4_2 = T(0.1) * B_thetadot15_4_1 - b5_19 + E5_12 * K_thetadot15_5_1 + E5_11 * K_thetadot15_5_2;
  const T b4_23 = T(0.3) * B_thetadot15_4_2;
  const T K_thetadot15_4_3 = b4_23 - T(0.25) * B_thetadot15_4_1 + K_thetadot15_5_3;
  // B_thetadot14_4 = E5^T B_thetadot14_5
  const T B_thetadot14_4_1 = E5_11 * B_thetadot14_6_1 - E5_12 * B_thetadot14_5_2;
  const T B_thetadot14_4_2 = E5_12 * B_thetadot14_6_1 + E5_11 * B_thetadot14_5_2;
  // K_thetadot14_4 = q5~ E5^T B_thetadot14_5 + E5^T K_thetadot14_5
  const T b4_24 = T(0.1) * B_thetadot14_4_2;
  const T K_thetadot14_4_1 = T(0.25) * B_thetadot14_5_3 - b4_24 + E5_11 * K_thetadot14_5_1 - E5_12 * K_thetadot14_5_2;
  const T K_thetadot14_4_2 = T(0.1) * B_thetadot14_4_1 - b5_20 + E5_12 * K_thetadot14_5_1 + E5_11 * K_thetadot14_5_2;
  const T b4_25 = T(0.3) * B_thetadot14_4_2;
  const T K_thetadot14_4_3 = b4_25 - T(0.25) * B_thetadot14_4_1 + K_thetadot14_5_3;
  // B_thetadot13_4 = E5^T B_thetadot13_5
  const T B_thetadot13_4_1 = E5_11 * B_thetadot13_6_1 - E5_12 * B_thetadot13_5_2;
  const T B_thetadot13_4_2 = E5_12 * B_thetadot13_6_1 + E5_11 * B_thetadot13_5_2;
  // K_thetadot13_4 = q5~ E5^T B_thetadot13_5 + E5^T K_thetadot13_5
  const T b4_26 = T(0.1) * B_thetadot13_4_2;
  const T K_thetadot13_4_1 = T(0.25) * B_thetadot13_5_3 - b4_26 + E5_11 * K_thetadot13_5_1 - E5_12 * K_thetadot13_5_2;
  const T K_thetadot13_4_2 = T(0.1) * B_thetadot13_4_1 - b5_21 + E5_12 * K_thetadot13_5_1 + E5_11 * K_thetadot13_5_2;
  const T b4_27 = T(0.3) * B_thetadot13_4_2;
  const T K_thetadot13_4_3 = b4_27 - T(0.25) * B_thetadot13_4_1 + K_thetadot13_5_3;
  // B_thetadot12_4 = E5^T B_thetadot12_5
  const T B_thetadot12_4_1 = E5_11 * B_thetadot12_6_1 - E5_12 * B_thetadot12_5_2;
  const T B_thetadot12_4_2 = E5_12 * B_thetadot12_6_1 + E5_11 * B_thetadot12_5_2;
  // K_thetadot12_4 = q5~ E5^T B_thetadot12_5 + E5^T K_thetadot12_5
  const T b4_28 = T(0.1) * B_thetadot12_4_2;
  const T K_thetadot12_4_1 = T(0.25) * B_thetadot12_5_3 - b4_28 + E5_11 * K_thetadot12_5_1 - E5_12 * K_thetadot12_5_2;
  const T K_thetadot12_4_2 = T(0.1) * B_thetadot12_4_1 - b5_22 + E5_12 * K_thetadot12_5_1 + E5_11 * K_thetadot12_5_2;
  const T b4_29 = T(0.3) * B_thetadot12_4_2;
  const T K_thetadot12_4_3 = b4_29 - T(0.25) * B_thetadot12_4_1 + K_thetadot12_5_3;
  // B_thetadot11_4 = E5^T B_thetadot11_5
  const T B_thetadot11_4_1 = E5_11 * B_thetadot11_6_1 - E5_12 * B_thetadot11_5_2;
  const T B_thetadot11_4_2 = E5_12 * B_thetadot11_6_1 + E5_11 * B_thetadot11_5_2;
  // K_thetadot11_4 = q5~ E5^T B_thetadot11_5 + E5^T K_thetadot11_5
  const T b4_30 = T(0.1) * B_thetadot11_4_2;
  const T K_thetadot11_4_1 = T(0.25) * B_thetadot11_5_3 - b4_30 + E5_11 * K_thetadot11_5_1 - E5_12 * K_thetadot11_5_2;
  const T K_thetadot11_4_2 = T(0.1) * B_thetadot11_4_1 - b5_23 + E5_12 * K_thetadot11_5_1 + E5_11 * K_thetadot11_5_2;
  const T b4_31 = T(0.3) * B_thetadot11_4_2;
  const T K_thetadot11_4_3 = b4_31 - T(0.25) * B_thetadot11_4_1 + K_thetadot11_5_3;
  // B_thetadot10_4 = E5^T B_thetadot10_5
  const T B_thetadot10_4_1 = E5_11 * B_thetadot10_6_1 - E5_12 * B_thetadot10_5_2;
  const T B_thetadot10_4_2 = E5_12 * B_thetadot10_6_1 + E5_11 * B_thetadot10_5_2;
  // K_thetadot10_4 = q5~ E5^T B_thetadot10_5 + E5^T K_thetadot10_5
  const T b4_32 = T(0.1) * B_thetadot10_4_2;
  const T K_thetadot10_4_1 = T(0.25) * B_thetadot10_5_3 - b4_32 + E5_11 * K_thetadot10_5_1 - E5_12 * K_thetadot10_5_2;
  const T K_thetadot10_4_2 = T(0.1) * B_thetadot10_4_1 - b5_24 + E5_12 * K_thetadot10_5_1 + E5_11 * K_thetadot10_5_2;
  const T b4_33 = T(0.3) * B_thetadot10_4_2;
  const T K_thetadot10_4_3 = b4_33 - T(0.25) * B_thetadot10_4_1 + K_thetadot10_5_3;
  // B_thetadot9_4 = E5^T B_thetadot9_5
  const T B_thetadot9_4_1 = E5_11 * B_thetadot9_6_1 + E5_12 * minus_B_thetadot9_5_2;
  const T B_thetadot9_4_2 = E5_12 * B_thetadot9_6_1 - E5_11 * minus_B_thetadot9_5_2;
  // K_thetadot9_4 = q5~ E5^T B_thetadot9_5 + E5^T K_thetadot9_5
  const T b4_34 = T(0.1) * B_thetadot9_4_2;
  const T K_thetadot9_4_1 = T(0.25) * B_thetadot9_5_3 - b4_34 + E5_11 * K_thetadot9_5_1 - E5_12 * K_thetadot9_5_2;
  const T K_thetadot9_4_2 = T(0.1) * B_thetadot9_4_1 - b5_25 + E5_12 * K_thetadot9_5_1 + E5_11 * K_thetadot9_5_2;
  const T b4_35 = T(0.3) * B_thetadot9_4_2;
  const T K_thetadot9_4_3 = b4_35 - T(0.25) * B_thetadot9_4_1 + K_thetadot9_5_3;
  // B_thetadot8_4 = E5^T B_thetadot8_5
  const T minus_B_thetadot8_4_1 = E5_11 * minus_B_thetadot8_6_1 + E5_12 * B_thetadot8_5_2;
  const T B_thetadot8_4_2 = E5_11 * B_thetadot8_5_2 - E5_12 * minus_B_thetadot8_6_1;
  // K_thetadot8_4 = q5~ E5^T B_thetadot8_5 + E5^T K_thetadot8_5
  const T b4_36 = T(0.1) * B_thetadot8_4_2;
  const T K_thetadot8_4_1 = T(0.25) * B_thetadot8_5_3 - b4_36 + E5_11 * K_thetadot8_5_1 - E5_12 * K_thetadot8_5_2;
  const T K_thetadot8_4_2 = E5_12 * K_thetadot8_5_1 + E5_11 * K_thetadot8_5_2 - T(0.1) * minus_B_thetadot8_4_1 -
      b5_26;
  const T b4_37 = T(0.3) * B_thetadot8_4_2;
  const T K_thetadot8_4_3 = b4_37 + T(0.25) * minus_B_thetadot8_4_1 + K_thetadot8_5_3;
  // B_thetadot7_4 = E5^T B_thetadot7_5
  const T B_thetadot7_4_1 = E5_11 * hc7_3 - E5_12 * B_thetadot7_5_2;
  const T B_thetadot7_4_2 = E5_12 * hc7_3 + E5_11 * B_thetadot7_5_2;
  // K_thetadot7_4 = q5~ E5^T B_thetadot7_5 + E5^T K_thetadot7_5
  const T b4_38 = T(0.1) * B_thetadot7_4_2;
  const T K_thetadot7_4_1 = E5_11 * K_thetadot7_5_1 - E5_12 * K_thetadot7_5_2 - b4_38 - T(0.25) *
      minus_B_thetadot7_5_3;
  const T K_thetadot7_4_2 = T(0.1) * B_thetadot7_4_1 + b5_27 + E5_12 * K_thetadot7_5_1 + E5_11 * K_thetadot7_5_2;
  const T b4_39 = T(0.3) * B_thetadot7_4_2;
  const T K_thetadot7_4_3 = b4_39 - T(0.25) * B_thetadot7_4_1 + K_thetadot7_5_3;
  // B_thetadot6_4 = E5^T B_thetadot6_5
  const T B_thetadot6_4_1 = E5_12 * hc6_3;
  const T minus_B_thetadot6_4_2 = E5_11 * hc6_3;
  // K_thetadot6_4 = q5~ E5^T B_thetadot6_5 + E5^T K_thetadot6_5
  const T b4_40 = T(0.1) * minus_B_thetadot6_4_2;
  const T K_thetadot6_4_1 = b4_40 + T(0.25) * hc6_2 + E5_11 * b5_6 - E5_12 * K_thetadot6_5_2;
  const T K_thetadot6_4_2 = T(0.1) * B_thetadot6_4_1 - b5_5 + E5_12 * b5_6 + E5_11 * K_thetadot6_5_2;
  const T b4_41 = T(0.3) * minus_B_thetadot6_4_2;
  const T K_thetadot6_4_3 = K_thetadot6_5_3 - b4_41 - T(0.25) * B_thetadot6_4_1;
  // D_thetaddot4: pivots of L D L^T
  const T b4_42 = K_thetadot16_4_2 * T(2.9027576197387517);
  const T b4_43 = K_thetadot15_4_2 + b4_42 * b15_11;
  const T b4_44 = b4_43 * b14_19;
  const T b4_45 = K_thetadot14_4_2 - b4_42 * K_thetadot16_14_3 - b4_44 * b14_18;
  const T b4_46 = b4_45 * b13_28;
  const T b4_47 = K_thetadot13_4_2 - b4_42 * K_thetadot16_13_2 - b4_44 * b13_25 - b4_46 * b13_27;
  const T b4_48 = b4_47 * b12_28;
  const T b4_49 = K_thetadot12_4_2 - b4_42 * K_thetadot16_12_1 - b4_44 * b12_23 - b4_46 * b12_25 - b4_48 * b12_27;
  const T b4_50 = b4_49 * b11_28;
  const T b4_51 = K_thetadot11_4_2 - b4_42 * K_thetadot16_11_3 - b4_44 * b11_21 - b4_46 * b11_23 - b4_48 * b11_25 -
      b4_50 * b11_27;
  const T b4_52 = b4_51 * b10_40;
  const T b4_53 = K_thetadot10_4_2 - b4_42 * K_thetadot16_10_2 - b4_44 * b10_31 - b4_46 * b10_33 - b4_48 * b10_35 -
      b4_50 * b10_37 - b4_52 * b10_39;
  const T b4_54 = b4_53 * b9_37;
  const T b4_55 = K_thetadot9_4_2 - b4_42 * K_thetadot16_9_1 - b4_44 * b9_26 - b4_46 * b9_28 - b4_48 * b9_30 - b4_50 *
      b9_32 - b4_52 * b9_34 - b4_54 * b9_36;
  const T b4_56 = b4_55 * b8_37;
  const T b4_57 = K_thetadot8_4_2 - b4_42 * K_thetadot16_8_3 - b4_44 * b8_24 - b4_46 * b8_26 - b4_48 * b8_28 - b4_50 *
      b8_30 - b4_52 * b8_32 - b4_54 * b8_34 - b4_56 * b8_36;
  const T b4_58 = b4_57 * b7_52;
  const T b4_59 = K_thetadot7_4_2 - b4_42 * K_thetadot16_7_2 - b4_44 * b7_37 - b4_46 * b7_39 - b4_48 * b7_41 - b4_50 *
      b7_43 - b4_52 * b7_45 - b4_54 * b7_47 - b4_56 * b7_49 - b4_58 * b7_51;
  const T b4_60 = b4_59 * b6_47;
  const T b4_61 = K_thetadot6_4_2 - b4_42 * K_thetadot16_6_1 - b4_44 * b6_30 - b4_46 * b6_32 - b4_48 * b6_34 - b4_50 *
      b6_36 - b4_52 * b6_38 - b4_54 * b6_40 - b4_56 * b6_42 - b4_58 * b6_44 - b4_60 * b6_46;
  const T b4_62 = b4_61 * b5_48;
  const T b4_63 = b4_18 - b4_42 * K_thetadot16_5_3 - b4_44 * b5_29 - b4_46 * b5_31 - b4_48 * b5_33 - b4_50 * b5_35 -
      b4_52 * b5_37 - b4_54 * b5_39 - b4_56 * b5_41 - b4_58 * b5_43 - b4_60 * b5_45 - b4_62 * b5_47;
  const T b4_64 = T(1) / D_thetaddot5;
  const T b4_65 = b4_63 * b4_64;
  const T D_thetaddot4 = J4_22 - b4_42 * K_thetadot16_4_2 - b4_44 * b4_43 - b4_46 * b4_45 - b4_48 * b4_47 - b4_50 *
      b4_49 - b4_52 * b4_51 - b4_54 * b4_53 - b4_56 * b4_55 - b4_58 * b4_57 - b4_60 * b4_59 - b4_62 * b4_61 - b4_65 *
      b4_63;

  // ---- body 3 (body_3) and what it carries
  // S3 = E4^T S4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = E4_11 * S4_1 + minus_E4_13 * S4_3;
  const T S3_1 = b3_1 - minus_G3_1;
  const T S3_2 = S4_2 - minus_G3_2;
  const T b3_2 = E4_11 * S4_3 - minus_E4_13 * S4_1;
  const T S3_3 = b3_2 - minus_G3_3;
  // rho3 = q4~ E4^T S4 + E4^T rho4 + r3~ G3 + N3: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho3_1 = T(0.2) * b3_2 - T(0.1) * S4_2 + E4_11 * rho4_1 + minus_E4_13 * rho4_3 + T(0.05) * minus_G3_2 -
      T(0.2) * minus_G3_3 - minus_N3_1;
  const T rho3_2 = T(0.1) * b3_1 - T(0.3) * b3_2 + rho4_2 + T(0.1) * minus_G3_3 - T(0.05) * minus_G3_1 - minus_N3_2;
  const T rho3_3 = T(0.3) * S4_2 - T(0.2) * b3_1 + E4_11 * rho4_3 - minus_E4_13 * rho4_1 + T(0.2) * minus_G3_1 -
      T(0.1) * minus_G3_2 - minus_N3_3;
  // h3 = m3 r3 + m_sub4 q4 + hc4: first moment of mass carried, about the body origin, body axes [kg m]
  const T h3_1 = T(7.93) + hc4_1;
  const T h3_2 = T(5.46) + h4_2;
  const T h3_3 = T(2.665) + hc4_3;
  // J3 = -q4~ hc4~ + E4^T J4 E4 - m3 r3~ r3~ + I3 + (-m_sub4 q4~ - hc4~) q4~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b3_3 = E4_11 * J4_11 + minus_E4_13 * J4_31;
  const T b3_4 = E4_11 * J4_13 + minus_E4_13 * J4_33;
  const T b3_5 = T(0.1) * hc4_3;
  const T b3_6 = T(5.2) + h4_2;
  const T b3_7 = T(0.2) * h4_2 + b3_6 * T(0.2);
  const T b3_8 = hc4_3 + T(2.6);
  const T b3_9 = b3_8 * T(0.1);
  const T J3_11 = b3_3 * E4_11 + b3_4 * minus_E4_13 + b3_5 + b3_7 + T(0.18525000000000003) + b3_9;
  const T b3_10 = E4_11 * J4_12 + minus_E4_13 * J4_32;
  const T b3_11 = b3_10 - T(0.2) * hc4_1;
  const T J3_12 = b3_11 - T(0.019500000000000003) - b3_6 * T(0.3);
  const T b3_12 = b3_4 * E4_11 - b3_3 * minus_E4_13 - T(0.002600000000000001);
  const T J3_13 = b3_12 - T(0.1) * hc4_1 - b3_8 * T(0.3);
  const T b3_13 = hc4_1 + T(7.8);
  const T J3_21 = b3_10 - T(0.3) * h4_2 - T(0.019500000000000003) - b3_13 * T(0.2);
  const T b3_14 = T(0.3) * hc4_1;
  const T b3_15 = b3_5 + b3_14 + J4_22;
  const T b3_16 = b3_13 * T(0.3);
  const T J3_22 = b3_15 + T(0.17225000000000001) + b3_9 + b3_16;
  const T b3_17 = J4_23 * E4_11 - J4_21 * minus_E4_13 - T(0.0182);
  const T J3_23 = b3_17 - T(0.1) * h4_2 - b3_8 * T(0.2);
  const T J3_31 = b3_12 - T(0.3) * hc4_3 - b3_13 * T(0.1);
  const T b3_18 = T(0.2) * hc4_3;
  const T J3_32 = b3_17 - b3_18 - b3_6 * T(0.1);
  const T J3_33 = (E4_11 * J4_33 - minus_E4_13 * J4_13) * E4_11 - (E4_11 * J4_31 - minus_E4_13 * J4_11) * minus_E4_13
      + b3_7 + b3_14 + T(0.169) + b3_16;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc3_2 = E3_22 * h3_2 - E3_23 * h3_3;
  const T hc3_3 = E3_22 * h3_3 + E3_23 * h3_2;
  // B_thetadot16_3 = E4^T B_thetadot16_4
  const T B_thetadot16_3_1 = E4_11 * B_thetadot16_4_1 + minus_E4_13 * B_thetadot16_5_3;
  const T B_thetadot16_3_3 = E4_11 * B_thetadot16_5_3 - minus_E4_13 * B_thetadot16_4_1;
  // K_thetadot16_3 = q4~ E4^T B_thetadot16_4 + E4^T K_thetadot16_4
  const T K_thetadot16_3_1 = T(0.2) * B_thetadot16_3_3 - b4_20 + E4_11 * K_thetadot16_4_1 + minus_E4_13 *
      K_thetadot16_4_3;
  const T b3_19 = T(0.1) * B_thetadot16_3_1;
  const T K_thetadot16_3_2 = b3_19 - T(0.3) * B_thetadot16_3_3 + K_thetadot16_4_2;
  const T K_thetadot16_3_3 = b4_21 - T(0.2) * B_thetadot16_3_1 + E4_11 * K_thetadot16_4_3 - minus_E4_13 *
      K_thetadot16_4_1;
  // B_thetadot15_3 = E4^T B_thetadot15_4
  const T B_thetadot15_3_1 = E4_11 * B_thetadot15_4_1 + minus_E4_13 * B_thetadot15_5_3;
  const T B_thetadot15_3_3 = E4_11 * B_thetadot15_5_3 - minus_E4_13 * B_thetadot15_4_1;
  // K_thetadot15_3 = q4~ E4^T B_thetadot15_4 + E4^T K_thetadot15_4
  const T K_thetadot15_3_1 = T(0.2) * B_thetadot15_3_3 - b4_22 + E4_11 * K_thetadot15_4_1 + minus_E4_13 *
      K_thetadot15_4_3;
  const T b3_20 = T(0.1) * B_thetadot15_3_1;
  const T K_thetadot15_3_2 = b3_20 - T(0.3) * B_thetadot15_3_3 + K_thetadot15_4_2;
  const T K_thetadot15_3_3 = b4_23 - T(0.2) * B_thetadot15_3_1 + E4_11 * K_thetadot15_4_3 - minus_E4_13 *
      K_thetadot15_4_1;
  // B_thetadot14_3 = E4^T B_thetadot14_4
  const T B_thetadot14_3_1 = E4_11 * B_thetadot14_4_1 + minus_E4_13 * B_thetadot14_5_3;
  const T B_thetadot14_3_3 = E4_11 * B_thetadot14_5_3 - minus_E4_13 * B_thetadot14_4_1;
  // K_thetadot14_3 = q4~ E4^T B_thetadot14_4 + E4^T K_thetadot14_4
  const T K_thetadot14_3_1 = T(0.2) * B_thetadot14_3_3 - b4_24 + E4_11 * K_thetadot14_4_1 + minus_E4_13 *
      K_thetadot14_4_3;
  const T b3_21 = T(0.1) * B_thetadot14_3_1;
  const T K_thetadot14_3_2 = b3_21 - T(0.3) * B_thetadot14_3_3 + K_thetadot14_4_2;
  const T K_thetadot14_3_3 = b4_25 - T(0.2) * B_thetadot14_3_1 + E4_11 * K_thetadot14_4_3 - minus_E4_13 *
      K_thetadot14_4_1;
  // B_thetadot13_3 = E4^T B_thetadot13_4
  const T B_thetadot13_3_1 = E4_11 * B_thetadot13_4_1 + minus_E4_13 * B_thetadot13_5_3;
  const T B_thetadot13_3_3 = E4_11 * B_thetadot13_5_3 - minus_E4_13 * B_thetadot13_4_1;
  // K_thetadot13_3 = q4~ E4^T B_thetadot13_4 + E4^T K_thetadot13_4
  const T K_thetadot13_3_1 = T(0.2) * B_thetadot13_3_3 - b4_26 + E4_11 * K_thetadot13_4_1 + minus_E4_13 *
      K_thetadot13_4_3;
  const T b3_22 = T(0.1) * B_thetadot13_3_1;
  const T K_thetadot13_3_2 = b3_22 - T(0.3) * B_thetadot13_3_3 + K_thetadot13_4_2;
  const T K_thetadot13_3_3 = b4_27 - T(0.2) * B_thetadot13_3_1 + E4_11 * K_thetadot13_4_3 - minus_E4_13 *
      K_thetadot13_4_1;
  // B_thetadot12_3 = E4^T B_thetadot12_4
  const T B_thetadot12_3_1 = E4_11 * B_thetadot12_4_1 + minus_E4_13 * B_thetadot12_5_3;
  const T B_thetadot12_3_3 = E4_11 * B_thetadot12_5_3 - minus_E4_13 * B_thetadot12_4_1;
  // K_thetadot12_3 = q4~ E4^T B_thetadot12_4 + E4^T K_thetadot12_4
  const T K_thetadot12_3_1 = T(0.2) * B_thetadot12_3_3 - b4_28 + E4_11 * K_thetadot12_4_1 + minus_E4_13 *
      K_thetadot12_4_3;
  const T b3_23 = T(0.1) * B_thetadot12_3_1;
  const T K_thetadot12_3_2 = b3_23 - T(0.3) * B_thetadot12_3_3 + K_thetadot12_4_2;
  const T K_thetadot12_3_3 = b4_29 - T(0.2) * B_thetadot12_3_1 + E4_11 * K_thetadot12_4_3 - minus_E4_13 *
      K_thetadot12_4_1;
  // B_thetadot11_3 = E4^T B_thetadot11_4
  const T B_thetadot11_3_1 = E4_11 * B_thetadot11_4_1 + minus_E4_13 * B_thetadot11_5_3;
  const T B_thetadot11_3_3 = E4_11 * B_thetadot11_5_3 - minus_E4_13 * B_thetadot11_4_1;
  // K_thetadot11_3 = q4~ E4^T B_thetadot11_4 + E4^T K_thetadot11_4
  const T K_thetadot11_3_1 = T(0.2) * B_thetadot11_3_3 - b4_30 + E4_11 * K_thetadot11_4_1 + minus_E4_13 *
      K_thetadot11_4_3;
  const T b3_24 = T(0.1) * B_thetadot11_3_1;
  const T K_thetadot11_3_2 = b3_24 - T(0.3) * B_thetadot11_3_3 + K_thetadot11_4_2;
  const T K_thetadot11_3_3 = b4_31 - T(0.2) * B_thetadot11_3_1 + E4_11 * K_thetadot11_4_3 - minus_E4_13 *
      K_thetadot11_4_1;
  // B_thetadot10_3 = E4^T B_thetadot10_4
  const T B_thetadot10_3_1 = E4_11 * B_thetadot10_4_1 + minus_E4_13 * B_thetadot10_5_3;
  const T B_thetadot10_3_3 = E4_11 * B_thetadot10_5_3 - minus_E4_13 * B_thetadot10_4_1;
  // K_thetadot10_3 = q4~ E4^T B_thetadot10_4 + E4^T K_thetadot10_4
  const T K_thetadot10_3_1 = T(0.2) * B_thetadot10_3_3 - b4_32 + E4_11 * K_thetadot10_4_1 + minus_E4_13 *
      K_thetadot10_4_3;
  const T b3_25 = T(0.1) * B_thetadot10_3_1;
  const T K_thetadot10_3_2 = b3_25 - T(0.3) * B_thetadot10_3_3 + K_thetadot10_4_2;
  const T K_thetadot10_3_3 = b4_33 - T(0.2) * B_thetadot10_3_1 + E4_11 * K_thetadot10_4_3 - minus_E4_13 *
      K_thetadot10_4_1;
  // B_thetadot9_3 = E4^T B_thetadot9_4
  const T B_thetadot9_3_1 = E4_11 * B_thetadot9_4_1 + minus_E4_13 * B_thetadot9_5_3;
  const T B_thetadot9_3_3 = E4_11 * B_thetadot9_5_3 - minus_E4_13 * B_thetadot9_4_1;
  // K_thetadot9_3 = q4~ E4^T B_thetadot9_4 + E4^T K_thetadot9_4
  const T K_thetadot9_3_1 = T(0.2) * B_thetadot9_3_3 - b4_34 + E4_11 * K_thetadot9_4_1 + minus_E4_13 *
      K_thetadot9_4_3;
  const T b3_26 = T(0.1) * B_thetadot9_3_1;
  const T K_thetadot9_3_2 = b3_26 - T(0.3) * B_thetadot9_3_3 + K_thetadot9_4_2;
  const T K_thetadot9_3_3 = b4_35 - T(0.2) * B_thetadot9_3_1 + E4_11 * K_thetadot9_4_3 - minus_E4_13 *
      K_thetadot9_4_1;
  // B_thetadot8_3 = E4^T B_thetadot8_4
  const T B_thetadot8_3_1 = minus_E4_13 * B_thetadot8_5_3 - E4_11 * minus_B_thetadot8_4_1;
  const T B_thetadot8_3_3 = minus_E4_13 * minus_B_thetadot8_4_1 + E4_11 * B_thetadot8_5_3;
  // K_thetadot8_3 = q4~ E4^T B_thetadot8_4 + E4^T K_thetadot8_4
  const T K_thetadot8_3_1 = T(0.2) * B_thetadot8_3_3 - b4_36 + E4_11 * K_thetadot8_4_1 + minus_E4_13 *
      K_thetadot8_4_3;
  const T b3_27 = T(0.1) * B_thetadot8_3_1;
  const T K_thetadot8_3_2 = b3_27 - T(0.3) * B_thetadot8_3_3 + K_thetadot8_4_2;
  const T K_thetadot8_3_3 = b4_37 - T(0.2) * B_thetadot8_3_1 + E4_11 * K_thetadot8_4_3 - minus_E4_13 *
      K_thetadot8_4_1;
  // B_thetadot7_3 = E4^T B_thetadot7_4
  const T B_thetadot7_3_1 = E4_11 * B_thetadot7_4_1 - minus_E4_13 * minus_B_thetadot7_5_3;
  const T minus_B_thetadot7_3_3 = minus_E4_13 * B_thetadot7_4_1 + E4_11 * minus_B_thetadot7_5_3;
  // K_thetadot7_3 = q4~ E4^T B_thetadot7_4 + E4^T K_thetadot7_4
  const T K_thetadot7_3_1 = E4_11 * K_thetadot7_4_1 + minus_E4_13 * K_thetadot7_4_3 - b4_38 - T(0.2) *
      minus_B_thetadot7_3_3;
  const T b3_28 = T(0.1) * B_thetadot7_3_1;
  const T K_thetadot7_3_2 = b3_28 + T(0.3) * minus_B_thetadot7_3_3 + K_thetadot7_4_2;
  const T K_thetadot7_3_3 = b4_39 - T(0.2) * B_thetadot7_3_1 + E4_11 * K_thetadot7_4_3 - minus_E4_13 *
      K_thetadot7_4_1;
  // B_thetadot6_3 = E4^T B_thetadot6_4
  const T B_thetadot6_3_1 = E4_11 * B_thetadot6_4_1 + minus_E4_13 * hc6_2;
  const T B_thetadot6_3_3 = E4_11 * hc6_2 - minus_E4_13 * B_thetadot6_4_1;
  // K_thetadot6_3 = q4~ E4^T B_thetadot6_4 + E4^T K_thetadot6_4
  const T K_thetadot6_3_1 = b4_40 + T(0.2) * B_thetadot6_3_3 + E4_11 * K_thetadot6_4_1 + minus_E4_13 *
      K_thetadot6_4_3;
  const T b3_29 = T(0.1) * B_thetadot6_3_1;
  const T K_thetadot6_3_2 = b3_29 - T(0.3) * B_thetadot6_3_3 + K_thetadot6_4_2;
  const T K_thetadot6_3_3 = E4_11 * K_thetadot6_4_3 - minus_E4_13 * K_thetadot6_4_1 - b4_41 - T(0.2) *
      B_thetadot6_3_1;
  // B_thetadot5_3 = E4^T B_thetadot5_4
  const T minus_B_thetadot5_3_1 = E4_11 * hc5_2;
  const T B_thetadot5_3_3 = minus_E4_13 * hc5_2;
  // K_thetadot5_3 = q4~ E4^T B_thetadot5_4 + E4^T K_thetadot5_4
  const T K_thetadot5_3_1 = T(0.2) * B_thetadot5_3_3 - b4_12 + E4_11 * b4_13 + minus_E4_13 * b4_19;
  const T b3_30 = T(0.1) * minus_B_thetadot5_3_1;
  const T K_thetadot5_3_2 = b4_18 - b3_30 - T(0.3) * B_thetadot5_3_3;
  const T K_thetadot5_3_3 = b4_15 + T(0.2) * minus_B_thetadot5_3_1 + E4_11 * b4_19 - minus_E4_13 * b4_13;
  // K_thetadot4_3 = q4~ E4^T B_thetadot4_4 + E4^T K_thetadot4_4
  const T K_thetadot4_3_3 = E4_11 * J4_32 - minus_E4_13 * J4_12 - b3_18;
  // D_thetaddot3: pivots of L D L^T
  const T b3_31 = K_thetadot16_3_1 * T(2.9027576197387517);
  const T b3_32 = K_thetadot15_3_1 + b3_31 * b15_11;
  const T b3_33 = b3_32 * b14_19;
  const T b3_34 = K_thetadot14_3_1 - b3_31 * K_thetadot16_14_3 - b3_33 * b14_18;
  const T b3_35 = b3_34 * b13_28;
  const T b3_36 = K_thetadot13_3_1 - b3_31 * K_thetadot16_13_2 - b3_33 * b13_25 - b3_35 * b13_27;
  const T b3_37 = b3_36 * b12_28;
  const T b3_38 = K_thetadot12_3_1 - b3_31 * K_thetadot16_12_1 - b3_33 * b12_23 - b3_35 * b12_25 - b3_37 * b12_27;
  const T b3_39 = b3_38 * b11_28;
  const T b3_40 = K_thetadot11_3_1 - b3_31 * K_thetadot16_11_3 - b3_33 * b11_21 - b3_35 * b11_23 - b3_37 * b11_25 -
      b3_39 * b11_27;
  const T b3_41 = b3_40 * b10_40;
  const T b3_42 = K_thetadot10_3_1 - b3_31 * K_thetadot16_10_2 - b3_33 * b10_31 - b3_35 * b10_33 - b3_37 * b10_35 -
      b3_39 * b10_37 - b3_41 * b10_39;
  const T b3_43 = b3_42 * b9_37;
  const T b3_44 = K_thetadot9_3_1 - b3_31 * K_thetadot16_9_1 - b3_33 * b9_26 - b3_35 * b9_28 - b3_37 * b9_30 - b3_39 *
      b9_32 - b3_41 * b9_34 - b3_43 * b9_36;
  const T b3_45 = b3_44 * b8_37;
  const T b3_46 = K_thetadot8_3_1 - b3_31 * K_thetadot16_8_3 - b3_33 * b8_24 - b3_35 * b8_26 - b3_37 * b8_28 - b3_39 *
      b8_30 - b3_41 * b8_32 - b3_43 * b8_34 - b3_45 * b8_36;
  const T b3_47 = b3_46 * b7_52;
  const T b3_48 = K_thetadot7_3_1 - b3_31 * K_thetadot16_7_2 - b3_33 * b7_37 - b3_35 * b7_39 - b3_37 * b7_41 - b3_39 *
      b7_43 - b3_41 * b7_45 - b3_43 * b7_47 - b3_45 * b7_49 - b3_47 * b7_51;
  const T b3_49 = b3_48 * b6_47;
  const T b3_50 = K_thetadot6_3_1 - b3_31 * K_thetadot16_6_1 - b3_33 * b6_30 - b3_35 * b6_32 - b3_37 * b6_34 - b3_39 *
      b6_36 - b3_41 * b6_38 - b3_43 * b6_40 - b3_45 * b6_42 - b3_47 * b6_44 - b3_49 * b6_46;
  const T b3_51 = b3_50 * b5_48;
  const T b3_52 = K_thetadot5_3_1 - b3_31 * K_thetadot16_5_3 - b3_33 * b5_29 - b3_35 * b5_31 - b3_37 * b5_33 - b3_39 *
      b5_35 - b3_41 * b5_37 - b3_43 * b5_39 - b3_45 * b5_41 - b3_47 * b5_43 - b3_49 * b5_45 - b3_51 * b5_47;
  const T b3_53 = b3_52 * b4_64;
  const T b3_54 = b3_11 - b3_31 * K_thetadot16_4_2 - b3_33 * b4_43 - b3_35 * b4_45 - b3_37 * b4_47 - b3_39 * b4_49 -
      b3_41 * b4_51 - b3_43 * b4_53 - b3_45 * b4_55 - b3_47 * b4_57 - b3_49 * b4_59 - b3_51 * b4_61 - b3_53 * b4_63;
  const T b3_55 = T(1) / D_thetaddot4;
  const T b3_56 = b3_54 * b3_55;
  const T D_thetaddot3 = J3_11 - b3_31 * K_thetadot16_3_1 - b3_33 * b3_32 - b3_35 * b3_34 - b3_37 * b3_36 - b3_39 *
      b3_38 - b3_41 * b3_40 - b3_43 * b3_42 - b3_45 * b3_44 - b3_47 * b3_46 - b3_49 * b3_48 - b3_51 * b3_50 - b3_53 *
      b3_52 - b3_56 * b3_54;

  // ---- body 2 (body_2) and what it carries
  // S2 = E3^T S3 + G2: sum of the force balances of the subtree, body axes [N]
  const T S2_1 = S3_1 - minus_G2_1;
  const T b2_1 = E3_22 * S3_2 - E3_23 * S3_3;
  const T S2_2 = b2_1 - minus_G2_2;
  const T b2_2 = E3_23 * S3_2 + E3_22 * S3_3;
  const T S2_3 = b2_2 - minus_G2_3;
  // rho2 = q3~ E3^T S3 + E3^T rho3 + r2~ G2 + N2: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho2_1 = T(0.15) * b2_2 - T(0.1) * b2_1 + rho3_1 + T(0.05) * minus_G2_2 - T(0.2) * minus_G2_3 - minus_N2_1;
  const T rho2_2 = T(0.1) * S3_1 - T(0.3) * b2_2 + E3_22 * rho3_2 - E3_23 * rho3_3 + T(0.1) * minus_G2_3 - T(0.05) *
      minus_G2_1 - minus_N2_2;
  const T rho2_3 = T(0.3) * b2_1 - T(0.15) * S3_1 + E3_23 * rho3_2 + E3_22 * rho3_3 + T(0.2) * minus_G2_1 - T(0.1) *
      minus_G2_2 - minus_N2_3;
  // h2 = m2 r2 + m_sub3 q3 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h2_1 = T(8.31) + h3_1;
  const T h2_2 = T(4.335) + hc3_2;
  const T h2_3 = T(2.79) + hc3_3;
  // J2 = -q3~ hc3~ + E3^T J3 E3 - m2 r2~ r2~ + I2 + (-m_sub3 q3~ - hc3~) q3~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b2_3 = T(0.1) * hc3_3;
  const T b2_4 = T(0.15) * hc3_2;
  const T b2_5 = b2_3 + b2_4 + J3_11;
  const T b2_6 = hc3_3 + T(2.73);
  const T b2_7 = b2_6 * T(0.1);
  const T b2_8 = T(4.095) + hc3_2;
  const T b2_9 = b2_8 * T(0.15);
  const T J2_11 = b2_5 + T(0.171) + b2_7 + b2_9;
  const T b2_10 = J3_12 * E3_22 - J3_13 * E3_23 - T(0.018000000000000002);
  const T J2_12 = b2_10 - T(0.15) * h3_1 - b2_8 * T(0.3);
  const T J2_13 = J3_12 * E3_23 + J3_13 * E3_22 - T(0.1) * h3_1 - T(0.0024000000000000007) - b2_6 * T(0.3);
  const T b2_11 = T(0.3) * hc3_2;
  const T b2_12 = h3_1 + T(8.19);
  const T J2_21 = b2_10 - b2_11 - b2_12 * T(0.15);
  const T b2_13 = E3_22 * J3_22 - E3_23 * J3_32;
  const T b2_14 = E3_22 * J3_23 - E3_23 * J3_33;
  const T b2_15 = T(0.3) * h3_1 + b2_12 * T(0.3);
  const T J2_22 = b2_13 * E3_22 - b2_14 * E3_23 + b2_3 + b2_15 + T(0.159) + b2_7;
  const T J2_23 = b2_13 * E3_23 + b2_14 * E3_22 - T(0.1) * hc3_2 - T(0.0168) - b2_6 * T(0.15);
  const T J2_33 = (E3_23 * J3_22 + E3_22 * J3_32) * E3_23 + (E3_23 * J3_23 + E3_22 * J3_33) * E3_22 + b2_4 + b2_15 +
      T(0.156) + b2_9;
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_1 = E2_11 * h2_1 - E2_12 * h2_2;
  const T hc2_2 = E2_11 * h2_2 + E2_12 * h2_1;
  // B_thetadot16_2 = E3^T B_thetadot16_3
  const T B_thetadot16_2_2 = E3_22 * B_thetadot16_4_2 - E3_23 * B_thetadot16_3_3;
  const T B_thetadot16_2_3 = E3_23 * B_thetadot16_4_2 + E3_22 * B_thetadot16_3_3;
  // K_thetadot16_2 = q3~ E3^T B_thetadot16_3 + E3^T K_thetadot16_3
  const T K_thetadot16_2_1 = T(0.15) * B_thetadot16_2_3 - T(0.1) * B_thetadot16_2_2 + K_thetadot16_3_1;
  const T b2_16 = T(0.3) * B_thetadot16_2_3;
  const T K_thetadot16_2_2 = b3_19 - b2_16 + E3_22 * K_thetadot16_3_2 - E3_23 * K_thetadot16_3_3;
  const T K_thetadot16_2_3 = T(0.3) * B_thetadot16_2_2 - T(0.15) * B_thetadot16_3_1 + E3_23 * K_thetadot16_3_2 + E3_22
      * K_thetadot16_3_3;
  // B_thetadot15_2 = E3^T B_thetadot15_3
  const T B_thetadot15_2_2 = E3_22 * B_thetadot15_4_2 - E3_23 * B_thetadot15_3_3;
  const T B_thetadot15_2_3 = E3_23 * B_thetadot15_4_2 + E3_22 * B_thetadot15_3_3;
  // K_thetadot15_2 = q3~ E3^T B_thetadot15_3 + E3^T K_thetadot15_3
  const T K_thetadot15_2_1 = T(0.15) * B_thetadot15_2_3 - T(0.1) * B_thetadot15_2_2 + K_thetadot15_3_1;
  const T b2_17 = T(0.3) * B_thetadot15_2_3;
  const T K_thetadot15_2_2 = b3_20 - b2_17 + E3_22 * K_thetadot15_3_2 - E3_23 * K_thetadot15_3_3;
  const T K_thetadot15_2_3 = T(0.3) * B_thetadot15_2_2 - T(0.15) * B_thetadot15_3_1 + E3_23 * K_thetadot15_3_2 + E3_22
      * K_thetadot15_3_3;
  // B_thetadot14_2 = E3^T B_thetadot14_3
  const T B_thetadot14_2_2 = E3_22 * B_thetadot14_4_2 - E3_23 * B_thetadot14_3_3;
  const T B_thetadot14_2_3 = E3_23 * B_thetadot14_4_2 + E3_22 * B_thetadot14_3_3;
  // K_thetadot14_2 = q3~ E3^T B_thetadot14_3 + E3^T K_thetadot14_3
  const T K_thetadot14_2_1 = T(0.15) * B_thetadot14_2_3 - T(0.1) * B_thetadot14_2_2 + K_thetadot14_3_1;
  const T b2_18 = T(0.3) * B_thetadot14_2_3;
  const T K_thetadot14_2_2 = b3_21 - b2_18 + E3_22 * K_thetadot14_3_2 - E3_23 * K_thetadot14_3_3;
  const T K_thetadot14_2_3 = T(0.3) * B_thetadot14_2_2 - T(0.15) * B_thetadot14_3_1 + E3_23 * K_thetadot14_3_2 + E3_22
      * K_thetadot14_3_3;
  // B_thetadot13_2 = E3^T B_thetadot13_3
  const T B_thetadot13_2_2 = E3_22 * B_thetadot13_4_2 - E3_23 * B_thetadot13_3_3;
  const T B_thetadot13_2_3 = E3_23 * B_thetadot13_4_2 + E3_22 * B_thetadot13_3_3;
  // K_thetadot13_2 = q3~ E3^T B_thetadot13_3 + E3^T K_thetadot13_3
  const T K_thetadot13_2_1 = T(0.15) * B_thetadot13_2_3 - T(0.1) * B_thetadot13_2_2 + K_thetadot13_3_1;
  const T b2_19 = T(0.3) * B_thetadot13_2_3;
  const T K_thetadot13_2_2 = b3_22 - b2_19 + E3_22 * K_thetadot13_3_2 - E3_23 * K_thetadot13_3_3;
  const T K_thetadot13_2_3 = T(0.3) * B_thetadot13_2_2 - T(0.15) * B_thetadot13_3_1 + E3_23 * K_thetadot13_3_2 + E3_22
      * K_thetadot13_3_3;
  // B_thetadot12_2 = E3^T B_thetadot12_3
  const T B_thetadot12_2_2 = E3_22 * B_thetadot12_4_2 - E3_23 * B_thetadot12_3_3;
  const T B_thetadot12_2_3 = E3_23 * B_thetadot12_4_2 + E3_22 * B_thetadot12_3_3;
  // K_thetadot12_2 = q3~ E3^T B_thetadot12_3 + E3^T K_thetadot12_3
  const T K_thetadot12_2_1 = T(0.15) * B_thetadot12_2_3 - T(0.1) * B_thetadot12_2_2 + K_thetadot12_3_1;
  const T b2_20 = T(0.3) * B_thetadot12_2_3;
  const T K_thetadot12_2_2 = b3_23 - b2_20 + E3_22 * K_thetadot12_3_2 - E3_23 * K_thetadot12_3_3;
  const T K_thetadot12_2_3 = T(0.3) * B_thetadot12_2_2 - T(0.15) * B_thetadot12_3_1 + E3_23 * K_thetadot12_3_2 + E3_22
      * K_thetadot12_3_3;
  // B_thetadot11_2 = E3^T B_thetadot11_3
  const T B_thetadot11_2_2 = E3_22 * B_thetadot11_4_2 - E3_23 * B_thetadot11_3_3;
  const T B_thetadot11_2_3 = E3_23 * B_thetadot11_4_2 + E3_22 * B_thetadot11_3_3;
  // K_thetadot11_2 = q3~ E3^T B_thetadot11_3 + E3^T K_thetadot11_3
  const T K_thetadot11_2_1 = T(0.15) * B_thetadot11_2_3 - T(0.1) * B_thetadot11_2_2 + K_thetadot11_3_1;
  const T b2_21 = T(0.3) * B_thetadot11_2_3;
  const T K_thetadot11_2_2 = b3_24 - b2_21 + E3_22 * K_thetadot11_3_2 - E3_23 * K_thetadot11_3_3;
  const T K_thetadot11_2_3 = T(0.3) * B_thetadot11_2_2 - T(0.15) * B_thetadot11_3_1 + E3_23 * K_thetadot11_3_2 + E3_22
      * K_thetadot11_3_3;
  // B_thetadot10_2 = E3^T B_thetadot10_3
  const T B_thetadot10_2_2 = E3_22 * B_thetadot10_4_2 - E3_23 * B_thetadot10_3_3;
  const T B_thetadot10_2_3 = E3_23 * B_thetadot10_4_2 + E3_22 * B_thetadot10_3_3;
  // K_thetadot10_2 = q3~ E3^T B_thetadot10_3 + E3^T K_thetadot10_3
  const T K_thetadot10_2_1 = T(0.15) * B_thetadot10_2_3 - T(0.1) * B_thetadot10_2_2 + K_thetadot10_3_1;
  const T b2_22 = T(0.3) * B_thetadot10_2_3;
  const T K_thetadot10_2_2 = b3_25 - b2_22 + E3_22 * K_thetadot10_3_2 - E3_23 * K_thetadot10_3_3;
  const T K_thetadot10_2_3 = T(0.3) * B_thetadot10_2_2 - T(0.15) * B_thetadot10_3_1 + E3_23 * K_thetadot10_3_2 + E3_22
      * K_thetadot10_3_3;
  // B_thetadot9_2 = E3^T B_thetadot9_3
  const T B_thetadot9_2_2 = E3_22 * B_thetadot9_4_2 - E3_23 * B_thetadot9_3_3;
  const T B_thetadot9_2_3 = E3_23 * B_thetadot9_4_2 + E3_22 * B_thetadot9_3_3;
  // K_thetadot9_2 = q3~ E3^T B_thetadot9_3 + E3^T K_thetadot9_3
  const T K_thetadot9_2_1 = T(0.15) * B_thetadot9_2_3 - T(0.1) * B_thetadot9_2_2 + K_thetadot9_3_1;
  const T b2_23 = T(0.3) * B_thetadot9_2_3;
  const T K_thetadot9_2_2 = b3_26 - b2_23 + E3_22 * K_thetadot9_3_2 - E3_23 * K_thetadot9_3_3;
  const T K_thetadot9_2_3 = T(0.3) * B_thetadot9_2_2 - T(0.15) * B_thetadot9_3_1 + E3_23 * K_thetadot9_3_2 + E3_22 *
      K_thetadot9_3_3;
  // B_thetadot8_2 = E3^T B_thetadot8_3
  const T B_thetadot8_2_2 = E3_22 * B_thetadot8_4_2 - E3_23 * B_thetadot8_3_3;
  const T B_thetadot8_2_3 = E3_23 * B_thetadot8_4_2 + E3_22 * B_thetadot8_3_3;
  // K_thetadot8_2 = q3~ E3^T B_thetadot8_3 + E3^T K_thetadot8_3
  const T K_thetadot8_2_1 = T(0.15) * B_thetadot8_2_3 - T(0.1) * B_thetadot8_2_2 + K_thetadot8_3_1;
  const T b2_24 = T(0.3) * B_thetadot8_2_3;
  const T K_thetadot8_2_2 = b3_27 - b2_24 + E3_22 * K_thetadot8_3_2 - E3_23 * K_thetadot8_3_3;
  const T K_thetadot8_2_3 = T(0.3) * B_thetadot8_2_2 - T(0.15) * B_thetadot8_3_1 + E3_23 * K_thetadot8_3_2 + E3_22 *
      K_thetadot8_3_3;
  // B_thetadot7_2 = E3^T B_thetadot7_3
  const T B_thetadot7_2_2 = E3_22 * B_thetadot7_4_2 + E3_23 * minus_B_thetadot7_3_3;
  const T B_thetadot7_2_3 = E3_23 * B_thetadot7_4_2 - E3_22 * minus_B_thetadot7_3_3;
  // K_thetadot7_2 = q3~ E3^T B_thetadot7_3 + E3^T K_thetadot7_3
  const T K_thetadot7_2_1 = T(0.15) * B_thetadot7_2_3 - T(0.1) * B_thetadot7_2_2 + K_thetadot7_3_1;
  const T b2_25 = T(0.3) * B_thetadot7_2_3;
  const T K_thetadot7_2_2 = b3_28 - b2_25 + E3_22 * K_thetadot7_3_2 - E3_23 * K_thetadot7_3_3;
  const T K_thetadot7_2_3 = T(0.3) * B_thetadot7_2_2 - T(0.15) * B_thetadot7_3_1 + E3_23 * K_thetadot7_3_2 + E3_22 *
      K_thetadot7_3_3;
  // B_thetadot6_2 = E3^T B_thetadot6_3
  const T minus_B_thetadot6_2_2 = E3_22 * minus_B_thetadot6_4_2 + E3_23 * B_thetadot6_3_3;
  const T B_thetadot6_2_3 = E3_22 * B_thetadot6_3_3 - E3_23 * minus_B_thetadot6_4_2;
  // K_thetadot6_2 = q3~ E3^T B_thetadot6_3 + E3^T K_thetadot6_3
  const T K_thetadot6_2_1 = T(0.1) * minus_B_thetadot6_2_2 + T(0.15) * B_thetadot6_2_3 + K_thetadot6_3_1;
  const T b2_26 = T(0.3) * B_thetadot6_2_3;
  const T K_thetadot6_2_2 = b3_29 - b2_26 + E3_22 * K_thetadot6_3_2 - E3_23 * K_thetadot6_3_3;
  const T K_thetadot6_2_3 = E3_23 * K_thetadot6_3_2 + E3_22 * K_thetadot6_3_3 - T(0.3) * minus_B_thetadot6_2_2 -
      T(0.15) * B_thetadot6_3_1;
  // B_thetadot5_2 = E3^T B_thetadot5_3
  const T B_thetadot5_2_2 = E3_22 * hc5_1 - E3_23 * B_thetadot5_3_3;
  const T B_thetadot5_2_3 = E3_23 * hc5_1 + E3_22 * B_thetadot5_3_3;
  // K_thetadot5_2 = q3~ E3^T B_thetadot5_3 + E3^T K_thetadot5_3
  const T K_thetadot5_2_1 = T(0.15) * B_thetadot5_2_3 - T(0.1) * B_thetadot5_2_2 + K_thetadot5_3_1;
  const T b2_27 = T(0.3) * B_thetadot5_2_3;
  const T K_thetadot5_2_2 = E3_22 * K_thetadot5_3_2 - E3_23 * K_thetadot5_3_3 - b3_30 - b2_27;
  const T K_thetadot5_2_3 = T(0.3) * B_thetadot5_2_2 + T(0.15) * minus_B_thetadot5_3_1 + E3_23 * K_thetadot5_3_2 +
      E3_22 * K_thetadot5_3_3;
  // B_thetadot4_2 = E3^T B_thetadot4_3
  const T B_thetadot4_2_2 = E3_23 * hc4_1;
  const T minus_B_thetadot4_2_3 = E3_22 * hc4_1;
  // K_thetadot4_2 = q3~ E3^T B_thetadot4_3 + E3^T K_thetadot4_3
  const T K_thetadot4_2_1 = b3_11 - T(0.1) * B_thetadot4_2_2 - T(0.15) * minus_B_thetadot4_2_3;
  const T b2_28 = T(0.3) * minus_B_thetadot4_2_3;
  const T K_thetadot4_2_2 = b3_5 + b2_28 + E3_22 * b3_15 - E3_23 * K_thetadot4_3_3;
  const T K_thetadot4_2_3 = T(0.3) * B_thetadot4_2_2 - T(0.15) * hc4_3 + E3_23 * b3_15 + E3_22 * K_thetadot4_3_3;
  // K_thetadot3_2 = q3~ E3^T B_thetadot3_3 + E3^T K_thetadot3_3
  const T K_thetadot3_2_2 = E3_22 * J3_21 - E3_23 * J3_31 - b2_11;
  const T K_thetadot3_2_3 = E3_23 * J3_21 + E3_22 * J3_31 - T(0.3) * hc3_3;
  // D_thetaddot2: pivots of L D L^T
  const T b2_29 = K_thetadot16_2_3 * T(2.9027576197387517);
  const T b2_30 = K_thetadot15_2_3 + b2_29 * b15_11;
  const T b2_31 = b2_30 * b14_19;
  const T b2_32 = K_thetadot14_2_3 - b2_29 * K_thetadot16_14_3 - b2_31 * b14_18;
  const T b2_33 = b2_32 * b13_28;
  const T b2_34 = K_thetadot13_2_3 - b2_29 * K_thetadot16_13_2 - b2_31 * b13_25 - b2_33 * b13_27;
  const T b2_35 = b2_34 * b12_28;
  const T b2_36 = K_thetadot12_2_3 - b2_29 * K_thetadot16_12_1 - b2_31 * b12_23 - b2_33 * b12_25 - b2_35 * b12_27;
  const T b2_37 = b2_36 * b11_28;
  const T b2_38 = K_thetadot11_2_3 - b2_29 * K_thetadot16_11_3 - b2_31 * b11_21 - b2_33 * b11_23 - b2_35 * b11_25 -
      b2_37 * b11_27;
  const T b2_39 = b2_38 * b10_40;
  const T b2_40 = K_thetadot10_2_3 - b2_29 * K_thetadot16_10_2 - b2_31 * b10_31 - b2_33 * b10_33 - b2_35 * b10_35 -
      b2_37 * b10_37 - b2_39 * b10_39;
  const T b2_41 = b2_40 * b9_37;
  const T b2_42 = K_thetadot9_2_3 - b2_29 * K_thetadot16_9_1 - b2_31 * b9_26 - b2_33 * b9_28 - b2_35 * b9_30 - b2_37 *
      b9_32 - b2_39 * b9_34 - b2_41 * b9_36;
  const T b2_43 = b2_42 * b8_37;
  const T b2_44 = K_thetadot8_2_3 - b2_29 * K_thetadot16_8_3 - b2_31 * b8_24 - b2_33 * b8_26 - b2_35 * b8_28 - b2_37 *
      b8_30 - b2_39 * b8_32 - b2_41 * b8_34 - b2_43 * b8_36;
  const T b2_45 = b2_44 * b7_52;
  const T b2_46 = K_thetadot7_2_3 - b2_29 * K_thetadot16_7_2 - b2_31 * b7_37 - b2_33 * b7_39 - b2_35 * b7_41 - b2_37 *
      b7_43 - b2_39 * b7_45 - b2_41 * b7_47 - b2_43 * b7_49 - b2_45 * b7_51;
  const T b2_47 = b2_46 * b6_47;
  const T b2_48 = K_thetadot6_2_3 - b2_29 * K_thetadot16_6_1 - b2_31 * b6_30 - b2_33 * b6_32 - b2_35 * b6_34 - b2_37 *
      b6_36 - b2_39 * b6_38 - b2_41 * b6_40 - b2_43 * b6_42 - b2_45 * b6_44 - b2_47 * b6_46;
  const T b2_49 = b2_48 * b5_48;
  const T b2_50 = K_thetadot5_2_3 - b2_29 * K_thetadot16_5_3 - b2_31 * b5_29 - b2_33 * b5_31 - b2_35 * b5_33 - b2_37 *
      b5_35 - b2_39 * b5_37 - b2_41 * b5_39 - b2_43 * b5_41 - b2_45 * b5_43 - b2_47 * b5_45 - b2_49 * b5_47;
  const T b2_51 = b2_50 * b4_64;
  const T b2_52 = K_thetadot4_2_3 - b2_29 * K_thetadot16_4_2 - b2_31 * b4_43 - b2_33 * b4_45 - b2_35 * b4_47 - b2_37 *
      b4_49 - b2_39 * b4_51 - b2_41 * b4_53 - b2_43 * b4_55 - b2_45 * b4_57 - b2_47 * b4_59 - b2_49 * b4_61 - b2_51 *
      b4_63;
  const T b2_53 = b2_52 * b3_55;
  const T b2_54 = K_thetadot3_2_3 - b2_29 * K_thetadot16_3_1 - b2_31 * b3_32 - b2_33 * b3_34 - b2_35 * b3_36 - b2_37 *
      b3_38 - b2_39 * b3_40 - b2_41 * b3_42 - b2_43 * b3_44 - b2_45 * b3_46 - b2_47 * b3_48 - b2_49 * b3_50 - b2_51 *
      b3_52 - b2_53 * b3_54;
  const T b2_55 = T(1) / D_thetaddot3;
  const T b2_56 = b2_54 * b2_55;
  const T D_thetaddot2 = J2_33 - b2_29 * K_thetadot16_2_3 - b2_31 * b2_30 - b2_33 * b2_32 - b2_35 * b2_34 - b2_37 *
      b2_36 - b2_39 * b2_38 - b2_41 * b2_40 - b2_43 * b2_42 - b2_45 * b2_44 - b2_47 * b2_46 - b2_49 * b2_48 - b2_51 *
      b2_50 - b2_53 * b2_52 - b2_56 * b2_54;

  // ---- body 1 (body_1) and what it carries
  // rho1 = q2~ E2^T S2 + E2^T rho2 + r1~ G1 + N1: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho1_2 = T(0.1) * (E2_11 * S2_1 - E2_12 * S2_2) - T(0.3) * S2_3 + E2_12 * rho2_1 + E2_11 * rho2_2 + T(0.05)
      * G1_1 + T(0.1) * minus_G1_3;
  // J1 = -q2~ hc2~ + E2^T J2 E2 - m1 r1~ r1~ + I1 + (-m_sub2 q2~ - hc2~) q2~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T J1_22 = (E2_12 * J2_11 + E2_11 * J2_21) * E2_12 + (E2_12 * J2_12 + E2_11 * J2_22) * E2_11 + T(0.1) * h2_3 +
      T(0.3) * hc2_1 + T(0.14575000000000002) + (h2_3 + T(2.85)) * T(0.1) + (hc2_1 + T(8.549999999999999)) * T(0.3);
  // K_thetadot16_1 = q2~ E2^T B_thetadot16_2 + E2^T K_thetadot16_2
  const T K_thetadot16_1_2 = T(0.1) * (E2_11 * B_thetadot16_3_1 - E2_12 * B_thetadot16_2_2) - b2_16 + E2_12 *
      K_thetadot16_2_1 + E2_11 * K_thetadot16_2_2;
  // K_thetadot15_1 = q2~ E2^T B_thetadot15_2 + E2^T K_thetadot15_2
  const T K_thetadot15_1_2 = T(0.1) * (E2_11 * B_thetadot15_3_1 - E2_12 * B_thetadot15_2_2) - b2_17 + E2_12 *
      K_thetadot15_2_1 + E2_11 * K_thetadot15_2_2;
  // K_thetadot14_1 = q2~ E2^T B_thetadot14_2 + E2^T K_thetadot14_2
  const T K_thetadot14_1_2 = T(0.1) * (E2_11 * B_thetadot14_3_1 - E2_12 * B_thetadot14_2_2) - b2_18 + E2_12 *
      K_thetadot14_2_1 + E2_11 * K_thetadot14_2_2;
  // K_thetadot13_1 = q2~ E2^T B_thetadot13_2 + E2^T K_thetadot13_2
  const T K_thetadot13_1_2 = T(0.1) * (E2_11 * B_thetadot13_3_1 - E2_12 * B_thetadot13_2_2) - b2_19 + E2_12 *
      K_thetadot13_2_1 + E2_11 * K_thetadot13_2_2;
  // K_thetadot12_1 = q2~ E2^T B_thetadot12_2 + E2^T K_thetadot12_2
  const T K_thetadot12_1_2 = T(0.1) * (E2_11 * B_thetadot12_3_1 - E2_12 * B_thetadot12_2_2) - b2_20 + E2_12 *
      K_thetadot12_2_1 + E2_11 * K_thetadot12_2_2;
  // K_thetadot11_1 = q2~ E2^T B_thetadot11_2 + E2^T K_thetadot11_2
  const T K_thetadot11_1_2 = T(0.1) * (E2_11 * B_thetadot11_3_1 - E2_12 * B_thetadot11_2_2) - b2_21 + E2_12 *
      K_thetadot11_2_1 + E2_11 * K_thetadot11_2_2;
  // K_thetadot10_1 = q2~ E2^T B_thetadot10_2 + E2^T K_thetadot10_2
  const T K_thetadot10_1_2 = T(0.1) * (E2_11 * B_thetadot10_3_1 - E2_12 * B_thetadot10_2_2) - b2_22 + E2_12 *
      K_thetadot10_2_1 + E2_11 * K_thetadot10_2_2;
  // K_thetadot9_1 = q2~ E2^T B_thetadot9_2 + E2^T K_thetadot9_2
  const T K_thetadot9_1_2 = T(0.1) * (E2_11 * B_thetadot9_3_1 - E2_12 * B_thetadot9_2_2) - b2_23 + E2_12 *
      K_thetadot9_2_1 + E2_11 * K_thetadot9_2_2;
  // K_thetadot8_1 = q2~ E2^T B_thetadot8_2 + E2^T K_thetadot8_2
  const T K_thetadot8_1_2 = T(0.1) * (E2_11 * B_thetadot8_3_1 - E2_12 * B_thetadot8_2_2) - b2_24 + E2_12 *
      K_thetadot8_2_1 + E2_11 * K_thetadot8_2_2;
  // K_thetadot7_1 = q2~ E2^T B_thetadot7_2 + E2^T K_thetadot7_2
  const T K_thetadot7_1_2 = T(0.1) * (E2_11 * B_thetadot7_3_1 - E2_12 * B_thetadot7_2_2) - b2_25 + E2_12 *
      K_thetadot7_2_1 + E2_11 * K_thetadot7_2_2;
  // K_thetadot6_1 = q2~ E2^T B_thetadot6_2 + E2^T K_thetadot6_2
  const T K_thetadot6_1_2 = T(0.1) * (E2_11 * B_thetadot6_3_1 + E2_12 * minus_B_thetadot6_2_2) - b2_26 + E2_12 *
      K_thetadot6_2_1 + E2_11 * K_thetadot6_2_2;
  // K_thetadot5_1 = q2~ E2^T B_thetadot5_2 + E2^T K_thetadot5_2
  const T K_thetadot5_1_2 = E2_12 * K_thetadot5_2_1 + E2_11 * K_thetadot5_2_2 - T(0.1) * (E2_11 *
      minus_B_thetadot5_3_1 + E2_12 * B_thetadot5_2_2) - b2_27;
  // K_thetadot4_1 = q2~ E2^T B_thetadot4_2 + E2^T K_thetadot4_2
  const T K_thetadot4_1_2 = T(0.1) * (E2_11 * hc4_3 - E2_12 * B_thetadot4_2_2) + b2_28 + E2_12 * K_thetadot4_2_1 +
      E2_11 * K_thetadot4_2_2;
  // K_thetadot3_1 = q2~ E2^T B_thetadot3_2 + E2^T K_thetadot3_2
  const T K_thetadot3_1_2 = E2_12 * hc3_3 * T(0.1) - b2_11 + E2_12 * b2_5 + E2_11 * K_thetadot3_2_2;
  // K_thetadot2_1 = q2~ E2^T B_thetadot2_2 + E2^T K_thetadot2_2
  const T K_thetadot2_1_2 = E2_12 * J2_13 + E2_11 * J2_23 - T(0.1) * hc2_2;
  // D_thetaddot1: pivots of L D L^T
  const T b1_1 = K_thetadot16_1_2 * T(2.9027576197387517);
  const T b1_2 = K_thetadot15_1_2 + b1_1 * b15_11;
  const T b1_3 = b1_2 * b14_19;
  const T b1_4 = K_thetadot14_1_2 - b1_1 * K_thetadot16_14_3 - b1_3 * b14_18;
  const T b1_5 = b1_4 * b13_28;
  const T b1_6 = K_thetadot13_1_2 - b1_1 * K_thetadot16_13_2 - b1_3 * b13_25 - b1_5 * b13_27;
  const T b1_7 = b1_6 * b12_28;
  const T b1_8 = K_thetadot12_1_2 - b1_1 * K_thetadot16_12_1 - b1_3 * b12_23 - b1_5 * b12_25 - b1_7 * b12_27;
  const T b1_9 = b1_8 * b11_28;
  const T b1_10 = K_thetadot11_1_2 - b1_1 * K_thetadot16_11_3 - b1_3 * b11_21 - b1_5 * b11_23 - b1_7 * b11_25 - b1_9 *
      b11_27;
  const T b1_11 = b1_10 * b10_40;
  const T b1_12 = K_thetadot10_1_2 - b1_1 * K_thetadot16_10_2 - b1_3 * b10_31 - b1_5 * b10_33 - b1_7 * b10_35 - b1_9 *
      b10_37 - b1_11 * b10_39;
  const T b1_13 = b1_12 * b9_37;
  const T b1_14 = K_thetadot9_1_2 - b1_1 * K_thetadot16_9_1 - b1_3 * b9_26 - b1_5 * b9_28 - b1_7 * b9_30 - b1_9 *
      b9_32 - b1_11 * b9_34 - b1_13 * b9_36;
  const T b1_15 = b1_14 * b8_37;
  const T b1_16 = K_thetadot8_1_2 - b1_1 * K_thetadot16_8_3 - b1_3 * b8_24 - b1_5 * b8_26 - b1_7 * b8_28 - b1_9 *
      b8_30 - b1_11 * b8_32 - b1_13 * b8_34 - b1_15 * b8_36;
  const T b1_17 = b1_16 * b7_52;
  const T b1_18 = K_thetadot7_1_2 - b1_1 * K_thetadot16_7_2 - b1_3 * b7_37 - b1_5 * b7_39 - b1_7 * b7_41 - b1_9 *
      b7_43 - b1_11 * b7_45 - b1_13 * b7_47 - b1_15 * b7_49 - b1_17 * b7_51;
  const T b1_19 = b1_18 * b6_47;
  const T b1_20 = K_thetadot6_1_2 - b1_1 * K_thetadot16_6_1 - b1_3 * b6_30 - b1_5 * b6_32 - b1_7 * b6_34 - b1_9 *
      b6_36 - b1_11 * b6_38 - b1_13 * b6_40 - b1_15 * b6_42 - b1_17 * b6_44 - b1_19 * b6_46;
  const T b1_21 = b1_20 * b5_48;
  const T b1_22 = K_thetadot5_1_2 - b1_1 * K_thetadot16_5_3 - b1_3 * b5_29 - b1_5 * b5_31 - b1_7 * b5_33 - b1_9 *
      b5_35 - b1_11 * b5_37 - b1_13 * b5_39 - b1_15 * b5_41 - b1_17 * b5_43 - b1_19 * b5_45 - b1_21 * b5_47;
  const T b1_23 = b1_22 * b4_64;
  const T b1_24 = K_thetadot4_1_2 - b1_1 * K_thetadot16_4_2 - b1_3 * b4_43 - b1_5 * b4_45 - b1_7 * b4_47 - b1_9 *
      b4_49 - b1_11 * b4_51 - b1_13 * b4_53 - b1_15 * b4_55 - b1_17 * b4_57 - b1_19 * b4_59 - b1_21 * b4_61 - b1_23 *
      b4_63;
  const T b1_25 = b1_24 * b3_55;
  const T b1_26 = K_thetadot3_1_2 - b1_1 * K_thetadot16_3_1 - b1_3 * b3_32 - b1_5 * b3_34 - b1_7 * b3_36 - b1_9 *
      b3_38 - b1_11 * b3_40 - b1_13 * b3_42 - b1_15 * b3_44 - b1_17 * b3_46 - b1_19 * b3_48 - b1_21 * b3_50 - b1_23 *
      b3_52 - b1_25 * b3_54;
  const T b1_27 = b1_26 * b2_55;
  const T b1_28 = K_thetadot2_1_2 - b1_1 * K_thetadot16_2_3 - b1_3 * b2_30 - b1_5 * b2_32 - b1_7 * b2_34 - b1_9 *
      b2_36 - b1_11 * b2_38 - b1_13 * b2_40 - b1_15 * b2_42 - b1_17 * b2_44 - b1_19 * b2_46 - b1_21 * b2_48 - b1_23 *
      b2_50 - b1_25 * b2_52 - b1_27 * b2_54;
  const T b1_29 = T(1) / D_thetaddot2;
  const T b1_30 = b1_28 * b1_29;
  const T D_thetaddot1 = J1_22 - b1_1 * K_thetadot16_1_2 - b1_3 * b1_2 - b1_5 * b1_4 - b1_7 * b1_6 - b1_9 * b1_8 -
      b1_11 * b1_10 - b1_13 * b1_12 - b1_15 * b1_14 - b1_17 * b1_16 - b1_19 * b1_18 - b1_21 * b1_20 - b1_23 * b1_22 -
      b1_25 * b1_24 - b1_27 * b1_26 - b1_30 * b1_28;

  // ---- body 1 (body_1), solved
  // thetaddot1: from A ydot = f by elimination
  const T z1_1 = rho16_2 + u.tau_16;
  const T z1_2 = rho15_1 + u.tau_15 + b15_19 * z1_1;
  const T z1_3 = rho14_3 + u.tau_14 - b14_17 * z1_1 - b14_20 * z1_2;
  const T z1_4 = rho13_2 + u.tau_13 - b13_24 * z1_1 - b13_26 * z1_2 - b13_29 * z1_3;
  const T z1_5 = rho12_1 + u.tau_12 - b12_22 * z1_1 - b12_24 * z1_2 - b12_26 * z1_3 - b12_29 * z1_4;
  const T z1_6 = rho11_3 + u.tau_11 - b11_20 * z1_1 - b11_22 * z1_2 - b11_24 * z1_3 - b11_26 * z1_4 - b11_29 * z1_5;
  const T z1_7 = rho10_2 + u.tau_10 - b10_30 * z1_1 - b10_32 * z1_2 - b10_34 * z1_3 - b10_36 * z1_4 - b10_38 * z1_5 -
      b10_41 * z1_6;
  const T z1_8 = rho9_1 + u.tau_9 - b9_25 * z1_1 - b9_27 * z1_2 - b9_29 * z1_3 - b9_31 * z1_4 - b9_33 * z1_5 - b9_35 *
      z1_6 - b9_38 * z1_7;
  const T z1_9 = rho8_3 + u.tau_8 - b8_23 * z1_1 - b8_25 * z1_2 - b8_27 * z1_3 - b8_29 * z1_4 - b8_31 * z1_5 - b8_33 *
      z1_6 - b8_35 * z1_7 - b8_38 * z1_8;
  const T z1_10 = rho7_2 + u.tau_7 - b7_36 * z1_1 - b7_38 * z1_2 - b7_40 * z1_3 - b7_42 * z1_4 - b7_44 * z1_5 - b7_46
      * z1_6 - b7_48 * z1_7 - b7_50 * z1_8 - b7_53 * z1_9;
  const T z1_11 = rho6_1 + u.tau_6 - b6_29 * z1_1 - b6_31 * z1_2 - b6_33 * z1_3 - b6_35 * z1_4 - b6_37 * z1_5 - b6_39
      * z1_6 - b6_41 * z1_7 - b6_43 * z1_8 - b6_45 * z1_9 - b6_48 * z1_10;
  const T z1_12 = rho5_3 + u.tau_5 - b5_28 * z1_1 - b5_30 * z1_2 - b5_32 * z1_3 - b5_34 * z1_4 - b5_36 * z1_5 - b5_38
      * z1_6 - b5_40 * z1_7 - b5_42 * z1_8 - b5_44 * z1_9 - b5_46 * z1_10 - b5_49 * z1_11;
  const T z1_13 = rho4_2 + u.tau_4 - b4_42 * z1_1 - b4_44 * z1_2 - b4_46 * z1_3 - b4_48 * z1_4 - b4_50 * z1_5 - b4_52
      * z1_6 - b4_54 * z1_7 - b4_56 * z1_8 - b4_58 * z1_9 - b4_60 * z1_10 - b4_62 * z1_11 - b4_65 * z1_12;
  const T z1_14 = rho3_1 + u.tau_3 - b3_31 * z1_1 - b3_33 * z1_2 - b3_35 * z1_3 - b3_37 * z1_4 - b3_39 * z1_5 - b3_41
      * z1_6 - b3_43 * z1_7 - b3_45 * z1_8 - b3_47 * z1_9 - b3_49 * z1_10 - b3_51 * z1_11 - b3_53 * z1_12 - b3_56 *
      z1_13;
  const T z1_15 = rho2_3 + u.tau_2 - b2_29 * z1_1 - b2_31 * z1_2 - b2_33 * z1_3 - b2_35 * z1_4 - b2_37 * z1_5 - b2_39
      * z1_6 - b2_41 * z1_7 - b2_43 * z1_8 - b2_45 * z1_9 - b2_47 * z1_10 - b2_49 * z1_11 - b2_51 * z1_12 - b2_53 *
      z1_13 - b2_56 * z1_14;
  const T thetaddot1 = T(1) / D_thetaddot1 * (rho1_2 + u.tau_1 - b1_1 * z1_1 - b1_3 * z1_2 - b1_5 * z1_3 - b1_7 * z1_4
      - b1_9 * z1_5 - b1_11 * z1_6 - b1_13 * z1_7 - b1_15 * z1_8 - b1_17 * z1_9 - b1_19 * z1_10 - b1_21 * z1_11 -
      b1_23 * z1_12 - b1_25 * z1_13 - b1_27 * z1_14 - b1_30 * z1_15);
  ydot[0] = thetaddot1;

  // ---- body 2 (body_2), solved
  // thetaddot2: from A ydot = f by elimination
  const T thetaddot2 = z1_15 * b1_29 - b1_30 * thetaddot1;
  ydot[1] = thetaddot2;

  // ---- body 3 (body_3), solved
  // thetaddot3: from A ydot = f by elimination
  const T thetaddot3 = z1_14 * b2_55 - b2_56 * thetaddot2 - b1_27 * thetaddot1;
  ydot[2] = thetaddot3;

  // ---- body 4 (body_4), solved
  // thetaddot4: from A ydot = f by elimination
  const T thetaddot4 = z1_13 * b3_55 - b3_56 * thetaddot3 - b2_53 * thetaddot2 - b1_25 * thetaddot1;
  ydot[3] = thetaddot4;

  // ---- body 5 (body_5), solved
  // thetaddot5: from A ydot = f by elimination
  const T thetaddot5 = z1_12 * b4_64 - b4_65 * thetaddot4 - b3_53 * thetaddot3 - b2_51 * thetaddot2 - b1_23 *
      thetaddot1;
  ydot[4] = thetaddot5;

  // ---- body 6 (body_6), solved
  // thetaddot6: from A ydot = f by elimination
  const T thetaddot6 = z1_11 * b5_48 - b5_49 * thetaddot5 - b4_62 * thetaddot4 - b3_51 * thetaddot3 - b2_49 *
      thetaddot2 - b1_21 * thetaddot1;
  ydot[5] = thetaddot6;

  // ---- body 7 (body_7), solved
  // thetaddot7: from A ydot = f by elimination
  const T thetaddot7 = z1_10 * b6_47 - b6_48 * thetaddot6 - b5_46 * thetaddot5 - b4_60 * thetaddot4 - b3_49 *
      thetaddot3 - b2_47 * thetaddot2 - b1_19 * thetaddot1;
  ydot[6] = thetaddot7;

  // ---- body 8 (body_8), solved
  // thetaddot8: from A ydot = f by elimination
  const T thetaddot8 = z1_9 * b7_52 - b7_53 * thetaddot7 - b6_45 * thetaddot6 - b5_44 * thetaddot5 - b4_58 *
      thetaddot4 - b3_47 * thetaddot3 - b2_45 * thetaddot2 - b1_17 * thetaddot1;
  ydot[7] = thetaddot8;

  // ---- body 9 (body_9), solved
  // thetaddot9: from A ydot = f by elimination
  const T thetaddot9 = z1_8 * b8_37 - b8_38 * thetaddot8 - b7_50 * thetaddot7 - b6_43 * thetaddot6 - b5_42 *
      thetaddot5 - b4_56 * thetaddot4 - b3_45 * thetaddot3 - b2_43 * thetaddot2 - b1_15 * thetaddot1;
  ydot[8] = thetaddot9;

  // ---- body 10 (body_10), solved
  // thetaddot10: from A ydot = f by elimination
  const T thetaddot10 = z1_7 * b9_37 - b9_38 * thetaddot9 - b8_35 * thetaddot8 - b7_48 * thetaddot7 - b6_41 *
      thetaddot6 - b5_40 * thetaddot5 - b4_54 * thetaddot4 - b3_43 * thetaddot3 - b2_41 * thetaddot2 - b1_13 *
      thetaddot1;
  ydot[9] = thetaddot10;

  // ---- body 11 (body_11), solved
  // thetaddot11: from A ydot = f by elimination
  const T thetaddot11 = z1_6 * b10_40 - b10_41 * thetaddot10 - b9_35 * thetaddot9 - b8_33 * thetaddot8 - b7_46 *
      thetaddot7 - b6_39 * thetaddot6 - b5_38 * thetaddot5 - b4_52 * thetaddot4 - b3_41 * thetaddot3 - b2_39 *
      thetaddot2 - b1_11 * thetaddot1;
  ydot[10] = thetaddot11;

  // ---- body 12 (body_12), solved
  // thetaddot12: from A ydot = f by elimination
  const T thetaddot12 = z1_5 * b11_28 - b11_29 * thetaddot11 - b10_38 * thetaddot10 - b9_33 * thetaddot9 - b8_31 *
      thetaddot8 - b7_44 * thetaddot7 - b6_37 * thetaddot6 - b5_36 * thetaddot5 - b4_50 * thetaddot4 - b3_39 *
      thetaddot3 - b2_37 * thetaddot2 - b1_9 * thetaddot1;
  ydot[11] = thetaddot12;

  // ---- body 13 (body_13), solved
  // thetaddot13: from A ydot = f by elimination
  const T thetaddot13 = z1_4 * b12_28 - b12_29 * thetaddot12 - b11_26 * thetaddot11 - b10_36 * thetaddot10 - b9_31 *
      thetaddot9 - b8_29 * thetaddot8 - b7_42 * thetaddot7 - b6_35 * thetaddot6 - b5_34 * thetaddot5 - b4_48 *
      thetaddot4 - b3_37 * thetaddot3 - b2_35 * thetaddot2 - b1_7 * thetaddot1;
  ydot[12] = thetaddot13;

  // ---- body 14 (body_14), solved
  // thetaddot14: from A ydot = f by elimination
  const T thetaddot14 = z1_3 * b13_28 - b13_29 * thetaddot13 - b12_26 * thetaddot12 - b11_24 * thetaddot11 - b10_34 *
      thetaddot10 - b9_29 * thetaddot9 - b8_27 * thetaddot8 - b7_40 * thetaddot7 - b6_33 * thetaddot6 - b5_32 *
      thetaddot5 - b4_46 * thetaddot4 - b3_35 * thetaddot3 - b2_33 * thetaddot2 - b1_5 * thetaddot1;
  ydot[13] = thetaddot14;

  // ---- body 15 (body_15), solved
  // thetaddot15: from A ydot = f by elimination
  const T thetaddot15 = z1_2 * b14_19 - b14_20 * thetaddot14 - b13_26 * thetaddot13 - b12_24 * thetaddot12 - b11_22 *
      thetaddot11 - b10_32 * thetaddot10 - b9_27 * thetaddot9 - b8_25 * thetaddot8 - b7_38 * thetaddot7 - b6_31 *
      thetaddot6 - b5_30 * thetaddot5 - b4_44 * thetaddot4 - b3_33 * thetaddot3 - b2_31 * thetaddot2 - b1_3 *
      thetaddot1;
  ydot[14] = thetaddot15;

  // ---- body 16 (body_16), solved
  // thetaddot16: from A ydot = f by elimination
  const T thetaddot16 = z1_1 * T(2.9027576197387517) + b15_19 * thetaddot15 - b14_17 * thetaddot14 - b13_24 *
      thetaddot13 - b12_22 * thetaddot12 - b11_20 * thetaddot11 - b10_30 * thetaddot10 - b9_25 * thetaddot9 - b8_23 *
      thetaddot8 - b7_36 * thetaddot7 - b6_29 * thetaddot6 - b5_28 * thetaddot5 - b4_42 * thetaddot4 - b3_31 *
      thetaddot3 - b2_29 * thetaddot2 - b1_1 * thetaddot1;
  ydot[15] = thetaddot16;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 1105 add, 1124 multiply, 32 sine or cosine
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r)
    noexcept {
  using std::cos, std::sin;

  // ---- body 1 (body_1) on the inertial frame
  const T theta1 = x[0];
  const T thetadot1 = y[0];
  const T thetaddot1 = ydot[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U1_11 = thetadot1 * thetadot1;
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  const T Pddot1_3 = E1_11 * T(9.81);
  // a1 = U1 r1 + Pddot1: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T t1_1 = minus_U1_11 * T(0.1);
  const T a1_1 = thetaddot1 * T(0.05) - t1_1 - minus_Pddot1_1;
  const T t1_2 = thetaddot1 * T(0.1);
  const T a1_3 = Pddot1_3 - t1_2 - minus_U1_11 * T(0.05);
  // G1 = m1 a1: force balance, body axes [N]
  const T G1_1 = T(1.1) * a1_1;
  const T G1_3 = T(1.1) * a1_3;
  // N1 = axial(U1 (tr(I1)/2 - I1)): moment balance about the mass centre, body axes [N m]
  const T N1_2 = T(0.132) * thetaddot1;

  // ---- body 2 (body_2) on body 1
  const T theta2 = x[1];
  const T thetadot2 = y[1];
  const T thetaddot2 = ydot[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T E2_12 = sin(theta2);
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = E2_12 * thetadot1;
  const T omega2_2 = E2_11 * thetadot1;
  // omegadot2 = -thetadot2 b2~ E2 omega1 + thetaddot2 b2 + E2 omegadot1: angular acceleration, body axes [rad/s^2]
  const T t2_1 = thetadot2 * omega2_2;
  const T omegadot2_1 = t2_1 + E2_12 * thetaddot1;
  const T t2_2 = thetadot2 * omega2_1;
  const T omegadot2_2 = E2_11 * thetaddot1 - t2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_3 = thetadot2 * thetadot2;
  const T t2_4 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_3 + t2_4;
  const T t2_5 = omega2_2 * omega2_1;
  const T U2_12 = t2_5 - thetaddot2;
  const T U2_13 = t2_2 + omegadot2_2;
  const T U2_21 = t2_5 + thetaddot2;
  const T t2_6 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_3 + t2_6;
  const T U2_23 = t2_1 - omegadot2_1;
  const T U2_31 = t2_2 - omegadot2_2;
  const T U2_32 = t2_1 + omegadot2_1;
  const T minus_U2_33 = t2_4 + t2_6;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_7 = t1_2 - minus_U1_11 * T(0.3) - minus_Pddot1_1;
  const T Pddot2_1 = E2_11 * t2_7;
  const T minus_Pddot2_2 = E2_12 * t2_7;
  const T Pddot2_3 = Pddot1_3 - thetaddot1 * T(0.3) - t1_1;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a2_1 = U2_12 * T(0.2) - minus_U2_11 * T(0.1) + U2_13 * T(0.05) + Pddot2_1;
  const T a2_2 = U2_21 * T(0.1) - minus_U2_22 * T(0.2) + U2_23 * T(0.05) - minus_Pddot2_2;
  const T a2_3 = U2_31 * T(0.1) + U2_32 * T(0.2) - minus_U2_33 * T(0.05) + Pddot2_3;
  // G2 = m2 a2: force balance, body axes [N]
  const T G2_1 = T(1.2) * a2_1;
  const T G2_2 = T(1.2) * a2_2;
  const T G2_3 = T(1.2) * a2_3;
  // N2 = axial(U2 (tr(I2)/2 - I2)): moment balance about the mass centre, body axes [N m]
  const T N2_1 = T(0.036000000000000004) * U2_32 - T(0.08399999999999999) * U2_23 + T(0.0048) * (minus_U2_22 -
      minus_U2_33) - T(0.006) * U2_31 + T(0.0036) * U2_21;
  const T N2_2 = T(0.08399999999999999) * U2_13 - T(0.06) * U2_31 - T(0.0036) * (minus_U2_33 - minus_U2_11) +
      T(0.0048) * U2_12 + T(0.006) * U2_32;
  const T N2_3 = T(0.06) * U2_21 - T(0.036000000000000004) * U2_12 - T(0.006) * (minus_U2_11 - minus_U2_22) -
      T(0.0036) * U2_23 - T(0.0048) * U2_13;

  // ---- body 3 (body_3) on body 2
  const T theta3 = x[2];
  const T thetadot3 = y[2];
  const T thetaddot3 = ydot[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega2_1;
  const T omega3_2 = E3_22 * omega2_2 + E3_23 * thetadot2;
  const T omega3_3 = E3_22 * thetadot2 - E3_23 * omega2_2;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + thetaddot3 b3 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = thetaddot3 + omegadot2_1;
  const T omegadot3_2 = thetadot3 * omega3_3 + E3_22 * omegadot2_2 + E3_23 * thetaddot2;
  const T omegadot3_3 = E3_22 * thetaddot2 - E3_23 * omegadot2_2 - thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_3 * omega3_3;
  const T t3_2 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_1 + t3_2;
  const T t3_3 = omega3_2 * omega3_1;
  const T U3_12 = t3_3 - omegadot3_3;
  const T t3_4 = omega3_3 * omega3_1;
  const T U3_13 = t3_4 + omegadot3_2;
  const T U3_21 = t3_3 + omegadot3_3;
  const T t3_5 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_1 + t3_5;
  const T t3_6 = omega3_3 * omega3_2;
  const T U3_23 = t3_6 - omegadot3_1;
  const T U3_31 = t3_4 - omegadot3_2;
  const T U3_32 = t3_6 + omegadot3_1;
  const T minus_U3_33 = t3_2 + t3_5;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot3_1 = U2_12 * T(0.15) - minus_U2_11 * T(0.3) + U2_13 * T(0.1) + Pddot2_1;
  const T t3_7 = U2_21 * T(0.3) - minus_U2_22 * T(0.15) + U2_23 * T(0.1) - minus_Pddot2_2;
  const T t3_8 = U2_31 * T(0.3) + U2_32 * T(0.15) - minus_U2_33 * T(0.1) + Pddot2_3;
  const T Pddot3_2 = E3_22 * t3_7 + E3_23 * t3_8;
  const T Pddot3_3 = E3_22 * t3_8 - E3_23 * t3_7;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T t3_9 = U3_12 * T(0.2) + Pddot3_1;
  const T a3_1 = t3_9 - minus_U3_11 * T(0.1) + U3_13 * T(0.05);
  const T t3_10 = minus_U3_22 * T(0.2) - Pddot3_2;
  const T a3_2 = U3_21 * T(0.1) - t3_10 + U3_23 * T(0.05);
  const T t3_11 = U3_32 * T(0.2) + Pddot3_3;
  const T a3_3 = U3_31 * T(0.1) + t3_11 - minus_U3_33 * T(0.05);
  // G3 = m3 a3: force balance, body axes [N]
  const T G3_1 = T(1.3) * a3_1;
  const T G3_2 = T(1.3) * a3_2;
  const T G3_3 = T(1.3) * a3_3;
  // N3 = axial(U3 (tr(I3)/2 - I3)): moment balance about the mass centre, body axes [N m]
  const T N3_1 = T(0.039) * U3_32 - T(0.091) * U3_23 + T(0.0052) * (minus_U3_22 - minus_U3_33) - T(0.0065) * U3_31 +
      T(0.0039) * U3_21;
  const T N3_2 = T(0.091) * U3_13 - T(0.065) * U3_31 - T(0.0039) * (minus_U3_33 - minus_U3_11) + T(0.0052) * U3_12 +
      T(0.0065) * U3_32;
  const T N3_3 = T(0.065) * U3_21 - T(0.039) * U3_12 - T(0.0065) * (minus_U3_11 - minus_U3_22) - T(0.0039) * U3_23 -
      T(0.0052) * U3_13;

  // ---- body 4 (body_4) on body 3
  const T theta4 = x[3];
  const T thetadot4 = y[3];
  const T thetaddot4 = ydot[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cos(theta4);
  const T minus_E4_13 = sin(theta4);
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 - minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  const T omega4_3 = minus_E4_13 * omega3_1 + E4_11 * omega3_3;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + thetaddot4 b4 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = E4_11 * omegadot3_1 - minus_E4_13 * omegadot3_3 - thetadot4 * omega4_3;
  const T omegadot4_2 = thetaddot4 + omegadot3_2;
  const T omegadot4_3 = thetadot4 * omega4_1 + minus_E4_13 * omegadot3_1 + E4_11 * omegadot3_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_1 = omega4_3 * omega4_3;
  const T t4_2 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_1 + t4_2;
  const T t4_3 = omega4_2 * omega4_1;
  const T U4_12 = t4_3 - omegadot4_3;
  const T t4_4 = omega4_3 * omega4_1;
  const T U4_13 = t4_4 + omegadot4_2;
  const T U4_21 = t4_3 + omegadot4_3;
  const T t4_5 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_1 + t4_5;
  const T t4_6 = omega4_3 * omega4_2;
  const T U4_23 = t4_6 - omegadot4_1;
  const T U4_31 = t4_4 - omegadot4_2;
  const T U4_32 = t4_6 + omegadot4_1;
  const T minus_U4_33 = t4_2 + t4_5;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_7 = t3_9 - minus_U3_11 * T(0.3) + U3_13 * T(0.1);
  const T t4_8 = U3_31 * T(0.3) + t3_11 - minus_U3_33 * T(0.1);
  const T Pddot4_1 = E4_11 * t4_7 - minus_E4_13 * t4_8;
  const T Pddot4_2 = U3_21 * T(0.3) - t3_10 + U3_23 * T(0.1);
  const T Pddot4_3 = minus_E4_13 * t4_7 + E4_11 * t4_8;
  // a4 = U4 r4 + Pddot4: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a4_1 = U4_12 * T(0.2) - minus_U4_11 * T(0.1) + U4_13 * T(0.05) + Pddot4_1;
  const T a4_2 = U4_21 * T(0.1) - minus_U4_22 * T(0.2) + U4_23 * T(0.05) + Pddot4_2;
  const T a4_3 = U4_31 * T(0.1) + U4_32 * T(0.2) - minus_U4_33 * T(0.05) + Pddot4_3;
  // G4 = m4 a4: force balance, body axes [N]
  const T G4_1 = T(1.4) * a4_1;
  const T G4_2 = T(1.4) * a4_2;
  const T G4_3 = T(1.4) * a4_3;
  // N4 = axial(U4 (tr(I4)/2 - I4)): moment balance about the mass centre, body axes [N m]
  const T N4_1 = T(0.042) * U4_32 - T(0.098) * U4_23 + T(0.0056) * (minus_U4_22 - minus_U4_33) - T(0.007) * U4_31 +
      T(0.0042) * U4_21;
  const T N4_2 = T(0.098) * U4_13 - T(0.07) * U4_31 - T(0.0042) * (minus_U4_33 - minus_U4_11) + T(0.0056) * U4_12 +
      T(0.007) * U4_32;
  const T N4_3 = T(0.07) * U4_21 - T(0.042) * U4_12 - T(0.007) * (minus_U4_11 - minus_U4_22) - T(0.0042) * U4_23 -
      T(0.0056) * U4_13;

  // ---- body 5 (body_5) on body 4
  const T theta5 = x[4];
  const T thetadot5 = y[4];
  const T thetaddot5 = ydot[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cos(theta5);
  const T E5_12 = sin(theta5);
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 + E5_12 * omega4_2;
  const T omega5_2 = E5_11 * omega4_2 - E5_12 * omega4_1;
  const T omega5_3 = thetadot5 + omega4_3;
  // omegadot5 = -thetadot5 b5~ E5 omega4 + thetaddot5 b5 + E5 omegadot4: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = thetadot5 * omega5_2 + E5_11 * omegadot4_1 + E5_12 * omegadot4_2;
  const T omegadot5_2 = E5_11 * omegadot4_2 - E5_12 * omegadot4_1 - thetadot5 * omega5_1;
  const T omegadot5_3 = thetaddot5 + omegadot4_3;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_1 = omega5_3 * omega5_3;
  const T t5_2 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_1 + t5_2;
  const T t5_3 = omega5_2 * omega5_1;
  const T U5_12 = t5_3 - omegadot5_3;
  const T t5_4 = omega5_3 * omega5_1;
  const T U5_13 = t5_4 + omegadot5_2;
  const T U5_21 = t5_3 + omegadot5_3;
  const T t5_5 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_1 + t5_5;
  const T t5_6 = omega5_3 * omega5_2;
  const T U5_23 = t5_6 - omegadot5_1;
  const T U5_31 = t5_4 - omegadot5_2;
  const T U5_32 = t5_6 + omegadot5_1;
  const T minus_U5_33 = t5_2 + t5_5;
  // Pddot5 = E5 (U4 q5 + Pddot4): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_7 = U4_12 * T(0.25) - minus_U4_11 * T(0.3) + U4_13 * T(0.1) + Pddot4_1;
  const T t5_8 = U4_21 * T(0.3) - minus_U4_22 * T(0.25) + U4_23 * T(0.1) + Pddot4_2;
  const T Pddot5_1 = E5_11 * t5_7 + E5_12 * t5_8;
  const T Pddot5_2 = E5_11 * t5_8 - E5_12 * t5_7;
  const T Pddot5_3 = U4_31 * T(0.3) + U4_32 * T(0.25) - minus_U4_33 * T(0.1) + Pddot4_3;
  // a5 = U5 r5 + Pddot5: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a5_1 = U5_12 * T(0.2) - minus_U5_11 * T(0.1) + U5_13 * T(0.05) + Pddot5_1;
  const T a5_2 = U5_21 * T(0.1) - minus_U5_22 * T(0.2) + U5_23 * T(0.05) + Pddot5_2;
  const T a5_3 = U5_31 * T(0.1) + U5_32 * T(0.2) - minus_U5_33 * T(0.05) + Pddot5_3;
  // G5 = m5 a5: force balance, body axes [N]
  const T G5_1 = T(1.5) * a5_1;
  const T G5_2 = T(1.5) * a5_2;
  const T G5_3 = T(1.5) * a5_3;
  // N5 = axial(U5 (tr(I5)/2 - I5)): moment balance about the mass centre, body axes [N m]
  const T N5_1 = T(0.045) * U5_32 - T(0.105) * U5_23 + T(0.006) * (minus_U5_22 - minus_U5_33) - T(0.0075) * U5_31 +
      T(0.0045) * U5_21;
  const T N5_2 = T(0.105) * U5_13 - T(0.075) * U5_31 - T(0.0045) * (minus_U5_33 - minus_U5_11) + T(0.006) * U5_12 +
      T(0.0075) * U5_32;
  const T N5_3 = T(0.075) * U5_21 - T(0.045) * U5_12 - T(0.0075) * (minus_U5_11 - minus_U5_22) - T(0.0045) * U5_23 -
      T(0.006) * U5_13;

  // ---- body 6 (body_6) on body 5
  const T theta6 = x[5];
  const T thetadot6 = y[5];
  const T thetaddot6 = ydot[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cos(theta6);
  const T E6_23 = sin(theta6);
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega5_1;
  const T omega6_2 = E6_22 * omega5_2 + E6_23 * omega5_3;
  const T omega6_3 = E6_22 * omega5_3 - E6_23 * omega5_2;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + thetaddot6 b6 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_1 = thetaddot6 + omegadot5_1;
  const T omegadot6_2 = thetadot6 * omega6_3 + E6_22 * omegadot5_2 + E6_23 * omegadot5_3;
  const T omegadot6_3 = E6_22 * omegadot5_3 - E6_23 * omegadot5_2 - thetadot6 * omega6_2;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_3 * omega6_3;
  const T t6_2 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_1 + t6_2;
  const T t6_3 = omega6_2 * omega6_1;
  const T U6_12 = t6_3 - omegadot6_3;
  const T t6_4 = omega6_3 * omega6_1;
  const T U6_13 = t6_4 + omegadot6_2;
  const T U6_21 = t6_3 + omegadot6_3;
  const T t6_5 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_1 + t6_5;
  const T t6_6 = omega6_3 * omega6_2;
  const T U6_23 = t6_6 - omegadot6_1;
  const T U6_31 = t6_4 - omegadot6_2;
  const T U6_32 = t6_6 + omegadot6_1;
  const T minus_U6_33 = t6_2 + t6_5;
  // Pddot6 = E6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = U5_12 * T(0.3) - minus_U5_11 * T(0.3) + U5_13 * T(0.1) + Pddot5_1;
  const T t6_7 = U5_21 * T(0.3) - minus_U5_22 * T(0.3) + U5_23 * T(0.1) + Pddot5_2;
  const T t6_8 = U5_31 * T(0.3) + U5_32 * T(0.3) - minus_U5_33 * T(0.1) + Pddot5_3;
  const T Pddot6_2 = E6_22 * t6_7 + E6_23 * t6_8;
  const T Pddot6_3 = E6_22 * t6_8 - E6_23 * t6_7;
  // a6 = U6 r6 + Pddot6: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a6_1 = U6_12 * T(0.2) - minus_U6_11 * T(0.1) + U6_13 * T(0.05) + Pddot6_1;
  const T a6_2 = U6_21 * T(0.1) - minus_U6_22 * T(0.2) + U6_23 * T(0.05) + Pddot6_2;
  const T a6_3 = U6_31 * T(0.1) + U6_32 * T(0.2) - minus_U6_33 * T(0.05) + Pddot6_3;
  // G6 = m6 a6: force balance, body axes [N]
  const T G6_1 = T(1.6) * a6_1;
  const T G6_2 = T(1.6) * a6_2;
  const T G6_3 = T(1.6) * a6_3;
  // N6 = axial(U6 (tr(I6)/2 - I6)): moment balance about the mass centre, body axes [N m]
  const T N6_1 = T(0.048) * U6_32 - T(0.112) * U6_23 + T(0.0064) * (minus_U6_22 - minus_U6_33) - T(0.008) * U6_31 +
      T(0.0048) * U6_21;
  const T N6_2 = T(0.112) * U6_13 - T(0.08) * U6_31 - T(0.0048) * (minus_U6_33 - minus_U6_11) + T(0.0064) * U6_12 +
      T(0.008) * U6_32;
  const T N6_3 = T(0.08) * U6_21 - T(0.048) * U6_12 - T(0.008) * (minus_U6_11 - minus_U6_22) - T(0.0048) * U6_23 -
      T(0.0064) * U6_13;

  // ---- body 7 (body_7) on body 6
  const T theta7 = x[6];
  const T thetadot7 = y[6];
  const T thetaddot7 = ydot[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cos(theta7);
  const T minus_E7_13 = sin(theta7);
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // omegadot7 = -thetadot7 b7~ E7 omega6 + thetaddot7 b7 + E7 omegadot6: angular acceleration, body axes [rad/s^2]
  const T omegadot7_1 = E7_11 * omegadot6_1 - minus_E7_13 * omegadot6_3 - thetadot7 * omega7_3;
  const T omegadot7_2 = thetaddot7 + omegadot6_2;
  const T omegadot7_3 = thetadot7 * omega7_1 + minus_E7_13 * omegadot6_1 + E7_11 * omegadot6_3;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t7_1 = omega7_3 * omega7_3;
  const T t7_2 = omega7_2 * omega7_2;
  const T minus_U7_11 = t7_1 + t7_2;
  const T t7_3 = omega7_2 * omega7_1;
  const T U7_12 = t7_3 - omegadot7_3;
  const T t7_4 = omega7_3 * omega7_1;
  const T U7_13 = t7_4 + omegadot7_2;
  const T U7_21 = t7_3 + omegadot7_3;
  const T t7_5 = omega7_1 * omega7_1;
  const T minus_U7_22 = t7_1 + t7_5;
  const T t7_6 = omega7_3 * omega7_2;
  const T U7_23 = t7_6 - omegadot7_1;
  const T U7_31 = t7_4 - omegadot7_2;
  const T U7_32 = t7_6 + omegadot7_1;
  const T minus_U7_33 = t7_2 + t7_5;
  // Pddot7 = E7 (U6 q7 + Pddot6): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t7_7 = U6_12 * T(0.35) - minus_U6_11 * T(0.3) + U6_13 * T(0.1) + Pddot6_1;
  const T t7_8 = U6_31 * T(0.3) + U6_32 * T(0.35) - minus_U6_33 * T(0.1) + Pddot6_3;
  const T Pddot7_1 = E7_11 * t7_7 - minus_E7_13 * t7_8;
  const T Pddot7_2 = U6_21 * T(0.3) - minus_U6_22 * T(0.35) + U6_23 * T(0.1) + Pddot6_2;
  const T Pddot7_3 = minus_E7_13 * t7_7 + E7_11 * t7_8;
  // a7 = U7 r7 + Pddot7: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a7_1 = U7_12 * T(0.2) - minus_U7_11 * T(0.1) + U7_13 * T(0.05) + Pddot7_1;
  const T a7_2 = U7_21 * T(0.1) - minus_U7_22 * T(0.2) + U7_23 * T(0.05) + Pddot7_2;
  const T a7_3 = U7_31 * T(0.1) + U7_32 * T(0.2) - minus_U7_33 * T(0.05) + Pddot7_3;
  // G7 = m7 a7: force balance, body axes [N]
  const T G7_1 = T(1.7) * a7_1;
  const T G7_2 = T(1.7) * a7_2;
  const T G7_3 = T(1.7) * a7_3;
  // N7 = axial(U7 (tr(I7)/2 - I7)): moment balance about the mass centre, body axes [N m]
  const T N7_1 = T(0.05100000000000002) * U7_32 - T(0.119) * U7_23 + T(0.0068) * (minus_U7_22 - minus_U7_33) -
      T(0.0085) * U7_31 + T(0.0051) * U7_21;
  const T N7_2 = T(0.119) * U7_13 - T(0.08499999999999999) * U7_31 - T(0.0051) * (minus_U7_33 - minus_U7_11) +
      T(0.0068) * U7_12 + T(0.0085) * U7_32;
  const T N7_3 = T(0.08499999999999999) * U7_21 - T(0.05100000000000002) * U7_12 - T(0.0085) * (minus_U7_11 -
      minus_U7_22) - T(0.0051) * U7_23 - T(0.0068) * U7_13;

  // ---- body 8 (body_8) on body 7
  const T theta8 = x[7];
  const T thetadot8 = y[7];
  const T thetaddot8 = ydot[7];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cos(theta8);
  const T E8_12 = sin(theta8);
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega7_1 + E8_12 * omega7_2;
  const T omega8_2 = E8_11 * omega7_2 - E8_12 * omega7_1;
  const T omega8_3 = thetadot8 + omega7_3;
  // omegadot8 = -thetadot8 b8~ E8 omega7 + thetaddot8 b8 + E8 omegadot7: angular acceleration, body axes [rad/s^2]
  const T omegadot8_1 = thetadot8 * omega8_2 + E8_11 * omegadot7_1 + E8_12 * omegadot7_2;
  const T omegadot8_2 = E8_11 * omegadot7_2 - E8_12 * omegadot7_1 - thetadot8 * omega8_1;
  const T omegadot8_3 = thetaddot8 + omegadot7_3;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_1 = omega8_3 * omega8_3;
  const T t8_2 = omega8_2 * omega8_2;
  const T minus_U8_11 = t8_1 + t8_2;
  const T t8_3 = omega8_2 * omega8_1;
  const T U8_12 = t8_3 - omegadot8_3;
  const T t8_4 = omega8_3 * omega8_1;
  const T U8_13 = t8_4 + omegadot8_2;
  const T U8_21 = t8_3 + omegadot8_3;
  const T t8_5 = omega8_1 * omega8_1;
  const T minus_U8_22 = t8_1 + t8_5;
  const T t8_6 = omega8_3 * omega8_2;
  const T U8_23 = t8_6 - omegadot8_1;
  const T U8_31 = t8_4 - omegadot8_2;
  const T U8_32 = t8_6 + omegadot8_1;
  const T minus_U8_33 = t8_2 + t8_5;
  // Pddot8 = E8 (U7 q8 + Pddot7): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t8_7 = U7_12 * T(0.4) - minus_U7_11 * T(0.3) + U7_13 * T(0.1) + Pddot7_1;
  const T t8_8 = U7_21 * T(0.3) - minus_U7_22 * T(0.4) + U7_23 * T(0.1) + Pddot7_2;
  const T Pddot8_1 = E8_11 * t8_7 + E8_12 * t8_8;
  const T Pddot8_2 = E8_11 * t8_8 - E8_12 * t8_7;
  const T Pddot8_3 = U7_31 * T(0.3) + U7_32 * T(0.4) - minus_U7_33 * T(0.1) + Pddot7_3;
  // a8 = U8 r8 + Pddot8: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a8_1 = U8_12 * T(0.2) - minus_U8_11 * T(0.1) + U8_13 * T(0.05) + Pddot8_1;
  const T a8_2 = U8_21 * T(0.1) - minus_U8_22 * T(0.2) + U8_23 * T(0.05) + Pddot8_2;
  const T a8_3 = U8_31 * T(0.1) + U8_32 * T(0.2) - minus_U8_33 * T(0.05) + Pddot8_3;
  // G8 = m8 a8: force balance, body axes [N]
  const T G8_1 = T(1.8) * a8_1;
  const T G8_2 = T(1.8) * a8_2;
  const T G8_3 = T(1.8) * a8_3;
  // N8 = axial(U8 (tr(I8)/2 - I8)): moment balance about the mass centre, body axes [N m]
  const T N8_1 = T(0.05399999999999999) * U8_32 - T(0.126) * U8_23 + T(0.0072) * (minus_U8_22 - minus_U8_33) -
      T(0.009) * U8_31 + T(0.0054) * U8_21;
  const T N8_2 = T(0.126) * U8_13 - T(0.09) * U8_31 - T(0.0054) * (minus_U8_33 - minus_U8_11) + T(0.0072) * U8_12 +
      T(0.009) * U8_32;
  const T N8_3 = T(0.09) * U8_21 - T(0.05399999999999999) * U8_12 - T(0.009) * (minus_U8_11 - minus_U8_22) - T(0.0054)
      * U8_23 - T(0.0072) * U8_13;

  // ---- body 9 (body_9) on body 8
  const T theta9 = x[8];
  const T thetadot9 = y[8];
  const T thetaddot9 = ydot[8];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_22 = cos(theta9);
  const T E9_23 = sin(theta9);
  // omega9 = thetadot9 b9 + E9 omega8: absolute angular velocity, body axes [rad/s]
  const T omega9_1 = thetadot9 + omega8_1;
  const T omega9_2 = E9_22 * omega8_2 + E9_23 * omega8_3;
  const T omega9_3 = E9_22 * omega8_3 - E9_23 * omega8_2;
  // omegadot9 = -thetadot9 b9~ E9 omega8 + thetaddot9 b9 + E9 omegadot8: angular acceleration, body axes [rad/s^2]
  const T omegadot9_1 = thetaddot9 + omegadot8_1;
  const T omegadot9_2 = thetadot9 * omega9_3 + E9_22 * omegadot8_2 + E9_23 * omegadot8_3;
  const T omegadot9_3 = E9_22 * omegadot8_3 - E9_23 * omegadot8_2 - thetadot9 * omega9_2;
  // U9 = omega9~ omega9~ + omegadot9~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t9_1 = omega9_3 * omega9_3;
  const T t9_2 = omega9_2 * omega9_2;
  const T minus_U9_11 = t9_1 + t9_2;
  const T t9_3 = omega9_2 * omega9_1;
  const T U9_12 = t9_3 - omegadot9_3;
  const T t9_4 = omega9_3 * omega9_1;
  const T U9_13 = t9_4 + omegadot9_2;
  const T U9_21 = t9_3 + omegadot9_3;
  const T t9_5 = omega9_1 * omega9_1;
  const T minus_U9_22 = t9_1 + t9_5;
  const T t9_6 = omega9_3 * omega9_2;
  const T U9_23 = t9_6 - omegadot9_1;
  const T U9_31 = t9_4 - omegadot9_2;
  const T U9_32 = t9_6 + omegadot9_1;
  const T minus_U9_33 = t9_2 + t9_5;
  // Pddot9 = E9 (U8 q9 + Pddot8): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot9_1 = U8_12 * T(0.45) - minus_U8_11 * T(0.3) + U8_13 * T(0.1) + Pddot8_1;
  const T t9_7 = U8_21 * T(0.3) - minus_U8_22 * T(0.45) + U8_23 * T(0.1) + Pddot8_2;
  const T t9_8 = U8_31 * T(0.3) + U8_32 * T(0.45) - minus_U8_33 * T(0.1) + Pddot8_3;
  const T Pddot9_2 = E9_22 * t9_7 + E9_23 * t9_8;
  const T Pddot9_3 = E9_22 * t9_8 - E9_23 * t9_7;
  // a9 = U9 r9 + Pddot9: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a9_1 = U9_12 * T(0.2) - minus_U9_11 * T(0.1) + U9_13 * T(0.05) + Pddot9_1;
  const T a9_2 = U9_21 * T(0.1) - minus_U9_22 * T(0.2) + U9_23 * T(0.05) + Pddot9_2;
  const T a9_3 = U9_31 * T(0.1) + U9_32 * T(0.2) - minus_U9_33 * T(0.05) + Pddot9_3;
  // G9 = m9 a9: force balance, body axes [N]
  const T G9_1 = T(1.9) * a9_1;
  const T G9_2 = T(1.9) * a9_2;
  const T G9_3 = T(1.9) * a9_3;
  // N9 = axial(U9 (tr(I9)/2 - I9)): moment balance about the mass centre, body axes [N m]
  const T N9_1 = T(0.056999999999999995) * U9_32 - T(0.133) * U9_23 + T(0.0076) * (minus_U9_22 - minus_U9_33) -
      T(0.0095) * U9_31 + T(0.0057) * U9_21;
  const T N9_2 = T(0.133) * U9_13 - T(0.095) * U9_31 - T(0.0057) * (minus_U9_33 - minus_U9_11) + T(0.0076) * U9_12 +
      T(0.0095) * U9_32;
  const T N9_3 = T(0.095) * U9_21 - T(0.056999999999999995) * U9_12 - T(0.0095) * (minus_U9_11 - minus_U9_22) -
      T(0.0057) * U9_23 - T(0.0076) * U9_13;

  // ---- body 10 (body_10) on body 9
  const T theta10 = x[9];
  const T thetadot10 = y[9];
  const T thetaddot10 = ydot[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_11 = cos(theta10);
  const T minus_E10_13 = sin(theta10);
  // omega10 = thetadot10 b10 + E10 omega9: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = E10_11 * omega9_1 - minus_E10_13 * omega9_3;
  const T omega10_2 = thetadot10 + omega9_2;
  const T omega10_3 = minus_E10_13 * omega9_1 + E10_11 * omega9_3;
  // omegadot10 = -thetadot10 b10~ E10 omega9 + thetaddot10 b10 + E10 omegadot9: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot10_1 = E10_11 * omegadot9_1 - minus_E10_13 * omegadot9_3 - thetadot10 * omega10_3;
  const T omegadot10_2 = thetaddot10 + omegadot9_2;
  const T omegadot10_3 = thetadot10 * omega10_1 + minus_E10_13 * omegadot9_1 + E10_11 * omegadot9_3;
  // U10 = omega10~ omega10~ + omegadot10~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t10_1 = omega10_3 * omega10_3;
  const T t10_2 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_1 + t10_2;
  const T t10_3 = omega10_2 * omega10_1;
  const T U10_12 = t10_3 - omegadot10_3;
  const T t10_4 = omega10_3 * omega10_1;
  const T U10_13 = t10_4 + omegadot10_2;
  const T U10_21 = t10_3 + omegadot10_3;
  const T t10_5 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_1 + t10_5;
  const T t10_6 = omega10_3 * omega10_2;
  const T U10_23 = t10_6 - omegadot10_1;
  const T U10_31 = t10_4 - omegadot10_2;
  const T U10_32 = t10_6 + omegadot10_1;
  const T minus_U10_33 = t10_2 + t10_5;
  // Pddot10 = E10 (U9 q10 + Pddot9): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t10_7 = U9_12 * T(0.5) - minus_U9_11 * T(0.3) + U9_13 * T(0.1) + Pddot9_1;
  const T t10_8 = U9_31 * T(0.3) + U9_32 * T(0.5) - minus_U9_33 * T(0.1) + Pddot9_3;
  const T Pddot10_1 = E10_11 * t10_7 - minus_E10_13 * t10_8;
  const T Pddot10_2 = U9_21 * T(0.3) - minus_U9_22 * T(0.5) + U9_23 * T(0.1) + Pddot9_2;
  const T Pddot10_3 = minus_E10_13 * t10_7 + E10_11 * t10_8;
  // a10 = U10 r10 + Pddot10: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a10_1 = U10_12 * T(0.2) - minus_U10_11 * T(0.1) + U10_13 * T(0.05) + Pddot10_1;
  const T a10_2 = U10_21 * T(0.1) - minus_U10_22 * T(0.2) + U10_23 * T(0.05) + Pddot10_2;
  const T a10_3 = U10_31 * T(0.1) + U10_32 * T(0.2) - minus_U10_33 * T(0.05) + Pddot10_3;
  // G10 = m10 a10: force balance, body axes [N]
  const T G10_1 = T(2) * a10_1;
  const T G10_2 = T(2) * a10_2;
  const T G10_3 = T(2) * a10_3;
  // N10 = axial(U10 (tr(I10)/2 - I10)): moment balance about the mass centre, body axes [N m]
  const T N10_1 = T(0.06000000000000001) * U10_32 - T(0.14) * U10_23 + T(0.008) * (minus_U10_22 - minus_U10_33) -
      T(0.01) * U10_31 + T(0.006) * U10_21;
  const T N10_2 = T(0.14) * U10_13 - T(0.09999999999999999) * U10_31 - T(0.006) * (minus_U10_33 - minus_U10_11) +
      T(0.008) * U10_12 + T(0.01) * U10_32;
  const T N10_3 = T(0.09999999999999999) * U10_21 - T(0.06000000000000001) * U10_12 - T(0.01) * (minus_U10_11 -
      minus_U10_22) - T(0.006) * U10_23 - T(0.008) * U10_13;

  // ---- body 11 (body_11) on body 10
  const T theta11 = x[10];
  const T thetadot11 = y[10];
  const T thetaddot11 = ydot[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cos(theta11);
  const T E11_12 = sin(theta11);
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 + E11_12 * omega10_2;
  const T omega11_2 = E11_11 * omega10_2 - E11_12 * omega10_1;
  const T omega11_3 = thetadot11 + omega10_3;
  // omegadot11 = -thetadot11 b11~ E11 omega10 + thetaddot11 b11 + E11 omegadot10: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot11_1 = thetadot11 * omega11_2 + E11_11 * omegadot10_1 + E11_12 * omegadot10_2;
  const T omegadot11_2 = E11_11 * omegadot10_2 - E11_12 * omegadot10_1 - thetadot11 * omega11_1;
  const T omegadot11_3 = thetaddot11 + omegadot10_3;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_1 = omega11_3 * omega11_3;
  const T t11_2 = omega11_2 * omega11_2;
  const T minus_U11_11 = t11_1 + t11_2;
  const T t11_3 = omega11_2 * omega11_1;
  const T U11_12 = t11_3 - omegadot11_3;
  const T t11_4 = omega11_3 * omega11_1;
  const T U11_13 = t11_4 + omegadot11_2;
  const T U11_21 = t11_3 + omegadot11_3;
  const T t11_5 = omega11_1 * omega11_1;
  const T minus_U11_22 = t11_1 + t11_5;
  const T t11_6 = omega11_3 * omega11_2;
  const T U11_23 = t11_6 - omegadot11_1;
  const T U11_31 = t11_4 - omegadot11_2;
  const T U11_32 = t11_6 + omegadot11_1;
  const T minus_U11_33 = t11_2 + t11_5;
  // Pddot11 = E11 (U10 q11 + Pddot10): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t11_7 = U10_12 * T(0.55) - minus_U10_11 * T(0.3) + U10_13 * T(0.1) + Pddot10_1;
  const T t11_8 = U10_21 * T(0.3) - minus_U10_22 * T(0.55) + U10_23 * T(0.1) + Pddot10_2;
  const T Pddot11_1 = E11_11 * t11_7 + E11_12 * t11_8;
  const T Pddot11_2 = E11_11 * t11_8 - E11_12 * t11_7;
  const T Pddot11_3 = U10_31 * T(0.3) + U10_32 * T(0.55) - minus_U10_33 * T(0.1) + Pddot10_3;
  // a11 = U11 r11 + Pddot11: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a11_1 = U11_12 * T(0.2) - minus_U11_11 * T(0.1) + U11_13 * T(0.05) + Pddot11_1;
  const T a11_2 = U11_21 * T(0.1) - minus_U11_22 * T(0.2) + U11_23 * T(0.05) + Pddot11_2;
  const T a11_3 = U11_31 * T(0.1) + U11_32 * T(0.2) - minus_U11_33 * T(0.05) + Pddot11_3;
  // G11 = m11 a11: force balance, body axes [N]
  const T G11_1 = T(2.1) * a11_1;
  const T G11_2 = T(2.1) * a11_2;
  const T G11_3 = T(2.1) * a11_3;
  // N11 = axial(U11 (tr(I11)/2 - I11)): moment balance about the mass centre, body axes [N m]
  const T N11_1 = T(0.063) * U11_32 - T(0.147) * U11_23 + T(0.0084) * (minus_U11_22 - minus_U11_33) - T(0.0105) *
      U11_31 + T(0.0063) * U11_21;
  const T N11_2 = T(0.147) * U11_13 - T(0.10500000000000001) * U11_31 - T(0.0063) * (minus_U11_33 - minus_U11_11) +
      T(0.0084) * U11_12 + T(0.0105) * U11_32;
  const T N11_3 = T(0.10500000000000001) * U11_21 - T(0.063) * U11_12 - T(0.0105) * (minus_U11_11 - minus_U11_22) -
      T(0.0063) * U11_23 - T(0.0084) * U11_13;

  // ---- body 12 (body_12) on body 11
  const T theta12 = x[11];
  const T thetadot12 = y[11];
  const T thetaddot12 = ydot[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_22 = cos(theta12);
  const T E12_23 = sin(theta12);
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T omega12_1 = thetadot12 + omega11_1;
  const T omega12_2 = E12_22 * omega11_2 + E12_23 * omega11_3;
  const T omega12_3 = E12_22 * omega11_3 - E12_23 * omega11_2;
  // omegadot12 = -thetadot12 b12~ E12 omega11 + thetaddot12 b12 + E12 omegadot11: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot12_1 = thetaddot12 + omegadot11_1;
  const T omegadot12_2 = thetadot12 * omega12_3 + E12_22 * omegadot11_2 + E12_23 * omegadot11_3;
  const T omegadot12_3 = E12_22 * omegadot11_3 - E12_23 * omegadot11_2 - thetadot12 * omega12_2;
  // U12 = omega12~ omega12~ + omegadot12~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t12_1 = omega12_3 * omega12_3;
  const T t12_2 = omega12_2 * omega12_2;
  const T minus_U12_11 = t12_1 + t12_2;
  const T t12_3 = omega12_2 * omega12_1;
  const T U12_12 = t12_3 - omegadot12_3;
  const T t12_4 = omega12_3 * omega12_1;
  const T U12_13 = t12_4 + omegadot12_2;
  const T U12_21 = t12_3 + omegadot12_3;
  const T t12_5 = omega12_1 * omega12_1;
  const T minus_U12_22 = t12_1 + t12_5;
  const T t12_6 = omega12_3 * omega12_2;
  const T U12_23 = t12_6 - omegadot12_1;
  const T U12_31 = t12_4 - omegadot12_2;
  const T U12_32 = t12_6 + omegadot12_1;
  const T minus_U12_33 = t12_2 + t12_5;
  // Pddot12 = E12 (U11 q12 + Pddot11): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot12_1 = U11_12 * T(0.6) - minus_U11_11 * T(0.3) + U11_13 * T(0.1) + Pddot11_1;
  const T t12_7 = U11_21 * T(0.3) - minus_U11_22 * T(0.6) + U11_23 * T(0.1) + Pddot11_2;
  const T t12_8 = U11_31 * T(0.3) + U11_32 * T(0.6) - minus_U11_33 * T(0.1) + Pddot11_3;
  const T Pddot12_2 = E12_22 * t12_7 + E12_23 * t12_8;
  const T Pddot12_3 = E12_22 * t12_8 - E12_23 * t12_7;
  // a12 = U12 r12 + Pddot12: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a12_1 = U12_12 * T(0.2) - minus_U12_11 * T(0.1) + U12_13 * T(0.05) + Pddot12_1;
  const T a12_2 = U12_21 * T(0.1) - minus_U12_22 * T(0.2) + U12_23 * T(0.05) + Pddot12_2;
  const T a12_3 = U12_31 * T(0.1) + U12_32 * T(0.2) - minus_U12_33 * T(0.05) + Pddot12_3;
  // G12 = m12 a12: force balance, body axes [N]
  const T G12_1 = T(2.2) * a12_1;
  const T G12_2 = T(2.2) * a12_2;
  const T G12_3 = T(2.2) * a12_3;
  // N12 = axial(U12 (tr(I12)/2 - I12)): moment balance about the mass centre, body axes [N m]
  const T N12_1 = T(0.06599999999999999) * U12_32 - T(0.15400000000000003) * U12_23 + T(0.0088) * (minus_U12_22 -
      minus_U12_33) - T(0.011) * U12_31 + T(0.0066) * U12_21;
  const T N12_2 = T(0.15400000000000003) * U12_13 - T(0.11) * U12_31 - T(0.0066) * (minus_U12_33 - minus_U12_11) +
      T(0.0088) * U12_12 + T(0.011) * U12_32;
  const T N12_3 = T(0.11) * U12_21 - T(0.06599999999999999) * U12_12 - T(0.011) * (minus_U12_11 - minus_U12_22) -
      T(0.0066) * U12_23 - T(0.0088) * U12_13;

  // ---- body 13 (body_13) on body 12
  const T theta13 = x[12];
  const T thetadot13 = y[12];
  const T thetaddot13 = ydot[12];
  // E13^T = Rot(b13, theta13): E takes components in the lower body to those in the body
  const T E13_11 = cos(theta13);
  const T minus_E13_13 = sin(theta13);
  // omega13 = thetadot13 b13 + E13 omega12: absolute angular velocity, body axes [rad/s]
  const T omega13_1 = E13_11 * omega12_1 - minus_E13_13 * omega12_3;
  const T omega13_2 = thetadot13 + omega12_2;
  const T omega13_3 = minus_E13_13 * omega12_1 + E13_11 * omega12_3;
  // omegadot13 = -thetadot13 b13~ E13 omega12 + thetaddot13 b13 + E13 omegadot12: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot13_1 = E13_11 * omegadot12_1 - minus_E13_13 * omegadot12_3 - thetadot13 * omega13_3;
  const T omegadot13_2 = thetaddot13 + omegadot12_2;
  const T omegadot13_3 = thetadot13 * omega13_1 + minus_E13_13 * omegadot12_1 + E13_11 * omegadot12_3;
  // U13 = omega13~ omega13~ + omegadot13~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t13_1 = omega13_3 * omega13_3;
  const T t13_2 = omega13_2 * omega13_2;
  const T minus_U13_11 = t13_1 + t13_2;
  const T t13_3 = omega13_2 * omega13_1;
  const T U13_12 = t13_3 - omegadot13_3;
  const T t13_4 = omega13_3 * omega13_1;
  const T U13_13 = t13_4 + omegadot13_2;
  const T U13_21 = t13_3 + omegadot13_3;
  const T t13_5 = omega13_1 * omega13_1;
  const T minus_U13_22 = t13_1 + t13_5;
  const T t13_6 = omega13_3 * omega13_2;
  const T U13_23 = t13_6 - omegadot13_1;
  const T U13_31 = t13_4 - omegadot13_2;
  const T U13_32 = t13_6 + omegadot13_1;
  const T minus_U13_33 = t13_2 + t13_5;
  // Pddot13 = E13 (U12 q13 + Pddot12): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t13_7 = U12_12 * T(0.65) - minus_U12_11 * T(0.3) + U12_13 * T(0.1) + Pddot12_1;
  const T t13_8 = U12_31 * T(0.3) + U12_32 * T(0.65) - minus_U12_33 * T(0.1) + Pddot12_3;
  const T Pddot13_1 = E13_11 * t13_7 - minus_E13_13 * t13_8;
  const T Pddot13_2 = U12_21 * T(0.3) - minus_U12_22 * T(0.65) + U12_23 * T(0.1) + Pddot12_2;
  const T Pddot13_3 = minus_E13_13 * t13_7 + E13_11 * t13_8;
  // a13 = U13 r13 + Pddot13: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a13_1 = U13_12 * T(0.2) - minus_U13_11 * T(0.1) + U13_13 * T(0.05) + Pddot13_1;
  const T a13_2 = U13_21 * T(0.1) - minus_U13_22 * T(0.2) + U13_23 * T(0.05) + Pddot13_2;
  const T a13_3 = U13_31 * T(0.1) + U13_32 * T(0.2) - minus_U13_33 * T(0.05) + Pddot13_3;
  // G13 = m13 a13: force balance, body axes [N]
  const T G13_1 = T(2.3) * a13_1;
  const T G13_2 = T(2.3) * a13_2;
  const T G13_3 = T(2.3) * a13_3;
  // N13 = axial(U13 (tr(I13)/2 - I13)): moment balance about the mass centre, body axes [N m]
  const T N13_1 = T(0.06899999999999999) * U13_32 - T(0.16100000000000003) * U13_23 + T(0.0092) * (minus_U13_22 -
      minus_U13_33) - T(0.0115) * U13_31 + T(0.0069) * U13_21;
  const T N13_2 = T(0.16100000000000003) * U13_13 - T(0.115) * U13_31 - T(0.0069) * (minus_U13_33 - minus_U13_11) +
      T(0.0092) * U13_12 + T(0.0115) * U13_32;
  const T N13_3 = T(0.115) * U13_21 - T(0.06899999999999999) * U13_12 - T(0.0115) * (minus_U13_11 - minus_U13_22) -
      T(0.0069) * U13_23 - T(0.0092) * U13_13;

  // ---- body 14 (body_14) on body 13
  const T theta14 = x[13];
  const T thetadot14 = y[13];
  const T thetaddot14 = ydot[13];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_11 = cos(theta14);
  const T E14_12 = sin(theta14);
  // omega14 = thetadot14 b14 + E14 omega13: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = E14_11 * omega13_1 + E14_12 * omega13_2;
  const T omega14_2 = E14_11 * omega13_2 - E14_12 * omega13_1;
  const T omega14_3 = thetadot14 + omega13_3;
  // omegadot14 = -thetadot14 b14~ E14 omega13 + thetaddot14 b14 + E14 omegadot13: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot14_1 = thetadot14 * omega14_2 + E14_11 * omegadot13_1 + E14_12 * omegadot13_2;
  const T omegadot14_2 = E14_11 * omegadot13_2 - E14_12 * omegadot13_1 - thetadot14 * omega14_1;
  const T omegadot14_3 = thetaddot14 + omegadot13_3;
  // U14 = omega14~ omega14~ + omegadot14~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t14_1 = omega14_3 * omega14_3;
  const T t14_2 = omega14_2 * omega14_2;
  const T minus_U14_11 = t14_1 + t14_2;
  const T t14_3 = omega14_2 * omega14_1;
  const T U14_12 = t14_3 - omegadot14_3;
  const T t14_4 = omega14_3 * omega14_1;
  const T U14_13 = t14_4 + omegadot14_2;
  const T U14_21 = t14_3 + omegadot14_3;
  const T t14_5 = omega14_1 * omega14_1;
  const T minus_U14_22 = t14_1 + t14_5;
  const T t14_6 = omega14_3 * omega14_2;
  const T U14_23 = t14_6 - omegadot14_1;
  const T U14_31 = t14_4 - omegadot14_2;
  const T U14_32 = t14_6 + omegadot14_1;
  const T minus_U14_33 = t14_2 + t14_5;
  // Pddot14 = E14 (U13 q14 + Pddot13): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t14_7 = U13_12 * T(0.7) - minus_U13_11 * T(0.3) + U13_13 * T(0.1) + Pddot13_1;
  const T t14_8 = U13_21 * T(0.3) - minus_U13_22 * T(0.7) + U13_23 * T(0.1) + Pddot13_2;
  const T Pddot14_1 = E14_11 * t14_7 + E14_12 * t14_8;
  const T Pddot14_2 = E14_11 * t14_8 - E14_12 * t14_7;
  const T Pddot14_3 = U13_31 * T(0.3) + U13_32 * T(0.7) - minus_U13_33 * T(0.1) + Pddot13_3;
  // a14 = U14 r14 + Pddot14: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a14_1 = U14_12 * T(0.2) - minus_U14_11 * T(0.1) + U14_13 * T(0.05) + Pddot14_1;
  const T a14_2 = U14_21 * T(0.1) - minus_U14_22 * T(0.2) + U14_23 * T(0.05) + Pddot14_2;
  const T a14_3 = U14_31 * T(0.1) + U14_32 * T(0.2) - minus_U14_33 * T(0.05) + Pddot14_3;
  // G14 = m14 a14: force balance, body axes [N]
  const T G14_1 = T(2.4) * a14_1;
  const T G14_2 = T(2.4) * a14_2;
  const T G14_3 = T(2.4) * a14_3;
  // N14 = axial(U14 (tr(I14)/2 - I14)): moment balance about the mass centre, body axes [N m]
  const T N14_1 = T(0.07200000000000001) * U14_32 - T(0.16799999999999998) * U14_23 + T(0.0096) * (minus_U14_22 -
      minus_U14_33) - T(0.012) * U14_31 + T(0.0072) * U14_21;
  const T N14_2 = T(0.16799999999999998) * U14_13 - T(0.12) * U14_31 - T(0.0072) * (minus_U14_33 - minus_U14_11) +
      T(0.0096) * U14_12 + T(0.012) * U14_32;
  const T N14_3 = T(0.12) * U14_21 - T(0.07200000000000001) * U14_12 - T(0.012) * (minus_U14_11 - minus_U14_22) -
      T(0.0072) * U14_23 - T(0.0096) * U14_13;

  // ---- body 15 (body_15) on body 14
  const T theta15 = x[14];
  const T thetadot15 = y[14];
  const T thetaddot15 = ydot[14];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_22 = cos(theta15);
  const T E15_23 = sin(theta15);
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = thetadot15 + omega14_1;
  const T omega15_2 = E15_22 * omega14_2 + E15_23 * omega14_3;
  const T omega15_3 = E15_22 * omega14_3 - E15_23 * omega14_2;
  // omegadot15 = -thetadot15 b15~ E15 omega14 + thetaddot15 b15 + E15 omegadot14: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot15_1 = thetaddot15 + omegadot14_1;
  const T omegadot15_2 = thetadot15 * omega15_3 + E15_22 * omegadot14_2 + E15_23 * omegadot14_3;
  const T omegadot15_3 = E15_22 * omegadot14_3 - E15_23 * omegadot14_2 - thetadot15 * omega15_2;
  // U15 = omega15~ omega15~ + omegadot15~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t15_1 = omega15_3 * omega15_3;
  const T t15_2 = omega15_2 * omega15_2;
  const T minus_U15_11 = t15_1 + t15_2;
  const T t15_3 = omega15_2 * omega15_1;
  const T U15_12 = t15_3 - omegadot15_3;
  const T t15_4 = omega15_3 * omega15_1;
  const T U15_13 = t15_4 + omegadot15_2;
  const T U15_21 = t15_3 + omegadot15_3;
  const T t15_5 = omega15_1 * omega15_1;
  const T minus_U15_22 = t15_1 + t15_5;
  const T t15_6 = omega15_3 * omega15_2;
  const T U15_23 = t15_6 - omegadot15_1;
  const T U15_31 = t15_4 - omegadot15_2;
  const T U15_32 = t15_6 + omegadot15_1;
  const T minus_U15_33 = t15_2 + t15_5;
  // Pddot15 = E15 (U14 q15 + Pddot14): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot15_1 = U14_12 * T(0.75) - minus_U14_11 * T(0.3) + U14_13 * T(0.1) + Pddot14_1;
  const T t15_7 = U14_21 * T(0.3) - minus_U14_22 * T(0.75) + U14_23 * T(0.1) + Pddot14_2;
  const T t15_8 = U14_31 * T(0.3) + U14_32 * T(0.75) - minus_U14_33 * T(0.1) + Pddot14_3;
  const T Pddot15_2 = E15_22 * t15_7 + E15_23 * t15_8;
  const T Pddot15_3 = E15_22 * t15_8 - E15_23 * t15_7;
  // a15 = U15 r15 + Pddot15: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a15_1 = U15_12 * T(0.2) - minus_U15_11 * T(0.1) + U15_13 * T(0.05) + Pddot15_1;
  const T a15_2 = U15_21 * T(0.1) - minus_U15_22 * T(0.2) + U15_23 * T(0.05) + Pddot15_2;
  const T a15_3 = U15_31 * T(0.1) + U15_32 * T(0.2) - minus_U15_33 * T(0.05) + Pddot15_3;
  // G15 = m15 a15: force balance, body axes [N]
  const T G15_1 = T(2.5) * a15_1;
  const T G15_2 = T(2.5) * a15_2;
  const T G15_3 = T(2.5) * a15_3;
  // N15 = axial(U15 (tr(I15)/2 - I15)): moment balance about the mass centre, body axes [N m]
  const T N15_1 = T(0.07500000000000001) * U15_32 - T(0.175) * U15_23 + T(0.01) * (minus_U15_22 - minus_U15_33) -
      T(0.0125) * U15_31 + T(0.0075) * U15_21;
  const T N15_2 = T(0.175) * U15_13 - T(0.125) * U15_31 - T(0.0075) * (minus_U15_33 - minus_U15_11) + T(0.01) * U15_12
      + T(0.0125) * U15_32;
  const T N15_3 = T(0.125) * U15_21 - T(0.07500000000000001) * U15_12 - T(0.0125) * (minus_U15_11 - minus_U15_22) -
      T(0.0075) * U15_23 - T(0.01) * U15_13;

  // ---- body 16 (body_16) on body 15
  const T theta16 = x[15];
  const T thetadot16 = y[15];
  const T thetaddot16 = ydot[15];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cos(theta16);
  const T minus_E16_13 = sin(theta16);
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T omega16_1 = E16_11 * omega15_1 - minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 + E16_11 * omega15_3;
  // omegadot16 = -thetadot16 b16~ E16 omega15 + thetaddot16 b16 + E16 omegadot15: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot16_1 = E16_11 * omegadot15_1 - minus_E16_13 * omegadot15_3 - thetadot16 * omega16_3;
  const T omegadot16_2 = thetaddot16 + omegadot15_2;
  const T omegadot16_3 = thetadot16 * omega16_1 + minus_E16_13 * omegadot15_1 + E16_11 * omegadot15_3;
  // U16 = omega16~ omega16~ + omegadot16~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t16_1 = omega16_3 * omega16_3;
  const T t16_2 = omega16_2 * omega16_2;
  const T minus_U16_11 = t16_1 + t16_2;
  const T t16_3 = omega16_2 * omega16_1;
  const T U16_12 = t16_3 - omegadot16_3;
  const T t16_4 = omega16_3 * omega16_1;
  const T U16_13 = t16_4 + omegadot16_2;
  const T U16_21 = t16_3 + omegadot16_3;
  const T t16_5 = omega16_1 * omega16_1;
  const T minus_U16_22 = t16_1 + t16_5;
  const T t16_6 = omega16_3 * omega16_2;
  const T U16_23 = t16_6 - omegadot16_1;
  const T U16_31 = t16_4 - omegadot16_2;
  const T U16_32 = t16_6 + omegadot16_1;
  const T minus_U16_33 = t16_2 + t16_5;
  // Pddot16 = E16 (U15 q16 + Pddot15): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t16_7 = U15_12 * T(0.8) - minus_U15_11 * T(0.3) + U15_13 * T(0.1) + Pddot15_1;
  const T t16_8 = U15_31 * T(0.3) + U15_32 * T(0.8) - minus_U15_33 * T(0.1) + Pddot15_3;
  const T Pddot16_1 = E16_11 * t16_7 - minus_E16_13 * t16_8;
  const T Pddot16_2 = U15_21 * T(0.3) - minus_U15_22 * T(0.8) + U15_23 * T(0.1) + Pddot15_2;
  const T Pddot16_3 = minus_E16_13 * t16_7 + E16_11 * t16_8;
  // a16 = U16 r16 + Pddot16: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a16_1 = U16_12 * T(0.2) - minus_U16_11 * T(0.1) + U16_13 * T(0.05) + Pddot16_1;
  const T a16_2 = U16_21 * T(0.1) - minus_U16_22 * T(0.2) + U16_23 * T(0.05) + Pddot16_2;
  const T a16_3 = U16_31 * T(0.1) + U16_32 * T(0.2) - minus_U16_33 * T(0.05) + Pddot16_3;
  // G16 = m16 a16: force balance, body axes [N]
  const T G16_1 = T(2.6) * a16_1;
  const T G16_2 = T(2.6) * a16_2;
  const T G16_3 = T(2.6) * a16_3;
  // N16 = axial(U16 (tr(I16)/2 - I16)): moment balance about the mass centre, body axes [N m]
  const T N16_1 = T(0.078) * U16_32 - T(0.182) * U16_23 + T(0.0104) * (minus_U16_22 - minus_U16_33) - T(0.013) *
      U16_31 + T(0.0078) * U16_21;
  const T N16_2 = T(0.182) * U16_13 - T(0.13) * U16_31 - T(0.0078) * (minus_U16_33 - minus_U16_11) + T(0.0104) *
      U16_12 + T(0.013) * U16_32;
  const T N16_3 = T(0.13) * U16_21 - T(0.078) * U16_12 - T(0.013) * (minus_U16_11 - minus_U16_22) - T(0.0078) * U16_23
      - T(0.0104) * U16_13;

  // ---- body 16 (body_16) and what it carries
  // rho16 = r16~ G16 + N16: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho16_1 = T(0.2) * G16_3 - T(0.05) * G16_2 + N16_1;
  const T rho16_2 = T(0.05) * G16_1 - T(0.1) * G16_3 + N16_2;
  const T b16_1 = T(0.1) * G16_2;
  const T rho16_3 = b16_1 - T(0.2) * G16_1 + N16_3;
  // r_theta16 = b16 . rho16 - tau_body_16_: Kane's equation of the angle [N m]
  const T r_theta16 = rho16_2 - u.tau_16;
  r[15] = r_theta16;

  // ---- body 15 (body_15) and what it carries
  // S15 = E16^T G16 + G15: sum of the force balances of the subtree, body axes [N]
  const T b15_1 = E16_11 * G16_1 + minus_E16_13 * G16_3;
  const T S15_1 = b15_1 + G15_1;
  const T S15_2 = G16_2 + G15_2;
  const T b15_2 = E16_11 * G16_3 - minus_E16_13 * G16_1;
  const T S15_3 = b15_2 + G15_3;
  // rho15 = q16~ E16^T G16 + E16^T rho16 + r15~ G15 + N15: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho15_1 = T(0.8) * b15_2 - b16_1 + E16_11 * rho16_1 + minus_E16_13 * rho16_3 + T(0.2) * G15_3 - T(0.05) *
      G15_2 + N15_1;
  const T rho15_2 = T(0.1) * b15_1 - T(0.3) * b15_2 + rho16_2 + T(0.05) * G15_1 - T(0.1) * G15_3 + N15_2;
  const T rho15_3 = T(0.3) * G16_2 - T(0.8) * b15_1 + E16_11 * rho16_3 - minus_E16_13 * rho16_1 + T(0.1) * G15_2 -
      T(0.2) * G15_1 + N15_3;
  // r_theta15 = b15 . rho15 - tau_body_15_: Kane's equation of the angle [N m]
  const T r_theta15 = rho15_1 - u.tau_15;
  r[14] = r_theta15;

  // ---- body 14 (body_14) and what it carries
  // S14 = E15^T S15 + G14: sum of the force balances of the subtree, body axes [N]
  const T S14_1 = S15_1 + G14_1;
  const T b14_1 = E15_22 * S15_2 - E15_23 * S15_3;
  const T S14_2 = b14_1 + G14_2;
  const T b14_2 = E15_23 * S15_2 + E15_22 * S15_3;
  const T S14_3 = b14_2 + G14_3;
  // rho14 = q15~ E15^T S15 + E15^T rho15 + r14~ G14 + N14: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho14_1 = T(0.75) * b14_2 - T(0.1) * b14_1 + rho15_1 + T(0.2) * G14_3 - T(0.05) * G14_2 + N14_1;
  const T rho14_2 = T(0.1) * S15_1 - T(0.3) * b14_2 + E15_22 * rho15_2 - E15_23 * rho15_3 + T(0.05) * G14_1 - T(0.1) *
      G14_3 + N14_2;
  const T rho14_3 = T(0.3) * b14_1 - T(0.75) * S15_1 + E15_23 * rho15_2 + E15_22 * rho15_3 + T(0.1) * G14_2 - T(0.2) *
      G14_1 + N14_3;
  // r_theta14 = b14 . rho14 - tau_body_14_: Kane's equation of the angle [N m]
  const T r_theta14 = rho14_3 - u.tau_14;
  r[13] = r_theta14;

  // ---- body 13 (body_13) and what it carries
  // S13 = E14^T S14 + G13: sum of the force balances of the subtree, body axes [N]
  const T b13_1 = E14_11 * S14_1 - E14_12 * S14_2;
  const T S13_1 = b13_1 + G13_1;
  const T b13_2 = E14_12 * S14_1 + E14_11 * S14_2;
  const T S13_2 = b13_2 + G13_2;
  const T S13_3 = S14_3 + G13_3;
  // rho13 = q14~ E14^T S14 + E14^T rho14 + r13~ G13 + N13: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho13_1 = T(0.7) * S14_3 - T(0.1) * b13_2 + E14_11 * rho14_1 - E14_12 * rho14_2 + T(0.2) * G13_3 - T(0.05) *
      G13_2 + N13_1;
  const T rho13_2 = T(0.1) * b13_1 - T(0.3) * S14_3 + E14_12 * rho14_1 + E14_11 * rho14_2 + T(0.05) * G13_1 - T(0.1) *
      G13_3 + N13_2;
  const T rho13_3 = T(0.3) * b13_2 - T(0.7) * b13_1 + rho14_3 + T(0.1) * G13_2 - T(0.2) * G13_1 + N13_3;
  // r_theta13 = b13 . rho13 - tau_body_13_: Kane's equation of the angle [N m]
  const T r_theta13 = rho13_2 - u.tau_13;
  r[12] = r_theta13;

  // ---- body 12 (body_12) and what it carries
  // S12 = E13^T S13 + G12: sum of the force balances of the subtree, body axes [N]
  const T b12_1 = E13_11 * S13_1 + minus_E13_13 * S13_3;
  const T S12_1 = b12_1 + G12_1;
  const T S12_2 = S13_2 + G12_2;
  const T b12_2 = E13_11 * S13_3 - minus_E13_13 * S13_1;
  const T S12_3 = b12_2 + G12_3;
  // rho12 = q13~ E13^T S13 + E13^T rho13 + r12~ G12 + N12: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho12_1 = T(0.65) * b12_2 - T(0.1) * S13_2 + E13_11 * rho13_1 + minus_E13_13 * rho13_3 + T(0.2) * G12_3 -
      T(0.05) * G12_2 + N12_1;
  const T rho12_2 = T(0.1) * b12_1 - T(0.3) * b12_2 + rho13_2 + T(0.05) * G12_1 - T(0.1) * G12_3 + N12_2;
  const T rho12_3 = T(0.3) * S13_2 - T(0.65) * b12_1 + E13_11 * rho13_3 - minus_E13_13 * rho13_1 + T(0.1) * G12_2 -
      T(0.2) * G12_1 + N12_3;
  // r_theta12 = b12 . rho12 - tau_body_12_: Kane's equation of the angle [N m]
  const T r_theta12 = rho12_1 - u.tau_12;
  r[11] = r_theta12;

  // ---- body 11 (body_11) and what it carries
  // S11 = E12^T S12 + G11: sum of the force balances of the subtree, body axes [N]
  const T S11_1 = S12_1 + G11_1;
  const T b11_1 = E12_22 * S12_2 - E12_23 * S12_3;
  const T S11_2 = b11_1 + G11_2;
  const T b11_2 = E12_23 * S12_2 + E12_22 * S12_3;
  const T S11_3 = b11_2 + G11_3;
  // rho11 = q12~ E12^T S12 + E12^T rho12 + r11~ G11 + N11: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho11_1 = T(0.6) * b11_2 - T(0.1) * b11_1 + rho12_1 + T(0.2) * G11_3 - T(0.05) * G11_2 + N11_1;
  const T rho11_2 = T(0.1) * S12_1 - T(0.3) * b11_2 + E12_22 * rho12_2 - E12_23 * rho12_3 + T(0.05) * G11_1 - T(0.1) *
      G11_3 + N11_2;
  const T rho11_3 = T(0.3) * b11_1 - T(0.6) * S12_1 + E12_23 * rho12_2 + E12_22 * rho12_3 + T(0.1) * G11_2 - T(0.2) *
      G11_1 + N11_3;
  // r_theta11 = b11 . rho11 - tau_body_11_: Kane's equation of the angle [N m]
  const T r_theta11 = rho11_3 - u.tau_11;
  r[10] = r_theta11;

  // ---- body 10 (body_10) and what it carries
  // S10 = E11^T S11 + G10: sum of the force balances of the subtree, body axes [N]
  const T b10_1 = E11_11 * S11_1 - E11_12 * S11_2;
  const T S10_1 = b10_1 + G10_1;
  const T b10_2 = E11_12 * S11_1 + E11_11 * S11_2;
  const T S10_2 = b10_2 + G10_2;
  const T S10_3 = S11_3 + G10_3;
  // rho10 = q11~ E11^T S11 + E11^T rho11 + r10~ G10 + N10: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho10_1 = T(0.55) * S11_3 - T(0.1) * b10_2 + E11_11 * rho11_1 - E11_12 * rho11_2 + T(0.2) * G10_3 - T(0.05)
      * G10_2 + N10_1;
  const T rho10_2 = T(0.1) * b10_1 - T(0.3) * S11_3 + E11_12 * rho11_1 + E11_11 * rho11_2 + T(0.05) * G10_1 - T(0.1) *
      G10_3 + N10_2;
  const T rho10_3 = T(0.3) * b10_2 - T(0.55) * b10_1 + rho11_3 + T(0.1) * G10_2 - T(0.2) * G10_1 + N10_3;
  // r_theta10 = b10 . rho10 - tau_body_10_: Kane's equation of the angle [N m]
  const T r_theta10 = rho10_2 - u.tau_10;
  r[9] = r_theta10;

  // ---- body 9 (body_9) and what it carries
  // S9 = E10^T S10 + G9: sum of the force balances of the subtree, body axes [N]
  const T b9_1 = E10_11 * S10_1 + minus_E10_13 * S10_3;
  const T S9_1 = b9_1 + G9_1;
  const T S9_2 = S10_2 + G9_2;
  const T b9_2 = E10_11 * S10_3 - minus_E10_13 * S10_1;
  const T S9_3 = b9_2 + G9_3;
  // rho9 = q10~ E10^T S10 + E10^T rho10 + r9~ G9 + N9: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho9_1 = T(0.5) * b9_2 - T(0.1) * S10_2 + E10_11 * rho10_1 + minus_E10_13 * rho10_3 + T(0.2) * G9_3 -
      T(0.05) * G9_2 + N9_1;
  const T rho9_2 = T(0.1) * b9_1 - T(0.3) * b9_2 + rho10_2 + T(0.05) * G9_1 - T(0.1) * G9_3 + N9_2;
  const T rho9_3 = T(0.3) * S10_2 - T(0.5) * b9_1 + E10_11 * rho10_3 - minus_E10_13 * rho10_1 + T(0.1) * G9_2 - T(0.2)
      * G9_1 + N9_3;
  // r_theta9 = b9 . rho9 - tau_body_9_: Kane's equation of the angle [N m]
  const T r_theta9 = rho9_1 - u.tau_9;
  r[8] = r_theta9;

  // ---- body 8 (body_8) and what it carries
  // S8 = E9^T S9 + G8: sum of the force balances of the subtree, body axes [N]
  const T S8_1 = S9_1 + G8_1;
  const T b8_1 = E9_22 * S9_2 - E9_23 * S9_3;
  const T S8_2 = b8_1 + G8_2;
  const T b8_2 = E9_23 * S9_2 + E9_22 * S9_3;
  const T S8_3 = b8_2 + G8_3;
  // rho8 = q9~ E9^T S9 + E9^T rho9 + r8~ G8 + N8: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho8_1 = T(0.45) * b8_2 - T(0.1) * b8_1 + rho9_1 + T(0.2) * G8_3 - T(0.05) * G8_2 + N8_1;
  const T rho8_2 = T(0.1) * S9_1 - T(0.3) * b8_2 + E9_22 * rho9_2 - E9_23 * rho9_3 + T(0.05) * G8_1 - T(0.1) * G8_3 +
      N8_2;
  const T rho8_3 = T(0.3) * b8_1 - T(0.45) * S9_1 + E9_23 * rho9_2 + E9_22 * rho9_3 + T(0.1) * G8_2 - T(0.2) * G8_1 +
      N8_3;
  // r_theta8 = b8 . rho8 - tau_body_8_: Kane's equation of the angle [N m]
  const T r_theta8 = rho8_3 - u.tau_8;
  r[7] = r_theta8;

  // ---- body 7 (body_7) and what it carries
  // S7 = E8^T S8 + G7: sum of the force balances of the subtree, body axes [N]
  const T b7_1 = E8_11 * S8_1 - E8_12 * S8_2;
  const T S7_1 = b7_1 + G7_1;
  const T b7_2 = E8_12 * S8_1 + E8_11 * S8_2;
  const T S7_2 = b7_2 + G7_2;
  const T S7_3 = S8_3 + G7_3;
  // rho7 = q8~ E8^T S8 + E8^T rho8 + r7~ G7 + N7: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho7_1 = T(0.4) * S8_3 - T(0.1) * b7_2 + E8_11 * rho8_1 - E8_12 * rho8_2 + T(0.2) * G7_3 - T(0.05) * G7_2 +
      N7_1;
  const T rho7_2 = T(0.1) * b7_1 - T(0.3) * S8_3 + E8_12 * rho8_1 + E8_11 * rho8_2 + T(0.05) * G7_1 - T(0.1) * G7_3 +
      N7_2;
  const T rho7_3 = T(0.3) * b7_2 - T(0.4) * b7_1 + rho8_3 + T(0.1) * G7_2 - T(0.2) * G7_1 + N7_3;
  // r_theta7 = b7 . rho7 - tau_body_7_: Kane's equation of the angle [N m]
  const T r_theta7 = rho7_2 - u.tau_7;
  r[6] = r_theta7;

  // ---- body 6 (body_6) and what it carries
  // S6 = E7^T S7 + G6: sum of the force balances of the subtree, body axes [N]
  const T b6_1 = E7_11 * S7_1 + minus_E7_13 * S7_3;
  const T S6_1 = b6_1 + G6_1;
  const T S6_2 = S7_2 + G6_2;
  const T b6_2 = E7_11 * S7_3 - minus_E7_13 * S7_1;
  const T S6_3 = b6_2 + G6_3;
  // rho6 = q7~ E7^T S7 + E7^T rho7 + r6~ G6 + N6: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho6_1 = T(0.35) * b6_2 - T(0.1) * S7_2 + E7_11 * rho7_1 + minus_E7_13 * rho7_3 + T(0.2) * G6_3 - T(0.05) *
      G6_2 + N6_1;
  const T rho6_2 = T(0.1) * b6_1 - T(0.3) * b6_2 + rho7_2 + T(0.05) * G6_1 - T(0.1) * G6_3 + N6_2;
  const T rho6_3 = T(0.3) * S7_2 - T(0.35) * b6_1 + E7_11 * rho7_3 - minus_E7_13 * rho7_1 + T(0.1) * G6_2 - T(0.2) *
      G6_1 + N6_3;
  // r_theta6 = b6 . rho6 - tau_body_6_: Kane's equation of the angle [N m]
  const T r_theta6 = rho6_1 - u.tau_6;
  r[5] = r_theta6;

  // ---- body 5 (body_5) and what it carries
  // S5 = E6^T S6 + G5: sum of the force balances of the subtree, body axes [N]
  const T S5_1 = S6_1 + G5_1;
  const T b5_1 = E6_22 * S6_2 - E6_23 * S6_3;
  const T S5_2 = b5_1 + G5_2;
  const T b5_2 = E6_23 * S6_2 + E6_22 * S6_3;
  const T S5_3 = b5_2 + G5_3;
  // rho5 = q6~ E6^T S6 + E6^T rho6 + r5~ G5 + N5: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T b5_3 = T(0.3) * b5_2;
  const T rho5_1 = b5_3 - T(0.1) * b5_1 + rho6_1 + T(0.2) * G5_3 - T(0.05) * G5_2 + N5_1;
  const T rho5_2 = T(0.1) * S6_1 - b5_3 + E6_22 * rho6_2 - E6_23 * rho6_3 + T(0.05) * G5_1 - T(0.1) * G5_3 + N5_2;
  const T rho5_3 = T(0.3) * b5_1 - T(0.3) * S6_1 + E6_23 * rho6_2 + E6_22 * rho6_3 + T(0.1) * G5_2 - T(0.2) * G5_1 +
      N5_3;
  // r_theta5 = b5 . rho5 - tau_body_5_: Kane's equation of the angle [N m]
  const T r_theta5 = rho5_3 - u.tau_5;
  r[4] = r_theta5;

  // ---- body 4 (body_4) and what it carries
  // S4 = E5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T b4_1 = E5_11 * S5_1 - E5_12 * S5_2;
  const T S4_1 = b4_1 + G4_1;
  const T b4_2 = E5_12 * S5_1 + E5_11 * S5_2;
  const T S4_2 = b4_2 + G4_2;
  const T S4_3 = S5_3 + G4_3;
  // rho4 = q5~ E5^T S5 + E5^T rho5 + r4~ G4 + N4: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho4_1 = T(0.25) * S5_3 - T(0.1) * b4_2 + E5_11 * rho5_1 - E5_12 * rho5_2 + T(0.2) * G4_3 - T(0.05) * G4_2 +
      N4_1;
  const T rho4_2 = T(0.1) * b4_1 - T(0.3) * S5_3 + E5_12 * rho5_1 + E5_11 * rho5_2 + T(0.05) * G4_1 - T(0.1) * G4_3 +
      N4_2;
  const T rho4_3 = T(0.3) * b4_2 - T(0.25) * b4_1 + rho5_3 + T(0.1) * G4_2 - T(0.2) * G4_1 + N4_3;
  // r_theta4 = b4 . rho4 - tau_body_4_: Kane's equation of the angle [N m]
  const T r_theta4 = rho4_2 - u.tau_4;
  r[3] = r_theta4;

  // ---- body 3 (body_3) and what it carries
  // S3 = E4^T S4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = E4_11 * S4_1 + minus_E4_13 * S4_3;
  const T S3_1 = b3_1 + G3_1;
  const T S3_2 = S4_2 + G3_2;
  const T b3_2 = E4_11 * S4_3 - minus_E4_13 * S4_1;
  const T S3_3 = b3_2 + G3_3;
  // rho3 = q4~ E4^T S4 + E4^T rho4 + r3~ G3 + N3: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho3_1 = T(0.2) * b3_2 - T(0.1) * S4_2 + E4_11 * rho4_1 + minus_E4_13 * rho4_3 + T(0.2) * G3_3 - T(0.05) *
      G3_2 + N3_1;
  const T rho3_2 = T(0.1) * b3_1 - T(0.3) * b3_2 + rho4_2 + T(0.05) * G3_1 - T(0.1) * G3_3 + N3_2;
  const T rho3_3 = T(0.3) * S4_2 - T(0.2) * b3_1 + E4_11 * rho4_3 - minus_E4_13 * rho4_1 + T(0.1) * G3_2 - T(0.2) *
      G3_1 + N3_3;
  // r_theta3 = b3 . rho3 - tau_body_3_: Kane's equation of the angle [N m]
  const T r_theta3 = rho3_1 - u.tau_3;
  r[2] = r_theta3;

  // ---- body 2 (body_2) and what it carries
  // S2 = E3^T S3 + G2: sum of the force balances of the subtree, body axes [N]
  const T S2_1 = S3_1 + G2_1;
  const T b2_1 = E3_22 * S3_2 - E3_23 * S3_3;
  const T S2_2 = b2_1 + G2_2;
  const T b2_2 = E3_23 * S3_2 + E3_22 * S3_3;
  const T S2_3 = b2_2 + G2_3;
  // rho2 = q3~ E3^T S3 + E3^T rho3 + r2~ G2 + N2: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho2_1 = T(0.15) * b2_2 - T(0.1) * b2_1 + rho3_1 + T(0.2) * G2_3 - T(0.05) * G2_2 + N2_1;
  const T rho2_2 = T(0.1) * S3_1 - T(0.3) * b2_2 + E3_22 * rho3_2 - E3_23 * rho3_3 + T(0.05) * G2_1 - T(0.1) * G2_3 +
      N2_2;
  const T rho2_3 = T(0.3) * b2_1 - T(0.15) * S3_1 + E3_23 * rho3_2 + E3_22 * rho3_3 + T(0.1) * G2_2 - T(0.2) * G2_1 +
      N2_3;
  // r_theta2 = b2 . rho2 - tau_body_2_: Kane's equation of the angle [N m]
  const T r_theta2 = rho2_3 - u.tau_2;
  r[1] = r_theta2;

  // ---- body 1 (body_1) and what it carries
  // rho1 = q2~ E2^T S2 + E2^T rho2 + r1~ G1 + N1: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho1_2 = T(0.1) * (E2_11 * S2_1 - E2_12 * S2_2) - T(0.3) * S2_3 + E2_12 * rho2_1 + E2_11 * rho2_2 + T(0.05)
      * G1_1 - T(0.1) * G1_3 + N1_2;
  // r_theta1 = b1 . rho1 - tau_body_1_: Kane's equation of the angle [N m]
  const T r_theta1 = rho1_2 - u.tau_1;
  r[0] = r_theta1;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 1609 add, 1762 multiply, 30 sine or cosine
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  using std::cos, std::sin;

  // ---- body 2 (body_2) on body 1
  const T theta2 = x[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T E2_12 = sin(theta2);

  // ---- body 3 (body_3) on body 2
  const T theta3 = x[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cos(theta3);
  const T E3_23 = sin(theta3);

  // ---- body 4 (body_4) on body 3
  const T theta4 = x[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cos(theta4);
  const T minus_E4_13 = sin(theta4);

  // ---- body 5 (body_5) on body 4
  const T theta5 = x[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cos(theta5);
  const T E5_12 = sin(theta5);

  // ---- body 6 (body_6) on body 5
  const T theta6 = x[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cos(theta6);
  const T E6_23 = sin(theta6);

  // ---- body 7 (body_7) on body 6
  const T theta7 = x[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cos(theta7);
  const T minus_E7_13 = sin(theta7);

  // ---- body 8 (body_8) on body 7
  const T theta8 = x[7];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cos(theta8);
  const T E8_12 = sin(theta8);

  // ---- body 9 (body_9) on body 8
  const T theta9 = x[8];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_22 = cos(theta9);
  const T E9_23 = sin(theta9);

  // ---- body 10 (body_10) on body 9
  const T theta10 = x[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_11 = cos(theta10);
  const T minus_E10_13 = sin(theta10);

  // ---- body 11 (body_11) on body 10
  const T theta11 = x[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cos(theta11);
  const T E11_12 = sin(theta11);

  // ---- body 12 (body_12) on body 11
  const T theta12 = x[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_22 = cos(theta12);
  const T E12_23 = sin(theta12);

  // ---- body 13 (body_13) on body 12
  const T theta13 = x[12];
  // E13^T = Rot(b13, theta13): E takes components in the lower body to those in the body
  const T E13_11 = cos(theta13);
  const T minus_E13_13 = sin(theta13);

  // ---- body 14 (body_14) on body 13
  const T theta14 = x[13];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_11 = cos(theta14);
  const T E14_12 = sin(theta14);

  // ---- body 15 (body_15) on body 14
  const T theta15 = x[14];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_22 = cos(theta15);
  const T E15_23 = sin(theta15);

  // ---- body 16 (body_16) on body 15
  const T theta16 = x[15];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cos(theta16);
  const T minus_E16_13 = sin(theta16);

  // ---- body 16 (body_16) and what it carries
  // hc16 = E16^T h16: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc16_1 = minus_E16_13 * T(0.13) + E16_11 * T(0.26);
  const T hc16_3 = E16_11 * T(0.13) - minus_E16_13 * T(0.26);

  // ---- body 15 (body_15) and what it carries
  // h15 = m15 r15 + m16 q16 + hc16: first moment of mass carried, about the body origin, body axes [kg m]
  const T h15_1 = T(1.03) + hc16_1;
  const T h15_3 = T(0.385) + hc16_3;
  // J15 = -q16~ hc16~ + E16^T J16 E16 - m15 r15~ r15~ + I15 + (-m16 q16~ - hc16~) q16~: inertia carried, about the
  //   body origin, body axes [kg m^2]
  const T b15_1 = minus_E16_13 * T(0.005200000000000002);
  const T b15_2 = E16_11 * T(0.37050000000000005) - b15_1;
  const T b15_3 = E16_11 * T(0.005200000000000002);
  const T b15_4 = minus_E16_13 * T(0.338) - b15_3;
  const T b15_5 = T(0.1) * hc16_3;
  const T b15_6 = hc16_3 + T(0.26);
  const T b15_7 = b15_6 * T(0.1);
  const T J15_11 = b15_2 * E16_11 + b15_4 * minus_E16_13 + b15_5 + T(2.85225) + b15_7;
  const T b15_8 = E16_11 * T(0.03900000000000001) + minus_E16_13 * T(0.0364);
  const T b15_9 = T(0.8) * hc16_1 + b15_8;
  const T minus_J15_12 = T(0.8175) + b15_9;
  const T b15_10 = b15_4 * E16_11 - b15_2 * minus_E16_13 - T(0.005000000000000002);
  const T J15_13 = b15_10 - T(0.1) * hc16_1 - b15_6 * T(0.3);
  const T b15_11 = hc16_1 + T(0.78);
  const T minus_J15_21 = T(0.1935) + b15_8 + b15_11 * T(0.8);
  const T b15_12 = T(0.3) * hc16_1;
  const T b15_13 = b15_5 + b15_12 + T(0.34450000000000003);
  const T b15_14 = b15_11 * T(0.3);
  const T J15_22 = b15_13 + T(0.33125) + b15_7 + b15_14;
  const T b15_15 = minus_E16_13 * T(0.03900000000000001) - E16_11 * T(0.0364);
  const T J15_23 = b15_15 - T(0.08700000000000001) - b15_6 * T(0.8);
  const T J15_31 = b15_10 - T(0.3) * hc16_3 - b15_11 * T(0.1);
  const T b15_16 = b15_15 - T(0.8) * hc16_3;
  const T J15_32 = b15_16 - T(0.29500000000000004);
  const T J15_33 = (minus_E16_13 * T(0.37050000000000005) + b15_3) * minus_E16_13 + (b15_1 + E16_11 * T(0.338)) *
      E16_11 + T(2.821) + b15_12 + b15_14;
  A[238] = J15_11;
  // hc15 = E15^T h15: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc15_2 = E15_22 * T(3.1) - E15_23 * h15_3;
  const T hc15_3 = E15_22 * h15_3 + E15_23 * T(3.1);
  A[239] = -b15_9;
  A[254] = -b15_9;

  // ---- body 14 (body_14) and what it carries
  // h14 = m14 r14 + m_sub15 q15 + hc15: first moment of mass carried, about the body origin, body axes [kg m]
  const T h14_1 = T(1.77) + h15_1;
  const T h14_2 = T(4.305) + hc15_2;
  const T h14_3 = T(0.63) + hc15_3;
  // J14 = -q15~ hc15~ + E15^T J15 E15 - m14 r14~ r14~ + I14 + (-m_sub15 q15~ - hc15~) q15~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b14_1 = T(0.1) * hc15_3;
  const T b14_2 = T(0.75) * hc15_2;
  const T b14_3 = b14_1 + b14_2 + J15_11;
  const T b14_4 = hc15_3 + T(0.51);
  const T b14_5 = b14_4 * T(0.1);
  const T b14_6 = T(3.825) + hc15_2;
  const T b14_7 = b14_6 * T(0.75);
  const T J14_11 = b14_3 + T(0.342) + b14_5 + b14_7;
  const T b14_8 = minus_J15_12 * E15_22 + J15_13 * E15_23 + T(0.036000000000000004);
  const T minus_J14_12 = b14_8 + T(0.75) * h15_1 + b14_6 * T(0.3);
  const T J14_13 = J15_13 * E15_22 - minus_J15_12 * E15_23 - T(0.1) * h15_1 - T(0.004800000000000001) - b14_4 *
      T(0.3);
  const T b14_9 = T(0.3) * hc15_2;
  const T b14_10 = h15_1 + T(1.53);
  const T minus_J14_21 = b14_8 + b14_9 + b14_10 * T(0.75);
  const T b14_11 = E15_22 * J15_22 - E15_23 * J15_32;
  const T b14_12 = E15_22 * J15_23 - E15_23 * J15_33;
  const T b14_13 = T(0.3) * h15_1 + b14_10 * T(0.3);
  const T J14_22 = b14_11 * E15_22 - b14_12 * E15_23 + b14_1 + b14_13 + T(0.318) + b14_5;
  const T J14_23 = b14_11 * E15_23 + b14_12 * E15_22 - T(0.1) * hc15_2 - T(0.0336) - b14_4 * T(0.75);
  const T J14_33 = (E15_23 * J15_22 + E15_22 * J15_32) * E15_23 + (E15_23 * J15_23 + E15_22 * J15_33) * E15_22 + b14_2
      + b14_13 + T(0.312) + b14_7;
  A[221] = J14_33;
  // hc14 = E14^T h14: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc14_1 = E14_11 * h14_1 - E14_12 * h14_2;
  const T hc14_2 = E14_11 * h14_2 + E14_12 * h14_1;
  // B_thetadot16_14 = E15^T B_thetadot16_15
  const T B_thetadot16_14_2 = E15_23 * hc16_1;
  const T minus_B_thetadot16_14_3 = E15_22 * hc16_1;
  // K_thetadot16_14 = q15~ E15^T B_thetadot16_15 + E15^T K_thetadot16_15
  const T minus_K_thetadot16_14_1 = T(0.1) * B_thetadot16_14_2 + T(0.75) * minus_B_thetadot16_14_3 + b15_9;
  const T b14_14 = T(0.3) * minus_B_thetadot16_14_3;
  const T K_thetadot16_14_2 = b15_5 + b14_14 + E15_22 * b15_13 - E15_23 * b15_16;
  const T K_thetadot16_14_3 = T(0.3) * B_thetadot16_14_2 - T(0.75) * hc16_3 + E15_23 * b15_13 + E15_22 * b15_16;
  A[223] = K_thetadot16_14_3;
  A[253] = K_thetadot16_14_3;
  // K_thetadot15_14 = q15~ E15^T B_thetadot15_15 + E15^T K_thetadot15_15
  const T minus_K_thetadot15_14_2 = E15_22 * minus_J15_21 + E15_23 * J15_31 + b14_9;
  const T K_thetadot15_14_3 = E15_22 * J15_31 - E15_23 * minus_J15_21 - T(0.3) * hc15_3;
  A[222] = K_thetadot15_14_3;
  A[237] = K_thetadot15_14_3;

  // ---- body 13 (body_13) and what it carries
  // h13 = m13 r13 + m_sub14 q14 + hc14: first moment of mass carried, about the body origin, body axes [kg m]
  const T h13_1 = T(2.48) + hc14_1;
  const T h13_2 = T(5.71) + hc14_2;
  const T h13_3 = T(0.865) + h14_3;
  // J13 = -q14~ hc14~ + E14^T J14 E14 - m13 r13~ r13~ + I13 + (-m_sub14 q14~ - hc14~) q14~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b13_1 = E14_11 * J14_11 + E14_12 * minus_J14_21;
  const T b13_2 = E14_11 * minus_J14_12 + E14_12 * J14_22;
  const T b13_3 = h14_3 + T(0.75);
  const T b13_4 = T(0.1) * h14_3 + b13_3 * T(0.1);
  const T b13_5 = T(0.7) * hc14_2;
  const T b13_6 = T(5.25) + hc14_2;
  const T b13_7 = b13_6 * T(0.7);
  const T J13_11 = b13_1 * E14_11 + b13_2 * E14_12 + b13_4 + b13_5 + T(0.32775) + b13_7;
  const T b13_8 = b13_1 * E14_12 - b13_2 * E14_11 - T(0.0345);
  const T J13_12 = b13_8 - T(0.7) * hc14_1 - b13_6 * T(0.3);
  const T b13_9 = E14_11 * J14_13 - E14_12 * J14_23;
  const T b13_10 = T(0.1) * hc14_1;
  const T b13_11 = b13_9 - b13_10;
  const T J13_13 = b13_11 - T(0.004600000000000001) - b13_3 * T(0.3);
  const T b13_12 = hc14_1 + T(2.25);
  const T J13_21 = b13_8 - T(0.3) * hc14_2 - b13_12 * T(0.7);
  const T b13_13 = T(0.3) * hc14_1;
  const T b13_14 = b13_12 * T(0.3);
  const T J13_22 = (E14_12 * J14_11 - E14_11 * minus_J14_21) * E14_12 + (E14_11 * J14_22 - E14_12 * minus_J14_12) *
      E14_11 + b13_4 + b13_13 + T(0.30475) + b13_14;
  const T b13_15 = E14_12 * J14_13 + E14_11 * J14_23;
  const T b13_16 = b13_15 - T(0.1) * hc14_2;
  const T J13_23 = b13_16 - T(0.0322) - b13_3 * T(0.7);
  const T J13_31 = b13_9 - T(0.3) * h14_3 - T(0.004600000000000001) - b13_12 * T(0.1);
  const T J13_32 = b13_15 - T(0.7) * h14_3 - T(0.0322) - b13_6 * T(0.1);
  const T b13_17 = b13_13 + b13_5 + J14_33;
  const T J13_33 = b13_17 + T(0.299) + b13_7 + b13_14;
  A[204] = J13_22;
  // hc13 = E13^T h13: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc13_1 = minus_E13_13 * h13_3 + E13_11 * h13_1;
  const T hc13_3 = E13_11 * h13_3 - minus_E13_13 * h13_1;
  // B_thetadot16_13 = E14^T B_thetadot16_14
  const T B_thetadot16_13_1 = E14_11 * hc16_3 - E14_12 * B_thetadot16_14_2;
  const T B_thetadot16_13_2 = E14_12 * hc16_3 + E14_11 * B_thetadot16_14_2;
  // K_thetadot16_13 = q14~ E14^T B_thetadot16_14 + E14^T K_thetadot16_14
  const T b13_18 = T(0.1) * B_thetadot16_13_2;
  const T minus_K_thetadot16_13_1 = b13_18 + T(0.7) * minus_B_thetadot16_14_3 + E14_11 * minus_K_thetadot16_14_1 +
      E14_12 * K_thetadot16_14_2;
  const T K_thetadot16_13_2 = T(0.1) * B_thetadot16_13_1 + b14_14 + E14_11 * K_thetadot16_14_2 - E14_12 *
      minus_K_thetadot16_14_1;
  const T b13_19 = T(0.3) * B_thetadot16_13_2;
  const T K_thetadot16_13_3 = b13_19 - T(0.7) * B_thetadot16_13_1 + K_thetadot16_14_3;
  A[207] = K_thetadot16_13_2;
  A[252] = K_thetadot16_13_2;
  // B_thetadot15_13 = E14^T B_thetadot15_14
  const T B_thetadot15_13_1 = E14_12 * hc15_3;
  const T minus_B_thetadot15_13_2 = E14_11 * hc15_3;
  // K_thetadot15_13 = q14~ E14^T B_thetadot15_14 + E14^T K_thetadot15_14
  const T b13_20 = T(0.1) * minus_B_thetadot15_13_2;
  const T K_thetadot15_13_1 = b13_20 + T(0.7) * hc15_2 + E14_11 * b14_3 + E14_12 * minus_K_thetadot15_14_2;
  const T K_thetadot15_13_2 = T(0.1) * B_thetadot15_13_1 - b14_9 + E14_12 * b14_3 - E14_11 * minus_K_thetadot15_14_2;
  const T b13_21 = T(0.3) * minus_B_thetadot15_13_2;
  const T K_thetadot15_13_3 = K_thetadot15_14_3 - b13_21 - T(0.7) * B_thetadot15_13_1;
  A[206] = K_thetadot15_13_2;
  A[236] = K_thetadot15_13_2;
  A[205] = b13_16;
  A[220] = b13_16;

  // ---- body 12 (body_12) and what it carries
  // h12 = m12 r12 + m_sub13 q13 + hc13: first moment of mass carried, about the body origin, body axes [kg m]
  const T h12_1 = T(3.1599999999999997) + hc13_1;
  const T h12_2 = T(6.8100000000000005) + h13_2;
  const T h12_3 = T(1.09) + hc13_3;
  // J12 = -q13~ hc13~ + E13^T J13 E13 - m12 r12~ r12~ + I12 + (-m_sub13 q13~ - hc13~) q13~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b12_1 = E13_11 * J13_11 + minus_E13_13 * J13_31;
  const T b12_2 = E13_11 * J13_13 + minus_E13_13 * J13_33;
  const T b12_3 = T(0.1) * hc13_3;
  const T b12_4 = T(6.37) + h13_2;
  const T b12_5 = T(0.65) * h13_2 + b12_4 * T(0.65);
  const T b12_6 = hc13_3 + T(0.98);
  const T b12_7 = b12_6 * T(0.1);
  const T J12_11 = b12_1 * E13_11 + b12_2 * minus_E13_13 + b12_3 + b12_5 + T(0.3135) + b12_7;
  const T b12_8 = E13_11 * J13_12 + minus_E13_13 * J13_32;
  const T b12_9 = b12_8 - T(0.65) * hc13_1;
  const T J12_12 = b12_9 - T(0.03300000000000001) - b12_4 * T(0.3);
  const T b12_10 = b12_2 * E13_11 - b12_1 * minus_E13_13 - T(0.004400000000000002);
  const T J12_13 = b12_10 - T(0.1) * hc13_1 - b12_6 * T(0.3);
  const T b12_11 = hc13_1 + T(2.94);
  const T J12_21 = b12_8 - T(0.3) * h13_2 - T(0.03300000000000001) - b12_11 * T(0.65);
  const T b12_12 = T(0.3) * hc13_1;
  const T b12_13 = b12_3 + b12_12 + J13_22;
  const T b12_14 = b12_11 * T(0.3);
  const T J12_22 = b12_13 + T(0.29150000000000004) + b12_7 + b12_14;
  const T b12_15 = J13_23 * E13_11 - J13_21 * minus_E13_13 - T(0.030800000000000004);
  const T J12_23 = b12_15 - T(0.1) * h13_2 - b12_6 * T(0.65);
  const T J12_31 = b12_10 - T(0.3) * hc13_3 - b12_11 * T(0.1);
  const T b12_16 = T(0.65) * hc13_3;
  const T J12_32 = b12_15 - b12_16 - b12_4 * T(0.1);
  const T J12_33 = (E13_11 * J13_33 - minus_E13_13 * J13_13) * E13_11 - (E13_11 * J13_31 - minus_E13_13 * J13_11) *
      minus_E13_13 + b12_5 + b12_12 + T(0.28600000000000003) + b12_14;
  A[187] = J12_11;
  // hc12 = E12^T h12: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc12_2 = E12_22 * h12_2 - E12_23 * h12_3;
  const T hc12_3 = E12_22 * h12_3 + E12_23 * h12_2;
  // B_thetadot16_12 = E13^T B_thetadot16_13
  const T B_thetadot16_12_1 = E13_11 * B_thetadot16_13_1 - minus_E13_13 * minus_B_thetadot16_14_3;
  const T minus_B_thetadot16_12_3 = minus_E13_13 * B_thetadot16_13_1 + E13_11 * minus_B_thetadot16_14_3;
  // K_thetadot16_12 = q13~ E13^T B_thetadot16_13 + E13^T K_thetadot16_13
  const T K_thetadot16_12_1 = minus_E13_13 * K_thetadot16_13_3 - E13_11 * minus_K_thetadot16_13_1 - b13_18 - T(0.65) *
      minus_B_thetadot16_12_3;
  const T b12_17 = T(0.1) * B_thetadot16_12_1;
  const T K_thetadot16_12_2 = b12_17 + T(0.3) * minus_B_thetadot16_12_3 + K_thetadot16_13_2;
  const T K_thetadot16_12_3 = b13_19 - T(0.65) * B_thetadot16_12_1 + minus_E13_13 * minus_K_thetadot16_13_1 + E13_11 *
      K_thetadot16_13_3;
  A[191] = K_thetadot16_12_1;
  A[251] = K_thetadot16_12_1;
  // B_thetadot15_12 = E13^T B_thetadot15_13
  const T B_thetadot15_12_1 = E13_11 * B_thetadot15_13_1 + minus_E13_13 * hc15_2;
  const T B_thetadot15_12_3 = E13_11 * hc15_2 - minus_E13_13 * B_thetadot15_13_1;
  // K_thetadot15_12 = q13~ E13^T B_thetadot15_13 + E13^T K_thetadot15_13
  const T K_thetadot15_12_1 = b13_20 + T(0.65) * B_thetadot15_12_3 + E13_11 * K_thetadot15_13_1 + minus_E13_13 *
      K_thetadot15_13_3;
  const T b12_18 = T(0.1) * B_thetadot15_12_1;
  const T K_thetadot15_12_2 = b12_18 - T(0.3) * B_thetadot15_12_3 + K_thetadot15_13_2;
  const T K_thetadot15_12_3 = E13_11 * K_thetadot15_13_3 - minus_E13_13 * K_thetadot15_13_1 - b13_21 - T(0.65) *
      B_thetadot15_12_1;
  A[190] = K_thetadot15_12_1;
  A[235] = K_thetadot15_12_1;
  // B_thetadot14_12 = E13^T B_thetadot14_13
  const T minus_B_thetadot14_12_1 = E13_11 * hc14_2;
  const T B_thetadot14_12_3 = minus_E13_13 * hc14_2;
  // K_thetadot14_12 = q13~ E13^T B_thetadot14_13 + E13^T K_thetadot14_13
  const T K_thetadot14_12_1 = T(0.65) * B_thetadot14_12_3 - b13_10 + E13_11 * b13_11 + minus_E13_13 * b13_17;
  const T b12_19 = T(0.1) * minus_B_thetadot14_12_1;
  const T K_thetadot14_12_2 = b13_16 - b12_19 - T(0.3) * B_thetadot14_12_3;
  const T K_thetadot14_12_3 = b13_13 + T(0.65) * minus_B_thetadot14_12_1 + E13_11 * b13_17 - minus_E13_13 * b13_11;
  A[189] = K_thetadot14_12_1;
  A[219] = K_thetadot14_12_1;
  // K_thetadot13_12 = q13~ E13^T B_thetadot13_13 + E13^T K_thetadot13_13
  const T K_thetadot13_12_3 = E13_11 * J13_32 - minus_E13_13 * J13_12 - b12_16;
  A[188] = b12_9;
  A[203] = b12_9;

  // ---- body 11 (body_11) and what it carries
  // h11 = m11 r11 + m_sub12 q12 + hc12: first moment of mass carried, about the body origin, body axes [kg m]
  const T h11_1 = T(3.81) + h12_1;
  const T h11_2 = T(7.62) + hc12_2;
  const T h11_3 = T(1.3050000000000002) + hc12_3;
  // J11 = -q12~ hc12~ + E12^T J12 E12 - m11 r11~ r11~ + I11 + (-m_sub12 q12~ - hc12~) q12~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b11_1 = T(0.1) * hc12_3;
  const T b11_2 = T(0.6) * hc12_2;
  const T b11_3 = b11_1 + b11_2 + J12_11;
  const T b11_4 = hc12_3 + T(1.2000000000000002);
  const T b11_5 = b11_4 * T(0.1);
  const T b11_6 = T(7.199999999999999) + hc12_2;
  const T b11_7 = b11_6 * T(0.6);
  const T J11_11 = b11_3 + T(0.29925) + b11_5 + b11_7;
  const T b11_8 = J12_12 * E12_22 - J12_13 * E12_23 - T(0.03150000000000001);
  const T J11_12 = b11_8 - T(0.6) * h12_1 - b11_6 * T(0.3);
  const T J11_13 = J12_12 * E12_23 + J12_13 * E12_22 - T(0.1) * h12_1 - T(0.0042000000000000015) - b11_4 * T(0.3);
  const T b11_9 = T(0.3) * hc12_2;
  const T b11_10 = h12_1 + T(3.5999999999999996);
  const T J11_21 = b11_8 - b11_9 - b11_10 * T(0.6);
  const T b11_11 = E12_22 * J12_22 - E12_23 * J12_32;
  const T b11_12 = E12_22 * J12_23 - E12_23 * J12_33;
  const T b11_13 = T(0.3) * h12_1 + b11_10 * T(0.3);
  const T J11_22 = b11_11 * E12_22 - b11_12 * E12_23 + b11_1 + b11_13 + T(0.27825) + b11_5;
  const T J11_23 = b11_11 * E12_23 + b11_12 * E12_22 - T(0.1) * hc12_2 - T(0.029400000000000003) - b11_4 * T(0.6);
  const T J11_33 = (E12_23 * J12_22 + E12_22 * J12_32) * E12_23 + (E12_23 * J12_23 + E12_22 * J12_33) * E12_22 + b11_2
      + b11_13 + T(0.273) + b11_7;
  A[170] = J11_33;
  // hc11 = E11^T h11: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc11_1 = E11_11 * h11_1 - E11_12 * h11_2;
  const T hc11_2 = E11_11 * h11_2 + E11_12 * h11_1;
  // B_thetadot16_11 = E12^T B_thetadot16_12
  const T B_thetadot16_11_2 = E12_22 * B_thetadot16_13_2 + E12_23 * minus_B_thetadot16_12_3;
  const T B_thetadot16_11_3 = E12_23 * B_thetadot16_13_2 - E12_22 * minus_B_thetadot16_12_3;
  // K_thetadot16_11 = q12~ E12^T B_thetadot16_12 + E12^T K_thetadot16_12
  const T K_thetadot16_11_1 = T(0.6) * B_thetadot16_11_3 - T(0.1) * B_thetadot16_11_2 + K_thetadot16_12_1;
  const T b11_14 = T(0.3) * B_thetadot16_11_3;
  const T K_thetadot16_11_2 = b12_17 - b11_14 + E12_22 * K_thetadot16_12_2 - E12_23 * K_thetadot16_12_3;
  const T K_thetadot16_11_3 = T(0.3) * B_thetadot16_11_2 - T(0.6) * B_thetadot16_12_1 + E12_23 * K_thetadot16_12_2 +
      E12_22 * K_thetadot16_12_3;
  A[175] = K_thetadot16_11_3;
  A[250] = K_thetadot16_11_3;
  // B_thetadot15_11 = E12^T B_thetadot15_12
  const T minus_B_thetadot15_11_2 = E12_22 * minus_B_thetadot15_13_2 + E12_23 * B_thetadot15_12_3;
  const T B_thetadot15_11_3 = E12_22 * B_thetadot15_12_3 - E12_23 * minus_B_thetadot15_13_2;
  // K_thetadot15_11 = q12~ E12^T B_thetadot15_12 + E12^T K_thetadot15_12
  const T K_thetadot15_11_1 = T(0.1) * minus_B_thetadot15_11_2 + T(0.6) * B_thetadot15_11_3 + K_thetadot15_12_1;
  const T b11_15 = T(0.3) * B_thetadot15_11_3;
  const T K_thetadot15_11_2 = b12_18 - b11_15 + E12_22 * K_thetadot15_12_2 - E12_23 * K_thetadot15_12_3;
  const T K_thetadot15_11_3 = E12_23 * K_thetadot15_12_2 + E12_22 * K_thetadot15_12_3 - T(0.3) *
      minus_B_thetadot15_11_2 - T(0.6) * B_thetadot15_12_1;
  A[174] = K_thetadot15_11_3;
  A[234] = K_thetadot15_11_3;
  // B_thetadot14_11 = E12^T B_thetadot14_12
  const T B_thetadot14_11_2 = E12_22 * hc14_1 - E12_23 * B_thetadot14_12_3;
  const T B_thetadot14_11_3 = E12_23 * hc14_1 + E12_22 * B_thetadot14_12_3;
  // K_thetadot14_11 = q12~ E12^T B_thetadot14_12 + E12^T K_thetadot14_12
  const T K_thetadot14_11_1 = T(0.6) * B_thetadot14_11_3 - T(0.1) * B_thetadot14_11_2 + K_thetadot14_12_1;
  const T b11_16 = T(0.3) * B_thetadot14_11_3;
  const T K_thetadot14_11_2 = E12_22 * K_thetadot14_12_2 - E12_23 * K_thetadot14_12_3 - b12_19 - b11_16;
  const T K_thetadot14_11_3 = T(0.3) * B_thetadot14_11_2 + T(0.6) * minus_B_thetadot14_12_1 + E12_23 *
      K_thetadot14_12_2 + E12_22 * K_thetadot14_12_3;
  A[173] = K_thetadot14_11_3;
  A[218] = K_thetadot14_11_3;
  // B_thetadot13_11 = E12^T B_thetadot13_12
  const T B_thetadot13_11_2 = E12_23 * hc13_1;
  const T minus_B_thetadot13_11_3 = E12_22 * hc13_1;
  // K_thetadot13_11 = q12~ E12^T B_thetadot13_12 + E12^T K_thetadot13_12
  const T K_thetadot13_11_1 = b12_9 - T(0.1) * B_thetadot13_11_2 - T(0.6) * minus_B_thetadot13_11_3;
  const T b11_17 = T(0.3) * minus_B_thetadot13_11_3;
  const T K_thetadot13_11_2 = b12_3 + b11_17 + E12_22 * b12_13 - E12_23 * K_thetadot13_12_3;
  const T K_thetadot13_11_3 = T(0.3) * B_thetadot13_11_2 - T(0.6) * hc13_3 + E12_23 * b12_13 + E12_22 *
      K_thetadot13_12_3;
  A[172] = K_thetadot13_11_3;
  A[202] = K_thetadot13_11_3;
  // K_thetadot12_11 = q12~ E12^T B_thetadot12_12 + E12^T K_thetadot12_12
  const T K_thetadot12_11_2 = E12_22 * J12_21 - E12_23 * J12_31 - b11_9;
  const T K_thetadot12_11_3 = E12_23 * J12_21 + E12_22 * J12_31 - T(0.3) * hc12_3;
  A[171] = K_thetadot12_11_3;
  A[186] = K_thetadot12_11_3;

  // ---- body 10 (body_10) and what it carries
  // h10 = m10 r10 + m_sub11 q11 + hc11: first moment of mass carried, about the body origin, body axes [kg m]
  const T h10_1 = T(4.43) + hc11_1;
  const T h10_2 = T(8.155000000000001) + hc11_2;
  const T h10_3 = T(1.51) + h11_3;
  // J10 = -q11~ hc11~ + E11^T J11 E11 - m10 r10~ r10~ + I10 + (-m_sub11 q11~ - hc11~) q11~: inertia carried, about
  //   the body origin, body axes [kg m^2]
  const T b10_1 = E11_11 * J11_11 - E11_12 * J11_21;
  const T b10_2 = E11_11 * J11_12 - E11_12 * J11_22;
  const T b10_3 = h11_3 + T(1.4100000000000001);
  const T b10_4 = T(0.1) * h11_3 + b10_3 * T(0.1);
  const T b10_5 = T(0.55) * hc11_2;
  const T b10_6 = T(7.755000000000001) + hc11_2;
  const T b10_7 = b10_6 * T(0.55);
  const T J10_11 = b10_1 * E11_11 - b10_2 * E11_12 + b10_4 + b10_5 + T(0.28500000000000003) + b10_7;
  const T b10_8 = b10_1 * E11_12 + b10_2 * E11_11 - T(0.030000000000000006);
  const T J10_12 = b10_8 - T(0.55) * hc11_1 - b10_6 * T(0.3);
  const T b10_9 = E11_11 * J11_13 - E11_12 * J11_23;
  const T b10_10 = T(0.1) * hc11_1;
  const T b10_11 = b10_9 - b10_10;
  const T J10_13 = b10_11 - T(0.004000000000000001) - b10_3 * T(0.3);
  const T b10_12 = hc11_1 + T(4.2299999999999995);
  const T J10_21 = b10_8 - T(0.3) * hc11_2 - b10_12 * T(0.55);
  const T b10_13 = T(0.3) * hc11_1;
  const T b10_14 = b10_12 * T(0.3);
  const T J10_22 = (E11_12 * J11_11 + E11_11 * J11_21) * E11_12 + (E11_12 * J11_12 + E11_11 * J11_22) * E11_11 + b10_4
      + b10_13 + T(0.265) + b10_14;
  const T b10_15 = E11_12 * J11_13 + E11_11 * J11_23;
  const T b10_16 = b10_15 - T(0.1) * hc11_2;
  const T J10_23 = b10_16 - T(0.028000000000000004) - b10_3 * T(0.55);
  const T J10_31 = b10_9 - T(0.3) * h11_3 - T(0.004000000000000001) - b10_12 * T(0.1);
  const T J10_32 = b10_15 - T(0.55) * h11_3 - T(0.028000000000000004) - b10_6 * T(0.1);
  const T b10_17 = b10_13 + b10_5 + J11_33;
  const T J10_33 = b10_17 + T(0.26) + b10_7 + b10_14;
  A[153] = J10_22;
  // hc10 = E10^T h10: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc10_1 = minus_E10_13 * h10_3 + E10_11 * h10_1;
  const T hc10_3 = E10_11 * h10_3 - minus_E10_13 * h10_1;
  // B_thetadot16_10 = E11^T B_thetadot16_11
  const T B_thetadot16_10_1 = E11_11 * B_thetadot16_12_1 - E11_12 * B_thetadot16_11_2;
  const T B_thetadot16_10_2 = E11_12 * B_thetadot16_12_1 + E11_11 * B_thetadot16_11_2;
  // K_thetadot16_10 = q11~ E11^T B_thetadot16_11 + E11^T K_thetadot16_11
  const T b10_18 = T(0.1) * B_thetadot16_10_2;
  const T K_thetadot16_10_1 = T(0.55) * B_thetadot16_11_3 - b10_18 + E11_11 * K_thetadot16_11_1 - E11_12 *
      K_thetadot16_11_2;
  const T K_thetadot16_10_2 = T(0.1) * B_thetadot16_10_1 - b11_14 + E11_12 * K_thetadot16_11_1 + E11_11 *
      K_thetadot16_11_2;
  const T b10_19 = T(0.3) * B_thetadot16_10_2;
  const T K_thetadot16_10_3 = b10_19 - T(0.55) * B_thetadot16_10_1 + K_thetadot16_11_3;
  A[159] = K_thetadot16_10_2;
  A[249] = K_thetadot16_10_2;
  // B_thetadot15_10 = E11^T B_thetadot15_11
  const T B_thetadot15_10_1 = E11_11 * B_thetadot15_12_1 + E11_12 * minus_B_thetadot15_11_2;
  const T B_thetadot15_10_2 = E11_12 * B_thetadot15_12_1 - E11_11 * minus_B_thetadot15_11_2;
  // K_thetadot15_10 = q11~ E11^T B_thetadot15_11 + E11^T K_thetadot15_11
  const T b10_20 = T(0.1) * B_thetadot15_10_2;
  const T K_thetadot15_10_1 = T(0.55) * B_thetadot15_11_3 - b10_20 + E11_11 * K_thetadot15_11_1 - E11_12 *
      K_thetadot15_11_2;
  const T K_thetadot15_10_2 = T(0.1) * B_thetadot15_10_1 - b11_15 + E11_12 * K_thetadot15_11_1 + E11_11 *
      K_thetadot15_11_2;
  const T b10_21 = T(0.3) * B_thetadot15_10_2;
  const T K_thetadot15_10_3 = b10_21 - T(0.55) * B_thetadot15_10_1 + K_thetadot15_11_3;
  A[158] = K_thetadot15_10_2;
  A[233] = K_thetadot15_10_2;
  // B_thetadot14_10 = E11^T B_thetadot14_11
  const T minus_B_thetadot14_10_1 = E11_11 * minus_B_thetadot14_12_1 + E11_12 * B_thetadot14_11_2;
  const T B_thetadot14_10_2 = E11_11 * B_thetadot14_11_2 - E11_12 * minus_B_thetadot14_12_1;
  // K_thetadot14_10 = q11~ E11^T B_thetadot14_11 + E11^T K_thetadot14_11
  const T b10_22 = T(0.1) * B_thetadot14_10_2;
  const T K_thetadot14_10_1 = T(0.55) * B_thetadot14_11_3 - b10_22 + E11_11 * K_thetadot14_11_1 - E11_12 *
      K_thetadot14_11_2;
  const T K_thetadot14_10_2 = E11_12 * K_thetadot14_11_1 + E11_11 * K_thetadot14_11_2 - T(0.1) *
      minus_B_thetadot14_10_1 - b11_16;
  const T b10_23 = T(0.3) * B_thetadot14_10_2;
  const T K_thetadot14_10_3 = b10_23 + T(0.55) * minus_B_thetadot14_10_1 + K_thetadot14_11_3;
  A[157] = K_thetadot14_10_2;
  A[217] = K_thetadot14_10_2;
  // B_thetadot13_10 = E11^T B_thetadot13_11
  const T B_thetadot13_10_1 = E11_11 * hc13_3 - E11_12 * B_thetadot13_11_2;
  const T B_thetadot13_10_2 = E11_12 * hc13_3 + E11_11 * B_thetadot13_11_2;
  // K_thetadot13_10 = q11~ E11^T B_thetadot13_11 + E11^T K_thetadot13_11
  const T b10_24 = T(0.1) * B_thetadot13_10_2;
  const T K_thetadot13_10_1 = E11_11 * K_thetadot13_11_1 - E11_12 * K_thetadot13_11_2 - b10_24 - T(0.55) *
      minus_B_thetadot13_11_3;
  const T K_thetadot13_10_2 = T(0.1) * B_thetadot13_10_1 + b11_17 + E11_12 * K_thetadot13_11_1 + E11_11 *
      K_thetadot13_11_2;
  const T b10_25 = T(0.3) * B_thetadot13_10_2;
  const T K_thetadot13_10_3 = b10_25 - T(0.55) * B_thetadot13_10_1 + K_thetadot13_11_3;
  A[156] = K_thetadot13_10_2;
  A[201] = K_thetadot13_10_2;
  // B_thetadot12_10 = E11^T B_thetadot12_11
  const T B_thetadot12_10_1 = E11_12 * hc12_3;
  const T minus_B_thetadot12_10_2 = E11_11 * hc12_3;
  // K_thetadot12_10 = q11~ E11^T B_thetadot12_11 + E11^T K_thetadot12_11
  const T b10_26 = T(0.1) * minus_B_thetadot12_10_2;
  const T K_thetadot12_10_1 = b10_26 + T(0.55) * hc12_2 + E11_11 * b11_3 - E11_12 * K_thetadot12_11_2;
  const T K_thetadot12_10_2 = T(0.1) * B_thetadot12_10_1 - b11_9 + E11_12 * b11_3 + E11_11 * K_thetadot12_11_2;
  const T b10_27 = T(0.3) * minus_B_thetadot12_10_2;
  const T K_thetadot12_10_3 = K_thetadot12_11_3 - b10_27 - T(0.55) * B_thetadot12_10_1;
  A[155] = K_thetadot12_10_2;
  A[185] = K_thetadot12_10_2;
  A[154] = b10_16;
  A[169] = b10_16;

  // ---- body 9 (body_9) and what it carries
  // h9 = m9 r9 + m_sub10 q10 + hc10: first moment of mass carried, about the body origin, body axes [kg m]
  const T h9_1 = T(5.02) + hc10_1;
  const T h9_2 = T(8.43) + h10_2;
  const T h9_3 = T(1.705) + hc10_3;
  // J9 = -q10~ hc10~ + E10^T J10 E10 - m9 r9~ r9~ + I9 + (-m_sub10 q10~ - hc10~) q10~: inertia carried, about the
  //   body origin, body axes [kg m^2]
  const T b9_1 = E10_11 * J10_11 + minus_E10_13 * J10_31;
  const T b9_2 = E10_11 * J10_13 + minus_E10_13 * J10_33;
  const T b9_3 = T(0.1) * hc10_3;
  const T b9_4 = T(8.05) + h10_2;
  const T b9_5 = T(0.5) * h10_2 + b9_4 * T(0.5);
  const T b9_6 = hc10_3 + T(1.61);
  const T b9_7 = b9_6 * T(0.1);
  const T J9_11 = b9_1 * E10_11 + b9_2 * minus_E10_13 + b9_3 + b9_5 + T(0.27075) + b9_7;
  const T b9_8 = E10_11 * J10_12 + minus_E10_13 * J10_32;
  const T b9_9 = b9_8 - T(0.5) * hc10_1;
  const T J9_12 = b9_9 - T(0.0285) - b9_4 * T(0.3);
  const T b9_10 = b9_2 * E10_11 - b9_1 * minus_E10_13 - T(0.0038000000000000004);
  const T J9_13 = b9_10 - T(0.1) * hc10_1 - b9_6 * T(0.3);
  const T b9_11 = hc10_1 + T(4.83);
  const T J9_21 = b9_8 - T(0.3) * h10_2 - T(0.0285) - b9_11 * T(0.5);
  const T b9_12 = T(0.3) * hc10_1;
  const T b9_13 = b9_3 + b9_12 + J10_22;
  const T b9_14 = b9_11 * T(0.3);
  const T J9_22 = b9_13 + T(0.25175000000000003) + b9_7 + b9_14;
  const T b9_15 = J10_23 * E10_11 - J10_21 * minus_E10_13 - T(0.026600000000000002);
  const T J9_23 = b9_15 - T(0.1) * h10_2 - b9_6 * T(0.5);
  const T J9_31 = b9_10 - T(0.3) * hc10_3 - b9_11 * T(0.1);
  const T b9_16 = T(0.5) * hc10_3;
  const T J9_32 = b9_15 - b9_16 - b9_4 * T(0.1);
  const T J9_33 = (E10_11 * J10_33 - minus_E10_13 * J10_13) * E10_11 - (E10_11 * J10_31 - minus_E10_13 * J10_11) *
      minus_E10_13 + b9_5 + b9_12 + T(0.247) + b9_14;
  A[136] = J9_11;
  // hc9 = E9^T h9: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc9_2 = E9_22 * h9_2 - E9_23 * h9_3;
  const T hc9_3 = E9_22 * h9_3 + E9_23 * h9_2;
  // B_thetadot16_9 = E10^T B_thetadot16_10
  const T B_thetadot16_9_1 = E10_11 * B_thetadot16_10_1 + minus_E10_13 * B_thetadot16_11_3;
  const T B_thetadot16_9_3 = E10_11 * B_thetadot16_11_3 - minus_E10_13 * B_thetadot16_10_1;
  // K_thetadot16_9 = q10~ E10^T B_thetadot16_10 + E10^T K_thetadot16_10
  const T K_thetadot16_9_1 = T(0.5) * B_thetadot16_9_3 - b10_18 + E10_11 * K_thetadot16_10_1 + minus_E10_13 *
      K_thetadot16_10_3;
  const T b9_17 = T(0.1) * B_thetadot16_9_1;
  const T K_thetadot16_9_2 = b9_17 - T(0.3) * B_thetadot16_9_3 + K_thetadot16_10_2;
  const T K_thetadot16_9_3 = b10_19 - T(0.5) * B_thetadot16_9_1 + E10_11 * K_thetadot16_10_3 - minus_E10_13 *
      K_thetadot16_10_1;
  A[143] = K_thetadot16_9_1;
  A[248] = K_thetadot16_9_1;
  // B_thetadot15_9 = E10^T B_thetadot15_10
  const T B_thetadot15_9_1 = E10_11 * B_thetadot15_10_1 + minus_E10_13 * B_thetadot15_11_3;
  const T B_thetadot15_9_3 = E10_11 * B_thetadot15_11_3 - minus_E10_13 * B_thetadot15_10_1;
  // K_thetadot15_9 = q10~ E10^T B_thetadot15_10 + E10^T K_thetadot15_10
  const T K_thetadot15_9_1 = T(0.5) * B_thetadot15_9_3 - b10_20 + E10_11 * K_thetadot15_10_1 + minus_E10_13 *
      K_thetadot15_10_3;
  const T b9_18 = T(0.1) * B_thetadot15_9_1;
  const T K_thetadot15_9_2 = b9_18 - T(0.3) * B_thetadot15_9_3 + K_thetadot15_10_2;
  const T K_thetadot15_9_3 = b10_21 - T(0.5) * B_thetadot15_9_1 + E10_11 * K_thetadot15_10_3 - minus_E10_13 *
      K_thetadot15_10_1;
  A[142] = K_thetadot15_9_1;
  A[232] = K_thetadot15_9_1;
  // B_thetadot14_9 = E10^T B_thetadot14_10
  const T B_thetadot14_9_1 = minus_E10_13 * B_thetadot14_11_3 - E10_11 * minus_B_thetadot14_10_1;
  const T B_thetadot14_9_3 = minus_E10_13 * minus_B_thetadot14_10_1 + E10_11 * B_thetadot14_11_3;
  // K_thetadot14_9 = q10~ E10^T B_thetadot14_10 + E10^T K_thetadot14_10
  const T K_thetadot14_9_1 = T(0.5) * B_thetadot14_9_3 - b10_22 + E10_11 * K_thetadot14_10_1 + minus_E10_13 *
      K_thetadot14_10_3;
  const T b9_19 = T(0.1) * B_thetadot14_9_1;
  const T K_thetadot14_9_2 = b9_19 - T(0.3) * B_thetadot14_9_3 + K_thetadot14_10_2;
  const T K_thetadot14_9_3 = b10_23 - T(0.5) * B_thetadot14_9_1 + E10_11 * K_thetadot14_10_3 - minus_E10_13 *
      K_thetadot14_10_1;
  A[141] = K_thetadot14_9_1;
  A[216] = K_thetadot14_9_1;
  // B_thetadot13_9 = E10^T B_thetadot13_10
  const T B_thetadot13_9_1 = E10_11 * B_thetadot13_10_1 - minus_E10_13 * minus_B_thetadot13_11_3;
  const T minus_B_thetadot13_9_3 = minus_E10_13 * B_thetadot13_10_1 + E10_11 * minus_B_thetadot13_11_3;
  // K_thetadot13_9 = q10~ E10^T B_thetadot13_10 + E10^T K_thetadot13_10
  const T K_thetadot13_9_1 = E10_11 * K_thetadot13_10_1 + minus_E10_13 * K_thetadot13_10_3 - b10_24 - T(0.5) *
      minus_B_thetadot13_9_3;
  const T b9_20 = T(0.1) * B_thetadot13_9_1;
  const T K_thetadot13_9_2 = b9_20 + T(0.3) * minus_B_thetadot13_9_3 + K_thetadot13_10_2;
  const T K_thetadot13_9_3 = b10_25 - T(0.5) * B_thetadot13_9_1 + E10_11 * K_thetadot13_10_3 - minus_E10_13 *
      K_thetadot13_10_1;
  A[140] = K_thetadot13_9_1;
  A[200] = K_thetadot13_9_1;
  // B_thetadot12_9 = E10^T B_thetadot12_10
  const T B_thetadot12_9_1 = E10_11 * B_thetadot12_10_1 + minus_E10_13 * hc12_2;
  const T B_thetadot12_9_3 = E10_11 * hc12_2 - minus_E10_13 * B_thetadot12_10_1;
  // K_thetadot12_9 = q10~ E10^T B_thetadot12_10 + E10^T K_thetadot12_10
  const T K_thetadot12_9_1 = b10_26 + T(0.5) * B_thetadot12_9_3 + E10_11 * K_thetadot12_10_1 + minus_E10_13 *
      K_thetadot12_10_3;
  const T b9_21 = T(0.1) * B_thetadot12_9_1;
  const T K_thetadot12_9_2 = b9_21 - T(0.3) * B_thetadot12_9_3 + K_thetadot12_10_2;
  const T K_thetadot12_9_3 = E10_11 * K_thetadot12_10_3 - minus_E10_13 * K_thetadot12_10_1 - b10_27 - T(0.5) *
      B_thetadot12_9_1;
  A[139] = K_thetadot12_9_1;
  A[184] = K_thetadot12_9_1;
  // B_thetadot11_9 = E10^T B_thetadot11_10
  const T minus_B_thetadot11_9_1 = E10_11 * hc11_2;
  const T B_thetadot11_9_3 = minus_E10_13 * hc11_2;
  // K_thetadot11_9 = q10~ E10^T B_thetadot11_10 + E10^T K_thetadot11_10
  const T K_thetadot11_9_1 = T(0.5) * B_thetadot11_9_3 - b10_10 + E10_11 * b10_11 + minus_E10_13 * b10_17;
  const T b9_22 = T(0.1) * minus_B_thetadot11_9_1;
  const T K_thetadot11_9_2 = b10_16 - b9_22 - T(0.3) * B_thetadot11_9_3;
  const T K_thetadot11_9_3 = b10_13 + T(0.5) * minus_B_thetadot11_9_1 + E10_11 * b10_17 - minus_E10_13 * b10_11;
  A[138] = K_thetadot11_9_1;
  A[168] = K_thetadot11_9_1;
  // K_thetadot10_9 = q10~ E10^T B_thetadot10_10 + E10^T K_thetadot10_10
  const T K_thetadot10_9_3 = E10_11 * J10_32 - minus_E10_13 * J10_12 - b9_16;
  A[137] = b9_9;
  A[152] = b9_9;

  // ---- body 8 (body_8) and what it carries
  // h8 = m8 r8 + m_sub9 q9 + hc9: first moment of mass carried, about the body origin, body axes [kg m]
  const T h8_1 = T(5.58) + h9_1;
  const T h8_2 = T(8.46) + hc9_2;
  const T h8_3 = T(1.8900000000000001) + hc9_3;
  // J8 = -q9~ hc9~ + E9^T J9 E9 - m8 r8~ r8~ + I8 + (-m_sub9 q9~ - hc9~) q9~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b8_1 = T(0.1) * hc9_3;
  const T b8_2 = T(0.45) * hc9_2;
  const T b8_3 = b8_1 + b8_2 + J9_11;
  const T b8_4 = hc9_3 + T(1.8);
  const T b8_5 = b8_4 * T(0.1);
  const T b8_6 = T(8.1) + hc9_2;
  const T b8_7 = b8_6 * T(0.45);
  const T J8_11 = b8_3 + T(0.2565) + b8_5 + b8_7;
  const T b8_8 = J9_12 * E9_22 - J9_13 * E9_23 - T(0.027000000000000007);
  const T J8_12 = b8_8 - T(0.45) * h9_1 - b8_6 * T(0.3);
  const T J8_13 = J9_12 * E9_23 + J9_13 * E9_22 - T(0.1) * h9_1 - T(0.0036000000000000008) - b8_4 * T(0.3);
  const T b8_9 = T(0.3) * hc9_2;
  const T b8_10 = h9_1 + T(5.3999999999999995);
  const T J8_21 = b8_8 - b8_9 - b8_10 * T(0.45);
  const T b8_11 = E9_22 * J9_22 - E9_23 * J9_32;
  const T b8_12 = E9_22 * J9_23 - E9_23 * J9_33;
  const T b8_13 = T(0.3) * h9_1 + b8_10 * T(0.3);
  const T J8_22 = b8_11 * E9_22 - b8_12 * E9_23 + b8_1 + b8_13 + T(0.2385) + b8_5;
  const T J8_23 = b8_11 * E9_23 + b8_12 * E9_22 - T(0.1) * hc9_2 - T(0.025200000000000004) - b8_4 * T(0.45);
  const T J8_33 = (E9_23 * J9_22 + E9_22 * J9_32) * E9_23 + (E9_23 * J9_23 + E9_22 * J9_33) * E9_22 + b8_2 + b8_13 +
      T(0.234) + b8_7;
  A[119] = J8_33;
  // hc8 = E8^T h8: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc8_1 = E8_11 * h8_1 - E8_12 * h8_2;
  const T hc8_2 = E8_11 * h8_2 + E8_12 * h8_1;
  // B_thetadot16_8 = E9^T B_thetadot16_9
  const T B_thetadot16_8_2 = E9_22 * B_thetadot16_10_2 - E9_23 * B_thetadot16_9_3;
  const T B_thetadot16_8_3 = E9_23 * B_thetadot16_10_2 + E9_22 * B_thetadot16_9_3;
  // K_thetadot16_8 = q9~ E9^T B_thetadot16_9 + E9^T K_thetadot16_9
  const T K_thetadot16_8_1 = T(0.45) * B_thetadot16_8_3 - T(0.1) * B_thetadot16_8_2 + K_thetadot16_9_1;
  const T b8_14 = T(0.3) * B_thetadot16_8_3;
  const T K_thetadot16_8_2 = b9_17 - b8_14 + E9_22 * K_thetadot16_9_2 - E9_23 * K_thetadot16_9_3;
  const T K_thetadot16_8_3 = T(0.3) * B_thetadot16_8_2 - T(0.45) * B_thetadot16_9_1 + E9_23 * K_thetadot16_9_2 + E9_22
      * K_thetadot16_9_3;
  A[127] = K_thetadot16_8_3;
  A[247] = K_thetadot16_8_3;
  // B_thetadot15_8 = E9^T B_thetadot15_9
  const T B_thetadot15_8_2 = E9_22 * B_thetadot15_10_2 - E9_23 * B_thetadot15_9_3;
  const T B_thetadot15_8_3 = E9_23 * B_thetadot15_10_2 + E9_22 * B_thetadot15_9_3;
  // K_thetadot15_8 = q9~ E9^T B_thetadot15_9 + E9^T K_thetadot15_9
  const T K_thetadot15_8_1 = T(0.45) * B_thetadot15_8_3 - T(0.1) * B_thetadot15_8_2 + K_thetadot15_9_1;
  const T b8_15 = T(0.3) * B_thetadot15_8_3;
  const T K_thetadot15_8_2 = b9_18 - b8_15 + E9_22 * K_thetadot15_9_2 - E9_23 * K_thetadot15_9_3;
  const T K_thetadot15_8_3 = T(0.3) * B_thetadot15_8_2 - T(0.45) * B_thetadot15_9_1 + E9_23 * K_thetadot15_9_2 + E9_22
      * K_thetadot15_9_3;
  A[126] = K_thetadot15_8_3;
  A[231] = K_thetadot15_8_3;
  // B_thetadot14_8 = E9^T B_thetadot14_9
  const T B_thetadot14_8_2 = E9_22 * B_thetadot14_10_2 - E9_23 * B_thetadot14_9_3;
  const T B_thetadot14_8_3 = E9_23 * B_thetadot14_10_2 + E9_22 * B_thetadot14_9_3;
  // K_thetadot14_8 = q9~ E9^T B_thetadot14_9 + E9^T K_thetadot14_9
  const T K_thetadot14_8_1 = T(0.45) * B_thetadot14_8_3 - T(0.1) * B_thetadot14_8_2 + K_thetadot14_9_1;
  const T b8_16 = T(0.3) * B_thetadot14_8_3;
  const T K_thetadot14_8_2 = b9_19 - b8_16 + E9_22 * K_thetadot14_9_2 - E9_23 * K_thetadot14_9_3;
  const T K_thetadot14_8_3 = T(0.3) * B_thetadot14_8_2 - T(0.45) * B_thetadot14_9_1 + E9_23 * K_thetadot14_9_2 + E9_22
      * K_thetadot14_9_3;
  A[125] = K_thetadot14_8_3;
  A[215] = K_thetadot14_8_3;
  // B_thetadot13_8 = E9^T B_thetadot13_9
  const T B_thetadot13_8_2 = E9_22 * B_thetadot13_10_2 + E9_23 * minus_B_thetadot13_9_3;
  const T B_thetadot13_8_3 = E9_23 * B_thetadot13_10_2 - E9_22 * minus_B_thetadot13_9_3;
  // K_thetadot13_8 = q9~ E9^T B_thetadot13_9 + E9^T K_thetadot13_9
  const T K_thetadot13_8_1 = T(0.45) * B_thetadot13_8_3 - T(0.1) * B_thetadot13_8_2 + K_thetadot13_9_1;
  const T b8_17 = T(0.3) * B_thetadot13_8_3;
  const T K_thetadot13_8_2 = b9_20 - b8_17 + E9_22 * K_thetadot13_9_2 - E9_23 * K_thetadot13_9_3;
  const T K_thetadot13_8_3 = T(0.3) * B_thetadot13_8_2 - T(0.45) * B_thetadot13_9_1 + E9_23 * K_thetadot13_9_2 + E9_22
      * K_thetadot13_9_3;
  A[124] = K_thetadot13_8_3;
  A[199] = K_thetadot13_8_3;
  // B_thetadot12_8 = E9^T B_thetadot12_9
  const T minus_B_thetadot12_8_2 = E9_22 * minus_B_thetadot12_10_2 + E9_23 * B_thetadot12_9_3;
  const T B_thetadot12_8_3 = E9_22 * B_thetadot12_9_3 - E9_23 * minus_B_thetadot12_10_2;
  // K_thetadot12_8 = q9~ E9^T B_thetadot12_9 + E9^T K_thetadot12_9
  const T K_thetadot12_8_1 = T(0.1) * minus_B_thetadot12_8_2 + T(0.45) * B_thetadot12_8_3 + K_thetadot12_9_1;
  const T b8_18 = T(0.3) * B_thetadot12_8_3;
  const T K_thetadot12_8_2 = b9_21 - b8_18 + E9_22 * K_thetadot12_9_2 - E9_23 * K_thetadot12_9_3;
  const T K_thetadot12_8_3 = E9_23 * K_thetadot12_9_2 + E9_22 * K_thetadot12_9_3 - T(0.3) * minus_B_thetadot12_8_2 -
      T(0.45) * B_thetadot12_9_1;
  A[123] = K_thetadot12_8_3;
  A[183] = K_thetadot12_8_3;
  // B_thetadot11_8 = E9^T B_thetadot11_9
  const T B_thetadot11_8_2 = E9_22 * hc11_1 - E9_23 * B_thetadot11_9_3;
  const T B_thetadot11_8_3 = E9_23 * hc11_1 + E9_22 * B_thetadot11_9_3;
  // K_thetadot11_8 = q9~ E9^T B_thetadot11_9 + E9^T K_thetadot11_9
  const T K_thetadot11_8_1 = T(0.45) * B_thetadot11_8_3 - T(0.1) * B_thetadot11_8_2 + K_thetadot11_9_1;
  const T b8_19 = T(0.3) * B_thetadot11_8_3;
  const T K_thetadot11_8_2 = E9_22 * K_thetadot11_9_2 - E9_23 * K_thetadot11_9_3 - b9_22 - b8_19;
  const T K_thetadot11_8_3 = T(0.3) * B_thetadot11_8_2 + T(0.45) * minus_B_thetadot11_9_1 + E9_23 * K_thetadot11_9_2 +
      E9_22 * K_thetadot11_9_3;
  A[122] = K_thetadot11_8_3;
  A[167] = K_thetadot11_8_3;
  // B_thetadot10_8 = E9^T B_thetadot10_9
  const T B_thetadot10_8_2 = E9_23 * hc10_1;
  const T minus_B_thetadot10_8_3 = E9_22 * hc10_1;
  // K_thetadot10_8 = q9~ E9^T B_thetadot10_9 + E9^T K_thetadot10_9
  const T K_thetadot10_8_1 = b9_9 - T(0.1) * B_thetadot10_8_2 - T(0.45) * minus_B_thetadot10_8_3;
  const T b8_20 = T(0.3) * minus_B_thetadot10_8_3;
  const T K_thetadot10_8_2 = b9_3 + b8_20 + E9_22 * b9_13 - E9_23 * K_thetadot10_9_3;
  const T K_thetadot10_8_3 = T(0.3) * B_thetadot10_8_2 - T(0.45) * hc10_3 + E9_23 * b9_13 + E9_22 * K_thetadot10_9_3;
  A[121] = K_thetadot10_8_3;
  A[151] = K_thetadot10_8_3;
  // K_thetadot9_8 = q9~ E9^T B_thetadot9_9 + E9^T K_thetadot9_9
  const T K_thetadot9_8_2 = E9_22 * J9_21 - E9_23 * J9_31 - b8_9;
  const T K_thetadot9_8_3 = E9_23 * J9_21 + E9_22 * J9_31 - T(0.3) * hc9_3;
  A[120] = K_thetadot9_8_3;
  A[135] = K_thetadot9_8_3;

  // ---- body 7 (body_7) and what it carries
  // h7 = m7 r7 + m_sub8 q8 + hc8: first moment of mass carried, about the body origin, body axes [kg m]
  const T h7_1 = T(6.109999999999999) + hc8_1;
  const T h7_2 = T(8.26) + hc8_2;
  const T h7_3 = T(2.065) + h8_3;
  // J7 = -q8~ hc8~ + E8^T J8 E8 - m7 r7~ r7~ + I7 + (-m_sub8 q8~ - hc8~) q8~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b7_1 = E8_11 * J8_11 - E8_12 * J8_21;
  const T b7_2 = E8_11 * J8_12 - E8_12 * J8_22;
  const T b7_3 = h8_3 + T(1.9800000000000002);
  const T b7_4 = T(0.1) * h8_3 + b7_3 * T(0.1);
  const T b7_5 = T(0.4) * hc8_2;
  const T b7_6 = T(7.920000000000001) + hc8_2;
  const T b7_7 = b7_6 * T(0.4);
  const T J7_11 = b7_1 * E8_11 - b7_2 * E8_12 + b7_4 + b7_5 + T(0.24225000000000002) + b7_7;
  const T b7_8 = b7_1 * E8_12 + b7_2 * E8_11 - T(0.025500000000000002);
  const T J7_12 = b7_8 - T(0.4) * hc8_1 - b7_6 * T(0.3);
  const T b7_9 = E8_11 * J8_13 - E8_12 * J8_23;
  const T b7_10 = T(0.1) * hc8_1;
  const T b7_11 = b7_9 - b7_10;
  const T J7_13 = b7_11 - T(0.0034000000000000002) - b7_3 * T(0.3);
  const T b7_12 = hc8_1 + T(5.9399999999999995);
  const T J7_21 = b7_8 - T(0.3) * hc8_2 - b7_12 * T(0.4);
  const T b7_13 = T(0.3) * hc8_1;
  const T b7_14 = b7_12 * T(0.3);
  const T J7_22 = (E8_12 * J8_11 + E8_11 * J8_21) * E8_12 + (E8_12 * J8_12 + E8_11 * J8_22) * E8_11 + b7_4 + b7_13 +
      T(0.22524999999999998) + b7_14;
  const T b7_15 = E8_12 * J8_13 + E8_11 * J8_23;
  const T b7_16 = b7_15 - T(0.1) * hc8_2;
  const T J7_23 = b7_16 - T(0.0238) - b7_3 * T(0.4);
  const T J7_31 = b7_9 - T(0.3) * h8_3 - T(0.0034000000000000002) - b7_12 * T(0.1);
  const T J7_32 = b7_15 - T(0.4) * h8_3 - T(0.0238) - b7_6 * T(0.1);
  const T b7_17 = b7_13 + b7_5 + J8_33;
  const T J7_33 = b7_17 + T(0.22100000000000003) + b7_7 + b7_14;
  A[102] = J7_22;
  // hc7 = E7^T h7: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc7_1 = minus_E7_13 * h7_3 + E7_11 * h7_1;
  const T hc7_3 = E7_11 * h7_3 - minus_E7_13 * h7_1;
  // B_thetadot16_7 = E8^T B_thetadot16_8
  const T B_thetadot16_7_1 = E8_11 * B_thetadot16_9_1 - E8_12 * B_thetadot16_8_2;
  const T B_thetadot16_7_2 = E8_12 * B_thetadot16_9_1 + E8_11 * B_thetadot16_8_2;
  // K_thetadot16_7 = q8~ E8^T B_thetadot16_8 + E8^T K_thetadot16_8
  const T b7_18 = T(0.1) * B_thetadot16_7_2;
  const T K_thetadot16_7_1 = T(0.4) * B_thetadot16_8_3 - b7_18 + E8_11 * K_thetadot16_8_1 - E8_12 * K_thetadot16_8_2;
  const T K_thetadot16_7_2 = T(0.1) * B_thetadot16_7_1 - b8_14 + E8_12 * K_thetadot16_8_1 + E8_11 * K_thetadot16_8_2;
  const T b7_19 = T(0.3) * B_thetadot16_7_2;
  const T K_thetadot16_7_3 = b7_19 - T(0.4) * B_thetadot16_7_1 + K_thetadot16_8_3;
  A[111] = K_thetadot16_7_2;
  A[246] = K_thetadot16_7_2;
  // B_thetadot15_7 = E8^T B_thetadot15_8
  const T B_thetadot15_7_1 = E8_11 * B_thetadot15_9_1 - E8_12 * B_thetadot15_8_2;
  const T B_thetadot15_7_2 = E8_12 * B_thetadot15_9_1 + E8_11 * B_thetadot15_8_2;
  // K_thetadot15_7 = q8~ E8^T B_thetadot15_8 + E8^T K_thetadot15_8
  const T b7_20 = T(0.1) * B_thetadot15_7_2;
  const T K_thetadot15_7_1 = T(0.4) * B_thetadot15_8_3 - b7_20 + E8_11 * K_thetadot15_8_1 - E8_12 * K_thetadot15_8_2;
  const T K_thetadot15_7_2 = T(0.1) * B_thetadot15_7_1 - b8_15 + E8_12 * K_thetadot15_8_1 + E8_11 * K_thetadot15_8_2;
  const T b7_21 = T(0.3) * B_thetadot15_7_2;
  const T K_thetadot15_7_3 = b7_21 - T(0.4) * B_thetadot15_7_1 + K_thetadot15_8_3;
  A[110] = K_thetadot15_7_2;
  A[230] = K_thetadot15_7_2;
  // B_thetadot14_7 = E8^T B_thetadot14_8
  const T B_thetadot14_7_1 = E8_11 * B_thetadot14_9_1 - E8_12 * B_thetadot14_8_2;
  const T B_thetadot14_7_2 = E8_12 * B_thetadot14_9_1 + E8_11 * B_thetadot14_8_2;
  // K_thetadot14_7 = q8~ E8^T B_thetadot14_8 + E8^T K_thetadot14_8
  const T b7_22 = T(0.1) * B_thetadot14_7_2;
  const T K_thetadot14_7_1 = T(0.4) * B_thetadot14_8_3 - b7_22 + E8_11 * K_thetadot14_8_1 - E8_12 * K_thetadot14_8_2;
  const T K_thetadot14_7_2 = T(0.1) * B_thetadot14_7_1 - b8_16 + E8_12 * K_thetadot14_8_1 + E8_11 * K_thetadot14_8_2;
  const T b7_23 = T(0.3) * B_thetadot14_7_2;
  const T K_thetadot14_7_3 = b7_23 - T(0.4) * B_thetadot14_7_1 + K_thetadot14_8_3;
  A[109] = K_thetadot14_7_2;
  A[214] = K_thetadot14_7_2;
  // B_thetadot13_7 = E8^T B_thetadot13_8
  const T B_thetadot13_7_1 = E8_11 * B_thetadot13_9_1 - E8_12 * B_thetadot13_8_2;
  const T B_thetadot13_7_2 = E8_12 * B_thetadot13_9_1 + E8_11 * B_thetadot13_8_2;
  // K_thetadot13_7 = q8~ E8^T B_thetadot13_8 + E8^T K_thetadot13_8
  const T b7_24 = T(0.1) * B_thetadot13_7_2;
  const T K_thetadot13_7_1 = T(0.4) * B_thetadot13_8_3 - b7_24 + E8_11 * K_thetadot13_8_1 - E8_12 * K_thetadot13_8_2;
  const T K_thetadot13_7_2 = T(0.1) * B_thetadot13_7_1 - b8_17 + E8_12 * K_thetadot13_8_1 + E8_11 * K_thetadot13_8_2;
  const T b7_25 = T(0.3) * B_thetadot13_7_2;
  const T K_thetadot13_7_3 = b7_25 - T(0.4) * B_thetadot13_7_1 + K_thetadot13_8_3;
  A[108] = K_thetadot13_7_2;
  A[198] = K_thetadot13_7_2;
  // B_thetadot12_7 = E8^T B_thetadot12_8
  const T B_thetadot12_7_1 = E8_11 * B_thetadot12_9_1 + E8_12 * minus_B_thetadot12_8_2;
  const T B_thetadot12_7_2 = E8_12 * B_thetadot12_9_1 - E8_11 * minus_B_thetadot12_8_2;
  // K_thetadot12_7 = q8~ E8^T B_thetadot12_8 + E8^T K_thetadot12_8
  const T b7_26 = T(0.1) * B_thetadot12_7_2;
  const T K_thetadot12_7_1 = T(0.4) * B_thetadot12_8_3 - b7_26 + E8_11 * K_thetadot12_8_1 - E8_12 * K_thetadot12_8_2;
  const T K_thetadot12_7_2 = T(0.1) * B_thetadot12_7_1 - b8_18 + E8_12 * K_thetadot12_8_1 + E8_11 * K_thetadot12_8_2;
  const T b7_27 = T(0.3) * B_thetadot12_7_2;
  const T K_thetadot12_7_3 = b7_27 - T(0.4) * B_thetadot12_7_1 + K_thetadot12_8_3;
  A[107] = K_thetadot12_7_2;
  A[182] = K_thetadot12_7_2;
  // B_thetadot11_7 = E8^T B_thetadot11_8
  const T minus_B_thetadot11_7_1 = E8_11 * minus_B_thetadot11_9_1 + E8_12 * B_thetadot11_8_2;
  const T B_thetadot11_7_2 = E8_11 * B_thetadot11_8_2 - E8_12 * minus_B_thetadot11_9_1;
  // K_thetadot11_7 = q8~ E8^T B_thetadot11_8 + E8^T K_thetadot11_8
  const T b7_28 = T(0.1) * B_thetadot11_7_2;
  const T K_thetadot11_7_1 = T(0.4) * B_thetadot11_8_3 - b7_28 + E8_11 * K_thetadot11_8_1 - E8_12 * K_thetadot11_8_2;
  const T K_thetadot11_7_2 = E8_12 * K_thetadot11_8_1 + E8_11 * K_thetadot11_8_2 - T(0.1) * minus_B_thetadot11_7_1 -
      b8_19;
  const T b7_29 = T(0.3) * B_thetadot11_7_2;
  const T K_thetadot11_7_3 = b7_29 + T(0.4) * minus_B_thetadot11_7_1 + K_thetadot11_8_3;
  A[106] = K_thetadot11_7_2;
  A[166] = K_thetadot11_7_2;
  // B_thetadot10_7 = E8^T B_thetadot10_8
  const T B_thetadot10_7_1 = E8_11 * hc10_3 - E8_12 * B_thetadot10_8_2;
  const T B_thetadot10_7_2 = E8_12 * hc10_3 + E8_11 * B_thetadot10_8_2;
  // K_thetadot10_7 = q8~ E8^T B_thetadot10_8 + E8^T K_thetadot10_8
  const T b7_30 = T(0.1) * B_thetadot10_7_2;
  const T K_thetadot10_7_1 = E8_11 * K_thetadot10_8_1 - E8_12 * K_thetadot10_8_2 - b7_30 - T(0.4) *
      minus_B_thetadot10_8_3;
  const T K_thetadot10_7_2 = T(0.1) * B_thetadot10_7_1 + b8_20 + E8_12 * K_thetadot10_8_1 + E8_11 * K_thetadot10_8_2;
  const T b7_31 = T(0.3) * B_thetadot10_7_2;
  const T K_thetadot10_7_3 = b7_31 - T(0.4) * B_thetadot10_7_1 + K_thetadot10_8_3;
  A[105] = K_thetadot10_7_2;
  A[150] = K_thetadot10_7_2;
  // B_thetadot9_7 = E8^T B_thetadot9_8
  const T B_thetadot9_7_1 = E8_12 * hc9_3;
  const T minus_B_thetadot9_7_2 = E8_11 * hc9_3;
  // K_thetadot9_7 = q8~ E8^T B_thetadot9_8 + E8^T K_thetadot9_8
  const T b7_32 = T(0.1) * minus_B_thetadot9_7_2;
  const T K_thetadot9_7_1 = b7_32 + T(0.4) * hc9_2 + E8_11 * b8_3 - E8_12 * K_thetadot9_8_2;
  const T K_thetadot9_7_2 = T(0.1) * B_thetadot9_7_1 - b8_9 + E8_12 * b8_3 + E8_11 * K_thetadot9_8_2;
  const T b7_33 = T(0.3) * minus_B_thetadot9_7_2;
  const T K_thetadot9_7_3 = K_thetadot9_8_3 - b7_33 - T(0.4) * B_thetadot9_7_1;
  A[104] = K_thetadot9_7_2;
  A[134] = K_thetadot9_7_2;
  A[103] = b7_16;
  A[118] = b7_16;

  // ---- body 6 (body_6) and what it carries
  // h6 = m6 r6 + m_sub7 q7 + hc7: first moment of mass carried, about the body origin, body axes [kg m]
  const T h6_1 = T(6.609999999999999) + hc7_1;
  const T h6_2 = T(7.845) + h7_2;
  const T h6_3 = T(2.23) + hc7_3;
  // J6 = -q7~ hc7~ + E7^T J7 E7 - m6 r6~ r6~ + I6 + (-m_sub7 q7~ - hc7~) q7~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b6_1 = E7_11 * J7_11 + minus_E7_13 * J7_31;
  const T b6_2 = E7_11 * J7_13 + minus_E7_13 * J7_33;
  const T b6_3 = T(0.1) * hc7_3;
  const T b6_4 = T(7.5249999999999995) + h7_2;
  const T b6_5 = T(0.35) * h7_2 + b6_4 * T(0.35);
  const T b6_6 = hc7_3 + T(2.15);
  const T b6_7 = b6_6 * T(0.1);
  const T J6_11 = b6_1 * E7_11 + b6_2 * minus_E7_13 + b6_3 + b6_5 + T(0.228) + b6_7;
  const T b6_8 = E7_11 * J7_12 + minus_E7_13 * J7_32;
  const T b6_9 = b6_8 - T(0.35) * hc7_1;
  const T J6_12 = b6_9 - T(0.024000000000000004) - b6_4 * T(0.3);
  const T b6_10 = b6_2 * E7_11 - b6_1 * minus_E7_13 - T(0.003200000000000002);
  const T J6_13 = b6_10 - T(0.1) * hc7_1 - b6_6 * T(0.3);
  const T b6_11 = hc7_1 + T(6.45);
  const T J6_21 = b6_8 - T(0.3) * h7_2 - T(0.024000000000000004) - b6_11 * T(0.35);
  const T b6_12 = T(0.3) * hc7_1;
  const T b6_13 = b6_3 + b6_12 + J7_22;
  const T b6_14 = b6_11 * T(0.3);
  const T J6_22 = b6_13 + T(0.212) + b6_7 + b6_14;
  const T b6_15 = J7_23 * E7_11 - J7_21 * minus_E7_13 - T(0.022400000000000003);
  const T J6_23 = b6_15 - T(0.1) * h7_2 - b6_6 * T(0.35);
  const T b6_16 = T(0.3) * hc7_3;
  const T J6_31 = b6_10 - b6_16 - b6_11 * T(0.1);
  const T b6_17 = T(0.35) * hc7_3;
  const T J6_32 = b6_15 - b6_17 - b6_4 * T(0.1);
  const T J6_33 = (E7_11 * J7_33 - minus_E7_13 * J7_13) * E7_11 - (E7_11 * J7_31 - minus_E7_13 * J7_11) * minus_E7_13
      + b6_5 + b6_12 + T(0.20800000000000002) + b6_14;
  A[85] = J6_11;
  // hc6 = E6^T h6: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc6_2 = E6_22 * h6_2 - E6_23 * h6_3;
  const T hc6_3 = E6_22 * h6_3 + E6_23 * h6_2;
  // B_thetadot16_6 = E7^T B_thetadot16_7
  const T B_thetadot16_6_1 = E7_11 * B_thetadot16_7_1 + minus_E7_13 * B_thetadot16_8_3;
  const T B_thetadot16_6_3 = E7_11 * B_thetadot16_8_3 - minus_E7_13 * B_thetadot16_7_1;
  // K_thetadot16_6 = q7~ E7^T B_thetadot16_7 + E7^T K_thetadot16_7
  const T K_thetadot16_6_1 = T(0.35) * B_thetadot16_6_3 - b7_18 + E7_11 * K_thetadot16_7_1 + minus_E7_13 *
      K_thetadot16_7_3;
  const T b6_18 = T(0.1) * B_thetadot16_6_1;
  const T K_thetadot16_6_2 = b6_18 - T(0.3) * B_thetadot16_6_3 + K_thetadot16_7_2;
  const T K_thetadot16_6_3 = b7_19 - T(0.35) * B_thetadot16_6_1 + E7_11 * K_thetadot16_7_3 - minus_E7_13 *
      K_thetadot16_7_1;
  A[95] = K_thetadot16_6_1;
  A[245] = K_thetadot16_6_1;
  // B_thetadot15_6 = E7^T B_thetadot15_7
  const T B_thetadot15_6_1 = E7_11 * B_thetadot15_7_1 + minus_E7_13 * B_thetadot15_8_3;
  const T B_thetadot15_6_3 = E7_11 * B_thetadot15_8_3 - minus_E7_13 * B_thetadot15_7_1;
  // K_thetadot15_6 = q7~ E7^T B_thetadot15_7 + E7^T K_thetadot15_7
  const T K_thetadot15_6_1 = T(0.35) * B_thetadot15_6_3 - b7_20 + E7_11 * K_thetadot15_7_1 + minus_E7_13 *
      K_thetadot15_7_3;
  const T b6_19 = T(0.1) * B_thetadot15_6_1;
  const T K_thetadot15_6_2 = b6_19 - T(0.3) * B_thetadot15_6_3 + K_thetadot15_7_2;
  const T K_thetadot15_6_3 = b7_21 - T(0.35) * B_thetadot15_6_1 + E7_11 * K_thetadot15_7_3 - minus_E7_13 *
      K_thetadot15_7_1;
  A[94] = K_thetadot15_6_1;
  A[229] = K_thetadot15_6_1;
  // B_thetadot14_6 = E7^T B_thetadot14_7
  const T B_thetadot14_6_1 = E7_11 * B_thetadot14_7_1 + minus_E7_13 * B_thetadot14_8_3;
  const T B_thetadot14_6_3 = E7_11 * B_thetadot14_8_3 - minus_E7_13 * B_thetadot14_7_1;
  // K_thetadot14_6 = q7~ E7^T B_thetadot14_7 + E7^T K_thetadot14_7
  const T K_thetadot14_6_1 = T(0.35) * B_thetadot14_6_3 - b7_22 + E7_11 * K_thetadot14_7_1 + minus_E7_13 *
      K_thetadot14_7_3;
  const T b6_20 = T(0.1) * B_thetadot14_6_1;
  const T K_thetadot14_6_2 = b6_20 - T(0.3) * B_thetadot14_6_3 + K_thetadot14_7_2;
  const T K_thetadot14_6_3 = b7_23 - T(0.35) * B_thetadot14_6_1 + E7_11 * K_thetadot14_7_3 - minus_E7_13 *
      K_thetadot14_7_1;
  A[93] = K_thetadot14_6_1;
  A[213] = K_thetadot14_6_1;
  // B_thetadot13_6 = E7^T B_thetadot13_7
  const T B_thetadot13_6_1 = E7_11 * B_thetadot13_7_1 + minus_E7_13 * B_thetadot13_8_3;
  const T B_thetadot13_6_3 = E7_11 * B_thetadot13_8_3 - minus_E7_13 * B_thetadot13_7_1;
  // K_thetadot13_6 = q7~ E7^T B_thetadot13_7 + E7^T K_thetadot13_7
  const T K_thetadot13_6_1 = T(0.35) * B_thetadot13_6_3 - b7_24 + E7_11 * K_thetadot13_7_1 + minus_E7_13 *
      K_thetadot13_7_3;
  const T b6_21 = T(0.1) * B_thetadot13_6_1;
  const T K_thetadot13_6_2 = b6_21 - T(0.3) * B_thetadot13_6_3 + K_thetadot13_7_2;
  const T K_thetadot13_6_3 = b7_25 - T(0.35) * B_thetadot13_6_1 + E7_11 * K_thetadot13_7_3 - minus_E7_13 *
      K_thetadot13_7_1;
  A[92] = K_thetadot13_6_1;
  A[197] = K_thetadot13_6_1;
  // B_thetadot12_6 = E7^T B_thetadot12_7
  const T B_thetadot12_6_1 = E7_11 * B_thetadot12_7_1 + minus_E7_13 * B_thetadot12_8_3;
  const T B_thetadot12_6_3 = E7_11 * B_thetadot12_8_3 - minus_E7_13 * B_thetadot12_7_1;
  // K_thetadot12_6 = q7~ E7^T B_thetadot12_7 + E7^T K_thetadot12_7
  const T K_thetadot12_6_1 = T(0.35) * B_thetadot12_6_3 - b7_26 + E7_11 * K_thetadot12_7_1 + minus_E7_13 *
      K_thetadot12_7_3;
  const T b6_22 = T(0.1) * B_thetadot12_6_1;
  const T K_thetadot12_6_2 = b6_22 - T(0.3) * B_thetadot12_6_3 + K_thetadot12_7_2;
  const T K_thetadot12_6_3 = b7_27 - T(0.35) * B_thetadot12_6_1 + E7_11 * K_thetadot12_7_3 - minus_E7_13 *
      K_thetadot12_7_1;
  A[91] = K_thetadot12_6_1;
  A[181] = K_thetadot12_6_1;
  // B_thetadot11_6 = E7^T B_thetadot11_7
  const T B_thetadot11_6_1 = minus_E7_13 * B_thetadot11_8_3 - E7_11 * minus_B_thetadot11_7_1;
  const T B_thetadot11_6_3 = minus_E7_13 * minus_B_thetadot11_7_1 + E7_11 * B_thetadot11_8_3;
  // K_thetadot11_6 = q7~ E7^T B_thetadot11_7 + E7^T K_thetadot11_7
  const T K_thetadot11_6_1 = T(0.35) * B_thetadot11_6_3 - b7_28 + E7_11 * K_thetadot11_7_1 + minus_E7_13 *
      K_thetadot11_7_3;
  const T b6_23 = T(0.1) * B_thetadot11_6_1;
  const T K_thetadot11_6_2 = b6_23 - T(0.3) * B_thetadot11_6_3 + K_thetadot11_7_2;
  const T K_thetadot11_6_3 = b7_29 - T(0.35) * B_thetadot11_6_1 + E7_11 * K_thetadot11_7_3 - minus_E7_13 *
      K_thetadot11_7_1;
  A[90] = K_thetadot11_6_1;
  A[165] = K_thetadot11_6_1;
  // B_thetadot10_6 = E7^T B_thetadot10_7
  const T B_thetadot10_6_1 = E7_11 * B_thetadot10_7_1 - minus_E7_13 * minus_B_thetadot10_8_3;
  const T minus_B_thetadot10_6_3 = minus_E7_13 * B_thetadot10_7_1 + E7_11 * minus_B_thetadot10_8_3;
  // K_thetadot10_6 = q7~ E7^T B_thetadot10_7 + E7^T K_thetadot10_7
  const T K_thetadot10_6_1 = E7_11 * K_thetadot10_7_1 + minus_E7_13 * K_thetadot10_7_3 - b7_30 - T(0.35) *
      minus_B_thetadot10_6_3;
  const T b6_24 = T(0.1) * B_thetadot10_6_1;
  const T K_thetadot10_6_2 = b6_24 + T(0.3) * minus_B_thetadot10_6_3 + K_thetadot10_7_2;
  const T K_thetadot10_6_3 = b7_31 - T(0.35) * B_thetadot10_6_1 + E7_11 * K_thetadot10_7_3 - minus_E7_13 *
      K_thetadot10_7_1;
  A[89] = K_thetadot10_6_1;
  A[149] = K_thetadot10_6_1;
  // B_thetadot9_6 = E7^T B_thetadot9_7
  const T B_thetadot9_6_1 = E7_11 * B_thetadot9_7_1 + minus_E7_13 * hc9_2;
  const T B_thetadot9_6_3 = E7_11 * hc9_2 - minus_E7_13 * B_thetadot9_7_1;
  // K_thetadot9_6 = q7~ E7^T B_thetadot9_7 + E7^T K_thetadot9_7
  const T K_thetadot9_6_1 = b7_32 + T(0.35) * B_thetadot9_6_3 + E7_11 * K_thetadot9_7_1 + minus_E7_13 *
      K_thetadot9_7_3;
  const T b6_25 = T(0.1) * B_thetadot9_6_1;
  const T K_thetadot9_6_2 = b6_25 - T(0.3) * B_thetadot9_6_3 + K_thetadot9_7_2;
  const T K_thetadot9_6_3 = E7_11 * K_thetadot9_7_3 - minus_E7_13 * K_thetadot9_7_1 - b7_33 - T(0.35) *
      B_thetadot9_6_1;
  A[88] = K_thetadot9_6_1;
  A[133] = K_thetadot9_6_1;
  // B_thetadot8_6 = E7^T B_thetadot8_7
  const T minus_B_thetadot8_6_1 = E7_11 * hc8_2;
  const T B_thetadot8_6_3 = minus_E7_13 * hc8_2;
  // K_thetadot8_6 = q7~ E7^T B_thetadot8_7 + E7^T K_thetadot8_7
  const T K_thetadot8_6_1 = T(0.35) * B_thetadot8_6_3 - b7_10 + E7_11 * b7_11 + minus_E7_13 * b7_17;
  const T b6_26 = T(0.1) * minus_B_thetadot8_6_1;
  const T K_thetadot8_6_2 = b7_16 - b6_26 - T(0.3) * B_thetadot8_6_3;
  const T K_thetadot8_6_3 = b7_13 + T(0.35) * minus_B_thetadot8_6_1 + E7_11 * b7_17 - minus_E7_13 * b7_11;
  A[87] = K_thetadot8_6_1;
  A[117] = K_thetadot8_6_1;
  // K_thetadot7_6 = q7~ E7^T B_thetadot7_7 + E7^T K_thetadot7_7
  const T K_thetadot7_6_3 = E7_11 * J7_32 - minus_E7_13 * J7_12 - b6_17;
  A[86] = b6_9;
  A[101] = b6_9;

  // ---- body 5 (body_5) and what it carries
  // h5 = m5 r5 + m_sub6 q6 + hc6: first moment of mass carried, about the body origin, body axes [kg m]
  const T h5_1 = T(7.08) + h6_1;
  const T h5_2 = T(7.2299999999999995) + hc6_2;
  const T h5_3 = T(2.3850000000000002) + hc6_3;
  // J5 = -q6~ hc6~ + E6^T J6 E6 - m5 r5~ r5~ + I5 + (-m_sub6 q6~ - hc6~) q6~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b5_1 = T(0.1) * hc6_3;
  const T b5_2 = T(0.3) * hc6_2;
  const T b5_3 = b5_1 + b5_2 + J6_11;
  const T b5_4 = hc6_3 + T(2.31);
  const T b5_5 = b5_4 * T(0.1);
  const T b5_6 = (T(6.93) + hc6_2) * T(0.3);
  const T J5_11 = b5_3 + T(0.21375) + b5_5 + b5_6;
  const T b5_7 = J6_12 * E6_22 - J6_13 * E6_23 - T(0.022500000000000003);
  const T b5_8 = T(0.3) * h6_1;
  const T b5_9 = b5_8 + b5_6;
  const T J5_12 = b5_7 - b5_9;
  const T b5_10 = b5_4 * T(0.3);
  const T J5_13 = J6_12 * E6_23 + J6_13 * E6_22 - T(0.1) * h6_1 - T(0.0030000000000000014) - b5_10;
  const T b5_11 = (h6_1 + T(6.93)) * T(0.3);
  const T b5_12 = b5_2 + b5_11;
  const T J5_21 = b5_7 - b5_12;
  const T b5_13 = E6_22 * J6_22 - E6_23 * J6_32;
  const T b5_14 = E6_22 * J6_23 - E6_23 * J6_33;
  const T J5_22 = b5_13 * E6_22 - b5_14 * E6_23 + b5_1 + b5_8 + T(0.19874999999999998) + b5_5 + b5_11;
  const T J5_23 = b5_13 * E6_23 + b5_14 * E6_22 - T(0.1) * hc6_2 - T(0.021) - b5_10;
  const T J5_33 = (E6_23 * J6_22 + E6_22 * J6_32) * E6_23 + (E6_23 * J6_23 + E6_22 * J6_33) * E6_22 + b5_12 + b5_9 +
      T(0.195);
  A[68] = J5_33;
  // hc5 = E5^T h5: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc5_1 = E5_11 * h5_1 - E5_12 * h5_2;
  const T hc5_2 = E5_11 * h5_2 + E5_12 * h5_1;
  // B_thetadot16_5 = E6^T B_thetadot16_6
  const T B_thetadot16_5_2 = E6_22 * B_thetadot16_7_2 - E6_23 * B_thetadot16_6_3;
  const T B_thetadot16_5_3 = E6_23 * B_thetadot16_7_2 + E6_22 * B_thetadot16_6_3;
  // K_thetadot16_5 = q6~ E6^T B_thetadot16_6 + E6^T K_thetadot16_6
  const T b5_15 = T(0.3) * B_thetadot16_5_3;
  const T K_thetadot16_5_1 = b5_15 - T(0.1) * B_thetadot16_5_2 + K_thetadot16_6_1;
  const T K_thetadot16_5_2 = b6_18 - b5_15 + E6_22 * K_thetadot16_6_2 - E6_23 * K_thetadot16_6_3;
  const T K_thetadot16_5_3 = T(0.3) * B_thetadot16_5_2 - T(0.3) * B_thetadot16_6_1 + E6_23 * K_thetadot16_6_2 + E6_22
      * K_thetadot16_6_3;
  A[79] = K_thetadot16_5_3;
  A[244] = K_thetadot16_5_3;
  // B_thetadot15_5 = E6^T B_thetadot15_6
  const T B_thetadot15_5_2 = E6_22 * B_thetadot15_7_2 - E6_23 * B_thetadot15_6_3;
  const T B_thetadot15_5_3 = E6_23 * B_thetadot15_7_2 + E6_22 * B_thetadot15_6_3;
  // K_thetadot15_5 = q6~ E6^T B_thetadot15_6 + E6^T K_thetadot15_6
  const T b5_16 = T(0.3) * B_thetadot15_5_3;
  const T K_thetadot15_5_1 = b5_16 - T(0.1) * B_thetadot15_5_2 + K_thetadot15_6_1;
  const T K_thetadot15_5_2 = b6_19 - b5_16 + E6_22 * K_thetadot15_6_2 - E6_23 * K_thetadot15_6_3;
  const T K_thetadot15_5_3 = T(0.3) * B_thetadot15_5_2 - T(0.3) * B_thetadot15_6_1 + E6_23 * K_thetadot15_6_2 + E6_22
      * K_thetadot15_6_3;
  A[78] = K_thetadot15_5_3;
  A[228] = K_thetadot15_5_3;
  // B_thetadot14_5 = E6^T B_thetadot14_6
  const T B_thetadot14_5_2 = E6_22 * B_thetadot14_7_2 - E6_23 * B_thetadot14_6_3;
  const T B_thetadot14_5_3 = E6_23 * B_thetadot14_7_2 + E6_22 * B_thetadot14_6_3;
  // K_thetadot14_5 = q6~ E6^T B_thetadot14_6 + E6^T K_thetadot14_6
  const T b5_17 = T(0.3) * B_thetadot14_5_3;
  const T K_thetadot14_5_1 = b5_17 - T(0.1) * B_thetadot14_5_2 + K_thetadot14_6_1;
  const T K_thetadot14_5_2 = b6_20 - b5_17 + E6_22 * K_thetadot14_6_2 - E6_23 * K_thetadot14_6_3;
  const T K_thetadot14_5_3 = T(0.3) * B_thetadot14_5_2 - T(0.3) * B_thetadot14_6_1 + E6_23 * K_thetadot14_6_2 + E6_22
      * K_thetadot14_6_3;
  A[77] = K_thetadot14_5_3;
  A[212] = K_thetadot14_5_3;
  // B_thetadot13_5 = E6^T B_thetadot13_6
  const T B_thetadot13_5_2 = E6_22 * B_thetadot13_7_2 - E6_23 * B_thetadot13_6_3;
  const T B_thetadot13_5_3 = E6_23 * B_thetadot13_7_2 + E6_22 * B_thetadot13_6_3;
  // K_thetadot13_5 = q6~ E6^T B_thetadot13_6 + E6^T K_thetadot13_6
  const T b5_18 = T(0.3) * B_thetadot13_5_3;
  const T K_thetadot13_5_1 = b5_18 - T(0.1) * B_thetadot13_5_2 + K_thetadot13_6_1;
  const T K_thetadot13_5_2 = b6_21 - b5_18 + E6_22 * K_thetadot13_6_2 - E6_23 * K_thetadot13_6_3;
  const T K_thetadot13_5_3 = T(0.3) * B_thetadot13_5_2 - T(0.3) * B_thetadot13_6_1 + E6_23 * K_thetadot13_6_2 + E6_22
      * K_thetadot13_6_3;
  A[76] = K_thetadot13_5_3;
  A[196] = K_thetadot13_5_3;
  // B_thetadot12_5 = E6^T B_thetadot12_6
  const T B_thetadot12_5_2 = E6_22 * B_thetadot12_7_2 - E6_23 * B_thetadot12_6_3;
  const T B_thetadot12_5_3 = E6_23 * B_thetadot12_7_2 + E6_22 * B_thetadot12_6_3;
  // K_thetadot12_5 = q6~ E6^T B_thetadot12_6 + E6^T K_thetadot12_6
  const T b5_19 = T(0.3) * B_thetadot12_5_3;
  const T K_thetadot12_5_1 = b5_19 - T(0.1) * B_thetadot12_5_2 + K_thetadot12_6_1;
  const T K_thetadot12_5_2 = b6_22 - b5_19 + E6_22 * K_thetadot12_6_2 - E6_23 * K_thetadot12_6_3;
  const T K_thetadot12_5_3 = T(0.3) * B_thetadot12_5_2 - T(0.3) * B_thetadot12_6_1 + E6_23 * K_thetadot12_6_2 + E6_22
      * K_thetadot12_6_3;
  A[75] = K_thetadot12_5_3;
  A[180] = K_thetadot12_5_3;
  // B_thetadot11_5 = E6^T B_thetadot11_6
  const T B_thetadot11_5_2 = E6_22 * B_thetadot11_7_2 - E6_23 * B_thetadot11_6_3;
  const T B_thetadot11_5_3 = E6_23 * B_thetadot11_7_2 + E6_22 * B_thetadot11_6_3;
  // K_thetadot11_5 = q6~ E6^T B_thetadot11_6 + E6^T K_thetadot11_6
  const T b5_20 = T(0.3) * B_thetadot11_5_3;
  const T K_thetadot11_5_1 = b5_20 - T(0.1) * B_thetadot11_5_2 + K_thetadot11_6_1;
  const T K_thetadot11_5_2 = b6_23 - b5_20 + E6_22 * K_thetadot11_6_2 - E6_23 * K_thetadot11_6_3;
  const T K_thetadot11_5_3 = T(0.3) * B_thetadot11_5_2 - T(0.3) * B_thetadot11_6_1 + E6_23 * K_thetadot11_6_2 + E6_22
      * K_thetadot11_6_3;
  A[74] = K_thetadot11_5_3;
  A[164] = K_thetadot11_5_3;
  // B_thetadot10_5 = E6^T B_thetadot10_6
  const T B_thetadot10_5_2 = E6_22 * B_thetadot10_7_2 + E6_23 * minus_B_thetadot10_6_3;
  const T B_thetadot10_5_3 = E6_23 * B_thetadot10_7_2 - E6_22 * minus_B_thetadot10_6_3;
  // K_thetadot10_5 = q6~ E6^T B_thetadot10_6 + E6^T K_thetadot10_6
  const T b5_21 = T(0.3) * B_thetadot10_5_3;
  const T K_thetadot10_5_1 = b5_21 - T(0.1) * B_thetadot10_5_2 + K_thetadot10_6_1;
  const T K_thetadot10_5_2 = b6_24 - b5_21 + E6_22 * K_thetadot10_6_2 - E6_23 * K_thetadot10_6_3;
  const T K_thetadot10_5_3 = T(0.3) * B_thetadot10_5_2 - T(0.3) * B_thetadot10_6_1 + E6_23 * K_thetadot10_6_2 + E6_22
      * K_thetadot10_6_3;
  A[73] = K_thetadot10_5_3;
  A[148] = K_thetadot10_5_3;
  // B_thetadot9_5 = E6^T B_thetadot9_6
  const T minus_B_thetadot9_5_2 = E6_22 * minus_B_thetadot9_7_2 + E6_23 * B_thetadot9_6_3;
  const T B_thetadot9_5_3 = E6_22 * B_thetadot9_6_3 - E6_23 * minus_B_thetadot9_7_2;
  // K_thetadot9_5 = q6~ E6^T B_thetadot9_6 + E6^T K_thetadot9_6
  const T b5_22 = T(0.3) * B_thetadot9_5_3;
  const T K_thetadot9_5_1 = T(0.1) * minus_B_thetadot9_5_2 + b5_22 + K_thetadot9_6_1;
  const T K_thetadot9_5_2 = b6_25 - b5_22 + E6_22 * K_thetadot9_6_2 - E6_23 * K_thetadot9_6_3;
  const T K_thetadot9_5_3 = E6_23 * K_thetadot9_6_2 + E6_22 * K_thetadot9_6_3 - T(0.3) * minus_B_thetadot9_5_2 -
      T(0.3) * B_thetadot9_6_1;
  A[72] = K_thetadot9_5_3;
  A[132] = K_thetadot9_5_3;
  // B_thetadot8_5 = E6^T B_thetadot8_6
  const T B_thetadot8_5_2 = E6_22 * hc8_1 - E6_23 * B_thetadot8_6_3;
  const T B_thetadot8_5_3 = E6_23 * hc8_1 + E6_22 * B_thetadot8_6_3;
  // K_thetadot8_5 = q6~ E6^T B_thetadot8_6 + E6^T K_thetadot8_6
  const T b5_23 = T(0.3) * B_thetadot8_5_3;
  const T K_thetadot8_5_1 = b5_23 - T(0.1) * B_thetadot8_5_2 + K_thetadot8_6_1;
  const T K_thetadot8_5_2 = E6_22 * K_thetadot8_6_2 - E6_23 * K_thetadot8_6_3 - b6_26 - b5_23;
  const T K_thetadot8_5_3 = T(0.3) * B_thetadot8_5_2 + T(0.3) * minus_B_thetadot8_6_1 + E6_23 * K_thetadot8_6_2 +
      E6_22 * K_thetadot8_6_3;
  A[71] = K_thetadot8_5_3;
  A[116] = K_thetadot8_5_3;
  // B_thetadot7_5 = E6^T B_thetadot7_6
  const T B_thetadot7_5_2 = E6_23 * hc7_1;
  const T minus_B_thetadot7_5_3 = E6_22 * hc7_1;
  // K_thetadot7_5 = q6~ E6^T B_thetadot7_6 + E6^T K_thetadot7_6
  const T b5_24 = T(0.3) * minus_B_thetadot7_5_3;
  const T K_thetadot7_5_1 = b6_9 - T(0.1) * B_thetadot7_5_2 - b5_24;
  const T K_thetadot7_5_2 = b6_3 + b5_24 + E6_22 * b6_13 - E6_23 * K_thetadot7_6_3;
  const T K_thetadot7_5_3 = T(0.3) * B_thetadot7_5_2 - b6_16 + E6_23 * b6_13 + E6_22 * K_thetadot7_6_3;
  A[70] = K_thetadot7_5_3;
  A[100] = K_thetadot7_5_3;
  // K_thetadot6_5 = q6~ E6^T B_thetadot6_6 + E6^T K_thetadot6_6
  const T K_thetadot6_5_2 = E6_22 * J6_21 - E6_23 * J6_31 - b5_2;
  const T K_thetadot6_5_3 = E6_23 * J6_21 + E6_22 * J6_31 - T(0.3) * hc6_3;
  A[69] = K_thetadot6_5_3;
  A[84] = K_thetadot6_5_3;

  // ---- body 4 (body_4) and what it carries
  // h4 = m4 r4 + m_sub5 q5 + hc5: first moment of mass carried, about the body origin, body axes [kg m]
  const T h4_1 = T(7.52) + hc5_1;
  const T h4_2 = T(6.43) + hc5_2;
  const T h4_3 = T(2.5300000000000002) + h5_3;
  // J4 = -q5~ hc5~ + E5^T J5 E5 - m4 r4~ r4~ + I4 + (-m_sub5 q5~ - hc5~) q5~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b4_1 = E5_11 * J5_11 - E5_12 * J5_21;
  const T b4_2 = E5_11 * J5_12 - E5_12 * J5_22;
  const T b4_3 = h5_3 + T(2.46);
  const T b4_4 = T(0.1) * h5_3 + b4_3 * T(0.1);
  const T b4_5 = T(0.25) * hc5_2;
  const T b4_6 = T(6.15) + hc5_2;
  const T b4_7 = b4_6 * T(0.25);
  const T J4_11 = b4_1 * E5_11 - b4_2 * E5_12 + b4_4 + b4_5 + T(0.1995) + b4_7;
  const T b4_8 = b4_1 * E5_12 + b4_2 * E5_11 - T(0.021);
  const T J4_12 = b4_8 - T(0.25) * hc5_1 - b4_6 * T(0.3);
  const T b4_9 = E5_11 * J5_13 - E5_12 * J5_23;
  const T b4_10 = T(0.1) * hc5_1;
  const T b4_11 = b4_9 - b4_10;
  const T J4_13 = b4_11 - T(0.0028000000000000004) - b4_3 * T(0.3);
  const T b4_12 = hc5_1 + T(7.38);
  const T J4_21 = b4_8 - T(0.3) * hc5_2 - b4_12 * T(0.25);
  const T b4_13 = T(0.3) * hc5_1;
  const T b4_14 = b4_12 * T(0.3);
  const T J4_22 = (E5_12 * J5_11 + E5_11 * J5_21) * E5_12 + (E5_12 * J5_12 + E5_11 * J5_22) * E5_11 + b4_4 + b4_13 +
      T(0.1855) + b4_14;
  const T b4_15 = E5_12 * J5_13 + E5_11 * J5_23;
  const T b4_16 = b4_15 - T(0.1) * hc5_2;
  const T J4_23 = b4_16 - T(0.0196) - b4_3 * T(0.25);
  const T J4_31 = b4_9 - T(0.3) * h5_3 - T(0.0028000000000000004) - b4_12 * T(0.1);
  const T J4_32 = b4_15 - T(0.25) * h5_3 - T(0.0196) - b4_6 * T(0.1);
  const T b4_17 = b4_13 + b4_5 + J5_33;
  const T J4_33 = b4_17 + T(0.182) + b4_7 + b4_14;
  A[51] = J4_22;
  // hc4 = E4^T h4: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4_1 = minus_E4_13 * h4_3 + E4_11 * h4_1;
  const T hc4_3 = E4_11 * h4_3 - minus_E4_13 * h4_1;
  // B_thetadot16_4 = E5^T B_thetadot16_5
  const T B_thetadot16_4_1 = E5_11 * B_thetadot16_6_1 - E5_12 * B_thetadot16_5_2;
  const T B_thetadot16_4_2 = E5_12 * B_thetadot16_6_1 + E5_11 * B_thetadot16_5_2;
  // K_thetadot16_4 = q5~ E5^T B_thetadot16_5 + E5^T K_thetadot16_5
  const T b4_18 = T(0.1) * B_thetadot16_4_2;
  const T K_thetadot16_4_1 = T(0.25) * B_thetadot16_5_3 - b4_18 + E5_11 * K_thetadot16_5_1 - E5_12 * K_thetadot16_5_2;
  const T K_thetadot16_4_2 = T(0.1) * B_thetadot16_4_1 - b5_15 + E5_12 * K_thetadot16_5_1 + E5_11 * K_thetadot16_5_2;
  const T b4_19 = T(0.3) * B_thetadot16_4_2;
  const T K_thetadot16_4_3 = b4_19 - T(0.25) * B_thetadot16_4_1 + K_thetadot16_5_3;
  A[63] = K_thetadot16_4_2;
  A[243] = K_thetadot16_4_2;
  // B_thetadot15_4 = E5^T B_thetadot15_5
  const T B_thetadot15_4_1 = E5_11 * B_thetadot15_6_1 - E5_12 * B_thetadot15_5_2;
  const T B_thetadot15_4_2 = E5_12 * B_thetadot15_6_1 + E5_11 * B_thetadot15_5_2;
  // K_thetadot15_4 = q5~ E5^T B_thetadot15_5 + E5^T K_thetadot15_5
  const T b4_20 = T(0.1) * B_thetadot15_4_2;
  const T K_thetadot15_4_1 = T(0.25) * B_thetadot15_5_3 - b4_20 + E5_11 * K_thetadot15_5_1 - E5_12 * K_thetadot15_5_2;
  const T K_thetadot15_4_2 = T(0.1) * B_thetadot15_4_1 - b5_16 + E5_12 * K_thetadot15_5_1 + E5_11 * K_thetadot15_5_2;
  const T b4_21 = T(0.3) * B_thetadot15_4_2;
  const T K_thetadot15_4_3 = b4_21 - T(0.25) * B_thetadot15_4_1 + K_thetadot15_5_3;
  A[62] = K_thetadot15_4_2;
  A[227] = K_thetadot15_4_2;
  // B_thetadot14_4 = E5^T B_thetadot14_5
  const T B_thetadot14_4_1 = E5_11 * B_thetadot14_6_1 - E5_12 * B_thetadot14_5_2;
  const T B_thetadot14_4_2 = E5_12 * B_thetadot14_6_1 + E5_11 * B_thetadot14_5_2;
  // K_thetadot14_4 = q5~ E5^T B_thetadot14_5 + E5^T K_thetadot14_5
  const T b4_22 = T(0.1) * B_thetadot14_4_2;
  const T K_thetadot14_4_1 = T(0.25) * B_thetadot14_5_3 - b4_22 + E5_11 * K_thetadot14_5_1 - E5_12 * K_thetadot14_5_2;
  const T K_thetadot14_4_2 = T(0.1) * B_thetadot14_4_1 - b5_17 + E5_12 * K_thetadot14_5_1 + E5_11 * K_thetadot14_5_2;
  const T b4_23 = T(0.3) * B_thetadot14_4_2;
  const T K_thetadot14_4_3 = b4_23 - T(0.25) * B_thetadot14_4_1 + K_thetadot14_5_3;
  A[61] = K_thetadot14_4_2;
  A[211] = K_thetadot14_4_2;
  // B_thetadot13_4 = E5^T B_thetadot13_5
  const T B_thetadot13_4_1 = E5_11 * B_thetadot13_6_1 - E5_12 * B_thetadot13_5_2;
  const T B_thetadot13_4_2 = E5_12 * B_thetadot13_6_1 + E5_11 * B_thetadot13_5_2;
  // K_thetadot13_4 = q5~ E5^T B_thetadot13_5 + E5^T K_thetadot13_5
  const T b4_24 = T(0.1) * B_thetadot13_4_2;
  const T K_thetadot13_4_1 = T(0.25) * B_thetadot13_5_3 - b4_24 + E5_11 * K_thetadot13_5_1 - E5_12 * K_thetadot13_5_2;
  const T K_thetadot13_4_2 = T(0.1) * B_thetadot13_4_1 - b5_18 + E5_12 * K_thetadot13_5_1 + E5_11 * K_thetadot13_5_2;
  const T b4_25 = T(0.3) * B_thetadot13_4_2;
  const T K_thetadot13_4_3 = b4_25 - T(0.25) * B_thetadot13_4_1 + K_thetadot13_5_3;
  A[60] = K_thetadot13_4_2;
  A[195] = K_thetadot13_4_2;
  // B_thetadot12_4 = E5^T B_thetadot12_5
  const T B_thetadot12_4_1 = E5_11 * B_thetadot12_6_1 - E5_12 * B_thetadot12_5_2;
  const T B_thetadot12_4_2 = E5_12 * B_thetadot12_6_1 + E5_11 * B_thetadot12_5_2;
  // K_thetadot12_4 = q5~ E5^T B_thetadot12_5 + E5^T K_thetadot12_5
  const T b4_26 = T(0.1) * B_thetadot12_4_2;
  const T K_thetadot12_4_1 = T(0.25) * B_thetadot12_5_3 - b4_26 + E5_11 * K_thetadot12_5_1 - E5_12 * K_thetadot12_5_2;
  const T K_thetadot12_4_2 = T(0.1) * B_thetadot12_4_1 - b5_19 + E5_12 * K_thetadot12_5_1 + E5_11 * K_thetadot12_5_2;
  const T b4_27 = T(0.3) * B_thetadot12_4_2;
  const T K_thetadot12_4_3 = b4_27 - T(0.25) * B_thetadot12_4_1 + K_thetadot12_5_3;
  A[59] = K_thetadot12_4_2;
  A[179] = K_thetadot12_4_2;
  // B_thetadot11_4 = E5^T B_thetadot11_5
  const T B_thetadot11_4_1 = E5_11 * B_thetadot11_6_1 - E5_12 * B_thetadot11_5_2;
  const T B_thetadot11_4_2 = E5_12 * B_thetadot11_6_1 + E5_11 * B_thetadot11_5_2;
  // K_thetadot11_4 = q5~ E5^T B_thetadot11_5 + E5^T K_thetadot11_5
  const T b4_28 = T(0.1) * B_thetadot11_4_2;
  const T K_thetadot11_4_1 = T(0.25) * B_thetadot11_5_3 - b4_28 + E5_11 * K_thetadot11_5_1 - E5_12 * K_thetadot11_5_2;
  const T K_thetadot11_4_2 = T(0.1) * B_thetadot11_4_1 - b5_20 + E5_12 * K_thetadot11_5_1 + E5_11 * K_thetadot11_5_2;
  const T b4_29 = T(0.3) * B_thetadot11_4_2;
  const T K_thetadot11_4_3 = b4_29 - T(0.25) * B_thetadot11_4_1 + K_thetadot11_5_3;
  A[58] = K_thetadot11_4_2;
  A[163] = K_thetadot11_4_2;
  // B_thetadot10_4 = E5^T B_thetadot10_5
  const T B_thetadot10_4_1 = E5_11 * B_thetadot10_6_1 - E5_12 * B_thetadot10_5_2;
  const T B_thetadot10_4_2 = E5_12 * B_thetadot10_6_1 + E5_11 * B_thetadot10_5_2;
  // K_thetadot10_4 = q5~ E5^T B_thetadot10_5 + E5^T K_thetadot10_5
  const T b4_30 = T(0.1) * B_thetadot10_4_2;
  const T K_thetadot10_4_1 = T(0.25) * B_thetadot10_5_3 - b4_30 + E5_11 * K_thetadot10_5_1 - E5_12 * K_thetadot10_5_2;
  const T K_thetadot10_4_2 = T(0.1) * B_thetadot10_4_1 - b5_21 + E5_12 * K_thetadot10_5_1 + E5_11 * K_thetadot10_5_2;
  const T b4_31 = T(0.3) * B_thetadot10_4_2;
  const T K_thetadot10_4_3 = b4_31 - T(0.25) * B_thetadot10_4_1 + K_thetadot10_5_3;
  A[57] = K_thetadot10_4_2;
  A[147] = K_thetadot10_4_2;
  // B_thetadot9_4 = E5^T B_thetadot9_5
  const T B_thetadot9_4_1 = E5_11 * B_thetadot9_6_1 + E5_12 * minus_B_thetadot9_5_2;
  const T B_thetadot9_4_2 = E5_12 * B_thetadot9_6_1 - E5_11 * minus_B_thetadot9_5_2;
  // K_thetadot9_4 = q5~ E5^T B_thetadot9_5 + E5^T K_thetadot9_5
  const T b4_32 = T(0.1) * B_thetadot9_4_2;
  const T K_thetadot9_4_1 = T(0.25) * B_thetadot9_5_3 - b4_32 + E5_11 * K_thetadot9_5_1 - E5_12 * K_thetadot9_5_2;
  const T K_thetadot9_4_2 = T(0.1) * B_thetadot9_4_1 - b5_22 + E5_12 * K_thetadot9_5_1 + E5_11 * K_thetadot9_5_2;
  const T b4_33 = T(0.3) * B_thetadot9_4_2;
  const T K_thetadot9_4_3 = b4_33 - T(0.25) * B_thetadot9_4_1 + K_thetadot9_5_3;
  A[56] = K_thetadot9_4_2;
  A[131] = K_thetadot9_4_2;
  // B_thetadot8_4 = E5^T B_thetadot8_5
  const T minus_B_thetadot8_4_1 = E5_11 * minus_B_thetadot8_6_1 + E5_12 * B_thetadot8_5_2;
  const T B_thetadot8_4_2 = E5_11 * B_thetadot8_5_2 - E5_12 * minus_B_thetadot8_6_1;
  // K_thetadot8_4 = q5~ E5^T B_thetadot8_5 + E5^T K_thetadot8_5
  const T b4_34 = T(0.1) * B_thetadot8_4_2;
  const T K_thetadot8_4_1 = T(0.25) * B_thetadot8_5_3 - b4_34 + E5_11 * K_thetadot8_5_1 - E5_12 * K_thetadot8_5_2;
  const T K_thetadot8_4_2 = E5_12 * K_thetadot8_5_1 + E5_11 * K_thetadot8_5_2 - T(0.1) * minus_B_thetadot8_4_1 -
      b5_23;
  const T b4_35 = T(0.3) * B_thetadot8_4_2;
  const T K_thetadot8_4_3 = b4_35 + T(0.25) * minus_B_thetadot8_4_1 + K_thetadot8_5_3;
  A[55] = K_thetadot8_4_2;
  A[115] = K_thetadot8_4_2;
  // B_thetadot7_4 = E5^T B_thetadot7_5
  const T B_thetadot7_4_1 = E5_11 * hc7_3 - E5_12 * B_thetadot7_5_2;
  const T B_thetadot7_4_2 = E5_12 * hc7_3 + E5_11 * B_thetadot7_5_2;
  // K_thetadot7_4 = q5~ E5^T B_thetadot7_5 + E5^T K_thetadot7_5
  const T b4_36 = T(0.1) * B_thetadot7_4_2;
  const T K_thetadot7_4_1 = E5_11 * K_thetadot7_5_1 - E5_12 * K_thetadot7_5_2 - b4_36 - T(0.25) *
      minus_B_thetadot7_5_3;
  const T K_thetadot7_4_2 = T(0.1) * B_thetadot7_4_1 + b5_24 + E5_12 * K_thetadot7_5_1 + E5_11 * K_thetadot7_5_2;
  const T b4_37 = T(0.3) * B_thetadot7_4_2;
  const T K_thetadot7_4_3 = b4_37 - T(0.25) * B_thetadot7_4_1 + K_thetadot7_5_3;
  A[54] = K_thetadot7_4_2;
  A[99] = K_thetadot7_4_2;
  // B_thetadot6_4 = E5^T B_thetadot6_5
  const T B_thetadot6_4_1 = E5_12 * hc6_3;
  const T minus_B_thetadot6_4_2 = E5_11 * hc6_3;
  // K_thetadot6_4 = q5~ E5^T B_thetadot6_5 + E5^T K_thetadot6_5
  const T b4_38 = T(0.1) * minus_B_thetadot6_4_2;
  const T K_thetadot6_4_1 = b4_38 + T(0.25) * hc6_2 + E5_11 * b5_3 - E5_12 * K_thetadot6_5_2;
  const T K_thetadot6_4_2 = T(0.1) * B_thetadot6_4_1 - b5_2 + E5_12 * b5_3 + E5_11 * K_thetadot6_5_2;
  const T b4_39 = T(0.3) * minus_B_thetadot6_4_2;
  const T K_thetadot6_4_3 = K_thetadot6_5_3 - b4_39 - T(0.25) * B_thetadot6_4_1;
  A[53] = K_thetadot6_4_2;
  A[83] = K_thetadot6_4_2;
  A[52] = b4_16;
  A[67] = b4_16;

  // ---- body 3 (body_3) and what it carries
  // h3 = m3 r3 + m_sub4 q4 + hc4: first moment of mass carried, about the body origin, body axes [kg m]
  const T h3_1 = T(7.93) + hc4_1;
  const T h3_2 = T(5.46) + h4_2;
  const T h3_3 = T(2.665) + hc4_3;
  // J3 = -q4~ hc4~ + E4^T J4 E4 - m3 r3~ r3~ + I3 + (-m_sub4 q4~ - hc4~) q4~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b3_1 = E4_11 * J4_11 + minus_E4_13 * J4_31;
  const T b3_2 = E4_11 * J4_13 + minus_E4_13 * J4_33;
  const T b3_3 = T(0.1) * hc4_3;
  const T b3_4 = T(5.2) + h4_2;
  const T b3_5 = T(0.2) * h4_2 + b3_4 * T(0.2);
  const T b3_6 = hc4_3 + T(2.6);
  const T b3_7 = b3_6 * T(0.1);
  const T J3_11 = b3_1 * E4_11 + b3_2 * minus_E4_13 + b3_3 + b3_5 + T(0.18525000000000003) + b3_7;
  const T b3_8 = E4_11 * J4_12 + minus_E4_13 * J4_32;
  const T b3_9 = b3_8 - T(0.2) * hc4_1;
  const T J3_12 = b3_9 - T(0.019500000000000003) - b3_4 * T(0.3);
  const T b3_10 = b3_2 * E4_11 - b3_1 * minus_E4_13 - T(0.002600000000000001);
  const T J3_13 = b3_10 - T(0.1) * hc4_1 - b3_6 * T(0.3);
  const T b3_11 = hc4_1 + T(7.8);
  const T J3_21 = b3_8 - T(0.3) * h4_2 - T(0.019500000000000003) - b3_11 * T(0.2);
  const T b3_12 = T(0.3) * hc4_1;
  const T b3_13 = b3_3 + b3_12 + J4_22;
  const T b3_14 = b3_11 * T(0.3);
  const T J3_22 = b3_13 + T(0.17225000000000001) + b3_7 + b3_14;
  const T b3_15 = J4_23 * E4_11 - J4_21 * minus_E4_13 - T(0.0182);
  const T J3_23 = b3_15 - T(0.1) * h4_2 - b3_6 * T(0.2);
  const T J3_31 = b3_10 - T(0.3) * hc4_3 - b3_11 * T(0.1);
  const T b3_16 = T(0.2) * hc4_3;
  const T J3_32 = b3_15 - b3_16 - b3_4 * T(0.1);
  const T J3_33 = (E4_11 * J4_33 - minus_E4_13 * J4_13) * E4_11 - (E4_11 * J4_31 - minus_E4_13 * J4_11) * minus_E4_13
      + b3_5 + b3_12 + T(0.169) + b3_14;
  A[34] = J3_11;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc3_2 = E3_22 * h3_2 - E3_23 * h3_3;
  const T hc3_3 = E3_22 * h3_3 + E3_23 * h3_2;
  // B_thetadot16_3 = E4^T B_thetadot16_4
  const T B_thetadot16_3_1 = E4_11 * B_thetadot16_4_1 + minus_E4_13 * B_thetadot16_5_3;
  const T B_thetadot16_3_3 = E4_11 * B_thetadot16_5_3 - minus_E4_13 * B_thetadot16_4_1;
  // K_thetadot16_3 = q4~ E4^T B_thetadot16_4 + E4^T K_thetadot16_4
  const T K_thetadot16_3_1 = T(0.2) * B_thetadot16_3_3 - b4_18 + E4_11 * K_thetadot16_4_1 + minus_E4_13 *
      K_thetadot16_4_3;
  const T b3_17 = T(0.1) * B_thetadot16_3_1;
  const T K_thetadot16_3_2 = b3_17 - T(0.3) * B_thetadot16_3_3 + K_thetadot16_4_2;
  const T K_thetadot16_3_3 = b4_19 - T(0.2) * B_thetadot16_3_1 + E4_11 * K_thetadot16_4_3 - minus_E4_13 *
      K_thetadot16_4_1;
  A[47] = K_thetadot16_3_1;
  A[242] = K_thetadot16_3_1;
  // B_thetadot15_3 = E4^T B_thetadot15_4
  const T B_thetadot15_3_1 = E4_11 * B_thetadot15_4_1 + minus_E4_13 * B_thetadot15_5_3;
  const T B_thetadot15_3_3 = E4_11 * B_thetadot15_5_3 - minus_E4_13 * B_thetadot15_4_1;
  // K_thetadot15_3 = q4~ E4^T B_thetadot15_4 + E4^T K_thetadot15_4
  const T K_thetadot15_3_1 = T(0.2) * B_thetadot15_3_3 - b4_20 + E4_11 * K_thetadot15_4_1 + minus_E4_13 *
      K_thetadot15_4_3;
  const T b3_18 = T(0.1) * B_thetadot15_3_1;
  const T K_thetadot15_3_2 = b3_18 - T(0.3) * B_thetadot15_3_3 + K_thetadot15_4_2;
  const T K_thetadot15_3_3 = b4_21 - T(0.2) * B_thetadot15_3_1 + E4_11 * K_thetadot15_4_3 - minus_E4_13 *
      K_thetadot15_4_1;
  A[46] = K_thetadot15_3_1;
  A[226] = K_thetadot15_3_1;
  // B_thetadot14_3 = E4^T B_thetadot14_4
  const T B_thetadot14_3_1 = E4_11 * B_thetadot14_4_1 + minus_E4_13 * B_thetadot14_5_3;
  const T B_thetadot14_3_3 = E4_11 * B_thetadot14_5_3 - minus_E4_13 * B_thetadot14_4_1;
  // K_thetadot14_3 = q4~ E4^T B_thetadot14_4 + E4^T K_thetadot14_4
  const T K_thetadot14_3_1 = T(0.2) * B_thetadot14_3_3 - b4_22 + E4_11 * K_thetadot14_4_1 + minus_E4_13 *
      K_thetadot14_4_3;
  const T b3_19 = T(0.1) * B_thetadot14_3_1;
  const T K_thetadot14_3_2 = b3_19 - T(0.3) * B_thetadot14_3_3 + K_thetadot14_4_2;
  const T K_thetadot14_3_3 = b4_23 - T(0.2) * B_thetadot14_3_1 + E4_11 * K_thetadot14_4_3 - minus_E4_13 *
      K_thetadot14_4_1;
  A[45] = K_thetadot14_3_1;
  A[210] = K_thetadot14_3_1;
  // B_thetadot13_3 = E4^T B_thetadot13_4
  const T B_thetadot13_3_1 = E4_11 * B_thetadot13_4_1 + minus_E4_13 * B_thetadot13_5_3;
  const T B_thetadot13_3_3 = E4_11 * B_thetadot13_5_3 - minus_E4_13 * B_thetadot13_4_1;
  // K_thetadot13_3 = q4~ E4^T B_thetadot13_4 + E4^T K_thetadot13_4
  const T K_thetadot13_3_1 = T(0.2) * B_thetadot13_3_3 - b4_24 + E4_11 * K_thetadot13_4_1 + minus_E4_13 *
      K_thetadot13_4_3;
  const T b3_20 = T(0.1) * B_thetadot13_3_1;
  const T K_thetadot13_3_2 = b3_20 - T(0.3) * B_thetadot13_3_3 + K_thetadot13_4_2;
  const T K_thetadot13_3_3 = b4_25 - T(0.2) * B_thetadot13_3_1 + E4_11 * K_thetadot13_4_3 - minus_E4_13 *
      K_thetadot13_4_1;
  A[44] = K_thetadot13_3_1;
  A[194] = K_thetadot13_3_1;
  // B_thetadot12_3 = E4^T B_thetadot12_4
  const T B_thetadot12_3_1 = E4_11 * B_thetadot12_4_1 + minus_E4_13 * B_thetadot12_5_3;
  const T B_thetadot12_3_3 = E4_11 * B_thetadot12_5_3 - minus_E4_13 * B_thetadot12_4_1;
  // K_thetadot12_3 = q4~ E4^T B_thetadot12_4 + E4^T K_thetadot12_4
  const T K_thetadot12_3_1 = T(0.2) * B_thetadot12_3_3 - b4_26 + E4_11 * K_thetadot12_4_1 + minus_E4_13 *
      K_thetadot12_4_3;
  const T b3_21 = T(0.1) * B_thetadot12_3_1;
  const T K_thetadot12_3_2 = b3_21 - T(0.3) * B_thetadot12_3_3 + K_thetadot12_4_2;
  const T K_thetadot12_3_3 = b4_27 - T(0.2) * B_thetadot12_3_1 + E4_11 * K_thetadot12_4_3 - minus_E4_13 *
      K_thetadot12_4_1;
  A[43] = K_thetadot12_3_1;
  A[178] = K_thetadot12_3_1;
  // B_thetadot11_3 = E4^T B_thetadot11_4
  const T B_thetadot11_3_1 = E4_11 * B_thetadot11_4_1 + minus_E4_13 * B_thetadot11_5_3;
  const T B_thetadot11_3_3 = E4_11 * B_thetadot11_5_3 - minus_E4_13 * B_thetadot11_4_1;
  // K_thetadot11_3 = q4~ E4^T B_thetadot11_4 + E4^T K_thetadot11_4
  const T K_thetadot11_3_1 = T(0.2) * B_thetadot11_3_3 - b4_28 + E4_11 * K_thetadot11_4_1 + minus_E4_13 *
      K_thetadot11_4_3;
  const T b3_22 = T(0.1) * B_thetadot11_3_1;
  const T K_thetadot11_3_2 = b3_22 - T(0.3) * B_thetadot11_3_3 + K_thetadot11_4_2;
  const T K_thetadot11_3_3 = b4_29 - T(0.2) * B_thetadot11_3_1 + E4_11 * K_thetadot11_4_3 - minus_E4_13 *
      K_thetadot11_4_1;
  A[42] = K_thetadot11_3_1;
  A[162] = K_thetadot11_3_1;
  // B_thetadot10_3 = E4^T B_thetadot10_4
  const T B_thetadot10_3_1 = E4_11 * B_thetadot10_4_1 + minus_E4_13 * B_thetadot10_5_3;
  const T B_thetadot10_3_3 = E4_11 * B_thetadot10_5_3 - minus_E4_13 * B_thetadot10_4_1;
  // K_thetadot10_3 = q4~ E4^T B_thetadot10_4 + E4^T K_thetadot10_4
  const T K_thetadot10_3_1 = T(0.2) * B_thetadot10_3_3 - b4_30 + E4_11 * K_thetadot10_4_1 + minus_E4_13 *
      K_thetadot10_4_3;
  const T b3_23 = T(0.1) * B_thetadot10_3_1;
  const T K_thetadot10_3_2 = b3_23 - T(0.3) * B_thetadot10_3_3 + K_thetadot10_4_2;
  const T K_thetadot10_3_3 = b4_31 - T(0.2) * B_thetadot10_3_1 + E4_11 * K_thetadot10_4_3 - minus_E4_13 *
      K_thetadot10_4_1;
  A[41] = K_thetadot10_3_1;
  A[146] = K_thetadot10_3_1;
  // B_thetadot9_3 = E4^T B_thetadot9_4
  const T B_thetadot9_3_1 = E4_11 * B_thetadot9_4_1 + minus_E4_13 * B_thetadot9_5_3;
  const T B_thetadot9_3_3 = E4_11 * B_thetadot9_5_3 - minus_E4_13 * B_thetadot9_4_1;
  // K_thetadot9_3 = q4~ E4^T B_thetadot9_4 + E4^T K_thetadot9_4
  const T K_thetadot9_3_1 = T(0.2) * B_thetadot9_3_3 - b4_32 + E4_11 * K_thetadot9_4_1 + minus_E4_13 *
      K_thetadot9_4_3;
  const T b3_24 = T(0.1) * B_thetadot9_3_1;
  const T K_thetadot9_3_2 = b3_24 - T(0.3) * B_thetadot9_3_3 + K_thetadot9_4_2;
  const T K_thetadot9_3_3 = b4_33 - T(0.2) * B_thetadot9_3_1 + E4_11 * K_thetadot9_4_3 - minus_E4_13 *
      K_thetadot9_4_1;
  A[40] = K_thetadot9_3_1;
  A[130] = K_thetadot9_3_1;
  // B_thetadot8_3 = E4^T B_thetadot8_4
  const T B_thetadot8_3_1 = minus_E4_13 * B_thetadot8_5_3 - E4_11 * minus_B_thetadot8_4_1;
  const T B_thetadot8_3_3 = minus_E4_13 * minus_B_thetadot8_4_1 + E4_11 * B_thetadot8_5_3;
  // K_thetadot8_3 = q4~ E4^T B_thetadot8_4 + E4^T K_thetadot8_4
  const T K_thetadot8_3_1 = T(0.2) * B_thetadot8_3_3 - b4_34 + E4_11 * K_thetadot8_4_1 + minus_E4_13 *
      K_thetadot8_4_3;
  const T b3_25 = T(0.1) * B_thetadot8_3_1;
  const T K_thetadot8_3_2 = b3_25 - T(0.3) * B_thetadot8_3_3 + K_thetadot8_4_2;
  const T K_thetadot8_3_3 = b4_35 - T(0.2) * B_thetadot8_3_1 + E4_11 * K_thetadot8_4_3 - minus_E4_13 *
      K_thetadot8_4_1;
  A[39] = K_thetadot8_3_1;
  A[114] = K_thetadot8_3_1;
  // B_thetadot7_3 = E4^T B_thetadot7_4
  const T B_thetadot7_3_1 = E4_11 * B_thetadot7_4_1 - minus_E4_13 * minus_B_thetadot7_5_3;
  const T minus_B_thetadot7_3_3 = minus_E4_13 * B_thetadot7_4_1 + E4_11 * minus_B_thetadot7_5_3;
  // K_thetadot7_3 = q4~ E4^T B_thetadot7_4 + E4^T K_thetadot7_4
  const T K_thetadot7_3_1 = E4_11 * K_thetadot7_4_1 + minus_E4_13 * K_thetadot7_4_3 - b4_36 - T(0.2) *
      minus_B_thetadot7_3_3;
  const T b3_26 = T(0.1) * B_thetadot7_3_1;
  const T K_thetadot7_3_2 = b3_26 + T(0.3) * minus_B_thetadot7_3_3 + K_thetadot7_4_2;
  const T K_thetadot7_3_3 = b4_37 - T(0.2) * B_thetadot7_3_1 + E4_11 * K_thetadot7_4_3 - minus_E4_13 *
      K_thetadot7_4_1;
  A[38] = K_thetadot7_3_1;
  A[98] = K_thetadot7_3_1;
  // B_thetadot6_3 = E4^T B_thetadot6_4
  const T B_thetadot6_3_1 = E4_11 * B_thetadot6_4_1 + minus_E4_13 * hc6_2;
  const T B_thetadot6_3_3 = E4_11 * hc6_2 - minus_E4_13 * B_thetadot6_4_1;
  // K_thetadot6_3 = q4~ E4^T B_thetadot6_4 + E4^T K_thetadot6_4
  const T K_thetadot6_3_1 = b4_38 + T(0.2) * B_thetadot6_3_3 + E4_11 * K_thetadot6_4_1 + minus_E4_13 *
      K_thetadot6_4_3;
  const T b3_27 = T(0.1) * B_thetadot6_3_1;
  const T K_thetadot6_3_2 = b3_27 - T(0.3) * B_thetadot6_3_3 + K_thetadot6_4_2;
  const T K_thetadot6_3_3 = E4_11 * K_thetadot6_4_3 - minus_E4_13 * K_thetadot6_4_1 - b4_39 - T(0.2) *
      B_thetadot6_3_1;
  A[37] = K_thetadot6_3_1;
  A[82] = K_thetadot6_3_1;
  // B_thetadot5_3 = E4^T B_thetadot5_4
  const T minus_B_thetadot5_3_1 = E4_11 * hc5_2;
  const T B_thetadot5_3_3 = minus_E4_13 * hc5_2;
  // K_thetadot5_3 = q4~ E4^T B_thetadot5_4 + E4^T K_thetadot5_4
  const T K_thetadot5_3_1 = T(0.2) * B_thetadot5_3_3 - b4_10 + E4_11 * b4_11 + minus_E4_13 * b4_17;
  const T b3_28 = T(0.1) * minus_B_thetadot5_3_1;
  const T K_thetadot5_3_2 = b4_16 - b3_28 - T(0.3) * B_thetadot5_3_3;
  const T K_thetadot5_3_3 = b4_13 + T(0.2) * minus_B_thetadot5_3_1 + E4_11 * b4_17 - minus_E4_13 * b4_11;
  A[36] = K_thetadot5_3_1;
  A[66] = K_thetadot5_3_1;
  // K_thetadot4_3 = q4~ E4^T B_thetadot4_4 + E4^T K_thetadot4_4
  const T K_thetadot4_3_3 = E4_11 * J4_32 - minus_E4_13 * J4_12 - b3_16;
  A[35] = b3_9;
  A[50] = b3_9;

  // ---- body 2 (body_2) and what it carries
  // h2 = m2 r2 + m_sub3 q3 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h2_1 = T(8.31) + h3_1;
  const T h2_2 = T(4.335) + hc3_2;
  const T h2_3 = T(2.79) + hc3_3;
  // J2 = -q3~ hc3~ + E3^T J3 E3 - m2 r2~ r2~ + I2 + (-m_sub3 q3~ - hc3~) q3~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T b2_1 = T(0.1) * hc3_3;
  const T b2_2 = T(0.15) * hc3_2;
  const T b2_3 = b2_1 + b2_2 + J3_11;
  const T b2_4 = hc3_3 + T(2.73);
  const T b2_5 = b2_4 * T(0.1);
  const T b2_6 = T(4.095) + hc3_2;
  const T b2_7 = b2_6 * T(0.15);
  const T J2_11 = b2_3 + T(0.171) + b2_5 + b2_7;
  const T b2_8 = J3_12 * E3_22 - J3_13 * E3_23 - T(0.018000000000000002);
  const T J2_12 = b2_8 - T(0.15) * h3_1 - b2_6 * T(0.3);
  const T J2_13 = J3_12 * E3_23 + J3_13 * E3_22 - T(0.1) * h3_1 - T(0.0024000000000000007) - b2_4 * T(0.3);
  const T b2_9 = T(0.3) * hc3_2;
  const T b2_10 = h3_1 + T(8.19);
  const T J2_21 = b2_8 - b2_9 - b2_10 * T(0.15);
  const T b2_11 = E3_22 * J3_22 - E3_23 * J3_32;
  const T b2_12 = E3_22 * J3_23 - E3_23 * J3_33;
  const T b2_13 = T(0.3) * h3_1 + b2_10 * T(0.3);
  const T J2_22 = b2_11 * E3_22 - b2_12 * E3_23 + b2_1 + b2_13 + T(0.159) + b2_5;
  const T J2_23 = b2_11 * E3_23 + b2_12 * E3_22 - T(0.1) * hc3_2 - T(0.0168) - b2_4 * T(0.15);
  const T J2_33 = (E3_23 * J3_22 + E3_22 * J3_32) * E3_23 + (E3_23 * J3_23 + E3_22 * J3_33) * E3_22 + b2_2 + b2_13 +
      T(0.156) + b2_7;
  A[17] = J2_33;
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_1 = E2_11 * h2_1 - E2_12 * h2_2;
  const T hc2_2 = E2_11 * h2_2 + E2_12 * h2_1;
  // B_thetadot16_2 = E3^T B_thetadot16_3
  const T B_thetadot16_2_2 = E3_22 * B_thetadot16_4_2 - E3_23 * B_thetadot16_3_3;
  const T B_thetadot16_2_3 = E3_23 * B_thetadot16_4_2 + E3_22 * B_thetadot16_3_3;
  // K_thetadot16_2 = q3~ E3^T B_thetadot16_3 + E3^T K_thetadot16_3
  const T K_thetadot16_2_1 = T(0.15) * B_thetadot16_2_3 - T(0.1) * B_thetadot16_2_2 + K_thetadot16_3_1;
  const T b2_14 = T(0.3) * B_thetadot16_2_3;
  const T K_thetadot16_2_2 = b3_17 - b2_14 + E3_22 * K_thetadot16_3_2 - E3_23 * K_thetadot16_3_3;
  const T K_thetadot16_2_3 = T(0.3) * B_thetadot16_2_2 - T(0.15) * B_thetadot16_3_1 + E3_23 * K_thetadot16_3_2 + E3_22
      * K_thetadot16_3_3;
  A[31] = K_thetadot16_2_3;
  A[241] = K_thetadot16_2_3;
  // B_thetadot15_2 = E3^T B_thetadot15_3
  const T B_thetadot15_2_2 = E3_22 * B_thetadot15_4_2 - E3_23 * B_thetadot15_3_3;
  const T B_thetadot15_2_3 = E3_23 * B_thetadot15_4_2 + E3_22 * B_thetadot15_3_3;
  // K_thetadot15_2 = q3~ E3^T B_thetadot15_3 + E3^T K_thetadot15_3
  const T K_thetadot15_2_1 = T(0.15) * B_thetadot15_2_3 - T(0.1) * B_thetadot15_2_2 + K_thetadot15_3_1;
  const T b2_15 = T(0.3) * B_thetadot15_2_3;
  const T K_thetadot15_2_2 = b3_18 - b2_15 + E3_22 * K_thetadot15_3_2 - E3_23 * K_thetadot15_3_3;
  const T K_thetadot15_2_3 = T(0.3) * B_thetadot15_2_2 - T(0.15) * B_thetadot15_3_1 + E3_23 * K_thetadot15_3_2 + E3_22
      * K_thetadot15_3_3;
  A[30] = K_thetadot15_2_3;
  A[225] = K_thetadot15_2_3;
  // B_thetadot14_2 = E3^T B_thetadot14_3
  const T B_thetadot14_2_2 = E3_22 * B_thetadot14_4_2 - E3_23 * B_thetadot14_3_3;
  const T B_thetadot14_2_3 = E3_23 * B_thetadot14_4_2 + E3_22 * B_thetadot14_3_3;
  // K_thetadot14_2 = q3~ E3^T B_thetadot14_3 + E3^T K_thetadot14_3
  const T K_thetadot14_2_1 = T(0.15) * B_thetadot14_2_3 - T(0.1) * B_thetadot14_2_2 + K_thetadot14_3_1;
  const T b2_16 = T(0.3) * B_thetadot14_2_3;
  const T K_thetadot14_2_2 = b3_19 - b2_16 + E3_22 * K_thetadot14_3_2 - E3_23 * K_thetadot14_3_3;
  const T K_thetadot14_2_3 = T(0.3) * B_thetadot14_2_2 - T(0.15) * B_thetadot14_3_1 + E3_23 * K_thetadot14_3_2 + E3_22
      * K_thetadot14_3_3;
  A[29] = K_thetadot14_2_3;
  A[209] = K_thetadot14_2_3;
  // B_thetadot13_2 = E3^T B_thetadot13_3
  const T B_thetadot13_2_2 = E3_22 * B_thetadot13_4_2 - E3_23 * B_thetadot13_3_3;
  const T B_thetadot13_2_3 = E3_23 * B_thetadot13_4_2 + E3_22 * B_thetadot13_3_3;
  // K_thetadot13_2 = q3~ E3^T B_thetadot13_3 + E3^T K_thetadot13_3
  const T K_thetadot13_2_1 = T(0.15) * B_thetadot13_2_3 - T(0.1) * B_thetadot13_2_2 + K_thetadot13_3_1;
  const T b2_17 = T(0.3) * B_thetadot13_2_3;
  const T K_thetadot13_2_2 = b3_20 - b2_17 + E3_22 * K_thetadot13_3_2 - E3_23 * K_thetadot13_3_3;
  const T K_thetadot13_2_3 = T(0.3) * B_thetadot13_2_2 - T(0.15) * B_thetadot13_3_1 + E3_23 * K_thetadot13_3_2 + E3_22
      * K_thetadot13_3_3;
  A[28] = K_thetadot13_2_3;
  A[193] = K_thetadot13_2_3;
  // B_thetadot12_2 = E3^T B_thetadot12_3
  const T B_thetadot12_2_2 = E3_22 * B_thetadot12_4_2 - E3_23 * B_thetadot12_3_3;
  const T B_thetadot12_2_3 = E3_23 * B_thetadot12_4_2 + E3_22 * B_thetadot12_3_3;
  // K_thetadot12_2 = q3~ E3^T B_thetadot12_3 + E3^T K_thetadot12_3
  const T K_thetadot12_2_1 = T(0.15) * B_thetadot12_2_3 - T(0.1) * B_thetadot12_2_2 + K_thetadot12_3_1;
  const T b2_18 = T(0.3) * B_thetadot12_2_3;
  const T K_thetadot12_2_2 = b3_21 - b2_18 + E3_22 * K_thetadot12_3_2 - E3_23 * K_thetadot12_3_3;
  const T K_thetadot12_2_3 = T(0.3) * B_thetadot12_2_2 - T(0.15) * B_thetadot12_3_1 + E3_23 * K_thetadot12_3_2 + E3_22
      * K_thetadot12_3_3;
  A[27] = K_thetadot12_2_3;
  A[177] = K_thetadot12_2_3;
  // B_thetadot11_2 = E3^T B_thetadot11_3
  const T B_thetadot11_2_2 = E3_22 * B_thetadot11_4_2 - E3_23 * B_thetadot11_3_3;
  const T B_thetadot11_2_3 = E3_23 * B_thetadot11_4_2 + E3_22 * B_thetadot11_3_3;
  // K_thetadot11_2 = q3~ E3^T B_thetadot11_3 + E3^T K_thetadot11_3
  const T K_thetadot11_2_1 = T(0.15) * B_thetadot11_2_3 - T(0.1) * B_thetadot11_2_2 + K_thetadot11_3_1;
  const T b2_19 = T(0.3) * B_thetadot11_2_3;
  const T K_thetadot11_2_2 = b3_22 - b2_19 + E3_22 * K_thetadot11_3_2 - E3_23 * K_thetadot11_3_3;
  const T K_thetadot11_2_3 = T(0.3) * B_thetadot11_2_2 - T(0.15) * B_thetadot11_3_1 + E3_23 * K_thetadot11_3_2 + E3_22
      * K_thetadot11_3_3;
  A[26] = K_thetadot11_2_3;
  A[161] = K_thetadot11_2_3;
  // B_thetadot10_2 = E3^T B_thetadot10_3
  const T B_thetadot10_2_2 = E3_22 * B_thetadot10_4_2 - E3_23 * B_thetadot10_3_3;
  const T B_thetadot10_2_3 = E3_23 * B_thetadot10_4_2 + E3_22 * B_thetadot10_3_3;
  // K_thetadot10_2 = q3~ E3^T B_thetadot10_3 + E3^T K_thetadot10_3
  const T K_thetadot10_2_1 = T(0.15) * B_thetadot10_2_3 - T(0.1) * B_thetadot10_2_2 + K_thetadot10_3_1;
  const T b2_20 = T(0.3) * B_thetadot10_2_3;
  const T K_thetadot10_2_2 = b3_23 - b2_20 + E3_22 * K_thetadot10_3_2 - E3_23 * K_thetadot10_3_3;
  const T K_thetadot10_2_3 = T(0.3) * B_thetadot10_2_2 - T(0.15) * B_thetadot10_3_1 + E3_23 * K_thetadot10_3_2 + E3_22
      * K_thetadot10_3_3;
  A[25] = K_thetadot10_2_3;
  A[145] = K_thetadot10_2_3;
  // B_thetadot9_2 = E3^T B_thetadot9_3
  const T B_thetadot9_2_2 = E3_22 * B_thetadot9_4_2 - E3_23 * B_thetadot9_3_3;
  const T B_thetadot9_2_3 = E3_23 * B_thetadot9_4_2 + E3_22 * B_thetadot9_3_3;
  // K_thetadot9_2 = q3~ E3^T B_thetadot9_3 + E3^T K_thetadot9_3
  const T K_thetadot9_2_1 = T(0.15) * B_thetadot9_2_3 - T(0.1) * B_thetadot9_2_2 + K_thetadot9_3_1;
  const T b2_21 = T(0.3) * B_thetadot9_2_3;
  const T K_thetadot9_2_2 = b3_24 - b2_21 + E3_22 * K_thetadot9_3_2 - E3_23 * K_thetadot9_3_3;
  const T K_thetadot9_2_3 = T(0.3) * B_thetadot9_2_2 - T(0.15) * B_thetadot9_3_1 + E3_23 * K_thetadot9_3_2 + E3_22 *
      K_thetadot9_3_3;
  A[24] = K_thetadot9_2_3;
  A[129] = K_thetadot9_2_3;
  // B_thetadot8_2 = E3^T B_thetadot8_3
  const T B_thetadot8_2_2 = E3_22 * B_thetadot8_4_2 - E3_23 * B_thetadot8_3_3;
  const T B_thetadot8_2_3 = E3_23 * B_thetadot8_4_2 + E3_22 * B_thetadot8_3_3;
  // K_thetadot8_2 = q3~ E3^T B_thetadot8_3 + E3^T K_thetadot8_3
  const T K_thetadot8_2_1 = T(0.15) * B_thetadot8_2_3 - T(0.1) * B_thetadot8_2_2 + K_thetadot8_3_1;
  const T b2_22 = T(0.3) * B_thetadot8_2_3;
  const T K_thetadot8_2_2 = b3_25 - b2_22 + E3_22 * K_thetadot8_3_2 - E3_23 * K_thetadot8_3_3;
  const T K_thetadot8_2_3 = T(0.3) * B_thetadot8_2_2 - T(0.15) * B_thetadot8_3_1 + E3_23 * K_thetadot8_3_2 + E3_22 *
      K_thetadot8_3_3;
  A[23] = K_thetadot8_2_3;
  A[113] = K_thetadot8_2_3;
  // B_thetadot7_2 = E3^T B_thetadot7_3
  const T B_thetadot7_2_2 = E3_22 * B_thetadot7_4_2 + E3_23 * minus_B_thetadot7_3_3;
  const T B_thetadot7_2_3 = E3_23 * B_thetadot7_4_2 - E3_22 * minus_B_thetadot7_3_3;
  // K_thetadot7_2 = q3~ E3^T B_thetadot7_3 + E3^T K_thetadot7_3
  const T K_thetadot7_2_1 = T(0.15) * B_thetadot7_2_3 - T(0.1) * B_thetadot7_2_2 + K_thetadot7_3_1;
  const T b2_23 = T(0.3) * B_thetadot7_2_3;
  const T K_thetadot7_2_2 = b3_26 - b2_23 + E3_22 * K_thetadot7_3_2 - E3_23 * K_thetadot7_3_3;
  const T K_thetadot7_2_3 = T(0.3) * B_thetadot7_2_2 - T(0.15) * B_thetadot7_3_1 + E3_23 * K_thetadot7_3_2 + E3_22 *
      K_thetadot7_3_3;
  A[22] = K_thetadot7_2_3;
  A[97] = K_thetadot7_2_3;
  // B_thetadot6_2 = E3^T B_thetadot6_3
  const T minus_B_thetadot6_2_2 = E3_22 * minus_B_thetadot6_4_2 + E3_23 * B_thetadot6_3_3;
  const T B_thetadot6_2_3 = E3_22 * B_thetadot6_3_3 - E3_23 * minus_B_thetadot6_4_2;
  // K_thetadot6_2 = q3~ E3^T B_thetadot6_3 + E3^T K_thetadot6_3
  const T K_thetadot6_2_1 = T(0.1) * minus_B_thetadot6_2_2 + T(0.15) * B_thetadot6_2_3 + K_thetadot6_3_1;
  const T b2_24 = T(0.3) * B_thetadot6_2_3;
  const T K_thetadot6_2_2 = b3_27 - b2_24 + E3_22 * K_thetadot6_3_2 - E3_23 * K_thetadot6_3_3;
  const T K_thetadot6_2_3 = E3_23 * K_thetadot6_3_2 + E3_22 * K_thetadot6_3_3 - T(0.3) * minus_B_thetadot6_2_2 -
      T(0.15) * B_thetadot6_3_1;
  A[21] = K_thetadot6_2_3;
  A[81] = K_thetadot6_2_3;
  // B_thetadot5_2 = E3^T B_thetadot5_3
  const T B_thetadot5_2_2 = E3_22 * hc5_1 - E3_23 * B_thetadot5_3_3;
  const T B_thetadot5_2_3 = E3_23 * hc5_1 + E3_22 * B_thetadot5_3_3;
  // K_thetadot5_2 = q3~ E3^T B_thetadot5_3 + E3^T K_thetadot5_3
  const T K_thetadot5_2_1 = T(0.15) * B_thetadot5_2_3 - T(0.1) * B_thetadot5_2_2 + K_thetadot5_3_1;
  const T b2_25 = T(0.3) * B_thetadot5_2_3;
  const T K_thetadot5_2_2 = E3_22 * K_thetadot5_3_2 - E3_23 * K_thetadot5_3_3 - b3_28 - b2_25;
  const T K_thetadot5_2_3 = T(0.3) * B_thetadot5_2_2 + T(0.15) * minus_B_thetadot5_3_1 + E3_23 * K_thetadot5_3_2 +
      E3_22 * K_thetadot5_3_3;
  A[20] = K_thetadot5_2_3;
  A[65] = K_thetadot5_2_3;
  // B_thetadot4_2 = E3^T B_thetadot4_3
  const T B_thetadot4_2_2 = E3_23 * hc4_1;
  const T minus_B_thetadot4_2_3 = E3_22 * hc4_1;
  // K_thetadot4_2 = q3~ E3^T B_thetadot4_3 + E3^T K_thetadot4_3
  const T K_thetadot4_2_1 = b3_9 - T(0.1) * B_thetadot4_2_2 - T(0.15) * minus_B_thetadot4_2_3;
  const T b2_26 = T(0.3) * minus_B_thetadot4_2_3;
  const T K_thetadot4_2_2 = b3_3 + b2_26 + E3_22 * b3_13 - E3_23 * K_thetadot4_3_3;
  const T K_thetadot4_2_3 = T(0.3) * B_thetadot4_2_2 - T(0.15) * hc4_3 + E3_23 * b3_13 + E3_22 * K_thetadot4_3_3;
  A[19] = K_thetadot4_2_3;
  A[49] = K_thetadot4_2_3;
  // K_thetadot3_2 = q3~ E3^T B_thetadot3_3 + E3^T K_thetadot3_3
  const T K_thetadot3_2_2 = E3_22 * J3_21 - E3_23 * J3_31 - b2_9;
  const T K_thetadot3_2_3 = E3_23 * J3_21 + E3_22 * J3_31 - T(0.3) * hc3_3;
  A[18] = K_thetadot3_2_3;
  A[33] = K_thetadot3_2_3;

  // ---- body 1 (body_1) and what it carries
  // J1 = -q2~ hc2~ + E2^T J2 E2 - m1 r1~ r1~ + I1 + (-m_sub2 q2~ - hc2~) q2~: inertia carried, about the body origin,
  //   body axes [kg m^2]
  const T J1_22 = (E2_12 * J2_11 + E2_11 * J2_21) * E2_12 + (E2_12 * J2_12 + E2_11 * J2_22) * E2_11 + T(0.1) * h2_3 +
      T(0.3) * hc2_1 + T(0.14575000000000002) + (h2_3 + T(2.85)) * T(0.1) + (hc2_1 + T(8.549999999999999)) * T(0.3);
  A[0] = J1_22;
  // K_thetadot16_1 = q2~ E2^T B_thetadot16_2 + E2^T K_thetadot16_2
  const T K_thetadot16_1_2 = T(0.1) * (E2_11 * B_thetadot16_3_1 - E2_12 * B_thetadot16_2_2) - b2_14 + E2_12 *
      K_thetadot16_2_1 + E2_11 * K_thetadot16_2_2;
  A[15] = K_thetadot16_1_2;
  A[240] = K_thetadot16_1_2;
  // K_thetadot15_1 = q2~ E2^T B_thetadot15_2 + E2^T K_thetadot15_2
  const T K_thetadot15_1_2 = T(0.1) * (E2_11 * B_thetadot15_3_1 - E2_12 * B_thetadot15_2_2) - b2_15 + E2_12 *
      K_thetadot15_2_1 + E2_11 * K_thetadot15_2_2;
  A[14] = K_thetadot15_1_2;
  A[224] = K_thetadot15_1_2;
  // K_thetadot14_1 = q2~ E2^T B_thetadot14_2 + E2^T K_thetadot14_2
  const T K_thetadot14_1_2 = T(0.1) * (E2_11 * B_thetadot14_3_1 - E2_12 * B_thetadot14_2_2) - b2_16 + E2_12 *
      K_thetadot14_2_1 + E2_11 * K_thetadot14_2_2;
  A[13] = K_thetadot14_1_2;
  A[208] = K_thetadot14_1_2;
  // K_thetadot13_1 = q2~ E2^T B_thetadot13_2 + E2^T K_thetadot13_2
  const T K_thetadot13_1_2 = T(0.1) * (E2_11 * B_thetadot13_3_1 - E2_12 * B_thetadot13_2_2) - b2_17 + E2_12 *
      K_thetadot13_2_1 + E2_11 * K_thetadot13_2_2;
  A[12] = K_thetadot13_1_2;
  A[192] = K_thetadot13_1_2;
  // K_thetadot12_1 = q2~ E2^T B_thetadot12_2 + E2^T K_thetadot12_2
  const T K_thetadot12_1_2 = T(0.1) * (E2_11 * B_thetadot12_3_1 - E2_12 * B_thetadot12_2_2) - b2_18 + E2_12 *
      K_thetadot12_2_1 + E2_11 * K_thetadot12_2_2;
  A[11] = K_thetadot12_1_2;
  A[176] = K_thetadot12_1_2;
  // K_thetadot11_1 = q2~ E2^T B_thetadot11_2 + E2^T K_thetadot11_2
  const T K_thetadot11_1_2 = T(0.1) * (E2_11 * B_thetadot11_3_1 - E2_12 * B_thetadot11_2_2) - b2_19 + E2_12 *
      K_thetadot11_2_1 + E2_11 * K_thetadot11_2_2;
  A[10] = K_thetadot11_1_2;
  A[160] = K_thetadot11_1_2;
  // K_thetadot10_1 = q2~ E2^T B_thetadot10_2 + E2^T K_thetadot10_2
  const T K_thetadot10_1_2 = T(0.1) * (E2_11 * B_thetadot10_3_1 - E2_12 * B_thetadot10_2_2) - b2_20 + E2_12 *
      K_thetadot10_2_1 + E2_11 * K_thetadot10_2_2;
  A[9] = K_thetadot10_1_2;
  A[144] = K_thetadot10_1_2;
  // K_thetadot9_1 = q2~ E2^T B_thetadot9_2 + E2^T K_thetadot9_2
  const T K_thetadot9_1_2 = T(0.1) * (E2_11 * B_thetadot9_3_1 - E2_12 * B_thetadot9_2_2) - b2_21 + E2_12 *
      K_thetadot9_2_1 + E2_11 * K_thetadot9_2_2;
  A[8] = K_thetadot9_1_2;
  A[128] = K_thetadot9_1_2;
  // K_thetadot8_1 = q2~ E2^T B_thetadot8_2 + E2^T K_thetadot8_2
  const T K_thetadot8_1_2 = T(0.1) * (E2_11 * B_thetadot8_3_1 - E2_12 * B_thetadot8_2_2) - b2_22 + E2_12 *
      K_thetadot8_2_1 + E2_11 * K_thetadot8_2_2;
  A[7] = K_thetadot8_1_2;
  A[112] = K_thetadot8_1_2;
  // K_thetadot7_1 = q2~ E2^T B_thetadot7_2 + E2^T K_thetadot7_2
  const T K_thetadot7_1_2 = T(0.1) * (E2_11 * B_thetadot7_3_1 - E2_12 * B_thetadot7_2_2) - b2_23 + E2_12 *
      K_thetadot7_2_1 + E2_11 * K_thetadot7_2_2;
  A[6] = K_thetadot7_1_2;
  A[96] = K_thetadot7_1_2;
  // K_thetadot6_1 = q2~ E2^T B_thetadot6_2 + E2^T K_thetadot6_2
  const T K_thetadot6_1_2 = T(0.1) * (E2_11 * B_thetadot6_3_1 + E2_12 * minus_B_thetadot6_2_2) - b2_24 + E2_12 *
      K_thetadot6_2_1 + E2_11 * K_thetadot6_2_2;
  A[5] = K_thetadot6_1_2;
  A[80] = K_thetadot6_1_2;
  // K_thetadot5_1 = q2~ E2^T B_thetadot5_2 + E2^T K_thetadot5_2
  const T K_thetadot5_1_2 = E2_12 * K_thetadot5_2_1 + E2_11 * K_thetadot5_2_2 - T(0.1) * (E2_11 *
      minus_B_thetadot5_3_1 + E2_12 * B_thetadot5_2_2) - b2_25;
  A[4] = K_thetadot5_1_2;
  A[64] = K_thetadot5_1_2;
  // K_thetadot4_1 = q2~ E2^T B_thetadot4_2 + E2^T K_thetadot4_2
  const T K_thetadot4_1_2 = T(0.1) * (E2_11 * hc4_3 - E2_12 * B_thetadot4_2_2) + b2_26 + E2_12 * K_thetadot4_2_1 +
      E2_11 * K_thetadot4_2_2;
  A[3] = K_thetadot4_1_2;
  A[48] = K_thetadot4_1_2;
  // K_thetadot3_1 = q2~ E2^T B_thetadot3_2 + E2^T K_thetadot3_2
  const T K_thetadot3_1_2 = E2_12 * hc3_3 * T(0.1) - b2_9 + E2_12 * b2_3 + E2_11 * K_thetadot3_2_2;
  A[2] = K_thetadot3_1_2;
  A[32] = K_thetadot3_1_2;
  // K_thetadot2_1 = q2~ E2^T B_thetadot2_2 + E2^T K_thetadot2_2
  const T K_thetadot2_1_2 = E2_12 * J2_13 + E2_11 * J2_23 - T(0.1) * hc2_2;
  A[1] = K_thetadot2_1_2;
  A[16] = K_thetadot2_1_2;

  // ---- results
  A[255] = T(0.34450000000000003);
}

}  // namespace kanec::bench_cr16
