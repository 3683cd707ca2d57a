// SPDX-License-Identifier: BSD-3-Clause
// bench_s6r: equations of motion of 6 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model ca892060618652c3 of bench_s6r/scene.toml; the usual functions
// bodies and their joints:
//   1 body_1 on the inertial frame: free
//   2 body_2 on 1: revolute
//   3 body_3 on 2: revolute
//   4 body_4 on 2: revolute
//   5 body_5 on 1: revolute
//   6 body_6 on 5: revolute
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, theta_2, theta_3, theta_4, theta_5, theta_6, s_1_1 .. s_1_3)
//   y = (omega_1_1 .. omega_1_3, thetadot_2, thetadot_3, thetadot_4, thetadot_5, thetadot_6, sdot_1_1 .. sdot_1_3)
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
//   kinematics              23 (8 add, 15 multiply)
//   poses                   263 (128 add, 135 multiply, 10 sine or cosine)
//   energy                  650 (285 add, 365 multiply, 10 sine or cosine)
//   momentum                865 (405 add, 460 multiply, 10 sine or cosine)
//   power                   71 (33 add, 38 multiply)
//   accelerations           1439 (685 add, 746 multiply, 8 divide, 10 sine or cosine)
//   residual                757 (373 add, 384 multiply, 10 sine or cosine)
//   forcing                 691 (332 add, 359 multiply, 10 sine or cosine)
//   mass_matrix             366 (172 add, 194 multiply, 10 sine or cosine)
//   partial_velocities      675 (303 add, 372 multiply, 10 sine or cosine)
//   partial_velocity_rates  1381 (584 add, 797 multiply, 10 sine or cosine)
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

