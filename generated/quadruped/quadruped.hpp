// SPDX-License-Identifier: BSD-3-Clause
// quadruped: equations of motion of 17 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 6fa857b29f0000a5 of quadruped/scene.toml; the usual functions
// bodies and their joints:
//   1 trunk on the inertial frame: free
//   2 fr_hip on 1: revolute
//   3 fr_thigh on 2: revolute
//   4 fr_calf on 3: revolute
//   5 fr_foot on 4: weld
//   6 fl_hip on 1: revolute
//   7 fl_thigh on 6: revolute
//   8 fl_calf on 7: revolute
//   9 fl_foot on 8: weld
//   10 rr_hip on 1: revolute
//   11 rr_thigh on 10: revolute
//   12 rr_calf on 11: revolute
//   13 rr_foot on 12: weld
//   14 rl_hip on 1: revolute
//   15 rl_thigh on 14: revolute
//   16 rl_calf on 15: revolute
//   17 rl_foot on 16: weld
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, theta_2, theta_3, theta_4, theta_6, theta_7, theta_8, theta_10, theta_11, theta_12,
//   theta_14, theta_15, theta_16, s_1_1 .. s_1_3)
//   y = (omega_1_1 .. omega_1_3, thetadot_2, thetadot_3, thetadot_4, thetadot_6, thetadot_7, thetadot_8, thetadot_10,
//   thetadot_11, thetadot_12, thetadot_14, thetadot_15, thetadot_16, sdot_1_1 .. sdot_1_3)
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
//   poses                   530 (239 add, 291 multiply, 24 sine or cosine)
//   energy                  1315 (558 add, 757 multiply, 24 sine or cosine)
//   momentum                1700 (773 add, 927 multiply, 24 sine or cosine)
//   power                   556 (236 add, 320 multiply, 24 sine or cosine)
//   accelerations           3202 (1514 add, 1674 multiply, 14 divide, 24 sine or cosine)
//   residual                1806 (860 add, 946 multiply, 24 sine or cosine)
//   forcing                 1705 (796 add, 909 multiply, 24 sine or cosine)
//   mass_matrix             780 (358 add, 422 multiply, 24 sine or cosine)
//   partial_velocities      1632 (704 add, 928 multiply, 24 sine or cosine)
//   partial_velocity_rates  3687 (1521 add, 2166 multiply, 24 sine or cosine)
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

namespace kanec::quadruped {

inline constexpr int n_bodies = 17;
inline constexpr int nx = 19;
inline constexpr int ny = 18;
inline constexpr int n_parameters = 3;
inline constexpr int n_inputs = 24;
inline constexpr char model_hash[] = "6fa857b29f0000a5";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, theta_2 = 4, theta_3 = 5, theta_4 = 6,
    theta_6 = 7, theta_7 = 8, theta_8 = 9, theta_10 = 10, theta_11 = 11, theta_12 = 12, theta_14 = 13, theta_15 = 14,
    theta_16 = 15, s_1_1 = 16, s_1_2 = 17, s_1_3 = 18;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, thetadot_2 = 3, thetadot_3 = 4, thetadot_4 = 5,
    thetadot_6 = 6, thetadot_7 = 7, thetadot_8 = 8, thetadot_10 = 9, thetadot_11 = 10, thetadot_12 = 11,
    thetadot_14 = 12, thetadot_15 = 13, thetadot_16 = 14, sdot_1_1 = 15, sdot_1_2 = 16, sdot_1_3 = 17;
inline constexpr int eps_trunk_1 = 0, eps_trunk_2 = 1, eps_trunk_3 = 2, eps_trunk_4 = 3, theta_fr_hip = 4,
    theta_fr_thigh = 5, theta_fr_calf = 6, theta_fl_hip = 7, theta_fl_thigh = 8, theta_fl_calf = 9, theta_rr_hip = 10,
    theta_rr_thigh = 11, theta_rr_calf = 12, theta_rl_hip = 13, theta_rl_thigh = 14, theta_rl_calf = 15,
    s_trunk_1 = 16, s_trunk_2 = 17, s_trunk_3 = 18;
inline constexpr int omega_trunk_1 = 0, omega_trunk_2 = 1, omega_trunk_3 = 2, thetadot_fr_hip = 3,
    thetadot_fr_thigh = 4, thetadot_fr_calf = 5, thetadot_fl_hip = 6, thetadot_fl_thigh = 7, thetadot_fl_calf = 8,
    thetadot_rr_hip = 9, thetadot_rr_thigh = 10, thetadot_rr_calf = 11, thetadot_rl_hip = 12, thetadot_rl_thigh = 13,
    thetadot_rl_calf = 14, sdot_trunk_1 = 15, sdot_trunk_2 = 16, sdot_trunk_3 = 17;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 210;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 3, 3,
    4, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 7, 7, 8, 8,
    8, 8, 8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9, 9, 9, 10, 10, 10, 10, 10, 10, 10, 10, 10, 11, 11, 11, 11, 11, 11, 11,
    11, 11, 12, 12, 12, 12, 12, 12, 12, 12, 12, 13, 13, 13, 13, 13, 13, 13, 13, 13, 14, 14, 14, 14, 14, 14, 14, 14,
    14, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 15, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16,
    16, 16, 16, 16, 16, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2,
    3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17,
    0, 1, 2, 3, 4, 5, 15, 16, 17, 0, 1, 2, 3, 4, 5, 15, 16, 17, 0, 1, 2, 3, 4, 5, 15, 16, 17, 0, 1, 2, 6, 7, 8, 15,
    16, 17, 0, 1, 2, 6, 7, 8, 15, 16, 17, 0, 1, 2, 6, 7, 8, 15, 16, 17, 0, 1, 2, 9, 10, 11, 15, 16, 17, 0, 1, 2, 9,
    10, 11, 15, 16, 17, 0, 1, 2, 9, 10, 11, 15, 16, 17, 0, 1, 2, 12, 13, 14, 15, 16, 17, 0, 1, 2, 12, 13, 14, 15, 16,
    17, 0, 1, 2, 12, 13, 14, 15, 16, 17, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 0, 1, 2, 3, 4, 5, 6, 7,
    8, 9, 10, 11, 12, 13, 14, 16, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 17};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T kp = T(80);
  T kd = T(1);
  T m_trunk = T(6);
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
  T tau_fr_hip = T(0);
  T tau_fr_thigh = T(0);
  T tau_fr_calf = T(0);
  T ground_fr_x = T(0);
  T ground_fr_y = T(0);
  T ground_fr_z = T(33.7);
  T tau_fl_hip = T(0);
  T tau_fl_thigh = T(0);
  T tau_fl_calf = T(0);
  T ground_fl_x = T(0);
  T ground_fl_y = T(0);
  T ground_fl_z = T(33.7);
  T tau_rr_hip = T(0);
  T tau_rr_thigh = T(0);
  T tau_rr_calf = T(0);
  T ground_rr_x = T(0);
  T ground_rr_y = T(0);
  T ground_rr_z = T(33.7);
  T tau_rl_hip = T(0);
  T tau_rl_thigh = T(0);
  T tau_rl_calf = T(0);
  T ground_rl_x = T(0);
  T ground_rl_y = T(0);
  T ground_rl_z = T(33.7);
};

// What depends on parameters only, computed once for many calls.
template <class T>
struct Prepared {
  Parameters<T> p;
  T c1_1;
  T c0_1;
  T h_all_1_2;
  T c1_2;
  T J_all_1_23;
  T J_all_1_11;
  T J_all_1_22;
  T J_all_1_33;
  T c1_3;
  T c1_4;
  T c1_5;
  T m_all_1;
  T c1_6;
  T c1_7;
  T c1_8;
  T c1_9;
  T c1_10;
  T c1_11;
};

// prepare: 17 add, 11 multiply
template <class T>
constexpr Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  Prepared<T> c{};
  c.p = p;
  const T c1_1 = T(0.5) * p.m_trunk;
  const T c0_1 = T(0.5) * p.kp;
  const T h_all_1_2 = p.m_trunk * T(0.0041);
  const T c1_2 = p.m_trunk * T(5e-04);
  const T J_all_1_23 = p.m_trunk * T(2.0500000000000003e-06) - T(2.75e-05);
  const T J_all_1_11 = p.m_trunk * T(1.7060000000000003e-05) + T(0.03295096);
  const T t1 = p.m_trunk * T(2.5e-07);
  const T J_all_1_22 = t1 + T(0.28990388342668794);
  const T t2 = p.m_trunk * T(1.6810000000000003e-05);
  const T J_all_1_33 = t2 + T(0.314855843426688);
  const T c1_3 = J_all_1_33 - J_all_1_22;
  const T c1_4 = J_all_1_11 - J_all_1_33;
  const T c1_5 = J_all_1_22 - J_all_1_11;
  const T m_all_1 = p.m_trunk + T(7.739999999999999);
  const T t3 = t1 + T(0.28990388342668794);
  const T c1_6 = J_all_1_11 - t3;
  const T t4 = t2 + T(0.314855843426688);
  const T c1_7 = T(0.5) * (t4 - c1_6);
  const T c1_8 = T(0.5) * (t4 + c1_6);
  const T c1_9 = T(0.5) * (J_all_1_11 + t3 - t4);
  const T c1_10 = t4 - t3;
  const T c1_11 = J_all_1_11 - t4;
  c.c1_1 = c1_1;
  c.c0_1 = c0_1;
  c.h_all_1_2 = h_all_1_2;
  c.c1_2 = c1_2;
  c.J_all_1_23 = J_all_1_23;
  c.J_all_1_11 = J_all_1_11;
  c.J_all_1_22 = J_all_1_22;
  c.J_all_1_33 = J_all_1_33;
  c.c1_3 = c1_3;
  c.c1_4 = c1_4;
  c.c1_5 = c1_5;
  c.m_all_1 = m_all_1;
  c.c1_6 = c1_6;
  c.c1_7 = c1_7;
  c.c1_8 = c1_8;
  c.c1_9 = c1_9;
  c.c1_10 = c1_10;
  c.c1_11 = c1_11;
  return c;
}

// kinematics: xdot, the kinematical equations.
// rates of x (nx) [1/s], [rad/s], [m/s]
// 8 add, 15 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* xdot) noexcept {

  // ---- body 1 (trunk) on the inertial frame
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
  const T thetadot6 = y[6];
  const T thetadot7 = y[7];
  const T thetadot8 = y[8];
  const T thetadot10 = y[9];
  const T thetadot11 = y[10];
  const T thetadot12 = y[11];
  const T thetadot14 = y[12];
  const T thetadot15 = y[13];
  const T thetadot16 = y[14];
  const T sdot1_1 = y[15], sdot1_2 = y[16], sdot1_3 = y[17];
  xdot[4] = thetadot2;
  xdot[5] = thetadot3;
  xdot[6] = thetadot4;
  xdot[7] = thetadot6;
  xdot[8] = thetadot7;
  xdot[9] = thetadot8;
  xdot[10] = thetadot10;
  xdot[11] = thetadot11;
  xdot[12] = thetadot12;
  xdot[13] = thetadot14;
  xdot[14] = thetadot15;
  xdot[15] = thetadot16;
  xdot[16] = sdot1_1;
  xdot[17] = sdot1_2;
  xdot[18] = sdot1_3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 239 add, 291 multiply, 24 sine or cosine
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[16], s1_2 = x[17], s1_3 = x[18];
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
  pose[60] = R1_11;
  pose[108] = R1_11;
  pose[156] = R1_11;
  pose[1] = R1_12;
  pose[13] = R1_12;
  pose[61] = R1_12;
  pose[109] = R1_12;
  pose[157] = R1_12;
  pose[2] = R1_13;
  pose[14] = R1_13;
  pose[62] = R1_13;
  pose[110] = R1_13;
  pose[158] = R1_13;
  pose[3] = R1_21;
  pose[4] = R1_22;
  pose[5] = R1_23;
  pose[6] = R1_31;
  pose[7] = R1_32;
  pose[8] = R1_33;
  // p1 = s1 + R1^T r1: position of the mass centre, inertial axes [m]
  const T p1_1 = s1_1 + R1_21 * T(0.0041) - R1_31 * T(5e-04);
  const T p1_2 = s1_2 + R1_22 * T(0.0041) - R1_32 * T(5e-04);
  const T p1_3 = s1_3 + R1_23 * T(0.0041) - R1_33 * T(5e-04);
  pose[9] = p1_1;
  pose[10] = p1_2;
  pose[11] = p1_3;

  // ---- body 2 (fr_hip) on body 1
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
  pose[27] = R2_21;
  pose[39] = R2_21;
  pose[51] = R2_21;
  pose[16] = R2_22;
  pose[28] = R2_22;
  pose[40] = R2_22;
  pose[52] = R2_22;
  pose[17] = R2_23;
  pose[29] = R2_23;
  pose[41] = R2_23;
  pose[53] = R2_23;
  pose[18] = R2_31;
  pose[19] = R2_32;
  pose[20] = R2_33;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_1 = R1_11 * T(0.1805);
  const T t2_2 = R1_21 * T(0.047);
  const T t2_3 = t2_1 - t2_2;
  const T P2_1 = s1_1 + t2_3;
  const T t2_4 = R1_12 * T(0.1805);
  const T t2_5 = R1_22 * T(0.047);
  const T t2_6 = t2_4 - t2_5;
  const T P2_2 = s1_2 + t2_6;
  const T t2_7 = R1_13 * T(0.1805);
  const T t2_8 = R1_23 * T(0.047);
  const T t2_9 = t2_7 - t2_8;
  const T P2_3 = s1_3 + t2_9;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_10 = R1_11 * T(0.003311);
  const T p2_1 = P2_1 - t2_10 - R2_21 * T(0.000635) + R2_31 * T(3.1e-05);
  const T t2_11 = R1_12 * T(0.003311);
  const T p2_2 = P2_2 - t2_11 - R2_22 * T(0.000635) + R2_32 * T(3.1e-05);
  const T t2_12 = R1_13 * T(0.003311);
  const T p2_3 = P2_3 - t2_12 - R2_23 * T(0.000635) + R2_33 * T(3.1e-05);
  pose[21] = p2_1;
  pose[22] = p2_2;
  pose[23] = p2_3;

  // ---- body 3 (fr_thigh) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 - R2_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 - R2_33 * minus_E3_13;
  const T R3_31 = R1_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R1_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = R1_13 * minus_E3_13 + R2_33 * E3_11;
  pose[24] = R3_11;
  pose[25] = R3_12;
  pose[26] = R3_13;
  pose[30] = R3_31;
  pose[31] = R3_32;
  pose[32] = R3_33;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 - R2_21 * T(0.0838);
  const T P3_2 = P2_2 - R2_22 * T(0.0838);
  const T P3_3 = P2_3 - R2_23 * T(0.0838);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 + R2_21 * T(0.022327) - R3_11 * T(0.003237) - R3_31 * T(0.027326);
  const T p3_2 = P3_2 + R2_22 * T(0.022327) - R3_12 * T(0.003237) - R3_32 * T(0.027326);
  const T p3_3 = P3_3 + R2_23 * T(0.022327) - R3_13 * T(0.003237) - R3_33 * T(0.027326);
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (fr_calf) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - R3_31 * minus_E4_13;
  const T R4_12 = R3_12 * E4_11 - R3_32 * minus_E4_13;
  const T R4_13 = R3_13 * E4_11 - R3_33 * minus_E4_13;
  const T R4_31 = R3_11 * minus_E4_13 + R3_31 * E4_11;
  const T R4_32 = R3_12 * minus_E4_13 + R3_32 * E4_11;
  const T R4_33 = R3_13 * minus_E4_13 + R3_33 * E4_11;
  pose[36] = R4_11;
  pose[48] = R4_11;
  pose[37] = R4_12;
  pose[49] = R4_12;
  pose[38] = R4_13;
  pose[50] = R4_13;
  pose[42] = R4_31;
  pose[54] = R4_31;
  pose[43] = R4_32;
  pose[55] = R4_32;
  pose[44] = R4_33;
  pose[56] = R4_33;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = P3_1 - R3_31 * T(0.2);
  const T P4_2 = P3_2 - R3_32 * T(0.2);
  const T P4_3 = P3_3 - R3_33 * T(0.2);

  // ---- body 6 (fl_hip) on body 1
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];
  // R6^T = R1^T E6^T: R takes inertial components to body components
  const T R6_21 = R1_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R1_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R1_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R1_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R1_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R1_23 * E6_23;
  pose[63] = R6_21;
  pose[75] = R6_21;
  pose[87] = R6_21;
  pose[99] = R6_21;
  pose[64] = R6_22;
  pose[76] = R6_22;
  pose[88] = R6_22;
  pose[100] = R6_22;
  pose[65] = R6_23;
  pose[77] = R6_23;
  pose[89] = R6_23;
  pose[101] = R6_23;
  pose[66] = R6_31;
  pose[67] = R6_32;
  pose[68] = R6_33;
  // P6 = s1 + R1^T q6: position of the body origin, inertial axes [m]
  const T t6_1 = t2_1 + t2_2;
  const T P6_1 = s1_1 + t6_1;
  const T t6_2 = t2_4 + t2_5;
  const T P6_2 = s1_2 + t6_2;
  const T t6_3 = t2_7 + t2_8;
  const T P6_3 = s1_3 + t6_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = P6_1 - t2_10 + R6_21 * T(0.000635) + R6_31 * T(3.1e-05);
  const T p6_2 = P6_2 - t2_11 + R6_22 * T(0.000635) + R6_32 * T(3.1e-05);
  const T p6_3 = P6_3 - t2_12 + R6_23 * T(0.000635) + R6_33 * T(3.1e-05);
  pose[69] = p6_1;
  pose[70] = p6_2;
  pose[71] = p6_3;

  // ---- body 7 (fl_thigh) on body 6
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R1_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R1_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R1_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R1_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R1_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R1_13 * minus_E7_13 + R6_33 * E7_11;
  pose[72] = R7_11;
  pose[73] = R7_12;
  pose[74] = R7_13;
  pose[78] = R7_31;
  pose[79] = R7_32;
  pose[80] = R7_33;
  // P7 = R6^T q7 + P6: position of the body origin, inertial axes [m]
  const T P7_1 = P6_1 + R6_21 * T(0.0838);
  const T P7_2 = P6_2 + R6_22 * T(0.0838);
  const T P7_3 = P6_3 + R6_23 * T(0.0838);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_1 = P7_1 - R7_11 * T(0.003237) - R6_21 * T(0.022327) - R7_31 * T(0.027326);
  const T p7_2 = P7_2 - R7_12 * T(0.003237) - R6_22 * T(0.022327) - R7_32 * T(0.027326);
  const T p7_3 = P7_3 - R7_13 * T(0.003237) - R6_23 * T(0.022327) - R7_33 * T(0.027326);
  pose[81] = p7_1;
  pose[82] = p7_2;
  pose[83] = p7_3;

  // ---- body 8 (fl_calf) on body 7
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[9];
  const T minus_E8_13 = sines[9];
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T R8_11 = R7_11 * E8_11 - R7_31 * minus_E8_13;
  const T R8_12 = R7_12 * E8_11 - R7_32 * minus_E8_13;
  const T R8_13 = R7_13 * E8_11 - R7_33 * minus_E8_13;
  const T R8_31 = R7_11 * minus_E8_13 + R7_31 * E8_11;
  const T R8_32 = R7_12 * minus_E8_13 + R7_32 * E8_11;
  const T R8_33 = R7_13 * minus_E8_13 + R7_33 * E8_11;
  pose[84] = R8_11;
  pose[96] = R8_11;
  pose[85] = R8_12;
  pose[97] = R8_12;
  pose[86] = R8_13;
  pose[98] = R8_13;
  pose[90] = R8_31;
  pose[102] = R8_31;
  pose[91] = R8_32;
  pose[103] = R8_32;
  pose[92] = R8_33;
  pose[104] = R8_33;
  // P8 = R7^T q8 + P7: position of the body origin, inertial axes [m]
  const T P8_1 = P7_1 - R7_31 * T(0.2);
  const T P8_2 = P7_2 - R7_32 * T(0.2);
  const T P8_3 = P7_3 - R7_33 * T(0.2);

  // ---- body 10 (rr_hip) on body 1
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];
  // R10^T = R1^T E10^T: R takes inertial components to body components
  const T R10_21 = R1_21 * E10_22 + R1_31 * E10_23;
  const T R10_22 = R1_22 * E10_22 + R1_32 * E10_23;
  const T R10_23 = R1_23 * E10_22 + R1_33 * E10_23;
  const T R10_31 = R1_31 * E10_22 - R1_21 * E10_23;
  const T R10_32 = R1_32 * E10_22 - R1_22 * E10_23;
  const T R10_33 = R1_33 * E10_22 - R1_23 * E10_23;
  pose[111] = R10_21;
  pose[123] = R10_21;
  pose[135] = R10_21;
  pose[147] = R10_21;
  pose[112] = R10_22;
  pose[124] = R10_22;
  pose[136] = R10_22;
  pose[148] = R10_22;
  pose[113] = R10_23;
  pose[125] = R10_23;
  pose[137] = R10_23;
  pose[149] = R10_23;
  pose[114] = R10_31;
  pose[115] = R10_32;
  pose[116] = R10_33;
  // P10 = s1 + R1^T q10: position of the body origin, inertial axes [m]
  const T P10_1 = s1_1 - t6_1;
  const T P10_2 = s1_2 - t6_2;
  const T P10_3 = s1_3 - t6_3;
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_1 = t2_10 + P10_1 - R10_21 * T(0.000635) + R10_31 * T(3.1e-05);
  const T p10_2 = t2_11 + P10_2 - R10_22 * T(0.000635) + R10_32 * T(3.1e-05);
  const T p10_3 = t2_12 + P10_3 - R10_23 * T(0.000635) + R10_33 * T(3.1e-05);
  pose[117] = p10_1;
  pose[118] = p10_2;
  pose[119] = p10_3;

  // ---- body 11 (rr_thigh) on body 10
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R1_11 * E11_11 - R10_31 * minus_E11_13;
  const T R11_12 = R1_12 * E11_11 - R10_32 * minus_E11_13;
  const T R11_13 = R1_13 * E11_11 - R10_33 * minus_E11_13;
  const T R11_31 = R1_11 * minus_E11_13 + R10_31 * E11_11;
  const T R11_32 = R1_12 * minus_E11_13 + R10_32 * E11_11;
  const T R11_33 = R1_13 * minus_E11_13 + R10_33 * E11_11;
  pose[120] = R11_11;
  pose[121] = R11_12;
  pose[122] = R11_13;
  pose[126] = R11_31;
  pose[127] = R11_32;
  pose[128] = R11_33;
  // P11 = R10^T q11 + P10: position of the body origin, inertial axes [m]
  const T P11_1 = P10_1 - R10_21 * T(0.0838);
  const T P11_2 = P10_2 - R10_22 * T(0.0838);
  const T P11_3 = P10_3 - R10_23 * T(0.0838);
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T p11_1 = P11_1 + R10_21 * T(0.022327) - R11_11 * T(0.003237) - R11_31 * T(0.027326);
  const T p11_2 = P11_2 + R10_22 * T(0.022327) - R11_12 * T(0.003237) - R11_32 * T(0.027326);
  const T p11_3 = P11_3 + R10_23 * T(0.022327) - R11_13 * T(0.003237) - R11_33 * T(0.027326);
  pose[129] = p11_1;
  pose[130] = p11_2;
  pose[131] = p11_3;

  // ---- body 12 (rr_calf) on body 11
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_11 = cosines[12];
  const T minus_E12_13 = sines[12];
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T R12_11 = R11_11 * E12_11 - R11_31 * minus_E12_13;
  const T R12_12 = R11_12 * E12_11 - R11_32 * minus_E12_13;
  const T R12_13 = R11_13 * E12_11 - R11_33 * minus_E12_13;
  const T R12_31 = R11_11 * minus_E12_13 + R11_31 * E12_11;
  const T R12_32 = R11_12 * minus_E12_13 + R11_32 * E12_11;
  const T R12_33 = R11_13 * minus_E12_13 + R11_33 * E12_11;
  pose[132] = R12_11;
  pose[144] = R12_11;
  pose[133] = R12_12;
  pose[145] = R12_12;
  pose[134] = R12_13;
  pose[146] = R12_13;
  pose[138] = R12_31;
  pose[150] = R12_31;
  pose[139] = R12_32;
  pose[151] = R12_32;
  pose[140] = R12_33;
  pose[152] = R12_33;
  // P12 = R11^T q12 + P11: position of the body origin, inertial axes [m]
  const T P12_1 = P11_1 - R11_31 * T(0.2);
  const T P12_2 = P11_2 - R11_32 * T(0.2);
  const T P12_3 = P11_3 - R11_33 * T(0.2);

  // ---- body 14 (rl_hip) on body 1
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];
  // R14^T = R1^T E14^T: R takes inertial components to body components
  const T R14_21 = R1_21 * E14_22 + R1_31 * E14_23;
  const T R14_22 = R1_22 * E14_22 + R1_32 * E14_23;
  const T R14_23 = R1_23 * E14_22 + R1_33 * E14_23;
  const T R14_31 = R1_31 * E14_22 - R1_21 * E14_23;
  const T R14_32 = R1_32 * E14_22 - R1_22 * E14_23;
  const T R14_33 = R1_33 * E14_22 - R1_23 * E14_23;
  pose[159] = R14_21;
  pose[171] = R14_21;
  pose[183] = R14_21;
  pose[195] = R14_21;
  pose[160] = R14_22;
  pose[172] = R14_22;
  pose[184] = R14_22;
  pose[196] = R14_22;
  pose[161] = R14_23;
  pose[173] = R14_23;
  pose[185] = R14_23;
  pose[197] = R14_23;
  pose[162] = R14_31;
  pose[163] = R14_32;
  pose[164] = R14_33;
  // P14 = s1 + R1^T q14: position of the body origin, inertial axes [m]
  const T P14_1 = s1_1 - t2_3;
  const T P14_2 = s1_2 - t2_6;
  const T P14_3 = s1_3 - t2_9;
  // p14 = R14^T r14 + P14: position of the mass centre, inertial axes [m]
  const T p14_1 = t2_10 + P14_1 + R14_21 * T(0.000635) + R14_31 * T(3.1e-05);
  const T p14_2 = t2_11 + P14_2 + R14_22 * T(0.000635) + R14_32 * T(3.1e-05);
  const T p14_3 = t2_12 + P14_3 + R14_23 * T(0.000635) + R14_33 * T(3.1e-05);
  pose[165] = p14_1;
  pose[166] = p14_2;
  pose[167] = p14_3;

  // ---- body 15 (rl_thigh) on body 14
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_11 = R1_11 * E15_11 - R14_31 * minus_E15_13;
  const T R15_12 = R1_12 * E15_11 - R14_32 * minus_E15_13;
  const T R15_13 = R1_13 * E15_11 - R14_33 * minus_E15_13;
  const T R15_31 = R1_11 * minus_E15_13 + R14_31 * E15_11;
  const T R15_32 = R1_12 * minus_E15_13 + R14_32 * E15_11;
  const T R15_33 = R1_13 * minus_E15_13 + R14_33 * E15_11;
  pose[168] = R15_11;
  pose[169] = R15_12;
  pose[170] = R15_13;
  pose[174] = R15_31;
  pose[175] = R15_32;
  pose[176] = R15_33;
  // P15 = R14^T q15 + P14: position of the body origin, inertial axes [m]
  const T P15_1 = P14_1 + R14_21 * T(0.0838);
  const T P15_2 = P14_2 + R14_22 * T(0.0838);
  const T P15_3 = P14_3 + R14_23 * T(0.0838);
  // p15 = R15^T r15 + P15: position of the mass centre, inertial axes [m]
  const T p15_1 = P15_1 - R15_11 * T(0.003237) - R14_21 * T(0.022327) - R15_31 * T(0.027326);
  const T p15_2 = P15_2 - R15_12 * T(0.003237) - R14_22 * T(0.022327) - R15_32 * T(0.027326);
  const T p15_3 = P15_3 - R15_13 * T(0.003237) - R14_23 * T(0.022327) - R15_33 * T(0.027326);
  pose[177] = p15_1;
  pose[178] = p15_2;
  pose[179] = p15_3;

  // ---- body 16 (rl_calf) on body 15
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cosines[15];
  const T minus_E16_13 = sines[15];
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T R16_11 = R15_11 * E16_11 - R15_31 * minus_E16_13;
  const T R16_12 = R15_12 * E16_11 - R15_32 * minus_E16_13;
  const T R16_13 = R15_13 * E16_11 - R15_33 * minus_E16_13;
  const T R16_31 = R15_11 * minus_E16_13 + R15_31 * E16_11;
  const T R16_32 = R15_12 * minus_E16_13 + R15_32 * E16_11;
  const T R16_33 = R15_13 * minus_E16_13 + R15_33 * E16_11;
  pose[180] = R16_11;
  pose[192] = R16_11;
  pose[181] = R16_12;
  pose[193] = R16_12;
  pose[182] = R16_13;
  pose[194] = R16_13;
  pose[186] = R16_31;
  pose[198] = R16_31;
  pose[187] = R16_32;
  pose[199] = R16_32;
  pose[188] = R16_33;
  pose[200] = R16_33;
  // P16 = R15^T q16 + P15: position of the body origin, inertial axes [m]
  const T P16_1 = P15_1 - R15_31 * T(0.2);
  const T P16_2 = P15_2 - R15_32 * T(0.2);
  const T P16_3 = P15_3 - R15_33 * T(0.2);

  // ---- results
  pose[45] = P4_1 + R4_11 * T(0.006435) - R4_31 * T(0.107388);
  pose[46] = P4_2 + R4_12 * T(0.006435) - R4_32 * T(0.107388);
  pose[47] = P4_3 + R4_13 * T(0.006435) - R4_33 * T(0.107388);
  pose[57] = P4_1 - R4_31 * T(0.2);
  pose[58] = P4_2 - R4_32 * T(0.2);
  pose[59] = P4_3 - R4_33 * T(0.2);
  pose[93] = P8_1 + R8_11 * T(0.006435) - R8_31 * T(0.107388);
  pose[94] = P8_2 + R8_12 * T(0.006435) - R8_32 * T(0.107388);
  pose[95] = P8_3 + R8_13 * T(0.006435) - R8_33 * T(0.107388);
  pose[105] = P8_1 - R8_31 * T(0.2);
  pose[106] = P8_2 - R8_32 * T(0.2);
  pose[107] = P8_3 - R8_33 * T(0.2);
  pose[141] = P12_1 + R12_11 * T(0.006435) - R12_31 * T(0.107388);
  pose[142] = P12_2 + R12_12 * T(0.006435) - R12_32 * T(0.107388);
  pose[143] = P12_3 + R12_13 * T(0.006435) - R12_33 * T(0.107388);
  pose[153] = P12_1 - R12_31 * T(0.2);
  pose[154] = P12_2 - R12_32 * T(0.2);
  pose[155] = P12_3 - R12_33 * T(0.2);
  pose[189] = P16_1 + R16_11 * T(0.006435) - R16_31 * T(0.107388);
  pose[190] = P16_2 + R16_12 * T(0.006435) - R16_32 * T(0.107388);
  pose[191] = P16_3 + R16_13 * T(0.006435) - R16_33 * T(0.107388);
  pose[201] = P16_1 - R16_31 * T(0.2);
  pose[202] = P16_2 - R16_32 * T(0.2);
  pose[203] = P16_3 - R16_33 * T(0.2);
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 558 add, 757 multiply, 24 sine or cosine
template <class T>
void energy(const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_3 = x[18];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[15], sdot1_2 = y[16], sdot1_3 = y[17];
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
  const T p1_3 = s1_3 + R1_23 * T(0.0041) - R1_33 * T(5e-04);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_1 * T(5e-04);
  const T t1_14 = omega1_3 * T(0.0041) + omega1_2 * T(5e-04);
  const T t1_15 = omega1_1 * T(0.0041);
  const T v1_1 = sdot1_1 + R1_21 * t1_13 - R1_11 * t1_14 + R1_31 * t1_15;
  const T v1_2 = sdot1_2 + R1_22 * t1_13 - R1_12 * t1_14 + R1_32 * t1_15;
  const T v1_3 = sdot1_3 + R1_23 * t1_13 - R1_13 * t1_14 + R1_33 * t1_15;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.5) * (omega1_1 * (T(0.0158533) * omega1_1 - T(3.66e-05) * omega1_2 - T(6.11e-05) * omega1_3) +
      omega1_2 * (T(0.0377999) * omega1_2 - T(3.66e-05) * omega1_1 - T(2.75e-05) * omega1_3) + omega1_3 *
      (T(0.0456542) * omega1_3 - (T(6.11e-05) * omega1_1 + T(2.75e-05) * omega1_2))) + c.c1_1 * (v1_1 * v1_1 + v1_2 *
      v1_2 + v1_3 * v1_3);

  // ---- body 2 (fr_hip) on body 1
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
  const T t2_1 = R1_13 * T(0.1805);
  const T t2_2 = R1_23 * T(0.047);
  const T t2_3 = t2_1 - t2_2;
  const T P2_3 = s1_3 + t2_3;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_4 = R1_13 * T(0.003311);
  const T p2_3 = P2_3 - t2_4 - R2_23 * T(0.000635) + R2_33 * T(3.1e-05);
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_5 = omega1_3 * T(0.047);
  const T t2_6 = R1_11 * t2_5;
  const T t2_7 = omega1_3 * T(0.1805);
  const T t2_8 = R1_21 * t2_7;
  const T t2_9 = omega1_1 * T(0.047);
  const T t2_10 = omega1_2 * T(0.1805);
  const T t2_11 = t2_9 + t2_10;
  const T t2_12 = t2_6 + t2_8 - R1_31 * t2_11;
  const T Pdot2_1 = sdot1_1 + t2_12;
  const T t2_13 = R1_12 * t2_5;
  const T t2_14 = R1_22 * t2_7;
  const T t2_15 = t2_13 + t2_14 - R1_32 * t2_11;
  const T Pdot2_2 = sdot1_2 + t2_15;
  const T t2_16 = R1_13 * t2_5;
  const T t2_17 = R1_23 * t2_7;
  const T t2_18 = t2_16 + t2_17 - R1_33 * t2_11;
  const T Pdot2_3 = sdot1_3 + t2_18;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_19 = omega2_3 * T(0.000635) + omega2_2 * T(3.1e-05);
  const T t2_20 = omega2_3 * T(0.003311) + omega2_1 * T(3.1e-05);
  const T t2_21 = omega2_2 * T(0.003311) - omega2_1 * T(0.000635);
  const T v2_1 = Pdot2_1 + R1_11 * t2_19 - R2_21 * t2_20 + R2_31 * t2_21;
  const T v2_2 = Pdot2_2 + R1_12 * t2_19 - R2_22 * t2_20 + R2_32 * t2_21;
  const T v2_3 = Pdot2_3 + R1_13 * t2_19 - R2_23 * t2_20 + R2_33 * t2_21;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (omega2_1 * (T(0.000469246) * omega2_1 + T(9.409e-06) * omega2_2 - T(3.42e-07) * omega2_3) +
      omega2_2 * (T(9.409e-06) * omega2_1 + T(0.00080749) * omega2_2 + T(4.66e-07) * omega2_3) + omega2_3 *
      (T(4.66e-07) * omega2_2 - T(3.42e-07) * omega2_1 + T(0.000552929) * omega2_3)) + T(0.348) * (v2_1 * v2_1 + v2_2
      * v2_2 + v2_3 * v2_3);

  // ---- body 3 (fr_thigh) on body 2
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 - R2_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 - R2_33 * minus_E3_13;
  const T R3_31 = R1_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R1_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = R1_13 * minus_E3_13 + R2_33 * E3_11;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega2_1 - minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + omega2_2;
  const T omega3_3 = minus_E3_13 * omega2_1 + E3_11 * omega2_3;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_3 = P2_3 - R2_23 * T(0.0838);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_3 = P3_3 + R2_23 * T(0.022327) - R3_13 * T(0.003237) - R3_33 * T(0.027326);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_1 = omega2_3 * T(0.0838);
  const T t3_2 = omega2_1 * T(0.0838);
  const T Pdot3_1 = Pdot2_1 + R1_11 * t3_1 - R2_31 * t3_2;
  const T Pdot3_2 = Pdot2_2 + R1_12 * t3_1 - R2_32 * t3_2;
  const T Pdot3_3 = Pdot2_3 + R1_13 * t3_1 - R2_33 * t3_2;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_3 = omega3_1 * T(0.027326) - omega3_3 * T(0.003237);
  const T t3_4 = omega3_3 * T(0.022327) + omega3_2 * T(0.027326);
  const T t3_5 = omega3_1 * T(0.022327) + omega3_2 * T(0.003237);
  const T v3_1 = Pdot3_1 + R2_21 * t3_3 - R3_11 * t3_4 + R3_31 * t3_5;
  const T v3_2 = Pdot3_2 + R2_22 * t3_3 - R3_12 * t3_4 + R3_32 * t3_5;
  const T v3_3 = Pdot3_3 + R2_23 * t3_3 - R3_13 * t3_4 + R3_33 * t3_5;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T T3 = T(0.5) * (omega3_1 * (T(0.005529065) * omega3_1 - T(4.825e-06) * omega3_2 + T(0.000343869) * omega3_3)
      + omega3_2 * (T(0.005139339) * omega3_2 - T(4.825e-06) * omega3_1 - T(2.2448e-05) * omega3_3) + omega3_3 *
      (T(0.000343869) * omega3_1 - T(2.2448e-05) * omega3_2 + T(0.001367788) * omega3_3)) + T(0.5065) * (v3_1 * v3_1 +
      v3_2 * v3_2 + v3_3 * v3_3);
  // stretch_fr_thigh_3 = theta3 - l_fr_thigh_: stretch of the spring
  const T stretch_fr_thigh_3 = theta3 - T(0.8);

  // ---- body 4 (fr_calf) on body 3
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - R3_31 * minus_E4_13;
  const T R4_12 = R3_12 * E4_11 - R3_32 * minus_E4_13;
  const T R4_13 = R3_13 * E4_11 - R3_33 * minus_E4_13;
  const T R4_31 = R3_11 * minus_E4_13 + R3_31 * E4_11;
  const T R4_32 = R3_12 * minus_E4_13 + R3_32 * E4_11;
  const T R4_33 = R3_13 * minus_E4_13 + R3_33 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 - minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  const T omega4_3 = minus_E4_13 * omega3_1 + E4_11 * omega3_3;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_3 = P3_3 - R3_33 * T(0.2);
  // p4 = R4^T r_link4 + P4: position of the mass centre, inertial axes [m]
  const T p4_3 = P4_3 + R4_13 * T(0.004726592920353982) - R4_33 * T(0.13197525663716814);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_1 = omega3_1 * T(0.2);
  const T t4_2 = omega3_2 * T(0.2);
  const T Pdot4_1 = Pdot3_1 + R2_21 * t4_1 - R3_11 * t4_2;
  const T Pdot4_2 = Pdot3_2 + R2_22 * t4_1 - R3_12 * t4_2;
  const T Pdot4_3 = Pdot3_3 + R2_23 * t4_1 - R3_13 * t4_2;
  // v4 = R4^T omega4~ r_link4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_3 = omega4_3 * T(0.004726592920353982) + omega4_1 * T(0.13197525663716814);
  const T t4_4 = omega4_2 * T(0.13197525663716814);
  const T t4_5 = omega4_2 * T(0.004726592920353982);
  const T v4_1 = Pdot4_1 + R2_21 * t4_3 - R4_11 * t4_4 - R4_31 * t4_5;
  const T v4_2 = Pdot4_2 + R2_22 * t4_3 - R4_12 * t4_4 - R4_32 * t4_5;
  const T v4_3 = Pdot4_3 + R2_23 * t4_3 - R4_13 * t4_4 - R4_33 * t4_5;
  // T4 = 1/2 omega4 . (I_link4 omega4) + 1/2 m_link4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (omega4_1 * (T(0.003385566451939115) * omega4_1 - T(0.00016742735341238938) * omega4_3) +
      T(0.003403441389465664) * omega4_2 * omega4_2 + omega4_3 * (T(4.385093752654867e-05) * omega4_3 -
      T(0.00016742735341238938) * omega4_1)) + T(0.113) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);
  // stretch_fr_calf_4 = theta4 - l_fr_calf_: stretch of the spring
  const T stretch_fr_calf_4 = theta4 + T(1.6);

  // ---- body 6 (fl_hip) on body 1
  const T thetadot6 = y[6];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];
  // R6^T = R1^T E6^T: R takes inertial components to body components
  const T R6_21 = R1_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R1_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R1_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R1_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R1_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R1_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega1: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega1_1;
  const T omega6_2 = E6_22 * omega1_2 + E6_23 * omega1_3;
  const T omega6_3 = E6_22 * omega1_3 - E6_23 * omega1_2;
  // P6 = s1 + R1^T q6: position of the body origin, inertial axes [m]
  const T t6_1 = t2_1 + t2_2;
  const T P6_3 = s1_3 + t6_1;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_3 = P6_3 - t2_4 + R6_23 * T(0.000635) + R6_33 * T(3.1e-05);
  // Pdot6 = sdot1 + R1^T omega1~ q6: velocity of the body origin, inertial axes [m/s]
  const T t6_2 = t2_9 - t2_10;
  const T t6_3 = t2_8 - t2_6 + R1_31 * t6_2;
  const T Pdot6_1 = sdot1_1 + t6_3;
  const T t6_4 = t2_14 - t2_13 + R1_32 * t6_2;
  const T Pdot6_2 = sdot1_2 + t6_4;
  const T t6_5 = t2_17 - t2_16 + R1_33 * t6_2;
  const T Pdot6_3 = sdot1_3 + t6_5;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_6 = omega6_2 * T(3.1e-05) - omega6_3 * T(0.000635);
  const T t6_7 = omega6_3 * T(0.003311) + omega6_1 * T(3.1e-05);
  const T t6_8 = omega6_1 * T(0.000635) + omega6_2 * T(0.003311);
  const T v6_1 = Pdot6_1 + R1_11 * t6_6 - R6_21 * t6_7 + R6_31 * t6_8;
  const T v6_2 = Pdot6_2 + R1_12 * t6_6 - R6_22 * t6_7 + R6_32 * t6_8;
  const T v6_3 = Pdot6_3 + R1_13 * t6_6 - R6_23 * t6_7 + R6_33 * t6_8;
  // T6 = 1/2 omega6 . (I6 omega6) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (omega6_1 * (T(0.000469246) * omega6_1 - T(9.409e-06) * omega6_2 - T(3.42e-07) * omega6_3) +
      omega6_2 * (T(0.00080749) * omega6_2 - T(9.409e-06) * omega6_1 - T(4.66e-07) * omega6_3) + omega6_3 *
      (T(0.000552929) * omega6_3 - (T(3.42e-07) * omega6_1 + T(4.66e-07) * omega6_2))) + T(0.348) * (v6_1 * v6_1 +
      v6_2 * v6_2 + v6_3 * v6_3);

  // ---- body 7 (fl_thigh) on body 6
  const T theta7 = x[8];
  const T thetadot7 = y[7];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R1_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R1_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R1_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R1_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R1_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R1_13 * minus_E7_13 + R6_33 * E7_11;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // P7 = R6^T q7 + P6: position of the body origin, inertial axes [m]
  const T P7_3 = P6_3 + R6_23 * T(0.0838);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_3 = P7_3 - R7_13 * T(0.003237) - R6_23 * T(0.022327) - R7_33 * T(0.027326);
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_1 = omega6_1 * T(0.0838);
  const T t7_2 = omega6_3 * T(0.0838);
  const T Pdot7_1 = Pdot6_1 + R6_31 * t7_1 - R1_11 * t7_2;
  const T Pdot7_2 = Pdot6_2 + R6_32 * t7_1 - R1_12 * t7_2;
  const T Pdot7_3 = Pdot6_3 + R6_33 * t7_1 - R1_13 * t7_2;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_3 = omega7_3 * T(0.022327) - omega7_2 * T(0.027326);
  const T t7_4 = omega7_1 * T(0.027326) - omega7_3 * T(0.003237);
  const T t7_5 = omega7_2 * T(0.003237) - omega7_1 * T(0.022327);
  const T v7_1 = Pdot7_1 + R7_11 * t7_3 + R6_21 * t7_4 + R7_31 * t7_5;
  const T v7_2 = Pdot7_2 + R7_12 * t7_3 + R6_22 * t7_4 + R7_32 * t7_5;
  const T v7_3 = Pdot7_3 + R7_13 * t7_3 + R6_23 * t7_4 + R7_33 * t7_5;
  // T7 = 1/2 omega7 . (I7 omega7) + 1/2 m7 v7 . v7: kinetic energy [J]
  const T T7 = T(0.5) * (omega7_1 * (T(0.005529065) * omega7_1 + T(4.825e-06) * omega7_2 + T(0.000343869) * omega7_3)
      + omega7_2 * (T(4.825e-06) * omega7_1 + T(0.005139339) * omega7_2 + T(2.2448e-05) * omega7_3) + omega7_3 *
      (T(0.000343869) * omega7_1 + T(2.2448e-05) * omega7_2 + T(0.001367788) * omega7_3)) + T(0.5065) * (v7_1 * v7_1 +
      v7_2 * v7_2 + v7_3 * v7_3);
  // stretch_fl_thigh_7 = theta7 - l_fl_thigh_: stretch of the spring
  const T stretch_fl_thigh_7 = theta7 - T(0.8);

  // ---- body 8 (fl_calf) on body 7
  const T theta8 = x[9];
  const T thetadot8 = y[8];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[9];
  const T minus_E8_13 = sines[9];
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T R8_11 = R7_11 * E8_11 - R7_31 * minus_E8_13;
  const T R8_12 = R7_12 * E8_11 - R7_32 * minus_E8_13;
  const T R8_13 = R7_13 * E8_11 - R7_33 * minus_E8_13;
  const T R8_31 = R7_11 * minus_E8_13 + R7_31 * E8_11;
  const T R8_32 = R7_12 * minus_E8_13 + R7_32 * E8_11;
  const T R8_33 = R7_13 * minus_E8_13 + R7_33 * E8_11;
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega7_1 - minus_E8_13 * omega7_3;
  const T omega8_2 = thetadot8 + omega7_2;
  const T omega8_3 = minus_E8_13 * omega7_1 + E8_11 * omega7_3;
  // P8 = R7^T q8 + P7: position of the body origin, inertial axes [m]
  const T P8_3 = P7_3 - R7_33 * T(0.2);
  // p8 = R8^T r_link8 + P8: position of the mass centre, inertial axes [m]
  const T p8_3 = P8_3 + R8_13 * T(0.004726592920353982) - R8_33 * T(0.13197525663716814);
  // Pdot8 = R7^T omega7~ q8 + Pdot7: velocity of the body origin, inertial axes [m/s]
  const T t8_1 = omega7_1 * T(0.2);
  const T t8_2 = omega7_2 * T(0.2);
  const T Pdot8_1 = Pdot7_1 + R6_21 * t8_1 - R7_11 * t8_2;
  const T Pdot8_2 = Pdot7_2 + R6_22 * t8_1 - R7_12 * t8_2;
  const T Pdot8_3 = Pdot7_3 + R6_23 * t8_1 - R7_13 * t8_2;
  // v8 = R8^T omega8~ r_link8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_3 = omega8_3 * T(0.004726592920353982) + omega8_1 * T(0.13197525663716814);
  const T t8_4 = omega8_2 * T(0.13197525663716814);
  const T t8_5 = omega8_2 * T(0.004726592920353982);
  const T v8_1 = Pdot8_1 + R6_21 * t8_3 - R8_11 * t8_4 - R8_31 * t8_5;
  const T v8_2 = Pdot8_2 + R6_22 * t8_3 - R8_12 * t8_4 - R8_32 * t8_5;
  const T v8_3 = Pdot8_3 + R6_23 * t8_3 - R8_13 * t8_4 - R8_33 * t8_5;
  // T8 = 1/2 omega8 . (I_link8 omega8) + 1/2 m_link8 v8 . v8: kinetic energy [J]
  const T T8 = T(0.5) * (omega8_1 * (T(0.003385566451939115) * omega8_1 - T(0.00016742735341238938) * omega8_3) +
      T(0.003403441389465664) * omega8_2 * omega8_2 + omega8_3 * (T(4.385093752654867e-05) * omega8_3 -
      T(0.00016742735341238938) * omega8_1)) + T(0.113) * (v8_1 * v8_1 + v8_2 * v8_2 + v8_3 * v8_3);
  // stretch_fl_calf_8 = theta8 - l_fl_calf_: stretch of the spring
  const T stretch_fl_calf_8 = theta8 + T(1.6);

  // ---- body 10 (rr_hip) on body 1
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];
  // R10^T = R1^T E10^T: R takes inertial components to body components
  const T R10_21 = R1_21 * E10_22 + R1_31 * E10_23;
  const T R10_22 = R1_22 * E10_22 + R1_32 * E10_23;
  const T R10_23 = R1_23 * E10_22 + R1_33 * E10_23;
  const T R10_31 = R1_31 * E10_22 - R1_21 * E10_23;
  const T R10_32 = R1_32 * E10_22 - R1_22 * E10_23;
  const T R10_33 = R1_33 * E10_22 - R1_23 * E10_23;
  // omega10 = thetadot10 b10 + E10 omega1: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = thetadot10 + omega1_1;
  const T omega10_2 = E10_22 * omega1_2 + E10_23 * omega1_3;
  const T omega10_3 = E10_22 * omega1_3 - E10_23 * omega1_2;
  // P10 = s1 + R1^T q10: position of the body origin, inertial axes [m]
  const T P10_3 = s1_3 - t6_1;
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_3 = t2_4 + P10_3 - R10_23 * T(0.000635) + R10_33 * T(3.1e-05);
  // Pdot10 = sdot1 + R1^T omega1~ q10: velocity of the body origin, inertial axes [m/s]
  const T Pdot10_1 = sdot1_1 - t6_3;
  const T Pdot10_2 = sdot1_2 - t6_4;
  const T Pdot10_3 = sdot1_3 - t6_5;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_1 = omega10_3 * T(0.000635) + omega10_2 * T(3.1e-05);
  const T t10_2 = omega10_3 * T(0.003311) - omega10_1 * T(3.1e-05);
  const T t10_3 = omega10_1 * T(0.000635) + omega10_2 * T(0.003311);
  const T v10_1 = Pdot10_1 + R1_11 * t10_1 + R10_21 * t10_2 - R10_31 * t10_3;
  const T v10_2 = Pdot10_2 + R1_12 * t10_1 + R10_22 * t10_2 - R10_32 * t10_3;
  const T v10_3 = Pdot10_3 + R1_13 * t10_1 + R10_23 * t10_2 - R10_33 * t10_3;
  // T10 = 1/2 omega10 . (I10 omega10) + 1/2 m10 v10 . v10: kinetic energy [J]
  const T T10 = T(0.5) * (omega10_1 * (T(0.000469246) * omega10_1 - T(9.409e-06) * omega10_2 + T(3.42e-07) *
      omega10_3) + omega10_2 * (T(0.00080749) * omega10_2 - T(9.409e-06) * omega10_1 + T(4.66e-07) * omega10_3) +
      omega10_3 * (T(3.42e-07) * omega10_1 + T(4.66e-07) * omega10_2 + T(0.000552929) * omega10_3)) + T(0.348) *
      (v10_1 * v10_1 + v10_2 * v10_2 + v10_3 * v10_3);

  // ---- body 11 (rr_thigh) on body 10
  const T theta11 = x[11];
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R1_11 * E11_11 - R10_31 * minus_E11_13;
  const T R11_12 = R1_12 * E11_11 - R10_32 * minus_E11_13;
  const T R11_13 = R1_13 * E11_11 - R10_33 * minus_E11_13;
  const T R11_31 = R1_11 * minus_E11_13 + R10_31 * E11_11;
  const T R11_32 = R1_12 * minus_E11_13 + R10_32 * E11_11;
  const T R11_33 = R1_13 * minus_E11_13 + R10_33 * E11_11;
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 - minus_E11_13 * omega10_3;
  const T omega11_2 = thetadot11 + omega10_2;
  const T omega11_3 = minus_E11_13 * omega10_1 + E11_11 * omega10_3;
  // P11 = R10^T q11 + P10: position of the body origin, inertial axes [m]
  const T P11_3 = P10_3 - R10_23 * T(0.0838);
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T p11_3 = P11_3 + R10_23 * T(0.022327) - R11_13 * T(0.003237) - R11_33 * T(0.027326);
  // Pdot11 = R10^T omega10~ q11 + Pdot10: velocity of the body origin, inertial axes [m/s]
  const T t11_1 = omega10_3 * T(0.0838);
  const T t11_2 = omega10_1 * T(0.0838);
  const T Pdot11_1 = Pdot10_1 + R1_11 * t11_1 - R10_31 * t11_2;
  const T Pdot11_2 = Pdot10_2 + R1_12 * t11_1 - R10_32 * t11_2;
  const T Pdot11_3 = Pdot10_3 + R1_13 * t11_1 - R10_33 * t11_2;
  // v11 = R11^T omega11~ r11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_3 = omega11_1 * T(0.027326) - omega11_3 * T(0.003237);
  const T t11_4 = omega11_3 * T(0.022327) + omega11_2 * T(0.027326);
  const T t11_5 = omega11_1 * T(0.022327) + omega11_2 * T(0.003237);
  const T v11_1 = Pdot11_1 + R10_21 * t11_3 - R11_11 * t11_4 + R11_31 * t11_5;
  const T v11_2 = Pdot11_2 + R10_22 * t11_3 - R11_12 * t11_4 + R11_32 * t11_5;
  const T v11_3 = Pdot11_3 + R10_23 * t11_3 - R11_13 * t11_4 + R11_33 * t11_5;
  // T11 = 1/2 omega11 . (I11 omega11) + 1/2 m11 v11 . v11: kinetic energy [J]
  const T T11 = T(0.5) * (omega11_1 * (T(0.005529065) * omega11_1 - T(4.825e-06) * omega11_2 + T(0.000343869) *
      omega11_3) + omega11_2 * (T(0.005139339) * omega11_2 - T(4.825e-06) * omega11_1 - T(2.2448e-05) * omega11_3) +
      omega11_3 * (T(0.000343869) * omega11_1 - T(2.2448e-05) * omega11_2 + T(0.001367788) * omega11_3)) + T(0.5065) *
      (v11_1 * v11_1 + v11_2 * v11_2 + v11_3 * v11_3);
  // stretch_rr_thigh_11 = theta11 - l_rr_thigh_: stretch of the spring
  const T stretch_rr_thigh_11 = theta11 - T(0.8);

  // ---- body 12 (rr_calf) on body 11
  const T theta12 = x[12];
  const T thetadot12 = y[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_11 = cosines[12];
  const T minus_E12_13 = sines[12];
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T R12_11 = R11_11 * E12_11 - R11_31 * minus_E12_13;
  const T R12_12 = R11_12 * E12_11 - R11_32 * minus_E12_13;
  const T R12_13 = R11_13 * E12_11 - R11_33 * minus_E12_13;
  const T R12_31 = R11_11 * minus_E12_13 + R11_31 * E12_11;
  const T R12_32 = R11_12 * minus_E12_13 + R11_32 * E12_11;
  const T R12_33 = R11_13 * minus_E12_13 + R11_33 * E12_11;
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T omega12_1 = E12_11 * omega11_1 - minus_E12_13 * omega11_3;
  const T omega12_2 = thetadot12 + omega11_2;
  const T omega12_3 = minus_E12_13 * omega11_1 + E12_11 * omega11_3;
  // P12 = R11^T q12 + P11: position of the body origin, inertial axes [m]
  const T P12_3 = P11_3 - R11_33 * T(0.2);
  // p12 = R12^T r_link12 + P12: position of the mass centre, inertial axes [m]
  const T p12_3 = P12_3 + R12_13 * T(0.004726592920353982) - R12_33 * T(0.13197525663716814);
  // Pdot12 = R11^T omega11~ q12 + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_1 = omega11_1 * T(0.2);
  const T t12_2 = omega11_2 * T(0.2);
  const T Pdot12_1 = Pdot11_1 + R10_21 * t12_1 - R11_11 * t12_2;
  const T Pdot12_2 = Pdot11_2 + R10_22 * t12_1 - R11_12 * t12_2;
  const T Pdot12_3 = Pdot11_3 + R10_23 * t12_1 - R11_13 * t12_2;
  // v12 = R12^T omega12~ r_link12 + Pdot12: velocity of the mass centre, inertial axes [m/s]
  const T t12_3 = omega12_3 * T(0.004726592920353982) + omega12_1 * T(0.13197525663716814);
  const T t12_4 = omega12_2 * T(0.13197525663716814);
  const T t12_5 = omega12_2 * T(0.004726592920353982);
  const T v12_1 = Pdot12_1 + R10_21 * t12_3 - R12_11 * t12_4 - R12_31 * t12_5;
  const T v12_2 = Pdot12_2 + R10_22 * t12_3 - R12_12 * t12_4 - R12_32 * t12_5;
  const T v12_3 = Pdot12_3 + R10_23 * t12_3 - R12_13 * t12_4 - R12_33 * t12_5;
  // T12 = 1/2 omega12 . (I_link12 omega12) + 1/2 m_link12 v12 . v12: kinetic energy [J]
  const T T12 = T(0.5) * (omega12_1 * (T(0.003385566451939115) * omega12_1 - T(0.00016742735341238938) * omega12_3) +
      T(0.003403441389465664) * omega12_2 * omega12_2 + omega12_3 * (T(4.385093752654867e-05) * omega12_3 -
      T(0.00016742735341238938) * omega12_1)) + T(0.113) * (v12_1 * v12_1 + v12_2 * v12_2 + v12_3 * v12_3);
  // stretch_rr_calf_12 = theta12 - l_rr_calf_: stretch of the spring
  const T stretch_rr_calf_12 = theta12 + T(1.6);

  // ---- body 14 (rl_hip) on body 1
  const T thetadot14 = y[12];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];
  // R14^T = R1^T E14^T: R takes inertial components to body components
  const T R14_21 = R1_21 * E14_22 + R1_31 * E14_23;
  const T R14_22 = R1_22 * E14_22 + R1_32 * E14_23;
  const T R14_23 = R1_23 * E14_22 + R1_33 * E14_23;
  const T R14_31 = R1_31 * E14_22 - R1_21 * E14_23;
  const T R14_32 = R1_32 * E14_22 - R1_22 * E14_23;
  const T R14_33 = R1_33 * E14_22 - R1_23 * E14_23;
  // omega14 = thetadot14 b14 + E14 omega1: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = thetadot14 + omega1_1;
  const T omega14_2 = E14_22 * omega1_2 + E14_23 * omega1_3;
  const T omega14_3 = E14_22 * omega1_3 - E14_23 * omega1_2;
  // P14 = s1 + R1^T q14: position of the body origin, inertial axes [m]
  const T P14_3 = s1_3 - t2_3;
  // p14 = R14^T r14 + P14: position of the mass centre, inertial axes [m]
  const T p14_3 = t2_4 + P14_3 + R14_23 * T(0.000635) + R14_33 * T(3.1e-05);
  // Pdot14 = sdot1 + R1^T omega1~ q14: velocity of the body origin, inertial axes [m/s]
  const T Pdot14_1 = sdot1_1 - t2_12;
  const T Pdot14_2 = sdot1_2 - t2_15;
  const T Pdot14_3 = sdot1_3 - t2_18;
  // v14 = R14^T omega14~ r14 + Pdot14: velocity of the mass centre, inertial axes [m/s]
  const T t14_1 = omega14_2 * T(3.1e-05) - omega14_3 * T(0.000635);
  const T t14_2 = omega14_3 * T(0.003311) - omega14_1 * T(3.1e-05);
  const T t14_3 = omega14_1 * T(0.000635) - omega14_2 * T(0.003311);
  const T v14_1 = Pdot14_1 + R1_11 * t14_1 + R14_21 * t14_2 + R14_31 * t14_3;
  const T v14_2 = Pdot14_2 + R1_12 * t14_1 + R14_22 * t14_2 + R14_32 * t14_3;
  const T v14_3 = Pdot14_3 + R1_13 * t14_1 + R14_23 * t14_2 + R14_33 * t14_3;
  // T14 = 1/2 omega14 . (I14 omega14) + 1/2 m14 v14 . v14: kinetic energy [J]
  const T T14 = T(0.5) * (omega14_1 * (T(0.000469246) * omega14_1 + T(9.409e-06) * omega14_2 + T(3.42e-07) *
      omega14_3) + omega14_2 * (T(9.409e-06) * omega14_1 + T(0.00080749) * omega14_2 - T(4.66e-07) * omega14_3) +
      omega14_3 * (T(3.42e-07) * omega14_1 - T(4.66e-07) * omega14_2 + T(0.000552929) * omega14_3)) + T(0.348) *
      (v14_1 * v14_1 + v14_2 * v14_2 + v14_3 * v14_3);

  // ---- body 15 (rl_thigh) on body 14
  const T theta15 = x[14];
  const T thetadot15 = y[13];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_11 = R1_11 * E15_11 - R14_31 * minus_E15_13;
  const T R15_12 = R1_12 * E15_11 - R14_32 * minus_E15_13;
  const T R15_13 = R1_13 * E15_11 - R14_33 * minus_E15_13;
  const T R15_31 = R1_11 * minus_E15_13 + R14_31 * E15_11;
  const T R15_32 = R1_12 * minus_E15_13 + R14_32 * E15_11;
  const T R15_33 = R1_13 * minus_E15_13 + R14_33 * E15_11;
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = E15_11 * omega14_1 - minus_E15_13 * omega14_3;
  const T omega15_2 = thetadot15 + omega14_2;
  const T omega15_3 = minus_E15_13 * omega14_1 + E15_11 * omega14_3;
  // P15 = R14^T q15 + P14: position of the body origin, inertial axes [m]
  const T P15_3 = P14_3 + R14_23 * T(0.0838);
  // p15 = R15^T r15 + P15: position of the mass centre, inertial axes [m]
  const T p15_3 = P15_3 - R15_13 * T(0.003237) - R14_23 * T(0.022327) - R15_33 * T(0.027326);
  // Pdot15 = R14^T omega14~ q15 + Pdot14: velocity of the body origin, inertial axes [m/s]
  const T t15_1 = omega14_1 * T(0.0838);
  const T t15_2 = omega14_3 * T(0.0838);
  const T Pdot15_1 = Pdot14_1 + R14_31 * t15_1 - R1_11 * t15_2;
  const T Pdot15_2 = Pdot14_2 + R14_32 * t15_1 - R1_12 * t15_2;
  const T Pdot15_3 = Pdot14_3 + R14_33 * t15_1 - R1_13 * t15_2;
  // v15 = R15^T omega15~ r15 + Pdot15: velocity of the mass centre, inertial axes [m/s]
  const T t15_3 = omega15_3 * T(0.022327) - omega15_2 * T(0.027326);
  const T t15_4 = omega15_1 * T(0.027326) - omega15_3 * T(0.003237);
  const T t15_5 = omega15_2 * T(0.003237) - omega15_1 * T(0.022327);
  const T v15_1 = Pdot15_1 + R15_11 * t15_3 + R14_21 * t15_4 + R15_31 * t15_5;
  const T v15_2 = Pdot15_2 + R15_12 * t15_3 + R14_22 * t15_4 + R15_32 * t15_5;
  const T v15_3 = Pdot15_3 + R15_13 * t15_3 + R14_23 * t15_4 + R15_33 * t15_5;
  // T15 = 1/2 omega15 . (I15 omega15) + 1/2 m15 v15 . v15: kinetic energy [J]
  const T T15 = T(0.5) * (omega15_1 * (T(0.005529065) * omega15_1 + T(4.825e-06) * omega15_2 + T(0.000343869) *
      omega15_3) + omega15_2 * (T(4.825e-06) * omega15_1 + T(0.005139339) * omega15_2 + T(2.2448e-05) * omega15_3) +
      omega15_3 * (T(0.000343869) * omega15_1 + T(2.2448e-05) * omega15_2 + T(0.001367788) * omega15_3)) + T(0.5065) *
      (v15_1 * v15_1 + v15_2 * v15_2 + v15_3 * v15_3);
  // stretch_rl_thigh_15 = theta15 - l_rl_thigh_: stretch of the spring
  const T stretch_rl_thigh_15 = theta15 - T(0.8);

  // ---- body 16 (rl_calf) on body 15
  const T theta16 = x[15];
  const T thetadot16 = y[14];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cosines[15];
  const T minus_E16_13 = sines[15];
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T R16_11 = R15_11 * E16_11 - R15_31 * minus_E16_13;
  const T R16_12 = R15_12 * E16_11 - R15_32 * minus_E16_13;
  const T R16_13 = R15_13 * E16_11 - R15_33 * minus_E16_13;
  const T R16_31 = R15_11 * minus_E16_13 + R15_31 * E16_11;
  const T R16_32 = R15_12 * minus_E16_13 + R15_32 * E16_11;
  const T R16_33 = R15_13 * minus_E16_13 + R15_33 * E16_11;
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T omega16_1 = E16_11 * omega15_1 - minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 + E16_11 * omega15_3;
  // P16 = R15^T q16 + P15: position of the body origin, inertial axes [m]
  const T P16_3 = P15_3 - R15_33 * T(0.2);
  // p16 = R16^T r_link16 + P16: position of the mass centre, inertial axes [m]
  const T p16_3 = P16_3 + R16_13 * T(0.004726592920353982) - R16_33 * T(0.13197525663716814);
  // Pdot16 = R15^T omega15~ q16 + Pdot15: velocity of the body origin, inertial axes [m/s]
  const T t16_1 = omega15_1 * T(0.2);
  const T t16_2 = omega15_2 * T(0.2);
  const T Pdot16_1 = Pdot15_1 + R14_21 * t16_1 - R15_11 * t16_2;
  const T Pdot16_2 = Pdot15_2 + R14_22 * t16_1 - R15_12 * t16_2;
  const T Pdot16_3 = Pdot15_3 + R14_23 * t16_1 - R15_13 * t16_2;
  // v16 = R16^T omega16~ r_link16 + Pdot16: velocity of the mass centre, inertial axes [m/s]
  const T t16_3 = omega16_3 * T(0.004726592920353982) + omega16_1 * T(0.13197525663716814);
  const T t16_4 = omega16_2 * T(0.13197525663716814);
  const T t16_5 = omega16_2 * T(0.004726592920353982);
  const T v16_1 = Pdot16_1 + R14_21 * t16_3 - R16_11 * t16_4 - R16_31 * t16_5;
  const T v16_2 = Pdot16_2 + R14_22 * t16_3 - R16_12 * t16_4 - R16_32 * t16_5;
  const T v16_3 = Pdot16_3 + R14_23 * t16_3 - R16_13 * t16_4 - R16_33 * t16_5;
  // T16 = 1/2 omega16 . (I_link16 omega16) + 1/2 m_link16 v16 . v16: kinetic energy [J]
  const T T16 = T(0.5) * (omega16_1 * (T(0.003385566451939115) * omega16_1 - T(0.00016742735341238938) * omega16_3) +
      T(0.003403441389465664) * omega16_2 * omega16_2 + omega16_3 * (T(4.385093752654867e-05) * omega16_3 -
      T(0.00016742735341238938) * omega16_1)) + T(0.113) * (v16_1 * v16_1 + v16_2 * v16_2 + v16_3 * v16_3);
  // stretch_rl_calf_16 = theta16 - l_rl_calf_: stretch of the spring
  const T stretch_rl_calf_16 = theta16 + T(1.6);

  // ---- whole system
  const T theta2 = x[4];
  const T theta6 = x[7];
  const T theta10 = x[10];
  const T theta14 = x[13];
  // kinetic = T1 + T2 + T3 + T4 + T6 + T7 + T8 + T10 + T11 + T12 + T14 + T15 + T16: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T6 + T7 + T8 + T10 + T11 + T12 + T14 + T15 + T16;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m6 p6 + m7 p7 + m10 p10 + m11 p11 + m14 p14 + m15 p15 + m_link4 p4 + m_link8 p8 +
  //   m_link12 p12 + m_link16 p16: first moment of mass, inertial axes [kg m]
  const T mp_3 = c.p.m_trunk * p1_3 + T(0.696) * p2_3 + T(1.013) * p3_3 + T(0.696) * p6_3 + T(1.013) * p7_3 + T(0.696)
      * p10_3 + T(1.013) * p11_3 + T(0.696) * p14_3 + T(1.013) * p15_3 + T(0.226) * p4_3 + T(0.226) * p8_3 + T(0.226)
      * p12_3 + T(0.226) * p16_3;
  // potential = -g . mp + 1/2 theta2^2 k_fr_hip_ + 1/2 theta6^2 k_fl_hip_ + 1/2 theta10^2 k_rr_hip_ + 1/2 theta14^2
  //   k_rl_hip_ + 1/2 k_fr_thigh_ stretch_fr_thigh_3^2 + 1/2 k_fr_calf_ stretch_fr_calf_4^2 + 1/2 k_fl_thigh_
  //   stretch_fl_thigh_7^2 + 1/2 k_fl_calf_ stretch_fl_calf_8^2 + 1/2 k_rr_thigh_ stretch_rr_thigh_11^2 + 1/2
  //   k_rr_calf_ stretch_rr_calf_12^2 + 1/2 k_rl_thigh_ stretch_rl_thigh_15^2 + 1/2 k_rl_calf_ stretch_rl_calf_16^2:
  //   potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3 + theta2 * theta2 * T(0.5) * c.p.kp + theta6 * theta6 * T(0.5) * c.p.kp + theta10
      * theta10 * T(0.5) * c.p.kp + theta14 * theta14 * T(0.5) * c.p.kp + stretch_fr_thigh_3 * stretch_fr_thigh_3 *
      c.c0_1 + stretch_fr_calf_4 * stretch_fr_calf_4 * c.c0_1 + stretch_fl_thigh_7 * stretch_fl_thigh_7 * c.c0_1 +
      stretch_fl_calf_8 * stretch_fl_calf_8 * c.c0_1 + stretch_rr_thigh_11 * stretch_rr_thigh_11 * c.c0_1 +
      stretch_rr_calf_12 * stretch_rr_calf_12 * c.c0_1 + stretch_rl_thigh_15 * stretch_rl_thigh_15 * c.c0_1 +
      stretch_rl_calf_16 * stretch_rl_calf_16 * c.c0_1;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 773 add, 927 multiply, 24 sine or cosine
template <class T>
void momentum(const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[16], s1_2 = x[17], s1_3 = x[18];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[15], sdot1_2 = y[16], sdot1_3 = y[17];
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
  const T p1_1 = s1_1 + R1_21 * T(0.0041) - R1_31 * T(5e-04);
  const T p1_2 = s1_2 + R1_22 * T(0.0041) - R1_32 * T(5e-04);
  const T p1_3 = s1_3 + R1_23 * T(0.0041) - R1_33 * T(5e-04);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = omega1_1 * T(5e-04);
  const T t1_14 = omega1_3 * T(0.0041) + omega1_2 * T(5e-04);
  const T t1_15 = omega1_1 * T(0.0041);
  const T v1_1 = sdot1_1 + R1_21 * t1_13 - R1_11 * t1_14 + R1_31 * t1_15;
  const T v1_2 = sdot1_2 + R1_22 * t1_13 - R1_12 * t1_14 + R1_32 * t1_15;
  const T v1_3 = sdot1_3 + R1_23 * t1_13 - R1_13 * t1_14 + R1_33 * t1_15;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = c.p.m_trunk * v1_1;
  const T l1_2 = c.p.m_trunk * v1_2;
  const T l1_3 = c.p.m_trunk * v1_3;
  // H1 = R1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_16 = T(0.0158533) * omega1_1 - T(3.66e-05) * omega1_2 - T(6.11e-05) * omega1_3;
  const T t1_17 = T(0.0377999) * omega1_2 - T(3.66e-05) * omega1_1 - T(2.75e-05) * omega1_3;
  const T t1_18 = T(0.0456542) * omega1_3 - (T(6.11e-05) * omega1_1 + T(2.75e-05) * omega1_2);
  const T H1_1 = R1_11 * t1_16 + R1_21 * t1_17 + R1_31 * t1_18 + p1_2 * l1_3 - p1_3 * l1_2;
  const T H1_2 = R1_12 * t1_16 + R1_22 * t1_17 + R1_32 * t1_18 + p1_3 * l1_1 - p1_1 * l1_3;
  const T H1_3 = R1_13 * t1_16 + R1_23 * t1_17 + R1_33 * t1_18 + p1_1 * l1_2 - p1_2 * l1_1;

  // ---- body 2 (fr_hip) on body 1
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
  const T t2_1 = R1_11 * T(0.1805);
  const T t2_2 = R1_21 * T(0.047);
  const T t2_3 = t2_1 - t2_2;
  const T P2_1 = s1_1 + t2_3;
  const T t2_4 = R1_12 * T(0.1805);
  const T t2_5 = R1_22 * T(0.047);
  const T t2_6 = t2_4 - t2_5;
  const T P2_2 = s1_2 + t2_6;
  const T t2_7 = R1_13 * T(0.1805);
  const T t2_8 = R1_23 * T(0.047);
  const T t2_9 = t2_7 - t2_8;
  const T P2_3 = s1_3 + t2_9;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T t2_10 = R1_11 * T(0.003311);
  const T p2_1 = P2_1 - t2_10 - R2_21 * T(0.000635) + R2_31 * T(3.1e-05);
  const T t2_11 = R1_12 * T(0.003311);
  const T p2_2 = P2_2 - t2_11 - R2_22 * T(0.000635) + R2_32 * T(3.1e-05);
  const T t2_12 = R1_13 * T(0.003311);
  const T p2_3 = P2_3 - t2_12 - R2_23 * T(0.000635) + R2_33 * T(3.1e-05);
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_13 = omega1_3 * T(0.047);
  const T t2_14 = R1_11 * t2_13;
  const T t2_15 = omega1_3 * T(0.1805);
  const T t2_16 = R1_21 * t2_15;
  const T t2_17 = omega1_1 * T(0.047);
  const T t2_18 = omega1_2 * T(0.1805);
  const T t2_19 = t2_17 + t2_18;
  const T t2_20 = t2_14 + t2_16 - R1_31 * t2_19;
  const T Pdot2_1 = sdot1_1 + t2_20;
  const T t2_21 = R1_12 * t2_13;
  const T t2_22 = R1_22 * t2_15;
  const T t2_23 = t2_21 + t2_22 - R1_32 * t2_19;
  const T Pdot2_2 = sdot1_2 + t2_23;
  const T t2_24 = R1_13 * t2_13;
  const T t2_25 = R1_23 * t2_15;
  const T t2_26 = t2_24 + t2_25 - R1_33 * t2_19;
  const T Pdot2_3 = sdot1_3 + t2_26;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_27 = omega2_3 * T(0.000635) + omega2_2 * T(3.1e-05);
  const T t2_28 = omega2_3 * T(0.003311) + omega2_1 * T(3.1e-05);
  const T t2_29 = omega2_2 * T(0.003311) - omega2_1 * T(0.000635);
  const T v2_1 = Pdot2_1 + R1_11 * t2_27 - R2_21 * t2_28 + R2_31 * t2_29;
  const T v2_2 = Pdot2_2 + R1_12 * t2_27 - R2_22 * t2_28 + R2_32 * t2_29;
  const T v2_3 = Pdot2_3 + R1_13 * t2_27 - R2_23 * t2_28 + R2_33 * t2_29;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(0.696) * v2_1;
  const T l2_2 = T(0.696) * v2_2;
  const T l2_3 = T(0.696) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_30 = T(0.000469246) * omega2_1 + T(9.409e-06) * omega2_2 - T(3.42e-07) * omega2_3;
  const T t2_31 = T(9.409e-06) * omega2_1 + T(0.00080749) * omega2_2 + T(4.66e-07) * omega2_3;
  const T t2_32 = T(4.66e-07) * omega2_2 - T(3.42e-07) * omega2_1 + T(0.000552929) * omega2_3;
  const T H2_1 = R1_11 * t2_30 + R2_21 * t2_31 + R2_31 * t2_32 + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = R1_12 * t2_30 + R2_22 * t2_31 + R2_32 * t2_32 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = R1_13 * t2_30 + R2_23 * t2_31 + R2_33 * t2_32 + p2_1 * l2_2 - p2_2 * l2_1;

  // ---- body 3 (fr_thigh) on body 2
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 - R2_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 - R2_33 * minus_E3_13;
  const T R3_31 = R1_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R1_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = R1_13 * minus_E3_13 + R2_33 * E3_11;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega2_1 - minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + omega2_2;
  const T omega3_3 = minus_E3_13 * omega2_1 + E3_11 * omega2_3;
  // P3 = R2^T q3 + P2: position of the body origin, inertial axes [m]
  const T P3_1 = P2_1 - R2_21 * T(0.0838);
  const T P3_2 = P2_2 - R2_22 * T(0.0838);
  const T P3_3 = P2_3 - R2_23 * T(0.0838);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 + R2_21 * T(0.022327) - R3_11 * T(0.003237) - R3_31 * T(0.027326);
  const T p3_2 = P3_2 + R2_22 * T(0.022327) - R3_12 * T(0.003237) - R3_32 * T(0.027326);
  const T p3_3 = P3_3 + R2_23 * T(0.022327) - R3_13 * T(0.003237) - R3_33 * T(0.027326);
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_1 = omega2_3 * T(0.0838);
  const T t3_2 = omega2_1 * T(0.0838);
  const T Pdot3_1 = Pdot2_1 + R1_11 * t3_1 - R2_31 * t3_2;
  const T Pdot3_2 = Pdot2_2 + R1_12 * t3_1 - R2_32 * t3_2;
  const T Pdot3_3 = Pdot2_3 + R1_13 * t3_1 - R2_33 * t3_2;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_3 = omega3_1 * T(0.027326) - omega3_3 * T(0.003237);
  const T t3_4 = omega3_3 * T(0.022327) + omega3_2 * T(0.027326);
  const T t3_5 = omega3_1 * T(0.022327) + omega3_2 * T(0.003237);
  const T v3_1 = Pdot3_1 + R2_21 * t3_3 - R3_11 * t3_4 + R3_31 * t3_5;
  const T v3_2 = Pdot3_2 + R2_22 * t3_3 - R3_12 * t3_4 + R3_32 * t3_5;
  const T v3_3 = Pdot3_3 + R2_23 * t3_3 - R3_13 * t3_4 + R3_33 * t3_5;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(1.013) * v3_1;
  const T l3_2 = T(1.013) * v3_2;
  const T l3_3 = T(1.013) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_6 = T(0.005529065) * omega3_1 - T(4.825e-06) * omega3_2 + T(0.000343869) * omega3_3;
  const T t3_7 = T(0.005139339) * omega3_2 - T(4.825e-06) * omega3_1 - T(2.2448e-05) * omega3_3;
  const T t3_8 = T(0.000343869) * omega3_1 - T(2.2448e-05) * omega3_2 + T(0.001367788) * omega3_3;
  const T H3_1 = R3_11 * t3_6 + R2_21 * t3_7 + R3_31 * t3_8 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = R3_12 * t3_6 + R2_22 * t3_7 + R3_32 * t3_8 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R3_13 * t3_6 + R2_23 * t3_7 + R3_33 * t3_8 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (fr_calf) on body 3
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - R3_31 * minus_E4_13;
  const T R4_12 = R3_12 * E4_11 - R3_32 * minus_E4_13;
  const T R4_13 = R3_13 * E4_11 - R3_33 * minus_E4_13;
  const T R4_31 = R3_11 * minus_E4_13 + R3_31 * E4_11;
  const T R4_32 = R3_12 * minus_E4_13 + R3_32 * E4_11;
  const T R4_33 = R3_13 * minus_E4_13 + R3_33 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 - minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  const T omega4_3 = minus_E4_13 * omega3_1 + E4_11 * omega3_3;
  // P4 = R3^T q4 + P3: position of the body origin, inertial axes [m]
  const T P4_1 = P3_1 - R3_31 * T(0.2);
  const T P4_2 = P3_2 - R3_32 * T(0.2);
  const T P4_3 = P3_3 - R3_33 * T(0.2);
  // p4 = R4^T r_link4 + P4: position of the mass centre, inertial axes [m]
  const T p4_1 = P4_1 + R4_11 * T(0.004726592920353982) - R4_31 * T(0.13197525663716814);
  const T p4_2 = P4_2 + R4_12 * T(0.004726592920353982) - R4_32 * T(0.13197525663716814);
  const T p4_3 = P4_3 + R4_13 * T(0.004726592920353982) - R4_33 * T(0.13197525663716814);
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_1 = omega3_1 * T(0.2);
  const T t4_2 = omega3_2 * T(0.2);
  const T Pdot4_1 = Pdot3_1 + R2_21 * t4_1 - R3_11 * t4_2;
  const T Pdot4_2 = Pdot3_2 + R2_22 * t4_1 - R3_12 * t4_2;
  const T Pdot4_3 = Pdot3_3 + R2_23 * t4_1 - R3_13 * t4_2;
  // v4 = R4^T omega4~ r_link4 + Pdot4: velocity of the mass centre, inertial axes [m/s]
  const T t4_3 = omega4_3 * T(0.004726592920353982) + omega4_1 * T(0.13197525663716814);
  const T t4_4 = omega4_2 * T(0.13197525663716814);
  const T t4_5 = omega4_2 * T(0.004726592920353982);
  const T v4_1 = Pdot4_1 + R2_21 * t4_3 - R4_11 * t4_4 - R4_31 * t4_5;
  const T v4_2 = Pdot4_2 + R2_22 * t4_3 - R4_12 * t4_4 - R4_32 * t4_5;
  const T v4_3 = Pdot4_3 + R2_23 * t4_3 - R4_13 * t4_4 - R4_33 * t4_5;
  // l4 = m_link4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(0.226) * v4_1;
  const T l4_2 = T(0.226) * v4_2;
  const T l4_3 = T(0.226) * v4_3;
  // H4 = R4^T I_link4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_6 = T(0.003385566451939115) * omega4_1 - T(0.00016742735341238938) * omega4_3;
  const T t4_7 = T(0.003403441389465664) * omega4_2;
  const T t4_8 = T(4.385093752654867e-05) * omega4_3 - T(0.00016742735341238938) * omega4_1;
  const T H4_1 = R4_11 * t4_6 + R2_21 * t4_7 + R4_31 * t4_8 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_6 + R2_22 * t4_7 + R4_32 * t4_8 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R4_13 * t4_6 + R2_23 * t4_7 + R4_33 * t4_8 + p4_1 * l4_2 - p4_2 * l4_1;

  // ---- body 6 (fl_hip) on body 1
  const T thetadot6 = y[6];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];
  // R6^T = R1^T E6^T: R takes inertial components to body components
  const T R6_21 = R1_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R1_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R1_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R1_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R1_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R1_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega1: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega1_1;
  const T omega6_2 = E6_22 * omega1_2 + E6_23 * omega1_3;
  const T omega6_3 = E6_22 * omega1_3 - E6_23 * omega1_2;
  // P6 = s1 + R1^T q6: position of the body origin, inertial axes [m]
  const T t6_1 = t2_1 + t2_2;
  const T P6_1 = s1_1 + t6_1;
  const T t6_2 = t2_4 + t2_5;
  const T P6_2 = s1_2 + t6_2;
  const T t6_3 = t2_7 + t2_8;
  const T P6_3 = s1_3 + t6_3;
  // p6 = R6^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = P6_1 - t2_10 + R6_21 * T(0.000635) + R6_31 * T(3.1e-05);
  const T p6_2 = P6_2 - t2_11 + R6_22 * T(0.000635) + R6_32 * T(3.1e-05);
  const T p6_3 = P6_3 - t2_12 + R6_23 * T(0.000635) + R6_33 * T(3.1e-05);
  // Pdot6 = sdot1 + R1^T omega1~ q6: velocity of the body origin, inertial axes [m/s]
  const T t6_4 = t2_17 - t2_18;
  const T t6_5 = t2_16 - t2_14 + R1_31 * t6_4;
  const T Pdot6_1 = sdot1_1 + t6_5;
  const T t6_6 = t2_22 - t2_21 + R1_32 * t6_4;
  const T Pdot6_2 = sdot1_2 + t6_6;
  const T t6_7 = t2_25 - t2_24 + R1_33 * t6_4;
  const T Pdot6_3 = sdot1_3 + t6_7;
  // v6 = R6^T omega6~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_8 = omega6_2 * T(3.1e-05) - omega6_3 * T(0.000635);
  const T t6_9 = omega6_3 * T(0.003311) + omega6_1 * T(3.1e-05);
  const T t6_10 = omega6_1 * T(0.000635) + omega6_2 * T(0.003311);
  const T v6_1 = Pdot6_1 + R1_11 * t6_8 - R6_21 * t6_9 + R6_31 * t6_10;
  const T v6_2 = Pdot6_2 + R1_12 * t6_8 - R6_22 * t6_9 + R6_32 * t6_10;
  const T v6_3 = Pdot6_3 + R1_13 * t6_8 - R6_23 * t6_9 + R6_33 * t6_10;
  // l6 = m6 v6: linear momentum, inertial axes [kg m/s]
  const T l6_1 = T(0.696) * v6_1;
  const T l6_2 = T(0.696) * v6_2;
  const T l6_3 = T(0.696) * v6_3;
  // H6 = R6^T I6 omega6 + p6~ l6: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t6_11 = T(0.000469246) * omega6_1 - T(9.409e-06) * omega6_2 - T(3.42e-07) * omega6_3;
  const T t6_12 = T(0.00080749) * omega6_2 - T(9.409e-06) * omega6_1 - T(4.66e-07) * omega6_3;
  const T t6_13 = T(0.000552929) * omega6_3 - (T(3.42e-07) * omega6_1 + T(4.66e-07) * omega6_2);
  const T H6_1 = R1_11 * t6_11 + R6_21 * t6_12 + R6_31 * t6_13 + p6_2 * l6_3 - p6_3 * l6_2;
  const T H6_2 = R1_12 * t6_11 + R6_22 * t6_12 + R6_32 * t6_13 + p6_3 * l6_1 - p6_1 * l6_3;
  const T H6_3 = R1_13 * t6_11 + R6_23 * t6_12 + R6_33 * t6_13 + p6_1 * l6_2 - p6_2 * l6_1;

  // ---- body 7 (fl_thigh) on body 6
  const T thetadot7 = y[7];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R1_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R1_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R1_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R1_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R1_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R1_13 * minus_E7_13 + R6_33 * E7_11;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // P7 = R6^T q7 + P6: position of the body origin, inertial axes [m]
  const T P7_1 = P6_1 + R6_21 * T(0.0838);
  const T P7_2 = P6_2 + R6_22 * T(0.0838);
  const T P7_3 = P6_3 + R6_23 * T(0.0838);
  // p7 = R7^T r7 + P7: position of the mass centre, inertial axes [m]
  const T p7_1 = P7_1 - R7_11 * T(0.003237) - R6_21 * T(0.022327) - R7_31 * T(0.027326);
  const T p7_2 = P7_2 - R7_12 * T(0.003237) - R6_22 * T(0.022327) - R7_32 * T(0.027326);
  const T p7_3 = P7_3 - R7_13 * T(0.003237) - R6_23 * T(0.022327) - R7_33 * T(0.027326);
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_1 = omega6_1 * T(0.0838);
  const T t7_2 = omega6_3 * T(0.0838);
  const T Pdot7_1 = Pdot6_1 + R6_31 * t7_1 - R1_11 * t7_2;
  const T Pdot7_2 = Pdot6_2 + R6_32 * t7_1 - R1_12 * t7_2;
  const T Pdot7_3 = Pdot6_3 + R6_33 * t7_1 - R1_13 * t7_2;
  // v7 = R7^T omega7~ r7 + Pdot7: velocity of the mass centre, inertial axes [m/s]
  const T t7_3 = omega7_3 * T(0.022327) - omega7_2 * T(0.027326);
  const T t7_4 = omega7_1 * T(0.027326) - omega7_3 * T(0.003237);
  const T t7_5 = omega7_2 * T(0.003237) - omega7_1 * T(0.022327);
  const T v7_1 = Pdot7_1 + R7_11 * t7_3 + R6_21 * t7_4 + R7_31 * t7_5;
  const T v7_2 = Pdot7_2 + R7_12 * t7_3 + R6_22 * t7_4 + R7_32 * t7_5;
  const T v7_3 = Pdot7_3 + R7_13 * t7_3 + R6_23 * t7_4 + R7_33 * t7_5;
  // l7 = m7 v7: linear momentum, inertial axes [kg m/s]
  const T l7_1 = T(1.013) * v7_1;
  const T l7_2 = T(1.013) * v7_2;
  const T l7_3 = T(1.013) * v7_3;
  // H7 = R7^T I7 omega7 + p7~ l7: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t7_6 = T(0.005529065) * omega7_1 + T(4.825e-06) * omega7_2 + T(0.000343869) * omega7_3;
  const T t7_7 = T(4.825e-06) * omega7_1 + T(0.005139339) * omega7_2 + T(2.2448e-05) * omega7_3;
  const T t7_8 = T(0.000343869) * omega7_1 + T(2.2448e-05) * omega7_2 + T(0.001367788) * omega7_3;
  const T H7_1 = R7_11 * t7_6 + R6_21 * t7_7 + R7_31 * t7_8 + p7_2 * l7_3 - p7_3 * l7_2;
  const T H7_2 = R7_12 * t7_6 + R6_22 * t7_7 + R7_32 * t7_8 + p7_3 * l7_1 - p7_1 * l7_3;
  const T H7_3 = R7_13 * t7_6 + R6_23 * t7_7 + R7_33 * t7_8 + p7_1 * l7_2 - p7_2 * l7_1;

  // ---- body 8 (fl_calf) on body 7
  const T thetadot8 = y[8];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[9];
  const T minus_E8_13 = sines[9];
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T R8_11 = R7_11 * E8_11 - R7_31 * minus_E8_13;
  const T R8_12 = R7_12 * E8_11 - R7_32 * minus_E8_13;
  const T R8_13 = R7_13 * E8_11 - R7_33 * minus_E8_13;
  const T R8_31 = R7_11 * minus_E8_13 + R7_31 * E8_11;
  const T R8_32 = R7_12 * minus_E8_13 + R7_32 * E8_11;
  const T R8_33 = R7_13 * minus_E8_13 + R7_33 * E8_11;
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega7_1 - minus_E8_13 * omega7_3;
  const T omega8_2 = thetadot8 + omega7_2;
  const T omega8_3 = minus_E8_13 * omega7_1 + E8_11 * omega7_3;
  // P8 = R7^T q8 + P7: position of the body origin, inertial axes [m]
  const T P8_1 = P7_1 - R7_31 * T(0.2);
  const T P8_2 = P7_2 - R7_32 * T(0.2);
  const T P8_3 = P7_3 - R7_33 * T(0.2);
  // p8 = R8^T r_link8 + P8: position of the mass centre, inertial axes [m]
  const T p8_1 = P8_1 + R8_11 * T(0.004726592920353982) - R8_31 * T(0.13197525663716814);
  const T p8_2 = P8_2 + R8_12 * T(0.004726592920353982) - R8_32 * T(0.13197525663716814);
  const T p8_3 = P8_3 + R8_13 * T(0.004726592920353982) - R8_33 * T(0.13197525663716814);
  // Pdot8 = R7^T omega7~ q8 + Pdot7: velocity of the body origin, inertial axes [m/s]
  const T t8_1 = omega7_1 * T(0.2);
  const T t8_2 = omega7_2 * T(0.2);
  const T Pdot8_1 = Pdot7_1 + R6_21 * t8_1 - R7_11 * t8_2;
  const T Pdot8_2 = Pdot7_2 + R6_22 * t8_1 - R7_12 * t8_2;
  const T Pdot8_3 = Pdot7_3 + R6_23 * t8_1 - R7_13 * t8_2;
  // v8 = R8^T omega8~ r_link8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_3 = omega8_3 * T(0.004726592920353982) + omega8_1 * T(0.13197525663716814);
  const T t8_4 = omega8_2 * T(0.13197525663716814);
  const T t8_5 = omega8_2 * T(0.004726592920353982);
  const T v8_1 = Pdot8_1 + R6_21 * t8_3 - R8_11 * t8_4 - R8_31 * t8_5;
  const T v8_2 = Pdot8_2 + R6_22 * t8_3 - R8_12 * t8_4 - R8_32 * t8_5;
  const T v8_3 = Pdot8_3 + R6_23 * t8_3 - R8_13 * t8_4 - R8_33 * t8_5;
  // l8 = m_link8 v8: linear momentum, inertial axes [kg m/s]
  const T l8_1 = T(0.226) * v8_1;
  const T l8_2 = T(0.226) * v8_2;
  const T l8_3 = T(0.226) * v8_3;
  // H8 = R8^T I_link8 omega8 + p8~ l8: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t8_6 = T(0.003385566451939115) * omega8_1 - T(0.00016742735341238938) * omega8_3;
  const T t8_7 = T(0.003403441389465664) * omega8_2;
  const T t8_8 = T(4.385093752654867e-05) * omega8_3 - T(0.00016742735341238938) * omega8_1;
  const T H8_1 = R8_11 * t8_6 + R6_21 * t8_7 + R8_31 * t8_8 + p8_2 * l8_3 - p8_3 * l8_2;
  const T H8_2 = R8_12 * t8_6 + R6_22 * t8_7 + R8_32 * t8_8 + p8_3 * l8_1 - p8_1 * l8_3;
  const T H8_3 = R8_13 * t8_6 + R6_23 * t8_7 + R8_33 * t8_8 + p8_1 * l8_2 - p8_2 * l8_1;

  // ---- body 10 (rr_hip) on body 1
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];
  // R10^T = R1^T E10^T: R takes inertial components to body components
  const T R10_21 = R1_21 * E10_22 + R1_31 * E10_23;
  const T R10_22 = R1_22 * E10_22 + R1_32 * E10_23;
  const T R10_23 = R1_23 * E10_22 + R1_33 * E10_23;
  const T R10_31 = R1_31 * E10_22 - R1_21 * E10_23;
  const T R10_32 = R1_32 * E10_22 - R1_22 * E10_23;
  const T R10_33 = R1_33 * E10_22 - R1_23 * E10_23;
  // omega10 = thetadot10 b10 + E10 omega1: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = thetadot10 + omega1_1;
  const T omega10_2 = E10_22 * omega1_2 + E10_23 * omega1_3;
  const T omega10_3 = E10_22 * omega1_3 - E10_23 * omega1_2;
  // P10 = s1 + R1^T q10: position of the body origin, inertial axes [m]
  const T P10_1 = s1_1 - t6_1;
  const T P10_2 = s1_2 - t6_2;
  const T P10_3 = s1_3 - t6_3;
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_1 = t2_10 + P10_1 - R10_21 * T(0.000635) + R10_31 * T(3.1e-05);
  const T p10_2 = t2_11 + P10_2 - R10_22 * T(0.000635) + R10_32 * T(3.1e-05);
  const T p10_3 = t2_12 + P10_3 - R10_23 * T(0.000635) + R10_33 * T(3.1e-05);
  // Pdot10 = sdot1 + R1^T omega1~ q10: velocity of the body origin, inertial axes [m/s]
  const T Pdot10_1 = sdot1_1 - t6_5;
  const T Pdot10_2 = sdot1_2 - t6_6;
  const T Pdot10_3 = sdot1_3 - t6_7;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_1 = omega10_3 * T(0.000635) + omega10_2 * T(3.1e-05);
  const T t10_2 = omega10_3 * T(0.003311) - omega10_1 * T(3.1e-05);
  const T t10_3 = omega10_1 * T(0.000635) + omega10_2 * T(0.003311);
  const T v10_1 = Pdot10_1 + R1_11 * t10_1 + R10_21 * t10_2 - R10_31 * t10_3;
  const T v10_2 = Pdot10_2 + R1_12 * t10_1 + R10_22 * t10_2 - R10_32 * t10_3;
  const T v10_3 = Pdot10_3 + R1_13 * t10_1 + R10_23 * t10_2 - R10_33 * t10_3;
  // l10 = m10 v10: linear momentum, inertial axes [kg m/s]
  const T l10_1 = T(0.696) * v10_1;
  const T l10_2 = T(0.696) * v10_2;
  const T l10_3 = T(0.696) * v10_3;
  // H10 = R10^T I10 omega10 + p10~ l10: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t10_4 = T(0.000469246) * omega10_1 - T(9.409e-06) * omega10_2 + T(3.42e-07) * omega10_3;
  const T t10_5 = T(0.00080749) * omega10_2 - T(9.409e-06) * omega10_1 + T(4.66e-07) * omega10_3;
  const T t10_6 = T(3.42e-07) * omega10_1 + T(4.66e-07) * omega10_2 + T(0.000552929) * omega10_3;
  const T H10_1 = R1_11 * t10_4 + R10_21 * t10_5 + R10_31 * t10_6 + p10_2 * l10_3 - p10_3 * l10_2;
  const T H10_2 = R1_12 * t10_4 + R10_22 * t10_5 + R10_32 * t10_6 + p10_3 * l10_1 - p10_1 * l10_3;
  const T H10_3 = R1_13 * t10_4 + R10_23 * t10_5 + R10_33 * t10_6 + p10_1 * l10_2 - p10_2 * l10_1;

  // ---- body 11 (rr_thigh) on body 10
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R1_11 * E11_11 - R10_31 * minus_E11_13;
  const T R11_12 = R1_12 * E11_11 - R10_32 * minus_E11_13;
  const T R11_13 = R1_13 * E11_11 - R10_33 * minus_E11_13;
  const T R11_31 = R1_11 * minus_E11_13 + R10_31 * E11_11;
  const T R11_32 = R1_12 * minus_E11_13 + R10_32 * E11_11;
  const T R11_33 = R1_13 * minus_E11_13 + R10_33 * E11_11;
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 - minus_E11_13 * omega10_3;
  const T omega11_2 = thetadot11 + omega10_2;
  const T omega11_3 = minus_E11_13 * omega10_1 + E11_11 * omega10_3;
  // P11 = R10^T q11 + P10: position of the body origin, inertial axes [m]
  const T P11_1 = P10_1 - R10_21 * T(0.0838);
  const T P11_2 = P10_2 - R10_22 * T(0.0838);
  const T P11_3 = P10_3 - R10_23 * T(0.0838);
  // p11 = R11^T r11 + P11: position of the mass centre, inertial axes [m]
  const T p11_1 = P11_1 + R10_21 * T(0.022327) - R11_11 * T(0.003237) - R11_31 * T(0.027326);
  const T p11_2 = P11_2 + R10_22 * T(0.022327) - R11_12 * T(0.003237) - R11_32 * T(0.027326);
  const T p11_3 = P11_3 + R10_23 * T(0.022327) - R11_13 * T(0.003237) - R11_33 * T(0.027326);
  // Pdot11 = R10^T omega10~ q11 + Pdot10: velocity of the body origin, inertial axes [m/s]
  const T t11_1 = omega10_3 * T(0.0838);
  const T t11_2 = omega10_1 * T(0.0838);
  const T Pdot11_1 = Pdot10_1 + R1_11 * t11_1 - R10_31 * t11_2;
  const T Pdot11_2 = Pdot10_2 + R1_12 * t11_1 - R10_32 * t11_2;
  const T Pdot11_3 = Pdot10_3 + R1_13 * t11_1 - R10_33 * t11_2;
  // v11 = R11^T omega11~ r11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_3 = omega11_1 * T(0.027326) - omega11_3 * T(0.003237);
  const T t11_4 = omega11_3 * T(0.022327) + omega11_2 * T(0.027326);
  const T t11_5 = omega11_1 * T(0.022327) + omega11_2 * T(0.003237);
  const T v11_1 = Pdot11_1 + R10_21 * t11_3 - R11_11 * t11_4 + R11_31 * t11_5;
  const T v11_2 = Pdot11_2 + R10_22 * t11_3 - R11_12 * t11_4 + R11_32 * t11_5;
  const T v11_3 = Pdot11_3 + R10_23 * t11_3 - R11_13 * t11_4 + R11_33 * t11_5;
  // l11 = m11 v11: linear momentum, inertial axes [kg m/s]
  const T l11_1 = T(1.013) * v11_1;
  const T l11_2 = T(1.013) * v11_2;
  const T l11_3 = T(1.013) * v11_3;
  // H11 = R11^T I11 omega11 + p11~ l11: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t11_6 = T(0.005529065) * omega11_1 - T(4.825e-06) * omega11_2 + T(0.000343869) * omega11_3;
  const T t11_7 = T(0.005139339) * omega11_2 - T(4.825e-06) * omega11_1 - T(2.2448e-05) * omega11_3;
  const T t11_8 = T(0.000343869) * omega11_1 - T(2.2448e-05) * omega11_2 + T(0.001367788) * omega11_3;
  const T H11_1 = R11_11 * t11_6 + R10_21 * t11_7 + R11_31 * t11_8 + p11_2 * l11_3 - p11_3 * l11_2;
  const T H11_2 = R11_12 * t11_6 + R10_22 * t11_7 + R11_32 * t11_8 + p11_3 * l11_1 - p11_1 * l11_3;
  const T H11_3 = R11_13 * t11_6 + R10_23 * t11_7 + R11_33 * t11_8 + p11_1 * l11_2 - p11_2 * l11_1;

  // ---- body 12 (rr_calf) on body 11
  const T thetadot12 = y[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_11 = cosines[12];
  const T minus_E12_13 = sines[12];
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T R12_11 = R11_11 * E12_11 - R11_31 * minus_E12_13;
  const T R12_12 = R11_12 * E12_11 - R11_32 * minus_E12_13;
  const T R12_13 = R11_13 * E12_11 - R11_33 * minus_E12_13;
  const T R12_31 = R11_11 * minus_E12_13 + R11_31 * E12_11;
  const T R12_32 = R11_12 * minus_E12_13 + R11_32 * E12_11;
  const T R12_33 = R11_13 * minus_E12_13 + R11_33 * E12_11;
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T omega12_1 = E12_11 * omega11_1 - minus_E12_13 * omega11_3;
  const T omega12_2 = thetadot12 + omega11_2;
  const T omega12_3 = minus_E12_13 * omega11_1 + E12_11 * omega11_3;
  // P12 = R11^T q12 + P11: position of the body origin, inertial axes [m]
  const T P12_1 = P11_1 - R11_31 * T(0.2);
  const T P12_2 = P11_2 - R11_32 * T(0.2);
  const T P12_3 = P11_3 - R11_33 * T(0.2);
  // p12 = R12^T r_link12 + P12: position of the mass centre, inertial axes [m]
  const T p12_1 = P12_1 + R12_11 * T(0.004726592920353982) - R12_31 * T(0.13197525663716814);
  const T p12_2 = P12_2 + R12_12 * T(0.004726592920353982) - R12_32 * T(0.13197525663716814);
  const T p12_3 = P12_3 + R12_13 * T(0.004726592920353982) - R12_33 * T(0.13197525663716814);
  // Pdot12 = R11^T omega11~ q12 + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_1 = omega11_1 * T(0.2);
  const T t12_2 = omega11_2 * T(0.2);
  const T Pdot12_1 = Pdot11_1 + R10_21 * t12_1 - R11_11 * t12_2;
  const T Pdot12_2 = Pdot11_2 + R10_22 * t12_1 - R11_12 * t12_2;
  const T Pdot12_3 = Pdot11_3 + R10_23 * t12_1 - R11_13 * t12_2;
  // v12 = R12^T omega12~ r_link12 + Pdot12: velocity of the mass centre, inertial axes [m/s]
  const T t12_3 = omega12_3 * T(0.004726592920353982) + omega12_1 * T(0.13197525663716814);
  const T t12_4 = omega12_2 * T(0.13197525663716814);
  const T t12_5 = omega12_2 * T(0.004726592920353982);
  const T v12_1 = Pdot12_1 + R10_21 * t12_3 - R12_11 * t12_4 - R12_31 * t12_5;
  const T v12_2 = Pdot12_2 + R10_22 * t12_3 - R12_12 * t12_4 - R12_32 * t12_5;
  const T v12_3 = Pdot12_3 + R10_23 * t12_3 - R12_13 * t12_4 - R12_33 * t12_5;
  // l12 = m_link12 v12: linear momentum, inertial axes [kg m/s]
  const T l12_1 = T(0.226) * v12_1;
  const T l12_2 = T(0.226) * v12_2;
  const T l12_3 = T(0.226) * v12_3;
  // H12 = R12^T I_link12 omega12 + p12~ l12: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t12_6 = T(0.003385566451939115) * omega12_1 - T(0.00016742735341238938) * omega12_3;
  const T t12_7 = T(0.003403441389465664) * omega12_2;
  const T t12_8 = T(4.385093752654867e-05) * omega12_3 - T(0.00016742735341238938) * omega12_1;
  const T H12_1 = R12_11 * t12_6 + R10_21 * t12_7 + R12_31 * t12_8 + p12_2 * l12_3 - p12_3 * l12_2;
  const T H12_2 = R12_12 * t12_6 + R10_22 * t12_7 + R12_32 * t12_8 + p12_3 * l12_1 - p12_1 * l12_3;
  const T H12_3 = R12_13 * t12_6 + R10_23 * t12_7 + R12_33 * t12_8 + p12_1 * l12_2 - p12_2 * l12_1;

  // ---- body 14 (rl_hip) on body 1
  const T thetadot14 = y[12];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];
  // R14^T = R1^T E14^T: R takes inertial components to body components
  const T R14_21 = R1_21 * E14_22 + R1_31 * E14_23;
  const T R14_22 = R1_22 * E14_22 + R1_32 * E14_23;
  const T R14_23 = R1_23 * E14_22 + R1_33 * E14_23;
  const T R14_31 = R1_31 * E14_22 - R1_21 * E14_23;
  const T R14_32 = R1_32 * E14_22 - R1_22 * E14_23;
  const T R14_33 = R1_33 * E14_22 - R1_23 * E14_23;
  // omega14 = thetadot14 b14 + E14 omega1: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = thetadot14 + omega1_1;
  const T omega14_2 = E14_22 * omega1_2 + E14_23 * omega1_3;
  const T omega14_3 = E14_22 * omega1_3 - E14_23 * omega1_2;
  // P14 = s1 + R1^T q14: position of the body origin, inertial axes [m]
  const T P14_1 = s1_1 - t2_3;
  const T P14_2 = s1_2 - t2_6;
  const T P14_3 = s1_3 - t2_9;
  // p14 = R14^T r14 + P14: position of the mass centre, inertial axes [m]
  const T p14_1 = t2_10 + P14_1 + R14_21 * T(0.000635) + R14_31 * T(3.1e-05);
  const T p14_2 = t2_11 + P14_2 + R14_22 * T(0.000635) + R14_32 * T(3.1e-05);
  const T p14_3 = t2_12 + P14_3 + R14_23 * T(0.000635) + R14_33 * T(3.1e-05);
  // Pdot14 = sdot1 + R1^T omega1~ q14: velocity of the body origin, inertial axes [m/s]
  const T Pdot14_1 = sdot1_1 - t2_20;
  const T Pdot14_2 = sdot1_2 - t2_23;
  const T Pdot14_3 = sdot1_3 - t2_26;
  // v14 = R14^T omega14~ r14 + Pdot14: velocity of the mass centre, inertial axes [m/s]
  const T t14_1 = omega14_2 * T(3.1e-05) - omega14_3 * T(0.000635);
  const T t14_2 = omega14_3 * T(0.003311) - omega14_1 * T(3.1e-05);
  const T t14_3 = omega14_1 * T(0.000635) - omega14_2 * T(0.003311);
  const T v14_1 = Pdot14_1 + R1_11 * t14_1 + R14_21 * t14_2 + R14_31 * t14_3;
  const T v14_2 = Pdot14_2 + R1_12 * t14_1 + R14_22 * t14_2 + R14_32 * t14_3;
  const T v14_3 = Pdot14_3 + R1_13 * t14_1 + R14_23 * t14_2 + R14_33 * t14_3;
  // l14 = m14 v14: linear momentum, inertial axes [kg m/s]
  const T l14_1 = T(0.696) * v14_1;
  const T l14_2 = T(0.696) * v14_2;
  const T l14_3 = T(0.696) * v14_3;
  // H14 = R14^T I14 omega14 + p14~ l14: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t14_4 = T(0.000469246) * omega14_1 + T(9.409e-06) * omega14_2 + T(3.42e-07) * omega14_3;
  const T t14_5 = T(9.409e-06) * omega14_1 + T(0.00080749) * omega14_2 - T(4.66e-07) * omega14_3;
  const T t14_6 = T(3.42e-07) * omega14_1 - T(4.66e-07) * omega14_2 + T(0.000552929) * omega14_3;
  const T H14_1 = R1_11 * t14_4 + R14_21 * t14_5 + R14_31 * t14_6 + p14_2 * l14_3 - p14_3 * l14_2;
  const T H14_2 = R1_12 * t14_4 + R14_22 * t14_5 + R14_32 * t14_6 + p14_3 * l14_1 - p14_1 * l14_3;
  const T H14_3 = R1_13 * t14_4 + R14_23 * t14_5 + R14_33 * t14_6 + p14_1 * l14_2 - p14_2 * l14_1;

  // ---- body 15 (rl_thigh) on body 14
  const T thetadot15 = y[13];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_11 = R1_11 * E15_11 - R14_31 * minus_E15_13;
  const T R15_12 = R1_12 * E15_11 - R14_32 * minus_E15_13;
  const T R15_13 = R1_13 * E15_11 - R14_33 * minus_E15_13;
  const T R15_31 = R1_11 * minus_E15_13 + R14_31 * E15_11;
  const T R15_32 = R1_12 * minus_E15_13 + R14_32 * E15_11;
  const T R15_33 = R1_13 * minus_E15_13 + R14_33 * E15_11;
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = E15_11 * omega14_1 - minus_E15_13 * omega14_3;
  const T omega15_2 = thetadot15 + omega14_2;
  const T omega15_3 = minus_E15_13 * omega14_1 + E15_11 * omega14_3;
  // P15 = R14^T q15 + P14: position of the body origin, inertial axes [m]
  const T P15_1 = P14_1 + R14_21 * T(0.0838);
  const T P15_2 = P14_2 + R14_22 * T(0.0838);
  const T P15_3 = P14_3 + R14_23 * T(0.0838);
  // p15 = R15^T r15 + P15: position of the mass centre, inertial axes [m]
  const T p15_1 = P15_1 - R15_11 * T(0.003237) - R14_21 * T(0.022327) - R15_31 * T(0.027326);
  const T p15_2 = P15_2 - R15_12 * T(0.003237) - R14_22 * T(0.022327) - R15_32 * T(0.027326);
  const T p15_3 = P15_3 - R15_13 * T(0.003237) - R14_23 * T(0.022327) - R15_33 * T(0.027326);
  // Pdot15 = R14^T omega14~ q15 + Pdot14: velocity of the body origin, inertial axes [m/s]
  const T t15_1 = omega14_1 * T(0.0838);
  const T t15_2 = omega14_3 * T(0.0838);
  const T Pdot15_1 = Pdot14_1 + R14_31 * t15_1 - R1_11 * t15_2;
  const T Pdot15_2 = Pdot14_2 + R14_32 * t15_1 - R1_12 * t15_2;
  const T Pdot15_3 = Pdot14_3 + R14_33 * t15_1 - R1_13 * t15_2;
  // v15 = R15^T omega15~ r15 + Pdot15: velocity of the mass centre, inertial axes [m/s]
  const T t15_3 = omega15_3 * T(0.022327) - omega15_2 * T(0.027326);
  const T t15_4 = omega15_1 * T(0.027326) - omega15_3 * T(0.003237);
  const T t15_5 = omega15_2 * T(0.003237) - omega15_1 * T(0.022327);
  const T v15_1 = Pdot15_1 + R15_11 * t15_3 + R14_21 * t15_4 + R15_31 * t15_5;
  const T v15_2 = Pdot15_2 + R15_12 * t15_3 + R14_22 * t15_4 + R15_32 * t15_5;
  const T v15_3 = Pdot15_3 + R15_13 * t15_3 + R14_23 * t15_4 + R15_33 * t15_5;
  // l15 = m15 v15: linear momentum, inertial axes [kg m/s]
  const T l15_1 = T(1.013) * v15_1;
  const T l15_2 = T(1.013) * v15_2;
  const T l15_3 = T(1.013) * v15_3;
  // H15 = R15^T I15 omega15 + p15~ l15: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t15_6 = T(0.005529065) * omega15_1 + T(4.825e-06) * omega15_2 + T(0.000343869) * omega15_3;
  const T t15_7 = T(4.825e-06) * omega15_1 + T(0.005139339) * omega15_2 + T(2.2448e-05) * omega15_3;
  const T t15_8 = T(0.000343869) * omega15_1 + T(2.2448e-05) * omega15_2 + T(0.001367788) * omega15_3;
  const T H15_1 = R15_11 * t15_6 + R14_21 * t15_7 + R15_31 * t15_8 + p15_2 * l15_3 - p15_3 * l15_2;
  const T H15_2 = R15_12 * t15_6 + R14_22 * t15_7 + R15_32 * t15_8 + p15_3 * l15_1 - p15_1 * l15_3;
  const T H15_3 = R15_13 * t15_6 + R14_23 * t15_7 + R15_33 * t15_8 + p15_1 * l15_2 - p15_2 * l15_1;

  // ---- body 16 (rl_calf) on body 15
  const T thetadot16 = y[14];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cosines[15];
  const T minus_E16_13 = sines[15];
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T R16_11 = R15_11 * E16_11 - R15_31 * minus_E16_13;
  const T R16_12 = R15_12 * E16_11 - R15_32 * minus_E16_13;
  const T R16_13 = R15_13 * E16_11 - R15_33 * minus_E16_13;
  const T R16_31 = R15_11 * minus_E16_13 + R15_31 * E16_11;
  const T R16_32 = R15_12 * minus_E16_13 + R15_32 * E16_11;
  const T R16_33 = R15_13 * minus_E16_13 + R15_33 * E16_11;
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T omega16_1 = E16_11 * omega15_1 - minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 + E16_11 * omega15_3;
  // P16 = R15^T q16 + P15: position of the body origin, inertial axes [m]
  const T P16_1 = P15_1 - R15_31 * T(0.2);
  const T P16_2 = P15_2 - R15_32 * T(0.2);
  const T P16_3 = P15_3 - R15_33 * T(0.2);
  // p16 = R16^T r_link16 + P16: position of the mass centre, inertial axes [m]
  const T p16_1 = P16_1 + R16_11 * T(0.004726592920353982) - R16_31 * T(0.13197525663716814);
  const T p16_2 = P16_2 + R16_12 * T(0.004726592920353982) - R16_32 * T(0.13197525663716814);
  const T p16_3 = P16_3 + R16_13 * T(0.004726592920353982) - R16_33 * T(0.13197525663716814);
  // Pdot16 = R15^T omega15~ q16 + Pdot15: velocity of the body origin, inertial axes [m/s]
  const T t16_1 = omega15_1 * T(0.2);
  const T t16_2 = omega15_2 * T(0.2);
  const T Pdot16_1 = Pdot15_1 + R14_21 * t16_1 - R15_11 * t16_2;
  const T Pdot16_2 = Pdot15_2 + R14_22 * t16_1 - R15_12 * t16_2;
  const T Pdot16_3 = Pdot15_3 + R14_23 * t16_1 - R15_13 * t16_2;
  // v16 = R16^T omega16~ r_link16 + Pdot16: velocity of the mass centre, inertial axes [m/s]
  const T t16_3 = omega16_3 * T(0.004726592920353982) + omega16_1 * T(0.13197525663716814);
  const T t16_4 = omega16_2 * T(0.13197525663716814);
  const T t16_5 = omega16_2 * T(0.004726592920353982);
  const T v16_1 = Pdot16_1 + R14_21 * t16_3 - R16_11 * t16_4 - R16_31 * t16_5;
  const T v16_2 = Pdot16_2 + R14_22 * t16_3 - R16_12 * t16_4 - R16_32 * t16_5;
  const T v16_3 = Pdot16_3 + R14_23 * t16_3 - R16_13 * t16_4 - R16_33 * t16_5;
  // l16 = m_link16 v16: linear momentum, inertial axes [kg m/s]
  const T l16_1 = T(0.226) * v16_1;
  const T l16_2 = T(0.226) * v16_2;
  const T l16_3 = T(0.226) * v16_3;
  // H16 = R16^T I_link16 omega16 + p16~ l16: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t16_6 = T(0.003385566451939115) * omega16_1 - T(0.00016742735341238938) * omega16_3;
  const T t16_7 = T(0.003403441389465664) * omega16_2;
  const T t16_8 = T(4.385093752654867e-05) * omega16_3 - T(0.00016742735341238938) * omega16_1;
  const T H16_1 = R16_11 * t16_6 + R14_21 * t16_7 + R16_31 * t16_8 + p16_2 * l16_3 - p16_3 * l16_2;
  const T H16_2 = R16_12 * t16_6 + R14_22 * t16_7 + R16_32 * t16_8 + p16_3 * l16_1 - p16_1 * l16_3;
  const T H16_3 = R16_13 * t16_6 + R14_23 * t16_7 + R16_33 * t16_8 + p16_1 * l16_2 - p16_2 * l16_1;

  // ---- whole system
  // linear = l1 + l2 + l3 + l4 + l6 + l7 + l8 + l10 + l11 + l12 + l14 + l15 + l16: linear momentum of the system [kg
  //   m/s]
  const T linear_1 = l1_1 + l2_1 + l3_1 + l4_1 + l6_1 + l7_1 + l8_1 + l10_1 + l11_1 + l12_1 + l14_1 + l15_1 + l16_1;
  const T linear_2 = l1_2 + l2_2 + l3_2 + l4_2 + l6_2 + l7_2 + l8_2 + l10_2 + l11_2 + l12_2 + l14_2 + l15_2 + l16_2;
  const T linear_3 = l1_3 + l2_3 + l3_3 + l4_3 + l6_3 + l7_3 + l8_3 + l10_3 + l11_3 + l12_3 + l14_3 + l15_3 + l16_3;
  momentum[0] = linear_1;
  momentum[1] = linear_2;
  momentum[2] = linear_3;
  // angular = H1 + H2 + H3 + H4 + H6 + H7 + H8 + H10 + H11 + H12 + H14 + H15 + H16: angular momentum of the system
  //   about the inertial origin [kg m^2/s]
  const T angular_1 = H1_1 + H2_1 + H3_1 + H4_1 + H6_1 + H7_1 + H8_1 + H10_1 + H11_1 + H12_1 + H14_1 + H15_1 + H16_1;
  const T angular_2 = H1_2 + H2_2 + H3_2 + H4_2 + H6_2 + H7_2 + H8_2 + H10_2 + H11_2 + H12_2 + H14_2 + H15_2 + H16_2;
  const T angular_3 = H1_3 + H2_3 + H3_3 + H4_3 + H6_3 + H7_3 + H8_3 + H10_3 + H11_3 + H12_3 + H14_3 + H15_3 + H16_3;
  momentum[3] = angular_1;
  momentum[4] = angular_2;
  momentum[5] = angular_3;
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 236 add, 320 multiply, 24 sine or cosine
template <class T>
void power(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* out) noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
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

  // ---- body 2 (fr_hip) on body 1
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T thetadot2 = y[3];
  const T sdot1_1 = y[15], sdot1_2 = y[16], sdot1_3 = y[17];
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
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_1 = omega1_3 * T(0.047);
  const T t2_2 = R1_11 * t2_1;
  const T t2_3 = omega1_3 * T(0.1805);
  const T t2_4 = R1_21 * t2_3;
  const T t2_5 = omega1_1 * T(0.047);
  const T t2_6 = omega1_2 * T(0.1805);
  const T t2_7 = t2_5 + t2_6;
  const T t2_8 = t2_2 + t2_4 - R1_31 * t2_7;
  const T Pdot2_1 = sdot1_1 + t2_8;
  const T t2_9 = R1_12 * t2_1;
  const T t2_10 = R1_22 * t2_3;
  const T t2_11 = t2_9 + t2_10 - R1_32 * t2_7;
  const T Pdot2_2 = sdot1_2 + t2_11;
  const T t2_12 = R1_13 * t2_1;
  const T t2_13 = R1_23 * t2_3;
  const T t2_14 = t2_12 + t2_13 - R1_33 * t2_7;
  const T Pdot2_3 = sdot1_3 + t2_14;
  // damping_fr_hip_2 = -thetadot2 c_fr_hip_ + tau_fr_hip_: along the coordinate [N m], [N]
  const T damping_fr_hip_2 = u.tau_fr_hip - thetadot2 * c.p.kd;

  // ---- body 3 (fr_thigh) on body 2
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 - R2_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 - R2_33 * minus_E3_13;
  const T R3_31 = R1_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R1_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = R1_13 * minus_E3_13 + R2_33 * E3_11;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega2_1 - minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + omega2_2;
  const T omega3_3 = minus_E3_13 * omega2_1 + E3_11 * omega2_3;
  // Pdot3 = R2^T omega2~ q3 + Pdot2: velocity of the body origin, inertial axes [m/s]
  const T t3_1 = omega2_3 * T(0.0838);
  const T t3_2 = omega2_1 * T(0.0838);
  const T Pdot3_1 = Pdot2_1 + R1_11 * t3_1 - R2_31 * t3_2;
  const T Pdot3_2 = Pdot2_2 + R1_12 * t3_1 - R2_32 * t3_2;
  const T Pdot3_3 = Pdot2_3 + R1_13 * t3_1 - R2_33 * t3_2;
  // damping_fr_thigh_3 = -thetadot3 c_fr_thigh_ + tau_fr_thigh_: along the coordinate [N m], [N]
  const T damping_fr_thigh_3 = u.tau_fr_thigh - thetadot3 * c.p.kd;

  // ---- body 4 (fr_calf) on body 3
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - R3_31 * minus_E4_13;
  const T R4_12 = R3_12 * E4_11 - R3_32 * minus_E4_13;
  const T R4_13 = R3_13 * E4_11 - R3_33 * minus_E4_13;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 - minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  // Pdot4 = R3^T omega3~ q4 + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t4_1 = omega3_1 * T(0.2);
  const T t4_2 = omega3_2 * T(0.2);
  const T Pdot4_1 = Pdot3_1 + R2_21 * t4_1 - R3_11 * t4_2;
  const T Pdot4_2 = Pdot3_2 + R2_22 * t4_1 - R3_12 * t4_2;
  const T Pdot4_3 = Pdot3_3 + R2_23 * t4_1 - R3_13 * t4_2;
  // damping_fr_calf_4 = -thetadot4 c_fr_calf_ + tau_fr_calf_: along the coordinate [N m], [N]
  const T damping_fr_calf_4 = u.tau_fr_calf - thetadot4 * c.p.kd;

  // ---- body 6 (fl_hip) on body 1
  const T thetadot6 = y[6];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];
  // R6^T = R1^T E6^T: R takes inertial components to body components
  const T R6_21 = R1_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R1_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R1_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R1_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R1_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R1_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega1: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega1_1;
  const T omega6_2 = E6_22 * omega1_2 + E6_23 * omega1_3;
  const T omega6_3 = E6_22 * omega1_3 - E6_23 * omega1_2;
  // Pdot6 = sdot1 + R1^T omega1~ q6: velocity of the body origin, inertial axes [m/s]
  const T t6_1 = t2_5 - t2_6;
  const T t6_2 = t2_4 - t2_2 + R1_31 * t6_1;
  const T Pdot6_1 = sdot1_1 + t6_2;
  const T t6_3 = t2_10 - t2_9 + R1_32 * t6_1;
  const T Pdot6_2 = sdot1_2 + t6_3;
  const T t6_4 = t2_13 - t2_12 + R1_33 * t6_1;
  const T Pdot6_3 = sdot1_3 + t6_4;
  // damping_fl_hip_6 = -thetadot6 c_fl_hip_ + tau_fl_hip_: along the coordinate [N m], [N]
  const T damping_fl_hip_6 = u.tau_fl_hip - thetadot6 * c.p.kd;

  // ---- body 7 (fl_thigh) on body 6
  const T thetadot7 = y[7];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R1_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R1_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R1_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R1_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R1_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R1_13 * minus_E7_13 + R6_33 * E7_11;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // Pdot7 = R6^T omega6~ q7 + Pdot6: velocity of the body origin, inertial axes [m/s]
  const T t7_1 = omega6_1 * T(0.0838);
  const T t7_2 = omega6_3 * T(0.0838);
  const T Pdot7_1 = Pdot6_1 + R6_31 * t7_1 - R1_11 * t7_2;
  const T Pdot7_2 = Pdot6_2 + R6_32 * t7_1 - R1_12 * t7_2;
  const T Pdot7_3 = Pdot6_3 + R6_33 * t7_1 - R1_13 * t7_2;
  // damping_fl_thigh_7 = -thetadot7 c_fl_thigh_ + tau_fl_thigh_: along the coordinate [N m], [N]
  const T damping_fl_thigh_7 = u.tau_fl_thigh - thetadot7 * c.p.kd;

  // ---- body 8 (fl_calf) on body 7
  const T thetadot8 = y[8];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[9];
  const T minus_E8_13 = sines[9];
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T R8_11 = R7_11 * E8_11 - R7_31 * minus_E8_13;
  const T R8_12 = R7_12 * E8_11 - R7_32 * minus_E8_13;
  const T R8_13 = R7_13 * E8_11 - R7_33 * minus_E8_13;
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega7_1 - minus_E8_13 * omega7_3;
  const T omega8_2 = thetadot8 + omega7_2;
  // Pdot8 = R7^T omega7~ q8 + Pdot7: velocity of the body origin, inertial axes [m/s]
  const T t8_1 = omega7_1 * T(0.2);
  const T t8_2 = omega7_2 * T(0.2);
  const T Pdot8_1 = Pdot7_1 + R6_21 * t8_1 - R7_11 * t8_2;
  const T Pdot8_2 = Pdot7_2 + R6_22 * t8_1 - R7_12 * t8_2;
  const T Pdot8_3 = Pdot7_3 + R6_23 * t8_1 - R7_13 * t8_2;
  // damping_fl_calf_8 = -thetadot8 c_fl_calf_ + tau_fl_calf_: along the coordinate [N m], [N]
  const T damping_fl_calf_8 = u.tau_fl_calf - thetadot8 * c.p.kd;

  // ---- body 10 (rr_hip) on body 1
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];
  // R10^T = R1^T E10^T: R takes inertial components to body components
  const T R10_21 = R1_21 * E10_22 + R1_31 * E10_23;
  const T R10_22 = R1_22 * E10_22 + R1_32 * E10_23;
  const T R10_23 = R1_23 * E10_22 + R1_33 * E10_23;
  const T R10_31 = R1_31 * E10_22 - R1_21 * E10_23;
  const T R10_32 = R1_32 * E10_22 - R1_22 * E10_23;
  const T R10_33 = R1_33 * E10_22 - R1_23 * E10_23;
  // omega10 = thetadot10 b10 + E10 omega1: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = thetadot10 + omega1_1;
  const T omega10_2 = E10_22 * omega1_2 + E10_23 * omega1_3;
  const T omega10_3 = E10_22 * omega1_3 - E10_23 * omega1_2;
  // Pdot10 = sdot1 + R1^T omega1~ q10: velocity of the body origin, inertial axes [m/s]
  const T Pdot10_1 = sdot1_1 - t6_2;
  const T Pdot10_2 = sdot1_2 - t6_3;
  const T Pdot10_3 = sdot1_3 - t6_4;
  // damping_rr_hip_10 = -thetadot10 c_rr_hip_ + tau_rr_hip_: along the coordinate [N m], [N]
  const T damping_rr_hip_10 = u.tau_rr_hip - thetadot10 * c.p.kd;

  // ---- body 11 (rr_thigh) on body 10
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R1_11 * E11_11 - R10_31 * minus_E11_13;
  const T R11_12 = R1_12 * E11_11 - R10_32 * minus_E11_13;
  const T R11_13 = R1_13 * E11_11 - R10_33 * minus_E11_13;
  const T R11_31 = R1_11 * minus_E11_13 + R10_31 * E11_11;
  const T R11_32 = R1_12 * minus_E11_13 + R10_32 * E11_11;
  const T R11_33 = R1_13 * minus_E11_13 + R10_33 * E11_11;
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 - minus_E11_13 * omega10_3;
  const T omega11_2 = thetadot11 + omega10_2;
  const T omega11_3 = minus_E11_13 * omega10_1 + E11_11 * omega10_3;
  // Pdot11 = R10^T omega10~ q11 + Pdot10: velocity of the body origin, inertial axes [m/s]
  const T t11_1 = omega10_3 * T(0.0838);
  const T t11_2 = omega10_1 * T(0.0838);
  const T Pdot11_1 = Pdot10_1 + R1_11 * t11_1 - R10_31 * t11_2;
  const T Pdot11_2 = Pdot10_2 + R1_12 * t11_1 - R10_32 * t11_2;
  const T Pdot11_3 = Pdot10_3 + R1_13 * t11_1 - R10_33 * t11_2;
  // damping_rr_thigh_11 = -thetadot11 c_rr_thigh_ + tau_rr_thigh_: along the coordinate [N m], [N]
  const T damping_rr_thigh_11 = u.tau_rr_thigh - thetadot11 * c.p.kd;

  // ---- body 12 (rr_calf) on body 11
  const T thetadot12 = y[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_11 = cosines[12];
  const T minus_E12_13 = sines[12];
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T R12_11 = R11_11 * E12_11 - R11_31 * minus_E12_13;
  const T R12_12 = R11_12 * E12_11 - R11_32 * minus_E12_13;
  const T R12_13 = R11_13 * E12_11 - R11_33 * minus_E12_13;
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T omega12_1 = E12_11 * omega11_1 - minus_E12_13 * omega11_3;
  const T omega12_2 = thetadot12 + omega11_2;
  // Pdot12 = R11^T omega11~ q12 + Pdot11: velocity of the body origin, inertial axes [m/s]
  const T t12_1 = omega11_1 * T(0.2);
  const T t12_2 = omega11_2 * T(0.2);
  const T Pdot12_1 = Pdot11_1 + R10_21 * t12_1 - R11_11 * t12_2;
  const T Pdot12_2 = Pdot11_2 + R10_22 * t12_1 - R11_12 * t12_2;
  const T Pdot12_3 = Pdot11_3 + R10_23 * t12_1 - R11_13 * t12_2;
  // damping_rr_calf_12 = -thetadot12 c_rr_calf_ + tau_rr_calf_: along the coordinate [N m], [N]
  const T damping_rr_calf_12 = u.tau_rr_calf - thetadot12 * c.p.kd;

  // ---- body 14 (rl_hip) on body 1
  const T thetadot14 = y[12];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];
  // R14^T = R1^T E14^T: R takes inertial components to body components
  const T R14_21 = R1_21 * E14_22 + R1_31 * E14_23;
  const T R14_22 = R1_22 * E14_22 + R1_32 * E14_23;
  const T R14_23 = R1_23 * E14_22 + R1_33 * E14_23;
  const T R14_31 = R1_31 * E14_22 - R1_21 * E14_23;
  const T R14_32 = R1_32 * E14_22 - R1_22 * E14_23;
  const T R14_33 = R1_33 * E14_22 - R1_23 * E14_23;
  // omega14 = thetadot14 b14 + E14 omega1: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = thetadot14 + omega1_1;
  const T omega14_2 = E14_22 * omega1_2 + E14_23 * omega1_3;
  const T omega14_3 = E14_22 * omega1_3 - E14_23 * omega1_2;
  // Pdot14 = sdot1 + R1^T omega1~ q14: velocity of the body origin, inertial axes [m/s]
  const T Pdot14_1 = sdot1_1 - t2_8;
  const T Pdot14_2 = sdot1_2 - t2_11;
  const T Pdot14_3 = sdot1_3 - t2_14;
  // damping_rl_hip_14 = -thetadot14 c_rl_hip_ + tau_rl_hip_: along the coordinate [N m], [N]
  const T damping_rl_hip_14 = u.tau_rl_hip - thetadot14 * c.p.kd;

  // ---- body 15 (rl_thigh) on body 14
  const T thetadot15 = y[13];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_11 = R1_11 * E15_11 - R14_31 * minus_E15_13;
  const T R15_12 = R1_12 * E15_11 - R14_32 * minus_E15_13;
  const T R15_13 = R1_13 * E15_11 - R14_33 * minus_E15_13;
  const T R15_31 = R1_11 * minus_E15_13 + R14_31 * E15_11;
  const T R15_32 = R1_12 * minus_E15_13 + R14_32 * E15_11;
  const T R15_33 = R1_13 * minus_E15_13 + R14_33 * E15_11;
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = E15_11 * omega14_1 - minus_E15_13 * omega14_3;
  const T omega15_2 = thetadot15 + omega14_2;
  const T omega15_3 = minus_E15_13 * omega14_1 + E15_11 * omega14_3;
  // Pdot15 = R14^T omega14~ q15 + Pdot14: velocity of the body origin, inertial axes [m/s]
  const T t15_1 = omega14_1 * T(0.0838);
  const T t15_2 = omega14_3 * T(0.0838);
  const T Pdot15_1 = Pdot14_1 + R14_31 * t15_1 - R1_11 * t15_2;
  const T Pdot15_2 = Pdot14_2 + R14_32 * t15_1 - R1_12 * t15_2;
  const T Pdot15_3 = Pdot14_3 + R14_33 * t15_1 - R1_13 * t15_2;
  // damping_rl_thigh_15 = -thetadot15 c_rl_thigh_ + tau_rl_thigh_: along the coordinate [N m], [N]
  const T damping_rl_thigh_15 = u.tau_rl_thigh - thetadot15 * c.p.kd;

  // ---- body 16 (rl_calf) on body 15
  const T thetadot16 = y[14];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cosines[15];
  const T minus_E16_13 = sines[15];
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T R16_11 = R15_11 * E16_11 - R15_31 * minus_E16_13;
  const T R16_12 = R15_12 * E16_11 - R15_32 * minus_E16_13;
  const T R16_13 = R15_13 * E16_11 - R15_33 * minus_E16_13;
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T omega16_1 = E16_11 * omega15_1 - minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  // Pdot16 = R15^T omega15~ q16 + Pdot15: velocity of the body origin, inertial axes [m/s]
  const T t16_1 = omega15_1 * T(0.2);
  const T t16_2 = omega15_2 * T(0.2);
  const T Pdot16_1 = Pdot15_1 + R14_21 * t16_1 - R15_11 * t16_2;
  const T Pdot16_2 = Pdot15_2 + R14_22 * t16_1 - R15_12 * t16_2;
  const T Pdot16_3 = Pdot15_3 + R14_23 * t16_1 - R15_13 * t16_2;
  // damping_rl_calf_16 = -thetadot16 c_rl_calf_ + tau_rl_calf_: along the coordinate [N m], [N]
  const T damping_rl_calf_16 = u.tau_rl_calf - thetadot16 * c.p.kd;

  // ---- whole system
  // power = thetadot2 damping_fr_hip_2 + thetadot3 damping_fr_thigh_3 + thetadot4 damping_fr_calf_4 + thetadot6
  //   damping_fl_hip_6 + thetadot7 damping_fl_thigh_7 + thetadot8 damping_fl_calf_8 + thetadot10 damping_rr_hip_10 +
  //   thetadot11 damping_rr_thigh_11 + thetadot12 damping_rr_calf_12 + thetadot14 damping_rl_hip_14 + thetadot15
  //   damping_rl_thigh_15 + thetadot16 damping_rl_calf_16 + F_ground_on_fr_ . (R4^T omega4~ o5 + Pdot4) +
  //   F_ground_on_fl_ . (R8^T omega8~ o9 + Pdot8) + F_ground_on_rr_ . (R12^T omega12~ o13 + Pdot12) + F_ground_on_rl_
  //   . (R16^T omega16~ o17 + Pdot16): power of the applied loads [W]
  const T b0_1 = omega4_1 * T(0.2);
  const T b0_2 = omega4_2 * T(0.2);
  const T b0_3 = omega8_1 * T(0.2);
  const T b0_4 = omega8_2 * T(0.2);
  const T b0_5 = omega12_1 * T(0.2);
  const T b0_6 = omega12_2 * T(0.2);
  const T b0_7 = omega16_1 * T(0.2);
  const T b0_8 = omega16_2 * T(0.2);
  const T power = thetadot2 * damping_fr_hip_2 + thetadot3 * damping_fr_thigh_3 + thetadot4 * damping_fr_calf_4 +
      thetadot6 * damping_fl_hip_6 + thetadot7 * damping_fl_thigh_7 + thetadot8 * damping_fl_calf_8 + thetadot10 *
      damping_rr_hip_10 + thetadot11 * damping_rr_thigh_11 + thetadot12 * damping_rr_calf_12 + thetadot14 *
      damping_rl_hip_14 + thetadot15 * damping_rl_thigh_15 + thetadot16 * damping_rl_calf_16 + u.ground_fr_x *
      (Pdot4_1 + R2_21 * b0_1 - R4_11 * b0_2) + u.ground_fr_y * (Pdot4_2 + R2_22 * b0_1 - R4_12 * b0_2) +
      u.ground_fr_z * (Pdot4_3 + R2_23 * b0_1 - R4_13 * b0_2) + u.ground_fl_x * (Pdot8_1 + R6_21 * b0_3 - R8_11 *
      b0_4) + u.ground_fl_y * (Pdot8_2 + R6_22 * b0_3 - R8_12 * b0_4) + u.ground_fl_z * (Pdot8_3 + R6_23 * b0_3 -
      R8_13 * b0_4) + u.ground_rr_x * (Pdot12_1 + R10_21 * b0_5 - R12_11 * b0_6) + u.ground_rr_y * (Pdot12_2 + R10_22
      * b0_5 - R12_12 * b0_6) + u.ground_rr_z * (Pdot12_3 + R10_23 * b0_5 - R12_13 * b0_6) + u.ground_rl_x * (Pdot16_1
      + R14_21 * b0_7 - R16_11 * b0_8) + u.ground_rl_y * (Pdot16_2 + R14_22 * b0_7 - R16_12 * b0_8) + u.ground_rl_z *
      (Pdot16_3 + R14_23 * b0_7 - R16_13 * b0_8);
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 1514 add, 1674 multiply, 14 divide, 24 sine or cosine
// by: articulated; composite would take 1640 add, 1892 multiply, 14 divide, 24 sine or cosine
template <class T>
void accelerations(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot) noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
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
  // G1 = -U1 h_all_1: applied less inertia force, body axes [N]
  const T minus_G1_1 = U1_12 * c.h_all_1_2 - U1_13 * c.c1_2;
  const T G1_2 = minus_U1_22 * c.h_all_1_2 + U1_23 * c.c1_2;
  const T minus_G1_3 = U1_23 * c.h_all_1_2 + minus_U1_33 * c.c1_2;
  // N1 = -omega1~ J_all_1 omega1: applied less inertia moment about the body origin, body axes [N m]
  const T minus_N1_1 = c.c1_3 * U1_23 + c.J_all_1_23 * (t1_15 - t1_13) - T(6.11e-05) * U1_12 + T(3.66e-05) * U1_13;
  const T minus_N1_2 = c.c1_4 * U1_13 - T(6.11e-05) * (t1_13 - t1_14) - T(3.66e-05) * U1_23 - c.J_all_1_23 * U1_12;
  const T minus_N1_3 = c.c1_5 * U1_12 - T(3.66e-05) * (t1_14 - t1_15) + c.J_all_1_23 * U1_13 + T(6.11e-05) * U1_23;

  // ---- body 2 (fr_hip) on body 1
  const T theta2 = x[4];
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
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_2 = thetadot2 * omega2_3;
  const T minus_omegadot2_3 = thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_3 * omega2_3;
  const T t2_2 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_1 + t2_2;
  const T t2_3 = omega2_2 * omega2_1;
  const T U2_12 = t2_3 + minus_omegadot2_3;
  const T t2_4 = omega2_3 * omega2_1;
  const T U2_13 = t2_4 + omegadot2_2;
  const T U2_21 = t2_3 - minus_omegadot2_3;
  const T t2_5 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_1 + t2_5;
  const T U2_23 = omega2_3 * omega2_2;
  const T U2_31 = t2_4 - omegadot2_2;
  const T minus_U2_33 = t2_2 + t2_5;
  // Pddot2 = E2 U1 q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = U1_12 * T(0.047);
  const T t2_6 = minus_U1_22 * T(0.047);
  const T t2_7 = U1_23 * T(0.047);
  const T Pddot2_2 = E2_22 * t2_6 - E2_23 * t2_7;
  const T minus_Pddot2_3 = E2_23 * t2_6 + E2_22 * t2_7;
  // effort_fr_hip_2 = -theta2 k_fr_hip_ - thetadot2 c_fr_hip_ + tau_fr_hip_: along the coordinate [N m], [N]
  const T effort_fr_hip_2 = u.tau_fr_hip - theta2 * c.p.kp - thetadot2 * c.p.kd;
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_13 * T(2.1575999999999998e-05) - U2_12 * T(0.081652909);
  const T minus_G2_2 = minus_U2_22 * T(0.081652909) + U2_23 * T(2.1575999999999998e-05);
  const T G2_3 = U2_23 * T(0.081652909) + minus_U2_33 * T(2.1575999999999998e-05);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(0.081652909) * minus_Pddot2_3 - T(2.1575999999999998e-05) * Pddot2_2 +
      T(0.006599357548829661) * U2_23 - T(4.7970076e-07) * (minus_U2_22 - minus_U2_33) - T(0.014746295744939998) *
      U2_31 - T(4.165029864e-06) * U2_21;
  const T t2_8 = T(2.1575999999999998e-05) * minus_Pddot2_1;
  const T minus_N2_2 = T(0.000361904168856) * U2_13 - t2_8 + T(0.000361904168856) * U2_31 + T(4.165029864e-06) *
      (minus_U2_33 - minus_U2_11) - T(4.7970076e-07) * U2_12 + T(0.014746295744939998) * U2_23;
  const T t2_9 = T(0.081652909) * minus_Pddot2_1;
  const T minus_N2_3 = T(4.165029864e-06) * U2_23 - (t2_9 + T(0.000361904168856) * U2_21 + T(0.006961261717685661) *
      U2_12 + T(0.014746295744939998) * (minus_U2_11 - minus_U2_22)) + T(4.7970076e-07) * U2_13;

  // ---- body 3 (fr_thigh) on body 2
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 - R2_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 - R2_33 * minus_E3_13;
  const T R3_31 = R1_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R1_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = R1_13 * minus_E3_13 + R2_33 * E3_11;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega2_1 - minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + omega2_2;
  const T omega3_3 = minus_E3_13 * omega2_1 + E3_11 * omega2_3;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = minus_E3_13 * minus_omegadot2_3 - thetadot3 * omega3_3;
  const T omegadot3_3 = thetadot3 * omega3_1 - E3_11 * minus_omegadot2_3;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_3 * omega3_3;
  const T t3_2 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_1 + t3_2;
  const T t3_3 = omega3_2 * omega3_1;
  const T U3_12 = t3_3 - omegadot3_3;
  const T t3_4 = omega3_3 * omega3_1;
  const T U3_13 = t3_4 + omegadot2_2;
  const T U3_21 = t3_3 + omegadot3_3;
  const T t3_5 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_1 + t3_5;
  const T t3_6 = omega3_3 * omega3_2;
  const T U3_23 = t3_6 - omegadot3_1;
  const T U3_31 = t3_4 - omegadot2_2;
  const T U3_32 = t3_6 + omegadot3_1;
  const T minus_U3_33 = t3_2 + t3_5;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_7 = minus_Pddot2_1 + minus_U2_11 * T(0.1805);
  const T t3_8 = U2_31 * T(0.1805) - minus_Pddot2_3;
  const T minus_Pddot3_1 = E3_11 * t3_7 + minus_E3_13 * t3_8;
  const T Pddot3_2 = Pddot2_2 + U2_21 * T(0.1805);
  const T Pddot3_3 = E3_11 * t3_8 - minus_E3_13 * t3_7;
  // stretch_fr_thigh_3 = theta3 - l_fr_thigh_: stretch of the spring
  const T stretch_fr_thigh_3 = theta3 - T(0.8);
  // effort_fr_thigh_3 = -thetadot3 c_fr_thigh_ + tau_fr_thigh_ - stretch_fr_thigh_3 k_fr_thigh_: along the coordinate
  //   [N m], [N]
  const T effort_fr_thigh_3 = u.tau_fr_thigh - thetadot3 * c.p.kd - stretch_fr_thigh_3 * c.p.kp;
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = minus_U3_11 * T(0.0032790809999999997) - U3_13 * T(0.072881238);
  const T G3_2 = U3_21 * T(0.0032790809999999997) + U3_23 * T(0.072881238);
  const T minus_G3_3 = minus_U3_33 * T(0.072881238) - U3_31 * T(0.0032790809999999997);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(0.072881238) * Pddot3_2 - T(0.000499645385197) * U3_32 - T(0.014446725509588) * U3_23 +
      T(0.005511856743573999) * (minus_U3_22 - minus_U3_33) + T(0.00020639994631299998) * U3_31 + T(0.000254264832594)
      * U3_21;
  const T minus_N3_2 = T(0.072881238) * minus_Pddot3_1 + T(0.0032790809999999997) * Pddot3_3 + T(0.014446725509588) *
      U3_13 - T(0.000499645385197) * U3_31 - T(0.000254264832594) * (minus_U3_33 - minus_U3_11) +
      T(0.005511856743573999) * U3_12 - T(0.00020639994631299998) * U3_32;
  const T minus_N3_3 = T(0.000499645385197) * U3_21 + T(0.000499645385197) * U3_12 + T(0.00020639994631299998) *
      (minus_U3_11 - minus_U3_22) - T(0.000254264832594) * U3_23 - T(0.005511856743573999) * U3_13 -
      T(0.0032790809999999997) * Pddot3_2;

  // ---- body 4 (fr_calf) on body 3
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  // E4^T = Z4^T Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T t4_2 = sines[6];
  const T minus_E4_11 = T(0.9993592865650762) * t4_1 + T(0.035791288830411085) * t4_2;
  const T minus_E4_13 = T(0.035791288830411085) * t4_1 - T(0.9993592865650762) * t4_2;
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T minus_R4_11 = R3_11 * minus_E4_11 + R3_31 * minus_E4_13;
  const T minus_R4_12 = R3_12 * minus_E4_11 + R3_32 * minus_E4_13;
  const T minus_R4_13 = R3_13 * minus_E4_11 + R3_33 * minus_E4_13;
  const T R4_31 = R3_11 * minus_E4_13 - R3_31 * minus_E4_11;
  const T R4_32 = R3_12 * minus_E4_13 - R3_32 * minus_E4_11;
  const T R4_33 = R3_13 * minus_E4_13 - R3_33 * minus_E4_11;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T minus_omega4_1 = minus_E4_11 * omega3_1 + minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  const T omega4_3 = minus_E4_13 * omega3_1 - minus_E4_11 * omega3_3;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot4_1 = thetadot4 * omega4_3 + minus_E4_11 * omegadot3_1 + minus_E4_13 * omegadot3_3;
  const T omegadot4_3 = minus_E4_13 * omegadot3_1 - minus_E4_11 * omegadot3_3 - thetadot4 * minus_omega4_1;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_3 = omega4_3 * omega4_3;
  const T t4_4 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_3 + t4_4;
  const T t4_5 = omega4_2 * minus_omega4_1;
  const T minus_U4_12 = t4_5 + omegadot4_3;
  const T t4_6 = omega4_3 * minus_omega4_1;
  const T U4_13 = omegadot2_2 - t4_6;
  const T U4_21 = omegadot4_3 - t4_5;
  const T t4_7 = minus_omega4_1 * minus_omega4_1;
  const T minus_U4_22 = t4_3 + t4_7;
  const T t4_8 = omega4_3 * omega4_2;
  const T U4_23 = t4_8 + minus_omegadot4_1;
  const T minus_U4_31 = t4_6 + omegadot2_2;
  const T U4_32 = t4_8 - minus_omegadot4_1;
  const T minus_U4_33 = t4_4 + t4_7;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot4_1 = minus_E4_11 * (minus_Pddot3_1 + U3_13 * T(0.2)) - minus_E4_13 * (Pddot3_3 + minus_U3_33 *
      T(0.2));
  const T Pddot4_2 = Pddot3_2 - U3_23 * T(0.2);
  // stretch_fr_calf_4 = theta4 - l_fr_calf_: stretch of the spring
  const T stretch_fr_calf_4 = theta4 + T(1.6);
  // effort_fr_calf_4 = -thetadot4 c_fr_calf_ + tau_fr_calf_ - stretch_fr_calf_4 k_fr_calf_: along the coordinate [N
  //   m], [N]
  const T effort_fr_calf_4 = u.tau_fr_calf - thetadot4 * c.p.kd - stretch_fr_calf_4 * c.p.kp;
  // G4 = R4 F_ground_on_fr_ - U4 h_own_4: applied less inertia force, body axes [N]
  const T t4_9 = minus_R4_11 * u.ground_fr_x + minus_R4_12 * u.ground_fr_y + minus_R4_13 * u.ground_fr_z;
  const T minus_G4_1 = t4_9 + U4_13 * T(0.029845530432320418);
  const T t4_10 = R2_21 * u.ground_fr_x + R2_22 * u.ground_fr_y + R2_23 * u.ground_fr_z;
  const T G4_2 = t4_10 - U4_23 * T(0.029845530432320418);
  const T t4_11 = R4_31 * u.ground_fr_x + R4_32 * u.ground_fr_y + R4_33 * u.ground_fr_z;
  const T G4_3 = t4_11 + minus_U4_33 * T(0.029845530432320418);
  // N4 = o4~ R4 F_ground_on_fr_ - h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N4_1 = T(0.029845530432320418) * Pddot4_2 - (T(0.19987185731301527) * t4_10 + T(0.0838) * t4_11) +
      T(4.712093241166159e-05) * U4_32 + T(0.007297717301242339) * U4_23 + T(0.0025010554502284503) * (minus_U4_22 -
      minus_U4_33) - T(5.215891594784536e-35) * minus_U4_31 + T(0.0002865260721362275) * U4_21;
  const T minus_N4_2 = T(0.19987185731301527) * t4_9 + T(0.007158257766082217) * t4_11 + T(0.029845530432320418) *
      Pddot4_1 + T(0.007297717301242339) * U4_13 + T(4.712093241166159e-05) * minus_U4_31 + T(0.0002865260721362275) *
      (minus_U4_33 - minus_U4_11) + T(0.0025010554502284503) * minus_U4_12 + T(5.215891594784536e-35) * U4_32;
  const T N4_3 = T(0.007158257766082217) * t4_10 - T(0.0838) * t4_9 - T(4.712093241166159e-05) * U4_21 +
      T(4.712093241166159e-05) * minus_U4_12 + T(5.215891594784536e-35) * (minus_U4_11 - minus_U4_22) -
      T(0.0002865260721362275) * U4_23 - T(0.0025010554502284503) * U4_13;

  // ---- body 6 (fl_hip) on body 1
  const T theta6 = x[7];
  const T thetadot6 = y[6];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];
  // R6^T = R1^T E6^T: R takes inertial components to body components
  const T R6_21 = R1_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R1_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R1_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R1_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R1_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R1_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega1: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega1_1;
  const T omega6_2 = E6_22 * omega1_2 + E6_23 * omega1_3;
  const T omega6_3 = E6_22 * omega1_3 - E6_23 * omega1_2;
  // omegadot6 = -thetadot6 b6~ E6 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot6_2 = thetadot6 * omega6_3;
  const T minus_omegadot6_3 = thetadot6 * omega6_2;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_3 * omega6_3;
  const T t6_2 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_1 + t6_2;
  const T t6_3 = omega6_2 * omega6_1;
  const T U6_12 = t6_3 + minus_omegadot6_3;
  const T t6_4 = omega6_3 * omega6_1;
  const T U6_13 = t6_4 + omegadot6_2;
  const T U6_21 = t6_3 - minus_omegadot6_3;
  const T t6_5 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_1 + t6_5;
  const T U6_23 = omega6_3 * omega6_2;
  const T U6_31 = t6_4 - omegadot6_2;
  const T minus_U6_33 = t6_2 + t6_5;
  // Pddot6 = E6 U1 q6: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_2 = E6_23 * t2_7 - E6_22 * t2_6;
  const T Pddot6_3 = E6_23 * t2_6 + E6_22 * t2_7;
  // effort_fl_hip_6 = -theta6 k_fl_hip_ - thetadot6 c_fl_hip_ + tau_fl_hip_: along the coordinate [N m], [N]
  const T effort_fl_hip_6 = u.tau_fl_hip - theta6 * c.p.kp - thetadot6 * c.p.kd;
  // G6 = -U6 h_own_6: applied less inertia force, body axes [N]
  const T minus_G6_1 = U6_12 * T(0.081652909) + U6_13 * T(2.1575999999999998e-05);
  const T minus_G6_2 = U6_23 * T(2.1575999999999998e-05) - minus_U6_22 * T(0.081652909);
  const T minus_G6_3 = U6_23 * T(0.081652909) - minus_U6_33 * T(2.1575999999999998e-05);
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(0.081652909) * Pddot6_3 - T(2.1575999999999998e-05) * Pddot6_2 + T(0.006599357548829661) *
      U6_23 + T(4.7970076e-07) * (minus_U6_22 - minus_U6_33) + T(0.014746295744939998) * U6_31 - T(4.165029864e-06) *
      U6_21;
  const T minus_N6_2 = t2_8 + T(0.000361904168856) * U6_13 + T(0.000361904168856) * U6_31 + T(4.165029864e-06) *
      (minus_U6_33 - minus_U6_11) + T(4.7970076e-07) * U6_12 - T(0.014746295744939998) * U6_23;
  const T minus_N6_3 = T(0.014746295744939998) * (minus_U6_11 - minus_U6_22) - (t2_9 + T(0.000361904168856) * U6_21 +
      T(0.006961261717685661) * U6_12) + T(4.165029864e-06) * U6_23 - T(4.7970076e-07) * U6_13;

  // ---- body 7 (fl_thigh) on body 6
  const T theta7 = x[8];
  const T thetadot7 = y[7];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R1_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R1_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R1_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R1_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R1_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R1_13 * minus_E7_13 + R6_33 * E7_11;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // omegadot7 = -thetadot7 b7~ E7 omega6 + E7 omegadot6: angular acceleration, body axes [rad/s^2]
  const T omegadot7_1 = minus_E7_13 * minus_omegadot6_3 - thetadot7 * omega7_3;
  const T omegadot7_3 = thetadot7 * omega7_1 - E7_11 * minus_omegadot6_3;
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
  const T t7_7 = minus_Pddot2_1 - minus_U6_11 * T(0.1805);
  const T t7_8 = Pddot6_3 + U6_31 * T(0.1805);
  const T Pddot7_1 = E7_11 * t7_7 - minus_E7_13 * t7_8;
  const T Pddot7_2 = Pddot6_2 + U6_21 * T(0.1805);
  const T Pddot7_3 = minus_E7_13 * t7_7 + E7_11 * t7_8;
  // stretch_fl_thigh_7 = theta7 - l_fl_thigh_: stretch of the spring
  const T stretch_fl_thigh_7 = theta7 - T(0.8);
  // effort_fl_thigh_7 = -thetadot7 c_fl_thigh_ + tau_fl_thigh_ - stretch_fl_thigh_7 k_fl_thigh_: along the coordinate
  //   [N m], [N]
  const T effort_fl_thigh_7 = u.tau_fl_thigh - thetadot7 * c.p.kd - stretch_fl_thigh_7 * c.p.kp;
  // G7 = -U7 h_own_7: applied less inertia force, body axes [N]
  const T minus_G7_1 = minus_U7_11 * T(0.0032790809999999997) - U7_13 * T(0.072881238);
  const T G7_2 = U7_21 * T(0.0032790809999999997) + U7_23 * T(0.072881238);
  const T minus_G7_3 = minus_U7_33 * T(0.072881238) - U7_31 * T(0.0032790809999999997);
  // N7 = -h_own_7~ Pddot7 - axial(U7 (tr(J_own_7)/2 - J_own_7)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N7_1 = T(0.072881238) * Pddot7_2 - T(0.000499645385197) * U7_32 - T(0.014446725509588) * U7_23 -
      T(0.005511856743573999) * (minus_U7_22 - minus_U7_33) - T(0.00020639994631299998) * U7_31 + T(0.000254264832594)
      * U7_21;
  const T minus_N7_2 = T(0.0032790809999999997) * Pddot7_3 - T(0.072881238) * Pddot7_1 + T(0.014446725509588) * U7_13
      - T(0.000499645385197) * U7_31 - T(0.000254264832594) * (minus_U7_33 - minus_U7_11) - T(0.005511856743573999) *
      U7_12 + T(0.00020639994631299998) * U7_32;
  const T minus_N7_3 = T(0.000499645385197) * U7_21 + T(0.000499645385197) * U7_12 - T(0.00020639994631299998) *
      (minus_U7_11 - minus_U7_22) - T(0.000254264832594) * U7_23 + T(0.005511856743573999) * U7_13 -
      T(0.0032790809999999997) * Pddot7_2;

  // ---- body 8 (fl_calf) on body 7
  const T theta8 = x[9];
  const T thetadot8 = y[8];
  // E8^T = Z8^T Rot(b8, theta8): E takes components in the lower body to those in the body
  const T t8_1 = cosines[9];
  const T t8_2 = sines[9];
  const T minus_E8_11 = T(0.9993592865650762) * t8_1 + T(0.035791288830411085) * t8_2;
  const T minus_E8_13 = T(0.035791288830411085) * t8_1 - T(0.9993592865650762) * t8_2;
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T minus_R8_11 = R7_11 * minus_E8_11 + R7_31 * minus_E8_13;
  const T minus_R8_12 = R7_12 * minus_E8_11 + R7_32 * minus_E8_13;
  const T minus_R8_13 = R7_13 * minus_E8_11 + R7_33 * minus_E8_13;
  const T R8_31 = R7_11 * minus_E8_13 - R7_31 * minus_E8_11;
  const T R8_32 = R7_12 * minus_E8_13 - R7_32 * minus_E8_11;
  const T R8_33 = R7_13 * minus_E8_13 - R7_33 * minus_E8_11;
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T minus_omega8_1 = minus_E8_11 * omega7_1 + minus_E8_13 * omega7_3;
  const T omega8_2 = thetadot8 + omega7_2;
  const T omega8_3 = minus_E8_13 * omega7_1 - minus_E8_11 * omega7_3;
  // omegadot8 = -thetadot8 b8~ E8 omega7 + E8 omegadot7: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot8_1 = thetadot8 * omega8_3 + minus_E8_11 * omegadot7_1 + minus_E8_13 * omegadot7_3;
  const T omegadot8_3 = minus_E8_13 * omegadot7_1 - minus_E8_11 * omegadot7_3 - thetadot8 * minus_omega8_1;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_3 = omega8_3 * omega8_3;
  const T t8_4 = omega8_2 * omega8_2;
  const T minus_U8_11 = t8_3 + t8_4;
  const T t8_5 = omega8_2 * minus_omega8_1;
  const T minus_U8_12 = t8_5 + omegadot8_3;
  const T t8_6 = omega8_3 * minus_omega8_1;
  const T U8_13 = omegadot6_2 - t8_6;
  const T U8_21 = omegadot8_3 - t8_5;
  const T t8_7 = minus_omega8_1 * minus_omega8_1;
  const T minus_U8_22 = t8_3 + t8_7;
  const T t8_8 = omega8_3 * omega8_2;
  const T U8_23 = t8_8 + minus_omegadot8_1;
  const T minus_U8_31 = t8_6 + omegadot6_2;
  const T U8_32 = t8_8 - minus_omegadot8_1;
  const T minus_U8_33 = t8_4 + t8_7;
  // Pddot8 = E8 (U7 q8 + Pddot7): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot8_1 = minus_E8_11 * (Pddot7_1 - U7_13 * T(0.2)) + minus_E8_13 * (Pddot7_3 + minus_U7_33 *
      T(0.2));
  const T Pddot8_2 = Pddot7_2 - U7_23 * T(0.2);
  // stretch_fl_calf_8 = theta8 - l_fl_calf_: stretch of the spring
  const T stretch_fl_calf_8 = theta8 + T(1.6);
  // effort_fl_calf_8 = -thetadot8 c_fl_calf_ + tau_fl_calf_ - stretch_fl_calf_8 k_fl_calf_: along the coordinate [N
  //   m], [N]
  const T effort_fl_calf_8 = u.tau_fl_calf - thetadot8 * c.p.kd - stretch_fl_calf_8 * c.p.kp;
  // G8 = R8 F_ground_on_fl_ - U8 h_own_8: applied less inertia force, body axes [N]
  const T t8_9 = minus_R8_11 * u.ground_fl_x + minus_R8_12 * u.ground_fl_y + minus_R8_13 * u.ground_fl_z;
  const T minus_G8_1 = t8_9 + U8_13 * T(0.029845530432320418);
  const T t8_10 = R6_21 * u.ground_fl_x + R6_22 * u.ground_fl_y + R6_23 * u.ground_fl_z;
  const T G8_2 = t8_10 - U8_23 * T(0.029845530432320418);
  const T t8_11 = R8_31 * u.ground_fl_x + R8_32 * u.ground_fl_y + R8_33 * u.ground_fl_z;
  const T G8_3 = t8_11 + minus_U8_33 * T(0.029845530432320418);
  // N8 = o8~ R8 F_ground_on_fl_ - h_own_8~ Pddot8 - axial(U8 (tr(J_own_8)/2 - J_own_8)): applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N8_1 = T(0.0838) * t8_11 - T(0.19987185731301527) * t8_10 + T(0.029845530432320418) * Pddot8_2 +
      T(4.712093241166159e-05) * U8_32 + T(0.007297717301242339) * U8_23 - T(0.0025010554502284503) * (minus_U8_22 -
      minus_U8_33) + T(5.215891594784536e-35) * minus_U8_31 + T(0.0002865260721362275) * U8_21;
  const T N8_2 = T(0.029845530432320418) * minus_Pddot8_1 - (T(0.19987185731301527) * t8_9 + T(0.007158257766082217) *
      t8_11) - T(0.007297717301242339) * U8_13 - T(4.712093241166159e-05) * minus_U8_31 - T(0.0002865260721362275) *
      (minus_U8_33 - minus_U8_11) + T(0.0025010554502284503) * minus_U8_12 + T(5.215891594784536e-35) * U8_32;
  const T N8_3 = T(0.007158257766082217) * t8_10 + T(0.0838) * t8_9 - T(4.712093241166159e-05) * U8_21 +
      T(4.712093241166159e-05) * minus_U8_12 - T(5.215891594784536e-35) * (minus_U8_11 - minus_U8_22) -
      T(0.0002865260721362275) * U8_23 + T(0.0025010554502284503) * U8_13;

  // ---- body 10 (rr_hip) on body 1
  const T theta10 = x[10];
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];
  // R10^T = R1^T E10^T: R takes inertial components to body components
  const T R10_21 = R1_21 * E10_22 + R1_31 * E10_23;
  const T R10_22 = R1_22 * E10_22 + R1_32 * E10_23;
  const T R10_23 = R1_23 * E10_22 + R1_33 * E10_23;
  const T R10_31 = R1_31 * E10_22 - R1_21 * E10_23;
  const T R10_32 = R1_32 * E10_22 - R1_22 * E10_23;
  const T R10_33 = R1_33 * E10_22 - R1_23 * E10_23;
  // omega10 = thetadot10 b10 + E10 omega1: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = thetadot10 + omega1_1;
  const T omega10_2 = E10_22 * omega1_2 + E10_23 * omega1_3;
  const T omega10_3 = E10_22 * omega1_3 - E10_23 * omega1_2;
  // omegadot10 = -thetadot10 b10~ E10 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot10_2 = thetadot10 * omega10_3;
  const T minus_omegadot10_3 = thetadot10 * omega10_2;
  // U10 = omega10~ omega10~ + omegadot10~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t10_1 = omega10_3 * omega10_3;
  const T t10_2 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_1 + t10_2;
  const T t10_3 = omega10_2 * omega10_1;
  const T U10_12 = t10_3 + minus_omegadot10_3;
  const T t10_4 = omega10_3 * omega10_1;
  const T U10_13 = t10_4 + omegadot10_2;
  const T U10_21 = t10_3 - minus_omegadot10_3;
  const T t10_5 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_1 + t10_5;
  const T U10_23 = omega10_3 * omega10_2;
  const T U10_31 = t10_4 - omegadot10_2;
  const T minus_U10_33 = t10_2 + t10_5;
  // Pddot10 = E10 U1 q10: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot10_2 = E10_22 * t2_6 - E10_23 * t2_7;
  const T minus_Pddot10_3 = E10_23 * t2_6 + E10_22 * t2_7;
  // effort_rr_hip_10 = -theta10 k_rr_hip_ - thetadot10 c_rr_hip_ + tau_rr_hip_: along the coordinate [N m], [N]
  const T effort_rr_hip_10 = u.tau_rr_hip - theta10 * c.p.kp - thetadot10 * c.p.kd;
  // G10 = -U10 h_own_10: applied less inertia force, body axes [N]
  const T minus_G10_1 = U10_13 * T(2.1575999999999998e-05) - U10_12 * T(0.081652909);
  const T minus_G10_2 = minus_U10_22 * T(0.081652909) + U10_23 * T(2.1575999999999998e-05);
  const T G10_3 = U10_23 * T(0.081652909) + minus_U10_33 * T(2.1575999999999998e-05);
  // N10 = -h_own_10~ Pddot10 - axial(U10 (tr(J_own_10)/2 - J_own_10)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N10_1 = T(0.081652909) * minus_Pddot10_3 - T(2.1575999999999998e-05) * Pddot10_2 +
      T(0.006599357548829661) * U10_23 - T(4.7970076e-07) * (minus_U10_22 - minus_U10_33) + T(0.014746295744939998) *
      U10_31 + T(4.165029864e-06) * U10_21;
  const T minus_N10_2 = T(0.000361904168856) * U10_13 - t2_8 + T(0.000361904168856) * U10_31 - T(4.165029864e-06) *
      (minus_U10_33 - minus_U10_11) - T(4.7970076e-07) * U10_12 - T(0.014746295744939998) * U10_23;
  const T minus_N10_3 = T(0.014746295744939998) * (minus_U10_11 - minus_U10_22) - (t2_9 + T(0.000361904168856) *
      U10_21 + T(0.006961261717685661) * U10_12) - T(4.165029864e-06) * U10_23 + T(4.7970076e-07) * U10_13;

  // ---- body 11 (rr_thigh) on body 10
  const T theta11 = x[11];
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R1_11 * E11_11 - R10_31 * minus_E11_13;
  const T R11_12 = R1_12 * E11_11 - R10_32 * minus_E11_13;
  const T R11_13 = R1_13 * E11_11 - R10_33 * minus_E11_13;
  const T R11_31 = R1_11 * minus_E11_13 + R10_31 * E11_11;
  const T R11_32 = R1_12 * minus_E11_13 + R10_32 * E11_11;
  const T R11_33 = R1_13 * minus_E11_13 + R10_33 * E11_11;
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 - minus_E11_13 * omega10_3;
  const T omega11_2 = thetadot11 + omega10_2;
  const T omega11_3 = minus_E11_13 * omega10_1 + E11_11 * omega10_3;
  // omegadot11 = -thetadot11 b11~ E11 omega10 + E11 omegadot10: angular acceleration, body axes [rad/s^2]
  const T omegadot11_1 = minus_E11_13 * minus_omegadot10_3 - thetadot11 * omega11_3;
  const T omegadot11_3 = thetadot11 * omega11_1 - E11_11 * minus_omegadot10_3;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_1 = omega11_3 * omega11_3;
  const T t11_2 = omega11_2 * omega11_2;
  const T minus_U11_11 = t11_1 + t11_2;
  const T t11_3 = omega11_2 * omega11_1;
  const T U11_12 = t11_3 - omegadot11_3;
  const T t11_4 = omega11_3 * omega11_1;
  const T U11_13 = t11_4 + omegadot10_2;
  const T U11_21 = t11_3 + omegadot11_3;
  const T t11_5 = omega11_1 * omega11_1;
  const T minus_U11_22 = t11_1 + t11_5;
  const T t11_6 = omega11_3 * omega11_2;
  const T U11_23 = t11_6 - omegadot11_1;
  const T U11_31 = t11_4 - omegadot10_2;
  const T U11_32 = t11_6 + omegadot11_1;
  const T minus_U11_33 = t11_2 + t11_5;
  // Pddot11 = E11 (U10 q11 + Pddot10): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t11_7 = minus_U10_11 * T(0.1805) - minus_Pddot2_1;
  const T t11_8 = minus_Pddot10_3 + U10_31 * T(0.1805);
  const T Pddot11_1 = E11_11 * t11_7 + minus_E11_13 * t11_8;
  const T Pddot11_2 = Pddot10_2 - U10_21 * T(0.1805);
  const T Pddot11_3 = minus_E11_13 * t11_7 - E11_11 * t11_8;
  // stretch_rr_thigh_11 = theta11 - l_rr_thigh_: stretch of the spring
  const T stretch_rr_thigh_11 = theta11 - T(0.8);
  // effort_rr_thigh_11 = -thetadot11 c_rr_thigh_ + tau_rr_thigh_ - stretch_rr_thigh_11 k_rr_thigh_: along the
  //   coordinate [N m], [N]
  const T effort_rr_thigh_11 = u.tau_rr_thigh - thetadot11 * c.p.kd - stretch_rr_thigh_11 * c.p.kp;
  // G11 = -U11 h_own_11: applied less inertia force, body axes [N]
  const T minus_G11_1 = minus_U11_11 * T(0.0032790809999999997) - U11_13 * T(0.072881238);
  const T G11_2 = U11_21 * T(0.0032790809999999997) + U11_23 * T(0.072881238);
  const T minus_G11_3 = minus_U11_33 * T(0.072881238) - U11_31 * T(0.0032790809999999997);
  // N11 = -h_own_11~ Pddot11 - axial(U11 (tr(J_own_11)/2 - J_own_11)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N11_1 = T(0.072881238) * Pddot11_2 - T(0.000499645385197) * U11_32 - T(0.014446725509588) * U11_23 +
      T(0.005511856743573999) * (minus_U11_22 - minus_U11_33) + T(0.00020639994631299998) * U11_31 +
      T(0.000254264832594) * U11_21;
  const T minus_N11_2 = T(0.0032790809999999997) * Pddot11_3 - T(0.072881238) * Pddot11_1 + T(0.014446725509588) *
      U11_13 - T(0.000499645385197) * U11_31 - T(0.000254264832594) * (minus_U11_33 - minus_U11_11) +
      T(0.005511856743573999) * U11_12 - T(0.00020639994631299998) * U11_32;
  const T minus_N11_3 = T(0.000499645385197) * U11_21 + T(0.000499645385197) * U11_12 + T(0.00020639994631299998) *
      (minus_U11_11 - minus_U11_22) - T(0.000254264832594) * U11_23 - T(0.005511856743573999) * U11_13 -
      T(0.0032790809999999997) * Pddot11_2;

  // ---- body 12 (rr_calf) on body 11
  const T theta12 = x[12];
  const T thetadot12 = y[11];
  // E12^T = Z12^T Rot(b12, theta12): E takes components in the lower body to those in the body
  const T t12_1 = cosines[12];
  const T t12_2 = sines[12];
  const T minus_E12_11 = T(0.9993592865650762) * t12_1 + T(0.035791288830411085) * t12_2;
  const T minus_E12_13 = T(0.035791288830411085) * t12_1 - T(0.9993592865650762) * t12_2;
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T minus_R12_11 = R11_11 * minus_E12_11 + R11_31 * minus_E12_13;
  const T minus_R12_12 = R11_12 * minus_E12_11 + R11_32 * minus_E12_13;
  const T minus_R12_13 = R11_13 * minus_E12_11 + R11_33 * minus_E12_13;
  const T R12_31 = R11_11 * minus_E12_13 - R11_31 * minus_E12_11;
  const T R12_32 = R11_12 * minus_E12_13 - R11_32 * minus_E12_11;
  const T R12_33 = R11_13 * minus_E12_13 - R11_33 * minus_E12_11;
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T minus_omega12_1 = minus_E12_11 * omega11_1 + minus_E12_13 * omega11_3;
  const T omega12_2 = thetadot12 + omega11_2;
  const T omega12_3 = minus_E12_13 * omega11_1 - minus_E12_11 * omega11_3;
  // omegadot12 = -thetadot12 b12~ E12 omega11 + E12 omegadot11: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot12_1 = thetadot12 * omega12_3 + minus_E12_11 * omegadot11_1 + minus_E12_13 * omegadot11_3;
  const T omegadot12_3 = minus_E12_13 * omegadot11_1 - minus_E12_11 * omegadot11_3 - thetadot12 * minus_omega12_1;
  // U12 = omega12~ omega12~ + omegadot12~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t12_3 = omega12_3 * omega12_3;
  const T t12_4 = omega12_2 * omega12_2;
  const T minus_U12_11 = t12_3 + t12_4;
  const T t12_5 = omega12_2 * minus_omega12_1;
  const T minus_U12_12 = t12_5 + omegadot12_3;
  const T t12_6 = omega12_3 * minus_omega12_1;
  const T U12_13 = omegadot10_2 - t12_6;
  const T U12_21 = omegadot12_3 - t12_5;
  const T t12_7 = minus_omega12_1 * minus_omega12_1;
  const T minus_U12_22 = t12_3 + t12_7;
  const T t12_8 = omega12_3 * omega12_2;
  const T U12_23 = t12_8 + minus_omegadot12_1;
  const T minus_U12_31 = t12_6 + omegadot10_2;
  const T U12_32 = t12_8 - minus_omegadot12_1;
  const T minus_U12_33 = t12_4 + t12_7;
  // Pddot12 = E12 (U11 q12 + Pddot11): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot12_1 = minus_E12_11 * (Pddot11_1 - U11_13 * T(0.2)) + minus_E12_13 * (Pddot11_3 + minus_U11_33 *
      T(0.2));
  const T Pddot12_2 = Pddot11_2 - U11_23 * T(0.2);
  // stretch_rr_calf_12 = theta12 - l_rr_calf_: stretch of the spring
  const T stretch_rr_calf_12 = theta12 + T(1.6);
  // effort_rr_calf_12 = -thetadot12 c_rr_calf_ + tau_rr_calf_ - stretch_rr_calf_12 k_rr_calf_: along the coordinate
  //   [N m], [N]
  const T effort_rr_calf_12 = u.tau_rr_calf - thetadot12 * c.p.kd - stretch_rr_calf_12 * c.p.kp;
  // G12 = R12 F_ground_on_rr_ - U12 h_own_12: applied less inertia force, body axes [N]
  const T t12_9 = minus_R12_11 * u.ground_rr_x + minus_R12_12 * u.ground_rr_y + minus_R12_13 * u.ground_rr_z;
  const T minus_G12_1 = t12_9 + U12_13 * T(0.029845530432320418);
  const T t12_10 = R10_21 * u.ground_rr_x + R10_22 * u.ground_rr_y + R10_23 * u.ground_rr_z;
  const T G12_2 = t12_10 - U12_23 * T(0.029845530432320418);
  const T t12_11 = R12_31 * u.ground_rr_x + R12_32 * u.ground_rr_y + R12_33 * u.ground_rr_z;
  const T G12_3 = t12_11 + minus_U12_33 * T(0.029845530432320418);
  // N12 = o12~ R12 F_ground_on_rr_ - h_own_12~ Pddot12 - axial(U12 (tr(J_own_12)/2 - J_own_12)): applied less inertia
  //   moment about the body origin, body axes [N m]
  const T N12_1 = T(0.029845530432320418) * Pddot12_2 - (T(0.19987185731301527) * t12_10 + T(0.0838) * t12_11) +
      T(4.712093241166159e-05) * U12_32 + T(0.007297717301242339) * U12_23 + T(0.0025010554502284503) * (minus_U12_22
      - minus_U12_33) - T(5.215891594784536e-35) * minus_U12_31 + T(0.0002865260721362275) * U12_21;
  const T N12_2 = T(0.029845530432320418) * minus_Pddot12_1 - (T(0.19987185731301527) * t12_9 +
      T(0.007158257766082217) * t12_11) - T(0.007297717301242339) * U12_13 - T(4.712093241166159e-05) * minus_U12_31 -
      T(0.0002865260721362275) * (minus_U12_33 - minus_U12_11) - T(0.0025010554502284503) * minus_U12_12 -
      T(5.215891594784536e-35) * U12_32;
  const T N12_3 = T(0.007158257766082217) * t12_10 - T(0.0838) * t12_9 - T(4.712093241166159e-05) * U12_21 +
      T(4.712093241166159e-05) * minus_U12_12 + T(5.215891594784536e-35) * (minus_U12_11 - minus_U12_22) -
      T(0.0002865260721362275) * U12_23 - T(0.0025010554502284503) * U12_13;

  // ---- body 14 (rl_hip) on body 1
  const T theta14 = x[13];
  const T thetadot14 = y[12];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];
  // R14^T = R1^T E14^T: R takes inertial components to body components
  const T R14_21 = R1_21 * E14_22 + R1_31 * E14_23;
  const T R14_22 = R1_22 * E14_22 + R1_32 * E14_23;
  const T R14_23 = R1_23 * E14_22 + R1_33 * E14_23;
  const T R14_31 = R1_31 * E14_22 - R1_21 * E14_23;
  const T R14_32 = R1_32 * E14_22 - R1_22 * E14_23;
  const T R14_33 = R1_33 * E14_22 - R1_23 * E14_23;
  // omega14 = thetadot14 b14 + E14 omega1: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = thetadot14 + omega1_1;
  const T omega14_2 = E14_22 * omega1_2 + E14_23 * omega1_3;
  const T omega14_3 = E14_22 * omega1_3 - E14_23 * omega1_2;
  // omegadot14 = -thetadot14 b14~ E14 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot14_2 = thetadot14 * omega14_3;
  const T minus_omegadot14_3 = thetadot14 * omega14_2;
  // U14 = omega14~ omega14~ + omegadot14~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t14_1 = omega14_3 * omega14_3;
  const T t14_2 = omega14_2 * omega14_2;
  const T minus_U14_11 = t14_1 + t14_2;
  const T t14_3 = omega14_2 * omega14_1;
  const T U14_12 = t14_3 + minus_omegadot14_3;
  const T t14_4 = omega14_3 * omega14_1;
  const T U14_13 = t14_4 + omegadot14_2;
  const T U14_21 = t14_3 - minus_omegadot14_3;
  const T t14_5 = omega14_1 * omega14_1;
  const T minus_U14_22 = t14_1 + t14_5;
  const T U14_23 = omega14_3 * omega14_2;
  const T U14_31 = t14_4 - omegadot14_2;
  const T minus_U14_33 = t14_2 + t14_5;
  // Pddot14 = E14 U1 q14: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot14_2 = E14_23 * t2_7 - E14_22 * t2_6;
  const T Pddot14_3 = E14_23 * t2_6 + E14_22 * t2_7;
  // effort_rl_hip_14 = -theta14 k_rl_hip_ - thetadot14 c_rl_hip_ + tau_rl_hip_: along the coordinate [N m], [N]
  const T effort_rl_hip_14 = u.tau_rl_hip - theta14 * c.p.kp - thetadot14 * c.p.kd;
  // G14 = -U14 h_own_14: applied less inertia force, body axes [N]
  const T minus_G14_1 = U14_12 * T(0.081652909) + U14_13 * T(2.1575999999999998e-05);
  const T minus_G14_2 = U14_23 * T(2.1575999999999998e-05) - minus_U14_22 * T(0.081652909);
  const T minus_G14_3 = U14_23 * T(0.081652909) - minus_U14_33 * T(2.1575999999999998e-05);
  // N14 = -h_own_14~ Pddot14 - axial(U14 (tr(J_own_14)/2 - J_own_14)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N14_1 = T(0.081652909) * Pddot14_3 - T(2.1575999999999998e-05) * Pddot14_2 + T(0.006599357548829661) *
      U14_23 + T(4.7970076e-07) * (minus_U14_22 - minus_U14_33) - T(0.014746295744939998) * U14_31 +
      T(4.165029864e-06) * U14_21;
  const T minus_N14_2 = t2_8 + T(0.000361904168856) * U14_13 + T(0.000361904168856) * U14_31 - T(4.165029864e-06) *
      (minus_U14_33 - minus_U14_11) + T(4.7970076e-07) * U14_12 + T(0.014746295744939998) * U14_23;
  const T N14_3 = t2_9 + T(0.000361904168856) * U14_21 + T(0.006961261717685661) * U14_12 + T(0.014746295744939998) *
      (minus_U14_11 - minus_U14_22) + T(4.165029864e-06) * U14_23 + T(4.7970076e-07) * U14_13;

  // ---- body 15 (rl_thigh) on body 14
  const T theta15 = x[14];
  const T thetadot15 = y[13];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_11 = R1_11 * E15_11 - R14_31 * minus_E15_13;
  const T R15_12 = R1_12 * E15_11 - R14_32 * minus_E15_13;
  const T R15_13 = R1_13 * E15_11 - R14_33 * minus_E15_13;
  const T R15_31 = R1_11 * minus_E15_13 + R14_31 * E15_11;
  const T R15_32 = R1_12 * minus_E15_13 + R14_32 * E15_11;
  const T R15_33 = R1_13 * minus_E15_13 + R14_33 * E15_11;
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = E15_11 * omega14_1 - minus_E15_13 * omega14_3;
  const T omega15_2 = thetadot15 + omega14_2;
  const T omega15_3 = minus_E15_13 * omega14_1 + E15_11 * omega14_3;
  // omegadot15 = -thetadot15 b15~ E15 omega14 + E15 omegadot14: angular acceleration, body axes [rad/s^2]
  const T omegadot15_1 = minus_E15_13 * minus_omegadot14_3 - thetadot15 * omega15_3;
  const T omegadot15_3 = thetadot15 * omega15_1 - E15_11 * minus_omegadot14_3;
  // U15 = omega15~ omega15~ + omegadot15~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t15_1 = omega15_3 * omega15_3;
  const T t15_2 = omega15_2 * omega15_2;
  const T minus_U15_11 = t15_1 + t15_2;
  const T t15_3 = omega15_2 * omega15_1;
  const T U15_12 = t15_3 - omegadot15_3;
  const T t15_4 = omega15_3 * omega15_1;
  const T U15_13 = t15_4 + omegadot14_2;
  const T U15_21 = t15_3 + omegadot15_3;
  const T t15_5 = omega15_1 * omega15_1;
  const T minus_U15_22 = t15_1 + t15_5;
  const T t15_6 = omega15_3 * omega15_2;
  const T U15_23 = t15_6 - omegadot15_1;
  const T U15_31 = t15_4 - omegadot14_2;
  const T U15_32 = t15_6 + omegadot15_1;
  const T minus_U15_33 = t15_2 + t15_5;
  // Pddot15 = E15 (U14 q15 + Pddot14): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t15_7 = minus_Pddot2_1 + minus_U14_11 * T(0.1805);
  const T t15_8 = Pddot14_3 - U14_31 * T(0.1805);
  const T Pddot15_1 = E15_11 * t15_7 - minus_E15_13 * t15_8;
  const T Pddot15_2 = Pddot14_2 - U14_21 * T(0.1805);
  const T Pddot15_3 = minus_E15_13 * t15_7 + E15_11 * t15_8;
  // stretch_rl_thigh_15 = theta15 - l_rl_thigh_: stretch of the spring
  const T stretch_rl_thigh_15 = theta15 - T(0.8);
  // effort_rl_thigh_15 = -thetadot15 c_rl_thigh_ + tau_rl_thigh_ - stretch_rl_thigh_15 k_rl_thigh_: along the
  //   coordinate [N m], [N]
  const T effort_rl_thigh_15 = u.tau_rl_thigh - thetadot15 * c.p.kd - stretch_rl_thigh_15 * c.p.kp;
  // G15 = -U15 h_own_15: applied less inertia force, body axes [N]
  const T minus_G15_1 = minus_U15_11 * T(0.0032790809999999997) - U15_13 * T(0.072881238);
  const T G15_2 = U15_21 * T(0.0032790809999999997) + U15_23 * T(0.072881238);
  const T minus_G15_3 = minus_U15_33 * T(0.072881238) - U15_31 * T(0.0032790809999999997);
  // N15 = -h_own_15~ Pddot15 - axial(U15 (tr(J_own_15)/2 - J_own_15)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N15_1 = T(0.072881238) * Pddot15_2 - T(0.000499645385197) * U15_32 - T(0.014446725509588) * U15_23 -
      T(0.005511856743573999) * (minus_U15_22 - minus_U15_33) - T(0.00020639994631299998) * U15_31 +
      T(0.000254264832594) * U15_21;
  const T minus_N15_2 = T(0.0032790809999999997) * Pddot15_3 - T(0.072881238) * Pddot15_1 + T(0.014446725509588) *
      U15_13 - T(0.000499645385197) * U15_31 - T(0.000254264832594) * (minus_U15_33 - minus_U15_11) -
      T(0.005511856743573999) * U15_12 + T(0.00020639994631299998) * U15_32;
  const T minus_N15_3 = T(0.000499645385197) * U15_21 + T(0.000499645385197) * U15_12 - T(0.00020639994631299998) *
      (minus_U15_11 - minus_U15_22) - T(0.000254264832594) * U15_23 + T(0.005511856743573999) * U15_13 -
      T(0.0032790809999999997) * Pddot15_2;

  // ---- body 16 (rl_calf) on body 15
  const T theta16 = x[15];
  const T thetadot16 = y[14];
  // E16^T = Z16^T Rot(b16, theta16): E takes components in the lower body to those in the body
  const T t16_1 = cosines[15];
  const T t16_2 = sines[15];
  const T minus_E16_11 = T(0.9993592865650762) * t16_1 + T(0.035791288830411085) * t16_2;
  const T minus_E16_13 = T(0.035791288830411085) * t16_1 - T(0.9993592865650762) * t16_2;
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T minus_R16_11 = R15_11 * minus_E16_11 + R15_31 * minus_E16_13;
  const T minus_R16_12 = R15_12 * minus_E16_11 + R15_32 * minus_E16_13;
  const T minus_R16_13 = R15_13 * minus_E16_11 + R15_33 * minus_E16_13;
  const T R16_31 = R15_11 * minus_E16_13 - R15_31 * minus_E16_11;
  const T R16_32 = R15_12 * minus_E16_13 - R15_32 * minus_E16_11;
  const T R16_33 = R15_13 * minus_E16_13 - R15_33 * minus_E16_11;
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T minus_omega16_1 = minus_E16_11 * omega15_1 + minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 - minus_E16_11 * omega15_3;
  // omegadot16 = -thetadot16 b16~ E16 omega15 + E16 omegadot15: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot16_1 = thetadot16 * omega16_3 + minus_E16_11 * omegadot15_1 + minus_E16_13 * omegadot15_3;
  const T omegadot16_3 = minus_E16_13 * omegadot15_1 - minus_E16_11 * omegadot15_3 - thetadot16 * minus_omega16_1;
  // U16 = omega16~ omega16~ + omegadot16~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t16_3 = omega16_3 * omega16_3;
  const T t16_4 = omega16_2 * omega16_2;
  const T minus_U16_11 = t16_3 + t16_4;
  const T t16_5 = omega16_2 * minus_omega16_1;
  const T minus_U16_12 = t16_5 + omegadot16_3;
  const T t16_6 = omega16_3 * minus_omega16_1;
  const T U16_13 = omegadot14_2 - t16_6;
  const T U16_21 = omegadot16_3 - t16_5;
  const T t16_7 = minus_omega16_1 * minus_omega16_1;
  const T minus_U16_22 = t16_3 + t16_7;
  const T t16_8 = omega16_3 * omega16_2;
  const T U16_23 = t16_8 + minus_omegadot16_1;
  const T minus_U16_31 = t16_6 + omegadot14_2;
  const T U16_32 = t16_8 - minus_omegadot16_1;
  const T minus_U16_33 = t16_4 + t16_7;
  // Pddot16 = E16 (U15 q16 + Pddot15): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot16_1 = minus_E16_11 * (Pddot15_1 - U15_13 * T(0.2)) + minus_E16_13 * (Pddot15_3 + minus_U15_33 *
      T(0.2));
  const T Pddot16_2 = Pddot15_2 - U15_23 * T(0.2);
  // stretch_rl_calf_16 = theta16 - l_rl_calf_: stretch of the spring
  const T stretch_rl_calf_16 = theta16 + T(1.6);
  // effort_rl_calf_16 = -thetadot16 c_rl_calf_ + tau_rl_calf_ - stretch_rl_calf_16 k_rl_calf_: along the coordinate
  //   [N m], [N]
  const T effort_rl_calf_16 = u.tau_rl_calf - thetadot16 * c.p.kd - stretch_rl_calf_16 * c.p.kp;
  // G16 = R16 F_ground_on_rl_ - U16 h_own_16: applied less inertia force, body axes [N]
  const T t16_9 = minus_R16_11 * u.ground_rl_x + minus_R16_12 * u.ground_rl_y + minus_R16_13 * u.ground_rl_z;
  const T minus_G16_1 = t16_9 + U16_13 * T(0.029845530432320418);
  const T t16_10 = R14_21 * u.ground_rl_x + R14_22 * u.ground_rl_y + R14_23 * u.ground_rl_z;
  const T G16_2 = t16_10 - U16_23 * T(0.029845530432320418);
  const T t16_11 = R16_31 * u.ground_rl_x + R16_32 * u.ground_rl_y + R16_33 * u.ground_rl_z;
  const T G16_3 = t16_11 + minus_U16_33 * T(0.029845530432320418);
  // N16 = o16~ R16 F_ground_on_rl_ - h_own_16~ Pddot16 - axial(U16 (tr(J_own_16)/2 - J_own_16)): applied less inertia
  //   moment about the body origin, body axes [N m]
  const T N16_1 = T(0.0838) * t16_11 - T(0.19987185731301527) * t16_10 + T(0.029845530432320418) * Pddot16_2 +
      T(4.712093241166159e-05) * U16_32 + T(0.007297717301242339) * U16_23 - T(0.0025010554502284503) * (minus_U16_22
      - minus_U16_33) + T(5.215891594784536e-35) * minus_U16_31 + T(0.0002865260721362275) * U16_21;
  const T N16_2 = T(0.029845530432320418) * minus_Pddot16_1 - (T(0.19987185731301527) * t16_9 +
      T(0.007158257766082217) * t16_11) - T(0.007297717301242339) * U16_13 - T(4.712093241166159e-05) * minus_U16_31 -
      T(0.0002865260721362275) * (minus_U16_33 - minus_U16_11) + T(0.0025010554502284503) * minus_U16_12 +
      T(5.215891594784536e-35) * U16_32;
  const T N16_3 = T(0.007158257766082217) * t16_10 + T(0.0838) * t16_9 - T(4.712093241166159e-05) * U16_21 +
      T(4.712093241166159e-05) * minus_U16_12 - T(5.215891594784536e-35) * (minus_U16_11 - minus_U16_22) -
      T(0.0002865260721362275) * U16_23 + T(0.0025010554502284503) * U16_13;

  // ---- body 16 (rl_calf) and what it carries
  // u_16 = b16 . N16 + effort_rl_calf_16: drives it [N m], [N]
  const T u_16 = N16_2 + effort_rl_calf_16;
  // v16 = invD16 u_16: u/D
  const T v16 = T(136.15003737155251) * u_16;
  // gt16 = G16 - v16 B16: force with the turn solved [N]
  const T minus_gt16_1 = minus_G16_1 + v16 * T(0.029845530432320418);
  // nt16 = -effort_rl_calf_16 b16 + P_b16 (N16 - v16 K16): moment with the turn solved [N m]
  const T nt16_1 = N16_1 + v16 * T(5.215891594784536e-35);
  const T nt16_3 = N16_3 + v16 * T(0.0025010554502284503);
  // Mp16 = E16^T M16 E16: M passed on, lower body's axes [kg]
  const T b16_1 = minus_E16_13 * T(0.12127642004491364);
  const T b16_2 = minus_E16_13 * b16_1;
  const T Mp16_11 = b16_2 - T(0.12127642004491364);
  const T minus_Mp16_13 = minus_E16_11 * b16_1;
  // gp16 = E16^T gt16: force passed on, lower body's axes [N]
  const T gp16_1 = minus_E16_11 * minus_gt16_1 + minus_E16_13 * G16_3;
  const T gp16_3 = minus_E16_13 * minus_gt16_1 - minus_E16_11 * G16_3;
  // Hp16 = E16^T H16 E16: H passed on, lower body's axes [kg m]
  const T b16_3 = minus_E16_13 * T(2.11946194554078e-34) + minus_E16_11 * T(0.010162963999763762);
  const T b16_4 = minus_E16_13 * b16_3;
  const T Hp16_11 = T(2.11946194554078e-34) - b16_4;
  const T Hp16_12 = minus_E16_11 * T(0.029845530432320418);
  const T b16_5 = minus_E16_11 * b16_3;
  const T Hp16_13 = b16_5 - T(0.010162963999763762);
  const T Hp16_32 = minus_E16_13 * T(0.029845530432320418);
  // Jp16 = E16^T J16 E16: J passed on, lower body's axes [kg m^2]
  const T b16_6 = T(2) * minus_E16_11 * T(0.0002865260721362275) - minus_E16_13 * T(0.00810225275201088);
  const T b16_7 = minus_E16_13 * b16_6;
  const T Jp16_11 = T(0.007250596368830678) + b16_7;
  const T Jp16_13 = T(0.0002865260721362275) - minus_E16_11 * b16_6;
  const T minus_Jp16_33 = T(0.0008516563831802031) + b16_7;
  // np16 = E16^T nt16: moment passed on, lower body's axes [N m]
  const T np16_1 = minus_E16_13 * nt16_3 - minus_E16_11 * nt16_1;
  const T minus_np16_3 = minus_E16_13 * nt16_1 + minus_E16_11 * nt16_3;
  // Hb16 = q16~ Mp16 + Hp16: H of the joint at the lower body's origin, its axes
  const T minus_Hb16_21 = T(0.2) * Mp16_11;
  const T Hb16_23 = T(0.2) * minus_Mp16_13;

  // ---- body 15 (rl_thigh) and what it carries
  // HA15 = h_own_15~ + Hb16: moment for an acceleration of the origin, body axes [kg m]
  const T HA15_12 = Hp16_12 + T(0.072881238);
  const T minus_HA15_21 = T(0.072881238) + minus_Hb16_21;
  const T HA15_23 = T(0.0032790809999999997) + Hb16_23;
  const T HA15_32 = Hp16_32 - T(0.0032790809999999997);
  // JA15 = q16~ Hp16^T + J_own_15 + Jp16 - Hb16 q16~: moment for an angular acceleration, body axes [kg m^2]
  const T JA15_11 = T(0.013947080124391002) + Jp16_11 + T(0.4) * Hp16_12;
  const T JA15_12 = T(0.00020639994631299998) - T(0.2) * Hp16_11;
  const T JA15_13 = T(0.000254264832594) + Jp16_13 + T(0.2) * Hp16_32;
  const T JA15_22 = T(0.014946370894785) + minus_Hb16_21 * T(0.2);
  const T JA15_23 = T(0.005511856743573999) - T(0.2) * b16_5;
  // g15 = G15 + gp16: force that drives it, home axes [N]
  const T g15_1 = gp16_1 - minus_G15_1;
  const T g15_2 = G16_2 + G15_2;
  const T g15_3 = gp16_3 - minus_G15_3;
  // n15 = q16~ gp16 + N15 + np16: moment that drives it, body axes [N m]
  const T n15_1 = np16_1 - minus_N15_1 + T(0.2) * G16_2;
  const T minus_n15_2 = minus_N15_2 + effort_rl_calf_16 + T(0.2) * gp16_1;
  const T minus_n15_3 = minus_N15_3 + minus_np16_3;
  // invD15 = D15^-1: 1/D
  const T invD15 = T(1) / JA15_22;
  // kB15 = invD15 B15: B/D
  const T minus_kB15_1 = invD15 * minus_HA15_21;
  const T kB15_3 = invD15 * HA15_23;
  // kK15 = invD15 K15: K/D
  const T kK15_1 = invD15 * JA15_12;
  const T kK15_3 = invD15 * JA15_23;
  // u_15 = b15 . n15 + effort_rl_thigh_15: drives it [N m], [N]
  const T u_15 = effort_rl_thigh_15 - minus_n15_2;
  // v15 = invD15 u_15: u/D
  const T v15 = invD15 * u_15;
  // M15 = Mp16 - kB15 B15^T: MA less what the turn takes up [kg]
  const T M15_11 = Mp16_11 - minus_kB15_1 * minus_HA15_21;
  const T M15_13 = minus_kB15_1 * HA15_23 - minus_Mp16_13;
  const T minus_M15_33 = b16_2 + kB15_3 * HA15_23;
  // H15 = P_b15 (HA15 - kK15 B15^T): HA less what the turn takes up [kg m]
  const T H15_11 = Hp16_11 + kK15_1 * minus_HA15_21;
  const T H15_13 = Hp16_13 - kK15_1 * HA15_23;
  const T H15_31 = b16_5 + kK15_3 * minus_HA15_21;
  const T H15_33 = b16_4 - kK15_3 * HA15_23;
  // J15 = P_b15 (JA15 - kK15 K15^T) P_b15: JA less what the turn takes up [kg m^2]
  const T J15_11 = JA15_11 - kK15_1 * JA15_12;
  const T J15_13 = JA15_13 - kK15_1 * JA15_23;
  const T minus_J15_33 = minus_Jp16_33 + kK15_3 * JA15_23;
  // gt15 = g15 - v15 B15: force with the turn solved [N]
  const T gt15_1 = g15_1 + v15 * minus_HA15_21;
  const T gt15_3 = g15_3 - v15 * HA15_23;
  // nt15 = -effort_rl_thigh_15 b15 + P_b15 (n15 - v15 K15): moment with the turn solved [N m]
  const T nt15_1 = n15_1 - v15 * JA15_12;
  const T minus_nt15_3 = minus_n15_3 + v15 * JA15_23;
  // Mp15 = E15^T M15 E15: M passed on, lower body's axes [kg]
  const T b15_1 = T(2) * E15_11;
  const T b15_2 = b15_1 * M15_13 - minus_E15_13 * (minus_M15_33 + M15_11);
  const T b15_3 = minus_E15_13 * b15_2;
  const T Mp15_11 = M15_11 + b15_3;
  const T Mp15_13 = E15_11 * b15_2 - M15_13;
  const T minus_Mp15_33 = minus_M15_33 + b15_3;
  // gp15 = E15^T gt15: force passed on, lower body's axes [N]
  const T gp15_1 = E15_11 * gt15_1 + minus_E15_13 * gt15_3;
  const T gp15_3 = E15_11 * gt15_3 - minus_E15_13 * gt15_1;
  // Hp15 = E15^T H15 E15: H passed on, lower body's axes [kg m]
  const T b15_4 = minus_E15_13 * (H15_33 - H15_11) + E15_11 * (H15_31 + H15_13);
  const T b15_5 = minus_E15_13 * b15_4;
  const T Hp15_11 = H15_11 + b15_5;
  const T Hp15_12 = minus_E15_13 * HA15_32 + E15_11 * HA15_12;
  const T b15_6 = E15_11 * b15_4;
  const T Hp15_13 = b15_6 - H15_31;
  const T Hp15_31 = b15_6 - H15_13;
  const T Hp15_32 = E15_11 * HA15_32 - minus_E15_13 * HA15_12;
  const T Hp15_33 = H15_33 - b15_5;
  // Jp15 = E15^T J15 E15: J passed on, lower body's axes [kg m^2]
  const T b15_7 = b15_1 * J15_13 - minus_E15_13 * (minus_J15_33 + J15_11);
  const T b15_8 = minus_E15_13 * b15_7;
  const T Jp15_11 = J15_11 + b15_8;
  const T Jp15_13 = E15_11 * b15_7 - J15_13;
  const T minus_Jp15_33 = minus_J15_33 + b15_8;
  // np15 = E15^T nt15: moment passed on, lower body's axes [N m]
  const T np15_1 = E15_11 * nt15_1 - minus_E15_13 * minus_nt15_3;
  const T minus_np15_3 = minus_E15_13 * nt15_1 + E15_11 * minus_nt15_3;
  // Hb15 = q15~ Mp15 + Hp15: H of the joint at the lower body's origin, its axes
  const T Hb15_21 = T(0.1805) * Mp15_13;
  const T minus_Hb15_23 = T(0.1805) * minus_Mp15_33;

  // ---- body 14 (rl_hip) and what it carries
  // HA14 = h_own_14~ + Hb15: moment for an acceleration of the origin, body axes [kg m]
  const T HA14_12 = Hp15_12 - T(2.1575999999999998e-05);
  const T HA14_13 = T(0.081652909) + Hp15_13;
  const T HA14_21 = T(2.1575999999999998e-05) + Hb15_21;
  const T HA14_31 = Hp15_31 - T(0.081652909);
  // JA14 = q15~ Hp15^T + J_own_14 + Jp15 - Hb15 q15~: moment for an angular acceleration, body axes [kg m^2]
  const T JA14_11 = T(0.007323165886541661) + Jp15_11;
  const T JA14_12 = T(0.014746295744939998) + T(0.1805) * Hp15_13;
  const T JA14_13 = T(4.165029864e-06) + Jp15_13 - T(0.1805) * Hp15_12;
  const T minus_JA14_22 = minus_Hb15_23 * T(0.1805);
  const T JA14_23 = T(0.1805) * Hp15_33 - T(4.7970076e-07);
  const T JA14_33 = T(0.006599357548829661) - minus_Jp15_33 - T(0.361) * Hp15_32;
  // g14 = G14 + gp15: force that drives it, home axes [N]
  const T g14_1 = gp15_1 - minus_G14_1;
  const T g14_2 = g15_2 - minus_G14_2;
  const T g14_3 = gp15_3 - minus_G14_3;
  // n14 = q15~ gp15 + N14 + np15: moment that drives it, body axes [N m]
  const T n14_1 = np15_1 - minus_N14_1;
  const T n14_2 = T(0.1805) * gp15_3 - (minus_N14_2 + effort_rl_thigh_15);
  const T n14_3 = N14_3 - minus_np15_3 - T(0.1805) * g15_2;
  // invD14 = D14^-1: 1/D
  const T invD14 = T(1) / JA14_11;
  // kB14 = invD14 B14: B/D
  const T kB14_1 = invD14 * Hp15_11;
  const T kB14_2 = invD14 * HA14_12;
  const T kB14_3 = invD14 * HA14_13;
  // kK14 = invD14 K14: K/D
  const T kK14_2 = invD14 * JA14_12;
  const T kK14_3 = invD14 * JA14_13;
  // u_14 = b14 . n14 + effort_rl_hip_14: drives it [N m], [N]
  const T u_14 = n14_1 + effort_rl_hip_14;
  // v14 = invD14 u_14: u/D
  const T v14 = invD14 * u_14;
  // M14 = Mp15 - kB14 B14^T: MA less what the turn takes up [kg]
  const T M14_11 = Mp15_11 - kB14_1 * Hp15_11;
  const T minus_M14_12 = kB14_1 * HA14_12;
  const T M14_13 = Mp15_13 - kB14_1 * HA14_13;
  const T minus_M14_22 = kB14_2 * HA14_12;
  const T minus_M14_23 = kB14_2 * HA14_13;
  const T minus_M14_33 = minus_Mp15_33 + kB14_3 * HA14_13;
  // H14 = P_b14 (HA14 - kK14 B14^T): HA less what the turn takes up [kg m]
  const T H14_21 = HA14_21 - kK14_2 * Hp15_11;
  const T minus_H14_22 = kK14_2 * HA14_12;
  const T minus_H14_23 = minus_Hb15_23 + kK14_2 * HA14_13;
  const T H14_31 = HA14_31 - kK14_3 * Hp15_11;
  const T H14_32 = Hp15_32 - kK14_3 * HA14_12;
  const T H14_33 = Hp15_33 - kK14_3 * HA14_13;
  // J14 = P_b14 (JA14 - kK14 K14^T) P_b14: JA less what the turn takes up [kg m^2]
  const T minus_J14_22 = minus_JA14_22 + kK14_2 * JA14_12;
  const T J14_23 = JA14_23 - kK14_2 * JA14_13;
  const T J14_33 = JA14_33 - kK14_3 * JA14_13;
  // gt14 = g14 - v14 B14: force with the turn solved [N]
  const T gt14_1 = g14_1 - v14 * Hp15_11;
  const T gt14_2 = g14_2 - v14 * HA14_12;
  const T gt14_3 = g14_3 - v14 * HA14_13;
  // nt14 = -effort_rl_hip_14 b14 + P_b14 (n14 - v14 K14): moment with the turn solved [N m]
  const T nt14_2 = n14_2 - v14 * JA14_12;
  const T nt14_3 = n14_3 - v14 * JA14_13;
  // Mp14 = E14^T M14 E14: M passed on, lower body's axes [kg]
  const T minus_Mp14_12 = E14_22 * minus_M14_12 + E14_23 * M14_13;
  const T Mp14_13 = E14_22 * M14_13 - E14_23 * minus_M14_12;
  const T b14_1 = T(2) * E14_22;
  const T b14_2 = E14_23 * (minus_M14_33 - minus_M14_22) - b14_1 * minus_M14_23;
  const T b14_3 = E14_23 * b14_2;
  const T minus_Mp14_22 = minus_M14_22 + b14_3;
  const T Mp14_23 = minus_M14_23 + E14_22 * b14_2;
  const T Mp14_33 = b14_3 - minus_M14_33;
  // gp14 = E14^T gt14: force passed on, lower body's axes [N]
  const T gp14_2 = E14_22 * gt14_2 - E14_23 * gt14_3;
  const T gp14_3 = E14_23 * gt14_2 + E14_22 * gt14_3;
  // Hp14 = E14^T H14 E14: H passed on, lower body's axes [kg m]
  const T Hp14_21 = E14_22 * H14_21 - E14_23 * H14_31;
  const T b14_4 = E14_22 * (H14_32 - minus_H14_23) - E14_23 * (minus_H14_22 + H14_33);
  const T b14_5 = E14_23 * b14_4;
  const T minus_Hp14_22 = minus_H14_22 + b14_5;
  const T b14_6 = E14_22 * b14_4;
  const T Hp14_23 = b14_6 - H14_32;
  const T Hp14_31 = E14_23 * H14_21 + E14_22 * H14_31;
  const T Hp14_32 = b14_6 + minus_H14_23;
  const T Hp14_33 = H14_33 + b14_5;
  // Jp14 = E14^T J14 E14: J passed on, lower body's axes [kg m^2]
  const T b14_7 = b14_1 * J14_23 - E14_23 * (minus_J14_22 + J14_33);
  const T b14_8 = E14_23 * b14_7;
  const T minus_Jp14_22 = minus_J14_22 + b14_8;
  const T Jp14_23 = E14_22 * b14_7 - J14_23;
  const T Jp14_33 = J14_33 + b14_8;
  // np14 = E14^T nt14: moment passed on, lower body's axes [N m]
  const T np14_2 = E14_22 * nt14_2 - E14_23 * nt14_3;
  const T np14_3 = E14_23 * nt14_2 + E14_22 * nt14_3;
  // Hb14 = q14~ Mp14 + Hp14: H of the joint at the lower body's origin, its axes
  const T Hb14_11 = T(0.047) * Mp14_13;
  const T Hb14_12 = T(0.047) * Mp14_23;
  const T Hb14_13 = T(0.047) * Mp14_33;
  const T Hb14_31 = Hp14_31 - T(0.047) * M14_11;
  const T Hb14_32 = Hp14_32 + T(0.047) * minus_Mp14_12;
  const T Hb14_33 = Hp14_33 - Hb14_11;

  // ---- body 12 (rr_calf) and what it carries
  // u_12 = b12 . N12 + effort_rr_calf_12: drives it [N m], [N]
  const T u_12 = N12_2 + effort_rr_calf_12;
  // v12 = invD12 u_12: u/D
  const T v12 = T(136.15003737155251) * u_12;
  // gt12 = G12 - v12 B12: force with the turn solved [N]
  const T minus_gt12_1 = minus_G12_1 + v12 * T(0.029845530432320418);
  // nt12 = -effort_rr_calf_12 b12 + P_b12 (N12 - v12 K12): moment with the turn solved [N m]
  const T nt12_1 = N12_1 - v12 * T(5.215891594784536e-35);
  const T nt12_3 = N12_3 - v12 * T(0.0025010554502284503);
  // Mp12 = E12^T M12 E12: M passed on, lower body's axes [kg]
  const T b12_1 = minus_E12_13 * T(0.12127642004491364);
  const T b12_2 = minus_E12_13 * b12_1;
  const T Mp12_11 = b12_2 - T(0.12127642004491364);
  const T minus_Mp12_13 = minus_E12_11 * b12_1;
  // gp12 = E12^T gt12: force passed on, lower body's axes [N]
  const T gp12_1 = minus_E12_11 * minus_gt12_1 + minus_E12_13 * G12_3;
  const T gp12_3 = minus_E12_13 * minus_gt12_1 - minus_E12_11 * G12_3;
  // Hp12 = E12^T H12 E12: H passed on, lower body's axes [kg m]
  const T b12_3 = minus_E12_13 * T(2.11946194554078e-34) + minus_E12_11 * T(0.010162963999763762);
  const T b12_4 = minus_E12_13 * b12_3;
  const T Hp12_11 = b12_4 - T(2.11946194554078e-34);
  const T Hp12_12 = minus_E12_11 * T(0.029845530432320418);
  const T b12_5 = minus_E12_11 * b12_3;
  const T Hp12_13 = T(0.010162963999763762) - b12_5;
  const T Hp12_32 = minus_E12_13 * T(0.029845530432320418);
  // Jp12 = E12^T J12 E12: J passed on, lower body's axes [kg m^2]
  const T b12_6 = T(2) * minus_E12_11 * T(0.0002865260721362275) - minus_E12_13 * T(0.00810225275201088);
  const T b12_7 = minus_E12_13 * b12_6;
  const T Jp12_11 = T(0.007250596368830678) + b12_7;
  const T Jp12_13 = T(0.0002865260721362275) - minus_E12_11 * b12_6;
  const T minus_Jp12_33 = T(0.0008516563831802031) + b12_7;
  // np12 = E12^T nt12: moment passed on, lower body's axes [N m]
  const T np12_1 = minus_E12_13 * nt12_3 - minus_E12_11 * nt12_1;
  const T minus_np12_3 = minus_E12_13 * nt12_1 + minus_E12_11 * nt12_3;
  // Hb12 = q12~ Mp12 + Hp12: H of the joint at the lower body's origin, its axes
  const T minus_Hb12_21 = T(0.2) * Mp12_11;
  const T Hb12_23 = T(0.2) * minus_Mp12_13;

  // ---- body 11 (rr_thigh) and what it carries
  // HA11 = h_own_11~ + Hb12: moment for an acceleration of the origin, body axes [kg m]
  const T HA11_12 = Hp12_12 + T(0.072881238);
  const T minus_HA11_21 = T(0.072881238) + minus_Hb12_21;
  const T HA11_23 = T(0.0032790809999999997) + Hb12_23;
  const T HA11_32 = Hp12_32 - T(0.0032790809999999997);
  // JA11 = q12~ Hp12^T + J_own_11 + Jp12 - Hb12 q12~: moment for an angular acceleration, body axes [kg m^2]
  const T JA11_11 = T(0.013947080124391002) + Jp12_11 + T(0.4) * Hp12_12;
  const T minus_JA11_12 = T(0.00020639994631299998) + T(0.2) * Hp12_11;
  const T JA11_13 = T(0.000254264832594) + Jp12_13 + T(0.2) * Hp12_32;
  const T JA11_22 = T(0.014946370894785) + minus_Hb12_21 * T(0.2);
  const T JA11_23 = T(0.2) * b12_5 - T(0.005511856743573999);
  // g11 = G11 + gp12: force that drives it, home axes [N]
  const T g11_1 = gp12_1 - minus_G11_1;
  const T g11_2 = G12_2 + G11_2;
  const T g11_3 = gp12_3 - minus_G11_3;
  // n11 = q12~ gp12 + N11 + np12: moment that drives it, body axes [N m]
  const T n11_1 = np12_1 - minus_N11_1 + T(0.2) * G12_2;
  const T minus_n11_2 = minus_N11_2 + effort_rr_calf_12 + T(0.2) * gp12_1;
  const T minus_n11_3 = minus_N11_3 + minus_np12_3;
  // invD11 = D11^-1: 1/D
  const T invD11 = T(1) / JA11_22;
  // kB11 = invD11 B11: B/D
  const T minus_kB11_1 = invD11 * minus_HA11_21;
  const T kB11_3 = invD11 * HA11_23;
  // kK11 = invD11 K11: K/D
  const T minus_kK11_1 = invD11 * minus_JA11_12;
  const T kK11_3 = invD11 * JA11_23;
  // u_11 = b11 . n11 + effort_rr_thigh_11: drives it [N m], [N]
  const T u_11 = effort_rr_thigh_11 - minus_n11_2;
  // v11 = invD11 u_11: u/D
  const T v11 = invD11 * u_11;
  // M11 = Mp12 - kB11 B11^T: MA less what the turn takes up [kg]
  const T M11_11 = Mp12_11 - minus_kB11_1 * minus_HA11_21;
  const T M11_13 = minus_kB11_1 * HA11_23 - minus_Mp12_13;
  const T minus_M11_33 = b12_2 + kB11_3 * HA11_23;
  // H11 = P_b11 (HA11 - kK11 B11^T): HA less what the turn takes up [kg m]
  const T H11_11 = Hp12_11 - minus_kK11_1 * minus_HA11_21;
  const T H11_13 = Hp12_13 + minus_kK11_1 * HA11_23;
  const T H11_31 = kK11_3 * minus_HA11_21 - b12_5;
  const T minus_H11_33 = b12_4 + kK11_3 * HA11_23;
  // J11 = P_b11 (JA11 - kK11 K11^T) P_b11: JA less what the turn takes up [kg m^2]
  const T J11_11 = JA11_11 - minus_kK11_1 * minus_JA11_12;
  const T J11_13 = JA11_13 + minus_kK11_1 * JA11_23;
  const T minus_J11_33 = minus_Jp12_33 + kK11_3 * JA11_23;
  // gt11 = g11 - v11 B11: force with the turn solved [N]
  const T gt11_1 = g11_1 + v11 * minus_HA11_21;
  const T gt11_3 = g11_3 - v11 * HA11_23;
  // nt11 = -effort_rr_thigh_11 b11 + P_b11 (n11 - v11 K11): moment with the turn solved [N m]
  const T nt11_1 = n11_1 + v11 * minus_JA11_12;
  const T minus_nt11_3 = minus_n11_3 + v11 * JA11_23;
  // Mp11 = E11^T M11 E11: M passed on, lower body's axes [kg]
  const T b11_1 = T(2) * E11_11;
  const T b11_2 = b11_1 * M11_13 - minus_E11_13 * (minus_M11_33 + M11_11);
  const T b11_3 = minus_E11_13 * b11_2;
  const T Mp11_11 = M11_11 + b11_3;
  const T Mp11_13 = E11_11 * b11_2 - M11_13;
  const T minus_Mp11_33 = minus_M11_33 + b11_3;
  // gp11 = E11^T gt11: force passed on, lower body's axes [N]
  const T gp11_1 = E11_11 * gt11_1 + minus_E11_13 * gt11_3;
  const T gp11_3 = E11_11 * gt11_3 - minus_E11_13 * gt11_1;
  // Hp11 = E11^T H11 E11: H passed on, lower body's axes [kg m]
  const T b11_4 = E11_11 * (H11_31 + H11_13) - minus_E11_13 * (minus_H11_33 + H11_11);
  const T b11_5 = minus_E11_13 * b11_4;
  const T Hp11_11 = H11_11 + b11_5;
  const T Hp11_12 = minus_E11_13 * HA11_32 + E11_11 * HA11_12;
  const T b11_6 = E11_11 * b11_4;
  const T Hp11_13 = b11_6 - H11_31;
  const T Hp11_31 = b11_6 - H11_13;
  const T Hp11_32 = E11_11 * HA11_32 - minus_E11_13 * HA11_12;
  const T minus_Hp11_33 = minus_H11_33 + b11_5;
  // Jp11 = E11^T J11 E11: J passed on, lower body's axes [kg m^2]
  const T b11_7 = b11_1 * J11_13 - minus_E11_13 * (minus_J11_33 + J11_11);
  const T b11_8 = minus_E11_13 * b11_7;
  const T Jp11_11 = J11_11 + b11_8;
  const T Jp11_13 = E11_11 * b11_7 - J11_13;
  const T minus_Jp11_33 = minus_J11_33 + b11_8;
  // np11 = E11^T nt11: moment passed on, lower body's axes [N m]
  const T np11_1 = E11_11 * nt11_1 - minus_E11_13 * minus_nt11_3;
  const T minus_np11_3 = minus_E11_13 * nt11_1 + E11_11 * minus_nt11_3;
  // Hb11 = q11~ Mp11 + Hp11: H of the joint at the lower body's origin, its axes
  const T Hb11_21 = T(0.1805) * Mp11_13;
  const T minus_Hb11_23 = T(0.1805) * minus_Mp11_33;

  // ---- body 10 (rr_hip) and what it carries
  // HA10 = h_own_10~ + Hb11: moment for an acceleration of the origin, body axes [kg m]
  const T HA10_12 = Hp11_12 - T(2.1575999999999998e-05);
  const T HA10_13 = Hp11_13 - T(0.081652909);
  const T HA10_21 = T(2.1575999999999998e-05) + Hb11_21;
  const T HA10_31 = Hp11_31 + T(0.081652909);
  // JA10 = q11~ Hp11^T + J_own_10 + Jp11 - Hb11 q11~: moment for an angular acceleration, body axes [kg m^2]
  const T JA10_11 = T(0.007323165886541661) + Jp11_11;
  const T JA10_12 = T(0.1805) * Hp11_13 - T(0.014746295744939998);
  const T JA10_13 = T(4.165029864e-06) + Jp11_13 - T(0.1805) * Hp11_12;
  const T minus_JA10_22 = minus_Hb11_23 * T(0.1805);
  const T JA10_23 = T(4.7970076e-07) - T(0.1805) * minus_Hp11_33;
  const T JA10_33 = T(0.006599357548829661) - minus_Jp11_33 - T(0.361) * Hp11_32;
  // g10 = G10 + gp11: force that drives it, home axes [N]
  const T g10_1 = gp11_1 - minus_G10_1;
  const T g10_2 = g11_2 - minus_G10_2;
  const T g10_3 = gp11_3 + G10_3;
  // n10 = q11~ gp11 + N10 + np11: moment that drives it, body axes [N m]
  const T n10_1 = np11_1 - minus_N10_1;
  const T n10_2 = T(0.1805) * gp11_3 - (minus_N10_2 + effort_rr_thigh_11);
  const T minus_n10_3 = minus_N10_3 + minus_np11_3 + T(0.1805) * g11_2;
  // invD10 = D10^-1: 1/D
  const T invD10 = T(1) / JA10_11;
  // kB10 = invD10 B10: B/D
  const T kB10_1 = invD10 * Hp11_11;
  const T kB10_2 = invD10 * HA10_12;
  const T kB10_3 = invD10 * HA10_13;
  // kK10 = invD10 K10: K/D
  const T kK10_2 = invD10 * JA10_12;
  const T kK10_3 = invD10 * JA10_13;
  // u_10 = b10 . n10 + effort_rr_hip_10: drives it [N m], [N]
  const T u_10 = n10_1 + effort_rr_hip_10;
  // v10 = invD10 u_10: u/D
  const T v10 = invD10 * u_10;
  // M10 = Mp11 - kB10 B10^T: MA less what the turn takes up [kg]
  const T M10_11 = Mp11_11 - kB10_1 * Hp11_11;
  const T minus_M10_12 = kB10_1 * HA10_12;
  const T M10_13 = Mp11_13 - kB10_1 * HA10_13;
  const T minus_M10_22 = kB10_2 * HA10_12;
  const T minus_M10_23 = kB10_2 * HA10_13;
  const T minus_M10_33 = minus_Mp11_33 + kB10_3 * HA10_13;
  // H10 = P_b10 (HA10 - kK10 B10^T): HA less what the turn takes up [kg m]
  const T H10_21 = HA10_21 - kK10_2 * Hp11_11;
  const T minus_H10_22 = kK10_2 * HA10_12;
  const T minus_H10_23 = minus_Hb11_23 + kK10_2 * HA10_13;
  const T H10_31 = HA10_31 - kK10_3 * Hp11_11;
  const T H10_32 = Hp11_32 - kK10_3 * HA10_12;
  const T minus_H10_33 = minus_Hp11_33 + kK10_3 * HA10_13;
  // J10 = P_b10 (JA10 - kK10 K10^T) P_b10: JA less what the turn takes up [kg m^2]
  const T minus_J10_22 = minus_JA10_22 + kK10_2 * JA10_12;
  const T J10_23 = JA10_23 - kK10_2 * JA10_13;
  const T J10_33 = JA10_33 - kK10_3 * JA10_13;
  // gt10 = g10 - v10 B10: force with the turn solved [N]
  const T gt10_1 = g10_1 - v10 * Hp11_11;
  const T gt10_2 = g10_2 - v10 * HA10_12;
  const T gt10_3 = g10_3 - v10 * HA10_13;
  // nt10 = -effort_rr_hip_10 b10 + P_b10 (n10 - v10 K10): moment with the turn solved [N m]
  const T nt10_2 = n10_2 - v10 * JA10_12;
  const T minus_nt10_3 = minus_n10_3 + v10 * JA10_13;
  // Mp10 = E10^T M10 E10: M passed on, lower body's axes [kg]
  const T minus_Mp10_12 = E10_22 * minus_M10_12 + E10_23 * M10_13;
  const T Mp10_13 = E10_22 * M10_13 - E10_23 * minus_M10_12;
  const T b10_1 = T(2) * E10_22;
  const T b10_2 = E10_23 * (minus_M10_33 - minus_M10_22) - b10_1 * minus_M10_23;
  const T b10_3 = E10_23 * b10_2;
  const T minus_Mp10_22 = minus_M10_22 + b10_3;
  const T Mp10_23 = minus_M10_23 + E10_22 * b10_2;
  const T Mp10_33 = b10_3 - minus_M10_33;
  // gp10 = E10^T gt10: force passed on, lower body's axes [N]
  const T gp10_2 = E10_22 * gt10_2 - E10_23 * gt10_3;
  const T gp10_3 = E10_23 * gt10_2 + E10_22 * gt10_3;
  // Hp10 = E10^T H10 E10: H passed on, lower body's axes [kg m]
  const T Hp10_21 = E10_22 * H10_21 - E10_23 * H10_31;
  const T b10_4 = E10_23 * (minus_H10_33 - minus_H10_22) + E10_22 * (H10_32 - minus_H10_23);
  const T b10_5 = E10_23 * b10_4;
  const T minus_Hp10_22 = minus_H10_22 + b10_5;
  const T b10_6 = E10_22 * b10_4;
  const T Hp10_23 = b10_6 - H10_32;
  const T Hp10_31 = E10_23 * H10_21 + E10_22 * H10_31;
  const T Hp10_32 = b10_6 + minus_H10_23;
  const T Hp10_33 = b10_5 - minus_H10_33;
  // Jp10 = E10^T J10 E10: J passed on, lower body's axes [kg m^2]
  const T b10_7 = b10_1 * J10_23 - E10_23 * (minus_J10_22 + J10_33);
  const T b10_8 = E10_23 * b10_7;
  const T minus_Jp10_22 = minus_J10_22 + b10_8;
  const T Jp10_23 = E10_22 * b10_7 - J10_23;
  const T Jp10_33 = J10_33 + b10_8;
  // np10 = E10^T nt10: moment passed on, lower body's axes [N m]
  const T np10_2 = E10_22 * nt10_2 + E10_23 * minus_nt10_3;
  const T np10_3 = E10_23 * nt10_2 - E10_22 * minus_nt10_3;
  // Hb10 = q10~ Mp10 + Hp10: H of the joint at the lower body's origin, its axes
  const T minus_Hb10_11 = T(0.047) * Mp10_13;
  const T minus_Hb10_12 = T(0.047) * Mp10_23;
  const T minus_Hb10_13 = T(0.047) * Mp10_33;
  const T Hb10_31 = Hp10_31 + T(0.047) * M10_11;
  const T Hb10_32 = Hp10_32 - T(0.047) * minus_Mp10_12;
  const T Hb10_33 = minus_Hb10_11 + Hp10_33;

  // ---- body 8 (fl_calf) and what it carries
  // u_8 = b8 . N8 + effort_fl_calf_8: drives it [N m], [N]
  const T u_8 = N8_2 + effort_fl_calf_8;
  // v8 = invD8 u_8: u/D
  const T v8 = T(136.15003737155251) * u_8;
  // gt8 = G8 - v8 B8: force with the turn solved [N]
  const T minus_gt8_1 = minus_G8_1 + v8 * T(0.029845530432320418);
  // nt8 = -effort_fl_calf_8 b8 + P_b8 (N8 - v8 K8): moment with the turn solved [N m]
  const T nt8_1 = N8_1 + v8 * T(5.215891594784536e-35);
  const T nt8_3 = N8_3 + v8 * T(0.0025010554502284503);
  // Mp8 = E8^T M8 E8: M passed on, lower body's axes [kg]
  const T b8_1 = minus_E8_13 * T(0.12127642004491364);
  const T b8_2 = minus_E8_13 * b8_1;
  const T Mp8_11 = b8_2 - T(0.12127642004491364);
  const T minus_Mp8_13 = minus_E8_11 * b8_1;
  // gp8 = E8^T gt8: force passed on, lower body's axes [N]
  const T gp8_1 = minus_E8_11 * minus_gt8_1 + minus_E8_13 * G8_3;
  const T gp8_3 = minus_E8_13 * minus_gt8_1 - minus_E8_11 * G8_3;
  // Hp8 = E8^T H8 E8: H passed on, lower body's axes [kg m]
  const T b8_3 = minus_E8_13 * T(2.11946194554078e-34) + minus_E8_11 * T(0.010162963999763762);
  const T b8_4 = minus_E8_13 * b8_3;
  const T Hp8_11 = T(2.11946194554078e-34) - b8_4;
  const T Hp8_12 = minus_E8_11 * T(0.029845530432320418);
  const T b8_5 = minus_E8_11 * b8_3;
  const T Hp8_13 = b8_5 - T(0.010162963999763762);
  const T Hp8_32 = minus_E8_13 * T(0.029845530432320418);
  // Jp8 = E8^T J8 E8: J passed on, lower body's axes [kg m^2]
  const T b8_6 = T(2) * minus_E8_11 * T(0.0002865260721362275) - minus_E8_13 * T(0.00810225275201088);
  const T b8_7 = minus_E8_13 * b8_6;
  const T Jp8_11 = T(0.007250596368830678) + b8_7;
  const T Jp8_13 = T(0.0002865260721362275) - minus_E8_11 * b8_6;
  const T minus_Jp8_33 = T(0.0008516563831802031) + b8_7;
  // np8 = E8^T nt8: moment passed on, lower body's axes [N m]
  const T np8_1 = minus_E8_13 * nt8_3 - minus_E8_11 * nt8_1;
  const T minus_np8_3 = minus_E8_13 * nt8_1 + minus_E8_11 * nt8_3;
  // Hb8 = q8~ Mp8 + Hp8: H of the joint at the lower body's origin, its axes
  const T minus_Hb8_21 = T(0.2) * Mp8_11;
  const T Hb8_23 = T(0.2) * minus_Mp8_13;

  // ---- body 7 (fl_thigh) and what it carries
  // HA7 = h_own_7~ + Hb8: moment for an acceleration of the origin, body axes [kg m]
  const T HA7_12 = Hp8_12 + T(0.072881238);
  const T minus_HA7_21 = T(0.072881238) + minus_Hb8_21;
  const T HA7_23 = T(0.0032790809999999997) + Hb8_23;
  const T HA7_32 = Hp8_32 - T(0.0032790809999999997);
  // JA7 = q8~ Hp8^T + J_own_7 + Jp8 - Hb8 q8~: moment for an angular acceleration, body axes [kg m^2]
  const T JA7_11 = T(0.013947080124391002) + Jp8_11 + T(0.4) * Hp8_12;
  const T JA7_12 = T(0.00020639994631299998) - T(0.2) * Hp8_11;
  const T JA7_13 = T(0.000254264832594) + Jp8_13 + T(0.2) * Hp8_32;
  const T JA7_22 = T(0.014946370894785) + minus_Hb8_21 * T(0.2);
  const T JA7_23 = T(0.005511856743573999) - T(0.2) * b8_5;
  // g7 = G7 + gp8: force that drives it, home axes [N]
  const T g7_1 = gp8_1 - minus_G7_1;
  const T g7_2 = G8_2 + G7_2;
  const T g7_3 = gp8_3 - minus_G7_3;
  // n7 = q8~ gp8 + N7 + np8: moment that drives it, body axes [N m]
  const T n7_1 = np8_1 - minus_N7_1 + T(0.2) * G8_2;
  const T minus_n7_2 = minus_N7_2 + effort_fl_calf_8 + T(0.2) * gp8_1;
  const T minus_n7_3 = minus_N7_3 + minus_np8_3;
  // invD7 = D7^-1: 1/D
  const T invD7 = T(1) / JA7_22;
  // kB7 = invD7 B7: B/D
  const T minus_kB7_1 = invD7 * minus_HA7_21;
  const T kB7_3 = invD7 * HA7_23;
  // kK7 = invD7 K7: K/D
  const T kK7_1 = invD7 * JA7_12;
  const T kK7_3 = invD7 * JA7_23;
  // u_7 = b7 . n7 + effort_fl_thigh_7: drives it [N m], [N]
  const T u_7 = effort_fl_thigh_7 - minus_n7_2;
  // v7 = invD7 u_7: u/D
  const T v7 = invD7 * u_7;
  // M7 = Mp8 - kB7 B7^T: MA less what the turn takes up [kg]
  const T M7_11 = Mp8_11 - minus_kB7_1 * minus_HA7_21;
  const T M7_13 = minus_kB7_1 * HA7_23 - minus_Mp8_13;
  const T minus_M7_33 = b8_2 + kB7_3 * HA7_23;
  // H7 = P_b7 (HA7 - kK7 B7^T): HA less what the turn takes up [kg m]
  const T H7_11 = Hp8_11 + kK7_1 * minus_HA7_21;
  const T H7_13 = Hp8_13 - kK7_1 * HA7_23;
  const T H7_31 = b8_5 + kK7_3 * minus_HA7_21;
  const T H7_33 = b8_4 - kK7_3 * HA7_23;
  // J7 = P_b7 (JA7 - kK7 K7^T) P_b7: JA less what the turn takes up [kg m^2]
  const T J7_11 = JA7_11 - kK7_1 * JA7_12;
  const T J7_13 = JA7_13 - kK7_1 * JA7_23;
  const T minus_J7_33 = minus_Jp8_33 + kK7_3 * JA7_23;
  // gt7 = g7 - v7 B7: force with the turn solved [N]
  const T gt7_1 = g7_1 + v7 * minus_HA7_21;
  const T gt7_3 = g7_3 - v7 * HA7_23;
  // nt7 = -effort_fl_thigh_7 b7 + P_b7 (n7 - v7 K7): moment with the turn solved [N m]
  const T nt7_1 = n7_1 - v7 * JA7_12;
  const T minus_nt7_3 = minus_n7_3 + v7 * JA7_23;
  // Mp7 = E7^T M7 E7: M passed on, lower body's axes [kg]
  const T b7_1 = T(2) * E7_11;
  const T b7_2 = b7_1 * M7_13 - minus_E7_13 * (minus_M7_33 + M7_11);
  const T b7_3 = minus_E7_13 * b7_2;
  const T Mp7_11 = M7_11 + b7_3;
  const T Mp7_13 = E7_11 * b7_2 - M7_13;
  const T minus_Mp7_33 = minus_M7_33 + b7_3;
  // gp7 = E7^T gt7: force passed on, lower body's axes [N]
  const T gp7_1 = E7_11 * gt7_1 + minus_E7_13 * gt7_3;
  const T gp7_3 = E7_11 * gt7_3 - minus_E7_13 * gt7_1;
  // Hp7 = E7^T H7 E7: H passed on, lower body's axes [kg m]
  const T b7_4 = minus_E7_13 * (H7_33 - H7_11) + E7_11 * (H7_31 + H7_13);
  const T b7_5 = minus_E7_13 * b7_4;
  const T Hp7_11 = H7_11 + b7_5;
  const T Hp7_12 = minus_E7_13 * HA7_32 + E7_11 * HA7_12;
  const T b7_6 = E7_11 * b7_4;
  const T Hp7_13 = b7_6 - H7_31;
  const T Hp7_31 = b7_6 - H7_13;
  const T Hp7_32 = E7_11 * HA7_32 - minus_E7_13 * HA7_12;
  const T Hp7_33 = H7_33 - b7_5;
  // Jp7 = E7^T J7 E7: J passed on, lower body's axes [kg m^2]
  const T b7_7 = b7_1 * J7_13 - minus_E7_13 * (minus_J7_33 + J7_11);
  const T b7_8 = minus_E7_13 * b7_7;
  const T Jp7_11 = J7_11 + b7_8;
  const T Jp7_13 = E7_11 * b7_7 - J7_13;
  const T minus_Jp7_33 = minus_J7_33 + b7_8;
  // np7 = E7^T nt7: moment passed on, lower body's axes [N m]
  const T np7_1 = E7_11 * nt7_1 - minus_E7_13 * minus_nt7_3;
  const T minus_np7_3 = minus_E7_13 * nt7_1 + E7_11 * minus_nt7_3;
  // Hb7 = q7~ Mp7 + Hp7: H of the joint at the lower body's origin, its axes
  const T minus_Hb7_21 = T(0.1805) * Mp7_13;
  const T Hb7_23 = T(0.1805) * minus_Mp7_33;

  // ---- body 6 (fl_hip) and what it carries
  // HA6 = h_own_6~ + Hb7: moment for an acceleration of the origin, body axes [kg m]
  const T HA6_12 = Hp7_12 - T(2.1575999999999998e-05);
  const T HA6_13 = T(0.081652909) + Hp7_13;
  const T HA6_21 = T(2.1575999999999998e-05) - minus_Hb7_21;
  const T HA6_31 = Hp7_31 - T(0.081652909);
  // JA6 = q7~ Hp7^T + J_own_6 + Jp7 - Hb7 q7~: moment for an angular acceleration, body axes [kg m^2]
  const T JA6_11 = T(0.007323165886541661) + Jp7_11;
  const T minus_JA6_12 = T(0.014746295744939998) + T(0.1805) * Hp7_13;
  const T JA6_13 = Jp7_13 - T(4.165029864e-06) + T(0.1805) * Hp7_12;
  const T minus_JA6_22 = Hb7_23 * T(0.1805);
  const T minus_JA6_23 = T(4.7970076e-07) + T(0.1805) * Hp7_33;
  const T JA6_33 = T(0.006599357548829661) - minus_Jp7_33 + T(0.361) * Hp7_32;
  // g6 = G6 + gp7: force that drives it, home axes [N]
  const T g6_1 = gp7_1 - minus_G6_1;
  const T g6_2 = g7_2 - minus_G6_2;
  const T g6_3 = gp7_3 - minus_G6_3;
  // n6 = q7~ gp7 + N6 + np7: moment that drives it, body axes [N m]
  const T n6_1 = np7_1 - minus_N6_1;
  const T minus_n6_2 = minus_N6_2 + effort_fl_thigh_7 + T(0.1805) * gp7_3;
  const T n6_3 = T(0.1805) * g7_2 - (minus_N6_3 + minus_np7_3);
  // invD6 = D6^-1: 1/D
  const T invD6 = T(1) / JA6_11;
  // kB6 = invD6 B6: B/D
  const T kB6_1 = invD6 * Hp7_11;
  const T kB6_2 = invD6 * HA6_12;
  const T kB6_3 = invD6 * HA6_13;
  // kK6 = invD6 K6: K/D
  const T minus_kK6_2 = invD6 * minus_JA6_12;
  const T kK6_3 = invD6 * JA6_13;
  // u_6 = b6 . n6 + effort_fl_hip_6: drives it [N m], [N]
  const T u_6 = n6_1 + effort_fl_hip_6;
  // v6 = invD6 u_6: u/D
  const T v6 = invD6 * u_6;
  // M6 = Mp7 - kB6 B6^T: MA less what the turn takes up [kg]
  const T M6_11 = Mp7_11 - kB6_1 * Hp7_11;
  const T minus_M6_12 = kB6_1 * HA6_12;
  const T M6_13 = Mp7_13 - kB6_1 * HA6_13;
  const T minus_M6_22 = kB6_2 * HA6_12;
  const T minus_M6_23 = kB6_2 * HA6_13;
  const T minus_M6_33 = minus_Mp7_33 + kB6_3 * HA6_13;
  // H6 = P_b6 (HA6 - kK6 B6^T): HA less what the turn takes up [kg m]
  const T H6_21 = HA6_21 + minus_kK6_2 * Hp7_11;
  const T H6_22 = minus_kK6_2 * HA6_12;
  const T H6_23 = Hb7_23 + minus_kK6_2 * HA6_13;
  const T H6_31 = HA6_31 - kK6_3 * Hp7_11;
  const T H6_32 = Hp7_32 - kK6_3 * HA6_12;
  const T H6_33 = Hp7_33 - kK6_3 * HA6_13;
  // J6 = P_b6 (JA6 - kK6 K6^T) P_b6: JA less what the turn takes up [kg m^2]
  const T minus_J6_22 = minus_JA6_22 + minus_kK6_2 * minus_JA6_12;
  const T J6_23 = minus_kK6_2 * JA6_13 - minus_JA6_23;
  const T J6_33 = JA6_33 - kK6_3 * JA6_13;
  // gt6 = g6 - v6 B6: force with the turn solved [N]
  const T gt6_1 = g6_1 - v6 * Hp7_11;
  const T gt6_2 = g6_2 - v6 * HA6_12;
  const T gt6_3 = g6_3 - v6 * HA6_13;
  // nt6 = -effort_fl_hip_6 b6 + P_b6 (n6 - v6 K6): moment with the turn solved [N m]
  const T nt6_2 = v6 * minus_JA6_12 - minus_n6_2;
  const T nt6_3 = n6_3 - v6 * JA6_13;
  // Mp6 = E6^T M6 E6: M passed on, lower body's axes [kg]
  const T minus_Mp6_12 = E6_22 * minus_M6_12 + E6_23 * M6_13;
  const T Mp6_13 = E6_22 * M6_13 - E6_23 * minus_M6_12;
  const T b6_1 = T(2) * E6_22;
  const T b6_2 = E6_23 * (minus_M6_33 - minus_M6_22) - b6_1 * minus_M6_23;
  const T b6_3 = E6_23 * b6_2;
  const T minus_Mp6_22 = minus_M6_22 + b6_3;
  const T Mp6_23 = minus_M6_23 + E6_22 * b6_2;
  const T Mp6_33 = b6_3 - minus_M6_33;
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
  const T Hb6_11 = T(0.047) * Mp6_13;
  const T Hb6_12 = T(0.047) * Mp6_23;
  const T Hb6_13 = T(0.047) * Mp6_33;
  const T Hb6_31 = Hp6_31 - T(0.047) * M6_11;
  const T Hb6_32 = Hp6_32 + T(0.047) * minus_Mp6_12;
  const T Hb6_33 = Hp6_33 - Hb6_11;

  // ---- body 4 (fr_calf) and what it carries
  // u_4 = b4 . N4 + effort_fr_calf_4: drives it [N m], [N]
  const T u_4 = effort_fr_calf_4 - minus_N4_2;
  // v4 = invD4 u_4: u/D
  const T v4 = T(136.15003737155251) * u_4;
  // gt4 = G4 - v4 B4: force with the turn solved [N]
  const T minus_gt4_1 = minus_G4_1 + v4 * T(0.029845530432320418);
  // nt4 = -effort_fr_calf_4 b4 + P_b4 (N4 - v4 K4): moment with the turn solved [N m]
  const T nt4_1 = N4_1 - v4 * T(5.215891594784536e-35);
  const T nt4_3 = N4_3 - v4 * T(0.0025010554502284503);
  // Mp4 = E4^T M4 E4: M passed on, lower body's axes [kg]
  const T b4_1 = minus_E4_13 * T(0.12127642004491364);
  const T b4_2 = minus_E4_13 * b4_1;
  const T Mp4_11 = b4_2 - T(0.12127642004491364);
  const T minus_Mp4_13 = minus_E4_11 * b4_1;
  // gp4 = E4^T gt4: force passed on, lower body's axes [N]
  const T gp4_1 = minus_E4_11 * minus_gt4_1 + minus_E4_13 * G4_3;
  const T gp4_3 = minus_E4_13 * minus_gt4_1 - minus_E4_11 * G4_3;
  // Hp4 = E4^T H4 E4: H passed on, lower body's axes [kg m]
  const T b4_3 = minus_E4_13 * T(2.11946194554078e-34) + minus_E4_11 * T(0.010162963999763762);
  const T b4_4 = minus_E4_13 * b4_3;
  const T Hp4_11 = b4_4 - T(2.11946194554078e-34);
  const T Hp4_12 = minus_E4_11 * T(0.029845530432320418);
  const T b4_5 = minus_E4_11 * b4_3;
  const T Hp4_13 = T(0.010162963999763762) - b4_5;
  const T Hp4_32 = minus_E4_13 * T(0.029845530432320418);
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_6 = T(2) * minus_E4_11 * T(0.0002865260721362275) - minus_E4_13 * T(0.00810225275201088);
  const T b4_7 = minus_E4_13 * b4_6;
  const T Jp4_11 = T(0.007250596368830678) + b4_7;
  const T Jp4_13 = T(0.0002865260721362275) - minus_E4_11 * b4_6;
  const T minus_Jp4_33 = T(0.0008516563831802031) + b4_7;
  // np4 = E4^T nt4: moment passed on, lower body's axes [N m]
  const T np4_1 = minus_E4_13 * nt4_3 - minus_E4_11 * nt4_1;
  const T minus_np4_3 = minus_E4_13 * nt4_1 + minus_E4_11 * nt4_3;
  // Hb4 = q4~ Mp4 + Hp4: H of the joint at the lower body's origin, its axes
  const T minus_Hb4_21 = T(0.2) * Mp4_11;
  const T Hb4_23 = T(0.2) * minus_Mp4_13;

  // ---- body 3 (fr_thigh) and what it carries
  // HA3 = h_own_3~ + Hb4: moment for an acceleration of the origin, body axes [kg m]
  const T HA3_12 = Hp4_12 + T(0.072881238);
  const T minus_HA3_21 = T(0.072881238) + minus_Hb4_21;
  const T HA3_23 = T(0.0032790809999999997) + Hb4_23;
  const T HA3_32 = Hp4_32 - T(0.0032790809999999997);
  // JA3 = q4~ Hp4^T + J_own_3 + Jp4 - Hb4 q4~: moment for an angular acceleration, body axes [kg m^2]
  const T JA3_11 = T(0.013947080124391002) + Jp4_11 + T(0.4) * Hp4_12;
  const T minus_JA3_12 = T(0.00020639994631299998) + T(0.2) * Hp4_11;
  const T JA3_13 = T(0.000254264832594) + Jp4_13 + T(0.2) * Hp4_32;
  const T JA3_22 = T(0.014946370894785) + minus_Hb4_21 * T(0.2);
  const T JA3_23 = T(0.2) * b4_5 - T(0.005511856743573999);
  // g3 = G3 + gp4: force that drives it, home axes [N]
  const T g3_1 = gp4_1 - minus_G3_1;
  const T g3_2 = G4_2 + G3_2;
  const T g3_3 = gp4_3 - minus_G3_3;
  // n3 = q4~ gp4 + N3 + np4: moment that drives it, body axes [N m]
  const T n3_1 = np4_1 - minus_N3_1 + T(0.2) * G4_2;
  const T minus_n3_2 = minus_N3_2 + effort_fr_calf_4 + T(0.2) * gp4_1;
  const T minus_n3_3 = minus_N3_3 + minus_np4_3;
  // invD3 = D3^-1: 1/D
  const T invD3 = T(1) / JA3_22;
  // kB3 = invD3 B3: B/D
  const T minus_kB3_1 = invD3 * minus_HA3_21;
  const T kB3_3 = invD3 * HA3_23;
  // kK3 = invD3 K3: K/D
  const T minus_kK3_1 = invD3 * minus_JA3_12;
  const T kK3_3 = invD3 * JA3_23;
  // u_3 = b3 . n3 + effort_fr_thigh_3: drives it [N m], [N]
  const T u_3 = effort_fr_thigh_3 - minus_n3_2;
  // v3 = invD3 u_3: u/D
  const T v3 = invD3 * u_3;
  // M3 = Mp4 - kB3 B3^T: MA less what the turn takes up [kg]
  const T M3_11 = Mp4_11 - minus_kB3_1 * minus_HA3_21;
  const T M3_13 = minus_kB3_1 * HA3_23 - minus_Mp4_13;
  const T minus_M3_33 = b4_2 + kB3_3 * HA3_23;
  // H3 = P_b3 (HA3 - kK3 B3^T): HA less what the turn takes up [kg m]
  const T H3_11 = Hp4_11 - minus_kK3_1 * minus_HA3_21;
  const T H3_13 = Hp4_13 + minus_kK3_1 * HA3_23;
  const T H3_31 = kK3_3 * minus_HA3_21 - b4_5;
  const T minus_H3_33 = b4_4 + kK3_3 * HA3_23;
  // J3 = P_b3 (JA3 - kK3 K3^T) P_b3: JA less what the turn takes up [kg m^2]
  const T J3_11 = JA3_11 - minus_kK3_1 * minus_JA3_12;
  const T J3_13 = JA3_13 + minus_kK3_1 * JA3_23;
  const T minus_J3_33 = minus_Jp4_33 + kK3_3 * JA3_23;
  // gt3 = g3 - v3 B3: force with the turn solved [N]
  const T gt3_1 = g3_1 + v3 * minus_HA3_21;
  const T gt3_3 = g3_3 - v3 * HA3_23;
  // nt3 = -effort_fr_thigh_3 b3 + P_b3 (n3 - v3 K3): moment with the turn solved [N m]
  const T nt3_1 = n3_1 + v3 * minus_JA3_12;
  const T minus_nt3_3 = minus_n3_3 + v3 * JA3_23;
  // Mp3 = E3^T M3 E3: M passed on, lower body's axes [kg]
  const T b3_1 = T(2) * E3_11;
  const T b3_2 = b3_1 * M3_13 - minus_E3_13 * (minus_M3_33 + M3_11);
  const T b3_3 = minus_E3_13 * b3_2;
  const T Mp3_11 = M3_11 + b3_3;
  const T Mp3_13 = E3_11 * b3_2 - M3_13;
  const T minus_Mp3_33 = minus_M3_33 + b3_3;
  // gp3 = E3^T gt3: force passed on, lower body's axes [N]
  const T gp3_1 = E3_11 * gt3_1 + minus_E3_13 * gt3_3;
  const T gp3_3 = E3_11 * gt3_3 - minus_E3_13 * gt3_1;
  // Hp3 = E3^T H3 E3: H passed on, lower body's axes [kg m]
  const T b3_4 = E3_11 * (H3_31 + H3_13) - minus_E3_13 * (minus_H3_33 + H3_11);
  const T b3_5 = minus_E3_13 * b3_4;
  const T Hp3_11 = H3_11 + b3_5;
  const T Hp3_12 = minus_E3_13 * HA3_32 + E3_11 * HA3_12;
  const T b3_6 = E3_11 * b3_4;
  const T Hp3_13 = b3_6 - H3_31;
  const T Hp3_31 = b3_6 - H3_13;
  const T Hp3_32 = E3_11 * HA3_32 - minus_E3_13 * HA3_12;
  const T minus_Hp3_33 = minus_H3_33 + b3_5;
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_7 = b3_1 * J3_13 - minus_E3_13 * (minus_J3_33 + J3_11);
  const T b3_8 = minus_E3_13 * b3_7;
  const T Jp3_11 = J3_11 + b3_8;
  const T Jp3_13 = E3_11 * b3_7 - J3_13;
  const T minus_Jp3_33 = minus_J3_33 + b3_8;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T np3_1 = E3_11 * nt3_1 - minus_E3_13 * minus_nt3_3;
  const T minus_np3_3 = minus_E3_13 * nt3_1 + E3_11 * minus_nt3_3;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T minus_Hb3_21 = T(0.1805) * Mp3_13;
  const T Hb3_23 = T(0.1805) * minus_Mp3_33;

  // ---- body 2 (fr_hip) and what it carries
  // HA2 = h_own_2~ + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA2_12 = Hp3_12 - T(2.1575999999999998e-05);
  const T HA2_13 = Hp3_13 - T(0.081652909);
  const T HA2_21 = T(2.1575999999999998e-05) - minus_Hb3_21;
  const T HA2_31 = Hp3_31 + T(0.081652909);
  // JA2 = q3~ Hp3^T + J_own_2 + Jp3 - Hb3 q3~: moment for an angular acceleration, body axes [kg m^2]
  const T JA2_11 = T(0.007323165886541661) + Jp3_11;
  const T JA2_12 = T(0.014746295744939998) - T(0.1805) * Hp3_13;
  const T JA2_13 = Jp3_13 - T(4.165029864e-06) + T(0.1805) * Hp3_12;
  const T minus_JA2_22 = Hb3_23 * T(0.1805);
  const T JA2_23 = T(4.7970076e-07) + T(0.1805) * minus_Hp3_33;
  const T JA2_33 = T(0.006599357548829661) - minus_Jp3_33 + T(0.361) * Hp3_32;
  // g2 = G2 + gp3: force that drives it, home axes [N]
  const T g2_1 = gp3_1 - minus_G2_1;
  const T g2_2 = g3_2 - minus_G2_2;
  const T g2_3 = gp3_3 + G2_3;
  // n2 = q3~ gp3 + N2 + np3: moment that drives it, body axes [N m]
  const T n2_1 = np3_1 - minus_N2_1;
  const T minus_n2_2 = minus_N2_2 + effort_fr_thigh_3 + T(0.1805) * gp3_3;
  const T n2_3 = T(0.1805) * g3_2 - (minus_N2_3 + minus_np3_3);
  // invD2 = D2^-1: 1/D
  const T invD2 = T(1) / JA2_11;
  // kB2 = invD2 B2: B/D
  const T kB2_1 = invD2 * Hp3_11;
  const T kB2_2 = invD2 * HA2_12;
  const T kB2_3 = invD2 * HA2_13;
  // kK2 = invD2 K2: K/D
  const T kK2_2 = invD2 * JA2_12;
  const T kK2_3 = invD2 * JA2_13;
  // u_2 = b2 . n2 + effort_fr_hip_2: drives it [N m], [N]
  const T u_2 = n2_1 + effort_fr_hip_2;
  // v2 = invD2 u_2: u/D
  const T v2 = invD2 * u_2;
  // M2 = Mp3 - kB2 B2^T: MA less what the turn takes up [kg]
  const T M2_11 = Mp3_11 - kB2_1 * Hp3_11;
  const T minus_M2_12 = kB2_1 * HA2_12;
  const T M2_13 = Mp3_13 - kB2_1 * HA2_13;
  const T minus_M2_22 = kB2_2 * HA2_12;
  const T minus_M2_23 = kB2_2 * HA2_13;
  const T minus_M2_33 = minus_Mp3_33 + kB2_3 * HA2_13;
  // H2 = P_b2 (HA2 - kK2 B2^T): HA less what the turn takes up [kg m]
  const T H2_21 = HA2_21 - kK2_2 * Hp3_11;
  const T minus_H2_22 = kK2_2 * HA2_12;
  const T H2_23 = Hb3_23 - kK2_2 * HA2_13;
  const T H2_31 = HA2_31 - kK2_3 * Hp3_11;
  const T H2_32 = Hp3_32 - kK2_3 * HA2_12;
  const T minus_H2_33 = minus_Hp3_33 + kK2_3 * HA2_13;
  // J2 = P_b2 (JA2 - kK2 K2^T) P_b2: JA less what the turn takes up [kg m^2]
  const T minus_J2_22 = minus_JA2_22 + kK2_2 * JA2_12;
  const T J2_23 = JA2_23 - kK2_2 * JA2_13;
  const T J2_33 = JA2_33 - kK2_3 * JA2_13;
  // gt2 = g2 - v2 B2: force with the turn solved [N]
  const T gt2_1 = g2_1 - v2 * Hp3_11;
  const T gt2_2 = g2_2 - v2 * HA2_12;
  const T gt2_3 = g2_3 - v2 * HA2_13;
  // nt2 = -effort_fr_hip_2 b2 + P_b2 (n2 - v2 K2): moment with the turn solved [N m]
  const T minus_nt2_2 = minus_n2_2 + v2 * JA2_12;
  const T nt2_3 = n2_3 - v2 * JA2_13;
  // Mp2 = E2^T M2 E2: M passed on, lower body's axes [kg]
  const T minus_Mp2_12 = E2_22 * minus_M2_12 + E2_23 * M2_13;
  const T Mp2_13 = E2_22 * M2_13 - E2_23 * minus_M2_12;
  const T b2_1 = T(2) * E2_22;
  const T b2_2 = E2_23 * (minus_M2_33 - minus_M2_22) - b2_1 * minus_M2_23;
  const T b2_3 = E2_23 * b2_2;
  const T minus_Mp2_22 = minus_M2_22 + b2_3;
  const T Mp2_23 = minus_M2_23 + E2_22 * b2_2;
  const T Mp2_33 = b2_3 - minus_M2_33;
  // gp2 = E2^T gt2: force passed on, lower body's axes [N]
  const T gp2_2 = E2_22 * gt2_2 - E2_23 * gt2_3;
  const T gp2_3 = E2_23 * gt2_2 + E2_22 * gt2_3;
  // Hp2 = E2^T H2 E2: H passed on, lower body's axes [kg m]
  const T Hp2_21 = E2_22 * H2_21 - E2_23 * H2_31;
  const T b2_4 = E2_23 * (minus_H2_33 - minus_H2_22) + E2_22 * (H2_23 + H2_32);
  const T b2_5 = E2_23 * b2_4;
  const T minus_Hp2_22 = minus_H2_22 + b2_5;
  const T b2_6 = E2_22 * b2_4;
  const T Hp2_23 = b2_6 - H2_32;
  const T Hp2_31 = E2_23 * H2_21 + E2_22 * H2_31;
  const T Hp2_32 = b2_6 - H2_23;
  const T Hp2_33 = b2_5 - minus_H2_33;
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T b2_7 = b2_1 * J2_23 - E2_23 * (minus_J2_22 + J2_33);
  const T b2_8 = E2_23 * b2_7;
  const T minus_Jp2_22 = minus_J2_22 + b2_8;
  const T Jp2_23 = E2_22 * b2_7 - J2_23;
  const T Jp2_33 = J2_33 + b2_8;
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T minus_np2_2 = E2_22 * minus_nt2_2 + E2_23 * nt2_3;
  const T np2_3 = E2_22 * nt2_3 - E2_23 * minus_nt2_2;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T minus_Hb2_11 = T(0.047) * Mp2_13;
  const T minus_Hb2_12 = T(0.047) * Mp2_23;
  const T minus_Hb2_13 = T(0.047) * Mp2_33;
  const T Hb2_31 = Hp2_31 + T(0.047) * M2_11;
  const T Hb2_32 = Hp2_32 - T(0.047) * minus_Mp2_12;
  const T Hb2_33 = minus_Hb2_11 + Hp2_33;

  // ---- body 1 (trunk) and what it carries
  // MA1 = m_all_1 one + Mp14 + Mp10 + Mp6 + Mp2: force for an acceleration of the origin, home axes [kg]
  const T MA1_11 = c.m_all_1 + M14_11 + M10_11 + M6_11 + M2_11;
  const T minus_MA1_12 = minus_Mp14_12 + minus_Mp10_12 + minus_Mp6_12 + minus_Mp2_12;
  const T MA1_13 = Mp14_13 + Mp10_13 + Mp6_13 + Mp2_13;
  const T MA1_22 = c.m_all_1 - minus_Mp14_22 - minus_Mp10_22 - minus_Mp6_22 - minus_Mp2_22;
  const T MA1_23 = Mp14_23 + Mp10_23 + Mp6_23 + Mp2_23;
  const T MA1_33 = c.m_all_1 + Mp14_33 + Mp10_33 + Mp6_33 + Mp2_33;
  // HA1 = h_all_1~ + Hb2 + Hb6 + Hb10 + Hb14: moment for an acceleration of the origin, body axes [kg m]
  const T HA1_11 = Hb6_11 - minus_Hb2_11 - minus_Hb10_11 + Hb14_11;
  const T HA1_12 = c.c1_2 - minus_Hb2_12 + Hb6_12 - minus_Hb10_12 + Hb14_12;
  const T HA1_13 = c.h_all_1_2 - minus_Hb2_13 + Hb6_13 - minus_Hb10_13 + Hb14_13;
  const T HA1_21 = Hp2_21 - c.c1_2 + Hp6_21 + Hp10_21 + Hp14_21;
  const T HA1_22 = Hp6_22 - minus_Hp2_22 - minus_Hp10_22 - minus_Hp14_22;
  const T HA1_23 = Hp2_23 + Hp6_23 + Hp10_23 + Hp14_23;
  const T HA1_31 = Hb2_31 - c.h_all_1_2 + Hb6_31 + Hb10_31 + Hb14_31;
  const T HA1_32 = Hb2_32 + Hb6_32 + Hb10_32 + Hb14_32;
  const T HA1_33 = Hb2_33 + Hb6_33 + Hb10_33 + Hb14_33;
  // JA1 = q2~ Hp2^T + q6~ Hp6^T + q10~ Hp10^T + q14~ Hp14^T + J_all_1 + Jp14 + Jp10 + Jp6 + Jp2 - Hb2 q2~ - Hb6 q6~ -
  //   Hb10 q10~ - Hb14 q14~: moment for an angular acceleration, body axes [kg m^2]
  const T JA1_11 = c.J_all_1_11 + minus_Hb2_13 * T(0.047) + Hb6_13 * T(0.047) + minus_Hb10_13 * T(0.047) + Hb14_13 *
      T(0.047);
  const T JA1_12 = T(0.047) * Hp6_23 - T(3.66e-05) - T(0.047) * Hp2_23 - T(0.047) * Hp10_23 + T(0.047) * Hp14_23;
  const T JA1_13 = T(0.047) * Hp6_33 - T(6.11e-05) - T(0.047) * Hp2_33 - T(0.047) * Hp10_33 + T(0.047) * Hp14_33 -
      minus_Hb2_11 * T(0.047) - Hb6_11 * T(0.047) - minus_Hb10_11 * T(0.047) - Hb14_11 * T(0.047);
  const T JA1_22 = c.J_all_1_22 - minus_Jp14_22 - minus_Jp10_22 - minus_Jp6_22 - minus_Jp2_22;
  const T JA1_23 = c.J_all_1_23 + Jp14_23 + Jp10_23 + Jp6_23 + Jp2_23 + T(0.047) * Hp2_21 - T(0.047) * Hp6_21 +
      T(0.047) * Hp10_21 - T(0.047) * Hp14_21;
  const T JA1_33 = c.J_all_1_33 + Jp14_33 + Jp10_33 + Jp6_33 + Jp2_33 + T(0.047) * Hp2_31 - T(0.047) * Hp6_31 +
      T(0.047) * Hp10_31 - T(0.047) * Hp14_31 + Hb2_31 * T(0.047) - Hb6_31 * T(0.047) + Hb10_31 * T(0.047) - Hb14_31 *
      T(0.047);
  // g1 = G1 + gp14 + gp10 + gp6 + gp2: force that drives it, home axes [N]
  const T g1_1 = gt14_1 - minus_G1_1 + gt10_1 + gt6_1 + gt2_1;
  const T g1_2 = gp14_2 + G1_2 + gp10_2 + gp6_2 + gp2_2;
  const T g1_3 = gp14_3 - minus_G1_3 + gp10_3 + gp6_3 + gp2_3;
  // n1 = q2~ gp2 + q6~ gp6 + q10~ gp10 + q14~ gp14 + N1 + np14 + np10 + np6 + np2: moment that drives it, body axes
  //   [N m]
  const T n1_1 = T(0.047) * gp6_3 - (minus_N1_1 + effort_rl_hip_14 + effort_rr_hip_10 + effort_fl_hip_6 +
      effort_fr_hip_2) - T(0.047) * gp2_3 - T(0.047) * gp10_3 + T(0.047) * gp14_3;
  const T n1_2 = np14_2 - minus_N1_2 + np10_2 + np6_2 - minus_np2_2;
  const T n1_3 = np14_3 - minus_N1_3 + np10_3 + np6_3 + np2_3 + T(0.047) * gt2_1 - T(0.047) * gt6_1 + T(0.047) *
      gt10_1 - T(0.047) * gt14_1;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T LD1_21 = LD1_11 * JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - LD1_21 * JA1_12);
  const T LD1_31 = LD1_11 * JA1_13;
  const T b1_1 = JA1_23 - LD1_21 * JA1_13;
  const T LD1_32 = LD1_22 * b1_1;
  const T LD1_33 = T(1) / (JA1_33 - LD1_31 * JA1_13 - LD1_32 * b1_1);
  // Y1 = L(LD1)^-1 HA1: L^-1 HA
  const T Y1_21 = HA1_21 - LD1_21 * HA1_11;
  const T Y1_22 = HA1_22 - LD1_21 * HA1_12;
  const T Y1_23 = HA1_23 - LD1_21 * HA1_13;
  const T Y1_31 = HA1_31 - LD1_31 * HA1_11 - LD1_32 * Y1_21;
  const T Y1_32 = HA1_32 - LD1_31 * HA1_12 - LD1_32 * Y1_22;
  const T Y1_33 = HA1_33 - LD1_31 * HA1_13 - LD1_32 * Y1_23;
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
  const T w_1_3 = LD1_33 * (n1_3 - LD1_31 * n1_1 - LD1_32 * b1_2);
  // M1 = MA1 - Y1^T W1: MA less what the ball takes up [kg]
  const T M1_11 = MA1_11 - HA1_11 * W1_11 - Y1_21 * W1_21 - Y1_31 * W1_31;
  const T minus_M1_12 = minus_MA1_12 + HA1_11 * W1_12 + Y1_21 * W1_22 + Y1_31 * W1_32;
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
  const T minus_LDs1_21 = LDs1_11 * minus_M1_12;
  const T LDs1_22 = T(1) / (M1_22 - minus_LDs1_21 * minus_M1_12);
  const T LDs1_31 = LDs1_11 * M1_13;
  const T b1_3 = M1_23 + minus_LDs1_21 * M1_13;
  const T LDs1_32 = LDs1_22 * b1_3;
  const T LDs1_33 = T(1) / (M1_33 - LDs1_31 * M1_13 - LDs1_32 * b1_3);
  // ws1 = D(LDs1)^-1 L(LDs1)^-1 gb1: D^-1 L^-1 g
  const T ws1_1 = LDs1_11 * gb1_1;
  const T b1_4 = gb1_2 + minus_LDs1_21 * gb1_1;
  const T ws1_2 = LDs1_22 * b1_4;
  const T ws1_3 = LDs1_33 * (gb1_3 - LDs1_31 * gb1_1 - LDs1_32 * b1_4);

  // ---- body 1 (trunk), solved
  // Pddot1 = L(LDs1)^-T ws1
  const T z1_1 = ws1_2 - LDs1_32 * ws1_3;
  const T Pddot1_1 = ws1_1 + minus_LDs1_21 * z1_1 - LDs1_31 * ws1_3;
  // omegadot1 = L(LD1)^-T (-W1 Pddot1 + w_1)
  const T z1_2 = w_1_3 - W1_31 * Pddot1_1 - W1_32 * z1_1 - W1_33 * ws1_3;
  const T z1_3 = w_1_2 - W1_21 * Pddot1_1 - W1_22 * z1_1 - W1_23 * ws1_3 - LD1_32 * z1_2;
  const T omegadot1_1 = w_1_1 - W1_11 * Pddot1_1 - W1_12 * z1_1 - W1_13 * ws1_3 - LD1_21 * z1_3 - LD1_31 * z1_2;
  ydot[0] = omegadot1_1;
  ydot[1] = z1_3;
  ydot[2] = z1_2;
  // sddot1 = g + R1^T Pddot1: relative acceleration, axes of the lower body [m/s^2]
  const T sddot1_1 = R1_11 * Pddot1_1 + R1_21 * z1_1 + R1_31 * ws1_3;
  const T sddot1_2 = R1_12 * Pddot1_1 + R1_22 * z1_1 + R1_32 * ws1_3;
  const T sddot1_3 = R1_13 * Pddot1_1 - T(9.81) + R1_23 * z1_1 + R1_33 * ws1_3;
  ydot[15] = sddot1_1;
  ydot[16] = sddot1_2;
  ydot[17] = sddot1_3;

  // ---- body 2 (fr_hip), solved
  // beta2 = -E2 q2~ omegadot1 + E2 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z2_1 = T(0.047) * z1_2;
  const T beta2_1 = Pddot1_1 + z2_1;
  const T z2_2 = T(0.047) * omegadot1_1;
  const T beta2_2 = E2_22 * z1_1 + E2_23 * ws1_3 - E2_23 * z2_2;
  const T beta2_3 = E2_22 * ws1_3 - E2_23 * z1_1 - E2_22 * z2_2;
  // alphaL2 = E2 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL2_2 = E2_22 * z1_3 + E2_23 * z1_2;
  const T alphaL2_3 = E2_22 * z1_2 - E2_23 * z1_3;
  // phi2 = -kB2 . beta2 + v2 - (P_b2 kK2) . alphaL2
  const T phi2 = v2 - kB2_1 * beta2_1 - kB2_2 * beta2_2 - kB2_3 * beta2_3 - kK2_2 * alphaL2_2 - kK2_3 * alphaL2_3;
  // thetaddot2 = -b2 . alphaL2 + phi2
  const T thetaddot2 = phi2 - omegadot1_1;
  ydot[3] = thetaddot2;

  // ---- body 3 (fr_thigh), solved
  // beta3 = -E3 q3~ alpha2 + E3 beta2: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z3_1 = T(0.1805) * alphaL2_2;
  const T beta3_1 = E3_11 * beta2_1 - minus_E3_13 * beta2_3 + minus_E3_13 * z3_1;
  const T beta3_3 = minus_E3_13 * beta2_1 + E3_11 * beta2_3 - E3_11 * z3_1;
  // alphaL3 = E3 alpha2: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL3_1 = E3_11 * phi2 - minus_E3_13 * alphaL2_3;
  const T alphaL3_3 = minus_E3_13 * phi2 + E3_11 * alphaL2_3;
  // phi3 = -kB3 . beta3 + v3 - (P_b3 kK3) . alphaL3
  const T phi3 = v3 + minus_kB3_1 * beta3_1 - kB3_3 * beta3_3 - kK3_3 * alphaL3_3 + minus_kK3_1 * alphaL3_1;
  // thetaddot3 = -b3 . alphaL3 + phi3
  const T thetaddot3 = phi3 - alphaL2_2;
  ydot[4] = thetaddot3;

  // ---- body 4 (fr_calf), solved
  // beta4 = -E4 q4~ alpha3 + E4 beta3: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta4_1 = T(0.2) * phi3 * minus_E4_11 - (minus_E4_11 * beta3_1 + minus_E4_13 * beta3_3);
  // alphaL4 = E4 alpha3: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T minus_alphaL4_1 = minus_E4_11 * alphaL3_1 + minus_E4_13 * alphaL3_3;
  const T alphaL4_3 = minus_E4_13 * alphaL3_1 - minus_E4_11 * alphaL3_3;
  // phi4 = -kB4 . beta4 + v4 - (P_b4 kK4) . alphaL4
  const T phi4 = v4 - T(4.063470083734233) * beta4_1 - T(0.34051879301692867) * alphaL4_3 + T(7.101438355558813e-33) *
      minus_alphaL4_1;
  // thetaddot4 = -b4 . alphaL4 + phi4
  const T thetaddot4 = phi4 - phi3;
  ydot[5] = thetaddot4;

  // ---- body 6 (fl_hip), solved
  // beta6 = -E6 q6~ omegadot1 + E6 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta6_1 = Pddot1_1 - z2_1;
  const T beta6_2 = E6_22 * z1_1 + E6_23 * ws1_3 + E6_23 * z2_2;
  const T beta6_3 = E6_22 * ws1_3 - E6_23 * z1_1 + E6_22 * z2_2;
  // alphaL6 = E6 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL6_2 = E6_22 * z1_3 + E6_23 * z1_2;
  const T alphaL6_3 = E6_22 * z1_2 - E6_23 * z1_3;
  // phi6 = -kB6 . beta6 + v6 - (P_b6 kK6) . alphaL6
  const T phi6 = v6 - kB6_1 * beta6_1 - kB6_2 * beta6_2 - kB6_3 * beta6_3 - kK6_3 * alphaL6_3 + minus_kK6_2 *
      alphaL6_2;
  // thetaddot6 = -b6 . alphaL6 + phi6
  const T thetaddot6 = phi6 - omegadot1_1;
  ydot[6] = thetaddot6;

  // ---- body 7 (fl_thigh), solved
  // beta7 = -E7 q7~ alpha6 + E7 beta6: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z7_1 = T(0.1805) * alphaL6_2;
  const T beta7_1 = E7_11 * beta6_1 - minus_E7_13 * beta6_3 + minus_E7_13 * z7_1;
  const T beta7_3 = minus_E7_13 * beta6_1 + E7_11 * beta6_3 - E7_11 * z7_1;
  // alphaL7 = E7 alpha6: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL7_1 = E7_11 * phi6 - minus_E7_13 * alphaL6_3;
  const T alphaL7_3 = minus_E7_13 * phi6 + E7_11 * alphaL6_3;
  // phi7 = -kB7 . beta7 + v7 - (P_b7 kK7) . alphaL7
  const T phi7 = v7 + minus_kB7_1 * beta7_1 - kB7_3 * beta7_3 - kK7_1 * alphaL7_1 - kK7_3 * alphaL7_3;
  // thetaddot7 = -b7 . alphaL7 + phi7
  const T thetaddot7 = phi7 - alphaL6_2;
  ydot[7] = thetaddot7;

  // ---- body 8 (fl_calf), solved
  // beta8 = -E8 q8~ alpha7 + E8 beta7: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta8_1 = T(0.2) * phi7 * minus_E8_11 - (minus_E8_11 * beta7_1 + minus_E8_13 * beta7_3);
  // alphaL8 = E8 alpha7: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T minus_alphaL8_1 = minus_E8_11 * alphaL7_1 + minus_E8_13 * alphaL7_3;
  const T alphaL8_3 = minus_E8_13 * alphaL7_1 - minus_E8_11 * alphaL7_3;
  // phi8 = -kB8 . beta8 + v8 - (P_b8 kK8) . alphaL8
  const T phi8 = v8 - T(4.063470083734233) * beta8_1 - T(7.101438355558813e-33) * minus_alphaL8_1 +
      T(0.34051879301692867) * alphaL8_3;
  // thetaddot8 = -b8 . alphaL8 + phi8
  const T thetaddot8 = phi8 - phi7;
  ydot[8] = thetaddot8;

  // ---- body 10 (rr_hip), solved
  // beta10 = -E10 q10~ omegadot1 + E10 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta10_2 = E10_22 * z1_1 + E10_23 * ws1_3 - E10_23 * z2_2;
  const T beta10_3 = E10_22 * ws1_3 - E10_23 * z1_1 - E10_22 * z2_2;
  // alphaL10 = E10 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL10_2 = E10_22 * z1_3 + E10_23 * z1_2;
  const T alphaL10_3 = E10_22 * z1_2 - E10_23 * z1_3;
  // phi10 = -kB10 . beta10 + v10 - (P_b10 kK10) . alphaL10
  const T phi10 = v10 - kB10_1 * beta2_1 - kB10_2 * beta10_2 - kB10_3 * beta10_3 - kK10_2 * alphaL10_2 - kK10_3 *
      alphaL10_3;
  // thetaddot10 = -b10 . alphaL10 + phi10
  const T thetaddot10 = phi10 - omegadot1_1;
  ydot[9] = thetaddot10;

  // ---- body 11 (rr_thigh), solved
  // beta11 = -E11 q11~ alpha10 + E11 beta10: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z11_1 = T(0.1805) * alphaL10_2;
  const T beta11_1 = E11_11 * beta2_1 - minus_E11_13 * beta10_3 - minus_E11_13 * z11_1;
  const T beta11_3 = minus_E11_13 * beta2_1 + E11_11 * beta10_3 + E11_11 * z11_1;
  // alphaL11 = E11 alpha10: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL11_1 = E11_11 * phi10 - minus_E11_13 * alphaL10_3;
  const T alphaL11_3 = minus_E11_13 * phi10 + E11_11 * alphaL10_3;
  // phi11 = -kB11 . beta11 + v11 - (P_b11 kK11) . alphaL11
  const T phi11 = v11 + minus_kB11_1 * beta11_1 - kB11_3 * beta11_3 - kK11_3 * alphaL11_3 + minus_kK11_1 * alphaL11_1;
  // thetaddot11 = -b11 . alphaL11 + phi11
  const T thetaddot11 = phi11 - alphaL10_2;
  ydot[10] = thetaddot11;

  // ---- body 12 (rr_calf), solved
  // beta12 = -E12 q12~ alpha11 + E12 beta11: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta12_1 = T(0.2) * phi11 * minus_E12_11 - (minus_E12_11 * beta11_1 + minus_E12_13 * beta11_3);
  // alphaL12 = E12 alpha11: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T minus_alphaL12_1 = minus_E12_11 * alphaL11_1 + minus_E12_13 * alphaL11_3;
  const T alphaL12_3 = minus_E12_13 * alphaL11_1 - minus_E12_11 * alphaL11_3;
  // phi12 = -kB12 . beta12 + v12 - (P_b12 kK12) . alphaL12
  const T phi12 = v12 - T(4.063470083734233) * beta12_1 - T(0.34051879301692867) * alphaL12_3 +
      T(7.101438355558813e-33) * minus_alphaL12_1;
  // thetaddot12 = -b12 . alphaL12 + phi12
  const T thetaddot12 = phi12 - phi11;
  ydot[11] = thetaddot12;

  // ---- body 14 (rl_hip), solved
  // beta14 = -E14 q14~ omegadot1 + E14 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta14_2 = E14_22 * z1_1 + E14_23 * ws1_3 + E14_23 * z2_2;
  const T beta14_3 = E14_22 * ws1_3 - E14_23 * z1_1 + E14_22 * z2_2;
  // alphaL14 = E14 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL14_2 = E14_22 * z1_3 + E14_23 * z1_2;
  const T alphaL14_3 = E14_22 * z1_2 - E14_23 * z1_3;
  // phi14 = -kB14 . beta14 + v14 - (P_b14 kK14) . alphaL14
  const T phi14 = v14 - kB14_1 * beta6_1 - kB14_2 * beta14_2 - kB14_3 * beta14_3 - kK14_2 * alphaL14_2 - kK14_3 *
      alphaL14_3;
  // thetaddot14 = -b14 . alphaL14 + phi14
  const T thetaddot14 = phi14 - omegadot1_1;
  ydot[12] = thetaddot14;

  // ---- body 15 (rl_thigh), solved
  // beta15 = -E15 q15~ alpha14 + E15 beta14: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z15_1 = T(0.1805) * alphaL14_2;
  const T beta15_1 = E15_11 * beta6_1 - minus_E15_13 * beta14_3 - minus_E15_13 * z15_1;
  const T beta15_3 = minus_E15_13 * beta6_1 + E15_11 * beta14_3 + E15_11 * z15_1;
  // alphaL15 = E15 alpha14: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL15_1 = E15_11 * phi14 - minus_E15_13 * alphaL14_3;
  const T alphaL15_3 = minus_E15_13 * phi14 + E15_11 * alphaL14_3;
  // phi15 = -kB15 . beta15 + v15 - (P_b15 kK15) . alphaL15
  const T phi15 = v15 + minus_kB15_1 * beta15_1 - kB15_3 * beta15_3 - kK15_1 * alphaL15_1 - kK15_3 * alphaL15_3;
  // thetaddot15 = -b15 . alphaL15 + phi15
  const T thetaddot15 = phi15 - alphaL14_2;
  ydot[13] = thetaddot15;

  // ---- body 16 (rl_calf), solved
  // beta16 = -E16 q16~ alpha15 + E16 beta15: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta16_1 = T(0.2) * phi15 * minus_E16_11 - (minus_E16_11 * beta15_1 + minus_E16_13 * beta15_3);
  // alphaL16 = E16 alpha15: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T minus_alphaL16_1 = minus_E16_11 * alphaL15_1 + minus_E16_13 * alphaL15_3;
  const T alphaL16_3 = minus_E16_13 * alphaL15_1 - minus_E16_11 * alphaL15_3;
  // phi16 = -kB16 . beta16 + v16 - (P_b16 kK16) . alphaL16
  const T phi16 = v16 - T(4.063470083734233) * beta16_1 - T(7.101438355558813e-33) * minus_alphaL16_1 +
      T(0.34051879301692867) * alphaL16_3;
  // thetaddot16 = -b16 . alphaL16 + phi16
  const T thetaddot16 = phi16 - phi15;
  ydot[14] = thetaddot16;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 860 add, 946 multiply, 24 sine or cosine
template <class T>
void residual(const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r) noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[15], sddot1_2 = ydot[16], sddot1_3 = ydot[17];
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
  // G1 = m_all_1 Pddot1 + U1 h_all_1: inertia less applied force, body axes [N]
  const T G1_1 = c.m_all_1 * Pddot1_1 + U1_12 * c.h_all_1_2 - U1_13 * c.c1_2;
  const T G1_2 = c.m_all_1 * Pddot1_2 - (minus_U1_22 * c.h_all_1_2 + U1_23 * c.c1_2);
  const T G1_3 = c.m_all_1 * Pddot1_3 + U1_32 * c.h_all_1_2 + minus_U1_33 * c.c1_2;
  // N1 = h_all_1~ Pddot1 + axial(U1 (tr(J_all_1)/2 - J_all_1)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N1_1 = c.c1_2 * Pddot1_2 + c.h_all_1_2 * Pddot1_3 + c.c1_8 * U1_32 - c.c1_9 * U1_23 - c.J_all_1_23 *
      (minus_U1_22 - minus_U1_33) + T(3.66e-05) * U1_31 - T(6.11e-05) * U1_21;
  const T N1_2 = c.c1_9 * U1_13 - c.c1_7 * U1_31 + T(6.11e-05) * (minus_U1_33 - minus_U1_11) - c.J_all_1_23 * U1_12 -
      T(3.66e-05) * U1_32 - c.c1_2 * Pddot1_1;
  const T N1_3 = c.c1_7 * U1_21 - c.c1_8 * U1_12 + T(3.66e-05) * (minus_U1_11 - minus_U1_22) + T(6.11e-05) * U1_23 +
      c.J_all_1_23 * U1_13 - c.h_all_1_2 * Pddot1_1;

  // ---- body 2 (fr_hip) on body 1
  const T theta2 = x[4];
  const T thetadot2 = y[3];
  const T thetaddot2 = ydot[3];
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
  // omegadot2 = -thetadot2 b2~ E2 omega1 + thetaddot2 b2 + E2 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_1 = thetaddot2 + omegadot1_1;
  const T omegadot2_2 = thetadot2 * omega2_3 + E2_22 * omegadot1_2 + E2_23 * omegadot1_3;
  const T omegadot2_3 = E2_22 * omegadot1_3 - E2_23 * omegadot1_2 - thetadot2 * omega2_2;
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
  const T t2_7 = minus_U1_11 * T(0.1805);
  const T t2_8 = U1_12 * T(0.047);
  const T t2_9 = t2_7 + t2_8;
  const T Pddot2_1 = Pddot1_1 - t2_9;
  const T t2_10 = U1_21 * T(0.1805);
  const T t2_11 = minus_U1_22 * T(0.047);
  const T t2_12 = t2_10 + t2_11;
  const T t2_13 = t2_12 + Pddot1_2;
  const T t2_14 = U1_32 * T(0.047);
  const T t2_15 = U1_31 * T(0.1805);
  const T t2_16 = t2_14 - t2_15;
  const T t2_17 = Pddot1_3 - t2_16;
  const T Pddot2_2 = E2_22 * t2_13 + E2_23 * t2_17;
  const T Pddot2_3 = E2_22 * t2_17 - E2_23 * t2_13;
  // effort_fr_hip_2 = -theta2 k_fr_hip_ - thetadot2 c_fr_hip_ + tau_fr_hip_: along the coordinate [N m], [N]
  const T effort_fr_hip_2 = u.tau_fr_hip - theta2 * c.p.kp - thetadot2 * c.p.kd;
  // G2 = U2 h_own_2: inertia less applied force, body axes [N]
  const T G2_1 = U2_13 * T(2.1575999999999998e-05) - U2_12 * T(0.081652909);
  const T G2_2 = minus_U2_22 * T(0.081652909) + U2_23 * T(2.1575999999999998e-05);
  const T minus_G2_3 = U2_32 * T(0.081652909) + minus_U2_33 * T(2.1575999999999998e-05);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(0.006961261717685661) * U2_32 - (T(2.1575999999999998e-05) * Pddot2_2 + T(0.081652909) * Pddot2_3)
      - T(0.000361904168856) * U2_23 - T(4.7970076e-07) * (minus_U2_22 - minus_U2_33) - T(7.94567044e-06) * U2_31 -
      T(2.70561864e-07) * U2_21;
  const T N2_2 = T(2.1575999999999998e-05) * Pddot2_1 + T(0.000361904168856) * U2_13 + T(0.000361904168856) * U2_31 +
      T(2.70561864e-07) * (minus_U2_33 - minus_U2_11) - T(4.7970076e-07) * U2_12 + T(7.94567044e-06) * U2_32;
  const T N2_3 = T(0.081652909) * Pddot2_1 - T(0.000361904168856) * U2_21 - T(0.006961261717685661) * U2_12 -
      T(7.94567044e-06) * (minus_U2_11 - minus_U2_22) + T(2.70561864e-07) * U2_23 + T(4.7970076e-07) * U2_13;

  // ---- body 3 (fr_thigh) on body 2
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  const T thetaddot3 = ydot[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 - R2_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 - R2_33 * minus_E3_13;
  const T R3_31 = R1_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R1_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = R1_13 * minus_E3_13 + R2_33 * E3_11;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega2_1 - minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + omega2_2;
  const T omega3_3 = minus_E3_13 * omega2_1 + E3_11 * omega2_3;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + thetaddot3 b3 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = E3_11 * omegadot2_1 - minus_E3_13 * omegadot2_3 - thetadot3 * omega3_3;
  const T omegadot3_2 = thetaddot3 + omegadot2_2;
  const T omegadot3_3 = thetadot3 * omega3_1 + minus_E3_13 * omegadot2_1 + E3_11 * omegadot2_3;
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
  const T t3_7 = Pddot2_1 - U2_12 * T(0.0838);
  const T t3_8 = Pddot2_3 - U2_32 * T(0.0838);
  const T Pddot3_1 = E3_11 * t3_7 - minus_E3_13 * t3_8;
  const T Pddot3_2 = Pddot2_2 + minus_U2_22 * T(0.0838);
  const T Pddot3_3 = minus_E3_13 * t3_7 + E3_11 * t3_8;
  // stretch_fr_thigh_3 = theta3 - l_fr_thigh_: stretch of the spring
  const T stretch_fr_thigh_3 = theta3 - T(0.8);
  // effort_fr_thigh_3 = -thetadot3 c_fr_thigh_ + tau_fr_thigh_ - stretch_fr_thigh_3 k_fr_thigh_: along the coordinate
  //   [N m], [N]
  const T effort_fr_thigh_3 = u.tau_fr_thigh - thetadot3 * c.p.kd - stretch_fr_thigh_3 * c.p.kp;
  // G3 = U3 h_own_3: inertia less applied force, body axes [N]
  const T G3_1 = minus_U3_11 * T(0.0032790809999999997) - U3_13 * T(0.072881238);
  const T minus_G3_2 = U3_21 * T(0.0032790809999999997) + U3_23 * T(0.072881238);
  const T G3_3 = minus_U3_33 * T(0.072881238) - U3_31 * T(0.0032790809999999997);
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(0.072881238) * Pddot3_2 - T(0.000499645385197) * U3_32 - T(0.014446725509588) * U3_23 -
      T(0.0005955910008259999) * (minus_U3_22 - minus_U3_33) - T(6.838704148699999e-05) * U3_31 + T(0.000254264832594)
      * U3_21;
  const T N3_2 = T(0.0032790809999999997) * Pddot3_3 - T(0.072881238) * Pddot3_1 + T(0.014446725509588) * U3_13 -
      T(0.000499645385197) * U3_31 - T(0.000254264832594) * (minus_U3_33 - minus_U3_11) - T(0.0005955910008259999) *
      U3_12 + T(6.838704148699999e-05) * U3_32;
  const T N3_3 = T(0.000499645385197) * U3_21 + T(0.000499645385197) * U3_12 - T(6.838704148699999e-05) * (minus_U3_11
      - minus_U3_22) - T(0.000254264832594) * U3_23 + T(0.0005955910008259999) * U3_13 - T(0.0032790809999999997) *
      Pddot3_2;

  // ---- body 4 (fr_calf) on body 3
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  const T thetaddot4 = ydot[5];
  // E4^T = Z4^T Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T t4_2 = sines[6];
  const T minus_E4_11 = T(0.9993592865650762) * t4_1 + T(0.035791288830411085) * t4_2;
  const T minus_E4_13 = T(0.035791288830411085) * t4_1 - T(0.9993592865650762) * t4_2;
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T minus_R4_11 = R3_11 * minus_E4_11 + R3_31 * minus_E4_13;
  const T minus_R4_12 = R3_12 * minus_E4_11 + R3_32 * minus_E4_13;
  const T minus_R4_13 = R3_13 * minus_E4_11 + R3_33 * minus_E4_13;
  const T R4_31 = R3_11 * minus_E4_13 - R3_31 * minus_E4_11;
  const T R4_32 = R3_12 * minus_E4_13 - R3_32 * minus_E4_11;
  const T R4_33 = R3_13 * minus_E4_13 - R3_33 * minus_E4_11;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T minus_omega4_1 = minus_E4_11 * omega3_1 + minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  const T omega4_3 = minus_E4_13 * omega3_1 - minus_E4_11 * omega3_3;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + thetaddot4 b4 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot4_1 = thetadot4 * omega4_3 + minus_E4_11 * omegadot3_1 + minus_E4_13 * omegadot3_3;
  const T omegadot4_2 = thetaddot4 + omegadot3_2;
  const T omegadot4_3 = minus_E4_13 * omegadot3_1 - minus_E4_11 * omegadot3_3 - thetadot4 * minus_omega4_1;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_3 = omega4_2 * omega4_2;
  const T minus_U4_11 = omega4_3 * omega4_3 + t4_3;
  const T t4_4 = omega4_2 * minus_omega4_1;
  const T minus_U4_12 = t4_4 + omegadot4_3;
  const T t4_5 = omega4_3 * minus_omega4_1;
  const T U4_13 = omegadot4_2 - t4_5;
  const T U4_21 = omegadot4_3 - t4_4;
  const T t4_6 = omega4_3 * omega4_2;
  const T U4_23 = t4_6 + minus_omegadot4_1;
  const T minus_U4_31 = t4_5 + omegadot4_2;
  const T U4_32 = t4_6 - minus_omegadot4_1;
  const T minus_U4_33 = t4_3 + minus_omega4_1 * minus_omega4_1;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot4_1 = minus_E4_11 * (Pddot3_1 - U3_13 * T(0.2)) + minus_E4_13 * (Pddot3_3 + minus_U3_33 *
      T(0.2));
  const T Pddot4_2 = Pddot3_2 - U3_23 * T(0.2);
  // stretch_fr_calf_4 = theta4 - l_fr_calf_: stretch of the spring
  const T stretch_fr_calf_4 = theta4 + T(1.6);
  // effort_fr_calf_4 = -thetadot4 c_fr_calf_ + tau_fr_calf_ - stretch_fr_calf_4 k_fr_calf_: along the coordinate [N
  //   m], [N]
  const T effort_fr_calf_4 = u.tau_fr_calf - thetadot4 * c.p.kd - stretch_fr_calf_4 * c.p.kp;
  // G4 = -R4 F_ground_on_fr_ + U4 h_own_4: inertia less applied force, body axes [N]
  const T t4_7 = minus_R4_11 * u.ground_fr_x + minus_R4_12 * u.ground_fr_y + minus_R4_13 * u.ground_fr_z;
  const T G4_1 = t4_7 + U4_13 * T(0.029845530432320418);
  const T t4_8 = R2_21 * u.ground_fr_x + R2_22 * u.ground_fr_y + R2_23 * u.ground_fr_z;
  const T G4_2 = U4_23 * T(0.029845530432320418) - t4_8;
  const T t4_9 = R4_31 * u.ground_fr_x + R4_32 * u.ground_fr_y + R4_33 * u.ground_fr_z;
  const T minus_G4_3 = t4_9 + minus_U4_33 * T(0.029845530432320418);
  // N4 = -o4~ R4 F_ground_on_fr_ + h_own_4~ Pddot4 + axial(U4 (tr(J_own_4)/2 - J_own_4)): inertia less applied moment
  //   about the body origin, body axes [N m]
  const T N4_1 = T(0.19987185731301527) * t4_8 - T(0.029845530432320418) * Pddot4_2 - T(4.712093241166159e-05) * U4_32
      - T(0.007297717301242339) * U4_23 - T(0.0002865260721362275) * U4_21;
  const T N4_2 = T(0.19987185731301527) * t4_7 + T(0.007158257766082217) * t4_9 - T(0.029845530432320418) *
      minus_Pddot4_1 + T(0.007297717301242339) * U4_13 + T(4.712093241166159e-05) * minus_U4_31 +
      T(0.0002865260721362275) * (minus_U4_33 - minus_U4_11);
  const T N4_3 = T(4.712093241166159e-05) * U4_21 - T(4.712093241166159e-05) * minus_U4_12 + T(0.0002865260721362275)
      * U4_23 - T(0.007158257766082217) * t4_8;

  // ---- body 6 (fl_hip) on body 1
  const T theta6 = x[7];
  const T thetadot6 = y[6];
  const T thetaddot6 = ydot[6];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];
  // R6^T = R1^T E6^T: R takes inertial components to body components
  const T R6_21 = R1_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R1_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R1_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R1_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R1_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R1_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega1: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega1_1;
  const T omega6_2 = E6_22 * omega1_2 + E6_23 * omega1_3;
  const T omega6_3 = E6_22 * omega1_3 - E6_23 * omega1_2;
  // omegadot6 = -thetadot6 b6~ E6 omega1 + thetaddot6 b6 + E6 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot6_1 = thetaddot6 + omegadot1_1;
  const T omegadot6_2 = thetadot6 * omega6_3 + E6_22 * omegadot1_2 + E6_23 * omegadot1_3;
  const T omegadot6_3 = E6_22 * omegadot1_3 - E6_23 * omegadot1_2 - thetadot6 * omega6_2;
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
  // Pddot6 = E6 (U1 q6 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t6_7 = t2_7 - t2_8;
  const T Pddot6_1 = Pddot1_1 - t6_7;
  const T t6_8 = t2_11 - t2_10;
  const T t6_9 = Pddot1_2 - t6_8;
  const T t6_10 = t2_15 + t2_14;
  const T t6_11 = t6_10 + Pddot1_3;
  const T Pddot6_2 = E6_22 * t6_9 + E6_23 * t6_11;
  const T Pddot6_3 = E6_22 * t6_11 - E6_23 * t6_9;
  // effort_fl_hip_6 = -theta6 k_fl_hip_ - thetadot6 c_fl_hip_ + tau_fl_hip_: along the coordinate [N m], [N]
  const T effort_fl_hip_6 = u.tau_fl_hip - theta6 * c.p.kp - thetadot6 * c.p.kd;
  // G6 = U6 h_own_6: inertia less applied force, body axes [N]
  const T G6_1 = U6_12 * T(0.081652909) + U6_13 * T(2.1575999999999998e-05);
  const T G6_2 = U6_23 * T(2.1575999999999998e-05) - minus_U6_22 * T(0.081652909);
  const T G6_3 = U6_32 * T(0.081652909) - minus_U6_33 * T(2.1575999999999998e-05);
  // N6 = h_own_6~ Pddot6 + axial(U6 (tr(J_own_6)/2 - J_own_6)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N6_1 = T(0.081652909) * Pddot6_3 - T(2.1575999999999998e-05) * Pddot6_2 + T(0.006961261717685661) * U6_32 -
      T(0.000361904168856) * U6_23 + T(4.7970076e-07) * (minus_U6_22 - minus_U6_33) + T(7.94567044e-06) * U6_31 -
      T(2.70561864e-07) * U6_21;
  const T N6_2 = T(2.1575999999999998e-05) * Pddot6_1 + T(0.000361904168856) * U6_13 + T(0.000361904168856) * U6_31 +
      T(2.70561864e-07) * (minus_U6_33 - minus_U6_11) + T(4.7970076e-07) * U6_12 - T(7.94567044e-06) * U6_32;
  const T N6_3 = T(7.94567044e-06) * (minus_U6_11 - minus_U6_22) - (T(0.000361904168856) * U6_21 +
      T(0.006961261717685661) * U6_12) + T(2.70561864e-07) * U6_23 - T(4.7970076e-07) * U6_13 - T(0.081652909) *
      Pddot6_1;

  // ---- body 7 (fl_thigh) on body 6
  const T theta7 = x[8];
  const T thetadot7 = y[7];
  const T thetaddot7 = ydot[7];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R1_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R1_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R1_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R1_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R1_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R1_13 * minus_E7_13 + R6_33 * E7_11;
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
  const T t7_7 = Pddot6_1 + U6_12 * T(0.0838);
  const T t7_8 = Pddot6_3 + U6_32 * T(0.0838);
  const T Pddot7_1 = E7_11 * t7_7 - minus_E7_13 * t7_8;
  const T Pddot7_2 = Pddot6_2 - minus_U6_22 * T(0.0838);
  const T Pddot7_3 = minus_E7_13 * t7_7 + E7_11 * t7_8;
  // stretch_fl_thigh_7 = theta7 - l_fl_thigh_: stretch of the spring
  const T stretch_fl_thigh_7 = theta7 - T(0.8);
  // effort_fl_thigh_7 = -thetadot7 c_fl_thigh_ + tau_fl_thigh_ - stretch_fl_thigh_7 k_fl_thigh_: along the coordinate
  //   [N m], [N]
  const T effort_fl_thigh_7 = u.tau_fl_thigh - thetadot7 * c.p.kd - stretch_fl_thigh_7 * c.p.kp;
  // G7 = U7 h_own_7: inertia less applied force, body axes [N]
  const T G7_1 = minus_U7_11 * T(0.0032790809999999997) - U7_13 * T(0.072881238);
  const T minus_G7_2 = U7_21 * T(0.0032790809999999997) + U7_23 * T(0.072881238);
  const T G7_3 = minus_U7_33 * T(0.072881238) - U7_31 * T(0.0032790809999999997);
  // N7 = h_own_7~ Pddot7 + axial(U7 (tr(J_own_7)/2 - J_own_7)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N7_1 = T(0.072881238) * Pddot7_2 - T(0.000499645385197) * U7_32 - T(0.014446725509588) * U7_23 +
      T(0.0005955910008259999) * (minus_U7_22 - minus_U7_33) + T(6.838704148699999e-05) * U7_31 + T(0.000254264832594)
      * U7_21;
  const T N7_2 = T(0.0032790809999999997) * Pddot7_3 - T(0.072881238) * Pddot7_1 + T(0.014446725509588) * U7_13 -
      T(0.000499645385197) * U7_31 - T(0.000254264832594) * (minus_U7_33 - minus_U7_11) + T(0.0005955910008259999) *
      U7_12 - T(6.838704148699999e-05) * U7_32;
  const T N7_3 = T(0.000499645385197) * U7_21 + T(0.000499645385197) * U7_12 + T(6.838704148699999e-05) * (minus_U7_11
      - minus_U7_22) - T(0.000254264832594) * U7_23 - T(0.0005955910008259999) * U7_13 - T(0.0032790809999999997) *
      Pddot7_2;

  // ---- body 8 (fl_calf) on body 7
  const T theta8 = x[9];
  const T thetadot8 = y[8];
  const T thetaddot8 = ydot[8];
  // E8^T = Z8^T Rot(b8, theta8): E takes components in the lower body to those in the body
  const T t8_1 = cosines[9];
  const T t8_2 = sines[9];
  const T minus_E8_11 = T(0.9993592865650762) * t8_1 + T(0.035791288830411085) * t8_2;
  const T minus_E8_13 = T(0.035791288830411085) * t8_1 - T(0.9993592865650762) * t8_2;
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T minus_R8_11 = R7_11 * minus_E8_11 + R7_31 * minus_E8_13;
  const T minus_R8_12 = R7_12 * minus_E8_11 + R7_32 * minus_E8_13;
  const T minus_R8_13 = R7_13 * minus_E8_11 + R7_33 * minus_E8_13;
  const T R8_31 = R7_11 * minus_E8_13 - R7_31 * minus_E8_11;
  const T R8_32 = R7_12 * minus_E8_13 - R7_32 * minus_E8_11;
  const T R8_33 = R7_13 * minus_E8_13 - R7_33 * minus_E8_11;
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T minus_omega8_1 = minus_E8_11 * omega7_1 + minus_E8_13 * omega7_3;
  const T omega8_2 = thetadot8 + omega7_2;
  const T omega8_3 = minus_E8_13 * omega7_1 - minus_E8_11 * omega7_3;
  // omegadot8 = -thetadot8 b8~ E8 omega7 + thetaddot8 b8 + E8 omegadot7: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot8_1 = thetadot8 * omega8_3 + minus_E8_11 * omegadot7_1 + minus_E8_13 * omegadot7_3;
  const T omegadot8_2 = thetaddot8 + omegadot7_2;
  const T omegadot8_3 = minus_E8_13 * omegadot7_1 - minus_E8_11 * omegadot7_3 - thetadot8 * minus_omega8_1;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_3 = omega8_2 * omega8_2;
  const T minus_U8_11 = omega8_3 * omega8_3 + t8_3;
  const T t8_4 = omega8_2 * minus_omega8_1;
  const T minus_U8_12 = t8_4 + omegadot8_3;
  const T t8_5 = omega8_3 * minus_omega8_1;
  const T U8_13 = omegadot8_2 - t8_5;
  const T U8_21 = omegadot8_3 - t8_4;
  const T t8_6 = omega8_3 * omega8_2;
  const T U8_23 = t8_6 + minus_omegadot8_1;
  const T minus_U8_31 = t8_5 + omegadot8_2;
  const T U8_32 = t8_6 - minus_omegadot8_1;
  const T minus_U8_33 = t8_3 + minus_omega8_1 * minus_omega8_1;
  // Pddot8 = E8 (U7 q8 + Pddot7): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot8_1 = minus_E8_11 * (Pddot7_1 - U7_13 * T(0.2)) + minus_E8_13 * (Pddot7_3 + minus_U7_33 *
      T(0.2));
  const T Pddot8_2 = Pddot7_2 - U7_23 * T(0.2);
  // stretch_fl_calf_8 = theta8 - l_fl_calf_: stretch of the spring
  const T stretch_fl_calf_8 = theta8 + T(1.6);
  // effort_fl_calf_8 = -thetadot8 c_fl_calf_ + tau_fl_calf_ - stretch_fl_calf_8 k_fl_calf_: along the coordinate [N
  //   m], [N]
  const T effort_fl_calf_8 = u.tau_fl_calf - thetadot8 * c.p.kd - stretch_fl_calf_8 * c.p.kp;
  // G8 = -R8 F_ground_on_fl_ + U8 h_own_8: inertia less applied force, body axes [N]
  const T t8_7 = minus_R8_11 * u.ground_fl_x + minus_R8_12 * u.ground_fl_y + minus_R8_13 * u.ground_fl_z;
  const T G8_1 = t8_7 + U8_13 * T(0.029845530432320418);
  const T t8_8 = R6_21 * u.ground_fl_x + R6_22 * u.ground_fl_y + R6_23 * u.ground_fl_z;
  const T G8_2 = U8_23 * T(0.029845530432320418) - t8_8;
  const T t8_9 = R8_31 * u.ground_fl_x + R8_32 * u.ground_fl_y + R8_33 * u.ground_fl_z;
  const T minus_G8_3 = t8_9 + minus_U8_33 * T(0.029845530432320418);
  // N8 = -o8~ R8 F_ground_on_fl_ + h_own_8~ Pddot8 + axial(U8 (tr(J_own_8)/2 - J_own_8)): inertia less applied moment
  //   about the body origin, body axes [N m]
  const T N8_1 = T(0.19987185731301527) * t8_8 - T(0.029845530432320418) * Pddot8_2 - T(4.712093241166159e-05) * U8_32
      - T(0.007297717301242339) * U8_23 - T(0.0002865260721362275) * U8_21;
  const T N8_2 = T(0.19987185731301527) * t8_7 + T(0.007158257766082217) * t8_9 - T(0.029845530432320418) *
      minus_Pddot8_1 + T(0.007297717301242339) * U8_13 + T(4.712093241166159e-05) * minus_U8_31 +
      T(0.0002865260721362275) * (minus_U8_33 - minus_U8_11);
  const T N8_3 = T(4.712093241166159e-05) * U8_21 - T(4.712093241166159e-05) * minus_U8_12 + T(0.0002865260721362275)
      * U8_23 - T(0.007158257766082217) * t8_8;

  // ---- body 10 (rr_hip) on body 1
  const T theta10 = x[10];
  const T thetadot10 = y[9];
  const T thetaddot10 = ydot[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];
  // R10^T = R1^T E10^T: R takes inertial components to body components
  const T R10_21 = R1_21 * E10_22 + R1_31 * E10_23;
  const T R10_22 = R1_22 * E10_22 + R1_32 * E10_23;
  const T R10_23 = R1_23 * E10_22 + R1_33 * E10_23;
  const T R10_31 = R1_31 * E10_22 - R1_21 * E10_23;
  const T R10_32 = R1_32 * E10_22 - R1_22 * E10_23;
  const T R10_33 = R1_33 * E10_22 - R1_23 * E10_23;
  // omega10 = thetadot10 b10 + E10 omega1: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = thetadot10 + omega1_1;
  const T omega10_2 = E10_22 * omega1_2 + E10_23 * omega1_3;
  const T omega10_3 = E10_22 * omega1_3 - E10_23 * omega1_2;
  // omegadot10 = -thetadot10 b10~ E10 omega1 + thetaddot10 b10 + E10 omegadot1: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot10_1 = thetaddot10 + omegadot1_1;
  const T omegadot10_2 = thetadot10 * omega10_3 + E10_22 * omegadot1_2 + E10_23 * omegadot1_3;
  const T omegadot10_3 = E10_22 * omegadot1_3 - E10_23 * omegadot1_2 - thetadot10 * omega10_2;
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
  // Pddot10 = E10 (U1 q10 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot10_1 = t6_7 + Pddot1_1;
  const T t10_7 = t6_8 + Pddot1_2;
  const T t10_8 = Pddot1_3 - t6_10;
  const T Pddot10_2 = E10_22 * t10_7 + E10_23 * t10_8;
  const T Pddot10_3 = E10_22 * t10_8 - E10_23 * t10_7;
  // effort_rr_hip_10 = -theta10 k_rr_hip_ - thetadot10 c_rr_hip_ + tau_rr_hip_: along the coordinate [N m], [N]
  const T effort_rr_hip_10 = u.tau_rr_hip - theta10 * c.p.kp - thetadot10 * c.p.kd;
  // G10 = U10 h_own_10: inertia less applied force, body axes [N]
  const T G10_1 = U10_13 * T(2.1575999999999998e-05) - U10_12 * T(0.081652909);
  const T G10_2 = minus_U10_22 * T(0.081652909) + U10_23 * T(2.1575999999999998e-05);
  const T minus_G10_3 = U10_32 * T(0.081652909) + minus_U10_33 * T(2.1575999999999998e-05);
  // N10 = h_own_10~ Pddot10 + axial(U10 (tr(J_own_10)/2 - J_own_10)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N10_1 = T(0.006961261717685661) * U10_32 - (T(2.1575999999999998e-05) * Pddot10_2 + T(0.081652909) *
      Pddot10_3) - T(0.000361904168856) * U10_23 - T(4.7970076e-07) * (minus_U10_22 - minus_U10_33) +
      T(7.94567044e-06) * U10_31 + T(2.70561864e-07) * U10_21;
  const T N10_2 = T(2.1575999999999998e-05) * Pddot10_1 + T(0.000361904168856) * U10_13 + T(0.000361904168856) *
      U10_31 - T(2.70561864e-07) * (minus_U10_33 - minus_U10_11) - T(4.7970076e-07) * U10_12 - T(7.94567044e-06) *
      U10_32;
  const T N10_3 = T(0.081652909) * Pddot10_1 - T(0.000361904168856) * U10_21 - T(0.006961261717685661) * U10_12 +
      T(7.94567044e-06) * (minus_U10_11 - minus_U10_22) - T(2.70561864e-07) * U10_23 + T(4.7970076e-07) * U10_13;

  // ---- body 11 (rr_thigh) on body 10
  const T theta11 = x[11];
  const T thetadot11 = y[10];
  const T thetaddot11 = ydot[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R1_11 * E11_11 - R10_31 * minus_E11_13;
  const T R11_12 = R1_12 * E11_11 - R10_32 * minus_E11_13;
  const T R11_13 = R1_13 * E11_11 - R10_33 * minus_E11_13;
  const T R11_31 = R1_11 * minus_E11_13 + R10_31 * E11_11;
  const T R11_32 = R1_12 * minus_E11_13 + R10_32 * E11_11;
  const T R11_33 = R1_13 * minus_E11_13 + R10_33 * E11_11;
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 - minus_E11_13 * omega10_3;
  const T omega11_2 = thetadot11 + omega10_2;
  const T omega11_3 = minus_E11_13 * omega10_1 + E11_11 * omega10_3;
  // omegadot11 = -thetadot11 b11~ E11 omega10 + thetaddot11 b11 + E11 omegadot10: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot11_1 = E11_11 * omegadot10_1 - minus_E11_13 * omegadot10_3 - thetadot11 * omega11_3;
  const T omegadot11_2 = thetaddot11 + omegadot10_2;
  const T omegadot11_3 = thetadot11 * omega11_1 + minus_E11_13 * omegadot10_1 + E11_11 * omegadot10_3;
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
  const T t11_7 = Pddot10_1 - U10_12 * T(0.0838);
  const T t11_8 = Pddot10_3 - U10_32 * T(0.0838);
  const T Pddot11_1 = E11_11 * t11_7 - minus_E11_13 * t11_8;
  const T Pddot11_2 = Pddot10_2 + minus_U10_22 * T(0.0838);
  const T Pddot11_3 = minus_E11_13 * t11_7 + E11_11 * t11_8;
  // stretch_rr_thigh_11 = theta11 - l_rr_thigh_: stretch of the spring
  const T stretch_rr_thigh_11 = theta11 - T(0.8);
  // effort_rr_thigh_11 = -thetadot11 c_rr_thigh_ + tau_rr_thigh_ - stretch_rr_thigh_11 k_rr_thigh_: along the
  //   coordinate [N m], [N]
  const T effort_rr_thigh_11 = u.tau_rr_thigh - thetadot11 * c.p.kd - stretch_rr_thigh_11 * c.p.kp;
  // G11 = U11 h_own_11: inertia less applied force, body axes [N]
  const T G11_1 = minus_U11_11 * T(0.0032790809999999997) - U11_13 * T(0.072881238);
  const T minus_G11_2 = U11_21 * T(0.0032790809999999997) + U11_23 * T(0.072881238);
  const T G11_3 = minus_U11_33 * T(0.072881238) - U11_31 * T(0.0032790809999999997);
  // N11 = h_own_11~ Pddot11 + axial(U11 (tr(J_own_11)/2 - J_own_11)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N11_1 = T(0.072881238) * Pddot11_2 - T(0.000499645385197) * U11_32 - T(0.014446725509588) * U11_23 -
      T(0.0005955910008259999) * (minus_U11_22 - minus_U11_33) - T(6.838704148699999e-05) * U11_31 +
      T(0.000254264832594) * U11_21;
  const T N11_2 = T(0.0032790809999999997) * Pddot11_3 - T(0.072881238) * Pddot11_1 + T(0.014446725509588) * U11_13 -
      T(0.000499645385197) * U11_31 - T(0.000254264832594) * (minus_U11_33 - minus_U11_11) - T(0.0005955910008259999)
      * U11_12 + T(6.838704148699999e-05) * U11_32;
  const T N11_3 = T(0.000499645385197) * U11_21 + T(0.000499645385197) * U11_12 - T(6.838704148699999e-05) *
      (minus_U11_11 - minus_U11_22) - T(0.000254264832594) * U11_23 + T(0.0005955910008259999) * U11_13 -
      T(0.0032790809999999997) * Pddot11_2;

  // ---- body 12 (rr_calf) on body 11
  const T theta12 = x[12];
  const T thetadot12 = y[11];
  const T thetaddot12 = ydot[11];
  // E12^T = Z12^T Rot(b12, theta12): E takes components in the lower body to those in the body
  const T t12_1 = cosines[12];
  const T t12_2 = sines[12];
  const T minus_E12_11 = T(0.9993592865650762) * t12_1 + T(0.035791288830411085) * t12_2;
  const T minus_E12_13 = T(0.035791288830411085) * t12_1 - T(0.9993592865650762) * t12_2;
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T minus_R12_11 = R11_11 * minus_E12_11 + R11_31 * minus_E12_13;
  const T minus_R12_12 = R11_12 * minus_E12_11 + R11_32 * minus_E12_13;
  const T minus_R12_13 = R11_13 * minus_E12_11 + R11_33 * minus_E12_13;
  const T R12_31 = R11_11 * minus_E12_13 - R11_31 * minus_E12_11;
  const T R12_32 = R11_12 * minus_E12_13 - R11_32 * minus_E12_11;
  const T R12_33 = R11_13 * minus_E12_13 - R11_33 * minus_E12_11;
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T minus_omega12_1 = minus_E12_11 * omega11_1 + minus_E12_13 * omega11_3;
  const T omega12_2 = thetadot12 + omega11_2;
  const T omega12_3 = minus_E12_13 * omega11_1 - minus_E12_11 * omega11_3;
  // omegadot12 = -thetadot12 b12~ E12 omega11 + thetaddot12 b12 + E12 omegadot11: angular acceleration, body axes
  //   [rad/s^2]
  const T minus_omegadot12_1 = thetadot12 * omega12_3 + minus_E12_11 * omegadot11_1 + minus_E12_13 * omegadot11_3;
  const T omegadot12_2 = thetaddot12 + omegadot11_2;
  const T omegadot12_3 = minus_E12_13 * omegadot11_1 - minus_E12_11 * omegadot11_3 - thetadot12 * minus_omega12_1;
  // U12 = omega12~ omega12~ + omegadot12~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t12_3 = omega12_2 * omega12_2;
  const T minus_U12_11 = omega12_3 * omega12_3 + t12_3;
  const T t12_4 = omega12_2 * minus_omega12_1;
  const T minus_U12_12 = t12_4 + omegadot12_3;
  const T t12_5 = omega12_3 * minus_omega12_1;
  const T U12_13 = omegadot12_2 - t12_5;
  const T U12_21 = omegadot12_3 - t12_4;
  const T t12_6 = omega12_3 * omega12_2;
  const T U12_23 = t12_6 + minus_omegadot12_1;
  const T minus_U12_31 = t12_5 + omegadot12_2;
  const T U12_32 = t12_6 - minus_omegadot12_1;
  const T minus_U12_33 = t12_3 + minus_omega12_1 * minus_omega12_1;
  // Pddot12 = E12 (U11 q12 + Pddot11): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot12_1 = minus_E12_11 * (Pddot11_1 - U11_13 * T(0.2)) + minus_E12_13 * (Pddot11_3 + minus_U11_33 *
      T(0.2));
  const T Pddot12_2 = Pddot11_2 - U11_23 * T(0.2);
  // stretch_rr_calf_12 = theta12 - l_rr_calf_: stretch of the spring
  const T stretch_rr_calf_12 = theta12 + T(1.6);
  // effort_rr_calf_12 = -thetadot12 c_rr_calf_ + tau_rr_calf_ - stretch_rr_calf_12 k_rr_calf_: along the coordinate
  //   [N m], [N]
  const T effort_rr_calf_12 = u.tau_rr_calf - thetadot12 * c.p.kd - stretch_rr_calf_12 * c.p.kp;
  // G12 = -R12 F_ground_on_rr_ + U12 h_own_12: inertia less applied force, body axes [N]
  const T t12_7 = minus_R12_11 * u.ground_rr_x + minus_R12_12 * u.ground_rr_y + minus_R12_13 * u.ground_rr_z;
  const T G12_1 = t12_7 + U12_13 * T(0.029845530432320418);
  const T t12_8 = R10_21 * u.ground_rr_x + R10_22 * u.ground_rr_y + R10_23 * u.ground_rr_z;
  const T G12_2 = U12_23 * T(0.029845530432320418) - t12_8;
  const T t12_9 = R12_31 * u.ground_rr_x + R12_32 * u.ground_rr_y + R12_33 * u.ground_rr_z;
  const T minus_G12_3 = t12_9 + minus_U12_33 * T(0.029845530432320418);
  // N12 = -o12~ R12 F_ground_on_rr_ + h_own_12~ Pddot12 + axial(U12 (tr(J_own_12)/2 - J_own_12)): inertia less
  //   applied moment about the body origin, body axes [N m]
  const T N12_1 = T(0.19987185731301527) * t12_8 - T(0.029845530432320418) * Pddot12_2 - T(4.712093241166159e-05) *
      U12_32 - T(0.007297717301242339) * U12_23 - T(0.0002865260721362275) * U12_21;
  const T N12_2 = T(0.19987185731301527) * t12_7 + T(0.007158257766082217) * t12_9 - T(0.029845530432320418) *
      minus_Pddot12_1 + T(0.007297717301242339) * U12_13 + T(4.712093241166159e-05) * minus_U12_31 +
      T(0.0002865260721362275) * (minus_U12_33 - minus_U12_11);
  const T N12_3 = T(4.712093241166159e-05) * U12_21 - T(4.712093241166159e-05) * minus_U12_12 +
      T(0.0002865260721362275) * U12_23 - T(0.007158257766082217) * t12_8;

  // ---- body 14 (rl_hip) on body 1
  const T theta14 = x[13];
  const T thetadot14 = y[12];
  const T thetaddot14 = ydot[12];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];
  // R14^T = R1^T E14^T: R takes inertial components to body components
  const T R14_21 = R1_21 * E14_22 + R1_31 * E14_23;
  const T R14_22 = R1_22 * E14_22 + R1_32 * E14_23;
  const T R14_23 = R1_23 * E14_22 + R1_33 * E14_23;
  const T R14_31 = R1_31 * E14_22 - R1_21 * E14_23;
  const T R14_32 = R1_32 * E14_22 - R1_22 * E14_23;
  const T R14_33 = R1_33 * E14_22 - R1_23 * E14_23;
  // omega14 = thetadot14 b14 + E14 omega1: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = thetadot14 + omega1_1;
  const T omega14_2 = E14_22 * omega1_2 + E14_23 * omega1_3;
  const T omega14_3 = E14_22 * omega1_3 - E14_23 * omega1_2;
  // omegadot14 = -thetadot14 b14~ E14 omega1 + thetaddot14 b14 + E14 omegadot1: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot14_1 = thetaddot14 + omegadot1_1;
  const T omegadot14_2 = thetadot14 * omega14_3 + E14_22 * omegadot1_2 + E14_23 * omegadot1_3;
  const T omegadot14_3 = E14_22 * omegadot1_3 - E14_23 * omegadot1_2 - thetadot14 * omega14_2;
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
  // Pddot14 = E14 (U1 q14 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot14_1 = t2_9 + Pddot1_1;
  const T t14_7 = Pddot1_2 - t2_12;
  const T t14_8 = t2_16 + Pddot1_3;
  const T Pddot14_2 = E14_22 * t14_7 + E14_23 * t14_8;
  const T Pddot14_3 = E14_22 * t14_8 - E14_23 * t14_7;
  // effort_rl_hip_14 = -theta14 k_rl_hip_ - thetadot14 c_rl_hip_ + tau_rl_hip_: along the coordinate [N m], [N]
  const T effort_rl_hip_14 = u.tau_rl_hip - theta14 * c.p.kp - thetadot14 * c.p.kd;
  // G14 = U14 h_own_14: inertia less applied force, body axes [N]
  const T G14_1 = U14_12 * T(0.081652909) + U14_13 * T(2.1575999999999998e-05);
  const T G14_2 = U14_23 * T(2.1575999999999998e-05) - minus_U14_22 * T(0.081652909);
  const T G14_3 = U14_32 * T(0.081652909) - minus_U14_33 * T(2.1575999999999998e-05);
  // N14 = h_own_14~ Pddot14 + axial(U14 (tr(J_own_14)/2 - J_own_14)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N14_1 = T(0.081652909) * Pddot14_3 - T(2.1575999999999998e-05) * Pddot14_2 + T(0.006961261717685661) *
      U14_32 - T(0.000361904168856) * U14_23 + T(4.7970076e-07) * (minus_U14_22 - minus_U14_33) - T(7.94567044e-06) *
      U14_31 + T(2.70561864e-07) * U14_21;
  const T N14_2 = T(2.1575999999999998e-05) * Pddot14_1 + T(0.000361904168856) * U14_13 + T(0.000361904168856) *
      U14_31 - T(2.70561864e-07) * (minus_U14_33 - minus_U14_11) + T(4.7970076e-07) * U14_12 + T(7.94567044e-06) *
      U14_32;
  const T minus_N14_3 = T(0.081652909) * Pddot14_1 + T(0.000361904168856) * U14_21 + T(0.006961261717685661) * U14_12
      + T(7.94567044e-06) * (minus_U14_11 - minus_U14_22) + T(2.70561864e-07) * U14_23 + T(4.7970076e-07) * U14_13;

  // ---- body 15 (rl_thigh) on body 14
  const T theta15 = x[14];
  const T thetadot15 = y[13];
  const T thetaddot15 = ydot[13];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_11 = R1_11 * E15_11 - R14_31 * minus_E15_13;
  const T R15_12 = R1_12 * E15_11 - R14_32 * minus_E15_13;
  const T R15_13 = R1_13 * E15_11 - R14_33 * minus_E15_13;
  const T R15_31 = R1_11 * minus_E15_13 + R14_31 * E15_11;
  const T R15_32 = R1_12 * minus_E15_13 + R14_32 * E15_11;
  const T R15_33 = R1_13 * minus_E15_13 + R14_33 * E15_11;
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = E15_11 * omega14_1 - minus_E15_13 * omega14_3;
  const T omega15_2 = thetadot15 + omega14_2;
  const T omega15_3 = minus_E15_13 * omega14_1 + E15_11 * omega14_3;
  // omegadot15 = -thetadot15 b15~ E15 omega14 + thetaddot15 b15 + E15 omegadot14: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot15_1 = E15_11 * omegadot14_1 - minus_E15_13 * omegadot14_3 - thetadot15 * omega15_3;
  const T omegadot15_2 = thetaddot15 + omegadot14_2;
  const T omegadot15_3 = thetadot15 * omega15_1 + minus_E15_13 * omegadot14_1 + E15_11 * omegadot14_3;
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
  const T t15_7 = Pddot14_1 + U14_12 * T(0.0838);
  const T t15_8 = Pddot14_3 + U14_32 * T(0.0838);
  const T Pddot15_1 = E15_11 * t15_7 - minus_E15_13 * t15_8;
  const T Pddot15_2 = Pddot14_2 - minus_U14_22 * T(0.0838);
  const T Pddot15_3 = minus_E15_13 * t15_7 + E15_11 * t15_8;
  // stretch_rl_thigh_15 = theta15 - l_rl_thigh_: stretch of the spring
  const T stretch_rl_thigh_15 = theta15 - T(0.8);
  // effort_rl_thigh_15 = -thetadot15 c_rl_thigh_ + tau_rl_thigh_ - stretch_rl_thigh_15 k_rl_thigh_: along the
  //   coordinate [N m], [N]
  const T effort_rl_thigh_15 = u.tau_rl_thigh - thetadot15 * c.p.kd - stretch_rl_thigh_15 * c.p.kp;
  // G15 = U15 h_own_15: inertia less applied force, body axes [N]
  const T G15_1 = minus_U15_11 * T(0.0032790809999999997) - U15_13 * T(0.072881238);
  const T minus_G15_2 = U15_21 * T(0.0032790809999999997) + U15_23 * T(0.072881238);
  const T G15_3 = minus_U15_33 * T(0.072881238) - U15_31 * T(0.0032790809999999997);
  // N15 = h_own_15~ Pddot15 + axial(U15 (tr(J_own_15)/2 - J_own_15)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N15_1 = T(0.072881238) * Pddot15_2 - T(0.000499645385197) * U15_32 - T(0.014446725509588) * U15_23 +
      T(0.0005955910008259999) * (minus_U15_22 - minus_U15_33) + T(6.838704148699999e-05) * U15_31 +
      T(0.000254264832594) * U15_21;
  const T N15_2 = T(0.0032790809999999997) * Pddot15_3 - T(0.072881238) * Pddot15_1 + T(0.014446725509588) * U15_13 -
      T(0.000499645385197) * U15_31 - T(0.000254264832594) * (minus_U15_33 - minus_U15_11) + T(0.0005955910008259999)
      * U15_12 - T(6.838704148699999e-05) * U15_32;
  const T N15_3 = T(0.000499645385197) * U15_21 + T(0.000499645385197) * U15_12 + T(6.838704148699999e-05) *
      (minus_U15_11 - minus_U15_22) - T(0.000254264832594) * U15_23 - T(0.0005955910008259999) * U15_13 -
      T(0.0032790809999999997) * Pddot15_2;

  // ---- body 16 (rl_calf) on body 15
  const T theta16 = x[15];
  const T thetadot16 = y[14];
  const T thetaddot16 = ydot[14];
  // E16^T = Z16^T Rot(b16, theta16): E takes components in the lower body to those in the body
  const T t16_1 = cosines[15];
  const T t16_2 = sines[15];
  const T minus_E16_11 = T(0.9993592865650762) * t16_1 + T(0.035791288830411085) * t16_2;
  const T minus_E16_13 = T(0.035791288830411085) * t16_1 - T(0.9993592865650762) * t16_2;
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T minus_R16_11 = R15_11 * minus_E16_11 + R15_31 * minus_E16_13;
  const T minus_R16_12 = R15_12 * minus_E16_11 + R15_32 * minus_E16_13;
  const T minus_R16_13 = R15_13 * minus_E16_11 + R15_33 * minus_E16_13;
  const T R16_31 = R15_11 * minus_E16_13 - R15_31 * minus_E16_11;
  const T R16_32 = R15_12 * minus_E16_13 - R15_32 * minus_E16_11;
  const T R16_33 = R15_13 * minus_E16_13 - R15_33 * minus_E16_11;
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T minus_omega16_1 = minus_E16_11 * omega15_1 + minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 - minus_E16_11 * omega15_3;
  // omegadot16 = -thetadot16 b16~ E16 omega15 + thetaddot16 b16 + E16 omegadot15: angular acceleration, body axes
  //   [rad/s^2]
  const T minus_omegadot16_1 = thetadot16 * omega16_3 + minus_E16_11 * omegadot15_1 + minus_E16_13 * omegadot15_3;
  const T omegadot16_2 = thetaddot16 + omegadot15_2;
  const T omegadot16_3 = minus_E16_13 * omegadot15_1 - minus_E16_11 * omegadot15_3 - thetadot16 * minus_omega16_1;
  // U16 = omega16~ omega16~ + omegadot16~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t16_3 = omega16_2 * omega16_2;
  const T minus_U16_11 = omega16_3 * omega16_3 + t16_3;
  const T t16_4 = omega16_2 * minus_omega16_1;
  const T minus_U16_12 = t16_4 + omegadot16_3;
  const T t16_5 = omega16_3 * minus_omega16_1;
  const T U16_13 = omegadot16_2 - t16_5;
  const T U16_21 = omegadot16_3 - t16_4;
  const T t16_6 = omega16_3 * omega16_2;
  const T U16_23 = t16_6 + minus_omegadot16_1;
  const T minus_U16_31 = t16_5 + omegadot16_2;
  const T U16_32 = t16_6 - minus_omegadot16_1;
  const T minus_U16_33 = t16_3 + minus_omega16_1 * minus_omega16_1;
  // Pddot16 = E16 (U15 q16 + Pddot15): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot16_1 = minus_E16_11 * (Pddot15_1 - U15_13 * T(0.2)) + minus_E16_13 * (Pddot15_3 + minus_U15_33 *
      T(0.2));
  const T Pddot16_2 = Pddot15_2 - U15_23 * T(0.2);
  // stretch_rl_calf_16 = theta16 - l_rl_calf_: stretch of the spring
  const T stretch_rl_calf_16 = theta16 + T(1.6);
  // effort_rl_calf_16 = -thetadot16 c_rl_calf_ + tau_rl_calf_ - stretch_rl_calf_16 k_rl_calf_: along the coordinate
  //   [N m], [N]
  const T effort_rl_calf_16 = u.tau_rl_calf - thetadot16 * c.p.kd - stretch_rl_calf_16 * c.p.kp;
  // G16 = -R16 F_ground_on_rl_ + U16 h_own_16: inertia less applied force, body axes [N]
  const T t16_7 = minus_R16_11 * u.ground_rl_x + minus_R16_12 * u.ground_rl_y + minus_R16_13 * u.ground_rl_z;
  const T G16_1 = t16_7 + U16_13 * T(0.029845530432320418);
  const T t16_8 = R14_21 * u.ground_rl_x + R14_22 * u.ground_rl_y + R14_23 * u.ground_rl_z;
  const T G16_2 = U16_23 * T(0.029845530432320418) - t16_8;
  const T t16_9 = R16_31 * u.ground_rl_x + R16_32 * u.ground_rl_y + R16_33 * u.ground_rl_z;
  const T minus_G16_3 = t16_9 + minus_U16_33 * T(0.029845530432320418);
  // N16 = -o16~ R16 F_ground_on_rl_ + h_own_16~ Pddot16 + axial(U16 (tr(J_own_16)/2 - J_own_16)): inertia less
  //   applied moment about the body origin, body axes [N m]
  const T N16_1 = T(0.19987185731301527) * t16_8 - T(0.029845530432320418) * Pddot16_2 - T(4.712093241166159e-05) *
      U16_32 - T(0.007297717301242339) * U16_23 - T(0.0002865260721362275) * U16_21;
  const T N16_2 = T(0.19987185731301527) * t16_7 + T(0.007158257766082217) * t16_9 - T(0.029845530432320418) *
      minus_Pddot16_1 + T(0.007297717301242339) * U16_13 + T(4.712093241166159e-05) * minus_U16_31 +
      T(0.0002865260721362275) * (minus_U16_33 - minus_U16_11);
  const T N16_3 = T(4.712093241166159e-05) * U16_21 - T(4.712093241166159e-05) * minus_U16_12 +
      T(0.0002865260721362275) * U16_23 - T(0.007158257766082217) * t16_8;

  // ---- body 16 (rl_calf) and what it carries
  // r_theta16 = b16 . N16 - effort_rl_calf_16: Kane's equation of the angle [N m]
  const T r_theta16 = N16_2 - effort_rl_calf_16;
  r[14] = r_theta16;

  // ---- body 15 (rl_thigh) and what it carries
  // S15 = E16^T G16 + G15: sum of the force balances of the subtree, body axes [N]
  const T b15_1 = minus_E16_11 * G16_1 + minus_E16_13 * minus_G16_3;
  const T S15_1 = G15_1 - b15_1;
  const T S15_2 = G16_2 - minus_G15_2;
  const T S15_3 = G15_3 + minus_E16_11 * minus_G16_3 - minus_E16_13 * G16_1;
  // rho15 = q16~ E16^T G16 + E16^T N16 + N15: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho15_1 = N15_1 + T(0.2) * G16_2 + minus_E16_13 * N16_3 - minus_E16_11 * N16_1;
  const T rho15_2 = N16_2 + N15_2 + T(0.2) * b15_1;
  const T rho15_3 = N15_3 - minus_E16_13 * N16_1 - minus_E16_11 * N16_3;
  // r_theta15 = b15 . rho15 - effort_rl_thigh_15: Kane's equation of the angle [N m]
  const T r_theta15 = rho15_2 - effort_rl_thigh_15;
  r[13] = r_theta15;

  // ---- body 14 (rl_hip) and what it carries
  // S14 = E15^T S15 + G14: sum of the force balances of the subtree, body axes [N]
  const T b14_1 = E15_11 * S15_1 + minus_E15_13 * S15_3;
  const T S14_1 = b14_1 + G14_1;
  const T S14_2 = S15_2 + G14_2;
  const T b14_2 = E15_11 * S15_3 - minus_E15_13 * S15_1;
  const T S14_3 = b14_2 + G14_3;
  // rho14 = q15~ E15^T S15 + E15^T rho15 + N14: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho14_1 = N14_1 + T(0.0838) * b14_2 + E15_11 * rho15_1 + minus_E15_13 * rho15_3;
  const T rho14_2 = rho15_2 + N14_2;
  const T rho14_3 = E15_11 * rho15_3 - minus_N14_3 - minus_E15_13 * rho15_1 - T(0.0838) * b14_1;
  // r_theta14 = b14 . rho14 - effort_rl_hip_14: Kane's equation of the angle [N m]
  const T r_theta14 = rho14_1 - effort_rl_hip_14;
  r[12] = r_theta14;

  // ---- body 12 (rr_calf) and what it carries
  // r_theta12 = b12 . N12 - effort_rr_calf_12: Kane's equation of the angle [N m]
  const T r_theta12 = N12_2 - effort_rr_calf_12;
  r[11] = r_theta12;

  // ---- body 11 (rr_thigh) and what it carries
  // S11 = E12^T G12 + G11: sum of the force balances of the subtree, body axes [N]
  const T b11_1 = minus_E12_11 * G12_1 + minus_E12_13 * minus_G12_3;
  const T S11_1 = G11_1 - b11_1;
  const T S11_2 = G12_2 - minus_G11_2;
  const T S11_3 = G11_3 + minus_E12_11 * minus_G12_3 - minus_E12_13 * G12_1;
  // rho11 = q12~ E12^T G12 + E12^T N12 + N11: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho11_1 = N11_1 + T(0.2) * G12_2 + minus_E12_13 * N12_3 - minus_E12_11 * N12_1;
  const T rho11_2 = N12_2 + N11_2 + T(0.2) * b11_1;
  const T rho11_3 = N11_3 - minus_E12_13 * N12_1 - minus_E12_11 * N12_3;
  // r_theta11 = b11 . rho11 - effort_rr_thigh_11: Kane's equation of the angle [N m]
  const T r_theta11 = rho11_2 - effort_rr_thigh_11;
  r[10] = r_theta11;

  // ---- body 10 (rr_hip) and what it carries
  // S10 = E11^T S11 + G10: sum of the force balances of the subtree, body axes [N]
  const T b10_1 = E11_11 * S11_1 + minus_E11_13 * S11_3;
  const T S10_1 = b10_1 + G10_1;
  const T S10_2 = S11_2 + G10_2;
  const T b10_2 = E11_11 * S11_3 - minus_E11_13 * S11_1;
  const T S10_3 = b10_2 - minus_G10_3;
  // rho10 = q11~ E11^T S11 + E11^T rho11 + N10: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho10_1 = N10_1 + E11_11 * rho11_1 + minus_E11_13 * rho11_3 - T(0.0838) * b10_2;
  const T rho10_2 = rho11_2 + N10_2;
  const T rho10_3 = N10_3 + T(0.0838) * b10_1 + E11_11 * rho11_3 - minus_E11_13 * rho11_1;
  // r_theta10 = b10 . rho10 - effort_rr_hip_10: Kane's equation of the angle [N m]
  const T r_theta10 = rho10_1 - effort_rr_hip_10;
  r[9] = r_theta10;

  // ---- body 8 (fl_calf) and what it carries
  // r_theta8 = b8 . N8 - effort_fl_calf_8: Kane's equation of the angle [N m]
  const T r_theta8 = N8_2 - effort_fl_calf_8;
  r[8] = r_theta8;

  // ---- body 7 (fl_thigh) and what it carries
  // S7 = E8^T G8 + G7: sum of the force balances of the subtree, body axes [N]
  const T b7_1 = minus_E8_11 * G8_1 + minus_E8_13 * minus_G8_3;
  const T S7_1 = G7_1 - b7_1;
  const T S7_2 = G8_2 - minus_G7_2;
  const T S7_3 = G7_3 + minus_E8_11 * minus_G8_3 - minus_E8_13 * G8_1;
  // rho7 = q8~ E8^T G8 + E8^T N8 + N7: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho7_1 = N7_1 + T(0.2) * G8_2 + minus_E8_13 * N8_3 - minus_E8_11 * N8_1;
  const T rho7_2 = N8_2 + N7_2 + T(0.2) * b7_1;
  const T rho7_3 = N7_3 - minus_E8_13 * N8_1 - minus_E8_11 * N8_3;
  // r_theta7 = b7 . rho7 - effort_fl_thigh_7: Kane's equation of the angle [N m]
  const T r_theta7 = rho7_2 - effort_fl_thigh_7;
  r[7] = r_theta7;

  // ---- body 6 (fl_hip) and what it carries
  // S6 = E7^T S7 + G6: sum of the force balances of the subtree, body axes [N]
  const T b6_1 = E7_11 * S7_1 + minus_E7_13 * S7_3;
  const T S6_1 = b6_1 + G6_1;
  const T S6_2 = S7_2 + G6_2;
  const T b6_2 = E7_11 * S7_3 - minus_E7_13 * S7_1;
  const T S6_3 = b6_2 + G6_3;
  // rho6 = q7~ E7^T S7 + E7^T rho7 + N6: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho6_1 = N6_1 + T(0.0838) * b6_2 + E7_11 * rho7_1 + minus_E7_13 * rho7_3;
  const T rho6_2 = rho7_2 + N6_2;
  const T rho6_3 = N6_3 + E7_11 * rho7_3 - minus_E7_13 * rho7_1 - T(0.0838) * b6_1;
  // r_theta6 = b6 . rho6 - effort_fl_hip_6: Kane's equation of the angle [N m]
  const T r_theta6 = rho6_1 - effort_fl_hip_6;
  r[6] = r_theta6;

  // ---- body 4 (fr_calf) and what it carries
  // r_theta4 = b4 . N4 - effort_fr_calf_4: Kane's equation of the angle [N m]
  const T r_theta4 = N4_2 - effort_fr_calf_4;
  r[5] = r_theta4;

  // ---- body 3 (fr_thigh) and what it carries
  // S3 = E4^T G4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = minus_E4_11 * G4_1 + minus_E4_13 * minus_G4_3;
  const T S3_1 = G3_1 - b3_1;
  const T S3_2 = G4_2 - minus_G3_2;
  const T S3_3 = G3_3 + minus_E4_11 * minus_G4_3 - minus_E4_13 * G4_1;
  // rho3 = q4~ E4^T G4 + E4^T N4 + N3: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho3_1 = N3_1 + T(0.2) * G4_2 + minus_E4_13 * N4_3 - minus_E4_11 * N4_1;
  const T rho3_2 = N4_2 + N3_2 + T(0.2) * b3_1;
  const T rho3_3 = N3_3 - minus_E4_13 * N4_1 - minus_E4_11 * N4_3;
  // r_theta3 = b3 . rho3 - effort_fr_thigh_3: Kane's equation of the angle [N m]
  const T r_theta3 = rho3_2 - effort_fr_thigh_3;
  r[4] = r_theta3;

  // ---- body 2 (fr_hip) and what it carries
  // S2 = E3^T S3 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = E3_11 * S3_1 + minus_E3_13 * S3_3;
  const T S2_1 = b2_1 + G2_1;
  const T S2_2 = S3_2 + G2_2;
  const T b2_2 = E3_11 * S3_3 - minus_E3_13 * S3_1;
  const T S2_3 = b2_2 - minus_G2_3;
  // rho2 = q3~ E3^T S3 + E3^T rho3 + N2: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho2_1 = N2_1 + E3_11 * rho3_1 + minus_E3_13 * rho3_3 - T(0.0838) * b2_2;
  const T rho2_2 = rho3_2 + N2_2;
  const T rho2_3 = N2_3 + T(0.0838) * b2_1 + E3_11 * rho3_3 - minus_E3_13 * rho3_1;
  // r_theta2 = b2 . rho2 - effort_fr_hip_2: Kane's equation of the angle [N m]
  const T r_theta2 = rho2_1 - effort_fr_hip_2;
  r[3] = r_theta2;

  // ---- body 1 (trunk) and what it carries
  // S1 = E2^T S2 + E6^T S6 + E10^T S10 + E14^T S14 + G1: sum of the force balances of the subtree, body axes [N]
  const T S1_1 = S2_1 + S6_1 + S10_1 + S14_1 + G1_1;
  const T b1_1 = E2_22 * S2_2 - E2_23 * S2_3;
  const T b1_2 = E6_22 * S6_2 - E6_23 * S6_3;
  const T b1_3 = E10_22 * S10_2 - E10_23 * S10_3;
  const T b1_4 = E14_22 * S14_2 - E14_23 * S14_3;
  const T S1_2 = b1_1 + b1_2 + b1_3 + b1_4 + G1_2;
  const T b1_5 = E2_23 * S2_2 + E2_22 * S2_3;
  const T b1_6 = E6_23 * S6_2 + E6_22 * S6_3;
  const T b1_7 = E10_23 * S10_2 + E10_22 * S10_3;
  const T b1_8 = E14_23 * S14_2 + E14_22 * S14_3;
  const T S1_3 = b1_5 + b1_6 + b1_7 + b1_8 + G1_3;
  // r_omega1 = q2~ E2^T S2 + E2^T rho2 + q6~ E6^T S6 + E6^T rho6 + q10~ E10^T S10 + E10^T rho10 + q14~ E14^T S14 +
  //   E14^T rho14 + N1: Kane's equation of omega [N m]
  const T r_omega1_1 = rho2_1 + rho6_1 + rho10_1 + rho14_1 + N1_1 - T(0.047) * b1_5 + T(0.047) * b1_6 - T(0.047) *
      b1_7 + T(0.047) * b1_8;
  const T r_omega1_2 = N1_2 + E2_22 * rho2_2 - E2_23 * rho2_3 - T(0.1805) * b1_5 - T(0.1805) * b1_6 + E6_22 * rho6_2 -
      E6_23 * rho6_3 + T(0.1805) * b1_7 + E10_22 * rho10_2 - E10_23 * rho10_3 + T(0.1805) * b1_8 + E14_22 * rho14_2 -
      E14_23 * rho14_3;
  const T r_omega1_3 = N1_3 + T(0.1805) * b1_1 + T(0.047) * S2_1 + E2_23 * rho2_2 + E2_22 * rho2_3 + T(0.1805) * b1_2
      - T(0.047) * S6_1 + E6_23 * rho6_2 + E6_22 * rho6_3 + T(0.047) * S10_1 - T(0.1805) * b1_3 + E10_23 * rho10_2 +
      E10_22 * rho10_3 - T(0.1805) * b1_4 - T(0.047) * S14_1 + E14_23 * rho14_2 + E14_22 * rho14_3;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
  // r_sdot1 = R1^T S1: Kane's equation of sdot [N]
  const T r_sdot1_1 = R1_11 * S1_1 + R1_21 * S1_2 + R1_31 * S1_3;
  const T r_sdot1_2 = R1_12 * S1_1 + R1_22 * S1_2 + R1_32 * S1_3;
  const T r_sdot1_3 = R1_13 * S1_1 + R1_23 * S1_2 + R1_33 * S1_3;
  r[15] = r_sdot1_1;
  r[16] = r_sdot1_2;
  r[17] = r_sdot1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 796 add, 909 multiply, 24 sine or cosine
template <class T>
void forcing(const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* f) noexcept {
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
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
  // G1 = -m_all_1 Pddot1 - U1 h_all_1: applied less inertia force, body axes [N]
  const T minus_G1_1 = c.m_all_1 * Pddot1_1 + U1_12 * c.h_all_1_2 - U1_13 * c.c1_2;
  const T minus_G1_2 = c.m_all_1 * Pddot1_2 - (minus_U1_22 * c.h_all_1_2 + U1_23 * c.c1_2);
  const T minus_G1_3 = c.m_all_1 * Pddot1_3 + U1_23 * c.h_all_1_2 + minus_U1_33 * c.c1_2;
  // N1 = -h_all_1~ Pddot1 - omega1~ J_all_1 omega1: applied less inertia moment about the body origin, body axes [N
  //   m]
  const T minus_N1_1 = c.c1_2 * Pddot1_2 + c.h_all_1_2 * Pddot1_3 + c.c1_10 * U1_23 + c.J_all_1_23 * (t1_14 - t1_13) -
      T(6.11e-05) * U1_12 + T(3.66e-05) * U1_13;
  const T minus_N1_2 = c.c1_11 * U1_13 - T(6.11e-05) * (t1_13 - t1_15) - T(3.66e-05) * U1_23 - c.J_all_1_23 * U1_12 -
      c.c1_2 * Pddot1_1;
  const T minus_N1_3 = c.J_all_1_23 * U1_13 - (c.c1_6 * U1_12 + T(3.66e-05) * (t1_15 - t1_14)) + T(6.11e-05) * U1_23 -
      c.h_all_1_2 * Pddot1_1;

  // ---- body 2 (fr_hip) on body 1
  const T theta2 = x[4];
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
  // effort_fr_hip_2 = -theta2 k_fr_hip_ - thetadot2 c_fr_hip_ + tau_fr_hip_: along the coordinate [N m], [N]
  const T effort_fr_hip_2 = u.tau_fr_hip - theta2 * c.p.kp - thetadot2 * c.p.kd;
  // omegadot2 = -thetadot2 b2~ E2 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_2 = thetadot2 * omega2_3;
  const T minus_omegadot2_3 = thetadot2 * omega2_2;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_1 = omega2_3 * omega2_3;
  const T t2_2 = omega2_2 * omega2_2;
  const T minus_U2_11 = t2_1 + t2_2;
  const T t2_3 = omega2_2 * omega2_1;
  const T U2_12 = t2_3 + minus_omegadot2_3;
  const T t2_4 = omega2_3 * omega2_1;
  const T U2_13 = t2_4 + omegadot2_2;
  const T U2_21 = t2_3 - minus_omegadot2_3;
  const T t2_5 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_1 + t2_5;
  const T U2_23 = omega2_3 * omega2_2;
  const T U2_31 = t2_4 - omegadot2_2;
  const T minus_U2_33 = t2_2 + t2_5;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_6 = minus_U1_11 * T(0.1805);
  const T t2_7 = U1_12 * T(0.047);
  const T t2_8 = t2_6 + t2_7;
  const T Pddot2_1 = Pddot1_1 - t2_8;
  const T t2_9 = U1_12 * T(0.1805);
  const T t2_10 = minus_U1_22 * T(0.047);
  const T t2_11 = t2_9 + t2_10;
  const T t2_12 = t2_11 + Pddot1_2;
  const T t2_13 = U1_23 * T(0.047);
  const T t2_14 = U1_13 * T(0.1805);
  const T t2_15 = t2_13 - t2_14;
  const T t2_16 = Pddot1_3 - t2_15;
  const T Pddot2_2 = E2_22 * t2_12 + E2_23 * t2_16;
  const T Pddot2_3 = E2_22 * t2_16 - E2_23 * t2_12;
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_1 = U2_13 * T(2.1575999999999998e-05) - U2_12 * T(0.081652909);
  const T minus_G2_2 = minus_U2_22 * T(0.081652909) + U2_23 * T(2.1575999999999998e-05);
  const T G2_3 = U2_23 * T(0.081652909) + minus_U2_33 * T(2.1575999999999998e-05);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_1 = T(0.0065993575488296615) * U2_23 - T(4.7970076e-07) * (minus_U2_22 - minus_U2_33) -
      T(7.94567044e-06) * U2_31 - T(2.70561864e-07) * U2_21 - T(2.1575999999999998e-05) * Pddot2_2 - T(0.081652909) *
      Pddot2_3;
  const T minus_N2_2 = T(2.1575999999999998e-05) * Pddot2_1 + T(0.000361904168856) * U2_13 + T(0.000361904168856) *
      U2_31 + T(2.70561864e-07) * (minus_U2_33 - minus_U2_11) - T(4.7970076e-07) * U2_12 + T(7.94567044e-06) * U2_23;
  const T minus_N2_3 = T(0.081652909) * Pddot2_1 - T(0.000361904168856) * U2_21 - T(0.006961261717685661) * U2_12 -
      T(7.94567044e-06) * (minus_U2_11 - minus_U2_22) + T(2.70561864e-07) * U2_23 + T(4.7970076e-07) * U2_13;

  // ---- body 3 (fr_thigh) on body 2
  const T theta3 = x[5];
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 - R2_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 - R2_33 * minus_E3_13;
  const T R3_31 = R1_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R1_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = R1_13 * minus_E3_13 + R2_33 * E3_11;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega2_1 - minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + omega2_2;
  const T omega3_3 = minus_E3_13 * omega2_1 + E3_11 * omega2_3;
  // stretch_fr_thigh_3 = theta3 - l_fr_thigh_: stretch of the spring
  const T stretch_fr_thigh_3 = theta3 - T(0.8);
  // effort_fr_thigh_3 = -thetadot3 c_fr_thigh_ + tau_fr_thigh_ - stretch_fr_thigh_3 k_fr_thigh_: along the coordinate
  //   [N m], [N]
  const T effort_fr_thigh_3 = u.tau_fr_thigh - thetadot3 * c.p.kd - stretch_fr_thigh_3 * c.p.kp;
  // omegadot3 = -thetadot3 b3~ E3 omega2 + E3 omegadot2: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = minus_E3_13 * minus_omegadot2_3 - thetadot3 * omega3_3;
  const T omegadot3_3 = thetadot3 * omega3_1 - E3_11 * minus_omegadot2_3;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_1 = omega3_3 * omega3_3;
  const T t3_2 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_1 + t3_2;
  const T t3_3 = omega3_2 * omega3_1;
  const T U3_12 = t3_3 - omegadot3_3;
  const T t3_4 = omega3_3 * omega3_1;
  const T U3_13 = t3_4 + omegadot2_2;
  const T U3_21 = t3_3 + omegadot3_3;
  const T t3_5 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_1 + t3_5;
  const T t3_6 = omega3_3 * omega3_2;
  const T U3_23 = t3_6 - omegadot3_1;
  const T U3_31 = t3_4 - omegadot2_2;
  const T U3_32 = t3_6 + omegadot3_1;
  const T minus_U3_33 = t3_2 + t3_5;
  // Pddot3 = E3 (U2 q3 + Pddot2): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_7 = Pddot2_1 - U2_12 * T(0.0838);
  const T t3_8 = Pddot2_3 - U2_23 * T(0.0838);
  const T Pddot3_1 = E3_11 * t3_7 - minus_E3_13 * t3_8;
  const T Pddot3_2 = Pddot2_2 + minus_U2_22 * T(0.0838);
  const T Pddot3_3 = minus_E3_13 * t3_7 + E3_11 * t3_8;
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = minus_U3_11 * T(0.0032790809999999997) - U3_13 * T(0.072881238);
  const T G3_2 = U3_21 * T(0.0032790809999999997) + U3_23 * T(0.072881238);
  const T minus_G3_3 = minus_U3_33 * T(0.072881238) - U3_31 * T(0.0032790809999999997);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N3_1 = T(0.072881238) * Pddot3_2 - T(0.000499645385197) * U3_32 - T(0.014446725509588) * U3_23 -
      T(0.0005955910008259999) * (minus_U3_22 - minus_U3_33) - T(6.838704148699999e-05) * U3_31 + T(0.000254264832594)
      * U3_21;
  const T minus_N3_2 = T(0.0032790809999999997) * Pddot3_3 - T(0.072881238) * Pddot3_1 + T(0.014446725509588) * U3_13
      - T(0.000499645385197) * U3_31 - T(0.000254264832594) * (minus_U3_33 - minus_U3_11) - T(0.0005955910008259999) *
      U3_12 + T(6.838704148699999e-05) * U3_32;
  const T minus_N3_3 = T(0.000499645385197) * U3_21 + T(0.000499645385197) * U3_12 - T(6.838704148699999e-05) *
      (minus_U3_11 - minus_U3_22) - T(0.000254264832594) * U3_23 + T(0.0005955910008259999) * U3_13 -
      T(0.0032790809999999997) * Pddot3_2;

  // ---- body 4 (fr_calf) on body 3
  const T theta4 = x[6];
  const T thetadot4 = y[5];
  // E4^T = Z4^T Rot(b4, theta4): E takes components in the lower body to those in the body
  const T t4_1 = cosines[6];
  const T t4_2 = sines[6];
  const T minus_E4_11 = T(0.9993592865650762) * t4_1 + T(0.035791288830411085) * t4_2;
  const T minus_E4_13 = T(0.035791288830411085) * t4_1 - T(0.9993592865650762) * t4_2;
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T minus_R4_11 = R3_11 * minus_E4_11 + R3_31 * minus_E4_13;
  const T minus_R4_12 = R3_12 * minus_E4_11 + R3_32 * minus_E4_13;
  const T minus_R4_13 = R3_13 * minus_E4_11 + R3_33 * minus_E4_13;
  const T R4_31 = R3_11 * minus_E4_13 - R3_31 * minus_E4_11;
  const T R4_32 = R3_12 * minus_E4_13 - R3_32 * minus_E4_11;
  const T R4_33 = R3_13 * minus_E4_13 - R3_33 * minus_E4_11;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T minus_omega4_1 = minus_E4_11 * omega3_1 + minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  const T omega4_3 = minus_E4_13 * omega3_1 - minus_E4_11 * omega3_3;
  // stretch_fr_calf_4 = theta4 - l_fr_calf_: stretch of the spring
  const T stretch_fr_calf_4 = theta4 + T(1.6);
  // effort_fr_calf_4 = -thetadot4 c_fr_calf_ + tau_fr_calf_ - stretch_fr_calf_4 k_fr_calf_: along the coordinate [N
  //   m], [N]
  const T effort_fr_calf_4 = u.tau_fr_calf - thetadot4 * c.p.kd - stretch_fr_calf_4 * c.p.kp;
  // omegadot4 = -thetadot4 b4~ E4 omega3 + E4 omegadot3: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot4_1 = thetadot4 * omega4_3 + minus_E4_11 * omegadot3_1 + minus_E4_13 * omegadot3_3;
  const T omegadot4_3 = minus_E4_13 * omegadot3_1 - minus_E4_11 * omegadot3_3 - thetadot4 * minus_omega4_1;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_3 = omega4_2 * omega4_2;
  const T minus_U4_11 = omega4_3 * omega4_3 + t4_3;
  const T t4_4 = omega4_2 * minus_omega4_1;
  const T minus_U4_12 = t4_4 + omegadot4_3;
  const T t4_5 = omega4_3 * minus_omega4_1;
  const T U4_13 = omegadot2_2 - t4_5;
  const T U4_21 = omegadot4_3 - t4_4;
  const T t4_6 = omega4_3 * omega4_2;
  const T U4_23 = t4_6 + minus_omegadot4_1;
  const T minus_U4_31 = t4_5 + omegadot2_2;
  const T U4_32 = t4_6 - minus_omegadot4_1;
  const T minus_U4_33 = t4_3 + minus_omega4_1 * minus_omega4_1;
  // Pddot4 = E4 (U3 q4 + Pddot3): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot4_1 = minus_E4_11 * (Pddot3_1 - U3_13 * T(0.2)) + minus_E4_13 * (Pddot3_3 + minus_U3_33 *
      T(0.2));
  const T Pddot4_2 = Pddot3_2 - U3_23 * T(0.2);
  // G4 = R4 F_ground_on_fr_ - U4 h_own_4: applied less inertia force, body axes [N]
  const T t4_7 = minus_R4_11 * u.ground_fr_x + minus_R4_12 * u.ground_fr_y + minus_R4_13 * u.ground_fr_z;
  const T minus_G4_1 = t4_7 + U4_13 * T(0.029845530432320418);
  const T t4_8 = R2_21 * u.ground_fr_x + R2_22 * u.ground_fr_y + R2_23 * u.ground_fr_z;
  const T G4_2 = t4_8 - U4_23 * T(0.029845530432320418);
  const T t4_9 = R4_31 * u.ground_fr_x + R4_32 * u.ground_fr_y + R4_33 * u.ground_fr_z;
  const T G4_3 = t4_9 + minus_U4_33 * T(0.029845530432320418);
  // N4 = o4~ R4 F_ground_on_fr_ - h_own_4~ Pddot4 - axial(U4 (tr(J_own_4)/2 - J_own_4)): applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N4_1 = T(0.029845530432320418) * Pddot4_2 - T(0.19987185731301527) * t4_8 + T(4.712093241166159e-05) * U4_32
      + T(0.007297717301242339) * U4_23 + T(0.0002865260721362275) * U4_21;
  const T N4_2 = T(0.029845530432320418) * minus_Pddot4_1 - (T(0.19987185731301527) * t4_7 + T(0.007158257766082217) *
      t4_9) - T(0.007297717301242339) * U4_13 - T(4.712093241166159e-05) * minus_U4_31 - T(0.0002865260721362275) *
      (minus_U4_33 - minus_U4_11);
  const T N4_3 = T(4.712093241166159e-05) * minus_U4_12 - T(4.712093241166159e-05) * U4_21 - T(0.0002865260721362275)
      * U4_23 + T(0.007158257766082217) * t4_8;

  // ---- body 6 (fl_hip) on body 1
  const T theta6 = x[7];
  const T thetadot6 = y[6];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];
  // R6^T = R1^T E6^T: R takes inertial components to body components
  const T R6_21 = R1_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R1_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R1_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R1_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R1_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R1_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega1: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega1_1;
  const T omega6_2 = E6_22 * omega1_2 + E6_23 * omega1_3;
  const T omega6_3 = E6_22 * omega1_3 - E6_23 * omega1_2;
  // effort_fl_hip_6 = -theta6 k_fl_hip_ - thetadot6 c_fl_hip_ + tau_fl_hip_: along the coordinate [N m], [N]
  const T effort_fl_hip_6 = u.tau_fl_hip - theta6 * c.p.kp - thetadot6 * c.p.kd;
  // omegadot6 = -thetadot6 b6~ E6 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot6_2 = thetadot6 * omega6_3;
  const T minus_omegadot6_3 = thetadot6 * omega6_2;
  // U6 = omega6~ omega6~ + omegadot6~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t6_1 = omega6_3 * omega6_3;
  const T t6_2 = omega6_2 * omega6_2;
  const T minus_U6_11 = t6_1 + t6_2;
  const T t6_3 = omega6_2 * omega6_1;
  const T U6_12 = t6_3 + minus_omegadot6_3;
  const T t6_4 = omega6_3 * omega6_1;
  const T U6_13 = t6_4 + omegadot6_2;
  const T U6_21 = t6_3 - minus_omegadot6_3;
  const T t6_5 = omega6_1 * omega6_1;
  const T minus_U6_22 = t6_1 + t6_5;
  const T U6_23 = omega6_3 * omega6_2;
  const T U6_31 = t6_4 - omegadot6_2;
  const T minus_U6_33 = t6_2 + t6_5;
  // Pddot6 = E6 (U1 q6 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t6_6 = t2_6 - t2_7;
  const T Pddot6_1 = Pddot1_1 - t6_6;
  const T t6_7 = t2_10 - t2_9;
  const T t6_8 = Pddot1_2 - t6_7;
  const T t6_9 = t2_14 + t2_13;
  const T t6_10 = t6_9 + Pddot1_3;
  const T Pddot6_2 = E6_22 * t6_8 + E6_23 * t6_10;
  const T Pddot6_3 = E6_22 * t6_10 - E6_23 * t6_8;
  // G6 = -U6 h_own_6: applied less inertia force, body axes [N]
  const T minus_G6_1 = U6_12 * T(0.081652909) + U6_13 * T(2.1575999999999998e-05);
  const T minus_G6_2 = U6_23 * T(2.1575999999999998e-05) - minus_U6_22 * T(0.081652909);
  const T minus_G6_3 = U6_23 * T(0.081652909) - minus_U6_33 * T(2.1575999999999998e-05);
  // N6 = -h_own_6~ Pddot6 - axial(U6 (tr(J_own_6)/2 - J_own_6)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N6_1 = T(0.081652909) * Pddot6_3 - T(2.1575999999999998e-05) * Pddot6_2 + T(0.0065993575488296615) *
      U6_23 + T(4.7970076e-07) * (minus_U6_22 - minus_U6_33) + T(7.94567044e-06) * U6_31 - T(2.70561864e-07) * U6_21;
  const T minus_N6_2 = T(2.1575999999999998e-05) * Pddot6_1 + T(0.000361904168856) * U6_13 + T(0.000361904168856) *
      U6_31 + T(2.70561864e-07) * (minus_U6_33 - minus_U6_11) + T(4.7970076e-07) * U6_12 - T(7.94567044e-06) * U6_23;
  const T minus_N6_3 = T(7.94567044e-06) * (minus_U6_11 - minus_U6_22) - (T(0.000361904168856) * U6_21 +
      T(0.006961261717685661) * U6_12) + T(2.70561864e-07) * U6_23 - T(4.7970076e-07) * U6_13 - T(0.081652909) *
      Pddot6_1;

  // ---- body 7 (fl_thigh) on body 6
  const T theta7 = x[8];
  const T thetadot7 = y[7];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R1_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R1_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R1_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R1_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R1_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R1_13 * minus_E7_13 + R6_33 * E7_11;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // stretch_fl_thigh_7 = theta7 - l_fl_thigh_: stretch of the spring
  const T stretch_fl_thigh_7 = theta7 - T(0.8);
  // effort_fl_thigh_7 = -thetadot7 c_fl_thigh_ + tau_fl_thigh_ - stretch_fl_thigh_7 k_fl_thigh_: along the coordinate
  //   [N m], [N]
  const T effort_fl_thigh_7 = u.tau_fl_thigh - thetadot7 * c.p.kd - stretch_fl_thigh_7 * c.p.kp;
  // omegadot7 = -thetadot7 b7~ E7 omega6 + E7 omegadot6: angular acceleration, body axes [rad/s^2]
  const T omegadot7_1 = minus_E7_13 * minus_omegadot6_3 - thetadot7 * omega7_3;
  const T omegadot7_3 = thetadot7 * omega7_1 - E7_11 * minus_omegadot6_3;
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
  const T t7_7 = Pddot6_1 + U6_12 * T(0.0838);
  const T t7_8 = Pddot6_3 + U6_23 * T(0.0838);
  const T Pddot7_1 = E7_11 * t7_7 - minus_E7_13 * t7_8;
  const T Pddot7_2 = Pddot6_2 - minus_U6_22 * T(0.0838);
  const T Pddot7_3 = minus_E7_13 * t7_7 + E7_11 * t7_8;
  // G7 = -U7 h_own_7: applied less inertia force, body axes [N]
  const T minus_G7_1 = minus_U7_11 * T(0.0032790809999999997) - U7_13 * T(0.072881238);
  const T G7_2 = U7_21 * T(0.0032790809999999997) + U7_23 * T(0.072881238);
  const T minus_G7_3 = minus_U7_33 * T(0.072881238) - U7_31 * T(0.0032790809999999997);
  // N7 = -h_own_7~ Pddot7 - axial(U7 (tr(J_own_7)/2 - J_own_7)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N7_1 = T(0.072881238) * Pddot7_2 - T(0.000499645385197) * U7_32 - T(0.014446725509588) * U7_23 +
      T(0.0005955910008259999) * (minus_U7_22 - minus_U7_33) + T(6.838704148699999e-05) * U7_31 + T(0.000254264832594)
      * U7_21;
  const T minus_N7_2 = T(0.0032790809999999997) * Pddot7_3 - T(0.072881238) * Pddot7_1 + T(0.014446725509588) * U7_13
      - T(0.000499645385197) * U7_31 - T(0.000254264832594) * (minus_U7_33 - minus_U7_11) + T(0.0005955910008259999) *
      U7_12 - T(6.838704148699999e-05) * U7_32;
  const T minus_N7_3 = T(0.000499645385197) * U7_21 + T(0.000499645385197) * U7_12 + T(6.838704148699999e-05) *
      (minus_U7_11 - minus_U7_22) - T(0.000254264832594) * U7_23 - T(0.0005955910008259999) * U7_13 -
      T(0.0032790809999999997) * Pddot7_2;

  // ---- body 8 (fl_calf) on body 7
  const T theta8 = x[9];
  const T thetadot8 = y[8];
  // E8^T = Z8^T Rot(b8, theta8): E takes components in the lower body to those in the body
  const T t8_1 = cosines[9];
  const T t8_2 = sines[9];
  const T minus_E8_11 = T(0.9993592865650762) * t8_1 + T(0.035791288830411085) * t8_2;
  const T minus_E8_13 = T(0.035791288830411085) * t8_1 - T(0.9993592865650762) * t8_2;
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T minus_R8_11 = R7_11 * minus_E8_11 + R7_31 * minus_E8_13;
  const T minus_R8_12 = R7_12 * minus_E8_11 + R7_32 * minus_E8_13;
  const T minus_R8_13 = R7_13 * minus_E8_11 + R7_33 * minus_E8_13;
  const T R8_31 = R7_11 * minus_E8_13 - R7_31 * minus_E8_11;
  const T R8_32 = R7_12 * minus_E8_13 - R7_32 * minus_E8_11;
  const T R8_33 = R7_13 * minus_E8_13 - R7_33 * minus_E8_11;
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T minus_omega8_1 = minus_E8_11 * omega7_1 + minus_E8_13 * omega7_3;
  const T omega8_2 = thetadot8 + omega7_2;
  const T omega8_3 = minus_E8_13 * omega7_1 - minus_E8_11 * omega7_3;
  // stretch_fl_calf_8 = theta8 - l_fl_calf_: stretch of the spring
  const T stretch_fl_calf_8 = theta8 + T(1.6);
  // effort_fl_calf_8 = -thetadot8 c_fl_calf_ + tau_fl_calf_ - stretch_fl_calf_8 k_fl_calf_: along the coordinate [N
  //   m], [N]
  const T effort_fl_calf_8 = u.tau_fl_calf - thetadot8 * c.p.kd - stretch_fl_calf_8 * c.p.kp;
  // omegadot8 = -thetadot8 b8~ E8 omega7 + E8 omegadot7: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot8_1 = thetadot8 * omega8_3 + minus_E8_11 * omegadot7_1 + minus_E8_13 * omegadot7_3;
  const T omegadot8_3 = minus_E8_13 * omegadot7_1 - minus_E8_11 * omegadot7_3 - thetadot8 * minus_omega8_1;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_3 = omega8_2 * omega8_2;
  const T minus_U8_11 = omega8_3 * omega8_3 + t8_3;
  const T t8_4 = omega8_2 * minus_omega8_1;
  const T minus_U8_12 = t8_4 + omegadot8_3;
  const T t8_5 = omega8_3 * minus_omega8_1;
  const T U8_13 = omegadot6_2 - t8_5;
  const T U8_21 = omegadot8_3 - t8_4;
  const T t8_6 = omega8_3 * omega8_2;
  const T U8_23 = t8_6 + minus_omegadot8_1;
  const T minus_U8_31 = t8_5 + omegadot6_2;
  const T U8_32 = t8_6 - minus_omegadot8_1;
  const T minus_U8_33 = t8_3 + minus_omega8_1 * minus_omega8_1;
  // Pddot8 = E8 (U7 q8 + Pddot7): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot8_1 = minus_E8_11 * (Pddot7_1 - U7_13 * T(0.2)) + minus_E8_13 * (Pddot7_3 + minus_U7_33 *
      T(0.2));
  const T Pddot8_2 = Pddot7_2 - U7_23 * T(0.2);
  // G8 = R8 F_ground_on_fl_ - U8 h_own_8: applied less inertia force, body axes [N]
  const T t8_7 = minus_R8_11 * u.ground_fl_x + minus_R8_12 * u.ground_fl_y + minus_R8_13 * u.ground_fl_z;
  const T minus_G8_1 = t8_7 + U8_13 * T(0.029845530432320418);
  const T t8_8 = R6_21 * u.ground_fl_x + R6_22 * u.ground_fl_y + R6_23 * u.ground_fl_z;
  const T G8_2 = t8_8 - U8_23 * T(0.029845530432320418);
  const T t8_9 = R8_31 * u.ground_fl_x + R8_32 * u.ground_fl_y + R8_33 * u.ground_fl_z;
  const T G8_3 = t8_9 + minus_U8_33 * T(0.029845530432320418);
  // N8 = o8~ R8 F_ground_on_fl_ - h_own_8~ Pddot8 - axial(U8 (tr(J_own_8)/2 - J_own_8)): applied less inertia moment
  //   about the body origin, body axes [N m]
  const T N8_1 = T(0.029845530432320418) * Pddot8_2 - T(0.19987185731301527) * t8_8 + T(4.712093241166159e-05) * U8_32
      + T(0.007297717301242339) * U8_23 + T(0.0002865260721362275) * U8_21;
  const T N8_2 = T(0.029845530432320418) * minus_Pddot8_1 - (T(0.19987185731301527) * t8_7 + T(0.007158257766082217) *
      t8_9) - T(0.007297717301242339) * U8_13 - T(4.712093241166159e-05) * minus_U8_31 - T(0.0002865260721362275) *
      (minus_U8_33 - minus_U8_11);
  const T N8_3 = T(4.712093241166159e-05) * minus_U8_12 - T(4.712093241166159e-05) * U8_21 - T(0.0002865260721362275)
      * U8_23 + T(0.007158257766082217) * t8_8;

  // ---- body 10 (rr_hip) on body 1
  const T theta10 = x[10];
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];
  // R10^T = R1^T E10^T: R takes inertial components to body components
  const T R10_21 = R1_21 * E10_22 + R1_31 * E10_23;
  const T R10_22 = R1_22 * E10_22 + R1_32 * E10_23;
  const T R10_23 = R1_23 * E10_22 + R1_33 * E10_23;
  const T R10_31 = R1_31 * E10_22 - R1_21 * E10_23;
  const T R10_32 = R1_32 * E10_22 - R1_22 * E10_23;
  const T R10_33 = R1_33 * E10_22 - R1_23 * E10_23;
  // omega10 = thetadot10 b10 + E10 omega1: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = thetadot10 + omega1_1;
  const T omega10_2 = E10_22 * omega1_2 + E10_23 * omega1_3;
  const T omega10_3 = E10_22 * omega1_3 - E10_23 * omega1_2;
  // effort_rr_hip_10 = -theta10 k_rr_hip_ - thetadot10 c_rr_hip_ + tau_rr_hip_: along the coordinate [N m], [N]
  const T effort_rr_hip_10 = u.tau_rr_hip - theta10 * c.p.kp - thetadot10 * c.p.kd;
  // omegadot10 = -thetadot10 b10~ E10 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot10_2 = thetadot10 * omega10_3;
  const T minus_omegadot10_3 = thetadot10 * omega10_2;
  // U10 = omega10~ omega10~ + omegadot10~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t10_1 = omega10_3 * omega10_3;
  const T t10_2 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_1 + t10_2;
  const T t10_3 = omega10_2 * omega10_1;
  const T U10_12 = t10_3 + minus_omegadot10_3;
  const T t10_4 = omega10_3 * omega10_1;
  const T U10_13 = t10_4 + omegadot10_2;
  const T U10_21 = t10_3 - minus_omegadot10_3;
  const T t10_5 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_1 + t10_5;
  const T U10_23 = omega10_3 * omega10_2;
  const T U10_31 = t10_4 - omegadot10_2;
  const T minus_U10_33 = t10_2 + t10_5;
  // Pddot10 = E10 (U1 q10 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot10_1 = t6_6 + Pddot1_1;
  const T t10_6 = t6_7 + Pddot1_2;
  const T t10_7 = Pddot1_3 - t6_9;
  const T Pddot10_2 = E10_22 * t10_6 + E10_23 * t10_7;
  const T Pddot10_3 = E10_22 * t10_7 - E10_23 * t10_6;
  // G10 = -U10 h_own_10: applied less inertia force, body axes [N]
  const T minus_G10_1 = U10_13 * T(2.1575999999999998e-05) - U10_12 * T(0.081652909);
  const T minus_G10_2 = minus_U10_22 * T(0.081652909) + U10_23 * T(2.1575999999999998e-05);
  const T G10_3 = U10_23 * T(0.081652909) + minus_U10_33 * T(2.1575999999999998e-05);
  // N10 = -h_own_10~ Pddot10 - axial(U10 (tr(J_own_10)/2 - J_own_10)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N10_1 = T(0.0065993575488296615) * U10_23 - T(4.7970076e-07) * (minus_U10_22 - minus_U10_33) +
      T(7.94567044e-06) * U10_31 + T(2.70561864e-07) * U10_21 - T(2.1575999999999998e-05) * Pddot10_2 - T(0.081652909)
      * Pddot10_3;
  const T minus_N10_2 = T(2.1575999999999998e-05) * Pddot10_1 + T(0.000361904168856) * U10_13 + T(0.000361904168856) *
      U10_31 - T(2.70561864e-07) * (minus_U10_33 - minus_U10_11) - T(4.7970076e-07) * U10_12 - T(7.94567044e-06) *
      U10_23;
  const T minus_N10_3 = T(0.081652909) * Pddot10_1 - T(0.000361904168856) * U10_21 - T(0.006961261717685661) * U10_12
      + T(7.94567044e-06) * (minus_U10_11 - minus_U10_22) - T(2.70561864e-07) * U10_23 + T(4.7970076e-07) * U10_13;

  // ---- body 11 (rr_thigh) on body 10
  const T theta11 = x[11];
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R1_11 * E11_11 - R10_31 * minus_E11_13;
  const T R11_12 = R1_12 * E11_11 - R10_32 * minus_E11_13;
  const T R11_13 = R1_13 * E11_11 - R10_33 * minus_E11_13;
  const T R11_31 = R1_11 * minus_E11_13 + R10_31 * E11_11;
  const T R11_32 = R1_12 * minus_E11_13 + R10_32 * E11_11;
  const T R11_33 = R1_13 * minus_E11_13 + R10_33 * E11_11;
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 - minus_E11_13 * omega10_3;
  const T omega11_2 = thetadot11 + omega10_2;
  const T omega11_3 = minus_E11_13 * omega10_1 + E11_11 * omega10_3;
  // stretch_rr_thigh_11 = theta11 - l_rr_thigh_: stretch of the spring
  const T stretch_rr_thigh_11 = theta11 - T(0.8);
  // effort_rr_thigh_11 = -thetadot11 c_rr_thigh_ + tau_rr_thigh_ - stretch_rr_thigh_11 k_rr_thigh_: along the
  //   coordinate [N m], [N]
  const T effort_rr_thigh_11 = u.tau_rr_thigh - thetadot11 * c.p.kd - stretch_rr_thigh_11 * c.p.kp;
  // omegadot11 = -thetadot11 b11~ E11 omega10 + E11 omegadot10: angular acceleration, body axes [rad/s^2]
  const T omegadot11_1 = minus_E11_13 * minus_omegadot10_3 - thetadot11 * omega11_3;
  const T omegadot11_3 = thetadot11 * omega11_1 - E11_11 * minus_omegadot10_3;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_1 = omega11_3 * omega11_3;
  const T t11_2 = omega11_2 * omega11_2;
  const T minus_U11_11 = t11_1 + t11_2;
  const T t11_3 = omega11_2 * omega11_1;
  const T U11_12 = t11_3 - omegadot11_3;
  const T t11_4 = omega11_3 * omega11_1;
  const T U11_13 = t11_4 + omegadot10_2;
  const T U11_21 = t11_3 + omegadot11_3;
  const T t11_5 = omega11_1 * omega11_1;
  const T minus_U11_22 = t11_1 + t11_5;
  const T t11_6 = omega11_3 * omega11_2;
  const T U11_23 = t11_6 - omegadot11_1;
  const T U11_31 = t11_4 - omegadot10_2;
  const T U11_32 = t11_6 + omegadot11_1;
  const T minus_U11_33 = t11_2 + t11_5;
  // Pddot11 = E11 (U10 q11 + Pddot10): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t11_7 = Pddot10_1 - U10_12 * T(0.0838);
  const T t11_8 = Pddot10_3 - U10_23 * T(0.0838);
  const T Pddot11_1 = E11_11 * t11_7 - minus_E11_13 * t11_8;
  const T Pddot11_2 = Pddot10_2 + minus_U10_22 * T(0.0838);
  const T Pddot11_3 = minus_E11_13 * t11_7 + E11_11 * t11_8;
  // G11 = -U11 h_own_11: applied less inertia force, body axes [N]
  const T minus_G11_1 = minus_U11_11 * T(0.0032790809999999997) - U11_13 * T(0.072881238);
  const T G11_2 = U11_21 * T(0.0032790809999999997) + U11_23 * T(0.072881238);
  const T minus_G11_3 = minus_U11_33 * T(0.072881238) - U11_31 * T(0.0032790809999999997);
  // N11 = -h_own_11~ Pddot11 - axial(U11 (tr(J_own_11)/2 - J_own_11)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N11_1 = T(0.072881238) * Pddot11_2 - T(0.000499645385197) * U11_32 - T(0.014446725509588) * U11_23 -
      T(0.0005955910008259999) * (minus_U11_22 - minus_U11_33) - T(6.838704148699999e-05) * U11_31 +
      T(0.000254264832594) * U11_21;
  const T minus_N11_2 = T(0.0032790809999999997) * Pddot11_3 - T(0.072881238) * Pddot11_1 + T(0.014446725509588) *
      U11_13 - T(0.000499645385197) * U11_31 - T(0.000254264832594) * (minus_U11_33 - minus_U11_11) -
      T(0.0005955910008259999) * U11_12 + T(6.838704148699999e-05) * U11_32;
  const T minus_N11_3 = T(0.000499645385197) * U11_21 + T(0.000499645385197) * U11_12 - T(6.838704148699999e-05) *
      (minus_U11_11 - minus_U11_22) - T(0.000254264832594) * U11_23 + T(0.0005955910008259999) * U11_13 -
      T(0.0032790809999999997) * Pddot11_2;

  // ---- body 12 (rr_calf) on body 11
  const T theta12 = x[12];
  const T thetadot12 = y[11];
  // E12^T = Z12^T Rot(b12, theta12): E takes components in the lower body to those in the body
  const T t12_1 = cosines[12];
  const T t12_2 = sines[12];
  const T minus_E12_11 = T(0.9993592865650762) * t12_1 + T(0.035791288830411085) * t12_2;
  const T minus_E12_13 = T(0.035791288830411085) * t12_1 - T(0.9993592865650762) * t12_2;
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T minus_R12_11 = R11_11 * minus_E12_11 + R11_31 * minus_E12_13;
  const T minus_R12_12 = R11_12 * minus_E12_11 + R11_32 * minus_E12_13;
  const T minus_R12_13 = R11_13 * minus_E12_11 + R11_33 * minus_E12_13;
  const T R12_31 = R11_11 * minus_E12_13 - R11_31 * minus_E12_11;
  const T R12_32 = R11_12 * minus_E12_13 - R11_32 * minus_E12_11;
  const T R12_33 = R11_13 * minus_E12_13 - R11_33 * minus_E12_11;
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T minus_omega12_1 = minus_E12_11 * omega11_1 + minus_E12_13 * omega11_3;
  const T omega12_2 = thetadot12 + omega11_2;
  const T omega12_3 = minus_E12_13 * omega11_1 - minus_E12_11 * omega11_3;
  // stretch_rr_calf_12 = theta12 - l_rr_calf_: stretch of the spring
  const T stretch_rr_calf_12 = theta12 + T(1.6);
  // effort_rr_calf_12 = -thetadot12 c_rr_calf_ + tau_rr_calf_ - stretch_rr_calf_12 k_rr_calf_: along the coordinate
  //   [N m], [N]
  const T effort_rr_calf_12 = u.tau_rr_calf - thetadot12 * c.p.kd - stretch_rr_calf_12 * c.p.kp;
  // omegadot12 = -thetadot12 b12~ E12 omega11 + E12 omegadot11: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot12_1 = thetadot12 * omega12_3 + minus_E12_11 * omegadot11_1 + minus_E12_13 * omegadot11_3;
  const T omegadot12_3 = minus_E12_13 * omegadot11_1 - minus_E12_11 * omegadot11_3 - thetadot12 * minus_omega12_1;
  // U12 = omega12~ omega12~ + omegadot12~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t12_3 = omega12_2 * omega12_2;
  const T minus_U12_11 = omega12_3 * omega12_3 + t12_3;
  const T t12_4 = omega12_2 * minus_omega12_1;
  const T minus_U12_12 = t12_4 + omegadot12_3;
  const T t12_5 = omega12_3 * minus_omega12_1;
  const T U12_13 = omegadot10_2 - t12_5;
  const T U12_21 = omegadot12_3 - t12_4;
  const T t12_6 = omega12_3 * omega12_2;
  const T U12_23 = t12_6 + minus_omegadot12_1;
  const T minus_U12_31 = t12_5 + omegadot10_2;
  const T U12_32 = t12_6 - minus_omegadot12_1;
  const T minus_U12_33 = t12_3 + minus_omega12_1 * minus_omega12_1;
  // Pddot12 = E12 (U11 q12 + Pddot11): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot12_1 = minus_E12_11 * (Pddot11_1 - U11_13 * T(0.2)) + minus_E12_13 * (Pddot11_3 + minus_U11_33 *
      T(0.2));
  const T Pddot12_2 = Pddot11_2 - U11_23 * T(0.2);
  // G12 = R12 F_ground_on_rr_ - U12 h_own_12: applied less inertia force, body axes [N]
  const T t12_7 = minus_R12_11 * u.ground_rr_x + minus_R12_12 * u.ground_rr_y + minus_R12_13 * u.ground_rr_z;
  const T minus_G12_1 = t12_7 + U12_13 * T(0.029845530432320418);
  const T t12_8 = R10_21 * u.ground_rr_x + R10_22 * u.ground_rr_y + R10_23 * u.ground_rr_z;
  const T G12_2 = t12_8 - U12_23 * T(0.029845530432320418);
  const T t12_9 = R12_31 * u.ground_rr_x + R12_32 * u.ground_rr_y + R12_33 * u.ground_rr_z;
  const T G12_3 = t12_9 + minus_U12_33 * T(0.029845530432320418);
  // N12 = o12~ R12 F_ground_on_rr_ - h_own_12~ Pddot12 - axial(U12 (tr(J_own_12)/2 - J_own_12)): applied less inertia
  //   moment about the body origin, body axes [N m]
  const T N12_1 = T(0.029845530432320418) * Pddot12_2 - T(0.19987185731301527) * t12_8 + T(4.712093241166159e-05) *
      U12_32 + T(0.007297717301242339) * U12_23 + T(0.0002865260721362275) * U12_21;
  const T N12_2 = T(0.029845530432320418) * minus_Pddot12_1 - (T(0.19987185731301527) * t12_7 +
      T(0.007158257766082217) * t12_9) - T(0.007297717301242339) * U12_13 - T(4.712093241166159e-05) * minus_U12_31 -
      T(0.0002865260721362275) * (minus_U12_33 - minus_U12_11);
  const T N12_3 = T(4.712093241166159e-05) * minus_U12_12 - T(4.712093241166159e-05) * U12_21 -
      T(0.0002865260721362275) * U12_23 + T(0.007158257766082217) * t12_8;

  // ---- body 14 (rl_hip) on body 1
  const T theta14 = x[13];
  const T thetadot14 = y[12];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];
  // R14^T = R1^T E14^T: R takes inertial components to body components
  const T R14_21 = R1_21 * E14_22 + R1_31 * E14_23;
  const T R14_22 = R1_22 * E14_22 + R1_32 * E14_23;
  const T R14_23 = R1_23 * E14_22 + R1_33 * E14_23;
  const T R14_31 = R1_31 * E14_22 - R1_21 * E14_23;
  const T R14_32 = R1_32 * E14_22 - R1_22 * E14_23;
  const T R14_33 = R1_33 * E14_22 - R1_23 * E14_23;
  // omega14 = thetadot14 b14 + E14 omega1: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = thetadot14 + omega1_1;
  const T omega14_2 = E14_22 * omega1_2 + E14_23 * omega1_3;
  const T omega14_3 = E14_22 * omega1_3 - E14_23 * omega1_2;
  // effort_rl_hip_14 = -theta14 k_rl_hip_ - thetadot14 c_rl_hip_ + tau_rl_hip_: along the coordinate [N m], [N]
  const T effort_rl_hip_14 = u.tau_rl_hip - theta14 * c.p.kp - thetadot14 * c.p.kd;
  // omegadot14 = -thetadot14 b14~ E14 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot14_2 = thetadot14 * omega14_3;
  const T minus_omegadot14_3 = thetadot14 * omega14_2;
  // U14 = omega14~ omega14~ + omegadot14~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t14_1 = omega14_3 * omega14_3;
  const T t14_2 = omega14_2 * omega14_2;
  const T minus_U14_11 = t14_1 + t14_2;
  const T t14_3 = omega14_2 * omega14_1;
  const T U14_12 = t14_3 + minus_omegadot14_3;
  const T t14_4 = omega14_3 * omega14_1;
  const T U14_13 = t14_4 + omegadot14_2;
  const T U14_21 = t14_3 - minus_omegadot14_3;
  const T t14_5 = omega14_1 * omega14_1;
  const T minus_U14_22 = t14_1 + t14_5;
  const T U14_23 = omega14_3 * omega14_2;
  const T U14_31 = t14_4 - omegadot14_2;
  const T minus_U14_33 = t14_2 + t14_5;
  // Pddot14 = E14 (U1 q14 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot14_1 = t2_8 + Pddot1_1;
  const T t14_6 = Pddot1_2 - t2_11;
  const T t14_7 = t2_15 + Pddot1_3;
  const T Pddot14_2 = E14_22 * t14_6 + E14_23 * t14_7;
  const T Pddot14_3 = E14_22 * t14_7 - E14_23 * t14_6;
  // G14 = -U14 h_own_14: applied less inertia force, body axes [N]
  const T minus_G14_1 = U14_12 * T(0.081652909) + U14_13 * T(2.1575999999999998e-05);
  const T minus_G14_2 = U14_23 * T(2.1575999999999998e-05) - minus_U14_22 * T(0.081652909);
  const T minus_G14_3 = U14_23 * T(0.081652909) - minus_U14_33 * T(2.1575999999999998e-05);
  // N14 = -h_own_14~ Pddot14 - axial(U14 (tr(J_own_14)/2 - J_own_14)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N14_1 = T(0.081652909) * Pddot14_3 - T(2.1575999999999998e-05) * Pddot14_2 + T(0.0065993575488296615)
      * U14_23 + T(4.7970076e-07) * (minus_U14_22 - minus_U14_33) - T(7.94567044e-06) * U14_31 + T(2.70561864e-07) *
      U14_21;
  const T minus_N14_2 = T(2.1575999999999998e-05) * Pddot14_1 + T(0.000361904168856) * U14_13 + T(0.000361904168856) *
      U14_31 - T(2.70561864e-07) * (minus_U14_33 - minus_U14_11) + T(4.7970076e-07) * U14_12 + T(7.94567044e-06) *
      U14_23;
  const T N14_3 = T(0.081652909) * Pddot14_1 + T(0.000361904168856) * U14_21 + T(0.006961261717685661) * U14_12 +
      T(7.94567044e-06) * (minus_U14_11 - minus_U14_22) + T(2.70561864e-07) * U14_23 + T(4.7970076e-07) * U14_13;

  // ---- body 15 (rl_thigh) on body 14
  const T theta15 = x[14];
  const T thetadot15 = y[13];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_11 = R1_11 * E15_11 - R14_31 * minus_E15_13;
  const T R15_12 = R1_12 * E15_11 - R14_32 * minus_E15_13;
  const T R15_13 = R1_13 * E15_11 - R14_33 * minus_E15_13;
  const T R15_31 = R1_11 * minus_E15_13 + R14_31 * E15_11;
  const T R15_32 = R1_12 * minus_E15_13 + R14_32 * E15_11;
  const T R15_33 = R1_13 * minus_E15_13 + R14_33 * E15_11;
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = E15_11 * omega14_1 - minus_E15_13 * omega14_3;
  const T omega15_2 = thetadot15 + omega14_2;
  const T omega15_3 = minus_E15_13 * omega14_1 + E15_11 * omega14_3;
  // stretch_rl_thigh_15 = theta15 - l_rl_thigh_: stretch of the spring
  const T stretch_rl_thigh_15 = theta15 - T(0.8);
  // effort_rl_thigh_15 = -thetadot15 c_rl_thigh_ + tau_rl_thigh_ - stretch_rl_thigh_15 k_rl_thigh_: along the
  //   coordinate [N m], [N]
  const T effort_rl_thigh_15 = u.tau_rl_thigh - thetadot15 * c.p.kd - stretch_rl_thigh_15 * c.p.kp;
  // omegadot15 = -thetadot15 b15~ E15 omega14 + E15 omegadot14: angular acceleration, body axes [rad/s^2]
  const T omegadot15_1 = minus_E15_13 * minus_omegadot14_3 - thetadot15 * omega15_3;
  const T omegadot15_3 = thetadot15 * omega15_1 - E15_11 * minus_omegadot14_3;
  // U15 = omega15~ omega15~ + omegadot15~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t15_1 = omega15_3 * omega15_3;
  const T t15_2 = omega15_2 * omega15_2;
  const T minus_U15_11 = t15_1 + t15_2;
  const T t15_3 = omega15_2 * omega15_1;
  const T U15_12 = t15_3 - omegadot15_3;
  const T t15_4 = omega15_3 * omega15_1;
  const T U15_13 = t15_4 + omegadot14_2;
  const T U15_21 = t15_3 + omegadot15_3;
  const T t15_5 = omega15_1 * omega15_1;
  const T minus_U15_22 = t15_1 + t15_5;
  const T t15_6 = omega15_3 * omega15_2;
  const T U15_23 = t15_6 - omegadot15_1;
  const T U15_31 = t15_4 - omegadot14_2;
  const T U15_32 = t15_6 + omegadot15_1;
  const T minus_U15_33 = t15_2 + t15_5;
  // Pddot15 = E15 (U14 q15 + Pddot14): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t15_7 = Pddot14_1 + U14_12 * T(0.0838);
  const T t15_8 = Pddot14_3 + U14_23 * T(0.0838);
  const T Pddot15_1 = E15_11 * t15_7 - minus_E15_13 * t15_8;
  const T Pddot15_2 = Pddot14_2 - minus_U14_22 * T(0.0838);
  const T Pddot15_3 = minus_E15_13 * t15_7 + E15_11 * t15_8;
  // G15 = -U15 h_own_15: applied less inertia force, body axes [N]
  const T minus_G15_1 = minus_U15_11 * T(0.0032790809999999997) - U15_13 * T(0.072881238);
  const T G15_2 = U15_21 * T(0.0032790809999999997) + U15_23 * T(0.072881238);
  const T minus_G15_3 = minus_U15_33 * T(0.072881238) - U15_31 * T(0.0032790809999999997);
  // N15 = -h_own_15~ Pddot15 - axial(U15 (tr(J_own_15)/2 - J_own_15)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T minus_N15_1 = T(0.072881238) * Pddot15_2 - T(0.000499645385197) * U15_32 - T(0.014446725509588) * U15_23 +
      T(0.0005955910008259999) * (minus_U15_22 - minus_U15_33) + T(6.838704148699999e-05) * U15_31 +
      T(0.000254264832594) * U15_21;
  const T minus_N15_2 = T(0.0032790809999999997) * Pddot15_3 - T(0.072881238) * Pddot15_1 + T(0.014446725509588) *
      U15_13 - T(0.000499645385197) * U15_31 - T(0.000254264832594) * (minus_U15_33 - minus_U15_11) +
      T(0.0005955910008259999) * U15_12 - T(6.838704148699999e-05) * U15_32;
  const T minus_N15_3 = T(0.000499645385197) * U15_21 + T(0.000499645385197) * U15_12 + T(6.838704148699999e-05) *
      (minus_U15_11 - minus_U15_22) - T(0.000254264832594) * U15_23 - T(0.0005955910008259999) * U15_13 -
      T(0.0032790809999999997) * Pddot15_2;

  // ---- body 16 (rl_calf) on body 15
  const T theta16 = x[15];
  const T thetadot16 = y[14];
  // E16^T = Z16^T Rot(b16, theta16): E takes components in the lower body to those in the body
  const T t16_1 = cosines[15];
  const T t16_2 = sines[15];
  const T minus_E16_11 = T(0.9993592865650762) * t16_1 + T(0.035791288830411085) * t16_2;
  const T minus_E16_13 = T(0.035791288830411085) * t16_1 - T(0.9993592865650762) * t16_2;
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T minus_R16_11 = R15_11 * minus_E16_11 + R15_31 * minus_E16_13;
  const T minus_R16_12 = R15_12 * minus_E16_11 + R15_32 * minus_E16_13;
  const T minus_R16_13 = R15_13 * minus_E16_11 + R15_33 * minus_E16_13;
  const T R16_31 = R15_11 * minus_E16_13 - R15_31 * minus_E16_11;
  const T R16_32 = R15_12 * minus_E16_13 - R15_32 * minus_E16_11;
  const T R16_33 = R15_13 * minus_E16_13 - R15_33 * minus_E16_11;
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T minus_omega16_1 = minus_E16_11 * omega15_1 + minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 - minus_E16_11 * omega15_3;
  // stretch_rl_calf_16 = theta16 - l_rl_calf_: stretch of the spring
  const T stretch_rl_calf_16 = theta16 + T(1.6);
  // effort_rl_calf_16 = -thetadot16 c_rl_calf_ + tau_rl_calf_ - stretch_rl_calf_16 k_rl_calf_: along the coordinate
  //   [N m], [N]
  const T effort_rl_calf_16 = u.tau_rl_calf - thetadot16 * c.p.kd - stretch_rl_calf_16 * c.p.kp;
  // omegadot16 = -thetadot16 b16~ E16 omega15 + E16 omegadot15: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot16_1 = thetadot16 * omega16_3 + minus_E16_11 * omegadot15_1 + minus_E16_13 * omegadot15_3;
  const T omegadot16_3 = minus_E16_13 * omegadot15_1 - minus_E16_11 * omegadot15_3 - thetadot16 * minus_omega16_1;
  // U16 = omega16~ omega16~ + omegadot16~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t16_3 = omega16_2 * omega16_2;
  const T minus_U16_11 = omega16_3 * omega16_3 + t16_3;
  const T t16_4 = omega16_2 * minus_omega16_1;
  const T minus_U16_12 = t16_4 + omegadot16_3;
  const T t16_5 = omega16_3 * minus_omega16_1;
  const T U16_13 = omegadot14_2 - t16_5;
  const T U16_21 = omegadot16_3 - t16_4;
  const T t16_6 = omega16_3 * omega16_2;
  const T U16_23 = t16_6 + minus_omegadot16_1;
  const T minus_U16_31 = t16_5 + omegadot14_2;
  const T U16_32 = t16_6 - minus_omegadot16_1;
  const T minus_U16_33 = t16_3 + minus_omega16_1 * minus_omega16_1;
  // Pddot16 = E16 (U15 q16 + Pddot15): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot16_1 = minus_E16_11 * (Pddot15_1 - U15_13 * T(0.2)) + minus_E16_13 * (Pddot15_3 + minus_U15_33 *
      T(0.2));
  const T Pddot16_2 = Pddot15_2 - U15_23 * T(0.2);
  // G16 = R16 F_ground_on_rl_ - U16 h_own_16: applied less inertia force, body axes [N]
  const T t16_7 = minus_R16_11 * u.ground_rl_x + minus_R16_12 * u.ground_rl_y + minus_R16_13 * u.ground_rl_z;
  const T minus_G16_1 = t16_7 + U16_13 * T(0.029845530432320418);
  const T t16_8 = R14_21 * u.ground_rl_x + R14_22 * u.ground_rl_y + R14_23 * u.ground_rl_z;
  const T G16_2 = t16_8 - U16_23 * T(0.029845530432320418);
  const T t16_9 = R16_31 * u.ground_rl_x + R16_32 * u.ground_rl_y + R16_33 * u.ground_rl_z;
  const T G16_3 = t16_9 + minus_U16_33 * T(0.029845530432320418);
  // N16 = o16~ R16 F_ground_on_rl_ - h_own_16~ Pddot16 - axial(U16 (tr(J_own_16)/2 - J_own_16)): applied less inertia
  //   moment about the body origin, body axes [N m]
  const T N16_1 = T(0.029845530432320418) * Pddot16_2 - T(0.19987185731301527) * t16_8 + T(4.712093241166159e-05) *
      U16_32 + T(0.007297717301242339) * U16_23 + T(0.0002865260721362275) * U16_21;
  const T N16_2 = T(0.029845530432320418) * minus_Pddot16_1 - (T(0.19987185731301527) * t16_7 +
      T(0.007158257766082217) * t16_9) - T(0.007297717301242339) * U16_13 - T(4.712093241166159e-05) * minus_U16_31 -
      T(0.0002865260721362275) * (minus_U16_33 - minus_U16_11);
  const T N16_3 = T(4.712093241166159e-05) * minus_U16_12 - T(4.712093241166159e-05) * U16_21 -
      T(0.0002865260721362275) * U16_23 + T(0.007158257766082217) * t16_8;

  // ---- body 16 (rl_calf) and what it carries
  // f_theta16 = b16 . N16 + effort_rl_calf_16: Kane's equation of the angle [N m]
  const T f_theta16 = N16_2 + effort_rl_calf_16;
  f[14] = f_theta16;

  // ---- body 15 (rl_thigh) and what it carries
  // S15 = E16^T G16 + G15: sum of the force balances of the subtree, body axes [N]
  const T b15_1 = minus_E16_11 * minus_G16_1 + minus_E16_13 * G16_3;
  const T S15_1 = b15_1 - minus_G15_1;
  const T S15_2 = G16_2 + G15_2;
  const T S15_3 = minus_E16_13 * minus_G16_1 - minus_G15_3 - minus_E16_11 * G16_3;
  // rho15 = q16~ E16^T G16 + E16^T N16 + N15: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho15_1 = T(0.2) * G16_2 - minus_N15_1 + minus_E16_13 * N16_3 - minus_E16_11 * N16_1;
  const T rho15_2 = N16_2 - minus_N15_2 - T(0.2) * b15_1;
  const T minus_rho15_3 = minus_N15_3 + minus_E16_13 * N16_1 + minus_E16_11 * N16_3;
  // f_theta15 = b15 . rho15 + effort_rl_thigh_15: Kane's equation of the angle [N m]
  const T f_theta15 = rho15_2 + effort_rl_thigh_15;
  f[13] = f_theta15;

  // ---- body 14 (rl_hip) and what it carries
  // S14 = E15^T S15 + G14: sum of the force balances of the subtree, body axes [N]
  const T b14_1 = E15_11 * S15_1 + minus_E15_13 * S15_3;
  const T S14_1 = b14_1 - minus_G14_1;
  const T S14_2 = S15_2 - minus_G14_2;
  const T b14_2 = E15_11 * S15_3 - minus_E15_13 * S15_1;
  const T S14_3 = b14_2 - minus_G14_3;
  // rho14 = q15~ E15^T S15 + E15^T rho15 + N14: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho14_1 = T(0.0838) * b14_2 - minus_N14_1 + E15_11 * rho15_1 - minus_E15_13 * minus_rho15_3;
  const T rho14_2 = rho15_2 - minus_N14_2;
  const T rho14_3 = N14_3 - T(0.0838) * b14_1 - minus_E15_13 * rho15_1 - E15_11 * minus_rho15_3;
  // f_theta14 = b14 . rho14 + effort_rl_hip_14: Kane's equation of the angle [N m]
  const T f_theta14 = rho14_1 + effort_rl_hip_14;
  f[12] = f_theta14;

  // ---- body 12 (rr_calf) and what it carries
  // f_theta12 = b12 . N12 + effort_rr_calf_12: Kane's equation of the angle [N m]
  const T f_theta12 = N12_2 + effort_rr_calf_12;
  f[11] = f_theta12;

  // ---- body 11 (rr_thigh) and what it carries
  // S11 = E12^T G12 + G11: sum of the force balances of the subtree, body axes [N]
  const T b11_1 = minus_E12_11 * minus_G12_1 + minus_E12_13 * G12_3;
  const T S11_1 = b11_1 - minus_G11_1;
  const T S11_2 = G12_2 + G11_2;
  const T S11_3 = minus_E12_13 * minus_G12_1 - minus_G11_3 - minus_E12_11 * G12_3;
  // rho11 = q12~ E12^T G12 + E12^T N12 + N11: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho11_1 = T(0.2) * G12_2 - minus_N11_1 + minus_E12_13 * N12_3 - minus_E12_11 * N12_1;
  const T rho11_2 = N12_2 - minus_N11_2 - T(0.2) * b11_1;
  const T minus_rho11_3 = minus_N11_3 + minus_E12_13 * N12_1 + minus_E12_11 * N12_3;
  // f_theta11 = b11 . rho11 + effort_rr_thigh_11: Kane's equation of the angle [N m]
  const T f_theta11 = rho11_2 + effort_rr_thigh_11;
  f[10] = f_theta11;

  // ---- body 10 (rr_hip) and what it carries
  // S10 = E11^T S11 + G10: sum of the force balances of the subtree, body axes [N]
  const T b10_1 = E11_11 * S11_1 + minus_E11_13 * S11_3;
  const T S10_1 = b10_1 - minus_G10_1;
  const T S10_2 = S11_2 - minus_G10_2;
  const T b10_2 = E11_11 * S11_3 - minus_E11_13 * S11_1;
  const T S10_3 = b10_2 + G10_3;
  // rho10 = q11~ E11^T S11 + E11^T rho11 + N10: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho10_1 = E11_11 * rho11_1 - minus_N10_1 - minus_E11_13 * minus_rho11_3 - T(0.0838) * b10_2;
  const T rho10_2 = rho11_2 - minus_N10_2;
  const T rho10_3 = T(0.0838) * b10_1 - (minus_N10_3 + minus_E11_13 * rho11_1 + E11_11 * minus_rho11_3);
  // f_theta10 = b10 . rho10 + effort_rr_hip_10: Kane's equation of the angle [N m]
  const T f_theta10 = rho10_1 + effort_rr_hip_10;
  f[9] = f_theta10;

  // ---- body 8 (fl_calf) and what it carries
  // f_theta8 = b8 . N8 + effort_fl_calf_8: Kane's equation of the angle [N m]
  const T f_theta8 = N8_2 + effort_fl_calf_8;
  f[8] = f_theta8;

  // ---- body 7 (fl_thigh) and what it carries
  // S7 = E8^T G8 + G7: sum of the force balances of the subtree, body axes [N]
  const T b7_1 = minus_E8_11 * minus_G8_1 + minus_E8_13 * G8_3;
  const T S7_1 = b7_1 - minus_G7_1;
  const T S7_2 = G8_2 + G7_2;
  const T S7_3 = minus_E8_13 * minus_G8_1 - minus_G7_3 - minus_E8_11 * G8_3;
  // rho7 = q8~ E8^T G8 + E8^T N8 + N7: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho7_1 = T(0.2) * G8_2 - minus_N7_1 + minus_E8_13 * N8_3 - minus_E8_11 * N8_1;
  const T rho7_2 = N8_2 - minus_N7_2 - T(0.2) * b7_1;
  const T minus_rho7_3 = minus_N7_3 + minus_E8_13 * N8_1 + minus_E8_11 * N8_3;
  // f_theta7 = b7 . rho7 + effort_fl_thigh_7: Kane's equation of the angle [N m]
  const T f_theta7 = rho7_2 + effort_fl_thigh_7;
  f[7] = f_theta7;

  // ---- body 6 (fl_hip) and what it carries
  // S6 = E7^T S7 + G6: sum of the force balances of the subtree, body axes [N]
  const T b6_1 = E7_11 * S7_1 + minus_E7_13 * S7_3;
  const T S6_1 = b6_1 - minus_G6_1;
  const T S6_2 = S7_2 - minus_G6_2;
  const T b6_2 = E7_11 * S7_3 - minus_E7_13 * S7_1;
  const T S6_3 = b6_2 - minus_G6_3;
  // rho6 = q7~ E7^T S7 + E7^T rho7 + N6: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho6_1 = T(0.0838) * b6_2 - minus_N6_1 + E7_11 * rho7_1 - minus_E7_13 * minus_rho7_3;
  const T rho6_2 = rho7_2 - minus_N6_2;
  const T minus_rho6_3 = minus_N6_3 + T(0.0838) * b6_1 + minus_E7_13 * rho7_1 + E7_11 * minus_rho7_3;
  // f_theta6 = b6 . rho6 + effort_fl_hip_6: Kane's equation of the angle [N m]
  const T f_theta6 = rho6_1 + effort_fl_hip_6;
  f[6] = f_theta6;

  // ---- body 4 (fr_calf) and what it carries
  // f_theta4 = b4 . N4 + effort_fr_calf_4: Kane's equation of the angle [N m]
  const T f_theta4 = N4_2 + effort_fr_calf_4;
  f[5] = f_theta4;

  // ---- body 3 (fr_thigh) and what it carries
  // S3 = E4^T G4 + G3: sum of the force balances of the subtree, body axes [N]
  const T b3_1 = minus_E4_11 * minus_G4_1 + minus_E4_13 * G4_3;
  const T S3_1 = b3_1 - minus_G3_1;
  const T S3_2 = G4_2 + G3_2;
  const T S3_3 = minus_E4_13 * minus_G4_1 - minus_G3_3 - minus_E4_11 * G4_3;
  // rho3 = q4~ E4^T G4 + E4^T N4 + N3: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho3_1 = T(0.2) * G4_2 - minus_N3_1 + minus_E4_13 * N4_3 - minus_E4_11 * N4_1;
  const T rho3_2 = N4_2 - minus_N3_2 - T(0.2) * b3_1;
  const T minus_rho3_3 = minus_N3_3 + minus_E4_13 * N4_1 + minus_E4_11 * N4_3;
  // f_theta3 = b3 . rho3 + effort_fr_thigh_3: Kane's equation of the angle [N m]
  const T f_theta3 = rho3_2 + effort_fr_thigh_3;
  f[4] = f_theta3;

  // ---- body 2 (fr_hip) and what it carries
  // S2 = E3^T S3 + G2: sum of the force balances of the subtree, body axes [N]
  const T b2_1 = E3_11 * S3_1 + minus_E3_13 * S3_3;
  const T S2_1 = b2_1 - minus_G2_1;
  const T S2_2 = S3_2 - minus_G2_2;
  const T b2_2 = E3_11 * S3_3 - minus_E3_13 * S3_1;
  const T S2_3 = b2_2 + G2_3;
  // rho2 = q3~ E3^T S3 + E3^T rho3 + N2: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho2_1 = E3_11 * rho3_1 - minus_N2_1 - minus_E3_13 * minus_rho3_3 - T(0.0838) * b2_2;
  const T rho2_2 = rho3_2 - minus_N2_2;
  const T rho2_3 = T(0.0838) * b2_1 - (minus_N2_3 + minus_E3_13 * rho3_1 + E3_11 * minus_rho3_3);
  // f_theta2 = b2 . rho2 + effort_fr_hip_2: Kane's equation of the angle [N m]
  const T f_theta2 = rho2_1 + effort_fr_hip_2;
  f[3] = f_theta2;

  // ---- body 1 (trunk) and what it carries
  // S1 = E2^T S2 + E6^T S6 + E10^T S10 + E14^T S14 + G1: sum of the force balances of the subtree, body axes [N]
  const T S1_1 = S2_1 + S6_1 + S10_1 + S14_1 - minus_G1_1;
  const T b1_1 = E2_22 * S2_2 - E2_23 * S2_3;
  const T b1_2 = E6_22 * S6_2 - E6_23 * S6_3;
  const T b1_3 = E10_22 * S10_2 - E10_23 * S10_3;
  const T b1_4 = E14_22 * S14_2 - E14_23 * S14_3;
  const T S1_2 = b1_1 + b1_2 + b1_3 + b1_4 - minus_G1_2;
  const T b1_5 = E2_23 * S2_2 + E2_22 * S2_3;
  const T b1_6 = E6_23 * S6_2 + E6_22 * S6_3;
  const T b1_7 = E10_23 * S10_2 + E10_22 * S10_3;
  const T b1_8 = E14_23 * S14_2 + E14_22 * S14_3;
  const T S1_3 = b1_5 + b1_6 + b1_7 + b1_8 - minus_G1_3;
  // f_omega1 = q2~ E2^T S2 + E2^T rho2 + q6~ E6^T S6 + E6^T rho6 + q10~ E10^T S10 + E10^T rho10 + q14~ E14^T S14 +
  //   E14^T rho14 + N1: Kane's equation of omega [N m]
  const T f_omega1_1 = rho2_1 + rho6_1 + rho10_1 + rho14_1 - minus_N1_1 - T(0.047) * b1_5 + T(0.047) * b1_6 - T(0.047)
      * b1_7 + T(0.047) * b1_8;
  const T f_omega1_2 = E2_22 * rho2_2 - minus_N1_2 - E2_23 * rho2_3 - T(0.1805) * b1_5 - T(0.1805) * b1_6 + E6_22 *
      rho6_2 + E6_23 * minus_rho6_3 + T(0.1805) * b1_7 + E10_22 * rho10_2 - E10_23 * rho10_3 + T(0.1805) * b1_8 +
      E14_22 * rho14_2 - E14_23 * rho14_3;
  const T f_omega1_3 = T(0.1805) * b1_1 - minus_N1_3 + T(0.047) * S2_1 + E2_23 * rho2_2 + E2_22 * rho2_3 + T(0.1805) *
      b1_2 - T(0.047) * S6_1 + E6_23 * rho6_2 - E6_22 * minus_rho6_3 + T(0.047) * S10_1 - T(0.1805) * b1_3 + E10_23 *
      rho10_2 + E10_22 * rho10_3 - T(0.1805) * b1_4 - T(0.047) * S14_1 + E14_23 * rho14_2 + E14_22 * rho14_3;
  f[0] = f_omega1_1;
  f[1] = f_omega1_2;
  f[2] = f_omega1_3;
  // f_sdot1 = R1^T S1: Kane's equation of sdot [N]
  const T f_sdot1_1 = R1_11 * S1_1 + R1_21 * S1_2 + R1_31 * S1_3;
  const T f_sdot1_2 = R1_12 * S1_1 + R1_22 * S1_2 + R1_32 * S1_3;
  const T f_sdot1_3 = R1_13 * S1_1 + R1_23 * S1_2 + R1_33 * S1_3;
  f[15] = f_sdot1_1;
  f[16] = f_sdot1_2;
  f[17] = f_sdot1_3;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 358 add, 422 multiply, 24 sine or cosine
template <class T>
void mass_matrix(const Prepared<T>& c, const T* x, T* A) noexcept {
  for (int i = 0; i < 324; ++i) A[i] = T(0);
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
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
  A[285] = c.m_all_1;
  A[304] = c.m_all_1;
  A[323] = c.m_all_1;

  // ---- body 2 (fr_hip) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_22 = cosines[4];
  const T E2_23 = sines[4];

  // ---- body 3 (fr_thigh) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];

  // ---- body 4 (fr_calf) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];

  // ---- body 6 (fl_hip) on body 1
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];

  // ---- body 7 (fl_thigh) on body 6
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];

  // ---- body 8 (fl_calf) on body 7
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[9];
  const T minus_E8_13 = sines[9];

  // ---- body 10 (rr_hip) on body 1
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];

  // ---- body 11 (rr_thigh) on body 10
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];

  // ---- body 12 (rr_calf) on body 11
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_11 = cosines[12];
  const T minus_E12_13 = sines[12];

  // ---- body 14 (rl_hip) on body 1
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];

  // ---- body 15 (rl_thigh) on body 14
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];

  // ---- body 16 (rl_calf) on body 15
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cosines[15];
  const T minus_E16_13 = sines[15];

  // ---- body 16 (rl_calf) and what it carries
  // hc16 = E16^T h_own_16: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc16_1 = minus_E16_13 * T(0.029826408000000002) - E16_11 * T(0.00106821);
  const T minus_hc16_3 = E16_11 * T(0.029826408000000002) + minus_E16_13 * T(0.00106821);

  // ---- body 15 (rl_thigh) and what it carries
  // h15 = h_own_15 + hc16: first moment of mass carried, about the body origin, body axes [kg m]
  const T minus_h15_1 = minus_hc16_1 + T(0.0032790809999999997);
  const T minus_h15_3 = T(0.072881238) + minus_hc16_3;
  // J15 = -q16~ hc16~ + E16^T J_own_16 E16 + J_own_15 - hc16~ q16~: inertia carried, about the body origin, body axes
  //   [kg m^2]
  const T b15_1 = minus_E16_13 * T(0.007273014370954) + T(2) * E16_11 * T(2.6450064520000005e-05);
  const T b15_2 = minus_E16_13 * b15_1;
  const T J15_11 = T(0.021220094495345) - b15_2 + T(0.4) * minus_hc16_3;
  const T b15_3 = minus_E16_13 * T(0.0024994529904) - E16_11 * T(8.9515998e-05);
  const T J15_12 = b15_3 + T(0.00020639994631299998);
  const T J15_13 = T(0.00028071489711400005) - E16_11 * b15_1 - T(0.2) * minus_hc16_1;
  const T b15_4 = T(0.2) * minus_hc16_3;
  const T b15_5 = b15_4 + T(0.007344838233654);
  const T J15_22 = b15_5 + T(0.014946370894785) + b15_4;
  const T b15_6 = minus_E16_13 * T(8.9515998e-05) + E16_11 * T(0.0024994529904);
  const T J15_23 = b15_6 + T(0.005511856743574);
  A[247] = J15_22;
  // hc15 = E15^T h15: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc15_1 = minus_E15_13 * minus_h15_3 + E15_11 * minus_h15_1;
  const T minus_hc15_3 = E15_11 * minus_h15_3 - minus_E15_13 * minus_h15_1;
  A[248] = b15_5;
  A[265] = b15_5;

  // ---- body 14 (rl_hip) and what it carries
  // h14 = h_own_14 + hc15: first moment of mass carried, about the body origin, body axes [kg m]
  const T h14_3 = T(2.1575999999999998e-05) - minus_hc15_3;
  // J14 = -q15~ hc15~ + E15^T J15 E15 + J_own_14 - hc15~ q15~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b14_1 = minus_E15_13 * (b15_2 - J15_11) + T(2) * E15_11 * J15_13;
  const T b14_2 = minus_E15_13 * b14_1;
  const T J14_11 = J15_11 + b14_2 + T(0.00731195688548);
  const T b14_3 = E15_11 * J15_12 + minus_E15_13 * J15_23;
  const T J14_12 = b14_3 + T(0.014746295744939998);
  const T J14_13 = T(4.165029864e-06) - J15_13 + E15_11 * b14_1 - T(0.1805) * minus_hc15_3;
  const T b14_4 = T(0.1805) * minus_hc15_1;
  const T b14_5 = b14_4 + J15_22;
  const T J14_22 = b14_5 + b14_4;
  const T b14_6 = E15_11 * J15_23 - minus_E15_13 * J15_12;
  const T J14_23 = b14_6 - T(4.7970076e-07);
  const T J14_33 = b15_2 - b14_2 + T(0.006588148547768) + T(0.361) * minus_hc15_1;
  A[228] = J14_11;
  // hc14 = E14^T h14: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc14_2 = E14_22 * T(0.081652909) - E14_23 * h14_3;
  const T hc14_3 = E14_22 * h14_3 + E14_23 * T(0.081652909);
  // B_thetadot16_14 = E15^T B_thetadot16_15
  const T B_thetadot16_14_1 = minus_E15_13 * minus_hc16_1 - E15_11 * minus_hc16_3;
  const T B_thetadot16_14_3 = minus_E15_13 * minus_hc16_3 + E15_11 * minus_hc16_1;
  // K_thetadot16_14 = q15~ E15^T B_thetadot16_15 + E15^T K_thetadot16_15
  const T K_thetadot16_14_1 = E15_11 * b15_3 + minus_E15_13 * b15_6;
  const T K_thetadot16_14_2 = b15_5 + T(0.1805) * B_thetadot16_14_3;
  const T K_thetadot16_14_3 = E15_11 * b15_6 - minus_E15_13 * b15_3;
  A[230] = K_thetadot16_14_1;
  A[264] = K_thetadot16_14_1;
  A[229] = b14_3;
  A[246] = b14_3;

  // ---- body 12 (rr_calf) and what it carries
  // hc12 = E12^T h_own_12: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc12_1 = minus_E12_13 * T(0.029826408000000002) - E12_11 * T(0.00106821);
  const T minus_hc12_3 = E12_11 * T(0.029826408000000002) + minus_E12_13 * T(0.00106821);

  // ---- body 11 (rr_thigh) and what it carries
  // h11 = h_own_11 + hc12: first moment of mass carried, about the body origin, body axes [kg m]
  const T minus_h11_1 = minus_hc12_1 + T(0.0032790809999999997);
  const T minus_h11_3 = T(0.072881238) + minus_hc12_3;
  // J11 = -q12~ hc12~ + E12^T J_own_12 E12 + J_own_11 - hc12~ q12~: inertia carried, about the body origin, body axes
  //   [kg m^2]
  const T b11_1 = minus_E12_13 * T(0.007273014370954) + T(2) * E12_11 * T(2.6450064520000005e-05);
  const T b11_2 = minus_E12_13 * b11_1;
  const T J11_11 = T(0.021220094495345) - b11_2 + T(0.4) * minus_hc12_3;
  const T b11_3 = E12_11 * T(8.9515998e-05) - minus_E12_13 * T(0.0024994529904);
  const T J11_12 = b11_3 - T(0.00020639994631299998);
  const T J11_13 = T(0.00028071489711400005) - E12_11 * b11_1 - T(0.2) * minus_hc12_1;
  const T b11_4 = T(0.2) * minus_hc12_3;
  const T b11_5 = b11_4 + T(0.007344838233654);
  const T J11_22 = b11_5 + T(0.014946370894785) + b11_4;
  const T b11_6 = minus_E12_13 * T(8.9515998e-05) + E12_11 * T(0.0024994529904);
  const T minus_J11_23 = b11_6 + T(0.005511856743574);
  A[190] = J11_22;
  // hc11 = E11^T h11: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc11_1 = minus_E11_13 * minus_h11_3 + E11_11 * minus_h11_1;
  const T minus_hc11_3 = E11_11 * minus_h11_3 - minus_E11_13 * minus_h11_1;
  A[191] = b11_5;
  A[208] = b11_5;

  // ---- body 10 (rr_hip) and what it carries
  // h10 = h_own_10 + hc11: first moment of mass carried, about the body origin, body axes [kg m]
  const T h10_3 = T(2.1575999999999998e-05) - minus_hc11_3;
  // J10 = -q11~ hc11~ + E11^T J11 E11 + J_own_10 - hc11~ q11~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b10_1 = minus_E11_13 * (b11_2 - J11_11) + T(2) * E11_11 * J11_13;
  const T b10_2 = minus_E11_13 * b10_1;
  const T J10_11 = J11_11 + b10_2 + T(0.00731195688548);
  const T b10_3 = E11_11 * J11_12 - minus_E11_13 * minus_J11_23;
  const T J10_12 = b10_3 - T(0.014746295744939998);
  const T J10_13 = T(4.165029864e-06) - J11_13 + E11_11 * b10_1 - T(0.1805) * minus_hc11_3;
  const T b10_4 = T(0.1805) * minus_hc11_1;
  const T b10_5 = b10_4 + J11_22;
  const T J10_22 = b10_5 + b10_4;
  const T b10_6 = minus_E11_13 * J11_12 + E11_11 * minus_J11_23;
  const T J10_23 = T(4.7970076e-07) - b10_6;
  const T J10_33 = b11_2 - b10_2 + T(0.006588148547768) + T(0.361) * minus_hc11_1;
  A[171] = J10_11;
  // hc10 = E10^T h10: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc10_2 = E10_23 * h10_3 + E10_22 * T(0.081652909);
  const T minus_hc10_3 = E10_23 * T(0.081652909) - E10_22 * h10_3;
  // B_thetadot12_10 = E11^T B_thetadot12_11
  const T B_thetadot12_10_1 = minus_E11_13 * minus_hc12_1 - E11_11 * minus_hc12_3;
  const T B_thetadot12_10_3 = minus_E11_13 * minus_hc12_3 + E11_11 * minus_hc12_1;
  // K_thetadot12_10 = q11~ E11^T B_thetadot12_11 + E11^T K_thetadot12_11
  const T K_thetadot12_10_1 = E11_11 * b11_3 - minus_E11_13 * b11_6;
  const T K_thetadot12_10_2 = b11_5 + T(0.1805) * B_thetadot12_10_3;
  const T minus_K_thetadot12_10_3 = minus_E11_13 * b11_3 + E11_11 * b11_6;
  A[173] = K_thetadot12_10_1;
  A[207] = K_thetadot12_10_1;
  A[172] = b10_3;
  A[189] = b10_3;

  // ---- body 8 (fl_calf) and what it carries
  // hc8 = E8^T h_own_8: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc8_1 = minus_E8_13 * T(0.029826408000000002) - E8_11 * T(0.00106821);
  const T minus_hc8_3 = E8_11 * T(0.029826408000000002) + minus_E8_13 * T(0.00106821);

  // ---- body 7 (fl_thigh) and what it carries
  // h7 = h_own_7 + hc8: first moment of mass carried, about the body origin, body axes [kg m]
  const T minus_h7_1 = minus_hc8_1 + T(0.0032790809999999997);
  const T minus_h7_3 = T(0.072881238) + minus_hc8_3;
  // J7 = -q8~ hc8~ + E8^T J_own_8 E8 + J_own_7 - hc8~ q8~: inertia carried, about the body origin, body axes [kg m^2]
  const T b7_1 = minus_E8_13 * T(0.007273014370954) + T(2) * E8_11 * T(2.6450064520000005e-05);
  const T b7_2 = minus_E8_13 * b7_1;
  const T J7_11 = T(0.021220094495345) - b7_2 + T(0.4) * minus_hc8_3;
  const T b7_3 = minus_E8_13 * T(0.0024994529904) - E8_11 * T(8.9515998e-05);
  const T J7_12 = b7_3 + T(0.00020639994631299998);
  const T J7_13 = T(0.00028071489711400005) - E8_11 * b7_1 - T(0.2) * minus_hc8_1;
  const T b7_4 = T(0.2) * minus_hc8_3;
  const T b7_5 = b7_4 + T(0.007344838233654);
  const T J7_22 = b7_5 + T(0.014946370894785) + b7_4;
  const T b7_6 = minus_E8_13 * T(8.9515998e-05) + E8_11 * T(0.0024994529904);
  const T J7_23 = b7_6 + T(0.005511856743574);
  A[133] = J7_22;
  // hc7 = E7^T h7: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc7_1 = minus_E7_13 * minus_h7_3 + E7_11 * minus_h7_1;
  const T minus_hc7_3 = E7_11 * minus_h7_3 - minus_E7_13 * minus_h7_1;
  A[134] = b7_5;
  A[151] = b7_5;

  // ---- body 6 (fl_hip) and what it carries
  // h6 = h_own_6 + hc7: first moment of mass carried, about the body origin, body axes [kg m]
  const T h6_3 = T(2.1575999999999998e-05) - minus_hc7_3;
  // J6 = -q7~ hc7~ + E7^T J7 E7 + J_own_6 - hc7~ q7~: inertia carried, about the body origin, body axes [kg m^2]
  const T b6_1 = minus_E7_13 * (b7_2 - J7_11) + T(2) * E7_11 * J7_13;
  const T b6_2 = minus_E7_13 * b6_1;
  const T J6_11 = J7_11 + b6_2 + T(0.00731195688548);
  const T b6_3 = E7_11 * J7_12 + minus_E7_13 * J7_23;
  const T J6_12 = b6_3 - T(0.014746295744939998);
  const T J6_13 = E7_11 * b6_1 - (J7_13 + T(4.165029864e-06)) + T(0.1805) * minus_hc7_3;
  const T b6_4 = T(0.1805) * minus_hc7_1;
  const T b6_5 = J7_22 - b6_4;
  const T J6_22 = b6_5 - b6_4;
  const T b6_6 = E7_11 * J7_23 - minus_E7_13 * J7_12;
  const T J6_23 = b6_6 - T(4.7970076e-07);
  const T J6_33 = b7_2 - b6_2 + T(0.006588148547768) - T(0.361) * minus_hc7_1;
  A[114] = J6_11;
  // hc6 = E6^T h6: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc6_2 = E6_22 * T(0.081652909) - E6_23 * h6_3;
  const T hc6_3 = E6_22 * h6_3 + E6_23 * T(0.081652909);
  // B_thetadot8_6 = E7^T B_thetadot8_7
  const T B_thetadot8_6_1 = minus_E7_13 * minus_hc8_1 - E7_11 * minus_hc8_3;
  const T B_thetadot8_6_3 = minus_E7_13 * minus_hc8_3 + E7_11 * minus_hc8_1;
  // K_thetadot8_6 = q7~ E7^T B_thetadot8_7 + E7^T K_thetadot8_7
  const T K_thetadot8_6_1 = E7_11 * b7_3 + minus_E7_13 * b7_6;
  const T K_thetadot8_6_2 = b7_5 - T(0.1805) * B_thetadot8_6_3;
  const T K_thetadot8_6_3 = E7_11 * b7_6 - minus_E7_13 * b7_3;
  A[116] = K_thetadot8_6_1;
  A[150] = K_thetadot8_6_1;
  A[115] = b6_3;
  A[132] = b6_3;

  // ---- body 4 (fr_calf) and what it carries
  // hc4 = E4^T h_own_4: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc4_1 = minus_E4_13 * T(0.029826408000000002) - E4_11 * T(0.00106821);
  const T minus_hc4_3 = E4_11 * T(0.029826408000000002) + minus_E4_13 * T(0.00106821);

  // ---- body 3 (fr_thigh) and what it carries
  // h3 = h_own_3 + hc4: first moment of mass carried, about the body origin, body axes [kg m]
  const T minus_h3_1 = minus_hc4_1 + T(0.0032790809999999997);
  const T minus_h3_3 = T(0.072881238) + minus_hc4_3;
  // J3 = -q4~ hc4~ + E4^T J_own_4 E4 + J_own_3 - hc4~ q4~: inertia carried, about the body origin, body axes [kg m^2]
  const T b3_1 = minus_E4_13 * T(0.007273014370954) + T(2) * E4_11 * T(2.6450064520000005e-05);
  const T b3_2 = minus_E4_13 * b3_1;
  const T J3_11 = T(0.021220094495345) - b3_2 + T(0.4) * minus_hc4_3;
  const T b3_3 = E4_11 * T(8.9515998e-05) - minus_E4_13 * T(0.0024994529904);
  const T J3_12 = b3_3 - T(0.00020639994631299998);
  const T J3_13 = T(0.00028071489711400005) - E4_11 * b3_1 - T(0.2) * minus_hc4_1;
  const T b3_4 = T(0.2) * minus_hc4_3;
  const T b3_5 = b3_4 + T(0.007344838233654);
  const T J3_22 = b3_5 + T(0.014946370894785) + b3_4;
  const T b3_6 = minus_E4_13 * T(8.9515998e-05) + E4_11 * T(0.0024994529904);
  const T minus_J3_23 = b3_6 + T(0.005511856743574);
  A[76] = J3_22;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc3_1 = minus_E3_13 * minus_h3_3 + E3_11 * minus_h3_1;
  const T minus_hc3_3 = E3_11 * minus_h3_3 - minus_E3_13 * minus_h3_1;
  A[77] = b3_5;
  A[94] = b3_5;

  // ---- body 2 (fr_hip) and what it carries
  // h2 = h_own_2 + hc3: first moment of mass carried, about the body origin, body axes [kg m]
  const T h2_3 = T(2.1575999999999998e-05) - minus_hc3_3;
  // J2 = -q3~ hc3~ + E3^T J3 E3 + J_own_2 - hc3~ q3~: inertia carried, about the body origin, body axes [kg m^2]
  const T b2_1 = minus_E3_13 * (b3_2 - J3_11) + T(2) * E3_11 * J3_13;
  const T b2_2 = minus_E3_13 * b2_1;
  const T J2_11 = J3_11 + b2_2 + T(0.00731195688548);
  const T b2_3 = E3_11 * J3_12 - minus_E3_13 * minus_J3_23;
  const T J2_12 = b2_3 + T(0.014746295744939998);
  const T J2_13 = E3_11 * b2_1 - (J3_13 + T(4.165029864e-06)) + T(0.1805) * minus_hc3_3;
  const T b2_4 = T(0.1805) * minus_hc3_1;
  const T b2_5 = J3_22 - b2_4;
  const T J2_22 = b2_5 - b2_4;
  const T b2_6 = minus_E3_13 * J3_12 + E3_11 * minus_J3_23;
  const T J2_23 = T(4.7970076e-07) - b2_6;
  const T J2_33 = b3_2 - b2_2 + T(0.006588148547768) - T(0.361) * minus_hc3_1;
  A[57] = J2_11;
  // hc2 = E2^T h2: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc2_2 = E2_23 * h2_3 + E2_22 * T(0.081652909);
  const T minus_hc2_3 = E2_23 * T(0.081652909) - E2_22 * h2_3;
  // B_thetadot4_2 = E3^T B_thetadot4_3
  const T B_thetadot4_2_1 = minus_E3_13 * minus_hc4_1 - E3_11 * minus_hc4_3;
  const T B_thetadot4_2_3 = minus_E3_13 * minus_hc4_3 + E3_11 * minus_hc4_1;
  // K_thetadot4_2 = q3~ E3^T B_thetadot4_3 + E3^T K_thetadot4_3
  const T K_thetadot4_2_1 = E3_11 * b3_3 - minus_E3_13 * b3_6;
  const T K_thetadot4_2_2 = b3_5 - T(0.1805) * B_thetadot4_2_3;
  const T minus_K_thetadot4_2_3 = minus_E3_13 * b3_3 + E3_11 * b3_6;
  A[59] = K_thetadot4_2_1;
  A[93] = K_thetadot4_2_1;
  A[58] = b2_3;
  A[75] = b2_3;

  // ---- body 1 (trunk) and what it carries
  // h1 = h_all_1 + hc2 + hc6 + hc10 + hc14: first moment of mass carried, about the body origin, body axes [kg m]
  const T minus_h1_1 = minus_hc3_1 + minus_hc7_1 + minus_hc11_1 + minus_hc15_1;
  const T h1_2 = c.h_all_1_2 - minus_hc2_2 + hc6_2 - minus_hc10_2 + hc14_2;
  const T h1_3 = hc6_3 - (minus_hc2_3 + c.c1_2) - minus_hc10_3 + hc14_3;
  // J1 = -q2~ hc2~ + E2^T J2 E2 - q6~ hc6~ + E6^T J6 E6 - q10~ hc10~ + E10^T J10 E10 - q14~ hc14~ + E14^T J14 E14 +
  //   J_all_1 - hc2~ q2~ - hc6~ q6~ - hc10~ q10~ - hc14~ q14~: inertia carried, about the body origin, body axes [kg
  //   m^2]
  const T b1_1 = T(0.047) * minus_hc2_2;
  const T b1_2 = b1_1 + J2_11;
  const T b1_3 = T(0.094) * hc14_2 + T(0.094) * hc6_2 + T(0.094) * minus_hc10_2;
  const T J1_11 = b1_2 + b1_3 + J6_11 + J10_11 + J14_11 + c.J_all_1_11 + b1_1;
  const T b1_4 = E2_22 * J2_12 - E2_23 * J2_13;
  const T b1_5 = E6_22 * J6_12 - E6_23 * J6_13;
  const T b1_6 = E10_22 * J10_12 - E10_23 * J10_13;
  const T b1_7 = E14_22 * J14_12 - E14_23 * J14_13;
  const T J1_12 = b1_4 + b1_5 + b1_6 + b1_7 - T(3.66e-05) - T(0.047) * minus_hc3_1 + T(0.047) * minus_hc7_1 - T(0.047)
      * minus_hc11_1 + T(0.047) * minus_hc15_1;
  const T b1_8 = E2_23 * J2_12 + E2_22 * J2_13;
  const T b1_9 = E6_23 * J6_12 + E6_22 * J6_13;
  const T b1_10 = E10_23 * J10_12 + E10_22 * J10_13;
  const T b1_11 = E14_23 * J14_12 + E14_22 * J14_13;
  const T J1_13 = b1_8 + b1_9 + b1_10 + b1_11 - T(6.11e-05);
  const T b1_12 = E2_23 * (J2_22 - J2_33) + T(2) * E2_22 * J2_23;
  const T b1_13 = E6_23 * (J6_22 - J6_33) + T(2) * E6_22 * J6_23;
  const T b1_14 = E10_23 * (J10_22 - J10_33) + T(2) * E10_22 * J10_23;
  const T b1_15 = E14_23 * (J14_22 - J14_33) + T(2) * E14_22 * J14_23;
  const T b1_16 = E2_23 * b1_12 + E6_23 * b1_13 + E10_23 * b1_14 + E14_23 * b1_15;
  const T J1_22 = J2_22 - b1_16 + J6_22 + J10_22 + J14_22 + c.J_all_1_22;
  const T J1_23 = c.J_all_1_23 - (J2_23 + J6_23 + J10_23 + J14_23) + E2_22 * b1_12 + E6_22 * b1_13 + E10_22 * b1_14 +
      E14_22 * b1_15 - T(0.047) * minus_hc2_3 - T(0.047) * hc6_3 - T(0.047) * minus_hc10_3 - T(0.047) * hc14_3;
  const T J1_33 = J2_33 + b1_16 + b1_3 + J6_33 + J10_33 + J14_33 + c.J_all_1_33 + T(0.094) * minus_hc2_2;
  A[0] = J1_11;
  A[1] = J1_12;
  A[18] = J1_12;
  A[2] = J1_13;
  A[36] = J1_13;
  A[19] = J1_22;
  A[20] = J1_23;
  A[37] = J1_23;
  A[38] = J1_33;
  // B_thetadot16_1 = E14^T B_thetadot16_14
  const T minus_B_thetadot16_1_2 = E14_23 * B_thetadot16_14_3;
  const T B_thetadot16_1_3 = E14_22 * B_thetadot16_14_3;
  // K_thetadot16_1 = q14~ E14^T B_thetadot16_14 + E14^T K_thetadot16_14
  const T K_thetadot16_1_1 = K_thetadot16_14_1 + T(0.047) * B_thetadot16_1_3;
  const T K_thetadot16_1_2 = E14_22 * K_thetadot16_14_2 - E14_23 * K_thetadot16_14_3;
  const T K_thetadot16_1_3 = E14_23 * K_thetadot16_14_2 + E14_22 * K_thetadot16_14_3 - T(0.047) * B_thetadot16_14_1;
  A[14] = K_thetadot16_1_1;
  A[252] = K_thetadot16_1_1;
  A[32] = K_thetadot16_1_2;
  A[253] = K_thetadot16_1_2;
  A[50] = K_thetadot16_1_3;
  A[254] = K_thetadot16_1_3;
  // B_thetadot15_1 = E14^T B_thetadot15_14
  const T minus_B_thetadot15_1_2 = E14_23 * minus_hc15_1;
  const T B_thetadot15_1_3 = E14_22 * minus_hc15_1;
  // K_thetadot15_1 = q14~ E14^T B_thetadot15_14 + E14^T K_thetadot15_14
  const T K_thetadot15_1_1 = b14_3 + T(0.047) * B_thetadot15_1_3;
  const T K_thetadot15_1_2 = E14_22 * b14_5 - E14_23 * b14_6;
  const T K_thetadot15_1_3 = T(0.047) * minus_hc15_3 + E14_23 * b14_5 + E14_22 * b14_6;
  A[13] = K_thetadot15_1_1;
  A[234] = K_thetadot15_1_1;
  A[31] = K_thetadot15_1_2;
  A[235] = K_thetadot15_1_2;
  A[49] = K_thetadot15_1_3;
  A[236] = K_thetadot15_1_3;
  // K_thetadot14_1 = q14~ E14^T B_thetadot14_14 + E14^T K_thetadot14_14
  const T K_thetadot14_1_1 = J14_11 + T(0.047) * hc14_2;
  A[12] = K_thetadot14_1_1;
  A[216] = K_thetadot14_1_1;
  A[30] = b1_7;
  A[217] = b1_7;
  A[48] = b1_11;
  A[218] = b1_11;
  // B_thetadot12_1 = E10^T B_thetadot12_10
  const T minus_B_thetadot12_1_2 = E10_23 * B_thetadot12_10_3;
  const T B_thetadot12_1_3 = E10_22 * B_thetadot12_10_3;
  // K_thetadot12_1 = q10~ E10^T B_thetadot12_10 + E10^T K_thetadot12_10
  const T K_thetadot12_1_1 = K_thetadot12_10_1 - T(0.047) * B_thetadot12_1_3;
  const T K_thetadot12_1_2 = E10_22 * K_thetadot12_10_2 + E10_23 * minus_K_thetadot12_10_3;
  const T K_thetadot12_1_3 = T(0.047) * B_thetadot12_10_1 + E10_23 * K_thetadot12_10_2 - E10_22 *
      minus_K_thetadot12_10_3;
  A[11] = K_thetadot12_1_1;
  A[198] = K_thetadot12_1_1;
  A[29] = K_thetadot12_1_2;
  A[199] = K_thetadot12_1_2;
  A[47] = K_thetadot12_1_3;
  A[200] = K_thetadot12_1_3;
  // B_thetadot11_1 = E10^T B_thetadot11_10
  const T minus_B_thetadot11_1_2 = E10_23 * minus_hc11_1;
  const T B_thetadot11_1_3 = E10_22 * minus_hc11_1;
  // K_thetadot11_1 = q10~ E10^T B_thetadot11_10 + E10^T K_thetadot11_10
  const T K_thetadot11_1_1 = b10_3 - T(0.047) * B_thetadot11_1_3;
  const T K_thetadot11_1_2 = E10_22 * b10_5 + E10_23 * b10_6;
  const T K_thetadot11_1_3 = E10_23 * b10_5 - E10_22 * b10_6 - T(0.047) * minus_hc11_3;
  A[10] = K_thetadot11_1_1;
  A[180] = K_thetadot11_1_1;
  A[28] = K_thetadot11_1_2;
  A[181] = K_thetadot11_1_2;
  A[46] = K_thetadot11_1_3;
  A[182] = K_thetadot11_1_3;
  // K_thetadot10_1 = q10~ E10^T B_thetadot10_10 + E10^T K_thetadot10_10
  const T K_thetadot10_1_1 = J10_11 + T(0.047) * minus_hc10_2;
  A[9] = K_thetadot10_1_1;
  A[162] = K_thetadot10_1_1;
  A[27] = b1_6;
  A[163] = b1_6;
  A[45] = b1_10;
  A[164] = b1_10;
  // B_thetadot8_1 = E6^T B_thetadot8_6
  const T minus_B_thetadot8_1_2 = E6_23 * B_thetadot8_6_3;
  const T B_thetadot8_1_3 = E6_22 * B_thetadot8_6_3;
  // K_thetadot8_1 = q6~ E6^T B_thetadot8_6 + E6^T K_thetadot8_6
  const T K_thetadot8_1_1 = K_thetadot8_6_1 + T(0.047) * B_thetadot8_1_3;
  const T K_thetadot8_1_2 = E6_22 * K_thetadot8_6_2 - E6_23 * K_thetadot8_6_3;
  const T K_thetadot8_1_3 = E6_23 * K_thetadot8_6_2 + E6_22 * K_thetadot8_6_3 - T(0.047) * B_thetadot8_6_1;
  A[8] = K_thetadot8_1_1;
  A[144] = K_thetadot8_1_1;
  A[26] = K_thetadot8_1_2;
  A[145] = K_thetadot8_1_2;
  A[44] = K_thetadot8_1_3;
  A[146] = K_thetadot8_1_3;
  // B_thetadot7_1 = E6^T B_thetadot7_6
  const T minus_B_thetadot7_1_2 = E6_23 * minus_hc7_1;
  const T B_thetadot7_1_3 = E6_22 * minus_hc7_1;
  // K_thetadot7_1 = q6~ E6^T B_thetadot7_6 + E6^T K_thetadot7_6
  const T K_thetadot7_1_1 = b6_3 + T(0.047) * B_thetadot7_1_3;
  const T K_thetadot7_1_2 = E6_22 * b6_5 - E6_23 * b6_6;
  const T K_thetadot7_1_3 = T(0.047) * minus_hc7_3 + E6_23 * b6_5 + E6_22 * b6_6;
  A[7] = K_thetadot7_1_1;
  A[126] = K_thetadot7_1_1;
  A[25] = K_thetadot7_1_2;
  A[127] = K_thetadot7_1_2;
  A[43] = K_thetadot7_1_3;
  A[128] = K_thetadot7_1_3;
  // K_thetadot6_1 = q6~ E6^T B_thetadot6_6 + E6^T K_thetadot6_6
  const T K_thetadot6_1_1 = J6_11 + T(0.047) * hc6_2;
  A[6] = K_thetadot6_1_1;
  A[108] = K_thetadot6_1_1;
  A[24] = b1_5;
  A[109] = b1_5;
  A[42] = b1_9;
  A[110] = b1_9;
  // B_thetadot4_1 = E2^T B_thetadot4_2
  const T minus_B_thetadot4_1_2 = E2_23 * B_thetadot4_2_3;
  const T B_thetadot4_1_3 = E2_22 * B_thetadot4_2_3;
  // K_thetadot4_1 = q2~ E2^T B_thetadot4_2 + E2^T K_thetadot4_2
  const T K_thetadot4_1_1 = K_thetadot4_2_1 - T(0.047) * B_thetadot4_1_3;
  const T K_thetadot4_1_2 = E2_22 * K_thetadot4_2_2 + E2_23 * minus_K_thetadot4_2_3;
  const T K_thetadot4_1_3 = T(0.047) * B_thetadot4_2_1 + E2_23 * K_thetadot4_2_2 - E2_22 * minus_K_thetadot4_2_3;
  A[5] = K_thetadot4_1_1;
  A[90] = K_thetadot4_1_1;
  A[23] = K_thetadot4_1_2;
  A[91] = K_thetadot4_1_2;
  A[41] = K_thetadot4_1_3;
  A[92] = K_thetadot4_1_3;
  // B_thetadot3_1 = E2^T B_thetadot3_2
  const T minus_B_thetadot3_1_2 = E2_23 * minus_hc3_1;
  const T B_thetadot3_1_3 = E2_22 * minus_hc3_1;
  // K_thetadot3_1 = q2~ E2^T B_thetadot3_2 + E2^T K_thetadot3_2
  const T K_thetadot3_1_1 = b2_3 - T(0.047) * B_thetadot3_1_3;
  const T K_thetadot3_1_2 = E2_22 * b2_5 + E2_23 * b2_6;
  const T K_thetadot3_1_3 = E2_23 * b2_5 - E2_22 * b2_6 - T(0.047) * minus_hc3_3;
  A[4] = K_thetadot3_1_1;
  A[72] = K_thetadot3_1_1;
  A[22] = K_thetadot3_1_2;
  A[73] = K_thetadot3_1_2;
  A[40] = K_thetadot3_1_3;
  A[74] = K_thetadot3_1_3;
  A[3] = b1_2;
  A[54] = b1_2;
  A[21] = b1_4;
  A[55] = b1_4;
  A[39] = b1_8;
  A[56] = b1_8;

  // ---- results
  const T t1 = h1_2 * R1_31 - h1_3 * R1_21;
  A[15] = t1;
  A[270] = t1;
  const T t2 = h1_2 * R1_32 - h1_3 * R1_22;
  A[16] = t2;
  A[288] = t2;
  const T t3 = h1_2 * R1_33 - h1_3 * R1_23;
  A[17] = t3;
  A[306] = t3;
  const T t4 = h1_3 * R1_11 + minus_h1_1 * R1_31;
  A[33] = t4;
  A[271] = t4;
  const T t5 = h1_3 * R1_12 + minus_h1_1 * R1_32;
  A[34] = t5;
  A[289] = t5;
  const T t6 = h1_3 * R1_13 + minus_h1_1 * R1_33;
  A[35] = t6;
  A[307] = t6;
  const T t7 = minus_h1_1 * R1_21 + h1_2 * R1_11;
  A[51] = -t7;
  A[272] = -t7;
  const T t8 = minus_h1_1 * R1_22 + h1_2 * R1_12;
  A[52] = -t8;
  A[290] = -t8;
  const T t9 = minus_h1_1 * R1_23 + h1_2 * R1_13;
  A[53] = -t9;
  A[308] = -t9;
  const T t10 = R1_21 * minus_hc2_3 - R1_31 * minus_hc2_2;
  A[69] = t10;
  A[273] = t10;
  const T t11 = R1_22 * minus_hc2_3 - R1_32 * minus_hc2_2;
  A[70] = t11;
  A[291] = t11;
  const T t12 = R1_23 * minus_hc2_3 - R1_33 * minus_hc2_2;
  A[71] = t12;
  A[309] = t12;
  const T t13 = R1_31 * B_thetadot3_1_3 - (R1_11 * minus_hc3_3 + R1_21 * minus_B_thetadot3_1_2);
  A[87] = t13;
  A[274] = t13;
  const T t14 = R1_32 * B_thetadot3_1_3 - (R1_12 * minus_hc3_3 + R1_22 * minus_B_thetadot3_1_2);
  A[88] = t14;
  A[292] = t14;
  const T t15 = R1_33 * B_thetadot3_1_3 - (R1_13 * minus_hc3_3 + R1_23 * minus_B_thetadot3_1_2);
  A[89] = t15;
  A[310] = t15;
  A[95] = T(0.007344838233654);
  A[152] = T(0.007344838233654);
  A[209] = T(0.007344838233654);
  A[266] = T(0.007344838233654);
  const T t16 = R1_11 * B_thetadot4_2_1 - R1_21 * minus_B_thetadot4_1_2 + R1_31 * B_thetadot4_1_3;
  A[105] = t16;
  A[275] = t16;
  const T t17 = R1_12 * B_thetadot4_2_1 - R1_22 * minus_B_thetadot4_1_2 + R1_32 * B_thetadot4_1_3;
  A[106] = t17;
  A[293] = t17;
  const T t18 = R1_13 * B_thetadot4_2_1 - R1_23 * minus_B_thetadot4_1_2 + R1_33 * B_thetadot4_1_3;
  A[107] = t18;
  A[311] = t18;
  const T t19 = R1_31 * hc6_2 - R1_21 * hc6_3;
  A[123] = t19;
  A[276] = t19;
  const T t20 = R1_32 * hc6_2 - R1_22 * hc6_3;
  A[124] = t20;
  A[294] = t20;
  const T t21 = R1_33 * hc6_2 - R1_23 * hc6_3;
  A[125] = t21;
  A[312] = t21;
  const T t22 = R1_31 * B_thetadot7_1_3 - (R1_11 * minus_hc7_3 + R1_21 * minus_B_thetadot7_1_2);
  A[141] = t22;
  A[277] = t22;
  const T t23 = R1_32 * B_thetadot7_1_3 - (R1_12 * minus_hc7_3 + R1_22 * minus_B_thetadot7_1_2);
  A[142] = t23;
  A[295] = t23;
  const T t24 = R1_33 * B_thetadot7_1_3 - (R1_13 * minus_hc7_3 + R1_23 * minus_B_thetadot7_1_2);
  A[143] = t24;
  A[313] = t24;
  const T t25 = R1_11 * B_thetadot8_6_1 - R1_21 * minus_B_thetadot8_1_2 + R1_31 * B_thetadot8_1_3;
  A[159] = t25;
  A[278] = t25;
  const T t26 = R1_12 * B_thetadot8_6_1 - R1_22 * minus_B_thetadot8_1_2 + R1_32 * B_thetadot8_1_3;
  A[160] = t26;
  A[296] = t26;
  const T t27 = R1_13 * B_thetadot8_6_1 - R1_23 * minus_B_thetadot8_1_2 + R1_33 * B_thetadot8_1_3;
  A[161] = t27;
  A[314] = t27;
  const T t28 = R1_21 * minus_hc10_3 - R1_31 * minus_hc10_2;
  A[177] = t28;
  A[279] = t28;
  const T t29 = R1_22 * minus_hc10_3 - R1_32 * minus_hc10_2;
  A[178] = t29;
  A[297] = t29;
  const T t30 = R1_23 * minus_hc10_3 - R1_33 * minus_hc10_2;
  A[179] = t30;
  A[315] = t30;
  const T t31 = R1_31 * B_thetadot11_1_3 - (R1_11 * minus_hc11_3 + R1_21 * minus_B_thetadot11_1_2);
  A[195] = t31;
  A[280] = t31;
  const T t32 = R1_32 * B_thetadot11_1_3 - (R1_12 * minus_hc11_3 + R1_22 * minus_B_thetadot11_1_2);
  A[196] = t32;
  A[298] = t32;
  const T t33 = R1_33 * B_thetadot11_1_3 - (R1_13 * minus_hc11_3 + R1_23 * minus_B_thetadot11_1_2);
  A[197] = t33;
  A[316] = t33;
  const T t34 = R1_11 * B_thetadot12_10_1 - R1_21 * minus_B_thetadot12_1_2 + R1_31 * B_thetadot12_1_3;
  A[213] = t34;
  A[281] = t34;
  const T t35 = R1_12 * B_thetadot12_10_1 - R1_22 * minus_B_thetadot12_1_2 + R1_32 * B_thetadot12_1_3;
  A[214] = t35;
  A[299] = t35;
  const T t36 = R1_13 * B_thetadot12_10_1 - R1_23 * minus_B_thetadot12_1_2 + R1_33 * B_thetadot12_1_3;
  A[215] = t36;
  A[317] = t36;
  const T t37 = R1_31 * hc14_2 - R1_21 * hc14_3;
  A[231] = t37;
  A[282] = t37;
  const T t38 = R1_32 * hc14_2 - R1_22 * hc14_3;
  A[232] = t38;
  A[300] = t38;
  const T t39 = R1_33 * hc14_2 - R1_23 * hc14_3;
  A[233] = t39;
  A[318] = t39;
  const T t40 = R1_31 * B_thetadot15_1_3 - (R1_11 * minus_hc15_3 + R1_21 * minus_B_thetadot15_1_2);
  A[249] = t40;
  A[283] = t40;
  const T t41 = R1_32 * B_thetadot15_1_3 - (R1_12 * minus_hc15_3 + R1_22 * minus_B_thetadot15_1_2);
  A[250] = t41;
  A[301] = t41;
  const T t42 = R1_33 * B_thetadot15_1_3 - (R1_13 * minus_hc15_3 + R1_23 * minus_B_thetadot15_1_2);
  A[251] = t42;
  A[319] = t42;
  const T t43 = R1_11 * B_thetadot16_14_1 - R1_21 * minus_B_thetadot16_1_2 + R1_31 * B_thetadot16_1_3;
  A[267] = t43;
  A[284] = t43;
  const T t44 = R1_12 * B_thetadot16_14_1 - R1_22 * minus_B_thetadot16_1_2 + R1_32 * B_thetadot16_1_3;
  A[268] = t44;
  A[302] = t44;
  const T t45 = R1_13 * B_thetadot16_14_1 - R1_23 * minus_B_thetadot16_1_2 + R1_33 * B_thetadot16_1_3;
  A[269] = t45;
  A[320] = t45;
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 704 add, 928 multiply, 24 sine or cosine
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  for (int i = 0; i < 918; ++i) v_y[i] = T(0);
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
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
  const T B1_1_11 = R1_21 * T(5e-04) + R1_31 * T(0.0041);
  const T minus_B1_1_12 = R1_11 * T(5e-04);
  const T minus_B1_1_13 = R1_11 * T(0.0041);
  const T B1_1_21 = R1_22 * T(5e-04) + R1_32 * T(0.0041);
  const T minus_B1_1_22 = R1_12 * T(5e-04);
  const T minus_B1_1_23 = R1_12 * T(0.0041);
  const T B1_1_31 = R1_23 * T(5e-04) + R1_33 * T(0.0041);
  const T minus_B1_1_32 = R1_13 * T(5e-04);
  const T minus_B1_1_33 = R1_13 * T(0.0041);
  v_y[0] = B1_1_11;
  v_y[1] = -minus_B1_1_12;
  v_y[2] = -minus_B1_1_13;
  v_y[18] = B1_1_21;
  v_y[19] = -minus_B1_1_22;
  v_y[20] = -minus_B1_1_23;
  v_y[36] = B1_1_31;
  v_y[37] = -minus_B1_1_32;
  v_y[38] = -minus_B1_1_33;

  // ---- body 2 (fr_hip) on body 1
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
  // P_omega1_2 = -R1^T q2~: partial velocity of the body origin, inertial axes
  const T minus_P_omega1_2_11 = R1_31 * T(0.047);
  const T minus_P_omega1_2_12 = R1_31 * T(0.1805);
  const T t2_1 = R1_11 * T(0.047);
  const T t2_2 = R1_21 * T(0.1805);
  const T P_omega1_2_13 = t2_1 + t2_2;
  const T minus_P_omega1_2_21 = R1_32 * T(0.047);
  const T minus_P_omega1_2_22 = R1_32 * T(0.1805);
  const T t2_3 = R1_12 * T(0.047);
  const T t2_4 = R1_22 * T(0.1805);
  const T P_omega1_2_23 = t2_3 + t2_4;
  const T minus_P_omega1_2_31 = R1_33 * T(0.047);
  const T minus_P_omega1_2_32 = R1_33 * T(0.1805);
  const T t2_5 = R1_13 * T(0.047);
  const T t2_6 = R1_23 * T(0.1805);
  const T P_omega1_2_33 = t2_5 + t2_6;
  // B3_1 = -R2^T r2~ E2 + P_omega1_2
  const T t2_7 = R2_21 * T(3.1e-05) + R2_31 * T(0.000635);
  const T minus_B3_1_11 = t2_7 + minus_P_omega1_2_11;
  const T t2_8 = T(0.000635) * E2_23 - T(3.1e-05) * E2_22;
  const T t2_9 = T(0.003311) * E2_23;
  const T t2_10 = T(0.003311) * E2_22;
  const T minus_B3_1_12 = minus_P_omega1_2_12 + R1_11 * t2_8 - R2_21 * t2_9 - R2_31 * t2_10;
  const T t2_11 = T(3.1e-05) * E2_23 + T(0.000635) * E2_22;
  const T minus_B3_1_13 = R2_21 * t2_10 - P_omega1_2_13 - R1_11 * t2_11 - R2_31 * t2_9;
  const T t2_12 = R2_22 * T(3.1e-05) + R2_32 * T(0.000635);
  const T minus_B3_1_21 = t2_12 + minus_P_omega1_2_21;
  const T minus_B3_1_22 = minus_P_omega1_2_22 + R1_12 * t2_8 - R2_22 * t2_9 - R2_32 * t2_10;
  const T minus_B3_1_23 = R2_22 * t2_10 - P_omega1_2_23 - R1_12 * t2_11 - R2_32 * t2_9;
  const T t2_13 = R2_23 * T(3.1e-05) + R2_33 * T(0.000635);
  const T minus_B3_1_31 = t2_13 + minus_P_omega1_2_31;
  const T minus_B3_1_32 = minus_P_omega1_2_32 + R1_13 * t2_8 - R2_23 * t2_9 - R2_33 * t2_10;
  const T minus_B3_1_33 = R2_23 * t2_10 - P_omega1_2_33 - R1_13 * t2_11 - R2_33 * t2_9;
  v_y[54] = -minus_B3_1_11;
  v_y[55] = -minus_B3_1_12;
  v_y[56] = -minus_B3_1_13;
  v_y[72] = -minus_B3_1_21;
  v_y[73] = -minus_B3_1_22;
  v_y[74] = -minus_B3_1_23;
  v_y[90] = -minus_B3_1_31;
  v_y[91] = -minus_B3_1_32;
  v_y[92] = -minus_B3_1_33;
  v_y[57] = -t2_7;
  v_y[75] = -t2_12;
  v_y[93] = -t2_13;

  // ---- body 3 (fr_thigh) on body 2
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 - R2_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 - R2_33 * minus_E3_13;
  const T R3_31 = R1_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R1_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = R1_13 * minus_E3_13 + R2_33 * E3_11;
  // omega_omega1_3 = E3 E2: partial angular velocity, body axes
  const T omega_omega1_3_12 = minus_E3_13 * E2_23;
  const T minus_omega_omega1_3_13 = minus_E3_13 * E2_22;
  const T minus_omega_omega1_3_32 = E3_11 * E2_23;
  const T omega_omega1_3_33 = E3_11 * E2_22;
  // P_omega1_3 = -R2^T q3~ E2 + P_omega1_2: partial velocity of the body origin, inertial axes
  const T t3_1 = R2_31 * T(0.0838);
  const T minus_P_omega1_3_11 = t3_1 + minus_P_omega1_2_11;
  const T t3_2 = T(0.0838) * E2_23;
  const T minus_P_omega1_3_12 = minus_P_omega1_2_12 + R1_11 * t3_2;
  const T t3_3 = T(0.0838) * E2_22;
  const T P_omega1_3_13 = P_omega1_2_13 + R1_11 * t3_3;
  const T t3_4 = R2_32 * T(0.0838);
  const T minus_P_omega1_3_21 = t3_4 + minus_P_omega1_2_21;
  const T minus_P_omega1_3_22 = minus_P_omega1_2_22 + R1_12 * t3_2;
  const T P_omega1_3_23 = P_omega1_2_23 + R1_12 * t3_3;
  const T t3_5 = R2_33 * T(0.0838);
  const T minus_P_omega1_3_31 = t3_5 + minus_P_omega1_2_31;
  const T minus_P_omega1_3_32 = minus_P_omega1_2_32 + R1_13 * t3_2;
  const T P_omega1_3_33 = P_omega1_2_33 + R1_13 * t3_3;
  // B5_1 = -R3^T r3~ omega_omega1_3 + P_omega1_3
  const T t3_6 = T(0.022327) * minus_E3_13;
  const T t3_7 = T(0.003237) * minus_E3_13 - T(0.027326) * E3_11;
  const T t3_8 = T(0.022327) * E3_11;
  const T t3_9 = R3_11 * t3_6 + R2_21 * t3_7 - R3_31 * t3_8;
  const T minus_B5_1_11 = t3_9 + minus_P_omega1_3_11;
  const T t3_10 = T(0.027326) * E2_22 - T(0.022327) * minus_omega_omega1_3_32;
  const T t3_11 = T(0.027326) * omega_omega1_3_12 + T(0.003237) * minus_omega_omega1_3_32;
  const T t3_12 = T(0.003237) * E2_22 + T(0.022327) * omega_omega1_3_12;
  const T minus_B5_1_12 = minus_P_omega1_3_12 + R3_11 * t3_10 - R2_21 * t3_11 - R3_31 * t3_12;
  const T t3_13 = T(0.027326) * E2_23 + T(0.022327) * omega_omega1_3_33;
  const T t3_14 = T(0.027326) * minus_omega_omega1_3_13 + T(0.003237) * omega_omega1_3_33;
  const T t3_15 = T(0.022327) * minus_omega_omega1_3_13 - T(0.003237) * E2_23;
  const T minus_B5_1_13 = R3_11 * t3_13 - P_omega1_3_13 + R2_21 * t3_14 + R3_31 * t3_15;
  const T t3_16 = R3_12 * t3_6 + R2_22 * t3_7 - R3_32 * t3_8;
  const T minus_B5_1_21 = t3_16 + minus_P_omega1_3_21;
  const T minus_B5_1_22 = minus_P_omega1_3_22 + R3_12 * t3_10 - R2_22 * t3_11 - R3_32 * t3_12;
  const T minus_B5_1_23 = R3_12 * t3_13 - P_omega1_3_23 + R2_22 * t3_14 + R3_32 * t3_15;
  const T t3_17 = R3_13 * t3_6 + R2_23 * t3_7 - R3_33 * t3_8;
  const T minus_B5_1_31 = t3_17 + minus_P_omega1_3_31;
  const T minus_B5_1_32 = minus_P_omega1_3_32 + R3_13 * t3_10 - R2_23 * t3_11 - R3_33 * t3_12;
  const T minus_B5_1_33 = R3_13 * t3_13 - P_omega1_3_33 + R2_23 * t3_14 + R3_33 * t3_15;
  v_y[108] = -minus_B5_1_11;
  v_y[109] = -minus_B5_1_12;
  v_y[110] = -minus_B5_1_13;
  v_y[126] = -minus_B5_1_21;
  v_y[127] = -minus_B5_1_22;
  v_y[128] = -minus_B5_1_23;
  v_y[144] = -minus_B5_1_31;
  v_y[145] = -minus_B5_1_32;
  v_y[146] = -minus_B5_1_33;
  // B6_2 = -R3^T r3~ omega_thetadot2_3 + P_thetadot2_3
  const T minus_B6_2_1 = t3_9 + t3_1;
  const T minus_B6_2_2 = t3_16 + t3_4;
  const T minus_B6_2_3 = t3_17 + t3_5;
  v_y[111] = -minus_B6_2_1;
  v_y[129] = -minus_B6_2_2;
  v_y[147] = -minus_B6_2_3;
  // B7_3 = -R3^T r3~ b3
  const T minus_B7_3_1 = R3_11 * T(0.027326) - R3_31 * T(0.003237);
  const T minus_B7_3_2 = R3_12 * T(0.027326) - R3_32 * T(0.003237);
  const T minus_B7_3_3 = R3_13 * T(0.027326) - R3_33 * T(0.003237);
  v_y[112] = -minus_B7_3_1;
  v_y[130] = -minus_B7_3_2;
  v_y[148] = -minus_B7_3_3;

  // ---- body 4 (fr_calf) on body 3
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - R3_31 * minus_E4_13;
  const T R4_12 = R3_12 * E4_11 - R3_32 * minus_E4_13;
  const T R4_13 = R3_13 * E4_11 - R3_33 * minus_E4_13;
  const T R4_31 = R3_11 * minus_E4_13 + R3_31 * E4_11;
  const T R4_32 = R3_12 * minus_E4_13 + R3_32 * E4_11;
  const T R4_33 = R3_13 * minus_E4_13 + R3_33 * E4_11;
  // omega_omega1_4 = E4 omega_omega1_3: partial angular velocity, body axes
  const T omega_omega1_4_11 = E4_11 * E3_11 - minus_E4_13 * minus_E3_13;
  const T omega_omega1_4_12 = E4_11 * omega_omega1_3_12 + minus_E4_13 * minus_omega_omega1_3_32;
  const T minus_omega_omega1_4_13 = E4_11 * minus_omega_omega1_3_13 + minus_E4_13 * omega_omega1_3_33;
  const T omega_omega1_4_31 = minus_E4_13 * E3_11 + E4_11 * minus_E3_13;
  const T omega_omega1_4_32 = minus_E4_13 * omega_omega1_3_12 - E4_11 * minus_omega_omega1_3_32;
  const T omega_omega1_4_33 = E4_11 * omega_omega1_3_33 - minus_E4_13 * minus_omega_omega1_3_13;
  // P_omega1_4 = -R3^T q4~ omega_omega1_3 + P_omega1_3: partial velocity of the body origin, inertial axes
  const T t4_1 = T(0.2) * E3_11;
  const T t4_2 = R2_21 * t4_1;
  const T minus_P_omega1_4_11 = minus_P_omega1_3_11 - t4_2;
  const T t4_3 = T(0.2) * E2_22;
  const T t4_4 = T(0.2) * omega_omega1_3_12;
  const T minus_P_omega1_4_12 = minus_P_omega1_3_12 + R3_11 * t4_3 - R2_21 * t4_4;
  const T t4_5 = T(0.2) * E2_23;
  const T t4_6 = T(0.2) * minus_omega_omega1_3_13;
  const T minus_P_omega1_4_13 = R3_11 * t4_5 - P_omega1_3_13 + R2_21 * t4_6;
  const T t4_7 = R2_22 * t4_1;
  const T minus_P_omega1_4_21 = minus_P_omega1_3_21 - t4_7;
  const T minus_P_omega1_4_22 = minus_P_omega1_3_22 + R3_12 * t4_3 - R2_22 * t4_4;
  const T minus_P_omega1_4_23 = R3_12 * t4_5 - P_omega1_3_23 + R2_22 * t4_6;
  const T t4_8 = R2_23 * t4_1;
  const T minus_P_omega1_4_31 = minus_P_omega1_3_31 - t4_8;
  const T minus_P_omega1_4_32 = minus_P_omega1_3_32 + R3_13 * t4_3 - R2_23 * t4_4;
  const T minus_P_omega1_4_33 = R3_13 * t4_5 - P_omega1_3_33 + R2_23 * t4_6;
  // P_thetadot2_4 = -R3^T q4~ omega_thetadot2_3 + P_thetadot2_3: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot2_4_1 = t3_1 - t4_2;
  const T minus_P_thetadot2_4_2 = t3_4 - t4_7;
  const T minus_P_thetadot2_4_3 = t3_5 - t4_8;
  // P_thetadot3_4 = -R3^T q4~ b3: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot3_4_1 = R3_11 * T(0.2);
  const T minus_P_thetadot3_4_2 = R3_12 * T(0.2);
  const T minus_P_thetadot3_4_3 = R3_13 * T(0.2);
  // B8_1 = -R4^T r4~ omega_omega1_4 + P_omega1_4
  const T t4_9 = T(0.107388) * omega_omega1_4_11 + T(0.006435) * omega_omega1_4_31;
  const T t4_10 = R2_21 * t4_9;
  const T minus_B8_1_11 = minus_P_omega1_4_11 - t4_10;
  const T t4_11 = T(0.107388) * E2_22;
  const T t4_12 = T(0.107388) * omega_omega1_4_12 + T(0.006435) * omega_omega1_4_32;
  const T t4_13 = T(0.006435) * E2_22;
  const T minus_B8_1_12 = minus_P_omega1_4_12 + R4_11 * t4_11 - R2_21 * t4_12 + R4_31 * t4_13;
  const T t4_14 = T(0.107388) * E2_23;
  const T t4_15 = T(0.107388) * minus_omega_omega1_4_13 - T(0.006435) * omega_omega1_4_33;
  const T t4_16 = T(0.006435) * E2_23;
  const T minus_B8_1_13 = minus_P_omega1_4_13 + R4_11 * t4_14 + R2_21 * t4_15 + R4_31 * t4_16;
  const T t4_17 = R2_22 * t4_9;
  const T minus_B8_1_21 = minus_P_omega1_4_21 - t4_17;
  const T minus_B8_1_22 = minus_P_omega1_4_22 + R4_12 * t4_11 - R2_22 * t4_12 + R4_32 * t4_13;
  const T minus_B8_1_23 = minus_P_omega1_4_23 + R4_12 * t4_14 + R2_22 * t4_15 + R4_32 * t4_16;
  const T t4_18 = R2_23 * t4_9;
  const T minus_B8_1_31 = minus_P_omega1_4_31 - t4_18;
  const T minus_B8_1_32 = minus_P_omega1_4_32 + R4_13 * t4_11 - R2_23 * t4_12 + R4_33 * t4_13;
  const T minus_B8_1_33 = minus_P_omega1_4_33 + R4_13 * t4_14 + R2_23 * t4_15 + R4_33 * t4_16;
  v_y[162] = -minus_B8_1_11;
  v_y[163] = -minus_B8_1_12;
  v_y[164] = -minus_B8_1_13;
  v_y[180] = -minus_B8_1_21;
  v_y[181] = -minus_B8_1_22;
  v_y[182] = -minus_B8_1_23;
  v_y[198] = -minus_B8_1_31;
  v_y[199] = -minus_B8_1_32;
  v_y[200] = -minus_B8_1_33;
  // B9_2 = -R4^T r4~ omega_thetadot2_4 + P_thetadot2_4
  const T minus_B9_2_1 = minus_P_thetadot2_4_1 - t4_10;
  const T minus_B9_2_2 = minus_P_thetadot2_4_2 - t4_17;
  const T minus_B9_2_3 = minus_P_thetadot2_4_3 - t4_18;
  v_y[165] = -minus_B9_2_1;
  v_y[183] = -minus_B9_2_2;
  v_y[201] = -minus_B9_2_3;
  // B10_3 = -R4^T r4~ omega_thetadot3_4 + P_thetadot3_4
  const T t4_19 = R4_11 * T(0.107388) + R4_31 * T(0.006435);
  const T minus_B10_3_1 = t4_19 + minus_P_thetadot3_4_1;
  const T t4_20 = R4_12 * T(0.107388) + R4_32 * T(0.006435);
  const T minus_B10_3_2 = t4_20 + minus_P_thetadot3_4_2;
  const T t4_21 = R4_13 * T(0.107388) + R4_33 * T(0.006435);
  const T minus_B10_3_3 = t4_21 + minus_P_thetadot3_4_3;
  v_y[166] = -minus_B10_3_1;
  v_y[184] = -minus_B10_3_2;
  v_y[202] = -minus_B10_3_3;
  v_y[167] = -t4_19;
  v_y[185] = -t4_20;
  v_y[203] = -t4_21;
  // B12_1 = -R4^T o5~ omega_omega1_4 + P_omega1_4
  const T t4_22 = T(0.2) * omega_omega1_4_11;
  const T t4_23 = R2_21 * t4_22;
  const T minus_B12_1_11 = minus_P_omega1_4_11 - t4_23;
  const T t4_24 = T(0.2) * omega_omega1_4_12;
  const T minus_B12_1_12 = minus_P_omega1_4_12 + R4_11 * t4_3 - R2_21 * t4_24;
  const T t4_25 = T(0.2) * minus_omega_omega1_4_13;
  const T minus_B12_1_13 = minus_P_omega1_4_13 + R4_11 * t4_5 + R2_21 * t4_25;
  const T t4_26 = R2_22 * t4_22;
  const T minus_B12_1_21 = minus_P_omega1_4_21 - t4_26;
  const T minus_B12_1_22 = minus_P_omega1_4_22 + R4_12 * t4_3 - R2_22 * t4_24;
  const T minus_B12_1_23 = minus_P_omega1_4_23 + R4_12 * t4_5 + R2_22 * t4_25;
  const T t4_27 = R2_23 * t4_22;
  const T minus_B12_1_31 = minus_P_omega1_4_31 - t4_27;
  const T minus_B12_1_32 = minus_P_omega1_4_32 + R4_13 * t4_3 - R2_23 * t4_24;
  const T minus_B12_1_33 = minus_P_omega1_4_33 + R4_13 * t4_5 + R2_23 * t4_25;
  v_y[216] = -minus_B12_1_11;
  v_y[217] = -minus_B12_1_12;
  v_y[218] = -minus_B12_1_13;
  v_y[234] = -minus_B12_1_21;
  v_y[235] = -minus_B12_1_22;
  v_y[236] = -minus_B12_1_23;
  v_y[252] = -minus_B12_1_31;
  v_y[253] = -minus_B12_1_32;
  v_y[254] = -minus_B12_1_33;
  // B13_2 = -R4^T o5~ omega_thetadot2_4 + P_thetadot2_4
  const T minus_B13_2_1 = minus_P_thetadot2_4_1 - t4_23;
  const T minus_B13_2_2 = minus_P_thetadot2_4_2 - t4_26;
  const T minus_B13_2_3 = minus_P_thetadot2_4_3 - t4_27;
  v_y[219] = -minus_B13_2_1;
  v_y[237] = -minus_B13_2_2;
  v_y[255] = -minus_B13_2_3;
  // B14_3 = -R4^T o5~ omega_thetadot3_4 + P_thetadot3_4
  const T t4_28 = R4_11 * T(0.2);
  const T minus_B14_3_1 = t4_28 + minus_P_thetadot3_4_1;
  const T t4_29 = R4_12 * T(0.2);
  const T minus_B14_3_2 = t4_29 + minus_P_thetadot3_4_2;
  const T t4_30 = R4_13 * T(0.2);
  const T minus_B14_3_3 = t4_30 + minus_P_thetadot3_4_3;
  v_y[220] = -minus_B14_3_1;
  v_y[238] = -minus_B14_3_2;
  v_y[256] = -minus_B14_3_3;
  v_y[221] = -t4_28;
  v_y[239] = -t4_29;
  v_y[257] = -t4_30;

  // ---- body 6 (fl_hip) on body 1
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];
  // R6^T = R1^T E6^T: R takes inertial components to body components
  const T R6_21 = R1_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R1_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R1_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R1_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R1_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R1_23 * E6_23;
  // P_omega1_6 = -R1^T q6~: partial velocity of the body origin, inertial axes
  const T minus_P_omega1_6_13 = t2_1 - t2_2;
  const T minus_P_omega1_6_23 = t2_3 - t2_4;
  const T minus_P_omega1_6_33 = t2_5 - t2_6;
  // B16_1 = -R6^T r6~ E6 + P_omega1_6
  const T t6_1 = R6_21 * T(3.1e-05) - R6_31 * T(0.000635);
  const T minus_B16_1_11 = t6_1 - minus_P_omega1_2_11;
  const T t6_2 = T(3.1e-05) * E6_22 + T(0.000635) * E6_23;
  const T t6_3 = T(0.003311) * E6_23;
  const T t6_4 = T(0.003311) * E6_22;
  const T minus_B16_1_12 = minus_P_omega1_2_12 - R1_11 * t6_2 - R6_21 * t6_3 - R6_31 * t6_4;
  const T t6_5 = T(0.000635) * E6_22 - T(3.1e-05) * E6_23;
  const T minus_B16_1_13 = minus_P_omega1_6_13 + R1_11 * t6_5 + R6_21 * t6_4 - R6_31 * t6_3;
  const T t6_6 = R6_22 * T(3.1e-05) - R6_32 * T(0.000635);
  const T minus_B16_1_21 = t6_6 - minus_P_omega1_2_21;
  const T minus_B16_1_22 = minus_P_omega1_2_22 - R1_12 * t6_2 - R6_22 * t6_3 - R6_32 * t6_4;
  const T minus_B16_1_23 = minus_P_omega1_6_23 + R1_12 * t6_5 + R6_22 * t6_4 - R6_32 * t6_3;
  const T t6_7 = R6_23 * T(3.1e-05) - R6_33 * T(0.000635);
  const T minus_B16_1_31 = t6_7 - minus_P_omega1_2_31;
  const T minus_B16_1_32 = minus_P_omega1_2_32 - R1_13 * t6_2 - R6_23 * t6_3 - R6_33 * t6_4;
  const T minus_B16_1_33 = minus_P_omega1_6_33 + R1_13 * t6_5 + R6_23 * t6_4 - R6_33 * t6_3;
  v_y[270] = -minus_B16_1_11;
  v_y[271] = -minus_B16_1_12;
  v_y[272] = -minus_B16_1_13;
  v_y[288] = -minus_B16_1_21;
  v_y[289] = -minus_B16_1_22;
  v_y[290] = -minus_B16_1_23;
  v_y[306] = -minus_B16_1_31;
  v_y[307] = -minus_B16_1_32;
  v_y[308] = -minus_B16_1_33;
  v_y[276] = -t6_1;
  v_y[294] = -t6_6;
  v_y[312] = -t6_7;

  // ---- body 7 (fl_thigh) on body 6
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R1_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R1_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R1_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R1_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R1_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R1_13 * minus_E7_13 + R6_33 * E7_11;
  // omega_omega1_7 = E7 E6: partial angular velocity, body axes
  const T omega_omega1_7_12 = minus_E7_13 * E6_23;
  const T minus_omega_omega1_7_13 = minus_E7_13 * E6_22;
  const T minus_omega_omega1_7_32 = E7_11 * E6_23;
  const T omega_omega1_7_33 = E7_11 * E6_22;
  // P_omega1_7 = -R6^T q7~ E6 + P_omega1_6: partial velocity of the body origin, inertial axes
  const T t7_1 = R6_31 * T(0.0838);
  const T P_omega1_7_11 = t7_1 + minus_P_omega1_2_11;
  const T t7_2 = T(0.0838) * E6_23;
  const T minus_P_omega1_7_12 = minus_P_omega1_2_12 - R1_11 * t7_2;
  const T t7_3 = T(0.0838) * E6_22;
  const T minus_P_omega1_7_13 = minus_P_omega1_6_13 + R1_11 * t7_3;
  const T t7_4 = R6_32 * T(0.0838);
  const T P_omega1_7_21 = t7_4 + minus_P_omega1_2_21;
  const T minus_P_omega1_7_22 = minus_P_omega1_2_22 - R1_12 * t7_2;
  const T minus_P_omega1_7_23 = minus_P_omega1_6_23 + R1_12 * t7_3;
  const T t7_5 = R6_33 * T(0.0838);
  const T P_omega1_7_31 = t7_5 + minus_P_omega1_2_31;
  const T minus_P_omega1_7_32 = minus_P_omega1_2_32 - R1_13 * t7_2;
  const T minus_P_omega1_7_33 = minus_P_omega1_6_33 + R1_13 * t7_3;
  // B18_1 = -R7^T r7~ omega_omega1_7 + P_omega1_7
  const T t7_6 = T(0.003237) * minus_E7_13 - T(0.027326) * E7_11;
  const T t7_7 = T(0.022327) * minus_E7_13;
  const T t7_8 = T(0.022327) * E7_11;
  const T t7_9 = R6_21 * t7_6 - R7_11 * t7_7 + R7_31 * t7_8;
  const T minus_B18_1_11 = t7_9 - P_omega1_7_11;
  const T t7_10 = T(0.027326) * E6_22 + T(0.022327) * minus_omega_omega1_7_32;
  const T t7_11 = T(0.027326) * omega_omega1_7_12 + T(0.003237) * minus_omega_omega1_7_32;
  const T t7_12 = T(0.022327) * omega_omega1_7_12 - T(0.003237) * E6_22;
  const T minus_B18_1_12 = minus_P_omega1_7_12 + R7_11 * t7_10 - R6_21 * t7_11 + R7_31 * t7_12;
  const T t7_13 = T(0.027326) * E6_23 - T(0.022327) * omega_omega1_7_33;
  const T t7_14 = T(0.027326) * minus_omega_omega1_7_13 + T(0.003237) * omega_omega1_7_33;
  const T t7_15 = T(0.003237) * E6_23 + T(0.022327) * minus_omega_omega1_7_13;
  const T minus_B18_1_13 = minus_P_omega1_7_13 + R7_11 * t7_13 + R6_21 * t7_14 - R7_31 * t7_15;
  const T t7_16 = R6_22 * t7_6 - R7_12 * t7_7 + R7_32 * t7_8;
  const T minus_B18_1_21 = t7_16 - P_omega1_7_21;
  const T minus_B18_1_22 = minus_P_omega1_7_22 + R7_12 * t7_10 - R6_22 * t7_11 + R7_32 * t7_12;
  const T minus_B18_1_23 = minus_P_omega1_7_23 + R7_12 * t7_13 + R6_22 * t7_14 - R7_32 * t7_15;
  const T t7_17 = R6_23 * t7_6 - R7_13 * t7_7 + R7_33 * t7_8;
  const T minus_B18_1_31 = t7_17 - P_omega1_7_31;
  const T minus_B18_1_32 = minus_P_omega1_7_32 + R7_13 * t7_10 - R6_23 * t7_11 + R7_33 * t7_12;
  const T minus_B18_1_33 = minus_P_omega1_7_33 + R7_13 * t7_13 + R6_23 * t7_14 - R7_33 * t7_15;
  v_y[324] = -minus_B18_1_11;
  v_y[325] = -minus_B18_1_12;
  v_y[326] = -minus_B18_1_13;
  v_y[342] = -minus_B18_1_21;
  v_y[343] = -minus_B18_1_22;
  v_y[344] = -minus_B18_1_23;
  v_y[360] = -minus_B18_1_31;
  v_y[361] = -minus_B18_1_32;
  v_y[362] = -minus_B18_1_33;
  // B19_6 = -R7^T r7~ omega_thetadot6_7 + P_thetadot6_7
  const T minus_B19_6_1 = t7_9 - t7_1;
  const T minus_B19_6_2 = t7_16 - t7_4;
  const T minus_B19_6_3 = t7_17 - t7_5;
  v_y[330] = -minus_B19_6_1;
  v_y[348] = -minus_B19_6_2;
  v_y[366] = -minus_B19_6_3;
  // B20_7 = -R7^T r7~ b7
  const T minus_B20_7_1 = R7_11 * T(0.027326) - R7_31 * T(0.003237);
  const T minus_B20_7_2 = R7_12 * T(0.027326) - R7_32 * T(0.003237);
  const T minus_B20_7_3 = R7_13 * T(0.027326) - R7_33 * T(0.003237);
  v_y[331] = -minus_B20_7_1;
  v_y[349] = -minus_B20_7_2;
  v_y[367] = -minus_B20_7_3;

  // ---- body 8 (fl_calf) on body 7
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[9];
  const T minus_E8_13 = sines[9];
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T R8_11 = R7_11 * E8_11 - R7_31 * minus_E8_13;
  const T R8_12 = R7_12 * E8_11 - R7_32 * minus_E8_13;
  const T R8_13 = R7_13 * E8_11 - R7_33 * minus_E8_13;
  const T R8_31 = R7_11 * minus_E8_13 + R7_31 * E8_11;
  const T R8_32 = R7_12 * minus_E8_13 + R7_32 * E8_11;
  const T R8_33 = R7_13 * minus_E8_13 + R7_33 * E8_11;
  // omega_omega1_8 = E8 omega_omega1_7: partial angular velocity, body axes
  const T omega_omega1_8_11 = E8_11 * E7_11 - minus_E8_13 * minus_E7_13;
  const T omega_omega1_8_12 = E8_11 * omega_omega1_7_12 + minus_E8_13 * minus_omega_omega1_7_32;
  const T minus_omega_omega1_8_13 = E8_11 * minus_omega_omega1_7_13 + minus_E8_13 * omega_omega1_7_33;
  const T omega_omega1_8_31 = minus_E8_13 * E7_11 + E8_11 * minus_E7_13;
  const T omega_omega1_8_32 = minus_E8_13 * omega_omega1_7_12 - E8_11 * minus_omega_omega1_7_32;
  const T omega_omega1_8_33 = E8_11 * omega_omega1_7_33 - minus_E8_13 * minus_omega_omega1_7_13;
  // P_omega1_8 = -R7^T q8~ omega_omega1_7 + P_omega1_7: partial velocity of the body origin, inertial axes
  const T t8_1 = T(0.2) * E7_11;
  const T t8_2 = R6_21 * t8_1;
  const T P_omega1_8_11 = t8_2 + P_omega1_7_11;
  const T t8_3 = T(0.2) * E6_22;
  const T t8_4 = T(0.2) * omega_omega1_7_12;
  const T minus_P_omega1_8_12 = minus_P_omega1_7_12 + R7_11 * t8_3 - R6_21 * t8_4;
  const T t8_5 = T(0.2) * E6_23;
  const T t8_6 = T(0.2) * minus_omega_omega1_7_13;
  const T minus_P_omega1_8_13 = minus_P_omega1_7_13 + R7_11 * t8_5 + R6_21 * t8_6;
  const T t8_7 = R6_22 * t8_1;
  const T P_omega1_8_21 = t8_7 + P_omega1_7_21;
  const T minus_P_omega1_8_22 = minus_P_omega1_7_22 + R7_12 * t8_3 - R6_22 * t8_4;
  const T minus_P_omega1_8_23 = minus_P_omega1_7_23 + R7_12 * t8_5 + R6_22 * t8_6;
  const T t8_8 = R6_23 * t8_1;
  const T P_omega1_8_31 = t8_8 + P_omega1_7_31;
  const T minus_P_omega1_8_32 = minus_P_omega1_7_32 + R7_13 * t8_3 - R6_23 * t8_4;
  const T minus_P_omega1_8_33 = minus_P_omega1_7_33 + R7_13 * t8_5 + R6_23 * t8_6;
  // P_thetadot6_8 = -R7^T q8~ omega_thetadot6_7 + P_thetadot6_7: partial velocity of the body origin, inertial axes
  const T P_thetadot6_8_1 = t8_2 + t7_1;
  const T P_thetadot6_8_2 = t8_7 + t7_4;
  const T P_thetadot6_8_3 = t8_8 + t7_5;
  // P_thetadot7_8 = -R7^T q8~ b7: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot7_8_1 = R7_11 * T(0.2);
  const T minus_P_thetadot7_8_2 = R7_12 * T(0.2);
  const T minus_P_thetadot7_8_3 = R7_13 * T(0.2);
  // B21_1 = -R8^T r8~ omega_omega1_8 + P_omega1_8
  const T t8_9 = T(0.107388) * omega_omega1_8_11 + T(0.006435) * omega_omega1_8_31;
  const T t8_10 = R6_21 * t8_9;
  const T B21_1_11 = t8_10 + P_omega1_8_11;
  const T t8_11 = T(0.107388) * E6_22;
  const T t8_12 = T(0.107388) * omega_omega1_8_12 + T(0.006435) * omega_omega1_8_32;
  const T t8_13 = T(0.006435) * E6_22;
  const T minus_B21_1_12 = minus_P_omega1_8_12 + R8_11 * t8_11 - R6_21 * t8_12 + R8_31 * t8_13;
  const T t8_14 = T(0.107388) * E6_23;
  const T t8_15 = T(0.107388) * minus_omega_omega1_8_13 - T(0.006435) * omega_omega1_8_33;
  const T t8_16 = T(0.006435) * E6_23;
  const T minus_B21_1_13 = minus_P_omega1_8_13 + R8_11 * t8_14 + R6_21 * t8_15 + R8_31 * t8_16;
  const T t8_17 = R6_22 * t8_9;
  const T B21_1_21 = t8_17 + P_omega1_8_21;
  const T minus_B21_1_22 = minus_P_omega1_8_22 + R8_12 * t8_11 - R6_22 * t8_12 + R8_32 * t8_13;
  const T minus_B21_1_23 = minus_P_omega1_8_23 + R8_12 * t8_14 + R6_22 * t8_15 + R8_32 * t8_16;
  const T t8_18 = R6_23 * t8_9;
  const T B21_1_31 = t8_18 + P_omega1_8_31;
  const T minus_B21_1_32 = minus_P_omega1_8_32 + R8_13 * t8_11 - R6_23 * t8_12 + R8_33 * t8_13;
  const T minus_B21_1_33 = minus_P_omega1_8_33 + R8_13 * t8_14 + R6_23 * t8_15 + R8_33 * t8_16;
  v_y[378] = B21_1_11;
  v_y[379] = -minus_B21_1_12;
  v_y[380] = -minus_B21_1_13;
  v_y[396] = B21_1_21;
  v_y[397] = -minus_B21_1_22;
  v_y[398] = -minus_B21_1_23;
  v_y[414] = B21_1_31;
  v_y[415] = -minus_B21_1_32;
  v_y[416] = -minus_B21_1_33;
  // B22_6 = -R8^T r8~ omega_thetadot6_8 + P_thetadot6_8
  const T B22_6_1 = t8_10 + P_thetadot6_8_1;
  const T B22_6_2 = t8_17 + P_thetadot6_8_2;
  const T B22_6_3 = t8_18 + P_thetadot6_8_3;
  v_y[384] = B22_6_1;
  v_y[402] = B22_6_2;
  v_y[420] = B22_6_3;
  // B23_7 = -R8^T r8~ omega_thetadot7_8 + P_thetadot7_8
  const T t8_19 = R8_11 * T(0.107388) + R8_31 * T(0.006435);
  const T minus_B23_7_1 = t8_19 + minus_P_thetadot7_8_1;
  const T t8_20 = R8_12 * T(0.107388) + R8_32 * T(0.006435);
  const T minus_B23_7_2 = t8_20 + minus_P_thetadot7_8_2;
  const T t8_21 = R8_13 * T(0.107388) + R8_33 * T(0.006435);
  const T minus_B23_7_3 = t8_21 + minus_P_thetadot7_8_3;
  v_y[385] = -minus_B23_7_1;
  v_y[403] = -minus_B23_7_2;
  v_y[421] = -minus_B23_7_3;
  v_y[386] = -t8_19;
  v_y[404] = -t8_20;
  v_y[422] = -t8_21;
  // B25_1 = -R8^T o9~ omega_omega1_8 + P_omega1_8
  const T t8_22 = T(0.2) * omega_omega1_8_11;
  const T t8_23 = R6_21 * t8_22;
  const T B25_1_11 = t8_23 + P_omega1_8_11;
  const T t8_24 = T(0.2) * omega_omega1_8_12;
  const T minus_B25_1_12 = minus_P_omega1_8_12 + R8_11 * t8_3 - R6_21 * t8_24;
  const T t8_25 = T(0.2) * minus_omega_omega1_8_13;
  const T minus_B25_1_13 = minus_P_omega1_8_13 + R8_11 * t8_5 + R6_21 * t8_25;
  const T t8_26 = R6_22 * t8_22;
  const T B25_1_21 = t8_26 + P_omega1_8_21;
  const T minus_B25_1_22 = minus_P_omega1_8_22 + R8_12 * t8_3 - R6_22 * t8_24;
  const T minus_B25_1_23 = minus_P_omega1_8_23 + R8_12 * t8_5 + R6_22 * t8_25;
  const T t8_27 = R6_23 * t8_22;
  const T B25_1_31 = t8_27 + P_omega1_8_31;
  const T minus_B25_1_32 = minus_P_omega1_8_32 + R8_13 * t8_3 - R6_23 * t8_24;
  const T minus_B25_1_33 = minus_P_omega1_8_33 + R8_13 * t8_5 + R6_23 * t8_25;
  v_y[432] = B25_1_11;
  v_y[433] = -minus_B25_1_12;
  v_y[434] = -minus_B25_1_13;
  v_y[450] = B25_1_21;
  v_y[451] = -minus_B25_1_22;
  v_y[452] = -minus_B25_1_23;
  v_y[468] = B25_1_31;
  v_y[469] = -minus_B25_1_32;
  v_y[470] = -minus_B25_1_33;
  // B26_6 = -R8^T o9~ omega_thetadot6_8 + P_thetadot6_8
  const T B26_6_1 = t8_23 + P_thetadot6_8_1;
  const T B26_6_2 = t8_26 + P_thetadot6_8_2;
  const T B26_6_3 = t8_27 + P_thetadot6_8_3;
  v_y[438] = B26_6_1;
  v_y[456] = B26_6_2;
  v_y[474] = B26_6_3;
  // B27_7 = -R8^T o9~ omega_thetadot7_8 + P_thetadot7_8
  const T t8_28 = R8_11 * T(0.2);
  const T minus_B27_7_1 = t8_28 + minus_P_thetadot7_8_1;
  const T t8_29 = R8_12 * T(0.2);
  const T minus_B27_7_2 = t8_29 + minus_P_thetadot7_8_2;
  const T t8_30 = R8_13 * T(0.2);
  const T minus_B27_7_3 = t8_30 + minus_P_thetadot7_8_3;
  v_y[439] = -minus_B27_7_1;
  v_y[457] = -minus_B27_7_2;
  v_y[475] = -minus_B27_7_3;
  v_y[440] = -t8_28;
  v_y[458] = -t8_29;
  v_y[476] = -t8_30;

  // ---- body 10 (rr_hip) on body 1
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];
  // R10^T = R1^T E10^T: R takes inertial components to body components
  const T R10_21 = R1_21 * E10_22 + R1_31 * E10_23;
  const T R10_22 = R1_22 * E10_22 + R1_32 * E10_23;
  const T R10_23 = R1_23 * E10_22 + R1_33 * E10_23;
  const T R10_31 = R1_31 * E10_22 - R1_21 * E10_23;
  const T R10_32 = R1_32 * E10_22 - R1_22 * E10_23;
  const T R10_33 = R1_33 * E10_22 - R1_23 * E10_23;
  // B29_1 = -R10^T r10~ E10 + P_omega1_10
  const T t10_1 = R10_21 * T(3.1e-05) + R10_31 * T(0.000635);
  const T minus_B29_1_11 = t10_1 + minus_P_omega1_2_11;
  const T t10_2 = T(0.000635) * E10_23 - T(3.1e-05) * E10_22;
  const T t10_3 = T(0.003311) * E10_23;
  const T t10_4 = T(0.003311) * E10_22;
  const T minus_B29_1_12 = R1_11 * t10_2 - minus_P_omega1_2_12 + R10_21 * t10_3 + R10_31 * t10_4;
  const T t10_5 = T(3.1e-05) * E10_23 + T(0.000635) * E10_22;
  const T minus_B29_1_13 = R10_31 * t10_3 - (minus_P_omega1_6_13 + R1_11 * t10_5 + R10_21 * t10_4);
  const T t10_6 = R10_22 * T(3.1e-05) + R10_32 * T(0.000635);
  const T minus_B29_1_21 = t10_6 + minus_P_omega1_2_21;
  const T minus_B29_1_22 = R1_12 * t10_2 - minus_P_omega1_2_22 + R10_22 * t10_3 + R10_32 * t10_4;
  const T minus_B29_1_23 = R10_32 * t10_3 - (minus_P_omega1_6_23 + R1_12 * t10_5 + R10_22 * t10_4);
  const T t10_7 = R10_23 * T(3.1e-05) + R10_33 * T(0.000635);
  const T minus_B29_1_31 = t10_7 + minus_P_omega1_2_31;
  const T minus_B29_1_32 = R1_13 * t10_2 - minus_P_omega1_2_32 + R10_23 * t10_3 + R10_33 * t10_4;
  const T minus_B29_1_33 = R10_33 * t10_3 - (minus_P_omega1_6_33 + R1_13 * t10_5 + R10_23 * t10_4);
  v_y[486] = -minus_B29_1_11;
  v_y[487] = -minus_B29_1_12;
  v_y[488] = -minus_B29_1_13;
  v_y[504] = -minus_B29_1_21;
  v_y[505] = -minus_B29_1_22;
  v_y[506] = -minus_B29_1_23;
  v_y[522] = -minus_B29_1_31;
  v_y[523] = -minus_B29_1_32;
  v_y[524] = -minus_B29_1_33;
  v_y[495] = -t10_1;
  v_y[513] = -t10_6;
  v_y[531] = -t10_7;

  // ---- body 11 (rr_thigh) on body 10
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R1_11 * E11_11 - R10_31 * minus_E11_13;
  const T R11_12 = R1_12 * E11_11 - R10_32 * minus_E11_13;
  const T R11_13 = R1_13 * E11_11 - R10_33 * minus_E11_13;
  const T R11_31 = R1_11 * minus_E11_13 + R10_31 * E11_11;
  const T R11_32 = R1_12 * minus_E11_13 + R10_32 * E11_11;
  const T R11_33 = R1_13 * minus_E11_13 + R10_33 * E11_11;
  // omega_omega1_11 = E11 E10: partial angular velocity, body axes
  const T omega_omega1_11_12 = minus_E11_13 * E10_23;
  const T minus_omega_omega1_11_13 = minus_E11_13 * E10_22;
  const T minus_omega_omega1_11_32 = E11_11 * E10_23;
  const T omega_omega1_11_33 = E11_11 * E10_22;
  // P_omega1_11 = -R10^T q11~ E10 + P_omega1_10: partial velocity of the body origin, inertial axes
  const T t11_1 = R10_31 * T(0.0838);
  const T minus_P_omega1_11_11 = t11_1 + minus_P_omega1_2_11;
  const T t11_2 = T(0.0838) * E10_23;
  const T minus_P_omega1_11_12 = R1_11 * t11_2 - minus_P_omega1_2_12;
  const T t11_3 = T(0.0838) * E10_22;
  const T P_omega1_11_13 = minus_P_omega1_6_13 + R1_11 * t11_3;
  const T t11_4 = R10_32 * T(0.0838);
  const T minus_P_omega1_11_21 = t11_4 + minus_P_omega1_2_21;
  const T minus_P_omega1_11_22 = R1_12 * t11_2 - minus_P_omega1_2_22;
  const T P_omega1_11_23 = minus_P_omega1_6_23 + R1_12 * t11_3;
  const T t11_5 = R10_33 * T(0.0838);
  const T minus_P_omega1_11_31 = t11_5 + minus_P_omega1_2_31;
  const T minus_P_omega1_11_32 = R1_13 * t11_2 - minus_P_omega1_2_32;
  const T P_omega1_11_33 = minus_P_omega1_6_33 + R1_13 * t11_3;
  // B31_1 = -R11^T r11~ omega_omega1_11 + P_omega1_11
  const T t11_6 = T(0.022327) * minus_E11_13;
  const T t11_7 = T(0.003237) * minus_E11_13 - T(0.027326) * E11_11;
  const T t11_8 = T(0.022327) * E11_11;
  const T t11_9 = R11_11 * t11_6 + R10_21 * t11_7 - R11_31 * t11_8;
  const T minus_B31_1_11 = t11_9 + minus_P_omega1_11_11;
  const T t11_10 = T(0.027326) * E10_22 - T(0.022327) * minus_omega_omega1_11_32;
  const T t11_11 = T(0.027326) * omega_omega1_11_12 + T(0.003237) * minus_omega_omega1_11_32;
  const T t11_12 = T(0.003237) * E10_22 + T(0.022327) * omega_omega1_11_12;
  const T minus_B31_1_12 = minus_P_omega1_11_12 + R11_11 * t11_10 - R10_21 * t11_11 - R11_31 * t11_12;
  const T t11_13 = T(0.027326) * E10_23 + T(0.022327) * omega_omega1_11_33;
  const T t11_14 = T(0.027326) * minus_omega_omega1_11_13 + T(0.003237) * omega_omega1_11_33;
  const T t11_15 = T(0.022327) * minus_omega_omega1_11_13 - T(0.003237) * E10_23;
  const T minus_B31_1_13 = R11_11 * t11_13 - P_omega1_11_13 + R10_21 * t11_14 + R11_31 * t11_15;
  const T t11_16 = R11_12 * t11_6 + R10_22 * t11_7 - R11_32 * t11_8;
  const T minus_B31_1_21 = t11_16 + minus_P_omega1_11_21;
  const T minus_B31_1_22 = minus_P_omega1_11_22 + R11_12 * t11_10 - R10_22 * t11_11 - R11_32 * t11_12;
  const T minus_B31_1_23 = R11_12 * t11_13 - P_omega1_11_23 + R10_22 * t11_14 + R11_32 * t11_15;
  const T t11_17 = R11_13 * t11_6 + R10_23 * t11_7 - R11_33 * t11_8;
  const T minus_B31_1_31 = t11_17 + minus_P_omega1_11_31;
  const T minus_B31_1_32 = minus_P_omega1_11_32 + R11_13 * t11_10 - R10_23 * t11_11 - R11_33 * t11_12;
  const T minus_B31_1_33 = R11_13 * t11_13 - P_omega1_11_33 + R10_23 * t11_14 + R11_33 * t11_15;
  v_y[540] = -minus_B31_1_11;
  v_y[541] = -minus_B31_1_12;
  v_y[542] = -minus_B31_1_13;
  v_y[558] = -minus_B31_1_21;
  v_y[559] = -minus_B31_1_22;
  v_y[560] = -minus_B31_1_23;
  v_y[576] = -minus_B31_1_31;
  v_y[577] = -minus_B31_1_32;
  v_y[578] = -minus_B31_1_33;
  // B32_10 = -R11^T r11~ omega_thetadot10_11 + P_thetadot10_11
  const T minus_B32_10_1 = t11_9 + t11_1;
  const T minus_B32_10_2 = t11_16 + t11_4;
  const T minus_B32_10_3 = t11_17 + t11_5;
  v_y[549] = -minus_B32_10_1;
  v_y[567] = -minus_B32_10_2;
  v_y[585] = -minus_B32_10_3;
  // B33_11 = -R11^T r11~ b11
  const T minus_B33_11_1 = R11_11 * T(0.027326) - R11_31 * T(0.003237);
  const T minus_B33_11_2 = R11_12 * T(0.027326) - R11_32 * T(0.003237);
  const T minus_B33_11_3 = R11_13 * T(0.027326) - R11_33 * T(0.003237);
  v_y[550] = -minus_B33_11_1;
  v_y[568] = -minus_B33_11_2;
  v_y[586] = -minus_B33_11_3;

  // ---- body 12 (rr_calf) on body 11
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_11 = cosines[12];
  const T minus_E12_13 = sines[12];
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T R12_11 = R11_11 * E12_11 - R11_31 * minus_E12_13;
  const T R12_12 = R11_12 * E12_11 - R11_32 * minus_E12_13;
  const T R12_13 = R11_13 * E12_11 - R11_33 * minus_E12_13;
  const T R12_31 = R11_11 * minus_E12_13 + R11_31 * E12_11;
  const T R12_32 = R11_12 * minus_E12_13 + R11_32 * E12_11;
  const T R12_33 = R11_13 * minus_E12_13 + R11_33 * E12_11;
  // omega_omega1_12 = E12 omega_omega1_11: partial angular velocity, body axes
  const T omega_omega1_12_11 = E12_11 * E11_11 - minus_E12_13 * minus_E11_13;
  const T omega_omega1_12_12 = E12_11 * omega_omega1_11_12 + minus_E12_13 * minus_omega_omega1_11_32;
  const T minus_omega_omega1_12_13 = E12_11 * minus_omega_omega1_11_13 + minus_E12_13 * omega_omega1_11_33;
  const T omega_omega1_12_31 = minus_E12_13 * E11_11 + E12_11 * minus_E11_13;
  const T omega_omega1_12_32 = minus_E12_13 * omega_omega1_11_12 - E12_11 * minus_omega_omega1_11_32;
  const T omega_omega1_12_33 = E12_11 * omega_omega1_11_33 - minus_E12_13 * minus_omega_omega1_11_13;
  // P_omega1_12 = -R11^T q12~ omega_omega1_11 + P_omega1_11: partial velocity of the body origin, inertial axes
  const T t12_1 = T(0.2) * E11_11;
  const T t12_2 = R10_21 * t12_1;
  const T minus_P_omega1_12_11 = minus_P_omega1_11_11 - t12_2;
  const T t12_3 = T(0.2) * E10_22;
  const T t12_4 = T(0.2) * omega_omega1_11_12;
  const T minus_P_omega1_12_12 = minus_P_omega1_11_12 + R11_11 * t12_3 - R10_21 * t12_4;
  const T t12_5 = T(0.2) * E10_23;
  const T t12_6 = T(0.2) * minus_omega_omega1_11_13;
  const T minus_P_omega1_12_13 = R11_11 * t12_5 - P_omega1_11_13 + R10_21 * t12_6;
  const T t12_7 = R10_22 * t12_1;
  const T minus_P_omega1_12_21 = minus_P_omega1_11_21 - t12_7;
  const T minus_P_omega1_12_22 = minus_P_omega1_11_22 + R11_12 * t12_3 - R10_22 * t12_4;
  const T minus_P_omega1_12_23 = R11_12 * t12_5 - P_omega1_11_23 + R10_22 * t12_6;
  const T t12_8 = R10_23 * t12_1;
  const T minus_P_omega1_12_31 = minus_P_omega1_11_31 - t12_8;
  const T minus_P_omega1_12_32 = minus_P_omega1_11_32 + R11_13 * t12_3 - R10_23 * t12_4;
  const T minus_P_omega1_12_33 = R11_13 * t12_5 - P_omega1_11_33 + R10_23 * t12_6;
  // P_thetadot10_12 = -R11^T q12~ omega_thetadot10_11 + P_thetadot10_11: partial velocity of the body origin,
  //   inertial axes
  const T minus_P_thetadot10_12_1 = t11_1 - t12_2;
  const T minus_P_thetadot10_12_2 = t11_4 - t12_7;
  const T minus_P_thetadot10_12_3 = t11_5 - t12_8;
  // P_thetadot11_12 = -R11^T q12~ b11: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot11_12_1 = R11_11 * T(0.2);
  const T minus_P_thetadot11_12_2 = R11_12 * T(0.2);
  const T minus_P_thetadot11_12_3 = R11_13 * T(0.2);
  // B34_1 = -R12^T r12~ omega_omega1_12 + P_omega1_12
  const T t12_9 = T(0.107388) * omega_omega1_12_11 + T(0.006435) * omega_omega1_12_31;
  const T t12_10 = R10_21 * t12_9;
  const T minus_B34_1_11 = minus_P_omega1_12_11 - t12_10;
  const T t12_11 = T(0.107388) * E10_22;
  const T t12_12 = T(0.107388) * omega_omega1_12_12 + T(0.006435) * omega_omega1_12_32;
  const T t12_13 = T(0.006435) * E10_22;
  const T minus_B34_1_12 = minus_P_omega1_12_12 + R12_11 * t12_11 - R10_21 * t12_12 + R12_31 * t12_13;
  const T t12_14 = T(0.107388) * E10_23;
  const T t12_15 = T(0.107388) * minus_omega_omega1_12_13 - T(0.006435) * omega_omega1_12_33;
  const T t12_16 = T(0.006435) * E10_23;
  const T minus_B34_1_13 = minus_P_omega1_12_13 + R12_11 * t12_14 + R10_21 * t12_15 + R12_31 * t12_16;
  const T t12_17 = R10_22 * t12_9;
  const T minus_B34_1_21 = minus_P_omega1_12_21 - t12_17;
  const T minus_B34_1_22 = minus_P_omega1_12_22 + R12_12 * t12_11 - R10_22 * t12_12 + R12_32 * t12_13;
  const T minus_B34_1_23 = minus_P_omega1_12_23 + R12_12 * t12_14 + R10_22 * t12_15 + R12_32 * t12_16;
  const T t12_18 = R10_23 * t12_9;
  const T minus_B34_1_31 = minus_P_omega1_12_31 - t12_18;
  const T minus_B34_1_32 = minus_P_omega1_12_32 + R12_13 * t12_11 - R10_23 * t12_12 + R12_33 * t12_13;
  const T minus_B34_1_33 = minus_P_omega1_12_33 + R12_13 * t12_14 + R10_23 * t12_15 + R12_33 * t12_16;
  v_y[594] = -minus_B34_1_11;
  v_y[595] = -minus_B34_1_12;
  v_y[596] = -minus_B34_1_13;
  v_y[612] = -minus_B34_1_21;
  v_y[613] = -minus_B34_1_22;
  v_y[614] = -minus_B34_1_23;
  v_y[630] = -minus_B34_1_31;
  v_y[631] = -minus_B34_1_32;
  v_y[632] = -minus_B34_1_33;
  // B35_10 = -R12^T r12~ omega_thetadot10_12 + P_thetadot10_12
  const T minus_B35_10_1 = minus_P_thetadot10_12_1 - t12_10;
  const T minus_B35_10_2 = minus_P_thetadot10_12_2 - t12_17;
  const T minus_B35_10_3 = minus_P_thetadot10_12_3 - t12_18;
  v_y[603] = -minus_B35_10_1;
  v_y[621] = -minus_B35_10_2;
  v_y[639] = -minus_B35_10_3;
  // B36_11 = -R12^T r12~ omega_thetadot11_12 + P_thetadot11_12
  const T t12_19 = R12_11 * T(0.107388) + R12_31 * T(0.006435);
  const T minus_B36_11_1 = t12_19 + minus_P_thetadot11_12_1;
  const T t12_20 = R12_12 * T(0.107388) + R12_32 * T(0.006435);
  const T minus_B36_11_2 = t12_20 + minus_P_thetadot11_12_2;
  const T t12_21 = R12_13 * T(0.107388) + R12_33 * T(0.006435);
  const T minus_B36_11_3 = t12_21 + minus_P_thetadot11_12_3;
  v_y[604] = -minus_B36_11_1;
  v_y[622] = -minus_B36_11_2;
  v_y[640] = -minus_B36_11_3;
  v_y[605] = -t12_19;
  v_y[623] = -t12_20;
  v_y[641] = -t12_21;
  // B38_1 = -R12^T o13~ omega_omega1_12 + P_omega1_12
  const T t12_22 = T(0.2) * omega_omega1_12_11;
  const T t12_23 = R10_21 * t12_22;
  const T minus_B38_1_11 = minus_P_omega1_12_11 - t12_23;
  const T t12_24 = T(0.2) * omega_omega1_12_12;
  const T minus_B38_1_12 = minus_P_omega1_12_12 + R12_11 * t12_3 - R10_21 * t12_24;
  const T t12_25 = T(0.2) * minus_omega_omega1_12_13;
  const T minus_B38_1_13 = minus_P_omega1_12_13 + R12_11 * t12_5 + R10_21 * t12_25;
  const T t12_26 = R10_22 * t12_22;
  const T minus_B38_1_21 = minus_P_omega1_12_21 - t12_26;
  const T minus_B38_1_22 = minus_P_omega1_12_22 + R12_12 * t12_3 - R10_22 * t12_24;
  const T minus_B38_1_23 = minus_P_omega1_12_23 + R12_12 * t12_5 + R10_22 * t12_25;
  const T t12_27 = R10_23 * t12_22;
  const T minus_B38_1_31 = minus_P_omega1_12_31 - t12_27;
  const T minus_B38_1_32 = minus_P_omega1_12_32 + R12_13 * t12_3 - R10_23 * t12_24;
  const T minus_B38_1_33 = minus_P_omega1_12_33 + R12_13 * t12_5 + R10_23 * t12_25;
  v_y[648] = -minus_B38_1_11;
  v_y[649] = -minus_B38_1_12;
  v_y[650] = -minus_B38_1_13;
  v_y[666] = -minus_B38_1_21;
  v_y[667] = -minus_B38_1_22;
  v_y[668] = -minus_B38_1_23;
  v_y[684] = -minus_B38_1_31;
  v_y[685] = -minus_B38_1_32;
  v_y[686] = -minus_B38_1_33;
  // B39_10 = -R12^T o13~ omega_thetadot10_12 + P_thetadot10_12
  const T minus_B39_10_1 = minus_P_thetadot10_12_1 - t12_23;
  const T minus_B39_10_2 = minus_P_thetadot10_12_2 - t12_26;
  const T minus_B39_10_3 = minus_P_thetadot10_12_3 - t12_27;
  v_y[657] = -minus_B39_10_1;
  v_y[675] = -minus_B39_10_2;
  v_y[693] = -minus_B39_10_3;
  // B40_11 = -R12^T o13~ omega_thetadot11_12 + P_thetadot11_12
  const T t12_28 = R12_11 * T(0.2);
  const T minus_B40_11_1 = t12_28 + minus_P_thetadot11_12_1;
  const T t12_29 = R12_12 * T(0.2);
  const T minus_B40_11_2 = t12_29 + minus_P_thetadot11_12_2;
  const T t12_30 = R12_13 * T(0.2);
  const T minus_B40_11_3 = t12_30 + minus_P_thetadot11_12_3;
  v_y[658] = -minus_B40_11_1;
  v_y[676] = -minus_B40_11_2;
  v_y[694] = -minus_B40_11_3;
  v_y[659] = -t12_28;
  v_y[677] = -t12_29;
  v_y[695] = -t12_30;

  // ---- body 14 (rl_hip) on body 1
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];
  // R14^T = R1^T E14^T: R takes inertial components to body components
  const T R14_21 = R1_21 * E14_22 + R1_31 * E14_23;
  const T R14_22 = R1_22 * E14_22 + R1_32 * E14_23;
  const T R14_23 = R1_23 * E14_22 + R1_33 * E14_23;
  const T R14_31 = R1_31 * E14_22 - R1_21 * E14_23;
  const T R14_32 = R1_32 * E14_22 - R1_22 * E14_23;
  const T R14_33 = R1_33 * E14_22 - R1_23 * E14_23;
  // B42_1 = -R14^T r14~ E14 + P_omega1_14
  const T t14_1 = R14_21 * T(3.1e-05) - R14_31 * T(0.000635);
  const T minus_B42_1_11 = t14_1 - minus_P_omega1_2_11;
  const T t14_2 = T(0.003311) * E14_23;
  const T t14_3 = T(3.1e-05) * E14_22 + T(0.000635) * E14_23;
  const T t14_4 = T(0.003311) * E14_22;
  const T minus_B42_1_12 = R14_21 * t14_2 - minus_P_omega1_2_12 - R1_11 * t14_3 + R14_31 * t14_4;
  const T t14_5 = T(0.000635) * E14_22 - T(3.1e-05) * E14_23;
  const T minus_B42_1_13 = P_omega1_2_13 + R1_11 * t14_5 - R14_21 * t14_4 + R14_31 * t14_2;
  const T t14_6 = R14_22 * T(3.1e-05) - R14_32 * T(0.000635);
  const T minus_B42_1_21 = t14_6 - minus_P_omega1_2_21;
  const T minus_B42_1_22 = R14_22 * t14_2 - minus_P_omega1_2_22 - R1_12 * t14_3 + R14_32 * t14_4;
  const T minus_B42_1_23 = P_omega1_2_23 + R1_12 * t14_5 - R14_22 * t14_4 + R14_32 * t14_2;
  const T t14_7 = R14_23 * T(3.1e-05) - R14_33 * T(0.000635);
  const T minus_B42_1_31 = t14_7 - minus_P_omega1_2_31;
  const T minus_B42_1_32 = R14_23 * t14_2 - minus_P_omega1_2_32 - R1_13 * t14_3 + R14_33 * t14_4;
  const T minus_B42_1_33 = P_omega1_2_33 + R1_13 * t14_5 - R14_23 * t14_4 + R14_33 * t14_2;
  v_y[702] = -minus_B42_1_11;
  v_y[703] = -minus_B42_1_12;
  v_y[704] = -minus_B42_1_13;
  v_y[720] = -minus_B42_1_21;
  v_y[721] = -minus_B42_1_22;
  v_y[722] = -minus_B42_1_23;
  v_y[738] = -minus_B42_1_31;
  v_y[739] = -minus_B42_1_32;
  v_y[740] = -minus_B42_1_33;
  v_y[714] = -t14_1;
  v_y[732] = -t14_6;
  v_y[750] = -t14_7;

  // ---- body 15 (rl_thigh) on body 14
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_11 = R1_11 * E15_11 - R14_31 * minus_E15_13;
  const T R15_12 = R1_12 * E15_11 - R14_32 * minus_E15_13;
  const T R15_13 = R1_13 * E15_11 - R14_33 * minus_E15_13;
  const T R15_31 = R1_11 * minus_E15_13 + R14_31 * E15_11;
  const T R15_32 = R1_12 * minus_E15_13 + R14_32 * E15_11;
  const T R15_33 = R1_13 * minus_E15_13 + R14_33 * E15_11;
  // omega_omega1_15 = E15 E14: partial angular velocity, body axes
  const T omega_omega1_15_12 = minus_E15_13 * E14_23;
  const T minus_omega_omega1_15_13 = minus_E15_13 * E14_22;
  const T minus_omega_omega1_15_32 = E15_11 * E14_23;
  const T omega_omega1_15_33 = E15_11 * E14_22;
  // P_omega1_15 = -R14^T q15~ E14 + P_omega1_14: partial velocity of the body origin, inertial axes
  const T t15_1 = R14_31 * T(0.0838);
  const T P_omega1_15_11 = t15_1 + minus_P_omega1_2_11;
  const T t15_2 = T(0.0838) * E14_23;
  const T P_omega1_15_12 = minus_P_omega1_2_12 + R1_11 * t15_2;
  const T t15_3 = T(0.0838) * E14_22;
  const T minus_P_omega1_15_13 = P_omega1_2_13 + R1_11 * t15_3;
  const T t15_4 = R14_32 * T(0.0838);
  const T P_omega1_15_21 = t15_4 + minus_P_omega1_2_21;
  const T P_omega1_15_22 = minus_P_omega1_2_22 + R1_12 * t15_2;
  const T minus_P_omega1_15_23 = P_omega1_2_23 + R1_12 * t15_3;
  const T t15_5 = R14_33 * T(0.0838);
  const T P_omega1_15_31 = t15_5 + minus_P_omega1_2_31;
  const T P_omega1_15_32 = minus_P_omega1_2_32 + R1_13 * t15_2;
  const T minus_P_omega1_15_33 = P_omega1_2_33 + R1_13 * t15_3;
  // B44_1 = -R15^T r15~ omega_omega1_15 + P_omega1_15
  const T t15_6 = T(0.003237) * minus_E15_13 - T(0.027326) * E15_11;
  const T t15_7 = T(0.022327) * minus_E15_13;
  const T t15_8 = T(0.022327) * E15_11;
  const T t15_9 = R14_21 * t15_6 - R15_11 * t15_7 + R15_31 * t15_8;
  const T minus_B44_1_11 = t15_9 - P_omega1_15_11;
  const T t15_10 = T(0.027326) * E14_22 + T(0.022327) * minus_omega_omega1_15_32;
  const T t15_11 = T(0.027326) * omega_omega1_15_12 + T(0.003237) * minus_omega_omega1_15_32;
  const T t15_12 = T(0.022327) * omega_omega1_15_12 - T(0.003237) * E14_22;
  const T minus_B44_1_12 = R15_11 * t15_10 - P_omega1_15_12 - R14_21 * t15_11 + R15_31 * t15_12;
  const T t15_13 = T(0.027326) * E14_23 - T(0.022327) * omega_omega1_15_33;
  const T t15_14 = T(0.027326) * minus_omega_omega1_15_13 + T(0.003237) * omega_omega1_15_33;
  const T t15_15 = T(0.003237) * E14_23 + T(0.022327) * minus_omega_omega1_15_13;
  const T minus_B44_1_13 = minus_P_omega1_15_13 + R15_11 * t15_13 + R14_21 * t15_14 - R15_31 * t15_15;
  const T t15_16 = R14_22 * t15_6 - R15_12 * t15_7 + R15_32 * t15_8;
  const T minus_B44_1_21 = t15_16 - P_omega1_15_21;
  const T minus_B44_1_22 = R15_12 * t15_10 - P_omega1_15_22 - R14_22 * t15_11 + R15_32 * t15_12;
  const T minus_B44_1_23 = minus_P_omega1_15_23 + R15_12 * t15_13 + R14_22 * t15_14 - R15_32 * t15_15;
  const T t15_17 = R14_23 * t15_6 - R15_13 * t15_7 + R15_33 * t15_8;
  const T minus_B44_1_31 = t15_17 - P_omega1_15_31;
  const T minus_B44_1_32 = R15_13 * t15_10 - P_omega1_15_32 - R14_23 * t15_11 + R15_33 * t15_12;
  const T minus_B44_1_33 = minus_P_omega1_15_33 + R15_13 * t15_13 + R14_23 * t15_14 - R15_33 * t15_15;
  v_y[756] = -minus_B44_1_11;
  v_y[757] = -minus_B44_1_12;
  v_y[758] = -minus_B44_1_13;
  v_y[774] = -minus_B44_1_21;
  v_y[775] = -minus_B44_1_22;
  v_y[776] = -minus_B44_1_23;
  v_y[792] = -minus_B44_1_31;
  v_y[793] = -minus_B44_1_32;
  v_y[794] = -minus_B44_1_33;
  // B45_14 = -R15^T r15~ omega_thetadot14_15 + P_thetadot14_15
  const T minus_B45_14_1 = t15_9 - t15_1;
  const T minus_B45_14_2 = t15_16 - t15_4;
  const T minus_B45_14_3 = t15_17 - t15_5;
  v_y[768] = -minus_B45_14_1;
  v_y[786] = -minus_B45_14_2;
  v_y[804] = -minus_B45_14_3;
  // B46_15 = -R15^T r15~ b15
  const T minus_B46_15_1 = R15_11 * T(0.027326) - R15_31 * T(0.003237);
  const T minus_B46_15_2 = R15_12 * T(0.027326) - R15_32 * T(0.003237);
  const T minus_B46_15_3 = R15_13 * T(0.027326) - R15_33 * T(0.003237);
  v_y[769] = -minus_B46_15_1;
  v_y[787] = -minus_B46_15_2;
  v_y[805] = -minus_B46_15_3;

  // ---- body 16 (rl_calf) on body 15
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cosines[15];
  const T minus_E16_13 = sines[15];
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T R16_11 = R15_11 * E16_11 - R15_31 * minus_E16_13;
  const T R16_12 = R15_12 * E16_11 - R15_32 * minus_E16_13;
  const T R16_13 = R15_13 * E16_11 - R15_33 * minus_E16_13;
  const T R16_31 = R15_11 * minus_E16_13 + R15_31 * E16_11;
  const T R16_32 = R15_12 * minus_E16_13 + R15_32 * E16_11;
  const T R16_33 = R15_13 * minus_E16_13 + R15_33 * E16_11;
  // omega_omega1_16 = E16 omega_omega1_15: partial angular velocity, body axes
  const T omega_omega1_16_11 = E16_11 * E15_11 - minus_E16_13 * minus_E15_13;
  const T omega_omega1_16_12 = E16_11 * omega_omega1_15_12 + minus_E16_13 * minus_omega_omega1_15_32;
  const T minus_omega_omega1_16_13 = E16_11 * minus_omega_omega1_15_13 + minus_E16_13 * omega_omega1_15_33;
  const T omega_omega1_16_31 = minus_E16_13 * E15_11 + E16_11 * minus_E15_13;
  const T omega_omega1_16_32 = minus_E16_13 * omega_omega1_15_12 - E16_11 * minus_omega_omega1_15_32;
  const T omega_omega1_16_33 = E16_11 * omega_omega1_15_33 - minus_E16_13 * minus_omega_omega1_15_13;
  // P_omega1_16 = -R15^T q16~ omega_omega1_15 + P_omega1_15: partial velocity of the body origin, inertial axes
  const T t16_1 = T(0.2) * E15_11;
  const T t16_2 = R14_21 * t16_1;
  const T P_omega1_16_11 = t16_2 + P_omega1_15_11;
  const T t16_3 = T(0.2) * E14_22;
  const T t16_4 = T(0.2) * omega_omega1_15_12;
  const T minus_P_omega1_16_12 = R15_11 * t16_3 - P_omega1_15_12 - R14_21 * t16_4;
  const T t16_5 = T(0.2) * E14_23;
  const T t16_6 = T(0.2) * minus_omega_omega1_15_13;
  const T minus_P_omega1_16_13 = minus_P_omega1_15_13 + R15_11 * t16_5 + R14_21 * t16_6;
  const T t16_7 = R14_22 * t16_1;
  const T P_omega1_16_21 = t16_7 + P_omega1_15_21;
  const T minus_P_omega1_16_22 = R15_12 * t16_3 - P_omega1_15_22 - R14_22 * t16_4;
  const T minus_P_omega1_16_23 = minus_P_omega1_15_23 + R15_12 * t16_5 + R14_22 * t16_6;
  const T t16_8 = R14_23 * t16_1;
  const T P_omega1_16_31 = t16_8 + P_omega1_15_31;
  const T minus_P_omega1_16_32 = R15_13 * t16_3 - P_omega1_15_32 - R14_23 * t16_4;
  const T minus_P_omega1_16_33 = minus_P_omega1_15_33 + R15_13 * t16_5 + R14_23 * t16_6;
  // P_thetadot14_16 = -R15^T q16~ omega_thetadot14_15 + P_thetadot14_15: partial velocity of the body origin,
  //   inertial axes
  const T P_thetadot14_16_1 = t16_2 + t15_1;
  const T P_thetadot14_16_2 = t16_7 + t15_4;
  const T P_thetadot14_16_3 = t16_8 + t15_5;
  // P_thetadot15_16 = -R15^T q16~ b15: partial velocity of the body origin, inertial axes
  const T minus_P_thetadot15_16_1 = R15_11 * T(0.2);
  const T minus_P_thetadot15_16_2 = R15_12 * T(0.2);
  const T minus_P_thetadot15_16_3 = R15_13 * T(0.2);
  // B47_1 = -R16^T r16~ omega_omega1_16 + P_omega1_16
  const T t16_9 = T(0.107388) * omega_omega1_16_11 + T(0.006435) * omega_omega1_16_31;
  const T t16_10 = R14_21 * t16_9;
  const T B47_1_11 = t16_10 + P_omega1_16_11;
  const T t16_11 = T(0.107388) * E14_22;
  const T t16_12 = T(0.107388) * omega_omega1_16_12 + T(0.006435) * omega_omega1_16_32;
  const T t16_13 = T(0.006435) * E14_22;
  const T minus_B47_1_12 = minus_P_omega1_16_12 + R16_11 * t16_11 - R14_21 * t16_12 + R16_31 * t16_13;
  const T t16_14 = T(0.107388) * E14_23;
  const T t16_15 = T(0.107388) * minus_omega_omega1_16_13 - T(0.006435) * omega_omega1_16_33;
  const T t16_16 = T(0.006435) * E14_23;
  const T minus_B47_1_13 = minus_P_omega1_16_13 + R16_11 * t16_14 + R14_21 * t16_15 + R16_31 * t16_16;
  const T t16_17 = R14_22 * t16_9;
  const T B47_1_21 = t16_17 + P_omega1_16_21;
  const T minus_B47_1_22 = minus_P_omega1_16_22 + R16_12 * t16_11 - R14_22 * t16_12 + R16_32 * t16_13;
  const T minus_B47_1_23 = minus_P_omega1_16_23 + R16_12 * t16_14 + R14_22 * t16_15 + R16_32 * t16_16;
  const T t16_18 = R14_23 * t16_9;
  const T B47_1_31 = t16_18 + P_omega1_16_31;
  const T minus_B47_1_32 = minus_P_omega1_16_32 + R16_13 * t16_11 - R14_23 * t16_12 + R16_33 * t16_13;
  const T minus_B47_1_33 = minus_P_omega1_16_33 + R16_13 * t16_14 + R14_23 * t16_15 + R16_33 * t16_16;
  v_y[810] = B47_1_11;
  v_y[811] = -minus_B47_1_12;
  v_y[812] = -minus_B47_1_13;
  v_y[828] = B47_1_21;
  v_y[829] = -minus_B47_1_22;
  v_y[830] = -minus_B47_1_23;
  v_y[846] = B47_1_31;
  v_y[847] = -minus_B47_1_32;
  v_y[848] = -minus_B47_1_33;
  // B48_14 = -R16^T r16~ omega_thetadot14_16 + P_thetadot14_16
  const T B48_14_1 = t16_10 + P_thetadot14_16_1;
  const T B48_14_2 = t16_17 + P_thetadot14_16_2;
  const T B48_14_3 = t16_18 + P_thetadot14_16_3;
  v_y[822] = B48_14_1;
  v_y[840] = B48_14_2;
  v_y[858] = B48_14_3;
  // B49_15 = -R16^T r16~ omega_thetadot15_16 + P_thetadot15_16
  const T t16_19 = R16_11 * T(0.107388) + R16_31 * T(0.006435);
  const T minus_B49_15_1 = t16_19 + minus_P_thetadot15_16_1;
  const T t16_20 = R16_12 * T(0.107388) + R16_32 * T(0.006435);
  const T minus_B49_15_2 = t16_20 + minus_P_thetadot15_16_2;
  const T t16_21 = R16_13 * T(0.107388) + R16_33 * T(0.006435);
  const T minus_B49_15_3 = t16_21 + minus_P_thetadot15_16_3;
  v_y[823] = -minus_B49_15_1;
  v_y[841] = -minus_B49_15_2;
  v_y[859] = -minus_B49_15_3;
  v_y[824] = -t16_19;
  v_y[842] = -t16_20;
  v_y[860] = -t16_21;
  // B51_1 = -R16^T o17~ omega_omega1_16 + P_omega1_16
  const T t16_22 = T(0.2) * omega_omega1_16_11;
  const T t16_23 = R14_21 * t16_22;
  const T B51_1_11 = t16_23 + P_omega1_16_11;
  const T t16_24 = T(0.2) * omega_omega1_16_12;
  const T minus_B51_1_12 = minus_P_omega1_16_12 + R16_11 * t16_3 - R14_21 * t16_24;
  const T t16_25 = T(0.2) * minus_omega_omega1_16_13;
  const T minus_B51_1_13 = minus_P_omega1_16_13 + R16_11 * t16_5 + R14_21 * t16_25;
  const T t16_26 = R14_22 * t16_22;
  const T B51_1_21 = t16_26 + P_omega1_16_21;
  const T minus_B51_1_22 = minus_P_omega1_16_22 + R16_12 * t16_3 - R14_22 * t16_24;
  const T minus_B51_1_23 = minus_P_omega1_16_23 + R16_12 * t16_5 + R14_22 * t16_25;
  const T t16_27 = R14_23 * t16_22;
  const T B51_1_31 = t16_27 + P_omega1_16_31;
  const T minus_B51_1_32 = minus_P_omega1_16_32 + R16_13 * t16_3 - R14_23 * t16_24;
  const T minus_B51_1_33 = minus_P_omega1_16_33 + R16_13 * t16_5 + R14_23 * t16_25;
  v_y[864] = B51_1_11;
  v_y[865] = -minus_B51_1_12;
  v_y[866] = -minus_B51_1_13;
  v_y[882] = B51_1_21;
  v_y[883] = -minus_B51_1_22;
  v_y[884] = -minus_B51_1_23;
  v_y[900] = B51_1_31;
  v_y[901] = -minus_B51_1_32;
  v_y[902] = -minus_B51_1_33;
  // B52_14 = -R16^T o17~ omega_thetadot14_16 + P_thetadot14_16
  const T B52_14_1 = t16_23 + P_thetadot14_16_1;
  const T B52_14_2 = t16_26 + P_thetadot14_16_2;
  const T B52_14_3 = t16_27 + P_thetadot14_16_3;
  v_y[876] = B52_14_1;
  v_y[894] = B52_14_2;
  v_y[912] = B52_14_3;
  // B53_15 = -R16^T o17~ omega_thetadot15_16 + P_thetadot15_16
  const T t16_28 = R16_11 * T(0.2);
  const T minus_B53_15_1 = t16_28 + minus_P_thetadot15_16_1;
  const T t16_29 = R16_12 * T(0.2);
  const T minus_B53_15_2 = t16_29 + minus_P_thetadot15_16_2;
  const T t16_30 = R16_13 * T(0.2);
  const T minus_B53_15_3 = t16_30 + minus_P_thetadot15_16_3;
  v_y[877] = -minus_B53_15_1;
  v_y[895] = -minus_B53_15_2;
  v_y[913] = -minus_B53_15_3;
  v_y[878] = -t16_28;
  v_y[896] = -t16_29;
  v_y[914] = -t16_30;

  // ---- results
  v_y[15] = T(1);
  v_y[34] = T(1);
  v_y[53] = T(1);
  v_y[69] = T(1);
  v_y[88] = T(1);
  v_y[107] = T(1);
  v_y[123] = T(1);
  v_y[142] = T(1);
  v_y[161] = T(1);
  v_y[177] = T(1);
  v_y[196] = T(1);
  v_y[215] = T(1);
  v_y[231] = T(1);
  v_y[250] = T(1);
  v_y[269] = T(1);
  v_y[285] = T(1);
  v_y[304] = T(1);
  v_y[323] = T(1);
  v_y[339] = T(1);
  v_y[358] = T(1);
  v_y[377] = T(1);
  v_y[393] = T(1);
  v_y[412] = T(1);
  v_y[431] = T(1);
  v_y[447] = T(1);
  v_y[466] = T(1);
  v_y[485] = T(1);
  v_y[501] = T(1);
  v_y[520] = T(1);
  v_y[539] = T(1);
  v_y[555] = T(1);
  v_y[574] = T(1);
  v_y[593] = T(1);
  v_y[609] = T(1);
  v_y[628] = T(1);
  v_y[647] = T(1);
  v_y[663] = T(1);
  v_y[682] = T(1);
  v_y[701] = T(1);
  v_y[717] = T(1);
  v_y[736] = T(1);
  v_y[755] = T(1);
  v_y[771] = T(1);
  v_y[790] = T(1);
  v_y[809] = T(1);
  v_y[825] = T(1);
  v_y[844] = T(1);
  v_y[863] = T(1);
  v_y[879] = T(1);
  v_y[898] = T(1);
  v_y[917] = T(1);
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 1521 add, 2166 multiply, 24 sine or cosine
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  for (int i = 0; i < 918; ++i) v_y_dot[i] = T(0);
  T cosines[16], sines[16];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 4, 12, cosines + 4, sines + 4);

  // ---- body 1 (trunk) on the inertial frame
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
  const T B1_1_11 = t1_13 * T(5e-04) + t1_14 * T(0.0041);
  const T t1_15 = R1_21 * omega1_3 - R1_31 * omega1_2;
  const T minus_B1_1_12 = t1_15 * T(5e-04);
  const T minus_B1_1_13 = t1_15 * T(0.0041);
  const T t1_16 = R1_32 * omega1_1 - R1_12 * omega1_3;
  const T t1_17 = R1_12 * omega1_2 - R1_22 * omega1_1;
  const T B1_1_21 = t1_16 * T(5e-04) + t1_17 * T(0.0041);
  const T t1_18 = R1_22 * omega1_3 - R1_32 * omega1_2;
  const T minus_B1_1_22 = t1_18 * T(5e-04);
  const T minus_B1_1_23 = t1_18 * T(0.0041);
  const T t1_19 = R1_33 * omega1_1 - R1_13 * omega1_3;
  const T t1_20 = R1_13 * omega1_2 - R1_23 * omega1_1;
  const T B1_1_31 = t1_19 * T(5e-04) + t1_20 * T(0.0041);
  const T t1_21 = R1_23 * omega1_3 - R1_33 * omega1_2;
  const T minus_B1_1_32 = t1_21 * T(5e-04);
  const T minus_B1_1_33 = t1_21 * T(0.0041);
  v_y_dot[0] = B1_1_11;
  v_y_dot[1] = -minus_B1_1_12;
  v_y_dot[2] = -minus_B1_1_13;
  v_y_dot[18] = B1_1_21;
  v_y_dot[19] = -minus_B1_1_22;
  v_y_dot[20] = -minus_B1_1_23;
  v_y_dot[36] = B1_1_31;
  v_y_dot[37] = -minus_B1_1_32;
  v_y_dot[38] = -minus_B1_1_33;

  // ---- body 2 (fr_hip) on body 1
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
  // P_dot_omega1_2 = -R1^T omega1~ q2~: its rate
  const T minus_P_dot_omega1_2_11 = t1_14 * T(0.047);
  const T minus_P_dot_omega1_2_12 = t1_14 * T(0.1805);
  const T t2_1 = t1_15 * T(0.047);
  const T t2_2 = t1_13 * T(0.1805);
  const T P_dot_omega1_2_13 = t2_1 + t2_2;
  const T minus_P_dot_omega1_2_21 = t1_17 * T(0.047);
  const T minus_P_dot_omega1_2_22 = t1_17 * T(0.1805);
  const T t2_3 = t1_18 * T(0.047);
  const T t2_4 = t1_16 * T(0.1805);
  const T P_dot_omega1_2_23 = t2_3 + t2_4;
  const T minus_P_dot_omega1_2_31 = t1_20 * T(0.047);
  const T minus_P_dot_omega1_2_32 = t1_20 * T(0.1805);
  const T t2_5 = t1_21 * T(0.047);
  const T t2_6 = t1_19 * T(0.1805);
  const T P_dot_omega1_2_33 = t2_5 + t2_6;
  // B2_1 = thetadot2 R2^T r2~ b2~ E2 - R2^T omega2~ r2~ E2 + P_dot_omega1_2
  const T t2_7 = omega2_2 * T(0.000635) - omega2_3 * T(3.1e-05);
  const T t2_8 = omega2_1 * T(0.000635);
  const T t2_9 = omega2_1 * T(3.1e-05);
  const T t2_10 = R1_11 * t2_7 - R2_21 * t2_8 + R2_31 * t2_9;
  const T minus_B2_1_11 = t2_10 + minus_P_dot_omega1_2_11;
  const T t2_11 = T(0.003311) * E2_23;
  const T t2_12 = omega2_1 * t2_11;
  const T t2_13 = T(0.000635) * E2_23 - T(3.1e-05) * E2_22;
  const T t2_14 = t2_12 + omega2_2 * t2_13;
  const T t2_15 = T(0.003311) * E2_22;
  const T t2_16 = omega2_3 * t2_11 - omega2_2 * t2_15;
  const T t2_17 = omega2_1 * t2_15;
  const T t2_18 = t2_17 + omega2_3 * t2_13;
  const T t2_19 = T(3.1e-05) * E2_23 + T(0.000635) * E2_22;
  const T B2_1_12 = R2_31 * t2_14 - (minus_P_dot_omega1_2_12 + R1_11 * t2_16 + R2_21 * t2_18) + thetadot2 * (R2_21 *
      t2_15 - R1_11 * t2_19 - R2_31 * t2_11);
  const T t2_20 = t2_12 - omega2_3 * t2_19;
  const T t2_21 = omega2_3 * t2_15 + omega2_2 * t2_11;
  const T t2_22 = t2_17 + omega2_2 * t2_19;
  const T B2_1_13 = P_dot_omega1_2_13 - thetadot2 * (R1_11 * t2_13 - R2_21 * t2_11 - R2_31 * t2_15) - R2_21 * t2_20 +
      R1_11 * t2_21 - R2_31 * t2_22;
  const T t2_23 = R1_12 * t2_7 - R2_22 * t2_8 + R2_32 * t2_9;
  const T minus_B2_1_21 = t2_23 + minus_P_dot_omega1_2_21;
  const T B2_1_22 = R2_32 * t2_14 - (minus_P_dot_omega1_2_22 + R1_12 * t2_16 + R2_22 * t2_18) + thetadot2 * (R2_22 *
      t2_15 - R1_12 * t2_19 - R2_32 * t2_11);
  const T B2_1_23 = P_dot_omega1_2_23 - thetadot2 * (R1_12 * t2_13 - R2_22 * t2_11 - R2_32 * t2_15) - R2_22 * t2_20 +
      R1_12 * t2_21 - R2_32 * t2_22;
  const T t2_24 = R1_13 * t2_7 - R2_23 * t2_8 + R2_33 * t2_9;
  const T minus_B2_1_31 = t2_24 + minus_P_dot_omega1_2_31;
  const T B2_1_32 = R2_33 * t2_14 - (minus_P_dot_omega1_2_32 + R1_13 * t2_16 + R2_23 * t2_18) + thetadot2 * (R2_23 *
      t2_15 - R1_13 * t2_19 - R2_33 * t2_11);
  const T B2_1_33 = P_dot_omega1_2_33 - thetadot2 * (R1_13 * t2_13 - R2_23 * t2_11 - R2_33 * t2_15) - R2_23 * t2_20 +
      R1_13 * t2_21 - R2_33 * t2_22;
  v_y_dot[54] = -minus_B2_1_11;
  v_y_dot[55] = B2_1_12;
  v_y_dot[56] = B2_1_13;
  v_y_dot[72] = -minus_B2_1_21;
  v_y_dot[73] = B2_1_22;
  v_y_dot[74] = B2_1_23;
  v_y_dot[90] = -minus_B2_1_31;
  v_y_dot[91] = B2_1_32;
  v_y_dot[92] = B2_1_33;
  v_y_dot[57] = -t2_10;
  v_y_dot[75] = -t2_23;
  v_y_dot[93] = -t2_24;

  // ---- body 3 (fr_thigh) on body 2
  const T thetadot3 = y[4];
  // E3^T = Rot(b3, theta3): E takes components in the lower body to those in the body
  const T E3_11 = cosines[5];
  const T minus_E3_13 = sines[5];
  // R3^T = R2^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 - R2_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 - R2_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 - R2_33 * minus_E3_13;
  const T R3_31 = R1_11 * minus_E3_13 + R2_31 * E3_11;
  const T R3_32 = R1_12 * minus_E3_13 + R2_32 * E3_11;
  const T R3_33 = R1_13 * minus_E3_13 + R2_33 * E3_11;
  // omega3 = thetadot3 b3 + E3 omega2: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega2_1 - minus_E3_13 * omega2_3;
  const T omega3_2 = thetadot3 + omega2_2;
  const T omega3_3 = minus_E3_13 * omega2_1 + E3_11 * omega2_3;
  // omega_omega1_3 = E3 E2: partial angular velocity, body axes
  const T omega_omega1_3_12 = minus_E3_13 * E2_23;
  const T minus_omega_omega1_3_13 = minus_E3_13 * E2_22;
  const T minus_omega_omega1_3_32 = E3_11 * E2_23;
  const T omega_omega1_3_33 = E3_11 * E2_22;
  // omega_dot_omega1_3 = -(thetadot2 E3 b2~ + thetadot3 b3~ E3) E2: its rate
  const T minus_omega_dot_omega1_3_11 = thetadot3 * minus_E3_13;
  const T t3_1 = thetadot2 * minus_E3_13;
  const T t3_2 = thetadot3 * E3_11;
  const T omega_dot_omega1_3_12 = t3_1 * E2_22 + t3_2 * E2_23;
  const T minus_omega_dot_omega1_3_13 = t3_2 * E2_22 - t3_1 * E2_23;
  const T minus_omega_dot_omega1_3_22 = thetadot2 * E2_23;
  const T omega_dot_omega1_3_23 = thetadot2 * E2_22;
  const T t3_3 = thetadot2 * E3_11;
  const T minus_omega_dot_omega1_3_32 = t3_3 * E2_22 - minus_omega_dot_omega1_3_11 * E2_23;
  const T minus_omega_dot_omega1_3_33 = t3_3 * E2_23 + minus_omega_dot_omega1_3_11 * E2_22;
  // P_dot_omega1_3 = R2^T (thetadot2 q3~ b2~ - omega2~ q3~) E2 + P_dot_omega1_2: its rate
  const T t3_4 = omega2_1 * T(0.0838);
  const T t3_5 = omega2_2 * T(0.0838);
  const T t3_6 = R2_21 * t3_4 - R1_11 * t3_5;
  const T P_dot_omega1_3_11 = t3_6 - minus_P_dot_omega1_2_11;
  const T t3_7 = t3_5 * E2_23;
  const T t3_8 = thetadot2 * T(0.0838);
  const T t3_9 = t3_8 * E2_22;
  const T t3_10 = omega2_3 * T(0.0838);
  const T t3_11 = t3_10 * E2_23;
  const T P_dot_omega1_3_12 = R2_31 * t3_7 - (minus_P_dot_omega1_2_12 + R1_11 * t3_9 + R2_21 * t3_11);
  const T t3_12 = t3_10 * E2_22;
  const T t3_13 = t3_8 * E2_23;
  const T t3_14 = t3_5 * E2_22;
  const T P_dot_omega1_3_13 = P_dot_omega1_2_13 + R2_21 * t3_12 - R1_11 * t3_13 - R2_31 * t3_14;
  const T t3_15 = R2_22 * t3_4 - R1_12 * t3_5;
  const T P_dot_omega1_3_21 = t3_15 - minus_P_dot_omega1_2_21;
  const T P_dot_omega1_3_22 = R2_32 * t3_7 - (minus_P_dot_omega1_2_22 + R1_12 * t3_9 + R2_22 * t3_11);
  const T P_dot_omega1_3_23 = P_dot_omega1_2_23 + R2_22 * t3_12 - R1_12 * t3_13 - R2_32 * t3_14;
  const T t3_16 = R2_23 * t3_4 - R1_13 * t3_5;
  const T P_dot_omega1_3_31 = t3_16 - minus_P_dot_omega1_2_31;
  const T P_dot_omega1_3_32 = R2_33 * t3_7 - (minus_P_dot_omega1_2_32 + R1_13 * t3_9 + R2_23 * t3_11);
  const T P_dot_omega1_3_33 = P_dot_omega1_2_33 + R2_23 * t3_12 - R1_13 * t3_13 - R2_33 * t3_14;
  // B4_1 = -R3^T omega3~ r3~ omega_omega1_3 - R3^T r3~ omega_dot_omega1_3 + P_dot_omega1_3
  const T t3_17 = T(0.022327) * minus_E3_13;
  const T t3_18 = T(0.022327) * E3_11;
  const T t3_19 = omega3_3 * t3_17 + omega3_1 * t3_18;
  const T t3_20 = T(0.003237) * minus_E3_13 - T(0.027326) * E3_11;
  const T t3_21 = omega3_3 * t3_20 + omega3_2 * t3_18;
  const T t3_22 = omega3_1 * t3_20 - omega3_2 * t3_17;
  const T t3_23 = T(0.022327) * t3_2;
  const T t3_24 = T(0.003237) * t3_2 + T(0.027326) * minus_omega_dot_omega1_3_11;
  const T t3_25 = T(0.022327) * minus_omega_dot_omega1_3_11;
  const T t3_26 = R2_21 * t3_19 - R3_11 * t3_21 + R3_31 * t3_22 + R3_11 * t3_23 + R2_21 * t3_24 + R3_31 * t3_25;
  const T B4_1_11 = P_dot_omega1_3_11 - t3_26;
  const T t3_27 = T(0.027326) * omega_omega1_3_12 + T(0.003237) * minus_omega_omega1_3_32;
  const T t3_28 = T(0.003237) * E2_22 + T(0.022327) * omega_omega1_3_12;
  const T t3_29 = omega3_3 * t3_27 - omega3_2 * t3_28;
  const T t3_30 = T(0.027326) * E2_22 - T(0.022327) * minus_omega_omega1_3_32;
  const T t3_31 = omega3_3 * t3_30 + omega3_1 * t3_28;
  const T t3_32 = omega3_1 * t3_27 + omega3_2 * t3_30;
  const T t3_33 = T(0.027326) * minus_omega_dot_omega1_3_22 + T(0.022327) * minus_omega_dot_omega1_3_32;
  const T t3_34 = T(0.003237) * minus_omega_dot_omega1_3_32 + T(0.027326) * omega_dot_omega1_3_12;
  const T t3_35 = T(0.003237) * minus_omega_dot_omega1_3_22 - T(0.022327) * omega_dot_omega1_3_12;
  const T B4_1_12 = P_dot_omega1_3_12 - R3_11 * t3_29 - R2_21 * t3_31 + R3_31 * t3_32 + R3_11 * t3_33 + R2_21 * t3_34
      - R3_31 * t3_35;
  const T t3_36 = T(0.022327) * minus_omega_omega1_3_13 - T(0.003237) * E2_23;
  const T t3_37 = T(0.027326) * minus_omega_omega1_3_13 + T(0.003237) * omega_omega1_3_33;
  const T t3_38 = omega3_2 * t3_36 - omega3_3 * t3_37;
  const T t3_39 = T(0.027326) * E2_23 + T(0.022327) * omega_omega1_3_33;
  const T t3_40 = omega3_3 * t3_39 - omega3_1 * t3_36;
  const T t3_41 = omega3_1 * t3_37 - omega3_2 * t3_39;
  const T t3_42 = T(0.027326) * omega_dot_omega1_3_23 - T(0.022327) * minus_omega_dot_omega1_3_33;
  const T t3_43 = T(0.027326) * minus_omega_dot_omega1_3_13 - T(0.003237) * minus_omega_dot_omega1_3_33;
  const T t3_44 = T(0.022327) * minus_omega_dot_omega1_3_13 - T(0.003237) * omega_dot_omega1_3_23;
  const T B4_1_13 = P_dot_omega1_3_13 - R3_11 * t3_38 - R2_21 * t3_40 - R3_31 * t3_41 - R3_11 * t3_42 - R2_21 * t3_43
      - R3_31 * t3_44;
  const T t3_45 = R2_22 * t3_19 - R3_12 * t3_21 + R3_32 * t3_22 + R3_12 * t3_23 + R2_22 * t3_24 + R3_32 * t3_25;
  const T B4_1_21 = P_dot_omega1_3_21 - t3_45;
  const T B4_1_22 = P_dot_omega1_3_22 - R3_12 * t3_29 - R2_22 * t3_31 + R3_32 * t3_32 + R3_12 * t3_33 + R2_22 * t3_34
      - R3_32 * t3_35;
  const T B4_1_23 = P_dot_omega1_3_23 - R3_12 * t3_38 - R2_22 * t3_40 - R3_32 * t3_41 - R3_12 * t3_42 - R2_22 * t3_43
      - R3_32 * t3_44;
  const T t3_46 = R2_23 * t3_19 - R3_13 * t3_21 + R3_33 * t3_22 + R3_13 * t3_23 + R2_23 * t3_24 + R3_33 * t3_25;
  const T B4_1_31 = P_dot_omega1_3_31 - t3_46;
  const T B4_1_32 = P_dot_omega1_3_32 - R3_13 * t3_29 - R2_23 * t3_31 + R3_33 * t3_32 + R3_13 * t3_33 + R2_23 * t3_34
      - R3_33 * t3_35;
  const T B4_1_33 = P_dot_omega1_3_33 - R3_13 * t3_38 - R2_23 * t3_40 - R3_33 * t3_41 - R3_13 * t3_42 - R2_23 * t3_43
      - R3_33 * t3_44;
  v_y_dot[108] = B4_1_11;
  v_y_dot[109] = B4_1_12;
  v_y_dot[110] = B4_1_13;
  v_y_dot[126] = B4_1_21;
  v_y_dot[127] = B4_1_22;
  v_y_dot[128] = B4_1_23;
  v_y_dot[144] = B4_1_31;
  v_y_dot[145] = B4_1_32;
  v_y_dot[146] = B4_1_33;
  // B5_2 = -R3^T omega3~ r3~ omega_thetadot2_3 - R3^T r3~ omega_dot_thetadot2_3 + P_dot_thetadot2_3
  const T minus_B5_2_1 = t3_26 - t3_6;
  const T minus_B5_2_2 = t3_45 - t3_15;
  const T minus_B5_2_3 = t3_46 - t3_16;
  v_y_dot[111] = -minus_B5_2_1;
  v_y_dot[129] = -minus_B5_2_2;
  v_y_dot[147] = -minus_B5_2_3;
  // B6_3 = -R3^T omega3~ r3~ b3
  const T t3_47 = omega3_3 * T(0.027326) + omega3_1 * T(0.003237);
  const T t3_48 = omega3_2 * T(0.003237);
  const T t3_49 = omega3_2 * T(0.027326);
  const T minus_B6_3_1 = R2_21 * t3_47 - R3_11 * t3_48 - R3_31 * t3_49;
  const T minus_B6_3_2 = R2_22 * t3_47 - R3_12 * t3_48 - R3_32 * t3_49;
  const T minus_B6_3_3 = R2_23 * t3_47 - R3_13 * t3_48 - R3_33 * t3_49;
  v_y_dot[112] = -minus_B6_3_1;
  v_y_dot[130] = -minus_B6_3_2;
  v_y_dot[148] = -minus_B6_3_3;

  // ---- body 4 (fr_calf) on body 3
  const T thetadot4 = y[5];
  // E4^T = Rot(b4, theta4): E takes components in the lower body to those in the body
  const T E4_11 = cosines[6];
  const T minus_E4_13 = sines[6];
  // R4^T = R3^T E4^T: R takes inertial components to body components
  const T R4_11 = R3_11 * E4_11 - R3_31 * minus_E4_13;
  const T R4_12 = R3_12 * E4_11 - R3_32 * minus_E4_13;
  const T R4_13 = R3_13 * E4_11 - R3_33 * minus_E4_13;
  const T R4_31 = R3_11 * minus_E4_13 + R3_31 * E4_11;
  const T R4_32 = R3_12 * minus_E4_13 + R3_32 * E4_11;
  const T R4_33 = R3_13 * minus_E4_13 + R3_33 * E4_11;
  // omega4 = thetadot4 b4 + E4 omega3: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_11 * omega3_1 - minus_E4_13 * omega3_3;
  const T omega4_2 = thetadot4 + omega3_2;
  const T omega4_3 = minus_E4_13 * omega3_1 + E4_11 * omega3_3;
  // omega_omega1_4 = E4 omega_omega1_3: partial angular velocity, body axes
  const T omega_omega1_4_11 = E4_11 * E3_11 - minus_E4_13 * minus_E3_13;
  const T omega_omega1_4_12 = E4_11 * omega_omega1_3_12 + minus_E4_13 * minus_omega_omega1_3_32;
  const T minus_omega_omega1_4_13 = E4_11 * minus_omega_omega1_3_13 + minus_E4_13 * omega_omega1_3_33;
  const T omega_omega1_4_31 = minus_E4_13 * E3_11 + E4_11 * minus_E3_13;
  const T omega_omega1_4_32 = minus_E4_13 * omega_omega1_3_12 - E4_11 * minus_omega_omega1_3_32;
  const T omega_omega1_4_33 = E4_11 * omega_omega1_3_33 - minus_E4_13 * minus_omega_omega1_3_13;
  // omega_dot_omega1_4 = -thetadot4 b4~ E4 omega_omega1_3 + E4 omega_dot_omega1_3: its rate
  const T minus_omega_dot_omega1_4_11 = thetadot4 * omega_omega1_4_31 + minus_E4_13 * t3_2 + E4_11 *
      minus_omega_dot_omega1_3_11;
  const T omega_dot_omega1_4_12 = minus_E4_13 * minus_omega_dot_omega1_3_32 + E4_11 * omega_dot_omega1_3_12 -
      thetadot4 * omega_omega1_4_32;
  const T omega_dot_omega1_4_13 = minus_E4_13 * minus_omega_dot_omega1_3_33 - E4_11 * minus_omega_dot_omega1_3_13 -
      thetadot4 * omega_omega1_4_33;
  const T omega_dot_omega1_4_31 = E4_11 * t3_2 - minus_E4_13 * minus_omega_dot_omega1_3_11 + thetadot4 *
      omega_omega1_4_11;
  const T omega_dot_omega1_4_32 = minus_E4_13 * omega_dot_omega1_3_12 - E4_11 * minus_omega_dot_omega1_3_32 +
      thetadot4 * omega_omega1_4_12;
  const T minus_omega_dot_omega1_4_33 = thetadot4 * minus_omega_omega1_4_13 + minus_E4_13 *
      minus_omega_dot_omega1_3_13 + E4_11 * minus_omega_dot_omega1_3_33;
  // P_dot_omega1_4 = R3^T (-omega3~ q4~ omega_omega1_3 - q4~ omega_dot_omega1_3) + P_dot_omega1_3: its rate
  const T t4_1 = T(0.2) * E3_11;
  const T t4_2 = omega3_3 * t4_1;
  const T t4_3 = T(0.2) * minus_omega_dot_omega1_3_11;
  const T t4_4 = omega3_1 * t4_1;
  const T t4_5 = R3_11 * t4_2 + R2_21 * t4_3 - R3_31 * t4_4;
  const T P_dot_omega1_4_11 = P_dot_omega1_3_11 - t4_5;
  const T t4_6 = T(0.2) * omega_omega1_3_12;
  const T t4_7 = T(0.2) * minus_omega_dot_omega1_3_22;
  const T t4_8 = omega3_3 * t4_6 - t4_7;
  const T t4_9 = T(0.2) * E2_22;
  const T t4_10 = omega3_3 * t4_9 - T(0.2) * omega_dot_omega1_3_12;
  const T t4_11 = omega3_1 * t4_6 + omega3_2 * t4_9;
  const T P_dot_omega1_4_12 = P_dot_omega1_3_12 - R3_11 * t4_8 - R2_21 * t4_10 + R3_31 * t4_11;
  const T t4_12 = T(0.2) * omega_dot_omega1_3_23;
  const T t4_13 = T(0.2) * minus_omega_omega1_3_13;
  const T t4_14 = t4_12 - omega3_3 * t4_13;
  const T t4_15 = T(0.2) * E2_23;
  const T t4_16 = omega3_3 * t4_15 + T(0.2) * minus_omega_dot_omega1_3_13;
  const T t4_17 = omega3_1 * t4_13 - omega3_2 * t4_15;
  const T P_dot_omega1_4_13 = P_dot_omega1_3_13 - R3_11 * t4_14 - R2_21 * t4_16 - R3_31 * t4_17;
  const T t4_18 = R3_12 * t4_2 + R2_22 * t4_3 - R3_32 * t4_4;
  const T P_dot_omega1_4_21 = P_dot_omega1_3_21 - t4_18;
  const T P_dot_omega1_4_22 = P_dot_omega1_3_22 - R3_12 * t4_8 - R2_22 * t4_10 + R3_32 * t4_11;
  const T P_dot_omega1_4_23 = P_dot_omega1_3_23 - R3_12 * t4_14 - R2_22 * t4_16 - R3_32 * t4_17;
  const T t4_19 = R3_13 * t4_2 + R2_23 * t4_3 - R3_33 * t4_4;
  const T P_dot_omega1_4_31 = P_dot_omega1_3_31 - t4_19;
  const T P_dot_omega1_4_32 = P_dot_omega1_3_32 - R3_13 * t4_8 - R2_23 * t4_10 + R3_33 * t4_11;
  const T P_dot_omega1_4_33 = P_dot_omega1_3_33 - R3_13 * t4_14 - R2_23 * t4_16 - R3_33 * t4_17;
  // P_dot_thetadot2_4 = R3^T (-omega3~ q4~ omega_thetadot2_3 - q4~ omega_dot_thetadot2_3) + P_dot_thetadot2_3: its
  //   rate
  const T minus_P_dot_thetadot2_4_1 = t4_5 - t3_6;
  const T minus_P_dot_thetadot2_4_2 = t4_18 - t3_15;
  const T minus_P_dot_thetadot2_4_3 = t4_19 - t3_16;
  // P_dot_thetadot3_4 = -R3^T omega3~ q4~ b3: its rate
  const T t4_20 = omega3_3 * T(0.2);
  const T t4_21 = omega3_2 * T(0.2);
  const T minus_P_dot_thetadot3_4_1 = R2_21 * t4_20 - R3_31 * t4_21;
  const T minus_P_dot_thetadot3_4_2 = R2_22 * t4_20 - R3_32 * t4_21;
  const T minus_P_dot_thetadot3_4_3 = R2_23 * t4_20 - R3_33 * t4_21;
  // B7_1 = -R4^T omega4~ r4~ omega_omega1_4 - R4^T r4~ omega_dot_omega1_4 + P_dot_omega1_4
  const T t4_22 = T(0.107388) * omega_omega1_4_11 + T(0.006435) * omega_omega1_4_31;
  const T t4_23 = omega4_3 * t4_22;
  const T t4_24 = omega4_1 * t4_22;
  const T t4_25 = T(0.107388) * minus_omega_dot_omega1_4_11 - T(0.006435) * omega_dot_omega1_4_31;
  const T t4_26 = R4_11 * t4_23 - R4_31 * t4_24 + R2_21 * t4_25;
  const T B7_1_11 = P_dot_omega1_4_11 - t4_26;
  const T t4_27 = T(0.107388) * omega_omega1_4_12 + T(0.006435) * omega_omega1_4_32;
  const T t4_28 = T(0.006435) * E2_22;
  const T t4_29 = omega4_3 * t4_27 + omega4_2 * t4_28;
  const T t4_30 = T(0.107388) * E2_22;
  const T t4_31 = omega4_3 * t4_30 - omega4_1 * t4_28;
  const T t4_32 = omega4_1 * t4_27 + omega4_2 * t4_30;
  const T t4_33 = T(0.107388) * minus_omega_dot_omega1_3_22;
  const T t4_34 = T(0.107388) * omega_dot_omega1_4_12 + T(0.006435) * omega_dot_omega1_4_32;
  const T t4_35 = T(0.006435) * minus_omega_dot_omega1_3_22;
  const T B7_1_12 = P_dot_omega1_4_12 - R4_11 * t4_29 - R2_21 * t4_31 + R4_31 * t4_32 + R4_11 * t4_33 + R2_21 * t4_34
      + R4_31 * t4_35;
  const T t4_36 = T(0.006435) * E2_23;
  const T t4_37 = T(0.107388) * minus_omega_omega1_4_13 - T(0.006435) * omega_omega1_4_33;
  const T t4_38 = omega4_2 * t4_36 - omega4_3 * t4_37;
  const T t4_39 = T(0.107388) * E2_23;
  const T t4_40 = omega4_3 * t4_39 - omega4_1 * t4_36;
  const T t4_41 = omega4_1 * t4_37 - omega4_2 * t4_39;
  const T t4_42 = T(0.107388) * omega_dot_omega1_3_23;
  const T t4_43 = T(0.006435) * minus_omega_dot_omega1_4_33 - T(0.107388) * omega_dot_omega1_4_13;
  const T t4_44 = T(0.006435) * omega_dot_omega1_3_23;
  const T B7_1_13 = P_dot_omega1_4_13 - R4_11 * t4_38 - R2_21 * t4_40 - R4_31 * t4_41 - R4_11 * t4_42 - R2_21 * t4_43
      - R4_31 * t4_44;
  const T t4_45 = R4_12 * t4_23 - R4_32 * t4_24 + R2_22 * t4_25;
  const T B7_1_21 = P_dot_omega1_4_21 - t4_45;
  const T B7_1_22 = P_dot_omega1_4_22 - R4_12 * t4_29 - R2_22 * t4_31 + R4_32 * t4_32 + R4_12 * t4_33 + R2_22 * t4_34
      + R4_32 * t4_35;
  const T B7_1_23 = P_dot_omega1_4_23 - R4_12 * t4_38 - R2_22 * t4_40 - R4_32 * t4_41 - R4_12 * t4_42 - R2_22 * t4_43
      - R4_32 * t4_44;
  const T t4_46 = R4_13 * t4_23 - R4_33 * t4_24 + R2_23 * t4_25;
  const T B7_1_31 = P_dot_omega1_4_31 - t4_46;
  const T B7_1_32 = P_dot_omega1_4_32 - R4_13 * t4_29 - R2_23 * t4_31 + R4_33 * t4_32 + R4_13 * t4_33 + R2_23 * t4_34
      + R4_33 * t4_35;
  const T B7_1_33 = P_dot_omega1_4_33 - R4_13 * t4_38 - R2_23 * t4_40 - R4_33 * t4_41 - R4_13 * t4_42 - R2_23 * t4_43
      - R4_33 * t4_44;
  v_y_dot[162] = B7_1_11;
  v_y_dot[163] = B7_1_12;
  v_y_dot[164] = B7_1_13;
  v_y_dot[180] = B7_1_21;
  v_y_dot[181] = B7_1_22;
  v_y_dot[182] = B7_1_23;
  v_y_dot[198] = B7_1_31;
  v_y_dot[199] = B7_1_32;
  v_y_dot[200] = B7_1_33;
  // B8_2 = -R4^T omega4~ r4~ omega_thetadot2_4 - R4^T r4~ omega_dot_thetadot2_4 + P_dot_thetadot2_4
  const T minus_B8_2_1 = t4_26 + minus_P_dot_thetadot2_4_1;
  const T minus_B8_2_2 = t4_45 + minus_P_dot_thetadot2_4_2;
  const T minus_B8_2_3 = t4_46 + minus_P_dot_thetadot2_4_3;
  v_y_dot[165] = -minus_B8_2_1;
  v_y_dot[183] = -minus_B8_2_2;
  v_y_dot[201] = -minus_B8_2_3;
  // B9_3 = -R4^T omega4~ r4~ omega_thetadot3_4 - R4^T r4~ omega_dot_thetadot3_4 + P_dot_thetadot3_4
  const T t4_47 = omega4_2 * T(0.006435);
  const T t4_48 = omega4_3 * T(0.107388) - omega4_1 * T(0.006435);
  const T t4_49 = omega4_2 * T(0.107388);
  const T t4_50 = R4_11 * t4_47 + R2_21 * t4_48 - R4_31 * t4_49;
  const T minus_B9_3_1 = t4_50 + minus_P_dot_thetadot3_4_1;
  const T t4_51 = R4_12 * t4_47 + R2_22 * t4_48 - R4_32 * t4_49;
  const T minus_B9_3_2 = t4_51 + minus_P_dot_thetadot3_4_2;
  const T t4_52 = R4_13 * t4_47 + R2_23 * t4_48 - R4_33 * t4_49;
  const T minus_B9_3_3 = t4_52 + minus_P_dot_thetadot3_4_3;
  v_y_dot[166] = -minus_B9_3_1;
  v_y_dot[184] = -minus_B9_3_2;
  v_y_dot[202] = -minus_B9_3_3;
  v_y_dot[167] = -t4_50;
  v_y_dot[185] = -t4_51;
  v_y_dot[203] = -t4_52;
  // B11_1 = -R4^T omega4~ o5~ omega_omega1_4 - R4^T o5~ omega_dot_omega1_4 + P_dot_omega1_4
  const T t4_53 = T(0.2) * omega_omega1_4_11;
  const T t4_54 = omega4_3 * t4_53;
  const T t4_55 = omega4_1 * t4_53;
  const T t4_56 = T(0.2) * minus_omega_dot_omega1_4_11;
  const T t4_57 = R4_11 * t4_54 - R4_31 * t4_55 + R2_21 * t4_56;
  const T B11_1_11 = P_dot_omega1_4_11 - t4_57;
  const T t4_58 = T(0.2) * omega_omega1_4_12;
  const T t4_59 = omega4_3 * t4_58;
  const T t4_60 = omega4_3 * t4_9;
  const T t4_61 = omega4_1 * t4_58 + omega4_2 * t4_9;
  const T t4_62 = T(0.2) * omega_dot_omega1_4_12;
  const T B11_1_12 = P_dot_omega1_4_12 - R4_11 * t4_59 - R2_21 * t4_60 + R4_31 * t4_61 + R4_11 * t4_7 + R2_21 * t4_62;
  const T t4_63 = T(0.2) * minus_omega_omega1_4_13;
  const T t4_64 = omega4_3 * t4_63;
  const T t4_65 = omega4_3 * t4_15;
  const T t4_66 = omega4_1 * t4_63 - omega4_2 * t4_15;
  const T t4_67 = T(0.2) * omega_dot_omega1_4_13;
  const T B11_1_13 = P_dot_omega1_4_13 + R4_11 * t4_64 - R2_21 * t4_65 - R4_31 * t4_66 - R4_11 * t4_12 + R2_21 *
      t4_67;
  const T t4_68 = R4_12 * t4_54 - R4_32 * t4_55 + R2_22 * t4_56;
  const T B11_1_21 = P_dot_omega1_4_21 - t4_68;
  const T B11_1_22 = P_dot_omega1_4_22 - R4_12 * t4_59 - R2_22 * t4_60 + R4_32 * t4_61 + R4_12 * t4_7 + R2_22 * t4_62;
  const T B11_1_23 = P_dot_omega1_4_23 + R4_12 * t4_64 - R2_22 * t4_65 - R4_32 * t4_66 - R4_12 * t4_12 + R2_22 *
      t4_67;
  const T t4_69 = R4_13 * t4_54 - R4_33 * t4_55 + R2_23 * t4_56;
  const T B11_1_31 = P_dot_omega1_4_31 - t4_69;
  const T B11_1_32 = P_dot_omega1_4_32 - R4_13 * t4_59 - R2_23 * t4_60 + R4_33 * t4_61 + R4_13 * t4_7 + R2_23 * t4_62;
  const T B11_1_33 = P_dot_omega1_4_33 + R4_13 * t4_64 - R2_23 * t4_65 - R4_33 * t4_66 - R4_13 * t4_12 + R2_23 *
      t4_67;
  v_y_dot[216] = B11_1_11;
  v_y_dot[217] = B11_1_12;
  v_y_dot[218] = B11_1_13;
  v_y_dot[234] = B11_1_21;
  v_y_dot[235] = B11_1_22;
  v_y_dot[236] = B11_1_23;
  v_y_dot[252] = B11_1_31;
  v_y_dot[253] = B11_1_32;
  v_y_dot[254] = B11_1_33;
  // B12_2 = -R4^T omega4~ o5~ omega_thetadot2_4 - R4^T o5~ omega_dot_thetadot2_4 + P_dot_thetadot2_4
  const T minus_B12_2_1 = t4_57 + minus_P_dot_thetadot2_4_1;
  const T minus_B12_2_2 = t4_68 + minus_P_dot_thetadot2_4_2;
  const T minus_B12_2_3 = t4_69 + minus_P_dot_thetadot2_4_3;
  v_y_dot[219] = -minus_B12_2_1;
  v_y_dot[237] = -minus_B12_2_2;
  v_y_dot[255] = -minus_B12_2_3;
  // B13_3 = -R4^T omega4~ o5~ omega_thetadot3_4 - R4^T o5~ omega_dot_thetadot3_4 + P_dot_thetadot3_4
  const T t4_70 = omega4_3 * T(0.2);
  const T t4_71 = omega4_2 * T(0.2);
  const T t4_72 = R2_21 * t4_70 - R4_31 * t4_71;
  const T minus_B13_3_1 = t4_72 + minus_P_dot_thetadot3_4_1;
  const T t4_73 = R2_22 * t4_70 - R4_32 * t4_71;
  const T minus_B13_3_2 = t4_73 + minus_P_dot_thetadot3_4_2;
  const T t4_74 = R2_23 * t4_70 - R4_33 * t4_71;
  const T minus_B13_3_3 = t4_74 + minus_P_dot_thetadot3_4_3;
  v_y_dot[220] = -minus_B13_3_1;
  v_y_dot[238] = -minus_B13_3_2;
  v_y_dot[256] = -minus_B13_3_3;
  v_y_dot[221] = -t4_72;
  v_y_dot[239] = -t4_73;
  v_y_dot[257] = -t4_74;

  // ---- body 6 (fl_hip) on body 1
  const T thetadot6 = y[6];
  // E6^T = Rot(b6, theta6): E takes components in the lower body to those in the body
  const T E6_22 = cosines[7];
  const T E6_23 = sines[7];
  // R6^T = R1^T E6^T: R takes inertial components to body components
  const T R6_21 = R1_21 * E6_22 + R1_31 * E6_23;
  const T R6_22 = R1_22 * E6_22 + R1_32 * E6_23;
  const T R6_23 = R1_23 * E6_22 + R1_33 * E6_23;
  const T R6_31 = R1_31 * E6_22 - R1_21 * E6_23;
  const T R6_32 = R1_32 * E6_22 - R1_22 * E6_23;
  const T R6_33 = R1_33 * E6_22 - R1_23 * E6_23;
  // omega6 = thetadot6 b6 + E6 omega1: absolute angular velocity, body axes [rad/s]
  const T omega6_1 = thetadot6 + omega1_1;
  const T omega6_2 = E6_22 * omega1_2 + E6_23 * omega1_3;
  const T omega6_3 = E6_22 * omega1_3 - E6_23 * omega1_2;
  // P_dot_omega1_6 = -R1^T omega1~ q6~: its rate
  const T minus_P_dot_omega1_6_13 = t2_1 - t2_2;
  const T minus_P_dot_omega1_6_23 = t2_3 - t2_4;
  const T minus_P_dot_omega1_6_33 = t2_5 - t2_6;
  // B15_1 = thetadot6 R6^T r6~ b6~ E6 - R6^T omega6~ r6~ E6 + P_dot_omega1_6
  const T t6_1 = omega6_1 * T(0.000635);
  const T t6_2 = omega6_3 * T(3.1e-05) + omega6_2 * T(0.000635);
  const T t6_3 = omega6_1 * T(3.1e-05);
  const T t6_4 = R6_21 * t6_1 - R1_11 * t6_2 + R6_31 * t6_3;
  const T B15_1_11 = minus_P_dot_omega1_2_11 - t6_4;
  const T t6_5 = T(0.000635) * E6_22 - T(3.1e-05) * E6_23;
  const T t6_6 = T(0.003311) * E6_22;
  const T t6_7 = T(0.003311) * E6_23;
  const T t6_8 = omega6_3 * t6_7 - omega6_2 * t6_6;
  const T t6_9 = omega6_1 * t6_6;
  const T t6_10 = T(3.1e-05) * E6_22 + T(0.000635) * E6_23;
  const T t6_11 = t6_9 - omega6_3 * t6_10;
  const T t6_12 = omega6_1 * t6_7;
  const T t6_13 = omega6_2 * t6_10 - t6_12;
  const T B15_1_12 = thetadot6 * (R1_11 * t6_5 + R6_21 * t6_6 - R6_31 * t6_7) - (minus_P_dot_omega1_2_12 + R1_11 *
      t6_8 + R6_21 * t6_11 + R6_31 * t6_13);
  const T t6_14 = omega6_3 * t6_6 + omega6_2 * t6_7;
  const T t6_15 = t6_12 + omega6_3 * t6_5;
  const T t6_16 = t6_9 - omega6_2 * t6_5;
  const T B15_1_13 = R1_11 * t6_14 - minus_P_dot_omega1_6_13 - R6_21 * t6_15 - R6_31 * t6_16 + thetadot6 * (R1_11 *
      t6_10 + R6_21 * t6_7 + R6_31 * t6_6);
  const T t6_17 = R6_22 * t6_1 - R1_12 * t6_2 + R6_32 * t6_3;
  const T B15_1_21 = minus_P_dot_omega1_2_21 - t6_17;
  const T B15_1_22 = thetadot6 * (R1_12 * t6_5 + R6_22 * t6_6 - R6_32 * t6_7) - (minus_P_dot_omega1_2_22 + R1_12 *
      t6_8 + R6_22 * t6_11 + R6_32 * t6_13);
  const T B15_1_23 = R1_12 * t6_14 - minus_P_dot_omega1_6_23 - R6_22 * t6_15 - R6_32 * t6_16 + thetadot6 * (R1_12 *
      t6_10 + R6_22 * t6_7 + R6_32 * t6_6);
  const T t6_18 = R6_23 * t6_1 - R1_13 * t6_2 + R6_33 * t6_3;
  const T B15_1_31 = minus_P_dot_omega1_2_31 - t6_18;
  const T B15_1_32 = thetadot6 * (R1_13 * t6_5 + R6_23 * t6_6 - R6_33 * t6_7) - (minus_P_dot_omega1_2_32 + R1_13 *
      t6_8 + R6_23 * t6_11 + R6_33 * t6_13);
  const T B15_1_33 = R1_13 * t6_14 - minus_P_dot_omega1_6_33 - R6_23 * t6_15 - R6_33 * t6_16 + thetadot6 * (R1_13 *
      t6_10 + R6_23 * t6_7 + R6_33 * t6_6);
  v_y_dot[270] = B15_1_11;
  v_y_dot[271] = B15_1_12;
  v_y_dot[272] = B15_1_13;
  v_y_dot[288] = B15_1_21;
  v_y_dot[289] = B15_1_22;
  v_y_dot[290] = B15_1_23;
  v_y_dot[306] = B15_1_31;
  v_y_dot[307] = B15_1_32;
  v_y_dot[308] = B15_1_33;
  v_y_dot[276] = -t6_4;
  v_y_dot[294] = -t6_17;
  v_y_dot[312] = -t6_18;

  // ---- body 7 (fl_thigh) on body 6
  const T thetadot7 = y[7];
  // E7^T = Rot(b7, theta7): E takes components in the lower body to those in the body
  const T E7_11 = cosines[8];
  const T minus_E7_13 = sines[8];
  // R7^T = R6^T E7^T: R takes inertial components to body components
  const T R7_11 = R1_11 * E7_11 - R6_31 * minus_E7_13;
  const T R7_12 = R1_12 * E7_11 - R6_32 * minus_E7_13;
  const T R7_13 = R1_13 * E7_11 - R6_33 * minus_E7_13;
  const T R7_31 = R1_11 * minus_E7_13 + R6_31 * E7_11;
  const T R7_32 = R1_12 * minus_E7_13 + R6_32 * E7_11;
  const T R7_33 = R1_13 * minus_E7_13 + R6_33 * E7_11;
  // omega7 = thetadot7 b7 + E7 omega6: absolute angular velocity, body axes [rad/s]
  const T omega7_1 = E7_11 * omega6_1 - minus_E7_13 * omega6_3;
  const T omega7_2 = thetadot7 + omega6_2;
  const T omega7_3 = minus_E7_13 * omega6_1 + E7_11 * omega6_3;
  // omega_omega1_7 = E7 E6: partial angular velocity, body axes
  const T omega_omega1_7_12 = minus_E7_13 * E6_23;
  const T minus_omega_omega1_7_13 = minus_E7_13 * E6_22;
  const T minus_omega_omega1_7_32 = E7_11 * E6_23;
  const T omega_omega1_7_33 = E7_11 * E6_22;
  // omega_dot_omega1_7 = -(thetadot6 E7 b6~ + thetadot7 b7~ E7) E6: its rate
  const T minus_omega_dot_omega1_7_11 = thetadot7 * minus_E7_13;
  const T t7_1 = thetadot6 * minus_E7_13;
  const T t7_2 = thetadot7 * E7_11;
  const T omega_dot_omega1_7_12 = t7_1 * E6_22 + t7_2 * E6_23;
  const T minus_omega_dot_omega1_7_13 = t7_2 * E6_22 - t7_1 * E6_23;
  const T minus_omega_dot_omega1_7_22 = thetadot6 * E6_23;
  const T omega_dot_omega1_7_23 = thetadot6 * E6_22;
  const T t7_3 = thetadot6 * E7_11;
  const T minus_omega_dot_omega1_7_32 = t7_3 * E6_22 - minus_omega_dot_omega1_7_11 * E6_23;
  const T minus_omega_dot_omega1_7_33 = t7_3 * E6_23 + minus_omega_dot_omega1_7_11 * E6_22;
  // P_dot_omega1_7 = R6^T (thetadot6 q7~ b6~ - omega6~ q7~) E6 + P_dot_omega1_6: its rate
  const T t7_4 = omega6_2 * T(0.0838);
  const T t7_5 = omega6_1 * T(0.0838);
  const T t7_6 = R1_11 * t7_4 - R6_21 * t7_5;
  const T P_dot_omega1_7_11 = t7_6 + minus_P_dot_omega1_2_11;
  const T t7_7 = thetadot6 * T(0.0838);
  const T t7_8 = t7_7 * E6_22;
  const T t7_9 = omega6_3 * T(0.0838);
  const T t7_10 = t7_9 * E6_23;
  const T t7_11 = t7_4 * E6_23;
  const T P_dot_omega1_7_12 = R1_11 * t7_8 - minus_P_dot_omega1_2_12 + R6_21 * t7_10 - R6_31 * t7_11;
  const T t7_12 = t7_7 * E6_23;
  const T t7_13 = t7_9 * E6_22;
  const T t7_14 = t7_4 * E6_22;
  const T P_dot_omega1_7_13 = R1_11 * t7_12 - minus_P_dot_omega1_6_13 - R6_21 * t7_13 + R6_31 * t7_14;
  const T t7_15 = R1_12 * t7_4 - R6_22 * t7_5;
  const T P_dot_omega1_7_21 = t7_15 + minus_P_dot_omega1_2_21;
  const T P_dot_omega1_7_22 = R1_12 * t7_8 - minus_P_dot_omega1_2_22 + R6_22 * t7_10 - R6_32 * t7_11;
  const T P_dot_omega1_7_23 = R1_12 * t7_12 - minus_P_dot_omega1_6_23 - R6_22 * t7_13 + R6_32 * t7_14;
  const T t7_16 = R1_13 * t7_4 - R6_23 * t7_5;
  const T P_dot_omega1_7_31 = t7_16 + minus_P_dot_omega1_2_31;
  const T P_dot_omega1_7_32 = R1_13 * t7_8 - minus_P_dot_omega1_2_32 + R6_23 * t7_10 - R6_33 * t7_11;
  const T P_dot_omega1_7_33 = R1_13 * t7_12 - minus_P_dot_omega1_6_33 - R6_23 * t7_13 + R6_33 * t7_14;
  // B17_1 = -R7^T omega7~ r7~ omega_omega1_7 - R7^T r7~ omega_dot_omega1_7 + P_dot_omega1_7
  const T t7_17 = T(0.022327) * E7_11;
  const T t7_18 = T(0.003237) * minus_E7_13 - T(0.027326) * E7_11;
  const T t7_19 = omega7_2 * t7_17 - omega7_3 * t7_18;
  const T t7_20 = T(0.022327) * minus_E7_13;
  const T t7_21 = omega7_3 * t7_20 + omega7_1 * t7_17;
  const T t7_22 = omega7_1 * t7_18 + omega7_2 * t7_20;
  const T t7_23 = T(0.003237) * t7_2 + T(0.027326) * minus_omega_dot_omega1_7_11;
  const T t7_24 = T(0.022327) * t7_2;
  const T t7_25 = T(0.022327) * minus_omega_dot_omega1_7_11;
  const T t7_26 = R7_11 * t7_19 - R6_21 * t7_21 + R7_31 * t7_22 + R6_21 * t7_23 - R7_11 * t7_24 - R7_31 * t7_25;
  const T B17_1_11 = P_dot_omega1_7_11 - t7_26;
  const T t7_27 = T(0.027326) * omega_omega1_7_12 + T(0.003237) * minus_omega_omega1_7_32;
  const T t7_28 = T(0.022327) * omega_omega1_7_12 - T(0.003237) * E6_22;
  const T t7_29 = omega7_3 * t7_27 + omega7_2 * t7_28;
  const T t7_30 = T(0.027326) * E6_22 + T(0.022327) * minus_omega_omega1_7_32;
  const T t7_31 = omega7_3 * t7_30 - omega7_1 * t7_28;
  const T t7_32 = omega7_1 * t7_27 + omega7_2 * t7_30;
  const T t7_33 = T(0.022327) * minus_omega_dot_omega1_7_32 - T(0.027326) * minus_omega_dot_omega1_7_22;
  const T t7_34 = T(0.003237) * minus_omega_dot_omega1_7_32 + T(0.027326) * omega_dot_omega1_7_12;
  const T t7_35 = T(0.022327) * omega_dot_omega1_7_12 + T(0.003237) * minus_omega_dot_omega1_7_22;
  const T B17_1_12 = P_dot_omega1_7_12 - R7_11 * t7_29 - R6_21 * t7_31 + R7_31 * t7_32 - R7_11 * t7_33 + R6_21 * t7_34
      - R7_31 * t7_35;
  const T t7_36 = T(0.027326) * minus_omega_omega1_7_13 + T(0.003237) * omega_omega1_7_33;
  const T t7_37 = T(0.003237) * E6_23 + T(0.022327) * minus_omega_omega1_7_13;
  const T t7_38 = omega7_3 * t7_36 + omega7_2 * t7_37;
  const T t7_39 = T(0.027326) * E6_23 - T(0.022327) * omega_omega1_7_33;
  const T t7_40 = omega7_3 * t7_39 + omega7_1 * t7_37;
  const T t7_41 = omega7_1 * t7_36 - omega7_2 * t7_39;
  const T t7_42 = T(0.027326) * omega_dot_omega1_7_23 + T(0.022327) * minus_omega_dot_omega1_7_33;
  const T t7_43 = T(0.027326) * minus_omega_dot_omega1_7_13 - T(0.003237) * minus_omega_dot_omega1_7_33;
  const T t7_44 = T(0.022327) * minus_omega_dot_omega1_7_13 + T(0.003237) * omega_dot_omega1_7_23;
  const T B17_1_13 = P_dot_omega1_7_13 + R7_11 * t7_38 - R6_21 * t7_40 - R7_31 * t7_41 - R7_11 * t7_42 - R6_21 * t7_43
      + R7_31 * t7_44;
  const T t7_45 = R7_12 * t7_19 - R6_22 * t7_21 + R7_32 * t7_22 + R6_22 * t7_23 - R7_12 * t7_24 - R7_32 * t7_25;
  const T B17_1_21 = P_dot_omega1_7_21 - t7_45;
  const T B17_1_22 = P_dot_omega1_7_22 - R7_12 * t7_29 - R6_22 * t7_31 + R7_32 * t7_32 - R7_12 * t7_33 + R6_22 * t7_34
      - R7_32 * t7_35;
  const T B17_1_23 = P_dot_omega1_7_23 + R7_12 * t7_38 - R6_22 * t7_40 - R7_32 * t7_41 - R7_12 * t7_42 - R6_22 * t7_43
      + R7_32 * t7_44;
  const T t7_46 = R7_13 * t7_19 - R6_23 * t7_21 + R7_33 * t7_22 + R6_23 * t7_23 - R7_13 * t7_24 - R7_33 * t7_25;
  const T B17_1_31 = P_dot_omega1_7_31 - t7_46;
  const T B17_1_32 = P_dot_omega1_7_32 - R7_13 * t7_29 - R6_23 * t7_31 + R7_33 * t7_32 - R7_13 * t7_33 + R6_23 * t7_34
      - R7_33 * t7_35;
  const T B17_1_33 = P_dot_omega1_7_33 + R7_13 * t7_38 - R6_23 * t7_40 - R7_33 * t7_41 - R7_13 * t7_42 - R6_23 * t7_43
      + R7_33 * t7_44;
  v_y_dot[324] = B17_1_11;
  v_y_dot[325] = B17_1_12;
  v_y_dot[326] = B17_1_13;
  v_y_dot[342] = B17_1_21;
  v_y_dot[343] = B17_1_22;
  v_y_dot[344] = B17_1_23;
  v_y_dot[360] = B17_1_31;
  v_y_dot[361] = B17_1_32;
  v_y_dot[362] = B17_1_33;
  // B18_6 = -R7^T omega7~ r7~ omega_thetadot6_7 - R7^T r7~ omega_dot_thetadot6_7 + P_dot_thetadot6_7
  const T minus_B18_6_1 = t7_26 - t7_6;
  const T minus_B18_6_2 = t7_45 - t7_15;
  const T minus_B18_6_3 = t7_46 - t7_16;
  v_y_dot[330] = -minus_B18_6_1;
  v_y_dot[348] = -minus_B18_6_2;
  v_y_dot[366] = -minus_B18_6_3;
  // B19_7 = -R7^T omega7~ r7~ b7
  const T t7_47 = omega7_3 * T(0.027326) + omega7_1 * T(0.003237);
  const T t7_48 = omega7_2 * T(0.003237);
  const T t7_49 = omega7_2 * T(0.027326);
  const T minus_B19_7_1 = R6_21 * t7_47 - R7_11 * t7_48 - R7_31 * t7_49;
  const T minus_B19_7_2 = R6_22 * t7_47 - R7_12 * t7_48 - R7_32 * t7_49;
  const T minus_B19_7_3 = R6_23 * t7_47 - R7_13 * t7_48 - R7_33 * t7_49;
  v_y_dot[331] = -minus_B19_7_1;
  v_y_dot[349] = -minus_B19_7_2;
  v_y_dot[367] = -minus_B19_7_3;

  // ---- body 8 (fl_calf) on body 7
  const T thetadot8 = y[8];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[9];
  const T minus_E8_13 = sines[9];
  // R8^T = R7^T E8^T: R takes inertial components to body components
  const T R8_11 = R7_11 * E8_11 - R7_31 * minus_E8_13;
  const T R8_12 = R7_12 * E8_11 - R7_32 * minus_E8_13;
  const T R8_13 = R7_13 * E8_11 - R7_33 * minus_E8_13;
  const T R8_31 = R7_11 * minus_E8_13 + R7_31 * E8_11;
  const T R8_32 = R7_12 * minus_E8_13 + R7_32 * E8_11;
  const T R8_33 = R7_13 * minus_E8_13 + R7_33 * E8_11;
  // omega8 = thetadot8 b8 + E8 omega7: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega7_1 - minus_E8_13 * omega7_3;
  const T omega8_2 = thetadot8 + omega7_2;
  const T omega8_3 = minus_E8_13 * omega7_1 + E8_11 * omega7_3;
  // omega_omega1_8 = E8 omega_omega1_7: partial angular velocity, body axes
  const T omega_omega1_8_11 = E8_11 * E7_11 - minus_E8_13 * minus_E7_13;
  const T omega_omega1_8_12 = E8_11 * omega_omega1_7_12 + minus_E8_13 * minus_omega_omega1_7_32;
  const T minus_omega_omega1_8_13 = E8_11 * minus_omega_omega1_7_13 + minus_E8_13 * omega_omega1_7_33;
  const T omega_omega1_8_31 = minus_E8_13 * E7_11 + E8_11 * minus_E7_13;
  const T omega_omega1_8_32 = minus_E8_13 * omega_omega1_7_12 - E8_11 * minus_omega_omega1_7_32;
  const T omega_omega1_8_33 = E8_11 * omega_omega1_7_33 - minus_E8_13 * minus_omega_omega1_7_13;
  // omega_dot_omega1_8 = -thetadot8 b8~ E8 omega_omega1_7 + E8 omega_dot_omega1_7: its rate
  const T minus_omega_dot_omega1_8_11 = thetadot8 * omega_omega1_8_31 + minus_E8_13 * t7_2 + E8_11 *
      minus_omega_dot_omega1_7_11;
  const T omega_dot_omega1_8_12 = minus_E8_13 * minus_omega_dot_omega1_7_32 + E8_11 * omega_dot_omega1_7_12 -
      thetadot8 * omega_omega1_8_32;
  const T omega_dot_omega1_8_13 = minus_E8_13 * minus_omega_dot_omega1_7_33 - E8_11 * minus_omega_dot_omega1_7_13 -
      thetadot8 * omega_omega1_8_33;
  const T omega_dot_omega1_8_31 = E8_11 * t7_2 - minus_E8_13 * minus_omega_dot_omega1_7_11 + thetadot8 *
      omega_omega1_8_11;
  const T omega_dot_omega1_8_32 = minus_E8_13 * omega_dot_omega1_7_12 - E8_11 * minus_omega_dot_omega1_7_32 +
      thetadot8 * omega_omega1_8_12;
  const T minus_omega_dot_omega1_8_33 = thetadot8 * minus_omega_omega1_8_13 + minus_E8_13 *
      minus_omega_dot_omega1_7_13 + E8_11 * minus_omega_dot_omega1_7_33;
  // P_dot_omega1_8 = R7^T (-omega7~ q8~ omega_omega1_7 - q8~ omega_dot_omega1_7) + P_dot_omega1_7: its rate
  const T t8_1 = T(0.2) * E7_11;
  const T t8_2 = omega7_3 * t8_1;
  const T t8_3 = T(0.2) * minus_omega_dot_omega1_7_11;
  const T t8_4 = omega7_1 * t8_1;
  const T t8_5 = R7_11 * t8_2 + R6_21 * t8_3 - R7_31 * t8_4;
  const T P_dot_omega1_8_11 = P_dot_omega1_7_11 - t8_5;
  const T t8_6 = T(0.2) * omega_omega1_7_12;
  const T t8_7 = T(0.2) * minus_omega_dot_omega1_7_22;
  const T t8_8 = omega7_3 * t8_6 - t8_7;
  const T t8_9 = T(0.2) * E6_22;
  const T t8_10 = omega7_3 * t8_9 - T(0.2) * omega_dot_omega1_7_12;
  const T t8_11 = omega7_1 * t8_6 + omega7_2 * t8_9;
  const T P_dot_omega1_8_12 = P_dot_omega1_7_12 - R7_11 * t8_8 - R6_21 * t8_10 + R7_31 * t8_11;
  const T t8_12 = T(0.2) * omega_dot_omega1_7_23;
  const T t8_13 = T(0.2) * minus_omega_omega1_7_13;
  const T t8_14 = t8_12 - omega7_3 * t8_13;
  const T t8_15 = T(0.2) * E6_23;
  const T t8_16 = omega7_3 * t8_15 + T(0.2) * minus_omega_dot_omega1_7_13;
  const T t8_17 = omega7_1 * t8_13 - omega7_2 * t8_15;
  const T P_dot_omega1_8_13 = P_dot_omega1_7_13 - R7_11 * t8_14 - R6_21 * t8_16 - R7_31 * t8_17;
  const T t8_18 = R7_12 * t8_2 + R6_22 * t8_3 - R7_32 * t8_4;
  const T P_dot_omega1_8_21 = P_dot_omega1_7_21 - t8_18;
  const T P_dot_omega1_8_22 = P_dot_omega1_7_22 - R7_12 * t8_8 - R6_22 * t8_10 + R7_32 * t8_11;
  const T P_dot_omega1_8_23 = P_dot_omega1_7_23 - R7_12 * t8_14 - R6_22 * t8_16 - R7_32 * t8_17;
  const T t8_19 = R7_13 * t8_2 + R6_23 * t8_3 - R7_33 * t8_4;
  const T P_dot_omega1_8_31 = P_dot_omega1_7_31 - t8_19;
  const T P_dot_omega1_8_32 = P_dot_omega1_7_32 - R7_13 * t8_8 - R6_23 * t8_10 + R7_33 * t8_11;
  const T P_dot_omega1_8_33 = P_dot_omega1_7_33 - R7_13 * t8_14 - R6_23 * t8_16 - R7_33 * t8_17;
  // P_dot_thetadot6_8 = R7^T (-omega7~ q8~ omega_thetadot6_7 - q8~ omega_dot_thetadot6_7) + P_dot_thetadot6_7: its
  //   rate
  const T minus_P_dot_thetadot6_8_1 = t8_5 - t7_6;
  const T minus_P_dot_thetadot6_8_2 = t8_18 - t7_15;
  const T minus_P_dot_thetadot6_8_3 = t8_19 - t7_16;
  // P_dot_thetadot7_8 = -R7^T omega7~ q8~ b7: its rate
  const T t8_20 = omega7_3 * T(0.2);
  const T t8_21 = omega7_2 * T(0.2);
  const T minus_P_dot_thetadot7_8_1 = R6_21 * t8_20 - R7_31 * t8_21;
  const T minus_P_dot_thetadot7_8_2 = R6_22 * t8_20 - R7_32 * t8_21;
  const T minus_P_dot_thetadot7_8_3 = R6_23 * t8_20 - R7_33 * t8_21;
  // B20_1 = -R8^T omega8~ r8~ omega_omega1_8 - R8^T r8~ omega_dot_omega1_8 + P_dot_omega1_8
  const T t8_22 = T(0.107388) * omega_omega1_8_11 + T(0.006435) * omega_omega1_8_31;
  const T t8_23 = omega8_3 * t8_22;
  const T t8_24 = omega8_1 * t8_22;
  const T t8_25 = T(0.107388) * minus_omega_dot_omega1_8_11 - T(0.006435) * omega_dot_omega1_8_31;
  const T t8_26 = R8_11 * t8_23 - R8_31 * t8_24 + R6_21 * t8_25;
  const T B20_1_11 = P_dot_omega1_8_11 - t8_26;
  const T t8_27 = T(0.107388) * omega_omega1_8_12 + T(0.006435) * omega_omega1_8_32;
  const T t8_28 = T(0.006435) * E6_22;
  const T t8_29 = omega8_3 * t8_27 + omega8_2 * t8_28;
  const T t8_30 = T(0.107388) * E6_22;
  const T t8_31 = omega8_3 * t8_30 - omega8_1 * t8_28;
  const T t8_32 = omega8_1 * t8_27 + omega8_2 * t8_30;
  const T t8_33 = T(0.107388) * minus_omega_dot_omega1_7_22;
  const T t8_34 = T(0.107388) * omega_dot_omega1_8_12 + T(0.006435) * omega_dot_omega1_8_32;
  const T t8_35 = T(0.006435) * minus_omega_dot_omega1_7_22;
  const T B20_1_12 = P_dot_omega1_8_12 - R8_11 * t8_29 - R6_21 * t8_31 + R8_31 * t8_32 + R8_11 * t8_33 + R6_21 * t8_34
      + R8_31 * t8_35;
  const T t8_36 = T(0.006435) * E6_23;
  const T t8_37 = T(0.107388) * minus_omega_omega1_8_13 - T(0.006435) * omega_omega1_8_33;
  const T t8_38 = omega8_2 * t8_36 - omega8_3 * t8_37;
  const T t8_39 = T(0.107388) * E6_23;
  const T t8_40 = omega8_3 * t8_39 - omega8_1 * t8_36;
  const T t8_41 = omega8_1 * t8_37 - omega8_2 * t8_39;
  const T t8_42 = T(0.107388) * omega_dot_omega1_7_23;
  const T t8_43 = T(0.006435) * minus_omega_dot_omega1_8_33 - T(0.107388) * omega_dot_omega1_8_13;
  const T t8_44 = T(0.006435) * omega_dot_omega1_7_23;
  const T B20_1_13 = P_dot_omega1_8_13 - R8_11 * t8_38 - R6_21 * t8_40 - R8_31 * t8_41 - R8_11 * t8_42 - R6_21 * t8_43
      - R8_31 * t8_44;
  const T t8_45 = R8_12 * t8_23 - R8_32 * t8_24 + R6_22 * t8_25;
  const T B20_1_21 = P_dot_omega1_8_21 - t8_45;
  const T B20_1_22 = P_dot_omega1_8_22 - R8_12 * t8_29 - R6_22 * t8_31 + R8_32 * t8_32 + R8_12 * t8_33 + R6_22 * t8_34
      + R8_32 * t8_35;
  const T B20_1_23 = P_dot_omega1_8_23 - R8_12 * t8_38 - R6_22 * t8_40 - R8_32 * t8_41 - R8_12 * t8_42 - R6_22 * t8_43
      - R8_32 * t8_44;
  const T t8_46 = R8_13 * t8_23 - R8_33 * t8_24 + R6_23 * t8_25;
  const T B20_1_31 = P_dot_omega1_8_31 - t8_46;
  const T B20_1_32 = P_dot_omega1_8_32 - R8_13 * t8_29 - R6_23 * t8_31 + R8_33 * t8_32 + R8_13 * t8_33 + R6_23 * t8_34
      + R8_33 * t8_35;
  const T B20_1_33 = P_dot_omega1_8_33 - R8_13 * t8_38 - R6_23 * t8_40 - R8_33 * t8_41 - R8_13 * t8_42 - R6_23 * t8_43
      - R8_33 * t8_44;
  v_y_dot[378] = B20_1_11;
  v_y_dot[379] = B20_1_12;
  v_y_dot[380] = B20_1_13;
  v_y_dot[396] = B20_1_21;
  v_y_dot[397] = B20_1_22;
  v_y_dot[398] = B20_1_23;
  v_y_dot[414] = B20_1_31;
  v_y_dot[415] = B20_1_32;
  v_y_dot[416] = B20_1_33;
  // B21_6 = -R8^T omega8~ r8~ omega_thetadot6_8 - R8^T r8~ omega_dot_thetadot6_8 + P_dot_thetadot6_8
  const T minus_B21_6_1 = t8_26 + minus_P_dot_thetadot6_8_1;
  const T minus_B21_6_2 = t8_45 + minus_P_dot_thetadot6_8_2;
  const T minus_B21_6_3 = t8_46 + minus_P_dot_thetadot6_8_3;
  v_y_dot[384] = -minus_B21_6_1;
  v_y_dot[402] = -minus_B21_6_2;
  v_y_dot[420] = -minus_B21_6_3;
  // B22_7 = -R8^T omega8~ r8~ omega_thetadot7_8 - R8^T r8~ omega_dot_thetadot7_8 + P_dot_thetadot7_8
  const T t8_47 = omega8_2 * T(0.006435);
  const T t8_48 = omega8_3 * T(0.107388) - omega8_1 * T(0.006435);
  const T t8_49 = omega8_2 * T(0.107388);
  const T t8_50 = R8_11 * t8_47 + R6_21 * t8_48 - R8_31 * t8_49;
  const T minus_B22_7_1 = t8_50 + minus_P_dot_thetadot7_8_1;
  const T t8_51 = R8_12 * t8_47 + R6_22 * t8_48 - R8_32 * t8_49;
  const T minus_B22_7_2 = t8_51 + minus_P_dot_thetadot7_8_2;
  const T t8_52 = R8_13 * t8_47 + R6_23 * t8_48 - R8_33 * t8_49;
  const T minus_B22_7_3 = t8_52 + minus_P_dot_thetadot7_8_3;
  v_y_dot[385] = -minus_B22_7_1;
  v_y_dot[403] = -minus_B22_7_2;
  v_y_dot[421] = -minus_B22_7_3;
  v_y_dot[386] = -t8_50;
  v_y_dot[404] = -t8_51;
  v_y_dot[422] = -t8_52;
  // B24_1 = -R8^T omega8~ o9~ omega_omega1_8 - R8^T o9~ omega_dot_omega1_8 + P_dot_omega1_8
  const T t8_53 = T(0.2) * omega_omega1_8_11;
  const T t8_54 = omega8_3 * t8_53;
  const T t8_55 = omega8_1 * t8_53;
  const T t8_56 = T(0.2) * minus_omega_dot_omega1_8_11;
  const T t8_57 = R8_11 * t8_54 - R8_31 * t8_55 + R6_21 * t8_56;
  const T B24_1_11 = P_dot_omega1_8_11 - t8_57;
  const T t8_58 = T(0.2) * omega_omega1_8_12;
  const T t8_59 = omega8_3 * t8_58;
  const T t8_60 = omega8_3 * t8_9;
  const T t8_61 = omega8_1 * t8_58 + omega8_2 * t8_9;
  const T t8_62 = T(0.2) * omega_dot_omega1_8_12;
  const T B24_1_12 = P_dot_omega1_8_12 - R8_11 * t8_59 - R6_21 * t8_60 + R8_31 * t8_61 + R8_11 * t8_7 + R6_21 * t8_62;
  const T t8_63 = T(0.2) * minus_omega_omega1_8_13;
  const T t8_64 = omega8_3 * t8_63;
  const T t8_65 = omega8_3 * t8_15;
  const T t8_66 = omega8_1 * t8_63 - omega8_2 * t8_15;
  const T t8_67 = T(0.2) * omega_dot_omega1_8_13;
  const T B24_1_13 = P_dot_omega1_8_13 + R8_11 * t8_64 - R6_21 * t8_65 - R8_31 * t8_66 - R8_11 * t8_12 + R6_21 *
      t8_67;
  const T t8_68 = R8_12 * t8_54 - R8_32 * t8_55 + R6_22 * t8_56;
  const T B24_1_21 = P_dot_omega1_8_21 - t8_68;
  const T B24_1_22 = P_dot_omega1_8_22 - R8_12 * t8_59 - R6_22 * t8_60 + R8_32 * t8_61 + R8_12 * t8_7 + R6_22 * t8_62;
  const T B24_1_23 = P_dot_omega1_8_23 + R8_12 * t8_64 - R6_22 * t8_65 - R8_32 * t8_66 - R8_12 * t8_12 + R6_22 *
      t8_67;
  const T t8_69 = R8_13 * t8_54 - R8_33 * t8_55 + R6_23 * t8_56;
  const T B24_1_31 = P_dot_omega1_8_31 - t8_69;
  const T B24_1_32 = P_dot_omega1_8_32 - R8_13 * t8_59 - R6_23 * t8_60 + R8_33 * t8_61 + R8_13 * t8_7 + R6_23 * t8_62;
  const T B24_1_33 = P_dot_omega1_8_33 + R8_13 * t8_64 - R6_23 * t8_65 - R8_33 * t8_66 - R8_13 * t8_12 + R6_23 *
      t8_67;
  v_y_dot[432] = B24_1_11;
  v_y_dot[433] = B24_1_12;
  v_y_dot[434] = B24_1_13;
  v_y_dot[450] = B24_1_21;
  v_y_dot[451] = B24_1_22;
  v_y_dot[452] = B24_1_23;
  v_y_dot[468] = B24_1_31;
  v_y_dot[469] = B24_1_32;
  v_y_dot[470] = B24_1_33;
  // B25_6 = -R8^T omega8~ o9~ omega_thetadot6_8 - R8^T o9~ omega_dot_thetadot6_8 + P_dot_thetadot6_8
  const T minus_B25_6_1 = t8_57 + minus_P_dot_thetadot6_8_1;
  const T minus_B25_6_2 = t8_68 + minus_P_dot_thetadot6_8_2;
  const T minus_B25_6_3 = t8_69 + minus_P_dot_thetadot6_8_3;
  v_y_dot[438] = -minus_B25_6_1;
  v_y_dot[456] = -minus_B25_6_2;
  v_y_dot[474] = -minus_B25_6_3;
  // B26_7 = -R8^T omega8~ o9~ omega_thetadot7_8 - R8^T o9~ omega_dot_thetadot7_8 + P_dot_thetadot7_8
  const T t8_70 = omega8_3 * T(0.2);
  const T t8_71 = omega8_2 * T(0.2);
  const T t8_72 = R6_21 * t8_70 - R8_31 * t8_71;
  const T minus_B26_7_1 = t8_72 + minus_P_dot_thetadot7_8_1;
  const T t8_73 = R6_22 * t8_70 - R8_32 * t8_71;
  const T minus_B26_7_2 = t8_73 + minus_P_dot_thetadot7_8_2;
  const T t8_74 = R6_23 * t8_70 - R8_33 * t8_71;
  const T minus_B26_7_3 = t8_74 + minus_P_dot_thetadot7_8_3;
  v_y_dot[439] = -minus_B26_7_1;
  v_y_dot[457] = -minus_B26_7_2;
  v_y_dot[475] = -minus_B26_7_3;
  v_y_dot[440] = -t8_72;
  v_y_dot[458] = -t8_73;
  v_y_dot[476] = -t8_74;

  // ---- body 10 (rr_hip) on body 1
  const T thetadot10 = y[9];
  // E10^T = Rot(b10, theta10): E takes components in the lower body to those in the body
  const T E10_22 = cosines[10];
  const T E10_23 = sines[10];
  // R10^T = R1^T E10^T: R takes inertial components to body components
  const T R10_21 = R1_21 * E10_22 + R1_31 * E10_23;
  const T R10_22 = R1_22 * E10_22 + R1_32 * E10_23;
  const T R10_23 = R1_23 * E10_22 + R1_33 * E10_23;
  const T R10_31 = R1_31 * E10_22 - R1_21 * E10_23;
  const T R10_32 = R1_32 * E10_22 - R1_22 * E10_23;
  const T R10_33 = R1_33 * E10_22 - R1_23 * E10_23;
  // omega10 = thetadot10 b10 + E10 omega1: absolute angular velocity, body axes [rad/s]
  const T omega10_1 = thetadot10 + omega1_1;
  const T omega10_2 = E10_22 * omega1_2 + E10_23 * omega1_3;
  const T omega10_3 = E10_22 * omega1_3 - E10_23 * omega1_2;
  // B28_1 = thetadot10 R10^T r10~ b10~ E10 - R10^T omega10~ r10~ E10 + P_dot_omega1_10
  const T t10_1 = omega10_2 * T(0.000635) - omega10_3 * T(3.1e-05);
  const T t10_2 = omega10_1 * T(0.000635);
  const T t10_3 = omega10_1 * T(3.1e-05);
  const T t10_4 = R1_11 * t10_1 - R10_21 * t10_2 + R10_31 * t10_3;
  const T minus_B28_1_11 = t10_4 + minus_P_dot_omega1_2_11;
  const T t10_5 = T(0.003311) * E10_22;
  const T t10_6 = T(0.003311) * E10_23;
  const T t10_7 = omega10_2 * t10_5 - omega10_3 * t10_6;
  const T t10_8 = T(0.000635) * E10_23 - T(3.1e-05) * E10_22;
  const T t10_9 = omega10_1 * t10_5;
  const T t10_10 = omega10_3 * t10_8 - t10_9;
  const T t10_11 = omega10_1 * t10_6;
  const T t10_12 = t10_11 - omega10_2 * t10_8;
  const T t10_13 = T(3.1e-05) * E10_23 + T(0.000635) * E10_22;
  const T B28_1_12 = minus_P_dot_omega1_2_12 - R1_11 * t10_7 - R10_21 * t10_10 - R10_31 * t10_12 + thetadot10 *
      (R10_31 * t10_6 - (R1_11 * t10_13 + R10_21 * t10_5));
  const T t10_14 = omega10_3 * t10_5 + omega10_2 * t10_6;
  const T t10_15 = t10_11 + omega10_3 * t10_13;
  const T t10_16 = omega10_2 * t10_13 - t10_9;
  const T B28_1_13 = minus_P_dot_omega1_6_13 - thetadot10 * (R1_11 * t10_8 + R10_21 * t10_6 + R10_31 * t10_5) - R1_11
      * t10_14 + R10_21 * t10_15 - R10_31 * t10_16;
  const T t10_17 = R1_12 * t10_1 - R10_22 * t10_2 + R10_32 * t10_3;
  const T minus_B28_1_21 = t10_17 + minus_P_dot_omega1_2_21;
  const T B28_1_22 = minus_P_dot_omega1_2_22 - R1_12 * t10_7 - R10_22 * t10_10 - R10_32 * t10_12 + thetadot10 *
      (R10_32 * t10_6 - (R1_12 * t10_13 + R10_22 * t10_5));
  const T B28_1_23 = minus_P_dot_omega1_6_23 - thetadot10 * (R1_12 * t10_8 + R10_22 * t10_6 + R10_32 * t10_5) - R1_12
      * t10_14 + R10_22 * t10_15 - R10_32 * t10_16;
  const T t10_18 = R1_13 * t10_1 - R10_23 * t10_2 + R10_33 * t10_3;
  const T minus_B28_1_31 = t10_18 + minus_P_dot_omega1_2_31;
  const T B28_1_32 = minus_P_dot_omega1_2_32 - R1_13 * t10_7 - R10_23 * t10_10 - R10_33 * t10_12 + thetadot10 *
      (R10_33 * t10_6 - (R1_13 * t10_13 + R10_23 * t10_5));
  const T B28_1_33 = minus_P_dot_omega1_6_33 - thetadot10 * (R1_13 * t10_8 + R10_23 * t10_6 + R10_33 * t10_5) - R1_13
      * t10_14 + R10_23 * t10_15 - R10_33 * t10_16;
  v_y_dot[486] = -minus_B28_1_11;
  v_y_dot[487] = B28_1_12;
  v_y_dot[488] = B28_1_13;
  v_y_dot[504] = -minus_B28_1_21;
  v_y_dot[505] = B28_1_22;
  v_y_dot[506] = B28_1_23;
  v_y_dot[522] = -minus_B28_1_31;
  v_y_dot[523] = B28_1_32;
  v_y_dot[524] = B28_1_33;
  v_y_dot[495] = -t10_4;
  v_y_dot[513] = -t10_17;
  v_y_dot[531] = -t10_18;

  // ---- body 11 (rr_thigh) on body 10
  const T thetadot11 = y[10];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[11];
  const T minus_E11_13 = sines[11];
  // R11^T = R10^T E11^T: R takes inertial components to body components
  const T R11_11 = R1_11 * E11_11 - R10_31 * minus_E11_13;
  const T R11_12 = R1_12 * E11_11 - R10_32 * minus_E11_13;
  const T R11_13 = R1_13 * E11_11 - R10_33 * minus_E11_13;
  const T R11_31 = R1_11 * minus_E11_13 + R10_31 * E11_11;
  const T R11_32 = R1_12 * minus_E11_13 + R10_32 * E11_11;
  const T R11_33 = R1_13 * minus_E11_13 + R10_33 * E11_11;
  // omega11 = thetadot11 b11 + E11 omega10: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega10_1 - minus_E11_13 * omega10_3;
  const T omega11_2 = thetadot11 + omega10_2;
  const T omega11_3 = minus_E11_13 * omega10_1 + E11_11 * omega10_3;
  // omega_omega1_11 = E11 E10: partial angular velocity, body axes
  const T omega_omega1_11_12 = minus_E11_13 * E10_23;
  const T minus_omega_omega1_11_13 = minus_E11_13 * E10_22;
  const T minus_omega_omega1_11_32 = E11_11 * E10_23;
  const T omega_omega1_11_33 = E11_11 * E10_22;
  // omega_dot_omega1_11 = -(thetadot10 E11 b10~ + thetadot11 b11~ E11) E10: its rate
  const T minus_omega_dot_omega1_11_11 = thetadot11 * minus_E11_13;
  const T t11_1 = thetadot10 * minus_E11_13;
  const T t11_2 = thetadot11 * E11_11;
  const T omega_dot_omega1_11_12 = t11_1 * E10_22 + t11_2 * E10_23;
  const T minus_omega_dot_omega1_11_13 = t11_2 * E10_22 - t11_1 * E10_23;
  const T minus_omega_dot_omega1_11_22 = thetadot10 * E10_23;
  const T omega_dot_omega1_11_23 = thetadot10 * E10_22;
  const T t11_3 = thetadot10 * E11_11;
  const T minus_omega_dot_omega1_11_32 = t11_3 * E10_22 - minus_omega_dot_omega1_11_11 * E10_23;
  const T minus_omega_dot_omega1_11_33 = t11_3 * E10_23 + minus_omega_dot_omega1_11_11 * E10_22;
  // P_dot_omega1_11 = R10^T (thetadot10 q11~ b10~ - omega10~ q11~) E10 + P_dot_omega1_10: its rate
  const T t11_4 = omega10_1 * T(0.0838);
  const T t11_5 = omega10_2 * T(0.0838);
  const T t11_6 = R10_21 * t11_4 - R1_11 * t11_5;
  const T P_dot_omega1_11_11 = t11_6 - minus_P_dot_omega1_2_11;
  const T t11_7 = thetadot10 * T(0.0838);
  const T t11_8 = t11_7 * E10_22;
  const T t11_9 = omega10_3 * T(0.0838);
  const T t11_10 = t11_9 * E10_23;
  const T t11_11 = t11_5 * E10_23;
  const T P_dot_omega1_11_12 = minus_P_dot_omega1_2_12 - R1_11 * t11_8 - R10_21 * t11_10 + R10_31 * t11_11;
  const T t11_12 = t11_9 * E10_22;
  const T t11_13 = t11_7 * E10_23;
  const T t11_14 = t11_5 * E10_22;
  const T P_dot_omega1_11_13 = minus_P_dot_omega1_6_13 + R10_21 * t11_12 - R1_11 * t11_13 - R10_31 * t11_14;
  const T t11_15 = R10_22 * t11_4 - R1_12 * t11_5;
  const T P_dot_omega1_11_21 = t11_15 - minus_P_dot_omega1_2_21;
  const T P_dot_omega1_11_22 = minus_P_dot_omega1_2_22 - R1_12 * t11_8 - R10_22 * t11_10 + R10_32 * t11_11;
  const T P_dot_omega1_11_23 = minus_P_dot_omega1_6_23 + R10_22 * t11_12 - R1_12 * t11_13 - R10_32 * t11_14;
  const T t11_16 = R10_23 * t11_4 - R1_13 * t11_5;
  const T P_dot_omega1_11_31 = t11_16 - minus_P_dot_omega1_2_31;
  const T P_dot_omega1_11_32 = minus_P_dot_omega1_2_32 - R1_13 * t11_8 - R10_23 * t11_10 + R10_33 * t11_11;
  const T P_dot_omega1_11_33 = minus_P_dot_omega1_6_33 + R10_23 * t11_12 - R1_13 * t11_13 - R10_33 * t11_14;
  // B30_1 = -R11^T omega11~ r11~ omega_omega1_11 - R11^T r11~ omega_dot_omega1_11 + P_dot_omega1_11
  const T t11_17 = T(0.022327) * minus_E11_13;
  const T t11_18 = T(0.022327) * E11_11;
  const T t11_19 = omega11_3 * t11_17 + omega11_1 * t11_18;
  const T t11_20 = T(0.003237) * minus_E11_13 - T(0.027326) * E11_11;
  const T t11_21 = omega11_3 * t11_20 + omega11_2 * t11_18;
  const T t11_22 = omega11_1 * t11_20 - omega11_2 * t11_17;
  const T t11_23 = T(0.022327) * t11_2;
  const T t11_24 = T(0.003237) * t11_2 + T(0.027326) * minus_omega_dot_omega1_11_11;
  const T t11_25 = T(0.022327) * minus_omega_dot_omega1_11_11;
  const T t11_26 = R10_21 * t11_19 - R11_11 * t11_21 + R11_31 * t11_22 + R11_11 * t11_23 + R10_21 * t11_24 + R11_31 *
      t11_25;
  const T B30_1_11 = P_dot_omega1_11_11 - t11_26;
  const T t11_27 = T(0.027326) * omega_omega1_11_12 + T(0.003237) * minus_omega_omega1_11_32;
  const T t11_28 = T(0.003237) * E10_22 + T(0.022327) * omega_omega1_11_12;
  const T t11_29 = omega11_3 * t11_27 - omega11_2 * t11_28;
  const T t11_30 = T(0.027326) * E10_22 - T(0.022327) * minus_omega_omega1_11_32;
  const T t11_31 = omega11_3 * t11_30 + omega11_1 * t11_28;
  const T t11_32 = omega11_1 * t11_27 + omega11_2 * t11_30;
  const T t11_33 = T(0.027326) * minus_omega_dot_omega1_11_22 + T(0.022327) * minus_omega_dot_omega1_11_32;
  const T t11_34 = T(0.003237) * minus_omega_dot_omega1_11_32 + T(0.027326) * omega_dot_omega1_11_12;
  const T t11_35 = T(0.003237) * minus_omega_dot_omega1_11_22 - T(0.022327) * omega_dot_omega1_11_12;
  const T B30_1_12 = P_dot_omega1_11_12 - R11_11 * t11_29 - R10_21 * t11_31 + R11_31 * t11_32 + R11_11 * t11_33 +
      R10_21 * t11_34 - R11_31 * t11_35;
  const T t11_36 = T(0.022327) * minus_omega_omega1_11_13 - T(0.003237) * E10_23;
  const T t11_37 = T(0.027326) * minus_omega_omega1_11_13 + T(0.003237) * omega_omega1_11_33;
  const T t11_38 = omega11_2 * t11_36 - omega11_3 * t11_37;
  const T t11_39 = T(0.027326) * E10_23 + T(0.022327) * omega_omega1_11_33;
  const T t11_40 = omega11_3 * t11_39 - omega11_1 * t11_36;
  const T t11_41 = omega11_1 * t11_37 - omega11_2 * t11_39;
  const T t11_42 = T(0.027326) * omega_dot_omega1_11_23 - T(0.022327) * minus_omega_dot_omega1_11_33;
  const T t11_43 = T(0.027326) * minus_omega_dot_omega1_11_13 - T(0.003237) * minus_omega_dot_omega1_11_33;
  const T t11_44 = T(0.022327) * minus_omega_dot_omega1_11_13 - T(0.003237) * omega_dot_omega1_11_23;
  const T B30_1_13 = P_dot_omega1_11_13 - R11_11 * t11_38 - R10_21 * t11_40 - R11_31 * t11_41 - R11_11 * t11_42 -
      R10_21 * t11_43 - R11_31 * t11_44;
  const T t11_45 = R10_22 * t11_19 - R11_12 * t11_21 + R11_32 * t11_22 + R11_12 * t11_23 + R10_22 * t11_24 + R11_32 *
      t11_25;
  const T B30_1_21 = P_dot_omega1_11_21 - t11_45;
  const T B30_1_22 = P_dot_omega1_11_22 - R11_12 * t11_29 - R10_22 * t11_31 + R11_32 * t11_32 + R11_12 * t11_33 +
      R10_22 * t11_34 - R11_32 * t11_35;
  const T B30_1_23 = P_dot_omega1_11_23 - R11_12 * t11_38 - R10_22 * t11_40 - R11_32 * t11_41 - R11_12 * t11_42 -
      R10_22 * t11_43 - R11_32 * t11_44;
  const T t11_46 = R10_23 * t11_19 - R11_13 * t11_21 + R11_33 * t11_22 + R11_13 * t11_23 + R10_23 * t11_24 + R11_33 *
      t11_25;
  const T B30_1_31 = P_dot_omega1_11_31 - t11_46;
  const T B30_1_32 = P_dot_omega1_11_32 - R11_13 * t11_29 - R10_23 * t11_31 + R11_33 * t11_32 + R11_13 * t11_33 +
      R10_23 * t11_34 - R11_33 * t11_35;
  const T B30_1_33 = P_dot_omega1_11_33 - R11_13 * t11_38 - R10_23 * t11_40 - R11_33 * t11_41 - R11_13 * t11_42 -
      R10_23 * t11_43 - R11_33 * t11_44;
  v_y_dot[540] = B30_1_11;
  v_y_dot[541] = B30_1_12;
  v_y_dot[542] = B30_1_13;
  v_y_dot[558] = B30_1_21;
  v_y_dot[559] = B30_1_22;
  v_y_dot[560] = B30_1_23;
  v_y_dot[576] = B30_1_31;
  v_y_dot[577] = B30_1_32;
  v_y_dot[578] = B30_1_33;
  // B31_10 = -R11^T omega11~ r11~ omega_thetadot10_11 - R11^T r11~ omega_dot_thetadot10_11 + P_dot_thetadot10_11
  const T minus_B31_10_1 = t11_26 - t11_6;
  const T minus_B31_10_2 = t11_45 - t11_15;
  const T minus_B31_10_3 = t11_46 - t11_16;
  v_y_dot[549] = -minus_B31_10_1;
  v_y_dot[567] = -minus_B31_10_2;
  v_y_dot[585] = -minus_B31_10_3;
  // B32_11 = -R11^T omega11~ r11~ b11
  const T t11_47 = omega11_3 * T(0.027326) + omega11_1 * T(0.003237);
  const T t11_48 = omega11_2 * T(0.003237);
  const T t11_49 = omega11_2 * T(0.027326);
  const T minus_B32_11_1 = R10_21 * t11_47 - R11_11 * t11_48 - R11_31 * t11_49;
  const T minus_B32_11_2 = R10_22 * t11_47 - R11_12 * t11_48 - R11_32 * t11_49;
  const T minus_B32_11_3 = R10_23 * t11_47 - R11_13 * t11_48 - R11_33 * t11_49;
  v_y_dot[550] = -minus_B32_11_1;
  v_y_dot[568] = -minus_B32_11_2;
  v_y_dot[586] = -minus_B32_11_3;

  // ---- body 12 (rr_calf) on body 11
  const T thetadot12 = y[11];
  // E12^T = Rot(b12, theta12): E takes components in the lower body to those in the body
  const T E12_11 = cosines[12];
  const T minus_E12_13 = sines[12];
  // R12^T = R11^T E12^T: R takes inertial components to body components
  const T R12_11 = R11_11 * E12_11 - R11_31 * minus_E12_13;
  const T R12_12 = R11_12 * E12_11 - R11_32 * minus_E12_13;
  const T R12_13 = R11_13 * E12_11 - R11_33 * minus_E12_13;
  const T R12_31 = R11_11 * minus_E12_13 + R11_31 * E12_11;
  const T R12_32 = R11_12 * minus_E12_13 + R11_32 * E12_11;
  const T R12_33 = R11_13 * minus_E12_13 + R11_33 * E12_11;
  // omega12 = thetadot12 b12 + E12 omega11: absolute angular velocity, body axes [rad/s]
  const T omega12_1 = E12_11 * omega11_1 - minus_E12_13 * omega11_3;
  const T omega12_2 = thetadot12 + omega11_2;
  const T omega12_3 = minus_E12_13 * omega11_1 + E12_11 * omega11_3;
  // omega_omega1_12 = E12 omega_omega1_11: partial angular velocity, body axes
  const T omega_omega1_12_11 = E12_11 * E11_11 - minus_E12_13 * minus_E11_13;
  const T omega_omega1_12_12 = E12_11 * omega_omega1_11_12 + minus_E12_13 * minus_omega_omega1_11_32;
  const T minus_omega_omega1_12_13 = E12_11 * minus_omega_omega1_11_13 + minus_E12_13 * omega_omega1_11_33;
  const T omega_omega1_12_31 = minus_E12_13 * E11_11 + E12_11 * minus_E11_13;
  const T omega_omega1_12_32 = minus_E12_13 * omega_omega1_11_12 - E12_11 * minus_omega_omega1_11_32;
  const T omega_omega1_12_33 = E12_11 * omega_omega1_11_33 - minus_E12_13 * minus_omega_omega1_11_13;
  // omega_dot_omega1_12 = -thetadot12 b12~ E12 omega_omega1_11 + E12 omega_dot_omega1_11: its rate
  const T minus_omega_dot_omega1_12_11 = thetadot12 * omega_omega1_12_31 + minus_E12_13 * t11_2 + E12_11 *
      minus_omega_dot_omega1_11_11;
  const T omega_dot_omega1_12_12 = minus_E12_13 * minus_omega_dot_omega1_11_32 + E12_11 * omega_dot_omega1_11_12 -
      thetadot12 * omega_omega1_12_32;
  const T omega_dot_omega1_12_13 = minus_E12_13 * minus_omega_dot_omega1_11_33 - E12_11 * minus_omega_dot_omega1_11_13
      - thetadot12 * omega_omega1_12_33;
  const T omega_dot_omega1_12_31 = E12_11 * t11_2 - minus_E12_13 * minus_omega_dot_omega1_11_11 + thetadot12 *
      omega_omega1_12_11;
  const T omega_dot_omega1_12_32 = minus_E12_13 * omega_dot_omega1_11_12 - E12_11 * minus_omega_dot_omega1_11_32 +
      thetadot12 * omega_omega1_12_12;
  const T minus_omega_dot_omega1_12_33 = thetadot12 * minus_omega_omega1_12_13 + minus_E12_13 *
      minus_omega_dot_omega1_11_13 + E12_11 * minus_omega_dot_omega1_11_33;
  // P_dot_omega1_12 = R11^T (-omega11~ q12~ omega_omega1_11 - q12~ omega_dot_omega1_11) + P_dot_omega1_11: its rate
  const T t12_1 = T(0.2) * E11_11;
  const T t12_2 = omega11_3 * t12_1;
  const T t12_3 = T(0.2) * minus_omega_dot_omega1_11_11;
  const T t12_4 = omega11_1 * t12_1;
  const T t12_5 = R11_11 * t12_2 + R10_21 * t12_3 - R11_31 * t12_4;
  const T P_dot_omega1_12_11 = P_dot_omega1_11_11 - t12_5;
  const T t12_6 = T(0.2) * omega_omega1_11_12;
  const T t12_7 = T(0.2) * minus_omega_dot_omega1_11_22;
  const T t12_8 = omega11_3 * t12_6 - t12_7;
  const T t12_9 = T(0.2) * E10_22;
  const T t12_10 = omega11_3 * t12_9 - T(0.2) * omega_dot_omega1_11_12;
  const T t12_11 = omega11_1 * t12_6 + omega11_2 * t12_9;
  const T P_dot_omega1_12_12 = P_dot_omega1_11_12 - R11_11 * t12_8 - R10_21 * t12_10 + R11_31 * t12_11;
  const T t12_12 = T(0.2) * omega_dot_omega1_11_23;
  const T t12_13 = T(0.2) * minus_omega_omega1_11_13;
  const T t12_14 = t12_12 - omega11_3 * t12_13;
  const T t12_15 = T(0.2) * E10_23;
  const T t12_16 = omega11_3 * t12_15 + T(0.2) * minus_omega_dot_omega1_11_13;
  const T t12_17 = omega11_1 * t12_13 - omega11_2 * t12_15;
  const T P_dot_omega1_12_13 = P_dot_omega1_11_13 - R11_11 * t12_14 - R10_21 * t12_16 - R11_31 * t12_17;
  const T t12_18 = R11_12 * t12_2 + R10_22 * t12_3 - R11_32 * t12_4;
  const T P_dot_omega1_12_21 = P_dot_omega1_11_21 - t12_18;
  const T P_dot_omega1_12_22 = P_dot_omega1_11_22 - R11_12 * t12_8 - R10_22 * t12_10 + R11_32 * t12_11;
  const T P_dot_omega1_12_23 = P_dot_omega1_11_23 - R11_12 * t12_14 - R10_22 * t12_16 - R11_32 * t12_17;
  const T t12_19 = R11_13 * t12_2 + R10_23 * t12_3 - R11_33 * t12_4;
  const T P_dot_omega1_12_31 = P_dot_omega1_11_31 - t12_19;
  const T P_dot_omega1_12_32 = P_dot_omega1_11_32 - R11_13 * t12_8 - R10_23 * t12_10 + R11_33 * t12_11;
  const T P_dot_omega1_12_33 = P_dot_omega1_11_33 - R11_13 * t12_14 - R10_23 * t12_16 - R11_33 * t12_17;
  // P_dot_thetadot10_12 = R11^T (-omega11~ q12~ omega_thetadot10_11 - q12~ omega_dot_thetadot10_11) +
  //   P_dot_thetadot10_11: its rate
  const T minus_P_dot_thetadot10_12_1 = t12_5 - t11_6;
  const T minus_P_dot_thetadot10_12_2 = t12_18 - t11_15;
  const T minus_P_dot_thetadot10_12_3 = t12_19 - t11_16;
  // P_dot_thetadot11_12 = -R11^T omega11~ q12~ b11: its rate
  const T t12_20 = omega11_3 * T(0.2);
  const T t12_21 = omega11_2 * T(0.2);
  const T minus_P_dot_thetadot11_12_1 = R10_21 * t12_20 - R11_31 * t12_21;
  const T minus_P_dot_thetadot11_12_2 = R10_22 * t12_20 - R11_32 * t12_21;
  const T minus_P_dot_thetadot11_12_3 = R10_23 * t12_20 - R11_33 * t12_21;
  // B33_1 = -R12^T omega12~ r12~ omega_omega1_12 - R12^T r12~ omega_dot_omega1_12 + P_dot_omega1_12
  const T t12_22 = T(0.107388) * omega_omega1_12_11 + T(0.006435) * omega_omega1_12_31;
  const T t12_23 = omega12_3 * t12_22;
  const T t12_24 = omega12_1 * t12_22;
  const T t12_25 = T(0.107388) * minus_omega_dot_omega1_12_11 - T(0.006435) * omega_dot_omega1_12_31;
  const T t12_26 = R12_11 * t12_23 - R12_31 * t12_24 + R10_21 * t12_25;
  const T B33_1_11 = P_dot_omega1_12_11 - t12_26;
  const T t12_27 = T(0.107388) * omega_omega1_12_12 + T(0.006435) * omega_omega1_12_32;
  const T t12_28 = T(0.006435) * E10_22;
  const T t12_29 = omega12_3 * t12_27 + omega12_2 * t12_28;
  const T t12_30 = T(0.107388) * E10_22;
  const T t12_31 = omega12_3 * t12_30 - omega12_1 * t12_28;
  const T t12_32 = omega12_1 * t12_27 + omega12_2 * t12_30;
  const T t12_33 = T(0.107388) * minus_omega_dot_omega1_11_22;
  const T t12_34 = T(0.107388) * omega_dot_omega1_12_12 + T(0.006435) * omega_dot_omega1_12_32;
  const T t12_35 = T(0.006435) * minus_omega_dot_omega1_11_22;
  const T B33_1_12 = P_dot_omega1_12_12 - R12_11 * t12_29 - R10_21 * t12_31 + R12_31 * t12_32 + R12_11 * t12_33 +
      R10_21 * t12_34 + R12_31 * t12_35;
  const T t12_36 = T(0.006435) * E10_23;
  const T t12_37 = T(0.107388) * minus_omega_omega1_12_13 - T(0.006435) * omega_omega1_12_33;
  const T t12_38 = omega12_2 * t12_36 - omega12_3 * t12_37;
  const T t12_39 = T(0.107388) * E10_23;
  const T t12_40 = omega12_3 * t12_39 - omega12_1 * t12_36;
  const T t12_41 = omega12_1 * t12_37 - omega12_2 * t12_39;
  const T t12_42 = T(0.107388) * omega_dot_omega1_11_23;
  const T t12_43 = T(0.006435) * minus_omega_dot_omega1_12_33 - T(0.107388) * omega_dot_omega1_12_13;
  const T t12_44 = T(0.006435) * omega_dot_omega1_11_23;
  const T B33_1_13 = P_dot_omega1_12_13 - R12_11 * t12_38 - R10_21 * t12_40 - R12_31 * t12_41 - R12_11 * t12_42 -
      R10_21 * t12_43 - R12_31 * t12_44;
  const T t12_45 = R12_12 * t12_23 - R12_32 * t12_24 + R10_22 * t12_25;
  const T B33_1_21 = P_dot_omega1_12_21 - t12_45;
  const T B33_1_22 = P_dot_omega1_12_22 - R12_12 * t12_29 - R10_22 * t12_31 + R12_32 * t12_32 + R12_12 * t12_33 +
      R10_22 * t12_34 + R12_32 * t12_35;
  const T B33_1_23 = P_dot_omega1_12_23 - R12_12 * t12_38 - R10_22 * t12_40 - R12_32 * t12_41 - R12_12 * t12_42 -
      R10_22 * t12_43 - R12_32 * t12_44;
  const T t12_46 = R12_13 * t12_23 - R12_33 * t12_24 + R10_23 * t12_25;
  const T B33_1_31 = P_dot_omega1_12_31 - t12_46;
  const T B33_1_32 = P_dot_omega1_12_32 - R12_13 * t12_29 - R10_23 * t12_31 + R12_33 * t12_32 + R12_13 * t12_33 +
      R10_23 * t12_34 + R12_33 * t12_35;
  const T B33_1_33 = P_dot_omega1_12_33 - R12_13 * t12_38 - R10_23 * t12_40 - R12_33 * t12_41 - R12_13 * t12_42 -
      R10_23 * t12_43 - R12_33 * t12_44;
  v_y_dot[594] = B33_1_11;
  v_y_dot[595] = B33_1_12;
  v_y_dot[596] = B33_1_13;
  v_y_dot[612] = B33_1_21;
  v_y_dot[613] = B33_1_22;
  v_y_dot[614] = B33_1_23;
  v_y_dot[630] = B33_1_31;
  v_y_dot[631] = B33_1_32;
  v_y_dot[632] = B33_1_33;
  // B34_10 = -R12^T omega12~ r12~ omega_thetadot10_12 - R12^T r12~ omega_dot_thetadot10_12 + P_dot_thetadot10_12
  const T minus_B34_10_1 = t12_26 + minus_P_dot_thetadot10_12_1;
  const T minus_B34_10_2 = t12_45 + minus_P_dot_thetadot10_12_2;
  const T minus_B34_10_3 = t12_46 + minus_P_dot_thetadot10_12_3;
  v_y_dot[603] = -minus_B34_10_1;
  v_y_dot[621] = -minus_B34_10_2;
  v_y_dot[639] = -minus_B34_10_3;
  // B35_11 = -R12^T omega12~ r12~ omega_thetadot11_12 - R12^T r12~ omega_dot_thetadot11_12 + P_dot_thetadot11_12
  const T t12_47 = omega12_2 * T(0.006435);
  const T t12_48 = omega12_3 * T(0.107388) - omega12_1 * T(0.006435);
  const T t12_49 = omega12_2 * T(0.107388);
  const T t12_50 = R12_11 * t12_47 + R10_21 * t12_48 - R12_31 * t12_49;
  const T minus_B35_11_1 = t12_50 + minus_P_dot_thetadot11_12_1;
  const T t12_51 = R12_12 * t12_47 + R10_22 * t12_48 - R12_32 * t12_49;
  const T minus_B35_11_2 = t12_51 + minus_P_dot_thetadot11_12_2;
  const T t12_52 = R12_13 * t12_47 + R10_23 * t12_48 - R12_33 * t12_49;
  const T minus_B35_11_3 = t12_52 + minus_P_dot_thetadot11_12_3;
  v_y_dot[604] = -minus_B35_11_1;
  v_y_dot[622] = -minus_B35_11_2;
  v_y_dot[640] = -minus_B35_11_3;
  v_y_dot[605] = -t12_50;
  v_y_dot[623] = -t12_51;
  v_y_dot[641] = -t12_52;
  // B37_1 = -R12^T omega12~ o13~ omega_omega1_12 - R12^T o13~ omega_dot_omega1_12 + P_dot_omega1_12
  const T t12_53 = T(0.2) * omega_omega1_12_11;
  const T t12_54 = omega12_3 * t12_53;
  const T t12_55 = omega12_1 * t12_53;
  const T t12_56 = T(0.2) * minus_omega_dot_omega1_12_11;
  const T t12_57 = R12_11 * t12_54 - R12_31 * t12_55 + R10_21 * t12_56;
  const T B37_1_11 = P_dot_omega1_12_11 - t12_57;
  const T t12_58 = T(0.2) * omega_omega1_12_12;
  const T t12_59 = omega12_3 * t12_58;
  const T t12_60 = omega12_3 * t12_9;
  const T t12_61 = omega12_1 * t12_58 + omega12_2 * t12_9;
  const T t12_62 = T(0.2) * omega_dot_omega1_12_12;
  const T B37_1_12 = P_dot_omega1_12_12 - R12_11 * t12_59 - R10_21 * t12_60 + R12_31 * t12_61 + R12_11 * t12_7 +
      R10_21 * t12_62;
  const T t12_63 = T(0.2) * minus_omega_omega1_12_13;
  const T t12_64 = omega12_3 * t12_63;
  const T t12_65 = omega12_3 * t12_15;
  const T t12_66 = omega12_1 * t12_63 - omega12_2 * t12_15;
  const T t12_67 = T(0.2) * omega_dot_omega1_12_13;
  const T B37_1_13 = P_dot_omega1_12_13 + R12_11 * t12_64 - R10_21 * t12_65 - R12_31 * t12_66 - R12_11 * t12_12 +
      R10_21 * t12_67;
  const T t12_68 = R12_12 * t12_54 - R12_32 * t12_55 + R10_22 * t12_56;
  const T B37_1_21 = P_dot_omega1_12_21 - t12_68;
  const T B37_1_22 = P_dot_omega1_12_22 - R12_12 * t12_59 - R10_22 * t12_60 + R12_32 * t12_61 + R12_12 * t12_7 +
      R10_22 * t12_62;
  const T B37_1_23 = P_dot_omega1_12_23 + R12_12 * t12_64 - R10_22 * t12_65 - R12_32 * t12_66 - R12_12 * t12_12 +
      R10_22 * t12_67;
  const T t12_69 = R12_13 * t12_54 - R12_33 * t12_55 + R10_23 * t12_56;
  const T B37_1_31 = P_dot_omega1_12_31 - t12_69;
  const T B37_1_32 = P_dot_omega1_12_32 - R12_13 * t12_59 - R10_23 * t12_60 + R12_33 * t12_61 + R12_13 * t12_7 +
      R10_23 * t12_62;
  const T B37_1_33 = P_dot_omega1_12_33 + R12_13 * t12_64 - R10_23 * t12_65 - R12_33 * t12_66 - R12_13 * t12_12 +
      R10_23 * t12_67;
  v_y_dot[648] = B37_1_11;
  v_y_dot[649] = B37_1_12;
  v_y_dot[650] = B37_1_13;
  v_y_dot[666] = B37_1_21;
  v_y_dot[667] = B37_1_22;
  v_y_dot[668] = B37_1_23;
  v_y_dot[684] = B37_1_31;
  v_y_dot[685] = B37_1_32;
  v_y_dot[686] = B37_1_33;
  // B38_10 = -R12^T omega12~ o13~ omega_thetadot10_12 - R12^T o13~ omega_dot_thetadot10_12 + P_dot_thetadot10_12
  const T minus_B38_10_1 = t12_57 + minus_P_dot_thetadot10_12_1;
  const T minus_B38_10_2 = t12_68 + minus_P_dot_thetadot10_12_2;
  const T minus_B38_10_3 = t12_69 + minus_P_dot_thetadot10_12_3;
  v_y_dot[657] = -minus_B38_10_1;
  v_y_dot[675] = -minus_B38_10_2;
  v_y_dot[693] = -minus_B38_10_3;
  // B39_11 = -R12^T omega12~ o13~ omega_thetadot11_12 - R12^T o13~ omega_dot_thetadot11_12 + P_dot_thetadot11_12
  const T t12_70 = omega12_3 * T(0.2);
  const T t12_71 = omega12_2 * T(0.2);
  const T t12_72 = R10_21 * t12_70 - R12_31 * t12_71;
  const T minus_B39_11_1 = t12_72 + minus_P_dot_thetadot11_12_1;
  const T t12_73 = R10_22 * t12_70 - R12_32 * t12_71;
  const T minus_B39_11_2 = t12_73 + minus_P_dot_thetadot11_12_2;
  const T t12_74 = R10_23 * t12_70 - R12_33 * t12_71;
  const T minus_B39_11_3 = t12_74 + minus_P_dot_thetadot11_12_3;
  v_y_dot[658] = -minus_B39_11_1;
  v_y_dot[676] = -minus_B39_11_2;
  v_y_dot[694] = -minus_B39_11_3;
  v_y_dot[659] = -t12_72;
  v_y_dot[677] = -t12_73;
  v_y_dot[695] = -t12_74;

  // ---- body 14 (rl_hip) on body 1
  const T thetadot14 = y[12];
  // E14^T = Rot(b14, theta14): E takes components in the lower body to those in the body
  const T E14_22 = cosines[13];
  const T E14_23 = sines[13];
  // R14^T = R1^T E14^T: R takes inertial components to body components
  const T R14_21 = R1_21 * E14_22 + R1_31 * E14_23;
  const T R14_22 = R1_22 * E14_22 + R1_32 * E14_23;
  const T R14_23 = R1_23 * E14_22 + R1_33 * E14_23;
  const T R14_31 = R1_31 * E14_22 - R1_21 * E14_23;
  const T R14_32 = R1_32 * E14_22 - R1_22 * E14_23;
  const T R14_33 = R1_33 * E14_22 - R1_23 * E14_23;
  // omega14 = thetadot14 b14 + E14 omega1: absolute angular velocity, body axes [rad/s]
  const T omega14_1 = thetadot14 + omega1_1;
  const T omega14_2 = E14_22 * omega1_2 + E14_23 * omega1_3;
  const T omega14_3 = E14_22 * omega1_3 - E14_23 * omega1_2;
  // B41_1 = thetadot14 R14^T r14~ b14~ E14 - R14^T omega14~ r14~ E14 + P_dot_omega1_14
  const T t14_1 = omega14_1 * T(0.000635);
  const T t14_2 = omega14_3 * T(3.1e-05) + omega14_2 * T(0.000635);
  const T t14_3 = omega14_1 * T(3.1e-05);
  const T t14_4 = R14_21 * t14_1 - R1_11 * t14_2 + R14_31 * t14_3;
  const T B41_1_11 = minus_P_dot_omega1_2_11 - t14_4;
  const T t14_5 = T(0.003311) * E14_22;
  const T t14_6 = omega14_1 * t14_5;
  const T t14_7 = T(3.1e-05) * E14_22 + T(0.000635) * E14_23;
  const T t14_8 = t14_6 + omega14_3 * t14_7;
  const T t14_9 = T(0.003311) * E14_23;
  const T t14_10 = omega14_2 * t14_5 - omega14_3 * t14_9;
  const T t14_11 = omega14_1 * t14_9;
  const T t14_12 = t14_11 + omega14_2 * t14_7;
  const T t14_13 = T(0.000635) * E14_22 - T(3.1e-05) * E14_23;
  const T B41_1_12 = minus_P_dot_omega1_2_12 + R14_21 * t14_8 - R1_11 * t14_10 - R14_31 * t14_12 + thetadot14 * (R1_11
      * t14_13 - R14_21 * t14_5 + R14_31 * t14_9);
  const T t14_14 = omega14_3 * t14_5 + omega14_2 * t14_9;
  const T t14_15 = omega14_3 * t14_13 - t14_11;
  const T t14_16 = t14_6 + omega14_2 * t14_13;
  const T minus_B41_1_13 = P_dot_omega1_2_13 + thetadot14 * (R14_21 * t14_9 - R1_11 * t14_7 + R14_31 * t14_5) + R1_11
      * t14_14 + R14_21 * t14_15 - R14_31 * t14_16;
  const T t14_17 = R14_22 * t14_1 - R1_12 * t14_2 + R14_32 * t14_3;
  const T B41_1_21 = minus_P_dot_omega1_2_21 - t14_17;
  const T B41_1_22 = minus_P_dot_omega1_2_22 + R14_22 * t14_8 - R1_12 * t14_10 - R14_32 * t14_12 + thetadot14 * (R1_12
      * t14_13 - R14_22 * t14_5 + R14_32 * t14_9);
  const T minus_B41_1_23 = P_dot_omega1_2_23 + thetadot14 * (R14_22 * t14_9 - R1_12 * t14_7 + R14_32 * t14_5) + R1_12
      * t14_14 + R14_22 * t14_15 - R14_32 * t14_16;
  const T t14_18 = R14_23 * t14_1 - R1_13 * t14_2 + R14_33 * t14_3;
  const T B41_1_31 = minus_P_dot_omega1_2_31 - t14_18;
  const T B41_1_32 = minus_P_dot_omega1_2_32 + R14_23 * t14_8 - R1_13 * t14_10 - R14_33 * t14_12 + thetadot14 * (R1_13
      * t14_13 - R14_23 * t14_5 + R14_33 * t14_9);
  const T minus_B41_1_33 = P_dot_omega1_2_33 + thetadot14 * (R14_23 * t14_9 - R1_13 * t14_7 + R14_33 * t14_5) + R1_13
      * t14_14 + R14_23 * t14_15 - R14_33 * t14_16;
  v_y_dot[702] = B41_1_11;
  v_y_dot[703] = B41_1_12;
  v_y_dot[704] = -minus_B41_1_13;
  v_y_dot[720] = B41_1_21;
  v_y_dot[721] = B41_1_22;
  v_y_dot[722] = -minus_B41_1_23;
  v_y_dot[738] = B41_1_31;
  v_y_dot[739] = B41_1_32;
  v_y_dot[740] = -minus_B41_1_33;
  v_y_dot[714] = -t14_4;
  v_y_dot[732] = -t14_17;
  v_y_dot[750] = -t14_18;

  // ---- body 15 (rl_thigh) on body 14
  const T thetadot15 = y[13];
  // E15^T = Rot(b15, theta15): E takes components in the lower body to those in the body
  const T E15_11 = cosines[14];
  const T minus_E15_13 = sines[14];
  // R15^T = R14^T E15^T: R takes inertial components to body components
  const T R15_11 = R1_11 * E15_11 - R14_31 * minus_E15_13;
  const T R15_12 = R1_12 * E15_11 - R14_32 * minus_E15_13;
  const T R15_13 = R1_13 * E15_11 - R14_33 * minus_E15_13;
  const T R15_31 = R1_11 * minus_E15_13 + R14_31 * E15_11;
  const T R15_32 = R1_12 * minus_E15_13 + R14_32 * E15_11;
  const T R15_33 = R1_13 * minus_E15_13 + R14_33 * E15_11;
  // omega15 = thetadot15 b15 + E15 omega14: absolute angular velocity, body axes [rad/s]
  const T omega15_1 = E15_11 * omega14_1 - minus_E15_13 * omega14_3;
  const T omega15_2 = thetadot15 + omega14_2;
  const T omega15_3 = minus_E15_13 * omega14_1 + E15_11 * omega14_3;
  // omega_omega1_15 = E15 E14: partial angular velocity, body axes
  const T omega_omega1_15_12 = minus_E15_13 * E14_23;
  const T minus_omega_omega1_15_13 = minus_E15_13 * E14_22;
  const T minus_omega_omega1_15_32 = E15_11 * E14_23;
  const T omega_omega1_15_33 = E15_11 * E14_22;
  // omega_dot_omega1_15 = -(thetadot14 E15 b14~ + thetadot15 b15~ E15) E14: its rate
  const T minus_omega_dot_omega1_15_11 = thetadot15 * minus_E15_13;
  const T t15_1 = thetadot14 * minus_E15_13;
  const T t15_2 = thetadot15 * E15_11;
  const T omega_dot_omega1_15_12 = t15_1 * E14_22 + t15_2 * E14_23;
  const T minus_omega_dot_omega1_15_13 = t15_2 * E14_22 - t15_1 * E14_23;
  const T minus_omega_dot_omega1_15_22 = thetadot14 * E14_23;
  const T omega_dot_omega1_15_23 = thetadot14 * E14_22;
  const T t15_3 = thetadot14 * E15_11;
  const T minus_omega_dot_omega1_15_32 = t15_3 * E14_22 - minus_omega_dot_omega1_15_11 * E14_23;
  const T minus_omega_dot_omega1_15_33 = t15_3 * E14_23 + minus_omega_dot_omega1_15_11 * E14_22;
  // P_dot_omega1_15 = R14^T (thetadot14 q15~ b14~ - omega14~ q15~) E14 + P_dot_omega1_14: its rate
  const T t15_4 = omega14_2 * T(0.0838);
  const T t15_5 = omega14_1 * T(0.0838);
  const T t15_6 = R1_11 * t15_4 - R14_21 * t15_5;
  const T P_dot_omega1_15_11 = t15_6 + minus_P_dot_omega1_2_11;
  const T t15_7 = thetadot14 * T(0.0838);
  const T t15_8 = t15_7 * E14_22;
  const T t15_9 = omega14_3 * T(0.0838);
  const T t15_10 = t15_9 * E14_23;
  const T t15_11 = t15_4 * E14_23;
  const T P_dot_omega1_15_12 = minus_P_dot_omega1_2_12 + R1_11 * t15_8 + R14_21 * t15_10 - R14_31 * t15_11;
  const T t15_12 = t15_7 * E14_23;
  const T t15_13 = t15_9 * E14_22;
  const T t15_14 = t15_4 * E14_22;
  const T P_dot_omega1_15_13 = R1_11 * t15_12 - P_dot_omega1_2_13 - R14_21 * t15_13 + R14_31 * t15_14;
  const T t15_15 = R1_12 * t15_4 - R14_22 * t15_5;
  const T P_dot_omega1_15_21 = t15_15 + minus_P_dot_omega1_2_21;
  const T P_dot_omega1_15_22 = minus_P_dot_omega1_2_22 + R1_12 * t15_8 + R14_22 * t15_10 - R14_32 * t15_11;
  const T P_dot_omega1_15_23 = R1_12 * t15_12 - P_dot_omega1_2_23 - R14_22 * t15_13 + R14_32 * t15_14;
  const T t15_16 = R1_13 * t15_4 - R14_23 * t15_5;
  const T P_dot_omega1_15_31 = t15_16 + minus_P_dot_omega1_2_31;
  const T P_dot_omega1_15_32 = minus_P_dot_omega1_2_32 + R1_13 * t15_8 + R14_23 * t15_10 - R14_33 * t15_11;
  const T P_dot_omega1_15_33 = R1_13 * t15_12 - P_dot_omega1_2_33 - R14_23 * t15_13 + R14_33 * t15_14;
  // B43_1 = -R15^T omega15~ r15~ omega_omega1_15 - R15^T r15~ omega_dot_omega1_15 + P_dot_omega1_15
  const T t15_17 = T(0.022327) * E15_11;
  const T t15_18 = T(0.003237) * minus_E15_13 - T(0.027326) * E15_11;
  const T t15_19 = omega15_2 * t15_17 - omega15_3 * t15_18;
  const T t15_20 = T(0.022327) * minus_E15_13;
  const T t15_21 = omega15_3 * t15_20 + omega15_1 * t15_17;
  const T t15_22 = omega15_1 * t15_18 + omega15_2 * t15_20;
  const T t15_23 = T(0.003237) * t15_2 + T(0.027326) * minus_omega_dot_omega1_15_11;
  const T t15_24 = T(0.022327) * t15_2;
  const T t15_25 = T(0.022327) * minus_omega_dot_omega1_15_11;
  const T t15_26 = R15_11 * t15_19 - R14_21 * t15_21 + R15_31 * t15_22 + R14_21 * t15_23 - R15_11 * t15_24 - R15_31 *
      t15_25;
  const T B43_1_11 = P_dot_omega1_15_11 - t15_26;
  const T t15_27 = T(0.027326) * omega_omega1_15_12 + T(0.003237) * minus_omega_omega1_15_32;
  const T t15_28 = T(0.022327) * omega_omega1_15_12 - T(0.003237) * E14_22;
  const T t15_29 = omega15_3 * t15_27 + omega15_2 * t15_28;
  const T t15_30 = T(0.027326) * E14_22 + T(0.022327) * minus_omega_omega1_15_32;
  const T t15_31 = omega15_3 * t15_30 - omega15_1 * t15_28;
  const T t15_32 = omega15_1 * t15_27 + omega15_2 * t15_30;
  const T t15_33 = T(0.022327) * minus_omega_dot_omega1_15_32 - T(0.027326) * minus_omega_dot_omega1_15_22;
  const T t15_34 = T(0.003237) * minus_omega_dot_omega1_15_32 + T(0.027326) * omega_dot_omega1_15_12;
  const T t15_35 = T(0.022327) * omega_dot_omega1_15_12 + T(0.003237) * minus_omega_dot_omega1_15_22;
  const T B43_1_12 = P_dot_omega1_15_12 - R15_11 * t15_29 - R14_21 * t15_31 + R15_31 * t15_32 - R15_11 * t15_33 +
      R14_21 * t15_34 - R15_31 * t15_35;
  const T t15_36 = T(0.027326) * minus_omega_omega1_15_13 + T(0.003237) * omega_omega1_15_33;
  const T t15_37 = T(0.003237) * E14_23 + T(0.022327) * minus_omega_omega1_15_13;
  const T t15_38 = omega15_3 * t15_36 + omega15_2 * t15_37;
  const T t15_39 = T(0.027326) * E14_23 - T(0.022327) * omega_omega1_15_33;
  const T t15_40 = omega15_3 * t15_39 + omega15_1 * t15_37;
  const T t15_41 = omega15_1 * t15_36 - omega15_2 * t15_39;
  const T t15_42 = T(0.027326) * omega_dot_omega1_15_23 + T(0.022327) * minus_omega_dot_omega1_15_33;
  const T t15_43 = T(0.027326) * minus_omega_dot_omega1_15_13 - T(0.003237) * minus_omega_dot_omega1_15_33;
  const T t15_44 = T(0.022327) * minus_omega_dot_omega1_15_13 + T(0.003237) * omega_dot_omega1_15_23;
  const T B43_1_13 = P_dot_omega1_15_13 + R15_11 * t15_38 - R14_21 * t15_40 - R15_31 * t15_41 - R15_11 * t15_42 -
      R14_21 * t15_43 + R15_31 * t15_44;
  const T t15_45 = R15_12 * t15_19 - R14_22 * t15_21 + R15_32 * t15_22 + R14_22 * t15_23 - R15_12 * t15_24 - R15_32 *
      t15_25;
  const T B43_1_21 = P_dot_omega1_15_21 - t15_45;
  const T B43_1_22 = P_dot_omega1_15_22 - R15_12 * t15_29 - R14_22 * t15_31 + R15_32 * t15_32 - R15_12 * t15_33 +
      R14_22 * t15_34 - R15_32 * t15_35;
  const T B43_1_23 = P_dot_omega1_15_23 + R15_12 * t15_38 - R14_22 * t15_40 - R15_32 * t15_41 - R15_12 * t15_42 -
      R14_22 * t15_43 + R15_32 * t15_44;
  const T t15_46 = R15_13 * t15_19 - R14_23 * t15_21 + R15_33 * t15_22 + R14_23 * t15_23 - R15_13 * t15_24 - R15_33 *
      t15_25;
  const T B43_1_31 = P_dot_omega1_15_31 - t15_46;
  const T B43_1_32 = P_dot_omega1_15_32 - R15_13 * t15_29 - R14_23 * t15_31 + R15_33 * t15_32 - R15_13 * t15_33 +
      R14_23 * t15_34 - R15_33 * t15_35;
  const T B43_1_33 = P_dot_omega1_15_33 + R15_13 * t15_38 - R14_23 * t15_40 - R15_33 * t15_41 - R15_13 * t15_42 -
      R14_23 * t15_43 + R15_33 * t15_44;
  v_y_dot[756] = B43_1_11;
  v_y_dot[757] = B43_1_12;
  v_y_dot[758] = B43_1_13;
  v_y_dot[774] = B43_1_21;
  v_y_dot[775] = B43_1_22;
  v_y_dot[776] = B43_1_23;
  v_y_dot[792] = B43_1_31;
  v_y_dot[793] = B43_1_32;
  v_y_dot[794] = B43_1_33;
  // B44_14 = -R15^T omega15~ r15~ omega_thetadot14_15 - R15^T r15~ omega_dot_thetadot14_15 + P_dot_thetadot14_15
  const T minus_B44_14_1 = t15_26 - t15_6;
  const T minus_B44_14_2 = t15_45 - t15_15;
  const T minus_B44_14_3 = t15_46 - t15_16;
  v_y_dot[768] = -minus_B44_14_1;
  v_y_dot[786] = -minus_B44_14_2;
  v_y_dot[804] = -minus_B44_14_3;
  // B45_15 = -R15^T omega15~ r15~ b15
  const T t15_47 = omega15_3 * T(0.027326) + omega15_1 * T(0.003237);
  const T t15_48 = omega15_2 * T(0.003237);
  const T t15_49 = omega15_2 * T(0.027326);
  const T minus_B45_15_1 = R14_21 * t15_47 - R15_11 * t15_48 - R15_31 * t15_49;
  const T minus_B45_15_2 = R14_22 * t15_47 - R15_12 * t15_48 - R15_32 * t15_49;
  const T minus_B45_15_3 = R14_23 * t15_47 - R15_13 * t15_48 - R15_33 * t15_49;
  v_y_dot[769] = -minus_B45_15_1;
  v_y_dot[787] = -minus_B45_15_2;
  v_y_dot[805] = -minus_B45_15_3;

  // ---- body 16 (rl_calf) on body 15
  const T thetadot16 = y[14];
  // E16^T = Rot(b16, theta16): E takes components in the lower body to those in the body
  const T E16_11 = cosines[15];
  const T minus_E16_13 = sines[15];
  // R16^T = R15^T E16^T: R takes inertial components to body components
  const T R16_11 = R15_11 * E16_11 - R15_31 * minus_E16_13;
  const T R16_12 = R15_12 * E16_11 - R15_32 * minus_E16_13;
  const T R16_13 = R15_13 * E16_11 - R15_33 * minus_E16_13;
  const T R16_31 = R15_11 * minus_E16_13 + R15_31 * E16_11;
  const T R16_32 = R15_12 * minus_E16_13 + R15_32 * E16_11;
  const T R16_33 = R15_13 * minus_E16_13 + R15_33 * E16_11;
  // omega16 = thetadot16 b16 + E16 omega15: absolute angular velocity, body axes [rad/s]
  const T omega16_1 = E16_11 * omega15_1 - minus_E16_13 * omega15_3;
  const T omega16_2 = thetadot16 + omega15_2;
  const T omega16_3 = minus_E16_13 * omega15_1 + E16_11 * omega15_3;
  // omega_omega1_16 = E16 omega_omega1_15: partial angular velocity, body axes
  const T omega_omega1_16_11 = E16_11 * E15_11 - minus_E16_13 * minus_E15_13;
  const T omega_omega1_16_12 = E16_11 * omega_omega1_15_12 + minus_E16_13 * minus_omega_omega1_15_32;
  const T minus_omega_omega1_16_13 = E16_11 * minus_omega_omega1_15_13 + minus_E16_13 * omega_omega1_15_33;
  const T omega_omega1_16_31 = minus_E16_13 * E15_11 + E16_11 * minus_E15_13;
  const T omega_omega1_16_32 = minus_E16_13 * omega_omega1_15_12 - E16_11 * minus_omega_omega1_15_32;
  const T omega_omega1_16_33 = E16_11 * omega_omega1_15_33 - minus_E16_13 * minus_omega_omega1_15_13;
  // omega_dot_omega1_16 = -thetadot16 b16~ E16 omega_omega1_15 + E16 omega_dot_omega1_15: its rate
  const T minus_omega_dot_omega1_16_11 = thetadot16 * omega_omega1_16_31 + minus_E16_13 * t15_2 + E16_11 *
      minus_omega_dot_omega1_15_11;
  const T omega_dot_omega1_16_12 = minus_E16_13 * minus_omega_dot_omega1_15_32 + E16_11 * omega_dot_omega1_15_12 -
      thetadot16 * omega_omega1_16_32;
  const T omega_dot_omega1_16_13 = minus_E16_13 * minus_omega_dot_omega1_15_33 - E16_11 * minus_omega_dot_omega1_15_13
      - thetadot16 * omega_omega1_16_33;
  const T omega_dot_omega1_16_31 = E16_11 * t15_2 - minus_E16_13 * minus_omega_dot_omega1_15_11 + thetadot16 *
      omega_omega1_16_11;
  const T omega_dot_omega1_16_32 = minus_E16_13 * omega_dot_omega1_15_12 - E16_11 * minus_omega_dot_omega1_15_32 +
      thetadot16 * omega_omega1_16_12;
  const T minus_omega_dot_omega1_16_33 = thetadot16 * minus_omega_omega1_16_13 + minus_E16_13 *
      minus_omega_dot_omega1_15_13 + E16_11 * minus_omega_dot_omega1_15_33;
  // P_dot_omega1_16 = R15^T (-omega15~ q16~ omega_omega1_15 - q16~ omega_dot_omega1_15) + P_dot_omega1_15: its rate
  const T t16_1 = T(0.2) * E15_11;
  const T t16_2 = omega15_3 * t16_1;
  const T t16_3 = T(0.2) * minus_omega_dot_omega1_15_11;
  const T t16_4 = omega15_1 * t16_1;
  const T t16_5 = R15_11 * t16_2 + R14_21 * t16_3 - R15_31 * t16_4;
  const T P_dot_omega1_16_11 = P_dot_omega1_15_11 - t16_5;
  const T t16_6 = T(0.2) * omega_omega1_15_12;
  const T t16_7 = T(0.2) * minus_omega_dot_omega1_15_22;
  const T t16_8 = omega15_3 * t16_6 - t16_7;
  const T t16_9 = T(0.2) * E14_22;
  const T t16_10 = omega15_3 * t16_9 - T(0.2) * omega_dot_omega1_15_12;
  const T t16_11 = omega15_1 * t16_6 + omega15_2 * t16_9;
  const T P_dot_omega1_16_12 = P_dot_omega1_15_12 - R15_11 * t16_8 - R14_21 * t16_10 + R15_31 * t16_11;
  const T t16_12 = T(0.2) * omega_dot_omega1_15_23;
  const T t16_13 = T(0.2) * minus_omega_omega1_15_13;
  const T t16_14 = t16_12 - omega15_3 * t16_13;
  const T t16_15 = T(0.2) * E14_23;
  const T t16_16 = omega15_3 * t16_15 + T(0.2) * minus_omega_dot_omega1_15_13;
  const T t16_17 = omega15_1 * t16_13 - omega15_2 * t16_15;
  const T P_dot_omega1_16_13 = P_dot_omega1_15_13 - R15_11 * t16_14 - R14_21 * t16_16 - R15_31 * t16_17;
  const T t16_18 = R15_12 * t16_2 + R14_22 * t16_3 - R15_32 * t16_4;
  const T P_dot_omega1_16_21 = P_dot_omega1_15_21 - t16_18;
  const T P_dot_omega1_16_22 = P_dot_omega1_15_22 - R15_12 * t16_8 - R14_22 * t16_10 + R15_32 * t16_11;
  const T P_dot_omega1_16_23 = P_dot_omega1_15_23 - R15_12 * t16_14 - R14_22 * t16_16 - R15_32 * t16_17;
  const T t16_19 = R15_13 * t16_2 + R14_23 * t16_3 - R15_33 * t16_4;
  const T P_dot_omega1_16_31 = P_dot_omega1_15_31 - t16_19;
  const T P_dot_omega1_16_32 = P_dot_omega1_15_32 - R15_13 * t16_8 - R14_23 * t16_10 + R15_33 * t16_11;
  const T P_dot_omega1_16_33 = P_dot_omega1_15_33 - R15_13 * t16_14 - R14_23 * t16_16 - R15_33 * t16_17;
  // P_dot_thetadot14_16 = R15^T (-omega15~ q16~ omega_thetadot14_15 - q16~ omega_dot_thetadot14_15) +
  //   P_dot_thetadot14_15: its rate
  const T minus_P_dot_thetadot14_16_1 = t16_5 - t15_6;
  const T minus_P_dot_thetadot14_16_2 = t16_18 - t15_15;
  const T minus_P_dot_thetadot14_16_3 = t16_19 - t15_16;
  // P_dot_thetadot15_16 = -R15^T omega15~ q16~ b15: its rate
  const T t16_20 = omega15_3 * T(0.2);
  const T t16_21 = omega15_2 * T(0.2);
  const T minus_P_dot_thetadot15_16_1 = R14_21 * t16_20 - R15_31 * t16_21;
  const T minus_P_dot_thetadot15_16_2 = R14_22 * t16_20 - R15_32 * t16_21;
  const T minus_P_dot_thetadot15_16_3 = R14_23 * t16_20 - R15_33 * t16_21;
  // B46_1 = -R16^T omega16~ r16~ omega_omega1_16 - R16^T r16~ omega_dot_omega1_16 + P_dot_omega1_16
  const T t16_22 = T(0.107388) * omega_omega1_16_11 + T(0.006435) * omega_omega1_16_31;
  const T t16_23 = omega16_3 * t16_22;
  const T t16_24 = omega16_1 * t16_22;
  const T t16_25 = T(0.107388) * minus_omega_dot_omega1_16_11 - T(0.006435) * omega_dot_omega1_16_31;
  const T t16_26 = R16_11 * t16_23 - R16_31 * t16_24 + R14_21 * t16_25;
  const T B46_1_11 = P_dot_omega1_16_11 - t16_26;
  const T t16_27 = T(0.107388) * omega_omega1_16_12 + T(0.006435) * omega_omega1_16_32;
  const T t16_28 = T(0.006435) * E14_22;
  const T t16_29 = omega16_3 * t16_27 + omega16_2 * t16_28;
  const T t16_30 = T(0.107388) * E14_22;
  const T t16_31 = omega16_3 * t16_30 - omega16_1 * t16_28;
  const T t16_32 = omega16_1 * t16_27 + omega16_2 * t16_30;
  const T t16_33 = T(0.107388) * minus_omega_dot_omega1_15_22;
  const T t16_34 = T(0.107388) * omega_dot_omega1_16_12 + T(0.006435) * omega_dot_omega1_16_32;
  const T t16_35 = T(0.006435) * minus_omega_dot_omega1_15_22;
  const T B46_1_12 = P_dot_omega1_16_12 - R16_11 * t16_29 - R14_21 * t16_31 + R16_31 * t16_32 + R16_11 * t16_33 +
      R14_21 * t16_34 + R16_31 * t16_35;
  const T t16_36 = T(0.006435) * E14_23;
  const T t16_37 = T(0.107388) * minus_omega_omega1_16_13 - T(0.006435) * omega_omega1_16_33;
  const T t16_38 = omega16_2 * t16_36 - omega16_3 * t16_37;
  const T t16_39 = T(0.107388) * E14_23;
  const T t16_40 = omega16_3 * t16_39 - omega16_1 * t16_36;
  const T t16_41 = omega16_1 * t16_37 - omega16_2 * t16_39;
  const T t16_42 = T(0.107388) * omega_dot_omega1_15_23;
  const T t16_43 = T(0.006435) * minus_omega_dot_omega1_16_33 - T(0.107388) * omega_dot_omega1_16_13;
  const T t16_44 = T(0.006435) * omega_dot_omega1_15_23;
  const T B46_1_13 = P_dot_omega1_16_13 - R16_11 * t16_38 - R14_21 * t16_40 - R16_31 * t16_41 - R16_11 * t16_42 -
      R14_21 * t16_43 - R16_31 * t16_44;
  const T t16_45 = R16_12 * t16_23 - R16_32 * t16_24 + R14_22 * t16_25;
  const T B46_1_21 = P_dot_omega1_16_21 - t16_45;
  const T B46_1_22 = P_dot_omega1_16_22 - R16_12 * t16_29 - R14_22 * t16_31 + R16_32 * t16_32 + R16_12 * t16_33 +
      R14_22 * t16_34 + R16_32 * t16_35;
  const T B46_1_23 = P_dot_omega1_16_23 - R16_12 * t16_38 - R14_22 * t16_40 - R16_32 * t16_41 - R16_12 * t16_42 -
      R14_22 * t16_43 - R16_32 * t16_44;
  const T t16_46 = R16_13 * t16_23 - R16_33 * t16_24 + R14_23 * t16_25;
  const T B46_1_31 = P_dot_omega1_16_31 - t16_46;
  const T B46_1_32 = P_dot_omega1_16_32 - R16_13 * t16_29 - R14_23 * t16_31 + R16_33 * t16_32 + R16_13 * t16_33 +
      R14_23 * t16_34 + R16_33 * t16_35;
  const T B46_1_33 = P_dot_omega1_16_33 - R16_13 * t16_38 - R14_23 * t16_40 - R16_33 * t16_41 - R16_13 * t16_42 -
      R14_23 * t16_43 - R16_33 * t16_44;
  v_y_dot[810] = B46_1_11;
  v_y_dot[811] = B46_1_12;
  v_y_dot[812] = B46_1_13;
  v_y_dot[828] = B46_1_21;
  v_y_dot[829] = B46_1_22;
  v_y_dot[830] = B46_1_23;
  v_y_dot[846] = B46_1_31;
  v_y_dot[847] = B46_1_32;
  v_y_dot[848] = B46_1_33;
  // B47_14 = -R16^T omega16~ r16~ omega_thetadot14_16 - R16^T r16~ omega_dot_thetadot14_16 + P_dot_thetadot14_16
  const T minus_B47_14_1 = t16_26 + minus_P_dot_thetadot14_16_1;
  const T minus_B47_14_2 = t16_45 + minus_P_dot_thetadot14_16_2;
  const T minus_B47_14_3 = t16_46 + minus_P_dot_thetadot14_16_3;
  v_y_dot[822] = -minus_B47_14_1;
  v_y_dot[840] = -minus_B47_14_2;
  v_y_dot[858] = -minus_B47_14_3;
  // B48_15 = -R16^T omega16~ r16~ omega_thetadot15_16 - R16^T r16~ omega_dot_thetadot15_16 + P_dot_thetadot15_16
  const T t16_47 = omega16_2 * T(0.006435);
  const T t16_48 = omega16_3 * T(0.107388) - omega16_1 * T(0.006435);
  const T t16_49 = omega16_2 * T(0.107388);
  const T t16_50 = R16_11 * t16_47 + R14_21 * t16_48 - R16_31 * t16_49;
  const T minus_B48_15_1 = t16_50 + minus_P_dot_thetadot15_16_1;
  const T t16_51 = R16_12 * t16_47 + R14_22 * t16_48 - R16_32 * t16_49;
  const T minus_B48_15_2 = t16_51 + minus_P_dot_thetadot15_16_2;
  const T t16_52 = R16_13 * t16_47 + R14_23 * t16_48 - R16_33 * t16_49;
  const T minus_B48_15_3 = t16_52 + minus_P_dot_thetadot15_16_3;
  v_y_dot[823] = -minus_B48_15_1;
  v_y_dot[841] = -minus_B48_15_2;
  v_y_dot[859] = -minus_B48_15_3;
  v_y_dot[824] = -t16_50;
  v_y_dot[842] = -t16_51;
  v_y_dot[860] = -t16_52;
  // B50_1 = -R16^T omega16~ o17~ omega_omega1_16 - R16^T o17~ omega_dot_omega1_16 + P_dot_omega1_16
  const T t16_53 = T(0.2) * omega_omega1_16_11;
  const T t16_54 = omega16_3 * t16_53;
  const T t16_55 = omega16_1 * t16_53;
  const T t16_56 = T(0.2) * minus_omega_dot_omega1_16_11;
  const T t16_57 = R16_11 * t16_54 - R16_31 * t16_55 + R14_21 * t16_56;
  const T B50_1_11 = P_dot_omega1_16_11 - t16_57;
  const T t16_58 = T(0.2) * omega_omega1_16_12;
  const T t16_59 = omega16_3 * t16_58;
  const T t16_60 = omega16_3 * t16_9;
  const T t16_61 = omega16_1 * t16_58 + omega16_2 * t16_9;
  const T t16_62 = T(0.2) * omega_dot_omega1_16_12;
  const T B50_1_12 = P_dot_omega1_16_12 - R16_11 * t16_59 - R14_21 * t16_60 + R16_31 * t16_61 + R16_11 * t16_7 +
      R14_21 * t16_62;
  const T t16_63 = T(0.2) * minus_omega_omega1_16_13;
  const T t16_64 = omega16_3 * t16_63;
  const T t16_65 = omega16_3 * t16_15;
  const T t16_66 = omega16_1 * t16_63 - omega16_2 * t16_15;
  const T t16_67 = T(0.2) * omega_dot_omega1_16_13;
  const T B50_1_13 = P_dot_omega1_16_13 + R16_11 * t16_64 - R14_21 * t16_65 - R16_31 * t16_66 - R16_11 * t16_12 +
      R14_21 * t16_67;
  const T t16_68 = R16_12 * t16_54 - R16_32 * t16_55 + R14_22 * t16_56;
  const T B50_1_21 = P_dot_omega1_16_21 - t16_68;
  const T B50_1_22 = P_dot_omega1_16_22 - R16_12 * t16_59 - R14_22 * t16_60 + R16_32 * t16_61 + R16_12 * t16_7 +
      R14_22 * t16_62;
  const T B50_1_23 = P_dot_omega1_16_23 + R16_12 * t16_64 - R14_22 * t16_65 - R16_32 * t16_66 - R16_12 * t16_12 +
      R14_22 * t16_67;
  const T t16_69 = R16_13 * t16_54 - R16_33 * t16_55 + R14_23 * t16_56;
  const T B50_1_31 = P_dot_omega1_16_31 - t16_69;
  const T B50_1_32 = P_dot_omega1_16_32 - R16_13 * t16_59 - R14_23 * t16_60 + R16_33 * t16_61 + R16_13 * t16_7 +
      R14_23 * t16_62;
  const T B50_1_33 = P_dot_omega1_16_33 + R16_13 * t16_64 - R14_23 * t16_65 - R16_33 * t16_66 - R16_13 * t16_12 +
      R14_23 * t16_67;
  v_y_dot[864] = B50_1_11;
  v_y_dot[865] = B50_1_12;
  v_y_dot[866] = B50_1_13;
  v_y_dot[882] = B50_1_21;
  v_y_dot[883] = B50_1_22;
  v_y_dot[884] = B50_1_23;
  v_y_dot[900] = B50_1_31;
  v_y_dot[901] = B50_1_32;
  v_y_dot[902] = B50_1_33;
  // B51_14 = -R16^T omega16~ o17~ omega_thetadot14_16 - R16^T o17~ omega_dot_thetadot14_16 + P_dot_thetadot14_16
  const T minus_B51_14_1 = t16_57 + minus_P_dot_thetadot14_16_1;
  const T minus_B51_14_2 = t16_68 + minus_P_dot_thetadot14_16_2;
  const T minus_B51_14_3 = t16_69 + minus_P_dot_thetadot14_16_3;
  v_y_dot[876] = -minus_B51_14_1;
  v_y_dot[894] = -minus_B51_14_2;
  v_y_dot[912] = -minus_B51_14_3;
  // B52_15 = -R16^T omega16~ o17~ omega_thetadot15_16 - R16^T o17~ omega_dot_thetadot15_16 + P_dot_thetadot15_16
  const T t16_70 = omega16_3 * T(0.2);
  const T t16_71 = omega16_2 * T(0.2);
  const T t16_72 = R14_21 * t16_70 - R16_31 * t16_71;
  const T minus_B52_15_1 = t16_72 + minus_P_dot_thetadot15_16_1;
  const T t16_73 = R14_22 * t16_70 - R16_32 * t16_71;
  const T minus_B52_15_2 = t16_73 + minus_P_dot_thetadot15_16_2;
  const T t16_74 = R14_23 * t16_70 - R16_33 * t16_71;
  const T minus_B52_15_3 = t16_74 + minus_P_dot_thetadot15_16_3;
  v_y_dot[877] = -minus_B52_15_1;
  v_y_dot[895] = -minus_B52_15_2;
  v_y_dot[913] = -minus_B52_15_3;
  v_y_dot[878] = -t16_72;
  v_y_dot[896] = -t16_73;
  v_y_dot[914] = -t16_74;
}

}  // namespace kanec::quadruped
