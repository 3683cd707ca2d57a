// SPDX-License-Identifier: BSD-3-Clause
// free_body: equations of motion of 1 rigid body, made by kanec 0.1.0. Not to be edited by hand.
//
// model d4edc8faacb9d23b of free_body/scene.toml; the usual functions
// bodies and their joints:
//   1 handle on the inertial frame: free
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, s_1_1 .. s_1_3)
//   y = (omega_1_1 .. omega_1_3, sdot_1_1 .. sdot_1_3)
//   eps       Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)
//   s         translation from the joint point, axes of the lower body [m]
//   omega     absolute angular velocity, body axes [rad/s] (3)
//   sdot      rate of s [m/s]
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              23 (8 add, 15 multiply)
//   poses                   23 (11 add, 12 multiply)
//   energy                  17 (5 add, 12 multiply)
//   momentum                56 (23 add, 33 multiply)
//   accelerations           9 (0 add, 9 multiply)
//   residual                21 (9 add, 12 multiply)
//   forcing                 6 (0 add, 6 multiply)
//   mass_matrix             0 (0 add, 0 multiply)
//   partial_velocities      0 (0 add, 0 multiply)
//   partial_velocity_rates  0 (0 add, 0 multiply)
#pragma once

namespace kanec::free_body {

inline constexpr int n_bodies = 1;
inline constexpr int nx = 7;
inline constexpr int ny = 6;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 0;
inline constexpr char model_hash[] = "d4edc8faacb9d23b";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, s_1_1 = 4, s_1_2 = 5, s_1_3 = 6;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, sdot_1_1 = 3, sdot_1_2 = 4, sdot_1_3 = 5;
inline constexpr int eps_handle_1 = 0, eps_handle_2 = 1, eps_handle_3 = 2, eps_handle_4 = 3, s_handle_1 = 4,
    s_handle_2 = 5, s_handle_3 = 6;
inline constexpr int omega_handle_1 = 0, omega_handle_2 = 1, omega_handle_3 = 2, sdot_handle_1 = 3, sdot_handle_2 = 4,
    sdot_handle_3 = 5;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 6;
inline constexpr int mass_matrix_rows[] = {0, 1, 2, 3, 4, 5};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
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
// 8 add, 15 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* xdot) noexcept {

