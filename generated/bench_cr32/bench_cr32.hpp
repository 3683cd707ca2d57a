// SPDX-License-Identifier: BSD-3-Clause
// bench_cr32: equations of motion of 32 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model b4b5ae030498a44a of bench_cr32/scene.toml; functions kinematics energy accelerations residual
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
//   17 body_17 on 16: revolute
//   18 body_18 on 17: revolute
//   19 body_19 on 18: revolute
//   20 body_20 on 19: revolute
//   21 body_21 on 20: revolute
//   22 body_22 on 21: revolute
//   23 body_23 on 22: revolute
//   24 body_24 on 23: revolute
//   25 body_25 on 24: revolute
//   26 body_26 on 25: revolute
//   27 body_27 on 26: revolute
//   28 body_28 on 27: revolute
//   29 body_29 on 28: revolute
//   30 body_30 on 29: revolute
//   31 body_31 on 30: revolute
//   32 body_32 on 31: revolute
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (theta_1, theta_2, theta_3, theta_4, theta_5, theta_6, theta_7, theta_8, theta_9, theta_10, theta_11,
//   theta_12, theta_13, theta_14, theta_15, theta_16, theta_17, theta_18, theta_19, theta_20, theta_21, theta_22,
//   theta_23, theta_24, theta_25, theta_26, theta_27, theta_28, theta_29, theta_30, theta_31, theta_32)
//   y = (thetadot_1, thetadot_2, thetadot_3, thetadot_4, thetadot_5, thetadot_6, thetadot_7, thetadot_8, thetadot_9,
//   thetadot_10, thetadot_11, thetadot_12, thetadot_13, thetadot_14, thetadot_15, thetadot_16, thetadot_17,
//   thetadot_18, thetadot_19, thetadot_20, thetadot_21, thetadot_22, thetadot_23, thetadot_24, thetadot_25,
//   thetadot_26, thetadot_27, thetadot_28, thetadot_29, thetadot_30, thetadot_31, thetadot_32)
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
//   energy                  3656 (1589 add, 2067 multiply, 64 sine or cosine)
//   accelerations           9240 (4500 add, 4709 multiply, 31 divide, 64 sine or cosine)
//   residual                3825 (1894 add, 1931 multiply, 64 sine or cosine)
//
// functions written as loops over bodies; bytes in double, estimated:
//   accelerations: 95 sections of 28 kinds; 32502 of code, 16456 of stack
//     as a straight line: 83736 of code, 2200 of stack
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

namespace kanec::bench_cr32 {

inline constexpr int n_bodies = 32;
inline constexpr int nx = 32;
inline constexpr int ny = 32;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 32;
inline constexpr char model_hash[] = "b4b5ae030498a44a";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_1 = 0, theta_2 = 1, theta_3 = 2, theta_4 = 3, theta_5 = 4, theta_6 = 5, theta_7 = 6,
    theta_8 = 7, theta_9 = 8, theta_10 = 9, theta_11 = 10, theta_12 = 11, theta_13 = 12, theta_14 = 13, theta_15 = 14,
    theta_16 = 15, theta_17 = 16, theta_18 = 17, theta_19 = 18, theta_20 = 19, theta_21 = 20, theta_22 = 21,
    theta_23 = 22, theta_24 = 23, theta_25 = 24, theta_26 = 25, theta_27 = 26, theta_28 = 27, theta_29 = 28,
    theta_30 = 29, theta_31 = 30, theta_32 = 31;
inline constexpr int thetadot_1 = 0, thetadot_2 = 1, thetadot_3 = 2, thetadot_4 = 3, thetadot_5 = 4, thetadot_6 = 5,
    thetadot_7 = 6, thetadot_8 = 7, thetadot_9 = 8, thetadot_10 = 9, thetadot_11 = 10, thetadot_12 = 11,
    thetadot_13 = 12, thetadot_14 = 13, thetadot_15 = 14, thetadot_16 = 15, thetadot_17 = 16, thetadot_18 = 17,
    thetadot_19 = 18, thetadot_20 = 19, thetadot_21 = 20, thetadot_22 = 21, thetadot_23 = 22, thetadot_24 = 23,
    thetadot_25 = 24, thetadot_26 = 25, thetadot_27 = 26, thetadot_28 = 27, thetadot_29 = 28, thetadot_30 = 29,
    thetadot_31 = 30, thetadot_32 = 31;
}  // namespace at

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
  T tau_17 = T(0);
  T tau_18 = T(0);
  T tau_19 = T(0);
  T tau_20 = T(0);
  T tau_21 = T(0);
  T tau_22 = T(0);
  T tau_23 = T(0);
  T tau_24 = T(0);
  T tau_25 = T(0);
  T tau_26 = T(0);
  T tau_27 = T(0);
  T tau_28 = T(0);
  T tau_29 = T(0);
  T tau_30 = T(0);
  T tau_31 = T(0);
  T tau_32 = T(0);
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
  const T thetadot17 = y[16];
  const T thetadot18 = y[17];
  const T thetadot19 = y[18];
  const T thetadot20 = y[19];
  const T thetadot21 = y[20];
  const T thetadot22 = y[21];
  const T thetadot23 = y[22];
  const T thetadot24 = y[23];
  const T thetadot25 = y[24];
  const T thetadot26 = y[25];
  const T thetadot27 = y[26];
  const T thetadot28 = y[27];
  const T thetadot29 = y[28];
  const T thetadot30 = y[29];
  const T thetadot31 = y[30];
  const T thetadot32 = y[31];
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
  xdot[16] = thetadot17;
  xdot[17] = thetadot18;
  xdot[18] = thetadot19;
  xdot[19] = thetadot20;
  xdot[20] = thetadot21;
  xdot[21] = thetadot22;
  xdot[22] = thetadot23;
  xdot[23] = thetadot24;
  xdot[24] = thetadot25;
  xdot[25] = thetadot26;
  xdot[26] = thetadot27;
  xdot[27] = thetadot28;
  xdot[28] = thetadot29;
  xdot[29] = thetadot30;
  xdot[30] = thetadot31;
  xdot[31] = thetadot32;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 1589 add, 2067 multiply, 64 sine or cosine
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  T cosines[32], sines[32];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 32, cosines, sines);

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
  const T t16_1 = R16_33 * T(0.05);
  const T p16_3 = t15_2 + t16_1 + P16_3 + R16_13 * T(0.1);
  // Pdot16 = R15^T omega15~ q16 + Pdot15: velocity of the body origin, inertial axes [m/s]
  const T t16_2 = t15_9 - omega15_3 * T(0.8);
  const T t16_3 = omega15_3 * T(0.3) - omega15_1 * T(0.1);
  const T t16_4 = omega15_1 * T(0.8) - t15_11;
  const T Pdot16_1 = Pdot15_1 + R14_11 * t16_2 + R15_21 * t16_3 + R15_31 * t16_4;
  const T Pdot16_2 = Pdot15_2 + R14_12 * t16_2 + R15_22 * t16_3 + R15_32 * t16_4;
  const T Pdot16_3 = Pdot15_3 + R14_13 * t16_2 + R15_23 * t16_3 + R15_33 * t16_4;
  // v16 = R16^T omega16~ r16 + Pdot16: velocity of the mass centre, inertial axes [m/s]
  const T t16_5 = omega16_2 * T(0.05) - omega16_3 * T(0.2);
  const T t16_6 = omega16_3 * T(0.1) - omega16_1 * T(0.05);
  const T t16_7 = omega16_2 * T(0.1);
  const T t16_8 = omega16_1 * T(0.2) - t16_7;
  const T v16_1 = Pdot16_1 + R16_11 * t16_5 + R15_21 * t16_6 + R16_31 * t16_8;
  const T v16_2 = Pdot16_2 + R16_12 * t16_5 + R15_22 * t16_6 + R16_32 * t16_8;
  const T v16_3 = Pdot16_3 + R16_13 * t16_5 + R15_23 * t16_6 + R16_33 * t16_8;
  // T16 = 1/2 omega16 . (I16 omega16) + 1/2 m16 v16 . v16: kinetic energy [J]
  const T T16 = T(0.5) * (omega16_1 * (T(0.26) * omega16_1 + T(0.013) * omega16_2 + T(0.0078) * omega16_3) + omega16_2
      * (T(0.013) * omega16_1 + T(0.312) * omega16_2 - T(0.0104) * omega16_3) + omega16_3 * (T(0.0078) * omega16_1 -
      T(0.0104) * omega16_2 + T(0.208) * omega16_3)) + T(1.3) * (v16_1 * v16_1 + v16_2 * v16_2 + v16_3 * v16_3);

  // ---- body 17 (body_17) on body 16
  const T thetadot17 = y[16];
  // E17^T = Rot(b17, theta17): E takes components in the lower body to those in the body
  const T E17_11 = cosines[16];
  const T E17_12 = sines[16];
  // R17^T = R16^T E17^T: R takes inertial components to body components
  const T R17_11 = R16_11 * E17_11 + R15_21 * E17_12;
  const T R17_12 = R16_12 * E17_11 + R15_22 * E17_12;
  const T R17_13 = R16_13 * E17_11 + R15_23 * E17_12;
  const T R17_21 = R15_21 * E17_11 - R16_11 * E17_12;
  const T R17_22 = R15_22 * E17_11 - R16_12 * E17_12;
  const T R17_23 = R15_23 * E17_11 - R16_13 * E17_12;
  // omega17 = thetadot17 b17 + E17 omega16: absolute angular velocity, body axes [rad/s]
  const T omega17_1 = E17_11 * omega16_1 + E17_12 * omega16_2;
  const T omega17_2 = E17_11 * omega16_2 - E17_12 * omega16_1;
  const T omega17_3 = thetadot17 + omega16_3;
  // P17 = R16^T q17 + P16: position of the body origin, inertial axes [m]
  const T t17_1 = R16_33 * T(0.1);
  const T P17_3 = t17_1 + P16_3 + R16_13 * T(0.3) + R15_23 * T(0.85);
  // p17 = R17^T r17 + P17: position of the mass centre, inertial axes [m]
  const T t17_2 = R17_13 * T(0.1);
  const T p17_3 = t17_2 + t16_1 + P17_3 + R17_23 * T(0.2);
  // Pdot17 = R16^T omega16~ q17 + Pdot16: velocity of the body origin, inertial axes [m/s]
  const T t17_3 = t16_7 - omega16_3 * T(0.85);
  const T t17_4 = omega16_3 * T(0.3) - omega16_1 * T(0.1);
  const T t17_5 = omega16_1 * T(0.85) - omega16_2 * T(0.3);
  const T Pdot17_1 = Pdot16_1 + R16_11 * t17_3 + R15_21 * t17_4 + R16_31 * t17_5;
  const T Pdot17_2 = Pdot16_2 + R16_12 * t17_3 + R15_22 * t17_4 + R16_32 * t17_5;
  const T Pdot17_3 = Pdot16_3 + R16_13 * t17_3 + R15_23 * t17_4 + R16_33 * t17_5;
  // v17 = R17^T omega17~ r17 + Pdot17: velocity of the mass centre, inertial axes [m/s]
  const T t17_6 = omega17_2 * T(0.05) - omega17_3 * T(0.2);
  const T t17_7 = omega17_3 * T(0.1) - omega17_1 * T(0.05);
  const T t17_8 = omega17_2 * T(0.1);
  const T t17_9 = omega17_1 * T(0.2) - t17_8;
  const T v17_1 = Pdot17_1 + R17_11 * t17_6 + R17_21 * t17_7 + R16_31 * t17_9;
  const T v17_2 = Pdot17_2 + R17_12 * t17_6 + R17_22 * t17_7 + R16_32 * t17_9;
  const T v17_3 = Pdot17_3 + R17_13 * t17_6 + R17_23 * t17_7 + R16_33 * t17_9;
  // T17 = 1/2 omega17 . (I17 omega17) + 1/2 m17 v17 . v17: kinetic energy [J]
  const T T17 = T(0.5) * (omega17_1 * (T(0.27) * omega17_1 + T(0.0135) * omega17_2 + T(0.0081) * omega17_3) +
      omega17_2 * (T(0.0135) * omega17_1 + T(0.324) * omega17_2 - T(0.0108) * omega17_3) + omega17_3 * (T(0.0081) *
      omega17_1 - T(0.0108) * omega17_2 + T(0.216) * omega17_3)) + T(1.35) * (v17_1 * v17_1 + v17_2 * v17_2 + v17_3 *
      v17_3);

  // ---- body 18 (body_18) on body 17
  const T thetadot18 = y[17];
  // E18^T = Rot(b18, theta18): E takes components in the lower body to those in the body
  const T E18_22 = cosines[17];
  const T E18_23 = sines[17];
  // R18^T = R17^T E18^T: R takes inertial components to body components
  const T R18_21 = R17_21 * E18_22 + R16_31 * E18_23;
  const T R18_22 = R17_22 * E18_22 + R16_32 * E18_23;
  const T R18_23 = R17_23 * E18_22 + R16_33 * E18_23;
  const T R18_31 = R16_31 * E18_22 - R17_21 * E18_23;
  const T R18_32 = R16_32 * E18_22 - R17_22 * E18_23;
  const T R18_33 = R16_33 * E18_22 - R17_23 * E18_23;
  // omega18 = thetadot18 b18 + E18 omega17: absolute angular velocity, body axes [rad/s]
  const T omega18_1 = thetadot18 + omega17_1;
  const T omega18_2 = E18_22 * omega17_2 + E18_23 * omega17_3;
  const T omega18_3 = E18_22 * omega17_3 - E18_23 * omega17_2;
  // P18 = R17^T q18 + P17: position of the body origin, inertial axes [m]
  const T t18_1 = R17_13 * T(0.3);
  const T P18_3 = t18_1 + t17_1 + P17_3 + R17_23 * T(0.9);
  // p18 = R18^T r18 + P18: position of the mass centre, inertial axes [m]
  const T t18_2 = R18_23 * T(0.2);
  const T p18_3 = t17_2 + t18_2 + P18_3 + R18_33 * T(0.05);
  // Pdot18 = R17^T omega17~ q18 + Pdot17: velocity of the body origin, inertial axes [m/s]
  const T t18_3 = t17_8 - omega17_3 * T(0.9);
  const T t18_4 = omega17_3 * T(0.3) - omega17_1 * T(0.1);
  const T t18_5 = omega17_1 * T(0.9) - omega17_2 * T(0.3);
  const T Pdot18_1 = Pdot17_1 + R17_11 * t18_3 + R17_21 * t18_4 + R16_31 * t18_5;
  const T Pdot18_2 = Pdot17_2 + R17_12 * t18_3 + R17_22 * t18_4 + R16_32 * t18_5;
  const T Pdot18_3 = Pdot17_3 + R17_13 * t18_3 + R17_23 * t18_4 + R16_33 * t18_5;
  // v18 = R18^T omega18~ r18 + Pdot18: velocity of the mass centre, inertial axes [m/s]
  const T t18_6 = omega18_2 * T(0.05) - omega18_3 * T(0.2);
  const T t18_7 = omega18_3 * T(0.1) - omega18_1 * T(0.05);
  const T t18_8 = omega18_2 * T(0.1);
  const T t18_9 = omega18_1 * T(0.2) - t18_8;
  const T v18_1 = Pdot18_1 + R17_11 * t18_6 + R18_21 * t18_7 + R18_31 * t18_9;
  const T v18_2 = Pdot18_2 + R17_12 * t18_6 + R18_22 * t18_7 + R18_32 * t18_9;
  const T v18_3 = Pdot18_3 + R17_13 * t18_6 + R18_23 * t18_7 + R18_33 * t18_9;
  // T18 = 1/2 omega18 . (I18 omega18) + 1/2 m18 v18 . v18: kinetic energy [J]
  const T T18 = T(0.5) * (omega18_1 * (T(0.28) * omega18_1 + T(0.014) * omega18_2 + T(0.0084) * omega18_3) + omega18_2
      * (T(0.014) * omega18_1 + T(0.336) * omega18_2 - T(0.0112) * omega18_3) + omega18_3 * (T(0.0084) * omega18_1 -
      T(0.0112) * omega18_2 + T(0.224) * omega18_3)) + T(1.4) * (v18_1 * v18_1 + v18_2 * v18_2 + v18_3 * v18_3);

  // ---- body 19 (body_19) on body 18
  const T thetadot19 = y[18];
  // E19^T = Rot(b19, theta19): E takes components in the lower body to those in the body
  const T E19_11 = cosines[18];
  const T minus_E19_13 = sines[18];
  // R19^T = R18^T E19^T: R takes inertial components to body components
  const T R19_11 = R17_11 * E19_11 - R18_31 * minus_E19_13;
  const T R19_12 = R17_12 * E19_11 - R18_32 * minus_E19_13;
  const T R19_13 = R17_13 * E19_11 - R18_33 * minus_E19_13;
  const T R19_31 = R17_11 * minus_E19_13 + R18_31 * E19_11;
  const T R19_32 = R17_12 * minus_E19_13 + R18_32 * E19_11;
  const T R19_33 = R17_13 * minus_E19_13 + R18_33 * E19_11;
  // omega19 = thetadot19 b19 + E19 omega18: absolute angular velocity, body axes [rad/s]
  const T omega19_1 = E19_11 * omega18_1 - minus_E19_13 * omega18_3;
  const T omega19_2 = thetadot19 + omega18_2;
  const T omega19_3 = minus_E19_13 * omega18_1 + E19_11 * omega18_3;
  // P19 = R18^T q19 + P18: position of the body origin, inertial axes [m]
  const T P19_3 = t18_1 + P18_3 + R18_23 * T(0.95) + R18_33 * T(0.1);
  // p19 = R19^T r19 + P19: position of the mass centre, inertial axes [m]
  const T t19_1 = R19_33 * T(0.05);
  const T p19_3 = t18_2 + t19_1 + P19_3 + R19_13 * T(0.1);
  // Pdot19 = R18^T omega18~ q19 + Pdot18: velocity of the body origin, inertial axes [m/s]
  const T t19_2 = t18_8 - omega18_3 * T(0.95);
  const T t19_3 = omega18_3 * T(0.3) - omega18_1 * T(0.1);
  const T t19_4 = omega18_1 * T(0.95) - omega18_2 * T(0.3);
  const T Pdot19_1 = Pdot18_1 + R17_11 * t19_2 + R18_21 * t19_3 + R18_31 * t19_4;
  const T Pdot19_2 = Pdot18_2 + R17_12 * t19_2 + R18_22 * t19_3 + R18_32 * t19_4;
  const T Pdot19_3 = Pdot18_3 + R17_13 * t19_2 + R18_23 * t19_3 + R18_33 * t19_4;
  // v19 = R19^T omega19~ r19 + Pdot19: velocity of the mass centre, inertial axes [m/s]
  const T t19_5 = omega19_2 * T(0.05) - omega19_3 * T(0.2);
  const T t19_6 = omega19_3 * T(0.1) - omega19_1 * T(0.05);
  const T t19_7 = omega19_2 * T(0.1);
  const T t19_8 = omega19_1 * T(0.2) - t19_7;
  const T v19_1 = Pdot19_1 + R19_11 * t19_5 + R18_21 * t19_6 + R19_31 * t19_8;
  const T v19_2 = Pdot19_2 + R19_12 * t19_5 + R18_22 * t19_6 + R19_32 * t19_8;
  const T v19_3 = Pdot19_3 + R19_13 * t19_5 + R18_23 * t19_6 + R19_33 * t19_8;
  // T19 = 1/2 omega19 . (I19 omega19) + 1/2 m19 v19 . v19: kinetic energy [J]
  const T T19 = T(0.5) * (omega19_1 * (T(0.29) * omega19_1 + T(0.0145) * omega19_2 + T(0.0087) * omega19_3) +
      omega19_2 * (T(0.0145) * omega19_1 + T(0.348) * omega19_2 - T(0.0116) * omega19_3) + omega19_3 * (T(0.0087) *
      omega19_1 - T(0.0116) * omega19_2 + T(0.232) * omega19_3)) + T(1.45) * (v19_1 * v19_1 + v19_2 * v19_2 + v19_3 *
      v19_3);

  // ---- body 20 (body_20) on body 19
  const T thetadot20 = y[19];
  // E20^T = Rot(b20, theta20): E takes components in the lower body to those in the body
  const T E20_11 = cosines[19];
  const T E20_12 = sines[19];
  // R20^T = R19^T E20^T: R takes inertial components to body components
  const T R20_11 = R19_11 * E20_11 + R18_21 * E20_12;
  const T R20_12 = R19_12 * E20_11 + R18_22 * E20_12;
  const T R20_13 = R19_13 * E20_11 + R18_23 * E20_12;
  const T R20_21 = R18_21 * E20_11 - R19_11 * E20_12;
  const T R20_22 = R18_22 * E20_11 - R19_12 * E20_12;
  const T R20_23 = R18_23 * E20_11 - R19_13 * E20_12;
  // omega20 = thetadot20 b20 + E20 omega19: absolute angular velocity, body axes [rad/s]
  const T omega20_1 = E20_11 * omega19_1 + E20_12 * omega19_2;
  const T omega20_2 = E20_11 * omega19_2 - E20_12 * omega19_1;
  const T omega20_3 = thetadot20 + omega19_3;
  // P20 = R19^T q20 + P19: position of the body origin, inertial axes [m]
  const T t20_1 = R19_33 * T(0.1);
  const T P20_3 = R18_23 + t20_1 + P19_3 + R19_13 * T(0.3);
  // p20 = R20^T r20 + P20: position of the mass centre, inertial axes [m]
  const T t20_2 = R20_13 * T(0.1);
  const T p20_3 = t20_2 + t19_1 + P20_3 + R20_23 * T(0.2);
  // Pdot20 = R19^T omega19~ q20 + Pdot19: velocity of the body origin, inertial axes [m/s]
  const T t20_3 = t19_7 - omega19_3;
  const T t20_4 = omega19_3 * T(0.3) - omega19_1 * T(0.1);
  const T t20_5 = omega19_1 - omega19_2 * T(0.3);
  const T Pdot20_1 = Pdot19_1 + R19_11 * t20_3 + R18_21 * t20_4 + R19_31 * t20_5;
  const T Pdot20_2 = Pdot19_2 + R19_12 * t20_3 + R18_22 * t20_4 + R19_32 * t20_5;
  const T Pdot20_3 = Pdot19_3 + R19_13 * t20_3 + R18_23 * t20_4 + R19_33 * t20_5;
  // v20 = R20^T omega20~ r20 + Pdot20: velocity of the mass centre, inertial axes [m/s]
  const T t20_6 = omega20_2 * T(0.05) - omega20_3 * T(0.2);
  const T t20_7 = omega20_3 * T(0.1) - omega20_1 * T(0.05);
  const T t20_8 = omega20_2 * T(0.1);
  const T t20_9 = omega20_1 * T(0.2) - t20_8;
  const T v20_1 = Pdot20_1 + R20_11 * t20_6 + R20_21 * t20_7 + R19_31 * t20_9;
  const T v20_2 = Pdot20_2 + R20_12 * t20_6 + R20_22 * t20_7 + R19_32 * t20_9;
  const T v20_3 = Pdot20_3 + R20_13 * t20_6 + R20_23 * t20_7 + R19_33 * t20_9;
  // T20 = 1/2 omega20 . (I20 omega20) + 1/2 m20 v20 . v20: kinetic energy [J]
  const T T20 = T(0.5) * (omega20_1 * (T(0.3) * omega20_1 + T(0.015) * omega20_2 + T(0.009) * omega20_3) + omega20_2 *
      (T(0.015) * omega20_1 + T(0.36) * omega20_2 - T(0.012) * omega20_3) + omega20_3 * (T(0.009) * omega20_1 -
      T(0.012) * omega20_2 + T(0.24) * omega20_3)) + T(1.5) * (v20_1 * v20_1 + v20_2 * v20_2 + v20_3 * v20_3);

  // ---- body 21 (body_21) on body 20
  const T thetadot21 = y[20];
  // E21^T = Rot(b21, theta21): E takes components in the lower body to those in the body
  const T E21_22 = cosines[20];
  const T E21_23 = sines[20];
  // R21^T = R20^T E21^T: R takes inertial components to body components
  const T R21_21 = R20_21 * E21_22 + R19_31 * E21_23;
  const T R21_22 = R20_22 * E21_22 + R19_32 * E21_23;
  const T R21_23 = R20_23 * E21_22 + R19_33 * E21_23;
  const T R21_31 = R19_31 * E21_22 - R20_21 * E21_23;
  const T R21_32 = R19_32 * E21_22 - R20_22 * E21_23;
  const T R21_33 = R19_33 * E21_22 - R20_23 * E21_23;
  // omega21 = thetadot21 b21 + E21 omega20: absolute angular velocity, body axes [rad/s]
  const T omega21_1 = thetadot21 + omega20_1;
  const T omega21_2 = E21_22 * omega20_2 + E21_23 * omega20_3;
  const T omega21_3 = E21_22 * omega20_3 - E21_23 * omega20_2;
  // P21 = R20^T q21 + P20: position of the body origin, inertial axes [m]
  const T t21_1 = R20_13 * T(0.3);
  const T P21_3 = t21_1 + t20_1 + P20_3 + R20_23 * T(1.05);
  // p21 = R21^T r21 + P21: position of the mass centre, inertial axes [m]
  const T t21_2 = R21_23 * T(0.2);
  const T p21_3 = t20_2 + t21_2 + P21_3 + R21_33 * T(0.05);
  // Pdot21 = R20^T omega20~ q21 + Pdot20: velocity of the body origin, inertial axes [m/s]
  const T t21_3 = t20_8 - omega20_3 * T(1.05);
  const T t21_4 = omega20_3 * T(0.3) - omega20_1 * T(0.1);
  const T t21_5 = omega20_1 * T(1.05) - omega20_2 * T(0.3);
  const T Pdot21_1 = Pdot20_1 + R20_11 * t21_3 + R20_21 * t21_4 + R19_31 * t21_5;
  const T Pdot21_2 = Pdot20_2 + R20_12 * t21_3 + R20_22 * t21_4 + R19_32 * t21_5;
  const T Pdot21_3 = Pdot20_3 + R20_13 * t21_3 + R20_23 * t21_4 + R19_33 * t21_5;
  // v21 = R21^T omega21~ r21 + Pdot21: velocity of the mass centre, inertial axes [m/s]
  const T t21_6 = omega21_2 * T(0.05) - omega21_3 * T(0.2);
  const T t21_7 = omega21_3 * T(0.1) - omega21_1 * T(0.05);
  const T t21_8 = omega21_2 * T(0.1);
  const T t21_9 = omega21_1 * T(0.2) - t21_8;
  const T v21_1 = Pdot21_1 + R20_11 * t21_6 + R21_21 * t21_7 + R21_31 * t21_9;
  const T v21_2 = Pdot21_2 + R20_12 * t21_6 + R21_22 * t21_7 + R21_32 * t21_9;
  const T v21_3 = Pdot21_3 + R20_13 * t21_6 + R21_23 * t21_7 + R21_33 * t21_9;
  // T21 = 1/2 omega21 . (I21 omega21) + 1/2 m21 v21 . v21: kinetic energy [J]
  const T T21 = T(0.5) * (omega21_1 * (T(0.31) * omega21_1 + T(0.0155) * omega21_2 + T(0.0093) * omega21_3) +
      omega21_2 * (T(0.0155) * omega21_1 + T(0.372) * omega21_2 - T(0.0124) * omega21_3) + omega21_3 * (T(0.0093) *
      omega21_1 - T(0.0124) * omega21_2 + T(0.248) * omega21_3)) + T(1.55) * (v21_1 * v21_1 + v21_2 * v21_2 + v21_3 *
      v21_3);

  // ---- body 22 (body_22) on body 21
  const T thetadot22 = y[21];
  // E22^T = Rot(b22, theta22): E takes components in the lower body to those in the body
  const T E22_11 = cosines[21];
  const T minus_E22_13 = sines[21];
  // R22^T = R21^T E22^T: R takes inertial components to body components
  const T R22_11 = R20_11 * E22_11 - R21_31 * minus_E22_13;
  const T R22_12 = R20_12 * E22_11 - R21_32 * minus_E22_13;
  const T R22_13 = R20_13 * E22_11 - R21_33 * minus_E22_13;
  const T R22_31 = R20_11 * minus_E22_13 + R21_31 * E22_11;
  const T R22_32 = R20_12 * minus_E22_13 + R21_32 * E22_11;
  const T R22_33 = R20_13 * minus_E22_13 + R21_33 * E22_11;
  // omega22 = thetadot22 b22 + E22 omega21: absolute angular velocity, body axes [rad/s]
  const T omega22_1 = E22_11 * omega21_1 - minus_E22_13 * omega21_3;
  const T omega22_2 = thetadot22 + omega21_2;
  const T omega22_3 = minus_E22_13 * omega21_1 + E22_11 * omega21_3;
  // P22 = R21^T q22 + P21: position of the body origin, inertial axes [m]
  const T P22_3 = t21_1 + P21_3 + R21_23 * T(1.1) + R21_33 * T(0.1);
  // p22 = R22^T r22 + P22: position of the mass centre, inertial axes [m]
  const T t22_1 = R22_33 * T(0.05);
  const T p22_3 = t21_2 + t22_1 + P22_3 + R22_13 * T(0.1);
  // Pdot22 = R21^T omega21~ q22 + Pdot21: velocity of the body origin, inertial axes [m/s]
  const T t22_2 = t21_8 - omega21_3 * T(1.1);
  const T t22_3 = omega21_3 * T(0.3) - omega21_1 * T(0.1);
  const T t22_4 = omega21_1 * T(1.1) - omega21_2 * T(0.3);
  const T Pdot22_1 = Pdot21_1 + R20_11 * t22_2 + R21_21 * t22_3 + R21_31 * t22_4;
  const T Pdot22_2 = Pdot21_2 + R20_12 * t22_2 + R21_22 * t22_3 + R21_32 * t22_4;
  const T Pdot22_3 = Pdot21_3 + R20_13 * t22_2 + R21_23 * t22_3 + R21_33 * t22_4;
  // v22 = R22^T omega22~ r22 + Pdot22: velocity of the mass centre, inertial axes [m/s]
  const T t22_5 = omega22_2 * T(0.05) - omega22_3 * T(0.2);
  const T t22_6 = omega22_3 * T(0.1) - omega22_1 * T(0.05);
  const T t22_7 = omega22_2 * T(0.1);
  const T t22_8 = omega22_1 * T(0.2) - t22_7;
  const T v22_1 = Pdot22_1 + R22_11 * t22_5 + R21_21 * t22_6 + R22_31 * t22_8;
  const T v22_2 = Pdot22_2 + R22_12 * t22_5 + R21_22 * t22_6 + R22_32 * t22_8;
  const T v22_3 = Pdot22_3 + R22_13 * t22_5 + R21_23 * t22_6 + R22_33 * t22_8;
  // T22 = 1/2 omega22 . (I22 omega22) + 1/2 m22 v22 . v22: kinetic energy [J]
  const T T22 = T(0.5) * (omega22_1 * (T(0.32) * omega22_1 + T(0.016) * omega22_2 + T(0.0096) * omega22_3) + omega22_2
      * (T(0.016) * omega22_1 + T(0.384) * omega22_2 - T(0.0128) * omega22_3) + omega22_3 * (T(0.0096) * omega22_1 -
      T(0.0128) * omega22_2 + T(0.256) * omega22_3)) + T(1.6) * (v22_1 * v22_1 + v22_2 * v22_2 + v22_3 * v22_3);

  // ---- body 23 (body_23) on body 22
  const T thetadot23 = y[22];
  // E23^T = Rot(b23, theta23): E takes components in the lower body to those in the body
  const T E23_11 = cosines[22];
  const T E23_12 = sines[22];
  // R23^T = R22^T E23^T: R takes inertial components to body components
  const T R23_11 = R22_11 * E23_11 + R21_21 * E23_12;
  const T R23_12 = R22_12 * E23_11 + R21_22 * E23_12;
  const T R23_13 = R22_13 * E23_11 + R21_23 * E23_12;
  const T R23_21 = R21_21 * E23_11 - R22_11 * E23_12;
  const T R23_22 = R21_22 * E23_11 - R22_12 * E23_12;
  const T R23_23 = R21_23 * E23_11 - R22_13 * E23_12;
  // omega23 = thetadot23 b23 + E23 omega22: absolute angular velocity, body axes [rad/s]
  const T omega23_1 = E23_11 * omega22_1 + E23_12 * omega22_2;
  const T omega23_2 = E23_11 * omega22_2 - E23_12 * omega22_1;
  const T omega23_3 = thetadot23 + omega22_3;
  // P23 = R22^T q23 + P22: position of the body origin, inertial axes [m]
  const T t23_1 = R22_33 * T(0.1);
  const T P23_3 = t23_1 + P22_3 + R22_13 * T(0.3) + R21_23 * T(1.15);
  // p23 = R23^T r23 + P23: position of the mass centre, inertial axes [m]
  const T t23_2 = R23_13 * T(0.1);
  const T p23_3 = t23_2 + t22_1 + P23_3 + R23_23 * T(0.2);
  // Pdot23 = R22^T omega22~ q23 + Pdot22: velocity of the body origin, inertial axes [m/s]
  const T t23_3 = t22_7 - omega22_3 * T(1.15);
  const T t23_4 = omega22_3 * T(0.3) - omega22_1 * T(0.1);
  const T t23_5 = omega22_1 * T(1.15) - omega22_2 * T(0.3);
  const T Pdot23_1 = Pdot22_1 + R22_11 * t23_3 + R21_21 * t23_4 + R22_31 * t23_5;
  const T Pdot23_2 = Pdot22_2 + R22_12 * t23_3 + R21_22 * t23_4 + R22_32 * t23_5;
  const T Pdot23_3 = Pdot22_3 + R22_13 * t23_3 + R21_23 * t23_4 + R22_33 * t23_5;
  // v23 = R23^T omega23~ r23 + Pdot23: velocity of the mass centre, inertial axes [m/s]
  const T t23_6 = omega23_2 * T(0.05) - omega23_3 * T(0.2);
  const T t23_7 = omega23_3 * T(0.1) - omega23_1 * T(0.05);
  const T t23_8 = omega23_2 * T(0.1);
  const T t23_9 = omega23_1 * T(0.2) - t23_8;
  const T v23_1 = Pdot23_1 + R23_11 * t23_6 + R23_21 * t23_7 + R22_31 * t23_9;
  const T v23_2 = Pdot23_2 + R23_12 * t23_6 + R23_22 * t23_7 + R22_32 * t23_9;
  const T v23_3 = Pdot23_3 + R23_13 * t23_6 + R23_23 * t23_7 + R22_33 * t23_9;
  // T23 = 1/2 omega23 . (I23 omega23) + 1/2 m23 v23 . v23: kinetic energy [J]
  const T T23 = T(0.5) * (omega23_1 * (T(0.33) * omega23_1 + T(0.0165) * omega23_2 + T(0.0099) * omega23_3) +
      omega23_2 * (T(0.0165) * omega23_1 + T(0.396) * omega23_2 - T(0.0132) * omega23_3) + omega23_3 * (T(0.0099) *
      omega23_1 - T(0.0132) * omega23_2 + T(0.264) * omega23_3)) + T(1.65) * (v23_1 * v23_1 + v23_2 * v23_2 + v23_3 *
      v23_3);

  // ---- body 24 (body_24) on body 23
  const T thetadot24 = y[23];
  // E24^T = Rot(b24, theta24): E takes components in the lower body to those in the body
  const T E24_22 = cosines[23];
  const T E24_23 = sines[23];
  // R24^T = R23^T E24^T: R takes inertial components to body components
  const T R24_21 = R23_21 * E24_22 + R22_31 * E24_23;
  const T R24_22 = R23_22 * E24_22 + R22_32 * E24_23;
  const T R24_23 = R23_23 * E24_22 + R22_33 * E24_23;
  const T R24_31 = R22_31 * E24_22 - R23_21 * E24_23;
  const T R24_32 = R22_32 * E24_22 - R23_22 * E24_23;
  const T R24_33 = R22_33 * E24_22 - R23_23 * E24_23;
  // omega24 = thetadot24 b24 + E24 omega23: absolute angular velocity, body axes [rad/s]
  const T omega24_1 = thetadot24 + omega23_1;
  const T omega24_2 = E24_22 * omega23_2 + E24_23 * omega23_3;
  const T omega24_3 = E24_22 * omega23_3 - E24_23 * omega23_2;
  // P24 = R23^T q24 + P23: position of the body origin, inertial axes [m]
  const T t24_1 = R23_13 * T(0.3);
  const T P24_3 = t24_1 + t23_1 + P23_3 + R23_23 * T(1.2);
  // p24 = R24^T r24 + P24: position of the mass centre, inertial axes [m]
  const T t24_2 = R24_23 * T(0.2);
  const T p24_3 = t23_2 + t24_2 + P24_3 + R24_33 * T(0.05);
  // Pdot24 = R23^T omega23~ q24 + Pdot23: velocity of the body origin, inertial axes [m/s]
  const T t24_3 = t23_8 - omega23_3 * T(1.2);
  const T t24_4 = omega23_3 * T(0.3) - omega23_1 * T(0.1);
  const T t24_5 = omega23_1 * T(1.2) - omega23_2 * T(0.3);
  const T Pdot24_1 = Pdot23_1 + R23_11 * t24_3 + R23_21 * t24_4 + R22_31 * t24_5;
  const T Pdot24_2 = Pdot23_2 + R23_12 * t24_3 + R23_22 * t24_4 + R22_32 * t24_5;
  const T Pdot24_3 = Pdot23_3 + R23_13 * t24_3 + R23_23 * t24_4 + R22_33 * t24_5;
  // v24 = R24^T omega24~ r24 + Pdot24: velocity of the mass centre, inertial axes [m/s]
  const T t24_6 = omega24_2 * T(0.05) - omega24_3 * T(0.2);
  const T t24_7 = omega24_3 * T(0.1) - omega24_1 * T(0.05);
  const T t24_8 = omega24_2 * T(0.1);
  const T t24_9 = omega24_1 * T(0.2) - t24_8;
  const T v24_1 = Pdot24_1 + R23_11 * t24_6 + R24_21 * t24_7 + R24_31 * t24_9;
  const T v24_2 = Pdot24_2 + R23_12 * t24_6 + R24_22 * t24_7 + R24_32 * t24_9;
  const T v24_3 = Pdot24_3 + R23_13 * t24_6 + R24_23 * t24_7 + R24_33 * t24_9;
  // T24 = 1/2 omega24 . (I24 omega24) + 1/2 m24 v24 . v24: kinetic energy [J]
  const T T24 = T(0.5) * (omega24_1 * (T(0.34) * omega24_1 + T(0.017) * omega24_2 + T(0.0102) * omega24_3) + omega24_2
      * (T(0.017) * omega24_1 + T(0.408) * omega24_2 - T(0.0136) * omega24_3) + omega24_3 * (T(0.0102) * omega24_1 -
      T(0.0136) * omega24_2 + T(0.272) * omega24_3)) + T(1.7) * (v24_1 * v24_1 + v24_2 * v24_2 + v24_3 * v24_3);

  // ---- body 25 (body_25) on body 24
  const T thetadot25 = y[24];
  // E25^T = Rot(b25, theta25): E takes components in the lower body to those in the body
  const T E25_11 = cosines[24];
  const T minus_E25_13 = sines[24];
  // R25^T = R24^T E25^T: R takes inertial components to body components
  const T R25_11 = R23_11 * E25_11 - R24_31 * minus_E25_13;
  const T R25_12 = R23_12 * E25_11 - R24_32 * minus_E25_13;
  const T R25_13 = R23_13 * E25_11 - R24_33 * minus_E25_13;
  const T R25_31 = R23_11 * minus_E25_13 + R24_31 * E25_11;
  const T R25_32 = R23_12 * minus_E25_13 + R24_32 * E25_11;
  const T R25_33 = R23_13 * minus_E25_13 + R24_33 * E25_11;
  // omega25 = thetadot25 b25 + E25 omega24: absolute angular velocity, body axes [rad/s]
  const T omega25_1 = E25_11 * omega24_1 - minus_E25_13 * omega24_3;
  const T omega25_2 = thetadot25 + omega24_2;
  const T omega25_3 = minus_E25_13 * omega24_1 + E25_11 * omega24_3;
  // P25 = R24^T q25 + P24: position of the body origin, inertial axes [m]
  const T P25_3 = t24_1 + P24_3 + R24_23 * T(1.25) + R24_33 * T(0.1);
  // p25 = R25^T r25 + P25: position of the mass centre, inertial axes [m]
  const T t25_1 = R25_33 * T(0.05);
  const T p25_3 = t24_2 + t25_1 + P25_3 + R25_13 * T(0.1);
  // Pdot25 = R24^T omega24~ q25 + Pdot24: velocity of the body origin, inertial axes [m/s]
  const T t25_2 = t24_8 - omega24_3 * T(1.25);
  const T t25_3 = omega24_3 * T(0.3) - omega24_1 * T(0.1);
  const T t25_4 = omega24_1 * T(1.25) - omega24_2 * T(0.3);
  const T Pdot25_1 = Pdot24_1 + R23_11 * t25_2 + R24_21 * t25_3 + R24_31 * t25_4;
  const T Pdot25_2 = Pdot24_2 + R23_12 * t25_2 + R24_22 * t25_3 + R24_32 * t25_4;
  const T Pdot25_3 = Pdot24_3 + R23_13 * t25_2 + R24_23 * t25_3 + R24_33 * t25_4;
  // v25 = R25^T omega25~ r25 + Pdot25: velocity of the mass centre, inertial axes [m/s]
  const T t25_5 = omega25_2 * T(0.05) - omega25_3 * T(0.2);
  const T t25_6 = omega25_3 * T(0.1) - omega25_1 * T(0.05);
  const T t25_7 = omega25_2 * T(0.1);
  const T t25_8 = omega25_1 * T(0.2) - t25_7;
  const T v25_1 = Pdot25_1 + R25_11 * t25_5 + R24_21 * t25_6 + R25_31 * t25_8;
  const T v25_2 = Pdot25_2 + R25_12 * t25_5 + R24_22 * t25_6 + R25_32 * t25_8;
  const T v25_3 = Pdot25_3 + R25_13 * t25_5 + R24_23 * t25_6 + R25_33 * t25_8;
  // T25 = 1/2 omega25 . (I25 omega25) + 1/2 m25 v25 . v25: kinetic energy [J]
  const T T25 = T(0.5) * (omega25_1 * (T(0.35) * omega25_1 + T(0.0175) * omega25_2 + T(0.0105) * omega25_3) +
      omega25_2 * (T(0.0175) * omega25_1 + T(0.42) * omega25_2 - T(0.014) * omega25_3) + omega25_3 * (T(0.0105) *
      omega25_1 - T(0.014) * omega25_2 + T(0.28) * omega25_3)) + T(1.75) * (v25_1 * v25_1 + v25_2 * v25_2 + v25_3 *
      v25_3);

  // ---- body 26 (body_26) on body 25
  const T thetadot26 = y[25];
  // E26^T = Rot(b26, theta26): E takes components in the lower body to those in the body
  const T E26_11 = cosines[25];
  const T E26_12 = sines[25];
  // R26^T = R25^T E26^T: R takes inertial components to body components
  const T R26_11 = R25_11 * E26_11 + R24_21 * E26_12;
  const T R26_12 = R25_12 * E26_11 + R24_22 * E26_12;
  const T R26_13 = R25_13 * E26_11 + R24_23 * E26_12;
  const T R26_21 = R24_21 * E26_11 - R25_11 * E26_12;
  const T R26_22 = R24_22 * E26_11 - R25_12 * E26_12;
  const T R26_23 = R24_23 * E26_11 - R25_13 * E26_12;
  // omega26 = thetadot26 b26 + E26 omega25: absolute angular velocity, body axes [rad/s]
  const T omega26_1 = E26_11 * omega25_1 + E26_12 * omega25_2;
  const T omega26_2 = E26_11 * omega25_2 - E26_12 * omega25_1;
  const T omega26_3 = thetadot26 + omega25_3;
  // P26 = R25^T q26 + P25: position of the body origin, inertial axes [m]
  const T t26_1 = R25_33 * T(0.1);
  const T P26_3 = t26_1 + P25_3 + R25_13 * T(0.3) + R24_23 * T(1.3);
  // p26 = R26^T r26 + P26: position of the mass centre, inertial axes [m]
  const T t26_2 = R26_13 * T(0.1);
  const T p26_3 = t26_2 + t25_1 + P26_3 + R26_23 * T(0.2);
  // Pdot26 = R25^T omega25~ q26 + Pdot25: velocity of the body origin, inertial axes [m/s]
  const T t26_3 = t25_7 - omega25_3 * T(1.3);
  const T t26_4 = omega25_3 * T(0.3) - omega25_1 * T(0.1);
  const T t26_5 = omega25_1 * T(1.3) - omega25_2 * T(0.3);
  const T Pdot26_1 = Pdot25_1 + R25_11 * t26_3 + R24_21 * t26_4 + R25_31 * t26_5;
  const T Pdot26_2 = Pdot25_2 + R25_12 * t26_3 + R24_22 * t26_4 + R25_32 * t26_5;
  const T Pdot26_3 = Pdot25_3 + R25_13 * t26_3 + R24_23 * t26_4 + R25_33 * t26_5;
  // v26 = R26^T omega26~ r26 + Pdot26: velocity of the mass centre, inertial axes [m/s]
  const T t26_6 = omega26_2 * T(0.05) - omega26_3 * T(0.2);
  const T t26_7 = omega26_3 * T(0.1) - omega26_1 * T(0.05);
  const T t26_8 = omega26_2 * T(0.1);
  const T t26_9 = omega26_1 * T(0.2) - t26_8;
  const T v26_1 = Pdot26_1 + R26_11 * t26_6 + R26_21 * t26_7 + R25_31 * t26_9;
  const T v26_2 = Pdot26_2 + R26_12 * t26_6 + R26_22 * t26_7 + R25_32 * t26_9;
  const T v26_3 = Pdot26_3 + R26_13 * t26_6 + R26_23 * t26_7 + R25_33 * t26_9;
  // T26 = 1/2 omega26 . (I26 omega26) + 1/2 m26 v26 . v26: kinetic energy [J]
  const T T26 = T(0.5) * (omega26_1 * (T(0.36) * omega26_1 + T(0.018) * omega26_2 + T(0.0108) * omega26_3) + omega26_2
      * (T(0.018) * omega26_1 + T(0.432) * omega26_2 - T(0.0144) * omega26_3) + omega26_3 * (T(0.0108) * omega26_1 -
      T(0.0144) * omega26_2 + T(0.288) * omega26_3)) + T(1.8) * (v26_1 * v26_1 + v26_2 * v26_2 + v26_3 * v26_3);

  // ---- body 27 (body_27) on body 26
  const T thetadot27 = y[26];
  // E27^T = Rot(b27, theta27): E takes components in the lower body to those in the body
  const T E27_22 = cosines[26];
  const T E27_23 = sines[26];
  // R27^T = R26^T E27^T: R takes inertial components to body components
  const T R27_21 = R26_21 * E27_22 + R25_31 * E27_23;
  const T R27_22 = R26_22 * E27_22 + R25_32 * E27_23;
  const T R27_23 = R26_23 * E27_22 + R25_33 * E27_23;
  const T R27_31 = R25_31 * E27_22 - R26_21 * E27_23;
  const T R27_32 = R25_32 * E27_22 - R26_22 * E27_23;
  const T R27_33 = R25_33 * E27_22 - R26_23 * E27_23;
  // omega27 = thetadot27 b27 + E27 omega26: absolute angular velocity, body axes [rad/s]
  const T omega27_1 = thetadot27 + omega26_1;
  const T omega27_2 = E27_22 * omega26_2 + E27_23 * omega26_3;
  const T omega27_3 = E27_22 * omega26_3 - E27_23 * omega26_2;
  // P27 = R26^T q27 + P26: position of the body origin, inertial axes [m]
  const T t27_1 = R26_13 * T(0.3);
  const T P27_3 = t27_1 + t26_1 + P26_3 + R26_23 * T(1.35);
  // p27 = R27^T r27 + P27: position of the mass centre, inertial axes [m]
  const T t27_2 = R27_23 * T(0.2);
  const T p27_3 = t26_2 + t27_2 + P27_3 + R27_33 * T(0.05);
  // Pdot27 = R26^T omega26~ q27 + Pdot26: velocity of the body origin, inertial axes [m/s]
  const T t27_3 = t26_8 - omega26_3 * T(1.35);
  const T t27_4 = omega26_3 * T(0.3) - omega26_1 * T(0.1);
  const T t27_5 = omega26_1 * T(1.35) - omega26_2 * T(0.3);
  const T Pdot27_1 = Pdot26_1 + R26_11 * t27_3 + R26_21 * t27_4 + R25_31 * t27_5;
  const T Pdot27_2 = Pdot26_2 + R26_12 * t27_3 + R26_22 * t27_4 + R25_32 * t27_5;
  const T Pdot27_3 = Pdot26_3 + R26_13 * t27_3 + R26_23 * t27_4 + R25_33 * t27_5;
  // v27 = R27^T omega27~ r27 + Pdot27: velocity of the mass centre, inertial axes [m/s]
  const T t27_6 = omega27_2 * T(0.05) - omega27_3 * T(0.2);
  const T t27_7 = omega27_3 * T(0.1) - omega27_1 * T(0.05);
  const T t27_8 = omega27_2 * T(0.1);
  const T t27_9 = omega27_1 * T(0.2) - t27_8;
  const T v27_1 = Pdot27_1 + R26_11 * t27_6 + R27_21 * t27_7 + R27_31 * t27_9;
  const T v27_2 = Pdot27_2 + R26_12 * t27_6 + R27_22 * t27_7 + R27_32 * t27_9;
  const T v27_3 = Pdot27_3 + R26_13 * t27_6 + R27_23 * t27_7 + R27_33 * t27_9;
  // T27 = 1/2 omega27 . (I27 omega27) + 1/2 m27 v27 . v27: kinetic energy [J]
  const T T27 = T(0.5) * (omega27_1 * (T(0.37) * omega27_1 + T(0.0185) * omega27_2 + T(0.0111) * omega27_3) +
      omega27_2 * (T(0.0185) * omega27_1 + T(0.444) * omega27_2 - T(0.0148) * omega27_3) + omega27_3 * (T(0.0111) *
      omega27_1 - T(0.0148) * omega27_2 + T(0.296) * omega27_3)) + T(1.85) * (v27_1 * v27_1 + v27_2 * v27_2 + v27_3 *
      v27_3);

  // ---- body 28 (body_28) on body 27
  const T thetadot28 = y[27];
  // E28^T = Rot(b28, theta28): E takes components in the lower body to those in the body
  const T E28_11 = cosines[27];
  const T minus_E28_13 = sines[27];
  // R28^T = R27^T E28^T: R takes inertial components to body components
  const T R28_11 = R26_11 * E28_11 - R27_31 * minus_E28_13;
  const T R28_12 = R26_12 * E28_11 - R27_32 * minus_E28_13;
  const T R28_13 = R26_13 * E28_11 - R27_33 * minus_E28_13;
  const T R28_31 = R26_11 * minus_E28_13 + R27_31 * E28_11;
  const T R28_32 = R26_12 * minus_E28_13 + R27_32 * E28_11;
  const T R28_33 = R26_13 * minus_E28_13 + R27_33 * E28_11;
  // omega28 = thetadot28 b28 + E28 omega27: absolute angular velocity, body axes [rad/s]
  const T omega28_1 = E28_11 * omega27_1 - minus_E28_13 * omega27_3;
  const T omega28_2 = thetadot28 + omega27_2;
  const T omega28_3 = minus_E28_13 * omega27_1 + E28_11 * omega27_3;
  // P28 = R27^T q28 + P27: position of the body origin, inertial axes [m]
  const T P28_3 = t27_1 + P27_3 + R27_23 * T(1.4) + R27_33 * T(0.1);
  // p28 = R28^T r28 + P28: position of the mass centre, inertial axes [m]
  const T t28_1 = R28_33 * T(0.05);
  const T p28_3 = t27_2 + t28_1 + P28_3 + R28_13 * T(0.1);
  // Pdot28 = R27^T omega27~ q28 + Pdot27: velocity of the body origin, inertial axes [m/s]
  const T t28_2 = t27_8 - omega27_3 * T(1.4);
  const T t28_3 = omega27_3 * T(0.3) - omega27_1 * T(0.1);
  const T t28_4 = omega27_1 * T(1.4) - omega27_2 * T(0.3);
  const T Pdot28_1 = Pdot27_1 + R26_11 * t28_2 + R27_21 * t28_3 + R27_31 * t28_4;
  const T Pdot28_2 = Pdot27_2 + R26_12 * t28_2 + R27_22 * t28_3 + R27_32 * t28_4;
  const T Pdot28_3 = Pdot27_3 + R26_13 * t28_2 + R27_23 * t28_3 + R27_33 * t28_4;
  // v28 = R28^T omega28~ r28 + Pdot28: velocity of the mass centre, inertial axes [m/s]
  const T t28_5 = omega28_2 * T(0.05) - omega28_3 * T(0.2);
  const T t28_6 = omega28_3 * T(0.1) - omega28_1 * T(0.05);
  const T t28_7 = omega28_2 * T(0.1);
  const T t28_8 = omega28_1 * T(0.2) - t28_7;
  const T v28_1 = Pdot28_1 + R28_11 * t28_5 + R27_21 * t28_6 + R28_31 * t28_8;
  const T v28_2 = Pdot28_2 + R28_12 * t28_5 + R27_22 * t28_6 + R28_32 * t28_8;
  const T v28_3 = Pdot28_3 + R28_13 * t28_5 + R27_23 * t28_6 + R28_33 * t28_8;
  // T28 = 1/2 omega28 . (I28 omega28) + 1/2 m28 v28 . v28: kinetic energy [J]
  const T T28 = T(0.5) * (omega28_1 * (T(0.38) * omega28_1 + T(0.019) * omega28_2 + T(0.0114) * omega28_3) + omega28_2
      * (T(0.019) * omega28_1 + T(0.456) * omega28_2 - T(0.0152) * omega28_3) + omega28_3 * (T(0.0114) * omega28_1 -
      T(0.0152) * omega28_2 + T(0.304) * omega28_3)) + T(1.9) * (v28_1 * v28_1 + v28_2 * v28_2 + v28_3 * v28_3);

  // ---- body 29 (body_29) on body 28
  const T thetadot29 = y[28];
  // E29^T = Rot(b29, theta29): E takes components in the lower body to those in the body
  const T E29_11 = cosines[28];
  const T E29_12 = sines[28];
  // R29^T = R28^T E29^T: R takes inertial components to body components
  const T R29_11 = R28_11 * E29_11 + R27_21 * E29_12;
  const T R29_12 = R28_12 * E29_11 + R27_22 * E29_12;
  const T R29_13 = R28_13 * E29_11 + R27_23 * E29_12;
  const T R29_21 = R27_21 * E29_11 - R28_11 * E29_12;
  const T R29_22 = R27_22 * E29_11 - R28_12 * E29_12;
  const T R29_23 = R27_23 * E29_11 - R28_13 * E29_12;
  // omega29 = thetadot29 b29 + E29 omega28: absolute angular velocity, body axes [rad/s]
  const T omega29_1 = E29_11 * omega28_1 + E29_12 * omega28_2;
  const T omega29_2 = E29_11 * omega28_2 - E29_12 * omega28_1;
  const T omega29_3 = thetadot29 + omega28_3;
  // P29 = R28^T q29 + P28: position of the body origin, inertial axes [m]
  const T t29_1 = R28_33 * T(0.1);
  const T P29_3 = t29_1 + P28_3 + R28_13 * T(0.3) + R27_23 * T(1.45);
  // p29 = R29^T r29 + P29: position of the mass centre, inertial axes [m]
  const T t29_2 = R29_13 * T(0.1);
  const T p29_3 = t29_2 + t28_1 + P29_3 + R29_23 * T(0.2);
  // Pdot29 = R28^T omega28~ q29 + Pdot28: velocity of the body origin, inertial axes [m/s]
  const T t29_3 = t28_7 - omega28_3 * T(1.45);
  const T t29_4 = omega28_3 * T(0.3) - omega28_1 * T(0.1);
  const T t29_5 = omega28_1 * T(1.45) - omega28_2 * T(0.3);
  const T Pdot29_1 = Pdot28_1 + R28_11 * t29_3 + R27_21 * t29_4 + R28_31 * t29_5;
  const T Pdot29_2 = Pdot28_2 + R28_12 * t29_3 + R27_22 * t29_4 + R28_32 * t29_5;
  const T Pdot29_3 = Pdot28_3 + R28_13 * t29_3 + R27_23 * t29_4 + R28_33 * t29_5;
  // v29 = R29^T omega29~ r29 + Pdot29: velocity of the mass centre, inertial axes [m/s]
  const T t29_6 = omega29_2 * T(0.05) - omega29_3 * T(0.2);
  const T t29_7 = omega29_3 * T(0.1) - omega29_1 * T(0.05);
  const T t29_8 = omega29_2 * T(0.1);
  const T t29_9 = omega29_1 * T(0.2) - t29_8;
  const T v29_1 = Pdot29_1 + R29_11 * t29_6 + R29_21 * t29_7 + R28_31 * t29_9;
  const T v29_2 = Pdot29_2 + R29_12 * t29_6 + R29_22 * t29_7 + R28_32 * t29_9;
  const T v29_3 = Pdot29_3 + R29_13 * t29_6 + R29_23 * t29_7 + R28_33 * t29_9;
  // T29 = 1/2 omega29 . (I29 omega29) + 1/2 m29 v29 . v29: kinetic energy [J]
  const T T29 = T(0.5) * (omega29_1 * (T(0.39) * omega29_1 + T(0.0195) * omega29_2 + T(0.0117) * omega29_3) +
      omega29_2 * (T(0.0195) * omega29_1 + T(0.468) * omega29_2 - T(0.0156) * omega29_3) + omega29_3 * (T(0.0117) *
      omega29_1 - T(0.0156) * omega29_2 + T(0.312) * omega29_3)) + T(1.95) * (v29_1 * v29_1 + v29_2 * v29_2 + v29_3 *
      v29_3);

  // ---- body 30 (body_30) on body 29
  const T thetadot30 = y[29];
  // E30^T = Rot(b30, theta30): E takes components in the lower body to those in the body
  const T E30_22 = cosines[29];
  const T E30_23 = sines[29];
  // R30^T = R29^T E30^T: R takes inertial components to body components
  const T R30_21 = R29_21 * E30_22 + R28_31 * E30_23;
  const T R30_22 = R29_22 * E30_22 + R28_32 * E30_23;
  const T R30_23 = R29_23 * E30_22 + R28_33 * E30_23;
  const T R30_31 = R28_31 * E30_22 - R29_21 * E30_23;
  const T R30_32 = R28_32 * E30_22 - R29_22 * E30_23;
  const T R30_33 = R28_33 * E30_22 - R29_23 * E30_23;
  // omega30 = thetadot30 b30 + E30 omega29: absolute angular velocity, body axes [rad/s]
  const T omega30_1 = thetadot30 + omega29_1;
  const T omega30_2 = E30_22 * omega29_2 + E30_23 * omega29_3;
  const T omega30_3 = E30_22 * omega29_3 - E30_23 * omega29_2;
  // P30 = R29^T q30 + P29: position of the body origin, inertial axes [m]
  const T t30_1 = R29_13 * T(0.3);
  const T P30_3 = t30_1 + t29_1 + P29_3 + R29_23 * T(1.5);
  // p30 = R30^T r30 + P30: position of the mass centre, inertial axes [m]
  const T t30_2 = R30_23 * T(0.2);
  const T p30_3 = t29_2 + t30_2 + P30_3 + R30_33 * T(0.05);
  // Pdot30 = R29^T omega29~ q30 + Pdot29: velocity of the body origin, inertial axes [m/s]
  const T t30_3 = t29_8 - omega29_3 * T(1.5);
  const T t30_4 = omega29_3 * T(0.3) - omega29_1 * T(0.1);
  const T t30_5 = omega29_1 * T(1.5) - omega29_2 * T(0.3);
  const T Pdot30_1 = Pdot29_1 + R29_11 * t30_3 + R29_21 * t30_4 + R28_31 * t30_5;
  const T Pdot30_2 = Pdot29_2 + R29_12 * t30_3 + R29_22 * t30_4 + R28_32 * t30_5;
  const T Pdot30_3 = Pdot29_3 + R29_13 * t30_3 + R29_23 * t30_4 + R28_33 * t30_5;
  // v30 = R30^T omega30~ r30 + Pdot30: velocity of the mass centre, inertial axes [m/s]
  const T t30_6 = omega30_2 * T(0.05) - omega30_3 * T(0.2);
  const T t30_7 = omega30_3 * T(0.1) - omega30_1 * T(0.05);
  const T t30_8 = omega30_2 * T(0.1);
  const T t30_9 = omega30_1 * T(0.2) - t30_8;
  const T v30_1 = Pdot30_1 + R29_11 * t30_6 + R30_21 * t30_7 + R30_31 * t30_9;
  const T v30_2 = Pdot30_2 + R29_12 * t30_6 + R30_22 * t30_7 + R30_32 * t30_9;
  const T v30_3 = Pdot30_3 + R29_13 * t30_6 + R30_23 * t30_7 + R30_33 * t30_9;
  // T30 = 1/2 omega30 . (I30 omega30) + 1/2 m30 v30 . v30: kinetic energy [J]
  const T T30 = T(0.5) * (omega30_1 * (T(0.4) * omega30_1 + T(0.02) * omega30_2 + T(0.012) * omega30_3) + omega30_2 *
      (T(0.02) * omega30_1 + T(0.48) * omega30_2 - T(0.016) * omega30_3) + omega30_3 * (T(0.012) * omega30_1 -
      T(0.016) * omega30_2 + T(0.32) * omega30_3)) + T(2) * (v30_1 * v30_1 + v30_2 * v30_2 + v30_3 * v30_3);

  // ---- body 31 (body_31) on body 30
  const T thetadot31 = y[30];
  // E31^T = Rot(b31, theta31): E takes components in the lower body to those in the body
  const T E31_11 = cosines[30];
  const T minus_E31_13 = sines[30];
  // R31^T = R30^T E31^T: R takes inertial components to body components
  const T R31_11 = R29_11 * E31_11 - R30_31 * minus_E31_13;
  const T R31_12 = R29_12 * E31_11 - R30_32 * minus_E31_13;
  const T R31_13 = R29_13 * E31_11 - R30_33 * minus_E31_13;
  const T R31_31 = R29_11 * minus_E31_13 + R30_31 * E31_11;
  const T R31_32 = R29_12 * minus_E31_13 + R30_32 * E31_11;
  const T R31_33 = R29_13 * minus_E31_13 + R30_33 * E31_11;
  // omega31 = thetadot31 b31 + E31 omega30: absolute angular velocity, body axes [rad/s]
  const T omega31_1 = E31_11 * omega30_1 - minus_E31_13 * omega30_3;
  const T omega31_2 = thetadot31 + omega30_2;
  const T omega31_3 = minus_E31_13 * omega30_1 + E31_11 * omega30_3;
  // P31 = R30^T q31 + P30: position of the body origin, inertial axes [m]
  const T P31_3 = t30_1 + P30_3 + R30_23 * T(1.55) + R30_33 * T(0.1);
  // p31 = R31^T r31 + P31: position of the mass centre, inertial axes [m]
  const T t31_1 = R31_33 * T(0.05);
  const T p31_3 = t30_2 + t31_1 + P31_3 + R31_13 * T(0.1);
  // Pdot31 = R30^T omega30~ q31 + Pdot30: velocity of the body origin, inertial axes [m/s]
  const T t31_2 = t30_8 - omega30_3 * T(1.55);
  const T t31_3 = omega30_3 * T(0.3) - omega30_1 * T(0.1);
  const T t31_4 = omega30_1 * T(1.55) - omega30_2 * T(0.3);
  const T Pdot31_1 = Pdot30_1 + R29_11 * t31_2 + R30_21 * t31_3 + R30_31 * t31_4;
  const T Pdot31_2 = Pdot30_2 + R29_12 * t31_2 + R30_22 * t31_3 + R30_32 * t31_4;
  const T Pdot31_3 = Pdot30_3 + R29_13 * t31_2 + R30_23 * t31_3 + R30_33 * t31_4;
  // v31 = R31^T omega31~ r31 + Pdot31: velocity of the mass centre, inertial axes [m/s]
  const T t31_5 = omega31_2 * T(0.05) - omega31_3 * T(0.2);
  const T t31_6 = omega31_3 * T(0.1) - omega31_1 * T(0.05);
  const T t31_7 = omega31_2 * T(0.1);
  const T t31_8 = omega31_1 * T(0.2) - t31_7;
  const T v31_1 = Pdot31_1 + R31_11 * t31_5 + R30_21 * t31_6 + R31_31 * t31_8;
  const T v31_2 = Pdot31_2 + R31_12 * t31_5 + R30_22 * t31_6 + R31_32 * t31_8;
  const T v31_3 = Pdot31_3 + R31_13 * t31_5 + R30_23 * t31_6 + R31_33 * t31_8;
  // T31 = 1/2 omega31 . (I31 omega31) + 1/2 m31 v31 . v31: kinetic energy [J]
  const T T31 = T(0.5) * (omega31_1 * (T(0.41) * omega31_1 + T(0.0205) * omega31_2 + T(0.0123) * omega31_3) +
      omega31_2 * (T(0.0205) * omega31_1 + T(0.492) * omega31_2 - T(0.0164) * omega31_3) + omega31_3 * (T(0.0123) *
      omega31_1 - T(0.0164) * omega31_2 + T(0.328) * omega31_3)) + T(2.05) * (v31_1 * v31_1 + v31_2 * v31_2 + v31_3 *
      v31_3);

  // ---- body 32 (body_32) on body 31
  const T thetadot32 = y[31];
  // E32^T = Rot(b32, theta32): E takes components in the lower body to those in the body
  const T E32_11 = cosines[31];
  const T E32_12 = sines[31];
  // R32^T = R31^T E32^T: R takes inertial components to body components
  const T R32_11 = R31_11 * E32_11 + R30_21 * E32_12;
  const T R32_12 = R31_12 * E32_11 + R30_22 * E32_12;
  const T R32_13 = R31_13 * E32_11 + R30_23 * E32_12;
  const T R32_21 = R30_21 * E32_11 - R31_11 * E32_12;
  const T R32_22 = R30_22 * E32_11 - R31_12 * E32_12;
  const T R32_23 = R30_23 * E32_11 - R31_13 * E32_12;
  // omega32 = thetadot32 b32 + E32 omega31: absolute angular velocity, body axes [rad/s]
  const T omega32_1 = E32_11 * omega31_1 + E32_12 * omega31_2;
  const T omega32_2 = E32_11 * omega31_2 - E32_12 * omega31_1;
  const T omega32_3 = thetadot32 + omega31_3;
  // P32 = R31^T q32 + P31: position of the body origin, inertial axes [m]
  const T P32_3 = P31_3 + R31_13 * T(0.3) + R30_23 * T(1.6) + R31_33 * T(0.1);
  // p32 = R32^T r32 + P32: position of the mass centre, inertial axes [m]
  const T p32_3 = t31_1 + P32_3 + R32_13 * T(0.1) + R32_23 * T(0.2);
  // Pdot32 = R31^T omega31~ q32 + Pdot31: velocity of the body origin, inertial axes [m/s]
  const T t32_1 = t31_7 - omega31_3 * T(1.6);
  const T t32_2 = omega31_3 * T(0.3) - omega31_1 * T(0.1);
  const T t32_3 = omega31_1 * T(1.6) - omega31_2 * T(0.3);
  const T Pdot32_1 = Pdot31_1 + R31_11 * t32_1 + R30_21 * t32_2 + R31_31 * t32_3;
  const T Pdot32_2 = Pdot31_2 + R31_12 * t32_1 + R30_22 * t32_2 + R31_32 * t32_3;
  const T Pdot32_3 = Pdot31_3 + R31_13 * t32_1 + R30_23 * t32_2 + R31_33 * t32_3;
  // v32 = R32^T omega32~ r32 + Pdot32: velocity of the mass centre, inertial axes [m/s]
  const T t32_4 = omega32_2 * T(0.05) - omega32_3 * T(0.2);
  const T t32_5 = omega32_3 * T(0.1) - omega32_1 * T(0.05);
  const T t32_6 = omega32_1 * T(0.2) - omega32_2 * T(0.1);
  const T v32_1 = Pdot32_1 + R32_11 * t32_4 + R32_21 * t32_5 + R31_31 * t32_6;
  const T v32_2 = Pdot32_2 + R32_12 * t32_4 + R32_22 * t32_5 + R31_32 * t32_6;
  const T v32_3 = Pdot32_3 + R32_13 * t32_4 + R32_23 * t32_5 + R31_33 * t32_6;
  // T32 = 1/2 omega32 . (I32 omega32) + 1/2 m32 v32 . v32: kinetic energy [J]
  const T T32 = T(0.5) * (omega32_1 * (T(0.42) * omega32_1 + T(0.021) * omega32_2 + T(0.0126) * omega32_3) + omega32_2
      * (T(0.021) * omega32_1 + T(0.504) * omega32_2 - T(0.0168) * omega32_3) + omega32_3 * (T(0.0126) * omega32_1 -
      T(0.0168) * omega32_2 + T(0.336) * omega32_3)) + T(2.1) * (v32_1 * v32_1 + v32_2 * v32_2 + v32_3 * v32_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12 + T13 + T14 + T15 + T16 + T17 + T18 + T19
  //   + T20 + T21 + T22 + T23 + T24 + T25 + T26 + T27 + T28 + T29 + T30 + T31 + T32: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12 + T13 + T14 + T15 + T16 + T17 + T18 +
      T19 + T20 + T21 + T22 + T23 + T24 + T25 + T26 + T27 + T28 + T29 + T30 + T31 + T32;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6 + m7 p7 + m8 p8 + m9 p9 + m10 p10 + m11 p11 + m12 p12 + m13
  //   p13 + m14 p14 + m15 p15 + m16 p16 + m17 p17 + m18 p18 + m19 p19 + m20 p20 + m21 p21 + m22 p22 + m23 p23 + m24
  //   p24 + m25 p25 + m26 p26 + m27 p27 + m28 p28 + m29 p29 + m30 p30 + m31 p31 + m32 p32: first moment of mass,
  //   inertial axes [kg m]
  const T mp_3 = T(1.1) * p1_3 + T(1.2) * p2_3 + T(1.3) * p3_3 + T(1.4) * p4_3 + T(1.5) * p5_3 + T(1.6) * p6_3 +
      T(1.7) * p7_3 + T(1.8) * p8_3 + T(1.9) * p9_3 + T(2) * p10_3 + T(2.1) * p11_3 + T(2.2) * p12_3 + T(2.3) * p13_3
      + T(2.4) * p14_3 + T(2.5) * p15_3 + T(2.6) * p16_3 + T(2.7) * p17_3 + T(2.8) * p18_3 + T(2.9) * p19_3 + T(3) *
      p20_3 + T(3.1) * p21_3 + T(3.2) * p22_3 + T(3.3) * p23_3 + T(3.4) * p24_3 + T(3.5) * p25_3 + T(3.6) * p26_3 +
      T(3.7) * p27_3 + T(3.8) * p28_3 + T(3.9) * p29_3 + T(4) * p30_3 + T(4.1) * p31_3 + T(4.2) * p32_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 4500 add, 4709 multiply, 31 divide, 64 sine or cosine
// by: articulated; composite would take 12767 add, 14832 multiply, 31 divide, 64 sine or cosine
namespace accelerations_sections {

// Results of a body's sections that others read, by their place in the body's frame; fields that no body has both
// of may share one. K, L and J in tables: where the frames of a body, of its lower and of an upper one begin.
namespace frame {
inline constexpr int minus_U_11 = 31, Pddot_1 = 2, Pddot_3 = 6, N_2 = 0, E_11 = 32, E_12 = 31, omega_1 = 7, omega_2 =
    8, omegadot_1 = 36, minus_omegadot_2 = 41, U_12 = 37, minus_U_22 = 38, U_32 = 39, minus_U_33 = 40, minus_Pddot_2 =
    6, G_3 = 3, N_1 = 4, N_3 = 5, E_22 = 32, E_23 = 38, omega_3 = 15, omegadot_2 = 39, omegadot_3 = 41, U_13 = 57,
    U_21 = 42, U_23 = 58, U_31 = 43, Pddot_2 = 16, G_1 = 9, G_2 = 10, minus_E_13 = 33, v = 1, minus_Mp_11 = 29, Mp_12
    = 17, Mp_22 = 59, gp_1 = 44, gp_2 = 45, minus_Hp_11 = 2, Hp_12 = 40, Hp_13 = 42, Hp_21 = 36, Hp_22 = 37, Hp_23 =
    33, Jp_11 = 46, Jp_12 = 43, Jp_22 = 34, np_1 = 47, np_2 = 35, Hb_31 = 11, Hb_32 = 18, kB_1 = 19, kB_2 = 20, kB_3 =
    12, kK_1 = 48, kK_3 = 49, M_22 = 34, gt_2 = 35, Mp_13 = 27, minus_Mp_23 = 30, Mp_33 = 50, gp_3 = 51, Hp_31 = 52,
    Hp_32 = 53, minus_Hp_33 = 57, Jp_13 = 45, Jp_33 = 54, np_3 = 55, Hb_11 = 21, Hb_12 = 22, Hb_13 = 23, Hb_21 = 24,
    Hb_22 = 28, Hb_23 = 13, minus_Hb_33 = 58, kK_2 = 56, M_11 = 47, gt_1 = 44, Mp_23 = 30, Hp_33 = 60, Jp_23 = 46,
    Hb_33 = 29, M_33 = 50, gt_3 = 49, Mp_11 = 61, beta_3 = 14, alphaL_1 = 62, alphaL_2 = 63, minus_phi = 64, beta_1 =
    25, beta_2 = 26, minus_alphaL_3 = 48, phi = 64, alphaL_3 = 65, minus_alphaL_2 = 51, minus_alphaL_1 = 56;
}  // namespace frame

// how constants stand in tables
template <class T>
struct Constants {
  using Number = double;
};
template <>
struct Constants<float> {
  using Number = float;
};
template <class T>
using Number = typename Constants<T>::Number;

inline constexpr unsigned short outward_4_places[10][5] = {  // L, J, K, y_at, x_at
    {97, 32, 162, 3, 3},
    {293, 228, 359, 6, 6},
    {490, 425, 555, 9, 9},
    {686, 621, 752, 12, 12},
    {883, 818, 948, 15, 15},
    {1079, 1014, 1145, 18, 18},
    {1276, 1211, 1341, 21, 21},
    {1472, 1407, 1538, 24, 24},
    {1669, 1604, 1734, 27, 27},
    {1865, 1800, 1931, 30, 30},
};
template <class C>
inline constexpr C outward_4_numbers[10][14] = {
    {C(0.59), C(-0.295), C(-0.59), C(0.295), C(-0.13485), C(0.34525), C(0.219), C(-0.2515), C(0.0703), C(-0.34525),
     C(0.2515), C(0.13485), C(-0.0703), C(-0.219)},
    {C(0.71), C(-0.35500000000000004), C(-0.71), C(0.35500000000000004), C(-0.25605), C(0.41575), C(0.264), C(-0.49),
     C(0.0844), C(-0.41575), C(0.49), C(0.25605), C(-0.0844), C(-0.264)},
    {C(0.83), C(-0.41500000000000004), C(-0.83), C(0.41500000000000004), C(-0.40875000000000006), C(0.48625),
     C(0.309), C(-0.7915000000000001), C(0.0985), C(-0.48625), C(0.7915000000000001), C(0.40875000000000006),
     C(-0.0985), C(-0.309)},
    {C(0.95), C(-0.475), C(-0.95), C(0.475), C(-0.59295), C(0.55675), C(0.354), C(-1.156), C(0.11259999999999999),
     C(-0.55675), C(1.156), C(0.59295), C(-0.11259999999999999), C(-0.354)},
    {C(1.07), C(-0.535), C(-1.07), C(0.535), C(-0.8086500000000001), C(0.6272500000000001), C(0.39899999999999997),
     C(-1.5835000000000001), C(0.1267), C(-0.6272500000000001), C(1.5835000000000001), C(0.8086500000000001),
     C(-0.1267), C(-0.39899999999999997)},
    {C(1.19), C(-0.595), C(-1.19), C(0.595), C(-1.05585), C(0.69775), C(0.444), C(-2.074), C(0.1408), C(-0.69775),
     C(2.074), C(1.05585), C(-0.1408), C(-0.444)},
    {C(1.31), C(-0.655), C(-1.31), C(0.655), C(-1.3345500000000001), C(0.76825), C(0.489), C(-2.6275), C(0.1549),
     C(-0.76825), C(2.6275), C(1.3345500000000001), C(-0.1549), C(-0.489)},
    {C(1.43), C(-0.7150000000000001), C(-1.43), C(0.7150000000000001), C(-1.6447500000000002), C(0.83875), C(0.534),
     C(-3.244), C(0.169), C(-0.83875), C(3.244), C(1.6447500000000002), C(-0.169), C(-0.534)},
    {C(1.5499999999999998), C(-0.775), C(-1.5499999999999998), C(0.775), C(-1.98645), C(0.90925), C(0.579),
     C(-3.9234999999999998), C(0.1831), C(-0.90925), C(3.9234999999999998), C(1.98645), C(-0.1831), C(-0.579)},
    {C(1.67), C(-0.8350000000000001), C(-1.67), C(0.8350000000000001), C(-2.3596500000000002), C(0.89575), C(0.624),
     C(-4.666), C(0.19720000000000004), C(-0.89575), C(4.666), C(2.3596500000000002), C(-0.19720000000000004),
     C(-0.624)},
};
inline constexpr unsigned short outward_5_places[9][5] = {  // L, J, K, y_at, x_at
    {162, 97, 228, 4, 4},
    {359, 293, 425, 7, 7},
    {555, 490, 621, 10, 10},
    {752, 686, 818, 13, 13},
    {948, 883, 1014, 16, 16},
    {1145, 1079, 1211, 19, 19},
    {1341, 1276, 1407, 22, 22},
    {1538, 1472, 1604, 25, 25},
    {1734, 1669, 1800, 28, 28},
};
template <class C>
inline constexpr C outward_5_numbers[9][16] = {
    {C(0.45), C(-0.45), C(0.15000000000000002), C(-0.30000000000000004), C(0.30000000000000004),
     C(-0.15000000000000002), C(-0.051000000000000004), C(-0.10500000000000001), C(-0.022500000000000003),
     C(0.018000000000000002), C(0.10500000000000001), C(0.09), C(0.022500000000000003), C(0.051000000000000004),
     C(-0.09), C(-0.018000000000000002)},
    {C(0.75), C(-0.75), C(0.18000000000000002), C(-0.36000000000000004), C(0.36000000000000004),
     C(-0.18000000000000002), C(-0.061200000000000004), C(-0.126), C(-0.027000000000000007), C(0.021600000000000005),
     C(0.126), C(0.108), C(0.027000000000000007), C(0.061200000000000004), C(-0.108), C(-0.021600000000000005)},
    {C(1.05), C(-1.05), C(0.21000000000000002), C(-0.42000000000000004), C(0.42000000000000004),
     C(-0.21000000000000002), C(-0.0714), C(-0.14700000000000002), C(-0.03150000000000001), C(0.025200000000000004),
     C(0.14700000000000002), C(0.126), C(0.03150000000000001), C(0.0714), C(-0.126), C(-0.025200000000000004)},
    {C(1.35), C(-1.35), C(0.24), C(-0.48), C(0.48), C(-0.24), C(-0.0816), C(-0.168), C(-0.036000000000000004),
     C(0.028800000000000003), C(0.168), C(0.144), C(0.036000000000000004), C(0.0816), C(-0.144),
     C(-0.028800000000000003)},
    {C(1.65), C(-1.65), C(0.27), C(-0.54), C(0.54), C(-0.27), C(-0.09180000000000002), C(-0.18900000000000003),
     C(-0.04050000000000001), C(0.032400000000000005), C(0.18900000000000003), C(0.162), C(0.04050000000000001),
     C(0.09180000000000002), C(-0.162), C(-0.032400000000000005)},
    {C(1.95), C(-1.95), C(0.30000000000000004), C(-0.6000000000000001), C(0.6000000000000001),
     C(-0.30000000000000004), C(-0.10200000000000001), C(-0.21000000000000002), C(-0.045000000000000005),
     C(0.036000000000000004), C(0.21000000000000002), C(0.18), C(0.045000000000000005), C(0.10200000000000001),
     C(-0.18), C(-0.036000000000000004)},
    {C(2.25), C(-2.25), C(0.33), C(-0.66), C(0.66), C(-0.33), C(-0.11220000000000001), C(-0.231), C(-0.0495),
     C(0.0396), C(0.231), C(0.198), C(0.0495), C(0.11220000000000001), C(-0.198), C(-0.0396)},
    {C(2.55), C(-2.55), C(0.36000000000000004), C(-0.7200000000000001), C(0.7200000000000001),
     C(-0.36000000000000004), C(-0.12240000000000001), C(-0.252), C(-0.05400000000000001), C(0.04320000000000001),
     C(0.252), C(0.216), C(0.05400000000000001), C(0.12240000000000001), C(-0.216), C(-0.04320000000000001)},
    {C(2.8499999999999996), C(-2.8499999999999996), C(0.39), C(-0.78), C(0.78), C(-0.39), C(-0.13260000000000002),
     C(-0.273), C(-0.05850000000000001), C(0.04680000000000001), C(0.273), C(0.234), C(0.05850000000000001),
     C(0.13260000000000002), C(-0.234), C(-0.04680000000000001)},
};
inline constexpr unsigned short outward_6_places[9][5] = {  // L, J, K, y_at, x_at
    {228, 162, 293, 5, 5},
    {425, 359, 490, 8, 8},
    {621, 555, 686, 11, 11},
    {818, 752, 883, 14, 14},
    {1014, 948, 1079, 17, 17},
    {1211, 1145, 1276, 20, 20},
    {1407, 1341, 1472, 23, 23},
    {1604, 1538, 1669, 26, 26},
    {1800, 1734, 1865, 29, 29},
};
template <class C>
inline constexpr C outward_6_numbers[9][21] = {
    {C(0.3), C(-0.3), C(-5.1), C(-2.605), C(2.7399999999999998), C(-0.43000000000000005), C(2.605),
     C(-2.7399999999999998), C(0.43000000000000005), C(0.2372), C(-1.4909999999999999), C(-0.2509), C(0.151),
     C(-1.95375), C(1.5959999999999999), C(-0.151), C(1.4909999999999999), C(0.2509), C(-1.5959999999999999),
     C(1.95375), C(-0.2372)},
    {C(0.45), C(-0.45), C(-6), C(-3.9850000000000003), C(3.2199999999999998), C(-0.505), C(3.9850000000000003),
     C(-3.2199999999999998), C(0.505), C(0.2783), C(-2.3055), C(-0.38710000000000006), C(0.17875000000000002),
     C(-3.7972500000000005), C(1.875), C(-0.17875000000000002), C(2.3055), C(0.38710000000000006), C(-1.875),
     C(3.7972500000000005), C(-0.2783)},
    {C(0.6), C(-0.6), C(-6.9), C(-5.635), C(3.6999999999999997), C(-0.58), C(5.635), C(-3.6999999999999997), C(0.58),
     C(0.3194), C(-3.2819999999999996), C(-0.5503), C(0.20650000000000002), C(-6.612749999999999), C(2.154),
     C(-0.20650000000000002), C(3.2819999999999996), C(0.5503), C(-2.154), C(6.612749999999999), C(-0.3194)},
    {C(0.75), C(-0.75), C(-7.800000000000001), C(-7.555000000000001), C(4.18), C(-0.655), C(7.555000000000001),
     C(-4.18), C(0.655), C(0.36050000000000004), C(-4.4205000000000005), C(-0.7405), C(0.23424999999999999),
     C(-10.60275), C(2.433), C(-0.23424999999999999), C(4.4205000000000005), C(0.7405), C(-2.433), C(10.60275),
     C(-0.36050000000000004)},
    {C(0.9), C(-0.9), C(-8.7), C(-9.745), C(4.66), C(-0.73), C(9.745), C(-4.66), C(0.73), C(0.4016),
     C(-5.720999999999999), C(-0.9577), C(0.262), C(-15.96975), C(2.7119999999999997), C(-0.262),
     C(5.720999999999999), C(0.9577), C(-2.7119999999999997), C(15.96975), C(-0.4016)},
    {C(1.05), C(-1.05), C(-9.6), C(-12.205), C(5.14), C(-0.805), C(12.205), C(-5.14), C(0.805),
     C(0.44270000000000004), C(-7.1834999999999996), C(-1.2019000000000002), C(0.28975), C(-22.91625),
     C(2.9909999999999997), C(-0.28975), C(7.1834999999999996), C(1.2019000000000002), C(-2.9909999999999997),
     C(22.91625), C(-0.44270000000000004)},
    {C(1.2), C(-1.2), C(-10.5), C(-14.935), C(5.62), C(-0.88), C(14.935), C(-5.62), C(0.88), C(0.4838), C(-8.808),
     C(-1.4731), C(0.3175), C(-31.644750000000002), C(3.27), C(-0.3175), C(8.808), C(1.4731), C(-3.27),
     C(31.644750000000002), C(-0.4838)},
    {C(1.35), C(-1.35), C(-11.4), C(-17.935), C(6.1), C(-0.9550000000000001), C(17.935), C(-6.1),
     C(0.9550000000000001), C(0.5249), C(-10.594499999999998), C(-1.7712999999999999), C(0.34525),
     C(-42.357749999999996), C(3.5489999999999995), C(-0.34525), C(10.594499999999998), C(1.7712999999999999),
     C(-3.5489999999999995), C(42.357749999999996), C(-0.5249)},
    {C(1.5), C(-1.5), C(-12.3), C(-21.205000000000002), C(6.58), C(-1.03), C(21.205000000000002), C(-6.58), C(1.03),
     C(0.566), C(-12.543), C(-2.0965000000000003), C(0.373), C(-55.25775000000001), C(3.828), C(-0.373), C(12.543),
     C(2.0965000000000003), C(-3.828), C(55.25775000000001), C(-0.566)},
};
inline constexpr unsigned short inward_4_places[9][3] = {  // J, K, u_at
    {1865, 1800, 0},
    {1669, 1604, 1},
    {1472, 1407, 2},
    {1276, 1211, 3},
    {1079, 1014, 4},
    {883, 818, 5},
    {686, 621, 6},
    {490, 425, 7},
    {293, 228, 8},
};
template <class C>
inline constexpr C inward_4_numbers[9][13] = {
    {C(0.78), C(-0.39), C(-0.78), C(0.39), C(1.5), C(-0.05850000000000001), C(-1.5), C(-0.04680000000000001),
     C(-0.039), C(-0.13260000000000002), C(0.507), C(-2.8499999999999996), C(2.8499999999999996)},
    {C(0.7200000000000001), C(-0.36000000000000004), C(-0.7200000000000001), C(0.36000000000000004), C(1.35),
     C(-0.05400000000000001), C(-1.35), C(-0.04320000000000001), C(-0.036000000000000004), C(-0.12240000000000001),
     C(0.468), C(-2.55), C(2.55)},
    {C(0.66), C(-0.33), C(-0.66), C(0.33), C(1.2), C(-0.0495), C(-1.2), C(-0.0396), C(-0.033),
     C(-0.11220000000000001), C(0.42900000000000005), C(-2.25), C(2.25)},
    {C(0.6000000000000001), C(-0.30000000000000004), C(-0.6000000000000001), C(0.30000000000000004), C(1.05),
     C(-0.045000000000000005), C(-1.05), C(-0.036000000000000004), C(-0.030000000000000013), C(-0.10200000000000001),
     C(0.39), C(-1.95), C(1.95)},
    {C(0.54), C(-0.27), C(-0.54), C(0.27), C(0.9), C(-0.04050000000000001), C(-0.9), C(-0.032400000000000005),
     C(-0.02700000000000002), C(-0.09180000000000002), C(0.35100000000000003), C(-1.65), C(1.65)},
    {C(0.48), C(-0.24), C(-0.48), C(0.24), C(0.75), C(-0.036000000000000004), C(-0.75), C(-0.028800000000000003),
     C(-0.024000000000000018), C(-0.0816), C(0.312), C(-1.35), C(1.35)},
    {C(0.42000000000000004), C(-0.21000000000000002), C(-0.42000000000000004), C(0.21000000000000002), C(0.6),
     C(-0.03150000000000001), C(-0.6), C(-0.025200000000000004), C(-0.021), C(-0.0714), C(0.273), C(-1.05), C(1.05)},
    {C(0.36000000000000004), C(-0.18000000000000002), C(-0.36000000000000004), C(0.18000000000000002), C(0.45),
     C(-0.027000000000000007), C(-0.45), C(-0.021600000000000005), C(-0.018000000000000002), C(-0.061200000000000004),
     C(0.234), C(-0.75), C(0.75)},
    {C(0.30000000000000004), C(-0.15000000000000002), C(-0.30000000000000004), C(0.15000000000000002), C(0.3),
     C(-0.022500000000000003), C(-0.3), C(-0.018000000000000002), C(-0.015000000000000006), C(-0.051000000000000004),
     C(0.195), C(-0.45), C(0.45)},
};
inline constexpr unsigned short inward_5_places[9][3] = {  // J, K, u_at
    {1800, 1734, 9},
    {1604, 1538, 10},
    {1407, 1341, 11},
    {1211, 1145, 12},
    {1014, 948, 13},
    {818, 752, 14},
    {621, 555, 15},
    {425, 359, 16},
    {228, 162, 17},
};
template <class C>
inline constexpr C inward_5_numbers[9][11] = {
    {C(-0.775), C(0.775), C(-1.5499999999999998), C(1.5499999999999998), C(2.8499999999999996), C(0.3302500000000001),
     C(-3.9234999999999998), C(-2.8499999999999996), C(-0.1831), C(1.48825), C(-1.98645)},
    {C(-0.7150000000000001), C(0.7150000000000001), C(-1.43), C(1.43), C(2.55), C(0.30474999999999997), C(-3.244),
     C(-2.55), C(-0.169), C(1.37275), C(-1.6447500000000002)},
    {C(-0.655), C(0.655), C(-1.31), C(1.31), C(2.25), C(0.27925000000000005), C(-2.6275), C(-2.25), C(-0.1549),
     C(1.25725), C(-1.3345500000000001)},
    {C(-0.595), C(0.595), C(-1.19), C(1.19), C(1.95), C(0.25375), C(-2.074), C(-1.95), C(-0.1408), C(1.14175),
     C(-1.05585)},
    {C(-0.535), C(0.535), C(-1.07), C(1.07), C(1.65), C(0.22825000000000006), C(-1.5835000000000001), C(-1.65),
     C(-0.1267), C(1.02625), C(-0.8086500000000001)},
    {C(-0.475), C(0.475), C(-0.95), C(0.95), C(1.35), C(0.20275000000000004), C(-1.156), C(-1.35),
     C(-0.11259999999999999), C(0.91075), C(-0.59295)},
    {C(-0.41500000000000004), C(0.41500000000000004), C(-0.83), C(0.83), C(1.05), C(0.17725000000000002),
     C(-0.7915000000000001), C(-1.05), C(-0.0985), C(0.79525), C(-0.40875000000000006)},
    {C(-0.35500000000000004), C(0.35500000000000004), C(-0.71), C(0.71), C(0.75), C(0.15175000000000002), C(-0.49),
     C(-0.75), C(-0.0844), C(0.67975), C(-0.25605)},
    {C(-0.295), C(0.295), C(-0.59), C(0.59), C(0.45), C(0.12625000000000003), C(-0.2515), C(-0.45), C(-0.0703),
     C(0.56425), C(-0.13485)},
};
inline constexpr unsigned short inward_6_places[8][3] = {  // J, K, u_at
    {1734, 1669, 1},
    {1538, 1472, 2},
    {1341, 1276, 3},
    {1145, 1079, 4},
    {948, 883, 5},
    {752, 686, 6},
    {555, 490, 7},
    {359, 293, 8},
};
template <class C>
inline constexpr C inward_6_numbers[8][15] = {
    {C(11.4), C(-0.9550000000000001), C(17.935), C(0.9550000000000001), C(-6.1), C(-17.935), C(6.1),
     C(42.702999999999996), C(-10.594499999999998), C(-0.5249), C(3.8942499999999995), C(-1.7712999999999999),
     C(45.906749999999995), C(1.35), C(-1.35)},
    {C(10.5), C(-0.88), C(14.935), C(0.88), C(-5.62), C(-14.935), C(5.62), C(31.96225), C(-8.808), C(-0.4838),
     C(3.5875), C(-1.4731), C(34.91475), C(1.2), C(-1.2)},
    {C(9.6), C(-0.805), C(12.205), C(0.805), C(-5.14), C(-12.205), C(5.14), C(23.206), C(-7.1834999999999996),
     C(-0.44270000000000004), C(3.28075), C(-1.2019000000000002), C(25.90725), C(1.05), C(-1.05)},
    {C(8.7), C(-0.73), C(9.745), C(0.73), C(-4.66), C(-9.745), C(4.66), C(16.231749999999998), C(-5.720999999999999),
     C(-0.4016), C(2.9739999999999998), C(-0.9577), C(18.681749999999997), C(0.9), C(-0.9)},
    {C(7.800000000000001), C(-0.655), C(7.555000000000001), C(0.655), C(-4.18), C(-7.555000000000001), C(4.18),
     C(10.837000000000002), C(-4.4205000000000005), C(-0.36050000000000004), C(2.66725), C(-0.7405), C(13.03575),
     C(0.75), C(-0.75)},
    {C(6.9), C(-0.58), C(5.635), C(0.58), C(-3.6999999999999997), C(-5.635), C(3.6999999999999997),
     C(6.819249999999999), C(-3.2819999999999996), C(-0.3194), C(2.3604999999999996), C(-0.5503), C(8.76675), C(0.6),
     C(-0.6)},
    {C(6), C(-0.505), C(3.9850000000000003), C(0.505), C(-3.2199999999999998), C(-3.9850000000000003),
     C(3.2199999999999998), C(3.9760000000000004), C(-2.3055), C(-0.2783), C(2.05375), C(-0.38710000000000006),
     C(5.67225), C(0.45), C(-0.45)},
    {C(5.1), C(-0.43000000000000005), C(2.605), C(0.43000000000000005), C(-2.7399999999999998), C(-2.605),
     C(2.7399999999999998), C(2.10475), C(-1.4909999999999999), C(-0.2372), C(1.7469999999999999), C(-0.2509),
     C(3.54975), C(0.3), C(-0.3)},
};
inline constexpr unsigned short solved_5_places[5][5] = {  // L, K, s_at, s_at2, ydot_at
    {228, 293, 51, 64, 5},
    {621, 686, 64, 51, 11},
    {1014, 1079, 64, 51, 17},
    {1407, 1472, 64, 51, 23},
    {1800, 1865, 64, 51, 29},
};
template <class C>
inline constexpr C solved_5_numbers[5][3] = {
    {C(-0.2), C(-0.3), C(0.3)},
    {C(-0.6), C(-0.2), C(0.6)},
    {C(-0.9), C(-0.2), C(0.9)},
    {C(-1.2), C(-0.2), C(1.2)},
    {C(-1.5), C(-0.2), C(1.5)},
};
inline constexpr unsigned short solved_7_places[4][3] = {  // K, L, ydot_at
    {425, 359, 7},
    {818, 752, 13},
    {1211, 1145, 19},
    {1604, 1538, 25},
};
template <class C>
inline constexpr C solved_7_numbers[4][2] = {
    {C(0.75), C(-0.75)},
    {C(1.35), C(-1.35)},
    {C(1.95), C(-1.95)},
    {C(2.55), C(-2.55)},
};
inline constexpr unsigned short solved_8_places[4][3] = {  // L, K, ydot_at
    {425, 490, 8},
    {818, 883, 14},
    {1211, 1276, 20},
    {1604, 1669, 26},
};
template <class C>
inline constexpr C solved_8_numbers[4][1] = {
    {C(0.45)},
    {C(0.75)},
    {C(1.05)},
    {C(1.35)},
};
inline constexpr unsigned short solved_9_places[4][3] = {  // L, K, ydot_at
    {490, 555, 9},
    {883, 948, 15},
    {1276, 1341, 21},
    {1669, 1734, 27},
};
inline constexpr unsigned short solved_10_places[4][3] = {  // K, L, ydot_at
    {621, 555, 10},
    {1014, 948, 16},
    {1407, 1341, 22},
    {1800, 1734, 28},
};
template <class C>
inline constexpr C solved_10_numbers[4][1] = {
    {C(1.05)},
    {C(1.65)},
    {C(2.25)},
    {C(2.8499999999999996)},
};
inline constexpr unsigned short solved_11_places[4][3] = {  // L, K, ydot_at
    {686, 752, 12},
    {1079, 1145, 18},
    {1472, 1538, 24},
    {1865, 1931, 30},
};

// body 1
template <class T>
[[gnu::noinline]] void outward_1(const T* y, const T* cosines, const T* sines, T* frames) noexcept {
  T* const own = frames + 0;
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
  const T N1_2 = T(0.47) * Pddot1_3 + T(0.23500000000000001) * minus_Pddot1_1;
  own[frame::minus_U_11] = minus_U1_11;
  own[frame::Pddot_1] = -minus_Pddot1_1;
  own[frame::Pddot_3] = Pddot1_3;
  own[frame::N_2] = N1_2;
}

// body 2
template <class T>
[[gnu::noinline]] void outward_2(const T* y, const T* cosines, const T* sines, T* frames) noexcept {
  const T* const of_1 = frames + 0;
  T* const own = frames + 32;
  const T thetadot1 = y[0];
  const T thetadot2 = y[1];
  const T minus_U1_11 = of_1[frame::minus_U_11];
  const T Pddot1_1 = of_1[frame::Pddot_1];
  const T Pddot1_3 = of_1[frame::Pddot_3];
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
  const T t2_4 = Pddot1_1 - minus_U1_11 * T(0.3);
  const T Pddot2_1 = E2_11 * t2_4;
  const T minus_Pddot2_2 = E2_12 * t2_4;
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_3 = U2_31 * T(0.12) + U2_32 * T(0.24);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(0.014400000000000001) * U2_12 - (T(0.24) * Pddot1_3 + T(0.084) * U2_32 + T(0.0408) * (minus_U2_22 -
      minus_U2_33) + T(0.018000000000000002) * U2_31);
  const T N2_2 = T(0.014400000000000001) * (minus_U2_11 - minus_U2_33) + T(0.072) * U2_31 - T(0.0408) * U2_12 +
      T(0.018000000000000002) * U2_32 + T(0.12) * Pddot1_3;
  const T N2_3 = T(0.12) * minus_Pddot2_2 + T(0.24) * Pddot2_1 + T(0.012000000000000009) * U2_12 -
      T(0.018000000000000002) * (minus_U2_11 - minus_U2_22);
  own[frame::Pddot_1] = Pddot2_1;
  own[frame::N_2] = N2_2;
  own[frame::E_11] = E2_11;
  own[frame::E_12] = E2_12;
  own[frame::omega_1] = omega2_1;
  own[frame::omega_2] = omega2_2;
  own[frame::omegadot_1] = omegadot2_1;
  own[frame::minus_omegadot_2] = minus_omegadot2_2;
  own[frame::U_12] = U2_12;
  own[frame::minus_U_22] = minus_U2_22;
  own[frame::U_32] = U2_32;
  own[frame::minus_U_33] = minus_U2_33;
  own[frame::minus_Pddot_2] = minus_Pddot2_2;
  own[frame::G_3] = -minus_G2_3;
  own[frame::N_1] = N2_1;
  own[frame::N_3] = N2_3;
}

// body 3
template <class T>
[[gnu::noinline]] void outward_3(const T* y, const T* cosines, const T* sines, T* frames) noexcept {
  const T* const of_2 = frames + 32;
  const T* const of_1 = frames + 0;
  T* const own = frames + 97;
  const T thetadot3 = y[2];
  const T omega2_1 = of_2[frame::omega_1];
  const T thetadot2 = y[1];
  const T omega2_2 = of_2[frame::omega_2];
  const T minus_omegadot2_2 = of_2[frame::minus_omegadot_2];
  const T omegadot2_1 = of_2[frame::omegadot_1];
  const T U2_12 = of_2[frame::U_12];
  const T Pddot2_1 = of_2[frame::Pddot_1];
  const T minus_U2_33 = of_2[frame::minus_U_33];
  const T U2_32 = of_2[frame::U_32];
  const T Pddot1_3 = of_1[frame::Pddot_3];
  const T minus_U2_22 = of_2[frame::minus_U_22];
  const T minus_Pddot2_2 = of_2[frame::minus_Pddot_2];
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
  const T Pddot3_1 = U2_12 * T(0.15) + Pddot2_1;
  const T t3_7 = Pddot1_3 + U2_32 * T(0.15) - minus_U2_33 * T(0.2);
  const T t3_8 = minus_Pddot2_2 + minus_U2_22 * T(0.15);
  const T Pddot3_2 = E3_23 * t3_7 - E3_22 * t3_8;
  const T Pddot3_3 = E3_22 * t3_7 + E3_23 * t3_8;
  // G3 = -m_all_3 Pddot3 - U3 h_all_3: applied less inertia force, body axes [N]
  const T G3_1 = minus_U3_11 * T(2.26) - (T(4.2) * Pddot3_1 + U3_12 * T(1.495)) - U3_13 * T(0.35500000000000004);
  const T G3_2 = minus_U3_22 * T(1.495) - (T(4.2) * Pddot3_2 + U3_21 * T(2.26)) - U3_23 * T(0.35500000000000004);
  const T G3_3 = minus_U3_33 * T(0.35500000000000004) - (T(4.2) * Pddot3_3 + U3_31 * T(2.26) + U3_32 * T(1.495));
  // N3 = -h_all_3~ Pddot3 - axial(U3 (tr(J_all_3)/2 - J_all_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(0.35500000000000004) * Pddot3_2 - T(1.495) * Pddot3_3 - T(0.87975) * U3_32 + T(0.12325000000000001)
      * U3_23 - T(0.14170000000000002) * (minus_U3_22 - minus_U3_33) - T(0.8385) * U3_31 + T(0.1961) * U3_21;
  const T N3_2 = T(2.26) * Pddot3_3 - T(0.35500000000000004) * Pddot3_1 - T(0.12325000000000001) * U3_13 + T(1.317) *
      U3_31 + T(0.1961) * (minus_U3_11 - minus_U3_33) - T(0.14170000000000002) * U3_12 + T(0.8385) * U3_32;
  const T N3_3 = T(1.495) * Pddot3_1 - T(2.26) * Pddot3_2 - T(1.317) * U3_21 + T(0.87975) * U3_12 - T(0.8385) *
      (minus_U3_11 - minus_U3_22) - T(0.1961) * U3_23 + T(0.14170000000000002) * U3_13;
  own[frame::minus_U_11] = minus_U3_11;
  own[frame::Pddot_1] = Pddot3_1;
  own[frame::Pddot_3] = Pddot3_3;
  own[frame::N_2] = N3_2;
  own[frame::omega_1] = omega3_1;
  own[frame::omega_2] = omega3_2;
  own[frame::minus_U_33] = minus_U3_33;
  own[frame::G_3] = G3_3;
  own[frame::N_1] = N3_1;
  own[frame::N_3] = N3_3;
  own[frame::E_22] = E3_22;
  own[frame::E_23] = E3_23;
  own[frame::omega_3] = omega3_3;
  own[frame::omegadot_2] = omegadot3_2;
  own[frame::omegadot_3] = omegadot3_3;
  own[frame::U_13] = U3_13;
  own[frame::U_21] = U3_21;
  own[frame::U_23] = U3_23;
  own[frame::U_31] = U3_31;
  own[frame::Pddot_2] = Pddot3_2;
  own[frame::G_1] = G3_1;
  own[frame::G_2] = G3_2;
}

// bodies 4, 7, 10, 13, 16, 19, 22, 25, 28, 31
template <class T>
[[gnu::noinline]] void outward_4(const T* y, const T* cosines, const T* sines, T* frames, int row) noexcept {
  const auto& [L, J, K, y_at, x_at] = outward_4_places[row];
  const auto& k = outward_4_numbers<Number<T>>[row];
  const T* const of_L = frames + L;
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T omegaL_1 = of_L[frame::omega_1];
  const T omegaL_3 = of_L[frame::omega_3];
  const T thetadotK = y[y_at];
  const T omegaL_2 = of_L[frame::omega_2];
  const T omegadotJ_1 = of_J[frame::omegadot_1];
  const T omegadotL_3 = of_L[frame::omegadot_3];
  const T omegadotL_2 = of_L[frame::omegadot_2];
  const T minus_UL_11 = of_L[frame::minus_U_11];
  const T UL_13 = of_L[frame::U_13];
  const T PddotL_1 = of_L[frame::Pddot_1];
  const T minus_UL_33 = of_L[frame::minus_U_33];
  const T UL_31 = of_L[frame::U_31];
  const T PddotL_3 = of_L[frame::Pddot_3];
  const T UL_23 = of_L[frame::U_23];
  const T UL_21 = of_L[frame::U_21];
  const T PddotL_2 = of_L[frame::Pddot_2];
  // EK^T = Rot(bK, thetaK): E takes components in the lower body to those in the body
  const T EK_11 = cosines[x_at];
  const T minus_EK_13 = sines[x_at];
  // omegaK = thetadotK bK + EK omegaL: absolute angular velocity, body axes [rad/s]
  const T omegaK_1 = EK_11 * omegaL_1 - minus_EK_13 * omegaL_3;
  const T omegaK_2 = thetadotK + omegaL_2;
  const T omegaK_3 = minus_EK_13 * omegaL_1 + EK_11 * omegaL_3;
  // omegadotK = -thetadotK bK~ EK omegaL + EK omegadotL: angular acceleration, body axes [rad/s^2]
  const T omegadotK_1 = EK_11 * omegadotJ_1 - minus_EK_13 * omegadotL_3 - thetadotK * omegaK_3;
  const T omegadotK_3 = thetadotK * omegaK_1 + minus_EK_13 * omegadotJ_1 + EK_11 * omegadotL_3;
  // UK = omegaK~ omegaK~ + omegadotK~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T tK_1 = omegaK_3 * omegaK_3;
  const T tK_2 = omegaK_2 * omegaK_2;
  const T minus_UK_11 = tK_1 + tK_2;
  const T tK_3 = omegaK_2 * omegaK_1;
  const T UK_12 = tK_3 - omegadotK_3;
  const T tK_4 = omegaK_3 * omegaK_1;
  const T UK_13 = tK_4 + omegadotL_2;
  const T UK_21 = tK_3 + omegadotK_3;
  const T tK_5 = omegaK_1 * omegaK_1;
  const T minus_UK_22 = tK_1 + tK_5;
  const T tK_6 = omegaK_3 * omegaK_2;
  const T UK_23 = tK_6 - omegadotK_1;
  const T UK_31 = tK_4 - omegadotL_2;
  const T UK_32 = tK_6 + omegadotK_1;
  const T minus_UK_33 = tK_2 + tK_5;
  // PddotK = EK (UL qK + PddotL): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T tK_7 = PddotL_1 + UL_13 * T(0.1) - minus_UL_11 * T(0.6);
  const T tK_8 = PddotL_3 + UL_31 * T(0.6) - minus_UL_33 * T(0.1);
  const T PddotK_1 = EK_11 * tK_7 - minus_EK_13 * tK_8;
  const T PddotK_2 = PddotL_2 + UL_21 * T(0.6) + UL_23 * T(0.1);
  const T PddotK_3 = minus_EK_13 * tK_7 + EK_11 * tK_8;
  // GK = -UK h_own_K: applied less inertia force, body axes [N]
  const T GK_1 = UK_13 * T(k[1]) + minus_UK_11 * T(k[0]);
  const T GK_2 = UK_21 * T(k[2]) + UK_23 * T(k[1]);
  const T GK_3 = UK_31 * T(k[2]) + minus_UK_33 * T(k[3]);
  // NK = -h_own_K~ PddotK - axial(UK (tr(J_own_K)/2 - J_own_K)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T NK_1 = T(k[6]) * UK_32 + T(k[5]) * UK_23 + T(k[4]) * (minus_UK_22 - minus_UK_33) + T(k[7]) * UK_31 + T(k[8])
      * UK_21 + T(k[3]) * PddotK_2;
  const T NK_2 = T(k[1]) * PddotK_1 + T(k[0]) * PddotK_3 + T(k[9]) * UK_13 + T(k[6]) * UK_31 + T(k[8]) * (minus_UK_11
      - minus_UK_33) + T(k[4]) * UK_12 + T(k[10]) * UK_32;
  const T NK_3 = T(k[2]) * PddotK_2 + T(k[13]) * UK_21 + T(k[13]) * UK_12 + T(k[7]) * (minus_UK_11 - minus_UK_22) +
      T(k[12]) * UK_23 + T(k[11]) * UK_13;
  own[frame::minus_U_11] = minus_UK_11;
  own[frame::Pddot_1] = PddotK_1;
  own[frame::Pddot_3] = PddotK_3;
  own[frame::N_2] = NK_2;
  own[frame::E_11] = EK_11;
  own[frame::omega_1] = omegaK_1;
  own[frame::omega_2] = omegaK_2;
  own[frame::omegadot_1] = omegadotK_1;
  own[frame::U_12] = UK_12;
  own[frame::minus_U_22] = minus_UK_22;
  own[frame::U_32] = UK_32;
  own[frame::G_3] = GK_3;
  own[frame::N_1] = NK_1;
  own[frame::N_3] = NK_3;
  own[frame::omega_3] = omegaK_3;
  own[frame::omegadot_3] = omegadotK_3;
  own[frame::U_21] = UK_21;
  own[frame::U_31] = UK_31;
  own[frame::Pddot_2] = PddotK_2;
  own[frame::G_1] = GK_1;
  own[frame::G_2] = GK_2;
  own[frame::minus_E_13] = minus_EK_13;
}

// bodies 5, 8, 11, 14, 17, 20, 23, 26, 29
template <class T>
[[gnu::noinline]] void outward_5(const T* y, const T* cosines, const T* sines, T* frames, int row) noexcept {
  const auto& [L, J, K, y_at, x_at] = outward_5_places[row];
  const auto& k = outward_5_numbers<Number<T>>[row];
  const T* const of_L = frames + L;
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T omegaL_2 = of_L[frame::omega_2];
  const T omegaL_1 = of_L[frame::omega_1];
  const T thetadotK = y[y_at];
  const T omegaL_3 = of_L[frame::omega_3];
  const T omegadotJ_2 = of_J[frame::omegadot_2];
  const T omegadotL_1 = of_L[frame::omegadot_1];
  const T omegadotL_3 = of_L[frame::omegadot_3];
  const T minus_UL_11 = of_L[frame::minus_U_11];
  const T UL_12 = of_L[frame::U_12];
  const T PddotL_1 = of_L[frame::Pddot_1];
  const T minus_UL_22 = of_L[frame::minus_U_22];
  const T UL_21 = of_L[frame::U_21];
  const T PddotL_2 = of_L[frame::Pddot_2];
  const T UL_32 = of_L[frame::U_32];
  const T UL_31 = of_L[frame::U_31];
  const T PddotL_3 = of_L[frame::Pddot_3];
  // EK^T = Rot(bK, thetaK): E takes components in the lower body to those in the body
  const T EK_11 = cosines[x_at];
  const T EK_12 = sines[x_at];
  // omegaK = thetadotK bK + EK omegaL: absolute angular velocity, body axes [rad/s]
  const T omegaK_1 = EK_11 * omegaL_1 + EK_12 * omegaL_2;
  const T omegaK_2 = EK_11 * omegaL_2 - EK_12 * omegaL_1;
  const T omegaK_3 = thetadotK + omegaL_3;
  // omegadotK = -thetadotK bK~ EK omegaL + EK omegadotL: angular acceleration, body axes [rad/s^2]
  const T omegadotK_1 = thetadotK * omegaK_2 + EK_11 * omegadotL_1 + EK_12 * omegadotJ_2;
  const T minus_omegadotK_2 = EK_12 * omegadotL_1 - EK_11 * omegadotJ_2 + thetadotK * omegaK_1;
  // UK = omegaK~ omegaK~ + omegadotK~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T tK_1 = omegaK_3 * omegaK_3;
  const T tK_2 = omegaK_2 * omegaK_2;
  const T minus_UK_11 = tK_1 + tK_2;
  const T tK_3 = omegaK_2 * omegaK_1;
  const T UK_12 = tK_3 - omegadotL_3;
  const T tK_4 = omegaK_3 * omegaK_1;
  const T UK_13 = tK_4 - minus_omegadotK_2;
  const T UK_21 = tK_3 + omegadotL_3;
  const T tK_5 = omegaK_1 * omegaK_1;
  const T minus_UK_22 = tK_1 + tK_5;
  const T tK_6 = omegaK_3 * omegaK_2;
  const T UK_23 = tK_6 - omegadotK_1;
  const T UK_31 = tK_4 + minus_omegadotK_2;
  const T UK_32 = tK_6 + omegadotK_1;
  const T minus_UK_33 = tK_2 + tK_5;
  // PddotK = EK (UL qK + PddotL): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T tK_7 = PddotL_1 + UL_12 * T(k[0]) - minus_UL_11 * T(0.3);
  const T tK_8 = PddotL_2 + UL_21 * T(0.3) + minus_UL_22 * T(k[1]);
  const T PddotK_1 = EK_11 * tK_7 + EK_12 * tK_8;
  const T PddotK_2 = EK_11 * tK_8 - EK_12 * tK_7;
  const T PddotK_3 = PddotL_3 + UL_31 * T(0.3) + UL_32 * T(k[0]);
  // GK = -UK h_own_K: applied less inertia force, body axes [N]
  const T GK_1 = UK_12 * T(k[3]) + minus_UK_11 * T(k[2]);
  const T GK_2 = UK_21 * T(k[5]) + minus_UK_22 * T(k[4]);
  const T GK_3 = UK_31 * T(k[5]) + UK_32 * T(k[3]);
  // NK = -h_own_K~ PddotK - axial(UK (tr(J_own_K)/2 - J_own_K)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T NK_1 = T(k[3]) * PddotK_3 + T(k[7]) * UK_32 + T(k[7]) * UK_23 + T(k[6]) * (minus_UK_22 - minus_UK_33) +
      T(k[8]) * UK_31 + T(k[9]) * UK_21;
  const T NK_2 = T(k[10]) * UK_13 + T(k[11]) * UK_31 + T(k[9]) * (minus_UK_11 - minus_UK_33) + T(k[6]) * UK_12 +
      T(k[12]) * UK_32 + T(k[2]) * PddotK_3;
  const T NK_3 = T(k[5]) * PddotK_2 + T(k[4]) * PddotK_1 + T(k[14]) * UK_21 + T(k[10]) * UK_12 + T(k[8]) *
      (minus_UK_11 - minus_UK_22) + T(k[15]) * UK_23 + T(k[13]) * UK_13;
  own[frame::Pddot_1] = PddotK_1;
  own[frame::Pddot_3] = PddotK_3;
  own[frame::N_2] = NK_2;
  own[frame::E_11] = EK_11;
  own[frame::E_12] = EK_12;
  own[frame::omega_1] = omegaK_1;
  own[frame::omega_2] = omegaK_2;
  own[frame::omegadot_1] = omegadotK_1;
  own[frame::minus_omegadot_2] = minus_omegadotK_2;
  own[frame::U_12] = UK_12;
  own[frame::minus_U_22] = minus_UK_22;
  own[frame::U_32] = UK_32;
  own[frame::minus_U_33] = minus_UK_33;
  own[frame::G_3] = GK_3;
  own[frame::N_1] = NK_1;
  own[frame::N_3] = NK_3;
  own[frame::omega_3] = omegaK_3;
  own[frame::U_13] = UK_13;
  own[frame::U_23] = UK_23;
  own[frame::Pddot_2] = PddotK_2;
  own[frame::G_1] = GK_1;
  own[frame::G_2] = GK_2;
}

// bodies 6, 9, 12, 15, 18, 21, 24, 27, 30
template <class T>
[[gnu::noinline]] void outward_6(const T* y, const T* cosines, const T* sines, T* frames, int row) noexcept {
  const auto& [L, J, K, y_at, x_at] = outward_6_places[row];
  const auto& k = outward_6_numbers<Number<T>>[row];
  const T* const of_L = frames + L;
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T thetadotK = y[y_at];
  const T omegaL_1 = of_L[frame::omega_1];
  const T omegaL_3 = of_L[frame::omega_3];
  const T omegaL_2 = of_L[frame::omega_2];
  const T omegadotJ_3 = of_J[frame::omegadot_3];
  const T minus_omegadotL_2 = of_L[frame::minus_omegadot_2];
  const T omegadotL_1 = of_L[frame::omegadot_1];
  const T UL_13 = of_L[frame::U_13];
  const T UL_12 = of_L[frame::U_12];
  const T PddotL_1 = of_L[frame::Pddot_1];
  const T minus_UL_22 = of_L[frame::minus_U_22];
  const T UL_23 = of_L[frame::U_23];
  const T PddotL_2 = of_L[frame::Pddot_2];
  const T minus_UL_33 = of_L[frame::minus_U_33];
  const T UL_32 = of_L[frame::U_32];
  const T PddotL_3 = of_L[frame::Pddot_3];
  // EK^T = Rot(bK, thetaK): E takes components in the lower body to those in the body
  const T EK_22 = cosines[x_at];
  const T EK_23 = sines[x_at];
  // omegaK = thetadotK bK + EK omegaL: absolute angular velocity, body axes [rad/s]
  const T omegaK_1 = thetadotK + omegaL_1;
  const T omegaK_2 = EK_22 * omegaL_2 + EK_23 * omegaL_3;
  const T omegaK_3 = EK_22 * omegaL_3 - EK_23 * omegaL_2;
  // omegadotK = -thetadotK bK~ EK omegaL + EK omegadotL: angular acceleration, body axes [rad/s^2]
  const T omegadotK_2 = thetadotK * omegaK_3 - EK_22 * minus_omegadotL_2 + EK_23 * omegadotJ_3;
  const T omegadotK_3 = EK_22 * omegadotJ_3 + EK_23 * minus_omegadotL_2 - thetadotK * omegaK_2;
  // UK = omegaK~ omegaK~ + omegadotK~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T tK_1 = omegaK_3 * omegaK_3;
  const T tK_2 = omegaK_2 * omegaK_2;
  const T minus_UK_11 = tK_1 + tK_2;
  const T tK_3 = omegaK_2 * omegaK_1;
  const T UK_12 = tK_3 - omegadotK_3;
  const T tK_4 = omegaK_3 * omegaK_1;
  const T UK_13 = tK_4 + omegadotK_2;
  const T UK_21 = tK_3 + omegadotK_3;
  const T tK_5 = omegaK_1 * omegaK_1;
  const T minus_UK_22 = tK_1 + tK_5;
  const T tK_6 = omegaK_3 * omegaK_2;
  const T UK_23 = tK_6 - omegadotL_1;
  const T UK_31 = tK_4 - omegadotK_2;
  const T UK_32 = tK_6 + omegadotL_1;
  const T minus_UK_33 = tK_2 + tK_5;
  // PddotK = EK (UL qK + PddotL): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T PddotK_1 = PddotL_1 + UL_12 * T(k[0]) + UL_13 * T(0.2);
  const T tK_7 = PddotL_2 + UL_23 * T(0.2) + minus_UL_22 * T(k[1]);
  const T tK_8 = PddotL_3 + UL_32 * T(k[0]) - minus_UL_33 * T(0.2);
  const T PddotK_2 = EK_22 * tK_7 + EK_23 * tK_8;
  const T PddotK_3 = EK_22 * tK_8 - EK_23 * tK_7;
  // GK = -m_all_K PddotK - UK h_all_K: applied less inertia force, body axes [N]
  const T GK_1 = T(k[2]) * PddotK_1 + UK_12 * T(k[3]) + minus_UK_11 * T(k[4]) + UK_13 * T(k[5]);
  const T GK_2 = T(k[2]) * PddotK_2 + UK_21 * T(k[7]) + minus_UK_22 * T(k[6]) + UK_23 * T(k[5]);
  const T GK_3 = T(k[2]) * PddotK_3 + UK_31 * T(k[7]) + UK_32 * T(k[3]) + minus_UK_33 * T(k[8]);
  // NK = -h_all_K~ PddotK - axial(UK (tr(J_all_K)/2 - J_all_K)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T NK_1 = T(k[3]) * PddotK_3 + T(k[8]) * PddotK_2 + T(k[13]) * UK_32 + T(k[12]) * UK_23 + T(k[11]) *
      (minus_UK_22 - minus_UK_33) + T(k[10]) * UK_31 + T(k[9]) * UK_21;
  const T NK_2 = T(k[5]) * PddotK_1 + T(k[4]) * PddotK_3 + T(k[15]) * UK_13 + T(k[14]) * UK_31 + T(k[9]) *
      (minus_UK_11 - minus_UK_33) + T(k[11]) * UK_12 + T(k[16]) * UK_32;
  const T NK_3 = T(k[7]) * PddotK_2 + T(k[6]) * PddotK_1 + T(k[18]) * UK_21 + T(k[19]) * UK_12 + T(k[10]) *
      (minus_UK_11 - minus_UK_22) + T(k[20]) * UK_23 + T(k[17]) * UK_13;
  own[frame::minus_U_11] = minus_UK_11;
  own[frame::Pddot_1] = PddotK_1;
  own[frame::Pddot_3] = PddotK_3;
  own[frame::N_2] = NK_2;
  own[frame::omega_1] = omegaK_1;
  own[frame::omega_2] = omegaK_2;
  own[frame::minus_U_33] = minus_UK_33;
  own[frame::G_3] = GK_3;
  own[frame::N_1] = NK_1;
  own[frame::N_3] = NK_3;
  own[frame::E_22] = EK_22;
  own[frame::E_23] = EK_23;
  own[frame::omega_3] = omegaK_3;
  own[frame::omegadot_2] = omegadotK_2;
  own[frame::omegadot_3] = omegadotK_3;
  own[frame::U_13] = UK_13;
  own[frame::U_21] = UK_21;
  own[frame::U_23] = UK_23;
  own[frame::U_31] = UK_31;
  own[frame::Pddot_2] = PddotK_2;
  own[frame::G_1] = GK_1;
  own[frame::G_2] = GK_2;
}

// body 32
template <class T>
[[gnu::noinline]] void outward_7(const T* y, const T* cosines, const T* sines, T* frames) noexcept {
  const T* const of_31 = frames + 1931;
  const T* const of_30 = frames + 1865;
  T* const own = frames + 1997;
  const T omega31_1 = of_31[frame::omega_1];
  const T omega31_2 = of_31[frame::omega_2];
  const T thetadot32 = y[31];
  const T omega31_3 = of_31[frame::omega_3];
  const T omegadot31_1 = of_31[frame::omegadot_1];
  const T omegadot30_2 = of_30[frame::omegadot_2];
  const T omegadot31_3 = of_31[frame::omegadot_3];
  const T minus_U31_22 = of_31[frame::minus_U_22];
  const T U31_21 = of_31[frame::U_21];
  const T Pddot31_2 = of_31[frame::Pddot_2];
  const T minus_U31_11 = of_31[frame::minus_U_11];
  const T U31_12 = of_31[frame::U_12];
  const T Pddot31_1 = of_31[frame::Pddot_1];
  const T U31_32 = of_31[frame::U_32];
  const T U31_31 = of_31[frame::U_31];
  const T Pddot31_3 = of_31[frame::Pddot_3];
  // E32^T = Z32^T Rot(b32, theta32): E takes components in the lower body to those in the body
  const T t32_1 = cosines[31];
  const T t32_2 = sines[31];
  const T E32_11 = T(0.44721359549995804) * t32_1 - T(0.8944271909999159) * t32_2;
  const T E32_12 = T(0.8944271909999159) * t32_1 + T(0.44721359549995804) * t32_2;
  // omega32 = thetadot32 b32 + E32 omega31: absolute angular velocity, body axes [rad/s]
  const T omega32_1 = E32_11 * omega31_1 + E32_12 * omega31_2;
  const T omega32_2 = E32_11 * omega31_2 - E32_12 * omega31_1;
  const T omega32_3 = thetadot32 + omega31_3;
  // omegadot32 = -thetadot32 b32~ E32 omega31 + E32 omegadot31: angular acceleration, body axes [rad/s^2]
  const T omegadot32_1 = thetadot32 * omega32_2 + E32_11 * omegadot31_1 + E32_12 * omegadot30_2;
  const T minus_omegadot32_2 = E32_12 * omegadot31_1 - E32_11 * omegadot30_2 + thetadot32 * omega32_1;
  // U32 = omega32~ omega32~ + omegadot32~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t32_3 = omega32_3 * omega32_3;
  const T t32_4 = omega32_2 * omega32_2;
  const T minus_U32_11 = t32_3 + t32_4;
  const T t32_5 = omega32_2 * omega32_1;
  const T U32_12 = t32_5 - omegadot31_3;
  const T t32_6 = omega32_3 * omega32_1;
  const T U32_13 = t32_6 - minus_omegadot32_2;
  const T U32_21 = t32_5 + omegadot31_3;
  const T t32_7 = omega32_1 * omega32_1;
  const T minus_U32_22 = t32_3 + t32_7;
  const T t32_8 = omega32_3 * omega32_2;
  const T U32_23 = t32_8 - omegadot32_1;
  const T U32_31 = t32_6 + minus_omegadot32_2;
  const T U32_32 = t32_8 + omegadot32_1;
  const T minus_U32_33 = t32_4 + t32_7;
  // Pddot32 = E32 (U31 q32 + Pddot31): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot32_2 = E32_11 * (Pddot31_2 + U31_21 * T(0.3) - minus_U31_22 * T(3.1500000000000004)) - E32_12 *
      (Pddot31_1 + U31_12 * T(3.1500000000000004) - minus_U31_11 * T(0.3));
  const T Pddot32_3 = Pddot31_3 + U31_31 * T(0.3) + U31_32 * T(3.1500000000000004);
  // G32 = -U32 h_own_32: applied less inertia force, body axes [N]
  const T G32_1 = minus_U32_11 * T(0.9391485505499118);
  const T minus_G32_2 = U32_21 * T(0.9391485505499118);
  const T minus_G32_3 = U32_31 * T(0.9391485505499118);
  // N32 = -h_own_32~ Pddot32 - axial(U32 (tr(J_own_32)/2 - J_own_32)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T N32_1 = T(0.02100000000000002) * U32_31 - (T(0.21000000000000002) * U32_32 + T(0.21000000000000002) * U32_23
      + T(0.018782971010998236) * (minus_U32_22 - minus_U32_33)) + T(0.15026376808798592) * U32_21;
  const T N32_2 = T(0.21000000000000002) * U32_13 + T(0.3360000000000001) * U32_31 + T(0.15026376808798592) *
      (minus_U32_11 - minus_U32_33) - T(0.018782971010998236) * U32_12 - T(0.02100000000000002) * U32_32 +
      T(0.9391485505499118) * Pddot32_3;
  const T N32_3 = T(0.21000000000000002) * U32_12 - (T(0.9391485505499118) * Pddot32_2 + T(0.3360000000000001) *
      U32_21) + T(0.02100000000000002) * (minus_U32_11 - minus_U32_22) - T(0.15026376808798592) * U32_23 +
      T(0.018782971010998236) * U32_13;
  own[frame::N_2] = N32_2;
  own[frame::E_11] = E32_11;
  own[frame::E_12] = E32_12;
  own[frame::G_3] = -minus_G32_3;
  own[frame::N_1] = N32_1;
  own[frame::N_3] = N32_3;
  own[frame::G_1] = G32_1;
  own[frame::G_2] = -minus_G32_2;
}

// body 32 and what they carry
template <class T>
[[gnu::noinline]] void inward_1(const Inputs<T>& u, T* frames) noexcept {
  T* const own = frames + 1997;
  const T N32_3 = own[frame::N_3];
  const T G32_2 = own[frame::G_2];
  const T N32_1 = own[frame::N_1];
  const T N32_2 = own[frame::N_2];
  const T E32_12 = own[frame::E_12];
  const T E32_11 = own[frame::E_11];
  const T G32_1 = own[frame::G_1];
  // u_32 = b32 . N32 + tau_body_32_: drives it [N m], [N]
  const T u_32 = u.tau_32 + N32_3;
  // v32 = invD32 u_32: u/D
  const T v32 = T(1.8315018315018312) * u_32;
  // gt32 = G32 - v32 B32: force with the turn solved [N]
  const T gt32_2 = G32_2 - v32 * T(0.9391485505499118);
  // nt32 = -tau_body_32_ b32 + P_b32 (N32 - v32 K32): moment with the turn solved [N m]
  const T nt32_1 = v32 * T(0.15026376808798592) + N32_1;
  const T nt32_2 = v32 * T(0.018782971010998236) + N32_2;
  // Mp32 = E32^T M32 E32: M passed on, lower body's axes [kg]
  const T b32_1 = E32_12 * T(1.6153846153846156);
  const T minus_Mp32_11 = E32_12 * b32_1;
  const T Mp32_12 = E32_11 * b32_1;
  const T Mp32_22 = minus_Mp32_11 - T(1.6153846153846156);
  // gp32 = E32^T gt32: force passed on, lower body's axes [N]
  const T gp32_1 = E32_11 * G32_1 - E32_12 * gt32_2;
  const T gp32_2 = E32_12 * G32_1 + E32_11 * gt32_2;
  // Hp32 = E32^T H32 E32: H passed on, lower body's axes [kg m]
  const T b32_2 = E32_11 * T(0.2584615384615385) - E32_12 * T(0.03230769230769231);
  const T minus_Hp32_11 = E32_12 * b32_2;
  const T Hp32_12 = E32_11 * b32_2;
  const T Hp32_13 = E32_12 * T(0.9391485505499118);
  const T Hp32_21 = Hp32_12 - T(0.2584615384615385);
  const T Hp32_22 = T(0.03230769230769231) + minus_Hp32_11;
  const T minus_Hp32_23 = E32_11 * T(0.9391485505499118);
  // Jp32 = E32^T J32 E32: J passed on, lower body's axes [kg m^2]
  const T b32_3 = T(2) * E32_11 * T(0.015830769230769245) - E32_12 * T(0.16670769230769236);
  const T b32_4 = E32_12 * b32_3;
  const T minus_Jp32_11 = T(0.04135384615384617) + b32_4;
  const T Jp32_12 = E32_11 * b32_3 - T(0.015830769230769245);
  const T Jp32_22 = T(0.1253538461538462) + b32_4;
  // np32 = E32^T nt32: moment passed on, lower body's axes [N m]
  const T np32_1 = E32_11 * nt32_1 - E32_12 * nt32_2;
  const T np32_2 = E32_12 * nt32_1 + E32_11 * nt32_2;
  // Hb32 = q32~ Mp32 + Hp32: H of the joint at the lower body's origin, its axes
  const T Hb32_31 = T(3.1500000000000004) * minus_Mp32_11 + T(0.3) * Mp32_12;
  const T Hb32_32 = T(0.3) * Mp32_22 - T(3.1500000000000004) * Mp32_12;
  own[frame::v] = v32;
  own[frame::minus_Mp_11] = minus_Mp32_11;
  own[frame::Mp_12] = Mp32_12;
  own[frame::Mp_22] = Mp32_22;
  own[frame::gp_1] = gp32_1;
  own[frame::gp_2] = gp32_2;
  own[frame::minus_Hp_11] = minus_Hp32_11;
  own[frame::Hp_12] = Hp32_12;
  own[frame::Hp_13] = Hp32_13;
  own[frame::Hp_21] = Hp32_21;
  own[frame::Hp_22] = Hp32_22;
  own[frame::Hp_23] = -minus_Hp32_23;
  own[frame::Jp_11] = -minus_Jp32_11;
  own[frame::Jp_12] = Jp32_12;
  own[frame::Jp_22] = Jp32_22;
  own[frame::np_1] = np32_1;
  own[frame::np_2] = np32_2;
  own[frame::Hb_31] = Hb32_31;
  own[frame::Hb_32] = Hb32_32;
}

// body 31 and what they carry
template <class T>
[[gnu::noinline]] void inward_2(const Inputs<T>& u, T* frames) noexcept {
  const T* const of_32 = frames + 1997;
  T* const own = frames + 1931;
  const T Hp32_12 = of_32[frame::Hp_12];
  const T Hp32_21 = of_32[frame::Hp_21];
  const T Hp32_23 = of_32[frame::Hp_23];
  const T Hb32_32 = of_32[frame::Hb_32];
  const T Hp32_13 = of_32[frame::Hp_13];
  const T Jp32_11 = of_32[frame::Jp_11];
  const T Jp32_12 = of_32[frame::Jp_12];
  const T minus_Hp32_11 = of_32[frame::minus_Hp_11];
  const T Jp32_22 = of_32[frame::Jp_22];
  const T Hp32_22 = of_32[frame::Hp_22];
  const T Hb32_31 = of_32[frame::Hb_31];
  const T gp32_1 = of_32[frame::gp_1];
  const T G31_1 = own[frame::G_1];
  const T gp32_2 = of_32[frame::gp_2];
  const T G31_2 = own[frame::G_2];
  const T G32_3 = of_32[frame::G_3];
  const T G31_3 = own[frame::G_3];
  const T np32_1 = of_32[frame::np_1];
  const T N31_1 = own[frame::N_1];
  const T np32_2 = of_32[frame::np_2];
  const T N31_2 = own[frame::N_2];
  const T N31_3 = own[frame::N_3];
  const T minus_Mp32_11 = of_32[frame::minus_Mp_11];
  const T Mp32_12 = of_32[frame::Mp_12];
  const T Mp32_22 = of_32[frame::Mp_22];
  const T E31_11 = own[frame::E_11];
  const T minus_E31_13 = own[frame::minus_E_13];
  // HA31 = h_own_31~ + Hb32: moment for an acceleration of the origin, body axes [kg m]
  const T HA31_12 = Hp32_12 - T(0.8350000000000001);
  const T HA31_21 = T(0.8350000000000001) + Hp32_21;
  const T HA31_23 = Hp32_23 - T(1.67);
  const T HA31_32 = T(1.67) + Hb32_32;
  // JA31 = q32~ Hp32^T + J_own_31 + Jp32 - Hb32 q32~: moment for an angular acceleration, body axes [kg m^2]
  const T JA31_11 = T(0.27175) + Jp32_11 + T(6.300000000000001) * Hp32_13;
  const T JA31_12 = Jp32_12 - T(4.666) + T(3.1500000000000004) * Hp32_23 - T(0.3) * Hp32_13;
  const T JA31_13 = T(0.3) * Hp32_12 - T(0.19720000000000004) + T(3.1500000000000004) * minus_Hp32_11;
  const T JA31_22 = T(1.51975) + Jp32_22 - T(0.6) * Hp32_23;
  const T JA31_23 = T(0.3) * Hp32_22 - T(2.3596500000000002) - T(3.1500000000000004) * Hp32_21;
  const T JA31_33 = Hb32_32 * T(0.3) - Hb32_31 * T(3.1500000000000004);
  // g31 = G31 + gp32: force that drives it, home axes [N]
  const T g31_1 = gp32_1 + G31_1;
  const T g31_2 = gp32_2 + G31_2;
  const T g31_3 = G32_3 + G31_3;
  // n31 = q32~ gp32 + N31 + np32: moment that drives it, body axes [N m]
  const T n31_1 = np32_1 + N31_1 + T(3.1500000000000004) * G32_3;
  const T n31_2 = np32_2 + N31_2 - T(0.3) * G32_3;
  const T minus_n31_3 = u.tau_32 - N31_3 - T(0.3) * gp32_2 + T(3.1500000000000004) * gp32_1;
  // invD31 = D31^-1: 1/D
  const T invD31 = T(1) / JA31_22;
  // kB31 = invD31 B31: B/D
  const T kB31_1 = invD31 * HA31_21;
  const T kB31_2 = invD31 * Hp32_22;
  const T kB31_3 = invD31 * HA31_23;
  // kK31 = invD31 K31: K/D
  const T kK31_1 = invD31 * JA31_12;
  const T kK31_3 = invD31 * JA31_23;
  // u_31 = b31 . n31 + tau_body_31_: drives it [N m], [N]
  const T u_31 = n31_2 + u.tau_31;
  // v31 = invD31 u_31: u/D
  const T v31 = invD31 * u_31;
  // M31 = Mp32 - kB31 B31^T: MA less what the turn takes up [kg]
  const T minus_M31_11 = minus_Mp32_11 + kB31_1 * HA31_21;
  const T M31_12 = Mp32_12 - kB31_1 * Hp32_22;
  const T minus_M31_13 = kB31_1 * HA31_23;
  const T M31_22 = Mp32_22 - kB31_2 * Hp32_22;
  const T minus_M31_23 = kB31_2 * HA31_23;
  const T minus_M31_33 = kB31_3 * HA31_23;
  // H31 = P_b31 (HA31 - kK31 B31^T): HA less what the turn takes up [kg m]
  const T minus_H31_11 = minus_Hp32_11 + kK31_1 * HA31_21;
  const T H31_12 = HA31_12 - kK31_1 * Hp32_22;
  const T H31_13 = Hp32_13 - kK31_1 * HA31_23;
  const T H31_31 = Hb32_31 - kK31_3 * HA31_21;
  const T H31_32 = HA31_32 - kK31_3 * Hp32_22;
  const T minus_H31_33 = kK31_3 * HA31_23;
  // J31 = P_b31 (JA31 - kK31 K31^T) P_b31: JA less what the turn takes up [kg m^2]
  const T J31_11 = JA31_11 - kK31_1 * JA31_12;
  const T J31_13 = JA31_13 - kK31_1 * JA31_23;
  const T J31_33 = JA31_33 - kK31_3 * JA31_23;
  // gt31 = g31 - v31 B31: force with the turn solved [N]
  const T gt31_1 = g31_1 - v31 * HA31_21;
  const T gt31_2 = g31_2 - v31 * Hp32_22;
  const T gt31_3 = g31_3 - v31 * HA31_23;
  // nt31 = -tau_body_31_ b31 + P_b31 (n31 - v31 K31): moment with the turn solved [N m]
  const T nt31_1 = n31_1 - v31 * JA31_12;
  const T minus_nt31_3 = minus_n31_3 + v31 * JA31_23;
  // Mp31 = E31^T M31 E31: M passed on, lower body's axes [kg]
  const T b31_1 = T(2) * E31_11;
  const T b31_2 = minus_E31_13 * (minus_M31_33 - minus_M31_11) + b31_1 * minus_M31_13;
  const T b31_3 = minus_E31_13 * b31_2;
  const T minus_Mp31_11 = b31_3 + minus_M31_11;
  const T Mp31_12 = E31_11 * M31_12 - minus_E31_13 * minus_M31_23;
  const T Mp31_13 = minus_M31_13 - E31_11 * b31_2;
  const T minus_Mp31_23 = minus_E31_13 * M31_12 + E31_11 * minus_M31_23;
  const T Mp31_33 = b31_3 - minus_M31_33;
  // gp31 = E31^T gt31: force passed on, lower body's axes [N]
  const T gp31_1 = E31_11 * gt31_1 + minus_E31_13 * gt31_3;
  const T gp31_3 = E31_11 * gt31_3 - minus_E31_13 * gt31_1;
  // Hp31 = E31^T H31 E31: H passed on, lower body's axes [kg m]
  const T b31_4 = E31_11 * (H31_31 + H31_13) - minus_E31_13 * (minus_H31_33 - minus_H31_11);
  const T b31_5 = minus_E31_13 * b31_4;
  const T Hp31_11 = b31_5 - minus_H31_11;
  const T Hp31_12 = minus_E31_13 * H31_32 + E31_11 * H31_12;
  const T b31_6 = E31_11 * b31_4;
  const T Hp31_13 = b31_6 - H31_31;
  const T Hp31_31 = b31_6 - H31_13;
  const T Hp31_32 = E31_11 * H31_32 - minus_E31_13 * H31_12;
  const T minus_Hp31_33 = b31_5 + minus_H31_33;
  // Jp31 = E31^T J31 E31: J passed on, lower body's axes [kg m^2]
  const T b31_7 = b31_1 * J31_13 - minus_E31_13 * (J31_11 - J31_33);
  const T b31_8 = minus_E31_13 * b31_7;
  const T Jp31_11 = J31_11 + b31_8;
  const T Jp31_13 = E31_11 * b31_7 - J31_13;
  const T Jp31_33 = J31_33 - b31_8;
  // np31 = E31^T nt31: moment passed on, lower body's axes [N m]
  const T np31_1 = E31_11 * nt31_1 - minus_E31_13 * minus_nt31_3;
  const T minus_np31_3 = E31_11 * minus_nt31_3 + minus_E31_13 * nt31_1;
  // Hb31 = q31~ Mp31 + Hp31: H of the joint at the lower body's origin, its axes
  const T b31_9 = T(0.1) * Mp31_12;
  const T Hb31_11 = Hp31_11 - b31_9;
  const T Hb31_12 = Hp31_12 - T(0.1) * M31_22;
  const T Hb31_13 = Hp31_13 + T(0.1) * minus_Mp31_23;
  const T minus_Hb31_21 = T(0.1) * minus_Mp31_11 + T(0.6) * Mp31_13;
  const T b31_10 = T(0.6) * minus_Mp31_23;
  const T Hb31_22 = b31_9 + b31_10;
  const T Hb31_23 = T(0.1) * Mp31_13 - T(0.6) * Mp31_33;
  const T Hb31_31 = Hp31_31 + T(0.6) * Mp31_12;
  const T Hb31_32 = Hp31_32 + T(0.6) * M31_22;
  const T minus_Hb31_33 = minus_Hp31_33 + b31_10;
  own[frame::v] = v31;
  own[frame::minus_Mp_11] = minus_Mp31_11;
  own[frame::Mp_12] = Mp31_12;
  own[frame::gp_1] = gp31_1;
  own[frame::Hp_12] = Hp31_12;
  own[frame::Jp_11] = Jp31_11;
  own[frame::np_1] = np31_1;
  own[frame::Hb_31] = Hb31_31;
  own[frame::Hb_32] = Hb31_32;
  own[frame::kB_1] = kB31_1;
  own[frame::kB_2] = kB31_2;
  own[frame::kB_3] = kB31_3;
  own[frame::kK_1] = kK31_1;
  own[frame::kK_3] = kK31_3;
  own[frame::M_22] = M31_22;
  own[frame::gt_2] = gt31_2;
  own[frame::Mp_13] = Mp31_13;
  own[frame::minus_Mp_23] = minus_Mp31_23;
  own[frame::Mp_33] = Mp31_33;
  own[frame::gp_3] = gp31_3;
  own[frame::Hp_31] = Hp31_31;
  own[frame::Hp_32] = Hp31_32;
  own[frame::minus_Hp_33] = minus_Hp31_33;
  own[frame::Jp_13] = Jp31_13;
  own[frame::Jp_33] = Jp31_33;
  own[frame::np_3] = -minus_np31_3;
  own[frame::Hb_11] = Hb31_11;
  own[frame::Hb_12] = Hb31_12;
  own[frame::Hb_13] = Hb31_13;
  own[frame::Hb_21] = -minus_Hb31_21;
  own[frame::Hb_22] = Hb31_22;
  own[frame::Hb_23] = Hb31_23;
  own[frame::minus_Hb_33] = minus_Hb31_33;
}

// body 30 and what they carry
template <class T>
[[gnu::noinline]] void inward_3(const Inputs<T>& u, T* frames) noexcept {
  const T* const of_31 = frames + 1931;
  T* const own = frames + 1865;
  const T minus_Mp31_11 = of_31[frame::minus_Mp_11];
  const T M31_22 = of_31[frame::M_22];
  const T Mp31_33 = of_31[frame::Mp_33];
  const T Hb31_12 = of_31[frame::Hb_12];
  const T Hb31_13 = of_31[frame::Hb_13];
  const T Hb31_21 = of_31[frame::Hb_21];
  const T Hb31_23 = of_31[frame::Hb_23];
  const T Hb31_31 = of_31[frame::Hb_31];
  const T Hb31_32 = of_31[frame::Hb_32];
  const T Hp31_12 = of_31[frame::Hp_12];
  const T Jp31_11 = of_31[frame::Jp_11];
  const T Hb31_11 = of_31[frame::Hb_11];
  const T Hp31_32 = of_31[frame::Hp_32];
  const T Jp31_13 = of_31[frame::Jp_13];
  const T Hb31_22 = of_31[frame::Hb_22];
  const T minus_Hp31_33 = of_31[frame::minus_Hp_33];
  const T Hp31_31 = of_31[frame::Hp_31];
  const T Jp31_33 = of_31[frame::Jp_33];
  const T gp31_1 = of_31[frame::gp_1];
  const T G30_1 = own[frame::G_1];
  const T gt31_2 = of_31[frame::gt_2];
  const T G30_2 = own[frame::G_2];
  const T gp31_3 = of_31[frame::gp_3];
  const T G30_3 = own[frame::G_3];
  const T np31_1 = of_31[frame::np_1];
  const T N30_1 = own[frame::N_1];
  const T N30_2 = own[frame::N_2];
  const T np31_3 = of_31[frame::np_3];
  const T N30_3 = own[frame::N_3];
  const T Mp31_12 = of_31[frame::Mp_12];
  const T Mp31_13 = of_31[frame::Mp_13];
  const T minus_Mp31_23 = of_31[frame::minus_Mp_23];
  const T minus_Hb31_33 = of_31[frame::minus_Hb_33];
  const T E30_22 = own[frame::E_22];
  const T E30_23 = own[frame::E_23];
  // MA30 = m_all_30 one + Mp31: force for an acceleration of the origin, home axes [kg]
  const T MA30_11 = T(12.3) - minus_Mp31_11;
  const T MA30_22 = T(12.3) + M31_22;
  const T MA30_33 = T(12.3) + Mp31_33;
  // HA30 = h_all_30~ + Hb31: moment for an acceleration of the origin, body axes [kg m]
  const T HA30_12 = Hb31_12 - T(1.03);
  const T HA30_13 = T(21.205000000000002) + Hb31_13;
  const T HA30_21 = T(1.03) + Hb31_21;
  const T HA30_23 = Hb31_23 - T(6.58);
  const T HA30_31 = Hb31_31 - T(21.205000000000002);
  const T HA30_32 = T(6.58) + Hb31_32;
  // JA30 = q31~ Hp31^T + J_all_30 + Jp31 - Hb31 q31~: moment for an angular acceleration, body axes [kg m^2]
  const T JA30_11 = T(55.630750000000006) + Jp31_11 - T(0.1) * Hp31_12 - Hb31_12 * T(0.1);
  const T JA30_12 = Hb31_11 * T(0.1) - (T(12.543) + Hb31_13 * T(0.6));
  const T JA30_13 = Jp31_13 - T(0.566) - T(0.1) * Hp31_32 + Hb31_12 * T(0.6);
  const T JA30_22 = T(4.201) + Hb31_21 * T(0.1) - Hb31_23 * T(0.6);
  const T JA30_23 = T(0.1) * Hp31_31 - T(2.0965000000000003) + T(0.6) * minus_Hp31_33 + Hb31_22 * T(0.6);
  const T JA30_33 = T(59.085750000000004) + Jp31_33 + T(0.6) * Hp31_32 + Hb31_32 * T(0.6);
  // g30 = G30 + gp31: force that drives it, home axes [N]
  const T g30_1 = gp31_1 + G30_1;
  const T g30_2 = gt31_2 + G30_2;
  const T g30_3 = gp31_3 + G30_3;
  // n30 = q31~ gp31 + N30 + np31: moment that drives it, body axes [N m]
  const T n30_1 = np31_1 + N30_1 - T(0.1) * gt31_2;
  const T minus_n30_2 = u.tau_31 - N30_2 - T(0.1) * gp31_1 + T(0.6) * gp31_3;
  const T n30_3 = np31_3 + N30_3 + T(0.6) * gt31_2;
  // invD30 = D30^-1: 1/D
  const T invD30 = T(1) / JA30_11;
  // kB30 = invD30 B30: B/D
  const T kB30_1 = invD30 * Hb31_11;
  const T kB30_2 = invD30 * HA30_12;
  const T kB30_3 = invD30 * HA30_13;
  // kK30 = invD30 K30: K/D
  const T kK30_2 = invD30 * JA30_12;
  const T kK30_3 = invD30 * JA30_13;
  // u_30 = b30 . n30 + tau_body_30_: drives it [N m], [N]
  const T u_30 = n30_1 + u.tau_30;
  // v30 = invD30 u_30: u/D
  const T v30 = invD30 * u_30;
  // M30 = MA30 - kB30 B30^T: MA less what the turn takes up [kg]
  const T M30_11 = MA30_11 - kB30_1 * Hb31_11;
  const T M30_12 = Mp31_12 - kB30_1 * HA30_12;
  const T M30_13 = Mp31_13 - kB30_1 * HA30_13;
  const T M30_22 = MA30_22 - kB30_2 * HA30_12;
  const T minus_M30_23 = minus_Mp31_23 + kB30_2 * HA30_13;
  const T M30_33 = MA30_33 - kB30_3 * HA30_13;
  // H30 = P_b30 (HA30 - kK30 B30^T): HA less what the turn takes up [kg m]
  const T H30_21 = HA30_21 - kK30_2 * Hb31_11;
  const T H30_22 = Hb31_22 - kK30_2 * HA30_12;
  const T H30_23 = HA30_23 - kK30_2 * HA30_13;
  const T H30_31 = HA30_31 - kK30_3 * Hb31_11;
  const T H30_32 = HA30_32 - kK30_3 * HA30_12;
  const T minus_H30_33 = minus_Hb31_33 + kK30_3 * HA30_13;
  // J30 = P_b30 (JA30 - kK30 K30^T) P_b30: JA less what the turn takes up [kg m^2]
  const T J30_22 = JA30_22 - kK30_2 * JA30_12;
  const T J30_23 = JA30_23 - kK30_2 * JA30_13;
  const T J30_33 = JA30_33 - kK30_3 * JA30_13;
  // gt30 = g30 - v30 B30: force with the turn solved [N]
  const T gt30_1 = g30_1 - v30 * Hb31_11;
  const T gt30_2 = g30_2 - v30 * HA30_12;
  const T gt30_3 = g30_3 - v30 * HA30_13;
  // nt30 = -tau_body_30_ b30 + P_b30 (n30 - v30 K30): moment with the turn solved [N m]
  const T minus_nt30_2 = minus_n30_2 + v30 * JA30_12;
  const T nt30_3 = n30_3 - v30 * JA30_13;
  // Mp30 = E30^T M30 E30: M passed on, lower body's axes [kg]
  const T Mp30_12 = E30_22 * M30_12 - E30_23 * M30_13;
  const T Mp30_13 = E30_23 * M30_12 + E30_22 * M30_13;
  const T b30_1 = T(2) * E30_22;
  const T b30_2 = b30_1 * minus_M30_23 - E30_23 * (M30_22 - M30_33);
  const T b30_3 = E30_23 * b30_2;
  const T Mp30_22 = M30_22 + b30_3;
  const T Mp30_23 = minus_M30_23 - E30_22 * b30_2;
  const T Mp30_33 = M30_33 - b30_3;
  // gp30 = E30^T gt30: force passed on, lower body's axes [N]
  const T gp30_2 = E30_22 * gt30_2 - E30_23 * gt30_3;
  const T gp30_3 = E30_23 * gt30_2 + E30_22 * gt30_3;
  // Hp30 = E30^T H30 E30: H passed on, lower body's axes [kg m]
  const T Hp30_21 = E30_22 * H30_21 - E30_23 * H30_31;
  const T b30_4 = E30_23 * (H30_22 + minus_H30_33) + E30_22 * (H30_23 + H30_32);
  const T b30_5 = E30_23 * b30_4;
  const T Hp30_22 = H30_22 - b30_5;
  const T b30_6 = E30_22 * b30_4;
  const T Hp30_23 = b30_6 - H30_32;
  const T Hp30_31 = E30_23 * H30_21 + E30_22 * H30_31;
  const T Hp30_32 = b30_6 - H30_23;
  const T Hp30_33 = b30_5 - minus_H30_33;
  // Jp30 = E30^T J30 E30: J passed on, lower body's axes [kg m^2]
  const T b30_7 = E30_23 * (J30_22 - J30_33) + b30_1 * J30_23;
  const T b30_8 = E30_23 * b30_7;
  const T Jp30_22 = J30_22 - b30_8;
  const T Jp30_23 = E30_22 * b30_7 - J30_23;
  const T Jp30_33 = J30_33 + b30_8;
  // np30 = E30^T nt30: moment passed on, lower body's axes [N m]
  const T minus_np30_2 = E30_22 * minus_nt30_2 + E30_23 * nt30_3;
  const T np30_3 = E30_22 * nt30_3 - E30_23 * minus_nt30_2;
  // Hb30 = q30~ Mp30 + Hp30: H of the joint at the lower body's origin, its axes
  const T b30_9 = T(1.5) * Mp30_13;
  const T minus_b30_10 = T(0.2) * Mp30_12;
  const T Hb30_11 = b30_9 - minus_b30_10;
  const T Hb30_12 = T(1.5) * Mp30_23 - T(0.2) * Mp30_22;
  const T Hb30_13 = T(1.5) * Mp30_33 - T(0.2) * Mp30_23;
  const T Hb30_21 = Hp30_21 + T(0.2) * M30_11;
  const T Hb30_22 = Hp30_22 + minus_b30_10;
  const T Hb30_23 = Hp30_23 + T(0.2) * Mp30_13;
  const T Hb30_31 = Hp30_31 - T(1.5) * M30_11;
  const T Hb30_32 = Hp30_32 - T(1.5) * Mp30_12;
  const T Hb30_33 = Hp30_33 - b30_9;
  own[frame::v] = v30;
  own[frame::Mp_12] = Mp30_12;
  own[frame::Mp_22] = Mp30_22;
  own[frame::gp_2] = gp30_2;
  own[frame::Hp_21] = Hp30_21;
  own[frame::Hp_22] = Hp30_22;
  own[frame::Hp_23] = Hp30_23;
  own[frame::Jp_22] = Jp30_22;
  own[frame::np_2] = -minus_np30_2;
  own[frame::Hb_31] = Hb30_31;
  own[frame::Hb_32] = Hb30_32;
  own[frame::kB_1] = kB30_1;
  own[frame::kB_2] = kB30_2;
  own[frame::kB_3] = kB30_3;
  own[frame::kK_3] = kK30_3;
  own[frame::Mp_13] = Mp30_13;
  own[frame::Mp_33] = Mp30_33;
  own[frame::gp_3] = gp30_3;
  own[frame::Hp_31] = Hp30_31;
  own[frame::Hp_32] = Hp30_32;
  own[frame::Jp_33] = Jp30_33;
  own[frame::np_3] = np30_3;
  own[frame::Hb_11] = Hb30_11;
  own[frame::Hb_12] = Hb30_12;
  own[frame::Hb_13] = Hb30_13;
  own[frame::Hb_21] = Hb30_21;
  own[frame::Hb_22] = Hb30_22;
  own[frame::Hb_23] = Hb30_23;
  own[frame::kK_2] = kK30_2;
  own[frame::M_11] = M30_11;
  own[frame::gt_1] = gt30_1;
  own[frame::Mp_23] = Mp30_23;
  own[frame::Hp_33] = Hp30_33;
  own[frame::Jp_23] = Jp30_23;
  own[frame::Hb_33] = Hb30_33;
}

// bodies 29, 26, 23, 20, 17, 14, 11, 8, 5 and what they carry
template <class T>
[[gnu::noinline]] void inward_4(const T* inputs, T* frames, int row) noexcept {
  const auto& [J, K, u_at] = inward_4_places[row];
  const auto& k = inward_4_numbers<Number<T>>[row];
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T HbJ_13 = of_J[frame::Hb_13];
  const T HbJ_23 = of_J[frame::Hb_23];
  const T HbJ_31 = of_J[frame::Hb_31];
  const T HbJ_32 = of_J[frame::Hb_32];
  const T HbJ_12 = of_J[frame::Hb_12];
  const T HbJ_11 = of_J[frame::Hb_11];
  const T HpJ_22 = of_J[frame::Hp_22];
  const T HpJ_23 = of_J[frame::Hp_23];
  const T HpJ_32 = of_J[frame::Hp_32];
  const T HpJ_33 = of_J[frame::Hp_33];
  const T HbJ_21 = of_J[frame::Hb_21];
  const T HpJ_21 = of_J[frame::Hp_21];
  const T JpJ_22 = of_J[frame::Jp_22];
  const T HpJ_31 = of_J[frame::Hp_31];
  const T JpJ_23 = of_J[frame::Jp_23];
  const T JpJ_33 = of_J[frame::Jp_33];
  const T gtJ_1 = of_J[frame::gt_1];
  const T GK_1 = own[frame::G_1];
  const T gpJ_2 = of_J[frame::gp_2];
  const T GK_2 = own[frame::G_2];
  const T gpJ_3 = of_J[frame::gp_3];
  const T GK_3 = own[frame::G_3];
  const T tau_J = inputs[u_at];
  const T NK_1 = own[frame::N_1];
  const T npJ_2 = of_J[frame::np_2];
  const T NK_2 = own[frame::N_2];
  const T npJ_3 = of_J[frame::np_3];
  const T NK_3 = own[frame::N_3];
  const T HbJ_33 = of_J[frame::Hb_33];
  const T tau_K = inputs[u_at + 9];
  const T MJ_11 = of_J[frame::M_11];
  const T MpJ_12 = of_J[frame::Mp_12];
  const T MpJ_13 = of_J[frame::Mp_13];
  const T MpJ_22 = of_J[frame::Mp_22];
  const T MpJ_23 = of_J[frame::Mp_23];
  const T MpJ_33 = of_J[frame::Mp_33];
  const T HbJ_22 = of_J[frame::Hb_22];
  const T EK_12 = own[frame::E_12];
  const T EK_11 = own[frame::E_11];
  // HAK = h_own_K~ + HbJ: moment for an acceleration of the origin, body axes [kg m]
  const T HAK_13 = T(k[0]) + HbJ_13;
  const T HAK_23 = HbJ_23 + T(k[1]);
  const T HAK_31 = HbJ_31 + T(k[2]);
  const T HAK_32 = T(k[3]) + HbJ_32;
  // JAK = qJ~ HpJ^T + J_own_K + JpJ - HbJ qJ~: moment for an angular acceleration, body axes [kg m^2]
  const T JAK_11 = HbJ_13 * T(k[4]) - HbJ_12 * T(0.2);
  const T JAK_12 = T(k[4]) * HpJ_23 + T(k[5]) - T(0.2) * HpJ_22 + HbJ_11 * T(0.2);
  const T JAK_13 = T(k[4]) * HpJ_33 + T(k[7]) - T(0.2) * HpJ_32 + HbJ_11 * T(k[6]);
  const T JAK_22 = JpJ_22 + T(k[8]) + T(0.2) * HpJ_21 + HbJ_21 * T(0.2);
  const T JAK_23 = JpJ_23 + T(k[9]) + T(0.2) * HpJ_31 + HbJ_21 * T(k[6]);
  const T JAK_33 = T(k[10]) + JpJ_33 + T(k[6]) * HpJ_31 + HbJ_31 * T(k[6]);
  // gK = GK + gpJ: force that drives it, home axes [N]
  const T gK_1 = gtJ_1 + GK_1;
  const T gK_2 = gpJ_2 + GK_2;
  const T gK_3 = gpJ_3 + GK_3;
  // nK = qJ~ gpJ + NK + npJ: moment that drives it, body axes [N m]
  const T minus_nK_1 = tau_J - NK_1 + T(k[6]) * gpJ_3 + T(0.2) * gpJ_2;
  const T nK_2 = npJ_2 + NK_2 + T(0.2) * gtJ_1;
  const T nK_3 = npJ_3 + NK_3 + T(k[6]) * gtJ_1;
  // invDK = DK^-1: 1/D
  const T invDK = T(1) / JAK_33;
  // kBK = invDK BK: B/D
  const T kBK_1 = invDK * HAK_31;
  const T kBK_2 = invDK * HAK_32;
  const T kBK_3 = invDK * HbJ_33;
  // kKK = invDK KK: K/D
  const T kKK_1 = invDK * JAK_13;
  const T kKK_2 = invDK * JAK_23;
  // u_K = bK . nK + tau_body_K_: drives it [N m], [N]
  const T u_K = nK_3 + tau_K;
  // vK = invDK u_K: u/D
  const T vK = invDK * u_K;
  // MK = MpJ - kBK BK^T: MA less what the turn takes up [kg]
  const T MK_11 = MJ_11 - kBK_1 * HAK_31;
  const T MK_12 = MpJ_12 - kBK_1 * HAK_32;
  const T MK_13 = MpJ_13 - kBK_1 * HbJ_33;
  const T MK_22 = MpJ_22 - kBK_2 * HAK_32;
  const T MK_23 = MpJ_23 - kBK_2 * HbJ_33;
  const T MK_33 = MpJ_33 - kBK_3 * HbJ_33;
  // HK = P_bK (HAK - kKK BK^T): HA less what the turn takes up [kg m]
  const T HK_11 = HbJ_11 - kKK_1 * HAK_31;
  const T HK_12 = HbJ_12 - kKK_1 * HAK_32;
  const T HK_13 = HAK_13 - kKK_1 * HbJ_33;
  const T HK_21 = HbJ_21 - kKK_2 * HAK_31;
  const T HK_22 = HbJ_22 - kKK_2 * HAK_32;
  const T HK_23 = HAK_23 - kKK_2 * HbJ_33;
  // JK = P_bK (JAK - kKK KK^T) P_bK: JA less what the turn takes up [kg m^2]
  const T JK_11 = JAK_11 - kKK_1 * JAK_13;
  const T JK_12 = JAK_12 - kKK_1 * JAK_23;
  const T JK_22 = JAK_22 - kKK_2 * JAK_23;
  // gtK = gK - vK BK: force with the turn solved [N]
  const T gtK_1 = gK_1 - vK * HAK_31;
  const T gtK_2 = gK_2 - vK * HAK_32;
  const T gtK_3 = gK_3 - vK * HbJ_33;
  // ntK = -tau_body_K_ bK + P_bK (nK - vK KK): moment with the turn solved [N m]
  const T minus_ntK_1 = minus_nK_1 + vK * JAK_13;
  const T ntK_2 = nK_2 - vK * JAK_23;
  // MpK = EK^T MK EK: M passed on, lower body's axes [kg]
  const T bK_1 = T(2) * EK_11;
  const T bK_2 = EK_12 * (MK_11 - MK_22) + bK_1 * MK_12;
  const T bK_3 = EK_12 * bK_2;
  const T MpK_11 = MK_11 - bK_3;
  const T MpK_12 = EK_11 * bK_2 - MK_12;
  const T MpK_13 = EK_11 * MK_13 - EK_12 * MK_23;
  const T MpK_22 = MK_22 + bK_3;
  const T MpK_23 = EK_12 * MK_13 + EK_11 * MK_23;
  // gpK = EK^T gtK: force passed on, lower body's axes [N]
  const T gpK_1 = EK_11 * gtK_1 - EK_12 * gtK_2;
  const T gpK_2 = EK_12 * gtK_1 + EK_11 * gtK_2;
  // HpK = EK^T HK EK: H passed on, lower body's axes [kg m]
  const T bK_4 = EK_12 * (HK_11 - HK_22) + EK_11 * (HK_12 + HK_21);
  const T bK_5 = EK_12 * bK_4;
  const T HpK_11 = HK_11 - bK_5;
  const T bK_6 = EK_11 * bK_4;
  const T HpK_12 = bK_6 - HK_21;
  const T HpK_13 = EK_11 * HK_13 - EK_12 * HK_23;
  const T HpK_21 = bK_6 - HK_12;
  const T HpK_22 = HK_22 + bK_5;
  const T HpK_23 = EK_12 * HK_13 + EK_11 * HK_23;
  // JpK = EK^T JK EK: J passed on, lower body's axes [kg m^2]
  const T bK_7 = bK_1 * JK_12 + EK_12 * (JK_11 - JK_22);
  const T bK_8 = EK_12 * bK_7;
  const T JpK_11 = JK_11 - bK_8;
  const T JpK_12 = EK_11 * bK_7 - JK_12;
  const T JpK_22 = JK_22 + bK_8;
  // npK = EK^T ntK: moment passed on, lower body's axes [N m]
  const T minus_npK_1 = EK_11 * minus_ntK_1 + EK_12 * ntK_2;
  const T npK_2 = EK_11 * ntK_2 - EK_12 * minus_ntK_1;
  // HbK = qK~ MpK + HpK: H of the joint at the lower body's origin, its axes
  const T bK_9 = T(k[11]) * MpK_13;
  const T HbK_11 = HpK_11 - bK_9;
  const T HbK_12 = HpK_12 + T(k[12]) * MpK_23;
  const T HbK_13 = HpK_13 + T(k[12]) * MK_33;
  const T HbK_21 = HpK_21 - T(0.3) * MpK_13;
  const T bK_10 = T(0.3) * MpK_23;
  const T HbK_22 = HpK_22 - bK_10;
  const T HbK_23 = HpK_23 - T(0.3) * MK_33;
  const T HbK_31 = T(0.3) * MpK_12 + T(k[11]) * MpK_11;
  const T HbK_32 = T(0.3) * MpK_22 + T(k[11]) * MpK_12;
  const T HbK_33 = bK_10 + bK_9;
  own[frame::v] = vK;
  own[frame::Mp_12] = MpK_12;
  own[frame::Mp_22] = MpK_22;
  own[frame::gp_1] = gpK_1;
  own[frame::gp_2] = gpK_2;
  own[frame::Hp_13] = HpK_13;
  own[frame::Hp_23] = HpK_23;
  own[frame::Jp_11] = JpK_11;
  own[frame::Jp_12] = JpK_12;
  own[frame::Jp_22] = JpK_22;
  own[frame::np_1] = -minus_npK_1;
  own[frame::np_2] = npK_2;
  own[frame::Hb_31] = HbK_31;
  own[frame::Hb_32] = HbK_32;
  own[frame::kB_1] = kBK_1;
  own[frame::kB_2] = kBK_2;
  own[frame::kB_3] = kBK_3;
  own[frame::kK_1] = kKK_1;
  own[frame::Mp_13] = MpK_13;
  own[frame::Hb_11] = HbK_11;
  own[frame::Hb_12] = HbK_12;
  own[frame::Hb_13] = HbK_13;
  own[frame::Hb_21] = HbK_21;
  own[frame::Hb_22] = HbK_22;
  own[frame::Hb_23] = HbK_23;
  own[frame::kK_2] = kKK_2;
  own[frame::Mp_23] = MpK_23;
  own[frame::Hb_33] = HbK_33;
  own[frame::M_33] = MK_33;
  own[frame::gt_3] = gtK_3;
  own[frame::Mp_11] = MpK_11;
}

// bodies 28, 25, 22, 19, 16, 13, 10, 7, 4 and what they carry
template <class T>
[[gnu::noinline]] void inward_5(const T* inputs, T* frames, int row) noexcept {
  const auto& [J, K, u_at] = inward_5_places[row];
  const auto& k = inward_5_numbers<Number<T>>[row];
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T HbJ_12 = of_J[frame::Hb_12];
  const T HbJ_21 = of_J[frame::Hb_21];
  const T HbJ_23 = of_J[frame::Hb_23];
  const T HbJ_32 = of_J[frame::Hb_32];
  const T HbJ_13 = of_J[frame::Hb_13];
  const T HpJ_13 = of_J[frame::Hp_13];
  const T JpJ_11 = of_J[frame::Jp_11];
  const T HpJ_23 = of_J[frame::Hp_23];
  const T JpJ_12 = of_J[frame::Jp_12];
  const T HbJ_11 = of_J[frame::Hb_11];
  const T JpJ_22 = of_J[frame::Jp_22];
  const T HbJ_22 = of_J[frame::Hb_22];
  const T HbJ_31 = of_J[frame::Hb_31];
  const T gpJ_1 = of_J[frame::gp_1];
  const T GK_1 = own[frame::G_1];
  const T gpJ_2 = of_J[frame::gp_2];
  const T GK_2 = own[frame::G_2];
  const T gtJ_3 = of_J[frame::gt_3];
  const T GK_3 = own[frame::G_3];
  const T npJ_1 = of_J[frame::np_1];
  const T NK_1 = own[frame::N_1];
  const T npJ_2 = of_J[frame::np_2];
  const T NK_2 = own[frame::N_2];
  const T tau_J = inputs[u_at];
  const T NK_3 = own[frame::N_3];
  const T tau_K = inputs[u_at + 9];
  const T MpJ_11 = of_J[frame::Mp_11];
  const T MpJ_12 = of_J[frame::Mp_12];
  const T MpJ_13 = of_J[frame::Mp_13];
  const T MpJ_22 = of_J[frame::Mp_22];
  const T MpJ_23 = of_J[frame::Mp_23];
  const T MJ_33 = of_J[frame::M_33];
  const T HbJ_33 = of_J[frame::Hb_33];
  const T EK_11 = own[frame::E_11];
  const T minus_EK_13 = own[frame::minus_E_13];
  // HAK = h_own_K~ + HbJ: moment for an acceleration of the origin, body axes [kg m]
  const T HAK_12 = HbJ_12 + T(k[0]);
  const T HAK_21 = T(k[1]) + HbJ_21;
  const T HAK_23 = HbJ_23 + T(k[2]);
  const T HAK_32 = T(k[3]) + HbJ_32;
  // JAK = qJ~ HpJ^T + J_own_K + JpJ - HbJ qJ~: moment for an angular acceleration, body axes [kg m^2]
  const T JAK_11 = T(k[5]) + JpJ_11 + T(k[4]) * HpJ_13 + HbJ_13 * T(k[4]);
  const T JAK_12 = JpJ_12 + T(k[6]) + T(k[4]) * HpJ_23 - HbJ_13 * T(0.3);
  const T JAK_13 = T(k[8]) + HbJ_11 * T(k[7]) + HbJ_12 * T(0.3);
  const T JAK_22 = T(k[9]) + JpJ_22 - T(0.3) * HpJ_23 - HbJ_23 * T(0.3);
  const T JAK_23 = T(k[10]) + HbJ_21 * T(k[7]) + HbJ_22 * T(0.3);
  const T JAK_33 = HbJ_31 * T(k[7]) + HbJ_32 * T(0.3);
  // gK = GK + gpJ: force that drives it, home axes [N]
  const T gK_1 = gpJ_1 + GK_1;
  const T gK_2 = gpJ_2 + GK_2;
  const T gK_3 = gtJ_3 + GK_3;
  // nK = qJ~ gpJ + NK + npJ: moment that drives it, body axes [N m]
  const T nK_1 = npJ_1 + NK_1 + T(k[4]) * gtJ_3;
  const T nK_2 = npJ_2 + NK_2 - T(0.3) * gtJ_3;
  const T nK_3 = T(k[7]) * gpJ_1 - (tau_J - NK_3 - T(0.3) * gpJ_2);
  // invDK = DK^-1: 1/D
  const T invDK = T(1) / JAK_22;
  // kBK = invDK BK: B/D
  const T kBK_1 = invDK * HAK_21;
  const T kBK_2 = invDK * HbJ_22;
  const T kBK_3 = invDK * HAK_23;
  // kKK = invDK KK: K/D
  const T kKK_1 = invDK * JAK_12;
  const T kKK_3 = invDK * JAK_23;
  // u_K = bK . nK + tau_body_K_: drives it [N m], [N]
  const T u_K = nK_2 + tau_K;
  // vK = invDK u_K: u/D
  const T vK = invDK * u_K;
  // MK = MpJ - kBK BK^T: MA less what the turn takes up [kg]
  const T MK_11 = MpJ_11 - kBK_1 * HAK_21;
  const T MK_12 = MpJ_12 - kBK_1 * HbJ_22;
  const T MK_13 = MpJ_13 - kBK_1 * HAK_23;
  const T MK_22 = MpJ_22 - kBK_2 * HbJ_22;
  const T MK_23 = MpJ_23 - kBK_2 * HAK_23;
  const T MK_33 = MJ_33 - kBK_3 * HAK_23;
  // HK = P_bK (HAK - kKK BK^T): HA less what the turn takes up [kg m]
  const T HK_11 = HbJ_11 - kKK_1 * HAK_21;
  const T HK_12 = HAK_12 - kKK_1 * HbJ_22;
  const T HK_13 = HbJ_13 - kKK_1 * HAK_23;
  const T HK_31 = HbJ_31 - kKK_3 * HAK_21;
  const T HK_32 = HAK_32 - kKK_3 * HbJ_22;
  const T HK_33 = HbJ_33 - kKK_3 * HAK_23;
  // JK = P_bK (JAK - kKK KK^T) P_bK: JA less what the turn takes up [kg m^2]
  const T JK_11 = JAK_11 - kKK_1 * JAK_12;
  const T JK_13 = JAK_13 - kKK_1 * JAK_23;
  const T JK_33 = JAK_33 - kKK_3 * JAK_23;
  // gtK = gK - vK BK: force with the turn solved [N]
  const T gtK_1 = gK_1 - vK * HAK_21;
  const T gtK_2 = gK_2 - vK * HbJ_22;
  const T gtK_3 = gK_3 - vK * HAK_23;
  // ntK = -tau_body_K_ bK + P_bK (nK - vK KK): moment with the turn solved [N m]
  const T ntK_1 = nK_1 - vK * JAK_12;
  const T ntK_3 = nK_3 - vK * JAK_23;
  // MpK = EK^T MK EK: M passed on, lower body's axes [kg]
  const T bK_1 = T(2) * EK_11;
  const T bK_2 = bK_1 * MK_13 - minus_EK_13 * (MK_11 - MK_33);
  const T bK_3 = minus_EK_13 * bK_2;
  const T MpK_11 = MK_11 + bK_3;
  const T MpK_12 = minus_EK_13 * MK_23 + EK_11 * MK_12;
  const T MpK_13 = EK_11 * bK_2 - MK_13;
  const T MpK_23 = EK_11 * MK_23 - minus_EK_13 * MK_12;
  const T MpK_33 = MK_33 - bK_3;
  // gpK = EK^T gtK: force passed on, lower body's axes [N]
  const T gpK_1 = EK_11 * gtK_1 + minus_EK_13 * gtK_3;
  const T gpK_3 = EK_11 * gtK_3 - minus_EK_13 * gtK_1;
  // HpK = EK^T HK EK: H passed on, lower body's axes [kg m]
  const T bK_4 = EK_11 * (HK_31 + HK_13) - minus_EK_13 * (HK_11 - HK_33);
  const T bK_5 = minus_EK_13 * bK_4;
  const T HpK_11 = HK_11 + bK_5;
  const T HpK_12 = minus_EK_13 * HK_32 + EK_11 * HK_12;
  const T bK_6 = EK_11 * bK_4;
  const T HpK_13 = bK_6 - HK_31;
  const T HpK_31 = bK_6 - HK_13;
  const T HpK_32 = EK_11 * HK_32 - minus_EK_13 * HK_12;
  const T HpK_33 = HK_33 - bK_5;
  // JpK = EK^T JK EK: J passed on, lower body's axes [kg m^2]
  const T bK_7 = bK_1 * JK_13 - minus_EK_13 * (JK_11 - JK_33);
  const T bK_8 = minus_EK_13 * bK_7;
  const T JpK_11 = JK_11 + bK_8;
  const T JpK_13 = EK_11 * bK_7 - JK_13;
  const T JpK_33 = JK_33 - bK_8;
  // npK = EK^T ntK: moment passed on, lower body's axes [N m]
  const T npK_1 = EK_11 * ntK_1 + minus_EK_13 * ntK_3;
  const T npK_3 = EK_11 * ntK_3 - minus_EK_13 * ntK_1;
  // HbK = qK~ MpK + HpK: H of the joint at the lower body's origin, its axes
  const T bK_9 = T(0.1) * MpK_12;
  const T HbK_11 = HpK_11 - bK_9;
  const T HbK_12 = HpK_12 - T(0.1) * MK_22;
  const T HbK_13 = HpK_13 - T(0.1) * MpK_23;
  const T HbK_21 = T(0.1) * MpK_11 - T(0.6) * MpK_13;
  const T minus_bK_10 = T(0.6) * MpK_23;
  const T HbK_22 = bK_9 - minus_bK_10;
  const T HbK_23 = T(0.1) * MpK_13 - T(0.6) * MpK_33;
  const T HbK_31 = HpK_31 + T(0.6) * MpK_12;
  const T HbK_32 = HpK_32 + T(0.6) * MK_22;
  const T HbK_33 = HpK_33 + minus_bK_10;
  own[frame::v] = vK;
  own[frame::Mp_12] = MpK_12;
  own[frame::gp_1] = gpK_1;
  own[frame::Hp_12] = HpK_12;
  own[frame::Jp_11] = JpK_11;
  own[frame::np_1] = npK_1;
  own[frame::Hb_31] = HbK_31;
  own[frame::Hb_32] = HbK_32;
  own[frame::kB_1] = kBK_1;
  own[frame::kB_2] = kBK_2;
  own[frame::kB_3] = kBK_3;
  own[frame::kK_1] = kKK_1;
  own[frame::kK_3] = kKK_3;
  own[frame::M_22] = MK_22;
  own[frame::gt_2] = gtK_2;
  own[frame::Mp_13] = MpK_13;
  own[frame::Mp_33] = MpK_33;
  own[frame::gp_3] = gpK_3;
  own[frame::Hp_31] = HpK_31;
  own[frame::Hp_32] = HpK_32;
  own[frame::Jp_13] = JpK_13;
  own[frame::Jp_33] = JpK_33;
  own[frame::np_3] = npK_3;
  own[frame::Hb_11] = HbK_11;
  own[frame::Hb_12] = HbK_12;
  own[frame::Hb_13] = HbK_13;
  own[frame::Hb_21] = HbK_21;
  own[frame::Hb_22] = HbK_22;
  own[frame::Hb_23] = HbK_23;
  own[frame::Mp_23] = MpK_23;
  own[frame::Hp_33] = HpK_33;
  own[frame::Hb_33] = HbK_33;
  own[frame::Mp_11] = MpK_11;
}

// bodies 27, 24, 21, 18, 15, 12, 9, 6 and what they carry
template <class T>
[[gnu::noinline]] void inward_6(const T* inputs, T* frames, int row) noexcept {
  const auto& [J, K, u_at] = inward_6_places[row];
  const auto& k = inward_6_numbers<Number<T>>[row];
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T MpJ_11 = of_J[frame::Mp_11];
  const T MJ_22 = of_J[frame::M_22];
  const T MpJ_33 = of_J[frame::Mp_33];
  const T HbJ_12 = of_J[frame::Hb_12];
  const T HbJ_13 = of_J[frame::Hb_13];
  const T HbJ_21 = of_J[frame::Hb_21];
  const T HbJ_23 = of_J[frame::Hb_23];
  const T HbJ_31 = of_J[frame::Hb_31];
  const T HbJ_32 = of_J[frame::Hb_32];
  const T HpJ_12 = of_J[frame::Hp_12];
  const T JpJ_11 = of_J[frame::Jp_11];
  const T HbJ_11 = of_J[frame::Hb_11];
  const T HpJ_32 = of_J[frame::Hp_32];
  const T JpJ_13 = of_J[frame::Jp_13];
  const T HbJ_22 = of_J[frame::Hb_22];
  const T HpJ_33 = of_J[frame::Hp_33];
  const T HpJ_31 = of_J[frame::Hp_31];
  const T JpJ_33 = of_J[frame::Jp_33];
  const T gpJ_1 = of_J[frame::gp_1];
  const T GK_1 = own[frame::G_1];
  const T gtJ_2 = of_J[frame::gt_2];
  const T GK_2 = own[frame::G_2];
  const T gpJ_3 = of_J[frame::gp_3];
  const T GK_3 = own[frame::G_3];
  const T npJ_1 = of_J[frame::np_1];
  const T NK_1 = own[frame::N_1];
  const T tau_J = inputs[u_at + 17];
  const T NK_2 = own[frame::N_2];
  const T npJ_3 = of_J[frame::np_3];
  const T NK_3 = own[frame::N_3];
  const T tau_K = inputs[u_at];
  const T MpJ_12 = of_J[frame::Mp_12];
  const T MpJ_13 = of_J[frame::Mp_13];
  const T MpJ_23 = of_J[frame::Mp_23];
  const T HbJ_33 = of_J[frame::Hb_33];
  const T EK_22 = own[frame::E_22];
  const T EK_23 = own[frame::E_23];
  // MAK = m_all_K one + MpJ: force for an acceleration of the origin, home axes [kg]
  const T MAK_11 = T(k[0]) + MpJ_11;
  const T MAK_22 = T(k[0]) + MJ_22;
  const T MAK_33 = T(k[0]) + MpJ_33;
  // HAK = h_all_K~ + HbJ: moment for an acceleration of the origin, body axes [kg m]
  const T HAK_12 = HbJ_12 + T(k[1]);
  const T HAK_13 = T(k[2]) + HbJ_13;
  const T HAK_21 = T(k[3]) + HbJ_21;
  const T HAK_23 = HbJ_23 + T(k[4]);
  const T HAK_31 = HbJ_31 + T(k[5]);
  const T HAK_32 = T(k[6]) + HbJ_32;
  // JAK = qJ~ HpJ^T + J_all_K + JpJ - HbJ qJ~: moment for an angular acceleration, body axes [kg m^2]
  const T JAK_11 = T(k[7]) + JpJ_11 - T(0.1) * HpJ_12 - HbJ_12 * T(0.1);
  const T JAK_12 = T(k[8]) - HbJ_13 * T(0.6) + HbJ_11 * T(0.1);
  const T JAK_13 = JpJ_13 + T(k[9]) - T(0.1) * HpJ_32 + HbJ_12 * T(0.6);
  const T JAK_22 = T(k[10]) + HbJ_21 * T(0.1) - HbJ_23 * T(0.6);
  const T JAK_23 = T(0.1) * HpJ_31 + T(k[11]) - T(0.6) * HpJ_33 + HbJ_22 * T(0.6);
  const T JAK_33 = T(k[12]) + JpJ_33 + T(0.6) * HpJ_32 + HbJ_32 * T(0.6);
  // gK = GK + gpJ: force that drives it, home axes [N]
  const T gK_1 = gpJ_1 + GK_1;
  const T gK_2 = gtJ_2 + GK_2;
  const T gK_3 = gpJ_3 + GK_3;
  // nK = qJ~ gpJ + NK + npJ: moment that drives it, body axes [N m]
  const T nK_1 = npJ_1 + NK_1 - T(0.1) * gtJ_2;
  const T minus_nK_2 = tau_J - NK_2 - T(0.1) * gpJ_1 + T(0.6) * gpJ_3;
  const T nK_3 = npJ_3 + NK_3 + T(0.6) * gtJ_2;
  // invDK = DK^-1: 1/D
  const T invDK = T(1) / JAK_11;
  // kBK = invDK BK: B/D
  const T kBK_1 = invDK * HbJ_11;
  const T kBK_2 = invDK * HAK_12;
  const T kBK_3 = invDK * HAK_13;
  // kKK = invDK KK: K/D
  const T kKK_2 = invDK * JAK_12;
  const T kKK_3 = invDK * JAK_13;
  // u_K = bK . nK + tau_body_K_: drives it [N m], [N]
  const T u_K = nK_1 + tau_K;
  // vK = invDK u_K: u/D
  const T vK = invDK * u_K;
  // MK = MAK - kBK BK^T: MA less what the turn takes up [kg]
  const T MK_11 = MAK_11 - kBK_1 * HbJ_11;
  const T MK_12 = MpJ_12 - kBK_1 * HAK_12;
  const T MK_13 = MpJ_13 - kBK_1 * HAK_13;
  const T MK_22 = MAK_22 - kBK_2 * HAK_12;
  const T MK_23 = MpJ_23 - kBK_2 * HAK_13;
  const T MK_33 = MAK_33 - kBK_3 * HAK_13;
  // HK = P_bK (HAK - kKK BK^T): HA less what the turn takes up [kg m]
  const T HK_21 = HAK_21 - kKK_2 * HbJ_11;
  const T HK_22 = HbJ_22 - kKK_2 * HAK_12;
  const T HK_23 = HAK_23 - kKK_2 * HAK_13;
  const T HK_31 = HAK_31 - kKK_3 * HbJ_11;
  const T HK_32 = HAK_32 - kKK_3 * HAK_12;
  const T HK_33 = HbJ_33 - kKK_3 * HAK_13;
  // JK = P_bK (JAK - kKK KK^T) P_bK: JA less what the turn takes up [kg m^2]
  const T JK_22 = JAK_22 - kKK_2 * JAK_12;
  const T JK_23 = JAK_23 - kKK_2 * JAK_13;
  const T JK_33 = JAK_33 - kKK_3 * JAK_13;
  // gtK = gK - vK BK: force with the turn solved [N]
  const T gtK_1 = gK_1 - vK * HbJ_11;
  const T gtK_2 = gK_2 - vK * HAK_12;
  const T gtK_3 = gK_3 - vK * HAK_13;
  // ntK = -tau_body_K_ bK + P_bK (nK - vK KK): moment with the turn solved [N m]
  const T minus_ntK_2 = minus_nK_2 + vK * JAK_12;
  const T ntK_3 = nK_3 - vK * JAK_13;
  // MpK = EK^T MK EK: M passed on, lower body's axes [kg]
  const T MpK_12 = EK_22 * MK_12 - EK_23 * MK_13;
  const T MpK_13 = EK_23 * MK_12 + EK_22 * MK_13;
  const T bK_1 = T(2) * EK_22;
  const T bK_2 = EK_23 * (MK_22 - MK_33) + bK_1 * MK_23;
  const T bK_3 = EK_23 * bK_2;
  const T MpK_22 = MK_22 - bK_3;
  const T MpK_23 = EK_22 * bK_2 - MK_23;
  const T MpK_33 = MK_33 + bK_3;
  // gpK = EK^T gtK: force passed on, lower body's axes [N]
  const T gpK_2 = EK_22 * gtK_2 - EK_23 * gtK_3;
  const T gpK_3 = EK_23 * gtK_2 + EK_22 * gtK_3;
  // HpK = EK^T HK EK: H passed on, lower body's axes [kg m]
  const T HpK_21 = EK_22 * HK_21 - EK_23 * HK_31;
  const T bK_4 = EK_23 * (HK_22 - HK_33) + EK_22 * (HK_23 + HK_32);
  const T bK_5 = EK_23 * bK_4;
  const T HpK_22 = HK_22 - bK_5;
  const T bK_6 = EK_22 * bK_4;
  const T HpK_23 = bK_6 - HK_32;
  const T HpK_31 = EK_23 * HK_21 + EK_22 * HK_31;
  const T HpK_32 = bK_6 - HK_23;
  const T HpK_33 = HK_33 + bK_5;
  // JpK = EK^T JK EK: J passed on, lower body's axes [kg m^2]
  const T bK_7 = EK_23 * (JK_22 - JK_33) + bK_1 * JK_23;
  const T bK_8 = EK_23 * bK_7;
  const T JpK_22 = JK_22 - bK_8;
  const T JpK_23 = EK_22 * bK_7 - JK_23;
  const T JpK_33 = JK_33 + bK_8;
  // npK = EK^T ntK: moment passed on, lower body's axes [N m]
  const T minus_npK_2 = EK_22 * minus_ntK_2 + EK_23 * ntK_3;
  const T npK_3 = EK_22 * ntK_3 - EK_23 * minus_ntK_2;
  // HbK = qK~ MpK + HpK: H of the joint at the lower body's origin, its axes
  const T bK_9 = T(k[13]) * MpK_13;
  const T minus_bK_10 = T(0.2) * MpK_12;
  const T HbK_11 = bK_9 - minus_bK_10;
  const T HbK_12 = T(k[13]) * MpK_23 - T(0.2) * MpK_22;
  const T HbK_13 = T(k[13]) * MpK_33 - T(0.2) * MpK_23;
  const T HbK_21 = HpK_21 + T(0.2) * MK_11;
  const T HbK_22 = HpK_22 + minus_bK_10;
  const T HbK_23 = HpK_23 + T(0.2) * MpK_13;
  const T HbK_31 = HpK_31 + T(k[14]) * MK_11;
  const T HbK_32 = HpK_32 + T(k[14]) * MpK_12;
  const T HbK_33 = HpK_33 - bK_9;
  own[frame::v] = vK;
  own[frame::Mp_12] = MpK_12;
  own[frame::Mp_22] = MpK_22;
  own[frame::gp_2] = gpK_2;
  own[frame::Hp_21] = HpK_21;
  own[frame::Hp_22] = HpK_22;
  own[frame::Hp_23] = HpK_23;
  own[frame::Jp_22] = JpK_22;
  own[frame::np_2] = -minus_npK_2;
  own[frame::Hb_31] = HbK_31;
  own[frame::Hb_32] = HbK_32;
  own[frame::kB_1] = kBK_1;
  own[frame::kB_2] = kBK_2;
  own[frame::kB_3] = kBK_3;
  own[frame::kK_3] = kKK_3;
  own[frame::Mp_13] = MpK_13;
  own[frame::Mp_33] = MpK_33;
  own[frame::gp_3] = gpK_3;
  own[frame::Hp_31] = HpK_31;
  own[frame::Hp_32] = HpK_32;
  own[frame::Jp_33] = JpK_33;
  own[frame::np_3] = npK_3;
  own[frame::Hb_11] = HbK_11;
  own[frame::Hb_12] = HbK_12;
  own[frame::Hb_13] = HbK_13;
  own[frame::Hb_21] = HbK_21;
  own[frame::Hb_22] = HbK_22;
  own[frame::Hb_23] = HbK_23;
  own[frame::kK_2] = kKK_2;
  own[frame::M_11] = MK_11;
  own[frame::gt_1] = gtK_1;
  own[frame::Mp_23] = MpK_23;
  own[frame::Hp_33] = HpK_33;
  own[frame::Jp_23] = JpK_23;
  own[frame::Hb_33] = HbK_33;
}

// body 3 and what they carry
template <class T>
[[gnu::noinline]] void inward_7(const Inputs<T>& u, T* frames) noexcept {
  const T* const of_4 = frames + 162;
  T* const own = frames + 97;
  const T Mp4_11 = of_4[frame::Mp_11];
  const T M4_22 = of_4[frame::M_22];
  const T Mp4_33 = of_4[frame::Mp_33];
  const T Hb4_12 = of_4[frame::Hb_12];
  const T Hb4_13 = of_4[frame::Hb_13];
  const T Hb4_21 = of_4[frame::Hb_21];
  const T Hb4_23 = of_4[frame::Hb_23];
  const T Hb4_31 = of_4[frame::Hb_31];
  const T Hb4_32 = of_4[frame::Hb_32];
  const T Hp4_12 = of_4[frame::Hp_12];
  const T Jp4_11 = of_4[frame::Jp_11];
  const T Hb4_11 = of_4[frame::Hb_11];
  const T Hp4_32 = of_4[frame::Hp_32];
  const T Jp4_13 = of_4[frame::Jp_13];
  const T Hb4_22 = of_4[frame::Hb_22];
  const T Hp4_33 = of_4[frame::Hp_33];
  const T Hp4_31 = of_4[frame::Hp_31];
  const T Jp4_33 = of_4[frame::Jp_33];
  const T gp4_1 = of_4[frame::gp_1];
  const T G3_1 = own[frame::G_1];
  const T gt4_2 = of_4[frame::gt_2];
  const T G3_2 = own[frame::G_2];
  const T gp4_3 = of_4[frame::gp_3];
  const T G3_3 = own[frame::G_3];
  const T np4_1 = of_4[frame::np_1];
  const T N3_1 = own[frame::N_1];
  const T N3_2 = own[frame::N_2];
  const T np4_3 = of_4[frame::np_3];
  const T N3_3 = own[frame::N_3];
  const T Mp4_12 = of_4[frame::Mp_12];
  const T Mp4_13 = of_4[frame::Mp_13];
  const T Mp4_23 = of_4[frame::Mp_23];
  const T Hb4_33 = of_4[frame::Hb_33];
  const T E3_22 = own[frame::E_22];
  const T E3_23 = own[frame::E_23];
  // MA3 = m_all_3 one + Mp4: force for an acceleration of the origin, home axes [kg]
  const T MA3_11 = T(4.2) + Mp4_11;
  const T MA3_22 = T(4.2) + M4_22;
  const T MA3_33 = T(4.2) + Mp4_33;
  // HA3 = h_all_3~ + Hb4: moment for an acceleration of the origin, body axes [kg m]
  const T HA3_12 = Hb4_12 - T(0.35500000000000004);
  const T HA3_13 = T(1.495) + Hb4_13;
  const T HA3_21 = T(0.35500000000000004) + Hb4_21;
  const T HA3_23 = Hb4_23 - T(2.26);
  const T HA3_31 = Hb4_31 - T(1.495);
  const T HA3_32 = T(2.26) + Hb4_32;
  // JA3 = q4~ Hp4^T + J_all_3 + Jp4 - Hb4 q4~: moment for an angular acceleration, body axes [kg m^2]
  const T JA3_11 = T(1.0030000000000001) + Jp4_11 - T(0.1) * Hp4_12 - Hb4_12 * T(0.1);
  const T JA3_12 = Hb4_11 * T(0.1) - (T(0.8385) + Hb4_13 * T(0.6));
  const T JA3_13 = Jp4_13 - T(0.1961) - T(0.1) * Hp4_32 + Hb4_12 * T(0.6);
  const T JA3_22 = T(1.4402499999999998) + Hb4_21 * T(0.1) - Hb4_23 * T(0.6);
  const T JA3_23 = T(0.1) * Hp4_31 - T(0.14170000000000002) - T(0.6) * Hp4_33 + Hb4_22 * T(0.6);
  const T JA3_33 = T(2.1967499999999998) + Jp4_33 + T(0.6) * Hp4_32 + Hb4_32 * T(0.6);
  // g3 = G3 + gp4: force that drives it, home axes [N]
  const T g3_1 = gp4_1 + G3_1;
  const T g3_2 = gt4_2 + G3_2;
  const T g3_3 = gp4_3 + G3_3;
  // n3 = q4~ gp4 + N3 + np4: moment that drives it, body axes [N m]
  const T n3_1 = np4_1 + N3_1 - T(0.1) * gt4_2;
  const T minus_n3_2 = u.tau_4 - N3_2 - T(0.1) * gp4_1 + T(0.6) * gp4_3;
  const T n3_3 = np4_3 + N3_3 + T(0.6) * gt4_2;
  // invD3 = D3^-1: 1/D
  const T invD3 = T(1) / JA3_11;
  // kB3 = invD3 B3: B/D
  const T kB3_1 = invD3 * Hb4_11;
  const T kB3_2 = invD3 * HA3_12;
  const T kB3_3 = invD3 * HA3_13;
  // kK3 = invD3 K3: K/D
  const T kK3_2 = invD3 * JA3_12;
  const T kK3_3 = invD3 * JA3_13;
  // u_3 = b3 . n3 + tau_body_3_: drives it [N m], [N]
  const T u_3 = n3_1 + u.tau_3;
  // v3 = invD3 u_3: u/D
  const T v3 = invD3 * u_3;
  // M3 = MA3 - kB3 B3^T: MA less what the turn takes up [kg]
  const T M3_11 = MA3_11 - kB3_1 * Hb4_11;
  const T M3_12 = Mp4_12 - kB3_1 * HA3_12;
  const T M3_13 = Mp4_13 - kB3_1 * HA3_13;
  const T M3_22 = MA3_22 - kB3_2 * HA3_12;
  const T M3_23 = Mp4_23 - kB3_2 * HA3_13;
  const T M3_33 = MA3_33 - kB3_3 * HA3_13;
  // H3 = P_b3 (HA3 - kK3 B3^T): HA less what the turn takes up [kg m]
  const T H3_21 = HA3_21 - kK3_2 * Hb4_11;
  const T H3_22 = Hb4_22 - kK3_2 * HA3_12;
  const T H3_23 = HA3_23 - kK3_2 * HA3_13;
  const T H3_31 = HA3_31 - kK3_3 * Hb4_11;
  const T H3_32 = HA3_32 - kK3_3 * HA3_12;
  const T H3_33 = Hb4_33 - kK3_3 * HA3_13;
  // J3 = P_b3 (JA3 - kK3 K3^T) P_b3: JA less what the turn takes up [kg m^2]
  const T J3_22 = JA3_22 - kK3_2 * JA3_12;
  const T J3_23 = JA3_23 - kK3_2 * JA3_13;
  const T J3_33 = JA3_33 - kK3_3 * JA3_13;
  // gt3 = g3 - v3 B3: force with the turn solved [N]
  const T gt3_1 = g3_1 - v3 * Hb4_11;
  const T gt3_2 = g3_2 - v3 * HA3_12;
  const T gt3_3 = g3_3 - v3 * HA3_13;
  // nt3 = -tau_body_3_ b3 + P_b3 (n3 - v3 K3): moment with the turn solved [N m]
  const T minus_nt3_2 = minus_n3_2 + v3 * JA3_12;
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
  const T b3_7 = E3_23 * (J3_22 - J3_33) + b3_1 * J3_23;
  const T b3_8 = E3_23 * b3_7;
  const T Jp3_22 = J3_22 - b3_8;
  const T Jp3_23 = E3_22 * b3_7 - J3_23;
  const T Jp3_33 = J3_33 + b3_8;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T minus_np3_2 = E3_22 * minus_nt3_2 + E3_23 * nt3_3;
  const T np3_3 = E3_22 * nt3_3 - E3_23 * minus_nt3_2;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T b3_9 = T(0.15) * Mp3_13;
  const T Hb3_11 = b3_9 - T(0.2) * Mp3_12;
  const T Hb3_12 = T(0.15) * Mp3_23 - T(0.2) * Mp3_22;
  const T Hb3_13 = T(0.15) * Mp3_33 - T(0.2) * Mp3_23;
  const T Hb3_21 = Hp3_21 + T(0.2) * M3_11;
  const T Hb3_23 = Hp3_23 + T(0.2) * Mp3_13;
  const T Hb3_31 = Hp3_31 - T(0.15) * M3_11;
  const T Hb3_33 = Hp3_33 - b3_9;
  own[frame::v] = v3;
  own[frame::gp_2] = gp3_2;
  own[frame::Hp_21] = Hp3_21;
  own[frame::Hp_22] = Hp3_22;
  own[frame::Hp_23] = Hp3_23;
  own[frame::Jp_22] = Jp3_22;
  own[frame::np_2] = -minus_np3_2;
  own[frame::Hb_31] = Hb3_31;
  own[frame::kB_1] = kB3_1;
  own[frame::kB_2] = kB3_2;
  own[frame::kB_3] = kB3_3;
  own[frame::kK_3] = kK3_3;
  own[frame::Mp_33] = Mp3_33;
  own[frame::gp_3] = gp3_3;
  own[frame::Hp_31] = Hp3_31;
  own[frame::Hp_32] = Hp3_32;
  own[frame::Jp_33] = Jp3_33;
  own[frame::np_3] = np3_3;
  own[frame::Hb_11] = Hb3_11;
  own[frame::Hb_12] = Hb3_12;
  own[frame::Hb_13] = Hb3_13;
  own[frame::Hb_21] = Hb3_21;
  own[frame::Hb_23] = Hb3_23;
  own[frame::kK_2] = kK3_2;
  own[frame::gt_1] = gt3_1;
  own[frame::Hp_33] = Hp3_33;
  own[frame::Jp_23] = Jp3_23;
  own[frame::Hb_33] = Hb3_33;
}

// body 2 and what they carry
template <class T>
[[gnu::noinline]] void inward_8(const Inputs<T>& u, T* frames) noexcept {
  const T* const of_3 = frames + 97;
  T* const own = frames + 32;
  const T Hb3_13 = of_3[frame::Hb_13];
  const T Hb3_23 = of_3[frame::Hb_23];
  const T Hb3_12 = of_3[frame::Hb_12];
  const T Hb3_11 = of_3[frame::Hb_11];
  const T Hp3_22 = of_3[frame::Hp_22];
  const T Hp3_23 = of_3[frame::Hp_23];
  const T Hp3_32 = of_3[frame::Hp_32];
  const T Hp3_33 = of_3[frame::Hp_33];
  const T Hb3_21 = of_3[frame::Hb_21];
  const T Hp3_21 = of_3[frame::Hp_21];
  const T Jp3_22 = of_3[frame::Jp_22];
  const T Hp3_31 = of_3[frame::Hp_31];
  const T Jp3_23 = of_3[frame::Jp_23];
  const T Hb3_31 = of_3[frame::Hb_31];
  const T Jp3_33 = of_3[frame::Jp_33];
  const T gp3_3 = of_3[frame::gp_3];
  const T G2_3 = own[frame::G_3];
  const T gp3_2 = of_3[frame::gp_2];
  const T N2_1 = own[frame::N_1];
  const T gt3_1 = of_3[frame::gt_1];
  const T np3_2 = of_3[frame::np_2];
  const T N2_2 = own[frame::N_2];
  const T np3_3 = of_3[frame::np_3];
  const T N2_3 = own[frame::N_3];
  const T Hb3_33 = of_3[frame::Hb_33];
  const T Mp3_33 = of_3[frame::Mp_33];
  const T E2_11 = own[frame::E_11];
  const T E2_12 = own[frame::E_12];
  // HA2 = h_own_2~ + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA2_13 = T(0.24) + Hb3_13;
  const T HA2_23 = Hb3_23 - T(0.12);
  // JA2 = q3~ Hp3^T + J_own_2 + Jp3 - Hb3 q3~: moment for an angular acceleration, body axes [kg m^2]
  const T JA2_11 = Hb3_13 * T(0.15) - Hb3_12 * T(0.2);
  const T JA2_12 = T(0.15) * Hp3_23 - T(0.018000000000000002) - T(0.2) * Hp3_22 + Hb3_11 * T(0.2);
  const T JA2_13 = T(0.15) * Hp3_33 - T(0.014400000000000001) - T(0.2) * Hp3_32 - Hb3_11 * T(0.15);
  const T JA2_22 = Jp3_22 - T(0.012000000000000009) + T(0.2) * Hp3_21 + Hb3_21 * T(0.2);
  const T JA2_23 = Jp3_23 - T(0.0408) + T(0.2) * Hp3_31 - Hb3_21 * T(0.15);
  const T JA2_33 = T(0.156) + Jp3_33 - T(0.15) * Hp3_31 - Hb3_31 * T(0.15);
  // g2 = G2 + gp3: force that drives it, home axes [N]
  const T g2_3 = gp3_3 + G2_3;
  // n2 = q3~ gp3 + N2 + np3: moment that drives it, body axes [N m]
  const T minus_n2_1 = u.tau_3 - N2_1 - T(0.15) * gp3_3 + T(0.2) * gp3_2;
  const T n2_2 = np3_2 + N2_2 + T(0.2) * gt3_1;
  const T n2_3 = np3_3 + N2_3 - T(0.15) * gt3_1;
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
  // M2 = Mp3 - kB2 B2^T: MA less what the turn takes up [kg]
  const T M2_33 = Mp3_33 - kB2_3 * Hb3_33;
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
  const T minus_nt2_1 = minus_n2_1 + v2 * JA2_13;
  const T nt2_2 = n2_2 - v2 * JA2_23;
  // Hp2 = E2^T H2 E2: H passed on, lower body's axes [kg m]
  const T Hp2_23 = E2_12 * H2_13 + E2_11 * H2_23;
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T Jp2_22 = J2_22 + E2_12 * (T(2) * E2_11 * J2_12 + E2_12 * (J2_11 - J2_22));
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T np2_2 = E2_11 * nt2_2 - E2_12 * minus_nt2_1;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T Hb2_23 = Hp2_23 - T(0.3) * M2_33;
  own[frame::v] = v2;
  own[frame::Hp_23] = Hp2_23;
  own[frame::Jp_22] = Jp2_22;
  own[frame::np_2] = np2_2;
  own[frame::kB_3] = kB2_3;
  own[frame::kK_1] = kK2_1;
  own[frame::Hb_23] = Hb2_23;
  own[frame::kK_2] = kK2_2;
  own[frame::gt_3] = gt2_3;
}

// body 1 and what they carry
template <class T>
[[gnu::noinline]] void inward_9(const Inputs<T>& u, T* ydot, T* frames) noexcept {
  const T* const of_2 = frames + 32;
  T* const own = frames + 0;
  const T Hb2_23 = of_2[frame::Hb_23];
  const T Hp2_23 = of_2[frame::Hp_23];
  const T Jp2_22 = of_2[frame::Jp_22];
  const T gt2_3 = of_2[frame::gt_3];
  const T N1_2 = own[frame::N_2];
  const T np2_2 = of_2[frame::np_2];
  // JA1 = q2~ Hp2^T + J_own_1 + Jp2 - Hb2 q2~: moment for an angular acceleration, body axes [kg m^2]
  const T JA1_22 = T(0.44875) + Jp2_22 - T(0.3) * Hp2_23 - Hb2_23 * T(0.3);
  // n1 = q2~ gp2 + N1 + np2: moment that drives it, body axes [N m]
  const T n1_2 = N1_2 + np2_2 - T(0.3) * gt2_3;
  // invD1 = D1^-1: 1/D
  const T invD1 = T(1) / JA1_22;
  // u_1 = b1 . n1 + tau_body_1_: drives it [N m], [N]
  const T u_1 = n1_2 + u.tau_1;
  // v1 = invD1 u_1: u/D
  const T v1 = invD1 * u_1;
  ydot[0] = v1;
  own[frame::v] = v1;
}

// body 2, solved
template <class T>
[[gnu::noinline]] void solved_1(T* ydot, T* frames) noexcept {
  const T* const of_1 = frames + 0;
  T* const own = frames + 32;
  const T v1 = of_1[frame::v];
  const T E2_12 = own[frame::E_12];
  const T E2_11 = own[frame::E_11];
  const T kK2_2 = own[frame::kK_2];
  const T kK2_1 = own[frame::kK_1];
  const T kB2_3 = own[frame::kB_3];
  const T v2 = own[frame::v];
  // beta2 = -E2 q2~ alpha1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T minus_beta2_3 = T(0.3) * v1;
  // alphaL2 = E2 alpha1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL2_1 = E2_12 * v1;
  const T alphaL2_2 = E2_11 * v1;
  // phi2 = -kB2 . beta2 + v2 - (P_b2 kK2) . alphaL2
  const T minus_phi2 = kK2_1 * alphaL2_1 - (v2 + kB2_3 * minus_beta2_3) + kK2_2 * alphaL2_2;
  ydot[1] = -minus_phi2;
  own[frame::beta_3] = -minus_beta2_3;
  own[frame::alphaL_1] = alphaL2_1;
  own[frame::alphaL_2] = alphaL2_2;
  own[frame::minus_phi] = minus_phi2;
}

// body 3, solved
template <class T>
[[gnu::noinline]] void solved_2(T* ydot, T* frames) noexcept {
  const T* const of_2 = frames + 32;
  T* const own = frames + 97;
  const T minus_phi2 = of_2[frame::minus_phi];
  const T alphaL2_2 = of_2[frame::alphaL_2];
  const T E3_23 = own[frame::E_23];
  const T beta2_3 = of_2[frame::beta_3];
  const T alphaL2_1 = of_2[frame::alphaL_1];
  const T E3_22 = own[frame::E_22];
  const T kK3_3 = own[frame::kK_3];
  const T kB3_2 = own[frame::kB_2];
  const T kB3_1 = own[frame::kB_1];
  const T v3 = own[frame::v];
  const T kB3_3 = own[frame::kB_3];
  const T kK3_2 = own[frame::kK_2];
  // beta3 = -E3 q3~ alpha2 + E3 beta2: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta3_1 = T(0.15) * minus_phi2 + T(0.2) * alphaL2_2;
  const T z3_1 = T(0.2) * alphaL2_1;
  const T z3_2 = T(0.15) * alphaL2_1;
  const T beta3_2 = E3_23 * beta2_3 - (E3_22 * z3_1 - E3_23 * z3_2);
  const T beta3_3 = E3_23 * z3_1 + E3_22 * z3_2 + E3_22 * beta2_3;
  // alphaL3 = E3 alpha2: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL3_2 = E3_22 * alphaL2_2 - E3_23 * minus_phi2;
  const T minus_alphaL3_3 = E3_22 * minus_phi2 + E3_23 * alphaL2_2;
  // phi3 = -kB3 . beta3 + v3 - (P_b3 kK3) . alphaL3
  const T phi3 = kK3_3 * minus_alphaL3_3 - (kB3_2 * beta3_2 - (v3 - kB3_1 * beta3_1) + kB3_3 * beta3_3) - kK3_2 *
      alphaL3_2;
  // thetaddot3 = -b3 . alphaL3 + phi3
  const T thetaddot3 = phi3 - alphaL2_1;
  ydot[2] = thetaddot3;
  own[frame::beta_3] = beta3_3;
  own[frame::alphaL_2] = alphaL3_2;
  own[frame::beta_1] = beta3_1;
  own[frame::beta_2] = beta3_2;
  own[frame::minus_alphaL_3] = minus_alphaL3_3;
  own[frame::phi] = phi3;
}

// body 4, solved
template <class T>
[[gnu::noinline]] void solved_3(T* ydot, T* frames) noexcept {
  T* const own = frames + 162;
  const T* const of_3 = frames + 97;
  const T E4_11 = own[frame::E_11];
  const T beta3_1 = of_3[frame::beta_1];
  const T alphaL3_2 = of_3[frame::alphaL_2];
  const T minus_E4_13 = own[frame::minus_E_13];
  const T beta3_3 = of_3[frame::beta_3];
  const T minus_alphaL3_3 = of_3[frame::minus_alphaL_3];
  const T phi3 = of_3[frame::phi];
  const T beta3_2 = of_3[frame::beta_2];
  const T kB4_3 = own[frame::kB_3];
  const T kB4_1 = own[frame::kB_1];
  const T kB4_2 = own[frame::kB_2];
  const T v4 = own[frame::v];
  const T kK4_1 = own[frame::kK_1];
  const T kK4_3 = own[frame::kK_3];
  // beta4 = -E4 q4~ alpha3 + E4 beta3: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z4_1 = T(0.1) * alphaL3_2;
  const T z4_2 = T(0.6) * alphaL3_2;
  const T beta4_1 = E4_11 * z4_1 + minus_E4_13 * z4_2 + E4_11 * beta3_1 - minus_E4_13 * beta3_3;
  const T beta4_2 = beta3_2 - T(0.1) * phi3 - T(0.6) * minus_alphaL3_3;
  const T beta4_3 = minus_E4_13 * z4_1 - E4_11 * z4_2 + E4_11 * beta3_3 + minus_E4_13 * beta3_1;
  // alphaL4 = E4 alpha3: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4_1 = E4_11 * phi3 + minus_E4_13 * minus_alphaL3_3;
  const T alphaL4_3 = minus_E4_13 * phi3 - E4_11 * minus_alphaL3_3;
  // phi4 = -kB4 . beta4 + v4 - (P_b4 kK4) . alphaL4
  const T minus_phi4 = kB4_1 * beta4_1 - (v4 - kB4_2 * beta4_2) + kB4_3 * beta4_3 + kK4_1 * alphaL4_1 + kK4_3 *
      alphaL4_3;
  // thetaddot4 = -b4 . alphaL4 + phi4
  const T minus_thetaddot4 = minus_phi4 + alphaL3_2;
  ydot[3] = -minus_thetaddot4;
  own[frame::beta_3] = beta4_3;
  own[frame::alphaL_1] = alphaL4_1;
  own[frame::minus_phi] = minus_phi4;
  own[frame::beta_1] = beta4_1;
  own[frame::beta_2] = beta4_2;
  own[frame::alphaL_3] = alphaL4_3;
}

// body 5, solved
template <class T>
[[gnu::noinline]] void solved_4(T* ydot, T* frames) noexcept {
  const T* const of_4 = frames + 162;
  T* const own = frames + 228;
  const T alphaL4_3 = of_4[frame::alphaL_3];
  const T E5_12 = own[frame::E_12];
  const T E5_11 = own[frame::E_11];
  const T beta4_2 = of_4[frame::beta_2];
  const T beta4_1 = of_4[frame::beta_1];
  const T minus_phi4 = of_4[frame::minus_phi];
  const T alphaL4_1 = of_4[frame::alphaL_1];
  const T beta4_3 = of_4[frame::beta_3];
  const T kK5_2 = own[frame::kK_2];
  const T kB5_2 = own[frame::kB_2];
  const T kB5_1 = own[frame::kB_1];
  const T v5 = own[frame::v];
  const T kB5_3 = own[frame::kB_3];
  const T kK5_1 = own[frame::kK_1];
  // beta5 = -E5 q5~ alpha4 + E5 beta4: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z5_1 = T(0.3) * alphaL4_3;
  const T z5_2 = T(0.45) * alphaL4_3;
  const T beta5_1 = E5_12 * z5_1 - (E5_11 * z5_2 - (E5_12 * beta4_2 + E5_11 * beta4_1));
  const T beta5_2 = E5_11 * z5_1 - (E5_12 * beta4_1 - E5_11 * beta4_2) + E5_12 * z5_2;
  const T beta5_3 = beta4_3 + T(0.45) * alphaL4_1 + T(0.3) * minus_phi4;
  // alphaL5 = E5 alpha4: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL5_1 = E5_11 * alphaL4_1 - E5_12 * minus_phi4;
  const T minus_alphaL5_2 = E5_11 * minus_phi4 + E5_12 * alphaL4_1;
  // phi5 = -kB5 . beta5 + v5 - (P_b5 kK5) . alphaL5
  const T phi5 = kK5_2 * minus_alphaL5_2 - (kB5_2 * beta5_2 - (v5 - kB5_1 * beta5_1) + kB5_3 * beta5_3 + kK5_1 *
      alphaL5_1);
  // thetaddot5 = -b5 . alphaL5 + phi5
  const T thetaddot5 = phi5 - alphaL4_3;
  ydot[4] = thetaddot5;
  own[frame::beta_3] = beta5_3;
  own[frame::alphaL_1] = alphaL5_1;
  own[frame::beta_1] = beta5_1;
  own[frame::beta_2] = beta5_2;
  own[frame::phi] = phi5;
  own[frame::minus_alphaL_2] = minus_alphaL5_2;
}

// bodies 6, 12, 18, 24, 30, solved
template <class T>
[[gnu::noinline]] void solved_5(T* ydot, T* frames, int row) noexcept {
  const auto& [L, K, s_at, s_at2, ydot_at] = solved_5_places[row];
  const auto& k = solved_5_numbers<Number<T>>[row];
  const T* const of_L = frames + L;
  T* const own = frames + K;
  const T minus_alphaLL_2 = of_L[s_at];
  const T phiL = of_L[s_at2];
  const T betaL_1 = of_L[frame::beta_1];
  const T EK_23 = own[frame::E_23];
  const T betaL_3 = of_L[frame::beta_3];
  const T EK_22 = own[frame::E_22];
  const T betaL_2 = of_L[frame::beta_2];
  const T alphaLL_1 = of_L[frame::alphaL_1];
  const T phiL_2 = of_L[frame::phi];
  const T minus_alphaLL_2_2 = of_L[frame::minus_alphaL_2];
  const T kBK_3 = own[frame::kB_3];
  const T kBK_2 = own[frame::kB_2];
  const T kBK_1 = own[frame::kB_1];
  const T vK = own[frame::v];
  const T kKK_3 = own[frame::kK_3];
  const T kKK_2 = own[frame::kK_2];
  // betaK = -EK qK~ alphaL + EK betaL: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T betaK_1 = betaL_1 + T(k[1]) * phiL + T(k[0]) * minus_alphaLL_2;
  const T zK_1 = T(0.2) * alphaLL_1;
  const T zK_2 = T(k[2]) * alphaLL_1;
  const T betaK_2 = EK_22 * betaL_2 - (EK_22 * zK_1 - EK_23 * zK_2) + EK_23 * betaL_3;
  const T betaK_3 = EK_23 * zK_1 - (EK_23 * betaL_2 - EK_22 * betaL_3) + EK_22 * zK_2;
  // alphaLK = EK alphaL: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaLK_2 = EK_23 * phiL_2 - EK_22 * minus_alphaLL_2_2;
  const T alphaLK_3 = EK_22 * phiL_2 + EK_23 * minus_alphaLL_2_2;
  // phiK = -kBK . betaK + vK - (P_bK kKK) . alphaLK
  const T minus_phiK = kBK_2 * betaK_2 - (vK - kBK_1 * betaK_1) + kBK_3 * betaK_3 + kKK_3 * alphaLK_3 + kKK_2 *
      alphaLK_2;
  // thetaddotK = -bK . alphaLK + phiK
  const T minus_thetaddotK = minus_phiK + alphaLL_1;
  ydot[ydot_at] = -minus_thetaddotK;
  own[frame::beta_3] = betaK_3;
  own[frame::alphaL_2] = alphaLK_2;
  own[frame::minus_phi] = minus_phiK;
  own[frame::beta_1] = betaK_1;
  own[frame::beta_2] = betaK_2;
  own[frame::alphaL_3] = alphaLK_3;
}

// body 7, solved
template <class T>
[[gnu::noinline]] void solved_6(T* ydot, T* frames) noexcept {
  T* const own = frames + 359;
  const T* const of_6 = frames + 293;
  const T E7_11 = own[frame::E_11];
  const T beta6_1 = of_6[frame::beta_1];
  const T alphaL6_2 = of_6[frame::alphaL_2];
  const T minus_E7_13 = own[frame::minus_E_13];
  const T beta6_3 = of_6[frame::beta_3];
  const T minus_phi6 = of_6[frame::minus_phi];
  const T alphaL6_3 = of_6[frame::alphaL_3];
  const T beta6_2 = of_6[frame::beta_2];
  const T kK7_1 = own[frame::kK_1];
  const T kB7_3 = own[frame::kB_3];
  const T kB7_2 = own[frame::kB_2];
  const T kB7_1 = own[frame::kB_1];
  const T v7 = own[frame::v];
  const T kK7_3 = own[frame::kK_3];
  // beta7 = -E7 q7~ alpha6 + E7 beta6: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z7_1 = T(0.1) * alphaL6_2;
  const T z7_2 = T(0.6) * alphaL6_2;
  const T beta7_1 = E7_11 * z7_1 + minus_E7_13 * z7_2 + E7_11 * beta6_1 - minus_E7_13 * beta6_3;
  const T beta7_2 = beta6_2 + T(0.6) * alphaL6_3 + T(0.1) * minus_phi6;
  const T beta7_3 = minus_E7_13 * z7_1 - E7_11 * z7_2 + E7_11 * beta6_3 + minus_E7_13 * beta6_1;
  // alphaL7 = E7 alpha6: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T minus_alphaL7_1 = E7_11 * minus_phi6 + minus_E7_13 * alphaL6_3;
  const T alphaL7_3 = E7_11 * alphaL6_3 - minus_E7_13 * minus_phi6;
  // phi7 = -kB7 . beta7 + v7 - (P_b7 kK7) . alphaL7
  const T phi7 = kK7_1 * minus_alphaL7_1 - (kB7_2 * beta7_2 - (v7 - kB7_1 * beta7_1) + kB7_3 * beta7_3) - kK7_3 *
      alphaL7_3;
  // thetaddot7 = -b7 . alphaL7 + phi7
  const T thetaddot7 = phi7 - alphaL6_2;
  ydot[6] = thetaddot7;
  own[frame::beta_3] = beta7_3;
  own[frame::beta_1] = beta7_1;
  own[frame::beta_2] = beta7_2;
  own[frame::phi] = phi7;
  own[frame::alphaL_3] = alphaL7_3;
  own[frame::minus_alphaL_1] = minus_alphaL7_1;
}

// bodies 8, 14, 20, 26, solved
template <class T>
[[gnu::noinline]] void solved_7(T* ydot, T* frames, int row) noexcept {
  const auto& [K, L, ydot_at] = solved_7_places[row];
  const auto& k = solved_7_numbers<Number<T>>[row];
  T* const own = frames + K;
  const T* const of_L = frames + L;
  const T EK_12 = own[frame::E_12];
  const T betaL_2 = of_L[frame::beta_2];
  const T EK_11 = own[frame::E_11];
  const T betaL_1 = of_L[frame::beta_1];
  const T alphaLL_3 = of_L[frame::alphaL_3];
  const T phiL = of_L[frame::phi];
  const T minus_alphaLL_1 = of_L[frame::minus_alphaL_1];
  const T betaL_3 = of_L[frame::beta_3];
  const T kBK_2 = own[frame::kB_2];
  const T kBK_1 = own[frame::kB_1];
  const T vK = own[frame::v];
  const T kBK_3 = own[frame::kB_3];
  const T kKK_1 = own[frame::kK_1];
  const T kKK_2 = own[frame::kK_2];
  // betaK = -EK qK~ alphaL + EK betaL: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T zK_1 = T(k[0]) * alphaLL_3;
  const T zK_2 = T(0.3) * alphaLL_3;
  const T betaK_1 = EK_11 * betaL_1 - (EK_11 * zK_1 - EK_12 * zK_2) + EK_12 * betaL_2;
  const T betaK_2 = EK_11 * zK_2 - (EK_12 * betaL_1 - EK_11 * betaL_2) + EK_12 * zK_1;
  const T betaK_3 = betaL_3 + T(k[1]) * minus_alphaLL_1 - T(0.3) * phiL;
  // alphaLK = EK alphaL: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaLK_1 = EK_12 * phiL - EK_11 * minus_alphaLL_1;
  const T alphaLK_2 = EK_11 * phiL + EK_12 * minus_alphaLL_1;
  // phiK = -kBK . betaK + vK - (P_bK kKK) . alphaLK
  const T minus_phiK = kBK_2 * betaK_2 - (vK - kBK_1 * betaK_1) + kBK_3 * betaK_3 + kKK_1 * alphaLK_1 + kKK_2 *
      alphaLK_2;
  // thetaddotK = -bK . alphaLK + phiK
  const T minus_thetaddotK = minus_phiK + alphaLL_3;
  ydot[ydot_at] = -minus_thetaddotK;
  own[frame::beta_3] = betaK_3;
  own[frame::alphaL_1] = alphaLK_1;
  own[frame::alphaL_2] = alphaLK_2;
  own[frame::minus_phi] = minus_phiK;
  own[frame::beta_1] = betaK_1;
  own[frame::beta_2] = betaK_2;
}

// bodies 9, 15, 21, 27, solved
template <class T>
[[gnu::noinline]] void solved_8(T* ydot, T* frames, int row) noexcept {
  const auto& [L, K, ydot_at] = solved_8_places[row];
  const auto& k = solved_8_numbers<Number<T>>[row];
  const T* const of_L = frames + L;
  T* const own = frames + K;
  const T minus_phiL = of_L[frame::minus_phi];
  const T alphaLL_2 = of_L[frame::alphaL_2];
  const T betaL_1 = of_L[frame::beta_1];
  const T EK_23 = own[frame::E_23];
  const T betaL_3 = of_L[frame::beta_3];
  const T EK_22 = own[frame::E_22];
  const T betaL_2 = of_L[frame::beta_2];
  const T alphaLL_1 = of_L[frame::alphaL_1];
  const T kKK_3 = own[frame::kK_3];
  const T kBK_3 = own[frame::kB_3];
  const T kBK_2 = own[frame::kB_2];
  const T kBK_1 = own[frame::kB_1];
  const T vK = own[frame::v];
  const T kKK_2 = own[frame::kK_2];
  // betaK = -EK qK~ alphaL + EK betaL: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T betaK_1 = betaL_1 + T(0.2) * alphaLL_2 + T(k[0]) * minus_phiL;
  const T zK_1 = T(0.2) * alphaLL_1;
  const T zK_2 = T(k[0]) * alphaLL_1;
  const T betaK_2 = EK_22 * betaL_2 - (EK_22 * zK_1 - EK_23 * zK_2) + EK_23 * betaL_3;
  const T betaK_3 = EK_23 * zK_1 - (EK_23 * betaL_2 - EK_22 * betaL_3) + EK_22 * zK_2;
  // alphaLK = EK alphaL: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaLK_2 = EK_22 * alphaLL_2 - EK_23 * minus_phiL;
  const T minus_alphaLK_3 = EK_22 * minus_phiL + EK_23 * alphaLL_2;
  // phiK = -kBK . betaK + vK - (P_bK kKK) . alphaLK
  const T phiK = kKK_3 * minus_alphaLK_3 - (kBK_2 * betaK_2 - (vK - kBK_1 * betaK_1) + kBK_3 * betaK_3) - kKK_2 *
      alphaLK_2;
  // thetaddotK = -bK . alphaLK + phiK
  const T thetaddotK = phiK - alphaLL_1;
  ydot[ydot_at] = thetaddotK;
  own[frame::beta_3] = betaK_3;
  own[frame::alphaL_2] = alphaLK_2;
  own[frame::beta_1] = betaK_1;
  own[frame::beta_2] = betaK_2;
  own[frame::minus_alphaL_3] = minus_alphaLK_3;
  own[frame::phi] = phiK;
}

// bodies 10, 16, 22, 28, solved
template <class T>
[[gnu::noinline]] void solved_9(T* ydot, T* frames, int row) noexcept {
  const auto& [L, K, ydot_at] = solved_9_places[row];
  const T* const of_L = frames + L;
  T* const own = frames + K;
  const T alphaLL_2 = of_L[frame::alphaL_2];
  const T minus_EK_13 = own[frame::minus_E_13];
  const T EK_11 = own[frame::E_11];
  const T betaL_1 = of_L[frame::beta_1];
  const T betaL_3 = of_L[frame::beta_3];
  const T phiL = of_L[frame::phi];
  const T minus_alphaLL_3 = of_L[frame::minus_alphaL_3];
  const T betaL_2 = of_L[frame::beta_2];
  const T kKK_3 = own[frame::kK_3];
  const T kBK_3 = own[frame::kB_3];
  const T kBK_2 = own[frame::kB_2];
  const T kBK_1 = own[frame::kB_1];
  const T vK = own[frame::v];
  const T kKK_1 = own[frame::kK_1];
  // betaK = -EK qK~ alphaL + EK betaL: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T zK_1 = T(0.1) * alphaLL_2;
  const T zK_2 = T(0.6) * alphaLL_2;
  const T betaK_1 = EK_11 * betaL_1 - minus_EK_13 * betaL_3 + EK_11 * zK_1 + minus_EK_13 * zK_2;
  const T betaK_2 = betaL_2 - T(0.6) * minus_alphaLL_3 - T(0.1) * phiL;
  const T betaK_3 = minus_EK_13 * zK_1 - EK_11 * zK_2 + minus_EK_13 * betaL_1 + EK_11 * betaL_3;
  // alphaLK = EK alphaL: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaLK_1 = EK_11 * phiL + minus_EK_13 * minus_alphaLL_3;
  const T alphaLK_3 = minus_EK_13 * phiL - EK_11 * minus_alphaLL_3;
  // phiK = -kBK . betaK + vK - (P_bK kKK) . alphaLK
  const T minus_phiK = kBK_2 * betaK_2 - (vK - kBK_1 * betaK_1) + kBK_3 * betaK_3 + kKK_1 * alphaLK_1 + kKK_3 *
      alphaLK_3;
  // thetaddotK = -bK . alphaLK + phiK
  const T minus_thetaddotK = minus_phiK + alphaLL_2;
  ydot[ydot_at] = -minus_thetaddotK;
  own[frame::beta_3] = betaK_3;
  own[frame::alphaL_1] = alphaLK_1;
  own[frame::minus_phi] = minus_phiK;
  own[frame::beta_1] = betaK_1;
  own[frame::beta_2] = betaK_2;
  own[frame::alphaL_3] = alphaLK_3;
}

// bodies 11, 17, 23, 29, solved
template <class T>
[[gnu::noinline]] void solved_10(T* ydot, T* frames, int row) noexcept {
  const auto& [K, L, ydot_at] = solved_10_places[row];
  const auto& k = solved_10_numbers<Number<T>>[row];
  T* const own = frames + K;
  const T* const of_L = frames + L;
  const T EK_12 = own[frame::E_12];
  const T betaL_2 = of_L[frame::beta_2];
  const T EK_11 = own[frame::E_11];
  const T betaL_1 = of_L[frame::beta_1];
  const T alphaLL_3 = of_L[frame::alphaL_3];
  const T minus_phiL = of_L[frame::minus_phi];
  const T alphaLL_1 = of_L[frame::alphaL_1];
  const T betaL_3 = of_L[frame::beta_3];
  const T kKK_2 = own[frame::kK_2];
  const T kBK_2 = own[frame::kB_2];
  const T kBK_1 = own[frame::kB_1];
  const T vK = own[frame::v];
  const T kBK_3 = own[frame::kB_3];
  const T kKK_1 = own[frame::kK_1];
  // betaK = -EK qK~ alphaL + EK betaL: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T zK_1 = T(k[0]) * alphaLL_3;
  const T zK_2 = T(0.3) * alphaLL_3;
  const T betaK_1 = EK_11 * betaL_1 - (EK_11 * zK_1 - EK_12 * zK_2) + EK_12 * betaL_2;
  const T betaK_2 = EK_11 * zK_2 - (EK_12 * betaL_1 - EK_11 * betaL_2) + EK_12 * zK_1;
  const T betaK_3 = betaL_3 + T(k[0]) * alphaLL_1 + T(0.3) * minus_phiL;
  // alphaLK = EK alphaL: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaLK_1 = EK_11 * alphaLL_1 - EK_12 * minus_phiL;
  const T minus_alphaLK_2 = EK_11 * minus_phiL + EK_12 * alphaLL_1;
  // phiK = -kBK . betaK + vK - (P_bK kKK) . alphaLK
  const T phiK = kKK_2 * minus_alphaLK_2 - (kBK_2 * betaK_2 - (vK - kBK_1 * betaK_1) + kBK_3 * betaK_3 + kKK_1 *
      alphaLK_1);
  // thetaddotK = -bK . alphaLK + phiK
  const T thetaddotK = phiK - alphaLL_3;
  ydot[ydot_at] = thetaddotK;
  own[frame::beta_3] = betaK_3;
  own[frame::alphaL_1] = alphaLK_1;
  own[frame::beta_1] = betaK_1;
  own[frame::beta_2] = betaK_2;
  own[frame::phi] = phiK;
  own[frame::minus_alphaL_2] = minus_alphaLK_2;
}

// bodies 13, 19, 25, 31, solved
template <class T>
[[gnu::noinline]] void solved_11(T* ydot, T* frames, int row) noexcept {
  const auto& [L, K, ydot_at] = solved_11_places[row];
  const T* const of_L = frames + L;
  T* const own = frames + K;
  const T alphaLL_2 = of_L[frame::alphaL_2];
  const T minus_EK_13 = own[frame::minus_E_13];
  const T EK_11 = own[frame::E_11];
  const T betaL_1 = of_L[frame::beta_1];
  const T betaL_3 = of_L[frame::beta_3];
  const T minus_phiL = of_L[frame::minus_phi];
  const T alphaLL_3 = of_L[frame::alphaL_3];
  const T betaL_2 = of_L[frame::beta_2];
  const T kKK_1 = own[frame::kK_1];
  const T kBK_3 = own[frame::kB_3];
  const T kBK_2 = own[frame::kB_2];
  const T kBK_1 = own[frame::kB_1];
  const T vK = own[frame::v];
  const T kKK_3 = own[frame::kK_3];
  // betaK = -EK qK~ alphaL + EK betaL: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T zK_1 = T(0.1) * alphaLL_2;
  const T zK_2 = T(0.6) * alphaLL_2;
  const T betaK_1 = EK_11 * betaL_1 - minus_EK_13 * betaL_3 + EK_11 * zK_1 + minus_EK_13 * zK_2;
  const T betaK_2 = betaL_2 + T(0.6) * alphaLL_3 + T(0.1) * minus_phiL;
  const T betaK_3 = minus_EK_13 * zK_1 - EK_11 * zK_2 + minus_EK_13 * betaL_1 + EK_11 * betaL_3;
  // alphaLK = EK alphaL: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T minus_alphaLK_1 = EK_11 * minus_phiL + minus_EK_13 * alphaLL_3;
  const T alphaLK_3 = EK_11 * alphaLL_3 - minus_EK_13 * minus_phiL;
  // phiK = -kBK . betaK + vK - (P_bK kKK) . alphaLK
  const T phiK = kKK_1 * minus_alphaLK_1 - (kBK_2 * betaK_2 - (vK - kBK_1 * betaK_1) + kBK_3 * betaK_3) - kKK_3 *
      alphaLK_3;
  // thetaddotK = -bK . alphaLK + phiK
  const T thetaddotK = phiK - alphaLL_2;
  ydot[ydot_at] = thetaddotK;
  own[frame::beta_3] = betaK_3;
  own[frame::beta_1] = betaK_1;
  own[frame::beta_2] = betaK_2;
  own[frame::phi] = phiK;
  own[frame::alphaL_3] = alphaLK_3;
  own[frame::minus_alphaL_1] = minus_alphaLK_1;
}

// body 32, solved
template <class T>
[[gnu::noinline]] void solved_12(T* ydot, T* frames) noexcept {
  const T* const of_31 = frames + 1931;
  T* const own = frames + 1997;
  const T alphaL31_3 = of_31[frame::alphaL_3];
  const T E32_12 = own[frame::E_12];
  const T beta31_1 = of_31[frame::beta_1];
  const T E32_11 = own[frame::E_11];
  const T beta31_2 = of_31[frame::beta_2];
  const T phi31 = of_31[frame::phi];
  const T minus_alphaL31_1 = of_31[frame::minus_alphaL_1];
  const T v32 = own[frame::v];
  // beta32 = -E32 q32~ alpha31 + E32 beta31: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta32_2 = T(3.1500000000000004) * alphaL31_3 * E32_12 - (E32_12 * beta31_1 - E32_11 * beta31_2 - T(0.3) *
      alphaL31_3 * E32_11);
  // alphaL32 = E32 alpha31: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL32_1 = E32_12 * phi31 - E32_11 * minus_alphaL31_1;
  const T alphaL32_2 = E32_11 * phi31 + E32_12 * minus_alphaL31_1;
  // phi32 = -kB32 . beta32 + v32 - (P_b32 kK32) . alphaL32
  const T phi32 = v32 - T(1.7200522903844537) * beta32_2 + T(0.2752083664615126) * alphaL32_1 + T(0.03440104580768907)
      * alphaL32_2;
  // thetaddot32 = -b32 . alphaL32 + phi32
  const T thetaddot32 = phi32 - alphaL31_3;
  ydot[31] = thetaddot32;
}

}  // namespace accelerations_sections

template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot)
    noexcept {
  using namespace accelerations_sections;
  [[maybe_unused]] T frames[2057];
  const T inputs[] = {u.tau_30, u.tau_27, u.tau_24, u.tau_21, u.tau_18, u.tau_15, u.tau_12, u.tau_9, u.tau_6,
      u.tau_29, u.tau_26, u.tau_23, u.tau_20, u.tau_17, u.tau_14, u.tau_11, u.tau_8, u.tau_5, u.tau_28, u.tau_25,
      u.tau_22, u.tau_19, u.tau_16, u.tau_13, u.tau_10, u.tau_7, u.tau_4};
  T cosines[32], sines[32];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 32, cosines, sines);
  // kind of section, and row of its tables
  static constexpr unsigned char steps[][2] = {
      {0,0}, {1,0}, {2,0}, {3,0}, {4,0}, {5,0}, {3,1}, {4,1}, {5,1}, {3,2}, {4,2}, {5,2}, {3,3}, {4,3}, {5,3}, {3,4},
      {4,4}, {5,4}, {3,5}, {4,5}, {5,5}, {3,6}, {4,6}, {5,6}, {3,7}, {4,7}, {5,7}, {3,8}, {4,8}, {5,8}, {3,9}, {6,0},
      {7,0}, {8,0}, {9,0}, {10,0}, {11,0}, {12,0}, {10,1}, {11,1}, {12,1}, {10,2}, {11,2}, {12,2}, {10,3}, {11,3},
      {12,3}, {10,4}, {11,4}, {12,4}, {10,5}, {11,5}, {12,5}, {10,6}, {11,6}, {12,6}, {10,7}, {11,7}, {12,7}, {10,8},
      {11,8}, {13,0}, {14,0}, {15,0}, {16,0}, {17,0}, {18,0}, {19,0}, {20,0}, {21,0}, {22,0}, {23,0}, {24,0}, {25,0},
      {20,1}, {26,0}, {22,1}, {23,1}, {24,1}, {25,1}, {20,2}, {26,1}, {22,2}, {23,2}, {24,2}, {25,2}, {20,3}, {26,2},
      {22,3}, {23,3}, {24,3}, {25,3}, {20,4}, {26,3}, {27,0}};
  for (const auto& step : steps) {
    [[maybe_unused]] const int row = step[1];
    switch (step[0]) {
      case 0: outward_1(y, cosines, sines, frames); break;
      case 1: outward_2(y, cosines, sines, frames); break;
      case 2: outward_3(y, cosines, sines, frames); break;
      case 3: outward_4(y, cosines, sines, frames, row); break;
      case 4: outward_5(y, cosines, sines, frames, row); break;
      case 5: outward_6(y, cosines, sines, frames, row); break;
      case 6: outward_7(y, cosines, sines, frames); break;
      case 7: inward_1(u, frames); break;
      case 8: inward_2(u, frames); break;
      case 9: inward_3(u, frames); break;
      case 10: inward_4(inputs, frames, row); break;
      case 11: inward_5(inputs, frames, row); break;
      case 12: inward_6(inputs, frames, row); break;
      case 13: inward_7(u, frames); break;
      case 14: inward_8(u, frames); break;
      case 15: inward_9(u, ydot, frames); break;
      case 16: solved_1(ydot, frames); break;
      case 17: solved_2(ydot, frames); break;
      case 18: solved_3(ydot, frames); break;
      case 19: solved_4(ydot, frames); break;
      case 20: solved_5(ydot, frames, row); break;
      case 21: solved_6(ydot, frames); break;
      case 22: solved_7(ydot, frames, row); break;
      case 23: solved_8(ydot, frames, row); break;
      case 24: solved_9(ydot, frames, row); break;
      case 25: solved_10(ydot, frames, row); break;
      case 26: solved_11(ydot, frames, row); break;
      case 27: solved_12(ydot, frames); break;
    }
  }
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 1894 add, 1931 multiply, 64 sine or cosine
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r)
    noexcept {
  T cosines[32], sines[32];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 32, cosines, sines);

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
  const T N1_2 = T(13.03) * thetaddot1 - T(25.22) * Pddot1_3 - T(16.735) * minus_Pddot1_1;

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
  const T G2_3 = U2_31 * T(49.36) + U2_32 * T(12.615);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(12.615) * Pddot2_3 + T(1.9402499999999998) * U2_32 + T(1.9402499999999998) * U2_23 + T(2.5158) *
      (minus_U2_22 - minus_U2_33) + T(7.403999999999999) * U2_31 - T(9.862400000000001) * U2_21;
  const T N2_2 = T(9.862400000000001) * (minus_U2_33 - minus_U2_11) - (T(1.9402499999999998) * U2_13 +
      T(30.483249999999998) * U2_31) + T(2.5158) * U2_12 - T(7.403999999999999) * U2_32 - T(49.36) * Pddot2_3;
  const T N2_3 = T(49.36) * Pddot2_2 + T(12.615) * minus_Pddot2_1 + T(30.483249999999998) * U2_21 -
      T(1.9402499999999998) * U2_12 + T(7.403999999999999) * (minus_U2_11 - minus_U2_22) + T(9.862400000000001) *
      U2_23 - T(2.5158) * U2_13;

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
  const T G3_1 = U3_12 * T(36.730000000000004) + U3_13 * T(8.185);
  const T G3_2 = U3_23 * T(8.185) - minus_U3_22 * T(36.730000000000004);
  const T G3_3 = U3_32 * T(36.730000000000004) - minus_U3_33 * T(8.185);
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(36.730000000000004) * Pddot3_3 - T(8.185) * Pddot3_2 + T(23.7825) * U3_32 - T(0.9062500000000001) *
      U3_23 + T(3.6652000000000005) * (minus_U3_22 - minus_U3_33) + T(21.979499999999998) * U3_31 - T(4.8941) * U3_21;
  const T N3_2 = T(8.185) * Pddot3_1 + T(0.9062500000000001) * U3_13 + T(0.9062500000000001) * U3_31 + T(4.8941) *
      (minus_U3_33 - minus_U3_11) + T(3.6652000000000005) * U3_12 - T(21.979499999999998) * U3_32;
  const T N3_3 = T(21.979499999999998) * (minus_U3_11 - minus_U3_22) - (T(0.9062500000000001) * U3_21 + T(23.7825) *
      U3_12) + T(4.8941) * U3_23 - T(3.6652000000000005) * U3_13 - T(36.730000000000004) * Pddot3_1;

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
  const T G4_1 = U4_13 * T(15.955) - minus_U4_11 * T(24.08);
  const T G4_2 = U4_21 * T(24.08) + U4_23 * T(15.955);
  const T G4_3 = U4_31 * T(24.08) - minus_U4_33 * T(15.955);
  // N4 = h_own_4~ Pddot4 + axial(U4 (tr(J_own_4)/2 - J_own_4)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N4_1 = T(7.181850000000001) * (minus_U4_22 - minus_U4_33) - (T(7.265999999999999) * U4_32 + T(10.52425) *
      U4_23) + T(10.822) * U4_31 - T(4.7683) * U4_21 - T(15.955) * Pddot4_2;
  const T N4_2 = T(15.955) * Pddot4_1 - T(24.08) * Pddot4_3 + T(10.52425) * U4_13 - T(7.265999999999999) * U4_31 +
      T(4.7683) * (minus_U4_33 - minus_U4_11) + T(7.181850000000001) * U4_12 - T(10.822) * U4_32;
  const T N4_3 = T(24.08) * Pddot4_2 + T(7.265999999999999) * U4_21 + T(7.265999999999999) * U4_12 + T(10.822) *
      (minus_U4_11 - minus_U4_22) + T(4.7683) * U4_23 - T(7.181850000000001) * U4_13;

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
  const T G5_1 = U5_12 * T(23.79) - minus_U5_11 * T(46.809999999999995);
  const T G5_2 = U5_21 * T(46.809999999999995) - minus_U5_22 * T(23.79);
  const T G5_3 = U5_31 * T(46.809999999999995) + U5_32 * T(23.79);
  // N5 = h_own_5~ Pddot5 + axial(U5 (tr(J_own_5)/2 - J_own_5)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N5_1 = T(23.79) * Pddot5_3 + T(7.151999999999999) * U5_32 + T(7.151999999999999) * U5_23 + T(4.749) *
      (minus_U5_22 - minus_U5_33) + T(14.020499999999998) * U5_31 - T(9.35) * U5_21;
  const T N5_2 = T(9.35) * (minus_U5_33 - minus_U5_11) - (T(7.151999999999999) * U5_13 + T(28.921) * U5_31) + T(4.749)
      * U5_12 - T(14.020499999999998) * U5_32 - T(46.809999999999995) * Pddot5_3;
  const T N5_3 = T(46.809999999999995) * Pddot5_2 - T(23.79) * Pddot5_1 + T(28.921) * U5_21 - T(7.151999999999999) *
      U5_12 + T(14.020499999999998) * (minus_U5_11 - minus_U5_22) + T(9.35) * U5_23 - T(4.749) * U5_13;

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
  const T G6_1 = U6_12 * T(57.505) + U6_13 * T(7.75);
  const T G6_2 = U6_23 * T(7.75) - minus_U6_22 * T(57.505);
  const T G6_3 = U6_32 * T(57.505) - minus_U6_33 * T(7.75);
  // N6 = h_own_6~ Pddot6 + axial(U6 (tr(J_own_6)/2 - J_own_6)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N6_1 = T(57.505) * Pddot6_3 - T(7.75) * Pddot6_2 + T(49.71675) * U6_32 - T(0.8830000000000001) * U6_23 +
      T(5.7409) * (minus_U6_22 - minus_U6_33) + T(34.431) * U6_31 - T(4.6292) * U6_21;
  const T N6_2 = T(7.75) * Pddot6_1 + T(0.8830000000000001) * U6_13 + T(0.8830000000000001) * U6_31 + T(4.6292) *
      (minus_U6_33 - minus_U6_11) + T(5.7409) * U6_12 - T(34.431) * U6_32;
  const T N6_3 = T(34.431) * (minus_U6_11 - minus_U6_22) - (T(0.8830000000000001) * U6_21 + T(49.71675) * U6_12) +
      T(4.6292) * U6_23 - T(5.7409) * U6_13 - T(57.505) * Pddot6_1;

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
  const T G7_1 = U7_13 * T(14.995000000000001) - minus_U7_11 * T(22.669999999999998);
  const T G7_2 = U7_21 * T(22.669999999999998) + U7_23 * T(14.995000000000001);
  const T G7_3 = U7_31 * T(22.669999999999998) - minus_U7_33 * T(14.995000000000001);
  // N7 = h_own_7~ Pddot7 + axial(U7 (tr(J_own_7)/2 - J_own_7)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N7_1 = T(11.23605) * (minus_U7_22 - minus_U7_33) - (T(6.851999999999999) * U7_32 + T(18.16675) * U7_23) +
      T(16.96) * U7_31 - T(4.4764) * U7_21 - T(14.995000000000001) * Pddot7_2;
  const T N7_2 = T(14.995000000000001) * Pddot7_1 - T(22.669999999999998) * Pddot7_3 + T(18.16675) * U7_13 -
      T(6.851999999999999) * U7_31 + T(4.4764) * (minus_U7_33 - minus_U7_11) + T(11.23605) * U7_12 - T(16.96) * U7_32;
  const T N7_3 = T(22.669999999999998) * Pddot7_2 + T(6.851999999999999) * U7_21 + T(6.851999999999999) * U7_12 +
      T(16.96) * (minus_U7_11 - minus_U7_22) + T(4.4764) * U7_23 - T(11.23605) * U7_13;

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
  const T G8_1 = U8_12 * T(33.300000000000004) - minus_U8_11 * T(43.72);
  const T G8_2 = U8_21 * T(43.72) - minus_U8_22 * T(33.300000000000004);
  const T G8_3 = U8_31 * T(43.72) + U8_32 * T(33.300000000000004);
  // N8 = h_own_8~ Pddot8 + axial(U8 (tr(J_own_8)/2 - J_own_8)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N8_1 = T(33.300000000000004) * Pddot8_3 + T(14.949) * U8_32 + T(14.949) * U8_23 + T(6.6492) * (minus_U8_22 -
      minus_U8_33) + T(19.62) * U8_31 - T(8.7296) * U8_21;
  const T N8_2 = T(8.7296) * (minus_U8_33 - minus_U8_11) - (T(14.949) * U8_13 + T(27.02575) * U8_31) + T(6.6492) *
      U8_12 - T(19.62) * U8_32 - T(43.72) * Pddot8_3;
  const T N8_3 = T(43.72) * Pddot8_2 - T(33.300000000000004) * Pddot8_1 + T(27.02575) * U8_21 - T(14.949) * U8_12 +
      T(19.62) * (minus_U8_11 - minus_U8_22) + T(8.7296) * U8_23 - T(6.6492) * U8_13;

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
  const T G9_1 = U9_12 * T(74.545) + U9_13 * T(7.2250000000000005);
  const T G9_2 = U9_23 * T(7.2250000000000005) - minus_U9_22 * T(74.545);
  const T G9_3 = U9_32 * T(74.545) - minus_U9_33 * T(7.2250000000000005);
  // N9 = h_own_9~ Pddot9 + axial(U9 (tr(J_own_9)/2 - J_own_9)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N9_1 = T(74.545) * Pddot9_3 - T(7.2250000000000005) * Pddot9_2 + T(83.93325) * U9_32 - T(0.8507500000000001)
      * U9_23 + T(7.4431) * (minus_U9_22 - minus_U9_33) + T(44.6415) * U9_31 - T(4.3103) * U9_21;
  const T N9_2 = T(7.2250000000000005) * Pddot9_1 + T(0.8507500000000001) * U9_13 + T(0.8507500000000001) * U9_31 +
      T(4.3103) * (minus_U9_33 - minus_U9_11) + T(7.4431) * U9_12 - T(44.6415) * U9_32;
  const T N9_3 = T(44.6415) * (minus_U9_11 - minus_U9_22) - (T(0.8507500000000001) * U9_21 + T(83.93325) * U9_12) +
      T(4.3103) * U9_23 - T(7.4431) * U9_13 - T(74.545) * Pddot9_1;

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
  const T G10_1 = U10_13 * T(13.855) - minus_U10_11 * T(20.99);
  const T G10_2 = U10_21 * T(20.99) + U10_23 * T(13.855);
  const T G10_3 = U10_31 * T(20.99) - minus_U10_33 * T(13.855);
  // N10 = h_own_10~ Pddot10 + axial(U10 (tr(J_own_10)/2 - J_own_10)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N10_1 = T(14.520750000000001) * (minus_U10_22 - minus_U10_33) - (T(6.356999999999999) * U10_32 +
      T(27.366249999999997) * U10_23) + T(21.9595) * U10_31 - T(4.1305000000000005) * U10_21 - T(13.855) * Pddot10_2;
  const T N10_2 = T(13.855) * Pddot10_1 - T(20.99) * Pddot10_3 + T(27.366249999999997) * U10_13 - T(6.356999999999999)
      * U10_31 + T(4.1305000000000005) * (minus_U10_33 - minus_U10_11) + T(14.520750000000001) * U10_12 - T(21.9595) *
      U10_32;
  const T N10_3 = T(20.99) * Pddot10_2 + T(6.356999999999999) * U10_21 + T(6.356999999999999) * U10_12 + T(21.9595) *
      (minus_U10_11 - minus_U10_22) + T(4.1305000000000005) * U10_23 - T(14.520750000000001) * U10_13;

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
  const T G11_1 = U11_12 * T(40.739999999999995) - minus_U11_11 * T(40.089999999999996);
  const T G11_2 = U11_21 * T(40.089999999999996) - minus_U11_22 * T(40.739999999999995);
  const T G11_3 = U11_31 * T(40.089999999999996) + U11_32 * T(40.739999999999995);
  // N11 = h_own_11~ Pddot11 + axial(U11 (tr(J_own_11)/2 - J_own_11)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N11_1 = T(40.739999999999995) * Pddot11_3 + T(24.339) * U11_32 + T(24.339) * U11_23 + T(8.1354) *
      (minus_U11_22 - minus_U11_33) + T(23.9595) * U11_31 - T(8.0012) * U11_21;
  const T N11_2 = T(8.0012) * (minus_U11_33 - minus_U11_11) - (T(24.339) * U11_13 + T(24.7975) * U11_31) + T(8.1354) *
      U11_12 - T(23.9595) * U11_32 - T(40.089999999999996) * Pddot11_3;
  const T N11_3 = T(40.089999999999996) * Pddot11_2 - T(40.739999999999995) * Pddot11_1 + T(24.7975) * U11_21 -
      T(24.339) * U11_12 + T(23.9595) * (minus_U11_11 - minus_U11_22) + T(8.0012) * U11_23 - T(8.1354) * U11_13;

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
  const T G12_1 = U12_12 * T(87.03999999999999) + U12_13 * T(6.61);
  const T G12_2 = U12_23 * T(6.61) - minus_U12_22 * T(87.03999999999999);
  const T G12_3 = U12_32 * T(87.03999999999999) - minus_U12_33 * T(6.61);
  // N12 = h_own_12~ Pddot12 + axial(U12 (tr(J_own_12)/2 - J_own_12)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N12_1 = T(87.03999999999999) * Pddot12_3 - T(6.61) * Pddot12_2 + T(121.9365) * U12_32 -
      T(0.8095000000000001) * U12_23 + T(8.690800000000001) * (minus_U12_22 - minus_U12_33) + T(52.125) * U12_31 -
      T(3.9374000000000002) * U12_21;
  const T N12_2 = T(6.61) * Pddot12_1 + T(0.8095000000000001) * U12_13 + T(0.8095000000000001) * U12_31 +
      T(3.9374000000000002) * (minus_U12_33 - minus_U12_11) + T(8.690800000000001) * U12_12 - T(52.125) * U12_32;
  const T N12_3 = T(52.125) * (minus_U12_11 - minus_U12_22) - (T(0.8095000000000001) * U12_21 + T(121.9365) * U12_12)
      + T(3.9374000000000002) * U12_23 - T(8.690800000000001) * U12_13 - T(87.03999999999999) * Pddot12_1;

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
  const T G13_1 = U13_13 * T(12.535) - minus_U13_11 * T(19.04);
  const T G13_2 = U13_21 * T(19.04) + U13_23 * T(12.535);
  const T G13_3 = U13_31 * T(19.04) - minus_U13_33 * T(12.535);
  // N13 = h_own_13~ Pddot13 + axial(U13 (tr(J_own_13)/2 - J_own_13)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N13_1 = T(16.87395) * (minus_U13_22 - minus_U13_33) - (T(5.781) * U13_32 + T(36.8875) * U13_23) +
      T(25.577499999999997) * U13_31 - T(3.7306) * U13_21 - T(12.535) * Pddot13_2;
  const T N13_2 = T(12.535) * Pddot13_1 - T(19.04) * Pddot13_3 + T(36.8875) * U13_13 - T(5.781) * U13_31 + T(3.7306) *
      (minus_U13_33 - minus_U13_11) + T(16.87395) * U13_12 - T(25.577499999999997) * U13_32;
  const T N13_3 = T(19.04) * Pddot13_2 + T(5.781) * U13_21 + T(5.781) * U13_12 + T(25.577499999999997) * (minus_U13_11
      - minus_U13_22) + T(3.7306) * U13_23 - T(16.87395) * U13_13;

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
  const T G14_1 = U14_12 * T(45.705) - minus_U14_11 * T(35.92);
  const T G14_2 = U14_21 * T(35.92) - minus_U14_22 * T(45.705);
  const T G14_3 = U14_31 * T(35.92) + U14_32 * T(45.705);
  // N14 = h_own_14~ Pddot14 + axial(U14 (tr(J_own_14)/2 - J_own_14)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N14_1 = T(45.705) * Pddot14_3 + T(34.08675) * U14_32 + T(34.08675) * U14_23 + T(9.1266) * (minus_U14_22 -
      minus_U14_33) + T(26.796) * U14_31 - T(7.1648000000000005) * U14_21;
  const T N14_2 = T(7.1648000000000005) * (minus_U14_33 - minus_U14_11) - (T(34.08675) * U14_13 + T(22.23625) *
      U14_31) + T(9.1266) * U14_12 - T(26.796) * U14_32 - T(35.92) * Pddot14_3;
  const T N14_3 = T(35.92) * Pddot14_2 - T(45.705) * Pddot14_1 + T(22.23625) * U14_21 - T(34.08675) * U14_12 +
      T(26.796) * (minus_U14_11 - minus_U14_22) + T(7.1648000000000005) * U14_23 - T(9.1266) * U14_13;

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
  const T G15_1 = U15_12 * T(94.18) + U15_13 * T(5.905);
  const T G15_2 = U15_23 * T(5.905) - minus_U15_22 * T(94.18);
  const T G15_3 = U15_32 * T(94.18) - minus_U15_33 * T(5.905);
  // N15 = h_own_15~ Pddot15 + axial(U15 (tr(J_own_15)/2 - J_own_15)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N15_1 = T(94.18) * Pddot15_3 - T(5.905) * Pddot15_2 + T(158.25900000000001) * U15_32 - T(0.7592500000000001)
      * U15_23 + T(9.403) * (minus_U15_22 - minus_U15_33) + T(56.3955) * U15_31 - T(3.5105) * U15_21;
  const T N15_2 = T(5.905) * Pddot15_1 + T(0.7592500000000001) * U15_13 + T(0.7592500000000001) * U15_31 + T(3.5105) *
      (minus_U15_33 - minus_U15_11) + T(9.403) * U15_12 - T(56.3955) * U15_32;
  const T N15_3 = T(56.3955) * (minus_U15_11 - minus_U15_22) - (T(0.7592500000000001) * U15_21 + T(158.25900000000001)
      * U15_12) + T(3.5105) * U15_23 - T(9.403) * U15_13 - T(94.18) * Pddot15_1;

  // ---- body 16 (body_16) on body 15
  const T thetadot16 = y[15];
  const T thetaddot16 = ydot[15];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cosines[15];
  const T minus_E16_13 = sines[15];
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
  const T t16_7 = Pddot15_1 + U15_13 * T(0.1) - minus_U15_11 * T(0.6);
  const T t16_8 = Pddot15_3 + U15_31 * T(0.6) - minus_U15_33 * T(0.1);
  const T Pddot16_1 = E16_11 * t16_7 - minus_E16_13 * t16_8;
  const T Pddot16_2 = Pddot15_2 + U15_21 * T(0.6) + U15_23 * T(0.1);
  const T Pddot16_3 = minus_E16_13 * t16_7 + E16_11 * t16_8;
  // G16 = U16 h_own_16: inertia less applied force, body axes [N]
  const T G16_1 = U16_13 * T(11.035) - minus_U16_11 * T(16.82);
  const T G16_2 = U16_21 * T(16.82) + U16_23 * T(11.035);
  const T G16_3 = U16_31 * T(16.82) - minus_U16_33 * T(11.035);
  // N16 = h_own_16~ Pddot16 + axial(U16 (tr(J_own_16)/2 - J_own_16)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N16_1 = T(18.133650000000003) * (minus_U16_22 - minus_U16_33) - (T(5.124) * U16_32 + T(45.252250000000004) *
      U16_23) + T(27.570999999999998) * U16_31 - T(3.2767) * U16_21 - T(11.035) * Pddot16_2;
  const T N16_2 = T(11.035) * Pddot16_1 - T(16.82) * Pddot16_3 + T(45.252250000000004) * U16_13 - T(5.124) * U16_31 +
      T(3.2767) * (minus_U16_33 - minus_U16_11) + T(18.133650000000003) * U16_12 - T(27.570999999999998) * U16_32;
  const T N16_3 = T(16.82) * Pddot16_2 + T(5.124) * U16_21 + T(5.124) * U16_12 + T(27.570999999999998) * (minus_U16_11
      - minus_U16_22) + T(3.2767) * U16_23 - T(18.133650000000003) * U16_13;

  // ---- body 17 (body_17) on body 16
  const T thetadot17 = y[16];
  const T thetaddot17 = ydot[16];
  // E17^T = Rot(b17, theta17): E takes components in the lower body to those in the body
  const T E17_11 = cosines[16];
  const T E17_12 = sines[16];
  // omega17 = thetadot17 b17 + E17 omega16: absolute angular velocity, body axes [rad/s]
  const T omega17_1 = E17_11 * omega16_1 + E17_12 * omega16_2;
  const T omega17_2 = E17_11 * omega16_2 - E17_12 * omega16_1;
  const T omega17_3 = thetadot17 + omega16_3;
  // omegadot17 = -thetadot17 b17~ E17 omega16 + thetaddot17 b17 + E17 omegadot16: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot17_1 = thetadot17 * omega17_2 + E17_11 * omegadot16_1 + E17_12 * omegadot16_2;
  const T omegadot17_2 = E17_11 * omegadot16_2 - E17_12 * omegadot16_1 - thetadot17 * omega17_1;
  const T omegadot17_3 = thetaddot17 + omegadot16_3;
  // U17 = omega17~ omega17~ + omegadot17~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t17_1 = omega17_3 * omega17_3;
  const T t17_2 = omega17_2 * omega17_2;
  const T minus_U17_11 = t17_1 + t17_2;
  const T t17_3 = omega17_2 * omega17_1;
  const T U17_12 = t17_3 - omegadot17_3;
  const T t17_4 = omega17_3 * omega17_1;
  const T U17_13 = t17_4 + omegadot17_2;
  const T U17_21 = t17_3 + omegadot17_3;
  const T t17_5 = omega17_1 * omega17_1;
  const T minus_U17_22 = t17_1 + t17_5;
  const T t17_6 = omega17_3 * omega17_2;
  const T U17_23 = t17_6 - omegadot17_1;
  const T U17_31 = t17_4 - omegadot17_2;
  const T U17_32 = t17_6 + omegadot17_1;
  const T minus_U17_33 = t17_2 + t17_5;
  // Pddot17 = E17 (U16 q17 + Pddot16): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t17_7 = Pddot16_1 + U16_12 * T(1.65) - minus_U16_11 * T(0.3);
  const T t17_8 = Pddot16_2 + U16_21 * T(0.3) - minus_U16_22 * T(1.65);
  const T Pddot17_1 = E17_11 * t17_7 + E17_12 * t17_8;
  const T Pddot17_2 = E17_11 * t17_8 - E17_12 * t17_7;
  const T Pddot17_3 = Pddot16_3 + U16_31 * T(0.3) + U16_32 * T(1.65);
  // G17 = U17 h_own_17: inertia less applied force, body axes [N]
  const T G17_1 = U17_12 * T(47.79) - minus_U17_11 * T(31.209999999999997);
  const T G17_2 = U17_21 * T(31.209999999999997) - minus_U17_22 * T(47.79);
  const T G17_3 = U17_31 * T(31.209999999999997) + U17_32 * T(47.79);
  // N17 = h_own_17~ Pddot17 + axial(U17 (tr(J_own_17)/2 - J_own_17)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N17_1 = T(47.79) * Pddot17_3 + T(42.714) * U17_32 + T(42.714) * U17_23 + T(9.5418) * (minus_U17_22 -
      minus_U17_33) + T(27.886499999999998) * U17_31 - T(6.2204) * U17_21;
  const T N17_2 = T(6.2204) * (minus_U17_33 - minus_U17_11) - (T(42.714) * U17_13 + T(19.342) * U17_31) + T(9.5418) *
      U17_12 - T(27.886499999999998) * U17_32 - T(31.209999999999997) * Pddot17_3;
  const T N17_3 = T(31.209999999999997) * Pddot17_2 - T(47.79) * Pddot17_1 + T(19.342) * U17_21 - T(42.714) * U17_12 +
      T(27.886499999999998) * (minus_U17_11 - minus_U17_22) + T(6.2204) * U17_23 - T(9.5418) * U17_13;

  // ---- body 18 (body_18) on body 17
  const T thetadot18 = y[17];
  const T thetaddot18 = ydot[17];
  // E18^T = Rot(b18, theta18): E takes components in the lower body to those in the body
  const T E18_22 = cosines[17];
  const T E18_23 = sines[17];
  // omega18 = thetadot18 b18 + E18 omega17: absolute angular velocity, body axes [rad/s]
  const T omega18_1 = thetadot18 + omega17_1;
  const T omega18_2 = E18_22 * omega17_2 + E18_23 * omega17_3;
  const T omega18_3 = E18_22 * omega17_3 - E18_23 * omega17_2;
  // omegadot18 = -thetadot18 b18~ E18 omega17 + thetaddot18 b18 + E18 omegadot17: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot18_1 = thetaddot18 + omegadot17_1;
  const T omegadot18_2 = thetadot18 * omega18_3 + E18_22 * omegadot17_2 + E18_23 * omegadot17_3;
  const T omegadot18_3 = E18_22 * omegadot17_3 - E18_23 * omegadot17_2 - thetadot18 * omega18_2;
  // U18 = omega18~ omega18~ + omegadot18~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t18_1 = omega18_3 * omega18_3;
  const T t18_2 = omega18_2 * omega18_2;
  const T minus_U18_11 = t18_1 + t18_2;
  const T t18_3 = omega18_2 * omega18_1;
  const T U18_12 = t18_3 - omegadot18_3;
  const T t18_4 = omega18_3 * omega18_1;
  const T U18_13 = t18_4 + omegadot18_2;
  const T U18_21 = t18_3 + omegadot18_3;
  const T t18_5 = omega18_1 * omega18_1;
  const T minus_U18_22 = t18_1 + t18_5;
  const T t18_6 = omega18_3 * omega18_2;
  const T U18_23 = t18_6 - omegadot18_1;
  const T U18_31 = t18_4 - omegadot18_2;
  const T U18_32 = t18_6 + omegadot18_1;
  const T minus_U18_33 = t18_2 + t18_5;
  // Pddot18 = E18 (U17 q18 + Pddot17): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot18_1 = Pddot17_1 + U17_12 * T(0.9) + U17_13 * T(0.2);
  const T t18_7 = Pddot17_2 + U17_23 * T(0.2) - minus_U17_22 * T(0.9);
  const T t18_8 = Pddot17_3 + U17_32 * T(0.9) - minus_U17_33 * T(0.2);
  const T Pddot18_2 = E18_22 * t18_7 + E18_23 * t18_8;
  const T Pddot18_3 = E18_22 * t18_8 - E18_23 * t18_7;
  // G18 = U18 h_own_18: inertia less applied force, body axes [N]
  const T G18_1 = U18_12 * T(95.155) + U18_13 * T(5.11);
  const T G18_2 = U18_23 * T(5.11) - minus_U18_22 * T(95.155);
  const T G18_3 = U18_32 * T(95.155) - minus_U18_33 * T(5.11);
  // N18 = h_own_18~ Pddot18 + axial(U18 (tr(J_own_18)/2 - J_own_18)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N18_1 = T(95.155) * Pddot18_3 - T(5.11) * Pddot18_2 + T(186.46124999999998) * U18_32 - T(0.7000000000000001)
      * U18_23 + T(9.4987) * (minus_U18_22 - minus_U18_33) + T(56.967) * U18_31 - T(3.0296) * U18_21;
  const T N18_2 = T(5.11) * Pddot18_1 + T(0.7000000000000001) * U18_13 + T(0.7000000000000001) * U18_31 + T(3.0296) *
      (minus_U18_33 - minus_U18_11) + T(9.4987) * U18_12 - T(56.967) * U18_32;
  const T N18_3 = T(56.967) * (minus_U18_11 - minus_U18_22) - (T(0.7000000000000001) * U18_21 + T(186.46124999999998)
      * U18_12) + T(3.0296) * U18_23 - T(9.4987) * U18_13 - T(95.155) * Pddot18_1;

  // ---- body 19 (body_19) on body 18
  const T thetadot19 = y[18];
  const T thetaddot19 = ydot[18];
  // E19^T = Rot(b19, theta19): E takes components in the lower body to those in the body
  const T E19_11 = cosines[18];
  const T minus_E19_13 = sines[18];
  // omega19 = thetadot19 b19 + E19 omega18: absolute angular velocity, body axes [rad/s]
  const T omega19_1 = E19_11 * omega18_1 - minus_E19_13 * omega18_3;
  const T omega19_2 = thetadot19 + omega18_2;
  const T omega19_3 = minus_E19_13 * omega18_1 + E19_11 * omega18_3;
  // omegadot19 = -thetadot19 b19~ E19 omega18 + thetaddot19 b19 + E19 omegadot18: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot19_1 = E19_11 * omegadot18_1 - minus_E19_13 * omegadot18_3 - thetadot19 * omega19_3;
  const T omegadot19_2 = thetaddot19 + omegadot18_2;
  const T omegadot19_3 = thetadot19 * omega19_1 + minus_E19_13 * omegadot18_1 + E19_11 * omegadot18_3;
  // U19 = omega19~ omega19~ + omegadot19~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t19_1 = omega19_3 * omega19_3;
  const T t19_2 = omega19_2 * omega19_2;
  const T minus_U19_11 = t19_1 + t19_2;
  const T t19_3 = omega19_2 * omega19_1;
  const T U19_12 = t19_3 - omegadot19_3;
  const T t19_4 = omega19_3 * omega19_1;
  const T U19_13 = t19_4 + omegadot19_2;
  const T U19_21 = t19_3 + omegadot19_3;
  const T t19_5 = omega19_1 * omega19_1;
  const T minus_U19_22 = t19_1 + t19_5;
  const T t19_6 = omega19_3 * omega19_2;
  const T U19_23 = t19_6 - omegadot19_1;
  const T U19_31 = t19_4 - omegadot19_2;
  const T U19_32 = t19_6 + omegadot19_1;
  const T minus_U19_33 = t19_2 + t19_5;
  // Pddot19 = E19 (U18 q19 + Pddot18): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t19_7 = Pddot18_1 + U18_13 * T(0.1) - minus_U18_11 * T(0.6);
  const T t19_8 = Pddot18_3 + U18_31 * T(0.6) - minus_U18_33 * T(0.1);
  const T Pddot19_1 = E19_11 * t19_7 - minus_E19_13 * t19_8;
  const T Pddot19_2 = Pddot18_2 + U18_21 * T(0.6) + U18_23 * T(0.1);
  const T Pddot19_3 = minus_E19_13 * t19_7 + E19_11 * t19_8;
  // G19 = U19 h_own_19: inertia less applied force, body axes [N]
  const T G19_1 = U19_13 * T(9.355) - minus_U19_11 * T(14.33);
  const T G19_2 = U19_21 * T(14.33) + U19_23 * T(9.355);
  const T G19_3 = U19_31 * T(14.33) - minus_U19_33 * T(9.355);
  // N19 = h_own_19~ Pddot19 + axial(U19 (tr(J_own_19)/2 - J_own_19)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N19_1 = T(18.13785) * (minus_U19_22 - minus_U19_33) - (T(4.386) * U19_32 + T(50.739250000000006) * U19_23) +
      T(27.697) * U19_31 - T(2.7688) * U19_21 - T(9.355) * Pddot19_2;
  const T N19_2 = T(9.355) * Pddot19_1 - T(14.33) * Pddot19_3 + T(50.739250000000006) * U19_13 - T(4.386) * U19_31 +
      T(2.7688) * (minus_U19_33 - minus_U19_11) + T(18.13785) * U19_12 - T(27.697) * U19_32;
  const T N19_3 = T(14.33) * Pddot19_2 + T(4.386) * U19_21 + T(4.386) * U19_12 + T(27.697) * (minus_U19_11 -
      minus_U19_22) + T(2.7688) * U19_23 - T(18.13785) * U19_13;

  // ---- body 20 (body_20) on body 19
  const T thetadot20 = y[19];
  const T thetaddot20 = ydot[19];
  // E20^T = Rot(b20, theta20): E takes components in the lower body to those in the body
  const T E20_11 = cosines[19];
  const T E20_12 = sines[19];
  // omega20 = thetadot20 b20 + E20 omega19: absolute angular velocity, body axes [rad/s]
  const T omega20_1 = E20_11 * omega19_1 + E20_12 * omega19_2;
  const T omega20_2 = E20_11 * omega19_2 - E20_12 * omega19_1;
  const T omega20_3 = thetadot20 + omega19_3;
  // omegadot20 = -thetadot20 b20~ E20 omega19 + thetaddot20 b20 + E20 omegadot19: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot20_1 = thetadot20 * omega20_2 + E20_11 * omegadot19_1 + E20_12 * omegadot19_2;
  const T omegadot20_2 = E20_11 * omegadot19_2 - E20_12 * omegadot19_1 - thetadot20 * omega20_1;
  const T omegadot20_3 = thetaddot20 + omegadot19_3;
  // U20 = omega20~ omega20~ + omegadot20~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t20_1 = omega20_3 * omega20_3;
  const T t20_2 = omega20_2 * omega20_2;
  const T minus_U20_11 = t20_1 + t20_2;
  const T t20_3 = omega20_2 * omega20_1;
  const T U20_12 = t20_3 - omegadot20_3;
  const T t20_4 = omega20_3 * omega20_1;
  const T U20_13 = t20_4 + omegadot20_2;
  const T U20_21 = t20_3 + omegadot20_3;
  const T t20_5 = omega20_1 * omega20_1;
  const T minus_U20_22 = t20_1 + t20_5;
  const T t20_6 = omega20_3 * omega20_2;
  const T U20_23 = t20_6 - omegadot20_1;
  const T U20_31 = t20_4 - omegadot20_2;
  const T U20_32 = t20_6 + omegadot20_1;
  const T minus_U20_33 = t20_2 + t20_5;
  // Pddot20 = E20 (U19 q20 + Pddot19): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t20_7 = Pddot19_1 + U19_12 * T(1.95) - minus_U19_11 * T(0.3);
  const T t20_8 = Pddot19_2 + U19_21 * T(0.3) - minus_U19_22 * T(1.95);
  const T Pddot20_1 = E20_11 * t20_7 + E20_12 * t20_8;
  const T Pddot20_2 = E20_11 * t20_8 - E20_12 * t20_7;
  const T Pddot20_3 = Pddot19_3 + U19_31 * T(0.3) + U19_32 * T(1.95);
  // G20 = U20 h_own_20: inertia less applied force, body axes [N]
  const T G20_1 = U20_12 * T(46.59) - minus_U20_11 * T(25.959999999999997);
  const T G20_2 = U20_21 * T(25.959999999999997) - minus_U20_22 * T(46.59);
  const T G20_3 = U20_31 * T(25.959999999999997) + U20_32 * T(46.59);
  // N20 = h_own_20~ Pddot20 + axial(U20 (tr(J_own_20)/2 - J_own_20)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N20_1 = T(46.59) * Pddot20_3 + T(48.499500000000005) * U20_32 + T(48.499500000000005) * U20_23 + T(9.3) *
      (minus_U20_22 - minus_U20_33) + T(26.988) * U20_31 - T(5.168) * U20_21;
  const T N20_2 = T(5.168) * (minus_U20_33 - minus_U20_11) - (T(48.499500000000005) * U20_13 + T(16.114749999999997) *
      U20_31) + T(9.3) * U20_12 - T(26.988) * U20_32 - T(25.959999999999997) * Pddot20_3;
  const T N20_3 = T(25.959999999999997) * Pddot20_2 - T(46.59) * Pddot20_1 + T(16.114749999999997) * U20_21 -
      T(48.499500000000005) * U20_12 + T(26.988) * (minus_U20_11 - minus_U20_22) + T(5.168) * U20_23 - T(9.3) *
      U20_13;

  // ---- body 21 (body_21) on body 20
  const T thetadot21 = y[20];
  const T thetaddot21 = ydot[20];
  // E21^T = Rot(b21, theta21): E takes components in the lower body to those in the body
  const T E21_22 = cosines[20];
  const T E21_23 = sines[20];
  // omega21 = thetadot21 b21 + E21 omega20: absolute angular velocity, body axes [rad/s]
  const T omega21_1 = thetadot21 + omega20_1;
  const T omega21_2 = E21_22 * omega20_2 + E21_23 * omega20_3;
  const T omega21_3 = E21_22 * omega20_3 - E21_23 * omega20_2;
  // omegadot21 = -thetadot21 b21~ E21 omega20 + thetaddot21 b21 + E21 omegadot20: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot21_1 = thetaddot21 + omegadot20_1;
  const T omegadot21_2 = thetadot21 * omega21_3 + E21_22 * omegadot20_2 + E21_23 * omegadot20_3;
  const T omegadot21_3 = E21_22 * omegadot20_3 - E21_23 * omegadot20_2 - thetadot21 * omega21_2;
  // U21 = omega21~ omega21~ + omegadot21~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t21_1 = omega21_3 * omega21_3;
  const T t21_2 = omega21_2 * omega21_2;
  const T minus_U21_11 = t21_1 + t21_2;
  const T t21_3 = omega21_2 * omega21_1;
  const T U21_12 = t21_3 - omegadot21_3;
  const T t21_4 = omega21_3 * omega21_1;
  const T U21_13 = t21_4 + omegadot21_2;
  const T U21_21 = t21_3 + omegadot21_3;
  const T t21_5 = omega21_1 * omega21_1;
  const T minus_U21_22 = t21_1 + t21_5;
  const T t21_6 = omega21_3 * omega21_2;
  const T U21_23 = t21_6 - omegadot21_1;
  const T U21_31 = t21_4 - omegadot21_2;
  const T U21_32 = t21_6 + omegadot21_1;
  const T minus_U21_33 = t21_2 + t21_5;
  // Pddot21 = E21 (U20 q21 + Pddot20): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot21_1 = Pddot20_1 + U20_12 * T(1.05) + U20_13 * T(0.2);
  const T t21_7 = Pddot20_2 + U20_23 * T(0.2) - minus_U20_22 * T(1.05);
  const T t21_8 = Pddot20_3 + U20_32 * T(1.05) - minus_U20_33 * T(0.2);
  const T Pddot21_2 = E21_22 * t21_7 + E21_23 * t21_8;
  const T Pddot21_3 = E21_22 * t21_8 - E21_23 * t21_7;
  // G21 = U21 h_own_21: inertia less applied force, body axes [N]
  const T G21_1 = U21_12 * T(89.155) + U21_13 * T(4.2250000000000005);
  const T G21_2 = U21_23 * T(4.2250000000000005) - minus_U21_22 * T(89.155);
  const T G21_3 = U21_32 * T(89.155) - minus_U21_33 * T(4.2250000000000005);
  // N21 = h_own_21~ Pddot21 + axial(U21 (tr(J_own_21)/2 - J_own_21)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N21_1 = T(89.155) * Pddot21_3 - T(4.2250000000000005) * Pddot21_2 + T(199.13175) * U21_32 - T(0.63175) *
      U21_23 + T(8.8969) * (minus_U21_22 - minus_U21_33) + T(53.3535) * U21_31 - T(2.4947) * U21_21;
  const T N21_2 = T(4.2250000000000005) * Pddot21_1 + T(0.63175) * U21_13 + T(0.63175) * U21_31 + T(2.4947) *
      (minus_U21_33 - minus_U21_11) + T(8.8969) * U21_12 - T(53.3535) * U21_32;
  const T N21_3 = T(53.3535) * (minus_U21_11 - minus_U21_22) - (T(0.63175) * U21_21 + T(199.13175) * U21_12) +
      T(2.4947) * U21_23 - T(8.8969) * U21_13 - T(89.155) * Pddot21_1;

  // ---- body 22 (body_22) on body 21
  const T thetadot22 = y[21];
  const T thetaddot22 = ydot[21];
  // E22^T = Rot(b22, theta22): E takes components in the lower body to those in the body
  const T E22_11 = cosines[21];
  const T minus_E22_13 = sines[21];
  // omega22 = thetadot22 b22 + E22 omega21: absolute angular velocity, body axes [rad/s]
  const T omega22_1 = E22_11 * omega21_1 - minus_E22_13 * omega21_3;
  const T omega22_2 = thetadot22 + omega21_2;
  const T omega22_3 = minus_E22_13 * omega21_1 + E22_11 * omega21_3;
  // omegadot22 = -thetadot22 b22~ E22 omega21 + thetaddot22 b22 + E22 omegadot21: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot22_1 = E22_11 * omegadot21_1 - minus_E22_13 * omegadot21_3 - thetadot22 * omega22_3;
  const T omegadot22_2 = thetaddot22 + omegadot21_2;
  const T omegadot22_3 = thetadot22 * omega22_1 + minus_E22_13 * omegadot21_1 + E22_11 * omegadot21_3;
  // U22 = omega22~ omega22~ + omegadot22~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t22_1 = omega22_3 * omega22_3;
  const T t22_2 = omega22_2 * omega22_2;
  const T minus_U22_11 = t22_1 + t22_2;
  const T t22_3 = omega22_2 * omega22_1;
  const T U22_12 = t22_3 - omegadot22_3;
  const T t22_4 = omega22_3 * omega22_1;
  const T U22_13 = t22_4 + omegadot22_2;
  const T U22_21 = t22_3 + omegadot22_3;
  const T t22_5 = omega22_1 * omega22_1;
  const T minus_U22_22 = t22_1 + t22_5;
  const T t22_6 = omega22_3 * omega22_2;
  const T U22_23 = t22_6 - omegadot22_1;
  const T U22_31 = t22_4 - omegadot22_2;
  const T U22_32 = t22_6 + omegadot22_1;
  const T minus_U22_33 = t22_2 + t22_5;
  // Pddot22 = E22 (U21 q22 + Pddot21): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t22_7 = Pddot21_1 + U21_13 * T(0.1) - minus_U21_11 * T(0.6);
  const T t22_8 = Pddot21_3 + U21_31 * T(0.6) - minus_U21_33 * T(0.1);
  const T Pddot22_1 = E22_11 * t22_7 - minus_E22_13 * t22_8;
  const T Pddot22_2 = Pddot21_2 + U21_21 * T(0.6) + U21_23 * T(0.1);
  const T Pddot22_3 = minus_E22_13 * t22_7 + E22_11 * t22_8;
  // G22 = U22 h_own_22: inertia less applied force, body axes [N]
  const T G22_1 = U22_13 * T(7.495) - minus_U22_11 * T(11.57);
  const T G22_2 = U22_21 * T(11.57) + U22_23 * T(7.495);
  const T G22_3 = U22_31 * T(11.57) - minus_U22_33 * T(7.495);
  // N22 = h_own_22~ Pddot22 + axial(U22 (tr(J_own_22)/2 - J_own_22)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N22_1 = T(16.72455) * (minus_U22_22 - minus_U22_33) - (T(3.5669999999999997) * U22_32 +
      T(51.384249999999994) * U22_23) + T(25.7125) * U22_31 - T(2.2069) * U22_21 - T(7.495) * Pddot22_2;
  const T N22_2 = T(7.495) * Pddot22_1 - T(11.57) * Pddot22_3 + T(51.384249999999994) * U22_13 - T(3.5669999999999997)
      * U22_31 + T(2.2069) * (minus_U22_33 - minus_U22_11) + T(16.72455) * U22_12 - T(25.7125) * U22_32;
  const T N22_3 = T(11.57) * Pddot22_2 + T(3.5669999999999997) * U22_21 + T(3.5669999999999997) * U22_12 + T(25.7125)
      * (minus_U22_11 - minus_U22_22) + T(2.2069) * U22_23 - T(16.72455) * U22_13;

  // ---- body 23 (body_23) on body 22
  const T thetadot23 = y[22];
  const T thetaddot23 = ydot[22];
  // E23^T = Rot(b23, theta23): E takes components in the lower body to those in the body
  const T E23_11 = cosines[22];
  const T E23_12 = sines[22];
  // omega23 = thetadot23 b23 + E23 omega22: absolute angular velocity, body axes [rad/s]
  const T omega23_1 = E23_11 * omega22_1 + E23_12 * omega22_2;
  const T omega23_2 = E23_11 * omega22_2 - E23_12 * omega22_1;
  const T omega23_3 = thetadot23 + omega22_3;
  // omegadot23 = -thetadot23 b23~ E23 omega22 + thetaddot23 b23 + E23 omegadot22: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot23_1 = thetadot23 * omega23_2 + E23_11 * omegadot22_1 + E23_12 * omegadot22_2;
  const T omegadot23_2 = E23_11 * omegadot22_2 - E23_12 * omegadot22_1 - thetadot23 * omega23_1;
  const T omegadot23_3 = thetaddot23 + omegadot22_3;
  // U23 = omega23~ omega23~ + omegadot23~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t23_1 = omega23_3 * omega23_3;
  const T t23_2 = omega23_2 * omega23_2;
  const T minus_U23_11 = t23_1 + t23_2;
  const T t23_3 = omega23_2 * omega23_1;
  const T U23_12 = t23_3 - omegadot23_3;
  const T t23_4 = omega23_3 * omega23_1;
  const T U23_13 = t23_4 + omegadot23_2;
  const T U23_21 = t23_3 + omegadot23_3;
  const T t23_5 = omega23_1 * omega23_1;
  const T minus_U23_22 = t23_1 + t23_5;
  const T t23_6 = omega23_3 * omega23_2;
  const T U23_23 = t23_6 - omegadot23_1;
  const T U23_31 = t23_4 - omegadot23_2;
  const T U23_32 = t23_6 + omegadot23_1;
  const T minus_U23_33 = t23_2 + t23_5;
  // Pddot23 = E23 (U22 q23 + Pddot22): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t23_7 = Pddot22_1 + U22_12 * T(2.25) - minus_U22_11 * T(0.3);
  const T t23_8 = Pddot22_2 + U22_21 * T(0.3) - minus_U22_22 * T(2.25);
  const T Pddot23_1 = E23_11 * t23_7 + E23_12 * t23_8;
  const T Pddot23_2 = E23_11 * t23_8 - E23_12 * t23_7;
  const T Pddot23_3 = Pddot22_3 + U22_31 * T(0.3) + U22_32 * T(2.25);
  // G23 = U23 h_own_23: inertia less applied force, body axes [N]
  const T G23_1 = U23_12 * T(41.699999999999996) - minus_U23_11 * T(20.169999999999998);
  const T G23_2 = U23_21 * T(20.169999999999998) - minus_U23_22 * T(41.699999999999996);
  const T G23_3 = U23_31 * T(20.169999999999998) + U23_32 * T(41.699999999999996);
  // N23 = h_own_23~ Pddot23 + axial(U23 (tr(J_own_23)/2 - J_own_23)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N23_1 = T(41.699999999999996) * Pddot23_3 + T(49.479) * U23_32 + T(49.479) * U23_23 + T(8.3202) *
      (minus_U23_22 - minus_U23_33) + T(23.857499999999998) * U23_31 - T(4.0076) * U23_21;
  const T N23_2 = T(4.0076) * (minus_U23_33 - minus_U23_11) - (T(49.479) * U23_13 + T(12.554499999999999) * U23_31) +
      T(8.3202) * U23_12 - T(23.857499999999998) * U23_32 - T(20.169999999999998) * Pddot23_3;
  const T N23_3 = T(20.169999999999998) * Pddot23_2 - T(41.699999999999996) * Pddot23_1 + T(12.554499999999999) *
      U23_21 - T(49.479) * U23_12 + T(23.857499999999998) * (minus_U23_11 - minus_U23_22) + T(4.0076) * U23_23 -
      T(8.3202) * U23_13;

  // ---- body 24 (body_24) on body 23
  const T thetadot24 = y[23];
  const T thetaddot24 = ydot[23];
  // E24^T = Rot(b24, theta24): E takes components in the lower body to those in the body
  const T E24_22 = cosines[23];
  const T E24_23 = sines[23];
  // omega24 = thetadot24 b24 + E24 omega23: absolute angular velocity, body axes [rad/s]
  const T omega24_1 = thetadot24 + omega23_1;
  const T omega24_2 = E24_22 * omega23_2 + E24_23 * omega23_3;
  const T omega24_3 = E24_22 * omega23_3 - E24_23 * omega23_2;
  // omegadot24 = -thetadot24 b24~ E24 omega23 + thetaddot24 b24 + E24 omegadot23: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot24_1 = thetaddot24 + omegadot23_1;
  const T omegadot24_2 = thetadot24 * omega24_3 + E24_22 * omegadot23_2 + E24_23 * omegadot23_3;
  const T omegadot24_3 = E24_22 * omegadot23_3 - E24_23 * omegadot23_2 - thetadot24 * omega24_2;
  // U24 = omega24~ omega24~ + omegadot24~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t24_1 = omega24_3 * omega24_3;
  const T t24_2 = omega24_2 * omega24_2;
  const T minus_U24_11 = t24_1 + t24_2;
  const T t24_3 = omega24_2 * omega24_1;
  const T U24_12 = t24_3 - omegadot24_3;
  const T t24_4 = omega24_3 * omega24_1;
  const T U24_13 = t24_4 + omegadot24_2;
  const T U24_21 = t24_3 + omegadot24_3;
  const T t24_5 = omega24_1 * omega24_1;
  const T minus_U24_22 = t24_1 + t24_5;
  const T t24_6 = omega24_3 * omega24_2;
  const T U24_23 = t24_6 - omegadot24_1;
  const T U24_31 = t24_4 - omegadot24_2;
  const T U24_32 = t24_6 + omegadot24_1;
  const T minus_U24_33 = t24_2 + t24_5;
  // Pddot24 = E24 (U23 q24 + Pddot23): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot24_1 = Pddot23_1 + U23_12 * T(1.2) + U23_13 * T(0.2);
  const T t24_7 = Pddot23_2 + U23_23 * T(0.2) - minus_U23_22 * T(1.2);
  const T t24_8 = Pddot23_3 + U23_32 * T(1.2) - minus_U23_33 * T(0.2);
  const T Pddot24_2 = E24_22 * t24_7 + E24_23 * t24_8;
  const T Pddot24_3 = E24_22 * t24_8 - E24_23 * t24_7;
  // G24 = U24 h_own_24: inertia less applied force, body axes [N]
  const T G24_1 = U24_12 * T(75.37) + U24_13 * T(3.25);
  const T G24_2 = U24_23 * T(3.25) - minus_U24_22 * T(75.37);
  const T G24_3 = U24_32 * T(75.37) - minus_U24_33 * T(3.25);
  // N24 = h_own_24~ Pddot24 + axial(U24 (tr(J_own_24)/2 - J_own_24)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N24_1 = T(75.37) * Pddot24_3 - T(3.25) * Pddot24_2 + T(187.887) * U24_32 - T(0.5545) * U24_23 + T(7.5166) *
      (minus_U24_22 - minus_U24_33) + T(45.068999999999996) * U24_31 - T(1.9058) * U24_21;
  const T N24_2 = T(3.25) * Pddot24_1 + T(0.5545) * U24_13 + T(0.5545) * U24_31 + T(1.9058) * (minus_U24_33 -
      minus_U24_11) + T(7.5166) * U24_12 - T(45.068999999999996) * U24_32;
  const T N24_3 = T(45.068999999999996) * (minus_U24_11 - minus_U24_22) - (T(0.5545) * U24_21 + T(187.887) * U24_12) +
      T(1.9058) * U24_23 - T(7.5166) * U24_13 - T(75.37) * Pddot24_1;

  // ---- body 25 (body_25) on body 24
  const T thetadot25 = y[24];
  const T thetaddot25 = ydot[24];
  // E25^T = Rot(b25, theta25): E takes components in the lower body to those in the body
  const T E25_11 = cosines[24];
  const T minus_E25_13 = sines[24];
  // omega25 = thetadot25 b25 + E25 omega24: absolute angular velocity, body axes [rad/s]
  const T omega25_1 = E25_11 * omega24_1 - minus_E25_13 * omega24_3;
  const T omega25_2 = thetadot25 + omega24_2;
  const T omega25_3 = minus_E25_13 * omega24_1 + E25_11 * omega24_3;
  // omegadot25 = -thetadot25 b25~ E25 omega24 + thetaddot25 b25 + E25 omegadot24: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot25_1 = E25_11 * omegadot24_1 - minus_E25_13 * omegadot24_3 - thetadot25 * omega25_3;
  const T omegadot25_2 = thetaddot25 + omegadot24_2;
  const T omegadot25_3 = thetadot25 * omega25_1 + minus_E25_13 * omegadot24_1 + E25_11 * omegadot24_3;
  // U25 = omega25~ omega25~ + omegadot25~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t25_1 = omega25_3 * omega25_3;
  const T t25_2 = omega25_2 * omega25_2;
  const T minus_U25_11 = t25_1 + t25_2;
  const T t25_3 = omega25_2 * omega25_1;
  const T U25_12 = t25_3 - omegadot25_3;
  const T t25_4 = omega25_3 * omega25_1;
  const T U25_13 = t25_4 + omegadot25_2;
  const T U25_21 = t25_3 + omegadot25_3;
  const T t25_5 = omega25_1 * omega25_1;
  const T minus_U25_22 = t25_1 + t25_5;
  const T t25_6 = omega25_3 * omega25_2;
  const T U25_23 = t25_6 - omegadot25_1;
  const T U25_31 = t25_4 - omegadot25_2;
  const T U25_32 = t25_6 + omegadot25_1;
  const T minus_U25_33 = t25_2 + t25_5;
  // Pddot25 = E25 (U24 q25 + Pddot24): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t25_7 = Pddot24_1 + U24_13 * T(0.1) - minus_U24_11 * T(0.6);
  const T t25_8 = Pddot24_3 + U24_31 * T(0.6) - minus_U24_33 * T(0.1);
  const T Pddot25_1 = E25_11 * t25_7 - minus_E25_13 * t25_8;
  const T Pddot25_2 = Pddot24_2 + U24_21 * T(0.6) + U24_23 * T(0.1);
  const T Pddot25_3 = minus_E25_13 * t25_7 + E25_11 * t25_8;
  // G25 = U25 h_own_25: inertia less applied force, body axes [N]
  const T G25_1 = U25_13 * T(5.455) - minus_U25_11 * T(8.54);
  const T G25_2 = U25_21 * T(8.54) + U25_23 * T(5.455);
  const T G25_3 = U25_31 * T(8.54) - minus_U25_33 * T(5.455);
  // N25 = h_own_25~ Pddot25 + axial(U25 (tr(J_own_25)/2 - J_own_25)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N25_1 = T(13.731750000000002) * (minus_U25_22 - minus_U25_33) - (T(2.667) * U25_32 + T(44.980000000000004) *
      U25_23) + T(21.3745) * U25_31 - T(1.591) * U25_21 - T(5.455) * Pddot25_2;
  const T N25_2 = T(5.455) * Pddot25_1 - T(8.54) * Pddot25_3 + T(44.980000000000004) * U25_13 - T(2.667) * U25_31 +
      T(1.591) * (minus_U25_33 - minus_U25_11) + T(13.731750000000002) * U25_12 - T(21.3745) * U25_32;
  const T N25_3 = T(8.54) * Pddot25_2 + T(2.667) * U25_21 + T(2.667) * U25_12 + T(21.3745) * (minus_U25_11 -
      minus_U25_22) + T(1.591) * U25_23 - T(13.731750000000002) * U25_13;

  // ---- body 26 (body_26) on body 25
  const T thetadot26 = y[25];
  const T thetaddot26 = ydot[25];
  // E26^T = Rot(b26, theta26): E takes components in the lower body to those in the body
  const T E26_11 = cosines[25];
  const T E26_12 = sines[25];
  // omega26 = thetadot26 b26 + E26 omega25: absolute angular velocity, body axes [rad/s]
  const T omega26_1 = E26_11 * omega25_1 + E26_12 * omega25_2;
  const T omega26_2 = E26_11 * omega25_2 - E26_12 * omega25_1;
  const T omega26_3 = thetadot26 + omega25_3;
  // omegadot26 = -thetadot26 b26~ E26 omega25 + thetaddot26 b26 + E26 omegadot25: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot26_1 = thetadot26 * omega26_2 + E26_11 * omegadot25_1 + E26_12 * omegadot25_2;
  const T omegadot26_2 = E26_11 * omegadot25_2 - E26_12 * omegadot25_1 - thetadot26 * omega26_1;
  const T omegadot26_3 = thetaddot26 + omegadot25_3;
  // U26 = omega26~ omega26~ + omegadot26~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t26_1 = omega26_3 * omega26_3;
  const T t26_2 = omega26_2 * omega26_2;
  const T minus_U26_11 = t26_1 + t26_2;
  const T t26_3 = omega26_2 * omega26_1;
  const T U26_12 = t26_3 - omegadot26_3;
  const T t26_4 = omega26_3 * omega26_1;
  const T U26_13 = t26_4 + omegadot26_2;
  const T U26_21 = t26_3 + omegadot26_3;
  const T t26_5 = omega26_1 * omega26_1;
  const T minus_U26_22 = t26_1 + t26_5;
  const T t26_6 = omega26_3 * omega26_2;
  const T U26_23 = t26_6 - omegadot26_1;
  const T U26_31 = t26_4 - omegadot26_2;
  const T U26_32 = t26_6 + omegadot26_1;
  const T minus_U26_33 = t26_2 + t26_5;
  // Pddot26 = E26 (U25 q26 + Pddot25): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t26_7 = Pddot25_1 + U25_12 * T(2.55) - minus_U25_11 * T(0.3);
  const T t26_8 = Pddot25_2 + U25_21 * T(0.3) - minus_U25_22 * T(2.55);
  const T Pddot26_1 = E26_11 * t26_7 + E26_12 * t26_8;
  const T Pddot26_2 = E26_11 * t26_8 - E26_12 * t26_7;
  const T Pddot26_3 = Pddot25_3 + U25_31 * T(0.3) + U25_32 * T(2.55);
  // G26 = U26 h_own_26: inertia less applied force, body axes [N]
  const T G26_1 = U26_12 * T(32.715) - minus_U26_11 * T(13.84);
  const T G26_2 = U26_21 * T(13.84) - minus_U26_22 * T(32.715);
  const T G26_3 = U26_31 * T(13.84) + U26_32 * T(32.715);
  // N26 = h_own_26~ Pddot26 + axial(U26 (tr(J_own_26)/2 - J_own_26)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N26_1 = T(32.715) * Pddot26_3 + T(43.44525000000001) * U26_32 + T(43.44525000000001) * U26_23 +
      T(6.521400000000001) * (minus_U26_22 - minus_U26_33) + T(18.252) * U26_31 - T(2.7392) * U26_21;
  const T N26_2 = T(2.7392) * (minus_U26_33 - minus_U26_11) - (T(43.44525000000001) * U26_13 + T(8.661249999999999) *
      U26_31) + T(6.521400000000001) * U26_12 - T(18.252) * U26_32 - T(13.84) * Pddot26_3;
  const T N26_3 = T(13.84) * Pddot26_2 - T(32.715) * Pddot26_1 + T(8.661249999999999) * U26_21 - T(43.44525000000001)
      * U26_12 + T(18.252) * (minus_U26_11 - minus_U26_22) + T(2.7392) * U26_23 - T(6.521400000000001) * U26_13;

  // ---- body 27 (body_27) on body 26
  const T thetadot27 = y[26];
  const T thetaddot27 = ydot[26];
  // E27^T = Rot(b27, theta27): E takes components in the lower body to those in the body
  const T E27_22 = cosines[26];
  const T E27_23 = sines[26];
  // omega27 = thetadot27 b27 + E27 omega26: absolute angular velocity, body axes [rad/s]
  const T omega27_1 = thetadot27 + omega26_1;
  const T omega27_2 = E27_22 * omega26_2 + E27_23 * omega26_3;
  const T omega27_3 = E27_22 * omega26_3 - E27_23 * omega26_2;
  // omegadot27 = -thetadot27 b27~ E27 omega26 + thetaddot27 b27 + E27 omegadot26: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot27_1 = thetaddot27 + omegadot26_1;
  const T omegadot27_2 = thetadot27 * omega27_3 + E27_22 * omegadot26_2 + E27_23 * omegadot26_3;
  const T omegadot27_3 = E27_22 * omegadot26_3 - E27_23 * omegadot26_2 - thetadot27 * omega27_2;
  // U27 = omega27~ omega27~ + omegadot27~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t27_1 = omega27_3 * omega27_3;
  const T t27_2 = omega27_2 * omega27_2;
  const T minus_U27_11 = t27_1 + t27_2;
  const T t27_3 = omega27_2 * omega27_1;
  const T U27_12 = t27_3 - omegadot27_3;
  const T t27_4 = omega27_3 * omega27_1;
  const T U27_13 = t27_4 + omegadot27_2;
  const T U27_21 = t27_3 + omegadot27_3;
  const T t27_5 = omega27_1 * omega27_1;
  const T minus_U27_22 = t27_1 + t27_5;
  const T t27_6 = omega27_3 * omega27_2;
  const T U27_23 = t27_6 - omegadot27_1;
  const T U27_31 = t27_4 - omegadot27_2;
  const T U27_32 = t27_6 + omegadot27_1;
  const T minus_U27_33 = t27_2 + t27_5;
  // Pddot27 = E27 (U26 q27 + Pddot26): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot27_1 = Pddot26_1 + U26_12 * T(1.35) + U26_13 * T(0.2);
  const T t27_7 = Pddot26_2 + U26_23 * T(0.2) - minus_U26_22 * T(1.35);
  const T t27_8 = Pddot26_3 + U26_32 * T(1.35) - minus_U26_33 * T(0.2);
  const T Pddot27_2 = E27_22 * t27_7 + E27_23 * t27_8;
  const T Pddot27_3 = E27_22 * t27_8 - E27_23 * t27_7;
  // G27 = U27 h_own_27: inertia less applied force, body axes [N]
  const T G27_1 = U27_12 * T(52.989999999999995) + U27_13 * T(2.185);
  const T G27_2 = U27_23 * T(2.185) - minus_U27_22 * T(52.989999999999995);
  const T G27_3 = U27_32 * T(52.989999999999995) - minus_U27_33 * T(2.185);
  // N27 = h_own_27~ Pddot27 + axial(U27 (tr(J_own_27)/2 - J_own_27)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N27_1 = T(52.989999999999995) * Pddot27_3 - T(2.185) * Pddot27_2 + T(143.3715) * U27_32 - T(0.46825) *
      U27_23 + T(5.2768) * (minus_U27_22 - minus_U27_33) + T(31.627499999999998) * U27_31 - T(1.2629) * U27_21;
  const T N27_2 = T(2.185) * Pddot27_1 + T(0.46825) * U27_13 + T(0.46825) * U27_31 + T(1.2629) * (minus_U27_33 -
      minus_U27_11) + T(5.2768) * U27_12 - T(31.627499999999998) * U27_32;
  const T N27_3 = T(31.627499999999998) * (minus_U27_11 - minus_U27_22) - (T(0.46825) * U27_21 + T(143.3715) * U27_12)
      + T(1.2629) * U27_23 - T(5.2768) * U27_13 - T(52.989999999999995) * Pddot27_1;

  // ---- body 28 (body_28) on body 27
  const T thetadot28 = y[27];
  const T thetaddot28 = ydot[27];
  // E28^T = Rot(b28, theta28): E takes components in the lower body to those in the body
  const T E28_11 = cosines[27];
  const T minus_E28_13 = sines[27];
  // omega28 = thetadot28 b28 + E28 omega27: absolute angular velocity, body axes [rad/s]
  const T omega28_1 = E28_11 * omega27_1 - minus_E28_13 * omega27_3;
  const T omega28_2 = thetadot28 + omega27_2;
  const T omega28_3 = minus_E28_13 * omega27_1 + E28_11 * omega27_3;
  // omegadot28 = -thetadot28 b28~ E28 omega27 + thetaddot28 b28 + E28 omegadot27: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot28_1 = E28_11 * omegadot27_1 - minus_E28_13 * omegadot27_3 - thetadot28 * omega28_3;
  const T omegadot28_2 = thetaddot28 + omegadot27_2;
  const T omegadot28_3 = thetadot28 * omega28_1 + minus_E28_13 * omegadot27_1 + E28_11 * omegadot27_3;
  // U28 = omega28~ omega28~ + omegadot28~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t28_1 = omega28_3 * omega28_3;
  const T t28_2 = omega28_2 * omega28_2;
  const T minus_U28_11 = t28_1 + t28_2;
  const T t28_3 = omega28_2 * omega28_1;
  const T U28_12 = t28_3 - omegadot28_3;
  const T t28_4 = omega28_3 * omega28_1;
  const T U28_13 = t28_4 + omegadot28_2;
  const T U28_21 = t28_3 + omegadot28_3;
  const T t28_5 = omega28_1 * omega28_1;
  const T minus_U28_22 = t28_1 + t28_5;
  const T t28_6 = omega28_3 * omega28_2;
  const T U28_23 = t28_6 - omegadot28_1;
  const T U28_31 = t28_4 - omegadot28_2;
  const T U28_32 = t28_6 + omegadot28_1;
  const T minus_U28_33 = t28_2 + t28_5;
  // Pddot28 = E28 (U27 q28 + Pddot27): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t28_7 = Pddot27_1 + U27_13 * T(0.1) - minus_U27_11 * T(0.6);
  const T t28_8 = Pddot27_3 + U27_31 * T(0.6) - minus_U27_33 * T(0.1);
  const T Pddot28_1 = E28_11 * t28_7 - minus_E28_13 * t28_8;
  const T Pddot28_2 = Pddot27_2 + U27_21 * T(0.6) + U27_23 * T(0.1);
  const T Pddot28_3 = minus_E28_13 * t28_7 + E28_11 * t28_8;
  // G28 = U28 h_own_28: inertia less applied force, body axes [N]
  const T G28_1 = U28_13 * T(3.2350000000000003) - minus_U28_11 * T(5.239999999999999);
  const T G28_2 = U28_21 * T(5.239999999999999) + U28_23 * T(3.2350000000000003);
  const T G28_3 = U28_31 * T(5.239999999999999) - minus_U28_33 * T(3.2350000000000003);
  // N28 = h_own_28~ Pddot28 + axial(U28 (tr(J_own_28)/2 - J_own_28)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N28_1 = T(8.99745) * (minus_U28_22 - minus_U28_33) - (T(1.686) * U28_32 + T(29.076249999999998) * U28_23) +
      T(14.439999999999998) * U28_31 - T(0.9211) * U28_21 - T(3.2350000000000003) * Pddot28_2;
  const T N28_2 = T(3.2350000000000003) * Pddot28_1 - T(5.239999999999999) * Pddot28_3 + T(29.076249999999998) *
      U28_13 - T(1.686) * U28_31 + T(0.9211) * (minus_U28_33 - minus_U28_11) + T(8.99745) * U28_12 -
      T(14.439999999999998) * U28_32;
  const T N28_3 = T(5.239999999999999) * Pddot28_2 + T(1.686) * U28_21 + T(1.686) * U28_12 + T(14.439999999999998) *
      (minus_U28_11 - minus_U28_22) + T(0.9211) * U28_23 - T(8.99745) * U28_13;

  // ---- body 29 (body_29) on body 28
  const T thetadot29 = y[28];
  const T thetaddot29 = ydot[28];
  // E29^T = Rot(b29, theta29): E takes components in the lower body to those in the body
  const T E29_11 = cosines[28];
  const T E29_12 = sines[28];
  // omega29 = thetadot29 b29 + E29 omega28: absolute angular velocity, body axes [rad/s]
  const T omega29_1 = E29_11 * omega28_1 + E29_12 * omega28_2;
  const T omega29_2 = E29_11 * omega28_2 - E29_12 * omega28_1;
  const T omega29_3 = thetadot29 + omega28_3;
  // omegadot29 = -thetadot29 b29~ E29 omega28 + thetaddot29 b29 + E29 omegadot28: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot29_1 = thetadot29 * omega29_2 + E29_11 * omegadot28_1 + E29_12 * omegadot28_2;
  const T omegadot29_2 = E29_11 * omegadot28_2 - E29_12 * omegadot28_1 - thetadot29 * omega29_1;
  const T omegadot29_3 = thetaddot29 + omegadot28_3;
  // U29 = omega29~ omega29~ + omegadot29~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t29_1 = omega29_3 * omega29_3;
  const T t29_2 = omega29_2 * omega29_2;
  const T minus_U29_11 = t29_1 + t29_2;
  const T t29_3 = omega29_2 * omega29_1;
  const T U29_12 = t29_3 - omegadot29_3;
  const T t29_4 = omega29_3 * omega29_1;
  const T U29_13 = t29_4 + omegadot29_2;
  const T U29_21 = t29_3 + omegadot29_3;
  const T t29_5 = omega29_1 * omega29_1;
  const T minus_U29_22 = t29_1 + t29_5;
  const T t29_6 = omega29_3 * omega29_2;
  const T U29_23 = t29_6 - omegadot29_1;
  const T U29_31 = t29_4 - omegadot29_2;
  const T U29_32 = t29_6 + omegadot29_1;
  const T minus_U29_33 = t29_2 + t29_5;
  // Pddot29 = E29 (U28 q29 + Pddot28): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t29_7 = Pddot28_1 + U28_12 * T(2.8499999999999996) - minus_U28_11 * T(0.3);
  const T t29_8 = Pddot28_2 + U28_21 * T(0.3) - minus_U28_22 * T(2.8499999999999996);
  const T Pddot29_1 = E29_11 * t29_7 + E29_12 * t29_8;
  const T Pddot29_2 = E29_11 * t29_8 - E29_12 * t29_7;
  const T Pddot29_3 = Pddot28_3 + U28_31 * T(0.3) + U28_32 * T(2.8499999999999996);
  // G29 = U29 h_own_29: inertia less applied force, body axes [N]
  const T G29_1 = U29_12 * T(19.23) - minus_U29_11 * T(6.97);
  const T G29_2 = U29_21 * T(6.97) - minus_U29_22 * T(19.23);
  const T G29_3 = U29_31 * T(6.97) + U29_32 * T(19.23);
  // N29 = h_own_29~ Pddot29 + axial(U29 (tr(J_own_29)/2 - J_own_29)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N29_1 = T(19.23) * Pddot29_3 + T(27.948) * U29_32 + T(27.948) * U29_23 + T(3.8226) * (minus_U29_22 -
      minus_U29_33) + T(9.9285) * U29_31 - T(1.3628) * U29_21;
  const T N29_2 = T(1.3628) * (minus_U29_33 - minus_U29_11) - (T(27.948) * U29_13 + T(4.435) * U29_31) + T(3.8226) *
      U29_12 - T(9.9285) * U29_32 - T(6.97) * Pddot29_3;
  const T N29_3 = T(6.97) * Pddot29_2 - T(19.23) * Pddot29_1 + T(4.435) * U29_21 - T(27.948) * U29_12 + T(9.9285) *
      (minus_U29_11 - minus_U29_22) + T(1.3628) * U29_23 - T(3.8226) * U29_13;

  // ---- body 30 (body_30) on body 29
  const T thetadot30 = y[29];
  const T thetaddot30 = ydot[29];
  // E30^T = Rot(b30, theta30): E takes components in the lower body to those in the body
  const T E30_22 = cosines[29];
  const T E30_23 = sines[29];
  // omega30 = thetadot30 b30 + E30 omega29: absolute angular velocity, body axes [rad/s]
  const T omega30_1 = thetadot30 + omega29_1;
  const T omega30_2 = E30_22 * omega29_2 + E30_23 * omega29_3;
  const T omega30_3 = E30_22 * omega29_3 - E30_23 * omega29_2;
  // omegadot30 = -thetadot30 b30~ E30 omega29 + thetaddot30 b30 + E30 omegadot29: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot30_1 = thetaddot30 + omegadot29_1;
  const T omegadot30_2 = thetadot30 * omega30_3 + E30_22 * omegadot29_2 + E30_23 * omegadot29_3;
  const T omegadot30_3 = E30_22 * omegadot29_3 - E30_23 * omegadot29_2 - thetadot30 * omega30_2;
  // U30 = omega30~ omega30~ + omegadot30~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t30_1 = omega30_3 * omega30_3;
  const T t30_2 = omega30_2 * omega30_2;
  const T minus_U30_11 = t30_1 + t30_2;
  const T t30_3 = omega30_2 * omega30_1;
  const T U30_12 = t30_3 - omegadot30_3;
  const T t30_4 = omega30_3 * omega30_1;
  const T U30_13 = t30_4 + omegadot30_2;
  const T U30_21 = t30_3 + omegadot30_3;
  const T t30_5 = omega30_1 * omega30_1;
  const T minus_U30_22 = t30_1 + t30_5;
  const T t30_6 = omega30_3 * omega30_2;
  const T U30_23 = t30_6 - omegadot30_1;
  const T U30_31 = t30_4 - omegadot30_2;
  const T U30_32 = t30_6 + omegadot30_1;
  const T minus_U30_33 = t30_2 + t30_5;
  // Pddot30 = E30 (U29 q30 + Pddot29): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot30_1 = Pddot29_1 + U29_12 * T(1.5) + U29_13 * T(0.2);
  const T t30_7 = Pddot29_2 + U29_23 * T(0.2) - minus_U29_22 * T(1.5);
  const T t30_8 = Pddot29_3 + U29_32 * T(1.5) - minus_U29_33 * T(0.2);
  const T Pddot30_2 = E30_22 * t30_7 + E30_23 * t30_8;
  const T Pddot30_3 = E30_22 * t30_8 - E30_23 * t30_7;
  // G30 = U30 h_own_30: inertia less applied force, body axes [N]
  const T G30_1 = U30_12 * T(21.205000000000002) + U30_13 * T(1.03);
  const T G30_2 = U30_23 * T(1.03) - minus_U30_22 * T(21.205000000000002);
  const T G30_3 = U30_32 * T(21.205000000000002) - minus_U30_33 * T(1.03);
  // N30 = h_own_30~ Pddot30 + axial(U30 (tr(J_own_30)/2 - J_own_30)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N30_1 = T(21.205000000000002) * Pddot30_3 - T(1.03) * Pddot30_2 + T(55.25775000000001) * U30_32 - T(0.373) *
      U30_23 + T(2.0965000000000003) * (minus_U30_22 - minus_U30_33) + T(12.543) * U30_31 - T(0.566) * U30_21;
  const T N30_2 = T(1.03) * Pddot30_1 + T(0.373) * U30_13 + T(0.373) * U30_31 + T(0.566) * (minus_U30_33 -
      minus_U30_11) + T(2.0965000000000003) * U30_12 - T(12.543) * U30_32;
  const T N30_3 = T(12.543) * (minus_U30_11 - minus_U30_22) - (T(0.373) * U30_21 + T(55.25775000000001) * U30_12) +
      T(0.566) * U30_23 - T(2.0965000000000003) * U30_13 - T(21.205000000000002) * Pddot30_1;

  // ---- body 31 (body_31) on body 30
  const T thetadot31 = y[30];
  const T thetaddot31 = ydot[30];
  // E31^T = Rot(b31, theta31): E takes components in the lower body to those in the body
  const T E31_11 = cosines[30];
  const T minus_E31_13 = sines[30];
  // omega31 = thetadot31 b31 + E31 omega30: absolute angular velocity, body axes [rad/s]
  const T omega31_1 = E31_11 * omega30_1 - minus_E31_13 * omega30_3;
  const T omega31_2 = thetadot31 + omega30_2;
  const T omega31_3 = minus_E31_13 * omega30_1 + E31_11 * omega30_3;
  // omegadot31 = -thetadot31 b31~ E31 omega30 + thetaddot31 b31 + E31 omegadot30: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot31_1 = E31_11 * omegadot30_1 - minus_E31_13 * omegadot30_3 - thetadot31 * omega31_3;
  const T omegadot31_2 = thetaddot31 + omegadot30_2;
  const T omegadot31_3 = thetadot31 * omega31_1 + minus_E31_13 * omegadot30_1 + E31_11 * omegadot30_3;
  // U31 = omega31~ omega31~ + omegadot31~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t31_1 = omega31_3 * omega31_3;
  const T t31_2 = omega31_2 * omega31_2;
  const T minus_U31_11 = t31_1 + t31_2;
  const T t31_3 = omega31_2 * omega31_1;
  const T U31_12 = t31_3 - omegadot31_3;
  const T t31_4 = omega31_3 * omega31_1;
  const T U31_13 = t31_4 + omegadot31_2;
  const T U31_21 = t31_3 + omegadot31_3;
  const T t31_5 = omega31_1 * omega31_1;
  const T minus_U31_22 = t31_1 + t31_5;
  const T t31_6 = omega31_3 * omega31_2;
  const T U31_23 = t31_6 - omegadot31_1;
  const T U31_31 = t31_4 - omegadot31_2;
  const T U31_32 = t31_6 + omegadot31_1;
  const T minus_U31_33 = t31_2 + t31_5;
  // Pddot31 = E31 (U30 q31 + Pddot30): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t31_7 = Pddot30_1 + U30_13 * T(0.1) - minus_U30_11 * T(0.6);
  const T t31_8 = Pddot30_3 + U30_31 * T(0.6) - minus_U30_33 * T(0.1);
  const T Pddot31_1 = E31_11 * t31_7 - minus_E31_13 * t31_8;
  const T Pddot31_2 = Pddot30_2 + U30_21 * T(0.6) + U30_23 * T(0.1);
  const T Pddot31_3 = minus_E31_13 * t31_7 + E31_11 * t31_8;
  // G31 = U31 h_own_31: inertia less applied force, body axes [N]
  const T G31_1 = U31_13 * T(0.8350000000000001) - minus_U31_11 * T(1.67);
  const T G31_2 = U31_21 * T(1.67) + U31_23 * T(0.8350000000000001);
  const T G31_3 = U31_31 * T(1.67) - minus_U31_33 * T(0.8350000000000001);
  // N31 = h_own_31~ Pddot31 + axial(U31 (tr(J_own_31)/2 - J_own_31)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N31_1 = T(2.3596500000000002) * (minus_U31_22 - minus_U31_33) - (T(0.624) * U31_32 + T(0.89575) * U31_23) +
      T(4.666) * U31_31 - T(0.19720000000000004) * U31_21 - T(0.8350000000000001) * Pddot31_2;
  const T N31_2 = T(0.8350000000000001) * Pddot31_1 - T(1.67) * Pddot31_3 + T(0.89575) * U31_13 - T(0.624) * U31_31 +
      T(0.19720000000000004) * (minus_U31_33 - minus_U31_11) + T(2.3596500000000002) * U31_12 - T(4.666) * U31_32;
  const T N31_3 = T(1.67) * Pddot31_2 + T(0.624) * U31_21 + T(0.624) * U31_12 + T(4.666) * (minus_U31_11 -
      minus_U31_22) + T(0.19720000000000004) * U31_23 - T(2.3596500000000002) * U31_13;

  // ---- body 32 (body_32) on body 31
  const T thetadot32 = y[31];
  const T thetaddot32 = ydot[31];
  // E32^T = Z32^T Rot(b32, theta32): E takes components in the lower body to those in the body
  const T t32_1 = cosines[31];
  const T t32_2 = sines[31];
  const T E32_11 = T(0.44721359549995804) * t32_1 - T(0.8944271909999159) * t32_2;
  const T E32_12 = T(0.8944271909999159) * t32_1 + T(0.44721359549995804) * t32_2;
  // omega32 = thetadot32 b32 + E32 omega31: absolute angular velocity, body axes [rad/s]
  const T omega32_1 = E32_11 * omega31_1 + E32_12 * omega31_2;
  const T omega32_2 = E32_11 * omega31_2 - E32_12 * omega31_1;
  const T omega32_3 = thetadot32 + omega31_3;
  // omegadot32 = -thetadot32 b32~ E32 omega31 + thetaddot32 b32 + E32 omegadot31: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot32_1 = thetadot32 * omega32_2 + E32_11 * omegadot31_1 + E32_12 * omegadot31_2;
  const T omegadot32_2 = E32_11 * omegadot31_2 - E32_12 * omegadot31_1 - thetadot32 * omega32_1;
  const T omegadot32_3 = thetaddot32 + omegadot31_3;
  // U32 = omega32~ omega32~ + omegadot32~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t32_3 = omega32_3 * omega32_3;
  const T t32_4 = omega32_2 * omega32_2;
  const T minus_U32_11 = t32_3 + t32_4;
  const T t32_5 = omega32_2 * omega32_1;
  const T U32_12 = t32_5 - omegadot32_3;
  const T t32_6 = omega32_3 * omega32_1;
  const T U32_13 = t32_6 + omegadot32_2;
  const T U32_21 = t32_5 + omegadot32_3;
  const T t32_7 = omega32_1 * omega32_1;
  const T minus_U32_22 = t32_3 + t32_7;
  const T t32_8 = omega32_3 * omega32_2;
  const T U32_23 = t32_8 - omegadot32_1;
  const T U32_31 = t32_6 - omegadot32_2;
  const T U32_32 = t32_8 + omegadot32_1;
  const T minus_U32_33 = t32_4 + t32_7;
  // Pddot32 = E32 (U31 q32 + Pddot31): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot32_2 = E32_11 * (Pddot31_2 + U31_21 * T(0.3) - minus_U31_22 * T(3.1500000000000004)) - E32_12 *
      (Pddot31_1 + U31_12 * T(3.1500000000000004) - minus_U31_11 * T(0.3));
  const T Pddot32_3 = Pddot31_3 + U31_31 * T(0.3) + U31_32 * T(3.1500000000000004);
  // G32 = U32 h_own_32: inertia less applied force, body axes [N]
  const T minus_G32_1 = minus_U32_11 * T(0.9391485505499118);
  const T G32_2 = U32_21 * T(0.9391485505499118);
  const T G32_3 = U32_31 * T(0.9391485505499118);
  // N32 = h_own_32~ Pddot32 + axial(U32 (tr(J_own_32)/2 - J_own_32)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N32_1 = T(0.21000000000000002) * U32_32 + T(0.21000000000000002) * U32_23 + T(0.018782971010998236) *
      (minus_U32_22 - minus_U32_33) - T(0.02100000000000002) * U32_31 - T(0.15026376808798592) * U32_21;
  const T N32_2 = T(0.15026376808798592) * (minus_U32_33 - minus_U32_11) - (T(0.21000000000000002) * U32_13 +
      T(0.3360000000000001) * U32_31) + T(0.018782971010998236) * U32_12 + T(0.02100000000000002) * U32_32 -
      T(0.9391485505499118) * Pddot32_3;
  const T N32_3 = T(0.9391485505499118) * Pddot32_2 + T(0.3360000000000001) * U32_21 - T(0.21000000000000002) * U32_12
      - T(0.02100000000000002) * (minus_U32_11 - minus_U32_22) + T(0.15026376808798592) * U32_23 -
      T(0.018782971010998236) * U32_13;

  // ---- body 32 (body_32) and what it carries
  // r_theta32 = b32 . N32 - tau_body_32_: Kane's equation of the angle [N m]
  const T r_theta32 = N32_3 - u.tau_32;
  r[31] = r_theta32;

  // ---- body 31 (body_31) and what it carries
  // S31 = E32^T G32 + G31: sum of the force balances of the subtree, body axes [N]
  const T b31_1 = E32_11 * minus_G32_1 + E32_12 * G32_2;
  const T S31_1 = G31_1 - b31_1;
  const T b31_2 = E32_11 * G32_2 - E32_12 * minus_G32_1;
  const T S31_2 = b31_2 + G31_2;
  const T S31_3 = G32_3 + G31_3;
  // rho31 = q32~ E32^T G32 + E32^T N32 + N31: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho31_1 = N31_1 + T(3.1500000000000004) * G32_3 + E32_11 * N32_1 - E32_12 * N32_2;
  const T rho31_2 = N31_2 + E32_12 * N32_1 + E32_11 * N32_2 - T(0.3) * G32_3;
  const T rho31_3 = N32_3 + N31_3 + T(0.3) * b31_2 + T(3.1500000000000004) * b31_1;
  // r_theta31 = b31 . rho31 - tau_body_31_: Kane's equation of the angle [N m]
  const T r_theta31 = rho31_2 - u.tau_31;
  r[30] = r_theta31;

  // ---- body 30 (body_30) and what it carries
  // S30 = E31^T S31 + G30: sum of the force balances of the subtree, body axes [N]
  const T b30_1 = E31_11 * S31_1 + minus_E31_13 * S31_3;
  const T S30_1 = b30_1 + G30_1;
  const T S30_2 = S31_2 + G30_2;
  const T b30_2 = E31_11 * S31_3 - minus_E31_13 * S31_1;
  const T S30_3 = b30_2 + G30_3;
  // rho30 = q31~ E31^T S31 + E31^T rho31 + N30: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho30_1 = N30_1 + E31_11 * rho31_1 + minus_E31_13 * rho31_3 - T(0.1) * S31_2;
  const T rho30_2 = rho31_2 + N30_2 + T(0.1) * b30_1 - T(0.6) * b30_2;
  const T rho30_3 = N30_3 + T(0.6) * S31_2 + E31_11 * rho31_3 - minus_E31_13 * rho31_1;
  // r_theta30 = b30 . rho30 - tau_body_30_: Kane's equation of the angle [N m]
  const T r_theta30 = rho30_1 - u.tau_30;
  r[29] = r_theta30;

  // ---- body 29 (body_29) and what it carries
  // S29 = E30^T S30 + G29: sum of the force balances of the subtree, body axes [N]
  const T S29_1 = S30_1 + G29_1;
  const T b29_1 = E30_22 * S30_2 - E30_23 * S30_3;
  const T S29_2 = b29_1 + G29_2;
  const T b29_2 = E30_23 * S30_2 + E30_22 * S30_3;
  const T S29_3 = b29_2 + G29_3;
  // rho29 = q30~ E30^T S30 + E30^T rho30 + N29: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho29_1 = rho30_1 + N29_1 + T(1.5) * b29_2 - T(0.2) * b29_1;
  const T rho29_2 = N29_2 + T(0.2) * S30_1 + E30_22 * rho30_2 - E30_23 * rho30_3;
  const T rho29_3 = N29_3 + E30_23 * rho30_2 + E30_22 * rho30_3 - T(1.5) * S30_1;
  // r_theta29 = b29 . rho29 - tau_body_29_: Kane's equation of the angle [N m]
  const T r_theta29 = rho29_3 - u.tau_29;
  r[28] = r_theta29;

  // ---- body 28 (body_28) and what it carries
  // S28 = E29^T S29 + G28: sum of the force balances of the subtree, body axes [N]
  const T b28_1 = E29_11 * S29_1 - E29_12 * S29_2;
  const T S28_1 = b28_1 + G28_1;
  const T b28_2 = E29_12 * S29_1 + E29_11 * S29_2;
  const T S28_2 = b28_2 + G28_2;
  const T S28_3 = S29_3 + G28_3;
  // rho28 = q29~ E29^T S29 + E29^T rho29 + N28: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho28_1 = N28_1 + T(2.8499999999999996) * S29_3 + E29_11 * rho29_1 - E29_12 * rho29_2;
  const T rho28_2 = N28_2 + E29_12 * rho29_1 + E29_11 * rho29_2 - T(0.3) * S29_3;
  const T rho28_3 = rho29_3 + N28_3 + T(0.3) * b28_2 - T(2.8499999999999996) * b28_1;
  // r_theta28 = b28 . rho28 - tau_body_28_: Kane's equation of the angle [N m]
  const T r_theta28 = rho28_2 - u.tau_28;
  r[27] = r_theta28;

  // ---- body 27 (body_27) and what it carries
  // S27 = E28^T S28 + G27: sum of the force balances of the subtree, body axes [N]
  const T b27_1 = E28_11 * S28_1 + minus_E28_13 * S28_3;
  const T S27_1 = b27_1 + G27_1;
  const T S27_2 = S28_2 + G27_2;
  const T b27_2 = E28_11 * S28_3 - minus_E28_13 * S28_1;
  const T S27_3 = b27_2 + G27_3;
  // rho27 = q28~ E28^T S28 + E28^T rho28 + N27: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho27_1 = N27_1 + E28_11 * rho28_1 + minus_E28_13 * rho28_3 - T(0.1) * S28_2;
  const T rho27_2 = rho28_2 + N27_2 + T(0.1) * b27_1 - T(0.6) * b27_2;
  const T rho27_3 = N27_3 + T(0.6) * S28_2 + E28_11 * rho28_3 - minus_E28_13 * rho28_1;
  // r_theta27 = b27 . rho27 - tau_body_27_: Kane's equation of the angle [N m]
  const T r_theta27 = rho27_1 - u.tau_27;
  r[26] = r_theta27;

  // ---- body 26 (body_26) and what it carries
  // S26 = E27^T S27 + G26: sum of the force balances of the subtree, body axes [N]
  const T S26_1 = S27_1 + G26_1;
  const T b26_1 = E27_22 * S27_2 - E27_23 * S27_3;
  const T S26_2 = b26_1 + G26_2;
  const T b26_2 = E27_23 * S27_2 + E27_22 * S27_3;
  const T S26_3 = b26_2 + G26_3;
  // rho26 = q27~ E27^T S27 + E27^T rho27 + N26: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho26_1 = rho27_1 + N26_1 + T(1.35) * b26_2 - T(0.2) * b26_1;
  const T rho26_2 = N26_2 + T(0.2) * S27_1 + E27_22 * rho27_2 - E27_23 * rho27_3;
  const T rho26_3 = N26_3 + E27_23 * rho27_2 + E27_22 * rho27_3 - T(1.35) * S27_1;
  // r_theta26 = b26 . rho26 - tau_body_26_: Kane's equation of the angle [N m]
  const T r_theta26 = rho26_3 - u.tau_26;
  r[25] = r_theta26;

  // ---- body 25 (body_25) and what it carries
  // S25 = E26^T S26 + G25: sum of the force balances of the subtree, body axes [N]
  const T b25_1 = E26_11 * S26_1 - E26_12 * S26_2;
  const T S25_1 = b25_1 + G25_1;
  const T b25_2 = E26_12 * S26_1 + E26_11 * S26_2;
  const T S25_2 = b25_2 + G25_2;
  const T S25_3 = S26_3 + G25_3;
  // rho25 = q26~ E26^T S26 + E26^T rho26 + N25: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho25_1 = N25_1 + T(2.55) * S26_3 + E26_11 * rho26_1 - E26_12 * rho26_2;
  const T rho25_2 = N25_2 + E26_12 * rho26_1 + E26_11 * rho26_2 - T(0.3) * S26_3;
  const T rho25_3 = rho26_3 + N25_3 + T(0.3) * b25_2 - T(2.55) * b25_1;
  // r_theta25 = b25 . rho25 - tau_body_25_: Kane's equation of the angle [N m]
  const T r_theta25 = rho25_2 - u.tau_25;
  r[24] = r_theta25;

  // ---- body 24 (body_24) and what it carries
  // S24 = E25^T S25 + G24: sum of the force balances of the subtree, body axes [N]
  const T b24_1 = E25_11 * S25_1 + minus_E25_13 * S25_3;
  const T S24_1 = b24_1 + G24_1;
  const T S24_2 = S25_2 + G24_2;
  const T b24_2 = E25_11 * S25_3 - minus_E25_13 * S25_1;
  const T S24_3 = b24_2 + G24_3;
  // rho24 = q25~ E25^T S25 + E25^T rho25 + N24: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho24_1 = N24_1 + E25_11 * rho25_1 + minus_E25_13 * rho25_3 - T(0.1) * S25_2;
  const T rho24_2 = rho25_2 + N24_2 + T(0.1) * b24_1 - T(0.6) * b24_2;
  const T rho24_3 = N24_3 + T(0.6) * S25_2 + E25_11 * rho25_3 - minus_E25_13 * rho25_1;
  // r_theta24 = b24 . rho24 - tau_body_24_: Kane's equation of the angle [N m]
  const T r_theta24 = rho24_1 - u.tau_24;
  r[23] = r_theta24;

  // ---- body 23 (body_23) and what it carries
  // S23 = E24^T S24 + G23: sum of the force balances of the subtree, body axes [N]
  const T S23_1 = S24_1 + G23_1;
  const T b23_1 = E24_22 * S24_2 - E24_23 * S24_3;
  const T S23_2 = b23_1 + G23_2;
  const T b23_2 = E24_23 * S24_2 + E24_22 * S24_3;
  const T S23_3 = b23_2 + G23_3;
  // rho23 = q24~ E24^T S24 + E24^T rho24 + N23: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho23_1 = rho24_1 + N23_1 + T(1.2) * b23_2 - T(0.2) * b23_1;
  const T rho23_2 = N23_2 + T(0.2) * S24_1 + E24_22 * rho24_2 - E24_23 * rho24_3;
  const T rho23_3 = N23_3 + E24_23 * rho24_2 + E24_22 * rho24_3 - T(1.2) * S24_1;
  // r_theta23 = b23 . rho23 - tau_body_23_: Kane's equation of the angle [N m]
  const T r_theta23 = rho23_3 - u.tau_23;
  r[22] = r_theta23;

  // ---- body 22 (body_22) and what it carries
  // S22 = E23^T S23 + G22: sum of the force balances of the subtree, body axes [N]
  const T b22_1 = E23_11 * S23_1 - E23_12 * S23_2;
  const T S22_1 = b22_1 + G22_1;
  const T b22_2 = E23_12 * S23_1 + E23_11 * S23_2;
  const T S22_2 = b22_2 + G22_2;
  const T S22_3 = S23_3 + G22_3;
  // rho22 = q23~ E23^T S23 + E23^T rho23 + N22: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho22_1 = N22_1 + T(2.25) * S23_3 + E23_11 * rho23_1 - E23_12 * rho23_2;
  const T rho22_2 = N22_2 + E23_12 * rho23_1 + E23_11 * rho23_2 - T(0.3) * S23_3;
  const T rho22_3 = rho23_3 + N22_3 + T(0.3) * b22_2 - T(2.25) * b22_1;
  // r_theta22 = b22 . rho22 - tau_body_22_: Kane's equation of the angle [N m]
  const T r_theta22 = rho22_2 - u.tau_22;
  r[21] = r_theta22;

  // ---- body 21 (body_21) and what it carries
  // S21 = E22^T S22 + G21: sum of the force balances of the subtree, body axes [N]
  const T b21_1 = E22_11 * S22_1 + minus_E22_13 * S22_3;
  const T S21_1 = b21_1 + G21_1;
  const T S21_2 = S22_2 + G21_2;
  const T b21_2 = E22_11 * S22_3 - minus_E22_13 * S22_1;
  const T S21_3 = b21_2 + G21_3;
  // rho21 = q22~ E22^T S22 + E22^T rho22 + N21: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho21_1 = N21_1 + E22_11 * rho22_1 + minus_E22_13 * rho22_3 - T(0.1) * S22_2;
  const T rho21_2 = rho22_2 + N21_2 + T(0.1) * b21_1 - T(0.6) * b21_2;
  const T rho21_3 = N21_3 + T(0.6) * S22_2 + E22_11 * rho22_3 - minus_E22_13 * rho22_1;
  // r_theta21 = b21 . rho21 - tau_body_21_: Kane's equation of the angle [N m]
  const T r_theta21 = rho21_1 - u.tau_21;
  r[20] = r_theta21;

  // ---- body 20 (body_20) and what it carries
  // S20 = E21^T S21 + G20: sum of the force balances of the subtree, body axes [N]
  const T S20_1 = S21_1 + G20_1;
  const T b20_1 = E21_22 * S21_2 - E21_23 * S21_3;
  const T S20_2 = b20_1 + G20_2;
  const T b20_2 = E21_23 * S21_2 + E21_22 * S21_3;
  const T S20_3 = b20_2 + G20_3;
  // rho20 = q21~ E21^T S21 + E21^T rho21 + N20: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho20_1 = rho21_1 + N20_1 + T(1.05) * b20_2 - T(0.2) * b20_1;
  const T rho20_2 = N20_2 + T(0.2) * S21_1 + E21_22 * rho21_2 - E21_23 * rho21_3;
  const T rho20_3 = N20_3 + E21_23 * rho21_2 + E21_22 * rho21_3 - T(1.05) * S21_1;
  // r_theta20 = b20 . rho20 - tau_body_20_: Kane's equation of the angle [N m]
  const T r_theta20 = rho20_3 - u.tau_20;
  r[19] = r_theta20;

  // ---- body 19 (body_19) and what it carries
  // S19 = E20^T S20 + G19: sum of the force balances of the subtree, body axes [N]
  const T b19_1 = E20_11 * S20_1 - E20_12 * S20_2;
  const T S19_1 = b19_1 + G19_1;
  const T b19_2 = E20_12 * S20_1 + E20_11 * S20_2;
  const T S19_2 = b19_2 + G19_2;
  const T S19_3 = S20_3 + G19_3;
  // rho19 = q20~ E20^T S20 + E20^T rho20 + N19: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho19_1 = N19_1 + T(1.95) * S20_3 + E20_11 * rho20_1 - E20_12 * rho20_2;
  const T rho19_2 = N19_2 + E20_12 * rho20_1 + E20_11 * rho20_2 - T(0.3) * S20_3;
  const T rho19_3 = rho20_3 + N19_3 + T(0.3) * b19_2 - T(1.95) * b19_1;
  // r_theta19 = b19 . rho19 - tau_body_19_: Kane's equation of the angle [N m]
  const T r_theta19 = rho19_2 - u.tau_19;
  r[18] = r_theta19;

  // ---- body 18 (body_18) and what it carries
  // S18 = E19^T S19 + G18: sum of the force balances of the subtree, body axes [N]
  const T b18_1 = E19_11 * S19_1 + minus_E19_13 * S19_3;
  const T S18_1 = b18_1 + G18_1;
  const T S18_2 = S19_2 + G18_2;
  const T b18_2 = E19_11 * S19_3 - minus_E19_13 * S19_1;
  const T S18_3 = b18_2 + G18_3;
  // rho18 = q19~ E19^T S19 + E19^T rho19 + N18: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho18_1 = N18_1 + E19_11 * rho19_1 + minus_E19_13 * rho19_3 - T(0.1) * S19_2;
  const T rho18_2 = rho19_2 + N18_2 + T(0.1) * b18_1 - T(0.6) * b18_2;
  const T rho18_3 = N18_3 + T(0.6) * S19_2 + E19_11 * rho19_3 - minus_E19_13 * rho19_1;
  // r_theta18 = b18 . rho18 - tau_body_18_: Kane's equation of the angle [N m]
  const T r_theta18 = rho18_1 - u.tau_18;
  r[17] = r_theta18;

  // ---- body 17 (body_17) and what it carries
  // S17 = E18^T S18 + G17: sum of the force balances of the subtree, body axes [N]
  const T S17_1 = S18_1 + G17_1;
  const T b17_1 = E18_22 * S18_2 - E18_23 * S18_3;
  const T S17_2 = b17_1 + G17_2;
  const T b17_2 = E18_23 * S18_2 + E18_22 * S18_3;
  const T S17_3 = b17_2 + G17_3;
  // rho17 = q18~ E18^T S18 + E18^T rho18 + N17: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho17_1 = rho18_1 + N17_1 + T(0.9) * b17_2 - T(0.2) * b17_1;
  const T rho17_2 = N17_2 + T(0.2) * S18_1 + E18_22 * rho18_2 - E18_23 * rho18_3;
  const T rho17_3 = N17_3 + E18_23 * rho18_2 + E18_22 * rho18_3 - T(0.9) * S18_1;
  // r_theta17 = b17 . rho17 - tau_body_17_: Kane's equation of the angle [N m]
  const T r_theta17 = rho17_3 - u.tau_17;
  r[16] = r_theta17;

  // ---- body 16 (body_16) and what it carries
  // S16 = E17^T S17 + G16: sum of the force balances of the subtree, body axes [N]
  const T b16_1 = E17_11 * S17_1 - E17_12 * S17_2;
  const T S16_1 = b16_1 + G16_1;
  const T b16_2 = E17_12 * S17_1 + E17_11 * S17_2;
  const T S16_2 = b16_2 + G16_2;
  const T S16_3 = S17_3 + G16_3;
  // rho16 = q17~ E17^T S17 + E17^T rho17 + N16: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho16_1 = N16_1 + T(1.65) * S17_3 + E17_11 * rho17_1 - E17_12 * rho17_2;
  const T rho16_2 = N16_2 + E17_12 * rho17_1 + E17_11 * rho17_2 - T(0.3) * S17_3;
  const T rho16_3 = rho17_3 + N16_3 + T(0.3) * b16_2 - T(1.65) * b16_1;
  // r_theta16 = b16 . rho16 - tau_body_16_: Kane's equation of the angle [N m]
  const T r_theta16 = rho16_2 - u.tau_16;
  r[15] = r_theta16;

  // ---- body 15 (body_15) and what it carries
  // S15 = E16^T S16 + G15: sum of the force balances of the subtree, body axes [N]
  const T b15_1 = E16_11 * S16_1 + minus_E16_13 * S16_3;
  const T S15_1 = b15_1 + G15_1;
  const T S15_2 = S16_2 + G15_2;
  const T b15_2 = E16_11 * S16_3 - minus_E16_13 * S16_1;
  const T S15_3 = b15_2 + G15_3;
  // rho15 = q16~ E16^T S16 + E16^T rho16 + N15: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho15_1 = N15_1 + E16_11 * rho16_1 + minus_E16_13 * rho16_3 - T(0.1) * S16_2;
  const T rho15_2 = rho16_2 + N15_2 + T(0.1) * b15_1 - T(0.6) * b15_2;
  const T rho15_3 = N15_3 + T(0.6) * S16_2 + E16_11 * rho16_3 - minus_E16_13 * rho16_1;
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

}  // namespace kanec::bench_cr32