namespace kanec::bench_s6r {

inline constexpr int n_bodies = 6;
inline constexpr int nx = 12;
inline constexpr int ny = 11;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 11;
inline constexpr char model_hash[] = "ca892060618652c3";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, theta_2 = 4, theta_3 = 5, theta_4 = 6,
    theta_5 = 7, theta_6 = 8, s_1_1 = 9, s_1_2 = 10, s_1_3 = 11;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, thetadot_2 = 3, thetadot_3 = 4, thetadot_4 = 5,
    thetadot_5 = 6, thetadot_6 = 7, sdot_1_1 = 8, sdot_1_2 = 9, sdot_1_3 = 10;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 101;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2,
    2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6,
    6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7, 8, 8, 8, 8, 8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9, 9, 9, 10, 10, 10, 10, 10, 10, 10,
    10, 10};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 0,
    1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 0, 1, 2, 3, 4, 5, 8, 9, 10, 0, 1, 2, 3, 4, 8, 9, 10, 0, 1, 2, 3, 5, 8, 9, 10, 0, 1,
    2, 6, 7, 8, 9, 10, 0, 1, 2, 6, 7, 8, 9, 10, 0, 1, 2, 3, 4, 5, 6, 7, 8, 0, 1, 2, 3, 4, 5, 6, 7, 9, 0, 1, 2, 3, 4,
    5, 6, 7, 10};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
  T F_1_1 = T(0);
  T F_1_2 = T(0);
  T F_1_3 = T(0);
  T M_1_1 = T(0);
  T M_1_2 = T(0);
  T M_1_3 = T(0);
  T tau_2 = T(0);
  T tau_3 = T(0);
  T tau_4 = T(0);
  T tau_5 = T(0);
  T tau_6 = T(0);
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

  // ---- body 1 (body_1) on the inertial frame
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
  const T thetadot5 = y[6];
  const T thetadot6 = y[7];
  const T sdot1_1 = y[8], sdot1_2 = y[9], sdot1_3 = y[10];
  xdot[4] = thetadot2;
  xdot[5] = thetadot3;
  xdot[6] = thetadot4;
  xdot[7] = thetadot5;
  xdot[8] = thetadot6;
  xdot[9] = sdot1_1;
  xdot[10] = sdot1_2;
  xdot[11] = sdot1_3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 128 add, 135 multiply, 10 sine or cosine
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  T cosines[9], sines[9];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 5, cosines + 4, sines + 4);

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[9], s1_2 = x[10], s1_3 = x[11];
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
  pose[18] = R1_31;
  pose[54] = R1_31;
  pose[7] = R1_32;
  pose[19] = R1_32;
  pose[55] = R1_32;
  pose[8] = R1_33;
  pose[20] = R1_33;
  pose[56] = R1_33;
  // p1 = s1 + R1^T r1: position of the mass centre, inertial axes [m]
  const T t1_13 = R1_31 * T(0.05);
  const T p1_1 = s1_1 + t1_13 + R1_11 * T(0.1) + R1_21 * T(0.2);
  const T t1_14 = R1_32 * T(0.05);
  const T p1_2 = s1_2 + t1_14 + R1_12 * T(0.1) + R1_22 * T(0.2);
  const T t1_15 = R1_33 * T(0.05);
  const T p1_3 = s1_3 + t1_15 + R1_13 * T(0.1) + R1_23 * T(0.2);
  pose[9] = p1_1;
  pose[10] = p1_2;
  pose[11] = p1_3;

  // ---- body 2 (body_2) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[4];
  const T E2_12 = sines[4];
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_11 = R1_11 * E2_11 + R1_21 * E2_12;
  const T R2_12 = R1_12 * E2_11 + R1_22 * E2_12;
  const T R2_13 = R1_13 * E2_11 + R1_23 * E2_12;
  const T R2_21 = R1_21 * E2_11 - R1_11 * E2_12;
  const T R2_22 = R1_22 * E2_11 - R1_12 * E2_12;
  const T R2_23 = R1_23 * E2_11 - R1_13 * E2_12;
  pose[12] = R2_11;
  pose[24] = R2_11;
  pose[13] = R2_12;
  pose[25] = R2_12;
  pose[14] = R2_13;
  pose[26] = R2_13;
  pose[15] = R2_21;
  pose[39] = R2_21;
  pose[16] = R2_22;
  pose[40] = R2_22;
  pose[17] = R2_23;
  pose[41] = R2_23;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_1 = R1_31 * T(0.1);
  const T t2_2 = t2_1 + s1_1 + R1_11 * T(0.3);
  const T P2_1 = t2_2 + R1_21 * T(0.1);
  const T t2_3 = R1_32 * T(0.1);
  const T t2_4 = t2_3 + s1_2 + R1_12 * T(0.3);
  const T P2_2 = t2_4 + R1_22 * T(0.1);
  const T t2_5 = R1_33 * T(0.1);
  const T t2_6 = t2_5 + s1_3 + R1_13 * T(0.3);
  const T P2_3 = t2_6 + R1_23 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_7 = R2_11 * T(0.1);
  const T t2_8 = R2_21 * T(0.2);
  const T t2_9 = t2_8 + P2_1;
  const T p2_1 = t2_7 + t2_9 + t1_13;
  const T t2_10 = R2_12 * T(0.1);
  const T t2_11 = R2_22 * T(0.2);
  const T t2_12 = t2_11 + P2_2;
  const T p2_2 = t2_10 + t2_12 + t1_14;
  const T t2_13 = R2_13 * T(0.1);
  const T t2_14 = R2_23 * T(0.2);
  const T t2_15 = t2_14 + P2_3;
  const T p2_3 = t2_13 + t2_15 + t1_15;
  pose[21] = p2_1;
  pose[22] = p2_2;
  pose[23] = p2_3;

  // ---- body 3 (body_3) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_21 = R2_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R2_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R2_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_31 * E3_22 - R2_21 * E3_23;
  const T R3_32 = R1_32 * E3_22 - R2_22 * E3_23;
  const T R3_33 = R1_33 * E3_22 - R2_23 * E3_23;
  pose[27] = R3_21;
  pose[28] = R3_22;
  pose[29] = R3_23;
  pose[30] = R3_31;
  pose[31] = R3_32;
  pose[32] = R3_33;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T t3_1 = t2_1 + R2_11 * T(0.3);
  const T P3_1 = t3_1 + P2_1 + R2_21 * T(0.15);
  const T t3_2 = t2_3 + R2_12 * T(0.3);
  const T P3_2 = t3_2 + P2_2 + R2_22 * T(0.15);
  const T t3_3 = t2_5 + R2_13 * T(0.3);
  const T P3_3 = t3_3 + P2_3 + R2_23 * T(0.15);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = t2_7 + P3_1 + R3_21 * T(0.2) + R3_31 * T(0.05);
  const T p3_2 = t2_10 + P3_2 + R3_22 * T(0.2) + R3_32 * T(0.05);
  const T p3_3 = t2_13 + P3_3 + R3_23 * T(0.2) + R3_33 * T(0.05);
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (body_4) on body 2
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R2^T E4^T: R takes inertial components to body components
  const T R4_11 = R2_11 * E4_11 - R1_31 * minus_E4_13;
  const T R4_12 = R2_12 * E4_11 - R1_32 * minus_E4_13;
  const T R4_13 = R2_13 * E4_11 - R1_33 * minus_E4_13;
  const T R4_31 = R2_11 * minus_E4_13 + R1_31 * E4_11;
  const T R4_32 = R2_12 * minus_E4_13 + R1_32 * E4_11;
  const T R4_33 = R2_13 * minus_E4_13 + R1_33 * E4_11;
  pose[36] = R4_11;
  pose[37] = R4_12;
  pose[38] = R4_13;
  pose[42] = R4_31;
  pose[43] = R4_32;
  pose[44] = R4_33;
  // P4 = R2^T q4 + P2: position of the body origin, inertial axes [m]
  const T P4_1 = t3_1 + t2_9;
  const T P4_2 = t3_2 + t2_12;
  const T P4_3 = t3_3 + t2_15;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = t2_8 + P4_1 + R4_11 * T(0.1) + R4_31 * T(0.05);
  const T p4_2 = t2_11 + P4_2 + R4_12 * T(0.1) + R4_32 * T(0.05);
  const T p4_3 = t2_14 + P4_3 + R4_13 * T(0.1) + R4_33 * T(0.05);
  pose[45] = p4_1;
  pose[46] = p4_2;
  pose[47] = p4_3;

  // ---- body 5 (body_5) on body 1
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[7];
  const T E5_12 = sines[7];
  // R5^T = R1^T E5^T: R takes inertial components to body components
  const T R5_11 = R1_11 * E5_11 + R1_21 * E5_12;
  const T R5_12 = R1_12 * E5_11 + R1_22 * E5_12;
  const T R5_13 = R1_13 * E5_11 + R1_23 * E5_12;
  const T R5_21 = R1_21 * E5_11 - R1_11 * E5_12;
  const T R5_22 = R1_22 * E5_11 - R1_12 * E5_12;
  const T R5_23 = R1_23 * E5_11 - R1_13 * E5_12;
  pose[48] = R5_11;
  pose[60] = R5_11;
  pose[49] = R5_12;
  pose[61] = R5_12;
  pose[50] = R5_13;
  pose[62] = R5_13;
  pose[51] = R5_21;
  pose[52] = R5_22;
  pose[53] = R5_23;
  // P5 = s1 + R1^T q5: position of the body origin, inertial axes [m]
  const T P5_1 = t2_2 + R1_21 * T(0.25);
  const T P5_2 = t2_4 + R1_22 * T(0.25);
  const T P5_3 = t2_6 + R1_23 * T(0.25);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T t5_1 = R5_11 * T(0.1);
  const T p5_1 = t5_1 + t1_13 + P5_1 + R5_21 * T(0.2);
  const T t5_2 = R5_12 * T(0.1);
  const T p5_2 = t5_2 + t1_14 + P5_2 + R5_22 * T(0.2);
  const T t5_3 = R5_13 * T(0.1);
  const T p5_3 = t5_3 + t1_15 + P5_3 + R5_23 * T(0.2);
  pose[57] = p5_1;
  pose[58] = p5_2;
  pose[59] = p5_3;

  // ---- body 6 (body_6) on body 5
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[8];
  const T E6_23 = sines[8];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_21 = R5_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R5_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R5_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R5_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R5_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R5_23 * E6_23;
  pose[63] = R6_21;
  pose[64] = R6_22;
  pose[65] = R6_23;
  pose[66] = R6_31;
  pose[67] = R6_32;
  pose[68] = R6_33;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T P6_1 = t2_1 + P5_1 + R5_11 * T(0.3) + R5_21 * T(0.3);
  const T P6_2 = t2_3 + P5_2 + R5_12 * T(0.3) + R5_22 * T(0.3);
  const T P6_3 = t2_5 + P5_3 + R5_13 * T(0.3) + R5_23 * T(0.3);
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = t5_1 + P6_1 + R6_21 * T(0.2) + R6_31 * T(0.05);
  const T p6_2 = t5_2 + P6_2 + R6_22 * T(0.2) + R6_32 * T(0.05);
  const T p6_3 = t5_3 + P6_3 + R6_23 * T(0.2) + R6_33 * T(0.05);
  pose[69] = p6_1;
  pose[70] = p6_2;
  pose[71] = p6_3;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 285 add, 365 multiply, 10 sine or cosine
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  T cosines[9], sines[9];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 5, cosines + 4, sines + 4);

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_3 = x[11];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[8], sdot1_2 = y[9], sdot1_3 = y[10];
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
  const T t1_13 = R1_33 * T(0.05);
  const T p1_3 = s1_3 + t1_13 + R1_13 * T(0.1) + R1_23 * T(0.2);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_14 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T t1_15 = omega1_3 * T(0.1);
  const T t1_16 = t1_15 - omega1_1 * T(0.05);
  const T t1_17 = omega1_2 * T(0.1);
  const T t1_18 = omega1_1 * T(0.2) - t1_17;
  const T v1_1 = sdot1_1 + R1_11 * t1_14 + R1_21 * t1_16 + R1_31 * t1_18;
  const T v1_2 = sdot1_2 + R1_12 * t1_14 + R1_22 * t1_16 + R1_32 * t1_18;
  const T v1_3 = sdot1_3 + R1_13 * t1_14 + R1_23 * t1_16 + R1_33 * t1_18;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.5) * (omega1_1 * (T(0.11) * omega1_1 + T(0.0055) * omega1_2 + T(0.0033) * omega1_3) + omega1_2 *
      (T(0.0055) * omega1_1 + T(0.132) * omega1_2 - T(0.0044) * omega1_3) + omega1_3 * (T(0.0033) * omega1_1 -
      T(0.0044) * omega1_2 + T(0.088) * omega1_3)) + T(0.55) * (v1_1 * v1_1 + v1_2 * v1_2 + v1_3 * v1_3);

  // ---- body 2 (body_2) on body 1
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[4];
  const T E2_12 = sines[4];
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_11 = R1_11 * E2_11 + R1_21 * E2_12;
  const T R2_12 = R1_12 * E2_11 + R1_22 * E2_12;
  const T R2_13 = R1_13 * E2_11 + R1_23 * E2_12;
  const T R2_21 = R1_21 * E2_11 - R1_11 * E2_12;
  const T R2_22 = R1_22 * E2_11 - R1_12 * E2_12;
  const T R2_23 = R1_23 * E2_11 - R1_13 * E2_12;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = E2_11 * omega1_1 + E2_12 * omega1_2;
  const T omega2_2 = E2_11 * omega1_2 - E2_12 * omega1_1;
  const T omega2_3 = thetadot2 + omega1_3;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_1 = R1_33 * T(0.1);
  const T t2_2 = t2_1 + s1_3 + R1_13 * T(0.3);
  const T P2_3 = t2_2 + R1_23 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_3 = R2_13 * T(0.1);
  const T t2_4 = R2_23 * T(0.2);
  const T t2_5 = t2_4 + P2_3;
  const T p2_3 = t2_3 + t2_5 + t1_13;
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_6 = omega1_1 * T(0.1);
  const T t2_7 = omega1_3 * T(0.3) - t2_6;
  const T t2_8 = sdot1_1 + R1_21 * t2_7;
  const T t2_9 = t1_17 - t1_15;
  const T t2_10 = omega1_2 * T(0.3);
  const T t2_11 = t2_6 - t2_10;
  const T Pdot2_1 = t2_8 + R1_11 * t2_9 + R1_31 * t2_11;
  const T t2_12 = sdot1_2 + R1_22 * t2_7;
  const T Pdot2_2 = t2_12 + R1_12 * t2_9 + R1_32 * t2_11;
  const T t2_13 = sdot1_3 + R1_23 * t2_7;
  const T Pdot2_3 = t2_13 + R1_13 * t2_9 + R1_33 * t2_11;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_14 = omega2_3 * T(0.2);
  const T t2_15 = omega2_2 * T(0.05) - t2_14;
  const T t2_16 = omega2_3 * T(0.1) - omega2_1 * T(0.05);
  const T t2_17 = omega2_1 * T(0.2);
  const T t2_18 = omega2_2 * T(0.1);
  const T t2_19 = t2_17 - t2_18;
  const T v2_1 = Pdot2_1 + R2_11 * t2_15 + R2_21 * t2_16 + R1_31 * t2_19;
  const T v2_2 = Pdot2_2 + R2_12 * t2_15 + R2_22 * t2_16 + R1_32 * t2_19;
  const T v2_3 = Pdot2_3 + R2_13 * t2_15 + R2_23 * t2_16 + R1_33 * t2_19;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (omega2_1 * (T(0.12) * omega2_1 + T(0.006) * omega2_2 + T(0.0036) * omega2_3) + omega2_2 *
      (T(0.006) * omega2_1 + T(0.144) * omega2_2 - T(0.0048) * omega2_3) + omega2_3 * (T(0.0036) * omega2_1 -
      T(0.0048) * omega2_2 + T(0.096) * omega2_3)) + T(0.6) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (body_3) on body 2
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_21 = R2_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R2_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R2_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_31 * E3_22 - R2_21 * E3_23;
  const T R3_32 = R1_32 * E3_22 - R2_22 * E3_23;
  const T R3_33 = R1_33 * E3_22 - R2_23 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega2_1;
  const T omega3_2 = E3_22 * omega2_2 + E3_23 * omega2_3;
  const T omega3_3 = E3_22 * omega2_3 - E3_23 * omega2_2;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T t3_1 = t2_1 + R2_13 * T(0.3);
  const T P3_3 = t3_1 + P2_3 + R2_23 * T(0.15);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_3 = t2_3 + P3_3 + R3_23 * T(0.2) + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_2 = t2_18 - omega2_3 * T(0.15);
  const T t3_3 = omega2_3 * T(0.3) - omega2_1 * T(0.1);
  const T t3_4 = Pdot2_1 + R2_21 * t3_3;
  const T t3_5 = omega2_2 * T(0.3);
  const T t3_6 = omega2_1 * T(0.15) - t3_5;
  const T Pdot3_1 = R2_11 * t3_2 + t3_4 + R1_31 * t3_6;
  const T t3_7 = Pdot2_2 + R2_22 * t3_3;
  const T Pdot3_2 = R2_12 * t3_2 + t3_7 + R1_32 * t3_6;
  const T t3_8 = Pdot2_3 + R2_23 * t3_3;
  const T Pdot3_3 = R2_13 * t3_2 + t3_8 + R1_33 * t3_6;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_9 = omega3_2 * T(0.05) - omega3_3 * T(0.2);
  const T t3_10 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_11 = omega3_1 * T(0.2) - omega3_2 * T(0.1);
  const T v3_1 = Pdot3_1 + R2_11 * t3_9 + R3_21 * t3_10 + R3_31 * t3_11;
  const T v3_2 = Pdot3_2 + R2_12 * t3_9 + R3_22 * t3_10 + R3_32 * t3_11;
  const T v3_3 = Pdot3_3 + R2_13 * t3_9 + R3_23 * t3_10 + R3_33 * t3_11;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (omega3_1 * (T(0.13) * omega3_1 + T(0.0065) * omega3_2 + T(0.0039) * omega3_3) + omega3_2 *
      (T(0.0065) * omega3_1 + T(0.156) * omega3_2 - T(0.0052) * omega3_3) + omega3_3 * (T(0.0039) * omega3_1 -
      T(0.0052) * omega3_2 + T(0.104) * omega3_3)) + T(0.65) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (body_4) on body 2
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R2^T E4^T: R takes inertial components to body components
  const T R4_11 = R2_11 * E4_11 - R1_31 * minus_E4_13;
  const T R4_12 = R2_12 * E4_11 - R1_32 * minus_E4_13;
  const T R4_13 = R2_13 * E4_11 - R1_33 * minus_E4_13;
  const T R4_31 = R2_11 * minus_E4_13 + R1_31 * E4_11;
  const T R4_32 = R2_12 * minus_E4_13 + R1_32 * E4_11;
  const T R4_33 = R2_13 * minus_E4_13 + R1_33 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega2: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega2_1 - minus_E4_13 * omega2_3;
  const T omega4_2 = thetadot4 + omega2_2;
  const T omega4_3 = minus_E4_13 * omega2_1 + E4_11 * omega2_3;
  // P4 = R2^T q4 + P2: position of the body origin, inertial axes [m]
  const T P4_3 = t3_1 + t2_5;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_3 = t2_4 + P4_3 + R4_13 * T(0.1) + R4_33 * T(0.05);
  // Pdot4 = R2^T omega2~ q4 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t4_1 = t2_18 - t2_14;
  const T t4_2 = t2_17 - t3_5;
  const T Pdot4_1 = R2_11 * t4_1 + t3_4 + R1_31 * t4_2;
  const T Pdot4_2 = R2_12 * t4_1 + t3_7 + R1_32 * t4_2;
  const T Pdot4_3 = R2_13 * t4_1 + t3_8 + R1_33 * t4_2;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_3 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_4 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_5 = omega4_1 * T(0.2) - omega4_2 * T(0.1);
  const T v4_1 = Pdot4_1 + R4_11 * t4_3 + R2_21 * t4_4 + R4_31 * t4_5;
  const T v4_2 = Pdot4_2 + R4_12 * t4_3 + R2_22 * t4_4 + R4_32 * t4_5;
  const T v4_3 = Pdot4_3 + R4_13 * t4_3 + R2_23 * t4_4 + R4_33 * t4_5;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (omega4_1 * (T(0.14) * omega4_1 + T(0.007) * omega4_2 + T(0.0042) * omega4_3) + omega4_2 *
      (T(0.007) * omega4_1 + T(0.168) * omega4_2 - T(0.0056) * omega4_3) + omega4_3 * (T(0.0042) * omega4_1 -
      T(0.0056) * omega4_2 + T(0.112) * omega4_3)) + T(0.7) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (body_5) on body 1
  const T thetadot5 = y[6];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[7];
  const T E5_12 = sines[7];
  // R5^T = R1^T E5^T: R takes inertial components to body components
  const T R5_11 = R1_11 * E5_11 + R1_21 * E5_12;
  const T R5_12 = R1_12 * E5_11 + R1_22 * E5_12;
  const T R5_13 = R1_13 * E5_11 + R1_23 * E5_12;
  const T R5_21 = R1_21 * E5_11 - R1_11 * E5_12;
  const T R5_22 = R1_22 * E5_11 - R1_12 * E5_12;
  const T R5_23 = R1_23 * E5_11 - R1_13 * E5_12;
  // omega5 = thetadot5 b5 + E5 omega1: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega1_1 + E5_12 * omega1_2;
  const T omega5_2 = E5_11 * omega1_2 - E5_12 * omega1_1;
  const T omega5_3 = thetadot5 + omega1_3;
  // P5 = s1 + R1^T q5: position of the body origin, inertial axes [m]
  const T P5_3 = t2_2 + R1_23 * T(0.25);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T t5_1 = R5_13 * T(0.1);
  const T p5_3 = t5_1 + t1_13 + P5_3 + R5_23 * T(0.2);
  // Pdot5 = sdot1 + R1^T omega1~ q5: velocity of the body origin, inertial axes [m/s]
  const T t5_2 = t1_17 - omega1_3 * T(0.25);
  const T t5_3 = omega1_1 * T(0.25) - t2_10;
  const T Pdot5_1 = t2_8 + R1_11 * t5_2 + R1_31 * t5_3;
  const T Pdot5_2 = t2_12 + R1_12 * t5_2 + R1_32 * t5_3;
  const T Pdot5_3 = t2_13 + R1_13 * t5_2 + R1_33 * t5_3;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_4 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_5 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_6 = omega5_2 * T(0.1);
  const T t5_7 = omega5_1 * T(0.2) - t5_6;
  const T v5_1 = Pdot5_1 + R5_11 * t5_4 + R5_21 * t5_5 + R1_31 * t5_7;
  const T v5_2 = Pdot5_2 + R5_12 * t5_4 + R5_22 * t5_5 + R1_32 * t5_7;
  const T v5_3 = Pdot5_3 + R5_13 * t5_4 + R5_23 * t5_5 + R1_33 * t5_7;
  // T5 = 1/2 omega5 . (I5 omega5) + 1/2 m5 v5 . v5: kinetic energy [J]
  const T T5 = T(0.5) * (omega5_1 * (T(0.15) * omega5_1 + T(0.0075) * omega5_2 + T(0.0045) * omega5_3) + omega5_2 *
      (T(0.0075) * omega5_1 + T(0.18) * omega5_2 - T(0.006) * omega5_3) + omega5_3 * (T(0.0045) * omega5_1 - T(0.006)
      * omega5_2 + T(0.12) * omega5_3)) + T(0.75) * (v5_1 * v5_1 + v5_2 * v5_2 + v5_3 * v5_3);

  // ---- body 6 (body_6) on body 5
  const T thetadot6 = y[7];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[8];
  const T E6_23 = sines[8];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_21 = R5_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R5_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R5_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R5_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R5_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R5_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega5_1;
  const T omega6_2 = E6_22 * omega5_2 + E6_23 * omega5_3;
  const T omega6_3 = E6_22 * omega5_3 - E6_23 * omega5_2;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T P6_3 = t2_1 + P5_3 + R5_13 * T(0.3) + R5_23 * T(0.3);
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_3 = t5_1 + P6_3 + R6_23 * T(0.2) + R6_33 * T(0.05);
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_1 = omega5_3 * T(0.3);
  const T t6_2 = t5_6 - t6_1;
  const T t6_3 = t6_1 - omega5_1 * T(0.1);
  const T t6_4 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_2 + R5_21 * t6_3 + R1_31 * t6_4;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_2 + R5_22 * t6_3 + R1_32 * t6_4;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_2 + R5_23 * t6_3 + R1_33 * t6_4;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_5 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_6 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_7 = omega6_1 * T(0.2) - omega6_2 * T(0.1);
  const T v6_1 = Pdot6_1 + R5_11 * t6_5 + R6_21 * t6_6 + R6_31 * t6_7;
  const T v6_2 = Pdot6_2 + R5_12 * t6_5 + R6_22 * t6_6 + R6_32 * t6_7;
  const T v6_3 = Pdot6_3 + R5_13 * t6_5 + R6_23 * t6_6 + R6_33 * t6_7;
  // T6 = 1/2 omega6 . (I6 omega6) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (omega6_1 * (T(0.16) * omega6_1 + T(0.008) * omega6_2 + T(0.0048) * omega6_3) + omega6_2 *
      (T(0.008) * omega6_1 + T(0.192) * omega6_2 - T(0.0064) * omega6_3) + omega6_3 * (T(0.0048) * omega6_1 -
      T(0.0064) * omega6_2 + T(0.128) * omega6_3)) + T(0.8) * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6: first moment of mass, inertial axes [kg m]
  const T mp_3 = T(1.1) * p1_3 + T(1.2) * p2_3 + T(1.3) * p3_3 + T(1.4) * p4_3 + T(1.5) * p5_3 + T(1.6) * p6_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 405 add, 460 multiply, 10 sine or cosine
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {
  T cosines[9], sines[9];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 5, cosines + 4, sines + 4);

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[9], s1_2 = x[10], s1_3 = x[11];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[8], sdot1_2 = y[9], sdot1_3 = y[10];
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
  const T t1_13 = R1_31 * T(0.05);
  const T p1_1 = s1_1 + t1_13 + R1_11 * T(0.1) + R1_21 * T(0.2);
  const T t1_14 = R1_32 * T(0.05);
  const T p1_2 = s1_2 + t1_14 + R1_12 * T(0.1) + R1_22 * T(0.2);
  const T t1_15 = R1_33 * T(0.05);
  const T p1_3 = s1_3 + t1_15 + R1_13 * T(0.1) + R1_23 * T(0.2);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_16 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T t1_17 = omega1_3 * T(0.1);
  const T t1_18 = t1_17 - omega1_1 * T(0.05);
  const T t1_19 = omega1_2 * T(0.1);
  const T t1_20 = omega1_1 * T(0.2) - t1_19;
  const T v1_1 = sdot1_1 + R1_11 * t1_16 + R1_21 * t1_18 + R1_31 * t1_20;
  const T v1_2 = sdot1_2 + R1_12 * t1_16 + R1_22 * t1_18 + R1_32 * t1_20;
  const T v1_3 = sdot1_3 + R1_13 * t1_16 + R1_23 * t1_18 + R1_33 * t1_20;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(1.1) * v1_1;
  const T l1_2 = T(1.1) * v1_2;
  const T l1_3 = T(1.1) * v1_3;
  // H1 = R1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_21 = T(0.11) * omega1_1 + T(0.0055) * omega1_2 + T(0.0033) * omega1_3;
  const T t1_22 = T(0.0055) * omega1_1 + T(0.132) * omega1_2 - T(0.0044) * omega1_3;
  const T t1_23 = T(0.0033) * omega1_1 - T(0.0044) * omega1_2 + T(0.088) * omega1_3;
  const T H1_1 = R1_11 * t1_21 + R1_21 * t1_22 + R1_31 * t1_23 + p1_2 * l1_3 - p1_3 * l1_2;
  const T H1_2 = R1_12 * t1_21 + R1_22 * t1_22 + R1_32 * t1_23 + p1_3 * l1_1 - p1_1 * l1_3;
  const T H1_3 = R1_13 * t1_21 + R1_23 * t1_22 + R1_33 * t1_23 + p1_1 * l1_2 - p1_2 * l1_1;

  // ---- body 2 (body_2) on body 1
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[4];
  const T E2_12 = sines[4];
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_11 = R1_11 * E2_11 + R1_21 * E2_12;
  const T R2_12 = R1_12 * E2_11 + R1_22 * E2_12;
  const T R2_13 = R1_13 * E2_11 + R1_23 * E2_12;
  const T R2_21 = R1_21 * E2_11 - R1_11 * E2_12;
  const T R2_22 = R1_22 * E2_11 - R1_12 * E2_12;
  const T R2_23 = R1_23 * E2_11 - R1_13 * E2_12;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = E2_11 * omega1_1 + E2_12 * omega1_2;
  const T omega2_2 = E2_11 * omega1_2 - E2_12 * omega1_1;
  const T omega2_3 = thetadot2 + omega1_3;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_1 = R1_31 * T(0.1);
  const T t2_2 = t2_1 + s1_1 + R1_11 * T(0.3);
  const T P2_1 = t2_2 + R1_21 * T(0.1);
  const T t2_3 = R1_32 * T(0.1);
  const T t2_4 = t2_3 + s1_2 + R1_12 * T(0.3);
  const T P2_2 = t2_4 + R1_22 * T(0.1);
  const T t2_5 = R1_33 * T(0.1);
  const T t2_6 = t2_5 + s1_3 + R1_13 * T(0.3);
  const T P2_3 = t2_6 + R1_23 * T(0.1);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_7 = R2_11 * T(0.1);
  const T t2_8 = R2_21 * T(0.2);
  const T t2_9 = t2_8 + P2_1;
  const T p2_1 = t2_7 + t2_9 + t1_13;
  const T t2_10 = R2_12 * T(0.1);
  const T t2_11 = R2_22 * T(0.2);
  const T t2_12 = t2_11 + P2_2;
  const T p2_2 = t2_10 + t2_12 + t1_14;
  const T t2_13 = R2_13 * T(0.1);
  const T t2_14 = R2_23 * T(0.2);
  const T t2_15 = t2_14 + P2_3;
  const T p2_3 = t2_13 + t2_15 + t1_15;
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_16 = omega1_1 * T(0.1);
  const T t2_17 = omega1_3 * T(0.3) - t2_16;
  const T t2_18 = sdot1_1 + R1_21 * t2_17;
  const T t2_19 = t1_19 - t1_17;
  const T t2_20 = omega1_2 * T(0.3);
  const T t2_21 = t2_16 - t2_20;
  const T Pdot2_1 = t2_18 + R1_11 * t2_19 + R1_31 * t2_21;
  const T t2_22 = sdot1_2 + R1_22 * t2_17;
  const T Pdot2_2 = t2_22 + R1_12 * t2_19 + R1_32 * t2_21;
  const T t2_23 = sdot1_3 + R1_23 * t2_17;
  const T Pdot2_3 = t2_23 + R1_13 * t2_19 + R1_33 * t2_21;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_24 = omega2_3 * T(0.2);
  const T t2_25 = omega2_2 * T(0.05) - t2_24;
  const T t2_26 = omega2_3 * T(0.1) - omega2_1 * T(0.05);
  const T t2_27 = omega2_1 * T(0.2);
  const T t2_28 = omega2_2 * T(0.1);
  const T t2_29 = t2_27 - t2_28;
  const T v2_1 = Pdot2_1 + R2_11 * t2_25 + R2_21 * t2_26 + R1_31 * t2_29;
  const T v2_2 = Pdot2_2 + R2_12 * t2_25 + R2_22 * t2_26 + R1_32 * t2_29;
  const T v2_3 = Pdot2_3 + R2_13 * t2_25 + R2_23 * t2_26 + R1_33 * t2_29;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(1.2) * v2_1;
  const T l2_2 = T(1.2) * v2_2;
  const T l2_3 = T(1.2) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_30 = T(0.12) * omega2_1 + T(0.006) * omega2_2 + T(0.0036) * omega2_3;
  const T t2_31 = T(0.006) * omega2_1 + T(0.144) * omega2_2 - T(0.0048) * omega2_3;
  const T t2_32 = T(0.0036) * omega2_1 - T(0.0048) * omega2_2 + T(0.096) * omega2_3;
  const T H2_1 = R2_11 * t2_30 + R2_21 * t2_31 + R1_31 * t2_32 + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = R2_12 * t2_30 + R2_22 * t2_31 + R1_32 * t2_32 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = R2_13 * t2_30 + R2_23 * t2_31 + R1_33 * t2_32 + p2_1 * l2_2 - p2_2 * l2_1;

  // ---- body 3 (body_3) on body 2
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_21 = R2_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R2_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R2_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_31 * E3_22 - R2_21 * E3_23;
  const T R3_32 = R1_32 * E3_22 - R2_22 * E3_23;
  const T R3_33 = R1_33 * E3_22 - R2_23 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega2_1;
  const T omega3_2 = E3_22 * omega2_2 + E3_23 * omega2_3;
  const T omega3_3 = E3_22 * omega2_3 - E3_23 * omega2_2;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T t3_1 = t2_1 + R2_11 * T(0.3);
  const T P3_1 = t3_1 + P2_1 + R2_21 * T(0.15);
  const T t3_2 = t2_3 + R2_12 * T(0.3);
  const T P3_2 = t3_2 + P2_2 + R2_22 * T(0.15);
  const T t3_3 = t2_5 + R2_13 * T(0.3);
  const T P3_3 = t3_3 + P2_3 + R2_23 * T(0.15);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = t2_7 + P3_1 + R3_21 * T(0.2) + R3_31 * T(0.05);
  const T p3_2 = t2_10 + P3_2 + R3_22 * T(0.2) + R3_32 * T(0.05);
  const T p3_3 = t2_13 + P3_3 + R3_23 * T(0.2) + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_4 = t2_28 - omega2_3 * T(0.15);
  const T t3_5 = omega2_3 * T(0.3) - omega2_1 * T(0.1);
  const T t3_6 = Pdot2_1 + R2_21 * t3_5;
  const T t3_7 = omega2_2 * T(0.3);
  const T t3_8 = omega2_1 * T(0.15) - t3_7;
  const T Pdot3_1 = R2_11 * t3_4 + t3_6 + R1_31 * t3_8;
  const T t3_9 = Pdot2_2 + R2_22 * t3_5;
  const T Pdot3_2 = R2_12 * t3_4 + t3_9 + R1_32 * t3_8;
  const T t3_10 = Pdot2_3 + R2_23 * t3_5;
  const T Pdot3_3 = R2_13 * t3_4 + t3_10 + R1_33 * t3_8;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_11 = omega3_2 * T(0.05) - omega3_3 * T(0.2);
  const T t3_12 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_13 = omega3_1 * T(0.2) - omega3_2 * T(0.1);
  const T v3_1 = Pdot3_1 + R2_11 * t3_11 + R3_21 * t3_12 + R3_31 * t3_13;
  const T v3_2 = Pdot3_2 + R2_12 * t3_11 + R3_22 * t3_12 + R3_32 * t3_13;
  const T v3_3 = Pdot3_3 + R2_13 * t3_11 + R3_23 * t3_12 + R3_33 * t3_13;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(1.3) * v3_1;
  const T l3_2 = T(1.3) * v3_2;
  const T l3_3 = T(1.3) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_14 = T(0.13) * omega3_1 + T(0.0065) * omega3_2 + T(0.0039) * omega3_3;
  const T t3_15 = T(0.0065) * omega3_1 + T(0.156) * omega3_2 - T(0.0052) * omega3_3;
  const T t3_16 = T(0.0039) * omega3_1 - T(0.0052) * omega3_2 + T(0.104) * omega3_3;
  const T H3_1 = R2_11 * t3_14 + R3_21 * t3_15 + R3_31 * t3_16 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = R2_12 * t3_14 + R3_22 * t3_15 + R3_32 * t3_16 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R2_13 * t3_14 + R3_23 * t3_15 + R3_33 * t3_16 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (body_4) on body 2
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R2^T E4^T: R takes inertial components to body components
  const T R4_11 = R2_11 * E4_11 - R1_31 * minus_E4_13;
  const T R4_12 = R2_12 * E4_11 - R1_32 * minus_E4_13;
  const T R4_13 = R2_13 * E4_11 - R1_33 * minus_E4_13;
  const T R4_31 = R2_11 * minus_E4_13 + R1_31 * E4_11;
  const T R4_32 = R2_12 * minus_E4_13 + R1_32 * E4_11;
  const T R4_33 = R2_13 * minus_E4_13 + R1_33 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega2: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega2_1 - minus_E4_13 * omega2_3;
  const T omega4_2 = thetadot4 + omega2_2;
  const T omega4_3 = minus_E4_13 * omega2_1 + E4_11 * omega2_3;
  // P4 = R2^T q4 + P2: position of the body origin, inertial axes [m]
  const T P4_1 = t3_1 + t2_9;
  const T P4_2 = t3_2 + t2_12;
  const T P4_3 = t3_3 + t2_15;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = t2_8 + P4_1 + R4_11 * T(0.1) + R4_31 * T(0.05);
  const T p4_2 = t2_11 + P4_2 + R4_12 * T(0.1) + R4_32 * T(0.05);
  const T p4_3 = t2_14 + P4_3 + R4_13 * T(0.1) + R4_33 * T(0.05);
  // Pdot4 = R2^T omega2~ q4 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t4_1 = t2_28 - t2_24;
  const T t4_2 = t2_27 - t3_7;
  const T Pdot4_1 = R2_11 * t4_1 + t3_6 + R1_31 * t4_2;
  const T Pdot4_2 = R2_12 * t4_1 + t3_9 + R1_32 * t4_2;
  const T Pdot4_3 = R2_13 * t4_1 + t3_10 + R1_33 * t4_2;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_3 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_4 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_5 = omega4_1 * T(0.2) - omega4_2 * T(0.1);
  const T v4_1 = Pdot4_1 + R4_11 * t4_3 + R2_21 * t4_4 + R4_31 * t4_5;
  const T v4_2 = Pdot4_2 + R4_12 * t4_3 + R2_22 * t4_4 + R4_32 * t4_5;
  const T v4_3 = Pdot4_3 + R4_13 * t4_3 + R2_23 * t4_4 + R4_33 * t4_5;
  // l4 = m4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(1.4) * v4_1;
  const T l4_2 = T(1.4) * v4_2;
  const T l4_3 = T(1.4) * v4_3;
  // H4 = R4^T I4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_6 = T(0.14) * omega4_1 + T(0.007) * omega4_2 + T(0.0042) * omega4_3;
  const T t4_7 = T(0.007) * omega4_1 + T(0.168) * omega4_2 - T(0.0056) * omega4_3;
  const T t4_8 = T(0.0042) * omega4_1 - T(0.0056) * omega4_2 + T(0.112) * omega4_3;
  const T H4_1 = R4_11 * t4_6 + R2_21 * t4_7 + R4_31 * t4_8 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_6 + R2_22 * t4_7 + R4_32 * t4_8 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R4_13 * t4_6 + R2_23 * t4_7 + R4_33 * t4_8 + p4_1 * l4_2 - p4_2 * l4_1;

  // ---- body 5 (body_5) on body 1
  const T thetadot5 = y[6];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[7];
  const T E5_12 = sines[7];
  // R5^T = R1^T E5^T: R takes inertial components to body components
  const T R5_11 = R1_11 * E5_11 + R1_21 * E5_12;
  const T R5_12 = R1_12 * E5_11 + R1_22 * E5_12;
  const T R5_13 = R1_13 * E5_11 + R1_23 * E5_12;
  const T R5_21 = R1_21 * E5_11 - R1_11 * E5_12;
  const T R5_22 = R1_22 * E5_11 - R1_12 * E5_12;
  const T R5_23 = R1_23 * E5_11 - R1_13 * E5_12;
  // omega5 = thetadot5 b5 + E5 omega1: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega1_1 + E5_12 * omega1_2;
  const T omega5_2 = E5_11 * omega1_2 - E5_12 * omega1_1;
  const T omega5_3 = thetadot5 + omega1_3;
  // P5 = s1 + R1^T q5: position of the body origin, inertial axes [m]
  const T P5_1 = t2_2 + R1_21 * T(0.25);
  const T P5_2 = t2_4 + R1_22 * T(0.25);
  const T P5_3 = t2_6 + R1_23 * T(0.25);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T t5_1 = R5_11 * T(0.1);
  const T p5_1 = t5_1 + t1_13 + P5_1 + R5_21 * T(0.2);
  const T t5_2 = R5_12 * T(0.1);
  const T p5_2 = t5_2 + t1_14 + P5_2 + R5_22 * T(0.2);
  const T t5_3 = R5_13 * T(0.1);
  const T p5_3 = t5_3 + t1_15 + P5_3 + R5_23 * T(0.2);
  // Pdot5 = sdot1 + R1^T omega1~ q5: velocity of the body origin, inertial axes [m/s]
  const T t5_4 = t1_19 - omega1_3 * T(0.25);
  const T t5_5 = omega1_1 * T(0.25) - t2_20;
  const T Pdot5_1 = t2_18 + R1_11 * t5_4 + R1_31 * t5_5;
  const T Pdot5_2 = t2_22 + R1_12 * t5_4 + R1_32 * t5_5;
  const T Pdot5_3 = t2_23 + R1_13 * t5_4 + R1_33 * t5_5;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_6 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_7 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_8 = omega5_2 * T(0.1);
  const T t5_9 = omega5_1 * T(0.2) - t5_8;
  const T v5_1 = Pdot5_1 + R5_11 * t5_6 + R5_21 * t5_7 + R1_31 * t5_9;
  const T v5_2 = Pdot5_2 + R5_12 * t5_6 + R5_22 * t5_7 + R1_32 * t5_9;
  const T v5_3 = Pdot5_3 + R5_13 * t5_6 + R5_23 * t5_7 + R1_33 * t5_9;
  // l5 = m5 v5: linear momentum, inertial axes [kg m/s]
  const T l5_1 = T(1.5) * v5_1;
  const T l5_2 = T(1.5) * v5_2;
  const T l5_3 = T(1.5) * v5_3;
  // H5 = R5^T I5 omega5 + p5~ l5: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t5_10 = T(0.15) * omega5_1 + T(0.0075) * omega5_2 + T(0.0045) * omega5_3;
  const T t5_11 = T(0.0075) * omega5_1 + T(0.18) * omega5_2 - T(0.006) * omega5_3;
  const T t5_12 = T(0.0045) * omega5_1 - T(0.006) * omega5_2 + T(0.12) * omega5_3;
  const T H5_1 = R5_11 * t5_10 + R5_21 * t5_11 + R1_31 * t5_12 + p5_2 * l5_3 - p5_3 * l5_2;
  const T H5_2 = R5_12 * t5_10 + R5_22 * t5_11 + R1_32 * t5_12 + p5_3 * l5_1 - p5_1 * l5_3;
  const T H5_3 = R5_13 * t5_10 + R5_23 * t5_11 + R1_33 * t5_12 + p5_1 * l5_2 - p5_2 * l5_1;

  // ---- body 6 (body_6) on body 5
  const T thetadot6 = y[7];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[8];
  const T E6_23 = sines[8];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_21 = R5_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R5_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R5_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R5_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R5_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R5_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega5_1;
  const T omega6_2 = E6_22 * omega5_2 + E6_23 * omega5_3;
  const T omega6_3 = E6_22 * omega5_3 - E6_23 * omega5_2;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T P6_1 = t2_1 + P5_1 + R5_11 * T(0.3) + R5_21 * T(0.3);
  const T P6_2 = t2_3 + P5_2 + R5_12 * T(0.3) + R5_22 * T(0.3);
  const T P6_3 = t2_5 + P5_3 + R5_13 * T(0.3) + R5_23 * T(0.3);
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = t5_1 + P6_1 + R6_21 * T(0.2) + R6_31 * T(0.05);
  const T p6_2 = t5_2 + P6_2 + R6_22 * T(0.2) + R6_32 * T(0.05);
  const T p6_3 = t5_3 + P6_3 + R6_23 * T(0.2) + R6_33 * T(0.05);
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_1 = omega5_3 * T(0.3);
  const T t6_2 = t5_8 - t6_1;
  const T t6_3 = t6_1 - omega5_1 * T(0.1);
  const T t6_4 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_2 + R5_21 * t6_3 + R1_31 * t6_4;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_2 + R5_22 * t6_3 + R1_32 * t6_4;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_2 + R5_23 * t6_3 + R1_33 * t6_4;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_5 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_6 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_7 = omega6_1 * T(0.2) - omega6_2 * T(0.1);
  const T v6_1 = Pdot6_1 + R5_11 * t6_5 + R6_21 * t6_6 + R6_31 * t6_7;
  const T v6_2 = Pdot6_2 + R5_12 * t6_5 + R6_22 * t6_6 + R6_32 * t6_7;
  const T v6_3 = Pdot6_3 + R5_13 * t6_5 + R6_23 * t6_6 + R6_33 * t6_7;
  // l6 = m6 v6: linear momentum, inertial axes [kg m/s]
  const T l6_1 = T(1.6) * v6_1;
  const T l6_2 = T(1.6) * v6_2;
  const T l6_3 = T(1.6) * v6_3;
  // H6 = R6^T I6 omega6 + p6~ l6: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t6_8 = T(0.16) * omega6_1 + T(0.008) * omega6_2 + T(0.0048) * omega6_3;
  const T t6_9 = T(0.008) * omega6_1 + T(0.192) * omega6_2 - T(0.0064) * omega6_3;
  const T t6_10 = T(0.0048) * omega6_1 - T(0.0064) * omega6_2 + T(0.128) * omega6_3;
  const T H6_1 = R5_11 * t6_8 + R6_21 * t6_9 + R6_31 * t6_10 + p6_2 * l6_3 - p6_3 * l6_2;
  const T H6_2 = R5_12 * t6_8 + R6_22 * t6_9 + R6_32 * t6_10 + p6_3 * l6_1 - p6_1 * l6_3;
  const T H6_3 = R5_13 * t6_8 + R6_23 * t6_9 + R6_33 * t6_10 + p6_1 * l6_2 - p6_2 * l6_1;

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
// 33 add, 38 multiply
template <class T>
void power([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* out) noexcept {

  // ---- body 1 (body_1) on the inertial frame
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

  // ---- whole system
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T thetadot2 = y[3];
  const T thetadot3 = y[4];
  const T thetadot4 = y[5];
  const T thetadot5 = y[6];
  const T thetadot6 = y[7];
  const T sdot1_1 = y[8], sdot1_2 = y[9], sdot1_3 = y[10];
  // power = thetadot2 tau_body_2_ + thetadot3 tau_body_3_ + thetadot4 tau_body_4_ + thetadot5 tau_body_5_ + thetadot6
  //   tau_body_6_ + F1 . (sdot1 + R1^T omega1~ r1) + M1 . omega1: power of the applied loads [W]
  const T b0_1 = omega1_2 * T(0.05) - omega1_3 * T(0.2);
  const T b0_2 = omega1_3 * T(0.1) - omega1_1 * T(0.05);
  const T b0_3 = omega1_1 * T(0.2) - omega1_2 * T(0.1);
  const T power = thetadot2 * u.tau_2 + thetadot3 * u.tau_3 + thetadot4 * u.tau_4 + thetadot5 * u.tau_5 + thetadot6 *
      u.tau_6 + u.F_1_1 * (sdot1_1 + R1_11 * b0_1 + R1_21 * b0_2 + R1_31 * b0_3) + u.F_1_2 * (sdot1_2 + R1_12 * b0_1 +
      R1_22 * b0_2 + R1_32 * b0_3) + u.F_1_3 * (sdot1_3 + R1_13 * b0_1 + R1_23 * b0_2 + R1_33 * b0_3) + u.M_1_1 *
      omega1_1 + u.M_1_2 * omega1_2 + u.M_1_3 * omega1_3;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 685 add, 746 multiply, 8 divide, 10 sine or cosine
// by: articulated; composite would take 692 add, 782 multiply, 8 divide, 10 sine or cosine
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot)
    noexcept {
  T cosines[9], sines[9];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 5, cosines + 4, sines + 4);

  // ---- body 1 (body_1) on the inertial frame
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
  // G1 = R1 F1 - U1 h_all_1: applied less inertia force, body axes [N]
  const T t1_16 = R1_11 * u.F_1_1 + R1_12 * u.F_1_2 + R1_13 * u.F_1_3;
  const T G1_1 = t1_16 + minus_U1_11 * T(2.21) - U1_12 * T(1.385) - U1_13 * T(1.32);
  const T t1_17 = R1_21 * u.F_1_1 + R1_22 * u.F_1_2 + R1_23 * u.F_1_3;
  const T G1_2 = t1_17 + minus_U1_22 * T(1.385) - U1_12 * T(2.21) - U1_23 * T(1.32);
  const T t1_18 = R1_31 * u.F_1_1 + R1_32 * u.F_1_2 + R1_33 * u.F_1_3;
  const T G1_3 = t1_18 - U1_13 * T(2.21) - U1_23 * T(1.385) + minus_U1_33 * T(1.32);
  // N1 = r1~ R1 F1 - omega1~ J_all_1 omega1 + M1: applied less inertia moment about the body origin, body axes [N m]
  const T N1_1 = u.M_1_1 + T(0.2) * t1_18 - T(0.05) * t1_17 + T(0.91576) * U1_23 + T(0.22365000000000002) * (t1_14 -
      t1_13) + T(0.3817) * U1_12 - T(0.366) * U1_13;
  const T N1_2 = u.M_1_2 + T(0.05) * t1_16 - T(0.1) * t1_18 - T(0.52951) * U1_13 + T(0.3817) * (t1_13 - t1_15) +
      T(0.366) * U1_23 - T(0.22365000000000002) * U1_12;
  const T N1_3 = u.M_1_3 + T(0.1) * t1_17 - T(0.2) * t1_16 - T(0.3862499999999999) * U1_12 + T(0.366) * (t1_15 -
      t1_14) + T(0.22365000000000002) * U1_13 - T(0.3817) * U1_23;

  // ---- body 2 (body_2) on body 1
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[4];
  const T E2_12 = sines[4];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = E2_11 * omega1_1 + E2_12 * omega1_2;
  const T omega2_2 = E2_11 * omega1_2 - E2_12 * omega1_1;
  const T omega2_3 = thetadot2 + omega1_3;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_1 = thetadot2 * omega2_2;
  const T minus_omegadot2_2 = thetadot2 * omega2_1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_3 * omega2_3;
  const T t2_2 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_1 + t2_2;
  const T U2_12 = omega2_2 * omega2_1;
  const T t2_3 = omega2_3 * omega2_1;
  const T U2_13 = t2_3 - minus_omegadot2_2;
  const T t2_4 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_1 + t2_4;
  const T t2_5 = omega2_3 * omega2_2;
  const T U2_23 = t2_5 - omegadot2_1;
  const T U2_31 = t2_3 + minus_omegadot2_2;
  const T U2_32 = t2_5 + omegadot2_1;
  const T minus_U2_33 = t2_2 + t2_4;
  // Pddot2 = E2 U1 q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_6 = minus_U1_11 * T(0.3);
  const T t2_7 = U1_12 * T(0.1) - t2_6;
  const T t2_8 = U1_12 * T(0.3);
  const T t2_9 = t2_8 - minus_U1_22 * T(0.1);
  const T Pddot2_1 = E2_11 * t2_7 + E2_12 * t2_9;
  const T Pddot2_2 = E2_11 * t2_9 - E2_12 * t2_7;
  const T t2_10 = U1_13 * T(0.3);
  const T Pddot2_3 = t2_10 + U1_23 * T(0.1);
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_12 * T(0.9949999999999999) - minus_U2_11 * T(1.06);
  const T minus_G2_2 = U2_12 * T(1.06) - minus_U2_22 * T(0.9949999999999999);
  const T minus_G2_3 = U2_31 * T(1.06) + U2_32 * T(0.9949999999999999);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(0.9949999999999999) * Pddot2_3 + T(0.47501) * U2_32 + T(0.47501) * U2_23 + T(0.1918) *
      (minus_U2_22 - minus_U2_33) + T(0.26399999999999996) * U2_31 - T(0.20240000000000002) * U2_12;
  const T minus_N2_2 = T(0.20240000000000002) * (minus_U2_33 - minus_U2_11) - (T(0.47501) * U2_13 +
      T(0.5564941176470588) * U2_31) + T(0.1918) * U2_12 - T(0.26399999999999996) * U2_32 - T(1.06) * Pddot2_3;
  const T minus_N2_3 = T(1.06) * Pddot2_2 - T(0.9949999999999999) * Pddot2_1 + T(0.08148411764705887) * U2_12 +
      T(0.26399999999999996) * (minus_U2_11 - minus_U2_22) + T(0.20240000000000002) * U2_23 - T(0.1918) * U2_13;

  // ---- body 3 (body_3) on body 2
  const T thetadot3 = y[4];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[5];
  const T t3_2 = sines[5];
  const T E3_22 = T(0.9701425001453319) * t3_1 - T(0.24253562503633297) * t3_2;
  const T E3_23 = T(0.24253562503633297) * t3_1 + T(0.9701425001453319) * t3_2;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega2_1;
  const T omega3_2 = E3_22 * omega2_2 + E3_23 * omega2_3;
  const T omega3_3 = E3_22 * omega2_3 - E3_23 * omega2_2;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_2 = thetadot3 * omega3_3 - E3_22 * minus_omegadot2_2;
  const T omegadot3_3 = E3_23 * minus_omegadot2_2 - thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_3 = omega3_3 * omega3_3;
  const T t3_4 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_3 + t3_4;
  const T t3_5 = omega3_2 * omega3_1;
  const T U3_12 = t3_5 - omegadot3_3;
  const T t3_6 = omega3_3 * omega3_1;
  const T U3_13 = t3_6 + omegadot3_2;
  const T U3_21 = t3_5 + omegadot3_3;
  const T t3_7 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_3 + t3_7;
  const T t3_8 = omega3_3 * omega3_2;
  const T U3_23 = t3_8 - omegadot2_1;
  const T U3_31 = t3_6 - omegadot3_2;
  const T U3_32 = t3_8 + omegadot2_1;
  const T minus_U3_33 = t3_4 + t3_7;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_9 = Pddot2_1 + U2_13 * T(0.2);
  const T Pddot3_1 = t3_9 + U2_12 * T(0.15);
  const T t3_10 = minus_U2_33 * T(0.2) - Pddot2_3;
  const T t3_11 = Pddot2_2 + U2_23 * T(0.2);
  const T Pddot3_3 = E3_22 * (U2_32 * T(0.15) - t3_10) - E3_23 * (t3_11 - minus_U2_22 * T(0.15));
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = U3_12 * T(0.26800186566514794);
  const T G3_2 = minus_U3_22 * T(0.26800186566514794);
  const T minus_G3_3 = U3_32 * T(0.26800186566514794);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(0.26800186566514794) * Pddot3_3 + T(0.09975588235294118) * U3_32 - T(0.08549411764705883) *
      U3_23 + T(0.016823529411764706) * (minus_U3_22 - minus_U3_33) + T(0.09994893107747284) * U3_31 +
      T(0.00220707418783063) * U3_21;
  const T minus_N3_2 = T(0.08549411764705883) * U3_13 + T(0.08549411764705883) * U3_31 - T(0.00220707418783063) *
      (minus_U3_33 - minus_U3_11) + T(0.016823529411764706) * U3_12 - T(0.09994893107747284) * U3_32;
  const T minus_N3_3 = T(0.09994893107747284) * (minus_U3_11 - minus_U3_22) - (T(0.08549411764705883) * U3_21 +
      T(0.09975588235294118) * U3_12) - T(0.00220707418783063) * U3_23 - T(0.016823529411764706) * U3_13 -
      T(0.26800186566514794) * Pddot3_1;

  // ---- body 4 (body_4) on body 2
  const T thetadot4 = y[5];
  // E4^T = Z4^T Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T t4_2 = sines[6];
  const T E4_11 = T(0.44721359549995804) * t4_1 - T(0.8944271909999159) * t4_2;
  const T minus_E4_13 = T(0.8944271909999159) * t4_1 + T(0.44721359549995804) * t4_2;
  // omega4 = thetadot4 b4 + E4 omega2: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega2_1 - minus_E4_13 * omega2_3;
  const T omega4_2 = thetadot4 + omega2_2;
  const T omega4_3 = minus_E4_13 * omega2_1 + E4_11 * omega2_3;
  // omegadot4 = -thetadot4 b4~ E4 omega2 + E4 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = E4_11 * omegadot2_1 - thetadot4 * omega4_3;
  const T omegadot4_3 = thetadot4 * omega4_1 + minus_E4_13 * omegadot2_1;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_3 = omega4_3 * omega4_3;
  const T t4_4 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_3 + t4_4;
  const T t4_5 = omega4_2 * omega4_1;
  const T U4_12 = t4_5 - omegadot4_3;
  const T t4_6 = omega4_3 * omega4_1;
  const T U4_13 = t4_6 - minus_omegadot2_2;
  const T U4_21 = t4_5 + omegadot4_3;
  const T t4_7 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_3 + t4_7;
  const T t4_8 = omega4_3 * omega4_2;
  const T U4_23 = t4_8 - omegadot4_1;
  const T U4_31 = t4_6 + minus_omegadot2_2;
  const T U4_32 = t4_8 + omegadot4_1;
  const T minus_U4_33 = t4_4 + t4_7;
  // Pddot4 = E4 (U2 q4 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot4_1 = E4_11 * (t3_9 - minus_U2_11 * T(0.3)) - minus_E4_13 * (U2_31 * T(0.3) - t3_10);
  const T Pddot4_2 = t3_11 + U2_12 * T(0.3);
  // G4 = -U4 h_own_4: applied less inertia force, body axes [N]
  const T minus_G4_1 = U4_13 * T(0.15652475842498526);
  const T minus_G4_2 = U4_23 * T(0.15652475842498526);
  const T G4_3 = minus_U4_33 * T(0.15652475842498526);
  // N4 = -h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N4_1 = T(0.05885330916779445) * (minus_U4_22 - minus_U4_33) - (T(0.09576000000000001) * U4_32 +
      T(0.08974) * U4_23) - T(0.008139287438099234) * U4_31 + T(0.008680000000000007) * U4_21 - T(0.15652475842498526)
      * Pddot4_2;
  const T minus_N4_2 = T(0.15652475842498526) * Pddot4_1 + T(0.08974) * U4_13 - T(0.09576000000000001) * U4_31 -
      T(0.008680000000000007) * (minus_U4_33 - minus_U4_11) + T(0.05885330916779445) * U4_12 + T(0.008139287438099234)
      * U4_32;
  const T minus_N4_3 = T(0.09576000000000001) * U4_21 + T(0.09576000000000001) * U4_12 - T(0.008139287438099234) *
      (minus_U4_11 - minus_U4_22) - T(0.008680000000000007) * U4_23 - T(0.05885330916779445) * U4_13;

  // ---- body 5 (body_5) on body 1
  const T thetadot5 = y[6];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[7];
  const T E5_12 = sines[7];
  // omega5 = thetadot5 b5 + E5 omega1: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega1_1 + E5_12 * omega1_2;
  const T omega5_2 = E5_11 * omega1_2 - E5_12 * omega1_1;
  const T omega5_3 = thetadot5 + omega1_3;
  // omegadot5 = -thetadot5 b5~ E5 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = thetadot5 * omega5_2;
  const T minus_omegadot5_2 = thetadot5 * omega5_1;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_1 = omega5_3 * omega5_3;
  const T t5_2 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_1 + t5_2;
  const T U5_12 = omega5_2 * omega5_1;
  const T t5_3 = omega5_3 * omega5_1;
  const T U5_13 = t5_3 - minus_omegadot5_2;
  const T t5_4 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_1 + t5_4;
  const T t5_5 = omega5_3 * omega5_2;
  const T U5_23 = t5_5 - omegadot5_1;
  const T U5_31 = t5_3 + minus_omegadot5_2;
  const T U5_32 = t5_5 + omegadot5_1;
  const T minus_U5_33 = t5_2 + t5_4;
  // Pddot5 = E5 U1 q5: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_6 = U1_12 * T(0.25) - t2_6;
  const T t5_7 = t2_8 - minus_U1_22 * T(0.25);
  const T Pddot5_1 = E5_11 * t5_6 + E5_12 * t5_7;
  const T Pddot5_2 = E5_11 * t5_7 - E5_12 * t5_6;
  const T Pddot5_3 = t2_10 + U1_23 * T(0.25);
  // G5 = -U5 h_own_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = U5_12 * T(0.78) - minus_U5_11 * T(0.7900000000000001);
  const T minus_G5_2 = U5_12 * T(0.7900000000000001) - minus_U5_22 * T(0.78);
  const T minus_G5_3 = U5_31 * T(0.7900000000000001) + U5_32 * T(0.78);
  // N5 = -h_own_5~ Pddot5 - axial(U5 (tr(J_own_5)/2 - J_own_5)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N5_1 = T(0.78) * Pddot5_3 + T(0.249) * U5_32 + T(0.249) * U5_23 + T(0.14700000000000002) *
      (minus_U5_22 - minus_U5_33) + T(0.21450000000000005) * U5_31 - T(0.14600000000000005) * U5_12;
  const T minus_N5_2 = T(0.14600000000000005) * (minus_U5_33 - minus_U5_11) - (T(0.249) * U5_13 +
      T(0.5312235294117649) * U5_31) + T(0.14700000000000002) * U5_12 - T(0.21450000000000005) * U5_32 -
      T(0.7900000000000001) * Pddot5_3;
  const T minus_N5_3 = T(0.7900000000000001) * Pddot5_2 - T(0.78) * Pddot5_1 + T(0.2822235294117648) * U5_12 +
      T(0.21450000000000005) * (minus_U5_11 - minus_U5_22) + T(0.14600000000000005) * U5_23 - T(0.14700000000000002) *
      U5_13;

  // ---- body 6 (body_6) on body 5
  const T thetadot6 = y[7];
  // E6^T = Z6^T Rot(b6, theta6): E takes components in the lower body to those in the body
  const T t6_1 = cosines[8];
  const T t6_2 = sines[8];
  const T E6_22 = T(0.9701425001453319) * t6_1 - T(0.24253562503633297) * t6_2;
  const T E6_23 = T(0.24253562503633297) * t6_1 + T(0.9701425001453319) * t6_2;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega5_1;
  const T omega6_2 = E6_22 * omega5_2 + E6_23 * omega5_3;
  const T omega6_3 = E6_22 * omega5_3 - E6_23 * omega5_2;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_2 = thetadot6 * omega6_3 - E6_22 * minus_omegadot5_2;
  const T omegadot6_3 = E6_23 * minus_omegadot5_2 - thetadot6 * omega6_2;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_3 = omega6_3 * omega6_3;
  const T t6_4 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_3 + t6_4;
  const T t6_5 = omega6_2 * omega6_1;
  const T U6_12 = t6_5 - omegadot6_3;
  const T t6_6 = omega6_3 * omega6_1;
  const T U6_13 = t6_6 + omegadot6_2;
  const T U6_21 = t6_5 + omegadot6_3;
  const T t6_7 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_3 + t6_7;
  const T t6_8 = omega6_3 * omega6_2;
  const T U6_23 = t6_8 - omegadot5_1;
  const T U6_31 = t6_6 - omegadot6_2;
  const T U6_32 = t6_8 + omegadot5_1;
  const T minus_U6_33 = t6_4 + t6_7;
  // Pddot6 = E6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = Pddot5_1 + U5_12 * T(0.3) + U5_13 * T(0.2);
  const T Pddot6_3 = E6_22 * (Pddot5_3 + U5_32 * T(0.3) - minus_U5_33 * T(0.2)) - E6_23 * (Pddot5_2 + U5_23 * T(0.2) -
      minus_U5_22 * T(0.3));
  // G6 = -U6 h_own_6: applied less inertia force, body axes [N]
  const T minus_G6_1 = U6_12 * T(0.32984845004941293);
  const T G6_2 = minus_U6_22 * T(0.32984845004941293);
  const T minus_G6_3 = U6_32 * T(0.32984845004941293);
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(0.32984845004941293) * Pddot6_3 + T(0.12277647058823532) * U6_32 - T(0.1052235294117647) *
      U6_23 + T(0.020705882352941175) * (minus_U6_22 - minus_U6_33) + T(0.12301406901842814) * U6_31 +
      T(0.002716399000406929) * U6_21;
  const T minus_N6_2 = T(0.1052235294117647) * U6_13 + T(0.1052235294117647) * U6_31 - T(0.002716399000406929) *
      (minus_U6_33 - minus_U6_11) + T(0.020705882352941175) * U6_12 - T(0.12301406901842814) * U6_32;
  const T minus_N6_3 = T(0.12301406901842814) * (minus_U6_11 - minus_U6_22) - (T(0.1052235294117647) * U6_21 +
      T(0.12277647058823532) * U6_12) - T(0.002716399000406929) * U6_23 - T(0.020705882352941175) * U6_13 -
      T(0.32984845004941293) * Pddot6_1;

  // ---- body 6 (body_6) and what it carries
  // u_6 = b6 . N6 + tau_body_6_: drives it [N m], [N]
  const T u_6 = u.tau_6 - minus_N6_1;
  // v6 = invD6 u_6: u/D
  const T v6 = T(4.385964912280701) * u_6;
  // gt6 = G6 - v6 B6: force with the turn solved [N]
  const T minus_gt6_3 = v6 * T(0.32984845004941293) + minus_G6_3;
  // nt6 = -tau_body_6_ b6 + P_b6 (N6 - v6 K6): moment with the turn solved [N m]
  const T nt6_2 = v6 * T(0.12301406901842814) - minus_N6_2;
  const T minus_nt6_3 = minus_N6_3 + v6 * T(0.002716399000406929);
  // Mp6 = E6^T M6 E6: M passed on, lower body's axes [kg]
  const T b6_1 = E6_23 * T(0.4771929824561405);
  const T minus_Mp6_22 = E6_23 * b6_1;
  const T Mp6_23 = E6_22 * b6_1;
  const T Mp6_33 = minus_Mp6_22 - T(0.4771929824561405);
  // gp6 = E6^T gt6: force passed on, lower body's axes [N]
  const T gp6_2 = E6_22 * G6_2 + E6_23 * minus_gt6_3;
  const T gp6_3 = E6_23 * G6_2 - E6_22 * minus_gt6_3;
  // Hp6 = E6^T H6 E6: H passed on, lower body's axes [kg m]
  const T Hp6_21 = E6_23 * T(0.32984845004941293);
  const T b6_2 = E6_23 * T(0.003929824561403508) + E6_22 * T(0.17796491228070185);
  const T minus_Hp6_22 = E6_23 * b6_2;
  const T Hp6_23 = E6_22 * b6_2;
  const T minus_Hp6_31 = E6_22 * T(0.32984845004941293);
  const T Hp6_32 = Hp6_23 - T(0.17796491228070185);
  const T Hp6_33 = minus_Hp6_22 - T(0.003929824561403508);
  // Jp6 = E6^T J6 E6: J passed on, lower body's axes [kg m^2]
  const T b6_3 = E6_23 * T(0.0838910216718267) + T(2) * E6_22 * T(0.01924028895768834);
  const T b6_4 = E6_23 * b6_3;
  const T Jp6_22 = b6_4 - T(0.06637044375645);
  const T Jp6_23 = T(0.01924028895768834) - E6_22 * b6_3;
  const T Jp6_33 = T(0.017520577915376704) - b6_4;
  // np6 = E6^T nt6: moment passed on, lower body's axes [N m]
  const T np6_2 = E6_22 * nt6_2 + E6_23 * minus_nt6_3;
  const T np6_3 = E6_23 * nt6_2 - E6_22 * minus_nt6_3;
  // Hb6 = q6~ Mp6 + Hp6: H of the joint at the lower body's origin, its axes
  const T Hb6_12 = T(0.2) * minus_Mp6_22 + T(0.3) * Mp6_23;
  const T Hb6_13 = T(0.3) * Mp6_33 - T(0.2) * Mp6_23;

  // ---- body 5 (body_5) and what it carries
  // HA5 = h_own_5~ + Hb6: moment for an acceleration of the origin, body axes [kg m]
  const T HA5_13 = T(0.78) + Hb6_13;
  const T HA5_23 = Hp6_23 - T(0.7900000000000001);
  const T minus_HA5_31 = minus_Hp6_31 + T(0.78);
  const T HA5_32 = T(0.7900000000000001) + Hp6_32;
  // JA5 = q6~ Hp6^T + J_own_5 + Jp6 - Hb6 q6~: moment for an angular acceleration, body axes [kg m^2]
  const T minus_JA5_11 = Hb6_12 * T(0.2) - Hb6_13 * T(0.3);
  const T JA5_12 = T(0.2) * minus_Hp6_22 - T(0.21450000000000005) + T(0.3) * Hp6_23;
  const T JA5_13 = T(0.3) * Hp6_33 - T(0.14600000000000005) - T(0.2) * Hp6_32;
  const T JA5_22 = T(0.2822235294117648) + Jp6_22 + T(0.4) * Hp6_21;
  const T JA5_23 = Jp6_23 - T(0.14700000000000002) - T(0.2) * minus_Hp6_31 - T(0.3) * Hp6_21;
  const T JA5_33 = T(0.7802235294117649) + Jp6_33 + T(0.6) * minus_Hp6_31;
  // g5 = G5 + gp6: force that drives it, home axes [N]
  const T minus_g5_1 = minus_G6_1 + minus_G5_1;
  const T g5_2 = gp6_2 - minus_G5_2;
  const T g5_3 = gp6_3 - minus_G5_3;
  // n5 = q6~ gp6 + N5 + np6: moment that drives it, body axes [N m]
  const T n5_1 = T(0.3) * gp6_3 - (minus_N5_1 + u.tau_6) - T(0.2) * gp6_2;
  const T n5_2 = np6_2 - minus_N5_2 - T(0.2) * minus_G6_1;
  const T n5_3 = np6_3 - minus_N5_3 + T(0.3) * minus_G6_1;
  // invD5 = D5^-1: 1/D
  const T invD5 = T(1) / JA5_33;
  // kB5 = invD5 B5: B/D
  const T minus_kB5_1 = invD5 * minus_HA5_31;
  const T kB5_2 = invD5 * HA5_32;
  const T kB5_3 = invD5 * Hp6_33;
  // kK5 = invD5 K5: K/D
  const T kK5_1 = invD5 * JA5_13;
  const T kK5_2 = invD5 * JA5_23;
  // u_5 = b5 . n5 + tau_body_5_: drives it [N m], [N]
  const T u_5 = n5_3 + u.tau_5;
  // v5 = invD5 u_5: u/D
  const T v5 = invD5 * u_5;
  // M5 = Mp6 - kB5 B5^T: MA less what the turn takes up [kg]
  const T minus_M5_11 = minus_kB5_1 * minus_HA5_31;
  const T M5_12 = minus_kB5_1 * HA5_32;
  const T M5_13 = minus_kB5_1 * Hp6_33;
  const T minus_M5_22 = minus_Mp6_22 + kB5_2 * HA5_32;
  const T M5_23 = Mp6_23 - kB5_2 * Hp6_33;
  const T M5_33 = Mp6_33 - kB5_3 * Hp6_33;
  // H5 = P_b5 (HA5 - kK5 B5^T): HA less what the turn takes up [kg m]
  const T H5_11 = kK5_1 * minus_HA5_31;
  const T H5_12 = Hb6_12 - kK5_1 * HA5_32;
  const T H5_13 = HA5_13 - kK5_1 * Hp6_33;
  const T H5_21 = Hp6_21 + kK5_2 * minus_HA5_31;
  const T minus_H5_22 = minus_Hp6_22 + kK5_2 * HA5_32;
  const T H5_23 = HA5_23 - kK5_2 * Hp6_33;
  // J5 = P_b5 (JA5 - kK5 K5^T) P_b5: JA less what the turn takes up [kg m^2]
  const T minus_J5_11 = minus_JA5_11 + kK5_1 * JA5_13;
  const T J5_12 = JA5_12 - kK5_1 * JA5_23;
  const T J5_22 = JA5_22 - kK5_2 * JA5_23;
  // gt5 = g5 - v5 B5: force with the turn solved [N]
  const T gt5_1 = v5 * minus_HA5_31 - minus_g5_1;
  const T gt5_2 = g5_2 - v5 * HA5_32;
  const T gt5_3 = g5_3 - v5 * Hp6_33;
  // nt5 = -tau_body_5_ b5 + P_b5 (n5 - v5 K5): moment with the turn solved [N m]
  const T nt5_1 = n5_1 - v5 * JA5_13;
  const T nt5_2 = n5_2 - v5 * JA5_23;
  // Mp5 = E5^T M5 E5: M passed on, lower body's axes [kg]
  const T b5_1 = T(2) * E5_11;
  const T b5_2 = E5_12 * (minus_M5_22 - minus_M5_11) + b5_1 * M5_12;
  const T b5_3 = E5_12 * b5_2;
  const T minus_Mp5_11 = minus_M5_11 + b5_3;
  const T Mp5_12 = E5_11 * b5_2 - M5_12;
  const T minus_Mp5_13 = E5_12 * M5_23 - E5_11 * M5_13;
  const T Mp5_22 = b5_3 - minus_M5_22;
  const T Mp5_23 = E5_11 * M5_23 + E5_12 * M5_13;
  // gp5 = E5^T gt5: force passed on, lower body's axes [N]
  const T gp5_1 = E5_11 * gt5_1 - E5_12 * gt5_2;
  const T gp5_2 = E5_12 * gt5_1 + E5_11 * gt5_2;
  // Hp5 = E5^T H5 E5: H passed on, lower body's axes [kg m]
  const T b5_4 = E5_12 * (H5_11 + minus_H5_22) + E5_11 * (H5_12 + H5_21);
  const T b5_5 = E5_12 * b5_4;
  const T Hp5_11 = H5_11 - b5_5;
  const T b5_6 = E5_11 * b5_4;
  const T Hp5_12 = b5_6 - H5_21;
  const T Hp5_13 = E5_11 * H5_13 - E5_12 * H5_23;
  const T Hp5_21 = b5_6 - H5_12;
  const T Hp5_22 = b5_5 - minus_H5_22;
  const T Hp5_23 = E5_12 * H5_13 + E5_11 * H5_23;
  // Jp5 = E5^T J5 E5: J passed on, lower body's axes [kg m^2]
  const T b5_7 = b5_1 * J5_12 - E5_12 * (minus_J5_11 + J5_22);
  const T b5_8 = E5_12 * b5_7;
  const T minus_Jp5_11 = minus_J5_11 + b5_8;
  const T Jp5_12 = E5_11 * b5_7 - J5_12;
  const T Jp5_22 = J5_22 + b5_8;
  // np5 = E5^T nt5: moment passed on, lower body's axes [N m]
  const T np5_1 = E5_11 * nt5_1 - E5_12 * nt5_2;
  const T np5_2 = E5_12 * nt5_1 + E5_11 * nt5_2;
  // Hb5 = q5~ Mp5 + Hp5: H of the joint at the lower body's origin, its axes
  const T b5_9 = T(0.25) * minus_Mp5_13;
  const T Hb5_11 = Hp5_11 - b5_9;
  const T Hb5_12 = Hp5_12 + T(0.25) * Mp5_23;
  const T Hb5_13 = Hp5_13 + T(0.25) * M5_33;
  const T Hb5_21 = Hp5_21 + T(0.3) * minus_Mp5_13;
  const T b5_10 = T(0.3) * Mp5_23;
  const T Hb5_22 = Hp5_22 - b5_10;
  const T Hb5_23 = Hp5_23 - T(0.3) * M5_33;
  const T Hb5_31 = T(0.25) * minus_Mp5_11 + T(0.3) * Mp5_12;
  const T Hb5_32 = T(0.3) * Mp5_22 - T(0.25) * Mp5_12;
  const T Hb5_33 = b5_9 + b5_10;

  // ---- body 4 (body_4) and what it carries
  // u_4 = b4 . N4 + tau_body_4_: drives it [N m], [N]
  const T u_4 = u.tau_4 - minus_N4_2;
  // v4 = invD4 u_4: u/D
  const T v4 = T(5.390835579514825) * u_4;
  // gt4 = G4 - v4 B4: force with the turn solved [N]
  const T minus_gt4_1 = v4 * T(0.15652475842498526) + minus_G4_1;
  // nt4 = -tau_body_4_ b4 + P_b4 (N4 - v4 K4): moment with the turn solved [N m]
  const T minus_nt4_1 = minus_N4_1 + v4 * T(0.008139287438099234);
  const T nt4_3 = v4 * T(0.05885330916779445) - minus_N4_3;
  // Mp4 = E4^T M4 E4: M passed on, lower body's axes [kg]
  const T b4_1 = minus_E4_13 * T(0.13207547169811318);
  const T b4_2 = minus_E4_13 * b4_1;
  const T Mp4_11 = b4_2 - T(0.13207547169811318);
  const T Mp4_13 = E4_11 * b4_1;
  // gp4 = E4^T gt4: force passed on, lower body's axes [N]
  const T gp4_1 = minus_E4_13 * G4_3 - E4_11 * minus_gt4_1;
  const T gp4_3 = minus_E4_13 * minus_gt4_1 + E4_11 * G4_3;
  // Hp4 = E4^T H4 E4: H passed on, lower body's axes [kg m]
  const T b4_3 = minus_E4_13 * T(0.006867924528301887) + E4_11 * T(0.04966037735849055);
  const T b4_4 = minus_E4_13 * b4_3;
  const T Hp4_11 = b4_4 - T(0.006867924528301887);
  const T minus_Hp4_12 = E4_11 * T(0.15652475842498526);
  const T b4_5 = E4_11 * b4_3;
  const T Hp4_13 = b4_5 - T(0.04966037735849055);
  const T Hp4_32 = minus_E4_13 * T(0.15652475842498526);
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_6 = T(2) * E4_11 * T(0.011262339622641516) - minus_E4_13 * T(0.01229516981132074);
  const T b4_7 = minus_E4_13 * b4_6;
  const T Jp4_11 = b4_7 - T(0.006377132075471705);
  const T Jp4_13 = E4_11 * b4_6 - T(0.011262339622641516);
  const T minus_Jp4_33 = T(0.018672301886792444) + b4_7;
  // np4 = E4^T nt4: moment passed on, lower body's axes [N m]
  const T np4_1 = minus_E4_13 * nt4_3 - E4_11 * minus_nt4_1;
  const T np4_3 = minus_E4_13 * minus_nt4_1 + E4_11 * nt4_3;
  // Hb4 = q4~ Mp4 + Hp4: H of the joint at the lower body's origin, its axes
  const T Hb4_21 = T(0.2) * Mp4_11 - T(0.3) * Mp4_13;
  const T Hb4_23 = T(0.2) * Mp4_13 + T(0.3) * b4_2;

  // ---- body 3 (body_3) and what it carries
  // u_3 = b3 . N3 + tau_body_3_: drives it [N m], [N]
  const T u_3 = u.tau_3 - minus_N3_1;
  // v3 = invD3 u_3: u/D
  const T v3 = T(5.398110661268555) * u_3;
  // gt3 = G3 - v3 B3: force with the turn solved [N]
  const T minus_gt3_3 = v3 * T(0.26800186566514794) + minus_G3_3;
  // nt3 = -tau_body_3_ b3 + P_b3 (N3 - v3 K3): moment with the turn solved [N m]
  const T nt3_2 = v3 * T(0.09994893107747284) - minus_N3_2;
  const T minus_nt3_3 = minus_N3_3 + v3 * T(0.00220707418783063);
  // Mp3 = E3^T M3 E3: M passed on, lower body's axes [kg]
  const T b3_1 = E3_23 * T(0.3877192982456141);
  const T minus_Mp3_22 = E3_23 * b3_1;
  const T Mp3_23 = E3_22 * b3_1;
  const T Mp3_33 = minus_Mp3_22 - T(0.3877192982456141);
  // gp3 = E3^T gt3: force passed on, lower body's axes [N]
  const T gp3_2 = E3_22 * G3_2 + E3_23 * minus_gt3_3;
  const T gp3_3 = E3_23 * G3_2 - E3_22 * minus_gt3_3;
  // Hp3 = E3^T H3 E3: H passed on, lower body's axes [kg m]
  const T Hp3_21 = E3_23 * T(0.26800186566514794);
  const T b3_2 = E3_23 * T(0.0031929824561403508) + E3_22 * T(0.1445964912280702);
  const T minus_Hp3_22 = E3_23 * b3_2;
  const T Hp3_23 = E3_22 * b3_2;
  const T minus_Hp3_31 = E3_22 * T(0.26800186566514794);
  const T Hp3_32 = Hp3_23 - T(0.1445964912280702);
  const T Hp3_33 = minus_Hp3_22 - T(0.0031929824561403508);
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_3 = E3_23 * T(0.06816145510835915) + T(2) * E3_22 * T(0.015632734778121774);
  const T b3_4 = E3_23 * b3_3;
  const T Jp3_22 = b3_4 - T(0.05392598555211559);
  const T Jp3_23 = T(0.015632734778121774) - E3_22 * b3_3;
  const T Jp3_33 = T(0.014235469556243552) - b3_4;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T np3_2 = E3_22 * nt3_2 + E3_23 * minus_nt3_3;
  const T np3_3 = E3_23 * nt3_2 - E3_22 * minus_nt3_3;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T Hb3_12 = T(0.2) * minus_Mp3_22 + T(0.15) * Mp3_23;
  const T Hb3_13 = T(0.15) * Mp3_33 - T(0.2) * Mp3_23;

  // ---- body 2 (body_2) and what it carries
  // MA2 = Mp4 + Mp3: force for an acceleration of the origin, home axes [kg]
  const T MA2_33 = Mp3_33 - b4_2;
  // HA2 = h_own_2~ + Hb3 + Hb4: moment for an acceleration of the origin, body axes [kg m]
  const T HA2_12 = Hb3_12 - minus_Hp4_12;
  const T HA2_13 = T(0.9949999999999999) + Hb3_13 + Hp4_13;
  const T HA2_21 = Hp3_21 + Hb4_21;
  const T HA2_23 = Hp3_23 - T(1.06) + Hb4_23;
  const T HA2_31 = b4_5 - (minus_Hp3_31 + T(0.9949999999999999));
  const T HA2_32 = T(1.06) + Hp3_32 + Hp4_32;
  const T HA2_33 = Hp3_33 - b4_4;
  // JA2 = q3~ Hp3^T + q4~ Hp4^T + J_own_2 + Jp4 + Jp3 - Hb3 q3~ - Hb4 q4~: moment for an angular acceleration, body
  //   axes [kg m^2]
  const T JA2_11 = T(0.4) * minus_Hp4_12 + Jp4_11 - Hb3_12 * T(0.2) + Hb3_13 * T(0.15);
  const T JA2_12 = T(0.2) * minus_Hp3_22 - T(0.26399999999999996) + T(0.15) * Hp3_23 + T(0.2) * Hp4_11 - T(0.3) *
      Hp4_13;
  const T JA2_13 = Jp4_13 - T(0.20240000000000002) + T(0.15) * Hp3_33 - T(0.2) * Hp3_32 - T(0.2) * Hp4_32 - T(0.3) *
      minus_Hp4_12;
  const T JA2_22 = T(0.08148411764705887) + Jp3_22 + T(0.4) * Hp3_21 - Hb4_23 * T(0.3) + Hb4_21 * T(0.2);
  const T JA2_23 = Jp3_23 - T(0.1918) + T(0.2) * b4_5 + T(0.3) * b4_4 - T(0.2) * minus_Hp3_31 - T(0.15) * Hp3_21;
  const T JA2_33 = T(1.0315041176470587) - minus_Jp4_33 + Jp3_33 + T(0.3) * minus_Hp3_31 + T(0.6) * Hp4_32;
  // g2 = G2 + gp4 + gp3: force that drives it, home axes [N]
  const T g2_1 = gp4_1 - minus_G2_1 - minus_G3_1;
  const T g2_2 = gp3_2 - (minus_G4_2 + minus_G2_2);
  const T g2_3 = gp4_3 - minus_G2_3 + gp3_3;
  // n2 = q3~ gp3 + q4~ gp4 + N2 + np4 + np3: moment that drives it, body axes [N m]
  const T n2_1 = np4_1 - minus_N2_1 - u.tau_3 + T(0.15) * gp3_3 - T(0.2) * gp3_2 + T(0.2) * minus_G4_2;
  const T n2_2 = np3_2 - (minus_N2_2 + u.tau_4) + T(0.2) * gp4_1 - T(0.3) * gp4_3 - T(0.2) * minus_G3_1;
  const T n2_3 = np4_3 - minus_N2_3 + np3_3 + T(0.15) * minus_G3_1 - T(0.3) * minus_G4_2;
  // invD2 = D2^-1: 1/D
  const T invD2 = T(1) / JA2_33;
  // kB2 = invD2 B2: B/D
  const T kB2_1 = invD2 * HA2_31;
  const T kB2_2 = invD2 * HA2_32;
  const T kB2_3 = invD2 * HA2_33;
  // kK2 = invD2 K2: K/D
  const T kK2_1 = invD2 * JA2_13;
  const T kK2_2 = invD2 * JA2_23;
  // u_2 = b2 . n2 + tau_body_2_: drives it [N m], [N]
  const T u_2 = n2_3 + u.tau_2;
  // v2 = invD2 u_2: u/D
  const T v2 = invD2 * u_2;
  // M2 = MA2 - kB2 B2^T: MA less what the turn takes up [kg]
  const T M2_11 = Mp4_11 - kB2_1 * HA2_31;
  const T minus_M2_12 = kB2_1 * HA2_32;
  const T M2_13 = Mp4_13 - kB2_1 * HA2_33;
  const T minus_M2_22 = minus_Mp3_22 + kB2_2 * HA2_32;
  const T M2_23 = Mp3_23 - kB2_2 * HA2_33;
  const T M2_33 = MA2_33 - kB2_3 * HA2_33;
  // H2 = P_b2 (HA2 - kK2 B2^T): HA less what the turn takes up [kg m]
  const T H2_11 = Hp4_11 - kK2_1 * HA2_31;
  const T H2_12 = HA2_12 - kK2_1 * HA2_32;
  const T H2_13 = HA2_13 - kK2_1 * HA2_33;
  const T H2_21 = HA2_21 - kK2_2 * HA2_31;
  const T minus_H2_22 = minus_Hp3_22 + kK2_2 * HA2_32;
  const T H2_23 = HA2_23 - kK2_2 * HA2_33;
  // J2 = P_b2 (JA2 - kK2 K2^T) P_b2: JA less what the turn takes up [kg m^2]
  const T J2_11 = JA2_11 - kK2_1 * JA2_13;
  const T J2_12 = JA2_12 - kK2_1 * JA2_23;
  const T J2_22 = JA2_22 - kK2_2 * JA2_23;
  // gt2 = g2 - v2 B2: force with the turn solved [N]
  const T gt2_1 = g2_1 - v2 * HA2_31;
  const T gt2_2 = g2_2 - v2 * HA2_32;
  const T gt2_3 = g2_3 - v2 * HA2_33;
  // nt2 = -tau_body_2_ b2 + P_b2 (n2 - v2 K2): moment with the turn solved [N m]
  const T nt2_1 = n2_1 - v2 * JA2_13;
  const T nt2_2 = n2_2 - v2 * JA2_23;
  // Mp2 = E2^T M2 E2: M passed on, lower body's axes [kg]
  const T b2_1 = T(2) * E2_11;
  const T b2_2 = E2_12 * (M2_11 + minus_M2_22) - b2_1 * minus_M2_12;
  const T b2_3 = E2_12 * b2_2;
  const T Mp2_11 = M2_11 - b2_3;
  const T Mp2_12 = minus_M2_12 + E2_11 * b2_2;
  const T Mp2_13 = E2_11 * M2_13 - E2_12 * M2_23;
  const T Mp2_22 = b2_3 - minus_M2_22;
  const T Mp2_23 = E2_12 * M2_13 + E2_11 * M2_23;
  // gp2 = E2^T gt2: force passed on, lower body's axes [N]
  const T gp2_1 = E2_11 * gt2_1 - E2_12 * gt2_2;
  const T gp2_2 = E2_12 * gt2_1 + E2_11 * gt2_2;
  // Hp2 = E2^T H2 E2: H passed on, lower body's axes [kg m]
  const T b2_4 = E2_12 * (H2_11 + minus_H2_22) + E2_11 * (H2_12 + H2_21);
  const T b2_5 = E2_12 * b2_4;
  const T Hp2_11 = H2_11 - b2_5;
  const T b2_6 = E2_11 * b2_4;
  const T Hp2_12 = b2_6 - H2_21;
  const T Hp2_13 = E2_11 * H2_13 - E2_12 * H2_23;
  const T Hp2_21 = b2_6 - H2_12;
  const T Hp2_22 = b2_5 - minus_H2_22;
  const T Hp2_23 = E2_12 * H2_13 + E2_11 * H2_23;
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T b2_7 = E2_12 * (J2_11 - J2_22) + b2_1 * J2_12;
  const T b2_8 = E2_12 * b2_7;
  const T Jp2_11 = J2_11 - b2_8;
  const T Jp2_12 = E2_11 * b2_7 - J2_12;
  const T Jp2_22 = J2_22 + b2_8;
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T np2_1 = E2_11 * nt2_1 - E2_12 * nt2_2;
  const T np2_2 = E2_12 * nt2_1 + E2_11 * nt2_2;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T b2_9 = T(0.1) * Mp2_13;
  const T Hb2_11 = b2_9 + Hp2_11;
  const T Hb2_12 = Hp2_12 + T(0.1) * Mp2_23;
  const T Hb2_13 = Hp2_13 + T(0.1) * M2_33;
  const T Hb2_21 = Hp2_21 - T(0.3) * Mp2_13;
  const T b2_10 = T(0.3) * Mp2_23;
  const T Hb2_22 = Hp2_22 - b2_10;
  const T Hb2_23 = Hp2_23 - T(0.3) * M2_33;
  const T Hb2_31 = T(0.3) * Mp2_12 - T(0.1) * Mp2_11;
  const T Hb2_32 = T(0.3) * Mp2_22 - T(0.1) * Mp2_12;
  const T Hb2_33 = b2_10 - b2_9;

  // ---- body 1 (body_1) and what it carries
  // MA1 = m_all_1 one + Mp5 + Mp2: force for an acceleration of the origin, home axes [kg]
  const T MA1_11 = T(8.1) - minus_Mp5_11 + Mp2_11;
  const T MA1_12 = Mp5_12 + Mp2_12;
  const T MA1_13 = Mp2_13 - minus_Mp5_13;
  const T MA1_22 = T(8.1) + Mp5_22 + Mp2_22;
  const T MA1_23 = Mp5_23 + Mp2_23;
  const T MA1_33 = T(8.1) + M5_33 + M2_33;
  // HA1 = h_all_1~ + Hb2 + Hb5: moment for an acceleration of the origin, body axes [kg m]
  const T HA1_11 = Hb2_11 + Hb5_11;
  const T HA1_12 = Hb2_12 - T(1.32) + Hb5_12;
  const T HA1_13 = T(1.385) + Hb2_13 + Hb5_13;
  const T HA1_21 = T(1.32) + Hb2_21 + Hb5_21;
  const T HA1_22 = Hb2_22 + Hb5_22;
  const T HA1_23 = Hb2_23 - T(2.21) + Hb5_23;
  const T HA1_31 = Hb2_31 - T(1.385) + Hb5_31;
  const T HA1_32 = T(2.21) + Hb2_32 + Hb5_32;
  const T HA1_33 = Hb2_33 + Hb5_33;
  // JA1 = q2~ Hp2^T + q5~ Hp5^T + J_all_1 + Jp5 + Jp2 - Hb2 q2~ - Hb5 q5~: moment for an angular acceleration, body
  //   axes [kg m^2]
  const T JA1_11 = T(1.53526) - minus_Jp5_11 + Jp2_11 + T(0.1) * Hp2_13 + T(0.25) * Hp5_13 + Hb2_13 * T(0.1) + Hb5_13
      * T(0.25);
  const T JA1_12 = Jp5_12 - T(0.366) + Jp2_12 + T(0.1) * Hp2_23 + T(0.25) * Hp5_23 - Hb2_13 * T(0.3) - Hb5_13 *
      T(0.3);
  const T minus_JA1_13 = T(0.3817) + Hb2_11 * T(0.1) - Hb2_12 * T(0.3) + Hb5_11 * T(0.25) - Hb5_12 * T(0.3);
  const T JA1_22 = T(1.92151) + Jp5_22 + Jp2_22 - T(0.3) * Hp2_23 - T(0.3) * Hp5_23 - Hb2_23 * T(0.3) - Hb5_23 *
      T(0.3);
  const T minus_JA1_23 = T(0.22365000000000002) + Hb2_21 * T(0.1) - Hb2_22 * T(0.3) + Hb5_21 * T(0.25) - Hb5_22 *
      T(0.3);
  const T JA1_33 = T(1.00575) + Hb2_32 * T(0.3) - Hb2_31 * T(0.1) - Hb5_31 * T(0.25) + Hb5_32 * T(0.3);
  // g1 = G1 + gp5 + gp2: force that drives it, home axes [N]
  const T g1_1 = G1_1 + gp5_1 + gp2_1;
  const T g1_2 = G1_2 + gp5_2 + gp2_2;
  const T g1_3 = G1_3 + gt5_3 + gt2_3;
  // n1 = q2~ gp2 + q5~ gp5 + N1 + np5 + np2: moment that drives it, body axes [N m]
  const T n1_1 = N1_1 + np5_1 + np2_1 + T(0.1) * gt2_3 + T(0.25) * gt5_3;
  const T n1_2 = N1_2 + np5_2 + np2_2 - T(0.3) * gt2_3 - T(0.3) * gt5_3;
  const T n1_3 = N1_3 - u.tau_5 - u.tau_2 + T(0.3) * gp2_2 - T(0.1) * gp2_1 + T(0.3) * gp5_2 - T(0.25) * gp5_1;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T LD1_21 = LD1_11 * JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - LD1_21 * JA1_12);
  const T minus_LD1_31 = LD1_11 * minus_JA1_13;
  const T b1_1 = LD1_21 * minus_JA1_13 - minus_JA1_23;
  const T LD1_32 = LD1_22 * b1_1;
  const T LD1_33 = T(1) / (JA1_33 - minus_LD1_31 * minus_JA1_13 - LD1_32 * b1_1);
  // Y1 = L(LD1)^-1 HA1: L^-1 HA
  const T Y1_21 = HA1_21 - LD1_21 * HA1_11;
  const T Y1_22 = HA1_22 - LD1_21 * HA1_12;
  const T Y1_23 = HA1_23 - LD1_21 * HA1_13;
  const T Y1_31 = HA1_31 + minus_LD1_31 * HA1_11 - LD1_32 * Y1_21;
  const T Y1_32 = HA1_32 + minus_LD1_31 * HA1_12 - LD1_32 * Y1_22;
  const T Y1_33 = HA1_33 + minus_LD1_31 * HA1_13 - LD1_32 * Y1_23;
  // W1 = D(LD1)^-1 Y1: D^-1 L^-1 HA
  const T W1_11 = LD1_11 * HA1_11;
  const T W1_12 = LD1_11 * HA1_12;
  const T W1_13 = LD1_11 * HA1_13;
  const T W1_21 = LD1_22 * Y1_21;
  const T W1_22 = LD1_22 * Y1_22;
  const T W1_23 = LD1_22 * Y1_23;
  const T W1_31 = LD1_33 * Y1_31;
  const T W1_32 = LD1_33 * Y1_32;
  const T W1_33 = LD1_33 * Y1_33;
  // w_1 = D(LD1)^-1 L(LD1)^-1 n1: D^-1 L^-1 n
  const T w_1_1 = LD1_11 * n1_1;
  const T b1_2 = n1_2 - LD1_21 * n1_1;
  const T w_1_2 = LD1_22 * b1_2;
  const T w_1_3 = LD1_33 * (n1_3 + minus_LD1_31 * n1_1 - LD1_32 * b1_2);
  // M1 = MA1 - Y1^T W1: MA less what the ball takes up [kg]
  const T M1_11 = MA1_11 - HA1_11 * W1_11 - Y1_21 * W1_21 - Y1_31 * W1_31;
  const T M1_12 = MA1_12 - HA1_11 * W1_12 - Y1_21 * W1_22 - Y1_31 * W1_32;
  const T M1_13 = MA1_13 - HA1_11 * W1_13 - Y1_21 * W1_23 - Y1_31 * W1_33;
  const T M1_22 = MA1_22 - HA1_12 * W1_12 - Y1_22 * W1_22 - Y1_32 * W1_32;
  const T M1_23 = MA1_23 - HA1_12 * W1_13 - Y1_22 * W1_23 - Y1_32 * W1_33;
  const T M1_33 = MA1_33 - HA1_13 * W1_13 - Y1_23 * W1_23 - Y1_33 * W1_33;
  // gb1 = g1 - Y1^T w_1: force with the ball solved [N]
  const T gb1_1 = g1_1 - HA1_11 * w_1_1 - Y1_21 * w_1_2 - Y1_31 * w_1_3;
  const T gb1_2 = g1_2 - HA1_12 * w_1_1 - Y1_22 * w_1_2 - Y1_32 * w_1_3;
  const T gb1_3 = g1_3 - HA1_13 * w_1_1 - Y1_23 * w_1_2 - Y1_33 * w_1_3;
  // LDs1 = L D L^T of M1: L D L^T = M: L, and 1/D on the diagonal
  const T LDs1_11 = T(1) / M1_11;
  const T LDs1_21 = LDs1_11 * M1_12;
  const T LDs1_22 = T(1) / (M1_22 - LDs1_21 * M1_12);
  const T LDs1_31 = LDs1_11 * M1_13;
  const T b1_3 = M1_23 - LDs1_21 * M1_13;
  const T LDs1_32 = LDs1_22 * b1_3;
  const T LDs1_33 = T(1) / (M1_33 - LDs1_31 * M1_13 - LDs1_32 * b1_3);
  // ws1 = D(LDs1)^-1 L(LDs1)^-1 gb1: D^-1 L^-1 g
  const T ws1_1 = LDs1_11 * gb1_1;
  const T b1_4 = gb1_2 - LDs1_21 * gb1_1;
  const T ws1_2 = LDs1_22 * b1_4;
  const T ws1_3 = LDs1_33 * (gb1_3 - LDs1_31 * gb1_1 - LDs1_32 * b1_4);

  // ---- body 1 (body_1), solved
  // Pddot1 = L(LDs1)^-T ws1
  const T z1_1 = ws1_2 - LDs1_32 * ws1_3;
  const T Pddot1_1 = ws1_1 - LDs1_21 * z1_1 - LDs1_31 * ws1_3;
  // omegadot1 = L(LD1)^-T (-W1 Pddot1 + w_1)
  const T z1_2 = w_1_3 - W1_31 * Pddot1_1 - W1_32 * z1_1 - W1_33 * ws1_3;
  const T z1_3 = w_1_2 - W1_21 * Pddot1_1 - W1_22 * z1_1 - W1_23 * ws1_3 - LD1_32 * z1_2;
  const T omegadot1_1 = w_1_1 - W1_11 * Pddot1_1 - W1_12 * z1_1 - W1_13 * ws1_3 - LD1_21 * z1_3 + minus_LD1_31 * z1_2;
  ydot[0] = omegadot1_1;
  ydot[1] = z1_3;
  ydot[2] = z1_2;
  // sddot1 = g + R1^T Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_1 = R1_11 * Pddot1_1 + R1_21 * z1_1 + R1_31 * ws1_3;
  const T sddot1_2 = R1_12 * Pddot1_1 + R1_22 * z1_1 + R1_32 * ws1_3;
  const T sddot1_3 = R1_13 * Pddot1_1 - T(9.81) + R1_23 * z1_1 + R1_33 * ws1_3;
  ydot[8] = sddot1_1;
  ydot[9] = sddot1_2;
  ydot[10] = sddot1_3;

  // ---- body 2 (body_2), solved
  // beta2 = -E2 q2~ omegadot1 + E2 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z2_1 = T(0.3) * z1_2;
  const T z2_2 = T(0.1) * z1_2;
  const T beta2_1 = E2_12 * z2_1 - E2_11 * z2_2 + E2_11 * Pddot1_1 + E2_12 * z1_1;
  const T beta2_2 = E2_11 * z1_1 - E2_12 * Pddot1_1 + E2_11 * z2_1 + E2_12 * z2_2;
  const T z2_3 = ws1_3 - T(0.3) * z1_3;
  const T beta2_3 = z2_3 + T(0.1) * omegadot1_1;
  // alphaL2 = E2 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL2_1 = E2_11 * omegadot1_1 + E2_12 * z1_3;
  const T alphaL2_2 = E2_11 * z1_3 - E2_12 * omegadot1_1;
  // phi2 = -kB2 . beta2 + v2 - (P_b2 kK2) . alphaL2
  const T phi2 = v2 - kB2_1 * beta2_1 - kB2_2 * beta2_2 - kB2_3 * beta2_3 - kK2_1 * alphaL2_1 - kK2_2 * alphaL2_2;
  // thetaddot2 = -b2 . alphaL2 + phi2
  const T thetaddot2 = phi2 - z1_2;
  ydot[3] = thetaddot2;

  // ---- body 3 (body_3), solved
  // beta3 = -E3 q3~ alpha2 + E3 beta2: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta3_3 = E3_22 * beta2_3 - E3_23 * beta2_2 + T(0.2) * alphaL2_1 * E3_23 + T(0.15) * alphaL2_1 * E3_22;
  // alphaL3 = E3 alpha2: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL3_2 = E3_22 * alphaL2_2 + E3_23 * phi2;
  const T alphaL3_3 = E3_22 * phi2 - E3_23 * alphaL2_2;
  // phi3 = -kB3 . beta3 + v3 - (P_b3 kK3) . alphaL3
  const T phi3 = v3 - T(1.4467037282868984) * beta3_3 - T(0.011914030703539162) * alphaL3_3 + T(0.5395353904317022) *
      alphaL3_2;
  // thetaddot3 = -b3 . alphaL3 + phi3
  const T thetaddot3 = phi3 - alphaL2_1;
  ydot[4] = thetaddot3;

  // ---- body 4 (body_4), solved
  // beta4 = -E4 q4~ alpha2 + E4 beta2: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta4_1 = E4_11 * beta2_1 - minus_E4_13 * beta2_3 + T(0.2) * alphaL2_2 * E4_11 + T(0.3) * alphaL2_2 *
      minus_E4_13;
  // alphaL4 = E4 alpha2: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4_1 = E4_11 * alphaL2_1 - minus_E4_13 * phi2;
  const T alphaL4_3 = minus_E4_13 * alphaL2_1 + E4_11 * phi2;
  // phi4 = -kB4 . beta4 + v4 - (P_b4 kK4) . alphaL4
  const T phi4 = v4 - T(0.8437992367923733) * beta4_1 - T(0.043877560313203424) * alphaL4_1 + T(0.31726851303393233) *
      alphaL4_3;
  // thetaddot4 = -b4 . alphaL4 + phi4
  const T thetaddot4 = phi4 - alphaL2_2;
  ydot[5] = thetaddot4;

  // ---- body 5 (body_5), solved
  // beta5 = -E5 q5~ omegadot1 + E5 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z5_1 = T(0.25) * z1_2;
  const T beta5_1 = E5_12 * z2_1 - E5_11 * z5_1 + E5_11 * Pddot1_1 + E5_12 * z1_1;
  const T beta5_2 = E5_11 * z1_1 - E5_12 * Pddot1_1 + E5_11 * z2_1 + E5_12 * z5_1;
  const T beta5_3 = z2_3 + T(0.25) * omegadot1_1;
  // alphaL5 = E5 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL5_1 = E5_11 * omegadot1_1 + E5_12 * z1_3;
  const T alphaL5_2 = E5_11 * z1_3 - E5_12 * omegadot1_1;
  // phi5 = -kB5 . beta5 + v5 - (P_b5 kK5) . alphaL5
  const T phi5 = v5 + minus_kB5_1 * beta5_1 - kB5_2 * beta5_2 - kB5_3 * beta5_3 - kK5_1 * alphaL5_1 - kK5_2 *
      alphaL5_2;
  // thetaddot5 = -b5 . alphaL5 + phi5
  const T thetaddot5 = phi5 - z1_2;
  ydot[6] = thetaddot5;

  // ---- body 6 (body_6), solved
  // beta6 = -E6 q6~ alpha5 + E6 beta5: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta6_3 = E6_22 * beta5_3 - E6_23 * beta5_2 + T(0.2) * alphaL5_1 * E6_23 + T(0.3) * alphaL5_1 * E6_22;
  // alphaL6 = E6 alpha5: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL6_2 = E6_22 * alphaL5_2 + E6_23 * phi5;
  const T alphaL6_3 = E6_22 * phi5 - E6_23 * alphaL5_2;
  // phi6 = -kB6 . beta6 + v6 - (P_b6 kK6) . alphaL6
  const T phi6 = v6 - T(1.4467037282868986) * beta6_3 - T(0.01191403070353916) * alphaL6_3 + T(0.5395353904317023) *
      alphaL6_2;
  // thetaddot6 = -b6 . alphaL6 + phi6
  const T thetaddot6 = phi6 - alphaL5_1;
  ydot[7] = thetaddot6;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 373 add, 384 multiply, 10 sine or cosine
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r)
    noexcept {
  T cosines[9], sines[9];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 5, cosines + 4, sines + 4);

  // ---- body 1 (body_1) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[8], sddot1_2 = ydot[9], sddot1_3 = ydot[10];
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
  const T U1_32 = t1_18 + omegadot1_1;
  const T minus_U1_33 = t1_14 + t1_17;
  // Pddot1 = R1 (-g + sddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t1_19 = sddot1_3 + T(9.81);
  const T Pddot1_1 = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * t1_19;
  const T Pddot1_2 = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * t1_19;
  const T Pddot1_3 = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * t1_19;
  // G1 = -R1 F1 + m_all_1 Pddot1 + U1 h_all_1: inertia less applied force, body axes [N]
  const T t1_20 = R1_11 * u.F_1_1 + R1_12 * u.F_1_2 + R1_13 * u.F_1_3;
  const T G1_1 = T(8.1) * Pddot1_1 - t1_20 + U1_12 * T(1.385) - minus_U1_11 * T(2.21) + U1_13 * T(1.32);
  const T t1_21 = R1_21 * u.F_1_1 + R1_22 * u.F_1_2 + R1_23 * u.F_1_3;
  const T G1_2 = T(8.1) * Pddot1_2 - t1_21 + U1_21 * T(2.21) - minus_U1_22 * T(1.385) + U1_23 * T(1.32);
  const T t1_22 = R1_31 * u.F_1_1 + R1_32 * u.F_1_2 + R1_33 * u.F_1_3;
  const T G1_3 = T(8.1) * Pddot1_3 - t1_22 + U1_31 * T(2.21) + U1_32 * T(1.385) - minus_U1_33 * T(1.32);
  // N1 = -r1~ R1 F1 + h_all_1~ Pddot1 + axial(U1 (tr(J_all_1)/2 - J_all_1)) - M1: inertia less applied moment about
  //   the body origin, body axes [N m]
  const T N1_1 = T(0.05) * t1_21 - u.M_1_1 - T(0.2) * t1_22 + T(1.385) * Pddot1_3 - T(1.32) * Pddot1_2 + T(0.30975) *
      U1_32 - T(1.22551) * U1_23 + T(0.22365000000000002) * (minus_U1_22 - minus_U1_33) + T(0.366) * U1_31 - T(0.3817)
      * U1_21;
  const T N1_2 = T(0.1) * t1_22 - u.M_1_2 - T(0.05) * t1_20 + T(1.32) * Pddot1_1 - T(2.21) * Pddot1_3 + T(1.22551) *
      U1_13 - T(0.696) * U1_31 + T(0.3817) * (minus_U1_33 - minus_U1_11) + T(0.22365000000000002) * U1_12 - T(0.366) *
      U1_32;
  const T N1_3 = T(0.2) * t1_20 - u.M_1_3 - T(0.1) * t1_21 + T(2.21) * Pddot1_2 - T(1.385) * Pddot1_1 + T(0.696) *
      U1_21 - T(0.30975) * U1_12 + T(0.366) * (minus_U1_11 - minus_U1_22) + T(0.3817) * U1_23 - T(0.22365000000000002)
      * U1_13;

  // ---- body 2 (body_2) on body 1
  const T thetadot2 = y[3];
  const T thetaddot2 = ydot[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[4];
  const T E2_12 = sines[4];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = E2_11 * omega1_1 + E2_12 * omega1_2;
  const T omega2_2 = E2_11 * omega1_2 - E2_12 * omega1_1;
  const T omega2_3 = thetadot2 + omega1_3;
  // omegadot2 = -thetadot2 b2~ E2 omega1 + thetaddot2 b2 + E2 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_1 = thetadot2 * omega2_2 + E2_11 * omegadot1_1 + E2_12 * omegadot1_2;
  const T omegadot2_2 = E2_11 * omegadot1_2 - E2_12 * omegadot1_1 - thetadot2 * omega2_1;
  const T omegadot2_3 = thetaddot2 + omegadot1_3;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_3 * omega2_3;
  const T t2_2 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_1 + t2_2;
  const T t2_3 = omega2_2 * omega2_1;
  const T U2_12 = t2_3 - omegadot2_3;
  const T t2_4 = omega2_3 * omega2_1;
  const T U2_13 = t2_4 + omegadot2_2;
  const T U2_21 = t2_3 + omegadot2_3;
  const T t2_5 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_1 + t2_5;
  const T t2_6 = omega2_3 * omega2_2;
  const T U2_23 = t2_6 - omegadot2_1;
  const T U2_31 = t2_4 - omegadot2_2;
  const T U2_32 = t2_6 + omegadot2_1;
  const T minus_U2_33 = t2_2 + t2_5;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_7 = minus_U1_11 * T(0.3) - Pddot1_1;
  const T t2_8 = U1_12 * T(0.1) - t2_7;
  const T t2_9 = Pddot1_2 + U1_21 * T(0.3);
  const T t2_10 = t2_9 - minus_U1_22 * T(0.1);
  const T Pddot2_1 = E2_11 * t2_8 + E2_12 * t2_10;
  const T Pddot2_2 = E2_11 * t2_10 - E2_12 * t2_8;
  const T t2_11 = Pddot1_3 + U1_31 * T(0.3);
  const T Pddot2_3 = t2_11 + U1_32 * T(0.1);
  // G2 = U2 h_own_2: inertia less applied force, body axes [N]
  const T G2_1 = U2_12 * T(0.9949999999999999) - minus_U2_11 * T(1.06);
  const T G2_2 = U2_21 * T(1.06) - minus_U2_22 * T(0.9949999999999999);
  const T G2_3 = U2_31 * T(1.06) + U2_32 * T(0.9949999999999999);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(0.9949999999999999) * Pddot2_3 + T(0.47501) * U2_32 + T(0.47501) * U2_23 + T(0.1918) * (minus_U2_22
      - minus_U2_33) + T(0.26399999999999996) * U2_31 - T(0.20240000000000002) * U2_21;
  const T N2_2 = T(0.20240000000000002) * (minus_U2_33 - minus_U2_11) - (T(0.47501) * U2_13 + T(0.5564941176470588) *
      U2_31) + T(0.1918) * U2_12 - T(0.26399999999999996) * U2_32 - T(1.06) * Pddot2_3;
  const T N2_3 = T(1.06) * Pddot2_2 - T(0.9949999999999999) * Pddot2_1 + T(0.5564941176470588) * U2_21 - T(0.47501) *
      U2_12 + T(0.26399999999999996) * (minus_U2_11 - minus_U2_22) + T(0.20240000000000002) * U2_23 - T(0.1918) *
      U2_13;

  // ---- body 3 (body_3) on body 2
  const T thetadot3 = y[4];
  const T thetaddot3 = ydot[4];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[5];
  const T t3_2 = sines[5];
  const T E3_22 = T(0.9701425001453319) * t3_1 - T(0.24253562503633297) * t3_2;
  const T E3_23 = T(0.24253562503633297) * t3_1 + T(0.9701425001453319) * t3_2;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega2_1;
  const T omega3_2 = E3_22 * omega2_2 + E3_23 * omega2_3;
  const T omega3_3 = E3_22 * omega2_3 - E3_23 * omega2_2;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + thetaddot3 b3 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = thetaddot3 + omegadot2_1;
  const T omegadot3_2 = thetadot3 * omega3_3 + E3_22 * omegadot2_2 + E3_23 * omegadot2_3;
  const T omegadot3_3 = E3_22 * omegadot2_3 - E3_23 * omegadot2_2 - thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_3 = omega3_3 * omega3_3;
  const T t3_4 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_3 + t3_4;
  const T t3_5 = omega3_2 * omega3_1;
  const T U3_12 = t3_5 - omegadot3_3;
  const T t3_6 = omega3_3 * omega3_1;
  const T U3_13 = t3_6 + omegadot3_2;
  const T U3_21 = t3_5 + omegadot3_3;
  const T t3_7 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_3 + t3_7;
  const T t3_8 = omega3_3 * omega3_2;
  const T U3_23 = t3_8 - omegadot3_1;
  const T U3_31 = t3_6 - omegadot3_2;
  const T U3_32 = t3_8 + omegadot3_1;
  const T minus_U3_33 = t3_4 + t3_7;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_9 = Pddot2_1 + U2_13 * T(0.2);
  const T Pddot3_1 = t3_9 + U2_12 * T(0.15);
  const T t3_10 = minus_U2_33 * T(0.2) - Pddot2_3;
  const T t3_11 = Pddot2_2 + U2_23 * T(0.2);
  const T Pddot3_3 = E3_22 * (U2_32 * T(0.15) - t3_10) - E3_23 * (t3_11 - minus_U2_22 * T(0.15));
  // G3 = U3 h_own_3: inertia less applied force, body axes [N]
  const T G3_1 = U3_12 * T(0.26800186566514794);
  const T minus_G3_2 = minus_U3_22 * T(0.26800186566514794);
  const T G3_3 = U3_32 * T(0.26800186566514794);
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(0.26800186566514794) * Pddot3_3 + T(0.09975588235294118) * U3_32 - T(0.08549411764705883) * U3_23 +
      T(0.016823529411764706) * (minus_U3_22 - minus_U3_33) + T(0.09994893107747284) * U3_31 + T(0.00220707418783063)
      * U3_21;
  const T N3_2 = T(0.08549411764705883) * U3_13 + T(0.08549411764705883) * U3_31 - T(0.00220707418783063) *
      (minus_U3_33 - minus_U3_11) + T(0.016823529411764706) * U3_12 - T(0.09994893107747284) * U3_32;
  const T N3_3 = T(0.09994893107747284) * (minus_U3_11 - minus_U3_22) - (T(0.08549411764705883) * U3_21 +
      T(0.09975588235294118) * U3_12) - T(0.00220707418783063) * U3_23 - T(0.016823529411764706) * U3_13 -
      T(0.26800186566514794) * Pddot3_1;

  // ---- body 4 (body_4) on body 2
  const T thetadot4 = y[5];
  const T thetaddot4 = ydot[5];
  // E4^T = Z4^T Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T t4_2 = sines[6];
  const T E4_11 = T(0.44721359549995804) * t4_1 - T(0.8944271909999159) * t4_2;
  const T minus_E4_13 = T(0.8944271909999159) * t4_1 + T(0.44721359549995804) * t4_2;
  // omega4 = thetadot4 b4 + E4 omega2: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega2_1 - minus_E4_13 * omega2_3;
  const T omega4_2 = thetadot4 + omega2_2;
  const T omega4_3 = minus_E4_13 * omega2_1 + E4_11 * omega2_3;
  // omegadot4 = -thetadot4 b4~ E4 omega2 + thetaddot4 b4 + E4 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = E4_11 * omegadot2_1 - minus_E4_13 * omegadot2_3 - thetadot4 * omega4_3;
  const T omegadot4_2 = thetaddot4 + omegadot2_2;
  const T omegadot4_3 = thetadot4 * omega4_1 + minus_E4_13 * omegadot2_1 + E4_11 * omegadot2_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_3 = omega4_3 * omega4_3;
  const T t4_4 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_3 + t4_4;
  const T t4_5 = omega4_2 * omega4_1;
  const T U4_12 = t4_5 - omegadot4_3;
  const T t4_6 = omega4_3 * omega4_1;
  const T U4_13 = t4_6 + omegadot4_2;
  const T U4_21 = t4_5 + omegadot4_3;
  const T t4_7 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_3 + t4_7;
  const T t4_8 = omega4_3 * omega4_2;
  const T U4_23 = t4_8 - omegadot4_1;
  const T U4_31 = t4_6 - omegadot4_2;
  const T U4_32 = t4_8 + omegadot4_1;
  const T minus_U4_33 = t4_4 + t4_7;
  // Pddot4 = E4 (U2 q4 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot4_1 = E4_11 * (t3_9 - minus_U2_11 * T(0.3)) - minus_E4_13 * (U2_31 * T(0.3) - t3_10);
  const T Pddot4_2 = t3_11 + U2_21 * T(0.3);
  // G4 = U4 h_own_4: inertia less applied force, body axes [N]
  const T G4_1 = U4_13 * T(0.15652475842498526);
  const T G4_2 = U4_23 * T(0.15652475842498526);
  const T minus_G4_3 = minus_U4_33 * T(0.15652475842498526);
  // N4 = h_own_4~ Pddot4 + axial(U4 (tr(J_own_4)/2 - J_own_4)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N4_1 = T(0.05885330916779445) * (minus_U4_22 - minus_U4_33) - (T(0.09576000000000001) * U4_32 + T(0.08974) *
      U4_23) - T(0.008139287438099234) * U4_31 + T(0.008680000000000007) * U4_21 - T(0.15652475842498526) * Pddot4_2;
  const T N4_2 = T(0.15652475842498526) * Pddot4_1 + T(0.08974) * U4_13 - T(0.09576000000000001) * U4_31 -
      T(0.008680000000000007) * (minus_U4_33 - minus_U4_11) + T(0.05885330916779445) * U4_12 + T(0.008139287438099234)
      * U4_32;
  const T N4_3 = T(0.09576000000000001) * U4_21 + T(0.09576000000000001) * U4_12 - T(0.008139287438099234) *
      (minus_U4_11 - minus_U4_22) - T(0.008680000000000007) * U4_23 - T(0.05885330916779445) * U4_13;

  // ---- body 5 (body_5) on body 1
  const T thetadot5 = y[6];
  const T thetaddot5 = ydot[6];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[7];
  const T E5_12 = sines[7];
  // omega5 = thetadot5 b5 + E5 omega1: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega1_1 + E5_12 * omega1_2;
  const T omega5_2 = E5_11 * omega1_2 - E5_12 * omega1_1;
  const T omega5_3 = thetadot5 + omega1_3;
  // omegadot5 = -thetadot5 b5~ E5 omega1 + thetaddot5 b5 + E5 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = thetadot5 * omega5_2 + E5_11 * omegadot1_1 + E5_12 * omegadot1_2;
  const T omegadot5_2 = E5_11 * omegadot1_2 - E5_12 * omegadot1_1 - thetadot5 * omega5_1;
  const T omegadot5_3 = thetaddot5 + omegadot1_3;
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
  // Pddot5 = E5 (U1 q5 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_7 = U1_12 * T(0.25) - t2_7;
  const T t5_8 = t2_9 - minus_U1_22 * T(0.25);
  const T Pddot5_1 = E5_11 * t5_7 + E5_12 * t5_8;
  const T Pddot5_2 = E5_11 * t5_8 - E5_12 * t5_7;
  const T Pddot5_3 = t2_11 + U1_32 * T(0.25);
  // G5 = U5 h_own_5: inertia less applied force, body axes [N]
  const T G5_1 = U5_12 * T(0.78) - minus_U5_11 * T(0.7900000000000001);
  const T G5_2 = U5_21 * T(0.7900000000000001) - minus_U5_22 * T(0.78);
  const T G5_3 = U5_31 * T(0.7900000000000001) + U5_32 * T(0.78);
  // N5 = h_own_5~ Pddot5 + axial(U5 (tr(J_own_5)/2 - J_own_5)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N5_1 = T(0.78) * Pddot5_3 + T(0.249) * U5_32 + T(0.249) * U5_23 + T(0.14700000000000002) * (minus_U5_22 -
      minus_U5_33) + T(0.21450000000000005) * U5_31 - T(0.14600000000000005) * U5_21;
  const T N5_2 = T(0.14600000000000005) * (minus_U5_33 - minus_U5_11) - (T(0.249) * U5_13 + T(0.5312235294117649) *
      U5_31) + T(0.14700000000000002) * U5_12 - T(0.21450000000000005) * U5_32 - T(0.7900000000000001) * Pddot5_3;
  const T N5_3 = T(0.7900000000000001) * Pddot5_2 - T(0.78) * Pddot5_1 + T(0.5312235294117649) * U5_21 - T(0.249) *
      U5_12 + T(0.21450000000000005) * (minus_U5_11 - minus_U5_22) + T(0.14600000000000005) * U5_23 -
      T(0.14700000000000002) * U5_13;

  // ---- body 6 (body_6) on body 5
  const T thetadot6 = y[7];
  const T thetaddot6 = ydot[7];
  // E6^T = Z6^T Rot(b6, theta6): E takes components in the lower body to those in the body
  const T t6_1 = cosines[8];
  const T t6_2 = sines[8];
  const T E6_22 = T(0.9701425001453319) * t6_1 - T(0.24253562503633297) * t6_2;
  const T E6_23 = T(0.24253562503633297) * t6_1 + T(0.9701425001453319) * t6_2;
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
  const T t6_3 = omega6_3 * omega6_3;
  const T t6_4 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_3 + t6_4;
  const T t6_5 = omega6_2 * omega6_1;
  const T U6_12 = t6_5 - omegadot6_3;
  const T t6_6 = omega6_3 * omega6_1;
  const T U6_13 = t6_6 + omegadot6_2;
  const T U6_21 = t6_5 + omegadot6_3;
  const T t6_7 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_3 + t6_7;
  const T t6_8 = omega6_3 * omega6_2;
  const T U6_23 = t6_8 - omegadot6_1;
  const T U6_31 = t6_6 - omegadot6_2;
  const T U6_32 = t6_8 + omegadot6_1;
  const T minus_U6_33 = t6_4 + t6_7;
  // Pddot6 = E6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = Pddot5_1 + U5_12 * T(0.3) + U5_13 * T(0.2);
  const T Pddot6_3 = E6_22 * (Pddot5_3 + U5_32 * T(0.3) - minus_U5_33 * T(0.2)) - E6_23 * (Pddot5_2 + U5_23 * T(0.2) -
      minus_U5_22 * T(0.3));
  // G6 = U6 h_own_6: inertia less applied force, body axes [N]
  const T G6_1 = U6_12 * T(0.32984845004941293);
  const T minus_G6_2 = minus_U6_22 * T(0.32984845004941293);
  const T G6_3 = U6_32 * T(0.32984845004941293);
  // N6 = h_own_6~ Pddot6 + axial(U6 (tr(J_own_6)/2 - J_own_6)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N6_1 = T(0.32984845004941293) * Pddot6_3 + T(0.12277647058823532) * U6_32 - T(0.1052235294117647) * U6_23 +
      T(0.020705882352941175) * (minus_U6_22 - minus_U6_33) + T(0.12301406901842814) * U6_31 + T(0.002716399000406929)
      * U6_21;
  const T N6_2 = T(0.1052235294117647) * U6_13 + T(0.1052235294117647) * U6_31 - T(0.002716399000406929) *
      (minus_U6_33 - minus_U6_11) + T(0.020705882352941175) * U6_12 - T(0.12301406901842814) * U6_32;
  const T N6_3 = T(0.12301406901842814) * (minus_U6_11 - minus_U6_22) - (T(0.1052235294117647) * U6_21 +
      T(0.12277647058823532) * U6_12) - T(0.002716399000406929) * U6_23 - T(0.020705882352941175) * U6_13 -
      T(0.32984845004941293) * Pddot6_1;

  // ---- body 6 (body_6) and what it carries
  // r_theta6 = b6 . N6 - tau_body_6_: Kane's equation of the angle [N m]
  const T r_theta6 = N6_1 - u.tau_6;
  r[7] = r_theta6;

  // ---- body 5 (body_5) and what it carries
  // S5 = E6^T G6 + G5: sum of the force balances of the subtree, body axes [N]
  const T S5_1 = G6_1 + G5_1;
  const T b5_1 = E6_22 * minus_G6_2 + E6_23 * G6_3;
  const T S5_2 = G5_2 - b5_1;
  const T b5_2 = E6_22 * G6_3 - E6_23 * minus_G6_2;
  const T S5_3 = b5_2 + G5_3;
  // rho5 = q6~ E6^T G6 + E6^T N6 + N5: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho5_1 = N6_1 + N5_1 + T(0.2) * b5_1 + T(0.3) * b5_2;
  const T rho5_2 = N5_2 + T(0.2) * G6_1 + E6_22 * N6_2 - E6_23 * N6_3;
  const T rho5_3 = N5_3 + E6_23 * N6_2 + E6_22 * N6_3 - T(0.3) * G6_1;
  // r_theta5 = b5 . rho5 - tau_body_5_: Kane's equation of the angle [N m]
  const T r_theta5 = rho5_3 - u.tau_5;
  r[6] = r_theta5;

  // ---- body 4 (body_4) and what it carries
  // r_theta4 = b4 . N4 - tau_body_4_: Kane's equation of the angle [N m]
  const T r_theta4 = N4_2 - u.tau_4;
  r[5] = r_theta4;

  // ---- body 3 (body_3) and what it carries
  // r_theta3 = b3 . N3 - tau_body_3_: Kane's equation of the angle [N m]
  const T r_theta3 = N3_1 - u.tau_3;
  r[4] = r_theta3;

  // ---- body 2 (body_2) and what it carries
  // S2 = E3^T G3 + E4^T G4 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = E4_11 * G4_1 - minus_E4_13 * minus_G4_3;
  const T S2_1 = G3_1 + b2_1 + G2_1;
  const T b2_2 = E3_22 * minus_G3_2 + E3_23 * G3_3;
  const T S2_2 = G4_2 - b2_2 + G2_2;
  const T b2_3 = E3_22 * G3_3 - E3_23 * minus_G3_2;
  const T b2_4 = minus_E4_13 * G4_1 + E4_11 * minus_G4_3;
  const T S2_3 = b2_3 - b2_4 + G2_3;
  // rho2 = q3~ E3^T G3 + E3^T N3 + q4~ E4^T G4 + E4^T N4 + N2: sum of the moment balances of the subtree about the
  //   body origin, body axes [N m]
  const T rho2_1 = N3_1 + N2_1 + T(0.2) * b2_2 + T(0.15) * b2_3 - T(0.2) * G4_2 + E4_11 * N4_1 + minus_E4_13 * N4_3;
  const T rho2_2 = N4_2 + N2_2 + T(0.2) * G3_1 + E3_22 * N3_2 - E3_23 * N3_3 + T(0.2) * b2_1 + T(0.3) * b2_4;
  const T rho2_3 = N2_3 + E3_23 * N3_2 + E3_22 * N3_3 - T(0.15) * G3_1 + T(0.3) * G4_2 + E4_11 * N4_3 - minus_E4_13 *
      N4_1;
  // r_theta2 = b2 . rho2 - tau_body_2_: Kane's equation of the angle [N m]
  const T r_theta2 = rho2_3 - u.tau_2;
  r[3] = r_theta2;

  // ---- body 1 (body_1) and what it carries
  // S1 = E2^T S2 + E5^T S5 + G1: sum of the force balances of the subtree, body axes [N]
  const T b1_1 = E2_11 * S2_1 - E2_12 * S2_2;
  const T b1_2 = E5_11 * S5_1 - E5_12 * S5_2;
  const T S1_1 = b1_1 + b1_2 + G1_1;
  const T b1_3 = E2_12 * S2_1 + E2_11 * S2_2;
  const T b1_4 = E5_12 * S5_1 + E5_11 * S5_2;
  const T S1_2 = b1_3 + b1_4 + G1_2;
  const T S1_3 = S2_3 + S5_3 + G1_3;
  // r_omega1 = q2~ E2^T S2 + E2^T rho2 + q5~ E5^T S5 + E5^T rho5 + N1: Kane's equation of omega [N m]
  const T r_omega1_1 = N1_1 + T(0.1) * S2_3 + E2_11 * rho2_1 - E2_12 * rho2_2 + T(0.25) * S5_3 + E5_11 * rho5_1 -
      E5_12 * rho5_2;
  const T r_omega1_2 = N1_2 + E2_12 * rho2_1 + E2_11 * rho2_2 - T(0.3) * S2_3 - T(0.3) * S5_3 + E5_12 * rho5_1 + E5_11
      * rho5_2;
  const T r_omega1_3 = rho2_3 + rho5_3 + N1_3 + T(0.3) * b1_3 - T(0.1) * b1_1 + T(0.3) * b1_4 - T(0.25) * b1_2;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
  // r_sdot1 = R1^T S1: Kane's equation of sdot [N]
  const T r_sdot1_1 = R1_11 * S1_1 + R1_21 * S1_2 + R1_31 * S1_3;
  const T r_sdot1_2 = R1_12 * S1_1 + R1_22 * S1_2 + R1_32 * S1_3;
  const T r_sdot1_3 = R1_13 * S1_1 + R1_23 * S1_2 + R1_33 * S1_3;
  r[8] = r_sdot1_1;
  r[9] = r_sdot1_2;
  r[10] = r_sdot1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 332 add, 359 multiply, 10 sine or cosine
