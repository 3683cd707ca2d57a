// SPDX-License-Identifier: BSD-3-Clause
// satellite: equations of motion of 4 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 473964f5f3ee8920 of satellite/scene.toml; functions kinematics poses energy momentum power accelerations
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
//   state_matrix                  2901 (1309 add, 1583 multiply, 9 divide, 6 sine or cosine)
//   input_matrix                  401 (174 add, 221 multiply, 6 divide, 6 sine or cosine)
//   tip_position                  40 (16 add, 24 multiply, 2 sine or cosine)
//   tip_acceleration              131 (55 add, 76 multiply, 2 sine or cosine)
#pragma once

#include <cmath>
#include <cstdint>

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
  const Vector reduced = a - n * 1.5707963267941523;  // 41 bits of pi/2, and 41 more: these products are exact
  const Vector r = reduced - n * 7.443547480484391e-13;
  const Vector e = (reduced - r) - n * 7.443547480484391e-13 - n * 2.232414100745812e-25;
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
  __builtin_memcpy(&quadrant, &shifted, sizeof quadrant);
  __builtin_memcpy(&bits_c, &cosine, sizeof bits_c);
  __builtin_memcpy(&bits_s, &sine, sizeof bits_s);
  const Bits exchange = (bits_c ^ bits_s) & (0 - (quadrant & 1));
  bits_c ^= exchange ^ ((quadrant + 1) & 2) << 62;
  bits_s ^= exchange ^ (quadrant & 2) << 62;
  __builtin_memcpy(&c, &bits_c, sizeof c);
  __builtin_memcpy(&s, &bits_s, sizeof s);
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
inline constexpr char model_hash[] = "473964f5f3ee8920";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, theta_2 = 4, theta_3 = 5, theta_4 = 6,
    s_1_1 = 7, s_1_2 = 8, s_1_3 = 9;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, thetadot_2 = 3, thetadot_3 = 4, thetadot_4 = 5,
    sdot_1_1 = 6, sdot_1_2 = 7, sdot_1_3 = 8;
inline constexpr int eps_hub_1 = 0, eps_hub_2 = 1, eps_hub_3 = 2, eps_hub_4 = 3, theta_left_panel = 4,
    theta_right_panel = 5, theta_wheel = 6, s_hub_1 = 7, s_hub_2 = 8, s_hub_3 = 9;
inline constexpr int omega_hub_1 = 0, omega_hub_2 = 1, omega_hub_3 = 2, thetadot_left_panel = 3,
    thetadot_right_panel = 4, thetadot_wheel = 5, sdot_hub_1 = 6, sdot_hub_2 = 7, sdot_hub_3 = 8;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 55;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 3, 3,
    3, 3, 3, 4, 4, 4, 4, 4, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 1, 2, 5, 6, 7, 8, 0, 1, 2, 5, 6, 7, 8, 0,
    3, 6, 7, 8, 0, 4, 6, 7, 8, 0, 1, 2, 5, 0, 1, 2, 3, 4, 6, 0, 1, 2, 3, 4, 7, 0, 1, 2, 3, 4, 8};

// Entries of state_matrix that are not always 0, row by row.
inline constexpr int state_matrix_nonzeros = 123;
inline constexpr int state_matrix_rows[] = {0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 4, 5, 6, 7, 8, 9, 9, 9, 9, 9, 9, 9, 9, 9, 9,
    9, 9, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 10, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 11, 12, 12, 12,
    12, 12, 12, 12, 12, 12, 12, 12, 12, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 14, 14, 14, 14, 14, 14, 14,
    14, 14, 14, 14, 14, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16,
    16, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17};
inline constexpr int state_matrix_columns[] = {1, 2, 9, 0, 2, 10, 0, 1, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5,
    9, 10, 11, 12, 13, 14, 0, 1, 2, 3, 4, 5, 9, 10, 11, 12, 13, 14, 0, 1, 2, 3, 4, 5, 9, 10, 11, 12, 13, 14, 0, 1, 2,
    3, 4, 5, 9, 10, 11, 12, 13, 14, 0, 1, 2, 3, 4, 5, 9, 10, 11, 12, 13, 14, 0, 1, 2, 3, 4, 5, 9, 10, 11, 12, 13, 14,
    0, 1, 2, 3, 4, 5, 9, 10, 11, 12, 13, 14, 0, 1, 2, 3, 4, 5, 9, 10, 11, 12, 13, 14, 0, 1, 2, 3, 4, 5, 9, 10, 11, 12,
    13, 14};

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
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  Prepared<T> c{};
  c.p = p;
  const T c0_1 = p.c * T(0.08333333333333333);
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

