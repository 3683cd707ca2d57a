// SPDX-License-Identifier: BSD-3-Clause
// slider_crank: equations of motion of 3 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model eee965b422e75ed3 of slider_crank/scene.toml; functions kinematics poses energy power accelerations residual
// mass_matrix driving_loads load_powers reactions rod_end_position pin_position
// bodies and their joints:
//   1 crank on the inertial frame: revolute
//   2 rod on 1: revolute
//   3 slider on the inertial frame: prismatic
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (theta_2, s_3)
//   y = (thetadot_2, sdot_3)
//   prescribed: theta_1 = crank_speed*t
//   theta     angle of a joint about its axis [rad]
//   s         translation from the joint point, axes of the lower body [m]
//   thetadot  rate of theta [rad/s]
//   sdot      rate of s [m/s]
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one, and of
// its own or by conversion cos, sin, tanh.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              0 (0 add, 0 multiply)
//   poses                   15 (4 add, 11 multiply, 4 sine or cosine)
//   energy                  54 (19 add, 35 multiply, 4 sine or cosine)
//   power                   38 (13 add, 24 multiply, 1 divide, 4 sine or cosine, 1 other function)
//   accelerations           53 (18 add, 34 multiply, 1 divide, 4 sine or cosine, 1 other function)
//   residual                55 (20 add, 34 multiply, 1 divide, 4 sine or cosine, 1 other function)
//   mass_matrix             0 (0 add, 0 multiply)
//   driving_loads           73 (27 add, 45 multiply, 1 divide, 4 sine or cosine)
//   load_powers             38 (13 add, 24 multiply, 1 divide, 4 sine or cosine, 1 other function)
//   reactions               83 (33 add, 49 multiply, 1 divide, 4 sine or cosine)
//   rod_end_position        13 (4 add, 9 multiply, 4 sine or cosine)
//   pin_position            0 (0 add, 0 multiply)
#pragma once

#include <cmath>

namespace kanec::slider_crank {

inline constexpr int n_bodies = 3;
inline constexpr int nx = 2;
inline constexpr int ny = 2;
inline constexpr int n_parameters = 4;
inline constexpr int n_inputs = 0;
inline constexpr char model_hash[] = "eee965b422e75ed3";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_2 = 0, s_3 = 1;
inline constexpr int thetadot_2 = 0, sdot_3 = 1;
inline constexpr int theta_rod = 0, s_slider = 1;
inline constexpr int thetadot_rod = 0, sdot_slider = 1;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 2;
inline constexpr int mass_matrix_rows[] = {0, 1};
inline constexpr int mass_matrix_columns[] = {0, 1};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T crank_speed = T(30);
  T k_pin = T(1e+05);
  T c_pin = T(20);
  T friction = T(2);
};

// What depends on parameters only, computed once for many calls.
template <class T>
struct Prepared {
  Parameters<T> p;
  T c1_1;
  T c1_2;
  T c2_1;
  T c0_1;
  T c2_2;
  T c1_3;
};

// prepare: 0 add, 9 multiply
template <class T>
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  Prepared<T> c{};
  c.p = p;
  const T c1_1 = T(2e-04) * p.crank_speed * p.crank_speed * T(0.5);
  const T c1_2 = p.crank_speed * T(0.01);
  const T c2_1 = p.crank_speed * T(0.05);
  const T c0_1 = T(0.5) * p.k_pin;
  const T t1 = p.crank_speed * p.crank_speed;
  const T c2_2 = t1 * T(0.05);
  const T c1_3 = t1 * T(0.01);
  c.c1_1 = c1_1;
  c.c1_2 = c1_2;
  c.c2_1 = c2_1;
  c.c0_1 = c0_1;
  c.c2_2 = c2_2;
  c.c1_3 = c1_3;
  return c;
}

// kinematics: xdot, the kinematical equations.
// rates of x (nx) [1/s], [rad/s], [m/s]
// 0 add, 0 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* xdot) noexcept {
  const T thetadot2 = y[0];
  const T sdot3 = y[1];
  xdot[0] = thetadot2;
  xdot[1] = sdot3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 4 add, 11 multiply, 4 sine or cosine
