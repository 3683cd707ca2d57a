// SPDX-License-Identifier: BSD-3-Clause
// bench_cr16: equations of motion of 16 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 1c7a5a2c104f0949 of bench_cr16/scene.toml; functions kinematics energy accelerations residual mass_matrix
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
// its own or by conversion cos, sin. Cosines and sines of angles in double are those of cos_sin() below, with
// KANEC_LIBM_COS_SIN the library's.
//
// operations of one call (adds + multiplies + divides):
//   kinematics              0 (0 add, 0 multiply)
//   energy                  1749 (757 add, 992 multiply, 32 sine or cosine)
//   accelerations           4302 (2086 add, 2201 multiply, 15 divide, 32 sine or cosine)
//   residual                1825 (902 add, 923 multiply, 32 sine or cosine)
//   mass_matrix             2467 (1080 add, 1387 multiply, 30 sine or cosine)
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

namespace kanec::bench_cr16 {

inline constexpr int n_bodies = 16;
inline constexpr int nx = 16;
inline constexpr int ny = 16;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 16;
inline constexpr char model_hash[] = "1c7a5a2c104f0949";

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
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
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
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 16, cosines, sines);

  // ---- body 1 (body_1) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T t1_1 = E1_11 * T(0.05);
  const T p1_3 = t1_1 - minus_E1_13 * T(0.1);
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_2 = thetadot1 * T(0.05);
  const T t1_3 = thetadot1 * T(0.1);
  const T t1_4 = minus_E1_13 * t1_3;
  const T v1_1 = E1_11 * t1_2 - t1_4;
  const T t1_5 = E1_11 * t1_3;
  const T minus_v1_3 = t1_5 + minus_E1_13 * t1_2;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.132) * thetadot1 * thetadot1 * T(0.5) + T(0.55) * (v1_1 * v1_1 + minus_v1_3 * minus_v1_3);

  // ---- body 2 (body_2) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T E2_12 = sines[1];
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
  const T p2_3 = t1_1 - t2_2 + P2_3 + R2_23 * T(0.2);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_3 = thetadot1 * T(0.3);
  const T Pdot2_1 = t1_5 - minus_E1_13 * t2_3;
  const T minus_Pdot2_3 = t1_4 + E1_11 * t2_3;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_4 = omega2_2 * T(0.05) - thetadot2 * T(0.2);
  const T t2_5 = thetadot2 * T(0.1) - omega2_1 * T(0.05);
  const T t2_6 = omega2_2 * T(0.1);
  const T t2_7 = omega2_1 * T(0.2) - t2_6;
  const T v2_1 = Pdot2_1 + R2_11 * t2_4 - minus_R2_21 * t2_5 + minus_E1_13 * t2_7;
  const T v2_2 = E2_12 * t2_4 + E2_11 * t2_5;
  const T v2_3 = R2_23 * t2_5 - minus_Pdot2_3 - minus_R2_13 * t2_4 + E1_11 * t2_7;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (omega2_1 * (T(0.12) * omega2_1 + T(0.006) * omega2_2 + T(0.0036) * thetadot2) + omega2_2 *
      (T(0.006) * omega2_1 + T(0.144) * omega2_2 - T(0.0048) * thetadot2) + thetadot2 * (T(0.0036) * omega2_1 -
      T(0.0048) * omega2_2 + T(0.096) * thetadot2)) + T(0.6) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (body_3) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[2];
  const T E3_23 = sines[2];
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
  const T P3_3 = t2_1 - t3_1 + P2_3 + R2_23 * T(0.15);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T t3_2 = R3_23 * T(0.2);
  const T t3_3 = t3_2 + P3_3;
  const T p3_3 = t3_3 - t2_2 + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_4 = t2_6 - thetadot2 * T(0.15);
  const T t3_5 = thetadot2 * T(0.3) - omega2_1 * T(0.1);
  const T t3_6 = omega2_1 * T(0.15) - omega2_2 * T(0.3);
  const T Pdot3_1 = Pdot2_1 + R2_11 * t3_4 - minus_R2_21 * t3_5 + minus_E1_13 * t3_6;
  const T Pdot3_2 = E2_12 * t3_4 + E2_11 * t3_5;
  const T Pdot3_3 = R2_23 * t3_5 - minus_Pdot2_3 - minus_R2_13 * t3_4 + E1_11 * t3_6;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_7 = omega3_3 * T(0.2);
  const T t3_8 = omega3_2 * T(0.05) - t3_7;
  const T t3_9 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_10 = omega3_1 * T(0.2);
  const T t3_11 = omega3_2 * T(0.1);
  const T t3_12 = t3_10 - t3_11;
  const T v3_1 = Pdot3_1 + R2_11 * t3_8 + R3_21 * t3_9 + R3_31 * t3_12;
  const T v3_2 = Pdot3_2 + E2_12 * t3_8 + R3_22 * t3_9 - minus_R3_32 * t3_12;
  const T v3_3 = Pdot3_3 + R3_23 * t3_9 - minus_R2_13 * t3_8 + R3_33 * t3_12;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (omega3_1 * (T(0.13) * omega3_1 + T(0.0065) * omega3_2 + T(0.0039) * omega3_3) + omega3_2 *
      (T(0.0065) * omega3_1 + T(0.156) * omega3_2 - T(0.0052) * omega3_3) + omega3_3 * (T(0.0039) * omega3_1 -
      T(0.0052) * omega3_2 + T(0.104) * omega3_3)) + T(0.65) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (body_4) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T minus_E4_13 = sines[3];
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
  const T p4_3 = t3_2 + t4_1 + P4_3 - minus_R4_13 * T(0.1);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_2 = t3_11 - t3_7;
  const T t4_3 = omega3_3 * T(0.3) - omega3_1 * T(0.1);
  const T t4_4 = t3_10 - omega3_2 * T(0.3);
  const T Pdot4_1 = Pdot3_1 + R2_11 * t4_2 + R3_21 * t4_3 + R3_31 * t4_4;
  const T Pdot4_2 = Pdot3_2 + E2_12 * t4_2 + R3_22 * t4_3 - minus_R3_32 * t4_4;
  const T Pdot4_3 = Pdot3_3 + R3_23 * t4_3 - minus_R2_13 * t4_2 + R3_33 * t4_4;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_5 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_6 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_7 = omega4_2 * T(0.1);
  const T t4_8 = omega4_1 * T(0.2) - t4_7;
  const T v4_1 = Pdot4_1 + R4_11 * t4_5 + R3_21 * t4_6 + R4_31 * t4_8;
  const T v4_2 = Pdot4_2 + R4_12 * t4_5 + R3_22 * t4_6 + R4_32 * t4_8;
  const T v4_3 = Pdot4_3 + R3_23 * t4_6 - minus_R4_13 * t4_5 + R4_33 * t4_8;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (omega4_1 * (T(0.14) * omega4_1 + T(0.007) * omega4_2 + T(0.0042) * omega4_3) + omega4_2 *
      (T(0.007) * omega4_1 + T(0.168) * omega4_2 - T(0.0056) * omega4_3) + omega4_3 * (T(0.0042) * omega4_1 -
      T(0.0056) * omega4_2 + T(0.112) * omega4_3)) + T(0.7) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (body_5) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 + R3_21 * E5_12;
  const T R5_12 = R4_12 * E5_11 + R3_22 * E5_12;
  const T R5_13 = R3_23 * E5_12 - minus_R4_13 * E5_11;
  const T R5_21 = R3_21 * E5_11 - R4_11 * E5_12;
  const T R5_22 = R3_22 * E5_11 - R4_12 * E5_12;
  const T R5_23 = R3_23 * E5_11 + minus_R4_13 * E5_12;
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 + E5_12 * omega4_2;
  const T omega5_2 = E5_11 * omega4_2 - E5_12 * omega4_1;
  const T omega5_3 = thetadot5 + omega4_3;
  // P5 = R4^T q5 + P4: position of the body origin, inertial axes [m]
  const T t5_1 = R4_33 * T(0.1);
  const T P5_3 = t5_1 + P4_3 + R3_23 * T(0.25) - minus_R4_13 * T(0.3);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T t5_2 = R5_13 * T(0.1);
  const T p5_3 = t5_2 + t4_1 + P5_3 + R5_23 * T(0.2);
  // Pdot5 = R4^T omega4~ q5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t5_3 = t4_7 - omega4_3 * T(0.25);
  const T t5_4 = omega4_3 * T(0.3) - omega4_1 * T(0.1);
  const T t5_5 = omega4_1 * T(0.25) - omega4_2 * T(0.3);
  const T Pdot5_1 = Pdot4_1 + R4_11 * t5_3 + R3_21 * t5_4 + R4_31 * t5_5;
  const T Pdot5_2 = Pdot4_2 + R4_12 * t5_3 + R3_22 * t5_4 + R4_32 * t5_5;
  const T Pdot5_3 = Pdot4_3 + R3_23 * t5_4 - minus_R4_13 * t5_3 + R4_33 * t5_5;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_6 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_7 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_8 = omega5_2 * T(0.1);
  const T t5_9 = omega5_1 * T(0.2) - t5_8;
  const T v5_1 = Pdot5_1 + R5_11 * t5_6 + R5_21 * t5_7 + R4_31 * t5_9;
  const T v5_2 = Pdot5_2 + R5_12 * t5_6 + R5_22 * t5_7 + R4_32 * t5_9;
  const T v5_3 = Pdot5_3 + R5_13 * t5_6 + R5_23 * t5_7 + R4_33 * t5_9;
  // T5 = 1/2 omega5 . (I5 omega5) + 1/2 m5 v5 . v5: kinetic energy [J]
  const T T5 = T(0.5) * (omega5_1 * (T(0.15) * omega5_1 + T(0.0075) * omega5_2 + T(0.0045) * omega5_3) + omega5_2 *
      (T(0.0075) * omega5_1 + T(0.18) * omega5_2 - T(0.006) * omega5_3) + omega5_3 * (T(0.0045) * omega5_1 - T(0.006)
      * omega5_2 + T(0.12) * omega5_3)) + T(0.75) * (v5_1 * v5_1 + v5_2 * v5_2 + v5_3 * v5_3);

  // ---- body 6 (body_6) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[5];
  const T E6_23 = sines[5];
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
  const T P6_3 = t6_1 + t5_1 + P5_3 + R5_23 * T(0.3);
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T t6_2 = R6_23 * T(0.2);
  const T p6_3 = t5_2 + t6_2 + P6_3 + R6_33 * T(0.05);
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_3 = omega5_3 * T(0.3);
  const T t6_4 = t5_8 - t6_3;
  const T t6_5 = t6_3 - omega5_1 * T(0.1);
  const T t6_6 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_4 + R5_21 * t6_5 + R4_31 * t6_6;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_4 + R5_22 * t6_5 + R4_32 * t6_6;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_4 + R5_23 * t6_5 + R4_33 * t6_6;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_7 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_8 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_9 = omega6_2 * T(0.1);
  const T t6_10 = omega6_1 * T(0.2) - t6_9;
  const T v6_1 = Pdot6_1 + R5_11 * t6_7 + R6_21 * t6_8 + R6_31 * t6_10;
  const T v6_2 = Pdot6_2 + R5_12 * t6_7 + R6_22 * t6_8 + R6_32 * t6_10;
  const T v6_3 = Pdot6_3 + R5_13 * t6_7 + R6_23 * t6_8 + R6_33 * t6_10;
  // T6 = 1/2 omega6 . (I6 omega6) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (omega6_1 * (T(0.16) * omega6_1 + T(0.008) * omega6_2 + T(0.0048) * omega6_3) + omega6_2 *
      (T(0.008) * omega6_1 + T(0.192) * omega6_2 - T(0.0064) * omega6_3) + omega6_3 * (T(0.0048) * omega6_1 -
      T(0.0064) * omega6_2 + T(0.128) * omega6_3)) + T(0.8) * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- body 7 (body_7) on body 6
  const T thetadot7 = y[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T minus_E7_13 = sines[6];
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
  const T P7_3 = t6_1 + P6_3 + R6_23 * T(0.35) + R6_33 * T(0.1);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T t7_1 = R7_33 * T(0.05);
  const T p7_3 = t6_2 + t7_1 + P7_3 + R7_13 * T(0.1);
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_2 = t6_9 - omega6_3 * T(0.35);
  const T t7_3 = omega6_3 * T(0.3) - omega6_1 * T(0.1);
  const T t7_4 = omega6_1 * T(0.35) - omega6_2 * T(0.3);
  const T Pdot7_1 = Pdot6_1 + R5_11 * t7_2 + R6_21 * t7_3 + R6_31 * t7_4;
  const T Pdot7_2 = Pdot6_2 + R5_12 * t7_2 + R6_22 * t7_3 + R6_32 * t7_4;
  const T Pdot7_3 = Pdot6_3 + R5_13 * t7_2 + R6_23 * t7_3 + R6_33 * t7_4;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_5 = omega7_2 * T(0.05) - omega7_3 * T(0.2);
  const T t7_6 = omega7_3 * T(0.1) - omega7_1 * T(0.05);
  const T t7_7 = omega7_2 * T(0.1);
  const T t7_8 = omega7_1 * T(0.2) - t7_7;
  const T v7_1 = Pdot7_1 + R7_11 * t7_5 + R6_21 * t7_6 + R7_31 * t7_8;
  const T v7_2 = Pdot7_2 + R7_12 * t7_5 + R6_22 * t7_6 + R7_32 * t7_8;
  const T v7_3 = Pdot7_3 + R7_13 * t7_5 + R6_23 * t7_6 + R7_33 * t7_8;
  // T7 = 1/2 omega7 . (I7 omega7) + 1/2 m7 v7 . v7: kinetic energy [J]
  const T T7 = T(0.5) * (omega7_1 * (T(0.17) * omega7_1 + T(0.0085) * omega7_2 + T(0.0051) * omega7_3) + omega7_2 *
      (T(0.0085) * omega7_1 + T(0.204) * omega7_2 - T(0.0068) * omega7_3) + omega7_3 * (T(0.0051) * omega7_1 -
      T(0.0068) * omega7_2 + T(0.136) * omega7_3)) + T(0.85) * (v7_1 * v7_1 + v7_2 * v7_2 + v7_3 * v7_3);

  // ---- body 8 (body_8) on body 7
  const T thetadot8 = y[7];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[7];
  const T E8_12 = sines[7];
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
  const T P8_3 = t8_1 + P7_3 + R7_13 * T(0.3) + R6_23 * T(0.4);
  // p8 = R8^T r8 + P8: position of the mass centre, inertial axes [m]
  const T t8_2 = R8_13 * T(0.1);
  const T p8_3 = t8_2 + t7_1 + P8_3 + R8_23 * T(0.2);
  // Pdot8 = R7^T omega7~ q8 + Pdot7: velocity of the body origin, inertial axes [m/s]
  const T t8_3 = t7_7 - omega7_3 * T(0.4);
  const T t8_4 = omega7_3 * T(0.3) - omega7_1 * T(0.1);
  const T t8_5 = omega7_1 * T(0.4) - omega7_2 * T(0.3);
  const T Pdot8_1 = Pdot7_1 + R7_11 * t8_3 + R6_21 * t8_4 + R7_31 * t8_5;
  const T Pdot8_2 = Pdot7_2 + R7_12 * t8_3 + R6_22 * t8_4 + R7_32 * t8_5;
  const T Pdot8_3 = Pdot7_3 + R7_13 * t8_3 + R6_23 * t8_4 + R7_33 * t8_5;
  // v8 = R8^T omega8~ r8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_6 = omega8_2 * T(0.05) - omega8_3 * T(0.2);
  const T t8_7 = omega8_3 * T(0.1) - omega8_1 * T(0.05);
  const T t8_8 = omega8_2 * T(0.1);
  const T t8_9 = omega8_1 * T(0.2) - t8_8;
  const T v8_1 = Pdot8_1 + R8_11 * t8_6 + R8_21 * t8_7 + R7_31 * t8_9;
  const T v8_2 = Pdot8_2 + R8_12 * t8_6 + R8_22 * t8_7 + R7_32 * t8_9;
  const T v8_3 = Pdot8_3 + R8_13 * t8_6 + R8_23 * t8_7 + R7_33 * t8_9;
  // T8 = 1/2 omega8 . (I8 omega8) + 1/2 m8 v8 . v8: kinetic energy [J]
  const T T8 = T(0.5) * (omega8_1 * (T(0.18) * omega8_1 + T(0.009) * omega8_2 + T(0.0054) * omega8_3) + omega8_2 *
      (T(0.009) * omega8_1 + T(0.216) * omega8_2 - T(0.0072) * omega8_3) + omega8_3 * (T(0.0054) * omega8_1 -
      T(0.0072) * omega8_2 + T(0.144) * omega8_3)) + T(0.9) * (v8_1 * v8_1 + v8_2 * v8_2 + v8_3 * v8_3);

  // ---- body 9 (body_9) on body 8
  const T thetadot9 = y[8];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_22 = cosines[8];
  const T E9_23 = sines[8];
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
  const T P9_3 = t9_1 + t8_1 + P8_3 + R8_23 * T(0.45);
  // p9 = R9^T r9 + P9: position of the mass centre, inertial axes [m]
  const T t9_2 = R9_23 * T(0.2);
  const T p9_3 = t8_2 + t9_2 + P9_3 + R9_33 * T(0.05);
  // Pdot9 = R8^T omega8~ q9 + Pdot8: velocity of the body origin, inertial axes [m/s]
  const T t9_3 = t8_8 - omega8_3 * T(0.45);
  const T t9_4 = omega8_3 * T(0.3) - omega8_1 * T(0.1);
  const T t9_5 = omega8_1 * T(0.45) - omega8_2 * T(0.3);
  const T Pdot9_1 = Pdot8_1 + R8_11 * t9_3 + R8_21 * t9_4 + R7_31 * t9_5;
  const T Pdot9_2 = Pdot8_2 + R8_12 * t9_3 + R8_22 * t9_4 + R7_32 * t9_5;
  const T Pdot9_3 = Pdot8_3 + R8_13 * t9_3 + R8_23 * t9_4 + R7_33 * t9_5;
  // v9 = R9^T omega9~ r9 + Pdot9: velocity of the mass centre, inertial axes [m/s]
  const T t9_6 = omega9_2 * T(0.05) - omega9_3 * T(0.2);
  const T t9_7 = omega9_3 * T(0.1) - omega9_1 * T(0.05);
  const T t9_8 = omega9_2 * T(0.1);
  const T t9_9 = omega9_1 * T(0.2) - t9_8;
  const T v9_1 = Pdot9_1 + R8_11 * t9_6 + R9_21 * t9_7 + R9_31 * t9_9;
  const T v9_2 = Pdot9_2 + R8_12 * t9_6 + R9_22 * t9_7 + R9_32 * t9_9;
  const T v9_3 = Pdot9_3 + R8_13 * t9_6 + R9_23 * t9_7 + R9_33 * t9_9;
  // T9 = 1/2 omega9 . (I9 omega9) + 1/2 m9 v9 . v9: kinetic energy [J]
  const T T9 = T(0.5) * (omega9_1 * (T(0.19) * omega9_1 + T(0.0095) * omega9_2 + T(0.0057) * omega9_3) + omega9_2 *
      (T(0.0095) * omega9_1 + T(0.228) * omega9_2 - T(0.0076) * omega9_3) + omega9_3 * (T(0.0057) * omega9_1 -
      T(0.0076) * omega9_2 + T(0.152) * omega9_3)) + T(0.95) * (v9_1 * v9_1 + v9_2 * v9_2 + v9_3 * v9_3);

  // ---- body 10 (body_10) on body 9
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_11 = cosines[9];
  const T minus_E10_13 = sines[9];
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
  const T P10_3 = t9_1 + P9_3 + R9_23 * T(0.5) + R9_33 * T(0.1);
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T t10_1 = R10_33 * T(0.05);
  const T p10_3 = t9_2 + t10_1 + P10_3 + R10_13 * T(0.1);
  // Pdot10 = R9^T omega9~ q10 + Pdot9: velocity of the body origin, inertial axes [m/s]
  const T t10_2 = t9_8 - omega9_3 * T(0.5);
  const T t10_3 = omega9_3 * T(0.3) - omega9_1 * T(0.1);
  const T t10_4 = omega9_1 * T(0.5) - omega9_2 * T(0.3);
  const T Pdot10_1 = Pdot9_1 + R8_11 * t10_2 + R9_21 * t10_3 + R9_31 * t10_4;
  const T Pdot10_2 = Pdot9_2 + R8_12 * t10_2 + R9_22 * t10_3 + R9_32 * t10_4;
  const T Pdot10_3 = Pdot9_3 + R8_13 * t10_2 + R9_23 * t10_3 + R9_33 * t10_4;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_5 = omega10_2 * T(0.05) - omega10_3 * T(0.2);
  const T t10_6 = omega10_3 * T(0.1) - omega10_1 * T(0.05);
  const T t10_7 = T(0.2) * omega10_1;
  const T t10_8 = omega10_2 * T(0.1);
  const T t10_9 = t10_7 - t10_8;
  const T v10_1 = Pdot10_1 + R10_11 * t10_5 + R9_21 * t10_6 + R10_31 * t10_9;
  const T v10_2 = Pdot10_2 + R10_12 * t10_5 + R9_22 * t10_6 + R10_32 * t10_9;
  const T v10_3 = Pdot10_3 + R10_13 * t10_5 + R9_23 * t10_6 + R10_33 * t10_9;
  // T10 = 1/2 omega10 . (I10 omega10) + 1/2 m10 v10 . v10: kinetic energy [J]
  const T T10 = T(0.5) * (omega10_1 * (t10_7 + T(0.01) * omega10_2 + T(0.006) * omega10_3) + omega10_2 * (T(0.01) *
      omega10_1 + T(0.24) * omega10_2 - T(0.008) * omega10_3) + omega10_3 * (T(0.006) * omega10_1 - T(0.008) *
      omega10_2 + T(0.16) * omega10_3)) + v10_1 * v10_1 + v10_2 * v10_2 + v10_3 * v10_3;

  // ---- body 11 (body_11) on body 10
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[10];
  const T E11_12 = sines[10];
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
  const T P11_3 = t11_1 + P10_3 + R10_13 * T(0.3) + R9_23 * T(0.55);
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T t11_2 = R11_13 * T(0.1);
  const T p11_3 = t11_2 + t10_1 + P11_3 + R11_23 * T(0.2);
  // Pdot11 = R10^T omega10~ q11 + Pdot10: velocity of the body origin, inertial axes [m/s]
  const T t11_3 = t10_8 - omega10_3 * T(0.55);
  const T t11_4 = omega10_3 * T(0.3) - omega10_1 * T(0.1);
  const T t11_5 = omega10_1 * T(0.55) - omega10_2 * T(0.3);
  const T Pdot11_1 = Pdot10_1 + R10_11 * t11_3 + R9_21 * t11_4 + R10_31 * t11_5;
  const T Pdot11_2 = Pdot10_2 + R10_12 * t11_3 + R9_22 * t11_4 + R10_32 * t11_5;
  const T Pdot11_3 = Pdot10_3 + R10_13 * t11_3 + R9_23 * t11_4 + R10_33 * t11_5;
  // v11 = R11^T omega11~ r11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_6 = omega11_2 * T(0.05) - omega11_3 * T(0.2);
  const T t11_7 = omega11_3 * T(0.1) - omega11_1 * T(0.05);
  const T t11_8 = omega11_2 * T(0.1);
  const T t11_9 = omega11_1 * T(0.2) - t11_8;
  const T v11_1 = Pdot11_1 + R11_11 * t11_6 + R11_21 * t11_7 + R10_31 * t11_9;
  const T v11_2 = Pdot11_2 + R11_12 * t11_6 + R11_22 * t11_7 + R10_32 * t11_9;
  const T v11_3 = Pdot11_3 + R11_13 * t11_6 + R11_23 * t11_7 + R10_33 * t11_9;
  // T11 = 1/2 omega11 . (I11 omega11) + 1/2 m11 v11 . v11: kinetic energy [J]
  const T T11 = T(0.5) * (omega11_1 * (T(0.21) * omega11_1 + T(0.0105) * omega11_2 + T(0.0063) * omega11_3) +
      omega11_2 * (T(0.0105) * omega11_1 + T(0.252) * omega11_2 - T(0.0084) * omega11_3) + omega11_3 * (T(0.0063) *
      omega11_1 - T(0.0084) * omega11_2 + T(0.168) * omega11_3)) + T(1.05) * (v11_1 * v11_1 + v11_2 * v11_2 + v11_3 *
      v11_3);

  // ---- body 12 (body_12) on body 11
  const T thetadot12 = y[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_22 = cosines[11];
  const T E12_23 = sines[11];
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
  const T P12_3 = t12_1 + t11_1 + P11_3 + R11_23 * T(0.6);
  // p12 = R12^T r12 + P12: position of the mass centre, inertial axes [m]
  const T t12_2 = R12_23 * T(0.2);
  const T p12_3 = t11_2 + t12_2 + P12_3 + R12_33 * T(0.05);
  // Pdot12 = R11^T omega11~ q12 + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_3 = t11_8 - omega11_3 * T(0.6);
  const T t12_4 = omega11_3 * T(0.3) - omega11_1 * T(0.1);
  const T t12_5 = omega11_1 * T(0.6) - omega11_2 * T(0.3);
  const T Pdot12_1 = Pdot11_1 + R11_11 * t12_3 + R11_21 * t12_4 + R10_31 * t12_5;
  const T Pdot12_2 = Pdot11_2 + R11_12 * t12_3 + R11_22 * t12_4 + R10_32 * t12_5;
  const T Pdot12_3 = Pdot11_3 + R11_13 * t12_3 + R11_23 * t12_4 + R10_33 * t12_5;
  // v12 = R12^T omega12~ r12 + Pdot12: velocity of the mass centre, inertial axes [m/s]
  const T t12_6 = omega12_2 * T(0.05) - omega12_3 * T(0.2);
  const T t12_7 = omega12_3 * T(0.1) - omega12_1 * T(0.05);
  const T t12_8 = omega12_2 * T(0.1);
  const T t12_9 = omega12_1 * T(0.2) - t12_8;
  const T v12_1 = Pdot12_1 + R11_11 * t12_6 + R12_21 * t12_7 + R12_31 * t12_9;
  const T v12_2 = Pdot12_2 + R11_12 * t12_6 + R12_22 * t12_7 + R12_32 * t12_9;
  const T v12_3 = Pdot12_3 + R11_13 * t12_6 + R12_23 * t12_7 + R12_33 * t12_9;
  // T12 = 1/2 omega12 . (I12 omega12) + 1/2 m12 v12 . v12: kinetic energy [J]
  const T T12 = T(0.5) * (omega12_1 * (T(0.22) * omega12_1 + T(0.011) * omega12_2 + T(0.0066) * omega12_3) + omega12_2
      * (T(0.011) * omega12_1 + T(0.264) * omega12_2 - T(0.0088) * omega12_3) + omega12_3 * (T(0.0066) * omega12_1 -
      T(0.0088) * omega12_2 + T(0.176) * omega12_3)) + T(1.1) * (v12_1 * v12_1 + v12_2 * v12_2 + v12_3 * v12_3);

  // ---- body 13 (body_13) on body 12
  const T thetadot13 = y[12];
  // E13^T = Rot(b13, theta13): E takes components in the lower body to those in the body
  const T E13_11 = cosines[12];
  const T minus_E13_13 = sines[12];
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
  const T P13_3 = t12_1 + P12_3 + R12_23 * T(0.65) + R12_33 * T(0.1);
  // p13 = R13^T r13 + P13: position of the mass centre, inertial axes [m]
  const T t13_1 = R13_33 * T(0.05);
  const T p13_3 = t12_2 + t13_1 + P13_3 + R13_13 * T(0.1);
  // Pdot13 = R12^T omega12~ q13 + Pdot12: velocity of the body origin, inertial axes [m/s]
  const T t13_2 = t12_8 - omega12_3 * T(0.65);
  const T t13_3 = omega12_3 * T(0.3) - omega12_1 * T(0.1);
  const T t13_4 = omega12_1 * T(0.65) - omega12_2 * T(0.3);
  const T Pdot13_1 = Pdot12_1 + R11_11 * t13_2 + R12_21 * t13_3 + R12_31 * t13_4;
  const T Pdot13_2 = Pdot12_2 + R11_12 * t13_2 + R12_22 * t13_3 + R12_32 * t13_4;
  const T Pdot13_3 = Pdot12_3 + R11_13 * t13_2 + R12_23 * t13_3 + R12_33 * t13_4;
  // v13 = R13^T omega13~ r13 + Pdot13: velocity of the mass centre, inertial axes [m/s]
  const T t13_5 = omega13_2 * T(0.05) - omega13_3 * T(0.2);
  const T t13_6 = omega13_3 * T(0.1) - omega13_1 * T(0.05);
  const T t13_7 = omega13_2 * T(0.1);
  const T t13_8 = omega13_1 * T(0.2) - t13_7;
  const T v13_1 = Pdot13_1 + R13_11 * t13_5 + R12_21 * t13_6 + R13_31 * t13_8;
  const T v13_2 = Pdot13_2 + R13_12 * t13_5 + R12_22 * t13_6 + R13_32 * t13_8;
  const T v13_3 = Pdot13_3 + R13_13 * t13_5 + R12_23 * t13_6 + R13_33 * t13_8;
  // T13 = 1/2 omega13 . (I13 omega13) + 1/2 m13 v13 . v13: kinetic energy [J]
  const T T13 = T(0.5) * (omega13_1 * (T(0.23) * omega13_1 + T(0.0115) * omega13_2 + T(0.0069) * omega13_3) +
      omega13_2 * (T(0.0115) * omega13_1 + T(0.276) * omega13_2 - T(0.0092) * omega13_3) + omega13_3 * (T(0.0069) *
      omega13_1 - T(0.0092) * omega13_2 + T(0.184) * omega13_3)) + T(1.15) * (v13_1 * v13_1 + v13_2 * v13_2 + v13_3 *
      v13_3);

  // ---- body 14 (body_14) on body 13
  const T thetadot14 = y[13];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_11 = cosines[13];
  const T E14_12 = sines[13];
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
  const T P14_3 = t14_1 + P13_3 + R13_13 * T(0.3) + R12_23 * T(0.7);
  // p14 = R14^T r14 + P14: position of the mass centre, inertial axes [m]
  const T t14_2 = R14_13 * T(0.1);
  const T p14_3 = t14_2 + t13_1 + P14_3 + R14_23 * T(0.2);
  // Pdot14 = R13^T omega13~ q14 + Pdot13: velocity of the body origin, inertial axes [m/s]
  const T t14_3 = t13_7 - omega13_3 * T(0.7);
  const T t14_4 = omega13_3 * T(0.3) - omega13_1 * T(0.1);
  const T t14_5 = omega13_1 * T(0.7) - omega13_2 * T(0.3);
  const T Pdot14_1 = Pdot13_1 + R13_11 * t14_3 + R12_21 * t14_4 + R13_31 * t14_5;
  const T Pdot14_2 = Pdot13_2 + R13_12 * t14_3 + R12_22 * t14_4 + R13_32 * t14_5;
  const T Pdot14_3 = Pdot13_3 + R13_13 * t14_3 + R12_23 * t14_4 + R13_33 * t14_5;
  // v14 = R14^T omega14~ r14 + Pdot14: velocity of the mass centre, inertial axes [m/s]
  const T t14_6 = omega14_2 * T(0.05) - omega14_3 * T(0.2);
  const T t14_7 = omega14_3 * T(0.1) - omega14_1 * T(0.05);
  const T t14_8 = omega14_2 * T(0.1);
  const T t14_9 = omega14_1 * T(0.2) - t14_8;
  const T v14_1 = Pdot14_1 + R14_11 * t14_6 + R14_21 * t14_7 + R13_31 * t14_9;
  const T v14_2 = Pdot14_2 + R14_12 * t14_6 + R14_22 * t14_7 + R13_32 * t14_9;
  const T v14_3 = Pdot14_3 + R14_13 * t14_6 + R14_23 * t14_7 + R13_33 * t14_9;
  // T14 = 1/2 omega14 . (I14 omega14) + 1/2 m14 v14 . v14: kinetic energy [J]
  const T T14 = T(0.5) * (omega14_1 * (T(0.24) * omega14_1 + T(0.012) * omega14_2 + T(0.0072) * omega14_3) + omega14_2
      * (T(0.012) * omega14_1 + T(0.288) * omega14_2 - T(0.0096) * omega14_3) + omega14_3 * (T(0.0072) * omega14_1 -
      T(0.0096) * omega14_2 + T(0.192) * omega14_3)) + T(1.2) * (v14_1 * v14_1 + v14_2 * v14_2 + v14_3 * v14_3);

  // ---- body 15 (body_15) on body 14
  const T thetadot15 = y[14];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_22 = cosines[14];
  const T E15_23 = sines[14];
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
  const T P15_3 = t15_1 + t14_1 + P14_3 + R14_23 * T(0.75);
  // p15 = R15^T r15 + P15: position of the mass centre, inertial axes [m]
  const T t15_2 = R15_23 * T(0.2);
  const T p15_3 = t14_2 + t15_2 + P15_3 + R15_33 * T(0.05);
  // Pdot15 = R14^T omega14~ q15 + Pdot14: velocity of the body origin, inertial axes [m/s]
  const T t15_3 = t14_8 - omega14_3 * T(0.75);
  const T t15_4 = omega14_3 * T(0.3) - omega14_1 * T(0.1);
  const T t15_5 = omega14_1 * T(0.75) - omega14_2 * T(0.3);
  const T Pdot15_1 = Pdot14_1 + R14_11 * t15_3 + R14_21 * t15_4 + R13_31 * t15_5;
  const T Pdot15_2 = Pdot14_2 + R14_12 * t15_3 + R14_22 * t15_4 + R13_32 * t15_5;
  const T Pdot15_3 = Pdot14_3 + R14_13 * t15_3 + R14_23 * t15_4 + R13_33 * t15_5;
  // v15 = R15^T omega15~ r15 + Pdot15: velocity of the mass centre, inertial axes [m/s]
  const T t15_6 = T(0.2) * omega15_3;
  const T t15_7 = omega15_2 * T(0.05) - t15_6;
  const T t15_8 = omega15_3 * T(0.1) - omega15_1 * T(0.05);
  const T t15_9 = omega15_2 * T(0.1);
  const T t15_10 = omega15_1 * T(0.2) - t15_9;
  const T v15_1 = Pdot15_1 + R14_11 * t15_7 + R15_21 * t15_8 + R15_31 * t15_10;
  const T v15_2 = Pdot15_2 + R14_12 * t15_7 + R15_22 * t15_8 + R15_32 * t15_10;
  const T v15_3 = Pdot15_3 + R14_13 * t15_7 + R15_23 * t15_8 + R15_33 * t15_10;
  // T15 = 1/2 omega15 . (I15 omega15) + 1/2 m15 v15 . v15: kinetic energy [J]
  const T t15_11 = T(0.3) * omega15_2;
  const T T15 = T(0.5) * (omega15_1 * (T(0.25) * omega15_1 + T(0.0125) * omega15_2 + T(0.0075) * omega15_3) +
      omega15_2 * (T(0.0125) * omega15_1 + t15_11 - T(0.01) * omega15_3) + omega15_3 * (t15_6 + T(0.0075) * omega15_1
      - T(0.01) * omega15_2)) + T(1.25) * (v15_1 * v15_1 + v15_2 * v15_2 + v15_3 * v15_3);

  // ---- body 16 (body_16) on body 15
  const T thetadot16 = y[15];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cosines[15];
  const T minus_E16_13 = sines[15];
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
  const T P16_3 = t15_1 + P15_3 + R15_23 * T(0.8) + R15_33 * T(0.1);
  // p16 = R16^T r16 + P16: position of the mass centre, inertial axes [m]
  const T p16_3 = t15_2 + P16_3 + R16_13 * T(0.1) + R16_33 * T(0.05);
  // Pdot16 = R15^T omega15~ q16 + Pdot15: velocity of the body origin, inertial axes [m/s]
  const T t16_1 = t15_9 - omega15_3 * T(0.8);
  const T t16_2 = omega15_3 * T(0.3) - omega15_1 * T(0.1);
  const T t16_3 = omega15_1 * T(0.8) - t15_11;
  const T Pdot16_1 = Pdot15_1 + R14_11 * t16_1 + R15_21 * t16_2 + R15_31 * t16_3;
  const T Pdot16_2 = Pdot15_2 + R14_12 * t16_1 + R15_22 * t16_2 + R15_32 * t16_3;
  const T Pdot16_3 = Pdot15_3 + R14_13 * t16_1 + R15_23 * t16_2 + R15_33 * t16_3;
  // v16 = R16^T omega16~ r16 + Pdot16: velocity of the mass centre, inertial axes [m/s]
  const T t16_4 = omega16_2 * T(0.05) - omega16_3 * T(0.2);
  const T t16_5 = omega16_3 * T(0.1) - omega16_1 * T(0.05);
  const T t16_6 = omega16_1 * T(0.2) - omega16_2 * T(0.1);
  const T v16_1 = Pdot16_1 + R16_11 * t16_4 + R15_21 * t16_5 + R16_31 * t16_6;
  const T v16_2 = Pdot16_2 + R16_12 * t16_4 + R15_22 * t16_5 + R16_32 * t16_6;
  const T v16_3 = Pdot16_3 + R16_13 * t16_4 + R15_23 * t16_5 + R16_33 * t16_6;
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
// 2086 add, 2201 multiply, 15 divide, 32 sine or cosine
// by: articulated; composite would take 2976 add, 3397 multiply, 15 divide, 32 sine or cosine
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot)
    noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 16, cosines, sines);

  // ---- body 1 (body_1) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // U1 = omega1~ omega1~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T minus_U1_11 = thetadot1 * thetadot1;
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  const T Pddot1_3 = E1_11 * T(9.81);
  // N1 = -h_own_1~ Pddot1 - axial(U1 (tr(J_own_1)/2 - J_own_1)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N1_2 = T(0.11000000000000001) * Pddot1_3 + T(0.05500000000000001) * minus_Pddot1_1;

  // ---- body 2 (body_2) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T E2_12 = sines[1];
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
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_4 = minus_Pddot1_1 + minus_U1_11 * T(0.3);
  const T minus_Pddot2_1 = E2_11 * t2_4;
  const T Pddot2_2 = E2_12 * t2_4;
  // G2 = -m_all_2 Pddot2 - U2 h_all_2: applied less inertia force, body axes [N]
  const T minus_G2_3 = T(3.9) * Pddot1_3 + U2_31 * T(1.48) + U2_32 * T(0.645) - minus_U2_33 * T(0.72);
  // N2 = -h_all_2~ Pddot2 - axial(U2 (tr(J_all_2)/2 - J_all_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(0.645) * Pddot1_3 - T(0.72) * Pddot2_2 + T(0.14475) * U2_32 + T(0.1218) * (minus_U2_22 -
      minus_U2_33) + T(0.22199999999999998) * U2_31 - T(0.2864) * U2_12;
  const T minus_N2_2 = T(0.2864) * (minus_U2_33 - minus_U2_11) - (T(0.72) * minus_Pddot2_1 + T(1.48) * Pddot1_3) -
      T(0.9572499999999999) * U2_31 + T(0.1218) * U2_12 - T(0.22199999999999998) * U2_32;
  const T minus_N2_3 = T(1.48) * Pddot2_2 + T(0.645) * minus_Pddot2_1 + T(0.8124999999999999) * U2_12 +
      T(0.22199999999999998) * (minus_U2_11 - minus_U2_22);

  // ---- body 3 (body_3) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[2];
  const T E3_23 = sines[2];
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
  const T Pddot3_1 = U2_12 * T(0.15) - minus_Pddot2_1;
  const T t3_7 = Pddot2_2 - minus_U2_22 * T(0.15);
  const T t3_8 = Pddot1_3 + U2_32 * T(0.15) - minus_U2_33 * T(0.2);
  const T Pddot3_2 = E3_22 * t3_7 + E3_23 * t3_8;
  const T Pddot3_3 = E3_22 * t3_8 - E3_23 * t3_7;
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = U3_12 * T(0.8200000000000001) + U3_13 * T(0.20500000000000002);
  const T minus_G3_2 = U3_23 * T(0.20500000000000002) - minus_U3_22 * T(0.8200000000000001);
  const T minus_G3_3 = U3_32 * T(0.8200000000000001) - minus_U3_33 * T(0.20500000000000002);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(0.8200000000000001) * Pddot3_3 - T(0.20500000000000002) * Pddot3_2 + T(0.441) * U3_32 -
      T(0.10825) * U3_23 + T(0.0742) * (minus_U3_22 - minus_U3_33) + T(0.4335) * U3_31 - T(0.1061) * U3_21;
  const T minus_N3_2 = T(0.20500000000000002) * Pddot3_1 + T(0.10825) * U3_13 + T(0.10825) * U3_31 + T(0.1061) *
      (minus_U3_33 - minus_U3_11) + T(0.0742) * U3_12 - T(0.4335) * U3_32;
  const T minus_N3_3 = T(0.4335) * (minus_U3_11 - minus_U3_22) - (T(0.10825) * U3_21 + T(0.441) * U3_12) + T(0.1061) *
      U3_23 - T(0.0742) * U3_13 - T(0.8200000000000001) * Pddot3_1;

  // ---- body 4 (body_4) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T minus_E4_13 = sines[3];
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
  const T t4_7 = Pddot3_1 + U3_13 * T(0.1) - minus_U3_11 * T(0.6);
  const T t4_8 = Pddot3_3 + U3_31 * T(0.6) - minus_U3_33 * T(0.1);
  const T Pddot4_1 = E4_11 * t4_7 - minus_E4_13 * t4_8;
  const T Pddot4_2 = Pddot3_2 + U3_21 * T(0.6) + U3_23 * T(0.1);
  const T Pddot4_3 = minus_E4_13 * t4_7 + E4_11 * t4_8;
  // G4 = -U4 h_own_4: applied less inertia force, body axes [N]
  const T minus_G4_1 = U4_13 * T(0.06999999999999999) - minus_U4_11 * T(0.13999999999999999);
  const T minus_G4_2 = U4_21 * T(0.13999999999999999) + U4_23 * T(0.06999999999999999);
  const T minus_G4_3 = U4_31 * T(0.13999999999999999) - minus_U4_33 * T(0.06999999999999999);
  // N4 = -h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N4_1 = T(0.0336) * (minus_U4_22 - minus_U4_33) - (T(0.084) * U4_32 + T(0.1015) * U4_23) + T(0.049) *
      U4_31 - T(0.0028000000000000004) * U4_21 - T(0.06999999999999999) * Pddot4_2;
  const T minus_N4_2 = T(0.06999999999999999) * Pddot4_1 - T(0.13999999999999999) * Pddot4_3 + T(0.1015) * U4_13 -
      T(0.084) * U4_31 + T(0.0028000000000000004) * (minus_U4_33 - minus_U4_11) + T(0.0336) * U4_12 - T(0.049) *
      U4_32;
  const T minus_N4_3 = T(0.13999999999999999) * Pddot4_2 + T(0.084) * U4_21 + T(0.084) * U4_12 + T(0.049) *
      (minus_U4_11 - minus_U4_22) + T(0.0028000000000000004) * U4_23 - T(0.0336) * U4_13;

  // ---- body 5 (body_5) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];
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
  const T t5_7 = Pddot4_1 + U4_12 * T(0.45) - minus_U4_11 * T(0.3);
  const T t5_8 = Pddot4_2 + U4_21 * T(0.3) - minus_U4_22 * T(0.45);
  const T Pddot5_1 = E5_11 * t5_7 + E5_12 * t5_8;
  const T Pddot5_2 = E5_11 * t5_8 - E5_12 * t5_7;
  const T Pddot5_3 = Pddot4_3 + U4_31 * T(0.3) + U4_32 * T(0.45);
  // G5 = -m_all_5 Pddot5 - U5 h_all_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = T(4.8) * Pddot5_1 + U5_12 * T(1.29) - minus_U5_11 * T(1.81) + U5_13 * T(0.885);
  const T minus_G5_2 = T(4.8) * Pddot5_2 + U5_21 * T(1.81) - minus_U5_22 * T(1.29) + U5_23 * T(0.885);
  const T minus_G5_3 = T(4.8) * Pddot5_3 + U5_31 * T(1.81) + U5_32 * T(1.29) - minus_U5_33 * T(0.885);
  // N5 = -h_all_5~ Pddot5 - axial(U5 (tr(J_all_5)/2 - J_all_5)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N5_1 = T(1.29) * Pddot5_3 - T(0.885) * Pddot5_2 + T(0.40199999999999997) * U5_32 - T(0.27075) * U5_23
      + T(0.249) * (minus_U5_22 - minus_U5_33) + T(0.5205) * U5_31 - T(0.35000000000000003) * U5_21;
  const T minus_N5_2 = T(0.885) * Pddot5_1 - T(1.81) * Pddot5_3 + T(0.27075) * U5_13 - T(1.171) * U5_31 +
      T(0.35000000000000003) * (minus_U5_33 - minus_U5_11) + T(0.249) * U5_12 - T(0.5205) * U5_32;
  const T minus_N5_3 = T(1.81) * Pddot5_2 - T(1.29) * Pddot5_1 + T(1.171) * U5_21 - T(0.40199999999999997) * U5_12 +
      T(0.5205) * (minus_U5_11 - minus_U5_22) + T(0.35000000000000003) * U5_23 - T(0.249) * U5_13;

  // ---- body 6 (body_6) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[5];
  const T E6_23 = sines[5];
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
  const T Pddot6_1 = Pddot5_1 + U5_12 * T(0.3) + U5_13 * T(0.2);
  const T t6_7 = Pddot5_2 + U5_23 * T(0.2) - minus_U5_22 * T(0.3);
  const T t6_8 = Pddot5_3 + U5_32 * T(0.3) - minus_U5_33 * T(0.2);
  const T Pddot6_2 = E6_22 * t6_7 + E6_23 * t6_8;
  const T Pddot6_3 = E6_22 * t6_8 - E6_23 * t6_7;
  // G6 = -U6 h_own_6: applied less inertia force, body axes [N]
  const T minus_G6_1 = U6_12 * T(1.255) + U6_13 * T(0.25);
  const T minus_G6_2 = U6_23 * T(0.25) - minus_U6_22 * T(1.255);
  const T minus_G6_3 = U6_32 * T(1.255) - minus_U6_33 * T(0.25);
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(1.255) * Pddot6_3 - T(0.25) * Pddot6_2 + T(0.77925) * U6_32 - T(0.133) * U6_23 + T(0.1159) *
      (minus_U6_22 - minus_U6_33) + T(0.6809999999999999) * U6_31 - T(0.1292) * U6_21;
  const T minus_N6_2 = T(0.25) * Pddot6_1 + T(0.133) * U6_13 + T(0.133) * U6_31 + T(0.1292) * (minus_U6_33 -
      minus_U6_11) + T(0.1159) * U6_12 - T(0.6809999999999999) * U6_32;
  const T minus_N6_3 = T(0.6809999999999999) * (minus_U6_11 - minus_U6_22) - (T(0.133) * U6_21 + T(0.77925) * U6_12) +
      T(0.1292) * U6_23 - T(0.1159) * U6_13 - T(1.255) * Pddot6_1;

  // ---- body 7 (body_7) on body 6
  const T thetadot7 = y[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T minus_E7_13 = sines[6];
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
  const T t7_7 = Pddot6_1 + U6_13 * T(0.1) - minus_U6_11 * T(0.6);
  const T t7_8 = Pddot6_3 + U6_31 * T(0.6) - minus_U6_33 * T(0.1);
  const T Pddot7_1 = E7_11 * t7_7 - minus_E7_13 * t7_8;
  const T Pddot7_2 = Pddot6_2 + U6_21 * T(0.6) + U6_23 * T(0.1);
  const T Pddot7_3 = minus_E7_13 * t7_7 + E7_11 * t7_8;
  // G7 = -U7 h_own_7: applied less inertia force, body axes [N]
  const T minus_G7_1 = U7_13 * T(0.085) - minus_U7_11 * T(0.17);
  const T minus_G7_2 = U7_21 * T(0.17) + U7_23 * T(0.085);
  const T minus_G7_3 = U7_31 * T(0.17) - minus_U7_33 * T(0.085);
  // N7 = -h_own_7~ Pddot7 - axial(U7 (tr(J_own_7)/2 - J_own_7)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N7_1 = T(0.05355) * (minus_U7_22 - minus_U7_33) - (T(0.102) * U7_32 + T(0.12325) * U7_23) + T(0.085) *
      U7_31 - T(0.0034000000000000002) * U7_21 - T(0.085) * Pddot7_2;
  const T minus_N7_2 = T(0.085) * Pddot7_1 - T(0.17) * Pddot7_3 + T(0.12325) * U7_13 - T(0.102) * U7_31 +
      T(0.0034000000000000002) * (minus_U7_33 - minus_U7_11) + T(0.05355) * U7_12 - T(0.085) * U7_32;
  const T minus_N7_3 = T(0.17) * Pddot7_2 + T(0.102) * U7_21 + T(0.102) * U7_12 + T(0.085) * (minus_U7_11 -
      minus_U7_22) + T(0.0034000000000000002) * U7_23 - T(0.05355) * U7_13;

  // ---- body 8 (body_8) on body 7
  const T thetadot8 = y[7];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[7];
  const T E8_12 = sines[7];
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
  const T t8_7 = Pddot7_1 + U7_12 * T(0.75) - minus_U7_11 * T(0.3);
  const T t8_8 = Pddot7_2 + U7_21 * T(0.3) - minus_U7_22 * T(0.75);
  const T Pddot8_1 = E8_11 * t8_7 + E8_12 * t8_8;
  const T Pddot8_2 = E8_11 * t8_8 - E8_12 * t8_7;
  const T Pddot8_3 = Pddot7_3 + U7_31 * T(0.3) + U7_32 * T(0.75);
  // G8 = -m_all_8 Pddot8 - U8 h_all_8: applied less inertia force, body axes [N]
  const T minus_G8_1 = T(5.7) * Pddot8_1 + U8_12 * T(2.115) - minus_U8_11 * T(2.14) + U8_13 * T(1.05);
  const T minus_G8_2 = T(5.7) * Pddot8_2 + U8_21 * T(2.14) - minus_U8_22 * T(2.115) + U8_23 * T(1.05);
  const T minus_G8_3 = T(5.7) * Pddot8_3 + U8_31 * T(2.14) + U8_32 * T(2.115) - minus_U8_33 * T(1.05);
  // N8 = -h_all_8~ Pddot8 - axial(U8 (tr(J_all_8)/2 - J_all_8)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N8_1 = T(2.115) * Pddot8_3 - T(1.05) * Pddot8_2 + T(0.9157500000000001) * U8_32 - T(0.3225) * U8_23 +
      T(0.4122) * (minus_U8_22 - minus_U8_33) + T(0.909) * U8_31 - T(0.4136) * U8_21;
  const T minus_N8_2 = T(1.05) * Pddot8_1 - T(2.14) * Pddot8_3 + T(0.3225) * U8_13 - T(1.38475) * U8_31 + T(0.4136) *
      (minus_U8_33 - minus_U8_11) + T(0.4122) * U8_12 - T(0.909) * U8_32;
  const T minus_N8_3 = T(2.14) * Pddot8_2 - T(2.115) * Pddot8_1 + T(1.38475) * U8_21 - T(0.9157500000000001) * U8_12 +
      T(0.909) * (minus_U8_11 - minus_U8_22) + T(0.4136) * U8_23 - T(0.4122) * U8_13;

  // ---- body 9 (body_9) on body 8
  const T thetadot9 = y[8];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_22 = cosines[8];
  const T E9_23 = sines[8];
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
  const T Pddot9_1 = Pddot8_1 + U8_12 * T(0.45) + U8_13 * T(0.2);
  const T t9_7 = Pddot8_2 + U8_23 * T(0.2) - minus_U8_22 * T(0.45);
  const T t9_8 = Pddot8_3 + U8_32 * T(0.45) - minus_U8_33 * T(0.2);
  const T Pddot9_2 = E9_22 * t9_7 + E9_23 * t9_8;
  const T Pddot9_3 = E9_22 * t9_8 - E9_23 * t9_7;
  // G9 = -U9 h_own_9: applied less inertia force, body axes [N]
  const T minus_G9_1 = U9_12 * T(1.78) + U9_13 * T(0.295);
  const T minus_G9_2 = U9_23 * T(0.295) - minus_U9_22 * T(1.78);
  const T minus_G9_3 = U9_32 * T(1.78) - minus_U9_33 * T(0.295);
  // N9 = -h_own_9~ Pddot9 - axial(U9 (tr(J_own_9)/2 - J_own_9)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N9_1 = T(1.78) * Pddot9_3 - T(0.295) * Pddot9_2 + T(1.293) * U9_32 - T(0.15775) * U9_23 + T(0.1666) *
      (minus_U9_22 - minus_U9_33) + T(0.9824999999999999) * U9_31 - T(0.1523) * U9_21;
  const T minus_N9_2 = T(0.295) * Pddot9_1 + T(0.15775) * U9_13 + T(0.15775) * U9_31 + T(0.1523) * (minus_U9_33 -
      minus_U9_11) + T(0.1666) * U9_12 - T(0.9824999999999999) * U9_32;
  const T minus_N9_3 = T(0.9824999999999999) * (minus_U9_11 - minus_U9_22) - (T(0.15775) * U9_21 + T(1.293) * U9_12) +
      T(0.1523) * U9_23 - T(0.1666) * U9_13 - T(1.78) * Pddot9_1;

  // ---- body 10 (body_10) on body 9
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_11 = cosines[9];
  const T minus_E10_13 = sines[9];
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
  const T t10_7 = Pddot9_1 + U9_13 * T(0.1) - minus_U9_11 * T(0.6);
  const T t10_8 = Pddot9_3 + U9_31 * T(0.6) - minus_U9_33 * T(0.1);
  const T Pddot10_1 = E10_11 * t10_7 - minus_E10_13 * t10_8;
  const T Pddot10_2 = Pddot9_2 + U9_21 * T(0.6) + U9_23 * T(0.1);
  const T Pddot10_3 = minus_E10_13 * t10_7 + E10_11 * t10_8;
  // G10 = -U10 h_own_10: applied less inertia force, body axes [N]
  const T minus_G10_1 = U10_13 * T(0.1) - minus_U10_11 * T(0.2);
  const T minus_G10_2 = U10_21 * T(0.2) + U10_23 * T(0.1);
  const T minus_G10_3 = U10_31 * T(0.2) - minus_U10_33 * T(0.1);
  // N10 = -h_own_10~ Pddot10 - axial(U10 (tr(J_own_10)/2 - J_own_10)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N10_1 = T(0.078) * (minus_U10_22 - minus_U10_33) - (T(0.12) * U10_32 + T(0.145) * U10_23) + T(0.13) *
      U10_31 - T(0.004000000000000001) * U10_21 - T(0.1) * Pddot10_2;
  const T minus_N10_2 = T(0.1) * Pddot10_1 - T(0.2) * Pddot10_3 + T(0.145) * U10_13 - T(0.12) * U10_31 +
      T(0.004000000000000001) * (minus_U10_33 - minus_U10_11) + T(0.078) * U10_12 - T(0.13) * U10_32;
  const T minus_N10_3 = T(0.2) * Pddot10_2 + T(0.12) * U10_21 + T(0.12) * U10_12 + T(0.13) * (minus_U10_11 -
      minus_U10_22) + T(0.004000000000000001) * U10_23 - T(0.078) * U10_13;

  // ---- body 11 (body_11) on body 10
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[10];
  const T E11_12 = sines[10];
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
  const T t11_7 = Pddot10_1 + U10_12 * T(1.05) - minus_U10_11 * T(0.3);
  const T t11_8 = Pddot10_2 + U10_21 * T(0.3) - minus_U10_22 * T(1.05);
  const T Pddot11_1 = E11_11 * t11_7 + E11_12 * t11_8;
  const T Pddot11_2 = E11_11 * t11_8 - E11_12 * t11_7;
  const T Pddot11_3 = Pddot10_3 + U10_31 * T(0.3) + U10_32 * T(1.05);
  // G11 = -m_all_11 Pddot11 - U11 h_all_11: applied less inertia force, body axes [N]
  const T minus_G11_1 = T(6.6) * Pddot11_1 + U11_12 * T(3.12) - minus_U11_11 * T(2.4699999999999998) + U11_13 *
      T(1.215);
  const T minus_G11_2 = T(6.6) * Pddot11_2 + U11_21 * T(2.4699999999999998) - minus_U11_22 * T(3.12) + U11_23 *
      T(1.215);
  const T minus_G11_3 = T(6.6) * Pddot11_3 + U11_31 * T(2.4699999999999998) + U11_32 * T(3.12) - minus_U11_33 *
      T(1.215);
  // N11 = -h_all_11~ Pddot11 - axial(U11 (tr(J_all_11)/2 - J_all_11)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N11_1 = T(3.12) * Pddot11_3 - T(1.215) * Pddot11_2 + T(1.767) * U11_32 - T(0.37425) * U11_23 +
      T(0.6114) * (minus_U11_22 - minus_U11_33) + T(1.3875) * U11_31 - T(0.4772) * U11_21;
  const T minus_N11_2 = T(1.215) * Pddot11_1 - T(2.4699999999999998) * Pddot11_3 + T(0.37425) * U11_13 -
      T(1.5984999999999998) * U11_31 + T(0.4772) * (minus_U11_33 - minus_U11_11) + T(0.6114) * U11_12 - T(1.3875) *
      U11_32;
  const T minus_N11_3 = T(2.4699999999999998) * Pddot11_2 - T(3.12) * Pddot11_1 + T(1.5984999999999998) * U11_21 -
      T(1.767) * U11_12 + T(1.3875) * (minus_U11_11 - minus_U11_22) + T(0.4772) * U11_23 - T(0.6114) * U11_13;

  // ---- body 12 (body_12) on body 11
  const T thetadot12 = y[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_22 = cosines[11];
  const T E12_23 = sines[11];
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
  const T Pddot12_1 = Pddot11_1 + U11_12 * T(0.6) + U11_13 * T(0.2);
  const T t12_7 = Pddot11_2 + U11_23 * T(0.2) - minus_U11_22 * T(0.6);
  const T t12_8 = Pddot11_3 + U11_32 * T(0.6) - minus_U11_33 * T(0.2);
  const T Pddot12_2 = E12_22 * t12_7 + E12_23 * t12_8;
  const T Pddot12_3 = E12_22 * t12_8 - E12_23 * t12_7;
  // G12 = -U12 h_own_12: applied less inertia force, body axes [N]
  const T minus_G12_1 = U12_12 * T(2.395) + U12_13 * T(0.34);
  const T minus_G12_2 = U12_23 * T(0.34) - minus_U12_22 * T(2.395);
  const T minus_G12_3 = U12_32 * T(2.395) - minus_U12_33 * T(0.34);
  // N12 = -h_own_12~ Pddot12 - axial(U12 (tr(J_own_12)/2 - J_own_12)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N12_1 = T(2.395) * Pddot12_3 - T(0.34) * Pddot12_2 + T(2.02275) * U12_32 - T(0.18250000000000002) *
      U12_23 + T(0.2263) * (minus_U12_22 - minus_U12_33) + T(1.3379999999999999) * U12_31 - T(0.1754) * U12_21;
  const T minus_N12_2 = T(0.34) * Pddot12_1 + T(0.18250000000000002) * U12_13 + T(0.18250000000000002) * U12_31 +
      T(0.1754) * (minus_U12_33 - minus_U12_11) + T(0.2263) * U12_12 - T(1.3379999999999999) * U12_32;
  const T minus_N12_3 = T(1.3379999999999999) * (minus_U12_11 - minus_U12_22) - (T(0.18250000000000002) * U12_21 +
      T(2.02275) * U12_12) + T(0.1754) * U12_23 - T(0.2263) * U12_13 - T(2.395) * Pddot12_1;

  // ---- body 13 (body_13) on body 12
  const T thetadot13 = y[12];
  // E13^T = Rot(b13, theta13): E takes components in the lower body to those in the body
  const T E13_11 = cosines[12];
  const T minus_E13_13 = sines[12];
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
  const T t13_7 = Pddot12_1 + U12_13 * T(0.1) - minus_U12_11 * T(0.6);
  const T t13_8 = Pddot12_3 + U12_31 * T(0.6) - minus_U12_33 * T(0.1);
  const T Pddot13_1 = E13_11 * t13_7 - minus_E13_13 * t13_8;
  const T Pddot13_2 = Pddot12_2 + U12_21 * T(0.6) + U12_23 * T(0.1);
  const T Pddot13_3 = minus_E13_13 * t13_7 + E13_11 * t13_8;
  // G13 = -U13 h_own_13: applied less inertia force, body axes [N]
  const T minus_G13_1 = U13_13 * T(0.11499999999999999) - minus_U13_11 * T(0.22999999999999998);
  const T minus_G13_2 = U13_21 * T(0.22999999999999998) + U13_23 * T(0.11499999999999999);
  const T minus_G13_3 = U13_31 * T(0.22999999999999998) - minus_U13_33 * T(0.11499999999999999);
  // N13 = -h_own_13~ Pddot13 - axial(U13 (tr(J_own_13)/2 - J_own_13)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N13_1 = T(0.10695) * (minus_U13_22 - minus_U13_33) - (T(0.138) * U13_32 + T(0.16675) * U13_23) +
      T(0.184) * U13_31 - T(0.004600000000000001) * U13_21 - T(0.11499999999999999) * Pddot13_2;
  const T minus_N13_2 = T(0.11499999999999999) * Pddot13_1 - T(0.22999999999999998) * Pddot13_3 + T(0.16675) * U13_13
      - T(0.138) * U13_31 + T(0.004600000000000001) * (minus_U13_33 - minus_U13_11) + T(0.10695) * U13_12 - T(0.184) *
      U13_32;
  const T minus_N13_3 = T(0.22999999999999998) * Pddot13_2 + T(0.138) * U13_21 + T(0.138) * U13_12 + T(0.184) *
      (minus_U13_11 - minus_U13_22) + T(0.004600000000000001) * U13_23 - T(0.10695) * U13_13;

  // ---- body 14 (body_14) on body 13
  const T thetadot14 = y[13];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_11 = cosines[13];
  const T E14_12 = sines[13];
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
  const T t14_7 = Pddot13_1 + U13_12 * T(1.35) - minus_U13_11 * T(0.3);
  const T t14_8 = Pddot13_2 + U13_21 * T(0.3) - minus_U13_22 * T(1.35);
  const T Pddot14_1 = E14_11 * t14_7 + E14_12 * t14_8;
  const T Pddot14_2 = E14_11 * t14_8 - E14_12 * t14_7;
  const T Pddot14_3 = Pddot13_3 + U13_31 * T(0.3) + U13_32 * T(1.35);
  // G14 = -m_all_14 Pddot14 - U14 h_all_14: applied less inertia force, body axes [N]
  const T minus_G14_1 = T(7.5) * Pddot14_1 + U14_12 * T(4.305) - minus_U14_11 * T(2.8) + U14_13 *
      T(1.3800000000000001);
  const T minus_G14_2 = T(7.5) * Pddot14_2 + U14_21 * T(2.8) - minus_U14_22 * T(4.305) + U14_23 *
      T(1.3800000000000001);
  const T minus_G14_3 = T(7.5) * Pddot14_3 + U14_31 * T(2.8) + U14_32 * T(4.305) - minus_U14_33 *
      T(1.3800000000000001);
  // N14 = -h_all_14~ Pddot14 - axial(U14 (tr(J_all_14)/2 - J_all_14)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N14_1 = T(4.305) * Pddot14_3 - T(1.3800000000000001) * Pddot14_2 + T(3.03675) * U14_32 - T(0.426) *
      U14_23 + T(0.8466) * (minus_U14_22 - minus_U14_33) + T(1.956) * U14_31 - T(0.5408000000000001) * U14_21;
  const T minus_N14_2 = T(1.3800000000000001) * Pddot14_1 - T(2.8) * Pddot14_3 + T(0.426) * U14_13 - T(1.81225) *
      U14_31 + T(0.5408000000000001) * (minus_U14_33 - minus_U14_11) + T(0.8466) * U14_12 - T(1.956) * U14_32;
  const T minus_N14_3 = T(2.8) * Pddot14_2 - T(4.305) * Pddot14_1 + T(1.81225) * U14_21 - T(3.03675) * U14_12 +
      T(1.956) * (minus_U14_11 - minus_U14_22) + T(0.5408000000000001) * U14_23 - T(0.8466) * U14_13;

  // ---- body 15 (body_15) on body 14
  const T thetadot15 = y[14];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_22 = cosines[14];
  const T E15_23 = sines[14];
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
  const T Pddot15_1 = Pddot14_1 + U14_12 * T(0.75) + U14_13 * T(0.2);
  const T t15_7 = Pddot14_2 + U14_23 * T(0.2) - minus_U14_22 * T(0.75);
  const T t15_8 = Pddot14_3 + U14_32 * T(0.75) - minus_U14_33 * T(0.2);
  const T Pddot15_2 = E15_22 * t15_7 + E15_23 * t15_8;
  const T Pddot15_3 = E15_22 * t15_8 - E15_23 * t15_7;
  // G15 = -U15 h_own_15: applied less inertia force, body axes [N]
  const T minus_G15_1 = U15_12 * T(3.1) + U15_13 * T(0.385);
  const T minus_G15_2 = U15_23 * T(0.385) - minus_U15_22 * T(3.1);
  const T minus_G15_3 = U15_32 * T(3.1) - minus_U15_33 * T(0.385);
  // N15 = -h_own_15~ Pddot15 - axial(U15 (tr(J_own_15)/2 - J_own_15)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N15_1 = T(3.1) * Pddot15_3 - T(0.385) * Pddot15_2 + T(3.03084) * U15_32 - T(0.20725) * U15_23 +
      T(0.29500000000000004) * (minus_U15_22 - minus_U15_33) + T(1.7475) * U15_31 - T(0.1985) * U15_21;
  const T minus_N15_2 = T(0.385) * Pddot15_1 + T(0.20725) * U15_13 + T(0.20725) * U15_31 + T(0.1985) * (minus_U15_33 -
      minus_U15_11) + T(0.29500000000000004) * U15_12 - T(1.7475) * U15_32;
  const T minus_N15_3 = T(1.7475) * (minus_U15_11 - minus_U15_22) - (T(0.20725) * U15_21 + T(3.03084) * U15_12) +
      T(0.1985) * U15_23 - T(0.29500000000000004) * U15_13 - T(3.1) * Pddot15_1;

  // ---- body 16 (body_16) on body 15
  const T thetadot16 = y[15];
  // E16^T = Z16^T Rot(b16, theta16): E takes components in the lower body to those in the body
  const T t16_1 = cosines[15];
  const T t16_2 = sines[15];
  const T E16_11 = T(0.44721359549995804) * t16_1 - T(0.8944271909999159) * t16_2;
  const T minus_E16_13 = T(0.8944271909999159) * t16_1 + T(0.44721359549995804) * t16_2;
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T omega16_1 = E16_11 * omega15_1 - minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 + E16_11 * omega15_3;
  // omegadot16 = -thetadot16 b16~ E16 omega15 + E16 omegadot15: angular acceleration, body axes [rad/s^2]
  const T omegadot16_1 = E16_11 * omegadot14_1 - minus_E16_13 * omegadot15_3 - thetadot16 * omega16_3;
  const T omegadot16_3 = thetadot16 * omega16_1 + minus_E16_13 * omegadot14_1 + E16_11 * omegadot15_3;
  // U16 = omega16~ omega16~ + omegadot16~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t16_3 = omega16_3 * omega16_3;
  const T t16_4 = omega16_2 * omega16_2;
  const T minus_U16_11 = t16_3 + t16_4;
  const T t16_5 = omega16_2 * omega16_1;
  const T U16_12 = t16_5 - omegadot16_3;
  const T t16_6 = omega16_3 * omega16_1;
  const T U16_13 = t16_6 + omegadot15_2;
  const T U16_21 = t16_5 + omegadot16_3;
  const T t16_7 = omega16_1 * omega16_1;
  const T minus_U16_22 = t16_3 + t16_7;
  const T t16_8 = omega16_3 * omega16_2;
  const T U16_23 = t16_8 - omegadot16_1;
  const T U16_31 = t16_6 - omegadot15_2;
  const T U16_32 = t16_8 + omegadot16_1;
  const T minus_U16_33 = t16_4 + t16_7;
  // Pddot16 = E16 (U15 q16 + Pddot15): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot16_1 = E16_11 * (Pddot15_1 + U15_13 * T(0.1) - minus_U15_11 * T(0.6)) - minus_E16_13 * (Pddot15_3 +
      U15_31 * T(0.6) - minus_U15_33 * T(0.1));
  const T Pddot16_2 = Pddot15_2 + U15_21 * T(0.6) + U15_23 * T(0.1);
  // G16 = -U16 h_own_16: applied less inertia force, body axes [N]
  const T minus_G16_1 = U16_13 * T(0.2906888370749727);
  const T minus_G16_2 = U16_23 * T(0.2906888370749727);
  const T G16_3 = minus_U16_33 * T(0.2906888370749727);
  // N16 = -h_own_16~ Pddot16 - axial(U16 (tr(J_own_16)/2 - J_own_16)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N16_1 = T(0.28371230498517336) * (minus_U16_22 - minus_U16_33) - (T(0.17784) * U16_32 + T(0.16666) *
      U16_23) - T(0.015115819527898578) * U16_31 + T(0.016120000000000013) * U16_21 - T(0.2906888370749727) *
      Pddot16_2;
  const T minus_N16_2 = T(0.2906888370749727) * Pddot16_1 + T(0.16666) * U16_13 - T(0.17784) * U16_31 -
      T(0.016120000000000013) * (minus_U16_33 - minus_U16_11) + T(0.28371230498517336) * U16_12 +
      T(0.015115819527898578) * U16_32;
  const T minus_N16_3 = T(0.17784) * U16_21 + T(0.17784) * U16_12 - T(0.015115819527898578) * (minus_U16_11 -
      minus_U16_22) - T(0.016120000000000013) * U16_23 - T(0.28371230498517336) * U16_13;

  // ---- body 16 (body_16) and what it carries
  // u_16 = b16 . N16 + tau_body_16_: drives it [N m], [N]
  const T u_16 = u.tau_16 - minus_N16_2;
  // v16 = invD16 u_16: u/D
  const T v16 = T(2.9027576197387517) * u_16;
  // gt16 = G16 - v16 B16: force with the turn solved [N]
  const T minus_gt16_1 = v16 * T(0.2906888370749727) + minus_G16_1;
  // nt16 = -tau_body_16_ b16 + P_b16 (N16 - v16 K16): moment with the turn solved [N m]
  const T minus_nt16_1 = minus_N16_1 + v16 * T(0.015115819527898578);
  const T nt16_3 = v16 * T(0.28371230498517336) - minus_N16_3;
  // Mp16 = E16^T M16 E16: M passed on, lower body's axes [kg]
  const T b16_1 = minus_E16_13 * T(0.24528301886792458);
  const T b16_2 = minus_E16_13 * b16_1;
  const T Mp16_11 = b16_2 - T(0.24528301886792458);
  const T Mp16_13 = E16_11 * b16_1;
  // gp16 = E16^T gt16: force passed on, lower body's axes [N]
  const T gp16_1 = minus_E16_13 * G16_3 - E16_11 * minus_gt16_1;
  const T gp16_3 = minus_E16_13 * minus_gt16_1 + E16_11 * G16_3;
  // Hp16 = E16^T H16 E16: H passed on, lower body's axes [kg m]
  const T b16_3 = minus_E16_13 * T(0.012754716981132078) + E16_11 * T(0.2393962264150944);
  const T b16_4 = minus_E16_13 * b16_3;
  const T Hp16_11 = b16_4 - T(0.012754716981132078);
  const T minus_Hp16_12 = E16_11 * T(0.2906888370749727);
  const T b16_5 = E16_11 * b16_3;
  const T Hp16_13 = b16_5 - T(0.2393962264150944);
  const T Hp16_32 = minus_E16_13 * T(0.2906888370749727);
  // Jp16 = E16^T J16 E16: J passed on, lower body's axes [kg m^2]
  const T b16_6 = T(2) * E16_11 * T(0.02856860377358492) - minus_E16_13 * T(0.22180747169811327);
  const T b16_7 = minus_E16_13 * b16_6;
  const T Jp16_11 = b16_7 - T(0.01184324528301887);
  const T Jp16_13 = E16_11 * b16_6 - T(0.02856860377358492);
  const T minus_Jp16_33 = T(0.23365071698113213) + b16_7;
  // np16 = E16^T nt16: moment passed on, lower body's axes [N m]
  const T np16_1 = minus_E16_13 * nt16_3 - E16_11 * minus_nt16_1;
  const T np16_3 = minus_E16_13 * minus_nt16_1 + E16_11 * nt16_3;
  // Hb16 = q16~ Mp16 + Hp16: H of the joint at the lower body's origin, its axes
  const T Hb16_21 = T(0.1) * Mp16_11 - T(0.6) * Mp16_13;
  const T Hb16_23 = T(0.1) * Mp16_13 + T(0.6) * b16_2;

  // ---- body 15 (body_15) and what it carries
  // HA15 = h_own_15~ + Hb16: moment for an acceleration of the origin, body axes [kg m]
  const T minus_HA15_12 = minus_Hp16_12 + T(0.385);
  const T HA15_13 = T(3.1) + Hp16_13;
  const T HA15_21 = T(0.385) + Hb16_21;
  const T HA15_31 = b16_5 - T(3.1);
  // JA15 = q16~ Hp16^T + J_own_15 + Jp16 - Hb16 q16~: moment for an angular acceleration, body axes [kg m^2]
  const T JA15_11 = T(3.23809) + Jp16_11 + T(0.2) * minus_Hp16_12;
  const T JA15_12 = T(0.1) * Hp16_11 - T(1.7475) - T(0.6) * Hp16_13;
  const T JA15_13 = Jp16_13 - T(0.1985) - T(0.1) * Hp16_32 - T(0.6) * minus_Hp16_12;
  const T minus_JA15_22 = Hb16_23 * T(0.6) - Hb16_21 * T(0.1);
  const T JA15_23 = T(0.1) * b16_5 - T(0.29500000000000004) + T(0.6) * b16_4;
  const T JA15_33 = T(2.8235900000000003) - minus_Jp16_33 + T(1.2) * Hp16_32;
  // g15 = G15 + gp16: force that drives it, home axes [N]
  const T g15_1 = gp16_1 - minus_G15_1;
  const T minus_g15_2 = minus_G16_2 + minus_G15_2;
  const T g15_3 = gp16_3 - minus_G15_3;
  // n15 = q16~ gp16 + N15 + np16: moment that drives it, body axes [N m]
  const T n15_1 = np16_1 - minus_N15_1 + T(0.1) * minus_G16_2;
  const T n15_2 = T(0.1) * gp16_1 - (minus_N15_2 + u.tau_16) - T(0.6) * gp16_3;
  const T n15_3 = np16_3 - minus_N15_3 - T(0.6) * minus_G16_2;
  // invD15 = D15^-1: 1/D
  const T invD15 = T(1) / JA15_11;
  // kB15 = invD15 B15: B/D
  const T kB15_1 = invD15 * Hp16_11;
  const T minus_kB15_2 = invD15 * minus_HA15_12;
  const T kB15_3 = invD15 * HA15_13;
  // kK15 = invD15 K15: K/D
  const T kK15_2 = invD15 * JA15_12;
  const T kK15_3 = invD15 * JA15_13;
  // u_15 = b15 . n15 + tau_body_15_: drives it [N m], [N]
  const T u_15 = n15_1 + u.tau_15;
  // v15 = invD15 u_15: u/D
  const T v15 = invD15 * u_15;
  // M15 = Mp16 - kB15 B15^T: MA less what the turn takes up [kg]
  const T M15_11 = Mp16_11 - kB15_1 * Hp16_11;
  const T M15_12 = kB15_1 * minus_HA15_12;
  const T M15_13 = Mp16_13 - kB15_1 * HA15_13;
  const T minus_M15_22 = minus_kB15_2 * minus_HA15_12;
  const T M15_23 = minus_kB15_2 * HA15_13;
  const T minus_M15_33 = b16_2 + kB15_3 * HA15_13;
  // H15 = P_b15 (HA15 - kK15 B15^T): HA less what the turn takes up [kg m]
  const T H15_21 = HA15_21 - kK15_2 * Hp16_11;
  const T H15_22 = kK15_2 * minus_HA15_12;
  const T H15_23 = Hb16_23 - kK15_2 * HA15_13;
  const T H15_31 = HA15_31 - kK15_3 * Hp16_11;
  const T H15_32 = Hp16_32 + kK15_3 * minus_HA15_12;
  const T minus_H15_33 = b16_4 + kK15_3 * HA15_13;
  // J15 = P_b15 (JA15 - kK15 K15^T) P_b15: JA less what the turn takes up [kg m^2]
  const T minus_J15_22 = minus_JA15_22 + kK15_2 * JA15_12;
  const T J15_23 = JA15_23 - kK15_2 * JA15_13;
  const T J15_33 = JA15_33 - kK15_3 * JA15_13;
  // gt15 = g15 - v15 B15: force with the turn solved [N]
  const T gt15_1 = g15_1 - v15 * Hp16_11;
  const T gt15_2 = v15 * minus_HA15_12 - minus_g15_2;
  const T gt15_3 = g15_3 - v15 * HA15_13;
  // nt15 = -tau_body_15_ b15 + P_b15 (n15 - v15 K15): moment with the turn solved [N m]
  const T nt15_2 = n15_2 - v15 * JA15_12;
  const T nt15_3 = n15_3 - v15 * JA15_13;
  // Mp15 = E15^T M15 E15: M passed on, lower body's axes [kg]
  const T minus_Mp15_12 = E15_23 * M15_13 - E15_22 * M15_12;
  const T Mp15_13 = E15_22 * M15_13 + E15_23 * M15_12;
  const T b15_1 = T(2) * E15_22;
  const T b15_2 = E15_23 * (minus_M15_33 - minus_M15_22) + b15_1 * M15_23;
  const T b15_3 = E15_23 * b15_2;
  const T minus_Mp15_22 = minus_M15_22 + b15_3;
  const T Mp15_23 = E15_22 * b15_2 - M15_23;
  const T Mp15_33 = b15_3 - minus_M15_33;
  // gp15 = E15^T gt15: force passed on, lower body's axes [N]
  const T gp15_2 = E15_22 * gt15_2 - E15_23 * gt15_3;
  const T gp15_3 = E15_23 * gt15_2 + E15_22 * gt15_3;
  // Hp15 = E15^T H15 E15: H passed on, lower body's axes [kg m]
  const T Hp15_21 = E15_22 * H15_21 - E15_23 * H15_31;
  const T b15_4 = E15_23 * (minus_H15_33 + H15_22) + E15_22 * (H15_23 + H15_32);
  const T b15_5 = E15_23 * b15_4;
  const T minus_Hp15_22 = b15_5 - H15_22;
  const T b15_6 = E15_22 * b15_4;
  const T Hp15_23 = b15_6 - H15_32;
  const T Hp15_31 = E15_23 * H15_21 + E15_22 * H15_31;
  const T Hp15_32 = b15_6 - H15_23;
  const T Hp15_33 = b15_5 - minus_H15_33;
  // Jp15 = E15^T J15 E15: J passed on, lower body's axes [kg m^2]
  const T b15_7 = b15_1 * J15_23 - E15_23 * (minus_J15_22 + J15_33);
  const T b15_8 = E15_23 * b15_7;
  const T minus_Jp15_22 = minus_J15_22 + b15_8;
  const T Jp15_23 = E15_22 * b15_7 - J15_23;
  const T Jp15_33 = J15_33 + b15_8;
  // np15 = E15^T nt15: moment passed on, lower body's axes [N m]
  const T np15_2 = E15_22 * nt15_2 - E15_23 * nt15_3;
  const T np15_3 = E15_23 * nt15_2 + E15_22 * nt15_3;
  // Hb15 = q15~ Mp15 + Hp15: H of the joint at the lower body's origin, its axes
  const T b15_9 = T(0.2) * minus_Mp15_12;
  const T b15_10 = T(0.75) * Mp15_13;
  const T Hb15_11 = b15_9 + b15_10;
  const T Hb15_12 = T(0.2) * minus_Mp15_22 + T(0.75) * Mp15_23;
  const T Hb15_13 = T(0.75) * Mp15_33 - T(0.2) * Mp15_23;
  const T Hb15_21 = Hp15_21 + T(0.2) * M15_11;
  const T minus_Hb15_22 = minus_Hp15_22 + b15_9;
  const T Hb15_23 = Hp15_23 + T(0.2) * Mp15_13;
  const T Hb15_31 = Hp15_31 - T(0.75) * M15_11;
  const T Hb15_32 = Hp15_32 + T(0.75) * minus_Mp15_12;
  const T Hb15_33 = Hp15_33 - b15_10;

  // ---- body 14 (body_14) and what it carries
  // MA14 = m_all_14 one + Mp15: force for an acceleration of the origin, home axes [kg]
  const T MA14_11 = T(7.5) + M15_11;
  const T MA14_22 = T(7.5) - minus_Mp15_22;
  const T MA14_33 = T(7.5) + Mp15_33;
  // HA14 = h_all_14~ + Hb15: moment for an acceleration of the origin, body axes [kg m]
  const T HA14_12 = Hb15_12 - T(1.3800000000000001);
  const T HA14_13 = T(4.305) + Hb15_13;
  const T HA14_21 = T(1.3800000000000001) + Hb15_21;
  const T HA14_23 = Hb15_23 - T(2.8);
  const T HA14_31 = Hb15_31 - T(4.305);
  const T HA14_32 = T(2.8) + Hb15_32;
  // JA14 = q15~ Hp15^T + J_all_14 + Jp15 - Hb15 q15~: moment for an angular acceleration, body axes [kg m^2]
  const T JA14_11 = T(3.46275) + Hb15_13 * T(0.75) - Hb15_12 * T(0.2);
  const T JA14_12 = T(0.2) * minus_Hp15_22 - T(1.956) + T(0.75) * Hp15_23 + Hb15_11 * T(0.2);
  const T JA14_13 = T(0.75) * Hp15_33 - T(0.5408000000000001) - T(0.2) * Hp15_32 - Hb15_11 * T(0.75);
  const T JA14_22 = T(2.23825) - minus_Jp15_22 + T(0.2) * Hp15_21 + Hb15_21 * T(0.2);
  const T JA14_23 = Jp15_23 - T(0.8466) + T(0.2) * Hp15_31 - Hb15_21 * T(0.75);
  const T JA14_33 = T(4.849) + Jp15_33 - T(0.75) * Hp15_31 - Hb15_31 * T(0.75);
  // g14 = G14 + gp15: force that drives it, home axes [N]
  const T g14_1 = gt15_1 - minus_G14_1;
  const T g14_2 = gp15_2 - minus_G14_2;
  const T g14_3 = gp15_3 - minus_G14_3;
  // n14 = q15~ gp15 + N14 + np15: moment that drives it, body axes [N m]
  const T n14_1 = T(0.75) * gp15_3 - (minus_N14_1 + u.tau_15) - T(0.2) * gp15_2;
  const T n14_2 = np15_2 - minus_N14_2 + T(0.2) * gt15_1;
  const T n14_3 = np15_3 - minus_N14_3 - T(0.75) * gt15_1;
  // invD14 = D14^-1: 1/D
  const T invD14 = T(1) / JA14_33;
  // kB14 = invD14 B14: B/D
  const T kB14_1 = invD14 * HA14_31;
  const T kB14_2 = invD14 * HA14_32;
  const T kB14_3 = invD14 * Hb15_33;
  // kK14 = invD14 K14: K/D
  const T kK14_1 = invD14 * JA14_13;
  const T kK14_2 = invD14 * JA14_23;
  // u_14 = b14 . n14 + tau_body_14_: drives it [N m], [N]
  const T u_14 = n14_3 + u.tau_14;
  // v14 = invD14 u_14: u/D
  const T v14 = invD14 * u_14;
  // M14 = MA14 - kB14 B14^T: MA less what the turn takes up [kg]
  const T M14_11 = MA14_11 - kB14_1 * HA14_31;
  const T minus_M14_12 = minus_Mp15_12 + kB14_1 * HA14_32;
  const T M14_13 = Mp15_13 - kB14_1 * Hb15_33;
  const T M14_22 = MA14_22 - kB14_2 * HA14_32;
  const T M14_23 = Mp15_23 - kB14_2 * Hb15_33;
  const T M14_33 = MA14_33 - kB14_3 * Hb15_33;
  // H14 = P_b14 (HA14 - kK14 B14^T): HA less what the turn takes up [kg m]
  const T H14_11 = Hb15_11 - kK14_1 * HA14_31;
  const T H14_12 = HA14_12 - kK14_1 * HA14_32;
  const T H14_13 = HA14_13 - kK14_1 * Hb15_33;
  const T H14_21 = HA14_21 - kK14_2 * HA14_31;
  const T minus_H14_22 = minus_Hb15_22 + kK14_2 * HA14_32;
  const T H14_23 = HA14_23 - kK14_2 * Hb15_33;
  // J14 = P_b14 (JA14 - kK14 K14^T) P_b14: JA less what the turn takes up [kg m^2]
  const T J14_11 = JA14_11 - kK14_1 * JA14_13;
  const T J14_12 = JA14_12 - kK14_1 * JA14_23;
  const T J14_22 = JA14_22 - kK14_2 * JA14_23;
  // gt14 = g14 - v14 B14: force with the turn solved [N]
  const T gt14_1 = g14_1 - v14 * HA14_31;
  const T gt14_2 = g14_2 - v14 * HA14_32;
  const T gt14_3 = g14_3 - v14 * Hb15_33;
  // nt14 = -tau_body_14_ b14 + P_b14 (n14 - v14 K14): moment with the turn solved [N m]
  const T nt14_1 = n14_1 - v14 * JA14_13;
  const T nt14_2 = n14_2 - v14 * JA14_23;
  // Mp14 = E14^T M14 E14: M passed on, lower body's axes [kg]
  const T b14_1 = T(2) * E14_11;
  const T b14_2 = E14_12 * (M14_11 - M14_22) - b14_1 * minus_M14_12;
  const T b14_3 = E14_12 * b14_2;
  const T Mp14_11 = M14_11 - b14_3;
  const T Mp14_12 = minus_M14_12 + E14_11 * b14_2;
  const T Mp14_13 = E14_11 * M14_13 - E14_12 * M14_23;
  const T Mp14_22 = M14_22 + b14_3;
  const T Mp14_23 = E14_12 * M14_13 + E14_11 * M14_23;
  // gp14 = E14^T gt14: force passed on, lower body's axes [N]
  const T gp14_1 = E14_11 * gt14_1 - E14_12 * gt14_2;
  const T gp14_2 = E14_12 * gt14_1 + E14_11 * gt14_2;
  // Hp14 = E14^T H14 E14: H passed on, lower body's axes [kg m]
  const T b14_4 = E14_12 * (H14_11 + minus_H14_22) + E14_11 * (H14_12 + H14_21);
  const T b14_5 = E14_12 * b14_4;
  const T Hp14_11 = H14_11 - b14_5;
  const T b14_6 = E14_11 * b14_4;
  const T Hp14_12 = b14_6 - H14_21;
  const T Hp14_13 = E14_11 * H14_13 - E14_12 * H14_23;
  const T Hp14_21 = b14_6 - H14_12;
  const T Hp14_22 = b14_5 - minus_H14_22;
  const T Hp14_23 = E14_12 * H14_13 + E14_11 * H14_23;
  // Jp14 = E14^T J14 E14: J passed on, lower body's axes [kg m^2]
  const T b14_7 = E14_12 * (J14_11 - J14_22) + b14_1 * J14_12;
  const T b14_8 = E14_12 * b14_7;
  const T Jp14_11 = J14_11 - b14_8;
  const T Jp14_12 = E14_11 * b14_7 - J14_12;
  const T Jp14_22 = J14_22 + b14_8;
  // np14 = E14^T nt14: moment passed on, lower body's axes [N m]
  const T np14_1 = E14_11 * nt14_1 - E14_12 * nt14_2;
  const T np14_2 = E14_12 * nt14_1 + E14_11 * nt14_2;
  // Hb14 = q14~ Mp14 + Hp14: H of the joint at the lower body's origin, its axes
  const T b14_9 = T(1.35) * Mp14_13;
  const T Hb14_11 = b14_9 + Hp14_11;
  const T Hb14_12 = Hp14_12 + T(1.35) * Mp14_23;
  const T Hb14_13 = Hp14_13 + T(1.35) * M14_33;
  const T Hb14_21 = Hp14_21 - T(0.3) * Mp14_13;
  const T b14_10 = T(0.3) * Mp14_23;
  const T Hb14_22 = Hp14_22 - b14_10;
  const T Hb14_23 = Hp14_23 - T(0.3) * M14_33;
  const T Hb14_31 = T(0.3) * Mp14_12 - T(1.35) * Mp14_11;
  const T Hb14_32 = T(0.3) * Mp14_22 - T(1.35) * Mp14_12;
  const T Hb14_33 = b14_10 - b14_9;

  // ---- body 13 (body_13) and what it carries
  // HA13 = h_own_13~ + Hb14: moment for an acceleration of the origin, body axes [kg m]
  const T HA13_12 = Hb14_12 - T(0.11499999999999999);
  const T HA13_21 = T(0.11499999999999999) + Hb14_21;
  const T HA13_23 = Hb14_23 - T(0.22999999999999998);
  const T HA13_32 = T(0.22999999999999998) + Hb14_32;
  // JA13 = q14~ Hp14^T + J_own_13 + Jp14 - Hb14 q14~: moment for an angular acceleration, body axes [kg m^2]
  const T JA13_11 = T(0.02875000000000001) + Jp14_11 + T(1.35) * Hp14_13 + Hb14_13 * T(1.35);
  const T JA13_12 = Jp14_12 - T(0.184) + T(1.35) * Hp14_23 - Hb14_13 * T(0.3);
  const T minus_JA13_13 = T(0.004600000000000001) + Hb14_11 * T(1.35) - Hb14_12 * T(0.3);
  const T JA13_22 = T(0.30475) + Jp14_22 - T(0.3) * Hp14_23 - Hb14_23 * T(0.3);
  const T minus_JA13_23 = T(0.10695) + Hb14_21 * T(1.35) - Hb14_22 * T(0.3);
  const T minus_JA13_33 = Hb14_31 * T(1.35) - Hb14_32 * T(0.3);
  // g13 = G13 + gp14: force that drives it, home axes [N]
  const T g13_1 = gp14_1 - minus_G13_1;
  const T g13_2 = gp14_2 - minus_G13_2;
  const T g13_3 = gt14_3 - minus_G13_3;
  // n13 = q14~ gp14 + N13 + np14: moment that drives it, body axes [N m]
  const T n13_1 = np14_1 - minus_N13_1 + T(1.35) * gt14_3;
  const T n13_2 = np14_2 - minus_N13_2 - T(0.3) * gt14_3;
  const T n13_3 = T(0.3) * gp14_2 - (minus_N13_3 + u.tau_14) - T(1.35) * gp14_1;
  // invD13 = D13^-1: 1/D
  const T invD13 = T(1) / JA13_22;
  // kB13 = invD13 B13: B/D
  const T kB13_1 = invD13 * HA13_21;
  const T kB13_2 = invD13 * Hb14_22;
  const T kB13_3 = invD13 * HA13_23;
  // kK13 = invD13 K13: K/D
  const T kK13_1 = invD13 * JA13_12;
  const T minus_kK13_3 = invD13 * minus_JA13_23;
  // u_13 = b13 . n13 + tau_body_13_: drives it [N m], [N]
  const T u_13 = n13_2 + u.tau_13;
  // v13 = invD13 u_13: u/D
  const T v13 = invD13 * u_13;
  // M13 = Mp14 - kB13 B13^T: MA less what the turn takes up [kg]
  const T M13_11 = Mp14_11 - kB13_1 * HA13_21;
  const T M13_12 = Mp14_12 - kB13_1 * Hb14_22;
  const T M13_13 = Mp14_13 - kB13_1 * HA13_23;
  const T M13_22 = Mp14_22 - kB13_2 * Hb14_22;
  const T M13_23 = Mp14_23 - kB13_2 * HA13_23;
  const T M13_33 = M14_33 - kB13_3 * HA13_23;
  // H13 = P_b13 (HA13 - kK13 B13^T): HA less what the turn takes up [kg m]
  const T H13_11 = Hb14_11 - kK13_1 * HA13_21;
  const T H13_12 = HA13_12 - kK13_1 * Hb14_22;
  const T H13_13 = Hb14_13 - kK13_1 * HA13_23;
  const T H13_31 = Hb14_31 + minus_kK13_3 * HA13_21;
  const T H13_32 = HA13_32 + minus_kK13_3 * Hb14_22;
  const T H13_33 = Hb14_33 + minus_kK13_3 * HA13_23;
  // J13 = P_b13 (JA13 - kK13 K13^T) P_b13: JA less what the turn takes up [kg m^2]
  const T J13_11 = JA13_11 - kK13_1 * JA13_12;
  const T J13_13 = kK13_1 * minus_JA13_23 - minus_JA13_13;
  const T minus_J13_33 = minus_JA13_33 + minus_kK13_3 * minus_JA13_23;
  // gt13 = g13 - v13 B13: force with the turn solved [N]
  const T gt13_1 = g13_1 - v13 * HA13_21;
  const T gt13_2 = g13_2 - v13 * Hb14_22;
  const T gt13_3 = g13_3 - v13 * HA13_23;
  // nt13 = -tau_body_13_ b13 + P_b13 (n13 - v13 K13): moment with the turn solved [N m]
  const T nt13_1 = n13_1 - v13 * JA13_12;
  const T nt13_3 = n13_3 + v13 * minus_JA13_23;
  // Mp13 = E13^T M13 E13: M passed on, lower body's axes [kg]
  const T b13_1 = T(2) * E13_11;
  const T b13_2 = minus_E13_13 * (M13_33 - M13_11) + b13_1 * M13_13;
  const T b13_3 = minus_E13_13 * b13_2;
  const T Mp13_11 = M13_11 + b13_3;
  const T Mp13_12 = minus_E13_13 * M13_23 + E13_11 * M13_12;
  const T Mp13_13 = E13_11 * b13_2 - M13_13;
  const T Mp13_23 = E13_11 * M13_23 - minus_E13_13 * M13_12;
  const T Mp13_33 = M13_33 - b13_3;
  // gp13 = E13^T gt13: force passed on, lower body's axes [N]
  const T gp13_1 = E13_11 * gt13_1 + minus_E13_13 * gt13_3;
  const T gp13_3 = E13_11 * gt13_3 - minus_E13_13 * gt13_1;
  // Hp13 = E13^T H13 E13: H passed on, lower body's axes [kg m]
  const T b13_4 = minus_E13_13 * (H13_33 - H13_11) + E13_11 * (H13_31 + H13_13);
  const T b13_5 = minus_E13_13 * b13_4;
  const T Hp13_11 = H13_11 + b13_5;
  const T Hp13_12 = minus_E13_13 * H13_32 + E13_11 * H13_12;
  const T b13_6 = E13_11 * b13_4;
  const T Hp13_13 = b13_6 - H13_31;
  const T Hp13_31 = b13_6 - H13_13;
  const T Hp13_32 = E13_11 * H13_32 - minus_E13_13 * H13_12;
  const T Hp13_33 = H13_33 - b13_5;
  // Jp13 = E13^T J13 E13: J passed on, lower body's axes [kg m^2]
  const T b13_7 = b13_1 * J13_13 - minus_E13_13 * (minus_J13_33 + J13_11);
  const T b13_8 = minus_E13_13 * b13_7;
  const T Jp13_11 = J13_11 + b13_8;
  const T Jp13_13 = E13_11 * b13_7 - J13_13;
  const T minus_Jp13_33 = minus_J13_33 + b13_8;
  // np13 = E13^T nt13: moment passed on, lower body's axes [N m]
  const T np13_1 = E13_11 * nt13_1 + minus_E13_13 * nt13_3;
  const T np13_3 = E13_11 * nt13_3 - minus_E13_13 * nt13_1;
  // Hb13 = q13~ Mp13 + Hp13: H of the joint at the lower body's origin, its axes
  const T b13_9 = T(0.1) * Mp13_12;
  const T Hb13_11 = Hp13_11 - b13_9;
  const T Hb13_12 = Hp13_12 - T(0.1) * M13_22;
  const T Hb13_13 = Hp13_13 - T(0.1) * Mp13_23;
  const T Hb13_21 = T(0.1) * Mp13_11 - T(0.6) * Mp13_13;
  const T b13_10 = T(0.6) * Mp13_23;
  const T Hb13_22 = b13_9 - b13_10;
  const T Hb13_23 = T(0.1) * Mp13_13 - T(0.6) * Mp13_33;
  const T Hb13_31 = Hp13_31 + T(0.6) * Mp13_12;
  const T Hb13_32 = Hp13_32 + T(0.6) * M13_22;
  const T Hb13_33 = b13_10 + Hp13_33;

  // ---- body 12 (body_12) and what it carries
  // HA12 = h_own_12~ + Hb13: moment for an acceleration of the origin, body axes [kg m]
  const T HA12_12 = Hb13_12 - T(0.34);
  const T HA12_13 = T(2.395) + Hb13_13;
  const T HA12_21 = T(0.34) + Hb13_21;
  const T HA12_31 = Hb13_31 - T(2.395);
  // JA12 = q13~ Hp13^T + J_own_12 + Jp13 - Hb13 q13~: moment for an angular acceleration, body axes [kg m^2]
  const T JA12_11 = T(2.20525) + Jp13_11 - T(0.1) * Hp13_12 - Hb13_12 * T(0.1);
  const T minus_JA12_12 = T(1.3379999999999999) + Hb13_13 * T(0.6) - Hb13_11 * T(0.1);
  const T JA12_13 = Jp13_13 - T(0.1754) - T(0.1) * Hp13_32 + Hb13_12 * T(0.6);
  const T minus_JA12_22 = Hb13_23 * T(0.6) - Hb13_21 * T(0.1);
  const T JA12_23 = T(0.1) * Hp13_31 - T(0.2263) - T(0.6) * Hp13_33 + Hb13_22 * T(0.6);
  const T JA12_33 = T(1.84025) - minus_Jp13_33 + T(0.6) * Hp13_32 + Hb13_32 * T(0.6);
  // g12 = G12 + gp13: force that drives it, home axes [N]
  const T g12_1 = gp13_1 - minus_G12_1;
  const T g12_2 = gt13_2 - minus_G12_2;
  const T g12_3 = gp13_3 - minus_G12_3;
  // n12 = q13~ gp13 + N12 + np13: moment that drives it, body axes [N m]
  const T n12_1 = np13_1 - minus_N12_1 - T(0.1) * gt13_2;
  const T n12_2 = T(0.1) * gp13_1 - (minus_N12_2 + u.tau_13) - T(0.6) * gp13_3;
  const T n12_3 = np13_3 - minus_N12_3 + T(0.6) * gt13_2;
  // invD12 = D12^-1: 1/D
  const T invD12 = T(1) / JA12_11;
  // kB12 = invD12 B12: B/D
  const T kB12_1 = invD12 * Hb13_11;
  const T kB12_2 = invD12 * HA12_12;
  const T kB12_3 = invD12 * HA12_13;
  // kK12 = invD12 K12: K/D
  const T minus_kK12_2 = invD12 * minus_JA12_12;
  const T kK12_3 = invD12 * JA12_13;
  // u_12 = b12 . n12 + tau_body_12_: drives it [N m], [N]
  const T u_12 = n12_1 + u.tau_12;
  // v12 = invD12 u_12: u/D
  const T v12 = invD12 * u_12;
  // M12 = Mp13 - kB12 B12^T: MA less what the turn takes up [kg]
  const T M12_11 = Mp13_11 - kB12_1 * Hb13_11;
  const T M12_12 = Mp13_12 - kB12_1 * HA12_12;
  const T M12_13 = Mp13_13 - kB12_1 * HA12_13;
  const T M12_22 = M13_22 - kB12_2 * HA12_12;
  const T M12_23 = Mp13_23 - kB12_2 * HA12_13;
  const T M12_33 = Mp13_33 - kB12_3 * HA12_13;
  // H12 = P_b12 (HA12 - kK12 B12^T): HA less what the turn takes up [kg m]
  const T H12_21 = HA12_21 + minus_kK12_2 * Hb13_11;
  const T H12_22 = Hb13_22 + minus_kK12_2 * HA12_12;
  const T H12_23 = Hb13_23 + minus_kK12_2 * HA12_13;
  const T H12_31 = HA12_31 - kK12_3 * Hb13_11;
  const T H12_32 = Hb13_32 - kK12_3 * HA12_12;
  const T H12_33 = Hb13_33 - kK12_3 * HA12_13;
  // J12 = P_b12 (JA12 - kK12 K12^T) P_b12: JA less what the turn takes up [kg m^2]
  const T minus_J12_22 = minus_JA12_22 + minus_kK12_2 * minus_JA12_12;
  const T J12_23 = JA12_23 + minus_kK12_2 * JA12_13;
  const T J12_33 = JA12_33 - kK12_3 * JA12_13;
  // gt12 = g12 - v12 B12: force with the turn solved [N]
  const T gt12_1 = g12_1 - v12 * Hb13_11;
  const T gt12_2 = g12_2 - v12 * HA12_12;
  const T gt12_3 = g12_3 - v12 * HA12_13;
  // nt12 = -tau_body_12_ b12 + P_b12 (n12 - v12 K12): moment with the turn solved [N m]
  const T nt12_2 = n12_2 + v12 * minus_JA12_12;
  const T nt12_3 = n12_3 - v12 * JA12_13;
  // Mp12 = E12^T M12 E12: M passed on, lower body's axes [kg]
  const T Mp12_12 = E12_22 * M12_12 - E12_23 * M12_13;
  const T Mp12_13 = E12_23 * M12_12 + E12_22 * M12_13;
  const T b12_1 = T(2) * E12_22;
  const T b12_2 = E12_23 * (M12_22 - M12_33) + b12_1 * M12_23;
  const T b12_3 = E12_23 * b12_2;
  const T Mp12_22 = M12_22 - b12_3;
  const T Mp12_23 = E12_22 * b12_2 - M12_23;
  const T Mp12_33 = M12_33 + b12_3;
  // gp12 = E12^T gt12: force passed on, lower body's axes [N]
  const T gp12_2 = E12_22 * gt12_2 - E12_23 * gt12_3;
  const T gp12_3 = E12_23 * gt12_2 + E12_22 * gt12_3;
  // Hp12 = E12^T H12 E12: H passed on, lower body's axes [kg m]
  const T Hp12_21 = E12_22 * H12_21 - E12_23 * H12_31;
  const T b12_4 = E12_23 * (H12_22 - H12_33) + E12_22 * (H12_23 + H12_32);
  const T b12_5 = E12_23 * b12_4;
  const T Hp12_22 = H12_22 - b12_5;
  const T b12_6 = E12_22 * b12_4;
  const T Hp12_23 = b12_6 - H12_32;
  const T Hp12_31 = E12_23 * H12_21 + E12_22 * H12_31;
  const T Hp12_32 = b12_6 - H12_23;
  const T Hp12_33 = H12_33 + b12_5;
  // Jp12 = E12^T J12 E12: J passed on, lower body's axes [kg m^2]
  const T b12_7 = b12_1 * J12_23 - E12_23 * (minus_J12_22 + J12_33);
  const T b12_8 = E12_23 * b12_7;
  const T minus_Jp12_22 = minus_J12_22 + b12_8;
  const T Jp12_23 = E12_22 * b12_7 - J12_23;
  const T Jp12_33 = J12_33 + b12_8;
  // np12 = E12^T nt12: moment passed on, lower body's axes [N m]
  const T np12_2 = E12_22 * nt12_2 - E12_23 * nt12_3;
  const T np12_3 = E12_23 * nt12_2 + E12_22 * nt12_3;
  // Hb12 = q12~ Mp12 + Hp12: H of the joint at the lower body's origin, its axes
  const T b12_9 = T(0.6) * Mp12_13;
  const T b12_10 = T(0.2) * Mp12_12;
  const T Hb12_11 = b12_9 - b12_10;
  const T Hb12_12 = T(0.6) * Mp12_23 - T(0.2) * Mp12_22;
  const T Hb12_13 = T(0.6) * Mp12_33 - T(0.2) * Mp12_23;
  const T Hb12_21 = Hp12_21 + T(0.2) * M12_11;
  const T Hb12_22 = b12_10 + Hp12_22;
  const T Hb12_23 = Hp12_23 + T(0.2) * Mp12_13;
  const T Hb12_31 = Hp12_31 - T(0.6) * M12_11;
  const T Hb12_32 = Hp12_32 - T(0.6) * Mp12_12;
  const T Hb12_33 = Hp12_33 - b12_9;

  // ---- body 11 (body_11) and what it carries
  // MA11 = m_all_11 one + Mp12: force for an acceleration of the origin, home axes [kg]
  const T MA11_11 = T(6.6) + M12_11;
  const T MA11_22 = T(6.6) + Mp12_22;
  const T MA11_33 = T(6.6) + Mp12_33;
  // HA11 = h_all_11~ + Hb12: moment for an acceleration of the origin, body axes [kg m]
  const T HA11_12 = Hb12_12 - T(1.215);
  const T HA11_13 = T(3.12) + Hb12_13;
  const T HA11_21 = T(1.215) + Hb12_21;
  const T HA11_23 = Hb12_23 - T(2.4699999999999998);
  const T HA11_31 = Hb12_31 - T(3.12);
  const T HA11_32 = T(2.4699999999999998) + Hb12_32;
  // JA11 = q12~ Hp12^T + J_all_11 + Jp12 - Hb12 q12~: moment for an angular acceleration, body axes [kg m^2]
  const T JA11_11 = T(2.14125) + Hb12_13 * T(0.6) - Hb12_12 * T(0.2);
  const T JA11_12 = T(0.6) * Hp12_23 - T(1.3875) - T(0.2) * Hp12_22 + Hb12_11 * T(0.2);
  const T JA11_13 = T(0.6) * Hp12_33 - T(0.4772) - T(0.2) * Hp12_32 - Hb12_11 * T(0.6);
  const T JA11_22 = T(1.97275) - minus_Jp12_22 + T(0.2) * Hp12_21 + Hb12_21 * T(0.2);
  const T JA11_23 = Jp12_23 - T(0.6114) + T(0.2) * Hp12_31 - Hb12_21 * T(0.6);
  const T JA11_33 = T(3.3655) + Jp12_33 - T(0.6) * Hp12_31 - Hb12_31 * T(0.6);
  // g11 = G11 + gp12: force that drives it, home axes [N]
  const T g11_1 = gt12_1 - minus_G11_1;
  const T g11_2 = gp12_2 - minus_G11_2;
  const T g11_3 = gp12_3 - minus_G11_3;
  // n11 = q12~ gp12 + N11 + np12: moment that drives it, body axes [N m]
  const T n11_1 = T(0.6) * gp12_3 - (minus_N11_1 + u.tau_12) - T(0.2) * gp12_2;
  const T n11_2 = np12_2 - minus_N11_2 + T(0.2) * gt12_1;
  const T n11_3 = np12_3 - minus_N11_3 - T(0.6) * gt12_1;
  // invD11 = D11^-1: 1/D
  const T invD11 = T(1) / JA11_33;
  // kB11 = invD11 B11: B/D
  const T kB11_1 = invD11 * HA11_31;
  const T kB11_2 = invD11 * HA11_32;
  const T kB11_3 = invD11 * Hb12_33;
  // kK11 = invD11 K11: K/D
  const T kK11_1 = invD11 * JA11_13;
  const T kK11_2 = invD11 * JA11_23;
  // u_11 = b11 . n11 + tau_body_11_: drives it [N m], [N]
  const T u_11 = n11_3 + u.tau_11;
  // v11 = invD11 u_11: u/D
  const T v11 = invD11 * u_11;
  // M11 = MA11 - kB11 B11^T: MA less what the turn takes up [kg]
  const T M11_11 = MA11_11 - kB11_1 * HA11_31;
  const T M11_12 = Mp12_12 - kB11_1 * HA11_32;
  const T M11_13 = Mp12_13 - kB11_1 * Hb12_33;
  const T M11_22 = MA11_22 - kB11_2 * HA11_32;
  const T M11_23 = Mp12_23 - kB11_2 * Hb12_33;
  const T M11_33 = MA11_33 - kB11_3 * Hb12_33;
  // H11 = P_b11 (HA11 - kK11 B11^T): HA less what the turn takes up [kg m]
  const T H11_11 = Hb12_11 - kK11_1 * HA11_31;
  const T H11_12 = HA11_12 - kK11_1 * HA11_32;
  const T H11_13 = HA11_13 - kK11_1 * Hb12_33;
  const T H11_21 = HA11_21 - kK11_2 * HA11_31;
  const T H11_22 = Hb12_22 - kK11_2 * HA11_32;
  const T H11_23 = HA11_23 - kK11_2 * Hb12_33;
  // J11 = P_b11 (JA11 - kK11 K11^T) P_b11: JA less what the turn takes up [kg m^2]
  const T J11_11 = JA11_11 - kK11_1 * JA11_13;
  const T J11_12 = JA11_12 - kK11_1 * JA11_23;
  const T J11_22 = JA11_22 - kK11_2 * JA11_23;
  // gt11 = g11 - v11 B11: force with the turn solved [N]
  const T gt11_1 = g11_1 - v11 * HA11_31;
  const T gt11_2 = g11_2 - v11 * HA11_32;
  const T gt11_3 = g11_3 - v11 * Hb12_33;
  // nt11 = -tau_body_11_ b11 + P_b11 (n11 - v11 K11): moment with the turn solved [N m]
  const T nt11_1 = n11_1 - v11 * JA11_13;
  const T nt11_2 = n11_2 - v11 * JA11_23;
  // Mp11 = E11^T M11 E11: M passed on, lower body's axes [kg]
  const T b11_1 = T(2) * E11_11;
  const T b11_2 = E11_12 * (M11_11 - M11_22) + b11_1 * M11_12;
  const T b11_3 = E11_12 * b11_2;
  const T Mp11_11 = M11_11 - b11_3;
  const T Mp11_12 = E11_11 * b11_2 - M11_12;
  const T Mp11_13 = E11_11 * M11_13 - E11_12 * M11_23;
  const T Mp11_22 = M11_22 + b11_3;
  const T Mp11_23 = E11_12 * M11_13 + E11_11 * M11_23;
  // gp11 = E11^T gt11: force passed on, lower body's axes [N]
  const T gp11_1 = E11_11 * gt11_1 - E11_12 * gt11_2;
  const T gp11_2 = E11_12 * gt11_1 + E11_11 * gt11_2;
  // Hp11 = E11^T H11 E11: H passed on, lower body's axes [kg m]
  const T b11_4 = E11_12 * (H11_11 - H11_22) + E11_11 * (H11_12 + H11_21);
  const T b11_5 = E11_12 * b11_4;
  const T Hp11_11 = H11_11 - b11_5;
  const T b11_6 = E11_11 * b11_4;
  const T Hp11_12 = b11_6 - H11_21;
  const T Hp11_13 = E11_11 * H11_13 - E11_12 * H11_23;
  const T Hp11_21 = b11_6 - H11_12;
  const T Hp11_22 = H11_22 + b11_5;
  const T Hp11_23 = E11_12 * H11_13 + E11_11 * H11_23;
  // Jp11 = E11^T J11 E11: J passed on, lower body's axes [kg m^2]
  const T b11_7 = E11_12 * (J11_11 - J11_22) + b11_1 * J11_12;
  const T b11_8 = E11_12 * b11_7;
  const T Jp11_11 = J11_11 - b11_8;
  const T Jp11_12 = E11_11 * b11_7 - J11_12;
  const T Jp11_22 = J11_22 + b11_8;
  // np11 = E11^T nt11: moment passed on, lower body's axes [N m]
  const T np11_1 = E11_11 * nt11_1 - E11_12 * nt11_2;
  const T np11_2 = E11_12 * nt11_1 + E11_11 * nt11_2;
  // Hb11 = q11~ Mp11 + Hp11: H of the joint at the lower body's origin, its axes
  const T b11_9 = T(1.05) * Mp11_13;
  const T Hb11_11 = b11_9 + Hp11_11;
  const T Hb11_12 = Hp11_12 + T(1.05) * Mp11_23;
  const T Hb11_13 = Hp11_13 + T(1.05) * M11_33;
  const T Hb11_21 = Hp11_21 - T(0.3) * Mp11_13;
  const T b11_10 = T(0.3) * Mp11_23;
  const T Hb11_22 = Hp11_22 - b11_10;
  const T Hb11_23 = Hp11_23 - T(0.3) * M11_33;
  const T Hb11_31 = T(0.3) * Mp11_12 - T(1.05) * Mp11_11;
  const T Hb11_32 = T(0.3) * Mp11_22 - T(1.05) * Mp11_12;
  const T Hb11_33 = b11_10 - b11_9;

  // ---- body 10 (body_10) and what it carries
  // HA10 = h_own_10~ + Hb11: moment for an acceleration of the origin, body axes [kg m]
  const T HA10_12 = Hb11_12 - T(0.1);
  const T HA10_21 = T(0.1) + Hb11_21;
  const T HA10_23 = Hb11_23 - T(0.2);
  const T HA10_32 = T(0.2) + Hb11_32;
  // JA10 = q11~ Hp11^T + J_own_10 + Jp11 - Hb11 q11~: moment for an angular acceleration, body axes [kg m^2]
  const T JA10_11 = T(0.025000000000000005) + Jp11_11 + T(1.05) * Hp11_13 + Hb11_13 * T(1.05);
  const T JA10_12 = Jp11_12 - T(0.13) + T(1.05) * Hp11_23 - Hb11_13 * T(0.3);
  const T minus_JA10_13 = T(0.004000000000000001) + Hb11_11 * T(1.05) - Hb11_12 * T(0.3);
  const T JA10_22 = T(0.265) + Jp11_22 - T(0.3) * Hp11_23 - Hb11_23 * T(0.3);
  const T minus_JA10_23 = T(0.078) + Hb11_21 * T(1.05) - Hb11_22 * T(0.3);
  const T minus_JA10_33 = Hb11_31 * T(1.05) - Hb11_32 * T(0.3);
  // g10 = G10 + gp11: force that drives it, home axes [N]
  const T g10_1 = gp11_1 - minus_G10_1;
  const T g10_2 = gp11_2 - minus_G10_2;
  const T g10_3 = gt11_3 - minus_G10_3;
  // n10 = q11~ gp11 + N10 + np11: moment that drives it, body axes [N m]
  const T n10_1 = np11_1 - minus_N10_1 + T(1.05) * gt11_3;
  const T n10_2 = np11_2 - minus_N10_2 - T(0.3) * gt11_3;
  const T n10_3 = T(0.3) * gp11_2 - (minus_N10_3 + u.tau_11) - T(1.05) * gp11_1;
  // invD10 = D10^-1: 1/D
  const T invD10 = T(1) / JA10_22;
  // kB10 = invD10 B10: B/D
  const T kB10_1 = invD10 * HA10_21;
  const T kB10_2 = invD10 * Hb11_22;
  const T kB10_3 = invD10 * HA10_23;
  // kK10 = invD10 K10: K/D
  const T kK10_1 = invD10 * JA10_12;
  const T minus_kK10_3 = invD10 * minus_JA10_23;
  // u_10 = b10 . n10 + tau_body_10_: drives it [N m], [N]
  const T u_10 = n10_2 + u.tau_10;
  // v10 = invD10 u_10: u/D
  const T v10 = invD10 * u_10;
  // M10 = Mp11 - kB10 B10^T: MA less what the turn takes up [kg]
  const T M10_11 = Mp11_11 - kB10_1 * HA10_21;
  const T M10_12 = Mp11_12 - kB10_1 * Hb11_22;
  const T M10_13 = Mp11_13 - kB10_1 * HA10_23;
  const T M10_22 = Mp11_22 - kB10_2 * Hb11_22;
  const T M10_23 = Mp11_23 - kB10_2 * HA10_23;
  const T M10_33 = M11_33 - kB10_3 * HA10_23;
  // H10 = P_b10 (HA10 - kK10 B10^T): HA less what the turn takes up [kg m]
  const T H10_11 = Hb11_11 - kK10_1 * HA10_21;
  const T H10_12 = HA10_12 - kK10_1 * Hb11_22;
  const T H10_13 = Hb11_13 - kK10_1 * HA10_23;
  const T H10_31 = Hb11_31 + minus_kK10_3 * HA10_21;
  const T H10_32 = HA10_32 + minus_kK10_3 * Hb11_22;
  const T H10_33 = Hb11_33 + minus_kK10_3 * HA10_23;
  // J10 = P_b10 (JA10 - kK10 K10^T) P_b10: JA less what the turn takes up [kg m^2]
  const T J10_11 = JA10_11 - kK10_1 * JA10_12;
  const T J10_13 = kK10_1 * minus_JA10_23 - minus_JA10_13;
  const T minus_J10_33 = minus_JA10_33 + minus_kK10_3 * minus_JA10_23;
  // gt10 = g10 - v10 B10: force with the turn solved [N]
  const T gt10_1 = g10_1 - v10 * HA10_21;
  const T gt10_2 = g10_2 - v10 * Hb11_22;
  const T gt10_3 = g10_3 - v10 * HA10_23;
  // nt10 = -tau_body_10_ b10 + P_b10 (n10 - v10 K10): moment with the turn solved [N m]
  const T nt10_1 = n10_1 - v10 * JA10_12;
  const T nt10_3 = n10_3 + v10 * minus_JA10_23;
  // Mp10 = E10^T M10 E10: M passed on, lower body's axes [kg]
  const T b10_1 = T(2) * E10_11;
  const T b10_2 = minus_E10_13 * (M10_33 - M10_11) + b10_1 * M10_13;
  const T b10_3 = minus_E10_13 * b10_2;
  const T Mp10_11 = M10_11 + b10_3;
  const T Mp10_12 = minus_E10_13 * M10_23 + E10_11 * M10_12;
  const T Mp10_13 = E10_11 * b10_2 - M10_13;
  const T Mp10_23 = E10_11 * M10_23 - minus_E10_13 * M10_12;
  const T Mp10_33 = M10_33 - b10_3;
  // gp10 = E10^T gt10: force passed on, lower body's axes [N]
  const T gp10_1 = E10_11 * gt10_1 + minus_E10_13 * gt10_3;
  const T gp10_3 = E10_11 * gt10_3 - minus_E10_13 * gt10_1;
  // Hp10 = E10^T H10 E10: H passed on, lower body's axes [kg m]
  const T b10_4 = minus_E10_13 * (H10_33 - H10_11) + E10_11 * (H10_31 + H10_13);
  const T b10_5 = minus_E10_13 * b10_4;
  const T Hp10_11 = H10_11 + b10_5;
  const T Hp10_12 = minus_E10_13 * H10_32 + E10_11 * H10_12;
  const T b10_6 = E10_11 * b10_4;
  const T Hp10_13 = b10_6 - H10_31;
  const T Hp10_31 = b10_6 - H10_13;
  const T Hp10_32 = E10_11 * H10_32 - minus_E10_13 * H10_12;
  const T Hp10_33 = H10_33 - b10_5;
  // Jp10 = E10^T J10 E10: J passed on, lower body's axes [kg m^2]
  const T b10_7 = b10_1 * J10_13 - minus_E10_13 * (minus_J10_33 + J10_11);
  const T b10_8 = minus_E10_13 * b10_7;
  const T Jp10_11 = J10_11 + b10_8;
  const T Jp10_13 = E10_11 * b10_7 - J10_13;
  const T minus_Jp10_33 = minus_J10_33 + b10_8;
  // np10 = E10^T nt10: moment passed on, lower body's axes [N m]
  const T np10_1 = E10_11 * nt10_1 + minus_E10_13 * nt10_3;
  const T np10_3 = E10_11 * nt10_3 - minus_E10_13 * nt10_1;
  // Hb10 = q10~ Mp10 + Hp10: H of the joint at the lower body's origin, its axes
  const T b10_9 = T(0.1) * Mp10_12;
  const T Hb10_11 = Hp10_11 - b10_9;
  const T Hb10_12 = Hp10_12 - T(0.1) * M10_22;
  const T Hb10_13 = Hp10_13 - T(0.1) * Mp10_23;
  const T Hb10_21 = T(0.1) * Mp10_11 - T(0.6) * Mp10_13;
  const T b10_10 = T(0.6) * Mp10_23;
  const T Hb10_22 = b10_9 - b10_10;
  const T Hb10_23 = T(0.1) * Mp10_13 - T(0.6) * Mp10_33;
  const T Hb10_31 = Hp10_31 + T(0.6) * Mp10_12;
  const T Hb10_32 = Hp10_32 + T(0.6) * M10_22;
  const T Hb10_33 = b10_10 + Hp10_33;

  // ---- body 9 (body_9) and what it carries
  // HA9 = h_own_9~ + Hb10: moment for an acceleration of the origin, body axes [kg m]
  const T HA9_12 = Hb10_12 - T(0.295);
  const T HA9_13 = T(1.78) + Hb10_13;
  const T HA9_21 = T(0.295) + Hb10_21;
  const T HA9_31 = Hb10_31 - T(1.78);
  // JA9 = q10~ Hp10^T + J_own_9 + Jp10 - Hb10 q10~: moment for an angular acceleration, body axes [kg m^2]
  const T JA9_11 = T(1.45075) + Jp10_11 - T(0.1) * Hp10_12 - Hb10_12 * T(0.1);
  const T minus_JA9_12 = T(0.9824999999999999) + Hb10_13 * T(0.6) - Hb10_11 * T(0.1);
  const T JA9_13 = Jp10_13 - T(0.1523) - T(0.1) * Hp10_32 + Hb10_12 * T(0.6);
  const T minus_JA9_22 = Hb10_23 * T(0.6) - Hb10_21 * T(0.1);
  const T JA9_23 = T(0.1) * Hp10_31 - T(0.1666) - T(0.6) * Hp10_33 + Hb10_22 * T(0.6);
  const T JA9_33 = T(1.13525) - minus_Jp10_33 + T(0.6) * Hp10_32 + Hb10_32 * T(0.6);
  // g9 = G9 + gp10: force that drives it, home axes [N]
  const T g9_1 = gp10_1 - minus_G9_1;
  const T g9_2 = gt10_2 - minus_G9_2;
  const T g9_3 = gp10_3 - minus_G9_3;
  // n9 = q10~ gp10 + N9 + np10: moment that drives it, body axes [N m]
  const T n9_1 = np10_1 - minus_N9_1 - T(0.1) * gt10_2;
  const T n9_2 = T(0.1) * gp10_1 - (minus_N9_2 + u.tau_10) - T(0.6) * gp10_3;
  const T n9_3 = np10_3 - minus_N9_3 + T(0.6) * gt10_2;
  // invD9 = D9^-1: 1/D
  const T invD9 = T(1) / JA9_11;
  // kB9 = invD9 B9: B/D
  const T kB9_1 = invD9 * Hb10_11;
  const T kB9_2 = invD9 * HA9_12;
  const T kB9_3 = invD9 * HA9_13;
  // kK9 = invD9 K9: K/D
  const T minus_kK9_2 = invD9 * minus_JA9_12;
  const T kK9_3 = invD9 * JA9_13;
  // u_9 = b9 . n9 + tau_body_9_: drives it [N m], [N]
  const T u_9 = n9_1 + u.tau_9;
  // v9 = invD9 u_9: u/D
  const T v9 = invD9 * u_9;
  // M9 = Mp10 - kB9 B9^T: MA less what the turn takes up [kg]
  const T M9_11 = Mp10_11 - kB9_1 * Hb10_11;
  const T M9_12 = Mp10_12 - kB9_1 * HA9_12;
  const T M9_13 = Mp10_13 - kB9_1 * HA9_13;
  const T M9_22 = M10_22 - kB9_2 * HA9_12;
  const T M9_23 = Mp10_23 - kB9_2 * HA9_13;
  const T M9_33 = Mp10_33 - kB9_3 * HA9_13;
  // H9 = P_b9 (HA9 - kK9 B9^T): HA less what the turn takes up [kg m]
  const T H9_21 = HA9_21 + minus_kK9_2 * Hb10_11;
  const T H9_22 = Hb10_22 + minus_kK9_2 * HA9_12;
  const T H9_23 = Hb10_23 + minus_kK9_2 * HA9_13;
  const T H9_31 = HA9_31 - kK9_3 * Hb10_11;
  const T H9_32 = Hb10_32 - kK9_3 * HA9_12;
  const T H9_33 = Hb10_33 - kK9_3 * HA9_13;
  // J9 = P_b9 (JA9 - kK9 K9^T) P_b9: JA less what the turn takes up [kg m^2]
  const T minus_J9_22 = minus_JA9_22 + minus_kK9_2 * minus_JA9_12;
  const T J9_23 = JA9_23 + minus_kK9_2 * JA9_13;
  const T J9_33 = JA9_33 - kK9_3 * JA9_13;
  // gt9 = g9 - v9 B9: force with the turn solved [N]
  const T gt9_1 = g9_1 - v9 * Hb10_11;
  const T gt9_2 = g9_2 - v9 * HA9_12;
  const T gt9_3 = g9_3 - v9 * HA9_13;
  // nt9 = -tau_body_9_ b9 + P_b9 (n9 - v9 K9): moment with the turn solved [N m]
  const T nt9_2 = n9_2 + v9 * minus_JA9_12;
  const T nt9_3 = n9_3 - v9 * JA9_13;
  // Mp9 = E9^T M9 E9: M passed on, lower body's axes [kg]
  const T Mp9_12 = E9_22 * M9_12 - E9_23 * M9_13;
  const T Mp9_13 = E9_23 * M9_12 + E9_22 * M9_13;
  const T b9_1 = T(2) * E9_22;
  const T b9_2 = E9_23 * (M9_22 - M9_33) + b9_1 * M9_23;
  const T b9_3 = E9_23 * b9_2;
  const T Mp9_22 = M9_22 - b9_3;
  const T Mp9_23 = E9_22 * b9_2 - M9_23;
  const T Mp9_33 = M9_33 + b9_3;
  // gp9 = E9^T gt9: force passed on, lower body's axes [N]
  const T gp9_2 = E9_22 * gt9_2 - E9_23 * gt9_3;
  const T gp9_3 = E9_23 * gt9_2 + E9_22 * gt9_3;
  // Hp9 = E9^T H9 E9: H passed on, lower body's axes [kg m]
  const T Hp9_21 = E9_22 * H9_21 - E9_23 * H9_31;
  const T b9_4 = E9_23 * (H9_22 - H9_33) + E9_22 * (H9_23 + H9_32);
  const T b9_5 = E9_23 * b9_4;
  const T Hp9_22 = H9_22 - b9_5;
  const T b9_6 = E9_22 * b9_4;
  const T Hp9_23 = b9_6 - H9_32;
  const T Hp9_31 = E9_23 * H9_21 + E9_22 * H9_31;
  const T Hp9_32 = b9_6 - H9_23;
  const T Hp9_33 = H9_33 + b9_5;
  // Jp9 = E9^T J9 E9: J passed on, lower body's axes [kg m^2]
  const T b9_7 = b9_1 * J9_23 - E9_23 * (minus_J9_22 + J9_33);
  const T b9_8 = E9_23 * b9_7;
  const T minus_Jp9_22 = minus_J9_22 + b9_8;
  const T Jp9_23 = E9_22 * b9_7 - J9_23;
  const T Jp9_33 = J9_33 + b9_8;
  // np9 = E9^T nt9: moment passed on, lower body's axes [N m]
  const T np9_2 = E9_22 * nt9_2 - E9_23 * nt9_3;
  const T np9_3 = E9_23 * nt9_2 + E9_22 * nt9_3;
  // Hb9 = q9~ Mp9 + Hp9: H of the joint at the lower body's origin, its axes
  const T b9_9 = T(0.45) * Mp9_13;
  const T b9_10 = T(0.2) * Mp9_12;
  const T Hb9_11 = b9_9 - b9_10;
  const T Hb9_12 = T(0.45) * Mp9_23 - T(0.2) * Mp9_22;
  const T Hb9_13 = T(0.45) * Mp9_33 - T(0.2) * Mp9_23;
  const T Hb9_21 = Hp9_21 + T(0.2) * M9_11;
  const T Hb9_22 = b9_10 + Hp9_22;
  const T Hb9_23 = Hp9_23 + T(0.2) * Mp9_13;
  const T Hb9_31 = Hp9_31 - T(0.45) * M9_11;
  const T Hb9_32 = Hp9_32 - T(0.45) * Mp9_12;
  const T Hb9_33 = Hp9_33 - b9_9;

  // ---- body 8 (body_8) and what it carries
  // MA8 = m_all_8 one + Mp9: force for an acceleration of the origin, home axes [kg]
  const T MA8_11 = T(5.7) + M9_11;
  const T MA8_22 = T(5.7) + Mp9_22;
  const T MA8_33 = T(5.7) + Mp9_33;
  // HA8 = h_all_8~ + Hb9: moment for an acceleration of the origin, body axes [kg m]
  const T HA8_12 = Hb9_12 - T(1.05);
  const T HA8_13 = T(2.115) + Hb9_13;
  const T HA8_21 = T(1.05) + Hb9_21;
  const T HA8_23 = Hb9_23 - T(2.14);
  const T HA8_31 = Hb9_31 - T(2.115);
  const T HA8_32 = T(2.14) + Hb9_32;
  // JA8 = q9~ Hp9^T + J_all_8 + Jp9 - Hb9 q9~: moment for an angular acceleration, body axes [kg m^2]
  const T JA8_11 = T(1.23825) + Hb9_13 * T(0.45) - Hb9_12 * T(0.2);
  const T JA8_12 = T(0.45) * Hp9_23 - T(0.909) - T(0.2) * Hp9_22 + Hb9_11 * T(0.2);
  const T JA8_13 = T(0.45) * Hp9_33 - T(0.4136) - T(0.2) * Hp9_32 - Hb9_11 * T(0.45);
  const T JA8_22 = T(1.70725) - minus_Jp9_22 + T(0.2) * Hp9_21 + Hb9_21 * T(0.2);
  const T JA8_23 = Jp9_23 - T(0.4122) + T(0.2) * Hp9_31 - Hb9_21 * T(0.45);
  const T JA8_33 = T(2.3005) + Jp9_33 - T(0.45) * Hp9_31 - Hb9_31 * T(0.45);
  // g8 = G8 + gp9: force that drives it, home axes [N]
  const T g8_1 = gt9_1 - minus_G8_1;
  const T g8_2 = gp9_2 - minus_G8_2;
  const T g8_3 = gp9_3 - minus_G8_3;
  // n8 = q9~ gp9 + N8 + np9: moment that drives it, body axes [N m]
  const T n8_1 = T(0.45) * gp9_3 - (minus_N8_1 + u.tau_9) - T(0.2) * gp9_2;
  const T n8_2 = np9_2 - minus_N8_2 + T(0.2) * gt9_1;
  const T n8_3 = np9_3 - minus_N8_3 - T(0.45) * gt9_1;
  // invD8 = D8^-1: 1/D
  const T invD8 = T(1) / JA8_33;
  // kB8 = invD8 B8: B/D
  const T kB8_1 = invD8 * HA8_31;
  const T kB8_2 = invD8 * HA8_32;
  const T kB8_3 = invD8 * Hb9_33;
  // kK8 = invD8 K8: K/D
  const T kK8_1 = invD8 * JA8_13;
  const T kK8_2 = invD8 * JA8_23;
  // u_8 = b8 . n8 + tau_body_8_: drives it [N m], [N]
  const T u_8 = n8_3 + u.tau_8;
  // v8 = invD8 u_8: u/D
  const T v8 = invD8 * u_8;
  // M8 = MA8 - kB8 B8^T: MA less what the turn takes up [kg]
  const T M8_11 = MA8_11 - kB8_1 * HA8_31;
  const T M8_12 = Mp9_12 - kB8_1 * HA8_32;
  const T M8_13 = Mp9_13 - kB8_1 * Hb9_33;
  const T M8_22 = MA8_22 - kB8_2 * HA8_32;
  const T M8_23 = Mp9_23 - kB8_2 * Hb9_33;
  const T M8_33 = MA8_33 - kB8_3 * Hb9_33;
  // H8 = P_b8 (HA8 - kK8 B8^T): HA less what the turn takes up [kg m]
  const T H8_11 = Hb9_11 - kK8_1 * HA8_31;
  const T H8_12 = HA8_12 - kK8_1 * HA8_32;
  const T H8_13 = HA8_13 - kK8_1 * Hb9_33;
  const T H8_21 = HA8_21 - kK8_2 * HA8_31;
  const T H8_22 = Hb9_22 - kK8_2 * HA8_32;
  const T H8_23 = HA8_23 - kK8_2 * Hb9_33;
  // J8 = P_b8 (JA8 - kK8 K8^T) P_b8: JA less what the turn takes up [kg m^2]
  const T J8_11 = JA8_11 - kK8_1 * JA8_13;
  const T J8_12 = JA8_12 - kK8_1 * JA8_23;
  const T J8_22 = JA8_22 - kK8_2 * JA8_23;
  // gt8 = g8 - v8 B8: force with the turn solved [N]
  const T gt8_1 = g8_1 - v8 * HA8_31;
  const T gt8_2 = g8_2 - v8 * HA8_32;
  const T gt8_3 = g8_3 - v8 * Hb9_33;
  // nt8 = -tau_body_8_ b8 + P_b8 (n8 - v8 K8): moment with the turn solved [N m]
  const T nt8_1 = n8_1 - v8 * JA8_13;
  const T nt8_2 = n8_2 - v8 * JA8_23;
  // Mp8 = E8^T M8 E8: M passed on, lower body's axes [kg]
  const T b8_1 = T(2) * E8_11;
  const T b8_2 = E8_12 * (M8_11 - M8_22) + b8_1 * M8_12;
  const T b8_3 = E8_12 * b8_2;
  const T Mp8_11 = M8_11 - b8_3;
  const T Mp8_12 = E8_11 * b8_2 - M8_12;
  const T Mp8_13 = E8_11 * M8_13 - E8_12 * M8_23;
  const T Mp8_22 = M8_22 + b8_3;
  const T Mp8_23 = E8_12 * M8_13 + E8_11 * M8_23;
  // gp8 = E8^T gt8: force passed on, lower body's axes [N]
  const T gp8_1 = E8_11 * gt8_1 - E8_12 * gt8_2;
  const T gp8_2 = E8_12 * gt8_1 + E8_11 * gt8_2;
  // Hp8 = E8^T H8 E8: H passed on, lower body's axes [kg m]
  const T b8_4 = E8_12 * (H8_11 - H8_22) + E8_11 * (H8_12 + H8_21);
  const T b8_5 = E8_12 * b8_4;
  const T Hp8_11 = H8_11 - b8_5;
  const T b8_6 = E8_11 * b8_4;
  const T Hp8_12 = b8_6 - H8_21;
  const T Hp8_13 = E8_11 * H8_13 - E8_12 * H8_23;
  const T Hp8_21 = b8_6 - H8_12;
  const T Hp8_22 = H8_22 + b8_5;
  const T Hp8_23 = E8_12 * H8_13 + E8_11 * H8_23;
  // Jp8 = E8^T J8 E8: J passed on, lower body's axes [kg m^2]
  const T b8_7 = E8_12 * (J8_11 - J8_22) + b8_1 * J8_12;
  const T b8_8 = E8_12 * b8_7;
  const T Jp8_11 = J8_11 - b8_8;
  const T Jp8_12 = E8_11 * b8_7 - J8_12;
  const T Jp8_22 = J8_22 + b8_8;
  // np8 = E8^T nt8: moment passed on, lower body's axes [N m]
  const T np8_1 = E8_11 * nt8_1 - E8_12 * nt8_2;
  const T np8_2 = E8_12 * nt8_1 + E8_11 * nt8_2;
  // Hb8 = q8~ Mp8 + Hp8: H of the joint at the lower body's origin, its axes
  const T b8_9 = T(0.75) * Mp8_13;
  const T Hb8_11 = b8_9 + Hp8_11;
  const T Hb8_12 = Hp8_12 + T(0.75) * Mp8_23;
  const T Hb8_13 = Hp8_13 + T(0.75) * M8_33;
  const T Hb8_21 = Hp8_21 - T(0.3) * Mp8_13;
  const T b8_10 = T(0.3) * Mp8_23;
  const T Hb8_22 = Hp8_22 - b8_10;
  const T Hb8_23 = Hp8_23 - T(0.3) * M8_33;
  const T Hb8_31 = T(0.3) * Mp8_12 - T(0.75) * Mp8_11;
  const T Hb8_32 = T(0.3) * Mp8_22 - T(0.75) * Mp8_12;
  const T Hb8_33 = b8_10 - b8_9;

  // ---- body 7 (body_7) and what it carries
  // HA7 = h_own_7~ + Hb8: moment for an acceleration of the origin, body axes [kg m]
  const T HA7_12 = Hb8_12 - T(0.085);
  const T HA7_21 = T(0.085) + Hb8_21;
  const T HA7_23 = Hb8_23 - T(0.17);
  const T HA7_32 = T(0.17) + Hb8_32;
  // JA7 = q8~ Hp8^T + J_own_7 + Jp8 - Hb8 q8~: moment for an angular acceleration, body axes [kg m^2]
  const T JA7_11 = T(0.02125) + Jp8_11 + T(0.75) * Hp8_13 + Hb8_13 * T(0.75);
  const T JA7_12 = Jp8_12 - T(0.085) + T(0.75) * Hp8_23 - Hb8_13 * T(0.3);
  const T minus_JA7_13 = T(0.0034000000000000002) + Hb8_11 * T(0.75) - Hb8_12 * T(0.3);
  const T JA7_22 = T(0.22524999999999998) + Jp8_22 - T(0.3) * Hp8_23 - Hb8_23 * T(0.3);
  const T minus_JA7_23 = T(0.05355) + Hb8_21 * T(0.75) - Hb8_22 * T(0.3);
  const T minus_JA7_33 = Hb8_31 * T(0.75) - Hb8_32 * T(0.3);
  // g7 = G7 + gp8: force that drives it, home axes [N]
  const T g7_1 = gp8_1 - minus_G7_1;
  const T g7_2 = gp8_2 - minus_G7_2;
  const T g7_3 = gt8_3 - minus_G7_3;
  // n7 = q8~ gp8 + N7 + np8: moment that drives it, body axes [N m]
  const T n7_1 = np8_1 - minus_N7_1 + T(0.75) * gt8_3;
  const T n7_2 = np8_2 - minus_N7_2 - T(0.3) * gt8_3;
  const T n7_3 = T(0.3) * gp8_2 - (minus_N7_3 + u.tau_8) - T(0.75) * gp8_1;
  // invD7 = D7^-1: 1/D
  const T invD7 = T(1) / JA7_22;
  // kB7 = invD7 B7: B/D
  const T kB7_1 = invD7 * HA7_21;
  const T kB7_2 = invD7 * Hb8_22;
  const T kB7_3 = invD7 * HA7_23;
  // kK7 = invD7 K7: K/D
  const T kK7_1 = invD7 * JA7_12;
  const T minus_kK7_3 = invD7 * minus_JA7_23;
  // u_7 = b7 . n7 + tau_body_7_: drives it [N m], [N]
  const T u_7 = n7_2 + u.tau_7;
  // v7 = invD7 u_7: u/D
  const T v7 = invD7 * u_7;
  // M7 = Mp8 - kB7 B7^T: MA less what the turn takes up [kg]
  const T M7_11 = Mp8_11 - kB7_1 * HA7_21;
  const T M7_12 = Mp8_12 - kB7_1 * Hb8_22;
  const T M7_13 = Mp8_13 - kB7_1 * HA7_23;
  const T M7_22 = Mp8_22 - kB7_2 * Hb8_22;
  const T M7_23 = Mp8_23 - kB7_2 * HA7_23;
  const T M7_33 = M8_33 - kB7_3 * HA7_23;
  // H7 = P_b7 (HA7 - kK7 B7^T): HA less what the turn takes up [kg m]
  const T H7_11 = Hb8_11 - kK7_1 * HA7_21;
  const T H7_12 = HA7_12 - kK7_1 * Hb8_22;
  const T H7_13 = Hb8_13 - kK7_1 * HA7_23;
  const T H7_31 = Hb8_31 + minus_kK7_3 * HA7_21;
  const T H7_32 = HA7_32 + minus_kK7_3 * Hb8_22;
  const T H7_33 = Hb8_33 + minus_kK7_3 * HA7_23;
  // J7 = P_b7 (JA7 - kK7 K7^T) P_b7: JA less what the turn takes up [kg m^2]
  const T J7_11 = JA7_11 - kK7_1 * JA7_12;
  const T J7_13 = kK7_1 * minus_JA7_23 - minus_JA7_13;
  const T minus_J7_33 = minus_JA7_33 + minus_kK7_3 * minus_JA7_23;
  // gt7 = g7 - v7 B7: force with the turn solved [N]
  const T gt7_1 = g7_1 - v7 * HA7_21;
  const T gt7_2 = g7_2 - v7 * Hb8_22;
  const T gt7_3 = g7_3 - v7 * HA7_23;
  // nt7 = -tau_body_7_ b7 + P_b7 (n7 - v7 K7): moment with the turn solved [N m]
  const T nt7_1 = n7_1 - v7 * JA7_12;
  const T nt7_3 = n7_3 + v7 * minus_JA7_23;
  // Mp7 = E7^T M7 E7: M passed on, lower body's axes [kg]
  const T b7_1 = T(2) * E7_11;
  const T b7_2 = minus_E7_13 * (M7_33 - M7_11) + b7_1 * M7_13;
  const T b7_3 = minus_E7_13 * b7_2;
  const T Mp7_11 = M7_11 + b7_3;
  const T Mp7_12 = minus_E7_13 * M7_23 + E7_11 * M7_12;
  const T Mp7_13 = E7_11 * b7_2 - M7_13;
  const T Mp7_23 = E7_11 * M7_23 - minus_E7_13 * M7_12;
  const T Mp7_33 = M7_33 - b7_3;
  // gp7 = E7^T gt7: force passed on, lower body's axes [N]
  const T gp7_1 = E7_11 * gt7_1 + minus_E7_13 * gt7_3;
  const T gp7_3 = E7_11 * gt7_3 - minus_E7_13 * gt7_1;
  // Hp7 = E7^T H7 E7: H passed on, lower body's axes [kg m]
  const T b7_4 = minus_E7_13 * (H7_33 - H7_11) + E7_11 * (H7_31 + H7_13);
  const T b7_5 = minus_E7_13 * b7_4;
  const T Hp7_11 = H7_11 + b7_5;
  const T Hp7_12 = minus_E7_13 * H7_32 + E7_11 * H7_12;
  const T b7_6 = E7_11 * b7_4;
  const T Hp7_13 = b7_6 - H7_31;
  const T Hp7_31 = b7_6 - H7_13;
  const T Hp7_32 = E7_11 * H7_32 - minus_E7_13 * H7_12;
  const T Hp7_33 = H7_33 - b7_5;
  // Jp7 = E7^T J7 E7: J passed on, lower body's axes [kg m^2]
  const T b7_7 = b7_1 * J7_13 - minus_E7_13 * (minus_J7_33 + J7_11);
  const T b7_8 = minus_E7_13 * b7_7;
  const T Jp7_11 = J7_11 + b7_8;
  const T Jp7_13 = E7_11 * b7_7 - J7_13;
  const T minus_Jp7_33 = minus_J7_33 + b7_8;
  // np7 = E7^T nt7: moment passed on, lower body's axes [N m]
  const T np7_1 = E7_11 * nt7_1 + minus_E7_13 * nt7_3;
  const T np7_3 = E7_11 * nt7_3 - minus_E7_13 * nt7_1;
  // Hb7 = q7~ Mp7 + Hp7: H of the joint at the lower body's origin, its axes
  const T b7_9 = T(0.1) * Mp7_12;
  const T Hb7_11 = Hp7_11 - b7_9;
  const T Hb7_12 = Hp7_12 - T(0.1) * M7_22;
  const T Hb7_13 = Hp7_13 - T(0.1) * Mp7_23;
  const T Hb7_21 = T(0.1) * Mp7_11 - T(0.6) * Mp7_13;
  const T b7_10 = T(0.6) * Mp7_23;
  const T Hb7_22 = b7_9 - b7_10;
  const T Hb7_23 = T(0.1) * Mp7_13 - T(0.6) * Mp7_33;
  const T Hb7_31 = Hp7_31 + T(0.6) * Mp7_12;
  const T Hb7_32 = Hp7_32 + T(0.6) * M7_22;
  const T Hb7_33 = b7_10 + Hp7_33;

  // ---- body 6 (body_6) and what it carries
  // HA6 = h_own_6~ + Hb7: moment for an acceleration of the origin, body axes [kg m]
  const T HA6_12 = Hb7_12 - T(0.25);
  const T HA6_13 = T(1.255) + Hb7_13;
  const T HA6_21 = T(0.25) + Hb7_21;
  const T HA6_31 = Hb7_31 - T(1.255);
  // JA6 = q7~ Hp7^T + J_own_6 + Jp7 - Hb7 q7~: moment for an angular acceleration, body axes [kg m^2]
  const T JA6_11 = T(0.91225) + Jp7_11 - T(0.1) * Hp7_12 - Hb7_12 * T(0.1);
  const T minus_JA6_12 = T(0.6809999999999999) + Hb7_13 * T(0.6) - Hb7_11 * T(0.1);
  const T JA6_13 = Jp7_13 - T(0.1292) - T(0.1) * Hp7_32 + Hb7_12 * T(0.6);
  const T minus_JA6_22 = Hb7_23 * T(0.6) - Hb7_21 * T(0.1);
  const T JA6_23 = T(0.1) * Hp7_31 - T(0.1159) - T(0.6) * Hp7_33 + Hb7_22 * T(0.6);
  const T JA6_33 = T(0.64625) - minus_Jp7_33 + T(0.6) * Hp7_32 + Hb7_32 * T(0.6);
  // g6 = G6 + gp7: force that drives it, home axes [N]
  const T g6_1 = gp7_1 - minus_G6_1;
  const T g6_2 = gt7_2 - minus_G6_2;
  const T g6_3 = gp7_3 - minus_G6_3;
  // n6 = q7~ gp7 + N6 + np7: moment that drives it, body axes [N m]
  const T n6_1 = np7_1 - minus_N6_1 - T(0.1) * gt7_2;
  const T n6_2 = T(0.1) * gp7_1 - (minus_N6_2 + u.tau_7) - T(0.6) * gp7_3;
  const T n6_3 = np7_3 - minus_N6_3 + T(0.6) * gt7_2;
  // invD6 = D6^-1: 1/D
  const T invD6 = T(1) / JA6_11;
  // kB6 = invD6 B6: B/D
  const T kB6_1 = invD6 * Hb7_11;
  const T kB6_2 = invD6 * HA6_12;
  const T kB6_3 = invD6 * HA6_13;
  // kK6 = invD6 K6: K/D
  const T minus_kK6_2 = invD6 * minus_JA6_12;
  const T kK6_3 = invD6 * JA6_13;
  // u_6 = b6 . n6 + tau_body_6_: drives it [N m], [N]
  const T u_6 = n6_1 + u.tau_6;
  // v6 = invD6 u_6: u/D
  const T v6 = invD6 * u_6;
  // M6 = Mp7 - kB6 B6^T: MA less what the turn takes up [kg]
  const T M6_11 = Mp7_11 - kB6_1 * Hb7_11;
  const T M6_12 = Mp7_12 - kB6_1 * HA6_12;
  const T M6_13 = Mp7_13 - kB6_1 * HA6_13;
  const T M6_22 = M7_22 - kB6_2 * HA6_12;
  const T M6_23 = Mp7_23 - kB6_2 * HA6_13;
  const T M6_33 = Mp7_33 - kB6_3 * HA6_13;
  // H6 = P_b6 (HA6 - kK6 B6^T): HA less what the turn takes up [kg m]
  const T H6_21 = HA6_21 + minus_kK6_2 * Hb7_11;
  const T H6_22 = Hb7_22 + minus_kK6_2 * HA6_12;
  const T H6_23 = Hb7_23 + minus_kK6_2 * HA6_13;
  const T H6_31 = HA6_31 - kK6_3 * Hb7_11;
  const T H6_32 = Hb7_32 - kK6_3 * HA6_12;
  const T H6_33 = Hb7_33 - kK6_3 * HA6_13;
  // J6 = P_b6 (JA6 - kK6 K6^T) P_b6: JA less what the turn takes up [kg m^2]
  const T minus_J6_22 = minus_JA6_22 + minus_kK6_2 * minus_JA6_12;
  const T J6_23 = JA6_23 + minus_kK6_2 * JA6_13;
  const T J6_33 = JA6_33 - kK6_3 * JA6_13;
  // gt6 = g6 - v6 B6: force with the turn solved [N]
  const T gt6_1 = g6_1 - v6 * Hb7_11;
  const T gt6_2 = g6_2 - v6 * HA6_12;
  const T gt6_3 = g6_3 - v6 * HA6_13;
  // nt6 = -tau_body_6_ b6 + P_b6 (n6 - v6 K6): moment with the turn solved [N m]
  const T nt6_2 = n6_2 + v6 * minus_JA6_12;
  const T nt6_3 = n6_3 - v6 * JA6_13;
  // Mp6 = E6^T M6 E6: M passed on, lower body's axes [kg]
  const T Mp6_12 = E6_22 * M6_12 - E6_23 * M6_13;
  const T Mp6_13 = E6_23 * M6_12 + E6_22 * M6_13;
  const T b6_1 = T(2) * E6_22;
  const T b6_2 = E6_23 * (M6_22 - M6_33) + b6_1 * M6_23;
  const T b6_3 = E6_23 * b6_2;
  const T Mp6_22 = M6_22 - b6_3;
  const T Mp6_23 = E6_22 * b6_2 - M6_23;
  const T Mp6_33 = M6_33 + b6_3;
  // gp6 = E6^T gt6: force passed on, lower body's axes [N]
  const T gp6_2 = E6_22 * gt6_2 - E6_23 * gt6_3;
  const T gp6_3 = E6_23 * gt6_2 + E6_22 * gt6_3;
  // Hp6 = E6^T H6 E6: H passed on, lower body's axes [kg m]
  const T Hp6_21 = E6_22 * H6_21 - E6_23 * H6_31;
  const T b6_4 = E6_23 * (H6_22 - H6_33) + E6_22 * (H6_23 + H6_32);
  const T b6_5 = E6_23 * b6_4;
  const T Hp6_22 = H6_22 - b6_5;
  const T b6_6 = E6_22 * b6_4;
  const T Hp6_23 = b6_6 - H6_32;
  const T Hp6_31 = E6_23 * H6_21 + E6_22 * H6_31;
  const T Hp6_32 = b6_6 - H6_23;
  const T Hp6_33 = H6_33 + b6_5;
  // Jp6 = E6^T J6 E6: J passed on, lower body's axes [kg m^2]
  const T b6_7 = b6_1 * J6_23 - E6_23 * (minus_J6_22 + J6_33);
  const T b6_8 = E6_23 * b6_7;
  const T minus_Jp6_22 = minus_J6_22 + b6_8;
  const T Jp6_23 = E6_22 * b6_7 - J6_23;
  const T Jp6_33 = J6_33 + b6_8;
  // np6 = E6^T nt6: moment passed on, lower body's axes [N m]
  const T np6_2 = E6_22 * nt6_2 - E6_23 * nt6_3;
  const T np6_3 = E6_23 * nt6_2 + E6_22 * nt6_3;
  // Hb6 = q6~ Mp6 + Hp6: H of the joint at the lower body's origin, its axes
  const T b6_9 = T(0.3) * Mp6_13;
  const T b6_10 = T(0.2) * Mp6_12;
  const T Hb6_11 = b6_9 - b6_10;
  const T Hb6_12 = T(0.3) * Mp6_23 - T(0.2) * Mp6_22;
  const T Hb6_13 = T(0.3) * Mp6_33 - T(0.2) * Mp6_23;
  const T Hb6_21 = Hp6_21 + T(0.2) * M6_11;
  const T Hb6_22 = b6_10 + Hp6_22;
  const T Hb6_23 = Hp6_23 + T(0.2) * Mp6_13;
  const T Hb6_31 = Hp6_31 - T(0.3) * M6_11;
  const T Hb6_32 = Hp6_32 - T(0.3) * Mp6_12;
  const T Hb6_33 = Hp6_33 - b6_9;

  // ---- body 5 (body_5) and what it carries
  // MA5 = m_all_5 one + Mp6: force for an acceleration of the origin, home axes [kg]
  const T MA5_11 = T(4.8) + M6_11;
  const T MA5_22 = T(4.8) + Mp6_22;
  const T MA5_33 = T(4.8) + Mp6_33;
  // HA5 = h_all_5~ + Hb6: moment for an acceleration of the origin, body axes [kg m]
  const T HA5_12 = Hb6_12 - T(0.885);
  const T HA5_13 = T(1.29) + Hb6_13;
  const T HA5_21 = T(0.885) + Hb6_21;
  const T HA5_23 = Hb6_23 - T(1.81);
  const T HA5_31 = Hb6_31 - T(1.29);
  const T HA5_32 = T(1.81) + Hb6_32;
  // JA5 = q6~ Hp6^T + J_all_5 + Jp6 - Hb6 q6~: moment for an angular acceleration, body axes [kg m^2]
  const T JA5_11 = T(0.67275) + Hb6_13 * T(0.3) - Hb6_12 * T(0.2);
  const T JA5_12 = T(0.3) * Hp6_23 - T(0.5205) - T(0.2) * Hp6_22 + Hb6_11 * T(0.2);
  const T JA5_13 = T(0.3) * Hp6_33 - T(0.35000000000000003) - T(0.2) * Hp6_32 - Hb6_11 * T(0.3);
  const T JA5_22 = T(1.4417499999999999) - minus_Jp6_22 + T(0.2) * Hp6_21 + Hb6_21 * T(0.2);
  const T JA5_23 = Jp6_23 - T(0.249) + T(0.2) * Hp6_31 - Hb6_21 * T(0.3);
  const T JA5_33 = T(1.573) + Jp6_33 - T(0.3) * Hp6_31 - Hb6_31 * T(0.3);
  // g5 = G5 + gp6: force that drives it, home axes [N]
  const T g5_1 = gt6_1 - minus_G5_1;
  const T g5_2 = gp6_2 - minus_G5_2;
  const T g5_3 = gp6_3 - minus_G5_3;
  // n5 = q6~ gp6 + N5 + np6: moment that drives it, body axes [N m]
  const T n5_1 = T(0.3) * gp6_3 - (minus_N5_1 + u.tau_6) - T(0.2) * gp6_2;
  const T n5_2 = np6_2 - minus_N5_2 + T(0.2) * gt6_1;
  const T n5_3 = np6_3 - minus_N5_3 - T(0.3) * gt6_1;
  // invD5 = D5^-1: 1/D
  const T invD5 = T(1) / JA5_33;
  // kB5 = invD5 B5: B/D
  const T kB5_1 = invD5 * HA5_31;
  const T kB5_2 = invD5 * HA5_32;
  const T kB5_3 = invD5 * Hb6_33;
  // kK5 = invD5 K5: K/D
  const T kK5_1 = invD5 * JA5_13;
  const T kK5_2 = invD5 * JA5_23;
  // u_5 = b5 . n5 + tau_body_5_: drives it [N m], [N]
  const T u_5 = n5_3 + u.tau_5;
  // v5 = invD5 u_5: u/D
  const T v5 = invD5 * u_5;
  // M5 = MA5 - kB5 B5^T: MA less what the turn takes up [kg]
  const T M5_11 = MA5_11 - kB5_1 * HA5_31;
  const T M5_12 = Mp6_12 - kB5_1 * HA5_32;
  const T M5_13 = Mp6_13 - kB5_1 * Hb6_33;
  const T M5_22 = MA5_22 - kB5_2 * HA5_32;
  const T M5_23 = Mp6_23 - kB5_2 * Hb6_33;
  const T M5_33 = MA5_33 - kB5_3 * Hb6_33;
  // H5 = P_b5 (HA5 - kK5 B5^T): HA less what the turn takes up [kg m]
  const T H5_11 = Hb6_11 - kK5_1 * HA5_31;
  const T H5_12 = HA5_12 - kK5_1 * HA5_32;
  const T H5_13 = HA5_13 - kK5_1 * Hb6_33;
  const T H5_21 = HA5_21 - kK5_2 * HA5_31;
  const T H5_22 = Hb6_22 - kK5_2 * HA5_32;
  const T H5_23 = HA5_23 - kK5_2 * Hb6_33;
  // J5 = P_b5 (JA5 - kK5 K5^T) P_b5: JA less what the turn takes up [kg m^2]
  const T J5_11 = JA5_11 - kK5_1 * JA5_13;
  const T J5_12 = JA5_12 - kK5_1 * JA5_23;
  const T J5_22 = JA5_22 - kK5_2 * JA5_23;
  // gt5 = g5 - v5 B5: force with the turn solved [N]
  const T gt5_1 = g5_1 - v5 * HA5_31;
  const T gt5_2 = g5_2 - v5 * HA5_32;
  const T gt5_3 = g5_3 - v5 * Hb6_33;
  // nt5 = -tau_body_5_ b5 + P_b5 (n5 - v5 K5): moment with the turn solved [N m]
  const T nt5_1 = n5_1 - v5 * JA5_13;
  const T nt5_2 = n5_2 - v5 * JA5_23;
  // Mp5 = E5^T M5 E5: M passed on, lower body's axes [kg]
  const T b5_1 = T(2) * E5_11;
  const T b5_2 = E5_12 * (M5_11 - M5_22) + b5_1 * M5_12;
  const T b5_3 = E5_12 * b5_2;
  const T Mp5_11 = M5_11 - b5_3;
  const T Mp5_12 = E5_11 * b5_2 - M5_12;
  const T Mp5_13 = E5_11 * M5_13 - E5_12 * M5_23;
  const T Mp5_22 = M5_22 + b5_3;
  const T Mp5_23 = E5_12 * M5_13 + E5_11 * M5_23;
  // gp5 = E5^T gt5: force passed on, lower body's axes [N]
  const T gp5_1 = E5_11 * gt5_1 - E5_12 * gt5_2;
  const T gp5_2 = E5_12 * gt5_1 + E5_11 * gt5_2;
  // Hp5 = E5^T H5 E5: H passed on, lower body's axes [kg m]
  const T b5_4 = E5_12 * (H5_11 - H5_22) + E5_11 * (H5_12 + H5_21);
  const T b5_5 = E5_12 * b5_4;
  const T Hp5_11 = H5_11 - b5_5;
  const T b5_6 = E5_11 * b5_4;
  const T Hp5_12 = b5_6 - H5_21;
  const T Hp5_13 = E5_11 * H5_13 - E5_12 * H5_23;
  const T Hp5_21 = b5_6 - H5_12;
  const T Hp5_22 = H5_22 + b5_5;
  const T Hp5_23 = E5_12 * H5_13 + E5_11 * H5_23;
  // Jp5 = E5^T J5 E5: J passed on, lower body's axes [kg m^2]
  const T b5_7 = E5_12 * (J5_11 - J5_22) + b5_1 * J5_12;
  const T b5_8 = E5_12 * b5_7;
  const T Jp5_11 = J5_11 - b5_8;
  const T Jp5_12 = E5_11 * b5_7 - J5_12;
  const T Jp5_22 = J5_22 + b5_8;
  // np5 = E5^T nt5: moment passed on, lower body's axes [N m]
  const T np5_1 = E5_11 * nt5_1 - E5_12 * nt5_2;
  const T np5_2 = E5_12 * nt5_1 + E5_11 * nt5_2;
  // Hb5 = q5~ Mp5 + Hp5: H of the joint at the lower body's origin, its axes
  const T b5_9 = T(0.45) * Mp5_13;
  const T Hb5_11 = b5_9 + Hp5_11;
  const T Hb5_12 = Hp5_12 + T(0.45) * Mp5_23;
  const T Hb5_13 = Hp5_13 + T(0.45) * M5_33;
  const T Hb5_21 = Hp5_21 - T(0.3) * Mp5_13;
  const T b5_10 = T(0.3) * Mp5_23;
  const T Hb5_22 = Hp5_22 - b5_10;
  const T Hb5_23 = Hp5_23 - T(0.3) * M5_33;
  const T Hb5_31 = T(0.3) * Mp5_12 - T(0.45) * Mp5_11;
  const T Hb5_32 = T(0.3) * Mp5_22 - T(0.45) * Mp5_12;
  const T Hb5_33 = b5_10 - b5_9;

  // ---- body 4 (body_4) and what it carries
  // HA4 = h_own_4~ + Hb5: moment for an acceleration of the origin, body axes [kg m]
  const T HA4_12 = Hb5_12 - T(0.06999999999999999);
  const T HA4_21 = T(0.06999999999999999) + Hb5_21;
  const T HA4_23 = Hb5_23 - T(0.13999999999999999);
  const T HA4_32 = T(0.13999999999999999) + Hb5_32;
  // JA4 = q5~ Hp5^T + J_own_4 + Jp5 - Hb5 q5~: moment for an angular acceleration, body axes [kg m^2]
  const T JA4_11 = T(0.017500000000000012) + Jp5_11 + T(0.45) * Hp5_13 + Hb5_13 * T(0.45);
  const T JA4_12 = Jp5_12 - T(0.049) + T(0.45) * Hp5_23 - Hb5_13 * T(0.3);
  const T minus_JA4_13 = T(0.0028000000000000004) + Hb5_11 * T(0.45) - Hb5_12 * T(0.3);
  const T JA4_22 = T(0.1855) + Jp5_22 - T(0.3) * Hp5_23 - Hb5_23 * T(0.3);
  const T minus_JA4_23 = T(0.0336) + Hb5_21 * T(0.45) - Hb5_22 * T(0.3);
  const T minus_JA4_33 = Hb5_31 * T(0.45) - Hb5_32 * T(0.3);
  // g4 = G4 + gp5: force that drives it, home axes [N]
  const T g4_1 = gp5_1 - minus_G4_1;
  const T g4_2 = gp5_2 - minus_G4_2;
  const T g4_3 = gt5_3 - minus_G4_3;
  // n4 = q5~ gp5 + N4 + np5: moment that drives it, body axes [N m]
  const T n4_1 = np5_1 - minus_N4_1 + T(0.45) * gt5_3;
  const T n4_2 = np5_2 - minus_N4_2 - T(0.3) * gt5_3;
  const T n4_3 = T(0.3) * gp5_2 - (minus_N4_3 + u.tau_5) - T(0.45) * gp5_1;
  // invD4 = D4^-1: 1/D
  const T invD4 = T(1) / JA4_22;
  // kB4 = invD4 B4: B/D
  const T kB4_1 = invD4 * HA4_21;
  const T kB4_2 = invD4 * Hb5_22;
  const T kB4_3 = invD4 * HA4_23;
  // kK4 = invD4 K4: K/D
  const T kK4_1 = invD4 * JA4_12;
  const T minus_kK4_3 = invD4 * minus_JA4_23;
  // u_4 = b4 . n4 + tau_body_4_: drives it [N m], [N]
  const T u_4 = n4_2 + u.tau_4;
  // v4 = invD4 u_4: u/D
  const T v4 = invD4 * u_4;
  // M4 = Mp5 - kB4 B4^T: MA less what the turn takes up [kg]
  const T M4_11 = Mp5_11 - kB4_1 * HA4_21;
  const T M4_12 = Mp5_12 - kB4_1 * Hb5_22;
  const T M4_13 = Mp5_13 - kB4_1 * HA4_23;
  const T M4_22 = Mp5_22 - kB4_2 * Hb5_22;
  const T M4_23 = Mp5_23 - kB4_2 * HA4_23;
  const T M4_33 = M5_33 - kB4_3 * HA4_23;
  // H4 = P_b4 (HA4 - kK4 B4^T): HA less what the turn takes up [kg m]
  const T H4_11 = Hb5_11 - kK4_1 * HA4_21;
  const T H4_12 = HA4_12 - kK4_1 * Hb5_22;
  const T H4_13 = Hb5_13 - kK4_1 * HA4_23;
  const T H4_31 = Hb5_31 + minus_kK4_3 * HA4_21;
  const T H4_32 = HA4_32 + minus_kK4_3 * Hb5_22;
  const T H4_33 = Hb5_33 + minus_kK4_3 * HA4_23;
  // J4 = P_b4 (JA4 - kK4 K4^T) P_b4: JA less what the turn takes up [kg m^2]
  const T J4_11 = JA4_11 - kK4_1 * JA4_12;
  const T J4_13 = kK4_1 * minus_JA4_23 - minus_JA4_13;
  const T minus_J4_33 = minus_JA4_33 + minus_kK4_3 * minus_JA4_23;
  // gt4 = g4 - v4 B4: force with the turn solved [N]
  const T gt4_1 = g4_1 - v4 * HA4_21;
  const T gt4_2 = g4_2 - v4 * Hb5_22;
  const T gt4_3 = g4_3 - v4 * HA4_23;
  // nt4 = -tau_body_4_ b4 + P_b4 (n4 - v4 K4): moment with the turn solved [N m]
  const T nt4_1 = n4_1 - v4 * JA4_12;
  const T nt4_3 = n4_3 + v4 * minus_JA4_23;
  // Mp4 = E4^T M4 E4: M passed on, lower body's axes [kg]
  const T b4_1 = T(2) * E4_11;
  const T b4_2 = minus_E4_13 * (M4_33 - M4_11) + b4_1 * M4_13;
  const T b4_3 = minus_E4_13 * b4_2;
  const T Mp4_11 = M4_11 + b4_3;
  const T Mp4_12 = minus_E4_13 * M4_23 + E4_11 * M4_12;
  const T Mp4_13 = E4_11 * b4_2 - M4_13;
  const T Mp4_23 = E4_11 * M4_23 - minus_E4_13 * M4_12;
  const T Mp4_33 = M4_33 - b4_3;
  // gp4 = E4^T gt4: force passed on, lower body's axes [N]
  const T gp4_1 = E4_11 * gt4_1 + minus_E4_13 * gt4_3;
  const T gp4_3 = E4_11 * gt4_3 - minus_E4_13 * gt4_1;
  // Hp4 = E4^T H4 E4: H passed on, lower body's axes [kg m]
  const T b4_4 = minus_E4_13 * (H4_33 - H4_11) + E4_11 * (H4_31 + H4_13);
  const T b4_5 = minus_E4_13 * b4_4;
  const T Hp4_11 = H4_11 + b4_5;
  const T Hp4_12 = minus_E4_13 * H4_32 + E4_11 * H4_12;
  const T b4_6 = E4_11 * b4_4;
  const T Hp4_13 = b4_6 - H4_31;
  const T Hp4_31 = b4_6 - H4_13;
  const T Hp4_32 = E4_11 * H4_32 - minus_E4_13 * H4_12;
  const T Hp4_33 = H4_33 - b4_5;
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_7 = b4_1 * J4_13 - minus_E4_13 * (minus_J4_33 + J4_11);
  const T b4_8 = minus_E4_13 * b4_7;
  const T Jp4_11 = J4_11 + b4_8;
  const T Jp4_13 = E4_11 * b4_7 - J4_13;
  const T minus_Jp4_33 = minus_J4_33 + b4_8;
  // np4 = E4^T nt4: moment passed on, lower body's axes [N m]
  const T np4_1 = E4_11 * nt4_1 + minus_E4_13 * nt4_3;
  const T np4_3 = E4_11 * nt4_3 - minus_E4_13 * nt4_1;
  // Hb4 = q4~ Mp4 + Hp4: H of the joint at the lower body's origin, its axes
  const T b4_9 = T(0.1) * Mp4_12;
  const T Hb4_11 = Hp4_11 - b4_9;
  const T Hb4_12 = Hp4_12 - T(0.1) * M4_22;
  const T Hb4_13 = Hp4_13 - T(0.1) * Mp4_23;
  const T Hb4_21 = T(0.1) * Mp4_11 - T(0.6) * Mp4_13;
  const T b4_10 = T(0.6) * Mp4_23;
  const T Hb4_22 = b4_9 - b4_10;
  const T Hb4_23 = T(0.1) * Mp4_13 - T(0.6) * Mp4_33;
  const T Hb4_31 = Hp4_31 + T(0.6) * Mp4_12;
  const T Hb4_32 = Hp4_32 + T(0.6) * M4_22;
  const T Hb4_33 = b4_10 + Hp4_33;

  // ---- body 3 (body_3) and what it carries
  // HA3 = h_own_3~ + Hb4: moment for an acceleration of the origin, body axes [kg m]
  const T HA3_12 = Hb4_12 - T(0.20500000000000002);
  const T HA3_13 = T(0.8200000000000001) + Hb4_13;
  const T HA3_21 = T(0.20500000000000002) + Hb4_21;
  const T HA3_31 = Hb4_31 - T(0.8200000000000001);
  // JA3 = q4~ Hp4^T + J_own_3 + Jp4 - Hb4 q4~: moment for an angular acceleration, body axes [kg m^2]
  const T JA3_11 = T(0.54925) + Jp4_11 - T(0.1) * Hp4_12 - Hb4_12 * T(0.1);
  const T minus_JA3_12 = T(0.4335) + Hb4_13 * T(0.6) - Hb4_11 * T(0.1);
  const T JA3_13 = Jp4_13 - T(0.1061) - T(0.1) * Hp4_32 + Hb4_12 * T(0.6);
  const T minus_JA3_22 = Hb4_23 * T(0.6) - Hb4_21 * T(0.1);
  const T JA3_23 = T(0.1) * Hp4_31 - T(0.0742) - T(0.6) * Hp4_33 + Hb4_22 * T(0.6);
  const T JA3_33 = T(0.33275) - minus_Jp4_33 + T(0.6) * Hp4_32 + Hb4_32 * T(0.6);
  // g3 = G3 + gp4: force that drives it, home axes [N]
  const T g3_1 = gp4_1 - minus_G3_1;
  const T g3_2 = gt4_2 - minus_G3_2;
  const T g3_3 = gp4_3 - minus_G3_3;
  // n3 = q4~ gp4 + N3 + np4: moment that drives it, body axes [N m]
  const T n3_1 = np4_1 - minus_N3_1 - T(0.1) * gt4_2;
  const T n3_2 = T(0.1) * gp4_1 - (minus_N3_2 + u.tau_4) - T(0.6) * gp4_3;
  const T n3_3 = np4_3 - minus_N3_3 + T(0.6) * gt4_2;
  // invD3 = D3^-1: 1/D
  const T invD3 = T(1) / JA3_11;
  // kB3 = invD3 B3: B/D
  const T kB3_1 = invD3 * Hb4_11;
  const T kB3_2 = invD3 * HA3_12;
  const T kB3_3 = invD3 * HA3_13;
  // kK3 = invD3 K3: K/D
  const T minus_kK3_2 = invD3 * minus_JA3_12;
  const T kK3_3 = invD3 * JA3_13;
  // u_3 = b3 . n3 + tau_body_3_: drives it [N m], [N]
  const T u_3 = n3_1 + u.tau_3;
  // v3 = invD3 u_3: u/D
  const T v3 = invD3 * u_3;
  // M3 = Mp4 - kB3 B3^T: MA less what the turn takes up [kg]
  const T M3_11 = Mp4_11 - kB3_1 * Hb4_11;
  const T M3_12 = Mp4_12 - kB3_1 * HA3_12;
  const T M3_13 = Mp4_13 - kB3_1 * HA3_13;
  const T M3_22 = M4_22 - kB3_2 * HA3_12;
  const T M3_23 = Mp4_23 - kB3_2 * HA3_13;
  const T M3_33 = Mp4_33 - kB3_3 * HA3_13;
  // H3 = P_b3 (HA3 - kK3 B3^T): HA less what the turn takes up [kg m]
  const T H3_21 = HA3_21 + minus_kK3_2 * Hb4_11;
  const T H3_22 = Hb4_22 + minus_kK3_2 * HA3_12;
  const T H3_23 = Hb4_23 + minus_kK3_2 * HA3_13;
  const T H3_31 = HA3_31 - kK3_3 * Hb4_11;
  const T H3_32 = Hb4_32 - kK3_3 * HA3_12;
  const T H3_33 = Hb4_33 - kK3_3 * HA3_13;
  // J3 = P_b3 (JA3 - kK3 K3^T) P_b3: JA less what the turn takes up [kg m^2]
  const T minus_J3_22 = minus_JA3_22 + minus_kK3_2 * minus_JA3_12;
  const T J3_23 = JA3_23 + minus_kK3_2 * JA3_13;
  const T J3_33 = JA3_33 - kK3_3 * JA3_13;
  // gt3 = g3 - v3 B3: force with the turn solved [N]
  const T gt3_1 = g3_1 - v3 * Hb4_11;
  const T gt3_2 = g3_2 - v3 * HA3_12;
  const T gt3_3 = g3_3 - v3 * HA3_13;
  // nt3 = -tau_body_3_ b3 + P_b3 (n3 - v3 K3): moment with the turn solved [N m]
  const T nt3_2 = n3_2 + v3 * minus_JA3_12;
  const T nt3_3 = n3_3 - v3 * JA3_13;
  // Mp3 = E3^T M3 E3: M passed on, lower body's axes [kg]
  const T Mp3_12 = E3_22 * M3_12 - E3_23 * M3_13;
  const T Mp3_13 = E3_23 * M3_12 + E3_22 * M3_13;
  const T b3_1 = T(2) * E3_22;
  const T b3_2 = E3_23 * (M3_22 - M3_33) + b3_1 * M3_23;
  const T b3_3 = E3_23 * b3_2;
  const T Mp3_22 = M3_22 - b3_3;
  const T Mp3_23 = E3_22 * b3_2 - M3_23;
  const T Mp3_33 = M3_33 + b3_3;
  // gp3 = E3^T gt3: force passed on, lower body's axes [N]
  const T gp3_2 = E3_22 * gt3_2 - E3_23 * gt3_3;
  const T gp3_3 = E3_23 * gt3_2 + E3_22 * gt3_3;
  // Hp3 = E3^T H3 E3: H passed on, lower body's axes [kg m]
  const T Hp3_21 = E3_22 * H3_21 - E3_23 * H3_31;
  const T b3_4 = E3_23 * (H3_22 - H3_33) + E3_22 * (H3_23 + H3_32);
  const T b3_5 = E3_23 * b3_4;
  const T Hp3_22 = H3_22 - b3_5;
  const T b3_6 = E3_22 * b3_4;
  const T Hp3_23 = b3_6 - H3_32;
  const T Hp3_31 = E3_23 * H3_21 + E3_22 * H3_31;
  const T Hp3_32 = b3_6 - H3_23;
  const T Hp3_33 = H3_33 + b3_5;
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_7 = b3_1 * J3_23 - E3_23 * (minus_J3_22 + J3_33);
  const T b3_8 = E3_23 * b3_7;
  const T minus_Jp3_22 = minus_J3_22 + b3_8;
  const T Jp3_23 = E3_22 * b3_7 - J3_23;
  const T Jp3_33 = J3_33 + b3_8;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T np3_2 = E3_22 * nt3_2 - E3_23 * nt3_3;
  const T np3_3 = E3_23 * nt3_2 + E3_22 * nt3_3;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T b3_9 = T(0.15) * Mp3_13;
  const T Hb3_11 = b3_9 - T(0.2) * Mp3_12;
  const T Hb3_12 = T(0.15) * Mp3_23 - T(0.2) * Mp3_22;
  const T Hb3_13 = T(0.15) * Mp3_33 - T(0.2) * Mp3_23;
  const T Hb3_21 = Hp3_21 + T(0.2) * M3_11;
  const T Hb3_23 = Hp3_23 + T(0.2) * Mp3_13;
  const T Hb3_31 = Hp3_31 - T(0.15) * M3_11;
  const T Hb3_33 = Hp3_33 - b3_9;

  // ---- body 2 (body_2) and what it carries
  // MA2 = m_all_2 one + Mp3: force for an acceleration of the origin, home axes [kg]
  const T MA2_33 = T(3.9) + Mp3_33;
  // HA2 = h_all_2~ + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA2_13 = T(0.645) + Hb3_13;
  const T HA2_23 = Hb3_23 - T(1.48);
  // JA2 = q3~ Hp3^T + J_all_2 + Jp3 - Hb3 q3~: moment for an angular acceleration, body axes [kg m^2]
  const T JA2_11 = T(0.36375) + Hb3_13 * T(0.15) - Hb3_12 * T(0.2);
  const T JA2_12 = T(0.15) * Hp3_23 - T(0.22199999999999998) - T(0.2) * Hp3_22 + Hb3_11 * T(0.2);
  const T JA2_13 = T(0.15) * Hp3_33 - T(0.2864) - T(0.2) * Hp3_32 - Hb3_11 * T(0.15);
  const T JA2_22 = T(1.17625) - minus_Jp3_22 + T(0.2) * Hp3_21 + Hb3_21 * T(0.2);
  const T JA2_23 = Jp3_23 - T(0.1218) + T(0.2) * Hp3_31 - Hb3_21 * T(0.15);
  const T JA2_33 = T(1.1019999999999999) + Jp3_33 - T(0.15) * Hp3_31 - Hb3_31 * T(0.15);
  // g2 = G2 + gp3: force that drives it, home axes [N]
  const T g2_3 = gp3_3 - minus_G2_3;
  // n2 = q3~ gp3 + N2 + np3: moment that drives it, body axes [N m]
  const T n2_1 = T(0.15) * gp3_3 - (minus_N2_1 + u.tau_3) - T(0.2) * gp3_2;
  const T n2_2 = np3_2 - minus_N2_2 + T(0.2) * gt3_1;
  const T n2_3 = np3_3 - minus_N2_3 - T(0.15) * gt3_1;
  // invD2 = D2^-1: 1/D
  const T invD2 = T(1) / JA2_33;
  // kB2 = invD2 B2: B/D
  const T kB2_3 = invD2 * Hb3_33;
  // kK2 = invD2 K2: K/D
  const T kK2_1 = invD2 * JA2_13;
  const T kK2_2 = invD2 * JA2_23;
  // u_2 = b2 . n2 + tau_body_2_: drives it [N m], [N]
  const T u_2 = n2_3 + u.tau_2;
  // v2 = invD2 u_2: u/D
  const T v2 = invD2 * u_2;
  // M2 = MA2 - kB2 B2^T: MA less what the turn takes up [kg]
  const T M2_33 = MA2_33 - kB2_3 * Hb3_33;
  // H2 = P_b2 (HA2 - kK2 B2^T): HA less what the turn takes up [kg m]
  const T H2_13 = HA2_13 - kK2_1 * Hb3_33;
  const T H2_23 = HA2_23 - kK2_2 * Hb3_33;
  // J2 = P_b2 (JA2 - kK2 K2^T) P_b2: JA less what the turn takes up [kg m^2]
  const T J2_11 = JA2_11 - kK2_1 * JA2_13;
  const T J2_12 = JA2_12 - kK2_1 * JA2_23;
  const T J2_22 = JA2_22 - kK2_2 * JA2_23;
  // gt2 = g2 - v2 B2: force with the turn solved [N]
  const T gt2_3 = g2_3 - v2 * Hb3_33;
  // nt2 = -tau_body_2_ b2 + P_b2 (n2 - v2 K2): moment with the turn solved [N m]
  const T nt2_1 = n2_1 - v2 * JA2_13;
  const T nt2_2 = n2_2 - v2 * JA2_23;
  // Hp2 = E2^T H2 E2: H passed on, lower body's axes [kg m]
  const T Hp2_23 = E2_12 * H2_13 + E2_11 * H2_23;
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T Jp2_22 = J2_22 + E2_12 * (E2_12 * (J2_11 - J2_22) + T(2) * E2_11 * J2_12);
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T np2_2 = E2_12 * nt2_1 + E2_11 * nt2_2;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T Hb2_23 = Hp2_23 - T(0.3) * M2_33;

  // ---- body 1 (body_1) and what it carries
  // JA1 = q2~ Hp2^T + J_own_1 + Jp2 - Hb2 q2~: moment for an angular acceleration, body axes [kg m^2]
  const T JA1_22 = T(0.14575000000000002) + Jp2_22 - T(0.3) * Hp2_23 - Hb2_23 * T(0.3);
  // n1 = q2~ gp2 + N1 + np2: moment that drives it, body axes [N m]
  const T n1_2 = N1_2 + np2_2 - T(0.3) * gt2_3;
  // invD1 = D1^-1: 1/D
  const T invD1 = T(1) / JA1_22;
  // u_1 = b1 . n1 + tau_body_1_: drives it [N m], [N]
  const T u_1 = n1_2 + u.tau_1;
  // v1 = invD1 u_1: u/D
  const T v1 = invD1 * u_1;
  ydot[0] = v1;

  // ---- body 2 (body_2), solved
  // beta2 = -E2 q2~ alpha1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T minus_beta2_3 = T(0.3) * v1;
  // alphaL2 = E2 alpha1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL2_1 = E2_12 * v1;
  const T alphaL2_2 = E2_11 * v1;
  // phi2 = -kB2 . beta2 + v2 - (P_b2 kK2) . alphaL2
  const T phi2 = v2 + kB2_3 * minus_beta2_3 - kK2_1 * alphaL2_1 - kK2_2 * alphaL2_2;
  ydot[1] = phi2;

  // ---- body 3 (body_3), solved
  // beta3 = -E3 q3~ alpha2 + E3 beta2: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T minus_beta3_1 = T(0.15) * phi2 - T(0.2) * alphaL2_2;
  const T z3_1 = T(0.2) * alphaL2_1;
  const T z3_2 = T(0.15) * alphaL2_1;
  const T minus_beta3_2 = E3_22 * z3_1 - E3_23 * z3_2 + E3_23 * minus_beta2_3;
  const T beta3_3 = E3_23 * z3_1 + E3_22 * z3_2 - E3_22 * minus_beta2_3;
  // alphaL3 = E3 alpha2: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL3_2 = E3_22 * alphaL2_2 + E3_23 * phi2;
  const T alphaL3_3 = E3_22 * phi2 - E3_23 * alphaL2_2;
  // phi3 = -kB3 . beta3 + v3 - (P_b3 kK3) . alphaL3
  const T phi3 = v3 + kB3_1 * minus_beta3_1 + kB3_2 * minus_beta3_2 - kB3_3 * beta3_3 - kK3_3 * alphaL3_3 +
      minus_kK3_2 * alphaL3_2;
  // thetaddot3 = -b3 . alphaL3 + phi3
  const T thetaddot3 = phi3 - alphaL2_1;
  ydot[2] = thetaddot3;

  // ---- body 4 (body_4), solved
  // beta4 = -E4 q4~ alpha3 + E4 beta3: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z4_1 = T(0.1) * alphaL3_2;
  const T z4_2 = T(0.6) * alphaL3_2;
  const T minus_beta4_1 = E4_11 * minus_beta3_1 - (E4_11 * z4_1 + minus_E4_13 * z4_2) + minus_E4_13 * beta3_3;
  const T minus_beta4_2 = minus_beta3_2 + T(0.1) * phi3 - T(0.6) * alphaL3_3;
  const T beta4_3 = minus_E4_13 * z4_1 - E4_11 * z4_2 + E4_11 * beta3_3 - minus_E4_13 * minus_beta3_1;
  // alphaL4 = E4 alpha3: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4_1 = E4_11 * phi3 - minus_E4_13 * alphaL3_3;
  const T alphaL4_3 = minus_E4_13 * phi3 + E4_11 * alphaL3_3;
  // phi4 = -kB4 . beta4 + v4 - (P_b4 kK4) . alphaL4
  const T phi4 = v4 + kB4_2 * minus_beta4_2 + kB4_1 * minus_beta4_1 - kB4_3 * beta4_3 - kK4_1 * alphaL4_1 +
      minus_kK4_3 * alphaL4_3;
  // thetaddot4 = -b4 . alphaL4 + phi4
  const T thetaddot4 = phi4 - alphaL3_2;
  ydot[3] = thetaddot4;

  // ---- body 5 (body_5), solved
  // beta5 = -E5 q5~ alpha4 + E5 beta4: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z5_1 = T(0.45) * alphaL4_3;
  const T z5_2 = T(0.3) * alphaL4_3;
  const T minus_beta5_1 = E5_12 * minus_beta4_2 + E5_11 * minus_beta4_1 + E5_11 * z5_1 - E5_12 * z5_2;
  const T beta5_2 = E5_12 * minus_beta4_1 - E5_11 * minus_beta4_2 + E5_11 * z5_2 + E5_12 * z5_1;
  const T beta5_3 = beta4_3 + T(0.45) * alphaL4_1 - T(0.3) * phi4;
  // alphaL5 = E5 alpha4: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL5_1 = E5_11 * alphaL4_1 + E5_12 * phi4;
  const T alphaL5_2 = E5_11 * phi4 - E5_12 * alphaL4_1;
  // phi5 = -kB5 . beta5 + v5 - (P_b5 kK5) . alphaL5
  const T phi5 = v5 + kB5_1 * minus_beta5_1 - kB5_2 * beta5_2 - kB5_3 * beta5_3 - kK5_1 * alphaL5_1 - kK5_2 *
      alphaL5_2;
  // thetaddot5 = -b5 . alphaL5 + phi5
  const T thetaddot5 = phi5 - alphaL4_3;
  ydot[4] = thetaddot5;

  // ---- body 6 (body_6), solved
  // beta6 = -E6 q6~ alpha5 + E6 beta5: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T minus_beta6_1 = minus_beta5_1 + T(0.3) * phi5 - T(0.2) * alphaL5_2;
  const T z6_1 = T(0.3) * alphaL5_1;
  const T z6_2 = T(0.2) * alphaL5_1;
  const T beta6_2 = E6_23 * z6_1 - E6_22 * z6_2 + E6_22 * beta5_2 + E6_23 * beta5_3;
  const T beta6_3 = E6_22 * beta5_3 - E6_23 * beta5_2 + E6_23 * z6_2 + E6_22 * z6_1;
  // alphaL6 = E6 alpha5: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL6_2 = E6_22 * alphaL5_2 + E6_23 * phi5;
  const T alphaL6_3 = E6_22 * phi5 - E6_23 * alphaL5_2;
  // phi6 = -kB6 . beta6 + v6 - (P_b6 kK6) . alphaL6
  const T phi6 = v6 + kB6_1 * minus_beta6_1 - kB6_2 * beta6_2 - kB6_3 * beta6_3 - kK6_3 * alphaL6_3 + minus_kK6_2 *
      alphaL6_2;
  // thetaddot6 = -b6 . alphaL6 + phi6
  const T thetaddot6 = phi6 - alphaL5_1;
  ydot[5] = thetaddot6;

  // ---- body 7 (body_7), solved
  // beta7 = -E7 q7~ alpha6 + E7 beta6: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z7_1 = T(0.1) * alphaL6_2;
  const T z7_2 = T(0.6) * alphaL6_2;
  const T beta7_1 = E7_11 * z7_1 + minus_E7_13 * z7_2 - E7_11 * minus_beta6_1 - minus_E7_13 * beta6_3;
  const T beta7_2 = beta6_2 + T(0.6) * alphaL6_3 - T(0.1) * phi6;
  const T beta7_3 = minus_E7_13 * z7_1 - E7_11 * z7_2 + E7_11 * beta6_3 - minus_E7_13 * minus_beta6_1;
  // alphaL7 = E7 alpha6: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL7_1 = E7_11 * phi6 - minus_E7_13 * alphaL6_3;
  const T alphaL7_3 = minus_E7_13 * phi6 + E7_11 * alphaL6_3;
  // phi7 = -kB7 . beta7 + v7 - (P_b7 kK7) . alphaL7
  const T phi7 = v7 - kB7_1 * beta7_1 - kB7_2 * beta7_2 - kB7_3 * beta7_3 - kK7_1 * alphaL7_1 + minus_kK7_3 *
      alphaL7_3;
  // thetaddot7 = -b7 . alphaL7 + phi7
  const T thetaddot7 = phi7 - alphaL6_2;
  ydot[6] = thetaddot7;

  // ---- body 8 (body_8), solved
  // beta8 = -E8 q8~ alpha7 + E8 beta7: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z8_1 = T(0.3) * alphaL7_3;
  const T z8_2 = T(0.75) * alphaL7_3;
  const T beta8_1 = E8_12 * z8_1 - E8_11 * z8_2 + E8_11 * beta7_1 + E8_12 * beta7_2;
  const T beta8_2 = E8_11 * beta7_2 - E8_12 * beta7_1 + E8_11 * z8_1 + E8_12 * z8_2;
  const T beta8_3 = beta7_3 + T(0.75) * alphaL7_1 - T(0.3) * phi7;
  // alphaL8 = E8 alpha7: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL8_1 = E8_11 * alphaL7_1 + E8_12 * phi7;
  const T alphaL8_2 = E8_11 * phi7 - E8_12 * alphaL7_1;
  // phi8 = -kB8 . beta8 + v8 - (P_b8 kK8) . alphaL8
  const T phi8 = v8 - kB8_1 * beta8_1 - kB8_2 * beta8_2 - kB8_3 * beta8_3 - kK8_1 * alphaL8_1 - kK8_2 * alphaL8_2;
  // thetaddot8 = -b8 . alphaL8 + phi8
  const T thetaddot8 = phi8 - alphaL7_3;
  ydot[7] = thetaddot8;

  // ---- body 9 (body_9), solved
  // beta9 = -E9 q9~ alpha8 + E9 beta8: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta9_1 = beta8_1 + T(0.2) * alphaL8_2 - T(0.45) * phi8;
  const T z9_1 = T(0.45) * alphaL8_1;
  const T z9_2 = T(0.2) * alphaL8_1;
  const T beta9_2 = E9_23 * z9_1 - E9_22 * z9_2 + E9_22 * beta8_2 + E9_23 * beta8_3;
  const T beta9_3 = E9_22 * beta8_3 - E9_23 * beta8_2 + E9_23 * z9_2 + E9_22 * z9_1;
  // alphaL9 = E9 alpha8: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL9_2 = E9_22 * alphaL8_2 + E9_23 * phi8;
  const T alphaL9_3 = E9_22 * phi8 - E9_23 * alphaL8_2;
  // phi9 = -kB9 . beta9 + v9 - (P_b9 kK9) . alphaL9
  const T phi9 = v9 - kB9_1 * beta9_1 - kB9_2 * beta9_2 - kB9_3 * beta9_3 - kK9_3 * alphaL9_3 + minus_kK9_2 *
      alphaL9_2;
  // thetaddot9 = -b9 . alphaL9 + phi9
  const T thetaddot9 = phi9 - alphaL8_1;
  ydot[8] = thetaddot9;

  // ---- body 10 (body_10), solved
  // beta10 = -E10 q10~ alpha9 + E10 beta9: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z10_1 = T(0.1) * alphaL9_2;
  const T z10_2 = T(0.6) * alphaL9_2;
  const T beta10_1 = E10_11 * beta9_1 - minus_E10_13 * beta9_3 + E10_11 * z10_1 + minus_E10_13 * z10_2;
  const T beta10_2 = beta9_2 + T(0.6) * alphaL9_3 - T(0.1) * phi9;
  const T beta10_3 = minus_E10_13 * z10_1 - E10_11 * z10_2 + minus_E10_13 * beta9_1 + E10_11 * beta9_3;
  // alphaL10 = E10 alpha9: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL10_1 = E10_11 * phi9 - minus_E10_13 * alphaL9_3;
  const T alphaL10_3 = minus_E10_13 * phi9 + E10_11 * alphaL9_3;
  // phi10 = -kB10 . beta10 + v10 - (P_b10 kK10) . alphaL10
  const T phi10 = v10 - kB10_1 * beta10_1 - kB10_2 * beta10_2 - kB10_3 * beta10_3 - kK10_1 * alphaL10_1 + minus_kK10_3
      * alphaL10_3;
  // thetaddot10 = -b10 . alphaL10 + phi10
  const T thetaddot10 = phi10 - alphaL9_2;
  ydot[9] = thetaddot10;

  // ---- body 11 (body_11), solved
  // beta11 = -E11 q11~ alpha10 + E11 beta10: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z11_1 = T(0.3) * alphaL10_3;
  const T z11_2 = T(1.05) * alphaL10_3;
  const T beta11_1 = E11_12 * z11_1 - E11_11 * z11_2 + E11_11 * beta10_1 + E11_12 * beta10_2;
  const T beta11_2 = E11_11 * beta10_2 - E11_12 * beta10_1 + E11_11 * z11_1 + E11_12 * z11_2;
  const T beta11_3 = beta10_3 + T(1.05) * alphaL10_1 - T(0.3) * phi10;
  // alphaL11 = E11 alpha10: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL11_1 = E11_11 * alphaL10_1 + E11_12 * phi10;
  const T alphaL11_2 = E11_11 * phi10 - E11_12 * alphaL10_1;
  // phi11 = -kB11 . beta11 + v11 - (P_b11 kK11) . alphaL11
  const T phi11 = v11 - kB11_1 * beta11_1 - kB11_2 * beta11_2 - kB11_3 * beta11_3 - kK11_1 * alphaL11_1 - kK11_2 *
      alphaL11_2;
  // thetaddot11 = -b11 . alphaL11 + phi11
  const T thetaddot11 = phi11 - alphaL10_3;
  ydot[10] = thetaddot11;

  // ---- body 12 (body_12), solved
  // beta12 = -E12 q12~ alpha11 + E12 beta11: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta12_1 = beta11_1 + T(0.2) * alphaL11_2 - T(0.6) * phi11;
  const T z12_1 = T(0.6) * alphaL11_1;
  const T z12_2 = T(0.2) * alphaL11_1;
  const T beta12_2 = E12_23 * z12_1 - E12_22 * z12_2 + E12_22 * beta11_2 + E12_23 * beta11_3;
  const T beta12_3 = E12_22 * beta11_3 - E12_23 * beta11_2 + E12_23 * z12_2 + E12_22 * z12_1;
  // alphaL12 = E12 alpha11: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL12_2 = E12_22 * alphaL11_2 + E12_23 * phi11;
  const T alphaL12_3 = E12_22 * phi11 - E12_23 * alphaL11_2;
  // phi12 = -kB12 . beta12 + v12 - (P_b12 kK12) . alphaL12
  const T phi12 = v12 - kB12_1 * beta12_1 - kB12_2 * beta12_2 - kB12_3 * beta12_3 - kK12_3 * alphaL12_3 + minus_kK12_2
      * alphaL12_2;
  // thetaddot12 = -b12 . alphaL12 + phi12
  const T thetaddot12 = phi12 - alphaL11_1;
  ydot[11] = thetaddot12;

  // ---- body 13 (body_13), solved
  // beta13 = -E13 q13~ alpha12 + E13 beta12: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z13_1 = T(0.1) * alphaL12_2;
  const T z13_2 = T(0.6) * alphaL12_2;
  const T beta13_1 = E13_11 * beta12_1 - minus_E13_13 * beta12_3 + E13_11 * z13_1 + minus_E13_13 * z13_2;
  const T beta13_2 = beta12_2 + T(0.6) * alphaL12_3 - T(0.1) * phi12;
  const T beta13_3 = minus_E13_13 * z13_1 - E13_11 * z13_2 + minus_E13_13 * beta12_1 + E13_11 * beta12_3;
  // alphaL13 = E13 alpha12: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL13_1 = E13_11 * phi12 - minus_E13_13 * alphaL12_3;
  const T alphaL13_3 = minus_E13_13 * phi12 + E13_11 * alphaL12_3;
  // phi13 = -kB13 . beta13 + v13 - (P_b13 kK13) . alphaL13
  const T phi13 = v13 - kB13_1 * beta13_1 - kB13_2 * beta13_2 - kB13_3 * beta13_3 - kK13_1 * alphaL13_1 + minus_kK13_3
      * alphaL13_3;
  // thetaddot13 = -b13 . alphaL13 + phi13
  const T thetaddot13 = phi13 - alphaL12_2;
  ydot[12] = thetaddot13;

  // ---- body 14 (body_14), solved
  // beta14 = -E14 q14~ alpha13 + E14 beta13: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z14_1 = T(0.3) * alphaL13_3;
  const T z14_2 = T(1.35) * alphaL13_3;
  const T beta14_1 = E14_12 * z14_1 - E14_11 * z14_2 + E14_11 * beta13_1 + E14_12 * beta13_2;
  const T beta14_2 = E14_11 * beta13_2 - E14_12 * beta13_1 + E14_11 * z14_1 + E14_12 * z14_2;
  const T beta14_3 = beta13_3 + T(1.35) * alphaL13_1 - T(0.3) * phi13;
  // alphaL14 = E14 alpha13: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL14_1 = E14_11 * alphaL13_1 + E14_12 * phi13;
  const T alphaL14_2 = E14_11 * phi13 - E14_12 * alphaL13_1;
  // phi14 = -kB14 . beta14 + v14 - (P_b14 kK14) . alphaL14
  const T phi14 = v14 - kB14_1 * beta14_1 - kB14_2 * beta14_2 - kB14_3 * beta14_3 - kK14_1 * alphaL14_1 - kK14_2 *
      alphaL14_2;
  // thetaddot14 = -b14 . alphaL14 + phi14
  const T thetaddot14 = phi14 - alphaL13_3;
  ydot[13] = thetaddot14;

  // ---- body 15 (body_15), solved
  // beta15 = -E15 q15~ alpha14 + E15 beta14: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta15_1 = beta14_1 + T(0.2) * alphaL14_2 - T(0.75) * phi14;
  const T z15_1 = T(0.75) * alphaL14_1;
  const T z15_2 = T(0.2) * alphaL14_1;
  const T beta15_2 = E15_23 * z15_1 - E15_22 * z15_2 + E15_22 * beta14_2 + E15_23 * beta14_3;
  const T beta15_3 = E15_22 * beta14_3 - E15_23 * beta14_2 + E15_23 * z15_2 + E15_22 * z15_1;
  // alphaL15 = E15 alpha14: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL15_2 = E15_22 * alphaL14_2 + E15_23 * phi14;
  const T alphaL15_3 = E15_22 * phi14 - E15_23 * alphaL14_2;
  // phi15 = -kB15 . beta15 + v15 - (P_b15 kK15) . alphaL15
  const T phi15 = v15 + minus_kB15_2 * beta15_2 - kB15_1 * beta15_1 - kB15_3 * beta15_3 - kK15_3 * alphaL15_3 - kK15_2
      * alphaL15_2;
  // thetaddot15 = -b15 . alphaL15 + phi15
  const T thetaddot15 = phi15 - alphaL14_1;
  ydot[14] = thetaddot15;

  // ---- body 16 (body_16), solved
  // beta16 = -E16 q16~ alpha15 + E16 beta15: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta16_1 = E16_11 * beta15_1 - minus_E16_13 * beta15_3 + T(0.1) * alphaL15_2 * E16_11 + T(0.6) * alphaL15_2
      * minus_E16_13;
  // alphaL16 = E16 alpha15: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL16_1 = E16_11 * phi15 - minus_E16_13 * alphaL15_3;
  const T alphaL16_3 = minus_E16_13 * phi15 + E16_11 * alphaL15_3;
  // phi16 = -kB16 . beta16 + v16 - (P_b16 kK16) . alphaL16
  const T phi16 = v16 - T(0.8437992367923736) * beta16_1 - T(0.04387756031320342) * alphaL16_1 + T(0.8235480551093566)
      * alphaL16_3;
  // thetaddot16 = -b16 . alphaL16 + phi16
  const T thetaddot16 = phi16 - alphaL15_2;
  ydot[15] = thetaddot16;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 902 add, 923 multiply, 32 sine or cosine
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r)
    noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 16, cosines, sines);

  // ---- body 1 (body_1) on the inertial frame
  const T thetadot1 = y[0];
  const T thetaddot1 = ydot[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // U1 = omega1~ omega1~ + omegadot1~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U1_11 = thetadot1 * thetadot1;
  // Pddot1 = -E1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot1_1 = minus_E1_13 * T(9.81);
  const T Pddot1_3 = E1_11 * T(9.81);
  // N1 = h_own_1~ Pddot1 + axial(U1 (tr(J_own_1)/2 - J_own_1)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N1_2 = T(4.612) * thetaddot1 - T(8.66) * Pddot1_3 - T(5.695) * minus_Pddot1_1;

  // ---- body 2 (body_2) on body 1
  const T thetadot2 = y[1];
  const T thetaddot2 = ydot[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T E2_12 = sines[1];
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
  const T t2_7 = minus_Pddot1_1 + minus_U1_11 * T(0.3);
  const T minus_Pddot2_1 = E2_11 * t2_7;
  const T Pddot2_2 = E2_12 * t2_7;
  const T Pddot2_3 = Pddot1_3 - thetaddot1 * T(0.3);
  // G2 = U2 h_own_2: inertia less applied force, body axes [N]
  const T G2_3 = U2_31 * T(16.24) + U2_32 * T(4.335);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(4.335) * Pddot2_3 + T(0.6982499999999999) * U2_32 + T(0.6982499999999999) * U2_23 + T(0.8598) *
      (minus_U2_22 - minus_U2_33) + T(2.436) * U2_31 - T(3.2384) * U2_21;
  const T N2_2 = T(3.2384) * (minus_U2_33 - minus_U2_11) - (T(0.6982499999999999) * U2_13 + T(10.059249999999999) *
      U2_31) + T(0.8598) * U2_12 - T(2.436) * U2_32 - T(16.24) * Pddot2_3;
  const T N2_3 = T(16.24) * Pddot2_2 + T(4.335) * minus_Pddot2_1 + T(10.059249999999999) * U2_21 -
      T(0.6982499999999999) * U2_12 + T(2.436) * (minus_U2_11 - minus_U2_22) + T(3.2384) * U2_23 - T(0.8598) * U2_13;

  // ---- body 3 (body_3) on body 2
  const T thetadot3 = y[2];
  const T thetaddot3 = ydot[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[2];
  const T E3_23 = sines[2];
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
  const T Pddot3_1 = U2_12 * T(0.15) - minus_Pddot2_1 + U2_13 * T(0.2);
  const T t3_7 = Pddot2_2 + U2_23 * T(0.2) - minus_U2_22 * T(0.15);
  const T t3_8 = Pddot2_3 + U2_32 * T(0.15) - minus_U2_33 * T(0.2);
  const T Pddot3_2 = E3_22 * t3_7 + E3_23 * t3_8;
  const T Pddot3_3 = E3_22 * t3_8 - E3_23 * t3_7;
  // G3 = U3 h_own_3: inertia less applied force, body axes [N]
  const T G3_1 = U3_12 * T(11.89) + U3_13 * T(2.665);
  const T G3_2 = U3_23 * T(2.665) - minus_U3_22 * T(11.89);
  const T G3_3 = U3_32 * T(11.89) - minus_U3_33 * T(2.665);
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(11.89) * Pddot3_3 - T(2.665) * Pddot3_2 + T(7.6365) * U3_32 - T(0.35425) * U3_23 + T(1.1812) *
      (minus_U3_22 - minus_U3_33) + T(7.0755) * U3_31 - T(1.5821) * U3_21;
  const T N3_2 = T(2.665) * Pddot3_1 + T(0.35425) * U3_13 + T(0.35425) * U3_31 + T(1.5821) * (minus_U3_33 -
      minus_U3_11) + T(1.1812) * U3_12 - T(7.0755) * U3_32;
  const T N3_3 = T(7.0755) * (minus_U3_11 - minus_U3_22) - (T(0.35425) * U3_21 + T(7.6365) * U3_12) + T(1.5821) *
      U3_23 - T(1.1812) * U3_13 - T(11.89) * Pddot3_1;

  // ---- body 4 (body_4) on body 3
  const T thetadot4 = y[3];
  const T thetaddot4 = ydot[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T minus_E4_13 = sines[3];
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
  const T t4_7 = Pddot3_1 + U3_13 * T(0.1) - minus_U3_11 * T(0.6);
  const T t4_8 = Pddot3_3 + U3_31 * T(0.6) - minus_U3_33 * T(0.1);
  const T Pddot4_1 = E4_11 * t4_7 - minus_E4_13 * t4_8;
  const T Pddot4_2 = Pddot3_2 + U3_21 * T(0.6) + U3_23 * T(0.1);
  const T Pddot4_3 = minus_E4_13 * t4_7 + E4_11 * t4_8;
  // G4 = U4 h_own_4: inertia less applied force, body axes [N]
  const T G4_1 = U4_13 * T(4.915) - minus_U4_11 * T(7.52);
  const T G4_2 = U4_21 * T(7.52) + U4_23 * T(4.915);
  const T G4_3 = U4_31 * T(7.52) - minus_U4_33 * T(4.915);
  // N4 = h_own_4~ Pddot4 + axial(U4 (tr(J_own_4)/2 - J_own_4)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N4_1 = T(2.2138500000000003) * (minus_U4_22 - minus_U4_33) - (T(2.298) * U4_32 + T(3.34825) * U4_23) +
      T(3.37) * U4_31 - T(1.4563) * U4_21 - T(4.915) * Pddot4_2;
  const T N4_2 = T(4.915) * Pddot4_1 - T(7.52) * Pddot4_3 + T(3.34825) * U4_13 - T(2.298) * U4_31 + T(1.4563) *
      (minus_U4_33 - minus_U4_11) + T(2.2138500000000003) * U4_12 - T(3.37) * U4_32;
  const T N4_3 = T(7.52) * Pddot4_2 + T(2.298) * U4_21 + T(2.298) * U4_12 + T(3.37) * (minus_U4_11 - minus_U4_22) +
      T(1.4563) * U4_23 - T(2.2138500000000003) * U4_13;

  // ---- body 5 (body_5) on body 4
  const T thetadot5 = y[4];
  const T thetaddot5 = ydot[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];
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
  const T t5_7 = Pddot4_1 + U4_12 * T(0.45) - minus_U4_11 * T(0.3);
  const T t5_8 = Pddot4_2 + U4_21 * T(0.3) - minus_U4_22 * T(0.45);
  const T Pddot5_1 = E5_11 * t5_7 + E5_12 * t5_8;
  const T Pddot5_2 = E5_11 * t5_8 - E5_12 * t5_7;
  const T Pddot5_3 = Pddot4_3 + U4_31 * T(0.3) + U4_32 * T(0.45);
  // G5 = U5 h_own_5: inertia less applied force, body axes [N]
  const T G5_1 = U5_12 * T(7.2299999999999995) - minus_U5_11 * T(13.69);
  const T G5_2 = U5_21 * T(13.69) - minus_U5_22 * T(7.2299999999999995);
  const T G5_3 = U5_31 * T(13.69) + U5_32 * T(7.2299999999999995);
  // N5 = h_own_5~ Pddot5 + axial(U5 (tr(J_own_5)/2 - J_own_5)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N5_1 = T(7.2299999999999995) * Pddot5_3 + T(2.1839999999999997) * U5_32 + T(2.1839999999999997) * U5_23 +
      T(1.437) * (minus_U5_22 - minus_U5_33) + T(4.084499999999999) * U5_31 - T(2.726) * U5_21;
  const T N5_2 = T(2.726) * (minus_U5_33 - minus_U5_11) - (T(2.1839999999999997) * U5_13 + T(8.497) * U5_31) +
      T(1.437) * U5_12 - T(4.084499999999999) * U5_32 - T(13.69) * Pddot5_3;
  const T N5_3 = T(13.69) * Pddot5_2 - T(7.2299999999999995) * Pddot5_1 + T(8.497) * U5_21 - T(2.1839999999999997) *
      U5_12 + T(4.084499999999999) * (minus_U5_11 - minus_U5_22) + T(2.726) * U5_23 - T(1.437) * U5_13;

  // ---- body 6 (body_6) on body 5
  const T thetadot6 = y[5];
  const T thetaddot6 = ydot[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[5];
  const T E6_23 = sines[5];
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
  const T Pddot6_1 = Pddot5_1 + U5_12 * T(0.3) + U5_13 * T(0.2);
  const T t6_7 = Pddot5_2 + U5_23 * T(0.2) - minus_U5_22 * T(0.3);
  const T t6_8 = Pddot5_3 + U5_32 * T(0.3) - minus_U5_33 * T(0.2);
  const T Pddot6_2 = E6_22 * t6_7 + E6_23 * t6_8;
  const T Pddot6_3 = E6_22 * t6_8 - E6_23 * t6_7;
  // G6 = U6 h_own_6: inertia less applied force, body axes [N]
  const T G6_1 = U6_12 * T(16.105) + U6_13 * T(2.23);
  const T G6_2 = U6_23 * T(2.23) - minus_U6_22 * T(16.105);
  const T G6_3 = U6_32 * T(16.105) - minus_U6_33 * T(2.23);
  // N6 = h_own_6~ Pddot6 + axial(U6 (tr(J_own_6)/2 - J_own_6)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N6_1 = T(16.105) * Pddot6_3 - T(2.23) * Pddot6_2 + T(13.69875) * U6_32 - T(0.331) * U6_23 + T(1.6009) *
      (minus_U6_22 - minus_U6_33) + T(9.591) * U6_31 - T(1.3172) * U6_21;
  const T N6_2 = T(2.23) * Pddot6_1 + T(0.331) * U6_13 + T(0.331) * U6_31 + T(1.3172) * (minus_U6_33 - minus_U6_11) +
      T(1.6009) * U6_12 - T(9.591) * U6_32;
  const T N6_3 = T(9.591) * (minus_U6_11 - minus_U6_22) - (T(0.331) * U6_21 + T(13.69875) * U6_12) + T(1.3172) * U6_23
      - T(1.6009) * U6_13 - T(16.105) * Pddot6_1;

  // ---- body 7 (body_7) on body 6
  const T thetadot7 = y[6];
  const T thetaddot7 = ydot[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T minus_E7_13 = sines[6];
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
  const T t7_7 = Pddot6_1 + U6_13 * T(0.1) - minus_U6_11 * T(0.6);
  const T t7_8 = Pddot6_3 + U6_31 * T(0.6) - minus_U6_33 * T(0.1);
  const T Pddot7_1 = E7_11 * t7_7 - minus_E7_13 * t7_8;
  const T Pddot7_2 = Pddot6_2 + U6_21 * T(0.6) + U6_23 * T(0.1);
  const T Pddot7_3 = minus_E7_13 * t7_7 + E7_11 * t7_8;
  // G7 = U7 h_own_7: inertia less applied force, body axes [N]
  const T G7_1 = U7_13 * T(3.955) - minus_U7_11 * T(6.109999999999999);
  const T G7_2 = U7_21 * T(6.109999999999999) + U7_23 * T(3.955);
  const T G7_3 = U7_31 * T(6.109999999999999) - minus_U7_33 * T(3.955);
  // N7 = h_own_7~ Pddot7 + axial(U7 (tr(J_own_7)/2 - J_own_7)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N7_1 = T(2.9560500000000003) * (minus_U7_22 - minus_U7_33) - (T(1.884) * U7_32 + T(4.78075) * U7_23) +
      T(4.54) * U7_31 - T(1.1644) * U7_21 - T(3.955) * Pddot7_2;
  const T N7_2 = T(3.955) * Pddot7_1 - T(6.109999999999999) * Pddot7_3 + T(4.78075) * U7_13 - T(1.884) * U7_31 +
      T(1.1644) * (minus_U7_33 - minus_U7_11) + T(2.9560500000000003) * U7_12 - T(4.54) * U7_32;
  const T N7_3 = T(6.109999999999999) * Pddot7_2 + T(1.884) * U7_21 + T(1.884) * U7_12 + T(4.54) * (minus_U7_11 -
      minus_U7_22) + T(1.1644) * U7_23 - T(2.9560500000000003) * U7_13;

  // ---- body 8 (body_8) on body 7
  const T thetadot8 = y[7];
  const T thetaddot8 = ydot[7];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[7];
  const T E8_12 = sines[7];
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
  const T t8_7 = Pddot7_1 + U7_12 * T(0.75) - minus_U7_11 * T(0.3);
  const T t8_8 = Pddot7_2 + U7_21 * T(0.3) - minus_U7_22 * T(0.75);
  const T Pddot8_1 = E8_11 * t8_7 + E8_12 * t8_8;
  const T Pddot8_2 = E8_11 * t8_8 - E8_12 * t8_7;
  const T Pddot8_3 = Pddot7_3 + U7_31 * T(0.3) + U7_32 * T(0.75);
  // G8 = U8 h_own_8: inertia less applied force, body axes [N]
  const T G8_1 = U8_12 * T(8.46) - minus_U8_11 * T(10.6);
  const T G8_2 = U8_21 * T(10.6) - minus_U8_22 * T(8.46);
  const T G8_3 = U8_31 * T(10.6) + U8_32 * T(8.46);
  // N8 = h_own_8~ Pddot8 + axial(U8 (tr(J_own_8)/2 - J_own_8)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N8_1 = T(8.46) * Pddot8_3 + T(3.7710000000000004) * U8_32 + T(3.7710000000000004) * U8_23 + T(1.6812) *
      (minus_U8_22 - minus_U8_33) + T(4.716) * U8_31 - T(2.1056) * U8_21;
  const T N8_2 = T(2.1056) * (minus_U8_33 - minus_U8_11) - (T(3.7710000000000004) * U8_13 + T(6.60175) * U8_31) +
      T(1.6812) * U8_12 - T(4.716) * U8_32 - T(10.6) * Pddot8_3;
  const T N8_3 = T(10.6) * Pddot8_2 - T(8.46) * Pddot8_1 + T(6.60175) * U8_21 - T(3.7710000000000004) * U8_12 +
      T(4.716) * (minus_U8_11 - minus_U8_22) + T(2.1056) * U8_23 - T(1.6812) * U8_13;

  // ---- body 9 (body_9) on body 8
  const T thetadot9 = y[8];
  const T thetaddot9 = ydot[8];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_22 = cosines[8];
  const T E9_23 = sines[8];
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
  const T Pddot9_1 = Pddot8_1 + U8_12 * T(0.45) + U8_13 * T(0.2);
  const T t9_7 = Pddot8_2 + U8_23 * T(0.2) - minus_U8_22 * T(0.45);
  const T t9_8 = Pddot8_3 + U8_32 * T(0.45) - minus_U8_33 * T(0.2);
  const T Pddot9_2 = E9_22 * t9_7 + E9_23 * t9_8;
  const T Pddot9_3 = E9_22 * t9_8 - E9_23 * t9_7;
  // G9 = U9 h_own_9: inertia less applied force, body axes [N]
  const T G9_1 = U9_12 * T(16.585) + U9_13 * T(1.705);
  const T G9_2 = U9_23 * T(1.705) - minus_U9_22 * T(16.585);
  const T G9_3 = U9_32 * T(16.585) - minus_U9_33 * T(1.705);
  // N9 = h_own_9~ Pddot9 + axial(U9 (tr(J_own_9)/2 - J_own_9)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N9_1 = T(16.585) * Pddot9_3 - T(1.705) * Pddot9_2 + T(18.10725) * U9_32 - T(0.29875) * U9_23 +
      T(1.6471000000000002) * (minus_U9_22 - minus_U9_33) + T(9.8655) * U9_31 - T(0.9983000000000001) * U9_21;
  const T N9_2 = T(1.705) * Pddot9_1 + T(0.29875) * U9_13 + T(0.29875) * U9_31 + T(0.9983000000000001) * (minus_U9_33
      - minus_U9_11) + T(1.6471000000000002) * U9_12 - T(9.8655) * U9_32;
  const T N9_3 = T(9.8655) * (minus_U9_11 - minus_U9_22) - (T(0.29875) * U9_21 + T(18.10725) * U9_12) +
      T(0.9983000000000001) * U9_23 - T(1.6471000000000002) * U9_13 - T(16.585) * Pddot9_1;

  // ---- body 10 (body_10) on body 9
  const T thetadot10 = y[9];
  const T thetaddot10 = ydot[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_11 = cosines[9];
  const T minus_E10_13 = sines[9];
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
  const T t10_7 = Pddot9_1 + U9_13 * T(0.1) - minus_U9_11 * T(0.6);
  const T t10_8 = Pddot9_3 + U9_31 * T(0.6) - minus_U9_33 * T(0.1);
  const T Pddot10_1 = E10_11 * t10_7 - minus_E10_13 * t10_8;
  const T Pddot10_2 = Pddot9_2 + U9_21 * T(0.6) + U9_23 * T(0.1);
  const T Pddot10_3 = minus_E10_13 * t10_7 + E10_11 * t10_8;
  // G10 = U10 h_own_10: inertia less applied force, body axes [N]
  const T G10_1 = U10_13 * T(2.8150000000000004) - minus_U10_11 * T(4.43);
  const T G10_2 = U10_21 * T(4.43) + U10_23 * T(2.8150000000000004);
  const T G10_3 = U10_31 * T(4.43) - minus_U10_33 * T(2.8150000000000004);
  // N10 = h_own_10~ Pddot10 + axial(U10 (tr(J_own_10)/2 - J_own_10)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N10_1 = T(2.9287500000000004) * (minus_U10_22 - minus_U10_33) - (T(1.389) * U10_32 + T(5.28625) * U10_23) +
      T(4.5715) * U10_31 - T(0.8185) * U10_21 - T(2.8150000000000004) * Pddot10_2;
  const T N10_2 = T(2.8150000000000004) * Pddot10_1 - T(4.43) * Pddot10_3 + T(5.28625) * U10_13 - T(1.389) * U10_31 +
      T(0.8185) * (minus_U10_33 - minus_U10_11) + T(2.9287500000000004) * U10_12 - T(4.5715) * U10_32;
  const T N10_3 = T(4.43) * Pddot10_2 + T(1.389) * U10_21 + T(1.389) * U10_12 + T(4.5715) * (minus_U10_11 -
      minus_U10_22) + T(0.8185) * U10_23 - T(2.9287500000000004) * U10_13;

  // ---- body 11 (body_11) on body 10
  const T thetadot11 = y[10];
  const T thetaddot11 = ydot[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[10];
  const T E11_12 = sines[10];
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
  const T t11_7 = Pddot10_1 + U10_12 * T(1.05) - minus_U10_11 * T(0.3);
  const T t11_8 = Pddot10_2 + U10_21 * T(0.3) - minus_U10_22 * T(1.05);
  const T Pddot11_1 = E11_11 * t11_7 + E11_12 * t11_8;
  const T Pddot11_2 = E11_11 * t11_8 - E11_12 * t11_7;
  const T Pddot11_3 = Pddot10_3 + U10_31 * T(0.3) + U10_32 * T(1.05);
  // G11 = U11 h_own_11: inertia less applied force, body axes [N]
  const T G11_1 = U11_12 * T(7.62) - minus_U11_11 * T(6.97);
  const T G11_2 = U11_21 * T(6.97) - minus_U11_22 * T(7.62);
  const T G11_3 = U11_31 * T(6.97) + U11_32 * T(7.62);
  // N11 = h_own_11~ Pddot11 + axial(U11 (tr(J_own_11)/2 - J_own_11)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N11_1 = T(7.62) * Pddot11_3 + T(4.467) * U11_32 + T(4.467) * U11_23 + T(1.5114) * (minus_U11_22 -
      minus_U11_33) + T(4.0874999999999995) * U11_31 - T(1.3772) * U11_21;
  const T N11_2 = T(1.3772) * (minus_U11_33 - minus_U11_11) - (T(4.467) * U11_13 + T(4.3735) * U11_31) + T(1.5114) *
      U11_12 - T(4.0874999999999995) * U11_32 - T(6.97) * Pddot11_3;
  const T N11_3 = T(6.97) * Pddot11_2 - T(7.62) * Pddot11_1 + T(4.3735) * U11_21 - T(4.467) * U11_12 +
      T(4.0874999999999995) * (minus_U11_11 - minus_U11_22) + T(1.3772) * U11_23 - T(1.5114) * U11_13;

  // ---- body 12 (body_12) on body 11
  const T thetadot12 = y[11];
  const T thetaddot12 = ydot[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_22 = cosines[11];
  const T E12_23 = sines[11];
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
  const T Pddot12_1 = Pddot11_1 + U11_12 * T(0.6) + U11_13 * T(0.2);
  const T t12_7 = Pddot11_2 + U11_23 * T(0.2) - minus_U11_22 * T(0.6);
  const T t12_8 = Pddot11_3 + U11_32 * T(0.6) - minus_U11_33 * T(0.2);
  const T Pddot12_2 = E12_22 * t12_7 + E12_23 * t12_8;
  const T Pddot12_3 = E12_22 * t12_8 - E12_23 * t12_7;
  // G12 = U12 h_own_12: inertia less applied force, body axes [N]
  const T G12_1 = U12_12 * T(12.52) + U12_13 * T(1.09);
  const T G12_2 = U12_23 * T(1.09) - minus_U12_22 * T(12.52);
  const T G12_3 = U12_32 * T(12.52) - minus_U12_33 * T(1.09);
  // N12 = h_own_12~ Pddot12 + axial(U12 (tr(J_own_12)/2 - J_own_12)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N12_1 = T(12.52) * Pddot12_3 - T(1.09) * Pddot12_2 + T(16.3665) * U12_32 - T(0.2575) * U12_23 +
      T(1.2388000000000001) * (minus_U12_22 - minus_U12_33) + T(7.412999999999999) * U12_31 - T(0.6254) * U12_21;
  const T N12_2 = T(1.09) * Pddot12_1 + T(0.2575) * U12_13 + T(0.2575) * U12_31 + T(0.6254) * (minus_U12_33 -
      minus_U12_11) + T(1.2388000000000001) * U12_12 - T(7.412999999999999) * U12_32;
  const T N12_3 = T(7.412999999999999) * (minus_U12_11 - minus_U12_22) - (T(0.2575) * U12_21 + T(16.3665) * U12_12) +
      T(0.6254) * U12_23 - T(1.2388000000000001) * U12_13 - T(12.52) * Pddot12_1;

  // ---- body 13 (body_13) on body 12
  const T thetadot13 = y[12];
  const T thetaddot13 = ydot[12];
  // E13^T = Rot(b13, theta13): E takes components in the lower body to those in the body
  const T E13_11 = cosines[12];
  const T minus_E13_13 = sines[12];
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
  const T t13_7 = Pddot12_1 + U12_13 * T(0.1) - minus_U12_11 * T(0.6);
  const T t13_8 = Pddot12_3 + U12_31 * T(0.6) - minus_U12_33 * T(0.1);
  const T Pddot13_1 = E13_11 * t13_7 - minus_E13_13 * t13_8;
  const T Pddot13_2 = Pddot12_2 + U12_21 * T(0.6) + U12_23 * T(0.1);
  const T Pddot13_3 = minus_E13_13 * t13_7 + E13_11 * t13_8;
  // G13 = U13 h_own_13: inertia less applied force, body axes [N]
  const T G13_1 = U13_13 * T(1.495) - minus_U13_11 * T(2.48);
  const T G13_2 = U13_21 * T(2.48) + U13_23 * T(1.495);
  const T G13_3 = U13_31 * T(2.48) - minus_U13_33 * T(1.495);
  // N13 = h_own_13~ Pddot13 + axial(U13 (tr(J_own_13)/2 - J_own_13)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N13_1 = T(1.96995) * (minus_U13_22 - minus_U13_33) - (T(0.813) * U13_32 + T(3.6295) * U13_23) + T(3.2215) *
      U13_31 - T(0.4186) * U13_21 - T(1.495) * Pddot13_2;
  const T N13_2 = T(1.495) * Pddot13_1 - T(2.48) * Pddot13_3 + T(3.6295) * U13_13 - T(0.813) * U13_31 + T(0.4186) *
      (minus_U13_33 - minus_U13_11) + T(1.96995) * U13_12 - T(3.2215) * U13_32;
  const T N13_3 = T(2.48) * Pddot13_2 + T(0.813) * U13_21 + T(0.813) * U13_12 + T(3.2215) * (minus_U13_11 -
      minus_U13_22) + T(0.4186) * U13_23 - T(1.96995) * U13_13;

  // ---- body 14 (body_14) on body 13
  const T thetadot14 = y[13];
  const T thetaddot14 = ydot[13];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_11 = cosines[13];
  const T E14_12 = sines[13];
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
  const T t14_7 = Pddot13_1 + U13_12 * T(1.35) - minus_U13_11 * T(0.3);
  const T t14_8 = Pddot13_2 + U13_21 * T(0.3) - minus_U13_22 * T(1.35);
  const T Pddot14_1 = E14_11 * t14_7 + E14_12 * t14_8;
  const T Pddot14_2 = E14_11 * t14_8 - E14_12 * t14_7;
  const T Pddot14_3 = Pddot13_3 + U13_31 * T(0.3) + U13_32 * T(1.35);
  // G14 = U14 h_own_14: inertia less applied force, body axes [N]
  const T G14_1 = U14_12 * T(4.305) - minus_U14_11 * T(2.8);
  const T G14_2 = U14_21 * T(2.8) - minus_U14_22 * T(4.305);
  const T G14_3 = U14_31 * T(2.8) + U14_32 * T(4.305);
  // N14 = h_own_14~ Pddot14 + axial(U14 (tr(J_own_14)/2 - J_own_14)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N14_1 = T(4.305) * Pddot14_3 + T(3.03675) * U14_32 + T(3.03675) * U14_23 + T(0.8466) * (minus_U14_22 -
      minus_U14_33) + T(1.956) * U14_31 - T(0.5408000000000001) * U14_21;
  const T N14_2 = T(0.5408000000000001) * (minus_U14_33 - minus_U14_11) - (T(3.03675) * U14_13 + T(1.81225) * U14_31)
      + T(0.8466) * U14_12 - T(1.956) * U14_32 - T(2.8) * Pddot14_3;
  const T N14_3 = T(2.8) * Pddot14_2 - T(4.305) * Pddot14_1 + T(1.81225) * U14_21 - T(3.03675) * U14_12 + T(1.956) *
      (minus_U14_11 - minus_U14_22) + T(0.5408000000000001) * U14_23 - T(0.8466) * U14_13;

  // ---- body 15 (body_15) on body 14
  const T thetadot15 = y[14];
  const T thetaddot15 = ydot[14];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_22 = cosines[14];
  const T E15_23 = sines[14];
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
  const T Pddot15_1 = Pddot14_1 + U14_12 * T(0.75) + U14_13 * T(0.2);
  const T t15_7 = Pddot14_2 + U14_23 * T(0.2) - minus_U14_22 * T(0.75);
  const T t15_8 = Pddot14_3 + U14_32 * T(0.75) - minus_U14_33 * T(0.2);
  const T Pddot15_2 = E15_22 * t15_7 + E15_23 * t15_8;
  const T Pddot15_3 = E15_22 * t15_8 - E15_23 * t15_7;
  // G15 = U15 h_own_15: inertia less applied force, body axes [N]
  const T G15_1 = U15_12 * T(3.1) + U15_13 * T(0.385);
  const T G15_2 = U15_23 * T(0.385) - minus_U15_22 * T(3.1);
  const T G15_3 = U15_32 * T(3.1) - minus_U15_33 * T(0.385);
  // N15 = h_own_15~ Pddot15 + axial(U15 (tr(J_own_15)/2 - J_own_15)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N15_1 = T(3.1) * Pddot15_3 - T(0.385) * Pddot15_2 + T(3.03084) * U15_32 - T(0.20725) * U15_23 +
      T(0.29500000000000004) * (minus_U15_22 - minus_U15_33) + T(1.7475) * U15_31 - T(0.1985) * U15_21;
  const T N15_2 = T(0.385) * Pddot15_1 + T(0.20725) * U15_13 + T(0.20725) * U15_31 + T(0.1985) * (minus_U15_33 -
      minus_U15_11) + T(0.29500000000000004) * U15_12 - T(1.7475) * U15_32;
  const T N15_3 = T(1.7475) * (minus_U15_11 - minus_U15_22) - (T(0.20725) * U15_21 + T(3.03084) * U15_12) + T(0.1985)
      * U15_23 - T(0.29500000000000004) * U15_13 - T(3.1) * Pddot15_1;

  // ---- body 16 (body_16) on body 15
  const T thetadot16 = y[15];
  const T thetaddot16 = ydot[15];
  // E16^T = Z16^T Rot(b16, theta16): E takes components in the lower body to those in the body
  const T t16_1 = cosines[15];
  const T t16_2 = sines[15];
  const T E16_11 = T(0.44721359549995804) * t16_1 - T(0.8944271909999159) * t16_2;
  const T minus_E16_13 = T(0.8944271909999159) * t16_1 + T(0.44721359549995804) * t16_2;
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
  const T t16_3 = omega16_3 * omega16_3;
  const T t16_4 = omega16_2 * omega16_2;
  const T minus_U16_11 = t16_3 + t16_4;
  const T t16_5 = omega16_2 * omega16_1;
  const T U16_12 = t16_5 - omegadot16_3;
  const T t16_6 = omega16_3 * omega16_1;
  const T U16_13 = t16_6 + omegadot16_2;
  const T U16_21 = t16_5 + omegadot16_3;
  const T t16_7 = omega16_1 * omega16_1;
  const T minus_U16_22 = t16_3 + t16_7;
  const T t16_8 = omega16_3 * omega16_2;
  const T U16_23 = t16_8 - omegadot16_1;
  const T U16_31 = t16_6 - omegadot16_2;
  const T U16_32 = t16_8 + omegadot16_1;
  const T minus_U16_33 = t16_4 + t16_7;
  // Pddot16 = E16 (U15 q16 + Pddot15): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot16_1 = E16_11 * (Pddot15_1 + U15_13 * T(0.1) - minus_U15_11 * T(0.6)) - minus_E16_13 * (Pddot15_3 +
      U15_31 * T(0.6) - minus_U15_33 * T(0.1));
  const T Pddot16_2 = Pddot15_2 + U15_21 * T(0.6) + U15_23 * T(0.1);
  // G16 = U16 h_own_16: inertia less applied force, body axes [N]
  const T G16_1 = U16_13 * T(0.2906888370749727);
  const T G16_2 = U16_23 * T(0.2906888370749727);
  const T minus_G16_3 = minus_U16_33 * T(0.2906888370749727);
  // N16 = h_own_16~ Pddot16 + axial(U16 (tr(J_own_16)/2 - J_own_16)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N16_1 = T(0.28371230498517336) * (minus_U16_22 - minus_U16_33) - (T(0.17784) * U16_32 + T(0.16666) * U16_23)
      - T(0.015115819527898578) * U16_31 + T(0.016120000000000013) * U16_21 - T(0.2906888370749727) * Pddot16_2;
  const T N16_2 = T(0.2906888370749727) * Pddot16_1 + T(0.16666) * U16_13 - T(0.17784) * U16_31 -
      T(0.016120000000000013) * (minus_U16_33 - minus_U16_11) + T(0.28371230498517336) * U16_12 +
      T(0.015115819527898578) * U16_32;
  const T N16_3 = T(0.17784) * U16_21 + T(0.17784) * U16_12 - T(0.015115819527898578) * (minus_U16_11 - minus_U16_22)
      - T(0.016120000000000013) * U16_23 - T(0.28371230498517336) * U16_13;

  // ---- body 16 (body_16) and what it carries
  // r_theta16 = b16 . N16 - tau_body_16_: Kane's equation of the angle [N m]
  const T r_theta16 = N16_2 - u.tau_16;
  r[15] = r_theta16;

  // ---- body 15 (body_15) and what it carries
  // S15 = E16^T G16 + G15: sum of the force balances of the subtree, body axes [N]
  const T b15_1 = E16_11 * G16_1 - minus_E16_13 * minus_G16_3;
  const T S15_1 = b15_1 + G15_1;
  const T S15_2 = G16_2 + G15_2;
  const T b15_2 = minus_E16_13 * G16_1 + E16_11 * minus_G16_3;
  const T S15_3 = G15_3 - b15_2;
  // rho15 = q16~ E16^T G16 + E16^T N16 + N15: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho15_1 = N15_1 + E16_11 * N16_1 + minus_E16_13 * N16_3 - T(0.1) * G16_2;
  const T rho15_2 = N16_2 + N15_2 + T(0.1) * b15_1 + T(0.6) * b15_2;
  const T rho15_3 = N15_3 + T(0.6) * G16_2 + E16_11 * N16_3 - minus_E16_13 * N16_1;
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
  // rho14 = q15~ E15^T S15 + E15^T rho15 + N14: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho14_1 = rho15_1 + N14_1 + T(0.75) * b14_2 - T(0.2) * b14_1;
  const T rho14_2 = N14_2 + T(0.2) * S15_1 + E15_22 * rho15_2 - E15_23 * rho15_3;
  const T rho14_3 = N14_3 + E15_23 * rho15_2 + E15_22 * rho15_3 - T(0.75) * S15_1;
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
  // rho13 = q14~ E14^T S14 + E14^T rho14 + N13: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho13_1 = N13_1 + T(1.35) * S14_3 + E14_11 * rho14_1 - E14_12 * rho14_2;
  const T rho13_2 = N13_2 + E14_12 * rho14_1 + E14_11 * rho14_2 - T(0.3) * S14_3;
  const T rho13_3 = rho14_3 + N13_3 + T(0.3) * b13_2 - T(1.35) * b13_1;
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
  // rho12 = q13~ E13^T S13 + E13^T rho13 + N12: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho12_1 = N12_1 + E13_11 * rho13_1 + minus_E13_13 * rho13_3 - T(0.1) * S13_2;
  const T rho12_2 = rho13_2 + N12_2 + T(0.1) * b12_1 - T(0.6) * b12_2;
  const T rho12_3 = N12_3 + T(0.6) * S13_2 + E13_11 * rho13_3 - minus_E13_13 * rho13_1;
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
  // rho11 = q12~ E12^T S12 + E12^T rho12 + N11: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho11_1 = rho12_1 + N11_1 + T(0.6) * b11_2 - T(0.2) * b11_1;
  const T rho11_2 = N11_2 + T(0.2) * S12_1 + E12_22 * rho12_2 - E12_23 * rho12_3;
  const T rho11_3 = N11_3 + E12_23 * rho12_2 + E12_22 * rho12_3 - T(0.6) * S12_1;
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
  // rho10 = q11~ E11^T S11 + E11^T rho11 + N10: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho10_1 = N10_1 + T(1.05) * S11_3 + E11_11 * rho11_1 - E11_12 * rho11_2;
  const T rho10_2 = N10_2 + E11_12 * rho11_1 + E11_11 * rho11_2 - T(0.3) * S11_3;
  const T rho10_3 = rho11_3 + N10_3 + T(0.3) * b10_2 - T(1.05) * b10_1;
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
  // rho9 = q10~ E10^T S10 + E10^T rho10 + N9: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho9_1 = N9_1 + E10_11 * rho10_1 + minus_E10_13 * rho10_3 - T(0.1) * S10_2;
  const T rho9_2 = rho10_2 + N9_2 + T(0.1) * b9_1 - T(0.6) * b9_2;
  const T rho9_3 = N9_3 + T(0.6) * S10_2 + E10_11 * rho10_3 - minus_E10_13 * rho10_1;
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
  // rho8 = q9~ E9^T S9 + E9^T rho9 + N8: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho8_1 = rho9_1 + N8_1 + T(0.45) * b8_2 - T(0.2) * b8_1;
  const T rho8_2 = N8_2 + T(0.2) * S9_1 + E9_22 * rho9_2 - E9_23 * rho9_3;
  const T rho8_3 = N8_3 + E9_23 * rho9_2 + E9_22 * rho9_3 - T(0.45) * S9_1;
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
  // rho7 = q8~ E8^T S8 + E8^T rho8 + N7: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho7_1 = N7_1 + T(0.75) * S8_3 + E8_11 * rho8_1 - E8_12 * rho8_2;
  const T rho7_2 = N7_2 + E8_12 * rho8_1 + E8_11 * rho8_2 - T(0.3) * S8_3;
  const T rho7_3 = rho8_3 + N7_3 + T(0.3) * b7_2 - T(0.75) * b7_1;
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
  // rho6 = q7~ E7^T S7 + E7^T rho7 + N6: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho6_1 = N6_1 + E7_11 * rho7_1 + minus_E7_13 * rho7_3 - T(0.1) * S7_2;
  const T rho6_2 = rho7_2 + N6_2 + T(0.1) * b6_1 - T(0.6) * b6_2;
  const T rho6_3 = N6_3 + T(0.6) * S7_2 + E7_11 * rho7_3 - minus_E7_13 * rho7_1;
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
  // rho5 = q6~ E6^T S6 + E6^T rho6 + N5: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho5_1 = rho6_1 + N5_1 + T(0.3) * b5_2 - T(0.2) * b5_1;
  const T rho5_2 = N5_2 + T(0.2) * S6_1 + E6_22 * rho6_2 - E6_23 * rho6_3;
  const T rho5_3 = N5_3 + E6_23 * rho6_2 + E6_22 * rho6_3 - T(0.3) * S6_1;
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
  // rho4 = q5~ E5^T S5 + E5^T rho5 + N4: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho4_1 = N4_1 + T(0.45) * S5_3 + E5_11 * rho5_1 - E5_12 * rho5_2;
  const T rho4_2 = N4_2 + E5_12 * rho5_1 + E5_11 * rho5_2 - T(0.3) * S5_3;
  const T rho4_3 = rho5_3 + N4_3 + T(0.3) * b4_2 - T(0.45) * b4_1;
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
  // rho3 = q4~ E4^T S4 + E4^T rho4 + N3: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho3_1 = N3_1 + E4_11 * rho4_1 + minus_E4_13 * rho4_3 - T(0.1) * S4_2;
  const T rho3_2 = rho4_2 + N3_2 + T(0.1) * b3_1 - T(0.6) * b3_2;
  const T rho3_3 = N3_3 + T(0.6) * S4_2 + E4_11 * rho4_3 - minus_E4_13 * rho4_1;
  // r_theta3 = b3 . rho3 - tau_body_3_: Kane's equation of the angle [N m]
  const T r_theta3 = rho3_1 - u.tau_3;
  r[2] = r_theta3;

  // ---- body 2 (body_2) and what it carries
  // S2 = E3^T S3 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = E3_23 * S3_2 + E3_22 * S3_3;
  const T S2_3 = b2_1 + G2_3;
  // rho2 = q3~ E3^T S3 + E3^T rho3 + N2: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho2_1 = rho3_1 + N2_1 + T(0.15) * b2_1 - T(0.2) * (E3_22 * S3_2 - E3_23 * S3_3);
  const T rho2_2 = N2_2 + T(0.2) * S3_1 + E3_22 * rho3_2 - E3_23 * rho3_3;
  const T rho2_3 = N2_3 + E3_23 * rho3_2 + E3_22 * rho3_3 - T(0.15) * S3_1;
  // r_theta2 = b2 . rho2 - tau_body_2_: Kane's equation of the angle [N m]
  const T r_theta2 = rho2_3 - u.tau_2;
  r[1] = r_theta2;

  // ---- body 1 (body_1) and what it carries
  // rho1 = q2~ E2^T S2 + E2^T rho2 + N1: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho1_2 = N1_2 + E2_12 * rho2_1 + E2_11 * rho2_2 - T(0.3) * S2_3;
  // r_theta1 = b1 . rho1 - tau_body_1_: Kane's equation of the angle [N m]
  const T r_theta1 = rho1_2 - u.tau_1;
  r[0] = r_theta1;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 1080 add, 1387 multiply, 30 sine or cosine
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 15, cosines + 1, sines + 1);

  // ---- body 2 (body_2) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T E2_12 = sines[1];

  // ---- body 3 (body_3) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_22 = cosines[2];
  const T E3_23 = sines[2];

  // ---- body 4 (body_4) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T minus_E4_13 = sines[3];

  // ---- body 5 (body_5) on body 4
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];

  // ---- body 6 (body_6) on body 5
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[5];
  const T E6_23 = sines[5];

  // ---- body 7 (body_7) on body 6
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T minus_E7_13 = sines[6];

  // ---- body 8 (body_8) on body 7
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[7];
  const T E8_12 = sines[7];

  // ---- body 9 (body_9) on body 8
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_22 = cosines[8];
  const T E9_23 = sines[8];

  // ---- body 10 (body_10) on body 9
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_11 = cosines[9];
  const T minus_E10_13 = sines[9];

  // ---- body 11 (body_11) on body 10
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[10];
  const T E11_12 = sines[10];

  // ---- body 12 (body_12) on body 11
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_22 = cosines[11];
  const T E12_23 = sines[11];

  // ---- body 13 (body_13) on body 12
  // E13^T = Rot(b13, theta13): E takes components in the lower body to those in the body
  const T E13_11 = cosines[12];
  const T minus_E13_13 = sines[12];

  // ---- body 14 (body_14) on body 13
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_11 = cosines[13];
  const T E14_12 = sines[13];

  // ---- body 15 (body_15) on body 14
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_22 = cosines[14];
  const T E15_23 = sines[14];

  // ---- body 16 (body_16) on body 15
  // E16^T = Z16^T Rot(b16, theta16): E takes components in the lower body to those in the body
  const T t16_1 = cosines[15];
  const T t16_2 = sines[15];
  const T E16_11 = T(0.44721359549995804) * t16_1 - T(0.8944271909999159) * t16_2;
  const T minus_E16_13 = T(0.8944271909999159) * t16_1 + T(0.44721359549995804) * t16_2;

  // ---- body 16 (body_16) and what it carries
  // hc16 = E16^T h_own_16: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc16_1 = minus_E16_13 * T(0.2906888370749727);
  const T hc16_3 = E16_11 * T(0.2906888370749727);

  // ---- body 15 (body_15) and what it carries
  // h15 = h_own_15 + hc16: first moment of mass carried, about the body origin, body axes [kg m]
  const T h15_3 = T(0.385) + hc16_3;
  // J15 = -q16~ hc16~ + E16^T J_own_16 E16 + J_own_15 - hc16~ q16~: inertia carried, about the body origin, body axes
  //   [kg m^2]
  const T b15_1 = minus_E16_13 * T(0.01118) + T(2) * E16_11 * T(0.016120000000000013);
  const T b15_2 = minus_E16_13 * b15_1;
  const T b15_3 = T(0.2) * hc16_3;
  const T J15_11 = b15_2 + T(3.22691) + b15_3;
  const T b15_4 = E16_11 * T(0.015115819527898578) - minus_E16_13 * T(0.28371230498517336);
  const T J15_12 = b15_4 - T(1.7475);
  const T J15_13 = E16_11 * b15_1 - T(0.21462000000000003) - T(0.1) * hc16_1 - T(0.6) * hc16_3;
  const T b15_5 = T(0.1) * hc16_3 + T(0.6) * hc16_1;
  const T b15_6 = b15_5 + T(0.34450000000000003);
  const T J15_22 = b15_6 + b15_5;
  const T b15_7 = minus_E16_13 * T(0.015115819527898578) + E16_11 * T(0.28371230498517336);
  const T minus_J15_23 = b15_7 + T(0.29500000000000004);
  const T J15_33 = T(2.8235900000000003) - b15_2 + T(1.2) * hc16_1;
  A[238] = J15_11;
  // hc15 = E15^T h15: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc15_2 = E15_22 * T(3.1) - E15_23 * h15_3;
  const T hc15_3 = E15_22 * h15_3 + E15_23 * T(3.1);
  A[239] = b15_4;
  A[254] = b15_4;

  // ---- body 14 (body_14) and what it carries
  // h14 = h_own_14 + hc15: first moment of mass carried, about the body origin, body axes [kg m]
  const T h14_1 = T(2.8) + hc16_1;
  const T h14_2 = T(4.305) + hc15_2;
  // J14 = -q15~ hc15~ + E15^T J15 E15 + J_own_14 - hc15~ q15~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b14_1 = T(0.2) * hc15_3 + T(0.75) * hc15_2;
  const T b14_2 = b14_1 + J15_11;
  const T J14_11 = b14_2 + b14_1;
  const T b14_3 = E15_22 * J15_12 - E15_23 * J15_13;
  const T J14_12 = b14_3 - T(1.956) - T(0.75) * hc16_1;
  const T b14_4 = E15_23 * J15_12 + E15_22 * J15_13;
  const T J14_13 = b14_4 - T(0.5408000000000001) - T(0.2) * hc16_1;
  const T b14_5 = E15_23 * (J15_22 - J15_33) - T(2) * E15_22 * minus_J15_23;
  const T b14_6 = E15_23 * b14_5;
  const T J14_22 = J15_22 - b14_6 - T(1.2245000000000001) + T(0.4) * hc15_3;
  const T J14_23 = minus_J15_23 - T(0.8466) + E15_22 * b14_5 - T(0.2) * hc15_2 - T(0.75) * hc15_3;
  const T J14_33 = J15_33 + b14_6 + T(4.849) + T(1.5) * hc15_2;
  A[221] = J14_33;
  // hc14 = E14^T h14: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc14_1 = E14_11 * h14_1 - E14_12 * h14_2;
  const T hc14_2 = E14_11 * h14_2 + E14_12 * h14_1;
  // B_thetadot16_14 = E15^T B_thetadot16_15
  const T B_thetadot16_14_2 = E15_23 * hc16_1;
  const T minus_B_thetadot16_14_3 = E15_22 * hc16_1;
  // K_thetadot16_14 = q15~ E15^T B_thetadot16_15 + E15^T K_thetadot16_15
  const T K_thetadot16_14_1 = b15_4 - T(0.2) * B_thetadot16_14_2 - T(0.75) * minus_B_thetadot16_14_3;
  const T K_thetadot16_14_2 = b15_3 + E15_22 * b15_6 + E15_23 * b15_7;
  const T K_thetadot16_14_3 = E15_23 * b15_6 - E15_22 * b15_7 - T(0.75) * hc16_3;
  A[223] = K_thetadot16_14_3;
  A[253] = K_thetadot16_14_3;
  A[222] = b14_4;
  A[237] = b14_4;

  // ---- body 13 (body_13) and what it carries
  // h13 = h_own_13 + hc14: first moment of mass carried, about the body origin, body axes [kg m]
  const T h13_1 = T(2.48) + hc14_1;
  const T h13_3 = T(1.495) + hc15_3;
  // J13 = -q14~ hc14~ + E14^T J14 E14 + J_own_13 - hc14~ q14~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b13_1 = E14_12 * (J14_11 - J14_22) + T(2) * E14_11 * J14_12;
  const T b13_2 = E14_12 * b13_1;
  const T J13_11 = J14_11 - b13_2 + T(2.8165) + T(2.7) * hc14_2;
  const T J13_12 = E14_11 * b13_1 - (J14_12 + T(3.2215)) - T(1.35) * hc14_1 - T(0.3) * hc14_2;
  const T b13_3 = E14_11 * J14_13 - E14_12 * J14_23;
  const T J13_13 = b13_3 - T(0.4186) - T(0.3) * hc15_3;
  const T b13_4 = T(0.6) * hc14_1;
  const T J13_22 = J14_22 + b13_2 + b13_4 + T(4.4425);
  const T b13_5 = E14_12 * J14_13 + E14_11 * J14_23;
  const T J13_23 = b13_5 - T(1.96995) - T(1.35) * hc15_3;
  const T b13_6 = T(0.3) * hc14_1 + T(1.35) * hc14_2;
  const T b13_7 = b13_6 + J14_33;
  const T J13_33 = b13_7 + b13_6;
  A[204] = J13_22;
  // hc13 = E13^T h13: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc13_1 = minus_E13_13 * h13_3 + E13_11 * h13_1;
  const T hc13_3 = E13_11 * h13_3 - minus_E13_13 * h13_1;
  // B_thetadot16_13 = E14^T B_thetadot16_14
  const T B_thetadot16_13_1 = E14_11 * hc16_3 - E14_12 * B_thetadot16_14_2;
  const T B_thetadot16_13_2 = E14_12 * hc16_3 + E14_11 * B_thetadot16_14_2;
  // K_thetadot16_13 = q14~ E14^T B_thetadot16_14 + E14^T K_thetadot16_14
  const T K_thetadot16_13_1 = E14_11 * K_thetadot16_14_1 - E14_12 * K_thetadot16_14_2 - T(1.35) *
      minus_B_thetadot16_14_3;
  const T K_thetadot16_13_2 = T(0.3) * minus_B_thetadot16_14_3 + E14_12 * K_thetadot16_14_1 + E14_11 *
      K_thetadot16_14_2;
  const T K_thetadot16_13_3 = K_thetadot16_14_3 + T(0.3) * B_thetadot16_13_2 - T(1.35) * B_thetadot16_13_1;
  A[207] = K_thetadot16_13_2;
  A[252] = K_thetadot16_13_2;
  // B_thetadot15_13 = E14^T B_thetadot15_14
  const T B_thetadot15_13_1 = E14_12 * hc15_3;
  const T minus_B_thetadot15_13_2 = E14_11 * hc15_3;
  // K_thetadot15_13 = q14~ E14^T B_thetadot15_14 + E14^T K_thetadot15_14
  const T K_thetadot15_13_1 = T(1.35) * hc15_2 + E14_11 * b14_2 - E14_12 * b14_3;
  const T K_thetadot15_13_2 = E14_12 * b14_2 + E14_11 * b14_3 - T(0.3) * hc15_2;
  const T K_thetadot15_13_3 = b14_4 - T(0.3) * minus_B_thetadot15_13_2 - T(1.35) * B_thetadot15_13_1;
  A[206] = K_thetadot15_13_2;
  A[236] = K_thetadot15_13_2;
  A[205] = b13_5;
  A[220] = b13_5;

  // ---- body 12 (body_12) and what it carries
  // h12 = h_own_12 + hc13: first moment of mass carried, about the body origin, body axes [kg m]
  const T h12_2 = T(12.52) + hc14_2;
  const T h12_3 = T(1.09) + hc13_3;
  // J12 = -q13~ hc13~ + E13^T J13 E13 + J_own_12 - hc13~ q13~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b12_1 = minus_E13_13 * (J13_33 - J13_11) + T(2) * E13_11 * J13_13;
  const T b12_2 = minus_E13_13 * b12_1;
  const T b12_3 = T(0.2) * hc13_3;
  const T J12_11 = J13_11 + b12_2 + b12_3 + T(16.624);
  const T b12_4 = E13_11 * J13_12 + minus_E13_13 * J13_23;
  const T J12_12 = b12_4 - T(7.412999999999999) - T(0.6) * hc14_2;
  const T b12_5 = T(0.6) * hc13_3;
  const T J12_13 = E13_11 * b12_1 - (J13_13 + T(0.6254) + b12_5) - T(0.1) * hc13_1;
  const T b12_6 = T(0.6) * hc13_1;
  const T b12_7 = b12_6 + T(0.1) * hc13_3;
  const T b12_8 = b12_7 + J13_22;
  const T J12_22 = b12_8 + b12_7;
  const T b12_9 = E13_11 * J13_23 - minus_E13_13 * J13_12;
  const T J12_23 = b12_9 - T(1.2388000000000001) - T(0.1) * hc14_2;
  const T J12_33 = J13_33 - b12_2 + T(16.108999999999998) + T(1.2) * hc13_1;
  A[187] = J12_11;
  // hc12 = E12^T h12: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc12_2 = E12_22 * h12_2 - E12_23 * h12_3;
  const T hc12_3 = E12_22 * h12_3 + E12_23 * h12_2;
  // B_thetadot16_12 = E13^T B_thetadot16_13
  const T B_thetadot16_12_1 = E13_11 * B_thetadot16_13_1 - minus_E13_13 * minus_B_thetadot16_14_3;
  const T minus_B_thetadot16_12_3 = minus_E13_13 * B_thetadot16_13_1 + E13_11 * minus_B_thetadot16_14_3;
  // K_thetadot16_12 = q13~ E13^T B_thetadot16_13 + E13^T K_thetadot16_13
  const T K_thetadot16_12_1 = E13_11 * K_thetadot16_13_1 + minus_E13_13 * K_thetadot16_13_3 - T(0.1) *
      B_thetadot16_13_2;
  const T K_thetadot16_12_2 = K_thetadot16_13_2 + T(0.1) * B_thetadot16_12_1 + T(0.6) * minus_B_thetadot16_12_3;
  const T K_thetadot16_12_3 = T(0.6) * B_thetadot16_13_2 + E13_11 * K_thetadot16_13_3 - minus_E13_13 *
      K_thetadot16_13_1;
  A[191] = K_thetadot16_12_1;
  A[251] = K_thetadot16_12_1;
  // B_thetadot15_12 = E13^T B_thetadot15_13
  const T B_thetadot15_12_1 = E13_11 * B_thetadot15_13_1 + minus_E13_13 * hc15_2;
  const T B_thetadot15_12_3 = E13_11 * hc15_2 - minus_E13_13 * B_thetadot15_13_1;
  // K_thetadot15_12 = q13~ E13^T B_thetadot15_13 + E13^T K_thetadot15_13
  const T K_thetadot15_12_1 = T(0.1) * minus_B_thetadot15_13_2 + E13_11 * K_thetadot15_13_1 + minus_E13_13 *
      K_thetadot15_13_3;
  const T K_thetadot15_12_2 = K_thetadot15_13_2 + T(0.1) * B_thetadot15_12_1 - T(0.6) * B_thetadot15_12_3;
  const T K_thetadot15_12_3 = E13_11 * K_thetadot15_13_3 - minus_E13_13 * K_thetadot15_13_1 - T(0.6) *
      minus_B_thetadot15_13_2;
  A[190] = K_thetadot15_12_1;
  A[235] = K_thetadot15_12_1;
  // B_thetadot14_12 = E13^T B_thetadot14_13
  const T minus_B_thetadot14_12_1 = E13_11 * hc14_2;
  const T B_thetadot14_12_3 = minus_E13_13 * hc14_2;
  // K_thetadot14_12 = q13~ E13^T B_thetadot14_13 + E13^T K_thetadot14_13
  const T K_thetadot14_12_1 = E13_11 * b13_3 + minus_E13_13 * b13_7 - T(0.1) * hc14_1;
  const T K_thetadot14_12_2 = b13_5 - T(0.1) * minus_B_thetadot14_12_1 - T(0.6) * B_thetadot14_12_3;
  const T K_thetadot14_12_3 = b13_4 + E13_11 * b13_7 - minus_E13_13 * b13_3;
  A[189] = K_thetadot14_12_1;
  A[219] = K_thetadot14_12_1;
  A[188] = b12_4;
  A[203] = b12_4;

  // ---- body 11 (body_11) and what it carries
  // h11 = h_own_11 + hc12: first moment of mass carried, about the body origin, body axes [kg m]
  const T h11_1 = T(6.97) + hc13_1;
  const T h11_2 = T(7.62) + hc12_2;
  // J11 = -q12~ hc12~ + E12^T J12 E12 + J_own_11 - hc12~ q12~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b11_1 = T(0.2) * hc12_3 + T(0.6) * hc12_2;
  const T b11_2 = b11_1 + J12_11;
  const T J11_11 = b11_2 + b11_1;
  const T b11_3 = E12_22 * J12_12 - E12_23 * J12_13;
  const T J11_12 = b11_3 - b12_6 - T(4.0874999999999995);
  const T b11_4 = E12_23 * J12_12 + E12_22 * J12_13;
  const T J11_13 = b11_4 - T(1.3772) - T(0.2) * hc13_1;
  const T b11_5 = E12_23 * (J12_22 - J12_33) + T(2) * E12_22 * J12_23;
  const T b11_6 = E12_23 * b11_5;
  const T J11_22 = J12_22 - b11_6 - T(0.09349999999999996) + T(0.4) * hc12_3;
  const T J11_23 = E12_22 * b11_5 - (J12_23 + T(1.5114)) - T(0.2) * hc12_2 - T(0.6) * hc12_3;
  const T J11_33 = J12_33 + b11_6 + T(8.840499999999999) + T(1.2) * hc12_2;
  A[170] = J11_33;
  // hc11 = E11^T h11: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc11_1 = E11_11 * h11_1 - E11_12 * h11_2;
  const T hc11_2 = E11_11 * h11_2 + E11_12 * h11_1;
  // B_thetadot16_11 = E12^T B_thetadot16_12
  const T B_thetadot16_11_2 = E12_22 * B_thetadot16_13_2 + E12_23 * minus_B_thetadot16_12_3;
  const T B_thetadot16_11_3 = E12_23 * B_thetadot16_13_2 - E12_22 * minus_B_thetadot16_12_3;
  // K_thetadot16_11 = q12~ E12^T B_thetadot16_12 + E12^T K_thetadot16_12
  const T K_thetadot16_11_1 = K_thetadot16_12_1 + T(0.6) * B_thetadot16_11_3 - T(0.2) * B_thetadot16_11_2;
  const T K_thetadot16_11_2 = T(0.2) * B_thetadot16_12_1 + E12_22 * K_thetadot16_12_2 - E12_23 * K_thetadot16_12_3;
  const T K_thetadot16_11_3 = E12_23 * K_thetadot16_12_2 + E12_22 * K_thetadot16_12_3 - T(0.6) * B_thetadot16_12_1;
  A[175] = K_thetadot16_11_3;
  A[250] = K_thetadot16_11_3;
  // B_thetadot15_11 = E12^T B_thetadot15_12
  const T minus_B_thetadot15_11_2 = E12_22 * minus_B_thetadot15_13_2 + E12_23 * B_thetadot15_12_3;
  const T B_thetadot15_11_3 = E12_22 * B_thetadot15_12_3 - E12_23 * minus_B_thetadot15_13_2;
  // K_thetadot15_11 = q12~ E12^T B_thetadot15_12 + E12^T K_thetadot15_12
  const T K_thetadot15_11_1 = K_thetadot15_12_1 + T(0.2) * minus_B_thetadot15_11_2 + T(0.6) * B_thetadot15_11_3;
  const T K_thetadot15_11_2 = T(0.2) * B_thetadot15_12_1 + E12_22 * K_thetadot15_12_2 - E12_23 * K_thetadot15_12_3;
  const T K_thetadot15_11_3 = E12_23 * K_thetadot15_12_2 + E12_22 * K_thetadot15_12_3 - T(0.6) * B_thetadot15_12_1;
  A[174] = K_thetadot15_11_3;
  A[234] = K_thetadot15_11_3;
  // B_thetadot14_11 = E12^T B_thetadot14_12
  const T B_thetadot14_11_2 = E12_22 * hc14_1 - E12_23 * B_thetadot14_12_3;
  const T B_thetadot14_11_3 = E12_23 * hc14_1 + E12_22 * B_thetadot14_12_3;
  // K_thetadot14_11 = q12~ E12^T B_thetadot14_12 + E12^T K_thetadot14_12
  const T K_thetadot14_11_1 = K_thetadot14_12_1 + T(0.6) * B_thetadot14_11_3 - T(0.2) * B_thetadot14_11_2;
  const T K_thetadot14_11_2 = E12_22 * K_thetadot14_12_2 - E12_23 * K_thetadot14_12_3 - T(0.2) *
      minus_B_thetadot14_12_1;
  const T K_thetadot14_11_3 = T(0.6) * minus_B_thetadot14_12_1 + E12_23 * K_thetadot14_12_2 + E12_22 *
      K_thetadot14_12_3;
  A[173] = K_thetadot14_11_3;
  A[218] = K_thetadot14_11_3;
  // B_thetadot13_11 = E12^T B_thetadot13_12
  const T B_thetadot13_11_2 = E12_23 * hc13_1;
  const T minus_B_thetadot13_11_3 = E12_22 * hc13_1;
  // K_thetadot13_11 = q12~ E12^T B_thetadot13_12 + E12^T K_thetadot13_12
  const T K_thetadot13_11_1 = b12_4 - T(0.2) * B_thetadot13_11_2 - T(0.6) * minus_B_thetadot13_11_3;
  const T K_thetadot13_11_2 = b12_3 + E12_22 * b12_8 - E12_23 * b12_9;
  const T K_thetadot13_11_3 = E12_23 * b12_8 - b12_5 + E12_22 * b12_9;
  A[172] = K_thetadot13_11_3;
  A[202] = K_thetadot13_11_3;
  A[171] = b11_4;
  A[186] = b11_4;

  // ---- body 10 (body_10) and what it carries
  // h10 = h_own_10 + hc11: first moment of mass carried, about the body origin, body axes [kg m]
  const T h10_1 = T(4.43) + hc11_1;
  const T h10_3 = T(2.8150000000000004) + hc12_3;
  // J10 = -q11~ hc11~ + E11^T J11 E11 + J_own_10 - hc11~ q11~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b10_1 = E11_12 * (J11_11 - J11_22) + T(2) * E11_11 * J11_12;
  const T b10_2 = E11_12 * b10_1;
  const T J10_11 = J11_11 - b10_2 + T(3.8972499999999997) + T(2.1) * hc11_2;
  const T J10_12 = E11_11 * b10_1 - (J11_12 + T(4.5715)) - T(1.05) * hc11_1 - T(0.3) * hc11_2;
  const T b10_3 = E11_11 * J11_13 - E11_12 * J11_23;
  const T J10_13 = b10_3 - T(0.8185) - T(0.3) * hc12_3;
  const T b10_4 = T(0.6) * hc11_1;
  const T J10_22 = J11_22 + b10_2 + b10_4 + T(6.675249999999999);
  const T b10_5 = E11_12 * J11_13 + E11_11 * J11_23;
  const T J10_23 = b10_5 - T(2.9287500000000004) - T(1.05) * hc12_3;
  const T b10_6 = T(0.3) * hc11_1 + T(1.05) * hc11_2;
  const T b10_7 = b10_6 + J11_33;
  const T J10_33 = b10_7 + b10_6;
  A[153] = J10_22;
  // hc10 = E10^T h10: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc10_1 = minus_E10_13 * h10_3 + E10_11 * h10_1;
  const T hc10_3 = E10_11 * h10_3 - minus_E10_13 * h10_1;
  // B_thetadot16_10 = E11^T B_thetadot16_11
  const T B_thetadot16_10_1 = E11_11 * B_thetadot16_12_1 - E11_12 * B_thetadot16_11_2;
  const T B_thetadot16_10_2 = E11_12 * B_thetadot16_12_1 + E11_11 * B_thetadot16_11_2;
  // K_thetadot16_10 = q11~ E11^T B_thetadot16_11 + E11^T K_thetadot16_11
  const T K_thetadot16_10_1 = T(1.05) * B_thetadot16_11_3 + E11_11 * K_thetadot16_11_1 - E11_12 * K_thetadot16_11_2;
  const T K_thetadot16_10_2 = E11_12 * K_thetadot16_11_1 + E11_11 * K_thetadot16_11_2 - T(0.3) * B_thetadot16_11_3;
  const T K_thetadot16_10_3 = K_thetadot16_11_3 + T(0.3) * B_thetadot16_10_2 - T(1.05) * B_thetadot16_10_1;
  A[159] = K_thetadot16_10_2;
  A[249] = K_thetadot16_10_2;
  // B_thetadot15_10 = E11^T B_thetadot15_11
  const T B_thetadot15_10_1 = E11_11 * B_thetadot15_12_1 + E11_12 * minus_B_thetadot15_11_2;
  const T B_thetadot15_10_2 = E11_12 * B_thetadot15_12_1 - E11_11 * minus_B_thetadot15_11_2;
  // K_thetadot15_10 = q11~ E11^T B_thetadot15_11 + E11^T K_thetadot15_11
  const T K_thetadot15_10_1 = T(1.05) * B_thetadot15_11_3 + E11_11 * K_thetadot15_11_1 - E11_12 * K_thetadot15_11_2;
  const T K_thetadot15_10_2 = E11_12 * K_thetadot15_11_1 + E11_11 * K_thetadot15_11_2 - T(0.3) * B_thetadot15_11_3;
  const T K_thetadot15_10_3 = K_thetadot15_11_3 + T(0.3) * B_thetadot15_10_2 - T(1.05) * B_thetadot15_10_1;
  A[158] = K_thetadot15_10_2;
  A[233] = K_thetadot15_10_2;
  // B_thetadot14_10 = E11^T B_thetadot14_11
  const T minus_B_thetadot14_10_1 = E11_11 * minus_B_thetadot14_12_1 + E11_12 * B_thetadot14_11_2;
  const T B_thetadot14_10_2 = E11_11 * B_thetadot14_11_2 - E11_12 * minus_B_thetadot14_12_1;
  // K_thetadot14_10 = q11~ E11^T B_thetadot14_11 + E11^T K_thetadot14_11
  const T K_thetadot14_10_1 = T(1.05) * B_thetadot14_11_3 + E11_11 * K_thetadot14_11_1 - E11_12 * K_thetadot14_11_2;
  const T K_thetadot14_10_2 = E11_12 * K_thetadot14_11_1 + E11_11 * K_thetadot14_11_2 - T(0.3) * B_thetadot14_11_3;
  const T K_thetadot14_10_3 = K_thetadot14_11_3 + T(0.3) * B_thetadot14_10_2 + T(1.05) * minus_B_thetadot14_10_1;
  A[157] = K_thetadot14_10_2;
  A[217] = K_thetadot14_10_2;
  // B_thetadot13_10 = E11^T B_thetadot13_11
  const T B_thetadot13_10_1 = E11_11 * hc13_3 - E11_12 * B_thetadot13_11_2;
  const T B_thetadot13_10_2 = E11_12 * hc13_3 + E11_11 * B_thetadot13_11_2;
  // K_thetadot13_10 = q11~ E11^T B_thetadot13_11 + E11^T K_thetadot13_11
  const T K_thetadot13_10_1 = E11_11 * K_thetadot13_11_1 - E11_12 * K_thetadot13_11_2 - T(1.05) *
      minus_B_thetadot13_11_3;
  const T K_thetadot13_10_2 = T(0.3) * minus_B_thetadot13_11_3 + E11_12 * K_thetadot13_11_1 + E11_11 *
      K_thetadot13_11_2;
  const T K_thetadot13_10_3 = K_thetadot13_11_3 + T(0.3) * B_thetadot13_10_2 - T(1.05) * B_thetadot13_10_1;
  A[156] = K_thetadot13_10_2;
  A[201] = K_thetadot13_10_2;
  // B_thetadot12_10 = E11^T B_thetadot12_11
  const T B_thetadot12_10_1 = E11_12 * hc12_3;
  const T minus_B_thetadot12_10_2 = E11_11 * hc12_3;
  // K_thetadot12_10 = q11~ E11^T B_thetadot12_11 + E11^T K_thetadot12_11
  const T K_thetadot12_10_1 = T(1.05) * hc12_2 + E11_11 * b11_2 - E11_12 * b11_3;
  const T K_thetadot12_10_2 = E11_12 * b11_2 + E11_11 * b11_3 - T(0.3) * hc12_2;
  const T K_thetadot12_10_3 = b11_4 - T(0.3) * minus_B_thetadot12_10_2 - T(1.05) * B_thetadot12_10_1;
  A[155] = K_thetadot12_10_2;
  A[185] = K_thetadot12_10_2;
  A[154] = b10_5;
  A[169] = b10_5;

  // ---- body 9 (body_9) and what it carries
  // h9 = h_own_9 + hc10: first moment of mass carried, about the body origin, body axes [kg m]
  const T h9_2 = T(16.585) + hc11_2;
  const T h9_3 = T(1.705) + hc10_3;
  // J9 = -q10~ hc10~ + E10^T J10 E10 + J_own_9 - hc10~ q10~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b9_1 = minus_E10_13 * (J10_33 - J10_11) + T(2) * E10_11 * J10_13;
  const T b9_2 = minus_E10_13 * b9_1;
  const T b9_3 = T(0.2) * hc10_3;
  const T J9_11 = J10_11 + b9_2 + b9_3 + T(18.406000000000002);
  const T b9_4 = E10_11 * J10_12 + minus_E10_13 * J10_23;
  const T J9_12 = b9_4 - T(9.8655) - T(0.6) * hc11_2;
  const T J9_13 = E10_11 * b9_1 - (J10_13 + T(0.9983000000000001)) - T(0.1) * hc10_1 - T(0.6) * hc10_3;
  const T b9_5 = T(0.1) * hc10_3 + T(0.6) * hc10_1;
  const T b9_6 = b9_5 + J10_22;
  const T J9_22 = b9_6 + b9_5;
  const T b9_7 = E10_11 * J10_23 - minus_E10_13 * J10_12;
  const T J9_23 = b9_7 - T(1.6471000000000002) - T(0.1) * hc11_2;
  const T J9_33 = J10_33 - b9_2 + T(17.808500000000002) + T(1.2) * hc10_1;
  A[136] = J9_11;
  // hc9 = E9^T h9: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc9_2 = E9_22 * h9_2 - E9_23 * h9_3;
  const T hc9_3 = E9_22 * h9_3 + E9_23 * h9_2;
  // B_thetadot16_9 = E10^T B_thetadot16_10
  const T B_thetadot16_9_1 = E10_11 * B_thetadot16_10_1 + minus_E10_13 * B_thetadot16_11_3;
  const T B_thetadot16_9_3 = E10_11 * B_thetadot16_11_3 - minus_E10_13 * B_thetadot16_10_1;
  // K_thetadot16_9 = q10~ E10^T B_thetadot16_10 + E10^T K_thetadot16_10
  const T K_thetadot16_9_1 = E10_11 * K_thetadot16_10_1 + minus_E10_13 * K_thetadot16_10_3 - T(0.1) *
      B_thetadot16_10_2;
  const T K_thetadot16_9_2 = K_thetadot16_10_2 + T(0.1) * B_thetadot16_9_1 - T(0.6) * B_thetadot16_9_3;
  const T K_thetadot16_9_3 = T(0.6) * B_thetadot16_10_2 + E10_11 * K_thetadot16_10_3 - minus_E10_13 *
      K_thetadot16_10_1;
  A[143] = K_thetadot16_9_1;
  A[248] = K_thetadot16_9_1;
  // B_thetadot15_9 = E10^T B_thetadot15_10
  const T B_thetadot15_9_1 = E10_11 * B_thetadot15_10_1 + minus_E10_13 * B_thetadot15_11_3;
  const T B_thetadot15_9_3 = E10_11 * B_thetadot15_11_3 - minus_E10_13 * B_thetadot15_10_1;
  // K_thetadot15_9 = q10~ E10^T B_thetadot15_10 + E10^T K_thetadot15_10
  const T K_thetadot15_9_1 = E10_11 * K_thetadot15_10_1 + minus_E10_13 * K_thetadot15_10_3 - T(0.1) *
      B_thetadot15_10_2;
  const T K_thetadot15_9_2 = K_thetadot15_10_2 + T(0.1) * B_thetadot15_9_1 - T(0.6) * B_thetadot15_9_3;
  const T K_thetadot15_9_3 = T(0.6) * B_thetadot15_10_2 + E10_11 * K_thetadot15_10_3 - minus_E10_13 *
      K_thetadot15_10_1;
  A[142] = K_thetadot15_9_1;
  A[232] = K_thetadot15_9_1;
  // B_thetadot14_9 = E10^T B_thetadot14_10
  const T B_thetadot14_9_1 = minus_E10_13 * B_thetadot14_11_3 - E10_11 * minus_B_thetadot14_10_1;
  const T B_thetadot14_9_3 = minus_E10_13 * minus_B_thetadot14_10_1 + E10_11 * B_thetadot14_11_3;
  // K_thetadot14_9 = q10~ E10^T B_thetadot14_10 + E10^T K_thetadot14_10
  const T K_thetadot14_9_1 = E10_11 * K_thetadot14_10_1 + minus_E10_13 * K_thetadot14_10_3 - T(0.1) *
      B_thetadot14_10_2;
  const T K_thetadot14_9_2 = K_thetadot14_10_2 + T(0.1) * B_thetadot14_9_1 - T(0.6) * B_thetadot14_9_3;
  const T K_thetadot14_9_3 = T(0.6) * B_thetadot14_10_2 + E10_11 * K_thetadot14_10_3 - minus_E10_13 *
      K_thetadot14_10_1;
  A[141] = K_thetadot14_9_1;
  A[216] = K_thetadot14_9_1;
  // B_thetadot13_9 = E10^T B_thetadot13_10
  const T B_thetadot13_9_1 = E10_11 * B_thetadot13_10_1 - minus_E10_13 * minus_B_thetadot13_11_3;
  const T minus_B_thetadot13_9_3 = minus_E10_13 * B_thetadot13_10_1 + E10_11 * minus_B_thetadot13_11_3;
  // K_thetadot13_9 = q10~ E10^T B_thetadot13_10 + E10^T K_thetadot13_10
  const T K_thetadot13_9_1 = E10_11 * K_thetadot13_10_1 + minus_E10_13 * K_thetadot13_10_3 - T(0.1) *
      B_thetadot13_10_2;
  const T K_thetadot13_9_2 = K_thetadot13_10_2 + T(0.1) * B_thetadot13_9_1 + T(0.6) * minus_B_thetadot13_9_3;
  const T K_thetadot13_9_3 = T(0.6) * B_thetadot13_10_2 + E10_11 * K_thetadot13_10_3 - minus_E10_13 *
      K_thetadot13_10_1;
  A[140] = K_thetadot13_9_1;
  A[200] = K_thetadot13_9_1;
  // B_thetadot12_9 = E10^T B_thetadot12_10
  const T B_thetadot12_9_1 = E10_11 * B_thetadot12_10_1 + minus_E10_13 * hc12_2;
  const T B_thetadot12_9_3 = E10_11 * hc12_2 - minus_E10_13 * B_thetadot12_10_1;
  // K_thetadot12_9 = q10~ E10^T B_thetadot12_10 + E10^T K_thetadot12_10
  const T K_thetadot12_9_1 = T(0.1) * minus_B_thetadot12_10_2 + E10_11 * K_thetadot12_10_1 + minus_E10_13 *
      K_thetadot12_10_3;
  const T K_thetadot12_9_2 = K_thetadot12_10_2 + T(0.1) * B_thetadot12_9_1 - T(0.6) * B_thetadot12_9_3;
  const T K_thetadot12_9_3 = E10_11 * K_thetadot12_10_3 - minus_E10_13 * K_thetadot12_10_1 - T(0.6) *
      minus_B_thetadot12_10_2;
  A[139] = K_thetadot12_9_1;
  A[184] = K_thetadot12_9_1;
  // B_thetadot11_9 = E10^T B_thetadot11_10
  const T minus_B_thetadot11_9_1 = E10_11 * hc11_2;
  const T B_thetadot11_9_3 = minus_E10_13 * hc11_2;
  // K_thetadot11_9 = q10~ E10^T B_thetadot11_10 + E10^T K_thetadot11_10
  const T K_thetadot11_9_1 = E10_11 * b10_3 + minus_E10_13 * b10_7 - T(0.1) * hc11_1;
  const T K_thetadot11_9_2 = b10_5 - T(0.1) * minus_B_thetadot11_9_1 - T(0.6) * B_thetadot11_9_3;
  const T K_thetadot11_9_3 = b10_4 + E10_11 * b10_7 - minus_E10_13 * b10_3;
  A[138] = K_thetadot11_9_1;
  A[168] = K_thetadot11_9_1;
  A[137] = b9_4;
  A[152] = b9_4;

  // ---- body 8 (body_8) and what it carries
  // h8 = h_own_8 + hc9: first moment of mass carried, about the body origin, body axes [kg m]
  const T h8_1 = T(10.6) + hc10_1;
  const T h8_2 = T(8.46) + hc9_2;
  // J8 = -q9~ hc9~ + E9^T J9 E9 + J_own_8 - hc9~ q9~: inertia carried, about the body origin, body axes [kg m^2]
  const T b8_1 = T(0.2) * hc9_3 + T(0.45) * hc9_2;
  const T b8_2 = b8_1 + J9_11;
  const T J8_11 = b8_2 + b8_1;
  const T b8_3 = E9_22 * J9_12 - E9_23 * J9_13;
  const T J8_12 = b8_3 - T(4.716) - T(0.45) * hc10_1;
  const T b8_4 = E9_23 * J9_12 + E9_22 * J9_13;
  const T J8_13 = b8_4 - T(2.1056) - T(0.2) * hc10_1;
  const T b8_5 = E9_23 * (J9_22 - J9_33) + T(2) * E9_22 * J9_23;
  const T b8_6 = E9_23 * b8_5;
  const T J8_22 = J9_22 - b8_6 + T(2.830749999999999) + T(0.4) * hc9_3;
  const T J8_23 = E9_22 * b8_5 - (J9_23 + T(1.6812)) - T(0.2) * hc9_2 - T(0.45) * hc9_3;
  const T J8_33 = J9_33 + b8_6 + T(10.37275) + T(0.9) * hc9_2;
  A[119] = J8_33;
  // hc8 = E8^T h8: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc8_1 = E8_11 * h8_1 - E8_12 * h8_2;
  const T hc8_2 = E8_11 * h8_2 + E8_12 * h8_1;
  // B_thetadot16_8 = E9^T B_thetadot16_9
  const T B_thetadot16_8_2 = E9_22 * B_thetadot16_10_2 - E9_23 * B_thetadot16_9_3;
  const T B_thetadot16_8_3 = E9_23 * B_thetadot16_10_2 + E9_22 * B_thetadot16_9_3;
  // K_thetadot16_8 = q9~ E9^T B_thetadot16_9 + E9^T K_thetadot16_9
  const T K_thetadot16_8_1 = K_thetadot16_9_1 + T(0.45) * B_thetadot16_8_3 - T(0.2) * B_thetadot16_8_2;
  const T K_thetadot16_8_2 = T(0.2) * B_thetadot16_9_1 + E9_22 * K_thetadot16_9_2 - E9_23 * K_thetadot16_9_3;
  const T K_thetadot16_8_3 = E9_23 * K_thetadot16_9_2 + E9_22 * K_thetadot16_9_3 - T(0.45) * B_thetadot16_9_1;
  A[127] = K_thetadot16_8_3;
  A[247] = K_thetadot16_8_3;
  // B_thetadot15_8 = E9^T B_thetadot15_9
  const T B_thetadot15_8_2 = E9_22 * B_thetadot15_10_2 - E9_23 * B_thetadot15_9_3;
  const T B_thetadot15_8_3 = E9_23 * B_thetadot15_10_2 + E9_22 * B_thetadot15_9_3;
  // K_thetadot15_8 = q9~ E9^T B_thetadot15_9 + E9^T K_thetadot15_9
  const T K_thetadot15_8_1 = K_thetadot15_9_1 + T(0.45) * B_thetadot15_8_3 - T(0.2) * B_thetadot15_8_2;
  const T K_thetadot15_8_2 = T(0.2) * B_thetadot15_9_1 + E9_22 * K_thetadot15_9_2 - E9_23 * K_thetadot15_9_3;
  const T K_thetadot15_8_3 = E9_23 * K_thetadot15_9_2 + E9_22 * K_thetadot15_9_3 - T(0.45) * B_thetadot15_9_1;
  A[126] = K_thetadot15_8_3;
  A[231] = K_thetadot15_8_3;
  // B_thetadot14_8 = E9^T B_thetadot14_9
  const T B_thetadot14_8_2 = E9_22 * B_thetadot14_10_2 - E9_23 * B_thetadot14_9_3;
  const T B_thetadot14_8_3 = E9_23 * B_thetadot14_10_2 + E9_22 * B_thetadot14_9_3;
  // K_thetadot14_8 = q9~ E9^T B_thetadot14_9 + E9^T K_thetadot14_9
  const T K_thetadot14_8_1 = K_thetadot14_9_1 + T(0.45) * B_thetadot14_8_3 - T(0.2) * B_thetadot14_8_2;
  const T K_thetadot14_8_2 = T(0.2) * B_thetadot14_9_1 + E9_22 * K_thetadot14_9_2 - E9_23 * K_thetadot14_9_3;
  const T K_thetadot14_8_3 = E9_23 * K_thetadot14_9_2 + E9_22 * K_thetadot14_9_3 - T(0.45) * B_thetadot14_9_1;
  A[125] = K_thetadot14_8_3;
  A[215] = K_thetadot14_8_3;
  // B_thetadot13_8 = E9^T B_thetadot13_9
  const T B_thetadot13_8_2 = E9_22 * B_thetadot13_10_2 + E9_23 * minus_B_thetadot13_9_3;
  const T B_thetadot13_8_3 = E9_23 * B_thetadot13_10_2 - E9_22 * minus_B_thetadot13_9_3;
  // K_thetadot13_8 = q9~ E9^T B_thetadot13_9 + E9^T K_thetadot13_9
  const T K_thetadot13_8_1 = K_thetadot13_9_1 + T(0.45) * B_thetadot13_8_3 - T(0.2) * B_thetadot13_8_2;
  const T K_thetadot13_8_2 = T(0.2) * B_thetadot13_9_1 + E9_22 * K_thetadot13_9_2 - E9_23 * K_thetadot13_9_3;
  const T K_thetadot13_8_3 = E9_23 * K_thetadot13_9_2 + E9_22 * K_thetadot13_9_3 - T(0.45) * B_thetadot13_9_1;
  A[124] = K_thetadot13_8_3;
  A[199] = K_thetadot13_8_3;
  // B_thetadot12_8 = E9^T B_thetadot12_9
  const T minus_B_thetadot12_8_2 = E9_22 * minus_B_thetadot12_10_2 + E9_23 * B_thetadot12_9_3;
  const T B_thetadot12_8_3 = E9_22 * B_thetadot12_9_3 - E9_23 * minus_B_thetadot12_10_2;
  // K_thetadot12_8 = q9~ E9^T B_thetadot12_9 + E9^T K_thetadot12_9
  const T K_thetadot12_8_1 = K_thetadot12_9_1 + T(0.2) * minus_B_thetadot12_8_2 + T(0.45) * B_thetadot12_8_3;
  const T K_thetadot12_8_2 = T(0.2) * B_thetadot12_9_1 + E9_22 * K_thetadot12_9_2 - E9_23 * K_thetadot12_9_3;
  const T K_thetadot12_8_3 = E9_23 * K_thetadot12_9_2 + E9_22 * K_thetadot12_9_3 - T(0.45) * B_thetadot12_9_1;
  A[123] = K_thetadot12_8_3;
  A[183] = K_thetadot12_8_3;
  // B_thetadot11_8 = E9^T B_thetadot11_9
  const T B_thetadot11_8_2 = E9_22 * hc11_1 - E9_23 * B_thetadot11_9_3;
  const T B_thetadot11_8_3 = E9_23 * hc11_1 + E9_22 * B_thetadot11_9_3;
  // K_thetadot11_8 = q9~ E9^T B_thetadot11_9 + E9^T K_thetadot11_9
  const T K_thetadot11_8_1 = K_thetadot11_9_1 + T(0.45) * B_thetadot11_8_3 - T(0.2) * B_thetadot11_8_2;
  const T K_thetadot11_8_2 = E9_22 * K_thetadot11_9_2 - E9_23 * K_thetadot11_9_3 - T(0.2) * minus_B_thetadot11_9_1;
  const T K_thetadot11_8_3 = T(0.45) * minus_B_thetadot11_9_1 + E9_23 * K_thetadot11_9_2 + E9_22 * K_thetadot11_9_3;
  A[122] = K_thetadot11_8_3;
  A[167] = K_thetadot11_8_3;
  // B_thetadot10_8 = E9^T B_thetadot10_9
  const T B_thetadot10_8_2 = E9_23 * hc10_1;
  const T minus_B_thetadot10_8_3 = E9_22 * hc10_1;
  // K_thetadot10_8 = q9~ E9^T B_thetadot10_9 + E9^T K_thetadot10_9
  const T K_thetadot10_8_1 = b9_4 - T(0.2) * B_thetadot10_8_2 - T(0.45) * minus_B_thetadot10_8_3;
  const T K_thetadot10_8_2 = b9_3 + E9_22 * b9_6 - E9_23 * b9_7;
  const T K_thetadot10_8_3 = E9_23 * b9_6 + E9_22 * b9_7 - T(0.45) * hc10_3;
  A[121] = K_thetadot10_8_3;
  A[151] = K_thetadot10_8_3;
  A[120] = b8_4;
  A[135] = b8_4;

  // ---- body 7 (body_7) and what it carries
  // h7 = h_own_7 + hc8: first moment of mass carried, about the body origin, body axes [kg m]
  const T h7_1 = T(6.109999999999999) + hc8_1;
  const T h7_3 = T(3.955) + hc9_3;
  // J7 = -q8~ hc8~ + E8^T J8 E8 + J_own_7 - hc8~ q8~: inertia carried, about the body origin, body axes [kg m^2]
  const T b7_1 = E8_12 * (J8_11 - J8_22) + T(2) * E8_11 * J8_12;
  const T b7_2 = E8_12 * b7_1;
  const T J7_11 = J8_11 - b7_2 + T(2.8967500000000004) + T(1.5) * hc8_2;
  const T J7_12 = E8_11 * b7_1 - (J8_12 + T(4.54)) - T(0.75) * hc8_1 - T(0.3) * hc8_2;
  const T b7_3 = E8_11 * J8_13 - E8_12 * J8_23;
  const T J7_13 = b7_3 - T(1.1644) - T(0.3) * hc9_3;
  const T b7_4 = T(0.6) * hc8_1;
  const T J7_22 = J8_22 + b7_2 + b7_4 + T(6.66475);
  const T b7_5 = E8_12 * J8_13 + E8_11 * J8_23;
  const T J7_23 = b7_5 - T(2.9560500000000003) - T(0.75) * hc9_3;
  const T b7_6 = T(0.3) * hc8_1 + T(0.75) * hc8_2;
  const T b7_7 = b7_6 + J8_33;
  const T J7_33 = b7_7 + b7_6;
  A[102] = J7_22;
  // hc7 = E7^T h7: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc7_1 = minus_E7_13 * h7_3 + E7_11 * h7_1;
  const T hc7_3 = E7_11 * h7_3 - minus_E7_13 * h7_1;
  // B_thetadot16_7 = E8^T B_thetadot16_8
  const T B_thetadot16_7_1 = E8_11 * B_thetadot16_9_1 - E8_12 * B_thetadot16_8_2;
  const T B_thetadot16_7_2 = E8_12 * B_thetadot16_9_1 + E8_11 * B_thetadot16_8_2;
  // K_thetadot16_7 = q8~ E8^T B_thetadot16_8 + E8^T K_thetadot16_8
  const T K_thetadot16_7_1 = T(0.75) * B_thetadot16_8_3 + E8_11 * K_thetadot16_8_1 - E8_12 * K_thetadot16_8_2;
  const T K_thetadot16_7_2 = E8_12 * K_thetadot16_8_1 + E8_11 * K_thetadot16_8_2 - T(0.3) * B_thetadot16_8_3;
  const T K_thetadot16_7_3 = K_thetadot16_8_3 + T(0.3) * B_thetadot16_7_2 - T(0.75) * B_thetadot16_7_1;
  A[111] = K_thetadot16_7_2;
  A[246] = K_thetadot16_7_2;
  // B_thetadot15_7 = E8^T B_thetadot15_8
  const T B_thetadot15_7_1 = E8_11 * B_thetadot15_9_1 - E8_12 * B_thetadot15_8_2;
  const T B_thetadot15_7_2 = E8_12 * B_thetadot15_9_1 + E8_11 * B_thetadot15_8_2;
  // K_thetadot15_7 = q8~ E8^T B_thetadot15_8 + E8^T K_thetadot15_8
  const T K_thetadot15_7_1 = T(0.75) * B_thetadot15_8_3 + E8_11 * K_thetadot15_8_1 - E8_12 * K_thetadot15_8_2;
  const T K_thetadot15_7_2 = E8_12 * K_thetadot15_8_1 + E8_11 * K_thetadot15_8_2 - T(0.3) * B_thetadot15_8_3;
  const T K_thetadot15_7_3 = K_thetadot15_8_3 + T(0.3) * B_thetadot15_7_2 - T(0.75) * B_thetadot15_7_1;
  A[110] = K_thetadot15_7_2;
  A[230] = K_thetadot15_7_2;
  // B_thetadot14_7 = E8^T B_thetadot14_8
  const T B_thetadot14_7_1 = E8_11 * B_thetadot14_9_1 - E8_12 * B_thetadot14_8_2;
  const T B_thetadot14_7_2 = E8_12 * B_thetadot14_9_1 + E8_11 * B_thetadot14_8_2;
  // K_thetadot14_7 = q8~ E8^T B_thetadot14_8 + E8^T K_thetadot14_8
  const T K_thetadot14_7_1 = T(0.75) * B_thetadot14_8_3 + E8_11 * K_thetadot14_8_1 - E8_12 * K_thetadot14_8_2;
  const T K_thetadot14_7_2 = E8_12 * K_thetadot14_8_1 + E8_11 * K_thetadot14_8_2 - T(0.3) * B_thetadot14_8_3;
  const T K_thetadot14_7_3 = K_thetadot14_8_3 + T(0.3) * B_thetadot14_7_2 - T(0.75) * B_thetadot14_7_1;
  A[109] = K_thetadot14_7_2;
  A[214] = K_thetadot14_7_2;
  // B_thetadot13_7 = E8^T B_thetadot13_8
  const T B_thetadot13_7_1 = E8_11 * B_thetadot13_9_1 - E8_12 * B_thetadot13_8_2;
  const T B_thetadot13_7_2 = E8_12 * B_thetadot13_9_1 + E8_11 * B_thetadot13_8_2;
  // K_thetadot13_7 = q8~ E8^T B_thetadot13_8 + E8^T K_thetadot13_8
  const T K_thetadot13_7_1 = T(0.75) * B_thetadot13_8_3 + E8_11 * K_thetadot13_8_1 - E8_12 * K_thetadot13_8_2;
  const T K_thetadot13_7_2 = E8_12 * K_thetadot13_8_1 + E8_11 * K_thetadot13_8_2 - T(0.3) * B_thetadot13_8_3;
  const T K_thetadot13_7_3 = K_thetadot13_8_3 + T(0.3) * B_thetadot13_7_2 - T(0.75) * B_thetadot13_7_1;
  A[108] = K_thetadot13_7_2;
  A[198] = K_thetadot13_7_2;
  // B_thetadot12_7 = E8^T B_thetadot12_8
  const T B_thetadot12_7_1 = E8_11 * B_thetadot12_9_1 + E8_12 * minus_B_thetadot12_8_2;
  const T B_thetadot12_7_2 = E8_12 * B_thetadot12_9_1 - E8_11 * minus_B_thetadot12_8_2;
  // K_thetadot12_7 = q8~ E8^T B_thetadot12_8 + E8^T K_thetadot12_8
  const T K_thetadot12_7_1 = T(0.75) * B_thetadot12_8_3 + E8_11 * K_thetadot12_8_1 - E8_12 * K_thetadot12_8_2;
  const T K_thetadot12_7_2 = E8_12 * K_thetadot12_8_1 + E8_11 * K_thetadot12_8_2 - T(0.3) * B_thetadot12_8_3;
  const T K_thetadot12_7_3 = K_thetadot12_8_3 + T(0.3) * B_thetadot12_7_2 - T(0.75) * B_thetadot12_7_1;
  A[107] = K_thetadot12_7_2;
  A[182] = K_thetadot12_7_2;
  // B_thetadot11_7 = E8^T B_thetadot11_8
  const T minus_B_thetadot11_7_1 = E8_11 * minus_B_thetadot11_9_1 + E8_12 * B_thetadot11_8_2;
  const T B_thetadot11_7_2 = E8_11 * B_thetadot11_8_2 - E8_12 * minus_B_thetadot11_9_1;
  // K_thetadot11_7 = q8~ E8^T B_thetadot11_8 + E8^T K_thetadot11_8
  const T K_thetadot11_7_1 = T(0.75) * B_thetadot11_8_3 + E8_11 * K_thetadot11_8_1 - E8_12 * K_thetadot11_8_2;
  const T K_thetadot11_7_2 = E8_12 * K_thetadot11_8_1 + E8_11 * K_thetadot11_8_2 - T(0.3) * B_thetadot11_8_3;
  const T K_thetadot11_7_3 = K_thetadot11_8_3 + T(0.3) * B_thetadot11_7_2 + T(0.75) * minus_B_thetadot11_7_1;
  A[106] = K_thetadot11_7_2;
  A[166] = K_thetadot11_7_2;
  // B_thetadot10_7 = E8^T B_thetadot10_8
  const T B_thetadot10_7_1 = E8_11 * hc10_3 - E8_12 * B_thetadot10_8_2;
  const T B_thetadot10_7_2 = E8_12 * hc10_3 + E8_11 * B_thetadot10_8_2;
  // K_thetadot10_7 = q8~ E8^T B_thetadot10_8 + E8^T K_thetadot10_8
  const T K_thetadot10_7_1 = E8_11 * K_thetadot10_8_1 - E8_12 * K_thetadot10_8_2 - T(0.75) * minus_B_thetadot10_8_3;
  const T K_thetadot10_7_2 = T(0.3) * minus_B_thetadot10_8_3 + E8_12 * K_thetadot10_8_1 + E8_11 * K_thetadot10_8_2;
  const T K_thetadot10_7_3 = K_thetadot10_8_3 + T(0.3) * B_thetadot10_7_2 - T(0.75) * B_thetadot10_7_1;
  A[105] = K_thetadot10_7_2;
  A[150] = K_thetadot10_7_2;
  // B_thetadot9_7 = E8^T B_thetadot9_8
  const T B_thetadot9_7_1 = E8_12 * hc9_3;
  const T minus_B_thetadot9_7_2 = E8_11 * hc9_3;
  // K_thetadot9_7 = q8~ E8^T B_thetadot9_8 + E8^T K_thetadot9_8
  const T K_thetadot9_7_1 = T(0.75) * hc9_2 + E8_11 * b8_2 - E8_12 * b8_3;
  const T K_thetadot9_7_2 = E8_12 * b8_2 + E8_11 * b8_3 - T(0.3) * hc9_2;
  const T K_thetadot9_7_3 = b8_4 - T(0.3) * minus_B_thetadot9_7_2 - T(0.75) * B_thetadot9_7_1;
  A[104] = K_thetadot9_7_2;
  A[134] = K_thetadot9_7_2;
  A[103] = b7_5;
  A[118] = b7_5;

  // ---- body 6 (body_6) and what it carries
  // h6 = h_own_6 + hc7: first moment of mass carried, about the body origin, body axes [kg m]
  const T h6_2 = T(16.105) + hc8_2;
  const T h6_3 = T(2.23) + hc7_3;
  // J6 = -q7~ hc7~ + E7^T J7 E7 + J_own_6 - hc7~ q7~: inertia carried, about the body origin, body axes [kg m^2]
  const T b6_1 = minus_E7_13 * (J7_33 - J7_11) + T(2) * E7_11 * J7_13;
  const T b6_2 = minus_E7_13 * b6_1;
  const T b6_3 = T(0.2) * hc7_3;
  const T J6_11 = J7_11 + b6_2 + b6_3 + T(14.02975);
  const T b6_4 = E7_11 * J7_12 + minus_E7_13 * J7_23;
  const T J6_12 = b6_4 - T(9.591) - T(0.6) * hc8_2;
  const T J6_13 = E7_11 * b6_1 - (J7_13 + T(1.3172)) - T(0.1) * hc7_1 - T(0.6) * hc7_3;
  const T b6_5 = T(0.1) * hc7_3 + T(0.6) * hc7_1;
  const T b6_6 = b6_5 + J7_22;
  const T J6_22 = b6_6 + b6_5;
  const T b6_7 = E7_11 * J7_23 - minus_E7_13 * J7_12;
  const T J6_23 = b6_7 - T(1.6009) - T(0.1) * hc8_2;
  const T J6_33 = J7_33 - b6_2 + T(13.36775) + T(1.2) * hc7_1;
  A[85] = J6_11;
  // hc6 = E6^T h6: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc6_2 = E6_22 * h6_2 - E6_23 * h6_3;
  const T hc6_3 = E6_22 * h6_3 + E6_23 * h6_2;
  // B_thetadot16_6 = E7^T B_thetadot16_7
  const T B_thetadot16_6_1 = E7_11 * B_thetadot16_7_1 + minus_E7_13 * B_thetadot16_8_3;
  const T B_thetadot16_6_3 = E7_11 * B_thetadot16_8_3 - minus_E7_13 * B_thetadot16_7_1;
  // K_thetadot16_6 = q7~ E7^T B_thetadot16_7 + E7^T K_thetadot16_7
  const T K_thetadot16_6_1 = E7_11 * K_thetadot16_7_1 + minus_E7_13 * K_thetadot16_7_3 - T(0.1) * B_thetadot16_7_2;
  const T K_thetadot16_6_2 = K_thetadot16_7_2 + T(0.1) * B_thetadot16_6_1 - T(0.6) * B_thetadot16_6_3;
  const T K_thetadot16_6_3 = T(0.6) * B_thetadot16_7_2 + E7_11 * K_thetadot16_7_3 - minus_E7_13 * K_thetadot16_7_1;
  A[95] = K_thetadot16_6_1;
  A[245] = K_thetadot16_6_1;
  // B_thetadot15_6 = E7^T B_thetadot15_7
  const T B_thetadot15_6_1 = E7_11 * B_thetadot15_7_1 + minus_E7_13 * B_thetadot15_8_3;
  const T B_thetadot15_6_3 = E7_11 * B_thetadot15_8_3 - minus_E7_13 * B_thetadot15_7_1;
  // K_thetadot15_6 = q7~ E7^T B_thetadot15_7 + E7^T K_thetadot15_7
  const T K_thetadot15_6_1 = E7_11 * K_thetadot15_7_1 + minus_E7_13 * K_thetadot15_7_3 - T(0.1) * B_thetadot15_7_2;
  const T K_thetadot15_6_2 = K_thetadot15_7_2 + T(0.1) * B_thetadot15_6_1 - T(0.6) * B_thetadot15_6_3;
  const T K_thetadot15_6_3 = T(0.6) * B_thetadot15_7_2 + E7_11 * K_thetadot15_7_3 - minus_E7_13 * K_thetadot15_7_1;
  A[94] = K_thetadot15_6_1;
  A[229] = K_thetadot15_6_1;
  // B_thetadot14_6 = E7^T B_thetadot14_7
  const T B_thetadot14_6_1 = E7_11 * B_thetadot14_7_1 + minus_E7_13 * B_thetadot14_8_3;
  const T B_thetadot14_6_3 = E7_11 * B_thetadot14_8_3 - minus_E7_13 * B_thetadot14_7_1;
  // K_thetadot14_6 = q7~ E7^T B_thetadot14_7 + E7^T K_thetadot14_7
  const T K_thetadot14_6_1 = E7_11 * K_thetadot14_7_1 + minus_E7_13 * K_thetadot14_7_3 - T(0.1) * B_thetadot14_7_2;
  const T K_thetadot14_6_2 = K_thetadot14_7_2 + T(0.1) * B_thetadot14_6_1 - T(0.6) * B_thetadot14_6_3;
  const T K_thetadot14_6_3 = T(0.6) * B_thetadot14_7_2 + E7_11 * K_thetadot14_7_3 - minus_E7_13 * K_thetadot14_7_1;
  A[93] = K_thetadot14_6_1;
  A[213] = K_thetadot14_6_1;
  // B_thetadot13_6 = E7^T B_thetadot13_7
  const T B_thetadot13_6_1 = E7_11 * B_thetadot13_7_1 + minus_E7_13 * B_thetadot13_8_3;
  const T B_thetadot13_6_3 = E7_11 * B_thetadot13_8_3 - minus_E7_13 * B_thetadot13_7_1;
  // K_thetadot13_6 = q7~ E7^T B_thetadot13_7 + E7^T K_thetadot13_7
  const T K_thetadot13_6_1 = E7_11 * K_thetadot13_7_1 + minus_E7_13 * K_thetadot13_7_3 - T(0.1) * B_thetadot13_7_2;
  const T K_thetadot13_6_2 = K_thetadot13_7_2 + T(0.1) * B_thetadot13_6_1 - T(0.6) * B_thetadot13_6_3;
  const T K_thetadot13_6_3 = T(0.6) * B_thetadot13_7_2 + E7_11 * K_thetadot13_7_3 - minus_E7_13 * K_thetadot13_7_1;
  A[92] = K_thetadot13_6_1;
  A[197] = K_thetadot13_6_1;
  // B_thetadot12_6 = E7^T B_thetadot12_7
  const T B_thetadot12_6_1 = E7_11 * B_thetadot12_7_1 + minus_E7_13 * B_thetadot12_8_3;
  const T B_thetadot12_6_3 = E7_11 * B_thetadot12_8_3 - minus_E7_13 * B_thetadot12_7_1;
  // K_thetadot12_6 = q7~ E7^T B_thetadot12_7 + E7^T K_thetadot12_7
  const T K_thetadot12_6_1 = E7_11 * K_thetadot12_7_1 + minus_E7_13 * K_thetadot12_7_3 - T(0.1) * B_thetadot12_7_2;
  const T K_thetadot12_6_2 = K_thetadot12_7_2 + T(0.1) * B_thetadot12_6_1 - T(0.6) * B_thetadot12_6_3;
  const T K_thetadot12_6_3 = T(0.6) * B_thetadot12_7_2 + E7_11 * K_thetadot12_7_3 - minus_E7_13 * K_thetadot12_7_1;
  A[91] = K_thetadot12_6_1;
  A[181] = K_thetadot12_6_1;
  // B_thetadot11_6 = E7^T B_thetadot11_7
  const T B_thetadot11_6_1 = minus_E7_13 * B_thetadot11_8_3 - E7_11 * minus_B_thetadot11_7_1;
  const T B_thetadot11_6_3 = minus_E7_13 * minus_B_thetadot11_7_1 + E7_11 * B_thetadot11_8_3;
  // K_thetadot11_6 = q7~ E7^T B_thetadot11_7 + E7^T K_thetadot11_7
  const T K_thetadot11_6_1 = E7_11 * K_thetadot11_7_1 + minus_E7_13 * K_thetadot11_7_3 - T(0.1) * B_thetadot11_7_2;
  const T K_thetadot11_6_2 = K_thetadot11_7_2 + T(0.1) * B_thetadot11_6_1 - T(0.6) * B_thetadot11_6_3;
  const T K_thetadot11_6_3 = T(0.6) * B_thetadot11_7_2 + E7_11 * K_thetadot11_7_3 - minus_E7_13 * K_thetadot11_7_1;
  A[90] = K_thetadot11_6_1;
  A[165] = K_thetadot11_6_1;
  // B_thetadot10_6 = E7^T B_thetadot10_7
  const T B_thetadot10_6_1 = E7_11 * B_thetadot10_7_1 - minus_E7_13 * minus_B_thetadot10_8_3;
  const T minus_B_thetadot10_6_3 = minus_E7_13 * B_thetadot10_7_1 + E7_11 * minus_B_thetadot10_8_3;
  // K_thetadot10_6 = q7~ E7^T B_thetadot10_7 + E7^T K_thetadot10_7
  const T K_thetadot10_6_1 = E7_11 * K_thetadot10_7_1 + minus_E7_13 * K_thetadot10_7_3 - T(0.1) * B_thetadot10_7_2;
  const T K_thetadot10_6_2 = K_thetadot10_7_2 + T(0.1) * B_thetadot10_6_1 + T(0.6) * minus_B_thetadot10_6_3;
  const T K_thetadot10_6_3 = T(0.6) * B_thetadot10_7_2 + E7_11 * K_thetadot10_7_3 - minus_E7_13 * K_thetadot10_7_1;
  A[89] = K_thetadot10_6_1;
  A[149] = K_thetadot10_6_1;
  // B_thetadot9_6 = E7^T B_thetadot9_7
  const T B_thetadot9_6_1 = E7_11 * B_thetadot9_7_1 + minus_E7_13 * hc9_2;
  const T B_thetadot9_6_3 = E7_11 * hc9_2 - minus_E7_13 * B_thetadot9_7_1;
  // K_thetadot9_6 = q7~ E7^T B_thetadot9_7 + E7^T K_thetadot9_7
  const T K_thetadot9_6_1 = T(0.1) * minus_B_thetadot9_7_2 + E7_11 * K_thetadot9_7_1 + minus_E7_13 * K_thetadot9_7_3;
  const T K_thetadot9_6_2 = K_thetadot9_7_2 + T(0.1) * B_thetadot9_6_1 - T(0.6) * B_thetadot9_6_3;
  const T K_thetadot9_6_3 = E7_11 * K_thetadot9_7_3 - minus_E7_13 * K_thetadot9_7_1 - T(0.6) * minus_B_thetadot9_7_2;
  A[88] = K_thetadot9_6_1;
  A[133] = K_thetadot9_6_1;
  // B_thetadot8_6 = E7^T B_thetadot8_7
  const T minus_B_thetadot8_6_1 = E7_11 * hc8_2;
  const T B_thetadot8_6_3 = minus_E7_13 * hc8_2;
  // K_thetadot8_6 = q7~ E7^T B_thetadot8_7 + E7^T K_thetadot8_7
  const T K_thetadot8_6_1 = E7_11 * b7_3 + minus_E7_13 * b7_7 - T(0.1) * hc8_1;
  const T K_thetadot8_6_2 = b7_5 - T(0.1) * minus_B_thetadot8_6_1 - T(0.6) * B_thetadot8_6_3;
  const T K_thetadot8_6_3 = b7_4 + E7_11 * b7_7 - minus_E7_13 * b7_3;
  A[87] = K_thetadot8_6_1;
  A[117] = K_thetadot8_6_1;
  A[86] = b6_4;
  A[101] = b6_4;

  // ---- body 5 (body_5) and what it carries
  // h5 = h_own_5 + hc6: first moment of mass carried, about the body origin, body axes [kg m]
  const T h5_1 = T(13.69) + hc7_1;
  const T h5_2 = T(7.2299999999999995) + hc6_2;
  // J5 = -q6~ hc6~ + E6^T J6 E6 + J_own_5 - hc6~ q6~: inertia carried, about the body origin, body axes [kg m^2]
  const T b5_1 = T(0.3) * hc6_2;
  const T b5_2 = b5_1 + T(0.2) * hc6_3;
  const T b5_3 = b5_2 + J6_11;
  const T J5_11 = b5_3 + b5_2;
  const T b5_4 = E6_22 * J6_12 - E6_23 * J6_13;
  const T J5_12 = b5_4 - T(4.084499999999999) - T(0.3) * hc7_1;
  const T b5_5 = E6_23 * J6_12 + E6_22 * J6_13;
  const T J5_13 = b5_5 - T(2.726) - T(0.2) * hc7_1;
  const T b5_6 = E6_23 * (J6_22 - J6_33) + T(2) * E6_22 * J6_23;
  const T b5_7 = E6_23 * b5_6;
  const T J5_22 = J6_22 - b5_7 + T(6.313) + T(0.4) * hc6_3;
  const T b5_8 = T(0.3) * hc6_3;
  const T J5_23 = E6_22 * b5_6 - (J6_23 + T(1.437) + b5_8) - T(0.2) * hc6_2;
  const T J5_33 = J6_33 + b5_7 + T(10.681) + T(0.6) * hc6_2;
  A[68] = J5_33;
  // hc5 = E5^T h5: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc5_1 = E5_11 * h5_1 - E5_12 * h5_2;
  const T hc5_2 = E5_11 * h5_2 + E5_12 * h5_1;
  // B_thetadot16_5 = E6^T B_thetadot16_6
  const T B_thetadot16_5_2 = E6_22 * B_thetadot16_7_2 - E6_23 * B_thetadot16_6_3;
  const T B_thetadot16_5_3 = E6_23 * B_thetadot16_7_2 + E6_22 * B_thetadot16_6_3;
  // K_thetadot16_5 = q6~ E6^T B_thetadot16_6 + E6^T K_thetadot16_6
  const T b5_9 = T(0.3) * B_thetadot16_5_3;
  const T K_thetadot16_5_1 = b5_9 + K_thetadot16_6_1 - T(0.2) * B_thetadot16_5_2;
  const T K_thetadot16_5_2 = T(0.2) * B_thetadot16_6_1 + E6_22 * K_thetadot16_6_2 - E6_23 * K_thetadot16_6_3;
  const T K_thetadot16_5_3 = E6_23 * K_thetadot16_6_2 + E6_22 * K_thetadot16_6_3 - T(0.3) * B_thetadot16_6_1;
  A[79] = K_thetadot16_5_3;
  A[244] = K_thetadot16_5_3;
  // B_thetadot15_5 = E6^T B_thetadot15_6
  const T B_thetadot15_5_2 = E6_22 * B_thetadot15_7_2 - E6_23 * B_thetadot15_6_3;
  const T B_thetadot15_5_3 = E6_23 * B_thetadot15_7_2 + E6_22 * B_thetadot15_6_3;
  // K_thetadot15_5 = q6~ E6^T B_thetadot15_6 + E6^T K_thetadot15_6
  const T b5_10 = T(0.3) * B_thetadot15_5_3;
  const T K_thetadot15_5_1 = b5_10 + K_thetadot15_6_1 - T(0.2) * B_thetadot15_5_2;
  const T K_thetadot15_5_2 = T(0.2) * B_thetadot15_6_1 + E6_22 * K_thetadot15_6_2 - E6_23 * K_thetadot15_6_3;
  const T K_thetadot15_5_3 = E6_23 * K_thetadot15_6_2 + E6_22 * K_thetadot15_6_3 - T(0.3) * B_thetadot15_6_1;
  A[78] = K_thetadot15_5_3;
  A[228] = K_thetadot15_5_3;
  // B_thetadot14_5 = E6^T B_thetadot14_6
  const T B_thetadot14_5_2 = E6_22 * B_thetadot14_7_2 - E6_23 * B_thetadot14_6_3;
  const T B_thetadot14_5_3 = E6_23 * B_thetadot14_7_2 + E6_22 * B_thetadot14_6_3;
  // K_thetadot14_5 = q6~ E6^T B_thetadot14_6 + E6^T K_thetadot14_6
  const T b5_11 = T(0.3) * B_thetadot14_5_3;
  const T K_thetadot14_5_1 = b5_11 + K_thetadot14_6_1 - T(0.2) * B_thetadot14_5_2;
  const T K_thetadot14_5_2 = T(0.2) * B_thetadot14_6_1 + E6_22 * K_thetadot14_6_2 - E6_23 * K_thetadot14_6_3;
  const T K_thetadot14_5_3 = E6_23 * K_thetadot14_6_2 + E6_22 * K_thetadot14_6_3 - T(0.3) * B_thetadot14_6_1;
  A[77] = K_thetadot14_5_3;
  A[212] = K_thetadot14_5_3;
  // B_thetadot13_5 = E6^T B_thetadot13_6
  const T B_thetadot13_5_2 = E6_22 * B_thetadot13_7_2 - E6_23 * B_thetadot13_6_3;
  const T B_thetadot13_5_3 = E6_23 * B_thetadot13_7_2 + E6_22 * B_thetadot13_6_3;
  // K_thetadot13_5 = q6~ E6^T B_thetadot13_6 + E6^T K_thetadot13_6
  const T b5_12 = T(0.3) * B_thetadot13_5_3;
  const T K_thetadot13_5_1 = b5_12 + K_thetadot13_6_1 - T(0.2) * B_thetadot13_5_2;
  const T K_thetadot13_5_2 = T(0.2) * B_thetadot13_6_1 + E6_22 * K_thetadot13_6_2 - E6_23 * K_thetadot13_6_3;
  const T K_thetadot13_5_3 = E6_23 * K_thetadot13_6_2 + E6_22 * K_thetadot13_6_3 - T(0.3) * B_thetadot13_6_1;
  A[76] = K_thetadot13_5_3;
  A[196] = K_thetadot13_5_3;
  // B_thetadot12_5 = E6^T B_thetadot12_6
  const T B_thetadot12_5_2 = E6_22 * B_thetadot12_7_2 - E6_23 * B_thetadot12_6_3;
  const T B_thetadot12_5_3 = E6_23 * B_thetadot12_7_2 + E6_22 * B_thetadot12_6_3;
  // K_thetadot12_5 = q6~ E6^T B_thetadot12_6 + E6^T K_thetadot12_6
  const T b5_13 = T(0.3) * B_thetadot12_5_3;
  const T K_thetadot12_5_1 = b5_13 + K_thetadot12_6_1 - T(0.2) * B_thetadot12_5_2;
  const T K_thetadot12_5_2 = T(0.2) * B_thetadot12_6_1 + E6_22 * K_thetadot12_6_2 - E6_23 * K_thetadot12_6_3;
  const T K_thetadot12_5_3 = E6_23 * K_thetadot12_6_2 + E6_22 * K_thetadot12_6_3 - T(0.3) * B_thetadot12_6_1;
  A[75] = K_thetadot12_5_3;
  A[180] = K_thetadot12_5_3;
  // B_thetadot11_5 = E6^T B_thetadot11_6
  const T B_thetadot11_5_2 = E6_22 * B_thetadot11_7_2 - E6_23 * B_thetadot11_6_3;
  const T B_thetadot11_5_3 = E6_23 * B_thetadot11_7_2 + E6_22 * B_thetadot11_6_3;
  // K_thetadot11_5 = q6~ E6^T B_thetadot11_6 + E6^T K_thetadot11_6
  const T b5_14 = T(0.3) * B_thetadot11_5_3;
  const T K_thetadot11_5_1 = b5_14 + K_thetadot11_6_1 - T(0.2) * B_thetadot11_5_2;
  const T K_thetadot11_5_2 = T(0.2) * B_thetadot11_6_1 + E6_22 * K_thetadot11_6_2 - E6_23 * K_thetadot11_6_3;
  const T K_thetadot11_5_3 = E6_23 * K_thetadot11_6_2 + E6_22 * K_thetadot11_6_3 - T(0.3) * B_thetadot11_6_1;
  A[74] = K_thetadot11_5_3;
  A[164] = K_thetadot11_5_3;
  // B_thetadot10_5 = E6^T B_thetadot10_6
  const T B_thetadot10_5_2 = E6_22 * B_thetadot10_7_2 + E6_23 * minus_B_thetadot10_6_3;
  const T B_thetadot10_5_3 = E6_23 * B_thetadot10_7_2 - E6_22 * minus_B_thetadot10_6_3;
  // K_thetadot10_5 = q6~ E6^T B_thetadot10_6 + E6^T K_thetadot10_6
  const T b5_15 = T(0.3) * B_thetadot10_5_3;
  const T K_thetadot10_5_1 = b5_15 + K_thetadot10_6_1 - T(0.2) * B_thetadot10_5_2;
  const T K_thetadot10_5_2 = T(0.2) * B_thetadot10_6_1 + E6_22 * K_thetadot10_6_2 - E6_23 * K_thetadot10_6_3;
  const T K_thetadot10_5_3 = E6_23 * K_thetadot10_6_2 + E6_22 * K_thetadot10_6_3 - T(0.3) * B_thetadot10_6_1;
  A[73] = K_thetadot10_5_3;
  A[148] = K_thetadot10_5_3;
  // B_thetadot9_5 = E6^T B_thetadot9_6
  const T minus_B_thetadot9_5_2 = E6_22 * minus_B_thetadot9_7_2 + E6_23 * B_thetadot9_6_3;
  const T B_thetadot9_5_3 = E6_22 * B_thetadot9_6_3 - E6_23 * minus_B_thetadot9_7_2;
  // K_thetadot9_5 = q6~ E6^T B_thetadot9_6 + E6^T K_thetadot9_6
  const T b5_16 = T(0.3) * B_thetadot9_5_3;
  const T K_thetadot9_5_1 = b5_16 + K_thetadot9_6_1 + T(0.2) * minus_B_thetadot9_5_2;
  const T K_thetadot9_5_2 = T(0.2) * B_thetadot9_6_1 + E6_22 * K_thetadot9_6_2 - E6_23 * K_thetadot9_6_3;
  const T K_thetadot9_5_3 = E6_23 * K_thetadot9_6_2 + E6_22 * K_thetadot9_6_3 - T(0.3) * B_thetadot9_6_1;
  A[72] = K_thetadot9_5_3;
  A[132] = K_thetadot9_5_3;
  // B_thetadot8_5 = E6^T B_thetadot8_6
  const T B_thetadot8_5_2 = E6_22 * hc8_1 - E6_23 * B_thetadot8_6_3;
  const T B_thetadot8_5_3 = E6_23 * hc8_1 + E6_22 * B_thetadot8_6_3;
  // K_thetadot8_5 = q6~ E6^T B_thetadot8_6 + E6^T K_thetadot8_6
  const T b5_17 = T(0.3) * B_thetadot8_5_3;
  const T K_thetadot8_5_1 = b5_17 + K_thetadot8_6_1 - T(0.2) * B_thetadot8_5_2;
  const T K_thetadot8_5_2 = E6_22 * K_thetadot8_6_2 - E6_23 * K_thetadot8_6_3 - T(0.2) * minus_B_thetadot8_6_1;
  const T K_thetadot8_5_3 = T(0.3) * minus_B_thetadot8_6_1 + E6_23 * K_thetadot8_6_2 + E6_22 * K_thetadot8_6_3;
  A[71] = K_thetadot8_5_3;
  A[116] = K_thetadot8_5_3;
  // B_thetadot7_5 = E6^T B_thetadot7_6
  const T B_thetadot7_5_2 = E6_23 * hc7_1;
  const T minus_B_thetadot7_5_3 = E6_22 * hc7_1;
  // K_thetadot7_5 = q6~ E6^T B_thetadot7_6 + E6^T K_thetadot7_6
  const T b5_18 = T(0.3) * minus_B_thetadot7_5_3;
  const T K_thetadot7_5_1 = b6_4 - b5_18 - T(0.2) * B_thetadot7_5_2;
  const T K_thetadot7_5_2 = b6_3 + E6_22 * b6_6 - E6_23 * b6_7;
  const T K_thetadot7_5_3 = E6_23 * b6_6 + E6_22 * b6_7 - T(0.3) * hc7_3;
  A[70] = K_thetadot7_5_3;
  A[100] = K_thetadot7_5_3;
  A[69] = b5_5;
  A[84] = b5_5;

  // ---- body 4 (body_4) and what it carries
  // h4 = h_own_4 + hc5: first moment of mass carried, about the body origin, body axes [kg m]
  const T h4_1 = T(7.52) + hc5_1;
  const T h4_3 = T(4.915) + hc6_3;
  // J4 = -q5~ hc5~ + E5^T J5 E5 + J_own_4 - hc5~ q5~: inertia carried, about the body origin, body axes [kg m^2]
  const T b4_1 = E5_12 * (J5_11 - J5_22) + T(2) * E5_11 * J5_12;
  const T b4_2 = E5_12 * b4_1;
  const T J4_11 = J5_11 - b4_2 + T(1.0502500000000001) + T(0.9) * hc5_2;
  const T J4_12 = E5_11 * b4_1 - (J5_12 + T(3.37)) - T(0.45) * hc5_1 - T(0.3) * hc5_2;
  const T b4_3 = E5_11 * J5_13 - E5_12 * J5_23;
  const T J4_13 = b4_3 - T(1.4563) - b5_8;
  const T b4_4 = T(0.6) * hc5_1;
  const T J4_22 = J5_22 + b4_2 + b4_4 + T(5.64625);
  const T b4_5 = E5_12 * J5_13 + E5_11 * J5_23;
  const T J4_23 = b4_5 - T(2.2138500000000003) - T(0.45) * hc6_3;
  const T b4_6 = T(0.3) * hc5_1 + T(0.45) * hc5_2;
  const T b4_7 = b4_6 + J5_33;
  const T J4_33 = b4_7 + b4_6;
  A[51] = J4_22;
  // hc4 = E4^T h4: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4_1 = minus_E4_13 * h4_3 + E4_11 * h4_1;
  const T hc4_3 = E4_11 * h4_3 - minus_E4_13 * h4_1;
  // B_thetadot16_4 = E5^T B_thetadot16_5
  const T B_thetadot16_4_1 = E5_11 * B_thetadot16_6_1 - E5_12 * B_thetadot16_5_2;
  const T B_thetadot16_4_2 = E5_12 * B_thetadot16_6_1 + E5_11 * B_thetadot16_5_2;
  // K_thetadot16_4 = q5~ E5^T B_thetadot16_5 + E5^T K_thetadot16_5
  const T K_thetadot16_4_1 = T(0.45) * B_thetadot16_5_3 + E5_11 * K_thetadot16_5_1 - E5_12 * K_thetadot16_5_2;
  const T K_thetadot16_4_2 = E5_12 * K_thetadot16_5_1 - b5_9 + E5_11 * K_thetadot16_5_2;
  const T K_thetadot16_4_3 = K_thetadot16_5_3 + T(0.3) * B_thetadot16_4_2 - T(0.45) * B_thetadot16_4_1;
  A[63] = K_thetadot16_4_2;
  A[243] = K_thetadot16_4_2;
  // B_thetadot15_4 = E5^T B_thetadot15_5
  const T B_thetadot15_4_1 = E5_11 * B_thetadot15_6_1 - E5_12 * B_thetadot15_5_2;
  const T B_thetadot15_4_2 = E5_12 * B_thetadot15_6_1 + E5_11 * B_thetadot15_5_2;
  // K_thetadot15_4 = q5~ E5^T B_thetadot15_5 + E5^T K_thetadot15_5
  const T K_thetadot15_4_1 = T(0.45) * B_thetadot15_5_3 + E5_11 * K_thetadot15_5_1 - E5_12 * K_thetadot15_5_2;
  const T K_thetadot15_4_2 = E5_12 * K_thetadot15_5_1 - b5_10 + E5_11 * K_thetadot15_5_2;
  const T K_thetadot15_4_3 = K_thetadot15_5_3 + T(0.3) * B_thetadot15_4_2 - T(0.45) * B_thetadot15_4_1;
  A[62] = K_thetadot15_4_2;
  A[227] = K_thetadot15_4_2;
  // B_thetadot14_4 = E5^T B_thetadot14_5
  const T B_thetadot14_4_1 = E5_11 * B_thetadot14_6_1 - E5_12 * B_thetadot14_5_2;
  const T B_thetadot14_4_2 = E5_12 * B_thetadot14_6_1 + E5_11 * B_thetadot14_5_2;
  // K_thetadot14_4 = q5~ E5^T B_thetadot14_5 + E5^T K_thetadot14_5
  const T K_thetadot14_4_1 = T(0.45) * B_thetadot14_5_3 + E5_11 * K_thetadot14_5_1 - E5_12 * K_thetadot14_5_2;
  const T K_thetadot14_4_2 = E5_12 * K_thetadot14_5_1 - b5_11 + E5_11 * K_thetadot14_5_2;
  const T K_thetadot14_4_3 = K_thetadot14_5_3 + T(0.3) * B_thetadot14_4_2 - T(0.45) * B_thetadot14_4_1;
  A[61] = K_thetadot14_4_2;
  A[211] = K_thetadot14_4_2;
  // B_thetadot13_4 = E5^T B_thetadot13_5
  const T B_thetadot13_4_1 = E5_11 * B_thetadot13_6_1 - E5_12 * B_thetadot13_5_2;
  const T B_thetadot13_4_2 = E5_12 * B_thetadot13_6_1 + E5_11 * B_thetadot13_5_2;
  // K_thetadot13_4 = q5~ E5^T B_thetadot13_5 + E5^T K_thetadot13_5
  const T K_thetadot13_4_1 = T(0.45) * B_thetadot13_5_3 + E5_11 * K_thetadot13_5_1 - E5_12 * K_thetadot13_5_2;
  const T K_thetadot13_4_2 = E5_12 * K_thetadot13_5_1 - b5_12 + E5_11 * K_thetadot13_5_2;
  const T K_thetadot13_4_3 = K_thetadot13_5_3 + T(0.3) * B_thetadot13_4_2 - T(0.45) * B_thetadot13_4_1;
  A[60] = K_thetadot13_4_2;
  A[195] = K_thetadot13_4_2;
  // B_thetadot12_4 = E5^T B_thetadot12_5
  const T B_thetadot12_4_1 = E5_11 * B_thetadot12_6_1 - E5_12 * B_thetadot12_5_2;
  const T B_thetadot12_4_2 = E5_12 * B_thetadot12_6_1 + E5_11 * B_thetadot12_5_2;
  // K_thetadot12_4 = q5~ E5^T B_thetadot12_5 + E5^T K_thetadot12_5
  const T K_thetadot12_4_1 = T(0.45) * B_thetadot12_5_3 + E5_11 * K_thetadot12_5_1 - E5_12 * K_thetadot12_5_2;
  const T K_thetadot12_4_2 = E5_12 * K_thetadot12_5_1 - b5_13 + E5_11 * K_thetadot12_5_2;
  const T K_thetadot12_4_3 = K_thetadot12_5_3 + T(0.3) * B_thetadot12_4_2 - T(0.45) * B_thetadot12_4_1;
  A[59] = K_thetadot12_4_2;
  A[179] = K_thetadot12_4_2;
  // B_thetadot11_4 = E5^T B_thetadot11_5
  const T B_thetadot11_4_1 = E5_11 * B_thetadot11_6_1 - E5_12 * B_thetadot11_5_2;
  const T B_thetadot11_4_2 = E5_12 * B_thetadot11_6_1 + E5_11 * B_thetadot11_5_2;
  // K_thetadot11_4 = q5~ E5^T B_thetadot11_5 + E5^T K_thetadot11_5
  const T K_thetadot11_4_1 = T(0.45) * B_thetadot11_5_3 + E5_11 * K_thetadot11_5_1 - E5_12 * K_thetadot11_5_2;
  const T K_thetadot11_4_2 = E5_12 * K_thetadot11_5_1 - b5_14 + E5_11 * K_thetadot11_5_2;
  const T K_thetadot11_4_3 = K_thetadot11_5_3 + T(0.3) * B_thetadot11_4_2 - T(0.45) * B_thetadot11_4_1;
  A[58] = K_thetadot11_4_2;
  A[163] = K_thetadot11_4_2;
  // B_thetadot10_4 = E5^T B_thetadot10_5
  const T B_thetadot10_4_1 = E5_11 * B_thetadot10_6_1 - E5_12 * B_thetadot10_5_2;
  const T B_thetadot10_4_2 = E5_12 * B_thetadot10_6_1 + E5_11 * B_thetadot10_5_2;
  // K_thetadot10_4 = q5~ E5^T B_thetadot10_5 + E5^T K_thetadot10_5
  const T K_thetadot10_4_1 = T(0.45) * B_thetadot10_5_3 + E5_11 * K_thetadot10_5_1 - E5_12 * K_thetadot10_5_2;
  const T K_thetadot10_4_2 = E5_12 * K_thetadot10_5_1 - b5_15 + E5_11 * K_thetadot10_5_2;
  const T K_thetadot10_4_3 = K_thetadot10_5_3 + T(0.3) * B_thetadot10_4_2 - T(0.45) * B_thetadot10_4_1;
  A[57] = K_thetadot10_4_2;
  A[147] = K_thetadot10_4_2;
  // B_thetadot9_4 = E5^T B_thetadot9_5
  const T B_thetadot9_4_1 = E5_11 * B_thetadot9_6_1 + E5_12 * minus_B_thetadot9_5_2;
  const T B_thetadot9_4_2 = E5_12 * B_thetadot9_6_1 - E5_11 * minus_B_thetadot9_5_2;
  // K_thetadot9_4 = q5~ E5^T B_thetadot9_5 + E5^T K_thetadot9_5
  const T K_thetadot9_4_1 = T(0.45) * B_thetadot9_5_3 + E5_11 * K_thetadot9_5_1 - E5_12 * K_thetadot9_5_2;
  const T K_thetadot9_4_2 = E5_12 * K_thetadot9_5_1 - b5_16 + E5_11 * K_thetadot9_5_2;
  const T K_thetadot9_4_3 = K_thetadot9_5_3 + T(0.3) * B_thetadot9_4_2 - T(0.45) * B_thetadot9_4_1;
  A[56] = K_thetadot9_4_2;
  A[131] = K_thetadot9_4_2;
  // B_thetadot8_4 = E5^T B_thetadot8_5
  const T minus_B_thetadot8_4_1 = E5_11 * minus_B_thetadot8_6_1 + E5_12 * B_thetadot8_5_2;
  const T B_thetadot8_4_2 = E5_11 * B_thetadot8_5_2 - E5_12 * minus_B_thetadot8_6_1;
  // K_thetadot8_4 = q5~ E5^T B_thetadot8_5 + E5^T K_thetadot8_5
  const T K_thetadot8_4_1 = T(0.45) * B_thetadot8_5_3 + E5_11 * K_thetadot8_5_1 - E5_12 * K_thetadot8_5_2;
  const T K_thetadot8_4_2 = E5_12 * K_thetadot8_5_1 - b5_17 + E5_11 * K_thetadot8_5_2;
  const T K_thetadot8_4_3 = K_thetadot8_5_3 + T(0.3) * B_thetadot8_4_2 + T(0.45) * minus_B_thetadot8_4_1;
  A[55] = K_thetadot8_4_2;
  A[115] = K_thetadot8_4_2;
  // B_thetadot7_4 = E5^T B_thetadot7_5
  const T B_thetadot7_4_1 = E5_11 * hc7_3 - E5_12 * B_thetadot7_5_2;
  const T B_thetadot7_4_2 = E5_12 * hc7_3 + E5_11 * B_thetadot7_5_2;
  // K_thetadot7_4 = q5~ E5^T B_thetadot7_5 + E5^T K_thetadot7_5
  const T K_thetadot7_4_1 = E5_11 * K_thetadot7_5_1 - E5_12 * K_thetadot7_5_2 - T(0.45) * minus_B_thetadot7_5_3;
  const T K_thetadot7_4_2 = b5_18 + E5_12 * K_thetadot7_5_1 + E5_11 * K_thetadot7_5_2;
  const T K_thetadot7_4_3 = K_thetadot7_5_3 + T(0.3) * B_thetadot7_4_2 - T(0.45) * B_thetadot7_4_1;
  A[54] = K_thetadot7_4_2;
  A[99] = K_thetadot7_4_2;
  // B_thetadot6_4 = E5^T B_thetadot6_5
  const T B_thetadot6_4_1 = E5_12 * hc6_3;
  const T minus_B_thetadot6_4_2 = E5_11 * hc6_3;
  // K_thetadot6_4 = q5~ E5^T B_thetadot6_5 + E5^T K_thetadot6_5
  const T K_thetadot6_4_1 = T(0.45) * hc6_2 + E5_11 * b5_3 - E5_12 * b5_4;
  const T K_thetadot6_4_2 = E5_12 * b5_3 - b5_1 + E5_11 * b5_4;
  const T K_thetadot6_4_3 = b5_5 - T(0.3) * minus_B_thetadot6_4_2 - T(0.45) * B_thetadot6_4_1;
  A[53] = K_thetadot6_4_2;
  A[83] = K_thetadot6_4_2;
  A[52] = b4_5;
  A[67] = b4_5;

  // ---- body 3 (body_3) and what it carries
  // h3 = h_own_3 + hc4: first moment of mass carried, about the body origin, body axes [kg m]
  const T h3_2 = T(11.89) + hc5_2;
  const T h3_3 = T(2.665) + hc4_3;
  // J3 = -q4~ hc4~ + E4^T J4 E4 + J_own_3 - hc4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b3_1 = minus_E4_13 * (J4_33 - J4_11) + T(2) * E4_11 * J4_13;
  const T b3_2 = minus_E4_13 * b3_1;
  const T b3_3 = T(0.2) * hc4_3;
  const T J3_11 = J4_11 + b3_2 + b3_3 + T(7.99075);
  const T b3_4 = E4_11 * J4_12 + minus_E4_13 * J4_23;
  const T J3_12 = b3_4 - T(7.0755) - T(0.6) * hc5_2;
  const T J3_13 = E4_11 * b3_1 - (J4_13 + T(1.5821)) - T(0.1) * hc4_1 - T(0.6) * hc4_3;
  const T b3_5 = T(0.1) * hc4_3 + T(0.6) * hc4_1;
  const T b3_6 = b3_5 + J4_22;
  const T J3_22 = b3_6 + b3_5;
  const T b3_7 = E4_11 * J4_23 - minus_E4_13 * J4_12;
  const T J3_23 = b3_7 - T(1.1812) - T(0.1) * hc5_2;
  const T J3_33 = J4_33 - b3_2 + T(7.28225) + T(1.2) * hc4_1;
  A[34] = J3_11;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc3_2 = E3_22 * h3_2 - E3_23 * h3_3;
  const T hc3_3 = E3_22 * h3_3 + E3_23 * h3_2;
  // B_thetadot16_3 = E4^T B_thetadot16_4
  const T B_thetadot16_3_1 = E4_11 * B_thetadot16_4_1 + minus_E4_13 * B_thetadot16_5_3;
  const T B_thetadot16_3_3 = E4_11 * B_thetadot16_5_3 - minus_E4_13 * B_thetadot16_4_1;
  // K_thetadot16_3 = q4~ E4^T B_thetadot16_4 + E4^T K_thetadot16_4
  const T K_thetadot16_3_1 = E4_11 * K_thetadot16_4_1 + minus_E4_13 * K_thetadot16_4_3 - T(0.1) * B_thetadot16_4_2;
  const T K_thetadot16_3_2 = K_thetadot16_4_2 + T(0.1) * B_thetadot16_3_1 - T(0.6) * B_thetadot16_3_3;
  const T K_thetadot16_3_3 = T(0.6) * B_thetadot16_4_2 + E4_11 * K_thetadot16_4_3 - minus_E4_13 * K_thetadot16_4_1;
  A[47] = K_thetadot16_3_1;
  A[242] = K_thetadot16_3_1;
  // B_thetadot15_3 = E4^T B_thetadot15_4
  const T B_thetadot15_3_1 = E4_11 * B_thetadot15_4_1 + minus_E4_13 * B_thetadot15_5_3;
  const T B_thetadot15_3_3 = E4_11 * B_thetadot15_5_3 - minus_E4_13 * B_thetadot15_4_1;
  // K_thetadot15_3 = q4~ E4^T B_thetadot15_4 + E4^T K_thetadot15_4
  const T K_thetadot15_3_1 = E4_11 * K_thetadot15_4_1 + minus_E4_13 * K_thetadot15_4_3 - T(0.1) * B_thetadot15_4_2;
  const T K_thetadot15_3_2 = K_thetadot15_4_2 + T(0.1) * B_thetadot15_3_1 - T(0.6) * B_thetadot15_3_3;
  const T K_thetadot15_3_3 = T(0.6) * B_thetadot15_4_2 + E4_11 * K_thetadot15_4_3 - minus_E4_13 * K_thetadot15_4_1;
  A[46] = K_thetadot15_3_1;
  A[226] = K_thetadot15_3_1;
  // B_thetadot14_3 = E4^T B_thetadot14_4
  const T B_thetadot14_3_1 = E4_11 * B_thetadot14_4_1 + minus_E4_13 * B_thetadot14_5_3;
  const T B_thetadot14_3_3 = E4_11 * B_thetadot14_5_3 - minus_E4_13 * B_thetadot14_4_1;
  // K_thetadot14_3 = q4~ E4^T B_thetadot14_4 + E4^T K_thetadot14_4
  const T K_thetadot14_3_1 = E4_11 * K_thetadot14_4_1 + minus_E4_13 * K_thetadot14_4_3 - T(0.1) * B_thetadot14_4_2;
  const T K_thetadot14_3_2 = K_thetadot14_4_2 + T(0.1) * B_thetadot14_3_1 - T(0.6) * B_thetadot14_3_3;
  const T K_thetadot14_3_3 = T(0.6) * B_thetadot14_4_2 + E4_11 * K_thetadot14_4_3 - minus_E4_13 * K_thetadot14_4_1;
  A[45] = K_thetadot14_3_1;
  A[210] = K_thetadot14_3_1;
  // B_thetadot13_3 = E4^T B_thetadot13_4
  const T B_thetadot13_3_1 = E4_11 * B_thetadot13_4_1 + minus_E4_13 * B_thetadot13_5_3;
  const T B_thetadot13_3_3 = E4_11 * B_thetadot13_5_3 - minus_E4_13 * B_thetadot13_4_1;
  // K_thetadot13_3 = q4~ E4^T B_thetadot13_4 + E4^T K_thetadot13_4
  const T K_thetadot13_3_1 = E4_11 * K_thetadot13_4_1 + minus_E4_13 * K_thetadot13_4_3 - T(0.1) * B_thetadot13_4_2;
  const T K_thetadot13_3_2 = K_thetadot13_4_2 + T(0.1) * B_thetadot13_3_1 - T(0.6) * B_thetadot13_3_3;
  const T K_thetadot13_3_3 = T(0.6) * B_thetadot13_4_2 + E4_11 * K_thetadot13_4_3 - minus_E4_13 * K_thetadot13_4_1;
  A[44] = K_thetadot13_3_1;
  A[194] = K_thetadot13_3_1;
  // B_thetadot12_3 = E4^T B_thetadot12_4
  const T B_thetadot12_3_1 = E4_11 * B_thetadot12_4_1 + minus_E4_13 * B_thetadot12_5_3;
  const T B_thetadot12_3_3 = E4_11 * B_thetadot12_5_3 - minus_E4_13 * B_thetadot12_4_1;
  // K_thetadot12_3 = q4~ E4^T B_thetadot12_4 + E4^T K_thetadot12_4
  const T K_thetadot12_3_1 = E4_11 * K_thetadot12_4_1 + minus_E4_13 * K_thetadot12_4_3 - T(0.1) * B_thetadot12_4_2;
  const T K_thetadot12_3_2 = K_thetadot12_4_2 + T(0.1) * B_thetadot12_3_1 - T(0.6) * B_thetadot12_3_3;
  const T K_thetadot12_3_3 = T(0.6) * B_thetadot12_4_2 + E4_11 * K_thetadot12_4_3 - minus_E4_13 * K_thetadot12_4_1;
  A[43] = K_thetadot12_3_1;
  A[178] = K_thetadot12_3_1;
  // B_thetadot11_3 = E4^T B_thetadot11_4
  const T B_thetadot11_3_1 = E4_11 * B_thetadot11_4_1 + minus_E4_13 * B_thetadot11_5_3;
  const T B_thetadot11_3_3 = E4_11 * B_thetadot11_5_3 - minus_E4_13 * B_thetadot11_4_1;
  // K_thetadot11_3 = q4~ E4^T B_thetadot11_4 + E4^T K_thetadot11_4
  const T K_thetadot11_3_1 = E4_11 * K_thetadot11_4_1 + minus_E4_13 * K_thetadot11_4_3 - T(0.1) * B_thetadot11_4_2;
  const T K_thetadot11_3_2 = K_thetadot11_4_2 + T(0.1) * B_thetadot11_3_1 - T(0.6) * B_thetadot11_3_3;
  const T K_thetadot11_3_3 = T(0.6) * B_thetadot11_4_2 + E4_11 * K_thetadot11_4_3 - minus_E4_13 * K_thetadot11_4_1;
  A[42] = K_thetadot11_3_1;
  A[162] = K_thetadot11_3_1;
  // B_thetadot10_3 = E4^T B_thetadot10_4
  const T B_thetadot10_3_1 = E4_11 * B_thetadot10_4_1 + minus_E4_13 * B_thetadot10_5_3;
  const T B_thetadot10_3_3 = E4_11 * B_thetadot10_5_3 - minus_E4_13 * B_thetadot10_4_1;
  // K_thetadot10_3 = q4~ E4^T B_thetadot10_4 + E4^T K_thetadot10_4
  const T K_thetadot10_3_1 = E4_11 * K_thetadot10_4_1 + minus_E4_13 * K_thetadot10_4_3 - T(0.1) * B_thetadot10_4_2;
  const T K_thetadot10_3_2 = K_thetadot10_4_2 + T(0.1) * B_thetadot10_3_1 - T(0.6) * B_thetadot10_3_3;
  const T K_thetadot10_3_3 = T(0.6) * B_thetadot10_4_2 + E4_11 * K_thetadot10_4_3 - minus_E4_13 * K_thetadot10_4_1;
  A[41] = K_thetadot10_3_1;
  A[146] = K_thetadot10_3_1;
  // B_thetadot9_3 = E4^T B_thetadot9_4
  const T B_thetadot9_3_1 = E4_11 * B_thetadot9_4_1 + minus_E4_13 * B_thetadot9_5_3;
  const T B_thetadot9_3_3 = E4_11 * B_thetadot9_5_3 - minus_E4_13 * B_thetadot9_4_1;
  // K_thetadot9_3 = q4~ E4^T B_thetadot9_4 + E4^T K_thetadot9_4
  const T K_thetadot9_3_1 = E4_11 * K_thetadot9_4_1 + minus_E4_13 * K_thetadot9_4_3 - T(0.1) * B_thetadot9_4_2;
  const T K_thetadot9_3_2 = K_thetadot9_4_2 + T(0.1) * B_thetadot9_3_1 - T(0.6) * B_thetadot9_3_3;
  const T K_thetadot9_3_3 = T(0.6) * B_thetadot9_4_2 + E4_11 * K_thetadot9_4_3 - minus_E4_13 * K_thetadot9_4_1;
  A[40] = K_thetadot9_3_1;
  A[130] = K_thetadot9_3_1;
  // B_thetadot8_3 = E4^T B_thetadot8_4
  const T B_thetadot8_3_1 = minus_E4_13 * B_thetadot8_5_3 - E4_11 * minus_B_thetadot8_4_1;
  const T B_thetadot8_3_3 = minus_E4_13 * minus_B_thetadot8_4_1 + E4_11 * B_thetadot8_5_3;
  // K_thetadot8_3 = q4~ E4^T B_thetadot8_4 + E4^T K_thetadot8_4
  const T K_thetadot8_3_1 = E4_11 * K_thetadot8_4_1 + minus_E4_13 * K_thetadot8_4_3 - T(0.1) * B_thetadot8_4_2;
  const T K_thetadot8_3_2 = K_thetadot8_4_2 + T(0.1) * B_thetadot8_3_1 - T(0.6) * B_thetadot8_3_3;
  const T K_thetadot8_3_3 = T(0.6) * B_thetadot8_4_2 + E4_11 * K_thetadot8_4_3 - minus_E4_13 * K_thetadot8_4_1;
  A[39] = K_thetadot8_3_1;
  A[114] = K_thetadot8_3_1;
  // B_thetadot7_3 = E4^T B_thetadot7_4
  const T B_thetadot7_3_1 = E4_11 * B_thetadot7_4_1 - minus_E4_13 * minus_B_thetadot7_5_3;
  const T minus_B_thetadot7_3_3 = minus_E4_13 * B_thetadot7_4_1 + E4_11 * minus_B_thetadot7_5_3;
  // K_thetadot7_3 = q4~ E4^T B_thetadot7_4 + E4^T K_thetadot7_4
  const T K_thetadot7_3_1 = E4_11 * K_thetadot7_4_1 + minus_E4_13 * K_thetadot7_4_3 - T(0.1) * B_thetadot7_4_2;
  const T K_thetadot7_3_2 = K_thetadot7_4_2 + T(0.1) * B_thetadot7_3_1 + T(0.6) * minus_B_thetadot7_3_3;
  const T K_thetadot7_3_3 = T(0.6) * B_thetadot7_4_2 + E4_11 * K_thetadot7_4_3 - minus_E4_13 * K_thetadot7_4_1;
  A[38] = K_thetadot7_3_1;
  A[98] = K_thetadot7_3_1;
  // B_thetadot6_3 = E4^T B_thetadot6_4
  const T B_thetadot6_3_1 = E4_11 * B_thetadot6_4_1 + minus_E4_13 * hc6_2;
  const T B_thetadot6_3_3 = E4_11 * hc6_2 - minus_E4_13 * B_thetadot6_4_1;
  // K_thetadot6_3 = q4~ E4^T B_thetadot6_4 + E4^T K_thetadot6_4
  const T K_thetadot6_3_1 = T(0.1) * minus_B_thetadot6_4_2 + E4_11 * K_thetadot6_4_1 + minus_E4_13 * K_thetadot6_4_3;
  const T K_thetadot6_3_2 = K_thetadot6_4_2 + T(0.1) * B_thetadot6_3_1 - T(0.6) * B_thetadot6_3_3;
  const T K_thetadot6_3_3 = E4_11 * K_thetadot6_4_3 - minus_E4_13 * K_thetadot6_4_1 - T(0.6) * minus_B_thetadot6_4_2;
  A[37] = K_thetadot6_3_1;
  A[82] = K_thetadot6_3_1;
  // B_thetadot5_3 = E4^T B_thetadot5_4
  const T minus_B_thetadot5_3_1 = E4_11 * hc5_2;
  const T B_thetadot5_3_3 = minus_E4_13 * hc5_2;
  // K_thetadot5_3 = q4~ E4^T B_thetadot5_4 + E4^T K_thetadot5_4
  const T K_thetadot5_3_1 = E4_11 * b4_3 + minus_E4_13 * b4_7 - T(0.1) * hc5_1;
  const T K_thetadot5_3_2 = b4_5 - T(0.1) * minus_B_thetadot5_3_1 - T(0.6) * B_thetadot5_3_3;
  const T K_thetadot5_3_3 = b4_4 + E4_11 * b4_7 - minus_E4_13 * b4_3;
  A[36] = K_thetadot5_3_1;
  A[66] = K_thetadot5_3_1;
  A[35] = b3_4;
  A[50] = b3_4;

  // ---- body 2 (body_2) and what it carries
  // h2 = h_own_2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h2_1 = T(16.24) + hc4_1;
  const T h2_2 = T(4.335) + hc3_2;
  // J2 = -q3~ hc3~ + E3^T J3 E3 + J_own_2 - hc3~ q3~: inertia carried, about the body origin, body axes [kg m^2]
  const T b2_1 = T(0.2) * hc3_3 + T(0.15) * hc3_2;
  const T b2_2 = b2_1 + J3_11;
  const T J2_11 = b2_2 + b2_1;
  const T b2_3 = E3_22 * J3_12 - E3_23 * J3_13;
  const T J2_12 = b2_3 - T(2.436) - T(0.15) * hc4_1;
  const T b2_4 = E3_23 * J3_12 + E3_22 * J3_13;
  const T J2_13 = b2_4 - T(3.2384) - T(0.2) * hc4_1;
  const T b2_5 = E3_23 * (J3_22 - J3_33) + T(2) * E3_22 * J3_23;
  const T b2_6 = E3_23 * b2_5;
  const T J2_22 = J3_22 - b2_6 + T(9.360999999999999) + T(0.4) * hc3_3;
  const T J2_23 = E3_22 * b2_5 - (J3_23 + T(0.8598)) - T(0.2) * hc3_2 - T(0.15) * hc3_3;
  const T b2_7 = T(0.3) * hc3_2;
  const T J2_33 = J3_33 + b2_6 + b2_7 + T(10.757499999999999);
  A[17] = J2_33;
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_1 = E2_11 * h2_1 - E2_12 * h2_2;
  // B_thetadot16_2 = E3^T B_thetadot16_3
  const T B_thetadot16_2_2 = E3_22 * B_thetadot16_4_2 - E3_23 * B_thetadot16_3_3;
  const T B_thetadot16_2_3 = E3_23 * B_thetadot16_4_2 + E3_22 * B_thetadot16_3_3;
  // K_thetadot16_2 = q3~ E3^T B_thetadot16_3 + E3^T K_thetadot16_3
  const T K_thetadot16_2_1 = K_thetadot16_3_1 + T(0.15) * B_thetadot16_2_3 - T(0.2) * B_thetadot16_2_2;
  const T K_thetadot16_2_2 = T(0.2) * B_thetadot16_3_1 + E3_22 * K_thetadot16_3_2 - E3_23 * K_thetadot16_3_3;
  const T K_thetadot16_2_3 = E3_23 * K_thetadot16_3_2 + E3_22 * K_thetadot16_3_3 - T(0.15) * B_thetadot16_3_1;
  A[31] = K_thetadot16_2_3;
  A[241] = K_thetadot16_2_3;
  // B_thetadot15_2 = E3^T B_thetadot15_3
  const T B_thetadot15_2_2 = E3_22 * B_thetadot15_4_2 - E3_23 * B_thetadot15_3_3;
  const T B_thetadot15_2_3 = E3_23 * B_thetadot15_4_2 + E3_22 * B_thetadot15_3_3;
  // K_thetadot15_2 = q3~ E3^T B_thetadot15_3 + E3^T K_thetadot15_3
  const T K_thetadot15_2_1 = K_thetadot15_3_1 + T(0.15) * B_thetadot15_2_3 - T(0.2) * B_thetadot15_2_2;
  const T K_thetadot15_2_2 = T(0.2) * B_thetadot15_3_1 + E3_22 * K_thetadot15_3_2 - E3_23 * K_thetadot15_3_3;
  const T K_thetadot15_2_3 = E3_23 * K_thetadot15_3_2 + E3_22 * K_thetadot15_3_3 - T(0.15) * B_thetadot15_3_1;
  A[30] = K_thetadot15_2_3;
  A[225] = K_thetadot15_2_3;
  // B_thetadot14_2 = E3^T B_thetadot14_3
  const T B_thetadot14_2_2 = E3_22 * B_thetadot14_4_2 - E3_23 * B_thetadot14_3_3;
  const T B_thetadot14_2_3 = E3_23 * B_thetadot14_4_2 + E3_22 * B_thetadot14_3_3;
  // K_thetadot14_2 = q3~ E3^T B_thetadot14_3 + E3^T K_thetadot14_3
  const T K_thetadot14_2_1 = K_thetadot14_3_1 + T(0.15) * B_thetadot14_2_3 - T(0.2) * B_thetadot14_2_2;
  const T K_thetadot14_2_2 = T(0.2) * B_thetadot14_3_1 + E3_22 * K_thetadot14_3_2 - E3_23 * K_thetadot14_3_3;
  const T K_thetadot14_2_3 = E3_23 * K_thetadot14_3_2 + E3_22 * K_thetadot14_3_3 - T(0.15) * B_thetadot14_3_1;
  A[29] = K_thetadot14_2_3;
  A[209] = K_thetadot14_2_3;
  // B_thetadot13_2 = E3^T B_thetadot13_3
  const T B_thetadot13_2_2 = E3_22 * B_thetadot13_4_2 - E3_23 * B_thetadot13_3_3;
  const T B_thetadot13_2_3 = E3_23 * B_thetadot13_4_2 + E3_22 * B_thetadot13_3_3;
  // K_thetadot13_2 = q3~ E3^T B_thetadot13_3 + E3^T K_thetadot13_3
  const T K_thetadot13_2_1 = K_thetadot13_3_1 + T(0.15) * B_thetadot13_2_3 - T(0.2) * B_thetadot13_2_2;
  const T K_thetadot13_2_2 = T(0.2) * B_thetadot13_3_1 + E3_22 * K_thetadot13_3_2 - E3_23 * K_thetadot13_3_3;
  const T K_thetadot13_2_3 = E3_23 * K_thetadot13_3_2 + E3_22 * K_thetadot13_3_3 - T(0.15) * B_thetadot13_3_1;
  A[28] = K_thetadot13_2_3;
  A[193] = K_thetadot13_2_3;
  // B_thetadot12_2 = E3^T B_thetadot12_3
  const T B_thetadot12_2_2 = E3_22 * B_thetadot12_4_2 - E3_23 * B_thetadot12_3_3;
  const T B_thetadot12_2_3 = E3_23 * B_thetadot12_4_2 + E3_22 * B_thetadot12_3_3;
  // K_thetadot12_2 = q3~ E3^T B_thetadot12_3 + E3^T K_thetadot12_3
  const T K_thetadot12_2_1 = K_thetadot12_3_1 + T(0.15) * B_thetadot12_2_3 - T(0.2) * B_thetadot12_2_2;
  const T K_thetadot12_2_2 = T(0.2) * B_thetadot12_3_1 + E3_22 * K_thetadot12_3_2 - E3_23 * K_thetadot12_3_3;
  const T K_thetadot12_2_3 = E3_23 * K_thetadot12_3_2 + E3_22 * K_thetadot12_3_3 - T(0.15) * B_thetadot12_3_1;
  A[27] = K_thetadot12_2_3;
  A[177] = K_thetadot12_2_3;
  // B_thetadot11_2 = E3^T B_thetadot11_3
  const T B_thetadot11_2_2 = E3_22 * B_thetadot11_4_2 - E3_23 * B_thetadot11_3_3;
  const T B_thetadot11_2_3 = E3_23 * B_thetadot11_4_2 + E3_22 * B_thetadot11_3_3;
  // K_thetadot11_2 = q3~ E3^T B_thetadot11_3 + E3^T K_thetadot11_3
  const T K_thetadot11_2_1 = K_thetadot11_3_1 + T(0.15) * B_thetadot11_2_3 - T(0.2) * B_thetadot11_2_2;
  const T K_thetadot11_2_2 = T(0.2) * B_thetadot11_3_1 + E3_22 * K_thetadot11_3_2 - E3_23 * K_thetadot11_3_3;
  const T K_thetadot11_2_3 = E3_23 * K_thetadot11_3_2 + E3_22 * K_thetadot11_3_3 - T(0.15) * B_thetadot11_3_1;
  A[26] = K_thetadot11_2_3;
  A[161] = K_thetadot11_2_3;
  // B_thetadot10_2 = E3^T B_thetadot10_3
  const T B_thetadot10_2_2 = E3_22 * B_thetadot10_4_2 - E3_23 * B_thetadot10_3_3;
  const T B_thetadot10_2_3 = E3_23 * B_thetadot10_4_2 + E3_22 * B_thetadot10_3_3;
  // K_thetadot10_2 = q3~ E3^T B_thetadot10_3 + E3^T K_thetadot10_3
  const T K_thetadot10_2_1 = K_thetadot10_3_1 + T(0.15) * B_thetadot10_2_3 - T(0.2) * B_thetadot10_2_2;
  const T K_thetadot10_2_2 = T(0.2) * B_thetadot10_3_1 + E3_22 * K_thetadot10_3_2 - E3_23 * K_thetadot10_3_3;
  const T K_thetadot10_2_3 = E3_23 * K_thetadot10_3_2 + E3_22 * K_thetadot10_3_3 - T(0.15) * B_thetadot10_3_1;
  A[25] = K_thetadot10_2_3;
  A[145] = K_thetadot10_2_3;
  // B_thetadot9_2 = E3^T B_thetadot9_3
  const T B_thetadot9_2_2 = E3_22 * B_thetadot9_4_2 - E3_23 * B_thetadot9_3_3;
  const T B_thetadot9_2_3 = E3_23 * B_thetadot9_4_2 + E3_22 * B_thetadot9_3_3;
  // K_thetadot9_2 = q3~ E3^T B_thetadot9_3 + E3^T K_thetadot9_3
  const T K_thetadot9_2_1 = K_thetadot9_3_1 + T(0.15) * B_thetadot9_2_3 - T(0.2) * B_thetadot9_2_2;
  const T K_thetadot9_2_2 = T(0.2) * B_thetadot9_3_1 + E3_22 * K_thetadot9_3_2 - E3_23 * K_thetadot9_3_3;
  const T K_thetadot9_2_3 = E3_23 * K_thetadot9_3_2 + E3_22 * K_thetadot9_3_3 - T(0.15) * B_thetadot9_3_1;
  A[24] = K_thetadot9_2_3;
  A[129] = K_thetadot9_2_3;
  // B_thetadot8_2 = E3^T B_thetadot8_3
  const T B_thetadot8_2_2 = E3_22 * B_thetadot8_4_2 - E3_23 * B_thetadot8_3_3;
  const T B_thetadot8_2_3 = E3_23 * B_thetadot8_4_2 + E3_22 * B_thetadot8_3_3;
  // K_thetadot8_2 = q3~ E3^T B_thetadot8_3 + E3^T K_thetadot8_3
  const T K_thetadot8_2_1 = K_thetadot8_3_1 + T(0.15) * B_thetadot8_2_3 - T(0.2) * B_thetadot8_2_2;
  const T K_thetadot8_2_2 = T(0.2) * B_thetadot8_3_1 + E3_22 * K_thetadot8_3_2 - E3_23 * K_thetadot8_3_3;
  const T K_thetadot8_2_3 = E3_23 * K_thetadot8_3_2 + E3_22 * K_thetadot8_3_3 - T(0.15) * B_thetadot8_3_1;
  A[23] = K_thetadot8_2_3;
  A[113] = K_thetadot8_2_3;
  // B_thetadot7_2 = E3^T B_thetadot7_3
  const T B_thetadot7_2_2 = E3_22 * B_thetadot7_4_2 + E3_23 * minus_B_thetadot7_3_3;
  const T B_thetadot7_2_3 = E3_23 * B_thetadot7_4_2 - E3_22 * minus_B_thetadot7_3_3;
  // K_thetadot7_2 = q3~ E3^T B_thetadot7_3 + E3^T K_thetadot7_3
  const T K_thetadot7_2_1 = K_thetadot7_3_1 + T(0.15) * B_thetadot7_2_3 - T(0.2) * B_thetadot7_2_2;
  const T K_thetadot7_2_2 = T(0.2) * B_thetadot7_3_1 + E3_22 * K_thetadot7_3_2 - E3_23 * K_thetadot7_3_3;
  const T K_thetadot7_2_3 = E3_23 * K_thetadot7_3_2 + E3_22 * K_thetadot7_3_3 - T(0.15) * B_thetadot7_3_1;
  A[22] = K_thetadot7_2_3;
  A[97] = K_thetadot7_2_3;
  // B_thetadot6_2 = E3^T B_thetadot6_3
  const T minus_B_thetadot6_2_2 = E3_22 * minus_B_thetadot6_4_2 + E3_23 * B_thetadot6_3_3;
  const T B_thetadot6_2_3 = E3_22 * B_thetadot6_3_3 - E3_23 * minus_B_thetadot6_4_2;
  // K_thetadot6_2 = q3~ E3^T B_thetadot6_3 + E3^T K_thetadot6_3
  const T K_thetadot6_2_1 = K_thetadot6_3_1 + T(0.2) * minus_B_thetadot6_2_2 + T(0.15) * B_thetadot6_2_3;
  const T K_thetadot6_2_2 = T(0.2) * B_thetadot6_3_1 + E3_22 * K_thetadot6_3_2 - E3_23 * K_thetadot6_3_3;
  const T K_thetadot6_2_3 = E3_23 * K_thetadot6_3_2 + E3_22 * K_thetadot6_3_3 - T(0.15) * B_thetadot6_3_1;
  A[21] = K_thetadot6_2_3;
  A[81] = K_thetadot6_2_3;
  // B_thetadot5_2 = E3^T B_thetadot5_3
  const T B_thetadot5_2_2 = E3_22 * hc5_1 - E3_23 * B_thetadot5_3_3;
  const T B_thetadot5_2_3 = E3_23 * hc5_1 + E3_22 * B_thetadot5_3_3;
  // K_thetadot5_2 = q3~ E3^T B_thetadot5_3 + E3^T K_thetadot5_3
  const T K_thetadot5_2_1 = K_thetadot5_3_1 + T(0.15) * B_thetadot5_2_3 - T(0.2) * B_thetadot5_2_2;
  const T K_thetadot5_2_2 = E3_22 * K_thetadot5_3_2 - E3_23 * K_thetadot5_3_3 - T(0.2) * minus_B_thetadot5_3_1;
  const T K_thetadot5_2_3 = T(0.15) * minus_B_thetadot5_3_1 + E3_23 * K_thetadot5_3_2 + E3_22 * K_thetadot5_3_3;
  A[20] = K_thetadot5_2_3;
  A[65] = K_thetadot5_2_3;
  // B_thetadot4_2 = E3^T B_thetadot4_3
  const T B_thetadot4_2_2 = E3_23 * hc4_1;
  const T minus_B_thetadot4_2_3 = E3_22 * hc4_1;
  // K_thetadot4_2 = q3~ E3^T B_thetadot4_3 + E3^T K_thetadot4_3
  const T K_thetadot4_2_1 = b3_4 - T(0.2) * B_thetadot4_2_2 - T(0.15) * minus_B_thetadot4_2_3;
  const T K_thetadot4_2_2 = b3_3 + E3_22 * b3_6 - E3_23 * b3_7;
  const T K_thetadot4_2_3 = E3_23 * b3_6 + E3_22 * b3_7 - T(0.15) * hc4_3;
  A[19] = K_thetadot4_2_3;
  A[49] = K_thetadot4_2_3;
  A[18] = b2_4;
  A[33] = b2_4;

  // ---- body 1 (body_1) and what it carries
  // J1 = -q2~ hc2~ + E2^T J2 E2 + J_own_1 - hc2~ q2~: inertia carried, about the body origin, body axes [kg m^2]
  const T J1_22 = J2_22 + T(4.612) + E2_12 * (E2_12 * (J2_11 - J2_22) + T(2) * E2_11 * J2_12) + T(0.6) * hc2_1;
  A[0] = J1_22;
  // K_thetadot16_1 = q2~ E2^T B_thetadot16_2 + E2^T K_thetadot16_2
  const T K_thetadot16_1_2 = E2_12 * K_thetadot16_2_1 + E2_11 * K_thetadot16_2_2 - T(0.3) * B_thetadot16_2_3;
  A[15] = K_thetadot16_1_2;
  A[240] = K_thetadot16_1_2;
  // K_thetadot15_1 = q2~ E2^T B_thetadot15_2 + E2^T K_thetadot15_2
  const T K_thetadot15_1_2 = E2_12 * K_thetadot15_2_1 + E2_11 * K_thetadot15_2_2 - T(0.3) * B_thetadot15_2_3;
  A[14] = K_thetadot15_1_2;
  A[224] = K_thetadot15_1_2;
  // K_thetadot14_1 = q2~ E2^T B_thetadot14_2 + E2^T K_thetadot14_2
  const T K_thetadot14_1_2 = E2_12 * K_thetadot14_2_1 + E2_11 * K_thetadot14_2_2 - T(0.3) * B_thetadot14_2_3;
  A[13] = K_thetadot14_1_2;
  A[208] = K_thetadot14_1_2;
  // K_thetadot13_1 = q2~ E2^T B_thetadot13_2 + E2^T K_thetadot13_2
  const T K_thetadot13_1_2 = E2_12 * K_thetadot13_2_1 + E2_11 * K_thetadot13_2_2 - T(0.3) * B_thetadot13_2_3;
  A[12] = K_thetadot13_1_2;
  A[192] = K_thetadot13_1_2;
  // K_thetadot12_1 = q2~ E2^T B_thetadot12_2 + E2^T K_thetadot12_2
  const T K_thetadot12_1_2 = E2_12 * K_thetadot12_2_1 + E2_11 * K_thetadot12_2_2 - T(0.3) * B_thetadot12_2_3;
  A[11] = K_thetadot12_1_2;
  A[176] = K_thetadot12_1_2;
  // K_thetadot11_1 = q2~ E2^T B_thetadot11_2 + E2^T K_thetadot11_2
  const T K_thetadot11_1_2 = E2_12 * K_thetadot11_2_1 + E2_11 * K_thetadot11_2_2 - T(0.3) * B_thetadot11_2_3;
  A[10] = K_thetadot11_1_2;
  A[160] = K_thetadot11_1_2;
  // K_thetadot10_1 = q2~ E2^T B_thetadot10_2 + E2^T K_thetadot10_2
  const T K_thetadot10_1_2 = E2_12 * K_thetadot10_2_1 + E2_11 * K_thetadot10_2_2 - T(0.3) * B_thetadot10_2_3;
  A[9] = K_thetadot10_1_2;
  A[144] = K_thetadot10_1_2;
  // K_thetadot9_1 = q2~ E2^T B_thetadot9_2 + E2^T K_thetadot9_2
  const T K_thetadot9_1_2 = E2_12 * K_thetadot9_2_1 + E2_11 * K_thetadot9_2_2 - T(0.3) * B_thetadot9_2_3;
  A[8] = K_thetadot9_1_2;
  A[128] = K_thetadot9_1_2;
  // K_thetadot8_1 = q2~ E2^T B_thetadot8_2 + E2^T K_thetadot8_2
  const T K_thetadot8_1_2 = E2_12 * K_thetadot8_2_1 + E2_11 * K_thetadot8_2_2 - T(0.3) * B_thetadot8_2_3;
  A[7] = K_thetadot8_1_2;
  A[112] = K_thetadot8_1_2;
  // K_thetadot7_1 = q2~ E2^T B_thetadot7_2 + E2^T K_thetadot7_2
  const T K_thetadot7_1_2 = E2_12 * K_thetadot7_2_1 + E2_11 * K_thetadot7_2_2 - T(0.3) * B_thetadot7_2_3;
  A[6] = K_thetadot7_1_2;
  A[96] = K_thetadot7_1_2;
  // K_thetadot6_1 = q2~ E2^T B_thetadot6_2 + E2^T K_thetadot6_2
  const T K_thetadot6_1_2 = E2_12 * K_thetadot6_2_1 + E2_11 * K_thetadot6_2_2 - T(0.3) * B_thetadot6_2_3;
  A[5] = K_thetadot6_1_2;
  A[80] = K_thetadot6_1_2;
  // K_thetadot5_1 = q2~ E2^T B_thetadot5_2 + E2^T K_thetadot5_2
  const T K_thetadot5_1_2 = E2_12 * K_thetadot5_2_1 + E2_11 * K_thetadot5_2_2 - T(0.3) * B_thetadot5_2_3;
  A[4] = K_thetadot5_1_2;
  A[64] = K_thetadot5_1_2;
  // K_thetadot4_1 = q2~ E2^T B_thetadot4_2 + E2^T K_thetadot4_2
  const T K_thetadot4_1_2 = T(0.3) * minus_B_thetadot4_2_3 + E2_12 * K_thetadot4_2_1 + E2_11 * K_thetadot4_2_2;
  A[3] = K_thetadot4_1_2;
  A[48] = K_thetadot4_1_2;
  // K_thetadot3_1 = q2~ E2^T B_thetadot3_2 + E2^T K_thetadot3_2
  const T K_thetadot3_1_2 = E2_12 * b2_2 - b2_7 + E2_11 * b2_3;
  A[2] = K_thetadot3_1_2;
  A[32] = K_thetadot3_1_2;
  // K_thetadot2_1 = q2~ E2^T B_thetadot2_2 + E2^T K_thetadot2_2
  const T K_thetadot2_1_2 = E2_12 * J2_13 + E2_11 * J2_23;
  A[1] = K_thetadot2_1_2;
  A[16] = K_thetadot2_1_2;

  // ---- results
  A[255] = T(0.34450000000000003);
}

}  // namespace kanec::bench_cr16