// state_matrix: S of d(xi, y)/dt = S (xi, y) for small changes; xi: of a ball a turn, body axes; else as x.
// S (2 ny x 2 ny)
// 1309 add, 1583 multiply, 9 divide, 6 sine or cosine
// by: equations differentiated; operations differentiated would take 1442 add, 1741 multiply, 6 divide, 6 sine or
//   cosine
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
  const T t1_13 = omega1_3 * omega1_3;
  const T t1_14 = omega1_2 * omega1_2;
  const T minus_U1_11 = t1_13 + t1_14;
  const T U1_12 = omega1_2 * omega1_1;
  const T U1_13 = omega1_3 * omega1_1;
  const T t1_15 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + t1_15;
  const T U1_23 = omega1_3 * omega1_2;
  const T minus_U1_33 = t1_14 + t1_15;
  // G1 = -U1 h_all_1 + F_thruster_: applied less inertia force, body axes [N]
  const T G1_1 = u.thrust + U1_13 * T(0.8);
  const T G1_2 = U1_23 * T(0.8);
  const T minus_G1_3 = minus_U1_33 * T(0.8);
  // N1 = -omega1~ J_all_1 omega1 + r_thruster_~ F_thruster_: applied less inertia moment about the body origin, body
  //   axes [N m]
  const T minus_N1_1 = T(10.32) * U1_23 + T(0.3) * (t1_14 - t1_13) - T(0.1) * U1_12 - T(0.2) * U1_13;
  const T minus_N1_2 = T(0.2) * U1_23 - (T(3.34) * U1_13 + T(0.1) * (t1_13 - t1_15)) - T(0.3) * U1_12;
  const T minus_N1_3 = T(0.1) * u.thrust + T(0.2) * (t1_15 - t1_14) - T(6.9799999999999995) * U1_12 + T(0.3) * U1_13 +
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
  const T t2_1 = omega2_2 * omega2_1;
  const T U2_12 = t2_1 + minus_omegadot2_3;
  const T minus_U2_22 = omega2_3 * omega2_3 + omega2_1 * omega2_1;
  const T U2_23 = omega2_3 * omega2_2;
  // Pddot2 = E2 U1 q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot2_1 = U1_12 * T(0.6);
  const T t2_2 = minus_U1_22 * T(0.6);
  const T t2_3 = U1_23 * T(0.6);
  const T Pddot2_3 = E2_23 * t2_2 + E2_22 * t2_3;
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
  const T minus_omegadot3_3 = thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_2 * omega3_1;
  const T U3_12 = t3_1 + minus_omegadot3_3;
  const T minus_U3_22 = omega3_3 * omega3_3 + omega3_1 * omega3_1;
  const T U3_23 = omega3_3 * omega3_2;
  // Pddot3 = E3 U1 q3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot3_3 = E3_23 * t2_2 + E3_22 * t2_3;
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
  const T t4_17 = T(0.0021) * (minus_U4_22 - minus_U4_33);
  const T minus_N4_1 = T(0.0079) * U4_32 - t4_17 - T(0.0079) * U4_23 - T(0.0021) * U4_31 + T(0.0021) * U4_21;
  const T t4_18 = T(0.0021) * (minus_U4_33 - minus_U4_11);
  const T minus_N4_2 = T(0.0079) * U4_13 - t4_18 - T(0.0079) * U4_31 - T(0.0021) * U4_12 + T(0.0021) * U4_32;
  const T t4_19 = T(0.0021) * (minus_U4_11 - minus_U4_22);
  const T minus_N4_3 = T(0.0079) * U4_21 - t4_19 - T(0.0079) * U4_12 - T(0.0021) * U4_23 + T(0.0021) * U4_13;

  // ---- body 3 (right_panel) and what it carries
  // hc3 = E3^T h_own_3: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc3_2 = E3_22 * T(9);
  const T minus_hc3_3 = E3_23 * T(9);

  // ---- body 2 (left_panel) and what it carries
  // hc2 = E2^T h_own_2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_2 = E2_22 * T(9);
  const T hc2_3 = E2_23 * T(9);

  // ---- body 1 (hub) and what it carries
  // S1 = E2^T G2 + E3^T G3 + G1: sum of the force balances of the subtree, body axes [N]
  const T S1_1 = G3_1 - minus_G2_1 + G1_1;
  const T b1_1 = E2_22 * G2_2;
  const T b1_2 = E3_22 * minus_G3_2;
  const T S1_2 = b1_1 - b1_2 + E2_23 * minus_G2_3 - E3_23 * G3_3 + G1_2;
  const T b1_3 = E2_23 * G2_2;
  const T b1_4 = E2_22 * minus_G2_3 - b1_3;
  const T b1_5 = E3_23 * minus_G3_2;
  const T b1_6 = b1_5 - E3_22 * G3_3;
  const T minus_S1_3 = minus_G1_3 + b1_4 + b1_6;
  // f_omega1 = q2~ E2^T G2 + E2^T N2 + q3~ E3^T G3 + E3^T N3 + E4^T N4 + N1: Kane's equation of omega [N m]
  const T minus_f_omega1_1 = minus_N1_1 + minus_N2_1 + minus_N3_1 + T(0.6) * b1_4 - T(0.6) * b1_6 + E4_11 * minus_N4_1
      + E4_13 * minus_N4_2 + E4_12 * minus_N4_3;
  const T minus_f_omega1_2 = minus_N1_2 + E2_23 * N2_3 + E3_23 * N3_3 + E4_12 * minus_N4_1 + E4_11 * minus_N4_2 +
      E4_13 * minus_N4_3;
  const T f_omega1_3 = T(0.6) * minus_G2_1 - minus_N1_3 + E2_22 * N2_3 + T(0.6) * G3_1 + E3_22 * N3_3 - E4_13 *
      minus_N4_1 - E4_12 * minus_N4_2 - E4_11 * minus_N4_3;
  // h1 = h_all_1 + hc2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T minus_h1_2 = minus_hc3_2 - hc2_2;
  const T h1_3 = hc2_3 - T(0.8) - minus_hc3_3;
  // J1 = -q2~ hc2~ + E2^T J_own_2 E2 - q3~ hc3~ + E3^T J_own_3 E3 + E4^T I4 E4 + J_all_1 - hc2~ q2~ - hc3~ q3~:
  //   inertia carried, about the body origin, body axes [kg m^2]
  const T b1_7 = T(0.6) * hc2_2;
  const T b1_8 = b1_7 + T(12);
  const T b1_9 = T(1.2) * minus_hc3_2;
  const T b1_10 = E4_13 * T(0.0021);
  const T b1_11 = E4_12 * T(0.0021);
  const T b1_12 = b1_10 + b1_11 + E4_11 * T(0.0158);
  const T b1_13 = b1_12 * E4_11;
  const T b1_14 = E4_11 * T(0.0021);
  const T b1_15 = b1_11 + b1_14 + E4_13 * T(0.0158);
  const T b1_16 = b1_15 * E4_13;
  const T b1_17 = b1_10 + b1_14 + E4_12 * T(0.0158);
  const T b1_18 = b1_17 * E4_12;
  const T b1_19 = b1_13 + b1_16 + b1_18;
  const T J1_11 = b1_8 + b1_9 + T(34.64) + b1_19 + b1_7;
  const T b1_20 = b1_12 * E4_12;
  const T b1_21 = b1_15 * E4_11;
  const T b1_22 = b1_17 * E4_13;
  const T b1_23 = b1_20 + b1_21 + b1_22;
  const T J1_12 = b1_23 + T(0.2);
  const T b1_24 = b1_12 * E4_13 + b1_15 * E4_12 + b1_17 * E4_11;
  const T J1_13 = b1_24 - T(0.1);
  const T b1_25 = E2_23 * T(12);
  const T b1_26 = E2_23 * b1_25;
  const T b1_27 = E3_23 * T(12);
  const T b1_28 = E3_23 * b1_27;
  const T b1_29 = b1_18 + b1_13 + b1_16;
  const T J1_22 = b1_26 + b1_28 + b1_29 + T(15.66);
  const T b1_30 = b1_22 + b1_20 + b1_21;
  const T b1_31 = E2_22 * b1_25;
  const T b1_32 = E3_22 * b1_27;
  const T J1_23 = b1_30 - (b1_31 + b1_32) + T(0.3) - T(0.6) * hc2_3 - T(0.6) * minus_hc3_3;
  const T b1_33 = T(12) - b1_26;
  const T b1_34 = T(12) - b1_28;
  const T b1_35 = T(0.047400000000000005) - b1_19 - b1_29;
  const T J1_33 = b1_33 + b1_9 + b1_34 + b1_35 + T(25.98) + T(1.2) * hc2_2;
  // K_thetadot4_1 = E4^T K_thetadot4_4
  const T K_thetadot4_1_1 = E4_11 * T(0.011547005383792516) + E4_13 * T(0.011547005383792516) + E4_12 *
      T(0.011547005383792516);
  // K_thetadot3_1 = q3~ E3^T B_thetadot3_3 + E3^T K_thetadot3_3
  const T K_thetadot3_1_1 = T(12) + T(0.6) * minus_hc3_2;
  // D_omegadot1: pivots of L D L^T
  const T b1_36 = K_thetadot4_1_1 * T(50);
  const T b1_37 = b1_36 * K_thetadot4_1_1;
  const T b1_38 = K_thetadot3_1_1 * T(0.08333333333333333);
  const T b1_39 = b1_8 * T(0.08333333333333333);
  const T D_omegadot1_1 = J1_11 - b1_37 - b1_38 * K_thetadot3_1_1 - b1_39 * b1_8;
  const T b1_40 = J1_12 - b1_37;
  const T b1_41 = T(1) / D_omegadot1_1;
  const T b1_42 = b1_40 * b1_41;
  const T D_omegadot1_2 = J1_22 - b1_37 - b1_42 * b1_40;
  const T b1_43 = J1_13 - b1_37;
  const T b1_44 = b1_43 * b1_41;
  const T b1_45 = J1_23 - b1_37 - b1_44 * b1_40;
  const T b1_46 = T(1) / D_omegadot1_2;
  const T b1_47 = b1_45 * b1_46;
  const T D_omegadot1_3 = J1_33 - b1_37 - b1_44 * b1_43 - b1_47 * b1_45;
  // D_Pddot1: pivots of L D L^T
  const T b1_48 = h1_3 * b1_46;
  const T b1_49 = b1_48 * b1_45 - minus_h1_2;
  const T b1_50 = T(1) / D_omegadot1_3;
  const T b1_51 = b1_49 * b1_50;
  const T D_Pddot1_1 = T(142) - b1_48 * h1_3 - b1_51 * b1_49;
  const T b1_52 = minus_hc3_3 * T(0.08333333333333333);
  const T b1_53 = hc2_3 * T(0.08333333333333333);
  const T b1_54 = h1_3 + b1_52 * K_thetadot3_1_1 - b1_53 * b1_8;
  const T b1_55 = b1_54 * b1_41;
  const T b1_56 = b1_55 * b1_40;
  const T b1_57 = b1_56 * b1_46;
  const T b1_58 = b1_55 * b1_43 - b1_57 * b1_45;
  const T b1_59 = b1_58 * b1_50;
  const T b1_60 = b1_59 * b1_49 - b1_57 * h1_3;
  const T b1_61 = T(1) / D_Pddot1_1;
  const T b1_62 = b1_60 * b1_61;
  const T D_Pddot1_2 = T(142) - b1_52 * minus_hc3_3 - b1_53 * hc2_3 - b1_55 * b1_54 - b1_57 * b1_56 - b1_59 * b1_58 -
      b1_62 * b1_60;
  const T b1_63 = minus_hc3_2 * T(0.08333333333333333);
  const T b1_64 = hc2_2 * T(0.08333333333333333);
  const T b1_65 = b1_63 * K_thetadot3_1_1 - minus_h1_2 - b1_64 * b1_8;
  const T b1_66 = b1_65 * b1_41;
  const T b1_67 = b1_66 * b1_40;
  const T b1_68 = b1_67 * b1_46;
  const T b1_69 = b1_68 * b1_45 - b1_66 * b1_43;
  const T b1_70 = b1_69 * b1_50;
  const T b1_71 = b1_68 * h1_3 + b1_70 * b1_49;
  const T b1_72 = b1_71 * b1_61;
  const T b1_73 = b1_63 * minus_hc3_3 + b1_64 * hc2_3 + b1_66 * b1_54 + b1_68 * b1_56 - b1_70 * b1_58 - b1_72 * b1_60;
  const T b1_74 = T(1) / D_Pddot1_2;
  const T b1_75 = b1_73 * b1_74;
  const T D_Pddot1_3 = T(142) - b1_63 * minus_hc3_2 - b1_64 * hc2_2 - b1_66 * b1_65 - b1_68 * b1_67 - b1_70 * b1_69 -
      b1_72 * b1_71 - b1_75 * b1_73;

  // ---- body 1 (hub), solved
  // Pddot1: from A ydot = f by elimination
  const T z1_1 = u.wheel_torque - T(0.5773502691896257) * minus_N4_1 - T(0.5773502691896257) * minus_N4_2 -
      T(0.5773502691896257) * minus_N4_3;
  const T z1_2 = b1_36 * z1_1;
  const T z1_3 = minus_effort_right_panel_3 + minus_N3_1;
  const T z1_4 = minus_effort_left_panel_2 + minus_N2_1;
  const T z1_5 = b1_38 * z1_3 - (minus_f_omega1_1 + z1_2) + b1_39 * z1_4;
  const T z1_6 = minus_f_omega1_2 + z1_2 + b1_42 * z1_5;
  const T z1_7 = f_omega1_3 - z1_2 - b1_44 * z1_5 + b1_47 * z1_6;
  const T z1_8 = S1_1 + b1_48 * z1_6 + b1_51 * z1_7;
  const T z1_9 = S1_2 + b1_52 * z1_3 - b1_53 * z1_4 + b1_55 * z1_5 + b1_57 * z1_6 - b1_59 * z1_7 - b1_62 * z1_8;
  const T z1_10 = T(1) / D_Pddot1_3 * (b1_64 * z1_4 - (minus_S1_3 + b1_63 * z1_3) - b1_66 * z1_5 - b1_68 * z1_6 -
      b1_70 * z1_7 - b1_72 * z1_8 - b1_75 * z1_9);
  const T z1_11 = z1_9 * b1_74 - b1_75 * z1_10;
  const T Pddot1_1 = z1_8 * b1_61 - b1_62 * z1_11 - b1_72 * z1_10;
  // omegadot1: from A ydot = f by elimination
  const T z1_12 = z1_7 * b1_50 + b1_51 * Pddot1_1 - b1_59 * z1_11 - b1_70 * z1_10;
  const T z1_13 = b1_68 * z1_10 - (z1_6 * b1_46 + b1_47 * z1_12 + b1_48 * Pddot1_1 + b1_57 * z1_11);
  const T omegadot1_1 = z1_5 * b1_41 - b1_42 * z1_13 - b1_44 * z1_12 + b1_55 * z1_11 - b1_66 * z1_10;
  // sddot1 = R1^T Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_1 = R1_11 * Pddot1_1 + R1_21 * z1_11 + R1_31 * z1_10;
  const T sddot1_2 = R1_12 * Pddot1_1 + R1_22 * z1_11 + R1_32 * z1_10;
  const T sddot1_3 = R1_13 * Pddot1_1 + R1_23 * z1_11 + R1_33 * z1_10;

  // ---- body 2 (left_panel), solved
  // thetaddot2: from A ydot = f by elimination
  const T thetaddot2 = b1_53 * z1_11 - (T(0.08333333333333333) * z1_4 + b1_39 * omegadot1_1) - b1_64 * z1_10;

  // ---- body 3 (right_panel), solved
  // thetaddot3: from A ydot = f by elimination
  const T thetaddot3 = b1_63 * z1_10 - (T(0.08333333333333333) * z1_3 + b1_38 * omegadot1_1 + b1_52 * z1_11);

  // ---- body 4 (wheel), solved
  // thetaddot4: from A ydot = f by elimination
  const T thetaddot4 = z1_1 * T(50) - b1_36 * omegadot1_1 - b1_36 * z1_13 - b1_36 * z1_12;

  // ---- body 1 (hub) on the inertial frame
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U1_12_of_r = U1_12 - z1_12;
  const T U1_13_of_r = U1_13 + z1_13;
  const T U1_21_of_r = U1_12 + z1_12;
  const T U1_23_of_r = U1_23 - omegadot1_1;
  const T U1_31_of_r = U1_13 - z1_13;
  const T U1_32_of_r = U1_23 + omegadot1_1;
  // Pddot1 = R1 sddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1_of_r = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * sddot1_3;
  const T Pddot1_2_of_r = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * sddot1_3;
  const T Pddot1_3_of_r = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * sddot1_3;
  // G1 = m_all_1 Pddot1 + U1 h_all_1: inertia less applied force, body axes [N]
  const T t1_16 = T(142) * Pddot1_1_of_r;
  const T G1_1_of_r = t1_16 - U1_13_of_r * T(0.8);
  const T t1_17 = T(142) * Pddot1_2_of_r;
  const T G1_2_of_r = t1_17 - U1_23_of_r * T(0.8);
  const T t1_18 = T(142) * Pddot1_3_of_r;
  const T G1_3_of_r = t1_18 + minus_G1_3;

  // ---- body 2 (left_panel) on body 1
  // omegadot2 = -thetadot2 b2~ E2 omega1 + thetaddot2 b2 + E2 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_1_of_r = thetaddot2 + omegadot1_1;
  const T omegadot2_3_of_r = E2_22 * z1_12 - minus_omegadot2_3 - E2_23 * z1_13;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U2_12_of_r = t2_1 - omegadot2_3_of_r;
  const T U2_32_of_r = U2_23 + omegadot2_1_of_r;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_5 = U1_12_of_r * T(0.6);
  const T Pddot2_1_of_r = t2_5 + Pddot1_1_of_r;
  // G2 = U2 h_own_2: inertia less applied force, body axes [N]
  const T G2_1_of_r = U2_12_of_r * T(9);
  const T G2_3_of_r = U2_32_of_r * T(9);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T minus_N2_3_of_r = T(9) * Pddot2_1_of_r + T(12) * U2_12_of_r;
  // Pddotc2 = U1 q2 + Pddot1: acceleration of the body origin, less gravity, lower body's axes [m/s^2]
  const T Pddotc2_2 = Pddot1_2_of_r - t2_2;
  const T t2_6 = U1_32_of_r * T(0.6);
  const T Pddotc2_3 = t2_6 + Pddot1_3_of_r;

  // ---- body 3 (right_panel) on body 1
  // omegadot3 = -thetadot3 b3~ E3 omega1 + thetaddot3 b3 + E3 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1_of_r = thetaddot3 + omegadot1_1;
  const T omegadot3_3_of_r = E3_22 * z1_12 - minus_omegadot3_3 - E3_23 * z1_13;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U3_12_of_r = t3_1 - omegadot3_3_of_r;
  const T U3_32_of_r = U3_23 + omegadot3_1_of_r;
  // Pddot3 = E3 (U1 q3 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot3_1_of_r = Pddot1_1_of_r - t2_5;
  // G3 = U3 h_own_3: inertia less applied force, body axes [N]
  const T minus_G3_1_of_r = U3_12_of_r * T(9);
  const T minus_G3_3_of_r = U3_32_of_r * T(9);
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_3_of_r = T(9) * Pddot3_1_of_r - T(12) * U3_12_of_r;
  // Pddotc3 = U1 q3 + Pddot1: acceleration of the body origin, less gravity, lower body's axes [m/s^2]
  const T Pddotc3_2 = t2_2 + Pddot1_2_of_r;
  const T Pddotc3_3 = Pddot1_3_of_r - t2_6;

  // ---- body 4 (wheel) on body 1
  // omegadot4 = -thetadot4 b4~ E4 omega1 + thetaddot4 b4 + E4 omegadot1: angular acceleration, body axes [rad/s^2]
  const T t4_20 = thetaddot4 * T(0.5773502691896257);
  const T omegadot4_1_of_r = t4_20 - minus_omegadot4_1 + E4_11 * omegadot1_1 + E4_12 * z1_13 + E4_13 * z1_12;
  const T omegadot4_2_of_r = t4_20 - minus_omegadot4_2 + E4_13 * omegadot1_1 + E4_11 * z1_13 + E4_12 * z1_12;
  const T omegadot4_3_of_r = t4_20 - minus_omegadot4_3 + E4_12 * omegadot1_1 + E4_13 * z1_13 + E4_11 * z1_12;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T U4_12_of_r = t4_13 - omegadot4_3_of_r;
  const T U4_13_of_r = t4_14 + omegadot4_2_of_r;
  const T U4_21_of_r = t4_13 + omegadot4_3_of_r;
  const T U4_23_of_r = t4_16 - omegadot4_1_of_r;
  const T U4_31_of_r = t4_14 - omegadot4_2_of_r;
  const T U4_32_of_r = t4_16 + omegadot4_1_of_r;
  // N4 = axial(U4 (tr(I4)/2 - I4)): inertia less applied moment about the body origin, body axes [N m]
  const T N4_1_of_r = T(0.0079) * U4_32_of_r - t4_17 - T(0.0079) * U4_23_of_r - T(0.0021) * U4_31_of_r + T(0.0021) *
      U4_21_of_r;
  const T N4_2_of_r = T(0.0079) * U4_13_of_r - t4_18 - T(0.0079) * U4_31_of_r - T(0.0021) * U4_12_of_r + T(0.0021) *
      U4_32_of_r;
  const T N4_3_of_r = T(0.0079) * U4_21_of_r - t4_19 - T(0.0079) * U4_12_of_r - T(0.0021) * U4_23_of_r + T(0.0021) *
      U4_13_of_r;

  // ---- body 4 (wheel) and what it carries
  // KC4 = -2 omega4~ (tr(I4)/2 - I4): moment of the Coriolis forces of an angular velocity, body axes [kg m^2/s]
  const T b4_1 = T(2) * omega4_2;
  const T b4_2 = b4_1 * T(0.0021);
  const T b4_3 = T(2) * omega4_3;
  const T b4_4 = b4_3 * T(0.0021);
  const T KC4_11 = b4_2 - b4_4;
  const T b4_5 = b4_3 * T(0.0079);
  const T KC4_12 = b4_5 + b4_2;
  const T b4_6 = b4_1 * T(0.0079);
  const T minus_KC4_13 = b4_4 + b4_6;
  const T b4_7 = T(2) * omega4_1;
  const T b4_8 = b4_7 * T(0.0021);
  const T minus_KC4_21 = b4_5 + b4_8;
  const T KC4_22 = b4_4 - b4_8;
  const T b4_9 = b4_7 * T(0.0079);
  const T KC4_23 = b4_4 + b4_9;
  const T KC4_31 = b4_6 + b4_8;
  const T minus_KC4_32 = b4_2 + b4_9;
  const T KC4_33 = b4_8 - b4_2;
  // KCc4 = E4^T KC4 E4: the same in the lower body's axes
  const T b4_10 = E4_11 * KC4_11 - E4_13 * minus_KC4_21 + E4_12 * KC4_31;
  const T b4_11 = E4_13 * KC4_22 + E4_11 * KC4_12 - E4_12 * minus_KC4_32;
  const T b4_12 = E4_13 * KC4_23 - E4_11 * minus_KC4_13 + E4_12 * KC4_33;
  const T KCc4_11 = b4_10 * E4_11 + b4_11 * E4_13 + b4_12 * E4_12;
  const T KCc4_12 = b4_10 * E4_12 + b4_11 * E4_11 + b4_12 * E4_13;
  const T KCc4_13 = b4_10 * E4_13 + b4_11 * E4_12 + b4_12 * E4_11;
  const T b4_13 = E4_12 * KC4_11 - E4_11 * minus_KC4_21 + E4_13 * KC4_31;
  const T b4_14 = E4_11 * KC4_22 + E4_12 * KC4_12 - E4_13 * minus_KC4_32;
  const T b4_15 = E4_11 * KC4_23 - E4_12 * minus_KC4_13 + E4_13 * KC4_33;
  const T KCc4_21 = b4_13 * E4_11 + b4_14 * E4_13 + b4_15 * E4_12;
  const T KCc4_22 = b4_13 * E4_12 + b4_14 * E4_11 + b4_15 * E4_13;
  const T KCc4_23 = b4_13 * E4_13 + b4_14 * E4_12 + b4_15 * E4_11;
  const T b4_16 = E4_13 * KC4_11 - E4_12 * minus_KC4_21 + E4_11 * KC4_31;
  const T b4_17 = E4_12 * KC4_22 + E4_13 * KC4_12 - E4_11 * minus_KC4_32;
  const T b4_18 = E4_12 * KC4_23 - E4_13 * minus_KC4_13 + E4_11 * KC4_33;
  const T KCc4_31 = b4_16 * E4_11 + b4_17 * E4_13 + b4_18 * E4_12;
  const T KCc4_32 = b4_16 * E4_12 + b4_17 * E4_11 + b4_18 * E4_13;
  const T KCc4_33 = b4_16 * E4_13 + b4_17 * E4_12 + b4_18 * E4_11;

  // ---- body 3 (right_panel) and what it carries
  // hdot3 = 2 omega3~ h_own_3: twice the rate of the first moment carried, body axes [kg m/s]
  const T b3_1 = T(2) * omega3_3;
  const T hdot3_1 = b3_1 * T(9);
  const T b3_2 = T(2) * omega3_1;
  const T minus_hdot3_3 = b3_2 * T(9);
  // KC3 = -2 omega3~ (tr(J_own_3)/2 - J_own_3): moment of the Coriolis forces of an angular velocity, body axes [kg
  //   m^2/s]
  const T KC3_12 = b3_1 * T(12);
  const T minus_KC3_32 = b3_2 * T(12);
  // hdotc3 = E3^T hdot3: the same in the lower body's axes
  const T hdotc3_2 = E3_23 * minus_hdot3_3;
  const T minus_hdotc3_3 = E3_22 * minus_hdot3_3;
  // KCc3 = E3^T KC3 E3: the same in the lower body's axes
  const T KCc3_12 = E3_22 * KC3_12;
  const T KCc3_13 = E3_23 * KC3_12;
  const T b3_3 = E3_22 * minus_KC3_32;
  const T KCc3_22 = E3_23 * b3_3;
  const T b3_4 = E3_22 * b3_3;
  const T KCc3_23 = minus_KC3_32 - b3_4;

  // ---- body 2 (left_panel) and what it carries
  // hdot2 = 2 omega2~ h_own_2: twice the rate of the first moment carried, body axes [kg m/s]
  const T b2_1 = T(2) * omega2_3;
  const T minus_hdot2_1 = b2_1 * T(9);
  const T b2_2 = T(2) * omega2_1;
  const T hdot2_3 = b2_2 * T(9);
  // KC2 = -2 omega2~ (tr(J_own_2)/2 - J_own_2): moment of the Coriolis forces of an angular velocity, body axes [kg
  //   m^2/s]
  const T KC2_12 = b2_1 * T(12);
  const T minus_KC2_32 = b2_2 * T(12);
  // hdotc2 = E2^T hdot2: the same in the lower body's axes
  const T minus_hdotc2_2 = E2_23 * hdot2_3;
  const T hdotc2_3 = E2_22 * hdot2_3;
  // KCc2 = E2^T KC2 E2: the same in the lower body's axes
  const T KCc2_12 = E2_22 * KC2_12;
  const T KCc2_13 = E2_23 * KC2_12;
  const T b2_3 = E2_22 * minus_KC2_32;
  const T KCc2_22 = E2_23 * b2_3;
  const T b2_4 = E2_22 * b2_3;
  const T KCc2_23 = minus_KC2_32 - b2_4;

  // ---- body 1 (hub) and what it carries
  // S1 = E2^T G2 + E3^T G3 + G1: sum of the force balances of the subtree, body axes [N]
  const T S1_1_of_inertia_xi = G1_1_of_r + G2_1_of_r - minus_G3_1_of_r;
  const T b1_76 = b1_2 + E3_23 * minus_G3_3_of_r;
  const T b1_77 = b1_1 + E2_23 * G2_3_of_r;
  const T S1_2_of_inertia_xi = b1_76 - b1_77 + G1_2_of_r;
  const T b1_78 = E2_22 * G2_3_of_r - b1_3;
  const T b1_79 = b1_5 - E3_22 * minus_G3_3_of_r;
  const T S1_3_of_inertia_xi = b1_78 + b1_79 + G1_3_of_r;
  // Mq_thetadot4_1 = (-(E4^T N4)~ + Jc4 U1 + KCc4 omega1~) b4
  const T b1_80 = E4_13 * N4_1_of_r + E4_12 * N4_2_of_r + E4_11 * N4_3_of_r;
  const T b1_81 = E4_12 * N4_1_of_r + E4_11 * N4_2_of_r + E4_13 * N4_3_of_r;
  const T Mq_thetadot4_1_1 = (b1_23 * U1_21_of_r - b1_19 * minus_U1_11 + b1_24 * U1_31_of_r + KCc4_12 * omega1_3 -
      KCc4_13 * omega1_2) * T(0.5773502691896257) + (b1_80 + b1_19 * U1_12_of_r - b1_23 * minus_U1_22 + b1_24 *
      U1_32_of_r + KCc4_13 * omega1_1 - KCc4_11 * omega1_3) * T(0.5773502691896257) + (b1_19 * U1_13_of_r - b1_81 +
      b1_23 * U1_23_of_r - b1_24 * minus_U1_33 + KCc4_11 * omega1_2 - KCc4_12 * omega1_1) * T(0.5773502691896257);
  const T b1_82 = E4_11 * N4_1_of_r + E4_13 * N4_2_of_r + E4_12 * N4_3_of_r;
  const T Mq_thetadot4_1_2 = (b1_29 * U1_21_of_r - b1_80 - b1_23 * minus_U1_11 + b1_30 * U1_31_of_r + KCc4_22 *
      omega1_3 - KCc4_23 * omega1_2) * T(0.5773502691896257) + (b1_23 * U1_12_of_r - b1_29 * minus_U1_22 + b1_30 *
      U1_32_of_r + KCc4_23 * omega1_1 - KCc4_21 * omega1_3) * T(0.5773502691896257) + (b1_82 + b1_23 * U1_13_of_r +
      b1_29 * U1_23_of_r - b1_30 * minus_U1_33 + KCc4_21 * omega1_2 - KCc4_22 * omega1_1) * T(0.5773502691896257);
  const T Mq_thetadot4_1_3 = (b1_81 + b1_30 * U1_21_of_r - b1_24 * minus_U1_11 + b1_35 * U1_31_of_r + KCc4_32 *
      omega1_3 - KCc4_33 * omega1_2) * T(0.5773502691896257) + (b1_24 * U1_12_of_r - b1_82 - b1_30 * minus_U1_22 +
      b1_35 * U1_32_of_r + KCc4_33 * omega1_1 - KCc4_31 * omega1_3) * T(0.5773502691896257) + (b1_24 * U1_13_of_r +
      b1_30 * U1_23_of_r - b1_35 * minus_U1_33 + KCc4_31 * omega1_2 - KCc4_32 * omega1_1) * T(0.5773502691896257);
  // Fq_thetadot3_1 = -((E3^T G3)~ + hc3~ U1 + hdotc3~ omega1~) b3
  const T minus_Fq_thetadot3_1_1 = minus_hc3_3 * U1_21_of_r - minus_hc3_2 * U1_31_of_r + minus_hdotc3_3 * omega1_3 -
      hdotc3_2 * omega1_2;
  const T minus_Fq_thetadot3_1_2 = b1_79 + minus_hc3_3 * minus_U1_11 + hdot3_1 * omega1_2;
  const T minus_Fq_thetadot3_1_3 = hdot3_1 * omega1_3 - (minus_hc3_2 * minus_U1_11 + b1_76);
  // Mq_thetadot3_1 = q3~ Fq_thetadot3_1 + (-(E3^T N3)~ + hc3~ Pddotc3~ + Jc3 U1 + KCc3 omega1~) b3
  const T b1_83 = omega1_3 * KCc3_12 - omega1_2 * KCc3_13 + Pddotc3_3 * minus_hc3_3 + Pddotc3_2 * minus_hc3_2;
  const T b1_84 = minus_U1_11 * T(12);
  const T Mq_thetadot3_1_1 = b1_83 - b1_84 + T(0.6) * minus_Fq_thetadot3_1_3;
  const T Mq_thetadot3_1_2 = b1_28 * U1_21_of_r - b1_32 * U1_31_of_r - E3_22 * N3_3_of_r + KCc3_22 * omega1_3 -
      KCc3_23 * omega1_2;
  const T Mq_thetadot3_1_3 = b1_34 * U1_31_of_r - b1_32 * U1_21_of_r - E3_23 * N3_3_of_r + KCc3_22 * omega1_2 - b3_4 *
      omega1_3 - T(0.6) * minus_Fq_thetadot3_1_1;
  // Fq_thetadot2_1 = -((E2^T G2)~ + hc2~ U1 + hdotc2~ omega1~) b2
  const T minus_Fq_thetadot2_1_1 = hc2_2 * U1_31_of_r - hc2_3 * U1_21_of_r + minus_hdotc2_2 * omega1_2 - hdotc2_3 *
      omega1_3;
  const T minus_Fq_thetadot2_1_2 = b1_78 - hc2_3 * minus_U1_11 - minus_hdot2_1 * omega1_2;
  const T minus_Fq_thetadot2_1_3 = hc2_2 * minus_U1_11 + b1_77 - minus_hdot2_1 * omega1_3;
  // Mq_thetadot2_1 = q2~ Fq_thetadot2_1 + (-(E2^T N2)~ + hc2~ Pddotc2~ + Jc2 U1 + KCc2 omega1~) b2
  const T b1_85 = omega1_3 * KCc2_12 - omega1_2 * KCc2_13 - Pddotc2_3 * hc2_3 - Pddotc2_2 * hc2_2;
  const T Mq_thetadot2_1_1 = b1_85 - b1_84 - T(0.6) * minus_Fq_thetadot2_1_3;
  const T Mq_thetadot2_1_2 = E2_22 * minus_N2_3_of_r + b1_26 * U1_21_of_r - b1_31 * U1_31_of_r + KCc2_22 * omega1_3 -
      KCc2_23 * omega1_2;
  const T Mq_thetadot2_1_3 = T(0.6) * minus_Fq_thetadot2_1_1 + E2_23 * minus_N2_3_of_r + b1_33 * U1_31_of_r - b1_31 *
      U1_21_of_r + KCc2_22 * omega1_2 - b2_4 * omega1_3;

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
  const T t1 = Pddot1_3_of_r * h1_3;
  const T t2 = Pddot1_2_of_r * minus_h1_2;
  const T t3 = Pddot1_3_of_r * minus_hc3_3 + Pddot1_2_of_r * minus_hc3_2;
  const T t4 = Pddot1_3_of_r * hc2_3 + Pddot1_2_of_r * hc2_2;
  const T t5 = t1 - t2 + b1_38 * t3 - b1_39 * t4;
  const T t6 = b1_42 * t5;
  const T t7 = b1_47 * t6 - b1_44 * t5;
  const T t8 = R1_21 * minus_hc3_3 - R1_31 * minus_hc3_2;
  const T t9 = t8 * T(0.08333333333333333);
  const T t10 = R1_31 * hc2_2 - R1_21 * hc2_3;
  const T t11 = t10 * T(0.08333333333333333);
  const T t12 = minus_h1_2 * R1_31 + h1_3 * R1_21 + t9 * K_thetadot3_1_1 + t11 * b1_8;
  const T t13 = t12 * b1_41;
  const T t14 = h1_3 * R1_11 + t13 * b1_40;
  const T t15 = t14 * b1_46;
  const T t16 = t15 * b1_45 - (minus_h1_2 * R1_11 + t13 * b1_43);
  const T t17 = t16 * b1_50;
  const T t18 = T(4) * eps1_3 * u.thrust;
  const T t19 = T(0.5) * eps1_2;
  const T t20 = T(4) * eps1_2 * u.thrust;
  const T t21 = T(0.5) * eps1_3;
  const T t22 = S1_3_of_inertia_xi - t1_18;
  const T t23 = t1_17 - S1_2_of_inertia_xi;
  const T t24 = t18 * t19 - t20 * t21 + R1_21 * t22 + R1_31 * t23 + t9 * t3 - t11 * t4 + t13 * t5 + t15 * t6 + t17 *
      t7;
  const T t25 = T(1) / (T(142) - t9 * t8 - t11 * t10 - t13 * t12 - t15 * t14 - t17 * t16);
  const T t26 = R1_22 * minus_hc3_3 - R1_32 * minus_hc3_2;
  const T t27 = t26 * T(0.08333333333333333);
  const T t28 = R1_32 * hc2_2 - R1_22 * hc2_3;
  const T t29 = t28 * T(0.08333333333333333);
  const T t30 = minus_h1_2 * R1_32 + h1_3 * R1_22 + t27 * K_thetadot3_1_1 + t29 * b1_8;
  const T t31 = t30 * b1_41;
  const T t32 = h1_3 * R1_12 + t31 * b1_40;
  const T t33 = t32 * b1_46;
  const T t34 = t33 * b1_45 - (minus_h1_2 * R1_12 + t31 * b1_43);
  const T t35 = t34 * b1_50;
  const T t36 = t27 * t8 + t29 * t10 + t31 * t12 + t33 * t14 + t35 * t16;
  const T t37 = t36 * t25;
  const T t38 = u.thrust * t1_1;
  const T t39 = T(0.5) * eps1_4;
  const T t40 = u.thrust * t1_3;
  const T t41 = T(0.5) * eps1_1;
  const T t42 = eps1_4 * T(2) * u.thrust;
  const T t43 = u.thrust * t1_5;
  const T t44 = t38 * t39 - t40 * t41 - t42 * t19 + t43 * t21 + R1_22 * t22 + R1_32 * t23 + t27 * t3 - t29 * t4 + t31
      * t5 + t33 * t6 + t35 * t7 + t37 * t24;
  const T t45 = T(1) / (T(142) - t27 * t26 - t29 * t28 - t31 * t30 - t33 * t32 - t35 * t34 - t37 * t36);
  const T t46 = R1_23 * minus_hc3_3 - R1_33 * minus_hc3_2;
  const T t47 = t46 * T(0.08333333333333333);
  const T t48 = R1_33 * hc2_2 - R1_23 * hc2_3;
  const T t49 = t48 * T(0.08333333333333333);
  const T t50 = minus_h1_2 * R1_33 + h1_3 * R1_23 + t47 * K_thetadot3_1_1 + t49 * b1_8;
  const T t51 = t50 * b1_41;
  const T t52 = h1_3 * R1_13 + t51 * b1_40;
  const T t53 = t52 * b1_46;
  const T t54 = t53 * b1_45 - (minus_h1_2 * R1_13 + t51 * b1_43);
  const T t55 = t54 * b1_50;
  const T t56 = t47 * t8 + t49 * t10 + t51 * t12 + t53 * t14 + t55 * t16;
  const T t57 = t56 * t25;
  const T t58 = t47 * t26 + t49 * t28 + t51 * t30 + t53 * t32 + t55 * t34 + t57 * t36;
  const T t59 = t58 * t45;
  const T t60 = T(1) / (T(142) - t47 * t46 - t49 * t48 - t51 * t50 - t53 * t52 - t55 * t54 - t57 * t56 - t59 * t58);
  const T t61 = (t38 * t41 + t40 * t39 - t43 * t19 - t42 * t21 + R1_23 * t22 + R1_33 * t23 + t47 * t3 - t49 * t4 + t51
      * t5 + t53 * t6 + t55 * t7 + t57 * t24 + t59 * t44) * t60;
  const T t62 = t44 * t45 + t59 * t61;
  const T t63 = t24 * t25 + t37 * t62 + t57 * t61;
  const T t64 = t7 * b1_50 + t17 * t63 + t35 * t62 + t55 * t61;
  const T t65 = t6 * b1_46 + b1_47 * t64 + t15 * t63 + t33 * t62 + t53 * t61;
  const T t66 = t5 * b1_41 + b1_42 * t65 - b1_44 * t64 + t13 * t63 + t31 * t62 + t51 * t61;
  S[162] = t66;
  const T t67 = Pddot1_1_of_r * hc2_2;
  const T t68 = Pddot1_1_of_r * minus_hc3_2;
  const T t69 = b1_39 * t67 - (b1_38 * t68 - Pddot1_1_of_r * minus_h1_2);
  const T t70 = t1 - b1_42 * t69;
  const T t71 = S1_1_of_inertia_xi - t1_16;
  const T t72 = b1_44 * t69 - Pddot1_3_of_r * minus_h1_2 + b1_47 * t70;
  const T t73 = R1_31 * t71 - R1_11 * t22 - t18 * t41 - t20 * t39 - t9 * t68 + t11 * t67 + t13 * t69 - t15 * t70 - t17
      * t72;
  const T t74 = t42 * t41 + t43 * t39;
  const T t75 = t40 * t19 + t38 * t21;
  const T t76 = t74 - t75 + R1_32 * t71 - R1_12 * t22 - t27 * t68 + t29 * t67 + t31 * t69 - t33 * t70 - t35 * t72 +
      t37 * t73;
  const T t77 = t43 * t41 - t42 * t39;
  const T t78 = t40 * t21 - t38 * t19;
  const T t79 = (t77 - t78 + R1_33 * t71 - R1_13 * t22 - t47 * t68 + t49 * t67 + t51 * t69 - t53 * t70 - t55 * t72 +
      t57 * t73 + t59 * t76) * t60;
  const T t80 = t76 * t45 + t59 * t79;
  const T t81 = t73 * t25 + t37 * t80 + t57 * t79;
  const T t82 = t17 * t81 - t72 * b1_50 + t35 * t80 + t55 * t79;
  const T t83 = t70 * b1_46 - b1_47 * t82 - t15 * t81 - t33 * t80 - t53 * t79;
  const T t84 = t69 * b1_41 - b1_42 * t83 - b1_44 * t82 + t13 * t81 + t31 * t80 + t51 * t79;
  S[163] = t84;
  const T t85 = Pddot1_1_of_r * hc2_3;
  const T t86 = Pddot1_1_of_r * minus_hc3_3;
  const T t87 = b1_39 * t85 - (Pddot1_1_of_r * h1_3 + b1_38 * t86);
  const T t88 = Pddot1_2_of_r * h1_3 + b1_42 * t87;
  const T t89 = b1_47 * t88 - (t2 + b1_44 * t87);
  const T t90 = t20 * t41 - (R1_11 * t23 + R1_21 * t71 + t18 * t39) - t9 * t86 + t11 * t85 + t13 * t87 + t15 * t88 +
      t17 * t89;
  const T t91 = t29 * t85 - (t78 + t77 + R1_12 * t23 + R1_22 * t71 + t27 * t86) + t31 * t87 + t33 * t88 + t35 * t89 +
      t37 * t90;
  const T t92 = (t75 + t74 - R1_13 * t23 - R1_23 * t71 - t47 * t86 + t49 * t85 + t51 * t87 + t53 * t88 + t55 * t89 +
      t57 * t90 + t59 * t91) * t60;
  const T t93 = t91 * t45 + t59 * t92;
  const T t94 = t90 * t25 + t37 * t93 + t57 * t92;
  const T t95 = t89 * b1_50 + t17 * t94 + t35 * t93 + t55 * t92;
  const T t96 = t88 * b1_46 + b1_47 * t95 + t15 * t94 + t33 * t93 + t53 * t92;
  const T t97 = t87 * b1_41 + b1_42 * t96 - b1_44 * t95 + t13 * t94 + t31 * t93 + t51 * t92;
  S[164] = t97;
  const T t98 = c.p.k - b1_84;
  const T t99 = b1_85 + t98;
  const T t100 = b1_39 * t99 - Mq_thetadot2_1_1;
  const T t101 = Mq_thetadot2_1_2 + b1_42 * t100;
  const T t102 = b1_47 * t101 - (Mq_thetadot2_1_3 + b1_44 * t100);
  const T t103 = R1_11 * minus_Fq_thetadot2_1_1 + R1_21 * minus_Fq_thetadot2_1_2 + R1_31 * minus_Fq_thetadot2_1_3 +
      t11 * t99 + t13 * t100 + t15 * t101 + t17 * t102;
  const T t104 = R1_12 * minus_Fq_thetadot2_1_1 + R1_22 * minus_Fq_thetadot2_1_2 + R1_32 * minus_Fq_thetadot2_1_3 +
      t29 * t99 + t31 * t100 + t33 * t101 + t35 * t102 + t37 * t103;
  const T t105 = (R1_13 * minus_Fq_thetadot2_1_1 + R1_23 * minus_Fq_thetadot2_1_2 + R1_33 * minus_Fq_thetadot2_1_3 +
      t49 * t99 + t51 * t100 + t53 * t101 + t55 * t102 + t57 * t103 + t59 * t104) * t60;
  const T t106 = t104 * t45 + t59 * t105;
  const T t107 = t103 * t25 + t37 * t106 + t57 * t105;
  const T t108 = t102 * b1_50 + t17 * t107 + t35 * t106 + t55 * t105;
  const T t109 = t101 * b1_46 + b1_47 * t108 + t15 * t107 + t33 * t106 + t53 * t105;
  const T t110 = t100 * b1_41 + b1_42 * t109 - b1_44 * t108 + t13 * t107 + t31 * t106 + t51 * t105;
  S[165] = t110;
  const T t111 = b1_83 + t98;
  const T t112 = b1_38 * t111 - Mq_thetadot3_1_1;
  const T t113 = Mq_thetadot3_1_2 + b1_42 * t112;
  const T t114 = b1_47 * t113 - (Mq_thetadot3_1_3 + b1_44 * t112);
  const T t115 = R1_11 * minus_Fq_thetadot3_1_1 + R1_21 * minus_Fq_thetadot3_1_2 + R1_31 * minus_Fq_thetadot3_1_3 + t9
      * t111 + t13 * t112 + t15 * t113 + t17 * t114;
  const T t116 = R1_12 * minus_Fq_thetadot3_1_1 + R1_22 * minus_Fq_thetadot3_1_2 + R1_32 * minus_Fq_thetadot3_1_3 +
      t27 * t111 + t31 * t112 + t33 * t113 + t35 * t114 + t37 * t115;
  const T t117 = (R1_13 * minus_Fq_thetadot3_1_1 + R1_23 * minus_Fq_thetadot3_1_2 + R1_33 * minus_Fq_thetadot3_1_3 +
      t47 * t111 + t51 * t112 + t53 * t113 + t55 * t114 + t57 * t115 + t59 * t116) * t60;
  const T t118 = t116 * t45 + t59 * t117;
  const T t119 = t115 * t25 + t37 * t118 + t57 * t117;
  const T t120 = t114 * b1_50 + t17 * t119 + t35 * t118 + t55 * t117;
  const T t121 = t113 * b1_46 + b1_47 * t120 + t15 * t119 + t33 * t118 + t53 * t117;
  const T t122 = t112 * b1_41 + b1_42 * t121 - b1_44 * t120 + t13 * t119 + t31 * t118 + t51 * t117;
  S[166] = t122;
  const T t123 = omega1_2 * T(0.5773502691896257);
  const T t124 = omega1_3 * T(0.5773502691896257);
  const T t125 = KCc4_11 * T(0.5773502691896257) + KCc4_21 * T(0.5773502691896257) + KCc4_31 * T(0.5773502691896257);
  const T t126 = omega1_1 * T(0.5773502691896257);
  const T t127 = KCc4_12 * T(0.5773502691896257) + KCc4_22 * T(0.5773502691896257) + KCc4_32 * T(0.5773502691896257);
  const T t128 = KCc4_13 * T(0.5773502691896257) + KCc4_23 * T(0.5773502691896257) + KCc4_33 * T(0.5773502691896257);
  const T t129 = b1_23 * T(0.5773502691896257);
  const T t130 = b1_24 * T(0.5773502691896257);
  const T t131 = t129 + t130 + b1_19 * T(0.5773502691896257);
  const T t132 = b1_30 * T(0.5773502691896257);
  const T t133 = t129 + t132 + b1_29 * T(0.5773502691896257);
  const T t134 = t130 + t132 + b1_35 * T(0.5773502691896257);
  const T t135 = (t123 - t124) * t125 + (t124 - t126) * t127 + (t126 - t123) * t128 + (U1_12_of_r *
      T(0.5773502691896257) - minus_U1_11 * T(0.5773502691896257) + U1_13_of_r * T(0.5773502691896257)) * t131 +
      (U1_21_of_r * T(0.5773502691896257) - minus_U1_22 * T(0.5773502691896257) + U1_23_of_r * T(0.5773502691896257))
      * t133 + (U1_31_of_r * T(0.5773502691896257) + U1_32_of_r * T(0.5773502691896257) - minus_U1_33 *
      T(0.5773502691896257)) * t134;
  const T t136 = b1_36 * t135;
  const T t137 = t136 - Mq_thetadot4_1_1;
  const T t138 = t136 - Mq_thetadot4_1_2 - b1_42 * t137;
  const T t139 = t136 - Mq_thetadot4_1_3 - b1_44 * t137 - b1_47 * t138;
  const T t140 = t17 * t139 - (t15 * t138 - t13 * t137);
  const T t141 = t35 * t139 - (t33 * t138 - t31 * t137) + t37 * t140;
  const T t142 = (t55 * t139 - (t53 * t138 - t51 * t137) + t57 * t140 + t59 * t141) * t60;
  const T t143 = t141 * t45 + t59 * t142;
  const T t144 = t140 * t25 + t37 * t143 + t57 * t142;
  const T t145 = t139 * b1_50 + t17 * t144 + t35 * t143 + t55 * t142;
  const T t146 = t138 * b1_46 - b1_47 * t145 - t15 * t144 - t33 * t143 - t53 * t142;
  const T t147 = t137 * b1_41 - b1_42 * t146 - b1_44 * t145 + t13 * t144 + t31 * t143 + t51 * t142;
  S[167] = t147;
  const T t148 = T(2) * omega1_2;
  const T t149 = omega1_2 * J1_13 + t148 * T(0.1);
  const T t150 = T(2) * omega1_3;
  const T t151 = omega1_3 * J1_12 - t150 * T(0.2);
  const T t152 = T(0.6) * hdotc3_2;
  const T t153 = T(0.6) * minus_hdotc2_2;
  const T t154 = t152 + t153;
  const T t155 = T(2) * omega1_1;
  const T t156 = t155 * T(0.6);
  const T t157 = t156 * minus_hc3_3;
  const T t158 = t156 * hc2_3;
  const T t159 = t157 + t158;
  const T t160 = t125 + omega1_3 * t133 - omega1_2 * t134;
  const T t161 = b1_36 * t160;
  const T t162 = t149 - t151 + t154 - t159 - KCc4_11 + t161 + b1_38 * t157 + b1_39 * t158;
  const T t163 = t161 - KCc4_21 + omega1_2 * J1_23 - omega1_3 * J1_22 - t155 * T(0.1) + t150 * T(9.5) - b1_42 * t162;
  const T t164 = t161 - KCc4_31 + omega1_2 * J1_33 - omega1_3 * J1_23 - t148 * T(9.5) - t155 * T(0.2) - b1_44 * t162 -
      b1_47 * t163;
  const T t165 = hdotc2_3 - minus_hdotc3_3;
  const T t166 = h1_3 * omega1_3;
  const T t167 = minus_h1_2 * omega1_2;
  const T t168 = t166 - t167;
  const T t169 = hdotc3_2 - minus_hdotc2_2 + t155 * T(0.8);
  const T t170 = R1_21 * t165 - R1_11 * t168 - R1_31 * t169 + t9 * t157 + t11 * t158 + t13 * t162 - t15 * t163 + t17 *
      t164;
  const T t171 = R1_22 * t165 - R1_12 * t168 - R1_32 * t169 + t27 * t157 + t29 * t158 + t31 * t162 - t33 * t163 + t35
      * t164 + t37 * t170;
  const T t172 = (R1_23 * t165 - R1_13 * t168 - R1_33 * t169 + t47 * t157 + t49 * t158 + t51 * t162 - t53 * t163 + t55
      * t164 + t57 * t170 + t59 * t171) * t60;
  const T t173 = t171 * t45 + t59 * t172;
  const T t174 = t170 * t25 + t37 * t173 + t57 * t172;
  const T t175 = t164 * b1_50 + t17 * t174 + t35 * t173 + t55 * t172;
  const T t176 = t163 * b1_46 - b1_47 * t175 - t15 * t174 - t33 * t173 - t53 * t172;
  const T t177 = t162 * b1_41 - b1_42 * t176 - b1_44 * t175 + t13 * t174 + t31 * t173 + t51 * t172;
  S[171] = t177;
  const T t178 = t127 + omega1_1 * t134 - omega1_3 * t131;
  const T t179 = b1_36 * t178;
  const T t180 = t150 * T(0.6);
  const T t181 = KCc2_12 + t180 * hc2_2;
  const T t182 = KCc3_12 + t180 * minus_hc3_2;
  const T t183 = t182 - omega1_3 * K_thetadot3_1_1;
  const T t184 = t181 - omega1_3 * b1_8;
  const T t185 = t179 - (KCc4_12 + t181 + t182) + omega1_3 * J1_11 - omega1_1 * J1_13 - t150 * T(16.48) - t148 *
      T(0.3) - T(0.6) * minus_hdot2_1 - T(0.6) * hdot3_1 + b1_38 * t183 + b1_39 * t184;
  const T t186 = KCc3_22 + KCc2_22 + omega1_1 * J1_23 - t155 * T(0.3);
  const T t187 = t151 - t186 - t159 - KCc4_22 + t179 - b1_42 * t185;
  const T t188 = b2_4 + b3_4 - KCc4_32 + t179 + omega1_3 * J1_13 - omega1_1 * J1_33 + t148 * T(0.2) + t155 * T(16.48)
      + T(0.6) * hdotc2_3 + T(0.6) * minus_hdotc3_3 + hc2_2 * t156 + minus_hc3_2 * t156 - b1_44 * t185 - b1_47 * t187;
  const T t189 = hdot3_1 - minus_hdot2_1 - t148 * T(0.8);
  const T t190 = t189 - minus_h1_2 * omega1_3;
  const T t191 = minus_h1_2 * omega1_1 + t165;
  const T t192 = R1_31 * t190 - (R1_11 * t191 + R1_21 * t166) + t9 * t183 + t11 * t184 + t13 * t185 - t15 * t187 + t17
      * t188;
  const T t193 = R1_32 * t190 - (R1_12 * t191 + R1_22 * t166) + t27 * t183 + t29 * t184 + t31 * t185 - t33 * t187 +
      t35 * t188 + t37 * t192;
  const T t194 = (R1_33 * t190 - (R1_13 * t191 + R1_23 * t166) + t47 * t183 + t49 * t184 + t51 * t185 - t53 * t187 +
      t55 * t188 + t57 * t192 + t59 * t193) * t60;
  const T t195 = t193 * t45 + t59 * t194;
  const T t196 = t192 * t25 + t37 * t195 + t57 * t194;
  const T t197 = t188 * b1_50 + t17 * t196 + t35 * t195 + t55 * t194;
  const T t198 = t187 * b1_46 - b1_47 * t197 - t15 * t196 - t33 * t195 - t53 * t194;
  const T t199 = t185 * b1_41 - b1_42 * t198 - b1_44 * t197 + t13 * t196 + t31 * t195 + t51 * t194;
  S[172] = t199;
  const T t200 = t128 + omega1_2 * t131 - omega1_1 * t133;
  const T t201 = b1_36 * t200;
  const T t202 = KCc2_13 + t180 * hc2_3;
  const T t203 = KCc3_13 + t180 * minus_hc3_3;
  const T t204 = t203 + omega1_2 * K_thetadot3_1_1;
  const T t205 = t202 + omega1_2 * b1_8;
  const T t206 = t201 - (t202 + t203 + KCc4_13) + omega1_1 * J1_12 - omega1_2 * J1_11 + t150 * T(0.3) + t148 * T(6.16)
      + b1_38 * t204 + b1_39 * t205;
  const T t207 = t201 - (KCc2_23 + KCc3_23 + KCc4_23) + omega1_1 * J1_22 - omega1_2 * J1_12 + t150 * T(0.1) - t155 *
      T(6.16) - b1_42 * t206;
  const T t208 = t186 - t149 + t154 - KCc4_33 + t201 - b1_44 * t206 - b1_47 * t207;
  const T t209 = t169 + h1_3 * omega1_1;
  const T t210 = h1_3 * omega1_2 - t189;
  const T t211 = R1_11 * t209 + R1_21 * t210 + R1_31 * t167 + t9 * t204 + t11 * t205 + t13 * t206 - t15 * t207 + t17 *
      t208;
  const T t212 = R1_12 * t209 + R1_22 * t210 + R1_32 * t167 + t27 * t204 + t29 * t205 + t31 * t206 - t33 * t207 + t35
      * t208 + t37 * t211;
  const T t213 = (R1_13 * t209 + R1_23 * t210 + R1_33 * t167 + t47 * t204 + t49 * t205 + t51 * t206 - t53 * t207 + t55
      * t208 + t57 * t211 + t59 * t212) * t60;
  const T t214 = t212 * t45 + t59 * t213;
  const T t215 = t211 * t25 + t37 * t214 + t57 * t213;
  const T t216 = t208 * b1_50 + t17 * t215 + t35 * t214 + t55 * t213;
  const T t217 = t207 * b1_46 - b1_47 * t216 - t15 * t215 - t33 * t214 - t53 * t213;
  const T t218 = t206 * b1_41 - b1_42 * t217 - b1_44 * t216 + t13 * t215 + t31 * t214 + t51 * t213;
  S[173] = t218;
  const T t219 = t153 + b1_39 * c.p.c;
  const T t220 = b1_26 * t150 + b1_31 * t148 + b1_42 * t219;
  const T t221 = T(2) * hc2_3 * omega1_3 + T(2) * hc2_2 * omega1_2;
  const T t222 = T(0.6) * t221 + b1_31 * t150 + b1_33 * t148 - b1_44 * t219 + b1_47 * t220;
  const T t223 = R1_21 * hdotc2_3 - R1_11 * t221 + R1_31 * minus_hdotc2_2 + t11 * c.p.c + t13 * t219 + t15 * t220 +
      t17 * t222;
  const T t224 = R1_22 * hdotc2_3 - R1_12 * t221 + R1_32 * minus_hdotc2_2 + t29 * c.p.c + t31 * t219 + t33 * t220 +
      t35 * t222 + t37 * t223;
  const T t225 = (R1_23 * hdotc2_3 - R1_13 * t221 + R1_33 * minus_hdotc2_2 + t49 * c.p.c + t51 * t219 + t53 * t220 +
      t55 * t222 + t57 * t223 + t59 * t224) * t60;
  const T t226 = t224 * t45 + t59 * t225;
  const T t227 = t223 * t25 + t37 * t226 + t57 * t225;
  const T t228 = t222 * b1_50 + t17 * t227 + t35 * t226 + t55 * t225;
  const T t229 = t220 * b1_46 + b1_47 * t228 + t15 * t227 + t33 * t226 + t53 * t225;
  const T t230 = t219 * b1_41 + b1_42 * t229 - b1_44 * t228 + t13 * t227 + t31 * t226 + t51 * t225;
  S[174] = t230;
  const T t231 = t152 + b1_38 * c.p.c;
  const T t232 = b1_28 * t150 + b1_32 * t148 + b1_42 * t231;
  const T t233 = T(2) * minus_hc3_3 * omega1_3 + T(2) * minus_hc3_2 * omega1_2;
  const T t234 = T(0.6) * t233 + b1_32 * t150 + b1_34 * t148 - b1_44 * t231 + b1_47 * t232;
  const T t235 = R1_11 * t233 - R1_21 * minus_hdotc3_3 - R1_31 * hdotc3_2 + t9 * c.p.c + t13 * t231 + t15 * t232 + t17
      * t234;
  const T t236 = R1_12 * t233 - R1_22 * minus_hdotc3_3 - R1_32 * hdotc3_2 + t27 * c.p.c + t31 * t231 + t33 * t232 +
      t35 * t234 + t37 * t235;
  const T t237 = (R1_13 * t233 - R1_23 * minus_hdotc3_3 - R1_33 * hdotc3_2 + t47 * c.p.c + t51 * t231 + t53 * t232 +
      t55 * t234 + t57 * t235 + t59 * t236) * t60;
  const T t238 = t236 * t45 + t59 * t237;
  const T t239 = t235 * t25 + t37 * t238 + t57 * t237;
  const T t240 = t234 * b1_50 + t17 * t239 + t35 * t238 + t55 * t237;
  const T t241 = t232 * b1_46 + b1_47 * t240 + t15 * t239 + t33 * t238 + t53 * t237;
  const T t242 = t231 * b1_41 + b1_42 * t241 - b1_44 * t240 + t13 * t239 + t31 * t238 + t51 * t237;
  S[175] = t242;
  const T t243 = t148 * T(0.5773502691896257);
  const T t244 = t150 * T(0.5773502691896257);
  const T t245 = t155 * T(0.5773502691896257);
  const T t246 = (t243 - t244) * t131 + (t244 - t245) * t133 + (t245 - t243) * t134 + T(0.5773502691896257) * t125 +
      T(0.5773502691896257) * t127 + T(0.5773502691896257) * t128;
  const T t247 = b1_36 * t246;
  const T t248 = b1_23 * t150;
  const T t249 = b1_24 * t148;
  const T t250 = t247 - (t248 - t249 + KCc4_11) * T(0.5773502691896257) - (KCc4_12 + b1_24 * t155 - b1_19 * t150) *
      T(0.5773502691896257) - (KCc4_13 + b1_19 * t148 - b1_23 * t155) * T(0.5773502691896257);
  const T t251 = b1_30 * t155;
  const T t252 = t247 - (KCc4_21 + b1_29 * t150 - b1_30 * t148) * T(0.5773502691896257) - (t251 - t248 + KCc4_22) *
      T(0.5773502691896257) - (KCc4_23 + b1_23 * t148 - b1_29 * t155) * T(0.5773502691896257) - b1_42 * t250;
  const T t253 = t247 - (KCc4_31 + b1_30 * t150 - b1_35 * t148) * T(0.5773502691896257) - (KCc4_32 + b1_35 * t155 -
      b1_24 * t150) * T(0.5773502691896257) - (t249 - t251 + KCc4_33) * T(0.5773502691896257) - b1_44 * t250 - b1_47 *
      t252;
  const T t254 = t17 * t253 - (t15 * t252 - t13 * t250);
  const T t255 = t35 * t253 - (t33 * t252 - t31 * t250) + t37 * t254;
  const T t256 = (t55 * t253 - (t53 * t252 - t51 * t250) + t57 * t254 + t59 * t255) * t60;
  const T t257 = t255 * t45 + t59 * t256;
  const T t258 = t254 * t25 + t37 * t257 + t57 * t256;
  const T t259 = t253 * b1_50 + t17 * t258 + t35 * t257 + t55 * t256;
  const T t260 = t252 * b1_46 - b1_47 * t259 - t15 * t258 - t33 * t257 - t53 * t256;
  const T t261 = t250 * b1_41 - b1_42 * t260 - b1_44 * t259 + t13 * t258 + t31 * t257 + t51 * t256;
  S[176] = t261;
  S[180] = -t65;
  S[181] = t83;
  S[182] = -t96;
  S[183] = -t109;
  S[184] = -t121;
  S[185] = t146;
  S[189] = t176;
  S[190] = t198;
  S[191] = t217;
  S[192] = -t229;
  S[193] = -t241;
  S[194] = t260;
  S[198] = t64;
  S[199] = t82;
  S[200] = t95;
  S[201] = t108;
  S[202] = t120;
  S[203] = t145;
  S[207] = t175;
  S[208] = t197;
  S[209] = t216;
  S[210] = t228;
  S[211] = t240;
  S[212] = t259;
  S[216] = t4 * T(0.08333333333333333) - b1_39 * t66 - t11 * t63 - t29 * t62 - t49 * t61;
  S[217] = -(t67 * T(0.08333333333333333) + b1_39 * t84 + t11 * t81 + t29 * t80 + t49 * t79);
  S[218] = -(t85 * T(0.08333333333333333) + b1_39 * t97 + t11 * t94 + t29 * t93 + t49 * t92);
  S[219] = -(t99 * T(0.08333333333333333) + b1_39 * t110 + t11 * t107 + t29 * t106 + t49 * t105);
  S[220] = -(b1_39 * t122 + t11 * t119 + t29 * t118 + t49 * t117);
  S[221] = -(b1_39 * t147 + t11 * t144 + t29 * t143 + t49 * t142);
  S[225] = -(t158 * T(0.08333333333333333) + b1_39 * t177 + t11 * t174 + t29 * t173 + t49 * t172);
  S[226] = -(t184 * T(0.08333333333333333) + b1_39 * t199 + t11 * t196 + t29 * t195 + t49 * t194);
  S[227] = -(t205 * T(0.08333333333333333) + b1_39 * t218 + t11 * t215 + t29 * t214 + t49 * t213);
  S[228] = -(c.c0_1 + b1_39 * t230 + t11 * t227 + t29 * t226 + t49 * t225);
  S[229] = -(b1_39 * t242 + t11 * t239 + t29 * t238 + t49 * t237);
  S[230] = -(b1_39 * t261 + t11 * t258 + t29 * t257 + t49 * t256);
  S[234] = -(t3 * T(0.08333333333333333) + b1_38 * t66 + t9 * t63 + t27 * t62 + t47 * t61);
  S[235] = t68 * T(0.08333333333333333) - b1_38 * t84 - t9 * t81 - t27 * t80 - t47 * t79;
  S[236] = t86 * T(0.08333333333333333) - b1_38 * t97 - t9 * t94 - t27 * t93 - t47 * t92;
  S[237] = -(b1_38 * t110 + t9 * t107 + t27 * t106 + t47 * t105);
  S[238] = -(t111 * T(0.08333333333333333) + b1_38 * t122 + t9 * t119 + t27 * t118 + t47 * t117);
  S[239] = -(b1_38 * t147 + t9 * t144 + t27 * t143 + t47 * t142);
  S[243] = -(t157 * T(0.08333333333333333) + b1_38 * t177 + t9 * t174 + t27 * t173 + t47 * t172);
  S[244] = -(t183 * T(0.08333333333333333) + b1_38 * t199 + t9 * t196 + t27 * t195 + t47 * t194);
  S[245] = -(t204 * T(0.08333333333333333) + b1_38 * t218 + t9 * t215 + t27 * t214 + t47 * t213);
  S[246] = -(b1_38 * t230 + t9 * t227 + t27 * t226 + t47 * t225);
  S[247] = -(c.c0_1 + b1_38 * t242 + t9 * t239 + t27 * t238 + t47 * t237);
  S[248] = -(b1_38 * t261 + t9 * t258 + t27 * t257 + t47 * t256);
  S[252] = -(b1_36 * t66 - b1_36 * t65 + b1_36 * t64);
  S[253] = -(b1_36 * t84 + b1_36 * t83 + b1_36 * t82);
  S[254] = -(b1_36 * t97 - b1_36 * t96 + b1_36 * t95);
  S[255] = -(b1_36 * t110 - b1_36 * t109 + b1_36 * t108);
  S[256] = -(b1_36 * t122 - b1_36 * t121 + b1_36 * t120);
  S[257] = -(t135 * T(50) + b1_36 * t147 + b1_36 * t146 + b1_36 * t145);
  S[261] = -(t160 * T(50) + b1_36 * t177 + b1_36 * t176 + b1_36 * t175);
  S[262] = -(t178 * T(50) + b1_36 * t199 + b1_36 * t198 + b1_36 * t197);
  S[263] = -(t200 * T(50) + b1_36 * t218 + b1_36 * t217 + b1_36 * t216);
  S[264] = -(b1_36 * t230 - b1_36 * t229 + b1_36 * t228);
  S[265] = -(b1_36 * t242 - b1_36 * t241 + b1_36 * t240);
  S[266] = -(t246 * T(50) + b1_36 * t261 + b1_36 * t260 + b1_36 * t259);
  S[270] = t63;
  S[271] = t81;
  S[272] = t94;
  S[273] = t107;
  S[274] = t119;
  S[275] = t144;
  S[279] = t174;
  S[280] = t196;
  S[281] = t215;
  S[282] = t227;
  S[283] = t239;
  S[284] = t258;
  S[288] = t62;
  S[289] = t80;
  S[290] = t93;
  S[291] = t106;
  S[292] = t118;
  S[293] = t143;
  S[297] = t173;
  S[298] = t195;
  S[299] = t214;
  S[300] = t226;
  S[301] = t238;
  S[302] = t257;
  S[306] = t61;
  S[307] = t79;
  S[308] = t92;
  S[309] = t105;
  S[310] = t117;
  S[311] = t142;
  S[315] = t172;
  S[316] = t194;
  S[317] = t213;
  S[318] = t225;
  S[319] = t237;
  S[320] = t256;
}

