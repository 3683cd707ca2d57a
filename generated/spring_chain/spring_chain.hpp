// SPDX-License-Identifier: BSD-3-Clause
// spring_chain: equations of motion of 5 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 81e2b93a5b6e3b52 of spring_chain/scene.toml; the usual functions
// bodies and their joints:
//   1 mass_1 on the inertial frame: prismatic
//   2 mass_2 on 1: prismatic
//   3 mass_3 on 2: prismatic
//   4 mass_4 on 3: prismatic
//   5 mass_5 on 4: prismatic
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (s_1, s_2, s_3, s_4, s_5)
//   y = (sdot_1, sdot_2, sdot_3, sdot_4, sdot_5)
//   s         translation from the joint point, axes of the lower body [m]
//   sdot      rate of s [m/s]
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one, and of
// its own or by conversion sqrt.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              0 (0 add, 0 multiply)
//   poses                   9 (9 add, 0 multiply)
//   energy                  53 (25 add, 28 multiply, 1 square root)
//   momentum                13 (8 add, 5 multiply)
//   power                   0 (0 add, 0 multiply)
//   accelerations           35 (21 add, 13 multiply, 1 divide, 1 square root)
//   residual                40 (26 add, 13 multiply, 1 divide, 1 square root)
//   forcing                 26 (17 add, 8 multiply, 1 divide, 1 square root)
//   mass_matrix             0 (0 add, 0 multiply)
//   partial_velocities      0 (0 add, 0 multiply)
//   partial_velocity_rates  0 (0 add, 0 multiply)
#pragma once

#include <cmath>

namespace kanec::spring_chain {

inline constexpr int n_bodies = 5;
inline constexpr int nx = 5;
inline constexpr int ny = 5;
inline constexpr int n_parameters = 2;
inline constexpr int n_inputs = 0;
inline constexpr char model_hash[] = "81e2b93a5b6e3b52";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int s_1 = 0, s_2 = 1, s_3 = 2, s_4 = 3, s_5 = 4;
inline constexpr int sdot_1 = 0, sdot_2 = 1, sdot_3 = 2, sdot_4 = 3, sdot_5 = 4;
inline constexpr int s_mass_1 = 0, s_mass_2 = 1, s_mass_3 = 2, s_mass_4 = 3, s_mass_5 = 4;
inline constexpr int sdot_mass_1 = 0, sdot_mass_2 = 1, sdot_mass_3 = 2, sdot_mass_4 = 3, sdot_mass_5 = 4;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 25;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0, 1, 2, 3, 4, 0, 1, 2, 3,
    4};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T m = T(0.5);
  T k = T(50);
};

// What depends on parameters only, computed once for many calls.
template <class T>
struct Prepared {
  Parameters<T> p;
  T c1_1;
  T c0_1;
  T invD4;
  T B_sdot4_3_1;
  T m_sub3;
  T m_sub2;
  T m_sub1;
};

// prepare: 4 add, 2 multiply, 1 divide
template <class T>
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  Prepared<T> c{};
  c.p = p;
  const T c1_1 = T(0.5) * p.m;
  const T c0_1 = T(0.5) * p.k;
  const T invD4 = T(1) / p.m;
  const T B_sdot4_3_1 = p.m + p.m;
  const T m_sub3 = p.m + B_sdot4_3_1;
  const T m_sub2 = p.m + m_sub3;
  const T m_sub1 = p.m + m_sub2;
  c.c1_1 = c1_1;
  c.c0_1 = c0_1;
  c.invD4 = invD4;
  c.B_sdot4_3_1 = B_sdot4_3_1;
  c.m_sub3 = m_sub3;
  c.m_sub2 = m_sub2;
  c.m_sub1 = m_sub1;
  return c;
}

