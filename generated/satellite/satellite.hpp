// SPDX-License-Identifier: BSD-3-Clause
// satellite: equations of motion of 4 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 07769617f5da6be7 of satellite/scene.toml; functions kinematics poses energy momentum power accelerations
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
// its own or by conversion cos, sin. Cosines and sines of angles in double are those of cos_sin() below, with
// KANEC_LIBM_COS_SIN the library's.
//
// operations of one call (adds + multiplies + divides):
//   kinematics                    23 (8 add, 15 multiply)
//   poses                         132 (60 add, 72 multiply, 6 sine or cosine)
//   energy                        230 (99 add, 131 multiply, 6 sine or cosine)
//   momentum                      389 (180 add, 209 multiply, 6 sine or cosine)
//   power                         62 (26 add, 36 multiply)
//   accelerations                 555 (250 add, 299 multiply, 6 divide, 6 sine or cosine)
//   residual                      357 (172 add, 185 multiply, 6 sine or cosine)
//   mass_matrix                   138 (65 add, 73 multiply, 6 sine or cosine)
//   kinematics_and_accelerations  578 (258 add, 314 multiply, 6 divide, 6 sine or cosine)
//   state_matrix                  3235 (1444 add, 1785 multiply, 6 divide, 6 sine or cosine)
//   input_matrix                  449 (193 add, 250 multiply, 6 divide, 6 sine or cosine)
//   tip_position                  40 (16 add, 24 multiply, 2 sine or cosine)
//   tip_acceleration              131 (55 add, 76 multiply, 2 sine or cosine)
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>

#if !defined(KANEC_COS_SIN)
#define KANEC_COS_SIN
namespace kanec_cos_sin {

// c = cos(a), s = sin(a) for n angles. Here by the functions of the scalar.
template <class T>
void cos_sin(const T* a, int n, T* c, T* s) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < n; ++i) {
    c[i] = cos(a[i]);
    s[i] = sin(a[i]);
  }
}

#if defined(__GNUC__) && (defined(__x86_64__) || defined(__aarch64__)) && \
    !(defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(KANEC_LIBM_COS_SIN))
#define KANEC_COS_SIN_VECTORS
// Lanes of a vector of doubles with |a| <= 4096; Bits: unsigned integers of 64 bits. Errors below 0.95 ulps.
// a = n pi/2 + r + e with |r| <= pi/4 (Cody and Waite 1980), then minimax polynomials of r^2.
template <class Vector, class Bits>
[[gnu::always_inline]] inline void cos_sin_of(const Vector& a, Vector& c, Vector& s) noexcept {
  const Vector shifted = a * 0.6366197723675814 + 6755399441055744.0;  // 1.5 2^52: the last bits are those of n
  const Vector n = shifted - 6755399441055744.0;
  const Vector near = a - n * 1.5707963267941523;  // 41 bits of pi/2, and 41 more: these products are exact
  const Vector r = near - n * 7.443547480484391e-13;
  const Vector e = (near - r) - n * 7.443547480484391e-13 - n * 2.232414100745812e-25;
  const Vector z = r * r;
  const Vector sine =
      r + (e + r * z *
                   (-0.16666666666666666 +
                    z * (0.008333333333328844 +
                         z * (-0.0001984126983405406 +
                              z * (2.755731495933727e-06 +
                                   z * (-2.5050933585480144e-08 + z * 1.5905963454567042e-10))))));
  const Vector high = 1.0 - 0.5 * z;
  const Vector cosine =
      high + ((1.0 - high - 0.5 * z) - r * e +
              z * z *
                  (0.041666666666666664 +
                   z * (-0.001388888888888389 +
                        z * (2.480158729492235e-05 +
                             z * (-2.7557315779745287e-07 +
                                  z * (2.087590183293117e-09 + z * -1.1368241888144376e-11))))));
  Bits quadrant, bits_c, bits_s;
  std::memcpy(&quadrant, &shifted, sizeof quadrant);
  std::memcpy(&bits_c, &cosine, sizeof bits_c);
  std::memcpy(&bits_s, &sine, sizeof bits_s);
  const Bits exchange = (bits_c ^ bits_s) & (0 - (quadrant & 1));
  bits_c ^= exchange ^ ((quadrant + 1) & 2) << 62;
  bits_s ^= exchange ^ (quadrant & 2) << 62;
  std::memcpy(&c, &bits_c, sizeof c);
  std::memcpy(&s, &bits_s, sizeof s);
}

// The same in doubles; angles that are large or no numbers by the library.
inline void cos_sin(const double* a, int n, double* c, double* s) noexcept {
  typedef double Vector __attribute__((vector_size(32)));
  typedef std::uint64_t Bits __attribute__((vector_size(32)));
  double sum = 0;
  for (int i = 0; i < n; ++i) sum += std::fabs(a[i]);
  if (!(sum <= 4096)) return cos_sin<double>(a, n, c, s);
  for (int i = 0; i < n; i += 4) {
    const int first = n < 4 ? 0 : i < n - 4 ? i : n - 4, last = n - 1;
    const double* const from = a + first;
    const Vector group = n < 4 ? Vector{a[0], a[last < 1 ? last : 1], a[last], a[last]}
                               : Vector{from[0], from[1], from[2], from[3]};
    Vector cosines, sines;
    cos_sin_of<Vector, Bits>(group, cosines, sines);
    for (int j = 0; j < 4 && j < n; ++j) {
      c[first + j] = cosines[j];
      s[first + j] = sines[j];
    }
  }
}
#endif

}  // namespace kanec_cos_sin
#endif

namespace kanec::satellite {

inline constexpr int n_bodies = 4;
inline constexpr int nx = 10;
inline constexpr int ny = 9;
inline constexpr int n_parameters = 2;
inline constexpr int n_inputs = 2;
inline constexpr char model_hash[] = "07769617f5da6be7";

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
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 3, cosines + 4, sines + 4);

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
  const T s1_1 = x[7], s1_2 = x[8], s1_3 = x[9];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];
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
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
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
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T E4_11 = T(0.3333333333333334) + t4_1 * T(0.6666666666666666);
  const T t4_2 = sines[6] * T(0.5773502691896257);
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
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 3, cosines + 4, sines + 4);

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
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];
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
  const T v2_1 = Pdot2_1 + R2_31 * omega2_1 - R1_11 * omega2_3;
  const T v2_2 = Pdot2_2 + R2_32 * omega2_1 - R1_12 * omega2_3;
  const T v2_3 = Pdot2_3 + R2_33 * omega2_1 - R1_13 * omega2_3;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (T(3) * omega2_1 * omega2_1 + T(0.75) * omega2_2 * omega2_2 + T(3.75) * omega2_3 * omega2_3) +
      T(4.5) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (right_panel) on body 1
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
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
  const T v3_1 = Pdot3_1 + R1_11 * omega3_3 - R3_31 * omega3_1;
  const T v3_2 = Pdot3_2 + R1_12 * omega3_3 - R3_32 * omega3_1;
  const T v3_3 = Pdot3_3 + R1_13 * omega3_3 - R3_33 * omega3_1;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (T(3) * omega3_1 * omega3_1 + T(0.75) * omega3_2 * omega3_2 + T(3.75) * omega3_3 * omega3_3) +
      T(4.5) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (wheel) on body 1
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T E4_11 = T(0.3333333333333334) + t4_1 * T(0.6666666666666666);
  const T t4_2 = sines[6] * T(0.5773502691896257);
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
  const T T4 = T(0.5) * (omega4_1 * (t4_5 + t4_6 + T(0.0158) * omega4_1) + omega4_2 * (t4_7 + t4_6 + T(0.0158) *
      omega4_2) + omega4_3 * (t4_7 + t4_5 + T(0.0158) * omega4_3)) + T(2) * (Pdot4_1 * Pdot4_1 + Pdot4_2 * Pdot4_2 +
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
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 3, cosines + 4, sines + 4);

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
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];
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
  const T v2_1 = Pdot2_1 + R2_31 * omega2_1 - R1_11 * omega2_3;
  const T v2_2 = Pdot2_2 + R2_32 * omega2_1 - R1_12 * omega2_3;
  const T v2_3 = Pdot2_3 + R2_33 * omega2_1 - R1_13 * omega2_3;
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
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
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
  const T v3_1 = Pdot3_1 + R1_11 * omega3_3 - R3_31 * omega3_1;
  const T v3_2 = Pdot3_2 + R1_12 * omega3_3 - R3_32 * omega3_1;
  const T v3_3 = Pdot3_3 + R1_13 * omega3_3 - R3_33 * omega3_1;
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
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T E4_11 = T(0.3333333333333334) + t4_1 * T(0.6666666666666666);
  const T t4_2 = sines[6] * T(0.5773502691896257);
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
  const T t4_7 = t4_5 + t4_6 + T(0.0158) * omega4_1;
  const T t4_8 = T(0.0021) * omega4_1;
  const T t4_9 = t4_8 + t4_6 + T(0.0158) * omega4_2;
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
// 250 add, 299 multiply, 6 divide, 6 sine or cosine
// by: articulated; composite would take 253 add, 304 multiply, 6 divide, 6 sine or cosine
template <class T>
void accelerations(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 3, cosines + 4, sines + 4);

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
  const T U1_12 = omega1_2 * omega1_1;
  const T U1_13 = omega1_3 * omega1_1;
  const T t1_13 = omega1_3 * omega1_3;
  const T t1_14 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_14;
  const T U1_23 = omega1_3 * omega1_2;
  const T t1_15 = omega1_2 * omega1_2;
  const T minus_U1_33 = t1_15 + t1_14;
  // G1 = -U1 h_all_1 + F_thruster_: applied less inertia force, body axes [N]
  const T G1_1 = u.thrust + U1_13 * T(0.8);
  const T G1_2 = U1_23 * T(0.8);
  const T minus_G1_3 = minus_U1_33 * T(0.8);
  // N1 = -omega1~ J_all_1 omega1 + r_thruster_~ F_thruster_: applied less inertia moment about the body origin, body
  //   axes [N m]
  const T minus_N1_1 = T(10.32) * U1_23 + T(0.3) * (t1_15 - t1_13) - T(0.1) * U1_12 - T(0.2) * U1_13;
  const T minus_N1_2 = T(0.2) * U1_23 - (T(3.34) * U1_13 + T(0.1) * (t1_13 - t1_14)) - T(0.3) * U1_12;
  const T minus_N1_3 = T(0.1) * u.thrust + T(0.2) * (t1_14 - t1_15) - T(6.9799999999999995) * U1_12 + T(0.3) * U1_13 +
      T(0.1) * U1_23;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot2_3 = thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U2_12 = omega2_2 * omega2_1 + minus_omegadot2_3;
  const T minus_U2_22 = omega2_3 * omega2_3 + omega2_1 * omega2_1;
  const T U2_23 = omega2_3 * omega2_2;
  // Pddot2 = E2 U1 q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot2_1 = U1_12 * T(0.6);
  const T t2_1 = minus_U1_22 * T(0.6);
  const T t2_2 = U1_23 * T(0.6);
  const T Pddot2_3 = E2_23 * t2_1 + E2_22 * t2_2;
  // effort_left_panel_2 = -theta2 k_left_panel_ - thetadot2 c_left_panel_: along the coordinate [N m], [N]
  const T minus_effort_left_panel_2 = theta2 * c.p.k + thetadot2 * c.p.c;
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_12 * T(9);
  const T G2_2 = minus_U2_22 * T(9);
  const T minus_G2_3 = U2_23 * T(9);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(9) * Pddot2_3 + T(12) * U2_23;
  const T t2_3 = T(9) * Pddot2_1;
  const T N2_3 = t2_3 + T(12) * U2_12;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // omegadot3 = -thetadot3 b3~ E3 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot3_3 = thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U3_12 = omega3_2 * omega3_1 + minus_omegadot3_3;
  const T minus_U3_22 = omega3_3 * omega3_3 + omega3_1 * omega3_1;
  const T U3_23 = omega3_3 * omega3_2;
  // Pddot3 = E3 U1 q3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot3_3 = E3_23 * t2_1 + E3_22 * t2_2;
  // effort_right_panel_3 = -theta3 k_right_panel_ - thetadot3 c_right_panel_: along the coordinate [N m], [N]
  const T minus_effort_right_panel_3 = theta3 * c.p.k + thetadot3 * c.p.c;
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T G3_1 = U3_12 * T(9);
  const T minus_G3_2 = minus_U3_22 * T(9);
  const T G3_3 = U3_23 * T(9);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(9) * minus_Pddot3_3 + T(12) * U3_23;
  const T N3_3 = t2_3 + T(12) * U3_12;

  // ---- body 4 (wheel) on body 1
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T E4_11 = T(0.3333333333333334) + t4_1 * T(0.6666666666666666);
  const T t4_2 = sines[6] * T(0.5773502691896257);
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
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment about the body origin, body axes [N m]
  const T minus_N4_1 = T(0.0079) * U4_32 - T(0.0079) * U4_23 - T(0.0021) * (minus_U4_22 - minus_U4_33) - T(0.0021) *
      U4_31 + T(0.0021) * U4_21;
  const T minus_N4_2 = T(0.0079) * U4_13 - T(0.0079) * U4_31 - T(0.0021) * (minus_U4_33 - minus_U4_11) - T(0.0021) *
      U4_12 + T(0.0021) * U4_32;
  const T minus_N4_3 = T(0.0079) * U4_21 - T(0.0079) * U4_12 - T(0.0021) * (minus_U4_11 - minus_U4_22) - T(0.0021) *
      U4_23 + T(0.0021) * U4_13;

  // ---- body 4 (wheel) and what it carries
  // u_4 = b4 . N4 + tau_wheel_: drives it [N m], [N]
  const T u_4 = u.wheel_torque - T(0.5773502691896257) * minus_N4_1 - T(0.5773502691896257) * minus_N4_2 -
      T(0.5773502691896257) * minus_N4_3;
  // v4 = invD4 u_4: u/D
  const T v4 = T(50) * u_4;
  // nt4 = N4 - v4 K4: moment with the turn solved [N m]
  const T b4_1 = v4 * T(0.011547005383792516);
  const T minus_nt4_1 = b4_1 + minus_N4_1;
  const T minus_nt4_2 = b4_1 + minus_N4_2;
  const T minus_nt4_3 = b4_1 + minus_N4_3;
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_2 = E4_13 * T(0.004566666666666667);
  const T b4_3 = E4_12 * T(0.004566666666666667);
  const T b4_4 = E4_11 * T(0.009133333333333334) - (b4_2 + b4_3);
  const T b4_5 = b4_4 * E4_11;
  const T b4_6 = E4_11 * T(0.004566666666666667);
  const T b4_7 = E4_13 * T(0.009133333333333334) - (b4_3 + b4_6);
  const T b4_8 = b4_7 * E4_13;
  const T b4_9 = E4_12 * T(0.009133333333333334) - (b4_2 + b4_6);
  const T b4_10 = b4_9 * E4_12;
  const T Jp4_11 = b4_5 + b4_8 + b4_10;
  const T b4_11 = b4_4 * E4_12;
  const T b4_12 = b4_7 * E4_11;
  const T b4_13 = b4_9 * E4_13;
  const T Jp4_12 = b4_11 + b4_12 + b4_13;
  const T Jp4_13 = b4_4 * E4_13 + b4_7 * E4_12 + b4_9 * E4_11;
  const T Jp4_22 = b4_10 + b4_5 + b4_8;
  const T Jp4_23 = b4_13 + b4_11 + b4_12;
  const T Jp4_33 = T(0.027400000000000004) - Jp4_11 - Jp4_22;
  // np4 = E4^T nt4: moment passed on, lower body's axes [N m]
  const T minus_np4_1 = E4_11 * minus_nt4_1 + E4_13 * minus_nt4_2 + E4_12 * minus_nt4_3;
  const T minus_np4_2 = E4_12 * minus_nt4_1 + E4_11 * minus_nt4_2 + E4_13 * minus_nt4_3;
  const T minus_np4_3 = E4_13 * minus_nt4_1 + E4_12 * minus_nt4_2 + E4_11 * minus_nt4_3;

  // ---- body 3 (right_panel) and what it carries
  // u_3 = b3 . N3 + effort_right_panel_3: drives it [N m], [N]
  const T minus_u_3 = minus_effort_right_panel_3 + minus_N3_1;
  // v3 = invD3 u_3: u/D
  const T minus_v3 = T(0.08333333333333333) * minus_u_3;
  // gt3 = G3 - v3 B3: force with the turn solved [N]
  const T gt3_3 = G3_3 - minus_v3 * T(9);
  // Mp3 = E3^T M3 E3: M passed on, lower body's axes [kg]
  const T b3_1 = E3_23 * T(6.75);
  const T minus_Mp3_22 = E3_23 * b3_1;
  const T Mp3_23 = E3_22 * b3_1;
  const T Mp3_33 = minus_Mp3_22 - T(6.75);
  // gp3 = E3^T gt3: force passed on, lower body's axes [N]
  const T minus_gp3_2 = E3_22 * minus_G3_2 + E3_23 * gt3_3;
  const T gp3_3 = E3_22 * gt3_3 - E3_23 * minus_G3_2;
  // Hp3 = E3^T H3 E3: H passed on, lower body's axes [kg m]
  const T minus_Hp3_21 = E3_23 * T(9);
  const T Hp3_31 = E3_22 * T(9);
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_2 = E3_23 * T(12);
  const T Jp3_22 = E3_23 * b3_2;
  const T minus_Jp3_23 = E3_22 * b3_2;
  const T Jp3_33 = T(12) - Jp3_22;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T minus_np3_2 = E3_23 * N3_3;
  const T np3_3 = E3_22 * N3_3;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T minus_Hb3_12 = T(0.6) * Mp3_23;
  const T minus_Hb3_13 = T(0.6) * Mp3_33;

  // ---- body 2 (left_panel) and what it carries
  // u_2 = b2 . N2 + effort_left_panel_2: drives it [N m], [N]
  const T minus_u_2 = minus_effort_left_panel_2 + minus_N2_1;
  // v2 = invD2 u_2: u/D
  const T minus_v2 = T(0.08333333333333333) * minus_u_2;
  // gt2 = G2 - v2 B2: force with the turn solved [N]
  const T gt2_3 = minus_v2 * T(9) - minus_G2_3;
  // Mp2 = E2^T M2 E2: M passed on, lower body's axes [kg]
  const T b2_1 = E2_23 * T(6.75);
  const T minus_Mp2_22 = E2_23 * b2_1;
  const T Mp2_23 = E2_22 * b2_1;
  const T Mp2_33 = minus_Mp2_22 - T(6.75);
  // gp2 = E2^T gt2: force passed on, lower body's axes [N]
  const T gp2_2 = E2_22 * G2_2 - E2_23 * gt2_3;
  const T gp2_3 = E2_23 * G2_2 + E2_22 * gt2_3;
  // Hp2 = E2^T H2 E2: H passed on, lower body's axes [kg m]
  const T Hp2_21 = E2_23 * T(9);
  const T minus_Hp2_31 = E2_22 * T(9);
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T b2_2 = E2_23 * T(12);
  const T Jp2_22 = E2_23 * b2_2;
  const T minus_Jp2_23 = E2_22 * b2_2;
  const T Jp2_33 = T(12) - Jp2_22;
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T minus_np2_2 = E2_23 * N2_3;
  const T np2_3 = E2_22 * N2_3;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T Hb2_12 = T(0.6) * Mp2_23;
  const T Hb2_13 = T(0.6) * Mp2_33;

  // ---- body 1 (hub) and what it carries
  // MA1 = m_all_1 one + Mp3 + Mp2: force for an acceleration of the origin, home axes [kg]
  const T MA1_22 = T(142) - minus_Mp3_22 - minus_Mp2_22;
  const T MA1_23 = Mp3_23 + Mp2_23;
  const T MA1_33 = T(142) + Mp3_33 + Mp2_33;
  // HA1 = h_all_1~ + Hb2 + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA1_12 = Hb2_12 + T(0.8) - minus_Hb3_12;
  const T HA1_13 = Hb2_13 - minus_Hb3_13;
  const T HA1_21 = Hp2_21 - T(0.8) - minus_Hp3_21;
  const T HA1_31 = Hp3_31 - minus_Hp2_31;
  // JA1 = q2~ Hp2^T + q3~ Hp3^T + J_all_1 + Jp4 + Jp3 + Jp2 - Hb2 q2~ - Hb3 q3~: moment for an angular acceleration,
  //   body axes [kg m^2]
  const T JA1_11 = T(22.64) + Jp4_11 + Hb2_13 * T(0.6) + minus_Hb3_13 * T(0.6);
  const T JA1_12 = T(0.2) + Jp4_12;
  const T JA1_13 = Jp4_13 - T(0.1);
  const T JA1_22 = T(15.66) + Jp4_22 + Jp3_22 + Jp2_22;
  const T JA1_23 = T(0.3) + Jp4_23 - minus_Jp3_23 - minus_Jp2_23 - T(0.6) * Hp2_21 - T(0.6) * minus_Hp3_21;
  const T JA1_33 = T(25.98) + Jp4_33 + Jp3_33 + Jp2_33 + T(1.2) * minus_Hp2_31 + T(1.2) * Hp3_31;
  // g1 = G1 + gp3 + gp2: force that drives it, home axes [N]
  const T g1_1 = G1_1 + G3_1 - minus_G2_1;
  const T g1_2 = gp2_2 - minus_gp3_2 + G1_2;
  const T g1_3 = gp3_3 + gp2_3 - minus_G1_3;
  // n1 = q2~ gp2 + q3~ gp3 + N1 + np4 + np3 + np2: moment that drives it, body axes [N m]
  const T n1_1 = minus_effort_right_panel_3 - (minus_N1_1 + minus_np4_1) + minus_effort_left_panel_2 + T(0.6) * gp2_3
      - T(0.6) * gp3_3;
  const T minus_n1_2 = minus_N1_2 + minus_np4_2 + minus_np3_2 + minus_np2_2;
  const T n1_3 = T(0.6) * minus_G2_1 - (minus_N1_3 + minus_np4_3) + T(0.6) * G3_1 + np3_3 + np2_3;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T LD1_21 = LD1_11 * JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - LD1_21 * JA1_12);
  const T LD1_31 = LD1_11 * JA1_13;
  const T b1_1 = JA1_23 - LD1_21 * JA1_13;
  const T LD1_32 = LD1_22 * b1_1;
  const T LD1_33 = T(1) / (JA1_33 - LD1_31 * JA1_13 - LD1_32 * b1_1);
  // Y1 = L(LD1)^-1 HA1: L^-1 HA
  const T minus_Y1_22 = LD1_21 * HA1_12;
  const T minus_Y1_23 = LD1_21 * HA1_13;
  const T Y1_31 = HA1_31 - LD1_32 * HA1_21;
  const T Y1_32 = LD1_32 * minus_Y1_22 - LD1_31 * HA1_12;
  const T Y1_33 = LD1_32 * minus_Y1_23 - LD1_31 * HA1_13;
  // W1 = D(LD1)^-1 Y1: D^-1 L^-1 HA
  const T W1_12 = LD1_11 * HA1_12;
  const T W1_13 = LD1_11 * HA1_13;
  const T W1_21 = LD1_22 * HA1_21;
  const T minus_W1_22 = LD1_22 * minus_Y1_22;
  const T minus_W1_23 = LD1_22 * minus_Y1_23;
  const T W1_31 = LD1_33 * Y1_31;
  const T W1_32 = LD1_33 * Y1_32;
  const T W1_33 = LD1_33 * Y1_33;
  // w_1 = D(LD1)^-1 L(LD1)^-1 n1: D^-1 L^-1 n
  const T w_1_1 = LD1_11 * n1_1;
  const T b1_2 = minus_n1_2 + LD1_21 * n1_1;
  const T minus_w_1_2 = LD1_22 * b1_2;
  const T w_1_3 = LD1_33 * (n1_3 - LD1_31 * n1_1 + LD1_32 * b1_2);
  // M1 = MA1 - Y1^T W1: MA less what the ball takes up [kg]
  const T M1_11 = T(142) - HA1_21 * W1_21 - Y1_31 * W1_31;
  const T minus_M1_12 = Y1_31 * W1_32 - HA1_21 * minus_W1_22;
  const T minus_M1_13 = Y1_31 * W1_33 - HA1_21 * minus_W1_23;
  const T M1_22 = MA1_22 - HA1_12 * W1_12 - minus_Y1_22 * minus_W1_22 - Y1_32 * W1_32;
  const T M1_23 = MA1_23 - HA1_12 * W1_13 - minus_Y1_22 * minus_W1_23 - Y1_32 * W1_33;
  const T M1_33 = MA1_33 - HA1_13 * W1_13 - minus_Y1_23 * minus_W1_23 - Y1_33 * W1_33;
  // gb1 = g1 - Y1^T w_1: force with the ball solved [N]
  const T gb1_1 = g1_1 + HA1_21 * minus_w_1_2 - Y1_31 * w_1_3;
  const T gb1_2 = g1_2 - HA1_12 * w_1_1 - minus_Y1_22 * minus_w_1_2 - Y1_32 * w_1_3;
  const T gb1_3 = g1_3 - HA1_13 * w_1_1 - minus_Y1_23 * minus_w_1_2 - Y1_33 * w_1_3;
  // LDs1 = L D L^T of M1: L D L^T = M: L, and 1/D on the diagonal
  const T LDs1_11 = T(1) / M1_11;
  const T minus_LDs1_21 = LDs1_11 * minus_M1_12;
  const T LDs1_22 = T(1) / (M1_22 - minus_LDs1_21 * minus_M1_12);
  const T minus_LDs1_31 = LDs1_11 * minus_M1_13;
  const T b1_3 = M1_23 - minus_LDs1_21 * minus_M1_13;
  const T LDs1_32 = LDs1_22 * b1_3;
  const T LDs1_33 = T(1) / (M1_33 - minus_LDs1_31 * minus_M1_13 - LDs1_32 * b1_3);
  // ws1 = D(LDs1)^-1 L(LDs1)^-1 gb1: D^-1 L^-1 g
  const T ws1_1 = LDs1_11 * gb1_1;
  const T b1_4 = gb1_2 + minus_LDs1_21 * gb1_1;
  const T ws1_2 = LDs1_22 * b1_4;
  const T ws1_3 = LDs1_33 * (gb1_3 + minus_LDs1_31 * gb1_1 - LDs1_32 * b1_4);

  // ---- body 1 (hub), solved
  // Pddot1 = L(LDs1)^-T ws1
  const T z1_1 = ws1_2 - LDs1_32 * ws1_3;
  const T Pddot1_1 = ws1_1 + minus_LDs1_21 * z1_1 + minus_LDs1_31 * ws1_3;
  // omegadot1 = L(LD1)^-T (-W1 Pddot1 + w_1)
  const T z1_2 = w_1_3 - W1_31 * Pddot1_1 - W1_32 * z1_1 - W1_33 * ws1_3;
  const T z1_3 = minus_w_1_2 + W1_21 * Pddot1_1 - minus_W1_22 * z1_1 - minus_W1_23 * ws1_3 + LD1_32 * z1_2;
  const T omegadot1_1 = w_1_1 - W1_12 * z1_1 - W1_13 * ws1_3 + LD1_21 * z1_3 - LD1_31 * z1_2;
  ydot[0] = omegadot1_1;
  ydot[1] = -z1_3;
  ydot[2] = z1_2;
  // sddot1 = R1^T Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_1 = R1_11 * Pddot1_1 + R1_21 * z1_1 + R1_31 * ws1_3;
  const T sddot1_2 = R1_12 * Pddot1_1 + R1_22 * z1_1 + R1_32 * ws1_3;
  const T sddot1_3 = R1_13 * Pddot1_1 + R1_23 * z1_1 + R1_33 * ws1_3;
  ydot[6] = sddot1_1;
  ydot[7] = sddot1_2;
  ydot[8] = sddot1_3;

  // ---- body 2 (left_panel), solved
  // beta2 = -E2 q2~ omegadot1 + E2 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z2_1 = T(0.6) * omegadot1_1;
  const T beta2_3 = E2_22 * ws1_3 - E2_23 * z1_1 + E2_22 * z2_1;
  // phi2 = -kB2 . beta2 + v2 - (P_b2 kK2) . alphaL2
  const T minus_phi2 = minus_v2 + T(0.75) * beta2_3;
  // thetaddot2 = -b2 . alphaL2 + phi2
  const T minus_thetaddot2 = omegadot1_1 + minus_phi2;
  ydot[3] = -minus_thetaddot2;

  // ---- body 3 (right_panel), solved
  // beta3 = -E3 q3~ omegadot1 + E3 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta3_3 = E3_22 * ws1_3 - E3_23 * z1_1 - E3_22 * z2_1;
  // phi3 = -kB3 . beta3 + v3 - (P_b3 kK3) . alphaL3
  const T phi3 = T(0.75) * beta3_3 - minus_v3;
  // thetaddot3 = -b3 . alphaL3 + phi3
  const T thetaddot3 = phi3 - omegadot1_1;
  ydot[4] = thetaddot3;

  // ---- body 4 (wheel), solved
  // alphaL4 = E4 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4_1 = E4_11 * omegadot1_1 - E4_12 * z1_3 + E4_13 * z1_2;
  const T alphaL4_2 = E4_13 * omegadot1_1 - E4_11 * z1_3 + E4_12 * z1_2;
  const T alphaL4_3 = E4_12 * omegadot1_1 - E4_13 * z1_3 + E4_11 * z1_2;
  // phi4 = -kK4 . alphaL4 + v4
  const T phi4 = v4 - T(0.5773502691896258) * alphaL4_1 - T(0.5773502691896258) * alphaL4_2 - T(0.5773502691896258) *
      alphaL4_3;
  ydot[5] = phi4;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 172 add, 185 multiply, 6 sine or cosine