template <class T>
void poses(const Prepared<T>& c, T t, const T* x, T* pose) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 36; ++i) pose[i] = T(0);

  // ---- body 1 (crank) on the inertial frame
  // theta1 = expression 1: prescribed
  const T theta1 = c.p.crank_speed * t;
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  pose[0] = E1_11;
  pose[8] = E1_11;
  pose[2] = -minus_E1_13;
  pose[6] = minus_E1_13;
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T p1_1 = E1_11 * T(0.01);
  const T minus_p1_3 = minus_E1_13 * T(0.01);
  pose[9] = p1_1;
  pose[11] = -minus_p1_3;

  // ---- body 2 (rod) on body 1
  const T theta2 = x[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  pose[12] = R2_11;
  pose[20] = R2_11;
  pose[14] = -minus_R2_13;
  pose[18] = minus_R2_13;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = E1_11 * T(0.05);
  const T minus_P2_3 = minus_E1_13 * T(0.05);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = R2_11 * T(0.1) + P2_1;
  const T minus_p2_3 = minus_R2_13 * T(0.1) + minus_P2_3;
  pose[21] = p2_1;
  pose[23] = -minus_p2_3;

  // ---- results
  const T s3 = x[1];
  pose[4] = T(1);
  pose[16] = T(1);
  pose[24] = T(1);
  pose[28] = T(1);
  pose[32] = T(1);
  pose[33] = s3;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 19 add, 35 multiply, 4 sine or cosine
template <class T>
void energy(const Prepared<T>& c, T t, const T* x, const T* y, T* energy) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (crank) on the inertial frame
  // theta1 = expression 1: prescribed
  const T theta1 = c.p.crank_speed * t;
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T minus_p1_3 = minus_E1_13 * T(0.01);
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T minus_v1_1 = minus_E1_13 * c.c1_2;
  const T minus_v1_3 = E1_11 * c.c1_2;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = c.c1_1 + T(0.25) * (minus_v1_1 * minus_v1_1 + minus_v1_3 * minus_v1_3);

  // ---- body 2 (rod) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + c.p.crank_speed;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = E1_11 * T(0.05);
  const T minus_P2_3 = minus_E1_13 * T(0.05);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T minus_p2_3 = minus_R2_13 * T(0.1) + minus_P2_3;
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T minus_Pdot2_1 = minus_E1_13 * c.c2_1;
  const T minus_Pdot2_3 = E1_11 * c.c2_1;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_1 = omega2_2 * T(0.1);
  const T minus_v2_1 = minus_R2_13 * t2_1 + minus_Pdot2_1;
  const T minus_v2_3 = R2_11 * t2_1 + minus_Pdot2_3;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.001) * omega2_2 * omega2_2 * T(0.5) + T(0.15) * (minus_v2_1 * minus_v2_1 + minus_v2_3 *
      minus_v2_3);

  // ---- body 3 (slider) on the inertial frame
  const T s3 = x[1];
  const T sdot3 = y[1];
  // T3 = 1/2 m3 Pdot3 . Pdot3: kinetic energy [J]
  const T T3 = sdot3 * sdot3 * T(0.2);
  // line_joint_pin_3 = -R2^T r_joint_pin_ - P2 + d3: from one end of the spring to the other, inertial axes [m]
  const T line_joint_pin_3_1 = s3 - R2_11 * T(0.2) - P2_1;
  const T line_joint_pin_3_3 = minus_P2_3 + minus_R2_13 * T(0.2);
  // ll_joint_pin_3 = 1e-36 + line_joint_pin_3 . line_joint_pin_3: length squared [m^2]
  const T ll_joint_pin_3 = T(1e-36) + line_joint_pin_3_1 * line_joint_pin_3_1 + line_joint_pin_3_3 *
      line_joint_pin_3_3;

  // ---- whole system
  // kinetic = T1 + T2 + T3: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 d3: first moment of mass, inertial axes [kg m]
  const T minus_mp_3 = T(0.5) * minus_p1_3 + T(0.3) * minus_p2_3;
  // potential = -g . mp + 1/2 k_joint_pin_ ll_joint_pin_3: potential energy of gravity and springs [J]
  const T potential = c.c0_1 * ll_joint_pin_3 - T(9.81) * minus_mp_3;
  energy[1] = potential;
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 13 add, 24 multiply, 1 divide, 4 sine or cosine, 1 other function
template <class T>
void power(const Prepared<T>& c, T t, const T* x, const T* y, T* out) noexcept {
  using std::cos, std::sin, std::tanh;

  // ---- body 1 (crank) on the inertial frame
  // theta1 = expression 1: prescribed
  const T theta1 = c.p.crank_speed * t;
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);

  // ---- body 2 (rod) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + c.p.crank_speed;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = E1_11 * T(0.05);
  const T minus_P2_3 = minus_E1_13 * T(0.05);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T minus_Pdot2_1 = minus_E1_13 * c.c2_1;
  const T minus_Pdot2_3 = E1_11 * c.c2_1;

  // ---- body 3 (slider) on the inertial frame
  const T s3 = x[1];
  const T sdot3 = y[1];
  // line_joint_pin_3 = -R2^T r_joint_pin_ - P2 + d3: from one end of the spring to the other, inertial axes [m]
  const T line_joint_pin_3_1 = s3 - R2_11 * T(0.2) - P2_1;
  const T line_joint_pin_3_3 = minus_P2_3 + minus_R2_13 * T(0.2);
  // ll_joint_pin_3 = 1e-36 + line_joint_pin_3 . line_joint_pin_3: length squared [m^2]
  const T ll_joint_pin_3 = T(1e-36) + line_joint_pin_3_1 * line_joint_pin_3_1 + line_joint_pin_3_3 *
      line_joint_pin_3_3;
  // line_rate_joint_pin_3 = -R2^T omega2~ r_joint_pin_ - Pdot2 + Pdot3: its rate [m/s]
  const T t3_1 = omega2_2 * T(0.2);
  const T line_rate_joint_pin_3_1 = sdot3 + minus_R2_13 * t3_1 + minus_Pdot2_1;
  const T line_rate_joint_pin_3_3 = R2_11 * t3_1 + minus_Pdot2_3;
  // f_damping_joint_pin_3 = line_joint_pin_3 . line_rate_joint_pin_3 ll_joint_pin_3^-1 c_joint_pin_: attraction by
  //   the length [N/m]
  const T t3_2 = line_joint_pin_3_1 * line_rate_joint_pin_3_1 + line_joint_pin_3_3 * line_rate_joint_pin_3_3;
  const T f_damping_joint_pin_3 = T(1) / ll_joint_pin_3 * t3_2 * c.p.c_pin;

  // ---- whole system
  // power = sdot3 tau_slider_ - line_joint_pin_3 . line_rate_joint_pin_3 f_damping_joint_pin_3: power of the applied
  //   loads [W]
  const T minus_power = t3_2 * f_damping_joint_pin_3 + c.p.friction * tanh(sdot3 * T(100)) * sdot3;
  out[0] = -minus_power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 18 add, 34 multiply, 1 divide, 4 sine or cosine, 1 other function
