// SPDX-License-Identifier: BSD-3-Clause
// arm_7: equations of motion of 7 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model f248bf0ca46b50f6 of arm_7/scene.toml; the usual functions
// bodies and their joints:
//   1 link_1 on the inertial frame: revolute
//   2 link_2 on 1: revolute
//   3 link_3 on 2: revolute
//   4 link_4 on 3: revolute
//   5 link_5 on 4: revolute
//   6 link_6 on 5: revolute
//   7 link_7 on 6: revolute
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
//   poses                   188 (73 add, 115 multiply, 14 sine or cosine)
//   energy                  484 (186 add, 298 multiply, 14 sine or cosine)
//   momentum                665 (278 add, 387 multiply, 14 sine or cosine)
//   power                   27 (13 add, 14 multiply)
//   accelerations           782 (357 add, 420 multiply, 5 divide, 12 sine or cosine)
//   residual                464 (226 add, 238 multiply, 12 sine or cosine)
//   forcing                 435 (207 add, 228 multiply, 12 sine or cosine)
//   mass_matrix             194 (84 add, 110 multiply, 10 sine or cosine)
//   partial_velocities      761 (293 add, 468 multiply, 14 sine or cosine)
//   partial_velocity_rates  1879 (732 add, 1147 multiply, 14 sine or cosine)
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

