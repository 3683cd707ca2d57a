// SPDX-License-Identifier: BSD-3-Clause
// six_body: equations of motion of 6 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model fd769df5120c306f of six_body/scene.toml; the usual functions
// bodies and their joints:
//   1 hub on the inertial frame: free
//   2 boom on 1: free
//   3 panel on 2: free
//   4 payload on 2: free
//   5 arm on 1: free
//   6 tool on 5: free
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, eps_2_1 .. eps_2_4, eps_3_1 .. eps_3_4, eps_4_1 .. eps_4_4, eps_5_1 .. eps_5_4,
//   eps_6_1 .. eps_6_4, s_1_1 .. s_1_3, s_2_1 .. s_2_3, s_3_1 .. s_3_3, s_4_1 .. s_4_3, s_5_1 .. s_5_3,
//   s_6_1 .. s_6_3)
//   y = (omega_1_1 .. omega_1_3, omega_2_1 .. omega_2_3, omega_3_1 .. omega_3_3, omega_4_1 .. omega_4_3,
//   omega_5_1 .. omega_5_3, omega_6_1 .. omega_6_3, sdot_1_1 .. sdot_1_3, sdot_2_1 .. sdot_2_3, sdot_3_1 .. sdot_3_3,
//   sdot_4_1 .. sdot_4_3, sdot_5_1 .. sdot_5_3, sdot_6_1 .. sdot_6_3)
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
//   poses                   351 (180 add, 171 multiply)
//   energy                  711 (337 add, 374 multiply)
//   momentum                958 (465 add, 493 multiply)
//   power                   535 (263 add, 272 multiply)
//   accelerations           944 (472 add, 472 multiply)
//   residual                1237 (619 add, 618 multiply)
//   forcing                 1115 (528 add, 587 multiply)
//   mass_matrix             1395 (501 add, 894 multiply)
//   partial_velocities      450 (180 add, 270 multiply)
//   partial_velocity_rates  792 (324 add, 468 multiply)
#pragma once

namespace kanec::six_body {

inline constexpr int n_bodies = 6;
inline constexpr int nx = 42;
inline constexpr int ny = 36;
inline constexpr int n_parameters = 1;
inline constexpr int n_inputs = 1;
inline constexpr char model_hash[] = "fd769df5120c306f";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, eps_2_1 = 4, eps_2_2 = 5, eps_2_3 = 6,
    eps_2_4 = 7, eps_3_1 = 8, eps_3_2 = 9, eps_3_3 = 10, eps_3_4 = 11, eps_4_1 = 12, eps_4_2 = 13, eps_4_3 = 14,
    eps_4_4 = 15, eps_5_1 = 16, eps_5_2 = 17, eps_5_3 = 18, eps_5_4 = 19, eps_6_1 = 20, eps_6_2 = 21, eps_6_3 = 22,
    eps_6_4 = 23, s_1_1 = 24, s_1_2 = 25, s_1_3 = 26, s_2_1 = 27, s_2_2 = 28, s_2_3 = 29, s_3_1 = 30, s_3_2 = 31,
    s_3_3 = 32, s_4_1 = 33, s_4_2 = 34, s_4_3 = 35, s_5_1 = 36, s_5_2 = 37, s_5_3 = 38, s_6_1 = 39, s_6_2 = 40,
    s_6_3 = 41;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, omega_2_1 = 3, omega_2_2 = 4, omega_2_3 = 5,
    omega_3_1 = 6, omega_3_2 = 7, omega_3_3 = 8, omega_4_1 = 9, omega_4_2 = 10, omega_4_3 = 11, omega_5_1 = 12,
    omega_5_2 = 13, omega_5_3 = 14, omega_6_1 = 15, omega_6_2 = 16, omega_6_3 = 17, sdot_1_1 = 18, sdot_1_2 = 19,
    sdot_1_3 = 20, sdot_2_1 = 21, sdot_2_2 = 22, sdot_2_3 = 23, sdot_3_1 = 24, sdot_3_2 = 25, sdot_3_3 = 26,
    sdot_4_1 = 27, sdot_4_2 = 28, sdot_4_3 = 29, sdot_5_1 = 30, sdot_5_2 = 31, sdot_5_3 = 32, sdot_6_1 = 33,
    sdot_6_2 = 34, sdot_6_3 = 35;
inline constexpr int eps_hub_1 = 0, eps_hub_2 = 1, eps_hub_3 = 2, eps_hub_4 = 3, eps_boom_1 = 4, eps_boom_2 = 5,
    eps_boom_3 = 6, eps_boom_4 = 7, eps_panel_1 = 8, eps_panel_2 = 9, eps_panel_3 = 10, eps_panel_4 = 11,
    eps_payload_1 = 12, eps_payload_2 = 13, eps_payload_3 = 14, eps_payload_4 = 15, eps_arm_1 = 16, eps_arm_2 = 17,
    eps_arm_3 = 18, eps_arm_4 = 19, eps_tool_1 = 20, eps_tool_2 = 21, eps_tool_3 = 22, eps_tool_4 = 23, s_hub_1 = 24,
    s_hub_2 = 25, s_hub_3 = 26, s_boom_1 = 27, s_boom_2 = 28, s_boom_3 = 29, s_panel_1 = 30, s_panel_2 = 31,
    s_panel_3 = 32, s_payload_1 = 33, s_payload_2 = 34, s_payload_3 = 35, s_arm_1 = 36, s_arm_2 = 37, s_arm_3 = 38,
    s_tool_1 = 39, s_tool_2 = 40, s_tool_3 = 41;
inline constexpr int omega_hub_1 = 0, omega_hub_2 = 1, omega_hub_3 = 2, omega_boom_1 = 3, omega_boom_2 = 4,
    omega_boom_3 = 5, omega_panel_1 = 6, omega_panel_2 = 7, omega_panel_3 = 8, omega_payload_1 = 9,
    omega_payload_2 = 10, omega_payload_3 = 11, omega_arm_1 = 12, omega_arm_2 = 13, omega_arm_3 = 14,
    omega_tool_1 = 15, omega_tool_2 = 16, omega_tool_3 = 17, sdot_hub_1 = 18, sdot_hub_2 = 19, sdot_hub_3 = 20,
    sdot_boom_1 = 21, sdot_boom_2 = 22, sdot_boom_3 = 23, sdot_panel_1 = 24, sdot_panel_2 = 25, sdot_panel_3 = 26,
    sdot_payload_1 = 27, sdot_payload_2 = 28, sdot_payload_3 = 29, sdot_arm_1 = 30, sdot_arm_2 = 31, sdot_arm_3 = 32,
    sdot_tool_1 = 33, sdot_tool_2 = 34, sdot_tool_3 = 35;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 726;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0,
    0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2,
    2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4, 4,
    4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 6, 6,
    6, 6, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8, 8,
    8, 8, 8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10,
    10, 10, 10, 10, 10, 10, 10, 10, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 12, 12,
    12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 12, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13,
    13, 13, 13, 13, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 15, 15, 15, 15, 15, 15, 15,
    15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16,
    16, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 18, 18, 18, 18, 18, 18, 18, 18, 18,
    18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 19, 19, 19,
    19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19, 19,
    19, 19, 19, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20, 20,
    20, 20, 20, 20, 20, 20, 20, 20, 20, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21, 21,
    21, 21, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 22, 23, 23, 23, 23, 23,
    23, 23, 23, 23, 23, 23, 23, 23, 23, 23, 23, 23, 23, 23, 23, 23, 24, 24, 24, 24, 24, 24, 24, 24, 24, 24, 24, 24,
    24, 24, 24, 25, 25, 25, 25, 25, 25, 25, 25, 25, 25, 25, 25, 25, 25, 25, 26, 26, 26, 26, 26, 26, 26, 26, 26, 26,
    26, 26, 26, 26, 26, 27, 27, 27, 27, 27, 27, 27, 27, 27, 27, 27, 27, 27, 27, 27, 28, 28, 28, 28, 28, 28, 28, 28,
    28, 28, 28, 28, 28, 28, 28, 29, 29, 29, 29, 29, 29, 29, 29, 29, 29, 29, 29, 29, 29, 29, 30, 30, 30, 30, 30, 30,
    30, 30, 30, 30, 30, 30, 30, 30, 30, 31, 31, 31, 31, 31, 31, 31, 31, 31, 31, 31, 31, 31, 31, 31, 32, 32, 32, 32,
    32, 32, 32, 32, 32, 32, 32, 32, 32, 32, 32, 33, 33, 33, 33, 33, 33, 33, 33, 33, 33, 33, 33, 33, 33, 33, 34, 34,
    34, 34, 34, 34, 34, 34, 34, 34, 34, 34, 34, 34, 34, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35, 35};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 18, 19,
    20, 22, 23, 24, 25, 26, 27, 28, 29, 31, 32, 33, 34, 35, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16,
    17, 18, 19, 20, 21, 23, 24, 25, 26, 27, 28, 29, 30, 32, 33, 34, 35, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13,
    14, 15, 16, 17, 18, 19, 20, 21, 22, 24, 25, 26, 27, 28, 29, 30, 31, 33, 34, 35, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10,
    11, 18, 19, 20, 21, 22, 23, 25, 26, 28, 29, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 18, 19, 20, 21, 22, 23, 24, 26,
    27, 29, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 18, 19, 20, 21, 22, 23, 24, 25, 27, 28, 0, 1, 2, 3, 4, 5, 6, 7, 8,
    18, 19, 20, 21, 22, 23, 24, 25, 26, 0, 1, 2, 3, 4, 5, 6, 7, 8, 18, 19, 20, 21, 22, 23, 24, 25, 26, 0, 1, 2, 3, 4,
    5, 6, 7, 8, 18, 19, 20, 21, 22, 23, 24, 25, 26, 0, 1, 2, 3, 4, 5, 9, 10, 11, 18, 19, 20, 21, 22, 23, 27, 28, 29,
    0, 1, 2, 3, 4, 5, 9, 10, 11, 18, 19, 20, 21, 22, 23, 27, 28, 29, 0, 1, 2, 3, 4, 5, 9, 10, 11, 18, 19, 20, 21, 22,
    23, 27, 28, 29, 0, 1, 2, 12, 13, 14, 15, 16, 17, 18, 19, 20, 30, 31, 32, 34, 35, 0, 1, 2, 12, 13, 14, 15, 16, 17,
    18, 19, 20, 30, 31, 32, 33, 35, 0, 1, 2, 12, 13, 14, 15, 16, 17, 18, 19, 20, 30, 31, 32, 33, 34, 0, 1, 2, 12, 13,
    14, 15, 16, 17, 18, 19, 20, 30, 31, 32, 33, 34, 35, 0, 1, 2, 12, 13, 14, 15, 16, 17, 18, 19, 20, 30, 31, 32, 33,
    34, 35, 0, 1, 2, 12, 13, 14, 15, 16, 17, 18, 19, 20, 30, 31, 32, 33, 34, 35, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11,
    12, 13, 14, 15, 16, 17, 18, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 0, 1, 2, 3, 4, 5, 6, 7, 8,
    9, 10, 11, 12, 13, 14, 15, 16, 17, 19, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 0, 1, 2, 3, 4,
    5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 20, 21, 22, 23, 24, 25, 26, 27, 28, 29, 30, 31, 32, 33, 34, 35, 1,
    2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 18, 19, 20, 21, 24, 25, 26, 27, 28, 29, 0, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 18, 19,
    20, 22, 24, 25, 26, 27, 28, 29, 0, 1, 3, 4, 5, 6, 7, 8, 9, 10, 11, 18, 19, 20, 23, 24, 25, 26, 27, 28, 29, 0, 1,
    2, 4, 5, 6, 7, 8, 18, 19, 20, 21, 22, 23, 24, 0, 1, 2, 3, 5, 6, 7, 8, 18, 19, 20, 21, 22, 23, 25, 0, 1, 2, 3, 4,
    6, 7, 8, 18, 19, 20, 21, 22, 23, 26, 0, 1, 2, 4, 5, 9, 10, 11, 18, 19, 20, 21, 22, 23, 27, 0, 1, 2, 3, 5, 9, 10,
    11, 18, 19, 20, 21, 22, 23, 28, 0, 1, 2, 3, 4, 9, 10, 11, 18, 19, 20, 21, 22, 23, 29, 1, 2, 12, 13, 14, 15, 16,
    17, 18, 19, 20, 30, 33, 34, 35, 0, 2, 12, 13, 14, 15, 16, 17, 18, 19, 20, 31, 33, 34, 35, 0, 1, 12, 13, 14, 15,
    16, 17, 18, 19, 20, 32, 33, 34, 35, 0, 1, 2, 13, 14, 15, 16, 17, 18, 19, 20, 30, 31, 32, 33, 0, 1, 2, 12, 14, 15,
    16, 17, 18, 19, 20, 30, 31, 32, 34, 0, 1, 2, 12, 13, 15, 16, 17, 18, 19, 20, 30, 31, 32, 35};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T m_payload = T(1.2);
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
  T thrust = T(2);
};

// What depends on parameters only, computed once for many calls.
template <class T>
struct Prepared {
  Parameters<T> p;
  T c4_1;
  T a4_1;
  T c4_2;
  T a4_3;
  T J4_11;
  T J4_12;
  T J4_13;
  T J4_22;
  T J4_23;
  T J4_33;
  T c4_3;
  T h4_2;
  T h4_3;
  T m_sub2;
  T m_sub1;
};

// prepare: 8 add, 13 multiply, 1 divide
template <class T>
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  Prepared<T> c{};
  c.p = p;
  const T c4_1 = T(0.5) * p.m_payload;
  const T t1 = T(1) / p.m_payload;
  const T a4_1 = t1 * T(0.1);
  const T c4_2 = t1 * T(0.15);
  const T a4_3 = t1 * T(0.05);
  const T J4_11 = p.m_payload * T(0.013600000000000001) + T(0.06);
  const T J4_12 = p.m_payload * T(0.0018) + T(0.004);
  const T J4_13 = p.m_payload * T(0.003) - T(0.002);
  const T J4_22 = p.m_payload * T(0.010900000000000002) + T(0.075);
  const T J4_23 = T(0.003) - p.m_payload * T(0.006);
  const T J4_33 = p.m_payload * T(0.0045) + T(0.052);
  const T c4_3 = p.m_payload * T(0.03);
  const T h4_2 = p.m_payload * T(0.06);
  const T h4_3 = p.m_payload * T(0.1);
  const T m_sub2 = T(5.3) + p.m_payload;
  const T m_sub1 = T(15.5) + m_sub2;
  c.c4_1 = c4_1;
  c.a4_1 = a4_1;
  c.c4_2 = c4_2;
  c.a4_3 = a4_3;
  c.J4_11 = J4_11;
  c.J4_12 = J4_12;
  c.J4_13 = J4_13;
  c.J4_22 = J4_22;
  c.J4_23 = J4_23;
  c.J4_33 = J4_33;
  c.c4_3 = c4_3;
  c.h4_2 = h4_2;
  c.h4_3 = h4_3;
  c.m_sub2 = m_sub2;
  c.m_sub1 = m_sub1;
  return c;
}