template <class T>
void accelerations(const Prepared<T>& c, T t, const T* x, const T* y, T* ydot) noexcept {
  using std::cos, std::sin, std::tanh;

  // ---- body 1 (crank) on the inertial frame
  // theta1 = expression 1: prescribed
  const T theta1 = c.p.crank_speed * t;
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  const T Pddot1_3 = E1_11 * T(9.81);

  // ---- body 2 (rod) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + c.p.crank_speed;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = E1_11 * T(0.05);
  const T minus_P2_3 = minus_E1_13 * T(0.05);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T minus_Pdot2_1 = minus_E1_13 * c.c2_1;
  const T minus_Pdot2_3 = E1_11 * c.c2_1;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot2_3 = E2_11 * Pddot1_3 - minus_E2_13 * (c.c2_2 + minus_Pddot1_1);

  // ---- body 3 (slider) on the inertial frame
  const T s3 = x[1];
  const T sdot3 = y[1];
  // line_joint_pin_3 = -R2^T r_joint_pin_ - P2 + d3: from one end of the spring to the other, inertial axes [m]
  const T line_joint_pin_3_1 = s3 - R2_11 * T(0.2) - P2_1;
  const T line_joint_pin_3_3 = minus_P2_3 + minus_R2_13 * T(0.2);
  // ll_joint_pin_3 = 1e-36 + line_joint_pin_3 . line_joint_pin_3: length squared [m^2]
  const T ll_joint_pin_3 = T(1e-36) + line_joint_pin_3_1 * line_joint_pin_3_1 + line_joint_pin_3_3 *
      line_joint_pin_3_3;
  // line_rate_joint_pin_3 = -R2^T omega2~ r_joint_pin_ - Pdot2 + Pdot3: its rate [m/s]
  const T t3_1 = omega2_2 * T(0.2);
  const T line_rate_joint_pin_3_1 = sdot3 + minus_R2_13 * t3_1 + minus_Pdot2_1;
  const T line_rate_joint_pin_3_3 = R2_11 * t3_1 + minus_Pdot2_3;
  // f_joint_pin_3 = k_joint_pin_ + c_joint_pin_ line_joint_pin_3 . line_rate_joint_pin_3 ll_joint_pin_3^-1:
  //   attraction by the length [N/m]
  const T f_joint_pin_3 = c.p.k_pin + c.p.c_pin * (line_joint_pin_3_1 * line_rate_joint_pin_3_1 + line_joint_pin_3_3 *
      line_rate_joint_pin_3_3) * (T(1) / ll_joint_pin_3);
  // F_joint_pin_3 = f_joint_pin_3 line_joint_pin_3: on the first end, inertial axes [N]
  const T F_joint_pin_3_1 = f_joint_pin_3 * line_joint_pin_3_1;
  const T F_joint_pin_3_3 = f_joint_pin_3 * line_joint_pin_3_3;
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)) + r_joint_pin_~ R2 F_joint_pin_3: applied less
  //   inertia moment about the body origin, body axes [N m]
  const T N2_2 = T(0.03) * Pddot2_3 - T(0.2) * (minus_R2_13 * F_joint_pin_3_1 + R2_11 * F_joint_pin_3_3);

  // ---- body 3 (slider) and what it carries
  // u_3 = u3 . G3 + tau_slider_: drives it [N m], [N]
  const T minus_u_3 = F_joint_pin_3_1 + c.p.friction * tanh(sdot3 * T(100));
  // v3 = invD3 u_3: u/D
  const T minus_v3 = T(2.5) * minus_u_3;
  ydot[1] = -minus_v3;

  // ---- body 2 (rod) and what it carries
  // v2 = invD2 u_2: u/D
  const T v2 = T(249.99999999999997) * N2_2;
  ydot[0] = v2;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 20 add, 34 multiply, 1 divide, 4 sine or cosine, 1 other function