  // ---- body 1 (handle) on the inertial frame
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
  const T sdot1_1 = y[3], sdot1_2 = y[4], sdot1_3 = y[5];
  xdot[4] = sdot1_1;
  xdot[5] = sdot1_2;
  xdot[6] = sdot1_3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 11 add, 12 multiply
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {

  // ---- body 1 (handle) on the inertial frame
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
  pose[1] = R1_12;
  pose[2] = R1_13;
  pose[3] = R1_21;
  pose[4] = R1_22;
  pose[5] = R1_23;
  pose[6] = R1_31;
  pose[7] = R1_32;
  pose[8] = R1_33;

  // ---- results
  const T s1_1 = x[4], s1_2 = x[5], s1_3 = x[6];
  pose[9] = s1_1;
  pose[10] = s1_2;
  pose[11] = s1_3;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 5 add, 12 multiply
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* energy) noexcept {

  // ---- body 1 (handle) on the inertial frame
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[3], sdot1_2 = y[4], sdot1_3 = y[5];
  // T1 = 1/2 sdot1 . sdot1 m1 + 1/2 omega1 . (I1 omega1): kinetic energy [J]
  const T T1 = T(0.5) * (sdot1_1 * sdot1_1 + sdot1_2 * sdot1_2 + sdot1_3 * sdot1_3) * T(0.8) + T(0.5) * (T(0.01) *
      omega1_1 * omega1_1 + T(0.02) * omega1_2 * omega1_2 + T(0.028) * omega1_3 * omega1_3);
  energy[0] = T1;

  // ---- results
  energy[1] = T(0);
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 23 add, 33 multiply
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {

  // ---- body 1 (handle) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[4], s1_2 = x[5], s1_3 = x[6];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[3], sdot1_2 = y[4], sdot1_3 = y[5];
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
  const T l1_1 = T(0.8) * sdot1_1;
  const T l1_2 = T(0.8) * sdot1_2;
  const T l1_3 = T(0.8) * sdot1_3;
  momentum[0] = l1_1;
  momentum[1] = l1_2;
  momentum[2] = l1_3;
  // H1 = s1~ l1 + R1^T I1 omega1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_13 = T(0.01) * omega1_1;
  const T t1_14 = T(0.02) * omega1_2;
  const T t1_15 = T(0.028) * omega1_3;
  const T H1_1 = s1_2 * l1_3 - s1_3 * l1_2 + R1_11 * t1_13 + R1_21 * t1_14 + R1_31 * t1_15;
  const T H1_2 = s1_3 * l1_1 - s1_1 * l1_3 + R1_12 * t1_13 + R1_22 * t1_14 + R1_32 * t1_15;
  const T H1_3 = s1_1 * l1_2 - s1_2 * l1_1 + R1_13 * t1_13 + R1_23 * t1_14 + R1_33 * t1_15;
  momentum[3] = H1_1;
  momentum[4] = H1_2;
  momentum[5] = H1_3;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 0 add, 9 multiply
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* ydot) noexcept {

  // ---- body 1 (handle) on the inertial frame
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // N1 = -omega1~ I1 omega1: applied less gyroscopic moment, body axes [N m]
  const T minus_N1_1 = omega1_2 * omega1_3 * T(0.008);
  const T N1_2 = omega1_1 * omega1_3 * T(0.018000000000000002);
  const T minus_N1_3 = omega1_1 * omega1_2 * T(0.01);
  // omegadot1 = Iinv1 N1: I omegadot + omega~ I omega = M
  const T minus_omegadot1_1 = T(100) * minus_N1_1;
  const T omegadot1_2 = T(50) * N1_2;
  const T minus_omegadot1_3 = T(35.714285714285715) * minus_N1_3;
  ydot[0] = -minus_omegadot1_1;
  ydot[1] = omegadot1_2;
  ydot[2] = -minus_omegadot1_3;

  // ---- results
  ydot[3] = T(0);
  ydot[4] = T(0);
  ydot[5] = T(0);
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 9 add, 12 multiply
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, const T* ydot, T* r)
    noexcept {

  // ---- body 1 (handle) on the inertial frame
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[3], sddot1_2 = ydot[4], sddot1_3 = ydot[5];
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t1_1 = omega1_2 * omega1_1;
  const T U1_12 = t1_1 - omegadot1_3;
  const T t1_2 = omega1_3 * omega1_1;
  const T U1_13 = t1_2 + omegadot1_2;
  const T U1_21 = t1_1 + omegadot1_3;
  const T t1_3 = omega1_3 * omega1_2;
  const T U1_23 = t1_3 - omegadot1_1;
  const T U1_31 = t1_2 - omegadot1_2;
  const T U1_32 = t1_3 + omegadot1_1;
  // G1 = m1 sddot1: inertia less applied force, inertial axes [N]
  const T G1_1 = T(0.8) * sddot1_1;
  const T G1_2 = T(0.8) * sddot1_2;
  const T G1_3 = T(0.8) * sddot1_3;
  r[3] = G1_1;
  r[4] = G1_2;
  r[5] = G1_3;
  // N1 = axial(U1 (tr(I1)/2 - I1)): inertia less applied moment about the mass centre, body axes [N m]
  const T N1_1 = T(0.009000000000000001) * U1_32 - T(0.001) * U1_23;
  const T N1_2 = T(0.001) * U1_13 - T(0.019) * U1_31;
  const T N1_3 = T(0.019) * U1_21 - T(0.009000000000000001) * U1_12;
  r[0] = N1_1;
  r[1] = N1_2;
  r[2] = N1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 0 add, 6 multiply
template <class T>
void forcing([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, T* f) noexcept {

  // ---- body 1 (handle) on the inertial frame
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  // N1 = -omega1~ I1 omega1: applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N1_1 = omega1_3 * omega1_2 * T(0.008);
  const T N1_2 = omega1_3 * omega1_1 * T(0.018000000000000002);
  const T minus_N1_3 = omega1_2 * omega1_1 * T(0.01);
  f[0] = -minus_N1_1;
  f[1] = N1_2;
  f[2] = -minus_N1_3;

  // ---- results
  f[3] = T(0);
  f[4] = T(0);
  f[5] = T(0);
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 0 add, 0 multiply
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, T* A) noexcept {
  for (int i = 0; i < 36; ++i) A[i] = T(0);
  A[0] = T(0.01);
  A[7] = T(0.02);
  A[14] = T(0.028);
  A[21] = T(0.8);
  A[28] = T(0.8);
  A[35] = T(0.8);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 0 add, 0 multiply
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, T* v_y) noexcept {
  T block[9];
  block[0] = T(1);
  block[4] = T(1);
  block[8] = T(1);
  block[1] = T(0);
  block[2] = T(0);
  block[3] = T(0);
  block[5] = T(0);
  block[6] = T(0);
  block[7] = T(0);

  // {block, place of its first entry}; the same block stands where bodies share it, 0 elsewhere
  static constexpr int places[][2] = {
      {0,3},
  };
  for (int i = 0; i < 18; ++i) v_y[i] = T(0);
  for (const auto& place : places)
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j) v_y[place[1] + i * 6 + j] = block[9 * place[0] + 3 * i + j];
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 0 add, 0 multiply
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, [[maybe_unused]] const
    T* y, T* v_y_dot) noexcept {
  for (int i = 0; i < 18; ++i) v_y_dot[i] = T(0);
}

}  // namespace kanec::free_body
