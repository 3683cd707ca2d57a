// SPDX-License-Identifier: BSD-3-Clause
// cart_pole: equations of motion of 2 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 63f7b9d1d634c459 of cart_pole/scene.toml; functions kinematics poses energy power accelerations residual
// mass_matrix state_matrix input_matrix tip_position
// bodies and their joints:
//   1 cart on the inertial frame: prismatic
//   2 pole on 1: revolute
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (theta_2, s_1)
//   y = (thetadot_2, sdot_1)
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
//   poses                   3 (1 add, 2 multiply, 2 sine or cosine)
//   energy                  18 (4 add, 14 multiply, 2 sine or cosine)
//   power                   4 (1 add, 3 multiply, 1 other function)
//   accelerations           20 (5 add, 14 multiply, 1 divide, 2 sine or cosine, 1 other function)
//   residual                18 (6 add, 12 multiply, 2 sine or cosine, 1 other function)
//   mass_matrix             1 (0 add, 1 multiply, 1 sine or cosine)
//   state_matrix            45 (10 add, 34 multiply, 1 divide, 2 sine or cosine, 1 other function)
//   input_matrix            6 (1 add, 4 multiply, 1 divide, 1 sine or cosine)
//   tip_position            1 (1 add, 0 multiply, 2 sine or cosine)
#pragma once

#include <cmath>

namespace kanec::cart_pole {

inline constexpr int n_bodies = 2;
inline constexpr int nx = 2;
inline constexpr int ny = 2;
inline constexpr int n_parameters = 2;
inline constexpr int n_inputs = 1;
inline constexpr char model_hash[] = "63f7b9d1d634c459";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_2 = 0, s_1 = 1;
inline constexpr int thetadot_2 = 0, sdot_1 = 1;
inline constexpr int theta_pole = 0, s_cart = 1;
inline constexpr int thetadot_pole = 0, sdot_cart = 1;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 4;
inline constexpr int mass_matrix_rows[] = {0, 0, 1, 1};
inline constexpr int mass_matrix_columns[] = {0, 1, 0, 1};

// Entries of state_matrix that are not always 0, row by row.
inline constexpr int state_matrix_nonzeros = 8;
inline constexpr int state_matrix_rows[] = {0, 1, 2, 2, 2, 3, 3, 3};
inline constexpr int state_matrix_columns[] = {2, 3, 0, 2, 3, 0, 2, 3};

// Entries of input_matrix that are not always 0, row by row.
inline constexpr int input_matrix_nonzeros = 2;
inline constexpr int input_matrix_rows[] = {2, 3};
inline constexpr int input_matrix_columns[] = {0, 0};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T m_cart = T(1);
  T mu = T(0.05);
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
  T push = T(0);
};

// What depends on parameters only, computed once for many calls.
template <class T>
struct Prepared {
  Parameters<T> p;
  T c1_1;
  T m_all_1;
};

// prepare: 1 add, 1 multiply
template <class T>
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  Prepared<T> c{};
  c.p = p;
  const T c1_1 = T(0.5) * p.m_cart;
  const T m_all_1 = p.m_cart + T(0.1);
  c.c1_1 = c1_1;
  c.m_all_1 = m_all_1;
  return c;
}