template <class T>
void residual(const Prepared<T>& c, T t, const T* x, const T* y, const T* ydot, T* r) noexcept {
  using std::cos, std::sin, std::tanh;

  // ---- body 1 (crank) on the inertial frame
  // theta1 = expression 1: prescribed
  const T theta1 = c.p.crank_speed * t;
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  const T Pddot1_3 = E1_11 * T(9.81);

  // ---- body 2 (rod) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + c.p.crank_speed;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = E1_11 * T(0.05);
  const T minus_P2_3 = minus_E1_13 * T(0.05);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T minus_Pdot2_1 = minus_E1_13 * c.c2_1;
  const T minus_Pdot2_3 = E1_11 * c.c2_1;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot2_3 = E2_11 * Pddot1_3 - minus_E2_13 * (c.c2_2 + minus_Pddot1_1);

  // ---- body 3 (slider) on the inertial frame
  const T s3 = x[1];
  const T sdot3 = y[1];
  const T thetaddot2 = ydot[0];
  const T sddot3 = ydot[1];
  // line_joint_pin_3 = -R2^T r_joint_pin_ - P2 + d3: from one end of the spring to the other, inertial axes [m]
  const T line_joint_pin_3_1 = s3 - R2_11 * T(0.2) - P2_1;
  const T line_joint_pin_3_3 = minus_P2_3 + minus_R2_13 * T(0.2);
  // ll_joint_pin_3 = 1e-36 + line_joint_pin_3 . line_joint_pin_3: length squared [m^2]
  const T ll_joint_pin_3 = T(1e-36) + line_joint_pin_3_1 * line_joint_pin_3_1 + line_joint_pin_3_3 *
      line_joint_pin_3_3;
  // line_rate_joint_pin_3 = -R2^T omega2~ r_joint_pin_ - Pdot2 + Pdot3: its rate [m/s]
  const T t3_1 = omega2_2 * T(0.2);
  const T line_rate_joint_pin_3_1 = sdot3 + minus_R2_13 * t3_1 + minus_Pdot2_1;
  const T line_rate_joint_pin_3_3 = R2_11 * t3_1 + minus_Pdot2_3;
  // f_joint_pin_3 = k_joint_pin_ + c_joint_pin_ line_joint_pin_3 . line_rate_joint_pin_3 ll_joint_pin_3^-1:
  //   attraction by the length [N/m]
  const T f_joint_pin_3 = c.p.k_pin + c.p.c_pin * (line_joint_pin_3_1 * line_rate_joint_pin_3_1 + line_joint_pin_3_3 *
      line_rate_joint_pin_3_3) * (T(1) / ll_joint_pin_3);
  // F_joint_pin_3 = f_joint_pin_3 line_joint_pin_3: on the first end, inertial axes [N]
  const T F_joint_pin_3_1 = f_joint_pin_3 * line_joint_pin_3_1;
  const T F_joint_pin_3_3 = f_joint_pin_3 * line_joint_pin_3_3;
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)) - r_joint_pin_~ R2 F_joint_pin_3: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N2_2 = T(0.004) * thetaddot2 - T(0.03) * Pddot2_3 + T(0.2) * (minus_R2_13 * F_joint_pin_3_1 + R2_11 *
      F_joint_pin_3_3);
  r[0] = N2_2;
  // G3 = m3 Pddot3 + F_joint_pin_3: inertia less applied force, inertial axes [N]
  const T G3_1 = F_joint_pin_3_1 + T(0.4) * sddot3;

  // ---- body 3 (slider) and what it carries
  // r_sdot3 = u3 . G3 - tau_slider_: Kane's equation of sdot [N]
  const T r_sdot3 = G3_1 + c.p.friction * tanh(sdot3 * T(100));
  r[1] = r_sdot3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 0 add, 0 multiply
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, T* A) noexcept {

  // ---- results
  A[0] = T(0.004);
  A[1] = T(0);
  A[2] = T(0);
  A[3] = T(0.4);
}