// kinematics: xdot, the kinematical equations.
// rates of x (nx) [1/s], [rad/s], [m/s]
// 48 add, 90 multiply
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

  // ---- body 2 (boom) on body 1
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

  // ---- body 3 (panel) on body 2
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

  // ---- body 4 (payload) on body 2
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

  // ---- body 5 (arm) on body 1
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

  // ---- body 6 (tool) on body 5
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
  const T sdot2_1 = y[21], sdot2_2 = y[22], sdot2_3 = y[23];
  const T sdot3_1 = y[24], sdot3_2 = y[25], sdot3_3 = y[26];
  const T sdot4_1 = y[27], sdot4_2 = y[28], sdot4_3 = y[29];
  const T sdot5_1 = y[30], sdot5_2 = y[31], sdot5_3 = y[32];
  const T sdot6_1 = y[33], sdot6_2 = y[34], sdot6_3 = y[35];
  xdot[24] = sdot1_1;
  xdot[25] = sdot1_2;
  xdot[26] = sdot1_3;
  xdot[27] = sdot2_1;
  xdot[28] = sdot2_2;
  xdot[29] = sdot2_3;
  xdot[30] = sdot3_1;
  xdot[31] = sdot3_2;
  xdot[32] = sdot3_3;
  xdot[33] = sdot4_1;
  xdot[34] = sdot4_2;
  xdot[35] = sdot4_3;
  xdot[36] = sdot5_1;
  xdot[37] = sdot5_2;
  xdot[38] = sdot5_3;
  xdot[39] = sdot6_1;
  xdot[40] = sdot6_2;
  xdot[41] = sdot6_3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 180 add, 171 multiply
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {

  // ---- body 1 (hub) on the inertial frame
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
  const T p1_1 = s1_1 + R1_11 * T(0.05) - R1_21 * T(0.02) + R1_31 * T(0.08);
  const T p1_2 = s1_2 + R1_12 * T(0.05) - R1_22 * T(0.02) + R1_32 * T(0.08);
  const T p1_3 = s1_3 + R1_13 * T(0.05) - R1_23 * T(0.02) + R1_33 * T(0.08);
  pose[9] = p1_1;
  pose[10] = p1_2;
  pose[11] = p1_3;

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
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
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
  // P2 = s1 + R1^T d2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * d2_1 + R1_21 * d2_2 + R1_31 * d2_3;
  const T P2_2 = s1_2 + R1_12 * d2_1 + R1_22 * d2_2 + R1_32 * d2_3;
  const T P2_3 = s1_3 + R1_13 * d2_1 + R1_23 * d2_2 + R1_33 * d2_3;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = P2_1 + R2_11 * T(0.03) + R2_21 * T(0.04) + R2_31 * T(0.45);
  const T p2_2 = P2_2 + R2_12 * T(0.03) + R2_22 * T(0.04) + R2_32 * T(0.45);
  const T p2_3 = P2_3 + R2_13 * T(0.03) + R2_23 * T(0.04) + R2_33 * T(0.45);
  pose[21] = p2_1;
  pose[22] = p2_2;
  pose[23] = p2_3;

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
  // P3 = R2^T d3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 + R2_11 * d3_1 + R2_21 * d3_2 + R2_31 * d3_3;
  const T P3_2 = P2_2 + R2_12 * d3_1 + R2_22 * d3_2 + R2_32 * d3_3;
  const T P3_3 = P2_3 + R2_13 * d3_1 + R2_23 * d3_2 + R2_33 * d3_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 + R3_11 * T(0.1) + R3_21 * T(0.35) - R3_31 * T(0.02);
  const T p3_2 = P3_2 + R3_12 * T(0.1) + R3_22 * T(0.35) - R3_32 * T(0.02);
  const T p3_3 = P3_3 + R3_13 * T(0.1) + R3_23 * T(0.35) - R3_33 * T(0.02);
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
  // P4 = R2^T d4 + P2: position of the body origin, inertial axes [m]
  const T P4_1 = P2_1 + R2_11 * d4_1 + R2_21 * d4_2 + R2_31 * d4_3;
  const T P4_2 = P2_2 + R2_12 * d4_1 + R2_22 * d4_2 + R2_32 * d4_3;
  const T P4_3 = P2_3 + R2_13 * d4_1 + R2_23 * d4_2 + R2_33 * d4_3;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 + R4_21 * T(0.06) - R4_11 * T(0.03) + R4_31 * T(0.1);
  const T p4_2 = P4_2 + R4_22 * T(0.06) - R4_12 * T(0.03) + R4_32 * T(0.1);
  const T p4_3 = P4_3 + R4_23 * T(0.06) - R4_13 * T(0.03) + R4_33 * T(0.1);
  pose[45] = p4_1;
  pose[46] = p4_2;
  pose[47] = p4_3;

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
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
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
  // P5 = s1 + R1^T d5: position of the body origin, inertial axes [m]
  const T P5_1 = s1_1 + R1_11 * d5_1 + R1_21 * d5_2 + R1_31 * d5_3;
  const T P5_2 = s1_2 + R1_12 * d5_1 + R1_22 * d5_2 + R1_32 * d5_3;
  const T P5_3 = s1_3 + R1_13 * d5_1 + R1_23 * d5_2 + R1_33 * d5_3;
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_1 = P5_1 + R5_11 * T(0.38) + R5_21 * T(0.02) - R5_31 * T(0.04);
  const T p5_2 = P5_2 + R5_12 * T(0.38) + R5_22 * T(0.02) - R5_32 * T(0.04);
  const T p5_3 = P5_3 + R5_13 * T(0.38) + R5_23 * T(0.02) - R5_33 * T(0.04);
  pose[57] = p5_1;
  pose[58] = p5_2;
  pose[59] = p5_3;

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
  // P6 = R5^T d6 + P5: position of the body origin, inertial axes [m]
  const T P6_1 = P5_1 + R5_11 * d6_1 + R5_21 * d6_2 + R5_31 * d6_3;
  const T P6_2 = P5_2 + R5_12 * d6_1 + R5_22 * d6_2 + R5_32 * d6_3;
  const T P6_3 = P5_3 + R5_13 * d6_1 + R5_23 * d6_2 + R5_33 * d6_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = P6_1 + R6_11 * T(0.09) - R6_21 * T(0.05) + R6_31 * T(0.07);
  const T p6_2 = P6_2 + R6_12 * T(0.09) - R6_22 * T(0.05) + R6_32 * T(0.07);
  const T p6_3 = P6_3 + R6_13 * T(0.09) - R6_23 * T(0.05) + R6_33 * T(0.07);
  pose[69] = p6_1;
  pose[70] = p6_2;
  pose[71] = p6_3;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 337 add, 374 multiply
template <class T>
void energy(const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {

  // ---- body 1 (hub) on the inertial frame
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
  const T p1_3 = s1_3 + R1_13 * T(0.05) - R1_23 * T(0.02) + R1_33 * T(0.08);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_3 * T(0.02) + omega1_2 * T(0.08);
  const T t1_14 = T(0.05) * omega1_3;
  const T t1_15 = t1_14 - omega1_1 * T(0.08);
  const T t1_16 = T(0.05) * omega1_2;
  const T t1_17 = t1_16 + omega1_1 * T(0.02);
  const T v1_1 = sdot1_1 + R1_11 * t1_13 + R1_21 * t1_15 - R1_31 * t1_17;
  const T v1_2 = sdot1_2 + R1_12 * t1_13 + R1_22 * t1_15 - R1_32 * t1_17;
  const T v1_3 = sdot1_3 + R1_13 * t1_13 + R1_23 * t1_15 - R1_33 * t1_17;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.5) * (omega1_1 * (T(1.1) * omega1_1 + T(0.04) * omega1_2 - T(0.03) * omega1_3) + omega1_2 * (t1_14
      + T(0.04) * omega1_1 + T(0.95) * omega1_2) + omega1_3 * (t1_16 - T(0.03) * omega1_1 + T(1.3) * omega1_3)) + T(6)
      * (v1_1 * v1_1 + v1_2 * v1_2 + v1_3 * v1_3);

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[21], sdot2_2 = y[22], sdot2_3 = y[23];
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
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
  // P2 = s1 + R1^T d2: position of the body origin, inertial axes [m]
  const T P2_3 = s1_3 + R1_13 * d2_1 + R1_23 * d2_2 + R1_33 * d2_3;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_3 = P2_3 + R2_13 * T(0.03) + R2_23 * T(0.04) + R2_33 * T(0.45);
  // Pdot2 = sdot1 + R1^T (omega1~ d2 + sdot2): velocity of the body origin, inertial axes [m/s]
  const T t2_13 = sdot2_1 + omega1_2 * d2_3 - omega1_3 * d2_2;
  const T t2_14 = sdot2_2 + omega1_3 * d2_1 - omega1_1 * d2_3;
  const T t2_15 = sdot2_3 + omega1_1 * d2_2 - omega1_2 * d2_1;
  const T Pdot2_1 = sdot1_1 + R1_11 * t2_13 + R1_21 * t2_14 + R1_31 * t2_15;
  const T Pdot2_2 = sdot1_2 + R1_12 * t2_13 + R1_22 * t2_14 + R1_32 * t2_15;
  const T Pdot2_3 = sdot1_3 + R1_13 * t2_13 + R1_23 * t2_14 + R1_33 * t2_15;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_16 = omega2_2 * T(0.45) - omega2_3 * T(0.04);
  const T t2_17 = T(0.03) * omega2_3;
  const T t2_18 = t2_17 - omega2_1 * T(0.45);
  const T t2_19 = T(0.03) * omega2_2;
  const T t2_20 = omega2_1 * T(0.04) - t2_19;
  const T v2_1 = Pdot2_1 + R2_11 * t2_16 + R2_21 * t2_18 + R2_31 * t2_20;
  const T v2_2 = Pdot2_2 + R2_12 * t2_16 + R2_22 * t2_18 + R2_32 * t2_20;
  const T v2_3 = Pdot2_3 + R2_13 * t2_16 + R2_23 * t2_18 + R2_33 * t2_20;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (omega2_1 * (T(0.42) * omega2_1 + T(0.02) * omega2_2 + T(0.01) * omega2_3) + omega2_2 *
      (T(0.02) * omega2_1 - t2_17 + T(0.38) * omega2_2) + omega2_3 * (T(0.01) * omega2_1 - t2_19 + T(0.11) *
      omega2_3)) + T(1.75) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[24], sdot3_2 = y[25], sdot3_3 = y[26];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
  // P3 = R2^T d3 + P2: position of the body origin, inertial axes [m]
  const T P3_3 = P2_3 + R2_13 * d3_1 + R2_23 * d3_2 + R2_33 * d3_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_3 = P3_3 + R3_13 * T(0.1) + R3_23 * T(0.35) - R3_33 * T(0.02);
  // Pdot3 = R2^T (omega2~ d3 + sdot3) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_13 = sdot3_1 + omega2_2 * d3_3 - omega2_3 * d3_2;
  const T t3_14 = sdot3_2 + omega2_3 * d3_1 - omega2_1 * d3_3;
  const T t3_15 = sdot3_3 + omega2_1 * d3_2 - omega2_2 * d3_1;
  const T Pdot3_1 = Pdot2_1 + R2_11 * t3_13 + R2_21 * t3_14 + R2_31 * t3_15;
  const T Pdot3_2 = Pdot2_2 + R2_12 * t3_13 + R2_22 * t3_14 + R2_32 * t3_15;
  const T Pdot3_3 = Pdot2_3 + R2_13 * t3_13 + R2_23 * t3_14 + R2_33 * t3_15;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_16 = omega3_3 * T(0.1) + omega3_1 * T(0.02);
  const T t3_17 = omega3_3 * T(0.35) + omega3_2 * T(0.02);
  const T t3_18 = omega3_1 * T(0.35) - omega3_2 * T(0.1);
  const T v3_1 = Pdot3_1 + R3_21 * t3_16 - R3_11 * t3_17 + R3_31 * t3_18;
  const T v3_2 = Pdot3_2 + R3_22 * t3_16 - R3_12 * t3_17 + R3_32 * t3_18;
  const T v3_3 = Pdot3_3 + R3_23 * t3_16 - R3_13 * t3_17 + R3_33 * t3_18;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (omega3_1 * (T(0.21) * omega3_1 - T(0.012) * omega3_2 + T(0.006) * omega3_3) + omega3_2 *
      (T(0.09) * omega3_2 - T(0.012) * omega3_1 + T(0.008) * omega3_3) + omega3_3 * (T(0.006) * omega3_1 + T(0.008) *
      omega3_2 + T(0.27) * omega3_3)) + T(0.9) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[27], sdot4_2 = y[28], sdot4_3 = y[29];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
  // P4 = R2^T d4 + P2: position of the body origin, inertial axes [m]
  const T P4_3 = P2_3 + R2_13 * d4_1 + R2_23 * d4_2 + R2_33 * d4_3;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_3 = P4_3 + R4_23 * T(0.06) - R4_13 * T(0.03) + R4_33 * T(0.1);
  // Pdot4 = R2^T (omega2~ d4 + sdot4) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = sdot4_1 + omega2_2 * d4_3 - omega2_3 * d4_2;
  const T t4_14 = sdot4_2 + omega2_3 * d4_1 - omega2_1 * d4_3;
  const T t4_15 = sdot4_3 + omega2_1 * d4_2 - omega2_2 * d4_1;
  const T Pdot4_1 = Pdot2_1 + R2_11 * t4_13 + R2_21 * t4_14 + R2_31 * t4_15;
  const T Pdot4_2 = Pdot2_2 + R2_12 * t4_13 + R2_22 * t4_14 + R2_32 * t4_15;
  const T Pdot4_3 = Pdot2_3 + R2_13 * t4_13 + R2_23 * t4_14 + R2_33 * t4_15;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_16 = omega4_2 * T(0.1) - omega4_3 * T(0.06);
  const T t4_17 = omega4_3 * T(0.03) + omega4_1 * T(0.1);
  const T t4_18 = T(0.06) * omega4_1;
  const T t4_19 = t4_18 + omega4_2 * T(0.03);
  const T v4_1 = Pdot4_1 + R4_11 * t4_16 - R4_21 * t4_17 + R4_31 * t4_19;
  const T v4_2 = Pdot4_2 + R4_12 * t4_16 - R4_22 * t4_17 + R4_32 * t4_19;
  const T v4_3 = Pdot4_3 + R4_13 * t4_16 - R4_23 * t4_17 + R4_33 * t4_19;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (omega4_1 * (t4_18 + T(0.004) * omega4_2 - T(0.002) * omega4_3) + omega4_2 * (T(0.004) *
      omega4_1 + T(0.075) * omega4_2 + T(0.003) * omega4_3) + omega4_3 * (T(0.003) * omega4_2 - T(0.002) * omega4_1 +
      T(0.052) * omega4_3)) + c.c4_1 * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[30], sdot5_2 = y[31], sdot5_3 = y[32];
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
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
  // P5 = s1 + R1^T d5: position of the body origin, inertial axes [m]
  const T P5_3 = s1_3 + R1_13 * d5_1 + R1_23 * d5_2 + R1_33 * d5_3;
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_3 = P5_3 + R5_13 * T(0.38) + R5_23 * T(0.02) - R5_33 * T(0.04);
  // Pdot5 = sdot1 + R1^T (omega1~ d5 + sdot5): velocity of the body origin, inertial axes [m/s]
  const T t5_13 = sdot5_1 + omega1_2 * d5_3 - omega1_3 * d5_2;
  const T t5_14 = sdot5_2 + omega1_3 * d5_1 - omega1_1 * d5_3;
  const T t5_15 = sdot5_3 + omega1_1 * d5_2 - omega1_2 * d5_1;
  const T Pdot5_1 = sdot1_1 + R1_11 * t5_13 + R1_21 * t5_14 + R1_31 * t5_15;
  const T Pdot5_2 = sdot1_2 + R1_12 * t5_13 + R1_22 * t5_14 + R1_32 * t5_15;
  const T Pdot5_3 = sdot1_3 + R1_13 * t5_13 + R1_23 * t5_14 + R1_33 * t5_15;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_16 = omega5_3 * T(0.38) + omega5_1 * T(0.04);
  const T t5_17 = omega5_3 * T(0.02) + omega5_2 * T(0.04);
  const T t5_18 = omega5_1 * T(0.02) - omega5_2 * T(0.38);
  const T v5_1 = Pdot5_1 + R5_21 * t5_16 - R5_11 * t5_17 + R5_31 * t5_18;
  const T v5_2 = Pdot5_2 + R5_22 * t5_16 - R5_12 * t5_17 + R5_32 * t5_18;
  const T v5_3 = Pdot5_3 + R5_23 * t5_16 - R5_13 * t5_17 + R5_33 * t5_18;
  // T5 = 1/2 omega5 . (I5 omega5) + 1/2 m5 v5 . v5: kinetic energy [J]
  const T T5 = T(0.5) * (omega5_1 * (T(0.08) * omega5_1 + T(0.005) * omega5_2 + T(0.012) * omega5_3) + omega5_2 *
      (T(0.005) * omega5_1 + T(0.31) * omega5_2 - T(0.007) * omega5_3) + omega5_3 * (T(0.012) * omega5_1 - T(0.007) *
      omega5_2 + T(0.33) * omega5_3)) + T(1.3) * (v5_1 * v5_1 + v5_2 * v5_2 + v5_3 * v5_3);

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[33], sdot6_2 = y[34], sdot6_3 = y[35];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
  // P6 = R5^T d6 + P5: position of the body origin, inertial axes [m]
  const T P6_3 = P5_3 + R5_13 * d6_1 + R5_23 * d6_2 + R5_33 * d6_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_3 = P6_3 + R6_13 * T(0.09) - R6_23 * T(0.05) + R6_33 * T(0.07);
  // Pdot6 = R5^T (omega5~ d6 + sdot6) + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = sdot6_1 + omega5_2 * d6_3 - omega5_3 * d6_2;
  const T t6_14 = sdot6_2 + omega5_3 * d6_1 - omega5_1 * d6_3;
  const T t6_15 = sdot6_3 + omega5_1 * d6_2 - omega5_2 * d6_1;
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_13 + R5_21 * t6_14 + R5_31 * t6_15;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_13 + R5_22 * t6_14 + R5_32 * t6_15;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_13 + R5_23 * t6_14 + R5_33 * t6_15;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_16 = omega6_3 * T(0.05) + omega6_2 * T(0.07);
  const T t6_17 = omega6_3 * T(0.09) - omega6_1 * T(0.07);
  const T t6_18 = omega6_1 * T(0.05) + omega6_2 * T(0.09);
  const T v6_1 = Pdot6_1 + R6_11 * t6_16 + R6_21 * t6_17 - R6_31 * t6_18;
  const T v6_2 = Pdot6_2 + R6_12 * t6_16 + R6_22 * t6_17 - R6_32 * t6_18;
  const T v6_3 = Pdot6_3 + R6_13 * t6_16 + R6_23 * t6_17 - R6_33 * t6_18;
  // T6 = 1/2 omega6 . (I6 omega6) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (omega6_1 * (T(0.022) * omega6_1 + T(0.0015) * omega6_2 - T(0.001) * omega6_3) + omega6_2 *
      (T(0.0015) * omega6_1 + T(0.018) * omega6_2 + T(0.002) * omega6_3) + omega6_3 * (T(0.002) * omega6_2 - T(0.001)
      * omega6_1 + T(0.027) * omega6_3)) + T(0.45) * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6: first moment of mass, inertial axes [kg m]
  const T mp_3 = T(12) * p1_3 + T(3.5) * p2_3 + T(1.8) * p3_3 + c.p.m_payload * p4_3 + T(2.6) * p5_3 + T(0.9) * p6_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 465 add, 493 multiply
template <class T>
void momentum(const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {

  // ---- body 1 (hub) on the inertial frame
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
  const T p1_1 = s1_1 + R1_11 * T(0.05) - R1_21 * T(0.02) + R1_31 * T(0.08);
  const T p1_2 = s1_2 + R1_12 * T(0.05) - R1_22 * T(0.02) + R1_32 * T(0.08);
  const T p1_3 = s1_3 + R1_13 * T(0.05) - R1_23 * T(0.02) + R1_33 * T(0.08);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_3 * T(0.02) + omega1_2 * T(0.08);
  const T t1_14 = T(0.05) * omega1_3;
  const T t1_15 = t1_14 - omega1_1 * T(0.08);
  const T t1_16 = T(0.05) * omega1_2;
  const T t1_17 = t1_16 + omega1_1 * T(0.02);
  const T v1_1 = sdot1_1 + R1_11 * t1_13 + R1_21 * t1_15 - R1_31 * t1_17;
  const T v1_2 = sdot1_2 + R1_12 * t1_13 + R1_22 * t1_15 - R1_32 * t1_17;
  const T v1_3 = sdot1_3 + R1_13 * t1_13 + R1_23 * t1_15 - R1_33 * t1_17;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(12) * v1_1;
  const T l1_2 = T(12) * v1_2;
  const T l1_3 = T(12) * v1_3;
  // H1 = R1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_18 = T(1.1) * omega1_1 + T(0.04) * omega1_2 - T(0.03) * omega1_3;
  const T t1_19 = t1_14 + T(0.04) * omega1_1 + T(0.95) * omega1_2;
  const T t1_20 = t1_16 - T(0.03) * omega1_1 + T(1.3) * omega1_3;
  const T H1_1 = R1_11 * t1_18 + R1_21 * t1_19 + R1_31 * t1_20 + p1_2 * l1_3 - p1_3 * l1_2;
  const T H1_2 = R1_12 * t1_18 + R1_22 * t1_19 + R1_32 * t1_20 + p1_3 * l1_1 - p1_1 * l1_3;
  const T H1_3 = R1_13 * t1_18 + R1_23 * t1_19 + R1_33 * t1_20 + p1_1 * l1_2 - p1_2 * l1_1;

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[21], sdot2_2 = y[22], sdot2_3 = y[23];
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
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
  // P2 = s1 + R1^T d2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * d2_1 + R1_21 * d2_2 + R1_31 * d2_3;
  const T P2_2 = s1_2 + R1_12 * d2_1 + R1_22 * d2_2 + R1_32 * d2_3;
  const T P2_3 = s1_3 + R1_13 * d2_1 + R1_23 * d2_2 + R1_33 * d2_3;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = P2_1 + R2_11 * T(0.03) + R2_21 * T(0.04) + R2_31 * T(0.45);
  const T p2_2 = P2_2 + R2_12 * T(0.03) + R2_22 * T(0.04) + R2_32 * T(0.45);
  const T p2_3 = P2_3 + R2_13 * T(0.03) + R2_23 * T(0.04) + R2_33 * T(0.45);
  // Pdot2 = sdot1 + R1^T (omega1~ d2 + sdot2): velocity of the body origin, inertial axes [m/s]
  const T t2_13 = sdot2_1 + omega1_2 * d2_3 - omega1_3 * d2_2;
  const T t2_14 = sdot2_2 + omega1_3 * d2_1 - omega1_1 * d2_3;
  const T t2_15 = sdot2_3 + omega1_1 * d2_2 - omega1_2 * d2_1;
  const T Pdot2_1 = sdot1_1 + R1_11 * t2_13 + R1_21 * t2_14 + R1_31 * t2_15;
  const T Pdot2_2 = sdot1_2 + R1_12 * t2_13 + R1_22 * t2_14 + R1_32 * t2_15;
  const T Pdot2_3 = sdot1_3 + R1_13 * t2_13 + R1_23 * t2_14 + R1_33 * t2_15;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_16 = omega2_2 * T(0.45) - omega2_3 * T(0.04);
  const T t2_17 = T(0.03) * omega2_3;
  const T t2_18 = t2_17 - omega2_1 * T(0.45);
  const T t2_19 = T(0.03) * omega2_2;
  const T t2_20 = omega2_1 * T(0.04) - t2_19;
  const T v2_1 = Pdot2_1 + R2_11 * t2_16 + R2_21 * t2_18 + R2_31 * t2_20;
  const T v2_2 = Pdot2_2 + R2_12 * t2_16 + R2_22 * t2_18 + R2_32 * t2_20;
  const T v2_3 = Pdot2_3 + R2_13 * t2_16 + R2_23 * t2_18 + R2_33 * t2_20;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(3.5) * v2_1;
  const T l2_2 = T(3.5) * v2_2;
  const T l2_3 = T(3.5) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_21 = T(0.42) * omega2_1 + T(0.02) * omega2_2 + T(0.01) * omega2_3;
  const T t2_22 = T(0.02) * omega2_1 - t2_17 + T(0.38) * omega2_2;
  const T t2_23 = T(0.01) * omega2_1 - t2_19 + T(0.11) * omega2_3;
  const T H2_1 = R2_11 * t2_21 + R2_21 * t2_22 + R2_31 * t2_23 + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = R2_12 * t2_21 + R2_22 * t2_22 + R2_32 * t2_23 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = R2_13 * t2_21 + R2_23 * t2_22 + R2_33 * t2_23 + p2_1 * l2_2 - p2_2 * l2_1;

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[24], sdot3_2 = y[25], sdot3_3 = y[26];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
  // P3 = R2^T d3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 + R2_11 * d3_1 + R2_21 * d3_2 + R2_31 * d3_3;
  const T P3_2 = P2_2 + R2_12 * d3_1 + R2_22 * d3_2 + R2_32 * d3_3;
  const T P3_3 = P2_3 + R2_13 * d3_1 + R2_23 * d3_2 + R2_33 * d3_3;
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 + R3_11 * T(0.1) + R3_21 * T(0.35) - R3_31 * T(0.02);
  const T p3_2 = P3_2 + R3_12 * T(0.1) + R3_22 * T(0.35) - R3_32 * T(0.02);
  const T p3_3 = P3_3 + R3_13 * T(0.1) + R3_23 * T(0.35) - R3_33 * T(0.02);
  // Pdot3 = R2^T (omega2~ d3 + sdot3) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_13 = sdot3_1 + omega2_2 * d3_3 - omega2_3 * d3_2;
  const T t3_14 = sdot3_2 + omega2_3 * d3_1 - omega2_1 * d3_3;
  const T t3_15 = sdot3_3 + omega2_1 * d3_2 - omega2_2 * d3_1;
  const T Pdot3_1 = Pdot2_1 + R2_11 * t3_13 + R2_21 * t3_14 + R2_31 * t3_15;
  const T Pdot3_2 = Pdot2_2 + R2_12 * t3_13 + R2_22 * t3_14 + R2_32 * t3_15;
  const T Pdot3_3 = Pdot2_3 + R2_13 * t3_13 + R2_23 * t3_14 + R2_33 * t3_15;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_16 = omega3_3 * T(0.1) + omega3_1 * T(0.02);
  const T t3_17 = omega3_3 * T(0.35) + omega3_2 * T(0.02);
  const T t3_18 = omega3_1 * T(0.35) - omega3_2 * T(0.1);
  const T v3_1 = Pdot3_1 + R3_21 * t3_16 - R3_11 * t3_17 + R3_31 * t3_18;
  const T v3_2 = Pdot3_2 + R3_22 * t3_16 - R3_12 * t3_17 + R3_32 * t3_18;
  const T v3_3 = Pdot3_3 + R3_23 * t3_16 - R3_13 * t3_17 + R3_33 * t3_18;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(1.8) * v3_1;
  const T l3_2 = T(1.8) * v3_2;
  const T l3_3 = T(1.8) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_19 = T(0.21) * omega3_1 - T(0.012) * omega3_2 + T(0.006) * omega3_3;
  const T t3_20 = T(0.09) * omega3_2 - T(0.012) * omega3_1 + T(0.008) * omega3_3;
  const T t3_21 = T(0.006) * omega3_1 + T(0.008) * omega3_2 + T(0.27) * omega3_3;
  const T H3_1 = R3_11 * t3_19 + R3_21 * t3_20 + R3_31 * t3_21 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = R3_12 * t3_19 + R3_22 * t3_20 + R3_32 * t3_21 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R3_13 * t3_19 + R3_23 * t3_20 + R3_33 * t3_21 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[27], sdot4_2 = y[28], sdot4_3 = y[29];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
  // P4 = R2^T d4 + P2: position of the body origin, inertial axes [m]
  const T P4_1 = P2_1 + R2_11 * d4_1 + R2_21 * d4_2 + R2_31 * d4_3;
  const T P4_2 = P2_2 + R2_12 * d4_1 + R2_22 * d4_2 + R2_32 * d4_3;
  const T P4_3 = P2_3 + R2_13 * d4_1 + R2_23 * d4_2 + R2_33 * d4_3;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 + R4_21 * T(0.06) - R4_11 * T(0.03) + R4_31 * T(0.1);
  const T p4_2 = P4_2 + R4_22 * T(0.06) - R4_12 * T(0.03) + R4_32 * T(0.1);
  const T p4_3 = P4_3 + R4_23 * T(0.06) - R4_13 * T(0.03) + R4_33 * T(0.1);
  // Pdot4 = R2^T (omega2~ d4 + sdot4) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = sdot4_1 + omega2_2 * d4_3 - omega2_3 * d4_2;
  const T t4_14 = sdot4_2 + omega2_3 * d4_1 - omega2_1 * d4_3;
  const T t4_15 = sdot4_3 + omega2_1 * d4_2 - omega2_2 * d4_1;
  const T Pdot4_1 = Pdot2_1 + R2_11 * t4_13 + R2_21 * t4_14 + R2_31 * t4_15;
  const T Pdot4_2 = Pdot2_2 + R2_12 * t4_13 + R2_22 * t4_14 + R2_32 * t4_15;
  const T Pdot4_3 = Pdot2_3 + R2_13 * t4_13 + R2_23 * t4_14 + R2_33 * t4_15;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_16 = omega4_2 * T(0.1) - omega4_3 * T(0.06);
  const T t4_17 = omega4_3 * T(0.03) + omega4_1 * T(0.1);
  const T t4_18 = T(0.06) * omega4_1;
  const T t4_19 = t4_18 + omega4_2 * T(0.03);
  const T v4_1 = Pdot4_1 + R4_11 * t4_16 - R4_21 * t4_17 + R4_31 * t4_19;
  const T v4_2 = Pdot4_2 + R4_12 * t4_16 - R4_22 * t4_17 + R4_32 * t4_19;
  const T v4_3 = Pdot4_3 + R4_13 * t4_16 - R4_23 * t4_17 + R4_33 * t4_19;
  // l4 = m4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = c.p.m_payload * v4_1;
  const T l4_2 = c.p.m_payload * v4_2;
  const T l4_3 = c.p.m_payload * v4_3;
  // H4 = R4^T I4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_20 = t4_18 + T(0.004) * omega4_2 - T(0.002) * omega4_3;
  const T t4_21 = T(0.004) * omega4_1 + T(0.075) * omega4_2 + T(0.003) * omega4_3;
  const T t4_22 = T(0.003) * omega4_2 - T(0.002) * omega4_1 + T(0.052) * omega4_3;
  const T H4_1 = R4_11 * t4_20 + R4_21 * t4_21 + R4_31 * t4_22 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_20 + R4_22 * t4_21 + R4_32 * t4_22 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R4_13 * t4_20 + R4_23 * t4_21 + R4_33 * t4_22 + p4_1 * l4_2 - p4_2 * l4_1;

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[30], sdot5_2 = y[31], sdot5_3 = y[32];
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
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
  // P5 = s1 + R1^T d5: position of the body origin, inertial axes [m]
  const T P5_1 = s1_1 + R1_11 * d5_1 + R1_21 * d5_2 + R1_31 * d5_3;
  const T P5_2 = s1_2 + R1_12 * d5_1 + R1_22 * d5_2 + R1_32 * d5_3;
  const T P5_3 = s1_3 + R1_13 * d5_1 + R1_23 * d5_2 + R1_33 * d5_3;
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T p5_1 = P5_1 + R5_11 * T(0.38) + R5_21 * T(0.02) - R5_31 * T(0.04);
  const T p5_2 = P5_2 + R5_12 * T(0.38) + R5_22 * T(0.02) - R5_32 * T(0.04);
  const T p5_3 = P5_3 + R5_13 * T(0.38) + R5_23 * T(0.02) - R5_33 * T(0.04);
  // Pdot5 = sdot1 + R1^T (omega1~ d5 + sdot5): velocity of the body origin, inertial axes [m/s]
  const T t5_13 = sdot5_1 + omega1_2 * d5_3 - omega1_3 * d5_2;
  const T t5_14 = sdot5_2 + omega1_3 * d5_1 - omega1_1 * d5_3;
  const T t5_15 = sdot5_3 + omega1_1 * d5_2 - omega1_2 * d5_1;
  const T Pdot5_1 = sdot1_1 + R1_11 * t5_13 + R1_21 * t5_14 + R1_31 * t5_15;
  const T Pdot5_2 = sdot1_2 + R1_12 * t5_13 + R1_22 * t5_14 + R1_32 * t5_15;
  const T Pdot5_3 = sdot1_3 + R1_13 * t5_13 + R1_23 * t5_14 + R1_33 * t5_15;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_16 = omega5_3 * T(0.38) + omega5_1 * T(0.04);
  const T t5_17 = omega5_3 * T(0.02) + omega5_2 * T(0.04);
  const T t5_18 = omega5_1 * T(0.02) - omega5_2 * T(0.38);
  const T v5_1 = Pdot5_1 + R5_21 * t5_16 - R5_11 * t5_17 + R5_31 * t5_18;
  const T v5_2 = Pdot5_2 + R5_22 * t5_16 - R5_12 * t5_17 + R5_32 * t5_18;
  const T v5_3 = Pdot5_3 + R5_23 * t5_16 - R5_13 * t5_17 + R5_33 * t5_18;
  // l5 = m5 v5: linear momentum, inertial axes [kg m/s]
  const T l5_1 = T(2.6) * v5_1;
  const T l5_2 = T(2.6) * v5_2;
  const T l5_3 = T(2.6) * v5_3;
  // H5 = R5^T I5 omega5 + p5~ l5: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t5_19 = T(0.08) * omega5_1 + T(0.005) * omega5_2 + T(0.012) * omega5_3;
  const T t5_20 = T(0.005) * omega5_1 + T(0.31) * omega5_2 - T(0.007) * omega5_3;
  const T t5_21 = T(0.012) * omega5_1 - T(0.007) * omega5_2 + T(0.33) * omega5_3;
  const T H5_1 = R5_11 * t5_19 + R5_21 * t5_20 + R5_31 * t5_21 + p5_2 * l5_3 - p5_3 * l5_2;
  const T H5_2 = R5_12 * t5_19 + R5_22 * t5_20 + R5_32 * t5_21 + p5_3 * l5_1 - p5_1 * l5_3;
  const T H5_3 = R5_13 * t5_19 + R5_23 * t5_20 + R5_33 * t5_21 + p5_1 * l5_2 - p5_2 * l5_1;

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[33], sdot6_2 = y[34], sdot6_3 = y[35];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
  // P6 = R5^T d6 + P5: position of the body origin, inertial axes [m]
  const T P6_1 = P5_1 + R5_11 * d6_1 + R5_21 * d6_2 + R5_31 * d6_3;
  const T P6_2 = P5_2 + R5_12 * d6_1 + R5_22 * d6_2 + R5_32 * d6_3;
  const T P6_3 = P5_3 + R5_13 * d6_1 + R5_23 * d6_2 + R5_33 * d6_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = P6_1 + R6_11 * T(0.09) - R6_21 * T(0.05) + R6_31 * T(0.07);
  const T p6_2 = P6_2 + R6_12 * T(0.09) - R6_22 * T(0.05) + R6_32 * T(0.07);
  const T p6_3 = P6_3 + R6_13 * T(0.09) - R6_23 * T(0.05) + R6_33 * T(0.07);
  // Pdot6 = R5^T (omega5~ d6 + sdot6) + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = sdot6_1 + omega5_2 * d6_3 - omega5_3 * d6_2;
  const T t6_14 = sdot6_2 + omega5_3 * d6_1 - omega5_1 * d6_3;
  const T t6_15 = sdot6_3 + omega5_1 * d6_2 - omega5_2 * d6_1;
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_13 + R5_21 * t6_14 + R5_31 * t6_15;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_13 + R5_22 * t6_14 + R5_32 * t6_15;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_13 + R5_23 * t6_14 + R5_33 * t6_15;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_16 = omega6_3 * T(0.05) + omega6_2 * T(0.07);
  const T t6_17 = omega6_3 * T(0.09) - omega6_1 * T(0.07);
  const T t6_18 = omega6_1 * T(0.05) + omega6_2 * T(0.09);
  const T v6_1 = Pdot6_1 + R6_11 * t6_16 + R6_21 * t6_17 - R6_31 * t6_18;
  const T v6_2 = Pdot6_2 + R6_12 * t6_16 + R6_22 * t6_17 - R6_32 * t6_18;
  const T v6_3 = Pdot6_3 + R6_13 * t6_16 + R6_23 * t6_17 - R6_33 * t6_18;
  // l6 = m6 v6: linear momentum, inertial axes [kg m/s]
  const T l6_1 = T(0.9) * v6_1;
  const T l6_2 = T(0.9) * v6_2;
  const T l6_3 = T(0.9) * v6_3;
  // H6 = R6^T I6 omega6 + p6~ l6: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t6_19 = T(0.022) * omega6_1 + T(0.0015) * omega6_2 - T(0.001) * omega6_3;
  const T t6_20 = T(0.0015) * omega6_1 + T(0.018) * omega6_2 + T(0.002) * omega6_3;
  const T t6_21 = T(0.002) * omega6_2 - T(0.001) * omega6_1 + T(0.027) * omega6_3;
  const T H6_1 = R6_11 * t6_19 + R6_21 * t6_20 + R6_31 * t6_21 + p6_2 * l6_3 - p6_3 * l6_2;
  const T H6_2 = R6_12 * t6_19 + R6_22 * t6_20 + R6_32 * t6_21 + p6_3 * l6_1 - p6_1 * l6_3;
  const T H6_3 = R6_13 * t6_19 + R6_23 * t6_20 + R6_33 * t6_21 + p6_1 * l6_2 - p6_2 * l6_1;

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
// 263 add, 272 multiply
template <class T>
void power([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* out) noexcept {

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

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[18], sdot1_2 = y[19], sdot1_3 = y[20];
  const T sdot2_1 = y[21], sdot2_2 = y[22], sdot2_3 = y[23];
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
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
  // Pdot2 = sdot1 + R1^T (omega1~ d2 + sdot2): velocity of the body origin, inertial axes [m/s]
  const T t2_13 = sdot2_1 + omega1_2 * d2_3 - omega1_3 * d2_2;
  const T t2_14 = sdot2_2 + omega1_3 * d2_1 - omega1_1 * d2_3;
  const T t2_15 = sdot2_3 + omega1_1 * d2_2 - omega1_2 * d2_1;
  const T Pdot2_1 = sdot1_1 + R1_11 * t2_13 + R1_21 * t2_14 + R1_31 * t2_15;
  const T Pdot2_2 = sdot1_2 + R1_12 * t2_13 + R1_22 * t2_14 + R1_32 * t2_15;
  const T Pdot2_3 = sdot1_3 + R1_13 * t2_13 + R1_23 * t2_14 + R1_33 * t2_15;

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot3_1 = y[24], sdot3_2 = y[25], sdot3_3 = y[26];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
  // Pdot3 = R2^T (omega2~ d3 + sdot3) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_13 = sdot3_1 + omega2_2 * d3_3 - omega2_3 * d3_2;
  const T t3_14 = sdot3_2 + omega2_3 * d3_1 - omega2_1 * d3_3;
  const T t3_15 = sdot3_3 + omega2_1 * d3_2 - omega2_2 * d3_1;
  const T Pdot3_1 = Pdot2_1 + R2_11 * t3_13 + R2_21 * t3_14 + R2_31 * t3_15;
  const T Pdot3_2 = Pdot2_2 + R2_12 * t3_13 + R2_22 * t3_14 + R2_32 * t3_15;
  const T Pdot3_3 = Pdot2_3 + R2_13 * t3_13 + R2_23 * t3_14 + R2_33 * t3_15;

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
  const T sdot4_1 = y[27], sdot4_2 = y[28], sdot4_3 = y[29];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
  // Pdot4 = R2^T (omega2~ d4 + sdot4) + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t4_13 = sdot4_1 + omega2_2 * d4_3 - omega2_3 * d4_2;
  const T t4_14 = sdot4_2 + omega2_3 * d4_1 - omega2_1 * d4_3;
  const T t4_15 = sdot4_3 + omega2_1 * d4_2 - omega2_2 * d4_1;
  const T Pdot4_1 = Pdot2_1 + R2_11 * t4_13 + R2_21 * t4_14 + R2_31 * t4_15;
  const T Pdot4_2 = Pdot2_2 + R2_12 * t4_13 + R2_22 * t4_14 + R2_32 * t4_15;
  const T Pdot4_3 = Pdot2_3 + R2_13 * t4_13 + R2_23 * t4_14 + R2_33 * t4_15;

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
  const T sdot5_1 = y[30], sdot5_2 = y[31], sdot5_3 = y[32];
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
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
  // Pdot5 = sdot1 + R1^T (omega1~ d5 + sdot5): velocity of the body origin, inertial axes [m/s]
  const T t5_13 = sdot5_1 + omega1_2 * d5_3 - omega1_3 * d5_2;
  const T t5_14 = sdot5_2 + omega1_3 * d5_1 - omega1_1 * d5_3;
  const T t5_15 = sdot5_3 + omega1_1 * d5_2 - omega1_2 * d5_1;
  const T Pdot5_1 = sdot1_1 + R1_11 * t5_13 + R1_21 * t5_14 + R1_31 * t5_15;
  const T Pdot5_2 = sdot1_2 + R1_12 * t5_13 + R1_22 * t5_14 + R1_32 * t5_15;
  const T Pdot5_3 = sdot1_3 + R1_13 * t5_13 + R1_23 * t5_14 + R1_33 * t5_15;

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot6_1 = y[33], sdot6_2 = y[34], sdot6_3 = y[35];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
  // Pdot6 = R5^T (omega5~ d6 + sdot6) + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_13 = sdot6_1 + omega5_2 * d6_3 - omega5_3 * d6_2;
  const T t6_14 = sdot6_2 + omega5_3 * d6_1 - omega5_1 * d6_3;
  const T t6_15 = sdot6_3 + omega5_1 * d6_2 - omega5_2 * d6_1;
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_13 + R5_21 * t6_14 + R5_31 * t6_15;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_13 + R5_22 * t6_14 + R5_32 * t6_15;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_13 + R5_23 * t6_14 + R5_33 * t6_15;

  // ---- whole system
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  // power = F1 . (sdot1 + R1^T omega1~ r1) + M1 . omega1 + F2 . (R2^T omega2~ r2 + Pdot2) + M2 . omega2 + F3 . (R3^T
  //   omega3~ r3 + Pdot3) + M3 . omega3 + F4 . (R4^T omega4~ r4 + Pdot4) + M4 . omega4 + F5 . (R5^T omega5~ r5 +
  //   Pdot5) + M5 . omega5 + F6 . (R6^T omega6~ r6 + Pdot6) + M6 . omega6: power of the applied loads [W]
  const T b0_1 = omega1_3 * T(0.02) + omega1_2 * T(0.08);
  const T b0_2 = T(0.05) * omega1_3 - omega1_1 * T(0.08);
  const T b0_3 = T(0.05) * omega1_2 + omega1_1 * T(0.02);
  const T b0_4 = omega5_1 * T(0.02);
  const T b0_5 = omega2_2 * T(0.45) - omega2_3 * T(0.04);
  const T b0_6 = T(0.03) * omega2_3 - omega2_1 * T(0.45);
  const T b0_7 = omega2_1 * T(0.04) - T(0.03) * omega2_2;
  const T b0_8 = omega3_3 * T(0.1) + omega3_1 * T(0.02);
  const T b0_9 = omega3_3 * T(0.35) + omega3_2 * T(0.02);
  const T b0_10 = omega3_1 * T(0.35) - omega3_2 * T(0.1);
  const T b0_11 = omega4_2 * T(0.1) - omega4_3 * T(0.06);
  const T b0_12 = omega4_3 * T(0.03) + omega4_1 * T(0.1);
  const T b0_13 = T(0.06) * omega4_1 + omega4_2 * T(0.03);
  const T b0_14 = omega5_3 * T(0.38) + omega5_1 * T(0.04);
  const T b0_15 = omega5_3 * T(0.02) + omega5_2 * T(0.04);
  const T b0_16 = b0_4 - omega5_2 * T(0.38);
  const T b0_17 = omega6_3 * T(0.05) + omega6_2 * T(0.07);
  const T b0_18 = omega6_3 * T(0.09) - omega6_1 * T(0.07);
  const T b0_19 = omega6_1 * T(0.05) + omega6_2 * T(0.09);
  const T power = T(0.5) * (sdot1_1 + R1_11 * b0_1 + R1_21 * b0_2 - R1_31 * b0_3) - b0_4 - T(0.3) * (sdot1_2 + R1_12 *
      b0_1 + R1_22 * b0_2 - R1_32 * b0_3) + u.thrust * (sdot1_3 + R1_13 * b0_1 + R1_23 * b0_2 - R1_33 * b0_3) +
      T(0.05) * omega1_1 - T(0.02) * omega1_2 + T(0.03) * omega1_3 + T(0.2) * (Pdot2_1 + R2_11 * b0_5 + R2_21 * b0_6 +
      R2_31 * b0_7) + T(0.1) * (Pdot2_2 + R2_12 * b0_5 + R2_22 * b0_6 + R2_32 * b0_7) - T(0.4) * (Pdot2_3 + R2_13 *
      b0_5 + R2_23 * b0_6 + R2_33 * b0_7) + T(0.01) * omega2_1 + T(0.02) * omega2_2 - T(0.015) * omega2_3 + T(0.05) *
      (Pdot3_2 + R3_22 * b0_8 - R3_12 * b0_9 + R3_32 * b0_10) - T(0.1) * (Pdot3_1 + R3_21 * b0_8 - R3_11 * b0_9 +
      R3_31 * b0_10) + T(0.15) * (Pdot3_3 + R3_23 * b0_8 - R3_13 * b0_9 + R3_33 * b0_10) + T(0.004) * omega3_2 -
      T(0.008) * omega3_1 + T(0.012) * omega3_3 + T(0.1) * (Pdot4_1 + R4_11 * b0_11 - R4_21 * b0_12 + R4_31 * b0_13) -
      T(0.15) * (Pdot4_2 + R4_12 * b0_11 - R4_22 * b0_12 + R4_32 * b0_13) + T(0.05) * (Pdot4_3 + R4_13 * b0_11 - R4_23
      * b0_12 + R4_33 * b0_13) + T(0.003) * omega4_1 + T(0.002) * omega4_2 - T(0.004) * omega4_3 + T(0.12) * (Pdot5_1
      + R5_21 * b0_14 - R5_11 * b0_15 + R5_31 * b0_16) - T(0.07) * (Pdot5_2 + R5_22 * b0_14 - R5_12 * b0_15 + R5_32 *
      b0_16) + T(0.09) * (Pdot5_3 + R5_23 * b0_14 - R5_13 * b0_15 + R5_33 * b0_16) + T(0.01) * omega5_2 + T(0.005) *
      omega5_3 + T(0.05) * (Pdot6_1 + R6_11 * b0_17 + R6_21 * b0_18 - R6_31 * b0_19) + T(0.08) * (Pdot6_2 + R6_12 *
      b0_17 + R6_22 * b0_18 - R6_32 * b0_19) - T(0.06) * (Pdot6_3 + R6_13 * b0_17 + R6_23 * b0_18 - R6_33 * b0_19) +
      T(0.002) * omega6_1 - T(0.001) * omega6_2 + T(0.0015) * omega6_3;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 472 add, 472 multiply
template <class T>
void accelerations(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot) noexcept {

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
  // N1 = -omega1~ I1 omega1 + M1: applied less gyroscopic moment, body axes [N m]
  const T t1_13 = omega1_2 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T t1_15 = omega1_3 * omega1_3;
  const T t1_16 = omega1_1 * omega1_2;
  const T t1_17 = omega1_1 * omega1_3;
  const T N1_1 = T(0.05) - T(0.3500000000000001) * t1_13 - T(0.05) * (t1_14 - t1_15) + T(0.03) * t1_16 + T(0.04) *
      t1_17;
  const T t1_18 = omega1_1 * omega1_1;
  const T minus_N1_2 = T(0.02) - T(0.19999999999999996) * t1_17 - T(0.03) * (t1_15 - t1_18) + T(0.04) * t1_13 -
      T(0.05) * t1_16;
  const T N1_3 = T(0.03) + T(0.15000000000000013) * t1_16 - T(0.04) * (t1_18 - t1_14) - T(0.05) * t1_17 - T(0.03) *
      t1_13;
  // omegadot1 = Iinv1 N1: I omegadot + omega~ I omega = M
  const T omegadot1_1 = T(0.9111440494716103) * N1_1 + T(0.03955067476408207) * minus_N1_2 + T(0.022547580940271084) *
      N1_3;
  const T minus_omegadot1_2 = T(0.03955067476408207) * N1_1 + T(1.0564835384177513) * minus_N1_2 +
      T(0.041546690126007715) * N1_3;
  const T omegadot1_3 = T(0.022547580940271084) * N1_1 + T(0.041546690126007715) * minus_N1_2 + T(0.7713490476419296)
      * N1_3;
  ydot[0] = omegadot1_1;
  ydot[1] = -minus_omegadot1_2;
  ydot[2] = omegadot1_3;
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U1_11 = t1_15 + t1_14;
  const T U1_12 = t1_16 - omegadot1_3;
  const T U1_13 = t1_17 - minus_omegadot1_2;
  const T U1_21 = t1_16 + omegadot1_3;
  const T minus_U1_22 = t1_15 + t1_18;
  const T U1_23 = t1_13 - omegadot1_1;
  const T U1_31 = t1_17 + minus_omegadot1_2;
  const T U1_32 = t1_13 + omegadot1_1;
  const T minus_U1_33 = t1_14 + t1_18;
  // a1 = m1^-1 F1: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T a1_3 = T(0.08333333333333333) * u.thrust;
  // Pddot1 = -R1^T U1 r1 + a1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t1_19 = U1_13 * T(0.08) - (minus_U1_11 * T(0.05) + U1_12 * T(0.02));
  const T t1_20 = U1_21 * T(0.05) + minus_U1_22 * T(0.02) + U1_23 * T(0.08);
  const T t1_21 = U1_31 * T(0.05) - U1_32 * T(0.02) - minus_U1_33 * T(0.08);
  const T Pddot1_1 = T(0.041666666666666664) - R1_11 * t1_19 - R1_21 * t1_20 - R1_31 * t1_21;
  const T minus_Pddot1_2 = T(0.024999999999999998) + R1_12 * t1_19 + R1_22 * t1_20 + R1_32 * t1_21;
  const T Pddot1_3 = a1_3 - (R1_13 * t1_19 + R1_23 * t1_20 + R1_33 * t1_21);
  ydot[18] = Pddot1_1;
  ydot[19] = -minus_Pddot1_2;
  // sddot1 = g + Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_3 = Pddot1_3 - T(9.81);
  ydot[20] = sddot1_3;

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[21], sdot2_2 = y[22], sdot2_3 = y[23];
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
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
  // N2 = -omega2~ I2 omega2 + M2: applied less gyroscopic moment, body axes [N m]
  const T t2_13 = omega2_2 * omega2_3;
  const T t2_14 = omega2_2 * omega2_2;
  const T t2_15 = omega2_3 * omega2_3;
  const T t2_16 = omega2_1 * omega2_2;
  const T t2_17 = omega2_1 * omega2_3;
  const T N2_1 = T(0.01) + T(0.27) * t2_13 + T(0.03) * (t2_14 - t2_15) - T(0.01) * t2_16 + T(0.02) * t2_17;
  const T t2_18 = omega2_1 * omega2_1;
  const T N2_2 = T(0.02) - T(0.31) * t2_17 - T(0.01) * (t2_15 - t2_18) - T(0.02) * t2_13 - T(0.03) * t2_16;
  const T minus_N2_3 = T(0.015) + T(0.02) * (t2_18 - t2_14) - T(0.03999999999999998) * t2_16 - T(0.03) * t2_17 -
      T(0.01) * t2_13;
  // omegadot2 = Iinv2 N2: I omegadot + omega~ I omega = M
  const T omegadot2_1 = T(2.394052915008195) * N2_1 - T(0.14633575275111216) * N2_2 + T(0.2575509248419574) *
      minus_N2_3;
  const T omegadot2_2 = T(2.698431280730508) * N2_2 - T(0.14633575275111216) * N2_1 - T(0.7492390540856941) *
      minus_N2_3;
  const T omegadot2_3 = T(0.7492390540856941) * N2_2 - T(0.2575509248419574) * N2_1 - T(9.318660735190821) *
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
  const T t2_19 = U2_12 * T(0.04) - minus_U2_11 * T(0.03) + U2_13 * T(0.45);
  const T t2_20 = U2_21 * T(0.03) - minus_U2_22 * T(0.04) + U2_23 * T(0.45);
  const T t2_21 = U2_31 * T(0.03) + U2_32 * T(0.04) - minus_U2_33 * T(0.45);
  const T Pddot2_1 = T(0.05714285714285715) - R2_11 * t2_19 - R2_21 * t2_20 - R2_31 * t2_21;
  const T Pddot2_2 = T(0.028571428571428574) - R2_12 * t2_19 - R2_22 * t2_20 - R2_32 * t2_21;
  const T minus_Pddot2_3 = T(0.1142857142857143) + R2_13 * t2_19 + R2_23 * t2_20 + R2_33 * t2_21;
  // sddot2 = R1 (-Pddot1 + Pddot2) - 2 omega1~ sdot2 - U1 d2: relative acceleration, axes of the lower body [m/s^2]
  const T t2_22 = Pddot2_1 - Pddot1_1;
  const T t2_23 = Pddot2_2 + minus_Pddot1_2;
  const T t2_24 = minus_Pddot2_3 + Pddot1_3;
  const T t2_25 = T(2) * omega1_3;
  const T t2_26 = T(2) * omega1_2;
  const T sddot2_1 = R1_11 * t2_22 + R1_12 * t2_23 - R1_13 * t2_24 + t2_25 * sdot2_2 - t2_26 * sdot2_3 - U1_12 * d2_2
      + minus_U1_11 * d2_1 - U1_13 * d2_3;
  const T t2_27 = T(2) * omega1_1;
  const T sddot2_2 = R1_21 * t2_22 + R1_22 * t2_23 - R1_23 * t2_24 + t2_27 * sdot2_3 - t2_25 * sdot2_1 - U1_21 * d2_1
      + minus_U1_22 * d2_2 - U1_23 * d2_3;
  const T sddot2_3 = R1_31 * t2_22 + R1_32 * t2_23 - R1_33 * t2_24 + t2_26 * sdot2_1 - t2_27 * sdot2_2 - U1_31 * d2_1
      - U1_32 * d2_2 + minus_U1_33 * d2_3;
  ydot[21] = sddot2_1;
  ydot[22] = sddot2_2;
  ydot[23] = sddot2_3;

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[24], sdot3_2 = y[25], sdot3_3 = y[26];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
  // N3 = -omega3~ I3 omega3 + M3: applied less gyroscopic moment, body axes [N m]
  const T t3_13 = omega3_2 * omega3_3;
  const T t3_14 = omega3_2 * omega3_2;
  const T t3_15 = omega3_3 * omega3_3;
  const T t3_16 = omega3_1 * omega3_2;
  const T t3_17 = omega3_1 * omega3_3;
  const T minus_N3_1 = T(0.008) + T(0.18000000000000002) * t3_13 + T(0.008) * (t3_14 - t3_15) + T(0.006) * t3_16 +
      T(0.012) * t3_17;
  const T t3_18 = omega3_1 * omega3_1;
  const T N3_2 = T(0.004) + T(0.060000000000000026) * t3_17 - T(0.006) * (t3_15 - t3_18) + T(0.012) * t3_13 + T(0.008)
      * t3_16;
  const T N3_3 = T(0.012) + T(0.12) * t3_16 + T(0.012) * (t3_18 - t3_14) - T(0.008) * t3_17 + T(0.006) * t3_13;
  // omegadot3 = Iinv3 N3: I omegadot + omega~ I omega = M
  const T omegadot3_1 = T(0.6515680436788388) * N3_2 - T(4.802738171107158) * minus_N3_1 - T(0.12603323472619873) *
      N3_3;
  const T omegadot3_2 = T(11.228847818436046) * N3_2 - T(0.6515680436788388) * minus_N3_1 - T(0.34718589188726445) *
      N3_3;
  const T omegadot3_3 = T(0.12603323472619873) * minus_N3_1 - T(0.34718589188726445) * N3_2 + T(3.716791431642427) *
      N3_3;
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
  const T t3_19 = U3_12 * T(0.35) - minus_U3_11 * T(0.1) - U3_13 * T(0.02);
  const T t3_20 = U3_21 * T(0.1) - minus_U3_22 * T(0.35) - U3_23 * T(0.02);
  const T t3_21 = U3_31 * T(0.1) + U3_32 * T(0.35) + minus_U3_33 * T(0.02);
  const T minus_Pddot3_1 = T(0.05555555555555556) + R3_11 * t3_19 + R3_21 * t3_20 + R3_31 * t3_21;
  const T Pddot3_2 = T(0.02777777777777778) - R3_12 * t3_19 - R3_22 * t3_20 - R3_32 * t3_21;
  const T Pddot3_3 = T(0.08333333333333333) - R3_13 * t3_19 - R3_23 * t3_20 - R3_33 * t3_21;
  // sddot3 = R2 (-Pddot2 + Pddot3) - 2 omega2~ sdot3 - U2 d3: relative acceleration, axes of the lower body [m/s^2]
  const T t3_22 = Pddot3_2 - Pddot2_2;
  const T t3_23 = minus_Pddot3_1 + Pddot2_1;
  const T t3_24 = Pddot3_3 + minus_Pddot2_3;
  const T t3_25 = T(2) * omega2_3;
  const T t3_26 = T(2) * omega2_2;
  const T sddot3_1 = R2_12 * t3_22 - R2_11 * t3_23 + R2_13 * t3_24 + t3_25 * sdot3_2 - t3_26 * sdot3_3 - U2_12 * d3_2
      + minus_U2_11 * d3_1 - U2_13 * d3_3;
  const T t3_27 = T(2) * omega2_1;
  const T sddot3_2 = R2_22 * t3_22 - R2_21 * t3_23 + R2_23 * t3_24 + t3_27 * sdot3_3 - t3_25 * sdot3_1 - U2_21 * d3_1
      + minus_U2_22 * d3_2 - U2_23 * d3_3;
  const T sddot3_3 = R2_32 * t3_22 - R2_31 * t3_23 + R2_33 * t3_24 + t3_26 * sdot3_1 - t3_27 * sdot3_2 - U2_31 * d3_1
      - U2_32 * d3_2 + minus_U2_33 * d3_3;
  ydot[24] = sddot3_1;
  ydot[25] = sddot3_2;
  ydot[26] = sddot3_3;

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[27], sdot4_2 = y[28], sdot4_3 = y[29];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
  // N4 = -omega4~ I4 omega4 + M4: applied less gyroscopic moment, body axes [N m]
  const T t4_13 = omega4_2 * omega4_3;
  const T t4_14 = omega4_2 * omega4_2;
  const T t4_15 = omega4_3 * omega4_3;
  const T t4_16 = omega4_1 * omega4_2;
  const T t4_17 = omega4_1 * omega4_3;
  const T N4_1 = T(0.003) + T(0.023) * t4_13 - T(0.003) * (t4_14 - t4_15) + T(0.002) * t4_16 + T(0.004) * t4_17;
  const T t4_18 = omega4_1 * omega4_1;
  const T N4_2 = T(0.002) + T(0.002) * (t4_15 - t4_18) - T(0.008) * t4_17 - T(0.004) * t4_13 + T(0.003) * t4_16;
  const T minus_N4_3 = T(0.004) + T(0.015) * t4_16 + T(0.004) * (t4_18 - t4_14) + T(0.003) * t4_17 + T(0.002) * t4_13;
  // omegadot4 = Iinv4 N4: I omegadot + omega~ I omega = M
  const T omegadot4_1 = T(16.751334596177028) * N4_1 - T(0.9213018770449458) * N4_2 - T(0.6974341312209403) *
      minus_N4_3;
  const T omegadot4_2 = T(13.414844153607715) * N4_2 - T(0.9213018770449458) * N4_1 + T(0.8093680041329431) *
      minus_N4_3;
  const T omegadot4_3 = T(0.6974341312209403) * N4_1 - T(0.8093680041329431) * N4_2 - T(19.30428792836232) *
      minus_N4_3;
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
  const T t4_19 = minus_U4_11 * T(0.03) + U4_12 * T(0.06) + U4_13 * T(0.1);
  const T t4_20 = U4_23 * T(0.1) - (U4_21 * T(0.03) + minus_U4_22 * T(0.06));
  const T t4_21 = U4_32 * T(0.06) - U4_31 * T(0.03) - minus_U4_33 * T(0.1);
  const T Pddot4_1 = c.a4_1 - R4_11 * t4_19 - R4_21 * t4_20 - R4_31 * t4_21;
  const T minus_Pddot4_2 = c.c4_2 + R4_12 * t4_19 + R4_22 * t4_20 + R4_32 * t4_21;
  const T Pddot4_3 = c.a4_3 - R4_13 * t4_19 - R4_23 * t4_20 - R4_33 * t4_21;
  // sddot4 = R2 (-Pddot2 + Pddot4) - 2 omega2~ sdot4 - U2 d4: relative acceleration, axes of the lower body [m/s^2]
  const T t4_22 = Pddot4_1 - Pddot2_1;
  const T t4_23 = minus_Pddot4_2 + Pddot2_2;
  const T t4_24 = Pddot4_3 + minus_Pddot2_3;
  const T sddot4_1 = R2_11 * t4_22 - R2_12 * t4_23 + R2_13 * t4_24 + t3_25 * sdot4_2 - t3_26 * sdot4_3 - U2_12 * d4_2
      + minus_U2_11 * d4_1 - U2_13 * d4_3;
  const T sddot4_2 = R2_21 * t4_22 - R2_22 * t4_23 + R2_23 * t4_24 + t3_27 * sdot4_3 - t3_25 * sdot4_1 - U2_21 * d4_1
      + minus_U2_22 * d4_2 - U2_23 * d4_3;
  const T sddot4_3 = R2_31 * t4_22 - R2_32 * t4_23 + R2_33 * t4_24 + t3_26 * sdot4_1 - t3_27 * sdot4_2 - U2_31 * d4_1
      - U2_32 * d4_2 + minus_U2_33 * d4_3;
  ydot[27] = sddot4_1;
  ydot[28] = sddot4_2;
  ydot[29] = sddot4_3;

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[30], sdot5_2 = y[31], sdot5_3 = y[32];
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
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
  // N5 = -omega5~ I5 omega5 + M5: applied less gyroscopic moment, body axes [N m]
  const T t5_13 = omega5_2 * omega5_3;
  const T t5_14 = omega5_2 * omega5_2;
  const T t5_15 = omega5_3 * omega5_3;
  const T t5_16 = omega5_1 * omega5_2;
  const T t5_17 = omega5_1 * omega5_3;
  const T minus_N5_1 = T(0.02) + T(0.020000000000000018) * t5_13 - T(0.007) * (t5_14 - t5_15) + T(0.012) * t5_16 -
      T(0.005) * t5_17;
  const T t5_18 = omega5_1 * omega5_1;
  const T N5_2 = T(0.01) + T(0.25) * t5_17 - T(0.012) * (t5_15 - t5_18) - T(0.005) * t5_13 - T(0.007) * t5_16;
  const T N5_3 = T(0.005) - T(0.22999999999999998) * t5_16 - T(0.005) * (t5_18 - t5_14) + T(0.007) * t5_17 + T(0.012)
      * t5_13;
  // omegadot5 = Iinv5 N5: I omegadot + omega~ I omega = M
  const T minus_omegadot5_1 = T(12.58264780621066) * minus_N5_1 + T(0.21337993071920358) * N5_2 +
      T(0.46207707027140105) * N5_3;
  const T omegadot5_2 = T(0.21337993071920358) * minus_N5_1 + T(3.230970854073477) * N5_2 + T(0.07629501559740844) *
      N5_3;
  const T omegadot5_3 = T(0.46207707027140105) * minus_N5_1 + T(0.07629501559740844) * N5_2 + T(3.0487242119770865) *
      N5_3;
  ydot[12] = -minus_omegadot5_1;
  ydot[13] = omegadot5_2;
  ydot[14] = omegadot5_3;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U5_11 = t5_15 + t5_14;
  const T U5_12 = t5_16 - omegadot5_3;
  const T U5_13 = t5_17 + omegadot5_2;
  const T U5_21 = t5_16 + omegadot5_3;
  const T minus_U5_22 = t5_15 + t5_18;
  const T U5_23 = t5_13 + minus_omegadot5_1;
  const T U5_31 = t5_17 - omegadot5_2;
  const T U5_32 = t5_13 - minus_omegadot5_1;
  const T minus_U5_33 = t5_14 + t5_18;
  // Pddot5 = -R5^T U5 r5 + a5: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t5_19 = U5_12 * T(0.02) - minus_U5_11 * T(0.38) - U5_13 * T(0.04);
  const T t5_20 = U5_21 * T(0.38) - minus_U5_22 * T(0.02) - U5_23 * T(0.04);
  const T t5_21 = U5_31 * T(0.38) + U5_32 * T(0.02) + minus_U5_33 * T(0.04);
  const T Pddot5_1 = T(0.04615384615384615) - R5_11 * t5_19 - R5_21 * t5_20 - R5_31 * t5_21;
  const T minus_Pddot5_2 = T(0.026923076923076925) + R5_12 * t5_19 + R5_22 * t5_20 + R5_32 * t5_21;
  const T Pddot5_3 = T(0.03461538461538461) - R5_13 * t5_19 - R5_23 * t5_20 - R5_33 * t5_21;
  // sddot5 = R1 (-Pddot1 + Pddot5) - 2 omega1~ sdot5 - U1 d5: relative acceleration, axes of the lower body [m/s^2]
  const T t5_22 = Pddot5_1 - Pddot1_1;
  const T t5_23 = minus_Pddot1_2 - minus_Pddot5_2;
  const T t5_24 = Pddot5_3 - Pddot1_3;
  const T sddot5_1 = R1_11 * t5_22 + R1_12 * t5_23 + R1_13 * t5_24 + t2_25 * sdot5_2 - t2_26 * sdot5_3 - U1_12 * d5_2
      + minus_U1_11 * d5_1 - U1_13 * d5_3;
  const T sddot5_2 = R1_21 * t5_22 + R1_22 * t5_23 + R1_23 * t5_24 + t2_27 * sdot5_3 - t2_25 * sdot5_1 - U1_21 * d5_1
      + minus_U1_22 * d5_2 - U1_23 * d5_3;
  const T sddot5_3 = R1_31 * t5_22 + R1_32 * t5_23 + R1_33 * t5_24 + t2_26 * sdot5_1 - t2_27 * sdot5_2 - U1_31 * d5_1
      - U1_32 * d5_2 + minus_U1_33 * d5_3;
  ydot[30] = sddot5_1;
  ydot[31] = sddot5_2;
  ydot[32] = sddot5_3;

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[33], sdot6_2 = y[34], sdot6_3 = y[35];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
  // N6 = -omega6~ I6 omega6 + M6: applied less gyroscopic moment, body axes [N m]
  const T t6_13 = omega6_2 * omega6_3;
  const T t6_14 = omega6_2 * omega6_2;
  const T t6_15 = omega6_3 * omega6_3;
  const T t6_16 = omega6_1 * omega6_2;
  const T t6_17 = omega6_1 * omega6_3;
  const T N6_1 = T(0.002) - T(0.009000000000000001) * t6_13 - T(0.002) * (t6_14 - t6_15) + T(0.001) * t6_16 +
      T(0.0015) * t6_17;
  const T t6_18 = omega6_1 * omega6_1;
  const T minus_N6_2 = T(0.001) - T(0.005000000000000001) * t6_17 - T(0.001) * (t6_15 - t6_18) + T(0.0015) * t6_13 -
      T(0.002) * t6_16;
  const T N6_3 = T(0.0015) + T(0.004) * t6_16 - T(0.0015) * (t6_18 - t6_14) - T(0.002) * t6_17 - T(0.001) * t6_13;
  // omegadot6 = Iinv6 N6: I omegadot + omega~ I omega = M
  const T omegadot6_1 = T(45.82075718325927) * N6_1 + T(4.040211992299832) * minus_N6_2 + T(1.9963400432540346) *
      N6_3;
  const T minus_omegadot6_2 = T(4.040211992299832) * N6_1 + T(56.37284026903059) * minus_N6_2 + T(4.325403427050408) *
      N6_3;
  const T omegadot6_3 = T(1.9963400432540346) * N6_1 + T(4.325403427050408) * minus_N6_2 + T(37.43137581101314) *
      N6_3;
  ydot[15] = omegadot6_1;
  ydot[16] = -minus_omegadot6_2;
  ydot[17] = omegadot6_3;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U6_11 = t6_15 + t6_14;
  const T U6_12 = t6_16 - omegadot6_3;
  const T U6_13 = t6_17 - minus_omegadot6_2;
  const T U6_21 = t6_16 + omegadot6_3;
  const T minus_U6_22 = t6_15 + t6_18;
  const T U6_23 = t6_13 - omegadot6_1;
  const T U6_31 = t6_17 + minus_omegadot6_2;
  const T U6_32 = t6_13 + omegadot6_1;
  const T minus_U6_33 = t6_14 + t6_18;
  // Pddot6 = -R6^T U6 r6 + a6: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t6_19 = U6_13 * T(0.07) - (minus_U6_11 * T(0.09) + U6_12 * T(0.05));
  const T t6_20 = U6_21 * T(0.09) + minus_U6_22 * T(0.05) + U6_23 * T(0.07);
  const T t6_21 = U6_31 * T(0.09) - U6_32 * T(0.05) - minus_U6_33 * T(0.07);
  const T Pddot6_1 = T(0.05555555555555556) - R6_11 * t6_19 - R6_21 * t6_20 - R6_31 * t6_21;
  const T Pddot6_2 = T(0.08888888888888889) - R6_12 * t6_19 - R6_22 * t6_20 - R6_32 * t6_21;
  const T minus_Pddot6_3 = T(0.06666666666666667) + R6_13 * t6_19 + R6_23 * t6_20 + R6_33 * t6_21;
  // sddot6 = R5 (-Pddot5 + Pddot6) - 2 omega5~ sdot6 - U5 d6: relative acceleration, axes of the lower body [m/s^2]
  const T t6_22 = Pddot6_1 - Pddot5_1;
  const T t6_23 = Pddot6_2 + minus_Pddot5_2;
  const T t6_24 = minus_Pddot6_3 + Pddot5_3;
  const T t6_25 = T(2) * omega5_3;
  const T t6_26 = T(2) * omega5_2;
  const T sddot6_1 = R5_11 * t6_22 + R5_12 * t6_23 - R5_13 * t6_24 + t6_25 * sdot6_2 - t6_26 * sdot6_3 - U5_12 * d6_2
      + minus_U5_11 * d6_1 - U5_13 * d6_3;
  const T t6_27 = T(2) * omega5_1;
  const T sddot6_2 = R5_21 * t6_22 + R5_22 * t6_23 - R5_23 * t6_24 + t6_27 * sdot6_3 - t6_25 * sdot6_1 - U5_21 * d6_1
      + minus_U5_22 * d6_2 - U5_23 * d6_3;
  const T sddot6_3 = R5_31 * t6_22 + R5_32 * t6_23 - R5_33 * t6_24 + t6_26 * sdot6_1 - t6_27 * sdot6_2 - U5_31 * d6_1
      - U5_32 * d6_2 + minus_U5_33 * d6_3;
  ydot[33] = sddot6_1;
  ydot[34] = sddot6_2;
  ydot[35] = sddot6_3;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 619 add, 618 multiply
template <class T>
void residual(const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r) noexcept {

  // ---- body 1 (hub) on the inertial frame
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
  const T t1_19 = U1_13 * T(0.08) - (minus_U1_11 * T(0.05) + U1_12 * T(0.02));
  const T t1_20 = U1_21 * T(0.05) + minus_U1_22 * T(0.02) + U1_23 * T(0.08);
  const T t1_21 = U1_31 * T(0.05) - U1_32 * T(0.02) - minus_U1_33 * T(0.08);
  const T a1_1 = sddot1_1 + R1_11 * t1_19 + R1_21 * t1_20 + R1_31 * t1_21;
  const T a1_2 = sddot1_2 + R1_12 * t1_19 + R1_22 * t1_20 + R1_32 * t1_21;
  const T a1_3 = Pddot1_3 + R1_13 * t1_19 + R1_23 * t1_20 + R1_33 * t1_21;
  // G1 = m1 a1 - F1: inertia less applied force, inertial axes [N]
  const T G1_1 = T(12) * a1_1 - T(0.5);
  const T G1_2 = T(0.3) + T(12) * a1_2;
  const T G1_3 = T(12) * a1_3 - u.thrust;
  // N1 = axial(U1 (tr(I1)/2 - I1)) - M1: inertia less applied moment about the mass centre, body axes [N m]
  const T N1_1 = T(0.7250000000000001) * U1_32 - T(0.05) - T(0.375) * U1_23 - T(0.05) * (minus_U1_22 - minus_U1_33) -
      T(0.04) * U1_31 - T(0.03) * U1_21;
  const T N1_2 = T(0.02) + T(0.375) * U1_13 - T(0.575) * U1_31 + T(0.03) * (minus_U1_33 - minus_U1_11) - T(0.05) *
      U1_12 + T(0.04) * U1_32;
  const T N1_3 = T(0.575) * U1_21 - T(0.03) - T(0.7250000000000001) * U1_12 - T(0.04) * (minus_U1_11 - minus_U1_22) +
      T(0.03) * U1_23 + T(0.05) * U1_13;

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[21], sdot2_2 = y[22], sdot2_3 = y[23];
  const T omegadot2_1 = ydot[3], omegadot2_2 = ydot[4], omegadot2_3 = ydot[5];
  const T sddot2_1 = ydot[21], sddot2_2 = ydot[22], sddot2_3 = ydot[23];
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
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
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
  const T t2_19 = T(2) * omega1_2;
  const T t2_20 = T(2) * omega1_3;
  const T t2_21 = sddot2_1 + t2_19 * sdot2_3 - t2_20 * sdot2_2 + U1_12 * d2_2 - minus_U1_11 * d2_1 + U1_13 * d2_3;
  const T t2_22 = T(2) * omega1_1;
  const T t2_23 = sddot2_2 + t2_20 * sdot2_1 - t2_22 * sdot2_3 + U1_21 * d2_1 - minus_U1_22 * d2_2 + U1_23 * d2_3;
  const T t2_24 = sddot2_3 + t2_22 * sdot2_2 - t2_19 * sdot2_1 + U1_31 * d2_1 + U1_32 * d2_2 - minus_U1_33 * d2_3;
  const T Pddot2_1 = sddot1_1 + R1_11 * t2_21 + R1_21 * t2_23 + R1_31 * t2_24;
  const T Pddot2_2 = sddot1_2 + R1_12 * t2_21 + R1_22 * t2_23 + R1_32 * t2_24;
  const T Pddot2_3 = Pddot1_3 + R1_13 * t2_21 + R1_23 * t2_23 + R1_33 * t2_24;
  // a2 = R2^T U2 r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_25 = U2_12 * T(0.04) - minus_U2_11 * T(0.03) + U2_13 * T(0.45);
  const T t2_26 = U2_21 * T(0.03) - minus_U2_22 * T(0.04) + U2_23 * T(0.45);
  const T t2_27 = U2_31 * T(0.03) + U2_32 * T(0.04) - minus_U2_33 * T(0.45);
  const T a2_1 = Pddot2_1 + R2_11 * t2_25 + R2_21 * t2_26 + R2_31 * t2_27;
  const T a2_2 = Pddot2_2 + R2_12 * t2_25 + R2_22 * t2_26 + R2_32 * t2_27;
  const T a2_3 = Pddot2_3 + R2_13 * t2_25 + R2_23 * t2_26 + R2_33 * t2_27;
  // G2 = m2 a2 - F2: inertia less applied force, inertial axes [N]
  const T G2_1 = T(3.5) * a2_1 - T(0.2);
  const T G2_2 = T(3.5) * a2_2 - T(0.1);
  const T G2_3 = T(0.4) + T(3.5) * a2_3;
  // N2 = axial(U2 (tr(I2)/2 - I2)) - M2: inertia less applied moment about the mass centre, body axes [N m]
  const T N2_1 = T(0.07499999999999998) * U2_32 - T(0.01) - T(0.345) * U2_23 + T(0.03) * (minus_U2_22 - minus_U2_33) -
      T(0.02) * U2_31 + T(0.01) * U2_21;
  const T N2_2 = T(0.345) * U2_13 - T(0.02) - T(0.03500000000000001) * U2_31 - T(0.01) * (minus_U2_33 - minus_U2_11) +
      T(0.03) * U2_12 + T(0.02) * U2_32;
  const T N2_3 = T(0.015) + T(0.03500000000000001) * U2_21 - T(0.07499999999999998) * U2_12 - T(0.02) * (minus_U2_11 -
      minus_U2_22) - T(0.01) * U2_23 - T(0.03) * U2_13;

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[24], sdot3_2 = y[25], sdot3_3 = y[26];
  const T omegadot3_1 = ydot[6], omegadot3_2 = ydot[7], omegadot3_3 = ydot[8];
  const T sddot3_1 = ydot[24], sddot3_2 = ydot[25], sddot3_3 = ydot[26];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
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
  const T t3_19 = T(2) * omega2_2;
  const T t3_20 = T(2) * omega2_3;
  const T t3_21 = sddot3_1 + t3_19 * sdot3_3 - t3_20 * sdot3_2 + U2_12 * d3_2 - minus_U2_11 * d3_1 + U2_13 * d3_3;
  const T t3_22 = T(2) * omega2_1;
  const T t3_23 = sddot3_2 + t3_20 * sdot3_1 - t3_22 * sdot3_3 + U2_21 * d3_1 - minus_U2_22 * d3_2 + U2_23 * d3_3;
  const T t3_24 = sddot3_3 + t3_22 * sdot3_2 - t3_19 * sdot3_1 + U2_31 * d3_1 + U2_32 * d3_2 - minus_U2_33 * d3_3;
  const T Pddot3_1 = Pddot2_1 + R2_11 * t3_21 + R2_21 * t3_23 + R2_31 * t3_24;
  const T Pddot3_2 = Pddot2_2 + R2_12 * t3_21 + R2_22 * t3_23 + R2_32 * t3_24;
  const T Pddot3_3 = Pddot2_3 + R2_13 * t3_21 + R2_23 * t3_23 + R2_33 * t3_24;
  // a3 = R3^T U3 r3 + Pddot3: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t3_25 = U3_12 * T(0.35) - minus_U3_11 * T(0.1) - U3_13 * T(0.02);
  const T t3_26 = U3_21 * T(0.1) - minus_U3_22 * T(0.35) - U3_23 * T(0.02);
  const T t3_27 = U3_31 * T(0.1) + U3_32 * T(0.35) + minus_U3_33 * T(0.02);
  const T a3_1 = Pddot3_1 + R3_11 * t3_25 + R3_21 * t3_26 + R3_31 * t3_27;
  const T a3_2 = Pddot3_2 + R3_12 * t3_25 + R3_22 * t3_26 + R3_32 * t3_27;
  const T a3_3 = Pddot3_3 + R3_13 * t3_25 + R3_23 * t3_26 + R3_33 * t3_27;
  // G3 = m3 a3 - F3: inertia less applied force, inertial axes [N]
  const T G3_1 = T(0.1) + T(1.8) * a3_1;
  const T G3_2 = T(1.8) * a3_2 - T(0.05);
  const T G3_3 = T(1.8) * a3_3 - T(0.15);
  // N3 = axial(U3 (tr(I3)/2 - I3)) - M3: inertia less applied moment about the mass centre, body axes [N m]
  const T N3_1 = T(0.008) + T(0.195) * U3_32 - T(0.014999999999999986) * U3_23 - T(0.008) * (minus_U3_22 -
      minus_U3_33) + T(0.012) * U3_31 + T(0.006) * U3_21;
  const T N3_2 = T(0.014999999999999986) * U3_13 - T(0.004) - T(0.07500000000000001) * U3_31 - T(0.006) * (minus_U3_33
      - minus_U3_11) - T(0.008) * U3_12 - T(0.012) * U3_32;
  const T N3_3 = T(0.07500000000000001) * U3_21 - T(0.012) - T(0.195) * U3_12 + T(0.012) * (minus_U3_11 - minus_U3_22)
      - T(0.006) * U3_23 + T(0.008) * U3_13;

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[27], sdot4_2 = y[28], sdot4_3 = y[29];
  const T omegadot4_1 = ydot[9], omegadot4_2 = ydot[10], omegadot4_3 = ydot[11];
  const T sddot4_1 = ydot[27], sddot4_2 = ydot[28], sddot4_3 = ydot[29];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
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
  // Pddot4 = R2^T (2 omega2~ sdot4 + sddot4 + U2 d4) + Pddot2: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t4_19 = sddot4_1 + t3_19 * sdot4_3 - t3_20 * sdot4_2 + U2_12 * d4_2 - minus_U2_11 * d4_1 + U2_13 * d4_3;
  const T t4_20 = sddot4_2 + t3_20 * sdot4_1 - t3_22 * sdot4_3 + U2_21 * d4_1 - minus_U2_22 * d4_2 + U2_23 * d4_3;
  const T t4_21 = sddot4_3 + t3_22 * sdot4_2 - t3_19 * sdot4_1 + U2_31 * d4_1 + U2_32 * d4_2 - minus_U2_33 * d4_3;
  const T Pddot4_1 = Pddot2_1 + R2_11 * t4_19 + R2_21 * t4_20 + R2_31 * t4_21;
  const T Pddot4_2 = Pddot2_2 + R2_12 * t4_19 + R2_22 * t4_20 + R2_32 * t4_21;
  const T Pddot4_3 = Pddot2_3 + R2_13 * t4_19 + R2_23 * t4_20 + R2_33 * t4_21;
  // a4 = R4^T U4 r4 + Pddot4: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t4_22 = minus_U4_11 * T(0.03) + U4_12 * T(0.06) + U4_13 * T(0.1);
  const T t4_23 = U4_23 * T(0.1) - (U4_21 * T(0.03) + minus_U4_22 * T(0.06));
  const T t4_24 = U4_32 * T(0.06) - U4_31 * T(0.03) - minus_U4_33 * T(0.1);
  const T a4_1 = Pddot4_1 + R4_11 * t4_22 + R4_21 * t4_23 + R4_31 * t4_24;
  const T a4_2 = Pddot4_2 + R4_12 * t4_22 + R4_22 * t4_23 + R4_32 * t4_24;
  const T a4_3 = Pddot4_3 + R4_13 * t4_22 + R4_23 * t4_23 + R4_33 * t4_24;
  // G4 = m4 a4 - F4: inertia less applied force, inertial axes [N]
  const T G4_1 = c.p.m_payload * a4_1 - T(0.1);
  const T G4_2 = T(0.15) + c.p.m_payload * a4_2;
  const T G4_3 = c.p.m_payload * a4_3 - T(0.05);
  // N4 = axial(U4 (tr(I4)/2 - I4)) - M4: inertia less applied moment about the mass centre, body axes [N m]
  const T N4_1 = T(0.0185) * U4_32 - T(0.003) - T(0.041499999999999995) * U4_23 - T(0.003) * (minus_U4_22 -
      minus_U4_33) - T(0.004) * U4_31 - T(0.002) * U4_21;
  const T N4_2 = T(0.041499999999999995) * U4_13 - T(0.002) - T(0.0335) * U4_31 + T(0.002) * (minus_U4_33 -
      minus_U4_11) - T(0.003) * U4_12 + T(0.004) * U4_32;
  const T N4_3 = T(0.004) + T(0.0335) * U4_21 - T(0.0185) * U4_12 - T(0.004) * (minus_U4_11 - minus_U4_22) + T(0.002)
      * U4_23 + T(0.003) * U4_13;

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[30], sdot5_2 = y[31], sdot5_3 = y[32];
  const T omegadot5_1 = ydot[12], omegadot5_2 = ydot[13], omegadot5_3 = ydot[14];
  const T sddot5_1 = ydot[30], sddot5_2 = ydot[31], sddot5_3 = ydot[32];
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
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
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
  // Pddot5 = R1^T (2 omega1~ sdot5 + sddot5 + U1 d5) + Pddot1: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t5_19 = sddot5_1 + t2_19 * sdot5_3 - t2_20 * sdot5_2 + U1_12 * d5_2 - minus_U1_11 * d5_1 + U1_13 * d5_3;
  const T t5_20 = sddot5_2 + t2_20 * sdot5_1 - t2_22 * sdot5_3 + U1_21 * d5_1 - minus_U1_22 * d5_2 + U1_23 * d5_3;
  const T t5_21 = sddot5_3 + t2_22 * sdot5_2 - t2_19 * sdot5_1 + U1_31 * d5_1 + U1_32 * d5_2 - minus_U1_33 * d5_3;
  const T Pddot5_1 = sddot1_1 + R1_11 * t5_19 + R1_21 * t5_20 + R1_31 * t5_21;
  const T Pddot5_2 = sddot1_2 + R1_12 * t5_19 + R1_22 * t5_20 + R1_32 * t5_21;
  const T Pddot5_3 = Pddot1_3 + R1_13 * t5_19 + R1_23 * t5_20 + R1_33 * t5_21;
  // a5 = R5^T U5 r5 + Pddot5: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t5_22 = U5_12 * T(0.02) - minus_U5_11 * T(0.38) - U5_13 * T(0.04);
  const T t5_23 = U5_21 * T(0.38) - minus_U5_22 * T(0.02) - U5_23 * T(0.04);
  const T t5_24 = U5_31 * T(0.38) + U5_32 * T(0.02) + minus_U5_33 * T(0.04);
  const T a5_1 = Pddot5_1 + R5_11 * t5_22 + R5_21 * t5_23 + R5_31 * t5_24;
  const T a5_2 = Pddot5_2 + R5_12 * t5_22 + R5_22 * t5_23 + R5_32 * t5_24;
  const T a5_3 = Pddot5_3 + R5_13 * t5_22 + R5_23 * t5_23 + R5_33 * t5_24;
  // G5 = m5 a5 - F5: inertia less applied force, inertial axes [N]
  const T G5_1 = T(2.6) * a5_1 - T(0.12);
  const T G5_2 = T(0.07) + T(2.6) * a5_2;
  const T G5_3 = T(2.6) * a5_3 - T(0.09);
  // N5 = axial(U5 (tr(I5)/2 - I5)) - M5: inertia less applied moment about the mass centre, body axes [N m]
  const T N5_1 = T(0.02) + T(0.05000000000000001) * U5_32 - T(0.029999999999999992) * U5_23 + T(0.007) * (minus_U5_22
      - minus_U5_33) - T(0.005) * U5_31 + T(0.012) * U5_21;
  const T N5_2 = T(0.029999999999999992) * U5_13 - T(0.01) - T(0.28) * U5_31 - T(0.012) * (minus_U5_33 - minus_U5_11)
      + T(0.007) * U5_12 + T(0.005) * U5_32;
  const T N5_3 = T(0.28) * U5_21 - T(0.005) - T(0.05000000000000001) * U5_12 - T(0.005) * (minus_U5_11 - minus_U5_22)
      - T(0.012) * U5_23 - T(0.007) * U5_13;

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[33], sdot6_2 = y[34], sdot6_3 = y[35];
  const T omegadot6_1 = ydot[15], omegadot6_2 = ydot[16], omegadot6_3 = ydot[17];
  const T sddot6_1 = ydot[33], sddot6_2 = ydot[34], sddot6_3 = ydot[35];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
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
  // Pddot6 = R5^T (2 omega5~ sdot6 + sddot6 + U5 d6) + Pddot5: acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t6_19 = T(2) * omega5_2;
  const T t6_20 = T(2) * omega5_3;
  const T t6_21 = sddot6_1 + t6_19 * sdot6_3 - t6_20 * sdot6_2 + U5_12 * d6_2 - minus_U5_11 * d6_1 + U5_13 * d6_3;
  const T t6_22 = T(2) * omega5_1;
  const T t6_23 = sddot6_2 + t6_20 * sdot6_1 - t6_22 * sdot6_3 + U5_21 * d6_1 - minus_U5_22 * d6_2 + U5_23 * d6_3;
  const T t6_24 = sddot6_3 + t6_22 * sdot6_2 - t6_19 * sdot6_1 + U5_31 * d6_1 + U5_32 * d6_2 - minus_U5_33 * d6_3;
  const T Pddot6_1 = Pddot5_1 + R5_11 * t6_21 + R5_21 * t6_23 + R5_31 * t6_24;
  const T Pddot6_2 = Pddot5_2 + R5_12 * t6_21 + R5_22 * t6_23 + R5_32 * t6_24;
  const T Pddot6_3 = Pddot5_3 + R5_13 * t6_21 + R5_23 * t6_23 + R5_33 * t6_24;
  // a6 = R6^T U6 r6 + Pddot6: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t6_25 = U6_13 * T(0.07) - (minus_U6_11 * T(0.09) + U6_12 * T(0.05));
  const T t6_26 = U6_21 * T(0.09) + minus_U6_22 * T(0.05) + U6_23 * T(0.07);
  const T t6_27 = U6_31 * T(0.09) - U6_32 * T(0.05) - minus_U6_33 * T(0.07);
  const T a6_1 = Pddot6_1 + R6_11 * t6_25 + R6_21 * t6_26 + R6_31 * t6_27;
  const T a6_2 = Pddot6_2 + R6_12 * t6_25 + R6_22 * t6_26 + R6_32 * t6_27;
  const T a6_3 = Pddot6_3 + R6_13 * t6_25 + R6_23 * t6_26 + R6_33 * t6_27;
  // G6 = m6 a6 - F6: inertia less applied force, inertial axes [N]
  const T G6_1 = T(0.9) * a6_1 - T(0.05);
  const T G6_2 = T(0.9) * a6_2 - T(0.08);
  const T G6_3 = T(0.06) + T(0.9) * a6_3;
  // N6 = axial(U6 (tr(I6)/2 - I6)) - M6: inertia less applied moment about the mass centre, body axes [N m]
  const T N6_1 = T(0.0155) * U6_32 - T(0.002) - T(0.006499999999999999) * U6_23 - T(0.002) * (minus_U6_22 -
      minus_U6_33) - T(0.0015) * U6_31 - T(0.001) * U6_21;
  const T N6_2 = T(0.001) + T(0.006499999999999999) * U6_13 - T(0.0115) * U6_31 + T(0.001) * (minus_U6_33 -
      minus_U6_11) - T(0.002) * U6_12 + T(0.0015) * U6_32;
  const T N6_3 = T(0.0115) * U6_21 - T(0.0015) - T(0.0155) * U6_12 - T(0.0015) * (minus_U6_11 - minus_U6_22) +
      T(0.001) * U6_23 + T(0.002) * U6_13;

  // ---- body 6 (tool) and what it carries
  // r_omega6 = r6~ R6 G6 + N6: Kane's equation of omega [N m]
  const T b6_1 = R6_21 * G6_1 + R6_22 * G6_2 + R6_23 * G6_3;
  const T b6_2 = R6_31 * G6_1 + R6_32 * G6_2 + R6_33 * G6_3;
  const T r_omega6_1 = N6_1 - T(0.07) * b6_1 - T(0.05) * b6_2;
  const T b6_3 = R6_11 * G6_1 + R6_12 * G6_2 + R6_13 * G6_3;
  const T r_omega6_2 = N6_2 + T(0.07) * b6_3 - T(0.09) * b6_2;
  const T r_omega6_3 = N6_3 + T(0.09) * b6_1 + T(0.05) * b6_3;
  r[15] = r_omega6_1;
  r[16] = r_omega6_2;
  r[17] = r_omega6_3;
  // r_sdot6 = R5 G6: Kane's equation of sdot [N]
  const T r_sdot6_1 = R5_11 * G6_1 + R5_12 * G6_2 + R5_13 * G6_3;
  const T r_sdot6_2 = R5_21 * G6_1 + R5_22 * G6_2 + R5_23 * G6_3;
  const T r_sdot6_3 = R5_31 * G6_1 + R5_32 * G6_2 + R5_33 * G6_3;
  r[33] = r_sdot6_1;
  r[34] = r_sdot6_2;
  r[35] = r_sdot6_3;

  // ---- body 5 (arm) and what it carries
  // S5 = G5 + G6: sum of the force balances of the subtree, inertial axes [N]
  const T S5_1 = G5_1 + G6_1;
  const T S5_2 = G5_2 + G6_2;
  const T S5_3 = G5_3 + G6_3;
  // r_omega5 = r5~ R5 G5 + d6~ R5 G6 + N5: Kane's equation of omega [N m]
  const T b5_1 = R5_21 * G5_1 + R5_22 * G5_2 + R5_23 * G5_3;
  const T b5_2 = R5_31 * G5_1 + R5_32 * G5_2 + R5_33 * G5_3;
  const T r_omega5_1 = N5_1 + T(0.04) * b5_1 + T(0.02) * b5_2 + d6_2 * r_sdot6_3 - d6_3 * r_sdot6_2;
  const T b5_3 = R5_11 * G5_1 + R5_12 * G5_2 + R5_13 * G5_3;
  const T r_omega5_2 = N5_2 - T(0.04) * b5_3 - T(0.38) * b5_2 + d6_3 * r_sdot6_1 - d6_1 * r_sdot6_3;
  const T r_omega5_3 = N5_3 + T(0.38) * b5_1 - T(0.02) * b5_3 + d6_1 * r_sdot6_2 - d6_2 * r_sdot6_1;
  r[12] = r_omega5_1;
  r[13] = r_omega5_2;
  r[14] = r_omega5_3;
  // r_sdot5 = R1 S5: Kane's equation of sdot [N]
  const T r_sdot5_1 = R1_11 * S5_1 + R1_12 * S5_2 + R1_13 * S5_3;
  const T r_sdot5_2 = R1_21 * S5_1 + R1_22 * S5_2 + R1_23 * S5_3;
  const T r_sdot5_3 = R1_31 * S5_1 + R1_32 * S5_2 + R1_33 * S5_3;
  r[30] = r_sdot5_1;
  r[31] = r_sdot5_2;
  r[32] = r_sdot5_3;

  // ---- body 4 (payload) and what it carries
  // r_omega4 = r4~ R4 G4 + N4: Kane's equation of omega [N m]
  const T b4_1 = R4_31 * G4_1 + R4_32 * G4_2 + R4_33 * G4_3;
  const T b4_2 = R4_21 * G4_1 + R4_22 * G4_2 + R4_23 * G4_3;
  const T r_omega4_1 = N4_1 + T(0.06) * b4_1 - T(0.1) * b4_2;
  const T b4_3 = R4_11 * G4_1 + R4_12 * G4_2 + R4_13 * G4_3;
  const T r_omega4_2 = N4_2 + T(0.1) * b4_3 + T(0.03) * b4_1;
  const T r_omega4_3 = N4_3 - T(0.03) * b4_2 - T(0.06) * b4_3;
  r[9] = r_omega4_1;
  r[10] = r_omega4_2;
  r[11] = r_omega4_3;
  // r_sdot4 = R2 G4: Kane's equation of sdot [N]
  const T r_sdot4_1 = R2_11 * G4_1 + R2_12 * G4_2 + R2_13 * G4_3;
  const T r_sdot4_2 = R2_21 * G4_1 + R2_22 * G4_2 + R2_23 * G4_3;
  const T r_sdot4_3 = R2_31 * G4_1 + R2_32 * G4_2 + R2_33 * G4_3;
  r[27] = r_sdot4_1;
  r[28] = r_sdot4_2;
  r[29] = r_sdot4_3;

  // ---- body 3 (panel) and what it carries
  // r_omega3 = r3~ R3 G3 + N3: Kane's equation of omega [N m]
  const T b3_1 = R3_21 * G3_1 + R3_22 * G3_2 + R3_23 * G3_3;
  const T b3_2 = R3_31 * G3_1 + R3_32 * G3_2 + R3_33 * G3_3;
  const T r_omega3_1 = N3_1 + T(0.02) * b3_1 + T(0.35) * b3_2;
  const T b3_3 = R3_11 * G3_1 + R3_12 * G3_2 + R3_13 * G3_3;
  const T r_omega3_2 = N3_2 - T(0.02) * b3_3 - T(0.1) * b3_2;
  const T r_omega3_3 = N3_3 + T(0.1) * b3_1 - T(0.35) * b3_3;
  r[6] = r_omega3_1;
  r[7] = r_omega3_2;
  r[8] = r_omega3_3;
  // r_sdot3 = R2 G3: Kane's equation of sdot [N]
  const T r_sdot3_1 = R2_11 * G3_1 + R2_12 * G3_2 + R2_13 * G3_3;
  const T r_sdot3_2 = R2_21 * G3_1 + R2_22 * G3_2 + R2_23 * G3_3;
  const T r_sdot3_3 = R2_31 * G3_1 + R2_32 * G3_2 + R2_33 * G3_3;
  r[24] = r_sdot3_1;
  r[25] = r_sdot3_2;
  r[26] = r_sdot3_3;

  // ---- body 2 (boom) and what it carries
  // S2 = G2 + G3 + G4: sum of the force balances of the subtree, inertial axes [N]
  const T S2_1 = G2_1 + G3_1 + G4_1;
  const T S2_2 = G2_2 + G3_2 + G4_2;
  const T S2_3 = G2_3 + G3_3 + G4_3;
  // r_omega2 = r2~ R2 G2 + d3~ R2 G3 + d4~ R2 G4 + N2: Kane's equation of omega [N m]
  const T b2_1 = R2_31 * G2_1 + R2_32 * G2_2 + R2_33 * G2_3;
  const T b2_2 = R2_21 * G2_1 + R2_22 * G2_2 + R2_23 * G2_3;
  const T r_omega2_1 = N2_1 + T(0.04) * b2_1 - T(0.45) * b2_2 + d3_2 * r_sdot3_3 - d3_3 * r_sdot3_2 + d4_2 * r_sdot4_3
      - d4_3 * r_sdot4_2;
  const T b2_3 = R2_11 * G2_1 + R2_12 * G2_2 + R2_13 * G2_3;
  const T r_omega2_2 = N2_2 + T(0.45) * b2_3 - T(0.03) * b2_1 + d3_3 * r_sdot3_1 - d3_1 * r_sdot3_3 + d4_3 * r_sdot4_1
      - d4_1 * r_sdot4_3;
  const T r_omega2_3 = N2_3 + T(0.03) * b2_2 - T(0.04) * b2_3 + d3_1 * r_sdot3_2 - d3_2 * r_sdot3_1 + d4_1 * r_sdot4_2
      - d4_2 * r_sdot4_1;
  r[3] = r_omega2_1;
  r[4] = r_omega2_2;
  r[5] = r_omega2_3;
  // r_sdot2 = R1 S2: Kane's equation of sdot [N]
  const T r_sdot2_1 = R1_11 * S2_1 + R1_12 * S2_2 + R1_13 * S2_3;
  const T r_sdot2_2 = R1_21 * S2_1 + R1_22 * S2_2 + R1_23 * S2_3;
  const T r_sdot2_3 = R1_31 * S2_1 + R1_32 * S2_2 + R1_33 * S2_3;
  r[21] = r_sdot2_1;
  r[22] = r_sdot2_2;
  r[23] = r_sdot2_3;

  // ---- body 1 (hub) and what it carries
  // S1 = G1 + S5 + S2: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = G1_1 + S5_1 + S2_1;
  const T S1_2 = G1_2 + S5_2 + S2_2;
  const T S1_3 = G1_3 + S5_3 + S2_3;
  r[18] = S1_1;
  r[19] = S1_2;
  r[20] = S1_3;
  // r_omega1 = r1~ R1 G1 + d2~ R1 S2 + d5~ R1 S5 + N1: Kane's equation of omega [N m]
  const T b1_1 = R1_21 * G1_1 + R1_22 * G1_2 + R1_23 * G1_3;
  const T b1_2 = R1_31 * G1_1 + R1_32 * G1_2 + R1_33 * G1_3;
  const T r_omega1_1 = N1_1 - T(0.08) * b1_1 - T(0.02) * b1_2 + d2_2 * r_sdot2_3 - d2_3 * r_sdot2_2 + d5_2 * r_sdot5_3
      - d5_3 * r_sdot5_2;
  const T b1_3 = R1_11 * G1_1 + R1_12 * G1_2 + R1_13 * G1_3;
  const T r_omega1_2 = N1_2 + T(0.08) * b1_3 - T(0.05) * b1_2 + d2_3 * r_sdot2_1 - d2_1 * r_sdot2_3 + d5_3 * r_sdot5_1
      - d5_1 * r_sdot5_3;
  const T r_omega1_3 = N1_3 + T(0.05) * b1_1 + T(0.02) * b1_3 + d2_1 * r_sdot2_2 - d2_2 * r_sdot2_1 + d5_1 * r_sdot5_2
      - d5_2 * r_sdot5_1;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 528 add, 587 multiply
template <class T>
void forcing(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* f) noexcept {

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
  // U1 = omega1~ omega1~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t1_13 = omega1_3 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T minus_U1_11 = t1_13 + t1_14;
  const T U1_12 = omega1_1 * omega1_2;
  const T U1_13 = omega1_1 * omega1_3;
  const T t1_15 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_15;
  const T U1_23 = omega1_2 * omega1_3;
  const T minus_U1_33 = t1_14 + t1_15;
  // a1 = R1^T U1 r1 + Pddot1: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t1_16 = U1_13 * T(0.08) - (minus_U1_11 * T(0.05) + U1_12 * T(0.02));
  const T t1_17 = T(0.05) * U1_12;
  const T t1_18 = t1_17 + minus_U1_22 * T(0.02) + U1_23 * T(0.08);
  const T t1_19 = T(0.05) * U1_13;
  const T t1_20 = t1_19 - U1_23 * T(0.02) - minus_U1_33 * T(0.08);
  const T a1_1 = R1_11 * t1_16 + R1_21 * t1_18 + R1_31 * t1_20;
  const T a1_2 = R1_12 * t1_16 + R1_22 * t1_18 + R1_32 * t1_20;
  const T a1_3 = T(9.81) + R1_13 * t1_16 + R1_23 * t1_18 + R1_33 * t1_20;
  // G1 = -m1 a1 + F1: applied less inertia force, inertial axes [N]
  const T G1_1 = T(0.5) - T(12) * a1_1;
  const T minus_G1_2 = T(0.3) + T(12) * a1_2;
  const T G1_3 = u.thrust - T(12) * a1_3;
  // N1 = -omega1~ I1 omega1 + M1: applied less inertia moment about the mass centre, body axes [N m]
  const T N1_1 = T(0.05) - T(0.3500000000000001) * U1_23 - T(0.05) * (t1_14 - t1_13) + T(0.03) * U1_12 + T(0.04) *
      U1_13;
  const T minus_N1_2 = T(0.02) - t1_17 - T(0.19999999999999996) * U1_13 - T(0.03) * (t1_13 - t1_15) + T(0.04) * U1_23;
  const T N1_3 = T(0.03) - t1_19 + T(0.15000000000000013) * U1_12 - T(0.04) * (t1_15 - t1_14) - T(0.03) * U1_23;

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[21], sdot2_2 = y[22], sdot2_3 = y[23];
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
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
  // U2 = omega2~ omega2~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t2_13 = omega2_3 * omega2_3;
  const T t2_14 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_13 + t2_14;
  const T U2_12 = omega2_1 * omega2_2;
  const T U2_13 = omega2_1 * omega2_3;
  const T t2_15 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_13 + t2_15;
  const T U2_23 = omega2_2 * omega2_3;
  const T minus_U2_33 = t2_14 + t2_15;
  // Pddot2 = R1^T omega1~ (omega1~ d2 + 2 sdot2) + Pddot1: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t2_16 = omega1_1 * d2_2 - omega1_2 * d2_1 + T(2) * sdot2_3;
  const T t2_17 = omega1_3 * d2_1 - omega1_1 * d2_3 + T(2) * sdot2_2;
  const T t2_18 = omega1_2 * t2_16 - omega1_3 * t2_17;
  const T t2_19 = omega1_2 * d2_3 - omega1_3 * d2_2 + T(2) * sdot2_1;
  const T t2_20 = omega1_3 * t2_19 - omega1_1 * t2_16;
  const T t2_21 = omega1_1 * t2_17 - omega1_2 * t2_19;
  const T Pddot2_1 = R1_11 * t2_18 + R1_21 * t2_20 + R1_31 * t2_21;
  const T Pddot2_2 = R1_12 * t2_18 + R1_22 * t2_20 + R1_32 * t2_21;
  const T Pddot2_3 = T(9.81) + R1_13 * t2_18 + R1_23 * t2_20 + R1_33 * t2_21;
  // a2 = R2^T U2 r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_22 = U2_12 * T(0.04) - minus_U2_11 * T(0.03) + U2_13 * T(0.45);
  const T t2_23 = T(0.03) * U2_12;
  const T t2_24 = t2_23 - minus_U2_22 * T(0.04) + U2_23 * T(0.45);
  const T t2_25 = T(0.03) * U2_13;
  const T t2_26 = t2_25 + U2_23 * T(0.04) - minus_U2_33 * T(0.45);
  const T a2_1 = Pddot2_1 + R2_11 * t2_22 + R2_21 * t2_24 + R2_31 * t2_26;
  const T a2_2 = Pddot2_2 + R2_12 * t2_22 + R2_22 * t2_24 + R2_32 * t2_26;
  const T a2_3 = Pddot2_3 + R2_13 * t2_22 + R2_23 * t2_24 + R2_33 * t2_26;
  // G2 = -m2 a2 + F2: applied less inertia force, inertial axes [N]
  const T G2_1 = T(0.2) - T(3.5) * a2_1;
  const T G2_2 = T(0.1) - T(3.5) * a2_2;
  const T minus_G2_3 = T(0.4) + T(3.5) * a2_3;
  // N2 = -omega2~ I2 omega2 + M2: applied less inertia moment about the mass centre, body axes [N m]
  const T N2_1 = T(0.01) + T(0.27) * U2_23 + T(0.03) * (t2_14 - t2_13) - T(0.01) * U2_12 + T(0.02) * U2_13;
  const T N2_2 = T(0.02) - t2_23 - T(0.31) * U2_13 - T(0.01) * (t2_13 - t2_15) - T(0.02) * U2_23;
  const T minus_N2_3 = T(0.015) - t2_25 + T(0.02) * (t2_15 - t2_14) - T(0.03999999999999998) * U2_12 - T(0.01) *
      U2_23;

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[24], sdot3_2 = y[25], sdot3_3 = y[26];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
  // U3 = omega3~ omega3~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t3_13 = omega3_3 * omega3_3;
  const T t3_14 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_13 + t3_14;
  const T U3_12 = omega3_1 * omega3_2;
  const T U3_13 = omega3_1 * omega3_3;
  const T t3_15 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_13 + t3_15;
  const T U3_23 = omega3_2 * omega3_3;
  const T minus_U3_33 = t3_14 + t3_15;
  // Pddot3 = R2^T omega2~ (omega2~ d3 + 2 sdot3) + Pddot2: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t3_16 = omega2_1 * d3_2 - omega2_2 * d3_1 + T(2) * sdot3_3;
  const T t3_17 = omega2_3 * d3_1 - omega2_1 * d3_3 + T(2) * sdot3_2;
  const T t3_18 = omega2_2 * t3_16 - omega2_3 * t3_17;
  const T t3_19 = omega2_2 * d3_3 - omega2_3 * d3_2 + T(2) * sdot3_1;
  const T t3_20 = omega2_3 * t3_19 - omega2_1 * t3_16;
  const T t3_21 = omega2_1 * t3_17 - omega2_2 * t3_19;
  const T Pddot3_1 = Pddot2_1 + R2_11 * t3_18 + R2_21 * t3_20 + R2_31 * t3_21;
  const T Pddot3_2 = Pddot2_2 + R2_12 * t3_18 + R2_22 * t3_20 + R2_32 * t3_21;
  const T Pddot3_3 = Pddot2_3 + R2_13 * t3_18 + R2_23 * t3_20 + R2_33 * t3_21;
  // a3 = R3^T U3 r3 + Pddot3: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t3_22 = U3_12 * T(0.35) - minus_U3_11 * T(0.1) - U3_13 * T(0.02);
  const T t3_23 = U3_12 * T(0.1) - minus_U3_22 * T(0.35) - U3_23 * T(0.02);
  const T t3_24 = U3_13 * T(0.1) + U3_23 * T(0.35) + minus_U3_33 * T(0.02);
  const T a3_1 = Pddot3_1 + R3_11 * t3_22 + R3_21 * t3_23 + R3_31 * t3_24;
  const T a3_2 = Pddot3_2 + R3_12 * t3_22 + R3_22 * t3_23 + R3_32 * t3_24;
  const T a3_3 = Pddot3_3 + R3_13 * t3_22 + R3_23 * t3_23 + R3_33 * t3_24;
  // G3 = -m3 a3 + F3: applied less inertia force, inertial axes [N]
  const T minus_G3_1 = T(0.1) + T(1.8) * a3_1;
  const T G3_2 = T(0.05) - T(1.8) * a3_2;
  const T G3_3 = T(0.15) - T(1.8) * a3_3;
  // N3 = -omega3~ I3 omega3 + M3: applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N3_1 = T(0.008) + T(0.18000000000000002) * U3_23 + T(0.008) * (t3_14 - t3_13) + T(0.006) * U3_12 +
      T(0.012) * U3_13;
  const T N3_2 = T(0.004) + T(0.060000000000000026) * U3_13 - T(0.006) * (t3_13 - t3_15) + T(0.012) * U3_23 + T(0.008)
      * U3_12;
  const T N3_3 = T(0.012) + T(0.12) * U3_12 + T(0.012) * (t3_15 - t3_14) - T(0.008) * U3_13 + T(0.006) * U3_23;

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[27], sdot4_2 = y[28], sdot4_3 = y[29];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
  // U4 = omega4~ omega4~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t4_13 = omega4_3 * omega4_3;
  const T t4_14 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_13 + t4_14;
  const T U4_12 = omega4_1 * omega4_2;
  const T U4_13 = omega4_1 * omega4_3;
  const T t4_15 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_13 + t4_15;
  const T U4_23 = omega4_2 * omega4_3;
  const T minus_U4_33 = t4_14 + t4_15;
  // Pddot4 = R2^T omega2~ (omega2~ d4 + 2 sdot4) + Pddot2: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t4_16 = omega2_1 * d4_2 - omega2_2 * d4_1 + T(2) * sdot4_3;
  const T t4_17 = omega2_3 * d4_1 - omega2_1 * d4_3 + T(2) * sdot4_2;
  const T t4_18 = omega2_2 * t4_16 - omega2_3 * t4_17;
  const T t4_19 = omega2_2 * d4_3 - omega2_3 * d4_2 + T(2) * sdot4_1;
  const T t4_20 = omega2_3 * t4_19 - omega2_1 * t4_16;
  const T t4_21 = omega2_1 * t4_17 - omega2_2 * t4_19;
  const T Pddot4_1 = Pddot2_1 + R2_11 * t4_18 + R2_21 * t4_20 + R2_31 * t4_21;
  const T Pddot4_2 = Pddot2_2 + R2_12 * t4_18 + R2_22 * t4_20 + R2_32 * t4_21;
  const T Pddot4_3 = Pddot2_3 + R2_13 * t4_18 + R2_23 * t4_20 + R2_33 * t4_21;
  // a4 = R4^T U4 r4 + Pddot4: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t4_22 = minus_U4_11 * T(0.03) + U4_12 * T(0.06) + U4_13 * T(0.1);
  const T t4_23 = U4_23 * T(0.1) - (U4_12 * T(0.03) + minus_U4_22 * T(0.06));
  const T t4_24 = U4_23 * T(0.06) - U4_13 * T(0.03) - minus_U4_33 * T(0.1);
  const T a4_1 = Pddot4_1 + R4_11 * t4_22 + R4_21 * t4_23 + R4_31 * t4_24;
  const T a4_2 = Pddot4_2 + R4_12 * t4_22 + R4_22 * t4_23 + R4_32 * t4_24;
  const T a4_3 = Pddot4_3 + R4_13 * t4_22 + R4_23 * t4_23 + R4_33 * t4_24;
  // G4 = -m4 a4 + F4: applied less inertia force, inertial axes [N]
  const T G4_1 = T(0.1) - c.p.m_payload * a4_1;
  const T minus_G4_2 = T(0.15) + c.p.m_payload * a4_2;
  const T G4_3 = T(0.05) - c.p.m_payload * a4_3;
  // N4 = -omega4~ I4 omega4 + M4: applied less inertia moment about the mass centre, body axes [N m]
  const T N4_1 = T(0.003) + T(0.023) * U4_23 - T(0.003) * (t4_14 - t4_13) + T(0.002) * U4_12 + T(0.004) * U4_13;
  const T N4_2 = T(0.002) + T(0.002) * (t4_13 - t4_15) - T(0.008) * U4_13 - T(0.004) * U4_23 + T(0.003) * U4_12;
  const T minus_N4_3 = T(0.004) + T(0.015) * U4_12 + T(0.004) * (t4_15 - t4_14) + T(0.003) * U4_13 + T(0.002) * U4_23;

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[30], sdot5_2 = y[31], sdot5_3 = y[32];
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
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
  // U5 = omega5~ omega5~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t5_13 = omega5_3 * omega5_3;
  const T t5_14 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_13 + t5_14;
  const T U5_12 = omega5_1 * omega5_2;
  const T U5_13 = omega5_1 * omega5_3;
  const T t5_15 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_13 + t5_15;
  const T U5_23 = omega5_2 * omega5_3;
  const T minus_U5_33 = t5_14 + t5_15;
  // Pddot5 = R1^T omega1~ (omega1~ d5 + 2 sdot5) + Pddot1: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t5_16 = omega1_1 * d5_2 - omega1_2 * d5_1 + T(2) * sdot5_3;
  const T t5_17 = omega1_3 * d5_1 - omega1_1 * d5_3 + T(2) * sdot5_2;
  const T t5_18 = omega1_2 * t5_16 - omega1_3 * t5_17;
  const T t5_19 = omega1_2 * d5_3 - omega1_3 * d5_2 + T(2) * sdot5_1;
  const T t5_20 = omega1_3 * t5_19 - omega1_1 * t5_16;
  const T t5_21 = omega1_1 * t5_17 - omega1_2 * t5_19;
  const T Pddot5_1 = R1_11 * t5_18 + R1_21 * t5_20 + R1_31 * t5_21;
  const T Pddot5_2 = R1_12 * t5_18 + R1_22 * t5_20 + R1_32 * t5_21;
  const T Pddot5_3 = T(9.81) + R1_13 * t5_18 + R1_23 * t5_20 + R1_33 * t5_21;
  // a5 = R5^T U5 r5 + Pddot5: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t5_22 = U5_12 * T(0.02) - minus_U5_11 * T(0.38) - U5_13 * T(0.04);
  const T t5_23 = U5_12 * T(0.38) - minus_U5_22 * T(0.02) - U5_23 * T(0.04);
  const T t5_24 = U5_13 * T(0.38) + U5_23 * T(0.02) + minus_U5_33 * T(0.04);
  const T a5_1 = Pddot5_1 + R5_11 * t5_22 + R5_21 * t5_23 + R5_31 * t5_24;
  const T a5_2 = Pddot5_2 + R5_12 * t5_22 + R5_22 * t5_23 + R5_32 * t5_24;
  const T a5_3 = Pddot5_3 + R5_13 * t5_22 + R5_23 * t5_23 + R5_33 * t5_24;
  // G5 = -m5 a5 + F5: applied less inertia force, inertial axes [N]
  const T G5_1 = T(0.12) - T(2.6) * a5_1;
  const T minus_G5_2 = T(0.07) + T(2.6) * a5_2;
  const T G5_3 = T(0.09) - T(2.6) * a5_3;
  // N5 = -omega5~ I5 omega5 + M5: applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N5_1 = T(0.02) + T(0.020000000000000018) * U5_23 - T(0.007) * (t5_14 - t5_13) + T(0.012) * U5_12 -
      T(0.005) * U5_13;
  const T N5_2 = T(0.01) + T(0.25) * U5_13 - T(0.012) * (t5_13 - t5_15) - T(0.005) * U5_23 - T(0.007) * U5_12;
  const T N5_3 = T(0.005) - T(0.22999999999999998) * U5_12 - T(0.005) * (t5_15 - t5_14) + T(0.007) * U5_13 + T(0.012)
      * U5_23;

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[33], sdot6_2 = y[34], sdot6_3 = y[35];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
  // U6 = omega6~ omega6~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t6_13 = omega6_3 * omega6_3;
  const T t6_14 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_13 + t6_14;
  const T U6_12 = omega6_1 * omega6_2;
  const T U6_13 = omega6_1 * omega6_3;
  const T t6_15 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_13 + t6_15;
  const T U6_23 = omega6_2 * omega6_3;
  const T minus_U6_33 = t6_14 + t6_15;
  // Pddot6 = R5^T omega5~ (omega5~ d6 + 2 sdot6) + Pddot5: acceleration of the body origin, less gravity, inertial
  //   axes [m/s^2]
  const T t6_16 = omega5_1 * d6_2 - omega5_2 * d6_1 + T(2) * sdot6_3;
  const T t6_17 = omega5_3 * d6_1 - omega5_1 * d6_3 + T(2) * sdot6_2;
  const T t6_18 = omega5_2 * t6_16 - omega5_3 * t6_17;
  const T t6_19 = omega5_2 * d6_3 - omega5_3 * d6_2 + T(2) * sdot6_1;
  const T t6_20 = omega5_3 * t6_19 - omega5_1 * t6_16;
  const T t6_21 = omega5_1 * t6_17 - omega5_2 * t6_19;
  const T Pddot6_1 = Pddot5_1 + R5_11 * t6_18 + R5_21 * t6_20 + R5_31 * t6_21;
  const T Pddot6_2 = Pddot5_2 + R5_12 * t6_18 + R5_22 * t6_20 + R5_32 * t6_21;
  const T Pddot6_3 = Pddot5_3 + R5_13 * t6_18 + R5_23 * t6_20 + R5_33 * t6_21;
  // a6 = R6^T U6 r6 + Pddot6: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t6_22 = U6_13 * T(0.07) - (minus_U6_11 * T(0.09) + U6_12 * T(0.05));
  const T t6_23 = U6_12 * T(0.09) + minus_U6_22 * T(0.05) + U6_23 * T(0.07);
  const T t6_24 = U6_13 * T(0.09) - U6_23 * T(0.05) - minus_U6_33 * T(0.07);
  const T a6_1 = Pddot6_1 + R6_11 * t6_22 + R6_21 * t6_23 + R6_31 * t6_24;
  const T a6_2 = Pddot6_2 + R6_12 * t6_22 + R6_22 * t6_23 + R6_32 * t6_24;
  const T a6_3 = Pddot6_3 + R6_13 * t6_22 + R6_23 * t6_23 + R6_33 * t6_24;
  // G6 = -m6 a6 + F6: applied less inertia force, inertial axes [N]
  const T G6_1 = T(0.05) - T(0.9) * a6_1;
  const T G6_2 = T(0.08) - T(0.9) * a6_2;
  const T minus_G6_3 = T(0.06) + T(0.9) * a6_3;
  // N6 = -omega6~ I6 omega6 + M6: applied less inertia moment about the mass centre, body axes [N m]
  const T N6_1 = T(0.002) - T(0.009000000000000001) * U6_23 - T(0.002) * (t6_14 - t6_13) + T(0.001) * U6_12 +
      T(0.0015) * U6_13;
  const T minus_N6_2 = T(0.001) - T(0.005000000000000001) * U6_13 - T(0.001) * (t6_13 - t6_15) + T(0.0015) * U6_23 -
      T(0.002) * U6_12;
  const T N6_3 = T(0.0015) + T(0.004) * U6_12 - T(0.0015) * (t6_15 - t6_14) - T(0.002) * U6_13 - T(0.001) * U6_23;

  // ---- body 6 (tool) and what it carries
  // f_omega6 = r6~ R6 G6 + N6: Kane's equation of omega [N m]
  const T b6_1 = R6_21 * G6_1 + R6_22 * G6_2 - R6_23 * minus_G6_3;
  const T b6_2 = R6_31 * G6_1 + R6_32 * G6_2 - R6_33 * minus_G6_3;
  const T f_omega6_1 = N6_1 - T(0.07) * b6_1 - T(0.05) * b6_2;
  const T b6_3 = R6_11 * G6_1 + R6_12 * G6_2 - R6_13 * minus_G6_3;
  const T f_omega6_2 = T(0.07) * b6_3 - minus_N6_2 - T(0.09) * b6_2;
  const T f_omega6_3 = N6_3 + T(0.09) * b6_1 + T(0.05) * b6_3;
  f[15] = f_omega6_1;
  f[16] = f_omega6_2;
  f[17] = f_omega6_3;
  // f_sdot6 = R5 G6: Kane's equation of sdot [N]
  const T f_sdot6_1 = R5_11 * G6_1 + R5_12 * G6_2 - R5_13 * minus_G6_3;
  const T f_sdot6_2 = R5_21 * G6_1 + R5_22 * G6_2 - R5_23 * minus_G6_3;
  const T f_sdot6_3 = R5_31 * G6_1 + R5_32 * G6_2 - R5_33 * minus_G6_3;
  f[33] = f_sdot6_1;
  f[34] = f_sdot6_2;
  f[35] = f_sdot6_3;

  // ---- body 5 (arm) and what it carries
  // S5 = G5 + G6: sum of the force balances of the subtree, inertial axes [N]
  const T S5_1 = G5_1 + G6_1;
  const T S5_2 = G6_2 - minus_G5_2;
  const T S5_3 = G5_3 - minus_G6_3;
  // f_omega5 = r5~ R5 G5 + d6~ R5 G6 + N5: Kane's equation of omega [N m]
  const T b5_1 = R5_21 * G5_1 - R5_22 * minus_G5_2 + R5_23 * G5_3;
  const T b5_2 = R5_31 * G5_1 - R5_32 * minus_G5_2 + R5_33 * G5_3;
  const T f_omega5_1 = T(0.04) * b5_1 - minus_N5_1 + T(0.02) * b5_2 + d6_2 * f_sdot6_3 - d6_3 * f_sdot6_2;
  const T b5_3 = R5_11 * G5_1 - R5_12 * minus_G5_2 + R5_13 * G5_3;
  const T f_omega5_2 = N5_2 - T(0.04) * b5_3 - T(0.38) * b5_2 + d6_3 * f_sdot6_1 - d6_1 * f_sdot6_3;
  const T f_omega5_3 = N5_3 + T(0.38) * b5_1 - T(0.02) * b5_3 + d6_1 * f_sdot6_2 - d6_2 * f_sdot6_1;
  f[12] = f_omega5_1;
  f[13] = f_omega5_2;
  f[14] = f_omega5_3;
  // f_sdot5 = R1 S5: Kane's equation of sdot [N]
  const T f_sdot5_1 = R1_11 * S5_1 + R1_12 * S5_2 + R1_13 * S5_3;
  const T f_sdot5_2 = R1_21 * S5_1 + R1_22 * S5_2 + R1_23 * S5_3;
  const T f_sdot5_3 = R1_31 * S5_1 + R1_32 * S5_2 + R1_33 * S5_3;
  f[30] = f_sdot5_1;
  f[31] = f_sdot5_2;
  f[32] = f_sdot5_3;

  // ---- body 4 (payload) and what it carries
  // f_omega4 = r4~ R4 G4 + N4: Kane's equation of omega [N m]
  const T b4_1 = R4_31 * G4_1 - R4_32 * minus_G4_2 + R4_33 * G4_3;
  const T b4_2 = R4_21 * G4_1 - R4_22 * minus_G4_2 + R4_23 * G4_3;
  const T f_omega4_1 = N4_1 + T(0.06) * b4_1 - T(0.1) * b4_2;
  const T b4_3 = R4_11 * G4_1 - R4_12 * minus_G4_2 + R4_13 * G4_3;
  const T f_omega4_2 = N4_2 + T(0.1) * b4_3 + T(0.03) * b4_1;
  const T minus_f_omega4_3 = minus_N4_3 + T(0.03) * b4_2 + T(0.06) * b4_3;
  f[9] = f_omega4_1;
  f[10] = f_omega4_2;
  f[11] = -minus_f_omega4_3;
  // f_sdot4 = R2 G4: Kane's equation of sdot [N]
  const T f_sdot4_1 = R2_11 * G4_1 - R2_12 * minus_G4_2 + R2_13 * G4_3;
  const T f_sdot4_2 = R2_21 * G4_1 - R2_22 * minus_G4_2 + R2_23 * G4_3;
  const T f_sdot4_3 = R2_31 * G4_1 - R2_32 * minus_G4_2 + R2_33 * G4_3;
  f[27] = f_sdot4_1;
  f[28] = f_sdot4_2;
  f[29] = f_sdot4_3;

  // ---- body 3 (panel) and what it carries
  // f_omega3 = r3~ R3 G3 + N3: Kane's equation of omega [N m]
  const T b3_1 = R3_22 * G3_2 - R3_21 * minus_G3_1 + R3_23 * G3_3;
  const T b3_2 = R3_32 * G3_2 - R3_31 * minus_G3_1 + R3_33 * G3_3;
  const T f_omega3_1 = T(0.02) * b3_1 - minus_N3_1 + T(0.35) * b3_2;
  const T b3_3 = R3_12 * G3_2 - R3_11 * minus_G3_1 + R3_13 * G3_3;
  const T f_omega3_2 = N3_2 - T(0.02) * b3_3 - T(0.1) * b3_2;
  const T f_omega3_3 = N3_3 + T(0.1) * b3_1 - T(0.35) * b3_3;
  f[6] = f_omega3_1;
  f[7] = f_omega3_2;
  f[8] = f_omega3_3;
  // f_sdot3 = R2 G3: Kane's equation of sdot [N]
  const T f_sdot3_1 = R2_12 * G3_2 - R2_11 * minus_G3_1 + R2_13 * G3_3;
  const T f_sdot3_2 = R2_22 * G3_2 - R2_21 * minus_G3_1 + R2_23 * G3_3;
  const T f_sdot3_3 = R2_32 * G3_2 - R2_31 * minus_G3_1 + R2_33 * G3_3;
  f[24] = f_sdot3_1;
  f[25] = f_sdot3_2;
  f[26] = f_sdot3_3;

  // ---- body 2 (boom) and what it carries
  // S2 = G2 + G3 + G4: sum of the force balances of the subtree, inertial axes [N]
  const T S2_1 = G2_1 - minus_G3_1 + G4_1;
  const T S2_2 = G2_2 + G3_2 - minus_G4_2;
  const T S2_3 = G3_3 - minus_G2_3 + G4_3;
  // f_omega2 = r2~ R2 G2 + d3~ R2 G3 + d4~ R2 G4 + N2: Kane's equation of omega [N m]
  const T b2_1 = R2_31 * G2_1 + R2_32 * G2_2 - R2_33 * minus_G2_3;
  const T b2_2 = R2_21 * G2_1 + R2_22 * G2_2 - R2_23 * minus_G2_3;
  const T f_omega2_1 = N2_1 + T(0.04) * b2_1 - T(0.45) * b2_2 + d3_2 * f_sdot3_3 - d3_3 * f_sdot3_2 + d4_2 * f_sdot4_3
      - d4_3 * f_sdot4_2;
  const T b2_3 = R2_11 * G2_1 + R2_12 * G2_2 - R2_13 * minus_G2_3;
  const T f_omega2_2 = N2_2 + T(0.45) * b2_3 - T(0.03) * b2_1 + d3_3 * f_sdot3_1 - d3_1 * f_sdot3_3 + d4_3 * f_sdot4_1
      - d4_1 * f_sdot4_3;
  const T f_omega2_3 = T(0.03) * b2_2 - minus_N2_3 - T(0.04) * b2_3 + d3_1 * f_sdot3_2 - d3_2 * f_sdot3_1 + d4_1 *
      f_sdot4_2 - d4_2 * f_sdot4_1;
  f[3] = f_omega2_1;
  f[4] = f_omega2_2;
  f[5] = f_omega2_3;
  // f_sdot2 = R1 S2: Kane's equation of sdot [N]
  const T f_sdot2_1 = R1_11 * S2_1 + R1_12 * S2_2 + R1_13 * S2_3;
  const T f_sdot2_2 = R1_21 * S2_1 + R1_22 * S2_2 + R1_23 * S2_3;
  const T f_sdot2_3 = R1_31 * S2_1 + R1_32 * S2_2 + R1_33 * S2_3;
  f[21] = f_sdot2_1;
  f[22] = f_sdot2_2;
  f[23] = f_sdot2_3;

  // ---- body 1 (hub) and what it carries
  // S1 = G1 + S5 + S2: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = G1_1 + S5_1 + S2_1;
  const T S1_2 = S5_2 - minus_G1_2 + S2_2;
  const T S1_3 = G1_3 + S5_3 + S2_3;
  f[18] = S1_1;
  f[19] = S1_2;
  f[20] = S1_3;
  // f_omega1 = r1~ R1 G1 + d2~ R1 S2 + d5~ R1 S5 + N1: Kane's equation of omega [N m]
  const T b1_1 = R1_21 * G1_1 - R1_22 * minus_G1_2 + R1_23 * G1_3;
  const T b1_2 = R1_31 * G1_1 - R1_32 * minus_G1_2 + R1_33 * G1_3;
  const T f_omega1_1 = N1_1 - T(0.08) * b1_1 - T(0.02) * b1_2 + d2_2 * f_sdot2_3 - d2_3 * f_sdot2_2 + d5_2 * f_sdot5_3
      - d5_3 * f_sdot5_2;
  const T b1_3 = R1_11 * G1_1 - R1_12 * minus_G1_2 + R1_13 * G1_3;
  const T f_omega1_2 = T(0.08) * b1_3 - minus_N1_2 - T(0.05) * b1_2 + d2_3 * f_sdot2_1 - d2_1 * f_sdot2_3 + d5_3 *
      f_sdot5_1 - d5_1 * f_sdot5_3;
  const T f_omega1_3 = N1_3 + T(0.05) * b1_1 + T(0.02) * b1_3 + d2_1 * f_sdot2_2 - d2_2 * f_sdot2_1 + d5_1 * f_sdot5_2
      - d5_2 * f_sdot5_1;
  f[0] = f_omega1_1;
  f[1] = f_omega1_2;
  f[2] = f_omega1_3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 501 add, 894 multiply
template <class T>
void mass_matrix(const Prepared<T>& c, const T* x, T* A) noexcept {
  for (int i = 0; i < 1296; ++i) A[i] = T(0);

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
  A[666] = c.m_sub1;
  A[703] = c.m_sub1;
  A[740] = c.m_sub1;

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
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
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
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

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
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

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
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

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
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
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
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

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
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

  // ---- body 5 (arm) and what it carries
  // h5 = m5 r5 + m6 d6: first moment of mass carried, about the body origin, body axes [kg m]
  const T b5_1 = T(0.9) * d6_1;
  const T h5_1 = T(0.9880000000000001) + b5_1;
  const T b5_2 = T(0.9) * d6_2;
  const T h5_2 = T(0.052000000000000005) + b5_2;
  const T b5_3 = T(0.9) * d6_3;
  const T h5_3 = b5_3 - T(0.10400000000000001);
  // J5 = -m5 r5~ r5~ + I5 - m6 d6~ d6~: inertia carried, about the body origin, body axes [kg m^2]
  const T b5_4 = d6_3 * d6_3;
  const T b5_5 = d6_2 * d6_2;
  const T J5_11 = T(0.0852) + T(0.9) * (b5_4 + b5_5);
  const T minus_J5_12 = T(0.01476) + d6_2 * d6_1 * T(0.9);
  const T J5_13 = T(0.05152) - d6_3 * d6_1 * T(0.9);
  const T b5_6 = d6_1 * d6_1;
  const T J5_22 = T(0.6896) + T(0.9) * (b5_4 + b5_6);
  const T minus_J5_23 = T(0.00492) + d6_3 * d6_2 * T(0.9);
  const T J5_33 = T(0.70648) + T(0.9) * (b5_5 + b5_6);
  A[444] = J5_11;
  A[445] = -minus_J5_12;
  A[480] = -minus_J5_12;
  A[446] = J5_13;
  A[516] = J5_13;
  A[481] = J5_22;
  A[482] = -minus_J5_23;
  A[517] = -minus_J5_23;
  A[518] = J5_33;

  // ---- body 4 (payload) and what it carries
  A[333] = c.J4_11;
  A[334] = c.J4_12;
  A[369] = c.J4_12;
  A[335] = c.J4_13;
  A[405] = c.J4_13;
  A[370] = c.J4_22;
  A[371] = c.J4_23;
  A[406] = c.J4_23;
  A[407] = c.J4_33;

  // ---- body 2 (boom) and what it carries
  A[777] = c.m_sub2;
  A[814] = c.m_sub2;
  A[851] = c.m_sub2;
  // h2 = m2 r2 + m3 d3 + m4 d4: first moment of mass carried, about the body origin, body axes [kg m]
  const T b2_1 = T(1.8) * d3_1;
  const T b2_2 = c.p.m_payload * d4_1;
  const T h2_1 = T(0.105) + b2_1 + b2_2;
  const T b2_3 = T(1.8) * d3_2;
  const T b2_4 = c.p.m_payload * d4_2;
  const T h2_2 = T(0.14) + b2_3 + b2_4;
  const T b2_5 = T(1.8) * d3_3;
  const T b2_6 = c.p.m_payload * d4_3;
  const T h2_3 = T(1.575) + b2_5 + b2_6;
  // J2 = -m2 r2~ r2~ + I2 - m3 d3~ d3~ - m4 d4~ d4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b2_7 = d3_3 * d3_3;
  const T b2_8 = d3_2 * d3_2;
  const T b2_9 = d4_3 * d4_3;
  const T b2_10 = d4_2 * d4_2;
  const T J2_11 = T(1.13435) + T(1.8) * (b2_7 + b2_8) + c.p.m_payload * (b2_9 + b2_10);
  const T J2_12 = T(0.0158) - d3_2 * d3_1 * T(1.8) - d4_2 * d4_1 * c.p.m_payload;
  const T minus_J2_13 = T(0.03725) + d3_3 * d3_1 * T(1.8) + d4_3 * d4_1 * c.p.m_payload;
  const T b2_11 = d3_1 * d3_1;
  const T b2_12 = d4_1 * d4_1;
  const T J2_22 = T(1.0919) + T(1.8) * (b2_7 + b2_11) + c.p.m_payload * (b2_9 + b2_12);
  const T minus_J2_23 = T(0.093) + d3_3 * d3_2 * T(1.8) + d4_3 * d4_2 * c.p.m_payload;
  const T J2_33 = T(0.11875) + T(1.8) * (b2_8 + b2_11) + c.p.m_payload * (b2_10 + b2_12);
  A[111] = J2_11;
  A[112] = J2_12;
  A[147] = J2_12;
  A[113] = -minus_J2_13;
  A[183] = -minus_J2_13;
  A[148] = J2_22;
  A[149] = -minus_J2_23;
  A[184] = -minus_J2_23;
  A[185] = J2_33;

  // ---- body 1 (hub) and what it carries
  // h1 = m1 r1 + m_sub5 d5 + m_sub2 d2: first moment of mass carried, about the body origin, body axes [kg m]
  const T b1_1 = T(3.5) * d5_1;
  const T b1_2 = c.m_sub2 * d2_1;
  const T h1_1 = T(0.6000000000000001) + b1_1 + b1_2;
  const T b1_3 = T(3.5) * d5_2;
  const T b1_4 = c.m_sub2 * d2_2;
  const T h1_2 = b1_3 - T(0.24) + b1_4;
  const T b1_5 = T(3.5) * d5_3;
  const T b1_6 = c.m_sub2 * d2_3;
  const T h1_3 = T(0.96) + b1_5 + b1_6;
  // J1 = -m1 r1~ r1~ + I1 - m_sub5 d5~ d5~ - m_sub2 d2~ d2~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b1_7 = d5_3 * d5_3;
  const T b1_8 = d5_2 * d5_2;
  const T b1_9 = d2_3 * d2_3;
  const T b1_10 = d2_2 * d2_2;
  const T J1_11 = T(1.1816) + T(3.5) * (b1_7 + b1_8) + c.m_sub2 * (b1_9 + b1_10);
  const T J1_12 = T(0.052000000000000005) - d5_2 * d5_1 * T(3.5) - d2_2 * d2_1 * c.m_sub2;
  const T minus_J1_13 = T(0.078) + d5_3 * d5_1 * T(3.5) + d2_3 * d2_1 * c.m_sub2;
  const T b1_11 = d5_1 * d5_1;
  const T b1_12 = d2_1 * d2_1;
  const T J1_22 = T(1.0568) + T(3.5) * (b1_7 + b1_11) + c.m_sub2 * (b1_9 + b1_12);
  const T J1_23 = T(0.0692) - d5_3 * d5_2 * T(3.5) - d2_3 * d2_2 * c.m_sub2;
  const T J1_33 = T(1.3348) + T(3.5) * (b1_8 + b1_11) + c.m_sub2 * (b1_10 + b1_12);
  A[0] = J1_11;
  A[1] = J1_12;
  A[36] = J1_12;
  A[2] = -minus_J1_13;
  A[72] = -minus_J1_13;
  A[37] = J1_22;
  A[38] = J1_23;
  A[73] = J1_23;
  A[74] = J1_33;

  // ---- results
  const T t1 = C1_2_32 * h2_3 - C1_2_33 * h2_2;
  const T t2 = C1_2_22 * h2_3 - C1_2_23 * h2_2;
  const T t3 = d2_2 * t1 - d2_3 * t2;
  A[3] = -t3;
  A[108] = -t3;
  const T t4 = C1_2_33 * h2_1 - C1_2_31 * h2_3;
  const T t5 = C1_2_23 * h2_1 - C1_2_21 * h2_3;
  const T t6 = d2_2 * t4 - d2_3 * t5;
  A[4] = -t6;
  A[144] = -t6;
  const T t7 = C1_2_31 * h2_2 - C1_2_32 * h2_1;
  const T t8 = C1_2_21 * h2_2 - C1_2_22 * h2_1;
  const T t9 = d2_2 * t7 - d2_3 * t8;
  A[5] = -t9;
  A[180] = -t9;
  const T t10 = C1_3_22 * T(0.036000000000000004) + C1_3_23 * T(0.63);
  const T t11 = C1_3_32 * T(0.036000000000000004) + C1_3_33 * T(0.63);
  const T t12 = d2_3 * t10 - d2_2 * t11;
  A[6] = -t12;
  A[216] = -t12;
  const T t13 = C1_3_31 * T(0.036000000000000004) + C1_3_33 * T(0.18000000000000002);
  const T t14 = C1_3_21 * T(0.036000000000000004) + C1_3_23 * T(0.18000000000000002);
  const T t15 = d2_2 * t13 - d2_3 * t14;
  A[7] = -t15;
  A[252] = -t15;
  const T t16 = C1_3_31 * T(0.63) - C1_3_32 * T(0.18000000000000002);
  const T t17 = C1_3_21 * T(0.63) - C1_3_22 * T(0.18000000000000002);
  const T t18 = d2_2 * t16 - d2_3 * t17;
  A[8] = -t18;
  A[288] = -t18;
  const T t19 = C1_4_32 * c.h4_3 - C1_4_33 * c.h4_2;
  const T t20 = C1_4_22 * c.h4_3 - C1_4_23 * c.h4_2;
  const T t21 = d2_2 * t19 - d2_3 * t20;
  A[9] = -t21;
  A[324] = -t21;
  const T t22 = C1_4_21 * c.h4_3 + C1_4_23 * c.c4_3;
  const T t23 = C1_4_31 * c.h4_3 + C1_4_33 * c.c4_3;
  const T t24 = d2_3 * t22 - d2_2 * t23;
  A[10] = -t24;
  A[360] = -t24;
  const T t25 = C1_4_31 * c.h4_2 + C1_4_32 * c.c4_3;
  const T t26 = C1_4_21 * c.h4_2 + C1_4_22 * c.c4_3;
  const T t27 = d2_2 * t25 - d2_3 * t26;
  A[11] = -t27;
  A[396] = -t27;
  const T t28 = C1_5_32 * h5_3 - C1_5_33 * h5_2;
  const T t29 = C1_5_22 * h5_3 - C1_5_23 * h5_2;
  const T t30 = d5_2 * t28 - d5_3 * t29;
  A[12] = -t30;
  A[432] = -t30;
  const T t31 = C1_5_33 * h5_1 - C1_5_31 * h5_3;
  const T t32 = C1_5_23 * h5_1 - C1_5_21 * h5_3;
  const T t33 = d5_2 * t31 - d5_3 * t32;
  A[13] = -t33;
  A[468] = -t33;
  const T t34 = C1_5_31 * h5_2 - C1_5_32 * h5_1;
  const T t35 = C1_5_21 * h5_2 - C1_5_22 * h5_1;
  const T t36 = d5_2 * t34 - d5_3 * t35;
  A[14] = -t36;
  A[504] = -t36;
  const T t37 = C1_6_32 * T(0.06300000000000001) + C1_6_33 * T(0.045000000000000005);
  const T t38 = C1_6_22 * T(0.06300000000000001) + C1_6_23 * T(0.045000000000000005);
  const T t39 = d5_2 * t37 - d5_3 * t38;
  A[15] = -t39;
  A[540] = -t39;
  const T t40 = C1_6_33 * T(0.081) - C1_6_31 * T(0.06300000000000001);
  const T t41 = C1_6_23 * T(0.081) - C1_6_21 * T(0.06300000000000001);
  const T t42 = d5_2 * t40 - d5_3 * t41;
  A[16] = -t42;
  A[576] = -t42;
  const T t43 = C1_6_21 * T(0.045000000000000005) + C1_6_22 * T(0.081);
  const T t44 = C1_6_31 * T(0.045000000000000005) + C1_6_32 * T(0.081);
  const T t45 = d5_3 * t43 - d5_2 * t44;
  A[17] = -t45;
  A[612] = -t45;
  const T t46 = h1_2 * R1_31 - h1_3 * R1_21;
  A[18] = t46;
  A[648] = t46;
  const T t47 = h1_2 * R1_32 - h1_3 * R1_22;
  A[19] = t47;
  A[684] = t47;
  const T t48 = h1_2 * R1_33 - h1_3 * R1_23;
  A[20] = t48;
  A[720] = t48;
  A[22] = -b1_6;
  A[57] = b1_6;
  A[757] = b1_6;
  A[792] = -b1_6;
  A[23] = b1_4;
  A[93] = -b1_4;
  A[758] = -b1_4;
  A[828] = b1_4;
  const T t49 = d2_2 * C1_2_31 - d2_3 * C1_2_21;
  const T t50 = T(1.8) * t49;
  A[24] = t50;
  A[864] = t50;
  const T t51 = d2_2 * C1_2_32 - d2_3 * C1_2_22;
  const T t52 = T(1.8) * t51;
  A[25] = t52;
  A[900] = t52;
  const T t53 = d2_2 * C1_2_33 - d2_3 * C1_2_23;
  const T t54 = T(1.8) * t53;
  A[26] = t54;
  A[936] = t54;
  const T t55 = c.p.m_payload * t49;
  A[27] = t55;
  A[972] = t55;
  const T t56 = c.p.m_payload * t51;
  A[28] = t56;
  A[1008] = t56;
  const T t57 = c.p.m_payload * t53;
  A[29] = t57;
  A[1044] = t57;
  A[31] = -b1_5;
  A[66] = b1_5;
  A[1081] = b1_5;
  A[1116] = -b1_5;
  A[32] = b1_3;
  A[102] = -b1_3;
  A[1082] = -b1_3;
  A[1152] = b1_3;
  const T t58 = T(0.9) * (d5_2 * C1_5_31 - d5_3 * C1_5_21);
  A[33] = t58;
  A[1188] = t58;
  const T t59 = T(0.9) * (d5_2 * C1_5_32 - d5_3 * C1_5_22);
  A[34] = t59;
  A[1224] = t59;
  const T t60 = T(0.9) * (d5_2 * C1_5_33 - d5_3 * C1_5_23);
  A[35] = t60;
  A[1260] = t60;
  const T t61 = C1_2_12 * h2_3 - C1_2_13 * h2_2;
  const T t62 = d2_3 * t61 - d2_1 * t1;
  A[39] = -t62;
  A[109] = -t62;
  const T t63 = C1_2_13 * h2_1 - C1_2_11 * h2_3;
  const T t64 = d2_3 * t63 - d2_1 * t4;
  A[40] = -t64;
  A[145] = -t64;
  const T t65 = C1_2_11 * h2_2 - C1_2_12 * h2_1;
  const T t66 = d2_3 * t65 - d2_1 * t7;
  A[41] = -t66;
  A[181] = -t66;
  const T t67 = C1_3_12 * T(0.036000000000000004) + C1_3_13 * T(0.63);
  const T t68 = d2_1 * t11 - d2_3 * t67;
  A[42] = -t68;
  A[217] = -t68;
  const T t69 = C1_3_11 * T(0.036000000000000004) + C1_3_13 * T(0.18000000000000002);
  const T t70 = d2_3 * t69 - d2_1 * t13;
  A[43] = -t70;
  A[253] = -t70;
  const T t71 = C1_3_11 * T(0.63) - C1_3_12 * T(0.18000000000000002);
  const T t72 = d2_3 * t71 - d2_1 * t16;
  A[44] = -t72;
  A[289] = -t72;
  const T t73 = C1_4_12 * c.h4_3 - C1_4_13 * c.h4_2;
  const T t74 = d2_3 * t73 - d2_1 * t19;
  A[45] = -t74;
  A[325] = -t74;
  const T t75 = C1_4_11 * c.h4_3 + C1_4_13 * c.c4_3;
  const T t76 = d2_1 * t23 - d2_3 * t75;
  A[46] = -t76;
  A[361] = -t76;
  const T t77 = C1_4_11 * c.h4_2 + C1_4_12 * c.c4_3;
  const T t78 = d2_3 * t77 - d2_1 * t25;
  A[47] = -t78;
  A[397] = -t78;
  const T t79 = C1_5_12 * h5_3 - C1_5_13 * h5_2;
  const T t80 = d5_3 * t79 - d5_1 * t28;
  A[48] = -t80;
  A[433] = -t80;
  const T t81 = C1_5_13 * h5_1 - C1_5_11 * h5_3;
  const T t82 = d5_3 * t81 - d5_1 * t31;
  A[49] = -t82;
  A[469] = -t82;
  const T t83 = C1_5_11 * h5_2 - C1_5_12 * h5_1;
  const T t84 = d5_3 * t83 - d5_1 * t34;
  A[50] = -t84;
  A[505] = -t84;
  const T t85 = C1_6_12 * T(0.06300000000000001) + C1_6_13 * T(0.045000000000000005);
  const T t86 = d5_3 * t85 - d5_1 * t37;
  A[51] = -t86;
  A[541] = -t86;
  const T t87 = C1_6_13 * T(0.081) - C1_6_11 * T(0.06300000000000001);
  const T t88 = d5_3 * t87 - d5_1 * t40;
  A[52] = -t88;
  A[577] = -t88;
  const T t89 = C1_6_11 * T(0.045000000000000005) + C1_6_12 * T(0.081);
  const T t90 = d5_1 * t44 - d5_3 * t89;
  A[53] = -t90;
  A[613] = -t90;
  const T t91 = h1_3 * R1_11 - h1_1 * R1_31;
  A[54] = t91;
  A[649] = t91;
  const T t92 = h1_3 * R1_12 - h1_1 * R1_32;
  A[55] = t92;
  A[685] = t92;
  const T t93 = h1_3 * R1_13 - h1_1 * R1_33;
  A[56] = t93;
  A[721] = t93;
  A[59] = -b1_2;
  A[94] = b1_2;
  A[794] = b1_2;
  A[829] = -b1_2;
  const T t94 = d2_3 * C1_2_11 - d2_1 * C1_2_31;
  const T t95 = T(1.8) * t94;
  A[60] = t95;
  A[865] = t95;
  const T t96 = d2_3 * C1_2_12 - d2_1 * C1_2_32;
  const T t97 = T(1.8) * t96;
  A[61] = t97;
  A[901] = t97;
  const T t98 = d2_3 * C1_2_13 - d2_1 * C1_2_33;
  const T t99 = T(1.8) * t98;
  A[62] = t99;
  A[937] = t99;
  const T t100 = c.p.m_payload * t94;
  A[63] = t100;
  A[973] = t100;
  const T t101 = c.p.m_payload * t96;
  A[64] = t101;
  A[1009] = t101;
  const T t102 = c.p.m_payload * t98;
  A[65] = t102;
  A[1045] = t102;
  A[68] = -b1_1;
  A[103] = b1_1;
  A[1118] = b1_1;
  A[1153] = -b1_1;
  const T t103 = T(0.9) * (d5_3 * C1_5_11 - d5_1 * C1_5_31);
  A[69] = t103;
  A[1189] = t103;
  const T t104 = T(0.9) * (d5_3 * C1_5_12 - d5_1 * C1_5_32);
  A[70] = t104;
  A[1225] = t104;
  const T t105 = T(0.9) * (d5_3 * C1_5_13 - d5_1 * C1_5_33);
  A[71] = t105;
  A[1261] = t105;
  const T t106 = d2_1 * t2 - d2_2 * t61;
  A[75] = -t106;
  A[110] = -t106;
  const T t107 = d2_1 * t5 - d2_2 * t63;
  A[76] = -t107;
  A[146] = -t107;
  const T t108 = d2_1 * t8 - d2_2 * t65;
  A[77] = -t108;
  A[182] = -t108;
  const T t109 = d2_2 * t67 - d2_1 * t10;
  A[78] = -t109;
  A[218] = -t109;
  const T t110 = d2_1 * t14 - d2_2 * t69;
  A[79] = -t110;
  A[254] = -t110;
  const T t111 = d2_1 * t17 - d2_2 * t71;
  A[80] = -t111;
  A[290] = -t111;
  const T t112 = d2_1 * t20 - d2_2 * t73;
  A[81] = -t112;
  A[326] = -t112;
  const T t113 = d2_2 * t75 - d2_1 * t22;
  A[82] = -t113;
  A[362] = -t113;
  const T t114 = d2_1 * t26 - d2_2 * t77;
  A[83] = -t114;
  A[398] = -t114;
  const T t115 = d5_1 * t29 - d5_2 * t79;
  A[84] = -t115;
  A[434] = -t115;
  const T t116 = d5_1 * t32 - d5_2 * t81;
  A[85] = -t116;
  A[470] = -t116;
  const T t117 = d5_1 * t35 - d5_2 * t83;
  A[86] = -t117;
  A[506] = -t117;
  const T t118 = d5_1 * t38 - d5_2 * t85;
  A[87] = -t118;
  A[542] = -t118;
  const T t119 = d5_1 * t41 - d5_2 * t87;
  A[88] = -t119;
  A[578] = -t119;
  const T t120 = d5_2 * t89 - d5_1 * t43;
  A[89] = -t120;
  A[614] = -t120;
  const T t121 = h1_1 * R1_21 - h1_2 * R1_11;
  A[90] = t121;
  A[650] = t121;
  const T t122 = h1_1 * R1_22 - h1_2 * R1_12;
  A[91] = t122;
  A[686] = t122;
  const T t123 = h1_1 * R1_23 - h1_2 * R1_13;
  A[92] = t123;
  A[722] = t123;
  const T t124 = d2_1 * C1_2_21 - d2_2 * C1_2_11;
  const T t125 = T(1.8) * t124;
  A[96] = t125;
  A[866] = t125;
  const T t126 = d2_1 * C1_2_22 - d2_2 * C1_2_12;
  const T t127 = T(1.8) * t126;
  A[97] = t127;
  A[902] = t127;
  const T t128 = d2_1 * C1_2_23 - d2_2 * C1_2_13;
  const T t129 = T(1.8) * t128;
  A[98] = t129;
  A[938] = t129;
  const T t130 = c.p.m_payload * t124;
  A[99] = t130;
  A[974] = t130;
  const T t131 = c.p.m_payload * t126;
  A[100] = t131;
  A[1010] = t131;
  const T t132 = c.p.m_payload * t128;
  A[101] = t132;
  A[1046] = t132;
  const T t133 = T(0.9) * (d5_1 * C1_5_21 - d5_2 * C1_5_11);
  A[105] = t133;
  A[1190] = t133;
  const T t134 = T(0.9) * (d5_1 * C1_5_22 - d5_2 * C1_5_12);
  A[106] = t134;
  A[1226] = t134;
  const T t135 = T(0.9) * (d5_1 * C1_5_23 - d5_2 * C1_5_13);
  A[107] = t135;
  A[1262] = t135;
  const T t136 = C2_3_22 * T(0.036000000000000004) + C2_3_23 * T(0.63);
  const T t137 = C2_3_32 * T(0.036000000000000004) + C2_3_33 * T(0.63);
  const T t138 = d3_3 * t136 - d3_2 * t137;
  A[114] = -t138;
  A[219] = -t138;
  const T t139 = C2_3_31 * T(0.036000000000000004) + C2_3_33 * T(0.18000000000000002);
  const T t140 = C2_3_21 * T(0.036000000000000004) + C2_3_23 * T(0.18000000000000002);
  const T t141 = d3_2 * t139 - d3_3 * t140;
  A[115] = -t141;
  A[255] = -t141;
  const T t142 = C2_3_31 * T(0.63) - C2_3_32 * T(0.18000000000000002);
  const T t143 = C2_3_21 * T(0.63) - C2_3_22 * T(0.18000000000000002);
  const T t144 = d3_2 * t142 - d3_3 * t143;
  A[116] = -t144;
  A[291] = -t144;
  const T t145 = C2_4_32 * c.h4_3 - C2_4_33 * c.h4_2;
  const T t146 = C2_4_22 * c.h4_3 - C2_4_23 * c.h4_2;
  const T t147 = d4_2 * t145 - d4_3 * t146;
  A[117] = -t147;
  A[327] = -t147;
  const T t148 = C2_4_21 * c.h4_3 + C2_4_23 * c.c4_3;
  const T t149 = C2_4_31 * c.h4_3 + C2_4_33 * c.c4_3;
  const T t150 = d4_3 * t148 - d4_2 * t149;
  A[118] = -t150;
  A[363] = -t150;
  const T t151 = C2_4_31 * c.h4_2 + C2_4_32 * c.c4_3;
  const T t152 = C2_4_21 * c.h4_2 + C2_4_22 * c.c4_3;
  const T t153 = d4_2 * t151 - d4_3 * t152;
  A[119] = -t153;
  A[399] = -t153;
  const T t154 = R2_21 * h2_3 - R2_31 * h2_2;
  A[126] = -t154;
  A[651] = -t154;
  const T t155 = R2_22 * h2_3 - R2_32 * h2_2;
  A[127] = -t155;
  A[687] = -t155;
  const T t156 = R2_23 * h2_3 - R2_33 * h2_2;
  A[128] = -t156;
  A[723] = -t156;
  A[129] = -t61;
  A[759] = -t61;
  A[130] = -t2;
  A[795] = -t2;
  A[131] = -t1;
  A[831] = -t1;
  A[133] = -b2_5;
  A[168] = b2_5;
  A[868] = b2_5;
  A[903] = -b2_5;
  A[134] = b2_3;
  A[204] = -b2_3;
  A[869] = -b2_3;
  A[939] = b2_3;
  A[136] = -b2_6;
  A[171] = b2_6;
  A[976] = b2_6;
  A[1011] = -b2_6;
  A[137] = b2_4;
  A[207] = -b2_4;
  A[977] = -b2_4;
  A[1047] = b2_4;
  const T t157 = C2_3_12 * T(0.036000000000000004) + C2_3_13 * T(0.63);
  const T t158 = d3_1 * t137 - d3_3 * t157;
  A[150] = -t158;
  A[220] = -t158;
  const T t159 = C2_3_11 * T(0.036000000000000004) + C2_3_13 * T(0.18000000000000002);
  const T t160 = d3_3 * t159 - d3_1 * t139;
  A[151] = -t160;
  A[256] = -t160;
  const T t161 = C2_3_11 * T(0.63) - C2_3_12 * T(0.18000000000000002);
  const T t162 = d3_3 * t161 - d3_1 * t142;
  A[152] = -t162;
  A[292] = -t162;
  const T t163 = C2_4_12 * c.h4_3 - C2_4_13 * c.h4_2;
  const T t164 = d4_3 * t163 - d4_1 * t145;
  A[153] = -t164;
  A[328] = -t164;
  const T t165 = C2_4_11 * c.h4_3 + C2_4_13 * c.c4_3;
  const T t166 = d4_1 * t149 - d4_3 * t165;
  A[154] = -t166;
  A[364] = -t166;
  const T t167 = C2_4_11 * c.h4_2 + C2_4_12 * c.c4_3;
  const T t168 = d4_3 * t167 - d4_1 * t151;
  A[155] = -t168;
  A[400] = -t168;
  const T t169 = R2_31 * h2_1 - R2_11 * h2_3;
  A[162] = -t169;
  A[652] = -t169;
  const T t170 = R2_32 * h2_1 - R2_12 * h2_3;
  A[163] = -t170;
  A[688] = -t170;
  const T t171 = R2_33 * h2_1 - R2_13 * h2_3;
  A[164] = -t171;
  A[724] = -t171;
  A[165] = -t63;
  A[760] = -t63;
  A[166] = -t5;
  A[796] = -t5;
  A[167] = -t4;
  A[832] = -t4;
  A[170] = -b2_1;
  A[205] = b2_1;
  A[905] = b2_1;
  A[940] = -b2_1;
  A[173] = -b2_2;
  A[208] = b2_2;
  A[1013] = b2_2;
  A[1048] = -b2_2;
  const T t172 = d3_2 * t157 - d3_1 * t136;
  A[186] = -t172;
  A[221] = -t172;
  const T t173 = d3_1 * t140 - d3_2 * t159;
  A[187] = -t173;
  A[257] = -t173;
  const T t174 = d3_1 * t143 - d3_2 * t161;
  A[188] = -t174;
  A[293] = -t174;
  const T t175 = d4_1 * t146 - d4_2 * t163;
  A[189] = -t175;
  A[329] = -t175;
  const T t176 = d4_2 * t165 - d4_1 * t148;
  A[190] = -t176;
  A[365] = -t176;
  const T t177 = d4_1 * t152 - d4_2 * t167;
  A[191] = -t177;
  A[401] = -t177;
  const T t178 = R2_11 * h2_2 - R2_21 * h2_1;
  A[198] = -t178;
  A[653] = -t178;
  const T t179 = R2_12 * h2_2 - R2_22 * h2_1;
  A[199] = -t179;
  A[689] = -t179;
  const T t180 = R2_13 * h2_2 - R2_23 * h2_1;
  A[200] = -t180;
  A[725] = -t180;
  A[201] = -t65;
  A[761] = -t65;
  A[202] = -t8;
  A[797] = -t8;
  A[203] = -t7;
  A[833] = -t7;
  A[222] = T(0.43122);
  A[223] = -T(0.075);
  A[258] = -T(0.075);
  A[224] = T(0.009600000000000001);
  A[294] = T(0.009600000000000001);
  const T t181 = R3_21 * T(0.036000000000000004) + R3_31 * T(0.63);
  A[234] = t181;
  A[654] = t181;
  const T t182 = R3_22 * T(0.036000000000000004) + R3_32 * T(0.63);
  A[235] = t182;
  A[690] = t182;
  const T t183 = R3_23 * T(0.036000000000000004) + R3_33 * T(0.63);
  A[236] = t183;
  A[726] = t183;
  A[237] = t67;
  A[762] = t67;
  A[238] = t10;
  A[798] = t10;
  A[239] = t11;
  A[834] = t11;
  A[240] = t157;
  A[870] = t157;
  A[241] = t136;
  A[906] = t136;
  A[242] = t137;
  A[942] = t137;
  A[259] = T(0.10872);
  A[260] = T(0.0206);
  A[295] = T(0.0206);
  const T t184 = R3_11 * T(0.036000000000000004) + R3_31 * T(0.18000000000000002);
  A[270] = -t184;
  A[655] = -t184;
  const T t185 = R3_12 * T(0.036000000000000004) + R3_32 * T(0.18000000000000002);
  A[271] = -t185;
  A[691] = -t185;
  const T t186 = R3_13 * T(0.036000000000000004) + R3_33 * T(0.18000000000000002);
  A[272] = -t186;
  A[727] = -t186;
  A[273] = -t69;
  A[763] = -t69;
  A[274] = -t14;
  A[799] = -t14;
  A[275] = -t13;
  A[835] = -t13;
  A[276] = -t159;
  A[871] = -t159;
  A[277] = -t140;
  A[907] = -t140;
  A[278] = -t139;
  A[943] = -t139;
  A[296] = T(0.5085);
  const T t187 = R3_11 * T(0.63) - R3_21 * T(0.18000000000000002);
  A[306] = -t187;
  A[656] = -t187;
  const T t188 = R3_12 * T(0.63) - R3_22 * T(0.18000000000000002);
  A[307] = -t188;
  A[692] = -t188;
  const T t189 = R3_13 * T(0.63) - R3_23 * T(0.18000000000000002);
  A[308] = -t189;
  A[728] = -t189;
  A[309] = -t71;
  A[764] = -t71;
  A[310] = -t17;
  A[800] = -t17;
  A[311] = -t16;
  A[836] = -t16;
  A[312] = -t161;
  A[872] = -t161;
  A[313] = -t143;
  A[908] = -t143;
  A[314] = -t142;
  A[944] = -t142;
  const T t190 = R4_21 * c.h4_3 - R4_31 * c.h4_2;
  A[342] = -t190;
  A[657] = -t190;
  const T t191 = R4_22 * c.h4_3 - R4_32 * c.h4_2;
  A[343] = -t191;
  A[693] = -t191;
  const T t192 = R4_23 * c.h4_3 - R4_33 * c.h4_2;
  A[344] = -t192;
  A[729] = -t192;
  A[345] = -t73;
  A[765] = -t73;
  A[346] = -t20;
  A[801] = -t20;
  A[347] = -t19;
  A[837] = -t19;
  A[351] = -t163;
  A[981] = -t163;
  A[352] = -t146;
  A[1017] = -t146;
  A[353] = -t145;
  A[1053] = -t145;
  const T t193 = R4_11 * c.h4_3 + R4_31 * c.c4_3;
  A[378] = t193;
  A[658] = t193;
  const T t194 = R4_12 * c.h4_3 + R4_32 * c.c4_3;
  A[379] = t194;
  A[694] = t194;
  const T t195 = R4_13 * c.h4_3 + R4_33 * c.c4_3;
  A[380] = t195;
  A[730] = t195;
  A[381] = t75;
  A[766] = t75;
  A[382] = t22;
  A[802] = t22;
  A[383] = t23;
  A[838] = t23;
  A[387] = t165;
  A[982] = t165;
  A[388] = t148;
  A[1018] = t148;
  A[389] = t149;
  A[1054] = t149;
  const T t196 = R4_11 * c.h4_2 + R4_21 * c.c4_3;
  A[414] = -t196;
  A[659] = -t196;
  const T t197 = R4_12 * c.h4_2 + R4_22 * c.c4_3;
  A[415] = -t197;
  A[695] = -t197;
  const T t198 = R4_13 * c.h4_2 + R4_23 * c.c4_3;
  A[416] = -t198;
  A[731] = -t198;
  A[417] = -t77;
  A[767] = -t77;
  A[418] = -t26;
  A[803] = -t26;
  A[419] = -t25;
  A[839] = -t25;
  A[423] = -t167;
  A[983] = -t167;
  A[424] = -t152;
  A[1019] = -t152;
  A[425] = -t151;
  A[1055] = -t151;
  const T t199 = C5_6_32 * T(0.06300000000000001) + C5_6_33 * T(0.045000000000000005);
  const T t200 = C5_6_22 * T(0.06300000000000001) + C5_6_23 * T(0.045000000000000005);
  const T t201 = d6_2 * t199 - d6_3 * t200;
  A[447] = -t201;
  A[552] = -t201;
  const T t202 = C5_6_33 * T(0.081) - C5_6_31 * T(0.06300000000000001);
  const T t203 = C5_6_23 * T(0.081) - C5_6_21 * T(0.06300000000000001);
  const T t204 = d6_2 * t202 - d6_3 * t203;
  A[448] = -t204;
  A[588] = -t204;
  const T t205 = C5_6_21 * T(0.045000000000000005) + C5_6_22 * T(0.081);
  const T t206 = C5_6_31 * T(0.045000000000000005) + C5_6_32 * T(0.081);
  const T t207 = d6_3 * t205 - d6_2 * t206;
  A[449] = -t207;
  A[624] = -t207;
  const T t208 = R5_21 * h5_3 - R5_31 * h5_2;
  A[450] = -t208;
  A[660] = -t208;
  const T t209 = R5_22 * h5_3 - R5_32 * h5_2;
  A[451] = -t209;
  A[696] = -t209;
  const T t210 = R5_23 * h5_3 - R5_33 * h5_2;
  A[452] = -t210;
  A[732] = -t210;
  A[462] = -t79;
  A[1092] = -t79;
  A[463] = -t29;
  A[1128] = -t29;
  A[464] = -t28;
  A[1164] = -t28;
  A[466] = -b5_3;
  A[501] = b5_3;
  A[1201] = b5_3;
  A[1236] = -b5_3;
  A[467] = b5_2;
  A[537] = -b5_2;
  A[1202] = -b5_2;
  A[1272] = b5_2;
  const T t211 = C5_6_12 * T(0.06300000000000001) + C5_6_13 * T(0.045000000000000005);
  const T t212 = d6_3 * t211 - d6_1 * t199;
  A[483] = -t212;
  A[553] = -t212;
  const T t213 = C5_6_13 * T(0.081) - C5_6_11 * T(0.06300000000000001);
  const T t214 = d6_3 * t213 - d6_1 * t202;
  A[484] = -t214;
  A[589] = -t214;
  const T t215 = C5_6_11 * T(0.045000000000000005) + C5_6_12 * T(0.081);
  const T t216 = d6_1 * t206 - d6_3 * t215;
  A[485] = -t216;
  A[625] = -t216;
  const T t217 = R5_31 * h5_1 - R5_11 * h5_3;
  A[486] = -t217;
  A[661] = -t217;
  const T t218 = R5_32 * h5_1 - R5_12 * h5_3;
  A[487] = -t218;
  A[697] = -t218;
  const T t219 = R5_33 * h5_1 - R5_13 * h5_3;
  A[488] = -t219;
  A[733] = -t219;
  A[498] = -t81;
  A[1093] = -t81;
  A[499] = -t32;
  A[1129] = -t32;
  A[500] = -t31;
  A[1165] = -t31;
  A[503] = -b5_1;
  A[538] = b5_1;
  A[1238] = b5_1;
  A[1273] = -b5_1;
  const T t220 = d6_1 * t200 - d6_2 * t211;
  A[519] = -t220;
  A[554] = -t220;
  const T t221 = d6_1 * t203 - d6_2 * t213;
  A[520] = -t221;
  A[590] = -t221;
  const T t222 = d6_2 * t215 - d6_1 * t205;
  A[521] = -t222;
  A[626] = -t222;
  const T t223 = R5_11 * h5_2 - R5_21 * h5_1;
  A[522] = -t223;
  A[662] = -t223;
  const T t224 = R5_12 * h5_2 - R5_22 * h5_1;
  A[523] = -t224;
  A[698] = -t224;
  const T t225 = R5_13 * h5_2 - R5_23 * h5_1;
  A[524] = -t225;
  A[734] = -t225;
  A[534] = -t83;
  A[1094] = -t83;
  A[535] = -t35;
  A[1130] = -t35;
  A[536] = -t34;
  A[1166] = -t34;
  A[555] = T(0.02866);
  A[556] = T(0.00555);
  A[591] = T(0.00555);
  A[557] = -T(0.006670000000000001);
  A[627] = -T(0.006670000000000001);
  const T t226 = R6_21 * T(0.06300000000000001) + R6_31 * T(0.045000000000000005);
  A[558] = -t226;
  A[663] = -t226;
  const T t227 = R6_22 * T(0.06300000000000001) + R6_32 * T(0.045000000000000005);
  A[559] = -t227;
  A[699] = -t227;
  const T t228 = R6_23 * T(0.06300000000000001) + R6_33 * T(0.045000000000000005);
  A[560] = -t228;
  A[735] = -t228;
  A[570] = -t85;
  A[1095] = -t85;
  A[571] = -t38;
  A[1131] = -t38;
  A[572] = -t37;
  A[1167] = -t37;
  A[573] = -t211;
  A[1203] = -t211;
  A[574] = -t200;
  A[1239] = -t200;
  A[575] = -t199;
  A[1275] = -t199;
  A[592] = T(0.0297);
  A[593] = T(0.005150000000000001);
  A[628] = T(0.005150000000000001);
  const T t229 = R6_31 * T(0.081) - R6_11 * T(0.06300000000000001);
  A[594] = -t229;
  A[664] = -t229;
  const T t230 = R6_32 * T(0.081) - R6_12 * T(0.06300000000000001);
  A[595] = -t230;
  A[700] = -t230;
  const T t231 = R6_33 * T(0.081) - R6_13 * T(0.06300000000000001);
  A[596] = -t231;
  A[736] = -t231;
  A[606] = -t87;
  A[1096] = -t87;
  A[607] = -t41;
  A[1132] = -t41;
  A[608] = -t40;
  A[1168] = -t40;
  A[609] = -t213;
  A[1204] = -t213;
  A[610] = -t203;
  A[1240] = -t203;
  A[611] = -t202;
  A[1276] = -t202;
  A[629] = T(0.03654);
  const T t232 = R6_11 * T(0.045000000000000005) + R6_21 * T(0.081);
  A[630] = t232;
  A[665] = t232;
  const T t233 = R6_12 * T(0.045000000000000005) + R6_22 * T(0.081);
  A[631] = t233;
  A[701] = t233;
  const T t234 = R6_13 * T(0.045000000000000005) + R6_23 * T(0.081);
  A[632] = t234;
  A[737] = t234;
  A[642] = t89;
  A[1097] = t89;
  A[643] = t43;
  A[1133] = t43;
  A[644] = t44;
  A[1169] = t44;
  A[645] = t215;
  A[1205] = t215;
  A[646] = t205;
  A[1241] = t205;
  A[647] = t206;
  A[1277] = t206;
  const T t235 = c.m_sub2 * R1_11;
  A[669] = t235;
  A[774] = t235;
  const T t236 = c.m_sub2 * R1_21;
  A[670] = t236;
  A[810] = t236;
  const T t237 = c.m_sub2 * R1_31;
  A[671] = t237;
  A[846] = t237;
  const T t238 = T(1.8) * R2_11;
  A[672] = t238;
  A[882] = t238;
  const T t239 = T(1.8) * R2_21;
  A[673] = t239;
  A[918] = t239;
  const T t240 = T(1.8) * R2_31;
  A[674] = t240;
  A[954] = t240;
  const T t241 = c.p.m_payload * R2_11;
  A[675] = t241;
  A[990] = t241;
  const T t242 = c.p.m_payload * R2_21;
  A[676] = t242;
  A[1026] = t242;
  const T t243 = c.p.m_payload * R2_31;
  A[677] = t243;
  A[1062] = t243;
  const T t244 = T(3.5) * R1_11;
  A[678] = t244;
  A[1098] = t244;
  const T t245 = T(3.5) * R1_21;
  A[679] = t245;
  A[1134] = t245;
  const T t246 = T(3.5) * R1_31;
  A[680] = t246;
  A[1170] = t246;
  const T t247 = T(0.9) * R5_11;
  A[681] = t247;
  A[1206] = t247;
  const T t248 = T(0.9) * R5_21;
  A[682] = t248;
  A[1242] = t248;
  const T t249 = T(0.9) * R5_31;
  A[683] = t249;
  A[1278] = t249;
  const T t250 = c.m_sub2 * R1_12;
  A[705] = t250;
  A[775] = t250;
  const T t251 = c.m_sub2 * R1_22;
  A[706] = t251;
  A[811] = t251;
  const T t252 = c.m_sub2 * R1_32;
  A[707] = t252;
  A[847] = t252;
  const T t253 = T(1.8) * R2_12;
  A[708] = t253;
  A[883] = t253;
  const T t254 = T(1.8) * R2_22;
  A[709] = t254;
  A[919] = t254;
  const T t255 = T(1.8) * R2_32;
  A[710] = t255;
  A[955] = t255;
  const T t256 = c.p.m_payload * R2_12;
  A[711] = t256;
  A[991] = t256;
  const T t257 = c.p.m_payload * R2_22;
  A[712] = t257;
  A[1027] = t257;
  const T t258 = c.p.m_payload * R2_32;
  A[713] = t258;
  A[1063] = t258;
  const T t259 = T(3.5) * R1_12;
  A[714] = t259;
  A[1099] = t259;
  const T t260 = T(3.5) * R1_22;
  A[715] = t260;
  A[1135] = t260;
  const T t261 = T(3.5) * R1_32;
  A[716] = t261;
  A[1171] = t261;
  const T t262 = T(0.9) * R5_12;
  A[717] = t262;
  A[1207] = t262;
  const T t263 = T(0.9) * R5_22;
  A[718] = t263;
  A[1243] = t263;
  const T t264 = T(0.9) * R5_32;
  A[719] = t264;
  A[1279] = t264;
  const T t265 = c.m_sub2 * R1_13;
  A[741] = t265;
  A[776] = t265;
  const T t266 = c.m_sub2 * R1_23;
  A[742] = t266;
  A[812] = t266;
  const T t267 = c.m_sub2 * R1_33;
  A[743] = t267;
  A[848] = t267;
  const T t268 = T(1.8) * R2_13;
  A[744] = t268;
  A[884] = t268;
  const T t269 = T(1.8) * R2_23;
  A[745] = t269;
  A[920] = t269;
  const T t270 = T(1.8) * R2_33;
  A[746] = t270;
  A[956] = t270;
  const T t271 = c.p.m_payload * R2_13;
  A[747] = t271;
  A[992] = t271;
  const T t272 = c.p.m_payload * R2_23;
  A[748] = t272;
  A[1028] = t272;
  const T t273 = c.p.m_payload * R2_33;
  A[749] = t273;
  A[1064] = t273;
  const T t274 = T(3.5) * R1_13;
  A[750] = t274;
  A[1100] = t274;
  const T t275 = T(3.5) * R1_23;
  A[751] = t275;
  A[1136] = t275;
  const T t276 = T(3.5) * R1_33;
  A[752] = t276;
  A[1172] = t276;
  const T t277 = T(0.9) * R5_13;
  A[753] = t277;
  A[1208] = t277;
  const T t278 = T(0.9) * R5_23;
  A[754] = t278;
  A[1244] = t278;
  const T t279 = T(0.9) * R5_33;
  A[755] = t279;
  A[1280] = t279;
  const T t280 = T(1.8) * C1_2_11;
  A[780] = t280;
  A[885] = t280;
  const T t281 = T(1.8) * C1_2_12;
  A[781] = t281;
  A[921] = t281;
  const T t282 = T(1.8) * C1_2_13;
  A[782] = t282;
  A[957] = t282;
  const T t283 = c.p.m_payload * C1_2_11;
  A[783] = t283;
  A[993] = t283;
  const T t284 = c.p.m_payload * C1_2_12;
  A[784] = t284;
  A[1029] = t284;
  const T t285 = c.p.m_payload * C1_2_13;
  A[785] = t285;
  A[1065] = t285;
  const T t286 = T(1.8) * C1_2_21;
  A[816] = t286;
  A[886] = t286;
  const T t287 = T(1.8) * C1_2_22;
  A[817] = t287;
  A[922] = t287;
  const T t288 = T(1.8) * C1_2_23;
  A[818] = t288;
  A[958] = t288;
  const T t289 = c.p.m_payload * C1_2_21;
  A[819] = t289;
  A[994] = t289;
  const T t290 = c.p.m_payload * C1_2_22;
  A[820] = t290;
  A[1030] = t290;
  const T t291 = c.p.m_payload * C1_2_23;
  A[821] = t291;
  A[1066] = t291;
  const T t292 = T(1.8) * C1_2_31;
  A[852] = t292;
  A[887] = t292;
  const T t293 = T(1.8) * C1_2_32;
  A[853] = t293;
  A[923] = t293;
  const T t294 = T(1.8) * C1_2_33;
  A[854] = t294;
  A[959] = t294;
  const T t295 = c.p.m_payload * C1_2_31;
  A[855] = t295;
  A[995] = t295;
  const T t296 = c.p.m_payload * C1_2_32;
  A[856] = t296;
  A[1031] = t296;
  const T t297 = c.p.m_payload * C1_2_33;
  A[857] = t297;
  A[1067] = t297;
  A[888] = T(1.8);
  A[925] = T(1.8);
  A[962] = T(1.8);
  A[999] = c.p.m_payload;
  A[1036] = c.p.m_payload;
  A[1073] = c.p.m_payload;
  A[1110] = T(3.5);
  A[1147] = T(3.5);
  A[1184] = T(3.5);
  const T t298 = T(0.9) * C1_5_11;
  A[1113] = t298;
  A[1218] = t298;
  const T t299 = T(0.9) * C1_5_12;
  A[1114] = t299;
  A[1254] = t299;
  const T t300 = T(0.9) * C1_5_13;
  A[1115] = t300;
  A[1290] = t300;
  const T t301 = T(0.9) * C1_5_21;
  A[1149] = t301;
  A[1219] = t301;
  const T t302 = T(0.9) * C1_5_22;
  A[1150] = t302;
  A[1255] = t302;
  const T t303 = T(0.9) * C1_5_23;
  A[1151] = t303;
  A[1291] = t303;
  const T t304 = T(0.9) * C1_5_31;
  A[1185] = t304;
  A[1220] = t304;
  const T t305 = T(0.9) * C1_5_32;
  A[1186] = t305;
  A[1256] = t305;
  const T t306 = T(0.9) * C1_5_33;
  A[1187] = t306;
  A[1292] = t306;
  A[1221] = T(0.9);
  A[1258] = T(0.9);
  A[1295] = T(0.9);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 180 add, 270 multiply
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  T block[135];

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
  const T minus_B1_1_11 = R1_21 * T(0.08) + R1_31 * T(0.02);
  const T minus_B1_1_12 = R1_31 * T(0.05) - R1_11 * T(0.08);
  const T B1_1_13 = R1_11 * T(0.02) + R1_21 * T(0.05);
  const T minus_B1_1_21 = R1_22 * T(0.08) + R1_32 * T(0.02);
  const T minus_B1_1_22 = R1_32 * T(0.05) - R1_12 * T(0.08);
  const T B1_1_23 = R1_12 * T(0.02) + R1_22 * T(0.05);
  const T minus_B1_1_31 = R1_23 * T(0.08) + R1_33 * T(0.02);
  const T minus_B1_1_32 = R1_33 * T(0.05) - R1_13 * T(0.08);
  const T B1_1_33 = R1_13 * T(0.02) + R1_23 * T(0.05);
  block[0] = -minus_B1_1_11;
  block[1] = -minus_B1_1_12;
  block[2] = B1_1_13;
  block[3] = -minus_B1_1_21;
  block[4] = -minus_B1_1_22;
  block[5] = B1_1_23;
  block[6] = -minus_B1_1_31;
  block[7] = -minus_B1_1_32;
  block[8] = B1_1_33;

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
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
  // d2 = q2 + s2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
  // B3_1 = -R1^T d2~
  const T minus_B3_1_11 = R1_21 * d2_3 - R1_31 * d2_2;
  const T minus_B3_1_12 = R1_31 * d2_1 - R1_11 * d2_3;
  const T minus_B3_1_13 = R1_11 * d2_2 - R1_21 * d2_1;
  const T minus_B3_1_21 = R1_22 * d2_3 - R1_32 * d2_2;
  const T minus_B3_1_22 = R1_32 * d2_1 - R1_12 * d2_3;
  const T minus_B3_1_23 = R1_12 * d2_2 - R1_22 * d2_1;
  const T minus_B3_1_31 = R1_23 * d2_3 - R1_33 * d2_2;
  const T minus_B3_1_32 = R1_33 * d2_1 - R1_13 * d2_3;
  const T minus_B3_1_33 = R1_13 * d2_2 - R1_23 * d2_1;
  block[18] = -minus_B3_1_11;
  block[19] = -minus_B3_1_12;
  block[20] = -minus_B3_1_13;
  block[21] = -minus_B3_1_21;
  block[22] = -minus_B3_1_22;
  block[23] = -minus_B3_1_23;
  block[24] = -minus_B3_1_31;
  block[25] = -minus_B3_1_32;
  block[26] = -minus_B3_1_33;
  // B4_2 = -R2^T r2~
  const T minus_B4_2_11 = R2_21 * T(0.45) - R2_31 * T(0.04);
  const T minus_B4_2_12 = R2_31 * T(0.03) - R2_11 * T(0.45);
  const T minus_B4_2_13 = R2_11 * T(0.04) - R2_21 * T(0.03);
  const T minus_B4_2_21 = R2_22 * T(0.45) - R2_32 * T(0.04);
  const T minus_B4_2_22 = R2_32 * T(0.03) - R2_12 * T(0.45);
  const T minus_B4_2_23 = R2_12 * T(0.04) - R2_22 * T(0.03);
  const T minus_B4_2_31 = R2_23 * T(0.45) - R2_33 * T(0.04);
  const T minus_B4_2_32 = R2_33 * T(0.03) - R2_13 * T(0.45);
  const T minus_B4_2_33 = R2_13 * T(0.04) - R2_23 * T(0.03);
  block[27] = -minus_B4_2_11;
  block[28] = -minus_B4_2_12;
  block[29] = -minus_B4_2_13;
  block[30] = -minus_B4_2_21;
  block[31] = -minus_B4_2_22;
  block[32] = -minus_B4_2_23;
  block[33] = -minus_B4_2_31;
  block[34] = -minus_B4_2_32;
  block[35] = -minus_B4_2_33;

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
  // B6_2 = -R2^T d3~
  const T minus_B6_2_11 = R2_21 * d3_3 - R2_31 * d3_2;
  const T minus_B6_2_12 = R2_31 * d3_1 - R2_11 * d3_3;
  const T minus_B6_2_13 = R2_11 * d3_2 - R2_21 * d3_1;
  const T minus_B6_2_21 = R2_22 * d3_3 - R2_32 * d3_2;
  const T minus_B6_2_22 = R2_32 * d3_1 - R2_12 * d3_3;
  const T minus_B6_2_23 = R2_12 * d3_2 - R2_22 * d3_1;
  const T minus_B6_2_31 = R2_23 * d3_3 - R2_33 * d3_2;
  const T minus_B6_2_32 = R2_33 * d3_1 - R2_13 * d3_3;
  const T minus_B6_2_33 = R2_13 * d3_2 - R2_23 * d3_1;
  block[45] = -minus_B6_2_11;
  block[46] = -minus_B6_2_12;
  block[47] = -minus_B6_2_13;
  block[48] = -minus_B6_2_21;
  block[49] = -minus_B6_2_22;
  block[50] = -minus_B6_2_23;
  block[51] = -minus_B6_2_31;
  block[52] = -minus_B6_2_32;
  block[53] = -minus_B6_2_33;
  // B7_3 = -R3^T r3~
  const T B7_3_11 = R3_21 * T(0.02) + R3_31 * T(0.35);
  const T minus_B7_3_12 = R3_11 * T(0.02) + R3_31 * T(0.1);
  const T minus_B7_3_13 = R3_11 * T(0.35) - R3_21 * T(0.1);
  const T B7_3_21 = R3_22 * T(0.02) + R3_32 * T(0.35);
  const T minus_B7_3_22 = R3_12 * T(0.02) + R3_32 * T(0.1);
  const T minus_B7_3_23 = R3_12 * T(0.35) - R3_22 * T(0.1);
  const T B7_3_31 = R3_23 * T(0.02) + R3_33 * T(0.35);
  const T minus_B7_3_32 = R3_13 * T(0.02) + R3_33 * T(0.1);
  const T minus_B7_3_33 = R3_13 * T(0.35) - R3_23 * T(0.1);
  block[54] = B7_3_11;
  block[55] = -minus_B7_3_12;
  block[56] = -minus_B7_3_13;
  block[57] = B7_3_21;
  block[58] = -minus_B7_3_22;
  block[59] = -minus_B7_3_23;
  block[60] = B7_3_31;
  block[61] = -minus_B7_3_32;
  block[62] = -minus_B7_3_33;

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
  // B9_2 = -R2^T d4~
  const T minus_B9_2_11 = R2_21 * d4_3 - R2_31 * d4_2;
  const T minus_B9_2_12 = R2_31 * d4_1 - R2_11 * d4_3;
  const T minus_B9_2_13 = R2_11 * d4_2 - R2_21 * d4_1;
  const T minus_B9_2_21 = R2_22 * d4_3 - R2_32 * d4_2;
  const T minus_B9_2_22 = R2_32 * d4_1 - R2_12 * d4_3;
  const T minus_B9_2_23 = R2_12 * d4_2 - R2_22 * d4_1;
  const T minus_B9_2_31 = R2_23 * d4_3 - R2_33 * d4_2;
  const T minus_B9_2_32 = R2_33 * d4_1 - R2_13 * d4_3;
  const T minus_B9_2_33 = R2_13 * d4_2 - R2_23 * d4_1;
  block[72] = -minus_B9_2_11;
  block[73] = -minus_B9_2_12;
  block[74] = -minus_B9_2_13;
  block[75] = -minus_B9_2_21;
  block[76] = -minus_B9_2_22;
  block[77] = -minus_B9_2_23;
  block[78] = -minus_B9_2_31;
  block[79] = -minus_B9_2_32;
  block[80] = -minus_B9_2_33;
  // B10_4 = -R4^T r4~
  const T minus_B10_4_11 = R4_21 * T(0.1) - R4_31 * T(0.06);
  const T B10_4_12 = R4_11 * T(0.1) + R4_31 * T(0.03);
  const T minus_B10_4_13 = R4_11 * T(0.06) + R4_21 * T(0.03);
  const T minus_B10_4_21 = R4_22 * T(0.1) - R4_32 * T(0.06);
  const T B10_4_22 = R4_12 * T(0.1) + R4_32 * T(0.03);
  const T minus_B10_4_23 = R4_12 * T(0.06) + R4_22 * T(0.03);
  const T minus_B10_4_31 = R4_23 * T(0.1) - R4_33 * T(0.06);
  const T B10_4_32 = R4_13 * T(0.1) + R4_33 * T(0.03);
  const T minus_B10_4_33 = R4_13 * T(0.06) + R4_23 * T(0.03);
  block[81] = -minus_B10_4_11;
  block[82] = B10_4_12;
  block[83] = -minus_B10_4_13;
  block[84] = -minus_B10_4_21;
  block[85] = B10_4_22;
  block[86] = -minus_B10_4_23;
  block[87] = -minus_B10_4_31;
  block[88] = B10_4_32;
  block[89] = -minus_B10_4_33;

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
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
  block[126] = R5_11;
  block[129] = R5_12;
  block[132] = R5_13;
  block[127] = R5_21;
  block[130] = R5_22;
  block[133] = R5_23;
  block[128] = R5_31;
  block[131] = R5_32;
  block[134] = R5_33;
  // d5 = q5 + s5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
  // B11_1 = -R1^T d5~
  const T minus_B11_1_11 = R1_21 * d5_3 - R1_31 * d5_2;
  const T minus_B11_1_12 = R1_31 * d5_1 - R1_11 * d5_3;
  const T minus_B11_1_13 = R1_11 * d5_2 - R1_21 * d5_1;
  const T minus_B11_1_21 = R1_22 * d5_3 - R1_32 * d5_2;
  const T minus_B11_1_22 = R1_32 * d5_1 - R1_12 * d5_3;
  const T minus_B11_1_23 = R1_12 * d5_2 - R1_22 * d5_1;
  const T minus_B11_1_31 = R1_23 * d5_3 - R1_33 * d5_2;
  const T minus_B11_1_32 = R1_33 * d5_1 - R1_13 * d5_3;
  const T minus_B11_1_33 = R1_13 * d5_2 - R1_23 * d5_1;
  block[90] = -minus_B11_1_11;
  block[91] = -minus_B11_1_12;
  block[92] = -minus_B11_1_13;
  block[93] = -minus_B11_1_21;
  block[94] = -minus_B11_1_22;
  block[95] = -minus_B11_1_23;
  block[96] = -minus_B11_1_31;
  block[97] = -minus_B11_1_32;
  block[98] = -minus_B11_1_33;
  // B12_5 = -R5^T r5~
  const T B12_5_11 = R5_21 * T(0.04) + R5_31 * T(0.02);
  const T minus_B12_5_12 = R5_11 * T(0.04) + R5_31 * T(0.38);
  const T minus_B12_5_13 = R5_11 * T(0.02) - R5_21 * T(0.38);
  const T B12_5_21 = R5_22 * T(0.04) + R5_32 * T(0.02);
  const T minus_B12_5_22 = R5_12 * T(0.04) + R5_32 * T(0.38);
  const T minus_B12_5_23 = R5_12 * T(0.02) - R5_22 * T(0.38);
  const T B12_5_31 = R5_23 * T(0.04) + R5_33 * T(0.02);
  const T minus_B12_5_32 = R5_13 * T(0.04) + R5_33 * T(0.38);
  const T minus_B12_5_33 = R5_13 * T(0.02) - R5_23 * T(0.38);
  block[99] = B12_5_11;
  block[100] = -minus_B12_5_12;
  block[101] = -minus_B12_5_13;
  block[102] = B12_5_21;
  block[103] = -minus_B12_5_22;
  block[104] = -minus_B12_5_23;
  block[105] = B12_5_31;
  block[106] = -minus_B12_5_32;
  block[107] = -minus_B12_5_33;

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
  // B13_5 = -R5^T d6~
  const T minus_B13_5_11 = R5_21 * d6_3 - R5_31 * d6_2;
  const T minus_B13_5_12 = R5_31 * d6_1 - R5_11 * d6_3;
  const T minus_B13_5_13 = R5_11 * d6_2 - R5_21 * d6_1;
  const T minus_B13_5_21 = R5_22 * d6_3 - R5_32 * d6_2;
  const T minus_B13_5_22 = R5_32 * d6_1 - R5_12 * d6_3;
  const T minus_B13_5_23 = R5_12 * d6_2 - R5_22 * d6_1;
  const T minus_B13_5_31 = R5_23 * d6_3 - R5_33 * d6_2;
  const T minus_B13_5_32 = R5_33 * d6_1 - R5_13 * d6_3;
  const T minus_B13_5_33 = R5_13 * d6_2 - R5_23 * d6_1;
  block[108] = -minus_B13_5_11;
  block[109] = -minus_B13_5_12;
  block[110] = -minus_B13_5_13;
  block[111] = -minus_B13_5_21;
  block[112] = -minus_B13_5_22;
  block[113] = -minus_B13_5_23;
  block[114] = -minus_B13_5_31;
  block[115] = -minus_B13_5_32;
  block[116] = -minus_B13_5_33;
  // B14_6 = -R6^T r6~
  const T minus_B14_6_11 = R6_21 * T(0.07) + R6_31 * T(0.05);
  const T minus_B14_6_12 = R6_31 * T(0.09) - R6_11 * T(0.07);
  const T B14_6_13 = R6_11 * T(0.05) + R6_21 * T(0.09);
  const T minus_B14_6_21 = R6_22 * T(0.07) + R6_32 * T(0.05);
  const T minus_B14_6_22 = R6_32 * T(0.09) - R6_12 * T(0.07);
  const T B14_6_23 = R6_12 * T(0.05) + R6_22 * T(0.09);
  const T minus_B14_6_31 = R6_23 * T(0.07) + R6_33 * T(0.05);
  const T minus_B14_6_32 = R6_33 * T(0.09) - R6_13 * T(0.07);
  const T B14_6_33 = R6_13 * T(0.05) + R6_23 * T(0.09);
  block[117] = -minus_B14_6_11;
  block[118] = -minus_B14_6_12;
  block[119] = B14_6_13;
  block[120] = -minus_B14_6_21;
  block[121] = -minus_B14_6_22;
  block[122] = B14_6_23;
  block[123] = -minus_B14_6_31;
  block[124] = -minus_B14_6_32;
  block[125] = B14_6_33;

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
      {0,0}, {1,18}, {2,108}, {3,111}, {1,126}, {4,129}, {2,216}, {5,219}, {6,222}, {1,234}, {4,237}, {7,240},
      {2,324}, {8,327}, {9,333}, {1,342}, {4,345}, {7,351}, {10,432}, {11,444}, {1,450}, {4,462}, {10,540}, {12,552},
      {13,555}, {1,558}, {4,570}, {14,573},
  };
  for (int i = 0; i < 648; ++i) v_y[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y[place[1] + i * 36 + j] = block[9 * place[0] + 3 * i + j];
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 324 add, 468 multiply
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  T block[126];

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
  // B1_1 = -R1^T omega1~ r1~
  const T t1_13 = R1_31 * omega1_1 - R1_11 * omega1_3;
  const T t1_14 = R1_11 * omega1_2 - R1_21 * omega1_1;
  const T minus_B1_1_11 = t1_13 * T(0.08) + t1_14 * T(0.02);
  const T t1_15 = R1_21 * omega1_3 - R1_31 * omega1_2;
  const T minus_B1_1_12 = t1_14 * T(0.05) - t1_15 * T(0.08);
  const T B1_1_13 = t1_15 * T(0.02) + t1_13 * T(0.05);
  const T t1_16 = R1_32 * omega1_1 - R1_12 * omega1_3;
  const T t1_17 = R1_12 * omega1_2 - R1_22 * omega1_1;
  const T minus_B1_1_21 = t1_16 * T(0.08) + t1_17 * T(0.02);
  const T t1_18 = R1_22 * omega1_3 - R1_32 * omega1_2;
  const T minus_B1_1_22 = t1_17 * T(0.05) - t1_18 * T(0.08);
  const T B1_1_23 = t1_18 * T(0.02) + t1_16 * T(0.05);
  const T t1_19 = R1_33 * omega1_1 - R1_13 * omega1_3;
  const T t1_20 = R1_13 * omega1_2 - R1_23 * omega1_1;
  const T minus_B1_1_31 = t1_19 * T(0.08) + t1_20 * T(0.02);
  const T t1_21 = R1_23 * omega1_3 - R1_33 * omega1_2;
  const T minus_B1_1_32 = t1_20 * T(0.05) - t1_21 * T(0.08);
  const T B1_1_33 = t1_21 * T(0.02) + t1_19 * T(0.05);
  block[0] = -minus_B1_1_11;
  block[1] = -minus_B1_1_12;
  block[2] = B1_1_13;
  block[3] = -minus_B1_1_21;
  block[4] = -minus_B1_1_22;
  block[5] = B1_1_23;
  block[6] = -minus_B1_1_31;
  block[7] = -minus_B1_1_32;
  block[8] = B1_1_33;
  block[27] = t1_15;
  block[28] = t1_13;
  block[29] = t1_14;
  block[30] = t1_18;
  block[31] = t1_16;
  block[32] = t1_17;
  block[33] = t1_21;
  block[34] = t1_19;
  block[35] = t1_20;

  // ---- body 2 (boom) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s2_1 = x[27], s2_2 = x[28], s2_3 = x[29];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T sdot2_1 = y[21], sdot2_2 = y[22], sdot2_3 = y[23];
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
  const T d2_1 = T(0.4) + s2_1;
  const T d2_2 = T(0.1) + s2_2;
  const T d2_3 = T(0.25) + s2_3;
  // B2_1 = -R1^T omega1~ d2~ - R1^T sdot2~
  const T minus_B2_1_11 = t1_13 * d2_3 - t1_14 * d2_2 + R1_21 * sdot2_3 - R1_31 * sdot2_2;
  const T minus_B2_1_12 = t1_14 * d2_1 - t1_15 * d2_3 + R1_31 * sdot2_1 - R1_11 * sdot2_3;
  const T minus_B2_1_13 = t1_15 * d2_2 - t1_13 * d2_1 + R1_11 * sdot2_2 - R1_21 * sdot2_1;
  const T minus_B2_1_21 = t1_16 * d2_3 - t1_17 * d2_2 + R1_22 * sdot2_3 - R1_32 * sdot2_2;
  const T minus_B2_1_22 = t1_17 * d2_1 - t1_18 * d2_3 + R1_32 * sdot2_1 - R1_12 * sdot2_3;
  const T minus_B2_1_23 = t1_18 * d2_2 - t1_16 * d2_1 + R1_12 * sdot2_2 - R1_22 * sdot2_1;
  const T minus_B2_1_31 = t1_19 * d2_3 - t1_20 * d2_2 + R1_23 * sdot2_3 - R1_33 * sdot2_2;
  const T minus_B2_1_32 = t1_20 * d2_1 - t1_21 * d2_3 + R1_33 * sdot2_1 - R1_13 * sdot2_3;
  const T minus_B2_1_33 = t1_21 * d2_2 - t1_19 * d2_1 + R1_13 * sdot2_2 - R1_23 * sdot2_1;
  block[9] = -minus_B2_1_11;
  block[10] = -minus_B2_1_12;
  block[11] = -minus_B2_1_13;
  block[12] = -minus_B2_1_21;
  block[13] = -minus_B2_1_22;
  block[14] = -minus_B2_1_23;
  block[15] = -minus_B2_1_31;
  block[16] = -minus_B2_1_32;
  block[17] = -minus_B2_1_33;
  // B3_2 = -R2^T omega2~ r2~
  const T t2_13 = R2_31 * omega2_1 - R2_11 * omega2_3;
  const T t2_14 = R2_11 * omega2_2 - R2_21 * omega2_1;
  const T minus_B3_2_11 = t2_13 * T(0.45) - t2_14 * T(0.04);
  const T t2_15 = R2_21 * omega2_3 - R2_31 * omega2_2;
  const T minus_B3_2_12 = t2_14 * T(0.03) - t2_15 * T(0.45);
  const T minus_B3_2_13 = t2_15 * T(0.04) - t2_13 * T(0.03);
  const T t2_16 = R2_32 * omega2_1 - R2_12 * omega2_3;
  const T t2_17 = R2_12 * omega2_2 - R2_22 * omega2_1;
  const T minus_B3_2_21 = t2_16 * T(0.45) - t2_17 * T(0.04);
  const T t2_18 = R2_22 * omega2_3 - R2_32 * omega2_2;
  const T minus_B3_2_22 = t2_17 * T(0.03) - t2_18 * T(0.45);
  const T minus_B3_2_23 = t2_18 * T(0.04) - t2_16 * T(0.03);
  const T t2_19 = R2_33 * omega2_1 - R2_13 * omega2_3;
  const T t2_20 = R2_13 * omega2_2 - R2_23 * omega2_1;
  const T minus_B3_2_31 = t2_19 * T(0.45) - t2_20 * T(0.04);
  const T t2_21 = R2_23 * omega2_3 - R2_33 * omega2_2;
  const T minus_B3_2_32 = t2_20 * T(0.03) - t2_21 * T(0.45);
  const T minus_B3_2_33 = t2_21 * T(0.04) - t2_19 * T(0.03);
  block[18] = -minus_B3_2_11;
  block[19] = -minus_B3_2_12;
  block[20] = -minus_B3_2_13;
  block[21] = -minus_B3_2_21;
  block[22] = -minus_B3_2_22;
  block[23] = -minus_B3_2_23;
  block[24] = -minus_B3_2_31;
  block[25] = -minus_B3_2_32;
  block[26] = -minus_B3_2_33;
  block[54] = t2_15;
  block[55] = t2_13;
  block[56] = t2_14;
  block[57] = t2_18;
  block[58] = t2_16;
  block[59] = t2_17;
  block[60] = t2_21;
  block[61] = t2_19;
  block[62] = t2_20;

  // ---- body 3 (panel) on body 2
  const T eps3_1 = x[8], eps3_2 = x[9], eps3_3 = x[10], eps3_4 = x[11];
  const T s3_1 = x[30], s3_2 = x[31], s3_3 = x[32];
  const T omega3_1 = y[6], omega3_2 = y[7], omega3_3 = y[8];
  const T sdot3_1 = y[24], sdot3_2 = y[25], sdot3_3 = y[26];
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
  const T d3_1 = T(0.05) + s3_1;
  const T d3_2 = T(0.2) + s3_2;
  const T d3_3 = T(0.8) + s3_3;
  // B5_2 = -R2^T omega2~ d3~ - R2^T sdot3~
  const T minus_B5_2_11 = t2_13 * d3_3 - t2_14 * d3_2 + R2_21 * sdot3_3 - R2_31 * sdot3_2;
  const T minus_B5_2_12 = t2_14 * d3_1 - t2_15 * d3_3 + R2_31 * sdot3_1 - R2_11 * sdot3_3;
  const T minus_B5_2_13 = t2_15 * d3_2 - t2_13 * d3_1 + R2_11 * sdot3_2 - R2_21 * sdot3_1;
  const T minus_B5_2_21 = t2_16 * d3_3 - t2_17 * d3_2 + R2_22 * sdot3_3 - R2_32 * sdot3_2;
  const T minus_B5_2_22 = t2_17 * d3_1 - t2_18 * d3_3 + R2_32 * sdot3_1 - R2_12 * sdot3_3;
  const T minus_B5_2_23 = t2_18 * d3_2 - t2_16 * d3_1 + R2_12 * sdot3_2 - R2_22 * sdot3_1;
  const T minus_B5_2_31 = t2_19 * d3_3 - t2_20 * d3_2 + R2_23 * sdot3_3 - R2_33 * sdot3_2;
  const T minus_B5_2_32 = t2_20 * d3_1 - t2_21 * d3_3 + R2_33 * sdot3_1 - R2_13 * sdot3_3;
  const T minus_B5_2_33 = t2_21 * d3_2 - t2_19 * d3_1 + R2_13 * sdot3_2 - R2_23 * sdot3_1;
  block[36] = -minus_B5_2_11;
  block[37] = -minus_B5_2_12;
  block[38] = -minus_B5_2_13;
  block[39] = -minus_B5_2_21;
  block[40] = -minus_B5_2_22;
  block[41] = -minus_B5_2_23;
  block[42] = -minus_B5_2_31;
  block[43] = -minus_B5_2_32;
  block[44] = -minus_B5_2_33;
  // B6_3 = -R3^T omega3~ r3~
  const T t3_13 = R3_31 * omega3_1 - R3_11 * omega3_3;
  const T t3_14 = R3_11 * omega3_2 - R3_21 * omega3_1;
  const T B6_3_11 = t3_13 * T(0.02) + t3_14 * T(0.35);
  const T t3_15 = R3_21 * omega3_3 - R3_31 * omega3_2;
  const T minus_B6_3_12 = t3_15 * T(0.02) + t3_14 * T(0.1);
  const T minus_B6_3_13 = t3_15 * T(0.35) - t3_13 * T(0.1);
  const T t3_16 = R3_32 * omega3_1 - R3_12 * omega3_3;
  const T t3_17 = R3_12 * omega3_2 - R3_22 * omega3_1;
  const T B6_3_21 = t3_16 * T(0.02) + t3_17 * T(0.35);
  const T t3_18 = R3_22 * omega3_3 - R3_32 * omega3_2;
  const T minus_B6_3_22 = t3_18 * T(0.02) + t3_17 * T(0.1);
  const T minus_B6_3_23 = t3_18 * T(0.35) - t3_16 * T(0.1);
  const T t3_19 = R3_33 * omega3_1 - R3_13 * omega3_3;
  const T t3_20 = R3_13 * omega3_2 - R3_23 * omega3_1;
  const T B6_3_31 = t3_19 * T(0.02) + t3_20 * T(0.35);
  const T t3_21 = R3_23 * omega3_3 - R3_33 * omega3_2;
  const T minus_B6_3_32 = t3_21 * T(0.02) + t3_20 * T(0.1);
  const T minus_B6_3_33 = t3_21 * T(0.35) - t3_19 * T(0.1);
  block[45] = B6_3_11;
  block[46] = -minus_B6_3_12;
  block[47] = -minus_B6_3_13;
  block[48] = B6_3_21;
  block[49] = -minus_B6_3_22;
  block[50] = -minus_B6_3_23;
  block[51] = B6_3_31;
  block[52] = -minus_B6_3_32;
  block[53] = -minus_B6_3_33;

  // ---- body 4 (payload) on body 2
  const T eps4_1 = x[12], eps4_2 = x[13], eps4_3 = x[14], eps4_4 = x[15];
  const T s4_1 = x[33], s4_2 = x[34], s4_3 = x[35];
  const T omega4_1 = y[9], omega4_2 = y[10], omega4_3 = y[11];
  const T sdot4_1 = y[27], sdot4_2 = y[28], sdot4_3 = y[29];
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
  const T d4_1 = s4_1 - T(0.06);
  const T d4_2 = s4_2 - T(0.15);
  const T d4_3 = T(0.9) + s4_3;
  // B8_2 = -R2^T omega2~ d4~ - R2^T sdot4~
  const T minus_B8_2_11 = t2_13 * d4_3 - t2_14 * d4_2 + R2_21 * sdot4_3 - R2_31 * sdot4_2;
  const T minus_B8_2_12 = t2_14 * d4_1 - t2_15 * d4_3 + R2_31 * sdot4_1 - R2_11 * sdot4_3;
  const T minus_B8_2_13 = t2_15 * d4_2 - t2_13 * d4_1 + R2_11 * sdot4_2 - R2_21 * sdot4_1;
  const T minus_B8_2_21 = t2_16 * d4_3 - t2_17 * d4_2 + R2_22 * sdot4_3 - R2_32 * sdot4_2;
  const T minus_B8_2_22 = t2_17 * d4_1 - t2_18 * d4_3 + R2_32 * sdot4_1 - R2_12 * sdot4_3;
  const T minus_B8_2_23 = t2_18 * d4_2 - t2_16 * d4_1 + R2_12 * sdot4_2 - R2_22 * sdot4_1;
  const T minus_B8_2_31 = t2_19 * d4_3 - t2_20 * d4_2 + R2_23 * sdot4_3 - R2_33 * sdot4_2;
  const T minus_B8_2_32 = t2_20 * d4_1 - t2_21 * d4_3 + R2_33 * sdot4_1 - R2_13 * sdot4_3;
  const T minus_B8_2_33 = t2_21 * d4_2 - t2_19 * d4_1 + R2_13 * sdot4_2 - R2_23 * sdot4_1;
  block[63] = -minus_B8_2_11;
  block[64] = -minus_B8_2_12;
  block[65] = -minus_B8_2_13;
  block[66] = -minus_B8_2_21;
  block[67] = -minus_B8_2_22;
  block[68] = -minus_B8_2_23;
  block[69] = -minus_B8_2_31;
  block[70] = -minus_B8_2_32;
  block[71] = -minus_B8_2_33;
  // B9_4 = -R4^T omega4~ r4~
  const T t4_13 = R4_31 * omega4_1 - R4_11 * omega4_3;
  const T t4_14 = R4_11 * omega4_2 - R4_21 * omega4_1;
  const T minus_B9_4_11 = t4_13 * T(0.1) - t4_14 * T(0.06);
  const T t4_15 = R4_21 * omega4_3 - R4_31 * omega4_2;
  const T B9_4_12 = t4_15 * T(0.1) + t4_14 * T(0.03);
  const T minus_B9_4_13 = t4_15 * T(0.06) + t4_13 * T(0.03);
  const T t4_16 = R4_32 * omega4_1 - R4_12 * omega4_3;
  const T t4_17 = R4_12 * omega4_2 - R4_22 * omega4_1;
  const T minus_B9_4_21 = t4_16 * T(0.1) - t4_17 * T(0.06);
  const T t4_18 = R4_22 * omega4_3 - R4_32 * omega4_2;
  const T B9_4_22 = t4_18 * T(0.1) + t4_17 * T(0.03);
  const T minus_B9_4_23 = t4_18 * T(0.06) + t4_16 * T(0.03);
  const T t4_19 = R4_33 * omega4_1 - R4_13 * omega4_3;
  const T t4_20 = R4_13 * omega4_2 - R4_23 * omega4_1;
  const T minus_B9_4_31 = t4_19 * T(0.1) - t4_20 * T(0.06);
  const T t4_21 = R4_23 * omega4_3 - R4_33 * omega4_2;
  const T B9_4_32 = t4_21 * T(0.1) + t4_20 * T(0.03);
  const T minus_B9_4_33 = t4_21 * T(0.06) + t4_19 * T(0.03);
  block[72] = -minus_B9_4_11;
  block[73] = B9_4_12;
  block[74] = -minus_B9_4_13;
  block[75] = -minus_B9_4_21;
  block[76] = B9_4_22;
  block[77] = -minus_B9_4_23;
  block[78] = -minus_B9_4_31;
  block[79] = B9_4_32;
  block[80] = -minus_B9_4_33;

  // ---- body 5 (arm) on body 1
  const T eps5_1 = x[16], eps5_2 = x[17], eps5_3 = x[18], eps5_4 = x[19];
  const T s5_1 = x[36], s5_2 = x[37], s5_3 = x[38];
  const T omega5_1 = y[12], omega5_2 = y[13], omega5_3 = y[14];
  const T sdot5_1 = y[30], sdot5_2 = y[31], sdot5_3 = y[32];
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
  const T d5_1 = s5_1 - T(0.35);
  const T d5_2 = T(0.12) + s5_2;
  const T d5_3 = s5_3 - T(0.2);
  // B10_1 = -R1^T omega1~ d5~ - R1^T sdot5~
  const T minus_B10_1_11 = t1_13 * d5_3 - t1_14 * d5_2 + R1_21 * sdot5_3 - R1_31 * sdot5_2;
  const T minus_B10_1_12 = t1_14 * d5_1 - t1_15 * d5_3 + R1_31 * sdot5_1 - R1_11 * sdot5_3;
  const T minus_B10_1_13 = t1_15 * d5_2 - t1_13 * d5_1 + R1_11 * sdot5_2 - R1_21 * sdot5_1;
  const T minus_B10_1_21 = t1_16 * d5_3 - t1_17 * d5_2 + R1_22 * sdot5_3 - R1_32 * sdot5_2;
  const T minus_B10_1_22 = t1_17 * d5_1 - t1_18 * d5_3 + R1_32 * sdot5_1 - R1_12 * sdot5_3;
  const T minus_B10_1_23 = t1_18 * d5_2 - t1_16 * d5_1 + R1_12 * sdot5_2 - R1_22 * sdot5_1;
  const T minus_B10_1_31 = t1_19 * d5_3 - t1_20 * d5_2 + R1_23 * sdot5_3 - R1_33 * sdot5_2;
  const T minus_B10_1_32 = t1_20 * d5_1 - t1_21 * d5_3 + R1_33 * sdot5_1 - R1_13 * sdot5_3;
  const T minus_B10_1_33 = t1_21 * d5_2 - t1_19 * d5_1 + R1_13 * sdot5_2 - R1_23 * sdot5_1;
  block[81] = -minus_B10_1_11;
  block[82] = -minus_B10_1_12;
  block[83] = -minus_B10_1_13;
  block[84] = -minus_B10_1_21;
  block[85] = -minus_B10_1_22;
  block[86] = -minus_B10_1_23;
  block[87] = -minus_B10_1_31;
  block[88] = -minus_B10_1_32;
  block[89] = -minus_B10_1_33;
  // B11_5 = -R5^T omega5~ r5~
  const T t5_13 = R5_31 * omega5_1 - R5_11 * omega5_3;
  const T t5_14 = R5_11 * omega5_2 - R5_21 * omega5_1;
  const T B11_5_11 = t5_13 * T(0.04) + t5_14 * T(0.02);
  const T t5_15 = R5_21 * omega5_3 - R5_31 * omega5_2;
  const T minus_B11_5_12 = t5_15 * T(0.04) + t5_14 * T(0.38);
  const T minus_B11_5_13 = t5_15 * T(0.02) - t5_13 * T(0.38);
  const T t5_16 = R5_32 * omega5_1 - R5_12 * omega5_3;
  const T t5_17 = R5_12 * omega5_2 - R5_22 * omega5_1;
  const T B11_5_21 = t5_16 * T(0.04) + t5_17 * T(0.02);
  const T t5_18 = R5_22 * omega5_3 - R5_32 * omega5_2;
  const T minus_B11_5_22 = t5_18 * T(0.04) + t5_17 * T(0.38);
  const T minus_B11_5_23 = t5_18 * T(0.02) - t5_16 * T(0.38);
  const T t5_19 = R5_33 * omega5_1 - R5_13 * omega5_3;
  const T t5_20 = R5_13 * omega5_2 - R5_23 * omega5_1;
  const T B11_5_31 = t5_19 * T(0.04) + t5_20 * T(0.02);
  const T t5_21 = R5_23 * omega5_3 - R5_33 * omega5_2;
  const T minus_B11_5_32 = t5_21 * T(0.04) + t5_20 * T(0.38);
  const T minus_B11_5_33 = t5_21 * T(0.02) - t5_19 * T(0.38);
  block[90] = B11_5_11;
  block[91] = -minus_B11_5_12;
  block[92] = -minus_B11_5_13;
  block[93] = B11_5_21;
  block[94] = -minus_B11_5_22;
  block[95] = -minus_B11_5_23;
  block[96] = B11_5_31;
  block[97] = -minus_B11_5_32;
  block[98] = -minus_B11_5_33;
  block[117] = t5_15;
  block[118] = t5_13;
  block[119] = t5_14;
  block[120] = t5_18;
  block[121] = t5_16;
  block[122] = t5_17;
  block[123] = t5_21;
  block[124] = t5_19;
  block[125] = t5_20;

  // ---- body 6 (tool) on body 5
  const T eps6_1 = x[20], eps6_2 = x[21], eps6_3 = x[22], eps6_4 = x[23];
  const T s6_1 = x[39], s6_2 = x[40], s6_3 = x[41];
  const T omega6_1 = y[15], omega6_2 = y[16], omega6_3 = y[17];
  const T sdot6_1 = y[33], sdot6_2 = y[34], sdot6_3 = y[35];
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
  const T d6_1 = T(0.75) + s6_1;
  const T d6_2 = s6_2 - T(0.03);
  const T d6_3 = T(0.05) + s6_3;
  // B12_5 = -R5^T omega5~ d6~ - R5^T sdot6~
  const T minus_B12_5_11 = t5_13 * d6_3 - t5_14 * d6_2 + R5_21 * sdot6_3 - R5_31 * sdot6_2;
  const T minus_B12_5_12 = t5_14 * d6_1 - t5_15 * d6_3 + R5_31 * sdot6_1 - R5_11 * sdot6_3;
  const T minus_B12_5_13 = t5_15 * d6_2 - t5_13 * d6_1 + R5_11 * sdot6_2 - R5_21 * sdot6_1;
  const T minus_B12_5_21 = t5_16 * d6_3 - t5_17 * d6_2 + R5_22 * sdot6_3 - R5_32 * sdot6_2;
  const T minus_B12_5_22 = t5_17 * d6_1 - t5_18 * d6_3 + R5_32 * sdot6_1 - R5_12 * sdot6_3;
  const T minus_B12_5_23 = t5_18 * d6_2 - t5_16 * d6_1 + R5_12 * sdot6_2 - R5_22 * sdot6_1;
  const T minus_B12_5_31 = t5_19 * d6_3 - t5_20 * d6_2 + R5_23 * sdot6_3 - R5_33 * sdot6_2;
  const T minus_B12_5_32 = t5_20 * d6_1 - t5_21 * d6_3 + R5_33 * sdot6_1 - R5_13 * sdot6_3;
  const T minus_B12_5_33 = t5_21 * d6_2 - t5_19 * d6_1 + R5_13 * sdot6_2 - R5_23 * sdot6_1;
  block[99] = -minus_B12_5_11;
  block[100] = -minus_B12_5_12;
  block[101] = -minus_B12_5_13;
  block[102] = -minus_B12_5_21;
  block[103] = -minus_B12_5_22;
  block[104] = -minus_B12_5_23;
  block[105] = -minus_B12_5_31;
  block[106] = -minus_B12_5_32;
  block[107] = -minus_B12_5_33;
  // B13_6 = -R6^T omega6~ r6~
  const T t6_13 = R6_31 * omega6_1 - R6_11 * omega6_3;
  const T t6_14 = R6_11 * omega6_2 - R6_21 * omega6_1;
  const T minus_B13_6_11 = t6_13 * T(0.07) + t6_14 * T(0.05);
  const T t6_15 = R6_21 * omega6_3 - R6_31 * omega6_2;
  const T minus_B13_6_12 = t6_14 * T(0.09) - t6_15 * T(0.07);
  const T B13_6_13 = t6_15 * T(0.05) + t6_13 * T(0.09);
  const T t6_16 = R6_32 * omega6_1 - R6_12 * omega6_3;
  const T t6_17 = R6_12 * omega6_2 - R6_22 * omega6_1;
  const T minus_B13_6_21 = t6_16 * T(0.07) + t6_17 * T(0.05);
  const T t6_18 = R6_22 * omega6_3 - R6_32 * omega6_2;
  const T minus_B13_6_22 = t6_17 * T(0.09) - t6_18 * T(0.07);
  const T B13_6_23 = t6_18 * T(0.05) + t6_16 * T(0.09);
  const T t6_19 = R6_33 * omega6_1 - R6_13 * omega6_3;
  const T t6_20 = R6_13 * omega6_2 - R6_23 * omega6_1;
  const T minus_B13_6_31 = t6_19 * T(0.07) + t6_20 * T(0.05);
  const T t6_21 = R6_23 * omega6_3 - R6_33 * omega6_2;
  const T minus_B13_6_32 = t6_20 * T(0.09) - t6_21 * T(0.07);
  const T B13_6_33 = t6_21 * T(0.05) + t6_19 * T(0.09);
  block[108] = -minus_B13_6_11;
  block[109] = -minus_B13_6_12;
  block[110] = B13_6_13;
  block[111] = -minus_B13_6_21;
  block[112] = -minus_B13_6_22;
  block[113] = B13_6_23;
  block[114] = -minus_B13_6_31;
  block[115] = -minus_B13_6_32;
  block[116] = B13_6_33;

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,0}, {1,108}, {2,111}, {3,129}, {1,216}, {4,219}, {5,222}, {3,237}, {6,240}, {1,324}, {7,327}, {8,333},
      {3,345}, {6,351}, {9,432}, {10,444}, {3,462}, {9,540}, {11,552}, {12,555}, {3,570}, {13,573},
  };
  for (int i = 0; i < 648; ++i) v_y_dot[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y_dot[place[1] + i * 36 + j] = block[9 * place[0] + 3 * i + j];
}

}  // namespace kanec::six_body