template <class T>
void residual(const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 3, cosines + 4, sines + 4);

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
  const T t1_15 = omega1_2 * omega1_1;
  const T U1_12 = t1_15 - omegadot1_3;
  const T t1_16 = omega1_3 * omega1_1;
  const T U1_13 = t1_16 + omegadot1_2;
  const T U1_21 = t1_15 + omegadot1_3;
  const T t1_17 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_17;
  const T t1_18 = omega1_3 * omega1_2;
  const T U1_23 = t1_18 - omegadot1_1;
  const T U1_31 = t1_16 - omegadot1_2;
  const T U1_32 = omegadot1_1 + t1_18;
  const T minus_U1_33 = t1_14 + t1_17;
  // Pddot1 = R1 sddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1 = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * sddot1_3;
  const T Pddot1_2 = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * sddot1_3;
  const T Pddot1_3 = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * sddot1_3;
  // G1 = m_all_1 Pddot1 + U1 h_all_1 - F_thruster_: inertia less applied force, body axes [N]
  const T G1_1 = T(142) * Pddot1_1 - u.thrust - U1_13 * T(0.8);
  const T G1_2 = T(142) * Pddot1_2 - U1_23 * T(0.8);
  const T G1_3 = T(142) * Pddot1_3 + minus_U1_33 * T(0.8);
  // N1 = h_all_1~ Pddot1 + axial(U1 (tr(J_all_1)/2 - J_all_1)) - r_thruster_~ F_thruster_: inertia less applied
  //   moment about the body origin, body axes [N m]
  const T N1_1 = T(0.8) * Pddot1_2 + T(16.48) * U1_32 - T(6.16) * U1_23 - T(0.3) * (minus_U1_22 - minus_U1_33) -
      T(0.2) * U1_31 - T(0.1) * U1_21;
  const T N1_2 = T(6.16) * U1_13 - T(9.5) * U1_31 + T(0.1) * (minus_U1_33 - minus_U1_11) - T(0.3) * U1_12 + T(0.2) *
      U1_32 - T(0.8) * Pddot1_1;
  const T N1_3 = T(9.5) * U1_21 - T(16.48) * U1_12 - T(0.2) * (minus_U1_11 - minus_U1_22) + T(0.1) * U1_23 + T(0.3) *
      U1_13 + T(0.1) * u.thrust;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  const T thetaddot2 = ydot[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];
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
  const T U2_32 = omegadot2_1 + omega2_3 * omega2_2;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_1 = U1_12 * T(0.6);
  const T Pddot2_1 = Pddot1_1 + t2_1;
  const T t2_2 = U1_32 * T(0.6);
  const T t2_3 = minus_U1_22 * T(0.6);
  const T Pddot2_3 = E2_22 * (Pddot1_3 + t2_2) - E2_23 * (Pddot1_2 - t2_3);
  // effort_left_panel_2 = -theta2 k_left_panel_ - thetadot2 c_left_panel_: along the coordinate [N m], [N]
  const T minus_effort_left_panel_2 = theta2 * c.p.k + thetadot2 * c.p.c;
  // G2 = U2 h_own_2: inertia less applied force, body axes [N]
  const T G2_1 = U2_12 * T(9);
  const T minus_G2_2 = minus_U2_22 * T(9);
  const T G2_3 = U2_32 * T(9);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(9) * Pddot2_3 + T(12) * U2_32;
  const T minus_N2_3 = T(9) * Pddot2_1 + T(12) * U2_12;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  const T thetaddot3 = ydot[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // omegadot3 = -thetadot3 b3~ E3 omega1 + thetaddot3 b3 + E3 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = thetaddot3 + omegadot1_1;
  const T omegadot3_3 = E3_22 * omegadot1_3 - E3_23 * omegadot1_2 - thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U3_12 = omega3_2 * omega3_1 - omegadot3_3;
  const T minus_U3_22 = omega3_3 * omega3_3 + omega3_1 * omega3_1;
  const T U3_32 = omegadot3_1 + omega3_3 * omega3_2;
  // Pddot3 = E3 (U1 q3 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot3_1 = Pddot1_1 - t2_1;
  const T Pddot3_3 = E3_22 * (Pddot1_3 - t2_2) - E3_23 * (t2_3 + Pddot1_2);
  // effort_right_panel_3 = -theta3 k_right_panel_ - thetadot3 c_right_panel_: along the coordinate [N m], [N]
  const T minus_effort_right_panel_3 = theta3 * c.p.k + thetadot3 * c.p.c;
  // G3 = U3 h_own_3: inertia less applied force, body axes [N]
  const T minus_G3_1 = U3_12 * T(9);
  const T G3_2 = minus_U3_22 * T(9);
  const T minus_G3_3 = U3_32 * T(9);
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(12) * U3_32 - T(9) * Pddot3_3;
  const T N3_3 = T(9) * Pddot3_1 - T(12) * U3_12;

  // ---- body 4 (wheel) on body 1
  const T thetadot4 = y[5];
  const T thetaddot4 = ydot[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T E4_11 = T(0.3333333333333334) + t4_1 * T(0.6666666666666666);
  const T t4_2 = sines[6] * T(0.5773502691896257);
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
  // N4 = axial(U4 (tr(I4)/2 - I4)): inertia less applied moment about the body origin, body axes [N m]
  const T N4_1 = T(0.0079) * U4_32 - T(0.0079) * U4_23 - T(0.0021) * (minus_U4_22 - minus_U4_33) - T(0.0021) * U4_31 +
      T(0.0021) * U4_21;
  const T N4_2 = T(0.0079) * U4_13 - T(0.0079) * U4_31 - T(0.0021) * (minus_U4_33 - minus_U4_11) - T(0.0021) * U4_12 +
      T(0.0021) * U4_32;
  const T N4_3 = T(0.0079) * U4_21 - T(0.0079) * U4_12 - T(0.0021) * (minus_U4_11 - minus_U4_22) - T(0.0021) * U4_23 +
      T(0.0021) * U4_13;

  // ---- body 4 (wheel) and what it carries
  // r_theta4 = b4 . N4 - tau_wheel_: Kane's equation of the angle [N m]
  const T r_theta4 = T(0.5773502691896257) * N4_1 - u.wheel_torque + T(0.5773502691896257) * N4_2 +
      T(0.5773502691896257) * N4_3;
  r[5] = r_theta4;

  // ---- body 3 (right_panel) and what it carries
  // r_theta3 = b3 . N3 - effort_right_panel_3: Kane's equation of the angle [N m]
  const T r_theta3 = N3_1 + minus_effort_right_panel_3;
  r[4] = r_theta3;

  // ---- body 2 (left_panel) and what it carries
  // r_theta2 = b2 . N2 - effort_left_panel_2: Kane's equation of the angle [N m]
  const T r_theta2 = N2_1 + minus_effort_left_panel_2;
  r[3] = r_theta2;

  // ---- body 1 (hub) and what it carries
  // S1 = E2^T G2 + E3^T G3 + G1: sum of the force balances of the subtree, body axes [N]
  const T S1_1 = G2_1 - minus_G3_1 + G1_1;
  const T S1_2 = G1_2 - E2_22 * minus_G2_2 - E2_23 * G2_3 + E3_22 * G3_2 + E3_23 * minus_G3_3;
  const T b1_1 = E2_22 * G2_3 - E2_23 * minus_G2_2;
  const T b1_2 = E3_23 * G3_2 - E3_22 * minus_G3_3;
  const T S1_3 = b1_1 + b1_2 + G1_3;
  // r_omega1 = q2~ E2^T G2 + E2^T N2 + q3~ E3^T G3 + E3^T N3 + E4^T N4 + N1: Kane's equation of omega [N m]
  const T r_omega1_1 = N2_1 + N3_1 + N1_1 + T(0.6) * b1_1 - T(0.6) * b1_2 + E4_11 * N4_1 + E4_13 * N4_2 + E4_12 *
      N4_3;
  const T r_omega1_2 = N1_2 + E2_23 * minus_N2_3 - E3_23 * N3_3 + E4_12 * N4_1 + E4_11 * N4_2 + E4_13 * N4_3;
  const T r_omega1_3 = N1_3 - T(0.6) * G2_1 - E2_22 * minus_N2_3 - T(0.6) * minus_G3_1 + E3_22 * N3_3 + E4_13 * N4_1 +
      E4_12 * N4_2 + E4_11 * N4_3;
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
// 65 add, 73 multiply, 6 sine or cosine
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  for (int i = 0; i < 81; ++i) A[i] = T(0);
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 3, cosines + 4, sines + 4);

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
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];

  // ---- body 3 (right_panel) on body 1
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];

  // ---- body 4 (wheel) on body 1
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T E4_11 = T(0.3333333333333334) + t4_1 * T(0.6666666666666666);
  const T t4_2 = sines[6] * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;

  // ---- body 3 (right_panel) and what it carries
  // hc3 = E3^T h_own_3: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc3_2 = E3_22 * T(9);
  const T minus_hc3_3 = E3_23 * T(9);

  // ---- body 2 (left_panel) and what it carries
  // hc2 = E2^T h_own_2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_2 = E2_22 * T(9);
  const T hc2_3 = E2_23 * T(9);

  // ---- body 1 (hub) and what it carries
  // h1 = h_all_1 + hc2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T minus_h1_2 = minus_hc3_2 - hc2_2;
  const T h1_3 = hc2_3 - T(0.8) - minus_hc3_3;
  // J1 = -q2~ hc2~ + E2^T J_own_2 E2 - q3~ hc3~ + E3^T J_own_3 E3 + E4^T I4 E4 + J_all_1 - hc2~ q2~ - hc3~ q3~:
  //   inertia carried, about the body origin, body axes [kg m^2]
  const T b1_1 = T(0.6) * hc2_2;
  const T b1_2 = b1_1 + T(12);
  const T b1_3 = T(1.2) * minus_hc3_2;
  const T b1_4 = E4_13 * T(0.0021);
  const T b1_5 = E4_12 * T(0.0021);
  const T b1_6 = b1_4 + b1_5 + E4_11 * T(0.0158);
  const T b1_7 = b1_6 * E4_11;
  const T b1_8 = E4_11 * T(0.0021);
  const T b1_9 = b1_5 + b1_8 + E4_13 * T(0.0158);
  const T b1_10 = b1_9 * E4_13;
  const T b1_11 = b1_4 + b1_8 + E4_12 * T(0.0158);
  const T b1_12 = b1_11 * E4_12;
  const T b1_13 = b1_7 + b1_10 + b1_12;
  const T J1_11 = b1_2 + b1_3 + T(34.64) + b1_13 + b1_1;
  const T b1_14 = b1_6 * E4_12;
  const T b1_15 = b1_9 * E4_11;
  const T b1_16 = b1_11 * E4_13;
  const T J1_12 = b1_14 + b1_15 + b1_16 + T(0.2);
  const T J1_13 = b1_6 * E4_13 - T(0.1) + b1_9 * E4_12 + b1_11 * E4_11;
  const T b1_17 = E2_23 * T(12);
  const T b1_18 = E3_23 * T(12);
  const T b1_19 = b1_12 + b1_7 + b1_10 + E2_23 * b1_17 + E3_23 * b1_18;
  const T J1_22 = b1_19 + T(15.66);
  const T J1_23 = b1_16 + b1_14 + b1_15 + T(0.3) - E2_22 * b1_17 - E3_22 * b1_18 - T(0.6) * hc2_3 - T(0.6) *
      minus_hc3_3;
  const T J1_33 = T(50.0274) - b1_19 + b1_3 - b1_13 + T(1.2) * hc2_2;
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
  const T K_thetadot3_1_1 = T(12) + T(0.6) * minus_hc3_2;
  A[4] = K_thetadot3_1_1;
  A[36] = K_thetadot3_1_1;
  A[3] = b1_2;
  A[27] = b1_2;

  // ---- results
  const T t1 = minus_h1_2 * R1_31 + h1_3 * R1_21;
  A[6] = -t1;
  A[54] = -t1;
  const T t2 = minus_h1_2 * R1_32 + h1_3 * R1_22;
  A[7] = -t2;
  A[63] = -t2;
  const T t3 = minus_h1_2 * R1_33 + h1_3 * R1_23;
  A[8] = -t3;
  A[72] = -t3;
  const T t4 = h1_3 * R1_11;
  A[15] = t4;
  A[55] = t4;
  const T t5 = h1_3 * R1_12;
  A[16] = t5;
  A[64] = t5;
  const T t6 = h1_3 * R1_13;
  A[17] = t6;
  A[73] = t6;
  const T t7 = minus_h1_2 * R1_11;
  A[24] = t7;
  A[56] = t7;
  const T t8 = minus_h1_2 * R1_12;
  A[25] = t8;
  A[65] = t8;
  const T t9 = minus_h1_2 * R1_13;
  A[26] = t9;
  A[74] = t9;
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
// 258 add, 314 multiply, 6 divide, 6 sine or cosine
// by: articulated; composite would take 253 add, 304 multiply, 6 divide, 6 sine or cosine
template <class T>
void kinematics_and_accelerations(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* xdot, T* ydot)
    noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 3, cosines + 4, sines + 4);

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
  const T U1_12 = omega1_2 * omega1_1;
  const T U1_13 = omega1_3 * omega1_1;
  const T t1_13 = omega1_3 * omega1_3;
  const T t1_14 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_14;
  const T U1_23 = omega1_3 * omega1_2;
  const T t1_15 = omega1_2 * omega1_2;
  const T minus_U1_33 = t1_15 + t1_14;
  // G1 = -U1 h_all_1 + F_thruster_: applied less inertia force, body axes [N]
  const T G1_1 = u.thrust + U1_13 * T(0.8);
  const T G1_2 = U1_23 * T(0.8);
  const T minus_G1_3 = minus_U1_33 * T(0.8);
  // N1 = -omega1~ J_all_1 omega1 + r_thruster_~ F_thruster_: applied less inertia moment about the body origin, body
  //   axes [N m]
  const T minus_N1_1 = T(10.32) * U1_23 + T(0.3) * (t1_15 - t1_13) - T(0.1) * U1_12 - T(0.2) * U1_13;
  const T minus_N1_2 = T(0.2) * U1_23 - (T(3.34) * U1_13 + T(0.1) * (t1_13 - t1_14)) - T(0.3) * U1_12;
  const T minus_N1_3 = T(0.1) * u.thrust + T(0.2) * (t1_14 - t1_15) - T(6.9799999999999995) * U1_12 + T(0.3) * U1_13 +
      T(0.1) * U1_23;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot2_3 = thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U2_12 = omega2_2 * omega2_1 + minus_omegadot2_3;
  const T minus_U2_22 = omega2_3 * omega2_3 + omega2_1 * omega2_1;
  const T U2_23 = omega2_3 * omega2_2;
  // Pddot2 = E2 U1 q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot2_1 = U1_12 * T(0.6);
  const T t2_1 = minus_U1_22 * T(0.6);
  const T t2_2 = U1_23 * T(0.6);
  const T Pddot2_3 = E2_23 * t2_1 + E2_22 * t2_2;
  // effort_left_panel_2 = -theta2 k_left_panel_ - thetadot2 c_left_panel_: along the coordinate [N m], [N]
  const T minus_effort_left_panel_2 = theta2 * c.p.k + thetadot2 * c.p.c;
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_12 * T(9);
  const T G2_2 = minus_U2_22 * T(9);
  const T minus_G2_3 = U2_23 * T(9);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(9) * Pddot2_3 + T(12) * U2_23;
  const T t2_3 = T(9) * Pddot2_1;
  const T N2_3 = t2_3 + T(12) * U2_12;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // omegadot3 = -thetadot3 b3~ E3 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot3_3 = thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U3_12 = omega3_2 * omega3_1 + minus_omegadot3_3;
  const T minus_U3_22 = omega3_3 * omega3_3 + omega3_1 * omega3_1;
  const T U3_23 = omega3_3 * omega3_2;
  // Pddot3 = E3 U1 q3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot3_3 = E3_23 * t2_1 + E3_22 * t2_2;
  // effort_right_panel_3 = -theta3 k_right_panel_ - thetadot3 c_right_panel_: along the coordinate [N m], [N]
  const T minus_effort_right_panel_3 = theta3 * c.p.k + thetadot3 * c.p.c;
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T G3_1 = U3_12 * T(9);
  const T minus_G3_2 = minus_U3_22 * T(9);
  const T G3_3 = U3_23 * T(9);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(9) * minus_Pddot3_3 + T(12) * U3_23;
  const T N3_3 = t2_3 + T(12) * U3_12;

  // ---- body 4 (wheel) on body 1
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T E4_11 = T(0.3333333333333334) + t4_1 * T(0.6666666666666666);
  const T t4_2 = sines[6] * T(0.5773502691896257);
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
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment about the body origin, body axes [N m]
  const T minus_N4_1 = T(0.0079) * U4_32 - T(0.0079) * U4_23 - T(0.0021) * (minus_U4_22 - minus_U4_33) - T(0.0021) *
      U4_31 + T(0.0021) * U4_21;
  const T minus_N4_2 = T(0.0079) * U4_13 - T(0.0079) * U4_31 - T(0.0021) * (minus_U4_33 - minus_U4_11) - T(0.0021) *
      U4_12 + T(0.0021) * U4_32;
  const T minus_N4_3 = T(0.0079) * U4_21 - T(0.0079) * U4_12 - T(0.0021) * (minus_U4_11 - minus_U4_22) - T(0.0021) *
      U4_23 + T(0.0021) * U4_13;

  // ---- body 4 (wheel) and what it carries
  // u_4 = b4 . N4 + tau_wheel_: drives it [N m], [N]
  const T u_4 = u.wheel_torque - T(0.5773502691896257) * minus_N4_1 - T(0.5773502691896257) * minus_N4_2 -
      T(0.5773502691896257) * minus_N4_3;
  // v4 = invD4 u_4: u/D
  const T v4 = T(50) * u_4;
  // nt4 = N4 - v4 K4: moment with the turn solved [N m]
  const T b4_1 = v4 * T(0.011547005383792516);
  const T minus_nt4_1 = b4_1 + minus_N4_1;
  const T minus_nt4_2 = b4_1 + minus_N4_2;
  const T minus_nt4_3 = b4_1 + minus_N4_3;
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_2 = E4_13 * T(0.004566666666666667);
  const T b4_3 = E4_12 * T(0.004566666666666667);
  const T b4_4 = E4_11 * T(0.009133333333333334) - (b4_2 + b4_3);
  const T b4_5 = b4_4 * E4_11;
  const T b4_6 = E4_11 * T(0.004566666666666667);
  const T b4_7 = E4_13 * T(0.009133333333333334) - (b4_3 + b4_6);
  const T b4_8 = b4_7 * E4_13;
  const T b4_9 = E4_12 * T(0.009133333333333334) - (b4_2 + b4_6);
  const T b4_10 = b4_9 * E4_12;
  const T Jp4_11 = b4_5 + b4_8 + b4_10;
  const T b4_11 = b4_4 * E4_12;
  const T b4_12 = b4_7 * E4_11;
  const T b4_13 = b4_9 * E4_13;
  const T Jp4_12 = b4_11 + b4_12 + b4_13;
  const T Jp4_13 = b4_4 * E4_13 + b4_7 * E4_12 + b4_9 * E4_11;
  const T Jp4_22 = b4_10 + b4_5 + b4_8;
  const T Jp4_23 = b4_13 + b4_11 + b4_12;
  const T Jp4_33 = T(0.027400000000000004) - Jp4_11 - Jp4_22;
  // np4 = E4^T nt4: moment passed on, lower body's axes [N m]
  const T minus_np4_1 = E4_11 * minus_nt4_1 + E4_13 * minus_nt4_2 + E4_12 * minus_nt4_3;
  const T minus_np4_2 = E4_12 * minus_nt4_1 + E4_11 * minus_nt4_2 + E4_13 * minus_nt4_3;
  const T minus_np4_3 = E4_13 * minus_nt4_1 + E4_12 * minus_nt4_2 + E4_11 * minus_nt4_3;

  // ---- body 3 (right_panel) and what it carries
  // u_3 = b3 . N3 + effort_right_panel_3: drives it [N m], [N]
  const T minus_u_3 = minus_effort_right_panel_3 + minus_N3_1;
  // v3 = invD3 u_3: u/D
  const T minus_v3 = T(0.08333333333333333) * minus_u_3;
  // gt3 = G3 - v3 B3: force with the turn solved [N]
  const T gt3_3 = G3_3 - minus_v3 * T(9);
  // Mp3 = E3^T M3 E3: M passed on, lower body's axes [kg]
  const T b3_1 = E3_23 * T(6.75);
  const T minus_Mp3_22 = E3_23 * b3_1;
  const T Mp3_23 = E3_22 * b3_1;
  const T Mp3_33 = minus_Mp3_22 - T(6.75);
  // gp3 = E3^T gt3: force passed on, lower body's axes [N]
  const T minus_gp3_2 = E3_22 * minus_G3_2 + E3_23 * gt3_3;
  const T gp3_3 = E3_22 * gt3_3 - E3_23 * minus_G3_2;
  // Hp3 = E3^T H3 E3: H passed on, lower body's axes [kg m]
  const T minus_Hp3_21 = E3_23 * T(9);
  const T Hp3_31 = E3_22 * T(9);
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_2 = E3_23 * T(12);
  const T Jp3_22 = E3_23 * b3_2;
  const T minus_Jp3_23 = E3_22 * b3_2;
  const T Jp3_33 = T(12) - Jp3_22;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T minus_np3_2 = E3_23 * N3_3;
  const T np3_3 = E3_22 * N3_3;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T minus_Hb3_12 = T(0.6) * Mp3_23;
  const T minus_Hb3_13 = T(0.6) * Mp3_33;

  // ---- body 2 (left_panel) and what it carries
  // u_2 = b2 . N2 + effort_left_panel_2: drives it [N m], [N]
  const T minus_u_2 = minus_effort_left_panel_2 + minus_N2_1;
  // v2 = invD2 u_2: u/D
  const T minus_v2 = T(0.08333333333333333) * minus_u_2;
  // gt2 = G2 - v2 B2: force with the turn solved [N]
  const T gt2_3 = minus_v2 * T(9) - minus_G2_3;
  // Mp2 = E2^T M2 E2: M passed on, lower body's axes [kg]
  const T b2_1 = E2_23 * T(6.75);
  const T minus_Mp2_22 = E2_23 * b2_1;
  const T Mp2_23 = E2_22 * b2_1;
  const T Mp2_33 = minus_Mp2_22 - T(6.75);
  // gp2 = E2^T gt2: force passed on, lower body's axes [N]
  const T gp2_2 = E2_22 * G2_2 - E2_23 * gt2_3;
  const T gp2_3 = E2_23 * G2_2 + E2_22 * gt2_3;
  // Hp2 = E2^T H2 E2: H passed on, lower body's axes [kg m]
  const T Hp2_21 = E2_23 * T(9);
  const T minus_Hp2_31 = E2_22 * T(9);
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T b2_2 = E2_23 * T(12);
  const T Jp2_22 = E2_23 * b2_2;
  const T minus_Jp2_23 = E2_22 * b2_2;
  const T Jp2_33 = T(12) - Jp2_22;
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T minus_np2_2 = E2_23 * N2_3;
  const T np2_3 = E2_22 * N2_3;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T Hb2_12 = T(0.6) * Mp2_23;
  const T Hb2_13 = T(0.6) * Mp2_33;

  // ---- body 1 (hub) and what it carries
  // MA1 = m_all_1 one + Mp3 + Mp2: force for an acceleration of the origin, home axes [kg]
  const T MA1_22 = T(142) - minus_Mp3_22 - minus_Mp2_22;
  const T MA1_23 = Mp3_23 + Mp2_23;
  const T MA1_33 = T(142) + Mp3_33 + Mp2_33;
  // HA1 = h_all_1~ + Hb2 + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA1_12 = Hb2_12 + T(0.8) - minus_Hb3_12;
  const T HA1_13 = Hb2_13 - minus_Hb3_13;
  const T HA1_21 = Hp2_21 - T(0.8) - minus_Hp3_21;
  const T HA1_31 = Hp3_31 - minus_Hp2_31;
  // JA1 = q2~ Hp2^T + q3~ Hp3^T + J_all_1 + Jp4 + Jp3 + Jp2 - Hb2 q2~ - Hb3 q3~: moment for an angular acceleration,
  //   body axes [kg m^2]
  const T JA1_11 = T(22.64) + Jp4_11 + Hb2_13 * T(0.6) + minus_Hb3_13 * T(0.6);
  const T JA1_12 = T(0.2) + Jp4_12;
  const T JA1_13 = Jp4_13 - T(0.1);
  const T JA1_22 = T(15.66) + Jp4_22 + Jp3_22 + Jp2_22;
  const T JA1_23 = T(0.3) + Jp4_23 - minus_Jp3_23 - minus_Jp2_23 - T(0.6) * Hp2_21 - T(0.6) * minus_Hp3_21;
  const T JA1_33 = T(25.98) + Jp4_33 + Jp3_33 + Jp2_33 + T(1.2) * minus_Hp2_31 + T(1.2) * Hp3_31;
  // g1 = G1 + gp3 + gp2: force that drives it, home axes [N]
  const T g1_1 = G1_1 + G3_1 - minus_G2_1;
  const T g1_2 = gp2_2 - minus_gp3_2 + G1_2;
  const T g1_3 = gp3_3 + gp2_3 - minus_G1_3;
  // n1 = q2~ gp2 + q3~ gp3 + N1 + np4 + np3 + np2: moment that drives it, body axes [N m]
  const T n1_1 = minus_effort_right_panel_3 - (minus_N1_1 + minus_np4_1) + minus_effort_left_panel_2 + T(0.6) * gp2_3
      - T(0.6) * gp3_3;
  const T minus_n1_2 = minus_N1_2 + minus_np4_2 + minus_np3_2 + minus_np2_2;
  const T n1_3 = T(0.6) * minus_G2_1 - (minus_N1_3 + minus_np4_3) + T(0.6) * G3_1 + np3_3 + np2_3;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T LD1_21 = LD1_11 * JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - LD1_21 * JA1_12);
  const T LD1_31 = LD1_11 * JA1_13;
  const T b1_1 = JA1_23 - LD1_21 * JA1_13;
  const T LD1_32 = LD1_22 * b1_1;
  const T LD1_33 = T(1) / (JA1_33 - LD1_31 * JA1_13 - LD1_32 * b1_1);
  // Y1 = L(LD1)^-1 HA1: L^-1 HA
  const T minus_Y1_22 = LD1_21 * HA1_12;
  const T minus_Y1_23 = LD1_21 * HA1_13;
  const T Y1_31 = HA1_31 - LD1_32 * HA1_21;
  const T Y1_32 = LD1_32 * minus_Y1_22 - LD1_31 * HA1_12;
  const T Y1_33 = LD1_32 * minus_Y1_23 - LD1_31 * HA1_13;
  // W1 = D(LD1)^-1 Y1: D^-1 L^-1 HA
  const T W1_12 = LD1_11 * HA1_12;
  const T W1_13 = LD1_11 * HA1_13;
  const T W1_21 = LD1_22 * HA1_21;
  const T minus_W1_22 = LD1_22 * minus_Y1_22;
  const T minus_W1_23 = LD1_22 * minus_Y1_23;
  const T W1_31 = LD1_33 * Y1_31;
  const T W1_32 = LD1_33 * Y1_32;
  const T W1_33 = LD1_33 * Y1_33;
  // w_1 = D(LD1)^-1 L(LD1)^-1 n1: D^-1 L^-1 n
  const T w_1_1 = LD1_11 * n1_1;
  const T b1_2 = minus_n1_2 + LD1_21 * n1_1;
  const T minus_w_1_2 = LD1_22 * b1_2;
  const T w_1_3 = LD1_33 * (n1_3 - LD1_31 * n1_1 + LD1_32 * b1_2);
  // M1 = MA1 - Y1^T W1: MA less what the ball takes up [kg]
  const T M1_11 = T(142) - HA1_21 * W1_21 - Y1_31 * W1_31;
  const T minus_M1_12 = Y1_31 * W1_32 - HA1_21 * minus_W1_22;
  const T minus_M1_13 = Y1_31 * W1_33 - HA1_21 * minus_W1_23;
  const T M1_22 = MA1_22 - HA1_12 * W1_12 - minus_Y1_22 * minus_W1_22 - Y1_32 * W1_32;
  const T M1_23 = MA1_23 - HA1_12 * W1_13 - minus_Y1_22 * minus_W1_23 - Y1_32 * W1_33;
  const T M1_33 = MA1_33 - HA1_13 * W1_13 - minus_Y1_23 * minus_W1_23 - Y1_33 * W1_33;
  // gb1 = g1 - Y1^T w_1: force with the ball solved [N]
  const T gb1_1 = g1_1 + HA1_21 * minus_w_1_2 - Y1_31 * w_1_3;
  const T gb1_2 = g1_2 - HA1_12 * w_1_1 - minus_Y1_22 * minus_w_1_2 - Y1_32 * w_1_3;
  const T gb1_3 = g1_3 - HA1_13 * w_1_1 - minus_Y1_23 * minus_w_1_2 - Y1_33 * w_1_3;
  // LDs1 = L D L^T of M1: L D L^T = M: L, and 1/D on the diagonal
  const T LDs1_11 = T(1) / M1_11;
  const T minus_LDs1_21 = LDs1_11 * minus_M1_12;
  const T LDs1_22 = T(1) / (M1_22 - minus_LDs1_21 * minus_M1_12);
  const T minus_LDs1_31 = LDs1_11 * minus_M1_13;
  const T b1_3 = M1_23 - minus_LDs1_21 * minus_M1_13;
  const T LDs1_32 = LDs1_22 * b1_3;
  const T LDs1_33 = T(1) / (M1_33 - minus_LDs1_31 * minus_M1_13 - LDs1_32 * b1_3);
  // ws1 = D(LDs1)^-1 L(LDs1)^-1 gb1: D^-1 L^-1 g
  const T ws1_1 = LDs1_11 * gb1_1;
  const T b1_4 = gb1_2 + minus_LDs1_21 * gb1_1;
  const T ws1_2 = LDs1_22 * b1_4;
  const T ws1_3 = LDs1_33 * (gb1_3 + minus_LDs1_31 * gb1_1 - LDs1_32 * b1_4);

  // ---- body 1 (hub), solved
  // Pddot1 = L(LDs1)^-T ws1
  const T z1_1 = ws1_2 - LDs1_32 * ws1_3;
  const T Pddot1_1 = ws1_1 + minus_LDs1_21 * z1_1 + minus_LDs1_31 * ws1_3;
  // omegadot1 = L(LD1)^-T (-W1 Pddot1 + w_1)
  const T z1_2 = w_1_3 - W1_31 * Pddot1_1 - W1_32 * z1_1 - W1_33 * ws1_3;
  const T z1_3 = minus_w_1_2 + W1_21 * Pddot1_1 - minus_W1_22 * z1_1 - minus_W1_23 * ws1_3 + LD1_32 * z1_2;
  const T omegadot1_1 = w_1_1 - W1_12 * z1_1 - W1_13 * ws1_3 + LD1_21 * z1_3 - LD1_31 * z1_2;
  ydot[0] = omegadot1_1;
  ydot[1] = -z1_3;
  ydot[2] = z1_2;
  // sddot1 = R1^T Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_1 = R1_11 * Pddot1_1 + R1_21 * z1_1 + R1_31 * ws1_3;
  const T sddot1_2 = R1_12 * Pddot1_1 + R1_22 * z1_1 + R1_32 * ws1_3;
  const T sddot1_3 = R1_13 * Pddot1_1 + R1_23 * z1_1 + R1_33 * ws1_3;
  ydot[6] = sddot1_1;
  ydot[7] = sddot1_2;
  ydot[8] = sddot1_3;

  // ---- body 2 (left_panel), solved
  // beta2 = -E2 q2~ omegadot1 + E2 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z2_1 = T(0.6) * omegadot1_1;
  const T beta2_3 = E2_22 * ws1_3 - E2_23 * z1_1 + E2_22 * z2_1;
  // phi2 = -kB2 . beta2 + v2 - (P_b2 kK2) . alphaL2
  const T minus_phi2 = minus_v2 + T(0.75) * beta2_3;
  // thetaddot2 = -b2 . alphaL2 + phi2
  const T minus_thetaddot2 = omegadot1_1 + minus_phi2;
  ydot[3] = -minus_thetaddot2;

  // ---- body 3 (right_panel), solved
  // beta3 = -E3 q3~ omegadot1 + E3 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta3_3 = E3_22 * ws1_3 - E3_23 * z1_1 - E3_22 * z2_1;
  // phi3 = -kB3 . beta3 + v3 - (P_b3 kK3) . alphaL3
  const T phi3 = T(0.75) * beta3_3 - minus_v3;
  // thetaddot3 = -b3 . alphaL3 + phi3
  const T thetaddot3 = phi3 - omegadot1_1;
  ydot[4] = thetaddot3;

  // ---- body 4 (wheel), solved
  // alphaL4 = E4 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4_1 = E4_11 * omegadot1_1 - E4_12 * z1_3 + E4_13 * z1_2;
  const T alphaL4_2 = E4_13 * omegadot1_1 - E4_11 * z1_3 + E4_12 * z1_2;
  const T alphaL4_3 = E4_12 * omegadot1_1 - E4_13 * z1_3 + E4_11 * z1_2;
  // phi4 = -kK4 . alphaL4 + v4
  const T phi4 = v4 - T(0.5773502691896258) * alphaL4_1 - T(0.5773502691896258) * alphaL4_2 - T(0.5773502691896258) *
      alphaL4_3;
  ydot[5] = phi4;

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
// 1444 add, 1785 multiply, 6 divide, 6 sine or cosine
// by: articulated; composite would take 253 add, 304 multiply, 6 divide, 6 sine or cosine
template <class T>
void state_matrix(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* S) noexcept {
  for (int i = 0; i < 324; ++i) S[i] = T(0);
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 3, cosines + 4, sines + 4);

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
  const T U1_12 = omega1_2 * omega1_1;
  const T U1_13 = omega1_3 * omega1_1;
  const T t1_13 = omega1_3 * omega1_3;
  const T t1_14 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_14;
  const T U1_23 = omega1_3 * omega1_2;
  const T t1_15 = omega1_2 * omega1_2;
  const T minus_U1_33 = t1_15 + t1_14;
  // G1 = -U1 h_all_1 + F_thruster_: applied less inertia force, body axes [N]
  const T G1_1 = u.thrust + U1_13 * T(0.8);
  const T G1_2 = U1_23 * T(0.8);
  const T minus_G1_3 = minus_U1_33 * T(0.8);
  // N1 = -omega1~ J_all_1 omega1 + r_thruster_~ F_thruster_: applied less inertia moment about the body origin, body
  //   axes [N m]
  const T minus_N1_1 = T(10.32) * U1_23 + T(0.3) * (t1_15 - t1_13) - T(0.1) * U1_12 - T(0.2) * U1_13;
  const T minus_N1_2 = T(0.2) * U1_23 - (T(3.34) * U1_13 + T(0.1) * (t1_13 - t1_14)) - T(0.3) * U1_12;
  const T minus_N1_3 = T(0.1) * u.thrust + T(0.2) * (t1_14 - t1_15) - T(6.9799999999999995) * U1_12 + T(0.3) * U1_13 +
      T(0.1) * U1_23;

  // ---- body 2 (left_panel) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = thetadot2 + omega1_1;
  const T omega2_2 = E2_22 * omega1_2 + E2_23 * omega1_3;
  const T omega2_3 = E2_22 * omega1_3 - E2_23 * omega1_2;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_2 = thetadot2 * omega2_3;
  const T minus_omegadot2_3 = thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U2_12 = omega2_2 * omega2_1 + minus_omegadot2_3;
  const T U2_13 = omega2_3 * omega2_1 + omegadot2_2;
  const T t2_1 = omega2_3 * omega2_3;
  const T minus_U2_22 = t2_1 + omega2_1 * omega2_1;
  const T U2_23 = omega2_3 * omega2_2;
  // Pddot2 = E2 U1 q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot2_1 = U1_12 * T(0.6);
  const T t2_2 = U1_23 * T(0.6);
  const T t2_3 = minus_U1_22 * T(0.6);
  const T Pddot2_2 = E2_23 * t2_2 - E2_22 * t2_3;
  const T Pddot2_3 = E2_23 * t2_3 + E2_22 * t2_2;
  // effort_left_panel_2 = -theta2 k_left_panel_ - thetadot2 c_left_panel_: along the coordinate [N m], [N]
  const T minus_effort_left_panel_2 = theta2 * c.p.k + thetadot2 * c.p.c;
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_12 * T(9);
  const T G2_2 = minus_U2_22 * T(9);
  const T minus_G2_3 = U2_23 * T(9);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(9) * Pddot2_3 + T(12) * U2_23;
  const T t2_4 = T(9) * Pddot2_1;
  const T N2_3 = t2_4 + T(12) * U2_12;

  // ---- body 3 (right_panel) on body 1
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega1_1;
  const T omega3_2 = E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = E3_22 * omega1_3 - E3_23 * omega1_2;
  // omegadot3 = -thetadot3 b3~ E3 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot3_2 = thetadot3 * omega3_3;
  const T minus_omegadot3_3 = thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U3_12 = omega3_2 * omega3_1 + minus_omegadot3_3;
  const T U3_13 = omega3_3 * omega3_1 + omegadot3_2;
  const T t3_1 = omega3_3 * omega3_3;
  const T minus_U3_22 = t3_1 + omega3_1 * omega3_1;
  const T U3_23 = omega3_3 * omega3_2;
  // Pddot3 = E3 U1 q3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot3_2 = E3_22 * t2_3 - E3_23 * t2_2;
  const T minus_Pddot3_3 = E3_23 * t2_3 + E3_22 * t2_2;
  // effort_right_panel_3 = -theta3 k_right_panel_ - thetadot3 c_right_panel_: along the coordinate [N m], [N]
  const T minus_effort_right_panel_3 = theta3 * c.p.k + thetadot3 * c.p.c;
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T G3_1 = U3_12 * T(9);
  const T minus_G3_2 = minus_U3_22 * T(9);
  const T G3_3 = U3_23 * T(9);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(9) * minus_Pddot3_3 + T(12) * U3_23;
  const T N3_3 = t2_4 + T(12) * U3_12;

  // ---- body 4 (wheel) on body 1
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T E4_11 = T(0.3333333333333334) + t4_1 * T(0.6666666666666666);
  const T t4_2 = sines[6];
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
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment about the body origin, body axes [N m]
  const T minus_N4_1 = T(0.0079) * U4_32 - T(0.0079) * U4_23 - T(0.0021) * (minus_U4_22 - minus_U4_33) - T(0.0021) *
      U4_31 + T(0.0021) * U4_21;
  const T minus_N4_2 = T(0.0079) * U4_13 - T(0.0079) * U4_31 - T(0.0021) * (minus_U4_33 - minus_U4_11) - T(0.0021) *
      U4_12 + T(0.0021) * U4_32;
  const T minus_N4_3 = T(0.0079) * U4_21 - T(0.0079) * U4_12 - T(0.0021) * (minus_U4_11 - minus_U4_22) - T(0.0021) *
      U4_23 + T(0.0021) * U4_13;

  // ---- body 4 (wheel) and what it carries
  // u_4 = b4 . N4 + tau_wheel_: drives it [N m], [N]
  const T u_4 = u.wheel_torque - T(0.5773502691896257) * minus_N4_1 - T(0.5773502691896257) * minus_N4_2 -
      T(0.5773502691896257) * minus_N4_3;
  // v4 = invD4 u_4: u/D
  const T v4 = T(50) * u_4;
  // nt4 = N4 - v4 K4: moment with the turn solved [N m]
  const T b4_1 = v4 * T(0.011547005383792516);
  const T minus_nt4_1 = b4_1 + minus_N4_1;
  const T minus_nt4_2 = b4_1 + minus_N4_2;
  const T minus_nt4_3 = b4_1 + minus_N4_3;
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_2 = E4_13 * T(0.004566666666666667);
  const T b4_3 = E4_12 * T(0.004566666666666667);
  const T b4_4 = E4_11 * T(0.009133333333333334) - (b4_2 + b4_3);
  const T b4_5 = b4_4 * E4_11;
  const T b4_6 = E4_11 * T(0.004566666666666667);
  const T b4_7 = E4_13 * T(0.009133333333333334) - (b4_3 + b4_6);
  const T b4_8 = b4_7 * E4_13;
  const T b4_9 = E4_12 * T(0.009133333333333334) - (b4_2 + b4_6);
  const T b4_10 = b4_9 * E4_12;
  const T Jp4_11 = b4_5 + b4_8 + b4_10;
  const T b4_11 = b4_4 * E4_12;
  const T b4_12 = b4_7 * E4_11;
  const T b4_13 = b4_9 * E4_13;
  const T Jp4_12 = b4_11 + b4_12 + b4_13;
  const T Jp4_13 = b4_4 * E4_13 + b4_7 * E4_12 + b4_9 * E4_11;
  const T Jp4_22 = b4_10 + b4_5 + b4_8;
  const T Jp4_23 = b4_13 + b4_11 + b4_12;
  const T Jp4_33 = T(0.027400000000000004) - Jp4_11 - Jp4_22;
  // np4 = E4^T nt4: moment passed on, lower body's axes [N m]
  const T minus_np4_1 = E4_11 * minus_nt4_1 + E4_13 * minus_nt4_2 + E4_12 * minus_nt4_3;
  const T minus_np4_2 = E4_12 * minus_nt4_1 + E4_11 * minus_nt4_2 + E4_13 * minus_nt4_3;
  const T minus_np4_3 = E4_13 * minus_nt4_1 + E4_12 * minus_nt4_2 + E4_11 * minus_nt4_3;

  // ---- body 3 (right_panel) and what it carries
  // u_3 = b3 . N3 + effort_right_panel_3: drives it [N m], [N]
  const T minus_u_3 = minus_effort_right_panel_3 + minus_N3_1;
  // v3 = invD3 u_3: u/D
  const T minus_v3 = T(0.08333333333333333) * minus_u_3;
  // gt3 = G3 - v3 B3: force with the turn solved [N]
  const T gt3_3 = G3_3 - minus_v3 * T(9);
  // Mp3 = E3^T M3 E3: M passed on, lower body's axes [kg]
  const T b3_1 = E3_23 * T(6.75);
  const T minus_Mp3_22 = E3_23 * b3_1;
  const T Mp3_23 = E3_22 * b3_1;
  const T Mp3_33 = minus_Mp3_22 - T(6.75);
  // gp3 = E3^T gt3: force passed on, lower body's axes [N]
  const T minus_gp3_2 = E3_22 * minus_G3_2 + E3_23 * gt3_3;
  const T gp3_3 = E3_22 * gt3_3 - E3_23 * minus_G3_2;
  // Hp3 = E3^T H3 E3: H passed on, lower body's axes [kg m]
  const T minus_Hp3_21 = E3_23 * T(9);
  const T Hp3_31 = E3_22 * T(9);
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_2 = E3_23 * T(12);
  const T Jp3_22 = E3_23 * b3_2;
  const T minus_Jp3_23 = E3_22 * b3_2;
  const T Jp3_33 = T(12) - Jp3_22;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T minus_np3_2 = E3_23 * N3_3;
  const T np3_3 = E3_22 * N3_3;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T minus_Hb3_12 = T(0.6) * Mp3_23;
  const T minus_Hb3_13 = T(0.6) * Mp3_33;

  // ---- body 2 (left_panel) and what it carries
  // u_2 = b2 . N2 + effort_left_panel_2: drives it [N m], [N]
  const T minus_u_2 = minus_effort_left_panel_2 + minus_N2_1;
  // v2 = invD2 u_2: u/D
  const T minus_v2 = T(0.08333333333333333) * minus_u_2;
  // gt2 = G2 - v2 B2: force with the turn solved [N]
  const T gt2_3 = minus_v2 * T(9) - minus_G2_3;
  // Mp2 = E2^T M2 E2: M passed on, lower body's axes [kg]
  const T b2_1 = E2_23 * T(6.75);
  const T minus_Mp2_22 = E2_23 * b2_1;
  const T Mp2_23 = E2_22 * b2_1;
  const T Mp2_33 = minus_Mp2_22 - T(6.75);
  // gp2 = E2^T gt2: force passed on, lower body's axes [N]
  const T gp2_2 = E2_22 * G2_2 - E2_23 * gt2_3;
  const T gp2_3 = E2_23 * G2_2 + E2_22 * gt2_3;
  // Hp2 = E2^T H2 E2: H passed on, lower body's axes [kg m]
  const T Hp2_21 = E2_23 * T(9);
  const T minus_Hp2_31 = E2_22 * T(9);
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T b2_2 = E2_23 * T(12);
  const T Jp2_22 = E2_23 * b2_2;
  const T minus_Jp2_23 = E2_22 * b2_2;
  const T Jp2_33 = T(12) - Jp2_22;
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T minus_np2_2 = E2_23 * N2_3;
  const T np2_3 = E2_22 * N2_3;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T Hb2_12 = T(0.6) * Mp2_23;
  const T Hb2_13 = T(0.6) * Mp2_33;

  // ---- body 1 (hub) and what it carries
  // MA1 = m_all_1 one + Mp3 + Mp2: force for an acceleration of the origin, home axes [kg]
  const T MA1_22 = T(142) - minus_Mp3_22 - minus_Mp2_22;
  const T MA1_23 = Mp3_23 + Mp2_23;
  const T MA1_33 = T(142) + Mp3_33 + Mp2_33;
  // HA1 = h_all_1~ + Hb2 + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA1_12 = Hb2_12 + T(0.8) - minus_Hb3_12;
  const T HA1_13 = Hb2_13 - minus_Hb3_13;
  const T HA1_21 = Hp2_21 - T(0.8) - minus_Hp3_21;
  const T HA1_31 = Hp3_31 - minus_Hp2_31;
  // JA1 = q2~ Hp2^T + q3~ Hp3^T + J_all_1 + Jp4 + Jp3 + Jp2 - Hb2 q2~ - Hb3 q3~: moment for an angular acceleration,
  //   body axes [kg m^2]
  const T JA1_11 = T(22.64) + Jp4_11 + Hb2_13 * T(0.6) + minus_Hb3_13 * T(0.6);
  const T JA1_12 = T(0.2) + Jp4_12;
  const T JA1_13 = Jp4_13 - T(0.1);
  const T JA1_22 = T(15.66) + Jp4_22 + Jp3_22 + Jp2_22;
  const T JA1_23 = T(0.3) + Jp4_23 - minus_Jp3_23 - minus_Jp2_23 - T(0.6) * Hp2_21 - T(0.6) * minus_Hp3_21;
  const T JA1_33 = T(25.98) + Jp4_33 + Jp3_33 + Jp2_33 + T(1.2) * minus_Hp2_31 + T(1.2) * Hp3_31;
  // g1 = G1 + gp3 + gp2: force that drives it, home axes [N]
  const T g1_1 = G1_1 + G3_1 - minus_G2_1;
  const T g1_2 = gp2_2 - minus_gp3_2 + G1_2;
  const T g1_3 = gp3_3 + gp2_3 - minus_G1_3;
  // n1 = q2~ gp2 + q3~ gp3 + N1 + np4 + np3 + np2: moment that drives it, body axes [N m]
  const T n1_1 = minus_effort_right_panel_3 - (minus_N1_1 + minus_np4_1) + minus_effort_left_panel_2 + T(0.6) * gp2_3
      - T(0.6) * gp3_3;
  const T minus_n1_2 = minus_N1_2 + minus_np4_2 + minus_np3_2 + minus_np2_2;
  const T n1_3 = np3_3 - (minus_N1_3 + minus_np4_3) + np2_3 + T(0.6) * minus_G2_1 + T(0.6) * G3_1;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T LD1_21 = LD1_11 * JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - LD1_21 * JA1_12);
  const T LD1_31 = LD1_11 * JA1_13;
  const T b1_1 = JA1_23 - LD1_21 * JA1_13;
  const T LD1_32 = LD1_22 * b1_1;
  const T LD1_33 = T(1) / (JA1_33 - LD1_31 * JA1_13 - LD1_32 * b1_1);
  // Y1 = L(LD1)^-1 HA1: L^-1 HA
  const T minus_Y1_22 = LD1_21 * HA1_12;
  const T minus_Y1_23 = LD1_21 * HA1_13;
  const T Y1_31 = HA1_31 - LD1_32 * HA1_21;
  const T Y1_32 = LD1_32 * minus_Y1_22 - LD1_31 * HA1_12;
  const T Y1_33 = LD1_32 * minus_Y1_23 - LD1_31 * HA1_13;
  // W1 = D(LD1)^-1 Y1: D^-1 L^-1 HA
  const T W1_12 = LD1_11 * HA1_12;
  const T W1_13 = LD1_11 * HA1_13;
  const T W1_21 = LD1_22 * HA1_21;
  const T minus_W1_22 = LD1_22 * minus_Y1_22;
  const T minus_W1_23 = LD1_22 * minus_Y1_23;
  const T W1_31 = LD1_33 * Y1_31;
  const T W1_32 = LD1_33 * Y1_32;
  const T W1_33 = LD1_33 * Y1_33;
  // w_1 = D(LD1)^-1 L(LD1)^-1 n1: D^-1 L^-1 n
  const T w_1_1 = LD1_11 * n1_1;
  const T b1_2 = minus_n1_2 + LD1_21 * n1_1;
  const T minus_w_1_2 = LD1_22 * b1_2;
  const T b1_3 = n1_3 - LD1_31 * n1_1 + LD1_32 * b1_2;
  const T w_1_3 = LD1_33 * b1_3;
  // M1 = MA1 - Y1^T W1: MA less what the ball takes up [kg]
  const T M1_11 = T(142) - HA1_21 * W1_21 - Y1_31 * W1_31;
  const T minus_M1_12 = Y1_31 * W1_32 - HA1_21 * minus_W1_22;
  const T minus_M1_13 = Y1_31 * W1_33 - HA1_21 * minus_W1_23;
  const T M1_22 = MA1_22 - HA1_12 * W1_12 - minus_Y1_22 * minus_W1_22 - Y1_32 * W1_32;
  const T M1_23 = MA1_23 - HA1_12 * W1_13 - minus_Y1_22 * minus_W1_23 - Y1_32 * W1_33;
  const T M1_33 = MA1_33 - HA1_13 * W1_13 - minus_Y1_23 * minus_W1_23 - Y1_33 * W1_33;
  // gb1 = g1 - Y1^T w_1: force with the ball solved [N]
  const T gb1_1 = g1_1 + HA1_21 * minus_w_1_2 - Y1_31 * w_1_3;
  const T gb1_2 = g1_2 - HA1_12 * w_1_1 - minus_Y1_22 * minus_w_1_2 - Y1_32 * w_1_3;
  const T gb1_3 = g1_3 - HA1_13 * w_1_1 - minus_Y1_23 * minus_w_1_2 - Y1_33 * w_1_3;
  // LDs1 = L D L^T of M1: L D L^T = M: L, and 1/D on the diagonal
  const T LDs1_11 = T(1) / M1_11;
  const T minus_LDs1_21 = LDs1_11 * minus_M1_12;
  const T LDs1_22 = T(1) / (M1_22 - minus_LDs1_21 * minus_M1_12);
  const T minus_LDs1_31 = LDs1_11 * minus_M1_13;
  const T b1_4 = M1_23 - minus_LDs1_21 * minus_M1_13;
  const T LDs1_32 = LDs1_22 * b1_4;
  const T LDs1_33 = T(1) / (M1_33 - minus_LDs1_31 * minus_M1_13 - LDs1_32 * b1_4);
  // ws1 = D(LDs1)^-1 L(LDs1)^-1 gb1: D^-1 L^-1 g
  const T ws1_1 = LDs1_11 * gb1_1;
  const T b1_5 = gb1_2 + minus_LDs1_21 * gb1_1;
  const T ws1_2 = LDs1_22 * b1_5;
  const T b1_6 = gb1_3 + minus_LDs1_31 * gb1_1 - LDs1_32 * b1_5;
  const T ws1_3 = LDs1_33 * b1_6;

  // ---- body 1 (hub), solved
  // Pddot1 = L(LDs1)^-T ws1
  const T z1_1 = ws1_2 - LDs1_32 * ws1_3;
  const T Pddot1_1 = ws1_1 + minus_LDs1_21 * z1_1 + minus_LDs1_31 * ws1_3;
  // omegadot1 = L(LD1)^-T (-W1 Pddot1 + w_1)
  const T z1_2 = w_1_3 - W1_31 * Pddot1_1 - W1_32 * z1_1 - W1_33 * ws1_3;
  const T z1_3 = minus_w_1_2 + W1_21 * Pddot1_1 - minus_W1_22 * z1_1 - minus_W1_23 * ws1_3 + LD1_32 * z1_2;
  const T omegadot1_1 = w_1_1 - W1_12 * z1_1 - W1_13 * ws1_3 + LD1_21 * z1_3 - LD1_31 * z1_2;

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
  const T t1 = T(9) * (U2_23 + U2_23);
  const T t2 = t2_1 - omega2_2 * omega2_2;
  const T t3 = T(0.08333333333333333) * (c.p.k + T(12) * t2 - T(9) * Pddot2_2);
  const T t4 = T(9) * t3 - T(9) * t2;
  const T t5 = gp2_2 - E2_23 * t1 + E2_22 * t4;
  const T t6 = c.p.k + T(0.6) * t5;
  const T t7 = LD1_11 * LD1_11;
  const T t8 = T(6.75) * E2_22;
  const T t9 = Mp2_23 + E2_23 * t8;
  const T t10 = T(0.6) * t9;
  const T t11 = T(0.6) * t10 * t7;
  const T t12 = LD1_11 * t6 - n1_1 * t11;
  const T t13 = JA1_13 * t11;
  const T t14 = T(12) * U2_13;
  const T t15 = T(9) * U2_13;
  const T t16 = T(12) * E2_22;
  const T t17 = JA1_12 * t11;
  const T t18 = Jp2_22 - E2_22 * t16 - T(0.6) * minus_Hp2_31 + JA1_13 * t17;
  const T t19 = LD1_22 * LD1_22;
  const T t20 = minus_Jp2_23 + E2_23 * t16;
  const T t21 = t19 * (t20 + JA1_12 * t17);
  const T t22 = LD1_22 * t18 - b1_1 * t21;
  const T t23 = np2_3 + E2_23 * t14 + LD1_21 * t6 - n1_1 * t17;
  const T t24 = LD1_33 * LD1_33;
  const T t25 = t24 * (JA1_13 * t13 - t20 - T(1.2) * Hp2_21 - b1_1 * t22 - LD1_32 * t18);
  const T t26 = LD1_33 * (n1_1 * t13 - minus_np2_2 - LD1_31 * t6 + E2_22 * t14 + T(0.6) * t15 + b1_2 * t22 + LD1_32 *
      t23) - b1_3 * t25;
  const T t27 = Hp2_21 - HA1_21 * t22 - LD1_32 * minus_Hp2_31;
  const T t28 = LD1_33 * t27 - Y1_31 * t25;
  const T t29 = LDs1_11 * LDs1_11;
  const T t30 = LD1_22 * minus_Hp2_31 - HA1_21 * t21;
  const T t31 = t29 * (HA1_21 * t30 + W1_21 * minus_Hp2_31 + W1_31 * t27 + Y1_31 * t28);
  const T t32 = b1_2 * t21 - LD1_22 * t23;
  const T t33 = t15 + HA1_21 * t32 - minus_w_1_2 * minus_Hp2_31 + w_1_3 * t27 + Y1_31 * t26;
  const T t34 = E2_22 * t8 - minus_Mp2_22;
  const T t35 = T(0.6) * t34;
  const T t36 = LD1_21 * t35 - HA1_12 * t17;
  const T t37 = minus_Y1_22 * t21 - LD1_22 * t36;
  const T t38 = minus_Y1_22 * t22 + LD1_32 * t36 - LD1_31 * t35 + HA1_12 * t13;
  const T t39 = LD1_33 * t38 - Y1_32 * t25;
  const T t40 = HA1_21 * t37 - minus_W1_22 * minus_Hp2_31 + W1_32 * t27 + Y1_31 * t39;
  const T t41 = minus_M1_12 * t31 + LDs1_11 * t40;
  const T t42 = LDs1_22 * LDs1_22;
  const T t43 = LD1_11 * t35 - HA1_12 * t11;
  const T t44 = t42 * (t9 + W1_12 * t35 + HA1_12 * t43 + minus_W1_22 * t36 - minus_Y1_22 * t37 + W1_32 * t38 + Y1_32 *
      t39 + minus_M1_12 * t41 + minus_LDs1_21 * t40);
  const T t45 = LD1_21 * t10 - HA1_13 * t17;
  const T t46 = minus_Y1_23 * t21 - LD1_22 * t45;
  const T t47 = minus_Y1_23 * t22 + LD1_32 * t45 - LD1_31 * t10 + HA1_13 * t13;
  const T t48 = LD1_33 * t47 - Y1_33 * t25;
  const T t49 = HA1_21 * t46 - minus_W1_23 * minus_Hp2_31 + W1_33 * t27 + Y1_31 * t48;
  const T t50 = LD1_11 * t10 - HA1_13 * t11;
  const T t51 = t34 - minus_M1_13 * t41 - minus_LDs1_21 * t49 - W1_13 * t35 - HA1_12 * t50 - minus_W1_23 * t36 +
      minus_Y1_22 * t46 - W1_33 * t38 - Y1_32 * t48;
  const T t52 = b1_4 * t44 + LDs1_22 * t51;
  const T t53 = E2_22 * t1 + gp2_3 + E2_23 * t4 + w_1_1 * t35 + HA1_12 * t12 + minus_w_1_2 * t36 - minus_Y1_22 * t32 +
      w_1_3 * t38 + Y1_32 * t26 + minus_LDs1_21 * t33 - gb1_1 * t41;
  const T t54 = minus_M1_13 * t31 + LDs1_11 * t49;
  const T t55 = LDs1_33 * LDs1_33;
  const T t56 = LDs1_33 * (t5 + LDs1_32 * t53 - b1_5 * t52 - minus_LDs1_31 * t33 + gb1_1 * t54 - w_1_1 * t10 - HA1_13
      * t12 - minus_w_1_2 * t45 + minus_Y1_23 * t32 - w_1_3 * t47 - Y1_33 * t26) - t55 * (t9 - b1_4 * t52 - LDs1_32 *
      t51 - minus_M1_13 * t54 - minus_LDs1_31 * t49 - W1_13 * t10 - HA1_13 * t50 - minus_W1_23 * t45 + minus_Y1_23 *
      t46 - W1_33 * t47 - Y1_33 * t48) * b1_6;
  const T t57 = b1_5 * t44 - (ws1_3 * t52 + LDs1_32 * t56) - LDs1_22 * t53;
  const T t58 = gb1_1 * t31 - LDs1_11 * t33 + z1_1 * t41 + minus_LDs1_21 * t57 + ws1_3 * t54 + minus_LDs1_31 * t56;
  const T t59 = t26 - Pddot1_1 * t28 - W1_31 * t58 - z1_1 * t39 - W1_32 * t57 - ws1_3 * t48 - W1_33 * t56;
  const T t60 = t32 - z1_2 * t22 - LD1_32 * t59 - Pddot1_1 * t30 - W1_21 * t58 - z1_1 * t37 + minus_W1_22 * t57 -
      ws1_3 * t46 + minus_W1_23 * t56;
  const T t61 = t12 + z1_2 * t13 - LD1_31 * t59 - z1_3 * t17 - LD1_21 * t60 - z1_1 * t43 - W1_12 * t57 - ws1_3 * t50 -
      W1_13 * t56;
  S[165] = t61;
  const T t62 = T(9) * (U3_23 + U3_23);
  const T t63 = t3_1 - omega3_2 * omega3_2;
  const T t64 = T(0.08333333333333333) * (c.p.k + T(12) * t63 + T(9) * Pddot3_2);
  const T t65 = T(9) * t63 - T(9) * t64;
  const T t66 = E3_23 * t62 - minus_gp3_2 + E3_22 * t65;
  const T t67 = c.p.k - T(0.6) * t66;
  const T t68 = T(6.75) * E3_22;
  const T t69 = Mp3_23 + E3_23 * t68;
  const T t70 = T(0.6) * t69;
  const T t71 = T(0.6) * t70 * t7;
  const T t72 = LD1_11 * t67 - n1_1 * t71;
  const T t73 = JA1_13 * t71;
  const T t74 = T(12) * U3_13;
  const T t75 = T(9) * U3_13;
  const T t76 = T(12) * E3_22;
  const T t77 = JA1_12 * t71;
  const T t78 = Jp3_22 - E3_22 * t76 - T(0.6) * Hp3_31 + JA1_13 * t77;
  const T t79 = minus_Jp3_23 + E3_23 * t76;
  const T t80 = t19 * (t79 + JA1_12 * t77);
  const T t81 = LD1_22 * t78 - b1_1 * t80;
  const T t82 = np3_3 + E3_23 * t74 + LD1_21 * t67 - n1_1 * t77;
  const T t83 = t24 * (JA1_13 * t73 - t79 - T(1.2) * minus_Hp3_21 - b1_1 * t81 - LD1_32 * t78);
  const T t84 = LD1_33 * (n1_1 * t73 - minus_np3_2 - LD1_31 * t67 + E3_22 * t74 + T(0.6) * t75 + b1_2 * t81 + LD1_32 *
      t82) - b1_3 * t83;
  const T t85 = minus_Hp3_21 + HA1_21 * t81 - LD1_32 * Hp3_31;
  const T t86 = LD1_33 * t85 + Y1_31 * t83;
  const T t87 = E3_22 * t68 - minus_Mp3_22;
  const T t88 = T(0.6) * t87;
  const T t89 = HA1_12 * t77 + LD1_21 * t88;
  const T t90 = minus_Y1_22 * t81 - LD1_32 * t89 + HA1_12 * t73 + LD1_31 * t88;
  const T t91 = LD1_33 * t90 - Y1_32 * t83;
  const T t92 = LD1_11 * t88 + HA1_12 * t71;
  const T t93 = minus_Y1_22 * t80 + LD1_22 * t89;
  const T t94 = HA1_21 * t93 + minus_W1_22 * Hp3_31 + Y1_31 * t91 - W1_32 * t85;
  const T t95 = HA1_21 * t80 + LD1_22 * Hp3_31;
  const T t96 = t29 * (HA1_21 * t95 + W1_21 * Hp3_31 + W1_31 * t85 + Y1_31 * t86);
  const T t97 = minus_M1_12 * t96 - LDs1_11 * t94;
  const T t98 = t42 * (t69 + W1_32 * t90 + Y1_32 * t91 - W1_12 * t88 - HA1_12 * t92 - minus_Y1_22 * t93 - minus_W1_22
      * t89 + minus_LDs1_21 * t94 - minus_M1_12 * t97);
  const T t99 = HA1_13 * t77 + LD1_21 * t70;
  const T t100 = minus_Y1_23 * t80 + LD1_22 * t99;
  const T t101 = minus_Y1_23 * t81 - LD1_32 * t99 + HA1_13 * t73 + LD1_31 * t70;
  const T t102 = LD1_33 * t101 - Y1_33 * t83;
  const T t103 = HA1_21 * t100 + minus_W1_23 * Hp3_31 + Y1_31 * t102 - W1_33 * t85;
  const T t104 = LD1_11 * t70 + HA1_13 * t71;
  const T t105 = t87 + minus_M1_13 * t97 - minus_LDs1_21 * t103 - W1_33 * t90 - Y1_32 * t102 + W1_13 * t88 + HA1_12 *
      t104 + minus_Y1_22 * t100 + minus_W1_23 * t89;
  const T t106 = b1_4 * t98 + LDs1_22 * t105;
  const T t107 = b1_2 * t80 - LD1_22 * t82;
  const T t108 = t75 - HA1_21 * t107 - minus_w_1_2 * Hp3_31 - Y1_31 * t84 + w_1_3 * t85;
  const T t109 = minus_LDs1_21 * t108 - gp3_3 - gb1_1 * t97 - E3_23 * t65 + E3_22 * t62 + minus_Y1_22 * t107 +
      minus_w_1_2 * t89 - HA1_12 * t72 + w_1_1 * t88 - w_1_3 * t90 - Y1_32 * t84;
  const T t110 = minus_M1_13 * t96 - LDs1_11 * t103;
  const T t111 = LDs1_33 * (t66 - b1_5 * t106 - LDs1_32 * t109 - gb1_1 * t110 + minus_LDs1_31 * t108 + minus_w_1_2 *
      t99 + minus_Y1_23 * t107 - HA1_13 * t72 + w_1_1 * t70 - w_1_3 * t101 - Y1_33 * t84) - t55 * (t69 - b1_4 * t106 -
      LDs1_32 * t105 - minus_LDs1_31 * t103 + minus_M1_13 * t110 - W1_33 * t101 - Y1_33 * t102 + W1_13 * t70 + HA1_13
      * t104 + minus_W1_23 * t99 + minus_Y1_23 * t100) * b1_6;
  const T t112 = b1_5 * t98 - (ws1_3 * t106 + LDs1_32 * t111) + LDs1_22 * t109;
  const T t113 = minus_LDs1_31 * t111 - ws1_3 * t110 - z1_1 * t97 + minus_LDs1_21 * t112 + LDs1_11 * t108 - gb1_1 *
      t96;
  const T t114 = t84 + Pddot1_1 * t86 - W1_31 * t113 - z1_1 * t91 - W1_32 * t112 - ws1_3 * t102 - W1_33 * t111;
  const T t115 = t107 - z1_2 * t81 - LD1_32 * t114 - W1_21 * t113 + Pddot1_1 * t95 - z1_1 * t93 + minus_W1_22 * t112 -
      ws1_3 * t100 + minus_W1_23 * t111;
  const T t116 = t72 + z1_2 * t73 - LD1_31 * t114 - z1_3 * t77 - LD1_21 * t115 - W1_12 * t112 + z1_1 * t92 - W1_13 *
      t111 + ws1_3 * t104;
  S[166] = t116;
  const T t117 = T(0.6666666666666666) * t4_2;
  const T t118 = T(0.5773502691896257) * t4_1;
  const T t119 = T(0.3333333333333333) * t4_2;
  const T t120 = t118 + t119;
  const T t121 = t118 - t119;
  const T t122 = omega1_1 * t120 - omega1_2 * t121 - omega1_3 * t117;
  const T t123 = omega1_3 * t120 - (omega1_2 * t117 + omega1_1 * t121);
  const T t124 = omega4_2 * t122 + omega4_3 * t123;
  const T t125 = T(0.5773502691896257) * t122;
  const T t126 = T(0.5773502691896257) * t123;
  const T t127 = thetadot4 * (t125 - t126);
  const T t128 = t124 - t127;
  const T t129 = t124 + t127;
  const T t130 = omega4_3 * t122;
  const T t131 = t130 + t130;
  const T t132 = omega1_2 * t120 - omega1_1 * t117 - omega1_3 * t121;
  const T t133 = omega4_1 * t132;
  const T t134 = t133 + t133;
  const T t135 = t131 + t134;
  const T t136 = omega4_2 * t123;
  const T t137 = t136 + t136;
  const T t138 = t137 + t134;
  const T t139 = omega4_1 * t122 + omega4_3 * t132;
  const T t140 = T(0.5773502691896257) * t132;
  const T t141 = thetadot4 * (t140 - t125);
  const T t142 = t139 + t141;
  const T t143 = omega4_1 * t123 + omega4_2 * t132;
  const T t144 = thetadot4 * (t126 - t140);
  const T t145 = t143 - t144;
  const T t146 = T(0.0079) * t128 - T(0.0079) * t129 - T(0.0021) * (t135 - t138) - T(0.0021) * t142 + T(0.0021) *
      t145;
  const T t147 = t139 - t141;
  const T t148 = t131 + t137;
  const T t149 = t143 + t144;
  const T t150 = T(0.0079) * t147 - T(0.0079) * t142 - T(0.0021) * (t138 - t148) - T(0.0021) * t149 + T(0.0021) *
      t128;
  const T t151 = T(0.0079) * t145 - T(0.0079) * t149 - T(0.0021) * (t148 - t135) - T(0.0021) * t129 + T(0.0021) *
      t147;
  const T t152 = T(50) * (T(0.5773502691896257) * t146 + T(0.5773502691896257) * t150 + T(0.5773502691896257) * t151);
  const T t153 = T(0.011547005383792516) * t152;
  const T t154 = t153 - t146;
  const T t155 = t153 - t150;
  const T t156 = t153 - t151;
  const T t157 = minus_nt4_1 * t117 + E4_11 * t154 + E4_13 * t155 + minus_nt4_2 * t121 + E4_12 * t156 - minus_nt4_3 *
      t120;
  const T t158 = T(0.004566666666666667) * t121;
  const T t159 = T(0.004566666666666667) * t120;
  const T t160 = t158 - t159 - T(0.009133333333333334) * t117;
  const T t161 = E4_11 * t160;
  const T t162 = b4_4 * t117;
  const T t163 = T(0.004566666666666667) * t117;
  const T t164 = t163 - t159 - T(0.009133333333333334) * t121;
  const T t165 = E4_13 * t164;
  const T t166 = b4_7 * t121;
  const T t167 = t163 + t158 + T(0.009133333333333334) * t120;
  const T t168 = E4_12 * t167;
  const T t169 = b4_9 * t120;
  const T t170 = t161 - t162 + t165 - t166 + t168 + t169;
  const T t171 = t7 * t170;
  const T t172 = LD1_11 * t157 - n1_1 * t171;
  const T t173 = E4_13 * t160 - b4_4 * t121 + E4_12 * t164 + b4_7 * t120 + E4_11 * t167 - b4_9 * t117;
  const T t174 = LD1_11 * t173 - JA1_13 * t171;
  const T t175 = t168 + t169 + t161 - t162 + t165 - t166;
  const T t176 = E4_13 * t167;
  const T t177 = b4_9 * t121;
  const T t178 = E4_12 * t160;
  const T t179 = b4_4 * t120;
  const T t180 = E4_11 * t164;
  const T t181 = b4_7 * t117;
  const T t182 = t178 + t179 + t180 - t181 + t176 - t177;
  const T t183 = LD1_11 * t182 - JA1_12 * t171;
  const T t184 = t176 - t177 + t178 + t179 + t180 - t181 - JA1_13 * t183 - LD1_21 * t173;
  const T t185 = t19 * (t175 - JA1_12 * t183 - LD1_21 * t182);
  const T t186 = LD1_22 * t184 - b1_1 * t185;
  const T t187 = t24 * (t170 + t175 + JA1_13 * t174 + LD1_31 * t173 + b1_1 * t186 + LD1_32 * t184);
  const T t188 = E4_12 * t154 - (n1_1 * t183 + LD1_21 * t157) - minus_nt4_1 * t120 + minus_nt4_2 * t117 + E4_11 * t155
      + E4_13 * t156 + minus_nt4_3 * t121;
  const T t189 = b1_3 * t187 + LD1_33 * (b1_2 * t186 - LD1_32 * t188 - n1_1 * t174 - LD1_31 * t157 + E4_13 * t154 +
      minus_nt4_1 * t121 + E4_12 * t155 - minus_nt4_2 * t120 + minus_nt4_3 * t117 + E4_11 * t156);
  const T t190 = HA1_21 * t186;
  const T t191 = Y1_31 * t187 - LD1_33 * t190;
  const T t192 = HA1_21 * t185;
  const T t193 = t29 * (Y1_31 * t191 - W1_31 * t190 - HA1_21 * t192);
  const T t194 = LD1_22 * t188 + b1_2 * t185;
  const T t195 = HA1_21 * t194 + Y1_31 * t189 - w_1_3 * t190;
  const T t196 = HA1_12 * t183;
  const T t197 = HA1_12 * t174 - (minus_Y1_22 * t186 + LD1_32 * t196);
  const T t198 = Y1_32 * t187 - LD1_33 * t197;
  const T t199 = LD1_22 * t196 - minus_Y1_22 * t185;
  const T t200 = Y1_31 * t198 - W1_32 * t190 - HA1_21 * t199;
  const T t201 = minus_M1_12 * t193 + LDs1_11 * t200;
  const T t202 = HA1_12 * t171;
  const T t203 = t42 * (Y1_32 * t198 - W1_32 * t197 + minus_W1_22 * t196 + minus_Y1_22 * t199 - HA1_12 * t202 +
      minus_M1_12 * t201 + minus_LDs1_21 * t200);
  const T t204 = HA1_13 * t183;
  const T t205 = HA1_13 * t174 - (minus_Y1_23 * t186 + LD1_32 * t204);
  const T t206 = Y1_33 * t187 - LD1_33 * t205;
  const T t207 = LD1_22 * t204 - minus_Y1_23 * t185;
  const T t208 = HA1_13 * t171;
  const T t209 = Y1_31 * t206 - W1_33 * t190 - HA1_21 * t207;
  const T t210 = Y1_32 * t206 - W1_33 * t197 + minus_W1_23 * t196 + minus_Y1_22 * t207 - HA1_12 * t208 + minus_M1_13 *
      t201 + minus_LDs1_21 * t209;
  const T t211 = b1_4 * t203 - LDs1_22 * t210;
  const T t212 = minus_M1_13 * t193 + LDs1_11 * t209;
  const T t213 = HA1_12 * t172 + minus_w_1_2 * t196 - minus_Y1_22 * t194 + Y1_32 * t189 - w_1_3 * t197 + minus_LDs1_21
      * t195 - gb1_1 * t201;
  const T t214 = t55 * (Y1_33 * t206 - W1_33 * t205 + minus_W1_23 * t204 + minus_Y1_23 * t207 - HA1_13 * t208 +
      minus_M1_13 * t212 + minus_LDs1_31 * t209 + b1_4 * t211 - LDs1_32 * t210) * b1_6 - LDs1_33 * (HA1_13 * t172 +
      minus_w_1_2 * t204 - minus_Y1_23 * t194 + Y1_33 * t189 - w_1_3 * t205 + minus_LDs1_31 * t195 - gb1_1 * t212 +
      b1_5 * t211 - LDs1_32 * t213);
  const T t215 = b1_5 * t203 - (ws1_3 * t211 + LDs1_32 * t214) - LDs1_22 * t213;
  const T t216 = gb1_1 * t193 - LDs1_11 * t195 + z1_1 * t201 + minus_LDs1_21 * t215 + ws1_3 * t212 + minus_LDs1_31 *
      t214;
  const T t217 = t189 - Pddot1_1 * t191 - W1_31 * t216 - z1_1 * t198 - W1_32 * t215 - ws1_3 * t206 - W1_33 * t214;
  const T t218 = t194 - z1_2 * t186 - LD1_32 * t217 + minus_W1_23 * t214 + ws1_3 * t207 + minus_W1_22 * t215 + z1_1 *
      t199 - W1_21 * t216 + Pddot1_1 * t192;
  const T t219 = t172 - z1_2 * t174 - LD1_31 * t217 - LD1_21 * t218 + z1_3 * t183 - W1_12 * t215 + z1_1 * t202 - W1_13
      * t214 + ws1_3 * t208;
  S[167] = t219;
  const T t220 = T(0.2) * omega1_3;
  const T t221 = T(0.1) * omega1_2;
  const T t222 = E3_23 * T(0.6);
  const T t223 = T(9) * (omega3_1 + omega3_1);
  const T t224 = t222 * t223;
  const T t225 = E2_23 * T(0.6);
  const T t226 = T(9) * (omega2_1 + omega2_1);
  const T t227 = t225 * t226;
  const T t228 = E4_11 * T(0.5773502691896258) + E4_12 * T(0.5773502691896258) + E4_13 * T(0.5773502691896258);
  const T t229 = t228 * T(0.5773502691896257);
  const T t230 = t229 - E4_11;
  const T t231 = T(0.013700000000000002) * t4_5;
  const T t232 = t231 * E4_13;
  const T t233 = t231 * E4_12;
  const T t234 = t232 - t233;
  const T t235 = T(0.0021) * omega4_2;
  const T t236 = T(0.0021) * omega4_3;
  const T t237 = t235 - t236;
  const T t238 = T(0.0021) * (omega4_2 + omega4_2);
  const T t239 = T(0.0021) * omega4_1;
  const T t240 = t238 + t239;
  const T t241 = T(0.0021) * (omega4_3 + omega4_3);
  const T t242 = t241 + t239;
  const T t243 = t234 + t237 * E4_11 + t240 * E4_13 - t242 * E4_12;
  const T t244 = t229 - E4_13;
  const T t245 = t231 * E4_11;
  const T t246 = t233 - t245;
  const T t247 = T(0.0021) * (omega4_1 + omega4_1);
  const T t248 = t247 + t235;
  const T t249 = t236 - t239;
  const T t250 = t241 + t235;
  const T t251 = t246 - t248 * E4_11 + t249 * E4_13 + t250 * E4_12;
  const T t252 = t229 - E4_12;
  const T t253 = t245 - t232;
  const T t254 = t247 + t236;
  const T t255 = t238 + t236;
  const T t256 = t239 - t235;
  const T t257 = t253 + t254 * E4_11 - t255 * E4_13 + t256 * E4_12;
  const T t258 = E3_22 * T(0.6);
  const T t259 = T(0.75) * t258;
  const T t260 = T(9) * t222;
  const T t261 = omega1_1 + omega1_1;
  const T t262 = t260 * t261;
  const T t263 = E2_22 * T(0.6);
  const T t264 = T(0.75) * t263;
  const T t265 = T(9) * t225;
  const T t266 = t265 * t261;
  const T t267 = t220 + t221 + t224 + t227 + t230 * t243 + t244 * t251 + t252 * t257 + t259 * t262 + t264 * t266;
  const T t268 = LD1_21 * LD1_22;
  const T t269 = T(5.3999999999999995) * omega1_2;
  const T t270 = T(3.34) * omega1_3 - T(0.1) * t261 + T(0.3) * omega1_2 - E3_23 * t269 - b3_2 * omega3_2 - E2_23 *
      t269 - b2_2 * omega2_2 + t252 * t243 + t230 * t251 + t244 * t257 - LD1_21 * t267;
  const T t271 = LD1_32 * LD1_33;
  const T t272 = LD1_21 * t271 - LD1_31 * LD1_33;
  const T t273 = T(5.3999999999999995) + t76;
  const T t274 = T(5.3999999999999995) + t16;
  const T t275 = T(6.9799999999999995) * omega1_2 - T(0.2) * t261 - T(0.3) * omega1_3 + E3_22 * t269 + t273 * omega3_2
      + E2_22 * t269 + t274 * omega2_2 + t244 * t243 + t252 * t251 + t230 * t257 - LD1_31 * t267 - LD1_32 * t270;
  const T t276 = LD1_32 * W1_31 - W1_21;
  const T t277 = LD1_31 * W1_31 - LD1_21 * t276;
  const T t278 = t277 * LDs1_11;
  const T t279 = T(9) * omega2_2;
  const T t280 = T(0.8) * omega1_3;
  const T t281 = T(9) * omega3_2;
  const T t282 = t279 - (t280 + t281) + W1_21 * t270 + W1_31 * t275;
  const T t283 = W1_32 * LDs1_22;
  const T t284 = W1_12 * LDs1_22;
  const T t285 = LD1_32 * t283 + minus_W1_22 * LDs1_22;
  const T t286 = minus_LDs1_21 * LDs1_22;
  const T t287 = LD1_31 * t283 - t284 - LD1_21 * t285 + t277 * t286;
  const T t288 = E2_22 * t226;
  const T t289 = E3_22 * t223;
  const T t290 = T(0.75) * E3_23;
  const T t291 = T(0.75) * E2_23;
  const T t292 = t288 - t289 + t290 * t262 - t291 * t266 - W1_12 * t267 + minus_W1_22 * t270 - W1_32 * t275 -
      minus_LDs1_21 * t282;
  const T t293 = LDs1_32 * LDs1_33;
  const T t294 = W1_12 * t293 - W1_13 * LDs1_33;
  const T t295 = W1_32 * t293 - W1_33 * LDs1_33;
  const T t296 = minus_W1_23 * LDs1_33 - minus_W1_22 * t293 - LD1_32 * t295;
  const T t297 = minus_LDs1_31 * LDs1_33 - minus_LDs1_21 * t293;
  const T t298 = t294 - LD1_31 * t295 - LD1_21 * t296 + t277 * t297;
  const T t299 = E2_23 * t226;
  const T t300 = E3_23 * t223;
  const T t301 = T(0.75) * E3_22;
  const T t302 = T(0.75) * E2_22;
  const T t303 = t299 - t300 - T(0.8) * t261 - t301 * t262 + t302 * t266 - W1_13 * t267 + minus_W1_23 * t270 - W1_33 *
      t275 - minus_LDs1_31 * t282 - LDs1_32 * t292;
  S[171] = LD1_11 * t267 - t268 * t270 + t272 * t275 - t278 * t282 + t287 * t292 + t298 * t303;
  const T t304 = T(9) * (omega3_3 + omega3_3);
  const T t305 = t304 * E3_23;
  const T t306 = omega1_2 + omega1_2;
  const T t307 = T(9) * omega3_3;
  const T t308 = t307 * E3_22 - t281 * E3_23;
  const T t309 = T(9) * (omega2_3 + omega2_3);
  const T t310 = t309 * E2_23;
  const T t311 = T(9) * omega2_3;
  const T t312 = t279 * E2_23 - t311 * E2_22;
  const T t313 = t253 + t237 * E4_12 + t240 * E4_11 - t242 * E4_13;
  const T t314 = t234 - t248 * E4_12 + t249 * E4_11 + t250 * E4_13;
  const T t315 = t246 + t254 * E4_12 - t255 * E4_11 + t256 * E4_13;
  const T t316 = T(12) * omega3_2;
  const T t317 = T(9) * t258;
  const T t318 = T(12) * omega3_3;
  const T t319 = t316 * E3_23 - (t317 * omega1_3 + t318 * E3_22);
  const T t320 = T(12) * omega2_2;
  const T t321 = T(9) * t263;
  const T t322 = T(12) * omega2_3;
  const T t323 = t320 * E2_23 - (t321 * omega1_3 + t322 * E2_22);
  const T t324 = T(0.1) * omega1_1 - (t222 * t305 + T(0.3) * t306 + T(10.32) * omega1_3) - t258 * t308 - t225 * t310 +
      t263 * t312 + t230 * t313 + t244 * t314 + t252 * t315 - t259 * t319 - t264 * t323;
  const T t325 = T(0.3) * omega1_1;
  const T t326 = T(5.3999999999999995) * omega1_1;
  const T t327 = omega3_1 * E3_22 + thetadot3 * E3_22;
  const T t328 = omega2_1 * E2_22 + thetadot2 * E2_22;
  const T t329 = t325 - t220 - E3_23 * t326 - b3_2 * t327 - E2_23 * t326 - b2_2 * t328 + t252 * t313 + t230 * t314 +
      t244 * t315 - LD1_21 * t324;
  const T t330 = T(0.2) * t306 + T(6.9799999999999995) * omega1_1 - T(0.1) * omega1_3 + E3_22 * t326 + t273 * t327 +
      E2_22 * t326 + t274 * t328 + t244 * t313 + t252 * t314 + t230 * t315 - LD1_31 * t324 - LD1_32 * t329;
  const T t331 = T(9) * t327 - T(9) * t328 - W1_21 * t329 - W1_31 * t330;
  const T t332 = t280 - t290 * t319 + E3_22 * t305 - E3_23 * t308 - E2_22 * t310 - E2_23 * t312 + t291 * t323 - W1_12
      * t324 + minus_W1_22 * t329 - W1_32 * t330 + minus_LDs1_21 * t331;
  const T t333 = E3_23 * t305 - T(0.8) * t306 + E3_22 * t308 - E2_23 * t310 + E2_22 * t312 + t301 * t319 - t302 * t323
      - W1_13 * t324 + minus_W1_23 * t329 - W1_33 * t330 + minus_LDs1_31 * t331 - LDs1_32 * t332;
  S[172] = LD1_11 * t324 - t268 * t329 + t272 * t330 + t278 * t331 + t287 * t332 + t298 * t333;
  const T t334 = omega1_3 + omega1_3;
  const T t335 = t304 * E3_22;
  const T t336 = t307 * E3_23 + t281 * E3_22;
  const T t337 = t309 * E2_22;
  const T t338 = t311 * E2_23 + t279 * E2_22;
  const T t339 = t246 + t237 * E4_13 + t240 * E4_12 - t242 * E4_11;
  const T t340 = t253 - t248 * E4_13 + t249 * E4_12 + t250 * E4_11;
  const T t341 = t234 + t254 * E4_13 - t255 * E4_12 + t256 * E4_11;
  const T t342 = t260 * t334 + t317 * omega1_2 + t318 * E3_23 + t316 * E3_22;
  const T t343 = t321 * omega1_2 + t265 * t334 + t322 * E2_23 + t320 * E2_22;
  const T t344 = T(0.3) * t334 - T(10.32) * omega1_2 + T(0.2) * omega1_1 + t222 * t335 - t258 * t336 + t225 * t337 -
      t263 * t338 + t230 * t339 + t244 * t340 + t252 * t341 + t259 * t342 + t264 * t343;
  const T t345 = omega3_1 * E3_23 + thetadot3 * E3_23;
  const T t346 = omega2_1 * E2_23 + thetadot2 * E2_23;
  const T t347 = T(0.1) * t334 + T(3.34) * omega1_1 - T(0.2) * omega1_2 - b3_2 * t345 - b2_2 * t346 + t252 * t339 +
      t230 * t340 + t244 * t341 - LD1_21 * t344;
  const T t348 = t273 * t345 - (t221 + t325) + t274 * t346 + t244 * t339 + t252 * t340 + t230 * t341 - LD1_31 * t344 -
      LD1_32 * t347;
  const T t349 = T(0.8) * omega1_1 + T(9) * t345 - T(9) * t346 - W1_21 * t347 - W1_31 * t348;
  const T t350 = T(0.8) * omega1_2 - E3_22 * t335 - E3_23 * t336 + E2_22 * t337 + E2_23 * t338 + t290 * t342 - t291 *
      t343 - W1_12 * t344 + minus_W1_22 * t347 - W1_32 * t348 + minus_LDs1_21 * t349;
  const T t351 = E3_22 * t336 - E3_23 * t335 + E2_23 * t337 - E2_22 * t338 - t301 * t342 + t302 * t343 - W1_13 * t344
      + minus_W1_23 * t347 - W1_33 * t348 + minus_LDs1_31 * t349 - LDs1_32 * t350;
  S[173] = LD1_11 * t344 - t268 * t347 + t272 * t348 + t278 * t349 + t287 * t350 + t298 * t351;
  const T t352 = c.p.c + t227 + t264 * c.p.c;
  const T t353 = omega2_2 + omega2_2;
  const T t354 = b2_2 * t353 + LD1_21 * t352;
  const T t355 = t274 * t353 - LD1_31 * t352 + LD1_32 * t354;
  const T t356 = T(9) * t353 - W1_21 * t354 + W1_31 * t355;
  const T t357 = t288 - t291 * c.p.c - W1_12 * t352 - minus_W1_22 * t354 - W1_32 * t355 - minus_LDs1_21 * t356;
  const T t358 = t299 + t302 * c.p.c - W1_13 * t352 - minus_W1_23 * t354 - W1_33 * t355 - minus_LDs1_31 * t356 -
      LDs1_32 * t357;
  S[174] = LD1_11 * t352 + t268 * t354 + t272 * t355 - t278 * t356 + t287 * t357 + t298 * t358;
  const T t359 = c.p.c + t224 + t259 * c.p.c;
  const T t360 = omega3_2 + omega3_2;
  const T t361 = b3_2 * t360 + LD1_21 * t359;
  const T t362 = t273 * t360 - LD1_31 * t359 + LD1_32 * t361;
  const T t363 = W1_31 * t362 - (T(9) * t360 + W1_21 * t361);
  const T t364 = t290 * c.p.c - t289 - W1_12 * t359 - minus_W1_22 * t361 - W1_32 * t362 - minus_LDs1_21 * t363;
  const T t365 = t300 + t301 * c.p.c + W1_13 * t359 + minus_W1_23 * t361 + W1_33 * t362 + minus_LDs1_31 * t363 +
      LDs1_32 * t364;
  S[175] = LD1_11 * t359 + t268 * t361 + t272 * t362 - t278 * t363 + t287 * t364 - t298 * t365;
  const T t366 = T(0.0021) * t4_14;
  const T t367 = T(0.0021) * t4_13;
  const T t368 = t237 * T(0.5773502691896257) - (t366 + t367) - T(0.0158) * t4_11 + t240 * T(0.5773502691896257) -
      t242 * T(0.5773502691896257);
  const T t369 = T(0.0021) * t4_11;
  const T t370 = t249 * T(0.5773502691896257) - (t366 + t369 + t248 * T(0.5773502691896257) + T(0.0158) * t4_13) +
      t250 * T(0.5773502691896257);
  const T t371 = t254 * T(0.5773502691896257) - (t367 + t369) - T(0.0158) * t4_14 - t255 * T(0.5773502691896257) +
      t256 * T(0.5773502691896257);
  const T t372 = t230 * t368 + t244 * t370 + t252 * t371;
  const T t373 = t252 * t368 + t230 * t370 + t244 * t371 - LD1_21 * t372;
  const T t374 = t244 * t368 + t252 * t370 + t230 * t371 - LD1_31 * t372 - LD1_32 * t373;
  const T t375 = W1_21 * t373 + W1_31 * t374;
  const T t376 = minus_LDs1_21 * t375 + W1_12 * t372 - minus_W1_22 * t373 + W1_32 * t374;
  const T t377 = minus_W1_23 * t373 - (minus_LDs1_31 * t375 + W1_13 * t372) - W1_33 * t374 + LDs1_32 * t376;
  S[176] = LD1_11 * t372 - t268 * t373 + t272 * t374 - t278 * t375 - t287 * t376 + t298 * t377;
  S[183] = t60;
  S[184] = t115;
  S[185] = t218;
  const T t378 = t276 * LDs1_11;
  const T t379 = t285 + t276 * t286;
  const T t380 = t296 + t276 * t297;
  S[189] = LD1_22 * t270 - t271 * t275 - t378 * t282 + t379 * t292 + t380 * t303;
  S[190] = LD1_22 * t329 - t271 * t330 + t378 * t331 + t379 * t332 + t380 * t333;
  S[191] = LD1_22 * t347 - t271 * t348 + t378 * t349 + t379 * t350 + t380 * t351;
  S[192] = t379 * t357 - (LD1_22 * t354 + t271 * t355 + t378 * t356) + t380 * t358;
  S[193] = t379 * t364 - (LD1_22 * t361 + t271 * t362 + t378 * t363) - t380 * t365;
  S[194] = LD1_22 * t373 - t271 * t374 - t378 * t375 - t379 * t376 + t380 * t377;
  S[201] = t59;
  S[202] = t114;
  S[203] = t217;
  const T t381 = W1_31 * LDs1_11;
  const T t382 = t283 + W1_31 * t286;
  const T t383 = t295 - W1_31 * t297;
  S[207] = LD1_33 * t275 + t381 * t282 - t382 * t292 + t383 * t303;
  S[208] = LD1_33 * t330 - t381 * t331 - t382 * t332 + t383 * t333;
  S[209] = LD1_33 * t348 - t381 * t349 - t382 * t350 + t383 * t351;
  S[210] = LD1_33 * t355 + t381 * t356 - t382 * t357 + t383 * t358;
  S[211] = LD1_33 * t362 + t381 * t363 - t382 * t364 - t383 * t365;
  S[212] = LD1_33 * t374 + t381 * t375 + t382 * t376 + t383 * t377;
  const T t384 = T(0.6) * t61;
  const T t385 = T(0.6) * omegadot1_1;
  S[219] = -(t61 + t3 + T(0.75) * (E2_22 * t56 - E2_23 * ws1_3 - E2_22 * z1_1 - E2_23 * t57 + E2_22 * t384 - E2_23 *
      t385));
  const T t386 = T(0.6) * t116;
  S[220] = -(t116 + T(0.75) * (E2_22 * t111 - E2_23 * t112 + E2_22 * t386));
  const T t387 = T(0.6) * t219;
  S[221] = -(t219 + T(0.75) * (E2_22 * t214 - E2_23 * t215 + E2_22 * t387));
  const T t388 = T(1) + t264;
  const T t389 = t388 * LD1_21;
  const T t390 = t389 * LD1_22;
  const T t391 = t388 * LD1_11;
  const T t392 = t388 * LD1_31;
  const T t393 = t392 * LD1_33 - t389 * t271;
  const T t394 = t389 * t276 - t392 * W1_31;
  const T t395 = t394 * LDs1_11;
  const T t396 = t291 * LDs1_22 + t388 * t284 - t392 * t283 + t389 * t285 + t394 * t286;
  const T t397 = t392 * t295 - (t302 * LDs1_33 + t291 * t293 + t388 * t294) + t389 * t296 + t394 * t297;
  S[225] = t390 * t270 - (T(0.08333333333333333) * t266 + t391 * t267) + t393 * t275 - t395 * t282 + t396 * t292 +
      t397 * t303;
  S[226] = T(0.08333333333333333) * t323 - t391 * t324 + t390 * t329 + t393 * t330 + t395 * t331 + t396 * t332 + t397
      * t333;
  S[227] = t390 * t347 - (T(0.08333333333333333) * t343 + t391 * t344) + t393 * t348 + t395 * t349 + t396 * t350 +
      t397 * t351;
  S[228] = t393 * t355 - (c.c0_1 + t391 * t352 + t390 * t354) - t395 * t356 + t396 * t357 + t397 * t358;
  S[229] = t393 * t362 - (t390 * t361 + t391 * t359) - t395 * t363 + t396 * t364 - t397 * t365;
  S[230] = t390 * t373 - t391 * t372 + t393 * t374 - t395 * t375 - t396 * t376 + t397 * t377;
  S[237] = -(t61 - T(0.75) * (E3_22 * t56 - E3_23 * t57 - E3_22 * t384));
  S[238] = -(t116 + t64 - T(0.75) * (E3_22 * t111 - E3_23 * ws1_3 - E3_22 * z1_1 - E3_23 * t112 + E3_23 * t385 - E3_22
      * t386));
  S[239] = -(t219 - T(0.75) * (E3_22 * t214 - E3_23 * t215 - E3_22 * t387));
  const T t398 = T(1) + t259;
  const T t399 = t398 * LD1_21;
  const T t400 = t399 * LD1_22;
  const T t401 = t398 * LD1_11;
  const T t402 = t398 * LD1_31;
  const T t403 = t399 * t271 - t402 * LD1_33;
  const T t404 = t399 * t276 - t402 * W1_31;
  const T t405 = t404 * LDs1_11;
  const T t406 = t398 * t284 - t290 * LDs1_22 - t402 * t283 + t399 * t285 + t404 * t286;
  const T t407 = t301 * LDs1_33 + t290 * t293 - t398 * t294 + t402 * t295 + t399 * t296 + t404 * t297;
  S[243] = t400 * t270 - (T(0.08333333333333333) * t262 + t401 * t267) - t403 * t275 - t405 * t282 + t406 * t292 +
      t407 * t303;
  S[244] = T(0.08333333333333333) * t319 - t401 * t324 + t400 * t329 - t403 * t330 + t405 * t331 + t406 * t332 + t407
      * t333;
  S[245] = t400 * t347 - (T(0.08333333333333333) * t342 + t401 * t344) - t403 * t348 + t405 * t349 + t406 * t350 +
      t407 * t351;
  S[246] = t406 * t357 - (t401 * t352 + t400 * t354 + t403 * t355 + t405 * t356) + t407 * t358;
  S[247] = t406 * t364 - (c.c0_1 + t401 * t359 + t400 * t361 + t403 * t362 + t405 * t363) - t407 * t365;
  S[248] = t400 * t373 - t401 * t372 - t403 * t374 - t405 * t375 - t406 * t376 + t407 * t377;
  S[255] = -(T(0.5773502691896258) * (E4_11 * t61 + E4_12 * t60 + E4_13 * t59) + T(0.5773502691896258) * (E4_13 * t61
      + E4_11 * t60 + E4_12 * t59) + T(0.5773502691896258) * (E4_12 * t61 + E4_13 * t60 + E4_11 * t59));
  S[256] = -(T(0.5773502691896258) * (E4_11 * t116 + E4_12 * t115 + E4_13 * t114) + T(0.5773502691896258) * (E4_13 *
      t116 + E4_11 * t115 + E4_12 * t114) + T(0.5773502691896258) * (E4_12 * t116 + E4_13 * t115 + E4_11 * t114));
  S[257] = -(t152 + T(0.5773502691896258) * (E4_11 * t219 - omegadot1_1 * t117 + E4_12 * t218 - z1_3 * t120 + E4_13 *
      t217 - z1_2 * t121) + T(0.5773502691896258) * (E4_13 * t219 - omegadot1_1 * t121 + z1_3 * t117 + E4_11 * t218 +
      z1_2 * t120 + E4_12 * t217) + T(0.5773502691896258) * (omegadot1_1 * t120 + E4_12 * t219 + E4_13 * t218 + z1_3 *
      t121 + E4_11 * t217 - z1_2 * t117));
  const T t408 = t228 * LD1_21 - t228;
  const T t409 = t408 * LD1_22;
  const T t410 = t228 * LD1_11;
  const T t411 = t228 * LD1_31 - t228;
  const T t412 = t411 * LD1_33 - t408 * t271;
  const T t413 = t408 * t276 - t411 * W1_31;
  const T t414 = t413 * LDs1_11;
  const T t415 = t228 * t284 - t411 * t283 + t408 * t285 + t413 * t286;
  const T t416 = t411 * t295 - t228 * t294 + t408 * t296 + t413 * t297;
  S[261] = t409 * t270 - (T(28.867513459481287) * t243 + T(28.867513459481287) * t251 + T(28.867513459481287) * t257 +
      t410 * t267) + t412 * t275 - t414 * t282 + t415 * t292 + t416 * t303;
  S[262] = t409 * t329 - (T(28.867513459481287) * t313 + T(28.867513459481287) * t314 + T(28.867513459481287) * t315 +
      t410 * t324) + t412 * t330 + t414 * t331 + t415 * t332 + t416 * t333;
  S[263] = t409 * t347 - (T(28.867513459481287) * t339 + T(28.867513459481287) * t340 + T(28.867513459481287) * t341 +
      t410 * t344) + t412 * t348 + t414 * t349 + t415 * t350 + t416 * t351;
  S[264] = t412 * t355 - (t409 * t354 + t410 * t352) - t414 * t356 + t415 * t357 + t416 * t358;
  S[265] = t412 * t362 - (t409 * t361 + t410 * t359) - t414 * t363 + t415 * t364 - t416 * t365;
  S[266] = t409 * t373 - (T(28.867513459481287) * t368 + T(28.867513459481287) * t370 + T(28.867513459481287) * t371 +
      t410 * t372) + t412 * t374 - t414 * t375 - t415 * t376 + t416 * t377;
  const T t417 = T(0.5) * eps1_2;
  const T t418 = T(2) * t417;
  const T t419 = eps1_3 * t418;
  const T t420 = t1_3 * t417;
  const T t421 = t419 + t420;
  const T t422 = T(0.5) * eps1_3;
  const T t423 = T(2) * t422;
  const T t424 = eps1_2 * t423;
  const T t425 = t1_1 * t422;
  const T t426 = t424 + t425;
  const T t427 = T(0.5) * eps1_4;
  const T t428 = T(2) * t427;
  const T t429 = eps1_2 * t428;
  const T t430 = t1_5 * t422;
  const T t431 = t429 + t430;
  const T t432 = eps1_4 * t418;
  const T t433 = T(0.5) * eps1_1;
  const T t434 = t1_3 * t433;
  const T t435 = t432 + t434;
  const T t436 = eps1_3 * t428;
  const T t437 = t1_5 * t417;
  const T t438 = t436 - t437;
  const T t439 = eps1_4 * t423;
  const T t440 = t1_1 * t433;
  const T t441 = t439 - t440;
  S[270] = Pddot1_1 * (t421 - t426) + z1_1 * (t431 + t435) + ws1_3 * (t438 + t441);
  const T t442 = t1_5 * t427;
  const T t443 = t442 - t424;
  const T t444 = T(2) * t433;
  const T t445 = eps1_4 * t444;
  const T t446 = t445 - t420;
  const T t447 = t1_1 * t427;
  const T t448 = t429 + t447;
  const T t449 = eps1_3 * t444;
  const T t450 = t449 + t434;
  const T t451 = t1_5 * t433;
  const T t452 = eps1_3 * t423;
  const T t453 = t451 - t452;
  const T t454 = eps1_4 * t428;
  const T t455 = t1_1 * t417;
  const T t456 = t454 - t455;
  S[271] = z1_1 * (t443 - t446) - Pddot1_1 * (t448 + t450) + ws1_3 * (t453 + t456);
  const T t457 = t440 + eps1_2 * t444;
  const T t458 = t436 + t1_3 * t427;
  const T t459 = eps1_2 * t418 - t451;
  const T t460 = t454 - t1_3 * t422;
  const T t461 = t419 + t442;
  const T t462 = t445 + t425;
  S[272] = Pddot1_1 * (t457 - t458) + z1_1 * (t459 - t460) + ws1_3 * (t461 - t462);
  S[273] = R1_11 * t58 + R1_21 * t57 + R1_31 * t56;
  S[274] = R1_11 * t113 + R1_21 * t112 + R1_31 * t111;
  S[275] = R1_11 * t216 + R1_21 * t215 + R1_31 * t214;
  const T t463 = R1_21 * LDs1_22 + R1_11 * t286;
  const T t464 = R1_11 * LDs1_11;
  const T t465 = R1_31 * LDs1_33 - R1_21 * t293 + R1_11 * t297;
  S[279] = t463 * t292 - t464 * t282 + t465 * t303;
  S[280] = t464 * t331 + t463 * t332 + t465 * t333;
  S[281] = t464 * t349 + t463 * t350 + t465 * t351;
  S[282] = t463 * t357 - t464 * t356 + t465 * t358;
  S[283] = t463 * t364 - t464 * t363 - t465 * t365;
  S[284] = t465 * t377 - (t463 * t376 + t464 * t375);
  const T t466 = t442 + eps1_1 * t428;
  const T t467 = t452 - t455;
  const T t468 = t454 - t451;
  S[288] = Pddot1_1 * (t431 - t435) + z1_1 * (t421 - t466) + ws1_3 * (t467 - t468);
  const T t469 = t430 + eps1_1 * t423;
  const T t470 = t436 + t440;
  const T t471 = t439 + t437;
  S[289] = Pddot1_1 * (t443 + t446) + z1_1 * (t469 - t450) + ws1_3 * (t470 + t471);
  const T t472 = t437 + eps1_1 * t418;
  const T t473 = t447 - t449;
  const T t474 = t432 - t430;
  S[290] = Pddot1_1 * (t459 + t460) - z1_1 * (t472 + t458) + ws1_3 * (t473 - t474);
  S[291] = R1_12 * t58 + R1_22 * t57 + R1_32 * t56;
  S[292] = R1_12 * t113 + R1_22 * t112 + R1_32 * t111;
  S[293] = R1_12 * t216 + R1_22 * t215 + R1_32 * t214;
  const T t475 = R1_22 * LDs1_22 + R1_12 * t286;
  const T t476 = R1_12 * LDs1_11;
  const T t477 = R1_32 * LDs1_33 - R1_22 * t293 + R1_12 * t297;
  S[297] = t475 * t292 - t476 * t282 + t477 * t303;
  S[298] = t476 * t331 + t475 * t332 + t477 * t333;
  S[299] = t476 * t349 + t475 * t350 + t477 * t351;
  S[300] = t475 * t357 - t476 * t356 + t477 * t358;
  S[301] = t475 * t364 - t476 * t363 - t477 * t365;
  S[302] = t477 * t377 - (t475 * t376 + t476 * t375);
  S[306] = Pddot1_1 * (t438 - t441) + z1_1 * (t467 + t468) - ws1_3 * (t466 + t426);
  S[307] = Pddot1_1 * (t453 - t456) + z1_1 * (t470 - t471) + ws1_3 * (t469 - t448);
  S[308] = Pddot1_1 * (t461 + t462) + z1_1 * (t473 + t474) + ws1_3 * (t457 - t472);
  S[309] = R1_13 * t58 + R1_23 * t57 + R1_33 * t56;
  S[310] = R1_13 * t113 + R1_23 * t112 + R1_33 * t111;
  S[311] = R1_13 * t216 + R1_23 * t215 + R1_33 * t214;
  const T t478 = R1_23 * LDs1_22 + R1_13 * t286;
  const T t479 = R1_13 * LDs1_11;
  const T t480 = R1_33 * LDs1_33 - R1_23 * t293 + R1_13 * t297;
  S[315] = t478 * t292 - t479 * t282 + t480 * t303;
  S[316] = t479 * t331 + t478 * t332 + t480 * t333;
  S[317] = t479 * t349 + t478 * t350 + t480 * t351;
  S[318] = t478 * t357 - t479 * t356 + t480 * t358;
  S[319] = t478 * t364 - t479 * t363 - t480 * t365;
  S[320] = t480 * t377 - (t478 * t376 + t479 * t375);
}