// driving_loads: what must act along locked and prescribed coordinates besides the joint's loads.
// one a coordinate (1) [N m], [N]
// 27 add, 45 multiply, 1 divide, 4 sine or cosine
template <class T>
void driving_loads(const Prepared<T>& c, T t, const T* x, const T* y, const T* ydot, T* drive) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (crank) on the inertial frame
  // theta1 = expression 1: prescribed
  const T theta1 = c.p.crank_speed * t;
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  const T Pddot1_3 = E1_11 * T(9.81);
  // G1 = m1 a1: inertia less applied force, body axes [N]
  const T G1_3 = T(0.5) * Pddot1_3;

  // ---- body 2 (rod) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  const T thetaddot2 = ydot[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + c.p.crank_speed;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = E1_11 * T(0.05);
  const T minus_P2_3 = minus_E1_13 * T(0.05);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T minus_Pdot2_1 = minus_E1_13 * c.c2_1;
  const T minus_Pdot2_3 = E1_11 * c.c2_1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U2_11 = omega2_2 * omega2_2;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_1 = c.c2_2 + minus_Pddot1_1;
  const T minus_Pddot2_1 = E2_11 * t2_1 + minus_E2_13 * Pddot1_3;
  const T Pddot2_3 = E2_11 * Pddot1_3 - minus_E2_13 * t2_1;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T minus_a2_1 = minus_Pddot2_1 + minus_U2_11 * T(0.1);
  const T a2_3 = Pddot2_3 - thetaddot2 * T(0.1);

  // ---- body 3 (slider) on the inertial frame
  const T s3 = x[1];
  const T sdot3 = y[1];
  // line_joint_pin_3 = -R2^T r_joint_pin_ - P2 + d3: from one end of the spring to the other, inertial axes [m]
  const T line_joint_pin_3_1 = s3 - R2_11 * T(0.2) - P2_1;
  const T line_joint_pin_3_3 = minus_P2_3 + minus_R2_13 * T(0.2);
  // ll_joint_pin_3 = 1e-36 + line_joint_pin_3 . line_joint_pin_3: length squared [m^2]
  const T ll_joint_pin_3 = T(1e-36) + line_joint_pin_3_1 * line_joint_pin_3_1 + line_joint_pin_3_3 *
      line_joint_pin_3_3;
  // line_rate_joint_pin_3 = -R2^T omega2~ r_joint_pin_ - Pdot2 + Pdot3: its rate [m/s]
  const T t3_1 = omega2_2 * T(0.2);
  const T line_rate_joint_pin_3_1 = sdot3 + minus_R2_13 * t3_1 + minus_Pdot2_1;
  const T line_rate_joint_pin_3_3 = R2_11 * t3_1 + minus_Pdot2_3;
  // f_joint_pin_3 = k_joint_pin_ + c_joint_pin_ line_joint_pin_3 . line_rate_joint_pin_3 ll_joint_pin_3^-1:
  //   attraction by the length [N/m]
  const T f_joint_pin_3 = c.p.k_pin + c.p.c_pin * (line_joint_pin_3_1 * line_rate_joint_pin_3_1 + line_joint_pin_3_3 *
      line_rate_joint_pin_3_3) * (T(1) / ll_joint_pin_3);
  // F_joint_pin_3 = f_joint_pin_3 line_joint_pin_3: on the first end, inertial axes [N]
  const T F_joint_pin_3_1 = f_joint_pin_3 * line_joint_pin_3_1;
  const T F_joint_pin_3_3 = f_joint_pin_3 * line_joint_pin_3_3;
  // G2 = -R2 F_joint_pin_3 + m2 a2: inertia less applied force, body axes [N]
  const T minus_G2_1 = T(0.3) * minus_a2_1 + R2_11 * F_joint_pin_3_1 - minus_R2_13 * F_joint_pin_3_3;
  const T t3_2 = minus_R2_13 * F_joint_pin_3_1 + R2_11 * F_joint_pin_3_3;
  const T G2_3 = T(0.3) * a2_3 - t3_2;
  // N2 = axial(U2 (tr(I2)/2 - I2)) - lever2~ R2 F_joint_pin_3: inertia less applied moment about the mass centre,
  //   body axes [N m]
  const T N2_2 = T(0.001) * thetaddot2 + T(0.1) * t3_2;

  // ---- body 2 (rod) and what it carries
  // rho2 = r2~ G2 + N2: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho2_2 = N2_2 - T(0.1) * G2_3;

  // ---- body 1 (crank) and what it carries
  // rho1 = q2~ E2^T G2 + E2^T rho2 + r1~ G1 + N1: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho1_2 = rho2_2 - T(0.05) * (minus_E2_13 * minus_G2_1 + E2_11 * G2_3) - T(0.01) * G1_3;
  drive[0] = rho1_2;
}

