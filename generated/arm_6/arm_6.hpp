// SPDX-License-Identifier: BSD-3-Clause
// arm_6: equations of motion of 7 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 088a79c4f80ff1e9 of arm_6/scene.toml; the usual functions
// bodies and their joints:
//   1 waist on the inertial frame: revolute
//   2 upper_arm on 1: revolute
//   3 forearm on 2: revolute
//   4 wrist on 3: revolute
//   5 hand on 4: revolute
//   6 flange on 5: revolute
//   7 payload on 6: weld
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (theta_1, theta_2, theta_3, theta_4, theta_5, theta_6)
//   y = (thetadot_1, thetadot_2, thetadot_3, thetadot_4, thetadot_5, thetadot_6)
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
//   poses                   132 (49 add, 83 multiply, 12 sine or cosine)
//   energy                  325 (120 add, 205 multiply, 12 sine or cosine)
//   momentum                460 (189 add, 271 multiply, 12 sine or cosine)
//   power                   11 (5 add, 6 multiply)
//   accelerations           623 (283 add, 336 multiply, 4 divide, 10 sine or cosine)
//   residual                379 (183 add, 196 multiply, 10 sine or cosine)
//   forcing                 349 (163 add, 186 multiply, 10 sine or cosine)
//   mass_matrix             153 (68 add, 85 multiply, 8 sine or cosine)
//   partial_velocities      353 (138 add, 215 multiply, 12 sine or cosine)
//   partial_velocity_rates  929 (360 add, 569 multiply, 12 sine or cosine)
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

namespace kanec::arm_6 {

inline constexpr int n_bodies = 7;
inline constexpr int nx = 6;
inline constexpr int ny = 6;
inline constexpr int n_parameters = 1;
inline constexpr int n_inputs = 6;
inline constexpr char model_hash[] = "088a79c4f80ff1e9";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_1 = 0, theta_2 = 1, theta_3 = 2, theta_4 = 3, theta_5 = 4, theta_6 = 5;
inline constexpr int thetadot_1 = 0, thetadot_2 = 1, thetadot_3 = 2, thetadot_4 = 3, thetadot_5 = 4, thetadot_6 = 5;
inline constexpr int theta_waist = 0, theta_upper_arm = 1, theta_forearm = 2, theta_wrist = 3, theta_hand = 4,
    theta_flange = 5;
inline constexpr int thetadot_waist = 0, thetadot_upper_arm = 1, thetadot_forearm = 2, thetadot_wrist = 3,
    thetadot_hand = 4, thetadot_flange = 5;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 32;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 4, 4,
    4, 4, 5, 5, 5, 5, 5};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 5, 0,
    1, 2, 4, 0, 1, 2, 3, 5};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T m_payload = T(1);
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
};

// What depends on parameters only, computed once for many calls.
template <class T>
struct Prepared {
  Parameters<T> p;
  T m_link6;
  T r_link6_3;
  T I_link6_11;
  T c6_1;
  T h_all_5_3;
  T J_all_5_22;
  T J_own_5_11;
  T c5_1;
  T c5_2;
  T J_own_4_22;
  T c4_1;
  T c4_2;
  T c1_1;
  T h_all_3_3;
  T J_all_3_12;
  T J_all_3_13;
  T c1_2;
  T J_all_3_22;
  T J_own_3_11;
  T c3_1;
  T c3_2;
  T h_all_2_1;
  T J_all_2_22;
  T c1_3;
  T J_own_2_11;
  T c2_1;
  T c2_2;
  T J_all_1_33;
  T c4_3;
  T c3_3;
  T c1_4;
  T c1_5;
};

// prepare: 45 add, 35 multiply, 2 divide
template <class T>
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  Prepared<T> c{};
  c.p = p;
  const T m_link6 = T(0.09) + p.m_payload;
  const T t1 = T(1) / m_link6;
  const T r_link6_3 = T(0.09) * t1 * T(0.032) + p.m_payload * t1 * T(0.10650000000000001);
  const T t2 = T(0.032) - r_link6_3;
  const T t3 = T(0.10650000000000001) - r_link6_3;
  const T I_link6_11 = t2 * t2 * T(0.09) + T(0.00015) + t3 * t3 * p.m_payload;
  const T c6_1 = T(0.5) * m_link6;
  const T h_all_5_3 = m_link6 * r_link6_3;
  const T t4 = r_link6_3 * r_link6_3 * m_link6 + I_link6_11;
  const T J_all_5_22 = T(4e-04) + t4;
  const T J_own_5_11 = T(3e-04) + t4 - T(3e-04);
  const T c5_1 = T(0.5) * (J_all_5_22 - J_own_5_11);
  const T c5_2 = T(0.5) * (J_own_5_11 + J_all_5_22);
  const T t5 = T(0.34) + m_link6;
  const T t6 = T(0.14241262419999998) + t5 * T(0.18757560999999998);
  const T t7 = t6 + T(3e-04);
  const T J_own_4_22 = t6 - t7;
  const T c4_1 = T(0.5) * (J_own_4_22 + T(0.0015999999999999999));
  const T c4_2 = T(0.5) * (T(0.0015999999999999999) - J_own_4_22);
  const T t8 = T(0.82) + t5;
  const T c1_1 = t8 * T(0.0203);
  const T t9 = T(0.339562) + t5 * T(0.4331);
  const T h_all_3_3 = T(0.336) + t9;
  const T J_all_3_12 = t8 * T(0.0030470299999999996);
  const T J_all_3_13 = t9 * T(0.0203);
  const T c1_2 = T(0.0551376) + t9 * T(0.1501);
  const T J_all_3_22 = T(0.08952) + t8 * T(0.00041208999999999994) + t7;
  const T t10 = T(0.14175828799999998) + t8 * T(0.0229421);
  const T J_own_3_11 = T(0.218778288) + t8 * T(0.02253001) + t7 - t10;
  const T c3_1 = T(0.5) * (J_all_3_22 - J_own_3_11);
  const T c3_2 = T(0.5) * (J_own_3_11 + J_all_3_22);
  const T t11 = T(4.8) + t8;
  const T h_all_2_1 = T(1.1832) + t11 * T(0.4318);
  const T t12 = t11 * T(0.18645124000000002);
  const T J_all_2_22 = T(0.6200840000000001) + t12;
  const T c1_3 = T(0.269178) + (T(0.7876799999999999) + t8 * T(0.1501)) * T(0.4318);
  const T t13 = T(1.50501635) + t12 + t10;
  const T J_own_2_11 = T(1.0311851499999998) + t10 - t13;
  const T c2_1 = T(0.5) * (J_all_2_22 - J_own_2_11);
  const T c2_2 = T(0.5) * (J_own_2_11 + J_all_2_22);
  const T J_all_1_33 = T(0.35) + t13;
  const T c4_3 = T(4e-05) - J_own_5_11;
  const T c3_3 = T(1) / J_all_5_22;
  const T c1_4 = T(0.5) * (J_all_1_33 - t13);
  const T c1_5 = T(0.5) * (J_all_1_33 + t13);
  c.m_link6 = m_link6;
  c.r_link6_3 = r_link6_3;
  c.I_link6_11 = I_link6_11;
  c.c6_1 = c6_1;
  c.h_all_5_3 = h_all_5_3;
  c.J_all_5_22 = J_all_5_22;
  c.J_own_5_11 = J_own_5_11;
  c.c5_1 = c5_1;
  c.c5_2 = c5_2;
  c.J_own_4_22 = J_own_4_22;
  c.c4_1 = c4_1;
  c.c4_2 = c4_2;
  c.c1_1 = c1_1;
  c.h_all_3_3 = h_all_3_3;
  c.J_all_3_12 = J_all_3_12;
  c.J_all_3_13 = J_all_3_13;
  c.c1_2 = c1_2;
  c.J_all_3_22 = J_all_3_22;
  c.J_own_3_11 = J_own_3_11;
  c.c3_1 = c3_1;
  c.c3_2 = c3_2;
  c.h_all_2_1 = h_all_2_1;
  c.J_all_2_22 = J_all_2_22;
  c.c1_3 = c1_3;
  c.J_own_2_11 = J_own_2_11;
  c.c2_1 = c2_1;
  c.c2_2 = c2_2;
  c.J_all_1_33 = J_all_1_33;
  c.c4_3 = c4_3;
  c.c3_3 = c3_3;
  c.c1_4 = c1_4;
  c.c1_5 = c1_5;
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
  xdot[0] = thetadot1;
  xdot[1] = thetadot2;
  xdot[2] = thetadot3;
  xdot[3] = thetadot4;
  xdot[4] = thetadot5;
  xdot[5] = thetadot6;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 49 add, 83 multiply, 12 sine or cosine
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  for (int i = 0; i < 84; ++i) pose[i] = T(0);
  T cosines[6], sines[6];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 6, cosines, sines);

  // ---- body 1 (waist) on the inertial frame
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];
  pose[0] = E1_11;
  pose[4] = E1_11;
  pose[19] = E1_11;
  pose[31] = E1_11;
  pose[1] = E1_12;
  pose[3] = -E1_12;
  pose[18] = -E1_12;
  pose[30] = -E1_12;

  // ---- body 2 (upper_arm) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  pose[17] = -E2_11;
  pose[14] = -minus_E2_13;
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T R2_12 = E1_12 * E2_11;
  const T R2_31 = E1_11 * minus_E2_13;
  const T R2_32 = E1_12 * minus_E2_13;
  pose[12] = R2_11;
  pose[13] = R2_12;
  pose[15] = -R2_31;
  pose[16] = -R2_32;

  // ---- body 3 (forearm) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T minus_E3_13 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R2_12 * E3_11 - R2_32 * minus_E3_13;
  const T minus_R3_13 = minus_E2_13 * E3_11 + E2_11 * minus_E3_13;
  const T R3_31 = R2_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R2_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = E2_11 * E3_11 - minus_E2_13 * minus_E3_13;
  pose[24] = R3_11;
  pose[25] = R3_12;
  pose[26] = -minus_R3_13;
  pose[27] = -R3_31;
  pose[42] = R3_31;
  pose[28] = -R3_32;
  pose[43] = R3_32;
  pose[29] = -R3_33;
  pose[44] = R3_33;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = R2_11 * T(0.4318) - T(0.1501) * E1_12;
  const T P3_2 = R2_12 * T(0.4318) + T(0.1501) * E1_11;
  const T minus_P3_3 = minus_E2_13 * T(0.4318);

  // ---- body 4 (wrist) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_12 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - E1_12 * E4_12;
  const T R4_12 = R3_12 * E4_11 + E1_11 * E4_12;
  const T minus_R4_13 = minus_R3_13 * E4_11;
  const T minus_R4_21 = E1_12 * E4_11 + R3_11 * E4_12;
  const T R4_22 = E1_11 * E4_11 - R3_12 * E4_12;
  const T R4_23 = minus_R3_13 * E4_12;
  pose[36] = R4_11;
  pose[37] = R4_12;
  pose[38] = -minus_R4_13;
  pose[39] = -minus_R4_21;
  pose[54] = -minus_R4_21;
  pose[40] = R4_22;
  pose[55] = R4_22;
  pose[41] = R4_23;
  pose[56] = R4_23;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = P3_1 + R3_31 * T(0.4331) - R3_11 * T(0.0203);
  const T P4_2 = P3_2 + R3_32 * T(0.4331) - R3_12 * T(0.0203);
  const T P4_3 = minus_R3_13 * T(0.0203) - minus_P3_3 + R3_33 * T(0.4331);
  pose[57] = P4_1;
  pose[58] = P4_2;
  pose[59] = P4_3;
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 - R3_31 * T(0.019);
  const T p4_2 = P4_2 - R3_32 * T(0.019);
  const T p4_3 = P4_3 - R3_33 * T(0.019);
  pose[45] = p4_1;
  pose[46] = p4_2;
  pose[47] = p4_3;

  // ---- body 5 (hand) on body 4
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T minus_E5_13 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - R3_31 * minus_E5_13;
  const T R5_12 = R4_12 * E5_11 - R3_32 * minus_E5_13;
  const T minus_R5_13 = minus_R4_13 * E5_11 + R3_33 * minus_E5_13;
  const T R5_31 = R4_11 * minus_E5_13 + R3_31 * E5_11;
  const T R5_32 = R4_12 * minus_E5_13 + R3_32 * E5_11;
  const T R5_33 = R3_33 * E5_11 - minus_R4_13 * minus_E5_13;
  pose[48] = R5_11;
  pose[49] = R5_12;
  pose[50] = -minus_R5_13;
  pose[51] = -R5_31;
  pose[66] = R5_31;
  pose[78] = R5_31;
  pose[52] = -R5_32;
  pose[67] = R5_32;
  pose[79] = R5_32;
  pose[53] = -R5_33;
  pose[68] = R5_33;
  pose[80] = R5_33;

  // ---- body 6 (flange) on body 5
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T E6_12 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - minus_R4_21 * E6_12;
  const T R6_12 = R5_12 * E6_11 + R4_22 * E6_12;
  const T R6_13 = R4_23 * E6_12 - minus_R5_13 * E6_11;
  const T minus_R6_21 = minus_R4_21 * E6_11 + R5_11 * E6_12;
  const T R6_22 = R4_22 * E6_11 - R5_12 * E6_12;
  const T R6_23 = R4_23 * E6_11 + minus_R5_13 * E6_12;
  pose[60] = R6_11;
  pose[72] = R6_11;
  pose[61] = R6_12;
  pose[73] = R6_12;
  pose[62] = R6_13;
  pose[74] = R6_13;
  pose[63] = -minus_R6_21;
  pose[75] = -minus_R6_21;
  pose[64] = R6_22;
  pose[76] = R6_22;
  pose[65] = R6_23;
  pose[77] = R6_23;

  // ---- results
  pose[8] = T(1);
  pose[21] = R2_11 * T(0.068) - T(0.22749999999999998) * E1_12 - R2_31 * T(0.006);
  pose[22] = R2_12 * T(0.068) + T(0.22749999999999998) * E1_11 - R2_32 * T(0.006);
  pose[23] = -(minus_E2_13 * T(0.068) + E2_11 * T(0.006));
  pose[33] = P3_1 + R3_31 * T(0.07) - E1_12 * T(0.014);
  pose[34] = P3_2 + E1_11 * T(0.014) + R3_32 * T(0.07);
  pose[35] = R3_33 * T(0.07) - minus_P3_3;
  pose[69] = P4_1 + R5_31 * T(0.032);
  pose[70] = P4_2 + R5_32 * T(0.032);
  pose[71] = P4_3 + R5_33 * T(0.032);
  pose[81] = P4_1 + T(0.10650000000000001) * R5_31;
  pose[82] = P4_2 + T(0.10650000000000001) * R5_32;
  pose[83] = P4_3 + T(0.10650000000000001) * R5_33;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 120 add, 205 multiply, 12 sine or cosine
template <class T>
void energy(const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  T cosines[6], sines[6];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 6, cosines, sines);

  // ---- body 1 (waist) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];
  // T1 = 1/2 omega1 . (I1 omega1): kinetic energy [J]
  const T T1 = T(0.35) * thetadot1 * thetadot1 * T(0.5);

  // ---- body 2 (upper_arm) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T R2_12 = E1_12 * E2_11;
  const T R2_31 = E1_11 * minus_E2_13;
  const T R2_32 = E1_12 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T minus_omega2_1 = minus_E2_13 * thetadot1;
  const T omega2_3 = E2_11 * thetadot1;
  // p2 = R2^T r_link2 + P2: position of the mass centre, inertial axes [m]
  const T minus_p2_3 = minus_E2_13 * T(0.068) + E2_11 * T(0.006);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_1 = thetadot1 * T(0.2435);
  const T minus_Pdot2_1 = E1_11 * t2_1;
  const T minus_Pdot2_2 = E1_12 * t2_1;
  // v2 = R2^T omega2~ r_link2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_2 = omega2_3 * T(0.016) - thetadot2 * T(0.006);
  const T t2_3 = omega2_3 * T(0.068) - minus_omega2_1 * T(0.006);
  const T t2_4 = minus_omega2_1 * T(0.016) - thetadot2 * T(0.068);
  const T v2_1 = R2_11 * t2_2 - minus_Pdot2_1 - E1_12 * t2_3 + R2_31 * t2_4;
  const T v2_2 = R2_12 * t2_2 - minus_Pdot2_2 + E1_11 * t2_3 + R2_32 * t2_4;
  const T v2_3 = E2_11 * t2_4 - minus_E2_13 * t2_2;
  // T2 = 1/2 omega2 . (I_link2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (T(0.13) * minus_omega2_1 * minus_omega2_1 + T(0.539) * thetadot2 * thetadot2 + T(0.524) *
      omega2_3 * omega2_3) + T(8.7) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (forearm) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T minus_E3_13 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R2_12 * E3_11 - R2_32 * minus_E3_13;
  const T minus_R3_13 = minus_E2_13 * E3_11 + E2_11 * minus_E3_13;
  const T R3_31 = R2_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R2_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = E2_11 * E3_11 - minus_E2_13 * minus_E3_13;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T minus_omega3_1 = E3_11 * minus_omega2_1 + minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + thetadot2;
  const T omega3_3 = E3_11 * omega2_3 - minus_E3_13 * minus_omega2_1;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T minus_P3_3 = minus_E2_13 * T(0.4318);
  // p3 = R3^T r_link3 + P3: position of the mass centre, inertial axes [m]
  const T p3_3 = R3_33 * T(0.07) - minus_P3_3;
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_1 = omega2_3 * T(0.0934);
  const T t3_2 = omega2_3 * T(0.4318);
  const T t3_3 = minus_omega2_1 * T(0.0934) - thetadot2 * T(0.4318);
  const T Pdot3_1 = R2_11 * t3_1 - minus_Pdot2_1 - E1_12 * t3_2 + R2_31 * t3_3;
  const T Pdot3_2 = R2_12 * t3_1 - minus_Pdot2_2 + E1_11 * t3_2 + R2_32 * t3_3;
  const T Pdot3_3 = E2_11 * t3_3 - minus_E2_13 * t3_1;
  // v3 = R3^T omega3~ r_link3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_4 = omega3_2 * T(0.07) - omega3_3 * T(0.014);
  const T t3_5 = minus_omega3_1 * T(0.07);
  const T t3_6 = minus_omega3_1 * T(0.014);
  const T v3_1 = Pdot3_1 + R3_11 * t3_4 - E1_12 * t3_5 - R3_31 * t3_6;
  const T v3_2 = Pdot3_2 + R3_12 * t3_4 + E1_11 * t3_5 - R3_32 * t3_6;
  const T v3_3 = Pdot3_3 - minus_R3_13 * t3_4 - R3_33 * t3_6;
  // T3 = 1/2 omega3 . (I_link3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (T(0.066) * minus_omega3_1 * minus_omega3_1 + T(0.066) * omega3_2 * omega3_2 + T(0.0125) *
      omega3_3 * omega3_3) + T(2.4) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (wrist) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_12 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - E1_12 * E4_12;
  const T R4_12 = R3_12 * E4_11 + E1_11 * E4_12;
  const T minus_R4_13 = minus_R3_13 * E4_11;
  const T minus_R4_21 = E1_12 * E4_11 + R3_11 * E4_12;
  const T R4_22 = E1_11 * E4_11 - R3_12 * E4_12;
  const T R4_23 = minus_R3_13 * E4_12;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega3_2 - E4_11 * minus_omega3_1;
  const T omega4_2 = E4_11 * omega3_2 + E4_12 * minus_omega3_1;
  const T omega4_3 = thetadot4 + omega3_3;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_3 = minus_R3_13 * T(0.0203) - minus_P3_3 + R3_33 * T(0.4331);
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_3 = P4_3 - R3_33 * T(0.019);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_1 = omega3_2 * T(0.4331);
  const T t4_2 = minus_omega3_1 * T(0.4331) - omega3_3 * T(0.0203);
  const T t4_3 = omega3_2 * T(0.0203);
  const T Pdot4_1 = Pdot3_1 + R3_11 * t4_1 - E1_12 * t4_2 + R3_31 * t4_3;
  const T Pdot4_2 = Pdot3_2 + R3_12 * t4_1 + E1_11 * t4_2 + R3_32 * t4_3;
  const T Pdot4_3 = Pdot3_3 + R3_33 * t4_3 - minus_R3_13 * t4_1;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_4 = omega4_2 * T(0.019);
  const T t4_5 = omega4_1 * T(0.019);
  const T v4_1 = Pdot4_1 - R4_11 * t4_4 - minus_R4_21 * t4_5;
  const T v4_2 = Pdot4_2 + R4_22 * t4_5 - R4_12 * t4_4;
  const T v4_3 = Pdot4_3 + minus_R4_13 * t4_4 + R4_23 * t4_5;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (T(0.0018) * omega4_1 * omega4_1 + T(0.0018) * omega4_2 * omega4_2 + T(0.0013) * omega4_3 *
      omega4_3) + T(0.41) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (hand) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T minus_E5_13 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - R3_31 * minus_E5_13;
  const T R5_12 = R4_12 * E5_11 - R3_32 * minus_E5_13;
  const T minus_R5_13 = minus_R4_13 * E5_11 + R3_33 * minus_E5_13;
  const T R5_33 = R3_33 * E5_11 - minus_R4_13 * minus_E5_13;
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 - minus_E5_13 * omega4_3;
  const T omega5_2 = thetadot5 + omega4_2;
  const T omega5_3 = minus_E5_13 * omega4_1 + E5_11 * omega4_3;
  // T5 = 1/2 omega5 . (I_link5 omega5) + 1/2 m5 Pdot4 . Pdot4: kinetic energy [J]
  const T T5 = T(0.5) * (T(3e-04) * omega5_1 * omega5_1 + T(4e-04) * omega5_2 * omega5_2 + T(3e-04) * omega5_3 *
      omega5_3) + T(0.17) * (Pdot4_1 * Pdot4_1 + Pdot4_2 * Pdot4_2 + Pdot4_3 * Pdot4_3);

  // ---- body 6 (flange) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T E6_12 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - minus_R4_21 * E6_12;
  const T R6_12 = R5_12 * E6_11 + R4_22 * E6_12;
  const T R6_13 = R4_23 * E6_12 - minus_R5_13 * E6_11;
  const T minus_R6_21 = minus_R4_21 * E6_11 + R5_11 * E6_12;
  const T R6_22 = R4_22 * E6_11 - R5_12 * E6_12;
  const T R6_23 = R4_23 * E6_11 + minus_R5_13 * E6_12;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 + E6_12 * omega5_2;
  const T omega6_2 = E6_11 * omega5_2 - E6_12 * omega5_1;
  const T omega6_3 = thetadot6 + omega5_3;
  // p6 = R6^T r_link6 + P4: position of the mass centre, inertial axes [m]
  const T p6_3 = P4_3 + R5_33 * c.r_link6_3;
  // v6 = R6^T omega6~ r_link6 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t6_1 = omega6_2 * c.r_link6_3;
  const T t6_2 = omega6_1 * c.r_link6_3;
  const T v6_1 = Pdot4_1 + R6_11 * t6_1 + minus_R6_21 * t6_2;
  const T v6_2 = Pdot4_2 + R6_12 * t6_1 - R6_22 * t6_2;
  const T v6_3 = Pdot4_3 + R6_13 * t6_1 - R6_23 * t6_2;
  // T6 = 1/2 omega6 . (I_link6 omega6) + 1/2 m_link6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (c.I_link6_11 * omega6_1 * omega6_1 + c.I_link6_11 * omega6_2 * omega6_2 + T(4e-05) * omega6_3
      * omega6_3) + c.c6_1 * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6: kinetic energy of the system [J]
  const T kinetic = T2 + T3 + T4 + T5 + T6 + T1;
  energy[0] = kinetic;
  // mp = m2 p2 + m3 p3 + m4 p4 + m5 P4 + m_link6 p6: first moment of mass, inertial axes [kg m]
  const T mp_3 = T(4.8) * p3_3 - T(17.4) * minus_p2_3 + T(0.82) * p4_3 + T(0.34) * P4_3 + c.m_link6 * p6_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 189 add, 271 multiply, 12 sine or cosine