// input_matrix: rates of (xi, y) for small changes of the inputs.
// B (2 ny x n_inputs)
// 193 add, 250 multiply, 6 divide, 6 sine or cosine
// by: articulated; composite would take 253 add, 304 multiply, 6 divide, 6 sine or cosine
template <class T>
void input_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, [[maybe_unused]] const T* y, [[maybe_unused]]
    const Inputs<T>& u, T* B) noexcept {
  for (int i = 0; i < 36; ++i) B[i] = T(0);
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 3, cosines + 4, sines + 4);

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
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];

  // ---- body 3 (right_panel) on body 1
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];

  // ---- body 4 (wheel) on body 1
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T E4_11 = T(0.3333333333333334) + t4_1 * T(0.6666666666666666);
  const T t4_2 = sines[6] * T(0.5773502691896257);
  const T t4_3 = T(0.3333333333333333) - t4_1 * T(0.3333333333333333);
  const T E4_12 = t4_2 + t4_3;
  const T E4_13 = t4_3 - t4_2;

  // ---- body 4 (wheel) and what it carries
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_1 = E4_13 * T(0.004566666666666667);
  const T b4_2 = E4_12 * T(0.004566666666666667);
  const T b4_3 = E4_11 * T(0.009133333333333334) - (b4_1 + b4_2);
  const T b4_4 = b4_3 * E4_11;
  const T b4_5 = E4_11 * T(0.004566666666666667);
  const T b4_6 = E4_13 * T(0.009133333333333334) - (b4_2 + b4_5);
  const T b4_7 = b4_6 * E4_13;
  const T b4_8 = E4_12 * T(0.009133333333333334) - (b4_1 + b4_5);
  const T b4_9 = b4_8 * E4_12;
  const T Jp4_11 = b4_4 + b4_7 + b4_9;
  const T b4_10 = b4_3 * E4_12;
  const T b4_11 = b4_6 * E4_11;
  const T b4_12 = b4_8 * E4_13;
  const T Jp4_12 = b4_10 + b4_11 + b4_12;
  const T Jp4_13 = b4_3 * E4_13 + b4_6 * E4_12 + b4_8 * E4_11;
  const T Jp4_22 = b4_9 + b4_4 + b4_7;
  const T Jp4_23 = b4_12 + b4_10 + b4_11;
  const T Jp4_33 = T(0.027400000000000004) - Jp4_11 - Jp4_22;

  // ---- body 3 (right_panel) and what it carries
  // Mp3 = E3^T M3 E3: M passed on, lower body's axes [kg]
  const T b3_1 = E3_23 * T(6.75);
  const T minus_Mp3_22 = E3_23 * b3_1;
  const T Mp3_23 = E3_22 * b3_1;
  const T Mp3_33 = minus_Mp3_22 - T(6.75);
  // Hp3 = E3^T H3 E3: H passed on, lower body's axes [kg m]
  const T minus_Hp3_21 = E3_23 * T(9);
  const T Hp3_31 = E3_22 * T(9);
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_2 = E3_23 * T(12);
  const T Jp3_22 = E3_23 * b3_2;
  const T minus_Jp3_23 = E3_22 * b3_2;
  const T Jp3_33 = T(12) - Jp3_22;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T minus_Hb3_12 = T(0.6) * Mp3_23;
  const T minus_Hb3_13 = T(0.6) * Mp3_33;

  // ---- body 2 (left_panel) and what it carries
  // Mp2 = E2^T M2 E2: M passed on, lower body's axes [kg]
  const T b2_1 = E2_23 * T(6.75);
  const T minus_Mp2_22 = E2_23 * b2_1;
  const T Mp2_23 = E2_22 * b2_1;
  const T Mp2_33 = minus_Mp2_22 - T(6.75);
  // Hp2 = E2^T H2 E2: H passed on, lower body's axes [kg m]
  const T Hp2_21 = E2_23 * T(9);
  const T minus_Hp2_31 = E2_22 * T(9);
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T b2_2 = E2_23 * T(12);
  const T Jp2_22 = E2_23 * b2_2;
  const T minus_Jp2_23 = E2_22 * b2_2;
  const T Jp2_33 = T(12) - Jp2_22;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T Hb2_12 = T(0.6) * Mp2_23;
  const T Hb2_13 = T(0.6) * Mp2_33;

  // ---- body 1 (hub) and what it carries
  // MA1 = m_all_1 one + Mp3 + Mp2: force for an acceleration of the origin, home axes [kg]
  const T MA1_22 = T(142) - minus_Mp3_22 - minus_Mp2_22;
  const T MA1_23 = Mp3_23 + Mp2_23;
  const T MA1_33 = T(142) + Mp3_33 + Mp2_33;
  // HA1 = h_all_1~ + Hb2 + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA1_12 = Hb2_12 + T(0.8) - minus_Hb3_12;
  const T HA1_13 = Hb2_13 - minus_Hb3_13;
  const T HA1_21 = Hp2_21 - T(0.8) - minus_Hp3_21;
  const T HA1_31 = Hp3_31 - minus_Hp2_31;
  // JA1 = q2~ Hp2^T + q3~ Hp3^T + J_all_1 + Jp4 + Jp3 + Jp2 - Hb2 q2~ - Hb3 q3~: moment for an angular acceleration,
  //   body axes [kg m^2]
  const T JA1_11 = T(22.64) + Jp4_11 + Hb2_13 * T(0.6) + minus_Hb3_13 * T(0.6);
  const T JA1_12 = T(0.2) + Jp4_12;
  const T JA1_13 = Jp4_13 - T(0.1);
  const T JA1_22 = T(15.66) + Jp4_22 + Jp3_22 + Jp2_22;
  const T JA1_23 = T(0.3) + Jp4_23 - minus_Jp3_23 - minus_Jp2_23 - T(0.6) * Hp2_21 - T(0.6) * minus_Hp3_21;
  const T JA1_33 = T(25.98) + Jp4_33 + Jp3_33 + Jp2_33 + T(1.2) * minus_Hp2_31 + T(1.2) * Hp3_31;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T LD1_21 = LD1_11 * JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - LD1_21 * JA1_12);
  const T LD1_31 = LD1_11 * JA1_13;
  const T b1_1 = JA1_23 - LD1_21 * JA1_13;
  const T LD1_32 = LD1_22 * b1_1;
  const T LD1_33 = T(1) / (JA1_33 - LD1_31 * JA1_13 - LD1_32 * b1_1);
  // Y1 = L(LD1)^-1 HA1: L^-1 HA
  const T minus_Y1_22 = LD1_21 * HA1_12;
  const T minus_Y1_23 = LD1_21 * HA1_13;
  const T Y1_31 = HA1_31 - LD1_32 * HA1_21;
  const T Y1_32 = LD1_32 * minus_Y1_22 - LD1_31 * HA1_12;
  const T Y1_33 = LD1_32 * minus_Y1_23 - LD1_31 * HA1_13;
  // W1 = D(LD1)^-1 Y1: D^-1 L^-1 HA
  const T W1_12 = LD1_11 * HA1_12;
  const T W1_13 = LD1_11 * HA1_13;
  const T W1_21 = LD1_22 * HA1_21;
  const T minus_W1_22 = LD1_22 * minus_Y1_22;
  const T minus_W1_23 = LD1_22 * minus_Y1_23;
  const T W1_31 = LD1_33 * Y1_31;
  const T W1_32 = LD1_33 * Y1_32;
  const T W1_33 = LD1_33 * Y1_33;
  // M1 = MA1 - Y1^T W1: MA less what the ball takes up [kg]
  const T M1_11 = T(142) - HA1_21 * W1_21 - Y1_31 * W1_31;
  const T minus_M1_12 = Y1_31 * W1_32 - HA1_21 * minus_W1_22;
  const T minus_M1_13 = Y1_31 * W1_33 - HA1_21 * minus_W1_23;
  const T M1_22 = MA1_22 - HA1_12 * W1_12 - minus_Y1_22 * minus_W1_22 - Y1_32 * W1_32;
  const T M1_23 = MA1_23 - HA1_12 * W1_13 - minus_Y1_22 * minus_W1_23 - Y1_32 * W1_33;
  const T M1_33 = MA1_33 - HA1_13 * W1_13 - minus_Y1_23 * minus_W1_23 - Y1_33 * W1_33;
  // LDs1 = L D L^T of M1: L D L^T = M: L, and 1/D on the diagonal
  const T LDs1_11 = T(1) / M1_11;
  const T minus_LDs1_21 = LDs1_11 * minus_M1_12;
  const T LDs1_22 = T(1) / (M1_22 - minus_LDs1_21 * minus_M1_12);
  const T minus_LDs1_31 = LDs1_11 * minus_M1_13;
  const T b1_2 = M1_23 - minus_LDs1_21 * minus_M1_13;
  const T LDs1_32 = LDs1_22 * b1_2;
  const T LDs1_33 = T(1) / (M1_33 - minus_LDs1_31 * minus_M1_13 - LDs1_32 * b1_2);

  // ---- results
  const T t1 = LD1_21 * LD1_32 - LD1_31;
  const T t2 = E4_11 * T(0.5773502691896258) + E4_12 * T(0.5773502691896258) + E4_13 * T(0.5773502691896258);
  const T t3 = t2 * LD1_21 - t2;
  const T t4 = t2 * LD1_31 - t2 - LD1_32 * t3;
  const T t5 = LD1_33 * t4;
  const T t6 = t2 * LD1_11;
  const T t7 = t3 * LD1_22;
  const T t8 = LDs1_33 * Y1_33;
  const T t9 = minus_LDs1_31 * LDs1_33;
  const T t10 = HA1_21 * t7 + Y1_31 * t5;
  const T t11 = LDs1_32 * LDs1_33;
  const T t12 = HA1_12 * t6 + minus_Y1_22 * t7 - Y1_32 * t5 - minus_LDs1_21 * t10;
  const T t13 = LDs1_33 * (HA1_13 * t6 + minus_Y1_23 * t7) - t8 * t5 - t9 * t10 - t11 * t12;
  const T t14 = LDs1_22 * t12 - LDs1_32 * t13;
  const T t15 = t5 - W1_33 * t13 - W1_32 * t14;
  const T t16 = W1_13 + LD1_21 * minus_W1_23;
  const T t17 = W1_12 + LD1_21 * minus_W1_22;
  const T t18 = LD1_21 * W1_21 - t1 * W1_31;
  const T t19 = minus_LDs1_31 * t13 - LDs1_11 * t10 + minus_LDs1_21 * t14;
  B[18] = t1 * t15 - (t16 * t13 + t6 + LD1_21 * t7 + t17 * t14) + t18 * t19;
  const T t20 = LD1_33 * T(0.1);
  const T t21 = T(1) + Y1_31 * t20;
  const T t22 = Y1_32 * t20 + minus_LDs1_21 * t21;
  const T t23 = t8 * t20 + t9 * t21 - t11 * t22;
  const T t24 = LDs1_22 * t22 - LDs1_32 * t23;
  const T t25 = LDs1_11 * t21 + minus_LDs1_31 * t23 + minus_LDs1_21 * t24;
  const T t26 = t20 + W1_33 * t23 + W1_32 * t24;
  B[19] = t18 * t25 - (t16 * t23 + t17 * t24 + t1 * t26);
  const T t27 = LD1_32 * W1_31 - W1_21;
  B[20] = t7 + minus_W1_23 * t13 + minus_W1_22 * t14 - LD1_32 * t15 + t27 * t19;
  B[21] = LD1_32 * t26 + minus_W1_23 * t23 + minus_W1_22 * t24 + t27 * t25;
  B[22] = t15 - W1_31 * t19;
  B[23] = -(t26 + W1_31 * t25);
  const T t28 = T(1) + E2_22 * T(0.6) * T(0.75);
  const T t29 = t28 * LD1_21;
  const T t30 = t28 * W1_13 - T(0.75) * E2_22 + t29 * minus_W1_23;
  const T t31 = T(0.75) * E2_23 + t28 * W1_12 + t29 * minus_W1_22;
  const T t32 = t28 * LD1_31 - t29 * LD1_32;
  const T t33 = t29 * W1_21 + t32 * W1_31;
  B[24] = t28 * t6 + t29 * t7 + t30 * t13 + t31 * t14 + t32 * t15 - t33 * t19;
  B[25] = t30 * t23 + t31 * t24 - t32 * t26 - t33 * t25;
  const T t34 = T(1) + E3_22 * T(0.6) * T(0.75);
  const T t35 = t34 * LD1_21;
  const T t36 = T(0.75) * E3_22 + t34 * W1_13 + t35 * minus_W1_23;
  const T t37 = t34 * W1_12 - T(0.75) * E3_23 + t35 * minus_W1_22;
  const T t38 = t35 * LD1_32 - t34 * LD1_31;
  const T t39 = t38 * W1_31 - t35 * W1_21;
  B[26] = t35 * t7 + t34 * t6 + t36 * t13 + t37 * t14 - t38 * t15 + t39 * t19;
  B[27] = t37 * t24 + t36 * t23 + t38 * t26 + t39 * t25;
  const T t40 = t2 * W1_13 + t3 * minus_W1_23;
  const T t41 = t2 * W1_12 + t3 * minus_W1_22;
  const T t42 = t3 * W1_21 + t4 * W1_31;
  B[28] = T(50) + t2 * t6 + t3 * t7 + t40 * t13 + t41 * t14 + t4 * t15 - t42 * t19;
  B[29] = t40 * t23 + t41 * t24 - t4 * t26 - t42 * t25;
  B[30] = R1_31 * t13 + R1_21 * t14 + R1_11 * t19;
  B[31] = R1_31 * t23 + R1_21 * t24 + R1_11 * t25;
  B[32] = R1_32 * t13 + R1_22 * t14 + R1_12 * t19;
  B[33] = R1_32 * t23 + R1_22 * t24 + R1_12 * t25;
  B[34] = R1_33 * t13 + R1_23 * t14 + R1_13 * t19;
  B[35] = R1_33 * t23 + R1_23 * t24 + R1_13 * t25;
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
  position[0] = P2_1 + R2_21 * T(2);
  position[1] = P2_2 + R2_22 * T(2);
  position[2] = P2_3 + R2_23 * T(2);
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
  const T U1_12 = omega1_2 * omega1_1 - omegadot1_3;
  const T minus_U1_22 = omega1_3 * omega1_3 + omega1_1 * omega1_1;
  const T U1_32 = omegadot1_1 + omega1_3 * omega1_2;
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
  const T U2_32 = omegadot2_1 + omega2_3 * omega2_2;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot2_1 = Pddot1_1 + U1_12 * T(0.6);
  const T t2_1 = Pddot1_2 - minus_U1_22 * T(0.6);
  const T t2_2 = Pddot1_3 + U1_32 * T(0.6);
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