// kinematics: xdot, the kinematical equations.
// rates of x (nx) [1/s], [rad/s], [m/s]
// 0 add, 0 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* xdot) noexcept {
  const T sdot1 = y[0];
  const T sdot2 = y[1];
  const T sdot3 = y[2];
  const T sdot4 = y[3];
  const T sdot5 = y[4];
  xdot[0] = sdot1;
  xdot[1] = sdot2;
  xdot[2] = sdot3;
  xdot[3] = sdot4;
  xdot[4] = sdot5;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 9 add, 0 multiply
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  for (int i = 0; i < 60; ++i) pose[i] = T(0);

  // ---- body 1 (mass_1) on the inertial frame
  const T s1 = x[0];
  // d1 = q1 + s1 u1: joint offset q + s, axes of the lower body [m]
  const T d1_1 = T(1) + s1;
  pose[9] = d1_1;

  // ---- body 2 (mass_2) on body 1
  const T s2 = x[1];
  // d2 = q2 + s2 u2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = T(1) + s2;
  // P2 = d1 + d2: position of the body origin, inertial axes [m]
  const T P2_1 = d1_1 + d2_1;
  pose[21] = P2_1;

  // ---- body 3 (mass_3) on body 2
  const T s3 = x[2];
  // d3 = q3 + s3 u3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = T(1) + s3;
  // P3 = P2 + d3: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 + d3_1;
  pose[33] = P3_1;

  // ---- body 4 (mass_4) on body 3
  const T s4 = x[3];
  // d4 = q4 + s4 u4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = T(1) + s4;
  // P4 = P3 + d4: position of the body origin, inertial axes [m]
  const T P4_1 = P3_1 + d4_1;
  pose[45] = P4_1;

  // ---- body 5 (mass_5) on body 4
  const T s5 = x[4];
  // d5 = q5 + s5 u5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = T(1) + s5;
  // P5 = P4 + d5: position of the body origin, inertial axes [m]
  const T P5_1 = P4_1 + d5_1;
  pose[57] = P5_1;

  // ---- results
  pose[0] = T(1);
  pose[4] = T(1);
  pose[8] = T(1);
  pose[12] = T(1);
  pose[16] = T(1);
  pose[20] = T(1);
  pose[24] = T(1);
  pose[28] = T(1);
  pose[32] = T(1);
  pose[36] = T(1);
  pose[40] = T(1);
  pose[44] = T(1);
  pose[48] = T(1);
  pose[52] = T(1);
  pose[56] = T(1);
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 25 add, 28 multiply, 1 square root
template <class T>
void energy(const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  using std::sqrt;

  // ---- body 1 (mass_1) on the inertial frame
  const T s1 = x[0];
  const T sdot1 = y[0];
  // d1 = q1 + s1 u1: joint offset q + s, axes of the lower body [m]
  const T d1_1 = T(1) + s1;
  // T1 = 1/2 m1 Pdot1 . Pdot1: kinetic energy [J]
  const T T1 = sdot1 * sdot1 * c.c1_1;

  // ---- body 2 (mass_2) on body 1
  const T s2 = x[1];
  const T sdot2 = y[1];
  // d2 = q2 + s2 u2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = T(1) + s2;
  // P2 = d1 + d2: position of the body origin, inertial axes [m]
  const T P2_1 = d1_1 + d2_1;
  // Pdot2 = sdot2 u2 + Pdot1: velocity of the body origin, inertial axes [m/s]
  const T Pdot2_1 = sdot2 + sdot1;
  // T2 = 1/2 m2 Pdot2 . Pdot2: kinetic energy [J]
  const T T2 = Pdot2_1 * Pdot2_1 * c.c1_1;

  // ---- body 3 (mass_3) on body 2
  const T s3 = x[2];
  const T sdot3 = y[2];
  // d3 = q3 + s3 u3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = T(1) + s3;
  // P3 = P2 + d3: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 + d3_1;
  // Pdot3 = sdot3 u3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T Pdot3_1 = sdot3 + Pdot2_1;
  // T3 = 1/2 m3 Pdot3 . Pdot3: kinetic energy [J]
  const T T3 = Pdot3_1 * Pdot3_1 * c.c1_1;

  // ---- body 4 (mass_4) on body 3
  const T s4 = x[3];
  const T sdot4 = y[3];
  // d4 = q4 + s4 u4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = T(1) + s4;
  // P4 = P3 + d4: position of the body origin, inertial axes [m]
  const T P4_1 = P3_1 + d4_1;
  // Pdot4 = sdot4 u4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T Pdot4_1 = sdot4 + Pdot3_1;
  // T4 = 1/2 m4 Pdot4 . Pdot4: kinetic energy [J]
  const T T4 = Pdot4_1 * Pdot4_1 * c.c1_1;

  // ---- body 5 (mass_5) on body 4
  const T s5 = x[4];
  const T sdot5 = y[4];
  // d5 = q5 + s5 u5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = T(1) + s5;
  // P5 = P4 + d5: position of the body origin, inertial axes [m]
  const T P5_1 = P4_1 + d5_1;
  // Pdot5 = sdot5 u5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T Pdot5_1 = sdot5 + Pdot4_1;
  // T5 = 1/2 m5 Pdot5 . Pdot5: kinetic energy [J]
  const T T5 = Pdot5_1 * Pdot5_1 * c.c1_1;
  // line_last_spring_5 = -P5 + r_last_spring_other_: from one end of the spring to the other, inertial axes [m]
  const T line_last_spring_5_1 = T(6) - P5_1;
  // ll_last_spring_5 = 1e-36 + line_last_spring_5 . line_last_spring_5: length squared [m^2]
  const T ll_last_spring_5 = T(1e-36) + line_last_spring_5_1 * line_last_spring_5_1;
  // length_last_spring_5 = ll_last_spring_5^1/2: length [m]
  const T length_last_spring_5 = sqrt(ll_last_spring_5);
  // stretch_last_spring_5 = length_last_spring_5 - l_last_spring_: stretch of the spring
  const T stretch_last_spring_5 = length_last_spring_5 - T(1);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5;
  energy[0] = kinetic;
  // potential = 1/2 s1^2 k_mass_1_ + 1/2 s2^2 k_mass_2_ + 1/2 s3^2 k_mass_3_ + 1/2 s4^2 k_mass_4_ + 1/2 s5^2
  //   k_mass_5_ + 1/2 k_last_spring_ stretch_last_spring_5^2: potential energy of gravity and springs [J]
  const T potential = s1 * s1 * T(0.5) * c.p.k + s2 * s2 * T(0.5) * c.p.k + s3 * s3 * T(0.5) * c.p.k + s4 * s4 *
      T(0.5) * c.p.k + s5 * s5 * T(0.5) * c.p.k + stretch_last_spring_5 * stretch_last_spring_5 * c.c0_1;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 8 add, 5 multiply
template <class T>
void momentum(const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* momentum) noexcept {

  // ---- body 1 (mass_1) on the inertial frame
  const T sdot1 = y[0];
  // l1 = m1 Pdot1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = c.p.m * sdot1;

  // ---- body 2 (mass_2) on body 1
  const T sdot2 = y[1];
  // Pdot2 = sdot2 u2 + Pdot1: velocity of the body origin, inertial axes [m/s]
  const T Pdot2_1 = sdot2 + sdot1;
  // l2 = m2 Pdot2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = c.p.m * Pdot2_1;

  // ---- body 3 (mass_3) on body 2
  const T sdot3 = y[2];
  // Pdot3 = sdot3 u3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T Pdot3_1 = sdot3 + Pdot2_1;
  // l3 = m3 Pdot3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = c.p.m * Pdot3_1;

  // ---- body 4 (mass_4) on body 3
  const T sdot4 = y[3];
  // Pdot4 = sdot4 u4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T Pdot4_1 = sdot4 + Pdot3_1;
  // l4 = m4 Pdot4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = c.p.m * Pdot4_1;

  // ---- body 5 (mass_5) on body 4
  const T sdot5 = y[4];
  // Pdot5 = sdot5 u5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T Pdot5_1 = sdot5 + Pdot4_1;
  // l5 = m5 Pdot5: linear momentum, inertial axes [kg m/s]
  const T l5_1 = c.p.m * Pdot5_1;

  // ---- whole system
  // linear = l1 + l2 + l3 + l4 + l5: linear momentum of the system [kg m/s]
  const T linear_1 = l1_1 + l2_1 + l3_1 + l4_1 + l5_1;
  momentum[0] = linear_1;

  // ---- results
  momentum[1] = T(0);
  momentum[2] = T(0);
  momentum[3] = T(0);
  momentum[4] = T(0);
  momentum[5] = T(0);
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 0 add, 0 multiply
template <class T>
void power([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, [[maybe_unused]] const T* y, T* out)
    noexcept {
  out[0] = T(0);
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 21 add, 13 multiply, 1 divide, 1 square root
// by: articulated; composite would take 31 add, 27 multiply, 1 divide, 1 square root
template <class T>
void accelerations(const Prepared<T>& c, const T* x, [[maybe_unused]] const T* y, T* ydot) noexcept {
  using std::sqrt;

  // ---- body 1 (mass_1) on the inertial frame
  const T s1 = x[0];
  // d1 = q1 + s1 u1: joint offset q + s, axes of the lower body [m]
  const T d1_1 = T(1) + s1;
  // effort_mass_1_1 = -s1 k_mass_1_: along the coordinate [N m], [N]
  const T minus_effort_mass_1_1 = s1 * c.p.k;

  // ---- body 2 (mass_2) on body 1
  const T s2 = x[1];
  // d2 = q2 + s2 u2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = T(1) + s2;
  // P2 = d1 + d2: position of the body origin, inertial axes [m]
  const T P2_1 = d1_1 + d2_1;
  // effort_mass_2_2 = -s2 k_mass_2_: along the coordinate [N m], [N]
  const T minus_effort_mass_2_2 = s2 * c.p.k;

  // ---- body 3 (mass_3) on body 2
  const T s3 = x[2];
  // d3 = q3 + s3 u3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = T(1) + s3;
  // P3 = P2 + d3: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 + d3_1;
  // effort_mass_3_3 = -s3 k_mass_3_: along the coordinate [N m], [N]
  const T minus_effort_mass_3_3 = s3 * c.p.k;

  // ---- body 4 (mass_4) on body 3
  const T s4 = x[3];
  // d4 = q4 + s4 u4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = T(1) + s4;
  // P4 = P3 + d4: position of the body origin, inertial axes [m]
  const T P4_1 = P3_1 + d4_1;
  // effort_mass_4_4 = -s4 k_mass_4_: along the coordinate [N m], [N]
  const T minus_effort_mass_4_4 = s4 * c.p.k;

  // ---- body 5 (mass_5) on body 4
  const T s5 = x[4];
  // d5 = q5 + s5 u5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = T(1) + s5;
  // P5 = P4 + d5: position of the body origin, inertial axes [m]
  const T P5_1 = P4_1 + d5_1;
  // effort_mass_5_5 = -s5 k_mass_5_: along the coordinate [N m], [N]
  const T minus_effort_mass_5_5 = s5 * c.p.k;
  // line_last_spring_5 = -P5 + r_last_spring_other_: from one end of the spring to the other, inertial axes [m]
  const T line_last_spring_5_1 = T(6) - P5_1;
  // ll_last_spring_5 = 1e-36 + line_last_spring_5 . line_last_spring_5: length squared [m^2]
  const T ll_last_spring_5 = T(1e-36) + line_last_spring_5_1 * line_last_spring_5_1;
  // length_last_spring_5 = ll_last_spring_5^1/2: length [m]
  const T length_last_spring_5 = sqrt(ll_last_spring_5);
  // f_last_spring_5 = k_last_spring_ - k_last_spring_ l_last_spring_ length_last_spring_5^-1: attraction by the
  //   length [N/m]
  const T f_last_spring_5 = c.p.k - T(1) / length_last_spring_5 * c.p.k;
  // F_last_spring_5 = f_last_spring_5 line_last_spring_5: on the first end, inertial axes [N]
  const T F_last_spring_5_1 = f_last_spring_5 * line_last_spring_5_1;

  // ---- body 5 (mass_5) and what it carries
  // u_5 = u5 . F_last_spring_5 + effort_mass_5_5: drives it [N m], [N]
  const T u_5 = F_last_spring_5_1 - minus_effort_mass_5_5;
  // v5 = invD5 u_5: u/D
  const T v5 = c.invD4 * u_5;

  // ---- body 4 (mass_4) and what it carries
  // u_4 = u4 . gs5 + effort_mass_4_4: drives it [N m], [N]
  const T u_4 = minus_effort_mass_5_5 - minus_effort_mass_4_4;
  // v4 = invD4 u_4: u/D
  const T v4 = c.invD4 * u_4;

  // ---- body 3 (mass_3) and what it carries
  // u_3 = u3 . gs4 + effort_mass_3_3: drives it [N m], [N]
  const T u_3 = minus_effort_mass_4_4 - minus_effort_mass_3_3;
  // v3 = invD3 u_3: u/D
  const T v3 = c.invD4 * u_3;

  // ---- body 2 (mass_2) and what it carries
  // u_2 = u2 . gs3 + effort_mass_2_2: drives it [N m], [N]
  const T u_2 = minus_effort_mass_3_3 - minus_effort_mass_2_2;
  // v2 = invD2 u_2: u/D
  const T v2 = c.invD4 * u_2;

  // ---- body 1 (mass_1) and what it carries
  // u_1 = u1 . gs2 + effort_mass_1_1: drives it [N m], [N]
  const T u_1 = minus_effort_mass_2_2 - minus_effort_mass_1_1;
  // v1 = invD1 u_1: u/D
  const T v1 = c.invD4 * u_1;
  ydot[0] = v1;

  // ---- body 2 (mass_2), solved
  // sddot2 = -u2 . beta1 + phi2
  const T sddot2 = v2 - v1;
  ydot[1] = sddot2;

  // ---- body 3 (mass_3), solved
  // sddot3 = -u3 . beta2 + phi3
  const T sddot3 = v3 - v2;
  ydot[2] = sddot3;

  // ---- body 4 (mass_4), solved
  // sddot4 = -u4 . beta3 + phi4
  const T sddot4 = v4 - v3;
  ydot[3] = sddot4;

  // ---- body 5 (mass_5), solved
  // sddot5 = -u5 . beta4 + phi5
  const T sddot5 = v5 - v4;
  ydot[4] = sddot5;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 26 add, 13 multiply, 1 divide, 1 square root
template <class T>
void residual(const Prepared<T>& c, const T* x, [[maybe_unused]] const T* y, const T* ydot, T* r) noexcept {
  using std::sqrt;

  // ---- body 1 (mass_1) on the inertial frame
  const T s1 = x[0];
  const T sddot1 = ydot[0];
  // d1 = q1 + s1 u1: joint offset q + s, axes of the lower body [m]
  const T d1_1 = T(1) + s1;
  // effort_mass_1_1 = -s1 k_mass_1_: along the coordinate [N m], [N]
  const T minus_effort_mass_1_1 = s1 * c.p.k;
  // G1 = m1 Pddot1: inertia less applied force, inertial axes [N]
  const T G1_1 = c.p.m * sddot1;

  // ---- body 2 (mass_2) on body 1
  const T s2 = x[1];
  const T sddot2 = ydot[1];
  // d2 = q2 + s2 u2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = T(1) + s2;
  // P2 = d1 + d2: position of the body origin, inertial axes [m]
  const T P2_1 = d1_1 + d2_1;
  // Pddot2 = sddot2 u2 + Pddot1: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T Pddot2_1 = sddot2 + sddot1;
  // effort_mass_2_2 = -s2 k_mass_2_: along the coordinate [N m], [N]
  const T minus_effort_mass_2_2 = s2 * c.p.k;
  // G2 = m2 Pddot2: inertia less applied force, inertial axes [N]
  const T G2_1 = c.p.m * Pddot2_1;

  // ---- body 3 (mass_3) on body 2
  const T s3 = x[2];
  const T sddot3 = ydot[2];
  // d3 = q3 + s3 u3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = T(1) + s3;
  // P3 = P2 + d3: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 + d3_1;
  // Pddot3 = sddot3 u3 + Pddot2: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T Pddot3_1 = sddot3 + Pddot2_1;
  // effort_mass_3_3 = -s3 k_mass_3_: along the coordinate [N m], [N]
  const T minus_effort_mass_3_3 = s3 * c.p.k;
  // G3 = m3 Pddot3: inertia less applied force, inertial axes [N]
  const T G3_1 = c.p.m * Pddot3_1;

  // ---- body 4 (mass_4) on body 3
  const T s4 = x[3];
  const T sddot4 = ydot[3];
  // d4 = q4 + s4 u4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = T(1) + s4;
  // P4 = P3 + d4: position of the body origin, inertial axes [m]
  const T P4_1 = P3_1 + d4_1;
  // Pddot4 = sddot4 u4 + Pddot3: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T Pddot4_1 = sddot4 + Pddot3_1;
  // effort_mass_4_4 = -s4 k_mass_4_: along the coordinate [N m], [N]
  const T minus_effort_mass_4_4 = s4 * c.p.k;
  // G4 = m4 Pddot4: inertia less applied force, inertial axes [N]
  const T G4_1 = c.p.m * Pddot4_1;

  // ---- body 5 (mass_5) on body 4
  const T s5 = x[4];
  const T sddot5 = ydot[4];
  // d5 = q5 + s5 u5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = T(1) + s5;
  // P5 = P4 + d5: position of the body origin, inertial axes [m]
  const T P5_1 = P4_1 + d5_1;
  // Pddot5 = sddot5 u5 + Pddot4: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T Pddot5_1 = sddot5 + Pddot4_1;
  // effort_mass_5_5 = -s5 k_mass_5_: along the coordinate [N m], [N]
  const T minus_effort_mass_5_5 = s5 * c.p.k;
  // line_last_spring_5 = -P5 + r_last_spring_other_: from one end of the spring to the other, inertial axes [m]
  const T line_last_spring_5_1 = T(6) - P5_1;
  // ll_last_spring_5 = 1e-36 + line_last_spring_5 . line_last_spring_5: length squared [m^2]
  const T ll_last_spring_5 = T(1e-36) + line_last_spring_5_1 * line_last_spring_5_1;
  // length_last_spring_5 = ll_last_spring_5^1/2: length [m]
  const T length_last_spring_5 = sqrt(ll_last_spring_5);
  // f_last_spring_5 = k_last_spring_ - k_last_spring_ l_last_spring_ length_last_spring_5^-1: attraction by the
  //   length [N/m]
  const T f_last_spring_5 = c.p.k - T(1) / length_last_spring_5 * c.p.k;
  // F_last_spring_5 = f_last_spring_5 line_last_spring_5: on the first end, inertial axes [N]
  const T F_last_spring_5_1 = f_last_spring_5 * line_last_spring_5_1;
  // G5 = m5 Pddot5 - F_last_spring_5: inertia less applied force, inertial axes [N]
  const T G5_1 = c.p.m * Pddot5_1 - F_last_spring_5_1;

  // ---- body 5 (mass_5) and what it carries
  // r_sdot5 = u5 . G5 - effort_mass_5_5: Kane's equation of sdot [N]
  const T r_sdot5 = G5_1 + minus_effort_mass_5_5;
  r[4] = r_sdot5;

  // ---- body 4 (mass_4) and what it carries
  // S4 = G4 + G5: sum of the force balances of the subtree, inertial axes [N]
  const T S4_1 = G5_1 + G4_1;
  // r_sdot4 = u4 . S4 - effort_mass_4_4: Kane's equation of sdot [N]
  const T r_sdot4 = S4_1 + minus_effort_mass_4_4;
  r[3] = r_sdot4;

  // ---- body 3 (mass_3) and what it carries
  // S3 = G3 + S4: sum of the force balances of the subtree, inertial axes [N]
  const T S3_1 = S4_1 + G3_1;
  // r_sdot3 = u3 . S3 - effort_mass_3_3: Kane's equation of sdot [N]
  const T r_sdot3 = S3_1 + minus_effort_mass_3_3;
  r[2] = r_sdot3;

  // ---- body 2 (mass_2) and what it carries
  // S2 = G2 + S3: sum of the force balances of the subtree, inertial axes [N]
  const T S2_1 = S3_1 + G2_1;
  // r_sdot2 = u2 . S2 - effort_mass_2_2: Kane's equation of sdot [N]
  const T r_sdot2 = S2_1 + minus_effort_mass_2_2;
  r[1] = r_sdot2;

  // ---- body 1 (mass_1) and what it carries
  // S1 = G1 + S2: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = S2_1 + G1_1;
  // r_sdot1 = u1 . S1 - effort_mass_1_1: Kane's equation of sdot [N]
  const T r_sdot1 = S1_1 + minus_effort_mass_1_1;
  r[0] = r_sdot1;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 17 add, 8 multiply, 1 divide, 1 square root
template <class T>
void forcing(const Prepared<T>& c, const T* x, [[maybe_unused]] const T* y, T* f) noexcept {
  using std::sqrt;

  // ---- body 1 (mass_1) on the inertial frame
  const T s1 = x[0];
  // d1 = q1 + s1 u1: joint offset q + s, axes of the lower body [m]
  const T d1_1 = T(1) + s1;
  // effort_mass_1_1 = -s1 k_mass_1_: along the coordinate [N m], [N]
  const T minus_effort_mass_1_1 = s1 * c.p.k;

  // ---- body 2 (mass_2) on body 1
  const T s2 = x[1];
  // d2 = q2 + s2 u2: joint offset q + s, axes of the lower body [m]
  const T d2_1 = T(1) + s2;
  // P2 = d1 + d2: position of the body origin, inertial axes [m]
  const T P2_1 = d1_1 + d2_1;
  // effort_mass_2_2 = -s2 k_mass_2_: along the coordinate [N m], [N]
  const T minus_effort_mass_2_2 = s2 * c.p.k;

  // ---- body 3 (mass_3) on body 2
  const T s3 = x[2];
  // d3 = q3 + s3 u3: joint offset q + s, axes of the lower body [m]
  const T d3_1 = T(1) + s3;
  // P3 = P2 + d3: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 + d3_1;
  // effort_mass_3_3 = -s3 k_mass_3_: along the coordinate [N m], [N]
  const T minus_effort_mass_3_3 = s3 * c.p.k;

  // ---- body 4 (mass_4) on body 3
  const T s4 = x[3];
  // d4 = q4 + s4 u4: joint offset q + s, axes of the lower body [m]
  const T d4_1 = T(1) + s4;
  // P4 = P3 + d4: position of the body origin, inertial axes [m]
  const T P4_1 = P3_1 + d4_1;
  // effort_mass_4_4 = -s4 k_mass_4_: along the coordinate [N m], [N]
  const T minus_effort_mass_4_4 = s4 * c.p.k;

  // ---- body 5 (mass_5) on body 4
  const T s5 = x[4];
  // d5 = q5 + s5 u5: joint offset q + s, axes of the lower body [m]
  const T d5_1 = T(1) + s5;
  // P5 = P4 + d5: position of the body origin, inertial axes [m]
  const T P5_1 = P4_1 + d5_1;
  // effort_mass_5_5 = -s5 k_mass_5_: along the coordinate [N m], [N]
  const T minus_effort_mass_5_5 = s5 * c.p.k;
  // line_last_spring_5 = -P5 + r_last_spring_other_: from one end of the spring to the other, inertial axes [m]
  const T line_last_spring_5_1 = T(6) - P5_1;
  // ll_last_spring_5 = 1e-36 + line_last_spring_5 . line_last_spring_5: length squared [m^2]
  const T ll_last_spring_5 = T(1e-36) + line_last_spring_5_1 * line_last_spring_5_1;
  // length_last_spring_5 = ll_last_spring_5^1/2: length [m]
  const T length_last_spring_5 = sqrt(ll_last_spring_5);
  // f_last_spring_5 = k_last_spring_ - k_last_spring_ l_last_spring_ length_last_spring_5^-1: attraction by the
  //   length [N/m]
  const T f_last_spring_5 = c.p.k - T(1) / length_last_spring_5 * c.p.k;
  // F_last_spring_5 = f_last_spring_5 line_last_spring_5: on the first end, inertial axes [N]
  const T F_last_spring_5_1 = f_last_spring_5 * line_last_spring_5_1;

  // ---- body 5 (mass_5) and what it carries
  // f_sdot5 = u5 . F_last_spring_5 + effort_mass_5_5: Kane's equation of sdot [N]
  const T f_sdot5 = F_last_spring_5_1 - minus_effort_mass_5_5;
  f[4] = f_sdot5;

  // ---- body 4 (mass_4) and what it carries
  // f_sdot4 = u4 . F_last_spring_5 + effort_mass_4_4: Kane's equation of sdot [N]
  const T f_sdot4 = F_last_spring_5_1 - minus_effort_mass_4_4;
  f[3] = f_sdot4;

  // ---- body 3 (mass_3) and what it carries
  // f_sdot3 = u3 . F_last_spring_5 + effort_mass_3_3: Kane's equation of sdot [N]
  const T f_sdot3 = F_last_spring_5_1 - minus_effort_mass_3_3;
  f[2] = f_sdot3;

  // ---- body 2 (mass_2) and what it carries
  // f_sdot2 = u2 . F_last_spring_5 + effort_mass_2_2: Kane's equation of sdot [N]
  const T f_sdot2 = F_last_spring_5_1 - minus_effort_mass_2_2;
  f[1] = f_sdot2;

  // ---- body 1 (mass_1) and what it carries
  // f_sdot1 = u1 . F_last_spring_5 + effort_mass_1_1: Kane's equation of sdot [N]
  const T f_sdot1 = F_last_spring_5_1 - minus_effort_mass_1_1;
  f[0] = f_sdot1;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 0 add, 0 multiply
template <class T>
void mass_matrix(const Prepared<T>& c, [[maybe_unused]] const T* x, T* A) noexcept {

  // ---- body 1 (mass_1) on the inertial frame
  A[2] = c.m_sub3;
  A[7] = c.m_sub3;
  A[10] = c.m_sub3;
  A[11] = c.m_sub3;
  A[12] = c.m_sub3;
  A[1] = c.m_sub2;
  A[5] = c.m_sub2;
  A[6] = c.m_sub2;
  A[0] = c.m_sub1;
  A[3] = c.B_sdot4_3_1;
  A[8] = c.B_sdot4_3_1;
  A[13] = c.B_sdot4_3_1;
  A[15] = c.B_sdot4_3_1;
  A[16] = c.B_sdot4_3_1;
  A[17] = c.B_sdot4_3_1;
  A[18] = c.B_sdot4_3_1;

  // ---- results
  A[4] = c.p.m;
  A[9] = c.p.m;
  A[14] = c.p.m;
  A[19] = c.p.m;
  A[20] = c.p.m;
  A[21] = c.p.m;
  A[22] = c.p.m;
  A[23] = c.p.m;
  A[24] = c.p.m;
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 0 add, 0 multiply
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, T* v_y) noexcept {
  for (int i = 0; i < 75; ++i) v_y[i] = T(0);
  v_y[0] = T(1);
  v_y[15] = T(1);
  v_y[16] = T(1);
  v_y[30] = T(1);
  v_y[31] = T(1);
  v_y[32] = T(1);
  v_y[45] = T(1);
  v_y[46] = T(1);
  v_y[47] = T(1);
  v_y[48] = T(1);
  v_y[60] = T(1);
  v_y[61] = T(1);
  v_y[62] = T(1);
  v_y[63] = T(1);
  v_y[64] = T(1);
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 0 add, 0 multiply
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, [[maybe_unused]] const
    T* y, T* v_y_dot) noexcept {
  for (int i = 0; i < 75; ++i) v_y_dot[i] = T(0);
}

}  // namespace kanec::spring_chain