template <class T>
void momentum(const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {
  T cosines[6], sines[6];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 6, cosines, sines);

  // ---- body 1 (waist) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];
  // H1 = E1^T I1 omega1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T H1_3 = T(0.35) * thetadot1;

  // ---- body 2 (upper_arm) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T R2_12 = E1_12 * E2_11;
  const T R2_31 = E1_11 * minus_E2_13;
  const T R2_32 = E1_12 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T minus_omega2_1 = minus_E2_13 * thetadot1;
  const T omega2_3 = E2_11 * thetadot1;
  // p2 = R2^T r_link2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = R2_11 * T(0.068) - T(0.22749999999999998) * E1_12 - R2_31 * T(0.006);
  const T p2_2 = R2_12 * T(0.068) + T(0.22749999999999998) * E1_11 - R2_32 * T(0.006);
  const T minus_p2_3 = minus_E2_13 * T(0.068) + E2_11 * T(0.006);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_1 = thetadot1 * T(0.2435);
  const T minus_Pdot2_1 = E1_11 * t2_1;
  const T minus_Pdot2_2 = E1_12 * t2_1;
  // v2 = R2^T omega2~ r_link2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_2 = omega2_3 * T(0.016) - thetadot2 * T(0.006);
  const T t2_3 = omega2_3 * T(0.068) - minus_omega2_1 * T(0.006);
  const T t2_4 = minus_omega2_1 * T(0.016) - thetadot2 * T(0.068);
  const T v2_1 = R2_11 * t2_2 - minus_Pdot2_1 - E1_12 * t2_3 + R2_31 * t2_4;
  const T v2_2 = R2_12 * t2_2 - minus_Pdot2_2 + E1_11 * t2_3 + R2_32 * t2_4;
  const T v2_3 = E2_11 * t2_4 - minus_E2_13 * t2_2;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(17.4) * v2_1;
  const T l2_2 = T(17.4) * v2_2;
  const T l2_3 = T(17.4) * v2_3;
  // H2 = R2^T I_link2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_5 = T(0.524) * omega2_3;
  const T t2_6 = T(0.13) * minus_omega2_1;
  const T t2_7 = T(0.539) * thetadot2;
  const T H2_1 = R2_31 * t2_5 - (R2_11 * t2_6 + E1_12 * t2_7) + minus_p2_3 * l2_2 + p2_2 * l2_3;
  const T H2_2 = E1_11 * t2_7 - R2_12 * t2_6 + R2_32 * t2_5 - minus_p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = minus_E2_13 * t2_6 + E2_11 * t2_5 + p2_1 * l2_2 - p2_2 * l2_1;

  // ---- body 3 (forearm) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T minus_E3_13 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R2_12 * E3_11 - R2_32 * minus_E3_13;
  const T minus_R3_13 = minus_E2_13 * E3_11 + E2_11 * minus_E3_13;
  const T R3_31 = R2_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R2_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = E2_11 * E3_11 - minus_E2_13 * minus_E3_13;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T minus_omega3_1 = E3_11 * minus_omega2_1 + minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + thetadot2;
  const T omega3_3 = E3_11 * omega2_3 - minus_E3_13 * minus_omega2_1;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = R2_11 * T(0.4318) - T(0.1501) * E1_12;
  const T P3_2 = R2_12 * T(0.4318) + T(0.1501) * E1_11;
  const T minus_P3_3 = minus_E2_13 * T(0.4318);
  // p3 = R3^T r_link3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 + R3_31 * T(0.07) - E1_12 * T(0.014);
  const T p3_2 = P3_2 + E1_11 * T(0.014) + R3_32 * T(0.07);
  const T p3_3 = R3_33 * T(0.07) - minus_P3_3;
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_1 = omega2_3 * T(0.0934);
  const T t3_2 = omega2_3 * T(0.4318);
  const T t3_3 = minus_omega2_1 * T(0.0934) - thetadot2 * T(0.4318);
  const T Pdot3_1 = R2_11 * t3_1 - minus_Pdot2_1 - E1_12 * t3_2 + R2_31 * t3_3;
  const T Pdot3_2 = R2_12 * t3_1 - minus_Pdot2_2 + E1_11 * t3_2 + R2_32 * t3_3;
  const T Pdot3_3 = E2_11 * t3_3 - minus_E2_13 * t3_1;
  // v3 = R3^T omega3~ r_link3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_4 = omega3_2 * T(0.07) - omega3_3 * T(0.014);
  const T t3_5 = minus_omega3_1 * T(0.07);
  const T t3_6 = minus_omega3_1 * T(0.014);
  const T v3_1 = Pdot3_1 + R3_11 * t3_4 - E1_12 * t3_5 - R3_31 * t3_6;
  const T v3_2 = Pdot3_2 + R3_12 * t3_4 + E1_11 * t3_5 - R3_32 * t3_6;
  const T v3_3 = Pdot3_3 - minus_R3_13 * t3_4 - R3_33 * t3_6;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(4.8) * v3_1;
  const T l3_2 = T(4.8) * v3_2;
  const T l3_3 = T(4.8) * v3_3;
  // H3 = R3^T I_link3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_7 = T(0.0125) * omega3_3;
  const T t3_8 = T(0.066) * minus_omega3_1;
  const T t3_9 = T(0.066) * omega3_2;
  const T H3_1 = R3_31 * t3_7 - (R3_11 * t3_8 + E1_12 * t3_9) + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = E1_11 * t3_9 - R3_12 * t3_8 + R3_32 * t3_7 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = minus_R3_13 * t3_8 + R3_33 * t3_7 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (wrist) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_12 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - E1_12 * E4_12;
  const T R4_12 = R3_12 * E4_11 + E1_11 * E4_12;
  const T minus_R4_13 = minus_R3_13 * E4_11;
  const T minus_R4_21 = E1_12 * E4_11 + R3_11 * E4_12;
  const T R4_22 = E1_11 * E4_11 - R3_12 * E4_12;
  const T R4_23 = minus_R3_13 * E4_12;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega3_2 - E4_11 * minus_omega3_1;
  const T omega4_2 = E4_11 * omega3_2 + E4_12 * minus_omega3_1;
  const T omega4_3 = thetadot4 + omega3_3;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = P3_1 + R3_31 * T(0.4331) - R3_11 * T(0.0203);
  const T P4_2 = P3_2 + R3_32 * T(0.4331) - R3_12 * T(0.0203);
  const T P4_3 = minus_R3_13 * T(0.0203) - minus_P3_3 + R3_33 * T(0.4331);
  // p4 = R4^T r4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 - R3_31 * T(0.019);
  const T p4_2 = P4_2 - R3_32 * T(0.019);
  const T p4_3 = P4_3 - R3_33 * T(0.019);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_1 = omega3_2 * T(0.4331);
  const T t4_2 = minus_omega3_1 * T(0.4331) - omega3_3 * T(0.0203);
  const T t4_3 = omega3_2 * T(0.0203);
  const T Pdot4_1 = Pdot3_1 + R3_11 * t4_1 - E1_12 * t4_2 + R3_31 * t4_3;
  const T Pdot4_2 = Pdot3_2 + R3_12 * t4_1 + E1_11 * t4_2 + R3_32 * t4_3;
  const T Pdot4_3 = Pdot3_3 + R3_33 * t4_3 - minus_R3_13 * t4_1;
  // v4 = R4^T omega4~ r4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_4 = omega4_2 * T(0.019);
  const T t4_5 = omega4_1 * T(0.019);
  const T v4_1 = Pdot4_1 - R4_11 * t4_4 - minus_R4_21 * t4_5;
  const T v4_2 = Pdot4_2 + R4_22 * t4_5 - R4_12 * t4_4;
  const T v4_3 = Pdot4_3 + minus_R4_13 * t4_4 + R4_23 * t4_5;
  // l4 = m4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(0.82) * v4_1;
  const T l4_2 = T(0.82) * v4_2;
  const T l4_3 = T(0.82) * v4_3;
  // H4 = R4^T I4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_6 = T(0.0018) * omega4_1;
  const T t4_7 = T(0.0018) * omega4_2;
  const T t4_8 = T(0.0013) * omega4_3;
  const T H4_1 = R4_11 * t4_6 - minus_R4_21 * t4_7 + R3_31 * t4_8 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_6 + R4_22 * t4_7 + R3_32 * t4_8 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R4_23 * t4_7 - minus_R4_13 * t4_6 + R3_33 * t4_8 + p4_1 * l4_2 - p4_2 * l4_1;

  // ---- body 5 (hand) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T minus_E5_13 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - R3_31 * minus_E5_13;
  const T R5_12 = R4_12 * E5_11 - R3_32 * minus_E5_13;
  const T minus_R5_13 = minus_R4_13 * E5_11 + R3_33 * minus_E5_13;
  const T R5_31 = R4_11 * minus_E5_13 + R3_31 * E5_11;
  const T R5_32 = R4_12 * minus_E5_13 + R3_32 * E5_11;
  const T R5_33 = R3_33 * E5_11 - minus_R4_13 * minus_E5_13;
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 - minus_E5_13 * omega4_3;
  const T omega5_2 = thetadot5 + omega4_2;
  const T omega5_3 = minus_E5_13 * omega4_1 + E5_11 * omega4_3;
  // l5 = m5 Pdot4: linear momentum, inertial axes [kg m/s]
  const T l5_1 = T(0.34) * Pdot4_1;
  const T l5_2 = T(0.34) * Pdot4_2;
  const T l5_3 = T(0.34) * Pdot4_3;
  // H5 = R5^T I_link5 omega5 + P4~ l5: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t5_1 = T(3e-04) * omega5_1;
  const T t5_2 = T(4e-04) * omega5_2;
  const T t5_3 = T(3e-04) * omega5_3;
  const T H5_1 = R5_11 * t5_1 - minus_R4_21 * t5_2 + R5_31 * t5_3 + P4_2 * l5_3 - P4_3 * l5_2;
  const T H5_2 = R5_12 * t5_1 + R4_22 * t5_2 + R5_32 * t5_3 + P4_3 * l5_1 - P4_1 * l5_3;
  const T H5_3 = R4_23 * t5_2 - minus_R5_13 * t5_1 + R5_33 * t5_3 + P4_1 * l5_2 - P4_2 * l5_1;

  // ---- body 6 (flange) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T E6_12 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - minus_R4_21 * E6_12;
  const T R6_12 = R5_12 * E6_11 + R4_22 * E6_12;
  const T R6_13 = R4_23 * E6_12 - minus_R5_13 * E6_11;
  const T minus_R6_21 = minus_R4_21 * E6_11 + R5_11 * E6_12;
  const T R6_22 = R4_22 * E6_11 - R5_12 * E6_12;
  const T R6_23 = R4_23 * E6_11 + minus_R5_13 * E6_12;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 + E6_12 * omega5_2;
  const T omega6_2 = E6_11 * omega5_2 - E6_12 * omega5_1;
  const T omega6_3 = thetadot6 + omega5_3;
  // p6 = R6^T r_link6 + P4: position of the mass centre, inertial axes [m]
  const T p6_1 = P4_1 + R5_31 * c.r_link6_3;
  const T p6_2 = P4_2 + R5_32 * c.r_link6_3;
  const T p6_3 = P4_3 + R5_33 * c.r_link6_3;
  // v6 = R6^T omega6~ r_link6 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t6_1 = omega6_2 * c.r_link6_3;
  const T t6_2 = omega6_1 * c.r_link6_3;
  const T v6_1 = Pdot4_1 + R6_11 * t6_1 + minus_R6_21 * t6_2;
  const T v6_2 = Pdot4_2 + R6_12 * t6_1 - R6_22 * t6_2;
  const T v6_3 = Pdot4_3 + R6_13 * t6_1 - R6_23 * t6_2;
  // l6 = m_link6 v6: linear momentum, inertial axes [kg m/s]
  const T l6_1 = c.m_link6 * v6_1;
  const T l6_2 = c.m_link6 * v6_2;
  const T l6_3 = c.m_link6 * v6_3;
  // H6 = R6^T I_link6 omega6 + p6~ l6: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t6_3 = c.I_link6_11 * omega6_1;
  const T t6_4 = c.I_link6_11 * omega6_2;
  const T t6_5 = T(4e-05) * omega6_3;
  const T H6_1 = R6_11 * t6_3 - minus_R6_21 * t6_4 + R5_31 * t6_5 + p6_2 * l6_3 - p6_3 * l6_2;
  const T H6_2 = R6_12 * t6_3 + R6_22 * t6_4 + R5_32 * t6_5 + p6_3 * l6_1 - p6_1 * l6_3;
  const T H6_3 = R6_13 * t6_3 + R6_23 * t6_4 + R5_33 * t6_5 + p6_1 * l6_2 - p6_2 * l6_1;

  // ---- whole system
  // linear = l2 + l3 + l4 + l5 + l6: linear momentum of the system [kg m/s]
  const T linear_1 = l2_1 + l3_1 + l4_1 + l5_1 + l6_1;
  const T linear_2 = l2_2 + l3_2 + l4_2 + l5_2 + l6_2;
  const T linear_3 = l2_3 + l3_3 + l4_3 + l5_3 + l6_3;
  momentum[0] = linear_1;
  momentum[1] = linear_2;
  momentum[2] = linear_3;
  // angular = H1 + H2 + H3 + H4 + H5 + H6: angular momentum of the system about the inertial origin [kg m^2/s]
  const T angular_1 = H2_1 + H3_1 + H4_1 + H5_1 + H6_1;
  const T angular_2 = H2_2 + H3_2 + H4_2 + H5_2 + H6_2;
  const T angular_3 = H2_3 + H3_3 + H4_3 + H5_3 + H6_3 + H1_3;
  momentum[3] = angular_1;
  momentum[4] = angular_2;
  momentum[5] = angular_3;
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 5 add, 6 multiply
template <class T>
void power([[maybe_unused]] const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, const Inputs<T>& u, T* out)
    noexcept {

  // ---- body 1 (waist) on the inertial frame
  const T thetadot1 = y[0];
  const T thetadot2 = y[1];
  const T thetadot3 = y[2];
  const T thetadot4 = y[3];
  const T thetadot5 = y[4];
  const T thetadot6 = y[5];
  // power = thetadot1 tau_waist_ + thetadot2 tau_upper_arm_ + thetadot3 tau_forearm_ + thetadot4 tau_wrist_ +
  //   thetadot5 tau_hand_ + thetadot6 tau_flange_: power of the applied loads [W]
  const T power = thetadot1 * u.tau_1 + thetadot2 * u.tau_2 + thetadot3 * u.tau_3 + thetadot4 * u.tau_4 + thetadot5 *
      u.tau_5 + thetadot6 * u.tau_6;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 283 add, 336 multiply, 4 divide, 10 sine or cosine
// by: composite; articulated would take 294 add, 354 multiply, 4 divide, 10 sine or cosine
template <class T>
void accelerations(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot) noexcept {
  T cosines[6], sines[6];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 5, cosines + 1, sines + 1);

  // ---- body 2 (upper_arm) on body 1
  const T thetadot1 = y[0];
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T minus_omega2_1 = minus_E2_13 * thetadot1;
  const T omega2_3 = E2_11 * thetadot1;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot2_1 = thetadot2 * omega2_3;
  const T minus_omegadot2_3 = thetadot2 * minus_omega2_1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_3 * omega2_3;
  const T t2_2 = thetadot2 * thetadot2;
  const T minus_U2_11 = t2_1 + t2_2;
  const T minus_U2_13 = omega2_3 * minus_omega2_1;
  const T minus_U2_21 = minus_omegadot2_3 + minus_omegadot2_3;
  const T t2_3 = minus_omega2_1 * minus_omega2_1;
  const T minus_U2_22 = t2_1 + t2_3;
  const T U2_23 = minus_omegadot2_1 + minus_omegadot2_1;
  const T minus_U2_33 = t2_2 + t2_3;
  // Pddot2 = E2 Pddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = minus_E2_13 * T(9.81);
  const T Pddot2_3 = E2_11 * T(9.81);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N2_1 = c.c2_2 * U2_23 + T(0.023750999999999998) * (minus_U2_22 - minus_U2_33) + c.c1_3 * minus_U2_13 +
      T(0.0070992) * minus_U2_21;
  const T minus_N2_2 = T(0.10439999999999999) * minus_Pddot2_1 - c.h_all_2_1 * Pddot2_3 + c.c2_1 * minus_U2_13 -
      c.c2_2 * minus_U2_13 - T(0.0070992) * (minus_U2_33 - minus_U2_11);
  const T minus_N2_3 = c.c1_3 * (minus_U2_11 - minus_U2_22) - c.c2_1 * minus_U2_21 - T(0.0070992) * U2_23 -
      T(0.023750999999999998) * minus_U2_13;

  // ---- body 3 (forearm) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T minus_E3_13 = sines[2];
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T minus_omega3_1 = E3_11 * minus_omega2_1 + minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + thetadot2;
  const T omega3_3 = E3_11 * omega2_3 - minus_E3_13 * minus_omega2_1;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = minus_E3_13 * minus_omegadot2_3 - E3_11 * minus_omegadot2_1 - thetadot3 * omega3_3;
  const T minus_omegadot3_3 = thetadot3 * minus_omega3_1 + minus_E3_13 * minus_omegadot2_1 + E3_11 *
      minus_omegadot2_3;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_3 * omega3_3;
  const T t3_2 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_1 + t3_2;
  const T t3_3 = omega3_2 * minus_omega3_1;
  const T U3_12 = minus_omegadot3_3 - t3_3;
  const T minus_U3_13 = omega3_3 * minus_omega3_1;
  const T minus_U3_21 = t3_3 + minus_omegadot3_3;
  const T t3_4 = minus_omega3_1 * minus_omega3_1;
  const T minus_U3_22 = t3_1 + t3_4;
  const T t3_5 = omega3_3 * omega3_2;
  const T U3_23 = t3_5 - omegadot3_1;
  const T U3_32 = t3_5 + omegadot3_1;
  const T minus_U3_33 = t3_2 + t3_4;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_6 = minus_Pddot2_1 + minus_U2_11 * T(0.4318);
  const T t3_7 = Pddot2_3 - minus_U2_13 * T(0.4318);
  const T minus_Pddot3_1 = E3_11 * t3_6 + minus_E3_13 * t3_7;
  const T minus_Pddot3_2 = minus_U2_21 * T(0.4318);
  const T Pddot3_3 = E3_11 * t3_7 - minus_E3_13 * t3_6;
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = minus_U3_11 * c.c1_1 - minus_U3_13 * c.h_all_3_3;
  const T minus_G3_2 = minus_U3_21 * c.c1_1 + U3_23 * c.h_all_3_3;
  const T minus_G3_3 = minus_U3_13 * c.c1_1 - minus_U3_33 * c.h_all_3_3;
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = c.h_all_3_3 * minus_Pddot3_2 - c.c3_1 * U3_32 - c.c3_2 * U3_23 + c.c1_2 * (minus_U3_22 -
      minus_U3_33) + c.J_all_3_12 * minus_U3_13 - c.J_all_3_13 * minus_U3_21;
  const T minus_N3_2 = c.c1_1 * Pddot3_3 - c.h_all_3_3 * minus_Pddot3_1 + c.c3_1 * minus_U3_13 - c.c3_2 * minus_U3_13
      - c.J_all_3_13 * (minus_U3_33 - minus_U3_11) + c.c1_2 * U3_12 + c.J_all_3_12 * U3_32;
  const T minus_N3_3 = c.c1_1 * minus_Pddot3_2 - c.c3_1 * minus_U3_21 + c.c3_1 * U3_12 - c.J_all_3_12 * (minus_U3_11 -
      minus_U3_22) - c.J_all_3_13 * U3_23 + c.c1_2 * minus_U3_13;

  // ---- body 4 (wrist) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_12 = sines[3];
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega3_2 - E4_11 * minus_omega3_1;
  const T omega4_2 = E4_11 * omega3_2 + E4_12 * minus_omega3_1;
  const T omega4_3 = thetadot4 + omega3_3;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = thetadot4 * omega4_2 + E4_11 * omegadot3_1;
  const T minus_omegadot4_2 = thetadot4 * omega4_1 + E4_12 * omegadot3_1;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_1 = omega4_2 * omega4_1;
  const T U4_12 = t4_1 + minus_omegadot3_3;
  const T t4_2 = omega4_3 * omega4_1;
  const T U4_13 = t4_2 - minus_omegadot4_2;
  const T U4_21 = t4_1 - minus_omegadot3_3;
  const T t4_3 = omega4_3 * omega4_2;
  const T U4_23 = t4_3 - omegadot4_1;
  const T U4_31 = t4_2 + minus_omegadot4_2;
  const T U4_32 = t4_3 + omegadot4_1;
  const T minus_U4_33 = omega4_2 * omega4_2 + omega4_1 * omega4_1;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_4 = minus_U3_11 * T(0.0203) - minus_Pddot3_1 + U3_12 * T(0.1501);
  const T t4_5 = minus_U3_21 * T(0.0203) - minus_Pddot3_2 - minus_U3_22 * T(0.1501);
  const T Pddot4_1 = E4_11 * t4_4 + E4_12 * t4_5;
  const T Pddot4_2 = E4_11 * t4_5 - E4_12 * t4_4;
  const T Pddot4_3 = Pddot3_3 + minus_U3_13 * T(0.0203) + U3_32 * T(0.1501);
  // N4 = -h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N4_1 = c.c4_2 * U4_32 + c.c4_2 * U4_23;
  const T N4_2 = c.c4_2 * U4_13 + c.c4_1 * U4_31;
  const T minus_N4_3 = c.c4_1 * U4_21 - c.c4_2 * U4_12;

  // ---- body 5 (hand) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T minus_E5_13 = sines[4];
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 - minus_E5_13 * omega4_3;
  const T omega5_2 = thetadot5 + omega4_2;
  const T omega5_3 = minus_E5_13 * omega4_1 + E5_11 * omega4_3;
  // omegadot5 = -thetadot5 b5~ E5 omega4 + E5 omegadot4: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = E5_11 * omegadot4_1 + minus_E5_13 * minus_omegadot3_3 - thetadot5 * omega5_3;
  const T omegadot5_3 = thetadot5 * omega5_1 + minus_E5_13 * omegadot4_1 - E5_11 * minus_omegadot3_3;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_1 = omega5_2 * omega5_1;
  const T U5_12 = t5_1 - omegadot5_3;
  const T t5_2 = omega5_3 * omega5_1;
  const T U5_13 = t5_2 - minus_omegadot4_2;
  const T U5_21 = t5_1 + omegadot5_3;
  const T t5_3 = omega5_3 * omega5_2;
  const T U5_23 = t5_3 - omegadot5_1;
  const T U5_31 = t5_2 + minus_omegadot4_2;
  const T U5_32 = t5_3 + omegadot5_1;
  const T minus_U5_33 = omega5_2 * omega5_2 + omega5_1 * omega5_1;
  // Pddot5 = E5 (U4 q5 + Pddot4): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_1 = E5_11 * (Pddot4_1 + U4_13 * T(0.4331)) - minus_E5_13 * (Pddot4_3 - minus_U4_33 * T(0.4331));
  const T Pddot5_2 = Pddot4_2 + U4_23 * T(0.4331);
  // G5 = -U5 h_own_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = U5_13 * c.h_all_5_3;
  const T minus_G5_2 = U5_23 * c.h_all_5_3;
  const T G5_3 = minus_U5_33 * c.h_all_5_3;
  // N5 = -h_own_5~ Pddot5 - axial(U5 (tr(J_own_5)/2 - J_own_5)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N5_1 = c.c5_1 * U5_32 + c.c5_2 * U5_23 + c.h_all_5_3 * Pddot5_2;
  const T minus_N5_2 = c.h_all_5_3 * Pddot5_1 + c.c5_2 * U5_13 - c.c5_1 * U5_31;
  const T minus_N5_3 = c.c5_1 * U5_21 + c.c5_1 * U5_12;

  // ---- body 6 (flange) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T E6_12 = sines[5];
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 + E6_12 * omega5_2;
  const T omega6_2 = E6_11 * omega5_2 - E6_12 * omega5_1;
  const T omega6_3 = thetadot6 + omega5_3;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_1 = thetadot6 * omega6_2 + E6_11 * omegadot5_1 - E6_12 * minus_omegadot4_2;
  const T minus_omegadot6_2 = thetadot6 * omega6_1 + E6_11 * minus_omegadot4_2 + E6_12 * omegadot5_1;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_2 * omega6_1;
  const T U6_12 = t6_1 - omegadot5_3;
  const T t6_2 = omega6_3 * omega6_1;
  const T U6_13 = t6_2 - minus_omegadot6_2;
  const T U6_21 = t6_1 + omegadot5_3;
  const T t6_3 = omega6_3 * omega6_2;
  const T U6_23 = t6_3 - omegadot6_1;
  const T U6_31 = t6_2 + minus_omegadot6_2;
  const T U6_32 = t6_3 + omegadot6_1;
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(2e-05) * U6_32 + T(2e-05) * U6_23;
  const T N6_2 = T(2e-05) * U6_13 + T(2e-05) * U6_31;
  const T minus_N6_3 = T(2e-05) * U6_21 - T(2e-05) * U6_12;

  // ---- body 5 (hand) and what it carries
  // rho5 = E6^T N6 + N5: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5_1 = N5_1 - E6_12 * N6_2 - E6_11 * minus_N6_1;
  const T minus_rho5_2 = minus_N5_2 + E6_12 * minus_N6_1 - E6_11 * N6_2;
  const T minus_rho5_3 = minus_N6_3 + minus_N5_3;
  // hc5 = E5^T h5: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc5_1 = minus_E5_13 * c.h_all_5_3;
  const T hc5_3 = E5_11 * c.h_all_5_3;

  // ---- body 4 (wrist) and what it carries
  // S4 = E5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T S4_1 = minus_E5_13 * G5_3 - E5_11 * minus_G5_1;
  const T S4_3 = minus_E5_13 * minus_G5_1 + E5_11 * G5_3;
  // rho4 = q5~ E5^T S5 + E5^T rho5 + N4: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho4_1 = T(0.4331) * minus_G5_2 - minus_N4_1 + E5_11 * rho5_1 - minus_E5_13 * minus_rho5_3;
  const T rho4_2 = N4_2 - minus_rho5_2 + T(0.4331) * S4_1;
  const T minus_rho4_3 = minus_N4_3 + minus_E5_13 * rho5_1 + E5_11 * minus_rho5_3;
  // J4 = -q5~ hc5~ + E5^T J5 E5 + J_own_4 - hc5~ q5~: inertia carried, about the body origin, body axes [kg m^2]
  const T b4_1 = minus_E5_13 * c.c4_3;
  const T b4_2 = minus_E5_13 * b4_1;
  const T J4_11 = c.J_own_5_11 + b4_2 + T(0.8662) * hc5_3;
  const T J4_13 = E5_11 * b4_1 - T(0.4331) * hc5_1;
  const T b4_3 = T(0.4331) * hc5_3;
  const T b4_4 = b4_3 + c.J_all_5_22;
  const T J4_22 = b4_4 + c.J_own_4_22 + b4_3;
  const T J4_33 = T(0.00164) - b4_2;
  // hc4 = E4^T h4: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4_1 = E4_11 * hc5_1;
  const T hc4_2 = E4_12 * hc5_1;
  // K_thetadot6_4 = q5~ E5^T B_thetadot6_5 + E5^T K_thetadot6_5
  const T K_thetadot6_4_1 = minus_E5_13 * T(4e-05);
  const T K_thetadot6_4_3 = E5_11 * T(4e-05);
  // D_thetaddot4: pivots of L D L^T
  const T b4_5 = K_thetadot6_4_3 * T(24999.999999999996);
  const T D_thetaddot4 = J4_33 - b4_5 * K_thetadot6_4_3;

  // ---- body 3 (forearm) and what it carries
  // S3 = E4^T S4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = E4_11 * S4_1 + E4_12 * minus_G5_2;
  const T S3_1 = b3_1 - minus_G3_1;
  const T b3_2 = E4_12 * S4_1 - E4_11 * minus_G5_2;
  const T S3_2 = b3_2 - minus_G3_2;
  const T S3_3 = S4_3 - minus_G3_3;
  // rho3 = q4~ E4^T S4 + E4^T rho4 + N3: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho3_1 = T(0.1501) * S4_3 - minus_N3_1 + E4_11 * rho4_1 - E4_12 * rho4_2;
  const T rho3_2 = T(0.0203) * S4_3 - minus_N3_2 + E4_12 * rho4_1 + E4_11 * rho4_2;
  const T minus_rho3_3 = minus_rho4_3 + minus_N3_3 + T(0.0203) * b3_2 + T(0.1501) * b3_1;
  // h3 = h_own_3 + hc4: first moment of mass carried, about the body origin, body axes [kg m]
  const T h3_1 = hc4_1 - c.c1_1;
  const T h3_3 = c.h_all_3_3 + hc5_3;
  // J3 = -q4~ hc4~ + E4^T J4 E4 + J_own_3 - hc4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b3_3 = E4_12 * (J4_11 - J4_22);
  const T b3_4 = E4_12 * b3_3;
  const T J3_11 = J4_11 - b3_4 + c.J_own_3_11 + T(0.3002) * hc4_2;
  const T J3_12 = c.J_all_3_12 + E4_11 * b3_3 - T(0.1501) * hc4_1 + T(0.0203) * hc4_2;
  const T b3_5 = E4_11 * J4_13;
  const T J3_13 = b3_5 + c.J_all_3_13 + T(0.0203) * hc5_3;
  const T J3_22 = J4_22 + b3_4 + c.J_all_3_22 - T(0.0406) * hc4_1;
  const T b3_6 = E4_12 * J4_13;
  const T J3_23 = b3_6 - c.c1_2 - T(0.1501) * hc5_3;
  const T b3_7 = T(0.1501) * hc4_2 - T(0.0203) * hc4_1;
  const T b3_8 = b3_7 + J4_33;
  const T J3_33 = b3_8 + b3_7;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc3_1 = minus_E3_13 * h3_3 + E3_11 * h3_1;
  const T hc3_3 = E3_11 * h3_3 - minus_E3_13 * h3_1;
  // K_thetadot6_3 = q4~ E4^T B_thetadot6_4 + E4^T K_thetadot6_4
  const T K_thetadot6_3_1 = E4_11 * K_thetadot6_4_1;
  const T K_thetadot6_3_2 = E4_12 * K_thetadot6_4_1;
  // B_thetadot5_3 = E4^T B_thetadot5_4
  const T B_thetadot5_3_1 = E4_11 * hc5_3;
  const T B_thetadot5_3_2 = E4_12 * hc5_3;
  // K_thetadot5_3 = q4~ E4^T B_thetadot5_4 + E4^T K_thetadot5_4
  const T minus_K_thetadot5_3_1 = T(0.1501) * hc5_1 + E4_12 * b4_4;
  const T K_thetadot5_3_2 = E4_11 * b4_4 - T(0.0203) * hc5_1;
  const T minus_K_thetadot5_3_3 = T(0.0203) * B_thetadot5_3_2 + T(0.1501) * B_thetadot5_3_1;
  // D_thetaddot3: pivots of L D L^T
  const T b3_9 = K_thetadot6_3_2 * T(24999.999999999996);
  const T b3_10 = b3_9 * K_thetadot6_3_2;
  const T b3_11 = K_thetadot5_3_2 * c.c3_3;
  const T b3_12 = b3_9 * K_thetadot6_4_3;
  const T b3_13 = b3_6 - b3_12;
  const T b3_14 = T(1) / D_thetaddot4;
  const T b3_15 = b3_13 * b3_14;
  const T D_thetaddot3 = J3_22 - b3_10 - b3_11 * K_thetadot5_3_2 - b3_15 * b3_13;

  // ---- body 2 (upper_arm) and what it carries
  // rho2 = q3~ E3^T S3 + E3^T rho3 + N2: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho2_1 = N2_1 + E3_11 * rho3_1 - minus_E3_13 * minus_rho3_3;
  const T rho2_2 = rho3_2 - minus_N2_2 - T(0.4318) * (E3_11 * S3_3 - minus_E3_13 * S3_1);
  const T rho2_3 = T(0.4318) * S3_2 - (minus_N2_3 + minus_E3_13 * rho3_1 + E3_11 * minus_rho3_3);
  // J2 = -q3~ hc3~ + E3^T J3 E3 + J_own_2 - hc3~ q3~: inertia carried, about the body origin, body axes [kg m^2]
  const T b2_1 = minus_E3_13 * (J3_33 - J3_11) + T(2) * E3_11 * J3_13;
  const T b2_2 = minus_E3_13 * b2_1;
  const T J2_11 = J3_11 + b2_2 + c.J_own_2_11;
  const T b2_3 = E3_11 * J3_12 + minus_E3_13 * J3_23;
  const T J2_12 = b2_3 - c.c1_3 - T(0.4318) * hc4_2;
  const T J2_13 = T(0.0070992) - J3_13 + E3_11 * b2_1 - T(0.4318) * hc3_3;
  const T b2_4 = T(0.4318) * hc3_1;
  const T b2_5 = b2_4 + J3_22;
  const T J2_22 = b2_5 + c.J_all_2_22 + b2_4;
  const T b2_6 = E3_11 * J3_23 - minus_E3_13 * J3_12;
  const T J2_23 = b2_6 + T(0.023750999999999998);
  const T J2_33 = J3_33 - b2_2 + T(0.8636) * hc3_1;
  // K_thetadot6_2 = q3~ E3^T B_thetadot6_3 + E3^T K_thetadot6_3
  const T K_thetadot6_2_1 = E3_11 * K_thetadot6_3_1 + minus_E3_13 * K_thetadot6_4_3;
  const T K_thetadot6_2_3 = E3_11 * K_thetadot6_4_3 - minus_E3_13 * K_thetadot6_3_1;
  // K_thetadot5_2 = q3~ E3^T B_thetadot5_3 + E3^T K_thetadot5_3
  const T minus_K_thetadot5_2_1 = minus_E3_13 * minus_K_thetadot5_3_3 + E3_11 * minus_K_thetadot5_3_1;
  const T K_thetadot5_2_2 = K_thetadot5_3_2 + T(0.4318) * (minus_E3_13 * B_thetadot5_3_1 + E3_11 * hc5_1);
  const T K_thetadot5_2_3 = T(0.4318) * B_thetadot5_3_2 + minus_E3_13 * minus_K_thetadot5_3_1 - E3_11 *
      minus_K_thetadot5_3_3;
  // K_thetadot4_2 = q3~ E3^T B_thetadot4_3 + E3^T K_thetadot4_3
  const T K_thetadot4_2_1 = E3_11 * b3_5 + minus_E3_13 * b3_8;
  const T K_thetadot4_2_2 = b3_6 - minus_E3_13 * hc4_2 * T(0.4318);
  const T K_thetadot4_2_3 = T(0.4318) * hc4_1 + E3_11 * b3_8 - minus_E3_13 * b3_5;
  // D_thetaddot2: pivots of L D L^T
  const T b2_7 = K_thetadot5_2_2 * c.c3_3;
  const T b2_8 = K_thetadot4_2_2 - b3_12;
  const T b2_9 = b2_8 * b3_14;
  const T b2_10 = b2_5 - b3_10 - b2_7 * K_thetadot5_3_2 - b2_9 * b3_13;
  const T b2_11 = T(1) / D_thetaddot3;
  const T b2_12 = b2_10 * b2_11;
  const T D_thetaddot2 = J2_22 - b3_10 - b2_7 * K_thetadot5_2_2 - b2_9 * b2_8 - b2_12 * b2_10;

  // ---- body 1 (waist) and what it carries
  // rho1 = E2^T rho2 + N1: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho1_3 = E2_11 * rho2_3 - minus_E2_13 * rho2_1;
  // J1 = E2^T J2 E2 + J_own_1: inertia carried, about the body origin, body axes [kg m^2]
  const T J1_23 = E2_11 * J2_23 - minus_E2_13 * J2_12;
  const T J1_33 = J2_33 + c.J_all_1_33 - minus_E2_13 * (minus_E2_13 * (J2_33 - J2_11) + T(2) * E2_11 * J2_13);
  // K_thetadot6_1 = E2^T K_thetadot6_2
  const T K_thetadot6_1_3 = E2_11 * K_thetadot6_2_3 - minus_E2_13 * K_thetadot6_2_1;
  // K_thetadot5_1 = E2^T K_thetadot5_2
  const T K_thetadot5_1_3 = E2_11 * K_thetadot5_2_3 + minus_E2_13 * minus_K_thetadot5_2_1;
  // K_thetadot4_1 = E2^T K_thetadot4_2
  const T K_thetadot4_1_3 = E2_11 * K_thetadot4_2_3 - minus_E2_13 * K_thetadot4_2_1;
  // K_thetadot3_1 = E2^T K_thetadot3_2
  const T K_thetadot3_1_3 = E2_11 * b2_6 - minus_E2_13 * b2_3;
  // D_thetaddot1: pivots of L D L^T
  const T b1_1 = K_thetadot6_1_3 * T(24999.999999999996);
  const T b1_2 = K_thetadot5_1_3 * c.c3_3;
  const T b1_3 = K_thetadot4_1_3 - b1_1 * K_thetadot6_4_3;
  const T b1_4 = b1_3 * b3_14;
  const T b1_5 = b1_1 * K_thetadot6_3_2;
  const T b1_6 = K_thetadot3_1_3 - b1_5 - b1_2 * K_thetadot5_3_2 - b1_4 * b3_13;
  const T b1_7 = b1_6 * b2_11;
  const T b1_8 = J1_23 - b1_5 - b1_2 * K_thetadot5_2_2 - b1_4 * b2_8 - b1_7 * b2_10;
  const T b1_9 = T(1) / D_thetaddot2;
  const T b1_10 = b1_8 * b1_9;
  const T D_thetaddot1 = J1_33 - b1_1 * K_thetadot6_1_3 - b1_2 * K_thetadot5_1_3 - b1_4 * b1_3 - b1_7 * b1_6 - b1_10 *
      b1_8;

  // ---- body 1 (waist), solved
  // thetaddot1: from A ydot = f by elimination
  const T z1_1 = u.tau_6 - minus_N6_3;
  const T z1_2 = u.tau_5 - minus_rho5_2;
  const T z1_3 = u.tau_4 - minus_rho4_3 - b4_5 * z1_1;
  const T z1_4 = b3_9 * z1_1;
  const T z1_5 = rho3_2 + u.tau_3 - z1_4 - b3_11 * z1_2 - b3_15 * z1_3;
  const T z1_6 = rho2_2 + u.tau_2 - z1_4 - b2_7 * z1_2 - b2_9 * z1_3 - b2_12 * z1_5;
  const T thetaddot1 = T(1) / D_thetaddot1 * (rho1_3 + u.tau_1 - b1_1 * z1_1 - b1_2 * z1_2 - b1_4 * z1_3 - b1_7 * z1_5
      - b1_10 * z1_6);
  ydot[0] = thetaddot1;

  // ---- body 2 (upper_arm), solved
  // thetaddot2: from A ydot = f by elimination
  const T thetaddot2 = z1_6 * b1_9 - b1_10 * thetaddot1;
  ydot[1] = thetaddot2;

  // ---- body 3 (forearm), solved
  // thetaddot3: from A ydot = f by elimination
  const T thetaddot3 = z1_5 * b2_11 - b2_12 * thetaddot2 - b1_7 * thetaddot1;
  ydot[2] = thetaddot3;

  // ---- body 4 (wrist), solved
  // thetaddot4: from A ydot = f by elimination
  const T thetaddot4 = z1_3 * b3_14 - b3_15 * thetaddot3 - b2_9 * thetaddot2 - b1_4 * thetaddot1;
  ydot[3] = thetaddot4;

  // ---- body 5 (hand), solved
  // thetaddot5: from A ydot = f by elimination
  const T thetaddot5 = z1_2 * c.c3_3 - b3_11 * thetaddot3 - b2_7 * thetaddot2 - b1_2 * thetaddot1;
  ydot[4] = thetaddot5;

  // ---- body 6 (flange), solved
  // thetaddot6: from A ydot = f by elimination
  const T thetaddot6 = z1_1 * T(24999.999999999996) - b4_5 * thetaddot4 - b3_9 * thetaddot3 - b3_9 * thetaddot2 - b1_1
      * thetaddot1;
  ydot[5] = thetaddot6;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 183 add, 196 multiply, 10 sine or cosine
template <class T>
void residual(const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r) noexcept {
  T cosines[6], sines[6];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 5, cosines + 1, sines + 1);

  // ---- body 1 (waist) on the inertial frame
  const T thetaddot1 = ydot[0];
  // N1 = h_own_1~ Pddot1 + axial(U1 (tr(J_own_1)/2 - J_own_1)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N1_3 = c.c1_4 * thetaddot1 + c.c1_5 * thetaddot1;

  // ---- body 2 (upper_arm) on body 1
  const T thetadot1 = y[0];
  const T thetadot2 = y[1];
  const T thetaddot2 = ydot[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T minus_omega2_1 = minus_E2_13 * thetadot1;
  const T omega2_3 = E2_11 * thetadot1;
  // omegadot2 = -thetadot2 b2~ E2 omega1 + thetaddot2 b2 + E2 omegadot1: angular acceleration, body axes [rad/s^2]
  const T t2_1 = thetadot2 * omega2_3;
  const T minus_omegadot2_1 = t2_1 + minus_E2_13 * thetaddot1;
  const T t2_2 = thetadot2 * minus_omega2_1;
  const T omegadot2_3 = E2_11 * thetaddot1 - t2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_3 = omega2_3 * omega2_3;
  const T t2_4 = thetadot2 * thetadot2;
  const T minus_U2_11 = t2_3 + t2_4;
  const T minus_U2_12 = t2_2 + omegadot2_3;
  const T t2_5 = omega2_3 * minus_omega2_1;
  const T U2_13 = thetaddot2 - t2_5;
  const T U2_21 = omegadot2_3 - t2_2;
  const T t2_6 = minus_omega2_1 * minus_omega2_1;
  const T minus_U2_22 = t2_3 + t2_6;
  const T U2_23 = t2_1 + minus_omegadot2_1;
  const T minus_U2_31 = t2_5 + thetaddot2;
  const T U2_32 = t2_1 - minus_omegadot2_1;
  const T minus_U2_33 = t2_4 + t2_6;
  // Pddot2 = E2 Pddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = minus_E2_13 * T(9.81);
  const T Pddot2_3 = E2_11 * T(9.81);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(0.0070992) * U2_21 - (c.c2_1 * U2_32 + c.c2_2 * U2_23 + T(0.023750999999999998) * (minus_U2_22 -
      minus_U2_33) + c.c1_3 * minus_U2_31);
  const T N2_2 = T(0.10439999999999999) * minus_Pddot2_1 - c.h_all_2_1 * Pddot2_3 + c.c2_2 * U2_13 + c.c2_1 *
      minus_U2_31 - T(0.0070992) * (minus_U2_33 - minus_U2_11) + T(0.023750999999999998) * minus_U2_12 - c.c1_3 *
      U2_32;
  const T N2_3 = c.c2_1 * U2_21 - c.c2_1 * minus_U2_12 + c.c1_3 * (minus_U2_11 - minus_U2_22) - T(0.0070992) * U2_23 +
      T(0.023750999999999998) * U2_13;

  // ---- body 3 (forearm) on body 2
  const T thetadot3 = y[2];
  const T thetaddot3 = ydot[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T minus_E3_13 = sines[2];
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T minus_omega3_1 = E3_11 * minus_omega2_1 + minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + thetadot2;
  const T omega3_3 = E3_11 * omega2_3 - minus_E3_13 * minus_omega2_1;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + thetaddot3 b3 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot3_1 = thetadot3 * omega3_3 + E3_11 * minus_omegadot2_1 + minus_E3_13 * omegadot2_3;
  const T omegadot3_2 = thetaddot3 + thetaddot2;
  const T omegadot3_3 = E3_11 * omegadot2_3 - minus_E3_13 * minus_omegadot2_1 - thetadot3 * minus_omega3_1;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_3 * omega3_3;
  const T t3_2 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_1 + t3_2;
  const T t3_3 = omega3_2 * minus_omega3_1;
  const T minus_U3_12 = t3_3 + omegadot3_3;
  const T t3_4 = omega3_3 * minus_omega3_1;
  const T U3_13 = omegadot3_2 - t3_4;
  const T U3_21 = omegadot3_3 - t3_3;
  const T t3_5 = minus_omega3_1 * minus_omega3_1;
  const T minus_U3_22 = t3_1 + t3_5;
  const T t3_6 = omega3_3 * omega3_2;
  const T U3_23 = t3_6 + minus_omegadot3_1;
  const T minus_U3_31 = t3_4 + omegadot3_2;
  const T U3_32 = t3_6 - minus_omegadot3_1;
  const T minus_U3_33 = t3_2 + t3_5;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_7 = minus_Pddot2_1 + minus_U2_11 * T(0.4318);
  const T t3_8 = Pddot2_3 - minus_U2_31 * T(0.4318);
  const T minus_Pddot3_1 = E3_11 * t3_7 + minus_E3_13 * t3_8;
  const T Pddot3_2 = U2_21 * T(0.4318);
  const T Pddot3_3 = E3_11 * t3_8 - minus_E3_13 * t3_7;
  // G3 = U3 h_own_3: inertia less applied force, body axes [N]
  const T G3_1 = minus_U3_11 * c.c1_1 + U3_13 * c.h_all_3_3;
  const T G3_2 = U3_23 * c.h_all_3_3 - U3_21 * c.c1_1;
  const T G3_3 = minus_U3_31 * c.c1_1 - minus_U3_33 * c.h_all_3_3;
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_1 = c.c1_2 * (minus_U3_22 - minus_U3_33) - (c.c3_1 * U3_32 + c.c3_2 * U3_23) + c.J_all_3_12 * minus_U3_31
      + c.J_all_3_13 * U3_21 - c.h_all_3_3 * Pddot3_2;
  const T N3_2 = c.c1_1 * Pddot3_3 - c.h_all_3_3 * minus_Pddot3_1 + c.c3_2 * U3_13 + c.c3_1 * minus_U3_31 -
      c.J_all_3_13 * (minus_U3_33 - minus_U3_11) - c.c1_2 * minus_U3_12 + c.J_all_3_12 * U3_32;
  const T N3_3 = c.c3_1 * U3_21 - c.c3_1 * minus_U3_12 - c.J_all_3_12 * (minus_U3_11 - minus_U3_22) - c.J_all_3_13 *
      U3_23 - c.c1_2 * U3_13 - c.c1_1 * Pddot3_2;

  // ---- body 4 (wrist) on body 3
  const T thetadot4 = y[3];
  const T thetaddot4 = ydot[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_12 = sines[3];
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega3_2 - E4_11 * minus_omega3_1;
  const T omega4_2 = E4_11 * omega3_2 + E4_12 * minus_omega3_1;
  const T omega4_3 = thetadot4 + omega3_3;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + thetaddot4 b4 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = thetadot4 * omega4_2 + E4_12 * omegadot3_2 - E4_11 * minus_omegadot3_1;
  const T omegadot4_2 = E4_11 * omegadot3_2 + E4_12 * minus_omegadot3_1 - thetadot4 * omega4_1;
  const T omegadot4_3 = thetaddot4 + omegadot3_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_1 = omega4_2 * omega4_1;
  const T U4_12 = t4_1 - omegadot4_3;
  const T t4_2 = omega4_3 * omega4_1;
  const T U4_13 = t4_2 + omegadot4_2;
  const T U4_21 = t4_1 + omegadot4_3;
  const T t4_3 = omega4_3 * omega4_2;
  const T U4_23 = t4_3 - omegadot4_1;
  const T U4_31 = t4_2 - omegadot4_2;
  const T U4_32 = t4_3 + omegadot4_1;
  const T minus_U4_33 = omega4_2 * omega4_2 + omega4_1 * omega4_1;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_4 = minus_U3_11 * T(0.0203) - minus_Pddot3_1 - minus_U3_12 * T(0.1501);
  const T t4_5 = Pddot3_2 - U3_21 * T(0.0203) - minus_U3_22 * T(0.1501);
  const T Pddot4_1 = E4_11 * t4_4 + E4_12 * t4_5;
  const T Pddot4_2 = E4_11 * t4_5 - E4_12 * t4_4;
  const T Pddot4_3 = Pddot3_3 + minus_U3_31 * T(0.0203) + U3_32 * T(0.1501);
  // N4 = h_own_4~ Pddot4 + axial(U4 (tr(J_own_4)/2 - J_own_4)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N4_1 = c.c4_2 * U4_32 + c.c4_2 * U4_23;
  const T minus_N4_2 = c.c4_2 * U4_13 + c.c4_1 * U4_31;
  const T N4_3 = c.c4_1 * U4_21 - c.c4_2 * U4_12;

  // ---- body 5 (hand) on body 4
  const T thetadot5 = y[4];
  const T thetaddot5 = ydot[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T minus_E5_13 = sines[4];
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 - minus_E5_13 * omega4_3;
  const T omega5_2 = thetadot5 + omega4_2;
  const T omega5_3 = minus_E5_13 * omega4_1 + E5_11 * omega4_3;
  // omegadot5 = -thetadot5 b5~ E5 omega4 + thetaddot5 b5 + E5 omegadot4: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = E5_11 * omegadot4_1 - minus_E5_13 * omegadot4_3 - thetadot5 * omega5_3;
  const T omegadot5_2 = thetaddot5 + omegadot4_2;
  const T omegadot5_3 = thetadot5 * omega5_1 + minus_E5_13 * omegadot4_1 + E5_11 * omegadot4_3;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_1 = omega5_2 * omega5_1;
  const T U5_12 = t5_1 - omegadot5_3;
  const T t5_2 = omega5_3 * omega5_1;
  const T U5_13 = t5_2 + omegadot5_2;
  const T U5_21 = t5_1 + omegadot5_3;
  const T t5_3 = omega5_3 * omega5_2;
  const T U5_23 = t5_3 - omegadot5_1;
  const T U5_31 = t5_2 - omegadot5_2;
  const T U5_32 = t5_3 + omegadot5_1;
  const T minus_U5_33 = omega5_2 * omega5_2 + omega5_1 * omega5_1;
  // Pddot5 = E5 (U4 q5 + Pddot4): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_1 = E5_11 * (Pddot4_1 + U4_13 * T(0.4331)) - minus_E5_13 * (Pddot4_3 - minus_U4_33 * T(0.4331));
  const T Pddot5_2 = Pddot4_2 + U4_23 * T(0.4331);
  // G5 = U5 h_own_5: inertia less applied force, body axes [N]
  const T G5_1 = U5_13 * c.h_all_5_3;
  const T G5_2 = U5_23 * c.h_all_5_3;
  const T minus_G5_3 = minus_U5_33 * c.h_all_5_3;
  // N5 = h_own_5~ Pddot5 + axial(U5 (tr(J_own_5)/2 - J_own_5)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T minus_N5_1 = c.c5_1 * U5_32 + c.c5_2 * U5_23 + c.h_all_5_3 * Pddot5_2;
  const T N5_2 = c.h_all_5_3 * Pddot5_1 + c.c5_2 * U5_13 - c.c5_1 * U5_31;
  const T N5_3 = c.c5_1 * U5_21 + c.c5_1 * U5_12;

  // ---- body 6 (flange) on body 5
  const T thetadot6 = y[5];
  const T thetaddot6 = ydot[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T E6_12 = sines[5];
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 + E6_12 * omega5_2;
  const T omega6_2 = E6_11 * omega5_2 - E6_12 * omega5_1;
  const T omega6_3 = thetadot6 + omega5_3;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + thetaddot6 b6 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_1 = thetadot6 * omega6_2 + E6_11 * omegadot5_1 + E6_12 * omegadot5_2;
  const T omegadot6_2 = E6_11 * omegadot5_2 - E6_12 * omegadot5_1 - thetadot6 * omega6_1;
  const T omegadot6_3 = thetaddot6 + omegadot5_3;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_2 * omega6_1;
  const T U6_12 = t6_1 - omegadot6_3;
  const T t6_2 = omega6_3 * omega6_1;
  const T U6_13 = t6_2 + omegadot6_2;
  const T U6_21 = t6_1 + omegadot6_3;
  const T t6_3 = omega6_3 * omega6_2;
  const T U6_23 = t6_3 - omegadot6_1;
  const T U6_31 = t6_2 - omegadot6_2;
  const T U6_32 = t6_3 + omegadot6_1;
  // N6 = h_own_6~ Pddot6 + axial(U6 (tr(J_own_6)/2 - J_own_6)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N6_1 = T(2e-05) * U6_32 + T(2e-05) * U6_23;
  const T minus_N6_2 = T(2e-05) * U6_13 + T(2e-05) * U6_31;
  const T N6_3 = T(2e-05) * U6_21 - T(2e-05) * U6_12;

  // ---- body 6 (flange) and what it carries
  // r_theta6 = b6 . N6 - tau_flange_: Kane's equation of the angle [N m]
  const T r_theta6 = N6_3 - u.tau_6;
  r[5] = r_theta6;

  // ---- body 5 (hand) and what it carries
  // rho5 = E6^T N6 + N5: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5_1 = E6_11 * N6_1 - minus_N5_1 + E6_12 * minus_N6_2;
  const T rho5_2 = N5_2 + E6_12 * N6_1 - E6_11 * minus_N6_2;
  const T rho5_3 = N6_3 + N5_3;
  // r_theta5 = b5 . rho5 - tau_hand_: Kane's equation of the angle [N m]
  const T r_theta5 = rho5_2 - u.tau_5;
  r[4] = r_theta5;

  // ---- body 4 (wrist) and what it carries
  // S4 = E5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T S4_1 = E5_11 * G5_1 - minus_E5_13 * minus_G5_3;
  const T minus_S4_3 = minus_E5_13 * G5_1 + E5_11 * minus_G5_3;
  // rho4 = q5~ E5^T S5 + E5^T rho5 + N4: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho4_1 = N4_1 + E5_11 * rho5_1 + minus_E5_13 * rho5_3 - T(0.4331) * G5_2;
  const T rho4_2 = rho5_2 - minus_N4_2 + T(0.4331) * S4_1;
  const T rho4_3 = N4_3 + E5_11 * rho5_3 - minus_E5_13 * rho5_1;
  // r_theta4 = b4 . rho4 - tau_wrist_: Kane's equation of the angle [N m]
  const T r_theta4 = rho4_3 - u.tau_4;
  r[3] = r_theta4;

  // ---- body 3 (forearm) and what it carries
  // S3 = E4^T S4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = E4_11 * S4_1 - E4_12 * G5_2;
  const T S3_1 = b3_1 + G3_1;
  const T b3_2 = E4_12 * S4_1 + E4_11 * G5_2;
  const T S3_2 = b3_2 + G3_2;
  const T S3_3 = G3_3 - minus_S4_3;
  // rho3 = q4~ E4^T S4 + E4^T rho4 + N3: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho3_1 = N3_1 + E4_11 * rho4_1 - E4_12 * rho4_2 - T(0.1501) * minus_S4_3;
  const T rho3_2 = N3_2 + E4_12 * rho4_1 + E4_11 * rho4_2 - T(0.0203) * minus_S4_3;
  const T rho3_3 = rho4_3 + N3_3 - T(0.0203) * b3_2 - T(0.1501) * b3_1;
  // r_theta3 = b3 . rho3 - tau_forearm_: Kane's equation of the angle [N m]
  const T r_theta3 = rho3_2 - u.tau_3;
  r[2] = r_theta3;

  // ---- body 2 (upper_arm) and what it carries
  // rho2 = q3~ E3^T S3 + E3^T rho3 + N2: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho2_1 = N2_1 + E3_11 * rho3_1 + minus_E3_13 * rho3_3;
  const T rho2_2 = rho3_2 + N2_2 - T(0.4318) * (E3_11 * S3_3 - minus_E3_13 * S3_1);
  const T rho2_3 = N2_3 + T(0.4318) * S3_2 + E3_11 * rho3_3 - minus_E3_13 * rho3_1;
  // r_theta2 = b2 . rho2 - tau_upper_arm_: Kane's equation of the angle [N m]
  const T r_theta2 = rho2_2 - u.tau_2;
  r[1] = r_theta2;

  // ---- body 1 (waist) and what it carries
  // rho1 = E2^T rho2 + N1: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho1_3 = N1_3 + E2_11 * rho2_3 - minus_E2_13 * rho2_1;
  // r_theta1 = b1 . rho1 - tau_waist_: Kane's equation of the angle [N m]
  const T r_theta1 = rho1_3 - u.tau_1;
  r[0] = r_theta1;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 163 add, 186 multiply, 10 sine or cosine
template <class T>
void forcing(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* f) noexcept {
  T cosines[6], sines[6];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 5, cosines + 1, sines + 1);

  // ---- body 2 (upper_arm) on body 1
  const T thetadot1 = y[0];
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T minus_omega2_1 = minus_E2_13 * thetadot1;
  const T omega2_3 = E2_11 * thetadot1;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot2_1 = thetadot2 * omega2_3;
  const T minus_omegadot2_3 = thetadot2 * minus_omega2_1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_3 * omega2_3;
  const T t2_2 = thetadot2 * thetadot2;
  const T minus_U2_11 = t2_1 + t2_2;
  const T minus_U2_13 = omega2_3 * minus_omega2_1;
  const T minus_U2_21 = minus_omegadot2_3 + minus_omegadot2_3;
  const T t2_3 = minus_omega2_1 * minus_omega2_1;
  const T minus_U2_22 = t2_1 + t2_3;
  const T U2_23 = minus_omegadot2_1 + minus_omegadot2_1;
  const T minus_U2_33 = t2_2 + t2_3;
  // Pddot2 = E2 Pddot1: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = minus_E2_13 * T(9.81);
  const T Pddot2_3 = E2_11 * T(9.81);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N2_1 = c.c2_2 * U2_23 + T(0.023750999999999998) * (minus_U2_22 - minus_U2_33) + c.c1_3 * minus_U2_13 +
      T(0.0070992) * minus_U2_21;
  const T minus_N2_2 = T(0.10439999999999999) * minus_Pddot2_1 - c.h_all_2_1 * Pddot2_3 + c.c2_1 * minus_U2_13 -
      c.c2_2 * minus_U2_13 - T(0.0070992) * (minus_U2_33 - minus_U2_11);
  const T minus_N2_3 = c.c1_3 * (minus_U2_11 - minus_U2_22) - c.c2_1 * minus_U2_21 - T(0.0070992) * U2_23 -
      T(0.023750999999999998) * minus_U2_13;

  // ---- body 3 (forearm) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T minus_E3_13 = sines[2];
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T minus_omega3_1 = E3_11 * minus_omega2_1 + minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + thetadot2;
  const T omega3_3 = E3_11 * omega2_3 - minus_E3_13 * minus_omega2_1;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = minus_E3_13 * minus_omegadot2_3 - E3_11 * minus_omegadot2_1 - thetadot3 * omega3_3;
  const T minus_omegadot3_3 = thetadot3 * minus_omega3_1 + minus_E3_13 * minus_omegadot2_1 + E3_11 *
      minus_omegadot2_3;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_3 * omega3_3;
  const T t3_2 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_1 + t3_2;
  const T t3_3 = omega3_2 * minus_omega3_1;
  const T U3_12 = minus_omegadot3_3 - t3_3;
  const T minus_U3_13 = omega3_3 * minus_omega3_1;
  const T minus_U3_21 = t3_3 + minus_omegadot3_3;
  const T t3_4 = minus_omega3_1 * minus_omega3_1;
  const T minus_U3_22 = t3_1 + t3_4;
  const T t3_5 = omega3_3 * omega3_2;
  const T U3_23 = t3_5 - omegadot3_1;
  const T U3_32 = t3_5 + omegadot3_1;
  const T minus_U3_33 = t3_2 + t3_4;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_6 = minus_Pddot2_1 + minus_U2_11 * T(0.4318);
  const T t3_7 = Pddot2_3 - minus_U2_13 * T(0.4318);
  const T minus_Pddot3_1 = E3_11 * t3_6 + minus_E3_13 * t3_7;
  const T minus_Pddot3_2 = minus_U2_21 * T(0.4318);
  const T Pddot3_3 = E3_11 * t3_7 - minus_E3_13 * t3_6;
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = minus_U3_11 * c.c1_1 - minus_U3_13 * c.h_all_3_3;
  const T minus_G3_2 = minus_U3_21 * c.c1_1 + U3_23 * c.h_all_3_3;
  const T minus_G3_3 = minus_U3_13 * c.c1_1 - minus_U3_33 * c.h_all_3_3;
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = c.h_all_3_3 * minus_Pddot3_2 - c.c3_1 * U3_32 - c.c3_2 * U3_23 + c.c1_2 * (minus_U3_22 -
      minus_U3_33) + c.J_all_3_12 * minus_U3_13 - c.J_all_3_13 * minus_U3_21;
  const T minus_N3_2 = c.c1_1 * Pddot3_3 - c.h_all_3_3 * minus_Pddot3_1 + c.c3_1 * minus_U3_13 - c.c3_2 * minus_U3_13
      - c.J_all_3_13 * (minus_U3_33 - minus_U3_11) + c.c1_2 * U3_12 + c.J_all_3_12 * U3_32;
  const T minus_N3_3 = c.c1_1 * minus_Pddot3_2 - c.c3_1 * minus_U3_21 + c.c3_1 * U3_12 - c.J_all_3_12 * (minus_U3_11 -
      minus_U3_22) - c.J_all_3_13 * U3_23 + c.c1_2 * minus_U3_13;

  // ---- body 4 (wrist) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_12 = sines[3];
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega3_2 - E4_11 * minus_omega3_1;
  const T omega4_2 = E4_11 * omega3_2 + E4_12 * minus_omega3_1;
  const T omega4_3 = thetadot4 + omega3_3;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = thetadot4 * omega4_2 + E4_11 * omegadot3_1;
  const T minus_omegadot4_2 = thetadot4 * omega4_1 + E4_12 * omegadot3_1;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_1 = omega4_2 * omega4_1;
  const T U4_12 = t4_1 + minus_omegadot3_3;
  const T t4_2 = omega4_3 * omega4_1;
  const T U4_13 = t4_2 - minus_omegadot4_2;
  const T U4_21 = t4_1 - minus_omegadot3_3;
  const T t4_3 = omega4_3 * omega4_2;
  const T U4_23 = t4_3 - omegadot4_1;
  const T U4_31 = t4_2 + minus_omegadot4_2;
  const T U4_32 = t4_3 + omegadot4_1;
  const T minus_U4_33 = omega4_2 * omega4_2 + omega4_1 * omega4_1;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_4 = minus_U3_11 * T(0.0203) - minus_Pddot3_1 + U3_12 * T(0.1501);
  const T t4_5 = minus_U3_21 * T(0.0203) - minus_Pddot3_2 - minus_U3_22 * T(0.1501);
  const T Pddot4_1 = E4_11 * t4_4 + E4_12 * t4_5;
  const T Pddot4_2 = E4_11 * t4_5 - E4_12 * t4_4;
  const T Pddot4_3 = Pddot3_3 + minus_U3_13 * T(0.0203) + U3_32 * T(0.1501);
  // N4 = -h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N4_1 = c.c4_2 * U4_32 + c.c4_2 * U4_23;
  const T N4_2 = c.c4_2 * U4_13 + c.c4_1 * U4_31;
  const T minus_N4_3 = c.c4_1 * U4_21 - c.c4_2 * U4_12;

  // ---- body 5 (hand) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T minus_E5_13 = sines[4];
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 - minus_E5_13 * omega4_3;
  const T omega5_2 = thetadot5 + omega4_2;
  const T omega5_3 = minus_E5_13 * omega4_1 + E5_11 * omega4_3;
  // omegadot5 = -thetadot5 b5~ E5 omega4 + E5 omegadot4: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = E5_11 * omegadot4_1 + minus_E5_13 * minus_omegadot3_3 - thetadot5 * omega5_3;
  const T omegadot5_3 = thetadot5 * omega5_1 + minus_E5_13 * omegadot4_1 - E5_11 * minus_omegadot3_3;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_1 = omega5_2 * omega5_1;
  const T U5_12 = t5_1 - omegadot5_3;
  const T t5_2 = omega5_3 * omega5_1;
  const T U5_13 = t5_2 - minus_omegadot4_2;
  const T U5_21 = t5_1 + omegadot5_3;
  const T t5_3 = omega5_3 * omega5_2;
  const T U5_23 = t5_3 - omegadot5_1;
  const T U5_31 = t5_2 + minus_omegadot4_2;
  const T U5_32 = t5_3 + omegadot5_1;
  const T minus_U5_33 = omega5_2 * omega5_2 + omega5_1 * omega5_1;
  // Pddot5 = E5 (U4 q5 + Pddot4): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_1 = E5_11 * (Pddot4_1 + U4_13 * T(0.4331)) - minus_E5_13 * (Pddot4_3 - minus_U4_33 * T(0.4331));
  const T Pddot5_2 = Pddot4_2 + U4_23 * T(0.4331);
  // G5 = -U5 h_own_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = U5_13 * c.h_all_5_3;
  const T minus_G5_2 = U5_23 * c.h_all_5_3;
  const T G5_3 = minus_U5_33 * c.h_all_5_3;
  // N5 = -h_own_5~ Pddot5 - axial(U5 (tr(J_own_5)/2 - J_own_5)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N5_1 = c.c5_1 * U5_32 + c.c5_2 * U5_23 + c.h_all_5_3 * Pddot5_2;
  const T minus_N5_2 = c.h_all_5_3 * Pddot5_1 + c.c5_2 * U5_13 - c.c5_1 * U5_31;
  const T minus_N5_3 = c.c5_1 * U5_21 + c.c5_1 * U5_12;

  // ---- body 6 (flange) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T E6_12 = sines[5];
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 + E6_12 * omega5_2;
  const T omega6_2 = E6_11 * omega5_2 - E6_12 * omega5_1;
  const T omega6_3 = thetadot6 + omega5_3;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_1 = thetadot6 * omega6_2 + E6_11 * omegadot5_1 - E6_12 * minus_omegadot4_2;
  const T minus_omegadot6_2 = thetadot6 * omega6_1 + E6_11 * minus_omegadot4_2 + E6_12 * omegadot5_1;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_2 * omega6_1;
  const T U6_12 = t6_1 - omegadot5_3;
  const T t6_2 = omega6_3 * omega6_1;
  const T U6_13 = t6_2 - minus_omegadot6_2;
  const T U6_21 = t6_1 + omegadot5_3;
  const T t6_3 = omega6_3 * omega6_2;
  const T U6_23 = t6_3 - omegadot6_1;
  const T U6_31 = t6_2 + minus_omegadot6_2;
  const T U6_32 = t6_3 + omegadot6_1;
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(2e-05) * U6_32 + T(2e-05) * U6_23;
  const T N6_2 = T(2e-05) * U6_13 + T(2e-05) * U6_31;
  const T minus_N6_3 = T(2e-05) * U6_21 - T(2e-05) * U6_12;

  // ---- body 6 (flange) and what it carries
  // f_theta6 = b6 . N6 + tau_flange_: Kane's equation of the angle [N m]
  const T f_theta6 = u.tau_6 - minus_N6_3;
  f[5] = f_theta6;

  // ---- body 5 (hand) and what it carries
  // rho5 = E6^T N6 + N5: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5_1 = N5_1 - E6_12 * N6_2 - E6_11 * minus_N6_1;
  const T minus_rho5_2 = minus_N5_2 + E6_12 * minus_N6_1 - E6_11 * N6_2;
  const T minus_rho5_3 = minus_N6_3 + minus_N5_3;
  // f_theta5 = b5 . rho5 + tau_hand_: Kane's equation of the angle [N m]
  const T f_theta5 = u.tau_5 - minus_rho5_2;
  f[4] = f_theta5;

  // ---- body 4 (wrist) and what it carries
  // S4 = E5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T S4_1 = minus_E5_13 * G5_3 - E5_11 * minus_G5_1;
  const T S4_3 = minus_E5_13 * minus_G5_1 + E5_11 * G5_3;
  // rho4 = q5~ E5^T S5 + E5^T rho5 + N4: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho4_1 = T(0.4331) * minus_G5_2 - minus_N4_1 + E5_11 * rho5_1 - minus_E5_13 * minus_rho5_3;
  const T rho4_2 = N4_2 - minus_rho5_2 + T(0.4331) * S4_1;
  const T minus_rho4_3 = minus_N4_3 + minus_E5_13 * rho5_1 + E5_11 * minus_rho5_3;
  // f_theta4 = b4 . rho4 + tau_wrist_: Kane's equation of the angle [N m]
  const T f_theta4 = u.tau_4 - minus_rho4_3;
  f[3] = f_theta4;

  // ---- body 3 (forearm) and what it carries
  // S3 = E4^T S4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = E4_11 * S4_1 + E4_12 * minus_G5_2;
  const T S3_1 = b3_1 - minus_G3_1;
  const T b3_2 = E4_12 * S4_1 - E4_11 * minus_G5_2;
  const T S3_2 = b3_2 - minus_G3_2;
  const T S3_3 = S4_3 - minus_G3_3;
  // rho3 = q4~ E4^T S4 + E4^T rho4 + N3: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho3_1 = T(0.1501) * S4_3 - minus_N3_1 + E4_11 * rho4_1 - E4_12 * rho4_2;
  const T rho3_2 = T(0.0203) * S4_3 - minus_N3_2 + E4_12 * rho4_1 + E4_11 * rho4_2;
  const T minus_rho3_3 = minus_rho4_3 + minus_N3_3 + T(0.0203) * b3_2 + T(0.1501) * b3_1;
  // f_theta3 = b3 . rho3 + tau_forearm_: Kane's equation of the angle [N m]
  const T f_theta3 = rho3_2 + u.tau_3;
  f[2] = f_theta3;

  // ---- body 2 (upper_arm) and what it carries
  // rho2 = q3~ E3^T S3 + E3^T rho3 + N2: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho2_1 = N2_1 + E3_11 * rho3_1 - minus_E3_13 * minus_rho3_3;
  const T rho2_2 = rho3_2 - minus_N2_2 - T(0.4318) * (E3_11 * S3_3 - minus_E3_13 * S3_1);
  const T rho2_3 = T(0.4318) * S3_2 - (minus_N2_3 + minus_E3_13 * rho3_1 + E3_11 * minus_rho3_3);
  // f_theta2 = b2 . rho2 + tau_upper_arm_: Kane's equation of the angle [N m]
  const T f_theta2 = rho2_2 + u.tau_2;
  f[1] = f_theta2;

  // ---- body 1 (waist) and what it carries
  // rho1 = E2^T rho2 + N1: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho1_3 = E2_11 * rho2_3 - minus_E2_13 * rho2_1;
  // f_theta1 = b1 . rho1 + tau_waist_: Kane's equation of the angle [N m]
  const T f_theta1 = rho1_3 + u.tau_1;
  f[0] = f_theta1;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 68 add, 85 multiply, 8 sine or cosine
template <class T>
void mass_matrix(const Prepared<T>& c, const T* x, T* A) noexcept {
  T cosines[5], sines[5];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 4, cosines + 1, sines + 1);

  // ---- body 1 (waist) on the inertial frame
  A[28] = c.J_all_5_22;

  // ---- body 2 (upper_arm) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];

  // ---- body 3 (forearm) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T minus_E3_13 = sines[2];

  // ---- body 4 (wrist) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_12 = sines[3];

  // ---- body 5 (hand) on body 4
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T minus_E5_13 = sines[4];

  // ---- body 5 (hand) and what it carries
  // hc5 = E5^T h5: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc5_1 = minus_E5_13 * c.h_all_5_3;
  const T hc5_3 = E5_11 * c.h_all_5_3;

  // ---- body 4 (wrist) and what it carries
  // J4 = -q5~ hc5~ + E5^T J5 E5 + J_own_4 - hc5~ q5~: inertia carried, about the body origin, body axes [kg m^2]
  const T b4_1 = minus_E5_13 * c.c4_3;
  const T b4_2 = minus_E5_13 * b4_1;
  const T J4_11 = c.J_own_5_11 + b4_2 + T(0.8662) * hc5_3;
  const T J4_13 = E5_11 * b4_1 - T(0.4331) * hc5_1;
  const T b4_3 = T(0.4331) * hc5_3;
  const T b4_4 = b4_3 + c.J_all_5_22;
  const T J4_22 = b4_4 + c.J_own_4_22 + b4_3;
  const T J4_33 = T(0.00164) - b4_2;
  A[21] = J4_33;
  // hc4 = E4^T h4: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4_1 = E4_11 * hc5_1;
  const T hc4_2 = E4_12 * hc5_1;
  // K_thetadot6_4 = q5~ E5^T B_thetadot6_5 + E5^T K_thetadot6_5
  const T K_thetadot6_4_1 = minus_E5_13 * T(4e-05);
  const T K_thetadot6_4_3 = E5_11 * T(4e-05);
  A[23] = K_thetadot6_4_3;
  A[33] = K_thetadot6_4_3;

  // ---- body 3 (forearm) and what it carries
  // h3 = h_own_3 + hc4: first moment of mass carried, about the body origin, body axes [kg m]
  const T h3_1 = hc4_1 - c.c1_1;
  const T h3_3 = c.h_all_3_3 + hc5_3;
  // J3 = -q4~ hc4~ + E4^T J4 E4 + J_own_3 - hc4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b3_1 = E4_12 * (J4_11 - J4_22);
  const T b3_2 = E4_12 * b3_1;
  const T J3_11 = J4_11 - b3_2 + c.J_own_3_11 + T(0.3002) * hc4_2;
  const T J3_12 = c.J_all_3_12 + E4_11 * b3_1 - T(0.1501) * hc4_1 + T(0.0203) * hc4_2;
  const T b3_3 = E4_11 * J4_13;
  const T J3_13 = b3_3 + c.J_all_3_13 + T(0.0203) * hc5_3;
  const T J3_22 = J4_22 + b3_2 + c.J_all_3_22 - T(0.0406) * hc4_1;
  const T b3_4 = E4_12 * J4_13;
  const T J3_23 = b3_4 - c.c1_2 - T(0.1501) * hc5_3;
  const T b3_5 = T(0.1501) * hc4_2 - T(0.0203) * hc4_1;
  const T b3_6 = b3_5 + J4_33;
  const T J3_33 = b3_6 + b3_5;
  A[14] = J3_22;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc3_1 = minus_E3_13 * h3_3 + E3_11 * h3_1;
  const T hc3_3 = E3_11 * h3_3 - minus_E3_13 * h3_1;
  // K_thetadot6_3 = q4~ E4^T B_thetadot6_4 + E4^T K_thetadot6_4
  const T K_thetadot6_3_1 = E4_11 * K_thetadot6_4_1;
  const T K_thetadot6_3_2 = E4_12 * K_thetadot6_4_1;
  A[11] = K_thetadot6_3_2;
  A[17] = K_thetadot6_3_2;
  A[31] = K_thetadot6_3_2;
  A[32] = K_thetadot6_3_2;
  // B_thetadot5_3 = E4^T B_thetadot5_4
  const T B_thetadot5_3_1 = E4_11 * hc5_3;
  const T B_thetadot5_3_2 = E4_12 * hc5_3;
  // K_thetadot5_3 = q4~ E4^T B_thetadot5_4 + E4^T K_thetadot5_4
  const T minus_K_thetadot5_3_1 = T(0.1501) * hc5_1 + E4_12 * b4_4;
  const T K_thetadot5_3_2 = E4_11 * b4_4 - T(0.0203) * hc5_1;
  const T minus_K_thetadot5_3_3 = T(0.0203) * B_thetadot5_3_2 + T(0.1501) * B_thetadot5_3_1;
  A[16] = K_thetadot5_3_2;
  A[26] = K_thetadot5_3_2;
  A[15] = b3_4;
  A[20] = b3_4;

  // ---- body 2 (upper_arm) and what it carries
  // J2 = -q3~ hc3~ + E3^T J3 E3 + J_own_2 - hc3~ q3~: inertia carried, about the body origin, body axes [kg m^2]
  const T b2_1 = minus_E3_13 * (J3_33 - J3_11) + T(2) * E3_11 * J3_13;
  const T b2_2 = minus_E3_13 * b2_1;
  const T J2_11 = J3_11 + b2_2 + c.J_own_2_11;
  const T b2_3 = E3_11 * J3_12 + minus_E3_13 * J3_23;
  const T J2_12 = b2_3 - c.c1_3 - T(0.4318) * hc4_2;
  const T J2_13 = T(0.0070992) - J3_13 + E3_11 * b2_1 - T(0.4318) * hc3_3;
  const T b2_4 = T(0.4318) * hc3_1;
  const T b2_5 = b2_4 + J3_22;
  const T J2_22 = b2_5 + c.J_all_2_22 + b2_4;
  const T b2_6 = E3_11 * J3_23 - minus_E3_13 * J3_12;
  const T J2_23 = b2_6 + T(0.023750999999999998);
  const T J2_33 = J3_33 - b2_2 + T(0.8636) * hc3_1;
  A[7] = J2_22;
  // K_thetadot6_2 = q3~ E3^T B_thetadot6_3 + E3^T K_thetadot6_3
  const T K_thetadot6_2_1 = E3_11 * K_thetadot6_3_1 + minus_E3_13 * K_thetadot6_4_3;
  const T K_thetadot6_2_3 = E3_11 * K_thetadot6_4_3 - minus_E3_13 * K_thetadot6_3_1;
  // K_thetadot5_2 = q3~ E3^T B_thetadot5_3 + E3^T K_thetadot5_3
  const T minus_K_thetadot5_2_1 = minus_E3_13 * minus_K_thetadot5_3_3 + E3_11 * minus_K_thetadot5_3_1;
  const T K_thetadot5_2_2 = K_thetadot5_3_2 + T(0.4318) * (minus_E3_13 * B_thetadot5_3_1 + E3_11 * hc5_1);
  const T K_thetadot5_2_3 = T(0.4318) * B_thetadot5_3_2 + minus_E3_13 * minus_K_thetadot5_3_1 - E3_11 *
      minus_K_thetadot5_3_3;
  A[10] = K_thetadot5_2_2;
  A[25] = K_thetadot5_2_2;
  // K_thetadot4_2 = q3~ E3^T B_thetadot4_3 + E3^T K_thetadot4_3
  const T K_thetadot4_2_1 = E3_11 * b3_3 + minus_E3_13 * b3_6;
  const T K_thetadot4_2_2 = b3_4 - minus_E3_13 * hc4_2 * T(0.4318);
  const T K_thetadot4_2_3 = T(0.4318) * hc4_1 + E3_11 * b3_6 - minus_E3_13 * b3_3;
  A[9] = K_thetadot4_2_2;
  A[19] = K_thetadot4_2_2;
  A[8] = b2_5;
  A[13] = b2_5;

  // ---- body 1 (waist) and what it carries
  // J1 = E2^T J2 E2 + J_own_1: inertia carried, about the body origin, body axes [kg m^2]
  const T J1_23 = E2_11 * J2_23 - minus_E2_13 * J2_12;
  const T J1_33 = J2_33 + c.J_all_1_33 - minus_E2_13 * (minus_E2_13 * (J2_33 - J2_11) + T(2) * E2_11 * J2_13);
  A[1] = J1_23;
  A[6] = J1_23;
  A[0] = J1_33;
  // K_thetadot6_1 = E2^T K_thetadot6_2
  const T K_thetadot6_1_3 = E2_11 * K_thetadot6_2_3 - minus_E2_13 * K_thetadot6_2_1;
  A[5] = K_thetadot6_1_3;
  A[30] = K_thetadot6_1_3;
  // K_thetadot5_1 = E2^T K_thetadot5_2
  const T K_thetadot5_1_3 = E2_11 * K_thetadot5_2_3 + minus_E2_13 * minus_K_thetadot5_2_1;
  A[4] = K_thetadot5_1_3;
  A[24] = K_thetadot5_1_3;
  // K_thetadot4_1 = E2^T K_thetadot4_2
  const T K_thetadot4_1_3 = E2_11 * K_thetadot4_2_3 - minus_E2_13 * K_thetadot4_2_1;
  A[3] = K_thetadot4_1_3;
  A[18] = K_thetadot4_1_3;
  // K_thetadot3_1 = E2^T K_thetadot3_2
  const T K_thetadot3_1_3 = E2_11 * b2_6 - minus_E2_13 * b2_3;
  A[2] = K_thetadot3_1_3;
  A[12] = K_thetadot3_1_3;

  // ---- results
  A[22] = T(0);
  A[27] = T(0);
  A[29] = T(0);
  A[34] = T(0);
  A[35] = T(4e-05);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 138 add, 215 multiply, 12 sine or cosine
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  for (int i = 0; i < 126; ++i) v_y[i] = T(0);
  T cosines[6], sines[6];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 6, cosines, sines);

  // ---- body 1 (waist) on the inertial frame
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];

  // ---- body 2 (upper_arm) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T R2_12 = E1_12 * E2_11;
  const T R2_31 = E1_11 * minus_E2_13;
  const T R2_32 = E1_12 * minus_E2_13;
  // P_thetadot1_2 = -E1^T q2~ b1: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot1_2_1 = E1_11 * T(0.2435);
  const T minus_P_thetadot1_2_2 = E1_12 * T(0.2435);
  // B1_1 = -R2^T (C2^T r2)~ omega_thetadot1_2 + P_thetadot1_2
  const T t2_1 = T(0.016) * E2_11;
  const T t2_2 = T(0.006) * minus_E2_13 - T(0.068) * E2_11;
  const T t2_3 = T(0.016) * minus_E2_13;
  const T minus_B1_1_1 = minus_P_thetadot1_2_1 - R2_11 * t2_1 - E1_12 * t2_2 - R2_31 * t2_3;
  const T minus_B1_1_2 = minus_P_thetadot1_2_2 + E1_11 * t2_2 - R2_12 * t2_1 - R2_32 * t2_3;
  const T minus_B1_1_3 = minus_E2_13 * t2_1 - E2_11 * t2_3;
  v_y[18] = -minus_B1_1_1;
  v_y[24] = -minus_B1_1_2;
  v_y[30] = -minus_B1_1_3;
  // B2_2 = -R2^T (C2^T r2)~ b2
  const T minus_B2_2_1 = R2_11 * T(0.006) + R2_31 * T(0.068);
  const T minus_B2_2_2 = R2_12 * T(0.006) + R2_32 * T(0.068);
  v_y[19] = -minus_B2_2_1;
  v_y[25] = -minus_B2_2_2;
  v_y[31] = t2_2;

  // ---- body 3 (forearm) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T minus_E3_13 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R2_12 * E3_11 - R2_32 * minus_E3_13;
  const T minus_R3_13 = minus_E2_13 * E3_11 + E2_11 * minus_E3_13;
  const T R3_31 = R2_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R2_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = E2_11 * E3_11 - minus_E2_13 * minus_E3_13;
  // P_thetadot1_3 = -R2^T q3~ omega_thetadot1_2 + P_thetadot1_2: partial velocity of the body origin, inertial axes
  const T t3_1 = T(0.4318) * E2_11;
  const T t3_2 = T(0.0934) * E2_11;
  const T t3_3 = T(0.0934) * minus_E2_13;
  const T minus_P_thetadot1_3_1 = minus_P_thetadot1_2_1 + E1_12 * t3_1 - R2_11 * t3_2 - R2_31 * t3_3;
  const T minus_P_thetadot1_3_2 = minus_P_thetadot1_2_2 - R2_12 * t3_2 - E1_11 * t3_1 - R2_32 * t3_3;
  const T minus_P_thetadot1_3_3 = minus_E2_13 * t3_2 - E2_11 * t3_3;
  v_y[84] = -minus_P_thetadot1_3_3;
  // P_thetadot2_3 = -R2^T q3~ b2: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot2_3_1 = R2_31 * T(0.4318);
  const T minus_P_thetadot2_3_2 = R2_32 * T(0.4318);
  // B3_1 = -R3^T (C3^T r3)~ omega_thetadot1_3 + P_thetadot1_3
  const T t3_4 = T(0.014) * R3_33;
  const T t3_5 = T(0.07) * minus_R3_13;
  const T t3_6 = T(0.014) * minus_R3_13;
  const T minus_B3_1_1 = minus_P_thetadot1_3_1 + R3_11 * t3_4 + E1_12 * t3_5 + R3_31 * t3_6;
  const T minus_B3_1_2 = minus_P_thetadot1_3_2 + R3_12 * t3_4 - E1_11 * t3_5 + R3_32 * t3_6;
  const T minus_B3_1_3 = minus_P_thetadot1_3_3 + R3_33 * t3_6 - minus_R3_13 * t3_4;
  v_y[36] = -minus_B3_1_1;
  v_y[42] = -minus_B3_1_2;
  v_y[48] = -minus_B3_1_3;
  // B4_2 = -R3^T (C3^T r3)~ omega_thetadot2_3 + P_thetadot2_3
  const T t3_7 = R3_11 * T(0.07);
  const T minus_B4_2_1 = minus_P_thetadot2_3_1 - t3_7;
  const T t3_8 = R3_12 * T(0.07);
  const T minus_B4_2_2 = minus_P_thetadot2_3_2 - t3_8;
  const T minus_B4_2_3 = t3_5 + t3_1;
  v_y[37] = -minus_B4_2_1;
  v_y[43] = -minus_B4_2_2;
  v_y[49] = -minus_B4_2_3;
  v_y[38] = t3_7;
  v_y[44] = t3_8;
  v_y[50] = -t3_5;

  // ---- body 4 (wrist) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_12 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - E1_12 * E4_12;
  const T R4_12 = R3_12 * E4_11 + E1_11 * E4_12;
  const T minus_R4_13 = minus_R3_13 * E4_11;
  const T minus_R4_21 = E1_12 * E4_11 + R3_11 * E4_12;
  const T R4_22 = E1_11 * E4_11 - R3_12 * E4_12;
  const T R4_23 = minus_R3_13 * E4_12;
  // P_thetadot1_4 = -R3^T q4~ omega_thetadot1_3 + P_thetadot1_3: partial velocity of the body origin, inertial axes
  const T t4_1 = T(0.0203) * R3_33 - T(0.4331) * minus_R3_13;
  const T minus_P_thetadot1_4_1 = minus_P_thetadot1_3_1 - E1_12 * t4_1;
  const T minus_P_thetadot1_4_2 = minus_P_thetadot1_3_2 + E1_11 * t4_1;
  v_y[72] = -minus_P_thetadot1_4_1;
  v_y[78] = -minus_P_thetadot1_4_2;
  // P_thetadot2_4 = -R3^T q4~ omega_thetadot2_3 + P_thetadot2_3: partial velocity of the body origin, inertial axes
  const T t4_2 = R3_11 * T(0.4331) + R3_31 * T(0.0203);
  const T minus_P_thetadot2_4_1 = minus_P_thetadot2_3_1 - t4_2;
  const T t4_3 = R3_12 * T(0.4331) + R3_32 * T(0.0203);
  const T minus_P_thetadot2_4_2 = minus_P_thetadot2_3_2 - t4_3;
  const T minus_P_thetadot2_4_3 = t3_1 - t4_1;
  v_y[73] = -minus_P_thetadot2_4_1;
  v_y[79] = -minus_P_thetadot2_4_2;
  v_y[85] = -minus_P_thetadot2_4_3;
  v_y[74] = t4_2;
  v_y[80] = t4_3;
  v_y[86] = t4_1;
  // B6_1 = -R4^T r4~ omega_thetadot1_4 + P_thetadot1_4
  const T t4_4 = T(0.019) * R4_23;
  const T t4_5 = T(0.019) * minus_R4_13;
  const T minus_B6_1_1 = minus_P_thetadot1_4_1 + R4_11 * t4_4 - minus_R4_21 * t4_5;
  const T minus_B6_1_2 = minus_P_thetadot1_4_2 + R4_12 * t4_4 + R4_22 * t4_5;
  const T minus_B6_1_3 = minus_P_thetadot1_3_3 + R4_23 * t4_5 - minus_R4_13 * t4_4;
  v_y[54] = -minus_B6_1_1;
  v_y[60] = -minus_B6_1_2;
  v_y[66] = -minus_B6_1_3;
  // B7_2 = -R4^T r4~ omega_thetadot2_4 + P_thetadot2_4
  const T t4_6 = T(0.019) * E4_11;
  const T t4_7 = T(0.019) * E4_12;
  const T t4_8 = R4_11 * t4_6 + minus_R4_21 * t4_7;
  const T minus_B7_2_1 = t4_8 + minus_P_thetadot2_4_1;
  const T t4_9 = R4_12 * t4_6 - R4_22 * t4_7;
  const T minus_B7_2_2 = t4_9 + minus_P_thetadot2_4_2;
  const T t4_10 = minus_R4_13 * t4_6 + R4_23 * t4_7;
  const T minus_B7_2_3 = minus_P_thetadot2_4_3 - t4_10;
  v_y[55] = -minus_B7_2_1;
  v_y[61] = -minus_B7_2_2;
  v_y[67] = -minus_B7_2_3;
  // B8_3 = -R4^T r4~ omega_thetadot3_4 + P_thetadot3_4
  const T minus_B8_3_1 = t4_8 - t4_2;
  const T minus_B8_3_2 = t4_9 - t4_3;
  const T B8_3_3 = t4_1 + t4_10;
  v_y[56] = -minus_B8_3_1;
  v_y[62] = -minus_B8_3_2;
  v_y[68] = B8_3_3;

  // ---- body 5 (hand) on body 4
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T minus_E5_13 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - R3_31 * minus_E5_13;
  const T R5_12 = R4_12 * E5_11 - R3_32 * minus_E5_13;
  const T minus_R5_13 = minus_R4_13 * E5_11 + R3_33 * minus_E5_13;
  // omega_thetadot2_5 = E5 omega_thetadot2_4: partial angular velocity, body axes
  const T omega_thetadot2_5_1 = E5_11 * E4_12;

  // ---- body 6 (flange) on body 5
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T E6_12 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - minus_R4_21 * E6_12;
  const T R6_12 = R5_12 * E6_11 + R4_22 * E6_12;
  const T R6_13 = R4_23 * E6_12 - minus_R5_13 * E6_11;
  const T minus_R6_21 = minus_R4_21 * E6_11 + R5_11 * E6_12;
  const T R6_22 = R4_22 * E6_11 - R5_12 * E6_12;
  const T R6_23 = R4_23 * E6_11 + minus_R5_13 * E6_12;
  // omega_thetadot2_6 = E6 omega_thetadot2_5: partial angular velocity, body axes
  const T omega_thetadot2_6_1 = E6_11 * omega_thetadot2_5_1 + E6_12 * E4_11;
  const T omega_thetadot2_6_2 = E6_11 * E4_11 - E6_12 * omega_thetadot2_5_1;
  // omega_thetadot4_6 = E6 omega_thetadot4_5: partial angular velocity, body axes
  const T minus_omega_thetadot4_6_1 = E6_11 * minus_E5_13;
  const T omega_thetadot4_6_2 = E6_12 * minus_E5_13;
  // B13_1 = -R6^T r6~ omega_thetadot1_6 + P_thetadot1_4
  const T t6_1 = T(0.032) * R6_23;
  const T t6_2 = T(0.032) * R6_13;
  const T minus_B13_1_1 = minus_P_thetadot1_4_1 - R6_11 * t6_1 - minus_R6_21 * t6_2;
  const T minus_B13_1_2 = minus_P_thetadot1_4_2 + R6_22 * t6_2 - R6_12 * t6_1;
  const T minus_B13_1_3 = minus_P_thetadot1_3_3 + R6_23 * t6_2 - R6_13 * t6_1;
  v_y[90] = -minus_B13_1_1;
  v_y[96] = -minus_B13_1_2;
  v_y[102] = -minus_B13_1_3;
  // B14_2 = -R6^T r6~ omega_thetadot2_6 + P_thetadot2_4
  const T t6_3 = T(0.032) * omega_thetadot2_6_2;
  const T t6_4 = T(0.032) * omega_thetadot2_6_1;
  const T t6_5 = R6_11 * t6_3 + minus_R6_21 * t6_4;
  const T minus_B14_2_1 = minus_P_thetadot2_4_1 - t6_5;
  const T t6_6 = R6_22 * t6_4 - R6_12 * t6_3;
  const T minus_B14_2_2 = t6_6 + minus_P_thetadot2_4_2;
  const T t6_7 = R6_23 * t6_4 - R6_13 * t6_3;
  const T minus_B14_2_3 = t6_7 + minus_P_thetadot2_4_3;
  v_y[91] = -minus_B14_2_1;
  v_y[97] = -minus_B14_2_2;
  v_y[103] = -minus_B14_2_3;
  // B15_3 = -R6^T r6~ omega_thetadot3_6 + P_thetadot3_4
  const T B15_3_1 = t6_5 + t4_2;
  const T minus_B15_3_2 = t6_6 - t4_3;
  const T minus_B15_3_3 = t6_7 - t4_1;
  v_y[92] = B15_3_1;
  v_y[98] = -minus_B15_3_2;
  v_y[104] = -minus_B15_3_3;
  // B16_4 = -R6^T r6~ omega_thetadot4_6
  const T t6_8 = T(0.032) * minus_omega_thetadot4_6_1;
  const T t6_9 = T(0.032) * omega_thetadot4_6_2;
  const T minus_B16_4_1 = minus_R6_21 * t6_8 - R6_11 * t6_9;
  const T B16_4_2 = R6_12 * t6_9 + R6_22 * t6_8;
  const T B16_4_3 = R6_13 * t6_9 + R6_23 * t6_8;
  v_y[93] = -minus_B16_4_1;
  v_y[99] = B16_4_2;
  v_y[105] = B16_4_3;
  // B17_5 = -R6^T r6~ omega_thetadot5_6
  const T t6_10 = T(0.032) * E6_11;
  const T t6_11 = T(0.032) * E6_12;
  const T B17_5_1 = R6_11 * t6_10 + minus_R6_21 * t6_11;
  const T minus_B17_5_2 = R6_22 * t6_11 - R6_12 * t6_10;
  const T minus_B17_5_3 = R6_23 * t6_11 - R6_13 * t6_10;
  v_y[94] = B17_5_1;
  v_y[100] = -minus_B17_5_2;
  v_y[106] = -minus_B17_5_3;
  // B19_1 = -R6^T o7~ omega_thetadot1_6 - R6^T r7~ omega_thetadot1_6 + P_thetadot1_4
  const T t6_12 = T(0.0565) * R6_23;
  const T t6_13 = T(0.0565) * R6_13;
  const T t6_14 = T(0.05) * R6_23;
  const T t6_15 = T(0.05) * R6_13;
  const T minus_B19_1_1 = minus_P_thetadot1_4_1 - R6_11 * t6_12 - minus_R6_21 * t6_13 - R6_11 * t6_14 - minus_R6_21 *
      t6_15;
  const T minus_B19_1_2 = minus_P_thetadot1_4_2 + R6_22 * t6_13 - R6_12 * t6_12 + R6_22 * t6_15 - R6_12 * t6_14;
  const T minus_B19_1_3 = minus_P_thetadot1_3_3 + R6_23 * t6_13 - R6_13 * t6_12 + R6_23 * t6_15 - R6_13 * t6_14;
  v_y[108] = -minus_B19_1_1;
  v_y[114] = -minus_B19_1_2;
  v_y[120] = -minus_B19_1_3;
  // B20_2 = -R6^T o7~ omega_thetadot2_6 - R6^T r7~ omega_thetadot2_6 + P_thetadot2_4
  const T t6_16 = T(0.0565) * omega_thetadot2_6_2;
  const T t6_17 = T(0.0565) * omega_thetadot2_6_1;
  const T t6_18 = T(0.05) * omega_thetadot2_6_2;
  const T t6_19 = T(0.05) * omega_thetadot2_6_1;
  const T t6_20 = R6_11 * t6_16 + minus_R6_21 * t6_17 + R6_11 * t6_18 + minus_R6_21 * t6_19;
  const T minus_B20_2_1 = minus_P_thetadot2_4_1 - t6_20;
  const T t6_21 = R6_22 * t6_17 - R6_12 * t6_16 + R6_22 * t6_19 - R6_12 * t6_18;
  const T minus_B20_2_2 = t6_21 + minus_P_thetadot2_4_2;
  const T t6_22 = R6_23 * t6_17 - R6_13 * t6_16 + R6_23 * t6_19 - R6_13 * t6_18;
  const T minus_B20_2_3 = t6_22 + minus_P_thetadot2_4_3;
  v_y[109] = -minus_B20_2_1;
  v_y[115] = -minus_B20_2_2;
  v_y[121] = -minus_B20_2_3;
  // B21_3 = -R6^T o7~ omega_thetadot3_6 - R6^T r7~ omega_thetadot3_6 + P_thetadot3_4
  const T B21_3_1 = t6_20 + t4_2;
  const T minus_B21_3_2 = t6_21 - t4_3;
  const T minus_B21_3_3 = t6_22 - t4_1;
  v_y[110] = B21_3_1;
  v_y[116] = -minus_B21_3_2;
  v_y[122] = -minus_B21_3_3;
  // B22_4 = -R6^T o7~ omega_thetadot4_6 - R6^T r7~ omega_thetadot4_6
  const T t6_23 = T(0.0565) * minus_omega_thetadot4_6_1;
  const T t6_24 = T(0.0565) * omega_thetadot4_6_2;
  const T t6_25 = T(0.05) * minus_omega_thetadot4_6_1;
  const T t6_26 = T(0.05) * omega_thetadot4_6_2;
  const T minus_B22_4_1 = minus_R6_21 * t6_23 - R6_11 * t6_24 + minus_R6_21 * t6_25 - R6_11 * t6_26;
  const T B22_4_2 = R6_12 * t6_24 + R6_22 * t6_23 + R6_12 * t6_26 + R6_22 * t6_25;
  const T B22_4_3 = R6_13 * t6_24 + R6_23 * t6_23 + R6_13 * t6_26 + R6_23 * t6_25;
  v_y[111] = -minus_B22_4_1;
  v_y[117] = B22_4_2;
  v_y[123] = B22_4_3;
  // B23_5 = -R6^T o7~ omega_thetadot5_6 - R6^T r7~ omega_thetadot5_6
  const T t6_27 = T(0.0565) * E6_11;
  const T t6_28 = T(0.0565) * E6_12;
  const T t6_29 = T(0.05) * E6_11;
  const T t6_30 = T(0.05) * E6_12;
  const T B23_5_1 = R6_11 * t6_27 + minus_R6_21 * t6_28 + R6_11 * t6_29 + minus_R6_21 * t6_30;
  const T minus_B23_5_2 = R6_22 * t6_28 - R6_12 * t6_27 + R6_22 * t6_30 - R6_12 * t6_29;
  const T minus_B23_5_3 = R6_23 * t6_28 - R6_13 * t6_27 + R6_23 * t6_30 - R6_13 * t6_29;
  v_y[112] = B23_5_1;
  v_y[118] = -minus_B23_5_2;
  v_y[124] = -minus_B23_5_3;
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 360 add, 569 multiply, 12 sine or cosine
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  for (int i = 0; i < 126; ++i) v_y_dot[i] = T(0);
  T cosines[6], sines[6];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 6, cosines, sines);

  // ---- body 1 (waist) on the inertial frame
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];

  // ---- body 2 (upper_arm) on body 1
  const T thetadot1 = y[0];
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T R2_12 = E1_12 * E2_11;
  const T R2_31 = E1_11 * minus_E2_13;
  const T R2_32 = E1_12 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T minus_omega2_1 = minus_E2_13 * thetadot1;
  const T omega2_3 = E2_11 * thetadot1;
  // omega_dot_thetadot1_2 = -thetadot2 b2~ E2 b1: its rate
  const T minus_omega_dot_thetadot1_2_1 = thetadot2 * E2_11;
  const T minus_omega_dot_thetadot1_2_3 = thetadot2 * minus_E2_13;
  // P_dot_thetadot1_2 = -E1^T omega1~ q2~ b1: its rate
  const T t2_1 = thetadot1 * T(0.2435);
  const T P_dot_thetadot1_2_1 = E1_12 * t2_1;
  const T minus_P_dot_thetadot1_2_2 = E1_11 * t2_1;
  // B1_1 = -R2^T omega2~ (C2^T r2)~ omega_thetadot1_2 - R2^T (C2^T r2)~ omega_dot_thetadot1_2 + P_dot_thetadot1_2
  const T t2_2 = T(0.016) * E2_11;
  const T t2_3 = T(0.016) * minus_E2_13;
  const T t2_4 = omega2_3 * t2_2 + minus_omega2_1 * t2_3;
  const T t2_5 = T(0.006) * minus_E2_13 - T(0.068) * E2_11;
  const T t2_6 = omega2_3 * t2_5 + thetadot2 * t2_3;
  const T t2_7 = thetadot2 * t2_2 - minus_omega2_1 * t2_5;
  const T t2_8 = T(0.016) * minus_omega_dot_thetadot1_2_3;
  const T t2_9 = T(0.006) * minus_omega_dot_thetadot1_2_1 + T(0.068) * minus_omega_dot_thetadot1_2_3;
  const T t2_10 = T(0.016) * minus_omega_dot_thetadot1_2_1;
  const T minus_B1_1_1 = E1_12 * t2_4 - P_dot_thetadot1_2_1 - R2_11 * t2_6 + R2_31 * t2_7 + R2_11 * t2_8 - E1_12 *
      t2_9 - R2_31 * t2_10;
  const T minus_B1_1_2 = minus_P_dot_thetadot1_2_2 - R2_12 * t2_6 - E1_11 * t2_4 + R2_32 * t2_7 + R2_12 * t2_8 + E1_11
      * t2_9 - R2_32 * t2_10;
  const T minus_B1_1_3 = minus_E2_13 * t2_6 + E2_11 * t2_7 - minus_E2_13 * t2_8 - E2_11 * t2_10;
  v_y_dot[18] = -minus_B1_1_1;
  v_y_dot[24] = -minus_B1_1_2;
  v_y_dot[30] = -minus_B1_1_3;
  // B2_2 = -R2^T omega2~ (C2^T r2)~ b2
  const T t2_11 = thetadot2 * T(0.068);
  const T t2_12 = omega2_3 * T(0.006) + minus_omega2_1 * T(0.068);
  const T t2_13 = thetadot2 * T(0.006);
  const T minus_B2_2_1 = R2_11 * t2_11 - E1_12 * t2_12 - R2_31 * t2_13;
  const T minus_B2_2_2 = R2_12 * t2_11 + E1_11 * t2_12 - R2_32 * t2_13;
  const T B2_2_3 = minus_E2_13 * t2_11 + E2_11 * t2_13;
  v_y_dot[19] = -minus_B2_2_1;
  v_y_dot[25] = -minus_B2_2_2;
  v_y_dot[31] = B2_2_3;

  // ---- body 3 (forearm) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T minus_E3_13 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R2_12 * E3_11 - R2_32 * minus_E3_13;
  const T minus_R3_13 = minus_E2_13 * E3_11 + E2_11 * minus_E3_13;
  const T R3_31 = R2_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R2_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = E2_11 * E3_11 - minus_E2_13 * minus_E3_13;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T minus_omega3_1 = E3_11 * minus_omega2_1 + minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + thetadot2;
  const T omega3_3 = E3_11 * omega2_3 - minus_E3_13 * minus_omega2_1;
  // omega_dot_thetadot1_3 = -thetadot3 b3~ E3 omega_thetadot1_2 + E3 omega_dot_thetadot1_2: its rate
  const T omega_dot_thetadot1_3_1 = minus_E3_13 * minus_omega_dot_thetadot1_2_3 - E3_11 *
      minus_omega_dot_thetadot1_2_1 - thetadot3 * R3_33;
  const T minus_omega_dot_thetadot1_3_3 = thetadot3 * minus_R3_13 + minus_E3_13 * minus_omega_dot_thetadot1_2_1 +
      E3_11 * minus_omega_dot_thetadot1_2_3;
  // P_dot_thetadot1_3 = R2^T (-omega2~ q3~ omega_thetadot1_2 - q3~ omega_dot_thetadot1_2) + P_dot_thetadot1_2: its
  //   rate
  const T t3_1 = T(0.4318) * E2_11;
  const T t3_2 = T(0.0934) * minus_E2_13;
  const T t3_3 = omega2_3 * t3_1 - thetadot2 * t3_2 + T(0.0934) * minus_omega_dot_thetadot1_2_3;
  const T t3_4 = T(0.0934) * E2_11;
  const T t3_5 = T(0.4318) * minus_omega_dot_thetadot1_2_3 - (omega2_3 * t3_4 + minus_omega2_1 * t3_2);
  const T t3_6 = minus_omega2_1 * t3_1 + thetadot2 * t3_4 - T(0.0934) * minus_omega_dot_thetadot1_2_1;
  const T minus_P_dot_thetadot1_3_1 = R2_11 * t3_3 - P_dot_thetadot1_2_1 - E1_12 * t3_5 + R2_31 * t3_6;
  const T minus_P_dot_thetadot1_3_2 = minus_P_dot_thetadot1_2_2 + R2_12 * t3_3 + E1_11 * t3_5 + R2_32 * t3_6;
  const T minus_P_dot_thetadot1_3_3 = E2_11 * t3_6 - minus_E2_13 * t3_3;
  // P_dot_thetadot2_3 = -R2^T omega2~ q3~ b2: its rate
  const T t3_7 = thetadot2 * T(0.4318);
  const T t3_8 = minus_omega2_1 * T(0.4318);
  const T minus_P_dot_thetadot2_3_1 = R2_11 * t3_7 - E1_12 * t3_8;
  const T minus_P_dot_thetadot2_3_2 = R2_12 * t3_7 + E1_11 * t3_8;
  const T P_dot_thetadot2_3_3 = minus_E2_13 * t3_7;
  // B3_1 = -R3^T omega3~ (C3^T r3)~ omega_thetadot1_3 - R3^T (C3^T r3)~ omega_dot_thetadot1_3 + P_dot_thetadot1_3
  const T t3_9 = T(0.07) * minus_R3_13;
  const T t3_10 = T(0.014) * minus_R3_13;
  const T t3_11 = omega3_3 * t3_9 + omega3_2 * t3_10;
  const T t3_12 = T(0.014) * R3_33;
  const T t3_13 = omega3_3 * t3_12 + minus_omega3_1 * t3_10;
  const T t3_14 = minus_omega3_1 * t3_9 - omega3_2 * t3_12;
  const T t3_15 = T(0.014) * minus_omega_dot_thetadot1_3_3;
  const T t3_16 = T(0.07) * omega_dot_thetadot1_3_1;
  const T t3_17 = T(0.014) * omega_dot_thetadot1_3_1;
  const T minus_B3_1_1 = minus_P_dot_thetadot1_3_1 + R3_11 * t3_11 - E1_12 * t3_13 + R3_31 * t3_14 - R3_11 * t3_15 -
      E1_12 * t3_16 - R3_31 * t3_17;
  const T minus_B3_1_2 = minus_P_dot_thetadot1_3_2 + R3_12 * t3_11 + E1_11 * t3_13 + R3_32 * t3_14 + E1_11 * t3_16 -
      R3_12 * t3_15 - R3_32 * t3_17;
  const T minus_B3_1_3 = minus_P_dot_thetadot1_3_3 + R3_33 * t3_14 - minus_R3_13 * t3_11 + minus_R3_13 * t3_15 - R3_33
      * t3_17;
  v_y_dot[36] = -minus_B3_1_1;
  v_y_dot[42] = -minus_B3_1_2;
  v_y_dot[48] = -minus_B3_1_3;
  // B4_2 = -R3^T omega3~ (C3^T r3)~ omega_thetadot2_3 - R3^T (C3^T r3)~ omega_dot_thetadot2_3 + P_dot_thetadot2_3
  const T t3_18 = omega3_3 * T(0.07);
  const T t3_19 = omega3_2 * T(0.07);
  const T t3_20 = E1_12 * t3_18 + R3_31 * t3_19;
  const T minus_B4_2_1 = t3_20 + minus_P_dot_thetadot2_3_1;
  const T t3_21 = R3_32 * t3_19 - E1_11 * t3_18;
  const T minus_B4_2_2 = t3_21 + minus_P_dot_thetadot2_3_2;
  const T t3_22 = R3_33 * t3_19;
  const T minus_B4_2_3 = t3_22 - P_dot_thetadot2_3_3;
  v_y_dot[37] = -minus_B4_2_1;
  v_y_dot[43] = -minus_B4_2_2;
  v_y_dot[49] = -minus_B4_2_3;
  v_y_dot[38] = -t3_20;
  v_y_dot[44] = -t3_21;
  v_y_dot[50] = -t3_22;

  // ---- body 4 (wrist) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_12 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - E1_12 * E4_12;
  const T R4_12 = R3_12 * E4_11 + E1_11 * E4_12;
  const T minus_R4_13 = minus_R3_13 * E4_11;
  const T minus_R4_21 = E1_12 * E4_11 + R3_11 * E4_12;
  const T R4_22 = E1_11 * E4_11 - R3_12 * E4_12;
  const T R4_23 = minus_R3_13 * E4_12;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega3_2 - E4_11 * minus_omega3_1;
  const T omega4_2 = E4_11 * omega3_2 + E4_12 * minus_omega3_1;
  const T omega4_3 = thetadot4 + omega3_3;
  // omega_dot_thetadot1_4 = -thetadot4 b4~ E4 omega_thetadot1_3 + E4 omega_dot_thetadot1_3: its rate
  const T omega_dot_thetadot1_4_1 = thetadot4 * R4_23 + E4_11 * omega_dot_thetadot1_3_1;
  const T omega_dot_thetadot1_4_2 = thetadot4 * minus_R4_13 - E4_12 * omega_dot_thetadot1_3_1;
  // omega_dot_thetadot2_4 = -thetadot4 b4~ E4 omega_thetadot2_3 + E4 omega_dot_thetadot2_3: its rate
  const T omega_dot_thetadot2_4_1 = thetadot4 * E4_11;
  const T minus_omega_dot_thetadot2_4_2 = thetadot4 * E4_12;
  // P_dot_thetadot1_4 = R3^T (-omega3~ q4~ omega_thetadot1_3 - q4~ omega_dot_thetadot1_3) + P_dot_thetadot1_3: its
  //   rate
  const T t4_1 = T(0.0203) * R3_33 - T(0.4331) * minus_R3_13;
  const T t4_2 = omega3_3 * t4_1;
  const T t4_3 = T(0.4331) * omega_dot_thetadot1_3_1 - T(0.0203) * minus_omega_dot_thetadot1_3_3;
  const T t4_4 = minus_omega3_1 * t4_1;
  const T minus_P_dot_thetadot1_4_1 = minus_P_dot_thetadot1_3_1 - R3_11 * t4_2 - E1_12 * t4_3 - R3_31 * t4_4;
  const T minus_P_dot_thetadot1_4_2 = minus_P_dot_thetadot1_3_2 + E1_11 * t4_3 - R3_12 * t4_2 - R3_32 * t4_4;
  const T minus_P_dot_thetadot1_4_3 = minus_P_dot_thetadot1_3_3 + minus_R3_13 * t4_2 - R3_33 * t4_4;
  v_y_dot[72] = -minus_P_dot_thetadot1_4_1;
  v_y_dot[78] = -minus_P_dot_thetadot1_4_2;
  v_y_dot[84] = -minus_P_dot_thetadot1_4_3;
  // P_dot_thetadot2_4 = R3^T (-omega3~ q4~ omega_thetadot2_3 - q4~ omega_dot_thetadot2_3) + P_dot_thetadot2_3: its
  //   rate
  const T t4_5 = omega3_3 * T(0.4331) + minus_omega3_1 * T(0.0203);
  const T t4_6 = omega3_2 * T(0.0203);
  const T t4_7 = omega3_2 * T(0.4331);
  const T t4_8 = E1_12 * t4_5 - R3_11 * t4_6 + R3_31 * t4_7;
  const T minus_P_dot_thetadot2_4_1 = t4_8 + minus_P_dot_thetadot2_3_1;
  const T t4_9 = R3_32 * t4_7 - (R3_12 * t4_6 + E1_11 * t4_5);
  const T minus_P_dot_thetadot2_4_2 = t4_9 + minus_P_dot_thetadot2_3_2;
  const T t4_10 = minus_R3_13 * t4_6 + R3_33 * t4_7;
  const T minus_P_dot_thetadot2_4_3 = t4_10 - P_dot_thetadot2_3_3;
  v_y_dot[73] = -minus_P_dot_thetadot2_4_1;
  v_y_dot[79] = -minus_P_dot_thetadot2_4_2;
  v_y_dot[85] = -minus_P_dot_thetadot2_4_3;
  v_y_dot[74] = -t4_8;
  v_y_dot[80] = -t4_9;
  v_y_dot[86] = -t4_10;
  // B6_1 = -R4^T omega4~ r4~ omega_thetadot1_4 - R4^T r4~ omega_dot_thetadot1_4 + P_dot_thetadot1_4
  const T t4_11 = T(0.019) * minus_R4_13;
  const T t4_12 = omega4_3 * t4_11;
  const T t4_13 = T(0.019) * R4_23;
  const T t4_14 = omega4_3 * t4_13;
  const T t4_15 = omega4_1 * t4_11 - omega4_2 * t4_13;
  const T t4_16 = T(0.019) * omega_dot_thetadot1_4_2;
  const T t4_17 = T(0.019) * omega_dot_thetadot1_4_1;
  const T minus_B6_1_1 = minus_P_dot_thetadot1_4_1 - R4_11 * t4_12 - minus_R4_21 * t4_14 + R3_31 * t4_15 + R4_11 *
      t4_16 + minus_R4_21 * t4_17;
  const T minus_B6_1_2 = minus_P_dot_thetadot1_4_2 + R4_22 * t4_14 - R4_12 * t4_12 + R3_32 * t4_15 + R4_12 * t4_16 -
      R4_22 * t4_17;
  const T minus_B6_1_3 = minus_P_dot_thetadot1_4_3 + minus_R4_13 * t4_12 + R4_23 * t4_14 + R3_33 * t4_15 - minus_R4_13
      * t4_16 - R4_23 * t4_17;
  v_y_dot[54] = -minus_B6_1_1;
  v_y_dot[60] = -minus_B6_1_2;
  v_y_dot[66] = -minus_B6_1_3;
  // B7_2 = -R4^T omega4~ r4~ omega_thetadot2_4 - R4^T r4~ omega_dot_thetadot2_4 + P_dot_thetadot2_4
  const T t4_18 = T(0.019) * E4_12;
  const T t4_19 = omega4_3 * t4_18;
  const T t4_20 = T(0.019) * E4_11;
  const T t4_21 = omega4_3 * t4_20;
  const T t4_22 = omega4_1 * t4_18 + omega4_2 * t4_20;
  const T t4_23 = T(0.019) * omega_dot_thetadot2_4_1;
  const T t4_24 = T(0.019) * minus_omega_dot_thetadot2_4_2;
  const T t4_25 = R4_11 * t4_19 - minus_R4_21 * t4_21 - R3_31 * t4_22 + minus_R4_21 * t4_23 - R4_11 * t4_24;
  const T minus_B7_2_1 = t4_25 + minus_P_dot_thetadot2_4_1;
  const T t4_26 = R4_12 * t4_19 + R4_22 * t4_21 - R3_32 * t4_22 - R4_12 * t4_24 - R4_22 * t4_23;
  const T minus_B7_2_2 = t4_26 + minus_P_dot_thetadot2_4_2;
  const T t4_27 = R4_23 * t4_21 - minus_R4_13 * t4_19 - R3_33 * t4_22 + minus_R4_13 * t4_24 - R4_23 * t4_23;
  const T minus_B7_2_3 = t4_27 + minus_P_dot_thetadot2_4_3;
  v_y_dot[55] = -minus_B7_2_1;
  v_y_dot[61] = -minus_B7_2_2;
  v_y_dot[67] = -minus_B7_2_3;
  // B8_3 = -R4^T omega4~ r4~ omega_thetadot3_4 - R4^T r4~ omega_dot_thetadot3_4 + P_dot_thetadot3_4
  const T minus_B8_3_1 = t4_25 + t4_8;
  const T minus_B8_3_2 = t4_26 + t4_9;
  const T minus_B8_3_3 = t4_27 + t4_10;
  v_y_dot[56] = -minus_B8_3_1;
  v_y_dot[62] = -minus_B8_3_2;
  v_y_dot[68] = -minus_B8_3_3;

  // ---- body 5 (hand) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T minus_E5_13 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - R3_31 * minus_E5_13;
  const T R5_12 = R4_12 * E5_11 - R3_32 * minus_E5_13;
  const T minus_R5_13 = minus_R4_13 * E5_11 + R3_33 * minus_E5_13;
  const T R5_31 = R4_11 * minus_E5_13 + R3_31 * E5_11;
  const T R5_32 = R4_12 * minus_E5_13 + R3_32 * E5_11;
  const T R5_33 = R3_33 * E5_11 - minus_R4_13 * minus_E5_13;
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 - minus_E5_13 * omega4_3;
  const T omega5_2 = thetadot5 + omega4_2;
  const T omega5_3 = minus_E5_13 * omega4_1 + E5_11 * omega4_3;
  // omega_dot_thetadot1_5 = -thetadot5 b5~ E5 omega_thetadot1_4 + E5 omega_dot_thetadot1_4: its rate
  const T omega_dot_thetadot1_5_1 = E5_11 * omega_dot_thetadot1_4_1 + minus_E5_13 * minus_omega_dot_thetadot1_3_3 -
      thetadot5 * R5_33;
  // omega_thetadot2_5 = E5 omega_thetadot2_4: partial angular velocity, body axes
  const T omega_thetadot2_5_1 = E5_11 * E4_12;
  const T omega_thetadot2_5_3 = minus_E5_13 * E4_12;
  // omega_dot_thetadot2_5 = -thetadot5 b5~ E5 omega_thetadot2_4 + E5 omega_dot_thetadot2_4: its rate
  const T omega_dot_thetadot2_5_1 = E5_11 * omega_dot_thetadot2_4_1 - thetadot5 * omega_thetadot2_5_3;
  // omega_dot_thetadot4_5 = -thetadot5 b5~ E5 b4: its rate
  const T minus_omega_dot_thetadot4_5_1 = thetadot5 * E5_11;

  // ---- body 6 (flange) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T E6_12 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - minus_R4_21 * E6_12;
  const T R6_12 = R5_12 * E6_11 + R4_22 * E6_12;
  const T R6_13 = R4_23 * E6_12 - minus_R5_13 * E6_11;
  const T minus_R6_21 = minus_R4_21 * E6_11 + R5_11 * E6_12;
  const T R6_22 = R4_22 * E6_11 - R5_12 * E6_12;
  const T R6_23 = R4_23 * E6_11 + minus_R5_13 * E6_12;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 + E6_12 * omega5_2;
  const T omega6_2 = E6_11 * omega5_2 - E6_12 * omega5_1;
  const T omega6_3 = thetadot6 + omega5_3;
  // omega_dot_thetadot1_6 = -thetadot6 b6~ E6 omega_thetadot1_5 + E6 omega_dot_thetadot1_5: its rate
  const T omega_dot_thetadot1_6_1 = thetadot6 * R6_23 + E6_11 * omega_dot_thetadot1_5_1 + E6_12 *
      omega_dot_thetadot1_4_2;
  const T omega_dot_thetadot1_6_2 = E6_11 * omega_dot_thetadot1_4_2 - E6_12 * omega_dot_thetadot1_5_1 - thetadot6 *
      R6_13;
  // omega_thetadot2_6 = E6 omega_thetadot2_5: partial angular velocity, body axes
  const T omega_thetadot2_6_1 = E6_11 * omega_thetadot2_5_1 + E6_12 * E4_11;
  const T omega_thetadot2_6_2 = E6_11 * E4_11 - E6_12 * omega_thetadot2_5_1;
  // omega_dot_thetadot2_6 = -thetadot6 b6~ E6 omega_thetadot2_5 + E6 omega_dot_thetadot2_5: its rate
  const T omega_dot_thetadot2_6_1 = thetadot6 * omega_thetadot2_6_2 + E6_11 * omega_dot_thetadot2_5_1 - E6_12 *
      minus_omega_dot_thetadot2_4_2;
  const T minus_omega_dot_thetadot2_6_2 = thetadot6 * omega_thetadot2_6_1 + E6_11 * minus_omega_dot_thetadot2_4_2 +
      E6_12 * omega_dot_thetadot2_5_1;
  // omega_thetadot4_6 = E6 omega_thetadot4_5: partial angular velocity, body axes
  const T minus_omega_thetadot4_6_1 = E6_11 * minus_E5_13;
  const T omega_thetadot4_6_2 = E6_12 * minus_E5_13;
  // omega_dot_thetadot4_6 = -thetadot6 b6~ E6 omega_thetadot4_5 + E6 omega_dot_thetadot4_5: its rate
  const T omega_dot_thetadot4_6_1 = thetadot6 * omega_thetadot4_6_2 - E6_11 * minus_omega_dot_thetadot4_5_1;
  const T omega_dot_thetadot4_6_2 = thetadot6 * minus_omega_thetadot4_6_1 + E6_12 * minus_omega_dot_thetadot4_5_1;
  // omega_dot_thetadot5_6 = -thetadot6 b6~ E6 b5: its rate
  const T omega_dot_thetadot5_6_1 = thetadot6 * E6_11;
  const T minus_omega_dot_thetadot5_6_2 = thetadot6 * E6_12;
  // B13_1 = -R6^T omega6~ r6~ omega_thetadot1_6 - R6^T r6~ omega_dot_thetadot1_6 + P_dot_thetadot1_4
  const T t6_1 = T(0.032) * R6_23;
  const T t6_2 = omega6_3 * t6_1;
  const T t6_3 = T(0.032) * R6_13;
  const T t6_4 = omega6_3 * t6_3;
  const T t6_5 = omega6_1 * t6_3 + omega6_2 * t6_1;
  const T t6_6 = T(0.032) * omega_dot_thetadot1_6_2;
  const T t6_7 = T(0.032) * omega_dot_thetadot1_6_1;
  const T minus_B13_1_1 = minus_P_dot_thetadot1_4_1 + minus_R6_21 * t6_2 - R6_11 * t6_4 + R5_31 * t6_5 - R6_11 * t6_6
      - minus_R6_21 * t6_7;
  const T minus_B13_1_2 = minus_P_dot_thetadot1_4_2 - R6_12 * t6_4 - R6_22 * t6_2 + R5_32 * t6_5 + R6_22 * t6_7 -
      R6_12 * t6_6;
  const T minus_B13_1_3 = minus_P_dot_thetadot1_4_3 - R6_13 * t6_4 - R6_23 * t6_2 + R5_33 * t6_5 + R6_23 * t6_7 -
      R6_13 * t6_6;
  v_y_dot[90] = -minus_B13_1_1;
  v_y_dot[96] = -minus_B13_1_2;
  v_y_dot[102] = -minus_B13_1_3;
  // B14_2 = -R6^T omega6~ r6~ omega_thetadot2_6 - R6^T r6~ omega_dot_thetadot2_6 + P_dot_thetadot2_4
  const T t6_8 = T(0.032) * omega_thetadot2_6_2;
  const T t6_9 = omega6_3 * t6_8;
  const T t6_10 = T(0.032) * omega_thetadot2_6_1;
  const T t6_11 = omega6_3 * t6_10;
  const T t6_12 = omega6_1 * t6_10 + omega6_2 * t6_8;
  const T t6_13 = T(0.032) * minus_omega_dot_thetadot2_6_2;
  const T t6_14 = T(0.032) * omega_dot_thetadot2_6_1;
  const T t6_15 = minus_R6_21 * t6_9 - R6_11 * t6_11 + R5_31 * t6_12 + R6_11 * t6_13 - minus_R6_21 * t6_14;
  const T minus_B14_2_1 = t6_15 + minus_P_dot_thetadot2_4_1;
  const T t6_16 = R5_32 * t6_12 - (R6_12 * t6_11 + R6_22 * t6_9) + R6_12 * t6_13 + R6_22 * t6_14;
  const T minus_B14_2_2 = t6_16 + minus_P_dot_thetadot2_4_2;
  const T t6_17 = R5_33 * t6_12 - (R6_13 * t6_11 + R6_23 * t6_9) + R6_13 * t6_13 + R6_23 * t6_14;
  const T minus_B14_2_3 = t6_17 + minus_P_dot_thetadot2_4_3;
  v_y_dot[91] = -minus_B14_2_1;
  v_y_dot[97] = -minus_B14_2_2;
  v_y_dot[103] = -minus_B14_2_3;
  // B15_3 = -R6^T omega6~ r6~ omega_thetadot3_6 - R6^T r6~ omega_dot_thetadot3_6 + P_dot_thetadot3_4
  const T minus_B15_3_1 = t6_15 + t4_8;
  const T minus_B15_3_2 = t6_16 + t4_9;
  const T minus_B15_3_3 = t6_17 + t4_10;
  v_y_dot[92] = -minus_B15_3_1;
  v_y_dot[98] = -minus_B15_3_2;
  v_y_dot[104] = -minus_B15_3_3;
  // B16_4 = -R6^T omega6~ r6~ omega_thetadot4_6 - R6^T r6~ omega_dot_thetadot4_6
  const T t6_18 = T(0.032) * minus_omega_thetadot4_6_1;
  const T t6_19 = omega6_3 * t6_18;
  const T t6_20 = T(0.032) * omega_thetadot4_6_2;
  const T t6_21 = omega6_3 * t6_20;
  const T t6_22 = omega6_2 * t6_20 - omega6_1 * t6_18;
  const T t6_23 = T(0.032) * omega_dot_thetadot4_6_2;
  const T t6_24 = T(0.032) * omega_dot_thetadot4_6_1;
  const T minus_B16_4_1 = R6_11 * t6_19 + minus_R6_21 * t6_21 + R5_31 * t6_22 - R6_11 * t6_23 - minus_R6_21 * t6_24;
  const T minus_B16_4_2 = R6_12 * t6_19 - R6_22 * t6_21 + R5_32 * t6_22 + R6_22 * t6_24 - R6_12 * t6_23;
  const T minus_B16_4_3 = R6_13 * t6_19 - R6_23 * t6_21 + R5_33 * t6_22 + R6_23 * t6_24 - R6_13 * t6_23;
  v_y_dot[93] = -minus_B16_4_1;
  v_y_dot[99] = -minus_B16_4_2;
  v_y_dot[105] = -minus_B16_4_3;
  // B17_5 = -R6^T omega6~ r6~ omega_thetadot5_6 - R6^T r6~ omega_dot_thetadot5_6
  const T t6_25 = T(0.032) * E6_11;
  const T t6_26 = omega6_3 * t6_25;
  const T t6_27 = T(0.032) * E6_12;
  const T t6_28 = omega6_3 * t6_27;
  const T t6_29 = omega6_1 * t6_27 + omega6_2 * t6_25;
  const T t6_30 = T(0.032) * minus_omega_dot_thetadot5_6_2;
  const T t6_31 = T(0.032) * omega_dot_thetadot5_6_1;
  const T minus_B17_5_1 = minus_R6_21 * t6_26 - R6_11 * t6_28 + R5_31 * t6_29 + R6_11 * t6_30 - minus_R6_21 * t6_31;
  const T minus_B17_5_2 = R5_32 * t6_29 - (R6_12 * t6_28 + R6_22 * t6_26) + R6_12 * t6_30 + R6_22 * t6_31;
  const T minus_B17_5_3 = R5_33 * t6_29 - (R6_13 * t6_28 + R6_23 * t6_26) + R6_13 * t6_30 + R6_23 * t6_31;
  v_y_dot[94] = -minus_B17_5_1;
  v_y_dot[100] = -minus_B17_5_2;
  v_y_dot[106] = -minus_B17_5_3;
  // B19_1 = -R6^T omega6~ o7~ omega_thetadot1_6 - R6^T omega6~ r7~ omega_thetadot1_6 - R6^T o7~ omega_dot_thetadot1_6
  //   - R6^T r7~ omega_dot_thetadot1_6 + P_dot_thetadot1_4
  const T t6_32 = T(0.0565) * R6_23;
  const T t6_33 = omega6_3 * t6_32;
  const T t6_34 = T(0.0565) * R6_13;
  const T t6_35 = omega6_3 * t6_34;
  const T t6_36 = omega6_1 * t6_34 + omega6_2 * t6_32;
  const T t6_37 = T(0.05) * R6_23;
  const T t6_38 = omega6_3 * t6_37;
  const T t6_39 = T(0.05) * R6_13;
  const T t6_40 = omega6_3 * t6_39;
  const T t6_41 = omega6_1 * t6_39 + omega6_2 * t6_37;
  const T t6_42 = T(0.0565) * omega_dot_thetadot1_6_2;
  const T t6_43 = T(0.0565) * omega_dot_thetadot1_6_1;
  const T t6_44 = T(0.05) * omega_dot_thetadot1_6_2;
  const T t6_45 = T(0.05) * omega_dot_thetadot1_6_1;
  const T minus_B19_1_1 = minus_P_dot_thetadot1_4_1 + minus_R6_21 * t6_33 - R6_11 * t6_35 + R5_31 * t6_36 +
      minus_R6_21 * t6_38 - R6_11 * t6_40 + R5_31 * t6_41 - R6_11 * t6_42 - minus_R6_21 * t6_43 - R6_11 * t6_44 -
      minus_R6_21 * t6_45;
  const T minus_B19_1_2 = minus_P_dot_thetadot1_4_2 - R6_12 * t6_35 - R6_22 * t6_33 + R5_32 * t6_36 - R6_12 * t6_40 -
      R6_22 * t6_38 + R5_32 * t6_41 + R6_22 * t6_43 - R6_12 * t6_42 + R6_22 * t6_45 - R6_12 * t6_44;
  const T minus_B19_1_3 = minus_P_dot_thetadot1_4_3 - R6_13 * t6_35 - R6_23 * t6_33 + R5_33 * t6_36 - R6_13 * t6_40 -
      R6_23 * t6_38 + R5_33 * t6_41 + R6_23 * t6_43 - R6_13 * t6_42 + R6_23 * t6_45 - R6_13 * t6_44;
  v_y_dot[108] = -minus_B19_1_1;
  v_y_dot[114] = -minus_B19_1_2;
  v_y_dot[120] = -minus_B19_1_3;
  // B20_2 = -R6^T omega6~ o7~ omega_thetadot2_6 - R6^T omega6~ r7~ omega_thetadot2_6 - R6^T o7~ omega_dot_thetadot2_6
  //   - R6^T r7~ omega_dot_thetadot2_6 + P_dot_thetadot2_4
  const T t6_46 = T(0.0565) * omega_thetadot2_6_2;
  const T t6_47 = omega6_3 * t6_46;
  const T t6_48 = T(0.0565) * omega_thetadot2_6_1;
  const T t6_49 = omega6_3 * t6_48;
  const T t6_50 = omega6_1 * t6_48 + omega6_2 * t6_46;
  const T t6_51 = T(0.05) * omega_thetadot2_6_2;
  const T t6_52 = omega6_3 * t6_51;
  const T t6_53 = T(0.05) * omega_thetadot2_6_1;
  const T t6_54 = omega6_3 * t6_53;
  const T t6_55 = omega6_1 * t6_53 + omega6_2 * t6_51;
  const T t6_56 = T(0.0565) * minus_omega_dot_thetadot2_6_2;
  const T t6_57 = T(0.0565) * omega_dot_thetadot2_6_1;
  const T t6_58 = T(0.05) * minus_omega_dot_thetadot2_6_2;
  const T t6_59 = T(0.05) * omega_dot_thetadot2_6_1;
  const T t6_60 = minus_R6_21 * t6_47 - R6_11 * t6_49 + R5_31 * t6_50 + minus_R6_21 * t6_52 - R6_11 * t6_54 + R5_31 *
      t6_55 + R6_11 * t6_56 - minus_R6_21 * t6_57 + R6_11 * t6_58 - minus_R6_21 * t6_59;
  const T minus_B20_2_1 = t6_60 + minus_P_dot_thetadot2_4_1;
  const T t6_61 = R5_32 * t6_50 - (R6_12 * t6_49 + R6_22 * t6_47) - R6_12 * t6_54 - R6_22 * t6_52 + R5_32 * t6_55 +
      R6_12 * t6_56 + R6_22 * t6_57 + R6_12 * t6_58 + R6_22 * t6_59;
  const T minus_B20_2_2 = t6_61 + minus_P_dot_thetadot2_4_2;
  const T t6_62 = R5_33 * t6_50 - (R6_13 * t6_49 + R6_23 * t6_47) - R6_13 * t6_54 - R6_23 * t6_52 + R5_33 * t6_55 +
      R6_13 * t6_56 + R6_23 * t6_57 + R6_13 * t6_58 + R6_23 * t6_59;
  const T minus_B20_2_3 = t6_62 + minus_P_dot_thetadot2_4_3;
  v_y_dot[109] = -minus_B20_2_1;
  v_y_dot[115] = -minus_B20_2_2;
  v_y_dot[121] = -minus_B20_2_3;
  // B21_3 = -R6^T omega6~ o7~ omega_thetadot3_6 - R6^T omega6~ r7~ omega_thetadot3_6 - R6^T o7~ omega_dot_thetadot3_6
  //   - R6^T r7~ omega_dot_thetadot3_6 + P_dot_thetadot3_4
  const T minus_B21_3_1 = t6_60 + t4_8;
  const T minus_B21_3_2 = t6_61 + t4_9;
  const T minus_B21_3_3 = t6_62 + t4_10;
  v_y_dot[110] = -minus_B21_3_1;
  v_y_dot[116] = -minus_B21_3_2;
  v_y_dot[122] = -minus_B21_3_3;
  // B22_4 = -R6^T omega6~ o7~ omega_thetadot4_6 - R6^T omega6~ r7~ omega_thetadot4_6 - R6^T o7~ omega_dot_thetadot4_6
  //   - R6^T r7~ omega_dot_thetadot4_6
  const T t6_63 = T(0.0565) * minus_omega_thetadot4_6_1;
  const T t6_64 = omega6_3 * t6_63;
  const T t6_65 = T(0.0565) * omega_thetadot4_6_2;
  const T t6_66 = omega6_3 * t6_65;
  const T t6_67 = omega6_2 * t6_65 - omega6_1 * t6_63;
  const T t6_68 = T(0.05) * minus_omega_thetadot4_6_1;
  const T t6_69 = omega6_3 * t6_68;
  const T t6_70 = T(0.05) * omega_thetadot4_6_2;
  const T t6_71 = omega6_3 * t6_70;
  const T t6_72 = omega6_2 * t6_70 - omega6_1 * t6_68;
  const T t6_73 = T(0.0565) * omega_dot_thetadot4_6_2;
  const T t6_74 = T(0.0565) * omega_dot_thetadot4_6_1;
  const T t6_75 = T(0.05) * omega_dot_thetadot4_6_2;
  const T t6_76 = T(0.05) * omega_dot_thetadot4_6_1;
  const T minus_B22_4_1 = R6_11 * t6_64 + minus_R6_21 * t6_66 + R5_31 * t6_67 + R6_11 * t6_69 + minus_R6_21 * t6_71 +
      R5_31 * t6_72 - R6_11 * t6_73 - minus_R6_21 * t6_74 - R6_11 * t6_75 - minus_R6_21 * t6_76;
  const T minus_B22_4_2 = R6_12 * t6_64 - R6_22 * t6_66 + R5_32 * t6_67 + R6_12 * t6_69 - R6_22 * t6_71 + R5_32 *
      t6_72 + R6_22 * t6_74 - R6_12 * t6_73 + R6_22 * t6_76 - R6_12 * t6_75;
  const T minus_B22_4_3 = R6_13 * t6_64 - R6_23 * t6_66 + R5_33 * t6_67 + R6_13 * t6_69 - R6_23 * t6_71 + R5_33 *
      t6_72 + R6_23 * t6_74 - R6_13 * t6_73 + R6_23 * t6_76 - R6_13 * t6_75;
  v_y_dot[111] = -minus_B22_4_1;
  v_y_dot[117] = -minus_B22_4_2;
  v_y_dot[123] = -minus_B22_4_3;
  // B23_5 = -R6^T omega6~ o7~ omega_thetadot5_6 - R6^T omega6~ r7~ omega_thetadot5_6 - R6^T o7~ omega_dot_thetadot5_6
  //   - R6^T r7~ omega_dot_thetadot5_6
  const T t6_77 = T(0.0565) * E6_11;
  const T t6_78 = omega6_3 * t6_77;
  const T t6_79 = T(0.0565) * E6_12;
  const T t6_80 = omega6_3 * t6_79;
  const T t6_81 = omega6_1 * t6_79 + omega6_2 * t6_77;
  const T t6_82 = T(0.05) * E6_11;
  const T t6_83 = omega6_3 * t6_82;
  const T t6_84 = T(0.05) * E6_12;
  const T t6_85 = omega6_3 * t6_84;
  const T t6_86 = omega6_1 * t6_84 + omega6_2 * t6_82;
  const T t6_87 = T(0.0565) * minus_omega_dot_thetadot5_6_2;
  const T t6_88 = T(0.0565) * omega_dot_thetadot5_6_1;
  const T t6_89 = T(0.05) * minus_omega_dot_thetadot5_6_2;
  const T t6_90 = T(0.05) * omega_dot_thetadot5_6_1;
  const T minus_B23_5_1 = minus_R6_21 * t6_78 - R6_11 * t6_80 + R5_31 * t6_81 + minus_R6_21 * t6_83 - R6_11 * t6_85 +
      R5_31 * t6_86 + R6_11 * t6_87 - minus_R6_21 * t6_88 + R6_11 * t6_89 - minus_R6_21 * t6_90;
  const T minus_B23_5_2 = R5_32 * t6_81 - (R6_12 * t6_80 + R6_22 * t6_78) - R6_12 * t6_85 - R6_22 * t6_83 + R5_32 *
      t6_86 + R6_12 * t6_87 + R6_22 * t6_88 + R6_12 * t6_89 + R6_22 * t6_90;
  const T minus_B23_5_3 = R5_33 * t6_81 - (R6_13 * t6_80 + R6_23 * t6_78) - R6_13 * t6_85 - R6_23 * t6_83 + R5_33 *
      t6_86 + R6_13 * t6_87 + R6_23 * t6_88 + R6_13 * t6_89 + R6_23 * t6_90;
  v_y_dot[112] = -minus_B23_5_1;
  v_y_dot[118] = -minus_B23_5_2;
  v_y_dot[124] = -minus_B23_5_3;
}

}  // namespace kanec::arm_6