// load_powers: power of each load [W].
// one a load (2) [W]
// 13 add, 24 multiply, 1 divide, 4 sine or cosine, 1 other function
template <class T>
void load_powers(const Prepared<T>& c, T t, const T* x, const T* y, T* power) noexcept {
  using std::cos, std::sin, std::tanh;

  // ---- body 1 (crank) on the inertial frame
  const T sdot3 = y[1];
  // theta1 = expression 1: prescribed
  const T theta1 = c.p.crank_speed * t;
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // W1_ = sdot3 tau_slider_
  const T minus_W1 = c.p.friction * tanh(sdot3 * T(100)) * sdot3;
  power[0] = -minus_W1;

  // ---- body 2 (rod) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + c.p.crank_speed;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = E1_11 * T(0.05);
  const T minus_P2_3 = minus_E1_13 * T(0.05);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T minus_Pdot2_1 = minus_E1_13 * c.c2_1;
  const T minus_Pdot2_3 = E1_11 * c.c2_1;

  // ---- body 3 (slider) on the inertial frame
  const T s3 = x[1];
  // line_joint_pin_3 = -R2^T r_joint_pin_ - P2 + d3: from one end of the spring to the other, inertial axes [m]
  const T line_joint_pin_3_1 = s3 - R2_11 * T(0.2) - P2_1;
  const T line_joint_pin_3_3 = minus_P2_3 + minus_R2_13 * T(0.2);
  // ll_joint_pin_3 = 1e-36 + line_joint_pin_3 . line_joint_pin_3: length squared [m^2]
  const T ll_joint_pin_3 = T(1e-36) + line_joint_pin_3_1 * line_joint_pin_3_1 + line_joint_pin_3_3 *
      line_joint_pin_3_3;
  // line_rate_joint_pin_3 = -R2^T omega2~ r_joint_pin_ - Pdot2 + Pdot3: its rate [m/s]
  const T t3_1 = omega2_2 * T(0.2);
  const T line_rate_joint_pin_3_1 = sdot3 + minus_R2_13 * t3_1 + minus_Pdot2_1;
  const T line_rate_joint_pin_3_3 = R2_11 * t3_1 + minus_Pdot2_3;
  // f_joint_pin_3 = k_joint_pin_ + line_joint_pin_3 . line_rate_joint_pin_3 ll_joint_pin_3^-1 c_joint_pin_:
  //   attraction by the length [N/m]
  const T t3_2 = line_joint_pin_3_1 * line_rate_joint_pin_3_1 + line_joint_pin_3_3 * line_rate_joint_pin_3_3;
  const T f_joint_pin_3 = c.p.k_pin + T(1) / ll_joint_pin_3 * t3_2 * c.p.c_pin;

  // ---- whole system
  // W2_ = -line_joint_pin_3 . line_rate_joint_pin_3 f_joint_pin_3
  const T minus_W2 = t3_2 * f_joint_pin_3;
  power[1] = -minus_W2;
}