namespace kanec::arm_7 {

inline constexpr int n_bodies = 7;
inline constexpr int nx = 7;
inline constexpr int ny = 7;
inline constexpr int n_parameters = 1;
inline constexpr int n_inputs = 7;
inline constexpr char model_hash[] = "f248bf0ca46b50f6";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_1 = 0, theta_2 = 1, theta_3 = 2, theta_4 = 3, theta_5 = 4, theta_6 = 5, theta_7 = 6;
inline constexpr int thetadot_1 = 0, thetadot_2 = 1, thetadot_3 = 2, thetadot_4 = 3, thetadot_5 = 4, thetadot_6 = 5,
    thetadot_7 = 6;
inline constexpr int theta_link_1 = 0, theta_link_2 = 1, theta_link_3 = 2, theta_link_4 = 3, theta_link_5 = 4,
    theta_link_6 = 5, theta_link_7 = 6;
inline constexpr int thetadot_link_1 = 0, thetadot_link_2 = 1, thetadot_link_3 = 2, thetadot_link_4 = 3,
    thetadot_link_5 = 4, thetadot_link_6 = 5, thetadot_link_7 = 6;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 47;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3,
    3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6, 0, 1, 2,
    3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 6, 0, 1, 2, 3, 4, 5, 0, 1, 2, 3, 4, 6};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T c = T(0.5);
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
// 73 add, 115 multiply, 14 sine or cosine
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

  // ---- body 1 (link_1) on the inertial frame
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];
  pose[0] = E1_11;
  pose[4] = E1_11;
  pose[19] = E1_11;
  pose[1] = E1_12;
  pose[3] = -E1_12;
  pose[18] = -E1_12;
  // p1 = q1 + E1^T r1: position of the mass centre, inertial axes [m]
  const T p1_1 = E1_12 * T(0.03);
  const T minus_p1_2 = E1_11 * T(0.03);
  pose[9] = p1_1;
  pose[10] = -minus_p1_2;

  // ---- body 2 (link_2) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  pose[17] = E2_11;
  pose[32] = E2_11;
  pose[14] = minus_E2_13;
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T R2_12 = E1_12 * E2_11;
  const T R2_31 = E1_11 * minus_E2_13;
  const T R2_32 = E1_12 * minus_E2_13;
  pose[12] = -R2_11;
  pose[13] = -R2_12;
  pose[15] = R2_31;
  pose[30] = R2_31;
  pose[16] = R2_32;
  pose[31] = R2_32;

  // ---- body 3 (link_3) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T E3_12 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - E1_12 * E3_12;
  const T R3_12 = R2_12 * E3_11 + E1_11 * E3_12;
  const T minus_R3_13 = minus_E2_13 * E3_11;
  const T minus_R3_21 = E1_12 * E3_11 + R2_11 * E3_12;
  const T R3_22 = E1_11 * E3_11 - R2_12 * E3_12;
  const T R3_23 = minus_E2_13 * E3_12;
  pose[24] = R3_11;
  pose[25] = R3_12;
  pose[26] = -minus_R3_13;
  pose[27] = -minus_R3_21;
  pose[42] = minus_R3_21;
  pose[28] = R3_22;
  pose[43] = -R3_22;
  pose[29] = R3_23;
  pose[44] = -R3_23;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_3 = T(0.36) + E2_11 * T(0.2045);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = T(0.3345) * R2_31 - minus_R3_21 * T(0.03);
  const T p3_2 = R3_22 * T(0.03) + T(0.3345) * R2_32;
  const T p3_3 = P3_3 + R3_23 * T(0.03) + E2_11 * T(0.13);
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (link_4) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_13 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 + R2_31 * E4_13;
  const T R4_12 = R3_12 * E4_11 + R2_32 * E4_13;
  const T R4_13 = E2_11 * E4_13 - minus_R3_13 * E4_11;
  const T R4_31 = R2_31 * E4_11 - R3_11 * E4_13;
  const T R4_32 = R2_32 * E4_11 - R3_12 * E4_13;
  const T R4_33 = minus_R3_13 * E4_13 + E2_11 * E4_11;
  pose[36] = R4_11;
  pose[37] = R4_12;
  pose[38] = R4_13;
  pose[39] = R4_31;
  pose[54] = R4_31;
  pose[40] = R4_32;
  pose[55] = R4_32;
  pose[41] = R4_33;
  pose[56] = R4_33;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = T(0.42) * R2_31;
  const T P4_2 = T(0.42) * R2_32;
  const T P4_3 = P3_3 + E2_11 * T(0.2155);

  // ---- body 5 (link_5) on body 4
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - minus_R3_21 * E5_12;
  const T R5_12 = R4_12 * E5_11 + R3_22 * E5_12;
  const T R5_13 = R4_13 * E5_11 + R3_23 * E5_12;
  const T minus_R5_21 = minus_R3_21 * E5_11 + R4_11 * E5_12;
  const T R5_22 = R3_22 * E5_11 - R4_12 * E5_12;
  const T R5_23 = R3_23 * E5_11 - R4_13 * E5_12;
  pose[48] = -R5_11;
  pose[49] = -R5_12;
  pose[50] = -R5_13;
  pose[51] = minus_R5_21;
  pose[66] = -minus_R5_21;
  pose[52] = -R5_22;
  pose[67] = R5_22;
  pose[53] = -R5_23;
  pose[68] = R5_23;
  // P5 = R4^T q5 + P4: position of the body origin, inertial axes [m]
  const T P5_1 = P4_1 + R4_31 * T(0.1845);
  const T P5_2 = P4_2 + R4_32 * T(0.1845);
  const T P5_3 = P4_3 + R4_33 * T(0.1845);

  // ---- body 6 (link_6) on body 5
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T minus_E6_13 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - R4_31 * minus_E6_13;
  const T R6_12 = R5_12 * E6_11 - R4_32 * minus_E6_13;
  const T R6_13 = R5_13 * E6_11 - R4_33 * minus_E6_13;
  const T R6_31 = R5_11 * minus_E6_13 + R4_31 * E6_11;
  const T R6_32 = R5_12 * minus_E6_13 + R4_32 * E6_11;
  const T R6_33 = R5_13 * minus_E6_13 + R4_33 * E6_11;
  pose[60] = -R6_11;
  pose[61] = -R6_12;
  pose[62] = -R6_13;
  pose[63] = R6_31;
  pose[78] = R6_31;
  pose[64] = R6_32;
  pose[79] = R6_32;
  pose[65] = R6_33;
  pose[80] = R6_33;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T P6_1 = P5_1 + R4_31 * T(0.2155);
  const T P6_2 = P5_2 + R4_32 * T(0.2155);
  const T P6_3 = P5_3 + R4_33 * T(0.2155);

  // ---- body 7 (link_7) on body 6
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T E7_12 = sines[6];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R6_11 * E7_11 - minus_R5_21 * E7_12;
  const T R7_12 = R6_12 * E7_11 + R5_22 * E7_12;
  const T R7_13 = R6_13 * E7_11 + R5_23 * E7_12;
  const T minus_R7_21 = minus_R5_21 * E7_11 + R6_11 * E7_12;
  const T R7_22 = R5_22 * E7_11 - R6_12 * E7_12;
  const T R7_23 = R5_23 * E7_11 - R6_13 * E7_12;
  pose[72] = R7_11;
  pose[73] = R7_12;
  pose[74] = R7_13;
  pose[75] = -minus_R7_21;
  pose[76] = R7_22;
  pose[77] = R7_23;
  // P7 = R6^T q7 + P6: position of the body origin, inertial axes [m]
  const T P7_1 = P6_1 + R6_31 * T(0.081);
  const T P7_2 = P6_2 + R6_32 * T(0.081);
  const T P7_3 = P6_3 + R6_33 * T(0.081);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_1 = P7_1 + R6_31 * T(0.02);
  const T p7_2 = P7_2 + R6_32 * T(0.02);
  const T p7_3 = P7_3 + R6_33 * T(0.02);
  pose[81] = p7_1;
  pose[82] = p7_2;
  pose[83] = p7_3;

  // ---- results
  pose[2] = T(0);
  pose[5] = T(0);
  pose[6] = T(0);
  pose[7] = T(0);
  pose[20] = T(0);
  pose[8] = T(1);
  pose[11] = T(0.27749999999999997);
  pose[21] = R2_31 * T(0.059) - (R2_11 * T(3e-04) + E1_12 * T(0.042));
  pose[22] = E1_11 * T(0.042) - R2_12 * T(3e-04) + R2_32 * T(0.059);
  pose[23] = T(0.36) + minus_E2_13 * T(3e-04) + E2_11 * T(0.059);
  pose[45] = P4_1 + minus_R3_21 * T(0.034) + R4_31 * T(0.067);
  pose[46] = P4_2 + R4_32 * T(0.067) - R3_22 * T(0.034);
  pose[47] = P4_3 + R4_33 * T(0.067) - R3_23 * T(0.034);
  pose[57] = P5_1 + minus_R5_21 * T(0.021) - R5_11 * T(1e-04) + R4_31 * T(0.076);
  pose[58] = P5_2 - R5_12 * T(1e-04) - R5_22 * T(0.021) + R4_32 * T(0.076);
  pose[59] = P5_3 - R5_13 * T(1e-04) - R5_23 * T(0.021) + R4_33 * T(0.076);
  pose[69] = P6_1 + R6_31 * T(6e-04) - minus_R5_21 * T(4e-04);
  pose[70] = P6_2 + R5_22 * T(4e-04) + R6_32 * T(6e-04);
  pose[71] = P6_3 + R5_23 * T(4e-04) + R6_33 * T(6e-04);
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 186 add, 298 multiply, 14 sine or cosine
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

  // ---- body 1 (link_1) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_1 = thetadot1 * T(0.03);
  const T v1_1 = E1_11 * t1_1;
  const T v1_2 = E1_12 * t1_1;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.0123) * thetadot1 * thetadot1 * T(0.5) + T(2.88) * (v1_1 * v1_1 + v1_2 * v1_2);

  // ---- body 2 (link_2) on body 1
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
  const T p2_3 = T(0.36) + minus_E2_13 * T(3e-04) + E2_11 * T(0.059);
  // v2 = R2^T omega2~ r_link2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_1 = thetadot2 * T(0.059) - omega2_3 * T(0.042);
  const T t2_2 = minus_omega2_1 * T(0.059) - omega2_3 * T(3e-04);
  const T t2_3 = thetadot2 * T(3e-04) - minus_omega2_1 * T(0.042);
  const T v2_1 = R2_11 * t2_1 - E1_12 * t2_2 + R2_31 * t2_3;
  const T v2_2 = R2_12 * t2_1 + E1_11 * t2_2 + R2_32 * t2_3;
  const T v2_3 = E2_11 * t2_3 - minus_E2_13 * t2_1;
  // T2 = 1/2 omega2 . (I_link2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (T(0.0305) * minus_omega2_1 * minus_omega2_1 + T(0.011) * thetadot2 * thetadot2 + T(0.0304) *
      omega2_3 * omega2_3) + T(3.175) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (link_3) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T E3_12 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - E1_12 * E3_12;
  const T R3_12 = R2_12 * E3_11 + E1_11 * E3_12;
  const T minus_R3_13 = minus_E2_13 * E3_11;
  const T minus_R3_21 = E1_12 * E3_11 + R2_11 * E3_12;
  const T R3_22 = E1_11 * E3_11 - R2_12 * E3_12;
  const T R3_23 = minus_E2_13 * E3_12;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_12 * thetadot2 - E3_11 * minus_omega2_1;
  const T omega3_2 = E3_11 * thetadot2 + E3_12 * minus_omega2_1;
  const T omega3_3 = thetadot3 + omega2_3;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_3 = T(0.36) + E2_11 * T(0.2045);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_3 = P3_3 + R3_23 * T(0.03) + E2_11 * T(0.13);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_1 = thetadot2 * T(0.2045);
  const T t3_2 = minus_omega2_1 * T(0.2045);
  const T Pdot3_1 = R2_11 * t3_1 - E1_12 * t3_2;
  const T Pdot3_2 = R2_12 * t3_1 + E1_11 * t3_2;
  const T minus_Pdot3_3 = minus_E2_13 * t3_1;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_3 = omega3_2 * T(0.13) - omega3_3 * T(0.03);
  const T t3_4 = omega3_1 * T(0.13);
  const T t3_5 = omega3_1 * T(0.03);
  const T v3_1 = Pdot3_1 + R3_11 * t3_3 + minus_R3_21 * t3_4 + R2_31 * t3_5;
  const T v3_2 = Pdot3_2 + R3_12 * t3_3 - R3_22 * t3_4 + R2_32 * t3_5;
  const T v3_3 = E2_11 * t3_5 - (minus_Pdot3_3 + minus_R3_13 * t3_3 + R3_23 * t3_4);
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (T(0.025) * omega3_1 * omega3_1 + T(0.0238) * omega3_2 * omega3_2 + T(0.0076) * omega3_3 *
      omega3_3) + T(1.75) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);

  // ---- body 4 (link_4) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_13 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 + R2_31 * E4_13;
  const T R4_12 = R3_12 * E4_11 + R2_32 * E4_13;
  const T R4_13 = E2_11 * E4_13 - minus_R3_13 * E4_11;
  const T R4_31 = R2_31 * E4_11 - R3_11 * E4_13;
  const T R4_32 = R2_32 * E4_11 - R3_12 * E4_13;
  const T R4_33 = minus_R3_13 * E4_13 + E2_11 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 + E4_13 * omega3_3;
  const T omega4_2 = omega3_2 - thetadot4;
  const T omega4_3 = E4_11 * omega3_3 - E4_13 * omega3_1;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_3 = P3_3 + E2_11 * T(0.2155);
  // p4 = R4^T r_link4 + P4: position of the mass centre, inertial axes [m]
  const T p4_3 = P4_3 + R4_33 * T(0.067) - R3_23 * T(0.034);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_1 = omega3_2 * T(0.2155);
  const T t4_2 = omega3_1 * T(0.2155);
  const T Pdot4_1 = Pdot3_1 + R3_11 * t4_1 + minus_R3_21 * t4_2;
  const T Pdot4_2 = Pdot3_2 + R3_12 * t4_1 - R3_22 * t4_2;
  const T minus_Pdot4_3 = minus_Pdot3_3 + minus_R3_13 * t4_1 + R3_23 * t4_2;
  // v4 = R4^T omega4~ r_link4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_3 = omega4_3 * T(0.034) + omega4_2 * T(0.067);
  const T t4_4 = omega4_1 * T(0.067);
  const T t4_5 = omega4_1 * T(0.034);
  const T v4_1 = Pdot4_1 + R4_11 * t4_3 + minus_R3_21 * t4_4 - R4_31 * t4_5;
  const T v4_2 = Pdot4_2 + R4_12 * t4_3 - R3_22 * t4_4 - R4_32 * t4_5;
  const T v4_3 = R4_13 * t4_3 - minus_Pdot4_3 - R3_23 * t4_4 - R4_33 * t4_5;
  // T4 = 1/2 omega4 . (I_link4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (T(0.017) * omega4_1 * omega4_1 + T(0.006) * omega4_2 * omega4_2 + T(0.0164) * omega4_3 *
      omega4_3) + T(1.75) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (link_5) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - minus_R3_21 * E5_12;
  const T R5_12 = R4_12 * E5_11 + R3_22 * E5_12;
  const T R5_13 = R4_13 * E5_11 + R3_23 * E5_12;
  const T minus_R5_21 = minus_R3_21 * E5_11 + R4_11 * E5_12;
  const T R5_22 = R3_22 * E5_11 - R4_12 * E5_12;
  const T R5_23 = R3_23 * E5_11 - R4_13 * E5_12;
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 + E5_12 * omega4_2;
  const T omega5_2 = E5_11 * omega4_2 - E5_12 * omega4_1;
  const T omega5_3 = thetadot5 + omega4_3;
  // P5 = R4^T q5 + P4: position of the body origin, inertial axes [m]
  const T P5_3 = P4_3 + R4_33 * T(0.1845);
  // p5 = R5^T r_link5 + P5: position of the mass centre, inertial axes [m]
  const T p5_3 = P5_3 - R5_13 * T(1e-04) - R5_23 * T(0.021) + R4_33 * T(0.076);
  // Pdot5 = R4^T omega4~ q5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t5_1 = omega4_2 * T(0.1845);
  const T t5_2 = omega4_1 * T(0.1845);
  const T Pdot5_1 = Pdot4_1 + R4_11 * t5_1 + minus_R3_21 * t5_2;
  const T Pdot5_2 = Pdot4_2 + R4_12 * t5_1 - R3_22 * t5_2;
  const T Pdot5_3 = R4_13 * t5_1 - minus_Pdot4_3 - R3_23 * t5_2;
  // v5 = R5^T omega5~ r_link5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_3 = omega5_3 * T(0.021) + omega5_2 * T(0.076);
  const T t5_4 = omega5_3 * T(1e-04) + omega5_1 * T(0.076);
  const T t5_5 = omega5_2 * T(1e-04) - omega5_1 * T(0.021);
  const T v5_1 = Pdot5_1 + R5_11 * t5_3 + minus_R5_21 * t5_4 + R4_31 * t5_5;
  const T v5_2 = Pdot5_2 + R5_12 * t5_3 - R5_22 * t5_4 + R4_32 * t5_5;
  const T v5_3 = Pdot5_3 + R5_13 * t5_3 - R5_23 * t5_4 + R4_33 * t5_5;
  // T5 = 1/2 omega5 . (I_link5 omega5) + 1/2 m5 v5 . v5: kinetic energy [J]
  const T T5 = T(0.5) * (T(0.01) * omega5_1 * omega5_1 + T(0.0087) * omega5_2 * omega5_2 + T(0.00449) * omega5_3 *
      omega5_3) + T(1.75) * (v5_1 * v5_1 + v5_2 * v5_2 + v5_3 * v5_3);

  // ---- body 6 (link_6) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T minus_E6_13 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - R4_31 * minus_E6_13;
  const T R6_12 = R5_12 * E6_11 - R4_32 * minus_E6_13;
  const T R6_13 = R5_13 * E6_11 - R4_33 * minus_E6_13;
  const T R6_31 = R5_11 * minus_E6_13 + R4_31 * E6_11;
  const T R6_32 = R5_12 * minus_E6_13 + R4_32 * E6_11;
  const T R6_33 = R5_13 * minus_E6_13 + R4_33 * E6_11;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 - minus_E6_13 * omega5_3;
  const T omega6_2 = thetadot6 + omega5_2;
  const T omega6_3 = minus_E6_13 * omega5_1 + E6_11 * omega5_3;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T P6_3 = P5_3 + R4_33 * T(0.2155);
  // p6 = R6^T r_link6 + P6: position of the mass centre, inertial axes [m]
  const T p6_3 = P6_3 + R5_23 * T(4e-04) + R6_33 * T(6e-04);
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_1 = omega5_2 * T(0.2155);
  const T t6_2 = omega5_1 * T(0.2155);
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_1 + minus_R5_21 * t6_2;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_1 - R5_22 * t6_2;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_1 - R5_23 * t6_2;
  // v6 = R6^T omega6~ r_link6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_3 = omega6_2 * T(6e-04) - omega6_3 * T(4e-04);
  const T t6_4 = omega6_1 * T(6e-04);
  const T t6_5 = omega6_1 * T(4e-04);
  const T v6_1 = Pdot6_1 + R6_11 * t6_3 + minus_R5_21 * t6_4 + R6_31 * t6_5;
  const T v6_2 = Pdot6_2 + R6_12 * t6_3 - R5_22 * t6_4 + R6_32 * t6_5;
  const T v6_3 = Pdot6_3 + R6_13 * t6_3 - R5_23 * t6_4 + R6_33 * t6_5;
  // T6 = 1/2 omega6 . (I_link6 omega6) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (T(0.0049) * omega6_1 * omega6_1 + T(0.0036) * omega6_2 * omega6_2 + T(0.0047) * omega6_3 *
      omega6_3) + T(0.9) * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- body 7 (link_7) on body 6
  const T thetadot7 = y[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T E7_12 = sines[6];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R6_11 * E7_11 - minus_R5_21 * E7_12;
  const T R7_12 = R6_12 * E7_11 + R5_22 * E7_12;
  const T R7_13 = R6_13 * E7_11 + R5_23 * E7_12;
  const T minus_R7_21 = minus_R5_21 * E7_11 + R6_11 * E7_12;
  const T R7_22 = R5_22 * E7_11 - R6_12 * E7_12;
  const T R7_23 = R5_23 * E7_11 - R6_13 * E7_12;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 + E7_12 * omega6_2;
  const T omega7_2 = E7_11 * omega6_2 - E7_12 * omega6_1;
  const T omega7_3 = thetadot7 + omega6_3;
  // P7 = R6^T q7 + P6: position of the body origin, inertial axes [m]
  const T P7_3 = P6_3 + R6_33 * T(0.081);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_3 = P7_3 + R6_33 * T(0.02);
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_1 = omega6_2 * T(0.081);
  const T t7_2 = omega6_1 * T(0.081);
  const T Pdot7_1 = Pdot6_1 + R6_11 * t7_1 + minus_R5_21 * t7_2;
  const T Pdot7_2 = Pdot6_2 + R6_12 * t7_1 - R5_22 * t7_2;
  const T Pdot7_3 = Pdot6_3 + R6_13 * t7_1 - R5_23 * t7_2;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_3 = omega7_2 * T(0.02);
  const T t7_4 = omega7_1 * T(0.02);
  const T v7_1 = Pdot7_1 + R7_11 * t7_3 + minus_R7_21 * t7_4;
  const T v7_2 = Pdot7_2 + R7_12 * t7_3 - R7_22 * t7_4;
  const T v7_3 = Pdot7_3 + R7_13 * t7_3 - R7_23 * t7_4;
  // T7 = 1/2 omega7 . (I7 omega7) + 1/2 m7 v7 . v7: kinetic energy [J]
  const T T7 = T(0.5) * (T(0.001) * omega7_1 * omega7_1 + T(0.001) * omega7_2 * omega7_2 + T(0.001) * omega7_3 *
      omega7_3) + T(0.6) * (v7_1 * v7_1 + v7_2 * v7_2 + v7_3 * v7_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6 + m7 p7: first moment of mass, inertial axes [kg m]
  const T mp_3 = T(1.5983999999999998) + T(6.35) * p2_3 + T(3.5) * p3_3 + T(3.5) * p4_3 + T(3.5) * p5_3 + T(1.8) *
      p6_3 + T(1.2) * p7_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 278 add, 387 multiply, 14 sine or cosine
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

  // ---- body 1 (link_1) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];
  // p1 = q1 + E1^T r1: position of the mass centre, inertial axes [m]
  const T p1_1 = E1_12 * T(0.03);
  const T minus_p1_2 = E1_11 * T(0.03);
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_1 = thetadot1 * T(0.03);
  const T v1_1 = E1_11 * t1_1;
  const T v1_2 = E1_12 * t1_1;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(5.76) * v1_1;
  const T l1_2 = T(5.76) * v1_2;
  // H1 = E1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T minus_H1_1 = T(0.27749999999999997) * l1_2;
  const T H1_2 = T(0.27749999999999997) * l1_1;
  const T H1_3 = T(0.0123) * thetadot1 + p1_1 * l1_2 + minus_p1_2 * l1_1;

  // ---- body 2 (link_2) on body 1
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
  const T p2_1 = R2_31 * T(0.059) - (R2_11 * T(3e-04) + E1_12 * T(0.042));
  const T p2_2 = E1_11 * T(0.042) - R2_12 * T(3e-04) + R2_32 * T(0.059);
  const T p2_3 = T(0.36) + minus_E2_13 * T(3e-04) + E2_11 * T(0.059);
  // v2 = R2^T omega2~ r_link2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_1 = thetadot2 * T(0.059) - omega2_3 * T(0.042);
  const T t2_2 = minus_omega2_1 * T(0.059) - omega2_3 * T(3e-04);
  const T t2_3 = thetadot2 * T(3e-04) - minus_omega2_1 * T(0.042);
  const T v2_1 = R2_11 * t2_1 - E1_12 * t2_2 + R2_31 * t2_3;
  const T v2_2 = R2_12 * t2_1 + E1_11 * t2_2 + R2_32 * t2_3;
  const T v2_3 = E2_11 * t2_3 - minus_E2_13 * t2_1;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(6.35) * v2_1;
  const T l2_2 = T(6.35) * v2_2;
  const T l2_3 = T(6.35) * v2_3;
  // H2 = R2^T I_link2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_4 = T(0.0304) * omega2_3;
  const T t2_5 = T(0.0305) * minus_omega2_1;
  const T t2_6 = T(0.011) * thetadot2;
  const T H2_1 = R2_31 * t2_4 - (R2_11 * t2_5 + E1_12 * t2_6) + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = E1_11 * t2_6 - R2_12 * t2_5 + R2_32 * t2_4 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = minus_E2_13 * t2_5 + E2_11 * t2_4 + p2_1 * l2_2 - p2_2 * l2_1;

  // ---- body 3 (link_3) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T E3_12 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - E1_12 * E3_12;
  const T R3_12 = R2_12 * E3_11 + E1_11 * E3_12;
  const T minus_R3_13 = minus_E2_13 * E3_11;
  const T minus_R3_21 = E1_12 * E3_11 + R2_11 * E3_12;
  const T R3_22 = E1_11 * E3_11 - R2_12 * E3_12;
  const T R3_23 = minus_E2_13 * E3_12;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_12 * thetadot2 - E3_11 * minus_omega2_1;
  const T omega3_2 = E3_11 * thetadot2 + E3_12 * minus_omega2_1;
  const T omega3_3 = thetadot3 + omega2_3;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_3 = T(0.36) + E2_11 * T(0.2045);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = T(0.3345) * R2_31 - minus_R3_21 * T(0.03);
  const T p3_2 = R3_22 * T(0.03) + T(0.3345) * R2_32;
  const T p3_3 = P3_3 + R3_23 * T(0.03) + E2_11 * T(0.13);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_1 = thetadot2 * T(0.2045);
  const T t3_2 = minus_omega2_1 * T(0.2045);
  const T Pdot3_1 = R2_11 * t3_1 - E1_12 * t3_2;
  const T Pdot3_2 = R2_12 * t3_1 + E1_11 * t3_2;
  const T minus_Pdot3_3 = minus_E2_13 * t3_1;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_3 = omega3_2 * T(0.13) - omega3_3 * T(0.03);
  const T t3_4 = omega3_1 * T(0.13);
  const T t3_5 = omega3_1 * T(0.03);
  const T v3_1 = Pdot3_1 + R3_11 * t3_3 + minus_R3_21 * t3_4 + R2_31 * t3_5;
  const T v3_2 = Pdot3_2 + R3_12 * t3_3 - R3_22 * t3_4 + R2_32 * t3_5;
  const T v3_3 = E2_11 * t3_5 - (minus_Pdot3_3 + minus_R3_13 * t3_3 + R3_23 * t3_4);
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(3.5) * v3_1;
  const T l3_2 = T(3.5) * v3_2;
  const T l3_3 = T(3.5) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_6 = T(0.025) * omega3_1;
  const T t3_7 = T(0.0238) * omega3_2;
  const T t3_8 = T(0.0076) * omega3_3;
  const T H3_1 = R3_11 * t3_6 - minus_R3_21 * t3_7 + R2_31 * t3_8 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = R3_12 * t3_6 + R3_22 * t3_7 + R2_32 * t3_8 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R3_23 * t3_7 - minus_R3_13 * t3_6 + E2_11 * t3_8 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (link_4) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_13 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 + R2_31 * E4_13;
  const T R4_12 = R3_12 * E4_11 + R2_32 * E4_13;
  const T R4_13 = E2_11 * E4_13 - minus_R3_13 * E4_11;
  const T R4_31 = R2_31 * E4_11 - R3_11 * E4_13;
  const T R4_32 = R2_32 * E4_11 - R3_12 * E4_13;
  const T R4_33 = minus_R3_13 * E4_13 + E2_11 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 + E4_13 * omega3_3;
  const T omega4_2 = omega3_2 - thetadot4;
  const T omega4_3 = E4_11 * omega3_3 - E4_13 * omega3_1;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = T(0.42) * R2_31;
  const T P4_2 = T(0.42) * R2_32;
  const T P4_3 = P3_3 + E2_11 * T(0.2155);
  // p4 = R4^T r_link4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 + minus_R3_21 * T(0.034) + R4_31 * T(0.067);
  const T p4_2 = P4_2 + R4_32 * T(0.067) - R3_22 * T(0.034);
  const T p4_3 = P4_3 + R4_33 * T(0.067) - R3_23 * T(0.034);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_1 = omega3_2 * T(0.2155);
  const T t4_2 = omega3_1 * T(0.2155);
  const T Pdot4_1 = Pdot3_1 + R3_11 * t4_1 + minus_R3_21 * t4_2;
  const T Pdot4_2 = Pdot3_2 + R3_12 * t4_1 - R3_22 * t4_2;
  const T minus_Pdot4_3 = minus_Pdot3_3 + minus_R3_13 * t4_1 + R3_23 * t4_2;
  // v4 = R4^T omega4~ r_link4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_3 = omega4_3 * T(0.034) + omega4_2 * T(0.067);
  const T t4_4 = omega4_1 * T(0.067);
  const T t4_5 = omega4_1 * T(0.034);
  const T v4_1 = Pdot4_1 + R4_11 * t4_3 + minus_R3_21 * t4_4 - R4_31 * t4_5;
  const T v4_2 = Pdot4_2 + R4_12 * t4_3 - R3_22 * t4_4 - R4_32 * t4_5;
  const T v4_3 = R4_13 * t4_3 - minus_Pdot4_3 - R3_23 * t4_4 - R4_33 * t4_5;
  // l4 = m4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(3.5) * v4_1;
  const T l4_2 = T(3.5) * v4_2;
  const T l4_3 = T(3.5) * v4_3;
  // H4 = R4^T I_link4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_6 = T(0.017) * omega4_1;
  const T t4_7 = T(0.006) * omega4_2;
  const T t4_8 = T(0.0164) * omega4_3;
  const T H4_1 = R4_11 * t4_6 - minus_R3_21 * t4_7 + R4_31 * t4_8 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_6 + R3_22 * t4_7 + R4_32 * t4_8 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R4_13 * t4_6 + R3_23 * t4_7 + R4_33 * t4_8 + p4_1 * l4_2 - p4_2 * l4_1;

  // ---- body 5 (link_5) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - minus_R3_21 * E5_12;
  const T R5_12 = R4_12 * E5_11 + R3_22 * E5_12;
  const T R5_13 = R4_13 * E5_11 + R3_23 * E5_12;
  const T minus_R5_21 = minus_R3_21 * E5_11 + R4_11 * E5_12;
  const T R5_22 = R3_22 * E5_11 - R4_12 * E5_12;
  const T R5_23 = R3_23 * E5_11 - R4_13 * E5_12;
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 + E5_12 * omega4_2;
  const T omega5_2 = E5_11 * omega4_2 - E5_12 * omega4_1;
  const T omega5_3 = thetadot5 + omega4_3;
  // P5 = R4^T q5 + P4: position of the body origin, inertial axes [m]
  const T P5_1 = P4_1 + R4_31 * T(0.1845);
  const T P5_2 = P4_2 + R4_32 * T(0.1845);
  const T P5_3 = P4_3 + R4_33 * T(0.1845);
  // p5 = R5^T r_link5 + P5: position of the mass centre, inertial axes [m]
  const T p5_1 = P5_1 + minus_R5_21 * T(0.021) - R5_11 * T(1e-04) + R4_31 * T(0.076);
  const T p5_2 = P5_2 - R5_12 * T(1e-04) - R5_22 * T(0.021) + R4_32 * T(0.076);
  const T p5_3 = P5_3 - R5_13 * T(1e-04) - R5_23 * T(0.021) + R4_33 * T(0.076);
  // Pdot5 = R4^T omega4~ q5 + Pdot4: velocity of the body origin, inertial axes [m/s]
  const T t5_1 = omega4_2 * T(0.1845);
  const T t5_2 = omega4_1 * T(0.1845);
  const T Pdot5_1 = Pdot4_1 + R4_11 * t5_1 + minus_R3_21 * t5_2;
  const T Pdot5_2 = Pdot4_2 + R4_12 * t5_1 - R3_22 * t5_2;
  const T Pdot5_3 = R4_13 * t5_1 - minus_Pdot4_3 - R3_23 * t5_2;
  // v5 = R5^T omega5~ r_link5 + Pdot5: velocity of the mass centre, inertial axes [m/s]
  const T t5_3 = omega5_3 * T(0.021) + omega5_2 * T(0.076);
  const T t5_4 = omega5_3 * T(1e-04) + omega5_1 * T(0.076);
  const T t5_5 = omega5_2 * T(1e-04) - omega5_1 * T(0.021);
  const T v5_1 = Pdot5_1 + R5_11 * t5_3 + minus_R5_21 * t5_4 + R4_31 * t5_5;
  const T v5_2 = Pdot5_2 + R5_12 * t5_3 - R5_22 * t5_4 + R4_32 * t5_5;
  const T v5_3 = Pdot5_3 + R5_13 * t5_3 - R5_23 * t5_4 + R4_33 * t5_5;
  // l5 = m5 v5: linear momentum, inertial axes [kg m/s]
  const T l5_1 = T(3.5) * v5_1;
  const T l5_2 = T(3.5) * v5_2;
  const T l5_3 = T(3.5) * v5_3;
  // H5 = R5^T I_link5 omega5 + p5~ l5: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t5_6 = T(0.01) * omega5_1;
  const T t5_7 = T(0.0087) * omega5_2;
  const T t5_8 = T(0.00449) * omega5_3;
  const T H5_1 = R5_11 * t5_6 - minus_R5_21 * t5_7 + R4_31 * t5_8 + p5_2 * l5_3 - p5_3 * l5_2;
  const T H5_2 = R5_12 * t5_6 + R5_22 * t5_7 + R4_32 * t5_8 + p5_3 * l5_1 - p5_1 * l5_3;
  const T H5_3 = R5_13 * t5_6 + R5_23 * t5_7 + R4_33 * t5_8 + p5_1 * l5_2 - p5_2 * l5_1;

  // ---- body 6 (link_6) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T minus_E6_13 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - R4_31 * minus_E6_13;
  const T R6_12 = R5_12 * E6_11 - R4_32 * minus_E6_13;
  const T R6_13 = R5_13 * E6_11 - R4_33 * minus_E6_13;
  const T R6_31 = R5_11 * minus_E6_13 + R4_31 * E6_11;
  const T R6_32 = R5_12 * minus_E6_13 + R4_32 * E6_11;
  const T R6_33 = R5_13 * minus_E6_13 + R4_33 * E6_11;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 - minus_E6_13 * omega5_3;
  const T omega6_2 = thetadot6 + omega5_2;
  const T omega6_3 = minus_E6_13 * omega5_1 + E6_11 * omega5_3;
  // P6 = R5^T q6 + P5: position of the body origin, inertial axes [m]
  const T P6_1 = P5_1 + R4_31 * T(0.2155);
  const T P6_2 = P5_2 + R4_32 * T(0.2155);
  const T P6_3 = P5_3 + R4_33 * T(0.2155);
  // p6 = R6^T r_link6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = P6_1 + R6_31 * T(6e-04) - minus_R5_21 * T(4e-04);
  const T p6_2 = P6_2 + R5_22 * T(4e-04) + R6_32 * T(6e-04);
  const T p6_3 = P6_3 + R5_23 * T(4e-04) + R6_33 * T(6e-04);
  // Pdot6 = R5^T omega5~ q6 + Pdot5: velocity of the body origin, inertial axes [m/s]
  const T t6_1 = omega5_2 * T(0.2155);
  const T t6_2 = omega5_1 * T(0.2155);
  const T Pdot6_1 = Pdot5_1 + R5_11 * t6_1 + minus_R5_21 * t6_2;
  const T Pdot6_2 = Pdot5_2 + R5_12 * t6_1 - R5_22 * t6_2;
  const T Pdot6_3 = Pdot5_3 + R5_13 * t6_1 - R5_23 * t6_2;
  // v6 = R6^T omega6~ r_link6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_3 = omega6_2 * T(6e-04) - omega6_3 * T(4e-04);
  const T t6_4 = omega6_1 * T(6e-04);
  const T t6_5 = omega6_1 * T(4e-04);
  const T v6_1 = Pdot6_1 + R6_11 * t6_3 + minus_R5_21 * t6_4 + R6_31 * t6_5;
  const T v6_2 = Pdot6_2 + R6_12 * t6_3 - R5_22 * t6_4 + R6_32 * t6_5;
  const T v6_3 = Pdot6_3 + R6_13 * t6_3 - R5_23 * t6_4 + R6_33 * t6_5;
  // l6 = m6 v6: linear momentum, inertial axes [kg m/s]
  const T l6_1 = T(1.8) * v6_1;
  const T l6_2 = T(1.8) * v6_2;
  const T l6_3 = T(1.8) * v6_3;
  // H6 = R6^T I_link6 omega6 + p6~ l6: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t6_6 = T(0.0049) * omega6_1;
  const T t6_7 = T(0.0036) * omega6_2;
  const T t6_8 = T(0.0047) * omega6_3;
  const T H6_1 = R6_11 * t6_6 - minus_R5_21 * t6_7 + R6_31 * t6_8 + p6_2 * l6_3 - p6_3 * l6_2;
  const T H6_2 = R6_12 * t6_6 + R5_22 * t6_7 + R6_32 * t6_8 + p6_3 * l6_1 - p6_1 * l6_3;
  const T H6_3 = R6_13 * t6_6 + R5_23 * t6_7 + R6_33 * t6_8 + p6_1 * l6_2 - p6_2 * l6_1;

  // ---- body 7 (link_7) on body 6
  const T thetadot7 = y[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T E7_12 = sines[6];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R6_11 * E7_11 - minus_R5_21 * E7_12;
  const T R7_12 = R6_12 * E7_11 + R5_22 * E7_12;
  const T R7_13 = R6_13 * E7_11 + R5_23 * E7_12;
  const T minus_R7_21 = minus_R5_21 * E7_11 + R6_11 * E7_12;
  const T R7_22 = R5_22 * E7_11 - R6_12 * E7_12;
  const T R7_23 = R5_23 * E7_11 - R6_13 * E7_12;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 + E7_12 * omega6_2;
  const T omega7_2 = E7_11 * omega6_2 - E7_12 * omega6_1;
  const T omega7_3 = thetadot7 + omega6_3;
  // P7 = R6^T q7 + P6: position of the body origin, inertial axes [m]
  const T P7_1 = P6_1 + R6_31 * T(0.081);
  const T P7_2 = P6_2 + R6_32 * T(0.081);
  const T P7_3 = P6_3 + R6_33 * T(0.081);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_1 = P7_1 + R6_31 * T(0.02);
  const T p7_2 = P7_2 + R6_32 * T(0.02);
  const T p7_3 = P7_3 + R6_33 * T(0.02);
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_1 = omega6_2 * T(0.081);
  const T t7_2 = omega6_1 * T(0.081);
  const T Pdot7_1 = Pdot6_1 + R6_11 * t7_1 + minus_R5_21 * t7_2;
  const T Pdot7_2 = Pdot6_2 + R6_12 * t7_1 - R5_22 * t7_2;
  const T Pdot7_3 = Pdot6_3 + R6_13 * t7_1 - R5_23 * t7_2;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_3 = omega7_2 * T(0.02);
  const T t7_4 = omega7_1 * T(0.02);
  const T v7_1 = Pdot7_1 + R7_11 * t7_3 + minus_R7_21 * t7_4;
  const T v7_2 = Pdot7_2 + R7_12 * t7_3 - R7_22 * t7_4;
  const T v7_3 = Pdot7_3 + R7_13 * t7_3 - R7_23 * t7_4;
  // l7 = m7 v7: linear momentum, inertial axes [kg m/s]
  const T l7_1 = T(1.2) * v7_1;
  const T l7_2 = T(1.2) * v7_2;
  const T l7_3 = T(1.2) * v7_3;
  // H7 = R7^T I7 omega7 + p7~ l7: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t7_5 = T(0.001) * omega7_1;
  const T t7_6 = T(0.001) * omega7_2;
  const T t7_7 = T(0.001) * omega7_3;
  const T H7_1 = R7_11 * t7_5 - minus_R7_21 * t7_6 + R6_31 * t7_7 + p7_2 * l7_3 - p7_3 * l7_2;
  const T H7_2 = R7_12 * t7_5 + R7_22 * t7_6 + R6_32 * t7_7 + p7_3 * l7_1 - p7_1 * l7_3;
  const T H7_3 = R7_13 * t7_5 + R7_23 * t7_6 + R6_33 * t7_7 + p7_1 * l7_2 - p7_2 * l7_1;

  // ---- whole system
  // linear = l1 + l2 + l3 + l4 + l5 + l6 + l7: linear momentum of the system [kg m/s]
  const T linear_1 = l1_1 + l2_1 + l3_1 + l4_1 + l5_1 + l6_1 + l7_1;
  const T linear_2 = l1_2 + l2_2 + l3_2 + l4_2 + l5_2 + l6_2 + l7_2;
  const T linear_3 = l2_3 + l3_3 + l4_3 + l5_3 + l6_3 + l7_3;
  momentum[0] = linear_1;
  momentum[1] = linear_2;
  momentum[2] = linear_3;
  // angular = H1 + H2 + H3 + H4 + H5 + H6 + H7: angular momentum of the system about the inertial origin [kg m^2/s]
  const T angular_1 = H2_1 + H3_1 + H4_1 + H5_1 + H6_1 + H7_1 - minus_H1_1;
  const T angular_2 = H2_2 + H3_2 + H4_2 + H5_2 + H6_2 + H7_2 + H1_2;
  const T angular_3 = H1_3 + H2_3 + H3_3 + H4_3 + H5_3 + H6_3 + H7_3;
  momentum[3] = angular_1;
  momentum[4] = angular_2;
  momentum[5] = angular_3;
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 13 add, 14 multiply
template <class T>
void power(const Prepared<T>& c, [[maybe_unused]] const T* x, const T* y, const Inputs<T>& u, T* out) noexcept {

  // ---- body 1 (link_1) on the inertial frame
  const T thetadot1 = y[0];
  // effort_link_1_1 = -thetadot1 c_link_1_ + tau_link_1_: along the coordinate [N m], [N]
  const T effort_link_1_1 = u.tau_1 - thetadot1 * c.p.c;

  // ---- body 2 (link_2) on body 1
  const T thetadot2 = y[1];
  // effort_link_2_2 = -thetadot2 c_link_2_ + tau_link_2_: along the coordinate [N m], [N]
  const T effort_link_2_2 = u.tau_2 - thetadot2 * c.p.c;

  // ---- body 3 (link_3) on body 2
  const T thetadot3 = y[2];
  // effort_link_3_3 = -thetadot3 c_link_3_ + tau_link_3_: along the coordinate [N m], [N]
  const T effort_link_3_3 = u.tau_3 - thetadot3 * c.p.c;

  // ---- body 4 (link_4) on body 3
  const T thetadot4 = y[3];
  // effort_link_4_4 = -thetadot4 c_link_4_ + tau_link_4_: along the coordinate [N m], [N]
  const T effort_link_4_4 = u.tau_4 - thetadot4 * c.p.c;

  // ---- body 5 (link_5) on body 4
  const T thetadot5 = y[4];
  // effort_link_5_5 = -thetadot5 c_link_5_ + tau_link_5_: along the coordinate [N m], [N]
  const T effort_link_5_5 = u.tau_5 - thetadot5 * c.p.c;

  // ---- body 6 (link_6) on body 5
  const T thetadot6 = y[5];
  // effort_link_6_6 = -thetadot6 c_link_6_ + tau_link_6_: along the coordinate [N m], [N]
  const T effort_link_6_6 = u.tau_6 - thetadot6 * c.p.c;

  // ---- body 7 (link_7) on body 6
  const T thetadot7 = y[6];
  // effort_link_7_7 = -thetadot7 c_link_7_ + tau_link_7_: along the coordinate [N m], [N]
  const T effort_link_7_7 = u.tau_7 - thetadot7 * c.p.c;

  // ---- whole system
  // power = thetadot1 effort_link_1_1 + thetadot2 effort_link_2_2 + thetadot3 effort_link_3_3 + thetadot4
  //   effort_link_4_4 + thetadot5 effort_link_5_5 + thetadot6 effort_link_6_6 + thetadot7 effort_link_7_7: power of
  //   the applied loads [W]
  const T power = thetadot1 * effort_link_1_1 + thetadot2 * effort_link_2_2 + thetadot3 * effort_link_3_3 + thetadot4
      * effort_link_4_4 + thetadot5 * effort_link_5_5 + thetadot6 * effort_link_6_6 + thetadot7 * effort_link_7_7;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 357 add, 420 multiply, 5 divide, 12 sine or cosine
// by: articulated; composite would take 381 add, 455 multiply, 5 divide, 12 sine or cosine
template <class T>
void accelerations(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 6, cosines + 1, sines + 1);

  // ---- body 1 (link_1) on the inertial frame
  const T thetadot1 = y[0];
  // effort_link_1_1 = -thetadot1 c_link_1_ + tau_link_1_: along the coordinate [N m], [N]
  const T effort_link_1_1 = u.tau_1 - thetadot1 * c.p.c;

  // ---- body 2 (link_2) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T minus_omega2_1 = minus_E2_13 * thetadot1;
  const T omega2_3 = E2_11 * thetadot1;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot2_1 = omega2_3 * thetadot2;
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
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = minus_E2_13 * T(9.81);
  const T Pddot2_3 = E2_11 * T(9.81);
  // effort_link_2_2 = -thetadot2 c_link_2_ + tau_link_2_: along the coordinate [N m], [N]
  const T effort_link_2_2 = u.tau_2 - thetadot2 * c.p.c;
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(0.0157353) * (minus_U2_22 - minus_U2_33) - T(2.2318662249999996) * U2_23 +
      T(8.000999999999999e-05) * minus_U2_13 - T(0.00011239499999999998) * minus_U2_21;
  const T minus_N2_2 = T(0.0019049999999999998) * Pddot2_3 - T(5.7454) * minus_Pddot2_1 - T(2.2264156534999997) *
      minus_U2_13 - T(0.00011239499999999998) * (minus_U2_33 - minus_U2_11);
  const T minus_N2_3 = T(0.0157353) * minus_U2_13 - (T(0.0054505715) * minus_U2_21 + T(8.000999999999999e-05) *
      (minus_U2_11 - minus_U2_22) + T(0.00011239499999999998) * U2_23);

  // ---- body 3 (link_3) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T E3_12 = sines[2];
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_12 * thetadot2 - E3_11 * minus_omega2_1;
  const T omega3_2 = E3_11 * thetadot2 + E3_12 * minus_omega2_1;
  const T omega3_3 = thetadot3 + omega2_3;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = thetadot3 * omega3_2 - E3_11 * minus_omegadot2_1;
  const T omegadot3_2 = E3_12 * minus_omegadot2_1 - thetadot3 * omega3_1;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_2 * omega3_1;
  const T U3_12 = t3_1 + minus_omegadot2_3;
  const T t3_2 = omega3_3 * omega3_1;
  const T U3_13 = t3_2 + omegadot3_2;
  const T U3_21 = t3_1 - minus_omegadot2_3;
  const T t3_3 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_3 + omega3_3 * omega3_3;
  const T t3_4 = omega3_3 * omega3_2;
  const T U3_23 = t3_4 - omegadot3_1;
  const T U3_31 = t3_2 - omegadot3_2;
  const T U3_32 = t3_4 + omegadot3_1;
  const T minus_U3_33 = t3_3 + omega3_2 * omega3_2;
  // Pddot3 = E3 Pddot2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot3_1 = E3_11 * minus_Pddot2_1;
  const T Pddot3_2 = E3_12 * minus_Pddot2_1;
  // effort_link_3_3 = -thetadot3 c_link_3_ + tau_link_3_: along the coordinate [N m], [N]
  const T effort_link_3_3 = u.tau_3 - thetadot3 * c.p.c;
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(0.027996) * U3_32 + T(0.027996) * U3_23 - T(0.014857500000000004) * (minus_U3_22 -
      minus_U3_33) - T(0.014000000000000012) * Pddot2_3;
  const T N3_2 = T(0.027996) * U3_13 + T(0.0032) * U3_31 + T(0.014857500000000004) * U3_12;
  const T minus_N3_3 = T(0.0032) * U3_21 - T(0.027996) * U3_12 + T(0.014857500000000004) * U3_13 -
      T(0.014000000000000012) * minus_Pddot3_1;

  // ---- body 4 (link_4) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_13 = sines[3];
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 + E4_13 * omega3_3;
  const T omega4_2 = omega3_2 - thetadot4;
  const T omega4_3 = E4_11 * omega3_3 - E4_13 * omega3_1;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = thetadot4 * omega4_3 + E4_11 * omegadot3_1 - E4_13 * minus_omegadot2_3;
  const T minus_omegadot4_3 = thetadot4 * omega4_1 + E4_13 * omegadot3_1 + E4_11 * minus_omegadot2_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_1 = omega4_2 * omega4_1;
  const T U4_12 = t4_1 + minus_omegadot4_3;
  const T t4_2 = omega4_3 * omega4_1;
  const T U4_13 = t4_2 + omegadot3_2;
  const T U4_21 = t4_1 - minus_omegadot4_3;
  const T t4_3 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_3 + omega4_3 * omega4_3;
  const T t4_4 = omega4_3 * omega4_2;
  const T U4_23 = t4_4 - omegadot4_1;
  const T U4_31 = t4_2 - omegadot3_2;
  const T U4_32 = t4_4 + omegadot4_1;
  const T minus_U4_33 = t4_3 + omega4_2 * omega4_2;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_5 = U3_13 * T(0.42) - minus_Pddot3_1;
  const T t4_6 = Pddot2_3 - minus_U3_33 * T(0.42);
  const T Pddot4_1 = E4_11 * t4_5 + E4_13 * t4_6;
  const T Pddot4_2 = U3_23 * T(0.42) + Pddot3_2;
  const T Pddot4_3 = E4_11 * t4_6 - E4_13 * t4_5;
  // effort_link_4_4 = -thetadot4 c_link_4_ + tau_link_4_: along the coordinate [N m], [N]
  const T effort_link_4_4 = u.tau_4 - thetadot4 * c.p.c;
  // G4 = -U4 h_own_4: applied less inertia force, body axes [N]
  const T minus_G4_1 = U4_13 * T(2.34625);
  const T minus_G4_2 = U4_23 * T(2.34625);
  const T G4_3 = minus_U4_33 * T(2.34625);
  // N4 = -h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N4_1 = T(2.34625) * Pddot4_2 + T(0.0027) * U4_32 + T(0.752766163) * U4_23 + T(0.007973000000000001) *
      (minus_U4_22 - minus_U4_33);
  const T minus_N4_2 = T(2.34625) * Pddot4_1 + T(0.752766163) * U4_13 - T(0.0027) * U4_31 - T(0.007973000000000001) *
      U4_12;
  const T minus_N4_3 = T(0.0027) * U4_21 + T(0.0027) * U4_12 + T(0.007973000000000001) * U4_13;

  // ---- body 5 (link_5) on body 4
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
  const T U5_12 = t5_3 + minus_omegadot4_3;
  const T t5_4 = omega5_3 * omega5_1;
  const T U5_13 = t5_4 + omegadot5_2;
  const T U5_21 = t5_3 - minus_omegadot4_3;
  const T t5_5 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_1 + t5_5;
  const T t5_6 = omega5_3 * omega5_2;
  const T U5_23 = t5_6 - omegadot5_1;
  const T U5_31 = t5_4 - omegadot5_2;
  const T U5_32 = t5_6 + omegadot5_1;
  const T minus_U5_33 = t5_2 + t5_5;
  // Pddot5 = E5 Pddot4: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_1 = E5_11 * Pddot4_1 + E5_12 * Pddot4_2;
  const T Pddot5_2 = E5_11 * Pddot4_2 - E5_12 * Pddot4_1;
  // effort_link_5_5 = -thetadot5 c_link_5_ + tau_link_5_: along the coordinate [N m], [N]
  const T effort_link_5_5 = u.tau_5 - thetadot5 * c.p.c;
  // G5 = -U5 h_own_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = minus_U5_11 * T(0.00035) - U5_12 * T(0.07278000000000001);
  const T minus_G5_2 = minus_U5_22 * T(0.07278000000000001) - U5_21 * T(0.00035);
  const T G5_3 = U5_31 * T(0.00035) + U5_32 * T(0.07278000000000001);
  // N5 = -h_own_5~ Pddot5 - axial(U5 (tr(J_own_5)/2 - J_own_5)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N5_1 = T(0.009138788) * U5_32 + T(0.009138788) * U5_23 - T(0.01885875) * (minus_U5_22 - minus_U5_33) +
      T(7.350000000000001e-06) * U5_31 + T(9.117500000000001e-05) * U5_21 - T(0.07278000000000001) * Pddot4_3;
  const T minus_N5_2 = T(0.00035) * Pddot4_3 - (T(0.009138788) * U5_13 + T(0.0015950349999999996) * U5_31 +
      T(9.117500000000001e-05) * (minus_U5_33 - minus_U5_11) + T(0.01885875) * U5_12 + T(7.350000000000001e-06) *
      U5_32);
  const T minus_N5_3 = T(0.07278000000000001) * Pddot5_1 - T(0.00035) * Pddot5_2 + T(0.0015950349999999996) * U5_21 -
      T(0.009138788) * U5_12 + T(7.350000000000001e-06) * (minus_U5_11 - minus_U5_22) - T(9.117500000000001e-05) *
      U5_23 + T(0.01885875) * U5_13;

  // ---- body 6 (link_6) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T minus_E6_13 = sines[5];
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 - minus_E6_13 * omega5_3;
  const T omega6_2 = thetadot6 + omega5_2;
  const T omega6_3 = minus_E6_13 * omega5_1 + E6_11 * omega5_3;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_1 = E6_11 * omegadot5_1 + minus_E6_13 * minus_omegadot4_3 - thetadot6 * omega6_3;
  const T omegadot6_3 = thetadot6 * omega6_1 + minus_E6_13 * omegadot5_1 - E6_11 * minus_omegadot4_3;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_2 * omega6_1;
  const T U6_12 = t6_1 - omegadot6_3;
  const T t6_2 = omega6_3 * omega6_1;
  const T U6_13 = t6_2 + omegadot5_2;
  const T U6_21 = t6_1 + omegadot6_3;
  const T t6_3 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_3 + omega6_3 * omega6_3;
  const T t6_4 = omega6_3 * omega6_2;
  const T U6_23 = t6_4 - omegadot6_1;
  const T U6_31 = t6_2 - omegadot5_2;
  const T U6_32 = t6_4 + omegadot6_1;
  const T minus_U6_33 = t6_3 + omega6_2 * omega6_2;
  // Pddot6 = E6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = E6_11 * (Pddot5_1 + U5_13 * T(0.4)) - minus_E6_13 * (Pddot4_3 - minus_U5_33 * T(0.4));
  const T Pddot6_2 = Pddot5_2 + U5_23 * T(0.4);
  // effort_link_6_6 = -thetadot6 c_link_6_ + tau_link_6_: along the coordinate [N m], [N]
  const T effort_link_6_6 = u.tau_6 - thetadot6 * c.p.c;
  // G6 = -U6 h_own_6: applied less inertia force, body axes [N]
  const T minus_G6_1 = U6_13 * T(0.12228);
  const T minus_G6_2 = U6_23 * T(0.12228);
  const T G6_3 = minus_U6_33 * T(0.12228);
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(4.32e-07) * (minus_U6_22 - minus_U6_33) - (T(0.0017000000000000001) * U6_32 + T(0.015141848)
      * U6_23) - T(0.12228) * Pddot6_2;
  const T minus_N6_2 = T(0.12228) * Pddot6_1 + T(0.015141848) * U6_13 - T(0.0017000000000000001) * U6_31 + T(4.32e-07)
      * U6_12;
  const T minus_N6_3 = T(0.0017000000000000001) * U6_21 + T(0.0017000000000000001) * U6_12 - T(4.32e-07) * U6_13;

  // ---- body 7 (link_7) on body 6
  const T thetadot7 = y[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T E7_12 = sines[6];
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 + E7_12 * omega6_2;
  const T omega7_2 = E7_11 * omega6_2 - E7_12 * omega6_1;
  const T omega7_3 = thetadot7 + omega6_3;
  // omegadot7 = -thetadot7 b7~ E7 omega6 + E7 omegadot6: angular acceleration, body axes [rad/s^2]
  const T omegadot7_1 = thetadot7 * omega7_2 + E7_11 * omegadot6_1 + E7_12 * omegadot5_2;
  const T omegadot7_2 = E7_11 * omegadot5_2 - E7_12 * omegadot6_1 - thetadot7 * omega7_1;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t7_1 = omega7_2 * omega7_1;
  const T U7_12 = t7_1 - omegadot6_3;
  const T t7_2 = omega7_3 * omega7_1;
  const T U7_13 = t7_2 + omegadot7_2;
  const T U7_21 = t7_1 + omegadot6_3;
  const T t7_3 = omega7_3 * omega7_2;
  const T U7_23 = t7_3 - omegadot7_1;
  const T U7_31 = t7_2 - omegadot7_2;
  const T U7_32 = t7_3 + omegadot7_1;
  // effort_link_7_7 = -thetadot7 c_link_7_ + tau_link_7_: along the coordinate [N m], [N]
  const T effort_link_7_7 = u.tau_7 - thetadot7 * c.p.c;
  // N7 = -h_own_7~ Pddot7 - axial(U7 (tr(J_own_7)/2 - J_own_7)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N7_1 = T(5e-04) * U7_32 + T(5e-04) * U7_23;
  const T N7_2 = T(5e-04) * U7_13 + T(5e-04) * U7_31;
  const T minus_N7_3 = T(5e-04) * U7_21 - T(5e-04) * U7_12;

  // ---- body 7 (link_7) and what it carries
  // u_7 = b7 . N7 + effort_link_7_7: drives it [N m], [N]
  const T u_7 = effort_link_7_7 - minus_N7_3;
  // v7 = invD7 u_7: u/D
  const T v7 = T(1000) * u_7;
  // np7 = E7^T nt7: moment passed on, lower body's axes [N m]
  const T minus_np7_1 = E7_11 * minus_N7_1 + E7_12 * N7_2;
  const T np7_2 = E7_11 * N7_2 - E7_12 * minus_N7_1;

  // ---- body 6 (link_6) and what it carries
  // n6 = N6 + np7: moment that drives it, body axes [N m]
  const T minus_n6_1 = minus_np7_1 + minus_N6_1;
  const T n6_2 = np7_2 - minus_N6_2;
  const T minus_n6_3 = effort_link_7_7 + minus_N6_3;
  // u_6 = b6 . n6 + effort_link_6_6: drives it [N m], [N]
  const T u_6 = n6_2 + effort_link_6_6;
  // v6 = invD6 u_6: u/D
  const T v6 = T(59.37590696697892) * u_6;
  // gt6 = g6 - v6 B6: force with the turn solved [N]
  const T minus_gt6_1 = minus_G6_1 + v6 * T(0.12228);
  // nt6 = -effort_link_6_6 b6 + P_b6 (n6 - v6 K6): moment with the turn solved [N m]
  const T nt6_3 = v6 * T(4.32e-07) - minus_n6_3;
  // Mp6 = E6^T M6 E6: M passed on, lower body's axes [kg]
  const T b6_1 = minus_E6_13 * T(0.8878122163316045);
  const T b6_2 = minus_E6_13 * b6_1;
  const T Mp6_11 = b6_2 - T(0.8878122163316045);
  const T Mp6_13 = E6_11 * b6_1;
  // gp6 = E6^T gt6: force passed on, lower body's axes [N]
  const T gp6_1 = minus_E6_13 * G6_3 - E6_11 * minus_gt6_1;
  const T gp6_3 = minus_E6_13 * minus_gt6_1 + E6_11 * G6_3;
  // Hp6 = E6^T H6 E6: H passed on, lower body's axes [kg m]
  const T b6_3 = E6_11 * T(3.136529910494383e-06);
  const T Hp6_11 = minus_E6_13 * b6_3;
  const T minus_Hp6_12 = E6_11 * T(0.12228);
  const T b6_4 = E6_11 * b6_3;
  const T Hp6_13 = b6_4 - T(3.136529910494383e-06);
  const T Hp6_32 = minus_E6_13 * T(0.12228);
  // Jp6 = E6^T J6 E6: J passed on, lower body's axes [kg m^2]
  const T b6_5 = minus_E6_13 * T(0.013441848011080969);
  const T b6_6 = minus_E6_13 * b6_5;
  const T Jp6_11 = T(0.013441848) - b6_6;
  const T minus_Jp6_13 = E6_11 * b6_5;
  const T Jp6_33 = b6_6 - T(1.1080969261805474e-11);
  // np6 = E6^T nt6: moment passed on, lower body's axes [N m]
  const T np6_1 = minus_E6_13 * nt6_3 - E6_11 * minus_n6_1;
  const T np6_3 = minus_E6_13 * minus_n6_1 + E6_11 * nt6_3;
  // Hb6 = q6~ Mp6 + Hp6: H of the joint at the lower body's origin, its axes
  const T Hb6_21 = T(0.4) * Mp6_11;
  const T Hb6_23 = T(0.4) * Mp6_13;

  // ---- body 5 (link_5) and what it carries
  // HA5 = h_own_5~ + Hb6: moment for an acceleration of the origin, body axes [kg m]
  const T HA5_13 = Hp6_13 - T(0.07278000000000001);
  const T HA5_23 = T(0.00035) + Hb6_23;
  const T HA5_31 = b6_4 + T(0.07278000000000001);
  const T HA5_32 = Hp6_32 - T(0.00035);
  // JA5 = q6~ Hp6^T + J_own_5 + Jp6 - Hb6 q6~: moment for an angular acceleration, body axes [kg m^2]
  const T JA5_11 = Jp6_11 + T(0.8) * minus_Hp6_12;
  const T JA5_12 = T(0.4) * Hp6_11 - T(7.350000000000001e-06);
  const T JA5_13 = T(9.117500000000001e-05) - T(0.4) * Hp6_32 - minus_Jp6_13;
  const T JA5_22 = Hb6_21 * T(0.4) - T(0.007543753000000001);
  const T JA5_23 = T(0.01885875) + T(0.4) * b6_4;
  const T JA5_33 = T(0.010733823) + Jp6_33;
  // g5 = G5 + gp6: force that drives it, home axes [N]
  const T g5_1 = gp6_1 - minus_G5_1;
  const T minus_g5_2 = minus_G6_2 + minus_G5_2;
  const T g5_3 = gp6_3 + G5_3;
  // n5 = q6~ gp6 + N5 + np6: moment that drives it, body axes [N m]
  const T n5_1 = np6_1 - minus_N5_1 + T(0.4) * minus_G6_2;
  const T n5_2 = T(0.4) * gp6_1 - (minus_N5_2 + effort_link_6_6);
  const T n5_3 = np6_3 - minus_N5_3;
  // invD5 = D5^-1: 1/D
  const T invD5 = T(1) / JA5_33;
  // kB5 = invD5 B5: B/D
  const T kB5_1 = invD5 * HA5_31;
  const T kB5_2 = invD5 * HA5_32;
  const T minus_kB5_3 = invD5 * Hp6_11;
  // kK5 = invD5 K5: K/D
  const T kK5_1 = invD5 * JA5_13;
  const T kK5_2 = invD5 * JA5_23;
  // u_5 = b5 . n5 + effort_link_5_5: drives it [N m], [N]
  const T u_5 = n5_3 + effort_link_5_5;
  // v5 = invD5 u_5: u/D
  const T v5 = invD5 * u_5;
  // M5 = Mp6 - kB5 B5^T: MA less what the turn takes up [kg]
  const T M5_11 = Mp6_11 - kB5_1 * HA5_31;
  const T minus_M5_12 = kB5_1 * HA5_32;
  const T M5_13 = Mp6_13 + kB5_1 * Hp6_11;
  const T minus_M5_22 = kB5_2 * HA5_32;
  const T M5_23 = kB5_2 * Hp6_11;
  const T minus_M5_33 = b6_2 + minus_kB5_3 * Hp6_11;
  // H5 = P_b5 (HA5 - kK5 B5^T): HA less what the turn takes up [kg m]
  const T H5_11 = Hp6_11 - kK5_1 * HA5_31;
  const T minus_H5_12 = minus_Hp6_12 + kK5_1 * HA5_32;
  const T H5_13 = HA5_13 + kK5_1 * Hp6_11;
  const T H5_21 = Hb6_21 - kK5_2 * HA5_31;
  const T minus_H5_22 = kK5_2 * HA5_32;
  const T H5_23 = HA5_23 + kK5_2 * Hp6_11;
  // J5 = P_b5 (JA5 - kK5 K5^T) P_b5: JA less what the turn takes up [kg m^2]
  const T J5_11 = JA5_11 - kK5_1 * JA5_13;
  const T J5_12 = JA5_12 - kK5_1 * JA5_23;
  const T J5_22 = JA5_22 - kK5_2 * JA5_23;
  // gt5 = g5 - v5 B5: force with the turn solved [N]
  const T gt5_1 = g5_1 - v5 * HA5_31;
  const T minus_gt5_2 = minus_g5_2 + v5 * HA5_32;
  const T gt5_3 = g5_3 + v5 * Hp6_11;
  // nt5 = -effort_link_5_5 b5 + P_b5 (n5 - v5 K5): moment with the turn solved [N m]
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
  const T gp5_1 = E5_11 * gt5_1 + E5_12 * minus_gt5_2;
  const T gp5_2 = E5_12 * gt5_1 - E5_11 * minus_gt5_2;
  // Hp5 = E5^T H5 E5: H passed on, lower body's axes [kg m]
  const T b5_4 = E5_12 * (H5_11 + minus_H5_22) + E5_11 * (H5_21 - minus_H5_12);
  const T b5_5 = E5_12 * b5_4;
  const T Hp5_11 = H5_11 - b5_5;
  const T b5_6 = E5_11 * b5_4;
  const T Hp5_12 = b5_6 - H5_21;
  const T Hp5_13 = E5_11 * H5_13 - E5_12 * H5_23;
  const T Hp5_21 = b5_6 + minus_H5_12;
  const T Hp5_22 = b5_5 - minus_H5_22;
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

  // ---- body 4 (link_4) and what it carries
  // HA4 = h_own_4~ + Hp5: moment for an acceleration of the origin, body axes [kg m]
  const T HA4_12 = Hp5_12 - T(2.34625);
  const T HA4_21 = T(2.34625) + Hp5_21;
  // JA4 = J_own_4 + Jp5: moment for an angular acceleration, body axes [kg m^2]
  const T JA4_11 = T(0.750066163) + Jp5_11;
  const T JA4_22 = T(0.755466163) + Jp5_22;
  // g4 = G4 + gp5: force that drives it, home axes [N]
  const T g4_1 = gp5_1 - minus_G4_1;
  const T g4_2 = gp5_2 - minus_G4_2;
  const T g4_3 = gt5_3 + G4_3;
  // n4 = N4 + np5: moment that drives it, body axes [N m]
  const T n4_1 = np5_1 + N4_1;
  const T n4_2 = np5_2 - minus_N4_2;
  const T minus_n4_3 = effort_link_5_5 + minus_N4_3;
  // invD4 = D4^-1: 1/D
  const T invD4 = T(1) / JA4_22;
  // kB4 = invD4 B4: B/D
  const T minus_kB4_1 = invD4 * HA4_21;
  const T minus_kB4_2 = invD4 * Hp5_22;
  const T minus_kB4_3 = invD4 * Hp5_23;
  // kK4 = invD4 K4: K/D
  const T minus_kK4_1 = invD4 * Jp5_12;
  const T minus_kK4_3 = invD4 * T(0.007973000000000001);
  // u_4 = b4 . n4 + effort_link_4_4: drives it [N m], [N]
  const T u_4 = effort_link_4_4 - n4_2;
  // v4 = invD4 u_4: u/D
  const T v4 = invD4 * u_4;
  // M4 = Mp5 - kB4 B4^T: MA less what the turn takes up [kg]
  const T M4_11 = Mp5_11 - minus_kB4_1 * HA4_21;
  const T M4_12 = Mp5_12 - minus_kB4_1 * Hp5_22;
  const T M4_13 = Mp5_13 - minus_kB4_1 * Hp5_23;
  const T M4_22 = Mp5_22 - minus_kB4_2 * Hp5_22;
  const T M4_23 = Mp5_23 - minus_kB4_2 * Hp5_23;
  const T minus_M4_33 = minus_M5_33 + minus_kB4_3 * Hp5_23;
  // H4 = P_b4 (HA4 - kK4 B4^T): HA less what the turn takes up [kg m]
  const T H4_11 = Hp5_11 - minus_kK4_1 * HA4_21;
  const T H4_12 = HA4_12 - minus_kK4_1 * Hp5_22;
  const T H4_13 = Hp5_13 - minus_kK4_1 * Hp5_23;
  const T minus_H4_31 = minus_kK4_3 * HA4_21;
  const T minus_H4_32 = minus_kK4_3 * Hp5_22;
  const T minus_H4_33 = minus_kK4_3 * Hp5_23;
  // J4 = P_b4 (JA4 - kK4 K4^T) P_b4: JA less what the turn takes up [kg m^2]
  const T J4_11 = JA4_11 - minus_kK4_1 * Jp5_12;
  const T minus_J4_13 = minus_kK4_1 * T(0.007973000000000001);
  const T minus_J4_33 = minus_kK4_3 * T(0.007973000000000001);
  // gt4 = g4 - v4 B4: force with the turn solved [N]
  const T gt4_1 = g4_1 + v4 * HA4_21;
  const T gt4_2 = g4_2 + v4 * Hp5_22;
  const T gt4_3 = g4_3 + v4 * Hp5_23;
  // nt4 = -effort_link_4_4 b4 + P_b4 (n4 - v4 K4): moment with the turn solved [N m]
  const T nt4_1 = n4_1 + v4 * Jp5_12;
  const T nt4_3 = v4 * T(0.007973000000000001) - minus_n4_3;
  // Mp4 = E4^T M4 E4: M passed on, lower body's axes [kg]
  const T b4_1 = T(2) * E4_11;
  const T Mp4_11 = M4_11 - E4_13 * (E4_13 * (minus_M4_33 + M4_11) + b4_1 * M4_13);
  const T Mp4_12 = E4_11 * M4_12 - E4_13 * M4_23;
  // gp4 = E4^T gt4: force passed on, lower body's axes [N]
  const T gp4_1 = E4_11 * gt4_1 - E4_13 * gt4_3;
  // Hp4 = E4^T H4 E4: H passed on, lower body's axes [kg m]
  const T b4_2 = E4_11 * (H4_13 - minus_H4_31) + E4_13 * (H4_11 + minus_H4_33);
  const T Hp4_11 = H4_11 - E4_13 * b4_2;
  const T Hp4_12 = E4_11 * H4_12 + E4_13 * minus_H4_32;
  const T Hp4_31 = E4_11 * b4_2 - H4_13;
  const T Hp4_32 = E4_13 * H4_12 - E4_11 * minus_H4_32;
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_3 = E4_13 * (minus_J4_33 + J4_11) - b4_1 * minus_J4_13;
  const T b4_4 = E4_13 * b4_3;
  const T Jp4_11 = J4_11 - b4_4;
  const T Jp4_13 = minus_J4_13 + E4_11 * b4_3;
  const T Jp4_33 = b4_4 - minus_J4_33;
  // np4 = E4^T nt4: moment passed on, lower body's axes [N m]
  const T np4_1 = E4_11 * nt4_1 - E4_13 * nt4_3;
  const T np4_3 = E4_13 * nt4_1 + E4_11 * nt4_3;
  // Hb4 = q4~ Mp4 + Hp4: H of the joint at the lower body's origin, its axes
  const T Hb4_11 = Hp4_11 - T(0.42) * Mp4_12;
  const T Hb4_12 = Hp4_12 - T(0.42) * M4_22;
  const T Hb4_21 = T(0.42) * Mp4_11;

  // ---- body 3 (link_3) and what it carries
  // JA3 = q4~ Hp4^T + J_own_3 + Jp4 - Hb4 q4~: moment for an angular acceleration, body axes [kg m^2]
  const T JA3_11 = Jp4_11 - T(0.42) * Hp4_12 - Hb4_12 * T(0.42);
  const T JA3_12 = Hb4_11 * T(0.42);
  const T JA3_13 = Jp4_13 - T(0.42) * Hp4_32;
  const T JA3_22 = Hb4_21 * T(0.42) - T(0.024796000000000002);
  const T JA3_23 = T(0.014857500000000004) + T(0.42) * Hp4_31;
  const T JA3_33 = T(0.031196) + Jp4_33;
  // n3 = q4~ gp4 + N3 + np4: moment that drives it, body axes [N m]
  const T n3_1 = np4_1 - minus_N3_1 - T(0.42) * gt4_2;
  const T n3_2 = N3_2 + effort_link_4_4 + T(0.42) * gp4_1;
  const T n3_3 = np4_3 - minus_N3_3;
  // invD3 = D3^-1: 1/D
  const T invD3 = T(1) / JA3_33;
  // kK3 = invD3 K3: K/D
  const T kK3_1 = invD3 * JA3_13;
  const T kK3_2 = invD3 * JA3_23;
  // u_3 = b3 . n3 + effort_link_3_3: drives it [N m], [N]
  const T u_3 = n3_3 + effort_link_3_3;
  // v3 = invD3 u_3: u/D
  const T v3 = invD3 * u_3;
  // J3 = P_b3 (JA3 - kK3 K3^T) P_b3: JA less what the turn takes up [kg m^2]
  const T J3_11 = JA3_11 - kK3_1 * JA3_13;
  const T J3_12 = JA3_12 - kK3_1 * JA3_23;
  const T J3_22 = JA3_22 - kK3_2 * JA3_23;
  // nt3 = -effort_link_3_3 b3 + P_b3 (n3 - v3 K3): moment with the turn solved [N m]
  const T nt3_1 = n3_1 - v3 * JA3_13;
  const T nt3_2 = n3_2 - v3 * JA3_23;
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_1 = E3_12 * (J3_11 - J3_22) + T(2) * E3_11 * J3_12;
  const T b3_2 = E3_12 * b3_1;
  const T Jp3_11 = J3_11 - b3_2;
  const T Jp3_12 = E3_11 * b3_1 - J3_12;
  const T Jp3_22 = J3_22 + b3_2;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T np3_1 = E3_11 * nt3_1 - E3_12 * nt3_2;
  const T np3_2 = E3_12 * nt3_1 + E3_11 * nt3_2;

  // ---- body 2 (link_2) and what it carries
  // JA2 = J_own_2 + Jp3: moment for an angular acceleration, body axes [kg m^2]
  const T JA2_11 = T(2.2264156534999997) + Jp3_11;
  const T JA2_12 = T(8.000999999999999e-05) + Jp3_12;
  const T JA2_22 = T(2.2373167965) + Jp3_22;
  // n2 = N2 + np3: moment that drives it, body axes [N m]
  const T n2_1 = np3_1 - minus_N2_1;
  const T n2_2 = np3_2 - minus_N2_2;
  const T minus_n2_3 = effort_link_3_3 + minus_N2_3;
  // invD2 = D2^-1: 1/D
  const T invD2 = T(1) / JA2_22;
  // kK2 = invD2 K2: K/D
  const T kK2_1 = invD2 * JA2_12;
  const T minus_kK2_3 = invD2 * T(0.0157353);
  // u_2 = b2 . n2 + effort_link_2_2: drives it [N m], [N]
  const T u_2 = n2_2 + effort_link_2_2;
  // v2 = invD2 u_2: u/D
  const T v2 = invD2 * u_2;
  // J2 = P_b2 (JA2 - kK2 K2^T) P_b2: JA less what the turn takes up [kg m^2]
  const T J2_11 = JA2_11 - kK2_1 * JA2_12;
  const T J2_13 = T(0.00011239499999999998) + kK2_1 * T(0.0157353);
  const T minus_J2_33 = minus_kK2_3 * T(0.0157353);
  // nt2 = -effort_link_2_2 b2 + P_b2 (n2 - v2 K2): moment with the turn solved [N m]
  const T nt2_1 = n2_1 - v2 * JA2_12;
  const T nt2_3 = v2 * T(0.0157353) - minus_n2_3;
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T minus_Jp2_33 = minus_J2_33 + minus_E2_13 * (T(2) * E2_11 * J2_13 - minus_E2_13 * (minus_J2_33 + J2_11));
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T np2_3 = E2_11 * nt2_3 - minus_E2_13 * nt2_1;

  // ---- body 1 (link_1) and what it carries
  // JA1 = q2~ Hp2^T + J_own_1 + Jp2 - Hb2 q2~: moment for an angular acceleration, body axes [kg m^2]
  const T JA1_33 = T(0.0590859715) - minus_Jp2_33;
  // invD1 = D1^-1: 1/D
  const T invD1 = T(1) / JA1_33;
  // u_1 = b1 . n1 + effort_link_1_1: drives it [N m], [N]
  const T u_1 = np2_3 + effort_link_1_1;
  // v1 = invD1 u_1: u/D
  const T v1 = invD1 * u_1;
  ydot[0] = v1;

  // ---- body 2 (link_2), solved
  // alphaL2 = E2 alpha1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T minus_alphaL2_1 = minus_E2_13 * v1;
  const T alphaL2_3 = E2_11 * v1;
  // phi2 = -kB2 . beta2 + v2 - (P_b2 kK2) . alphaL2
  const T phi2 = v2 + kK2_1 * minus_alphaL2_1 + minus_kK2_3 * alphaL2_3;
  ydot[1] = phi2;

  // ---- body 3 (link_3), solved
  // alphaL3 = E3 alpha2: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL3_1 = E3_12 * phi2 - E3_11 * minus_alphaL2_1;
  const T alphaL3_2 = E3_11 * phi2 + E3_12 * minus_alphaL2_1;
  // phi3 = -kB3 . beta3 + v3 - (P_b3 kK3) . alphaL3
  const T phi3 = v3 - kK3_1 * alphaL3_1 - kK3_2 * alphaL3_2;
  // thetaddot3 = -b3 . alphaL3 + phi3
  const T thetaddot3 = phi3 - alphaL2_3;
  ydot[2] = thetaddot3;

  // ---- body 4 (link_4), solved
  // beta4 = -E4 q4~ alpha3 + E4 beta3: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z4_1 = T(0.42) * alphaL3_2;
  const T beta4_1 = E4_11 * z4_1;
  const T minus_beta4_2 = T(0.42) * alphaL3_1;
  const T minus_beta4_3 = E4_13 * z4_1;
  // alphaL4 = E4 alpha3: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4_1 = E4_11 * alphaL3_1 + E4_13 * phi3;
  const T alphaL4_3 = E4_11 * phi3 - E4_13 * alphaL3_1;
  // phi4 = -kB4 . beta4 + v4 - (P_b4 kK4) . alphaL4
  const T phi4 = v4 + minus_kB4_1 * beta4_1 - minus_kB4_2 * minus_beta4_2 - minus_kB4_3 * minus_beta4_3 + minus_kK4_1
      * alphaL4_1 + minus_kK4_3 * alphaL4_3;
  // thetaddot4 = -b4 . alphaL4 + phi4
  const T thetaddot4 = alphaL3_2 + phi4;
  ydot[3] = thetaddot4;

  // ---- body 5 (link_5), solved
  // beta5 = E5 beta4: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta5_1 = E5_11 * beta4_1 - E5_12 * minus_beta4_2;
  const T minus_beta5_2 = E5_11 * minus_beta4_2 + E5_12 * beta4_1;
  // alphaL5 = E5 alpha4: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL5_1 = E5_11 * alphaL4_1 - E5_12 * phi4;
  const T minus_alphaL5_2 = E5_11 * phi4 + E5_12 * alphaL4_1;
  // phi5 = -kB5 . beta5 + v5 - (P_b5 kK5) . alphaL5
  const T phi5 = v5 + kB5_2 * minus_beta5_2 - kB5_1 * beta5_1 - minus_kB5_3 * minus_beta4_3 - kK5_1 * alphaL5_1 +
      kK5_2 * minus_alphaL5_2;
  // thetaddot5 = -b5 . alphaL5 + phi5
  const T thetaddot5 = phi5 - alphaL4_3;
  ydot[4] = thetaddot5;

  // ---- body 6 (link_6), solved
  // beta6 = -E6 q6~ alpha5 + E6 beta5: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta6_1 = E6_11 * beta5_1 + minus_E6_13 * minus_beta4_3 - T(0.4) * minus_alphaL5_2 * E6_11;
  // alphaL6 = E6 alpha5: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL6_3 = minus_E6_13 * alphaL5_1 + E6_11 * phi5;
  // phi6 = -kB6 . beta6 + v6 - (P_b6 kK6) . alphaL6
  const T phi6 = v6 - T(7.2604859039221825) * beta6_1 + T(2.5650391809734895e-05) * alphaL6_3;
  // thetaddot6 = -b6 . alphaL6 + phi6
  const T thetaddot6 = minus_alphaL5_2 + phi6;
  ydot[5] = thetaddot6;

  // ---- body 7 (link_7), solved
  // thetaddot7 = -b7 . alphaL7 + phi7
  const T thetaddot7 = v7 - alphaL6_3;
  ydot[6] = thetaddot7;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 226 add, 238 multiply, 12 sine or cosine
template <class T>
void residual(const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 6, cosines + 1, sines + 1);

  // ---- body 1 (link_1) on the inertial frame
  const T thetadot1 = y[0];
  const T thetaddot1 = ydot[0];
  // effort_link_1_1 = -thetadot1 c_link_1_ + tau_link_1_: along the coordinate [N m], [N]
  const T effort_link_1_1 = u.tau_1 - thetadot1 * c.p.c;
  // N1 = h_own_1~ Pddot1 + axial(U1 (tr(J_own_1)/2 - J_own_1)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N1_3 = T(0.0590859715) * thetaddot1;

  // ---- body 2 (link_2) on body 1
  const T thetadot2 = y[1];
  const T thetaddot2 = ydot[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T minus_omega2_1 = minus_E2_13 * thetadot1;
  const T omega2_3 = E2_11 * thetadot1;
  // omegadot2 = -thetadot2 b2~ E2 omega1 + thetaddot2 b2 + E2 omegadot1: angular acceleration, body axes [rad/s^2]
  const T t2_1 = omega2_3 * thetadot2;
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
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = minus_E2_13 * T(9.81);
  const T Pddot2_3 = E2_11 * T(9.81);
  // effort_link_2_2 = -thetadot2 c_link_2_ + tau_link_2_: along the coordinate [N m], [N]
  const T effort_link_2_2 = u.tau_2 - thetadot2 * c.p.c;
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(0.0157353) * (minus_U2_22 - minus_U2_33) - (T(0.0054505715) * U2_32 + T(2.2318662249999996) *
      U2_23) + T(8.000999999999999e-05) * minus_U2_31 + T(0.00011239499999999998) * U2_21;
  const T N2_2 = T(0.0019049999999999998) * Pddot2_3 - T(5.7454) * minus_Pddot2_1 + T(2.2318662249999996) * U2_13 +
      T(0.0054505715) * minus_U2_31 - T(0.00011239499999999998) * (minus_U2_33 - minus_U2_11) - T(0.0157353) *
      minus_U2_12 + T(8.000999999999999e-05) * U2_32;
  const T N2_3 = T(0.0054505715) * U2_21 - T(0.0054505715) * minus_U2_12 - T(8.000999999999999e-05) * (minus_U2_11 -
      minus_U2_22) - T(0.00011239499999999998) * U2_23 - T(0.0157353) * U2_13;

  // ---- body 3 (link_3) on body 2
  const T thetadot3 = y[2];
  const T thetaddot3 = ydot[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T E3_12 = sines[2];
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_12 * thetadot2 - E3_11 * minus_omega2_1;
  const T omega3_2 = E3_11 * thetadot2 + E3_12 * minus_omega2_1;
  const T omega3_3 = thetadot3 + omega2_3;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + thetaddot3 b3 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = thetadot3 * omega3_2 + E3_12 * thetaddot2 - E3_11 * minus_omegadot2_1;
  const T omegadot3_2 = E3_11 * thetaddot2 + E3_12 * minus_omegadot2_1 - thetadot3 * omega3_1;
  const T omegadot3_3 = thetaddot3 + omegadot2_3;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_2 * omega3_1;
  const T U3_12 = t3_1 - omegadot3_3;
  const T t3_2 = omega3_3 * omega3_1;
  const T U3_13 = t3_2 + omegadot3_2;
  const T U3_21 = t3_1 + omegadot3_3;
  const T t3_3 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_3 + omega3_3 * omega3_3;
  const T t3_4 = omega3_3 * omega3_2;
  const T U3_23 = t3_4 - omegadot3_1;
  const T U3_31 = t3_2 - omegadot3_2;
  const T U3_32 = t3_4 + omegadot3_1;
  const T minus_U3_33 = t3_3 + omega3_2 * omega3_2;
  // Pddot3 = E3 Pddot2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot3_1 = E3_11 * minus_Pddot2_1;
  const T Pddot3_2 = E3_12 * minus_Pddot2_1;
  // effort_link_3_3 = -thetadot3 c_link_3_ + tau_link_3_: along the coordinate [N m], [N]
  const T effort_link_3_3 = u.tau_3 - thetadot3 * c.p.c;
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(0.027996) * U3_32 + T(0.027996) * U3_23 - T(0.014857500000000004) * (minus_U3_22 - minus_U3_33) -
      T(0.014000000000000012) * Pddot2_3;
  const T minus_N3_2 = T(0.027996) * U3_13 + T(0.0032) * U3_31 + T(0.014857500000000004) * U3_12;
  const T N3_3 = T(0.0032) * U3_21 - T(0.027996) * U3_12 + T(0.014857500000000004) * U3_13 - T(0.014000000000000012) *
      minus_Pddot3_1;

  // ---- body 4 (link_4) on body 3
  const T thetadot4 = y[3];
  const T thetaddot4 = ydot[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_13 = sines[3];
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 + E4_13 * omega3_3;
  const T omega4_2 = omega3_2 - thetadot4;
  const T omega4_3 = E4_11 * omega3_3 - E4_13 * omega3_1;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + thetaddot4 b4 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = thetadot4 * omega4_3 + E4_11 * omegadot3_1 + E4_13 * omegadot3_3;
  const T omegadot4_2 = omegadot3_2 - thetaddot4;
  const T omegadot4_3 = E4_11 * omegadot3_3 - E4_13 * omegadot3_1 - thetadot4 * omega4_1;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_1 = omega4_2 * omega4_1;
  const T U4_12 = t4_1 - omegadot4_3;
  const T t4_2 = omega4_3 * omega4_1;
  const T U4_13 = t4_2 + omegadot4_2;
  const T U4_21 = t4_1 + omegadot4_3;
  const T t4_3 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_3 + omega4_3 * omega4_3;
  const T t4_4 = omega4_3 * omega4_2;
  const T U4_23 = t4_4 - omegadot4_1;
  const T U4_31 = t4_2 - omegadot4_2;
  const T U4_32 = t4_4 + omegadot4_1;
  const T minus_U4_33 = t4_3 + omega4_2 * omega4_2;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_5 = U3_13 * T(0.42) - minus_Pddot3_1;
  const T t4_6 = Pddot2_3 - minus_U3_33 * T(0.42);
  const T Pddot4_1 = E4_11 * t4_5 + E4_13 * t4_6;
  const T Pddot4_2 = U3_23 * T(0.42) + Pddot3_2;
  const T Pddot4_3 = E4_11 * t4_6 - E4_13 * t4_5;
  // effort_link_4_4 = -thetadot4 c_link_4_ + tau_link_4_: along the coordinate [N m], [N]
  const T effort_link_4_4 = u.tau_4 - thetadot4 * c.p.c;
  // G4 = U4 h_own_4: inertia less applied force, body axes [N]
  const T G4_1 = U4_13 * T(2.34625);
  const T G4_2 = U4_23 * T(2.34625);
  const T minus_G4_3 = minus_U4_33 * T(2.34625);
  // N4 = h_own_4~ Pddot4 + axial(U4 (tr(J_own_4)/2 - J_own_4)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T minus_N4_1 = T(2.34625) * Pddot4_2 + T(0.0027) * U4_32 + T(0.752766163) * U4_23 + T(0.007973000000000001) *
      (minus_U4_22 - minus_U4_33);
  const T N4_2 = T(2.34625) * Pddot4_1 + T(0.752766163) * U4_13 - T(0.0027) * U4_31 - T(0.007973000000000001) * U4_12;
  const T N4_3 = T(0.0027) * U4_21 + T(0.0027) * U4_12 + T(0.007973000000000001) * U4_13;

  // ---- body 5 (link_5) on body 4
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
  // Pddot5 = E5 Pddot4: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_1 = E5_11 * Pddot4_1 + E5_12 * Pddot4_2;
  const T Pddot5_2 = E5_11 * Pddot4_2 - E5_12 * Pddot4_1;
  // effort_link_5_5 = -thetadot5 c_link_5_ + tau_link_5_: along the coordinate [N m], [N]
  const T effort_link_5_5 = u.tau_5 - thetadot5 * c.p.c;
  // G5 = U5 h_own_5: inertia less applied force, body axes [N]
  const T G5_1 = minus_U5_11 * T(0.00035) - U5_12 * T(0.07278000000000001);
  const T G5_2 = minus_U5_22 * T(0.07278000000000001) - U5_21 * T(0.00035);
  const T minus_G5_3 = U5_31 * T(0.00035) + U5_32 * T(0.07278000000000001);
  // N5 = h_own_5~ Pddot5 + axial(U5 (tr(J_own_5)/2 - J_own_5)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N5_1 = T(0.009138788) * U5_32 + T(0.009138788) * U5_23 - T(0.01885875) * (minus_U5_22 - minus_U5_33) +
      T(7.350000000000001e-06) * U5_31 + T(9.117500000000001e-05) * U5_21 - T(0.07278000000000001) * Pddot4_3;
  const T N5_2 = T(0.00035) * Pddot4_3 - (T(0.009138788) * U5_13 + T(0.0015950349999999996) * U5_31 +
      T(9.117500000000001e-05) * (minus_U5_33 - minus_U5_11) + T(0.01885875) * U5_12 + T(7.350000000000001e-06) *
      U5_32);
  const T N5_3 = T(0.07278000000000001) * Pddot5_1 - T(0.00035) * Pddot5_2 + T(0.0015950349999999996) * U5_21 -
      T(0.009138788) * U5_12 + T(7.350000000000001e-06) * (minus_U5_11 - minus_U5_22) - T(9.117500000000001e-05) *
      U5_23 + T(0.01885875) * U5_13;

  // ---- body 6 (link_6) on body 5
  const T thetadot6 = y[5];
  const T thetaddot6 = ydot[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T minus_E6_13 = sines[5];
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 - minus_E6_13 * omega5_3;
  const T omega6_2 = thetadot6 + omega5_2;
  const T omega6_3 = minus_E6_13 * omega5_1 + E6_11 * omega5_3;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + thetaddot6 b6 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_1 = E6_11 * omegadot5_1 - minus_E6_13 * omegadot5_3 - thetadot6 * omega6_3;
  const T omegadot6_2 = thetaddot6 + omegadot5_2;
  const T omegadot6_3 = thetadot6 * omega6_1 + minus_E6_13 * omegadot5_1 + E6_11 * omegadot5_3;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_2 * omega6_1;
  const T U6_12 = t6_1 - omegadot6_3;
  const T t6_2 = omega6_3 * omega6_1;
  const T U6_13 = t6_2 + omegadot6_2;
  const T U6_21 = t6_1 + omegadot6_3;
  const T t6_3 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_3 + omega6_3 * omega6_3;
  const T t6_4 = omega6_3 * omega6_2;
  const T U6_23 = t6_4 - omegadot6_1;
  const T U6_31 = t6_2 - omegadot6_2;
  const T U6_32 = t6_4 + omegadot6_1;
  const T minus_U6_33 = t6_3 + omega6_2 * omega6_2;
  // Pddot6 = E6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = E6_11 * (Pddot5_1 + U5_13 * T(0.4)) - minus_E6_13 * (Pddot4_3 - minus_U5_33 * T(0.4));
  const T Pddot6_2 = Pddot5_2 + U5_23 * T(0.4);
  // effort_link_6_6 = -thetadot6 c_link_6_ + tau_link_6_: along the coordinate [N m], [N]
  const T effort_link_6_6 = u.tau_6 - thetadot6 * c.p.c;
  // G6 = U6 h_own_6: inertia less applied force, body axes [N]
  const T G6_1 = U6_13 * T(0.12228);
  const T G6_2 = U6_23 * T(0.12228);
  const T minus_G6_3 = minus_U6_33 * T(0.12228);
  // N6 = h_own_6~ Pddot6 + axial(U6 (tr(J_own_6)/2 - J_own_6)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N6_1 = T(4.32e-07) * (minus_U6_22 - minus_U6_33) - (T(0.0017000000000000001) * U6_32 + T(0.015141848) *
      U6_23) - T(0.12228) * Pddot6_2;
  const T N6_2 = T(0.12228) * Pddot6_1 + T(0.015141848) * U6_13 - T(0.0017000000000000001) * U6_31 + T(4.32e-07) *
      U6_12;
  const T N6_3 = T(0.0017000000000000001) * U6_21 + T(0.0017000000000000001) * U6_12 - T(4.32e-07) * U6_13;

  // ---- body 7 (link_7) on body 6
  const T thetadot7 = y[6];
  const T thetaddot7 = ydot[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T E7_12 = sines[6];
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 + E7_12 * omega6_2;
  const T omega7_2 = E7_11 * omega6_2 - E7_12 * omega6_1;
  const T omega7_3 = thetadot7 + omega6_3;
  // omegadot7 = -thetadot7 b7~ E7 omega6 + thetaddot7 b7 + E7 omegadot6: angular acceleration, body axes [rad/s^2]
  const T omegadot7_1 = thetadot7 * omega7_2 + E7_11 * omegadot6_1 + E7_12 * omegadot6_2;
  const T omegadot7_2 = E7_11 * omegadot6_2 - E7_12 * omegadot6_1 - thetadot7 * omega7_1;
  const T omegadot7_3 = thetaddot7 + omegadot6_3;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t7_1 = omega7_2 * omega7_1;
  const T U7_12 = t7_1 - omegadot7_3;
  const T t7_2 = omega7_3 * omega7_1;
  const T U7_13 = t7_2 + omegadot7_2;
  const T U7_21 = t7_1 + omegadot7_3;
  const T t7_3 = omega7_3 * omega7_2;
  const T U7_23 = t7_3 - omegadot7_1;
  const T U7_31 = t7_2 - omegadot7_2;
  const T U7_32 = t7_3 + omegadot7_1;
  // effort_link_7_7 = -thetadot7 c_link_7_ + tau_link_7_: along the coordinate [N m], [N]
  const T effort_link_7_7 = u.tau_7 - thetadot7 * c.p.c;
  // N7 = h_own_7~ Pddot7 + axial(U7 (tr(J_own_7)/2 - J_own_7)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N7_1 = T(5e-04) * U7_32 + T(5e-04) * U7_23;
  const T minus_N7_2 = T(5e-04) * U7_13 + T(5e-04) * U7_31;
  const T N7_3 = T(5e-04) * U7_21 - T(5e-04) * U7_12;

  // ---- body 7 (link_7) and what it carries
  // r_theta7 = b7 . N7 - effort_link_7_7: Kane's equation of the angle [N m]
  const T r_theta7 = N7_3 - effort_link_7_7;
  r[6] = r_theta7;

  // ---- body 6 (link_6) and what it carries
  // rho6 = E7^T N7 + N6: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho6_1 = N6_1 + E7_11 * N7_1 + E7_12 * minus_N7_2;
  const T rho6_2 = N6_2 + E7_12 * N7_1 - E7_11 * minus_N7_2;
  const T rho6_3 = N7_3 + N6_3;
  // r_theta6 = b6 . rho6 - effort_link_6_6: Kane's equation of the angle [N m]
  const T r_theta6 = rho6_2 - effort_link_6_6;
  r[5] = r_theta6;

  // ---- body 5 (link_5) and what it carries
  // S5 = E6^T S6 + G5: sum of the force balances of the subtree, body axes [N]
  const T b5_1 = E6_11 * G6_1 - minus_E6_13 * minus_G6_3;
  const T S5_1 = b5_1 + G5_1;
  const T S5_2 = G6_2 + G5_2;
  const T minus_S5_3 = minus_G5_3 + minus_E6_13 * G6_1 + E6_11 * minus_G6_3;
  // rho5 = q6~ E6^T S6 + E6^T rho6 + N5: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho5_1 = N5_1 + E6_11 * rho6_1 + minus_E6_13 * rho6_3 - T(0.4) * G6_2;
  const T rho5_2 = rho6_2 + N5_2 + T(0.4) * b5_1;
  const T rho5_3 = N5_3 + E6_11 * rho6_3 - minus_E6_13 * rho6_1;
  // r_theta5 = b5 . rho5 - effort_link_5_5: Kane's equation of the angle [N m]
  const T r_theta5 = rho5_3 - effort_link_5_5;
  r[4] = r_theta5;

  // ---- body 4 (link_4) and what it carries
  // S4 = E5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T S4_1 = E5_11 * S5_1 - E5_12 * S5_2 + G4_1;
  const T S4_2 = E5_12 * S5_1 + E5_11 * S5_2 + G4_2;
  const T minus_S4_3 = minus_S5_3 + minus_G4_3;
  // rho4 = E5^T rho5 + N4: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho4_1 = E5_11 * rho5_1 - minus_N4_1 - E5_12 * rho5_2;
  const T rho4_2 = N4_2 + E5_12 * rho5_1 + E5_11 * rho5_2;
  const T rho4_3 = rho5_3 + N4_3;
  // r_theta4 = b4 . rho4 - effort_link_4_4: Kane's equation of the angle [N m]
  const T minus_r_theta4 = rho4_2 + effort_link_4_4;
  r[3] = -minus_r_theta4;

  // ---- body 3 (link_3) and what it carries
  // rho3 = q4~ E4^T S4 + E4^T rho4 + N3: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho3_1 = N3_1 + E4_11 * rho4_1 - E4_13 * rho4_3 - T(0.42) * S4_2;
  const T rho3_2 = rho4_2 - minus_N3_2 + T(0.42) * (E4_11 * S4_1 + E4_13 * minus_S4_3);
  const T rho3_3 = N3_3 + E4_13 * rho4_1 + E4_11 * rho4_3;
  // r_theta3 = b3 . rho3 - effort_link_3_3: Kane's equation of the angle [N m]
  const T r_theta3 = rho3_3 - effort_link_3_3;
  r[2] = r_theta3;

  // ---- body 2 (link_2) and what it carries
  // rho2 = E3^T rho3 + N2: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho2_1 = N2_1 + E3_11 * rho3_1 - E3_12 * rho3_2;
  const T rho2_2 = N2_2 + E3_12 * rho3_1 + E3_11 * rho3_2;
  const T rho2_3 = rho3_3 + N2_3;
  // r_theta2 = b2 . rho2 - effort_link_2_2: Kane's equation of the angle [N m]
  const T r_theta2 = rho2_2 - effort_link_2_2;
  r[1] = r_theta2;

  // ---- body 1 (link_1) and what it carries
  // rho1 = q2~ E2^T S2 + E2^T rho2 + N1: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho1_3 = E2_11 * rho2_3 - minus_E2_13 * rho2_1 + N1_3;
  // r_theta1 = b1 . rho1 - effort_link_1_1: Kane's equation of the angle [N m]
  const T r_theta1 = rho1_3 - effort_link_1_1;
  r[0] = r_theta1;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 207 add, 228 multiply, 12 sine or cosine
template <class T>
void forcing(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* f) noexcept {
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 6, cosines + 1, sines + 1);

  // ---- body 1 (link_1) on the inertial frame
  const T thetadot1 = y[0];
  // effort_link_1_1 = -thetadot1 c_link_1_ + tau_link_1_: along the coordinate [N m], [N]
  const T effort_link_1_1 = u.tau_1 - thetadot1 * c.p.c;

  // ---- body 2 (link_2) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T minus_omega2_1 = minus_E2_13 * thetadot1;
  const T omega2_3 = E2_11 * thetadot1;
  // effort_link_2_2 = -thetadot2 c_link_2_ + tau_link_2_: along the coordinate [N m], [N]
  const T effort_link_2_2 = u.tau_2 - thetadot2 * c.p.c;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot2_1 = omega2_3 * thetadot2;
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
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = minus_E2_13 * T(9.81);
  const T Pddot2_3 = E2_11 * T(9.81);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(0.0157353) * (minus_U2_22 - minus_U2_33) - T(2.2318662249999996) * U2_23 +
      T(8.000999999999999e-05) * minus_U2_13 - T(0.00011239499999999998) * minus_U2_21;
  const T minus_N2_2 = T(0.0019049999999999998) * Pddot2_3 - T(5.7454) * minus_Pddot2_1 - T(2.2264156534999997) *
      minus_U2_13 - T(0.00011239499999999998) * (minus_U2_33 - minus_U2_11);
  const T minus_N2_3 = T(0.0157353) * minus_U2_13 - (T(0.0054505715) * minus_U2_21 + T(8.000999999999999e-05) *
      (minus_U2_11 - minus_U2_22) + T(0.00011239499999999998) * U2_23);

  // ---- body 3 (link_3) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T E3_12 = sines[2];
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_12 * thetadot2 - E3_11 * minus_omega2_1;
  const T omega3_2 = E3_11 * thetadot2 + E3_12 * minus_omega2_1;
  const T omega3_3 = thetadot3 + omega2_3;
  // effort_link_3_3 = -thetadot3 c_link_3_ + tau_link_3_: along the coordinate [N m], [N]
  const T effort_link_3_3 = u.tau_3 - thetadot3 * c.p.c;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = thetadot3 * omega3_2 - E3_11 * minus_omegadot2_1;
  const T omegadot3_2 = E3_12 * minus_omegadot2_1 - thetadot3 * omega3_1;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_2 * omega3_1;
  const T U3_12 = t3_1 + minus_omegadot2_3;
  const T t3_2 = omega3_3 * omega3_1;
  const T U3_13 = t3_2 + omegadot3_2;
  const T U3_21 = t3_1 - minus_omegadot2_3;
  const T t3_3 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_3 + omega3_3 * omega3_3;
  const T t3_4 = omega3_3 * omega3_2;
  const T U3_23 = t3_4 - omegadot3_1;
  const T U3_31 = t3_2 - omegadot3_2;
  const T U3_32 = t3_4 + omegadot3_1;
  const T minus_U3_33 = t3_3 + omega3_2 * omega3_2;
  // Pddot3 = E3 Pddot2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot3_1 = E3_11 * minus_Pddot2_1;
  const T Pddot3_2 = E3_12 * minus_Pddot2_1;
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(0.027996) * U3_32 + T(0.027996) * U3_23 - T(0.014857500000000004) * (minus_U3_22 -
      minus_U3_33) - T(0.014000000000000012) * Pddot2_3;
  const T N3_2 = T(0.027996) * U3_13 + T(0.0032) * U3_31 + T(0.014857500000000004) * U3_12;
  const T minus_N3_3 = T(0.0032) * U3_21 - T(0.027996) * U3_12 + T(0.014857500000000004) * U3_13 -
      T(0.014000000000000012) * minus_Pddot3_1;

  // ---- body 4 (link_4) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_13 = sines[3];
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 + E4_13 * omega3_3;
  const T omega4_2 = omega3_2 - thetadot4;
  const T omega4_3 = E4_11 * omega3_3 - E4_13 * omega3_1;
  // effort_link_4_4 = -thetadot4 c_link_4_ + tau_link_4_: along the coordinate [N m], [N]
  const T effort_link_4_4 = u.tau_4 - thetadot4 * c.p.c;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = thetadot4 * omega4_3 + E4_11 * omegadot3_1 - E4_13 * minus_omegadot2_3;
  const T minus_omegadot4_3 = thetadot4 * omega4_1 + E4_13 * omegadot3_1 + E4_11 * minus_omegadot2_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_1 = omega4_2 * omega4_1;
  const T U4_12 = t4_1 + minus_omegadot4_3;
  const T t4_2 = omega4_3 * omega4_1;
  const T U4_13 = t4_2 + omegadot3_2;
  const T U4_21 = t4_1 - minus_omegadot4_3;
  const T t4_3 = omega4_1 * omega4_1;
  const T minus_U4_22 = t4_3 + omega4_3 * omega4_3;
  const T t4_4 = omega4_3 * omega4_2;
  const T U4_23 = t4_4 - omegadot4_1;
  const T U4_31 = t4_2 - omegadot3_2;
  const T U4_32 = t4_4 + omegadot4_1;
  const T minus_U4_33 = t4_3 + omega4_2 * omega4_2;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_5 = U3_13 * T(0.42) - minus_Pddot3_1;
  const T t4_6 = Pddot2_3 - minus_U3_33 * T(0.42);
  const T Pddot4_1 = E4_11 * t4_5 + E4_13 * t4_6;
  const T Pddot4_2 = U3_23 * T(0.42) + Pddot3_2;
  const T Pddot4_3 = E4_11 * t4_6 - E4_13 * t4_5;
  // G4 = -U4 h_own_4: applied less inertia force, body axes [N]
  const T minus_G4_1 = U4_13 * T(2.34625);
  const T minus_G4_2 = U4_23 * T(2.34625);
  const T G4_3 = minus_U4_33 * T(2.34625);
  // N4 = -h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N4_1 = T(2.34625) * Pddot4_2 + T(0.0027) * U4_32 + T(0.752766163) * U4_23 + T(0.007973000000000001) *
      (minus_U4_22 - minus_U4_33);
  const T minus_N4_2 = T(2.34625) * Pddot4_1 + T(0.752766163) * U4_13 - T(0.0027) * U4_31 - T(0.007973000000000001) *
      U4_12;
  const T minus_N4_3 = T(0.0027) * U4_21 + T(0.0027) * U4_12 + T(0.007973000000000001) * U4_13;

  // ---- body 5 (link_5) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 + E5_12 * omega4_2;
  const T omega5_2 = E5_11 * omega4_2 - E5_12 * omega4_1;
  const T omega5_3 = thetadot5 + omega4_3;
  // effort_link_5_5 = -thetadot5 c_link_5_ + tau_link_5_: along the coordinate [N m], [N]
  const T effort_link_5_5 = u.tau_5 - thetadot5 * c.p.c;
  // omegadot5 = -thetadot5 b5~ E5 omega4 + E5 omegadot4: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = thetadot5 * omega5_2 + E5_11 * omegadot4_1 + E5_12 * omegadot3_2;
  const T omegadot5_2 = E5_11 * omegadot3_2 - E5_12 * omegadot4_1 - thetadot5 * omega5_1;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_1 = omega5_3 * omega5_3;
  const T t5_2 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_1 + t5_2;
  const T t5_3 = omega5_2 * omega5_1;
  const T U5_12 = t5_3 + minus_omegadot4_3;
  const T t5_4 = omega5_3 * omega5_1;
  const T U5_13 = t5_4 + omegadot5_2;
  const T U5_21 = t5_3 - minus_omegadot4_3;
  const T t5_5 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_1 + t5_5;
  const T t5_6 = omega5_3 * omega5_2;
  const T U5_23 = t5_6 - omegadot5_1;
  const T U5_31 = t5_4 - omegadot5_2;
  const T U5_32 = t5_6 + omegadot5_1;
  const T minus_U5_33 = t5_2 + t5_5;
  // Pddot5 = E5 Pddot4: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_1 = E5_11 * Pddot4_1 + E5_12 * Pddot4_2;
  const T Pddot5_2 = E5_11 * Pddot4_2 - E5_12 * Pddot4_1;
  // G5 = -U5 h_own_5: applied less inertia force, body axes [N]
  const T minus_G5_1 = minus_U5_11 * T(0.00035) - U5_12 * T(0.07278000000000001);
  const T minus_G5_2 = minus_U5_22 * T(0.07278000000000001) - U5_21 * T(0.00035);
  const T G5_3 = U5_31 * T(0.00035) + U5_32 * T(0.07278000000000001);
  // N5 = -h_own_5~ Pddot5 - axial(U5 (tr(J_own_5)/2 - J_own_5)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N5_1 = T(0.009138788) * U5_32 + T(0.009138788) * U5_23 - T(0.01885875) * (minus_U5_22 - minus_U5_33) +
      T(7.350000000000001e-06) * U5_31 + T(9.117500000000001e-05) * U5_21 - T(0.07278000000000001) * Pddot4_3;
  const T minus_N5_2 = T(0.00035) * Pddot4_3 - (T(0.009138788) * U5_13 + T(0.0015950349999999996) * U5_31 +
      T(9.117500000000001e-05) * (minus_U5_33 - minus_U5_11) + T(0.01885875) * U5_12 + T(7.350000000000001e-06) *
      U5_32);
  const T minus_N5_3 = T(0.07278000000000001) * Pddot5_1 - T(0.00035) * Pddot5_2 + T(0.0015950349999999996) * U5_21 -
      T(0.009138788) * U5_12 + T(7.350000000000001e-06) * (minus_U5_11 - minus_U5_22) - T(9.117500000000001e-05) *
      U5_23 + T(0.01885875) * U5_13;

  // ---- body 6 (link_6) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T minus_E6_13 = sines[5];
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 - minus_E6_13 * omega5_3;
  const T omega6_2 = thetadot6 + omega5_2;
  const T omega6_3 = minus_E6_13 * omega5_1 + E6_11 * omega5_3;
  // effort_link_6_6 = -thetadot6 c_link_6_ + tau_link_6_: along the coordinate [N m], [N]
  const T effort_link_6_6 = u.tau_6 - thetadot6 * c.p.c;
  // omegadot6 = -thetadot6 b6~ E6 omega5 + E6 omegadot5: angular acceleration, body axes [rad/s^2]
  const T omegadot6_1 = E6_11 * omegadot5_1 + minus_E6_13 * minus_omegadot4_3 - thetadot6 * omega6_3;
  const T omegadot6_3 = thetadot6 * omega6_1 + minus_E6_13 * omegadot5_1 - E6_11 * minus_omegadot4_3;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_2 * omega6_1;
  const T U6_12 = t6_1 - omegadot6_3;
  const T t6_2 = omega6_3 * omega6_1;
  const T U6_13 = t6_2 + omegadot5_2;
  const T U6_21 = t6_1 + omegadot6_3;
  const T t6_3 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_3 + omega6_3 * omega6_3;
  const T t6_4 = omega6_3 * omega6_2;
  const T U6_23 = t6_4 - omegadot6_1;
  const T U6_31 = t6_2 - omegadot5_2;
  const T U6_32 = t6_4 + omegadot6_1;
  const T minus_U6_33 = t6_3 + omega6_2 * omega6_2;
  // Pddot6 = E6 (U5 q6 + Pddot5): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = E6_11 * (Pddot5_1 + U5_13 * T(0.4)) - minus_E6_13 * (Pddot4_3 - minus_U5_33 * T(0.4));
  const T Pddot6_2 = Pddot5_2 + U5_23 * T(0.4);
  // G6 = -U6 h_own_6: applied less inertia force, body axes [N]
  const T minus_G6_1 = U6_13 * T(0.12228);
  const T minus_G6_2 = U6_23 * T(0.12228);
  const T G6_3 = minus_U6_33 * T(0.12228);
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(4.32e-07) * (minus_U6_22 - minus_U6_33) - (T(0.0017000000000000001) * U6_32 + T(0.015141848)
      * U6_23) - T(0.12228) * Pddot6_2;
  const T minus_N6_2 = T(0.12228) * Pddot6_1 + T(0.015141848) * U6_13 - T(0.0017000000000000001) * U6_31 + T(4.32e-07)
      * U6_12;
  const T minus_N6_3 = T(0.0017000000000000001) * U6_21 + T(0.0017000000000000001) * U6_12 - T(4.32e-07) * U6_13;

  // ---- body 7 (link_7) on body 6
  const T thetadot7 = y[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T E7_12 = sines[6];
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 + E7_12 * omega6_2;
  const T omega7_2 = E7_11 * omega6_2 - E7_12 * omega6_1;
  const T omega7_3 = thetadot7 + omega6_3;
  // effort_link_7_7 = -thetadot7 c_link_7_ + tau_link_7_: along the coordinate [N m], [N]
  const T effort_link_7_7 = u.tau_7 - thetadot7 * c.p.c;
  // omegadot7 = -thetadot7 b7~ E7 omega6 + E7 omegadot6: angular acceleration, body axes [rad/s^2]
  const T omegadot7_1 = thetadot7 * omega7_2 + E7_11 * omegadot6_1 + E7_12 * omegadot5_2;
  const T omegadot7_2 = E7_11 * omegadot5_2 - E7_12 * omegadot6_1 - thetadot7 * omega7_1;
  // U7 = omega7~ omega7~ + omegadot7~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t7_1 = omega7_2 * omega7_1;
  const T U7_12 = t7_1 - omegadot6_3;
  const T t7_2 = omega7_3 * omega7_1;
  const T U7_13 = t7_2 + omegadot7_2;
  const T U7_21 = t7_1 + omegadot6_3;
  const T t7_3 = omega7_3 * omega7_2;
  const T U7_23 = t7_3 - omegadot7_1;
  const T U7_31 = t7_2 - omegadot7_2;
  const T U7_32 = t7_3 + omegadot7_1;
  // N7 = -h_own_7~ Pddot7 - axial(U7 (tr(J_own_7)/2 - J_own_7)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N7_1 = T(5e-04) * U7_32 + T(5e-04) * U7_23;
  const T N7_2 = T(5e-04) * U7_13 + T(5e-04) * U7_31;
  const T minus_N7_3 = T(5e-04) * U7_21 - T(5e-04) * U7_12;

  // ---- body 7 (link_7) and what it carries
  // f_theta7 = b7 . N7 + effort_link_7_7: Kane's equation of the angle [N m]
  const T f_theta7 = effort_link_7_7 - minus_N7_3;
  f[6] = f_theta7;

  // ---- body 6 (link_6) and what it carries
  // rho6 = E7^T N7 + N6: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T minus_rho6_1 = minus_N6_1 + E7_12 * N7_2 + E7_11 * minus_N7_1;
  const T minus_rho6_2 = minus_N6_2 + E7_12 * minus_N7_1 - E7_11 * N7_2;
  const T minus_rho6_3 = minus_N7_3 + minus_N6_3;
  // f_theta6 = b6 . rho6 + effort_link_6_6: Kane's equation of the angle [N m]
  const T f_theta6 = effort_link_6_6 - minus_rho6_2;
  f[5] = f_theta6;

  // ---- body 5 (link_5) and what it carries
  // S5 = E6^T S6 + G5: sum of the force balances of the subtree, body axes [N]
  const T b5_1 = minus_E6_13 * G6_3 - E6_11 * minus_G6_1;
  const T S5_1 = b5_1 - minus_G5_1;
  const T minus_S5_2 = minus_G6_2 + minus_G5_2;
  const T S5_3 = G5_3 + minus_E6_13 * minus_G6_1 + E6_11 * G6_3;
  // rho5 = q6~ E6^T S6 + E6^T rho6 + N5: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho5_1 = T(0.4) * minus_G6_2 - (minus_N5_1 + E6_11 * minus_rho6_1 + minus_E6_13 * minus_rho6_3);
  const T rho5_2 = T(0.4) * b5_1 - (minus_rho6_2 + minus_N5_2);
  const T minus_rho5_3 = minus_N5_3 + E6_11 * minus_rho6_3 - minus_E6_13 * minus_rho6_1;
  // f_theta5 = b5 . rho5 + effort_link_5_5: Kane's equation of the angle [N m]
  const T f_theta5 = effort_link_5_5 - minus_rho5_3;
  f[4] = f_theta5;

  // ---- body 4 (link_4) and what it carries
  // S4 = E5^T S5 + G4: sum of the force balances of the subtree, body axes [N]
  const T S4_1 = E5_11 * S5_1 + E5_12 * minus_S5_2 - minus_G4_1;
  const T S4_2 = E5_12 * S5_1 - E5_11 * minus_S5_2 - minus_G4_2;
  const T S4_3 = S5_3 + G4_3;
  // rho4 = E5^T rho5 + N4: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho4_1 = N4_1 + E5_11 * rho5_1 - E5_12 * rho5_2;
  const T rho4_2 = E5_12 * rho5_1 - minus_N4_2 + E5_11 * rho5_2;
  const T minus_rho4_3 = minus_rho5_3 + minus_N4_3;
  // f_theta4 = b4 . rho4 + effort_link_4_4: Kane's equation of the angle [N m]
  const T f_theta4 = effort_link_4_4 - rho4_2;
  f[3] = f_theta4;

  // ---- body 3 (link_3) and what it carries
  // rho3 = q4~ E4^T S4 + E4^T rho4 + N3: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho3_1 = E4_11 * rho4_1 - minus_N3_1 + E4_13 * minus_rho4_3 - T(0.42) * S4_2;
  const T rho3_2 = rho4_2 + N3_2 + T(0.42) * (E4_11 * S4_1 - E4_13 * S4_3);
  const T rho3_3 = E4_13 * rho4_1 - minus_N3_3 - E4_11 * minus_rho4_3;
  // f_theta3 = b3 . rho3 + effort_link_3_3: Kane's equation of the angle [N m]
  const T f_theta3 = rho3_3 + effort_link_3_3;
  f[2] = f_theta3;

  // ---- body 2 (link_2) and what it carries
  // rho2 = E3^T rho3 + N2: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho2_1 = E3_11 * rho3_1 - minus_N2_1 - E3_12 * rho3_2;
  const T rho2_2 = E3_12 * rho3_1 - minus_N2_2 + E3_11 * rho3_2;
  const T rho2_3 = rho3_3 - minus_N2_3;
  // f_theta2 = b2 . rho2 + effort_link_2_2: Kane's equation of the angle [N m]
  const T f_theta2 = rho2_2 + effort_link_2_2;
  f[1] = f_theta2;

  // ---- body 1 (link_1) and what it carries
  // rho1 = q2~ E2^T S2 + E2^T rho2 + N1: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho1_3 = E2_11 * rho2_3 - minus_E2_13 * rho2_1;
  // f_theta1 = b1 . rho1 + effort_link_1_1: Kane's equation of the angle [N m]
  const T f_theta1 = rho1_3 + effort_link_1_1;
  f[0] = f_theta1;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 84 add, 110 multiply, 10 sine or cosine
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  T cosines[6], sines[6];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 1, 5, cosines + 1, sines + 1);

  // ---- body 2 (link_2) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];

  // ---- body 3 (link_3) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T E3_12 = sines[2];

  // ---- body 4 (link_4) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_13 = sines[3];

  // ---- body 5 (link_5) on body 4
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];

  // ---- body 6 (link_6) on body 5
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T minus_E6_13 = sines[5];

  // ---- body 6 (link_6) and what it carries
  // hc6 = E6^T h6: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc6_1 = minus_E6_13 * T(0.12228);
  const T hc6_3 = E6_11 * T(0.12228);

  // ---- body 5 (link_5) and what it carries
  // h5 = h_own_5 + hc6: first moment of mass carried, about the body origin, body axes [kg m]
  const T h5_1 = hc6_1 - T(0.00035);
  // J5 = -q6~ hc6~ + E6^T J6 E6 + J_own_5 - hc6~ q6~: inertia carried, about the body origin, body axes [kg m^2]
  const T b5_1 = minus_E6_13 * T(0.012441848);
  const T b5_2 = minus_E6_13 * b5_1;
  const T J5_11 = T(0.013441848) - b5_2 + T(0.8) * hc6_3;
  const T b5_3 = minus_E6_13 * T(4.32e-07);
  const T minus_J5_12 = b5_3 + T(7.350000000000001e-06);
  const T J5_13 = T(9.117500000000001e-05) - E6_11 * b5_1 - T(0.4) * hc6_1;
  const T b5_4 = T(0.4) * hc6_3;
  const T b5_5 = b5_4 + T(0.016841848);
  const T J5_22 = b5_5 - T(0.007543753000000001) + b5_4;
  const T b5_6 = E6_11 * T(4.32e-07);
  const T J5_23 = T(0.01885875) - b5_6;
  const T J5_33 = T(0.011733823) + b5_2;
  A[32] = J5_33;
  // hc5 = E5^T h5: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc5_1 = E5_12 * T(0.07278000000000001) + E5_11 * h5_1;
  const T minus_hc5_2 = E5_11 * T(0.07278000000000001) - E5_12 * h5_1;
  // K_thetadot7_5 = q6~ E6^T B_thetadot7_6 + E6^T K_thetadot7_6
  const T K_thetadot7_5_1 = minus_E6_13 * T(0.001);
  const T K_thetadot7_5_3 = E6_11 * T(0.001);
  A[34] = K_thetadot7_5_3;
  A[46] = K_thetadot7_5_3;
  A[33] = -b5_6;
  A[39] = -b5_6;

  // ---- body 4 (link_4) and what it carries
  // h4 = h_own_4 + hc5: first moment of mass carried, about the body origin, body axes [kg m]
  const T h4_3 = T(2.34625) + hc6_3;
  // J4 = E5^T J5 E5 + J_own_4: inertia carried, about the body origin, body axes [kg m^2]
  const T b4_1 = E5_12 * (J5_11 - J5_22) - T(2) * E5_11 * minus_J5_12;
  const T b4_2 = E5_12 * b4_1;
  const T J4_11 = J5_11 - b4_2 + T(0.750066163);
  const T J4_12 = minus_J5_12 + E5_11 * b4_1;
  const T J4_13 = E5_11 * J5_13 - E5_12 * J5_23;
  const T J4_22 = J5_22 + b4_2 + T(0.755466163);
  const T b4_3 = E5_12 * J5_13 + E5_11 * J5_23;
  const T J4_23 = b4_3 + T(0.007973000000000001);
  A[24] = J4_22;
  // hc4 = E4^T h4: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4_1 = E4_11 * hc5_1 - E4_13 * h4_3;
  const T hc4_3 = E4_11 * h4_3 + E4_13 * hc5_1;
  // K_thetadot7_4 = E5^T K_thetadot7_5
  const T K_thetadot7_4_1 = E5_11 * K_thetadot7_5_1;
  const T K_thetadot7_4_2 = E5_12 * K_thetadot7_5_1;
  A[27] = -K_thetadot7_4_2;
  A[45] = -K_thetadot7_4_2;
  // B_thetadot6_4 = E5^T B_thetadot6_5
  const T B_thetadot6_4_1 = E5_11 * hc6_3;
  const T B_thetadot6_4_2 = E5_12 * hc6_3;
  // K_thetadot6_4 = E5^T K_thetadot6_5
  const T minus_K_thetadot6_4_1 = E5_11 * b5_3 + E5_12 * b5_5;
  const T K_thetadot6_4_2 = E5_11 * b5_5 - E5_12 * b5_3;
  A[26] = -K_thetadot6_4_2;
  A[38] = -K_thetadot6_4_2;
  A[25] = -b4_3;
  A[31] = -b4_3;

  // ---- body 3 (link_3) and what it carries
  // J3 = -q4~ hc4~ + E4^T J4 E4 + J_own_3 - hc4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b3_1 = T(2) * E4_11 * J4_13 - E4_13 * (J5_33 - J4_11);
  const T b3_2 = E4_13 * b3_1;
  const T J3_11 = J4_11 - b3_2 + T(0.84) * hc4_3;
  const T minus_J3_12 = E4_13 * J4_23 - E4_11 * J4_12;
  const T J3_13 = E4_11 * b3_1 - J4_13 - T(0.42) * hc4_1;
  const T b3_3 = T(0.42) * hc4_3;
  const T b3_4 = b3_3 + J4_22;
  const T J3_22 = b3_4 - T(0.024796000000000002) + b3_3;
  const T b3_5 = E4_13 * J4_12 + E4_11 * J4_23;
  const T J3_23 = b3_5 + T(0.014857500000000004) + T(0.42) * minus_hc5_2;
  const T J3_33 = J5_33 + b3_2 + T(0.031196);
  A[16] = J3_33;
  // K_thetadot7_3 = q4~ E4^T B_thetadot7_4 + E4^T K_thetadot7_4
  const T K_thetadot7_3_1 = E4_11 * K_thetadot7_4_1 - E4_13 * K_thetadot7_5_3;
  const T K_thetadot7_3_3 = E4_13 * K_thetadot7_4_1 + E4_11 * K_thetadot7_5_3;
  A[20] = K_thetadot7_3_3;
  A[44] = K_thetadot7_3_3;
  // B_thetadot6_3 = E4^T B_thetadot6_4
  const T B_thetadot6_3_1 = E4_11 * B_thetadot6_4_1 + E4_13 * hc6_1;
  // K_thetadot6_3 = q4~ E4^T B_thetadot6_4 + E4^T K_thetadot6_4
  const T K_thetadot6_3_1 = E4_13 * b5_6 - E4_11 * minus_K_thetadot6_4_1 - T(0.42) * B_thetadot6_4_2;
  const T K_thetadot6_3_2 = K_thetadot6_4_2 + T(0.42) * B_thetadot6_3_1;
  const T minus_K_thetadot6_3_3 = E4_13 * minus_K_thetadot6_4_1 + E4_11 * b5_6;
  A[19] = -minus_K_thetadot6_3_3;
  A[37] = -minus_K_thetadot6_3_3;
  // B_thetadot5_3 = E4^T B_thetadot5_4
  const T B_thetadot5_3_1 = E4_11 * minus_hc5_2;
  // K_thetadot5_3 = q4~ E4^T B_thetadot5_4 + E4^T K_thetadot5_4
  const T K_thetadot5_3_1 = E4_11 * J4_13 - E4_13 * J5_33 - T(0.42) * hc5_1;
  const T K_thetadot5_3_2 = b4_3 + T(0.42) * B_thetadot5_3_1;
  const T K_thetadot5_3_3 = E4_13 * J4_13 + E4_11 * J5_33;
  A[18] = K_thetadot5_3_3;
  A[30] = K_thetadot5_3_3;
  A[17] = -b3_5;
  A[23] = -b3_5;

  // ---- body 2 (link_2) and what it carries
  // J2 = E3^T J3 E3 + J_own_2: inertia carried, about the body origin, body axes [kg m^2]
  const T b2_1 = E3_12 * (J3_11 - J3_22) - T(2) * E3_11 * minus_J3_12;
  const T b2_2 = E3_12 * b2_1;
  const T J2_11 = J3_11 - b2_2 + T(2.2264156534999997);
  const T J2_12 = minus_J3_12 + T(8.000999999999999e-05) + E3_11 * b2_1;
  const T b2_3 = E3_11 * J3_13 - E3_12 * J3_23;
  const T J2_13 = b2_3 + T(0.00011239499999999998);
  const T J2_22 = J3_22 + b2_2 + T(2.2373167965);
  const T b2_4 = E3_12 * J3_13 + E3_11 * J3_23;
  const T J2_23 = b2_4 - T(0.0157353);
  A[8] = J2_22;
  // K_thetadot7_2 = E3^T K_thetadot7_3
  const T K_thetadot7_2_1 = E3_11 * K_thetadot7_3_1 - E3_12 * K_thetadot7_4_2;
  const T K_thetadot7_2_2 = E3_12 * K_thetadot7_3_1 + E3_11 * K_thetadot7_4_2;
  A[13] = K_thetadot7_2_2;
  A[43] = K_thetadot7_2_2;
  // K_thetadot6_2 = E3^T K_thetadot6_3
  const T K_thetadot6_2_1 = E3_11 * K_thetadot6_3_1 - E3_12 * K_thetadot6_3_2;
  const T K_thetadot6_2_2 = E3_12 * K_thetadot6_3_1 + E3_11 * K_thetadot6_3_2;
  A[12] = K_thetadot6_2_2;
  A[36] = K_thetadot6_2_2;
  // K_thetadot5_2 = E3^T K_thetadot5_3
  const T K_thetadot5_2_1 = E3_11 * K_thetadot5_3_1 - E3_12 * K_thetadot5_3_2;
  const T K_thetadot5_2_2 = E3_12 * K_thetadot5_3_1 + E3_11 * K_thetadot5_3_2;
  A[11] = K_thetadot5_2_2;
  A[29] = K_thetadot5_2_2;
  // K_thetadot4_2 = E3^T K_thetadot4_3
  const T K_thetadot4_2_1 = E3_11 * minus_J3_12 + E3_12 * b3_4;
  const T K_thetadot4_2_2 = E3_12 * minus_J3_12 - E3_11 * b3_4;
  A[10] = K_thetadot4_2_2;
  A[22] = K_thetadot4_2_2;
  A[9] = b2_4;
  A[15] = b2_4;

  // ---- body 1 (link_1) and what it carries
  // J1 = -q2~ hc2~ + E2^T J2 E2 + J_own_1 - hc2~ q2~: inertia carried, about the body origin, body axes [kg m^2]
  const T J1_33 = J3_33 + T(0.0590859715) - minus_E2_13 * (minus_E2_13 * (J3_33 - J2_11) + T(2) * E2_11 * J2_13);
  A[0] = J1_33;
  // K_thetadot7_1 = q2~ E2^T B_thetadot7_2 + E2^T K_thetadot7_2
  const T K_thetadot7_1_3 = E2_11 * K_thetadot7_3_3 - minus_E2_13 * K_thetadot7_2_1;
  A[6] = K_thetadot7_1_3;
  A[42] = K_thetadot7_1_3;
  // K_thetadot6_1 = q2~ E2^T B_thetadot6_2 + E2^T K_thetadot6_2
  const T minus_K_thetadot6_1_3 = minus_E2_13 * K_thetadot6_2_1 + E2_11 * minus_K_thetadot6_3_3;
  A[5] = -minus_K_thetadot6_1_3;
  A[35] = -minus_K_thetadot6_1_3;
  // K_thetadot5_1 = q2~ E2^T B_thetadot5_2 + E2^T K_thetadot5_2
  const T K_thetadot5_1_3 = E2_11 * K_thetadot5_3_3 - minus_E2_13 * K_thetadot5_2_1;
  A[4] = K_thetadot5_1_3;
  A[28] = K_thetadot5_1_3;
  // K_thetadot4_1 = q2~ E2^T B_thetadot4_2 + E2^T K_thetadot4_2
  const T minus_K_thetadot4_1_3 = minus_E2_13 * K_thetadot4_2_1 + E2_11 * b3_5;
  A[3] = -minus_K_thetadot4_1_3;
  A[21] = -minus_K_thetadot4_1_3;
  // K_thetadot3_1 = q2~ E2^T B_thetadot3_2 + E2^T K_thetadot3_2
  const T K_thetadot3_1_3 = E2_11 * J3_33 - minus_E2_13 * b2_3;
  A[2] = K_thetadot3_1_3;
  A[14] = K_thetadot3_1_3;
  // K_thetadot2_1 = q2~ E2^T B_thetadot2_2 + E2^T K_thetadot2_2
  const T K_thetadot2_1_3 = E2_11 * J2_23 - minus_E2_13 * J2_12;
  A[1] = K_thetadot2_1_3;
  A[7] = K_thetadot2_1_3;

  // ---- results
  A[40] = T(0.016841848);
  A[41] = T(0);
  A[47] = T(0);
  A[48] = T(0.001);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 293 add, 468 multiply, 14 sine or cosine
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  for (int i = 0; i < 147; ++i) v_y[i] = T(0);
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

  // ---- body 1 (link_1) on the inertial frame
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];
  // B1_1 = -E1^T r1~ b1
  const T B1_1_1 = E1_11 * T(0.03);
  const T B1_1_2 = E1_12 * T(0.03);
  v_y[0] = B1_1_1;
  v_y[7] = B1_1_2;

  // ---- body 2 (link_2) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11;
  const T R2_12 = E1_12 * E2_11;
  const T R2_31 = E1_11 * minus_E2_13;
  const T R2_32 = E1_12 * minus_E2_13;
  // B2_1 = -R2^T (C2^T r2)~ omega_thetadot1_2 + P_thetadot1_2
  const T t2_1 = T(0.042) * E2_11;
  const T t2_2 = T(3e-04) * E2_11 - T(0.059) * minus_E2_13;
  const T t2_3 = T(0.042) * minus_E2_13;
  const T minus_B2_1_1 = R2_11 * t2_1 - E1_12 * t2_2 + R2_31 * t2_3;
  const T minus_B2_1_2 = R2_12 * t2_1 + E1_11 * t2_2 + R2_32 * t2_3;
  const T minus_B2_1_3 = E2_11 * t2_3 - minus_E2_13 * t2_1;
  v_y[21] = -minus_B2_1_1;
  v_y[28] = -minus_B2_1_2;
  v_y[35] = -minus_B2_1_3;
  // B3_2 = -R2^T (C2^T r2)~ b2
  const T B3_2_1 = R2_11 * T(0.059) + R2_31 * T(3e-04);
  const T B3_2_2 = R2_12 * T(0.059) + R2_32 * T(3e-04);
  v_y[22] = B3_2_1;
  v_y[29] = B3_2_2;
  v_y[36] = t2_2;

  // ---- body 3 (link_3) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T E3_12 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - E1_12 * E3_12;
  const T R3_12 = R2_12 * E3_11 + E1_11 * E3_12;
  const T minus_R3_13 = minus_E2_13 * E3_11;
  const T minus_R3_21 = E1_12 * E3_11 + R2_11 * E3_12;
  const T R3_22 = E1_11 * E3_11 - R2_12 * E3_12;
  const T R3_23 = minus_E2_13 * E3_12;
  // P_thetadot1_3 = -R2^T q3~ omega_thetadot1_2 + P_thetadot1_2: partial velocity of the body origin, inertial axes
  const T t3_1 = T(0.2045) * minus_E2_13;
  const T minus_P_thetadot1_3_1 = E1_12 * t3_1;
  const T P_thetadot1_3_2 = E1_11 * t3_1;
  // P_thetadot2_3 = -R2^T q3~ b2: partial velocity of the body origin, inertial axes
  const T P_thetadot2_3_1 = R2_11 * T(0.2045);
  const T P_thetadot2_3_2 = R2_12 * T(0.2045);
  // B4_1 = -R3^T r3~ omega_thetadot1_3 + P_thetadot1_3
  const T t3_2 = T(0.03) * E2_11 - T(0.13) * R3_23;
  const T t3_3 = T(0.13) * minus_R3_13;
  const T t3_4 = T(0.03) * minus_R3_13;
  const T minus_B4_1_1 = minus_P_thetadot1_3_1 + R3_11 * t3_2 + minus_R3_21 * t3_3 + R2_31 * t3_4;
  const T minus_B4_1_2 = R3_12 * t3_2 - P_thetadot1_3_2 - R3_22 * t3_3 + R2_32 * t3_4;
  const T minus_B4_1_3 = E2_11 * t3_4 - (minus_R3_13 * t3_2 + R3_23 * t3_3);
  v_y[42] = -minus_B4_1_1;
  v_y[49] = -minus_B4_1_2;
  v_y[56] = -minus_B4_1_3;
  // B5_2 = -R3^T r3~ omega_thetadot2_3 + P_thetadot2_3
  const T t3_5 = T(0.13) * E3_11;
  const T t3_6 = T(0.13) * E3_12;
  const T t3_7 = T(0.03) * E3_12;
  const T B5_2_1 = P_thetadot2_3_1 + R3_11 * t3_5 + minus_R3_21 * t3_6 + R2_31 * t3_7;
  const T minus_B5_2_2 = R3_22 * t3_6 - P_thetadot2_3_2 - R3_12 * t3_5 - R2_32 * t3_7;
  const T minus_B5_2_3 = t3_1 + minus_R3_13 * t3_5 + R3_23 * t3_6 - E2_11 * t3_7;
  v_y[43] = B5_2_1;
  v_y[50] = -minus_B5_2_2;
  v_y[57] = -minus_B5_2_3;
  // B6_3 = -R3^T r3~ b3
  const T minus_B6_3_1 = R3_11 * T(0.03);
  const T minus_B6_3_2 = R3_12 * T(0.03);
  v_y[44] = -minus_B6_3_1;
  v_y[51] = -minus_B6_3_2;
  v_y[58] = t3_4;

  // ---- body 4 (link_4) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_13 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 + R2_31 * E4_13;
  const T R4_12 = R3_12 * E4_11 + R2_32 * E4_13;
  const T R4_13 = E2_11 * E4_13 - minus_R3_13 * E4_11;
  const T R4_31 = R2_31 * E4_11 - R3_11 * E4_13;
  const T R4_32 = R2_32 * E4_11 - R3_12 * E4_13;
  const T R4_33 = minus_R3_13 * E4_13 + E2_11 * E4_11;
  // omega_thetadot2_4 = E4 omega_thetadot2_3: partial angular velocity, body axes
  const T omega_thetadot2_4_1 = E4_11 * E3_12;
  const T minus_omega_thetadot2_4_3 = E4_13 * E3_12;
  // P_thetadot1_4 = -R3^T q4~ omega_thetadot1_3 + P_thetadot1_3: partial velocity of the body origin, inertial axes
  const T t4_1 = T(0.2155) * minus_R3_13;
  const T t4_2 = T(0.2155) * R3_23;
  const T minus_P_thetadot1_4_1 = minus_P_thetadot1_3_1 + minus_R3_21 * t4_1 - R3_11 * t4_2;
  const T P_thetadot1_4_2 = P_thetadot1_3_2 + R3_12 * t4_2 + R3_22 * t4_1;
  const T minus_P_thetadot1_4_3 = minus_R3_13 * t4_2 - R3_23 * t4_1;
  // P_thetadot2_4 = -R3^T q4~ omega_thetadot2_3 + P_thetadot2_3: partial velocity of the body origin, inertial axes
  const T t4_3 = T(0.2155) * E3_11;
  const T t4_4 = T(0.2155) * E3_12;
  const T P_thetadot2_4_1 = P_thetadot2_3_1 + R3_11 * t4_3 + minus_R3_21 * t4_4;
  const T minus_P_thetadot2_4_2 = R3_22 * t4_4 - P_thetadot2_3_2 - R3_12 * t4_3;
  const T minus_P_thetadot2_4_3 = t3_1 + minus_R3_13 * t4_3 + R3_23 * t4_4;
  // B7_1 = -R4^T (C4^T r4)~ omega_thetadot1_4 + P_thetadot1_4
  const T t4_5 = T(0.067) * R3_23 + T(0.034) * R4_33;
  const T t4_6 = T(0.067) * R4_13;
  const T t4_7 = T(0.034) * R4_13;
  const T minus_B7_1_1 = minus_P_thetadot1_4_1 - R4_11 * t4_5 - minus_R3_21 * t4_6 + R4_31 * t4_7;
  const T minus_B7_1_2 = R3_22 * t4_6 - P_thetadot1_4_2 - R4_12 * t4_5 + R4_32 * t4_7;
  const T minus_B7_1_3 = minus_P_thetadot1_4_3 + R3_23 * t4_6 - R4_13 * t4_5 + R4_33 * t4_7;
  v_y[63] = -minus_B7_1_1;
  v_y[70] = -minus_B7_1_2;
  v_y[77] = -minus_B7_1_3;
  // B8_2 = -R4^T (C4^T r4)~ omega_thetadot2_4 + P_thetadot2_4
  const T t4_8 = T(0.034) * minus_omega_thetadot2_4_3 - T(0.067) * E3_11;
  const T t4_9 = T(0.067) * omega_thetadot2_4_1;
  const T t4_10 = T(0.034) * omega_thetadot2_4_1;
  const T minus_B8_2_1 = R4_11 * t4_8 - P_thetadot2_4_1 - minus_R3_21 * t4_9 + R4_31 * t4_10;
  const T minus_B8_2_2 = minus_P_thetadot2_4_2 + R4_12 * t4_8 + R3_22 * t4_9 + R4_32 * t4_10;
  const T minus_B8_2_3 = minus_P_thetadot2_4_3 + R4_13 * t4_8 + R3_23 * t4_9 + R4_33 * t4_10;
  v_y[64] = -minus_B8_2_1;
  v_y[71] = -minus_B8_2_2;
  v_y[78] = -minus_B8_2_3;
  // B9_3 = -R4^T (C4^T r4)~ omega_thetadot3_4 + P_thetadot3_4
  const T t4_11 = T(0.034) * E4_13;
  const T t4_12 = T(0.034) * E4_11;
  const T t4_13 = T(0.067) * E4_13;
  const T minus_B9_3_1 = R4_31 * t4_11 - (R4_11 * t4_12 + minus_R3_21 * t4_13);
  const T minus_B9_3_2 = R3_22 * t4_13 - R4_12 * t4_12 + R4_32 * t4_11;
  const T minus_B9_3_3 = R3_23 * t4_13 - R4_13 * t4_12 + R4_33 * t4_11;
  v_y[65] = -minus_B9_3_1;
  v_y[72] = -minus_B9_3_2;
  v_y[79] = -minus_B9_3_3;
  // B10_4 = -R4^T (C4^T r4)~ b4
  const T minus_B10_4_1 = R4_11 * T(0.067);
  const T minus_B10_4_2 = R4_12 * T(0.067);
  v_y[66] = -minus_B10_4_1;
  v_y[73] = -minus_B10_4_2;
  v_y[80] = -t4_6;

  // ---- body 5 (link_5) on body 4
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - minus_R3_21 * E5_12;
  const T R5_12 = R4_12 * E5_11 + R3_22 * E5_12;
  const T R5_13 = R4_13 * E5_11 + R3_23 * E5_12;
  const T minus_R5_21 = minus_R3_21 * E5_11 + R4_11 * E5_12;
  const T R5_22 = R3_22 * E5_11 - R4_12 * E5_12;
  const T R5_23 = R3_23 * E5_11 - R4_13 * E5_12;
  // omega_thetadot2_5 = E5 omega_thetadot2_4: partial angular velocity, body axes
  const T omega_thetadot2_5_1 = E5_11 * omega_thetadot2_4_1 + E5_12 * E3_11;
  const T omega_thetadot2_5_2 = E5_11 * E3_11 - E5_12 * omega_thetadot2_4_1;
  // omega_thetadot3_5 = E5 omega_thetadot3_4: partial angular velocity, body axes
  const T omega_thetadot3_5_1 = E5_11 * E4_13;
  const T minus_omega_thetadot3_5_2 = E5_12 * E4_13;
  // P_thetadot1_5 = -R4^T q5~ omega_thetadot1_4 + P_thetadot1_4: partial velocity of the body origin, inertial axes
  const T t5_1 = T(0.1845) * R3_23;
  const T t5_2 = T(0.1845) * R4_13;
  const T minus_P_thetadot1_5_1 = minus_P_thetadot1_4_1 - R4_11 * t5_1 - minus_R3_21 * t5_2;
  const T minus_P_thetadot1_5_2 = R3_22 * t5_2 - P_thetadot1_4_2 - R4_12 * t5_1;
  const T minus_P_thetadot1_5_3 = minus_P_thetadot1_4_3 + R3_23 * t5_2 - R4_13 * t5_1;
  // P_thetadot2_5 = -R4^T q5~ omega_thetadot2_4 + P_thetadot2_4: partial velocity of the body origin, inertial axes
  const T t5_3 = T(0.1845) * E3_11;
  const T t5_4 = T(0.1845) * omega_thetadot2_4_1;
  const T P_thetadot2_5_1 = P_thetadot2_4_1 + R4_11 * t5_3 + minus_R3_21 * t5_4;
  const T minus_P_thetadot2_5_2 = minus_P_thetadot2_4_2 + R3_22 * t5_4 - R4_12 * t5_3;
  const T minus_P_thetadot2_5_3 = minus_P_thetadot2_4_3 + R3_23 * t5_4 - R4_13 * t5_3;
  // P_thetadot3_5 = -R4^T q5~ omega_thetadot3_4 + P_thetadot3_4: partial velocity of the body origin, inertial axes
  const T t5_5 = T(0.1845) * E4_13;
  const T P_thetadot3_5_1 = minus_R3_21 * t5_5;
  const T minus_P_thetadot3_5_2 = R3_22 * t5_5;
  const T minus_P_thetadot3_5_3 = R3_23 * t5_5;
  // P_thetadot4_5 = -R4^T q5~ b4: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot4_5_1 = R4_11 * T(0.1845);
  const T minus_P_thetadot4_5_2 = R4_12 * T(0.1845);
  // B11_1 = -R5^T (C5^T r5)~ omega_thetadot1_5 + P_thetadot1_5
  const T t5_6 = T(0.076) * R5_23 + T(0.021) * R4_33;
  const T t5_7 = T(0.076) * R5_13 + T(1e-04) * R4_33;
  const T t5_8 = T(0.021) * R5_13 - T(1e-04) * R5_23;
  const T minus_B11_1_1 = minus_P_thetadot1_5_1 - R5_11 * t5_6 - minus_R5_21 * t5_7 + R4_31 * t5_8;
  const T minus_B11_1_2 = minus_P_thetadot1_5_2 + R5_22 * t5_7 - R5_12 * t5_6 + R4_32 * t5_8;
  const T minus_B11_1_3 = minus_P_thetadot1_5_3 + R5_23 * t5_7 - R5_13 * t5_6 + R4_33 * t5_8;
  v_y[84] = -minus_B11_1_1;
  v_y[91] = -minus_B11_1_2;
  v_y[98] = -minus_B11_1_3;
  // B12_2 = -R5^T (C5^T r5)~ omega_thetadot2_5 + P_thetadot2_5
  const T t5_9 = T(0.021) * minus_omega_thetadot2_4_3 - T(0.076) * omega_thetadot2_5_2;
  const T t5_10 = T(0.076) * omega_thetadot2_5_1 - T(1e-04) * minus_omega_thetadot2_4_3;
  const T t5_11 = T(0.021) * omega_thetadot2_5_1 - T(1e-04) * omega_thetadot2_5_2;
  const T minus_B12_2_1 = R5_11 * t5_9 - P_thetadot2_5_1 - minus_R5_21 * t5_10 + R4_31 * t5_11;
  const T minus_B12_2_2 = minus_P_thetadot2_5_2 + R5_12 * t5_9 + R5_22 * t5_10 + R4_32 * t5_11;
  const T minus_B12_2_3 = minus_P_thetadot2_5_3 + R5_13 * t5_9 + R5_23 * t5_10 + R4_33 * t5_11;
  v_y[85] = -minus_B12_2_1;
  v_y[92] = -minus_B12_2_2;
  v_y[99] = -minus_B12_2_3;
  // B13_3 = -R5^T (C5^T r5)~ omega_thetadot3_5 + P_thetadot3_5
  const T t5_12 = T(0.076) * minus_omega_thetadot3_5_2 - T(0.021) * E4_11;
  const T t5_13 = T(0.076) * omega_thetadot3_5_1 + T(1e-04) * E4_11;
  const T t5_14 = T(1e-04) * minus_omega_thetadot3_5_2 + T(0.021) * omega_thetadot3_5_1;
  const T minus_B13_3_1 = R5_11 * t5_12 - P_thetadot3_5_1 - minus_R5_21 * t5_13 + R4_31 * t5_14;
  const T minus_B13_3_2 = minus_P_thetadot3_5_2 + R5_12 * t5_12 + R5_22 * t5_13 + R4_32 * t5_14;
  const T minus_B13_3_3 = minus_P_thetadot3_5_3 + R5_13 * t5_12 + R5_23 * t5_13 + R4_33 * t5_14;
  v_y[86] = -minus_B13_3_1;
  v_y[93] = -minus_B13_3_2;
  v_y[100] = -minus_B13_3_3;
  // B14_4 = -R5^T (C5^T r5)~ omega_thetadot4_5 + P_thetadot4_5
  const T t5_15 = T(0.076) * E5_11;
  const T t5_16 = T(0.076) * E5_12;
  const T t5_17 = T(1e-04) * E5_11 - T(0.021) * E5_12;
  const T minus_B14_4_1 = minus_P_thetadot4_5_1 + R5_11 * t5_15 + minus_R5_21 * t5_16 + R4_31 * t5_17;
  const T minus_B14_4_2 = minus_P_thetadot4_5_2 + R5_12 * t5_15 - R5_22 * t5_16 + R4_32 * t5_17;
  const T minus_B14_4_3 = t5_2 + R5_13 * t5_15 - R5_23 * t5_16 + R4_33 * t5_17;
  v_y[87] = -minus_B14_4_1;
  v_y[94] = -minus_B14_4_2;
  v_y[101] = -minus_B14_4_3;
  // B15_5 = -R5^T (C5^T r5)~ b5
  const T B15_5_1 = R5_11 * T(0.021) + minus_R5_21 * T(1e-04);
  const T minus_B15_5_2 = R5_22 * T(1e-04) - R5_12 * T(0.021);
  v_y[88] = B15_5_1;
  v_y[95] = -minus_B15_5_2;
  v_y[102] = t5_8;

  // ---- body 6 (link_6) on body 5
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T minus_E6_13 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - R4_31 * minus_E6_13;
  const T R6_12 = R5_12 * E6_11 - R4_32 * minus_E6_13;
  const T R6_13 = R5_13 * E6_11 - R4_33 * minus_E6_13;
  const T R6_31 = R5_11 * minus_E6_13 + R4_31 * E6_11;
  const T R6_32 = R5_12 * minus_E6_13 + R4_32 * E6_11;
  const T R6_33 = R5_13 * minus_E6_13 + R4_33 * E6_11;
  // omega_thetadot2_6 = E6 omega_thetadot2_5: partial angular velocity, body axes
  const T omega_thetadot2_6_1 = E6_11 * omega_thetadot2_5_1 + minus_E6_13 * minus_omega_thetadot2_4_3;
  const T omega_thetadot2_6_3 = minus_E6_13 * omega_thetadot2_5_1 - E6_11 * minus_omega_thetadot2_4_3;
  // omega_thetadot3_6 = E6 omega_thetadot3_5: partial angular velocity, body axes
  const T omega_thetadot3_6_1 = E6_11 * omega_thetadot3_5_1 - minus_E6_13 * E4_11;
  const T omega_thetadot3_6_3 = minus_E6_13 * omega_thetadot3_5_1 + E6_11 * E4_11;
  // omega_thetadot4_6 = E6 omega_thetadot4_5: partial angular velocity, body axes
  const T minus_omega_thetadot4_6_1 = E6_11 * E5_12;
  const T minus_omega_thetadot4_6_3 = minus_E6_13 * E5_12;
  // P_thetadot1_6 = -R5^T q6~ omega_thetadot1_5 + P_thetadot1_5: partial velocity of the body origin, inertial axes
  const T t6_1 = T(0.2155) * R5_23;
  const T t6_2 = T(0.2155) * R5_13;
  const T minus_P_thetadot1_6_1 = minus_P_thetadot1_5_1 - R5_11 * t6_1 - minus_R5_21 * t6_2;
  const T minus_P_thetadot1_6_2 = minus_P_thetadot1_5_2 + R5_22 * t6_2 - R5_12 * t6_1;
  const T minus_P_thetadot1_6_3 = minus_P_thetadot1_5_3 + R5_23 * t6_2 - R5_13 * t6_1;
  // P_thetadot2_6 = -R5^T q6~ omega_thetadot2_5 + P_thetadot2_5: partial velocity of the body origin, inertial axes
  const T t6_3 = T(0.2155) * omega_thetadot2_5_2;
  const T t6_4 = T(0.2155) * omega_thetadot2_5_1;
  const T P_thetadot2_6_1 = P_thetadot2_5_1 + R5_11 * t6_3 + minus_R5_21 * t6_4;
  const T minus_P_thetadot2_6_2 = minus_P_thetadot2_5_2 + R5_22 * t6_4 - R5_12 * t6_3;
  const T minus_P_thetadot2_6_3 = minus_P_thetadot2_5_3 + R5_23 * t6_4 - R5_13 * t6_3;
  // P_thetadot3_6 = -R5^T q6~ omega_thetadot3_5 + P_thetadot3_5: partial velocity of the body origin, inertial axes
  const T t6_5 = T(0.2155) * minus_omega_thetadot3_5_2;
  const T t6_6 = T(0.2155) * omega_thetadot3_5_1;
  const T minus_P_thetadot3_6_1 = R5_11 * t6_5 - P_thetadot3_5_1 - minus_R5_21 * t6_6;
  const T minus_P_thetadot3_6_2 = minus_P_thetadot3_5_2 + R5_12 * t6_5 + R5_22 * t6_6;
  const T minus_P_thetadot3_6_3 = minus_P_thetadot3_5_3 + R5_13 * t6_5 + R5_23 * t6_6;
  // P_thetadot4_6 = -R5^T q6~ omega_thetadot4_5 + P_thetadot4_5: partial velocity of the body origin, inertial axes
  const T t6_7 = T(0.2155) * E5_11;
  const T t6_8 = T(0.2155) * E5_12;
  const T minus_P_thetadot4_6_1 = minus_P_thetadot4_5_1 + R5_11 * t6_7 + minus_R5_21 * t6_8;
  const T minus_P_thetadot4_6_2 = minus_P_thetadot4_5_2 + R5_12 * t6_7 - R5_22 * t6_8;
  const T minus_P_thetadot4_6_3 = t5_2 + R5_13 * t6_7 - R5_23 * t6_8;
  // B16_1 = -R6^T (C6^T r6)~ omega_thetadot1_6 + P_thetadot1_6
  const T t6_9 = T(4e-04) * R6_33 - T(6e-04) * R5_23;
  const T t6_10 = T(6e-04) * R6_13;
  const T t6_11 = T(4e-04) * R6_13;
  const T minus_B16_1_1 = minus_P_thetadot1_6_1 + R6_11 * t6_9 - minus_R5_21 * t6_10 - R6_31 * t6_11;
  const T minus_B16_1_2 = minus_P_thetadot1_6_2 + R6_12 * t6_9 + R5_22 * t6_10 - R6_32 * t6_11;
  const T minus_B16_1_3 = minus_P_thetadot1_6_3 + R6_13 * t6_9 + R5_23 * t6_10 - R6_33 * t6_11;
  v_y[105] = -minus_B16_1_1;
  v_y[112] = -minus_B16_1_2;
  v_y[119] = -minus_B16_1_3;
  // B17_2 = -R6^T (C6^T r6)~ omega_thetadot2_6 + P_thetadot2_6
  const T t6_12 = T(4e-04) * omega_thetadot2_6_3 - T(6e-04) * omega_thetadot2_5_2;
  const T t6_13 = T(6e-04) * omega_thetadot2_6_1;
  const T t6_14 = T(4e-04) * omega_thetadot2_6_1;
  const T minus_B17_2_1 = R6_11 * t6_12 - P_thetadot2_6_1 - minus_R5_21 * t6_13 - R6_31 * t6_14;
  const T minus_B17_2_2 = minus_P_thetadot2_6_2 + R6_12 * t6_12 + R5_22 * t6_13 - R6_32 * t6_14;
  const T minus_B17_2_3 = minus_P_thetadot2_6_3 + R6_13 * t6_12 + R5_23 * t6_13 - R6_33 * t6_14;
  v_y[106] = -minus_B17_2_1;
  v_y[113] = -minus_B17_2_2;
  v_y[120] = -minus_B17_2_3;
  // B18_3 = -R6^T (C6^T r6)~ omega_thetadot3_6 + P_thetadot3_6
  const T t6_15 = T(6e-04) * minus_omega_thetadot3_5_2 + T(4e-04) * omega_thetadot3_6_3;
  const T t6_16 = T(6e-04) * omega_thetadot3_6_1;
  const T t6_17 = T(4e-04) * omega_thetadot3_6_1;
  const T minus_B18_3_1 = minus_P_thetadot3_6_1 + R6_11 * t6_15 - minus_R5_21 * t6_16 - R6_31 * t6_17;
  const T minus_B18_3_2 = minus_P_thetadot3_6_2 + R6_12 * t6_15 + R5_22 * t6_16 - R6_32 * t6_17;
  const T minus_B18_3_3 = minus_P_thetadot3_6_3 + R6_13 * t6_15 + R5_23 * t6_16 - R6_33 * t6_17;
  v_y[107] = -minus_B18_3_1;
  v_y[114] = -minus_B18_3_2;
  v_y[121] = -minus_B18_3_3;
  // B19_4 = -R6^T (C6^T r6)~ omega_thetadot4_6 + P_thetadot4_6
  const T t6_18 = T(6e-04) * E5_11 - T(4e-04) * minus_omega_thetadot4_6_3;
  const T t6_19 = T(6e-04) * minus_omega_thetadot4_6_1;
  const T t6_20 = T(4e-04) * minus_omega_thetadot4_6_1;
  const T minus_B19_4_1 = minus_P_thetadot4_6_1 + R6_11 * t6_18 + minus_R5_21 * t6_19 + R6_31 * t6_20;
  const T minus_B19_4_2 = minus_P_thetadot4_6_2 + R6_12 * t6_18 - R5_22 * t6_19 + R6_32 * t6_20;
  const T minus_B19_4_3 = minus_P_thetadot4_6_3 + R6_13 * t6_18 - R5_23 * t6_19 + R6_33 * t6_20;
  v_y[108] = -minus_B19_4_1;
  v_y[115] = -minus_B19_4_2;
  v_y[122] = -minus_B19_4_3;
  // B20_5 = -R6^T (C6^T r6)~ omega_thetadot5_6 + P_thetadot5_6
  const T t6_21 = T(4e-04) * E6_11;
  const T t6_22 = T(6e-04) * minus_E6_13;
  const T t6_23 = T(4e-04) * minus_E6_13;
  const T minus_B20_5_1 = R6_11 * t6_21 + minus_R5_21 * t6_22 + R6_31 * t6_23;
  const T minus_B20_5_2 = R6_12 * t6_21 - R5_22 * t6_22 + R6_32 * t6_23;
  const T minus_B20_5_3 = R6_13 * t6_21 - R5_23 * t6_22 + R6_33 * t6_23;
  v_y[109] = -minus_B20_5_1;
  v_y[116] = -minus_B20_5_2;
  v_y[123] = -minus_B20_5_3;
  // B21_6 = -R6^T (C6^T r6)~ b6
  const T B21_6_1 = R6_11 * T(6e-04);
  const T B21_6_2 = R6_12 * T(6e-04);
  v_y[110] = B21_6_1;
  v_y[117] = B21_6_2;
  v_y[124] = t6_10;

  // ---- body 7 (link_7) on body 6
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T E7_12 = sines[6];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R6_11 * E7_11 - minus_R5_21 * E7_12;
  const T R7_12 = R6_12 * E7_11 + R5_22 * E7_12;
  const T R7_13 = R6_13 * E7_11 + R5_23 * E7_12;
  const T minus_R7_21 = minus_R5_21 * E7_11 + R6_11 * E7_12;
  const T R7_22 = R5_22 * E7_11 - R6_12 * E7_12;
  const T R7_23 = R5_23 * E7_11 - R6_13 * E7_12;
  // omega_thetadot2_7 = E7 omega_thetadot2_6: partial angular velocity, body axes
  const T omega_thetadot2_7_1 = E7_11 * omega_thetadot2_6_1 + E7_12 * omega_thetadot2_5_2;
  const T omega_thetadot2_7_2 = E7_11 * omega_thetadot2_5_2 - E7_12 * omega_thetadot2_6_1;
  // omega_thetadot3_7 = E7 omega_thetadot3_6: partial angular velocity, body axes
  const T omega_thetadot3_7_1 = E7_11 * omega_thetadot3_6_1 - E7_12 * minus_omega_thetadot3_5_2;
  const T minus_omega_thetadot3_7_2 = E7_11 * minus_omega_thetadot3_5_2 + E7_12 * omega_thetadot3_6_1;
  // omega_thetadot4_7 = E7 omega_thetadot4_6: partial angular velocity, body axes
  const T minus_omega_thetadot4_7_1 = E7_11 * minus_omega_thetadot4_6_1 + E7_12 * E5_11;
  const T omega_thetadot4_7_2 = E7_12 * minus_omega_thetadot4_6_1 - E7_11 * E5_11;
  // omega_thetadot5_7 = E7 omega_thetadot5_6: partial angular velocity, body axes
  const T minus_omega_thetadot5_7_1 = E7_11 * minus_E6_13;
  const T omega_thetadot5_7_2 = E7_12 * minus_E6_13;
  // P_thetadot1_7 = -R6^T q7~ omega_thetadot1_6 + P_thetadot1_6: partial velocity of the body origin, inertial axes
  const T t7_1 = T(0.081) * R5_23;
  const T t7_2 = T(0.081) * R6_13;
  const T minus_P_thetadot1_7_1 = minus_P_thetadot1_6_1 - R6_11 * t7_1 - minus_R5_21 * t7_2;
  const T minus_P_thetadot1_7_2 = minus_P_thetadot1_6_2 + R5_22 * t7_2 - R6_12 * t7_1;
  const T minus_P_thetadot1_7_3 = minus_P_thetadot1_6_3 + R5_23 * t7_2 - R6_13 * t7_1;
  // P_thetadot2_7 = -R6^T q7~ omega_thetadot2_6 + P_thetadot2_6: partial velocity of the body origin, inertial axes
  const T t7_3 = T(0.081) * omega_thetadot2_5_2;
  const T t7_4 = T(0.081) * omega_thetadot2_6_1;
  const T P_thetadot2_7_1 = P_thetadot2_6_1 + R6_11 * t7_3 + minus_R5_21 * t7_4;
  const T minus_P_thetadot2_7_2 = minus_P_thetadot2_6_2 + R5_22 * t7_4 - R6_12 * t7_3;
  const T minus_P_thetadot2_7_3 = minus_P_thetadot2_6_3 + R5_23 * t7_4 - R6_13 * t7_3;
  // P_thetadot3_7 = -R6^T q7~ omega_thetadot3_6 + P_thetadot3_6: partial velocity of the body origin, inertial axes
  const T t7_5 = T(0.081) * minus_omega_thetadot3_5_2;
  const T t7_6 = T(0.081) * omega_thetadot3_6_1;
  const T minus_P_thetadot3_7_1 = minus_P_thetadot3_6_1 + R6_11 * t7_5 - minus_R5_21 * t7_6;
  const T minus_P_thetadot3_7_2 = minus_P_thetadot3_6_2 + R6_12 * t7_5 + R5_22 * t7_6;
  const T minus_P_thetadot3_7_3 = minus_P_thetadot3_6_3 + R6_13 * t7_5 + R5_23 * t7_6;
  // P_thetadot4_7 = -R6^T q7~ omega_thetadot4_6 + P_thetadot4_6: partial velocity of the body origin, inertial axes
  const T t7_7 = T(0.081) * E5_11;
  const T t7_8 = T(0.081) * minus_omega_thetadot4_6_1;
  const T minus_P_thetadot4_7_1 = minus_P_thetadot4_6_1 + R6_11 * t7_7 + minus_R5_21 * t7_8;
  const T minus_P_thetadot4_7_2 = minus_P_thetadot4_6_2 + R6_12 * t7_7 - R5_22 * t7_8;
  const T minus_P_thetadot4_7_3 = minus_P_thetadot4_6_3 + R6_13 * t7_7 - R5_23 * t7_8;
  // P_thetadot5_7 = -R6^T q7~ omega_thetadot5_6 + P_thetadot5_6: partial velocity of the body origin, inertial axes
  const T t7_9 = T(0.081) * minus_E6_13;
  const T minus_P_thetadot5_7_1 = minus_R5_21 * t7_9;
  const T P_thetadot5_7_2 = R5_22 * t7_9;
  const T P_thetadot5_7_3 = R5_23 * t7_9;
  // P_thetadot6_7 = -R6^T q7~ b6: partial velocity of the body origin, inertial axes
  const T P_thetadot6_7_1 = R6_11 * T(0.081);
  const T P_thetadot6_7_2 = R6_12 * T(0.081);
  // B22_1 = -R7^T r7~ omega_thetadot1_7 + P_thetadot1_7
  const T t7_10 = T(0.02) * R7_23;
  const T t7_11 = T(0.02) * R7_13;
  const T minus_B22_1_1 = minus_P_thetadot1_7_1 - R7_11 * t7_10 - minus_R7_21 * t7_11;
  const T minus_B22_1_2 = minus_P_thetadot1_7_2 + R7_22 * t7_11 - R7_12 * t7_10;
  const T minus_B22_1_3 = minus_P_thetadot1_7_3 + R7_23 * t7_11 - R7_13 * t7_10;
  v_y[126] = -minus_B22_1_1;
  v_y[133] = -minus_B22_1_2;
  v_y[140] = -minus_B22_1_3;
  // B23_2 = -R7^T r7~ omega_thetadot2_7 + P_thetadot2_7
  const T t7_12 = T(0.02) * omega_thetadot2_7_2;
  const T t7_13 = T(0.02) * omega_thetadot2_7_1;
  const T B23_2_1 = P_thetadot2_7_1 + R7_11 * t7_12 + minus_R7_21 * t7_13;
  const T minus_B23_2_2 = minus_P_thetadot2_7_2 + R7_22 * t7_13 - R7_12 * t7_12;
  const T minus_B23_2_3 = minus_P_thetadot2_7_3 + R7_23 * t7_13 - R7_13 * t7_12;
  v_y[127] = B23_2_1;
  v_y[134] = -minus_B23_2_2;
  v_y[141] = -minus_B23_2_3;
  // B24_3 = -R7^T r7~ omega_thetadot3_7 + P_thetadot3_7
  const T t7_14 = T(0.02) * minus_omega_thetadot3_7_2;
  const T t7_15 = T(0.02) * omega_thetadot3_7_1;
  const T minus_B24_3_1 = minus_P_thetadot3_7_1 + R7_11 * t7_14 - minus_R7_21 * t7_15;
  const T minus_B24_3_2 = minus_P_thetadot3_7_2 + R7_12 * t7_14 + R7_22 * t7_15;
  const T minus_B24_3_3 = minus_P_thetadot3_7_3 + R7_13 * t7_14 + R7_23 * t7_15;
  v_y[128] = -minus_B24_3_1;
  v_y[135] = -minus_B24_3_2;
  v_y[142] = -minus_B24_3_3;
  // B25_4 = -R7^T r7~ omega_thetadot4_7 + P_thetadot4_7
  const T t7_16 = T(0.02) * minus_omega_thetadot4_7_1;
  const T t7_17 = T(0.02) * omega_thetadot4_7_2;
  const T minus_B25_4_1 = minus_P_thetadot4_7_1 + minus_R7_21 * t7_16 - R7_11 * t7_17;
  const T minus_B25_4_2 = minus_P_thetadot4_7_2 - R7_12 * t7_17 - R7_22 * t7_16;
  const T minus_B25_4_3 = minus_P_thetadot4_7_3 - R7_13 * t7_17 - R7_23 * t7_16;
  v_y[129] = -minus_B25_4_1;
  v_y[136] = -minus_B25_4_2;
  v_y[143] = -minus_B25_4_3;
  // B26_5 = -R7^T r7~ omega_thetadot5_7 + P_thetadot5_7
  const T t7_18 = T(0.02) * minus_omega_thetadot5_7_1;
  const T t7_19 = T(0.02) * omega_thetadot5_7_2;
  const T minus_B26_5_1 = minus_R7_21 * t7_18 - R7_11 * t7_19 + minus_P_thetadot5_7_1;
  const T B26_5_2 = R7_12 * t7_19 + R7_22 * t7_18 + P_thetadot5_7_2;
  const T B26_5_3 = R7_13 * t7_19 + R7_23 * t7_18 + P_thetadot5_7_3;
  v_y[130] = -minus_B26_5_1;
  v_y[137] = B26_5_2;
  v_y[144] = B26_5_3;
  // B27_6 = -R7^T r7~ omega_thetadot6_7 + P_thetadot6_7
  const T t7_20 = T(0.02) * E7_11;
  const T t7_21 = T(0.02) * E7_12;
  const T B27_6_1 = R7_11 * t7_20 + minus_R7_21 * t7_21 + P_thetadot6_7_1;
  const T minus_B27_6_2 = R7_22 * t7_21 - R7_12 * t7_20 - P_thetadot6_7_2;
  const T minus_B27_6_3 = R7_23 * t7_21 - t7_2 - R7_13 * t7_20;
  v_y[131] = B27_6_1;
  v_y[138] = -minus_B27_6_2;
  v_y[145] = -minus_B27_6_3;
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 732 add, 1147 multiply, 14 sine or cosine
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  for (int i = 0; i < 147; ++i) v_y_dot[i] = T(0);
  T cosines[7], sines[7];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 7, cosines, sines);

  // ---- body 1 (link_1) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T E1_12 = sines[0];
  // B1_1 = -E1^T omega1~ r1~ b1
  const T t1_1 = thetadot1 * T(0.03);
  const T minus_B1_1_1 = E1_12 * t1_1;
  const T B1_1_2 = E1_11 * t1_1;
  v_y_dot[0] = -minus_B1_1_1;
  v_y_dot[7] = B1_1_2;

  // ---- body 2 (link_2) on body 1
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
  // B2_1 = -R2^T omega2~ (C2^T r2)~ omega_thetadot1_2 - R2^T (C2^T r2)~ omega_dot_thetadot1_2 + P_dot_thetadot1_2
  const T t2_1 = T(0.042) * minus_E2_13;
  const T t2_2 = T(3e-04) * E2_11 - T(0.059) * minus_E2_13;
  const T t2_3 = thetadot2 * t2_1 - omega2_3 * t2_2;
  const T t2_4 = T(0.042) * E2_11;
  const T t2_5 = omega2_3 * t2_4 + minus_omega2_1 * t2_1;
  const T t2_6 = minus_omega2_1 * t2_2 + thetadot2 * t2_4;
  const T t2_7 = T(0.059) * minus_omega_dot_thetadot1_2_1 + T(3e-04) * minus_omega_dot_thetadot1_2_3;
  const T t2_8 = T(0.042) * minus_omega_dot_thetadot1_2_3;
  const T t2_9 = T(0.042) * minus_omega_dot_thetadot1_2_1;
  const T minus_B2_1_1 = R2_11 * t2_3 - E1_12 * t2_5 - R2_31 * t2_6 + E1_12 * t2_7 - R2_11 * t2_8 + R2_31 * t2_9;
  const T minus_B2_1_2 = R2_12 * t2_3 + E1_11 * t2_5 - R2_32 * t2_6 - R2_12 * t2_8 - E1_11 * t2_7 + R2_32 * t2_9;
  const T minus_B2_1_3 = minus_E2_13 * t2_8 - (minus_E2_13 * t2_3 + E2_11 * t2_6) + E2_11 * t2_9;
  v_y_dot[21] = -minus_B2_1_1;
  v_y_dot[28] = -minus_B2_1_2;
  v_y_dot[35] = -minus_B2_1_3;
  // B3_2 = -R2^T omega2~ (C2^T r2)~ b2
  const T t2_10 = omega2_3 * T(0.059) + minus_omega2_1 * T(3e-04);
  const T t2_11 = thetadot2 * T(3e-04);
  const T t2_12 = thetadot2 * T(0.059);
  const T minus_B3_2_1 = E1_12 * t2_10 - R2_11 * t2_11 + R2_31 * t2_12;
  const T minus_B3_2_2 = R2_32 * t2_12 - (R2_12 * t2_11 + E1_11 * t2_10);
  const T minus_B3_2_3 = minus_E2_13 * t2_11 + E2_11 * t2_12;
  v_y_dot[22] = -minus_B3_2_1;
  v_y_dot[29] = -minus_B3_2_2;
  v_y_dot[36] = -minus_B3_2_3;

  // ---- body 3 (link_3) on body 2
  const T thetadot3 = y[2];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[2];
  const T E3_12 = sines[2];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R2_11 * E3_11 - E1_12 * E3_12;
  const T R3_12 = R2_12 * E3_11 + E1_11 * E3_12;
  const T minus_R3_13 = minus_E2_13 * E3_11;
  const T minus_R3_21 = E1_12 * E3_11 + R2_11 * E3_12;
  const T R3_22 = E1_11 * E3_11 - R2_12 * E3_12;
  const T R3_23 = minus_E2_13 * E3_12;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_12 * thetadot2 - E3_11 * minus_omega2_1;
  const T omega3_2 = E3_11 * thetadot2 + E3_12 * minus_omega2_1;
  const T omega3_3 = thetadot3 + omega2_3;
  // omega_dot_thetadot1_3 = -thetadot3 b3~ E3 omega_thetadot1_2 + E3 omega_dot_thetadot1_2: its rate
  const T omega_dot_thetadot1_3_1 = thetadot3 * R3_23 - E3_11 * minus_omega_dot_thetadot1_2_1;
  const T omega_dot_thetadot1_3_2 = thetadot3 * minus_R3_13 + E3_12 * minus_omega_dot_thetadot1_2_1;
  // omega_dot_thetadot2_3 = -thetadot3 b3~ E3 b2: its rate
  const T omega_dot_thetadot2_3_1 = thetadot3 * E3_11;
  const T minus_omega_dot_thetadot2_3_2 = thetadot3 * E3_12;
  // P_dot_thetadot1_3 = R2^T (-omega2~ q3~ omega_thetadot1_2 - q3~ omega_dot_thetadot1_2) + P_dot_thetadot1_2: its
  //   rate
  const T t3_1 = T(0.2045) * minus_E2_13;
  const T t3_2 = omega2_3 * t3_1;
  const T t3_3 = T(0.2045) * minus_omega_dot_thetadot1_2_1;
  const T t3_4 = minus_omega2_1 * t3_1;
  const T minus_P_dot_thetadot1_3_1 = R2_11 * t3_2 + E1_12 * t3_3 + R2_31 * t3_4;
  const T minus_P_dot_thetadot1_3_2 = R2_12 * t3_2 - E1_11 * t3_3 + R2_32 * t3_4;
  const T minus_P_dot_thetadot1_3_3 = E2_11 * t3_4 - minus_E2_13 * t3_2;
  // P_dot_thetadot2_3 = -R2^T omega2~ q3~ b2: its rate
  const T t3_5 = omega2_3 * T(0.2045);
  const T t3_6 = thetadot2 * T(0.2045);
  const T minus_P_dot_thetadot2_3_1 = E1_12 * t3_5 + R2_31 * t3_6;
  const T minus_P_dot_thetadot2_3_2 = R2_32 * t3_6 - E1_11 * t3_5;
  const T minus_P_dot_thetadot2_3_3 = E2_11 * t3_6;
  // B4_1 = -R3^T omega3~ r3~ omega_thetadot1_3 - R3^T r3~ omega_dot_thetadot1_3 + P_dot_thetadot1_3
  const T t3_7 = T(0.13) * minus_R3_13;
  const T t3_8 = T(0.03) * minus_R3_13;
  const T t3_9 = omega3_3 * t3_7 + omega3_2 * t3_8;
  const T t3_10 = T(0.03) * E2_11 - T(0.13) * R3_23;
  const T t3_11 = omega3_3 * t3_10 - omega3_1 * t3_8;
  const T t3_12 = omega3_1 * t3_7 + omega3_2 * t3_10;
  const T t3_13 = T(0.13) * omega_dot_thetadot1_3_2 + T(0.03) * minus_omega_dot_thetadot1_2_3;
  const T t3_14 = T(0.13) * omega_dot_thetadot1_3_1;
  const T t3_15 = T(0.03) * omega_dot_thetadot1_3_1;
  const T minus_B4_1_1 = minus_P_dot_thetadot1_3_1 + R3_11 * t3_9 - minus_R3_21 * t3_11 - R2_31 * t3_12 - R3_11 *
      t3_13 - minus_R3_21 * t3_14 - R2_31 * t3_15;
  const T minus_B4_1_2 = minus_P_dot_thetadot1_3_2 + R3_12 * t3_9 + R3_22 * t3_11 - R2_32 * t3_12 + R3_22 * t3_14 -
      R3_12 * t3_13 - R2_32 * t3_15;
  const T minus_B4_1_3 = minus_P_dot_thetadot1_3_3 + R3_23 * t3_11 - minus_R3_13 * t3_9 - E2_11 * t3_12 + minus_R3_13
      * t3_13 + R3_23 * t3_14 - E2_11 * t3_15;
  v_y_dot[42] = -minus_B4_1_1;
  v_y_dot[49] = -minus_B4_1_2;
  v_y_dot[56] = -minus_B4_1_3;
  // B5_2 = -R3^T omega3~ r3~ omega_thetadot2_3 - R3^T r3~ omega_dot_thetadot2_3 + P_dot_thetadot2_3
  const T t3_16 = T(0.13) * E3_12;
  const T t3_17 = T(0.03) * E3_12;
  const T t3_18 = omega3_3 * t3_16 + omega3_2 * t3_17;
  const T t3_19 = T(0.13) * E3_11;
  const T t3_20 = omega3_1 * t3_17 - omega3_3 * t3_19;
  const T t3_21 = omega3_1 * t3_16 + omega3_2 * t3_19;
  const T t3_22 = T(0.13) * minus_omega_dot_thetadot2_3_2;
  const T t3_23 = T(0.13) * omega_dot_thetadot2_3_1;
  const T t3_24 = T(0.03) * omega_dot_thetadot2_3_1;
  const T minus_B5_2_1 = minus_P_dot_thetadot2_3_1 - R3_11 * t3_18 - minus_R3_21 * t3_20 + R2_31 * t3_21 + R3_11 *
      t3_22 - minus_R3_21 * t3_23 - R2_31 * t3_24;
  const T minus_B5_2_2 = minus_P_dot_thetadot2_3_2 + R3_22 * t3_20 - R3_12 * t3_18 + R2_32 * t3_21 + R3_12 * t3_22 +
      R3_22 * t3_23 - R2_32 * t3_24;
  const T minus_B5_2_3 = minus_P_dot_thetadot2_3_3 + minus_R3_13 * t3_18 + R3_23 * t3_20 + E2_11 * t3_21 + R3_23 *
      t3_23 - minus_R3_13 * t3_22 - E2_11 * t3_24;
  v_y_dot[43] = -minus_B5_2_1;
  v_y_dot[50] = -minus_B5_2_2;
  v_y_dot[57] = -minus_B5_2_3;
  // B6_3 = -R3^T omega3~ r3~ b3
  const T t3_25 = omega3_3 * T(0.03);
  const T t3_26 = omega3_2 * T(0.03);
  const T B6_3_1 = minus_R3_21 * t3_25 + R2_31 * t3_26;
  const T minus_B6_3_2 = R3_22 * t3_25 - R2_32 * t3_26;
  const T minus_B6_3_3 = R3_23 * t3_25 - E2_11 * t3_26;
  v_y_dot[44] = B6_3_1;
  v_y_dot[51] = -minus_B6_3_2;
  v_y_dot[58] = -minus_B6_3_3;

  // ---- body 4 (link_4) on body 3
  const T thetadot4 = y[3];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[3];
  const T E4_13 = sines[3];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 + R2_31 * E4_13;
  const T R4_12 = R3_12 * E4_11 + R2_32 * E4_13;
  const T R4_13 = E2_11 * E4_13 - minus_R3_13 * E4_11;
  const T R4_31 = R2_31 * E4_11 - R3_11 * E4_13;
  const T R4_32 = R2_32 * E4_11 - R3_12 * E4_13;
  const T R4_33 = minus_R3_13 * E4_13 + E2_11 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 + E4_13 * omega3_3;
  const T omega4_2 = omega3_2 - thetadot4;
  const T omega4_3 = E4_11 * omega3_3 - E4_13 * omega3_1;
  // omega_dot_thetadot1_4 = -thetadot4 b4~ E4 omega_thetadot1_3 + E4 omega_dot_thetadot1_3: its rate
  const T omega_dot_thetadot1_4_1 = thetadot4 * R4_33 + E4_11 * omega_dot_thetadot1_3_1 - E4_13 *
      minus_omega_dot_thetadot1_2_3;
  const T minus_omega_dot_thetadot1_4_3 = thetadot4 * R4_13 + E4_13 * omega_dot_thetadot1_3_1 + E4_11 *
      minus_omega_dot_thetadot1_2_3;
  // omega_thetadot2_4 = E4 omega_thetadot2_3: partial angular velocity, body axes
  const T omega_thetadot2_4_1 = E4_11 * E3_12;
  const T minus_omega_thetadot2_4_3 = E4_13 * E3_12;
  // omega_dot_thetadot2_4 = -thetadot4 b4~ E4 omega_thetadot2_3 + E4 omega_dot_thetadot2_3: its rate
  const T omega_dot_thetadot2_4_1 = E4_11 * omega_dot_thetadot2_3_1 - thetadot4 * minus_omega_thetadot2_4_3;
  const T minus_omega_dot_thetadot2_4_3 = thetadot4 * omega_thetadot2_4_1 + E4_13 * omega_dot_thetadot2_3_1;
  // omega_dot_thetadot3_4 = -thetadot4 b4~ E4 b3: its rate
  const T omega_dot_thetadot3_4_1 = thetadot4 * E4_11;
  const T minus_omega_dot_thetadot3_4_3 = thetadot4 * E4_13;
  // P_dot_thetadot1_4 = R3^T (-omega3~ q4~ omega_thetadot1_3 - q4~ omega_dot_thetadot1_3) + P_dot_thetadot1_3: its
  //   rate
  const T t4_1 = T(0.2155) * minus_R3_13;
  const T t4_2 = omega3_3 * t4_1 - T(0.2155) * omega_dot_thetadot1_3_2;
  const T t4_3 = T(0.2155) * R3_23;
  const T t4_4 = T(0.2155) * omega_dot_thetadot1_3_1 - omega3_3 * t4_3;
  const T t4_5 = omega3_2 * t4_3 - omega3_1 * t4_1;
  const T minus_P_dot_thetadot1_4_1 = minus_P_dot_thetadot1_3_1 + R3_11 * t4_2 - minus_R3_21 * t4_4 + R2_31 * t4_5;
  const T minus_P_dot_thetadot1_4_2 = minus_P_dot_thetadot1_3_2 + R3_12 * t4_2 + R3_22 * t4_4 + R2_32 * t4_5;
  const T minus_P_dot_thetadot1_4_3 = minus_P_dot_thetadot1_3_3 + R3_23 * t4_4 - minus_R3_13 * t4_2 + E2_11 * t4_5;
  // P_dot_thetadot2_4 = R3^T (-omega3~ q4~ omega_thetadot2_3 - q4~ omega_dot_thetadot2_3) + P_dot_thetadot2_3: its
  //   rate
  const T t4_6 = T(0.2155) * E3_12;
  const T t4_7 = T(0.2155) * minus_omega_dot_thetadot2_3_2 - omega3_3 * t4_6;
  const T t4_8 = T(0.2155) * E3_11;
  const T t4_9 = T(0.2155) * omega_dot_thetadot2_3_1 - omega3_3 * t4_8;
  const T t4_10 = omega3_1 * t4_6 + omega3_2 * t4_8;
  const T minus_P_dot_thetadot2_4_1 = minus_P_dot_thetadot2_3_1 + R3_11 * t4_7 - minus_R3_21 * t4_9 + R2_31 * t4_10;
  const T minus_P_dot_thetadot2_4_2 = minus_P_dot_thetadot2_3_2 + R3_12 * t4_7 + R3_22 * t4_9 + R2_32 * t4_10;
  const T minus_P_dot_thetadot2_4_3 = minus_P_dot_thetadot2_3_3 + R3_23 * t4_9 - minus_R3_13 * t4_7 + E2_11 * t4_10;
  // B7_1 = -R4^T omega4~ (C4^T r4)~ omega_thetadot1_4 - R4^T (C4^T r4)~ omega_dot_thetadot1_4 + P_dot_thetadot1_4
  const T t4_11 = T(0.034) * R4_13;
  const T t4_12 = T(0.067) * R4_13;
  const T t4_13 = omega4_2 * t4_11 - omega4_3 * t4_12;
  const T t4_14 = T(0.067) * R3_23 + T(0.034) * R4_33;
  const T t4_15 = omega4_3 * t4_14 + omega4_1 * t4_11;
  const T t4_16 = omega4_1 * t4_12 + omega4_2 * t4_14;
  const T t4_17 = T(0.034) * minus_omega_dot_thetadot1_4_3 - T(0.067) * omega_dot_thetadot1_3_2;
  const T t4_18 = T(0.067) * omega_dot_thetadot1_4_1;
  const T t4_19 = T(0.034) * omega_dot_thetadot1_4_1;
  const T minus_B7_1_1 = minus_P_dot_thetadot1_4_1 + R4_11 * t4_13 + minus_R3_21 * t4_15 + R4_31 * t4_16 + R4_11 *
      t4_17 - minus_R3_21 * t4_18 + R4_31 * t4_19;
  const T minus_B7_1_2 = minus_P_dot_thetadot1_4_2 + R4_12 * t4_13 - R3_22 * t4_15 + R4_32 * t4_16 + R4_12 * t4_17 +
      R3_22 * t4_18 + R4_32 * t4_19;
  const T minus_B7_1_3 = minus_P_dot_thetadot1_4_3 + R4_13 * t4_13 - R3_23 * t4_15 + R4_33 * t4_16 + R4_13 * t4_17 +
      R3_23 * t4_18 + R4_33 * t4_19;
  v_y_dot[63] = -minus_B7_1_1;
  v_y_dot[70] = -minus_B7_1_2;
  v_y_dot[77] = -minus_B7_1_3;
  // B8_2 = -R4^T omega4~ (C4^T r4)~ omega_thetadot2_4 - R4^T (C4^T r4)~ omega_dot_thetadot2_4 + P_dot_thetadot2_4
  const T t4_20 = T(0.034) * omega_thetadot2_4_1;
  const T t4_21 = T(0.067) * omega_thetadot2_4_1;
  const T t4_22 = omega4_2 * t4_20 - omega4_3 * t4_21;
  const T t4_23 = T(0.034) * minus_omega_thetadot2_4_3 - T(0.067) * E3_11;
  const T t4_24 = omega4_3 * t4_23 - omega4_1 * t4_20;
  const T t4_25 = omega4_1 * t4_21 - omega4_2 * t4_23;
  const T t4_26 = T(0.067) * minus_omega_dot_thetadot2_3_2 + T(0.034) * minus_omega_dot_thetadot2_4_3;
  const T t4_27 = T(0.067) * omega_dot_thetadot2_4_1;
  const T t4_28 = T(0.034) * omega_dot_thetadot2_4_1;
  const T minus_B8_2_1 = minus_P_dot_thetadot2_4_1 + R4_11 * t4_22 - minus_R3_21 * t4_24 + R4_31 * t4_25 + R4_11 *
      t4_26 - minus_R3_21 * t4_27 + R4_31 * t4_28;
  const T minus_B8_2_2 = minus_P_dot_thetadot2_4_2 + R4_12 * t4_22 + R3_22 * t4_24 + R4_32 * t4_25 + R4_12 * t4_26 +
      R3_22 * t4_27 + R4_32 * t4_28;
  const T minus_B8_2_3 = minus_P_dot_thetadot2_4_3 + R4_13 * t4_22 + R3_23 * t4_24 + R4_33 * t4_25 + R4_13 * t4_26 +
      R3_23 * t4_27 + R4_33 * t4_28;
  v_y_dot[64] = -minus_B8_2_1;
  v_y_dot[71] = -minus_B8_2_2;
  v_y_dot[78] = -minus_B8_2_3;
  // B9_3 = -R4^T omega4~ (C4^T r4)~ omega_thetadot3_4 - R4^T (C4^T r4)~ omega_dot_thetadot3_4 + P_dot_thetadot3_4
  const T t4_29 = T(0.034) * E4_13;
  const T t4_30 = T(0.067) * E4_13;
  const T t4_31 = omega4_2 * t4_29 - omega4_3 * t4_30;
  const T t4_32 = T(0.034) * E4_11;
  const T t4_33 = omega4_3 * t4_32 + omega4_1 * t4_29;
  const T t4_34 = omega4_1 * t4_30 + omega4_2 * t4_32;
  const T t4_35 = T(0.034) * minus_omega_dot_thetadot3_4_3;
  const T t4_36 = T(0.067) * omega_dot_thetadot3_4_1;
  const T t4_37 = T(0.034) * omega_dot_thetadot3_4_1;
  const T minus_B9_3_1 = R4_11 * t4_31 + minus_R3_21 * t4_33 + R4_31 * t4_34 + R4_11 * t4_35 - minus_R3_21 * t4_36 +
      R4_31 * t4_37;
  const T minus_B9_3_2 = R4_12 * t4_31 - R3_22 * t4_33 + R4_32 * t4_34 + R4_12 * t4_35 + R3_22 * t4_36 + R4_32 *
      t4_37;
  const T minus_B9_3_3 = R4_13 * t4_31 - R3_23 * t4_33 + R4_33 * t4_34 + R4_13 * t4_35 + R3_23 * t4_36 + R4_33 *
      t4_37;
  v_y_dot[65] = -minus_B9_3_1;
  v_y_dot[72] = -minus_B9_3_2;
  v_y_dot[79] = -minus_B9_3_3;
  // B10_4 = -R4^T omega4~ (C4^T r4)~ b4
  const T t4_38 = omega4_3 * T(0.067);
  const T t4_39 = omega4_2 * T(0.067);
  const T B10_4_1 = minus_R3_21 * t4_38 + R4_31 * t4_39;
  const T minus_B10_4_2 = R3_22 * t4_38 - R4_32 * t4_39;
  const T minus_B10_4_3 = R3_23 * t4_38 - R4_33 * t4_39;
  v_y_dot[66] = B10_4_1;
  v_y_dot[73] = -minus_B10_4_2;
  v_y_dot[80] = -minus_B10_4_3;

  // ---- body 5 (link_5) on body 4
  const T thetadot5 = y[4];
  // E5^T = Rot(b5, theta5): E takes components in the lower body to those in the body
  const T E5_11 = cosines[4];
  const T E5_12 = sines[4];
  // R5^T = R4^T E5^T: R takes inertial components to body components
  const T R5_11 = R4_11 * E5_11 - minus_R3_21 * E5_12;
  const T R5_12 = R4_12 * E5_11 + R3_22 * E5_12;
  const T R5_13 = R4_13 * E5_11 + R3_23 * E5_12;
  const T minus_R5_21 = minus_R3_21 * E5_11 + R4_11 * E5_12;
  const T R5_22 = R3_22 * E5_11 - R4_12 * E5_12;
  const T R5_23 = R3_23 * E5_11 - R4_13 * E5_12;
  // omega5 = thetadot5 b5 + E5 omega4: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = E5_11 * omega4_1 + E5_12 * omega4_2;
  const T omega5_2 = E5_11 * omega4_2 - E5_12 * omega4_1;
  const T omega5_3 = thetadot5 + omega4_3;
  // omega_dot_thetadot1_5 = -thetadot5 b5~ E5 omega_thetadot1_4 + E5 omega_dot_thetadot1_4: its rate
  const T omega_dot_thetadot1_5_1 = thetadot5 * R5_23 + E5_11 * omega_dot_thetadot1_4_1 + E5_12 *
      omega_dot_thetadot1_3_2;
  const T omega_dot_thetadot1_5_2 = E5_11 * omega_dot_thetadot1_3_2 - E5_12 * omega_dot_thetadot1_4_1 - thetadot5 *
      R5_13;
  // omega_thetadot2_5 = E5 omega_thetadot2_4: partial angular velocity, body axes
  const T omega_thetadot2_5_1 = E5_11 * omega_thetadot2_4_1 + E5_12 * E3_11;
  const T omega_thetadot2_5_2 = E5_11 * E3_11 - E5_12 * omega_thetadot2_4_1;
  // omega_dot_thetadot2_5 = -thetadot5 b5~ E5 omega_thetadot2_4 + E5 omega_dot_thetadot2_4: its rate
  const T omega_dot_thetadot2_5_1 = thetadot5 * omega_thetadot2_5_2 + E5_11 * omega_dot_thetadot2_4_1 - E5_12 *
      minus_omega_dot_thetadot2_3_2;
  const T minus_omega_dot_thetadot2_5_2 = thetadot5 * omega_thetadot2_5_1 + E5_11 * minus_omega_dot_thetadot2_3_2 +
      E5_12 * omega_dot_thetadot2_4_1;
  // omega_thetadot3_5 = E5 omega_thetadot3_4: partial angular velocity, body axes
  const T omega_thetadot3_5_1 = E5_11 * E4_13;
  const T minus_omega_thetadot3_5_2 = E5_12 * E4_13;
  // omega_dot_thetadot3_5 = -thetadot5 b5~ E5 omega_thetadot3_4 + E5 omega_dot_thetadot3_4: its rate
  const T omega_dot_thetadot3_5_1 = E5_11 * omega_dot_thetadot3_4_1 - thetadot5 * minus_omega_thetadot3_5_2;
  const T minus_omega_dot_thetadot3_5_2 = thetadot5 * omega_thetadot3_5_1 + E5_12 * omega_dot_thetadot3_4_1;
  // omega_dot_thetadot4_5 = -thetadot5 b5~ E5 b4: its rate
  const T minus_omega_dot_thetadot4_5_1 = thetadot5 * E5_11;
  const T omega_dot_thetadot4_5_2 = thetadot5 * E5_12;
  // P_dot_thetadot1_5 = R4^T (-omega4~ q5~ omega_thetadot1_4 - q5~ omega_dot_thetadot1_4) + P_dot_thetadot1_4: its
  //   rate
  const T t5_1 = T(0.1845) * R4_13;
  const T t5_2 = omega4_3 * t5_1 + T(0.1845) * omega_dot_thetadot1_3_2;
  const T t5_3 = T(0.1845) * R3_23;
  const T t5_4 = T(0.1845) * omega_dot_thetadot1_4_1 - omega4_3 * t5_3;
  const T t5_5 = omega4_1 * t5_1 + omega4_2 * t5_3;
  const T minus_P_dot_thetadot1_5_1 = minus_P_dot_thetadot1_4_1 - R4_11 * t5_2 - minus_R3_21 * t5_4 + R4_31 * t5_5;
  const T minus_P_dot_thetadot1_5_2 = minus_P_dot_thetadot1_4_2 + R3_22 * t5_4 - R4_12 * t5_2 + R4_32 * t5_5;
  const T minus_P_dot_thetadot1_5_3 = minus_P_dot_thetadot1_4_3 + R3_23 * t5_4 - R4_13 * t5_2 + R4_33 * t5_5;
  // P_dot_thetadot2_5 = R4^T (-omega4~ q5~ omega_thetadot2_4 - q5~ omega_dot_thetadot2_4) + P_dot_thetadot2_4: its
  //   rate
  const T t5_6 = T(0.1845) * omega_thetadot2_4_1;
  const T t5_7 = T(0.1845) * minus_omega_dot_thetadot2_3_2 - omega4_3 * t5_6;
  const T t5_8 = T(0.1845) * E3_11;
  const T t5_9 = T(0.1845) * omega_dot_thetadot2_4_1 - omega4_3 * t5_8;
  const T t5_10 = omega4_1 * t5_6 + omega4_2 * t5_8;
  const T minus_P_dot_thetadot2_5_1 = minus_P_dot_thetadot2_4_1 + R4_11 * t5_7 - minus_R3_21 * t5_9 + R4_31 * t5_10;
  const T minus_P_dot_thetadot2_5_2 = minus_P_dot_thetadot2_4_2 + R4_12 * t5_7 + R3_22 * t5_9 + R4_32 * t5_10;
  const T minus_P_dot_thetadot2_5_3 = minus_P_dot_thetadot2_4_3 + R4_13 * t5_7 + R3_23 * t5_9 + R4_33 * t5_10;
  // P_dot_thetadot3_5 = R4^T (-omega4~ q5~ omega_thetadot3_4 - q5~ omega_dot_thetadot3_4) + P_dot_thetadot3_4: its
  //   rate
  const T t5_11 = T(0.1845) * E4_13;
  const T t5_12 = omega4_1 * t5_11;
  const T t5_13 = omega4_3 * t5_11;
  const T t5_14 = T(0.1845) * omega_dot_thetadot3_4_1;
  const T minus_P_dot_thetadot3_5_1 = R4_31 * t5_12 - (R4_11 * t5_13 + minus_R3_21 * t5_14);
  const T minus_P_dot_thetadot3_5_2 = R3_22 * t5_14 - R4_12 * t5_13 + R4_32 * t5_12;
  const T minus_P_dot_thetadot3_5_3 = R3_23 * t5_14 - R4_13 * t5_13 + R4_33 * t5_12;
  // P_dot_thetadot4_5 = -R4^T omega4~ q5~ b4: its rate
  const T t5_15 = omega4_3 * T(0.1845);
  const T t5_16 = omega4_2 * T(0.1845);
  const T P_dot_thetadot4_5_1 = minus_R3_21 * t5_15 + R4_31 * t5_16;
  const T minus_P_dot_thetadot4_5_2 = R3_22 * t5_15 - R4_32 * t5_16;
  const T minus_P_dot_thetadot4_5_3 = R3_23 * t5_15 - R4_33 * t5_16;
  // B11_1 = -R5^T omega5~ (C5^T r5)~ omega_thetadot1_5 - R5^T (C5^T r5)~ omega_dot_thetadot1_5 + P_dot_thetadot1_5
  const T t5_17 = T(0.021) * R5_13 - T(1e-04) * R5_23;
  const T t5_18 = T(0.076) * R5_13 + T(1e-04) * R4_33;
  const T t5_19 = omega5_2 * t5_17 - omega5_3 * t5_18;
  const T t5_20 = T(0.076) * R5_23 + T(0.021) * R4_33;
  const T t5_21 = omega5_3 * t5_20 + omega5_1 * t5_17;
  const T t5_22 = omega5_1 * t5_18 + omega5_2 * t5_20;
  const T t5_23 = T(0.021) * minus_omega_dot_thetadot1_4_3 - T(0.076) * omega_dot_thetadot1_5_2;
  const T t5_24 = T(0.076) * omega_dot_thetadot1_5_1 - T(1e-04) * minus_omega_dot_thetadot1_4_3;
  const T t5_25 = T(0.021) * omega_dot_thetadot1_5_1 - T(1e-04) * omega_dot_thetadot1_5_2;
  const T minus_B11_1_1 = minus_P_dot_thetadot1_5_1 + R5_11 * t5_19 + minus_R5_21 * t5_21 + R4_31 * t5_22 + R5_11 *
      t5_23 - minus_R5_21 * t5_24 + R4_31 * t5_25;
  const T minus_B11_1_2 = minus_P_dot_thetadot1_5_2 + R5_12 * t5_19 - R5_22 * t5_21 + R4_32 * t5_22 + R5_12 * t5_23 +
      R5_22 * t5_24 + R4_32 * t5_25;
  const T minus_B11_1_3 = minus_P_dot_thetadot1_5_3 + R5_13 * t5_19 - R5_23 * t5_21 + R4_33 * t5_22 + R5_13 * t5_23 +
      R5_23 * t5_24 + R4_33 * t5_25;
  v_y_dot[84] = -minus_B11_1_1;
  v_y_dot[91] = -minus_B11_1_2;
  v_y_dot[98] = -minus_B11_1_3;
  // B12_2 = -R5^T omega5~ (C5^T r5)~ omega_thetadot2_5 - R5^T (C5^T r5)~ omega_dot_thetadot2_5 + P_dot_thetadot2_5
  const T t5_26 = T(0.021) * omega_thetadot2_5_1 - T(1e-04) * omega_thetadot2_5_2;
  const T t5_27 = T(0.076) * omega_thetadot2_5_1 - T(1e-04) * minus_omega_thetadot2_4_3;
  const T t5_28 = omega5_2 * t5_26 - omega5_3 * t5_27;
  const T t5_29 = T(0.021) * minus_omega_thetadot2_4_3 - T(0.076) * omega_thetadot2_5_2;
  const T t5_30 = omega5_3 * t5_29 - omega5_1 * t5_26;
  const T t5_31 = omega5_1 * t5_27 - omega5_2 * t5_29;
  const T t5_32 = T(0.076) * minus_omega_dot_thetadot2_5_2 + T(0.021) * minus_omega_dot_thetadot2_4_3;
  const T t5_33 = T(0.076) * omega_dot_thetadot2_5_1 - T(1e-04) * minus_omega_dot_thetadot2_4_3;
  const T t5_34 = T(1e-04) * minus_omega_dot_thetadot2_5_2 + T(0.021) * omega_dot_thetadot2_5_1;
  const T minus_B12_2_1 = minus_P_dot_thetadot2_5_1 + R5_11 * t5_28 - minus_R5_21 * t5_30 + R4_31 * t5_31 + R5_11 *
      t5_32 - minus_R5_21 * t5_33 + R4_31 * t5_34;
  const T minus_B12_2_2 = minus_P_dot_thetadot2_5_2 + R5_12 * t5_28 + R5_22 * t5_30 + R4_32 * t5_31 + R5_12 * t5_32 +
      R5_22 * t5_33 + R4_32 * t5_34;
  const T minus_B12_2_3 = minus_P_dot_thetadot2_5_3 + R5_13 * t5_28 + R5_23 * t5_30 + R4_33 * t5_31 + R5_13 * t5_32 +
      R5_23 * t5_33 + R4_33 * t5_34;
  v_y_dot[85] = -minus_B12_2_1;
  v_y_dot[92] = -minus_B12_2_2;
  v_y_dot[99] = -minus_B12_2_3;
  // B13_3 = -R5^T omega5~ (C5^T r5)~ omega_thetadot3_5 - R5^T (C5^T r5)~ omega_dot_thetadot3_5 + P_dot_thetadot3_5
  const T t5_35 = T(1e-04) * minus_omega_thetadot3_5_2 + T(0.021) * omega_thetadot3_5_1;
  const T t5_36 = T(0.076) * omega_thetadot3_5_1 + T(1e-04) * E4_11;
  const T t5_37 = omega5_2 * t5_35 - omega5_3 * t5_36;
  const T t5_38 = T(0.076) * minus_omega_thetadot3_5_2 - T(0.021) * E4_11;
  const T t5_39 = omega5_3 * t5_38 - omega5_1 * t5_35;
  const T t5_40 = omega5_1 * t5_36 - omega5_2 * t5_38;
  const T t5_41 = T(0.076) * minus_omega_dot_thetadot3_5_2 + T(0.021) * minus_omega_dot_thetadot3_4_3;
  const T t5_42 = T(0.076) * omega_dot_thetadot3_5_1 - T(1e-04) * minus_omega_dot_thetadot3_4_3;
  const T t5_43 = T(1e-04) * minus_omega_dot_thetadot3_5_2 + T(0.021) * omega_dot_thetadot3_5_1;
  const T minus_B13_3_1 = minus_P_dot_thetadot3_5_1 + R5_11 * t5_37 - minus_R5_21 * t5_39 + R4_31 * t5_40 + R5_11 *
      t5_41 - minus_R5_21 * t5_42 + R4_31 * t5_43;
  const T minus_B13_3_2 = minus_P_dot_thetadot3_5_2 + R5_12 * t5_37 + R5_22 * t5_39 + R4_32 * t5_40 + R5_12 * t5_41 +
      R5_22 * t5_42 + R4_32 * t5_43;
  const T minus_B13_3_3 = minus_P_dot_thetadot3_5_3 + R5_13 * t5_37 + R5_23 * t5_39 + R4_33 * t5_40 + R5_13 * t5_41 +
      R5_23 * t5_42 + R4_33 * t5_43;
  v_y_dot[86] = -minus_B13_3_1;
  v_y_dot[93] = -minus_B13_3_2;
  v_y_dot[100] = -minus_B13_3_3;
  // B14_4 = -R5^T omega5~ (C5^T r5)~ omega_thetadot4_5 - R5^T (C5^T r5)~ omega_dot_thetadot4_5 + P_dot_thetadot4_5
  const T t5_44 = T(0.076) * E5_12;
  const T t5_45 = T(1e-04) * E5_11 - T(0.021) * E5_12;
  const T t5_46 = omega5_3 * t5_44 + omega5_2 * t5_45;
  const T t5_47 = T(0.076) * E5_11;
  const T t5_48 = omega5_3 * t5_47 - omega5_1 * t5_45;
  const T t5_49 = omega5_1 * t5_44 + omega5_2 * t5_47;
  const T t5_50 = T(0.076) * minus_omega_dot_thetadot4_5_1;
  const T t5_51 = T(0.076) * omega_dot_thetadot4_5_2;
  const T t5_52 = T(1e-04) * omega_dot_thetadot4_5_2 + T(0.021) * minus_omega_dot_thetadot4_5_1;
  const T minus_B14_4_1 = R5_11 * t5_46 - P_dot_thetadot4_5_1 - minus_R5_21 * t5_48 - R4_31 * t5_49 + minus_R5_21 *
      t5_50 - R5_11 * t5_51 - R4_31 * t5_52;
  const T minus_B14_4_2 = minus_P_dot_thetadot4_5_2 + R5_12 * t5_46 + R5_22 * t5_48 - R4_32 * t5_49 - R5_12 * t5_51 -
      R5_22 * t5_50 - R4_32 * t5_52;
  const T minus_B14_4_3 = minus_P_dot_thetadot4_5_3 + R5_13 * t5_46 + R5_23 * t5_48 - R4_33 * t5_49 - R5_13 * t5_51 -
      R5_23 * t5_50 - R4_33 * t5_52;
  v_y_dot[87] = -minus_B14_4_1;
  v_y_dot[94] = -minus_B14_4_2;
  v_y_dot[101] = -minus_B14_4_3;
  // B15_5 = -R5^T omega5~ (C5^T r5)~ b5
  const T t5_53 = omega5_3 * T(0.021);
  const T t5_54 = omega5_3 * T(1e-04);
  const T t5_55 = omega5_1 * T(1e-04) + omega5_2 * T(0.021);
  const T minus_B15_5_1 = minus_R5_21 * t5_53 - R5_11 * t5_54 + R4_31 * t5_55;
  const T minus_B15_5_2 = R4_32 * t5_55 - (R5_12 * t5_54 + R5_22 * t5_53);
  const T minus_B15_5_3 = R4_33 * t5_55 - (R5_13 * t5_54 + R5_23 * t5_53);
  v_y_dot[88] = -minus_B15_5_1;
  v_y_dot[95] = -minus_B15_5_2;
  v_y_dot[102] = -minus_B15_5_3;

  // ---- body 6 (link_6) on body 5
  const T thetadot6 = y[5];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_11 = cosines[5];
  const T minus_E6_13 = sines[5];
  // R6^T = R5^T E6^T: R takes inertial components to body components
  const T R6_11 = R5_11 * E6_11 - R4_31 * minus_E6_13;
  const T R6_12 = R5_12 * E6_11 - R4_32 * minus_E6_13;
  const T R6_13 = R5_13 * E6_11 - R4_33 * minus_E6_13;
  const T R6_31 = R5_11 * minus_E6_13 + R4_31 * E6_11;
  const T R6_32 = R5_12 * minus_E6_13 + R4_32 * E6_11;
  const T R6_33 = R5_13 * minus_E6_13 + R4_33 * E6_11;
  // omega6 = thetadot6 b6 + E6 omega5: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = E6_11 * omega5_1 - minus_E6_13 * omega5_3;
  const T omega6_2 = thetadot6 + omega5_2;
  const T omega6_3 = minus_E6_13 * omega5_1 + E6_11 * omega5_3;
  // omega_dot_thetadot1_6 = -thetadot6 b6~ E6 omega_thetadot1_5 + E6 omega_dot_thetadot1_5: its rate
  const T omega_dot_thetadot1_6_1 = E6_11 * omega_dot_thetadot1_5_1 + minus_E6_13 * minus_omega_dot_thetadot1_4_3 -
      thetadot6 * R6_33;
  const T omega_dot_thetadot1_6_3 = thetadot6 * R6_13 + minus_E6_13 * omega_dot_thetadot1_5_1 - E6_11 *
      minus_omega_dot_thetadot1_4_3;
  // omega_thetadot2_6 = E6 omega_thetadot2_5: partial angular velocity, body axes
  const T omega_thetadot2_6_1 = E6_11 * omega_thetadot2_5_1 + minus_E6_13 * minus_omega_thetadot2_4_3;
  const T omega_thetadot2_6_3 = minus_E6_13 * omega_thetadot2_5_1 - E6_11 * minus_omega_thetadot2_4_3;
  // omega_dot_thetadot2_6 = -thetadot6 b6~ E6 omega_thetadot2_5 + E6 omega_dot_thetadot2_5: its rate
  const T omega_dot_thetadot2_6_1 = E6_11 * omega_dot_thetadot2_5_1 + minus_E6_13 * minus_omega_dot_thetadot2_4_3 -
      thetadot6 * omega_thetadot2_6_3;
  const T omega_dot_thetadot2_6_3 = thetadot6 * omega_thetadot2_6_1 + minus_E6_13 * omega_dot_thetadot2_5_1 - E6_11 *
      minus_omega_dot_thetadot2_4_3;
  // omega_thetadot3_6 = E6 omega_thetadot3_5: partial angular velocity, body axes
  const T omega_thetadot3_6_1 = E6_11 * omega_thetadot3_5_1 - minus_E6_13 * E4_11;
  const T omega_thetadot3_6_3 = minus_E6_13 * omega_thetadot3_5_1 + E6_11 * E4_11;
  // omega_dot_thetadot3_6 = -thetadot6 b6~ E6 omega_thetadot3_5 + E6 omega_dot_thetadot3_5: its rate
  const T omega_dot_thetadot3_6_1 = E6_11 * omega_dot_thetadot3_5_1 + minus_E6_13 * minus_omega_dot_thetadot3_4_3 -
      thetadot6 * omega_thetadot3_6_3;
  const T omega_dot_thetadot3_6_3 = thetadot6 * omega_thetadot3_6_1 + minus_E6_13 * omega_dot_thetadot3_5_1 - E6_11 *
      minus_omega_dot_thetadot3_4_3;
  // omega_thetadot4_6 = E6 omega_thetadot4_5: partial angular velocity, body axes
  const T minus_omega_thetadot4_6_1 = E6_11 * E5_12;
  const T minus_omega_thetadot4_6_3 = minus_E6_13 * E5_12;
  // omega_dot_thetadot4_6 = -thetadot6 b6~ E6 omega_thetadot4_5 + E6 omega_dot_thetadot4_5: its rate
  const T omega_dot_thetadot4_6_1 = thetadot6 * minus_omega_thetadot4_6_3 - E6_11 * minus_omega_dot_thetadot4_5_1;
  const T minus_omega_dot_thetadot4_6_3 = thetadot6 * minus_omega_thetadot4_6_1 + minus_E6_13 *
      minus_omega_dot_thetadot4_5_1;
  // omega_dot_thetadot5_6 = -thetadot6 b6~ E6 b5: its rate
  const T minus_omega_dot_thetadot5_6_1 = thetadot6 * E6_11;
  const T minus_omega_dot_thetadot5_6_3 = thetadot6 * minus_E6_13;
  // P_dot_thetadot1_6 = R5^T (-omega5~ q6~ omega_thetadot1_5 - q6~ omega_dot_thetadot1_5) + P_dot_thetadot1_5: its
  //   rate
  const T t6_1 = T(0.2155) * R5_13;
  const T t6_2 = omega5_3 * t6_1 + T(0.2155) * omega_dot_thetadot1_5_2;
  const T t6_3 = T(0.2155) * R5_23;
  const T t6_4 = T(0.2155) * omega_dot_thetadot1_5_1 - omega5_3 * t6_3;
  const T t6_5 = omega5_1 * t6_1 + omega5_2 * t6_3;
  const T minus_P_dot_thetadot1_6_1 = minus_P_dot_thetadot1_5_1 - R5_11 * t6_2 - minus_R5_21 * t6_4 + R4_31 * t6_5;
  const T minus_P_dot_thetadot1_6_2 = minus_P_dot_thetadot1_5_2 + R5_22 * t6_4 - R5_12 * t6_2 + R4_32 * t6_5;
  const T minus_P_dot_thetadot1_6_3 = minus_P_dot_thetadot1_5_3 + R5_23 * t6_4 - R5_13 * t6_2 + R4_33 * t6_5;
  // P_dot_thetadot2_6 = R5^T (-omega5~ q6~ omega_thetadot2_5 - q6~ omega_dot_thetadot2_5) + P_dot_thetadot2_5: its
  //   rate
  const T t6_6 = T(0.2155) * omega_thetadot2_5_1;
  const T t6_7 = T(0.2155) * minus_omega_dot_thetadot2_5_2 - omega5_3 * t6_6;
  const T t6_8 = T(0.2155) * omega_thetadot2_5_2;
  const T t6_9 = T(0.2155) * omega_dot_thetadot2_5_1 - omega5_3 * t6_8;
  const T t6_10 = omega5_1 * t6_6 + omega5_2 * t6_8;
  const T minus_P_dot_thetadot2_6_1 = minus_P_dot_thetadot2_5_1 + R5_11 * t6_7 - minus_R5_21 * t6_9 + R4_31 * t6_10;
  const T minus_P_dot_thetadot2_6_2 = minus_P_dot_thetadot2_5_2 + R5_12 * t6_7 + R5_22 * t6_9 + R4_32 * t6_10;
  const T minus_P_dot_thetadot2_6_3 = minus_P_dot_thetadot2_5_3 + R5_13 * t6_7 + R5_23 * t6_9 + R4_33 * t6_10;
  // P_dot_thetadot3_6 = R5^T (-omega5~ q6~ omega_thetadot3_5 - q6~ omega_dot_thetadot3_5) + P_dot_thetadot3_5: its
  //   rate
  const T t6_11 = T(0.2155) * omega_thetadot3_5_1;
  const T t6_12 = T(0.2155) * minus_omega_dot_thetadot3_5_2 - omega5_3 * t6_11;
  const T t6_13 = T(0.2155) * minus_omega_thetadot3_5_2;
  const T t6_14 = omega5_3 * t6_13 + T(0.2155) * omega_dot_thetadot3_5_1;
  const T t6_15 = omega5_1 * t6_11 - omega5_2 * t6_13;
  const T minus_P_dot_thetadot3_6_1 = minus_P_dot_thetadot3_5_1 + R5_11 * t6_12 - minus_R5_21 * t6_14 + R4_31 * t6_15;
  const T minus_P_dot_thetadot3_6_2 = minus_P_dot_thetadot3_5_2 + R5_12 * t6_12 + R5_22 * t6_14 + R4_32 * t6_15;
  const T minus_P_dot_thetadot3_6_3 = minus_P_dot_thetadot3_5_3 + R5_13 * t6_12 + R5_23 * t6_14 + R4_33 * t6_15;
  // P_dot_thetadot4_6 = R5^T (-omega5~ q6~ omega_thetadot4_5 - q6~ omega_dot_thetadot4_5) + P_dot_thetadot4_5: its
  //   rate
  const T t6_16 = T(0.2155) * E5_12;
  const T t6_17 = omega5_3 * t6_16 - T(0.2155) * omega_dot_thetadot4_5_2;
  const T t6_18 = T(0.2155) * E5_11;
  const T t6_19 = omega5_3 * t6_18 - T(0.2155) * minus_omega_dot_thetadot4_5_1;
  const T t6_20 = omega5_1 * t6_16 + omega5_2 * t6_18;
  const T minus_P_dot_thetadot4_6_1 = R5_11 * t6_17 - P_dot_thetadot4_5_1 - minus_R5_21 * t6_19 - R4_31 * t6_20;
  const T minus_P_dot_thetadot4_6_2 = minus_P_dot_thetadot4_5_2 + R5_12 * t6_17 + R5_22 * t6_19 - R4_32 * t6_20;
  const T minus_P_dot_thetadot4_6_3 = minus_P_dot_thetadot4_5_3 + R5_13 * t6_17 + R5_23 * t6_19 - R4_33 * t6_20;
  // B16_1 = -R6^T omega6~ (C6^T r6)~ omega_thetadot1_6 - R6^T (C6^T r6)~ omega_dot_thetadot1_6 + P_dot_thetadot1_6
  const T t6_21 = T(6e-04) * R6_13;
  const T t6_22 = T(4e-04) * R6_13;
  const T t6_23 = omega6_3 * t6_21 + omega6_2 * t6_22;
  const T t6_24 = T(4e-04) * R6_33 - T(6e-04) * R5_23;
  const T t6_25 = omega6_3 * t6_24 + omega6_1 * t6_22;
  const T t6_26 = omega6_1 * t6_21 - omega6_2 * t6_24;
  const T t6_27 = T(4e-04) * omega_dot_thetadot1_6_3 - T(6e-04) * omega_dot_thetadot1_5_2;
  const T t6_28 = T(6e-04) * omega_dot_thetadot1_6_1;
  const T t6_29 = T(4e-04) * omega_dot_thetadot1_6_1;
  const T minus_B16_1_1 = minus_P_dot_thetadot1_6_1 - R6_11 * t6_23 - minus_R5_21 * t6_25 + R6_31 * t6_26 + R6_11 *
      t6_27 - minus_R5_21 * t6_28 - R6_31 * t6_29;
  const T minus_B16_1_2 = minus_P_dot_thetadot1_6_2 + R5_22 * t6_25 - R6_12 * t6_23 + R6_32 * t6_26 + R6_12 * t6_27 +
      R5_22 * t6_28 - R6_32 * t6_29;
  const T minus_B16_1_3 = minus_P_dot_thetadot1_6_3 + R5_23 * t6_25 - R6_13 * t6_23 + R6_33 * t6_26 + R6_13 * t6_27 +
      R5_23 * t6_28 - R6_33 * t6_29;
  v_y_dot[105] = -minus_B16_1_1;
  v_y_dot[112] = -minus_B16_1_2;
  v_y_dot[119] = -minus_B16_1_3;
  // B17_2 = -R6^T omega6~ (C6^T r6)~ omega_thetadot2_6 - R6^T (C6^T r6)~ omega_dot_thetadot2_6 + P_dot_thetadot2_6
  const T t6_30 = T(6e-04) * omega_thetadot2_6_1;
  const T t6_31 = T(4e-04) * omega_thetadot2_6_1;
  const T t6_32 = omega6_3 * t6_30 + omega6_2 * t6_31;
  const T t6_33 = T(4e-04) * omega_thetadot2_6_3 - T(6e-04) * omega_thetadot2_5_2;
  const T t6_34 = omega6_3 * t6_33 + omega6_1 * t6_31;
  const T t6_35 = omega6_1 * t6_30 - omega6_2 * t6_33;
  const T t6_36 = T(6e-04) * minus_omega_dot_thetadot2_5_2 + T(4e-04) * omega_dot_thetadot2_6_3;
  const T t6_37 = T(6e-04) * omega_dot_thetadot2_6_1;
  const T t6_38 = T(4e-04) * omega_dot_thetadot2_6_1;
  const T minus_B17_2_1 = minus_P_dot_thetadot2_6_1 - R6_11 * t6_32 - minus_R5_21 * t6_34 + R6_31 * t6_35 + R6_11 *
      t6_36 - minus_R5_21 * t6_37 - R6_31 * t6_38;
  const T minus_B17_2_2 = minus_P_dot_thetadot2_6_2 + R5_22 * t6_34 - R6_12 * t6_32 + R6_32 * t6_35 + R6_12 * t6_36 +
      R5_22 * t6_37 - R6_32 * t6_38;
  const T minus_B17_2_3 = minus_P_dot_thetadot2_6_3 + R5_23 * t6_34 - R6_13 * t6_32 + R6_33 * t6_35 + R6_13 * t6_36 +
      R5_23 * t6_37 - R6_33 * t6_38;
  v_y_dot[106] = -minus_B17_2_1;
  v_y_dot[113] = -minus_B17_2_2;
  v_y_dot[120] = -minus_B17_2_3;
  // B18_3 = -R6^T omega6~ (C6^T r6)~ omega_thetadot3_6 - R6^T (C6^T r6)~ omega_dot_thetadot3_6 + P_dot_thetadot3_6
  const T t6_39 = T(6e-04) * omega_thetadot3_6_1;
  const T t6_40 = T(4e-04) * omega_thetadot3_6_1;
  const T t6_41 = omega6_3 * t6_39 + omega6_2 * t6_40;
  const T t6_42 = T(6e-04) * minus_omega_thetadot3_5_2 + T(4e-04) * omega_thetadot3_6_3;
  const T t6_43 = omega6_3 * t6_42 + omega6_1 * t6_40;
  const T t6_44 = omega6_1 * t6_39 - omega6_2 * t6_42;
  const T t6_45 = T(6e-04) * minus_omega_dot_thetadot3_5_2 + T(4e-04) * omega_dot_thetadot3_6_3;
  const T t6_46 = T(6e-04) * omega_dot_thetadot3_6_1;
  const T t6_47 = T(4e-04) * omega_dot_thetadot3_6_1;
  const T minus_B18_3_1 = minus_P_dot_thetadot3_6_1 - R6_11 * t6_41 - minus_R5_21 * t6_43 + R6_31 * t6_44 + R6_11 *
      t6_45 - minus_R5_21 * t6_46 - R6_31 * t6_47;
  const T minus_B18_3_2 = minus_P_dot_thetadot3_6_2 + R5_22 * t6_43 - R6_12 * t6_41 + R6_32 * t6_44 + R6_12 * t6_45 +
      R5_22 * t6_46 - R6_32 * t6_47;
  const T minus_B18_3_3 = minus_P_dot_thetadot3_6_3 + R5_23 * t6_43 - R6_13 * t6_41 + R6_33 * t6_44 + R6_13 * t6_45 +
      R5_23 * t6_46 - R6_33 * t6_47;
  v_y_dot[107] = -minus_B18_3_1;
  v_y_dot[114] = -minus_B18_3_2;
  v_y_dot[121] = -minus_B18_3_3;
  // B19_4 = -R6^T omega6~ (C6^T r6)~ omega_thetadot4_6 - R6^T (C6^T r6)~ omega_dot_thetadot4_6 + P_dot_thetadot4_6
  const T t6_48 = T(6e-04) * minus_omega_thetadot4_6_1;
  const T t6_49 = T(4e-04) * minus_omega_thetadot4_6_1;
  const T t6_50 = omega6_3 * t6_48 + omega6_2 * t6_49;
  const T t6_51 = T(6e-04) * E5_11 - T(4e-04) * minus_omega_thetadot4_6_3;
  const T t6_52 = omega6_3 * t6_51 - omega6_1 * t6_49;
  const T t6_53 = omega6_1 * t6_48 + omega6_2 * t6_51;
  const T t6_54 = T(6e-04) * omega_dot_thetadot4_5_2 + T(4e-04) * minus_omega_dot_thetadot4_6_3;
  const T t6_55 = T(6e-04) * omega_dot_thetadot4_6_1;
  const T t6_56 = T(4e-04) * omega_dot_thetadot4_6_1;
  const T minus_B19_4_1 = minus_P_dot_thetadot4_6_1 + R6_11 * t6_50 - minus_R5_21 * t6_52 - R6_31 * t6_53 - R6_11 *
      t6_54 - minus_R5_21 * t6_55 - R6_31 * t6_56;
  const T minus_B19_4_2 = minus_P_dot_thetadot4_6_2 + R6_12 * t6_50 + R5_22 * t6_52 - R6_32 * t6_53 + R5_22 * t6_55 -
      R6_12 * t6_54 - R6_32 * t6_56;
  const T minus_B19_4_3 = minus_P_dot_thetadot4_6_3 + R6_13 * t6_50 + R5_23 * t6_52 - R6_33 * t6_53 + R5_23 * t6_55 -
      R6_13 * t6_54 - R6_33 * t6_56;
  v_y_dot[108] = -minus_B19_4_1;
  v_y_dot[115] = -minus_B19_4_2;
  v_y_dot[122] = -minus_B19_4_3;
  // B20_5 = -R6^T omega6~ (C6^T r6)~ omega_thetadot5_6 - R6^T (C6^T r6)~ omega_dot_thetadot5_6 + P_dot_thetadot5_6
  const T t6_57 = T(6e-04) * minus_E6_13;
  const T t6_58 = T(4e-04) * minus_E6_13;
  const T t6_59 = omega6_3 * t6_57 + omega6_2 * t6_58;
  const T t6_60 = T(4e-04) * E6_11;
  const T t6_61 = omega6_3 * t6_60 - omega6_1 * t6_58;
  const T t6_62 = omega6_1 * t6_57 + omega6_2 * t6_60;
  const T t6_63 = T(6e-04) * minus_omega_dot_thetadot5_6_1;
  const T t6_64 = T(4e-04) * minus_omega_dot_thetadot5_6_3;
  const T t6_65 = T(4e-04) * minus_omega_dot_thetadot5_6_1;
  const T minus_B20_5_1 = R6_11 * t6_59 - minus_R5_21 * t6_61 - R6_31 * t6_62 + minus_R5_21 * t6_63 - R6_11 * t6_64 +
      R6_31 * t6_65;
  const T minus_B20_5_2 = R6_12 * t6_59 + R5_22 * t6_61 - R6_32 * t6_62 - R6_12 * t6_64 - R5_22 * t6_63 + R6_32 *
      t6_65;
  const T minus_B20_5_3 = R6_13 * t6_59 + R5_23 * t6_61 - R6_33 * t6_62 - R6_13 * t6_64 - R5_23 * t6_63 + R6_33 *
      t6_65;
  v_y_dot[109] = -minus_B20_5_1;
  v_y_dot[116] = -minus_B20_5_2;
  v_y_dot[123] = -minus_B20_5_3;
  // B21_6 = -R6^T omega6~ (C6^T r6)~ b6
  const T t6_66 = omega6_3 * T(6e-04);
  const T t6_67 = omega6_2 * T(6e-04);
  const T minus_B21_6_1 = minus_R5_21 * t6_66 + R6_31 * t6_67;
  const T minus_B21_6_2 = R6_32 * t6_67 - R5_22 * t6_66;
  const T minus_B21_6_3 = R6_33 * t6_67 - R5_23 * t6_66;
  v_y_dot[110] = -minus_B21_6_1;
  v_y_dot[117] = -minus_B21_6_2;
  v_y_dot[124] = -minus_B21_6_3;

  // ---- body 7 (link_7) on body 6
  const T thetadot7 = y[6];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[6];
  const T E7_12 = sines[6];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R6_11 * E7_11 - minus_R5_21 * E7_12;
  const T R7_12 = R6_12 * E7_11 + R5_22 * E7_12;
  const T R7_13 = R6_13 * E7_11 + R5_23 * E7_12;
  const T minus_R7_21 = minus_R5_21 * E7_11 + R6_11 * E7_12;
  const T R7_22 = R5_22 * E7_11 - R6_12 * E7_12;
  const T R7_23 = R5_23 * E7_11 - R6_13 * E7_12;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 + E7_12 * omega6_2;
  const T omega7_2 = E7_11 * omega6_2 - E7_12 * omega6_1;
  const T omega7_3 = thetadot7 + omega6_3;
  // omega_dot_thetadot1_7 = -thetadot7 b7~ E7 omega_thetadot1_6 + E7 omega_dot_thetadot1_6: its rate
  const T omega_dot_thetadot1_7_1 = thetadot7 * R7_23 + E7_11 * omega_dot_thetadot1_6_1 + E7_12 *
      omega_dot_thetadot1_5_2;
  const T omega_dot_thetadot1_7_2 = E7_11 * omega_dot_thetadot1_5_2 - E7_12 * omega_dot_thetadot1_6_1 - thetadot7 *
      R7_13;
  // omega_thetadot2_7 = E7 omega_thetadot2_6: partial angular velocity, body axes
  const T omega_thetadot2_7_1 = E7_11 * omega_thetadot2_6_1 + E7_12 * omega_thetadot2_5_2;
  const T omega_thetadot2_7_2 = E7_11 * omega_thetadot2_5_2 - E7_12 * omega_thetadot2_6_1;
  // omega_dot_thetadot2_7 = -thetadot7 b7~ E7 omega_thetadot2_6 + E7 omega_dot_thetadot2_6: its rate
  const T omega_dot_thetadot2_7_1 = thetadot7 * omega_thetadot2_7_2 + E7_11 * omega_dot_thetadot2_6_1 - E7_12 *
      minus_omega_dot_thetadot2_5_2;
  const T minus_omega_dot_thetadot2_7_2 = thetadot7 * omega_thetadot2_7_1 + E7_11 * minus_omega_dot_thetadot2_5_2 +
      E7_12 * omega_dot_thetadot2_6_1;
  // omega_thetadot3_7 = E7 omega_thetadot3_6: partial angular velocity, body axes
  const T omega_thetadot3_7_1 = E7_11 * omega_thetadot3_6_1 - E7_12 * minus_omega_thetadot3_5_2;
  const T minus_omega_thetadot3_7_2 = E7_11 * minus_omega_thetadot3_5_2 + E7_12 * omega_thetadot3_6_1;
  // omega_dot_thetadot3_7 = -thetadot7 b7~ E7 omega_thetadot3_6 + E7 omega_dot_thetadot3_6: its rate
  const T omega_dot_thetadot3_7_1 = E7_11 * omega_dot_thetadot3_6_1 - E7_12 * minus_omega_dot_thetadot3_5_2 -
      thetadot7 * minus_omega_thetadot3_7_2;
  const T minus_omega_dot_thetadot3_7_2 = thetadot7 * omega_thetadot3_7_1 + E7_11 * minus_omega_dot_thetadot3_5_2 +
      E7_12 * omega_dot_thetadot3_6_1;
  // omega_thetadot4_7 = E7 omega_thetadot4_6: partial angular velocity, body axes
  const T minus_omega_thetadot4_7_1 = E7_11 * minus_omega_thetadot4_6_1 + E7_12 * E5_11;
  const T omega_thetadot4_7_2 = E7_12 * minus_omega_thetadot4_6_1 - E7_11 * E5_11;
  // omega_dot_thetadot4_7 = -thetadot7 b7~ E7 omega_thetadot4_6 + E7 omega_dot_thetadot4_6: its rate
  const T omega_dot_thetadot4_7_1 = thetadot7 * omega_thetadot4_7_2 + E7_11 * omega_dot_thetadot4_6_1 + E7_12 *
      omega_dot_thetadot4_5_2;
  const T omega_dot_thetadot4_7_2 = thetadot7 * minus_omega_thetadot4_7_1 + E7_11 * omega_dot_thetadot4_5_2 - E7_12 *
      omega_dot_thetadot4_6_1;
  // omega_thetadot5_7 = E7 omega_thetadot5_6: partial angular velocity, body axes
  const T minus_omega_thetadot5_7_1 = E7_11 * minus_E6_13;
  const T omega_thetadot5_7_2 = E7_12 * minus_E6_13;
  // omega_dot_thetadot5_7 = -thetadot7 b7~ E7 omega_thetadot5_6 + E7 omega_dot_thetadot5_6: its rate
  const T omega_dot_thetadot5_7_1 = thetadot7 * omega_thetadot5_7_2 - E7_11 * minus_omega_dot_thetadot5_6_1;
  const T omega_dot_thetadot5_7_2 = thetadot7 * minus_omega_thetadot5_7_1 + E7_12 * minus_omega_dot_thetadot5_6_1;
  // omega_dot_thetadot6_7 = -thetadot7 b7~ E7 b6: its rate
  const T omega_dot_thetadot6_7_1 = thetadot7 * E7_11;
  const T minus_omega_dot_thetadot6_7_2 = thetadot7 * E7_12;
  // P_dot_thetadot1_7 = R6^T (-omega6~ q7~ omega_thetadot1_6 - q7~ omega_dot_thetadot1_6) + P_dot_thetadot1_6: its
  //   rate
  const T t7_1 = T(0.081) * R6_13;
  const T t7_2 = omega6_3 * t7_1 + T(0.081) * omega_dot_thetadot1_5_2;
  const T t7_3 = T(0.081) * R5_23;
  const T t7_4 = T(0.081) * omega_dot_thetadot1_6_1 - omega6_3 * t7_3;
  const T t7_5 = omega6_1 * t7_1 + omega6_2 * t7_3;
  const T minus_P_dot_thetadot1_7_1 = minus_P_dot_thetadot1_6_1 - R6_11 * t7_2 - minus_R5_21 * t7_4 + R6_31 * t7_5;
  const T minus_P_dot_thetadot1_7_2 = minus_P_dot_thetadot1_6_2 + R5_22 * t7_4 - R6_12 * t7_2 + R6_32 * t7_5;
  const T minus_P_dot_thetadot1_7_3 = minus_P_dot_thetadot1_6_3 + R5_23 * t7_4 - R6_13 * t7_2 + R6_33 * t7_5;
  // P_dot_thetadot2_7 = R6^T (-omega6~ q7~ omega_thetadot2_6 - q7~ omega_dot_thetadot2_6) + P_dot_thetadot2_6: its
  //   rate
  const T t7_6 = T(0.081) * omega_thetadot2_6_1;
  const T t7_7 = T(0.081) * minus_omega_dot_thetadot2_5_2 - omega6_3 * t7_6;
  const T t7_8 = T(0.081) * omega_thetadot2_5_2;
  const T t7_9 = T(0.081) * omega_dot_thetadot2_6_1 - omega6_3 * t7_8;
  const T t7_10 = omega6_1 * t7_6 + omega6_2 * t7_8;
  const T minus_P_dot_thetadot2_7_1 = minus_P_dot_thetadot2_6_1 + R6_11 * t7_7 - minus_R5_21 * t7_9 + R6_31 * t7_10;
  const T minus_P_dot_thetadot2_7_2 = minus_P_dot_thetadot2_6_2 + R6_12 * t7_7 + R5_22 * t7_9 + R6_32 * t7_10;
  const T minus_P_dot_thetadot2_7_3 = minus_P_dot_thetadot2_6_3 + R6_13 * t7_7 + R5_23 * t7_9 + R6_33 * t7_10;
  // P_dot_thetadot3_7 = R6^T (-omega6~ q7~ omega_thetadot3_6 - q7~ omega_dot_thetadot3_6) + P_dot_thetadot3_6: its
  //   rate
  const T t7_11 = T(0.081) * omega_thetadot3_6_1;
  const T t7_12 = T(0.081) * minus_omega_dot_thetadot3_5_2 - omega6_3 * t7_11;
  const T t7_13 = T(0.081) * minus_omega_thetadot3_5_2;
  const T t7_14 = omega6_3 * t7_13 + T(0.081) * omega_dot_thetadot3_6_1;
  const T t7_15 = omega6_1 * t7_11 - omega6_2 * t7_13;
  const T minus_P_dot_thetadot3_7_1 = minus_P_dot_thetadot3_6_1 + R6_11 * t7_12 - minus_R5_21 * t7_14 + R6_31 * t7_15;
  const T minus_P_dot_thetadot3_7_2 = minus_P_dot_thetadot3_6_2 + R6_12 * t7_12 + R5_22 * t7_14 + R6_32 * t7_15;
  const T minus_P_dot_thetadot3_7_3 = minus_P_dot_thetadot3_6_3 + R6_13 * t7_12 + R5_23 * t7_14 + R6_33 * t7_15;
  // P_dot_thetadot4_7 = R6^T (-omega6~ q7~ omega_thetadot4_6 - q7~ omega_dot_thetadot4_6) + P_dot_thetadot4_6: its
  //   rate
  const T t7_16 = T(0.081) * minus_omega_thetadot4_6_1;
  const T t7_17 = omega6_3 * t7_16 - T(0.081) * omega_dot_thetadot4_5_2;
  const T t7_18 = T(0.081) * E5_11;
  const T t7_19 = omega6_3 * t7_18 + T(0.081) * omega_dot_thetadot4_6_1;
  const T t7_20 = omega6_1 * t7_16 + omega6_2 * t7_18;
  const T minus_P_dot_thetadot4_7_1 = minus_P_dot_thetadot4_6_1 + R6_11 * t7_17 - minus_R5_21 * t7_19 - R6_31 * t7_20;
  const T minus_P_dot_thetadot4_7_2 = minus_P_dot_thetadot4_6_2 + R6_12 * t7_17 + R5_22 * t7_19 - R6_32 * t7_20;
  const T minus_P_dot_thetadot4_7_3 = minus_P_dot_thetadot4_6_3 + R6_13 * t7_17 + R5_23 * t7_19 - R6_33 * t7_20;
  // P_dot_thetadot5_7 = R6^T (-omega6~ q7~ omega_thetadot5_6 - q7~ omega_dot_thetadot5_6) + P_dot_thetadot5_6: its
  //   rate
  const T t7_21 = T(0.081) * minus_E6_13;
  const T t7_22 = omega6_3 * t7_21;
  const T t7_23 = T(0.081) * minus_omega_dot_thetadot5_6_1;
  const T t7_24 = omega6_1 * t7_21;
  const T minus_P_dot_thetadot5_7_1 = R6_11 * t7_22 + minus_R5_21 * t7_23 - R6_31 * t7_24;
  const T minus_P_dot_thetadot5_7_2 = R6_12 * t7_22 - R5_22 * t7_23 - R6_32 * t7_24;
  const T minus_P_dot_thetadot5_7_3 = R6_13 * t7_22 - R5_23 * t7_23 - R6_33 * t7_24;
  // P_dot_thetadot6_7 = -R6^T omega6~ q7~ b6: its rate
  const T t7_25 = omega6_3 * T(0.081);
  const T t7_26 = omega6_2 * T(0.081);
  const T minus_P_dot_thetadot6_7_1 = minus_R5_21 * t7_25 + R6_31 * t7_26;
  const T minus_P_dot_thetadot6_7_2 = R6_32 * t7_26 - R5_22 * t7_25;
  const T minus_P_dot_thetadot6_7_3 = R6_33 * t7_26 - R5_23 * t7_25;
  // B22_1 = -R7^T omega7~ r7~ omega_thetadot1_7 - R7^T r7~ omega_dot_thetadot1_7 + P_dot_thetadot1_7
  const T t7_27 = T(0.02) * R7_23;
  const T t7_28 = omega7_3 * t7_27;
  const T t7_29 = T(0.02) * R7_13;
  const T t7_30 = omega7_3 * t7_29;
  const T t7_31 = omega7_1 * t7_29 + omega7_2 * t7_27;
  const T t7_32 = T(0.02) * omega_dot_thetadot1_7_2;
  const T t7_33 = T(0.02) * omega_dot_thetadot1_7_1;
  const T minus_B22_1_1 = minus_P_dot_thetadot1_7_1 + minus_R7_21 * t7_28 - R7_11 * t7_30 + R6_31 * t7_31 - R7_11 *
      t7_32 - minus_R7_21 * t7_33;
  const T minus_B22_1_2 = minus_P_dot_thetadot1_7_2 - R7_12 * t7_30 - R7_22 * t7_28 + R6_32 * t7_31 + R7_22 * t7_33 -
      R7_12 * t7_32;
  const T minus_B22_1_3 = minus_P_dot_thetadot1_7_3 - R7_13 * t7_30 - R7_23 * t7_28 + R6_33 * t7_31 + R7_23 * t7_33 -
      R7_13 * t7_32;
  v_y_dot[126] = -minus_B22_1_1;
  v_y_dot[133] = -minus_B22_1_2;
  v_y_dot[140] = -minus_B22_1_3;
  // B23_2 = -R7^T omega7~ r7~ omega_thetadot2_7 - R7^T r7~ omega_dot_thetadot2_7 + P_dot_thetadot2_7
  const T t7_34 = T(0.02) * omega_thetadot2_7_2;
  const T t7_35 = omega7_3 * t7_34;
  const T t7_36 = T(0.02) * omega_thetadot2_7_1;
  const T t7_37 = omega7_3 * t7_36;
  const T t7_38 = omega7_1 * t7_36 + omega7_2 * t7_34;
  const T t7_39 = T(0.02) * minus_omega_dot_thetadot2_7_2;
  const T t7_40 = T(0.02) * omega_dot_thetadot2_7_1;
  const T minus_B23_2_1 = minus_P_dot_thetadot2_7_1 + minus_R7_21 * t7_35 - R7_11 * t7_37 + R6_31 * t7_38 + R7_11 *
      t7_39 - minus_R7_21 * t7_40;
  const T minus_B23_2_2 = minus_P_dot_thetadot2_7_2 - R7_12 * t7_37 - R7_22 * t7_35 + R6_32 * t7_38 + R7_12 * t7_39 +
      R7_22 * t7_40;
  const T minus_B23_2_3 = minus_P_dot_thetadot2_7_3 - R7_13 * t7_37 - R7_23 * t7_35 + R6_33 * t7_38 + R7_13 * t7_39 +
      R7_23 * t7_40;
  v_y_dot[127] = -minus_B23_2_1;
  v_y_dot[134] = -minus_B23_2_2;
  v_y_dot[141] = -minus_B23_2_3;
  // B24_3 = -R7^T omega7~ r7~ omega_thetadot3_7 - R7^T r7~ omega_dot_thetadot3_7 + P_dot_thetadot3_7
  const T t7_41 = T(0.02) * omega_thetadot3_7_1;
  const T t7_42 = omega7_3 * t7_41;
  const T t7_43 = T(0.02) * minus_omega_thetadot3_7_2;
  const T t7_44 = omega7_3 * t7_43;
  const T t7_45 = omega7_1 * t7_41 - omega7_2 * t7_43;
  const T t7_46 = T(0.02) * minus_omega_dot_thetadot3_7_2;
  const T t7_47 = T(0.02) * omega_dot_thetadot3_7_1;
  const T minus_B24_3_1 = minus_P_dot_thetadot3_7_1 - R7_11 * t7_42 - minus_R7_21 * t7_44 + R6_31 * t7_45 + R7_11 *
      t7_46 - minus_R7_21 * t7_47;
  const T minus_B24_3_2 = minus_P_dot_thetadot3_7_2 + R7_22 * t7_44 - R7_12 * t7_42 + R6_32 * t7_45 + R7_12 * t7_46 +
      R7_22 * t7_47;
  const T minus_B24_3_3 = minus_P_dot_thetadot3_7_3 + R7_23 * t7_44 - R7_13 * t7_42 + R6_33 * t7_45 + R7_13 * t7_46 +
      R7_23 * t7_47;
  v_y_dot[128] = -minus_B24_3_1;
  v_y_dot[135] = -minus_B24_3_2;
  v_y_dot[142] = -minus_B24_3_3;
  // B25_4 = -R7^T omega7~ r7~ omega_thetadot4_7 - R7^T r7~ omega_dot_thetadot4_7 + P_dot_thetadot4_7
  const T t7_48 = T(0.02) * minus_omega_thetadot4_7_1;
  const T t7_49 = omega7_3 * t7_48;
  const T t7_50 = T(0.02) * omega_thetadot4_7_2;
  const T t7_51 = omega7_3 * t7_50;
  const T t7_52 = omega7_2 * t7_50 - omega7_1 * t7_48;
  const T t7_53 = T(0.02) * omega_dot_thetadot4_7_2;
  const T t7_54 = T(0.02) * omega_dot_thetadot4_7_1;
  const T minus_B25_4_1 = minus_P_dot_thetadot4_7_1 + R7_11 * t7_49 + minus_R7_21 * t7_51 + R6_31 * t7_52 - R7_11 *
      t7_53 - minus_R7_21 * t7_54;
  const T minus_B25_4_2 = minus_P_dot_thetadot4_7_2 + R7_12 * t7_49 - R7_22 * t7_51 + R6_32 * t7_52 + R7_22 * t7_54 -
      R7_12 * t7_53;
  const T minus_B25_4_3 = minus_P_dot_thetadot4_7_3 + R7_13 * t7_49 - R7_23 * t7_51 + R6_33 * t7_52 + R7_23 * t7_54 -
      R7_13 * t7_53;
  v_y_dot[129] = -minus_B25_4_1;
  v_y_dot[136] = -minus_B25_4_2;
  v_y_dot[143] = -minus_B25_4_3;
  // B26_5 = -R7^T omega7~ r7~ omega_thetadot5_7 - R7^T r7~ omega_dot_thetadot5_7 + P_dot_thetadot5_7
  const T t7_55 = T(0.02) * minus_omega_thetadot5_7_1;
  const T t7_56 = omega7_3 * t7_55;
  const T t7_57 = T(0.02) * omega_thetadot5_7_2;
  const T t7_58 = omega7_3 * t7_57;
  const T t7_59 = omega7_2 * t7_57 - omega7_1 * t7_55;
  const T t7_60 = T(0.02) * omega_dot_thetadot5_7_2;
  const T t7_61 = T(0.02) * omega_dot_thetadot5_7_1;
  const T minus_B26_5_1 = minus_P_dot_thetadot5_7_1 + R7_11 * t7_56 + minus_R7_21 * t7_58 + R6_31 * t7_59 - R7_11 *
      t7_60 - minus_R7_21 * t7_61;
  const T minus_B26_5_2 = minus_P_dot_thetadot5_7_2 + R7_12 * t7_56 - R7_22 * t7_58 + R6_32 * t7_59 + R7_22 * t7_61 -
      R7_12 * t7_60;
  const T minus_B26_5_3 = minus_P_dot_thetadot5_7_3 + R7_13 * t7_56 - R7_23 * t7_58 + R6_33 * t7_59 + R7_23 * t7_61 -
      R7_13 * t7_60;
  v_y_dot[130] = -minus_B26_5_1;
  v_y_dot[137] = -minus_B26_5_2;
  v_y_dot[144] = -minus_B26_5_3;
  // B27_6 = -R7^T omega7~ r7~ omega_thetadot6_7 - R7^T r7~ omega_dot_thetadot6_7 + P_dot_thetadot6_7
  const T t7_62 = T(0.02) * E7_11;
  const T t7_63 = omega7_3 * t7_62;
  const T t7_64 = T(0.02) * E7_12;
  const T t7_65 = omega7_3 * t7_64;
  const T t7_66 = omega7_1 * t7_64 + omega7_2 * t7_62;
  const T t7_67 = T(0.02) * minus_omega_dot_thetadot6_7_2;
  const T t7_68 = T(0.02) * omega_dot_thetadot6_7_1;
  const T minus_B27_6_1 = minus_P_dot_thetadot6_7_1 + minus_R7_21 * t7_63 - R7_11 * t7_65 + R6_31 * t7_66 + R7_11 *
      t7_67 - minus_R7_21 * t7_68;
  const T minus_B27_6_2 = minus_P_dot_thetadot6_7_2 - R7_12 * t7_65 - R7_22 * t7_63 + R6_32 * t7_66 + R7_12 * t7_67 +
      R7_22 * t7_68;
  const T minus_B27_6_3 = minus_P_dot_thetadot6_7_3 - R7_13 * t7_65 - R7_23 * t7_63 + R6_33 * t7_66 + R7_13 * t7_67 +
      R7_23 * t7_68;
  v_y_dot[131] = -minus_B27_6_1;
  v_y_dot[138] = -minus_B27_6_2;
  v_y_dot[145] = -minus_B27_6_3;
}

}  // namespace kanec::arm_7
