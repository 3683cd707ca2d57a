// SPDX-License-Identifier: BSD-3-Clause
// bench_cr7: equations of motion of 7 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 0d1c635bd23112cd of bench_cr7/scene.toml; the usual functions
// bodies and their joints:
//   1 body_1 on the inertial frame: revolute
//   2 body_2 on 1: revolute
//   3 body_3 on 2: revolute
//   4 body_4 on 3: revolute
//   5 body_5 on 4: revolute
//   6 body_6 on 5: revolute
//   7 body_7 on 6: revolute
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (theta_1, theta_2, theta_3, theta_4, theta_5, theta_6, theta_7)
//   y = (thetadot_1, thetadot_2, thetadot_3, thetadot_4, thetadot_5, thetadot_6, thetadot_7)
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
//   poses                   260 (126 add, 134 multiply, 14 sine or cosine)
//   energy                  679 (289 add, 390 multiply, 14 sine or cosine)
//   momentum                915 (421 add, 494 multiply, 14 sine or cosine)
//   power                   13 (6 add, 7 multiply)
//   accelerations           1495 (710 add, 779 multiply, 6 divide, 14 sine or cosine)
//   residual                700 (344 add, 356 multiply, 14 sine or cosine)
//   forcing                 665 (322 add, 343 multiply, 14 sine or cosine)
//   mass_matrix             439 (207 add, 232 multiply, 12 sine or cosine)
//   partial_velocities      1070 (472 add, 598 multiply, 14 sine or cosine)
//   partial_velocity_rates  2362 (1017 add, 1345 multiply, 14 sine or cosine)
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