// reactions: force and moment on each body through its joint, about its origin, body axes.
// force (3) [N] and moment (3) [N m] of body 1, of body 2, ... (n_bodies * 6)
// 33 add, 49 multiply, 1 divide, 4 sine or cosine
template <class T>
void reactions(const Prepared<T>& c, T t, const T* x, const T* y, const T* ydot, T* reaction) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 18; ++i) reaction[i] = T(0);

  // ---- body 1 (crank) on the inertial frame
  // theta1 = expression 1: prescribed
  const T theta1 = c.p.crank_speed * t;
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  const T Pddot1_3 = E1_11 * T(9.81);
  // a1 = U1 r1 + Pddot1: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T minus_a1_1 = c.c1_3 + minus_Pddot1_1;
  // G1 = m1 a1: inertia less applied force, body axes [N]
  const T minus_G1_1 = T(0.5) * minus_a1_1;
  const T G1_3 = T(0.5) * Pddot1_3;

  // ---- body 2 (rod) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  const T thetaddot2 = ydot[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + c.p.crank_speed;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = E1_11 * T(0.05);
  const T minus_P2_3 = minus_E1_13 * T(0.05);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T minus_Pdot2_1 = minus_E1_13 * c.c2_1;
  const T minus_Pdot2_3 = E1_11 * c.c2_1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U2_11 = omega2_2 * omega2_2;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_1 = c.c2_2 + minus_Pddot1_1;
  const T minus_Pddot2_1 = E2_11 * t2_1 + minus_E2_13 * Pddot1_3;
  const T Pddot2_3 = E2_11 * Pddot1_3 - minus_E2_13 * t2_1;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T minus_a2_1 = minus_Pddot2_1 + minus_U2_11 * T(0.1);
  const T a2_3 = Pddot2_3 - thetaddot2 * T(0.1);

  // ---- body 3 (slider) on the inertial frame
  const T s3 = x[1];
  const T sdot3 = y[1];
  const T sddot3 = ydot[1];
  // line_joint_pin_3 = -R2^T r_joint_pin_ - P2 + d3: from one end of the spring to the other, inertial axes [m]
  const T line_joint_pin_3_1 = s3 - R2_11 * T(0.2) - P2_1;
  const T line_joint_pin_3_3 = minus_P2_3 + minus_R2_13 * T(0.2);
  // ll_joint_pin_3 = 1e-36 + line_joint_pin_3 . line_joint_pin_3: length squared [m^2]
  const T ll_joint_pin_3 = T(1e-36) + line_joint_pin_3_1 * line_joint_pin_3_1 + line_joint_pin_3_3 *
      line_joint_pin_3_3;
  // line_rate_joint_pin_3 = -R2^T omega2~ r_joint_pin_ - Pdot2 + Pdot3: its rate [m/s]
  const T t3_1 = omega2_2 * T(0.2);
  const T line_rate_joint_pin_3_1 = sdot3 + minus_R2_13 * t3_1 + minus_Pdot2_1;
  const T line_rate_joint_pin_3_3 = R2_11 * t3_1 + minus_Pdot2_3;
  // f_joint_pin_3 = k_joint_pin_ + c_joint_pin_ line_joint_pin_3 . line_rate_joint_pin_3 ll_joint_pin_3^-1:
  //   attraction by the length [N/m]
  const T f_joint_pin_3 = c.p.k_pin + c.p.c_pin * (line_joint_pin_3_1 * line_rate_joint_pin_3_1 + line_joint_pin_3_3 *
      line_rate_joint_pin_3_3) * (T(1) / ll_joint_pin_3);
  // F_joint_pin_3 = f_joint_pin_3 line_joint_pin_3: on the first end, inertial axes [N]
  const T F_joint_pin_3_1 = f_joint_pin_3 * line_joint_pin_3_1;
  const T F_joint_pin_3_3 = f_joint_pin_3 * line_joint_pin_3_3;
  // G2 = -R2 F_joint_pin_3 + m2 a2: inertia less applied force, body axes [N]
  const T minus_G2_1 = T(0.3) * minus_a2_1 + R2_11 * F_joint_pin_3_1 - minus_R2_13 * F_joint_pin_3_3;
  const T t3_2 = minus_R2_13 * F_joint_pin_3_1 + R2_11 * F_joint_pin_3_3;
  const T G2_3 = T(0.3) * a2_3 - t3_2;
  reaction[6] = -minus_G2_1;
  reaction[8] = G2_3;
  // N2 = axial(U2 (tr(I2)/2 - I2)) - lever2~ R2 F_joint_pin_3: inertia less applied moment about the mass centre,
  //   body axes [N m]
  const T N2_2 = T(0.001) * thetaddot2 + T(0.1) * t3_2;
  // G3 = m3 Pddot3 + F_joint_pin_3: inertia less applied force, inertial axes [N]
  const T G3_1 = F_joint_pin_3_1 + T(0.4) * sddot3;
  const T G3_3 = T(3.9240000000000004) + F_joint_pin_3_3;
  reaction[12] = G3_1;
  reaction[14] = G3_3;

  // ---- body 2 (rod) and what it carries
  // rho2 = r2~ G2 + N2: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho2_2 = N2_2 - T(0.1) * G2_3;
  reaction[10] = rho2_2;

  // ---- body 1 (crank) and what it carries
  // S1 = E2^T G2 + G1: sum of the force balances of the subtree, body axes [N]
  const T S1_1 = minus_E2_13 * G2_3 - E2_11 * minus_G2_1 - minus_G1_1;
  const T b1_1 = minus_E2_13 * minus_G2_1 + E2_11 * G2_3;
  const T S1_3 = b1_1 + G1_3;
  reaction[0] = S1_1;
  reaction[2] = S1_3;
  // rho1 = q2~ E2^T G2 + E2^T rho2 + r1~ G1 + N1: sum of the moment balances of the subtree about the body origin,
  //   body axes [N m]
  const T rho1_2 = rho2_2 - T(0.05) * b1_1 - T(0.01) * G1_3;
  reaction[4] = rho1_2;
}

// rod_end_position: position of rod_end, inertial axes.
// (3) [m]
// 4 add, 9 multiply, 4 sine or cosine
template <class T>
void rod_end_position(const Prepared<T>& c, T t, const T* x, T* position) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (crank) on the inertial frame
  // theta1 = expression 1: prescribed
  const T theta1 = c.p.crank_speed * t;
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cos(theta1);
  const T minus_E1_13 = sin(theta1);

  // ---- body 2 (rod) on body 1
  const T theta2 = x[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = E1_11 * T(0.05);
  const T minus_P2_3 = minus_E1_13 * T(0.05);

  // ---- results
  position[0] = R2_11 * T(0.2) + P2_1;
  position[1] = T(0);
  position[2] = -(minus_P2_3 + minus_R2_13 * T(0.2));
}

// pin_position: position of pin, inertial axes.
// (3) [m]
// 0 add, 0 multiply
template <class T>
void pin_position([[maybe_unused]] const Prepared<T>& c, const T* x, T* position) noexcept {

  // ---- results
  const T s3 = x[1];
  position[0] = s3;
  position[1] = T(0);
  position[2] = T(0);
}

}  // namespace kanec::slider_crank