template <class T>
void forcing([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* f) noexcept {
  T cosines[9], sines[9];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 5, cosines + 4, sines + 4);

  // ---- body 1 (body_1) on the inertial frame
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
  // Pddot1 = -R1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1 = R1_13 * T(9.81);
  const T Pddot1_2 = R1_23 * T(9.81);
  const T Pddot1_3 = R1_33 * T(9.81);
  // G1 = R1 F1 - m_all_1 Pddot1 - U1 h_all_1: applied less inertia force, body axes [N]
  const T t1_16 = R1_11 * u.F_1_1 + R1_12 * u.F_1_2 + R1_13 * u.F_1_3;
  const T G1_1 = t1_16 - T(8.1) * Pddot1_1 - U1_12 * T(1.385) + minus_U1_11 * T(2.21) - U1_13 * T(1.32);
  const T t1_17 = R1_21 * u.F_1_1 + R1_22 * u.F_1_2 + R1_23 * u.F_1_3;
  const T G1_2 = t1_17 - T(8.1) * Pddot1_2 - U1_12 * T(2.21) + minus_U1_22 * T(1.385) - U1_23 * T(1.32);
  const T t1_18 = R1_31 * u.F_1_1 + R1_32 * u.F_1_2 + R1_33 * u.F_1_3;
  const T G1_3 = t1_18 - T(8.1) * Pddot1_3 - U1_13 * T(2.21) - U1_23 * T(1.385) + minus_U1_33 * T(1.32);
  // N1 = r1~ R1 F1 - h_all_1~ Pddot1 - omega1~ J_all_1 omega1 + M1: applied less inertia moment about the body
  //   origin, body axes [N m]
  const T N1_1 = T(1.32) * Pddot1_2 - (T(0.05) * t1_17 - u.M_1_1 - T(0.2) * t1_18 + T(1.385) * Pddot1_3) + T(0.91576)
      * U1_23 + T(0.22365000000000002) * (t1_14 - t1_13) + T(0.3817) * U1_12 - T(0.366) * U1_13;
  const T N1_2 = T(2.21) * Pddot1_3 - (T(0.1) * t1_18 - u.M_1_2 - T(0.05) * t1_16 + T(1.32) * Pddot1_1) - T(0.52951) *
      U1_13 + T(0.3817) * (t1_13 - t1_15) + T(0.366) * U1_23 - T(0.22365000000000002) * U1_12;
  const T N1_3 = T(1.385) * Pddot1_1 - (T(0.2) * t1_16 - u.M_1_3 - T(0.1) * t1_17 + T(2.21) * Pddot1_2) -
      T(0.3862499999999999) * U1_12 + T(0.366) * (t1_15 - t1_14) + T(0.22365000000000002) * U1_13 - T(0.3817) * U1_23;

  // ---- body 2 (body_2) on body 1
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[4];
  const T E2_12 = sines[4];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = E2_11 * omega1_1 + E2_12 * omega1_2;
  const T omega2_2 = E2_11 * omega1_2 - E2_12 * omega1_1;
  const T omega2_3 = thetadot2 + omega1_3;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_1 = thetadot2 * omega2_2;
  const T minus_omegadot2_2 = thetadot2 * omega2_1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_3 * omega2_3;
  const T t2_2 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_1 + t2_2;
  const T U2_12 = omega2_2 * omega2_1;
  const T t2_3 = omega2_3 * omega2_1;
  const T U2_13 = t2_3 - minus_omegadot2_2;
  const T t2_4 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_1 + t2_4;
  const T t2_5 = omega2_3 * omega2_2;
  const T U2_23 = t2_5 - omegadot2_1;
  const T U2_31 = t2_3 + minus_omegadot2_2;
  const T U2_32 = t2_5 + omegadot2_1;
  const T minus_U2_33 = t2_2 + t2_4;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_6 = minus_U1_11 * T(0.3) - Pddot1_1;
  const T t2_7 = U1_12 * T(0.1) - t2_6;
  const T t2_8 = Pddot1_2 + U1_12 * T(0.3);
  const T t2_9 = t2_8 - minus_U1_22 * T(0.1);
  const T Pddot2_1 = E2_11 * t2_7 + E2_12 * t2_9;
  const T Pddot2_2 = E2_11 * t2_9 - E2_12 * t2_7;
  const T t2_10 = Pddot1_3 + U1_13 * T(0.3);
  const T Pddot2_3 = t2_10 + U1_23 * T(0.1);
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_12 * T(0.9949999999999999) - minus_U2_11 * T(1.06);
  const T minus_G2_2 = U2_12 * T(1.06) - minus_U2_22 * T(0.9949999999999999);
  const T minus_G2_3 = U2_31 * T(1.06) + U2_32 * T(0.9949999999999999);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(0.9949999999999999) * Pddot2_3 + T(0.47501) * U2_32 + T(0.47501) * U2_23 + T(0.1918) *
      (minus_U2_22 - minus_U2_33) + T(0.26399999999999996) * U2_31 - T(0.20240000000000002) * U2_12;
  const T minus_N2_2 = T(0.20240000000000002) * (minus_U2_33 - minus_U2_11) - (T(0.47501) * U2_13 +
      T(0.5564941176470588) * U2_31) + T(0.1918) * U2_12 - T(0.26399999999999996) * U2_32 - T(1.06) * Pddot2_3;
  const T minus_N2_3 = T(1.06) * Pddot2_2 - T(0.9949999999999999) * Pddot2_1 + T(0.08148411764705887) * U2_12 +
      T(0.26399999999999996) * (minus_U2_11 - minus_U2_22) + T(0.20240000000000002) * U2_23 - T(0.1918) * U2_13;

  // ---- body 3 (body_3) on body 2
  const T thetadot3 = y[4];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[5];
  const T t3_2 = sines[5];
  const T E3_22 = T(0.9701425001453319) * t3_1 - T(0.24253562503633297) * t3_2;
  const T E3_23 = T(0.24253562503633297) * t3_1 + T(0.9701425001453319) * t3_2;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega2_1;
  const T omega3_2 = E3_22 * omega2_2 + E3_23 * omega2_3;
  const T omega3_3 = E3_22 * omega2_3 - E3_23 * omega2_2;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_2 = thetadot3 * omega3_3 - E3_22 * minus_omegadot2_2;
  const T omegadot3_3 = E3_23 * minus_omegadot2_2 - thetadot3 * omega3_2;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_3 = omega3_3 * omega3_3;
  const T t3_4 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_3 + t3_4;
  const T t3_5 = omega3_2 * omega3_1;
  const T U3_12 = t3_5 - omegadot3_3;
  const T t3_6 = omega3_3 * omega3_1;
  const T U3_13 = t3_6 + omegadot3_2;
  const T U3_21 = t3_5 + omegadot3_3;
  const T t3_7 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_3 + t3_7;
  const T t3_8 = omega3_3 * omega3_2;
  const T U3_23 = t3_8 - omegadot2_1;
  const T U3_31 = t3_6 - omegadot3_2;
  const T U3_32 = t3_8 + omegadot2_1;
  const T minus_U3_33 = t3_4 + t3_7;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_9 = Pddot2_1 + U2_13 * T(0.2);
  const T Pddot3_1 = t3_9 + U2_12 * T(0.15);
  const T t3_10 = minus_U2_33 * T(0.2) - Pddot2_3;
  const T t3_11 = Pddot2_2 + U2_23 * T(0.2);
  const T Pddot3_3 = E3_22 * (U2_32 * T(0.15) - t3_10) - E3_23 * (t3_11 - minus_U2_22 * T(0.15));
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = U3_12 * T(0.26800186566514794);
  const T G3_2 = minus_U3_22 * T(0.26800186566514794);
  const T minus_G3_3 = U3_32 * T(0.26800186566514794);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(0.26800186566514794) * Pddot3_3 + T(0.09975588235294118) * U3_32 - T(0.08549411764705883) *
      U3_23 + T(0.016823529411764706) * (minus_U3_22 - minus_U3_33) + T(0.09994893107747284) * U3_31 +
      T(0.00220707418783063) * U3_21;
  const T minus_N3_2 = T(0.08549411764705883) * U3_13 + T(0.08549411764705883) * U3_31 - T(0.00220707418783063) *
      (minus_U3_33 - minus_U3_11) + T(0.016823529411764706) * U3_12 - T(0.09994893107747284) * U3_32;
  const T minus_N3_3 = T(0.09994893107747284) * (minus_U3_11 - minus_U3_22) - (T(0.08549411764705883) * U3_21 +
      T(0.09975588235294118) * U3_12) - T(0.00220707418783063) * U3_23 - T(0.016823529411764706) * U3_13 -
      T(0.26800186566514794) * Pddot3_1;

  // ---- body 4 (body_4) on body 2
  const T thetadot4 = y[5];
  // E4^T = Z4^T Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T t4_2 = sines[6];
  const T E4_11 = T(0.44721359549995804) * t4_1 - T(0.8944271909999159) * t4_2;
  const T minus_E4_13 = T(0.8944271909999159) * t4_1 + T(0.44721359549995804) * t4_2;
  // omega4 = thetadot4 b4 + E4 omega2: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega2_1 - minus_E4_13 * omega2_3;
  const T omega4_2 = thetadot4 + omega2_2;
  const T omega4_3 = minus_E4_13 * omega2_1 + E4_11 * omega2_3;
  // omegadot4 = -thetadot4 b4~ E4 omega2 + E4 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = E4_11 * omegadot2_1 - thetadot4 * omega4_3;
  const T omegadot4_3 = thetadot4 * omega4_1 + minus_E4_13 * omegadot2_1;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_3 = omega4_3 * omega4_3;
  const T t4_4 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_3 + t4_4;
  const T t4_5 = omega4_2 * omega4_1;
  const T U4_12 = t4_5 - omegadot4_3;
  const T t4_6 = omega4_3 * omega4_1;
  const T U4_13 = t4_6 - minus_omegadot2_2;
  const T U4_21 = t4_5 + omegadot4_3;
  const T t4_7 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_3 + t4_7;
  const T t4_8 = omega4_3 * omega4_2;
  const T U4_23 = t4_8 - omegadot4_1;
  const T U4_31 = t4_6 + minus_omegadot2_2;
  const T U4_32 = t4_8 + omegadot4_1;
  const T minus_U4_33 = t4_4 + t4_7;
  // Pddot4 = E4 (U2 q4 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot4_1 = E4_11 * (t3_9 - minus_U2_11 * T(0.3)) - minus_E4_13 * (U2_31 * T(0.3) - t3_10);
  const T Pddot4_2 = t3_11 + U2_12 * T(0.3);
  // G4 = -U4 h_own_4: applied less inertia force, body axes [N]
  const T minus_G4_1 = U4_13 * T(0.15652475842498526);
  const T minus_G4_2 = U4_23 * T(0.15652475842498526);
  const T G4_3 = minus_U4_33 * T(0.15652475842498526);
  // N4 = -h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N4_1 = T(0.05885330916779445) * (minus_U4_22 - minus_U4_33) - (T(0.09576000000000001) * U4_32 +
      T(0.08974) * U4_23) - T(0.008139287438099234) * U4_31 + T(0.008680000000000007) * U4_21 - T(0.15652475842498526)
      * Pddot4_2;
  const T minus_N4_2 = T(0.15652475842498526) * Pddot4_1 + T(0.08974) * U4_13 - T(0.09576000000000001) * U4_31 -
      T(0.008680000000000007) * (minus_U4_33 - minus_U4_11) + T(0.05885330916779445) * U4_12 + T(0.008139287438099234)
      * U4_32;
  const T minus_N4_3 = T(0.09576000000000001) * U4_21 + T(0.09576000000000001) * U4_12 - T(0.008139287438099234) *
      (minus_U4_11 - minus_U4_22) - T(0.008680000000000007) * U4_23 - T(0.05885330916779445) * U4_13;

  // ---- body 5 (body_5) on body 1
  const T thetadot5 = y[6];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[7];
  const T E5_12 = sines[7];
  // omega5 = thetadot5 b5 + E5 omega1: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega1_1 + E5_12 * omega1_2;
  const T omega5_2 = E5_11 * omega1_2 - E5_12 * omega1_1;
  const T omega5_3 = thetadot5 + omega1_3;
  // omegadot5 = -thetadot5 b5~ E5 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = thetadot5 * omega5_2;
  const T minus_omegadot5_2 = thetadot5 * omega5_1;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_1 = omega5_3 * omega5_3;
  const T t5_2 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_1 + t5_2;
  const T U5_12 = omega5_2 * omega5_1;
  const T t5_3 = omega5_3 * omega5_1;
  const T U5_13 = t5_3 - minus_omegadot5_2;
  const T t5_4 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_1 + t5_4;
  const T t5_5 = omega5_3 * omega5_2;
  const T U5_23 = t5_5 - omegadot5_1;
  const T U5_31 = t5_3 + minus_omegadot5_2;
  const T U5_32 = t5_5 + omegadot5_1;
  const T minus_U5_33 = t5_2 + t5_4;
  // Pddot5 = E5 (U1 q5 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_6 = U1_12 * T(0.25) - t2_6;
  const T t5_7 = t2_8 - minus_U1_22 * T(0.25);
  const T Pddot5_1 = E5_11 * t5_6 + E5_12 * t5_7;
  const T Pddot5_2 = E5_11 * t5_7 - E5_12 * t5_6;
  const T Pddot5_3 = t2_10 + U1_23 * T(0.25);
  // G5 = -U5 h_own_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = U5_12 * T(0.78) - minus_U5_11 * T(0.7900000000000001);
  const T minus_G5_2 = U5_12 * T(0.7900000000000001) - minus_U5_22 * T(0.78);
  const T minus_G5_3 = U5_31 * T(0.7900000000000001) + U5_32 * T(0.78);
  // N5 = -h_own_5~ Pddot5 - axial(U5 (tr(J_own_5)/2 - J_own_5)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N5_1 = T(0.78) * Pddot5_3 + T(0.249) * U5_32 + T(0.249) * U5_23 + T(0.14700000000000002) *
      (minus_U5_22 - minus_U5_33) + T(0.21450000000000005) * U5_31 - T(0.14600000000000005) * U5_12;
  const T minus_N5_2 = T(0.14600000000000005) * (minus_U5_33 - minus_U5_11) - (T(0.249) * U5_13 +
      T(0.5312235294117649) * U5_31) + T(0.14700000000000002) * U5_12 - T(0.21450000000000005) * U5_32 -
      T(0.7900000000000001) * Pddot5_3;
  const T minus_N5_3 = T(0.7900000000000001) * Pddot5_2 - T(0.78) * Pddot5_1 + T(0.2822235294117648) * U5_12 +
      T(0.21450000000000005) * (minus_U5_11 - minus_U5_22) + T(0.14600000000000005) * U5_23 - T(0.14700000000000002) *
      U5_13;

  // ---- body 6 (body_6) on body 5
  const T thetadot6 = y[7];
  // E6^T = Z6^T Rot(b6, theta6): E takes components in the lower body to those in the body
  const T t6_1 = cosines[8];
  const T t6_2 = sines[8];
  const T E6_22 = T(0.9701425001453319) * t6_1 - T(0.24253562503633297) * t6_2;
  const T E6_23 = T(0.24253562503633297) * t6_1 + T(0.9701425001453319) * t6_2;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega5_1;
  const T omega6_2 = E6_22 * omega5_2 + E6_23 * omega5_3;
  const T omega6_3 = E6_22 * omega5_3 - E6_23 * omega5_2;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_2 = thetadot6 * omega6_3 - E6_22 * minus_omegadot5_2;
  const T omegadot6_3 = E6_23 * minus_omegadot5_2 - thetadot6 * omega6_2;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_3 = omega6_3 * omega6_3;
  const T t6_4 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_3 + t6_4;
  const T t6_5 = omega6_2 * omega6_1;
  const T U6_12 = t6_5 - omegadot6_3;
  const T t6_6 = omega6_3 * omega6_1;
  const T U6_13 = t6_6 + omegadot6_2;
  const T U6_21 = t6_5 + omegadot6_3;
  const T t6_7 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_3 + t6_7;
  const T t6_8 = omega6_3 * omega6_2;
  const T U6_23 = t6_8 - omegadot5_1;
  const T U6_31 = t6_6 - omegadot6_2;
  const T U6_32 = t6_8 + omegadot5_1;
  const T minus_U6_33 = t6_4 + t6_7;
  // Pddot6 = E6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = Pddot5_1 + U5_12 * T(0.3) + U5_13 * T(0.2);
  const T Pddot6_3 = E6_22 * (Pddot5_3 + U5_32 * T(0.3) - minus_U5_33 * T(0.2)) - E6_23 * (Pddot5_2 + U5_23 * T(0.2) -
      minus_U5_22 * T(0.3));
  // G6 = -U6 h_own_6: applied less inertia force, body axes [N]
  const T minus_G6_1 = U6_12 * T(0.32984845004941293);
  const T G6_2 = minus_U6_22 * T(0.32984845004941293);
  const T minus_G6_3 = U6_32 * T(0.32984845004941293);
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(0.32984845004941293) * Pddot6_3 + T(0.12277647058823532) * U6_32 - T(0.1052235294117647) *
      U6_23 + T(0.020705882352941175) * (minus_U6_22 - minus_U6_33) + T(0.12301406901842814) * U6_31 +
      T(0.002716399000406929) * U6_21;
  const T minus_N6_2 = T(0.1052235294117647) * U6_13 + T(0.1052235294117647) * U6_31 - T(0.002716399000406929) *
      (minus_U6_33 - minus_U6_11) + T(0.020705882352941175) * U6_12 - T(0.12301406901842814) * U6_32;
  const T minus_N6_3 = T(0.12301406901842814) * (minus_U6_11 - minus_U6_22) - (T(0.1052235294117647) * U6_21 +
      T(0.12277647058823532) * U6_12) - T(0.002716399000406929) * U6_23 - T(0.020705882352941175) * U6_13 -
      T(0.32984845004941293) * Pddot6_1;

  // ---- body 6 (body_6) and what it carries
  // f_theta6 = b6 . N6 + tau_body_6_: Kane's equation of the angle [N m]
  const T f_theta6 = u.tau_6 - minus_N6_1;
  f[7] = f_theta6;

  // ---- body 5 (body_5) and what it carries
  // S5 = E6^T G6 + G5: sum of the force balances of the subtree, body axes [N]
  const T minus_S5_1 = minus_G6_1 + minus_G5_1;
  const T b5_1 = E6_23 * minus_G6_3 + E6_22 * G6_2;
  const T S5_2 = b5_1 - minus_G5_2;
  const T b5_2 = E6_22 * minus_G6_3 - E6_23 * G6_2;
  const T minus_S5_3 = b5_2 + minus_G5_3;
  // rho5 = q6~ E6^T G6 + E6^T N6 + N5: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T minus_rho5_1 = minus_N6_1 + minus_N5_1 + T(0.2) * b5_1 + T(0.3) * b5_2;
  const T rho5_2 = E6_23 * minus_N6_3 - minus_N5_2 - E6_22 * minus_N6_2 - T(0.2) * minus_G6_1;
  const T rho5_3 = T(0.3) * minus_G6_1 - (minus_N5_3 + E6_23 * minus_N6_2 + E6_22 * minus_N6_3);
  // f_theta5 = b5 . rho5 + tau_body_5_: Kane's equation of the angle [N m]
  const T f_theta5 = rho5_3 + u.tau_5;
  f[6] = f_theta5;

  // ---- body 4 (body_4) and what it carries
  // f_theta4 = b4 . N4 + tau_body_4_: Kane's equation of the angle [N m]
  const T f_theta4 = u.tau_4 - minus_N4_2;
  f[5] = f_theta4;

  // ---- body 3 (body_3) and what it carries
  // f_theta3 = b3 . N3 + tau_body_3_: Kane's equation of the angle [N m]
  const T f_theta3 = u.tau_3 - minus_N3_1;
  f[4] = f_theta3;

  // ---- body 2 (body_2) and what it carries
  // S2 = E3^T G3 + E4^T G4 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = E4_11 * minus_G4_1 - minus_E4_13 * G4_3;
  const T minus_S2_1 = minus_G3_1 + b2_1 + minus_G2_1;
  const T b2_2 = E3_23 * minus_G3_3 + E3_22 * G3_2;
  const T S2_2 = b2_2 - minus_G4_2 - minus_G2_2;
  const T b2_3 = minus_E4_13 * minus_G4_1 + E4_11 * G4_3;
  const T b2_4 = E3_22 * minus_G3_3 - E3_23 * G3_2;
  const T S2_3 = b2_3 - b2_4 - minus_G2_3;
  // rho2 = q3~ E3^T G3 + E3^T N3 + q4~ E4^T G4 + E4^T N4 + N2: sum of the moment balances of the subtree about the
  //   body origin, body axes [N m]
  const T rho2_1 = T(0.2) * minus_G4_2 - (minus_N3_1 + minus_N2_1 + T(0.2) * b2_2 + T(0.15) * b2_4) - E4_11 *
      minus_N4_1 - minus_E4_13 * minus_N4_3;
  const T rho2_2 = E3_23 * minus_N3_3 - (minus_N4_2 + minus_N2_2) - E3_22 * minus_N3_2 - T(0.2) * minus_G3_1 - T(0.2)
      * b2_1 - T(0.3) * b2_3;
  const T rho2_3 = T(0.15) * minus_G3_1 - (minus_N2_3 + E3_23 * minus_N3_2 + E3_22 * minus_N3_3) - T(0.3) * minus_G4_2
      + minus_E4_13 * minus_N4_1 - E4_11 * minus_N4_3;
  // f_theta2 = b2 . rho2 + tau_body_2_: Kane's equation of the angle [N m]
  const T f_theta2 = rho2_3 + u.tau_2;
  f[3] = f_theta2;

  // ---- body 1 (body_1) and what it carries
  // S1 = E2^T S2 + E5^T S5 + G1: sum of the force balances of the subtree, body axes [N]
  const T b1_1 = E2_11 * minus_S2_1 + E2_12 * S2_2;
  const T b1_2 = E5_11 * minus_S5_1 + E5_12 * S5_2;
  const T S1_1 = G1_1 - (b1_1 + b1_2);
  const T b1_3 = E2_11 * S2_2 - E2_12 * minus_S2_1;
  const T b1_4 = E5_11 * S5_2 - E5_12 * minus_S5_1;
  const T S1_2 = b1_3 + b1_4 + G1_2;
  const T S1_3 = S2_3 - minus_S5_3 + G1_3;
  // f_omega1 = q2~ E2^T S2 + E2^T rho2 + q5~ E5^T S5 + E5^T rho5 + N1: Kane's equation of omega [N m]
  const T f_omega1_1 = N1_1 + T(0.1) * S2_3 + E2_11 * rho2_1 - E2_12 * rho2_2 - T(0.25) * minus_S5_3 - E5_11 *
      minus_rho5_1 - E5_12 * rho5_2;
  const T f_omega1_2 = N1_2 + E2_12 * rho2_1 + E2_11 * rho2_2 - T(0.3) * S2_3 + T(0.3) * minus_S5_3 + E5_11 * rho5_2 -
      E5_12 * minus_rho5_1;
  const T f_omega1_3 = rho2_3 + rho5_3 + N1_3 + T(0.3) * b1_3 + T(0.1) * b1_1 + T(0.25) * b1_2 + T(0.3) * b1_4;
  f[0] = f_omega1_1;
  f[1] = f_omega1_2;
  f[2] = f_omega1_3;
  // f_sdot1 = R1^T S1: Kane's equation of sdot [N]
  const T f_sdot1_1 = R1_11 * S1_1 + R1_21 * S1_2 + R1_31 * S1_3;
  const T f_sdot1_2 = R1_12 * S1_1 + R1_22 * S1_2 + R1_32 * S1_3;
  const T f_sdot1_3 = R1_13 * S1_1 + R1_23 * S1_2 + R1_33 * S1_3;
  f[8] = f_sdot1_1;
  f[9] = f_sdot1_2;
  f[10] = f_sdot1_3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 172 add, 194 multiply, 10 sine or cosine
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  for (int i = 0; i < 121; ++i) A[i] = T(0);
  T cosines[9], sines[9];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 5, cosines + 4, sines + 4);

  // ---- body 1 (body_1) on the inertial frame
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

  // ---- body 2 (body_2) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[4];
  const T E2_12 = sines[4];

  // ---- body 3 (body_3) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];

  // ---- body 4 (body_4) on body 2
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];

  // ---- body 5 (body_5) on body 1
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[7];
  const T E5_12 = sines[7];

  // ---- body 6 (body_6) on body 5
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[8];
  const T E6_23 = sines[8];

  // ---- body 6 (body_6) and what it carries
  // hc6 = E6^T h_own_6: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc6_2 = E6_22 * T(0.32000000000000006) - E6_23 * T(0.08000000000000002);
  const T hc6_3 = E6_22 * T(0.08000000000000002) + E6_23 * T(0.32000000000000006);

  // ---- body 5 (body_5) and what it carries
  // h5 = h_own_5 + hc6: first moment of mass carried, about the body origin, body axes [kg m]
  const T h5_2 = T(0.78) + hc6_2;
  // J5 = -q6~ hc6~ + E6^T J_own_6 E6 + J_own_5 - hc6~ q6~: inertia carried, about the body origin, body axes [kg m^2]
  const T b5_1 = T(0.3) * hc6_2;
  const T b5_2 = b5_1 + T(0.2) * hc6_3;
  const T b5_3 = b5_2 + T(0.228);
  const T J5_11 = b5_3 + b5_2;
  const T b5_4 = E6_23 * T(0.027200000000000002) - E6_22 * T(0.12000000000000001);
  const T J5_12 = b5_4 - T(0.2145);
  const T b5_5 = E6_23 * T(0.12000000000000001) + E6_22 * T(0.027200000000000002);
  const T minus_J5_13 = b5_5 + T(0.14600000000000002);
  const T b5_6 = E6_23 * T(0.003999999999999991) - T(2) * E6_22 * T(0.022400000000000003);
  const T b5_7 = E6_23 * b5_6;
  const T J5_22 = T(0.293) - b5_7 + T(0.4) * hc6_3;
  const T b5_8 = T(0.3) * hc6_3;
  const T J5_23 = E6_22 * b5_6 - (T(0.1246) + b5_8) - T(0.2) * hc6_2;
  const T J5_33 = b5_7 + T(0.787) + T(0.6) * hc6_2;
  A[72] = J5_33;
  // hc5 = E5^T h5: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc5_1 = E5_11 * T(0.79) - E5_12 * h5_2;
  const T hc5_2 = E5_11 * h5_2 + E5_12 * T(0.79);
  A[73] = -b5_5;
  A[83] = -b5_5;

  // ---- body 4 (body_4) and what it carries
  // hc4 = E4^T h_own_4: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4_1 = minus_E4_13 * T(0.06999999999999999) + E4_11 * T(0.13999999999999999);
  const T hc4_3 = E4_11 * T(0.06999999999999999) - minus_E4_13 * T(0.13999999999999999);

  // ---- body 3 (body_3) and what it carries
  // hc3 = E3^T h_own_3: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc3_2 = E3_22 * T(0.26) - E3_23 * T(0.065);
  const T hc3_3 = E3_22 * T(0.065) + E3_23 * T(0.26);

  // ---- body 2 (body_2) and what it carries
  // h2 = h_own_2 + hc3 + hc4: first moment of mass carried, about the body origin, body axes [kg m]
  const T h2_1 = T(1.06) + hc4_1;
  const T h2_2 = T(0.995) + hc3_2;
  const T h2_3 = hc3_3 + hc4_3;
  // J2 = -q3~ hc3~ + E3^T J_own_3 E3 - q4~ hc4~ + E4^T J_own_4 E4 + J_own_2 - hc3~ q3~ - hc4~ q4~: inertia carried,
  //   about the body origin, body axes [kg m^2]
  const T b2_1 = T(0.2) * hc3_3 + T(0.15) * hc3_2;
  const T b2_2 = b2_1 + T(0.18525000000000003);
  const T b2_3 = minus_E4_13 * T(0.017500000000000012) + T(2) * E4_11 * T(0.0028000000000000004);
  const T b2_4 = minus_E4_13 * b2_3;
  const T J2_11 = b2_2 + T(0.017500000000000012) - b2_4 + b2_1 + T(0.4) * hc4_3;
  const T b2_5 = E3_23 * T(0.0221) - E3_22 * T(0.0975);
  const T b2_6 = E4_11 * T(0.049) + minus_E4_13 * T(0.0336);
  const T J2_12 = b2_5 - b2_6 - T(0.264);
  const T b2_7 = E3_23 * T(0.0975) + E3_22 * T(0.0221);
  const T minus_J2_13 = T(0.1996) + b2_7 + E4_11 * b2_3 + T(0.2) * hc4_1 + T(0.3) * hc4_3;
  const T b2_8 = T(0.3) * hc4_1;
  const T b2_9 = b2_8 + T(0.2) * hc4_3;
  const T b2_10 = E3_23 * T(0.0032499999999999977) - T(2) * E3_22 * T(0.0182);
  const T b2_11 = E3_23 * b2_10;
  const T J2_22 = b2_9 - b2_11 + T(0.2875) + b2_9 + T(0.4) * hc3_3;
  const T b2_12 = minus_E4_13 * T(0.049) - E4_11 * T(0.0336);
  const T J2_23 = b2_12 - T(0.1736) + E3_22 * b2_10 - T(0.2) * hc3_2 - T(0.15) * hc3_3;
  const T b2_13 = T(0.3) * hc3_2;
  const T J2_33 = b2_11 + T(1.02525) + b2_13 + b2_4 + T(0.6) * hc4_1;
  A[36] = J2_33;
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_1 = E2_11 * h2_1 - E2_12 * h2_2;
  const T hc2_2 = E2_11 * h2_2 + E2_12 * h2_1;
  // K_thetadot4_2 = q4~ E4^T B_thetadot4_4 + E4^T K_thetadot4_4
  const T K_thetadot4_2_2 = b2_9 + T(0.1855);
  A[38] = b2_12;
  A[58] = b2_12;
  A[37] = -b2_7;
  A[47] = -b2_7;

  // ---- body 1 (body_1) and what it carries
  // h1 = h_all_1 + hc2 + hc5: first moment of mass carried, about the body origin, body axes [kg m]
  const T h1_1 = T(2.21) + hc2_1 + hc5_1;
  const T h1_2 = T(1.385) + hc2_2 + hc5_2;
  const T h1_3 = T(1.32) + h2_3 + hc6_3;
  // J1 = -q2~ hc2~ + E2^T J2 E2 - q5~ hc5~ + E5^T J5 E5 + J_all_1 - hc2~ q2~ - hc5~ q5~: inertia carried, about the
  //   body origin, body axes [kg m^2]
  const T b1_1 = E2_12 * (J2_11 - J2_22) + T(2) * E2_11 * J2_12;
  const T b1_2 = E5_12 * (J5_11 - J5_22) + T(2) * E5_11 * J5_12;
  const T b1_3 = E2_12 * b1_1 + E5_12 * b1_2;
  const T J1_11 = J2_11 - b1_3 + J5_11 + T(1.5235) + T(0.2) * hc2_2 + T(0.5) * hc5_2;
  const T J1_12 = E2_11 * b1_1 - (J2_12 + J5_12 + T(0.366)) - T(0.1) * hc2_1 - T(0.25) * hc5_1 + E5_11 * b1_2 - T(0.3)
      * hc2_2 - T(0.3) * hc5_2;
  const T b1_4 = E2_11 * minus_J2_13 + E2_12 * J2_23;
  const T b1_5 = E5_11 * minus_J5_13 + E5_12 * J5_23;
  const T minus_J1_13 = b1_4 + b1_5 + T(0.3817) + b5_8 + T(0.3) * h2_3;
  const T J1_22 = J2_22 + b1_3 + J5_22 + T(1.90975) + T(0.6) * hc2_1 + T(0.6) * hc5_1;
  const T b1_6 = E2_11 * J2_23 - E2_12 * minus_J2_13;
  const T b1_7 = E5_11 * J5_23 - E5_12 * minus_J5_13;
  const T J1_23 = b1_6 + b1_7 - T(0.22365000000000002) - T(0.1) * h2_3 - T(0.25) * hc6_3;
  const T b1_8 = T(0.3) * hc2_1 + T(0.1) * hc2_2;
  const T b1_9 = b1_8 + J2_33;
  const T b1_10 = T(0.3) * hc5_1 + T(0.25) * hc5_2;
  const T b1_11 = J5_33 + b1_10;
  const T J1_33 = b1_9 + b1_11 + T(1.00575) + b1_8 + b1_10;
  A[0] = J1_11;
  A[1] = J1_12;
  A[11] = J1_12;
  A[2] = -minus_J1_13;
  A[22] = -minus_J1_13;
  A[12] = J1_22;
  A[13] = J1_23;
  A[23] = J1_23;
  A[24] = J1_33;
  // B_thetadot6_1 = E5^T B_thetadot6_5
  const T B_thetadot6_1_1 = E5_12 * hc6_3;
  const T minus_B_thetadot6_1_2 = E5_11 * hc6_3;
  // K_thetadot6_1 = q5~ E5^T B_thetadot6_5 + E5^T K_thetadot6_5
  const T K_thetadot6_1_1 = T(0.25) * hc6_2 + E5_11 * b5_3 - E5_12 * b5_4;
  const T K_thetadot6_1_2 = E5_12 * b5_3 - b5_1 + E5_11 * b5_4;
  const T minus_K_thetadot6_1_3 = b5_5 + T(0.3) * minus_B_thetadot6_1_2 + T(0.25) * B_thetadot6_1_1;
  A[7] = K_thetadot6_1_1;
  A[77] = K_thetadot6_1_1;
  A[18] = K_thetadot6_1_2;
  A[78] = K_thetadot6_1_2;
  A[29] = -minus_K_thetadot6_1_3;
  A[79] = -minus_K_thetadot6_1_3;
  A[6] = -b1_5;
  A[66] = -b1_5;
  A[17] = b1_7;
  A[67] = b1_7;
  A[28] = b1_11;
  A[68] = b1_11;
  // B_thetadot4_1 = E2^T B_thetadot4_2
  const T B_thetadot4_1_1 = E2_11 * hc4_3;
  const T B_thetadot4_1_2 = E2_12 * hc4_3;
  // K_thetadot4_1 = q2~ E2^T B_thetadot4_2 + E2^T K_thetadot4_2
  const T minus_K_thetadot4_1_1 = T(0.1) * hc4_1 + E2_11 * b2_6 + E2_12 * K_thetadot4_2_2;
  const T K_thetadot4_1_2 = b2_8 + E2_11 * K_thetadot4_2_2 - E2_12 * b2_6;
  const T K_thetadot4_1_3 = b2_12 + T(0.3) * B_thetadot4_1_2 - T(0.1) * B_thetadot4_1_1;
  A[5] = -minus_K_thetadot4_1_1;
  A[55] = -minus_K_thetadot4_1_1;
  A[16] = K_thetadot4_1_2;
  A[56] = K_thetadot4_1_2;
  A[27] = K_thetadot4_1_3;
  A[57] = K_thetadot4_1_3;
  // B_thetadot3_1 = E2^T B_thetadot3_2
  const T B_thetadot3_1_1 = E2_12 * hc3_3;
  const T minus_B_thetadot3_1_2 = E2_11 * hc3_3;
  // K_thetadot3_1 = q2~ E2^T B_thetadot3_2 + E2^T K_thetadot3_2
  const T K_thetadot3_1_1 = T(0.1) * hc3_2 + E2_11 * b2_2 - E2_12 * b2_5;
  const T K_thetadot3_1_2 = E2_12 * b2_2 - b2_13 + E2_11 * b2_5;
  const T minus_K_thetadot3_1_3 = b2_7 + T(0.3) * minus_B_thetadot3_1_2 + T(0.1) * B_thetadot3_1_1;
  A[4] = K_thetadot3_1_1;
  A[44] = K_thetadot3_1_1;
  A[15] = K_thetadot3_1_2;
  A[45] = K_thetadot3_1_2;
  A[26] = -minus_K_thetadot3_1_3;
  A[46] = -minus_K_thetadot3_1_3;
  A[3] = -b1_4;
  A[33] = -b1_4;
  A[14] = b1_6;
  A[34] = b1_6;
  A[25] = b1_9;
  A[35] = b1_9;

  // ---- results
  const T t1 = h1_2 * R1_31 - h1_3 * R1_21;
  A[8] = t1;
  A[88] = t1;
  const T t2 = h1_2 * R1_32 - h1_3 * R1_22;
  A[9] = t2;
  A[99] = t2;
  const T t3 = h1_2 * R1_33 - h1_3 * R1_23;
  A[10] = t3;
  A[110] = t3;
  const T t4 = h1_3 * R1_11 - h1_1 * R1_31;
  A[19] = t4;
  A[89] = t4;
  const T t5 = h1_3 * R1_12 - h1_1 * R1_32;
  A[20] = t5;
  A[100] = t5;
  const T t6 = h1_3 * R1_13 - h1_1 * R1_33;
  A[21] = t6;
  A[111] = t6;
  const T t7 = h1_1 * R1_21 - h1_2 * R1_11;
  A[30] = t7;
  A[90] = t7;
  const T t8 = h1_1 * R1_22 - h1_2 * R1_12;
  A[31] = t8;
  A[101] = t8;
  const T t9 = h1_1 * R1_23 - h1_2 * R1_13;
  A[32] = t9;
  A[112] = t9;
  const T t10 = R1_21 * hc2_1 - R1_11 * hc2_2;
  A[41] = t10;
  A[91] = t10;
  const T t11 = R1_22 * hc2_1 - R1_12 * hc2_2;
  A[42] = t11;
  A[102] = t11;
  const T t12 = R1_23 * hc2_1 - R1_13 * hc2_2;
  A[43] = t12;
  A[113] = t12;
  A[48] = T(0.18525000000000003);
  const T t13 = R1_11 * B_thetadot3_1_1 - R1_21 * minus_B_thetadot3_1_2 + R1_31 * hc3_2;
  A[52] = t13;
  A[92] = t13;
  const T t14 = R1_12 * B_thetadot3_1_1 - R1_22 * minus_B_thetadot3_1_2 + R1_32 * hc3_2;
  A[53] = t14;
  A[103] = t14;
  const T t15 = R1_13 * B_thetadot3_1_1 - R1_23 * minus_B_thetadot3_1_2 + R1_33 * hc3_2;
  A[54] = t15;
  A[114] = t15;
  A[60] = T(0.1855);
  const T t16 = R1_11 * B_thetadot4_1_1 + R1_21 * B_thetadot4_1_2 - R1_31 * hc4_1;
  A[63] = t16;
  A[93] = t16;
  const T t17 = R1_12 * B_thetadot4_1_1 + R1_22 * B_thetadot4_1_2 - R1_32 * hc4_1;
  A[64] = t17;
  A[104] = t17;
  const T t18 = R1_13 * B_thetadot4_1_1 + R1_23 * B_thetadot4_1_2 - R1_33 * hc4_1;
  A[65] = t18;
  A[115] = t18;
  const T t19 = R1_21 * hc5_1 - R1_11 * hc5_2;
  A[74] = t19;
  A[94] = t19;
  const T t20 = R1_22 * hc5_1 - R1_12 * hc5_2;
  A[75] = t20;
  A[105] = t20;
  const T t21 = R1_23 * hc5_1 - R1_13 * hc5_2;
  A[76] = t21;
  A[116] = t21;
  A[84] = T(0.228);
  const T t22 = R1_11 * B_thetadot6_1_1 - R1_21 * minus_B_thetadot6_1_2 + R1_31 * hc6_2;
  A[85] = t22;
  A[95] = t22;
  const T t23 = R1_12 * B_thetadot6_1_1 - R1_22 * minus_B_thetadot6_1_2 + R1_32 * hc6_2;
  A[86] = t23;
  A[106] = t23;
  const T t24 = R1_13 * B_thetadot6_1_1 - R1_23 * minus_B_thetadot6_1_2 + R1_33 * hc6_2;
  A[87] = t24;
  A[117] = t24;
  A[96] = T(8.1);
  A[108] = T(8.1);
  A[120] = T(8.1);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 303 add, 372 multiply, 10 sine or cosine
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  for (int i = 0; i < 198; ++i) v_y[i] = T(0);
  T cosines[9], sines[9];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 5, cosines + 4, sines + 4);

  // ---- body 1 (body_1) on the inertial frame
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
  // B1_1 = -R1^T r1~
  const T minus_B1_1_11 = R1_21 * T(0.05) - R1_31 * T(0.2);
  const T t1_13 = R1_31 * T(0.1);
  const T minus_B1_1_12 = t1_13 - R1_11 * T(0.05);
  const T t1_14 = R1_21 * T(0.1);
  const T minus_B1_1_13 = R1_11 * T(0.2) - t1_14;
  const T minus_B1_1_21 = R1_22 * T(0.05) - R1_32 * T(0.2);
  const T t1_15 = R1_32 * T(0.1);
  const T minus_B1_1_22 = t1_15 - R1_12 * T(0.05);
  const T t1_16 = R1_22 * T(0.1);
  const T minus_B1_1_23 = R1_12 * T(0.2) - t1_16;
  const T minus_B1_1_31 = R1_23 * T(0.05) - R1_33 * T(0.2);
  const T t1_17 = R1_33 * T(0.1);
  const T minus_B1_1_32 = t1_17 - R1_13 * T(0.05);
  const T t1_18 = R1_23 * T(0.1);
  const T minus_B1_1_33 = R1_13 * T(0.2) - t1_18;
  v_y[0] = -minus_B1_1_11;
  v_y[1] = -minus_B1_1_12;
  v_y[2] = -minus_B1_1_13;
  v_y[11] = -minus_B1_1_21;
  v_y[12] = -minus_B1_1_22;
  v_y[13] = -minus_B1_1_23;
  v_y[22] = -minus_B1_1_31;
  v_y[23] = -minus_B1_1_32;
  v_y[24] = -minus_B1_1_33;

  // ---- body 2 (body_2) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[4];
  const T E2_12 = sines[4];
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_11 = R1_11 * E2_11 + R1_21 * E2_12;
  const T R2_12 = R1_12 * E2_11 + R1_22 * E2_12;
  const T R2_13 = R1_13 * E2_11 + R1_23 * E2_12;
  const T R2_21 = R1_21 * E2_11 - R1_11 * E2_12;
  const T R2_22 = R1_22 * E2_11 - R1_12 * E2_12;
  const T R2_23 = R1_23 * E2_11 - R1_13 * E2_12;
  // P_omega1_2 = -R1^T q2~: partial velocity of the body origin, inertial axes
  const T minus_P_omega1_2_11 = t1_14 - t1_13;
  const T t2_1 = R1_11 * T(0.1);
  const T minus_P_omega1_2_12 = R1_31 * T(0.3) - t2_1;
  const T t2_2 = R1_21 * T(0.3);
  const T minus_P_omega1_2_13 = t2_1 - t2_2;
  const T minus_P_omega1_2_21 = t1_16 - t1_15;
  const T t2_3 = R1_12 * T(0.1);
  const T minus_P_omega1_2_22 = R1_32 * T(0.3) - t2_3;
  const T t2_4 = R1_22 * T(0.3);
  const T minus_P_omega1_2_23 = t2_3 - t2_4;
  const T minus_P_omega1_2_31 = t1_18 - t1_17;
  const T t2_5 = R1_13 * T(0.1);
  const T minus_P_omega1_2_32 = R1_33 * T(0.3) - t2_5;
  const T t2_6 = R1_23 * T(0.3);
  const T minus_P_omega1_2_33 = t2_5 - t2_6;
  // B3_1 = -R2^T r2~ E2 + P_omega1_2
  const T t2_7 = T(0.05) * E2_12;
  const T t2_8 = T(0.05) * E2_11;
  const T t2_9 = T(0.2) * E2_11;
  const T t2_10 = T(0.1) * E2_12;
  const T t2_11 = t2_9 + t2_10;
  const T minus_B3_1_11 = minus_P_omega1_2_11 + R2_11 * t2_7 + R2_21 * t2_8 - R1_31 * t2_11;
  const T t2_12 = T(0.1) * E2_11;
  const T t2_13 = T(0.2) * E2_12;
  const T t2_14 = t2_12 - t2_13;
  const T minus_B3_1_12 = minus_P_omega1_2_12 + R2_21 * t2_7 - R2_11 * t2_8 + R1_31 * t2_14;
  const T t2_15 = R2_11 * T(0.2);
  const T t2_16 = t2_15 - R2_21 * T(0.1);
  const T minus_B3_1_13 = t2_16 + minus_P_omega1_2_13;
  const T minus_B3_1_21 = minus_P_omega1_2_21 + R2_12 * t2_7 + R2_22 * t2_8 - R1_32 * t2_11;
  const T minus_B3_1_22 = minus_P_omega1_2_22 + R2_22 * t2_7 - R2_12 * t2_8 + R1_32 * t2_14;
  const T t2_17 = R2_12 * T(0.2);
  const T t2_18 = t2_17 - R2_22 * T(0.1);
  const T minus_B3_1_23 = t2_18 + minus_P_omega1_2_23;
  const T minus_B3_1_31 = minus_P_omega1_2_31 + R2_13 * t2_7 + R2_23 * t2_8 - R1_33 * t2_11;
  const T minus_B3_1_32 = minus_P_omega1_2_32 + R2_23 * t2_7 - R2_13 * t2_8 + R1_33 * t2_14;
  const T t2_19 = R2_13 * T(0.2);
  const T t2_20 = t2_19 - R2_23 * T(0.1);
  const T minus_B3_1_33 = t2_20 + minus_P_omega1_2_33;
  v_y[33] = -minus_B3_1_11;
  v_y[34] = -minus_B3_1_12;
  v_y[35] = -minus_B3_1_13;
  v_y[44] = -minus_B3_1_21;
  v_y[45] = -minus_B3_1_22;
  v_y[46] = -minus_B3_1_23;
  v_y[55] = -minus_B3_1_31;
  v_y[56] = -minus_B3_1_32;
  v_y[57] = -minus_B3_1_33;
  v_y[36] = -t2_16;
  v_y[47] = -t2_18;
  v_y[58] = -t2_20;

  // ---- body 3 (body_3) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_21 = R2_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R2_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R2_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_31 * E3_22 - R2_21 * E3_23;
  const T R3_32 = R1_32 * E3_22 - R2_22 * E3_23;
  const T R3_33 = R1_33 * E3_22 - R2_23 * E3_23;
  // omega_omega1_3 = E3 E2: partial angular velocity, body axes
  const T minus_omega_omega1_3_21 = E3_22 * E2_12;
  const T omega_omega1_3_22 = E3_22 * E2_11;
  const T omega_omega1_3_31 = E3_23 * E2_12;
  const T minus_omega_omega1_3_32 = E3_23 * E2_11;
  // P_omega1_3 = -R2^T q3~ E2 + P_omega1_2: partial velocity of the body origin, inertial axes
  const T t3_1 = minus_P_omega1_2_11 + R2_11 * t2_10 + R2_21 * t2_12;
  const T t3_2 = T(0.3) * E2_12;
  const T t3_3 = t3_2 + T(0.15) * E2_11;
  const T minus_P_omega1_3_11 = t3_1 - R1_31 * t3_3;
  const T t3_4 = minus_P_omega1_2_12 + R2_21 * t2_10 - R2_11 * t2_12;
  const T t3_5 = T(0.3) * E2_11;
  const T t3_6 = t3_5 - T(0.15) * E2_12;
  const T minus_P_omega1_3_12 = t3_4 + R1_31 * t3_6;
  const T t3_7 = R2_21 * T(0.3);
  const T t3_8 = R2_11 * T(0.15) - t3_7;
  const T minus_P_omega1_3_13 = t3_8 + minus_P_omega1_2_13;
  const T t3_9 = minus_P_omega1_2_21 + R2_12 * t2_10 + R2_22 * t2_12;
  const T minus_P_omega1_3_21 = t3_9 - R1_32 * t3_3;
  const T t3_10 = minus_P_omega1_2_22 + R2_22 * t2_10 - R2_12 * t2_12;
  const T minus_P_omega1_3_22 = t3_10 + R1_32 * t3_6;
  const T t3_11 = R2_22 * T(0.3);
  const T t3_12 = R2_12 * T(0.15) - t3_11;
  const T minus_P_omega1_3_23 = t3_12 + minus_P_omega1_2_23;
  const T t3_13 = minus_P_omega1_2_31 + R2_13 * t2_10 + R2_23 * t2_12;
  const T minus_P_omega1_3_31 = t3_13 - R1_33 * t3_3;
  const T t3_14 = minus_P_omega1_2_32 + R2_23 * t2_10 - R2_13 * t2_12;
  const T minus_P_omega1_3_32 = t3_14 + R1_33 * t3_6;
  const T t3_15 = R2_23 * T(0.3);
  const T t3_16 = R2_13 * T(0.15) - t3_15;
  const T minus_P_omega1_3_33 = t3_16 + minus_P_omega1_2_33;
  // B5_1 = -R3^T r3~ omega_omega1_3 + P_omega1_3
  const T t3_17 = T(0.05) * minus_omega_omega1_3_21 + T(0.2) * omega_omega1_3_31;
  const T t3_18 = t2_8 - T(0.1) * omega_omega1_3_31;
  const T t3_19 = t2_9 + T(0.1) * minus_omega_omega1_3_21;
  const T minus_B5_1_11 = minus_P_omega1_3_11 + R2_11 * t3_17 + R3_21 * t3_18 - R3_31 * t3_19;
  const T t3_20 = t2_7 + T(0.1) * minus_omega_omega1_3_32;
  const T t3_21 = T(0.05) * omega_omega1_3_22 + T(0.2) * minus_omega_omega1_3_32;
  const T t3_22 = T(0.1) * omega_omega1_3_22 - t2_13;
  const T minus_B5_1_12 = minus_P_omega1_3_12 + R3_21 * t3_20 - R2_11 * t3_21 + R3_31 * t3_22;
  const T t3_23 = T(0.2) * E3_22 - T(0.05) * E3_23;
  const T t3_24 = T(0.1) * E3_22;
  const T t3_25 = T(0.1) * E3_23;
  const T t3_26 = R2_11 * t3_23 - R3_21 * t3_24 + R3_31 * t3_25;
  const T minus_B5_1_13 = t3_26 + minus_P_omega1_3_13;
  const T minus_B5_1_21 = minus_P_omega1_3_21 + R2_12 * t3_17 + R3_22 * t3_18 - R3_32 * t3_19;
  const T minus_B5_1_22 = minus_P_omega1_3_22 + R3_22 * t3_20 - R2_12 * t3_21 + R3_32 * t3_22;
  const T t3_27 = R2_12 * t3_23 - R3_22 * t3_24 + R3_32 * t3_25;
  const T minus_B5_1_23 = t3_27 + minus_P_omega1_3_23;
  const T minus_B5_1_31 = minus_P_omega1_3_31 + R2_13 * t3_17 + R3_23 * t3_18 - R3_33 * t3_19;
  const T minus_B5_1_32 = minus_P_omega1_3_32 + R3_23 * t3_20 - R2_13 * t3_21 + R3_33 * t3_22;
  const T t3_28 = R2_13 * t3_23 - R3_23 * t3_24 + R3_33 * t3_25;
  const T minus_B5_1_33 = t3_28 + minus_P_omega1_3_33;
  v_y[66] = -minus_B5_1_11;
  v_y[67] = -minus_B5_1_12;
  v_y[68] = -minus_B5_1_13;
  v_y[77] = -minus_B5_1_21;
  v_y[78] = -minus_B5_1_22;
  v_y[79] = -minus_B5_1_23;
  v_y[88] = -minus_B5_1_31;
  v_y[89] = -minus_B5_1_32;
  v_y[90] = -minus_B5_1_33;
  // B6_2 = -R3^T r3~ omega_thetadot2_3 + P_thetadot2_3
  const T minus_B6_2_1 = t3_26 + t3_8;
  const T minus_B6_2_2 = t3_27 + t3_12;
  const T minus_B6_2_3 = t3_28 + t3_16;
  v_y[69] = -minus_B6_2_1;
  v_y[80] = -minus_B6_2_2;
  v_y[91] = -minus_B6_2_3;
  // B7_3 = -R3^T r3~ b3
  const T minus_B7_3_1 = R3_21 * T(0.05) - R3_31 * T(0.2);
  const T minus_B7_3_2 = R3_22 * T(0.05) - R3_32 * T(0.2);
  const T minus_B7_3_3 = R3_23 * T(0.05) - R3_33 * T(0.2);
  v_y[70] = -minus_B7_3_1;
  v_y[81] = -minus_B7_3_2;
  v_y[92] = -minus_B7_3_3;

  // ---- body 4 (body_4) on body 2
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R2^T E4^T: R takes inertial components to body components
  const T R4_11 = R2_11 * E4_11 - R1_31 * minus_E4_13;
  const T R4_12 = R2_12 * E4_11 - R1_32 * minus_E4_13;
  const T R4_13 = R2_13 * E4_11 - R1_33 * minus_E4_13;
  const T R4_31 = R2_11 * minus_E4_13 + R1_31 * E4_11;
  const T R4_32 = R2_12 * minus_E4_13 + R1_32 * E4_11;
  const T R4_33 = R2_13 * minus_E4_13 + R1_33 * E4_11;
  // omega_omega1_4 = E4 E2: partial angular velocity, body axes
  const T omega_omega1_4_11 = E4_11 * E2_11;
  const T omega_omega1_4_12 = E4_11 * E2_12;
  const T omega_omega1_4_31 = minus_E4_13 * E2_11;
  const T omega_omega1_4_32 = minus_E4_13 * E2_12;
  // P_omega1_4 = -R2^T q4~ E2 + P_omega1_2: partial velocity of the body origin, inertial axes
  const T t4_1 = t2_9 + t3_2;
  const T minus_P_omega1_4_11 = t3_1 - R1_31 * t4_1;
  const T t4_2 = t3_5 - t2_13;
  const T minus_P_omega1_4_12 = t3_4 + R1_31 * t4_2;
  const T t4_3 = t2_15 - t3_7;
  const T minus_P_omega1_4_13 = t4_3 + minus_P_omega1_2_13;
  const T minus_P_omega1_4_21 = t3_9 - R1_32 * t4_1;
  const T minus_P_omega1_4_22 = t3_10 + R1_32 * t4_2;
  const T t4_4 = t2_17 - t3_11;
  const T minus_P_omega1_4_23 = t4_4 + minus_P_omega1_2_23;
  const T minus_P_omega1_4_31 = t3_13 - R1_33 * t4_1;
  const T minus_P_omega1_4_32 = t3_14 + R1_33 * t4_2;
  const T t4_5 = t2_19 - t3_15;
  const T minus_P_omega1_4_33 = t4_5 + minus_P_omega1_2_33;
  // B8_1 = -R4^T r4~ omega_omega1_4 + P_omega1_4
  const T t4_6 = t2_7 + T(0.2) * omega_omega1_4_31;
  const T t4_7 = T(0.05) * omega_omega1_4_11 - T(0.1) * omega_omega1_4_31;
  const T t4_8 = t2_10 + T(0.2) * omega_omega1_4_11;
  const T minus_B8_1_11 = minus_P_omega1_4_11 + R4_11 * t4_6 + R2_21 * t4_7 - R4_31 * t4_8;
  const T t4_9 = T(0.2) * omega_omega1_4_32 - t2_8;
  const T t4_10 = T(0.05) * omega_omega1_4_12 - T(0.1) * omega_omega1_4_32;
  const T t4_11 = t2_12 - T(0.2) * omega_omega1_4_12;
  const T minus_B8_1_12 = minus_P_omega1_4_12 + R4_11 * t4_9 + R2_21 * t4_10 + R4_31 * t4_11;
  const T t4_12 = T(0.2) * E4_11;
  const T t4_13 = T(0.05) * minus_E4_13 + T(0.1) * E4_11;
  const T t4_14 = T(0.2) * minus_E4_13;
  const T t4_15 = R4_11 * t4_12 - R2_21 * t4_13 + R4_31 * t4_14;
  const T minus_B8_1_13 = t4_15 + minus_P_omega1_4_13;
  const T minus_B8_1_21 = minus_P_omega1_4_21 + R4_12 * t4_6 + R2_22 * t4_7 - R4_32 * t4_8;
  const T minus_B8_1_22 = minus_P_omega1_4_22 + R4_12 * t4_9 + R2_22 * t4_10 + R4_32 * t4_11;
  const T t4_16 = R4_12 * t4_12 - R2_22 * t4_13 + R4_32 * t4_14;
  const T minus_B8_1_23 = t4_16 + minus_P_omega1_4_23;
  const T minus_B8_1_31 = minus_P_omega1_4_31 + R4_13 * t4_6 + R2_23 * t4_7 - R4_33 * t4_8;
  const T minus_B8_1_32 = minus_P_omega1_4_32 + R4_13 * t4_9 + R2_23 * t4_10 + R4_33 * t4_11;
  const T t4_17 = R4_13 * t4_12 - R2_23 * t4_13 + R4_33 * t4_14;
  const T minus_B8_1_33 = t4_17 + minus_P_omega1_4_33;
  v_y[99] = -minus_B8_1_11;
  v_y[100] = -minus_B8_1_12;
  v_y[101] = -minus_B8_1_13;
  v_y[110] = -minus_B8_1_21;
  v_y[111] = -minus_B8_1_22;
  v_y[112] = -minus_B8_1_23;
  v_y[121] = -minus_B8_1_31;
  v_y[122] = -minus_B8_1_32;
  v_y[123] = -minus_B8_1_33;
  // B9_2 = -R4^T r4~ omega_thetadot2_4 + P_thetadot2_4
  const T minus_B9_2_1 = t4_15 + t4_3;
  const T minus_B9_2_2 = t4_16 + t4_4;
  const T minus_B9_2_3 = t4_17 + t4_5;
  v_y[102] = -minus_B9_2_1;
  v_y[113] = -minus_B9_2_2;
  v_y[124] = -minus_B9_2_3;
  // B10_4 = -R4^T r4~ b4
  const T minus_B10_4_1 = R4_31 * T(0.1) - R4_11 * T(0.05);
  const T minus_B10_4_2 = R4_32 * T(0.1) - R4_12 * T(0.05);
  const T minus_B10_4_3 = R4_33 * T(0.1) - R4_13 * T(0.05);
  v_y[104] = -minus_B10_4_1;
  v_y[115] = -minus_B10_4_2;
  v_y[126] = -minus_B10_4_3;

  // ---- body 5 (body_5) on body 1
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[7];
  const T E5_12 = sines[7];
  // R5^T = R1^T E5^T: R takes inertial components to body components
  const T R5_11 = R1_11 * E5_11 + R1_21 * E5_12;
  const T R5_12 = R1_12 * E5_11 + R1_22 * E5_12;
  const T R5_13 = R1_13 * E5_11 + R1_23 * E5_12;
  const T R5_21 = R1_21 * E5_11 - R1_11 * E5_12;
  const T R5_22 = R1_22 * E5_11 - R1_12 * E5_12;
  const T R5_23 = R1_23 * E5_11 - R1_13 * E5_12;
  // P_omega1_5 = -R1^T q5~: partial velocity of the body origin, inertial axes
  const T minus_P_omega1_5_11 = t1_14 - R1_31 * T(0.25);
  const T minus_P_omega1_5_13 = R1_11 * T(0.25) - t2_2;
  const T minus_P_omega1_5_21 = t1_16 - R1_32 * T(0.25);
  const T minus_P_omega1_5_23 = R1_12 * T(0.25) - t2_4;
  const T minus_P_omega1_5_31 = t1_18 - R1_33 * T(0.25);
  const T minus_P_omega1_5_33 = R1_13 * T(0.25) - t2_6;
  // B11_1 = -R5^T r5~ E5 + P_omega1_5
  const T t5_1 = T(0.05) * E5_12;
  const T t5_2 = T(0.05) * E5_11;
  const T t5_3 = T(0.2) * E5_11;
  const T t5_4 = T(0.1) * E5_12;
  const T t5_5 = t5_3 + t5_4;
  const T minus_B11_1_11 = minus_P_omega1_5_11 + R5_11 * t5_1 + R5_21 * t5_2 - R1_31 * t5_5;
  const T t5_6 = T(0.1) * E5_11;
  const T t5_7 = T(0.2) * E5_12;
  const T t5_8 = t5_6 - t5_7;
  const T minus_B11_1_12 = minus_P_omega1_2_12 + R5_21 * t5_1 - R5_11 * t5_2 + R1_31 * t5_8;
  const T t5_9 = R5_11 * T(0.2) - R5_21 * T(0.1);
  const T minus_B11_1_13 = t5_9 + minus_P_omega1_5_13;
  const T minus_B11_1_21 = minus_P_omega1_5_21 + R5_12 * t5_1 + R5_22 * t5_2 - R1_32 * t5_5;
  const T minus_B11_1_22 = minus_P_omega1_2_22 + R5_22 * t5_1 - R5_12 * t5_2 + R1_32 * t5_8;
  const T t5_10 = R5_12 * T(0.2) - R5_22 * T(0.1);
  const T minus_B11_1_23 = t5_10 + minus_P_omega1_5_23;
  const T minus_B11_1_31 = minus_P_omega1_5_31 + R5_13 * t5_1 + R5_23 * t5_2 - R1_33 * t5_5;
  const T minus_B11_1_32 = minus_P_omega1_2_32 + R5_23 * t5_1 - R5_13 * t5_2 + R1_33 * t5_8;
  const T t5_11 = R5_13 * T(0.2) - R5_23 * T(0.1);
  const T minus_B11_1_33 = t5_11 + minus_P_omega1_5_33;
  v_y[132] = -minus_B11_1_11;
  v_y[133] = -minus_B11_1_12;
  v_y[134] = -minus_B11_1_13;
  v_y[143] = -minus_B11_1_21;
  v_y[144] = -minus_B11_1_22;
  v_y[145] = -minus_B11_1_23;
  v_y[154] = -minus_B11_1_31;
  v_y[155] = -minus_B11_1_32;
  v_y[156] = -minus_B11_1_33;
  v_y[138] = -t5_9;
  v_y[149] = -t5_10;
  v_y[160] = -t5_11;

  // ---- body 6 (body_6) on body 5
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[8];
  const T E6_23 = sines[8];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_21 = R5_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R5_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R5_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R5_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R5_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R5_23 * E6_23;
  // omega_omega1_6 = E6 E5: partial angular velocity, body axes
  const T minus_omega_omega1_6_21 = E6_22 * E5_12;
  const T omega_omega1_6_22 = E6_22 * E5_11;
  const T omega_omega1_6_31 = E6_23 * E5_12;
  const T minus_omega_omega1_6_32 = E6_23 * E5_11;
  // P_omega1_6 = -R5^T q6~ E5 + P_omega1_5: partial velocity of the body origin, inertial axes
  const T t6_1 = T(0.3) * E5_11;
  const T t6_2 = T(0.3) * E5_12;
  const T t6_3 = t6_1 + t6_2;
  const T minus_P_omega1_6_11 = minus_P_omega1_5_11 + R5_11 * t5_4 + R5_21 * t5_6 - R1_31 * t6_3;
  const T t6_4 = t6_1 - t6_2;
  const T minus_P_omega1_6_12 = minus_P_omega1_2_12 + R5_21 * t5_4 - R5_11 * t5_6 + R1_31 * t6_4;
  const T t6_5 = R5_11 * T(0.3) - R5_21 * T(0.3);
  const T minus_P_omega1_6_13 = t6_5 + minus_P_omega1_5_13;
  const T minus_P_omega1_6_21 = minus_P_omega1_5_21 + R5_12 * t5_4 + R5_22 * t5_6 - R1_32 * t6_3;
  const T minus_P_omega1_6_22 = minus_P_omega1_2_22 + R5_22 * t5_4 - R5_12 * t5_6 + R1_32 * t6_4;
  const T t6_6 = R5_12 * T(0.3) - R5_22 * T(0.3);
  const T minus_P_omega1_6_23 = t6_6 + minus_P_omega1_5_23;
  const T minus_P_omega1_6_31 = minus_P_omega1_5_31 + R5_13 * t5_4 + R5_23 * t5_6 - R1_33 * t6_3;
  const T minus_P_omega1_6_32 = minus_P_omega1_2_32 + R5_23 * t5_4 - R5_13 * t5_6 + R1_33 * t6_4;
  const T t6_7 = R5_13 * T(0.3) - R5_23 * T(0.3);
  const T minus_P_omega1_6_33 = t6_7 + minus_P_omega1_5_33;
  // B13_1 = -R6^T r6~ omega_omega1_6 + P_omega1_6
  const T t6_8 = T(0.05) * minus_omega_omega1_6_21 + T(0.2) * omega_omega1_6_31;
  const T t6_9 = t5_2 - T(0.1) * omega_omega1_6_31;
  const T t6_10 = t5_3 + T(0.1) * minus_omega_omega1_6_21;
  const T minus_B13_1_11 = minus_P_omega1_6_11 + R5_11 * t6_8 + R6_21 * t6_9 - R6_31 * t6_10;
  const T t6_11 = t5_1 + T(0.1) * minus_omega_omega1_6_32;
  const T t6_12 = T(0.05) * omega_omega1_6_22 + T(0.2) * minus_omega_omega1_6_32;
  const T t6_13 = T(0.1) * omega_omega1_6_22 - t5_7;
  const T minus_B13_1_12 = minus_P_omega1_6_12 + R6_21 * t6_11 - R5_11 * t6_12 + R6_31 * t6_13;
  const T t6_14 = T(0.2) * E6_22 - T(0.05) * E6_23;
  const T t6_15 = T(0.1) * E6_22;
  const T t6_16 = T(0.1) * E6_23;
  const T t6_17 = R5_11 * t6_14 - R6_21 * t6_15 + R6_31 * t6_16;
  const T minus_B13_1_13 = t6_17 + minus_P_omega1_6_13;
  const T minus_B13_1_21 = minus_P_omega1_6_21 + R5_12 * t6_8 + R6_22 * t6_9 - R6_32 * t6_10;
  const T minus_B13_1_22 = minus_P_omega1_6_22 + R6_22 * t6_11 - R5_12 * t6_12 + R6_32 * t6_13;
  const T t6_18 = R5_12 * t6_14 - R6_22 * t6_15 + R6_32 * t6_16;
  const T minus_B13_1_23 = t6_18 + minus_P_omega1_6_23;
  const T minus_B13_1_31 = minus_P_omega1_6_31 + R5_13 * t6_8 + R6_23 * t6_9 - R6_33 * t6_10;
  const T minus_B13_1_32 = minus_P_omega1_6_32 + R6_23 * t6_11 - R5_13 * t6_12 + R6_33 * t6_13;
  const T t6_19 = R5_13 * t6_14 - R6_23 * t6_15 + R6_33 * t6_16;
  const T minus_B13_1_33 = t6_19 + minus_P_omega1_6_33;
  v_y[165] = -minus_B13_1_11;
  v_y[166] = -minus_B13_1_12;
  v_y[167] = -minus_B13_1_13;
  v_y[176] = -minus_B13_1_21;
  v_y[177] = -minus_B13_1_22;
  v_y[178] = -minus_B13_1_23;
  v_y[187] = -minus_B13_1_31;
  v_y[188] = -minus_B13_1_32;
  v_y[189] = -minus_B13_1_33;
  // B14_5 = -R6^T r6~ omega_thetadot5_6 + P_thetadot5_6
  const T minus_B14_5_1 = t6_17 + t6_5;
  const T minus_B14_5_2 = t6_18 + t6_6;
  const T minus_B14_5_3 = t6_19 + t6_7;
  v_y[171] = -minus_B14_5_1;
  v_y[182] = -minus_B14_5_2;
  v_y[193] = -minus_B14_5_3;
  // B15_6 = -R6^T r6~ b6
  const T minus_B15_6_1 = R6_21 * T(0.05) - R6_31 * T(0.2);
  const T minus_B15_6_2 = R6_22 * T(0.05) - R6_32 * T(0.2);
  const T minus_B15_6_3 = R6_23 * T(0.05) - R6_33 * T(0.2);
  v_y[172] = -minus_B15_6_1;
  v_y[183] = -minus_B15_6_2;
  v_y[194] = -minus_B15_6_3;

  // ---- results
  v_y[8] = T(1);
  v_y[20] = T(1);
  v_y[32] = T(1);
  v_y[41] = T(1);
  v_y[53] = T(1);
  v_y[65] = T(1);
  v_y[74] = T(1);
  v_y[86] = T(1);
  v_y[98] = T(1);
  v_y[107] = T(1);
  v_y[119] = T(1);
  v_y[131] = T(1);
  v_y[140] = T(1);
  v_y[152] = T(1);
  v_y[164] = T(1);
  v_y[173] = T(1);
  v_y[185] = T(1);
  v_y[197] = T(1);
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 584 add, 797 multiply, 10 sine or cosine
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  for (int i = 0; i < 198; ++i) v_y_dot[i] = T(0);
  T cosines[9], sines[9];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 5, cosines + 4, sines + 4);

  // ---- body 1 (body_1) on the inertial frame
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
  const T minus_B1_1_11 = t1_13 * T(0.05) - t1_14 * T(0.2);
  const T t1_15 = t1_14 * T(0.1);
  const T t1_16 = R1_21 * omega1_3 - R1_31 * omega1_2;
  const T minus_B1_1_12 = t1_15 - t1_16 * T(0.05);
  const T t1_17 = t1_13 * T(0.1);
  const T minus_B1_1_13 = t1_16 * T(0.2) - t1_17;
  const T t1_18 = R1_32 * omega1_1 - R1_12 * omega1_3;
  const T t1_19 = R1_12 * omega1_2 - R1_22 * omega1_1;
  const T minus_B1_1_21 = t1_18 * T(0.05) - t1_19 * T(0.2);
  const T t1_20 = t1_19 * T(0.1);
  const T t1_21 = R1_22 * omega1_3 - R1_32 * omega1_2;
  const T minus_B1_1_22 = t1_20 - t1_21 * T(0.05);
  const T t1_22 = t1_18 * T(0.1);
  const T minus_B1_1_23 = t1_21 * T(0.2) - t1_22;
  const T t1_23 = R1_33 * omega1_1 - R1_13 * omega1_3;
  const T t1_24 = R1_13 * omega1_2 - R1_23 * omega1_1;
  const T minus_B1_1_31 = t1_23 * T(0.05) - t1_24 * T(0.2);
  const T t1_25 = t1_24 * T(0.1);
  const T t1_26 = R1_23 * omega1_3 - R1_33 * omega1_2;
  const T minus_B1_1_32 = t1_25 - t1_26 * T(0.05);
  const T t1_27 = t1_23 * T(0.1);
  const T minus_B1_1_33 = t1_26 * T(0.2) - t1_27;
  v_y_dot[0] = -minus_B1_1_11;
  v_y_dot[1] = -minus_B1_1_12;
  v_y_dot[2] = -minus_B1_1_13;
  v_y_dot[11] = -minus_B1_1_21;
  v_y_dot[12] = -minus_B1_1_22;
  v_y_dot[13] = -minus_B1_1_23;
  v_y_dot[22] = -minus_B1_1_31;
  v_y_dot[23] = -minus_B1_1_32;
  v_y_dot[24] = -minus_B1_1_33;

  // ---- body 2 (body_2) on body 1
  const T thetadot2 = y[3];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[4];
  const T E2_12 = sines[4];
  // R2^T = R1^T E2^T: R takes inertial components to body components
  const T R2_11 = R1_11 * E2_11 + R1_21 * E2_12;
  const T R2_12 = R1_12 * E2_11 + R1_22 * E2_12;
  const T R2_13 = R1_13 * E2_11 + R1_23 * E2_12;
  const T R2_21 = R1_21 * E2_11 - R1_11 * E2_12;
  const T R2_22 = R1_22 * E2_11 - R1_12 * E2_12;
  const T R2_23 = R1_23 * E2_11 - R1_13 * E2_12;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_1 = E2_11 * omega1_1 + E2_12 * omega1_2;
  const T omega2_2 = E2_11 * omega1_2 - E2_12 * omega1_1;
  const T omega2_3 = thetadot2 + omega1_3;
  // P_dot_omega1_2 = -R1^T omega1~ q2~: its rate
  const T minus_P_dot_omega1_2_11 = t1_17 - t1_15;
  const T t2_1 = t1_16 * T(0.1);
  const T minus_P_dot_omega1_2_12 = t1_14 * T(0.3) - t2_1;
  const T t2_2 = t1_13 * T(0.3);
  const T minus_P_dot_omega1_2_13 = t2_1 - t2_2;
  const T minus_P_dot_omega1_2_21 = t1_22 - t1_20;
  const T t2_3 = t1_21 * T(0.1);
  const T minus_P_dot_omega1_2_22 = t1_19 * T(0.3) - t2_3;
  const T t2_4 = t1_18 * T(0.3);
  const T minus_P_dot_omega1_2_23 = t2_3 - t2_4;
  const T minus_P_dot_omega1_2_31 = t1_27 - t1_25;
  const T t2_5 = t1_26 * T(0.1);
  const T minus_P_dot_omega1_2_32 = t1_24 * T(0.3) - t2_5;
  const T t2_6 = t1_23 * T(0.3);
  const T minus_P_dot_omega1_2_33 = t2_5 - t2_6;
  // B2_1 = thetadot2 R2^T r2~ b2~ E2 - R2^T omega2~ r2~ E2 + P_dot_omega1_2
  const T t2_7 = T(0.05) * E2_11;
  const T t2_8 = omega2_3 * t2_7;
  const T t2_9 = T(0.2) * E2_11;
  const T t2_10 = T(0.1) * E2_12;
  const T t2_11 = t2_9 + t2_10;
  const T t2_12 = t2_8 + omega2_2 * t2_11;
  const T t2_13 = T(0.05) * E2_12;
  const T t2_14 = omega2_3 * t2_13;
  const T t2_15 = t2_14 + omega2_1 * t2_11;
  const T t2_16 = omega2_1 * t2_7 - omega2_2 * t2_13;
  const T t2_17 = T(0.1) * E2_11;
  const T t2_18 = T(0.2) * E2_12;
  const T t2_19 = t2_17 - t2_18;
  const T B2_1_11 = R2_11 * t2_12 - minus_P_dot_omega1_2_11 - R2_21 * t2_15 - R1_31 * t2_16 + thetadot2 * (R2_21 *
      t2_13 - R2_11 * t2_7 + R1_31 * t2_19);
  const T t2_20 = omega2_2 * t2_19 - t2_14;
  const T t2_21 = t2_8 + omega2_1 * t2_19;
  const T t2_22 = omega2_1 * t2_13 + omega2_2 * t2_7;
  const T minus_B2_1_12 = minus_P_dot_omega1_2_12 + thetadot2 * (R2_11 * t2_13 + R2_21 * t2_7 - R1_31 * t2_11) + R2_11
      * t2_20 - R2_21 * t2_21 + R1_31 * t2_22;
  const T t2_23 = omega2_3 * T(0.1);
  const T t2_24 = omega2_3 * T(0.2);
  const T t2_25 = R2_21 * t2_24;
  const T t2_26 = omega2_1 * T(0.1);
  const T t2_27 = omega2_2 * T(0.2);
  const T t2_28 = t2_26 + t2_27;
  const T t2_29 = R2_11 * t2_23 + t2_25 - R1_31 * t2_28;
  const T minus_B2_1_13 = t2_29 + minus_P_dot_omega1_2_13;
  const T B2_1_21 = R2_12 * t2_12 - minus_P_dot_omega1_2_21 - R2_22 * t2_15 - R1_32 * t2_16 + thetadot2 * (R2_22 *
      t2_13 - R2_12 * t2_7 + R1_32 * t2_19);
  const T minus_B2_1_22 = minus_P_dot_omega1_2_22 + thetadot2 * (R2_12 * t2_13 + R2_22 * t2_7 - R1_32 * t2_11) + R2_12
      * t2_20 - R2_22 * t2_21 + R1_32 * t2_22;
  const T t2_30 = R2_22 * t2_24;
  const T t2_31 = R2_12 * t2_23 + t2_30 - R1_32 * t2_28;
  const T minus_B2_1_23 = t2_31 + minus_P_dot_omega1_2_23;
  const T B2_1_31 = R2_13 * t2_12 - minus_P_dot_omega1_2_31 - R2_23 * t2_15 - R1_33 * t2_16 + thetadot2 * (R2_23 *
      t2_13 - R2_13 * t2_7 + R1_33 * t2_19);
  const T minus_B2_1_32 = minus_P_dot_omega1_2_32 + thetadot2 * (R2_13 * t2_13 + R2_23 * t2_7 - R1_33 * t2_11) + R2_13
      * t2_20 - R2_23 * t2_21 + R1_33 * t2_22;
  const T t2_32 = R2_23 * t2_24;
  const T t2_33 = R2_13 * t2_23 + t2_32 - R1_33 * t2_28;
  const T minus_B2_1_33 = t2_33 + minus_P_dot_omega1_2_33;
  v_y_dot[33] = B2_1_11;
  v_y_dot[34] = -minus_B2_1_12;
  v_y_dot[35] = -minus_B2_1_13;
  v_y_dot[44] = B2_1_21;
  v_y_dot[45] = -minus_B2_1_22;
  v_y_dot[46] = -minus_B2_1_23;
  v_y_dot[55] = B2_1_31;
  v_y_dot[56] = -minus_B2_1_32;
  v_y_dot[57] = -minus_B2_1_33;
  v_y_dot[36] = -t2_29;
  v_y_dot[47] = -t2_31;
  v_y_dot[58] = -t2_33;

  // ---- body 3 (body_3) on body 2
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[5];
  const T E3_23 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_21 = R2_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R2_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R2_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_31 * E3_22 - R2_21 * E3_23;
  const T R3_32 = R1_32 * E3_22 - R2_22 * E3_23;
  const T R3_33 = R1_33 * E3_22 - R2_23 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = thetadot3 + omega2_1;
  const T omega3_2 = E3_22 * omega2_2 + E3_23 * omega2_3;
  const T omega3_3 = E3_22 * omega2_3 - E3_23 * omega2_2;
  // omega_omega1_3 = E3 E2: partial angular velocity, body axes
  const T minus_omega_omega1_3_21 = E3_22 * E2_12;
  const T omega_omega1_3_22 = E3_22 * E2_11;
  const T omega_omega1_3_31 = E3_23 * E2_12;
  const T minus_omega_omega1_3_32 = E3_23 * E2_11;
  // omega_dot_omega1_3 = -(thetadot2 E3 b2~ + thetadot3 b3~ E3) E2: its rate
  const T minus_omega_dot_omega1_3_11 = thetadot2 * E2_12;
  const T omega_dot_omega1_3_12 = thetadot2 * E2_11;
  const T t3_1 = thetadot2 * E3_22;
  const T t3_2 = thetadot3 * E3_23;
  const T minus_omega_dot_omega1_3_21 = t3_1 * E2_11 - t3_2 * E2_12;
  const T minus_omega_dot_omega1_3_22 = t3_1 * E2_12 + t3_2 * E2_11;
  const T omega_dot_omega1_3_23 = thetadot3 * E3_22;
  const T t3_3 = thetadot2 * E3_23;
  const T omega_dot_omega1_3_31 = t3_3 * E2_11 + omega_dot_omega1_3_23 * E2_12;
  const T minus_omega_dot_omega1_3_32 = omega_dot_omega1_3_23 * E2_11 - t3_3 * E2_12;
  // P_dot_omega1_3 = R2^T (thetadot2 q3~ b2~ - omega2~ q3~) E2 + P_dot_omega1_2: its rate
  const T t3_4 = omega2_2 * T(0.3);
  const T t3_5 = t3_4 * E2_12;
  const T t3_6 = t2_23 - thetadot2 * T(0.1);
  const T t3_7 = omega2_2 * T(0.15);
  const T t3_8 = t3_6 + t3_7;
  const T t3_9 = t3_5 + t3_8 * E2_11;
  const T t3_10 = omega2_1 * T(0.3);
  const T t3_11 = t3_6 + t3_10;
  const T t3_12 = t3_11 * E2_12;
  const T t3_13 = omega2_1 * T(0.15);
  const T t3_14 = t3_12 + t3_13 * E2_11;
  const T t3_15 = thetadot2 * T(0.3) - t2_26;
  const T t3_16 = t3_15 * E2_11;
  const T t3_17 = omega2_2 * T(0.1);
  const T t3_18 = thetadot2 * T(0.15) - t3_17;
  const T t3_19 = t3_16 - t3_18 * E2_12;
  const T P_dot_omega1_3_11 = R2_11 * t3_9 - minus_P_dot_omega1_2_11 - R2_21 * t3_14 + R1_31 * t3_19;
  const T t3_20 = t3_4 * E2_11;
  const T t3_21 = t3_8 * E2_12 - t3_20;
  const T t3_22 = t3_11 * E2_11;
  const T t3_23 = t3_22 - t3_13 * E2_12;
  const T t3_24 = t3_15 * E2_12;
  const T t3_25 = t3_24 + t3_18 * E2_11;
  const T P_dot_omega1_3_12 = R2_11 * t3_21 - minus_P_dot_omega1_2_12 + R2_21 * t3_23 + R1_31 * t3_25;
  const T t3_26 = t3_7 + t3_10;
  const T t3_27 = omega2_3 * T(0.3);
  const T t3_28 = R2_11 * t3_27;
  const T t3_29 = omega2_3 * T(0.15);
  const T t3_30 = R1_31 * t3_26 - (t3_28 + R2_21 * t3_29);
  const T P_dot_omega1_3_13 = t3_30 - minus_P_dot_omega1_2_13;
  const T P_dot_omega1_3_21 = R2_12 * t3_9 - minus_P_dot_omega1_2_21 - R2_22 * t3_14 + R1_32 * t3_19;
  const T P_dot_omega1_3_22 = R2_12 * t3_21 - minus_P_dot_omega1_2_22 + R2_22 * t3_23 + R1_32 * t3_25;
  const T t3_31 = R2_12 * t3_27;
  const T t3_32 = R1_32 * t3_26 - (t3_31 + R2_22 * t3_29);
  const T P_dot_omega1_3_23 = t3_32 - minus_P_dot_omega1_2_23;
  const T P_dot_omega1_3_31 = R2_13 * t3_9 - minus_P_dot_omega1_2_31 - R2_23 * t3_14 + R1_33 * t3_19;
  const T P_dot_omega1_3_32 = R2_13 * t3_21 - minus_P_dot_omega1_2_32 + R2_23 * t3_23 + R1_33 * t3_25;
  const T t3_33 = R2_13 * t3_27;
  const T t3_34 = R1_33 * t3_26 - (t3_33 + R2_23 * t3_29);
  const T P_dot_omega1_3_33 = t3_34 - minus_P_dot_omega1_2_33;
  // B4_1 = -R3^T omega3~ r3~ omega_omega1_3 - R3^T r3~ omega_dot_omega1_3 + P_dot_omega1_3
  const T t3_35 = t2_7 - T(0.1) * omega_omega1_3_31;
  const T t3_36 = t2_9 + T(0.1) * minus_omega_omega1_3_21;
  const T t3_37 = omega3_3 * t3_35 + omega3_2 * t3_36;
  const T t3_38 = T(0.05) * minus_omega_omega1_3_21 + T(0.2) * omega_omega1_3_31;
  const T t3_39 = omega3_3 * t3_38 + omega3_1 * t3_36;
  const T t3_40 = omega3_1 * t3_35 - omega3_2 * t3_38;
  const T t3_41 = T(0.05) * minus_omega_dot_omega1_3_21 + T(0.2) * omega_dot_omega1_3_31;
  const T t3_42 = T(0.05) * minus_omega_dot_omega1_3_11;
  const T t3_43 = t3_42 + T(0.1) * omega_dot_omega1_3_31;
  const T t3_44 = T(0.2) * minus_omega_dot_omega1_3_11 - T(0.1) * minus_omega_dot_omega1_3_21;
  const T B4_1_11 = P_dot_omega1_3_11 + R2_11 * t3_37 - R3_21 * t3_39 - R3_31 * t3_40 - R2_11 * t3_41 + R3_21 * t3_43
      - R3_31 * t3_44;
  const T t3_45 = T(0.05) * omega_omega1_3_22 + T(0.2) * minus_omega_omega1_3_32;
  const T t3_46 = T(0.1) * omega_omega1_3_22 - t2_18;
  const T t3_47 = omega3_3 * t3_45 + omega3_1 * t3_46;
  const T t3_48 = t2_13 + T(0.1) * minus_omega_omega1_3_32;
  const T t3_49 = omega3_2 * t3_46 - omega3_3 * t3_48;
  const T t3_50 = omega3_1 * t3_48 + omega3_2 * t3_45;
  const T t3_51 = T(0.05) * minus_omega_dot_omega1_3_22 - T(0.2) * minus_omega_dot_omega1_3_32;
  const T t3_52 = T(0.05) * omega_dot_omega1_3_12;
  const T t3_53 = t3_52 + T(0.1) * minus_omega_dot_omega1_3_32;
  const T t3_54 = T(0.2) * omega_dot_omega1_3_12 + T(0.1) * minus_omega_dot_omega1_3_22;
  const T B4_1_12 = P_dot_omega1_3_12 + R3_21 * t3_47 - R2_11 * t3_49 - R3_31 * t3_50 - R2_11 * t3_51 - R3_21 * t3_53
      + R3_31 * t3_54;
  const T t3_55 = T(0.1) * E3_22;
  const T t3_56 = T(0.1) * E3_23;
  const T t3_57 = omega3_3 * t3_55 + omega3_2 * t3_56;
  const T t3_58 = T(0.2) * E3_22 - T(0.05) * E3_23;
  const T t3_59 = omega3_3 * t3_58 - omega3_1 * t3_56;
  const T t3_60 = omega3_1 * t3_55 + omega3_2 * t3_58;
  const T t3_61 = T(0.1) * t3_2;
  const T t3_62 = T(0.05) * omega_dot_omega1_3_23 + T(0.2) * t3_2;
  const T t3_63 = T(0.1) * omega_dot_omega1_3_23;
  const T t3_64 = R2_11 * t3_57 + R3_21 * t3_59 - R3_31 * t3_60 + R3_21 * t3_61 - R2_11 * t3_62 + R3_31 * t3_63;
  const T B4_1_13 = P_dot_omega1_3_13 - t3_64;
  const T B4_1_21 = P_dot_omega1_3_21 + R2_12 * t3_37 - R3_22 * t3_39 - R3_32 * t3_40 - R2_12 * t3_41 + R3_22 * t3_43
      - R3_32 * t3_44;
  const T B4_1_22 = P_dot_omega1_3_22 + R3_22 * t3_47 - R2_12 * t3_49 - R3_32 * t3_50 - R2_12 * t3_51 - R3_22 * t3_53
      + R3_32 * t3_54;
  const T t3_65 = R2_12 * t3_57 + R3_22 * t3_59 - R3_32 * t3_60 + R3_22 * t3_61 - R2_12 * t3_62 + R3_32 * t3_63;
  const T B4_1_23 = P_dot_omega1_3_23 - t3_65;
  const T B4_1_31 = P_dot_omega1_3_31 + R2_13 * t3_37 - R3_23 * t3_39 - R3_33 * t3_40 - R2_13 * t3_41 + R3_23 * t3_43
      - R3_33 * t3_44;
  const T B4_1_32 = P_dot_omega1_3_32 + R3_23 * t3_47 - R2_13 * t3_49 - R3_33 * t3_50 - R2_13 * t3_51 - R3_23 * t3_53
      + R3_33 * t3_54;
  const T t3_66 = R2_13 * t3_57 + R3_23 * t3_59 - R3_33 * t3_60 + R3_23 * t3_61 - R2_13 * t3_62 + R3_33 * t3_63;
  const T B4_1_33 = P_dot_omega1_3_33 - t3_66;
  v_y_dot[66] = B4_1_11;
  v_y_dot[67] = B4_1_12;
  v_y_dot[68] = B4_1_13;
  v_y_dot[77] = B4_1_21;
  v_y_dot[78] = B4_1_22;
  v_y_dot[79] = B4_1_23;
  v_y_dot[88] = B4_1_31;
  v_y_dot[89] = B4_1_32;
  v_y_dot[90] = B4_1_33;
  // B5_2 = -R3^T omega3~ r3~ omega_thetadot2_3 - R3^T r3~ omega_dot_thetadot2_3 + P_dot_thetadot2_3
  const T minus_B5_2_1 = t3_64 - t3_30;
  const T minus_B5_2_2 = t3_65 - t3_32;
  const T minus_B5_2_3 = t3_66 - t3_34;
  v_y_dot[69] = -minus_B5_2_1;
  v_y_dot[80] = -minus_B5_2_2;
  v_y_dot[91] = -minus_B5_2_3;
  // B6_3 = -R3^T omega3~ r3~ b3
  const T t3_67 = omega3_1 * T(0.2);
  const T t3_68 = omega3_3 * T(0.05) + omega3_2 * T(0.2);
  const T t3_69 = omega3_1 * T(0.05);
  const T minus_B6_3_1 = R3_21 * t3_67 - R2_11 * t3_68 + R3_31 * t3_69;
  const T minus_B6_3_2 = R3_22 * t3_67 - R2_12 * t3_68 + R3_32 * t3_69;
  const T minus_B6_3_3 = R3_23 * t3_67 - R2_13 * t3_68 + R3_33 * t3_69;
  v_y_dot[70] = -minus_B6_3_1;
  v_y_dot[81] = -minus_B6_3_2;
  v_y_dot[92] = -minus_B6_3_3;

  // ---- body 4 (body_4) on body 2
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R2^T E4^T: R takes inertial components to body components
  const T R4_11 = R2_11 * E4_11 - R1_31 * minus_E4_13;
  const T R4_12 = R2_12 * E4_11 - R1_32 * minus_E4_13;
  const T R4_13 = R2_13 * E4_11 - R1_33 * minus_E4_13;
  const T R4_31 = R2_11 * minus_E4_13 + R1_31 * E4_11;
  const T R4_32 = R2_12 * minus_E4_13 + R1_32 * E4_11;
  const T R4_33 = R2_13 * minus_E4_13 + R1_33 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega2: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega2_1 - minus_E4_13 * omega2_3;
  const T omega4_2 = thetadot4 + omega2_2;
  const T omega4_3 = minus_E4_13 * omega2_1 + E4_11 * omega2_3;
  // omega_omega1_4 = E4 E2: partial angular velocity, body axes
  const T omega_omega1_4_11 = E4_11 * E2_11;
  const T omega_omega1_4_12 = E4_11 * E2_12;
  const T omega_omega1_4_31 = minus_E4_13 * E2_11;
  const T omega_omega1_4_32 = minus_E4_13 * E2_12;
  // omega_dot_omega1_4 = -(thetadot2 E4 b2~ + thetadot4 b4~ E4) E2: its rate
  const T t4_1 = thetadot4 * minus_E4_13;
  const T t4_2 = thetadot2 * E4_11;
  const T minus_omega_dot_omega1_4_11 = t4_1 * E2_11 + t4_2 * E2_12;
  const T minus_omega_dot_omega1_4_12 = t4_1 * E2_12 - t4_2 * E2_11;
  const T minus_omega_dot_omega1_4_13 = thetadot4 * E4_11;
  const T t4_3 = thetadot2 * minus_E4_13;
  const T minus_omega_dot_omega1_4_31 = t4_3 * E2_12 - minus_omega_dot_omega1_4_13 * E2_11;
  const T omega_dot_omega1_4_32 = minus_omega_dot_omega1_4_13 * E2_12 + t4_3 * E2_11;
  // P_dot_omega1_4 = R2^T (thetadot2 q4~ b2~ - omega2~ q4~) E2 + P_dot_omega1_2: its rate
  const T t4_4 = t3_6 + t2_27;
  const T t4_5 = t3_5 + t4_4 * E2_11;
  const T t4_6 = omega2_1 * T(0.2);
  const T t4_7 = t3_12 + t4_6 * E2_11;
  const T t4_8 = thetadot2 * T(0.2) - t3_17;
  const T t4_9 = t3_16 - t4_8 * E2_12;
  const T P_dot_omega1_4_11 = R2_11 * t4_5 - minus_P_dot_omega1_2_11 - R2_21 * t4_7 + R1_31 * t4_9;
  const T t4_10 = t4_4 * E2_12 - t3_20;
  const T t4_11 = t3_22 - t4_6 * E2_12;
  const T t4_12 = t3_24 + t4_8 * E2_11;
  const T P_dot_omega1_4_12 = R2_11 * t4_10 - minus_P_dot_omega1_2_12 + R2_21 * t4_11 + R1_31 * t4_12;
  const T t4_13 = t2_27 + t3_10;
  const T t4_14 = R1_31 * t4_13 - (t3_28 + t2_25);
  const T P_dot_omega1_4_13 = t4_14 - minus_P_dot_omega1_2_13;
  const T P_dot_omega1_4_21 = R2_12 * t4_5 - minus_P_dot_omega1_2_21 - R2_22 * t4_7 + R1_32 * t4_9;
  const T P_dot_omega1_4_22 = R2_12 * t4_10 - minus_P_dot_omega1_2_22 + R2_22 * t4_11 + R1_32 * t4_12;
  const T t4_15 = R1_32 * t4_13 - (t3_31 + t2_30);
  const T P_dot_omega1_4_23 = t4_15 - minus_P_dot_omega1_2_23;
  const T P_dot_omega1_4_31 = R2_13 * t4_5 - minus_P_dot_omega1_2_31 - R2_23 * t4_7 + R1_33 * t4_9;
  const T P_dot_omega1_4_32 = R2_13 * t4_10 - minus_P_dot_omega1_2_32 + R2_23 * t4_11 + R1_33 * t4_12;
  const T t4_16 = R1_33 * t4_13 - (t3_33 + t2_32);
  const T P_dot_omega1_4_33 = t4_16 - minus_P_dot_omega1_2_33;
  // B7_1 = -R4^T omega4~ r4~ omega_omega1_4 - R4^T r4~ omega_dot_omega1_4 + P_dot_omega1_4
  const T t4_17 = T(0.05) * omega_omega1_4_11 - T(0.1) * omega_omega1_4_31;
  const T t4_18 = t2_10 + T(0.2) * omega_omega1_4_11;
  const T t4_19 = omega4_3 * t4_17 + omega4_2 * t4_18;
  const T t4_20 = t2_13 + T(0.2) * omega_omega1_4_31;
  const T t4_21 = omega4_3 * t4_20 + omega4_1 * t4_18;
  const T t4_22 = omega4_1 * t4_17 - omega4_2 * t4_20;
  const T t4_23 = t3_52 - T(0.2) * minus_omega_dot_omega1_4_31;
  const T t4_24 = T(0.1) * minus_omega_dot_omega1_4_31 - T(0.05) * minus_omega_dot_omega1_4_11;
  const T t4_25 = T(0.2) * minus_omega_dot_omega1_4_11 - T(0.1) * omega_dot_omega1_3_12;
  const T B7_1_11 = P_dot_omega1_4_11 + R4_11 * t4_19 - R2_21 * t4_21 - R4_31 * t4_22 - R4_11 * t4_23 - R2_21 * t4_24
      - R4_31 * t4_25;
  const T t4_26 = t2_17 - T(0.2) * omega_omega1_4_12;
  const T t4_27 = T(0.05) * omega_omega1_4_12 - T(0.1) * omega_omega1_4_32;
  const T t4_28 = omega4_2 * t4_26 - omega4_3 * t4_27;
  const T t4_29 = T(0.2) * omega_omega1_4_32 - t2_7;
  const T t4_30 = omega4_3 * t4_29 - omega4_1 * t4_26;
  const T t4_31 = omega4_1 * t4_27 - omega4_2 * t4_29;
  const T t4_32 = t3_42 + T(0.2) * omega_dot_omega1_4_32;
  const T t4_33 = T(0.1) * omega_dot_omega1_4_32 + T(0.05) * minus_omega_dot_omega1_4_12;
  const T t4_34 = T(0.2) * minus_omega_dot_omega1_4_12 - T(0.1) * minus_omega_dot_omega1_3_11;
  const T B7_1_12 = P_dot_omega1_4_12 - R4_11 * t4_28 - R2_21 * t4_30 - R4_31 * t4_31 - R4_11 * t4_32 + R2_21 * t4_33
      - R4_31 * t4_34;
  const T t4_35 = T(0.05) * minus_E4_13 + T(0.1) * E4_11;
  const T t4_36 = T(0.2) * minus_E4_13;
  const T t4_37 = omega4_3 * t4_35 + omega4_2 * t4_36;
  const T t4_38 = T(0.2) * E4_11;
  const T t4_39 = omega4_3 * t4_38 - omega4_1 * t4_36;
  const T t4_40 = omega4_1 * t4_35 + omega4_2 * t4_38;
  const T t4_41 = T(0.1) * t4_1 - T(0.05) * minus_omega_dot_omega1_4_13;
  const T t4_42 = T(0.2) * t4_1;
  const T t4_43 = T(0.2) * minus_omega_dot_omega1_4_13;
  const T t4_44 = R4_11 * t4_37 + R2_21 * t4_39 - R4_31 * t4_40 + R2_21 * t4_41 - R4_11 * t4_42 + R4_31 * t4_43;
  const T B7_1_13 = P_dot_omega1_4_13 - t4_44;
  const T B7_1_21 = P_dot_omega1_4_21 + R4_12 * t4_19 - R2_22 * t4_21 - R4_32 * t4_22 - R4_12 * t4_23 - R2_22 * t4_24
      - R4_32 * t4_25;
  const T B7_1_22 = P_dot_omega1_4_22 - R4_12 * t4_28 - R2_22 * t4_30 - R4_32 * t4_31 - R4_12 * t4_32 + R2_22 * t4_33
      - R4_32 * t4_34;
  const T t4_45 = R4_12 * t4_37 + R2_22 * t4_39 - R4_32 * t4_40 + R2_22 * t4_41 - R4_12 * t4_42 + R4_32 * t4_43;
  const T B7_1_23 = P_dot_omega1_4_23 - t4_45;
  const T B7_1_31 = P_dot_omega1_4_31 + R4_13 * t4_19 - R2_23 * t4_21 - R4_33 * t4_22 - R4_13 * t4_23 - R2_23 * t4_24
      - R4_33 * t4_25;
  const T B7_1_32 = P_dot_omega1_4_32 - R4_13 * t4_28 - R2_23 * t4_30 - R4_33 * t4_31 - R4_13 * t4_32 + R2_23 * t4_33
      - R4_33 * t4_34;
  const T t4_46 = R4_13 * t4_37 + R2_23 * t4_39 - R4_33 * t4_40 + R2_23 * t4_41 - R4_13 * t4_42 + R4_33 * t4_43;
  const T B7_1_33 = P_dot_omega1_4_33 - t4_46;
  v_y_dot[99] = B7_1_11;
  v_y_dot[100] = B7_1_12;
  v_y_dot[101] = B7_1_13;
  v_y_dot[110] = B7_1_21;
  v_y_dot[111] = B7_1_22;
  v_y_dot[112] = B7_1_23;
  v_y_dot[121] = B7_1_31;
  v_y_dot[122] = B7_1_32;
  v_y_dot[123] = B7_1_33;
  // B8_2 = -R4^T omega4~ r4~ omega_thetadot2_4 - R4^T r4~ omega_dot_thetadot2_4 + P_dot_thetadot2_4
  const T minus_B8_2_1 = t4_44 - t4_14;
  const T minus_B8_2_2 = t4_45 - t4_15;
  const T minus_B8_2_3 = t4_46 - t4_16;
  v_y_dot[102] = -minus_B8_2_1;
  v_y_dot[113] = -minus_B8_2_2;
  v_y_dot[124] = -minus_B8_2_3;
  // B9_4 = -R4^T omega4~ r4~ b4
  const T t4_47 = omega4_2 * T(0.1);
  const T t4_48 = omega4_3 * T(0.05) + omega4_1 * T(0.1);
  const T t4_49 = omega4_2 * T(0.05);
  const T minus_B9_4_1 = R4_11 * t4_47 - R2_21 * t4_48 + R4_31 * t4_49;
  const T minus_B9_4_2 = R4_12 * t4_47 - R2_22 * t4_48 + R4_32 * t4_49;
  const T minus_B9_4_3 = R4_13 * t4_47 - R2_23 * t4_48 + R4_33 * t4_49;
  v_y_dot[104] = -minus_B9_4_1;
  v_y_dot[115] = -minus_B9_4_2;
  v_y_dot[126] = -minus_B9_4_3;

  // ---- body 5 (body_5) on body 1
  const T thetadot5 = y[6];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[7];
  const T E5_12 = sines[7];
  // R5^T = R1^T E5^T: R takes inertial components to body components
  const T R5_11 = R1_11 * E5_11 + R1_21 * E5_12;
  const T R5_12 = R1_12 * E5_11 + R1_22 * E5_12;
  const T R5_13 = R1_13 * E5_11 + R1_23 * E5_12;
  const T R5_21 = R1_21 * E5_11 - R1_11 * E5_12;
  const T R5_22 = R1_22 * E5_11 - R1_12 * E5_12;
  const T R5_23 = R1_23 * E5_11 - R1_13 * E5_12;
  // omega5 = thetadot5 b5 + E5 omega1: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega1_1 + E5_12 * omega1_2;
  const T omega5_2 = E5_11 * omega1_2 - E5_12 * omega1_1;
  const T omega5_3 = thetadot5 + omega1_3;
  // P_dot_omega1_5 = -R1^T omega1~ q5~: its rate
  const T minus_P_dot_omega1_5_11 = t1_17 - t1_14 * T(0.25);
  const T minus_P_dot_omega1_5_13 = t1_16 * T(0.25) - t2_2;
  const T minus_P_dot_omega1_5_21 = t1_22 - t1_19 * T(0.25);
  const T minus_P_dot_omega1_5_23 = t1_21 * T(0.25) - t2_4;
  const T minus_P_dot_omega1_5_31 = t1_27 - t1_24 * T(0.25);
  const T minus_P_dot_omega1_5_33 = t1_26 * T(0.25) - t2_6;
  // B10_1 = thetadot5 R5^T r5~ b5~ E5 - R5^T omega5~ r5~ E5 + P_dot_omega1_5
  const T t5_1 = T(0.05) * E5_11;
  const T t5_2 = omega5_3 * t5_1;
  const T t5_3 = T(0.2) * E5_11;
  const T t5_4 = t5_3 + T(0.1) * E5_12;
  const T t5_5 = t5_2 + omega5_2 * t5_4;
  const T t5_6 = T(0.05) * E5_12;
  const T t5_7 = omega5_3 * t5_6;
  const T t5_8 = t5_7 + omega5_1 * t5_4;
  const T t5_9 = omega5_1 * t5_1 - omega5_2 * t5_6;
  const T t5_10 = T(0.2) * E5_12;
  const T t5_11 = T(0.1) * E5_11 - t5_10;
  const T B10_1_11 = R5_11 * t5_5 - minus_P_dot_omega1_5_11 - R5_21 * t5_8 - R1_31 * t5_9 + thetadot5 * (R5_21 * t5_6
      - R5_11 * t5_1 + R1_31 * t5_11);
  const T t5_12 = omega5_2 * t5_11 - t5_7;
  const T t5_13 = t5_2 + omega5_1 * t5_11;
  const T t5_14 = omega5_1 * t5_6 + omega5_2 * t5_1;
  const T minus_B10_1_12 = minus_P_dot_omega1_2_12 + thetadot5 * (R5_11 * t5_6 + R5_21 * t5_1 - R1_31 * t5_4) + R5_11
      * t5_12 - R5_21 * t5_13 + R1_31 * t5_14;
  const T t5_15 = omega5_3 * T(0.1);
  const T t5_16 = omega5_3 * T(0.2);
  const T t5_17 = omega5_1 * T(0.1);
  const T t5_18 = t5_17 + omega5_2 * T(0.2);
  const T t5_19 = R5_11 * t5_15 + R5_21 * t5_16 - R1_31 * t5_18;
  const T minus_B10_1_13 = t5_19 + minus_P_dot_omega1_5_13;
  const T B10_1_21 = R5_12 * t5_5 - minus_P_dot_omega1_5_21 - R5_22 * t5_8 - R1_32 * t5_9 + thetadot5 * (R5_22 * t5_6
      - R5_12 * t5_1 + R1_32 * t5_11);
  const T minus_B10_1_22 = minus_P_dot_omega1_2_22 + thetadot5 * (R5_12 * t5_6 + R5_22 * t5_1 - R1_32 * t5_4) + R5_12
      * t5_12 - R5_22 * t5_13 + R1_32 * t5_14;
  const T t5_20 = R5_12 * t5_15 + R5_22 * t5_16 - R1_32 * t5_18;
  const T minus_B10_1_23 = t5_20 + minus_P_dot_omega1_5_23;
  const T B10_1_31 = R5_13 * t5_5 - minus_P_dot_omega1_5_31 - R5_23 * t5_8 - R1_33 * t5_9 + thetadot5 * (R5_23 * t5_6
      - R5_13 * t5_1 + R1_33 * t5_11);
  const T minus_B10_1_32 = minus_P_dot_omega1_2_32 + thetadot5 * (R5_13 * t5_6 + R5_23 * t5_1 - R1_33 * t5_4) + R5_13
      * t5_12 - R5_23 * t5_13 + R1_33 * t5_14;
  const T t5_21 = R5_13 * t5_15 + R5_23 * t5_16 - R1_33 * t5_18;
  const T minus_B10_1_33 = t5_21 + minus_P_dot_omega1_5_33;
  v_y_dot[132] = B10_1_11;
  v_y_dot[133] = -minus_B10_1_12;
  v_y_dot[134] = -minus_B10_1_13;
  v_y_dot[143] = B10_1_21;
  v_y_dot[144] = -minus_B10_1_22;
  v_y_dot[145] = -minus_B10_1_23;
  v_y_dot[154] = B10_1_31;
  v_y_dot[155] = -minus_B10_1_32;
  v_y_dot[156] = -minus_B10_1_33;
  v_y_dot[138] = -t5_19;
  v_y_dot[149] = -t5_20;
  v_y_dot[160] = -t5_21;

  // ---- body 6 (body_6) on body 5
  const T thetadot6 = y[7];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[8];
  const T E6_23 = sines[8];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_21 = R5_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R5_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R5_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R5_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R5_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R5_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega5_1;
  const T omega6_2 = E6_22 * omega5_2 + E6_23 * omega5_3;
  const T omega6_3 = E6_22 * omega5_3 - E6_23 * omega5_2;
  // omega_omega1_6 = E6 E5: partial angular velocity, body axes
  const T minus_omega_omega1_6_21 = E6_22 * E5_12;
  const T omega_omega1_6_22 = E6_22 * E5_11;
  const T omega_omega1_6_31 = E6_23 * E5_12;
  const T minus_omega_omega1_6_32 = E6_23 * E5_11;
  // omega_dot_omega1_6 = -(thetadot5 E6 b5~ + thetadot6 b6~ E6) E5: its rate
  const T minus_omega_dot_omega1_6_11 = thetadot5 * E5_12;
  const T omega_dot_omega1_6_12 = thetadot5 * E5_11;
  const T t6_1 = thetadot5 * E6_22;
  const T t6_2 = thetadot6 * E6_23;
  const T minus_omega_dot_omega1_6_21 = t6_1 * E5_11 - t6_2 * E5_12;
  const T minus_omega_dot_omega1_6_22 = t6_1 * E5_12 + t6_2 * E5_11;
  const T omega_dot_omega1_6_23 = thetadot6 * E6_22;
  const T t6_3 = thetadot5 * E6_23;
  const T omega_dot_omega1_6_31 = t6_3 * E5_11 + omega_dot_omega1_6_23 * E5_12;
  const T minus_omega_dot_omega1_6_32 = omega_dot_omega1_6_23 * E5_11 - t6_3 * E5_12;
  // P_dot_omega1_6 = R5^T (thetadot5 q6~ b5~ - omega5~ q6~) E5 + P_dot_omega1_5: its rate
  const T t6_4 = t5_15 - thetadot5 * T(0.1);
  const T t6_5 = omega5_2 * T(0.3);
  const T t6_6 = t6_4 + t6_5;
  const T t6_7 = t6_6 * E5_11 + t6_5 * E5_12;
  const T t6_8 = omega5_1 * T(0.3);
  const T t6_9 = t6_4 + t6_8;
  const T t6_10 = t6_8 * E5_11 + t6_9 * E5_12;
  const T t6_11 = thetadot5 * T(0.3);
  const T t6_12 = t6_11 - t5_17;
  const T t6_13 = t6_11 - omega5_2 * T(0.1);
  const T t6_14 = t6_12 * E5_11 - t6_13 * E5_12;
  const T P_dot_omega1_6_11 = R5_11 * t6_7 - minus_P_dot_omega1_5_11 - R5_21 * t6_10 + R1_31 * t6_14;
  const T t6_15 = t6_6 * E5_12 - t6_5 * E5_11;
  const T t6_16 = t6_9 * E5_11 - t6_8 * E5_12;
  const T t6_17 = t6_12 * E5_12 + t6_13 * E5_11;
  const T P_dot_omega1_6_12 = R5_11 * t6_15 - minus_P_dot_omega1_2_12 + R5_21 * t6_16 + R1_31 * t6_17;
  const T t6_18 = t6_5 + t6_8;
  const T t6_19 = omega5_3 * T(0.3);
  const T t6_20 = R1_31 * t6_18 - (R5_11 * t6_19 + R5_21 * t6_19);
  const T P_dot_omega1_6_13 = t6_20 - minus_P_dot_omega1_5_13;
  const T P_dot_omega1_6_21 = R5_12 * t6_7 - minus_P_dot_omega1_5_21 - R5_22 * t6_10 + R1_32 * t6_14;
  const T P_dot_omega1_6_22 = R5_12 * t6_15 - minus_P_dot_omega1_2_22 + R5_22 * t6_16 + R1_32 * t6_17;
  const T t6_21 = R1_32 * t6_18 - (R5_12 * t6_19 + R5_22 * t6_19);
  const T P_dot_omega1_6_23 = t6_21 - minus_P_dot_omega1_5_23;
  const T P_dot_omega1_6_31 = R5_13 * t6_7 - minus_P_dot_omega1_5_31 - R5_23 * t6_10 + R1_33 * t6_14;
  const T P_dot_omega1_6_32 = R5_13 * t6_15 - minus_P_dot_omega1_2_32 + R5_23 * t6_16 + R1_33 * t6_17;
  const T t6_22 = R1_33 * t6_18 - (R5_13 * t6_19 + R5_23 * t6_19);
  const T P_dot_omega1_6_33 = t6_22 - minus_P_dot_omega1_5_33;
  // B12_1 = -R6^T omega6~ r6~ omega_omega1_6 - R6^T r6~ omega_dot_omega1_6 + P_dot_omega1_6
  const T t6_23 = t5_1 - T(0.1) * omega_omega1_6_31;
  const T t6_24 = t5_3 + T(0.1) * minus_omega_omega1_6_21;
  const T t6_25 = omega6_3 * t6_23 + omega6_2 * t6_24;
  const T t6_26 = T(0.05) * minus_omega_omega1_6_21 + T(0.2) * omega_omega1_6_31;
  const T t6_27 = omega6_3 * t6_26 + omega6_1 * t6_24;
  const T t6_28 = omega6_1 * t6_23 - omega6_2 * t6_26;
  const T t6_29 = T(0.05) * minus_omega_dot_omega1_6_21 + T(0.2) * omega_dot_omega1_6_31;
  const T t6_30 = T(0.1) * omega_dot_omega1_6_31 + T(0.05) * minus_omega_dot_omega1_6_11;
  const T t6_31 = T(0.2) * minus_omega_dot_omega1_6_11 - T(0.1) * minus_omega_dot_omega1_6_21;
  const T B12_1_11 = P_dot_omega1_6_11 + R5_11 * t6_25 - R6_21 * t6_27 - R6_31 * t6_28 - R5_11 * t6_29 + R6_21 * t6_30
      - R6_31 * t6_31;
  const T t6_32 = T(0.05) * omega_omega1_6_22 + T(0.2) * minus_omega_omega1_6_32;
  const T t6_33 = T(0.1) * omega_omega1_6_22 - t5_10;
  const T t6_34 = omega6_3 * t6_32 + omega6_1 * t6_33;
  const T t6_35 = t5_6 + T(0.1) * minus_omega_omega1_6_32;
  const T t6_36 = omega6_2 * t6_33 - omega6_3 * t6_35;
  const T t6_37 = omega6_1 * t6_35 + omega6_2 * t6_32;
  const T t6_38 = T(0.05) * minus_omega_dot_omega1_6_22 - T(0.2) * minus_omega_dot_omega1_6_32;
  const T t6_39 = T(0.1) * minus_omega_dot_omega1_6_32 + T(0.05) * omega_dot_omega1_6_12;
  const T t6_40 = T(0.2) * omega_dot_omega1_6_12 + T(0.1) * minus_omega_dot_omega1_6_22;
  const T B12_1_12 = P_dot_omega1_6_12 + R6_21 * t6_34 - R5_11 * t6_36 - R6_31 * t6_37 - R5_11 * t6_38 - R6_21 * t6_39
      + R6_31 * t6_40;
  const T t6_41 = T(0.1) * E6_22;
  const T t6_42 = T(0.1) * E6_23;
  const T t6_43 = omega6_3 * t6_41 + omega6_2 * t6_42;
  const T t6_44 = T(0.2) * E6_22 - T(0.05) * E6_23;
  const T t6_45 = omega6_3 * t6_44 - omega6_1 * t6_42;
  const T t6_46 = omega6_1 * t6_41 + omega6_2 * t6_44;
  const T t6_47 = T(0.1) * t6_2;
  const T t6_48 = T(0.05) * omega_dot_omega1_6_23 + T(0.2) * t6_2;
  const T t6_49 = T(0.1) * omega_dot_omega1_6_23;
  const T t6_50 = R5_11 * t6_43 + R6_21 * t6_45 - R6_31 * t6_46 + R6_21 * t6_47 - R5_11 * t6_48 + R6_31 * t6_49;
  const T B12_1_13 = P_dot_omega1_6_13 - t6_50;
  const T B12_1_21 = P_dot_omega1_6_21 + R5_12 * t6_25 - R6_22 * t6_27 - R6_32 * t6_28 - R5_12 * t6_29 + R6_22 * t6_30
      - R6_32 * t6_31;
  const T B12_1_22 = P_dot_omega1_6_22 + R6_22 * t6_34 - R5_12 * t6_36 - R6_32 * t6_37 - R5_12 * t6_38 - R6_22 * t6_39
      + R6_32 * t6_40;
  const T t6_51 = R5_12 * t6_43 + R6_22 * t6_45 - R6_32 * t6_46 + R6_22 * t6_47 - R5_12 * t6_48 + R6_32 * t6_49;
  const T B12_1_23 = P_dot_omega1_6_23 - t6_51;
  const T B12_1_31 = P_dot_omega1_6_31 + R5_13 * t6_25 - R6_23 * t6_27 - R6_33 * t6_28 - R5_13 * t6_29 + R6_23 * t6_30
      - R6_33 * t6_31;
  const T B12_1_32 = P_dot_omega1_6_32 + R6_23 * t6_34 - R5_13 * t6_36 - R6_33 * t6_37 - R5_13 * t6_38 - R6_23 * t6_39
      + R6_33 * t6_40;
  const T t6_52 = R5_13 * t6_43 + R6_23 * t6_45 - R6_33 * t6_46 + R6_23 * t6_47 - R5_13 * t6_48 + R6_33 * t6_49;
  const T B12_1_33 = P_dot_omega1_6_33 - t6_52;
  v_y_dot[165] = B12_1_11;
  v_y_dot[166] = B12_1_12;
  v_y_dot[167] = B12_1_13;
  v_y_dot[176] = B12_1_21;
  v_y_dot[177] = B12_1_22;
  v_y_dot[178] = B12_1_23;
  v_y_dot[187] = B12_1_31;
  v_y_dot[188] = B12_1_32;
  v_y_dot[189] = B12_1_33;
  // B13_5 = -R6^T omega6~ r6~ omega_thetadot5_6 - R6^T r6~ omega_dot_thetadot5_6 + P_dot_thetadot5_6
  const T minus_B13_5_1 = t6_50 - t6_20;
  const T minus_B13_5_2 = t6_51 - t6_21;
  const T minus_B13_5_3 = t6_52 - t6_22;
  v_y_dot[171] = -minus_B13_5_1;
  v_y_dot[182] = -minus_B13_5_2;
  v_y_dot[193] = -minus_B13_5_3;
  // B14_6 = -R6^T omega6~ r6~ b6
  const T t6_53 = omega6_1 * T(0.2);
  const T t6_54 = omega6_3 * T(0.05) + omega6_2 * T(0.2);
  const T t6_55 = omega6_1 * T(0.05);
  const T minus_B14_6_1 = R6_21 * t6_53 - R5_11 * t6_54 + R6_31 * t6_55;
  const T minus_B14_6_2 = R6_22 * t6_53 - R5_12 * t6_54 + R6_32 * t6_55;
  const T minus_B14_6_3 = R6_23 * t6_53 - R5_13 * t6_54 + R6_33 * t6_55;
  v_y_dot[172] = -minus_B14_6_1;
  v_y_dot[183] = -minus_B14_6_2;
  v_y_dot[194] = -minus_B14_6_3;
}

}  // namespace kanec::bench_s6r