// kinematics: xdot, the kinematical equations.
// rates of x (nx) [1/s], [rad/s], [m/s]
// 0 add, 0 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* xdot) noexcept {
  const T thetadot2 = y[0];
  const T sdot1 = y[1];
  xdot[0] = thetadot2;
  xdot[1] = sdot1;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 1 add, 2 multiply, 2 sine or cosine
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 24; ++i) pose[i] = T(0);

  // ---- body 2 (pole) on body 1
  const T theta2 = x[0];
  const T s1 = x[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  pose[12] = E2_11;
  pose[20] = E2_11;
  pose[14] = -minus_E2_13;
  pose[18] = minus_E2_13;
  // p2 = E2^T r2 + d1: position of the mass centre, inertial axes [m]
  const T p2_1 = s1 + minus_E2_13 * T(0.5);
  const T p2_3 = E2_11 * T(0.5);
  pose[21] = p2_1;
  pose[23] = p2_3;

  // ---- results
  pose[0] = T(1);
  pose[4] = T(1);
  pose[8] = T(1);
  pose[16] = T(1);
  pose[9] = s1;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 4 add, 14 multiply, 2 sine or cosine
template <class T>
void energy(const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (cart) on the inertial frame
  const T sdot1 = y[1];
  // T1 = 1/2 m1 Pdot1 . Pdot1: kinetic energy [J]
  const T T1 = sdot1 * sdot1 * c.c1_1;

  // ---- body 2 (pole) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // p2 = E2^T r2 + d1: position of the mass centre, inertial axes [m]
  const T p2_3 = E2_11 * T(0.5);
  // v2 = E2^T omega2~ r2 + Pdot1: velocity of the mass centre, inertial axes [m/s]
  const T t2_1 = thetadot2 * T(0.5);
  const T v2_1 = sdot1 + E2_11 * t2_1;
  const T minus_v2_3 = minus_E2_13 * t2_1;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.008333333333333333) * thetadot2 * thetadot2 * T(0.5) + T(0.05) * (v2_1 * v2_1 + minus_v2_3 *
      minus_v2_3);

  // ---- whole system
  // kinetic = T1 + T2: kinetic energy of the system [J]
  const T kinetic = T2 + T1;
  energy[0] = kinetic;
  // mp = m1 d1 + m2 p2: first moment of mass, inertial axes [kg m]
  const T mp_3 = T(0.1) * p2_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.8) * mp_3;
  energy[1] = potential;
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 1 add, 3 multiply, 1 other function
template <class T>
void power(const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, const Inputs<T>& u, T* out) noexcept {
  using std::tanh;

  // ---- body 1 (cart) on the inertial frame
  const T sdot1 = y[1];
  // power = sdot1 tau_cart_: power of the applied loads [W]
  const T power = sdot1 * (u.push - c.p.mu * tanh(sdot1 * T(100)));
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 5 add, 14 multiply, 1 divide, 2 sine or cosine, 1 other function
// by: composite; articulated would take 6 add, 15 multiply, 1 divide, 2 sine or cosine, 1 other function
template <class T>
void accelerations(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot) noexcept {
  using std::cos, std::sin, std::tanh;

  // ---- body 2 (pole) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // U2 = omega2~ omega2~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T minus_U2_11 = thetadot2 * thetadot2;
  // Pddot2 = E2 Pddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = minus_E2_13 * T(9.8);
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T G2_3 = minus_U2_11 * T(0.05);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N2_2 = T(0.05) * minus_Pddot2_1;

  // ---- body 1 (cart) and what it carries
  // S1 = E2^T G2 + G1: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = minus_E2_13 * G2_3;
  // D_sddot1: pivots of L D L^T
  const T b1_1 = E2_11 * T(0.05);
  const T b1_2 = b1_1 * T(30);
  const T D_sddot1 = c.m_all_1 - b1_2 * b1_1;

  // ---- body 1 (cart), solved
  const T sdot1 = y[1];
  // sddot1: from A ydot = f by elimination
  const T sddot1 = T(1) / D_sddot1 * (S1_1 + u.push - c.p.mu * tanh(sdot1 * T(100)) - b1_2 * N2_2);
  ydot[1] = sddot1;

  // ---- body 2 (pole), solved
  // thetaddot2: from A ydot = f by elimination
  const T thetaddot2 = N2_2 * T(30) - b1_2 * sddot1;
  ydot[0] = thetaddot2;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 6 add, 12 multiply, 2 sine or cosine, 1 other function
template <class T>
void residual(const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r) noexcept {
  using std::cos, std::sin, std::tanh;

  // ---- body 1 (cart) on the inertial frame
  const T sddot1 = ydot[1];
  // G1 = m_all_1 Pddot1: inertia less applied force, inertial axes [N]
  const T G1_1 = c.m_all_1 * sddot1;

  // ---- body 2 (pole) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  const T thetaddot2 = ydot[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U2_11 = thetadot2 * thetadot2;
  // Pddot2 = E2 Pddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot2_1 = E2_11 * sddot1 - minus_E2_13 * T(9.8);
  // G2 = U2 h_own_2: inertia less applied force, body axes [N]
  const T G2_1 = thetaddot2 * T(0.05);
  const T minus_G2_3 = minus_U2_11 * T(0.05);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_2 = T(0.05) * Pddot2_1 + T(0.03333333333333333) * thetaddot2;
  r[0] = N2_2;

  // ---- body 1 (cart) and what it carries
  const T sdot1 = y[1];
  // S1 = E2^T G2 + G1: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = E2_11 * G2_1 - minus_E2_13 * minus_G2_3 + G1_1;
  // r_sdot1 = u1 . S1 - tau_cart_: Kane's equation of sdot [N]
  const T r_sdot1 = S1_1 - u.push + c.p.mu * tanh(sdot1 * T(100));
  r[1] = r_sdot1;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 0 add, 1 multiply, 1 sine or cosine
template <class T>
void mass_matrix(const Prepared<T>& c, const T* x, T* A) noexcept {
  using std::cos;

  // ---- body 1 (cart) on the inertial frame
  A[3] = c.m_all_1;

  // ---- body 2 (pole) on body 1
  const T theta2 = x[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);

  // ---- results
  A[0] = T(0.03333333333333333);
  const T t1 = E2_11 * T(0.05);
  A[1] = t1;
  A[2] = t1;
}

// state_matrix: S of d(xi, y)/dt = S (xi, y) for small changes; xi: of a ball a turn, body axes; else as x.
// S (2 ny x 2 ny)
// 10 add, 34 multiply, 1 divide, 2 sine or cosine, 1 other function
// by: equations differentiated; operations differentiated would take 12 add, 37 multiply, 1 divide, 2 sine or cosine,
//   1 other function
template <class T>
void state_matrix(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* S) noexcept {
  using std::cos, std::sin, std::tanh;
  for (int i = 0; i < 16; ++i) S[i] = T(0);

  // ---- body 2 (pole) on body 1
  const T theta2 = x[0];
  const T thetadot2 = y[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  // U2 = omega2~ omega2~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T minus_U2_11 = thetadot2 * thetadot2;
  // Pddot2 = E2 Pddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = minus_E2_13 * T(9.8);
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T G2_3 = minus_U2_11 * T(0.05);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N2_2 = T(0.05) * minus_Pddot2_1;

  // ---- body 1 (cart) and what it carries
  // S1 = E2^T G2 + G1: sum of the force balances of the subtree, inertial axes [N]
  const T S1_1 = minus_E2_13 * G2_3;
  // D_sddot1: pivots of L D L^T
  const T b1_1 = E2_11 * T(0.05);
  const T b1_2 = b1_1 * T(30);
  const T D_sddot1 = c.m_all_1 - b1_2 * b1_1;

  // ---- body 1 (cart), solved
  const T sdot1 = y[1];
  // sddot1: from A ydot = f by elimination
  const T z1_1 = tanh(sdot1 * T(100));
  const T z1_2 = T(1) / D_sddot1;
  const T sddot1 = (u.push - c.p.mu * z1_1 + S1_1 - b1_2 * N2_2) * z1_2;

  // ---- body 2 (pole), solved
  // thetaddot2: from A ydot = f by elimination
  const T thetaddot2 = N2_2 * T(30) - b1_2 * sddot1;

  // ---- body 2 (pole) on body 1
  // G2 = U2 h_own_2: inertia less applied force, body axes [N]
  const T G2_1_of_r = thetaddot2 * T(0.05);

  // ---- body 2 (pole) and what it carries
  // hc2 = E2^T h_own_2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_1 = minus_E2_13 * T(0.05);

  // ---- body 1 (cart) and what it carries
  // Fq_thetadot2_1 = -(E2^T G2)~ b2
  const T minus_Fq_thetadot2_1_1 = minus_E2_13 * G2_1_of_r + E2_11 * G2_3;

  // ---- results
  S[2] = T(1);
  S[7] = T(1);
  const T t1 = T(9.8) * b1_1 + sddot1 * hc2_1;
  const T t2 = (minus_Fq_thetadot2_1_1 - b1_2 * t1) * z1_2;
  S[8] = t1 * T(30) - b1_2 * t2;
  const T t3 = T(2) * thetadot2 * T(0.05) * minus_E2_13 * z1_2;
  S[10] = -b1_2 * t3;
  const T t4 = (T(1) - z1_1 * z1_1) * T(100) * c.p.mu * z1_2;
  S[11] = b1_2 * t4;
  S[12] = t2;
  S[14] = t3;
  S[15] = -t4;
}

// input_matrix: rates of (xi, y) for small changes of the inputs.
// B (2 ny x n_inputs)
// 1 add, 4 multiply, 1 divide, 1 sine or cosine
template <class T>
void input_matrix(const Prepared<T>& c, const T* x, [[maybe_unused]] const T* y, [[maybe_unused]] const Inputs<T>& u,
    T* B) noexcept {
  using std::cos;

  // ---- body 2 (pole) on body 1
  const T theta2 = x[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);

  // ---- body 1 (cart) and what it carries
  // D_sddot1: pivots of L D L^T
  const T b1_1 = E2_11 * T(0.05);
  const T b1_2 = b1_1 * T(30);
  const T D_sddot1 = c.m_all_1 - b1_2 * b1_1;

  // ---- results
  B[0] = T(0);
  B[1] = T(0);
  const T t1 = T(1) / D_sddot1;
  B[2] = -b1_2 * t1;
  B[3] = t1;
}

// tip_position: position of tip, inertial axes.
// (3) [m]
// 1 add, 0 multiply, 2 sine or cosine
template <class T>
void tip_position([[maybe_unused]] const Prepared<T>& c, const T* x, T* position) noexcept {
  using std::cos, std::sin;

  // ---- body 2 (pole) on body 1
  const T theta2 = x[0];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);
  const T minus_E2_13 = sin(theta2);
  position[2] = E2_11;

  // ---- results
  const T s1 = x[1];
  position[0] = minus_E2_13 + s1;
  position[1] = T(0);
}

}  // namespace kanec::cart_pole