namespace kanec::bench_cr7 {

inline constexpr int n_bodies = 7;
inline constexpr int nx = 7;
inline constexpr int ny = 7;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 7;
inline constexpr char model_hash[] = "0d1c635bd23112cd";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_1 = 0, theta_2 = 1, theta_3 = 2, theta_4 = 3, theta_5 = 4, theta_6 = 5, theta_7 = 6;
inline constexpr int thetadot_1 = 0, thetadot_2 = 1, thetadot_3 = 2, thetadot_4 = 3, thetadot_5 = 4, thetadot_6 = 5,
    thetadot_7 = 6;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 49;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3,
    3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6, 0, 1, 2,
    3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6};

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
  xdot[0] = thetadot1;
  xdot[1] = thetadot2;
  xdot[2] = thetadot3;
  xdot[3] = thetadot4;
  xdot[4] = thetadot5;
  xdot[5] = thetadot6;
  xdot[6] = thetadot7;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 126 add, 134 multiply, 14 sine or cosine
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

  // ---- body 1 (body_1) on the inertial frame
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  pose[0] = E1_11;
  pose[8] = E1_11;
  pose[20] = E1_11;
  pose[2] = -minus_E1_13;
  pose[6] = minus_E1_13;
  pose[18] = minus_E1_13;
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T t1_1 = E1_11 * T(0.1);
  const T t1_2 = minus_E1_13 * T(0.05);
  const T p1_1 = t1_1 + t1_2;
  const T t1_3 = E1_11 * T(0.05);
  const T t1_4 = minus_E1_13 * T(0.1);
  const T p1_3 = t1_3 - t1_4;
  pose[9] = p1_1;
  pose[11] = p1_3;

  // ---- body 2 (body_2) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T E2_12 = sines[1];
  pose[16] = E2_11;
  pose[13] = E2_12;
  pose[25] = E2_12;
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T minus_R2_13 = minus_E1_13 * E2_11;
  const T minus_R2_21 = E1_11 * E2_12;
  const T R2_23 = minus_E1_13 * E2_12;
  pose[12] = R2_11;
  pose[24] = R2_11;
  pose[14] = -minus_R2_13;
  pose[26] = -minus_R2_13;
  pose[15] = -minus_R2_21;
  pose[17] = R2_23;
  // P2 = E1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = t1_4 + E1_11 * T(0.3);
  const T P2_3 = t1_1 - minus_E1_13 * T(0.3);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_1 = R2_11 * T(0.1);
  const T p2_1 = t2_1 + t1_2 + P2_1 - minus_R2_21 * T(0.2);
  const T t2_2 = E2_12 * T(0.1);
  const T p2_2 = t2_2 + T(0.1) + E2_11 * T(0.2);
  const T t2_3 = minus_R2_13 * T(0.1);
  const T p2_3 = t1_3 - t2_3 + P2_3 + R2_23 * T(0.2);
  pose[21] = p2_1;
  pose[22] = p2_2;
  pose[23] = p2_3;

  // ---- body 3 (body_3) on body 2
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
  pose[27] = R3_21;
  pose[39] = R3_21;
  pose[28] = R3_22;
  pose[40] = R3_22;
  pose[29] = R3_23;
  pose[41] = R3_23;
  pose[30] = R3_31;
  pose[31] = -minus_R3_32;
  pose[32] = R3_33;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T t3_1 = R2_11 * T(0.3);
  const T P3_1 = t3_1 + t1_4 + P2_1 - minus_R2_21 * T(0.15);
  const T t3_2 = E2_12 * T(0.3);
  const T P3_2 = t3_2 + T(0.1) + E2_11 * T(0.15);
  const T t3_3 = minus_R2_13 * T(0.3);
  const T P3_3 = t1_1 - t3_3 + P2_3 + R2_23 * T(0.15);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T t3_4 = R3_21 * T(0.2);
  const T t3_5 = t3_4 + P3_1;
  const T p3_1 = t2_1 + t3_5 + R3_31 * T(0.05);
  const T t3_6 = R3_22 * T(0.2);
  const T t3_7 = t3_6 + P3_2;
  const T p3_2 = t2_2 + t3_7 - minus_R3_32 * T(0.05);
  const T t3_8 = R3_23 * T(0.2);
  const T t3_9 = t3_8 + P3_3;
  const T p3_3 = t3_9 - t2_3 + R3_33 * T(0.05);
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (body_4) on body 3
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
  pose[36] = R4_11;
  pose[37] = R4_12;
  pose[38] = -minus_R4_13;
  pose[42] = R4_31;
  pose[54] = R4_31;
  pose[43] = R4_32;
  pose[55] = R4_32;
  pose[44] = R4_33;
  pose[56] = R4_33;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = t3_1 + t3_5 + R3_31 * T(0.1);
  const T P4_2 = t3_2 + t3_7 - minus_R3_32 * T(0.1);
  const T P4_3 = t3_9 - t3_3 + R3_33 * T(0.1);
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T t4_1 = R4_31 * T(0.05);
  const T p4_1 = t3_4 + t4_1 + P4_1 + R4_11 * T(0.1);
  const T t4_2 = R4_32 * T(0.05);
  const T p4_2 = t3_6 + t4_2 + P4_2 + R4_12 * T(0.1);
  const T t4_3 = R4_33 * T(0.05);
  const T p4_3 = t3_8 + t4_3 + P4_3 - minus_R4_13 * T(0.1);
  pose[45] = p4_1;
  pose[46] = p4_2;
  pose[47] = p4_3;

  // ---- body 5 (body_5) on body 4
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
  pose[48] = R5_11;
  pose[60] = R5_11;
  pose[49] = R5_12;
  pose[61] = R5_12;
  pose[50] = R5_13;
  pose[62] = R5_13;
  pose[51] = R5_21;
  pose[52] = R5_22;
  pose[53] = R5_23;
  // P5 = R4^T q5 + P4: position of the body origin, inertial axes [m]
  const T t5_1 = R4_31 * T(0.1);
  const T P5_1 = t5_1 + P4_1 + R4_11 * T(0.3) + R3_21 * T(0.25);
  const T t5_2 = R4_32 * T(0.1);
  const T P5_2 = t5_2 + P4_2 + R4_12 * T(0.3) + R3_22 * T(0.25);
  const T t5_3 = R4_33 * T(0.1);
  const T P5_3 = t5_3 + P4_3 + R3_23 * T(0.25) - minus_R4_13 * T(0.3);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T t5_4 = R5_11 * T(0.1);
  const T p5_1 = t5_4 + t4_1 + P5_1 + R5_21 * T(0.2);
  const T t5_5 = R5_12 * T(0.1);
  const T p5_2 = t5_5 + t4_2 + P5_2 + R5_22 * T(0.2);
  const T t5_6 = R5_13 * T(0.1);
  const T p5_3 = t5_6 + t4_3 + P5_3 + R5_23 * T(0.2);
  pose[57] = p5_1;
  pose[58] = p5_2;
  pose[59] = p5_3;

  // ---- body 6 (body_6) on body 5
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
  pose[63] = R6_21;
  pose[75] = R6_21;
  pose[64] = R6_22;
  pose[76] = R6_22;
  pose[65] = R6_23;
  pose[77] = R6_23;
  pose[66] = R6_31;
  pose[67] = R6_32;
  pose[68] = R6_33;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T t6_1 = R5_11 * T(0.3);
  const T P6_1 = t6_1 + t5_1 + P5_1 + R5_21 * T(0.3);
  const T t6_2 = R5_12 * T(0.3);
  const T P6_2 = t6_2 + t5_2 + P5_2 + R5_22 * T(0.3);
  const T t6_3 = R5_13 * T(0.3);
  const T P6_3 = t6_3 + t5_3 + P5_3 + R5_23 * T(0.3);
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T t6_4 = R6_21 * T(0.2);
  const T p6_1 = t5_4 + t6_4 + P6_1 + R6_31 * T(0.05);
  const T t6_5 = R6_22 * T(0.2);
  const T p6_2 = t5_5 + t6_5 + P6_2 + R6_32 * T(0.05);
  const T t6_6 = R6_23 * T(0.2);
  const T p6_3 = t5_6 + t6_6 + P6_3 + R6_33 * T(0.05);
  pose[69] = p6_1;
  pose[70] = p6_2;
  pose[71] = p6_3;

  // ---- body 7 (body_7) on body 6
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
  pose[72] = R7_11;
  pose[73] = R7_12;
  pose[74] = R7_13;
  pose[78] = R7_31;
  pose[79] = R7_32;
  pose[80] = R7_33;
  // P7 = R6^T q7 + P6: position of the body origin, inertial axes [m]
  const T P7_1 = t6_1 + P6_1 + R6_21 * T(0.35) + R6_31 * T(0.1);
  const T P7_2 = t6_2 + P6_2 + R6_22 * T(0.35) + R6_32 * T(0.1);
  const T P7_3 = t6_3 + P6_3 + R6_23 * T(0.35) + R6_33 * T(0.1);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_1 = t6_4 + P7_1 + R7_11 * T(0.1) + R7_31 * T(0.05);
  const T p7_2 = t6_5 + P7_2 + R7_12 * T(0.1) + R7_32 * T(0.05);
  const T p7_3 = t6_6 + P7_3 + R7_13 * T(0.1) + R7_33 * T(0.05);
  pose[81] = p7_1;
  pose[82] = p7_2;
  pose[83] = p7_3;

  // ---- results
  pose[1] = T(0);
  pose[3] = T(0);
  pose[5] = T(0);
  pose[7] = T(0);
  pose[19] = T(0);
  pose[4] = T(1);
  pose[10] = T(0.2);
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 289 add, 390 multiply, 14 sine or cosine
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

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
  const T p7_3 = t6_2 + P7_3 + R7_13 * T(0.1) + R7_33 * T(0.05);
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_1 = t6_9 - omega6_3 * T(0.35);
  const T t7_2 = omega6_3 * T(0.3) - omega6_1 * T(0.1);
  const T t7_3 = omega6_1 * T(0.35) - omega6_2 * T(0.3);
  const T Pdot7_1 = Pdot6_1 + R5_11 * t7_1 + R6_21 * t7_2 + R6_31 * t7_3;
  const T Pdot7_2 = Pdot6_2 + R5_12 * t7_1 + R6_22 * t7_2 + R6_32 * t7_3;
  const T Pdot7_3 = Pdot6_3 + R5_13 * t7_1 + R6_23 * t7_2 + R6_33 * t7_3;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_4 = omega7_2 * T(0.05) - omega7_3 * T(0.2);
  const T t7_5 = omega7_3 * T(0.1) - omega7_1 * T(0.05);
  const T t7_6 = omega7_1 * T(0.2) - omega7_2 * T(0.1);
  const T v7_1 = Pdot7_1 + R7_11 * t7_4 + R6_21 * t7_5 + R7_31 * t7_6;
  const T v7_2 = Pdot7_2 + R7_12 * t7_4 + R6_22 * t7_5 + R7_32 * t7_6;
  const T v7_3 = Pdot7_3 + R7_13 * t7_4 + R6_23 * t7_5 + R7_33 * t7_6;
  // T7 = 1/2 omega7 . (I7 omega7) + 1/2 m7 v7 . v7: kinetic energy [J]
  const T T7 = T(0.5) * (omega7_1 * (T(0.17) * omega7_1 + T(0.0085) * omega7_2 + T(0.0051) * omega7_3) + omega7_2 *
      (T(0.0085) * omega7_1 + T(0.204) * omega7_2 - T(0.0068) * omega7_3) + omega7_3 * (T(0.0051) * omega7_1 -
      T(0.0068) * omega7_2 + T(0.136) * omega7_3)) + T(0.85) * (v7_1 * v7_1 + v7_2 * v7_2 + v7_3 * v7_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6 + m7 p7: first moment of mass, inertial axes [kg m]
  const T mp_3 = T(1.1) * p1_3 + T(1.2) * p2_3 + T(1.3) * p3_3 + T(1.4) * p4_3 + T(1.5) * p5_3 + T(1.6) * p6_3 +
      T(1.7) * p7_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 421 add, 494 multiply, 14 sine or cosine
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

  // ---- body 1 (body_1) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T t1_1 = E1_11 * T(0.1);
  const T t1_2 = minus_E1_13 * T(0.05);
  const T p1_1 = t1_1 + t1_2;
  const T t1_3 = E1_11 * T(0.05);
  const T t1_4 = minus_E1_13 * T(0.1);
  const T p1_3 = t1_3 - t1_4;
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_5 = thetadot1 * T(0.05);
  const T t1_6 = thetadot1 * T(0.1);
  const T t1_7 = minus_E1_13 * t1_6;
  const T v1_1 = E1_11 * t1_5 - t1_7;
  const T t1_8 = E1_11 * t1_6;
  const T minus_v1_3 = t1_8 + minus_E1_13 * t1_5;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(1.1) * v1_1;
  const T minus_l1_3 = T(1.1) * minus_v1_3;
  // H1 = E1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_9 = T(0.0055) * thetadot1;
  const T t1_10 = T(0.0044) * thetadot1;
  const T H1_1 = E1_11 * t1_9 - minus_E1_13 * t1_10 - T(0.2) * minus_l1_3;
  const T H1_2 = T(0.132) * thetadot1 + p1_3 * l1_1 + p1_1 * minus_l1_3;
  const T minus_H1_3 = minus_E1_13 * t1_9 + E1_11 * t1_10 + T(0.2) * l1_1;

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
  const T P2_1 = t1_4 + E1_11 * T(0.3);
  const T P2_3 = t1_1 - minus_E1_13 * T(0.3);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_1 = R2_11 * T(0.1);
  const T p2_1 = t2_1 + t1_2 + P2_1 - minus_R2_21 * T(0.2);
  const T t2_2 = E2_12 * T(0.1);
  const T p2_2 = t2_2 + T(0.1) + E2_11 * T(0.2);
  const T t2_3 = minus_R2_13 * T(0.1);
  const T p2_3 = t1_3 - t2_3 + P2_3 + R2_23 * T(0.2);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_4 = thetadot1 * T(0.3);
  const T Pdot2_1 = t1_8 - minus_E1_13 * t2_4;
  const T minus_Pdot2_3 = t1_7 + E1_11 * t2_4;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_5 = omega2_2 * T(0.05) - thetadot2 * T(0.2);
  const T t2_6 = thetadot2 * T(0.1) - omega2_1 * T(0.05);
  const T t2_7 = omega2_2 * T(0.1);
  const T t2_8 = omega2_1 * T(0.2) - t2_7;
  const T v2_1 = Pdot2_1 + R2_11 * t2_5 - minus_R2_21 * t2_6 + minus_E1_13 * t2_8;
  const T v2_2 = E2_12 * t2_5 + E2_11 * t2_6;
  const T v2_3 = R2_23 * t2_6 - minus_Pdot2_3 - minus_R2_13 * t2_5 + E1_11 * t2_8;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(1.2) * v2_1;
  const T l2_2 = T(1.2) * v2_2;
  const T l2_3 = T(1.2) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_9 = T(0.12) * omega2_1 + T(0.006) * omega2_2 + T(0.0036) * thetadot2;
  const T t2_10 = T(0.006) * omega2_1 + T(0.144) * omega2_2 - T(0.0048) * thetadot2;
  const T t2_11 = T(0.0036) * omega2_1 - T(0.0048) * omega2_2 + T(0.096) * thetadot2;
  const T H2_1 = R2_11 * t2_9 - minus_R2_21 * t2_10 + minus_E1_13 * t2_11 + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = E2_12 * t2_9 + E2_11 * t2_10 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = R2_23 * t2_10 - minus_R2_13 * t2_9 + E1_11 * t2_11 + p2_1 * l2_2 - p2_2 * l2_1;

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
  const T t3_1 = R2_11 * T(0.3);
  const T P3_1 = t3_1 + t1_4 + P2_1 - minus_R2_21 * T(0.15);
  const T t3_2 = E2_12 * T(0.3);
  const T P3_2 = t3_2 + T(0.1) + E2_11 * T(0.15);
  const T t3_3 = minus_R2_13 * T(0.3);
  const T P3_3 = t1_1 - t3_3 + P2_3 + R2_23 * T(0.15);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T t3_4 = R3_21 * T(0.2);
  const T t3_5 = t3_4 + P3_1;
  const T p3_1 = t2_1 + t3_5 + R3_31 * T(0.05);
  const T t3_6 = R3_22 * T(0.2);
  const T t3_7 = t3_6 + P3_2;
  const T p3_2 = t2_2 + t3_7 - minus_R3_32 * T(0.05);
  const T t3_8 = R3_23 * T(0.2);
  const T t3_9 = t3_8 + P3_3;
  const T p3_3 = t3_9 - t2_3 + R3_33 * T(0.05);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_10 = t2_7 - thetadot2 * T(0.15);
  const T t3_11 = thetadot2 * T(0.3) - omega2_1 * T(0.1);
  const T t3_12 = omega2_1 * T(0.15) - omega2_2 * T(0.3);
  const T Pdot3_1 = Pdot2_1 + R2_11 * t3_10 - minus_R2_21 * t3_11 + minus_E1_13 * t3_12;
  const T Pdot3_2 = E2_12 * t3_10 + E2_11 * t3_11;
  const T Pdot3_3 = R2_23 * t3_11 - minus_Pdot2_3 - minus_R2_13 * t3_10 + E1_11 * t3_12;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_13 = omega3_3 * T(0.2);
  const T t3_14 = omega3_2 * T(0.05) - t3_13;
  const T t3_15 = omega3_3 * T(0.1) - omega3_1 * T(0.05);
  const T t3_16 = omega3_1 * T(0.2);
  const T t3_17 = omega3_2 * T(0.1);
  const T t3_18 = t3_16 - t3_17;
  const T v3_1 = Pdot3_1 + R2_11 * t3_14 + R3_21 * t3_15 + R3_31 * t3_18;
  const T v3_2 = Pdot3_2 + E2_12 * t3_14 + R3_22 * t3_15 - minus_R3_32 * t3_18;
  const T v3_3 = Pdot3_3 + R3_23 * t3_15 - minus_R2_13 * t3_14 + R3_33 * t3_18;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(1.3) * v3_1;
  const T l3_2 = T(1.3) * v3_2;
  const T l3_3 = T(1.3) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_19 = T(0.13) * omega3_1 + T(0.0065) * omega3_2 + T(0.0039) * omega3_3;
  const T t3_20 = T(0.0065) * omega3_1 + T(0.156) * omega3_2 - T(0.0052) * omega3_3;
  const T t3_21 = T(0.0039) * omega3_1 - T(0.0052) * omega3_2 + T(0.104) * omega3_3;
  const T H3_1 = R2_11 * t3_19 + R3_21 * t3_20 + R3_31 * t3_21 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = E2_12 * t3_19 + R3_22 * t3_20 - minus_R3_32 * t3_21 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R3_23 * t3_20 - minus_R2_13 * t3_19 + R3_33 * t3_21 + p3_1 * l3_2 - p3_2 * l3_1;

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
  const T P4_1 = t3_1 + t3_5 + R3_31 * T(0.1);
  const T P4_2 = t3_2 + t3_7 - minus_R3_32 * T(0.1);
  const T P4_3 = t3_9 - t3_3 + R3_33 * T(0.1);
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T t4_1 = R4_31 * T(0.05);
  const T p4_1 = t3_4 + t4_1 + P4_1 + R4_11 * T(0.1);
  const T t4_2 = R4_32 * T(0.05);
  const T p4_2 = t3_6 + t4_2 + P4_2 + R4_12 * T(0.1);
  const T t4_3 = R4_33 * T(0.05);
  const T p4_3 = t3_8 + t4_3 + P4_3 - minus_R4_13 * T(0.1);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_4 = t3_17 - t3_13;
  const T t4_5 = omega3_3 * T(0.3) - omega3_1 * T(0.1);
  const T t4_6 = t3_16 - omega3_2 * T(0.3);
  const T Pdot4_1 = Pdot3_1 + R2_11 * t4_4 + R3_21 * t4_5 + R3_31 * t4_6;
  const T Pdot4_2 = Pdot3_2 + E2_12 * t4_4 + R3_22 * t4_5 - minus_R3_32 * t4_6;
  const T Pdot4_3 = Pdot3_3 + R3_23 * t4_5 - minus_R2_13 * t4_4 + R3_33 * t4_6;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_7 = omega4_2 * T(0.05) - omega4_3 * T(0.2);
  const T t4_8 = omega4_3 * T(0.1) - omega4_1 * T(0.05);
  const T t4_9 = omega4_2 * T(0.1);
  const T t4_10 = omega4_1 * T(0.2) - t4_9;
  const T v4_1 = Pdot4_1 + R4_11 * t4_7 + R3_21 * t4_8 + R4_31 * t4_10;
  const T v4_2 = Pdot4_2 + R4_12 * t4_7 + R3_22 * t4_8 + R4_32 * t4_10;
  const T v4_3 = Pdot4_3 + R3_23 * t4_8 - minus_R4_13 * t4_7 + R4_33 * t4_10;
  // l4 = m4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(1.4) * v4_1;
  const T l4_2 = T(1.4) * v4_2;
  const T l4_3 = T(1.4) * v4_3;
  // H4 = R4^T I4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_11 = T(0.14) * omega4_1 + T(0.007) * omega4_2 + T(0.0042) * omega4_3;
  const T t4_12 = T(0.007) * omega4_1 + T(0.168) * omega4_2 - T(0.0056) * omega4_3;
  const T t4_13 = T(0.0042) * omega4_1 - T(0.0056) * omega4_2 + T(0.112) * omega4_3;
  const T H4_1 = R4_11 * t4_11 + R3_21 * t4_12 + R4_31 * t4_13 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_11 + R3_22 * t4_12 + R4_32 * t4_13 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R3_23 * t4_12 - minus_R4_13 * t4_11 + R4_33 * t4_13 + p4_1 * l4_2 - p4_2 * l4_1;

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
  const T t5_1 = R4_31 * T(0.1);
  const T P5_1 = t5_1 + P4_1 + R4_11 * T(0.3) + R3_21 * T(0.25);
  const T t5_2 = R4_32 * T(0.1);
  const T P5_2 = t5_2 + P4_2 + R4_12 * T(0.3) + R3_22 * T(0.25);
  const T t5_3 = R4_33 * T(0.1);
  const T P5_3 = t5_3 + P4_3 + R3_23 * T(0.25) - minus_R4_13 * T(0.3);
  // p5 = R5^T r5 + P5: position of the mass centre, inertial axes [m]
  const T t5_4 = R5_11 * T(0.1);
  const T p5_1 = t5_4 + t4_1 + P5_1 + R5_21 * T(0.2);
  const T t5_5 = R5_12 * T(0.1);
  const T p5_2 = t5_5 + t4_2 + P5_2 + R5_22 * T(0.2);
  const T t5_6 = R5_13 * T(0.1);
  const T p5_3 = t5_6 + t4_3 + P5_3 + R5_23 * T(0.2);
  // Pdot5 = R4^T omega4~ q5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t5_7 = t4_9 - omega4_3 * T(0.25);
  const T t5_8 = omega4_3 * T(0.3) - omega4_1 * T(0.1);
  const T t5_9 = omega4_1 * T(0.25) - omega4_2 * T(0.3);
  const T Pdot5_1 = Pdot4_1 + R4_11 * t5_7 + R3_21 * t5_8 + R4_31 * t5_9;
  const T Pdot5_2 = Pdot4_2 + R4_12 * t5_7 + R3_22 * t5_8 + R4_32 * t5_9;
  const T Pdot5_3 = Pdot4_3 + R3_23 * t5_8 - minus_R4_13 * t5_7 + R4_33 * t5_9;
  // v5 = R5^T omega5~ r5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_10 = omega5_2 * T(0.05) - omega5_3 * T(0.2);
  const T t5_11 = omega5_3 * T(0.1) - omega5_1 * T(0.05);
  const T t5_12 = omega5_2 * T(0.1);
  const T t5_13 = omega5_1 * T(0.2) - t5_12;
  const T v5_1 = Pdot5_1 + R5_11 * t5_10 + R5_21 * t5_11 + R4_31 * t5_13;
  const T v5_2 = Pdot5_2 + R5_12 * t5_10 + R5_22 * t5_11 + R4_32 * t5_13;
  const T v5_3 = Pdot5_3 + R5_13 * t5_10 + R5_23 * t5_11 + R4_33 * t5_13;
  // l5 = m5 v5: linear momentum, inertial axes [kg m/s]
  const T l5_1 = T(1.5) * v5_1;
  const T l5_2 = T(1.5) * v5_2;
  const T l5_3 = T(1.5) * v5_3;
  // H5 = R5^T I5 omega5 + p5~ l5: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t5_14 = T(0.15) * omega5_1 + T(0.0075) * omega5_2 + T(0.0045) * omega5_3;
  const T t5_15 = T(0.0075) * omega5_1 + T(0.18) * omega5_2 - T(0.006) * omega5_3;
  const T t5_16 = T(0.0045) * omega5_1 - T(0.006) * omega5_2 + T(0.12) * omega5_3;
  const T H5_1 = R5_11 * t5_14 + R5_21 * t5_15 + R4_31 * t5_16 + p5_2 * l5_3 - p5_3 * l5_2;
  const T H5_2 = R5_12 * t5_14 + R5_22 * t5_15 + R4_32 * t5_16 + p5_3 * l5_1 - p5_1 * l5_3;
  const T H5_3 = R5_13 * t5_14 + R5_23 * t5_15 + R4_33 * t5_16 + p5_1 * l5_2 - p5_2 * l5_1;

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
  const T t6_1 = R5_11 * T(0.3);
  const T P6_1 = t6_1 + t5_1 + P5_1 + R5_21 * T(0.3);
  const T t6_2 = R5_12 * T(0.3);
  const T P6_2 = t6_2 + t5_2 + P5_2 + R5_22 * T(0.3);
  const T t6_3 = R5_13 * T(0.3);
  const T P6_3 = t6_3 + t5_3 + P5_3 + R5_23 * T(0.3);
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T t6_4 = R6_21 * T(0.2);
  const T p6_1 = t5_4 + t6_4 + P6_1 + R6_31 * T(0.05);
  const T t6_5 = R6_22 * T(0.2);
  const T p6_2 = t5_5 + t6_5 + P6_2 + R6_32 * T(0.05);
  const T t6_6 = R6_23 * T(0.2);
  const T p6_3 = t5_6 + t6_6 + P6_3 + R6_33 * T(0.05);
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_7 = omega5_3 * T(0.3);
  const T t6_8 = t5_12 - t6_7;
  const T t6_9 = t6_7 - omega5_1 * T(0.1);
  const T t6_10 = omega5_1 * T(0.3) - omega5_2 * T(0.3);
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_8 + R5_21 * t6_9 + R4_31 * t6_10;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_8 + R5_22 * t6_9 + R4_32 * t6_10;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_8 + R5_23 * t6_9 + R4_33 * t6_10;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_11 = omega6_2 * T(0.05) - omega6_3 * T(0.2);
  const T t6_12 = omega6_3 * T(0.1) - omega6_1 * T(0.05);
  const T t6_13 = omega6_2 * T(0.1);
  const T t6_14 = omega6_1 * T(0.2) - t6_13;
  const T v6_1 = Pdot6_1 + R5_11 * t6_11 + R6_21 * t6_12 + R6_31 * t6_14;
  const T v6_2 = Pdot6_2 + R5_12 * t6_11 + R6_22 * t6_12 + R6_32 * t6_14;
  const T v6_3 = Pdot6_3 + R5_13 * t6_11 + R6_23 * t6_12 + R6_33 * t6_14;
  // l6 = m6 v6: linear momentum, inertial axes [kg m/s]
  const T l6_1 = T(1.6) * v6_1;
  const T l6_2 = T(1.6) * v6_2;
  const T l6_3 = T(1.6) * v6_3;
  // H6 = R6^T I6 omega6 + p6~ l6: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t6_15 = T(0.16) * omega6_1 + T(0.008) * omega6_2 + T(0.0048) * omega6_3;
  const T t6_16 = T(0.008) * omega6_1 + T(0.192) * omega6_2 - T(0.0064) * omega6_3;
  const T t6_17 = T(0.0048) * omega6_1 - T(0.0064) * omega6_2 + T(0.128) * omega6_3;
  const T H6_1 = R5_11 * t6_15 + R6_21 * t6_16 + R6_31 * t6_17 + p6_2 * l6_3 - p6_3 * l6_2;
  const T H6_2 = R5_12 * t6_15 + R6_22 * t6_16 + R6_32 * t6_17 + p6_3 * l6_1 - p6_1 * l6_3;
  const T H6_3 = R5_13 * t6_15 + R6_23 * t6_16 + R6_33 * t6_17 + p6_1 * l6_2 - p6_2 * l6_1;

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
  const T P7_1 = t6_1 + P6_1 + R6_21 * T(0.35) + R6_31 * T(0.1);
  const T P7_2 = t6_2 + P6_2 + R6_22 * T(0.35) + R6_32 * T(0.1);
  const T P7_3 = t6_3 + P6_3 + R6_23 * T(0.35) + R6_33 * T(0.1);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_1 = t6_4 + P7_1 + R7_11 * T(0.1) + R7_31 * T(0.05);
  const T p7_2 = t6_5 + P7_2 + R7_12 * T(0.1) + R7_32 * T(0.05);
  const T p7_3 = t6_6 + P7_3 + R7_13 * T(0.1) + R7_33 * T(0.05);
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_1 = t6_13 - omega6_3 * T(0.35);
  const T t7_2 = omega6_3 * T(0.3) - omega6_1 * T(0.1);
  const T t7_3 = omega6_1 * T(0.35) - omega6_2 * T(0.3);
  const T Pdot7_1 = Pdot6_1 + R5_11 * t7_1 + R6_21 * t7_2 + R6_31 * t7_3;
  const T Pdot7_2 = Pdot6_2 + R5_12 * t7_1 + R6_22 * t7_2 + R6_32 * t7_3;
  const T Pdot7_3 = Pdot6_3 + R5_13 * t7_1 + R6_23 * t7_2 + R6_33 * t7_3;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_4 = omega7_2 * T(0.05) - omega7_3 * T(0.2);
  const T t7_5 = omega7_3 * T(0.1) - omega7_1 * T(0.05);
  const T t7_6 = omega7_1 * T(0.2) - omega7_2 * T(0.1);
  const T v7_1 = Pdot7_1 + R7_11 * t7_4 + R6_21 * t7_5 + R7_31 * t7_6;
  const T v7_2 = Pdot7_2 + R7_12 * t7_4 + R6_22 * t7_5 + R7_32 * t7_6;
  const T v7_3 = Pdot7_3 + R7_13 * t7_4 + R6_23 * t7_5 + R7_33 * t7_6;
  // l7 = m7 v7: linear momentum, inertial axes [kg m/s]
  const T l7_1 = T(1.7) * v7_1;
  const T l7_2 = T(1.7) * v7_2;
  const T l7_3 = T(1.7) * v7_3;
  // H7 = R7^T I7 omega7 + p7~ l7: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t7_7 = T(0.17) * omega7_1 + T(0.0085) * omega7_2 + T(0.0051) * omega7_3;
  const T t7_8 = T(0.0085) * omega7_1 + T(0.204) * omega7_2 - T(0.0068) * omega7_3;
  const T t7_9 = T(0.0051) * omega7_1 - T(0.0068) * omega7_2 + T(0.136) * omega7_3;
  const T H7_1 = R7_11 * t7_7 + R6_21 * t7_8 + R7_31 * t7_9 + p7_2 * l7_3 - p7_3 * l7_2;
  const T H7_2 = R7_12 * t7_7 + R6_22 * t7_8 + R7_32 * t7_9 + p7_3 * l7_1 - p7_1 * l7_3;
  const T H7_3 = R7_13 * t7_7 + R6_23 * t7_8 + R7_33 * t7_9 + p7_1 * l7_2 - p7_2 * l7_1;

  // ---- whole system
  // linear = l1 + l2 + l3 + l4 + l5 + l6 + l7: linear momentum of the system [kg m/s]
  const T linear_1 = l1_1 + l2_1 + l3_1 + l4_1 + l5_1 + l6_1 + l7_1;
  const T linear_2 = l2_2 + l3_2 + l4_2 + l5_2 + l6_2 + l7_2;
  const T linear_3 = l2_3 - minus_l1_3 + l3_3 + l4_3 + l5_3 + l6_3 + l7_3;
  momentum[0] = linear_1;
  momentum[1] = linear_2;
  momentum[2] = linear_3;
  // angular = H1 + H2 + H3 + H4 + H5 + H6 + H7: angular momentum of the system about the inertial origin [kg m^2/s]
  const T angular_1 = H1_1 + H2_1 + H3_1 + H4_1 + H5_1 + H6_1 + H7_1;
  const T angular_2 = H1_2 + H2_2 + H3_2 + H4_2 + H5_2 + H6_2 + H7_2;
  const T angular_3 = H2_3 - minus_H1_3 + H3_3 + H4_3 + H5_3 + H6_3 + H7_3;
  momentum[3] = angular_1;
  momentum[4] = angular_2;
  momentum[5] = angular_3;
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 6 add, 7 multiply
template <class T>
void power([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, const Inputs<T>& u, T* out)
    noexcept {

  // ---- body 1 (body_1) on the inertial frame
  const T thetadot1 = y[0];
  const T thetadot2 = y[1];
  const T thetadot3 = y[2];
  const T thetadot4 = y[3];
  const T thetadot5 = y[4];
  const T thetadot6 = y[5];
  const T thetadot7 = y[6];
  // power = thetadot1 tau_body_1_ + thetadot2 tau_body_2_ + thetadot3 tau_body_3_ + thetadot4 tau_body_4_ + thetadot5
  //   tau_body_5_ + thetadot6 tau_body_6_ + thetadot7 tau_body_7_: power of the applied loads [W]
  const T power = thetadot1 * u.tau_1 + thetadot2 * u.tau_2 + thetadot3 * u.tau_3 + thetadot4 * u.tau_4 + thetadot5 *
      u.tau_5 + thetadot6 * u.tau_6 + thetadot7 * u.tau_7;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 710 add, 779 multiply, 6 divide, 14 sine or cosine
// by: articulated; composite would take 625 add, 699 multiply, 6 divide, 14 sine or cosine, and err by 11 ulps
//   instead of 4
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot)
    noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

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
  const T N1_2 = T(2.7199999999999998) * Pddot1_3 + T(1.735) * minus_Pddot1_1;

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
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_3 = U2_31 * T(4.359999999999999) + U2_32 * T(1.365);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(1.365) * Pddot1_3 + T(0.25275) * U2_32 + T(0.2658) * (minus_U2_22 - minus_U2_33) +
      T(0.6539999999999999) * U2_31 - T(0.8624) * U2_12;
  const T minus_N2_2 = T(0.8624) * (minus_U2_33 - minus_U2_11) - T(2.73325) * U2_31 + T(0.2658) * U2_12 -
      T(0.6539999999999999) * U2_32 - T(4.359999999999999) * Pddot1_3;
  const T minus_N2_3 = T(4.359999999999999) * Pddot2_2 + T(1.365) * minus_Pddot2_1 + T(2.4804999999999997) * U2_12 +
      T(0.6539999999999999) * (minus_U2_11 - minus_U2_22);

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
  const T minus_G3_1 = U3_12 * T(2.98) + U3_13 * T(0.685);
  const T minus_G3_2 = U3_23 * T(0.685) - minus_U3_22 * T(2.98);
  const T minus_G3_3 = U3_32 * T(2.98) - minus_U3_33 * T(0.685);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(2.98) * Pddot3_3 - T(0.685) * Pddot3_2 + T(1.845) * U3_32 - T(0.15625) * U3_23 + T(0.2902) *
      (minus_U3_22 - minus_U3_33) + T(1.7295) * U3_31 - T(0.3941) * U3_21;
  const T minus_N3_2 = T(0.685) * Pddot3_1 + T(0.15625) * U3_13 + T(0.15625) * U3_31 + T(0.3941) * (minus_U3_33 -
      minus_U3_11) + T(0.2902) * U3_12 - T(1.7295) * U3_32;
  const T minus_N3_3 = T(1.7295) * (minus_U3_11 - minus_U3_22) - (T(0.15625) * U3_21 + T(1.845) * U3_12) + T(0.3941) *
      U3_23 - T(0.2902) * U3_13 - T(2.98) * Pddot3_1;

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
  const T minus_G4_1 = U4_13 * T(0.9550000000000001) - minus_U4_11 * T(1.5799999999999998);
  const T minus_G4_2 = U4_21 * T(1.5799999999999998) + U4_23 * T(0.9550000000000001);
  const T minus_G4_3 = U4_31 * T(1.5799999999999998) - minus_U4_33 * T(0.9550000000000001);
  // N4 = -h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N4_1 = T(0.43185) * (minus_U4_22 - minus_U4_33) - (T(0.516) * U4_32 + T(0.77425) * U4_23) + T(0.697) *
      U4_31 - T(0.2683) * U4_21 - T(0.9550000000000001) * Pddot4_2;
  const T minus_N4_2 = T(0.9550000000000001) * Pddot4_1 - T(1.5799999999999998) * Pddot4_3 + T(0.77425) * U4_13 -
      T(0.516) * U4_31 + T(0.2683) * (minus_U4_33 - minus_U4_11) + T(0.43185) * U4_12 - T(0.697) * U4_32;
  const T minus_N4_3 = T(1.5799999999999998) * Pddot4_2 + T(0.516) * U4_21 + T(0.516) * U4_12 + T(0.697) *
      (minus_U4_11 - minus_U4_22) + T(0.2683) * U4_23 - T(0.43185) * U4_13;

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
  // G5 = -U5 h_own_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = U5_12 * T(1.29) - minus_U5_11 * T(1.81);
  const T minus_G5_2 = U5_21 * T(1.81) - minus_U5_22 * T(1.29);
  const T minus_G5_3 = U5_31 * T(1.81) + U5_32 * T(1.29);
  // N5 = -h_own_5~ Pddot5 - axial(U5 (tr(J_own_5)/2 - J_own_5)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N5_1 = T(1.29) * Pddot5_3 + T(0.40199999999999997) * U5_32 + T(0.40199999999999997) * U5_23 + T(0.249)
      * (minus_U5_22 - minus_U5_33) + T(0.5205) * U5_31 - T(0.35000000000000003) * U5_21;
  const T minus_N5_2 = T(0.35000000000000003) * (minus_U5_33 - minus_U5_11) - (T(0.40199999999999997) * U5_13 +
      T(1.171) * U5_31) + T(0.249) * U5_12 - T(0.5205) * U5_32 - T(1.81) * Pddot5_3;
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
  const T minus_G6_1 = U6_12 * T(1.2550000000000001) + U6_13 * T(0.25);
  const T minus_G6_2 = U6_23 * T(0.25) - minus_U6_22 * T(1.2550000000000001);
  const T minus_G6_3 = U6_32 * T(1.2550000000000001) - minus_U6_33 * T(0.25);
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(1.2550000000000001) * Pddot6_3 - T(0.25) * Pddot6_2 + T(0.7935300000000001) * U6_32 -
      T(0.133) * U6_23 + T(0.11590000000000002) * (minus_U6_22 - minus_U6_33) + T(0.681) * U6_31 - T(0.1292) * U6_21;
  const T minus_N6_2 = T(0.25) * Pddot6_1 + T(0.133) * U6_13 + T(0.133) * U6_31 + T(0.1292) * (minus_U6_33 -
      minus_U6_11) + T(0.11590000000000002) * U6_12 - T(0.681) * U6_32;
  const T minus_N6_3 = T(0.681) * (minus_U6_11 - minus_U6_22) - (T(0.133) * U6_21 + T(0.7935300000000001) * U6_12) +
      T(0.1292) * U6_23 - T(0.11590000000000002) * U6_13 - T(1.2550000000000001) * Pddot6_1;

  // ---- body 7 (body_7) on body 6
  const T thetadot7 = y[6];
  // E7^T = Z7^T Rot(b7, theta7): E takes components in the lower body to those in the body
  const T t7_1 = cosines[6];
  const T t7_2 = sines[6];
  const T E7_11 = T(0.44721359549995804) * t7_1 - T(0.8944271909999159) * t7_2;
  const T minus_E7_13 = T(0.8944271909999159) * t7_1 + T(0.44721359549995804) * t7_2;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // omegadot7 = -thetadot7 b7~ E7 omega6 + E7 omegadot6: angular acceleration, body axes [rad/s^2]
  const T omegadot7_1 = E7_11 * omegadot5_1 - minus_E7_13 * omegadot6_3 - thetadot7 * omega7_3;
  const T omegadot7_3 = thetadot7 * omega7_1 + minus_E7_13 * omegadot5_1 + E7_11 * omegadot6_3;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t7_3 = omega7_3 * omega7_3;
  const T t7_4 = omega7_2 * omega7_2;
  const T minus_U7_11 = t7_3 + t7_4;
  const T t7_5 = omega7_2 * omega7_1;
  const T U7_12 = t7_5 - omegadot7_3;
  const T t7_6 = omega7_3 * omega7_1;
  const T U7_13 = t7_6 + omegadot6_2;
  const T U7_21 = t7_5 + omegadot7_3;
  const T t7_7 = omega7_1 * omega7_1;
  const T minus_U7_22 = t7_3 + t7_7;
  const T t7_8 = omega7_3 * omega7_2;
  const T U7_23 = t7_8 - omegadot7_1;
  const T U7_31 = t7_6 - omegadot6_2;
  const T U7_32 = t7_8 + omegadot7_1;
  const T minus_U7_33 = t7_4 + t7_7;
  // Pddot7 = E7 (U6 q7 + Pddot6): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot7_1 = E7_11 * (Pddot6_1 + U6_13 * T(0.1) - minus_U6_11 * T(0.6)) - minus_E7_13 * (Pddot6_3 + U6_31 *
      T(0.6) - minus_U6_33 * T(0.1));
  const T Pddot7_2 = Pddot6_2 + U6_21 * T(0.6) + U6_23 * T(0.1);
  // G7 = -U7 h_own_7: applied less inertia force, body axes [N]
  const T minus_G7_1 = U7_13 * T(0.19006577808748215);
  const T minus_G7_2 = U7_23 * T(0.19006577808748215);
  const T G7_3 = minus_U7_33 * T(0.19006577808748215);
  // N7 = -h_own_7~ Pddot7 - axial(U7 (tr(J_own_7)/2 - J_own_7)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N7_1 = T(0.09997459927401561) * (minus_U7_22 - minus_U7_33) - (T(0.11628) * U7_32 + T(0.10897) *
      U7_23) - T(0.009883420460549072) * U7_31 + T(0.010540000000000004) * U7_21 - T(0.19006577808748215) * Pddot7_2;
  const T minus_N7_2 = T(0.19006577808748215) * Pddot7_1 + T(0.10897) * U7_13 - T(0.11628) * U7_31 -
      T(0.010540000000000004) * (minus_U7_33 - minus_U7_11) + T(0.09997459927401561) * U7_12 + T(0.009883420460549072)
      * U7_32;
  const T minus_N7_3 = T(0.11628) * U7_21 + T(0.11628) * U7_12 - T(0.009883420460549072) * (minus_U7_11 - minus_U7_22)
      - T(0.010540000000000004) * U7_23 - T(0.09997459927401561) * U7_13;

  // ---- body 7 (body_7) and what it carries
  // u_7 = b7 . N7 + tau_body_7_: drives it [N m], [N]
  const T u_7 = u.tau_7 - minus_N7_2;
  // v7 = invD7 u_7: u/D
  const T v7 = T(4.439511653718091) * u_7;
  // gt7 = G7 - v7 B7: force with the turn solved [N]
  const T minus_gt7_1 = v7 * T(0.19006577808748215) + minus_G7_1;
  // nt7 = -tau_body_7_ b7 + P_b7 (N7 - v7 K7): moment with the turn solved [N m]
  const T minus_nt7_1 = minus_N7_1 + v7 * T(0.009883420460549072);
  const T nt7_3 = v7 * T(0.09997459927401561) - minus_N7_3;
  // Mp7 = E7^T M7 E7: M passed on, lower body's axes [kg]
  const T b7_1 = minus_E7_13 * T(0.16037735849056606);
  const T b7_2 = minus_E7_13 * b7_1;
  const T Mp7_11 = b7_2 - T(0.16037735849056606);
  const T Mp7_13 = E7_11 * b7_1;
  // gp7 = E7^T gt7: force passed on, lower body's axes [N]
  const T gp7_1 = minus_E7_13 * G7_3 - E7_11 * minus_gt7_1;
  const T gp7_3 = minus_E7_13 * minus_gt7_1 + E7_11 * G7_3;
  // Hp7 = E7^T H7 E7: H passed on, lower body's axes [kg m]
  const T b7_3 = minus_E7_13 * T(0.008339622641509436) + E7_11 * T(0.08435849056603775);
  const T b7_4 = minus_E7_13 * b7_3;
  const T Hp7_11 = b7_4 - T(0.008339622641509436);
  const T minus_Hp7_12 = E7_11 * T(0.19006577808748215);
  const T b7_5 = E7_11 * b7_3;
  const T Hp7_13 = b7_5 - T(0.08435849056603775);
  const T Hp7_32 = minus_E7_13 * T(0.19006577808748215);
  // Jp7 = E7^T J7 E7: J passed on, lower body's axes [kg m^2]
  const T b7_6 = T(2) * E7_11 * T(0.014926641509433968) - minus_E7_13 * T(0.036628905660377374);
  const T b7_7 = minus_E7_13 * b7_6;
  const T Jp7_11 = b7_7 - T(0.007743660377358488);
  const T Jp7_13 = E7_11 * b7_6 - T(0.014926641509433968);
  const T minus_Jp7_33 = T(0.044372566037735865) + b7_7;
  // np7 = E7^T nt7: moment passed on, lower body's axes [N m]
  const T np7_1 = minus_E7_13 * nt7_3 - E7_11 * minus_nt7_1;
  const T np7_3 = minus_E7_13 * minus_nt7_1 + E7_11 * nt7_3;
  // Hb7 = q7~ Mp7 + Hp7: H of the joint at the lower body's origin, its axes
  const T Hb7_21 = T(0.1) * Mp7_11 - T(0.6) * Mp7_13;
  const T Hb7_23 = T(0.1) * Mp7_13 + T(0.6) * b7_2;

  // ---- body 6 (body_6) and what it carries
  // HA6 = h_own_6~ + Hb7: moment for an acceleration of the origin, body axes [kg m]
  const T minus_HA6_12 = minus_Hp7_12 + T(0.25);
  const T HA6_13 = T(1.2550000000000001) + Hp7_13;
  const T HA6_21 = T(0.25) + Hb7_21;
  const T HA6_31 = b7_5 - T(1.2550000000000001);
  // JA6 = q7~ Hp7^T + J_own_6 + Jp7 - Hb7 q7~: moment for an angular acceleration, body axes [kg m^2]
  const T JA6_11 = T(0.9265300000000001) + Jp7_11 + T(0.2) * minus_Hp7_12;
  const T JA6_12 = T(0.1) * Hp7_11 - T(0.681) - T(0.6) * Hp7_13;
  const T JA6_13 = Jp7_13 - T(0.1292) - T(0.1) * Hp7_32 - T(0.6) * minus_Hp7_12;
  const T minus_JA6_22 = Hb7_23 * T(0.6) - Hb7_21 * T(0.1);
  const T JA6_23 = T(0.1) * b7_5 - T(0.11590000000000002) + T(0.6) * b7_4;
  const T JA6_33 = T(0.6605300000000001) - minus_Jp7_33 + T(1.2) * Hp7_32;
  // g6 = G6 + gp7: force that drives it, home axes [N]
  const T g6_1 = gp7_1 - minus_G6_1;
  const T minus_g6_2 = minus_G7_2 + minus_G6_2;
  const T g6_3 = gp7_3 - minus_G6_3;
  // n6 = q7~ gp7 + N6 + np7: moment that drives it, body axes [N m]
  const T n6_1 = np7_1 - minus_N6_1 + T(0.1) * minus_G7_2;
  const T n6_2 = T(0.1) * gp7_1 - (minus_N6_2 + u.tau_7) - T(0.6) * gp7_3;
  const T n6_3 = np7_3 - minus_N6_3 - T(0.6) * minus_G7_2;
  // invD6 = D6^-1: 1/D
  const T invD6 = T(1) / JA6_11;
  // kB6 = invD6 B6: B/D
  const T kB6_1 = invD6 * Hp7_11;
  const T minus_kB6_2 = invD6 * minus_HA6_12;
  const T kB6_3 = invD6 * HA6_13;
  // kK6 = invD6 K6: K/D
  const T kK6_2 = invD6 * JA6_12;
  const T kK6_3 = invD6 * JA6_13;
  // u_6 = b6 . n6 + tau_body_6_: drives it [N m], [N]
  const T u_6 = n6_1 + u.tau_6;
  // v6 = invD6 u_6: u/D
  const T v6 = invD6 * u_6;
  // M6 = Mp7 - kB6 B6^T: MA less what the turn takes up [kg]
  const T M6_11 = Mp7_11 - kB6_1 * Hp7_11;
  const T M6_12 = kB6_1 * minus_HA6_12;
  const T M6_13 = Mp7_13 - kB6_1 * HA6_13;
  const T minus_M6_22 = minus_kB6_2 * minus_HA6_12;
  const T M6_23 = minus_kB6_2 * HA6_13;
  const T minus_M6_33 = b7_2 + kB6_3 * HA6_13;
  // H6 = P_b6 (HA6 - kK6 B6^T): HA less what the turn takes up [kg m]
  const T H6_21 = HA6_21 - kK6_2 * Hp7_11;
  const T H6_22 = kK6_2 * minus_HA6_12;
  const T H6_23 = Hb7_23 - kK6_2 * HA6_13;
  const T H6_31 = HA6_31 - kK6_3 * Hp7_11;
  const T H6_32 = Hp7_32 + kK6_3 * minus_HA6_12;
  const T minus_H6_33 = b7_4 + kK6_3 * HA6_13;
  // J6 = P_b6 (JA6 - kK6 K6^T) P_b6: JA less what the turn takes up [kg m^2]
  const T minus_J6_22 = minus_JA6_22 + kK6_2 * JA6_12;
  const T J6_23 = JA6_23 - kK6_2 * JA6_13;
  const T J6_33 = JA6_33 - kK6_3 * JA6_13;
  // gt6 = g6 - v6 B6: force with the turn solved [N]
  const T gt6_1 = g6_1 - v6 * Hp7_11;
  const T gt6_2 = v6 * minus_HA6_12 - minus_g6_2;
  const T gt6_3 = g6_3 - v6 * HA6_13;
  // nt6 = -tau_body_6_ b6 + P_b6 (n6 - v6 K6): moment with the turn solved [N m]
  const T nt6_2 = n6_2 - v6 * JA6_12;
  const T nt6_3 = n6_3 - v6 * JA6_13;
  // Mp6 = E6^T M6 E6: M passed on, lower body's axes [kg]
  const T minus_Mp6_12 = E6_23 * M6_13 - E6_22 * M6_12;
  const T Mp6_13 = E6_22 * M6_13 + E6_23 * M6_12;
  const T b6_1 = T(2) * E6_22;
  const T b6_2 = E6_23 * (minus_M6_33 - minus_M6_22) + b6_1 * M6_23;
  const T b6_3 = E6_23 * b6_2;
  const T minus_Mp6_22 = minus_M6_22 + b6_3;
  const T Mp6_23 = E6_22 * b6_2 - M6_23;
  const T Mp6_33 = b6_3 - minus_M6_33;
  // gp6 = E6^T gt6: force passed on, lower body's axes [N]
  const T gp6_2 = E6_22 * gt6_2 - E6_23 * gt6_3;
  const T gp6_3 = E6_23 * gt6_2 + E6_22 * gt6_3;
  // Hp6 = E6^T H6 E6: H passed on, lower body's axes [kg m]
  const T Hp6_21 = E6_22 * H6_21 - E6_23 * H6_31;
  const T b6_4 = E6_23 * (minus_H6_33 + H6_22) + E6_22 * (H6_23 + H6_32);
  const T b6_5 = E6_23 * b6_4;
  const T minus_Hp6_22 = b6_5 - H6_22;
  const T b6_6 = E6_22 * b6_4;
  const T Hp6_23 = b6_6 - H6_32;
  const T Hp6_31 = E6_23 * H6_21 + E6_22 * H6_31;
  const T Hp6_32 = b6_6 - H6_23;
  const T Hp6_33 = b6_5 - minus_H6_33;
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
  const T b6_9 = T(0.2) * minus_Mp6_12;
  const T b6_10 = T(0.3) * Mp6_13;
  const T Hb6_11 = b6_9 + b6_10;
  const T Hb6_12 = T(0.2) * minus_Mp6_22 + T(0.3) * Mp6_23;
  const T Hb6_13 = T(0.3) * Mp6_33 - T(0.2) * Mp6_23;
  const T Hb6_21 = Hp6_21 + T(0.2) * M6_11;
  const T minus_Hb6_22 = minus_Hp6_22 + b6_9;
  const T Hb6_23 = Hp6_23 + T(0.2) * Mp6_13;
  const T Hb6_31 = Hp6_31 - T(0.3) * M6_11;
  const T Hb6_32 = Hp6_32 + T(0.3) * minus_Mp6_12;
  const T Hb6_33 = Hp6_33 - b6_10;

  // ---- body 5 (body_5) and what it carries
  // HA5 = h_own_5~ + Hb6: moment for an acceleration of the origin, body axes [kg m]
  const T HA5_13 = T(1.29) + Hb6_13;
  const T HA5_23 = Hb6_23 - T(1.81);
  const T HA5_31 = Hb6_31 - T(1.29);
  const T HA5_32 = T(1.81) + Hb6_32;
  // JA5 = q6~ Hp6^T + J_own_5 + Jp6 - Hb6 q6~: moment for an angular acceleration, body axes [kg m^2]
  const T minus_JA5_11 = Hb6_12 * T(0.2) - Hb6_13 * T(0.3);
  const T JA5_12 = T(0.2) * minus_Hp6_22 - T(0.5205) + T(0.3) * Hp6_23 + Hb6_11 * T(0.2);
  const T JA5_13 = T(0.3) * Hp6_33 - T(0.35000000000000003) - T(0.2) * Hp6_32 - Hb6_11 * T(0.3);
  const T JA5_22 = T(0.769) - minus_Jp6_22 + T(0.2) * Hp6_21 + Hb6_21 * T(0.2);
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
  // M5 = Mp6 - kB5 B5^T: MA less what the turn takes up [kg]
  const T M5_11 = M6_11 - kB5_1 * HA5_31;
  const T minus_M5_12 = minus_Mp6_12 + kB5_1 * HA5_32;
  const T M5_13 = Mp6_13 - kB5_1 * Hb6_33;
  const T minus_M5_22 = minus_Mp6_22 + kB5_2 * HA5_32;
  const T M5_23 = Mp6_23 - kB5_2 * Hb6_33;
  const T M5_33 = Mp6_33 - kB5_3 * Hb6_33;
  // H5 = P_b5 (HA5 - kK5 B5^T): HA less what the turn takes up [kg m]
  const T H5_11 = Hb6_11 - kK5_1 * HA5_31;
  const T H5_12 = Hb6_12 - kK5_1 * HA5_32;
  const T H5_13 = HA5_13 - kK5_1 * Hb6_33;
  const T H5_21 = Hb6_21 - kK5_2 * HA5_31;
  const T minus_H5_22 = minus_Hb6_22 + kK5_2 * HA5_32;
  const T H5_23 = HA5_23 - kK5_2 * Hb6_33;
  // J5 = P_b5 (JA5 - kK5 K5^T) P_b5: JA less what the turn takes up [kg m^2]
  const T minus_J5_11 = minus_JA5_11 + kK5_1 * JA5_13;
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
  const T b5_2 = E5_12 * (M5_11 + minus_M5_22) - b5_1 * minus_M5_12;
  const T b5_3 = E5_12 * b5_2;
  const T Mp5_11 = M5_11 - b5_3;
  const T Mp5_12 = minus_M5_12 + E5_11 * b5_2;
  const T Mp5_13 = E5_11 * M5_13 - E5_12 * M5_23;
  const T Mp5_22 = b5_3 - minus_M5_22;
  const T Mp5_23 = E5_12 * M5_13 + E5_11 * M5_23;
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
  const T HA4_12 = Hb5_12 - T(0.9550000000000001);
  const T HA4_21 = T(0.9550000000000001) + Hb5_21;
  const T HA4_23 = Hb5_23 - T(1.5799999999999998);
  const T HA4_32 = T(1.5799999999999998) + Hb5_32;
  // JA4 = q5~ Hp5^T + J_own_4 + Jp5 - Hb5 q5~: moment for an angular acceleration, body axes [kg m^2]
  const T JA4_11 = T(0.25825000000000004) - minus_Jp5_11 + T(0.45) * Hp5_13 + Hb5_13 * T(0.45);
  const T JA4_12 = Jp5_12 - T(0.697) + T(0.45) * Hp5_23 - Hb5_13 * T(0.3);
  const T minus_JA4_13 = T(0.2683) + Hb5_11 * T(0.45) - Hb5_12 * T(0.3);
  const T JA4_22 = T(1.29025) + Jp5_22 - T(0.3) * Hp5_23 - Hb5_23 * T(0.3);
  const T minus_JA4_23 = T(0.43185) + Hb5_21 * T(0.45) - Hb5_22 * T(0.3);
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
  const T HA3_12 = Hb4_12 - T(0.685);
  const T HA3_13 = T(2.98) + Hb4_13;
  const T HA3_21 = T(0.685) + Hb4_21;
  const T HA3_31 = Hb4_31 - T(2.98);
  // JA3 = q4~ Hp4^T + J_own_3 + Jp4 - Hb4 q4~: moment for an angular acceleration, body axes [kg m^2]
  const T JA3_11 = T(2.00125) + Jp4_11 - T(0.1) * Hp4_12 - Hb4_12 * T(0.1);
  const T minus_JA3_12 = T(1.7295) + Hb4_13 * T(0.6) - Hb4_11 * T(0.1);
  const T JA3_13 = Jp4_13 - T(0.3941) - T(0.1) * Hp4_32 + Hb4_12 * T(0.6);
  const T minus_JA3_22 = Hb4_23 * T(0.6) - Hb4_21 * T(0.1);
  const T JA3_23 = T(0.1) * Hp4_31 - T(0.2902) - T(0.6) * Hp4_33 + Hb4_22 * T(0.6);
  const T JA3_33 = T(1.68875) - minus_Jp4_33 + T(0.6) * Hp4_32 + Hb4_32 * T(0.6);
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
  // HA2 = h_own_2~ + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA2_13 = T(1.365) + Hb3_13;
  const T HA2_23 = Hb3_23 - T(4.359999999999999);
  // JA2 = q3~ Hp3^T + J_own_2 + Jp3 - Hb3 q3~: moment for an angular acceleration, body axes [kg m^2]
  const T minus_JA2_11 = Hb3_12 * T(0.2) - Hb3_13 * T(0.15);
  const T JA2_12 = T(0.15) * Hp3_23 - T(0.6539999999999999) - T(0.2) * Hp3_22 + Hb3_11 * T(0.2);
  const T JA2_13 = T(0.15) * Hp3_33 - T(0.8624) - T(0.2) * Hp3_32 - Hb3_11 * T(0.15);
  const T JA2_22 = T(2.4804999999999997) - minus_Jp3_22 + T(0.2) * Hp3_21 + Hb3_21 * T(0.2);
  const T JA2_23 = Jp3_23 - T(0.2658) + T(0.2) * Hp3_31 - Hb3_21 * T(0.15);
  const T JA2_33 = T(2.9859999999999998) + Jp3_33 - T(0.15) * Hp3_31 - Hb3_31 * T(0.15);
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
  // M2 = Mp3 - kB2 B2^T: MA less what the turn takes up [kg]
  const T M2_33 = Mp3_33 - kB2_3 * Hb3_33;
  // H2 = P_b2 (HA2 - kK2 B2^T): HA less what the turn takes up [kg m]
  const T H2_13 = HA2_13 - kK2_1 * Hb3_33;
  const T H2_23 = HA2_23 - kK2_2 * Hb3_33;
  // J2 = P_b2 (JA2 - kK2 K2^T) P_b2: JA less what the turn takes up [kg m^2]
  const T minus_J2_11 = minus_JA2_11 + kK2_1 * JA2_13;
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
  const T Jp2_22 = J2_22 + E2_12 * (T(2) * E2_11 * J2_12 - E2_12 * (minus_J2_11 + J2_22));
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T np2_2 = E2_12 * nt2_1 + E2_11 * nt2_2;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T Hb2_23 = Hp2_23 - T(0.3) * M2_33;

  // ---- body 1 (body_1) and what it carries
  // JA1 = q2~ Hp2^T + J_own_1 + Jp2 - Hb2 q2~: moment for an angular acceleration, body axes [kg m^2]
  const T JA1_22 = T(1.5925) + Jp2_22 - T(0.3) * Hp2_23 - Hb2_23 * T(0.3);
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
  const T phi6 = v6 + kB6_1 * minus_beta6_1 + minus_kB6_2 * beta6_2 - kB6_3 * beta6_3 - kK6_3 * alphaL6_3 - kK6_2 *
      alphaL6_2;
  // thetaddot6 = -b6 . alphaL6 + phi6
  const T thetaddot6 = phi6 - alphaL5_1;
  ydot[5] = thetaddot6;

  // ---- body 7 (body_7), solved
  // beta7 = -E7 q7~ alpha6 + E7 beta6: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta7_1 = T(0.1) * alphaL6_2 * E7_11 + T(0.6) * alphaL6_2 * minus_E7_13 - E7_11 * minus_beta6_1 -
      minus_E7_13 * beta6_3;
  // alphaL7 = E7 alpha6: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL7_1 = E7_11 * phi6 - minus_E7_13 * alphaL6_3;
  const T alphaL7_3 = minus_E7_13 * phi6 + E7_11 * alphaL6_3;
  // phi7 = -kB7 . beta7 + v7 - (P_b7 kK7) . alphaL7
  const T phi7 = v7 - T(0.8437992367923736) * beta7_1 - T(0.043877560313203424) * alphaL7_1 + T(0.44383839855278856) *
      alphaL7_3;
  // thetaddot7 = -b7 . alphaL7 + phi7
  const T thetaddot7 = phi7 - alphaL6_2;
  ydot[6] = thetaddot7;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 344 add, 356 multiply, 14 sine or cosine
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r)
    noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

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
  const T N1_2 = T(1.5925) * thetaddot1 - T(2.7199999999999998) * Pddot1_3 - T(1.735) * minus_Pddot1_1;

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
  const T G2_3 = U2_31 * T(4.359999999999999) + U2_32 * T(1.365);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(1.365) * Pddot2_3 + T(0.25275) * U2_32 + T(0.25275) * U2_23 + T(0.2658) * (minus_U2_22 -
      minus_U2_33) + T(0.6539999999999999) * U2_31 - T(0.8624) * U2_21;
  const T N2_2 = T(0.8624) * (minus_U2_33 - minus_U2_11) - (T(0.25275) * U2_13 + T(2.73325) * U2_31) + T(0.2658) *
      U2_12 - T(0.6539999999999999) * U2_32 - T(4.359999999999999) * Pddot2_3;
  const T N2_3 = T(4.359999999999999) * Pddot2_2 + T(1.365) * minus_Pddot2_1 + T(2.73325) * U2_21 - T(0.25275) * U2_12
      + T(0.6539999999999999) * (minus_U2_11 - minus_U2_22) + T(0.8624) * U2_23 - T(0.2658) * U2_13;

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
  const T G3_1 = U3_12 * T(2.98) + U3_13 * T(0.685);
  const T G3_2 = U3_23 * T(0.685) - minus_U3_22 * T(2.98);
  const T G3_3 = U3_32 * T(2.98) - minus_U3_33 * T(0.685);
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(2.98) * Pddot3_3 - T(0.685) * Pddot3_2 + T(1.845) * U3_32 - T(0.15625) * U3_23 + T(0.2902) *
      (minus_U3_22 - minus_U3_33) + T(1.7295) * U3_31 - T(0.3941) * U3_21;
  const T N3_2 = T(0.685) * Pddot3_1 + T(0.15625) * U3_13 + T(0.15625) * U3_31 + T(0.3941) * (minus_U3_33 -
      minus_U3_11) + T(0.2902) * U3_12 - T(1.7295) * U3_32;
  const T N3_3 = T(1.7295) * (minus_U3_11 - minus_U3_22) - (T(0.15625) * U3_21 + T(1.845) * U3_12) + T(0.3941) * U3_23
      - T(0.2902) * U3_13 - T(2.98) * Pddot3_1;

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
  const T G4_1 = U4_13 * T(0.9550000000000001) - minus_U4_11 * T(1.5799999999999998);
  const T G4_2 = U4_21 * T(1.5799999999999998) + U4_23 * T(0.9550000000000001);
  const T G4_3 = U4_31 * T(1.5799999999999998) - minus_U4_33 * T(0.9550000000000001);
  // N4 = h_own_4~ Pddot4 + axial(U4 (tr(J_own_4)/2 - J_own_4)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N4_1 = T(0.43185) * (minus_U4_22 - minus_U4_33) - (T(0.516) * U4_32 + T(0.77425) * U4_23) + T(0.697) * U4_31
      - T(0.2683) * U4_21 - T(0.9550000000000001) * Pddot4_2;
  const T N4_2 = T(0.9550000000000001) * Pddot4_1 - T(1.5799999999999998) * Pddot4_3 + T(0.77425) * U4_13 - T(0.516) *
      U4_31 + T(0.2683) * (minus_U4_33 - minus_U4_11) + T(0.43185) * U4_12 - T(0.697) * U4_32;
  const T N4_3 = T(1.5799999999999998) * Pddot4_2 + T(0.516) * U4_21 + T(0.516) * U4_12 + T(0.697) * (minus_U4_11 -
      minus_U4_22) + T(0.2683) * U4_23 - T(0.43185) * U4_13;

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
  const T G5_1 = U5_12 * T(1.29) - minus_U5_11 * T(1.81);
  const T G5_2 = U5_21 * T(1.81) - minus_U5_22 * T(1.29);
  const T G5_3 = U5_31 * T(1.81) + U5_32 * T(1.29);
  // N5 = h_own_5~ Pddot5 + axial(U5 (tr(J_own_5)/2 - J_own_5)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N5_1 = T(1.29) * Pddot5_3 + T(0.40199999999999997) * U5_32 + T(0.40199999999999997) * U5_23 + T(0.249) *
      (minus_U5_22 - minus_U5_33) + T(0.5205) * U5_31 - T(0.35000000000000003) * U5_21;
  const T N5_2 = T(0.35000000000000003) * (minus_U5_33 - minus_U5_11) - (T(0.40199999999999997) * U5_13 + T(1.171) *
      U5_31) + T(0.249) * U5_12 - T(0.5205) * U5_32 - T(1.81) * Pddot5_3;
  const T N5_3 = T(1.81) * Pddot5_2 - T(1.29) * Pddot5_1 + T(1.171) * U5_21 - T(0.40199999999999997) * U5_12 +
      T(0.5205) * (minus_U5_11 - minus_U5_22) + T(0.35000000000000003) * U5_23 - T(0.249) * U5_13;

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
  const T G6_1 = U6_12 * T(1.2550000000000001) + U6_13 * T(0.25);
  const T G6_2 = U6_23 * T(0.25) - minus_U6_22 * T(1.2550000000000001);
  const T G6_3 = U6_32 * T(1.2550000000000001) - minus_U6_33 * T(0.25);
  // N6 = h_own_6~ Pddot6 + axial(U6 (tr(J_own_6)/2 - J_own_6)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N6_1 = T(1.2550000000000001) * Pddot6_3 - T(0.25) * Pddot6_2 + T(0.7935300000000001) * U6_32 - T(0.133) *
      U6_23 + T(0.11590000000000002) * (minus_U6_22 - minus_U6_33) + T(0.681) * U6_31 - T(0.1292) * U6_21;
  const T N6_2 = T(0.25) * Pddot6_1 + T(0.133) * U6_13 + T(0.133) * U6_31 + T(0.1292) * (minus_U6_33 - minus_U6_11) +
      T(0.11590000000000002) * U6_12 - T(0.681) * U6_32;
  const T N6_3 = T(0.681) * (minus_U6_11 - minus_U6_22) - (T(0.133) * U6_21 + T(0.7935300000000001) * U6_12) +
      T(0.1292) * U6_23 - T(0.11590000000000002) * U6_13 - T(1.2550000000000001) * Pddot6_1;

  // ---- body 7 (body_7) on body 6
  const T thetadot7 = y[6];
  const T thetaddot7 = ydot[6];
  // E7^T = Z7^T Rot(b7, theta7): E takes components in the lower body to those in the body
  const T t7_1 = cosines[6];
  const T t7_2 = sines[6];
  const T E7_11 = T(0.44721359549995804) * t7_1 - T(0.8944271909999159) * t7_2;
  const T minus_E7_13 = T(0.8944271909999159) * t7_1 + T(0.44721359549995804) * t7_2;
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
  const T t7_3 = omega7_3 * omega7_3;
  const T t7_4 = omega7_2 * omega7_2;
  const T minus_U7_11 = t7_3 + t7_4;
  const T t7_5 = omega7_2 * omega7_1;
  const T U7_12 = t7_5 - omegadot7_3;
  const T t7_6 = omega7_3 * omega7_1;
  const T U7_13 = t7_6 + omegadot7_2;
  const T U7_21 = t7_5 + omegadot7_3;
  const T t7_7 = omega7_1 * omega7_1;
  const T minus_U7_22 = t7_3 + t7_7;
  const T t7_8 = omega7_3 * omega7_2;
  const T U7_23 = t7_8 - omegadot7_1;
  const T U7_31 = t7_6 - omegadot7_2;
  const T U7_32 = t7_8 + omegadot7_1;
  const T minus_U7_33 = t7_4 + t7_7;
  // Pddot7 = E7 (U6 q7 + Pddot6): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot7_1 = E7_11 * (Pddot6_1 + U6_13 * T(0.1) - minus_U6_11 * T(0.6)) - minus_E7_13 * (Pddot6_3 + U6_31 *
      T(0.6) - minus_U6_33 * T(0.1));
  const T Pddot7_2 = Pddot6_2 + U6_21 * T(0.6) + U6_23 * T(0.1);
  // G7 = U7 h_own_7: inertia less applied force, body axes [N]
  const T G7_1 = U7_13 * T(0.19006577808748215);
  const T G7_2 = U7_23 * T(0.19006577808748215);
  const T minus_G7_3 = minus_U7_33 * T(0.19006577808748215);
  // N7 = h_own_7~ Pddot7 + axial(U7 (tr(J_own_7)/2 - J_own_7)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N7_1 = T(0.09997459927401561) * (minus_U7_22 - minus_U7_33) - (T(0.11628) * U7_32 + T(0.10897) * U7_23) -
      T(0.009883420460549072) * U7_31 + T(0.010540000000000004) * U7_21 - T(0.19006577808748215) * Pddot7_2;
  const T N7_2 = T(0.19006577808748215) * Pddot7_1 + T(0.10897) * U7_13 - T(0.11628) * U7_31 - T(0.010540000000000004)
      * (minus_U7_33 - minus_U7_11) + T(0.09997459927401561) * U7_12 + T(0.009883420460549072) * U7_32;
  const T N7_3 = T(0.11628) * U7_21 + T(0.11628) * U7_12 - T(0.009883420460549072) * (minus_U7_11 - minus_U7_22) -
      T(0.010540000000000004) * U7_23 - T(0.09997459927401561) * U7_13;

  // ---- body 7 (body_7) and what it carries
  // r_theta7 = b7 . N7 - tau_body_7_: Kane's equation of the angle [N m]
  const T r_theta7 = N7_2 - u.tau_7;
  r[6] = r_theta7;

  // ---- body 6 (body_6) and what it carries
  // S6 = E7^T G7 + G6: sum of the force balances of the subtree, body axes [N]
  const T b6_1 = E7_11 * G7_1 - minus_E7_13 * minus_G7_3;
  const T S6_1 = b6_1 + G6_1;
  const T S6_2 = G7_2 + G6_2;
  const T b6_2 = minus_E7_13 * G7_1 + E7_11 * minus_G7_3;
  const T S6_3 = G6_3 - b6_2;
  // rho6 = q7~ E7^T G7 + E7^T N7 + N6: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho6_1 = N6_1 + E7_11 * N7_1 + minus_E7_13 * N7_3 - T(0.1) * G7_2;
  const T rho6_2 = N7_2 + N6_2 + T(0.1) * b6_1 + T(0.6) * b6_2;
  const T rho6_3 = N6_3 + T(0.6) * G7_2 + E7_11 * N7_3 - minus_E7_13 * N7_1;
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

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 322 add, 343 multiply, 14 sine or cosine
template <class T>
void forcing([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* f) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

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
  const T N1_2 = T(2.7199999999999998) * Pddot1_3 + T(1.735) * minus_Pddot1_1;

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
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_3 = U2_31 * T(4.359999999999999) + U2_32 * T(1.365);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(1.365) * Pddot1_3 + T(0.25275) * U2_32 + T(0.2658) * (minus_U2_22 - minus_U2_33) +
      T(0.6539999999999999) * U2_31 - T(0.8624) * U2_12;
  const T minus_N2_2 = T(0.8624) * (minus_U2_33 - minus_U2_11) - T(2.73325) * U2_31 + T(0.2658) * U2_12 -
      T(0.6539999999999999) * U2_32 - T(4.359999999999999) * Pddot1_3;
  const T minus_N2_3 = T(4.359999999999999) * Pddot2_2 + T(1.365) * minus_Pddot2_1 + T(2.4804999999999997) * U2_12 +
      T(0.6539999999999999) * (minus_U2_11 - minus_U2_22);

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
  const T minus_G3_1 = U3_12 * T(2.98) + U3_13 * T(0.685);
  const T minus_G3_2 = U3_23 * T(0.685) - minus_U3_22 * T(2.98);
  const T minus_G3_3 = U3_32 * T(2.98) - minus_U3_33 * T(0.685);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(2.98) * Pddot3_3 - T(0.685) * Pddot3_2 + T(1.845) * U3_32 - T(0.15625) * U3_23 + T(0.2902) *
      (minus_U3_22 - minus_U3_33) + T(1.7295) * U3_31 - T(0.3941) * U3_21;
  const T minus_N3_2 = T(0.685) * Pddot3_1 + T(0.15625) * U3_13 + T(0.15625) * U3_31 + T(0.3941) * (minus_U3_33 -
      minus_U3_11) + T(0.2902) * U3_12 - T(1.7295) * U3_32;
  const T minus_N3_3 = T(1.7295) * (minus_U3_11 - minus_U3_22) - (T(0.15625) * U3_21 + T(1.845) * U3_12) + T(0.3941) *
      U3_23 - T(0.2902) * U3_13 - T(2.98) * Pddot3_1;

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
  const T minus_G4_1 = U4_13 * T(0.9550000000000001) - minus_U4_11 * T(1.5799999999999998);
  const T minus_G4_2 = U4_21 * T(1.5799999999999998) + U4_23 * T(0.9550000000000001);
  const T minus_G4_3 = U4_31 * T(1.5799999999999998) - minus_U4_33 * T(0.9550000000000001);
  // N4 = -h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N4_1 = T(0.43185) * (minus_U4_22 - minus_U4_33) - (T(0.516) * U4_32 + T(0.77425) * U4_23) + T(0.697) *
      U4_31 - T(0.2683) * U4_21 - T(0.9550000000000001) * Pddot4_2;
  const T minus_N4_2 = T(0.9550000000000001) * Pddot4_1 - T(1.5799999999999998) * Pddot4_3 + T(0.77425) * U4_13 -
      T(0.516) * U4_31 + T(0.2683) * (minus_U4_33 - minus_U4_11) + T(0.43185) * U4_12 - T(0.697) * U4_32;
  const T minus_N4_3 = T(1.5799999999999998) * Pddot4_2 + T(0.516) * U4_21 + T(0.516) * U4_12 + T(0.697) *
      (minus_U4_11 - minus_U4_22) + T(0.2683) * U4_23 - T(0.43185) * U4_13;

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
  // G5 = -U5 h_own_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = U5_12 * T(1.29) - minus_U5_11 * T(1.81);
  const T minus_G5_2 = U5_21 * T(1.81) - minus_U5_22 * T(1.29);
  const T minus_G5_3 = U5_31 * T(1.81) + U5_32 * T(1.29);
  // N5 = -h_own_5~ Pddot5 - axial(U5 (tr(J_own_5)/2 - J_own_5)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N5_1 = T(1.29) * Pddot5_3 + T(0.40199999999999997) * U5_32 + T(0.40199999999999997) * U5_23 + T(0.249)
      * (minus_U5_22 - minus_U5_33) + T(0.5205) * U5_31 - T(0.35000000000000003) * U5_21;
  const T minus_N5_2 = T(0.35000000000000003) * (minus_U5_33 - minus_U5_11) - (T(0.40199999999999997) * U5_13 +
      T(1.171) * U5_31) + T(0.249) * U5_12 - T(0.5205) * U5_32 - T(1.81) * Pddot5_3;
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
  const T minus_G6_1 = U6_12 * T(1.2550000000000001) + U6_13 * T(0.25);
  const T minus_G6_2 = U6_23 * T(0.25) - minus_U6_22 * T(1.2550000000000001);
  const T minus_G6_3 = U6_32 * T(1.2550000000000001) - minus_U6_33 * T(0.25);
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(1.2550000000000001) * Pddot6_3 - T(0.25) * Pddot6_2 + T(0.7935300000000001) * U6_32 -
      T(0.133) * U6_23 + T(0.11590000000000002) * (minus_U6_22 - minus_U6_33) + T(0.681) * U6_31 - T(0.1292) * U6_21;
  const T minus_N6_2 = T(0.25) * Pddot6_1 + T(0.133) * U6_13 + T(0.133) * U6_31 + T(0.1292) * (minus_U6_33 -
      minus_U6_11) + T(0.11590000000000002) * U6_12 - T(0.681) * U6_32;
  const T minus_N6_3 = T(0.681) * (minus_U6_11 - minus_U6_22) - (T(0.133) * U6_21 + T(0.7935300000000001) * U6_12) +
      T(0.1292) * U6_23 - T(0.11590000000000002) * U6_13 - T(1.2550000000000001) * Pddot6_1;

  // ---- body 7 (body_7) on body 6
  const T thetadot7 = y[6];
  // E7^T = Z7^T Rot(b7, theta7): E takes components in the lower body to those in the body
  const T t7_1 = cosines[6];
  const T t7_2 = sines[6];
  const T E7_11 = T(0.44721359549995804) * t7_1 - T(0.8944271909999159) * t7_2;
  const T minus_E7_13 = T(0.8944271909999159) * t7_1 + T(0.44721359549995804) * t7_2;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // omegadot7 = -thetadot7 b7~ E7 omega6 + E7 omegadot6: angular acceleration, body axes [rad/s^2]
  const T omegadot7_1 = E7_11 * omegadot5_1 - minus_E7_13 * omegadot6_3 - thetadot7 * omega7_3;
  const T omegadot7_3 = thetadot7 * omega7_1 + minus_E7_13 * omegadot5_1 + E7_11 * omegadot6_3;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t7_3 = omega7_3 * omega7_3;
  const T t7_4 = omega7_2 * omega7_2;
  const T minus_U7_11 = t7_3 + t7_4;
  const T t7_5 = omega7_2 * omega7_1;
  const T U7_12 = t7_5 - omegadot7_3;
  const T t7_6 = omega7_3 * omega7_1;
  const T U7_13 = t7_6 + omegadot6_2;
  const T U7_21 = t7_5 + omegadot7_3;
  const T t7_7 = omega7_1 * omega7_1;
  const T minus_U7_22 = t7_3 + t7_7;
  const T t7_8 = omega7_3 * omega7_2;
  const T U7_23 = t7_8 - omegadot7_1;
  const T U7_31 = t7_6 - omegadot6_2;
  const T U7_32 = t7_8 + omegadot7_1;
  const T minus_U7_33 = t7_4 + t7_7;
  // Pddot7 = E7 (U6 q7 + Pddot6): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot7_1 = E7_11 * (Pddot6_1 + U6_13 * T(0.1) - minus_U6_11 * T(0.6)) - minus_E7_13 * (Pddot6_3 + U6_31 *
      T(0.6) - minus_U6_33 * T(0.1));
  const T Pddot7_2 = Pddot6_2 + U6_21 * T(0.6) + U6_23 * T(0.1);
  // G7 = -U7 h_own_7: applied less inertia force, body axes [N]
  const T minus_G7_1 = U7_13 * T(0.19006577808748215);
  const T minus_G7_2 = U7_23 * T(0.19006577808748215);
  const T G7_3 = minus_U7_33 * T(0.19006577808748215);
  // N7 = -h_own_7~ Pddot7 - axial(U7 (tr(J_own_7)/2 - J_own_7)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N7_1 = T(0.09997459927401561) * (minus_U7_22 - minus_U7_33) - (T(0.11628) * U7_32 + T(0.10897) *
      U7_23) - T(0.009883420460549072) * U7_31 + T(0.010540000000000004) * U7_21 - T(0.19006577808748215) * Pddot7_2;
  const T minus_N7_2 = T(0.19006577808748215) * Pddot7_1 + T(0.10897) * U7_13 - T(0.11628) * U7_31 -
      T(0.010540000000000004) * (minus_U7_33 - minus_U7_11) + T(0.09997459927401561) * U7_12 + T(0.009883420460549072)
      * U7_32;
  const T minus_N7_3 = T(0.11628) * U7_21 + T(0.11628) * U7_12 - T(0.009883420460549072) * (minus_U7_11 - minus_U7_22)
      - T(0.010540000000000004) * U7_23 - T(0.09997459927401561) * U7_13;

  // ---- body 7 (body_7) and what it carries
  // f_theta7 = b7 . N7 + tau_body_7_: Kane's equation of the angle [N m]
  const T f_theta7 = u.tau_7 - minus_N7_2;
  f[6] = f_theta7;

  // ---- body 6 (body_6) and what it carries
  // S6 = E7^T G7 + G6: sum of the force balances of the subtree, body axes [N]
  const T b6_1 = E7_11 * minus_G7_1 - minus_E7_13 * G7_3;
  const T minus_S6_1 = b6_1 + minus_G6_1;
  const T minus_S6_2 = minus_G7_2 + minus_G6_2;
  const T b6_2 = minus_E7_13 * minus_G7_1 + E7_11 * G7_3;
  const T S6_3 = b6_2 - minus_G6_3;
  // rho6 = q7~ E7^T G7 + E7^T N7 + N6: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho6_1 = T(0.1) * minus_G7_2 - (minus_N6_1 + E7_11 * minus_N7_1 + minus_E7_13 * minus_N7_3);
  const T minus_rho6_2 = minus_N7_2 + minus_N6_2 + T(0.1) * b6_1 + T(0.6) * b6_2;
  const T rho6_3 = minus_E7_13 * minus_N7_1 - minus_N6_3 - E7_11 * minus_N7_3 - T(0.6) * minus_G7_2;
  // f_theta6 = b6 . rho6 + tau_body_6_: Kane's equation of the angle [N m]
  const T f_theta6 = rho6_1 + u.tau_6;
  f[5] = f_theta6;

  // ---- body 5 (body_5) and what it carries
  // S5 = E6^T S6 + G5: sum of the force balances of the subtree, body axes [N]
  const T minus_S5_1 = minus_S6_1 + minus_G5_1;
  const T b5_1 = E6_22 * minus_S6_2 + E6_23 * S6_3;
  const T minus_S5_2 = b5_1 + minus_G5_2;
  const T b5_2 = E6_22 * S6_3 - E6_23 * minus_S6_2;
  const T S5_3 = b5_2 - minus_G5_3;
  // rho5 = q6~ E6^T S6 + E6^T rho6 + N5: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho5_1 = rho6_1 - minus_N5_1 + T(0.2) * b5_1 + T(0.3) * b5_2;
  const T minus_rho5_2 = minus_N5_2 + T(0.2) * minus_S6_1 + E6_22 * minus_rho6_2 + E6_23 * rho6_3;
  const T rho5_3 = T(0.3) * minus_S6_1 - minus_N5_3 + E6_22 * rho6_3 - E6_23 * minus_rho6_2;
  // f_theta5 = b5 . rho5 + tau_body_5_: Kane's equation of the angle [N m]
  const T f_theta5 = rho5_3 + u.tau_5;
  f[4] = f_theta5;

  // ---- body 4 (body_4) and what it carries
  // S4 = E5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T b4_1 = E5_12 * minus_S5_2 - E5_11 * minus_S5_1;
  const T S4_1 = b4_1 - minus_G4_1;
  const T b4_2 = E5_12 * minus_S5_1 + E5_11 * minus_S5_2;
  const T minus_S4_2 = b4_2 + minus_G4_2;
  const T S4_3 = S5_3 - minus_G4_3;
  // rho4 = q5~ E5^T S5 + E5^T rho5 + N4: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho4_1 = T(0.45) * S5_3 - minus_N4_1 + E5_11 * rho5_1 + E5_12 * minus_rho5_2;
  const T rho4_2 = E5_12 * rho5_1 - minus_N4_2 - E5_11 * minus_rho5_2 - T(0.3) * S5_3;
  const T rho4_3 = rho5_3 - minus_N4_3 - T(0.3) * b4_2 - T(0.45) * b4_1;
  // f_theta4 = b4 . rho4 + tau_body_4_: Kane's equation of the angle [N m]
  const T f_theta4 = rho4_2 + u.tau_4;
  f[3] = f_theta4;

  // ---- body 3 (body_3) and what it carries
  // S3 = E4^T S4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = E4_11 * S4_1 + minus_E4_13 * S4_3;
  const T S3_1 = b3_1 - minus_G3_1;
  const T minus_S3_2 = minus_S4_2 + minus_G3_2;
  const T b3_2 = E4_11 * S4_3 - minus_E4_13 * S4_1;
  const T S3_3 = b3_2 - minus_G3_3;
  // rho3 = q4~ E4^T S4 + E4^T rho4 + N3: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho3_1 = T(0.1) * minus_S4_2 - minus_N3_1 + E4_11 * rho4_1 + minus_E4_13 * rho4_3;
  const T rho3_2 = rho4_2 - minus_N3_2 + T(0.1) * b3_1 - T(0.6) * b3_2;
  const T rho3_3 = E4_11 * rho4_3 - minus_N3_3 - minus_E4_13 * rho4_1 - T(0.6) * minus_S4_2;
  // f_theta3 = b3 . rho3 + tau_body_3_: Kane's equation of the angle [N m]
  const T f_theta3 = rho3_1 + u.tau_3;
  f[2] = f_theta3;

  // ---- body 2 (body_2) and what it carries
  // S2 = E3^T S3 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = E3_22 * S3_3 - E3_23 * minus_S3_2;
  const T S2_3 = b2_1 - minus_G2_3;
  // rho2 = q3~ E3^T S3 + E3^T rho3 + N2: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho2_1 = rho3_1 - minus_N2_1 + T(0.2) * (E3_22 * minus_S3_2 + E3_23 * S3_3) + T(0.15) * b2_1;
  const T rho2_2 = T(0.2) * S3_1 - minus_N2_2 + E3_22 * rho3_2 - E3_23 * rho3_3;
  const T rho2_3 = E3_23 * rho3_2 - minus_N2_3 + E3_22 * rho3_3 - T(0.15) * S3_1;
  // f_theta2 = b2 . rho2 + tau_body_2_: Kane's equation of the angle [N m]
  const T f_theta2 = rho2_3 + u.tau_2;
  f[1] = f_theta2;

  // ---- body 1 (body_1) and what it carries
  // rho1 = q2~ E2^T S2 + E2^T rho2 + N1: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho1_2 = N1_2 + E2_12 * rho2_1 + E2_11 * rho2_2 - T(0.3) * S2_3;
  // f_theta1 = b1 . rho1 + tau_body_1_: Kane's equation of the angle [N m]
  const T f_theta1 = rho1_2 + u.tau_1;
  f[0] = f_theta1;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 207 add, 232 multiply, 12 sine or cosine
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 6, cosines + 1, sines + 1);

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

  // ---- body 7 (body_7) and what it carries
  // hc7 = E7^T h_own_7: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc7_1 = minus_E7_13 * T(0.085) + E7_11 * T(0.17);
  const T hc7_3 = E7_11 * T(0.085) - minus_E7_13 * T(0.17);

  // ---- body 6 (body_6) and what it carries
  // h6 = h_own_6 + hc7: first moment of mass carried, about the body origin, body axes [kg m]
  const T h6_3 = T(0.25) + hc7_3;
  // J6 = -q7~ hc7~ + E7^T J_own_7 E7 + J_own_6 - hc7~ q7~: inertia carried, about the body origin, body axes [kg m^2]
  const T b6_1 = minus_E7_13 * T(0.02125) + T(2) * E7_11 * T(0.0034000000000000002);
  const T b6_2 = minus_E7_13 * b6_1;
  const T b6_3 = T(0.2) * hc7_3;
  const T J6_11 = T(0.9335) - b6_2 + b6_3;
  const T b6_4 = E7_11 * T(0.085) + minus_E7_13 * T(0.05355);
  const T minus_J6_12 = b6_4 + T(0.6809999999999999);
  const T minus_J6_13 = T(0.1258) + E7_11 * b6_1 + T(0.1) * hc7_1 + T(0.6) * hc7_3;
  const T b6_5 = T(0.1) * hc7_3 + T(0.6) * hc7_1;
  const T b6_6 = b6_5 + T(0.22524999999999998);
  const T J6_22 = b6_6 + b6_5;
  const T b6_7 = minus_E7_13 * T(0.085) - E7_11 * T(0.05355);
  const T J6_23 = b6_7 - T(0.1159);
  const T J6_33 = b6_2 + T(0.64625) + T(1.2) * hc7_1;
  A[40] = J6_11;
  // hc6 = E6^T h6: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc6_2 = E6_22 * T(1.255) - E6_23 * h6_3;
  const T hc6_3 = E6_22 * h6_3 + E6_23 * T(1.255);
  A[41] = -b6_4;
  A[47] = -b6_4;

  // ---- body 5 (body_5) and what it carries
  // h5 = h_own_5 + hc6: first moment of mass carried, about the body origin, body axes [kg m]
  const T h5_1 = T(1.81) + hc7_1;
  const T h5_2 = T(1.29) + hc6_2;
  // J5 = -q6~ hc6~ + E6^T J6 E6 + J_own_5 - hc6~ q6~: inertia carried, about the body origin, body axes [kg m^2]
  const T b5_1 = T(0.3) * hc6_2;
  const T b5_2 = b5_1 + T(0.2) * hc6_3;
  const T b5_3 = b5_2 + J6_11;
  const T J5_11 = b5_3 + b5_2;
  const T b5_4 = E6_22 * minus_J6_12 - E6_23 * minus_J6_13;
  const T minus_J5_12 = b5_4 + T(0.5205) + T(0.3) * hc7_1;
  const T b5_5 = E6_22 * minus_J6_13 + E6_23 * minus_J6_12;
  const T minus_J5_13 = b5_5 + T(0.35000000000000003) + T(0.2) * hc7_1;
  const T b5_6 = E6_23 * (J6_22 - J6_33) + T(2) * E6_22 * J6_23;
  const T b5_7 = E6_23 * b5_6;
  const T J5_22 = J6_22 - b5_7 + T(0.769) + T(0.4) * hc6_3;
  const T b5_8 = T(0.3) * hc6_3;
  const T J5_23 = E6_22 * b5_6 - (J6_23 + T(0.249) + b5_8) - T(0.2) * hc6_2;
  const T J5_33 = J6_33 + b5_7 + T(1.573) + T(0.6) * hc6_2;
  A[32] = J5_33;
  // hc5 = E5^T h5: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc5_1 = E5_11 * h5_1 - E5_12 * h5_2;
  const T hc5_2 = E5_11 * h5_2 + E5_12 * h5_1;
  // B_thetadot7_5 = E6^T B_thetadot7_6
  const T B_thetadot7_5_2 = E6_23 * hc7_1;
  const T minus_B_thetadot7_5_3 = E6_22 * hc7_1;
  // K_thetadot7_5 = q6~ E6^T B_thetadot7_6 + E6^T K_thetadot7_6
  const T b5_9 = T(0.3) * minus_B_thetadot7_5_3;
  const T minus_K_thetadot7_5_1 = b5_9 + b6_4 + T(0.2) * B_thetadot7_5_2;
  const T K_thetadot7_5_2 = b6_3 + E6_22 * b6_6 - E6_23 * b6_7;
  const T K_thetadot7_5_3 = E6_23 * b6_6 + E6_22 * b6_7 - T(0.3) * hc7_3;
  A[34] = K_thetadot7_5_3;
  A[46] = K_thetadot7_5_3;
  A[33] = -b5_5;
  A[39] = -b5_5;

  // ---- body 4 (body_4) and what it carries
  // h4 = h_own_4 + hc5: first moment of mass carried, about the body origin, body axes [kg m]
  const T h4_1 = T(1.5799999999999998) + hc5_1;
  const T h4_3 = T(0.9550000000000001) + hc6_3;
  // J4 = -q5~ hc5~ + E5^T J5 E5 + J_own_4 - hc5~ q5~: inertia carried, about the body origin, body axes [kg m^2]
  const T b4_1 = E5_12 * (J5_11 - J5_22) - T(2) * E5_11 * minus_J5_12;
  const T b4_2 = E5_12 * b4_1;
  const T J4_11 = J5_11 - b4_2 + T(0.25825000000000004) + T(0.9) * hc5_2;
  const T J4_12 = minus_J5_12 - T(0.697) + E5_11 * b4_1 - T(0.45) * hc5_1 - T(0.3) * hc5_2;
  const T b4_3 = E5_11 * minus_J5_13 + E5_12 * J5_23;
  const T minus_J4_13 = b4_3 + T(0.2683) + b5_8;
  const T b4_4 = T(0.6) * hc5_1;
  const T J4_22 = J5_22 + b4_2 + b4_4 + T(1.29025);
  const T b4_5 = E5_11 * J5_23 - E5_12 * minus_J5_13;
  const T J4_23 = b4_5 - T(0.43185) - T(0.45) * hc6_3;
  const T b4_6 = T(0.3) * hc5_1 + T(0.45) * hc5_2;
  const T b4_7 = b4_6 + J5_33;
  const T J4_33 = b4_7 + b4_6;
  A[24] = J4_22;
  // hc4 = E4^T h4: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4_1 = minus_E4_13 * h4_3 + E4_11 * h4_1;
  const T hc4_3 = E4_11 * h4_3 - minus_E4_13 * h4_1;
  // B_thetadot7_4 = E5^T B_thetadot7_5
  const T B_thetadot7_4_1 = E5_11 * hc7_3 - E5_12 * B_thetadot7_5_2;
  const T B_thetadot7_4_2 = E5_12 * hc7_3 + E5_11 * B_thetadot7_5_2;
  // K_thetadot7_4 = q5~ E5^T B_thetadot7_5 + E5^T K_thetadot7_5
  const T minus_K_thetadot7_4_1 = T(0.45) * minus_B_thetadot7_5_3 + E5_11 * minus_K_thetadot7_5_1 + E5_12 *
      K_thetadot7_5_2;
  const T K_thetadot7_4_2 = b5_9 + E5_11 * K_thetadot7_5_2 - E5_12 * minus_K_thetadot7_5_1;
  const T K_thetadot7_4_3 = K_thetadot7_5_3 + T(0.3) * B_thetadot7_4_2 - T(0.45) * B_thetadot7_4_1;
  A[27] = K_thetadot7_4_2;
  A[45] = K_thetadot7_4_2;
  // B_thetadot6_4 = E5^T B_thetadot6_5
  const T B_thetadot6_4_1 = E5_12 * hc6_3;
  const T minus_B_thetadot6_4_2 = E5_11 * hc6_3;
  // K_thetadot6_4 = q5~ E5^T B_thetadot6_5 + E5^T K_thetadot6_5
  const T K_thetadot6_4_1 = T(0.45) * hc6_2 + E5_11 * b5_3 + E5_12 * b5_4;
  const T K_thetadot6_4_2 = E5_12 * b5_3 - b5_1 - E5_11 * b5_4;
  const T minus_K_thetadot6_4_3 = b5_5 + T(0.3) * minus_B_thetadot6_4_2 + T(0.45) * B_thetadot6_4_1;
  A[26] = K_thetadot6_4_2;
  A[38] = K_thetadot6_4_2;
  A[25] = b4_5;
  A[31] = b4_5;

  // ---- body 3 (body_3) and what it carries
  // h3 = h_own_3 + hc4: first moment of mass carried, about the body origin, body axes [kg m]
  const T h3_2 = T(2.98) + hc5_2;
  const T h3_3 = T(0.685) + hc4_3;
  // J3 = -q4~ hc4~ + E4^T J4 E4 + J_own_3 - hc4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b3_1 = minus_E4_13 * (J4_33 - J4_11) - T(2) * E4_11 * minus_J4_13;
  const T b3_2 = minus_E4_13 * b3_1;
  const T b3_3 = T(0.2) * hc4_3;
  const T J3_11 = J4_11 + b3_2 + b3_3 + T(2.00125);
  const T b3_4 = E4_11 * J4_12 + minus_E4_13 * J4_23;
  const T J3_12 = b3_4 - T(1.7295) - T(0.6) * hc5_2;
  const T J3_13 = minus_J4_13 - T(0.3941) + E4_11 * b3_1 - T(0.1) * hc4_1 - T(0.6) * hc4_3;
  const T b3_5 = T(0.1) * hc4_3 + T(0.6) * hc4_1;
  const T b3_6 = b3_5 + J4_22;
  const T J3_22 = b3_6 + b3_5;
  const T b3_7 = E4_11 * J4_23 - minus_E4_13 * J4_12;
  const T J3_23 = b3_7 - T(0.2902) - T(0.1) * hc5_2;
  const T J3_33 = J4_33 - b3_2 + T(1.68875) + T(1.2) * hc4_1;
  A[16] = J3_11;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc3_2 = E3_22 * h3_2 - E3_23 * h3_3;
  const T hc3_3 = E3_22 * h3_3 + E3_23 * h3_2;
  // B_thetadot7_3 = E4^T B_thetadot7_4
  const T B_thetadot7_3_1 = E4_11 * B_thetadot7_4_1 - minus_E4_13 * minus_B_thetadot7_5_3;
  const T minus_B_thetadot7_3_3 = minus_E4_13 * B_thetadot7_4_1 + E4_11 * minus_B_thetadot7_5_3;
  // K_thetadot7_3 = q4~ E4^T B_thetadot7_4 + E4^T K_thetadot7_4
  const T K_thetadot7_3_1 = minus_E4_13 * K_thetadot7_4_3 - E4_11 * minus_K_thetadot7_4_1 - T(0.1) * B_thetadot7_4_2;
  const T K_thetadot7_3_2 = K_thetadot7_4_2 + T(0.1) * B_thetadot7_3_1 + T(0.6) * minus_B_thetadot7_3_3;
  const T K_thetadot7_3_3 = T(0.6) * B_thetadot7_4_2 + minus_E4_13 * minus_K_thetadot7_4_1 + E4_11 * K_thetadot7_4_3;
  A[20] = K_thetadot7_3_1;
  A[44] = K_thetadot7_3_1;
  // B_thetadot6_3 = E4^T B_thetadot6_4
  const T B_thetadot6_3_1 = E4_11 * B_thetadot6_4_1 + minus_E4_13 * hc6_2;
  const T B_thetadot6_3_3 = E4_11 * hc6_2 - minus_E4_13 * B_thetadot6_4_1;
  // K_thetadot6_3 = q4~ E4^T B_thetadot6_4 + E4^T K_thetadot6_4
  const T K_thetadot6_3_1 = T(0.1) * minus_B_thetadot6_4_2 + E4_11 * K_thetadot6_4_1 - minus_E4_13 *
      minus_K_thetadot6_4_3;
  const T K_thetadot6_3_2 = K_thetadot6_4_2 + T(0.1) * B_thetadot6_3_1 - T(0.6) * B_thetadot6_3_3;
  const T minus_K_thetadot6_3_3 = E4_11 * minus_K_thetadot6_4_3 + minus_E4_13 * K_thetadot6_4_1 + T(0.6) *
      minus_B_thetadot6_4_2;
  A[19] = K_thetadot6_3_1;
  A[37] = K_thetadot6_3_1;
  // B_thetadot5_3 = E4^T B_thetadot5_4
  const T minus_B_thetadot5_3_1 = E4_11 * hc5_2;
  const T B_thetadot5_3_3 = minus_E4_13 * hc5_2;
  // K_thetadot5_3 = q4~ E4^T B_thetadot5_4 + E4^T K_thetadot5_4
  const T K_thetadot5_3_1 = minus_E4_13 * b4_7 - E4_11 * b4_3 - T(0.1) * hc5_1;
  const T K_thetadot5_3_2 = b4_5 - T(0.1) * minus_B_thetadot5_3_1 - T(0.6) * B_thetadot5_3_3;
  const T K_thetadot5_3_3 = b4_4 + E4_11 * b4_7 + minus_E4_13 * b4_3;
  A[18] = K_thetadot5_3_1;
  A[30] = K_thetadot5_3_1;
  A[17] = b3_4;
  A[23] = b3_4;

  // ---- body 2 (body_2) and what it carries
  // h2 = h_own_2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h2_1 = T(4.359999999999999) + hc4_1;
  const T h2_2 = T(1.365) + hc3_2;
  // J2 = -q3~ hc3~ + E3^T J3 E3 + J_own_2 - hc3~ q3~: inertia carried, about the body origin, body axes [kg m^2]
  const T b2_1 = T(0.2) * hc3_3 + T(0.15) * hc3_2;
  const T b2_2 = b2_1 + J3_11;
  const T J2_11 = b2_2 + b2_1;
  const T b2_3 = E3_22 * J3_12 - E3_23 * J3_13;
  const T J2_12 = b2_3 - T(0.6539999999999999) - T(0.15) * hc4_1;
  const T b2_4 = E3_23 * J3_12 + E3_22 * J3_13;
  const T J2_13 = b2_4 - T(0.8624) - T(0.2) * hc4_1;
  const T b2_5 = E3_23 * (J3_22 - J3_33) + T(2) * E3_22 * J3_23;
  const T b2_6 = E3_23 * b2_5;
  const T J2_22 = J3_22 - b2_6 + T(2.4804999999999997) + T(0.4) * hc3_3;
  const T J2_23 = E3_22 * b2_5 - (J3_23 + T(0.2658)) - T(0.2) * hc3_2 - T(0.15) * hc3_3;
  const T b2_7 = T(0.3) * hc3_2;
  const T J2_33 = J3_33 + b2_6 + b2_7 + T(2.9859999999999998);
  A[8] = J2_33;
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc2_1 = E2_11 * h2_1 - E2_12 * h2_2;
  // B_thetadot7_2 = E3^T B_thetadot7_3
  const T B_thetadot7_2_2 = E3_22 * B_thetadot7_4_2 + E3_23 * minus_B_thetadot7_3_3;
  const T B_thetadot7_2_3 = E3_23 * B_thetadot7_4_2 - E3_22 * minus_B_thetadot7_3_3;
  // K_thetadot7_2 = q3~ E3^T B_thetadot7_3 + E3^T K_thetadot7_3
  const T K_thetadot7_2_1 = K_thetadot7_3_1 + T(0.15) * B_thetadot7_2_3 - T(0.2) * B_thetadot7_2_2;
  const T K_thetadot7_2_2 = T(0.2) * B_thetadot7_3_1 + E3_22 * K_thetadot7_3_2 - E3_23 * K_thetadot7_3_3;
  const T K_thetadot7_2_3 = E3_23 * K_thetadot7_3_2 + E3_22 * K_thetadot7_3_3 - T(0.15) * B_thetadot7_3_1;
  A[13] = K_thetadot7_2_3;
  A[43] = K_thetadot7_2_3;
  // B_thetadot6_2 = E3^T B_thetadot6_3
  const T minus_B_thetadot6_2_2 = E3_22 * minus_B_thetadot6_4_2 + E3_23 * B_thetadot6_3_3;
  const T B_thetadot6_2_3 = E3_22 * B_thetadot6_3_3 - E3_23 * minus_B_thetadot6_4_2;
  // K_thetadot6_2 = q3~ E3^T B_thetadot6_3 + E3^T K_thetadot6_3
  const T K_thetadot6_2_1 = K_thetadot6_3_1 + T(0.2) * minus_B_thetadot6_2_2 + T(0.15) * B_thetadot6_2_3;
  const T K_thetadot6_2_2 = T(0.2) * B_thetadot6_3_1 + E3_22 * K_thetadot6_3_2 + E3_23 * minus_K_thetadot6_3_3;
  const T K_thetadot6_2_3 = E3_23 * K_thetadot6_3_2 - E3_22 * minus_K_thetadot6_3_3 - T(0.15) * B_thetadot6_3_1;
  A[12] = K_thetadot6_2_3;
  A[36] = K_thetadot6_2_3;
  // B_thetadot5_2 = E3^T B_thetadot5_3
  const T B_thetadot5_2_2 = E3_22 * hc5_1 - E3_23 * B_thetadot5_3_3;
  const T B_thetadot5_2_3 = E3_23 * hc5_1 + E3_22 * B_thetadot5_3_3;
  // K_thetadot5_2 = q3~ E3^T B_thetadot5_3 + E3^T K_thetadot5_3
  const T K_thetadot5_2_1 = K_thetadot5_3_1 + T(0.15) * B_thetadot5_2_3 - T(0.2) * B_thetadot5_2_2;
  const T K_thetadot5_2_2 = E3_22 * K_thetadot5_3_2 - E3_23 * K_thetadot5_3_3 - T(0.2) * minus_B_thetadot5_3_1;
  const T K_thetadot5_2_3 = T(0.15) * minus_B_thetadot5_3_1 + E3_23 * K_thetadot5_3_2 + E3_22 * K_thetadot5_3_3;
  A[11] = K_thetadot5_2_3;
  A[29] = K_thetadot5_2_3;
  // B_thetadot4_2 = E3^T B_thetadot4_3
  const T B_thetadot4_2_2 = E3_23 * hc4_1;
  const T minus_B_thetadot4_2_3 = E3_22 * hc4_1;
  // K_thetadot4_2 = q3~ E3^T B_thetadot4_3 + E3^T K_thetadot4_3
  const T K_thetadot4_2_1 = b3_4 - T(0.2) * B_thetadot4_2_2 - T(0.15) * minus_B_thetadot4_2_3;
  const T K_thetadot4_2_2 = b3_3 + E3_22 * b3_6 - E3_23 * b3_7;
  const T K_thetadot4_2_3 = E3_23 * b3_6 + E3_22 * b3_7 - T(0.15) * hc4_3;
  A[10] = K_thetadot4_2_3;
  A[22] = K_thetadot4_2_3;
  A[9] = b2_4;
  A[15] = b2_4;

  // ---- body 1 (body_1) and what it carries
  // J1 = -q2~ hc2~ + E2^T J2 E2 + J_own_1 - hc2~ q2~: inertia carried, about the body origin, body axes [kg m^2]
  const T J1_22 = J2_22 + T(1.5925) + E2_12 * (E2_12 * (J2_11 - J2_22) + T(2) * E2_11 * J2_12) + T(0.6) * hc2_1;
  A[0] = J1_22;
  // K_thetadot7_1 = q2~ E2^T B_thetadot7_2 + E2^T K_thetadot7_2
  const T K_thetadot7_1_2 = E2_12 * K_thetadot7_2_1 + E2_11 * K_thetadot7_2_2 - T(0.3) * B_thetadot7_2_3;
  A[6] = K_thetadot7_1_2;
  A[42] = K_thetadot7_1_2;
  // K_thetadot6_1 = q2~ E2^T B_thetadot6_2 + E2^T K_thetadot6_2
  const T K_thetadot6_1_2 = E2_12 * K_thetadot6_2_1 + E2_11 * K_thetadot6_2_2 - T(0.3) * B_thetadot6_2_3;
  A[5] = K_thetadot6_1_2;
  A[35] = K_thetadot6_1_2;
  // K_thetadot5_1 = q2~ E2^T B_thetadot5_2 + E2^T K_thetadot5_2
  const T K_thetadot5_1_2 = E2_12 * K_thetadot5_2_1 + E2_11 * K_thetadot5_2_2 - T(0.3) * B_thetadot5_2_3;
  A[4] = K_thetadot5_1_2;
  A[28] = K_thetadot5_1_2;
  // K_thetadot4_1 = q2~ E2^T B_thetadot4_2 + E2^T K_thetadot4_2
  const T K_thetadot4_1_2 = T(0.3) * minus_B_thetadot4_2_3 + E2_12 * K_thetadot4_2_1 + E2_11 * K_thetadot4_2_2;
  A[3] = K_thetadot4_1_2;
  A[21] = K_thetadot4_1_2;
  // K_thetadot3_1 = q2~ E2^T B_thetadot3_2 + E2^T K_thetadot3_2
  const T K_thetadot3_1_2 = E2_12 * b2_2 - b2_7 + E2_11 * b2_3;
  A[2] = K_thetadot3_1_2;
  A[14] = K_thetadot3_1_2;
  // K_thetadot2_1 = q2~ E2^T B_thetadot2_2 + E2^T K_thetadot2_2
  const T K_thetadot2_1_2 = E2_12 * J2_13 + E2_11 * J2_23;
  A[1] = K_thetadot2_1_2;
  A[7] = K_thetadot2_1_2;

  // ---- results
  A[48] = T(0.22524999999999998);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 472 add, 598 multiply, 14 sine or cosine
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  for (int i = 0; i < 147; ++i) v_y[i] = T(0);
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

  // ---- body 1 (body_1) on the inertial frame
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // B1_1 = -E1^T r1~ b1
  const T t1_1 = minus_E1_13 * T(0.1);
  const T B1_1_1 = E1_11 * T(0.05) - t1_1;
  const T t1_2 = E1_11 * T(0.1);
  const T minus_B1_1_3 = t1_2 + minus_E1_13 * T(0.05);
  v_y[0] = B1_1_1;
  v_y[14] = -minus_B1_1_3;

  // ---- body 2 (body_2) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T E2_12 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T minus_R2_13 = minus_E1_13 * E2_11;
  const T minus_R2_21 = E1_11 * E2_12;
  const T R2_23 = minus_E1_13 * E2_12;
  // P_thetadot1_2 = -E1^T q2~ b1: partial velocity of the body origin, inertial axes
  const T P_thetadot1_2_1 = t1_2 - minus_E1_13 * T(0.3);
  const T minus_P_thetadot1_2_3 = t1_1 + E1_11 * T(0.3);
  // B2_1 = -R2^T r2~ omega_thetadot1_2 + P_thetadot1_2
  const T t2_1 = T(0.1) * E2_11;
  const T t2_2 = T(0.2) * E2_12;
  const T t2_3 = t2_1 - t2_2;
  const T t2_4 = T(0.05) * E2_11;
  const T t2_5 = T(0.05) * E2_12;
  const T minus_B2_1_1 = minus_E1_13 * t2_3 - (P_thetadot1_2_1 + R2_11 * t2_4 + minus_R2_21 * t2_5);
  const T minus_B2_1_2 = E2_11 * t2_5 - E2_12 * t2_4;
  const T minus_B2_1_3 = minus_P_thetadot1_2_3 + minus_R2_13 * t2_4 + R2_23 * t2_5 + E1_11 * t2_3;
  v_y[21] = -minus_B2_1_1;
  v_y[28] = -minus_B2_1_2;
  v_y[35] = -minus_B2_1_3;
  // B3_2 = -R2^T r2~ b2
  const T minus_B3_2_1 = R2_11 * T(0.2) + minus_R2_21 * T(0.1);
  const T B3_2_3 = minus_R2_13 * T(0.2) + R2_23 * T(0.1);
  v_y[22] = -minus_B3_2_1;
  v_y[29] = t2_3;
  v_y[36] = B3_2_3;

  // ---- body 3 (body_3) on body 2
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
  // P_thetadot1_3 = -R2^T q3~ omega_thetadot1_2 + P_thetadot1_2: partial velocity of the body origin, inertial axes
  const T t3_1 = T(0.3) * E2_11 - T(0.15) * E2_12;
  const T t3_2 = E2_12 * T(0.1);
  const T minus_P_thetadot1_3_1 = minus_E1_13 * t3_1 - (P_thetadot1_2_1 + R2_11 * t2_1 + minus_R2_21 * t3_2);
  const T minus_P_thetadot1_3_2 = E2_11 * t3_2 - E2_12 * t2_1;
  const T minus_P_thetadot1_3_3 = minus_P_thetadot1_2_3 + minus_R2_13 * t2_1 + R2_23 * t3_2 + E1_11 * t3_1;
  // P_thetadot2_3 = -R2^T q3~ b2: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot2_3_1 = R2_11 * T(0.15) + minus_R2_21 * T(0.3);
  const T P_thetadot2_3_3 = minus_R2_13 * T(0.15) + R2_23 * T(0.3);
  // B4_1 = -R3^T r3~ omega_thetadot1_3 + P_thetadot1_3
  const T t3_3 = t2_5 + minus_R3_32 * T(0.1);
  const T t3_4 = T(0.05) * R3_22;
  const T t3_5 = T(0.2) * minus_R3_32;
  const T t3_6 = t3_4 + t3_5;
  const T t3_7 = T(0.1) * R3_22;
  const T t3_8 = t3_7 - t2_2;
  const T minus_B4_1_1 = minus_P_thetadot1_3_1 + R3_21 * t3_3 - R2_11 * t3_6 + R3_31 * t3_8;
  const T minus_B4_1_2 = minus_P_thetadot1_3_2 + R3_22 * t3_3 - E2_12 * t3_6 - minus_R3_32 * t3_8;
  const T minus_B4_1_3 = minus_P_thetadot1_3_3 + minus_R2_13 * t3_6 + R3_23 * t3_3 + R3_33 * t3_8;
  v_y[42] = -minus_B4_1_1;
  v_y[49] = -minus_B4_1_2;
  v_y[56] = -minus_B4_1_3;
  // B5_2 = -R3^T r3~ omega_thetadot2_3 + P_thetadot2_3
  const T t3_9 = T(0.2) * E3_22;
  const T t3_10 = T(0.05) * E3_23;
  const T t3_11 = t3_9 - t3_10;
  const T t3_12 = T(0.1) * E3_22;
  const T t3_13 = T(0.1) * E3_23;
  const T minus_B5_2_1 = minus_P_thetadot2_3_1 + R2_11 * t3_11 - R3_21 * t3_12 + R3_31 * t3_13;
  const T minus_B5_2_2 = E2_12 * t3_11 - t3_1 - R3_22 * t3_12 - minus_R3_32 * t3_13;
  const T minus_B5_2_3 = R3_33 * t3_13 - (P_thetadot2_3_3 + minus_R2_13 * t3_11 + R3_23 * t3_12);
  v_y[43] = -minus_B5_2_1;
  v_y[50] = -minus_B5_2_2;
  v_y[57] = -minus_B5_2_3;
  // B6_3 = -R3^T r3~ b3
  const T t3_14 = R3_31 * T(0.2);
  const T minus_B6_3_1 = R3_21 * T(0.05) - t3_14;
  const T t3_15 = R3_33 * T(0.2);
  const T minus_B6_3_3 = R3_23 * T(0.05) - t3_15;
  v_y[44] = -minus_B6_3_1;
  v_y[51] = -t3_6;
  v_y[58] = -minus_B6_3_3;

  // ---- body 4 (body_4) on body 3
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
  // omega_thetadot2_4 = E4 omega_thetadot2_3: partial angular velocity, body axes
  const T minus_omega_thetadot2_4_1 = minus_E4_13 * E3_22;
  const T omega_thetadot2_4_3 = E4_11 * E3_22;
  // P_thetadot1_4 = -R3^T q4~ omega_thetadot1_3 + P_thetadot1_3: partial velocity of the body origin, inertial axes
  const T t4_1 = t3_2 + T(0.3) * minus_R3_32;
  const T t4_2 = t3_7 + t3_5;
  const T t4_3 = T(0.3) * R3_22;
  const T t4_4 = t4_3 - t2_2;
  const T minus_P_thetadot1_4_1 = minus_P_thetadot1_3_1 + R3_21 * t4_1 - R2_11 * t4_2 + R3_31 * t4_4;
  const T minus_P_thetadot1_4_2 = minus_P_thetadot1_3_2 + R3_22 * t4_1 - E2_12 * t4_2 - minus_R3_32 * t4_4;
  const T minus_P_thetadot1_4_3 = minus_P_thetadot1_3_3 + minus_R2_13 * t4_2 + R3_23 * t4_1 + R3_33 * t4_4;
  // P_thetadot2_4 = -R3^T q4~ omega_thetadot2_3 + P_thetadot2_3: partial velocity of the body origin, inertial axes
  const T t4_5 = t3_9 - t3_13;
  const T t4_6 = T(0.3) * E3_22;
  const T t4_7 = T(0.3) * E3_23;
  const T minus_P_thetadot2_4_1 = minus_P_thetadot2_3_1 + R2_11 * t4_5 - R3_21 * t4_6 + R3_31 * t4_7;
  const T minus_P_thetadot2_4_2 = E2_12 * t4_5 - t3_1 - R3_22 * t4_6 - minus_R3_32 * t4_7;
  const T minus_P_thetadot2_4_3 = R3_33 * t4_7 - (P_thetadot2_3_3 + minus_R2_13 * t4_5 + R3_23 * t4_6);
  // P_thetadot3_4 = -R3^T q4~ b3: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot3_4_1 = R3_21 * T(0.1) - t3_14;
  const T minus_P_thetadot3_4_3 = R3_23 * T(0.1) - t3_15;
  // B7_1 = -R4^T r4~ omega_thetadot1_4 + P_thetadot1_4
  const T t4_8 = T(0.2) * R4_32;
  const T t4_9 = t4_8 - t3_4;
  const T t4_10 = R4_32 * T(0.1);
  const T t4_11 = T(0.05) * R4_12 - t4_10;
  const T t4_12 = t3_7 - T(0.2) * R4_12;
  const T minus_B7_1_1 = minus_P_thetadot1_4_1 + R4_11 * t4_9 + R3_21 * t4_11 + R4_31 * t4_12;
  const T minus_B7_1_2 = minus_P_thetadot1_4_2 + R4_12 * t4_9 + R3_22 * t4_11 + R4_32 * t4_12;
  const T minus_B7_1_3 = minus_P_thetadot1_4_3 + R3_23 * t4_11 - minus_R4_13 * t4_9 + R4_33 * t4_12;
  v_y[63] = -minus_B7_1_1;
  v_y[70] = -minus_B7_1_2;
  v_y[77] = -minus_B7_1_3;
  // B8_2 = -R4^T r4~ omega_thetadot2_4 + P_thetadot2_4
  const T t4_13 = T(0.2) * omega_thetadot2_4_3;
  const T t4_14 = t4_13 - t3_10;
  const T t4_15 = T(0.1) * omega_thetadot2_4_3;
  const T t4_16 = t4_15 + T(0.05) * minus_omega_thetadot2_4_1;
  const T t4_17 = t3_13 + T(0.2) * minus_omega_thetadot2_4_1;
  const T minus_B8_2_1 = minus_P_thetadot2_4_1 + R4_11 * t4_14 - R3_21 * t4_16 + R4_31 * t4_17;
  const T minus_B8_2_2 = minus_P_thetadot2_4_2 + R4_12 * t4_14 - R3_22 * t4_16 + R4_32 * t4_17;
  const T minus_B8_2_3 = minus_P_thetadot2_4_3 - minus_R4_13 * t4_14 - R3_23 * t4_16 + R4_33 * t4_17;
  v_y[64] = -minus_B8_2_1;
  v_y[71] = -minus_B8_2_2;
  v_y[78] = -minus_B8_2_3;
  // B9_3 = -R4^T r4~ omega_thetadot3_4 + P_thetadot3_4
  const T t4_18 = T(0.2) * minus_E4_13;
  const T t4_19 = T(0.1) * minus_E4_13;
  const T t4_20 = T(0.05) * E4_11 - t4_19;
  const T t4_21 = T(0.2) * E4_11;
  const T minus_B9_3_1 = minus_P_thetadot3_4_1 + R4_11 * t4_18 + R3_21 * t4_20 - R4_31 * t4_21;
  const T minus_B9_3_2 = t4_2 + R4_12 * t4_18 + R3_22 * t4_20 - R4_32 * t4_21;
  const T minus_B9_3_3 = minus_P_thetadot3_4_3 + R3_23 * t4_20 - minus_R4_13 * t4_18 - R4_33 * t4_21;
  v_y[65] = -minus_B9_3_1;
  v_y[72] = -minus_B9_3_2;
  v_y[79] = -minus_B9_3_3;
  // B10_4 = -R4^T r4~ b4
  const T minus_B10_4_1 = R4_31 * T(0.1) - R4_11 * T(0.05);
  const T minus_B10_4_3 = minus_R4_13 * T(0.05) + R4_33 * T(0.1);
  v_y[66] = -minus_B10_4_1;
  v_y[73] = t4_11;
  v_y[80] = -minus_B10_4_3;

  // ---- body 5 (body_5) on body 4
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
  // omega_thetadot2_5 = E5 omega_thetadot2_4: partial angular velocity, body axes
  const T omega_thetadot2_5_1 = E5_12 * E3_23 - E5_11 * minus_omega_thetadot2_4_1;
  const T omega_thetadot2_5_2 = E5_11 * E3_23 + E5_12 * minus_omega_thetadot2_4_1;
  // omega_thetadot3_5 = E5 omega_thetadot3_4: partial angular velocity, body axes
  const T omega_thetadot3_5_1 = E5_11 * E4_11;
  const T minus_omega_thetadot3_5_2 = E5_12 * E4_11;
  // P_thetadot1_5 = -R4^T q5~ omega_thetadot1_4 + P_thetadot1_4: partial velocity of the body origin, inertial axes
  const T t5_1 = T(0.25) * R4_32 - t3_7;
  const T t5_2 = T(0.3) * R4_32;
  const T t5_3 = R4_12 * T(0.1) - t5_2;
  const T t5_4 = t4_3 - T(0.25) * R4_12;
  const T minus_P_thetadot1_5_1 = minus_P_thetadot1_4_1 + R4_11 * t5_1 + R3_21 * t5_3 + R4_31 * t5_4;
  const T minus_P_thetadot1_5_2 = minus_P_thetadot1_4_2 + R4_12 * t5_1 + R3_22 * t5_3 + R4_32 * t5_4;
  const T minus_P_thetadot1_5_3 = minus_P_thetadot1_4_3 + R3_23 * t5_3 - minus_R4_13 * t5_1 + R4_33 * t5_4;
  // P_thetadot2_5 = -R4^T q5~ omega_thetadot2_4 + P_thetadot2_4: partial velocity of the body origin, inertial axes
  const T t5_5 = T(0.25) * omega_thetadot2_4_3 - t3_13;
  const T t5_6 = T(0.3) * omega_thetadot2_4_3;
  const T t5_7 = t5_6 + T(0.1) * minus_omega_thetadot2_4_1;
  const T t5_8 = t4_7 + T(0.25) * minus_omega_thetadot2_4_1;
  const T minus_P_thetadot2_5_1 = minus_P_thetadot2_4_1 + R4_11 * t5_5 - R3_21 * t5_7 + R4_31 * t5_8;
  const T minus_P_thetadot2_5_2 = minus_P_thetadot2_4_2 + R4_12 * t5_5 - R3_22 * t5_7 + R4_32 * t5_8;
  const T minus_P_thetadot2_5_3 = minus_P_thetadot2_4_3 - minus_R4_13 * t5_5 - R3_23 * t5_7 + R4_33 * t5_8;
  // P_thetadot3_5 = -R4^T q5~ omega_thetadot3_4 + P_thetadot3_4: partial velocity of the body origin, inertial axes
  const T t5_9 = T(0.25) * minus_E4_13;
  const T t5_10 = T(0.3) * minus_E4_13;
  const T t5_11 = T(0.1) * E4_11 - t5_10;
  const T t5_12 = T(0.25) * E4_11;
  const T minus_P_thetadot3_5_1 = minus_P_thetadot3_4_1 + R4_11 * t5_9 + R3_21 * t5_11 - R4_31 * t5_12;
  const T minus_P_thetadot3_5_2 = t4_2 + R4_12 * t5_9 + R3_22 * t5_11 - R4_32 * t5_12;
  const T minus_P_thetadot3_5_3 = minus_P_thetadot3_4_3 + R3_23 * t5_11 - minus_R4_13 * t5_9 - R4_33 * t5_12;
  // P_thetadot4_5 = -R4^T q5~ b4: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot4_5_1 = R4_31 * T(0.3) - R4_11 * T(0.1);
  const T minus_P_thetadot4_5_3 = minus_R4_13 * T(0.1) + R4_33 * T(0.3);
  // B11_1 = -R5^T r5~ omega_thetadot1_5 + P_thetadot1_5
  const T t5_13 = t4_8 - T(0.05) * R5_22;
  const T t5_14 = T(0.05) * R5_12;
  const T t5_15 = t5_14 - t4_10;
  const T t5_16 = T(0.1) * R5_22;
  const T t5_17 = T(0.2) * R5_12;
  const T t5_18 = t5_16 - t5_17;
  const T minus_B11_1_1 = minus_P_thetadot1_5_1 + R5_11 * t5_13 + R5_21 * t5_15 + R4_31 * t5_18;
  const T minus_B11_1_2 = minus_P_thetadot1_5_2 + R5_12 * t5_13 + R5_22 * t5_15 + R4_32 * t5_18;
  const T minus_B11_1_3 = minus_P_thetadot1_5_3 + R5_13 * t5_13 + R5_23 * t5_15 + R4_33 * t5_18;
  v_y[84] = -minus_B11_1_1;
  v_y[91] = -minus_B11_1_2;
  v_y[98] = -minus_B11_1_3;
  // B12_2 = -R5^T r5~ omega_thetadot2_5 + P_thetadot2_5
  const T t5_19 = t4_13 - T(0.05) * omega_thetadot2_5_2;
  const T t5_20 = T(0.05) * omega_thetadot2_5_1;
  const T t5_21 = t5_20 - t4_15;
  const T t5_22 = T(0.1) * omega_thetadot2_5_2;
  const T t5_23 = T(0.2) * omega_thetadot2_5_1;
  const T t5_24 = t5_22 - t5_23;
  const T minus_B12_2_1 = minus_P_thetadot2_5_1 + R5_11 * t5_19 + R5_21 * t5_21 + R4_31 * t5_24;
  const T minus_B12_2_2 = minus_P_thetadot2_5_2 + R5_12 * t5_19 + R5_22 * t5_21 + R4_32 * t5_24;
  const T minus_B12_2_3 = minus_P_thetadot2_5_3 + R5_13 * t5_19 + R5_23 * t5_21 + R4_33 * t5_24;
  v_y[85] = -minus_B12_2_1;
  v_y[92] = -minus_B12_2_2;
  v_y[99] = -minus_B12_2_3;
  // B13_3 = -R5^T r5~ omega_thetadot3_5 + P_thetadot3_5
  const T t5_25 = t4_18 + T(0.05) * minus_omega_thetadot3_5_2;
  const T t5_26 = T(0.05) * omega_thetadot3_5_1;
  const T t5_27 = t5_26 - t4_19;
  const T t5_28 = T(0.1) * minus_omega_thetadot3_5_2;
  const T t5_29 = T(0.2) * omega_thetadot3_5_1;
  const T t5_30 = t5_28 + t5_29;
  const T minus_B13_3_1 = minus_P_thetadot3_5_1 + R5_11 * t5_25 + R5_21 * t5_27 - R4_31 * t5_30;
  const T minus_B13_3_2 = minus_P_thetadot3_5_2 + R5_12 * t5_25 + R5_22 * t5_27 - R4_32 * t5_30;
  const T minus_B13_3_3 = minus_P_thetadot3_5_3 + R5_13 * t5_25 + R5_23 * t5_27 - R4_33 * t5_30;
  v_y[86] = -minus_B13_3_1;
  v_y[93] = -minus_B13_3_2;
  v_y[100] = -minus_B13_3_3;
  // B14_4 = -R5^T r5~ omega_thetadot4_5 + P_thetadot4_5
  const T t5_31 = T(0.05) * E5_12;
  const T t5_32 = T(0.05) * E5_11;
  const T t5_33 = T(0.1) * E5_11;
  const T t5_34 = T(0.2) * E5_12;
  const T t5_35 = t5_33 - t5_34;
  const T minus_B14_4_1 = minus_P_thetadot4_5_1 + R5_21 * t5_31 - R5_11 * t5_32 + R4_31 * t5_35;
  const T minus_B14_4_2 = R5_22 * t5_31 - t5_3 - R5_12 * t5_32 + R4_32 * t5_35;
  const T minus_B14_4_3 = minus_P_thetadot4_5_3 + R5_23 * t5_31 - R5_13 * t5_32 + R4_33 * t5_35;
  v_y[87] = -minus_B14_4_1;
  v_y[94] = -minus_B14_4_2;
  v_y[101] = -minus_B14_4_3;
  // B15_5 = -R5^T r5~ b5
  const T minus_B15_5_1 = R5_11 * T(0.2) - R5_21 * T(0.1);
  const T minus_B15_5_3 = R5_13 * T(0.2) - R5_23 * T(0.1);
  v_y[88] = -minus_B15_5_1;
  v_y[95] = t5_18;
  v_y[102] = -minus_B15_5_3;

  // ---- body 6 (body_6) on body 5
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
  // omega_thetadot2_6 = E6 omega_thetadot2_5: partial angular velocity, body axes
  const T omega_thetadot2_6_2 = E6_22 * omega_thetadot2_5_2 + E6_23 * omega_thetadot2_4_3;
  const T omega_thetadot2_6_3 = E6_22 * omega_thetadot2_4_3 - E6_23 * omega_thetadot2_5_2;
  // omega_thetadot3_6 = E6 omega_thetadot3_5: partial angular velocity, body axes
  const T omega_thetadot3_6_2 = E6_23 * minus_E4_13 - E6_22 * minus_omega_thetadot3_5_2;
  const T omega_thetadot3_6_3 = E6_23 * minus_omega_thetadot3_5_2 + E6_22 * minus_E4_13;
  // omega_thetadot4_6 = E6 omega_thetadot4_5: partial angular velocity, body axes
  const T omega_thetadot4_6_2 = E6_22 * E5_11;
  const T minus_omega_thetadot4_6_3 = E6_23 * E5_11;
  // P_thetadot1_6 = -R5^T q6~ omega_thetadot1_5 + P_thetadot1_5: partial velocity of the body origin, inertial axes
  const T t6_1 = t5_2 - t5_16;
  const T t6_2 = R5_12 * T(0.1);
  const T t6_3 = t6_2 - t5_2;
  const T t6_4 = R5_22 * T(0.3) - R5_12 * T(0.3);
  const T minus_P_thetadot1_6_1 = minus_P_thetadot1_5_1 + R5_11 * t6_1 + R5_21 * t6_3 + R4_31 * t6_4;
  const T minus_P_thetadot1_6_2 = minus_P_thetadot1_5_2 + R5_12 * t6_1 + R5_22 * t6_3 + R4_32 * t6_4;
  const T minus_P_thetadot1_6_3 = minus_P_thetadot1_5_3 + R5_13 * t6_1 + R5_23 * t6_3 + R4_33 * t6_4;
  // P_thetadot2_6 = -R5^T q6~ omega_thetadot2_5 + P_thetadot2_5: partial velocity of the body origin, inertial axes
  const T t6_5 = t5_6 - t5_22;
  const T t6_6 = T(0.1) * omega_thetadot2_5_1;
  const T t6_7 = t6_6 - t5_6;
  const T t6_8 = T(0.3) * omega_thetadot2_5_2 - T(0.3) * omega_thetadot2_5_1;
  const T minus_P_thetadot2_6_1 = minus_P_thetadot2_5_1 + R5_11 * t6_5 + R5_21 * t6_7 + R4_31 * t6_8;
  const T minus_P_thetadot2_6_2 = minus_P_thetadot2_5_2 + R5_12 * t6_5 + R5_22 * t6_7 + R4_32 * t6_8;
  const T minus_P_thetadot2_6_3 = minus_P_thetadot2_5_3 + R5_13 * t6_5 + R5_23 * t6_7 + R4_33 * t6_8;
  // P_thetadot3_6 = -R5^T q6~ omega_thetadot3_5 + P_thetadot3_5: partial velocity of the body origin, inertial axes
  const T t6_9 = t5_28 + t5_10;
  const T t6_10 = T(0.1) * omega_thetadot3_5_1;
  const T t6_11 = t6_10 - t5_10;
  const T t6_12 = T(0.3) * minus_omega_thetadot3_5_2 + T(0.3) * omega_thetadot3_5_1;
  const T minus_P_thetadot3_6_1 = minus_P_thetadot3_5_1 + R5_11 * t6_9 + R5_21 * t6_11 - R4_31 * t6_12;
  const T minus_P_thetadot3_6_2 = minus_P_thetadot3_5_2 + R5_12 * t6_9 + R5_22 * t6_11 - R4_32 * t6_12;
  const T minus_P_thetadot3_6_3 = minus_P_thetadot3_5_3 + R5_13 * t6_9 + R5_23 * t6_11 - R4_33 * t6_12;
  // P_thetadot4_6 = -R5^T q6~ omega_thetadot4_5 + P_thetadot4_5: partial velocity of the body origin, inertial axes
  const T t6_13 = T(0.1) * E5_12;
  const T t6_14 = T(0.3) * E5_11 - T(0.3) * E5_12;
  const T minus_P_thetadot4_6_1 = minus_P_thetadot4_5_1 + R5_21 * t6_13 - R5_11 * t5_33 + R4_31 * t6_14;
  const T minus_P_thetadot4_6_2 = R5_22 * t6_13 - t5_3 - R5_12 * t5_33 + R4_32 * t6_14;
  const T minus_P_thetadot4_6_3 = minus_P_thetadot4_5_3 + R5_23 * t6_13 - R5_13 * t5_33 + R4_33 * t6_14;
  // P_thetadot5_6 = -R5^T q6~ b5: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot5_6_1 = R5_11 * T(0.3) - R5_21 * T(0.3);
  const T minus_P_thetadot5_6_3 = R5_13 * T(0.3) - R5_23 * T(0.3);
  // B16_1 = -R6^T r6~ omega_thetadot1_6 + P_thetadot1_6
  const T t6_15 = T(0.05) * R6_22;
  const T t6_16 = T(0.2) * R6_32 - t6_15;
  const T t6_17 = t5_14 - R6_32 * T(0.1);
  const T t6_18 = T(0.1) * R6_22;
  const T t6_19 = t6_18 - t5_17;
  const T minus_B16_1_1 = minus_P_thetadot1_6_1 + R5_11 * t6_16 + R6_21 * t6_17 + R6_31 * t6_19;
  const T minus_B16_1_2 = minus_P_thetadot1_6_2 + R5_12 * t6_16 + R6_22 * t6_17 + R6_32 * t6_19;
  const T minus_B16_1_3 = minus_P_thetadot1_6_3 + R5_13 * t6_16 + R6_23 * t6_17 + R6_33 * t6_19;
  v_y[105] = -minus_B16_1_1;
  v_y[112] = -minus_B16_1_2;
  v_y[119] = -minus_B16_1_3;
  // B17_2 = -R6^T r6~ omega_thetadot2_6 + P_thetadot2_6
  const T t6_20 = T(0.05) * omega_thetadot2_6_2;
  const T t6_21 = T(0.2) * omega_thetadot2_6_3 - t6_20;
  const T t6_22 = t5_20 - T(0.1) * omega_thetadot2_6_3;
  const T t6_23 = T(0.1) * omega_thetadot2_6_2;
  const T t6_24 = t6_23 - t5_23;
  const T minus_B17_2_1 = minus_P_thetadot2_6_1 + R5_11 * t6_21 + R6_21 * t6_22 + R6_31 * t6_24;
  const T minus_B17_2_2 = minus_P_thetadot2_6_2 + R5_12 * t6_21 + R6_22 * t6_22 + R6_32 * t6_24;
  const T minus_B17_2_3 = minus_P_thetadot2_6_3 + R5_13 * t6_21 + R6_23 * t6_22 + R6_33 * t6_24;
  v_y[106] = -minus_B17_2_1;
  v_y[113] = -minus_B17_2_2;
  v_y[120] = -minus_B17_2_3;
  // B18_3 = -R6^T r6~ omega_thetadot3_6 + P_thetadot3_6
  const T t6_25 = T(0.05) * omega_thetadot3_6_2;
  const T t6_26 = T(0.2) * omega_thetadot3_6_3 - t6_25;
  const T t6_27 = t5_26 - T(0.1) * omega_thetadot3_6_3;
  const T t6_28 = T(0.1) * omega_thetadot3_6_2;
  const T t6_29 = t6_28 - t5_29;
  const T minus_B18_3_1 = minus_P_thetadot3_6_1 + R5_11 * t6_26 + R6_21 * t6_27 + R6_31 * t6_29;
  const T minus_B18_3_2 = minus_P_thetadot3_6_2 + R5_12 * t6_26 + R6_22 * t6_27 + R6_32 * t6_29;
  const T minus_B18_3_3 = minus_P_thetadot3_6_3 + R5_13 * t6_26 + R6_23 * t6_27 + R6_33 * t6_29;
  v_y[107] = -minus_B18_3_1;
  v_y[114] = -minus_B18_3_2;
  v_y[121] = -minus_B18_3_3;
  // B19_4 = -R6^T r6~ omega_thetadot4_6 + P_thetadot4_6
  const T t6_30 = t5_31 + T(0.1) * minus_omega_thetadot4_6_3;
  const T t6_31 = T(0.05) * omega_thetadot4_6_2;
  const T t6_32 = t6_31 + T(0.2) * minus_omega_thetadot4_6_3;
  const T t6_33 = T(0.1) * omega_thetadot4_6_2;
  const T t6_34 = t6_33 - t5_34;
  const T minus_B19_4_1 = minus_P_thetadot4_6_1 + R6_21 * t6_30 - R5_11 * t6_32 + R6_31 * t6_34;
  const T minus_B19_4_2 = minus_P_thetadot4_6_2 + R6_22 * t6_30 - R5_12 * t6_32 + R6_32 * t6_34;
  const T minus_B19_4_3 = minus_P_thetadot4_6_3 + R6_23 * t6_30 - R5_13 * t6_32 + R6_33 * t6_34;
  v_y[108] = -minus_B19_4_1;
  v_y[115] = -minus_B19_4_2;
  v_y[122] = -minus_B19_4_3;
  // B20_5 = -R6^T r6~ omega_thetadot5_6 + P_thetadot5_6
  const T t6_35 = T(0.05) * E6_23;
  const T t6_36 = T(0.2) * E6_22 - t6_35;
  const T t6_37 = T(0.1) * E6_22;
  const T t6_38 = T(0.1) * E6_23;
  const T minus_B20_5_1 = minus_P_thetadot5_6_1 + R5_11 * t6_36 - R6_21 * t6_37 + R6_31 * t6_38;
  const T minus_B20_5_2 = R5_12 * t6_36 - t6_4 - R6_22 * t6_37 + R6_32 * t6_38;
  const T minus_B20_5_3 = minus_P_thetadot5_6_3 + R5_13 * t6_36 - R6_23 * t6_37 + R6_33 * t6_38;
  v_y[109] = -minus_B20_5_1;
  v_y[116] = -minus_B20_5_2;
  v_y[123] = -minus_B20_5_3;
  // B21_6 = -R6^T r6~ b6
  const T minus_B21_6_1 = R6_21 * T(0.05) - R6_31 * T(0.2);
  const T minus_B21_6_3 = R6_23 * T(0.05) - R6_33 * T(0.2);
  v_y[110] = -minus_B21_6_1;
  v_y[117] = t6_16;
  v_y[124] = -minus_B21_6_3;

  // ---- body 7 (body_7) on body 6
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
  // omega_thetadot2_7 = E7 omega_thetadot2_6: partial angular velocity, body axes
  const T omega_thetadot2_7_1 = E7_11 * omega_thetadot2_5_1 - minus_E7_13 * omega_thetadot2_6_3;
  const T omega_thetadot2_7_3 = minus_E7_13 * omega_thetadot2_5_1 + E7_11 * omega_thetadot2_6_3;
  // omega_thetadot3_7 = E7 omega_thetadot3_6: partial angular velocity, body axes
  const T omega_thetadot3_7_1 = E7_11 * omega_thetadot3_5_1 - minus_E7_13 * omega_thetadot3_6_3;
  const T omega_thetadot3_7_3 = minus_E7_13 * omega_thetadot3_5_1 + E7_11 * omega_thetadot3_6_3;
  // omega_thetadot4_7 = E7 omega_thetadot4_6: partial angular velocity, body axes
  const T omega_thetadot4_7_1 = E7_11 * E5_12 + minus_E7_13 * minus_omega_thetadot4_6_3;
  const T omega_thetadot4_7_3 = minus_E7_13 * E5_12 - E7_11 * minus_omega_thetadot4_6_3;
  // omega_thetadot5_7 = E7 omega_thetadot5_6: partial angular velocity, body axes
  const T minus_omega_thetadot5_7_1 = minus_E7_13 * E6_22;
  const T omega_thetadot5_7_3 = E7_11 * E6_22;
  // P_thetadot1_7 = -R6^T q7~ omega_thetadot1_6 + P_thetadot1_6: partial velocity of the body origin, inertial axes
  const T t7_1 = T(0.35) * R6_32 - t6_18;
  const T t7_2 = t6_2 - T(0.3) * R6_32;
  const T t7_3 = T(0.3) * R6_22 - T(0.35) * R5_12;
  const T minus_P_thetadot1_7_1 = minus_P_thetadot1_6_1 + R5_11 * t7_1 + R6_21 * t7_2 + R6_31 * t7_3;
  const T minus_P_thetadot1_7_2 = minus_P_thetadot1_6_2 + R5_12 * t7_1 + R6_22 * t7_2 + R6_32 * t7_3;
  const T minus_P_thetadot1_7_3 = minus_P_thetadot1_6_3 + R5_13 * t7_1 + R6_23 * t7_2 + R6_33 * t7_3;
  // P_thetadot2_7 = -R6^T q7~ omega_thetadot2_6 + P_thetadot2_6: partial velocity of the body origin, inertial axes
  const T t7_4 = T(0.35) * omega_thetadot2_6_3 - t6_23;
  const T t7_5 = t6_6 - T(0.3) * omega_thetadot2_6_3;
  const T t7_6 = T(0.3) * omega_thetadot2_6_2 - T(0.35) * omega_thetadot2_5_1;
  const T minus_P_thetadot2_7_1 = minus_P_thetadot2_6_1 + R5_11 * t7_4 + R6_21 * t7_5 + R6_31 * t7_6;
  const T minus_P_thetadot2_7_2 = minus_P_thetadot2_6_2 + R5_12 * t7_4 + R6_22 * t7_5 + R6_32 * t7_6;
  const T minus_P_thetadot2_7_3 = minus_P_thetadot2_6_3 + R5_13 * t7_4 + R6_23 * t7_5 + R6_33 * t7_6;
  // P_thetadot3_7 = -R6^T q7~ omega_thetadot3_6 + P_thetadot3_6: partial velocity of the body origin, inertial axes
  const T t7_7 = T(0.35) * omega_thetadot3_6_3 - t6_28;
  const T t7_8 = t6_10 - T(0.3) * omega_thetadot3_6_3;
  const T t7_9 = T(0.3) * omega_thetadot3_6_2 - T(0.35) * omega_thetadot3_5_1;
  const T minus_P_thetadot3_7_1 = minus_P_thetadot3_6_1 + R5_11 * t7_7 + R6_21 * t7_8 + R6_31 * t7_9;
  const T minus_P_thetadot3_7_2 = minus_P_thetadot3_6_2 + R5_12 * t7_7 + R6_22 * t7_8 + R6_32 * t7_9;
  const T minus_P_thetadot3_7_3 = minus_P_thetadot3_6_3 + R5_13 * t7_7 + R6_23 * t7_8 + R6_33 * t7_9;
  // P_thetadot4_7 = -R6^T q7~ omega_thetadot4_6 + P_thetadot4_6: partial velocity of the body origin, inertial axes
  const T t7_10 = t6_13 + T(0.3) * minus_omega_thetadot4_6_3;
  const T t7_11 = t6_33 + T(0.35) * minus_omega_thetadot4_6_3;
  const T t7_12 = T(0.3) * omega_thetadot4_6_2 - T(0.35) * E5_12;
  const T minus_P_thetadot4_7_1 = minus_P_thetadot4_6_1 + R6_21 * t7_10 - R5_11 * t7_11 + R6_31 * t7_12;
  const T minus_P_thetadot4_7_2 = minus_P_thetadot4_6_2 + R6_22 * t7_10 - R5_12 * t7_11 + R6_32 * t7_12;
  const T minus_P_thetadot4_7_3 = minus_P_thetadot4_6_3 + R6_23 * t7_10 - R5_13 * t7_11 + R6_33 * t7_12;
  // P_thetadot5_7 = -R6^T q7~ omega_thetadot5_6 + P_thetadot5_6: partial velocity of the body origin, inertial axes
  const T t7_13 = T(0.35) * E6_22 - t6_38;
  const T t7_14 = T(0.3) * E6_22;
  const T t7_15 = T(0.3) * E6_23;
  const T minus_P_thetadot5_7_1 = minus_P_thetadot5_6_1 + R5_11 * t7_13 - R6_21 * t7_14 + R6_31 * t7_15;
  const T minus_P_thetadot5_7_2 = R5_12 * t7_13 - t6_4 - R6_22 * t7_14 + R6_32 * t7_15;
  const T minus_P_thetadot5_7_3 = minus_P_thetadot5_6_3 + R5_13 * t7_13 - R6_23 * t7_14 + R6_33 * t7_15;
  // P_thetadot6_7 = -R6^T q7~ b6: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot6_7_1 = R6_21 * T(0.1) - R6_31 * T(0.35);
  const T minus_P_thetadot6_7_3 = R6_23 * T(0.1) - R6_33 * T(0.35);
  // B22_1 = -R7^T r7~ omega_thetadot1_7 + P_thetadot1_7
  const T t7_16 = T(0.2) * R7_32 - t6_15;
  const T t7_17 = T(0.05) * R7_12 - T(0.1) * R7_32;
  const T t7_18 = t6_18 - T(0.2) * R7_12;
  const T minus_B22_1_1 = minus_P_thetadot1_7_1 + R7_11 * t7_16 + R6_21 * t7_17 + R7_31 * t7_18;
  const T minus_B22_1_2 = minus_P_thetadot1_7_2 + R7_12 * t7_16 + R6_22 * t7_17 + R7_32 * t7_18;
  const T minus_B22_1_3 = minus_P_thetadot1_7_3 + R7_13 * t7_16 + R6_23 * t7_17 + R7_33 * t7_18;
  v_y[126] = -minus_B22_1_1;
  v_y[133] = -minus_B22_1_2;
  v_y[140] = -minus_B22_1_3;
  // B23_2 = -R7^T r7~ omega_thetadot2_7 + P_thetadot2_7
  const T t7_19 = T(0.2) * omega_thetadot2_7_3 - t6_20;
  const T t7_20 = T(0.05) * omega_thetadot2_7_1 - T(0.1) * omega_thetadot2_7_3;
  const T t7_21 = t6_23 - T(0.2) * omega_thetadot2_7_1;
  const T minus_B23_2_1 = minus_P_thetadot2_7_1 + R7_11 * t7_19 + R6_21 * t7_20 + R7_31 * t7_21;
  const T minus_B23_2_2 = minus_P_thetadot2_7_2 + R7_12 * t7_19 + R6_22 * t7_20 + R7_32 * t7_21;
  const T minus_B23_2_3 = minus_P_thetadot2_7_3 + R7_13 * t7_19 + R6_23 * t7_20 + R7_33 * t7_21;
  v_y[127] = -minus_B23_2_1;
  v_y[134] = -minus_B23_2_2;
  v_y[141] = -minus_B23_2_3;
  // B24_3 = -R7^T r7~ omega_thetadot3_7 + P_thetadot3_7
  const T t7_22 = T(0.2) * omega_thetadot3_7_3 - t6_25;
  const T t7_23 = T(0.05) * omega_thetadot3_7_1 - T(0.1) * omega_thetadot3_7_3;
  const T t7_24 = t6_28 - T(0.2) * omega_thetadot3_7_1;
  const T minus_B24_3_1 = minus_P_thetadot3_7_1 + R7_11 * t7_22 + R6_21 * t7_23 + R7_31 * t7_24;
  const T minus_B24_3_2 = minus_P_thetadot3_7_2 + R7_12 * t7_22 + R6_22 * t7_23 + R7_32 * t7_24;
  const T minus_B24_3_3 = minus_P_thetadot3_7_3 + R7_13 * t7_22 + R6_23 * t7_23 + R7_33 * t7_24;
  v_y[128] = -minus_B24_3_1;
  v_y[135] = -minus_B24_3_2;
  v_y[142] = -minus_B24_3_3;
  // B25_4 = -R7^T r7~ omega_thetadot4_7 + P_thetadot4_7
  const T t7_25 = T(0.2) * omega_thetadot4_7_3 - t6_31;
  const T t7_26 = T(0.05) * omega_thetadot4_7_1 - T(0.1) * omega_thetadot4_7_3;
  const T t7_27 = t6_33 - T(0.2) * omega_thetadot4_7_1;
  const T minus_B25_4_1 = minus_P_thetadot4_7_1 + R7_11 * t7_25 + R6_21 * t7_26 + R7_31 * t7_27;
  const T minus_B25_4_2 = minus_P_thetadot4_7_2 + R7_12 * t7_25 + R6_22 * t7_26 + R7_32 * t7_27;
  const T minus_B25_4_3 = minus_P_thetadot4_7_3 + R7_13 * t7_25 + R6_23 * t7_26 + R7_33 * t7_27;
  v_y[129] = -minus_B25_4_1;
  v_y[136] = -minus_B25_4_2;
  v_y[143] = -minus_B25_4_3;
  // B26_5 = -R7^T r7~ omega_thetadot5_7 + P_thetadot5_7
  const T t7_28 = T(0.2) * omega_thetadot5_7_3 - t6_35;
  const T t7_29 = T(0.05) * minus_omega_thetadot5_7_1 + T(0.1) * omega_thetadot5_7_3;
  const T t7_30 = t6_38 + T(0.2) * minus_omega_thetadot5_7_1;
  const T minus_B26_5_1 = minus_P_thetadot5_7_1 + R7_11 * t7_28 - R6_21 * t7_29 + R7_31 * t7_30;
  const T minus_B26_5_2 = minus_P_thetadot5_7_2 + R7_12 * t7_28 - R6_22 * t7_29 + R7_32 * t7_30;
  const T minus_B26_5_3 = minus_P_thetadot5_7_3 + R7_13 * t7_28 - R6_23 * t7_29 + R7_33 * t7_30;
  v_y[130] = -minus_B26_5_1;
  v_y[137] = -minus_B26_5_2;
  v_y[144] = -minus_B26_5_3;
  // B27_6 = -R7^T r7~ omega_thetadot6_7 + P_thetadot6_7
  const T t7_31 = T(0.2) * minus_E7_13;
  const T t7_32 = T(0.05) * E7_11 - T(0.1) * minus_E7_13;
  const T t7_33 = T(0.2) * E7_11;
  const T minus_B27_6_1 = minus_P_thetadot6_7_1 + R7_11 * t7_31 + R6_21 * t7_32 - R7_31 * t7_33;
  const T minus_B27_6_2 = R7_12 * t7_31 - t7_1 + R6_22 * t7_32 - R7_32 * t7_33;
  const T minus_B27_6_3 = minus_P_thetadot6_7_3 + R7_13 * t7_31 + R6_23 * t7_32 - R7_33 * t7_33;
  v_y[131] = -minus_B27_6_1;
  v_y[138] = -minus_B27_6_2;
  v_y[145] = -minus_B27_6_3;
  // B28_7 = -R7^T r7~ b7
  const T minus_B28_7_1 = R7_31 * T(0.1) - R7_11 * T(0.05);
  const T minus_B28_7_3 = R7_33 * T(0.1) - R7_13 * T(0.05);
  v_y[132] = -minus_B28_7_1;
  v_y[139] = t7_17;
  v_y[146] = -minus_B28_7_3;
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 1017 add, 1345 multiply, 14 sine or cosine
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  for (int i = 0; i < 147; ++i) v_y_dot[i] = T(0);
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

  // ---- body 1 (body_1) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // B1_1 = -E1^T omega1~ r1~ b1
  const T t1_1 = thetadot1 * T(0.1);
  const T t1_2 = E1_11 * t1_1;
  const T t1_3 = thetadot1 * T(0.05);
  const T minus_B1_1_1 = t1_2 + minus_E1_13 * t1_3;
  const T t1_4 = minus_E1_13 * t1_1;
  const T minus_B1_1_3 = E1_11 * t1_3 - t1_4;
  v_y_dot[0] = -minus_B1_1_1;
  v_y_dot[14] = -minus_B1_1_3;

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
  // omega_dot_thetadot1_2 = -thetadot2 b2~ E2 b1: its rate
  const T omega_dot_thetadot1_2_1 = thetadot2 * E2_11;
  const T minus_omega_dot_thetadot1_2_2 = thetadot2 * E2_12;
  // P_dot_thetadot1_2 = -E1^T omega1~ q2~ b1: its rate
  const T t2_1 = thetadot1 * T(0.3);
  const T minus_P_dot_thetadot1_2_1 = t1_4 + E1_11 * t2_1;
  const T minus_P_dot_thetadot1_2_3 = t1_2 - minus_E1_13 * t2_1;
  // B2_1 = -R2^T omega2~ r2~ omega_thetadot1_2 - R2^T r2~ omega_dot_thetadot1_2 + P_dot_thetadot1_2
  const T t2_2 = T(0.1) * E2_11;
  const T t2_3 = T(0.2) * E2_12;
  const T t2_4 = t2_2 - t2_3;
  const T t2_5 = T(0.05) * E2_12;
  const T t2_6 = omega2_2 * t2_4 - thetadot2 * t2_5;
  const T t2_7 = T(0.05) * E2_11;
  const T t2_8 = thetadot2 * t2_7 + omega2_1 * t2_4;
  const T t2_9 = omega2_1 * t2_5 + omega2_2 * t2_7;
  const T t2_10 = T(0.05) * minus_omega_dot_thetadot1_2_2;
  const T t2_11 = T(0.05) * omega_dot_thetadot1_2_1;
  const T t2_12 = T(0.1) * minus_omega_dot_thetadot1_2_2;
  const T t2_13 = T(0.2) * omega_dot_thetadot1_2_1;
  const T t2_14 = t2_12 + t2_13;
  const T minus_B2_1_1 = minus_P_dot_thetadot1_2_1 + R2_11 * t2_6 + minus_R2_21 * t2_8 + minus_E1_13 * t2_9 + R2_11 *
      t2_10 - minus_R2_21 * t2_11 - minus_E1_13 * t2_14;
  const T minus_B2_1_2 = E2_12 * t2_6 - E2_11 * t2_8 + E2_12 * t2_10 + E2_11 * t2_11;
  const T minus_B2_1_3 = minus_P_dot_thetadot1_2_3 - minus_R2_13 * t2_6 - R2_23 * t2_8 + E1_11 * t2_9 + R2_23 * t2_11
      - minus_R2_13 * t2_10 - E1_11 * t2_14;
  v_y_dot[21] = -minus_B2_1_1;
  v_y_dot[28] = -minus_B2_1_2;
  v_y_dot[35] = -minus_B2_1_3;
  // B3_2 = -R2^T omega2~ r2~ b2
  const T t2_15 = thetadot2 * T(0.1);
  const T t2_16 = thetadot2 * T(0.2);
  const T t2_17 = omega2_1 * T(0.1) + omega2_2 * T(0.2);
  const T minus_B3_2_1 = R2_11 * t2_15 - minus_R2_21 * t2_16 - minus_E1_13 * t2_17;
  const T minus_B3_2_2 = E2_12 * t2_15 + E2_11 * t2_16;
  const T minus_B3_2_3 = R2_23 * t2_16 - minus_R2_13 * t2_15 - E1_11 * t2_17;
  v_y_dot[22] = -minus_B3_2_1;
  v_y_dot[29] = -minus_B3_2_2;
  v_y_dot[36] = -minus_B3_2_3;

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
  // omega_dot_thetadot1_3 = -thetadot3 b3~ E3 omega_thetadot1_2 + E3 omega_dot_thetadot1_2: its rate
  const T minus_omega_dot_thetadot1_3_2 = thetadot3 * minus_R3_32 + E3_22 * minus_omega_dot_thetadot1_2_2;
  const T omega_dot_thetadot1_3_3 = E3_23 * minus_omega_dot_thetadot1_2_2 - thetadot3 * R3_22;
  // omega_dot_thetadot2_3 = -thetadot3 b3~ E3 b2: its rate
  const T omega_dot_thetadot2_3_2 = thetadot3 * E3_22;
  const T minus_omega_dot_thetadot2_3_3 = thetadot3 * E3_23;
  // P_dot_thetadot1_3 = R2^T (-omega2~ q3~ omega_thetadot1_2 - q3~ omega_dot_thetadot1_2) + P_dot_thetadot1_2: its
  //   rate
  const T t3_1 = T(0.3) * E2_11 - T(0.15) * E2_12;
  const T t3_2 = E2_12 * T(0.1);
  const T t3_3 = t2_12 + omega2_2 * t3_1 - thetadot2 * t3_2;
  const T t3_4 = T(0.1) * omega_dot_thetadot1_2_1;
  const T t3_5 = t3_4 - thetadot2 * t2_2 - omega2_1 * t3_1;
  const T t3_6 = omega2_1 * t3_2 + omega2_2 * t2_2 - T(0.3) * minus_omega_dot_thetadot1_2_2 - T(0.15) *
      omega_dot_thetadot1_2_1;
  const T minus_P_dot_thetadot1_3_1 = minus_P_dot_thetadot1_2_1 + R2_11 * t3_3 - minus_R2_21 * t3_5 + minus_E1_13 *
      t3_6;
  const T minus_P_dot_thetadot1_3_2 = E2_12 * t3_3 + E2_11 * t3_5;
  const T minus_P_dot_thetadot1_3_3 = minus_P_dot_thetadot1_2_3 + R2_23 * t3_5 - minus_R2_13 * t3_3 + E1_11 * t3_6;
  // P_dot_thetadot2_3 = -R2^T omega2~ q3~ b2: its rate
  const T t3_7 = thetadot2 * T(0.3);
  const T t3_8 = thetadot2 * T(0.15);
  const T t3_9 = omega2_1 * T(0.3) + omega2_2 * T(0.15);
  const T minus_P_dot_thetadot2_3_1 = R2_11 * t3_7 - minus_R2_21 * t3_8 - minus_E1_13 * t3_9;
  const T minus_P_dot_thetadot2_3_2 = E2_12 * t3_7 + E2_11 * t3_8;
  const T minus_P_dot_thetadot2_3_3 = R2_23 * t3_8 - minus_R2_13 * t3_7 - E1_11 * t3_9;
  // B4_1 = -R3^T omega3~ r3~ omega_thetadot1_3 - R3^T r3~ omega_dot_thetadot1_3 + P_dot_thetadot1_3
  const T t3_10 = T(0.1) * R3_22;
  const T t3_11 = t3_10 - t2_3;
  const T t3_12 = t2_5 + minus_R3_32 * T(0.1);
  const T t3_13 = omega3_2 * t3_11 - omega3_3 * t3_12;
  const T t3_14 = T(0.05) * R3_22;
  const T t3_15 = T(0.2) * minus_R3_32;
  const T t3_16 = t3_14 + t3_15;
  const T t3_17 = omega3_3 * t3_16 + omega3_1 * t3_11;
  const T t3_18 = omega3_1 * t3_12 + omega3_2 * t3_16;
  const T t3_19 = T(0.05) * minus_omega_dot_thetadot1_3_2;
  const T t3_20 = T(0.2) * omega_dot_thetadot1_3_3;
  const T t3_21 = t3_19 + t3_20;
  const T t3_22 = t2_11 - T(0.1) * omega_dot_thetadot1_3_3;
  const T t3_23 = T(0.1) * minus_omega_dot_thetadot1_3_2;
  const T t3_24 = t3_23 + t2_13;
  const T minus_B4_1_1 = minus_P_dot_thetadot1_3_1 + R2_11 * t3_13 - R3_21 * t3_17 + R3_31 * t3_18 + R2_11 * t3_21 +
      R3_21 * t3_22 - R3_31 * t3_24;
  const T minus_B4_1_2 = minus_P_dot_thetadot1_3_2 + E2_12 * t3_13 - R3_22 * t3_17 - minus_R3_32 * t3_18 + E2_12 *
      t3_21 + R3_22 * t3_22 + minus_R3_32 * t3_24;
  const T minus_B4_1_3 = minus_P_dot_thetadot1_3_3 - minus_R2_13 * t3_13 - R3_23 * t3_17 + R3_33 * t3_18 + R3_23 *
      t3_22 - minus_R2_13 * t3_21 - R3_33 * t3_24;
  v_y_dot[42] = -minus_B4_1_1;
  v_y_dot[49] = -minus_B4_1_2;
  v_y_dot[56] = -minus_B4_1_3;
  // B5_2 = -R3^T omega3~ r3~ omega_thetadot2_3 - R3^T r3~ omega_dot_thetadot2_3 + P_dot_thetadot2_3
  const T t3_25 = T(0.1) * E3_22;
  const T t3_26 = T(0.1) * E3_23;
  const T t3_27 = omega3_3 * t3_25 + omega3_2 * t3_26;
  const T t3_28 = T(0.2) * E3_22;
  const T t3_29 = T(0.05) * E3_23;
  const T t3_30 = t3_28 - t3_29;
  const T t3_31 = omega3_3 * t3_30 - omega3_1 * t3_26;
  const T t3_32 = omega3_1 * t3_25 + omega3_2 * t3_30;
  const T t3_33 = T(0.1) * minus_omega_dot_thetadot2_3_3;
  const T t3_34 = T(0.05) * omega_dot_thetadot2_3_2;
  const T t3_35 = T(0.2) * minus_omega_dot_thetadot2_3_3;
  const T t3_36 = t3_34 + t3_35;
  const T t3_37 = T(0.1) * omega_dot_thetadot2_3_2;
  const T minus_B5_2_1 = minus_P_dot_thetadot2_3_1 + R2_11 * t3_27 + R3_21 * t3_31 - R3_31 * t3_32 + R3_21 * t3_33 -
      R2_11 * t3_36 + R3_31 * t3_37;
  const T minus_B5_2_2 = minus_P_dot_thetadot2_3_2 + E2_12 * t3_27 + R3_22 * t3_31 + minus_R3_32 * t3_32 + R3_22 *
      t3_33 - E2_12 * t3_36 - minus_R3_32 * t3_37;
  const T minus_B5_2_3 = minus_P_dot_thetadot2_3_3 + R3_23 * t3_31 - minus_R2_13 * t3_27 - R3_33 * t3_32 + minus_R2_13
      * t3_36 + R3_23 * t3_33 + R3_33 * t3_37;
  v_y_dot[43] = -minus_B5_2_1;
  v_y_dot[50] = -minus_B5_2_2;
  v_y_dot[57] = -minus_B5_2_3;
  // B6_3 = -R3^T omega3~ r3~ b3
  const T t3_38 = omega3_1 * T(0.2);
  const T t3_39 = R3_21 * t3_38;
  const T t3_40 = omega3_2 * T(0.2);
  const T t3_41 = t3_40 + omega3_3 * T(0.05);
  const T t3_42 = omega3_1 * T(0.05);
  const T minus_B6_3_1 = t3_39 - R2_11 * t3_41 + R3_31 * t3_42;
  const T t3_43 = R3_22 * t3_38;
  const T minus_B6_3_2 = t3_43 - E2_12 * t3_41 - minus_R3_32 * t3_42;
  const T t3_44 = R3_23 * t3_38;
  const T minus_B6_3_3 = minus_R2_13 * t3_41 + t3_44 + R3_33 * t3_42;
  v_y_dot[44] = -minus_B6_3_1;
  v_y_dot[51] = -minus_B6_3_2;
  v_y_dot[58] = -minus_B6_3_3;

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
  // omega_dot_thetadot1_4 = -thetadot4 b4~ E4 omega_thetadot1_3 + E4 omega_dot_thetadot1_3: its rate
  const T omega_dot_thetadot1_4_1 = E4_11 * omega_dot_thetadot1_2_1 - minus_E4_13 * omega_dot_thetadot1_3_3 -
      thetadot4 * R4_32;
  const T omega_dot_thetadot1_4_3 = thetadot4 * R4_12 + minus_E4_13 * omega_dot_thetadot1_2_1 + E4_11 *
      omega_dot_thetadot1_3_3;
  // omega_thetadot2_4 = E4 omega_thetadot2_3: partial angular velocity, body axes
  const T minus_omega_thetadot2_4_1 = minus_E4_13 * E3_22;
  const T omega_thetadot2_4_3 = E4_11 * E3_22;
  // omega_dot_thetadot2_4 = -thetadot4 b4~ E4 omega_thetadot2_3 + E4 omega_dot_thetadot2_3: its rate
  const T omega_dot_thetadot2_4_1 = minus_E4_13 * minus_omega_dot_thetadot2_3_3 - thetadot4 * omega_thetadot2_4_3;
  const T minus_omega_dot_thetadot2_4_3 = thetadot4 * minus_omega_thetadot2_4_1 + E4_11 *
      minus_omega_dot_thetadot2_3_3;
  // omega_dot_thetadot3_4 = -thetadot4 b4~ E4 b3: its rate
  const T minus_omega_dot_thetadot3_4_1 = thetadot4 * minus_E4_13;
  const T omega_dot_thetadot3_4_3 = thetadot4 * E4_11;
  // P_dot_thetadot1_4 = R3^T (-omega3~ q4~ omega_thetadot1_3 - q4~ omega_dot_thetadot1_3) + P_dot_thetadot1_3: its
  //   rate
  const T t4_1 = T(0.3) * R3_22;
  const T t4_2 = t4_1 - t2_3;
  const T t4_3 = t3_2 + T(0.3) * minus_R3_32;
  const T t4_4 = t3_23 + t3_20 + omega3_2 * t4_2 - omega3_3 * t4_3;
  const T t4_5 = t3_10 + t3_15;
  const T t4_6 = t3_4 - omega3_3 * t4_5 - omega3_1 * t4_2 - T(0.3) * omega_dot_thetadot1_3_3;
  const T t4_7 = T(0.3) * minus_omega_dot_thetadot1_3_2;
  const T t4_8 = omega3_1 * t4_3 - (t4_7 + t2_13) + omega3_2 * t4_5;
  const T minus_P_dot_thetadot1_4_1 = minus_P_dot_thetadot1_3_1 + R2_11 * t4_4 + R3_21 * t4_6 + R3_31 * t4_8;
  const T minus_P_dot_thetadot1_4_2 = minus_P_dot_thetadot1_3_2 + E2_12 * t4_4 + R3_22 * t4_6 - minus_R3_32 * t4_8;
  const T minus_P_dot_thetadot1_4_3 = minus_P_dot_thetadot1_3_3 + R3_23 * t4_6 - minus_R2_13 * t4_4 + R3_33 * t4_8;
  // P_dot_thetadot2_4 = R3^T (-omega3~ q4~ omega_thetadot2_3 - q4~ omega_dot_thetadot2_3) + P_dot_thetadot2_3: its
  //   rate
  const T t4_9 = T(0.3) * E3_22;
  const T t4_10 = T(0.3) * E3_23;
  const T t4_11 = omega3_3 * t4_9 - (t3_37 + t3_35) + omega3_2 * t4_10;
  const T t4_12 = t3_28 - t3_26;
  const T t4_13 = omega3_3 * t4_12 - omega3_1 * t4_10 + T(0.3) * minus_omega_dot_thetadot2_3_3;
  const T t4_14 = T(0.3) * omega_dot_thetadot2_3_2;
  const T t4_15 = t4_14 - omega3_1 * t4_9 - omega3_2 * t4_12;
  const T minus_P_dot_thetadot2_4_1 = minus_P_dot_thetadot2_3_1 + R2_11 * t4_11 + R3_21 * t4_13 + R3_31 * t4_15;
  const T minus_P_dot_thetadot2_4_2 = minus_P_dot_thetadot2_3_2 + E2_12 * t4_11 + R3_22 * t4_13 - minus_R3_32 * t4_15;
  const T minus_P_dot_thetadot2_4_3 = minus_P_dot_thetadot2_3_3 + R3_23 * t4_13 - minus_R2_13 * t4_11 + R3_33 * t4_15;
  // P_dot_thetadot3_4 = -R3^T omega3~ q4~ b3: its rate
  const T t4_16 = t3_40 + omega3_3 * T(0.1);
  const T t4_17 = omega3_1 * T(0.1);
  const T minus_P_dot_thetadot3_4_1 = t3_39 - R2_11 * t4_16 + R3_31 * t4_17;
  const T minus_P_dot_thetadot3_4_2 = t3_43 - E2_12 * t4_16 - minus_R3_32 * t4_17;
  const T minus_P_dot_thetadot3_4_3 = minus_R2_13 * t4_16 + t3_44 + R3_33 * t4_17;
  // B7_1 = -R4^T omega4~ r4~ omega_thetadot1_4 - R4^T r4~ omega_dot_thetadot1_4 + P_dot_thetadot1_4
  const T t4_18 = t3_10 - T(0.2) * R4_12;
  const T t4_19 = R4_32 * T(0.1);
  const T t4_20 = T(0.05) * R4_12 - t4_19;
  const T t4_21 = omega4_2 * t4_18 - omega4_3 * t4_20;
  const T t4_22 = T(0.2) * R4_32;
  const T t4_23 = t4_22 - t3_14;
  const T t4_24 = omega4_3 * t4_23 - omega4_1 * t4_18;
  const T t4_25 = omega4_1 * t4_20 - omega4_2 * t4_23;
  const T t4_26 = T(0.2) * omega_dot_thetadot1_4_3;
  const T t4_27 = t3_19 + t4_26;
  const T t4_28 = T(0.1) * omega_dot_thetadot1_4_3;
  const T t4_29 = T(0.05) * omega_dot_thetadot1_4_1 - t4_28;
  const T t4_30 = t3_23 + T(0.2) * omega_dot_thetadot1_4_1;
  const T minus_B7_1_1 = minus_P_dot_thetadot1_4_1 + R4_11 * t4_21 + R3_21 * t4_24 + R4_31 * t4_25 + R4_11 * t4_27 +
      R3_21 * t4_29 - R4_31 * t4_30;
  const T minus_B7_1_2 = minus_P_dot_thetadot1_4_2 + R4_12 * t4_21 + R3_22 * t4_24 + R4_32 * t4_25 + R4_12 * t4_27 +
      R3_22 * t4_29 - R4_32 * t4_30;
  const T minus_B7_1_3 = minus_P_dot_thetadot1_4_3 + R3_23 * t4_24 - minus_R4_13 * t4_21 + R4_33 * t4_25 + R3_23 *
      t4_29 - minus_R4_13 * t4_27 - R4_33 * t4_30;
  v_y_dot[63] = -minus_B7_1_1;
  v_y_dot[70] = -minus_B7_1_2;
  v_y_dot[77] = -minus_B7_1_3;
  // B8_2 = -R4^T omega4~ r4~ omega_thetadot2_4 - R4^T r4~ omega_dot_thetadot2_4 + P_dot_thetadot2_4
  const T t4_31 = T(0.1) * omega_thetadot2_4_3;
  const T t4_32 = t4_31 + T(0.05) * minus_omega_thetadot2_4_1;
  const T t4_33 = t3_26 + T(0.2) * minus_omega_thetadot2_4_1;
  const T t4_34 = omega4_3 * t4_32 + omega4_2 * t4_33;
  const T t4_35 = T(0.2) * omega_thetadot2_4_3;
  const T t4_36 = t4_35 - t3_29;
  const T t4_37 = omega4_3 * t4_36 - omega4_1 * t4_33;
  const T t4_38 = omega4_1 * t4_32 + omega4_2 * t4_36;
  const T t4_39 = T(0.1) * minus_omega_dot_thetadot2_4_3;
  const T t4_40 = t4_39 + T(0.05) * omega_dot_thetadot2_4_1;
  const T t4_41 = T(0.2) * minus_omega_dot_thetadot2_4_3;
  const T t4_42 = t3_34 + t4_41;
  const T t4_43 = t3_37 - T(0.2) * omega_dot_thetadot2_4_1;
  const T minus_B8_2_1 = minus_P_dot_thetadot2_4_1 + R4_11 * t4_34 + R3_21 * t4_37 - R4_31 * t4_38 + R3_21 * t4_40 -
      R4_11 * t4_42 + R4_31 * t4_43;
  const T minus_B8_2_2 = minus_P_dot_thetadot2_4_2 + R4_12 * t4_34 + R3_22 * t4_37 - R4_32 * t4_38 + R3_22 * t4_40 -
      R4_12 * t4_42 + R4_32 * t4_43;
  const T minus_B8_2_3 = minus_P_dot_thetadot2_4_3 + R3_23 * t4_37 - minus_R4_13 * t4_34 - R4_33 * t4_38 + minus_R4_13
      * t4_42 + R3_23 * t4_40 + R4_33 * t4_43;
  v_y_dot[64] = -minus_B8_2_1;
  v_y_dot[71] = -minus_B8_2_2;
  v_y_dot[78] = -minus_B8_2_3;
  // B9_3 = -R4^T omega4~ r4~ omega_thetadot3_4 - R4^T r4~ omega_dot_thetadot3_4 + P_dot_thetadot3_4
  const T t4_44 = T(0.2) * minus_E4_13;
  const T t4_45 = T(0.2) * E4_11;
  const T t4_46 = omega4_3 * t4_44 + omega4_1 * t4_45;
  const T t4_47 = T(0.1) * minus_E4_13;
  const T t4_48 = T(0.05) * E4_11 - t4_47;
  const T t4_49 = omega4_3 * t4_48 + omega4_2 * t4_45;
  const T t4_50 = omega4_1 * t4_48 - omega4_2 * t4_44;
  const T t4_51 = T(0.2) * omega_dot_thetadot3_4_3;
  const T t4_52 = T(0.1) * omega_dot_thetadot3_4_3;
  const T t4_53 = t4_52 + T(0.05) * minus_omega_dot_thetadot3_4_1;
  const T t4_54 = T(0.2) * minus_omega_dot_thetadot3_4_1;
  const T minus_B9_3_1 = minus_P_dot_thetadot3_4_1 + R3_21 * t4_46 - R4_11 * t4_49 + R4_31 * t4_50 + R4_11 * t4_51 -
      R3_21 * t4_53 + R4_31 * t4_54;
  const T minus_B9_3_2 = minus_P_dot_thetadot3_4_2 + R3_22 * t4_46 - R4_12 * t4_49 + R4_32 * t4_50 + R4_12 * t4_51 -
      R3_22 * t4_53 + R4_32 * t4_54;
  const T minus_B9_3_3 = minus_P_dot_thetadot3_4_3 + minus_R4_13 * t4_49 + R3_23 * t4_46 + R4_33 * t4_50 - minus_R4_13
      * t4_51 - R3_23 * t4_53 + R4_33 * t4_54;
  v_y_dot[65] = -minus_B9_3_1;
  v_y_dot[72] = -minus_B9_3_2;
  v_y_dot[79] = -minus_B9_3_3;
  // B10_4 = -R4^T omega4~ r4~ b4
  const T t4_55 = omega4_2 * T(0.1);
  const T t4_56 = omega4_3 * T(0.05) + omega4_1 * T(0.1);
  const T t4_57 = omega4_2 * T(0.05);
  const T minus_B10_4_1 = R4_11 * t4_55 - R3_21 * t4_56 + R4_31 * t4_57;
  const T minus_B10_4_2 = R4_12 * t4_55 - R3_22 * t4_56 + R4_32 * t4_57;
  const T minus_B10_4_3 = R4_33 * t4_57 - (minus_R4_13 * t4_55 + R3_23 * t4_56);
  v_y_dot[66] = -minus_B10_4_1;
  v_y_dot[73] = -minus_B10_4_2;
  v_y_dot[80] = -minus_B10_4_3;

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
  // omega_dot_thetadot1_5 = -thetadot5 b5~ E5 omega_thetadot1_4 + E5 omega_dot_thetadot1_4: its rate
  const T omega_dot_thetadot1_5_1 = thetadot5 * R5_22 + E5_11 * omega_dot_thetadot1_4_1 - E5_12 *
      minus_omega_dot_thetadot1_3_2;
  const T minus_omega_dot_thetadot1_5_2 = thetadot5 * R5_12 + E5_11 * minus_omega_dot_thetadot1_3_2 + E5_12 *
      omega_dot_thetadot1_4_1;
  // omega_thetadot2_5 = E5 omega_thetadot2_4: partial angular velocity, body axes
  const T omega_thetadot2_5_1 = E5_12 * E3_23 - E5_11 * minus_omega_thetadot2_4_1;
  const T omega_thetadot2_5_2 = E5_11 * E3_23 + E5_12 * minus_omega_thetadot2_4_1;
  // omega_dot_thetadot2_5 = -thetadot5 b5~ E5 omega_thetadot2_4 + E5 omega_dot_thetadot2_4: its rate
  const T omega_dot_thetadot2_5_1 = thetadot5 * omega_thetadot2_5_2 + E5_11 * omega_dot_thetadot2_4_1 + E5_12 *
      omega_dot_thetadot2_3_2;
  const T omega_dot_thetadot2_5_2 = E5_11 * omega_dot_thetadot2_3_2 - E5_12 * omega_dot_thetadot2_4_1 - thetadot5 *
      omega_thetadot2_5_1;
  // omega_thetadot3_5 = E5 omega_thetadot3_4: partial angular velocity, body axes
  const T omega_thetadot3_5_1 = E5_11 * E4_11;
  const T minus_omega_thetadot3_5_2 = E5_12 * E4_11;
  // omega_dot_thetadot3_5 = -thetadot5 b5~ E5 omega_thetadot3_4 + E5 omega_dot_thetadot3_4: its rate
  const T minus_omega_dot_thetadot3_5_1 = thetadot5 * minus_omega_thetadot3_5_2 + E5_11 *
      minus_omega_dot_thetadot3_4_1;
  const T omega_dot_thetadot3_5_2 = E5_12 * minus_omega_dot_thetadot3_4_1 - thetadot5 * omega_thetadot3_5_1;
  // omega_dot_thetadot4_5 = -thetadot5 b5~ E5 b4: its rate
  const T omega_dot_thetadot4_5_1 = thetadot5 * E5_11;
  const T minus_omega_dot_thetadot4_5_2 = thetadot5 * E5_12;
  // P_dot_thetadot1_5 = R4^T (-omega4~ q5~ omega_thetadot1_4 - q5~ omega_dot_thetadot1_4) + P_dot_thetadot1_4: its
  //   rate
  const T t5_1 = t4_1 - T(0.25) * R4_12;
  const T t5_2 = T(0.3) * R4_32;
  const T t5_3 = R4_12 * T(0.1) - t5_2;
  const T t5_4 = t3_23 + omega4_2 * t5_1 - omega4_3 * t5_3 + T(0.25) * omega_dot_thetadot1_4_3;
  const T t5_5 = T(0.25) * R4_32 - t3_10;
  const T t5_6 = T(0.3) * omega_dot_thetadot1_4_3;
  const T t5_7 = omega4_3 * t5_5 - t5_6 - omega4_1 * t5_1 + T(0.1) * omega_dot_thetadot1_4_1;
  const T t5_8 = omega4_1 * t5_3 - t4_7 - omega4_2 * t5_5 - T(0.25) * omega_dot_thetadot1_4_1;
  const T minus_P_dot_thetadot1_5_1 = minus_P_dot_thetadot1_4_1 + R4_11 * t5_4 + R3_21 * t5_7 + R4_31 * t5_8;
  const T minus_P_dot_thetadot1_5_2 = minus_P_dot_thetadot1_4_2 + R4_12 * t5_4 + R3_22 * t5_7 + R4_32 * t5_8;
  const T minus_P_dot_thetadot1_5_3 = minus_P_dot_thetadot1_4_3 + R3_23 * t5_7 - minus_R4_13 * t5_4 + R4_33 * t5_8;
  // P_dot_thetadot2_5 = R4^T (-omega4~ q5~ omega_thetadot2_4 - q5~ omega_dot_thetadot2_4) + P_dot_thetadot2_4: its
  //   rate
  const T t5_9 = T(0.3) * omega_thetadot2_4_3;
  const T t5_10 = t5_9 + T(0.1) * minus_omega_thetadot2_4_1;
  const T t5_11 = t4_10 + T(0.25) * minus_omega_thetadot2_4_1;
  const T t5_12 = omega4_3 * t5_10 - t3_37 + omega4_2 * t5_11 - T(0.25) * minus_omega_dot_thetadot2_4_3;
  const T t5_13 = T(0.3) * minus_omega_dot_thetadot2_4_3;
  const T t5_14 = T(0.25) * omega_thetadot2_4_3 - t3_26;
  const T t5_15 = t5_13 + omega4_3 * t5_14 - omega4_1 * t5_11 + T(0.1) * omega_dot_thetadot2_4_1;
  const T t5_16 = t4_14 - omega4_1 * t5_10 - omega4_2 * t5_14 - T(0.25) * omega_dot_thetadot2_4_1;
  const T minus_P_dot_thetadot2_5_1 = minus_P_dot_thetadot2_4_1 + R4_11 * t5_12 + R3_21 * t5_15 + R4_31 * t5_16;
  const T minus_P_dot_thetadot2_5_2 = minus_P_dot_thetadot2_4_2 + R4_12 * t5_12 + R3_22 * t5_15 + R4_32 * t5_16;
  const T minus_P_dot_thetadot2_5_3 = minus_P_dot_thetadot2_4_3 + R3_23 * t5_15 - minus_R4_13 * t5_12 + R4_33 * t5_16;
  // P_dot_thetadot3_5 = R4^T (-omega4~ q5~ omega_thetadot3_4 - q5~ omega_dot_thetadot3_4) + P_dot_thetadot3_4: its
  //   rate
  const T t5_17 = T(0.3) * minus_E4_13;
  const T t5_18 = T(0.1) * E4_11 - t5_17;
  const T t5_19 = T(0.25) * E4_11;
  const T t5_20 = T(0.25) * omega_dot_thetadot3_4_3 - (omega4_3 * t5_18 + omega4_2 * t5_19);
  const T t5_21 = T(0.25) * minus_E4_13;
  const T t5_22 = T(0.3) * omega_dot_thetadot3_4_3;
  const T t5_23 = omega4_3 * t5_21 - t5_22 + omega4_1 * t5_19 - T(0.1) * minus_omega_dot_thetadot3_4_1;
  const T t5_24 = omega4_1 * t5_18 - omega4_2 * t5_21 + T(0.25) * minus_omega_dot_thetadot3_4_1;
  const T minus_P_dot_thetadot3_5_1 = minus_P_dot_thetadot3_4_1 + R4_11 * t5_20 + R3_21 * t5_23 + R4_31 * t5_24;
  const T minus_P_dot_thetadot3_5_2 = minus_P_dot_thetadot3_4_2 + R4_12 * t5_20 + R3_22 * t5_23 + R4_32 * t5_24;
  const T minus_P_dot_thetadot3_5_3 = minus_P_dot_thetadot3_4_3 + R3_23 * t5_23 - minus_R4_13 * t5_20 + R4_33 * t5_24;
  // P_dot_thetadot4_5 = -R4^T omega4~ q5~ b4: its rate
  const T t5_25 = omega4_2 * T(0.3);
  const T t5_26 = omega4_3 * T(0.1) + omega4_1 * T(0.3);
  const T minus_P_dot_thetadot4_5_1 = R4_11 * t5_25 - R3_21 * t5_26 + R4_31 * t4_55;
  const T minus_P_dot_thetadot4_5_2 = R4_12 * t5_25 - R3_22 * t5_26 + R4_32 * t4_55;
  const T minus_P_dot_thetadot4_5_3 = R4_33 * t4_55 - (minus_R4_13 * t5_25 + R3_23 * t5_26);
  // B11_1 = -R5^T omega5~ r5~ omega_thetadot1_5 - R5^T r5~ omega_dot_thetadot1_5 + P_dot_thetadot1_5
  const T t5_27 = T(0.1) * R5_22;
  const T t5_28 = T(0.2) * R5_12;
  const T t5_29 = t5_27 - t5_28;
  const T t5_30 = T(0.05) * R5_12;
  const T t5_31 = t5_30 - t4_19;
  const T t5_32 = omega5_2 * t5_29 - omega5_3 * t5_31;
  const T t5_33 = t4_22 - T(0.05) * R5_22;
  const T t5_34 = omega5_3 * t5_33 - omega5_1 * t5_29;
  const T t5_35 = omega5_1 * t5_31 - omega5_2 * t5_33;
  const T t5_36 = t4_26 + T(0.05) * minus_omega_dot_thetadot1_5_2;
  const T t5_37 = T(0.05) * omega_dot_thetadot1_5_1;
  const T t5_38 = t5_37 - t4_28;
  const T t5_39 = T(0.1) * minus_omega_dot_thetadot1_5_2;
  const T t5_40 = T(0.2) * omega_dot_thetadot1_5_1;
  const T t5_41 = t5_39 + t5_40;
  const T minus_B11_1_1 = minus_P_dot_thetadot1_5_1 + R5_11 * t5_32 + R5_21 * t5_34 + R4_31 * t5_35 + R5_11 * t5_36 +
      R5_21 * t5_38 - R4_31 * t5_41;
  const T minus_B11_1_2 = minus_P_dot_thetadot1_5_2 + R5_12 * t5_32 + R5_22 * t5_34 + R4_32 * t5_35 + R5_12 * t5_36 +
      R5_22 * t5_38 - R4_32 * t5_41;
  const T minus_B11_1_3 = minus_P_dot_thetadot1_5_3 + R5_13 * t5_32 + R5_23 * t5_34 + R4_33 * t5_35 + R5_13 * t5_36 +
      R5_23 * t5_38 - R4_33 * t5_41;
  v_y_dot[84] = -minus_B11_1_1;
  v_y_dot[91] = -minus_B11_1_2;
  v_y_dot[98] = -minus_B11_1_3;
  // B12_2 = -R5^T omega5~ r5~ omega_thetadot2_5 - R5^T r5~ omega_dot_thetadot2_5 + P_dot_thetadot2_5
  const T t5_42 = T(0.1) * omega_thetadot2_5_2;
  const T t5_43 = T(0.2) * omega_thetadot2_5_1;
  const T t5_44 = t5_42 - t5_43;
  const T t5_45 = T(0.05) * omega_thetadot2_5_1;
  const T t5_46 = t5_45 - t4_31;
  const T t5_47 = omega5_2 * t5_44 - omega5_3 * t5_46;
  const T t5_48 = t4_35 - T(0.05) * omega_thetadot2_5_2;
  const T t5_49 = omega5_3 * t5_48 - omega5_1 * t5_44;
  const T t5_50 = omega5_1 * t5_46 - omega5_2 * t5_48;
  const T t5_51 = T(0.05) * omega_dot_thetadot2_5_1;
  const T t5_52 = t5_51 + t4_39;
  const T t5_53 = t4_41 + T(0.05) * omega_dot_thetadot2_5_2;
  const T t5_54 = T(0.1) * omega_dot_thetadot2_5_2;
  const T t5_55 = T(0.2) * omega_dot_thetadot2_5_1;
  const T t5_56 = t5_54 - t5_55;
  const T minus_B12_2_1 = minus_P_dot_thetadot2_5_1 + R5_11 * t5_47 + R5_21 * t5_49 + R4_31 * t5_50 + R5_21 * t5_52 -
      R5_11 * t5_53 + R4_31 * t5_56;
  const T minus_B12_2_2 = minus_P_dot_thetadot2_5_2 + R5_12 * t5_47 + R5_22 * t5_49 + R4_32 * t5_50 + R5_22 * t5_52 -
      R5_12 * t5_53 + R4_32 * t5_56;
  const T minus_B12_2_3 = minus_P_dot_thetadot2_5_3 + R5_13 * t5_47 + R5_23 * t5_49 + R4_33 * t5_50 + R5_23 * t5_52 -
      R5_13 * t5_53 + R4_33 * t5_56;
  v_y_dot[85] = -minus_B12_2_1;
  v_y_dot[92] = -minus_B12_2_2;
  v_y_dot[99] = -minus_B12_2_3;
  // B13_3 = -R5^T omega5~ r5~ omega_thetadot3_5 - R5^T r5~ omega_dot_thetadot3_5 + P_dot_thetadot3_5
  const T t5_57 = t4_44 + T(0.05) * minus_omega_thetadot3_5_2;
  const T t5_58 = T(0.1) * minus_omega_thetadot3_5_2;
  const T t5_59 = T(0.2) * omega_thetadot3_5_1;
  const T t5_60 = t5_58 + t5_59;
  const T t5_61 = omega5_3 * t5_57 + omega5_1 * t5_60;
  const T t5_62 = T(0.05) * omega_thetadot3_5_1;
  const T t5_63 = t5_62 - t4_47;
  const T t5_64 = omega5_3 * t5_63 + omega5_2 * t5_60;
  const T t5_65 = omega5_1 * t5_63 - omega5_2 * t5_57;
  const T t5_66 = t4_51 - T(0.05) * omega_dot_thetadot3_5_2;
  const T t5_67 = T(0.05) * minus_omega_dot_thetadot3_5_1;
  const T t5_68 = t5_67 + t4_52;
  const T t5_69 = T(0.1) * omega_dot_thetadot3_5_2;
  const T t5_70 = T(0.2) * minus_omega_dot_thetadot3_5_1;
  const T t5_71 = t5_69 + t5_70;
  const T minus_B13_3_1 = minus_P_dot_thetadot3_5_1 + R5_21 * t5_61 - R5_11 * t5_64 + R4_31 * t5_65 + R5_11 * t5_66 -
      R5_21 * t5_68 + R4_31 * t5_71;
  const T minus_B13_3_2 = minus_P_dot_thetadot3_5_2 + R5_22 * t5_61 - R5_12 * t5_64 + R4_32 * t5_65 + R5_12 * t5_66 -
      R5_22 * t5_68 + R4_32 * t5_71;
  const T minus_B13_3_3 = minus_P_dot_thetadot3_5_3 + R5_23 * t5_61 - R5_13 * t5_64 + R4_33 * t5_65 + R5_13 * t5_66 -
      R5_23 * t5_68 + R4_33 * t5_71;
  v_y_dot[86] = -minus_B13_3_1;
  v_y_dot[93] = -minus_B13_3_2;
  v_y_dot[100] = -minus_B13_3_3;
  // B14_4 = -R5^T omega5~ r5~ omega_thetadot4_5 - R5^T r5~ omega_dot_thetadot4_5 + P_dot_thetadot4_5
  const T t5_72 = T(0.1) * E5_11;
  const T t5_73 = T(0.2) * E5_12;
  const T t5_74 = t5_72 - t5_73;
  const T t5_75 = T(0.05) * E5_12;
  const T t5_76 = omega5_2 * t5_74 - omega5_3 * t5_75;
  const T t5_77 = T(0.05) * E5_11;
  const T t5_78 = omega5_3 * t5_77 + omega5_1 * t5_74;
  const T t5_79 = omega5_1 * t5_75 + omega5_2 * t5_77;
  const T t5_80 = T(0.05) * minus_omega_dot_thetadot4_5_2;
  const T t5_81 = T(0.05) * omega_dot_thetadot4_5_1;
  const T t5_82 = T(0.1) * minus_omega_dot_thetadot4_5_2;
  const T t5_83 = T(0.2) * omega_dot_thetadot4_5_1;
  const T t5_84 = t5_82 + t5_83;
  const T minus_B14_4_1 = minus_P_dot_thetadot4_5_1 + R5_11 * t5_76 - R5_21 * t5_78 + R4_31 * t5_79 + R5_11 * t5_80 +
      R5_21 * t5_81 - R4_31 * t5_84;
  const T minus_B14_4_2 = minus_P_dot_thetadot4_5_2 + R5_12 * t5_76 - R5_22 * t5_78 + R4_32 * t5_79 + R5_12 * t5_80 +
      R5_22 * t5_81 - R4_32 * t5_84;
  const T minus_B14_4_3 = minus_P_dot_thetadot4_5_3 + R5_13 * t5_76 - R5_23 * t5_78 + R4_33 * t5_79 + R5_13 * t5_80 +
      R5_23 * t5_81 - R4_33 * t5_84;
  v_y_dot[87] = -minus_B14_4_1;
  v_y_dot[94] = -minus_B14_4_2;
  v_y_dot[101] = -minus_B14_4_3;
  // B15_5 = -R5^T omega5~ r5~ b5
  const T t5_85 = omega5_3 * T(0.1);
  const T t5_86 = omega5_3 * T(0.2);
  const T t5_87 = omega5_1 * T(0.1) + omega5_2 * T(0.2);
  const T minus_B15_5_1 = R5_11 * t5_85 + R5_21 * t5_86 - R4_31 * t5_87;
  const T minus_B15_5_2 = R5_12 * t5_85 + R5_22 * t5_86 - R4_32 * t5_87;
  const T minus_B15_5_3 = R5_13 * t5_85 + R5_23 * t5_86 - R4_33 * t5_87;
  v_y_dot[88] = -minus_B15_5_1;
  v_y_dot[95] = -minus_B15_5_2;
  v_y_dot[102] = -minus_B15_5_3;

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
  // omega_dot_thetadot1_6 = -thetadot6 b6~ E6 omega_thetadot1_5 + E6 omega_dot_thetadot1_5: its rate
  const T omega_dot_thetadot1_6_2 = thetadot6 * R6_32 + E6_23 * omega_dot_thetadot1_4_3 - E6_22 *
      minus_omega_dot_thetadot1_5_2;
  const T omega_dot_thetadot1_6_3 = E6_23 * minus_omega_dot_thetadot1_5_2 + E6_22 * omega_dot_thetadot1_4_3 -
      thetadot6 * R6_22;
  // omega_thetadot2_6 = E6 omega_thetadot2_5: partial angular velocity, body axes
  const T omega_thetadot2_6_2 = E6_22 * omega_thetadot2_5_2 + E6_23 * omega_thetadot2_4_3;
  const T omega_thetadot2_6_3 = E6_22 * omega_thetadot2_4_3 - E6_23 * omega_thetadot2_5_2;
  // omega_dot_thetadot2_6 = -thetadot6 b6~ E6 omega_thetadot2_5 + E6 omega_dot_thetadot2_5: its rate
  const T omega_dot_thetadot2_6_2 = thetadot6 * omega_thetadot2_6_3 + E6_22 * omega_dot_thetadot2_5_2 - E6_23 *
      minus_omega_dot_thetadot2_4_3;
  const T minus_omega_dot_thetadot2_6_3 = thetadot6 * omega_thetadot2_6_2 + E6_23 * omega_dot_thetadot2_5_2 + E6_22 *
      minus_omega_dot_thetadot2_4_3;
  // omega_thetadot3_6 = E6 omega_thetadot3_5: partial angular velocity, body axes
  const T omega_thetadot3_6_2 = E6_23 * minus_E4_13 - E6_22 * minus_omega_thetadot3_5_2;
  const T omega_thetadot3_6_3 = E6_23 * minus_omega_thetadot3_5_2 + E6_22 * minus_E4_13;
  // omega_dot_thetadot3_6 = -thetadot6 b6~ E6 omega_thetadot3_5 + E6 omega_dot_thetadot3_5: its rate
  const T omega_dot_thetadot3_6_2 = thetadot6 * omega_thetadot3_6_3 + E6_22 * omega_dot_thetadot3_5_2 + E6_23 *
      omega_dot_thetadot3_4_3;
  const T omega_dot_thetadot3_6_3 = E6_22 * omega_dot_thetadot3_4_3 - E6_23 * omega_dot_thetadot3_5_2 - thetadot6 *
      omega_thetadot3_6_2;
  // omega_thetadot4_6 = E6 omega_thetadot4_5: partial angular velocity, body axes
  const T omega_thetadot4_6_2 = E6_22 * E5_11;
  const T minus_omega_thetadot4_6_3 = E6_23 * E5_11;
  // omega_dot_thetadot4_6 = -thetadot6 b6~ E6 omega_thetadot4_5 + E6 omega_dot_thetadot4_5: its rate
  const T minus_omega_dot_thetadot4_6_2 = thetadot6 * minus_omega_thetadot4_6_3 + E6_22 *
      minus_omega_dot_thetadot4_5_2;
  const T omega_dot_thetadot4_6_3 = E6_23 * minus_omega_dot_thetadot4_5_2 - thetadot6 * omega_thetadot4_6_2;
  // omega_dot_thetadot5_6 = -thetadot6 b6~ E6 b5: its rate
  const T omega_dot_thetadot5_6_2 = thetadot6 * E6_22;
  const T minus_omega_dot_thetadot5_6_3 = thetadot6 * E6_23;
  // P_dot_thetadot1_6 = R5^T (-omega5~ q6~ omega_thetadot1_5 - q6~ omega_dot_thetadot1_5) + P_dot_thetadot1_5: its
  //   rate
  const T t6_1 = R5_22 * T(0.3) - R5_12 * T(0.3);
  const T t6_2 = R5_12 * T(0.1);
  const T t6_3 = t6_2 - t5_2;
  const T t6_4 = t5_39 + t5_6 + omega5_2 * t6_1 - omega5_3 * t6_3;
  const T t6_5 = T(0.1) * omega_dot_thetadot1_5_1;
  const T t6_6 = t5_2 - t5_27;
  const T t6_7 = t6_5 - t5_6 + omega5_3 * t6_6 - omega5_1 * t6_1;
  const T t6_8 = omega5_1 * t6_3 - omega5_2 * t6_6 - T(0.3) * minus_omega_dot_thetadot1_5_2 - T(0.3) *
      omega_dot_thetadot1_5_1;
  const T minus_P_dot_thetadot1_6_1 = minus_P_dot_thetadot1_5_1 + R5_11 * t6_4 + R5_21 * t6_7 + R4_31 * t6_8;
  const T minus_P_dot_thetadot1_6_2 = minus_P_dot_thetadot1_5_2 + R5_12 * t6_4 + R5_22 * t6_7 + R4_32 * t6_8;
  const T minus_P_dot_thetadot1_6_3 = minus_P_dot_thetadot1_5_3 + R5_13 * t6_4 + R5_23 * t6_7 + R4_33 * t6_8;
  // P_dot_thetadot2_6 = R5^T (-omega5~ q6~ omega_thetadot2_5 - q6~ omega_dot_thetadot2_5) + P_dot_thetadot2_5: its
  //   rate
  const T t6_9 = T(0.3) * omega_thetadot2_5_2 - T(0.3) * omega_thetadot2_5_1;
  const T t6_10 = T(0.1) * omega_thetadot2_5_1;
  const T t6_11 = t6_10 - t5_9;
  const T t6_12 = omega5_2 * t6_9 - (t5_54 + t5_13) - omega5_3 * t6_11;
  const T t6_13 = T(0.1) * omega_dot_thetadot2_5_1;
  const T t6_14 = t5_9 - t5_42;
  const T t6_15 = t6_13 + t5_13 + omega5_3 * t6_14 - omega5_1 * t6_9;
  const T t6_16 = omega5_1 * t6_11 - omega5_2 * t6_14 + T(0.3) * omega_dot_thetadot2_5_2 - T(0.3) *
      omega_dot_thetadot2_5_1;
  const T minus_P_dot_thetadot2_6_1 = minus_P_dot_thetadot2_5_1 + R5_11 * t6_12 + R5_21 * t6_15 + R4_31 * t6_16;
  const T minus_P_dot_thetadot2_6_2 = minus_P_dot_thetadot2_5_2 + R5_12 * t6_12 + R5_22 * t6_15 + R4_32 * t6_16;
  const T minus_P_dot_thetadot2_6_3 = minus_P_dot_thetadot2_5_3 + R5_13 * t6_12 + R5_23 * t6_15 + R4_33 * t6_16;
  // P_dot_thetadot3_6 = R5^T (-omega5~ q6~ omega_thetadot3_5 - q6~ omega_dot_thetadot3_5) + P_dot_thetadot3_5: its
  //   rate
  const T t6_17 = T(0.1) * omega_thetadot3_5_1;
  const T t6_18 = t6_17 - t5_17;
  const T t6_19 = T(0.3) * minus_omega_thetadot3_5_2 + T(0.3) * omega_thetadot3_5_1;
  const T t6_20 = t5_22 - t5_69 - omega5_3 * t6_18 - omega5_2 * t6_19;
  const T t6_21 = t5_58 + t5_17;
  const T t6_22 = T(0.1) * minus_omega_dot_thetadot3_5_1;
  const T t6_23 = omega5_3 * t6_21 - (t6_22 + t5_22) + omega5_1 * t6_19;
  const T t6_24 = omega5_1 * t6_18 - omega5_2 * t6_21 + T(0.3) * omega_dot_thetadot3_5_2 + T(0.3) *
      minus_omega_dot_thetadot3_5_1;
  const T minus_P_dot_thetadot3_6_1 = minus_P_dot_thetadot3_5_1 + R5_11 * t6_20 + R5_21 * t6_23 + R4_31 * t6_24;
  const T minus_P_dot_thetadot3_6_2 = minus_P_dot_thetadot3_5_2 + R5_12 * t6_20 + R5_22 * t6_23 + R4_32 * t6_24;
  const T minus_P_dot_thetadot3_6_3 = minus_P_dot_thetadot3_5_3 + R5_13 * t6_20 + R5_23 * t6_23 + R4_33 * t6_24;
  // P_dot_thetadot4_6 = R5^T (-omega5~ q6~ omega_thetadot4_5 - q6~ omega_dot_thetadot4_5) + P_dot_thetadot4_5: its
  //   rate
  const T t6_25 = T(0.3) * E5_11 - T(0.3) * E5_12;
  const T t6_26 = T(0.1) * E5_12;
  const T t6_27 = t5_82 + omega5_2 * t6_25 - omega5_3 * t6_26;
  const T t6_28 = T(0.1) * omega_dot_thetadot4_5_1;
  const T t6_29 = t6_28 - omega5_3 * t5_72 - omega5_1 * t6_25;
  const T t6_30 = omega5_1 * t6_26 + omega5_2 * t5_72 - T(0.3) * minus_omega_dot_thetadot4_5_2 - T(0.3) *
      omega_dot_thetadot4_5_1;
  const T minus_P_dot_thetadot4_6_1 = minus_P_dot_thetadot4_5_1 + R5_11 * t6_27 + R5_21 * t6_29 + R4_31 * t6_30;
  const T minus_P_dot_thetadot4_6_2 = minus_P_dot_thetadot4_5_2 + R5_12 * t6_27 + R5_22 * t6_29 + R4_32 * t6_30;
  const T minus_P_dot_thetadot4_6_3 = minus_P_dot_thetadot4_5_3 + R5_13 * t6_27 + R5_23 * t6_29 + R4_33 * t6_30;
  // P_dot_thetadot5_6 = -R5^T omega5~ q6~ b5: its rate
  const T t6_31 = omega5_3 * T(0.3);
  const T t6_32 = omega5_1 * T(0.3) + omega5_2 * T(0.3);
  const T minus_P_dot_thetadot5_6_1 = R5_11 * t6_31 + R5_21 * t6_31 - R4_31 * t6_32;
  const T minus_P_dot_thetadot5_6_2 = R5_12 * t6_31 + R5_22 * t6_31 - R4_32 * t6_32;
  const T minus_P_dot_thetadot5_6_3 = R5_13 * t6_31 + R5_23 * t6_31 - R4_33 * t6_32;
  // B16_1 = -R6^T omega6~ r6~ omega_thetadot1_6 - R6^T r6~ omega_dot_thetadot1_6 + P_dot_thetadot1_6
  const T t6_33 = T(0.1) * R6_22;
  const T t6_34 = t6_33 - t5_28;
  const T t6_35 = t5_30 - R6_32 * T(0.1);
  const T t6_36 = omega6_2 * t6_34 - omega6_3 * t6_35;
  const T t6_37 = T(0.05) * R6_22;
  const T t6_38 = T(0.2) * R6_32 - t6_37;
  const T t6_39 = omega6_3 * t6_38 - omega6_1 * t6_34;
  const T t6_40 = omega6_1 * t6_35 - omega6_2 * t6_38;
  const T t6_41 = T(0.05) * omega_dot_thetadot1_6_2;
  const T t6_42 = T(0.2) * omega_dot_thetadot1_6_3 - t6_41;
  const T t6_43 = t5_37 - T(0.1) * omega_dot_thetadot1_6_3;
  const T t6_44 = T(0.1) * omega_dot_thetadot1_6_2;
  const T t6_45 = t6_44 - t5_40;
  const T minus_B16_1_1 = minus_P_dot_thetadot1_6_1 + R5_11 * t6_36 + R6_21 * t6_39 + R6_31 * t6_40 + R5_11 * t6_42 +
      R6_21 * t6_43 + R6_31 * t6_45;
  const T minus_B16_1_2 = minus_P_dot_thetadot1_6_2 + R5_12 * t6_36 + R6_22 * t6_39 + R6_32 * t6_40 + R5_12 * t6_42 +
      R6_22 * t6_43 + R6_32 * t6_45;
  const T minus_B16_1_3 = minus_P_dot_thetadot1_6_3 + R5_13 * t6_36 + R6_23 * t6_39 + R6_33 * t6_40 + R5_13 * t6_42 +
      R6_23 * t6_43 + R6_33 * t6_45;
  v_y_dot[105] = -minus_B16_1_1;
  v_y_dot[112] = -minus_B16_1_2;
  v_y_dot[119] = -minus_B16_1_3;
  // B17_2 = -R6^T omega6~ r6~ omega_thetadot2_6 - R6^T r6~ omega_dot_thetadot2_6 + P_dot_thetadot2_6
  const T t6_46 = T(0.1) * omega_thetadot2_6_2;
  const T t6_47 = t6_46 - t5_43;
  const T t6_48 = t5_45 - T(0.1) * omega_thetadot2_6_3;
  const T t6_49 = omega6_2 * t6_47 - omega6_3 * t6_48;
  const T t6_50 = T(0.05) * omega_thetadot2_6_2;
  const T t6_51 = T(0.2) * omega_thetadot2_6_3 - t6_50;
  const T t6_52 = omega6_3 * t6_51 - omega6_1 * t6_47;
  const T t6_53 = omega6_1 * t6_48 - omega6_2 * t6_51;
  const T t6_54 = t5_51 + T(0.1) * minus_omega_dot_thetadot2_6_3;
  const T t6_55 = T(0.05) * omega_dot_thetadot2_6_2;
  const T t6_56 = t6_55 + T(0.2) * minus_omega_dot_thetadot2_6_3;
  const T t6_57 = T(0.1) * omega_dot_thetadot2_6_2;
  const T t6_58 = t6_57 - t5_55;
  const T minus_B17_2_1 = minus_P_dot_thetadot2_6_1 + R5_11 * t6_49 + R6_21 * t6_52 + R6_31 * t6_53 + R6_21 * t6_54 -
      R5_11 * t6_56 + R6_31 * t6_58;
  const T minus_B17_2_2 = minus_P_dot_thetadot2_6_2 + R5_12 * t6_49 + R6_22 * t6_52 + R6_32 * t6_53 + R6_22 * t6_54 -
      R5_12 * t6_56 + R6_32 * t6_58;
  const T minus_B17_2_3 = minus_P_dot_thetadot2_6_3 + R5_13 * t6_49 + R6_23 * t6_52 + R6_33 * t6_53 + R6_23 * t6_54 -
      R5_13 * t6_56 + R6_33 * t6_58;
  v_y_dot[106] = -minus_B17_2_1;
  v_y_dot[113] = -minus_B17_2_2;
  v_y_dot[120] = -minus_B17_2_3;
  // B18_3 = -R6^T omega6~ r6~ omega_thetadot3_6 - R6^T r6~ omega_dot_thetadot3_6 + P_dot_thetadot3_6
  const T t6_59 = T(0.1) * omega_thetadot3_6_2;
  const T t6_60 = t6_59 - t5_59;
  const T t6_61 = t5_62 - T(0.1) * omega_thetadot3_6_3;
  const T t6_62 = omega6_2 * t6_60 - omega6_3 * t6_61;
  const T t6_63 = T(0.05) * omega_thetadot3_6_2;
  const T t6_64 = T(0.2) * omega_thetadot3_6_3 - t6_63;
  const T t6_65 = omega6_3 * t6_64 - omega6_1 * t6_60;
  const T t6_66 = omega6_1 * t6_61 - omega6_2 * t6_64;
  const T t6_67 = T(0.05) * omega_dot_thetadot3_6_2;
  const T t6_68 = T(0.2) * omega_dot_thetadot3_6_3 - t6_67;
  const T t6_69 = t5_67 + T(0.1) * omega_dot_thetadot3_6_3;
  const T t6_70 = T(0.1) * omega_dot_thetadot3_6_2;
  const T t6_71 = t6_70 + t5_70;
  const T minus_B18_3_1 = minus_P_dot_thetadot3_6_1 + R5_11 * t6_62 + R6_21 * t6_65 + R6_31 * t6_66 + R5_11 * t6_68 -
      R6_21 * t6_69 + R6_31 * t6_71;
  const T minus_B18_3_2 = minus_P_dot_thetadot3_6_2 + R5_12 * t6_62 + R6_22 * t6_65 + R6_32 * t6_66 + R5_12 * t6_68 -
      R6_22 * t6_69 + R6_32 * t6_71;
  const T minus_B18_3_3 = minus_P_dot_thetadot3_6_3 + R5_13 * t6_62 + R6_23 * t6_65 + R6_33 * t6_66 + R5_13 * t6_68 -
      R6_23 * t6_69 + R6_33 * t6_71;
  v_y_dot[107] = -minus_B18_3_1;
  v_y_dot[114] = -minus_B18_3_2;
  v_y_dot[121] = -minus_B18_3_3;
  // B19_4 = -R6^T omega6~ r6~ omega_thetadot4_6 - R6^T r6~ omega_dot_thetadot4_6 + P_dot_thetadot4_6
  const T t6_72 = T(0.1) * omega_thetadot4_6_2;
  const T t6_73 = t6_72 - t5_73;
  const T t6_74 = t5_75 + T(0.1) * minus_omega_thetadot4_6_3;
  const T t6_75 = omega6_2 * t6_73 - omega6_3 * t6_74;
  const T t6_76 = T(0.05) * omega_thetadot4_6_2;
  const T t6_77 = t6_76 + T(0.2) * minus_omega_thetadot4_6_3;
  const T t6_78 = omega6_3 * t6_77 + omega6_1 * t6_73;
  const T t6_79 = omega6_1 * t6_74 + omega6_2 * t6_77;
  const T t6_80 = T(0.05) * minus_omega_dot_thetadot4_6_2;
  const T t6_81 = t6_80 + T(0.2) * omega_dot_thetadot4_6_3;
  const T t6_82 = t5_81 - T(0.1) * omega_dot_thetadot4_6_3;
  const T t6_83 = T(0.1) * minus_omega_dot_thetadot4_6_2;
  const T t6_84 = t6_83 + t5_83;
  const T minus_B19_4_1 = minus_P_dot_thetadot4_6_1 + R5_11 * t6_75 - R6_21 * t6_78 + R6_31 * t6_79 + R5_11 * t6_81 +
      R6_21 * t6_82 - R6_31 * t6_84;
  const T minus_B19_4_2 = minus_P_dot_thetadot4_6_2 + R5_12 * t6_75 - R6_22 * t6_78 + R6_32 * t6_79 + R5_12 * t6_81 +
      R6_22 * t6_82 - R6_32 * t6_84;
  const T minus_B19_4_3 = minus_P_dot_thetadot4_6_3 + R5_13 * t6_75 - R6_23 * t6_78 + R6_33 * t6_79 + R5_13 * t6_81 +
      R6_23 * t6_82 - R6_33 * t6_84;
  v_y_dot[108] = -minus_B19_4_1;
  v_y_dot[115] = -minus_B19_4_2;
  v_y_dot[122] = -minus_B19_4_3;
  // B20_5 = -R6^T omega6~ r6~ omega_thetadot5_6 - R6^T r6~ omega_dot_thetadot5_6 + P_dot_thetadot5_6
  const T t6_85 = T(0.1) * E6_22;
  const T t6_86 = T(0.1) * E6_23;
  const T t6_87 = omega6_3 * t6_85 + omega6_2 * t6_86;
  const T t6_88 = T(0.05) * E6_23;
  const T t6_89 = T(0.2) * E6_22 - t6_88;
  const T t6_90 = omega6_3 * t6_89 - omega6_1 * t6_86;
  const T t6_91 = omega6_1 * t6_85 + omega6_2 * t6_89;
  const T t6_92 = T(0.1) * minus_omega_dot_thetadot5_6_3;
  const T t6_93 = T(0.05) * omega_dot_thetadot5_6_2;
  const T t6_94 = t6_93 + T(0.2) * minus_omega_dot_thetadot5_6_3;
  const T t6_95 = T(0.1) * omega_dot_thetadot5_6_2;
  const T minus_B20_5_1 = minus_P_dot_thetadot5_6_1 + R5_11 * t6_87 + R6_21 * t6_90 - R6_31 * t6_91 + R6_21 * t6_92 -
      R5_11 * t6_94 + R6_31 * t6_95;
  const T minus_B20_5_2 = minus_P_dot_thetadot5_6_2 + R5_12 * t6_87 + R6_22 * t6_90 - R6_32 * t6_91 + R6_22 * t6_92 -
      R5_12 * t6_94 + R6_32 * t6_95;
  const T minus_B20_5_3 = minus_P_dot_thetadot5_6_3 + R5_13 * t6_87 + R6_23 * t6_90 - R6_33 * t6_91 + R6_23 * t6_92 -
      R5_13 * t6_94 + R6_33 * t6_95;
  v_y_dot[109] = -minus_B20_5_1;
  v_y_dot[116] = -minus_B20_5_2;
  v_y_dot[123] = -minus_B20_5_3;
  // B21_6 = -R6^T omega6~ r6~ b6
  const T t6_96 = omega6_1 * T(0.2);
  const T t6_97 = omega6_3 * T(0.05) + omega6_2 * T(0.2);
  const T t6_98 = omega6_1 * T(0.05);
  const T minus_B21_6_1 = R6_21 * t6_96 - R5_11 * t6_97 + R6_31 * t6_98;
  const T minus_B21_6_2 = R6_22 * t6_96 - R5_12 * t6_97 + R6_32 * t6_98;
  const T minus_B21_6_3 = R6_23 * t6_96 - R5_13 * t6_97 + R6_33 * t6_98;
  v_y_dot[110] = -minus_B21_6_1;
  v_y_dot[117] = -minus_B21_6_2;
  v_y_dot[124] = -minus_B21_6_3;

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
  // omega_dot_thetadot1_7 = -thetadot7 b7~ E7 omega_thetadot1_6 + E7 omega_dot_thetadot1_6: its rate
  const T omega_dot_thetadot1_7_1 = E7_11 * omega_dot_thetadot1_5_1 - minus_E7_13 * omega_dot_thetadot1_6_3 -
      thetadot7 * R7_32;
  const T omega_dot_thetadot1_7_3 = thetadot7 * R7_12 + minus_E7_13 * omega_dot_thetadot1_5_1 + E7_11 *
      omega_dot_thetadot1_6_3;
  // omega_thetadot2_7 = E7 omega_thetadot2_6: partial angular velocity, body axes
  const T omega_thetadot2_7_1 = E7_11 * omega_thetadot2_5_1 - minus_E7_13 * omega_thetadot2_6_3;
  const T omega_thetadot2_7_3 = minus_E7_13 * omega_thetadot2_5_1 + E7_11 * omega_thetadot2_6_3;
  // omega_dot_thetadot2_7 = -thetadot7 b7~ E7 omega_thetadot2_6 + E7 omega_dot_thetadot2_6: its rate
  const T omega_dot_thetadot2_7_1 = E7_11 * omega_dot_thetadot2_5_1 + minus_E7_13 * minus_omega_dot_thetadot2_6_3 -
      thetadot7 * omega_thetadot2_7_3;
  const T omega_dot_thetadot2_7_3 = thetadot7 * omega_thetadot2_7_1 + minus_E7_13 * omega_dot_thetadot2_5_1 - E7_11 *
      minus_omega_dot_thetadot2_6_3;
  // omega_thetadot3_7 = E7 omega_thetadot3_6: partial angular velocity, body axes
  const T omega_thetadot3_7_1 = E7_11 * omega_thetadot3_5_1 - minus_E7_13 * omega_thetadot3_6_3;
  const T omega_thetadot3_7_3 = minus_E7_13 * omega_thetadot3_5_1 + E7_11 * omega_thetadot3_6_3;
  // omega_dot_thetadot3_7 = -thetadot7 b7~ E7 omega_thetadot3_6 + E7 omega_dot_thetadot3_6: its rate
  const T minus_omega_dot_thetadot3_7_1 = thetadot7 * omega_thetadot3_7_3 + E7_11 * minus_omega_dot_thetadot3_5_1 +
      minus_E7_13 * omega_dot_thetadot3_6_3;
  const T omega_dot_thetadot3_7_3 = thetadot7 * omega_thetadot3_7_1 + E7_11 * omega_dot_thetadot3_6_3 - minus_E7_13 *
      minus_omega_dot_thetadot3_5_1;
  // omega_thetadot4_7 = E7 omega_thetadot4_6: partial angular velocity, body axes
  const T omega_thetadot4_7_1 = E7_11 * E5_12 + minus_E7_13 * minus_omega_thetadot4_6_3;
  const T omega_thetadot4_7_3 = minus_E7_13 * E5_12 - E7_11 * minus_omega_thetadot4_6_3;
  // omega_dot_thetadot4_7 = -thetadot7 b7~ E7 omega_thetadot4_6 + E7 omega_dot_thetadot4_6: its rate
  const T omega_dot_thetadot4_7_1 = E7_11 * omega_dot_thetadot4_5_1 - minus_E7_13 * omega_dot_thetadot4_6_3 -
      thetadot7 * omega_thetadot4_7_3;
  const T omega_dot_thetadot4_7_3 = thetadot7 * omega_thetadot4_7_1 + minus_E7_13 * omega_dot_thetadot4_5_1 + E7_11 *
      omega_dot_thetadot4_6_3;
  // omega_thetadot5_7 = E7 omega_thetadot5_6: partial angular velocity, body axes
  const T minus_omega_thetadot5_7_1 = minus_E7_13 * E6_22;
  const T omega_thetadot5_7_3 = E7_11 * E6_22;
  // omega_dot_thetadot5_7 = -thetadot7 b7~ E7 omega_thetadot5_6 + E7 omega_dot_thetadot5_6: its rate
  const T omega_dot_thetadot5_7_1 = minus_E7_13 * minus_omega_dot_thetadot5_6_3 - thetadot7 * omega_thetadot5_7_3;
  const T minus_omega_dot_thetadot5_7_3 = thetadot7 * minus_omega_thetadot5_7_1 + E7_11 *
      minus_omega_dot_thetadot5_6_3;
  // omega_dot_thetadot6_7 = -thetadot7 b7~ E7 b6: its rate
  const T minus_omega_dot_thetadot6_7_1 = thetadot7 * minus_E7_13;
  const T omega_dot_thetadot6_7_3 = thetadot7 * E7_11;
  // P_dot_thetadot1_7 = R6^T (-omega6~ q7~ omega_thetadot1_6 - q7~ omega_dot_thetadot1_6) + P_dot_thetadot1_6: its
  //   rate
  const T t7_1 = T(0.3) * R6_22 - T(0.35) * R5_12;
  const T t7_2 = t6_2 - T(0.3) * R6_32;
  const T t7_3 = omega6_2 * t7_1 - t6_44 - omega6_3 * t7_2 + T(0.35) * omega_dot_thetadot1_6_3;
  const T t7_4 = T(0.35) * R6_32 - t6_33;
  const T t7_5 = t6_5 + omega6_3 * t7_4 - omega6_1 * t7_1 - T(0.3) * omega_dot_thetadot1_6_3;
  const T t7_6 = omega6_1 * t7_2 - omega6_2 * t7_4 + T(0.3) * omega_dot_thetadot1_6_2 - T(0.35) *
      omega_dot_thetadot1_5_1;
  const T minus_P_dot_thetadot1_7_1 = minus_P_dot_thetadot1_6_1 + R5_11 * t7_3 + R6_21 * t7_5 + R6_31 * t7_6;
  const T minus_P_dot_thetadot1_7_2 = minus_P_dot_thetadot1_6_2 + R5_12 * t7_3 + R6_22 * t7_5 + R6_32 * t7_6;
  const T minus_P_dot_thetadot1_7_3 = minus_P_dot_thetadot1_6_3 + R5_13 * t7_3 + R6_23 * t7_5 + R6_33 * t7_6;
  // P_dot_thetadot2_7 = R6^T (-omega6~ q7~ omega_thetadot2_6 - q7~ omega_dot_thetadot2_6) + P_dot_thetadot2_6: its
  //   rate
  const T t7_7 = T(0.3) * omega_thetadot2_6_2 - T(0.35) * omega_thetadot2_5_1;
  const T t7_8 = t6_10 - T(0.3) * omega_thetadot2_6_3;
  const T t7_9 = omega6_2 * t7_7 - t6_57 - omega6_3 * t7_8 - T(0.35) * minus_omega_dot_thetadot2_6_3;
  const T t7_10 = T(0.35) * omega_thetadot2_6_3 - t6_46;
  const T t7_11 = t6_13 + omega6_3 * t7_10 - omega6_1 * t7_7 + T(0.3) * minus_omega_dot_thetadot2_6_3;
  const T t7_12 = omega6_1 * t7_8 - omega6_2 * t7_10 + T(0.3) * omega_dot_thetadot2_6_2 - T(0.35) *
      omega_dot_thetadot2_5_1;
  const T minus_P_dot_thetadot2_7_1 = minus_P_dot_thetadot2_6_1 + R5_11 * t7_9 + R6_21 * t7_11 + R6_31 * t7_12;
  const T minus_P_dot_thetadot2_7_2 = minus_P_dot_thetadot2_6_2 + R5_12 * t7_9 + R6_22 * t7_11 + R6_32 * t7_12;
  const T minus_P_dot_thetadot2_7_3 = minus_P_dot_thetadot2_6_3 + R5_13 * t7_9 + R6_23 * t7_11 + R6_33 * t7_12;
  // P_dot_thetadot3_7 = R6^T (-omega6~ q7~ omega_thetadot3_6 - q7~ omega_dot_thetadot3_6) + P_dot_thetadot3_6: its
  //   rate
  const T t7_13 = T(0.3) * omega_thetadot3_6_2 - T(0.35) * omega_thetadot3_5_1;
  const T t7_14 = t6_17 - T(0.3) * omega_thetadot3_6_3;
  const T t7_15 = omega6_2 * t7_13 - t6_70 - omega6_3 * t7_14 + T(0.35) * omega_dot_thetadot3_6_3;
  const T t7_16 = T(0.35) * omega_thetadot3_6_3 - t6_59;
  const T t7_17 = omega6_3 * t7_16 - t6_22 - omega6_1 * t7_13 - T(0.3) * omega_dot_thetadot3_6_3;
  const T t7_18 = omega6_1 * t7_14 - omega6_2 * t7_16 + T(0.3) * omega_dot_thetadot3_6_2 + T(0.35) *
      minus_omega_dot_thetadot3_5_1;
  const T minus_P_dot_thetadot3_7_1 = minus_P_dot_thetadot3_6_1 + R5_11 * t7_15 + R6_21 * t7_17 + R6_31 * t7_18;
  const T minus_P_dot_thetadot3_7_2 = minus_P_dot_thetadot3_6_2 + R5_12 * t7_15 + R6_22 * t7_17 + R6_32 * t7_18;
  const T minus_P_dot_thetadot3_7_3 = minus_P_dot_thetadot3_6_3 + R5_13 * t7_15 + R6_23 * t7_17 + R6_33 * t7_18;
  // P_dot_thetadot4_7 = R6^T (-omega6~ q7~ omega_thetadot4_6 - q7~ omega_dot_thetadot4_6) + P_dot_thetadot4_6: its
  //   rate
  const T t7_19 = T(0.3) * omega_thetadot4_6_2 - T(0.35) * E5_12;
  const T t7_20 = t6_26 + T(0.3) * minus_omega_thetadot4_6_3;
  const T t7_21 = t6_83 + omega6_2 * t7_19 - omega6_3 * t7_20 + T(0.35) * omega_dot_thetadot4_6_3;
  const T t7_22 = t6_72 + T(0.35) * minus_omega_thetadot4_6_3;
  const T t7_23 = t6_28 - omega6_3 * t7_22 - omega6_1 * t7_19 - T(0.3) * omega_dot_thetadot4_6_3;
  const T t7_24 = omega6_1 * t7_20 + omega6_2 * t7_22 - T(0.3) * minus_omega_dot_thetadot4_6_2 - T(0.35) *
      omega_dot_thetadot4_5_1;
  const T minus_P_dot_thetadot4_7_1 = minus_P_dot_thetadot4_6_1 + R5_11 * t7_21 + R6_21 * t7_23 + R6_31 * t7_24;
  const T minus_P_dot_thetadot4_7_2 = minus_P_dot_thetadot4_6_2 + R5_12 * t7_21 + R6_22 * t7_23 + R6_32 * t7_24;
  const T minus_P_dot_thetadot4_7_3 = minus_P_dot_thetadot4_6_3 + R5_13 * t7_21 + R6_23 * t7_23 + R6_33 * t7_24;
  // P_dot_thetadot5_7 = R6^T (-omega6~ q7~ omega_thetadot5_6 - q7~ omega_dot_thetadot5_6) + P_dot_thetadot5_6: its
  //   rate
  const T t7_25 = T(0.3) * E6_22;
  const T t7_26 = T(0.3) * E6_23;
  const T t7_27 = omega6_3 * t7_25 - t6_95 + omega6_2 * t7_26 - T(0.35) * minus_omega_dot_thetadot5_6_3;
  const T t7_28 = T(0.35) * E6_22 - t6_86;
  const T t7_29 = omega6_3 * t7_28 - omega6_1 * t7_26 + T(0.3) * minus_omega_dot_thetadot5_6_3;
  const T t7_30 = T(0.3) * omega_dot_thetadot5_6_2 - (omega6_1 * t7_25 + omega6_2 * t7_28);
  const T minus_P_dot_thetadot5_7_1 = minus_P_dot_thetadot5_6_1 + R5_11 * t7_27 + R6_21 * t7_29 + R6_31 * t7_30;
  const T minus_P_dot_thetadot5_7_2 = minus_P_dot_thetadot5_6_2 + R5_12 * t7_27 + R6_22 * t7_29 + R6_32 * t7_30;
  const T minus_P_dot_thetadot5_7_3 = minus_P_dot_thetadot5_6_3 + R5_13 * t7_27 + R6_23 * t7_29 + R6_33 * t7_30;
  // P_dot_thetadot6_7 = -R6^T omega6~ q7~ b6: its rate
  const T t7_31 = omega6_1 * T(0.35);
  const T t7_32 = omega6_3 * T(0.1) + omega6_2 * T(0.35);
  const T t7_33 = omega6_1 * T(0.1);
  const T minus_P_dot_thetadot6_7_1 = R6_21 * t7_31 - R5_11 * t7_32 + R6_31 * t7_33;
  const T minus_P_dot_thetadot6_7_2 = R6_22 * t7_31 - R5_12 * t7_32 + R6_32 * t7_33;
  const T minus_P_dot_thetadot6_7_3 = R6_23 * t7_31 - R5_13 * t7_32 + R6_33 * t7_33;
  // B22_1 = -R7^T omega7~ r7~ omega_thetadot1_7 - R7^T r7~ omega_dot_thetadot1_7 + P_dot_thetadot1_7
  const T t7_34 = t6_33 - T(0.2) * R7_12;
  const T t7_35 = T(0.05) * R7_12 - T(0.1) * R7_32;
  const T t7_36 = omega7_2 * t7_34 - omega7_3 * t7_35;
  const T t7_37 = T(0.2) * R7_32 - t6_37;
  const T t7_38 = omega7_3 * t7_37 - omega7_1 * t7_34;
  const T t7_39 = omega7_1 * t7_35 - omega7_2 * t7_37;
  const T t7_40 = T(0.2) * omega_dot_thetadot1_7_3 - t6_41;
  const T t7_41 = T(0.05) * omega_dot_thetadot1_7_1 - T(0.1) * omega_dot_thetadot1_7_3;
  const T t7_42 = t6_44 - T(0.2) * omega_dot_thetadot1_7_1;
  const T minus_B22_1_1 = minus_P_dot_thetadot1_7_1 + R7_11 * t7_36 + R6_21 * t7_38 + R7_31 * t7_39 + R7_11 * t7_40 +
      R6_21 * t7_41 + R7_31 * t7_42;
  const T minus_B22_1_2 = minus_P_dot_thetadot1_7_2 + R7_12 * t7_36 + R6_22 * t7_38 + R7_32 * t7_39 + R7_12 * t7_40 +
      R6_22 * t7_41 + R7_32 * t7_42;
  const T minus_B22_1_3 = minus_P_dot_thetadot1_7_3 + R7_13 * t7_36 + R6_23 * t7_38 + R7_33 * t7_39 + R7_13 * t7_40 +
      R6_23 * t7_41 + R7_33 * t7_42;
  v_y_dot[126] = -minus_B22_1_1;
  v_y_dot[133] = -minus_B22_1_2;
  v_y_dot[140] = -minus_B22_1_3;
  // B23_2 = -R7^T omega7~ r7~ omega_thetadot2_7 - R7^T r7~ omega_dot_thetadot2_7 + P_dot_thetadot2_7
  const T t7_43 = t6_46 - T(0.2) * omega_thetadot2_7_1;
  const T t7_44 = T(0.05) * omega_thetadot2_7_1 - T(0.1) * omega_thetadot2_7_3;
  const T t7_45 = omega7_2 * t7_43 - omega7_3 * t7_44;
  const T t7_46 = T(0.2) * omega_thetadot2_7_3 - t6_50;
  const T t7_47 = omega7_3 * t7_46 - omega7_1 * t7_43;
  const T t7_48 = omega7_1 * t7_44 - omega7_2 * t7_46;
  const T t7_49 = T(0.2) * omega_dot_thetadot2_7_3 - t6_55;
  const T t7_50 = T(0.05) * omega_dot_thetadot2_7_1 - T(0.1) * omega_dot_thetadot2_7_3;
  const T t7_51 = t6_57 - T(0.2) * omega_dot_thetadot2_7_1;
  const T minus_B23_2_1 = minus_P_dot_thetadot2_7_1 + R7_11 * t7_45 + R6_21 * t7_47 + R7_31 * t7_48 + R7_11 * t7_49 +
      R6_21 * t7_50 + R7_31 * t7_51;
  const T minus_B23_2_2 = minus_P_dot_thetadot2_7_2 + R7_12 * t7_45 + R6_22 * t7_47 + R7_32 * t7_48 + R7_12 * t7_49 +
      R6_22 * t7_50 + R7_32 * t7_51;
  const T minus_B23_2_3 = minus_P_dot_thetadot2_7_3 + R7_13 * t7_45 + R6_23 * t7_47 + R7_33 * t7_48 + R7_13 * t7_49 +
      R6_23 * t7_50 + R7_33 * t7_51;
  v_y_dot[127] = -minus_B23_2_1;
  v_y_dot[134] = -minus_B23_2_2;
  v_y_dot[141] = -minus_B23_2_3;
  // B24_3 = -R7^T omega7~ r7~ omega_thetadot3_7 - R7^T r7~ omega_dot_thetadot3_7 + P_dot_thetadot3_7
  const T t7_52 = t6_59 - T(0.2) * omega_thetadot3_7_1;
  const T t7_53 = T(0.05) * omega_thetadot3_7_1 - T(0.1) * omega_thetadot3_7_3;
  const T t7_54 = omega7_2 * t7_52 - omega7_3 * t7_53;
  const T t7_55 = T(0.2) * omega_thetadot3_7_3 - t6_63;
  const T t7_56 = omega7_3 * t7_55 - omega7_1 * t7_52;
  const T t7_57 = omega7_1 * t7_53 - omega7_2 * t7_55;
  const T t7_58 = T(0.2) * omega_dot_thetadot3_7_3 - t6_67;
  const T t7_59 = T(0.05) * minus_omega_dot_thetadot3_7_1 + T(0.1) * omega_dot_thetadot3_7_3;
  const T t7_60 = t6_70 + T(0.2) * minus_omega_dot_thetadot3_7_1;
  const T minus_B24_3_1 = minus_P_dot_thetadot3_7_1 + R7_11 * t7_54 + R6_21 * t7_56 + R7_31 * t7_57 + R7_11 * t7_58 -
      R6_21 * t7_59 + R7_31 * t7_60;
  const T minus_B24_3_2 = minus_P_dot_thetadot3_7_2 + R7_12 * t7_54 + R6_22 * t7_56 + R7_32 * t7_57 + R7_12 * t7_58 -
      R6_22 * t7_59 + R7_32 * t7_60;
  const T minus_B24_3_3 = minus_P_dot_thetadot3_7_3 + R7_13 * t7_54 + R6_23 * t7_56 + R7_33 * t7_57 + R7_13 * t7_58 -
      R6_23 * t7_59 + R7_33 * t7_60;
  v_y_dot[128] = -minus_B24_3_1;
  v_y_dot[135] = -minus_B24_3_2;
  v_y_dot[142] = -minus_B24_3_3;
  // B25_4 = -R7^T omega7~ r7~ omega_thetadot4_7 - R7^T r7~ omega_dot_thetadot4_7 + P_dot_thetadot4_7
  const T t7_61 = t6_72 - T(0.2) * omega_thetadot4_7_1;
  const T t7_62 = T(0.05) * omega_thetadot4_7_1 - T(0.1) * omega_thetadot4_7_3;
  const T t7_63 = omega7_2 * t7_61 - omega7_3 * t7_62;
  const T t7_64 = T(0.2) * omega_thetadot4_7_3 - t6_76;
  const T t7_65 = omega7_3 * t7_64 - omega7_1 * t7_61;
  const T t7_66 = omega7_1 * t7_62 - omega7_2 * t7_64;
  const T t7_67 = t6_80 + T(0.2) * omega_dot_thetadot4_7_3;
  const T t7_68 = T(0.05) * omega_dot_thetadot4_7_1 - T(0.1) * omega_dot_thetadot4_7_3;
  const T t7_69 = t6_83 + T(0.2) * omega_dot_thetadot4_7_1;
  const T minus_B25_4_1 = minus_P_dot_thetadot4_7_1 + R7_11 * t7_63 + R6_21 * t7_65 + R7_31 * t7_66 + R7_11 * t7_67 +
      R6_21 * t7_68 - R7_31 * t7_69;
  const T minus_B25_4_2 = minus_P_dot_thetadot4_7_2 + R7_12 * t7_63 + R6_22 * t7_65 + R7_32 * t7_66 + R7_12 * t7_67 +
      R6_22 * t7_68 - R7_32 * t7_69;
  const T minus_B25_4_3 = minus_P_dot_thetadot4_7_3 + R7_13 * t7_63 + R6_23 * t7_65 + R7_33 * t7_66 + R7_13 * t7_67 +
      R6_23 * t7_68 - R7_33 * t7_69;
  v_y_dot[129] = -minus_B25_4_1;
  v_y_dot[136] = -minus_B25_4_2;
  v_y_dot[143] = -minus_B25_4_3;
  // B26_5 = -R7^T omega7~ r7~ omega_thetadot5_7 - R7^T r7~ omega_dot_thetadot5_7 + P_dot_thetadot5_7
  const T t7_70 = T(0.05) * minus_omega_thetadot5_7_1 + T(0.1) * omega_thetadot5_7_3;
  const T t7_71 = t6_86 + T(0.2) * minus_omega_thetadot5_7_1;
  const T t7_72 = omega7_3 * t7_70 + omega7_2 * t7_71;
  const T t7_73 = T(0.2) * omega_thetadot5_7_3 - t6_88;
  const T t7_74 = omega7_3 * t7_73 - omega7_1 * t7_71;
  const T t7_75 = omega7_1 * t7_70 + omega7_2 * t7_73;
  const T t7_76 = T(0.05) * omega_dot_thetadot5_7_1 + T(0.1) * minus_omega_dot_thetadot5_7_3;
  const T t7_77 = t6_93 + T(0.2) * minus_omega_dot_thetadot5_7_3;
  const T t7_78 = t6_95 - T(0.2) * omega_dot_thetadot5_7_1;
  const T minus_B26_5_1 = minus_P_dot_thetadot5_7_1 + R7_11 * t7_72 + R6_21 * t7_74 - R7_31 * t7_75 + R6_21 * t7_76 -
      R7_11 * t7_77 + R7_31 * t7_78;
  const T minus_B26_5_2 = minus_P_dot_thetadot5_7_2 + R7_12 * t7_72 + R6_22 * t7_74 - R7_32 * t7_75 + R6_22 * t7_76 -
      R7_12 * t7_77 + R7_32 * t7_78;
  const T minus_B26_5_3 = minus_P_dot_thetadot5_7_3 + R7_13 * t7_72 + R6_23 * t7_74 - R7_33 * t7_75 + R6_23 * t7_76 -
      R7_13 * t7_77 + R7_33 * t7_78;
  v_y_dot[130] = -minus_B26_5_1;
  v_y_dot[137] = -minus_B26_5_2;
  v_y_dot[144] = -minus_B26_5_3;
  // B27_6 = -R7^T omega7~ r7~ omega_thetadot6_7 - R7^T r7~ omega_dot_thetadot6_7 + P_dot_thetadot6_7
  const T t7_79 = T(0.2) * minus_E7_13;
  const T t7_80 = T(0.2) * E7_11;
  const T t7_81 = omega7_3 * t7_79 + omega7_1 * t7_80;
  const T t7_82 = T(0.05) * E7_11 - T(0.1) * minus_E7_13;
  const T t7_83 = omega7_3 * t7_82 + omega7_2 * t7_80;
  const T t7_84 = omega7_1 * t7_82 - omega7_2 * t7_79;
  const T t7_85 = T(0.2) * omega_dot_thetadot6_7_3;
  const T t7_86 = T(0.05) * minus_omega_dot_thetadot6_7_1 + T(0.1) * omega_dot_thetadot6_7_3;
  const T t7_87 = T(0.2) * minus_omega_dot_thetadot6_7_1;
  const T minus_B27_6_1 = minus_P_dot_thetadot6_7_1 + R6_21 * t7_81 - R7_11 * t7_83 + R7_31 * t7_84 + R7_11 * t7_85 -
      R6_21 * t7_86 + R7_31 * t7_87;
  const T minus_B27_6_2 = minus_P_dot_thetadot6_7_2 + R6_22 * t7_81 - R7_12 * t7_83 + R7_32 * t7_84 + R7_12 * t7_85 -
      R6_22 * t7_86 + R7_32 * t7_87;
  const T minus_B27_6_3 = minus_P_dot_thetadot6_7_3 + R6_23 * t7_81 - R7_13 * t7_83 + R7_33 * t7_84 + R7_13 * t7_85 -
      R6_23 * t7_86 + R7_33 * t7_87;
  v_y_dot[131] = -minus_B27_6_1;
  v_y_dot[138] = -minus_B27_6_2;
  v_y_dot[145] = -minus_B27_6_3;
  // B28_7 = -R7^T omega7~ r7~ b7
  const T t7_88 = omega7_2 * T(0.1);
  const T t7_89 = omega7_3 * T(0.05) + omega7_1 * T(0.1);
  const T t7_90 = omega7_2 * T(0.05);
  const T minus_B28_7_1 = R7_11 * t7_88 - R6_21 * t7_89 + R7_31 * t7_90;
  const T minus_B28_7_2 = R7_12 * t7_88 - R6_22 * t7_89 + R7_32 * t7_90;
  const T minus_B28_7_3 = R7_13 * t7_88 - R6_23 * t7_89 + R7_33 * t7_90;
  v_y_dot[132] = -minus_B28_7_1;
  v_y_dot[139] = -minus_B28_7_2;
  v_y_dot[146] = -minus_B28_7_3;
}

}  // namespace kanec::bench_cr7