// input_matrix: rates of (xi, y) for small changes of the inputs.
// B (2 ny x n_inputs)
// 174 add, 221 multiply, 6 divide, 6 sine or cosine
// by: operations differentiated; equations differentiated would take 186 add, 236 multiply, 6 divide, 6 sine or
//   cosine
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
  const T t1 = E4_11 * T(0.5773502691896258) + E4_12 * T(0.5773502691896258) + E4_13 * T(0.5773502691896258);
  const T t2 = t1 - LD1_21 * t1;
  const T t3 = LD1_22 * t2;
  const T t4 = LD1_11 * t1;
  const T t5 = LD1_33 * (LD1_31 * t1 - t1 + LD1_32 * t2);
  const T t6 = Y1_31 * t5 - HA1_21 * t3;
  const T t7 = minus_Y1_22 * t3 - HA1_12 * t4 + Y1_32 * t5 + minus_LDs1_21 * t6;
  const T t8 = LDs1_33 * (HA1_13 * t4 - minus_Y1_23 * t3 - Y1_33 * t5 - minus_LDs1_31 * t6 + LDs1_32 * t7);
  const T t9 = LDs1_22 * t7 + LDs1_32 * t8;
  const T t10 = minus_LDs1_31 * t8 - (LDs1_11 * t6 + minus_LDs1_21 * t9);
  const T t11 = t5 + W1_32 * t9 - W1_31 * t10 - W1_33 * t8;
  const T t12 = t3 + W1_21 * t10 + minus_W1_22 * t9 - minus_W1_23 * t8 + LD1_32 * t11;
  const T t13 = W1_12 * t9 - (t4 + W1_13 * t8) + LD1_21 * t12 - LD1_31 * t11;
  B[18] = t13;
  const T t14 = LD1_33 * T(0.1);
  const T t15 = T(1) + Y1_31 * t14;
  const T t16 = Y1_32 * t14 + minus_LDs1_21 * t15;
  const T t17 = LDs1_33 * (Y1_33 * t14 + minus_LDs1_31 * t15 - LDs1_32 * t16);
  const T t18 = LDs1_22 * t16 - LDs1_32 * t17;
  const T t19 = LDs1_11 * t15 + minus_LDs1_21 * t18 + minus_LDs1_31 * t17;
  const T t20 = t14 + W1_31 * t19 + W1_32 * t18 + W1_33 * t17;
  const T t21 = W1_21 * t19 - minus_W1_22 * t18 - minus_W1_23 * t17 - LD1_32 * t20;
  const T t22 = LD1_21 * t21 - (W1_12 * t18 + W1_13 * t17) + LD1_31 * t20;
  B[19] = t22;
  B[20] = -t12;
  B[21] = -t21;
  B[22] = t11;
  B[23] = -t20;
  const T t23 = T(0.6) * t13;
  B[24] = -(t13 + T(0.75) * (E2_22 * t8 + E2_23 * t9 + E2_22 * t23));
  const T t24 = T(0.6) * t22;
  B[25] = -(t22 + T(0.75) * (E2_22 * t17 - E2_23 * t18 + E2_22 * t24));
  B[26] = T(0.75) * (E3_22 * t8 + E3_23 * t9 - E3_22 * t23) - t13;
  B[27] = T(0.75) * (E3_22 * t17 - E3_23 * t18 - E3_22 * t24) - t22;
  B[28] = T(50) - T(0.5773502691896258) * (E4_11 * t13 - E4_12 * t12 + E4_13 * t11) - T(0.5773502691896258) * (E4_13 *
      t13 - E4_11 * t12 + E4_12 * t11) - T(0.5773502691896258) * (E4_12 * t13 - E4_13 * t12 + E4_11 * t11);
  B[29] = -(T(0.5773502691896258) * (E4_11 * t22 - E4_12 * t21 - E4_13 * t20) + T(0.5773502691896258) * (E4_13 * t22 -
      E4_11 * t21 - E4_12 * t20) + T(0.5773502691896258) * (E4_12 * t22 - E4_13 * t21 - E4_11 * t20));
  B[30] = R1_11 * t10 - R1_21 * t9 + R1_31 * t8;
  B[31] = R1_11 * t19 + R1_21 * t18 + R1_31 * t17;
  B[32] = R1_12 * t10 - R1_22 * t9 + R1_32 * t8;
  B[33] = R1_12 * t19 + R1_22 * t18 + R1_32 * t17;
  B[34] = R1_13 * t10 - R1_23 * t9 + R1_33 * t8;
  B[35] = R1_13 * t19 + R1_23 * t18 + R1_33 * t17;
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
