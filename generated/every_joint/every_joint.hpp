// SPDX-License-Identifier: BSD-3-Clause
// every_joint: equations of motion of 13 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 2397d9dbedfd67f1 of every_joint/scene.toml; functions kinematics poses energy momentum power accelerations
// residual forcing mass_matrix partial_velocities partial_velocity_rates partial_angular_velocities
// partial_angular_velocity_rates load_powers driving_loads reactions probe_position probe_velocity probe_acceleration
// probe_jacobian kinematics+accelerations
// bodies and their joints:
//   1 hull on the inertial frame: free
//   2 clapper on 1: ball
//   3 boom on 1: revolute
//   4 cross on 1: universal
//   5 camera on 1: gimbal
//   6 telescope on 3: prismatic
//   7 gantry on the inertial frame: cartesian
//   8 piston on 1: cylindrical
//   9 sled on the inertial frame: planar
//   10 runner on 1: bearing
//   11 nut on 8: screw
//   12 plate on 5: weld
//   13 ballast on the inertial frame: free
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (eps_1_1 .. eps_1_4, eps_2_1 .. eps_2_4, theta_3, theta_4_1, theta_4_2, theta_5_1, theta_8, theta_9,
//   eps_10_1 .. eps_10_4, theta_11, s_1_1 .. s_1_3, s_6, s_7_1, s_7_2, s_8, s_9_1, s_9_2, s_10, s_13_1 .. s_13_3)
//   y = (omega_1_1 .. omega_1_3, omega_2_1 .. omega_2_3, thetadot_3, thetadot_4_1, thetadot_4_2, thetadot_5_1,
//   thetadot_8, thetadot_9, omega_10_1 .. omega_10_3, thetadot_11, sdot_1_1 .. sdot_1_3, sdot_6, sdot_7_1, sdot_7_2,
//   sdot_8, sdot_9_1, sdot_9_2, sdot_10, sdot_13_1 .. sdot_13_3)
//   locked: theta_5_3 = 0.1, eps_13, s_7_3 = 0.4
//   prescribed: theta_5_2 = amplitude*sin(3*t)
//   eps       Euler parameters relative to the inertial frame, scalar last, of unit norm (4 a body)
//   theta     angle of a joint about its axis [rad]
//   s         translation from the joint point, axes of the lower body [m]
//   omega     absolute angular velocity, body axes [rad/s] (3)
//   thetadot  rate of theta [rad/s]
//   sdot      rate of s [m/s]
// R takes inertial components to body components; a~ b = a x b; matrices are row-major.
// No function allocates, throws, branches or keeps a state; results must not overlap arguments. T is the scalar:
// float, double, long double, or any type with + - * /, unary -, a constructor from double and a default one, and of
// its own or by conversion abs, cos, exp, sin, sqrt, tanh. Cosines and sines of angles in double are those of
// cos_sin() below, with KANEC_LIBM_COS_SIN the library's.
//
// operations of one call (adds + multiplies + divides):
//   kinematics                      69 (24 add, 45 multiply)
//   poses                           604 (268 add, 336 multiply, 17 sine or cosine)
//   energy                          1150 (499 add, 651 multiply, 1 square root, 18 sine or cosine)
//   momentum                        1434 (651 add, 783 multiply, 18 sine or cosine)
//   power                           614 (273 add, 340 multiply, 1 divide, 11 sine or cosine, 3 other function)
//   accelerations                   3525 (1601 add, 1910 multiply, 14 divide, 1 square root, 19 sine or cosine, 3 other function)
//   residual                        1830 (839 add, 989 multiply, 2 divide, 1 square root, 19 sine or cosine, 3 other function)
//   forcing                         1678 (750 add, 926 multiply, 2 divide, 1 square root, 19 sine or cosine, 3 other function)
//   mass_matrix                     1074 (460 add, 614 multiply, 17 sine or cosine)
//   partial_velocities              1150 (470 add, 680 multiply, 17 sine or cosine)
//   partial_velocity_rates          2374 (937 add, 1437 multiply, 18 sine or cosine)
//   partial_angular_velocities      165 (61 add, 104 multiply, 15 sine or cosine)
//   partial_angular_velocity_rates  246 (81 add, 165 multiply, 16 sine or cosine)
//   load_powers                     616 (271 add, 343 multiply, 2 divide, 1 square root, 11 sine or cosine, 3 other function)
//   driving_loads                   441 (193 add, 246 multiply, 2 divide, 1 square root, 8 sine or cosine)
//   reactions                       1886 (861 add, 1023 multiply, 2 divide, 1 square root, 19 sine or cosine, 1 other function)
//   probe_position                  91 (38 add, 53 multiply, 5 sine or cosine)
//   probe_velocity                  150 (61 add, 89 multiply, 6 sine or cosine)
//   probe_acceleration              245 (105 add, 140 multiply, 6 sine or cosine)
//   probe_jacobian                  157 (60 add, 97 multiply, 5 sine or cosine)
//   kinematics_and_accelerations    3594 (1625 add, 1955 multiply, 14 divide, 1 square root, 19 sine or cosine, 3 other function)
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

namespace kanec::every_joint {

inline constexpr int n_bodies = 13;
inline constexpr int nx = 32;
inline constexpr int ny = 29;
inline constexpr int n_parameters = 3;
inline constexpr int n_inputs = 2;
inline constexpr char model_hash[] = "2397d9dbedfd67f1";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int eps_1_1 = 0, eps_1_2 = 1, eps_1_3 = 2, eps_1_4 = 3, eps_2_1 = 4, eps_2_2 = 5, eps_2_3 = 6,
    eps_2_4 = 7, theta_3 = 8, theta_4_1 = 9, theta_4_2 = 10, theta_5_1 = 11, theta_8 = 12, theta_9 = 13,
    eps_10_1 = 14, eps_10_2 = 15, eps_10_3 = 16, eps_10_4 = 17, theta_11 = 18, s_1_1 = 19, s_1_2 = 20, s_1_3 = 21,
    s_6 = 22, s_7_1 = 23, s_7_2 = 24, s_8 = 25, s_9_1 = 26, s_9_2 = 27, s_10 = 28, s_13_1 = 29, s_13_2 = 30,
    s_13_3 = 31;
inline constexpr int omega_1_1 = 0, omega_1_2 = 1, omega_1_3 = 2, omega_2_1 = 3, omega_2_2 = 4, omega_2_3 = 5,
    thetadot_3 = 6, thetadot_4_1 = 7, thetadot_4_2 = 8, thetadot_5_1 = 9, thetadot_8 = 10, thetadot_9 = 11,
    omega_10_1 = 12, omega_10_2 = 13, omega_10_3 = 14, thetadot_11 = 15, sdot_1_1 = 16, sdot_1_2 = 17, sdot_1_3 = 18,
    sdot_6 = 19, sdot_7_1 = 20, sdot_7_2 = 21, sdot_8 = 22, sdot_9_1 = 23, sdot_9_2 = 24, sdot_10 = 25,
    sdot_13_1 = 26, sdot_13_2 = 27, sdot_13_3 = 28;
inline constexpr int eps_hull_1 = 0, eps_hull_2 = 1, eps_hull_3 = 2, eps_hull_4 = 3, eps_clapper_1 = 4,
    eps_clapper_2 = 5, eps_clapper_3 = 6, eps_clapper_4 = 7, theta_boom = 8, theta_cross_1 = 9, theta_cross_2 = 10,
    theta_camera_1 = 11, theta_piston = 12, theta_sled = 13, eps_runner_1 = 14, eps_runner_2 = 15, eps_runner_3 = 16,
    eps_runner_4 = 17, theta_nut = 18, s_hull_1 = 19, s_hull_2 = 20, s_hull_3 = 21, s_telescope = 22, s_gantry_1 = 23,
    s_gantry_2 = 24, s_piston = 25, s_sled_1 = 26, s_sled_2 = 27, s_runner = 28, s_ballast_1 = 29, s_ballast_2 = 30,
    s_ballast_3 = 31;
inline constexpr int omega_hull_1 = 0, omega_hull_2 = 1, omega_hull_3 = 2, omega_clapper_1 = 3, omega_clapper_2 = 4,
    omega_clapper_3 = 5, thetadot_boom = 6, thetadot_cross_1 = 7, thetadot_cross_2 = 8, thetadot_camera_1 = 9,
    thetadot_piston = 10, thetadot_sled = 11, omega_runner_1 = 12, omega_runner_2 = 13, omega_runner_3 = 14,
    thetadot_nut = 15, sdot_hull_1 = 16, sdot_hull_2 = 17, sdot_hull_3 = 18, sdot_telescope = 19, sdot_gantry_1 = 20,
    sdot_gantry_2 = 21, sdot_piston = 22, sdot_sled_1 = 23, sdot_sled_2 = 24, sdot_runner = 25, sdot_ballast_1 = 26,
    sdot_ballast_2 = 27, sdot_ballast_3 = 28;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 253;
inline constexpr int mass_matrix_rows[] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 1, 1, 1, 1,
    1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 2, 3, 3,
    3, 3, 3, 3, 3, 4, 4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 6, 6, 6, 6, 6, 6, 6, 6, 7, 7, 7, 7, 7, 7, 7, 8, 8,
    8, 8, 8, 8, 8, 9, 9, 9, 9, 9, 9, 9, 10, 10, 10, 10, 10, 10, 10, 10, 11, 11, 11, 12, 12, 12, 12, 12, 12, 12, 12,
    12, 12, 13, 13, 13, 13, 13, 13, 13, 13, 13, 13, 14, 14, 14, 14, 14, 14, 14, 14, 14, 14, 15, 15, 15, 15, 15, 15,
    15, 15, 15, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 16, 17, 17, 17, 17, 17, 17,
    17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 17, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18, 18,
    18, 18, 18, 18, 19, 19, 19, 19, 19, 19, 19, 19, 20, 21, 22, 22, 22, 22, 22, 22, 22, 23, 23, 24, 24, 25, 25, 25,
    25, 25, 25, 25, 25, 25, 26, 27, 28};
inline constexpr int mass_matrix_columns[] = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 14, 15, 16, 17, 18, 19, 22,
    25, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 14, 15, 16, 17, 18, 19, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13,
    14, 15, 16, 17, 18, 19, 22, 25, 0, 1, 2, 3, 16, 17, 18, 0, 1, 2, 4, 5, 16, 17, 18, 0, 1, 2, 4, 5, 16, 17, 18, 0,
    1, 2, 6, 16, 17, 18, 19, 0, 1, 2, 7, 16, 17, 18, 0, 1, 2, 8, 16, 17, 18, 0, 1, 2, 9, 16, 17, 18, 0, 1, 2, 10, 15,
    16, 17, 18, 11, 23, 24, 0, 1, 2, 12, 13, 14, 16, 17, 18, 25, 0, 1, 2, 12, 13, 14, 16, 17, 18, 25, 0, 1, 2, 12, 13,
    14, 16, 17, 18, 25, 0, 1, 2, 10, 15, 16, 17, 18, 22, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 14, 15, 16, 19, 22,
    25, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13, 14, 15, 17, 19, 22, 25, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 13,
    14, 15, 18, 19, 22, 25, 0, 1, 2, 6, 16, 17, 18, 19, 20, 21, 0, 2, 15, 16, 17, 18, 22, 11, 23, 11, 24, 0, 2, 12,
    13, 14, 16, 17, 18, 25, 26, 27, 28};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
  T k = T(30);
  T amplitude = T(0.2);
  T m_plate = T(0.7);
};

// Run-time inputs with the scene's defaults, SI units.
template <class T>
struct Inputs {
  T motor = T(0.4);
  T thrust = T(3);
};

// What depends on parameters only, computed once for many calls.
template <class T>
struct Prepared {
  Parameters<T> p;
  T m_link5;
  T r_link5_1;
  T r_link5_3;
  T I_link5_11;
  T I_link5_13;
  T I_link5_22;
  T I_link5_33;
  T c5_1;
  T c0_1;
  T E5_11;
  T E5_31;
  T c9_1;
  T HA5_21;
  T HA5_32;
  T JA5_11;
  T JA5_13;
  T JA5_22;
  T JA5_33;
  T c5_2;
  T c5_3;
  T c9_2;
  T c9_3;
  T c9_4;
  T lever5_1;
  T lever5_3;
  T J_all_1_11;
  T J_all_1_22;
  T J_all_1_23;
  T J_all_1_33;
  T h_all_1_2;
  T c1_1;
  T m_sub1;
};

// prepare: 39 add, 41 multiply, 1 divide, 2 sine or cosine
template <class T>
Prepared<T> prepare([[maybe_unused]] const Parameters<T>& p) noexcept {
  using std::cos, std::sin;
  Prepared<T> c{};
  c.p = p;
  const T m_link5 = T(0.6) + p.m_plate;
  const T t1 = T(1) / m_link5;
  const T t2 = T(0.6) * t1;
  const T t3 = p.m_plate * t1;
  const T r_link5_1 = t2 * T(0.049750208263901294) + T(0.06785135119395468) * t3;
  const T r_link5_3 = T(0.028725012259164514) * t3 - t2 * T(0.004991670832341408);
  const T t4 = T(0.004991670832341408) + r_link5_3;
  const T t5 = t4 * t4;
  const T t6 = T(0.028725012259164514) - r_link5_3;
  const T t7 = t6 * t6;
  const T I_link5_11 = T(0.007407305372669502) + T(0.6) * t5 + p.m_plate * t7;
  const T t8 = T(0.049750208263901294) - r_link5_1;
  const T t9 = T(0.06785135119395468) - r_link5_1;
  const T I_link5_13 = T(0.0020594678210800145) + t4 * t8 * T(0.6) - t6 * t9 * p.m_plate;
  const T t10 = t8 * t8;
  const T t11 = t9 * t9;
  const T I_link5_22 = T(0.006) + T(0.6) * (t5 + t10) + p.m_plate * (t7 + t11);
  const T I_link5_33 = T(0.007592694627330498) + T(0.6) * t10 + p.m_plate * t11;
  const T c5_1 = T(0.5) * m_link5;
  const T c0_1 = T(0.5) * p.k;
  const T E5_11 = cos(T(0.1));
  const T E5_31 = sin(T(0.1));
  const T c9_1 = p.k * T(0.3);
  const T HA5_21 = m_link5 * r_link5_3;
  const T HA5_32 = m_link5 * r_link5_1;
  const T t12 = r_link5_3 * r_link5_3;
  const T JA5_11 = m_link5 * t12 + I_link5_11;
  const T JA5_13 = I_link5_13 - r_link5_3 * r_link5_1 * m_link5;
  const T t13 = r_link5_1 * r_link5_1;
  const T JA5_22 = m_link5 * (t12 + t13) + I_link5_22;
  const T JA5_33 = m_link5 * t13 + I_link5_33;
  const T c5_2 = JA5_22 - JA5_33;
  const T c5_3 = T(0.3) * m_link5;
  const T t14 = I_link5_11 - I_link5_22;
  const T c9_2 = T(0.5) * (I_link5_33 - t14);
  const T c9_3 = T(0.5) * (I_link5_33 + t14);
  const T c9_4 = T(0.5) * (I_link5_11 + I_link5_22 - I_link5_33);
  const T lever5_1 = T(0.03620228586010676) - r_link5_1;
  const T lever5_3 = T(0.06743336618301184) - r_link5_3;
  const T J_all_1_11 = T(0.672) + m_link5 * T(0.09999999999999999);
  const T J_all_1_22 = T(0.7604) + m_link5 * T(0.010000000000000002);
  const T J_all_1_23 = T(0.0484) + m_link5 * T(0.03);
  const T J_all_1_33 = T(0.9239999999999999) + m_link5 * T(0.09);
  const T h_all_1_2 = T(0.09000000000000001) - c5_3;
  const T c1_1 = T(0.22999999999999998) + m_link5 * T(0.1) + T(0.17);
  const T m_sub1 = T(11.2) + m_link5 + T(1.9);
  c.m_link5 = m_link5;
  c.r_link5_1 = r_link5_1;
  c.r_link5_3 = r_link5_3;
  c.I_link5_11 = I_link5_11;
  c.I_link5_13 = I_link5_13;
  c.I_link5_22 = I_link5_22;
  c.I_link5_33 = I_link5_33;
  c.c5_1 = c5_1;
  c.c0_1 = c0_1;
  c.E5_11 = E5_11;
  c.E5_31 = E5_31;
  c.c9_1 = c9_1;
  c.HA5_21 = HA5_21;
  c.HA5_32 = HA5_32;
  c.JA5_11 = JA5_11;
  c.JA5_13 = JA5_13;
  c.JA5_22 = JA5_22;
  c.JA5_33 = JA5_33;
  c.c5_2 = c5_2;
  c.c5_3 = c5_3;
  c.c9_2 = c9_2;
  c.c9_3 = c9_3;
  c.c9_4 = c9_4;
  c.lever5_1 = lever5_1;
  c.lever5_3 = lever5_3;
  c.J_all_1_11 = J_all_1_11;
  c.J_all_1_22 = J_all_1_22;
  c.J_all_1_23 = J_all_1_23;
  c.J_all_1_33 = J_all_1_33;
  c.h_all_1_2 = h_all_1_2;
  c.c1_1 = c1_1;
  c.m_sub1 = m_sub1;
  return c;
}

// kinematics: xdot, the kinematical equations.
// rates of x (nx) [1/s], [rad/s], [m/s]
// 24 add, 45 multiply
template <class T>
void kinematics([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* xdot) noexcept {

  // ---- body 1 (hull) on the inertial frame
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

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // w2 = 1/2 omega2: half the angular velocity [rad/s]
  const T w2_1 = T(0.5) * omega2_1;
  const T w2_2 = T(0.5) * omega2_2;
  const T w2_3 = T(0.5) * omega2_3;
  // edot2 = e2~ w2 + eps4_2 w2: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot2_1 = eps2_2 * w2_3 - eps2_3 * w2_2 + eps2_4 * w2_1;
  const T edot2_2 = eps2_3 * w2_1 - eps2_1 * w2_3 + eps2_4 * w2_2;
  const T edot2_3 = eps2_1 * w2_2 - eps2_2 * w2_1 + eps2_4 * w2_3;
  xdot[4] = edot2_1;
  xdot[5] = edot2_2;
  xdot[6] = edot2_3;
  // eps4dot2 = -e2 . w2: rate of eps_4 [1/s]
  const T minus_eps4dot2 = eps2_1 * w2_1 + eps2_2 * w2_2 + eps2_3 * w2_3;
  xdot[7] = -minus_eps4dot2;

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T omega10_1 = y[12], omega10_2 = y[13], omega10_3 = y[14];
  // w10 = 1/2 omega10: half the angular velocity [rad/s]
  const T w10_1 = T(0.5) * omega10_1;
  const T w10_2 = T(0.5) * omega10_2;
  const T w10_3 = T(0.5) * omega10_3;
  // edot10 = e10~ w10 + eps4_10 w10: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot10_1 = eps10_2 * w10_3 - eps10_3 * w10_2 + eps10_4 * w10_1;
  const T edot10_2 = eps10_3 * w10_1 - eps10_1 * w10_3 + eps10_4 * w10_2;
  const T edot10_3 = eps10_1 * w10_2 - eps10_2 * w10_1 + eps10_4 * w10_3;
  xdot[14] = edot10_1;
  xdot[15] = edot10_2;
  xdot[16] = edot10_3;
  // eps4dot10 = -e10 . w10: rate of eps_4 [1/s]
  const T minus_eps4dot10 = eps10_1 * w10_1 + eps10_2 * w10_2 + eps10_3 * w10_3;
  xdot[17] = -minus_eps4dot10;

  // ---- results
  const T thetadot3 = y[6];
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  const T thetadot5_1 = y[9];
  const T thetadot8 = y[10];
  const T thetadot9 = y[11];
  const T thetadot11 = y[15];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  const T sdot6 = y[19];
  const T sdot7_1 = y[20], sdot7_2 = y[21];
  const T sdot8 = y[22];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  const T sdot10 = y[25];
  const T sdot13_1 = y[26], sdot13_2 = y[27], sdot13_3 = y[28];
  xdot[8] = thetadot3;
  xdot[9] = thetadot4_1;
  xdot[10] = thetadot4_2;
  xdot[11] = thetadot5_1;
  xdot[12] = thetadot8;
  xdot[13] = thetadot9;
  xdot[18] = thetadot11;
  xdot[19] = sdot1_1;
  xdot[20] = sdot1_2;
  xdot[21] = sdot1_3;
  xdot[22] = sdot6;
  xdot[23] = sdot7_1;
  xdot[24] = sdot7_2;
  xdot[25] = sdot8;
  xdot[26] = sdot9_1;
  xdot[27] = sdot9_2;
  xdot[28] = sdot10;
  xdot[29] = sdot13_1;
  xdot[30] = sdot13_2;
  xdot[31] = sdot13_3;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 268 add, 336 multiply, 17 sine or cosine
template <class T>
void poses(const Prepared<T>& c, T t, const T* x, T* pose) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 156; ++i) pose[i] = T(0);
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
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
  pose[90] = -R1_21;
  pose[126] = -R1_21;
  pose[4] = R1_22;
  pose[91] = -R1_22;
  pose[127] = -R1_22;
  pose[5] = R1_23;
  pose[92] = -R1_23;
  pose[128] = -R1_23;
  pose[6] = R1_31;
  pose[7] = R1_32;
  pose[8] = R1_33;
  // p1 = s1 + R1^T r1: position of the mass centre, inertial axes [m]
  const T p1_1 = s1_1 + R1_11 * T(0.02) - R1_21 * T(0.01) + R1_31 * T(0.03);
  const T p1_2 = s1_2 + R1_12 * T(0.02) - R1_22 * T(0.01) + R1_32 * T(0.03);
  const T p1_3 = s1_3 + R1_13 * T(0.02) - R1_23 * T(0.01) + R1_33 * T(0.03);
  pose[9] = p1_1;
  pose[10] = p1_2;
  pose[11] = p1_3;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  pose[12] = R2_11;
  pose[13] = R2_12;
  pose[14] = R2_13;
  pose[15] = R2_21;
  pose[16] = R2_22;
  pose[17] = R2_23;
  pose[18] = R2_31;
  pose[19] = R2_32;
  pose[20] = R2_33;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_13 = R1_21 * T(0.1);
  const T t2_14 = s1_1 + t2_13;
  const T t2_15 = R1_11 * T(0.2);
  const T P2_1 = t2_14 + t2_15 - R1_31 * T(0.2);
  const T t2_16 = R1_22 * T(0.1);
  const T t2_17 = s1_2 + t2_16;
  const T t2_18 = R1_12 * T(0.2);
  const T P2_2 = t2_17 + t2_18 - R1_32 * T(0.2);
  const T t2_19 = R1_23 * T(0.1);
  const T t2_20 = s1_3 + t2_19;
  const T t2_21 = R1_13 * T(0.2);
  const T P2_3 = t2_20 + t2_21 - R1_33 * T(0.2);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = P2_1 + R2_21 * T(0.02) - R2_31 * T(0.2);
  const T p2_2 = P2_2 + R2_22 * T(0.02) - R2_32 * T(0.2);
  const T p2_3 = P2_3 + R2_23 * T(0.02) - R2_33 * T(0.2);
  pose[21] = p2_1;
  pose[22] = p2_2;
  pose[23] = p2_3;

  // ---- body 3 (boom) on body 1
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_11 * E3_31 + R1_21 * E3_32 + R1_31 * E3_33;
  const T R3_32 = R1_12 * E3_31 + R1_22 * E3_32 + R1_32 * E3_33;
  const T R3_33 = R1_13 * E3_31 + R1_23 * E3_32 + R1_33 * E3_33;
  pose[24] = R3_11;
  pose[60] = R3_11;
  pose[25] = R3_12;
  pose[61] = R3_12;
  pose[26] = R3_13;
  pose[62] = R3_13;
  pose[27] = R3_21;
  pose[63] = R3_21;
  pose[28] = R3_22;
  pose[64] = R3_22;
  pose[29] = R3_23;
  pose[65] = R3_23;
  pose[30] = R3_31;
  pose[66] = R3_31;
  pose[31] = R3_32;
  pose[67] = R3_32;
  pose[32] = R3_33;
  pose[68] = R3_33;
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_18 = s1_1 + R1_31 * T(0.1);
  const T P3_1 = t3_18 + R1_11 * T(0.3);
  const T t3_19 = s1_2 + R1_32 * T(0.1);
  const T P3_2 = t3_19 + R1_12 * T(0.3);
  const T t3_20 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_20 + R1_13 * T(0.3);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 + R3_11 * T(0.2) + R3_21 * T(0.02);
  const T p3_2 = P3_2 + R3_12 * T(0.2) + R3_22 * T(0.02);
  const T p3_3 = P3_3 + R3_13 * T(0.2) + R3_23 * T(0.02);
  pose[33] = p3_1;
  pose[34] = p3_2;
  pose[35] = p3_3;

  // ---- body 4 (cross) on body 1
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // R4a^T = R1^T E4a^T: R takes inertial components to body components
  const T R4a_11 = R1_11 * E4a_11 - R1_21 * minus_E4a_12 - R1_31 * minus_E4a_13;
  const T R4a_12 = R1_12 * E4a_11 - R1_22 * minus_E4a_12 - R1_32 * minus_E4a_13;
  const T R4a_13 = R1_13 * E4a_11 - R1_23 * minus_E4a_12 - R1_33 * minus_E4a_13;
  const T R4a_21 = R1_11 * minus_E4a_12 + R1_21 * E4a_22 + R1_31 * E4a_23;
  const T R4a_22 = R1_12 * minus_E4a_12 + R1_22 * E4a_22 + R1_32 * E4a_23;
  const T R4a_23 = R1_13 * minus_E4a_12 + R1_23 * E4a_22 + R1_33 * E4a_23;
  const T R4a_31 = R1_11 * minus_E4a_13 + R1_21 * E4a_23 + R1_31 * E4a_33;
  const T R4a_32 = R1_12 * minus_E4a_13 + R1_22 * E4a_23 + R1_32 * E4a_33;
  const T R4a_33 = R1_13 * minus_E4a_13 + R1_23 * E4a_23 + R1_33 * E4a_33;
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_3 = cosines[10];
  const T E4_12 = T(0.28) * t4_3;
  const T minus_E4_13 = T(0.96) * t4_3;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // R4^T = R4a^T E4^T: R takes inertial components to body components
  const T R4_11 = R4a_21 * E4_12 - R4a_11 * minus_E4_11 - R4a_31 * minus_E4_13;
  const T R4_12 = R4a_22 * E4_12 - R4a_12 * minus_E4_11 - R4a_32 * minus_E4_13;
  const T R4_13 = R4a_23 * E4_12 - R4a_13 * minus_E4_11 - R4a_33 * minus_E4_13;
  const T R4_21 = R4a_21 * T(0.96) + R4a_31 * T(0.28);
  const T R4_22 = R4a_22 * T(0.96) + R4a_32 * T(0.28);
  const T R4_23 = R4a_23 * T(0.96) + R4a_33 * T(0.28);
  const T R4_31 = R4a_11 * t4_3 + R4a_21 * E4_32 - R4a_31 * minus_E4_33;
  const T R4_32 = R4a_12 * t4_3 + R4a_22 * E4_32 - R4a_32 * minus_E4_33;
  const T R4_33 = R4a_13 * t4_3 + R4a_23 * E4_32 - R4a_33 * minus_E4_33;
  pose[36] = R4_11;
  pose[37] = R4_12;
  pose[38] = R4_13;
  pose[39] = R4_21;
  pose[40] = R4_22;
  pose[41] = R4_23;
  pose[42] = R4_31;
  pose[43] = R4_32;
  pose[44] = R4_33;
  // P4a = s1 + R1^T q4a: position of the body origin, inertial axes [m]
  const T P4a_1 = t2_14 - t2_15;
  const T P4a_2 = t2_17 - t2_18;
  const T P4a_3 = t2_20 - t2_21;
  // p4 = R4^T r4 + P4a: position of the mass centre, inertial axes [m]
  const T p4_1 = P4a_1 + R4_11 * T(0.03) + R4_31 * T(0.1);
  const T p4_2 = P4a_2 + R4_12 * T(0.03) + R4_32 * T(0.1);
  const T p4_3 = P4a_3 + R4_13 * T(0.03) + R4_33 * T(0.1);
  pose[45] = p4_1;
  pose[46] = p4_2;
  pose[47] = p4_3;

  // ---- body 5 (camera) on body 1
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // theta5_2 = expression 1: prescribed
  const T theta5_2 = c.p.amplitude * sin(T(3) * t);
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  pose[51] = R5_21;
  pose[132] = R5_21;
  pose[52] = R5_22;
  pose[133] = R5_22;
  pose[53] = R5_23;
  pose[134] = R5_23;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = t3_18 - R1_21 * T(0.3);
  const T P5a_2 = t3_19 - R1_22 * T(0.3);
  const T P5a_3 = t3_20 - R1_23 * T(0.3);

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_1 = P3_1 + R3_11 * d6_1;
  const T P6_2 = P3_2 + R3_12 * d6_1;
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // p6 = R3^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = P6_1 + R3_11 * T(0.1) + R3_31 * T(0.01);
  const T p6_2 = P6_2 + R3_12 * T(0.1) + R3_32 * T(0.01);
  const T p6_3 = P6_3 + R3_13 * T(0.1) + R3_33 * T(0.01);
  pose[69] = p6_1;
  pose[70] = p6_2;
  pose[71] = p6_3;

  // ---- body 7 (gantry) on the inertial frame
  const T s7_1 = x[23], s7_2 = x[24];
  // d7 = q7 + s7_1 u7_1 + s7_2 u7_2: joint offset q + s, axes of the lower body [m]
  const T d7_1 = T(2) + s7_1;
  pose[81] = d7_1;
  // p7 = r7 + d7: position of the mass centre, inertial axes [m]
  const T p7_2 = T(0.1) + s7_2;
  pose[82] = p7_2;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // R8^T = R1^T E8^T: R takes inertial components to body components
  const T R8_11 = R1_11 * E8_11 + R1_31 * E8_13;
  const T R8_12 = R1_12 * E8_11 + R1_32 * E8_13;
  const T R8_13 = R1_13 * E8_11 + R1_33 * E8_13;
  const T R8_31 = R1_31 * E8_11 - R1_11 * E8_13;
  const T R8_32 = R1_32 * E8_11 - R1_12 * E8_13;
  const T R8_33 = R1_33 * E8_11 - R1_13 * E8_13;
  pose[87] = -R8_11;
  pose[88] = -R8_12;
  pose[89] = -R8_13;
  pose[84] = R8_31;
  pose[85] = R8_32;
  pose[86] = R8_33;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // P8 = s1 + R1^T d8: position of the body origin, inertial axes [m]
  const T P8_1 = s1_1 + R1_21 * d8_2;
  const T P8_2 = s1_2 + R1_22 * d8_2;
  const T P8_3 = s1_3 + R1_23 * d8_2;

  // ---- body 9 (sled) on the inertial frame
  const T s9_1 = x[26], s9_2 = x[27];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  pose[96] = E9_11;
  pose[100] = E9_11;
  pose[97] = E9_12;
  pose[99] = -E9_12;
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // p9 = E9^T r9 + d9: position of the mass centre, inertial axes [m]
  const T p9_1 = s9_1 + E9_11 * T(0.1);
  const T p9_2 = d9_2 + E9_12 * T(0.1);
  pose[105] = p9_1;
  pose[106] = p9_2;

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  pose[108] = R10_11;
  pose[109] = R10_12;
  pose[110] = R10_13;
  pose[111] = R10_21;
  pose[112] = R10_22;
  pose[113] = R10_23;
  pose[114] = R10_31;
  pose[115] = R10_32;
  pose[116] = R10_33;
  // P10 = s1 + R1^T d10: position of the body origin, inertial axes [m]
  const T P10_1 = s1_1 + R1_11 * T(0.1) + R1_21 * s10 + R1_31 * T(0.3);
  const T P10_2 = s1_2 + R1_12 * T(0.1) + R1_22 * s10 + R1_32 * T(0.3);
  const T P10_3 = s1_3 + R1_13 * T(0.1) + R1_23 * s10 + R1_33 * T(0.3);
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_1 = P10_1 + R10_11 * T(0.02) + R10_21 * T(0.01) - R10_31 * T(0.03);
  const T p10_2 = P10_2 + R10_12 * T(0.02) + R10_22 * T(0.01) - R10_32 * T(0.03);
  const T p10_3 = P10_3 + R10_13 * T(0.02) + R10_23 * T(0.01) - R10_33 * T(0.03);
  pose[117] = p10_1;
  pose[118] = p10_2;
  pose[119] = p10_3;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // R11^T = R8^T E11^T: R takes inertial components to body components
  const T R11_11 = R8_11 * E11_11 + R8_31 * E11_13;
  const T R11_12 = R8_12 * E11_11 + R8_32 * E11_13;
  const T R11_13 = R8_13 * E11_11 + R8_33 * E11_13;
  const T R11_31 = R8_31 * E11_11 - R8_11 * E11_13;
  const T R11_32 = R8_32 * E11_11 - R8_12 * E11_13;
  const T R11_33 = R8_33 * E11_11 - R8_13 * E11_13;
  pose[123] = -R11_11;
  pose[124] = -R11_12;
  pose[125] = -R11_13;
  pose[120] = R11_31;
  pose[121] = R11_32;
  pose[122] = R11_33;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // P11 = R8^T d11 + P8: position of the body origin, inertial axes [m]
  const T P11_1 = P8_1 - R1_21 * minus_d11_2;
  const T P11_2 = P8_2 - R1_22 * minus_d11_2;
  const T P11_3 = P8_3 - R1_23 * minus_d11_2;

  // ---- body 13 (ballast) on the inertial frame
  const T s13_1 = x[29];
  // d13 = q13 + s13: joint offset q + s, axes of the lower body [m]
  const T d13_1 = s13_1 - T(1);
  pose[153] = d13_1;

  // ---- results
  const T s13_2 = x[30], s13_3 = x[31];
  pose[48] = T(0.9950041652780258) * R5a_11 - T(0.09983341664682815) * R5_31;
  pose[49] = T(0.9950041652780258) * R5a_12 - T(0.09983341664682815) * R5_32;
  pose[50] = T(0.9950041652780258) * R5a_13 - T(0.09983341664682815) * R5_33;
  pose[54] = T(0.09983341664682815) * R5a_11 + T(0.9950041652780258) * R5_31;
  pose[55] = T(0.09983341664682815) * R5a_12 + T(0.9950041652780258) * R5_32;
  pose[56] = T(0.09983341664682815) * R5a_13 + T(0.9950041652780258) * R5_33;
  pose[57] = P5a_1 + R5a_11 * T(0.049750208263901294) - R5_31 * T(0.004991670832341408);
  pose[58] = P5a_2 + R5a_12 * T(0.049750208263901294) - R5_32 * T(0.004991670832341408);
  pose[59] = P5a_3 + R5a_13 * T(0.049750208263901294) - R5_33 * T(0.004991670832341408);
  pose[72] = T(1);
  pose[76] = T(1);
  pose[80] = T(1);
  pose[104] = T(1);
  pose[148] = T(1);
  pose[83] = T(0.9);
  pose[93] = P8_1 - t2_13 - R8_11 * T(0.01) + R8_31 * T(0.02);
  pose[94] = P8_2 - t2_16 - R8_12 * T(0.01) + R8_32 * T(0.02);
  pose[95] = P8_3 - t2_19 - R8_13 * T(0.01) + R8_33 * T(0.02);
  pose[129] = P11_1 + R11_31 * T(0.01);
  pose[130] = P11_2 + R11_32 * T(0.01);
  pose[131] = P11_3 + R11_33 * T(0.01);
  pose[135] = T(0.7741670784769465) * R5_31 - T(0.6329813066769583) * R5a_11;
  pose[136] = T(0.7741670784769465) * R5_32 - T(0.6329813066769583) * R5a_12;
  pose[137] = T(0.7741670784769465) * R5_33 - T(0.6329813066769583) * R5a_13;
  pose[138] = T(0.7741670784769465) * R5a_11 + T(0.6329813066769583) * R5_31;
  pose[139] = T(0.7741670784769465) * R5a_12 + T(0.6329813066769583) * R5_32;
  pose[140] = T(0.7741670784769465) * R5a_13 + T(0.6329813066769583) * R5_33;
  pose[141] = P5a_1 + T(0.028725012259164514) * R5_31 + T(0.06785135119395468) * R5a_11;
  pose[142] = P5a_2 + T(0.028725012259164514) * R5_32 + T(0.06785135119395468) * R5a_12;
  pose[143] = P5a_3 + T(0.028725012259164514) * R5_33 + T(0.06785135119395468) * R5a_13;
  pose[144] = T(0.28);
  pose[152] = T(0.28);
  pose[146] = -T(0.96);
  pose[150] = T(0.96);
  pose[154] = s13_2;
  pose[155] = s13_3;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 499 add, 651 multiply, 1 square root, 18 sine or cosine
template <class T>
void energy(const Prepared<T>& c, T t, const T* x, const T* y, T* energy) noexcept {
  using std::cos, std::sin, std::sqrt;
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_3 = x[21];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
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
  const T p1_3 = s1_3 + R1_13 * T(0.02) - R1_23 * T(0.01) + R1_33 * T(0.03);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = T(0.01) * omega1_3;
  const T t1_14 = T(0.03) * omega1_2;
  const T t1_15 = t1_13 + t1_14;
  const T t1_16 = omega1_3 * T(0.02) - omega1_1 * T(0.03);
  const T t1_17 = T(0.01) * omega1_1;
  const T t1_18 = T(0.02) * omega1_2;
  const T t1_19 = t1_17 + t1_18;
  const T v1_1 = sdot1_1 + R1_11 * t1_15 + R1_21 * t1_16 - R1_31 * t1_19;
  const T v1_2 = sdot1_2 + R1_12 * t1_15 + R1_22 * t1_16 - R1_32 * t1_19;
  const T v1_3 = sdot1_3 + R1_13 * t1_15 + R1_23 * t1_16 - R1_33 * t1_19;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.5) * (omega1_1 * (t1_18 - t1_13 + T(0.6) * omega1_1) + omega1_2 * (T(0.02) * omega1_1 + T(0.5) *
      omega1_2 + T(0.03) * omega1_3) + omega1_3 * (t1_14 - t1_17 + T(0.7) * omega1_3)) + T(4) * (v1_1 * v1_1 + v1_2 *
      v1_2 + v1_3 * v1_3);

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_13 = R1_23 * T(0.1);
  const T t2_14 = s1_3 + t2_13;
  const T t2_15 = R1_13 * T(0.2);
  const T P2_3 = t2_14 + t2_15 - R1_33 * T(0.2);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_3 = P2_3 + R2_23 * T(0.02) - R2_33 * T(0.2);
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_16 = omega1_3 * T(0.2);
  const T t2_17 = t2_16 + omega1_1 * T(0.2);
  const T t2_18 = omega1_3 * T(0.1);
  const T t2_19 = omega1_2 * T(0.2);
  const T t2_20 = t2_18 + t2_19;
  const T t2_21 = omega1_1 * T(0.1);
  const T t2_22 = t2_21 - t2_19;
  const T Pdot2_1 = sdot1_1 + R1_21 * t2_17 - R1_11 * t2_20 + R1_31 * t2_22;
  const T Pdot2_2 = sdot1_2 + R1_22 * t2_17 - R1_12 * t2_20 + R1_32 * t2_22;
  const T Pdot2_3 = sdot1_3 + R1_23 * t2_17 - R1_13 * t2_20 + R1_33 * t2_22;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_23 = omega2_1 * T(0.2);
  const T t2_24 = omega2_3 * T(0.02) + omega2_2 * T(0.2);
  const T t2_25 = omega2_1 * T(0.02);
  const T v2_1 = Pdot2_1 + R2_21 * t2_23 - R2_11 * t2_24 + R2_31 * t2_25;
  const T v2_2 = Pdot2_2 + R2_22 * t2_23 - R2_12 * t2_24 + R2_32 * t2_25;
  const T v2_3 = Pdot2_3 + R2_23 * t2_23 - R2_13 * t2_24 + R2_33 * t2_25;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.5) * (T(0.01) * omega2_1 * omega2_1 + T(0.011) * omega2_2 * omega2_2 + T(0.004) * omega2_3 *
      omega2_3) + T(0.4) * (v2_1 * v2_1 + v2_2 * v2_2 + v2_3 * v2_3);

  // ---- body 3 (boom) on body 1
  const T theta3 = x[8];
  const T thetadot3 = y[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_11 * E3_31 + R1_21 * E3_32 + R1_31 * E3_33;
  const T R3_32 = R1_12 * E3_31 + R1_22 * E3_32 + R1_32 * E3_33;
  const T R3_33 = R1_13 * E3_31 + R1_23 * E3_32 + R1_33 * E3_33;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega1_1 + E3_12 * omega1_2 - minus_E3_13 * omega1_3 - thetadot3 * T(0.3152711589176631);
  const T omega3_2 = thetadot3 * T(0.44378789320576517) + E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = thetadot3 * T(0.8388422987658062) + E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_18 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_18 + R1_13 * T(0.3);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_3 = P3_3 + R3_13 * T(0.2) + R3_23 * T(0.02);
  // Pdot3 = sdot1 + R1^T omega1~ q3: velocity of the body origin, inertial axes [m/s]
  const T t3_19 = omega1_2 * T(0.1);
  const T t3_20 = omega1_3 * T(0.3);
  const T t3_21 = t3_20 - t2_21;
  const T t3_22 = omega1_2 * T(0.3);
  const T Pdot3_1 = sdot1_1 + R1_11 * t3_19 + R1_21 * t3_21 - R1_31 * t3_22;
  const T Pdot3_2 = sdot1_2 + R1_12 * t3_19 + R1_22 * t3_21 - R1_32 * t3_22;
  const T Pdot3_3 = sdot1_3 + R1_13 * t3_19 + R1_23 * t3_21 - R1_33 * t3_22;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_23 = omega3_3 * T(0.2);
  const T t3_24 = T(0.02) * omega3_3;
  const T t3_25 = omega3_1 * T(0.02) - omega3_2 * T(0.2);
  const T v3_1 = Pdot3_1 + R3_21 * t3_23 - R3_11 * t3_24 + R3_31 * t3_25;
  const T v3_2 = Pdot3_2 + R3_22 * t3_23 - R3_12 * t3_24 + R3_32 * t3_25;
  const T v3_3 = Pdot3_3 + R3_23 * t3_23 - R3_13 * t3_24 + R3_33 * t3_25;
  // T3 = 1/2 omega3 . (I3 omega3) + 1/2 m3 v3 . v3: kinetic energy [J]
  const T t3_26 = T(0.001) * omega3_1;
  const T T3 = T(0.5) * (omega3_1 * (T(0.04) * omega3_1 + T(0.002) * omega3_2 + T(0.001) * omega3_3) + omega3_2 *
      (T(0.002) * omega3_1 + T(0.05) * omega3_2 - T(0.003) * omega3_3) + omega3_3 * (t3_26 + t3_24 - T(0.003) *
      omega3_2)) + T(0.75) * (v3_1 * v3_1 + v3_2 * v3_2 + v3_3 * v3_3);
  // stretch_boom_3 = theta3 - l_boom_: stretch of the spring
  const T stretch_boom_3 = theta3 - T(0.2);

  // ---- body 4 (cross) on body 1
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // R4a^T = R1^T E4a^T: R takes inertial components to body components
  const T R4a_11 = R1_11 * E4a_11 - R1_21 * minus_E4a_12 - R1_31 * minus_E4a_13;
  const T R4a_12 = R1_12 * E4a_11 - R1_22 * minus_E4a_12 - R1_32 * minus_E4a_13;
  const T R4a_13 = R1_13 * E4a_11 - R1_23 * minus_E4a_12 - R1_33 * minus_E4a_13;
  const T R4a_21 = R1_11 * minus_E4a_12 + R1_21 * E4a_22 + R1_31 * E4a_23;
  const T R4a_22 = R1_12 * minus_E4a_12 + R1_22 * E4a_22 + R1_32 * E4a_23;
  const T R4a_23 = R1_13 * minus_E4a_12 + R1_23 * E4a_22 + R1_33 * E4a_23;
  const T R4a_31 = R1_11 * minus_E4a_13 + R1_21 * E4a_23 + R1_31 * E4a_33;
  const T R4a_32 = R1_12 * minus_E4a_13 + R1_22 * E4a_23 + R1_32 * E4a_33;
  const T R4a_33 = R1_13 * minus_E4a_13 + R1_23 * E4a_23 + R1_33 * E4a_33;
  // omega4a = thetadot4_1 b4_1 + E4a omega1: absolute angular velocity, body axes [rad/s]
  const T omega4a_1 = E4a_11 * omega1_1 - minus_E4a_12 * omega1_2 - minus_E4a_13 * omega1_3;
  const T omega4a_2 = thetadot4_1 * T(0.28) + minus_E4a_12 * omega1_1 + E4a_22 * omega1_2 + E4a_23 * omega1_3;
  const T omega4a_3 = minus_E4a_13 * omega1_1 + E4a_23 * omega1_2 + E4a_33 * omega1_3 - thetadot4_1 * T(0.96);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_3 = cosines[10];
  const T E4_12 = T(0.28) * t4_3;
  const T minus_E4_13 = T(0.96) * t4_3;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // R4^T = R4a^T E4^T: R takes inertial components to body components
  const T R4_11 = R4a_21 * E4_12 - R4a_11 * minus_E4_11 - R4a_31 * minus_E4_13;
  const T R4_12 = R4a_22 * E4_12 - R4a_12 * minus_E4_11 - R4a_32 * minus_E4_13;
  const T R4_13 = R4a_23 * E4_12 - R4a_13 * minus_E4_11 - R4a_33 * minus_E4_13;
  const T R4_21 = R4a_21 * T(0.96) + R4a_31 * T(0.28);
  const T R4_22 = R4a_22 * T(0.96) + R4a_32 * T(0.28);
  const T R4_23 = R4a_23 * T(0.96) + R4a_33 * T(0.28);
  const T R4_31 = R4a_11 * t4_3 + R4a_21 * E4_32 - R4a_31 * minus_E4_33;
  const T R4_32 = R4a_12 * t4_3 + R4a_22 * E4_32 - R4a_32 * minus_E4_33;
  const T R4_33 = R4a_13 * t4_3 + R4a_23 * E4_32 - R4a_33 * minus_E4_33;
  // omega4 = thetadot4_2 b4_2 + E4 omega4a: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega4a_2 - minus_E4_11 * omega4a_1 - minus_E4_13 * omega4a_3;
  const T omega4_2 = thetadot4_2 + T(0.96) * omega4a_2 + T(0.28) * omega4a_3;
  const T omega4_3 = t4_3 * omega4a_1 + E4_32 * omega4a_2 - minus_E4_33 * omega4a_3;
  // P4a = s1 + R1^T q4a: position of the body origin, inertial axes [m]
  const T P4a_3 = t2_14 - t2_15;
  // p4 = R4^T r4 + P4a: position of the mass centre, inertial axes [m]
  const T p4_3 = P4a_3 + R4_13 * T(0.03) + R4_33 * T(0.1);
  // Pdot4a = sdot1 + R1^T omega1~ q4a: velocity of the body origin, inertial axes [m/s]
  const T t4_4 = t2_21 + t2_19;
  const T Pdot4a_1 = sdot1_1 - R1_11 * t2_18 - R1_21 * t2_16 + R1_31 * t4_4;
  const T Pdot4a_2 = sdot1_2 - R1_12 * t2_18 - R1_22 * t2_16 + R1_32 * t4_4;
  const T Pdot4a_3 = sdot1_3 - R1_13 * t2_18 - R1_23 * t2_16 + R1_33 * t4_4;
  // v4 = R4^T omega4~ r4 + Pdot4a: velocity of the mass centre, inertial axes [m/s]
  const T t4_5 = omega4_2 * T(0.1);
  const T t4_6 = omega4_3 * T(0.03) - omega4_1 * T(0.1);
  const T t4_7 = omega4_2 * T(0.03);
  const T v4_1 = Pdot4a_1 + R4_11 * t4_5 + R4_21 * t4_6 - R4_31 * t4_7;
  const T v4_2 = Pdot4a_2 + R4_12 * t4_5 + R4_22 * t4_6 - R4_32 * t4_7;
  const T v4_3 = Pdot4a_3 + R4_13 * t4_5 + R4_23 * t4_6 - R4_33 * t4_7;
  // T4 = 1/2 omega4 . (I4 omega4) + 1/2 m4 v4 . v4: kinetic energy [J]
  const T T4 = T(0.5) * (T(0.008) * omega4_1 * omega4_1 + T(0.007) * omega4_2 * omega4_2 + T(0.012) * omega4_3 *
      omega4_3) + T(0.45) * (v4_1 * v4_1 + v4_2 * v4_2 + v4_3 * v4_3);

  // ---- body 5 (camera) on body 1
  const T s1_1 = x[19], s1_2 = x[20];
  const T thetadot5_1 = y[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T theta5_2 = c.p.amplitude * sin(t5_1);
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = s1_1 + R1_31 * T(0.1) - R1_21 * T(0.3);
  const T P5a_2 = s1_2 + R1_32 * T(0.1) - R1_22 * T(0.3);
  const T P5a_3 = t3_18 - R1_23 * T(0.3);
  // p5 = R5^T r_link5 + P5a: position of the mass centre, inertial axes [m]
  const T p5_3 = P5a_3 + R5a_13 * c.r_link5_1 + R5_33 * c.r_link5_3;
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_2 = t3_20 + t3_19;
  const T t5_3 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_2 - R1_21 * t2_21 - R1_31 * t5_3;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_2 - R1_22 * t2_21 - R1_32 * t5_3;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_2 - R1_23 * t2_21 - R1_33 * t5_3;
  // v5 = R5^T omega5~ r_link5 + Pdot5a: velocity of the mass centre, inertial axes [m/s]
  const T t5_4 = omega5_2 * c.r_link5_3;
  const T t5_5 = omega5_3 * c.r_link5_1 - omega5_1 * c.r_link5_3;
  const T t5_6 = omega5_2 * c.r_link5_1;
  const T v5_1 = Pdot5a_1 + R5a_11 * t5_4 + R5_21 * t5_5 - R5_31 * t5_6;
  const T v5_2 = Pdot5a_2 + R5a_12 * t5_4 + R5_22 * t5_5 - R5_32 * t5_6;
  const T v5_3 = Pdot5a_3 + R5a_13 * t5_4 + R5_23 * t5_5 - R5_33 * t5_6;
  // T5 = 1/2 omega5 . (I_link5 omega5) + 1/2 m_link5 v5 . v5: kinetic energy [J]
  const T T5 = T(0.5) * (omega5_1 * (c.I_link5_11 * omega5_1 + c.I_link5_13 * omega5_3) + c.I_link5_22 * omega5_2 *
      omega5_2 + omega5_3 * (c.I_link5_13 * omega5_1 + c.I_link5_33 * omega5_3)) + c.c5_1 * (v5_1 * v5_1 + v5_2 * v5_2
      + v5_3 * v5_3);

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // p6 = R3^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_3 = P6_3 + R3_13 * T(0.1) + R3_33 * T(0.01);
  // Pdot6 = R3^T (omega3~ d6 + sdot6 u6) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t6_1 = omega3_3 * d6_1;
  const T t6_2 = omega3_2 * d6_1;
  const T Pdot6_1 = Pdot3_1 + R3_11 * sdot6 + R3_21 * t6_1 - R3_31 * t6_2;
  const T Pdot6_2 = Pdot3_2 + R3_12 * sdot6 + R3_22 * t6_1 - R3_32 * t6_2;
  const T Pdot6_3 = Pdot3_3 + R3_13 * sdot6 + R3_23 * t6_1 - R3_33 * t6_2;
  // v6 = R3^T omega3~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_3 = omega3_2 * T(0.01);
  const T t6_4 = omega3_3 * T(0.1) - omega3_1 * T(0.01);
  const T t6_5 = omega3_2 * T(0.1);
  const T v6_1 = Pdot6_1 + R3_11 * t6_3 + R3_21 * t6_4 - R3_31 * t6_5;
  const T v6_2 = Pdot6_2 + R3_12 * t6_3 + R3_22 * t6_4 - R3_32 * t6_5;
  const T v6_3 = Pdot6_3 + R3_13 * t6_3 + R3_23 * t6_4 - R3_33 * t6_5;
  // T6 = 1/2 omega3 . (I6 omega3) + 1/2 m6 v6 . v6: kinetic energy [J]
  const T T6 = T(0.5) * (omega3_1 * t3_26 + T(0.006) * omega3_2 * omega3_2 + T(0.006) * omega3_3 * omega3_3) + T(0.25)
      * (v6_1 * v6_1 + v6_2 * v6_2 + v6_3 * v6_3);

  // ---- body 7 (gantry) on the inertial frame
  const T sdot7_1 = y[20], sdot7_2 = y[21];
  // T7 = 1/2 m7 Pdot7 . Pdot7: kinetic energy [J]
  const T T7 = T(1.5) * (sdot7_1 * sdot7_1 + sdot7_2 * sdot7_2);

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  const T thetadot8 = y[10];
  const T sdot8 = y[22];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // R8^T = R1^T E8^T: R takes inertial components to body components
  const T R8_11 = R1_11 * E8_11 + R1_31 * E8_13;
  const T R8_12 = R1_12 * E8_11 + R1_32 * E8_13;
  const T R8_13 = R1_13 * E8_11 + R1_33 * E8_13;
  const T R8_31 = R1_31 * E8_11 - R1_11 * E8_13;
  const T R8_32 = R1_32 * E8_11 - R1_12 * E8_13;
  const T R8_33 = R1_33 * E8_11 - R1_13 * E8_13;
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega1_1 + E8_13 * omega1_3;
  const T omega8_2 = omega1_2 - thetadot8;
  const T omega8_3 = E8_11 * omega1_3 - E8_13 * omega1_1;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // P8 = s1 + R1^T d8: position of the body origin, inertial axes [m]
  const T P8_3 = s1_3 + R1_23 * d8_2;
  // p8 = R8^T r_link8 + P8: position of the mass centre, inertial axes [m]
  const T p8_3 = P8_3 - t2_13 - R8_13 * T(0.01) + R8_33 * T(0.02);
  // Pdot8 = sdot1 + R1^T (omega1~ d8 + sdot8 u8): velocity of the body origin, inertial axes [m/s]
  const T t8_1 = omega1_3 * d8_2;
  const T t8_2 = omega1_1 * d8_2;
  const T Pdot8_1 = sdot1_1 - R1_11 * t8_1 - R1_21 * sdot8 + R1_31 * t8_2;
  const T Pdot8_2 = sdot1_2 - R1_12 * t8_1 - R1_22 * sdot8 + R1_32 * t8_2;
  const T Pdot8_3 = sdot1_3 - R1_13 * t8_1 - R1_23 * sdot8 + R1_33 * t8_2;
  // v8 = R8^T omega8~ r_link8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_3 = omega8_3 * T(0.1) + omega8_2 * T(0.02);
  const T t8_4 = omega8_3 * T(0.01) + omega8_1 * T(0.02);
  const T t8_5 = omega8_2 * T(0.01) - omega8_1 * T(0.1);
  const T v8_1 = Pdot8_1 + R8_11 * t8_3 - R1_21 * t8_4 + R8_31 * t8_5;
  const T v8_2 = Pdot8_2 + R8_12 * t8_3 - R1_22 * t8_4 + R8_32 * t8_5;
  const T v8_3 = Pdot8_3 + R8_13 * t8_3 - R1_23 * t8_4 + R8_33 * t8_5;
  // T8 = 1/2 omega8 . (I_link8 omega8) + 1/2 m8 v8 . v8: kinetic energy [J]
  const T T8 = T(0.5) * (T(0.003) * omega8_1 * omega8_1 + T(0.002) * omega8_2 * omega8_2 + T(0.004) * omega8_3 *
      omega8_3) + T(0.35) * (v8_1 * v8_1 + v8_2 * v8_2 + v8_3 * v8_3);

  // ---- body 9 (sled) on the inertial frame
  const T s9_1 = x[26], s9_2 = x[27];
  const T thetadot9 = y[11];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // v9 = E9^T omega9~ r9 + Pdot9: velocity of the mass centre, inertial axes [m/s]
  const T t9_1 = thetadot9 * T(0.1);
  const T v9_1 = sdot9_1 - E9_12 * t9_1;
  const T v9_2 = sdot9_2 + E9_11 * t9_1;
  // T9 = 1/2 omega9 . (I9 omega9) + 1/2 m9 v9 . v9: kinetic energy [J]
  const T T9 = T(0.08) * thetadot9 * thetadot9 * T(0.5) + v9_1 * v9_1 + v9_2 * v9_2;
  // line_tether_9 = -R5^T C12^T r_tether_ - R5^T o5 + E9^T r_tether_other_ - P5a + d9: from one end of the spring to
  //   the other, inertial axes [m]
  const T line_tether_9_1 = s9_1 - P5a_1 + E9_11 * T(0.1) - R5_21 * T(0.02) - T(0.03620228586010676) * R5a_11 -
      T(0.06743336618301184) * R5_31;
  const T line_tether_9_2 = d9_2 - P5a_2 + E9_12 * T(0.1) - R5_22 * T(0.02) - T(0.03620228586010676) * R5a_12 -
      T(0.06743336618301184) * R5_32;
  const T line_tether_9_3 = T(0.1) - P5a_3 - R5_23 * T(0.02) - T(0.03620228586010676) * R5a_13 -
      T(0.06743336618301184) * R5_33;
  // ll_tether_9 = 1e-36 + line_tether_9 . line_tether_9: length squared [m^2]
  const T ll_tether_9 = T(1e-36) + line_tether_9_1 * line_tether_9_1 + line_tether_9_2 * line_tether_9_2 +
      line_tether_9_3 * line_tether_9_3;
  // length_tether_9 = ll_tether_9^1/2: length [m]
  const T length_tether_9 = sqrt(ll_tether_9);
  // stretch_tether_9 = length_tether_9 - l_tether_: stretch of the spring
  const T stretch_tether_9 = length_tether_9 - T(0.3);

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  const T omega10_1 = y[12], omega10_2 = y[13], omega10_3 = y[14];
  const T sdot10 = y[25];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // P10 = s1 + R1^T d10: position of the body origin, inertial axes [m]
  const T P10_3 = s1_3 + R1_13 * T(0.1) + R1_23 * s10 + R1_33 * T(0.3);
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_3 = P10_3 + R10_13 * T(0.02) + R10_23 * T(0.01) - R10_33 * T(0.03);
  // Pdot10 = sdot1 + R1^T (omega1~ d10 + sdot10 u10): velocity of the body origin, inertial axes [m/s]
  const T t10_13 = t3_22 - omega1_3 * s10;
  const T t10_14 = t2_18 - t5_3 + sdot10;
  const T t10_15 = omega1_1 * s10 - t3_19;
  const T Pdot10_1 = sdot1_1 + R1_11 * t10_13 + R1_21 * t10_14 + R1_31 * t10_15;
  const T Pdot10_2 = sdot1_2 + R1_12 * t10_13 + R1_22 * t10_14 + R1_32 * t10_15;
  const T Pdot10_3 = sdot1_3 + R1_13 * t10_13 + R1_23 * t10_14 + R1_33 * t10_15;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_16 = omega10_3 * T(0.02) + omega10_1 * T(0.03);
  const T t10_17 = omega10_3 * T(0.01) + omega10_2 * T(0.03);
  const T t10_18 = omega10_1 * T(0.01) - omega10_2 * T(0.02);
  const T v10_1 = Pdot10_1 + R10_21 * t10_16 - R10_11 * t10_17 + R10_31 * t10_18;
  const T v10_2 = Pdot10_2 + R10_22 * t10_16 - R10_12 * t10_17 + R10_32 * t10_18;
  const T v10_3 = Pdot10_3 + R10_23 * t10_16 - R10_13 * t10_17 + R10_33 * t10_18;
  // T10 = 1/2 omega10 . (I10 omega10) + 1/2 m10 v10 . v10: kinetic energy [J]
  const T T10 = T(0.5) * (T(0.002) * omega10_1 * omega10_1 + T(0.003) * omega10_2 * omega10_2 + T(0.0025) * omega10_3
      * omega10_3) + T(0.2) * (v10_1 * v10_1 + v10_2 * v10_2 + v10_3 * v10_3);

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  const T thetadot11 = y[15];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // R11^T = R8^T E11^T: R takes inertial components to body components
  const T R11_11 = R8_11 * E11_11 + R8_31 * E11_13;
  const T R11_12 = R8_12 * E11_11 + R8_32 * E11_13;
  const T R11_13 = R8_13 * E11_11 + R8_33 * E11_13;
  const T R11_33 = R8_33 * E11_11 - R8_13 * E11_13;
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega8_1 + E11_13 * omega8_3;
  const T omega11_2 = omega8_2 - thetadot11;
  const T omega11_3 = E11_11 * omega8_3 - E11_13 * omega8_1;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // P11 = R8^T d11 + P8: position of the body origin, inertial axes [m]
  const T P11_3 = P8_3 - R1_23 * minus_d11_2;
  // p11 = R11^T r_link11 + P11: position of the mass centre, inertial axes [m]
  const T p11_3 = P11_3 + R11_33 * T(0.01);
  // Pdot11 = R8^T (omega8~ d11 + thetadot11 pitch11 u11) + Pdot8: velocity of the body origin, inertial axes [m/s]
  const T t11_1 = omega8_3 * minus_d11_2;
  const T t11_2 = thetadot11 * T(0.01);
  const T t11_3 = omega8_1 * minus_d11_2;
  const T Pdot11_1 = Pdot8_1 + R8_11 * t11_1 - R1_21 * t11_2 - R8_31 * t11_3;
  const T Pdot11_2 = Pdot8_2 + R8_12 * t11_1 - R1_22 * t11_2 - R8_32 * t11_3;
  const T Pdot11_3 = Pdot8_3 + R8_13 * t11_1 - R1_23 * t11_2 - R8_33 * t11_3;
  // v11 = R11^T omega11~ r_link11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_4 = omega11_2 * T(0.01);
  const T t11_5 = omega11_1 * T(0.01);
  const T v11_1 = Pdot11_1 + R11_11 * t11_4 - R1_21 * t11_5;
  const T v11_2 = Pdot11_2 + R11_12 * t11_4 - R1_22 * t11_5;
  const T v11_3 = Pdot11_3 + R11_13 * t11_4 - R1_23 * t11_5;
  // T11 = 1/2 omega11 . (I_link11 omega11) + 1/2 m11 v11 . v11: kinetic energy [J]
  const T T11 = T(0.5) * (T(4e-04) * omega11_1 * omega11_1 + T(6e-04) * omega11_2 * omega11_2 + T(4e-04) * omega11_3 *
      omega11_3) + T(0.15) * (v11_1 * v11_1 + v11_2 * v11_2 + v11_3 * v11_3);

  // ---- body 13 (ballast) on the inertial frame
  const T sdot13_1 = y[26], sdot13_2 = y[27], sdot13_3 = y[28];
  // T13 = 1/2 sdot13 . sdot13 m13: kinetic energy [J]
  const T T13 = T(0.5) * (sdot13_1 * sdot13_1 + sdot13_2 * sdot13_2 + sdot13_3 * sdot13_3) * T(5);

  // ---- whole system
  const T s13_3 = x[31];
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T13: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T8 + T9 + T10 + T11 + T7 + T13;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m6 p6 + m7 p7 + m8 p8 + m9 p9 + m10 p10 + m11 p11 + m13 d13 + m_link5 p5:
  //   first moment of mass, inertial axes [kg m]
  const T mp_3 = T(2.7) + T(8) * p1_3 + T(0.8) * p2_3 + T(1.5) * p3_3 + T(0.9) * p4_3 + T(0.5) * p6_3 + T(0.7) * p8_3
      + T(0.4) * p10_3 + T(0.3) * p11_3 + T(5) * s13_3 + c.m_link5 * p5_3;
  // potential = -g . mp + 1/2 k_boom_ stretch_boom_3^2 + 1/2 k_tether_ stretch_tether_9^2 + 1/2 k_soft_mount_
  //   stretch_soft_mount_7^2: potential energy of gravity and springs [J]
  const T potential = T(0.5000000000000003) + T(9.81) * mp_3 + stretch_boom_3 * stretch_boom_3 * c.c0_1 +
      stretch_tether_9 * stretch_tether_9 * c.c0_1;
  energy[1] = potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 651 add, 783 multiply, 18 sine or cosine
template <class T>
void momentum(const Prepared<T>& c, T t, const T* x, const T* y, T* momentum) noexcept {
  using std::cos, std::sin;
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
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
  const T p1_1 = s1_1 + R1_11 * T(0.02) - R1_21 * T(0.01) + R1_31 * T(0.03);
  const T p1_2 = s1_2 + R1_12 * T(0.02) - R1_22 * T(0.01) + R1_32 * T(0.03);
  const T p1_3 = s1_3 + R1_13 * T(0.02) - R1_23 * T(0.01) + R1_33 * T(0.03);
  // v1 = sdot1 + R1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_13 = T(0.01) * omega1_3;
  const T t1_14 = T(0.03) * omega1_2;
  const T t1_15 = t1_13 + t1_14;
  const T t1_16 = omega1_3 * T(0.02) - omega1_1 * T(0.03);
  const T t1_17 = T(0.01) * omega1_1;
  const T t1_18 = T(0.02) * omega1_2;
  const T t1_19 = t1_17 + t1_18;
  const T v1_1 = sdot1_1 + R1_11 * t1_15 + R1_21 * t1_16 - R1_31 * t1_19;
  const T v1_2 = sdot1_2 + R1_12 * t1_15 + R1_22 * t1_16 - R1_32 * t1_19;
  const T v1_3 = sdot1_3 + R1_13 * t1_15 + R1_23 * t1_16 - R1_33 * t1_19;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T l1_1 = T(8) * v1_1;
  const T l1_2 = T(8) * v1_2;
  const T l1_3 = T(8) * v1_3;
  // H1 = R1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t1_20 = t1_18 - t1_13 + T(0.6) * omega1_1;
  const T t1_21 = T(0.02) * omega1_1 + T(0.5) * omega1_2 + T(0.03) * omega1_3;
  const T t1_22 = t1_14 - t1_17 + T(0.7) * omega1_3;
  const T H1_1 = R1_11 * t1_20 + R1_21 * t1_21 + R1_31 * t1_22 + p1_2 * l1_3 - p1_3 * l1_2;
  const T H1_2 = R1_12 * t1_20 + R1_22 * t1_21 + R1_32 * t1_22 + p1_3 * l1_1 - p1_1 * l1_3;
  const T H1_3 = R1_13 * t1_20 + R1_23 * t1_21 + R1_33 * t1_22 + p1_1 * l1_2 - p1_2 * l1_1;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T t2_13 = R1_21 * T(0.1);
  const T t2_14 = s1_1 + t2_13;
  const T t2_15 = R1_11 * T(0.2);
  const T P2_1 = t2_14 + t2_15 - R1_31 * T(0.2);
  const T t2_16 = R1_22 * T(0.1);
  const T t2_17 = s1_2 + t2_16;
  const T t2_18 = R1_12 * T(0.2);
  const T P2_2 = t2_17 + t2_18 - R1_32 * T(0.2);
  const T t2_19 = R1_23 * T(0.1);
  const T t2_20 = s1_3 + t2_19;
  const T t2_21 = R1_13 * T(0.2);
  const T P2_3 = t2_20 + t2_21 - R1_33 * T(0.2);
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T p2_1 = P2_1 + R2_21 * T(0.02) - R2_31 * T(0.2);
  const T p2_2 = P2_2 + R2_22 * T(0.02) - R2_32 * T(0.2);
  const T p2_3 = P2_3 + R2_23 * T(0.02) - R2_33 * T(0.2);
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_22 = omega1_3 * T(0.2);
  const T t2_23 = t2_22 + omega1_1 * T(0.2);
  const T t2_24 = omega1_3 * T(0.1);
  const T t2_25 = omega1_2 * T(0.2);
  const T t2_26 = t2_24 + t2_25;
  const T t2_27 = omega1_1 * T(0.1);
  const T t2_28 = t2_27 - t2_25;
  const T Pdot2_1 = sdot1_1 + R1_21 * t2_23 - R1_11 * t2_26 + R1_31 * t2_28;
  const T Pdot2_2 = sdot1_2 + R1_22 * t2_23 - R1_12 * t2_26 + R1_32 * t2_28;
  const T Pdot2_3 = sdot1_3 + R1_23 * t2_23 - R1_13 * t2_26 + R1_33 * t2_28;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_29 = omega2_1 * T(0.2);
  const T t2_30 = omega2_3 * T(0.02) + omega2_2 * T(0.2);
  const T t2_31 = omega2_1 * T(0.02);
  const T v2_1 = Pdot2_1 + R2_21 * t2_29 - R2_11 * t2_30 + R2_31 * t2_31;
  const T v2_2 = Pdot2_2 + R2_22 * t2_29 - R2_12 * t2_30 + R2_32 * t2_31;
  const T v2_3 = Pdot2_3 + R2_23 * t2_29 - R2_13 * t2_30 + R2_33 * t2_31;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T l2_1 = T(0.8) * v2_1;
  const T l2_2 = T(0.8) * v2_2;
  const T l2_3 = T(0.8) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t2_32 = T(0.01) * omega2_1;
  const T t2_33 = T(0.011) * omega2_2;
  const T t2_34 = T(0.004) * omega2_3;
  const T H2_1 = R2_11 * t2_32 + R2_21 * t2_33 + R2_31 * t2_34 + p2_2 * l2_3 - p2_3 * l2_2;
  const T H2_2 = R2_12 * t2_32 + R2_22 * t2_33 + R2_32 * t2_34 + p2_3 * l2_1 - p2_1 * l2_3;
  const T H2_3 = R2_13 * t2_32 + R2_23 * t2_33 + R2_33 * t2_34 + p2_1 * l2_2 - p2_2 * l2_1;

  // ---- body 3 (boom) on body 1
  const T thetadot3 = y[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_11 * E3_31 + R1_21 * E3_32 + R1_31 * E3_33;
  const T R3_32 = R1_12 * E3_31 + R1_22 * E3_32 + R1_32 * E3_33;
  const T R3_33 = R1_13 * E3_31 + R1_23 * E3_32 + R1_33 * E3_33;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega1_1 + E3_12 * omega1_2 - minus_E3_13 * omega1_3 - thetadot3 * T(0.3152711589176631);
  const T omega3_2 = thetadot3 * T(0.44378789320576517) + E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = thetadot3 * T(0.8388422987658062) + E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_18 = s1_1 + R1_31 * T(0.1);
  const T P3_1 = t3_18 + R1_11 * T(0.3);
  const T t3_19 = s1_2 + R1_32 * T(0.1);
  const T P3_2 = t3_19 + R1_12 * T(0.3);
  const T t3_20 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_20 + R1_13 * T(0.3);
  // p3 = R3^T r3 + P3: position of the mass centre, inertial axes [m]
  const T p3_1 = P3_1 + R3_11 * T(0.2) + R3_21 * T(0.02);
  const T p3_2 = P3_2 + R3_12 * T(0.2) + R3_22 * T(0.02);
  const T p3_3 = P3_3 + R3_13 * T(0.2) + R3_23 * T(0.02);
  // Pdot3 = sdot1 + R1^T omega1~ q3: velocity of the body origin, inertial axes [m/s]
  const T t3_21 = omega1_2 * T(0.1);
  const T t3_22 = omega1_3 * T(0.3);
  const T t3_23 = t3_22 - t2_27;
  const T t3_24 = omega1_2 * T(0.3);
  const T Pdot3_1 = sdot1_1 + R1_11 * t3_21 + R1_21 * t3_23 - R1_31 * t3_24;
  const T Pdot3_2 = sdot1_2 + R1_12 * t3_21 + R1_22 * t3_23 - R1_32 * t3_24;
  const T Pdot3_3 = sdot1_3 + R1_13 * t3_21 + R1_23 * t3_23 - R1_33 * t3_24;
  // v3 = R3^T omega3~ r3 + Pdot3: velocity of the mass centre, inertial axes [m/s]
  const T t3_25 = omega3_3 * T(0.2);
  const T t3_26 = T(0.02) * omega3_3;
  const T t3_27 = omega3_1 * T(0.02) - omega3_2 * T(0.2);
  const T v3_1 = Pdot3_1 + R3_21 * t3_25 - R3_11 * t3_26 + R3_31 * t3_27;
  const T v3_2 = Pdot3_2 + R3_22 * t3_25 - R3_12 * t3_26 + R3_32 * t3_27;
  const T v3_3 = Pdot3_3 + R3_23 * t3_25 - R3_13 * t3_26 + R3_33 * t3_27;
  // l3 = m3 v3: linear momentum, inertial axes [kg m/s]
  const T l3_1 = T(1.5) * v3_1;
  const T l3_2 = T(1.5) * v3_2;
  const T l3_3 = T(1.5) * v3_3;
  // H3 = R3^T I3 omega3 + p3~ l3: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t3_28 = T(0.04) * omega3_1 + T(0.002) * omega3_2 + T(0.001) * omega3_3;
  const T t3_29 = T(0.002) * omega3_1 + T(0.05) * omega3_2 - T(0.003) * omega3_3;
  const T t3_30 = T(0.001) * omega3_1;
  const T t3_31 = t3_30 + t3_26 - T(0.003) * omega3_2;
  const T H3_1 = R3_11 * t3_28 + R3_21 * t3_29 + R3_31 * t3_31 + p3_2 * l3_3 - p3_3 * l3_2;
  const T H3_2 = R3_12 * t3_28 + R3_22 * t3_29 + R3_32 * t3_31 + p3_3 * l3_1 - p3_1 * l3_3;
  const T H3_3 = R3_13 * t3_28 + R3_23 * t3_29 + R3_33 * t3_31 + p3_1 * l3_2 - p3_2 * l3_1;

  // ---- body 4 (cross) on body 1
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // R4a^T = R1^T E4a^T: R takes inertial components to body components
  const T R4a_11 = R1_11 * E4a_11 - R1_21 * minus_E4a_12 - R1_31 * minus_E4a_13;
  const T R4a_12 = R1_12 * E4a_11 - R1_22 * minus_E4a_12 - R1_32 * minus_E4a_13;
  const T R4a_13 = R1_13 * E4a_11 - R1_23 * minus_E4a_12 - R1_33 * minus_E4a_13;
  const T R4a_21 = R1_11 * minus_E4a_12 + R1_21 * E4a_22 + R1_31 * E4a_23;
  const T R4a_22 = R1_12 * minus_E4a_12 + R1_22 * E4a_22 + R1_32 * E4a_23;
  const T R4a_23 = R1_13 * minus_E4a_12 + R1_23 * E4a_22 + R1_33 * E4a_23;
  const T R4a_31 = R1_11 * minus_E4a_13 + R1_21 * E4a_23 + R1_31 * E4a_33;
  const T R4a_32 = R1_12 * minus_E4a_13 + R1_22 * E4a_23 + R1_32 * E4a_33;
  const T R4a_33 = R1_13 * minus_E4a_13 + R1_23 * E4a_23 + R1_33 * E4a_33;
  // omega4a = thetadot4_1 b4_1 + E4a omega1: absolute angular velocity, body axes [rad/s]
  const T omega4a_1 = E4a_11 * omega1_1 - minus_E4a_12 * omega1_2 - minus_E4a_13 * omega1_3;
  const T omega4a_2 = thetadot4_1 * T(0.28) + minus_E4a_12 * omega1_1 + E4a_22 * omega1_2 + E4a_23 * omega1_3;
  const T omega4a_3 = minus_E4a_13 * omega1_1 + E4a_23 * omega1_2 + E4a_33 * omega1_3 - thetadot4_1 * T(0.96);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_3 = cosines[10];
  const T E4_12 = T(0.28) * t4_3;
  const T minus_E4_13 = T(0.96) * t4_3;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // R4^T = R4a^T E4^T: R takes inertial components to body components
  const T R4_11 = R4a_21 * E4_12 - R4a_11 * minus_E4_11 - R4a_31 * minus_E4_13;
  const T R4_12 = R4a_22 * E4_12 - R4a_12 * minus_E4_11 - R4a_32 * minus_E4_13;
  const T R4_13 = R4a_23 * E4_12 - R4a_13 * minus_E4_11 - R4a_33 * minus_E4_13;
  const T R4_21 = R4a_21 * T(0.96) + R4a_31 * T(0.28);
  const T R4_22 = R4a_22 * T(0.96) + R4a_32 * T(0.28);
  const T R4_23 = R4a_23 * T(0.96) + R4a_33 * T(0.28);
  const T R4_31 = R4a_11 * t4_3 + R4a_21 * E4_32 - R4a_31 * minus_E4_33;
  const T R4_32 = R4a_12 * t4_3 + R4a_22 * E4_32 - R4a_32 * minus_E4_33;
  const T R4_33 = R4a_13 * t4_3 + R4a_23 * E4_32 - R4a_33 * minus_E4_33;
  // omega4 = thetadot4_2 b4_2 + E4 omega4a: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega4a_2 - minus_E4_11 * omega4a_1 - minus_E4_13 * omega4a_3;
  const T omega4_2 = thetadot4_2 + T(0.96) * omega4a_2 + T(0.28) * omega4a_3;
  const T omega4_3 = t4_3 * omega4a_1 + E4_32 * omega4a_2 - minus_E4_33 * omega4a_3;
  // P4a = s1 + R1^T q4a: position of the body origin, inertial axes [m]
  const T P4a_1 = t2_14 - t2_15;
  const T P4a_2 = t2_17 - t2_18;
  const T P4a_3 = t2_20 - t2_21;
  // p4 = R4^T r4 + P4a: position of the mass centre, inertial axes [m]
  const T p4_1 = P4a_1 + R4_11 * T(0.03) + R4_31 * T(0.1);
  const T p4_2 = P4a_2 + R4_12 * T(0.03) + R4_32 * T(0.1);
  const T p4_3 = P4a_3 + R4_13 * T(0.03) + R4_33 * T(0.1);
  // Pdot4a = sdot1 + R1^T omega1~ q4a: velocity of the body origin, inertial axes [m/s]
  const T t4_4 = t2_27 + t2_25;
  const T Pdot4a_1 = sdot1_1 - R1_11 * t2_24 - R1_21 * t2_22 + R1_31 * t4_4;
  const T Pdot4a_2 = sdot1_2 - R1_12 * t2_24 - R1_22 * t2_22 + R1_32 * t4_4;
  const T Pdot4a_3 = sdot1_3 - R1_13 * t2_24 - R1_23 * t2_22 + R1_33 * t4_4;
  // v4 = R4^T omega4~ r4 + Pdot4a: velocity of the mass centre, inertial axes [m/s]
  const T t4_5 = omega4_2 * T(0.1);
  const T t4_6 = omega4_3 * T(0.03) - omega4_1 * T(0.1);
  const T t4_7 = omega4_2 * T(0.03);
  const T v4_1 = Pdot4a_1 + R4_11 * t4_5 + R4_21 * t4_6 - R4_31 * t4_7;
  const T v4_2 = Pdot4a_2 + R4_12 * t4_5 + R4_22 * t4_6 - R4_32 * t4_7;
  const T v4_3 = Pdot4a_3 + R4_13 * t4_5 + R4_23 * t4_6 - R4_33 * t4_7;
  // l4 = m4 v4: linear momentum, inertial axes [kg m/s]
  const T l4_1 = T(0.9) * v4_1;
  const T l4_2 = T(0.9) * v4_2;
  const T l4_3 = T(0.9) * v4_3;
  // H4 = R4^T I4 omega4 + p4~ l4: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t4_8 = T(0.008) * omega4_1;
  const T t4_9 = T(0.007) * omega4_2;
  const T t4_10 = T(0.012) * omega4_3;
  const T H4_1 = R4_11 * t4_8 + R4_21 * t4_9 + R4_31 * t4_10 + p4_2 * l4_3 - p4_3 * l4_2;
  const T H4_2 = R4_12 * t4_8 + R4_22 * t4_9 + R4_32 * t4_10 + p4_3 * l4_1 - p4_1 * l4_3;
  const T H4_3 = R4_13 * t4_8 + R4_23 * t4_9 + R4_33 * t4_10 + p4_1 * l4_2 - p4_2 * l4_1;

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T theta5_2 = c.p.amplitude * sin(t5_1);
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = t3_18 - R1_21 * T(0.3);
  const T P5a_2 = t3_19 - R1_22 * T(0.3);
  const T P5a_3 = t3_20 - R1_23 * T(0.3);
  // p5 = R5^T r_link5 + P5a: position of the mass centre, inertial axes [m]
  const T p5_1 = P5a_1 + R5a_11 * c.r_link5_1 + R5_31 * c.r_link5_3;
  const T p5_2 = P5a_2 + R5a_12 * c.r_link5_1 + R5_32 * c.r_link5_3;
  const T p5_3 = P5a_3 + R5a_13 * c.r_link5_1 + R5_33 * c.r_link5_3;
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_2 = t3_22 + t3_21;
  const T t5_3 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_2 - R1_21 * t2_27 - R1_31 * t5_3;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_2 - R1_22 * t2_27 - R1_32 * t5_3;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_2 - R1_23 * t2_27 - R1_33 * t5_3;
  // v5 = R5^T omega5~ r_link5 + Pdot5a: velocity of the mass centre, inertial axes [m/s]
  const T t5_4 = omega5_2 * c.r_link5_3;
  const T t5_5 = omega5_3 * c.r_link5_1 - omega5_1 * c.r_link5_3;
  const T t5_6 = omega5_2 * c.r_link5_1;
  const T v5_1 = Pdot5a_1 + R5a_11 * t5_4 + R5_21 * t5_5 - R5_31 * t5_6;
  const T v5_2 = Pdot5a_2 + R5a_12 * t5_4 + R5_22 * t5_5 - R5_32 * t5_6;
  const T v5_3 = Pdot5a_3 + R5a_13 * t5_4 + R5_23 * t5_5 - R5_33 * t5_6;
  // l5 = m_link5 v5: linear momentum, inertial axes [kg m/s]
  const T l5_1 = c.m_link5 * v5_1;
  const T l5_2 = c.m_link5 * v5_2;
  const T l5_3 = c.m_link5 * v5_3;
  // H5 = R5^T I_link5 omega5 + p5~ l5: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t5_7 = c.I_link5_11 * omega5_1 + c.I_link5_13 * omega5_3;
  const T t5_8 = c.I_link5_22 * omega5_2;
  const T t5_9 = c.I_link5_13 * omega5_1 + c.I_link5_33 * omega5_3;
  const T H5_1 = R5a_11 * t5_7 + R5_21 * t5_8 + R5_31 * t5_9 + p5_2 * l5_3 - p5_3 * l5_2;
  const T H5_2 = R5a_12 * t5_7 + R5_22 * t5_8 + R5_32 * t5_9 + p5_3 * l5_1 - p5_1 * l5_3;
  const T H5_3 = R5a_13 * t5_7 + R5_23 * t5_8 + R5_33 * t5_9 + p5_1 * l5_2 - p5_2 * l5_1;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_1 = P3_1 + R3_11 * d6_1;
  const T P6_2 = P3_2 + R3_12 * d6_1;
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // p6 = R3^T r6 + P6: position of the mass centre, inertial axes [m]
  const T p6_1 = P6_1 + R3_11 * T(0.1) + R3_31 * T(0.01);
  const T p6_2 = P6_2 + R3_12 * T(0.1) + R3_32 * T(0.01);
  const T p6_3 = P6_3 + R3_13 * T(0.1) + R3_33 * T(0.01);
  // Pdot6 = R3^T (omega3~ d6 + sdot6 u6) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t6_1 = omega3_3 * d6_1;
  const T t6_2 = omega3_2 * d6_1;
  const T Pdot6_1 = Pdot3_1 + R3_11 * sdot6 + R3_21 * t6_1 - R3_31 * t6_2;
  const T Pdot6_2 = Pdot3_2 + R3_12 * sdot6 + R3_22 * t6_1 - R3_32 * t6_2;
  const T Pdot6_3 = Pdot3_3 + R3_13 * sdot6 + R3_23 * t6_1 - R3_33 * t6_2;
  // v6 = R3^T omega3~ r6 + Pdot6: velocity of the mass centre, inertial axes [m/s]
  const T t6_3 = omega3_2 * T(0.01);
  const T t6_4 = omega3_3 * T(0.1) - omega3_1 * T(0.01);
  const T t6_5 = omega3_2 * T(0.1);
  const T v6_1 = Pdot6_1 + R3_11 * t6_3 + R3_21 * t6_4 - R3_31 * t6_5;
  const T v6_2 = Pdot6_2 + R3_12 * t6_3 + R3_22 * t6_4 - R3_32 * t6_5;
  const T v6_3 = Pdot6_3 + R3_13 * t6_3 + R3_23 * t6_4 - R3_33 * t6_5;
  // l6 = m6 v6: linear momentum, inertial axes [kg m/s]
  const T l6_1 = T(0.5) * v6_1;
  const T l6_2 = T(0.5) * v6_2;
  const T l6_3 = T(0.5) * v6_3;
  // H6 = R3^T I6 omega3 + p6~ l6: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t6_6 = T(0.006) * omega3_2;
  const T t6_7 = T(0.006) * omega3_3;
  const T H6_1 = R3_11 * t3_30 + R3_21 * t6_6 + R3_31 * t6_7 + p6_2 * l6_3 - p6_3 * l6_2;
  const T H6_2 = R3_12 * t3_30 + R3_22 * t6_6 + R3_32 * t6_7 + p6_3 * l6_1 - p6_1 * l6_3;
  const T H6_3 = R3_13 * t3_30 + R3_23 * t6_6 + R3_33 * t6_7 + p6_1 * l6_2 - p6_2 * l6_1;

  // ---- body 7 (gantry) on the inertial frame
  const T s7_1 = x[23], s7_2 = x[24];
  const T sdot7_1 = y[20], sdot7_2 = y[21];
  // d7 = q7 + s7_1 u7_1 + s7_2 u7_2: joint offset q + s, axes of the lower body [m]
  const T d7_1 = T(2) + s7_1;
  // p7 = r7 + d7: position of the mass centre, inertial axes [m]
  const T p7_2 = T(0.1) + s7_2;
  // l7 = m7 Pdot7: linear momentum, inertial axes [kg m/s]
  const T l7_1 = T(3) * sdot7_1;
  const T l7_2 = T(3) * sdot7_2;
  // H7 = p7~ l7: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T minus_H7_1 = T(0.9) * l7_2;
  const T H7_2 = T(0.9) * l7_1;
  const T H7_3 = d7_1 * l7_2 - p7_2 * l7_1;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  const T thetadot8 = y[10];
  const T sdot8 = y[22];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // R8^T = R1^T E8^T: R takes inertial components to body components
  const T R8_11 = R1_11 * E8_11 + R1_31 * E8_13;
  const T R8_12 = R1_12 * E8_11 + R1_32 * E8_13;
  const T R8_13 = R1_13 * E8_11 + R1_33 * E8_13;
  const T R8_31 = R1_31 * E8_11 - R1_11 * E8_13;
  const T R8_32 = R1_32 * E8_11 - R1_12 * E8_13;
  const T R8_33 = R1_33 * E8_11 - R1_13 * E8_13;
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega1_1 + E8_13 * omega1_3;
  const T omega8_2 = omega1_2 - thetadot8;
  const T omega8_3 = E8_11 * omega1_3 - E8_13 * omega1_1;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // P8 = s1 + R1^T d8: position of the body origin, inertial axes [m]
  const T P8_1 = s1_1 + R1_21 * d8_2;
  const T P8_2 = s1_2 + R1_22 * d8_2;
  const T P8_3 = s1_3 + R1_23 * d8_2;
  // p8 = R8^T r_link8 + P8: position of the mass centre, inertial axes [m]
  const T p8_1 = P8_1 - t2_13 - R8_11 * T(0.01) + R8_31 * T(0.02);
  const T p8_2 = P8_2 - t2_16 - R8_12 * T(0.01) + R8_32 * T(0.02);
  const T p8_3 = P8_3 - t2_19 - R8_13 * T(0.01) + R8_33 * T(0.02);
  // Pdot8 = sdot1 + R1^T (omega1~ d8 + sdot8 u8): velocity of the body origin, inertial axes [m/s]
  const T t8_1 = omega1_3 * d8_2;
  const T t8_2 = omega1_1 * d8_2;
  const T Pdot8_1 = sdot1_1 - R1_11 * t8_1 - R1_21 * sdot8 + R1_31 * t8_2;
  const T Pdot8_2 = sdot1_2 - R1_12 * t8_1 - R1_22 * sdot8 + R1_32 * t8_2;
  const T Pdot8_3 = sdot1_3 - R1_13 * t8_1 - R1_23 * sdot8 + R1_33 * t8_2;
  // v8 = R8^T omega8~ r_link8 + Pdot8: velocity of the mass centre, inertial axes [m/s]
  const T t8_3 = omega8_3 * T(0.1) + omega8_2 * T(0.02);
  const T t8_4 = omega8_3 * T(0.01) + omega8_1 * T(0.02);
  const T t8_5 = omega8_2 * T(0.01) - omega8_1 * T(0.1);
  const T v8_1 = Pdot8_1 + R8_11 * t8_3 - R1_21 * t8_4 + R8_31 * t8_5;
  const T v8_2 = Pdot8_2 + R8_12 * t8_3 - R1_22 * t8_4 + R8_32 * t8_5;
  const T v8_3 = Pdot8_3 + R8_13 * t8_3 - R1_23 * t8_4 + R8_33 * t8_5;
  // l8 = m8 v8: linear momentum, inertial axes [kg m/s]
  const T l8_1 = T(0.7) * v8_1;
  const T l8_2 = T(0.7) * v8_2;
  const T l8_3 = T(0.7) * v8_3;
  // H8 = R8^T I_link8 omega8 + p8~ l8: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t8_6 = T(0.003) * omega8_1;
  const T t8_7 = T(0.002) * omega8_2;
  const T t8_8 = T(0.004) * omega8_3;
  const T H8_1 = R8_11 * t8_6 + R1_21 * t8_7 + R8_31 * t8_8 + p8_2 * l8_3 - p8_3 * l8_2;
  const T H8_2 = R8_12 * t8_6 + R1_22 * t8_7 + R8_32 * t8_8 + p8_3 * l8_1 - p8_1 * l8_3;
  const T H8_3 = R8_13 * t8_6 + R1_23 * t8_7 + R8_33 * t8_8 + p8_1 * l8_2 - p8_2 * l8_1;

  // ---- body 9 (sled) on the inertial frame
  const T s9_1 = x[26], s9_2 = x[27];
  const T thetadot9 = y[11];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // p9 = E9^T r9 + d9: position of the mass centre, inertial axes [m]
  const T p9_1 = s9_1 + E9_11 * T(0.1);
  const T p9_2 = d9_2 + E9_12 * T(0.1);
  // v9 = E9^T omega9~ r9 + Pdot9: velocity of the mass centre, inertial axes [m/s]
  const T t9_1 = thetadot9 * T(0.1);
  const T v9_1 = sdot9_1 - E9_12 * t9_1;
  const T v9_2 = sdot9_2 + E9_11 * t9_1;
  // l9 = m9 v9: linear momentum, inertial axes [kg m/s]
  const T l9_1 = T(2) * v9_1;
  const T l9_2 = T(2) * v9_2;
  // H9 = E9^T I9 omega9 + p9~ l9: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T H9_3 = T(0.08) * thetadot9 + p9_1 * l9_2 - p9_2 * l9_1;

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  const T omega10_1 = y[12], omega10_2 = y[13], omega10_3 = y[14];
  const T sdot10 = y[25];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // P10 = s1 + R1^T d10: position of the body origin, inertial axes [m]
  const T P10_1 = s1_1 + R1_11 * T(0.1) + R1_21 * s10 + R1_31 * T(0.3);
  const T P10_2 = s1_2 + R1_12 * T(0.1) + R1_22 * s10 + R1_32 * T(0.3);
  const T P10_3 = s1_3 + R1_13 * T(0.1) + R1_23 * s10 + R1_33 * T(0.3);
  // p10 = R10^T r10 + P10: position of the mass centre, inertial axes [m]
  const T p10_1 = P10_1 + R10_11 * T(0.02) + R10_21 * T(0.01) - R10_31 * T(0.03);
  const T p10_2 = P10_2 + R10_12 * T(0.02) + R10_22 * T(0.01) - R10_32 * T(0.03);
  const T p10_3 = P10_3 + R10_13 * T(0.02) + R10_23 * T(0.01) - R10_33 * T(0.03);
  // Pdot10 = sdot1 + R1^T (omega1~ d10 + sdot10 u10): velocity of the body origin, inertial axes [m/s]
  const T t10_13 = t3_24 - omega1_3 * s10;
  const T t10_14 = t2_24 - t5_3 + sdot10;
  const T t10_15 = omega1_1 * s10 - t3_21;
  const T Pdot10_1 = sdot1_1 + R1_11 * t10_13 + R1_21 * t10_14 + R1_31 * t10_15;
  const T Pdot10_2 = sdot1_2 + R1_12 * t10_13 + R1_22 * t10_14 + R1_32 * t10_15;
  const T Pdot10_3 = sdot1_3 + R1_13 * t10_13 + R1_23 * t10_14 + R1_33 * t10_15;
  // v10 = R10^T omega10~ r10 + Pdot10: velocity of the mass centre, inertial axes [m/s]
  const T t10_16 = omega10_3 * T(0.02) + omega10_1 * T(0.03);
  const T t10_17 = omega10_3 * T(0.01) + omega10_2 * T(0.03);
  const T t10_18 = omega10_1 * T(0.01) - omega10_2 * T(0.02);
  const T v10_1 = Pdot10_1 + R10_21 * t10_16 - R10_11 * t10_17 + R10_31 * t10_18;
  const T v10_2 = Pdot10_2 + R10_22 * t10_16 - R10_12 * t10_17 + R10_32 * t10_18;
  const T v10_3 = Pdot10_3 + R10_23 * t10_16 - R10_13 * t10_17 + R10_33 * t10_18;
  // l10 = m10 v10: linear momentum, inertial axes [kg m/s]
  const T l10_1 = T(0.4) * v10_1;
  const T l10_2 = T(0.4) * v10_2;
  const T l10_3 = T(0.4) * v10_3;
  // H10 = R10^T I10 omega10 + p10~ l10: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t10_19 = T(0.002) * omega10_1;
  const T t10_20 = T(0.003) * omega10_2;
  const T t10_21 = T(0.0025) * omega10_3;
  const T H10_1 = R10_11 * t10_19 + R10_21 * t10_20 + R10_31 * t10_21 + p10_2 * l10_3 - p10_3 * l10_2;
  const T H10_2 = R10_12 * t10_19 + R10_22 * t10_20 + R10_32 * t10_21 + p10_3 * l10_1 - p10_1 * l10_3;
  const T H10_3 = R10_13 * t10_19 + R10_23 * t10_20 + R10_33 * t10_21 + p10_1 * l10_2 - p10_2 * l10_1;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  const T thetadot11 = y[15];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // R11^T = R8^T E11^T: R takes inertial components to body components
  const T R11_11 = R8_11 * E11_11 + R8_31 * E11_13;
  const T R11_12 = R8_12 * E11_11 + R8_32 * E11_13;
  const T R11_13 = R8_13 * E11_11 + R8_33 * E11_13;
  const T R11_31 = R8_31 * E11_11 - R8_11 * E11_13;
  const T R11_32 = R8_32 * E11_11 - R8_12 * E11_13;
  const T R11_33 = R8_33 * E11_11 - R8_13 * E11_13;
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega8_1 + E11_13 * omega8_3;
  const T omega11_2 = omega8_2 - thetadot11;
  const T omega11_3 = E11_11 * omega8_3 - E11_13 * omega8_1;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // P11 = R8^T d11 + P8: position of the body origin, inertial axes [m]
  const T P11_1 = P8_1 - R1_21 * minus_d11_2;
  const T P11_2 = P8_2 - R1_22 * minus_d11_2;
  const T P11_3 = P8_3 - R1_23 * minus_d11_2;
  // p11 = R11^T r_link11 + P11: position of the mass centre, inertial axes [m]
  const T p11_1 = P11_1 + R11_31 * T(0.01);
  const T p11_2 = P11_2 + R11_32 * T(0.01);
  const T p11_3 = P11_3 + R11_33 * T(0.01);
  // Pdot11 = R8^T (omega8~ d11 + thetadot11 pitch11 u11) + Pdot8: velocity of the body origin, inertial axes [m/s]
  const T t11_1 = omega8_3 * minus_d11_2;
  const T t11_2 = thetadot11 * T(0.01);
  const T t11_3 = omega8_1 * minus_d11_2;
  const T Pdot11_1 = Pdot8_1 + R8_11 * t11_1 - R1_21 * t11_2 - R8_31 * t11_3;
  const T Pdot11_2 = Pdot8_2 + R8_12 * t11_1 - R1_22 * t11_2 - R8_32 * t11_3;
  const T Pdot11_3 = Pdot8_3 + R8_13 * t11_1 - R1_23 * t11_2 - R8_33 * t11_3;
  // v11 = R11^T omega11~ r_link11 + Pdot11: velocity of the mass centre, inertial axes [m/s]
  const T t11_4 = omega11_2 * T(0.01);
  const T t11_5 = omega11_1 * T(0.01);
  const T v11_1 = Pdot11_1 + R11_11 * t11_4 - R1_21 * t11_5;
  const T v11_2 = Pdot11_2 + R11_12 * t11_4 - R1_22 * t11_5;
  const T v11_3 = Pdot11_3 + R11_13 * t11_4 - R1_23 * t11_5;
  // l11 = m11 v11: linear momentum, inertial axes [kg m/s]
  const T l11_1 = T(0.3) * v11_1;
  const T l11_2 = T(0.3) * v11_2;
  const T l11_3 = T(0.3) * v11_3;
  // H11 = R11^T I_link11 omega11 + p11~ l11: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T t11_6 = T(4e-04) * omega11_1;
  const T t11_7 = T(6e-04) * omega11_2;
  const T t11_8 = T(4e-04) * omega11_3;
  const T H11_1 = R11_11 * t11_6 + R1_21 * t11_7 + R11_31 * t11_8 + p11_2 * l11_3 - p11_3 * l11_2;
  const T H11_2 = R11_12 * t11_6 + R1_22 * t11_7 + R11_32 * t11_8 + p11_3 * l11_1 - p11_1 * l11_3;
  const T H11_3 = R11_13 * t11_6 + R1_23 * t11_7 + R11_33 * t11_8 + p11_1 * l11_2 - p11_2 * l11_1;

  // ---- body 13 (ballast) on the inertial frame
  const T s13_1 = x[29], s13_2 = x[30], s13_3 = x[31];
  const T sdot13_1 = y[26], sdot13_2 = y[27], sdot13_3 = y[28];
  // d13 = q13 + s13: joint offset q + s, axes of the lower body [m]
  const T d13_1 = s13_1 - T(1);
  // l13 = m13 sdot13: linear momentum, inertial axes [kg m/s]
  const T l13_1 = T(5) * sdot13_1;
  const T l13_2 = T(5) * sdot13_2;
  const T l13_3 = T(5) * sdot13_3;
  // H13 = d13~ l13: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T H13_1 = s13_2 * l13_3 - s13_3 * l13_2;
  const T H13_2 = s13_3 * l13_1 - d13_1 * l13_3;
  const T H13_3 = d13_1 * l13_2 - s13_2 * l13_1;

  // ---- whole system
  // linear = l1 + l2 + l3 + l4 + l5 + l6 + l7 + l8 + l9 + l10 + l11 + l13: linear momentum of the system [kg m/s]
  const T linear_1 = l1_1 + l2_1 + l3_1 + l4_1 + l5_1 + l6_1 + l7_1 + l8_1 + l9_1 + l10_1 + l11_1 + l13_1;
  const T linear_2 = l1_2 + l2_2 + l3_2 + l4_2 + l5_2 + l6_2 + l7_2 + l8_2 + l9_2 + l10_2 + l11_2 + l13_2;
  const T linear_3 = l1_3 + l2_3 + l3_3 + l4_3 + l5_3 + l6_3 + l8_3 + l10_3 + l11_3 + l13_3;
  momentum[0] = linear_1;
  momentum[1] = linear_2;
  momentum[2] = linear_3;
  // angular = H1 + H2 + H3 + H4 + H5 + H6 + H7 + H8 + H9 + H10 + H11 + H13: angular momentum of the system about the
  //   inertial origin [kg m^2/s]
  const T angular_1 = H1_1 + H2_1 + H3_1 + H4_1 + H5_1 + H6_1 + H8_1 + H10_1 + H11_1 + H13_1 - minus_H7_1;
  const T angular_2 = H1_2 + H2_2 + H3_2 + H4_2 + H5_2 + H6_2 + H8_2 + H10_2 + H11_2 + H13_2 + H7_2;
  const T angular_3 = H1_3 + H2_3 + H3_3 + H4_3 + H5_3 + H6_3 + H7_3 + H8_3 + H9_3 + H10_3 + H11_3 + H13_3;
  momentum[3] = angular_1;
  momentum[4] = angular_2;
  momentum[5] = angular_3;
}

// power: power of the applied loads, without gravity and springs that keep their energy [W].
// power (1) [W]
// 273 add, 340 multiply, 1 divide, 11 sine or cosine, 3 other function
template <class T>
void power(const Prepared<T>& c, T t, const T* x, const T* y, const Inputs<T>& u, T* out) noexcept {
  using std::abs, std::cos, std::exp, std::sin, std::tanh;
  T cosines[14], sines[14];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 1, cosines + 8, sines + 8);
  cos_sin(x + 11, 1, cosines + 11, sines + 11);
  cos_sin(x + 13, 1, cosines + 13, sines + 13);

  // ---- body 1 (hull) on the inertial frame
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

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * T(0.2) + R1_21 * T(0.1) - R1_31 * T(0.2);
  const T P2_2 = s1_2 + R1_12 * T(0.2) + R1_22 * T(0.1) - R1_32 * T(0.2);
  const T P2_3 = s1_3 + R1_13 * T(0.2) + R1_23 * T(0.1) - R1_33 * T(0.2);
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_13 = omega1_3 * T(0.2) + omega1_1 * T(0.2);
  const T t2_14 = omega1_2 * T(0.2);
  const T t2_15 = omega1_3 * T(0.1) + t2_14;
  const T t2_16 = omega1_1 * T(0.1);
  const T t2_17 = t2_16 - t2_14;
  const T Pdot2_1 = sdot1_1 + R1_21 * t2_13 - R1_11 * t2_15 + R1_31 * t2_17;
  const T Pdot2_2 = sdot1_2 + R1_22 * t2_13 - R1_12 * t2_15 + R1_32 * t2_17;
  const T Pdot2_3 = sdot1_3 + R1_23 * t2_13 - R1_13 * t2_15 + R1_33 * t2_17;

  // ---- body 3 (boom) on body 1
  const T thetadot3 = y[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_11 * E3_31 + R1_21 * E3_32 + R1_31 * E3_33;
  const T R3_32 = R1_12 * E3_31 + R1_22 * E3_32 + R1_32 * E3_33;
  const T R3_33 = R1_13 * E3_31 + R1_23 * E3_32 + R1_33 * E3_33;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_2 = thetadot3 * T(0.44378789320576517) + E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = thetadot3 * T(0.8388422987658062) + E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_18 = s1_1 + R1_31 * T(0.1);
  const T P3_1 = t3_18 + R1_11 * T(0.3);
  const T t3_19 = s1_2 + R1_32 * T(0.1);
  const T P3_2 = t3_19 + R1_12 * T(0.3);
  const T t3_20 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_20 + R1_13 * T(0.3);
  // Pdot3 = sdot1 + R1^T omega1~ q3: velocity of the body origin, inertial axes [m/s]
  const T t3_21 = omega1_2 * T(0.1);
  const T t3_22 = omega1_3 * T(0.3);
  const T t3_23 = t3_22 - t2_16;
  const T t3_24 = omega1_2 * T(0.3);
  const T Pdot3_1 = sdot1_1 + R1_11 * t3_21 + R1_21 * t3_23 - R1_31 * t3_24;
  const T Pdot3_2 = sdot1_2 + R1_12 * t3_21 + R1_22 * t3_23 - R1_32 * t3_24;
  const T Pdot3_3 = sdot1_3 + R1_13 * t3_21 + R1_23 * t3_23 - R1_33 * t3_24;
  // damping_boom_3 = -thetadot3 c_boom_ + tau_boom_: along the coordinate [N m], [N]
  const T damping_boom_3 = u.motor - T(0.1) * tanh(thetadot3 * T(100)) - thetadot3 * T(0.5);

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T theta5_2 = c.p.amplitude * sin(t5_1);
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = t3_18 - R1_21 * T(0.3);
  const T P5a_2 = t3_19 - R1_22 * T(0.3);
  const T P5a_3 = t3_20 - R1_23 * T(0.3);
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_2 = t3_22 + t3_21;
  const T t5_3 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_2 - R1_21 * t2_16 - R1_31 * t5_3;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_2 - R1_22 * t2_16 - R1_32 * t5_3;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_2 - R1_23 * t2_16 - R1_33 * t5_3;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_1 = P3_1 + R3_11 * d6_1;
  const T P6_2 = P3_2 + R3_12 * d6_1;
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // Pdot6 = R3^T (omega3~ d6 + sdot6 u6) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t6_1 = omega3_3 * d6_1;
  const T t6_2 = omega3_2 * d6_1;
  const T Pdot6_1 = Pdot3_1 + R3_11 * sdot6 + R3_21 * t6_1 - R3_31 * t6_2;
  const T Pdot6_2 = Pdot3_2 + R3_12 * sdot6 + R3_22 * t6_1 - R3_32 * t6_2;
  const T Pdot6_3 = Pdot3_3 + R3_13 * sdot6 + R3_23 * t6_1 - R3_33 * t6_2;
  // effort_telescope_6 = -sdot6 c_telescope_: along the coordinate [N m], [N]
  const T minus_effort_telescope_6 = sdot6 * (T(2) + abs(sdot6));
  // arm2 = R2 R3^T r_jet_ - R2 P2 + R2 P6
  const T t6_3 = R3_11 * T(0.2);
  const T t6_4 = R3_12 * T(0.2);
  const T t6_5 = R3_13 * T(0.2);
  const T arm2_1 = R2_11 * t6_3 + R2_12 * t6_4 + R2_13 * t6_5 - R2_11 * P2_1 - R2_12 * P2_2 - R2_13 * P2_3 + R2_11 *
      P6_1 + R2_12 * P6_2 + R2_13 * P6_3;
  const T arm2_2 = R2_21 * t6_3 + R2_22 * t6_4 + R2_23 * t6_5 - R2_21 * P2_1 - R2_22 * P2_2 - R2_23 * P2_3 + R2_21 *
      P6_1 + R2_22 * P6_2 + R2_23 * P6_3;
  const T arm2_3 = R2_31 * t6_3 + R2_32 * t6_4 + R2_33 * t6_5 - R2_31 * P2_1 - R2_32 * P2_2 - R2_33 * P2_3 + R2_31 *
      P6_1 + R2_32 * P6_2 + R2_33 * P6_3;

  // ---- body 8 (piston) on body 1
  const T thetadot8 = y[10];
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_2 = omega1_2 - thetadot8;

  // ---- body 9 (sled) on the inertial frame
  const T s9_1 = x[26], s9_2 = x[27];
  const T thetadot9 = y[11];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // line_tether_9 = -R5^T C12^T r_tether_ - R5^T o5 + E9^T r_tether_other_ - P5a + d9: from one end of the spring to
  //   the other, inertial axes [m]
  const T line_tether_9_1 = s9_1 - P5a_1 + E9_11 * T(0.1) - R5_21 * T(0.02) - T(0.03620228586010676) * R5a_11 -
      T(0.06743336618301184) * R5_31;
  const T line_tether_9_2 = d9_2 - P5a_2 + E9_12 * T(0.1) - R5_22 * T(0.02) - T(0.03620228586010676) * R5a_12 -
      T(0.06743336618301184) * R5_32;
  const T line_tether_9_3 = T(0.1) - P5a_3 - R5_23 * T(0.02) - T(0.03620228586010676) * R5a_13 -
      T(0.06743336618301184) * R5_33;
  // ll_tether_9 = 1e-36 + line_tether_9 . line_tether_9: length squared [m^2]
  const T ll_tether_9 = T(1e-36) + line_tether_9_1 * line_tether_9_1 + line_tether_9_2 * line_tether_9_2 +
      line_tether_9_3 * line_tether_9_3;
  // line_rate_tether_9 = -R5^T omega5~ C12^T r_tether_ - R5^T omega5~ o5 + E9^T omega9~ r_tether_other_ - Pdot5a +
  //   Pdot9: its rate [m/s]
  const T t9_1 = thetadot9 * T(0.1);
  const T t9_2 = omega5_2 * T(0.07741670784769467) - omega5_3 * T(0.02);
  const T t9_3 = omega5_3 * T(0.06329813066769584) + omega5_1 * T(0.07741670784769467);
  const T t9_4 = omega5_1 * T(0.02) + omega5_2 * T(0.06329813066769584);
  const T t9_5 = omega5_3 * T(0.09950041652780259) + omega5_1 * T(0.009983341664682815);
  const T t9_6 = omega5_2 * T(0.009983341664682815);
  const T t9_7 = omega5_2 * T(0.09950041652780259);
  const T line_rate_tether_9_1 = sdot9_1 - Pdot5a_1 - E9_12 * t9_1 - R5a_11 * t9_2 + R5_21 * t9_3 - R5_31 * t9_4 -
      R5_21 * t9_5 + R5a_11 * t9_6 + R5_31 * t9_7;
  const T line_rate_tether_9_2 = sdot9_2 - Pdot5a_2 + R5_22 * t9_3 - R5a_12 * t9_2 - R5_32 * t9_4 - R5_22 * t9_5 +
      R5a_12 * t9_6 + R5_32 * t9_7 + E9_11 * t9_1;
  const T minus_line_rate_tether_9_3 = Pdot5a_3 + R5a_13 * t9_2 - R5_23 * t9_3 + R5_33 * t9_4 + R5_23 * t9_5 - R5a_13
      * t9_6 - R5_33 * t9_7;
  // f_damping_tether_9 = line_tether_9 . line_rate_tether_9 ll_tether_9^-1 c_tether_: attraction by the length [N/m]
  const T t9_8 = line_tether_9_1 * line_rate_tether_9_1 + line_tether_9_2 * line_rate_tether_9_2 - line_tether_9_3 *
      minus_line_rate_tether_9_3;
  const T f_damping_tether_9 = T(1) / ll_tether_9 * t9_8 * T(0.4);

  // ---- body 11 (nut) on body 8
  const T thetadot11 = y[15];
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_2 = omega8_2 - thetadot11;
  // effort_nut_11 = -thetadot11 c_nut_: along the coordinate [N m], [N]
  const T minus_effort_nut_11 = thetadot11 * T(0.002);

  // ---- whole system
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // power = thetadot3 damping_boom_3 - R3^T F_jet_ . (R2^T omega2~ arm2 + Pdot2) + (R3^T F_jet_) . (R3^T omega3~
  //   r_jet_ + Pdot6) + sdot6 effort_telescope_6 + thetadot11 effort_nut_11 + (C11^T M_coupling_) . omega11 -
  //   line_tether_9 . line_rate_tether_9 f_damping_tether_9 + F1 . (sdot1 + R1^T omega1~ r1) + M1 . omega1: power of
  //   the applied loads [W]
  const T b0_1 = T(0.5) * u.thrust * exp(T(0) - t);
  const T b0_2 = R3_11 * T(0.1) + R3_21 * b0_1;
  const T b0_3 = omega2_2 * arm2_3 - omega2_3 * arm2_2;
  const T b0_4 = omega2_3 * arm2_1 - omega2_1 * arm2_3;
  const T b0_5 = omega2_1 * arm2_2 - omega2_2 * arm2_1;
  const T b0_6 = R3_12 * T(0.1) + R3_22 * b0_1;
  const T b0_7 = R3_13 * T(0.1) + R3_23 * b0_1;
  const T b0_8 = omega3_3 * T(0.2);
  const T b0_9 = omega3_2 * T(0.2);
  const T power = t2_16 - b0_2 * (Pdot2_1 + R2_11 * b0_3 + R2_21 * b0_4 + R2_31 * b0_5) - b0_6 * (Pdot2_2 + R2_12 *
      b0_3 + R2_22 * b0_4 + R2_32 * b0_5) - b0_7 * (Pdot2_3 + R2_13 * b0_3 + R2_23 * b0_4 + R2_33 * b0_5) + thetadot3
      * damping_boom_3 + b0_2 * (Pdot6_1 + R3_21 * b0_8 - R3_31 * b0_9) + b0_6 * (Pdot6_2 + R3_22 * b0_8 - R3_32 *
      b0_9) + b0_7 * (Pdot6_3 + R3_23 * b0_8 - R3_33 * b0_9) - sdot6 * minus_effort_telescope_6 - thetadot11 *
      minus_effort_nut_11 - T(0.02) * u.motor * omega11_2 - t9_8 * f_damping_tether_9 + u.thrust * (sdot1_3 + R1_13 *
      (T(0.01) * omega1_3 + T(0.03) * omega1_2) + R1_23 * (omega1_3 * T(0.02) - omega1_1 * T(0.03)) - R1_33 * (T(0.01)
      * omega1_1 + T(0.02) * omega1_2)) + T(0.2) * cos(T(2) * t) * omega1_2;
  out[0] = power;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 1601 add, 1910 multiply, 14 divide, 1 square root, 19 sine or cosine, 3 other function
// by: articulated; composite would take 1691 add, 2059 multiply, 14 divide, 1 square root, 19 sine or cosine, 3 other
//   function
template <class T>
void accelerations(const Prepared<T>& c, T t, const T* x, const T* y, const Inputs<T>& u, T* ydot) noexcept {
  using std::abs, std::cos, std::exp, std::sin, std::sqrt, std::tanh;
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
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
  const T minus_U1_22 = t1_15 + t1_13;
  const T U1_23 = omega1_3 * omega1_2;
  const T minus_U1_33 = t1_15 + t1_14;
  // a1 = U1 r1: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T t1_16 = U1_13 * T(0.03);
  const T t1_17 = U1_12 * T(0.01);
  const T a1_1 = t1_16 - t1_17 - minus_U1_11 * T(0.02);
  const T a1_2 = U1_12 * T(0.02) + minus_U1_22 * T(0.01) + U1_23 * T(0.03);
  const T t1_18 = U1_13 * T(0.02);
  const T t1_19 = U1_23 * T(0.01);
  const T a1_3 = t1_18 - t1_19 - minus_U1_33 * T(0.03);
  // G1 = R1 F1 - m1 a1: applied less inertia force, body axes [N]
  const T G1_1 = R1_13 * u.thrust - T(8) * a1_1;
  const T G1_2 = R1_23 * u.thrust - T(8) * a1_2;
  const T G1_3 = R1_33 * u.thrust - T(8) * a1_3;
  // N1 = -omega1~ I1 omega1 + M1: applied less inertia moment about the mass centre, body axes [N m]
  const T N1_1 = t1_17 + t1_18 + T(0.1) - T(0.19999999999999996) * U1_23 - T(0.03) * (t1_14 - t1_13);
  const T N1_2 = T(0.09999999999999998) * U1_13 + T(0.01) * (t1_13 - t1_15) - T(0.02) * U1_23 + T(0.03) * U1_12 +
      T(0.2) * cos(T(2) * t);
  const T minus_N1_3 = t1_16 + t1_19 + T(0.02) * (t1_15 - t1_14) - T(0.09999999999999998) * U1_12;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // erel2 = -e1~ e2 + eps4_1 e2 - eps4_2 e1: Euler parameters relative to the lower body
  const T erel2_1 = eps1_3 * eps2_2 - eps1_2 * eps2_3 + eps1_4 * eps2_1 - eps2_4 * eps1_1;
  const T erel2_2 = eps1_1 * eps2_3 - eps1_3 * eps2_1 + eps1_4 * eps2_2 - eps2_4 * eps1_2;
  const T erel2_3 = eps1_2 * eps2_1 - eps1_1 * eps2_2 + eps1_4 * eps2_3 - eps2_4 * eps1_3;
  // eps4rel2 = e1 . e2 + eps4_1 eps4_2
  const T eps4rel2 = eps1_1 * eps2_1 + eps1_2 * eps2_2 + eps1_3 * eps2_3 + eps1_4 * eps2_4;
  // C2^T = 1 + 2 erel2~ (eps4rel2 + erel2~): C takes components in the lower body to those in the body
  const T t2_13 = T(2) * erel2_2;
  const T t2_14 = t2_13 * erel2_2;
  const T t2_15 = T(2) * erel2_3;
  const T t2_16 = t2_15 * erel2_3;
  const T C2_11 = T(1) - t2_14 - t2_16;
  const T t2_17 = T(2) * erel2_1;
  const T t2_18 = t2_17 * erel2_2;
  const T t2_19 = t2_15 * eps4rel2;
  const T C2_12 = t2_18 + t2_19;
  const T t2_20 = t2_17 * erel2_3;
  const T t2_21 = t2_13 * eps4rel2;
  const T C2_13 = t2_20 - t2_21;
  const T C2_21 = t2_18 - t2_19;
  const T t2_22 = T(1) - t2_17 * erel2_1;
  const T C2_22 = t2_22 - t2_16;
  const T t2_23 = t2_13 * erel2_3;
  const T t2_24 = t2_17 * eps4rel2;
  const T C2_23 = t2_23 + t2_24;
  const T C2_31 = t2_20 + t2_21;
  const T C2_32 = t2_23 - t2_24;
  const T C2_33 = t2_22 - t2_14;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * T(0.2) + R1_21 * T(0.1) - R1_31 * T(0.2);
  const T P2_2 = s1_2 + R1_12 * T(0.2) + R1_22 * T(0.1) - R1_32 * T(0.2);
  const T P2_3 = s1_3 + R1_13 * T(0.2) + R1_23 * T(0.1) - R1_33 * T(0.2);
  // U2 = omega2~ omega2~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T U2_12 = omega2_2 * omega2_1;
  const T U2_13 = omega2_3 * omega2_1;
  const T t2_25 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_25 + omega2_3 * omega2_3;
  const T U2_23 = omega2_3 * omega2_2;
  const T minus_U2_33 = t2_25 + omega2_2 * omega2_2;
  // Pddot2 = C2 U1 q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_26 = U1_12 * T(0.1);
  const T t2_27 = minus_U1_11 * T(0.2);
  const T t2_28 = U1_13 * T(0.2);
  const T t2_29 = t2_26 - t2_27 - t2_28;
  const T t2_30 = U1_12 * T(0.2);
  const T t2_31 = minus_U1_22 * T(0.1);
  const T t2_32 = t2_30 - t2_31 - U1_23 * T(0.2);
  const T t2_33 = U1_23 * T(0.1);
  const T t2_34 = t2_28 + t2_33 + minus_U1_33 * T(0.2);
  const T Pddot2_1 = C2_11 * t2_29 + C2_12 * t2_32 + C2_13 * t2_34;
  const T Pddot2_2 = C2_21 * t2_29 + C2_22 * t2_32 + C2_23 * t2_34;
  const T Pddot2_3 = C2_31 * t2_29 + C2_32 * t2_32 + C2_33 * t2_34;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a2_1 = Pddot2_1 + U2_12 * T(0.02) - U2_13 * T(0.2);
  const T a2_2 = Pddot2_2 - minus_U2_22 * T(0.02) - U2_23 * T(0.2);
  const T a2_3 = Pddot2_3 + U2_23 * T(0.02) + minus_U2_33 * T(0.2);

  // ---- body 3 (boom) on body 1
  const T theta3 = x[8];
  const T thetadot3 = y[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T t3_18 = E3_11 * omega1_1 + E3_12 * omega1_2 - minus_E3_13 * omega1_3;
  const T omega3_1 = t3_18 - thetadot3 * T(0.3152711589176631);
  const T t3_19 = E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_2 = t3_19 + thetadot3 * T(0.44378789320576517);
  const T t3_20 = E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  const T omega3_3 = t3_20 + thetadot3 * T(0.8388422987658062);
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_21 = s1_1 + R1_31 * T(0.1);
  const T P3_1 = t3_21 + R1_11 * T(0.3);
  const T t3_22 = s1_2 + R1_32 * T(0.1);
  const T P3_2 = t3_22 + R1_12 * T(0.3);
  const T t3_23 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_23 + R1_13 * T(0.3);
  // omegadot3 = -thetadot3 b3~ E3 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot3_1 = thetadot3 * (T(0.44378789320576517) * t3_20 - T(0.8388422987658062) * t3_19);
  const T minus_omegadot3_2 = thetadot3 * (T(0.8388422987658062) * t3_18 + T(0.3152711589176631) * t3_20);
  const T omegadot3_3 = thetadot3 * (T(0.3152711589176631) * t3_19 + T(0.44378789320576517) * t3_18);
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_24 = omega3_3 * omega3_3;
  const T t3_25 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_24 + t3_25;
  const T t3_26 = omega3_2 * omega3_1;
  const T U3_12 = t3_26 - omegadot3_3;
  const T t3_27 = omega3_3 * omega3_1;
  const T U3_13 = t3_27 - minus_omegadot3_2;
  const T U3_21 = t3_26 + omegadot3_3;
  const T t3_28 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_24 + t3_28;
  const T t3_29 = omega3_3 * omega3_2;
  const T U3_23 = t3_29 + minus_omegadot3_1;
  const T U3_31 = t3_27 + minus_omegadot3_2;
  const T U3_32 = t3_29 - minus_omegadot3_1;
  const T minus_U3_33 = t3_25 + t3_28;
  // Pddot3 = E3 U1 q3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_30 = U1_13 * T(0.1);
  const T t3_31 = t3_30 - minus_U1_11 * T(0.3);
  const T t3_32 = U1_12 * T(0.3);
  const T t3_33 = t3_32 + t2_33;
  const T t3_34 = minus_U1_33 * T(0.1);
  const T t3_35 = U1_13 * T(0.3) - t3_34;
  const T Pddot3_1 = E3_11 * t3_31 + E3_12 * t3_33 - minus_E3_13 * t3_35;
  const T Pddot3_2 = E3_21 * t3_31 + E3_22 * t3_33 + E3_23 * t3_35;
  const T Pddot3_3 = E3_31 * t3_31 + E3_32 * t3_33 + E3_33 * t3_35;
  // stretch_boom_3 = theta3 - l_boom_: stretch of the spring
  const T stretch_boom_3 = theta3 - T(0.2);
  // effort_boom_3 = -thetadot3 c_boom_ + tau_boom_ - stretch_boom_3 k_boom_: along the coordinate [N m], [N]
  const T effort_boom_3 = u.motor - T(0.1) * tanh(thetadot3 * T(100)) - thetadot3 * T(0.5) - c.p.k * stretch_boom_3;
  // G2 = -R2 R3^T F_jet_ - m2 a2: applied less inertia force, body axes [N]
  const T t3_36 = T(0.5) * u.thrust * exp(T(0) - t);
  const T t3_37 = R3_11 * T(0.1) + R3_21 * t3_36;
  const T t3_38 = R3_12 * T(0.1) + R3_22 * t3_36;
  const T t3_39 = R3_13 * T(0.1) + R3_23 * t3_36;
  const T t3_40 = R2_11 * t3_37 + R2_12 * t3_38 + R2_13 * t3_39;
  const T minus_G2_1 = t3_40 + T(0.8) * a2_1;
  const T t3_41 = R2_21 * t3_37 + R2_22 * t3_38 + R2_23 * t3_39;
  const T minus_G2_2 = t3_41 + T(0.8) * a2_2;
  const T t3_42 = R2_31 * t3_37 + R2_32 * t3_38 + R2_33 * t3_39;
  const T minus_G2_3 = t3_42 + T(0.8) * a2_3;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a3_1 = Pddot3_1 + U3_12 * T(0.02) - minus_U3_11 * T(0.2);
  const T a3_2 = Pddot3_2 + U3_21 * T(0.2) - minus_U3_22 * T(0.02);
  const T a3_3 = Pddot3_3 + U3_31 * T(0.2) + U3_32 * T(0.02);
  // G3 = -m3 a3: applied less inertia force, body axes [N]
  const T minus_G3_1 = T(1.5) * a3_1;
  const T minus_G3_2 = T(1.5) * a3_2;
  const T minus_G3_3 = T(1.5) * a3_3;
  // N3 = -axial(U3 (tr(I3)/2 - I3)): applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N3_1 = T(0.004999999999999999) * U3_32 - T(0.035) * U3_23 + T(0.003) * (minus_U3_22 - minus_U3_33) -
      T(0.002) * U3_31 + T(0.001) * U3_21;
  const T minus_N3_2 = T(0.035) * U3_13 - T(0.015000000000000001) * U3_31 - T(0.001) * (minus_U3_33 - minus_U3_11) +
      T(0.003) * U3_12 + T(0.002) * U3_32;
  const T minus_N3_3 = T(0.015000000000000001) * U3_21 - T(0.004999999999999999) * U3_12 - T(0.002) * (minus_U3_11 -
      minus_U3_22) - T(0.001) * U3_23 - T(0.003) * U3_13;

  // ---- body 4 (cross) on body 1
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // omega4a = thetadot4_1 b4_1 + E4a omega1: absolute angular velocity, body axes [rad/s]
  const T omega4a_1 = E4a_11 * omega1_1 - minus_E4a_12 * omega1_2 - minus_E4a_13 * omega1_3;
  const T t4_3 = minus_E4a_12 * omega1_1 + E4a_22 * omega1_2 + E4a_23 * omega1_3;
  const T omega4a_2 = t4_3 + thetadot4_1 * T(0.28);
  const T t4_4 = minus_E4a_13 * omega1_1 + E4a_23 * omega1_2 + E4a_33 * omega1_3;
  const T omega4a_3 = t4_4 - thetadot4_1 * T(0.96);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_5 = cosines[10];
  const T E4_12 = T(0.28) * t4_5;
  const T minus_E4_13 = T(0.96) * t4_5;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // omega4 = thetadot4_2 b4_2 + E4 omega4a: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega4a_2 - minus_E4_11 * omega4a_1 - minus_E4_13 * omega4a_3;
  const T omega4_2 = thetadot4_2 + T(0.96) * omega4a_2 + T(0.28) * omega4a_3;
  const T omega4_3 = t4_5 * omega4a_1 + E4_32 * omega4a_2 - minus_E4_33 * omega4a_3;
  // omegadot4a = -thetadot4_1 b4_1~ E4a omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot4a_1 = thetadot4_1 * (T(0.96) * t4_3 + T(0.28) * t4_4);
  const T omegadot4a_2 = T(0.96) * omega4a_1 * thetadot4_1;
  const T omegadot4a_3 = T(0.28) * omega4a_1 * thetadot4_1;
  // Pddot4a = E4a U1 q4a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_6 = t2_27 + t2_26;
  const T t4_7 = t2_30 + t2_31;
  const T t4_8 = t2_33 - t2_28;
  const T Pddot4a_1 = E4a_11 * t4_6 + minus_E4a_12 * t4_7 - minus_E4a_13 * t4_8;
  const T Pddot4a_2 = minus_E4a_12 * t4_6 - E4a_22 * t4_7 + E4a_23 * t4_8;
  const T Pddot4a_3 = minus_E4a_13 * t4_6 - E4a_23 * t4_7 + E4a_33 * t4_8;
  // omegadot4 = -thetadot4_2 b4_2~ E4 omega4a + E4 omegadot4a: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = minus_E4_11 * minus_omegadot4a_1 + E4_12 * omegadot4a_2 - minus_E4_13 * omegadot4a_3 -
      thetadot4_2 * omega4_3;
  const T omegadot4_2 = T(0.96) * omegadot4a_2 + T(0.28) * omegadot4a_3;
  const T omegadot4_3 = thetadot4_2 * omega4_1 + E4_32 * omegadot4a_2 - t4_5 * minus_omegadot4a_1 - minus_E4_33 *
      omegadot4a_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_9 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_9 + omega4_3 * omega4_3;
  const T t4_10 = omega4_2 * omega4_1;
  const T U4_12 = t4_10 - omegadot4_3;
  const T t4_11 = omega4_3 * omega4_1;
  const T U4_13 = t4_11 + omegadot4_2;
  const T U4_21 = t4_10 + omegadot4_3;
  const T t4_12 = omega4_3 * omega4_2;
  const T U4_23 = t4_12 - omegadot4_1;
  const T U4_31 = t4_11 - omegadot4_2;
  const T U4_32 = t4_12 + omegadot4_1;
  const T minus_U4_33 = t4_9 + omega4_1 * omega4_1;
  // Pddot4 = E4 Pddot4a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot4_1 = E4_12 * Pddot4a_2 - minus_E4_11 * Pddot4a_1 - minus_E4_13 * Pddot4a_3;
  const T Pddot4_2 = T(0.96) * Pddot4a_2 + T(0.28) * Pddot4a_3;
  const T Pddot4_3 = t4_5 * Pddot4a_1 + E4_32 * Pddot4a_2 - minus_E4_33 * Pddot4a_3;
  // a4 = U4 r4 + Pddot4: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a4_1 = Pddot4_1 + U4_13 * T(0.1) - minus_U4_11 * T(0.03);
  const T a4_2 = Pddot4_2 + U4_21 * T(0.03) + U4_23 * T(0.1);
  const T a4_3 = Pddot4_3 + U4_31 * T(0.03) - minus_U4_33 * T(0.1);
  // G4 = -m4 a4: applied less inertia force, body axes [N]
  const T minus_G4_1 = T(0.9) * a4_1;
  const T minus_G4_2 = T(0.9) * a4_2;
  const T minus_G4_3 = T(0.9) * a4_3;
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N4_1 = T(0.006500000000000001) * U4_32 - T(0.0015) * U4_23;
  const T minus_N4_2 = T(0.0015) * U4_13 - T(0.0055) * U4_31;
  const T minus_N4_3 = T(0.0055) * U4_21 - T(0.006500000000000001) * U4_12;

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T t5_2 = sin(t5_1);
  const T theta5_2 = c.p.amplitude * t5_2;
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // thetaddot5_2 = d^2/dt^2 expression 1: prescribed
  const T minus_thetaddot5_2 = t5_2 * T(3) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = t3_21 - R1_21 * T(0.3);
  const T P5a_2 = t3_22 - R1_22 * T(0.3);
  const T P5a_3 = t3_23 - R1_23 * T(0.3);
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_3 = omega1_2 * T(0.1);
  const T t5_4 = omega1_3 * T(0.3) + t5_3;
  const T t5_5 = omega1_1 * T(0.1);
  const T t5_6 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_4 - R1_21 * t5_5 - R1_31 * t5_6;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_4 - R1_22 * t5_5 - R1_32 * t5_6;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_4 - R1_23 * t5_5 - R1_33 * t5_6;
  // omegadot5a = -thetadot5_1 b5_1~ E5a omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot5a_1 = thetadot5_1 * omega5a_2;
  const T minus_omegadot5a_2 = thetadot5_1 * omega5a_1;
  // Pddot5a = E5a U1 q5a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_7 = t3_30 - t3_32;
  const T t5_8 = t2_33 + minus_U1_22 * T(0.3);
  const T Pddot5a_1 = E5a_11 * t5_7 + E5a_12 * t5_8;
  const T Pddot5a_2 = E5a_11 * t5_8 - E5a_12 * t5_7;
  const T minus_Pddot5a_3 = t3_34 + U1_23 * T(0.3);
  // omegadot5 = -thetadot5_2 b5_2~ E5 omega5a + thetaddot5_2 b5_2 + E5 omegadot5a: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5_1 = omegadot5a_1 - minus_thetaddot5_2;
  const T omegadot5_2 = thetadot5_2 * omega5_3 - E5_22 * minus_omegadot5a_2;
  const T omegadot5_3 = E5_23 * minus_omegadot5a_2 - thetadot5_2 * omega5_2;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_9 = omega5_2 * omega5_2;
  const T minus_U5_11 = omega5_3 * omega5_3 + t5_9;
  const T t5_10 = omega5_2 * omega5_1;
  const T U5_12 = t5_10 - omegadot5_3;
  const T t5_11 = omega5_3 * omega5_1;
  const T U5_13 = t5_11 + omegadot5_2;
  const T U5_21 = t5_10 + omegadot5_3;
  const T t5_12 = omega5_3 * omega5_2;
  const T U5_23 = t5_12 - omegadot5_1;
  const T U5_31 = t5_11 - omegadot5_2;
  const T U5_32 = t5_12 + omegadot5_1;
  const T minus_U5_33 = t5_9 + omega5_1 * omega5_1;
  // Pddot5 = E5 Pddot5a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_2 = E5_22 * Pddot5a_2 - E5_23 * minus_Pddot5a_3;
  const T minus_Pddot5_3 = E5_23 * Pddot5a_2 + E5_22 * minus_Pddot5a_3;
  // a5 = U5 r_link5 + Pddot5: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a5_1 = Pddot5a_1 + U5_13 * c.r_link5_3 - minus_U5_11 * c.r_link5_1;
  const T a5_2 = Pddot5_2 + U5_21 * c.r_link5_1 + U5_23 * c.r_link5_3;
  const T a5_3 = U5_31 * c.r_link5_1 - minus_Pddot5_3 - minus_U5_33 * c.r_link5_3;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_1 = P3_1 + R3_11 * d6_1;
  const T P6_2 = P3_2 + R3_12 * d6_1;
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // Pddot6 = 2 sdot6 omega3~ u6 + U3 d6 + Pddot3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = Pddot3_1 - minus_U3_11 * d6_1;
  const T t6_1 = T(2) * sdot6;
  const T Pddot6_2 = Pddot3_2 + t6_1 * omega3_3 + U3_21 * d6_1;
  const T Pddot6_3 = Pddot3_3 + U3_31 * d6_1 - t6_1 * omega3_2;
  // effort_telescope_6 = -sdot6 c_telescope_: along the coordinate [N m], [N]
  const T minus_effort_telescope_6 = sdot6 * (T(2) + abs(sdot6));
  // arm2 = R2 R3^T r_jet_ - R2 P2 + R2 P6
  const T t6_2 = R3_11 * T(0.2);
  const T t6_3 = R3_12 * T(0.2);
  const T t6_4 = R3_13 * T(0.2);
  const T arm2_1 = R2_11 * t6_2 + R2_12 * t6_3 + R2_13 * t6_4 - R2_11 * P2_1 - R2_12 * P2_2 - R2_13 * P2_3 + R2_11 *
      P6_1 + R2_12 * P6_2 + R2_13 * P6_3;
  const T arm2_2 = R2_21 * t6_2 + R2_22 * t6_3 + R2_23 * t6_4 - R2_21 * P2_1 - R2_22 * P2_2 - R2_23 * P2_3 + R2_21 *
      P6_1 + R2_22 * P6_2 + R2_23 * P6_3;
  const T arm2_3 = R2_31 * t6_2 + R2_32 * t6_3 + R2_33 * t6_4 - R2_31 * P2_1 - R2_32 * P2_2 - R2_33 * P2_3 + R2_31 *
      P6_1 + R2_32 * P6_2 + R2_33 * P6_3;
  // lever2 = -r2 + arm2: from the reference point to where a force acts, link axes [m]
  const T lever2_2 = arm2_2 - T(0.02);
  const T lever2_3 = arm2_3 + T(0.2);
  // N2 = -omega2~ I2 omega2 - lever2~ R2 R3^T F_jet_: applied less inertia moment about the mass centre, body axes [N
  //   m]
  const T minus_N2_1 = lever2_2 * t3_42 - lever2_3 * t3_41 - T(0.006999999999999999) * U2_23;
  const T minus_N2_2 = T(0.006) * U2_13 + lever2_3 * t3_40 - arm2_1 * t3_42;
  const T minus_N2_3 = T(0.0009999999999999992) * U2_12 + arm2_1 * t3_41 - lever2_2 * t3_40;
  // a6 = U3 r6 + Pddot6: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a6_1 = Pddot6_1 + U3_13 * T(0.01) - minus_U3_11 * T(0.1);
  const T a6_2 = Pddot6_2 + U3_21 * T(0.1) + U3_23 * T(0.01);
  const T a6_3 = Pddot6_3 + U3_31 * T(0.1) - minus_U3_33 * T(0.01);
  // G6 = -m6 a6 + F_jet_: applied less inertia force, body axes [N]
  const T G6_1 = T(0.1) - T(0.5) * a6_1;
  const T G6_2 = t3_36 - T(0.5) * a6_2;
  const T minus_G6_3 = T(0.5) * a6_3;
  // N6 = -axial(U3 (tr(I6)/2 - I6)) + lever6~ F_jet_: applied less inertia moment about the mass centre, body axes [N
  //   m]
  const T N6_1 = T(5e-04) * U3_23 - T(5e-04) * U3_32 + T(0.01) * t3_36;
  const T minus_N6_2 = T(0.001) + T(5e-04) * U3_13 - T(0.0055) * U3_31;
  const T N6_3 = T(5e-04) * U3_12 - T(0.0055) * U3_21 + T(0.1) * t3_36;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  const T thetadot8 = y[10];
  const T sdot8 = y[22];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega1_1 + E8_13 * omega1_3;
  const T omega8_2 = omega1_2 - thetadot8;
  const T omega8_3 = E8_11 * omega1_3 - E8_13 * omega1_1;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // omegadot8 = -thetadot8 b8~ E8 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot8_1 = thetadot8 * omega8_3;
  const T minus_omegadot8_3 = thetadot8 * omega8_1;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_1 = omega8_3 * omega8_3;
  const T t8_2 = omega8_2 * omega8_2;
  const T minus_U8_11 = t8_1 + t8_2;
  const T t8_3 = omega8_2 * omega8_1;
  const T U8_12 = t8_3 + minus_omegadot8_3;
  const T U8_13 = omega8_3 * omega8_1;
  const T U8_21 = t8_3 - minus_omegadot8_3;
  const T t8_4 = omega8_1 * omega8_1;
  const T minus_U8_22 = t8_1 + t8_4;
  const T t8_5 = omega8_3 * omega8_2;
  const T U8_23 = t8_5 - omegadot8_1;
  const T U8_32 = t8_5 + omegadot8_1;
  const T minus_U8_33 = t8_2 + t8_4;
  // Pddot8 = E8 omega1~ (omega1~ d8 + 2 sdot8 u8): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t8_6 = T(2) * sdot8;
  const T t8_7 = omega1_1 * d8_2;
  const T t8_8 = t8_6 * omega1_3 + omega1_2 * t8_7;
  const T t8_9 = omega1_3 * d8_2;
  const T t8_10 = omega1_2 * t8_9 - t8_6 * omega1_1;
  const T Pddot8_1 = E8_11 * t8_8 + E8_13 * t8_10;
  const T minus_Pddot8_2 = omega1_3 * t8_9 + omega1_1 * t8_7;
  const T Pddot8_3 = E8_11 * t8_10 - E8_13 * t8_8;
  // a8 = U8 r_link8 + Pddot8: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a8_1 = Pddot8_1 + minus_U8_11 * T(0.01) - U8_12 * T(0.1) + U8_13 * T(0.02);
  const T a8_2 = minus_U8_22 * T(0.1) - minus_Pddot8_2 - U8_21 * T(0.01) + U8_23 * T(0.02);
  const T a8_3 = Pddot8_3 - U8_13 * T(0.01) - U8_32 * T(0.1) - minus_U8_33 * T(0.02);
  // G8 = -m8 a8: applied less inertia force, body axes [N]
  const T minus_G8_1 = T(0.7) * a8_1;
  const T minus_G8_2 = T(0.7) * a8_2;
  const T minus_G8_3 = T(0.7) * a8_3;
  // N8 = -axial(U8 (tr(I_link8)/2 - I_link8)): applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N8_1 = T(0.0025) * U8_32 - T(5e-04) * U8_23;
  const T N8_2 = T(0.001) * U8_13;
  const T minus_N8_3 = T(0.0015) * U8_21 - T(0.0025) * U8_12;

  // ---- body 9 (sled) on the inertial frame
  const T s9_1 = x[26], s9_2 = x[27];
  const T thetadot9 = y[11];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // U9 = omega9~ omega9~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T minus_U9_11 = thetadot9 * thetadot9;
  // line_tether_9 = -R5^T C12^T r_tether_ - R5^T o5 + E9^T r_tether_other_ - P5a + d9: from one end of the spring to
  //   the other, inertial axes [m]
  const T line_tether_9_1 = s9_1 - P5a_1 + E9_11 * T(0.1) - R5_21 * T(0.02) - T(0.03620228586010676) * R5a_11 -
      T(0.06743336618301184) * R5_31;
  const T line_tether_9_2 = d9_2 - P5a_2 + E9_12 * T(0.1) - R5_22 * T(0.02) - T(0.03620228586010676) * R5a_12 -
      T(0.06743336618301184) * R5_32;
  const T line_tether_9_3 = T(0.1) - P5a_3 - R5_23 * T(0.02) - T(0.03620228586010676) * R5a_13 -
      T(0.06743336618301184) * R5_33;
  // ll_tether_9 = 1e-36 + line_tether_9 . line_tether_9: length squared [m^2]
  const T ll_tether_9 = T(1e-36) + line_tether_9_1 * line_tether_9_1 + line_tether_9_2 * line_tether_9_2 +
      line_tether_9_3 * line_tether_9_3;
  // length_tether_9 = ll_tether_9^1/2: length [m]
  const T length_tether_9 = sqrt(ll_tether_9);
  // line_rate_tether_9 = -R5^T omega5~ C12^T r_tether_ - R5^T omega5~ o5 + E9^T omega9~ r_tether_other_ - Pdot5a +
  //   Pdot9: its rate [m/s]
  const T t9_1 = thetadot9 * T(0.1);
  const T t9_2 = omega5_2 * T(0.07741670784769467) - omega5_3 * T(0.02);
  const T t9_3 = omega5_3 * T(0.06329813066769584) + omega5_1 * T(0.07741670784769467);
  const T t9_4 = omega5_1 * T(0.02) + omega5_2 * T(0.06329813066769584);
  const T t9_5 = omega5_3 * T(0.09950041652780259) + omega5_1 * T(0.009983341664682815);
  const T t9_6 = omega5_2 * T(0.009983341664682815);
  const T t9_7 = omega5_2 * T(0.09950041652780259);
  const T line_rate_tether_9_1 = sdot9_1 - Pdot5a_1 - E9_12 * t9_1 - R5a_11 * t9_2 + R5_21 * t9_3 - R5_31 * t9_4 -
      R5_21 * t9_5 + R5a_11 * t9_6 + R5_31 * t9_7;
  const T line_rate_tether_9_2 = sdot9_2 - Pdot5a_2 + R5_22 * t9_3 - R5a_12 * t9_2 - R5_32 * t9_4 - R5_22 * t9_5 +
      R5a_12 * t9_6 + R5_32 * t9_7 + E9_11 * t9_1;
  const T minus_line_rate_tether_9_3 = Pdot5a_3 + R5a_13 * t9_2 - R5_23 * t9_3 + R5_33 * t9_4 + R5_23 * t9_5 - R5a_13
      * t9_6 - R5_33 * t9_7;
  // f_tether_9 = k_tether_ - k_tether_ l_tether_ length_tether_9^-1 + c_tether_ line_tether_9 . line_rate_tether_9
  //   ll_tether_9^-1: attraction by the length [N/m]
  const T f_tether_9 = c.p.k - T(1) / length_tether_9 * c.c9_1 + T(0.4) * (line_tether_9_1 * line_rate_tether_9_1 +
      line_tether_9_2 * line_rate_tether_9_2 - line_tether_9_3 * minus_line_rate_tether_9_3) * (T(1) / ll_tether_9);
  // F_tether_9 = f_tether_9 line_tether_9: on the first end, inertial axes [N]
  const T F_tether_9_1 = f_tether_9 * line_tether_9_1;
  const T F_tether_9_2 = f_tether_9 * line_tether_9_2;
  const T F_tether_9_3 = f_tether_9 * line_tether_9_3;
  // G5 = R5 F_tether_9 - m_link5 a5: applied less inertia force, body axes [N]
  const T t9_8 = R5a_11 * F_tether_9_1 + R5a_12 * F_tether_9_2 + R5a_13 * F_tether_9_3;
  const T G5_1 = t9_8 - c.m_link5 * a5_1;
  const T t9_9 = R5_21 * F_tether_9_1 + R5_22 * F_tether_9_2 + R5_23 * F_tether_9_3;
  const T G5_2 = t9_9 - c.m_link5 * a5_2;
  const T t9_10 = R5_31 * F_tether_9_1 + R5_32 * F_tether_9_2 + R5_33 * F_tether_9_3;
  const T G5_3 = t9_10 - c.m_link5 * a5_3;
  // N5 = -axial(U5 (tr(I_link5)/2 - I_link5)) + lever5~ R5 F_tether_9: applied less inertia moment about the mass
  //   centre, body axes [N m]
  const T N5_1 = c.c9_4 * U5_23 - c.c9_3 * U5_32 - c.I_link5_13 * U5_21 + T(0.02) * t9_10 - c.lever5_3 * t9_9;
  const T N5_2 = c.c9_2 * U5_31 - c.c9_4 * U5_13 + c.I_link5_13 * (minus_U5_33 - minus_U5_11) + c.lever5_3 * t9_8 -
      c.lever5_1 * t9_10;
  const T N5_3 = c.c9_3 * U5_12 - c.c9_2 * U5_21 + c.I_link5_13 * U5_23 + c.lever5_1 * t9_9 - T(0.02) * t9_8;
  // a9 = U9 r9 + Pddot9: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T minus_a9_1 = minus_U9_11 * T(0.1);
  // G9 = -E9 F_tether_9 - m9 a9: applied less inertia force, body axes [N]
  const T G9_1 = T(2) * minus_a9_1 - (E9_11 * F_tether_9_1 + E9_12 * F_tether_9_2);
  const T minus_G9_2 = E9_11 * F_tether_9_2 - E9_12 * F_tether_9_1;
  // N9 = -axial(U9 (tr(I9)/2 - I9)) - lever9~ E9 F_tether_9: applied less inertia moment about the mass centre, body
  //   axes [N m]
  const T N9_1 = T(0.1) * minus_G9_2;

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  const T omega10_1 = y[12], omega10_2 = y[13], omega10_3 = y[14];
  const T sdot10 = y[25];
  // erel10 = -e1~ e10 + eps4_1 e10 - eps4_10 e1: Euler parameters relative to the lower body
  const T erel10_1 = eps1_3 * eps10_2 - eps1_2 * eps10_3 + eps1_4 * eps10_1 - eps10_4 * eps1_1;
  const T erel10_2 = eps1_1 * eps10_3 - eps1_3 * eps10_1 + eps1_4 * eps10_2 - eps10_4 * eps1_2;
  const T erel10_3 = eps1_2 * eps10_1 - eps1_1 * eps10_2 + eps1_4 * eps10_3 - eps10_4 * eps1_3;
  // eps4rel10 = e1 . e10 + eps4_1 eps4_10
  const T eps4rel10 = eps1_1 * eps10_1 + eps1_2 * eps10_2 + eps1_3 * eps10_3 + eps1_4 * eps10_4;
  // C10^T = 1 + 2 erel10~ (eps4rel10 + erel10~): C takes components in the lower body to those in the body
  const T t10_1 = T(2) * erel10_2;
  const T t10_2 = t10_1 * erel10_2;
  const T t10_3 = T(2) * erel10_3;
  const T t10_4 = t10_3 * erel10_3;
  const T C10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * erel10_1;
  const T t10_6 = t10_5 * erel10_2;
  const T t10_7 = t10_3 * eps4rel10;
  const T C10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * erel10_3;
  const T t10_9 = t10_1 * eps4rel10;
  const T C10_13 = t10_8 - t10_9;
  const T C10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * erel10_1;
  const T C10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * erel10_3;
  const T t10_12 = t10_5 * eps4rel10;
  const T C10_23 = t10_11 + t10_12;
  const T C10_31 = t10_8 + t10_9;
  const T C10_32 = t10_11 - t10_12;
  const T C10_33 = t10_10 - t10_2;
  // U10 = omega10~ omega10~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t10_13 = omega10_3 * omega10_3;
  const T t10_14 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_13 + t10_14;
  const T U10_12 = omega10_2 * omega10_1;
  const T U10_13 = omega10_3 * omega10_1;
  const T t10_15 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_13 + t10_15;
  const T U10_23 = omega10_3 * omega10_2;
  const T minus_U10_33 = t10_14 + t10_15;
  // Pddot10 = C10 omega1~ (omega1~ d10 + 2 sdot10 u10): acceleration of the body origin, less gravity, body axes
  //   [m/s^2]
  const T t10_16 = omega1_1 * s10 - t5_3;
  const T t10_17 = omega1_3 * T(0.1) - t5_6 + T(2) * sdot10;
  const T t10_18 = omega1_2 * t10_16 - omega1_3 * t10_17;
  const T t10_19 = omega1_2 * T(0.3) - omega1_3 * s10;
  const T t10_20 = omega1_3 * t10_19 - omega1_1 * t10_16;
  const T t10_21 = omega1_1 * t10_17 - omega1_2 * t10_19;
  const T Pddot10_1 = C10_11 * t10_18 + C10_12 * t10_20 + C10_13 * t10_21;
  const T Pddot10_2 = C10_21 * t10_18 + C10_22 * t10_20 + C10_23 * t10_21;
  const T Pddot10_3 = C10_31 * t10_18 + C10_32 * t10_20 + C10_33 * t10_21;
  // a10 = U10 r10 + Pddot10: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a10_1 = Pddot10_1 + U10_12 * T(0.01) - minus_U10_11 * T(0.02) - U10_13 * T(0.03);
  const T a10_2 = Pddot10_2 + U10_12 * T(0.02) - minus_U10_22 * T(0.01) - U10_23 * T(0.03);
  const T a10_3 = Pddot10_3 + U10_13 * T(0.02) + U10_23 * T(0.01) + minus_U10_33 * T(0.03);
  // G10 = -m10 a10: applied less inertia force, body axes [N]
  const T minus_G10_1 = T(0.4) * a10_1;
  const T minus_G10_2 = T(0.4) * a10_2;
  const T minus_G10_3 = T(0.4) * a10_3;
  // N10 = -omega10~ I10 omega10: applied less inertia moment about the mass centre, body axes [N m]
  const T N10_1 = T(5e-04) * U10_23;
  const T N10_2 = T(5e-04) * U10_13;
  const T minus_N10_3 = T(0.001) * U10_12;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  const T thetadot11 = y[15];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega8_1 + E11_13 * omega8_3;
  const T omega11_2 = omega8_2 - thetadot11;
  const T omega11_3 = E11_11 * omega8_3 - E11_13 * omega8_1;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // omegadot11 = -thetadot11 b11~ E11 omega8 + E11 omegadot8: angular acceleration, body axes [rad/s^2]
  const T omegadot11_1 = thetadot11 * omega11_3 + E11_11 * omegadot8_1 - E11_13 * minus_omegadot8_3;
  const T minus_omegadot11_3 = thetadot11 * omega11_1 + E11_13 * omegadot8_1 + E11_11 * minus_omegadot8_3;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_1 = omega11_2 * omega11_1;
  const T U11_12 = t11_1 + minus_omegadot11_3;
  const T U11_13 = omega11_3 * omega11_1;
  const T U11_21 = t11_1 - minus_omegadot11_3;
  const T t11_2 = omega11_3 * omega11_2;
  const T U11_23 = t11_2 - omegadot11_1;
  const T U11_32 = t11_2 + omegadot11_1;
  const T minus_U11_33 = omega11_2 * omega11_2 + omega11_1 * omega11_1;
  // Pddot11 = E11 (2 thetadot11 pitch11 omega8~ u11 + U8 d11 + Pddot8): acceleration of the body origin, less
  //   gravity, body axes [m/s^2]
  const T t11_3 = T(2) * thetadot11 * T(0.01);
  const T t11_4 = Pddot8_1 + t11_3 * omega8_3 - U8_12 * minus_d11_2;
  const T t11_5 = Pddot8_3 - t11_3 * omega8_1 - U8_32 * minus_d11_2;
  const T Pddot11_1 = E11_11 * t11_4 + E11_13 * t11_5;
  const T Pddot11_2 = minus_U8_22 * minus_d11_2 - minus_Pddot8_2;
  const T Pddot11_3 = E11_11 * t11_5 - E11_13 * t11_4;
  // effort_nut_11 = -thetadot11 c_nut_: along the coordinate [N m], [N]
  const T minus_effort_nut_11 = thetadot11 * T(0.002);
  // a11 = U11 r_link11 + Pddot11: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a11_1 = Pddot11_1 + U11_13 * T(0.01);
  const T a11_2 = Pddot11_2 + U11_23 * T(0.01);
  const T a11_3 = Pddot11_3 - minus_U11_33 * T(0.01);
  // G11 = -m11 a11: applied less inertia force, body axes [N]
  const T minus_G11_1 = T(0.3) * a11_1;
  const T minus_G11_2 = T(0.3) * a11_2;
  const T minus_G11_3 = T(0.3) * a11_3;
  // N11 = C11^T M_coupling_ - axial(U11 (tr(I_link11)/2 - I_link11)): applied less inertia moment about the mass
  //   centre, body axes [N m]
  const T minus_N11_1 = T(0.00010000000000000005) * U11_32 - T(3e-04) * U11_23;
  const T minus_N11_2 = T(0.02) * u.motor;
  const T minus_N11_3 = T(3e-04) * U11_21 - T(0.00010000000000000005) * U11_12;

  // ---- body 11 (nut) and what it carries
  // n11 = r_link11~ G11 + N11: moment that drives it, body axes [N m]
  const T b11_1 = minus_G11_2 * T(0.01);
  const T n11_1 = b11_1 - minus_N11_1;
  const T minus_n11_2 = T(0.01) * minus_G11_1 + minus_N11_2;
  // u_11 = b11 . G11 pitch11 + b11 . n11 + effort_nut_11: drives it [N m], [N]
  const T u_11 = b11_1 + minus_n11_2 - minus_effort_nut_11;
  // v11 = invD11 u_11: u/D
  const T v11 = T(1515.1515151515152) * u_11;
  // gt11 = G11 - v11 B11: force with the turn solved [N]
  const T b11_2 = v11 * T(0.003);
  const T gt11_1 = b11_2 - minus_G11_1;
  const T gt11_2 = b11_2 - minus_G11_2;
  // nt11 = n11 - v11 K11: moment with the turn solved [N m]
  const T nt11_1 = n11_1 - v11 * T(3e-05);
  const T nt11_2 = v11 * T(0.0006299999999999999) - minus_n11_2;
  // Mp11 = E11^T M11 E11: M passed on, lower body's axes [kg]
  const T b11_3 = E11_13 * T(0.013636363636363637);
  const T b11_4 = E11_13 * b11_3;
  const T Mp11_11 = T(0.2863636363636364) + b11_4;
  const T minus_Mp11_12 = E11_11 * T(0.013636363636363637);
  const T minus_Mp11_13 = E11_11 * b11_3;
  const T minus_Mp11_23 = E11_13 * T(0.013636363636363637);
  const T Mp11_33 = T(0.3) - b11_4;
  // gp11 = E11^T gt11: force passed on, lower body's axes [N]
  const T gp11_1 = E11_11 * gt11_1 + E11_13 * minus_G11_3;
  const T gp11_3 = E11_13 * gt11_1 - E11_11 * minus_G11_3;
  // Hp11 = E11^T H11 E11: H passed on, lower body's axes [kg m]
  const T b11_5 = E11_13 * T(0.00013636363636363637);
  const T b11_6 = E11_13 * b11_5;
  const T Hp11_11 = T(0.00013636363636363637) - b11_6;
  const T minus_Hp11_12 = E11_11 * T(0.0028636363636363638);
  const T Hp11_13 = E11_11 * b11_5;
  const T Hp11_21 = E11_11 * T(0.00013636363636363637);
  const T Hp11_23 = E11_13 * T(0.00013636363636363637);
  const T minus_Hp11_32 = E11_13 * T(0.0028636363636363638);
  // Jp11 = E11^T J11 E11: J passed on, lower body's axes [kg m^2]
  const T b11_7 = E11_13 * T(2.8636363636363637e-05);
  const T b11_8 = E11_13 * b11_7;
  const T Jp11_11 = T(0.0004286363636363637) - b11_8;
  const T Jp11_12 = E11_11 * T(2.8636363636363637e-05);
  const T Jp11_13 = E11_11 * b11_7;
  const T Jp11_23 = E11_13 * T(2.8636363636363637e-05);
  const T Jp11_33 = T(4e-04) + b11_8;
  // np11 = E11^T nt11: moment passed on, lower body's axes [N m]
  const T np11_1 = E11_11 * nt11_1 + E11_13 * minus_N11_3;
  const T np11_3 = E11_13 * nt11_1 - E11_11 * minus_N11_3;
  // Hb11 = d11~ Mp11 + Hp11: H of the joint at the lower body's origin, its axes
  const T b11_9 = minus_d11_2 * minus_Mp11_13;
  const T Hb11_11 = b11_9 + Hp11_11;
  const T Hb11_12 = minus_d11_2 * minus_Mp11_23 - minus_Hp11_12;
  const T Hb11_13 = Hp11_13 - minus_d11_2 * Mp11_33;
  const T Hb11_31 = Hp11_13 + minus_d11_2 * Mp11_11;
  const T minus_Hb11_32 = minus_d11_2 * minus_Mp11_12 + minus_Hp11_32;
  const T Hb11_33 = b11_6 - b11_9;

  // ---- body 10 (runner) and what it carries
  // n10 = r10~ G10 + N10: moment that drives it, body axes [N m]
  const T n10_1 = N10_1 - (T(0.03) * minus_G10_2 + T(0.01) * minus_G10_3);
  const T n10_2 = T(0.03) * minus_G10_1 + T(0.02) * minus_G10_3 + N10_2;
  const T n10_3 = T(0.01) * minus_G10_1 - T(0.02) * minus_G10_2 - minus_N10_3;
  // w_10 = D(LD10)^-1 L(LD10)^-1 n10: D^-1 L^-1 n
  const T w_10_1 = T(416.6666666666667) * n10_1;
  const T b10_1 = n10_2 + T(0.03333333333333333) * n10_1;
  const T w_10_2 = T(284.30629264594387) * b10_1;
  const T w_10_3 = T(374.3436923513552) * (n10_3 - T(0.1) * n10_1 - T(0.03639120545868082) * b10_1);
  // gb10 = G10 - Y10^T w_10: force with the ball solved [N]
  const T gb10_1 = T(0.012) * w_10_2 - minus_G10_1 + T(0.0035633055344958305) * w_10_3;
  const T minus_gb10_2 = minus_G10_2 + T(4e-04) * w_10_2 + T(0.012) * w_10_1 + T(0.006785443517816528) * w_10_3;
  const T minus_gb10_3 = minus_G10_3 + T(0.004) * w_10_1 - T(0.007866666666666668) * w_10_2 -
      T(0.00011372251705837757) * w_10_3;
  // Mp10 = C10^T M10 C10: M passed on, lower body's axes [kg]
  const T b10_2 = C10_11 * T(0.35430679721867464) + C10_21 * T(0.01041577976443877) - C10_31 *
      T(0.026990208599404004);
  const T b10_3 = C10_11 * T(0.01041577976443877) + C10_21 * T(0.32271888746984534) - C10_31 *
      T(0.018816517667092383);
  const T b10_4 = C10_31 * T(0.3757343550446999) - (C10_11 * T(0.026990208599404004) + C10_21 *
      T(0.018816517667092383));
  const T Mp10_11 = b10_2 * C10_11 + b10_3 * C10_21 + b10_4 * C10_31;
  const T Mp10_12 = b10_2 * C10_12 + b10_3 * C10_22 + b10_4 * C10_32;
  const T Mp10_13 = b10_2 * C10_13 + b10_3 * C10_23 + b10_4 * C10_33;
  const T b10_5 = C10_12 * T(0.35430679721867464) + C10_22 * T(0.01041577976443877) - C10_32 *
      T(0.026990208599404004);
  const T b10_6 = C10_12 * T(0.01041577976443877) + C10_22 * T(0.32271888746984534) - C10_32 *
      T(0.018816517667092383);
  const T b10_7 = C10_32 * T(0.3757343550446999) - (C10_12 * T(0.026990208599404004) + C10_22 *
      T(0.018816517667092383));
  const T Mp10_22 = b10_5 * C10_12 + b10_6 * C10_22 + b10_7 * C10_32;
  const T Mp10_23 = b10_5 * C10_13 + b10_6 * C10_23 + b10_7 * C10_33;
  const T Mp10_33 = T(1.05276003973322) - Mp10_11 - Mp10_22;
  // gp10 = C10^T gb10: force passed on, lower body's axes [N]
  const T gp10_1 = C10_11 * gb10_1 - C10_21 * minus_gb10_2 - C10_31 * minus_gb10_3;
  const T gp10_2 = C10_12 * gb10_1 - C10_22 * minus_gb10_2 - C10_32 * minus_gb10_3;
  const T gp10_3 = C10_13 * gb10_1 - C10_23 * minus_gb10_2 - C10_33 * minus_gb10_3;
  // invD2_10 = D2_10^-1: 1/D
  const T invD2_10 = T(1) / Mp10_22;
  // kB2_10 = invD2_10 B2_10: B/D
  const T kB2_10_1 = invD2_10 * Mp10_12;
  const T kB2_10_3 = invD2_10 * Mp10_23;
  // v2_10 = invD2_10 u_2_10: u/D
  const T v2_10 = invD2_10 * gp10_2;
  // Ms2_10 = P_u10 (Mp10 - kB2_10 B2_10^T) P_u10: M with the slide solved [kg]
  const T Ms2_10_11 = Mp10_11 - kB2_10_1 * Mp10_12;
  const T Ms2_10_13 = Mp10_13 - kB2_10_1 * Mp10_23;
  const T Ms2_10_33 = Mp10_33 - kB2_10_3 * Mp10_23;
  // gs2_10 = P_u10 (gp10 - v2_10 B2_10): force with the slide solved [N]
  const T gs2_10_1 = gp10_1 - v2_10 * Mp10_12;
  const T gs2_10_3 = gp10_3 - v2_10 * Mp10_23;
  // Hb10 = d10~ Ms2_10: H of the joint at the lower body's origin, its axes
  const T Hb10_11 = s10 * Ms2_10_13;
  const T Hb10_13 = s10 * Ms2_10_33;
  const T Hb10_21 = T(0.3) * Ms2_10_11 - T(0.1) * Ms2_10_13;
  const T Hb10_23 = T(0.3) * Ms2_10_13 - T(0.1) * Ms2_10_33;
  const T minus_Hb10_31 = s10 * Ms2_10_11;

  // ---- body 9 (sled) and what it carries
  // v1_9 = invD1_9 u_1_9: u/D
  const T minus_v1_9 = T(10) * N9_1;
  // gt9 = G9 - v1_9 B1_9: force with the turn solved [N]
  const T gt9_2 = minus_v1_9 * T(0.2) - minus_G9_2;
  // Mp9 = E9^T M9 E9: M passed on, lower body's axes [kg]
  const T b9_1 = E9_12 * T(0.4);
  const T b9_2 = E9_12 * b9_1;
  const T Mp9_11 = T(2) - b9_2;
  const T Mp9_12 = E9_11 * b9_1;
  const T Mp9_22 = T(1.5999999999999999) + b9_2;
  // gp9 = E9^T gt9: force passed on, lower body's axes [N]
  const T gp9_1 = E9_11 * G9_1 - E9_12 * gt9_2;
  const T gp9_2 = E9_12 * G9_1 + E9_11 * gt9_2;
  // invD2_9 = D2_9^-1: 1/D
  const T invD2_9 = T(1) / Mp9_11;
  // kB2_9 = invD2_9 B2_9: B/D
  const T kB2_9_2 = invD2_9 * Mp9_12;
  // v2_9 = invD2_9 u_2_9: u/D
  const T v2_9 = invD2_9 * gp9_1;
  // Ms2_9 = P_u9_1 (Mp9 - kB2_9 B2_9^T) P_u9_1: M with the slide solved [kg]
  const T Ms2_9_22 = Mp9_22 - kB2_9_2 * Mp9_12;
  // gs2_9 = P_u9_1 (gp9 - v2_9 B2_9): force with the slide solved [N]
  const T gs2_9_2 = gp9_2 - v2_9 * Mp9_12;
  // invD3_9 = D3_9^-1: 1/D
  const T invD3_9 = T(1) / Ms2_9_22;
  // v3_9 = invD3_9 u_3_9: u/D
  const T v3_9 = invD3_9 * gs2_9_2;
  ydot[24] = v3_9;

  // ---- body 8 (piston) and what it carries
  // MA8 = m8 one + Mp11: force for an acceleration of the origin, home axes [kg]
  const T MA8_11 = T(0.7) + Mp11_11;
  const T MA8_33 = T(0.7) + Mp11_33;
  // HA8 = m8 r_link8~ + Hb11: moment for an acceleration of the origin, body axes [kg m]
  const T HA8_12 = Hb11_12 - T(0.013999999999999999);
  const T HA8_13 = Hb11_13 - T(0.06999999999999999);
  const T HA8_21 = T(0.013999999999999999) + Hp11_21;
  const T HA8_23 = Hp11_23 + T(0.006999999999999999);
  const T HA8_31 = Hb11_31 + T(0.06999999999999999);
  const T minus_HA8_32 = T(0.006999999999999999) + minus_Hb11_32;
  // JA8 = -m8 r_link8~ r_link8~ + I_link8 + d11~ Hp11^T + Jp11 - Hb11 d11~: moment for an angular acceleration, body
  //   axes [kg m^2]
  const T b8_1 = minus_d11_2 * Hp11_13;
  const T JA8_11 = T(0.010280000000000001) - b8_1 + Jp11_11 - Hb11_13 * minus_d11_2;
  const T JA8_12 = Jp11_12 - (T(7e-04) + minus_d11_2 * Hp11_23);
  const T JA8_13 = T(0.00014) - minus_d11_2 * b11_6 + Jp11_13 + Hb11_11 * minus_d11_2;
  const T JA8_23 = T(0.0014) + Jp11_23 + minus_d11_2 * Hp11_21;
  const T JA8_33 = T(0.01107) + b8_1 + Jp11_33 + Hb11_31 * minus_d11_2;
  // g8 = G8 + gp11: force that drives it, home axes [N]
  const T g8_1 = gp11_1 - minus_G8_1;
  const T g8_2 = gt11_2 - minus_G8_2;
  const T g8_3 = gp11_3 - minus_G8_3;
  // n8 = r_link8~ G8 + d11~ gp11 + N8 + np11: moment that drives it, body axes [N m]
  const T n8_1 = np11_1 - minus_N8_1 + T(0.02) * minus_G8_2 + T(0.1) * minus_G8_3 - minus_d11_2 * gp11_3;
  const T n8_2 = nt11_2 - T(0.02) * minus_G8_1 - T(0.01) * minus_G8_3 + N8_2;
  const T n8_3 = np11_3 - minus_N8_3 + T(0.01) * minus_G8_2 - T(0.1) * minus_G8_1 + minus_d11_2 * gp11_1;
  // kB1_8 = invD1_8 B1_8: B/D
  const T minus_kB1_8_1 = T(420.4089432447927) * HA8_21;
  const T minus_kB1_8_3 = T(420.4089432447927) * HA8_23;
  // kK1_8 = invD1_8 K1_8: K/D
  const T minus_kK1_8_1 = T(420.4089432447927) * JA8_12;
  const T minus_kK1_8_3 = T(420.4089432447927) * JA8_23;
  // v1_8 = invD1_8 u_1_8: u/D
  const T minus_v1_8 = T(420.4089432447927) * n8_2;
  // M8 = MA8 - kB1_8 B1_8^T: MA less what the turn takes up [kg]
  const T M8_11 = MA8_11 - minus_kB1_8_1 * HA8_21;
  const T M8_12 = minus_kB1_8_1 * T(0.0028636363636363638) - minus_Mp11_12;
  const T minus_M8_13 = minus_Mp11_13 + minus_kB1_8_1 * HA8_23;
  const T M8_23 = T(1.2038983374737244) * HA8_23 - minus_Mp11_23;
  const T M8_33 = MA8_33 - minus_kB1_8_3 * HA8_23;
  // H8 = P_b8 (HA8 - kK1_8 B1_8^T): HA less what the turn takes up [kg m]
  const T H8_11 = Hb11_11 - minus_kK1_8_1 * HA8_21;
  const T H8_12 = HA8_12 + minus_kK1_8_1 * T(0.0028636363636363638);
  const T H8_13 = HA8_13 - minus_kK1_8_1 * HA8_23;
  const T H8_31 = HA8_31 - minus_kK1_8_3 * HA8_21;
  const T H8_32 = minus_kK1_8_3 * T(0.0028636363636363638) - minus_HA8_32;
  const T H8_33 = Hb11_33 - minus_kK1_8_3 * HA8_23;
  // J8 = P_b8 (JA8 - kK1_8 K1_8^T) P_b8: JA less what the turn takes up [kg m^2]
  const T J8_11 = JA8_11 - minus_kK1_8_1 * JA8_12;
  const T J8_13 = JA8_13 - minus_kK1_8_1 * JA8_23;
  const T J8_33 = JA8_33 - minus_kK1_8_3 * JA8_23;
  // gt8 = g8 - v1_8 B1_8: force with the turn solved [N]
  const T gt8_1 = g8_1 - minus_v1_8 * HA8_21;
  const T gt8_2 = g8_2 + minus_v1_8 * T(0.0028636363636363638);
  const T gt8_3 = g8_3 - minus_v1_8 * HA8_23;
  // nt8 = P_b8 (n8 - v1_8 K1_8): moment with the turn solved [N m]
  const T nt8_1 = n8_1 - minus_v1_8 * JA8_12;
  const T nt8_3 = n8_3 - minus_v1_8 * JA8_23;
  // Mp8 = E8^T M8 E8: M passed on, lower body's axes [kg]
  const T b8_2 = T(2) * E8_11;
  const T b8_3 = b8_2 * minus_M8_13 + E8_13 * (M8_33 - M8_11);
  const T b8_4 = E8_13 * b8_3;
  const T Mp8_11 = M8_11 + b8_4;
  const T Mp8_12 = E8_11 * M8_12 - E8_13 * M8_23;
  const T Mp8_13 = minus_M8_13 - E8_11 * b8_3;
  const T Mp8_23 = E8_11 * M8_23 + E8_13 * M8_12;
  const T Mp8_33 = M8_33 - b8_4;
  // gp8 = E8^T gt8: force passed on, lower body's axes [N]
  const T gp8_1 = E8_11 * gt8_1 - E8_13 * gt8_3;
  const T gp8_3 = E8_13 * gt8_1 + E8_11 * gt8_3;
  // Hp8 = E8^T H8 E8: H passed on, lower body's axes [kg m]
  const T b8_5 = E8_11 * (H8_31 + H8_13) - E8_13 * (H8_33 - H8_11);
  const T b8_6 = E8_13 * b8_5;
  const T Hp8_11 = H8_11 - b8_6;
  const T Hp8_12 = E8_11 * H8_12 - E8_13 * H8_32;
  const T b8_7 = E8_11 * b8_5;
  const T Hp8_13 = b8_7 - H8_31;
  const T Hp8_31 = b8_7 - H8_13;
  const T Hp8_32 = E8_11 * H8_32 + E8_13 * H8_12;
  const T Hp8_33 = H8_33 + b8_6;
  // Jp8 = E8^T J8 E8: J passed on, lower body's axes [kg m^2]
  const T b8_8 = b8_2 * J8_13 - E8_13 * (J8_33 - J8_11);
  const T b8_9 = E8_13 * b8_8;
  const T Jp8_11 = J8_11 - b8_9;
  const T Jp8_13 = E8_11 * b8_8 - J8_13;
  const T Jp8_33 = J8_33 + b8_9;
  // np8 = E8^T nt8: moment passed on, lower body's axes [N m]
  const T np8_1 = E8_11 * nt8_1 - E8_13 * nt8_3;
  const T np8_3 = E8_13 * nt8_1 + E8_11 * nt8_3;
  // kB2_8 = invD2_8 B2_8: B/D
  const T minus_kB2_8_1 = T(1.0173808227700445) * Mp8_12;
  const T minus_kB2_8_3 = T(1.0173808227700445) * Mp8_23;
  // kK2_8 = invD2_8 K2_8: K/D
  const T minus_kK2_8_1 = T(1.0173808227700445) * Hp8_12;
  const T minus_kK2_8_3 = T(1.0173808227700445) * Hp8_32;
  // v2_8 = invD2_8 u_2_8: u/D
  const T minus_v2_8 = T(1.0173808227700445) * gt8_2;
  // Ms2_8 = P_u8 (Mp8 - kB2_8 B2_8^T) P_u8: M with the slide solved [kg]
  const T Ms2_8_11 = Mp8_11 - minus_kB2_8_1 * Mp8_12;
  const T Ms2_8_13 = Mp8_13 - minus_kB2_8_1 * Mp8_23;
  const T Ms2_8_33 = Mp8_33 - minus_kB2_8_3 * Mp8_23;
  // Hs2_8 = (Hp8 - kK2_8 B2_8^T) P_u8: H with the slide solved [kg m]
  const T Hs2_8_11 = Hp8_11 - minus_kK2_8_1 * Mp8_12;
  const T Hs2_8_13 = Hp8_13 - minus_kK2_8_1 * Mp8_23;
  const T Hs2_8_31 = Hp8_31 - minus_kK2_8_3 * Mp8_12;
  const T Hs2_8_33 = Hp8_33 - minus_kK2_8_3 * Mp8_23;
  // Js2_8 = Jp8 - kK2_8 K2_8^T: J with the slide solved [kg m^2]
  const T Js2_8_11 = Jp8_11 - minus_kK2_8_1 * Hp8_12;
  const T Js2_8_13 = Jp8_13 - minus_kK2_8_1 * Hp8_32;
  const T Js2_8_33 = Jp8_33 - minus_kK2_8_3 * Hp8_32;
  // gs2_8 = P_u8 (gp8 - v2_8 B2_8): force with the slide solved [N]
  const T gs2_8_1 = gp8_1 - minus_v2_8 * Mp8_12;
  const T gs2_8_3 = gp8_3 - minus_v2_8 * Mp8_23;
  // ns2_8 = np8 - v2_8 K2_8: moment with the slide solved [N m]
  const T ns2_8_1 = np8_1 - minus_v2_8 * Hp8_12;
  const T ns2_8_3 = np8_3 - minus_v2_8 * Hp8_32;
  // Hb8 = d8~ Ms2_8 + Hs2_8: H of the joint at the lower body's origin, its axes
  const T b8_10 = d8_2 * Ms2_8_13;
  const T Hb8_11 = b8_10 + Hs2_8_11;
  const T Hb8_13 = Hs2_8_13 + d8_2 * Ms2_8_33;
  const T Hb8_31 = Hs2_8_31 - d8_2 * Ms2_8_11;
  const T Hb8_33 = Hs2_8_33 - b8_10;

  // ---- body 6 (telescope) and what it carries
  // n6 = r6~ G6 + N6: moment that drives it, body axes [N m]
  const T n6_1 = N6_1 - T(0.01) * G6_2;
  const T n6_2 = T(0.01) * G6_1 - minus_N6_2 + T(0.1) * minus_G6_3;
  const T n6_3 = N6_3 + T(0.1) * G6_2;
  // u_6 = u6 . G6 + effort_telescope_6: drives it [N m], [N]
  const T u_6 = G6_1 - minus_effort_telescope_6;
  // v6 = invD6 u_6: u/D
  const T v6 = T(2) * u_6;
  // ns6 = n6 - v6 K6: moment with the slide solved [N m]
  const T ns6_2 = n6_2 - v6 * T(0.005);
  // Hb6 = d6~ Ms6 + Hs6: H of the joint at the lower body's origin, its axes
  const T minus_Hb6_23 = T(0.05) + d6_1 * T(0.5);

  // ---- body 5 (camera) and what it carries
  // n5 = r_link5~ G5 + N5: moment that drives it, body axes [N m]
  const T n5_1 = N5_1 - c.r_link5_3 * G5_2;
  const T n5_2 = N5_2 + c.r_link5_3 * G5_1 - c.r_link5_1 * G5_3;
  const T n5_3 = N5_3 + c.r_link5_1 * G5_2;
  // gp5 = E5^T G5: force passed on, lower body's axes [N]
  const T gp5_2 = E5_22 * G5_2 - E5_23 * G5_3;
  const T gp5_3 = E5_23 * G5_2 + E5_22 * G5_3;
  // Hp5 = E5^T HA5 E5: H passed on, lower body's axes [kg m]
  const T minus_Hp5_12 = E5_22 * c.HA5_21;
  const T minus_Hp5_13 = E5_23 * c.HA5_21;
  // Jp5 = E5^T JA5 E5: J passed on, lower body's axes [kg m^2]
  const T minus_Jp5_12 = E5_23 * c.JA5_13;
  const T Jp5_13 = E5_22 * c.JA5_13;
  const T b5_1 = E5_23 * c.c5_2;
  const T b5_2 = E5_23 * b5_1;
  const T Jp5_22 = c.JA5_22 - b5_2;
  const T Jp5_23 = E5_22 * b5_1;
  const T Jp5_33 = c.JA5_33 + b5_2;
  // np5 = E5^T n5: moment passed on, lower body's axes [N m]
  const T np5_2 = E5_22 * n5_2 - E5_23 * n5_3;
  const T np5_3 = E5_23 * n5_2 + E5_22 * n5_3;
  // invD5a = D5a^-1: 1/D
  const T invD5a = T(1) / Jp5_33;
  // kB5a = invD5a B5a: B/D
  const T kB5a_1 = invD5a * minus_Hp5_13;
  const T kB5a_2 = invD5a * c.HA5_32;
  // kK5a = invD5a K5a: K/D
  const T kK5a_1 = invD5a * Jp5_13;
  const T kK5a_2 = invD5a * Jp5_23;
  // v5a = invD5a u_5a: u/D
  const T v5a = invD5a * np5_3;
  // M5a = Mp5 - kB5a B5a^T: MA less what the turn takes up [kg]
  const T M5a_11 = c.m_link5 - kB5a_1 * minus_Hp5_13;
  const T minus_M5a_12 = kB5a_1 * c.HA5_32;
  const T M5a_22 = c.m_link5 - kB5a_2 * c.HA5_32;
  // H5a = P_b5_1 (Hp5 - kK5a B5a^T): HA less what the turn takes up [kg m]
  const T minus_H5a_11 = kK5a_1 * minus_Hp5_13;
  const T minus_H5a_12 = minus_Hp5_12 + kK5a_1 * c.HA5_32;
  const T H5a_21 = minus_Hp5_12 - kK5a_2 * minus_Hp5_13;
  const T minus_H5a_22 = kK5a_2 * c.HA5_32;
  // J5a = P_b5_1 (Jp5 - kK5a K5a^T) P_b5_1: JA less what the turn takes up [kg m^2]
  const T J5a_11 = c.JA5_11 - kK5a_1 * Jp5_13;
  const T minus_J5a_12 = minus_Jp5_12 + kK5a_1 * Jp5_23;
  const T J5a_22 = Jp5_22 - kK5a_2 * Jp5_23;
  // gt5a = gp5 - v5a B5a: force with the turn solved [N]
  const T gt5a_1 = G5_1 - v5a * minus_Hp5_13;
  const T gt5a_2 = gp5_2 - v5a * c.HA5_32;
  // nt5a = P_b5_1 (np5 - v5a K5a): moment with the turn solved [N m]
  const T nt5a_1 = n5_1 - v5a * Jp5_13;
  const T nt5a_2 = np5_2 - v5a * Jp5_23;
  // Mp5a = E5a^T M5a E5a: M passed on, lower body's axes [kg]
  const T b5_3 = T(2) * E5a_11;
  const T b5_4 = E5a_12 * (M5a_11 - M5a_22) - b5_3 * minus_M5a_12;
  const T b5_5 = E5a_12 * b5_4;
  const T Mp5a_11 = M5a_11 - b5_5;
  const T Mp5a_12 = minus_M5a_12 + E5a_11 * b5_4;
  const T Mp5a_22 = M5a_22 + b5_5;
  // gp5a = E5a^T gt5a: force passed on, lower body's axes [N]
  const T gp5a_1 = E5a_11 * gt5a_1 - E5a_12 * gt5a_2;
  const T gp5a_2 = E5a_12 * gt5a_1 + E5a_11 * gt5a_2;
  // Hp5a = E5a^T H5a E5a: H passed on, lower body's axes [kg m]
  const T b5_6 = E5a_12 * (minus_H5a_22 - minus_H5a_11) + E5a_11 * (H5a_21 - minus_H5a_12);
  const T b5_7 = E5a_12 * b5_6;
  const T minus_Hp5a_11 = minus_H5a_11 + b5_7;
  const T b5_8 = E5a_11 * b5_6;
  const T Hp5a_12 = b5_8 - H5a_21;
  const T minus_Hp5a_13 = E5a_11 * minus_Hp5_13 - E5a_12 * c.HA5_32;
  const T Hp5a_21 = b5_8 + minus_H5a_12;
  const T Hp5a_22 = b5_7 - minus_H5a_22;
  const T minus_Hp5a_23 = E5a_11 * c.HA5_32 + E5a_12 * minus_Hp5_13;
  // Jp5a = E5a^T J5a E5a: J passed on, lower body's axes [kg m^2]
  const T b5_9 = E5a_12 * (J5a_11 - J5a_22) - b5_3 * minus_J5a_12;
  const T b5_10 = E5a_12 * b5_9;
  const T Jp5a_11 = J5a_11 - b5_10;
  const T Jp5a_12 = minus_J5a_12 + E5a_11 * b5_9;
  const T Jp5a_22 = J5a_22 + b5_10;
  // np5a = E5a^T nt5a: moment passed on, lower body's axes [N m]
  const T np5a_1 = E5a_11 * nt5a_1 - E5a_12 * nt5a_2;
  const T np5a_2 = E5a_12 * nt5a_1 + E5a_11 * nt5a_2;
  // Hb5a = q5a~ Mp5a + Hp5a: H of the joint at the lower body's origin, its axes
  const T b5_11 = T(0.1) * Mp5a_12;
  const T minus_Hb5a_11 = b5_11 + minus_Hp5a_11;
  const T Hb5a_12 = Hp5a_12 - T(0.1) * Mp5a_22;
  const T minus_Hb5a_13 = c.c5_3 + minus_Hp5a_13;
  const T Hb5a_21 = Hp5a_21 + T(0.1) * Mp5a_11;
  const T Hb5a_22 = b5_11 + Hp5a_22;
  const T Hb5a_31 = T(0.3) * Mp5a_11;
  const T Hb5a_32 = T(0.3) * Mp5a_12;

  // ---- body 4 (cross) and what it carries
  // n4 = r4~ G4 + N4: moment that drives it, body axes [N m]
  const T n4_1 = T(0.1) * minus_G4_2 - minus_N4_1;
  const T n4_2 = T(0.03) * minus_G4_3 - minus_N4_2 - T(0.1) * minus_G4_1;
  const T minus_n4_3 = minus_N4_3 + T(0.03) * minus_G4_2;
  // v4 = invD4 u_4: u/D
  const T v4 = T(59.4883997620464) * n4_2;
  // gt4 = G4 - v4 B4: force with the turn solved [N]
  const T minus_gt4_1 = minus_G4_1 + v4 * T(0.09000000000000001);
  const T gt4_3 = v4 * T(0.027) - minus_G4_3;
  // Mp4 = E4^T M4 E4: M passed on, lower body's axes [kg]
  const T b4_1 = t4_5 * T(0.8566329565734682) - minus_E4_11 * T(0.14455681142177276);
  const T b4_2 = t4_5 * T(0.14455681142177276) - minus_E4_11 * T(0.41814396192742415);
  const T Mp4_11 = b4_1 * t4_5 - b4_2 * minus_E4_11;
  const T Mp4_12 = b4_2 * E4_12 + b4_1 * E4_32;
  const T minus_Mp4_13 = b4_2 * minus_E4_13 + b4_1 * minus_E4_33;
  const T b4_3 = E4_12 * T(0.41814396192742415) + E4_32 * T(0.14455681142177276);
  const T b4_4 = E4_12 * T(0.14455681142177276) + E4_32 * T(0.8566329565734682);
  const T Mp4_22 = b4_3 * E4_12 + T(0.82944) + b4_4 * E4_32;
  const T Mp4_23 = T(0.24192000000000002) - b4_3 * minus_E4_13 - b4_4 * minus_E4_33;
  const T Mp4_33 = T(2.1747769185008923) - Mp4_11 - Mp4_22;
  // gp4 = E4^T gt4: force passed on, lower body's axes [N]
  const T gp4_1 = minus_E4_11 * minus_gt4_1 + t4_5 * gt4_3;
  const T gp4_2 = E4_32 * gt4_3 - (E4_12 * minus_gt4_1 + T(0.96) * minus_G4_2);
  const T gp4_3 = minus_E4_13 * minus_gt4_1 - T(0.28) * minus_G4_2 - minus_E4_33 * gt4_3;
  // Hp4 = E4^T H4 E4: H passed on, lower body's axes [kg m]
  const T b4_5 = minus_E4_11 * T(0.09000000000000001) + t4_5 * T(0.027);
  const T Hp4_12 = b4_5 * T(0.96);
  const T Hp4_13 = b4_5 * T(0.28);
  const T b4_6 = E4_32 * T(0.027) - E4_12 * T(0.09000000000000001);
  const T Hp4_22 = b4_6 * T(0.96);
  const T Hp4_23 = b4_6 * T(0.28);
  const T b4_7 = minus_E4_13 * T(0.09000000000000001) - minus_E4_33 * T(0.027);
  const T Hp4_32 = b4_7 * T(0.96);
  const T Hp4_33 = b4_7 * T(0.28);
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_8 = minus_E4_11 * T(0.017) + t4_5 * T(0.0027);
  const T b4_9 = minus_E4_11 * T(0.0027) + t4_5 * T(0.01281);
  const T Jp4_11 = b4_8 * minus_E4_11 + b4_9 * t4_5;
  const T Jp4_12 = b4_9 * E4_32 - b4_8 * E4_12;
  const T Jp4_13 = b4_8 * minus_E4_13 - b4_9 * minus_E4_33;
  const T b4_10 = E4_12 * T(0.017) - E4_32 * T(0.0027);
  const T b4_11 = E4_32 * T(0.01281) - E4_12 * T(0.0027);
  const T Jp4_22 = b4_10 * E4_12 + b4_11 * E4_32;
  const T minus_Jp4_23 = b4_10 * minus_E4_13 + b4_11 * minus_E4_33;
  const T Jp4_33 = T(0.029810000000000003) - Jp4_11 - Jp4_22;
  // np4 = E4^T nt4: moment passed on, lower body's axes [N m]
  const T minus_np4_1 = minus_E4_11 * n4_1 + t4_5 * minus_n4_3;
  const T np4_2 = E4_12 * n4_1 - E4_32 * minus_n4_3;
  const T np4_3 = minus_E4_33 * minus_n4_3 - minus_E4_13 * n4_1;
  // B4a = Hp4^T b4_1: force of a unit of the angle's acceleration [kg m]
  const T B4a_2 = Hp4_22 * T(0.28) - Hp4_32 * T(0.96);
  const T B4a_3 = Hp4_23 * T(0.28) - Hp4_33 * T(0.96);
  // K4a = Jp4 b4_1: its moment about the body origin, body axes [kg m^2]
  const T K4a_1 = Jp4_12 * T(0.28) - Jp4_13 * T(0.96);
  const T K4a_2 = Jp4_22 * T(0.28) + minus_Jp4_23 * T(0.96);
  const T minus_K4a_3 = minus_Jp4_23 * T(0.28) + Jp4_33 * T(0.96);
  // D4a = b4_1 . K4a: pivot: inertia that the angle feels [kg m^2]
  const T D4a = T(0.28) * K4a_2 + T(0.96) * minus_K4a_3;
  // invD4a = D4a^-1: 1/D
  const T invD4a = T(1) / D4a;
  // kB4a = invD4a B4a: B/D
  const T kB4a_2 = invD4a * B4a_2;
  const T kB4a_3 = invD4a * B4a_3;
  // kK4a = invD4a K4a: K/D
  const T kK4a_1 = invD4a * K4a_1;
  const T kK4a_2 = invD4a * K4a_2;
  const T minus_kK4a_3 = invD4a * minus_K4a_3;
  // u_4a = b4_1 . np4: drives it [N m], [N]
  const T u_4a = T(0.28) * np4_2 - T(0.96) * np4_3;
  // v4a = invD4a u_4a: u/D
  const T v4a = invD4a * u_4a;
  // M4a = Mp4 - kB4a B4a^T: MA less what the turn takes up [kg]
  const T M4a_22 = Mp4_22 - kB4a_2 * B4a_2;
  const T M4a_23 = Mp4_23 - kB4a_2 * B4a_3;
  const T M4a_33 = Mp4_33 - kB4a_3 * B4a_3;
  // H4a = Hp4 - kK4a B4a^T: HA less what the turn takes up [kg m]
  const T H4a_12 = Hp4_12 - kK4a_1 * B4a_2;
  const T H4a_13 = Hp4_13 - kK4a_1 * B4a_3;
  const T H4a_22 = Hp4_22 - kK4a_2 * B4a_2;
  const T H4a_23 = Hp4_23 - kK4a_2 * B4a_3;
  const T H4a_32 = Hp4_32 + minus_kK4a_3 * B4a_2;
  const T H4a_33 = Hp4_33 + minus_kK4a_3 * B4a_3;
  // J4a = Jp4 - kK4a K4a^T: JA less what the turn takes up [kg m^2]
  const T J4a_11 = Jp4_11 - kK4a_1 * K4a_1;
  const T J4a_12 = Jp4_12 - kK4a_1 * K4a_2;
  const T J4a_13 = Jp4_13 + kK4a_1 * minus_K4a_3;
  const T J4a_22 = Jp4_22 - kK4a_2 * K4a_2;
  const T J4a_23 = kK4a_2 * minus_K4a_3 - minus_Jp4_23;
  const T J4a_33 = Jp4_33 - minus_kK4a_3 * minus_K4a_3;
  // gt4a = gp4 - v4a B4a: force with the turn solved [N]
  const T gt4a_2 = gp4_2 - v4a * B4a_2;
  const T gt4a_3 = gp4_3 - v4a * B4a_3;
  // nt4a = np4 - v4a K4a: moment with the turn solved [N m]
  const T minus_nt4a_1 = minus_np4_1 + v4a * K4a_1;
  const T nt4a_2 = np4_2 - v4a * K4a_2;
  const T nt4a_3 = np4_3 + v4a * minus_K4a_3;
  // Mp4a = E4a^T M4a E4a: M passed on, lower body's axes [kg]
  const T b4_12 = minus_E4a_12 * Mp4_12;
  const T b4_13 = E4a_11 * Mp4_11 + b4_12 - minus_E4a_13 * minus_Mp4_13;
  const T b4_14 = E4a_11 * Mp4_12 + minus_E4a_12 * M4a_22 + minus_E4a_13 * M4a_23;
  const T b4_15 = minus_E4a_12 * M4a_23 - E4a_11 * minus_Mp4_13 + minus_E4a_13 * M4a_33;
  const T Mp4a_11 = b4_13 * E4a_11 + b4_14 * minus_E4a_12 + b4_15 * minus_E4a_13;
  const T Mp4a_12 = b4_14 * E4a_22 - b4_13 * minus_E4a_12 + b4_15 * E4a_23;
  const T Mp4a_13 = b4_14 * E4a_23 - b4_13 * minus_E4a_13 + b4_15 * E4a_33;
  const T b4_16 = E4a_22 * M4a_22 - b4_12 + E4a_23 * M4a_23;
  const T b4_17 = E4a_22 * Mp4_12 - minus_E4a_12 * Mp4_11 - E4a_23 * minus_Mp4_13;
  const T b4_18 = minus_E4a_12 * minus_Mp4_13 + E4a_22 * M4a_23 + E4a_23 * M4a_33;
  const T Mp4a_22 = b4_16 * E4a_22 - b4_17 * minus_E4a_12 + b4_18 * E4a_23;
  const T Mp4a_23 = b4_16 * E4a_23 - b4_17 * minus_E4a_13 + b4_18 * E4a_33;
  const T Mp4a_33 = Mp4_11 + M4a_22 + M4a_33 - Mp4a_11 - Mp4a_22;
  // gp4a = E4a^T gt4a: force passed on, lower body's axes [N]
  const T gp4a_1 = E4a_11 * gp4_1 + minus_E4a_12 * gt4a_2 + minus_E4a_13 * gt4a_3;
  const T gp4a_2 = E4a_22 * gt4a_2 - minus_E4a_12 * gp4_1 + E4a_23 * gt4a_3;
  const T gp4a_3 = E4a_23 * gt4a_2 - minus_E4a_13 * gp4_1 + E4a_33 * gt4a_3;
  // Hp4a = E4a^T H4a E4a: H passed on, lower body's axes [kg m]
  const T b4_19 = E4a_11 * H4a_12 + minus_E4a_12 * H4a_22 + minus_E4a_13 * H4a_32;
  const T b4_20 = E4a_11 * H4a_13 + minus_E4a_12 * H4a_23 + minus_E4a_13 * H4a_33;
  const T Hp4a_11 = b4_19 * minus_E4a_12 + b4_20 * minus_E4a_13;
  const T Hp4a_12 = b4_19 * E4a_22 + b4_20 * E4a_23;
  const T Hp4a_13 = b4_19 * E4a_23 + b4_20 * E4a_33;
  const T b4_21 = E4a_22 * H4a_22 - minus_E4a_12 * H4a_12 + E4a_23 * H4a_32;
  const T b4_22 = E4a_22 * H4a_23 - minus_E4a_12 * H4a_13 + E4a_23 * H4a_33;
  const T Hp4a_21 = b4_21 * minus_E4a_12 + b4_22 * minus_E4a_13;
  const T Hp4a_22 = b4_21 * E4a_22 + b4_22 * E4a_23;
  const T Hp4a_23 = b4_21 * E4a_23 + b4_22 * E4a_33;
  const T b4_23 = E4a_23 * H4a_22 - minus_E4a_13 * H4a_12 + E4a_33 * H4a_32;
  const T b4_24 = E4a_23 * H4a_23 - minus_E4a_13 * H4a_13 + E4a_33 * H4a_33;
  const T Hp4a_31 = b4_23 * minus_E4a_12 + b4_24 * minus_E4a_13;
  const T Hp4a_32 = b4_23 * E4a_22 + b4_24 * E4a_23;
  const T Hp4a_33 = b4_23 * E4a_23 + b4_24 * E4a_33;
  // Jp4a = E4a^T J4a E4a: J passed on, lower body's axes [kg m^2]
  const T b4_25 = minus_E4a_12 * J4a_12;
  const T b4_26 = E4a_11 * J4a_11 + b4_25 + minus_E4a_13 * J4a_13;
  const T b4_27 = E4a_11 * J4a_12 + minus_E4a_12 * J4a_22 + minus_E4a_13 * J4a_23;
  const T b4_28 = E4a_11 * J4a_13 + minus_E4a_12 * J4a_23 + minus_E4a_13 * J4a_33;
  const T Jp4a_11 = b4_26 * E4a_11 + b4_27 * minus_E4a_12 + b4_28 * minus_E4a_13;
  const T Jp4a_12 = b4_27 * E4a_22 - b4_26 * minus_E4a_12 + b4_28 * E4a_23;
  const T Jp4a_13 = b4_27 * E4a_23 - b4_26 * minus_E4a_13 + b4_28 * E4a_33;
  const T b4_29 = E4a_22 * J4a_22 - b4_25 + E4a_23 * J4a_23;
  const T b4_30 = E4a_22 * J4a_12 - minus_E4a_12 * J4a_11 + E4a_23 * J4a_13;
  const T b4_31 = E4a_22 * J4a_23 - minus_E4a_12 * J4a_13 + E4a_23 * J4a_33;
  const T Jp4a_22 = b4_29 * E4a_22 - b4_30 * minus_E4a_12 + b4_31 * E4a_23;
  const T Jp4a_23 = b4_29 * E4a_23 - b4_30 * minus_E4a_13 + b4_31 * E4a_33;
  const T Jp4a_33 = J4a_11 + J4a_22 + J4a_33 - Jp4a_11 - Jp4a_22;
  // np4a = E4a^T nt4a: moment passed on, lower body's axes [N m]
  const T np4a_1 = minus_E4a_12 * nt4a_2 - E4a_11 * minus_nt4a_1 + minus_E4a_13 * nt4a_3;
  const T np4a_2 = minus_E4a_12 * minus_nt4a_1 + E4a_22 * nt4a_2 + E4a_23 * nt4a_3;
  const T np4a_3 = minus_E4a_13 * minus_nt4a_1 + E4a_23 * nt4a_2 + E4a_33 * nt4a_3;
  // Hb4a = q4a~ Mp4a + Hp4a: H of the joint at the lower body's origin, its axes
  const T b4_32 = T(0.1) * Mp4a_13;
  const T Hb4a_11 = b4_32 + Hp4a_11;
  const T Hb4a_12 = Hp4a_12 + T(0.1) * Mp4a_23;
  const T Hb4a_13 = Hp4a_13 + T(0.1) * Mp4a_33;
  const T Hb4a_21 = Hp4a_21 + T(0.2) * Mp4a_13;
  const T b4_33 = T(0.2) * Mp4a_23;
  const T Hb4a_22 = b4_33 + Hp4a_22;
  const T Hb4a_23 = Hp4a_23 + T(0.2) * Mp4a_33;
  const T Hb4a_31 = Hp4a_31 - T(0.2) * Mp4a_12 - T(0.1) * Mp4a_11;
  const T Hb4a_32 = Hp4a_32 - T(0.2) * Mp4a_22 - T(0.1) * Mp4a_12;
  const T Hb4a_33 = Hp4a_33 - (b4_33 + b4_32);

  // ---- body 3 (boom) and what it carries
  // HA3 = m3 r3~ + Hb6: moment for an acceleration of the origin, body axes [kg m]
  const T minus_HA3_23 = minus_Hb6_23 + T(0.30000000000000004);
  // JA3 = -m3 r3~ r3~ + I3 + d6~ Hs6^T + Js6 - Hb6 d6~: moment for an angular acceleration, body axes [kg m^2]
  const T JA3_13 = T(5e-04) - d6_1 * T(0.005);
  const T b3_1 = d6_1 * T(0.05) + minus_Hb6_23 * d6_1;
  const T JA3_22 = T(0.12100000000000001) + b3_1;
  const T JA3_33 = T(0.0916) + b3_1;
  // g3 = G3 + gs6: force that drives it, home axes [N]
  const T g3_1 = minus_effort_telescope_6 - minus_G3_1;
  const T g3_2 = G6_2 - minus_G3_2;
  const T minus_g3_3 = minus_G3_3 + minus_G6_3;
  // n3 = r3~ G3 + d6~ gs6 + N3 + ns6: moment that drives it, body axes [N m]
  const T n3_1 = n6_1 - minus_N3_1 - T(0.02) * minus_G3_3;
  const T n3_2 = ns6_2 - minus_N3_2 + T(0.2) * minus_G3_3 + d6_1 * minus_G6_3;
  const T n3_3 = n6_3 - minus_N3_3 + T(0.02) * minus_G3_1 - T(0.2) * minus_G3_2 + d6_1 * G6_2;
  // B3 = HA3^T b3: force of a unit of the angle's acceleration [kg m]
  const T B3_2 = T(0.0015763557945883155) + minus_HA3_23 * T(0.8388422987658062);
  const T minus_B3_3 = T(0.009458134767529894) + minus_HA3_23 * T(0.44378789320576517);
  // K3 = JA3 b3: its moment about the body origin, body axes [kg m^2]
  const T K3_1 = JA3_13 * T(0.8388422987658062) - T(0.01490619534174373);
  const T K3_2 = JA3_22 * T(0.44378789320576517) - T(0.001255442260626766);
  const T K3_3 = JA3_33 * T(0.8388422987658062) - (JA3_13 * T(0.3152711589176631) + T(0.0013313636796172955));
  // D3 = b3 . K3: pivot: inertia that the angle feels [kg m^2]
  const T D3 = T(0.44378789320576517) * K3_2 - T(0.3152711589176631) * K3_1 + T(0.8388422987658062) * K3_3;
  // invD3 = D3^-1: 1/D
  const T invD3 = T(1) / D3;
  // kB3 = invD3 B3: B/D
  const T minus_kB3_1 = invD3 * T(0.025165268962974188);
  const T kB3_2 = invD3 * B3_2;
  const T minus_kB3_3 = invD3 * minus_B3_3;
  // kK3 = invD3 K3: K/D
  const T kK3_1 = invD3 * K3_1;
  const T kK3_2 = invD3 * K3_2;
  const T kK3_3 = invD3 * K3_3;
  // u_3 = b3 . n3 + effort_boom_3: drives it [N m], [N]
  const T u_3 = effort_boom_3 + T(0.44378789320576517) * n3_2 - T(0.3152711589176631) * n3_1 + T(0.8388422987658062) *
      n3_3;
  // v3 = invD3 u_3: u/D
  const T v3 = invD3 * u_3;
  // M3 = MA3 - kB3 B3^T: MA less what the turn takes up [kg]
  const T M3_11 = T(1.5) - minus_kB3_1 * T(0.025165268962974188);
  const T M3_12 = minus_kB3_1 * B3_2;
  const T minus_M3_13 = minus_kB3_1 * minus_B3_3;
  const T M3_22 = T(2) - kB3_2 * B3_2;
  const T M3_23 = kB3_2 * minus_B3_3;
  const T M3_33 = T(2) - minus_kB3_3 * minus_B3_3;
  // H3 = HA3 - kK3 B3^T: HA less what the turn takes up [kg m]
  const T H3_11 = kK3_1 * T(0.025165268962974188);
  const T minus_H3_12 = T(0.005) + kK3_1 * B3_2;
  const T H3_13 = T(0.03) + kK3_1 * minus_B3_3;
  const T H3_21 = kK3_2 * T(0.025165268962974188);
  const T minus_H3_22 = kK3_2 * B3_2;
  const T H3_23 = kK3_2 * minus_B3_3 - minus_HA3_23;
  const T H3_31 = kK3_3 * T(0.025165268962974188) - T(0.03);
  const T H3_32 = minus_HA3_23 - kK3_3 * B3_2;
  const T H3_33 = kK3_3 * minus_B3_3;
  // J3 = JA3 - kK3 K3^T: JA less what the turn takes up [kg m^2]
  const T J3_11 = T(0.04165) - kK3_1 * K3_1;
  const T minus_J3_12 = T(0.004) + kK3_1 * K3_2;
  const T J3_13 = JA3_13 - kK3_1 * K3_3;
  const T J3_22 = JA3_22 - kK3_2 * K3_2;
  const T minus_J3_23 = T(0.003) + kK3_2 * K3_3;
  const T J3_33 = JA3_33 - kK3_3 * K3_3;
  // gt3 = g3 - v3 B3: force with the turn solved [N]
  const T gt3_1 = g3_1 + v3 * T(0.025165268962974188);
  const T gt3_2 = g3_2 - v3 * B3_2;
  const T gt3_3 = v3 * minus_B3_3 - minus_g3_3;
  // nt3 = n3 - v3 K3: moment with the turn solved [N m]
  const T nt3_1 = n3_1 - v3 * K3_1;
  const T nt3_2 = n3_2 - v3 * K3_2;
  const T nt3_3 = n3_3 - v3 * K3_3;
  // Mp3 = E3^T M3 E3: M passed on, lower body's axes [kg]
  const T b3_2 = E3_11 * M3_11 + E3_21 * M3_12 - E3_31 * minus_M3_13;
  const T b3_3 = E3_11 * M3_12 + E3_21 * M3_22 + E3_31 * M3_23;
  const T b3_4 = E3_21 * M3_23 - E3_11 * minus_M3_13 + E3_31 * M3_33;
  const T Mp3_11 = b3_2 * E3_11 + b3_3 * E3_21 + b3_4 * E3_31;
  const T Mp3_12 = b3_2 * E3_12 + b3_3 * E3_22 + b3_4 * E3_32;
  const T Mp3_13 = b3_3 * E3_23 - b3_2 * minus_E3_13 + b3_4 * E3_33;
  const T b3_5 = E3_12 * M3_11 + E3_22 * M3_12 - E3_32 * minus_M3_13;
  const T b3_6 = E3_12 * M3_12 + E3_22 * M3_22 + E3_32 * M3_23;
  const T b3_7 = E3_22 * M3_23 - E3_12 * minus_M3_13 + E3_32 * M3_33;
  const T Mp3_22 = b3_5 * E3_12 + b3_6 * E3_22 + b3_7 * E3_32;
  const T Mp3_23 = b3_6 * E3_23 - b3_5 * minus_E3_13 + b3_7 * E3_33;
  const T Mp3_33 = M3_11 + M3_22 + M3_33 - Mp3_11 - Mp3_22;
  // gp3 = E3^T gt3: force passed on, lower body's axes [N]
  const T gp3_1 = E3_11 * gt3_1 + E3_21 * gt3_2 + E3_31 * gt3_3;
  const T gp3_2 = E3_12 * gt3_1 + E3_22 * gt3_2 + E3_32 * gt3_3;
  const T gp3_3 = E3_23 * gt3_2 - minus_E3_13 * gt3_1 + E3_33 * gt3_3;
  // Hp3 = E3^T H3 E3: H passed on, lower body's axes [kg m]
  const T b3_8 = E3_11 * H3_11 + E3_21 * H3_21 + E3_31 * H3_31;
  const T b3_9 = E3_31 * H3_32 - (E3_11 * minus_H3_12 + E3_21 * minus_H3_22);
  const T b3_10 = E3_11 * H3_13 + E3_21 * H3_23 + E3_31 * H3_33;
  const T Hp3_11 = b3_8 * E3_11 + b3_9 * E3_21 + b3_10 * E3_31;
  const T Hp3_12 = b3_8 * E3_12 + b3_9 * E3_22 + b3_10 * E3_32;
  const T Hp3_13 = b3_9 * E3_23 - b3_8 * minus_E3_13 + b3_10 * E3_33;
  const T b3_11 = E3_12 * H3_11 + E3_22 * H3_21 + E3_32 * H3_31;
  const T b3_12 = E3_32 * H3_32 - (E3_12 * minus_H3_12 + E3_22 * minus_H3_22);
  const T b3_13 = E3_12 * H3_13 + E3_22 * H3_23 + E3_32 * H3_33;
  const T Hp3_21 = b3_11 * E3_11 + b3_12 * E3_21 + b3_13 * E3_31;
  const T Hp3_22 = b3_11 * E3_12 + b3_12 * E3_22 + b3_13 * E3_32;
  const T Hp3_23 = b3_12 * E3_23 - b3_11 * minus_E3_13 + b3_13 * E3_33;
  const T b3_14 = E3_23 * H3_21 - minus_E3_13 * H3_11 + E3_33 * H3_31;
  const T b3_15 = minus_E3_13 * minus_H3_12 - E3_23 * minus_H3_22 + E3_33 * H3_32;
  const T b3_16 = E3_23 * H3_23 - minus_E3_13 * H3_13 + E3_33 * H3_33;
  const T Hp3_31 = b3_14 * E3_11 + b3_15 * E3_21 + b3_16 * E3_31;
  const T Hp3_32 = b3_14 * E3_12 + b3_15 * E3_22 + b3_16 * E3_32;
  const T Hp3_33 = b3_15 * E3_23 - b3_14 * minus_E3_13 + b3_16 * E3_33;
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_17 = E3_11 * J3_11 - E3_21 * minus_J3_12 + E3_31 * J3_13;
  const T b3_18 = E3_21 * J3_22 - E3_11 * minus_J3_12 - E3_31 * minus_J3_23;
  const T b3_19 = E3_11 * J3_13 - E3_21 * minus_J3_23 + E3_31 * J3_33;
  const T Jp3_11 = b3_17 * E3_11 + b3_18 * E3_21 + b3_19 * E3_31;
  const T Jp3_12 = b3_17 * E3_12 + b3_18 * E3_22 + b3_19 * E3_32;
  const T Jp3_13 = b3_18 * E3_23 - b3_17 * minus_E3_13 + b3_19 * E3_33;
  const T b3_20 = E3_12 * J3_11 - E3_22 * minus_J3_12 + E3_32 * J3_13;
  const T b3_21 = E3_22 * J3_22 - E3_12 * minus_J3_12 - E3_32 * minus_J3_23;
  const T b3_22 = E3_12 * J3_13 - E3_22 * minus_J3_23 + E3_32 * J3_33;
  const T Jp3_22 = b3_20 * E3_12 + b3_21 * E3_22 + b3_22 * E3_32;
  const T Jp3_23 = b3_21 * E3_23 - b3_20 * minus_E3_13 + b3_22 * E3_33;
  const T Jp3_33 = J3_11 + J3_22 + J3_33 - Jp3_11 - Jp3_22;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T np3_1 = E3_11 * nt3_1 + E3_21 * nt3_2 + E3_31 * nt3_3;
  const T np3_2 = E3_12 * nt3_1 + E3_22 * nt3_2 + E3_32 * nt3_3;
  const T np3_3 = E3_23 * nt3_2 - minus_E3_13 * nt3_1 + E3_33 * nt3_3;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T b3_23 = T(0.1) * Mp3_12;
  const T Hb3_11 = Hp3_11 - b3_23;
  const T Hb3_12 = Hp3_12 - T(0.1) * Mp3_22;
  const T Hb3_13 = Hp3_13 - T(0.1) * Mp3_23;
  const T Hb3_21 = Hp3_21 + T(0.1) * Mp3_11 - T(0.3) * Mp3_13;
  const T b3_24 = T(0.3) * Mp3_23;
  const T Hb3_22 = b3_23 - b3_24 + Hp3_22;
  const T Hb3_23 = Hp3_23 + T(0.1) * Mp3_13 - T(0.3) * Mp3_33;
  const T Hb3_31 = Hp3_31 + T(0.3) * Mp3_12;
  const T Hb3_32 = Hp3_32 + T(0.3) * Mp3_22;
  const T Hb3_33 = b3_24 + Hp3_33;

  // ---- body 2 (clapper) and what it carries
  // n2 = r2~ G2 + N2: moment that drives it, body axes [N m]
  const T minus_n2_1 = minus_N2_1 + T(0.2) * minus_G2_2 + T(0.02) * minus_G2_3;
  const T n2_2 = T(0.2) * minus_G2_1 - minus_N2_2;
  const T n2_3 = T(0.02) * minus_G2_1 - minus_N2_3;
  // w_2 = D(LD2)^-1 L(LD2)^-1 n2: D^-1 L^-1 n
  const T minus_w_2_1 = T(23.62948960302457) * minus_n2_1;
  const T w_2_2 = T(23.25581395348837) * n2_2;
  const T w_2_3 = T(244.9863263445761) * (n2_3 - T(0.07441860465116279) * n2_2);
  // gb2 = G2 - Y2^T w_2: force with the ball solved [N]
  const T gb2_1 = T(0.16000000000000003) * w_2_2 - minus_G2_1 + T(0.004093023255813953) * w_2_3;
  const T gb2_2 = T(0.16000000000000003) * minus_w_2_1 - minus_G2_2;
  const T gb2_3 = T(0.016) * minus_w_2_1 - minus_G2_3;
  // Mb2 = C2^T M2 C2: M of the joint, lower body's axes
  const T b2_1 = C2_11 * T(0.20054694621695532);
  const T b2_2 = C2_21 * T(0.19508506616257087) - C2_31 * T(0.06049149338374291);
  const T b2_3 = C2_31 * T(0.7939508506616257) - C2_21 * T(0.06049149338374291);
  const T Mb2_11 = b2_1 * C2_11 + b2_2 * C2_21 + b2_3 * C2_31;
  const T Mb2_12 = b2_1 * C2_12 + b2_2 * C2_22 + b2_3 * C2_32;
  const T Mb2_13 = b2_1 * C2_13 + b2_2 * C2_23 + b2_3 * C2_33;
  const T b2_4 = C2_12 * T(0.20054694621695532);
  const T b2_5 = C2_22 * T(0.19508506616257087) - C2_32 * T(0.06049149338374291);
  const T b2_6 = C2_32 * T(0.7939508506616257) - C2_22 * T(0.06049149338374291);
  const T Mb2_22 = b2_4 * C2_12 + b2_5 * C2_22 + b2_6 * C2_32;
  const T Mb2_23 = b2_4 * C2_13 + b2_5 * C2_23 + b2_6 * C2_33;
  const T Mb2_33 = T(1.189582863041152) - Mb2_11 - Mb2_22;
  // Hb2 = q2~ Mb2: H of the joint at the lower body's origin, its axes
  const T b2_7 = T(0.2) * Mb2_12;
  const T b2_8 = T(0.1) * Mb2_13;
  const T Hb2_11 = b2_7 + b2_8;
  const T b2_9 = T(0.2) * Mb2_22;
  const T Hb2_12 = b2_9 + T(0.1) * Mb2_23;
  const T b2_10 = T(0.2) * Mb2_23;
  const T Hb2_13 = b2_10 + T(0.1) * Mb2_33;
  const T b2_11 = T(0.2) * Mb2_13;
  const T minus_Hb2_21 = b2_11 + T(0.2) * Mb2_11;
  const T minus_Hb2_22 = b2_7 + b2_10;
  const T minus_Hb2_23 = b2_11 + T(0.2) * Mb2_33;
  const T Hb2_31 = b2_7 - T(0.1) * Mb2_11;
  const T Hb2_32 = b2_9 - T(0.1) * Mb2_12;
  const T Hb2_33 = b2_10 - b2_8;

  // ---- body 1 (hull) and what it carries
  // MA1 = m1 one + Ms2_10 + Ms2_8 + Mp5a + Mp4a + Mp3 + Mb2: force for an acceleration of the origin, home axes [kg]
  const T MA1_11 = T(8) + Ms2_10_11 + Ms2_8_11 + Mp5a_11 + Mp4a_11 + Mp3_11 + Mb2_11;
  const T MA1_12 = Mp5a_12 + Mp4a_12 + Mp3_12 + Mb2_12;
  const T MA1_13 = Ms2_10_13 + Ms2_8_13 + Mp4a_13 + Mp3_13 + Mb2_13;
  const T MA1_22 = T(8) + Mp5a_22 + Mp4a_22 + Mp3_22 + Mb2_22;
  const T MA1_23 = Mp4a_23 + Mp3_23 + Mb2_23;
  const T MA1_33 = T(8) + Ms2_10_33 + Ms2_8_33 + c.m_link5 + Mp4a_33 + Mp3_33 + Mb2_33;
  // HA1 = m1 r1~ + Hb2 + Hb3 + Hb4a + Hb5a + Hb8 + Hb10: moment for an acceleration of the origin, body axes [kg m]
  const T HA1_11 = Hb2_11 + Hb3_11 + Hb4a_11 - minus_Hb5a_11 + Hb8_11 + Hb10_11;
  const T HA1_12 = Hb2_12 - T(0.24) + Hb3_12 + Hb4a_12 + Hb5a_12;
  const T HA1_13 = Hb2_13 - T(0.08) + Hb3_13 + Hb4a_13 - minus_Hb5a_13 + Hb8_13 + Hb10_13;
  const T HA1_21 = T(0.24) - minus_Hb2_21 + Hb3_21 + Hb4a_21 + Hb5a_21 + Hb10_21;
  const T HA1_22 = Hb3_22 - minus_Hb2_22 + Hb4a_22 + Hb5a_22;
  const T HA1_23 = Hb3_23 - (minus_Hb2_23 + T(0.16)) + Hb4a_23 - minus_Hp5a_23 + Hb10_23;
  const T HA1_31 = Hb2_31 + T(0.08) + Hb3_31 + Hb4a_31 + Hb5a_31 + Hb8_31 - minus_Hb10_31;
  const T HA1_32 = T(0.16) + Hb2_32 + Hb3_32 + Hb4a_32 + Hb5a_32;
  const T HA1_33 = Hb2_33 + Hb3_33 + Hb4a_33 + Hb8_33 - Hb10_11;
  // JA1 = q3~ Hp3^T + q4a~ Hp4a^T + q5a~ Hp5a^T - m1 r1~ r1~ + I1 + d8~ Hs2_8^T + Js2_8 + Jp5a + Jp4a + Jp3 - Hb2 q2~
  //   - Hb3 q3~ - Hb4a q4a~ - Hb5a q5a~ - Hb8 d8~ - Hb10 d10~: moment for an angular acceleration, body axes [kg m^2]
  const T b1_1 = Hb2_12 * T(0.2);
  const T JA1_11 = T(0.608) + Js2_8_11 + Jp5a_11 + Jp4a_11 + Jp3_11 + b1_1 + T(0.1) * Hp4a_13 - T(0.1) * Hp3_12 +
      T(0.3) * minus_Hp5a_13 - T(0.1) * Hp5a_12 + d8_2 * Hs2_8_13 + Hb2_13 * T(0.1) - Hb3_12 * T(0.1) + Hb4a_13 *
      T(0.1) - Hb5a_12 * T(0.1) + minus_Hb5a_13 * T(0.3) + Hb8_13 * d8_2 + Hb10_13 * s10;
  const T JA1_12 = T(0.0216) + Jp5a_12 + Jp4a_12 + Jp3_12 + T(0.1) * Hp4a_23 - T(0.1) * Hp3_22 - T(0.1) * Hp5a_22 +
      T(0.3) * minus_Hp5a_23 - Hb2_11 * T(0.2) - Hb2_13 * T(0.2) - Hb3_13 * T(0.3) + Hb3_11 * T(0.1) + Hb4a_13 *
      T(0.2) - minus_Hb5a_11 * T(0.1) - Hb10_13 * T(0.1) + Hb10_11 * T(0.3);
  const T JA1_13 = Js2_8_13 - T(0.0148) + Jp4a_13 + Jp3_13 + b1_1 + T(0.1) * Hp4a_33 - T(0.1) * Hp3_32 + d8_2 *
      Hs2_8_33 - Hb2_11 * T(0.1) + Hb3_12 * T(0.3) - Hb4a_11 * T(0.1) - Hb4a_12 * T(0.2) - minus_Hb5a_11 * T(0.3) -
      Hb8_11 * d8_2 - Hb10_11 * s10;
  const T JA1_22 = T(0.5104) + Jp5a_22 + Jp4a_22 + Jp3_22 + T(0.1) * Hp3_21 - T(0.3) * Hp3_23 + T(0.2) * Hp4a_23 +
      T(0.1) * Hp5a_21 + minus_Hb2_21 * T(0.2) + minus_Hb2_23 * T(0.2) - Hb3_23 * T(0.3) + Hb3_21 * T(0.1) + Hb4a_23 *
      T(0.2) + Hb5a_21 * T(0.1) - Hb10_23 * T(0.1) + Hb10_21 * T(0.3);
  const T JA1_23 = T(0.0324) + Jp4a_23 + Jp3_23 + T(0.1) * Hp3_31 - T(0.3) * Hp3_33 + T(0.2) * Hp4a_33 - minus_Hb2_22
      * T(0.2) + minus_Hb2_21 * T(0.1) + Hb3_22 * T(0.3) - Hb4a_21 * T(0.1) - Hb4a_22 * T(0.2) + Hb5a_21 * T(0.3) -
      Hb10_21 * s10;
  const T JA1_33 = T(0.704) + Js2_8_33 + Jp4a_33 + Jp3_33 + T(0.3) * Hp3_32 - T(0.2) * Hp4a_32 - T(0.1) * Hp4a_31 -
      d8_2 * Hs2_8_31 - Hb2_31 * T(0.1) + Hb2_32 * T(0.2) + Hb3_32 * T(0.3) - Hb4a_31 * T(0.1) - Hb4a_32 * T(0.2) +
      Hb5a_31 * T(0.3) - Hb8_31 * d8_2 + minus_Hb10_31 * s10;
  // g1 = C2^T gb2 + G1 + gs2_10 + gs2_8 + gp5a + gp4a + gp3: force that drives it, home axes [N]
  const T b1_2 = C2_11 * gb2_1 + C2_21 * gb2_2 + C2_31 * gb2_3;
  const T g1_1 = b1_2 + G1_1 + gs2_10_1 + gs2_8_1 + gp5a_1 + gp4a_1 + gp3_1;
  const T b1_3 = C2_12 * gb2_1 + C2_22 * gb2_2 + C2_32 * gb2_3;
  const T g1_2 = b1_3 + G1_2 + gp5a_2 + gp4a_2 + gp3_2;
  const T b1_4 = C2_13 * gb2_1 + C2_23 * gb2_2 + C2_33 * gb2_3;
  const T g1_3 = b1_4 + G1_3 + gs2_10_3 + gs2_8_3 + gp5_3 + gp4a_3 + gp3_3;
  // n1 = q2~ C2^T gb2 + q3~ gp3 + q4a~ gp4a + q5a~ gp5a + r1~ G1 + d8~ gs2_8 + d10~ gs2_10 + N1 + ns2_8 + np5a + np4a
  //   + np3: moment that drives it, body axes [N m]
  const T b1_5 = T(0.2) * b1_3;
  const T n1_1 = b1_5 + N1_1 + ns2_8_1 + np5a_1 + np4a_1 + np3_1 + T(0.1) * b1_4 - T(0.1) * gp3_2 + T(0.1) * gp4a_3 -
      T(0.1) * gp5a_2 - T(0.3) * gp5_3 - T(0.03) * G1_2 - T(0.01) * G1_3 + d8_2 * gs2_8_3 + s10 * gs2_10_3;
  const T n1_2 = N1_2 + np5a_2 + np4a_2 + np3_2 - T(0.2) * b1_2 - T(0.2) * b1_4 + T(0.1) * gp3_1 - T(0.3) * gp3_3 +
      T(0.2) * gp4a_3 + T(0.1) * gp5a_1 + T(0.03) * G1_1 - T(0.02) * G1_3 + T(0.3) * gs2_10_1 - T(0.1) * gs2_10_3;
  const T n1_3 = b1_5 - minus_N1_3 + ns2_8_3 + np4a_3 + np3_3 - T(0.1) * b1_2 + T(0.3) * gp3_2 - T(0.2) * gp4a_2 -
      T(0.1) * gp4a_1 + T(0.3) * gp5a_1 + T(0.02) * G1_2 + T(0.01) * G1_1 - d8_2 * gs2_8_1 - s10 * gs2_10_1;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T LD1_21 = LD1_11 * JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - LD1_21 * JA1_12);
  const T LD1_31 = LD1_11 * JA1_13;
  const T b1_6 = JA1_23 - LD1_21 * JA1_13;
  const T LD1_32 = LD1_22 * b1_6;
  const T LD1_33 = T(1) / (JA1_33 - LD1_31 * JA1_13 - LD1_32 * b1_6);
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
  const T b1_7 = n1_2 - LD1_21 * n1_1;
  const T w_1_2 = LD1_22 * b1_7;
  const T w_1_3 = LD1_33 * (n1_3 - LD1_31 * n1_1 - LD1_32 * b1_7);
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
  const T b1_8 = M1_23 - LDs1_21 * M1_13;
  const T LDs1_32 = LDs1_22 * b1_8;
  const T LDs1_33 = T(1) / (M1_33 - LDs1_31 * M1_13 - LDs1_32 * b1_8);
  // ws1 = D(LDs1)^-1 L(LDs1)^-1 gb1: D^-1 L^-1 g
  const T ws1_1 = LDs1_11 * gb1_1;
  const T b1_9 = gb1_2 - LDs1_21 * gb1_1;
  const T ws1_2 = LDs1_22 * b1_9;
  const T ws1_3 = LDs1_33 * (gb1_3 - LDs1_31 * gb1_1 - LDs1_32 * b1_9);

  // ---- body 1 (hull), solved
  // Pddot1 = L(LDs1)^-T ws1
  const T z1_1 = ws1_2 - LDs1_32 * ws1_3;
  const T Pddot1_1 = ws1_1 - LDs1_21 * z1_1 - LDs1_31 * ws1_3;
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
  ydot[16] = sddot1_1;
  ydot[17] = sddot1_2;
  ydot[18] = sddot1_3;

  // ---- body 2 (clapper), solved
  // beta2 = -C2 q2~ omegadot1 + C2 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z2_1 = T(0.2) * z1_2;
  const T z2_2 = z2_1 + T(0.2) * omegadot1_1;
  const T z2_3 = T(0.2) * z1_3;
  const T z2_4 = T(0.1) * z1_2;
  const T z2_5 = z2_3 + z2_4;
  const T z2_6 = T(0.1) * omegadot1_1;
  const T z2_7 = z2_3 - z2_6;
  const T beta2_1 = C2_12 * z2_2 - C2_11 * z2_5 - C2_13 * z2_7 + C2_11 * Pddot1_1 + C2_12 * z1_1 + C2_13 * ws1_3;
  const T beta2_2 = C2_22 * z2_2 - C2_21 * z2_5 - C2_23 * z2_7 + C2_21 * Pddot1_1 + C2_22 * z1_1 + C2_23 * ws1_3;
  const T beta2_3 = C2_32 * z2_2 - C2_31 * z2_5 - C2_33 * z2_7 + C2_31 * Pddot1_1 + C2_32 * z1_1 + C2_33 * ws1_3;
  // omegadot2 = L(LD2)^-T (-W2 beta2 + w_2)
  const T minus_omegadot2_1 = minus_w_2_1 + T(3.780718336483932) * beta2_2 + T(0.3780718336483932) * beta2_3;
  const T z2_8 = w_2_3 + T(1.0027347310847765) * beta2_1;
  const T omegadot2_2 = w_2_2 + T(3.7209302325581395) * beta2_1 - T(0.07441860465116279) * z2_8;
  ydot[3] = -minus_omegadot2_1;
  ydot[4] = omegadot2_2;
  ydot[5] = z2_8;

  // ---- body 3 (boom), solved
  // beta3 = -E3 q3~ omegadot1 + E3 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z3_1 = T(0.1) * z1_3;
  const T z3_2 = T(0.3) * z1_2;
  const T z3_3 = z2_6 - z3_2;
  const T z3_4 = T(0.3) * z1_3;
  const T beta3_1 = E3_11 * z3_1 - E3_12 * z3_3 + minus_E3_13 * z3_4 + E3_11 * Pddot1_1 + E3_12 * z1_1 - minus_E3_13 *
      ws1_3;
  const T beta3_2 = E3_21 * z3_1 - E3_22 * z3_3 - E3_23 * z3_4 + E3_21 * Pddot1_1 + E3_22 * z1_1 + E3_23 * ws1_3;
  const T beta3_3 = E3_31 * z3_1 - E3_32 * z3_3 - E3_33 * z3_4 + E3_31 * Pddot1_1 + E3_32 * z1_1 + E3_33 * ws1_3;
  // alphaL3 = E3 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL3_1 = E3_11 * omegadot1_1 + E3_12 * z1_3 - minus_E3_13 * z1_2;
  const T alphaL3_2 = E3_21 * omegadot1_1 + E3_22 * z1_3 + E3_23 * z1_2;
  const T alphaL3_3 = E3_31 * omegadot1_1 + E3_32 * z1_3 + E3_33 * z1_2;
  // phi3 = -kB3 . beta3 - kK3 . alphaL3 + v3
  const T phi3 = v3 + minus_kB3_1 * beta3_1 - kB3_2 * beta3_2 + minus_kB3_3 * beta3_3 - kK3_1 * alphaL3_1 - kK3_2 *
      alphaL3_2 - kK3_3 * alphaL3_3;
  ydot[6] = phi3;
  // alpha3 = alphaL3 + phi3 b3: angular acceleration beyond that at ydot = 0, body axes [rad/s^2]
  const T alpha3_2 = alphaL3_2 + phi3 * T(0.44378789320576517);

  // ---- body 4 (cross), solved
  // beta4a = -E4a q4a~ omegadot1 + E4a Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z4_1 = z2_3 + z2_6;
  const T beta4a_1 = minus_E4a_12 * z2_1 - E4a_11 * z2_4 - minus_E4a_13 * z4_1 + E4a_11 * Pddot1_1 - minus_E4a_12 *
      z1_1 - minus_E4a_13 * ws1_3;
  const T beta4a_2 = E4a_23 * z4_1 - (minus_E4a_12 * z2_4 + E4a_22 * z2_1) + minus_E4a_12 * Pddot1_1 + E4a_22 * z1_1 +
      E4a_23 * ws1_3;
  const T beta4a_3 = E4a_33 * z4_1 - (minus_E4a_13 * z2_4 + E4a_23 * z2_1) + minus_E4a_13 * Pddot1_1 + E4a_23 * z1_1 +
      E4a_33 * ws1_3;
  // alphaL4a = E4a omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4a_1 = E4a_11 * omegadot1_1 - minus_E4a_12 * z1_3 - minus_E4a_13 * z1_2;
  const T alphaL4a_2 = minus_E4a_12 * omegadot1_1 + E4a_22 * z1_3 + E4a_23 * z1_2;
  const T alphaL4a_3 = minus_E4a_13 * omegadot1_1 + E4a_23 * z1_3 + E4a_33 * z1_2;
  // phi4a = -kB4a . beta4a - kK4a . alphaL4a + v4a
  const T phi4a = v4a - kB4a_2 * beta4a_2 - kB4a_3 * beta4a_3 - kK4a_1 * alphaL4a_1 - kK4a_2 * alphaL4a_2 +
      minus_kK4a_3 * alphaL4a_3;
  ydot[7] = phi4a;
  // alpha4a = alphaL4a + phi4a b4_1: angular acceleration beyond that at ydot = 0, body axes [rad/s^2]
  const T alpha4a_2 = alphaL4a_2 + phi4a * T(0.28);
  const T alpha4a_3 = alphaL4a_3 - phi4a * T(0.96);
  // beta4 = E4 beta4a: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta4_1 = E4_12 * beta4a_2 - minus_E4_11 * beta4a_1 - minus_E4_13 * beta4a_3;
  const T beta4_3 = t4_5 * beta4a_1 + E4_32 * beta4a_2 - minus_E4_33 * beta4a_3;
  // alphaL4 = E4 alpha4a: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4_2 = T(0.96) * alpha4a_2 + T(0.28) * alpha4a_3;
  // phi4 = -kB4 . beta4 + v4 - (P_b4_2 kK4) . alphaL4
  const T phi4 = v4 + T(1.6061867935752527) * beta4_3 - T(5.353955978584176) * beta4_1;
  // thetaddot4_2 = -b4_2 . alphaL4 + phi4
  const T thetaddot4_2 = phi4 - alphaL4_2;
  ydot[8] = thetaddot4_2;

  // ---- body 5 (camera), solved
  // beta5a = -E5a q5a~ omegadot1 + E5a Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z5_1 = z3_1 + z3_2;
  const T beta5a_1 = E5a_11 * z5_1 - E5a_12 * z2_6 + E5a_11 * Pddot1_1 + E5a_12 * z1_1;
  const T beta5a_2 = E5a_11 * z1_1 - (E5a_11 * z2_6 + E5a_12 * z5_1) - E5a_12 * Pddot1_1;
  // alphaL5a = E5a omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL5a_1 = E5a_11 * omegadot1_1 + E5a_12 * z1_3;
  const T alphaL5a_2 = E5a_11 * z1_3 - E5a_12 * omegadot1_1;
  // phi5a = -kB5a . beta5a + v5a - (P_b5_1 kK5a) . alphaL5a
  const T phi5a = v5a - kB5a_1 * beta5a_1 - kB5a_2 * beta5a_2 - kK5a_1 * alphaL5a_1 - kK5a_2 * alphaL5a_2;
  // thetaddot5_1 = -b5_1 . alphaL5a + phi5a
  const T thetaddot5_1 = phi5a - z1_2;
  ydot[9] = thetaddot5_1;

  // ---- body 6 (telescope), solved
  // phi6 = -kK6 . alpha3 + v6 - (P_u6 kB6) . Pj6
  const T phi6 = v6 - T(0.01) * alpha3_2;
  // sddot6 = -u6 . Pj6 + phi6
  const T sddot6 = phi6 - beta3_1;
  ydot[19] = sddot6;

  // ---- body 8 (piston), solved
  // Pj2_8 = -d8~ omegadot1 + Pddot1: acceleration of the joint beyond that at ydot = 0 [m/s^2]
  const T Pj2_8_1 = Pddot1_1 - d8_2 * z1_2;
  const T Pj2_8_3 = ws1_3 + d8_2 * omegadot1_1;
  // phi2_8 = -kK2_8 . omegadot1 + v2_8 - (P_u8 kB2_8) . Pj2_8
  const T phi2_8 = minus_kK2_8_1 * omegadot1_1 - minus_v2_8 + minus_kK2_8_3 * z1_2 + minus_kB2_8_1 * Pj2_8_1 +
      minus_kB2_8_3 * Pj2_8_3;
  // sddot8 = -u8 . Pj2_8 + phi2_8
  const T sddot8 = z1_1 + phi2_8;
  ydot[22] = sddot8;
  // beta8 = E8 P_u8 Pj2_8 + phi2_8 E8 u8: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta8_1 = E8_11 * Pj2_8_1 + E8_13 * Pj2_8_3;
  const T beta8_3 = E8_11 * Pj2_8_3 - E8_13 * Pj2_8_1;
  // alphaL8 = E8 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL8_1 = E8_11 * omegadot1_1 + E8_13 * z1_2;
  const T alphaL8_3 = E8_11 * z1_2 - E8_13 * omegadot1_1;
  // phi8 = -kB1_8 . beta8 + v1_8 - (P_b8 kK1_8) . alphaL8
  const T phi8 = minus_kB1_8_1 * beta8_1 - minus_v1_8 + T(1.2038983374737244) * phi2_8 + minus_kB1_8_3 * beta8_3 +
      minus_kK1_8_1 * alphaL8_1 + minus_kK1_8_3 * alphaL8_3;
  // thetaddot8 = -b8 . alphaL8 + phi8
  const T thetaddot8 = z1_3 + phi8;
  ydot[10] = thetaddot8;

  // ---- body 9 (sled), solved
  // phi2_9 = v2_9 - (P_u9_1 kB2_9) . Pj2_9
  const T phi2_9 = v2_9 - kB2_9_2 * v3_9;
  ydot[23] = phi2_9;
  // beta9 = E9 P_u9_1 Pj2_9 + phi2_9 E9 u9_1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta9_2 = E9_11 * v3_9 - phi2_9 * E9_12;
  // phi9 = -kB1_9 . beta9 + v1_9
  const T minus_phi9 = minus_v1_9 + T(2) * beta9_2;
  ydot[11] = -minus_phi9;

  // ---- body 10 (runner), solved
  // Pj2_10 = -d10~ omegadot1 + Pddot1: acceleration of the joint beyond that at ydot = 0 [m/s^2]
  const T Pj2_10_1 = z3_4 + Pddot1_1 - s10 * z1_2;
  const T Pj2_10_2 = z2_4 + z1_1 - T(0.3) * omegadot1_1;
  const T Pj2_10_3 = ws1_3 - z3_1 + s10 * omegadot1_1;
  // phi2_10 = v2_10 - (P_u10 kB2_10) . Pj2_10
  const T phi2_10 = v2_10 - kB2_10_1 * Pj2_10_1 - kB2_10_3 * Pj2_10_3;
  // sddot10 = -u10 . Pj2_10 + phi2_10
  const T sddot10 = phi2_10 - Pj2_10_2;
  ydot[25] = sddot10;
  // beta10 = C10 P_u10 Pj2_10 + phi2_10 C10 u10: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta10_1 = C10_11 * Pj2_10_1 + C10_13 * Pj2_10_3 + phi2_10 * C10_12;
  const T beta10_2 = C10_21 * Pj2_10_1 + C10_23 * Pj2_10_3 + phi2_10 * C10_22;
  const T beta10_3 = C10_31 * Pj2_10_1 + C10_33 * Pj2_10_3 + phi2_10 * C10_32;
  // omegadot10 = L(LD10)^-T (-W10 beta10 + w_10)
  const T z10_1 = w_10_3 + T(1.3339009507591884) * beta10_1 - T(2.5400879807010077) * beta10_2 +
      T(0.04257130693912303) * beta10_3;
  const T z10_2 = w_10_2 + T(3.411675511751327) * beta10_1 - T(0.11372251705837756) * beta10_2 + T(2.2365428354814254)
      * beta10_3 - T(0.03639120545868082) * z10_1;
  const T omegadot10_1 = w_10_1 - T(5) * beta10_2 - T(1.6666666666666667) * beta10_3 + T(0.03333333333333333) * z10_2
      - T(0.1) * z10_1;
  ydot[12] = omegadot10_1;
  ydot[13] = z10_2;
  ydot[14] = z10_1;

  // ---- body 11 (nut), solved
  // beta11 = -E11 d11~ alpha8 + E11 beta8: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta11_1 = minus_d11_2 * alphaL8_3 * E11_11 - minus_d11_2 * alphaL8_1 * E11_13 + E11_11 * beta8_1 + E11_13 *
      beta8_3;
  // alphaL11 = E11 alpha8: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL11_1 = E11_11 * alphaL8_1 + E11_13 * alphaL8_3;
  // phi11 = -kB11 . beta11 - kK11 . alphaL11 + v11
  const T phi11 = v11 + T(4.545454545454546) * beta11_1 - T(4.545454545454546) * phi2_8 - T(0.045454545454545456) *
      alphaL11_1 - T(0.9545454545454546) * phi8;
  ydot[15] = phi11;

  // ---- results
  ydot[20] = -T(0);
  ydot[21] = -T(0);
  ydot[26] = -T(0);
  ydot[27] = T(0);
  ydot[28] = -T(9.81);
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 839 add, 989 multiply, 2 divide, 1 square root, 19 sine or cosine, 3 other function
template <class T>
void residual(const Prepared<T>& c, T t, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r) noexcept {
  using std::abs, std::cos, std::exp, std::sin, std::sqrt, std::tanh;
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[16], sddot1_2 = ydot[17], sddot1_3 = ydot[18];
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
  const T U1_13 = omegadot1_2 + t1_16;
  const T U1_21 = t1_15 + omegadot1_3;
  const T t1_17 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_17 + t1_13;
  const T t1_18 = omega1_3 * omega1_2;
  const T U1_23 = t1_18 - omegadot1_1;
  const T U1_31 = t1_16 - omegadot1_2;
  const T U1_32 = t1_18 + omegadot1_1;
  const T minus_U1_33 = t1_17 + t1_14;
  // Pddot1 = R1 (-g + sddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t1_19 = sddot1_3 + T(9.81);
  const T Pddot1_1 = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * t1_19;
  const T Pddot1_2 = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * t1_19;
  const T Pddot1_3 = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * t1_19;
  // a1 = U1 r1 + Pddot1: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T t1_20 = U1_13 * T(0.03);
  const T a1_1 = t1_20 + Pddot1_1 - minus_U1_11 * T(0.02) - U1_12 * T(0.01);
  const T a1_2 = Pddot1_2 + U1_21 * T(0.02) + minus_U1_22 * T(0.01) + U1_23 * T(0.03);
  const T t1_21 = U1_31 * T(0.02);
  const T a1_3 = t1_21 + Pddot1_3 - U1_32 * T(0.01) - minus_U1_33 * T(0.03);
  // G1 = -R1 F1 + m1 a1: inertia less applied force, body axes [N]
  const T G1_1 = T(8) * a1_1 - R1_13 * u.thrust;
  const T G1_2 = T(8) * a1_2 - R1_23 * u.thrust;
  const T G1_3 = T(8) * a1_3 - R1_33 * u.thrust;
  // N1 = axial(U1 (tr(I1)/2 - I1)) - M1: inertia less applied moment about the mass centre, body axes [N m]
  const T t1_22 = U1_23 * T(0.2);
  const T N1_1 = T(0.39999999999999997) * U1_32 - (t1_22 + t1_21 + T(0.1)) - T(0.03) * (minus_U1_22 - minus_U1_33) -
      T(0.01) * U1_21;
  const T t1_23 = U1_13 * T(0.2);
  const T t1_24 = U1_31 * T(0.3);
  const T N1_2 = t1_23 - t1_24 + T(0.01) * (minus_U1_33 - minus_U1_11) - T(0.03) * U1_12 + T(0.02) * U1_32 - T(0.2) *
      cos(T(2) * t);
  const T t1_25 = U1_21 * T(0.3);
  const T N1_3 = t1_25 + t1_20 - T(0.39999999999999997) * U1_12 - T(0.02) * (minus_U1_11 - minus_U1_22) + T(0.01) *
      U1_23;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T omegadot2_1 = ydot[3], omegadot2_2 = ydot[4], omegadot2_3 = ydot[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * T(0.2) + R1_21 * T(0.1) - R1_31 * T(0.2);
  const T P2_2 = s1_2 + R1_12 * T(0.2) + R1_22 * T(0.1) - R1_32 * T(0.2);
  const T P2_3 = s1_3 + R1_13 * T(0.2) + R1_23 * T(0.1) - R1_33 * T(0.2);
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_13 = omega2_2 * omega2_1;
  const T U2_12 = t2_13 - omegadot2_3;
  const T t2_14 = omega2_3 * omega2_1;
  const T U2_13 = t2_14 + omegadot2_2;
  const T U2_21 = t2_13 + omegadot2_3;
  const T t2_15 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_15 + omega2_3 * omega2_3;
  const T t2_16 = omega2_3 * omega2_2;
  const T U2_23 = t2_16 - omegadot2_1;
  const T U2_31 = t2_14 - omegadot2_2;
  const T U2_32 = t2_16 + omegadot2_1;
  const T minus_U2_33 = t2_15 + omega2_2 * omega2_2;
  // Pddot2 = R1^T (U1 q2 + Pddot1): acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t2_17 = Pddot1_1 + U1_12 * T(0.1);
  const T t2_18 = minus_U1_11 * T(0.2);
  const T t2_19 = t2_17 - t2_18 - t1_23;
  const T t2_20 = U1_21 * T(0.2);
  const T t2_21 = Pddot1_2 - minus_U1_22 * T(0.1);
  const T t2_22 = t2_20 + t2_21 - t1_22;
  const T t2_23 = U1_31 * T(0.2);
  const T t2_24 = Pddot1_3 + U1_32 * T(0.1);
  const T t2_25 = t2_23 + t2_24 + minus_U1_33 * T(0.2);
  const T Pddot2_1 = R1_11 * t2_19 + R1_21 * t2_22 + R1_31 * t2_25;
  const T Pddot2_2 = R1_12 * t2_19 + R1_22 * t2_22 + R1_32 * t2_25;
  const T Pddot2_3 = R1_13 * t2_19 + R1_23 * t2_22 + R1_33 * t2_25;
  // a2 = R2^T U2 r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_26 = U2_12 * T(0.02) - U2_13 * T(0.2);
  const T t2_27 = minus_U2_22 * T(0.02) + U2_23 * T(0.2);
  const T t2_28 = U2_32 * T(0.02) + minus_U2_33 * T(0.2);
  const T a2_1 = Pddot2_1 + R2_11 * t2_26 - R2_21 * t2_27 + R2_31 * t2_28;
  const T a2_2 = Pddot2_2 + R2_12 * t2_26 - R2_22 * t2_27 + R2_32 * t2_28;
  const T a2_3 = Pddot2_3 + R2_13 * t2_26 - R2_23 * t2_27 + R2_33 * t2_28;

  // ---- body 3 (boom) on body 1
  const T theta3 = x[8];
  const T thetadot3 = y[6];
  const T thetaddot3 = ydot[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T t3_18 = E3_11 * omega1_1 + E3_12 * omega1_2 - minus_E3_13 * omega1_3;
  const T omega3_1 = t3_18 - thetadot3 * T(0.3152711589176631);
  const T t3_19 = E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_2 = t3_19 + thetadot3 * T(0.44378789320576517);
  const T t3_20 = E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  const T omega3_3 = t3_20 + thetadot3 * T(0.8388422987658062);
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_21 = s1_1 + R1_31 * T(0.1);
  const T P3_1 = t3_21 + R1_11 * T(0.3);
  const T t3_22 = s1_2 + R1_32 * T(0.1);
  const T P3_2 = t3_22 + R1_12 * T(0.3);
  const T t3_23 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_23 + R1_13 * T(0.3);
  // omegadot3 = -thetadot3 b3~ E3 omega1 + thetaddot3 b3 + E3 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = E3_11 * omegadot1_1 - (thetadot3 * (T(0.44378789320576517) * t3_20 - T(0.8388422987658062) *
      t3_19) + thetaddot3 * T(0.3152711589176631)) + E3_12 * omegadot1_2 - minus_E3_13 * omegadot1_3;
  const T omegadot3_2 = thetaddot3 * T(0.44378789320576517) - thetadot3 * (T(0.8388422987658062) * t3_18 +
      T(0.3152711589176631) * t3_20) + E3_21 * omegadot1_1 + E3_22 * omegadot1_2 + E3_23 * omegadot1_3;
  const T omegadot3_3 = thetadot3 * (T(0.3152711589176631) * t3_19 + T(0.44378789320576517) * t3_18) + thetaddot3 *
      T(0.8388422987658062) + E3_31 * omegadot1_1 + E3_32 * omegadot1_2 + E3_33 * omegadot1_3;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_24 = omega3_3 * omega3_3;
  const T t3_25 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_24 + t3_25;
  const T t3_26 = omega3_2 * omega3_1;
  const T U3_12 = t3_26 - omegadot3_3;
  const T t3_27 = omega3_3 * omega3_1;
  const T U3_13 = t3_27 + omegadot3_2;
  const T U3_21 = t3_26 + omegadot3_3;
  const T t3_28 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_24 + t3_28;
  const T t3_29 = omega3_3 * omega3_2;
  const T U3_23 = t3_29 - omegadot3_1;
  const T U3_31 = t3_27 - omegadot3_2;
  const T U3_32 = t3_29 + omegadot3_1;
  const T minus_U3_33 = t3_25 + t3_28;
  // Pddot3 = E3 (U1 q3 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_30 = Pddot1_1 + U1_13 * T(0.1);
  const T t3_31 = t3_30 - minus_U1_11 * T(0.3);
  const T t3_32 = Pddot1_2 + U1_23 * T(0.1);
  const T t3_33 = t1_25 + t3_32;
  const T t3_34 = minus_U1_33 * T(0.1) - Pddot1_3;
  const T t3_35 = t1_24 - t3_34;
  const T Pddot3_1 = E3_11 * t3_31 + E3_12 * t3_33 - minus_E3_13 * t3_35;
  const T Pddot3_2 = E3_21 * t3_31 + E3_22 * t3_33 + E3_23 * t3_35;
  const T Pddot3_3 = E3_31 * t3_31 + E3_32 * t3_33 + E3_33 * t3_35;
  // stretch_boom_3 = theta3 - l_boom_: stretch of the spring
  const T stretch_boom_3 = theta3 - T(0.2);
  // effort_boom_3 = -thetadot3 c_boom_ + tau_boom_ - stretch_boom_3 k_boom_: along the coordinate [N m], [N]
  const T effort_boom_3 = u.motor - T(0.1) * tanh(thetadot3 * T(100)) - thetadot3 * T(0.5) - c.p.k * stretch_boom_3;
  // G2 = R3^T F_jet_ + m2 a2: inertia less applied force, inertial axes [N]
  const T t3_36 = T(0.5) * u.thrust * exp(T(0) - t);
  const T t3_37 = R3_11 * T(0.1) + R3_21 * t3_36;
  const T G2_1 = t3_37 + T(0.8) * a2_1;
  const T t3_38 = R3_12 * T(0.1) + R3_22 * t3_36;
  const T G2_2 = t3_38 + T(0.8) * a2_2;
  const T t3_39 = R3_13 * T(0.1) + R3_23 * t3_36;
  const T G2_3 = t3_39 + T(0.8) * a2_3;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a3_1 = Pddot3_1 + U3_12 * T(0.02) - minus_U3_11 * T(0.2);
  const T a3_2 = Pddot3_2 + U3_21 * T(0.2) - minus_U3_22 * T(0.02);
  const T a3_3 = Pddot3_3 + U3_31 * T(0.2) + U3_32 * T(0.02);
  // G3 = m3 a3: inertia less applied force, body axes [N]
  const T G3_1 = T(1.5) * a3_1;
  const T G3_2 = T(1.5) * a3_2;
  const T G3_3 = T(1.5) * a3_3;
  // N3 = axial(U3 (tr(I3)/2 - I3)): inertia less applied moment about the mass centre, body axes [N m]
  const T N3_1 = T(0.004999999999999999) * U3_32 - T(0.035) * U3_23 + T(0.003) * (minus_U3_22 - minus_U3_33) -
      T(0.002) * U3_31 + T(0.001) * U3_21;
  const T N3_2 = T(0.035) * U3_13 - T(0.015000000000000001) * U3_31 - T(0.001) * (minus_U3_33 - minus_U3_11) +
      T(0.003) * U3_12 + T(0.002) * U3_32;
  const T N3_3 = T(0.015000000000000001) * U3_21 - T(0.004999999999999999) * U3_12 - T(0.002) * (minus_U3_11 -
      minus_U3_22) - T(0.001) * U3_23 - T(0.003) * U3_13;

  // ---- body 4 (cross) on body 1
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  const T thetaddot4_1 = ydot[7], thetaddot4_2 = ydot[8];
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // omega4a = thetadot4_1 b4_1 + E4a omega1: absolute angular velocity, body axes [rad/s]
  const T omega4a_1 = E4a_11 * omega1_1 - minus_E4a_12 * omega1_2 - minus_E4a_13 * omega1_3;
  const T t4_3 = minus_E4a_12 * omega1_1 + E4a_22 * omega1_2 + E4a_23 * omega1_3;
  const T omega4a_2 = t4_3 + thetadot4_1 * T(0.28);
  const T t4_4 = minus_E4a_13 * omega1_1 + E4a_23 * omega1_2 + E4a_33 * omega1_3;
  const T omega4a_3 = t4_4 - thetadot4_1 * T(0.96);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_5 = cosines[10];
  const T E4_12 = T(0.28) * t4_5;
  const T minus_E4_13 = T(0.96) * t4_5;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // omega4 = thetadot4_2 b4_2 + E4 omega4a: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega4a_2 - minus_E4_11 * omega4a_1 - minus_E4_13 * omega4a_3;
  const T omega4_2 = thetadot4_2 + T(0.96) * omega4a_2 + T(0.28) * omega4a_3;
  const T omega4_3 = t4_5 * omega4a_1 + E4_32 * omega4a_2 - minus_E4_33 * omega4a_3;
  // omegadot4a = -thetadot4_1 b4_1~ E4a omega1 + thetaddot4_1 b4_1 + E4a omegadot1: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot4a_1 = E4a_11 * omegadot1_1 - minus_E4a_12 * omegadot1_2 - minus_E4a_13 * omegadot1_3 - thetadot4_1
      * (T(0.96) * t4_3 + T(0.28) * t4_4);
  const T omegadot4a_2 = T(0.96) * omega4a_1 * thetadot4_1 + thetaddot4_1 * T(0.28) + minus_E4a_12 * omegadot1_1 +
      E4a_22 * omegadot1_2 + E4a_23 * omegadot1_3;
  const T omegadot4a_3 = T(0.28) * omega4a_1 * thetadot4_1 - thetaddot4_1 * T(0.96) + minus_E4a_13 * omegadot1_1 +
      E4a_23 * omegadot1_2 + E4a_33 * omegadot1_3;
  // Pddot4a = E4a (U1 q4a + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_6 = t2_18 + t2_17;
  const T t4_7 = t2_21 - t2_20;
  const T t4_8 = t2_24 - t2_23;
  const T Pddot4a_1 = E4a_11 * t4_6 - minus_E4a_12 * t4_7 - minus_E4a_13 * t4_8;
  const T Pddot4a_2 = minus_E4a_12 * t4_6 + E4a_22 * t4_7 + E4a_23 * t4_8;
  const T Pddot4a_3 = minus_E4a_13 * t4_6 + E4a_23 * t4_7 + E4a_33 * t4_8;
  // omegadot4 = -thetadot4_2 b4_2~ E4 omega4a + thetaddot4_2 b4_2 + E4 omegadot4a: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot4_1 = E4_12 * omegadot4a_2 - minus_E4_11 * omegadot4a_1 - minus_E4_13 * omegadot4a_3 - thetadot4_2 *
      omega4_3;
  const T omegadot4_2 = thetaddot4_2 + T(0.96) * omegadot4a_2 + T(0.28) * omegadot4a_3;
  const T omegadot4_3 = thetadot4_2 * omega4_1 + t4_5 * omegadot4a_1 + E4_32 * omegadot4a_2 - minus_E4_33 *
      omegadot4a_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_9 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_9 + omega4_3 * omega4_3;
  const T t4_10 = omega4_2 * omega4_1;
  const T U4_12 = t4_10 - omegadot4_3;
  const T t4_11 = omega4_3 * omega4_1;
  const T U4_13 = t4_11 + omegadot4_2;
  const T U4_21 = t4_10 + omegadot4_3;
  const T t4_12 = omega4_3 * omega4_2;
  const T U4_23 = t4_12 - omegadot4_1;
  const T U4_31 = t4_11 - omegadot4_2;
  const T U4_32 = t4_12 + omegadot4_1;
  const T minus_U4_33 = t4_9 + omega4_1 * omega4_1;
  // Pddot4 = E4 Pddot4a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot4_1 = E4_12 * Pddot4a_2 - minus_E4_11 * Pddot4a_1 - minus_E4_13 * Pddot4a_3;
  const T Pddot4_2 = T(0.96) * Pddot4a_2 + T(0.28) * Pddot4a_3;
  const T Pddot4_3 = t4_5 * Pddot4a_1 + E4_32 * Pddot4a_2 - minus_E4_33 * Pddot4a_3;
  // a4 = U4 r4 + Pddot4: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a4_1 = Pddot4_1 + U4_13 * T(0.1) - minus_U4_11 * T(0.03);
  const T a4_2 = Pddot4_2 + U4_21 * T(0.03) + U4_23 * T(0.1);
  const T a4_3 = Pddot4_3 + U4_31 * T(0.03) - minus_U4_33 * T(0.1);
  // G4 = m4 a4: inertia less applied force, body axes [N]
  const T G4_1 = T(0.9) * a4_1;
  const T G4_2 = T(0.9) * a4_2;
  const T G4_3 = T(0.9) * a4_3;
  // N4 = axial(U4 (tr(I4)/2 - I4)): inertia less applied moment about the mass centre, body axes [N m]
  const T N4_1 = T(0.006500000000000001) * U4_32 - T(0.0015) * U4_23;
  const T N4_2 = T(0.0015) * U4_13 - T(0.0055) * U4_31;
  const T N4_3 = T(0.0055) * U4_21 - T(0.006500000000000001) * U4_12;

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  const T thetaddot5_1 = ydot[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T t5_2 = sin(t5_1);
  const T theta5_2 = c.p.amplitude * t5_2;
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // thetaddot5_2 = d^2/dt^2 expression 1: prescribed
  const T minus_thetaddot5_2 = t5_2 * T(3) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = t3_21 - R1_21 * T(0.3);
  const T P5a_2 = t3_22 - R1_22 * T(0.3);
  const T P5a_3 = t3_23 - R1_23 * T(0.3);
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_3 = omega1_3 * T(0.3) + omega1_2 * T(0.1);
  const T t5_4 = omega1_1 * T(0.1);
  const T t5_5 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_3 - R1_21 * t5_4 - R1_31 * t5_5;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_3 - R1_22 * t5_4 - R1_32 * t5_5;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_3 - R1_23 * t5_4 - R1_33 * t5_5;
  // omegadot5a = -thetadot5_1 b5_1~ E5a omega1 + thetaddot5_1 b5_1 + E5a omegadot1: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5a_1 = thetadot5_1 * omega5a_2 + E5a_11 * omegadot1_1 + E5a_12 * omegadot1_2;
  const T omegadot5a_2 = E5a_11 * omegadot1_2 - E5a_12 * omegadot1_1 - thetadot5_1 * omega5a_1;
  const T omegadot5a_3 = thetaddot5_1 + omegadot1_3;
  // Pddot5a = E5a (U1 q5a + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_6 = t3_30 - U1_12 * T(0.3);
  const T t5_7 = t3_32 + minus_U1_22 * T(0.3);
  const T Pddot5a_1 = E5a_11 * t5_6 + E5a_12 * t5_7;
  const T Pddot5a_2 = E5a_11 * t5_7 - E5a_12 * t5_6;
  const T minus_Pddot5a_3 = t3_34 + U1_32 * T(0.3);
  // omegadot5 = -thetadot5_2 b5_2~ E5 omega5a + thetaddot5_2 b5_2 + E5 omegadot5a: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5_1 = omegadot5a_1 - minus_thetaddot5_2;
  const T omegadot5_2 = thetadot5_2 * omega5_3 + E5_22 * omegadot5a_2 + E5_23 * omegadot5a_3;
  const T omegadot5_3 = E5_22 * omegadot5a_3 - E5_23 * omegadot5a_2 - thetadot5_2 * omega5_2;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_8 = omega5_2 * omega5_2;
  const T minus_U5_11 = omega5_3 * omega5_3 + t5_8;
  const T t5_9 = omega5_2 * omega5_1;
  const T U5_12 = t5_9 - omegadot5_3;
  const T t5_10 = omega5_3 * omega5_1;
  const T U5_13 = t5_10 + omegadot5_2;
  const T U5_21 = t5_9 + omegadot5_3;
  const T t5_11 = omega5_3 * omega5_2;
  const T U5_23 = t5_11 - omegadot5_1;
  const T U5_31 = t5_10 - omegadot5_2;
  const T U5_32 = t5_11 + omegadot5_1;
  const T minus_U5_33 = t5_8 + omega5_1 * omega5_1;
  // Pddot5 = E5 Pddot5a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_2 = E5_22 * Pddot5a_2 - E5_23 * minus_Pddot5a_3;
  const T minus_Pddot5_3 = E5_22 * minus_Pddot5a_3 + E5_23 * Pddot5a_2;
  // a5 = U5 r_link5 + Pddot5: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a5_1 = Pddot5a_1 + U5_13 * c.r_link5_3 - minus_U5_11 * c.r_link5_1;
  const T a5_2 = Pddot5_2 + U5_21 * c.r_link5_1 + U5_23 * c.r_link5_3;
  const T a5_3 = U5_31 * c.r_link5_1 - minus_Pddot5_3 - minus_U5_33 * c.r_link5_3;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  const T sddot6 = ydot[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_1 = P3_1 + R3_11 * d6_1;
  const T P6_2 = P3_2 + R3_12 * d6_1;
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // Pddot6 = 2 sdot6 omega3~ u6 + sddot6 u6 + U3 d6 + Pddot3: acceleration of the body origin, less gravity, body
  //   axes [m/s^2]
  const T Pddot6_1 = sddot6 + Pddot3_1 - minus_U3_11 * d6_1;
  const T t6_1 = T(2) * sdot6;
  const T Pddot6_2 = Pddot3_2 + t6_1 * omega3_3 + U3_21 * d6_1;
  const T Pddot6_3 = Pddot3_3 + U3_31 * d6_1 - t6_1 * omega3_2;
  // effort_telescope_6 = -sdot6 c_telescope_: along the coordinate [N m], [N]
  const T minus_effort_telescope_6 = sdot6 * (T(2) + abs(sdot6));
  // arm2 = R2 R3^T r_jet_ - R2 P2 + R2 P6
  const T t6_2 = R3_11 * T(0.2);
  const T t6_3 = R3_12 * T(0.2);
  const T t6_4 = R3_13 * T(0.2);
  const T arm2_1 = R2_11 * t6_2 + R2_12 * t6_3 + R2_13 * t6_4 - R2_11 * P2_1 - R2_12 * P2_2 - R2_13 * P2_3 + R2_11 *
      P6_1 + R2_12 * P6_2 + R2_13 * P6_3;
  const T arm2_2 = R2_21 * t6_2 + R2_22 * t6_3 + R2_23 * t6_4 - R2_21 * P2_1 - R2_22 * P2_2 - R2_23 * P2_3 + R2_21 *
      P6_1 + R2_22 * P6_2 + R2_23 * P6_3;
  const T arm2_3 = R2_31 * t6_2 + R2_32 * t6_3 + R2_33 * t6_4 - R2_31 * P2_1 - R2_32 * P2_2 - R2_33 * P2_3 + R2_31 *
      P6_1 + R2_32 * P6_2 + R2_33 * P6_3;
  // lever2 = -r2 + arm2: from the reference point to where a force acts, link axes [m]
  const T lever2_2 = arm2_2 - T(0.02);
  const T lever2_3 = arm2_3 + T(0.2);
  // N2 = axial(U2 (tr(I2)/2 - I2)) + lever2~ R2 R3^T F_jet_: inertia less applied moment about the mass centre, body
  //   axes [N m]
  const T t6_5 = R2_31 * t3_37 + R2_32 * t3_38 + R2_33 * t3_39;
  const T t6_6 = R2_21 * t3_37 + R2_22 * t3_38 + R2_23 * t3_39;
  const T N2_1 = T(0.0015000000000000005) * U2_32 - T(0.0085) * U2_23 + lever2_2 * t6_5 - lever2_3 * t6_6;
  const T t6_7 = R2_11 * t3_37 + R2_12 * t3_38 + R2_13 * t3_39;
  const T N2_2 = T(0.0085) * U2_13 - T(0.0024999999999999996) * U2_31 + lever2_3 * t6_7 - arm2_1 * t6_5;
  const T N2_3 = T(0.0024999999999999996) * U2_21 - T(0.0015000000000000005) * U2_12 + arm2_1 * t6_6 - lever2_2 *
      t6_7;
  // a6 = U3 r6 + Pddot6: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a6_1 = Pddot6_1 + U3_13 * T(0.01) - minus_U3_11 * T(0.1);
  const T a6_2 = Pddot6_2 + U3_21 * T(0.1) + U3_23 * T(0.01);
  const T a6_3 = Pddot6_3 + U3_31 * T(0.1) - minus_U3_33 * T(0.01);
  // G6 = m6 a6 - F_jet_: inertia less applied force, body axes [N]
  const T G6_1 = T(0.5) * a6_1 - T(0.1);
  const T G6_2 = T(0.5) * a6_2 - t3_36;
  const T G6_3 = T(0.5) * a6_3;
  // N6 = axial(U3 (tr(I6)/2 - I6)) - lever6~ F_jet_: inertia less applied moment about the mass centre, body axes [N
  //   m]
  const T N6_1 = T(5e-04) * U3_32 - T(5e-04) * U3_23 - T(0.01) * t3_36;
  const T N6_2 = T(0.001) + T(5e-04) * U3_13 - T(0.0055) * U3_31;
  const T N6_3 = T(0.0055) * U3_21 - T(5e-04) * U3_12 - T(0.1) * t3_36;

  // ---- body 7 (gantry) on the inertial frame
  const T sddot7_1 = ydot[20], sddot7_2 = ydot[21];
  // G7 = m7 Pddot7: inertia less applied force, inertial axes [N]
  const T G7_1 = T(3) * sddot7_1;
  const T G7_2 = T(3) * sddot7_2;
  r[20] = G7_1;
  r[21] = G7_2;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  const T thetadot8 = y[10];
  const T sdot8 = y[22];
  const T thetaddot8 = ydot[10];
  const T sddot8 = ydot[22];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega1_1 + E8_13 * omega1_3;
  const T omega8_2 = omega1_2 - thetadot8;
  const T omega8_3 = E8_11 * omega1_3 - E8_13 * omega1_1;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // omegadot8 = -thetadot8 b8~ E8 omega1 + thetaddot8 b8 + E8 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot8_1 = thetadot8 * omega8_3 + E8_11 * omegadot1_1 + E8_13 * omegadot1_3;
  const T omegadot8_2 = omegadot1_2 - thetaddot8;
  const T omegadot8_3 = E8_11 * omegadot1_3 - E8_13 * omegadot1_1 - thetadot8 * omega8_1;
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
  // Pddot8 = E8 (2 sdot8 omega1~ u8 + sddot8 u8 + U1 d8 + Pddot1): acceleration of the body origin, less gravity,
  //   body axes [m/s^2]
  const T t8_7 = T(2) * sdot8;
  const T t8_8 = Pddot1_1 + t8_7 * omega1_3 + U1_12 * d8_2;
  const T t8_9 = Pddot1_3 + U1_32 * d8_2 - t8_7 * omega1_1;
  const T Pddot8_1 = E8_11 * t8_8 + E8_13 * t8_9;
  const T Pddot8_2 = Pddot1_2 - sddot8 - minus_U1_22 * d8_2;
  const T Pddot8_3 = E8_11 * t8_9 - E8_13 * t8_8;
  // a8 = U8 r_link8 + Pddot8: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a8_1 = Pddot8_1 + minus_U8_11 * T(0.01) - U8_12 * T(0.1) + U8_13 * T(0.02);
  const T a8_2 = Pddot8_2 + minus_U8_22 * T(0.1) - U8_21 * T(0.01) + U8_23 * T(0.02);
  const T a8_3 = Pddot8_3 - U8_31 * T(0.01) - U8_32 * T(0.1) - minus_U8_33 * T(0.02);
  // G8 = m8 a8: inertia less applied force, body axes [N]
  const T G8_1 = T(0.7) * a8_1;
  const T G8_2 = T(0.7) * a8_2;
  const T G8_3 = T(0.7) * a8_3;
  // N8 = axial(U8 (tr(I_link8)/2 - I_link8)): inertia less applied moment about the mass centre, body axes [N m]
  const T N8_1 = T(0.0025) * U8_32 - T(5e-04) * U8_23;
  const T N8_2 = T(5e-04) * U8_13 - T(0.0015) * U8_31;
  const T N8_3 = T(0.0015) * U8_21 - T(0.0025) * U8_12;

  // ---- body 9 (sled) on the inertial frame
  const T s9_1 = x[26], s9_2 = x[27];
  const T thetadot9 = y[11];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  const T thetaddot9 = ydot[11];
  const T sddot9_1 = ydot[23], sddot9_2 = ydot[24];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // U9 = omega9~ omega9~ + omegadot9~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U9_11 = thetadot9 * thetadot9;
  // Pddot9 = E9 (-g + sddot9_1 u9_1 + sddot9_2 u9_2): acceleration of the body origin, less gravity, body axes
  //   [m/s^2]
  const T Pddot9_1 = E9_11 * sddot9_1 + E9_12 * sddot9_2;
  const T Pddot9_2 = E9_11 * sddot9_2 - E9_12 * sddot9_1;
  // line_tether_9 = -R5^T C12^T r_tether_ - R5^T o5 + E9^T r_tether_other_ - P5a + d9: from one end of the spring to
  //   the other, inertial axes [m]
  const T line_tether_9_1 = s9_1 - P5a_1 + E9_11 * T(0.1) - R5_21 * T(0.02) - T(0.03620228586010676) * R5a_11 -
      T(0.06743336618301184) * R5_31;
  const T line_tether_9_2 = d9_2 - P5a_2 + E9_12 * T(0.1) - R5_22 * T(0.02) - T(0.03620228586010676) * R5a_12 -
      T(0.06743336618301184) * R5_32;
  const T line_tether_9_3 = T(0.1) - P5a_3 - R5_23 * T(0.02) - T(0.03620228586010676) * R5a_13 -
      T(0.06743336618301184) * R5_33;
  // ll_tether_9 = 1e-36 + line_tether_9 . line_tether_9: length squared [m^2]
  const T ll_tether_9 = T(1e-36) + line_tether_9_1 * line_tether_9_1 + line_tether_9_2 * line_tether_9_2 +
      line_tether_9_3 * line_tether_9_3;
  // length_tether_9 = ll_tether_9^1/2: length [m]
  const T length_tether_9 = sqrt(ll_tether_9);
  // line_rate_tether_9 = -R5^T omega5~ C12^T r_tether_ - R5^T omega5~ o5 + E9^T omega9~ r_tether_other_ - Pdot5a +
  //   Pdot9: its rate [m/s]
  const T t9_1 = thetadot9 * T(0.1);
  const T t9_2 = omega5_2 * T(0.07741670784769467) - omega5_3 * T(0.02);
  const T t9_3 = omega5_3 * T(0.06329813066769584) + omega5_1 * T(0.07741670784769467);
  const T t9_4 = omega5_1 * T(0.02) + omega5_2 * T(0.06329813066769584);
  const T t9_5 = omega5_3 * T(0.09950041652780259) + omega5_1 * T(0.009983341664682815);
  const T t9_6 = omega5_2 * T(0.009983341664682815);
  const T t9_7 = omega5_2 * T(0.09950041652780259);
  const T line_rate_tether_9_1 = sdot9_1 - Pdot5a_1 - E9_12 * t9_1 - R5a_11 * t9_2 + R5_21 * t9_3 - R5_31 * t9_4 -
      R5_21 * t9_5 + R5a_11 * t9_6 + R5_31 * t9_7;
  const T line_rate_tether_9_2 = sdot9_2 - Pdot5a_2 + R5_22 * t9_3 - R5a_12 * t9_2 - R5_32 * t9_4 - R5_22 * t9_5 +
      R5a_12 * t9_6 + R5_32 * t9_7 + E9_11 * t9_1;
  const T minus_line_rate_tether_9_3 = Pdot5a_3 + R5a_13 * t9_2 - R5_23 * t9_3 + R5_33 * t9_4 + R5_23 * t9_5 - R5a_13
      * t9_6 - R5_33 * t9_7;
  // f_tether_9 = k_tether_ - k_tether_ l_tether_ length_tether_9^-1 + c_tether_ line_tether_9 . line_rate_tether_9
  //   ll_tether_9^-1: attraction by the length [N/m]
  const T f_tether_9 = c.p.k - T(1) / length_tether_9 * c.c9_1 + T(0.4) * (line_tether_9_1 * line_rate_tether_9_1 +
      line_tether_9_2 * line_rate_tether_9_2 - line_tether_9_3 * minus_line_rate_tether_9_3) * (T(1) / ll_tether_9);
  // F_tether_9 = f_tether_9 line_tether_9: on the first end, inertial axes [N]
  const T F_tether_9_1 = f_tether_9 * line_tether_9_1;
  const T F_tether_9_2 = f_tether_9 * line_tether_9_2;
  const T F_tether_9_3 = f_tether_9 * line_tether_9_3;
  // G5 = -R5 F_tether_9 + m_link5 a5: inertia less applied force, body axes [N]
  const T t9_8 = R5a_11 * F_tether_9_1 + R5a_12 * F_tether_9_2 + R5a_13 * F_tether_9_3;
  const T G5_1 = c.m_link5 * a5_1 - t9_8;
  const T t9_9 = R5_21 * F_tether_9_1 + R5_22 * F_tether_9_2 + R5_23 * F_tether_9_3;
  const T G5_2 = c.m_link5 * a5_2 - t9_9;
  const T t9_10 = R5_31 * F_tether_9_1 + R5_32 * F_tether_9_2 + R5_33 * F_tether_9_3;
  const T G5_3 = c.m_link5 * a5_3 - t9_10;
  // N5 = axial(U5 (tr(I_link5)/2 - I_link5)) - lever5~ R5 F_tether_9: inertia less applied moment about the mass
  //   centre, body axes [N m]
  const T N5_1 = c.c9_3 * U5_32 - c.c9_4 * U5_23 + c.I_link5_13 * U5_21 - T(0.02) * t9_10 + c.lever5_3 * t9_9;
  const T N5_2 = c.c9_4 * U5_13 - c.c9_2 * U5_31 - c.I_link5_13 * (minus_U5_33 - minus_U5_11) - c.lever5_3 * t9_8 +
      c.lever5_1 * t9_10;
  const T N5_3 = c.c9_2 * U5_21 - c.c9_3 * U5_12 - c.I_link5_13 * U5_23 - c.lever5_1 * t9_9 + T(0.02) * t9_8;
  // a9 = U9 r9 + Pddot9: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a9_1 = Pddot9_1 - minus_U9_11 * T(0.1);
  const T a9_2 = Pddot9_2 + thetaddot9 * T(0.1);
  // G9 = E9 F_tether_9 + m9 a9: inertia less applied force, body axes [N]
  const T G9_1 = E9_11 * F_tether_9_1 + E9_12 * F_tether_9_2 + T(2) * a9_1;
  const T G9_2 = E9_11 * F_tether_9_2 - E9_12 * F_tether_9_1 + T(2) * a9_2;
  // N9 = axial(U9 (tr(I9)/2 - I9)) + lever9~ E9 F_tether_9: inertia less applied moment about the mass centre, body
  //   axes [N m]
  const T N9_3 = T(0.08) * thetaddot9;

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  const T omega10_1 = y[12], omega10_2 = y[13], omega10_3 = y[14];
  const T sdot10 = y[25];
  const T omegadot10_1 = ydot[12], omegadot10_2 = ydot[13], omegadot10_3 = ydot[14];
  const T sddot10 = ydot[25];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // U10 = omega10~ omega10~ + omegadot10~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t10_13 = omega10_3 * omega10_3;
  const T t10_14 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_13 + t10_14;
  const T t10_15 = omega10_2 * omega10_1;
  const T U10_12 = t10_15 - omegadot10_3;
  const T t10_16 = omega10_3 * omega10_1;
  const T U10_13 = t10_16 + omegadot10_2;
  const T U10_21 = t10_15 + omegadot10_3;
  const T t10_17 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_13 + t10_17;
  const T t10_18 = omega10_3 * omega10_2;
  const T U10_23 = t10_18 - omegadot10_1;
  const T U10_31 = t10_16 - omegadot10_2;
  const T U10_32 = t10_18 + omegadot10_1;
  const T minus_U10_33 = t10_14 + t10_17;
  // Pddot10 = R1^T (2 sdot10 omega1~ u10 + sddot10 u10 + U1 d10 + Pddot1): acceleration of the body origin, less
  //   gravity, inertial axes [m/s^2]
  const T t10_19 = T(2) * sdot10;
  const T t10_20 = Pddot1_1 + U1_12 * s10 - minus_U1_11 * T(0.1) + U1_13 * T(0.3) - t10_19 * omega1_3;
  const T t10_21 = sddot10 + Pddot1_2 + U1_21 * T(0.1) - minus_U1_22 * s10 + U1_23 * T(0.3);
  const T t10_22 = Pddot1_3 + t10_19 * omega1_1 + U1_31 * T(0.1) + U1_32 * s10 - minus_U1_33 * T(0.3);
  const T Pddot10_1 = R1_11 * t10_20 + R1_21 * t10_21 + R1_31 * t10_22;
  const T Pddot10_2 = R1_12 * t10_20 + R1_22 * t10_21 + R1_32 * t10_22;
  const T Pddot10_3 = R1_13 * t10_20 + R1_23 * t10_21 + R1_33 * t10_22;
  // a10 = R10^T U10 r10 + Pddot10: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t10_23 = U10_12 * T(0.01) - minus_U10_11 * T(0.02) - U10_13 * T(0.03);
  const T t10_24 = U10_21 * T(0.02) - minus_U10_22 * T(0.01) - U10_23 * T(0.03);
  const T t10_25 = U10_31 * T(0.02) + U10_32 * T(0.01) + minus_U10_33 * T(0.03);
  const T a10_1 = Pddot10_1 + R10_11 * t10_23 + R10_21 * t10_24 + R10_31 * t10_25;
  const T a10_2 = Pddot10_2 + R10_12 * t10_23 + R10_22 * t10_24 + R10_32 * t10_25;
  const T a10_3 = Pddot10_3 + R10_13 * t10_23 + R10_23 * t10_24 + R10_33 * t10_25;
  // G10 = m10 a10: inertia less applied force, inertial axes [N]
  const T G10_1 = T(0.4) * a10_1;
  const T G10_2 = T(0.4) * a10_2;
  const T G10_3 = T(0.4) * a10_3;
  // N10 = axial(U10 (tr(I10)/2 - I10)): inertia less applied moment about the mass centre, body axes [N m]
  const T N10_1 = T(0.00075) * U10_32 - T(0.00125) * U10_23;
  const T N10_2 = T(0.00125) * U10_13 - T(0.00175) * U10_31;
  const T N10_3 = T(0.00175) * U10_21 - T(0.00075) * U10_12;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  const T thetadot11 = y[15];
  const T thetaddot11 = ydot[15];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega8_1 + E11_13 * omega8_3;
  const T omega11_2 = omega8_2 - thetadot11;
  const T omega11_3 = E11_11 * omega8_3 - E11_13 * omega8_1;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // omegadot11 = -thetadot11 b11~ E11 omega8 + thetaddot11 b11 + E11 omegadot8: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot11_1 = thetadot11 * omega11_3 + E11_11 * omegadot8_1 + E11_13 * omegadot8_3;
  const T omegadot11_2 = omegadot8_2 - thetaddot11;
  const T omegadot11_3 = E11_11 * omegadot8_3 - E11_13 * omegadot8_1 - thetadot11 * omega11_1;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_1 = omega11_2 * omega11_1;
  const T U11_12 = t11_1 - omegadot11_3;
  const T t11_2 = omega11_3 * omega11_1;
  const T U11_13 = t11_2 + omegadot11_2;
  const T U11_21 = t11_1 + omegadot11_3;
  const T t11_3 = omega11_3 * omega11_2;
  const T U11_23 = t11_3 - omegadot11_1;
  const T U11_31 = t11_2 - omegadot11_2;
  const T U11_32 = t11_3 + omegadot11_1;
  const T minus_U11_33 = omega11_2 * omega11_2 + omega11_1 * omega11_1;
  // Pddot11 = E11 (2 thetadot11 pitch11 omega8~ u11 + thetaddot11 pitch11 u11 + U8 d11 + Pddot8): acceleration of the
  //   body origin, less gravity, body axes [m/s^2]
  const T t11_4 = T(2) * thetadot11 * T(0.01);
  const T t11_5 = Pddot8_1 + t11_4 * omega8_3 - U8_12 * minus_d11_2;
  const T t11_6 = Pddot8_3 - t11_4 * omega8_1 - U8_32 * minus_d11_2;
  const T Pddot11_1 = E11_11 * t11_5 + E11_13 * t11_6;
  const T Pddot11_2 = Pddot8_2 + minus_U8_22 * minus_d11_2 - thetaddot11 * T(0.01);
  const T Pddot11_3 = E11_11 * t11_6 - E11_13 * t11_5;
  // effort_nut_11 = -thetadot11 c_nut_: along the coordinate [N m], [N]
  const T minus_effort_nut_11 = thetadot11 * T(0.002);
  // a11 = U11 r_link11 + Pddot11: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a11_1 = Pddot11_1 + U11_13 * T(0.01);
  const T a11_2 = Pddot11_2 + U11_23 * T(0.01);
  const T a11_3 = Pddot11_3 - minus_U11_33 * T(0.01);
  // G11 = m11 a11: inertia less applied force, body axes [N]
  const T G11_1 = T(0.3) * a11_1;
  const T G11_2 = T(0.3) * a11_2;
  const T G11_3 = T(0.3) * a11_3;
  // N11 = -C11^T M_coupling_ + axial(U11 (tr(I_link11)/2 - I_link11)): inertia less applied moment about the mass
  //   centre, body axes [N m]
  const T N11_1 = T(0.00010000000000000005) * U11_32 - T(3e-04) * U11_23;
  const T N11_2 = T(3e-04) * U11_13 - T(3e-04) * U11_31 + T(0.02) * u.motor;
  const T N11_3 = T(3e-04) * U11_21 - T(0.00010000000000000005) * U11_12;

  // ---- body 13 (ballast) on the inertial frame
  const T sddot13_1 = ydot[26], sddot13_2 = ydot[27], sddot13_3 = ydot[28];
  // Pddot13 = -g + sddot13: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T Pddot13_3 = sddot13_3 + T(9.81);
  // G13 = m13 Pddot13: inertia less applied force, inertial axes [N]
  const T G13_1 = T(5) * sddot13_1;
  const T G13_2 = T(5) * sddot13_2;
  const T G13_3 = T(5) * Pddot13_3;
  r[26] = G13_1;
  r[27] = G13_2;
  r[28] = G13_3;

  // ---- body 11 (nut) and what it carries
  // rho11 = r_link11~ G11 + N11: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T b11_1 = T(0.01) * G11_2;
  const T rho11_1 = N11_1 - b11_1;
  const T rho11_2 = N11_2 + T(0.01) * G11_1;
  // r_theta11 = b11 . G11 pitch11 + b11 . rho11 - effort_nut_11: Kane's equation of the angle [N m]
  const T r_theta11 = minus_effort_nut_11 - (b11_1 + rho11_2);
  r[15] = r_theta11;

  // ---- body 10 (runner) and what it carries
  // r_omega10 = r10~ R10 G10 + N10: Kane's equation of omega [N m]
  const T b10_1 = R10_21 * G10_1 + R10_22 * G10_2 + R10_23 * G10_3;
  const T b10_2 = R10_31 * G10_1 + R10_32 * G10_2 + R10_33 * G10_3;
  const T r_omega10_1 = N10_1 + T(0.03) * b10_1 + T(0.01) * b10_2;
  const T b10_3 = R10_11 * G10_1 + R10_12 * G10_2 + R10_13 * G10_3;
  const T r_omega10_2 = N10_2 - T(0.03) * b10_3 - T(0.02) * b10_2;
  const T r_omega10_3 = N10_3 + T(0.02) * b10_1 - T(0.01) * b10_3;
  r[12] = r_omega10_1;
  r[13] = r_omega10_2;
  r[14] = r_omega10_3;
  // r_sdot1_10 = u10 . (R1 G10): Kane's equation of sdot [N]
  const T r_sdot1_10 = R1_21 * G10_1 + R1_22 * G10_2 + R1_23 * G10_3;
  r[25] = r_sdot1_10;

  // ---- body 9 (sled) and what it carries
  // rho9 = r9~ G9 + N9: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho9_3 = T(0.1) * G9_2 + N9_3;
  r[11] = rho9_3;
  // r_sdot1_9 = u9_1 . (E9^T G9): Kane's equation of sdot [N]
  const T r_sdot1_9 = E9_11 * G9_1 - E9_12 * G9_2;
  r[23] = r_sdot1_9;
  // r_sdot2_9 = u9_2 . (E9^T G9): Kane's equation of sdot [N]
  const T r_sdot2_9 = E9_12 * G9_1 + E9_11 * G9_2;
  r[24] = r_sdot2_9;

  // ---- body 8 (piston) and what it carries
  // S8 = E11^T G11 + G8: sum of the force balances of the subtree, body axes [N]
  const T b8_1 = E11_11 * G11_1 - E11_13 * G11_3;
  const T S8_1 = b8_1 + G8_1;
  const T S8_2 = G11_2 + G8_2;
  const T b8_2 = E11_13 * G11_1 + E11_11 * G11_3;
  const T S8_3 = b8_2 + G8_3;
  r[22] = -S8_2;
  // rho8 = E11^T rho11 + r_link8~ G8 + d11~ E11^T G11 + N8: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho8_1 = N8_1 + E11_11 * rho11_1 - E11_13 * N11_3 - T(0.02) * G8_2 - T(0.1) * G8_3 - minus_d11_2 * b8_2;
  const T rho8_2 = rho11_2 + N8_2 + T(0.02) * G8_1 + T(0.01) * G8_3;
  const T rho8_3 = N8_3 + E11_13 * rho11_1 + E11_11 * N11_3 + T(0.1) * G8_1 - T(0.01) * G8_2 + minus_d11_2 * b8_1;
  r[10] = -rho8_2;

  // ---- body 6 (telescope) and what it carries
  // rho6 = r6~ G6 + N6: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho6_1 = N6_1 - T(0.01) * G6_2;
  const T rho6_2 = N6_2 + T(0.01) * G6_1 - T(0.1) * G6_3;
  const T rho6_3 = N6_3 + T(0.1) * G6_2;
  // r_sdot6 = u6 . G6 - effort_telescope_6: Kane's equation of sdot [N]
  const T r_sdot6 = G6_1 + minus_effort_telescope_6;
  r[19] = r_sdot6;

  // ---- body 5 (camera) and what it carries
  // rho5 = r_link5~ G5 + N5: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5_1 = N5_1 - c.r_link5_3 * G5_2;
  const T rho5_2 = N5_2 + c.r_link5_3 * G5_1 - c.r_link5_1 * G5_3;
  const T rho5_3 = N5_3 + c.r_link5_1 * G5_2;
  // S5a = E5^T G5: sum of the force balances of the subtree, body axes [N]
  const T S5a_2 = E5_22 * G5_2 - E5_23 * G5_3;
  const T S5a_3 = E5_23 * G5_2 + E5_22 * G5_3;
  // rho5a = E5^T rho5: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5a_2 = E5_22 * rho5_2 - E5_23 * rho5_3;
  const T rho5a_3 = E5_23 * rho5_2 + E5_22 * rho5_3;
  r[9] = rho5a_3;

  // ---- body 4 (cross) and what it carries
  // rho4 = r4~ G4 + N4: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho4_1 = N4_1 - T(0.1) * G4_2;
  const T rho4_2 = N4_2 + T(0.1) * G4_1 - T(0.03) * G4_3;
  const T rho4_3 = N4_3 + T(0.03) * G4_2;
  r[8] = rho4_2;
  // S4a = E4^T G4: sum of the force balances of the subtree, body axes [N]
  const T S4a_1 = t4_5 * G4_3 - minus_E4_11 * G4_1;
  const T S4a_2 = E4_12 * G4_1 + T(0.96) * G4_2 + E4_32 * G4_3;
  const T S4a_3 = T(0.28) * G4_2 - minus_E4_13 * G4_1 - minus_E4_33 * G4_3;
  // rho4a = E4^T rho4: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho4a_1 = t4_5 * rho4_3 - minus_E4_11 * rho4_1;
  const T rho4a_2 = E4_12 * rho4_1 + T(0.96) * rho4_2 + E4_32 * rho4_3;
  const T rho4a_3 = T(0.28) * rho4_2 - minus_E4_13 * rho4_1 - minus_E4_33 * rho4_3;
  // r_theta4a = b4_1 . rho4a: Kane's equation of the angle [N m]
  const T r_theta4a = T(0.28) * rho4a_2 - T(0.96) * rho4a_3;
  r[7] = r_theta4a;

  // ---- body 3 (boom) and what it carries
  // S3 = G3 + G6: sum of the force balances of the subtree, body axes [N]
  const T S3_1 = G3_1 + G6_1;
  const T S3_2 = G3_2 + G6_2;
  const T S3_3 = G3_3 + G6_3;
  // rho3 = r3~ G3 + d6~ G6 + N3 + rho6: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho3_1 = N3_1 + rho6_1 + T(0.02) * G3_3;
  const T rho3_2 = N3_2 + rho6_2 - T(0.2) * G3_3 - d6_1 * G6_3;
  const T rho3_3 = N3_3 + rho6_3 + T(0.2) * G3_2 - T(0.02) * G3_1 + d6_1 * G6_2;
  // r_theta3 = b3 . rho3 - effort_boom_3: Kane's equation of the angle [N m]
  const T r_theta3 = T(0.44378789320576517) * rho3_2 - effort_boom_3 - T(0.3152711589176631) * rho3_1 +
      T(0.8388422987658062) * rho3_3;
  r[6] = r_theta3;

  // ---- body 2 (clapper) and what it carries
  // r_omega2 = r2~ R2 G2 + N2: Kane's equation of omega [N m]
  const T r_omega2_1 = N2_1 + T(0.2) * (R2_21 * G2_1 + R2_22 * G2_2 + R2_23 * G2_3) + T(0.02) * (R2_31 * G2_1 + R2_32
      * G2_2 + R2_33 * G2_3);
  const T b2_1 = R2_11 * G2_1 + R2_12 * G2_2 + R2_13 * G2_3;
  const T r_omega2_2 = N2_2 - T(0.2) * b2_1;
  const T r_omega2_3 = N2_3 - T(0.02) * b2_1;
  r[3] = r_omega2_1;
  r[4] = r_omega2_2;
  r[5] = r_omega2_3;

  // ---- body 1 (hull) and what it carries
  // S1 = R1 G2 + R1 G10 + E3^T S3 + E4a^T S4a + E5a^T S5a + E8^T S8 + G1: sum of the force balances of the subtree,
  //   body axes [N]
  const T b1_1 = R1_11 * G2_1 + R1_12 * G2_2 + R1_13 * G2_3;
  const T b1_2 = R1_11 * G10_1 + R1_12 * G10_2 + R1_13 * G10_3;
  const T b1_3 = E3_11 * S3_1 + E3_21 * S3_2 + E3_31 * S3_3;
  const T b1_4 = E4a_11 * S4a_1 + minus_E4a_12 * S4a_2 + minus_E4a_13 * S4a_3;
  const T b1_5 = E5a_11 * G5_1 - E5a_12 * S5a_2;
  const T b1_6 = E8_11 * S8_1 - E8_13 * S8_3;
  const T S1_1 = b1_1 + b1_2 + b1_3 + b1_4 + b1_5 + b1_6 + G1_1;
  const T b1_7 = R1_21 * G2_1 + R1_22 * G2_2 + R1_23 * G2_3;
  const T b1_8 = E3_12 * S3_1 + E3_22 * S3_2 + E3_32 * S3_3;
  const T b1_9 = E4a_22 * S4a_2 - minus_E4a_12 * S4a_1 + E4a_23 * S4a_3;
  const T b1_10 = E5a_12 * G5_1 + E5a_11 * S5a_2;
  const T S1_2 = b1_7 + r_sdot1_10 + b1_8 + b1_9 + b1_10 + S8_2 + G1_2;
  const T b1_11 = R1_31 * G2_1 + R1_32 * G2_2 + R1_33 * G2_3;
  const T b1_12 = R1_31 * G10_1 + R1_32 * G10_2 + R1_33 * G10_3;
  const T b1_13 = E3_23 * S3_2 - minus_E3_13 * S3_1 + E3_33 * S3_3;
  const T b1_14 = E4a_23 * S4a_2 - minus_E4a_13 * S4a_1 + E4a_33 * S4a_3;
  const T b1_15 = E8_13 * S8_1 + E8_11 * S8_3;
  const T S1_3 = b1_11 + b1_12 + b1_13 + b1_14 + S5a_3 + b1_15 + G1_3;
  // r_omega1 = q2~ R1 G2 + q3~ E3^T S3 + E3^T rho3 + q4a~ E4a^T S4a + E4a^T rho4a + q5a~ E5a^T S5a + E5a^T rho5a +
  //   E8^T rho8 + r1~ G1 + d8~ E8^T S8 + d10~ R1 G10 + N1: Kane's equation of omega [N m]
  const T b1_16 = T(0.2) * b1_7;
  const T r_omega1_1 = b1_16 + N1_1 + T(0.1) * b1_11 - T(0.1) * b1_8 + E3_11 * rho3_1 + E3_21 * rho3_2 + E3_31 *
      rho3_3 + T(0.1) * b1_14 + E4a_11 * rho4a_1 + minus_E4a_12 * rho4a_2 + minus_E4a_13 * rho4a_3 - T(0.1) * b1_10 -
      T(0.3) * S5a_3 + E5a_11 * rho5_1 - E5a_12 * rho5a_2 + E8_11 * rho8_1 - E8_13 * rho8_3 - T(0.03) * G1_2 - T(0.01)
      * G1_3 + d8_2 * b1_15 + s10 * b1_12 - T(0.3) * r_sdot1_10;
  const T r_omega1_2 = rho8_2 + N1_2 - T(0.2) * b1_1 - T(0.2) * b1_11 + T(0.1) * b1_3 - T(0.3) * b1_13 + E3_12 *
      rho3_1 + E3_22 * rho3_2 + E3_32 * rho3_3 + T(0.2) * b1_14 + E4a_22 * rho4a_2 - minus_E4a_12 * rho4a_1 + E4a_23 *
      rho4a_3 + T(0.1) * b1_5 + E5a_12 * rho5_1 + E5a_11 * rho5a_2 + T(0.03) * G1_1 - T(0.02) * G1_3 + T(0.3) * b1_2 -
      T(0.1) * b1_12;
  const T r_omega1_3 = b1_16 + rho5a_3 + N1_3 - T(0.1) * b1_1 + T(0.3) * b1_8 + E3_23 * rho3_2 - minus_E3_13 * rho3_1
      + E3_33 * rho3_3 - T(0.2) * b1_9 - T(0.1) * b1_4 + E4a_23 * rho4a_2 - minus_E4a_13 * rho4a_1 + E4a_33 * rho4a_3
      + T(0.3) * b1_5 + E8_13 * rho8_1 + E8_11 * rho8_3 + T(0.02) * G1_2 + T(0.01) * G1_1 - d8_2 * b1_6 + T(0.1) *
      r_sdot1_10 - s10 * b1_2;
  r[0] = r_omega1_1;
  r[1] = r_omega1_2;
  r[2] = r_omega1_3;
  // r_sdot1 = R1^T S1: Kane's equation of sdot [N]
  const T r_sdot1_1 = R1_11 * S1_1 + R1_21 * S1_2 + R1_31 * S1_3;
  const T r_sdot1_2 = R1_12 * S1_1 + R1_22 * S1_2 + R1_32 * S1_3;
  const T r_sdot1_3 = R1_13 * S1_1 + R1_23 * S1_2 + R1_33 * S1_3;
  r[16] = r_sdot1_1;
  r[17] = r_sdot1_2;
  r[18] = r_sdot1_3;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 750 add, 926 multiply, 2 divide, 1 square root, 19 sine or cosine, 3 other function
template <class T>
void forcing(const Prepared<T>& c, T t, const T* x, const T* y, const Inputs<T>& u, T* f) noexcept {
  using std::abs, std::cos, std::exp, std::sin, std::sqrt, std::tanh;
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
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
  const T minus_U1_22 = t1_15 + t1_13;
  const T U1_23 = omega1_3 * omega1_2;
  const T minus_U1_33 = t1_15 + t1_14;
  // Pddot1 = -R1 g: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot1_1 = R1_13 * T(9.81);
  const T Pddot1_2 = R1_23 * T(9.81);
  const T Pddot1_3 = R1_33 * T(9.81);
  // a1 = U1 r1 + Pddot1: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T t1_16 = U1_13 * T(0.03);
  const T t1_17 = U1_12 * T(0.01);
  const T a1_1 = t1_16 - t1_17 + Pddot1_1 - minus_U1_11 * T(0.02);
  const T a1_2 = Pddot1_2 + U1_12 * T(0.02) + minus_U1_22 * T(0.01) + U1_23 * T(0.03);
  const T t1_18 = U1_13 * T(0.02);
  const T t1_19 = U1_23 * T(0.01);
  const T a1_3 = t1_18 - t1_19 + Pddot1_3 - minus_U1_33 * T(0.03);
  // G1 = R1 F1 - m1 a1: applied less inertia force, body axes [N]
  const T G1_1 = R1_13 * u.thrust - T(8) * a1_1;
  const T G1_2 = R1_23 * u.thrust - T(8) * a1_2;
  const T G1_3 = R1_33 * u.thrust - T(8) * a1_3;
  // N1 = -omega1~ I1 omega1 + M1: applied less inertia moment about the mass centre, body axes [N m]
  const T N1_1 = t1_17 + t1_18 + T(0.1) - T(0.19999999999999996) * U1_23 - T(0.03) * (t1_14 - t1_13);
  const T N1_2 = T(0.09999999999999998) * U1_13 + T(0.01) * (t1_13 - t1_15) - T(0.02) * U1_23 + T(0.03) * U1_12 +
      T(0.2) * cos(T(2) * t);
  const T minus_N1_3 = t1_16 + t1_19 + T(0.02) * (t1_15 - t1_14) - T(0.09999999999999998) * U1_12;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * T(0.2) + R1_21 * T(0.1) - R1_31 * T(0.2);
  const T P2_2 = s1_2 + R1_12 * T(0.2) + R1_22 * T(0.1) - R1_32 * T(0.2);
  const T P2_3 = s1_3 + R1_13 * T(0.2) + R1_23 * T(0.1) - R1_33 * T(0.2);
  // U2 = omega2~ omega2~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T U2_12 = omega2_2 * omega2_1;
  const T U2_13 = omega2_3 * omega2_1;
  const T t2_13 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_13 + omega2_3 * omega2_3;
  const T U2_23 = omega2_3 * omega2_2;
  const T minus_U2_33 = t2_13 + omega2_2 * omega2_2;
  // Pddot2 = R1^T (U1 q2 + Pddot1): acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t2_14 = Pddot1_1 + U1_12 * T(0.1);
  const T t2_15 = minus_U1_11 * T(0.2);
  const T t2_16 = U1_13 * T(0.2);
  const T t2_17 = t2_14 - t2_15 - t2_16;
  const T t2_18 = U1_12 * T(0.2);
  const T t2_19 = minus_U1_22 * T(0.1) - Pddot1_2;
  const T t2_20 = t2_18 - t2_19 - U1_23 * T(0.2);
  const T t2_21 = U1_23 * T(0.1);
  const T t2_22 = Pddot1_3 + t2_21;
  const T t2_23 = t2_16 + t2_22 + minus_U1_33 * T(0.2);
  const T Pddot2_1 = R1_11 * t2_17 + R1_21 * t2_20 + R1_31 * t2_23;
  const T Pddot2_2 = R1_12 * t2_17 + R1_22 * t2_20 + R1_32 * t2_23;
  const T Pddot2_3 = R1_13 * t2_17 + R1_23 * t2_20 + R1_33 * t2_23;
  // a2 = R2^T U2 r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_24 = U2_12 * T(0.02) - U2_13 * T(0.2);
  const T t2_25 = minus_U2_22 * T(0.02) + U2_23 * T(0.2);
  const T t2_26 = U2_23 * T(0.02) + minus_U2_33 * T(0.2);
  const T a2_1 = Pddot2_1 + R2_11 * t2_24 - R2_21 * t2_25 + R2_31 * t2_26;
  const T a2_2 = Pddot2_2 + R2_12 * t2_24 - R2_22 * t2_25 + R2_32 * t2_26;
  const T a2_3 = Pddot2_3 + R2_13 * t2_24 - R2_23 * t2_25 + R2_33 * t2_26;

  // ---- body 3 (boom) on body 1
  const T theta3 = x[8];
  const T thetadot3 = y[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T t3_18 = E3_11 * omega1_1 + E3_12 * omega1_2 - minus_E3_13 * omega1_3;
  const T omega3_1 = t3_18 - thetadot3 * T(0.3152711589176631);
  const T t3_19 = E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_2 = t3_19 + thetadot3 * T(0.44378789320576517);
  const T t3_20 = E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  const T omega3_3 = t3_20 + thetadot3 * T(0.8388422987658062);
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_21 = s1_1 + R1_31 * T(0.1);
  const T P3_1 = t3_21 + R1_11 * T(0.3);
  const T t3_22 = s1_2 + R1_32 * T(0.1);
  const T P3_2 = t3_22 + R1_12 * T(0.3);
  const T t3_23 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_23 + R1_13 * T(0.3);
  // stretch_boom_3 = theta3 - l_boom_: stretch of the spring
  const T stretch_boom_3 = theta3 - T(0.2);
  // effort_boom_3 = -thetadot3 c_boom_ + tau_boom_ - stretch_boom_3 k_boom_: along the coordinate [N m], [N]
  const T effort_boom_3 = u.motor - T(0.1) * tanh(thetadot3 * T(100)) - thetadot3 * T(0.5) - c.p.k * stretch_boom_3;
  // omegadot3 = -thetadot3 b3~ E3 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot3_1 = thetadot3 * (T(0.44378789320576517) * t3_20 - T(0.8388422987658062) * t3_19);
  const T minus_omegadot3_2 = thetadot3 * (T(0.8388422987658062) * t3_18 + T(0.3152711589176631) * t3_20);
  const T omegadot3_3 = thetadot3 * (T(0.3152711589176631) * t3_19 + T(0.44378789320576517) * t3_18);
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_24 = omega3_3 * omega3_3;
  const T t3_25 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_24 + t3_25;
  const T t3_26 = omega3_2 * omega3_1;
  const T U3_12 = t3_26 - omegadot3_3;
  const T t3_27 = omega3_3 * omega3_1;
  const T U3_13 = t3_27 - minus_omegadot3_2;
  const T U3_21 = t3_26 + omegadot3_3;
  const T t3_28 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_24 + t3_28;
  const T t3_29 = omega3_3 * omega3_2;
  const T U3_23 = t3_29 + minus_omegadot3_1;
  const T U3_31 = t3_27 + minus_omegadot3_2;
  const T U3_32 = t3_29 - minus_omegadot3_1;
  const T minus_U3_33 = t3_25 + t3_28;
  // Pddot3 = E3 (U1 q3 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_30 = Pddot1_1 + U1_13 * T(0.1);
  const T t3_31 = t3_30 - minus_U1_11 * T(0.3);
  const T t3_32 = U1_12 * T(0.3);
  const T t3_33 = Pddot1_2 + t2_21;
  const T t3_34 = t3_32 + t3_33;
  const T t3_35 = minus_U1_33 * T(0.1) - Pddot1_3;
  const T t3_36 = U1_13 * T(0.3) - t3_35;
  const T Pddot3_1 = E3_11 * t3_31 + E3_12 * t3_34 - minus_E3_13 * t3_36;
  const T Pddot3_2 = E3_21 * t3_31 + E3_22 * t3_34 + E3_23 * t3_36;
  const T Pddot3_3 = E3_31 * t3_31 + E3_32 * t3_34 + E3_33 * t3_36;
  // G2 = -R3^T F_jet_ - m2 a2: applied less inertia force, inertial axes [N]
  const T t3_37 = T(0.5) * u.thrust * exp(T(0) - t);
  const T t3_38 = R3_11 * T(0.1) + R3_21 * t3_37;
  const T minus_G2_1 = t3_38 + T(0.8) * a2_1;
  const T t3_39 = R3_12 * T(0.1) + R3_22 * t3_37;
  const T minus_G2_2 = t3_39 + T(0.8) * a2_2;
  const T t3_40 = R3_13 * T(0.1) + R3_23 * t3_37;
  const T minus_G2_3 = t3_40 + T(0.8) * a2_3;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a3_1 = Pddot3_1 + U3_12 * T(0.02) - minus_U3_11 * T(0.2);
  const T a3_2 = Pddot3_2 + U3_21 * T(0.2) - minus_U3_22 * T(0.02);
  const T a3_3 = Pddot3_3 + U3_31 * T(0.2) + U3_32 * T(0.02);
  // G3 = -m3 a3: applied less inertia force, body axes [N]
  const T minus_G3_1 = T(1.5) * a3_1;
  const T minus_G3_2 = T(1.5) * a3_2;
  const T minus_G3_3 = T(1.5) * a3_3;
  // N3 = -axial(U3 (tr(I3)/2 - I3)): applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N3_1 = T(0.004999999999999999) * U3_32 - T(0.035) * U3_23 + T(0.003) * (minus_U3_22 - minus_U3_33) -
      T(0.002) * U3_31 + T(0.001) * U3_21;
  const T minus_N3_2 = T(0.035) * U3_13 - T(0.015000000000000001) * U3_31 - T(0.001) * (minus_U3_33 - minus_U3_11) +
      T(0.003) * U3_12 + T(0.002) * U3_32;
  const T minus_N3_3 = T(0.015000000000000001) * U3_21 - T(0.004999999999999999) * U3_12 - T(0.002) * (minus_U3_11 -
      minus_U3_22) - T(0.001) * U3_23 - T(0.003) * U3_13;

  // ---- body 4 (cross) on body 1
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // omega4a = thetadot4_1 b4_1 + E4a omega1: absolute angular velocity, body axes [rad/s]
  const T omega4a_1 = E4a_11 * omega1_1 - minus_E4a_12 * omega1_2 - minus_E4a_13 * omega1_3;
  const T t4_3 = minus_E4a_12 * omega1_1 + E4a_22 * omega1_2 + E4a_23 * omega1_3;
  const T omega4a_2 = t4_3 + thetadot4_1 * T(0.28);
  const T t4_4 = minus_E4a_13 * omega1_1 + E4a_23 * omega1_2 + E4a_33 * omega1_3;
  const T omega4a_3 = t4_4 - thetadot4_1 * T(0.96);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_5 = cosines[10];
  const T E4_12 = T(0.28) * t4_5;
  const T minus_E4_13 = T(0.96) * t4_5;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // omega4 = thetadot4_2 b4_2 + E4 omega4a: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega4a_2 - minus_E4_11 * omega4a_1 - minus_E4_13 * omega4a_3;
  const T omega4_2 = thetadot4_2 + T(0.96) * omega4a_2 + T(0.28) * omega4a_3;
  const T omega4_3 = t4_5 * omega4a_1 + E4_32 * omega4a_2 - minus_E4_33 * omega4a_3;
  // omegadot4a = -thetadot4_1 b4_1~ E4a omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot4a_1 = thetadot4_1 * (T(0.96) * t4_3 + T(0.28) * t4_4);
  const T omegadot4a_2 = T(0.96) * omega4a_1 * thetadot4_1;
  const T omegadot4a_3 = T(0.28) * omega4a_1 * thetadot4_1;
  // Pddot4a = E4a (U1 q4a + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_6 = t2_15 + t2_14;
  const T t4_7 = t2_18 + t2_19;
  const T t4_8 = t2_22 - t2_16;
  const T Pddot4a_1 = E4a_11 * t4_6 + minus_E4a_12 * t4_7 - minus_E4a_13 * t4_8;
  const T Pddot4a_2 = minus_E4a_12 * t4_6 - E4a_22 * t4_7 + E4a_23 * t4_8;
  const T Pddot4a_3 = minus_E4a_13 * t4_6 - E4a_23 * t4_7 + E4a_33 * t4_8;
  // omegadot4 = -thetadot4_2 b4_2~ E4 omega4a + E4 omegadot4a: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = minus_E4_11 * minus_omegadot4a_1 + E4_12 * omegadot4a_2 - minus_E4_13 * omegadot4a_3 -
      thetadot4_2 * omega4_3;
  const T omegadot4_2 = T(0.96) * omegadot4a_2 + T(0.28) * omegadot4a_3;
  const T omegadot4_3 = thetadot4_2 * omega4_1 + E4_32 * omegadot4a_2 - t4_5 * minus_omegadot4a_1 - minus_E4_33 *
      omegadot4a_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_9 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_9 + omega4_3 * omega4_3;
  const T t4_10 = omega4_2 * omega4_1;
  const T U4_12 = t4_10 - omegadot4_3;
  const T t4_11 = omega4_3 * omega4_1;
  const T U4_13 = t4_11 + omegadot4_2;
  const T U4_21 = t4_10 + omegadot4_3;
  const T t4_12 = omega4_3 * omega4_2;
  const T U4_23 = t4_12 - omegadot4_1;
  const T U4_31 = t4_11 - omegadot4_2;
  const T U4_32 = t4_12 + omegadot4_1;
  const T minus_U4_33 = t4_9 + omega4_1 * omega4_1;
  // Pddot4 = E4 Pddot4a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot4_1 = E4_12 * Pddot4a_2 - minus_E4_11 * Pddot4a_1 - minus_E4_13 * Pddot4a_3;
  const T Pddot4_2 = T(0.96) * Pddot4a_2 + T(0.28) * Pddot4a_3;
  const T Pddot4_3 = t4_5 * Pddot4a_1 + E4_32 * Pddot4a_2 - minus_E4_33 * Pddot4a_3;
  // a4 = U4 r4 + Pddot4: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a4_1 = Pddot4_1 + U4_13 * T(0.1) - minus_U4_11 * T(0.03);
  const T a4_2 = Pddot4_2 + U4_21 * T(0.03) + U4_23 * T(0.1);
  const T a4_3 = Pddot4_3 + U4_31 * T(0.03) - minus_U4_33 * T(0.1);
  // G4 = -m4 a4: applied less inertia force, body axes [N]
  const T minus_G4_1 = T(0.9) * a4_1;
  const T minus_G4_2 = T(0.9) * a4_2;
  const T minus_G4_3 = T(0.9) * a4_3;
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N4_1 = T(0.006500000000000001) * U4_32 - T(0.0015) * U4_23;
  const T minus_N4_2 = T(0.0015) * U4_13 - T(0.0055) * U4_31;
  const T minus_N4_3 = T(0.0055) * U4_21 - T(0.006500000000000001) * U4_12;

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T t5_2 = sin(t5_1);
  const T theta5_2 = c.p.amplitude * t5_2;
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // thetaddot5_2 = d^2/dt^2 expression 1: prescribed
  const T minus_thetaddot5_2 = t5_2 * T(3) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = t3_21 - R1_21 * T(0.3);
  const T P5a_2 = t3_22 - R1_22 * T(0.3);
  const T P5a_3 = t3_23 - R1_23 * T(0.3);
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_3 = omega1_2 * T(0.1);
  const T t5_4 = omega1_3 * T(0.3) + t5_3;
  const T t5_5 = omega1_1 * T(0.1);
  const T t5_6 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_4 - R1_21 * t5_5 - R1_31 * t5_6;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_4 - R1_22 * t5_5 - R1_32 * t5_6;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_4 - R1_23 * t5_5 - R1_33 * t5_6;
  // omegadot5a = -thetadot5_1 b5_1~ E5a omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot5a_1 = thetadot5_1 * omega5a_2;
  const T minus_omegadot5a_2 = thetadot5_1 * omega5a_1;
  // Pddot5a = E5a (U1 q5a + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_7 = t3_30 - t3_32;
  const T t5_8 = t3_33 + minus_U1_22 * T(0.3);
  const T Pddot5a_1 = E5a_11 * t5_7 + E5a_12 * t5_8;
  const T Pddot5a_2 = E5a_11 * t5_8 - E5a_12 * t5_7;
  const T minus_Pddot5a_3 = t3_35 + U1_23 * T(0.3);
  // omegadot5 = -thetadot5_2 b5_2~ E5 omega5a + thetaddot5_2 b5_2 + E5 omegadot5a: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5_1 = omegadot5a_1 - minus_thetaddot5_2;
  const T omegadot5_2 = thetadot5_2 * omega5_3 - E5_22 * minus_omegadot5a_2;
  const T omegadot5_3 = E5_23 * minus_omegadot5a_2 - thetadot5_2 * omega5_2;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_9 = omega5_2 * omega5_2;
  const T minus_U5_11 = omega5_3 * omega5_3 + t5_9;
  const T t5_10 = omega5_2 * omega5_1;
  const T U5_12 = t5_10 - omegadot5_3;
  const T t5_11 = omega5_3 * omega5_1;
  const T U5_13 = t5_11 + omegadot5_2;
  const T U5_21 = t5_10 + omegadot5_3;
  const T t5_12 = omega5_3 * omega5_2;
  const T U5_23 = t5_12 - omegadot5_1;
  const T U5_31 = t5_11 - omegadot5_2;
  const T U5_32 = t5_12 + omegadot5_1;
  const T minus_U5_33 = t5_9 + omega5_1 * omega5_1;
  // Pddot5 = E5 Pddot5a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_2 = E5_22 * Pddot5a_2 - E5_23 * minus_Pddot5a_3;
  const T minus_Pddot5_3 = E5_22 * minus_Pddot5a_3 + E5_23 * Pddot5a_2;
  // a5 = U5 r_link5 + Pddot5: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a5_1 = Pddot5a_1 + U5_13 * c.r_link5_3 - minus_U5_11 * c.r_link5_1;
  const T a5_2 = Pddot5_2 + U5_21 * c.r_link5_1 + U5_23 * c.r_link5_3;
  const T a5_3 = U5_31 * c.r_link5_1 - minus_Pddot5_3 - minus_U5_33 * c.r_link5_3;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_1 = P3_1 + R3_11 * d6_1;
  const T P6_2 = P3_2 + R3_12 * d6_1;
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // effort_telescope_6 = -sdot6 c_telescope_: along the coordinate [N m], [N]
  const T minus_effort_telescope_6 = sdot6 * (T(2) + abs(sdot6));
  // Pddot6 = 2 sdot6 omega3~ u6 + U3 d6 + Pddot3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = Pddot3_1 - minus_U3_11 * d6_1;
  const T t6_1 = T(2) * sdot6;
  const T Pddot6_2 = Pddot3_2 + t6_1 * omega3_3 + U3_21 * d6_1;
  const T Pddot6_3 = Pddot3_3 + U3_31 * d6_1 - t6_1 * omega3_2;
  // arm2 = R2 R3^T r_jet_ - R2 P2 + R2 P6
  const T t6_2 = R3_11 * T(0.2);
  const T t6_3 = R3_12 * T(0.2);
  const T t6_4 = R3_13 * T(0.2);
  const T arm2_1 = R2_11 * t6_2 + R2_12 * t6_3 + R2_13 * t6_4 - R2_11 * P2_1 - R2_12 * P2_2 - R2_13 * P2_3 + R2_11 *
      P6_1 + R2_12 * P6_2 + R2_13 * P6_3;
  const T arm2_2 = R2_21 * t6_2 + R2_22 * t6_3 + R2_23 * t6_4 - R2_21 * P2_1 - R2_22 * P2_2 - R2_23 * P2_3 + R2_21 *
      P6_1 + R2_22 * P6_2 + R2_23 * P6_3;
  const T arm2_3 = R2_31 * t6_2 + R2_32 * t6_3 + R2_33 * t6_4 - R2_31 * P2_1 - R2_32 * P2_2 - R2_33 * P2_3 + R2_31 *
      P6_1 + R2_32 * P6_2 + R2_33 * P6_3;
  // lever2 = -r2 + arm2: from the reference point to where a force acts, link axes [m]
  const T lever2_2 = arm2_2 - T(0.02);
  const T lever2_3 = arm2_3 + T(0.2);
  // N2 = -omega2~ I2 omega2 - lever2~ R2 R3^T F_jet_: applied less inertia moment about the mass centre, body axes [N
  //   m]
  const T t6_5 = R2_31 * t3_38 + R2_32 * t3_39 + R2_33 * t3_40;
  const T t6_6 = R2_21 * t3_38 + R2_22 * t3_39 + R2_23 * t3_40;
  const T minus_N2_1 = lever2_2 * t6_5 - lever2_3 * t6_6 - T(0.006999999999999999) * U2_23;
  const T t6_7 = R2_11 * t3_38 + R2_12 * t3_39 + R2_13 * t3_40;
  const T minus_N2_2 = T(0.006) * U2_13 + lever2_3 * t6_7 - arm2_1 * t6_5;
  const T minus_N2_3 = T(0.0009999999999999992) * U2_12 + arm2_1 * t6_6 - lever2_2 * t6_7;
  // a6 = U3 r6 + Pddot6: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a6_1 = Pddot6_1 + U3_13 * T(0.01) - minus_U3_11 * T(0.1);
  const T a6_2 = Pddot6_2 + U3_21 * T(0.1) + U3_23 * T(0.01);
  const T a6_3 = Pddot6_3 + U3_31 * T(0.1) - minus_U3_33 * T(0.01);
  // G6 = -m6 a6 + F_jet_: applied less inertia force, body axes [N]
  const T G6_1 = T(0.1) - T(0.5) * a6_1;
  const T G6_2 = t3_37 - T(0.5) * a6_2;
  const T minus_G6_3 = T(0.5) * a6_3;
  // N6 = -axial(U3 (tr(I6)/2 - I6)) + lever6~ F_jet_: applied less inertia moment about the mass centre, body axes [N
  //   m]
  const T N6_1 = T(5e-04) * U3_23 - T(5e-04) * U3_32 + T(0.01) * t3_37;
  const T minus_N6_2 = T(0.001) + T(5e-04) * U3_13 - T(0.0055) * U3_31;
  const T N6_3 = T(5e-04) * U3_12 - T(0.0055) * U3_21 + T(0.1) * t3_37;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  const T thetadot8 = y[10];
  const T sdot8 = y[22];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega1_1 + E8_13 * omega1_3;
  const T omega8_2 = omega1_2 - thetadot8;
  const T omega8_3 = E8_11 * omega1_3 - E8_13 * omega1_1;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // omegadot8 = -thetadot8 b8~ E8 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot8_1 = thetadot8 * omega8_3;
  const T minus_omegadot8_3 = thetadot8 * omega8_1;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_1 = omega8_3 * omega8_3;
  const T t8_2 = omega8_2 * omega8_2;
  const T minus_U8_11 = t8_1 + t8_2;
  const T t8_3 = omega8_2 * omega8_1;
  const T U8_12 = t8_3 + minus_omegadot8_3;
  const T U8_13 = omega8_3 * omega8_1;
  const T U8_21 = t8_3 - minus_omegadot8_3;
  const T t8_4 = omega8_1 * omega8_1;
  const T minus_U8_22 = t8_1 + t8_4;
  const T t8_5 = omega8_3 * omega8_2;
  const T U8_23 = t8_5 - omegadot8_1;
  const T U8_32 = t8_5 + omegadot8_1;
  const T minus_U8_33 = t8_2 + t8_4;
  // Pddot8 = E8 (omega1~ (omega1~ d8 + 2 sdot8 u8) + Pddot1): acceleration of the body origin, less gravity, body
  //   axes [m/s^2]
  const T t8_6 = T(2) * sdot8;
  const T t8_7 = omega1_1 * d8_2;
  const T t8_8 = Pddot1_1 + t8_6 * omega1_3 + omega1_2 * t8_7;
  const T t8_9 = omega1_3 * d8_2;
  const T t8_10 = Pddot1_3 + omega1_2 * t8_9 - t8_6 * omega1_1;
  const T Pddot8_1 = E8_11 * t8_8 + E8_13 * t8_10;
  const T Pddot8_2 = Pddot1_2 - omega1_3 * t8_9 - omega1_1 * t8_7;
  const T Pddot8_3 = E8_11 * t8_10 - E8_13 * t8_8;
  // a8 = U8 r_link8 + Pddot8: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a8_1 = Pddot8_1 + minus_U8_11 * T(0.01) - U8_12 * T(0.1) + U8_13 * T(0.02);
  const T a8_2 = Pddot8_2 + minus_U8_22 * T(0.1) - U8_21 * T(0.01) + U8_23 * T(0.02);
  const T a8_3 = Pddot8_3 - U8_13 * T(0.01) - U8_32 * T(0.1) - minus_U8_33 * T(0.02);
  // G8 = -m8 a8: applied less inertia force, body axes [N]
  const T minus_G8_1 = T(0.7) * a8_1;
  const T minus_G8_2 = T(0.7) * a8_2;
  const T minus_G8_3 = T(0.7) * a8_3;
  // N8 = -axial(U8 (tr(I_link8)/2 - I_link8)): applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N8_1 = T(0.0025) * U8_32 - T(5e-04) * U8_23;
  const T N8_2 = T(0.001) * U8_13;
  const T minus_N8_3 = T(0.0015) * U8_21 - T(0.0025) * U8_12;

  // ---- body 9 (sled) on the inertial frame
  const T s9_1 = x[26], s9_2 = x[27];
  const T thetadot9 = y[11];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // line_tether_9 = -R5^T C12^T r_tether_ - R5^T o5 + E9^T r_tether_other_ - P5a + d9: from one end of the spring to
  //   the other, inertial axes [m]
  const T line_tether_9_1 = s9_1 - P5a_1 + E9_11 * T(0.1) - R5_21 * T(0.02) - T(0.03620228586010676) * R5a_11 -
      T(0.06743336618301184) * R5_31;
  const T line_tether_9_2 = d9_2 - P5a_2 + E9_12 * T(0.1) - R5_22 * T(0.02) - T(0.03620228586010676) * R5a_12 -
      T(0.06743336618301184) * R5_32;
  const T line_tether_9_3 = T(0.1) - P5a_3 - R5_23 * T(0.02) - T(0.03620228586010676) * R5a_13 -
      T(0.06743336618301184) * R5_33;
  // ll_tether_9 = 1e-36 + line_tether_9 . line_tether_9: length squared [m^2]
  const T ll_tether_9 = T(1e-36) + line_tether_9_1 * line_tether_9_1 + line_tether_9_2 * line_tether_9_2 +
      line_tether_9_3 * line_tether_9_3;
  // length_tether_9 = ll_tether_9^1/2: length [m]
  const T length_tether_9 = sqrt(ll_tether_9);
  // line_rate_tether_9 = -R5^T omega5~ C12^T r_tether_ - R5^T omega5~ o5 + E9^T omega9~ r_tether_other_ - Pdot5a +
  //   Pdot9: its rate [m/s]
  const T t9_1 = thetadot9 * T(0.1);
  const T t9_2 = omega5_2 * T(0.07741670784769467) - omega5_3 * T(0.02);
  const T t9_3 = omega5_3 * T(0.06329813066769584) + omega5_1 * T(0.07741670784769467);
  const T t9_4 = omega5_1 * T(0.02) + omega5_2 * T(0.06329813066769584);
  const T t9_5 = omega5_3 * T(0.09950041652780259) + omega5_1 * T(0.009983341664682815);
  const T t9_6 = omega5_2 * T(0.009983341664682815);
  const T t9_7 = omega5_2 * T(0.09950041652780259);
  const T line_rate_tether_9_1 = sdot9_1 - Pdot5a_1 - E9_12 * t9_1 - R5a_11 * t9_2 + R5_21 * t9_3 - R5_31 * t9_4 -
      R5_21 * t9_5 + R5a_11 * t9_6 + R5_31 * t9_7;
  const T line_rate_tether_9_2 = sdot9_2 - Pdot5a_2 + R5_22 * t9_3 - R5a_12 * t9_2 - R5_32 * t9_4 - R5_22 * t9_5 +
      R5a_12 * t9_6 + R5_32 * t9_7 + E9_11 * t9_1;
  const T minus_line_rate_tether_9_3 = Pdot5a_3 + R5a_13 * t9_2 - R5_23 * t9_3 + R5_33 * t9_4 + R5_23 * t9_5 - R5a_13
      * t9_6 - R5_33 * t9_7;
  // f_tether_9 = k_tether_ - k_tether_ l_tether_ length_tether_9^-1 + c_tether_ line_tether_9 . line_rate_tether_9
  //   ll_tether_9^-1: attraction by the length [N/m]
  const T f_tether_9 = c.p.k - T(1) / length_tether_9 * c.c9_1 + T(0.4) * (line_tether_9_1 * line_rate_tether_9_1 +
      line_tether_9_2 * line_rate_tether_9_2 - line_tether_9_3 * minus_line_rate_tether_9_3) * (T(1) / ll_tether_9);
  // F_tether_9 = f_tether_9 line_tether_9: on the first end, inertial axes [N]
  const T F_tether_9_1 = f_tether_9 * line_tether_9_1;
  const T F_tether_9_2 = f_tether_9 * line_tether_9_2;
  const T F_tether_9_3 = f_tether_9 * line_tether_9_3;
  // U9 = omega9~ omega9~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T minus_U9_11 = thetadot9 * thetadot9;
  // G5 = R5 F_tether_9 - m_link5 a5: applied less inertia force, body axes [N]
  const T t9_8 = R5a_11 * F_tether_9_1 + R5a_12 * F_tether_9_2 + R5a_13 * F_tether_9_3;
  const T G5_1 = t9_8 - c.m_link5 * a5_1;
  const T t9_9 = R5_21 * F_tether_9_1 + R5_22 * F_tether_9_2 + R5_23 * F_tether_9_3;
  const T G5_2 = t9_9 - c.m_link5 * a5_2;
  const T t9_10 = R5_31 * F_tether_9_1 + R5_32 * F_tether_9_2 + R5_33 * F_tether_9_3;
  const T G5_3 = t9_10 - c.m_link5 * a5_3;
  // N5 = -axial(U5 (tr(I_link5)/2 - I_link5)) + lever5~ R5 F_tether_9: applied less inertia moment about the mass
  //   centre, body axes [N m]
  const T N5_1 = T(0.02) * t9_10 - c.lever5_3 * t9_9 - c.c9_3 * U5_32 + c.c9_4 * U5_23 - c.I_link5_13 * U5_21;
  const T N5_2 = c.lever5_3 * t9_8 - c.lever5_1 * t9_10 - c.c9_4 * U5_13 + c.c9_2 * U5_31 + c.I_link5_13 *
      (minus_U5_33 - minus_U5_11);
  const T N5_3 = c.lever5_1 * t9_9 - T(0.02) * t9_8 - c.c9_2 * U5_21 + c.c9_3 * U5_12 + c.I_link5_13 * U5_23;
  // a9 = U9 r9 + Pddot9: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T minus_a9_1 = minus_U9_11 * T(0.1);
  // G9 = -E9 F_tether_9 - m9 a9: applied less inertia force, body axes [N]
  const T G9_1 = T(2) * minus_a9_1 - (E9_11 * F_tether_9_1 + E9_12 * F_tether_9_2);
  const T minus_G9_2 = E9_11 * F_tether_9_2 - E9_12 * F_tether_9_1;
  // N9 = -axial(U9 (tr(I9)/2 - I9)) - lever9~ E9 F_tether_9: applied less inertia moment about the mass centre, body
  //   axes [N m]
  const T N9_1 = T(0.1) * minus_G9_2;
  f[11] = -N9_1;

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  const T omega10_1 = y[12], omega10_2 = y[13], omega10_3 = y[14];
  const T sdot10 = y[25];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // U10 = omega10~ omega10~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t10_13 = omega10_3 * omega10_3;
  const T t10_14 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_13 + t10_14;
  const T U10_12 = omega10_2 * omega10_1;
  const T U10_13 = omega10_3 * omega10_1;
  const T t10_15 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_13 + t10_15;
  const T U10_23 = omega10_3 * omega10_2;
  const T minus_U10_33 = t10_14 + t10_15;
  // Pddot10 = R1^T (omega1~ (omega1~ d10 + 2 sdot10 u10) + Pddot1): acceleration of the body origin, less gravity,
  //   inertial axes [m/s^2]
  const T t10_16 = omega1_1 * s10 - t5_3;
  const T t10_17 = omega1_3 * T(0.1) - t5_6 + T(2) * sdot10;
  const T t10_18 = Pddot1_1 + omega1_2 * t10_16 - omega1_3 * t10_17;
  const T t10_19 = omega1_2 * T(0.3) - omega1_3 * s10;
  const T t10_20 = Pddot1_2 + omega1_3 * t10_19 - omega1_1 * t10_16;
  const T t10_21 = Pddot1_3 + omega1_1 * t10_17 - omega1_2 * t10_19;
  const T Pddot10_1 = R1_11 * t10_18 + R1_21 * t10_20 + R1_31 * t10_21;
  const T Pddot10_2 = R1_12 * t10_18 + R1_22 * t10_20 + R1_32 * t10_21;
  const T Pddot10_3 = R1_13 * t10_18 + R1_23 * t10_20 + R1_33 * t10_21;
  // a10 = R10^T U10 r10 + Pddot10: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t10_22 = U10_12 * T(0.01) - minus_U10_11 * T(0.02) - U10_13 * T(0.03);
  const T t10_23 = U10_12 * T(0.02) - minus_U10_22 * T(0.01) - U10_23 * T(0.03);
  const T t10_24 = U10_13 * T(0.02) + U10_23 * T(0.01) + minus_U10_33 * T(0.03);
  const T a10_1 = Pddot10_1 + R10_11 * t10_22 + R10_21 * t10_23 + R10_31 * t10_24;
  const T a10_2 = Pddot10_2 + R10_12 * t10_22 + R10_22 * t10_23 + R10_32 * t10_24;
  const T a10_3 = Pddot10_3 + R10_13 * t10_22 + R10_23 * t10_23 + R10_33 * t10_24;
  // G10 = -m10 a10: applied less inertia force, inertial axes [N]
  const T minus_G10_1 = T(0.4) * a10_1;
  const T minus_G10_2 = T(0.4) * a10_2;
  const T minus_G10_3 = T(0.4) * a10_3;
  // N10 = -omega10~ I10 omega10: applied less inertia moment about the mass centre, body axes [N m]
  const T N10_1 = T(5e-04) * U10_23;
  const T N10_2 = T(5e-04) * U10_13;
  const T minus_N10_3 = T(0.001) * U10_12;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  const T thetadot11 = y[15];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega8_1 + E11_13 * omega8_3;
  const T omega11_2 = omega8_2 - thetadot11;
  const T omega11_3 = E11_11 * omega8_3 - E11_13 * omega8_1;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // effort_nut_11 = -thetadot11 c_nut_: along the coordinate [N m], [N]
  const T minus_effort_nut_11 = thetadot11 * T(0.002);
  // omegadot11 = -thetadot11 b11~ E11 omega8 + E11 omegadot8: angular acceleration, body axes [rad/s^2]
  const T omegadot11_1 = thetadot11 * omega11_3 + E11_11 * omegadot8_1 - E11_13 * minus_omegadot8_3;
  const T minus_omegadot11_3 = thetadot11 * omega11_1 + E11_13 * omegadot8_1 + E11_11 * minus_omegadot8_3;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_1 = omega11_2 * omega11_1;
  const T U11_12 = t11_1 + minus_omegadot11_3;
  const T U11_13 = omega11_3 * omega11_1;
  const T U11_21 = t11_1 - minus_omegadot11_3;
  const T t11_2 = omega11_3 * omega11_2;
  const T U11_23 = t11_2 - omegadot11_1;
  const T U11_32 = t11_2 + omegadot11_1;
  const T minus_U11_33 = omega11_2 * omega11_2 + omega11_1 * omega11_1;
  // Pddot11 = E11 (2 thetadot11 pitch11 omega8~ u11 + U8 d11 + Pddot8): acceleration of the body origin, less
  //   gravity, body axes [m/s^2]
  const T t11_3 = T(2) * thetadot11 * T(0.01);
  const T t11_4 = Pddot8_1 + t11_3 * omega8_3 - U8_12 * minus_d11_2;
  const T t11_5 = Pddot8_3 - t11_3 * omega8_1 - U8_32 * minus_d11_2;
  const T Pddot11_1 = E11_11 * t11_4 + E11_13 * t11_5;
  const T Pddot11_2 = Pddot8_2 + minus_U8_22 * minus_d11_2;
  const T Pddot11_3 = E11_11 * t11_5 - E11_13 * t11_4;
  // a11 = U11 r_link11 + Pddot11: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a11_1 = Pddot11_1 + U11_13 * T(0.01);
  const T a11_2 = Pddot11_2 + U11_23 * T(0.01);
  const T a11_3 = Pddot11_3 - minus_U11_33 * T(0.01);
  // G11 = -m11 a11: applied less inertia force, body axes [N]
  const T minus_G11_1 = T(0.3) * a11_1;
  const T minus_G11_2 = T(0.3) * a11_2;
  const T minus_G11_3 = T(0.3) * a11_3;
  // N11 = C11^T M_coupling_ - axial(U11 (tr(I_link11)/2 - I_link11)): applied less inertia moment about the mass
  //   centre, body axes [N m]
  const T minus_N11_1 = T(0.00010000000000000005) * U11_32 - T(3e-04) * U11_23;
  const T minus_N11_2 = T(0.02) * u.motor;
  const T minus_N11_3 = T(3e-04) * U11_21 - T(0.00010000000000000005) * U11_12;

  // ---- body 11 (nut) and what it carries
  // rho11 = r_link11~ G11 + N11: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T b11_1 = minus_G11_2 * T(0.01);
  const T rho11_1 = b11_1 - minus_N11_1;
  const T minus_rho11_2 = T(0.01) * minus_G11_1 + minus_N11_2;
  // f_theta11 = b11 . G11 pitch11 + b11 . rho11 + effort_nut_11: Kane's equation of the angle [N m]
  const T f_theta11 = b11_1 + minus_rho11_2 - minus_effort_nut_11;
  f[15] = f_theta11;

  // ---- body 10 (runner) and what it carries
  // f_omega10 = r10~ R10 G10 + N10: Kane's equation of omega [N m]
  const T b10_1 = R10_21 * minus_G10_1 + R10_22 * minus_G10_2 + R10_23 * minus_G10_3;
  const T b10_2 = R10_31 * minus_G10_1 + R10_32 * minus_G10_2 + R10_33 * minus_G10_3;
  const T f_omega10_1 = N10_1 - (T(0.03) * b10_1 + T(0.01) * b10_2);
  const T b10_3 = R10_11 * minus_G10_1 + R10_12 * minus_G10_2 + R10_13 * minus_G10_3;
  const T f_omega10_2 = T(0.03) * b10_3 + T(0.02) * b10_2 + N10_2;
  const T f_omega10_3 = T(0.01) * b10_3 - T(0.02) * b10_1 - minus_N10_3;
  f[12] = f_omega10_1;
  f[13] = f_omega10_2;
  f[14] = f_omega10_3;
  // f_sdot1_10 = u10 . (R1 G10): Kane's equation of sdot [N]
  const T minus_f_sdot1_10 = R1_21 * minus_G10_1 + R1_22 * minus_G10_2 + R1_23 * minus_G10_3;
  f[25] = -minus_f_sdot1_10;

  // ---- body 9 (sled) and what it carries
  // f_sdot1_9 = u9_1 . (E9^T G9): Kane's equation of sdot [N]
  const T f_sdot1_9 = E9_11 * G9_1 + E9_12 * minus_G9_2;
  f[23] = f_sdot1_9;
  // f_sdot2_9 = u9_2 . (E9^T G9): Kane's equation of sdot [N]
  const T f_sdot2_9 = E9_12 * G9_1 - E9_11 * minus_G9_2;
  f[24] = f_sdot2_9;

  // ---- body 8 (piston) and what it carries
  // S8 = E11^T G11 + G8: sum of the force balances of the subtree, body axes [N]
  const T b8_1 = E11_13 * minus_G11_3 - E11_11 * minus_G11_1;
  const T S8_1 = b8_1 - minus_G8_1;
  const T minus_S8_2 = minus_G11_2 + minus_G8_2;
  const T b8_2 = E11_13 * minus_G11_1 + E11_11 * minus_G11_3;
  const T minus_S8_3 = b8_2 + minus_G8_3;
  f[22] = minus_S8_2;
  // rho8 = E11^T rho11 + r_link8~ G8 + d11~ E11^T G11 + N8: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho8_1 = E11_11 * rho11_1 - minus_N8_1 + E11_13 * minus_N11_3 + T(0.02) * minus_G8_2 + T(0.1) * minus_G8_3 +
      minus_d11_2 * b8_2;
  const T minus_rho8_2 = minus_rho11_2 + T(0.02) * minus_G8_1 + T(0.01) * minus_G8_3 - N8_2;
  const T rho8_3 = E11_13 * rho11_1 - minus_N8_3 - E11_11 * minus_N11_3 + T(0.01) * minus_G8_2 - T(0.1) * minus_G8_1 +
      minus_d11_2 * b8_1;
  f[10] = minus_rho8_2;

  // ---- body 6 (telescope) and what it carries
  // rho6 = r6~ G6 + N6: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho6_1 = N6_1 - T(0.01) * G6_2;
  const T rho6_2 = T(0.01) * G6_1 - minus_N6_2 + T(0.1) * minus_G6_3;
  const T rho6_3 = N6_3 + T(0.1) * G6_2;
  // f_sdot6 = u6 . G6 + effort_telescope_6: Kane's equation of sdot [N]
  const T f_sdot6 = G6_1 - minus_effort_telescope_6;
  f[19] = f_sdot6;

  // ---- body 5 (camera) and what it carries
  // rho5 = r_link5~ G5 + N5: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5_1 = N5_1 - c.r_link5_3 * G5_2;
  const T rho5_2 = N5_2 + c.r_link5_3 * G5_1 - c.r_link5_1 * G5_3;
  const T rho5_3 = N5_3 + c.r_link5_1 * G5_2;
  // S5a = E5^T G5: sum of the force balances of the subtree, body axes [N]
  const T S5a_2 = E5_22 * G5_2 - E5_23 * G5_3;
  const T S5a_3 = E5_23 * G5_2 + E5_22 * G5_3;
  // rho5a = E5^T rho5: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5a_2 = E5_22 * rho5_2 - E5_23 * rho5_3;
  const T rho5a_3 = E5_23 * rho5_2 + E5_22 * rho5_3;
  f[9] = rho5a_3;

  // ---- body 4 (cross) and what it carries
  // rho4 = r4~ G4 + N4: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho4_1 = T(0.1) * minus_G4_2 - minus_N4_1;
  const T rho4_2 = T(0.03) * minus_G4_3 - minus_N4_2 - T(0.1) * minus_G4_1;
  const T minus_rho4_3 = minus_N4_3 + T(0.03) * minus_G4_2;
  f[8] = rho4_2;
  // S4a = E4^T G4: sum of the force balances of the subtree, body axes [N]
  const T S4a_1 = minus_E4_11 * minus_G4_1 - t4_5 * minus_G4_3;
  const T minus_S4a_2 = E4_12 * minus_G4_1 + T(0.96) * minus_G4_2 + E4_32 * minus_G4_3;
  const T S4a_3 = minus_E4_13 * minus_G4_1 - T(0.28) * minus_G4_2 + minus_E4_33 * minus_G4_3;
  // rho4a = E4^T rho4: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T minus_rho4a_1 = minus_E4_11 * rho4_1 + t4_5 * minus_rho4_3;
  const T rho4a_2 = E4_12 * rho4_1 + T(0.96) * rho4_2 - E4_32 * minus_rho4_3;
  const T rho4a_3 = T(0.28) * rho4_2 - minus_E4_13 * rho4_1 + minus_E4_33 * minus_rho4_3;
  // f_theta4a = b4_1 . rho4a: Kane's equation of the angle [N m]
  const T f_theta4a = T(0.28) * rho4a_2 - T(0.96) * rho4a_3;
  f[7] = f_theta4a;

  // ---- body 3 (boom) and what it carries
  // S3 = G3 + G6: sum of the force balances of the subtree, body axes [N]
  const T S3_1 = G6_1 - minus_G3_1;
  const T S3_2 = G6_2 - minus_G3_2;
  const T minus_S3_3 = minus_G3_3 + minus_G6_3;
  // rho3 = r3~ G3 + d6~ G6 + N3 + rho6: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho3_1 = rho6_1 - minus_N3_1 - T(0.02) * minus_G3_3;
  const T rho3_2 = rho6_2 - minus_N3_2 + T(0.2) * minus_G3_3 + d6_1 * minus_G6_3;
  const T rho3_3 = rho6_3 - minus_N3_3 + T(0.02) * minus_G3_1 - T(0.2) * minus_G3_2 + d6_1 * G6_2;
  // f_theta3 = b3 . rho3 + effort_boom_3: Kane's equation of the angle [N m]
  const T f_theta3 = effort_boom_3 + T(0.44378789320576517) * rho3_2 - T(0.3152711589176631) * rho3_1 +
      T(0.8388422987658062) * rho3_3;
  f[6] = f_theta3;

  // ---- body 2 (clapper) and what it carries
  // f_omega2 = r2~ R2 G2 + N2: Kane's equation of omega [N m]
  const T minus_f_omega2_1 = minus_N2_1 + T(0.2) * (R2_21 * minus_G2_1 + R2_22 * minus_G2_2 + R2_23 * minus_G2_3) +
      T(0.02) * (R2_31 * minus_G2_1 + R2_32 * minus_G2_2 + R2_33 * minus_G2_3);
  const T b2_1 = R2_11 * minus_G2_1 + R2_12 * minus_G2_2 + R2_13 * minus_G2_3;
  const T f_omega2_2 = T(0.2) * b2_1 - minus_N2_2;
  const T f_omega2_3 = T(0.02) * b2_1 - minus_N2_3;
  f[3] = -minus_f_omega2_1;
  f[4] = f_omega2_2;
  f[5] = f_omega2_3;

  // ---- body 1 (hull) and what it carries
  // S1 = R1 G2 + R1 G10 + E3^T S3 + E4a^T S4a + E5a^T S5a + E8^T S8 + G1: sum of the force balances of the subtree,
  //   body axes [N]
  const T b1_1 = E3_11 * S3_1 + E3_21 * S3_2 - E3_31 * minus_S3_3;
  const T b1_2 = R1_11 * minus_G2_1 + R1_12 * minus_G2_2 + R1_13 * minus_G2_3;
  const T b1_3 = R1_11 * minus_G10_1 + R1_12 * minus_G10_2 + R1_13 * minus_G10_3;
  const T b1_4 = E4a_11 * S4a_1 - minus_E4a_12 * minus_S4a_2 + minus_E4a_13 * S4a_3;
  const T b1_5 = E5a_11 * G5_1 - E5a_12 * S5a_2;
  const T b1_6 = E8_11 * S8_1 + E8_13 * minus_S8_3;
  const T S1_1 = b1_1 - (b1_2 + b1_3) + b1_4 + b1_5 + b1_6 + G1_1;
  const T b1_7 = E3_12 * S3_1 + E3_22 * S3_2 - E3_32 * minus_S3_3;
  const T b1_8 = R1_21 * minus_G2_1 + R1_22 * minus_G2_2 + R1_23 * minus_G2_3;
  const T b1_9 = E4a_23 * S4a_3 - (minus_E4a_12 * S4a_1 + E4a_22 * minus_S4a_2);
  const T b1_10 = E5a_12 * G5_1 + E5a_11 * S5a_2;
  const T S1_2 = b1_7 - (b1_8 + minus_f_sdot1_10) + b1_9 + b1_10 - minus_S8_2 + G1_2;
  const T b1_11 = E3_23 * S3_2 - minus_E3_13 * S3_1 - E3_33 * minus_S3_3;
  const T b1_12 = R1_31 * minus_G2_1 + R1_32 * minus_G2_2 + R1_33 * minus_G2_3;
  const T b1_13 = R1_31 * minus_G10_1 + R1_32 * minus_G10_2 + R1_33 * minus_G10_3;
  const T b1_14 = E4a_33 * S4a_3 - (minus_E4a_13 * S4a_1 + E4a_23 * minus_S4a_2);
  const T b1_15 = E8_13 * S8_1 - E8_11 * minus_S8_3;
  const T S1_3 = b1_11 - (b1_12 + b1_13) + b1_14 + S5a_3 + b1_15 + G1_3;
  // f_omega1 = q2~ R1 G2 + q3~ E3^T S3 + E3^T rho3 + q4a~ E4a^T S4a + E4a^T rho4a + q5a~ E5a^T S5a + E5a^T rho5a +
  //   E8^T rho8 + r1~ G1 + d8~ E8^T S8 + d10~ R1 G10 + N1: Kane's equation of omega [N m]
  const T b1_16 = T(0.2) * b1_8;
  const T f_omega1_1 = N1_1 - b1_16 - T(0.1) * b1_12 - T(0.1) * b1_7 + E3_11 * rho3_1 + E3_21 * rho3_2 + E3_31 *
      rho3_3 + T(0.1) * b1_14 + minus_E4a_12 * rho4a_2 - E4a_11 * minus_rho4a_1 + minus_E4a_13 * rho4a_3 - T(0.1) *
      b1_10 - T(0.3) * S5a_3 + E5a_11 * rho5_1 - E5a_12 * rho5a_2 + E8_11 * rho8_1 - E8_13 * rho8_3 - T(0.03) * G1_2 -
      T(0.01) * G1_3 + d8_2 * b1_15 + T(0.3) * minus_f_sdot1_10 - s10 * b1_13;
  const T f_omega1_2 = N1_2 - minus_rho8_2 + T(0.2) * b1_2 + T(0.2) * b1_12 + T(0.1) * b1_1 - T(0.3) * b1_11 + E3_12 *
      rho3_1 + E3_22 * rho3_2 + E3_32 * rho3_3 + T(0.2) * b1_14 + minus_E4a_12 * minus_rho4a_1 + E4a_22 * rho4a_2 +
      E4a_23 * rho4a_3 + T(0.1) * b1_5 + E5a_12 * rho5_1 + E5a_11 * rho5a_2 + T(0.03) * G1_1 - T(0.02) * G1_3 + T(0.1)
      * b1_13 - T(0.3) * b1_3;
  const T f_omega1_3 = rho5a_3 - b1_16 - minus_N1_3 + T(0.1) * b1_2 + T(0.3) * b1_7 + E3_23 * rho3_2 - minus_E3_13 *
      rho3_1 + E3_33 * rho3_3 - T(0.2) * b1_9 - T(0.1) * b1_4 + minus_E4a_13 * minus_rho4a_1 + E4a_23 * rho4a_2 +
      E4a_33 * rho4a_3 + T(0.3) * b1_5 + E8_13 * rho8_1 + E8_11 * rho8_3 + T(0.02) * G1_2 + T(0.01) * G1_1 - d8_2 *
      b1_6 + s10 * b1_3 - T(0.1) * minus_f_sdot1_10;
  f[0] = f_omega1_1;
  f[1] = f_omega1_2;
  f[2] = f_omega1_3;
  // f_sdot1 = R1^T S1: Kane's equation of sdot [N]
  const T f_sdot1_1 = R1_11 * S1_1 + R1_21 * S1_2 + R1_31 * S1_3;
  const T f_sdot1_2 = R1_12 * S1_1 + R1_22 * S1_2 + R1_32 * S1_3;
  const T f_sdot1_3 = R1_13 * S1_1 + R1_23 * S1_2 + R1_33 * S1_3;
  f[16] = f_sdot1_1;
  f[17] = f_sdot1_2;
  f[18] = f_sdot1_3;

  // ---- results
  f[20] = -T(0);
  f[21] = -T(0);
  f[26] = -T(0);
  f[27] = -T(0);
  f[28] = -T(49.050000000000004);
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 460 add, 614 multiply, 17 sine or cosine
template <class T>
void mass_matrix(const Prepared<T>& c, T t, const T* x, T* A) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 841; ++i) A[i] = T(0);
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
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
  A[480] = c.m_sub1;
  A[510] = c.m_sub1;
  A[540] = c.m_sub1;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // C1_2 = R1 R2^T: takes components in the body to those in body 1
  const T C1_2_11 = R1_11 * R2_11 + R1_12 * R2_12 + R1_13 * R2_13;
  const T C1_2_12 = R1_11 * R2_21 + R1_12 * R2_22 + R1_13 * R2_23;
  const T C1_2_13 = R1_11 * R2_31 + R1_12 * R2_32 + R1_13 * R2_33;
  const T C1_2_21 = R1_21 * R2_11 + R1_22 * R2_12 + R1_23 * R2_13;
  const T C1_2_22 = R1_21 * R2_21 + R1_22 * R2_22 + R1_23 * R2_23;
  const T C1_2_23 = R1_21 * R2_31 + R1_22 * R2_32 + R1_23 * R2_33;
  const T C1_2_31 = R1_31 * R2_11 + R1_32 * R2_12 + R1_33 * R2_13;
  const T C1_2_32 = R1_31 * R2_21 + R1_32 * R2_22 + R1_33 * R2_23;
  const T C1_2_33 = R1_31 * R2_31 + R1_32 * R2_32 + R1_33 * R2_33;

  // ---- body 3 (boom) on body 1
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);

  // ---- body 4 (cross) on body 1
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_3 = cosines[10];
  const T E4_12 = T(0.28) * t4_3;
  const T minus_E4_13 = T(0.96) * t4_3;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;

  // ---- body 5 (camera) on body 1
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // theta5_2 = expression 1: prescribed
  const T theta5_2 = c.p.amplitude * sin(T(3) * t);
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;

  // ---- body 9 (sled) on the inertial frame
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // C1_10 = R1 R10^T: takes components in the body to those in body 1
  const T C1_10_11 = R1_11 * R10_11 + R1_12 * R10_12 + R1_13 * R10_13;
  const T C1_10_12 = R1_11 * R10_21 + R1_12 * R10_22 + R1_13 * R10_23;
  const T C1_10_13 = R1_11 * R10_31 + R1_12 * R10_32 + R1_13 * R10_33;
  const T C1_10_21 = R1_21 * R10_11 + R1_22 * R10_12 + R1_23 * R10_13;
  const T C1_10_22 = R1_21 * R10_21 + R1_22 * R10_22 + R1_23 * R10_23;
  const T C1_10_23 = R1_21 * R10_31 + R1_22 * R10_32 + R1_23 * R10_33;
  const T C1_10_31 = R1_31 * R10_11 + R1_32 * R10_12 + R1_33 * R10_13;
  const T C1_10_32 = R1_31 * R10_21 + R1_32 * R10_22 + R1_33 * R10_23;
  const T C1_10_33 = R1_31 * R10_31 + R1_32 * R10_32 + R1_33 * R10_33;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);

  // ---- body 11 (nut) and what it carries
  // hc11 = E11^T h11: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc11_1 = E11_13 * T(0.003);
  const T hc11_3 = E11_11 * T(0.003);

  // ---- body 8 (piston) and what it carries
  // h8 = m8 r_link8 + m11 d11 + hc11: first moment of mass carried, about the body origin, body axes [kg m]
  const T minus_h8_1 = T(0.006999999999999999) + minus_hc11_1;
  const T b8_1 = T(0.3) * minus_d11_2;
  const T minus_h8_2 = T(0.06999999999999999) + b8_1;
  const T h8_3 = T(0.013999999999999999) + hc11_3;
  // J8 = E11^T J11 E11 - m8 r_link8~ r_link8~ + (-m11 d11~ - hc11~) d11~ + I_link8 - d11~ hc11~: inertia carried,
  //   about the body origin, body axes [kg m^2]
  const T b8_2 = E11_13 * T(3e-05);
  const T b8_3 = E11_13 * b8_2;
  const T b8_4 = b8_1 * minus_d11_2;
  const T J8_11 = T(0.01071) - b8_3 + b8_4;
  const T b8_5 = minus_d11_2 * minus_hc11_1;
  const T minus_J8_12 = T(7e-04) + b8_5;
  const T J8_13 = T(0.00014) + E11_11 * b8_2;
  const T b8_6 = minus_d11_2 * hc11_3;
  const T J8_23 = T(0.0014) + b8_6;
  const T J8_33 = T(0.011470000000000001) + b8_3 + b8_4;
  // hc8 = E8^T h8: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc8_1 = E8_13 * h8_3 + E8_11 * minus_h8_1;
  const T minus_hc8_3 = E8_13 * minus_h8_1 - E8_11 * h8_3;
  A[80] = minus_hc8_1;
  A[640] = minus_hc8_1;
  A[22] = -minus_hc8_3;
  A[638] = -minus_hc8_3;
  // K_thetadot11_8 = E11^T K_thetadot11_11 + d11~ E11^T B_thetadot11_11
  const T K_thetadot11_8_1 = b8_5 + E11_11 * T(3e-05);
  const T K_thetadot11_8_3 = E11_13 * T(3e-05) - b8_6;

  // ---- body 5 (camera) and what it carries
  // hc5 = E5^T h_own_5: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc5_2 = E5_23 * c.HA5_21;
  const T hc5_3 = E5_22 * c.HA5_21;
  // J5a = E5^T J_own_5 E5 + J_own_5a: inertia carried, about the body origin, body axes [kg m^2]
  const T minus_J5a_12 = E5_23 * c.JA5_13;
  const T J5a_13 = E5_22 * c.JA5_13;
  const T b5_1 = E5_23 * c.c5_2;
  const T b5_2 = E5_23 * b5_1;
  const T J5a_22 = c.JA5_22 - b5_2;
  const T J5a_23 = E5_22 * b5_1;
  const T J5a_33 = b5_2 - c.c5_2 + c.JA5_22;
  A[270] = J5a_33;
  // hc5a = E5a^T h5a: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc5a_1 = E5a_11 * c.HA5_32 + E5a_12 * minus_hc5_2;
  const T minus_hc5a_2 = E5a_11 * minus_hc5_2 - E5a_12 * c.HA5_32;

  // ---- body 4 (cross) and what it carries
  // hc4 = E4^T h_own_4: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4_1 = t4_3 * T(0.09000000000000001) - minus_E4_11 * T(0.027);
  const T hc4_2 = E4_12 * T(0.027) + E4_32 * T(0.09000000000000001);
  const T minus_hc4_3 = minus_E4_13 * T(0.027) + minus_E4_33 * T(0.09000000000000001);
  // J4a = E4^T J_own_4 E4 + J_all_4a: inertia carried, about the body origin, body axes [kg m^2]
  const T b4_1 = minus_E4_11 * T(0.004190000000000001) + t4_3 * T(0.0027);
  const T b4_2 = minus_E4_11 * T(0.0027);
  const T b4_3 = b4_1 * minus_E4_11 + b4_2 * t4_3;
  const T J4a_11 = b4_3 + T(0.01281);
  const T J4a_12 = b4_2 * E4_32 - b4_1 * E4_12;
  const T J4a_13 = b4_1 * minus_E4_13 - b4_2 * minus_E4_33;
  const T b4_4 = E4_12 * T(0.004190000000000001) - E4_32 * T(0.0027);
  const T b4_5 = E4_12 * T(0.0027);
  const T b4_6 = b4_4 * E4_12 + T(0.015492096) - b4_5 * E4_32;
  const T J4a_22 = b4_6 + T(0.0010043040000000001);
  const T J4a_23 = T(0.0010752000000000003) - b4_4 * minus_E4_13 + b4_5 * minus_E4_33;
  const T J4a_33 = T(0.032805696) - b4_3 - b4_6;
  // hc4a = E4a^T h4a: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc4a_1 = E4a_11 * hc4_1 + minus_E4a_12 * hc4_2 - minus_E4a_13 * minus_hc4_3;
  const T hc4a_2 = E4a_22 * hc4_2 - minus_E4a_12 * hc4_1 - E4a_23 * minus_hc4_3;
  const T hc4a_3 = E4a_23 * hc4_2 - minus_E4a_13 * hc4_1 - E4a_33 * minus_hc4_3;
  // B_thetadot4_2_4a = E4^T B_thetadot4_2_4
  const T minus_B_thetadot4_2_4a_1 = minus_E4_11 * T(0.09000000000000001) + t4_3 * T(0.027);
  const T minus_B_thetadot4_2_4a_2 = E4_32 * T(0.027) - E4_12 * T(0.09000000000000001);
  const T minus_B_thetadot4_2_4a_3 = minus_E4_13 * T(0.09000000000000001) - minus_E4_33 * T(0.027);
  // B_thetadot4_1_4a = b4_1~ h4a: force of a unit of the rate of the speed
  const T B_thetadot4_1_4a_1 = T(0.96) * hc4_2 - T(0.28) * minus_hc4_3;
  const T minus_B_thetadot4_1_4a_2 = T(0.96) * hc4_1;
  const T minus_B_thetadot4_1_4a_3 = T(0.28) * hc4_1;
  // K_thetadot4_1_4a = J4a b4_1: its moment about the body origin, body axes
  const T K_thetadot4_1_4a_1 = J4a_12 * T(0.28) - J4a_13 * T(0.96);
  const T K_thetadot4_1_4a_2 = J4a_22 * T(0.28) - J4a_23 * T(0.96);
  const T K_thetadot4_1_4a_3 = J4a_23 * T(0.28) - J4a_33 * T(0.96);

  // ---- body 3 (boom) and what it carries
  // h3 = m6 d6 + h_all_3 + h6: first moment of mass carried, about the body origin, body axes [kg m]
  const T b3_1 = d6_1 * T(0.5);
  const T h3_1 = b3_1 + T(0.35000000000000003);
  // J3 = (-m6 d6~ - h6~) d6~ + J_all_3 - d6~ h6~ + J6: inertia carried, about the body origin, body axes [kg m^2]
  const T J3_13 = T(5e-04) - d6_1 * T(0.005);
  const T b3_2 = d6_1 * T(0.05) + (T(0.05) + b3_1) * d6_1;
  const T J3_22 = b3_2 + T(0.12105);
  const T J3_33 = T(0.0916) + b3_2;
  // hc3 = E3^T h3: first moment carried, about the body origin, lower body's axes [kg m]
  const T hc3_1 = E3_11 * h3_1 + E3_21 * T(0.03) + E3_31 * T(0.005);
  const T hc3_2 = E3_12 * h3_1 + E3_22 * T(0.03) + E3_32 * T(0.005);
  const T hc3_3 = E3_23 * T(0.03) - minus_E3_13 * h3_1 + E3_33 * T(0.005);
  // B_thetadot3_3 = b3~ h3: force of a unit of the rate of the speed
  const T B_thetadot3_3_2 = T(0.0015763557945883155) + T(0.8388422987658062) * h3_1;
  const T minus_B_thetadot3_3_3 = T(0.009458134767529894) + T(0.44378789320576517) * h3_1;
  // K_thetadot3_3 = J3 b3: its moment about the body origin, body axes
  const T K_thetadot3_3_1 = J3_13 * T(0.8388422987658062) - T(0.01490619534174373);
  const T K_thetadot3_3_2 = J3_22 * T(0.44378789320576517) - T(0.001255442260626766);
  const T K_thetadot3_3_3 = J3_33 * T(0.8388422987658062) - (J3_13 * T(0.3152711589176631) +
      T(0.0013313636796172955));

  // ---- body 1 (hull) and what it carries
  const T s10 = x[28];
  // h1 = m6 q3 + m10 d10 + h_all_1 + m_sub8 d8 + hc3 + hc4a + hc5a + hc8: first moment of mass carried, about the
  //   body origin, body axes [kg m]
  const T h1_1 = T(0.78) + hc3_1 + hc4a_1 + hc5a_1 - minus_hc8_1;
  const T b1_1 = minus_h8_2 - T(1) * d8_2;
  const T h1_2 = c.h_all_1_2 - b1_1 + hc3_2 + hc4a_2 - minus_hc5a_2 + T(0.4) * s10;
  const T h1_3 = c.c1_1 + hc3_3 + hc4a_3 + hc5_3 - minus_hc8_3;
  // J1 = -q3~ hc3~ + E3^T J3 E3 - q4a~ hc4a~ + E4a^T J4a E4a - q5a~ hc5a~ + E5a^T J5a E5a + E8^T J8 E8 + (-m6 q3~ -
  //   hc3~) q3~ - m10 d10~ d10~ + J_all_1 - d8~ hc8~ + (-m_sub8 d8~ - hc8~) d8~ - hc4a~ q4a~ - hc5a~ q5a~: inertia
  //   carried, about the body origin, body axes [kg m^2]
  const T b1_2 = hc3_3 + T(0.05);
  const T b1_3 = T(0.1) * hc3_3 + b1_2 * T(0.1);
  const T b1_4 = T(2) * E8_11 * J8_13 - E8_13 * (J8_33 - J8_11);
  const T b1_5 = E3_11 * T(0.04165) - E3_21 * T(0.004) + E3_31 * J3_13;
  const T b1_6 = E3_21 * J3_22 - E3_11 * T(0.004) - E3_31 * T(0.003);
  const T b1_7 = E3_11 * J3_13 - E3_21 * T(0.003) + E3_31 * J3_33;
  const T b1_8 = minus_E4a_12 * J4a_12;
  const T b1_9 = E4a_11 * J4a_11 + b1_8 + minus_E4a_13 * J4a_13;
  const T b1_10 = E4a_11 * J4a_12 + minus_E4a_12 * J4a_22 + minus_E4a_13 * J4a_23;
  const T b1_11 = E4a_11 * J4a_13 + minus_E4a_12 * J4a_23 + minus_E4a_13 * J4a_33;
  const T b1_12 = E8_13 * b1_4 - (b1_5 * E3_11 + b1_6 * E3_21 + b1_7 * E3_31 + b1_9 * E4a_11 + b1_10 * minus_E4a_12 +
      b1_11 * minus_E4a_13);
  const T b1_13 = T(0.2) * hc4a_2;
  const T b1_14 = T(0.3) * minus_hc5a_2;
  const T b1_15 = b1_14 + T(0.1) * hc5_3;
  const T b1_16 = E5a_12 * (c.JA5_11 - J5a_22) - T(2) * E5a_11 * minus_J5a_12;
  const T b1_17 = E5a_12 * b1_16;
  const T b1_18 = d8_2 * minus_h8_2 + b1_1 * d8_2;
  const T b1_19 = s10 * s10;
  const T J1_11 = b1_3 - b1_12 + b1_13 + b1_15 + c.JA5_11 - b1_17 + J8_11 + c.J_all_1_11 - b1_18 + b1_15 + T(0.4) *
      (T(0.09) + b1_19);
  const T b1_20 = E8_11 * minus_J8_12 + E8_13 * J8_23 - d8_2 * minus_hc8_1;
  const T J1_12 = minus_J5a_12 - b1_20 + T(0.0236) + b1_13 + b1_5 * E3_12 + b1_6 * E3_22 + b1_7 * E3_32 - T(0.1) *
      hc4a_1 + b1_10 * E4a_22 - b1_9 * minus_E4a_12 + b1_11 * E4a_23 + T(0.3) * hc5a_1 + E5a_11 * b1_16 - T(0.3) *
      hc3_2 - s10 * T(0.1) * T(0.4);
  const T b1_21 = T(0.1) * hc5a_1 - (E5a_11 * J5a_13 - E5a_12 * J5a_23);
  const T J1_13 = b1_6 * E3_23 - (b1_21 + J8_13 + T(0.039799999999999995)) - b1_5 * minus_E3_13 + b1_7 * E3_33 -
      T(0.1) * hc3_1 + b1_10 * E4a_23 - b1_9 * minus_E4a_13 + b1_11 * E4a_33 + E8_11 * b1_4 - b1_2 * T(0.3) + T(0.2) *
      hc4a_3;
  const T b1_22 = E3_12 * T(0.04165) - E3_22 * T(0.004) + E3_32 * J3_13;
  const T b1_23 = E3_22 * J3_22 - E3_12 * T(0.004) - E3_32 * T(0.003);
  const T b1_24 = E3_12 * J3_13 - E3_22 * T(0.003) + E3_32 * J3_33;
  const T b1_25 = E4a_22 * J4a_22 - b1_8 + E4a_23 * J4a_23;
  const T b1_26 = E4a_22 * J4a_12 - minus_E4a_12 * J4a_11 + E4a_23 * J4a_13;
  const T b1_27 = E4a_22 * J4a_23 - minus_E4a_12 * J4a_13 + E4a_23 * J4a_33;
  const T b1_28 = b1_22 * E3_12 + b1_23 * E3_22 + b1_24 * E3_32 + b1_25 * E4a_22 - b1_26 * minus_E4a_12 + b1_27 *
      E4a_23;
  const T b1_29 = T(0.3) * hc3_1 + (hc3_1 + T(0.15)) * T(0.3);
  const T J1_22 = b1_28 + b1_3 + b1_29 + J5a_22 + b1_17 + T(0.04298) + c.J_all_1_22 - T(0.4) * hc4a_1 + T(0.2) *
      hc5_3;
  const T b1_30 = T(0.1) * minus_hc5a_2 + E5a_12 * J5a_13 + E5a_11 * J5a_23;
  const T b1_31 = E8_13 * minus_J8_12 - E8_11 * J8_23 - d8_2 * minus_hc8_3;
  const T J1_23 = b1_30 - b1_31 + c.J_all_1_23 + b1_23 * E3_23 - b1_22 * minus_E3_13 + b1_24 * E3_33 - T(0.1) * hc3_2
      + b1_25 * E4a_23 - b1_26 * minus_E4a_13 + b1_27 * E4a_33 - T(0.3) * s10 * T(0.4) - T(0.1) * hc4a_3 + T(0.3) *
      hc5_3;
  const T b1_32 = T(0.1) * hc4a_2 - T(0.2) * hc4a_1;
  const T J1_33 = T(0.04165) + J3_22 + J3_33 + b1_12 - b1_28 + b1_29 + b1_32 + J4a_11 + J4a_22 + J4a_33 + J5a_33 +
      J8_33 + c.J_all_1_33 - b1_18 + b1_32 + T(0.6) * minus_hc5a_2 + T(0.4) * (b1_19 + T(0.010000000000000002));
  A[0] = J1_11;
  A[1] = J1_12;
  A[29] = J1_12;
  A[2] = J1_13;
  A[58] = J1_13;
  A[30] = J1_22;
  A[31] = J1_23;
  A[59] = J1_23;
  A[60] = J1_33;
  // B_thetadot11_1 = E8^T B_thetadot11_8
  const T B_thetadot11_1_1 = E8_13 * minus_hc11_1 - E8_11 * hc11_3;
  const T minus_B_thetadot11_1_3 = E8_13 * hc11_3 + E8_11 * minus_hc11_1;
  // K_thetadot11_1 = E8^T K_thetadot11_8 + d8~ E8^T B_thetadot11_8
  const T K_thetadot11_1_1 = E8_11 * K_thetadot11_8_1 - E8_13 * K_thetadot11_8_3 - d8_2 * minus_B_thetadot11_1_3;
  const T K_thetadot11_1_3 = E8_13 * K_thetadot11_8_1 + E8_11 * K_thetadot11_8_3 - d8_2 * B_thetadot11_1_1;
  A[15] = K_thetadot11_1_1;
  A[435] = K_thetadot11_1_1;
  A[73] = K_thetadot11_1_3;
  A[437] = K_thetadot11_1_3;
  A[10] = b1_20;
  A[290] = b1_20;
  A[68] = b1_31;
  A[292] = b1_31;
  // B_sdot6_1 = E3^T B_sdot6_3
  const T B_sdot6_1_1 = E3_11 * T(0.5);
  const T B_sdot6_1_2 = E3_12 * T(0.5);
  const T minus_B_sdot6_1_3 = minus_E3_13 * T(0.5);
  // K_sdot6_1 = q3~ E3^T B_sdot6_3 + E3^T K_sdot6_3
  const T K_sdot6_1_1 = E3_21 * T(0.005) - T(0.1) * B_sdot6_1_2;
  const T K_sdot6_1_2 = T(0.1) * B_sdot6_1_1 + T(0.3) * minus_B_sdot6_1_3 + E3_22 * T(0.005);
  const T K_sdot6_1_3 = T(0.3) * B_sdot6_1_2 + E3_23 * T(0.005);
  A[19] = K_sdot6_1_1;
  A[551] = K_sdot6_1_1;
  A[48] = K_sdot6_1_2;
  A[552] = K_sdot6_1_2;
  A[77] = K_sdot6_1_3;
  A[553] = K_sdot6_1_3;
  // K_thetadot5_1_1 = q5a~ E5a^T B_thetadot5_1_5a + E5a^T K_thetadot5_1_5a
  const T K_thetadot5_1_1_3 = b1_14 + J5a_33;
  A[9] = -b1_21;
  A[261] = -b1_21;
  A[38] = b1_30;
  A[262] = b1_30;
  A[67] = K_thetadot5_1_1_3;
  A[263] = K_thetadot5_1_1_3;
  // B_thetadot4_2_1 = E4a^T B_thetadot4_2_4a
  const T minus_B_thetadot4_2_1_1 = minus_E4a_12 * minus_B_thetadot4_2_4a_2 + E4a_11 * minus_B_thetadot4_2_4a_1 +
      minus_E4a_13 * minus_B_thetadot4_2_4a_3;
  const T B_thetadot4_2_1_2 = minus_E4a_12 * minus_B_thetadot4_2_4a_1 - E4a_22 * minus_B_thetadot4_2_4a_2 - E4a_23 *
      minus_B_thetadot4_2_4a_3;
  const T B_thetadot4_2_1_3 = minus_E4a_13 * minus_B_thetadot4_2_4a_1 - E4a_23 * minus_B_thetadot4_2_4a_2 - E4a_33 *
      minus_B_thetadot4_2_4a_3;
  // K_thetadot4_2_1 = q4a~ E4a^T B_thetadot4_2_4a + E4a^T K_thetadot4_2_4a
  const T K_thetadot4_2_1_1 = T(0.1) * B_thetadot4_2_1_3 + minus_E4a_12 * T(0.016137600000000002) + minus_E4a_13 *
      T(0.004706800000000001);
  const T K_thetadot4_2_1_2 = T(0.2) * B_thetadot4_2_1_3 + E4a_22 * T(0.016137600000000002) + E4a_23 *
      T(0.004706800000000001);
  const T K_thetadot4_2_1_3 = E4a_23 * T(0.016137600000000002) - (T(0.2) * B_thetadot4_2_1_2 - T(0.1) *
      minus_B_thetadot4_2_1_1) + E4a_33 * T(0.004706800000000001);
  A[8] = K_thetadot4_2_1_1;
  A[232] = K_thetadot4_2_1_1;
  A[37] = K_thetadot4_2_1_2;
  A[233] = K_thetadot4_2_1_2;
  A[66] = K_thetadot4_2_1_3;
  A[234] = K_thetadot4_2_1_3;
  // B_thetadot4_1_1 = E4a^T B_thetadot4_1_4a
  const T B_thetadot4_1_1_1 = E4a_11 * B_thetadot4_1_4a_1 - minus_E4a_12 * minus_B_thetadot4_1_4a_2 - minus_E4a_13 *
      minus_B_thetadot4_1_4a_3;
  const T minus_B_thetadot4_1_1_2 = minus_E4a_12 * B_thetadot4_1_4a_1 + E4a_22 * minus_B_thetadot4_1_4a_2 + E4a_23 *
      minus_B_thetadot4_1_4a_3;
  const T minus_B_thetadot4_1_1_3 = minus_E4a_13 * B_thetadot4_1_4a_1 + E4a_23 * minus_B_thetadot4_1_4a_2 + E4a_33 *
      minus_B_thetadot4_1_4a_3;
  // K_thetadot4_1_1 = q4a~ E4a^T B_thetadot4_1_4a + E4a^T K_thetadot4_1_4a
  const T K_thetadot4_1_1_1 = E4a_11 * K_thetadot4_1_4a_1 + minus_E4a_12 * K_thetadot4_1_4a_2 + minus_E4a_13 *
      K_thetadot4_1_4a_3 - T(0.1) * minus_B_thetadot4_1_1_3;
  const T K_thetadot4_1_1_2 = E4a_22 * K_thetadot4_1_4a_2 - minus_E4a_12 * K_thetadot4_1_4a_1 + E4a_23 *
      K_thetadot4_1_4a_3 - T(0.2) * minus_B_thetadot4_1_1_3;
  const T K_thetadot4_1_1_3 = T(0.2) * minus_B_thetadot4_1_1_2 - T(0.1) * B_thetadot4_1_1_1 + E4a_23 *
      K_thetadot4_1_4a_2 - minus_E4a_13 * K_thetadot4_1_4a_1 + E4a_33 * K_thetadot4_1_4a_3;
  A[7] = K_thetadot4_1_1_1;
  A[203] = K_thetadot4_1_1_1;
  A[36] = K_thetadot4_1_1_2;
  A[204] = K_thetadot4_1_1_2;
  A[65] = K_thetadot4_1_1_3;
  A[205] = K_thetadot4_1_1_3;
  // B_thetadot3_1 = E3^T B_thetadot3_3
  const T B_thetadot3_1_1 = E3_21 * B_thetadot3_3_2 - E3_11 * T(0.02294632949694536) - E3_31 * minus_B_thetadot3_3_3;
  const T B_thetadot3_1_2 = E3_22 * B_thetadot3_3_2 - E3_12 * T(0.02294632949694536) - E3_32 * minus_B_thetadot3_3_3;
  const T B_thetadot3_1_3 = minus_E3_13 * T(0.02294632949694536) + E3_23 * B_thetadot3_3_2 - E3_33 *
      minus_B_thetadot3_3_3;
  // K_thetadot3_1 = q3~ E3^T B_thetadot3_3 + E3^T K_thetadot3_3
  const T K_thetadot3_1_1 = E3_11 * K_thetadot3_3_1 + E3_21 * K_thetadot3_3_2 + E3_31 * K_thetadot3_3_3 - T(0.1) *
      B_thetadot3_1_2;
  const T K_thetadot3_1_2 = T(0.1) * B_thetadot3_1_1 - T(0.3) * B_thetadot3_1_3 + E3_12 * K_thetadot3_3_1 + E3_22 *
      K_thetadot3_3_2 + E3_32 * K_thetadot3_3_3;
  const T K_thetadot3_1_3 = T(0.3) * B_thetadot3_1_2 + E3_23 * K_thetadot3_3_2 - minus_E3_13 * K_thetadot3_3_1 + E3_33
      * K_thetadot3_3_3;
  A[6] = K_thetadot3_1_1;
  A[174] = K_thetadot3_1_1;
  A[35] = K_thetadot3_1_2;
  A[175] = K_thetadot3_1_2;
  A[64] = K_thetadot3_1_3;
  A[176] = K_thetadot3_1_3;

  // ---- results
  const T t1 = T(0.2) * (C1_2_22 * T(0.16000000000000003) + C1_2_23 * T(0.016));
  const T t2 = C1_2_32 * T(0.16000000000000003) + C1_2_33 * T(0.016);
  const T t3 = t1 + T(0.1) * t2;
  A[3] = t3;
  A[87] = t3;
  const T t4 = C1_2_21 * T(0.16000000000000003) * T(0.2);
  const T t5 = C1_2_31 * T(0.16000000000000003);
  const T t6 = t4 + T(0.1) * t5;
  A[4] = -t6;
  A[116] = -t6;
  const T t7 = C1_2_21 * T(0.016) * T(0.2);
  const T t8 = C1_2_31 * T(0.016);
  const T t9 = t7 + T(0.1) * t8;
  A[5] = -t9;
  A[145] = -t9;
  const T t10 = C1_10_22 * T(0.012) + C1_10_23 * T(0.004);
  const T t11 = C1_10_32 * T(0.012) + C1_10_33 * T(0.004);
  const T t12 = T(0.3) * t10 - s10 * t11;
  A[12] = -t12;
  A[348] = -t12;
  const T t13 = C1_10_31 * T(0.012) + C1_10_33 * T(0.008);
  const T t14 = C1_10_21 * T(0.012) + C1_10_23 * T(0.008);
  const T t15 = s10 * t13 - T(0.3) * t14;
  A[13] = -t15;
  A[377] = -t15;
  const T t16 = C1_10_31 * T(0.004) - C1_10_32 * T(0.008);
  const T t17 = C1_10_21 * T(0.004) - C1_10_22 * T(0.008);
  const T t18 = s10 * t16 - T(0.3) * t17;
  A[14] = -t18;
  A[406] = -t18;
  const T t19 = h1_2 * R1_31 - h1_3 * R1_21;
  A[16] = t19;
  A[464] = t19;
  const T t20 = h1_2 * R1_32 - h1_3 * R1_22;
  A[17] = t20;
  A[493] = t20;
  const T t21 = h1_2 * R1_33 - h1_3 * R1_23;
  A[18] = t21;
  A[522] = t21;
  A[25] = -T(0.12);
  A[725] = -T(0.12);
  const T t22 = C1_2_12 * T(0.16000000000000003) + C1_2_13 * T(0.016);
  const T t23 = T(0.2) * t22 + T(0.2) * t2;
  A[32] = -t23;
  A[88] = -t23;
  const T t24 = C1_2_11 * T(0.16000000000000003);
  const T t25 = T(0.2) * t24 + T(0.2) * t5;
  A[33] = t25;
  A[117] = t25;
  const T t26 = C1_2_11 * T(0.016);
  const T t27 = T(0.2) * t26 + T(0.2) * t8;
  A[34] = t27;
  A[146] = t27;
  A[39] = -T(0.00298);
  A[291] = -T(0.00298);
  A[300] = T(0.00298);
  const T t28 = C1_10_12 * T(0.012) + C1_10_13 * T(0.004);
  const T t29 = T(0.1) * t11 - T(0.3) * t28;
  A[41] = -t29;
  A[349] = -t29;
  const T t30 = C1_10_11 * T(0.012) + C1_10_13 * T(0.008);
  const T t31 = T(0.3) * t30 - T(0.1) * t13;
  A[42] = -t31;
  A[378] = -t31;
  const T t32 = C1_10_11 * T(0.004) - C1_10_12 * T(0.008);
  const T t33 = T(0.3) * t32 - T(0.1) * t16;
  A[43] = -t33;
  A[407] = -t33;
  A[44] = -T(0.0006299999999999999);
  A[305] = T(0.0006299999999999999);
  A[436] = -T(0.0006299999999999999);
  A[445] = T(0.0006299999999999999);
  const T t34 = h1_3 * R1_11 - h1_1 * R1_31;
  A[45] = t34;
  A[465] = t34;
  const T t35 = h1_3 * R1_12 - h1_1 * R1_32;
  A[46] = t35;
  A[494] = t35;
  const T t36 = h1_3 * R1_13 - h1_1 * R1_33;
  A[47] = t36;
  A[523] = t36;
  const T t37 = T(0.1) * t22 - t1;
  A[61] = -t37;
  A[89] = -t37;
  const T t38 = t4 - T(0.1) * t24;
  A[62] = -t38;
  A[118] = -t38;
  const T t39 = t7 - T(0.1) * t26;
  A[63] = -t39;
  A[147] = -t39;
  const T t40 = s10 * t28 - T(0.1) * t10;
  A[70] = -t40;
  A[350] = -t40;
  const T t41 = T(0.1) * t14 - s10 * t30;
  A[71] = -t41;
  A[379] = -t41;
  const T t42 = T(0.1) * t17 - s10 * t32;
  A[72] = -t42;
  A[408] = -t42;
  const T t43 = h1_1 * R1_21 - h1_2 * R1_11;
  A[74] = t43;
  A[466] = t43;
  const T t44 = h1_1 * R1_22 - h1_2 * R1_12;
  A[75] = t44;
  A[495] = t44;
  const T t45 = h1_1 * R1_23 - h1_2 * R1_13;
  A[76] = t45;
  A[524] = t45;
  A[83] = T(0.04000000000000001);
  A[727] = T(0.04000000000000001);
  A[90] = T(0.04232);
  const T t46 = R2_21 * T(0.16000000000000003) + R2_31 * T(0.016);
  A[103] = t46;
  A[467] = t46;
  const T t47 = R2_22 * T(0.16000000000000003) + R2_32 * T(0.016);
  A[104] = t47;
  A[496] = t47;
  const T t48 = R2_23 * T(0.16000000000000003) + R2_33 * T(0.016);
  A[105] = t48;
  A[525] = t48;
  A[120] = T(0.043000000000000003);
  A[121] = T(0.0032000000000000006);
  A[149] = T(0.0032000000000000006);
  const T t49 = R2_11 * T(0.16000000000000003);
  A[132] = -t49;
  A[468] = -t49;
  const T t50 = R2_12 * T(0.16000000000000003);
  A[133] = -t50;
  A[497] = -t50;
  const T t51 = R2_13 * T(0.16000000000000003);
  A[134] = -t51;
  A[526] = -t51;
  A[150] = T(0.00432);
  const T t52 = R2_11 * T(0.016);
  A[161] = -t52;
  A[469] = -t52;
  const T t53 = R2_12 * T(0.016);
  A[162] = -t53;
  A[498] = -t53;
  const T t54 = R2_13 * T(0.016);
  A[163] = -t54;
  A[527] = -t54;
  A[180] = T(0.44378789320576517) * K_thetadot3_3_2 - T(0.3152711589176631) * K_thetadot3_3_1 + T(0.8388422987658062)
      * K_thetadot3_3_3;
  const T t55 = R1_11 * B_thetadot3_1_1 + R1_21 * B_thetadot3_1_2 + R1_31 * B_thetadot3_1_3;
  A[190] = t55;
  A[470] = t55;
  const T t56 = R1_12 * B_thetadot3_1_1 + R1_22 * B_thetadot3_1_2 + R1_32 * B_thetadot3_1_3;
  A[191] = t56;
  A[499] = t56;
  const T t57 = R1_13 * B_thetadot3_1_1 + R1_23 * B_thetadot3_1_2 + R1_33 * B_thetadot3_1_3;
  A[192] = t57;
  A[528] = t57;
  A[193] = T(0.002218939466028826);
  A[557] = T(0.002218939466028826);
  A[210] = T(0.28) * K_thetadot4_1_4a_2 - T(0.96) * K_thetadot4_1_4a_3;
  const T t58 = R1_11 * B_thetadot4_1_1_1 - R1_21 * minus_B_thetadot4_1_1_2 - R1_31 * minus_B_thetadot4_1_1_3;
  A[219] = t58;
  A[471] = t58;
  const T t59 = R1_12 * B_thetadot4_1_1_1 - R1_22 * minus_B_thetadot4_1_1_2 - R1_32 * minus_B_thetadot4_1_1_3;
  A[220] = t59;
  A[500] = t59;
  const T t60 = R1_13 * B_thetadot4_1_1_1 - R1_23 * minus_B_thetadot4_1_1_2 - R1_33 * minus_B_thetadot4_1_1_3;
  A[221] = t60;
  A[529] = t60;
  A[240] = T(0.016810000000000002);
  const T t61 = R1_21 * B_thetadot4_2_1_2 - R1_11 * minus_B_thetadot4_2_1_1 + R1_31 * B_thetadot4_2_1_3;
  A[248] = t61;
  A[472] = t61;
  const T t62 = R1_22 * B_thetadot4_2_1_2 - R1_12 * minus_B_thetadot4_2_1_1 + R1_32 * B_thetadot4_2_1_3;
  A[249] = t62;
  A[501] = t62;
  const T t63 = R1_23 * B_thetadot4_2_1_2 - R1_13 * minus_B_thetadot4_2_1_1 + R1_33 * B_thetadot4_2_1_3;
  A[250] = t63;
  A[530] = t63;
  const T t64 = R1_11 * minus_hc5a_2 + R1_21 * hc5a_1;
  A[277] = t64;
  A[473] = t64;
  const T t65 = R1_12 * minus_hc5a_2 + R1_22 * hc5a_1;
  A[278] = t65;
  A[502] = t65;
  const T t66 = R1_13 * minus_hc5a_2 + R1_23 * hc5a_1;
  A[279] = t66;
  A[531] = t66;
  const T t67 = R1_11 * minus_hc8_3 - R1_31 * minus_hc8_1;
  A[306] = t67;
  A[474] = t67;
  const T t68 = R1_12 * minus_hc8_3 - R1_32 * minus_hc8_1;
  A[307] = t68;
  A[503] = t68;
  const T t69 = R1_13 * minus_hc8_3 - R1_33 * minus_hc8_1;
  A[308] = t69;
  A[532] = t69;
  A[330] = T(0.1);
  const T t70 = T(0.2) * E9_12;
  A[342] = -t70;
  A[678] = -t70;
  const T t71 = T(0.2) * E9_11;
  A[343] = t71;
  A[707] = t71;
  A[360] = T(0.0024000000000000002);
  A[361] = -T(8e-05);
  A[389] = -T(8e-05);
  A[362] = T(0.00024);
  A[418] = T(0.00024);
  const T t72 = R10_21 * T(0.012) + R10_31 * T(0.004);
  A[364] = t72;
  A[476] = t72;
  const T t73 = R10_22 * T(0.012) + R10_32 * T(0.004);
  A[365] = t73;
  A[505] = t73;
  const T t74 = R10_23 * T(0.012) + R10_33 * T(0.004);
  A[366] = t74;
  A[534] = t74;
  A[373] = t10;
  A[737] = t10;
  A[390] = T(0.00352);
  A[391] = T(0.00012);
  A[419] = T(0.00012);
  const T t75 = R10_11 * T(0.012) + R10_31 * T(0.008);
  A[393] = -t75;
  A[477] = -t75;
  const T t76 = R10_12 * T(0.012) + R10_32 * T(0.008);
  A[394] = -t76;
  A[506] = -t76;
  const T t77 = R10_13 * T(0.012) + R10_33 * T(0.008);
  A[395] = -t77;
  A[535] = -t77;
  A[402] = -t14;
  A[738] = -t14;
  A[420] = T(0.0027);
  const T t78 = R10_11 * T(0.004) - R10_21 * T(0.008);
  A[422] = -t78;
  A[478] = -t78;
  const T t79 = R10_12 * T(0.004) - R10_22 * T(0.008);
  A[423] = -t79;
  A[507] = -t79;
  const T t80 = R10_13 * T(0.004) - R10_23 * T(0.008);
  A[424] = -t80;
  A[536] = -t80;
  A[431] = -t17;
  A[739] = -t17;
  A[450] = T(0.00066);
  const T t81 = R1_11 * B_thetadot11_1_1 - R1_21 * T(0.003) - R1_31 * minus_B_thetadot11_1_3;
  A[451] = t81;
  A[479] = t81;
  const T t82 = R1_12 * B_thetadot11_1_1 - R1_22 * T(0.003) - R1_32 * minus_B_thetadot11_1_3;
  A[452] = t82;
  A[508] = t82;
  const T t83 = R1_13 * B_thetadot11_1_1 - R1_23 * T(0.003) - R1_33 * minus_B_thetadot11_1_3;
  A[453] = t83;
  A[537] = t83;
  A[457] = T(0.003);
  A[653] = T(0.003);
  const T t84 = R1_11 * B_sdot6_1_1 + R1_21 * B_sdot6_1_2 - R1_31 * minus_B_sdot6_1_3;
  A[483] = t84;
  A[567] = t84;
  const T t85 = R1_21 * T(1);
  A[486] = -t85;
  A[654] = -t85;
  const T t86 = R1_21 * T(0.4);
  A[489] = t86;
  A[741] = t86;
  const T t87 = R1_12 * B_sdot6_1_1 + R1_22 * B_sdot6_1_2 - R1_32 * minus_B_sdot6_1_3;
  A[512] = t87;
  A[568] = t87;
  const T t88 = R1_22 * T(1);
  A[515] = -t88;
  A[655] = -t88;
  const T t89 = R1_22 * T(0.4);
  A[518] = t89;
  A[742] = t89;
  const T t90 = R1_13 * B_sdot6_1_1 + R1_23 * B_sdot6_1_2 - R1_33 * minus_B_sdot6_1_3;
  A[541] = t90;
  A[569] = t90;
  const T t91 = R1_23 * T(1);
  A[544] = -t91;
  A[656] = -t91;
  const T t92 = R1_23 * T(0.4);
  A[547] = t92;
  A[743] = t92;
  A[570] = T(0.5);
  A[600] = T(3);
  A[630] = T(3);
  A[660] = T(1);
  A[690] = T(2);
  A[720] = T(2);
  A[750] = T(0.4);
  A[780] = T(5);
  A[810] = T(5);
  A[840] = T(5);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 470 add, 680 multiply, 17 sine or cosine
template <class T>
void partial_velocities(const Prepared<T>& c, T t, const T* x, T* v_y) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 1131; ++i) v_y[i] = T(0);
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
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
  v_y[631] = -R1_21;
  v_y[808] = R1_21;
  v_y[892] = -R1_21;
  v_y[660] = -R1_22;
  v_y[837] = R1_22;
  v_y[921] = -R1_22;
  v_y[689] = -R1_23;
  v_y[866] = R1_23;
  v_y[950] = -R1_23;
  // B1_1 = -R1^T r1~
  const T minus_B1_1_11 = R1_21 * T(0.03) + R1_31 * T(0.01);
  const T minus_B1_1_12 = R1_31 * T(0.02) - R1_11 * T(0.03);
  const T B1_1_13 = R1_11 * T(0.01) + R1_21 * T(0.02);
  const T minus_B1_1_21 = R1_22 * T(0.03) + R1_32 * T(0.01);
  const T minus_B1_1_22 = R1_32 * T(0.02) - R1_12 * T(0.03);
  const T B1_1_23 = R1_12 * T(0.01) + R1_22 * T(0.02);
  const T minus_B1_1_31 = R1_23 * T(0.03) + R1_33 * T(0.01);
  const T minus_B1_1_32 = R1_33 * T(0.02) - R1_13 * T(0.03);
  const T B1_1_33 = R1_13 * T(0.01) + R1_23 * T(0.02);
  v_y[0] = -minus_B1_1_11;
  v_y[1] = -minus_B1_1_12;
  v_y[2] = B1_1_13;
  v_y[29] = -minus_B1_1_21;
  v_y[30] = -minus_B1_1_22;
  v_y[31] = B1_1_23;
  v_y[58] = -minus_B1_1_31;
  v_y[59] = -minus_B1_1_32;
  v_y[60] = B1_1_33;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P_omega1_2 = -R1^T q2~: partial velocity of the body origin, inertial axes
  const T t2_13 = R1_21 * T(0.2);
  const T t2_14 = R1_31 * T(0.1);
  const T P_omega1_2_11 = t2_13 + t2_14;
  const T t2_15 = R1_31 * T(0.2);
  const T minus_P_omega1_2_12 = t2_15 + R1_11 * T(0.2);
  const T t2_16 = R1_11 * T(0.1);
  const T minus_P_omega1_2_13 = t2_16 - t2_13;
  const T t2_17 = R1_22 * T(0.2);
  const T t2_18 = R1_32 * T(0.1);
  const T P_omega1_2_21 = t2_17 + t2_18;
  const T t2_19 = R1_32 * T(0.2);
  const T minus_P_omega1_2_22 = t2_19 + R1_12 * T(0.2);
  const T t2_20 = R1_12 * T(0.1);
  const T minus_P_omega1_2_23 = t2_20 - t2_17;
  const T t2_21 = R1_23 * T(0.2);
  const T t2_22 = R1_33 * T(0.1);
  const T P_omega1_2_31 = t2_21 + t2_22;
  const T t2_23 = R1_33 * T(0.2);
  const T minus_P_omega1_2_32 = t2_23 + R1_13 * T(0.2);
  const T t2_24 = R1_13 * T(0.1);
  const T minus_P_omega1_2_33 = t2_24 - t2_21;
  v_y[87] = P_omega1_2_11;
  v_y[88] = -minus_P_omega1_2_12;
  v_y[89] = -minus_P_omega1_2_13;
  v_y[116] = P_omega1_2_21;
  v_y[117] = -minus_P_omega1_2_22;
  v_y[118] = -minus_P_omega1_2_23;
  v_y[145] = P_omega1_2_31;
  v_y[146] = -minus_P_omega1_2_32;
  v_y[147] = -minus_P_omega1_2_33;
  // B4_2 = -R2^T r2~
  const T B4_2_11 = R2_21 * T(0.2) + R2_31 * T(0.02);
  const T minus_B4_2_12 = R2_11 * T(0.2);
  const T minus_B4_2_13 = R2_11 * T(0.02);
  const T B4_2_21 = R2_22 * T(0.2) + R2_32 * T(0.02);
  const T minus_B4_2_22 = R2_12 * T(0.2);
  const T minus_B4_2_23 = R2_12 * T(0.02);
  const T B4_2_31 = R2_23 * T(0.2) + R2_33 * T(0.02);
  const T minus_B4_2_32 = R2_13 * T(0.2);
  const T minus_B4_2_33 = R2_13 * T(0.02);
  v_y[90] = B4_2_11;
  v_y[91] = -minus_B4_2_12;
  v_y[92] = -minus_B4_2_13;
  v_y[119] = B4_2_21;
  v_y[120] = -minus_B4_2_22;
  v_y[121] = -minus_B4_2_23;
  v_y[148] = B4_2_31;
  v_y[149] = -minus_B4_2_32;
  v_y[150] = -minus_B4_2_33;

  // ---- body 3 (boom) on body 1
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_11 * E3_31 + R1_21 * E3_32 + R1_31 * E3_33;
  const T R3_32 = R1_12 * E3_31 + R1_22 * E3_32 + R1_32 * E3_33;
  const T R3_33 = R1_13 * E3_31 + R1_23 * E3_32 + R1_33 * E3_33;
  v_y[454] = R3_11;
  v_y[483] = R3_12;
  v_y[512] = R3_13;
  // P_omega1_3 = -R1^T q3~: partial velocity of the body origin, inertial axes
  const T minus_P_omega1_3_11 = R1_21 * T(0.1);
  const T t3_18 = R1_31 * T(0.3);
  const T minus_P_omega1_3_12 = t3_18 - t2_16;
  const T P_omega1_3_13 = R1_21 * T(0.3);
  const T minus_P_omega1_3_21 = R1_22 * T(0.1);
  const T t3_19 = R1_32 * T(0.3);
  const T minus_P_omega1_3_22 = t3_19 - t2_20;
  const T P_omega1_3_23 = R1_22 * T(0.3);
  const T minus_P_omega1_3_31 = R1_23 * T(0.1);
  const T t3_20 = R1_33 * T(0.3);
  const T minus_P_omega1_3_32 = t3_20 - t2_24;
  const T P_omega1_3_33 = R1_23 * T(0.3);
  // B5_1 = -R3^T r3~ E3 + P_omega1_3
  const T t3_21 = T(0.02) * E3_31;
  const T t3_22 = T(0.2) * E3_31;
  const T t3_23 = T(0.2) * E3_21 - T(0.02) * E3_11;
  const T minus_B5_1_11 = minus_P_omega1_3_11 + R3_11 * t3_21 - R3_21 * t3_22 + R3_31 * t3_23;
  const T t3_24 = T(0.02) * E3_32;
  const T t3_25 = T(0.2) * E3_32;
  const T t3_26 = T(0.2) * E3_22 - T(0.02) * E3_12;
  const T minus_B5_1_12 = minus_P_omega1_3_12 + R3_11 * t3_24 - R3_21 * t3_25 + R3_31 * t3_26;
  const T t3_27 = T(0.02) * E3_33;
  const T t3_28 = T(0.2) * E3_33;
  const T t3_29 = T(0.2) * E3_23 + T(0.02) * minus_E3_13;
  const T minus_B5_1_13 = R3_11 * t3_27 - P_omega1_3_13 - R3_21 * t3_28 + R3_31 * t3_29;
  const T minus_B5_1_21 = minus_P_omega1_3_21 + R3_12 * t3_21 - R3_22 * t3_22 + R3_32 * t3_23;
  const T minus_B5_1_22 = minus_P_omega1_3_22 + R3_12 * t3_24 - R3_22 * t3_25 + R3_32 * t3_26;
  const T minus_B5_1_23 = R3_12 * t3_27 - P_omega1_3_23 - R3_22 * t3_28 + R3_32 * t3_29;
  const T minus_B5_1_31 = minus_P_omega1_3_31 + R3_13 * t3_21 - R3_23 * t3_22 + R3_33 * t3_23;
  const T minus_B5_1_32 = minus_P_omega1_3_32 + R3_13 * t3_24 - R3_23 * t3_25 + R3_33 * t3_26;
  const T minus_B5_1_33 = R3_13 * t3_27 - P_omega1_3_33 - R3_23 * t3_28 + R3_33 * t3_29;
  v_y[174] = -minus_B5_1_11;
  v_y[175] = -minus_B5_1_12;
  v_y[176] = -minus_B5_1_13;
  v_y[203] = -minus_B5_1_21;
  v_y[204] = -minus_B5_1_22;
  v_y[205] = -minus_B5_1_23;
  v_y[232] = -minus_B5_1_31;
  v_y[233] = -minus_B5_1_32;
  v_y[234] = -minus_B5_1_33;
  // B6_3 = -R3^T r3~ b3
  const T minus_B6_3_1 = R3_11 * T(0.016776845975316125) - R3_21 * T(0.16776845975316124) + R3_31 *
      T(0.0950630018195063);
  const T minus_B6_3_2 = R3_12 * T(0.016776845975316125) - R3_22 * T(0.16776845975316124) + R3_32 *
      T(0.0950630018195063);
  const T minus_B6_3_3 = R3_13 * T(0.016776845975316125) - R3_23 * T(0.16776845975316124) + R3_33 *
      T(0.0950630018195063);
  v_y[180] = -minus_B6_3_1;
  v_y[209] = -minus_B6_3_2;
  v_y[238] = -minus_B6_3_3;

  // ---- body 4 (cross) on body 1
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // R4a^T = R1^T E4a^T: R takes inertial components to body components
  const T R4a_11 = R1_11 * E4a_11 - R1_21 * minus_E4a_12 - R1_31 * minus_E4a_13;
  const T R4a_12 = R1_12 * E4a_11 - R1_22 * minus_E4a_12 - R1_32 * minus_E4a_13;
  const T R4a_13 = R1_13 * E4a_11 - R1_23 * minus_E4a_12 - R1_33 * minus_E4a_13;
  const T R4a_21 = R1_11 * minus_E4a_12 + R1_21 * E4a_22 + R1_31 * E4a_23;
  const T R4a_22 = R1_12 * minus_E4a_12 + R1_22 * E4a_22 + R1_32 * E4a_23;
  const T R4a_23 = R1_13 * minus_E4a_12 + R1_23 * E4a_22 + R1_33 * E4a_23;
  const T R4a_31 = R1_11 * minus_E4a_13 + R1_21 * E4a_23 + R1_31 * E4a_33;
  const T R4a_32 = R1_12 * minus_E4a_13 + R1_22 * E4a_23 + R1_32 * E4a_33;
  const T R4a_33 = R1_13 * minus_E4a_13 + R1_23 * E4a_23 + R1_33 * E4a_33;
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_3 = cosines[10];
  const T E4_12 = T(0.28) * t4_3;
  const T minus_E4_13 = T(0.96) * t4_3;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // R4^T = R4a^T E4^T: R takes inertial components to body components
  const T R4_11 = R4a_21 * E4_12 - R4a_11 * minus_E4_11 - R4a_31 * minus_E4_13;
  const T R4_12 = R4a_22 * E4_12 - R4a_12 * minus_E4_11 - R4a_32 * minus_E4_13;
  const T R4_13 = R4a_23 * E4_12 - R4a_13 * minus_E4_11 - R4a_33 * minus_E4_13;
  const T R4_21 = R4a_21 * T(0.96) + R4a_31 * T(0.28);
  const T R4_22 = R4a_22 * T(0.96) + R4a_32 * T(0.28);
  const T R4_23 = R4a_23 * T(0.96) + R4a_33 * T(0.28);
  const T R4_31 = R4a_11 * t4_3 + R4a_21 * E4_32 - R4a_31 * minus_E4_33;
  const T R4_32 = R4a_12 * t4_3 + R4a_22 * E4_32 - R4a_32 * minus_E4_33;
  const T R4_33 = R4a_13 * t4_3 + R4a_23 * E4_32 - R4a_33 * minus_E4_33;
  // P_omega1_4a = -R1^T q4a~: partial velocity of the body origin, inertial axes
  const T minus_P_omega1_4a_13 = t2_16 + t2_13;
  const T minus_P_omega1_4a_23 = t2_20 + t2_17;
  const T minus_P_omega1_4a_33 = t2_24 + t2_21;
  // omega_omega1_4 = E4 E4a: partial angular velocity, body axes
  const T omega_omega1_4_11 = E4_12 * minus_E4a_12 - minus_E4_11 * E4a_11 - minus_E4_13 * minus_E4a_13;
  const T omega_omega1_4_12 = minus_E4_11 * minus_E4a_12 + E4_12 * E4a_22 - minus_E4_13 * E4a_23;
  const T omega_omega1_4_13 = minus_E4_11 * minus_E4a_13 + E4_12 * E4a_23 - minus_E4_13 * E4a_33;
  const T omega_omega1_4_21 = T(0.96) * minus_E4a_12 + T(0.28) * minus_E4a_13;
  const T omega_omega1_4_22 = T(0.96) * E4a_22 + T(0.28) * E4a_23;
  const T omega_omega1_4_23 = T(0.96) * E4a_23 + T(0.28) * E4a_33;
  const T omega_omega1_4_31 = t4_3 * E4a_11 + E4_32 * minus_E4a_12 - minus_E4_33 * minus_E4a_13;
  const T omega_omega1_4_32 = E4_32 * E4a_22 - t4_3 * minus_E4a_12 - minus_E4_33 * E4a_23;
  const T omega_omega1_4_33 = E4_32 * E4a_23 - t4_3 * minus_E4a_13 - minus_E4_33 * E4a_33;
  // omega_thetadot4_1_4 = E4 b4_1: partial angular velocity, body axes
  const T omega_thetadot4_1_4_1 = E4_12 * T(0.28) + minus_E4_13 * T(0.96);
  const T omega_thetadot4_1_4_3 = E4_32 * T(0.28) + minus_E4_33 * T(0.96);
  // B7_1 = -R4^T r4~ omega_omega1_4 + P_omega1_4a
  const T t4_4 = T(0.1) * omega_omega1_4_11 - T(0.03) * omega_omega1_4_31;
  const T t4_5 = T(0.1) * omega_omega1_4_21;
  const T t4_6 = T(0.03) * omega_omega1_4_21;
  const T minus_B7_1_11 = R4_21 * t4_4 - t2_14 - R4_11 * t4_5 + R4_31 * t4_6;
  const T t4_7 = T(0.1) * omega_omega1_4_12 - T(0.03) * omega_omega1_4_32;
  const T t4_8 = T(0.1) * omega_omega1_4_22;
  const T t4_9 = T(0.03) * omega_omega1_4_22;
  const T minus_B7_1_12 = R4_21 * t4_7 - t2_15 - R4_11 * t4_8 + R4_31 * t4_9;
  const T t4_10 = T(0.1) * omega_omega1_4_13 - T(0.03) * omega_omega1_4_33;
  const T t4_11 = T(0.1) * omega_omega1_4_23;
  const T t4_12 = T(0.03) * omega_omega1_4_23;
  const T minus_B7_1_13 = minus_P_omega1_4a_13 + R4_21 * t4_10 - R4_11 * t4_11 + R4_31 * t4_12;
  const T minus_B7_1_21 = R4_22 * t4_4 - t2_18 - R4_12 * t4_5 + R4_32 * t4_6;
  const T minus_B7_1_22 = R4_22 * t4_7 - t2_19 - R4_12 * t4_8 + R4_32 * t4_9;
  const T minus_B7_1_23 = minus_P_omega1_4a_23 + R4_22 * t4_10 - R4_12 * t4_11 + R4_32 * t4_12;
  const T minus_B7_1_31 = R4_23 * t4_4 - t2_22 - R4_13 * t4_5 + R4_33 * t4_6;
  const T minus_B7_1_32 = R4_23 * t4_7 - t2_23 - R4_13 * t4_8 + R4_33 * t4_9;
  const T minus_B7_1_33 = minus_P_omega1_4a_33 + R4_23 * t4_10 - R4_13 * t4_11 + R4_33 * t4_12;
  v_y[261] = -minus_B7_1_11;
  v_y[262] = -minus_B7_1_12;
  v_y[263] = -minus_B7_1_13;
  v_y[290] = -minus_B7_1_21;
  v_y[291] = -minus_B7_1_22;
  v_y[292] = -minus_B7_1_23;
  v_y[319] = -minus_B7_1_31;
  v_y[320] = -minus_B7_1_32;
  v_y[321] = -minus_B7_1_33;
  // B8_4a = -R4^T r4~ omega_thetadot4_1_4
  const T t4_13 = T(0.1) * omega_thetadot4_1_4_1 - T(0.03) * omega_thetadot4_1_4_3;
  const T minus_B8_4a_1 = R4_21 * t4_13;
  const T minus_B8_4a_2 = R4_22 * t4_13;
  const T minus_B8_4a_3 = R4_23 * t4_13;
  v_y[268] = -minus_B8_4a_1;
  v_y[297] = -minus_B8_4a_2;
  v_y[326] = -minus_B8_4a_3;
  // B9_4 = -R4^T r4~ b4_2
  const T minus_B9_4_1 = R4_31 * T(0.03) - R4_11 * T(0.1);
  const T minus_B9_4_2 = R4_32 * T(0.03) - R4_12 * T(0.1);
  const T minus_B9_4_3 = R4_33 * T(0.03) - R4_13 * T(0.1);
  v_y[269] = -minus_B9_4_1;
  v_y[298] = -minus_B9_4_2;
  v_y[327] = -minus_B9_4_3;

  // ---- body 5 (camera) on body 1
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // theta5_2 = expression 1: prescribed
  const T theta5_2 = c.p.amplitude * sin(T(3) * t);
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // P_omega1_5a = -R1^T q5a~: partial velocity of the body origin, inertial axes
  const T minus_P_omega1_5a_11 = minus_P_omega1_3_11 + t3_18;
  const T P_omega1_5a_13 = R1_11 * T(0.3);
  const T minus_P_omega1_5a_21 = minus_P_omega1_3_21 + t3_19;
  const T P_omega1_5a_23 = R1_12 * T(0.3);
  const T minus_P_omega1_5a_31 = minus_P_omega1_3_31 + t3_20;
  const T P_omega1_5a_33 = R1_13 * T(0.3);
  // omega_omega1_5 = E5 E5a: partial angular velocity, body axes
  const T minus_omega_omega1_5_21 = E5_22 * E5a_12;
  const T omega_omega1_5_22 = E5_22 * E5a_11;
  const T omega_omega1_5_31 = E5_23 * E5a_12;
  const T minus_omega_omega1_5_32 = E5_23 * E5a_11;
  // B10_1 = -R5^T (C5^T r5)~ omega_omega1_5 + P_omega1_5a
  const T t5_1 = T(0.004991670832341408) * minus_omega_omega1_5_21;
  const T t5_2 = T(0.004991670832341408) * E5a_11 + T(0.049750208263901294) * omega_omega1_5_31;
  const T t5_3 = T(0.049750208263901294) * minus_omega_omega1_5_21;
  const T minus_B10_1_11 = minus_P_omega1_5a_11 - R5a_11 * t5_1 - R5_21 * t5_2 - R5_31 * t5_3;
  const T t5_4 = T(0.004991670832341408) * omega_omega1_5_22;
  const T t5_5 = T(0.049750208263901294) * minus_omega_omega1_5_32 - T(0.004991670832341408) * E5a_12;
  const T t5_6 = T(0.049750208263901294) * omega_omega1_5_22;
  const T minus_B10_1_12 = R5a_11 * t5_4 - t2_16 + R5_21 * t5_5 + R5_31 * t5_6;
  const T t5_7 = T(0.004991670832341408) * E5_23;
  const T t5_8 = T(0.049750208263901294) * E5_22;
  const T t5_9 = T(0.049750208263901294) * E5_23;
  const T t5_10 = R5a_11 * t5_7 - R5_21 * t5_8 + R5_31 * t5_9;
  const T minus_B10_1_13 = t5_10 - P_omega1_5a_13;
  const T minus_B10_1_21 = minus_P_omega1_5a_21 - R5a_12 * t5_1 - R5_22 * t5_2 - R5_32 * t5_3;
  const T minus_B10_1_22 = R5a_12 * t5_4 - t2_20 + R5_22 * t5_5 + R5_32 * t5_6;
  const T t5_11 = R5a_12 * t5_7 - R5_22 * t5_8 + R5_32 * t5_9;
  const T minus_B10_1_23 = t5_11 - P_omega1_5a_23;
  const T minus_B10_1_31 = minus_P_omega1_5a_31 - R5a_13 * t5_1 - R5_23 * t5_2 - R5_33 * t5_3;
  const T minus_B10_1_32 = R5a_13 * t5_4 - t2_24 + R5_23 * t5_5 + R5_33 * t5_6;
  const T t5_12 = R5a_13 * t5_7 - R5_23 * t5_8 + R5_33 * t5_9;
  const T minus_B10_1_33 = t5_12 - P_omega1_5a_33;
  v_y[348] = -minus_B10_1_11;
  v_y[349] = -minus_B10_1_12;
  v_y[350] = -minus_B10_1_13;
  v_y[377] = -minus_B10_1_21;
  v_y[378] = -minus_B10_1_22;
  v_y[379] = -minus_B10_1_23;
  v_y[406] = -minus_B10_1_31;
  v_y[407] = -minus_B10_1_32;
  v_y[408] = -minus_B10_1_33;
  v_y[357] = -t5_10;
  v_y[386] = -t5_11;
  v_y[415] = -t5_12;
  // B30_1 = -R5^T (C12^T r12)~ omega_omega1_5 - R5^T o5~ omega_omega1_5 + P_omega1_5a
  const T t5_13 = T(0.03870835392384733) * minus_omega_omega1_5_21;
  const T t5_14 = T(0.03870835392384733) * E5a_11 + T(0.03164906533384792) * omega_omega1_5_31;
  const T t5_15 = T(0.03164906533384792) * minus_omega_omega1_5_21;
  const T t5_16 = T(0.009983341664682815) * minus_omega_omega1_5_21;
  const T t5_17 = T(0.009983341664682815) * E5a_11 + T(0.09950041652780259) * omega_omega1_5_31;
  const T t5_18 = T(0.09950041652780259) * minus_omega_omega1_5_21;
  const T minus_B30_1_11 = minus_P_omega1_5a_11 + R5a_11 * t5_13 + R5_21 * t5_14 + R5_31 * t5_15 - R5a_11 * t5_16 -
      R5_21 * t5_17 - R5_31 * t5_18;
  const T t5_19 = T(0.03870835392384733) * E5a_12 - T(0.03164906533384792) * minus_omega_omega1_5_32;
  const T t5_20 = T(0.03870835392384733) * omega_omega1_5_22;
  const T t5_21 = T(0.03164906533384792) * omega_omega1_5_22;
  const T t5_22 = T(0.009983341664682815) * omega_omega1_5_22;
  const T t5_23 = T(0.09950041652780259) * minus_omega_omega1_5_32 - T(0.009983341664682815) * E5a_12;
  const T t5_24 = T(0.09950041652780259) * omega_omega1_5_22;
  const T minus_B30_1_12 = R5_21 * t5_19 - t2_16 - R5a_11 * t5_20 - R5_31 * t5_21 + R5a_11 * t5_22 + R5_21 * t5_23 +
      R5_31 * t5_24;
  const T t5_25 = T(0.03164906533384792) * E5_22;
  const T t5_26 = T(0.03870835392384733) * E5_23;
  const T t5_27 = T(0.03164906533384792) * E5_23;
  const T t5_28 = T(0.009983341664682815) * E5_23;
  const T t5_29 = T(0.09950041652780259) * E5_22;
  const T t5_30 = T(0.09950041652780259) * E5_23;
  const T t5_31 = R5_21 * t5_25 - R5a_11 * t5_26 - R5_31 * t5_27 + R5a_11 * t5_28 - R5_21 * t5_29 + R5_31 * t5_30;
  const T minus_B30_1_13 = t5_31 - P_omega1_5a_13;
  const T minus_B30_1_21 = minus_P_omega1_5a_21 + R5a_12 * t5_13 + R5_22 * t5_14 + R5_32 * t5_15 - R5a_12 * t5_16 -
      R5_22 * t5_17 - R5_32 * t5_18;
  const T minus_B30_1_22 = R5_22 * t5_19 - t2_20 - R5a_12 * t5_20 - R5_32 * t5_21 + R5a_12 * t5_22 + R5_22 * t5_23 +
      R5_32 * t5_24;
  const T t5_32 = R5_22 * t5_25 - R5a_12 * t5_26 - R5_32 * t5_27 + R5a_12 * t5_28 - R5_22 * t5_29 + R5_32 * t5_30;
  const T minus_B30_1_23 = t5_32 - P_omega1_5a_23;
  const T minus_B30_1_31 = minus_P_omega1_5a_31 + R5a_13 * t5_13 + R5_23 * t5_14 + R5_33 * t5_15 - R5a_13 * t5_16 -
      R5_23 * t5_17 - R5_33 * t5_18;
  const T minus_B30_1_32 = R5_23 * t5_19 - t2_24 - R5a_13 * t5_20 - R5_33 * t5_21 + R5a_13 * t5_22 + R5_23 * t5_23 +
      R5_33 * t5_24;
  const T t5_33 = R5_23 * t5_25 - R5a_13 * t5_26 - R5_33 * t5_27 + R5a_13 * t5_28 - R5_23 * t5_29 + R5_33 * t5_30;
  const T minus_B30_1_33 = t5_33 - P_omega1_5a_33;
  v_y[957] = -minus_B30_1_11;
  v_y[958] = -minus_B30_1_12;
  v_y[959] = -minus_B30_1_13;
  v_y[986] = -minus_B30_1_21;
  v_y[987] = -minus_B30_1_22;
  v_y[988] = -minus_B30_1_23;
  v_y[1015] = -minus_B30_1_31;
  v_y[1016] = -minus_B30_1_32;
  v_y[1017] = -minus_B30_1_33;
  v_y[966] = -t5_31;
  v_y[995] = -t5_32;
  v_y[1024] = -t5_33;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P_omega1_6 = -R3^T d6~ E3 + P_omega1_3: partial velocity of the body origin, inertial axes
  const T t6_1 = d6_1 * E3_21;
  const T t6_2 = d6_1 * E3_31;
  const T minus_P_omega1_6_11 = minus_P_omega1_3_11 + R3_31 * t6_1 - R3_21 * t6_2;
  const T t6_3 = d6_1 * E3_22;
  const T t6_4 = d6_1 * E3_32;
  const T minus_P_omega1_6_12 = minus_P_omega1_3_12 + R3_31 * t6_3 - R3_21 * t6_4;
  const T t6_5 = d6_1 * E3_23;
  const T t6_6 = d6_1 * E3_33;
  const T minus_P_omega1_6_13 = R3_31 * t6_5 - P_omega1_3_13 - R3_21 * t6_6;
  const T minus_P_omega1_6_21 = minus_P_omega1_3_21 + R3_32 * t6_1 - R3_22 * t6_2;
  const T minus_P_omega1_6_22 = minus_P_omega1_3_22 + R3_32 * t6_3 - R3_22 * t6_4;
  const T minus_P_omega1_6_23 = R3_32 * t6_5 - P_omega1_3_23 - R3_22 * t6_6;
  const T minus_P_omega1_6_31 = minus_P_omega1_3_31 + R3_33 * t6_1 - R3_23 * t6_2;
  const T minus_P_omega1_6_32 = minus_P_omega1_3_32 + R3_33 * t6_3 - R3_23 * t6_4;
  const T minus_P_omega1_6_33 = R3_33 * t6_5 - P_omega1_3_33 - R3_23 * t6_6;
  // P_thetadot3_6 = -R3^T d6~ b3: partial velocity of the body origin, inertial axes
  const T t6_7 = d6_1 * T(0.44378789320576517);
  const T t6_8 = d6_1 * T(0.8388422987658062);
  const T minus_P_thetadot3_6_1 = R3_31 * t6_7 - R3_21 * t6_8;
  const T minus_P_thetadot3_6_2 = R3_32 * t6_7 - R3_22 * t6_8;
  const T minus_P_thetadot3_6_3 = R3_33 * t6_7 - R3_23 * t6_8;
  // B12_1 = -R3^T r6~ E3 + P_omega1_6
  const T t6_9 = T(0.01) * E3_11 - T(0.1) * E3_31;
  const T t6_10 = T(0.01) * E3_21;
  const T t6_11 = T(0.1) * E3_21;
  const T minus_B12_1_11 = minus_P_omega1_6_11 + R3_21 * t6_9 - R3_11 * t6_10 + R3_31 * t6_11;
  const T t6_12 = T(0.01) * E3_12 - T(0.1) * E3_32;
  const T t6_13 = T(0.01) * E3_22;
  const T t6_14 = T(0.1) * E3_22;
  const T minus_B12_1_12 = minus_P_omega1_6_12 + R3_21 * t6_12 - R3_11 * t6_13 + R3_31 * t6_14;
  const T t6_15 = T(0.01) * E3_23;
  const T t6_16 = T(0.01) * minus_E3_13 + T(0.1) * E3_33;
  const T t6_17 = T(0.1) * E3_23;
  const T minus_B12_1_13 = minus_P_omega1_6_13 - R3_11 * t6_15 - R3_21 * t6_16 + R3_31 * t6_17;
  const T minus_B12_1_21 = minus_P_omega1_6_21 + R3_22 * t6_9 - R3_12 * t6_10 + R3_32 * t6_11;
  const T minus_B12_1_22 = minus_P_omega1_6_22 + R3_22 * t6_12 - R3_12 * t6_13 + R3_32 * t6_14;
  const T minus_B12_1_23 = minus_P_omega1_6_23 - R3_12 * t6_15 - R3_22 * t6_16 + R3_32 * t6_17;
  const T minus_B12_1_31 = minus_P_omega1_6_31 + R3_23 * t6_9 - R3_13 * t6_10 + R3_33 * t6_11;
  const T minus_B12_1_32 = minus_P_omega1_6_32 + R3_23 * t6_12 - R3_13 * t6_13 + R3_33 * t6_14;
  const T minus_B12_1_33 = minus_P_omega1_6_33 - R3_13 * t6_15 - R3_23 * t6_16 + R3_33 * t6_17;
  v_y[435] = -minus_B12_1_11;
  v_y[436] = -minus_B12_1_12;
  v_y[437] = -minus_B12_1_13;
  v_y[464] = -minus_B12_1_21;
  v_y[465] = -minus_B12_1_22;
  v_y[466] = -minus_B12_1_23;
  v_y[493] = -minus_B12_1_31;
  v_y[494] = -minus_B12_1_32;
  v_y[495] = -minus_B12_1_33;
  // B13_3 = -R3^T r6~ b3 + P_thetadot3_6
  const T minus_B13_3_1 = minus_P_thetadot3_6_1 - R3_11 * T(0.004437878932057652) - R3_21 * T(0.08703694146575726) +
      R3_31 * T(0.04437878932057652);
  const T minus_B13_3_2 = minus_P_thetadot3_6_2 - R3_12 * T(0.004437878932057652) - R3_22 * T(0.08703694146575726) +
      R3_32 * T(0.04437878932057652);
  const T minus_B13_3_3 = minus_P_thetadot3_6_3 - R3_13 * T(0.004437878932057652) - R3_23 * T(0.08703694146575726) +
      R3_33 * T(0.04437878932057652);
  v_y[441] = -minus_B13_3_1;
  v_y[470] = -minus_B13_3_2;
  v_y[499] = -minus_B13_3_3;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // R8^T = R1^T E8^T: R takes inertial components to body components
  const T R8_11 = R1_11 * E8_11 + R1_31 * E8_13;
  const T R8_12 = R1_12 * E8_11 + R1_32 * E8_13;
  const T R8_13 = R1_13 * E8_11 + R1_33 * E8_13;
  const T R8_31 = R1_31 * E8_11 - R1_11 * E8_13;
  const T R8_32 = R1_32 * E8_11 - R1_12 * E8_13;
  const T R8_33 = R1_33 * E8_11 - R1_13 * E8_13;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // P_omega1_8 = -R1^T d8~: partial velocity of the body origin, inertial axes
  const T P_omega1_8_11 = R1_31 * d8_2;
  const T minus_P_omega1_8_13 = R1_11 * d8_2;
  const T P_omega1_8_21 = R1_32 * d8_2;
  const T minus_P_omega1_8_23 = R1_12 * d8_2;
  const T P_omega1_8_31 = R1_33 * d8_2;
  const T minus_P_omega1_8_33 = R1_13 * d8_2;
  // B17_1 = -R8^T (C8^T r8)~ E8 + P_omega1_8
  const T t8_1 = T(0.1) * E8_13;
  const T t8_2 = T(0.02) * E8_11 - T(0.01) * E8_13;
  const T t8_3 = T(0.1) * E8_11;
  const T minus_B17_1_11 = R8_11 * t8_1 - P_omega1_8_11 + R1_21 * t8_2 + R8_31 * t8_3;
  const T B17_1_12 = R8_11 * T(0.02) + R8_31 * T(0.01);
  const T t8_4 = T(0.02) * E8_13 + T(0.01) * E8_11;
  const T minus_B17_1_13 = minus_P_omega1_8_13 + R1_21 * t8_4 - R8_11 * t8_3 + R8_31 * t8_1;
  const T minus_B17_1_21 = R8_12 * t8_1 - P_omega1_8_21 + R1_22 * t8_2 + R8_32 * t8_3;
  const T B17_1_22 = R8_12 * T(0.02) + R8_32 * T(0.01);
  const T minus_B17_1_23 = minus_P_omega1_8_23 + R1_22 * t8_4 - R8_12 * t8_3 + R8_32 * t8_1;
  const T minus_B17_1_31 = R8_13 * t8_1 - P_omega1_8_31 + R1_23 * t8_2 + R8_33 * t8_3;
  const T B17_1_32 = R8_13 * T(0.02) + R8_33 * T(0.01);
  const T minus_B17_1_33 = minus_P_omega1_8_33 + R1_23 * t8_4 - R8_13 * t8_3 + R8_33 * t8_1;
  v_y[609] = -minus_B17_1_11;
  v_y[610] = B17_1_12;
  v_y[619] = -B17_1_12;
  v_y[611] = -minus_B17_1_13;
  v_y[638] = -minus_B17_1_21;
  v_y[639] = B17_1_22;
  v_y[648] = -B17_1_22;
  v_y[640] = -minus_B17_1_23;
  v_y[667] = -minus_B17_1_31;
  v_y[668] = B17_1_32;
  v_y[677] = -B17_1_32;
  v_y[669] = -minus_B17_1_33;

  // ---- body 9 (sled) on the inertial frame
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // B20_9 = -E9^T r9~ b9
  const T minus_B20_9_1 = E9_12 * T(0.1);
  const T B20_9_2 = E9_11 * T(0.1);
  v_y[707] = -minus_B20_9_1;
  v_y[736] = B20_9_2;

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // P_omega1_10 = -R1^T d10~: partial velocity of the body origin, inertial axes
  const T minus_P_omega1_10_11 = P_omega1_3_13 - R1_31 * s10;
  const T minus_P_omega1_10_12 = t2_14 - P_omega1_5a_13;
  const T minus_P_omega1_10_13 = R1_11 * s10 - minus_P_omega1_3_11;
  const T minus_P_omega1_10_21 = P_omega1_3_23 - R1_32 * s10;
  const T minus_P_omega1_10_22 = t2_18 - P_omega1_5a_23;
  const T minus_P_omega1_10_23 = R1_12 * s10 - minus_P_omega1_3_21;
  const T minus_P_omega1_10_31 = P_omega1_3_33 - R1_33 * s10;
  const T minus_P_omega1_10_32 = t2_22 - P_omega1_5a_33;
  const T minus_P_omega1_10_33 = R1_13 * s10 - minus_P_omega1_3_31;
  v_y[783] = -minus_P_omega1_10_11;
  v_y[784] = -minus_P_omega1_10_12;
  v_y[785] = -minus_P_omega1_10_13;
  v_y[812] = -minus_P_omega1_10_21;
  v_y[813] = -minus_P_omega1_10_22;
  v_y[814] = -minus_P_omega1_10_23;
  v_y[841] = -minus_P_omega1_10_31;
  v_y[842] = -minus_P_omega1_10_32;
  v_y[843] = -minus_P_omega1_10_33;
  // B24_10 = -R10^T r10~
  const T B24_10_11 = R10_21 * T(0.03) + R10_31 * T(0.01);
  const T minus_B24_10_12 = R10_11 * T(0.03) + R10_31 * T(0.02);
  const T minus_B24_10_13 = R10_11 * T(0.01) - R10_21 * T(0.02);
  const T B24_10_21 = R10_22 * T(0.03) + R10_32 * T(0.01);
  const T minus_B24_10_22 = R10_12 * T(0.03) + R10_32 * T(0.02);
  const T minus_B24_10_23 = R10_12 * T(0.01) - R10_22 * T(0.02);
  const T B24_10_31 = R10_23 * T(0.03) + R10_33 * T(0.01);
  const T minus_B24_10_32 = R10_13 * T(0.03) + R10_33 * T(0.02);
  const T minus_B24_10_33 = R10_13 * T(0.01) - R10_23 * T(0.02);
  v_y[795] = B24_10_11;
  v_y[796] = -minus_B24_10_12;
  v_y[797] = -minus_B24_10_13;
  v_y[824] = B24_10_21;
  v_y[825] = -minus_B24_10_22;
  v_y[826] = -minus_B24_10_23;
  v_y[853] = B24_10_31;
  v_y[854] = -minus_B24_10_32;
  v_y[855] = -minus_B24_10_33;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // R11^T = R8^T E11^T: R takes inertial components to body components
  const T R11_11 = R8_11 * E11_11 + R8_31 * E11_13;
  const T R11_12 = R8_12 * E11_11 + R8_32 * E11_13;
  const T R11_13 = R8_13 * E11_11 + R8_33 * E11_13;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // omega_omega1_11 = E11 E8: partial angular velocity, body axes
  const T omega_omega1_11_11 = E11_11 * E8_11 - E11_13 * E8_13;
  const T omega_omega1_11_13 = E11_13 * E8_11 + E11_11 * E8_13;
  // P_omega1_11 = -R8^T d11~ E8 + P_omega1_8: partial velocity of the body origin, inertial axes
  const T t11_1 = minus_d11_2 * E8_13;
  const T t11_2 = minus_d11_2 * E8_11;
  const T minus_P_omega1_11_11 = R8_11 * t11_1 - P_omega1_8_11 + R8_31 * t11_2;
  const T minus_P_omega1_11_13 = minus_P_omega1_8_13 + R8_31 * t11_1 - R8_11 * t11_2;
  const T minus_P_omega1_11_21 = R8_12 * t11_1 - P_omega1_8_21 + R8_32 * t11_2;
  const T minus_P_omega1_11_23 = minus_P_omega1_8_23 + R8_32 * t11_1 - R8_12 * t11_2;
  const T minus_P_omega1_11_31 = R8_13 * t11_1 - P_omega1_8_31 + R8_33 * t11_2;
  const T minus_P_omega1_11_33 = minus_P_omega1_8_33 + R8_33 * t11_1 - R8_13 * t11_2;
  // B26_1 = -R11^T (C11^T r11)~ omega_omega1_11 + P_omega1_11
  const T t11_3 = T(0.01) * omega_omega1_11_11;
  const T minus_B26_1_11 = minus_P_omega1_11_11 + R1_21 * t11_3;
  const T B26_1_12 = R11_11 * T(0.01);
  const T t11_4 = T(0.01) * omega_omega1_11_13;
  const T minus_B26_1_13 = minus_P_omega1_11_13 + R1_21 * t11_4;
  const T minus_B26_1_21 = minus_P_omega1_11_21 + R1_22 * t11_3;
  const T B26_1_22 = R11_12 * T(0.01);
  const T minus_B26_1_23 = minus_P_omega1_11_23 + R1_22 * t11_4;
  const T minus_B26_1_31 = minus_P_omega1_11_31 + R1_23 * t11_3;
  const T B26_1_32 = R11_13 * T(0.01);
  const T minus_B26_1_33 = minus_P_omega1_11_33 + R1_23 * t11_4;
  v_y[870] = -minus_B26_1_11;
  v_y[871] = B26_1_12;
  v_y[880] = -B26_1_12;
  v_y[872] = -minus_B26_1_13;
  v_y[899] = -minus_B26_1_21;
  v_y[900] = B26_1_22;
  v_y[909] = -B26_1_22;
  v_y[901] = -minus_B26_1_23;
  v_y[928] = -minus_B26_1_31;
  v_y[929] = B26_1_32;
  v_y[938] = -B26_1_32;
  v_y[930] = -minus_B26_1_33;
  // B28_11 = -R11^T (C11^T r11)~ b11 + pitch11 R8^T u11
  const T minus_B28_11_1 = B26_1_12 + R1_21 * T(0.01);
  const T minus_B28_11_2 = B26_1_22 + R1_22 * T(0.01);
  const T minus_B28_11_3 = B26_1_32 + R1_23 * T(0.01);
  v_y[885] = -minus_B28_11_1;
  v_y[914] = -minus_B28_11_2;
  v_y[943] = -minus_B28_11_3;

  // ---- results
  v_y[16] = T(1);
  v_y[46] = T(1);
  v_y[76] = T(1);
  v_y[103] = T(1);
  v_y[133] = T(1);
  v_y[163] = T(1);
  v_y[190] = T(1);
  v_y[220] = T(1);
  v_y[250] = T(1);
  v_y[277] = T(1);
  v_y[307] = T(1);
  v_y[337] = T(1);
  v_y[364] = T(1);
  v_y[394] = T(1);
  v_y[424] = T(1);
  v_y[451] = T(1);
  v_y[481] = T(1);
  v_y[511] = T(1);
  v_y[542] = T(1);
  v_y[572] = T(1);
  v_y[625] = T(1);
  v_y[655] = T(1);
  v_y[685] = T(1);
  v_y[719] = T(1);
  v_y[749] = T(1);
  v_y[799] = T(1);
  v_y[829] = T(1);
  v_y[859] = T(1);
  v_y[886] = T(1);
  v_y[916] = T(1);
  v_y[946] = T(1);
  v_y[973] = T(1);
  v_y[1003] = T(1);
  v_y[1033] = T(1);
  v_y[1070] = T(1);
  v_y[1100] = T(1);
  v_y[1130] = T(1);
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 937 add, 1437 multiply, 18 sine or cosine
template <class T>
void partial_velocity_rates(const Prepared<T>& c, T t, const T* x, const T* y, T* v_y_dot) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 1131; ++i) v_y_dot[i] = T(0);
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
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
  const T minus_B1_1_11 = t1_13 * T(0.03) + t1_14 * T(0.01);
  const T t1_15 = R1_21 * omega1_3 - R1_31 * omega1_2;
  const T minus_B1_1_12 = t1_14 * T(0.02) - t1_15 * T(0.03);
  const T B1_1_13 = t1_15 * T(0.01) + t1_13 * T(0.02);
  const T t1_16 = R1_32 * omega1_1 - R1_12 * omega1_3;
  const T t1_17 = R1_12 * omega1_2 - R1_22 * omega1_1;
  const T minus_B1_1_21 = t1_16 * T(0.03) + t1_17 * T(0.01);
  const T t1_18 = R1_22 * omega1_3 - R1_32 * omega1_2;
  const T minus_B1_1_22 = t1_17 * T(0.02) - t1_18 * T(0.03);
  const T B1_1_23 = t1_18 * T(0.01) + t1_16 * T(0.02);
  const T t1_19 = R1_33 * omega1_1 - R1_13 * omega1_3;
  const T t1_20 = R1_13 * omega1_2 - R1_23 * omega1_1;
  const T minus_B1_1_31 = t1_19 * T(0.03) + t1_20 * T(0.01);
  const T t1_21 = R1_23 * omega1_3 - R1_33 * omega1_2;
  const T minus_B1_1_32 = t1_20 * T(0.02) - t1_21 * T(0.03);
  const T B1_1_33 = t1_21 * T(0.01) + t1_19 * T(0.02);
  v_y_dot[0] = -minus_B1_1_11;
  v_y_dot[1] = -minus_B1_1_12;
  v_y_dot[2] = B1_1_13;
  v_y_dot[29] = -minus_B1_1_21;
  v_y_dot[30] = -minus_B1_1_22;
  v_y_dot[31] = B1_1_23;
  v_y_dot[58] = -minus_B1_1_31;
  v_y_dot[59] = -minus_B1_1_32;
  v_y_dot[60] = B1_1_33;
  v_y_dot[631] = -t1_13;
  v_y_dot[808] = t1_13;
  v_y_dot[892] = -t1_13;
  v_y_dot[660] = -t1_16;
  v_y_dot[837] = t1_16;
  v_y_dot[921] = -t1_16;
  v_y_dot[689] = -t1_19;
  v_y_dot[866] = t1_19;
  v_y_dot[950] = -t1_19;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P_dot_omega1_2 = -R1^T omega1~ q2~: its rate
  const T t2_13 = t1_13 * T(0.2);
  const T t2_14 = t1_14 * T(0.1);
  const T P_dot_omega1_2_11 = t2_13 + t2_14;
  const T t2_15 = t1_14 * T(0.2);
  const T minus_P_dot_omega1_2_12 = t2_15 + t1_15 * T(0.2);
  const T t2_16 = t1_15 * T(0.1);
  const T minus_P_dot_omega1_2_13 = t2_16 - t2_13;
  const T t2_17 = t1_16 * T(0.2);
  const T t2_18 = t1_17 * T(0.1);
  const T P_dot_omega1_2_21 = t2_17 + t2_18;
  const T t2_19 = t1_17 * T(0.2);
  const T minus_P_dot_omega1_2_22 = t2_19 + t1_18 * T(0.2);
  const T t2_20 = t1_18 * T(0.1);
  const T minus_P_dot_omega1_2_23 = t2_20 - t2_17;
  const T t2_21 = t1_19 * T(0.2);
  const T t2_22 = t1_20 * T(0.1);
  const T P_dot_omega1_2_31 = t2_21 + t2_22;
  const T t2_23 = t1_20 * T(0.2);
  const T minus_P_dot_omega1_2_32 = t2_23 + t1_21 * T(0.2);
  const T t2_24 = t1_21 * T(0.1);
  const T minus_P_dot_omega1_2_33 = t2_24 - t2_21;
  v_y_dot[87] = P_dot_omega1_2_11;
  v_y_dot[88] = -minus_P_dot_omega1_2_12;
  v_y_dot[89] = -minus_P_dot_omega1_2_13;
  v_y_dot[116] = P_dot_omega1_2_21;
  v_y_dot[117] = -minus_P_dot_omega1_2_22;
  v_y_dot[118] = -minus_P_dot_omega1_2_23;
  v_y_dot[145] = P_dot_omega1_2_31;
  v_y_dot[146] = -minus_P_dot_omega1_2_32;
  v_y_dot[147] = -minus_P_dot_omega1_2_33;
  // B3_2 = -R2^T omega2~ r2~
  const T B3_2_11 = (R2_31 * omega2_1 - R2_11 * omega2_3) * T(0.2) + (R2_11 * omega2_2 - R2_21 * omega2_1) * T(0.02);
  const T t2_25 = R2_21 * omega2_3 - R2_31 * omega2_2;
  const T minus_B3_2_12 = t2_25 * T(0.2);
  const T minus_B3_2_13 = t2_25 * T(0.02);
  const T B3_2_21 = (R2_32 * omega2_1 - R2_12 * omega2_3) * T(0.2) + (R2_12 * omega2_2 - R2_22 * omega2_1) * T(0.02);
  const T t2_26 = R2_22 * omega2_3 - R2_32 * omega2_2;
  const T minus_B3_2_22 = t2_26 * T(0.2);
  const T minus_B3_2_23 = t2_26 * T(0.02);
  const T B3_2_31 = (R2_33 * omega2_1 - R2_13 * omega2_3) * T(0.2) + (R2_13 * omega2_2 - R2_23 * omega2_1) * T(0.02);
  const T t2_27 = R2_23 * omega2_3 - R2_33 * omega2_2;
  const T minus_B3_2_32 = t2_27 * T(0.2);
  const T minus_B3_2_33 = t2_27 * T(0.02);
  v_y_dot[90] = B3_2_11;
  v_y_dot[91] = -minus_B3_2_12;
  v_y_dot[92] = -minus_B3_2_13;
  v_y_dot[119] = B3_2_21;
  v_y_dot[120] = -minus_B3_2_22;
  v_y_dot[121] = -minus_B3_2_23;
  v_y_dot[148] = B3_2_31;
  v_y_dot[149] = -minus_B3_2_32;
  v_y_dot[150] = -minus_B3_2_33;

  // ---- body 3 (boom) on body 1
  const T thetadot3 = y[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_11 * E3_31 + R1_21 * E3_32 + R1_31 * E3_33;
  const T R3_32 = R1_12 * E3_31 + R1_22 * E3_32 + R1_32 * E3_33;
  const T R3_33 = R1_13 * E3_31 + R1_23 * E3_32 + R1_33 * E3_33;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_1 = E3_11 * omega1_1 + E3_12 * omega1_2 - minus_E3_13 * omega1_3 - thetadot3 * T(0.3152711589176631);
  const T omega3_2 = thetadot3 * T(0.44378789320576517) + E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = thetadot3 * T(0.8388422987658062) + E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  // P_dot_omega1_3 = -R1^T omega1~ q3~: its rate
  const T minus_P_dot_omega1_3_11 = t1_13 * T(0.1);
  const T t3_18 = t1_14 * T(0.3);
  const T minus_P_dot_omega1_3_12 = t3_18 - t2_16;
  const T P_dot_omega1_3_13 = t1_13 * T(0.3);
  const T minus_P_dot_omega1_3_21 = t1_16 * T(0.1);
  const T t3_19 = t1_17 * T(0.3);
  const T minus_P_dot_omega1_3_22 = t3_19 - t2_20;
  const T P_dot_omega1_3_23 = t1_16 * T(0.3);
  const T minus_P_dot_omega1_3_31 = t1_19 * T(0.1);
  const T t3_20 = t1_20 * T(0.3);
  const T minus_P_dot_omega1_3_32 = t3_20 - t2_24;
  const T P_dot_omega1_3_33 = t1_19 * T(0.3);
  // B4_1 = thetadot3 R3^T r3~ b3~ E3 - R3^T omega3~ r3~ E3 + P_dot_omega1_3
  const T t3_21 = T(0.2) * E3_31;
  const T t3_22 = T(0.02) * E3_31;
  const T t3_23 = omega3_1 * t3_21 + omega3_2 * t3_22;
  const T t3_24 = T(0.2) * E3_21 - T(0.02) * E3_11;
  const T t3_25 = omega3_3 * t3_21 + omega3_2 * t3_24;
  const T t3_26 = omega3_3 * t3_22 - omega3_1 * t3_24;
  const T t3_27 = T(0.3152711589176631) * E3_21 + T(0.44378789320576517) * E3_11;
  const T t3_28 = T(0.2) * t3_27;
  const T t3_29 = T(0.02) * t3_27;
  const T t3_30 = T(0.8388422987658062) * E3_11 + T(0.3152711589176631) * E3_31;
  const T t3_31 = T(0.44378789320576517) * E3_31 - T(0.8388422987658062) * E3_21;
  const T t3_32 = T(0.2) * t3_30 - T(0.02) * t3_31;
  const T B4_1_11 = R3_31 * t3_23 - (minus_P_dot_omega1_3_11 + R3_11 * t3_25 + R3_21 * t3_26) + thetadot3 * (R3_21 *
      t3_28 - R3_11 * t3_29 + R3_31 * t3_32);
  const T t3_33 = T(0.2) * E3_32;
  const T t3_34 = T(0.02) * E3_32;
  const T t3_35 = omega3_1 * t3_33 + omega3_2 * t3_34;
  const T t3_36 = T(0.2) * E3_22 - T(0.02) * E3_12;
  const T t3_37 = omega3_3 * t3_33 + omega3_2 * t3_36;
  const T t3_38 = omega3_3 * t3_34 - omega3_1 * t3_36;
  const T t3_39 = T(0.3152711589176631) * E3_22 + T(0.44378789320576517) * E3_12;
  const T t3_40 = T(0.2) * t3_39;
  const T t3_41 = T(0.02) * t3_39;
  const T t3_42 = T(0.8388422987658062) * E3_12 + T(0.3152711589176631) * E3_32;
  const T t3_43 = T(0.44378789320576517) * E3_32 - T(0.8388422987658062) * E3_22;
  const T t3_44 = T(0.2) * t3_42 - T(0.02) * t3_43;
  const T B4_1_12 = R3_31 * t3_35 - (minus_P_dot_omega1_3_12 + R3_11 * t3_37 + R3_21 * t3_38) + thetadot3 * (R3_21 *
      t3_40 - R3_11 * t3_41 + R3_31 * t3_44);
  const T t3_45 = T(0.2) * E3_33;
  const T t3_46 = T(0.2) * E3_23 + T(0.02) * minus_E3_13;
  const T t3_47 = omega3_3 * t3_45 + omega3_2 * t3_46;
  const T t3_48 = T(0.02) * E3_33;
  const T t3_49 = omega3_3 * t3_48 - omega3_1 * t3_46;
  const T t3_50 = omega3_1 * t3_45 + omega3_2 * t3_48;
  const T t3_51 = T(0.44378789320576517) * minus_E3_13 - T(0.3152711589176631) * E3_23;
  const T t3_52 = T(0.02) * t3_51;
  const T t3_53 = T(0.2) * t3_51;
  const T t3_54 = T(0.3152711589176631) * E3_33 - T(0.8388422987658062) * minus_E3_13;
  const T t3_55 = T(0.44378789320576517) * E3_33 - T(0.8388422987658062) * E3_23;
  const T t3_56 = T(0.2) * t3_54 - T(0.02) * t3_55;
  const T B4_1_13 = P_dot_omega1_3_13 - R3_11 * t3_47 - R3_21 * t3_49 + R3_31 * t3_50 + thetadot3 * (R3_11 * t3_52 -
      R3_21 * t3_53 + R3_31 * t3_56);
  const T B4_1_21 = R3_32 * t3_23 - (minus_P_dot_omega1_3_21 + R3_12 * t3_25 + R3_22 * t3_26) + thetadot3 * (R3_22 *
      t3_28 - R3_12 * t3_29 + R3_32 * t3_32);
  const T B4_1_22 = R3_32 * t3_35 - (minus_P_dot_omega1_3_22 + R3_12 * t3_37 + R3_22 * t3_38) + thetadot3 * (R3_22 *
      t3_40 - R3_12 * t3_41 + R3_32 * t3_44);
  const T B4_1_23 = P_dot_omega1_3_23 - R3_12 * t3_47 - R3_22 * t3_49 + R3_32 * t3_50 + thetadot3 * (R3_12 * t3_52 -
      R3_22 * t3_53 + R3_32 * t3_56);
  const T B4_1_31 = R3_33 * t3_23 - (minus_P_dot_omega1_3_31 + R3_13 * t3_25 + R3_23 * t3_26) + thetadot3 * (R3_23 *
      t3_28 - R3_13 * t3_29 + R3_33 * t3_32);
  const T B4_1_32 = R3_33 * t3_35 - (minus_P_dot_omega1_3_32 + R3_13 * t3_37 + R3_23 * t3_38) + thetadot3 * (R3_23 *
      t3_40 - R3_13 * t3_41 + R3_33 * t3_44);
  const T B4_1_33 = P_dot_omega1_3_33 - R3_13 * t3_47 - R3_23 * t3_49 + R3_33 * t3_50 + thetadot3 * (R3_13 * t3_52 -
      R3_23 * t3_53 + R3_33 * t3_56);
  v_y_dot[174] = B4_1_11;
  v_y_dot[175] = B4_1_12;
  v_y_dot[176] = B4_1_13;
  v_y_dot[203] = B4_1_21;
  v_y_dot[204] = B4_1_22;
  v_y_dot[205] = B4_1_23;
  v_y_dot[232] = B4_1_31;
  v_y_dot[233] = B4_1_32;
  v_y_dot[234] = B4_1_33;
  // B5_3 = -R3^T omega3~ r3~ b3
  const T t3_57 = omega3_3 * T(0.16776845975316124) + omega3_2 * T(0.0950630018195063);
  const T t3_58 = omega3_3 * T(0.016776845975316125) - omega3_1 * T(0.0950630018195063);
  const T t3_59 = omega3_1 * T(0.16776845975316124) + omega3_2 * T(0.016776845975316125);
  const T minus_B5_3_1 = R3_11 * t3_57 + R3_21 * t3_58 - R3_31 * t3_59;
  const T minus_B5_3_2 = R3_12 * t3_57 + R3_22 * t3_58 - R3_32 * t3_59;
  const T minus_B5_3_3 = R3_13 * t3_57 + R3_23 * t3_58 - R3_33 * t3_59;
  v_y_dot[180] = -minus_B5_3_1;
  v_y_dot[209] = -minus_B5_3_2;
  v_y_dot[238] = -minus_B5_3_3;
  // B13_3 = R3^T omega3~ u6
  const T B13_3_1 = R3_21 * omega3_3 - R3_31 * omega3_2;
  const T B13_3_2 = R3_22 * omega3_3 - R3_32 * omega3_2;
  const T B13_3_3 = R3_23 * omega3_3 - R3_33 * omega3_2;
  v_y_dot[454] = B13_3_1;
  v_y_dot[483] = B13_3_2;
  v_y_dot[512] = B13_3_3;

  // ---- body 4 (cross) on body 1
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // R4a^T = R1^T E4a^T: R takes inertial components to body components
  const T R4a_11 = R1_11 * E4a_11 - R1_21 * minus_E4a_12 - R1_31 * minus_E4a_13;
  const T R4a_12 = R1_12 * E4a_11 - R1_22 * minus_E4a_12 - R1_32 * minus_E4a_13;
  const T R4a_13 = R1_13 * E4a_11 - R1_23 * minus_E4a_12 - R1_33 * minus_E4a_13;
  const T R4a_21 = R1_11 * minus_E4a_12 + R1_21 * E4a_22 + R1_31 * E4a_23;
  const T R4a_22 = R1_12 * minus_E4a_12 + R1_22 * E4a_22 + R1_32 * E4a_23;
  const T R4a_23 = R1_13 * minus_E4a_12 + R1_23 * E4a_22 + R1_33 * E4a_23;
  const T R4a_31 = R1_11 * minus_E4a_13 + R1_21 * E4a_23 + R1_31 * E4a_33;
  const T R4a_32 = R1_12 * minus_E4a_13 + R1_22 * E4a_23 + R1_32 * E4a_33;
  const T R4a_33 = R1_13 * minus_E4a_13 + R1_23 * E4a_23 + R1_33 * E4a_33;
  // omega4a = thetadot4_1 b4_1 + E4a omega1: absolute angular velocity, body axes [rad/s]
  const T omega4a_1 = E4a_11 * omega1_1 - minus_E4a_12 * omega1_2 - minus_E4a_13 * omega1_3;
  const T omega4a_2 = thetadot4_1 * T(0.28) + minus_E4a_12 * omega1_1 + E4a_22 * omega1_2 + E4a_23 * omega1_3;
  const T omega4a_3 = minus_E4a_13 * omega1_1 + E4a_23 * omega1_2 + E4a_33 * omega1_3 - thetadot4_1 * T(0.96);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_3 = cosines[10];
  const T E4_12 = T(0.28) * t4_3;
  const T minus_E4_13 = T(0.96) * t4_3;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // R4^T = R4a^T E4^T: R takes inertial components to body components
  const T R4_11 = R4a_21 * E4_12 - R4a_11 * minus_E4_11 - R4a_31 * minus_E4_13;
  const T R4_12 = R4a_22 * E4_12 - R4a_12 * minus_E4_11 - R4a_32 * minus_E4_13;
  const T R4_13 = R4a_23 * E4_12 - R4a_13 * minus_E4_11 - R4a_33 * minus_E4_13;
  const T R4_21 = R4a_21 * T(0.96) + R4a_31 * T(0.28);
  const T R4_22 = R4a_22 * T(0.96) + R4a_32 * T(0.28);
  const T R4_23 = R4a_23 * T(0.96) + R4a_33 * T(0.28);
  const T R4_31 = R4a_11 * t4_3 + R4a_21 * E4_32 - R4a_31 * minus_E4_33;
  const T R4_32 = R4a_12 * t4_3 + R4a_22 * E4_32 - R4a_32 * minus_E4_33;
  const T R4_33 = R4a_13 * t4_3 + R4a_23 * E4_32 - R4a_33 * minus_E4_33;
  // omega4 = thetadot4_2 b4_2 + E4 omega4a: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega4a_2 - minus_E4_11 * omega4a_1 - minus_E4_13 * omega4a_3;
  const T omega4_2 = thetadot4_2 + T(0.96) * omega4a_2 + T(0.28) * omega4a_3;
  const T omega4_3 = t4_3 * omega4a_1 + E4_32 * omega4a_2 - minus_E4_33 * omega4a_3;
  // P_dot_omega1_4a = -R1^T omega1~ q4a~: its rate
  const T minus_P_dot_omega1_4a_13 = t2_16 + t2_13;
  const T minus_P_dot_omega1_4a_23 = t2_20 + t2_17;
  const T minus_P_dot_omega1_4a_33 = t2_24 + t2_21;
  // omega_omega1_4 = E4 E4a: partial angular velocity, body axes
  const T omega_omega1_4_11 = E4_12 * minus_E4a_12 - minus_E4_11 * E4a_11 - minus_E4_13 * minus_E4a_13;
  const T omega_omega1_4_12 = minus_E4_11 * minus_E4a_12 + E4_12 * E4a_22 - minus_E4_13 * E4a_23;
  const T omega_omega1_4_13 = minus_E4_11 * minus_E4a_13 + E4_12 * E4a_23 - minus_E4_13 * E4a_33;
  const T omega_omega1_4_21 = T(0.96) * minus_E4a_12 + T(0.28) * minus_E4a_13;
  const T omega_omega1_4_22 = T(0.96) * E4a_22 + T(0.28) * E4a_23;
  const T omega_omega1_4_23 = T(0.96) * E4a_23 + T(0.28) * E4a_33;
  const T omega_omega1_4_31 = t4_3 * E4a_11 + E4_32 * minus_E4a_12 - minus_E4_33 * minus_E4a_13;
  const T omega_omega1_4_32 = E4_32 * E4a_22 - t4_3 * minus_E4a_12 - minus_E4_33 * E4a_23;
  const T omega_omega1_4_33 = E4_32 * E4a_23 - t4_3 * minus_E4a_13 - minus_E4_33 * E4a_33;
  // omega_dot_omega1_4 = -(thetadot4_1 E4 b4_1~ + thetadot4_2 b4_2~ E4) E4a: its rate
  const T t4_4 = thetadot4_1 * (minus_E4_13 * T(0.28) - E4_12 * T(0.96)) + thetadot4_2 * t4_3;
  const T t4_5 = thetadot4_2 * E4_32 - thetadot4_1 * minus_E4_33;
  const T t4_6 = thetadot4_1 * E4_32 + thetadot4_2 * minus_E4_33;
  const T minus_omega_dot_omega1_4_11 = t4_4 * E4a_11 + t4_5 * minus_E4a_12 - t4_6 * minus_E4a_13;
  const T minus_omega_dot_omega1_4_12 = t4_5 * E4a_22 - t4_4 * minus_E4a_12 - t4_6 * E4a_23;
  const T minus_omega_dot_omega1_4_13 = t4_5 * E4a_23 - t4_4 * minus_E4a_13 - t4_6 * E4a_33;
  const T t4_7 = thetadot4_1 * T(1);
  const T omega_dot_omega1_4_21 = t4_7 * E4a_11;
  const T minus_omega_dot_omega1_4_22 = t4_7 * minus_E4a_12;
  const T minus_omega_dot_omega1_4_23 = t4_7 * minus_E4a_13;
  const T t4_8 = thetadot4_1 * (minus_E4_33 * T(0.28) - E4_32 * T(0.96)) + thetadot4_2 * minus_E4_11;
  const T t4_9 = thetadot4_1 * minus_E4_13 - thetadot4_2 * E4_12;
  const T t4_10 = thetadot4_1 * E4_12 + thetadot4_2 * minus_E4_13;
  const T minus_omega_dot_omega1_4_31 = t4_8 * E4a_11 + t4_9 * minus_E4a_12 + t4_10 * minus_E4a_13;
  const T minus_omega_dot_omega1_4_32 = t4_9 * E4a_22 - t4_8 * minus_E4a_12 + t4_10 * E4a_23;
  const T minus_omega_dot_omega1_4_33 = t4_9 * E4a_23 - t4_8 * minus_E4a_13 + t4_10 * E4a_33;
  // omega_thetadot4_1_4 = E4 b4_1: partial angular velocity, body axes
  const T omega_thetadot4_1_4_1 = E4_12 * T(0.28) + minus_E4_13 * T(0.96);
  const T omega_thetadot4_1_4_3 = E4_32 * T(0.28) + minus_E4_33 * T(0.96);
  // omega_dot_thetadot4_1_4 = -thetadot4_2 b4_2~ E4 b4_1: its rate
  const T minus_omega_dot_thetadot4_1_4_1 = thetadot4_2 * omega_thetadot4_1_4_3;
  const T omega_dot_thetadot4_1_4_3 = thetadot4_2 * omega_thetadot4_1_4_1;
  // B6_1 = -R4^T omega4~ r4~ omega_omega1_4 - R4^T r4~ omega_dot_omega1_4 + P_dot_omega1_4a
  const T t4_11 = T(0.03) * omega_omega1_4_21;
  const T t4_12 = T(0.1) * omega_omega1_4_11 - T(0.03) * omega_omega1_4_31;
  const T t4_13 = omega4_2 * t4_11 - omega4_3 * t4_12;
  const T t4_14 = T(0.1) * omega_omega1_4_21;
  const T t4_15 = omega4_3 * t4_14 + omega4_1 * t4_11;
  const T t4_16 = omega4_1 * t4_12 + omega4_2 * t4_14;
  const T t4_17 = T(0.03) * minus_omega_dot_omega1_4_31 - T(0.1) * minus_omega_dot_omega1_4_11;
  const T t4_18 = T(0.1) * omega_dot_omega1_4_21;
  const T t4_19 = T(0.03) * omega_dot_omega1_4_21;
  const T minus_B6_1_11 = R4_11 * t4_13 - t2_14 - R4_21 * t4_15 + R4_31 * t4_16 + R4_21 * t4_17 - R4_11 * t4_18 +
      R4_31 * t4_19;
  const T t4_20 = T(0.03) * omega_omega1_4_22;
  const T t4_21 = T(0.1) * omega_omega1_4_12 - T(0.03) * omega_omega1_4_32;
  const T t4_22 = omega4_2 * t4_20 - omega4_3 * t4_21;
  const T t4_23 = T(0.1) * omega_omega1_4_22;
  const T t4_24 = omega4_3 * t4_23 + omega4_1 * t4_20;
  const T t4_25 = omega4_1 * t4_21 + omega4_2 * t4_23;
  const T t4_26 = T(0.1) * minus_omega_dot_omega1_4_22;
  const T t4_27 = T(0.03) * minus_omega_dot_omega1_4_32 - T(0.1) * minus_omega_dot_omega1_4_12;
  const T t4_28 = T(0.03) * minus_omega_dot_omega1_4_22;
  const T minus_B6_1_12 = R4_11 * t4_22 - t2_15 - R4_21 * t4_24 + R4_31 * t4_25 + R4_11 * t4_26 + R4_21 * t4_27 -
      R4_31 * t4_28;
  const T t4_29 = T(0.03) * omega_omega1_4_23;
  const T t4_30 = T(0.1) * omega_omega1_4_13 - T(0.03) * omega_omega1_4_33;
  const T t4_31 = omega4_2 * t4_29 - omega4_3 * t4_30;
  const T t4_32 = T(0.1) * omega_omega1_4_23;
  const T t4_33 = omega4_3 * t4_32 + omega4_1 * t4_29;
  const T t4_34 = omega4_1 * t4_30 + omega4_2 * t4_32;
  const T t4_35 = T(0.1) * minus_omega_dot_omega1_4_23;
  const T t4_36 = T(0.03) * minus_omega_dot_omega1_4_33 - T(0.1) * minus_omega_dot_omega1_4_13;
  const T t4_37 = T(0.03) * minus_omega_dot_omega1_4_23;
  const T minus_B6_1_13 = minus_P_dot_omega1_4a_13 + R4_11 * t4_31 - R4_21 * t4_33 + R4_31 * t4_34 + R4_11 * t4_35 +
      R4_21 * t4_36 - R4_31 * t4_37;
  const T minus_B6_1_21 = R4_12 * t4_13 - t2_18 - R4_22 * t4_15 + R4_32 * t4_16 + R4_22 * t4_17 - R4_12 * t4_18 +
      R4_32 * t4_19;
  const T minus_B6_1_22 = R4_12 * t4_22 - t2_19 - R4_22 * t4_24 + R4_32 * t4_25 + R4_12 * t4_26 + R4_22 * t4_27 -
      R4_32 * t4_28;
  const T minus_B6_1_23 = minus_P_dot_omega1_4a_23 + R4_12 * t4_31 - R4_22 * t4_33 + R4_32 * t4_34 + R4_12 * t4_35 +
      R4_22 * t4_36 - R4_32 * t4_37;
  const T minus_B6_1_31 = R4_13 * t4_13 - t2_22 - R4_23 * t4_15 + R4_33 * t4_16 + R4_23 * t4_17 - R4_13 * t4_18 +
      R4_33 * t4_19;
  const T minus_B6_1_32 = R4_13 * t4_22 - t2_23 - R4_23 * t4_24 + R4_33 * t4_25 + R4_13 * t4_26 + R4_23 * t4_27 -
      R4_33 * t4_28;
  const T minus_B6_1_33 = minus_P_dot_omega1_4a_33 + R4_13 * t4_31 - R4_23 * t4_33 + R4_33 * t4_34 + R4_13 * t4_35 +
      R4_23 * t4_36 - R4_33 * t4_37;
  v_y_dot[261] = -minus_B6_1_11;
  v_y_dot[262] = -minus_B6_1_12;
  v_y_dot[263] = -minus_B6_1_13;
  v_y_dot[290] = -minus_B6_1_21;
  v_y_dot[291] = -minus_B6_1_22;
  v_y_dot[292] = -minus_B6_1_23;
  v_y_dot[319] = -minus_B6_1_31;
  v_y_dot[320] = -minus_B6_1_32;
  v_y_dot[321] = -minus_B6_1_33;
  // B7_4a = -R4^T omega4~ r4~ omega_thetadot4_1_4 - R4^T r4~ omega_dot_thetadot4_1_4
  const T t4_38 = T(0.1) * omega_thetadot4_1_4_1 - T(0.03) * omega_thetadot4_1_4_3;
  const T t4_39 = omega4_1 * t4_38;
  const T t4_40 = omega4_3 * t4_38;
  const T t4_41 = T(0.1) * minus_omega_dot_thetadot4_1_4_1 + T(0.03) * omega_dot_thetadot4_1_4_3;
  const T minus_B7_4a_1 = R4_31 * t4_39 - R4_11 * t4_40 - R4_21 * t4_41;
  const T minus_B7_4a_2 = R4_32 * t4_39 - R4_12 * t4_40 - R4_22 * t4_41;
  const T minus_B7_4a_3 = R4_33 * t4_39 - R4_13 * t4_40 - R4_23 * t4_41;
  v_y_dot[268] = -minus_B7_4a_1;
  v_y_dot[297] = -minus_B7_4a_2;
  v_y_dot[326] = -minus_B7_4a_3;
  // B8_4 = -R4^T omega4~ r4~ b4_2
  const T t4_42 = omega4_2 * T(0.03);
  const T t4_43 = omega4_3 * T(0.1) + omega4_1 * T(0.03);
  const T t4_44 = omega4_2 * T(0.1);
  const T minus_B8_4_1 = R4_11 * t4_42 - R4_21 * t4_43 + R4_31 * t4_44;
  const T minus_B8_4_2 = R4_12 * t4_42 - R4_22 * t4_43 + R4_32 * t4_44;
  const T minus_B8_4_3 = R4_13 * t4_42 - R4_23 * t4_43 + R4_33 * t4_44;
  v_y_dot[269] = -minus_B8_4_1;
  v_y_dot[298] = -minus_B8_4_2;
  v_y_dot[327] = -minus_B8_4_3;

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T theta5_2 = c.p.amplitude * sin(t5_1);
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // P_dot_omega1_5a = -R1^T omega1~ q5a~: its rate
  const T minus_P_dot_omega1_5a_11 = minus_P_dot_omega1_3_11 + t3_18;
  const T P_dot_omega1_5a_13 = t1_15 * T(0.3);
  const T minus_P_dot_omega1_5a_21 = minus_P_dot_omega1_3_21 + t3_19;
  const T P_dot_omega1_5a_23 = t1_18 * T(0.3);
  const T minus_P_dot_omega1_5a_31 = minus_P_dot_omega1_3_31 + t3_20;
  const T P_dot_omega1_5a_33 = t1_21 * T(0.3);
  // omega_omega1_5 = E5 E5a: partial angular velocity, body axes
  const T minus_omega_omega1_5_21 = E5_22 * E5a_12;
  const T omega_omega1_5_22 = E5_22 * E5a_11;
  const T omega_omega1_5_31 = E5_23 * E5a_12;
  const T minus_omega_omega1_5_32 = E5_23 * E5a_11;
  // omega_dot_omega1_5 = -(thetadot5_1 E5 b5_1~ + thetadot5_2 b5_2~ E5) E5a: its rate
  const T minus_omega_dot_omega1_5_11 = thetadot5_1 * E5a_12;
  const T omega_dot_omega1_5_12 = thetadot5_1 * E5a_11;
  const T t5_2 = thetadot5_1 * E5_22;
  const T t5_3 = thetadot5_2 * E5_23;
  const T minus_omega_dot_omega1_5_21 = t5_2 * E5a_11 - t5_3 * E5a_12;
  const T minus_omega_dot_omega1_5_22 = t5_2 * E5a_12 + t5_3 * E5a_11;
  const T omega_dot_omega1_5_23 = thetadot5_2 * E5_22;
  const T t5_4 = thetadot5_1 * E5_23;
  const T omega_dot_omega1_5_31 = t5_4 * E5a_11 + omega_dot_omega1_5_23 * E5a_12;
  const T minus_omega_dot_omega1_5_32 = omega_dot_omega1_5_23 * E5a_11 - t5_4 * E5a_12;
  // B9_1 = -R5^T omega5~ (C5^T r5)~ omega_omega1_5 - R5^T (C5^T r5)~ omega_dot_omega1_5 + P_dot_omega1_5a
  const T t5_5 = T(0.004991670832341408) * E5a_11 + T(0.049750208263901294) * omega_omega1_5_31;
  const T t5_6 = T(0.049750208263901294) * minus_omega_omega1_5_21;
  const T t5_7 = omega5_3 * t5_5 - omega5_2 * t5_6;
  const T t5_8 = T(0.004991670832341408) * minus_omega_omega1_5_21;
  const T t5_9 = omega5_1 * t5_6 - omega5_3 * t5_8;
  const T t5_10 = omega5_2 * t5_8 - omega5_1 * t5_5;
  const T t5_11 = T(0.004991670832341408) * minus_omega_dot_omega1_5_11 - T(0.049750208263901294) *
      omega_dot_omega1_5_31;
  const T t5_12 = T(0.004991670832341408) * minus_omega_dot_omega1_5_21;
  const T t5_13 = T(0.049750208263901294) * minus_omega_dot_omega1_5_21;
  const T minus_B9_1_11 = minus_P_dot_omega1_5a_11 + R5a_11 * t5_7 + R5_21 * t5_9 + R5_31 * t5_10 + R5_21 * t5_11 -
      R5a_11 * t5_12 - R5_31 * t5_13;
  const T t5_14 = T(0.049750208263901294) * omega_omega1_5_22;
  const T t5_15 = T(0.049750208263901294) * minus_omega_omega1_5_32 - T(0.004991670832341408) * E5a_12;
  const T t5_16 = omega5_2 * t5_14 - omega5_3 * t5_15;
  const T t5_17 = T(0.004991670832341408) * omega_omega1_5_22;
  const T t5_18 = omega5_3 * t5_17 - omega5_1 * t5_14;
  const T t5_19 = omega5_1 * t5_15 - omega5_2 * t5_17;
  const T t5_20 = T(0.049750208263901294) * minus_omega_dot_omega1_5_32 - T(0.004991670832341408) *
      omega_dot_omega1_5_12;
  const T t5_21 = T(0.004991670832341408) * minus_omega_dot_omega1_5_22;
  const T t5_22 = T(0.049750208263901294) * minus_omega_dot_omega1_5_22;
  const T minus_B9_1_12 = R5a_11 * t5_16 - t2_16 + R5_21 * t5_18 + R5_31 * t5_19 + R5_21 * t5_20 - R5a_11 * t5_21 -
      R5_31 * t5_22;
  const T t5_23 = T(0.049750208263901294) * E5_22;
  const T t5_24 = T(0.049750208263901294) * E5_23;
  const T t5_25 = omega5_3 * t5_23 + omega5_2 * t5_24;
  const T t5_26 = T(0.004991670832341408) * E5_23;
  const T t5_27 = omega5_3 * t5_26 - omega5_1 * t5_24;
  const T t5_28 = omega5_1 * t5_23 + omega5_2 * t5_26;
  const T t5_29 = T(0.004991670832341408) * omega_dot_omega1_5_23;
  const T t5_30 = T(0.049750208263901294) * t5_3;
  const T t5_31 = T(0.049750208263901294) * omega_dot_omega1_5_23;
  const T t5_32 = R5a_11 * t5_25 + R5_21 * t5_27 - R5_31 * t5_28 + R5a_11 * t5_29 + R5_21 * t5_30 + R5_31 * t5_31;
  const T minus_B9_1_13 = t5_32 - P_dot_omega1_5a_13;
  const T minus_B9_1_21 = minus_P_dot_omega1_5a_21 + R5a_12 * t5_7 + R5_22 * t5_9 + R5_32 * t5_10 + R5_22 * t5_11 -
      R5a_12 * t5_12 - R5_32 * t5_13;
  const T minus_B9_1_22 = R5a_12 * t5_16 - t2_20 + R5_22 * t5_18 + R5_32 * t5_19 + R5_22 * t5_20 - R5a_12 * t5_21 -
      R5_32 * t5_22;
  const T t5_33 = R5a_12 * t5_25 + R5_22 * t5_27 - R5_32 * t5_28 + R5a_12 * t5_29 + R5_22 * t5_30 + R5_32 * t5_31;
  const T minus_B9_1_23 = t5_33 - P_dot_omega1_5a_23;
  const T minus_B9_1_31 = minus_P_dot_omega1_5a_31 + R5a_13 * t5_7 + R5_23 * t5_9 + R5_33 * t5_10 + R5_23 * t5_11 -
      R5a_13 * t5_12 - R5_33 * t5_13;
  const T minus_B9_1_32 = R5a_13 * t5_16 - t2_24 + R5_23 * t5_18 + R5_33 * t5_19 + R5_23 * t5_20 - R5a_13 * t5_21 -
      R5_33 * t5_22;
  const T t5_34 = R5a_13 * t5_25 + R5_23 * t5_27 - R5_33 * t5_28 + R5a_13 * t5_29 + R5_23 * t5_30 + R5_33 * t5_31;
  const T minus_B9_1_33 = t5_34 - P_dot_omega1_5a_33;
  v_y_dot[348] = -minus_B9_1_11;
  v_y_dot[349] = -minus_B9_1_12;
  v_y_dot[350] = -minus_B9_1_13;
  v_y_dot[377] = -minus_B9_1_21;
  v_y_dot[378] = -minus_B9_1_22;
  v_y_dot[379] = -minus_B9_1_23;
  v_y_dot[406] = -minus_B9_1_31;
  v_y_dot[407] = -minus_B9_1_32;
  v_y_dot[408] = -minus_B9_1_33;
  v_y_dot[357] = -t5_32;
  v_y_dot[386] = -t5_33;
  v_y_dot[415] = -t5_34;
  // B25_1 = -R5^T omega5~ (C12^T r12)~ omega_omega1_5 - R5^T omega5~ o5~ omega_omega1_5 - R5^T (C12^T r12)~
  //   omega_dot_omega1_5 - R5^T o5~ omega_dot_omega1_5 + P_dot_omega1_5a
  const T t5_35 = T(0.03164906533384792) * minus_omega_omega1_5_21;
  const T t5_36 = T(0.03870835392384733) * E5a_11 + T(0.03164906533384792) * omega_omega1_5_31;
  const T t5_37 = omega5_2 * t5_35 - omega5_3 * t5_36;
  const T t5_38 = T(0.03870835392384733) * minus_omega_omega1_5_21;
  const T t5_39 = omega5_3 * t5_38 - omega5_1 * t5_35;
  const T t5_40 = omega5_1 * t5_36 - omega5_2 * t5_38;
  const T t5_41 = T(0.009983341664682815) * E5a_11 + T(0.09950041652780259) * omega_omega1_5_31;
  const T t5_42 = T(0.09950041652780259) * minus_omega_omega1_5_21;
  const T t5_43 = omega5_3 * t5_41 - omega5_2 * t5_42;
  const T t5_44 = T(0.009983341664682815) * minus_omega_omega1_5_21;
  const T t5_45 = omega5_1 * t5_42 - omega5_3 * t5_44;
  const T t5_46 = omega5_2 * t5_44 - omega5_1 * t5_41;
  const T t5_47 = T(0.03870835392384733) * minus_omega_dot_omega1_5_21;
  const T t5_48 = T(0.03164906533384792) * omega_dot_omega1_5_31 - T(0.03870835392384733) *
      minus_omega_dot_omega1_5_11;
  const T t5_49 = T(0.03164906533384792) * minus_omega_dot_omega1_5_21;
  const T t5_50 = T(0.009983341664682815) * minus_omega_dot_omega1_5_11 - T(0.09950041652780259) *
      omega_dot_omega1_5_31;
  const T t5_51 = T(0.009983341664682815) * minus_omega_dot_omega1_5_21;
  const T t5_52 = T(0.09950041652780259) * minus_omega_dot_omega1_5_21;
  const T minus_B25_1_11 = minus_P_dot_omega1_5a_11 + R5a_11 * t5_37 + R5_21 * t5_39 + R5_31 * t5_40 + R5a_11 * t5_43
      + R5_21 * t5_45 + R5_31 * t5_46 + R5a_11 * t5_47 + R5_21 * t5_48 + R5_31 * t5_49 + R5_21 * t5_50 - R5a_11 *
      t5_51 - R5_31 * t5_52;
  const T t5_53 = T(0.03164906533384792) * omega_omega1_5_22;
  const T t5_54 = T(0.03870835392384733) * omega_omega1_5_22;
  const T t5_55 = omega5_1 * t5_53 - omega5_3 * t5_54;
  const T t5_56 = T(0.03870835392384733) * E5a_12 - T(0.03164906533384792) * minus_omega_omega1_5_32;
  const T t5_57 = omega5_3 * t5_56 + omega5_2 * t5_53;
  const T t5_58 = omega5_1 * t5_56 + omega5_2 * t5_54;
  const T t5_59 = T(0.09950041652780259) * omega_omega1_5_22;
  const T t5_60 = T(0.09950041652780259) * minus_omega_omega1_5_32 - T(0.009983341664682815) * E5a_12;
  const T t5_61 = omega5_2 * t5_59 - omega5_3 * t5_60;
  const T t5_62 = T(0.009983341664682815) * omega_omega1_5_22;
  const T t5_63 = omega5_3 * t5_62 - omega5_1 * t5_59;
  const T t5_64 = omega5_1 * t5_60 - omega5_2 * t5_62;
  const T t5_65 = T(0.03870835392384733) * minus_omega_dot_omega1_5_22;
  const T t5_66 = T(0.03870835392384733) * omega_dot_omega1_5_12 - T(0.03164906533384792) *
      minus_omega_dot_omega1_5_32;
  const T t5_67 = T(0.03164906533384792) * minus_omega_dot_omega1_5_22;
  const T t5_68 = T(0.09950041652780259) * minus_omega_dot_omega1_5_32 - T(0.009983341664682815) *
      omega_dot_omega1_5_12;
  const T t5_69 = T(0.009983341664682815) * minus_omega_dot_omega1_5_22;
  const T t5_70 = T(0.09950041652780259) * minus_omega_dot_omega1_5_22;
  const T minus_B25_1_12 = R5_21 * t5_55 - t2_16 - R5a_11 * t5_57 + R5_31 * t5_58 + R5a_11 * t5_61 + R5_21 * t5_63 +
      R5_31 * t5_64 + R5a_11 * t5_65 + R5_21 * t5_66 + R5_31 * t5_67 + R5_21 * t5_68 - R5a_11 * t5_69 - R5_31 * t5_70;
  const T t5_71 = T(0.03164906533384792) * E5_23;
  const T t5_72 = T(0.03870835392384733) * E5_23;
  const T t5_73 = omega5_1 * t5_71 - omega5_3 * t5_72;
  const T t5_74 = T(0.03164906533384792) * E5_22;
  const T t5_75 = omega5_3 * t5_74 + omega5_2 * t5_71;
  const T t5_76 = omega5_1 * t5_74 + omega5_2 * t5_72;
  const T t5_77 = T(0.09950041652780259) * E5_22;
  const T t5_78 = T(0.09950041652780259) * E5_23;
  const T t5_79 = omega5_3 * t5_77 + omega5_2 * t5_78;
  const T t5_80 = T(0.009983341664682815) * E5_23;
  const T t5_81 = omega5_3 * t5_80 - omega5_1 * t5_78;
  const T t5_82 = omega5_1 * t5_77 + omega5_2 * t5_80;
  const T t5_83 = T(0.03870835392384733) * omega_dot_omega1_5_23;
  const T t5_84 = T(0.03164906533384792) * t5_3;
  const T t5_85 = T(0.03164906533384792) * omega_dot_omega1_5_23;
  const T t5_86 = T(0.009983341664682815) * omega_dot_omega1_5_23;
  const T t5_87 = T(0.09950041652780259) * t5_3;
  const T t5_88 = T(0.09950041652780259) * omega_dot_omega1_5_23;
  const T t5_89 = R5_21 * t5_73 - R5a_11 * t5_75 + R5_31 * t5_76 + R5a_11 * t5_79 + R5_21 * t5_81 - R5_31 * t5_82 -
      R5a_11 * t5_83 - R5_21 * t5_84 - R5_31 * t5_85 + R5a_11 * t5_86 + R5_21 * t5_87 + R5_31 * t5_88;
  const T minus_B25_1_13 = t5_89 - P_dot_omega1_5a_13;
  const T minus_B25_1_21 = minus_P_dot_omega1_5a_21 + R5a_12 * t5_37 + R5_22 * t5_39 + R5_32 * t5_40 + R5a_12 * t5_43
      + R5_22 * t5_45 + R5_32 * t5_46 + R5a_12 * t5_47 + R5_22 * t5_48 + R5_32 * t5_49 + R5_22 * t5_50 - R5a_12 *
      t5_51 - R5_32 * t5_52;
  const T minus_B25_1_22 = R5_22 * t5_55 - t2_20 - R5a_12 * t5_57 + R5_32 * t5_58 + R5a_12 * t5_61 + R5_22 * t5_63 +
      R5_32 * t5_64 + R5a_12 * t5_65 + R5_22 * t5_66 + R5_32 * t5_67 + R5_22 * t5_68 - R5a_12 * t5_69 - R5_32 * t5_70;
  const T t5_90 = R5_22 * t5_73 - R5a_12 * t5_75 + R5_32 * t5_76 + R5a_12 * t5_79 + R5_22 * t5_81 - R5_32 * t5_82 -
      R5a_12 * t5_83 - R5_22 * t5_84 - R5_32 * t5_85 + R5a_12 * t5_86 + R5_22 * t5_87 + R5_32 * t5_88;
  const T minus_B25_1_23 = t5_90 - P_dot_omega1_5a_23;
  const T minus_B25_1_31 = minus_P_dot_omega1_5a_31 + R5a_13 * t5_37 + R5_23 * t5_39 + R5_33 * t5_40 + R5a_13 * t5_43
      + R5_23 * t5_45 + R5_33 * t5_46 + R5a_13 * t5_47 + R5_23 * t5_48 + R5_33 * t5_49 + R5_23 * t5_50 - R5a_13 *
      t5_51 - R5_33 * t5_52;
  const T minus_B25_1_32 = R5_23 * t5_55 - t2_24 - R5a_13 * t5_57 + R5_33 * t5_58 + R5a_13 * t5_61 + R5_23 * t5_63 +
      R5_33 * t5_64 + R5a_13 * t5_65 + R5_23 * t5_66 + R5_33 * t5_67 + R5_23 * t5_68 - R5a_13 * t5_69 - R5_33 * t5_70;
  const T t5_91 = R5_23 * t5_73 - R5a_13 * t5_75 + R5_33 * t5_76 + R5a_13 * t5_79 + R5_23 * t5_81 - R5_33 * t5_82 -
      R5a_13 * t5_83 - R5_23 * t5_84 - R5_33 * t5_85 + R5a_13 * t5_86 + R5_23 * t5_87 + R5_33 * t5_88;
  const T minus_B25_1_33 = t5_91 - P_dot_omega1_5a_33;
  v_y_dot[957] = -minus_B25_1_11;
  v_y_dot[958] = -minus_B25_1_12;
  v_y_dot[959] = -minus_B25_1_13;
  v_y_dot[986] = -minus_B25_1_21;
  v_y_dot[987] = -minus_B25_1_22;
  v_y_dot[988] = -minus_B25_1_23;
  v_y_dot[1015] = -minus_B25_1_31;
  v_y_dot[1016] = -minus_B25_1_32;
  v_y_dot[1017] = -minus_B25_1_33;
  v_y_dot[966] = -t5_89;
  v_y_dot[995] = -t5_90;
  v_y_dot[1024] = -t5_91;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P_dot_omega1_6 = R3^T (thetadot3 d6~ b3~ - omega3~ d6~ - sdot6 u6~) E3 + P_dot_omega1_3: its rate
  const T t6_1 = d6_1 * T(0.44378789320576517) * thetadot3;
  const T t6_2 = omega3_1 * d6_1;
  const T t6_3 = t6_2 + d6_1 * T(0.3152711589176631) * thetadot3;
  const T t6_4 = t6_1 * E3_11 + t6_3 * E3_21 + sdot6 * E3_31;
  const T t6_5 = omega3_2 * d6_1;
  const T t6_6 = omega3_3 * d6_1;
  const T t6_7 = t6_5 * E3_21 + t6_6 * E3_31;
  const T t6_8 = d6_1 * T(0.8388422987658062) * thetadot3;
  const T t6_9 = t6_8 * E3_11 - sdot6 * E3_21 + t6_3 * E3_31;
  const T P_dot_omega1_6_11 = R3_21 * t6_4 - minus_P_dot_omega1_3_11 - R3_11 * t6_7 + R3_31 * t6_9;
  const T t6_10 = t6_1 * E3_12 + t6_3 * E3_22 + sdot6 * E3_32;
  const T t6_11 = t6_5 * E3_22 + t6_6 * E3_32;
  const T t6_12 = t6_8 * E3_12 - sdot6 * E3_22 + t6_3 * E3_32;
  const T P_dot_omega1_6_12 = R3_21 * t6_10 - minus_P_dot_omega1_3_12 - R3_11 * t6_11 + R3_31 * t6_12;
  const T t6_13 = t6_3 * E3_23 - t6_1 * minus_E3_13 + sdot6 * E3_33;
  const T t6_14 = t6_5 * E3_23 + t6_6 * E3_33;
  const T t6_15 = t6_3 * E3_33 - (t6_8 * minus_E3_13 + sdot6 * E3_23);
  const T P_dot_omega1_6_13 = P_dot_omega1_3_13 + R3_21 * t6_13 - R3_11 * t6_14 + R3_31 * t6_15;
  const T P_dot_omega1_6_21 = R3_22 * t6_4 - minus_P_dot_omega1_3_21 - R3_12 * t6_7 + R3_32 * t6_9;
  const T P_dot_omega1_6_22 = R3_22 * t6_10 - minus_P_dot_omega1_3_22 - R3_12 * t6_11 + R3_32 * t6_12;
  const T P_dot_omega1_6_23 = P_dot_omega1_3_23 + R3_22 * t6_13 - R3_12 * t6_14 + R3_32 * t6_15;
  const T P_dot_omega1_6_31 = R3_23 * t6_4 - minus_P_dot_omega1_3_31 - R3_13 * t6_7 + R3_33 * t6_9;
  const T P_dot_omega1_6_32 = R3_23 * t6_10 - minus_P_dot_omega1_3_32 - R3_13 * t6_11 + R3_33 * t6_12;
  const T P_dot_omega1_6_33 = P_dot_omega1_3_33 + R3_23 * t6_13 - R3_13 * t6_14 + R3_33 * t6_15;
  // P_dot_thetadot3_6 = -R3^T (omega3~ d6~ + sdot6 u6~) b3: its rate
  const T t6_16 = t6_5 * T(0.44378789320576517) + t6_6 * T(0.8388422987658062);
  const T t6_17 = t6_2 * T(0.44378789320576517) + sdot6 * T(0.8388422987658062);
  const T t6_18 = sdot6 * T(0.44378789320576517) - t6_2 * T(0.8388422987658062);
  const T minus_P_dot_thetadot3_6_1 = R3_11 * t6_16 - R3_21 * t6_17 + R3_31 * t6_18;
  const T minus_P_dot_thetadot3_6_2 = R3_12 * t6_16 - R3_22 * t6_17 + R3_32 * t6_18;
  const T minus_P_dot_thetadot3_6_3 = R3_13 * t6_16 - R3_23 * t6_17 + R3_33 * t6_18;
  // B11_1 = thetadot3 R3^T r6~ b3~ E3 - R3^T omega3~ r6~ E3 + P_dot_omega1_6
  const T t6_19 = T(0.01) * E3_21;
  const T t6_20 = T(0.1) * E3_21;
  const T t6_21 = omega3_3 * t6_19 + omega3_1 * t6_20;
  const T t6_22 = T(0.01) * E3_11 - T(0.1) * E3_31;
  const T t6_23 = omega3_2 * t6_20 - omega3_3 * t6_22;
  const T t6_24 = omega3_1 * t6_22 + omega3_2 * t6_19;
  const T t6_25 = T(0.01) * t3_31 + T(0.1) * t3_27;
  const T t6_26 = T(0.01) * t3_30;
  const T t6_27 = T(0.1) * t3_30;
  const T B11_1_11 = P_dot_omega1_6_11 + R3_21 * t6_21 - R3_11 * t6_23 - R3_31 * t6_24 + thetadot3 * (R3_21 * t6_25 -
      R3_11 * t6_26 + R3_31 * t6_27);
  const T t6_28 = T(0.01) * E3_22;
  const T t6_29 = T(0.1) * E3_22;
  const T t6_30 = omega3_3 * t6_28 + omega3_1 * t6_29;
  const T t6_31 = T(0.01) * E3_12 - T(0.1) * E3_32;
  const T t6_32 = omega3_2 * t6_29 - omega3_3 * t6_31;
  const T t6_33 = omega3_1 * t6_31 + omega3_2 * t6_28;
  const T t6_34 = T(0.01) * t3_43 + T(0.1) * t3_39;
  const T t6_35 = T(0.01) * t3_42;
  const T t6_36 = T(0.1) * t3_42;
  const T B11_1_12 = P_dot_omega1_6_12 + R3_21 * t6_30 - R3_11 * t6_32 - R3_31 * t6_33 + thetadot3 * (R3_21 * t6_34 -
      R3_11 * t6_35 + R3_31 * t6_36);
  const T t6_37 = T(0.01) * E3_23;
  const T t6_38 = T(0.1) * E3_23;
  const T t6_39 = omega3_3 * t6_37 + omega3_1 * t6_38;
  const T t6_40 = T(0.01) * minus_E3_13 + T(0.1) * E3_33;
  const T t6_41 = omega3_3 * t6_40 + omega3_2 * t6_38;
  const T t6_42 = omega3_2 * t6_37 - omega3_1 * t6_40;
  const T t6_43 = T(0.01) * t3_55 - T(0.1) * t3_51;
  const T t6_44 = T(0.01) * t3_54;
  const T t6_45 = T(0.1) * t3_54;
  const T B11_1_13 = P_dot_omega1_6_13 + R3_21 * t6_39 - R3_11 * t6_41 - R3_31 * t6_42 + thetadot3 * (R3_21 * t6_43 -
      R3_11 * t6_44 + R3_31 * t6_45);
  const T B11_1_21 = P_dot_omega1_6_21 + R3_22 * t6_21 - R3_12 * t6_23 - R3_32 * t6_24 + thetadot3 * (R3_22 * t6_25 -
      R3_12 * t6_26 + R3_32 * t6_27);
  const T B11_1_22 = P_dot_omega1_6_22 + R3_22 * t6_30 - R3_12 * t6_32 - R3_32 * t6_33 + thetadot3 * (R3_22 * t6_34 -
      R3_12 * t6_35 + R3_32 * t6_36);
  const T B11_1_23 = P_dot_omega1_6_23 + R3_22 * t6_39 - R3_12 * t6_41 - R3_32 * t6_42 + thetadot3 * (R3_22 * t6_43 -
      R3_12 * t6_44 + R3_32 * t6_45);
  const T B11_1_31 = P_dot_omega1_6_31 + R3_23 * t6_21 - R3_13 * t6_23 - R3_33 * t6_24 + thetadot3 * (R3_23 * t6_25 -
      R3_13 * t6_26 + R3_33 * t6_27);
  const T B11_1_32 = P_dot_omega1_6_32 + R3_23 * t6_30 - R3_13 * t6_32 - R3_33 * t6_33 + thetadot3 * (R3_23 * t6_34 -
      R3_13 * t6_35 + R3_33 * t6_36);
  const T B11_1_33 = P_dot_omega1_6_33 + R3_23 * t6_39 - R3_13 * t6_41 - R3_33 * t6_42 + thetadot3 * (R3_23 * t6_43 -
      R3_13 * t6_44 + R3_33 * t6_45);
  v_y_dot[435] = B11_1_11;
  v_y_dot[436] = B11_1_12;
  v_y_dot[437] = B11_1_13;
  v_y_dot[464] = B11_1_21;
  v_y_dot[465] = B11_1_22;
  v_y_dot[466] = B11_1_23;
  v_y_dot[493] = B11_1_31;
  v_y_dot[494] = B11_1_32;
  v_y_dot[495] = B11_1_33;
  // B12_3 = -R3^T omega3~ r6~ b3 + P_dot_thetadot3_6
  const T t6_46 = omega3_3 * T(0.08703694146575726) + omega3_2 * T(0.04437878932057652);
  const T t6_47 = omega3_3 * T(0.004437878932057652) + omega3_1 * T(0.04437878932057652);
  const T t6_48 = omega3_2 * T(0.004437878932057652) - omega3_1 * T(0.08703694146575726);
  const T minus_B12_3_1 = minus_P_dot_thetadot3_6_1 + R3_11 * t6_46 - R3_21 * t6_47 + R3_31 * t6_48;
  const T minus_B12_3_2 = minus_P_dot_thetadot3_6_2 + R3_12 * t6_46 - R3_22 * t6_47 + R3_32 * t6_48;
  const T minus_B12_3_3 = minus_P_dot_thetadot3_6_3 + R3_13 * t6_46 - R3_23 * t6_47 + R3_33 * t6_48;
  v_y_dot[441] = -minus_B12_3_1;
  v_y_dot[470] = -minus_B12_3_2;
  v_y_dot[499] = -minus_B12_3_3;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  const T thetadot8 = y[10];
  const T sdot8 = y[22];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // R8^T = R1^T E8^T: R takes inertial components to body components
  const T R8_11 = R1_11 * E8_11 + R1_31 * E8_13;
  const T R8_12 = R1_12 * E8_11 + R1_32 * E8_13;
  const T R8_13 = R1_13 * E8_11 + R1_33 * E8_13;
  const T R8_31 = R1_31 * E8_11 - R1_11 * E8_13;
  const T R8_32 = R1_32 * E8_11 - R1_12 * E8_13;
  const T R8_33 = R1_33 * E8_11 - R1_13 * E8_13;
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega1_1 + E8_13 * omega1_3;
  const T omega8_2 = omega1_2 - thetadot8;
  const T omega8_3 = E8_11 * omega1_3 - E8_13 * omega1_1;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // P_dot_omega1_8 = -R1^T (omega1~ d8~ + sdot8 u8~): its rate
  const T t8_1 = omega1_1 * d8_2;
  const T t8_2 = omega1_2 * d8_2;
  const T minus_P_dot_omega1_8_11 = R1_21 * t8_1 - R1_11 * t8_2 + R1_31 * sdot8;
  const T t8_3 = omega1_3 * d8_2;
  const T minus_P_dot_omega1_8_13 = R1_21 * t8_3 - R1_11 * sdot8 - R1_31 * t8_2;
  const T minus_P_dot_omega1_8_21 = R1_22 * t8_1 - R1_12 * t8_2 + R1_32 * sdot8;
  const T minus_P_dot_omega1_8_23 = R1_22 * t8_3 - R1_12 * sdot8 - R1_32 * t8_2;
  const T minus_P_dot_omega1_8_31 = R1_23 * t8_1 - R1_13 * t8_2 + R1_33 * sdot8;
  const T minus_P_dot_omega1_8_33 = R1_23 * t8_3 - R1_13 * sdot8 - R1_33 * t8_2;
  // B14_1 = thetadot8 R8^T (C8^T r8)~ b8~ E8 - R8^T omega8~ (C8^T r8)~ E8 + P_dot_omega1_8
  const T t8_4 = T(0.02) * E8_13 + T(0.01) * E8_11;
  const T t8_5 = T(0.1) * E8_11;
  const T t8_6 = T(0.1) * E8_13;
  const T t8_7 = omega8_2 * t8_5;
  const T t8_8 = T(0.02) * E8_11 - T(0.01) * E8_13;
  const T t8_9 = t8_7 - omega8_3 * t8_8;
  const T t8_10 = omega8_3 * t8_6 - omega8_1 * t8_5;
  const T t8_11 = omega8_2 * t8_6;
  const T t8_12 = omega8_1 * t8_8 - t8_11;
  const T B14_1_11 = thetadot8 * (R1_21 * t8_4 - R8_11 * t8_5 + R8_31 * t8_6) - (minus_P_dot_omega1_8_11 + R8_11 *
      t8_9 + R1_21 * t8_10 + R8_31 * t8_12);
  const T t8_13 = omega8_1 * T(0.01) - omega8_3 * T(0.02);
  const T t8_14 = omega8_2 * T(0.01);
  const T t8_15 = omega8_2 * T(0.02);
  const T minus_B14_1_12 = R1_21 * t8_13 - R8_11 * t8_14 + R8_31 * t8_15;
  const T t8_16 = t8_11 - omega8_3 * t8_4;
  const T t8_17 = omega8_3 * t8_5 + omega8_1 * t8_6;
  const T t8_18 = t8_7 + omega8_1 * t8_4;
  const T minus_B14_1_13 = minus_P_dot_omega1_8_13 + thetadot8 * (R8_11 * t8_6 + R1_21 * t8_8 + R8_31 * t8_5) + R8_11
      * t8_16 - R1_21 * t8_17 + R8_31 * t8_18;
  const T B14_1_21 = thetadot8 * (R1_22 * t8_4 - R8_12 * t8_5 + R8_32 * t8_6) - (minus_P_dot_omega1_8_21 + R8_12 *
      t8_9 + R1_22 * t8_10 + R8_32 * t8_12);
  const T minus_B14_1_22 = R1_22 * t8_13 - R8_12 * t8_14 + R8_32 * t8_15;
  const T minus_B14_1_23 = minus_P_dot_omega1_8_23 + thetadot8 * (R8_12 * t8_6 + R1_22 * t8_8 + R8_32 * t8_5) + R8_12
      * t8_16 - R1_22 * t8_17 + R8_32 * t8_18;
  const T B14_1_31 = thetadot8 * (R1_23 * t8_4 - R8_13 * t8_5 + R8_33 * t8_6) - (minus_P_dot_omega1_8_31 + R8_13 *
      t8_9 + R1_23 * t8_10 + R8_33 * t8_12);
  const T minus_B14_1_32 = R1_23 * t8_13 - R8_13 * t8_14 + R8_33 * t8_15;
  const T minus_B14_1_33 = minus_P_dot_omega1_8_33 + thetadot8 * (R8_13 * t8_6 + R1_23 * t8_8 + R8_33 * t8_5) + R8_13
      * t8_16 - R1_23 * t8_17 + R8_33 * t8_18;
  v_y_dot[609] = B14_1_11;
  v_y_dot[610] = -minus_B14_1_12;
  v_y_dot[619] = minus_B14_1_12;
  v_y_dot[611] = -minus_B14_1_13;
  v_y_dot[638] = B14_1_21;
  v_y_dot[639] = -minus_B14_1_22;
  v_y_dot[648] = minus_B14_1_22;
  v_y_dot[640] = -minus_B14_1_23;
  v_y_dot[667] = B14_1_31;
  v_y_dot[668] = -minus_B14_1_32;
  v_y_dot[677] = minus_B14_1_32;
  v_y_dot[669] = -minus_B14_1_33;

  // ---- body 9 (sled) on the inertial frame
  const T thetadot9 = y[11];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // B17_9 = -E9^T omega9~ r9~ b9
  const T t9_1 = thetadot9 * T(0.1);
  const T minus_B17_9_1 = E9_11 * t9_1;
  const T minus_B17_9_2 = E9_12 * t9_1;
  v_y_dot[707] = -minus_B17_9_1;
  v_y_dot[736] = -minus_B17_9_2;

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  const T omega10_1 = y[12], omega10_2 = y[13], omega10_3 = y[14];
  const T sdot10 = y[25];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // P_dot_omega1_10 = -R1^T (omega1~ d10~ + sdot10 u10~): its rate
  const T t10_13 = omega1_1 * s10;
  const T t10_14 = omega1_3 * T(0.3);
  const T t10_15 = omega1_2 * s10;
  const T t10_16 = t10_14 + t10_15;
  const T t10_17 = omega1_1 * T(0.3) - sdot10;
  const T minus_P_dot_omega1_10_11 = R1_21 * t10_13 - R1_11 * t10_16 + R1_31 * t10_17;
  const T t10_18 = omega1_2 * T(0.1);
  const T t10_19 = omega1_1 * T(0.1);
  const T t10_20 = t10_14 + t10_19;
  const T t10_21 = omega1_2 * T(0.3);
  const T minus_P_dot_omega1_10_12 = R1_11 * t10_18 - R1_21 * t10_20 + R1_31 * t10_21;
  const T t10_22 = sdot10 + omega1_3 * T(0.1);
  const T t10_23 = omega1_3 * s10;
  const T t10_24 = t10_15 + t10_19;
  const T minus_P_dot_omega1_10_13 = R1_11 * t10_22 + R1_21 * t10_23 - R1_31 * t10_24;
  const T minus_P_dot_omega1_10_21 = R1_22 * t10_13 - R1_12 * t10_16 + R1_32 * t10_17;
  const T minus_P_dot_omega1_10_22 = R1_12 * t10_18 - R1_22 * t10_20 + R1_32 * t10_21;
  const T minus_P_dot_omega1_10_23 = R1_12 * t10_22 + R1_22 * t10_23 - R1_32 * t10_24;
  const T minus_P_dot_omega1_10_31 = R1_23 * t10_13 - R1_13 * t10_16 + R1_33 * t10_17;
  const T minus_P_dot_omega1_10_32 = R1_13 * t10_18 - R1_23 * t10_20 + R1_33 * t10_21;
  const T minus_P_dot_omega1_10_33 = R1_13 * t10_22 + R1_23 * t10_23 - R1_33 * t10_24;
  v_y_dot[783] = -minus_P_dot_omega1_10_11;
  v_y_dot[784] = -minus_P_dot_omega1_10_12;
  v_y_dot[785] = -minus_P_dot_omega1_10_13;
  v_y_dot[812] = -minus_P_dot_omega1_10_21;
  v_y_dot[813] = -minus_P_dot_omega1_10_22;
  v_y_dot[814] = -minus_P_dot_omega1_10_23;
  v_y_dot[841] = -minus_P_dot_omega1_10_31;
  v_y_dot[842] = -minus_P_dot_omega1_10_32;
  v_y_dot[843] = -minus_P_dot_omega1_10_33;
  // B19_10 = -R10^T omega10~ r10~
  const T t10_25 = R10_31 * omega10_1 - R10_11 * omega10_3;
  const T t10_26 = R10_11 * omega10_2 - R10_21 * omega10_1;
  const T B19_10_11 = t10_25 * T(0.03) + t10_26 * T(0.01);
  const T t10_27 = R10_21 * omega10_3 - R10_31 * omega10_2;
  const T minus_B19_10_12 = t10_27 * T(0.03) + t10_26 * T(0.02);
  const T minus_B19_10_13 = t10_27 * T(0.01) - t10_25 * T(0.02);
  const T t10_28 = R10_32 * omega10_1 - R10_12 * omega10_3;
  const T t10_29 = R10_12 * omega10_2 - R10_22 * omega10_1;
  const T B19_10_21 = t10_28 * T(0.03) + t10_29 * T(0.01);
  const T t10_30 = R10_22 * omega10_3 - R10_32 * omega10_2;
  const T minus_B19_10_22 = t10_30 * T(0.03) + t10_29 * T(0.02);
  const T minus_B19_10_23 = t10_30 * T(0.01) - t10_28 * T(0.02);
  const T t10_31 = R10_33 * omega10_1 - R10_13 * omega10_3;
  const T t10_32 = R10_13 * omega10_2 - R10_23 * omega10_1;
  const T B19_10_31 = t10_31 * T(0.03) + t10_32 * T(0.01);
  const T t10_33 = R10_23 * omega10_3 - R10_33 * omega10_2;
  const T minus_B19_10_32 = t10_33 * T(0.03) + t10_32 * T(0.02);
  const T minus_B19_10_33 = t10_33 * T(0.01) - t10_31 * T(0.02);
  v_y_dot[795] = B19_10_11;
  v_y_dot[796] = -minus_B19_10_12;
  v_y_dot[797] = -minus_B19_10_13;
  v_y_dot[824] = B19_10_21;
  v_y_dot[825] = -minus_B19_10_22;
  v_y_dot[826] = -minus_B19_10_23;
  v_y_dot[853] = B19_10_31;
  v_y_dot[854] = -minus_B19_10_32;
  v_y_dot[855] = -minus_B19_10_33;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  const T thetadot11 = y[15];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // R11^T = R8^T E11^T: R takes inertial components to body components
  const T R11_11 = R8_11 * E11_11 + R8_31 * E11_13;
  const T R11_12 = R8_12 * E11_11 + R8_32 * E11_13;
  const T R11_13 = R8_13 * E11_11 + R8_33 * E11_13;
  const T R11_31 = R8_31 * E11_11 - R8_11 * E11_13;
  const T R11_32 = R8_32 * E11_11 - R8_12 * E11_13;
  const T R11_33 = R8_33 * E11_11 - R8_13 * E11_13;
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega8_1 + E11_13 * omega8_3;
  const T omega11_2 = omega8_2 - thetadot11;
  const T omega11_3 = E11_11 * omega8_3 - E11_13 * omega8_1;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // omega_omega1_11 = E11 E8: partial angular velocity, body axes
  const T omega_omega1_11_11 = E11_11 * E8_11 - E11_13 * E8_13;
  const T omega_omega1_11_13 = E11_13 * E8_11 + E11_11 * E8_13;
  // omega_dot_omega1_11 = -(thetadot8 E11 b8~ + thetadot11 b11~ E11) E8: its rate
  const T t11_1 = thetadot8 * E11_13 + thetadot11 * E11_13;
  const T t11_2 = thetadot8 * E11_11 + thetadot11 * E11_11;
  const T minus_omega_dot_omega1_11_11 = t11_1 * E8_11 + t11_2 * E8_13;
  const T minus_omega_dot_omega1_11_13 = t11_1 * E8_13 - t11_2 * E8_11;
  // P_dot_omega1_11 = R8^T (thetadot8 d11~ b8~ - omega8~ d11~ - thetadot11 pitch11 u11~) E8 + P_dot_omega1_8: its
  //   rate
  const T t11_3 = omega8_1 * minus_d11_2;
  const T t11_4 = omega8_3 * minus_d11_2;
  const T t11_5 = t11_3 * E8_11 - t11_4 * E8_13;
  const T t11_6 = thetadot8 * minus_d11_2 + omega8_2 * minus_d11_2;
  const T t11_7 = thetadot11 * T(0.01);
  const T t11_8 = t11_6 * E8_11 + t11_7 * E8_13;
  const T t11_9 = t11_7 * E8_11 - t11_6 * E8_13;
  const T P_dot_omega1_11_11 = R1_21 * t11_5 - minus_P_dot_omega1_8_11 - R8_11 * t11_8 - R8_31 * t11_9;
  const T t11_10 = t11_3 * E8_13 + t11_4 * E8_11;
  const T P_dot_omega1_11_13 = R8_11 * t11_9 - minus_P_dot_omega1_8_13 + R1_21 * t11_10 - R8_31 * t11_8;
  const T P_dot_omega1_11_21 = R1_22 * t11_5 - minus_P_dot_omega1_8_21 - R8_12 * t11_8 - R8_32 * t11_9;
  const T P_dot_omega1_11_23 = R8_12 * t11_9 - minus_P_dot_omega1_8_23 + R1_22 * t11_10 - R8_32 * t11_8;
  const T P_dot_omega1_11_31 = R1_23 * t11_5 - minus_P_dot_omega1_8_31 - R8_13 * t11_8 - R8_33 * t11_9;
  const T P_dot_omega1_11_33 = R8_13 * t11_9 - minus_P_dot_omega1_8_33 + R1_23 * t11_10 - R8_33 * t11_8;
  // B21_1 = -R11^T omega11~ (C11^T r11)~ omega_omega1_11 - R11^T (C11^T r11)~ omega_dot_omega1_11 + P_dot_omega1_11
  const T t11_11 = T(0.01) * omega_omega1_11_11;
  const T t11_12 = omega11_3 * t11_11;
  const T t11_13 = omega11_1 * t11_11;
  const T t11_14 = T(0.01) * minus_omega_dot_omega1_11_11;
  const T B21_1_11 = P_dot_omega1_11_11 + R11_11 * t11_12 - R11_31 * t11_13 + R1_21 * t11_14;
  const T t11_15 = omega11_2 * T(0.01);
  const T t11_16 = omega11_3 * T(0.01);
  const T minus_B21_1_12 = R11_31 * t11_15 - R1_21 * t11_16;
  const T t11_17 = T(0.01) * omega_omega1_11_13;
  const T t11_18 = omega11_3 * t11_17;
  const T t11_19 = omega11_1 * t11_17;
  const T t11_20 = T(0.01) * minus_omega_dot_omega1_11_13;
  const T B21_1_13 = P_dot_omega1_11_13 + R11_11 * t11_18 - R11_31 * t11_19 + R1_21 * t11_20;
  const T B21_1_21 = P_dot_omega1_11_21 + R11_12 * t11_12 - R11_32 * t11_13 + R1_22 * t11_14;
  const T minus_B21_1_22 = R11_32 * t11_15 - R1_22 * t11_16;
  const T B21_1_23 = P_dot_omega1_11_23 + R11_12 * t11_18 - R11_32 * t11_19 + R1_22 * t11_20;
  const T B21_1_31 = P_dot_omega1_11_31 + R11_13 * t11_12 - R11_33 * t11_13 + R1_23 * t11_14;
  const T minus_B21_1_32 = R11_33 * t11_15 - R1_23 * t11_16;
  const T B21_1_33 = P_dot_omega1_11_33 + R11_13 * t11_18 - R11_33 * t11_19 + R1_23 * t11_20;
  v_y_dot[870] = B21_1_11;
  v_y_dot[871] = -minus_B21_1_12;
  v_y_dot[880] = minus_B21_1_12;
  v_y_dot[872] = B21_1_13;
  v_y_dot[899] = B21_1_21;
  v_y_dot[900] = -minus_B21_1_22;
  v_y_dot[909] = minus_B21_1_22;
  v_y_dot[901] = B21_1_23;
  v_y_dot[928] = B21_1_31;
  v_y_dot[929] = -minus_B21_1_32;
  v_y_dot[938] = minus_B21_1_32;
  v_y_dot[930] = B21_1_33;
  // B23_11 = -R11^T omega11~ (C11^T r11)~ b11 + pitch11 R8^T omega8~ u11
  const T B23_11_1 = minus_B21_1_12 + T(0.01) * (R8_11 * omega8_3 - R8_31 * omega8_1);
  const T B23_11_2 = minus_B21_1_22 + T(0.01) * (R8_12 * omega8_3 - R8_32 * omega8_1);
  const T B23_11_3 = minus_B21_1_32 + T(0.01) * (R8_13 * omega8_3 - R8_33 * omega8_1);
  v_y_dot[885] = B23_11_1;
  v_y_dot[914] = B23_11_2;
  v_y_dot[943] = B23_11_3;
}

// partial_angular_velocities: partial angular velocities omega_y, body axes: omega = omega_y y.
// omega_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 61 add, 104 multiply, 15 sine or cosine
template <class T>
void partial_angular_velocities(const Prepared<T>& c, T t, const T* x, T* omega_y) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 1131; ++i) omega_y[i] = T(0);
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 5, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 3 (boom) on body 1
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  omega_y[174] = E3_11;
  omega_y[435] = E3_11;
  omega_y[175] = E3_12;
  omega_y[436] = E3_12;
  omega_y[176] = -minus_E3_13;
  omega_y[437] = -minus_E3_13;
  omega_y[203] = E3_21;
  omega_y[464] = E3_21;
  omega_y[204] = E3_22;
  omega_y[465] = E3_22;
  omega_y[205] = E3_23;
  omega_y[466] = E3_23;
  omega_y[232] = E3_31;
  omega_y[493] = E3_31;
  omega_y[233] = E3_32;
  omega_y[494] = E3_32;
  omega_y[234] = E3_33;
  omega_y[495] = E3_33;

  // ---- body 4 (cross) on body 1
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_3 = cosines[10];
  const T E4_12 = T(0.28) * t4_3;
  const T minus_E4_13 = T(0.96) * t4_3;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // omega_omega1_4 = E4 E4a: partial angular velocity, body axes
  const T omega_omega1_4_11 = E4_12 * minus_E4a_12 - minus_E4_11 * E4a_11 - minus_E4_13 * minus_E4a_13;
  const T omega_omega1_4_12 = minus_E4_11 * minus_E4a_12 + E4_12 * E4a_22 - minus_E4_13 * E4a_23;
  const T omega_omega1_4_13 = minus_E4_11 * minus_E4a_13 + E4_12 * E4a_23 - minus_E4_13 * E4a_33;
  const T omega_omega1_4_21 = T(0.96) * minus_E4a_12 + T(0.28) * minus_E4a_13;
  const T omega_omega1_4_22 = T(0.96) * E4a_22 + T(0.28) * E4a_23;
  const T omega_omega1_4_23 = T(0.96) * E4a_23 + T(0.28) * E4a_33;
  const T omega_omega1_4_31 = t4_3 * E4a_11 + E4_32 * minus_E4a_12 - minus_E4_33 * minus_E4a_13;
  const T omega_omega1_4_32 = E4_32 * E4a_22 - t4_3 * minus_E4a_12 - minus_E4_33 * E4a_23;
  const T omega_omega1_4_33 = E4_32 * E4a_23 - t4_3 * minus_E4a_13 - minus_E4_33 * E4a_33;
  omega_y[261] = omega_omega1_4_11;
  omega_y[262] = omega_omega1_4_12;
  omega_y[263] = omega_omega1_4_13;
  omega_y[290] = omega_omega1_4_21;
  omega_y[291] = omega_omega1_4_22;
  omega_y[292] = omega_omega1_4_23;
  omega_y[319] = omega_omega1_4_31;
  omega_y[320] = omega_omega1_4_32;
  omega_y[321] = omega_omega1_4_33;
  // omega_thetadot4_1_4 = E4 b4_1: partial angular velocity, body axes
  const T omega_thetadot4_1_4_1 = E4_12 * T(0.28) + minus_E4_13 * T(0.96);
  const T omega_thetadot4_1_4_3 = E4_32 * T(0.28) + minus_E4_33 * T(0.96);
  omega_y[268] = omega_thetadot4_1_4_1;
  omega_y[326] = omega_thetadot4_1_4_3;

  // ---- body 5 (camera) on body 1
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // theta5_2 = expression 1: prescribed
  const T theta5_2 = c.p.amplitude * sin(T(3) * t);
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  omega_y[379] = E5_23;
  omega_y[386] = E5_23;
  omega_y[959] = E5_23;
  omega_y[966] = E5_23;
  // omega_omega1_5 = E5 E5a: partial angular velocity, body axes
  const T minus_omega_omega1_5_21 = E5_22 * E5a_12;
  const T omega_omega1_5_22 = E5_22 * E5a_11;
  const T omega_omega1_5_31 = E5_23 * E5a_12;
  const T minus_omega_omega1_5_32 = E5_23 * E5a_11;
  omega_y[377] = -minus_omega_omega1_5_21;
  omega_y[957] = -minus_omega_omega1_5_21;
  omega_y[378] = omega_omega1_5_22;
  omega_y[958] = omega_omega1_5_22;
  // B7_1 = C5 omega_omega1_5
  const T B7_1_11 = T(0.9950041652780258) * E5a_11 - T(0.09983341664682815) * omega_omega1_5_31;
  const T B7_1_12 = T(0.9950041652780258) * E5a_12 + T(0.09983341664682815) * minus_omega_omega1_5_32;
  const T minus_B7_1_13 = T(0.09983341664682815) * E5_22;
  const T B7_1_31 = T(0.09983341664682815) * E5a_11 + T(0.9950041652780258) * omega_omega1_5_31;
  const T B7_1_32 = T(0.09983341664682815) * E5a_12 - T(0.9950041652780258) * minus_omega_omega1_5_32;
  const T B7_1_33 = T(0.9950041652780258) * E5_22;
  omega_y[348] = B7_1_11;
  omega_y[349] = B7_1_12;
  omega_y[350] = -minus_B7_1_13;
  omega_y[357] = -minus_B7_1_13;
  omega_y[406] = B7_1_31;
  omega_y[407] = B7_1_32;
  omega_y[408] = B7_1_33;
  omega_y[415] = B7_1_33;
  // B15_1 = C12 omega_omega1_5
  const T B15_1_21 = T(0.7741670784769465) * omega_omega1_5_31 - T(0.6329813066769583) * E5a_11;
  const T minus_B15_1_22 = T(0.6329813066769583) * E5a_12 + T(0.7741670784769465) * minus_omega_omega1_5_32;
  const T B15_1_23 = T(0.7741670784769465) * E5_22;
  const T B15_1_31 = T(0.7741670784769465) * E5a_11 + T(0.6329813066769583) * omega_omega1_5_31;
  const T B15_1_32 = T(0.7741670784769465) * E5a_12 - T(0.6329813066769583) * minus_omega_omega1_5_32;
  const T B15_1_33 = T(0.6329813066769583) * E5_22;
  omega_y[986] = B15_1_21;
  omega_y[987] = -minus_B15_1_22;
  omega_y[988] = B15_1_23;
  omega_y[995] = B15_1_23;
  omega_y[1015] = B15_1_31;
  omega_y[1016] = B15_1_32;
  omega_y[1017] = B15_1_33;
  omega_y[1024] = B15_1_33;

  // ---- body 8 (piston) on body 1
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  omega_y[611] = E8_11;
  omega_y[638] = -E8_11;
  omega_y[609] = -E8_13;
  omega_y[640] = -E8_13;

  // ---- body 11 (nut) on body 8
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // omega_omega1_11 = E11 E8: partial angular velocity, body axes
  const T omega_omega1_11_11 = E11_11 * E8_11 - E11_13 * E8_13;
  const T omega_omega1_11_13 = E11_13 * E8_11 + E11_11 * E8_13;
  omega_y[872] = omega_omega1_11_11;
  omega_y[899] = -omega_omega1_11_11;
  omega_y[870] = -omega_omega1_11_13;
  omega_y[901] = -omega_omega1_11_13;

  // ---- results
  omega_y[0] = T(1);
  omega_y[30] = T(1);
  omega_y[60] = T(1);
  omega_y[90] = T(1);
  omega_y[120] = T(1);
  omega_y[150] = T(1);
  omega_y[298] = T(1);
  omega_y[668] = -T(1);
  omega_y[677] = T(1);
  omega_y[765] = T(1);
  omega_y[795] = T(1);
  omega_y[825] = T(1);
  omega_y[855] = T(1);
  omega_y[929] = -T(1);
  omega_y[938] = T(1);
  omega_y[943] = T(1);
  omega_y[180] = -T(0.3152711589176631);
  omega_y[441] = -T(0.3152711589176631);
  omega_y[209] = T(0.44378789320576517);
  omega_y[470] = T(0.44378789320576517);
  omega_y[238] = T(0.8388422987658062);
  omega_y[499] = T(0.8388422987658062);
}

// partial_angular_velocity_rates: time derivatives of the partial angular velocities, body axes.
// omega_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 81 add, 165 multiply, 16 sine or cosine
template <class T>
void partial_angular_velocity_rates(const Prepared<T>& c, T t, const T* x, const T* y, T* omega_y_dot) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 1131; ++i) omega_y_dot[i] = T(0);
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 5, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 3 (boom) on body 1
  const T thetadot3 = y[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // B1_1 = -thetadot3 b3~ E3
  const T minus_B1_1_11 = thetadot3 * (T(0.44378789320576517) * E3_31 - T(0.8388422987658062) * E3_21);
  const T minus_B1_1_12 = thetadot3 * (T(0.44378789320576517) * E3_32 - T(0.8388422987658062) * E3_22);
  const T minus_B1_1_13 = thetadot3 * (T(0.44378789320576517) * E3_33 - T(0.8388422987658062) * E3_23);
  const T minus_B1_1_21 = thetadot3 * (T(0.8388422987658062) * E3_11 + T(0.3152711589176631) * E3_31);
  const T minus_B1_1_22 = thetadot3 * (T(0.8388422987658062) * E3_12 + T(0.3152711589176631) * E3_32);
  const T minus_B1_1_23 = thetadot3 * (T(0.3152711589176631) * E3_33 - T(0.8388422987658062) * minus_E3_13);
  const T B1_1_31 = thetadot3 * (T(0.3152711589176631) * E3_21 + T(0.44378789320576517) * E3_11);
  const T B1_1_32 = thetadot3 * (T(0.3152711589176631) * E3_22 + T(0.44378789320576517) * E3_12);
  const T minus_B1_1_33 = thetadot3 * (T(0.44378789320576517) * minus_E3_13 - T(0.3152711589176631) * E3_23);
  omega_y_dot[174] = -minus_B1_1_11;
  omega_y_dot[435] = -minus_B1_1_11;
  omega_y_dot[175] = -minus_B1_1_12;
  omega_y_dot[436] = -minus_B1_1_12;
  omega_y_dot[176] = -minus_B1_1_13;
  omega_y_dot[437] = -minus_B1_1_13;
  omega_y_dot[203] = -minus_B1_1_21;
  omega_y_dot[464] = -minus_B1_1_21;
  omega_y_dot[204] = -minus_B1_1_22;
  omega_y_dot[465] = -minus_B1_1_22;
  omega_y_dot[205] = -minus_B1_1_23;
  omega_y_dot[466] = -minus_B1_1_23;
  omega_y_dot[232] = B1_1_31;
  omega_y_dot[493] = B1_1_31;
  omega_y_dot[233] = B1_1_32;
  omega_y_dot[494] = B1_1_32;
  omega_y_dot[234] = -minus_B1_1_33;
  omega_y_dot[495] = -minus_B1_1_33;

  // ---- body 4 (cross) on body 1
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_3 = cosines[10];
  const T E4_12 = T(0.28) * t4_3;
  const T minus_E4_13 = T(0.96) * t4_3;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // omega_dot_omega1_4 = -(thetadot4_1 E4 b4_1~ + thetadot4_2 b4_2~ E4) E4a: its rate
  const T t4_4 = thetadot4_1 * (minus_E4_13 * T(0.28) - E4_12 * T(0.96)) + thetadot4_2 * t4_3;
  const T t4_5 = thetadot4_2 * E4_32 - thetadot4_1 * minus_E4_33;
  const T t4_6 = thetadot4_1 * E4_32 + thetadot4_2 * minus_E4_33;
  const T minus_omega_dot_omega1_4_11 = t4_4 * E4a_11 + t4_5 * minus_E4a_12 - t4_6 * minus_E4a_13;
  const T minus_omega_dot_omega1_4_12 = t4_5 * E4a_22 - t4_4 * minus_E4a_12 - t4_6 * E4a_23;
  const T minus_omega_dot_omega1_4_13 = t4_5 * E4a_23 - t4_4 * minus_E4a_13 - t4_6 * E4a_33;
  const T t4_7 = thetadot4_1 * T(1);
  const T omega_dot_omega1_4_21 = t4_7 * E4a_11;
  const T minus_omega_dot_omega1_4_22 = t4_7 * minus_E4a_12;
  const T minus_omega_dot_omega1_4_23 = t4_7 * minus_E4a_13;
  const T t4_8 = thetadot4_1 * (minus_E4_33 * T(0.28) - E4_32 * T(0.96)) + thetadot4_2 * minus_E4_11;
  const T t4_9 = thetadot4_1 * minus_E4_13 - thetadot4_2 * E4_12;
  const T t4_10 = thetadot4_1 * E4_12 + thetadot4_2 * minus_E4_13;
  const T minus_omega_dot_omega1_4_31 = t4_8 * E4a_11 + t4_9 * minus_E4a_12 + t4_10 * minus_E4a_13;
  const T minus_omega_dot_omega1_4_32 = t4_9 * E4a_22 - t4_8 * minus_E4a_12 + t4_10 * E4a_23;
  const T minus_omega_dot_omega1_4_33 = t4_9 * E4a_23 - t4_8 * minus_E4a_13 + t4_10 * E4a_33;
  omega_y_dot[261] = -minus_omega_dot_omega1_4_11;
  omega_y_dot[262] = -minus_omega_dot_omega1_4_12;
  omega_y_dot[263] = -minus_omega_dot_omega1_4_13;
  omega_y_dot[290] = omega_dot_omega1_4_21;
  omega_y_dot[291] = -minus_omega_dot_omega1_4_22;
  omega_y_dot[292] = -minus_omega_dot_omega1_4_23;
  omega_y_dot[319] = -minus_omega_dot_omega1_4_31;
  omega_y_dot[320] = -minus_omega_dot_omega1_4_32;
  omega_y_dot[321] = -minus_omega_dot_omega1_4_33;
  // omega_dot_thetadot4_1_4 = -thetadot4_2 b4_2~ E4 b4_1: its rate
  const T minus_omega_dot_thetadot4_1_4_1 = thetadot4_2 * (E4_32 * T(0.28) + minus_E4_33 * T(0.96));
  const T omega_dot_thetadot4_1_4_3 = thetadot4_2 * (E4_12 * T(0.28) + minus_E4_13 * T(0.96));
  omega_y_dot[268] = -minus_omega_dot_thetadot4_1_4_1;
  omega_y_dot[326] = omega_dot_thetadot4_1_4_3;

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T theta5_2 = c.p.amplitude * sin(t5_1);
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // omega_dot_omega1_5 = -(thetadot5_1 E5 b5_1~ + thetadot5_2 b5_2~ E5) E5a: its rate
  const T minus_omega_dot_omega1_5_11 = thetadot5_1 * E5a_12;
  const T omega_dot_omega1_5_12 = thetadot5_1 * E5a_11;
  const T t5_2 = thetadot5_1 * E5_22;
  const T t5_3 = thetadot5_2 * E5_23;
  const T minus_omega_dot_omega1_5_21 = t5_2 * E5a_11 - t5_3 * E5a_12;
  const T minus_omega_dot_omega1_5_22 = t5_2 * E5a_12 + t5_3 * E5a_11;
  const T omega_dot_omega1_5_23 = thetadot5_2 * E5_22;
  const T t5_4 = thetadot5_1 * E5_23;
  const T omega_dot_omega1_5_31 = t5_4 * E5a_11 + omega_dot_omega1_5_23 * E5a_12;
  const T minus_omega_dot_omega1_5_32 = omega_dot_omega1_5_23 * E5a_11 - t5_4 * E5a_12;
  omega_y_dot[377] = -minus_omega_dot_omega1_5_21;
  omega_y_dot[957] = -minus_omega_dot_omega1_5_21;
  omega_y_dot[378] = -minus_omega_dot_omega1_5_22;
  omega_y_dot[958] = -minus_omega_dot_omega1_5_22;
  omega_y_dot[379] = omega_dot_omega1_5_23;
  omega_y_dot[386] = omega_dot_omega1_5_23;
  omega_y_dot[959] = omega_dot_omega1_5_23;
  omega_y_dot[966] = omega_dot_omega1_5_23;
  // B4_1 = C5 omega_dot_omega1_5
  const T minus_B4_1_11 = T(0.9950041652780258) * minus_omega_dot_omega1_5_11 + T(0.09983341664682815) *
      omega_dot_omega1_5_31;
  const T B4_1_12 = T(0.9950041652780258) * omega_dot_omega1_5_12 + T(0.09983341664682815) *
      minus_omega_dot_omega1_5_32;
  const T B4_1_13 = T(0.09983341664682815) * t5_3;
  const T minus_B4_1_31 = T(0.09983341664682815) * minus_omega_dot_omega1_5_11 - T(0.9950041652780258) *
      omega_dot_omega1_5_31;
  const T minus_B4_1_32 = T(0.9950041652780258) * minus_omega_dot_omega1_5_32 - T(0.09983341664682815) *
      omega_dot_omega1_5_12;
  const T minus_B4_1_33 = T(0.9950041652780258) * t5_3;
  omega_y_dot[348] = -minus_B4_1_11;
  omega_y_dot[349] = B4_1_12;
  omega_y_dot[350] = B4_1_13;
  omega_y_dot[357] = B4_1_13;
  omega_y_dot[406] = -minus_B4_1_31;
  omega_y_dot[407] = -minus_B4_1_32;
  omega_y_dot[408] = -minus_B4_1_33;
  omega_y_dot[415] = -minus_B4_1_33;
  // B9_1 = C12 omega_dot_omega1_5
  const T B9_1_21 = T(0.6329813066769583) * minus_omega_dot_omega1_5_11 + T(0.7741670784769465) *
      omega_dot_omega1_5_31;
  const T minus_B9_1_22 = T(0.6329813066769583) * omega_dot_omega1_5_12 + T(0.7741670784769465) *
      minus_omega_dot_omega1_5_32;
  const T minus_B9_1_23 = T(0.7741670784769465) * t5_3;
  const T minus_B9_1_31 = T(0.7741670784769465) * minus_omega_dot_omega1_5_11 - T(0.6329813066769583) *
      omega_dot_omega1_5_31;
  const T minus_B9_1_32 = T(0.6329813066769583) * minus_omega_dot_omega1_5_32 - T(0.7741670784769465) *
      omega_dot_omega1_5_12;
  const T minus_B9_1_33 = T(0.6329813066769583) * t5_3;
  omega_y_dot[986] = B9_1_21;
  omega_y_dot[987] = -minus_B9_1_22;
  omega_y_dot[988] = -minus_B9_1_23;
  omega_y_dot[995] = -minus_B9_1_23;
  omega_y_dot[1015] = -minus_B9_1_31;
  omega_y_dot[1016] = -minus_B9_1_32;
  omega_y_dot[1017] = -minus_B9_1_33;
  omega_y_dot[1024] = -minus_B9_1_33;

  // ---- body 8 (piston) on body 1
  const T thetadot8 = y[10];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // B6_1 = -thetadot8 C8 b8~ E8
  const T minus_B6_1_11 = thetadot8 * E8_11;
  const T minus_B6_1_13 = thetadot8 * E8_13;
  omega_y_dot[609] = -minus_B6_1_11;
  omega_y_dot[640] = -minus_B6_1_11;
  omega_y_dot[611] = -minus_B6_1_13;
  omega_y_dot[638] = minus_B6_1_13;

  // ---- body 11 (nut) on body 8
  const T thetadot11 = y[15];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // omega_dot_omega1_11 = -(thetadot8 E11 b8~ + thetadot11 b11~ E11) E8: its rate
  const T t11_1 = thetadot8 * E11_13 + thetadot11 * E11_13;
  const T t11_2 = thetadot8 * E11_11 + thetadot11 * E11_11;
  const T minus_omega_dot_omega1_11_11 = t11_1 * E8_11 + t11_2 * E8_13;
  const T minus_omega_dot_omega1_11_13 = t11_1 * E8_13 - t11_2 * E8_11;
  omega_y_dot[872] = -minus_omega_dot_omega1_11_11;
  omega_y_dot[899] = minus_omega_dot_omega1_11_11;
  omega_y_dot[870] = minus_omega_dot_omega1_11_13;
  omega_y_dot[901] = minus_omega_dot_omega1_11_13;
}

// load_powers: power of each load [W].
// one a load (8) [W]
// 271 add, 343 multiply, 2 divide, 1 square root, 11 sine or cosine, 3 other function
template <class T>
void load_powers(const Prepared<T>& c, T t, const T* x, const T* y, const Inputs<T>& u, T* power) noexcept {
  using std::abs, std::cos, std::exp, std::sin, std::sqrt, std::tanh;
  T cosines[14], sines[14];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 1, cosines + 8, sines + 8);
  cos_sin(x + 11, 1, cosines + 11, sines + 11);
  cos_sin(x + 13, 1, cosines + 13, sines + 13);

  // ---- body 1 (hull) on the inertial frame
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

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * T(0.2) + R1_21 * T(0.1) - R1_31 * T(0.2);
  const T P2_2 = s1_2 + R1_12 * T(0.2) + R1_22 * T(0.1) - R1_32 * T(0.2);
  const T P2_3 = s1_3 + R1_13 * T(0.2) + R1_23 * T(0.1) - R1_33 * T(0.2);
  // Pdot2 = sdot1 + R1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T t2_13 = omega1_3 * T(0.2) + omega1_1 * T(0.2);
  const T t2_14 = omega1_2 * T(0.2);
  const T t2_15 = omega1_3 * T(0.1) + t2_14;
  const T t2_16 = omega1_1 * T(0.1);
  const T t2_17 = t2_16 - t2_14;
  const T Pdot2_1 = sdot1_1 + R1_21 * t2_13 - R1_11 * t2_15 + R1_31 * t2_17;
  const T Pdot2_2 = sdot1_2 + R1_22 * t2_13 - R1_12 * t2_15 + R1_32 * t2_17;
  const T Pdot2_3 = sdot1_3 + R1_23 * t2_13 - R1_13 * t2_15 + R1_33 * t2_17;

  // ---- body 3 (boom) on body 1
  const T theta3 = x[8];
  const T thetadot3 = y[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  const T R3_31 = R1_11 * E3_31 + R1_21 * E3_32 + R1_31 * E3_33;
  const T R3_32 = R1_12 * E3_31 + R1_22 * E3_32 + R1_32 * E3_33;
  const T R3_33 = R1_13 * E3_31 + R1_23 * E3_32 + R1_33 * E3_33;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T omega3_2 = thetadot3 * T(0.44378789320576517) + E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_3 = thetadot3 * T(0.8388422987658062) + E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_18 = s1_1 + R1_31 * T(0.1);
  const T P3_1 = t3_18 + R1_11 * T(0.3);
  const T t3_19 = s1_2 + R1_32 * T(0.1);
  const T P3_2 = t3_19 + R1_12 * T(0.3);
  const T t3_20 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_20 + R1_13 * T(0.3);
  // Pdot3 = sdot1 + R1^T omega1~ q3: velocity of the body origin, inertial axes [m/s]
  const T t3_21 = omega1_2 * T(0.1);
  const T t3_22 = omega1_3 * T(0.3);
  const T t3_23 = t3_22 - t2_16;
  const T t3_24 = omega1_2 * T(0.3);
  const T Pdot3_1 = sdot1_1 + R1_11 * t3_21 + R1_21 * t3_23 - R1_31 * t3_24;
  const T Pdot3_2 = sdot1_2 + R1_12 * t3_21 + R1_22 * t3_23 - R1_32 * t3_24;
  const T Pdot3_3 = sdot1_3 + R1_13 * t3_21 + R1_23 * t3_23 - R1_33 * t3_24;
  // stretch_boom_3 = theta3 - l_boom_: stretch of the spring
  const T stretch_boom_3 = theta3 - T(0.2);
  // effort_boom_3 = -thetadot3 c_boom_ - k_boom_ stretch_boom_3 + tau_boom_: along the coordinate [N m], [N]
  const T effort_boom_3 = u.motor - T(0.1) * tanh(thetadot3 * T(100)) - thetadot3 * T(0.5) - c.p.k * stretch_boom_3;

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T theta5_2 = c.p.amplitude * sin(t5_1);
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = t3_18 - R1_21 * T(0.3);
  const T P5a_2 = t3_19 - R1_22 * T(0.3);
  const T P5a_3 = t3_20 - R1_23 * T(0.3);
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_2 = t3_22 + t3_21;
  const T t5_3 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_2 - R1_21 * t2_16 - R1_31 * t5_3;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_2 - R1_22 * t2_16 - R1_32 * t5_3;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_2 - R1_23 * t2_16 - R1_33 * t5_3;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_1 = P3_1 + R3_11 * d6_1;
  const T P6_2 = P3_2 + R3_12 * d6_1;
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // Pdot6 = R3^T (omega3~ d6 + sdot6 u6) + Pdot3: velocity of the body origin, inertial axes [m/s]
  const T t6_1 = omega3_3 * d6_1;
  const T t6_2 = omega3_2 * d6_1;
  const T Pdot6_1 = Pdot3_1 + R3_11 * sdot6 + R3_21 * t6_1 - R3_31 * t6_2;
  const T Pdot6_2 = Pdot3_2 + R3_12 * sdot6 + R3_22 * t6_1 - R3_32 * t6_2;
  const T Pdot6_3 = Pdot3_3 + R3_13 * sdot6 + R3_23 * t6_1 - R3_33 * t6_2;
  // effort_telescope_6 = -sdot6 c_telescope_: along the coordinate [N m], [N]
  const T minus_effort_telescope_6 = sdot6 * (T(2) + abs(sdot6));
  // arm2 = R2 R3^T r_jet_ - R2 P2 + R2 P6
  const T t6_3 = R3_11 * T(0.2);
  const T t6_4 = R3_12 * T(0.2);
  const T t6_5 = R3_13 * T(0.2);
  const T arm2_1 = R2_11 * t6_3 + R2_12 * t6_4 + R2_13 * t6_5 - R2_11 * P2_1 - R2_12 * P2_2 - R2_13 * P2_3 + R2_11 *
      P6_1 + R2_12 * P6_2 + R2_13 * P6_3;
  const T arm2_2 = R2_21 * t6_3 + R2_22 * t6_4 + R2_23 * t6_5 - R2_21 * P2_1 - R2_22 * P2_2 - R2_23 * P2_3 + R2_21 *
      P6_1 + R2_22 * P6_2 + R2_23 * P6_3;
  const T arm2_3 = R2_31 * t6_3 + R2_32 * t6_4 + R2_33 * t6_5 - R2_31 * P2_1 - R2_32 * P2_2 - R2_33 * P2_3 + R2_31 *
      P6_1 + R2_32 * P6_2 + R2_33 * P6_3;

  // ---- body 8 (piston) on body 1
  const T thetadot8 = y[10];
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_2 = omega1_2 - thetadot8;

  // ---- body 9 (sled) on the inertial frame
  const T s9_1 = x[26], s9_2 = x[27];
  const T thetadot9 = y[11];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // line_tether_9 = -R5^T C12^T r_tether_ - R5^T o5 + E9^T r_tether_other_ - P5a + d9: from one end of the spring to
  //   the other, inertial axes [m]
  const T line_tether_9_1 = s9_1 - P5a_1 + E9_11 * T(0.1) - R5_21 * T(0.02) - T(0.03620228586010676) * R5a_11 -
      T(0.06743336618301184) * R5_31;
  const T line_tether_9_2 = d9_2 - P5a_2 + E9_12 * T(0.1) - R5_22 * T(0.02) - T(0.03620228586010676) * R5a_12 -
      T(0.06743336618301184) * R5_32;
  const T line_tether_9_3 = T(0.1) - P5a_3 - R5_23 * T(0.02) - T(0.03620228586010676) * R5a_13 -
      T(0.06743336618301184) * R5_33;
  // ll_tether_9 = 1e-36 + line_tether_9 . line_tether_9: length squared [m^2]
  const T ll_tether_9 = T(1e-36) + line_tether_9_1 * line_tether_9_1 + line_tether_9_2 * line_tether_9_2 +
      line_tether_9_3 * line_tether_9_3;
  // length_tether_9 = ll_tether_9^1/2: length [m]
  const T length_tether_9 = sqrt(ll_tether_9);
  // line_rate_tether_9 = -R5^T omega5~ C12^T r_tether_ - R5^T omega5~ o5 + E9^T omega9~ r_tether_other_ - Pdot5a +
  //   Pdot9: its rate [m/s]
  const T t9_1 = thetadot9 * T(0.1);
  const T t9_2 = omega5_2 * T(0.07741670784769467) - omega5_3 * T(0.02);
  const T t9_3 = omega5_3 * T(0.06329813066769584) + omega5_1 * T(0.07741670784769467);
  const T t9_4 = omega5_1 * T(0.02) + omega5_2 * T(0.06329813066769584);
  const T t9_5 = omega5_3 * T(0.09950041652780259) + omega5_1 * T(0.009983341664682815);
  const T t9_6 = omega5_2 * T(0.009983341664682815);
  const T t9_7 = omega5_2 * T(0.09950041652780259);
  const T line_rate_tether_9_1 = sdot9_1 - Pdot5a_1 - E9_12 * t9_1 - R5a_11 * t9_2 + R5_21 * t9_3 - R5_31 * t9_4 -
      R5_21 * t9_5 + R5a_11 * t9_6 + R5_31 * t9_7;
  const T line_rate_tether_9_2 = sdot9_2 - Pdot5a_2 + R5_22 * t9_3 - R5a_12 * t9_2 - R5_32 * t9_4 - R5_22 * t9_5 +
      R5a_12 * t9_6 + R5_32 * t9_7 + E9_11 * t9_1;
  const T minus_line_rate_tether_9_3 = Pdot5a_3 + R5a_13 * t9_2 - R5_23 * t9_3 + R5_33 * t9_4 + R5_23 * t9_5 - R5a_13
      * t9_6 - R5_33 * t9_7;
  // f_tether_9 = k_tether_ - k_tether_ length_tether_9^-1 l_tether_ + line_tether_9 . line_rate_tether_9
  //   ll_tether_9^-1 c_tether_: attraction by the length [N/m]
  const T t9_8 = line_tether_9_1 * line_rate_tether_9_1 + line_tether_9_2 * line_rate_tether_9_2 - line_tether_9_3 *
      minus_line_rate_tether_9_3;
  const T f_tether_9 = c.p.k - T(1) / length_tether_9 * c.p.k * T(0.3) + T(1) / ll_tether_9 * t9_8 * T(0.4);

  // ---- body 11 (nut) on body 8
  const T thetadot11 = y[15];
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_2 = omega8_2 - thetadot11;
  // effort_nut_11 = -thetadot11 c_nut_: along the coordinate [N m], [N]
  const T minus_effort_nut_11 = thetadot11 * T(0.002);

  // ---- whole system
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // W1_ = F1 . (sdot1 + R1^T omega1~ r1) + M1 . omega1
  const T W1 = u.thrust * (sdot1_3 + R1_13 * (T(0.01) * omega1_3 + T(0.03) * omega1_2) + R1_23 * (omega1_3 * T(0.02) -
      omega1_1 * T(0.03)) - R1_33 * (T(0.01) * omega1_1 + T(0.02) * omega1_2)) + t2_16 + T(0.2) * cos(T(2) * t) *
      omega1_2;
  power[0] = W1;
  // W2_ = thetadot3 effort_boom_3
  const T W2 = thetadot3 * effort_boom_3;
  power[1] = W2;
  // W3_ = sdot6 effort_telescope_6
  const T minus_W3 = sdot6 * minus_effort_telescope_6;
  power[2] = -minus_W3;
  // W4_ = thetadot11 effort_nut_11
  const T minus_W4 = thetadot11 * minus_effort_nut_11;
  power[3] = -minus_W4;
  // W5_ = -line_tether_9 . line_rate_tether_9 f_tether_9
  const T minus_W5 = t9_8 * f_tether_9;
  power[4] = -minus_W5;
  // W6_ = -R3^T F_jet_ . (R2^T omega2~ arm2 + Pdot2) + (R3^T F_jet_) . (R3^T omega3~ r_jet_ + Pdot6)
  const T b0_1 = T(0.5) * u.thrust * exp(T(0) - t);
  const T b0_2 = R3_11 * T(0.1) + R3_21 * b0_1;
  const T b0_3 = omega3_3 * T(0.2);
  const T b0_4 = omega3_2 * T(0.2);
  const T b0_5 = omega2_2 * arm2_3 - omega2_3 * arm2_2;
  const T b0_6 = omega2_3 * arm2_1 - omega2_1 * arm2_3;
  const T b0_7 = omega2_1 * arm2_2 - omega2_2 * arm2_1;
  const T b0_8 = R3_12 * T(0.1) + R3_22 * b0_1;
  const T b0_9 = R3_13 * T(0.1) + R3_23 * b0_1;
  const T W6 = b0_2 * (Pdot6_1 + R3_21 * b0_3 - R3_31 * b0_4) - (b0_2 * (Pdot2_1 + R2_11 * b0_5 + R2_21 * b0_6 + R2_31
      * b0_7) + b0_8 * (Pdot2_2 + R2_12 * b0_5 + R2_22 * b0_6 + R2_32 * b0_7) + b0_9 * (Pdot2_3 + R2_13 * b0_5 + R2_23
      * b0_6 + R2_33 * b0_7)) + b0_8 * (Pdot6_2 + R3_22 * b0_3 - R3_32 * b0_4) + b0_9 * (Pdot6_3 + R3_23 * b0_3 -
      R3_33 * b0_4);
  power[5] = W6;
  // W7_ = (C11^T M_coupling_) . omega11
  const T minus_W7 = T(0.02) * u.motor * omega11_2;
  power[6] = -minus_W7;

  // ---- results
  power[7] = T(0);
}

// driving_loads: what must act along locked and prescribed coordinates besides the joint's loads.
// one a coordinate (6) [N m], [N]
// 193 add, 246 multiply, 2 divide, 1 square root, 8 sine or cosine
template <class T>
void driving_loads(const Prepared<T>& c, T t, const T* x, const T* y, const T* ydot, [[maybe_unused]] const Inputs<T>&
    u, T* drive) noexcept {
  using std::cos, std::sin, std::sqrt;
  T cosines[14], sines[14];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 11, 1, cosines + 11, sines + 11);
  cos_sin(x + 13, 1, cosines + 13, sines + 13);

  // ---- body 1 (hull) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[16], sddot1_2 = ydot[17], sddot1_3 = ydot[18];
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
  const T U1_13 = omegadot1_2 + omega1_3 * omega1_1;
  const T t1_13 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + omega1_3 * omega1_3;
  const T t1_14 = omega1_3 * omega1_2;
  const T U1_23 = t1_14 - omegadot1_1;
  const T U1_32 = t1_14 + omegadot1_1;
  const T minus_U1_33 = t1_13 + omega1_2 * omega1_2;
  // Pddot1 = R1 (-g + sddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t1_15 = sddot1_3 + T(9.81);
  const T Pddot1_1 = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * t1_15;
  const T Pddot1_2 = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * t1_15;
  const T Pddot1_3 = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * t1_15;

  // ---- body 5 (camera) on body 1
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  const T thetadot5_1 = y[9];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  const T thetaddot5_1 = ydot[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T t5_2 = sin(t5_1);
  const T theta5_2 = c.p.amplitude * t5_2;
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // thetaddot5_2 = d^2/dt^2 expression 1: prescribed
  const T minus_thetaddot5_2 = t5_2 * T(3) * T(3) * c.p.amplitude;
  // E5b^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5b_22 = cos(theta5_2);
  const T E5b_23 = sin(theta5_2);
  // R5b^T = R5a^T E5b^T: R takes inertial components to body components
  const T R5b_21 = R5a_21 * E5b_22 + R1_31 * E5b_23;
  const T R5b_22 = R5a_22 * E5b_22 + R1_32 * E5b_23;
  const T R5b_23 = R5a_23 * E5b_22 + R1_33 * E5b_23;
  const T R5b_31 = R1_31 * E5b_22 - R5a_21 * E5b_23;
  const T R5b_32 = R1_32 * E5b_22 - R5a_22 * E5b_23;
  const T R5b_33 = R1_33 * E5b_22 - R5a_23 * E5b_23;
  // omega5b = thetadot5_2 b5_2 + E5b omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5b_1 = omega5a_1 + thetadot5_2;
  const T omega5b_2 = E5b_22 * omega5a_2 + E5b_23 * omega5a_3;
  const T omega5b_3 = E5b_22 * omega5a_3 - E5b_23 * omega5a_2;
  // R5^T = R5b^T E5^T: R takes inertial components to body components
  const T R5_11 = R5a_11 * c.E5_11 - R5b_31 * c.E5_31;
  const T R5_12 = R5a_12 * c.E5_11 - R5b_32 * c.E5_31;
  const T R5_13 = R5a_13 * c.E5_11 - R5b_33 * c.E5_31;
  const T R5_31 = R5a_11 * c.E5_31 + R5b_31 * c.E5_11;
  const T R5_32 = R5a_12 * c.E5_31 + R5b_32 * c.E5_11;
  const T R5_33 = R5a_13 * c.E5_31 + R5b_33 * c.E5_11;
  // omega5 = E5 omega5b: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = c.E5_11 * omega5b_1 - c.E5_31 * omega5b_3;
  const T omega5_3 = c.E5_31 * omega5b_1 + c.E5_11 * omega5b_3;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = s1_1 + R1_31 * T(0.1) - R1_21 * T(0.3);
  const T P5a_2 = s1_2 + R1_32 * T(0.1) - R1_22 * T(0.3);
  const T P5a_3 = s1_3 + R1_33 * T(0.1) - R1_23 * T(0.3);
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_3 = omega1_3 * T(0.3) + omega1_2 * T(0.1);
  const T t5_4 = omega1_1 * T(0.1);
  const T t5_5 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_3 - R1_21 * t5_4 - R1_31 * t5_5;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_3 - R1_22 * t5_4 - R1_32 * t5_5;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_3 - R1_23 * t5_4 - R1_33 * t5_5;
  // omegadot5a = -thetadot5_1 b5_1~ E5a omega1 + thetaddot5_1 b5_1 + E5a omegadot1: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5a_1 = thetadot5_1 * omega5a_2 + E5a_11 * omegadot1_1 + E5a_12 * omegadot1_2;
  const T omegadot5a_2 = E5a_11 * omegadot1_2 - E5a_12 * omegadot1_1 - thetadot5_1 * omega5a_1;
  const T omegadot5a_3 = thetaddot5_1 + omegadot1_3;
  // Pddot5a = E5a (U1 q5a + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_6 = Pddot1_1 + U1_13 * T(0.1) - U1_12 * T(0.3);
  const T t5_7 = Pddot1_2 + minus_U1_22 * T(0.3) + U1_23 * T(0.1);
  const T Pddot5a_1 = E5a_11 * t5_6 + E5a_12 * t5_7;
  const T Pddot5a_2 = E5a_11 * t5_7 - E5a_12 * t5_6;
  const T Pddot5a_3 = Pddot1_3 - U1_32 * T(0.3) - minus_U1_33 * T(0.1);
  // omegadot5b = -thetadot5_2 b5_2~ E5b omega5a + thetaddot5_2 b5_2 + E5b omegadot5a: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5b_1 = omegadot5a_1 - minus_thetaddot5_2;
  const T omegadot5b_2 = thetadot5_2 * omega5b_3 + E5b_22 * omegadot5a_2 + E5b_23 * omegadot5a_3;
  const T omegadot5b_3 = E5b_22 * omegadot5a_3 - E5b_23 * omegadot5a_2 - thetadot5_2 * omega5b_2;
  // Pddot5b = E5b Pddot5a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5b_2 = E5b_22 * Pddot5a_2 + E5b_23 * Pddot5a_3;
  const T Pddot5b_3 = E5b_22 * Pddot5a_3 - E5b_23 * Pddot5a_2;
  // omegadot5 = E5 omegadot5b: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = c.E5_11 * omegadot5b_1 - c.E5_31 * omegadot5b_3;
  const T omegadot5_3 = c.E5_31 * omegadot5b_1 + c.E5_11 * omegadot5b_3;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_8 = omega5b_2 * omega5b_2;
  const T minus_U5_11 = t5_8 + omega5_3 * omega5_3;
  const T t5_9 = omega5b_2 * omega5_1;
  const T U5_12 = t5_9 - omegadot5_3;
  const T t5_10 = omega5_3 * omega5_1;
  const T U5_13 = t5_10 + omegadot5b_2;
  const T U5_21 = t5_9 + omegadot5_3;
  const T t5_11 = omega5_3 * omega5b_2;
  const T U5_23 = t5_11 - omegadot5_1;
  const T U5_31 = t5_10 - omegadot5b_2;
  const T U5_32 = t5_11 + omegadot5_1;
  const T minus_U5_33 = t5_8 + omega5_1 * omega5_1;
  // Pddot5 = E5 Pddot5b: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_1 = c.E5_11 * Pddot5a_1 - c.E5_31 * Pddot5b_3;
  const T Pddot5_3 = c.E5_31 * Pddot5a_1 + c.E5_11 * Pddot5b_3;
  // a5 = U5 r5 + Pddot5: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a5_2 = Pddot5b_2 + U5_21 * T(0.05);
  const T a5_3 = Pddot5_3 + U5_31 * T(0.05);
  // G5 = m5 a5: inertia less applied force, body axes [N]
  const T G5_2 = T(0.6) * a5_2;
  const T G5_3 = T(0.6) * a5_3;
  // N5 = axial(U5 (tr(I5)/2 - I5)): inertia less applied moment about the mass centre, body axes [N m]
  const T N5_1 = T(0.0025) * U5_32 - T(5e-04) * U5_23;
  const T N5_2 = T(5e-04) * U5_13 - T(0.0015) * U5_31;
  const T N5_3 = T(0.0015) * U5_21 - T(0.0025) * U5_12;

  // ---- body 9 (sled) on the inertial frame
  const T s9_2 = x[27];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;

  // ---- body 12 (plate) on body 5
  const T s9_1 = x[26];
  const T thetadot9 = y[11];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  // P12 = R5^T q12 + P5a: position of the body origin, inertial axes [m]
  const T P12_1 = P5a_1 + R5_11 * T(0.1);
  const T P12_2 = P5a_2 + R5_12 * T(0.1);
  const T P12_3 = P5a_3 + R5_13 * T(0.1);
  // Pdot12 = R5^T omega5~ q12 + Pdot5a: velocity of the body origin, inertial axes [m/s]
  const T t12_1 = omega5_3 * T(0.1);
  const T t12_2 = omega5b_2 * T(0.1);
  const T Pdot12_1 = Pdot5a_1 + R5b_21 * t12_1 - R5_31 * t12_2;
  const T Pdot12_2 = Pdot5a_2 + R5b_22 * t12_1 - R5_32 * t12_2;
  const T Pdot12_3 = Pdot5a_3 + R5b_23 * t12_1 - R5_33 * t12_2;
  // Pddot12 = U5 q12 + Pddot5: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot12_1 = Pddot5_1 - minus_U5_11 * T(0.1);
  const T Pddot12_2 = Pddot5b_2 + U5_21 * T(0.1);
  const T Pddot12_3 = Pddot5_3 + U5_31 * T(0.1);
  // line_tether_12 = -R5^T C12^T r_tether_ + E9^T r_tether_other_ + d9 - P12: from one end of the spring to the
  //   other, inertial axes [m]
  const T line_tether_12_1 = s9_1 - P12_1 + R5_11 * T(0.07071067811865477) - R5b_21 * T(0.02) - R5_31 *
      T(0.07071067811865477) + E9_11 * T(0.1);
  const T line_tether_12_2 = d9_2 - P12_2 + R5_12 * T(0.07071067811865477) - R5b_22 * T(0.02) - R5_32 *
      T(0.07071067811865477) + E9_12 * T(0.1);
  const T line_tether_12_3 = T(0.1) - P12_3 + R5_13 * T(0.07071067811865477) - R5b_23 * T(0.02) - R5_33 *
      T(0.07071067811865477);
  // ll_tether_12 = 1e-36 + line_tether_12 . line_tether_12: length squared [m^2]
  const T ll_tether_12 = T(1e-36) + line_tether_12_1 * line_tether_12_1 + line_tether_12_2 * line_tether_12_2 +
      line_tether_12_3 * line_tether_12_3;
  // length_tether_12 = ll_tether_12^1/2: length [m]
  const T length_tether_12 = sqrt(ll_tether_12);
  // line_rate_tether_12 = -R5^T omega5~ C12^T r_tether_ + E9^T omega9~ r_tether_other_ + Pdot9 - Pdot12: its rate
  //   [m/s]
  const T t12_3 = thetadot9 * T(0.1);
  const T t12_4 = omega5b_2 * T(0.07071067811865477);
  const T t12_5 = t12_4 - omega5_3 * T(0.02);
  const T t12_6 = omega5_3 * T(0.07071067811865477) + omega5_1 * T(0.07071067811865477);
  const T t12_7 = t12_4 + omega5_1 * T(0.02);
  const T line_rate_tether_12_1 = sdot9_1 - Pdot12_1 - E9_12 * t12_3 - R5_11 * t12_5 + R5b_21 * t12_6 - R5_31 * t12_7;
  const T line_rate_tether_12_2 = sdot9_2 - Pdot12_2 + R5b_22 * t12_6 - R5_12 * t12_5 - R5_32 * t12_7 + E9_11 * t12_3;
  const T minus_line_rate_tether_12_3 = Pdot12_3 + R5_13 * t12_5 - R5b_23 * t12_6 + R5_33 * t12_7;
  // f_tether_12 = k_tether_ - k_tether_ l_tether_ length_tether_12^-1 + c_tether_ line_tether_12 .
  //   line_rate_tether_12 ll_tether_12^-1: attraction by the length [N/m]
  const T f_tether_12 = c.p.k - T(1) / length_tether_12 * c.c9_1 + T(0.4) * (line_tether_12_1 * line_rate_tether_12_1
      + line_tether_12_2 * line_rate_tether_12_2 - line_tether_12_3 * minus_line_rate_tether_12_3) * (T(1) /
      ll_tether_12);
  // F_tether_12 = f_tether_12 line_tether_12: on the first end, inertial axes [N]
  const T F_tether_12_1 = f_tether_12 * line_tether_12_1;
  const T F_tether_12_2 = f_tether_12 * line_tether_12_2;
  const T F_tether_12_3 = f_tether_12 * line_tether_12_3;
  // a12 = U5 r_link12 + Pddot12: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a12_1 = Pddot12_1 + minus_U5_11 * T(0.03535533905932738) + U5_13 * T(0.03535533905932738);
  const T a12_2 = Pddot12_2 + U5_23 * T(0.03535533905932738) - U5_21 * T(0.03535533905932738);
  const T a12_3 = Pddot12_3 - U5_31 * T(0.03535533905932738) - minus_U5_33 * T(0.03535533905932738);
  // G12 = -R5 F_tether_12 + m12 a12: inertia less applied force, body axes [N]
  const T t12_8 = R5_11 * F_tether_12_1 + R5_12 * F_tether_12_2 + R5_13 * F_tether_12_3;
  const T G12_1 = c.p.m_plate * a12_1 - t12_8;
  const T t12_9 = R5b_21 * F_tether_12_1 + R5b_22 * F_tether_12_2 + R5b_23 * F_tether_12_3;
  const T G12_2 = c.p.m_plate * a12_2 - t12_9;
  const T t12_10 = R5_31 * F_tether_12_1 + R5_32 * F_tether_12_2 + R5_33 * F_tether_12_3;
  const T G12_3 = c.p.m_plate * a12_3 - t12_10;
  // N12 = axial(U5 (tr(I_link12)/2 - I_link12)) - lever12~ R5 F_tether_12: inertia less applied moment about the mass
  //   centre, body axes [N m]
  const T t12_11 = T(0.03535533905932738) * t12_9;
  const T N12_1 = t12_11 + T(0.002) * U5_32 - T(0.0020000000000000005) * U5_23 + T(0.0020000000000000005) * U5_21 -
      T(0.02) * t12_10;
  const T N12_2 = T(0.0020000000000000005) * U5_13 - T(0.0019999999999999996) * U5_31 - T(0.0020000000000000005) *
      (minus_U5_33 - minus_U5_11) - T(0.03535533905932738) * t12_8 - T(0.03535533905932738) * t12_10;
  const T N12_3 = t12_11 + T(0.0019999999999999996) * U5_21 - T(0.002) * U5_12 - T(0.0020000000000000005) * U5_23 +
      T(0.02) * t12_8;

  // ---- body 12 (plate) and what it carries
  // rho12 = r_link12~ G12 + N12: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T b12_1 = T(0.03535533905932738) * G12_2;
  const T rho12_1 = N12_1 - b12_1;
  const T rho12_2 = N12_2 + T(0.03535533905932738) * G12_1 + T(0.03535533905932738) * G12_3;
  const T rho12_3 = N12_3 - b12_1;

  // ---- body 5 (camera) and what it carries
  // rho5 = q12~ G12 + r5~ G5 + N5 + rho12: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho5_1 = N5_1 + rho12_1;
  const T rho5_2 = N5_2 + rho12_2 - T(0.1) * G12_3 - T(0.05) * G5_3;
  const T rho5_3 = N5_3 + rho12_3 + T(0.1) * G12_2 + T(0.05) * G5_2;
  drive[1] = rho5_2;
  // rho5b = E5^T rho5: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5b_1 = c.E5_11 * rho5_1 + c.E5_31 * rho5_3;
  drive[0] = rho5b_1;

  // ---- results
  drive[2] = T(0);
  drive[3] = T(0);
  drive[4] = T(0);
  drive[5] = T(39.43000000000001);
}

// reactions: force and moment on each body through its joint, about its origin, body axes.
// force (3) [N] and moment (3) [N m] of body 1, of body 2, ... (n_bodies * 6)
// 861 add, 1023 multiply, 2 divide, 1 square root, 19 sine or cosine, 1 other function
template <class T>
void reactions(const Prepared<T>& c, T t, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* reaction)
    noexcept {
  using std::cos, std::exp, std::sin, std::sqrt;
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[16], sddot1_2 = ydot[17], sddot1_3 = ydot[18];
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
  const T U1_13 = omegadot1_2 + t1_16;
  const T U1_21 = t1_15 + omegadot1_3;
  const T t1_17 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_17 + t1_13;
  const T t1_18 = omega1_3 * omega1_2;
  const T U1_23 = t1_18 - omegadot1_1;
  const T U1_31 = t1_16 - omegadot1_2;
  const T U1_32 = t1_18 + omegadot1_1;
  const T minus_U1_33 = t1_17 + t1_14;
  // Pddot1 = R1 (-g + sddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t1_19 = sddot1_3 + T(9.81);
  const T Pddot1_1 = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * t1_19;
  const T Pddot1_2 = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * t1_19;
  const T Pddot1_3 = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * t1_19;
  // a1 = U1 r1 + Pddot1: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T t1_20 = U1_13 * T(0.03);
  const T a1_1 = t1_20 + Pddot1_1 - minus_U1_11 * T(0.02) - U1_12 * T(0.01);
  const T a1_2 = Pddot1_2 + U1_21 * T(0.02) + minus_U1_22 * T(0.01) + U1_23 * T(0.03);
  const T t1_21 = U1_31 * T(0.02);
  const T a1_3 = t1_21 + Pddot1_3 - U1_32 * T(0.01) - minus_U1_33 * T(0.03);
  // G1 = -R1 F1 + m1 a1: inertia less applied force, body axes [N]
  const T G1_1 = T(8) * a1_1 - R1_13 * u.thrust;
  const T G1_2 = T(8) * a1_2 - R1_23 * u.thrust;
  const T G1_3 = T(8) * a1_3 - R1_33 * u.thrust;
  // N1 = -M1 + axial(U1 (tr(I1)/2 - I1)): inertia less applied moment about the mass centre, body axes [N m]
  const T t1_22 = U1_23 * T(0.2);
  const T N1_1 = T(0.39999999999999997) * U1_32 - (t1_22 + t1_21 + T(0.1)) - T(0.03) * (minus_U1_22 - minus_U1_33) -
      T(0.01) * U1_21;
  const T t1_23 = U1_13 * T(0.2);
  const T t1_24 = U1_31 * T(0.3);
  const T N1_2 = t1_23 - t1_24 + T(0.01) * (minus_U1_33 - minus_U1_11) - T(0.03) * U1_12 + T(0.02) * U1_32 - T(0.2) *
      cos(T(2) * t);
  const T t1_25 = U1_21 * T(0.3);
  const T N1_3 = t1_25 + t1_20 - T(0.39999999999999997) * U1_12 - T(0.02) * (minus_U1_11 - minus_U1_22) + T(0.01) *
      U1_23;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  const T omegadot2_1 = ydot[3], omegadot2_2 = ydot[4], omegadot2_3 = ydot[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * T(0.2) + R1_21 * T(0.1) - R1_31 * T(0.2);
  const T P2_2 = s1_2 + R1_12 * T(0.2) + R1_22 * T(0.1) - R1_32 * T(0.2);
  const T P2_3 = s1_3 + R1_13 * T(0.2) + R1_23 * T(0.1) - R1_33 * T(0.2);
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t2_13 = omega2_2 * omega2_1;
  const T U2_12 = t2_13 - omegadot2_3;
  const T t2_14 = omega2_3 * omega2_1;
  const T U2_13 = t2_14 + omegadot2_2;
  const T U2_21 = t2_13 + omegadot2_3;
  const T t2_15 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_15 + omega2_3 * omega2_3;
  const T t2_16 = omega2_3 * omega2_2;
  const T U2_23 = t2_16 - omegadot2_1;
  const T U2_31 = t2_14 - omegadot2_2;
  const T U2_32 = t2_16 + omegadot2_1;
  const T minus_U2_33 = t2_15 + omega2_2 * omega2_2;
  // Pddot2 = R1^T (U1 q2 + Pddot1): acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T t2_17 = Pddot1_1 + U1_12 * T(0.1);
  const T t2_18 = minus_U1_11 * T(0.2);
  const T t2_19 = t2_17 - t2_18 - t1_23;
  const T t2_20 = U1_21 * T(0.2);
  const T t2_21 = Pddot1_2 - minus_U1_22 * T(0.1);
  const T t2_22 = t2_20 + t2_21 - t1_22;
  const T t2_23 = U1_31 * T(0.2);
  const T t2_24 = Pddot1_3 + U1_32 * T(0.1);
  const T t2_25 = t2_23 + t2_24 + minus_U1_33 * T(0.2);
  const T Pddot2_1 = R1_11 * t2_19 + R1_21 * t2_22 + R1_31 * t2_25;
  const T Pddot2_2 = R1_12 * t2_19 + R1_22 * t2_22 + R1_32 * t2_25;
  const T Pddot2_3 = R1_13 * t2_19 + R1_23 * t2_22 + R1_33 * t2_25;
  // a2 = R2^T U2 r2 + Pddot2: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t2_26 = U2_12 * T(0.02) - U2_13 * T(0.2);
  const T t2_27 = minus_U2_22 * T(0.02) + U2_23 * T(0.2);
  const T t2_28 = U2_32 * T(0.02) + minus_U2_33 * T(0.2);
  const T a2_1 = Pddot2_1 + R2_11 * t2_26 - R2_21 * t2_27 + R2_31 * t2_28;
  const T a2_2 = Pddot2_2 + R2_12 * t2_26 - R2_22 * t2_27 + R2_32 * t2_28;
  const T a2_3 = Pddot2_3 + R2_13 * t2_26 - R2_23 * t2_27 + R2_33 * t2_28;

  // ---- body 3 (boom) on body 1
  const T thetadot3 = y[6];
  const T thetaddot3 = ydot[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T t3_18 = E3_11 * omega1_1 + E3_12 * omega1_2 - minus_E3_13 * omega1_3;
  const T omega3_1 = t3_18 - thetadot3 * T(0.3152711589176631);
  const T t3_19 = E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_2 = t3_19 + thetadot3 * T(0.44378789320576517);
  const T t3_20 = E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  const T omega3_3 = t3_20 + thetadot3 * T(0.8388422987658062);
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_21 = s1_1 + R1_31 * T(0.1);
  const T P3_1 = t3_21 + R1_11 * T(0.3);
  const T t3_22 = s1_2 + R1_32 * T(0.1);
  const T P3_2 = t3_22 + R1_12 * T(0.3);
  const T t3_23 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_23 + R1_13 * T(0.3);
  // omegadot3 = -thetadot3 b3~ E3 omega1 + thetaddot3 b3 + E3 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot3_1 = E3_11 * omegadot1_1 - (thetadot3 * (T(0.44378789320576517) * t3_20 - T(0.8388422987658062) *
      t3_19) + thetaddot3 * T(0.3152711589176631)) + E3_12 * omegadot1_2 - minus_E3_13 * omegadot1_3;
  const T omegadot3_2 = thetaddot3 * T(0.44378789320576517) - thetadot3 * (T(0.8388422987658062) * t3_18 +
      T(0.3152711589176631) * t3_20) + E3_21 * omegadot1_1 + E3_22 * omegadot1_2 + E3_23 * omegadot1_3;
  const T omegadot3_3 = thetadot3 * (T(0.3152711589176631) * t3_19 + T(0.44378789320576517) * t3_18) + thetaddot3 *
      T(0.8388422987658062) + E3_31 * omegadot1_1 + E3_32 * omegadot1_2 + E3_33 * omegadot1_3;
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_24 = omega3_3 * omega3_3;
  const T t3_25 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_24 + t3_25;
  const T t3_26 = omega3_2 * omega3_1;
  const T U3_12 = t3_26 - omegadot3_3;
  const T t3_27 = omega3_3 * omega3_1;
  const T U3_13 = t3_27 + omegadot3_2;
  const T U3_21 = t3_26 + omegadot3_3;
  const T t3_28 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_24 + t3_28;
  const T t3_29 = omega3_3 * omega3_2;
  const T U3_23 = t3_29 - omegadot3_1;
  const T U3_31 = t3_27 - omegadot3_2;
  const T U3_32 = t3_29 + omegadot3_1;
  const T minus_U3_33 = t3_25 + t3_28;
  // Pddot3 = E3 (U1 q3 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_30 = Pddot1_1 + U1_13 * T(0.1);
  const T t3_31 = t3_30 - minus_U1_11 * T(0.3);
  const T t3_32 = Pddot1_2 + U1_23 * T(0.1);
  const T t3_33 = t1_25 + t3_32;
  const T t3_34 = minus_U1_33 * T(0.1) - Pddot1_3;
  const T t3_35 = t1_24 - t3_34;
  const T Pddot3_1 = E3_11 * t3_31 + E3_12 * t3_33 - minus_E3_13 * t3_35;
  const T Pddot3_2 = E3_21 * t3_31 + E3_22 * t3_33 + E3_23 * t3_35;
  const T Pddot3_3 = E3_31 * t3_31 + E3_32 * t3_33 + E3_33 * t3_35;
  // G2 = R3^T F_jet_ + m2 a2: inertia less applied force, inertial axes [N]
  const T t3_36 = T(0.5) * u.thrust * exp(T(0) - t);
  const T t3_37 = R3_11 * T(0.1) + R3_21 * t3_36;
  const T G2_1 = t3_37 + T(0.8) * a2_1;
  const T t3_38 = R3_12 * T(0.1) + R3_22 * t3_36;
  const T G2_2 = t3_38 + T(0.8) * a2_2;
  const T t3_39 = R3_13 * T(0.1) + R3_23 * t3_36;
  const T G2_3 = t3_39 + T(0.8) * a2_3;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a3_1 = Pddot3_1 + U3_12 * T(0.02) - minus_U3_11 * T(0.2);
  const T a3_2 = Pddot3_2 + U3_21 * T(0.2) - minus_U3_22 * T(0.02);
  const T a3_3 = Pddot3_3 + U3_31 * T(0.2) + U3_32 * T(0.02);
  // G3 = m3 a3: inertia less applied force, body axes [N]
  const T G3_1 = T(1.5) * a3_1;
  const T G3_2 = T(1.5) * a3_2;
  const T G3_3 = T(1.5) * a3_3;
  // N3 = axial(U3 (tr(I3)/2 - I3)): inertia less applied moment about the mass centre, body axes [N m]
  const T N3_1 = T(0.004999999999999999) * U3_32 - T(0.035) * U3_23 + T(0.003) * (minus_U3_22 - minus_U3_33) -
      T(0.002) * U3_31 + T(0.001) * U3_21;
  const T N3_2 = T(0.035) * U3_13 - T(0.015000000000000001) * U3_31 - T(0.001) * (minus_U3_33 - minus_U3_11) +
      T(0.003) * U3_12 + T(0.002) * U3_32;
  const T N3_3 = T(0.015000000000000001) * U3_21 - T(0.004999999999999999) * U3_12 - T(0.002) * (minus_U3_11 -
      minus_U3_22) - T(0.001) * U3_23 - T(0.003) * U3_13;

  // ---- body 4 (cross) on body 1
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  const T thetaddot4_1 = ydot[7], thetaddot4_2 = ydot[8];
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // omega4a = thetadot4_1 b4_1 + E4a omega1: absolute angular velocity, body axes [rad/s]
  const T omega4a_1 = E4a_11 * omega1_1 - minus_E4a_12 * omega1_2 - minus_E4a_13 * omega1_3;
  const T t4_3 = minus_E4a_12 * omega1_1 + E4a_22 * omega1_2 + E4a_23 * omega1_3;
  const T omega4a_2 = t4_3 + thetadot4_1 * T(0.28);
  const T t4_4 = minus_E4a_13 * omega1_1 + E4a_23 * omega1_2 + E4a_33 * omega1_3;
  const T omega4a_3 = t4_4 - thetadot4_1 * T(0.96);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_5 = cosines[10];
  const T E4_12 = T(0.28) * t4_5;
  const T minus_E4_13 = T(0.96) * t4_5;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // omega4 = thetadot4_2 b4_2 + E4 omega4a: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega4a_2 - minus_E4_11 * omega4a_1 - minus_E4_13 * omega4a_3;
  const T omega4_2 = thetadot4_2 + T(0.96) * omega4a_2 + T(0.28) * omega4a_3;
  const T omega4_3 = t4_5 * omega4a_1 + E4_32 * omega4a_2 - minus_E4_33 * omega4a_3;
  // omegadot4a = -thetadot4_1 b4_1~ E4a omega1 + thetaddot4_1 b4_1 + E4a omegadot1: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot4a_1 = E4a_11 * omegadot1_1 - minus_E4a_12 * omegadot1_2 - minus_E4a_13 * omegadot1_3 - thetadot4_1
      * (T(0.96) * t4_3 + T(0.28) * t4_4);
  const T omegadot4a_2 = T(0.96) * omega4a_1 * thetadot4_1 + thetaddot4_1 * T(0.28) + minus_E4a_12 * omegadot1_1 +
      E4a_22 * omegadot1_2 + E4a_23 * omegadot1_3;
  const T omegadot4a_3 = T(0.28) * omega4a_1 * thetadot4_1 - thetaddot4_1 * T(0.96) + minus_E4a_13 * omegadot1_1 +
      E4a_23 * omegadot1_2 + E4a_33 * omegadot1_3;
  // Pddot4a = E4a (U1 q4a + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_6 = t2_18 + t2_17;
  const T t4_7 = t2_21 - t2_20;
  const T t4_8 = t2_24 - t2_23;
  const T Pddot4a_1 = E4a_11 * t4_6 - minus_E4a_12 * t4_7 - minus_E4a_13 * t4_8;
  const T Pddot4a_2 = minus_E4a_12 * t4_6 + E4a_22 * t4_7 + E4a_23 * t4_8;
  const T Pddot4a_3 = minus_E4a_13 * t4_6 + E4a_23 * t4_7 + E4a_33 * t4_8;
  // omegadot4 = -thetadot4_2 b4_2~ E4 omega4a + thetaddot4_2 b4_2 + E4 omegadot4a: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot4_1 = E4_12 * omegadot4a_2 - minus_E4_11 * omegadot4a_1 - minus_E4_13 * omegadot4a_3 - thetadot4_2 *
      omega4_3;
  const T omegadot4_2 = thetaddot4_2 + T(0.96) * omegadot4a_2 + T(0.28) * omegadot4a_3;
  const T omegadot4_3 = thetadot4_2 * omega4_1 + t4_5 * omegadot4a_1 + E4_32 * omegadot4a_2 - minus_E4_33 *
      omegadot4a_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_9 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_9 + omega4_3 * omega4_3;
  const T t4_10 = omega4_2 * omega4_1;
  const T U4_12 = t4_10 - omegadot4_3;
  const T t4_11 = omega4_3 * omega4_1;
  const T U4_13 = t4_11 + omegadot4_2;
  const T U4_21 = t4_10 + omegadot4_3;
  const T t4_12 = omega4_3 * omega4_2;
  const T U4_23 = t4_12 - omegadot4_1;
  const T U4_31 = t4_11 - omegadot4_2;
  const T U4_32 = t4_12 + omegadot4_1;
  const T minus_U4_33 = t4_9 + omega4_1 * omega4_1;
  // Pddot4 = E4 Pddot4a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot4_1 = E4_12 * Pddot4a_2 - minus_E4_11 * Pddot4a_1 - minus_E4_13 * Pddot4a_3;
  const T Pddot4_2 = T(0.96) * Pddot4a_2 + T(0.28) * Pddot4a_3;
  const T Pddot4_3 = t4_5 * Pddot4a_1 + E4_32 * Pddot4a_2 - minus_E4_33 * Pddot4a_3;
  // a4 = U4 r4 + Pddot4: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a4_1 = Pddot4_1 + U4_13 * T(0.1) - minus_U4_11 * T(0.03);
  const T a4_2 = Pddot4_2 + U4_21 * T(0.03) + U4_23 * T(0.1);
  const T a4_3 = Pddot4_3 + U4_31 * T(0.03) - minus_U4_33 * T(0.1);
  // G4 = m4 a4: inertia less applied force, body axes [N]
  const T G4_1 = T(0.9) * a4_1;
  const T G4_2 = T(0.9) * a4_2;
  const T G4_3 = T(0.9) * a4_3;
  reaction[18] = G4_1;
  reaction[19] = G4_2;
  reaction[20] = G4_3;
  // N4 = axial(U4 (tr(I4)/2 - I4)): inertia less applied moment about the mass centre, body axes [N m]
  const T N4_1 = T(0.006500000000000001) * U4_32 - T(0.0015) * U4_23;
  const T N4_2 = T(0.0015) * U4_13 - T(0.0055) * U4_31;
  const T N4_3 = T(0.0055) * U4_21 - T(0.006500000000000001) * U4_12;

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  const T thetaddot5_1 = ydot[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T t5_2 = sin(t5_1);
  const T theta5_2 = c.p.amplitude * t5_2;
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // thetaddot5_2 = d^2/dt^2 expression 1: prescribed
  const T minus_thetaddot5_2 = t5_2 * T(3) * T(3) * c.p.amplitude;
  // E5b^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5b_22 = cos(theta5_2);
  const T E5b_23 = sin(theta5_2);
  // R5b^T = R5a^T E5b^T: R takes inertial components to body components
  const T R5b_21 = R5a_21 * E5b_22 + R1_31 * E5b_23;
  const T R5b_22 = R5a_22 * E5b_22 + R1_32 * E5b_23;
  const T R5b_23 = R5a_23 * E5b_22 + R1_33 * E5b_23;
  const T R5b_31 = R1_31 * E5b_22 - R5a_21 * E5b_23;
  const T R5b_32 = R1_32 * E5b_22 - R5a_22 * E5b_23;
  const T R5b_33 = R1_33 * E5b_22 - R5a_23 * E5b_23;
  // omega5b = thetadot5_2 b5_2 + E5b omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5b_1 = omega5a_1 + thetadot5_2;
  const T omega5b_2 = E5b_22 * omega5a_2 + E5b_23 * omega5a_3;
  const T omega5b_3 = E5b_22 * omega5a_3 - E5b_23 * omega5a_2;
  // R5^T = R5b^T E5^T: R takes inertial components to body components
  const T R5_11 = R5a_11 * c.E5_11 - R5b_31 * c.E5_31;
  const T R5_12 = R5a_12 * c.E5_11 - R5b_32 * c.E5_31;
  const T R5_13 = R5a_13 * c.E5_11 - R5b_33 * c.E5_31;
  const T R5_31 = R5a_11 * c.E5_31 + R5b_31 * c.E5_11;
  const T R5_32 = R5a_12 * c.E5_31 + R5b_32 * c.E5_11;
  const T R5_33 = R5a_13 * c.E5_31 + R5b_33 * c.E5_11;
  // omega5 = E5 omega5b: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = c.E5_11 * omega5b_1 - c.E5_31 * omega5b_3;
  const T omega5_3 = c.E5_31 * omega5b_1 + c.E5_11 * omega5b_3;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = t3_21 - R1_21 * T(0.3);
  const T P5a_2 = t3_22 - R1_22 * T(0.3);
  const T P5a_3 = t3_23 - R1_23 * T(0.3);
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_3 = omega1_3 * T(0.3) + omega1_2 * T(0.1);
  const T t5_4 = omega1_1 * T(0.1);
  const T t5_5 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_3 - R1_21 * t5_4 - R1_31 * t5_5;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_3 - R1_22 * t5_4 - R1_32 * t5_5;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_3 - R1_23 * t5_4 - R1_33 * t5_5;
  // omegadot5a = -thetadot5_1 b5_1~ E5a omega1 + thetaddot5_1 b5_1 + E5a omegadot1: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5a_1 = thetadot5_1 * omega5a_2 + E5a_11 * omegadot1_1 + E5a_12 * omegadot1_2;
  const T omegadot5a_2 = E5a_11 * omegadot1_2 - E5a_12 * omegadot1_1 - thetadot5_1 * omega5a_1;
  const T omegadot5a_3 = thetaddot5_1 + omegadot1_3;
  // Pddot5a = E5a (U1 q5a + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_6 = t3_30 - U1_12 * T(0.3);
  const T t5_7 = t3_32 + minus_U1_22 * T(0.3);
  const T Pddot5a_1 = E5a_11 * t5_6 + E5a_12 * t5_7;
  const T Pddot5a_2 = E5a_11 * t5_7 - E5a_12 * t5_6;
  const T minus_Pddot5a_3 = t3_34 + U1_32 * T(0.3);
  // omegadot5b = -thetadot5_2 b5_2~ E5b omega5a + thetaddot5_2 b5_2 + E5b omegadot5a: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5b_1 = omegadot5a_1 - minus_thetaddot5_2;
  const T omegadot5b_2 = thetadot5_2 * omega5b_3 + E5b_22 * omegadot5a_2 + E5b_23 * omegadot5a_3;
  const T omegadot5b_3 = E5b_22 * omegadot5a_3 - E5b_23 * omegadot5a_2 - thetadot5_2 * omega5b_2;
  // Pddot5b = E5b Pddot5a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5b_2 = E5b_22 * Pddot5a_2 - E5b_23 * minus_Pddot5a_3;
  const T minus_Pddot5b_3 = E5b_22 * minus_Pddot5a_3 + E5b_23 * Pddot5a_2;
  // omegadot5 = E5 omegadot5b: angular acceleration, body axes [rad/s^2]
  const T omegadot5_1 = c.E5_11 * omegadot5b_1 - c.E5_31 * omegadot5b_3;
  const T omegadot5_3 = c.E5_31 * omegadot5b_1 + c.E5_11 * omegadot5b_3;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_8 = omega5b_2 * omega5b_2;
  const T minus_U5_11 = t5_8 + omega5_3 * omega5_3;
  const T t5_9 = omega5b_2 * omega5_1;
  const T U5_12 = t5_9 - omegadot5_3;
  const T t5_10 = omega5_3 * omega5_1;
  const T U5_13 = t5_10 + omegadot5b_2;
  const T U5_21 = t5_9 + omegadot5_3;
  const T t5_11 = omega5_3 * omega5b_2;
  const T U5_23 = t5_11 - omegadot5_1;
  const T U5_31 = t5_10 - omegadot5b_2;
  const T U5_32 = t5_11 + omegadot5_1;
  const T minus_U5_33 = t5_8 + omega5_1 * omega5_1;
  // Pddot5 = E5 Pddot5b: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_1 = c.E5_11 * Pddot5a_1 + c.E5_31 * minus_Pddot5b_3;
  const T Pddot5_3 = c.E5_31 * Pddot5a_1 - c.E5_11 * minus_Pddot5b_3;
  // a5 = U5 r5 + Pddot5: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a5_1 = Pddot5_1 - minus_U5_11 * T(0.05);
  const T a5_2 = Pddot5b_2 + U5_21 * T(0.05);
  const T a5_3 = Pddot5_3 + U5_31 * T(0.05);
  // G5 = m5 a5: inertia less applied force, body axes [N]
  const T G5_1 = T(0.6) * a5_1;
  const T G5_2 = T(0.6) * a5_2;
  const T G5_3 = T(0.6) * a5_3;
  // N5 = axial(U5 (tr(I5)/2 - I5)): inertia less applied moment about the mass centre, body axes [N m]
  const T N5_1 = T(0.0025) * U5_32 - T(5e-04) * U5_23;
  const T N5_2 = T(5e-04) * U5_13 - T(0.0015) * U5_31;
  const T N5_3 = T(0.0015) * U5_21 - T(0.0025) * U5_12;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  const T sddot6 = ydot[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_1 = P3_1 + R3_11 * d6_1;
  const T P6_2 = P3_2 + R3_12 * d6_1;
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // Pddot6 = 2 sdot6 omega3~ u6 + sddot6 u6 + U3 d6 + Pddot3: acceleration of the body origin, less gravity, body
  //   axes [m/s^2]
  const T Pddot6_1 = sddot6 + Pddot3_1 - minus_U3_11 * d6_1;
  const T t6_1 = T(2) * sdot6;
  const T Pddot6_2 = Pddot3_2 + t6_1 * omega3_3 + U3_21 * d6_1;
  const T Pddot6_3 = Pddot3_3 + U3_31 * d6_1 - t6_1 * omega3_2;
  // arm2 = R2 R3^T r_jet_ - R2 P2 + R2 P6
  const T t6_2 = R3_11 * T(0.2);
  const T t6_3 = R3_12 * T(0.2);
  const T t6_4 = R3_13 * T(0.2);
  const T arm2_1 = R2_11 * t6_2 + R2_12 * t6_3 + R2_13 * t6_4 - R2_11 * P2_1 - R2_12 * P2_2 - R2_13 * P2_3 + R2_11 *
      P6_1 + R2_12 * P6_2 + R2_13 * P6_3;
  const T arm2_2 = R2_21 * t6_2 + R2_22 * t6_3 + R2_23 * t6_4 - R2_21 * P2_1 - R2_22 * P2_2 - R2_23 * P2_3 + R2_21 *
      P6_1 + R2_22 * P6_2 + R2_23 * P6_3;
  const T arm2_3 = R2_31 * t6_2 + R2_32 * t6_3 + R2_33 * t6_4 - R2_31 * P2_1 - R2_32 * P2_2 - R2_33 * P2_3 + R2_31 *
      P6_1 + R2_32 * P6_2 + R2_33 * P6_3;
  // lever2 = -r2 + arm2: from the reference point to where a force acts, link axes [m]
  const T lever2_2 = arm2_2 - T(0.02);
  const T lever2_3 = arm2_3 + T(0.2);
  // N2 = axial(U2 (tr(I2)/2 - I2)) + lever2~ R2 R3^T F_jet_: inertia less applied moment about the mass centre, body
  //   axes [N m]
  const T t6_5 = R2_31 * t3_37 + R2_32 * t3_38 + R2_33 * t3_39;
  const T t6_6 = R2_21 * t3_37 + R2_22 * t3_38 + R2_23 * t3_39;
  const T N2_1 = T(0.0015000000000000005) * U2_32 - T(0.0085) * U2_23 + lever2_2 * t6_5 - lever2_3 * t6_6;
  const T t6_7 = R2_11 * t3_37 + R2_12 * t3_38 + R2_13 * t3_39;
  const T N2_2 = T(0.0085) * U2_13 - T(0.0024999999999999996) * U2_31 + lever2_3 * t6_7 - arm2_1 * t6_5;
  const T N2_3 = T(0.0024999999999999996) * U2_21 - T(0.0015000000000000005) * U2_12 + arm2_1 * t6_6 - lever2_2 *
      t6_7;
  // a6 = U3 r6 + Pddot6: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a6_1 = Pddot6_1 + U3_13 * T(0.01) - minus_U3_11 * T(0.1);
  const T a6_2 = Pddot6_2 + U3_21 * T(0.1) + U3_23 * T(0.01);
  const T a6_3 = Pddot6_3 + U3_31 * T(0.1) - minus_U3_33 * T(0.01);
  // G6 = m6 a6 - F_jet_: inertia less applied force, body axes [N]
  const T G6_1 = T(0.5) * a6_1 - T(0.1);
  const T G6_2 = T(0.5) * a6_2 - t3_36;
  const T G6_3 = T(0.5) * a6_3;
  reaction[30] = G6_1;
  reaction[31] = G6_2;
  reaction[32] = G6_3;
  // N6 = axial(U3 (tr(I6)/2 - I6)) - lever6~ F_jet_: inertia less applied moment about the mass centre, body axes [N
  //   m]
  const T N6_1 = T(5e-04) * U3_32 - T(5e-04) * U3_23 - T(0.01) * t3_36;
  const T N6_2 = T(0.001) + T(5e-04) * U3_13 - T(0.0055) * U3_31;
  const T N6_3 = T(0.0055) * U3_21 - T(5e-04) * U3_12 - T(0.1) * t3_36;

  // ---- body 7 (gantry) on the inertial frame
  const T sddot7_1 = ydot[20], sddot7_2 = ydot[21];
  // G7 = m7 Pddot7: inertia less applied force, inertial axes [N]
  const T G7_1 = T(3) * sddot7_1;
  const T G7_2 = T(3) * sddot7_2;
  reaction[36] = G7_1;
  reaction[37] = G7_2;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  const T thetadot8 = y[10];
  const T sdot8 = y[22];
  const T thetaddot8 = ydot[10];
  const T sddot8 = ydot[22];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega1_1 + E8_13 * omega1_3;
  const T omega8_2 = omega1_2 - thetadot8;
  const T omega8_3 = E8_11 * omega1_3 - E8_13 * omega1_1;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // omegadot8 = -thetadot8 b8~ E8 omega1 + thetaddot8 b8 + E8 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot8_1 = thetadot8 * omega8_3 + E8_11 * omegadot1_1 + E8_13 * omegadot1_3;
  const T omegadot8_2 = omegadot1_2 - thetaddot8;
  const T omegadot8_3 = E8_11 * omegadot1_3 - E8_13 * omegadot1_1 - thetadot8 * omega8_1;
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
  // Pddot8 = E8 (2 sdot8 omega1~ u8 + sddot8 u8 + U1 d8 + Pddot1): acceleration of the body origin, less gravity,
  //   body axes [m/s^2]
  const T t8_7 = T(2) * sdot8;
  const T t8_8 = Pddot1_1 + t8_7 * omega1_3 + U1_12 * d8_2;
  const T t8_9 = Pddot1_3 + U1_32 * d8_2 - t8_7 * omega1_1;
  const T Pddot8_1 = E8_11 * t8_8 + E8_13 * t8_9;
  const T Pddot8_2 = Pddot1_2 - sddot8 - minus_U1_22 * d8_2;
  const T Pddot8_3 = E8_11 * t8_9 - E8_13 * t8_8;
  // a8 = U8 r_link8 + Pddot8: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a8_1 = Pddot8_1 + minus_U8_11 * T(0.01) - U8_12 * T(0.1) + U8_13 * T(0.02);
  const T a8_2 = Pddot8_2 + minus_U8_22 * T(0.1) - U8_21 * T(0.01) + U8_23 * T(0.02);
  const T a8_3 = Pddot8_3 - U8_31 * T(0.01) - U8_32 * T(0.1) - minus_U8_33 * T(0.02);
  // G8 = m8 a8: inertia less applied force, body axes [N]
  const T G8_1 = T(0.7) * a8_1;
  const T G8_2 = T(0.7) * a8_2;
  const T G8_3 = T(0.7) * a8_3;
  // N8 = axial(U8 (tr(I_link8)/2 - I_link8)): inertia less applied moment about the mass centre, body axes [N m]
  const T N8_1 = T(0.0025) * U8_32 - T(5e-04) * U8_23;
  const T N8_2 = T(5e-04) * U8_13 - T(0.0015) * U8_31;
  const T N8_3 = T(0.0015) * U8_21 - T(0.0025) * U8_12;

  // ---- body 9 (sled) on the inertial frame
  const T s9_2 = x[27];
  const T thetadot9 = y[11];
  const T thetaddot9 = ydot[11];
  const T sddot9_1 = ydot[23], sddot9_2 = ydot[24];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // U9 = omega9~ omega9~ + omegadot9~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U9_11 = thetadot9 * thetadot9;
  // Pddot9 = E9 (-g + sddot9_1 u9_1 + sddot9_2 u9_2): acceleration of the body origin, less gravity, body axes
  //   [m/s^2]
  const T Pddot9_1 = E9_11 * sddot9_1 + E9_12 * sddot9_2;
  const T Pddot9_2 = E9_11 * sddot9_2 - E9_12 * sddot9_1;
  // a9 = U9 r9 + Pddot9: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a9_1 = Pddot9_1 - minus_U9_11 * T(0.1);
  const T a9_2 = Pddot9_2 + thetaddot9 * T(0.1);

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  const T omega10_1 = y[12], omega10_2 = y[13], omega10_3 = y[14];
  const T sdot10 = y[25];
  const T omegadot10_1 = ydot[12], omegadot10_2 = ydot[13], omegadot10_3 = ydot[14];
  const T sddot10 = ydot[25];
  // R10^T = 1 + 2 e10~ (eps4_10 + e10~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t10_1 = T(2) * eps10_2;
  const T t10_2 = t10_1 * eps10_2;
  const T t10_3 = T(2) * eps10_3;
  const T t10_4 = t10_3 * eps10_3;
  const T R10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * eps10_1;
  const T t10_6 = t10_5 * eps10_2;
  const T t10_7 = t10_3 * eps10_4;
  const T R10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * eps10_3;
  const T t10_9 = t10_1 * eps10_4;
  const T R10_13 = t10_8 - t10_9;
  const T R10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * eps10_1;
  const T R10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * eps10_3;
  const T t10_12 = t10_5 * eps10_4;
  const T R10_23 = t10_11 + t10_12;
  const T R10_31 = t10_8 + t10_9;
  const T R10_32 = t10_11 - t10_12;
  const T R10_33 = t10_10 - t10_2;
  // U10 = omega10~ omega10~ + omegadot10~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t10_13 = omega10_3 * omega10_3;
  const T t10_14 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_13 + t10_14;
  const T t10_15 = omega10_2 * omega10_1;
  const T U10_12 = t10_15 - omegadot10_3;
  const T t10_16 = omega10_3 * omega10_1;
  const T U10_13 = t10_16 + omegadot10_2;
  const T U10_21 = t10_15 + omegadot10_3;
  const T t10_17 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_13 + t10_17;
  const T t10_18 = omega10_3 * omega10_2;
  const T U10_23 = t10_18 - omegadot10_1;
  const T U10_31 = t10_16 - omegadot10_2;
  const T U10_32 = t10_18 + omegadot10_1;
  const T minus_U10_33 = t10_14 + t10_17;
  // Pddot10 = R1^T (2 sdot10 omega1~ u10 + sddot10 u10 + U1 d10 + Pddot1): acceleration of the body origin, less
  //   gravity, inertial axes [m/s^2]
  const T t10_19 = T(2) * sdot10;
  const T t10_20 = Pddot1_1 + U1_12 * s10 - minus_U1_11 * T(0.1) + U1_13 * T(0.3) - t10_19 * omega1_3;
  const T t10_21 = sddot10 + Pddot1_2 + U1_21 * T(0.1) - minus_U1_22 * s10 + U1_23 * T(0.3);
  const T t10_22 = Pddot1_3 + t10_19 * omega1_1 + U1_31 * T(0.1) + U1_32 * s10 - minus_U1_33 * T(0.3);
  const T Pddot10_1 = R1_11 * t10_20 + R1_21 * t10_21 + R1_31 * t10_22;
  const T Pddot10_2 = R1_12 * t10_20 + R1_22 * t10_21 + R1_32 * t10_22;
  const T Pddot10_3 = R1_13 * t10_20 + R1_23 * t10_21 + R1_33 * t10_22;
  // a10 = R10^T U10 r10 + Pddot10: acceleration of the mass centre, less gravity, inertial axes [m/s^2]
  const T t10_23 = U10_12 * T(0.01) - minus_U10_11 * T(0.02) - U10_13 * T(0.03);
  const T t10_24 = U10_21 * T(0.02) - minus_U10_22 * T(0.01) - U10_23 * T(0.03);
  const T t10_25 = U10_31 * T(0.02) + U10_32 * T(0.01) + minus_U10_33 * T(0.03);
  const T a10_1 = Pddot10_1 + R10_11 * t10_23 + R10_21 * t10_24 + R10_31 * t10_25;
  const T a10_2 = Pddot10_2 + R10_12 * t10_23 + R10_22 * t10_24 + R10_32 * t10_25;
  const T a10_3 = Pddot10_3 + R10_13 * t10_23 + R10_23 * t10_24 + R10_33 * t10_25;
  // G10 = m10 a10: inertia less applied force, inertial axes [N]
  const T G10_1 = T(0.4) * a10_1;
  const T G10_2 = T(0.4) * a10_2;
  const T G10_3 = T(0.4) * a10_3;
  // N10 = axial(U10 (tr(I10)/2 - I10)): inertia less applied moment about the mass centre, body axes [N m]
  const T N10_1 = T(0.00075) * U10_32 - T(0.00125) * U10_23;
  const T N10_2 = T(0.00125) * U10_13 - T(0.00175) * U10_31;
  const T N10_3 = T(0.00175) * U10_21 - T(0.00075) * U10_12;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  const T thetadot11 = y[15];
  const T thetaddot11 = ydot[15];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega8_1 + E11_13 * omega8_3;
  const T omega11_2 = omega8_2 - thetadot11;
  const T omega11_3 = E11_11 * omega8_3 - E11_13 * omega8_1;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // omegadot11 = -thetadot11 b11~ E11 omega8 + thetaddot11 b11 + E11 omegadot8: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot11_1 = thetadot11 * omega11_3 + E11_11 * omegadot8_1 + E11_13 * omegadot8_3;
  const T omegadot11_2 = omegadot8_2 - thetaddot11;
  const T omegadot11_3 = E11_11 * omegadot8_3 - E11_13 * omegadot8_1 - thetadot11 * omega11_1;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_1 = omega11_2 * omega11_1;
  const T U11_12 = t11_1 - omegadot11_3;
  const T t11_2 = omega11_3 * omega11_1;
  const T U11_13 = t11_2 + omegadot11_2;
  const T U11_21 = t11_1 + omegadot11_3;
  const T t11_3 = omega11_3 * omega11_2;
  const T U11_23 = t11_3 - omegadot11_1;
  const T U11_31 = t11_2 - omegadot11_2;
  const T U11_32 = t11_3 + omegadot11_1;
  const T minus_U11_33 = omega11_2 * omega11_2 + omega11_1 * omega11_1;
  // Pddot11 = E11 (2 thetadot11 pitch11 omega8~ u11 + thetaddot11 pitch11 u11 + U8 d11 + Pddot8): acceleration of the
  //   body origin, less gravity, body axes [m/s^2]
  const T t11_4 = T(2) * thetadot11 * T(0.01);
  const T t11_5 = Pddot8_1 + t11_4 * omega8_3 - U8_12 * minus_d11_2;
  const T t11_6 = Pddot8_3 - t11_4 * omega8_1 - U8_32 * minus_d11_2;
  const T Pddot11_1 = E11_11 * t11_5 + E11_13 * t11_6;
  const T Pddot11_2 = Pddot8_2 + minus_U8_22 * minus_d11_2 - thetaddot11 * T(0.01);
  const T Pddot11_3 = E11_11 * t11_6 - E11_13 * t11_5;
  // a11 = U11 r_link11 + Pddot11: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a11_1 = Pddot11_1 + U11_13 * T(0.01);
  const T a11_2 = Pddot11_2 + U11_23 * T(0.01);
  const T a11_3 = Pddot11_3 - minus_U11_33 * T(0.01);
  // G11 = m11 a11: inertia less applied force, body axes [N]
  const T G11_1 = T(0.3) * a11_1;
  const T G11_2 = T(0.3) * a11_2;
  const T G11_3 = T(0.3) * a11_3;
  reaction[61] = -G11_1;
  reaction[62] = -G11_2;
  reaction[60] = G11_3;
  // N11 = -C11^T M_coupling_ + axial(U11 (tr(I_link11)/2 - I_link11)): inertia less applied moment about the mass
  //   centre, body axes [N m]
  const T N11_1 = T(0.00010000000000000005) * U11_32 - T(3e-04) * U11_23;
  const T N11_2 = T(3e-04) * U11_13 - T(3e-04) * U11_31 + T(0.02) * u.motor;
  const T N11_3 = T(3e-04) * U11_21 - T(0.00010000000000000005) * U11_12;
  reaction[63] = N11_3;

  // ---- body 12 (plate) on body 5
  const T s9_1 = x[26];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  // P12 = R5^T q12 + P5a: position of the body origin, inertial axes [m]
  const T P12_1 = P5a_1 + R5_11 * T(0.1);
  const T P12_2 = P5a_2 + R5_12 * T(0.1);
  const T P12_3 = P5a_3 + R5_13 * T(0.1);
  // Pdot12 = R5^T omega5~ q12 + Pdot5a: velocity of the body origin, inertial axes [m/s]
  const T t12_1 = omega5_3 * T(0.1);
  const T t12_2 = omega5b_2 * T(0.1);
  const T Pdot12_1 = Pdot5a_1 + R5b_21 * t12_1 - R5_31 * t12_2;
  const T Pdot12_2 = Pdot5a_2 + R5b_22 * t12_1 - R5_32 * t12_2;
  const T Pdot12_3 = Pdot5a_3 + R5b_23 * t12_1 - R5_33 * t12_2;
  // line_tether_12 = -R5^T C12^T r_tether_ + E9^T r_tether_other_ + d9 - P12: from one end of the spring to the
  //   other, inertial axes [m]
  const T line_tether_12_1 = s9_1 - P12_1 + R5_11 * T(0.07071067811865477) - R5b_21 * T(0.02) - R5_31 *
      T(0.07071067811865477) + E9_11 * T(0.1);
  const T line_tether_12_2 = d9_2 - P12_2 + R5_12 * T(0.07071067811865477) - R5b_22 * T(0.02) - R5_32 *
      T(0.07071067811865477) + E9_12 * T(0.1);
  const T line_tether_12_3 = T(0.1) - P12_3 + R5_13 * T(0.07071067811865477) - R5b_23 * T(0.02) - R5_33 *
      T(0.07071067811865477);
  // ll_tether_12 = 1e-36 + line_tether_12 . line_tether_12: length squared [m^2]
  const T ll_tether_12 = T(1e-36) + line_tether_12_1 * line_tether_12_1 + line_tether_12_2 * line_tether_12_2 +
      line_tether_12_3 * line_tether_12_3;
  // length_tether_12 = ll_tether_12^1/2: length [m]
  const T length_tether_12 = sqrt(ll_tether_12);
  // line_rate_tether_12 = -R5^T omega5~ C12^T r_tether_ + E9^T omega9~ r_tether_other_ + Pdot9 - Pdot12: its rate
  //   [m/s]
  const T t12_3 = thetadot9 * T(0.1);
  const T t12_4 = omega5b_2 * T(0.07071067811865477);
  const T t12_5 = t12_4 - omega5_3 * T(0.02);
  const T t12_6 = omega5_3 * T(0.07071067811865477) + omega5_1 * T(0.07071067811865477);
  const T t12_7 = t12_4 + omega5_1 * T(0.02);
  const T line_rate_tether_12_1 = sdot9_1 - Pdot12_1 - E9_12 * t12_3 - R5_11 * t12_5 + R5b_21 * t12_6 - R5_31 * t12_7;
  const T line_rate_tether_12_2 = sdot9_2 - Pdot12_2 + R5b_22 * t12_6 - R5_12 * t12_5 - R5_32 * t12_7 + E9_11 * t12_3;
  const T minus_line_rate_tether_12_3 = Pdot12_3 + R5_13 * t12_5 - R5b_23 * t12_6 + R5_33 * t12_7;
  // f_tether_12 = k_tether_ - k_tether_ l_tether_ length_tether_12^-1 + c_tether_ line_tether_12 .
  //   line_rate_tether_12 ll_tether_12^-1: attraction by the length [N/m]
  const T f_tether_12 = c.p.k - T(1) / length_tether_12 * c.c9_1 + T(0.4) * (line_tether_12_1 * line_rate_tether_12_1
      + line_tether_12_2 * line_rate_tether_12_2 - line_tether_12_3 * minus_line_rate_tether_12_3) * (T(1) /
      ll_tether_12);
  // F_tether_12 = f_tether_12 line_tether_12: on the first end, inertial axes [N]
  const T F_tether_12_1 = f_tether_12 * line_tether_12_1;
  const T F_tether_12_2 = f_tether_12 * line_tether_12_2;
  const T F_tether_12_3 = f_tether_12 * line_tether_12_3;
  // Pddot12 = U5 q12 + Pddot5: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot12_1 = Pddot5_1 - minus_U5_11 * T(0.1);
  const T Pddot12_2 = Pddot5b_2 + U5_21 * T(0.1);
  const T Pddot12_3 = Pddot5_3 + U5_31 * T(0.1);
  // G9 = E9 F_tether_12 + m9 a9: inertia less applied force, body axes [N]
  const T t12_8 = E9_11 * F_tether_12_1 + E9_12 * F_tether_12_2;
  const T G9_1 = t12_8 + T(2) * a9_1;
  const T t12_9 = E9_11 * F_tether_12_2 - E9_12 * F_tether_12_1;
  const T G9_2 = t12_9 + T(2) * a9_2;
  const T G9_3 = F_tether_12_3 + T(19.62);
  reaction[48] = G9_1;
  reaction[49] = G9_2;
  reaction[50] = G9_3;
  // N9 = axial(U9 (tr(I9)/2 - I9)) + lever9~ E9 F_tether_12: inertia less applied moment about the mass centre, body
  //   axes [N m]
  const T minus_N9_1 = T(0.1) * t12_9;
  const T N9_2 = T(0.1) * t12_8;
  const T N9_3 = T(0.08) * thetaddot9;
  reaction[51] = -minus_N9_1;
  // a12 = U5 r_link12 + Pddot12: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a12_1 = Pddot12_1 + minus_U5_11 * T(0.03535533905932738) + U5_13 * T(0.03535533905932738);
  const T a12_2 = Pddot12_2 + U5_23 * T(0.03535533905932738) - U5_21 * T(0.03535533905932738);
  const T a12_3 = Pddot12_3 - U5_31 * T(0.03535533905932738) - minus_U5_33 * T(0.03535533905932738);
  // G12 = -R5 F_tether_12 + m12 a12: inertia less applied force, body axes [N]
  const T t12_10 = R5_11 * F_tether_12_1 + R5_12 * F_tether_12_2 + R5_13 * F_tether_12_3;
  const T G12_1 = c.p.m_plate * a12_1 - t12_10;
  const T t12_11 = R5b_21 * F_tether_12_1 + R5b_22 * F_tether_12_2 + R5b_23 * F_tether_12_3;
  const T G12_2 = c.p.m_plate * a12_2 - t12_11;
  const T t12_12 = R5_31 * F_tether_12_1 + R5_32 * F_tether_12_2 + R5_33 * F_tether_12_3;
  const T G12_3 = c.p.m_plate * a12_3 - t12_12;
  reaction[66] = G12_2;
  // N12 = axial(U5 (tr(I_link12)/2 - I_link12)) - lever12~ R5 F_tether_12: inertia less applied moment about the mass
  //   centre, body axes [N m]
  const T t12_13 = T(0.03535533905932738) * t12_11;
  const T N12_1 = t12_13 + T(0.002) * U5_32 - T(0.0020000000000000005) * U5_23 + T(0.0020000000000000005) * U5_21 -
      T(0.02) * t12_12;
  const T N12_2 = T(0.0020000000000000005) * U5_13 - T(0.0019999999999999996) * U5_31 - T(0.0020000000000000005) *
      (minus_U5_33 - minus_U5_11) - T(0.03535533905932738) * t12_10 - T(0.03535533905932738) * t12_12;
  const T N12_3 = t12_13 + T(0.0019999999999999996) * U5_21 - T(0.002) * U5_12 - T(0.0020000000000000005) * U5_23 +
      T(0.02) * t12_10;

  // ---- body 13 (ballast) on the inertial frame
  const T sddot13_1 = ydot[26], sddot13_2 = ydot[27], sddot13_3 = ydot[28];
  // Pddot13 = -g + sddot13: acceleration of the body origin, less gravity, inertial axes [m/s^2]
  const T Pddot13_3 = sddot13_3 + T(9.81);
  // G13 = m13 Pddot13: inertia less applied force, inertial axes [N]
  const T G13_1 = T(5) * sddot13_1;
  const T G13_2 = T(5) * sddot13_2;
  const T G13_3 = T(5) * Pddot13_3;
  reaction[73] = G13_2;

  // ---- body 12 (plate) and what it carries
  // rho12 = r_link12~ G12 + N12: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T b12_1 = T(0.03535533905932738) * G12_2;
  const T rho12_1 = N12_1 - b12_1;
  const T rho12_2 = N12_2 + T(0.03535533905932738) * G12_1 + T(0.03535533905932738) * G12_3;
  const T rho12_3 = N12_3 - b12_1;
  reaction[69] = rho12_2;

  // ---- body 11 (nut) and what it carries
  // rho11 = r_link11~ G11 + N11: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho11_1 = N11_1 - T(0.01) * G11_2;
  const T rho11_2 = N11_2 + T(0.01) * G11_1;
  reaction[64] = -rho11_1;
  reaction[65] = -rho11_2;

  // ---- body 10 (runner) and what it carries
  // r_omega10 = r10~ R10 G10 + N10: Kane's equation of omega [N m]
  const T b10_1 = R10_21 * G10_1 + R10_22 * G10_2 + R10_23 * G10_3;
  const T b10_2 = R10_31 * G10_1 + R10_32 * G10_2 + R10_33 * G10_3;
  const T r_omega10_1 = N10_1 + T(0.03) * b10_1 + T(0.01) * b10_2;
  const T b10_3 = R10_11 * G10_1 + R10_12 * G10_2 + R10_13 * G10_3;
  const T r_omega10_2 = N10_2 - T(0.03) * b10_3 - T(0.02) * b10_2;
  const T r_omega10_3 = N10_3 + T(0.02) * b10_1 - T(0.01) * b10_3;
  reaction[57] = r_omega10_1;
  reaction[58] = r_omega10_2;
  reaction[59] = r_omega10_3;

  // ---- body 9 (sled) and what it carries
  // rho9 = r9~ G9 + N9: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho9_2 = N9_2 - T(0.1) * G9_3;
  const T rho9_3 = T(0.1) * G9_2 + N9_3;
  reaction[52] = rho9_2;
  reaction[53] = rho9_3;

  // ---- body 8 (piston) and what it carries
  // S8 = E11^T G11 + G8: sum of the force balances of the subtree, body axes [N]
  const T b8_1 = E11_11 * G11_1 - E11_13 * G11_3;
  const T S8_1 = b8_1 + G8_1;
  const T S8_2 = G11_2 + G8_2;
  const T b8_2 = E11_13 * G11_1 + E11_11 * G11_3;
  const T S8_3 = b8_2 + G8_3;
  reaction[43] = -S8_1;
  reaction[44] = -S8_2;
  reaction[42] = S8_3;
  // rho8 = E11^T rho11 + r_link8~ G8 + d11~ E11^T G11 + N8: sum of the moment balances of the subtree about the body
  //   origin, body axes [N m]
  const T rho8_1 = N8_1 + E11_11 * rho11_1 - E11_13 * N11_3 - T(0.02) * G8_2 - T(0.1) * G8_3 - minus_d11_2 * b8_2;
  const T rho8_2 = rho11_2 + N8_2 + T(0.02) * G8_1 + T(0.01) * G8_3;
  const T rho8_3 = N8_3 + E11_13 * rho11_1 + E11_11 * N11_3 + T(0.1) * G8_1 - T(0.01) * G8_2 + minus_d11_2 * b8_1;
  reaction[46] = -rho8_1;
  reaction[47] = -rho8_2;
  reaction[45] = rho8_3;

  // ---- body 7 (gantry) and what it carries
  // rho7 = r7~ G7: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T minus_rho7_3 = T(0.1) * G7_1;
  reaction[41] = -minus_rho7_3;

  // ---- body 6 (telescope) and what it carries
  // rho6 = r6~ G6 + N6: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho6_1 = N6_1 - T(0.01) * G6_2;
  const T rho6_2 = N6_2 + T(0.01) * G6_1 - T(0.1) * G6_3;
  const T rho6_3 = N6_3 + T(0.1) * G6_2;
  reaction[33] = rho6_1;
  reaction[34] = rho6_2;
  reaction[35] = rho6_3;

  // ---- body 5 (camera) and what it carries
  // S5 = G5 + G12: sum of the force balances of the subtree, body axes [N]
  const T S5_1 = G12_1 + G5_1;
  const T S5_2 = G5_2 + G12_2;
  const T S5_3 = G5_3 + G12_3;
  reaction[24] = S5_1;
  reaction[25] = S5_2;
  reaction[26] = S5_3;
  // rho5 = q12~ G12 + r5~ G5 + N5 + rho12: sum of the moment balances of the subtree about the body origin, body axes
  //   [N m]
  const T rho5_1 = N5_1 + rho12_1;
  const T rho5_2 = N5_2 + rho12_2 - T(0.1) * G12_3 - T(0.05) * G5_3;
  const T rho5_3 = N5_3 + rho12_3 + T(0.1) * G12_2 + T(0.05) * G5_2;
  reaction[27] = rho5_1;
  reaction[28] = rho5_2;
  reaction[29] = rho5_3;
  // S5b = E5^T S5: sum of the force balances of the subtree, body axes [N]
  const T S5b_1 = c.E5_11 * S5_1 + c.E5_31 * S5_3;
  const T S5b_3 = c.E5_11 * S5_3 - c.E5_31 * S5_1;
  // rho5b = E5^T rho5: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5b_1 = c.E5_11 * rho5_1 + c.E5_31 * rho5_3;
  const T rho5b_3 = c.E5_11 * rho5_3 - c.E5_31 * rho5_1;
  // S5a = E5b^T S5b: sum of the force balances of the subtree, body axes [N]
  const T S5a_2 = E5b_22 * S5_2 - E5b_23 * S5b_3;
  const T S5a_3 = E5b_23 * S5_2 + E5b_22 * S5b_3;
  // rho5a = E5b^T rho5b: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho5a_2 = E5b_22 * rho5_2 - E5b_23 * rho5b_3;
  const T rho5a_3 = E5b_23 * rho5_2 + E5b_22 * rho5b_3;

  // ---- body 4 (cross) and what it carries
  // rho4 = r4~ G4 + N4: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho4_1 = N4_1 - T(0.1) * G4_2;
  const T rho4_2 = N4_2 + T(0.1) * G4_1 - T(0.03) * G4_3;
  const T rho4_3 = N4_3 + T(0.03) * G4_2;
  reaction[21] = rho4_1;
  reaction[22] = rho4_2;
  reaction[23] = rho4_3;
  // S4a = E4^T G4: sum of the force balances of the subtree, body axes [N]
  const T S4a_1 = t4_5 * G4_3 - minus_E4_11 * G4_1;
  const T S4a_2 = E4_12 * G4_1 + T(0.96) * G4_2 + E4_32 * G4_3;
  const T S4a_3 = T(0.28) * G4_2 - minus_E4_13 * G4_1 - minus_E4_33 * G4_3;
  // rho4a = E4^T rho4: sum of the moment balances of the subtree about the body origin, body axes [N m]
  const T rho4a_1 = t4_5 * rho4_3 - minus_E4_11 * rho4_1;
  const T rho4a_2 = E4_12 * rho4_1 + T(0.96) * rho4_2 + E4_32 * rho4_3;
  const T rho4a_3 = T(0.28) * rho4_2 - minus_E4_13 * rho4_1 - minus_E4_33 * rho4_3;

  // ---- body 3 (boom) and what it carries
  // S3 = G3 + G6: sum of the force balances of the subtree, body axes [N]
  const T S3_1 = G3_1 + G6_1;
  const T S3_2 = G3_2 + G6_2;
  const T S3_3 = G3_3 + G6_3;
  reaction[12] = S3_1;
  reaction[13] = S3_2;
  reaction[14] = S3_3;
  // rho3 = r3~ G3 + d6~ G6 + N3 + rho6: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho3_1 = N3_1 + rho6_1 + T(0.02) * G3_3;
  const T rho3_2 = N3_2 + rho6_2 - T(0.2) * G3_3 - d6_1 * G6_3;
  const T rho3_3 = N3_3 + rho6_3 + T(0.2) * G3_2 - T(0.02) * G3_1 + d6_1 * G6_2;
  reaction[15] = rho3_1;
  reaction[16] = rho3_2;
  reaction[17] = rho3_3;

  // ---- body 2 (clapper) and what it carries
  // r_omega2 = r2~ R2 G2 + N2: Kane's equation of omega [N m]
  const T b2_1 = R2_21 * G2_1 + R2_22 * G2_2 + R2_23 * G2_3;
  const T b2_2 = R2_31 * G2_1 + R2_32 * G2_2 + R2_33 * G2_3;
  const T r_omega2_1 = N2_1 + T(0.2) * b2_1 + T(0.02) * b2_2;
  const T b2_3 = R2_11 * G2_1 + R2_12 * G2_2 + R2_13 * G2_3;
  const T r_omega2_2 = N2_2 - T(0.2) * b2_3;
  const T r_omega2_3 = N2_3 - T(0.02) * b2_3;
  reaction[9] = r_omega2_1;
  reaction[10] = r_omega2_2;
  reaction[11] = r_omega2_3;

  // ---- body 1 (hull) and what it carries
  // S1 = R1 G2 + R1 G10 + E3^T S3 + E4a^T S4a + E5a^T S5a + E8^T S8 + G1: sum of the force balances of the subtree,
  //   body axes [N]
  const T b1_1 = R1_11 * G2_1 + R1_12 * G2_2 + R1_13 * G2_3;
  const T b1_2 = R1_11 * G10_1 + R1_12 * G10_2 + R1_13 * G10_3;
  const T b1_3 = E3_11 * S3_1 + E3_21 * S3_2 + E3_31 * S3_3;
  const T b1_4 = E4a_11 * S4a_1 + minus_E4a_12 * S4a_2 + minus_E4a_13 * S4a_3;
  const T b1_5 = E5a_11 * S5b_1 - E5a_12 * S5a_2;
  const T b1_6 = E8_11 * S8_1 - E8_13 * S8_3;
  const T S1_1 = b1_1 + b1_2 + b1_3 + b1_4 + b1_5 + b1_6 + G1_1;
  const T b1_7 = R1_21 * G2_1 + R1_22 * G2_2 + R1_23 * G2_3;
  const T b1_8 = R1_21 * G10_1 + R1_22 * G10_2 + R1_23 * G10_3;
  const T b1_9 = E3_12 * S3_1 + E3_22 * S3_2 + E3_32 * S3_3;
  const T b1_10 = E4a_22 * S4a_2 - minus_E4a_12 * S4a_1 + E4a_23 * S4a_3;
  const T b1_11 = E5a_12 * S5b_1 + E5a_11 * S5a_2;
  const T S1_2 = b1_7 + b1_8 + b1_9 + b1_10 + b1_11 + S8_2 + G1_2;
  const T b1_12 = R1_31 * G2_1 + R1_32 * G2_2 + R1_33 * G2_3;
  const T b1_13 = R1_31 * G10_1 + R1_32 * G10_2 + R1_33 * G10_3;
  const T b1_14 = E3_23 * S3_2 - minus_E3_13 * S3_1 + E3_33 * S3_3;
  const T b1_15 = E4a_23 * S4a_2 - minus_E4a_13 * S4a_1 + E4a_33 * S4a_3;
  const T b1_16 = E8_13 * S8_1 + E8_11 * S8_3;
  const T S1_3 = b1_12 + b1_13 + b1_14 + b1_15 + S5a_3 + b1_16 + G1_3;
  reaction[0] = S1_1;
  reaction[1] = S1_2;
  reaction[2] = S1_3;
  // r_omega1 = q2~ R1 G2 + q3~ E3^T S3 + E3^T rho3 + q4a~ E4a^T S4a + E4a^T rho4a + q5a~ E5a^T S5a + E5a^T rho5a +
  //   E8^T rho8 + r1~ G1 + d8~ E8^T S8 + d10~ R1 G10 + N1: Kane's equation of omega [N m]
  const T b1_17 = T(0.2) * b1_7;
  const T r_omega1_1 = b1_17 + N1_1 + T(0.1) * b1_12 - T(0.1) * b1_9 + E3_11 * rho3_1 + E3_21 * rho3_2 + E3_31 *
      rho3_3 + T(0.1) * b1_15 + E4a_11 * rho4a_1 + minus_E4a_12 * rho4a_2 + minus_E4a_13 * rho4a_3 - T(0.1) * b1_11 -
      T(0.3) * S5a_3 + E5a_11 * rho5b_1 - E5a_12 * rho5a_2 + E8_11 * rho8_1 - E8_13 * rho8_3 - T(0.03) * G1_2 -
      T(0.01) * G1_3 + d8_2 * b1_16 + s10 * b1_13 - T(0.3) * b1_8;
  const T r_omega1_2 = rho8_2 + N1_2 - T(0.2) * b1_1 - T(0.2) * b1_12 + T(0.1) * b1_3 - T(0.3) * b1_14 + E3_12 *
      rho3_1 + E3_22 * rho3_2 + E3_32 * rho3_3 + T(0.2) * b1_15 + E4a_22 * rho4a_2 - minus_E4a_12 * rho4a_1 + E4a_23 *
      rho4a_3 + T(0.1) * b1_5 + E5a_12 * rho5b_1 + E5a_11 * rho5a_2 + T(0.03) * G1_1 - T(0.02) * G1_3 + T(0.3) * b1_2
      - T(0.1) * b1_13;
  const T r_omega1_3 = b1_17 + rho5a_3 + N1_3 - T(0.1) * b1_1 + T(0.3) * b1_9 + E3_23 * rho3_2 - minus_E3_13 * rho3_1
      + E3_33 * rho3_3 - T(0.2) * b1_10 - T(0.1) * b1_4 + E4a_23 * rho4a_2 - minus_E4a_13 * rho4a_1 + E4a_33 * rho4a_3
      + T(0.3) * b1_5 + E8_13 * rho8_1 + E8_11 * rho8_3 + T(0.02) * G1_2 + T(0.01) * G1_1 - d8_2 * b1_6 + T(0.1) *
      b1_8 - s10 * b1_2;
  reaction[3] = r_omega1_1;
  reaction[4] = r_omega1_2;
  reaction[5] = r_omega1_3;

  // ---- results
  reaction[6] = b2_3;
  reaction[7] = b2_1;
  reaction[8] = b2_2;
  reaction[38] = T(29.43);
  reaction[39] = T(2.9430000000000005);
  reaction[40] = T(0);
  reaction[75] = T(0);
  reaction[76] = T(0);
  reaction[77] = T(0);
  reaction[54] = b10_3;
  reaction[55] = b10_1;
  reaction[56] = b10_2;
  const T t1 = T(0.7071067811865476) * G12_3;
  const T t2 = T(0.7071067811865476) * G12_1;
  reaction[67] = t1 - t2;
  reaction[68] = t2 + t1;
  const T t3 = T(0.7071067811865476) * rho12_3;
  const T t4 = T(0.7071067811865476) * rho12_1;
  reaction[70] = t3 - t4;
  reaction[71] = t4 + t3;
  reaction[72] = T(0.28) * G13_1 - T(0.96) * G13_3;
  reaction[74] = T(0.96) * G13_1 + T(0.28) * G13_3;
}

// probe_position: position of probe, inertial axes.
// (3) [m]
// 38 add, 53 multiply, 5 sine or cosine
template <class T>
void probe_position(const Prepared<T>& c, T t, const T* x, T* position) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hull) on the inertial frame
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

  // ---- body 5 (camera) on body 1
  const T theta5_1 = x[11];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cos(theta5_1);
  const T E5a_12 = sin(theta5_1);
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // theta5_2 = expression 1: prescribed
  const T theta5_2 = c.p.amplitude * sin(T(3) * t);
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = s1_1 + R1_31 * T(0.1) - R1_21 * T(0.3);
  const T P5a_2 = s1_2 + R1_32 * T(0.1) - R1_22 * T(0.3);
  const T P5a_3 = s1_3 + R1_33 * T(0.1) - R1_23 * T(0.3);

  // ---- results
  position[0] = P5a_1 + R5_21 * T(0.02) + T(0.03620228586010676) * R5a_11 + T(0.06743336618301184) * R5_31;
  position[1] = P5a_2 + R5_22 * T(0.02) + T(0.03620228586010676) * R5a_12 + T(0.06743336618301184) * R5_32;
  position[2] = P5a_3 + R5_23 * T(0.02) + T(0.03620228586010676) * R5a_13 + T(0.06743336618301184) * R5_33;
}

// probe_velocity: velocity of probe, inertial axes.
// (3) [m/s]
// 61 add, 89 multiply, 6 sine or cosine
template <class T>
void probe_velocity(const Prepared<T>& c, T t, const T* x, const T* y, T* velocity) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hull) on the inertial frame
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

  // ---- body 5 (camera) on body 1
  const T theta5_1 = x[11];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T thetadot5_1 = y[9];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cos(theta5_1);
  const T E5a_12 = sin(theta5_1);
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T theta5_2 = c.p.amplitude * sin(t5_1);
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_2 = omega1_3 * T(0.3) + omega1_2 * T(0.1);
  const T t5_3 = omega1_1 * T(0.1);
  const T t5_4 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_2 - R1_21 * t5_3 - R1_31 * t5_4;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_2 - R1_22 * t5_3 - R1_32 * t5_4;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_2 - R1_23 * t5_3 - R1_33 * t5_4;

  // ---- results
  const T t1 = omega5_2 * T(0.07741670784769467) - omega5_3 * T(0.02);
  const T t2 = omega5_3 * T(0.06329813066769584) + omega5_1 * T(0.07741670784769467);
  const T t3 = omega5_1 * T(0.02) + omega5_2 * T(0.06329813066769584);
  const T t4 = omega5_3 * T(0.09950041652780259) + omega5_1 * T(0.009983341664682815);
  const T t5 = omega5_2 * T(0.009983341664682815);
  const T t6 = omega5_2 * T(0.09950041652780259);
  velocity[0] = Pdot5a_1 + R5a_11 * t1 - R5_21 * t2 + R5_31 * t3 + R5_21 * t4 - R5a_11 * t5 - R5_31 * t6;
  velocity[1] = Pdot5a_2 - R5_22 * t2 + R5a_12 * t1 + R5_32 * t3 + R5_22 * t4 - R5a_12 * t5 - R5_32 * t6;
  velocity[2] = Pdot5a_3 + R5a_13 * t1 - R5_23 * t2 + R5_33 * t3 + R5_23 * t4 - R5a_13 * t5 - R5_33 * t6;
}

// probe_acceleration: acceleration of probe, inertial axes.
// (3) [m/s^2]
// 105 add, 140 multiply, 6 sine or cosine
template <class T>
void probe_acceleration(const Prepared<T>& c, T t, const T* x, const T* y, const T* ydot, T* acceleration) noexcept {
  using std::cos, std::sin;

  // ---- body 1 (hull) on the inertial frame
  const T eps1_1 = x[0], eps1_2 = x[1], eps1_3 = x[2], eps1_4 = x[3];
  const T omega1_1 = y[0], omega1_2 = y[1], omega1_3 = y[2];
  const T omegadot1_1 = ydot[0], omegadot1_2 = ydot[1], omegadot1_3 = ydot[2];
  const T sddot1_1 = ydot[16], sddot1_2 = ydot[17], sddot1_3 = ydot[18];
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
  const T U1_13 = omegadot1_2 + omega1_3 * omega1_1;
  const T t1_13 = omega1_1 * omega1_1;
  const T minus_U1_22 = t1_13 + omega1_3 * omega1_3;
  const T t1_14 = omega1_3 * omega1_2;
  const T U1_23 = t1_14 - omegadot1_1;
  const T U1_32 = t1_14 + omegadot1_1;
  const T minus_U1_33 = t1_13 + omega1_2 * omega1_2;
  // Pddot1 = R1 (-g + sddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t1_15 = sddot1_3 + T(9.81);
  const T Pddot1_1 = R1_11 * sddot1_1 + R1_12 * sddot1_2 + R1_13 * t1_15;
  const T Pddot1_2 = R1_21 * sddot1_1 + R1_22 * sddot1_2 + R1_23 * t1_15;
  const T Pddot1_3 = R1_31 * sddot1_1 + R1_32 * sddot1_2 + R1_33 * t1_15;

  // ---- body 5 (camera) on body 1
  const T theta5_1 = x[11];
  const T thetadot5_1 = y[9];
  const T thetaddot5_1 = ydot[9];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cos(theta5_1);
  const T E5a_12 = sin(theta5_1);
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T t5_2 = sin(t5_1);
  const T theta5_2 = c.p.amplitude * t5_2;
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // thetaddot5_2 = d^2/dt^2 expression 1: prescribed
  const T minus_thetaddot5_2 = t5_2 * T(3) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // omegadot5a = -thetadot5_1 b5_1~ E5a omega1 + thetaddot5_1 b5_1 + E5a omegadot1: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5a_1 = thetadot5_1 * omega5a_2 + E5a_11 * omegadot1_1 + E5a_12 * omegadot1_2;
  const T omegadot5a_2 = E5a_11 * omegadot1_2 - E5a_12 * omegadot1_1 - thetadot5_1 * omega5a_1;
  const T omegadot5a_3 = thetaddot5_1 + omegadot1_3;
  // Pddot5a = E5a (U1 q5a + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_3 = Pddot1_1 + U1_13 * T(0.1) - U1_12 * T(0.3);
  const T t5_4 = Pddot1_2 + minus_U1_22 * T(0.3) + U1_23 * T(0.1);
  const T Pddot5a_1 = E5a_11 * t5_3 + E5a_12 * t5_4;
  const T Pddot5a_2 = E5a_11 * t5_4 - E5a_12 * t5_3;
  const T Pddot5a_3 = Pddot1_3 - U1_32 * T(0.3) - minus_U1_33 * T(0.1);
  // omegadot5 = -thetadot5_2 b5_2~ E5 omega5a + thetaddot5_2 b5_2 + E5 omegadot5a: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5_1 = omegadot5a_1 - minus_thetaddot5_2;
  const T omegadot5_2 = thetadot5_2 * omega5_3 + E5_22 * omegadot5a_2 + E5_23 * omegadot5a_3;
  const T omegadot5_3 = E5_22 * omegadot5a_3 - E5_23 * omegadot5a_2 - thetadot5_2 * omega5_2;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_5 = omega5_3 * omega5_3;
  const T t5_6 = omega5_2 * omega5_2;
  const T minus_U5_11 = t5_5 + t5_6;
  const T t5_7 = omega5_2 * omega5_1;
  const T U5_12 = t5_7 - omegadot5_3;
  const T t5_8 = omega5_3 * omega5_1;
  const T U5_13 = t5_8 + omegadot5_2;
  const T U5_21 = t5_7 + omegadot5_3;
  const T t5_9 = omega5_1 * omega5_1;
  const T minus_U5_22 = t5_5 + t5_9;
  const T t5_10 = omega5_3 * omega5_2;
  const T U5_23 = t5_10 - omegadot5_1;
  const T U5_31 = t5_8 - omegadot5_2;
  const T U5_32 = t5_10 + omegadot5_1;
  const T minus_U5_33 = t5_6 + t5_9;
  // Pddot5 = E5 Pddot5a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_2 = E5_22 * Pddot5a_2 + E5_23 * Pddot5a_3;
  const T Pddot5_3 = E5_22 * Pddot5a_3 - E5_23 * Pddot5a_2;

  // ---- results
  const T t1 = minus_U5_11 * T(0.06329813066769584) + U5_12 * T(0.02) + U5_13 * T(0.07741670784769467);
  const T t2 = U5_23 * T(0.07741670784769467) - (U5_21 * T(0.06329813066769584) + minus_U5_22 * T(0.02));
  const T t3 = U5_32 * T(0.02) - U5_31 * T(0.06329813066769584) - minus_U5_33 * T(0.07741670784769467);
  const T t4 = U5_21 * T(0.09950041652780259) - U5_23 * T(0.009983341664682815);
  const T t5 = minus_U5_11 * T(0.09950041652780259) + U5_13 * T(0.009983341664682815);
  const T t6 = U5_31 * T(0.09950041652780259) + minus_U5_33 * T(0.009983341664682815);
  acceleration[0] = R5a_11 * t1 + R5_21 * t2 + R5_31 * t3 + R5_21 * t4 - R5a_11 * t5 + R5_31 * t6 + R5a_11 * Pddot5a_1
      + R5_21 * Pddot5_2 + R5_31 * Pddot5_3;
  acceleration[1] = R5a_12 * t1 + R5_22 * t2 + R5_32 * t3 + R5_22 * t4 - R5a_12 * t5 + R5_32 * t6 + R5a_12 * Pddot5a_1
      + R5_22 * Pddot5_2 + R5_32 * Pddot5_3;
  acceleration[2] = R5a_13 * t1 - T(9.81) + R5_23 * t2 + R5_33 * t3 + R5_23 * t4 - R5a_13 * t5 + R5_33 * t6 + R5a_13 *
      Pddot5a_1 + R5_23 * Pddot5_2 + R5_33 * Pddot5_3;
}

// probe_jacobian: partial velocities of probe, inertial axes.
// (3 x ny)
// 60 add, 97 multiply, 5 sine or cosine
template <class T>
void probe_jacobian(const Prepared<T>& c, T t, const T* x, T* jacobian) noexcept {
  using std::cos, std::sin;
  for (int i = 0; i < 87; ++i) jacobian[i] = T(0);

  // ---- body 1 (hull) on the inertial frame
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

  // ---- body 5 (camera) on body 1
  const T theta5_1 = x[11];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cos(theta5_1);
  const T E5a_12 = sin(theta5_1);
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // theta5_2 = expression 1: prescribed
  const T theta5_2 = c.p.amplitude * sin(T(3) * t);
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // P_omega1_5a = -R1^T q5a~: partial velocity of the body origin, inertial axes
  const T minus_P_omega1_5a_11 = R1_21 * T(0.1) + R1_31 * T(0.3);
  const T P_omega1_5a_12 = R1_11 * T(0.1);
  const T P_omega1_5a_13 = R1_11 * T(0.3);
  const T minus_P_omega1_5a_21 = R1_22 * T(0.1) + R1_32 * T(0.3);
  const T P_omega1_5a_22 = R1_12 * T(0.1);
  const T P_omega1_5a_23 = R1_12 * T(0.3);
  const T minus_P_omega1_5a_31 = R1_23 * T(0.1) + R1_33 * T(0.3);
  const T P_omega1_5a_32 = R1_13 * T(0.1);
  const T P_omega1_5a_33 = R1_13 * T(0.3);
  // omega_omega1_5 = E5 E5a: partial angular velocity, body axes
  const T minus_omega_omega1_5_21 = E5_22 * E5a_12;
  const T omega_omega1_5_22 = E5_22 * E5a_11;
  const T omega_omega1_5_31 = E5_23 * E5a_12;
  const T minus_omega_omega1_5_32 = E5_23 * E5a_11;

  // ---- results
  const T t1 = T(0.06743336618301184) * minus_omega_omega1_5_21 + T(0.02) * omega_omega1_5_31;
  const T t2 = T(0.06743336618301184) * E5a_11 - T(0.03620228586010676) * omega_omega1_5_31;
  const T t3 = T(0.03620228586010676) * minus_omega_omega1_5_21 + T(0.02) * E5a_11;
  jacobian[0] = -(minus_P_omega1_5a_11 + R5a_11 * t1 + R5_21 * t2 - R5_31 * t3);
  const T t4 = T(0.06743336618301184) * E5a_12 + T(0.03620228586010676) * minus_omega_omega1_5_32;
  const T t5 = T(0.06743336618301184) * omega_omega1_5_22 + T(0.02) * minus_omega_omega1_5_32;
  const T t6 = T(0.03620228586010676) * omega_omega1_5_22 - T(0.02) * E5a_12;
  jacobian[1] = -(R5_21 * t4 - R5a_11 * t5 + R5_31 * t6 - P_omega1_5a_12);
  const T t7 = T(0.02) * E5_22 - T(0.06743336618301184) * E5_23;
  const T t8 = T(0.03620228586010676) * E5_22;
  const T t9 = T(0.03620228586010676) * E5_23;
  const T t10 = R5a_11 * t7 - R5_21 * t8 + R5_31 * t9;
  jacobian[2] = -(t10 - P_omega1_5a_13);
  jacobian[9] = -t10;
  jacobian[16] = T(1);
  jacobian[46] = T(1);
  jacobian[76] = T(1);
  jacobian[29] = -(minus_P_omega1_5a_21 + R5a_12 * t1 + R5_22 * t2 - R5_32 * t3);
  jacobian[30] = -(R5_22 * t4 - R5a_12 * t5 + R5_32 * t6 - P_omega1_5a_22);
  const T t11 = R5a_12 * t7 - R5_22 * t8 + R5_32 * t9;
  jacobian[31] = -(t11 - P_omega1_5a_23);
  jacobian[38] = -t11;
  jacobian[58] = -(minus_P_omega1_5a_31 + R5a_13 * t1 + R5_23 * t2 - R5_33 * t3);
  jacobian[59] = -(R5_23 * t4 - R5a_13 * t5 + R5_33 * t6 - P_omega1_5a_32);
  const T t12 = R5a_13 * t7 - R5_23 * t8 + R5_33 * t9;
  jacobian[60] = -(t12 - P_omega1_5a_33);
  jacobian[67] = -t12;
}

// kinematics_and_accelerations: xdot, the kinematical equations; ydot from A ydot = f.
// xdot: rates of x (nx) [1/s], [rad/s], [m/s]
// ydot: rates of y (ny) [rad/s^2], [m/s^2]
// 1625 add, 1955 multiply, 14 divide, 1 square root, 19 sine or cosine, 3 other function
// by: articulated; composite would take 1691 add, 2059 multiply, 14 divide, 1 square root, 19 sine or cosine, 3 other
//   function
template <class T>
void kinematics_and_accelerations(const Prepared<T>& c, T t, const T* x, const T* y, const Inputs<T>& u, T* xdot, T*
    ydot) noexcept {
  using std::abs, std::cos, std::exp, std::sin, std::sqrt, std::tanh;
  T cosines[19], sines[19];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x + 8, 6, cosines + 8, sines + 8);
  cos_sin(x + 18, 1, cosines + 18, sines + 18);

  // ---- body 1 (hull) on the inertial frame
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
  const T minus_U1_22 = t1_15 + t1_13;
  const T U1_23 = omega1_3 * omega1_2;
  const T minus_U1_33 = t1_15 + t1_14;
  // a1 = U1 r1: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T t1_16 = U1_13 * T(0.03);
  const T t1_17 = U1_12 * T(0.01);
  const T a1_1 = t1_16 - t1_17 - minus_U1_11 * T(0.02);
  const T a1_2 = U1_12 * T(0.02) + minus_U1_22 * T(0.01) + U1_23 * T(0.03);
  const T t1_18 = U1_13 * T(0.02);
  const T t1_19 = U1_23 * T(0.01);
  const T a1_3 = t1_18 - t1_19 - minus_U1_33 * T(0.03);
  // G1 = R1 F1 - m1 a1: applied less inertia force, body axes [N]
  const T G1_1 = R1_13 * u.thrust - T(8) * a1_1;
  const T G1_2 = R1_23 * u.thrust - T(8) * a1_2;
  const T G1_3 = R1_33 * u.thrust - T(8) * a1_3;
  // N1 = -omega1~ I1 omega1 + M1: applied less inertia moment about the mass centre, body axes [N m]
  const T N1_1 = t1_17 + t1_18 + T(0.1) - T(0.19999999999999996) * U1_23 - T(0.03) * (t1_14 - t1_13);
  const T N1_2 = T(0.09999999999999998) * U1_13 + T(0.01) * (t1_13 - t1_15) - T(0.02) * U1_23 + T(0.03) * U1_12 +
      T(0.2) * cos(T(2) * t);
  const T minus_N1_3 = t1_16 + t1_19 + T(0.02) * (t1_15 - t1_14) - T(0.09999999999999998) * U1_12;

  // ---- body 2 (clapper) on body 1
  const T eps2_1 = x[4], eps2_2 = x[5], eps2_3 = x[6], eps2_4 = x[7];
  const T s1_1 = x[19], s1_2 = x[20], s1_3 = x[21];
  const T omega2_1 = y[3], omega2_2 = y[4], omega2_3 = y[5];
  // R2^T = 1 + 2 e2~ (eps4_2 + e2~): R takes inertial components to body components; e = (eps_1, eps_2, eps_3)
  const T t2_1 = T(2) * eps2_2;
  const T t2_2 = t2_1 * eps2_2;
  const T t2_3 = T(2) * eps2_3;
  const T t2_4 = t2_3 * eps2_3;
  const T R2_11 = T(1) - t2_2 - t2_4;
  const T t2_5 = T(2) * eps2_1;
  const T t2_6 = t2_5 * eps2_2;
  const T t2_7 = t2_3 * eps2_4;
  const T R2_12 = t2_6 + t2_7;
  const T t2_8 = t2_5 * eps2_3;
  const T t2_9 = t2_1 * eps2_4;
  const T R2_13 = t2_8 - t2_9;
  const T R2_21 = t2_6 - t2_7;
  const T t2_10 = T(1) - t2_5 * eps2_1;
  const T R2_22 = t2_10 - t2_4;
  const T t2_11 = t2_1 * eps2_3;
  const T t2_12 = t2_5 * eps2_4;
  const T R2_23 = t2_11 + t2_12;
  const T R2_31 = t2_8 + t2_9;
  const T R2_32 = t2_11 - t2_12;
  const T R2_33 = t2_10 - t2_2;
  // erel2 = -e1~ e2 + eps4_1 e2 - eps4_2 e1: Euler parameters relative to the lower body
  const T erel2_1 = eps1_3 * eps2_2 - eps1_2 * eps2_3 + eps1_4 * eps2_1 - eps2_4 * eps1_1;
  const T erel2_2 = eps1_1 * eps2_3 - eps1_3 * eps2_1 + eps1_4 * eps2_2 - eps2_4 * eps1_2;
  const T erel2_3 = eps1_2 * eps2_1 - eps1_1 * eps2_2 + eps1_4 * eps2_3 - eps2_4 * eps1_3;
  // eps4rel2 = e1 . e2 + eps4_1 eps4_2
  const T eps4rel2 = eps1_1 * eps2_1 + eps1_2 * eps2_2 + eps1_3 * eps2_3 + eps1_4 * eps2_4;
  // C2^T = 1 + 2 erel2~ (eps4rel2 + erel2~): C takes components in the lower body to those in the body
  const T t2_13 = T(2) * erel2_2;
  const T t2_14 = t2_13 * erel2_2;
  const T t2_15 = T(2) * erel2_3;
  const T t2_16 = t2_15 * erel2_3;
  const T C2_11 = T(1) - t2_14 - t2_16;
  const T t2_17 = T(2) * erel2_1;
  const T t2_18 = t2_17 * erel2_2;
  const T t2_19 = t2_15 * eps4rel2;
  const T C2_12 = t2_18 + t2_19;
  const T t2_20 = t2_17 * erel2_3;
  const T t2_21 = t2_13 * eps4rel2;
  const T C2_13 = t2_20 - t2_21;
  const T C2_21 = t2_18 - t2_19;
  const T t2_22 = T(1) - t2_17 * erel2_1;
  const T C2_22 = t2_22 - t2_16;
  const T t2_23 = t2_13 * erel2_3;
  const T t2_24 = t2_17 * eps4rel2;
  const T C2_23 = t2_23 + t2_24;
  const T C2_31 = t2_20 + t2_21;
  const T C2_32 = t2_23 - t2_24;
  const T C2_33 = t2_22 - t2_14;
  // P2 = s1 + R1^T q2: position of the body origin, inertial axes [m]
  const T P2_1 = s1_1 + R1_11 * T(0.2) + R1_21 * T(0.1) - R1_31 * T(0.2);
  const T P2_2 = s1_2 + R1_12 * T(0.2) + R1_22 * T(0.1) - R1_32 * T(0.2);
  const T P2_3 = s1_3 + R1_13 * T(0.2) + R1_23 * T(0.1) - R1_33 * T(0.2);
  // U2 = omega2~ omega2~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T U2_12 = omega2_2 * omega2_1;
  const T U2_13 = omega2_3 * omega2_1;
  const T t2_25 = omega2_1 * omega2_1;
  const T minus_U2_22 = t2_25 + omega2_3 * omega2_3;
  const T U2_23 = omega2_3 * omega2_2;
  const T minus_U2_33 = t2_25 + omega2_2 * omega2_2;
  // Pddot2 = C2 U1 q2: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t2_26 = U1_12 * T(0.1);
  const T t2_27 = minus_U1_11 * T(0.2);
  const T t2_28 = U1_13 * T(0.2);
  const T t2_29 = t2_26 - t2_27 - t2_28;
  const T t2_30 = U1_12 * T(0.2);
  const T t2_31 = minus_U1_22 * T(0.1);
  const T t2_32 = t2_30 - t2_31 - U1_23 * T(0.2);
  const T t2_33 = U1_23 * T(0.1);
  const T t2_34 = t2_28 + t2_33 + minus_U1_33 * T(0.2);
  const T Pddot2_1 = C2_11 * t2_29 + C2_12 * t2_32 + C2_13 * t2_34;
  const T Pddot2_2 = C2_21 * t2_29 + C2_22 * t2_32 + C2_23 * t2_34;
  const T Pddot2_3 = C2_31 * t2_29 + C2_32 * t2_32 + C2_33 * t2_34;
  // a2 = U2 r2 + Pddot2: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a2_1 = Pddot2_1 + U2_12 * T(0.02) - U2_13 * T(0.2);
  const T a2_2 = Pddot2_2 - minus_U2_22 * T(0.02) - U2_23 * T(0.2);
  const T a2_3 = Pddot2_3 + U2_23 * T(0.02) + minus_U2_33 * T(0.2);

  // ---- body 3 (boom) on body 1
  const T theta3 = x[8];
  const T thetadot3 = y[6];
  // E3^T = Z3^T Rot(b3, theta3): E takes components in the lower body to those in the body
  const T t3_1 = cosines[8];
  const T t3_2 = T(0.09939590364528633) + t3_1 * T(0.9006040963547137);
  const T t3_3 = sines[8];
  const T t3_4 = t3_3 * T(0.8388422987658062);
  const T t3_5 = T(0.1399135234046097) - t3_1 * T(0.1399135234046097);
  const T t3_6 = t3_4 - t3_5;
  const T t3_7 = T(0.2644627836810523) - t3_1 * T(0.2644627836810523);
  const T t3_8 = t3_3 * T(0.44378789320576517);
  const T t3_9 = t3_7 + t3_8;
  const T E3_11 = T(0.9362933635841992) * t3_2 + T(0.28962947762551555) * t3_6 - T(0.19866933079506122) * t3_9;
  const T E3_12 = T(0.9447024859948943) * t3_6 - T(0.31299182578546797) * t3_2 - T(0.09784339500725572) * t3_9;
  const T minus_E3_13 = T(0.1593450793079779) * t3_2 + T(0.1537919979889642) * t3_6 + T(0.9751703272018158) * t3_9;
  const T t3_10 = T(0.19694769415601157) + t3_1 * T(0.8030523058439885);
  const T t3_11 = t3_5 + t3_4;
  const T t3_12 = T(0.37226805650115813) - t3_1 * T(0.37226805650115813);
  const T t3_13 = t3_3 * T(0.3152711589176631);
  const T t3_14 = t3_12 - t3_13;
  const T E3_21 = T(0.28962947762551555) * t3_10 - T(0.9362933635841992) * t3_11 + T(0.19866933079506122) * t3_14;
  const T E3_22 = T(0.31299182578546797) * t3_11 + T(0.9447024859948943) * t3_10 + T(0.09784339500725572) * t3_14;
  const T E3_23 = T(0.1593450793079779) * t3_11 - T(0.1537919979889642) * t3_10 + T(0.9751703272018158) * t3_14;
  const T t3_15 = t3_8 - t3_7;
  const T t3_16 = t3_12 + t3_13;
  const T t3_17 = T(0.703656402198702) + t3_1 * T(0.29634359780129804);
  const T E3_31 = T(0.9362933635841992) * t3_15 + T(0.28962947762551555) * t3_16 + T(0.19866933079506122) * t3_17;
  const T E3_32 = T(0.9447024859948943) * t3_16 - T(0.31299182578546797) * t3_15 + T(0.09784339500725572) * t3_17;
  const T E3_33 = T(0.9751703272018158) * t3_17 - (T(0.1593450793079779) * t3_15 + T(0.1537919979889642) * t3_16);
  // R3^T = R1^T E3^T: R takes inertial components to body components
  const T R3_11 = R1_11 * E3_11 + R1_21 * E3_12 - R1_31 * minus_E3_13;
  const T R3_12 = R1_12 * E3_11 + R1_22 * E3_12 - R1_32 * minus_E3_13;
  const T R3_13 = R1_13 * E3_11 + R1_23 * E3_12 - R1_33 * minus_E3_13;
  const T R3_21 = R1_11 * E3_21 + R1_21 * E3_22 + R1_31 * E3_23;
  const T R3_22 = R1_12 * E3_21 + R1_22 * E3_22 + R1_32 * E3_23;
  const T R3_23 = R1_13 * E3_21 + R1_23 * E3_22 + R1_33 * E3_23;
  // omega3 = thetadot3 b3 + E3 omega1: absolute angular velocity, body axes [rad/s]
  const T t3_18 = E3_11 * omega1_1 + E3_12 * omega1_2 - minus_E3_13 * omega1_3;
  const T omega3_1 = t3_18 - thetadot3 * T(0.3152711589176631);
  const T t3_19 = E3_21 * omega1_1 + E3_22 * omega1_2 + E3_23 * omega1_3;
  const T omega3_2 = t3_19 + thetadot3 * T(0.44378789320576517);
  const T t3_20 = E3_31 * omega1_1 + E3_32 * omega1_2 + E3_33 * omega1_3;
  const T omega3_3 = t3_20 + thetadot3 * T(0.8388422987658062);
  // P3 = s1 + R1^T q3: position of the body origin, inertial axes [m]
  const T t3_21 = s1_1 + R1_31 * T(0.1);
  const T P3_1 = t3_21 + R1_11 * T(0.3);
  const T t3_22 = s1_2 + R1_32 * T(0.1);
  const T P3_2 = t3_22 + R1_12 * T(0.3);
  const T t3_23 = s1_3 + R1_33 * T(0.1);
  const T P3_3 = t3_23 + R1_13 * T(0.3);
  // omegadot3 = -thetadot3 b3~ E3 omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot3_1 = thetadot3 * (T(0.44378789320576517) * t3_20 - T(0.8388422987658062) * t3_19);
  const T minus_omegadot3_2 = thetadot3 * (T(0.8388422987658062) * t3_18 + T(0.3152711589176631) * t3_20);
  const T omegadot3_3 = thetadot3 * (T(0.3152711589176631) * t3_19 + T(0.44378789320576517) * t3_18);
  // U3 = omega3~ omega3~ + omegadot3~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t3_24 = omega3_3 * omega3_3;
  const T t3_25 = omega3_2 * omega3_2;
  const T minus_U3_11 = t3_24 + t3_25;
  const T t3_26 = omega3_2 * omega3_1;
  const T U3_12 = t3_26 - omegadot3_3;
  const T t3_27 = omega3_3 * omega3_1;
  const T U3_13 = t3_27 - minus_omegadot3_2;
  const T U3_21 = t3_26 + omegadot3_3;
  const T t3_28 = omega3_1 * omega3_1;
  const T minus_U3_22 = t3_24 + t3_28;
  const T t3_29 = omega3_3 * omega3_2;
  const T U3_23 = t3_29 + minus_omegadot3_1;
  const T U3_31 = t3_27 + minus_omegadot3_2;
  const T U3_32 = t3_29 - minus_omegadot3_1;
  const T minus_U3_33 = t3_25 + t3_28;
  // Pddot3 = E3 U1 q3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t3_30 = U1_13 * T(0.1);
  const T t3_31 = t3_30 - minus_U1_11 * T(0.3);
  const T t3_32 = U1_12 * T(0.3);
  const T t3_33 = t3_32 + t2_33;
  const T t3_34 = minus_U1_33 * T(0.1);
  const T t3_35 = U1_13 * T(0.3) - t3_34;
  const T Pddot3_1 = E3_11 * t3_31 + E3_12 * t3_33 - minus_E3_13 * t3_35;
  const T Pddot3_2 = E3_21 * t3_31 + E3_22 * t3_33 + E3_23 * t3_35;
  const T Pddot3_3 = E3_31 * t3_31 + E3_32 * t3_33 + E3_33 * t3_35;
  // stretch_boom_3 = theta3 - l_boom_: stretch of the spring
  const T stretch_boom_3 = theta3 - T(0.2);
  // effort_boom_3 = -thetadot3 c_boom_ + tau_boom_ - stretch_boom_3 k_boom_: along the coordinate [N m], [N]
  const T effort_boom_3 = u.motor - T(0.1) * tanh(thetadot3 * T(100)) - thetadot3 * T(0.5) - c.p.k * stretch_boom_3;
  // G2 = -R2 R3^T F_jet_ - m2 a2: applied less inertia force, body axes [N]
  const T t3_36 = T(0.5) * u.thrust * exp(T(0) - t);
  const T t3_37 = R3_11 * T(0.1) + R3_21 * t3_36;
  const T t3_38 = R3_12 * T(0.1) + R3_22 * t3_36;
  const T t3_39 = R3_13 * T(0.1) + R3_23 * t3_36;
  const T t3_40 = R2_11 * t3_37 + R2_12 * t3_38 + R2_13 * t3_39;
  const T minus_G2_1 = t3_40 + T(0.8) * a2_1;
  const T t3_41 = R2_21 * t3_37 + R2_22 * t3_38 + R2_23 * t3_39;
  const T minus_G2_2 = t3_41 + T(0.8) * a2_2;
  const T t3_42 = R2_31 * t3_37 + R2_32 * t3_38 + R2_33 * t3_39;
  const T minus_G2_3 = t3_42 + T(0.8) * a2_3;
  // a3 = U3 r3 + Pddot3: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a3_1 = Pddot3_1 + U3_12 * T(0.02) - minus_U3_11 * T(0.2);
  const T a3_2 = Pddot3_2 + U3_21 * T(0.2) - minus_U3_22 * T(0.02);
  const T a3_3 = Pddot3_3 + U3_31 * T(0.2) + U3_32 * T(0.02);
  // G3 = -m3 a3: applied less inertia force, body axes [N]
  const T minus_G3_1 = T(1.5) * a3_1;
  const T minus_G3_2 = T(1.5) * a3_2;
  const T minus_G3_3 = T(1.5) * a3_3;
  // N3 = -axial(U3 (tr(I3)/2 - I3)): applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N3_1 = T(0.004999999999999999) * U3_32 - T(0.035) * U3_23 + T(0.003) * (minus_U3_22 - minus_U3_33) -
      T(0.002) * U3_31 + T(0.001) * U3_21;
  const T minus_N3_2 = T(0.035) * U3_13 - T(0.015000000000000001) * U3_31 - T(0.001) * (minus_U3_33 - minus_U3_11) +
      T(0.003) * U3_12 + T(0.002) * U3_32;
  const T minus_N3_3 = T(0.015000000000000001) * U3_21 - T(0.004999999999999999) * U3_12 - T(0.002) * (minus_U3_11 -
      minus_U3_22) - T(0.001) * U3_23 - T(0.003) * U3_13;

  // ---- body 4 (cross) on body 1
  const T thetadot4_1 = y[7], thetadot4_2 = y[8];
  // E4a^T = Rot(b4_1, theta4_1): E takes components in the lower body to those in the body
  const T t4_1 = cosines[9];
  const T E4a_11 = T(5.329070518200751e-17) + t4_1 * T(1);
  const T t4_2 = sines[9];
  const T minus_E4a_12 = t4_2 * T(0.96);
  const T minus_E4a_13 = t4_2 * T(0.28);
  const T E4a_22 = T(0.07840000000000007) + t4_1 * T(0.9216);
  const T E4a_23 = t4_1 * T(0.26880000000000004) - T(0.26880000000000004);
  const T E4a_33 = T(0.9216) + t4_1 * T(0.07840000000000001);
  // omega4a = thetadot4_1 b4_1 + E4a omega1: absolute angular velocity, body axes [rad/s]
  const T omega4a_1 = E4a_11 * omega1_1 - minus_E4a_12 * omega1_2 - minus_E4a_13 * omega1_3;
  const T t4_3 = minus_E4a_12 * omega1_1 + E4a_22 * omega1_2 + E4a_23 * omega1_3;
  const T omega4a_2 = t4_3 + thetadot4_1 * T(0.28);
  const T t4_4 = minus_E4a_13 * omega1_1 + E4a_23 * omega1_2 + E4a_33 * omega1_3;
  const T omega4a_3 = t4_4 - thetadot4_1 * T(0.96);
  // E4^T = Z4^T Rot(b4_2, theta4_2): E takes components in the lower body to those in the body
  const T minus_E4_11 = sines[10];
  const T t4_5 = cosines[10];
  const T E4_12 = T(0.28) * t4_5;
  const T minus_E4_13 = T(0.96) * t4_5;
  const T E4_32 = T(0.28) * minus_E4_11;
  const T minus_E4_33 = T(0.96) * minus_E4_11;
  // omega4 = thetadot4_2 b4_2 + E4 omega4a: absolute angular velocity, body axes [rad/s]
  const T omega4_1 = E4_12 * omega4a_2 - minus_E4_11 * omega4a_1 - minus_E4_13 * omega4a_3;
  const T omega4_2 = thetadot4_2 + T(0.96) * omega4a_2 + T(0.28) * omega4a_3;
  const T omega4_3 = t4_5 * omega4a_1 + E4_32 * omega4a_2 - minus_E4_33 * omega4a_3;
  // omegadot4a = -thetadot4_1 b4_1~ E4a omega1: angular acceleration, body axes [rad/s^2]
  const T minus_omegadot4a_1 = thetadot4_1 * (T(0.96) * t4_3 + T(0.28) * t4_4);
  const T omegadot4a_2 = T(0.96) * omega4a_1 * thetadot4_1;
  const T omegadot4a_3 = T(0.28) * omega4a_1 * thetadot4_1;
  // Pddot4a = E4a U1 q4a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t4_6 = t2_27 + t2_26;
  const T t4_7 = t2_30 + t2_31;
  const T t4_8 = t2_33 - t2_28;
  const T Pddot4a_1 = E4a_11 * t4_6 + minus_E4a_12 * t4_7 - minus_E4a_13 * t4_8;
  const T Pddot4a_2 = minus_E4a_12 * t4_6 - E4a_22 * t4_7 + E4a_23 * t4_8;
  const T Pddot4a_3 = minus_E4a_13 * t4_6 - E4a_23 * t4_7 + E4a_33 * t4_8;
  // omegadot4 = -thetadot4_2 b4_2~ E4 omega4a + E4 omegadot4a: angular acceleration, body axes [rad/s^2]
  const T omegadot4_1 = minus_E4_11 * minus_omegadot4a_1 + E4_12 * omegadot4a_2 - minus_E4_13 * omegadot4a_3 -
      thetadot4_2 * omega4_3;
  const T omegadot4_2 = T(0.96) * omegadot4a_2 + T(0.28) * omegadot4a_3;
  const T omegadot4_3 = thetadot4_2 * omega4_1 + E4_32 * omegadot4a_2 - t4_5 * minus_omegadot4a_1 - minus_E4_33 *
      omegadot4a_3;
  // U4 = omega4~ omega4~ + omegadot4~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t4_9 = omega4_2 * omega4_2;
  const T minus_U4_11 = t4_9 + omega4_3 * omega4_3;
  const T t4_10 = omega4_2 * omega4_1;
  const T U4_12 = t4_10 - omegadot4_3;
  const T t4_11 = omega4_3 * omega4_1;
  const T U4_13 = t4_11 + omegadot4_2;
  const T U4_21 = t4_10 + omegadot4_3;
  const T t4_12 = omega4_3 * omega4_2;
  const T U4_23 = t4_12 - omegadot4_1;
  const T U4_31 = t4_11 - omegadot4_2;
  const T U4_32 = t4_12 + omegadot4_1;
  const T minus_U4_33 = t4_9 + omega4_1 * omega4_1;
  // Pddot4 = E4 Pddot4a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot4_1 = E4_12 * Pddot4a_2 - minus_E4_11 * Pddot4a_1 - minus_E4_13 * Pddot4a_3;
  const T Pddot4_2 = T(0.96) * Pddot4a_2 + T(0.28) * Pddot4a_3;
  const T Pddot4_3 = t4_5 * Pddot4a_1 + E4_32 * Pddot4a_2 - minus_E4_33 * Pddot4a_3;
  // a4 = U4 r4 + Pddot4: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a4_1 = Pddot4_1 + U4_13 * T(0.1) - minus_U4_11 * T(0.03);
  const T a4_2 = Pddot4_2 + U4_21 * T(0.03) + U4_23 * T(0.1);
  const T a4_3 = Pddot4_3 + U4_31 * T(0.03) - minus_U4_33 * T(0.1);
  // G4 = -m4 a4: applied less inertia force, body axes [N]
  const T minus_G4_1 = T(0.9) * a4_1;
  const T minus_G4_2 = T(0.9) * a4_2;
  const T minus_G4_3 = T(0.9) * a4_3;
  // N4 = -axial(U4 (tr(I4)/2 - I4)): applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N4_1 = T(0.006500000000000001) * U4_32 - T(0.0015) * U4_23;
  const T minus_N4_2 = T(0.0015) * U4_13 - T(0.0055) * U4_31;
  const T minus_N4_3 = T(0.0055) * U4_21 - T(0.006500000000000001) * U4_12;

  // ---- body 5 (camera) on body 1
  const T thetadot5_1 = y[9];
  const T sdot1_1 = y[16], sdot1_2 = y[17], sdot1_3 = y[18];
  // E5a^T = Rot(b5_1, theta5_1): E takes components in the lower body to those in the body
  const T E5a_11 = cosines[11];
  const T E5a_12 = sines[11];
  // R5a^T = R1^T E5a^T: R takes inertial components to body components
  const T R5a_11 = R1_11 * E5a_11 + R1_21 * E5a_12;
  const T R5a_12 = R1_12 * E5a_11 + R1_22 * E5a_12;
  const T R5a_13 = R1_13 * E5a_11 + R1_23 * E5a_12;
  const T R5a_21 = R1_21 * E5a_11 - R1_11 * E5a_12;
  const T R5a_22 = R1_22 * E5a_11 - R1_12 * E5a_12;
  const T R5a_23 = R1_23 * E5a_11 - R1_13 * E5a_12;
  // omega5a = thetadot5_1 b5_1 + E5a omega1: absolute angular velocity, body axes [rad/s]
  const T omega5a_1 = E5a_11 * omega1_1 + E5a_12 * omega1_2;
  const T omega5a_2 = E5a_11 * omega1_2 - E5a_12 * omega1_1;
  const T omega5a_3 = thetadot5_1 + omega1_3;
  // theta5_2 = expression 1: prescribed
  const T t5_1 = T(3) * t;
  const T t5_2 = sin(t5_1);
  const T theta5_2 = c.p.amplitude * t5_2;
  // thetadot5_2 = d/dt expression 1: prescribed
  const T thetadot5_2 = cos(t5_1) * T(3) * c.p.amplitude;
  // thetaddot5_2 = d^2/dt^2 expression 1: prescribed
  const T minus_thetaddot5_2 = t5_2 * T(3) * T(3) * c.p.amplitude;
  // E5^T = Rot(b5_2, theta5_2): E takes components in the lower body to those in the body
  const T E5_22 = cos(theta5_2);
  const T E5_23 = sin(theta5_2);
  // R5^T = R5a^T E5^T: R takes inertial components to body components
  const T R5_21 = R5a_21 * E5_22 + R1_31 * E5_23;
  const T R5_22 = R5a_22 * E5_22 + R1_32 * E5_23;
  const T R5_23 = R5a_23 * E5_22 + R1_33 * E5_23;
  const T R5_31 = R1_31 * E5_22 - R5a_21 * E5_23;
  const T R5_32 = R1_32 * E5_22 - R5a_22 * E5_23;
  const T R5_33 = R1_33 * E5_22 - R5a_23 * E5_23;
  // omega5 = thetadot5_2 b5_2 + E5 omega5a: absolute angular velocity, body axes [rad/s]
  const T omega5_1 = omega5a_1 + thetadot5_2;
  const T omega5_2 = E5_22 * omega5a_2 + E5_23 * omega5a_3;
  const T omega5_3 = E5_22 * omega5a_3 - E5_23 * omega5a_2;
  // P5a = s1 + R1^T q5a: position of the body origin, inertial axes [m]
  const T P5a_1 = t3_21 - R1_21 * T(0.3);
  const T P5a_2 = t3_22 - R1_22 * T(0.3);
  const T P5a_3 = t3_23 - R1_23 * T(0.3);
  // Pdot5a = sdot1 + R1^T omega1~ q5a: velocity of the body origin, inertial axes [m/s]
  const T t5_3 = omega1_2 * T(0.1);
  const T t5_4 = omega1_3 * T(0.3) + t5_3;
  const T t5_5 = omega1_1 * T(0.1);
  const T t5_6 = omega1_1 * T(0.3);
  const T Pdot5a_1 = sdot1_1 + R1_11 * t5_4 - R1_21 * t5_5 - R1_31 * t5_6;
  const T Pdot5a_2 = sdot1_2 + R1_12 * t5_4 - R1_22 * t5_5 - R1_32 * t5_6;
  const T Pdot5a_3 = sdot1_3 + R1_13 * t5_4 - R1_23 * t5_5 - R1_33 * t5_6;
  // omegadot5a = -thetadot5_1 b5_1~ E5a omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot5a_1 = thetadot5_1 * omega5a_2;
  const T minus_omegadot5a_2 = thetadot5_1 * omega5a_1;
  // Pddot5a = E5a U1 q5a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t5_7 = t3_30 - t3_32;
  const T t5_8 = t2_33 + minus_U1_22 * T(0.3);
  const T Pddot5a_1 = E5a_11 * t5_7 + E5a_12 * t5_8;
  const T Pddot5a_2 = E5a_11 * t5_8 - E5a_12 * t5_7;
  const T minus_Pddot5a_3 = t3_34 + U1_23 * T(0.3);
  // omegadot5 = -thetadot5_2 b5_2~ E5 omega5a + thetaddot5_2 b5_2 + E5 omegadot5a: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot5_1 = omegadot5a_1 - minus_thetaddot5_2;
  const T omegadot5_2 = thetadot5_2 * omega5_3 - E5_22 * minus_omegadot5a_2;
  const T omegadot5_3 = E5_23 * minus_omegadot5a_2 - thetadot5_2 * omega5_2;
  // U5 = omega5~ omega5~ + omegadot5~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t5_9 = omega5_2 * omega5_2;
  const T minus_U5_11 = omega5_3 * omega5_3 + t5_9;
  const T t5_10 = omega5_2 * omega5_1;
  const T U5_12 = t5_10 - omegadot5_3;
  const T t5_11 = omega5_3 * omega5_1;
  const T U5_13 = t5_11 + omegadot5_2;
  const T U5_21 = t5_10 + omegadot5_3;
  const T t5_12 = omega5_3 * omega5_2;
  const T U5_23 = t5_12 - omegadot5_1;
  const T U5_31 = t5_11 - omegadot5_2;
  const T U5_32 = t5_12 + omegadot5_1;
  const T minus_U5_33 = t5_9 + omega5_1 * omega5_1;
  // Pddot5 = E5 Pddot5a: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot5_2 = E5_22 * Pddot5a_2 - E5_23 * minus_Pddot5a_3;
  const T minus_Pddot5_3 = E5_23 * Pddot5a_2 + E5_22 * minus_Pddot5a_3;
  // a5 = U5 r_link5 + Pddot5: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a5_1 = Pddot5a_1 + U5_13 * c.r_link5_3 - minus_U5_11 * c.r_link5_1;
  const T a5_2 = Pddot5_2 + U5_21 * c.r_link5_1 + U5_23 * c.r_link5_3;
  const T a5_3 = U5_31 * c.r_link5_1 - minus_Pddot5_3 - minus_U5_33 * c.r_link5_3;

  // ---- body 6 (telescope) on body 3
  const T s6 = x[22];
  const T sdot6 = y[19];
  // d6 = q6 + s6 u6: joint offset q + s, axes of the lower body [m]
  const T d6_1 = T(0.4) + s6;
  // P6 = R3^T d6 + P3: position of the body origin, inertial axes [m]
  const T P6_1 = P3_1 + R3_11 * d6_1;
  const T P6_2 = P3_2 + R3_12 * d6_1;
  const T P6_3 = P3_3 + R3_13 * d6_1;
  // Pddot6 = 2 sdot6 omega3~ u6 + U3 d6 + Pddot3: acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot6_1 = Pddot3_1 - minus_U3_11 * d6_1;
  const T t6_1 = T(2) * sdot6;
  const T Pddot6_2 = Pddot3_2 + t6_1 * omega3_3 + U3_21 * d6_1;
  const T Pddot6_3 = Pddot3_3 + U3_31 * d6_1 - t6_1 * omega3_2;
  // effort_telescope_6 = -sdot6 c_telescope_: along the coordinate [N m], [N]
  const T minus_effort_telescope_6 = sdot6 * (T(2) + abs(sdot6));
  // arm2 = R2 R3^T r_jet_ - R2 P2 + R2 P6
  const T t6_2 = R3_11 * T(0.2);
  const T t6_3 = R3_12 * T(0.2);
  const T t6_4 = R3_13 * T(0.2);
  const T arm2_1 = R2_11 * t6_2 + R2_12 * t6_3 + R2_13 * t6_4 - R2_11 * P2_1 - R2_12 * P2_2 - R2_13 * P2_3 + R2_11 *
      P6_1 + R2_12 * P6_2 + R2_13 * P6_3;
  const T arm2_2 = R2_21 * t6_2 + R2_22 * t6_3 + R2_23 * t6_4 - R2_21 * P2_1 - R2_22 * P2_2 - R2_23 * P2_3 + R2_21 *
      P6_1 + R2_22 * P6_2 + R2_23 * P6_3;
  const T arm2_3 = R2_31 * t6_2 + R2_32 * t6_3 + R2_33 * t6_4 - R2_31 * P2_1 - R2_32 * P2_2 - R2_33 * P2_3 + R2_31 *
      P6_1 + R2_32 * P6_2 + R2_33 * P6_3;
  // lever2 = -r2 + arm2: from the reference point to where a force acts, link axes [m]
  const T lever2_2 = arm2_2 - T(0.02);
  const T lever2_3 = arm2_3 + T(0.2);
  // N2 = -omega2~ I2 omega2 - lever2~ R2 R3^T F_jet_: applied less inertia moment about the mass centre, body axes [N
  //   m]
  const T minus_N2_1 = lever2_2 * t3_42 - lever2_3 * t3_41 - T(0.006999999999999999) * U2_23;
  const T minus_N2_2 = T(0.006) * U2_13 + lever2_3 * t3_40 - arm2_1 * t3_42;
  const T minus_N2_3 = T(0.0009999999999999992) * U2_12 + arm2_1 * t3_41 - lever2_2 * t3_40;
  // a6 = U3 r6 + Pddot6: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a6_1 = Pddot6_1 + U3_13 * T(0.01) - minus_U3_11 * T(0.1);
  const T a6_2 = Pddot6_2 + U3_21 * T(0.1) + U3_23 * T(0.01);
  const T a6_3 = Pddot6_3 + U3_31 * T(0.1) - minus_U3_33 * T(0.01);
  // G6 = -m6 a6 + F_jet_: applied less inertia force, body axes [N]
  const T G6_1 = T(0.1) - T(0.5) * a6_1;
  const T G6_2 = t3_36 - T(0.5) * a6_2;
  const T minus_G6_3 = T(0.5) * a6_3;
  // N6 = -axial(U3 (tr(I6)/2 - I6)) + lever6~ F_jet_: applied less inertia moment about the mass centre, body axes [N
  //   m]
  const T N6_1 = T(5e-04) * U3_23 - T(5e-04) * U3_32 + T(0.01) * t3_36;
  const T minus_N6_2 = T(0.001) + T(5e-04) * U3_13 - T(0.0055) * U3_31;
  const T N6_3 = T(5e-04) * U3_12 - T(0.0055) * U3_21 + T(0.1) * t3_36;

  // ---- body 8 (piston) on body 1
  const T s8 = x[25];
  const T thetadot8 = y[10];
  const T sdot8 = y[22];
  // E8^T = Rot(b8, theta8): E takes components in the lower body to those in the body
  const T E8_11 = cosines[12];
  const T E8_13 = sines[12];
  // omega8 = thetadot8 b8 + E8 omega1: absolute angular velocity, body axes [rad/s]
  const T omega8_1 = E8_11 * omega1_1 + E8_13 * omega1_3;
  const T omega8_2 = omega1_2 - thetadot8;
  const T omega8_3 = E8_11 * omega1_3 - E8_13 * omega1_1;
  // d8 = q8 + s8 u8: joint offset q + s, axes of the lower body [m]
  const T d8_2 = T(0.25) - s8;
  // omegadot8 = -thetadot8 b8~ E8 omega1: angular acceleration, body axes [rad/s^2]
  const T omegadot8_1 = thetadot8 * omega8_3;
  const T minus_omegadot8_3 = thetadot8 * omega8_1;
  // U8 = omega8~ omega8~ + omegadot8~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T t8_1 = omega8_3 * omega8_3;
  const T t8_2 = omega8_2 * omega8_2;
  const T minus_U8_11 = t8_1 + t8_2;
  const T t8_3 = omega8_2 * omega8_1;
  const T U8_12 = t8_3 + minus_omegadot8_3;
  const T U8_13 = omega8_3 * omega8_1;
  const T U8_21 = t8_3 - minus_omegadot8_3;
  const T t8_4 = omega8_1 * omega8_1;
  const T minus_U8_22 = t8_1 + t8_4;
  const T t8_5 = omega8_3 * omega8_2;
  const T U8_23 = t8_5 - omegadot8_1;
  const T U8_32 = t8_5 + omegadot8_1;
  const T minus_U8_33 = t8_2 + t8_4;
  // Pddot8 = E8 omega1~ (omega1~ d8 + 2 sdot8 u8): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t8_6 = T(2) * sdot8;
  const T t8_7 = omega1_1 * d8_2;
  const T t8_8 = t8_6 * omega1_3 + omega1_2 * t8_7;
  const T t8_9 = omega1_3 * d8_2;
  const T t8_10 = omega1_2 * t8_9 - t8_6 * omega1_1;
  const T Pddot8_1 = E8_11 * t8_8 + E8_13 * t8_10;
  const T minus_Pddot8_2 = omega1_3 * t8_9 + omega1_1 * t8_7;
  const T Pddot8_3 = E8_11 * t8_10 - E8_13 * t8_8;
  // a8 = U8 r_link8 + Pddot8: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a8_1 = Pddot8_1 + minus_U8_11 * T(0.01) - U8_12 * T(0.1) + U8_13 * T(0.02);
  const T a8_2 = minus_U8_22 * T(0.1) - minus_Pddot8_2 - U8_21 * T(0.01) + U8_23 * T(0.02);
  const T a8_3 = Pddot8_3 - U8_13 * T(0.01) - U8_32 * T(0.1) - minus_U8_33 * T(0.02);
  // G8 = -m8 a8: applied less inertia force, body axes [N]
  const T minus_G8_1 = T(0.7) * a8_1;
  const T minus_G8_2 = T(0.7) * a8_2;
  const T minus_G8_3 = T(0.7) * a8_3;
  // N8 = -axial(U8 (tr(I_link8)/2 - I_link8)): applied less inertia moment about the mass centre, body axes [N m]
  const T minus_N8_1 = T(0.0025) * U8_32 - T(5e-04) * U8_23;
  const T N8_2 = T(0.001) * U8_13;
  const T minus_N8_3 = T(0.0015) * U8_21 - T(0.0025) * U8_12;

  // ---- body 9 (sled) on the inertial frame
  const T s9_1 = x[26], s9_2 = x[27];
  const T thetadot9 = y[11];
  const T sdot9_1 = y[23], sdot9_2 = y[24];
  // E9^T = Rot(b9, theta9): E takes components in the lower body to those in the body
  const T E9_11 = cosines[13];
  const T E9_12 = sines[13];
  // d9 = q9 + s9_1 u9_1 + s9_2 u9_2: joint offset q + s, axes of the lower body [m]
  const T d9_2 = T(1) + s9_2;
  // U9 = omega9~ omega9~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T minus_U9_11 = thetadot9 * thetadot9;
  // line_tether_9 = -R5^T C12^T r_tether_ - R5^T o5 + E9^T r_tether_other_ - P5a + d9: from one end of the spring to
  //   the other, inertial axes [m]
  const T line_tether_9_1 = s9_1 - P5a_1 + E9_11 * T(0.1) - R5_21 * T(0.02) - T(0.03620228586010676) * R5a_11 -
      T(0.06743336618301184) * R5_31;
  const T line_tether_9_2 = d9_2 - P5a_2 + E9_12 * T(0.1) - R5_22 * T(0.02) - T(0.03620228586010676) * R5a_12 -
      T(0.06743336618301184) * R5_32;
  const T line_tether_9_3 = T(0.1) - P5a_3 - R5_23 * T(0.02) - T(0.03620228586010676) * R5a_13 -
      T(0.06743336618301184) * R5_33;
  // ll_tether_9 = 1e-36 + line_tether_9 . line_tether_9: length squared [m^2]
  const T ll_tether_9 = T(1e-36) + line_tether_9_1 * line_tether_9_1 + line_tether_9_2 * line_tether_9_2 +
      line_tether_9_3 * line_tether_9_3;
  // length_tether_9 = ll_tether_9^1/2: length [m]
  const T length_tether_9 = sqrt(ll_tether_9);
  // line_rate_tether_9 = -R5^T omega5~ C12^T r_tether_ - R5^T omega5~ o5 + E9^T omega9~ r_tether_other_ - Pdot5a +
  //   Pdot9: its rate [m/s]
  const T t9_1 = thetadot9 * T(0.1);
  const T t9_2 = omega5_2 * T(0.07741670784769467) - omega5_3 * T(0.02);
  const T t9_3 = omega5_3 * T(0.06329813066769584) + omega5_1 * T(0.07741670784769467);
  const T t9_4 = omega5_1 * T(0.02) + omega5_2 * T(0.06329813066769584);
  const T t9_5 = omega5_3 * T(0.09950041652780259) + omega5_1 * T(0.009983341664682815);
  const T t9_6 = omega5_2 * T(0.009983341664682815);
  const T t9_7 = omega5_2 * T(0.09950041652780259);
  const T line_rate_tether_9_1 = sdot9_1 - Pdot5a_1 - E9_12 * t9_1 - R5a_11 * t9_2 + R5_21 * t9_3 - R5_31 * t9_4 -
      R5_21 * t9_5 + R5a_11 * t9_6 + R5_31 * t9_7;
  const T line_rate_tether_9_2 = sdot9_2 - Pdot5a_2 + R5_22 * t9_3 - R5a_12 * t9_2 - R5_32 * t9_4 - R5_22 * t9_5 +
      R5a_12 * t9_6 + R5_32 * t9_7 + E9_11 * t9_1;
  const T minus_line_rate_tether_9_3 = Pdot5a_3 + R5a_13 * t9_2 - R5_23 * t9_3 + R5_33 * t9_4 + R5_23 * t9_5 - R5a_13
      * t9_6 - R5_33 * t9_7;
  // f_tether_9 = k_tether_ - k_tether_ l_tether_ length_tether_9^-1 + c_tether_ line_tether_9 . line_rate_tether_9
  //   ll_tether_9^-1: attraction by the length [N/m]
  const T f_tether_9 = c.p.k - T(1) / length_tether_9 * c.c9_1 + T(0.4) * (line_tether_9_1 * line_rate_tether_9_1 +
      line_tether_9_2 * line_rate_tether_9_2 - line_tether_9_3 * minus_line_rate_tether_9_3) * (T(1) / ll_tether_9);
  // F_tether_9 = f_tether_9 line_tether_9: on the first end, inertial axes [N]
  const T F_tether_9_1 = f_tether_9 * line_tether_9_1;
  const T F_tether_9_2 = f_tether_9 * line_tether_9_2;
  const T F_tether_9_3 = f_tether_9 * line_tether_9_3;
  // G5 = R5 F_tether_9 - m_link5 a5: applied less inertia force, body axes [N]
  const T t9_8 = R5a_11 * F_tether_9_1 + R5a_12 * F_tether_9_2 + R5a_13 * F_tether_9_3;
  const T G5_1 = t9_8 - c.m_link5 * a5_1;
  const T t9_9 = R5_21 * F_tether_9_1 + R5_22 * F_tether_9_2 + R5_23 * F_tether_9_3;
  const T G5_2 = t9_9 - c.m_link5 * a5_2;
  const T t9_10 = R5_31 * F_tether_9_1 + R5_32 * F_tether_9_2 + R5_33 * F_tether_9_3;
  const T G5_3 = t9_10 - c.m_link5 * a5_3;
  // N5 = -axial(U5 (tr(I_link5)/2 - I_link5)) + lever5~ R5 F_tether_9: applied less inertia moment about the mass
  //   centre, body axes [N m]
  const T N5_1 = c.c9_4 * U5_23 - c.c9_3 * U5_32 - c.I_link5_13 * U5_21 + T(0.02) * t9_10 - c.lever5_3 * t9_9;
  const T N5_2 = c.c9_2 * U5_31 - c.c9_4 * U5_13 + c.I_link5_13 * (minus_U5_33 - minus_U5_11) + c.lever5_3 * t9_8 -
      c.lever5_1 * t9_10;
  const T N5_3 = c.c9_3 * U5_12 - c.c9_2 * U5_21 + c.I_link5_13 * U5_23 + c.lever5_1 * t9_9 - T(0.02) * t9_8;
  // a9 = U9 r9 + Pddot9: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T minus_a9_1 = minus_U9_11 * T(0.1);
  // G9 = -E9 F_tether_9 - m9 a9: applied less inertia force, body axes [N]
  const T G9_1 = T(2) * minus_a9_1 - (E9_11 * F_tether_9_1 + E9_12 * F_tether_9_2);
  const T minus_G9_2 = E9_11 * F_tether_9_2 - E9_12 * F_tether_9_1;
  // N9 = -axial(U9 (tr(I9)/2 - I9)) - lever9~ E9 F_tether_9: applied less inertia moment about the mass centre, body
  //   axes [N m]
  const T N9_1 = T(0.1) * minus_G9_2;

  // ---- body 10 (runner) on body 1
  const T eps10_1 = x[14], eps10_2 = x[15], eps10_3 = x[16], eps10_4 = x[17];
  const T s10 = x[28];
  const T omega10_1 = y[12], omega10_2 = y[13], omega10_3 = y[14];
  const T sdot10 = y[25];
  // erel10 = -e1~ e10 + eps4_1 e10 - eps4_10 e1: Euler parameters relative to the lower body
  const T erel10_1 = eps1_3 * eps10_2 - eps1_2 * eps10_3 + eps1_4 * eps10_1 - eps10_4 * eps1_1;
  const T erel10_2 = eps1_1 * eps10_3 - eps1_3 * eps10_1 + eps1_4 * eps10_2 - eps10_4 * eps1_2;
  const T erel10_3 = eps1_2 * eps10_1 - eps1_1 * eps10_2 + eps1_4 * eps10_3 - eps10_4 * eps1_3;
  // eps4rel10 = e1 . e10 + eps4_1 eps4_10
  const T eps4rel10 = eps1_1 * eps10_1 + eps1_2 * eps10_2 + eps1_3 * eps10_3 + eps1_4 * eps10_4;
  // C10^T = 1 + 2 erel10~ (eps4rel10 + erel10~): C takes components in the lower body to those in the body
  const T t10_1 = T(2) * erel10_2;
  const T t10_2 = t10_1 * erel10_2;
  const T t10_3 = T(2) * erel10_3;
  const T t10_4 = t10_3 * erel10_3;
  const T C10_11 = T(1) - t10_2 - t10_4;
  const T t10_5 = T(2) * erel10_1;
  const T t10_6 = t10_5 * erel10_2;
  const T t10_7 = t10_3 * eps4rel10;
  const T C10_12 = t10_6 + t10_7;
  const T t10_8 = t10_5 * erel10_3;
  const T t10_9 = t10_1 * eps4rel10;
  const T C10_13 = t10_8 - t10_9;
  const T C10_21 = t10_6 - t10_7;
  const T t10_10 = T(1) - t10_5 * erel10_1;
  const T C10_22 = t10_10 - t10_4;
  const T t10_11 = t10_1 * erel10_3;
  const T t10_12 = t10_5 * eps4rel10;
  const T C10_23 = t10_11 + t10_12;
  const T C10_31 = t10_8 + t10_9;
  const T C10_32 = t10_11 - t10_12;
  const T C10_33 = t10_10 - t10_2;
  // U10 = omega10~ omega10~: takes a point fixed in the body to its acceleration due to rotation, body axes [1/s^2]
  const T t10_13 = omega10_3 * omega10_3;
  const T t10_14 = omega10_2 * omega10_2;
  const T minus_U10_11 = t10_13 + t10_14;
  const T U10_12 = omega10_2 * omega10_1;
  const T U10_13 = omega10_3 * omega10_1;
  const T t10_15 = omega10_1 * omega10_1;
  const T minus_U10_22 = t10_13 + t10_15;
  const T U10_23 = omega10_3 * omega10_2;
  const T minus_U10_33 = t10_14 + t10_15;
  // Pddot10 = C10 omega1~ (omega1~ d10 + 2 sdot10 u10): acceleration of the body origin, less gravity, body axes
  //   [m/s^2]
  const T t10_16 = omega1_1 * s10 - t5_3;
  const T t10_17 = omega1_3 * T(0.1) - t5_6 + T(2) * sdot10;
  const T t10_18 = omega1_2 * t10_16 - omega1_3 * t10_17;
  const T t10_19 = omega1_2 * T(0.3) - omega1_3 * s10;
  const T t10_20 = omega1_3 * t10_19 - omega1_1 * t10_16;
  const T t10_21 = omega1_1 * t10_17 - omega1_2 * t10_19;
  const T Pddot10_1 = C10_11 * t10_18 + C10_12 * t10_20 + C10_13 * t10_21;
  const T Pddot10_2 = C10_21 * t10_18 + C10_22 * t10_20 + C10_23 * t10_21;
  const T Pddot10_3 = C10_31 * t10_18 + C10_32 * t10_20 + C10_33 * t10_21;
  // a10 = U10 r10 + Pddot10: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a10_1 = Pddot10_1 + U10_12 * T(0.01) - minus_U10_11 * T(0.02) - U10_13 * T(0.03);
  const T a10_2 = Pddot10_2 + U10_12 * T(0.02) - minus_U10_22 * T(0.01) - U10_23 * T(0.03);
  const T a10_3 = Pddot10_3 + U10_13 * T(0.02) + U10_23 * T(0.01) + minus_U10_33 * T(0.03);
  // G10 = -m10 a10: applied less inertia force, body axes [N]
  const T minus_G10_1 = T(0.4) * a10_1;
  const T minus_G10_2 = T(0.4) * a10_2;
  const T minus_G10_3 = T(0.4) * a10_3;
  // N10 = -omega10~ I10 omega10: applied less inertia moment about the mass centre, body axes [N m]
  const T N10_1 = T(5e-04) * U10_23;
  const T N10_2 = T(5e-04) * U10_13;
  const T minus_N10_3 = T(0.001) * U10_12;

  // ---- body 11 (nut) on body 8
  const T theta11 = x[18];
  const T thetadot11 = y[15];
  // E11^T = Rot(b11, theta11): E takes components in the lower body to those in the body
  const T E11_11 = cosines[18];
  const T E11_13 = sines[18];
  // omega11 = thetadot11 b11 + E11 omega8: absolute angular velocity, body axes [rad/s]
  const T omega11_1 = E11_11 * omega8_1 + E11_13 * omega8_3;
  const T omega11_2 = omega8_2 - thetadot11;
  const T omega11_3 = E11_11 * omega8_3 - E11_13 * omega8_1;
  // d11 = q11 + theta11 pitch11 u11: joint offset q + s, axes of the lower body [m]
  const T minus_d11_2 = T(0.1) + theta11 * T(0.01);
  // omegadot11 = -thetadot11 b11~ E11 omega8 + E11 omegadot8: angular acceleration, body axes [rad/s^2]
  const T omegadot11_1 = thetadot11 * omega11_3 + E11_11 * omegadot8_1 - E11_13 * minus_omegadot8_3;
  const T minus_omegadot11_3 = thetadot11 * omega11_1 + E11_13 * omegadot8_1 + E11_11 * minus_omegadot8_3;
  // U11 = omega11~ omega11~ + omegadot11~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t11_1 = omega11_2 * omega11_1;
  const T U11_12 = t11_1 + minus_omegadot11_3;
  const T U11_13 = omega11_3 * omega11_1;
  const T U11_21 = t11_1 - minus_omegadot11_3;
  const T t11_2 = omega11_3 * omega11_2;
  const T U11_23 = t11_2 - omegadot11_1;
  const T U11_32 = t11_2 + omegadot11_1;
  const T minus_U11_33 = omega11_2 * omega11_2 + omega11_1 * omega11_1;
  // Pddot11 = E11 (2 thetadot11 pitch11 omega8~ u11 + U8 d11 + Pddot8): acceleration of the body origin, less
  //   gravity, body axes [m/s^2]
  const T t11_3 = T(2) * thetadot11 * T(0.01);
  const T t11_4 = Pddot8_1 + t11_3 * omega8_3 - U8_12 * minus_d11_2;
  const T t11_5 = Pddot8_3 - t11_3 * omega8_1 - U8_32 * minus_d11_2;
  const T Pddot11_1 = E11_11 * t11_4 + E11_13 * t11_5;
  const T Pddot11_2 = minus_U8_22 * minus_d11_2 - minus_Pddot8_2;
  const T Pddot11_3 = E11_11 * t11_5 - E11_13 * t11_4;
  // effort_nut_11 = -thetadot11 c_nut_: along the coordinate [N m], [N]
  const T minus_effort_nut_11 = thetadot11 * T(0.002);
  // a11 = U11 r_link11 + Pddot11: acceleration of the mass centre, less gravity, body axes [m/s^2]
  const T a11_1 = Pddot11_1 + U11_13 * T(0.01);
  const T a11_2 = Pddot11_2 + U11_23 * T(0.01);
  const T a11_3 = Pddot11_3 - minus_U11_33 * T(0.01);
  // G11 = -m11 a11: applied less inertia force, body axes [N]
  const T minus_G11_1 = T(0.3) * a11_1;
  const T minus_G11_2 = T(0.3) * a11_2;
  const T minus_G11_3 = T(0.3) * a11_3;
  // N11 = C11^T M_coupling_ - axial(U11 (tr(I_link11)/2 - I_link11)): applied less inertia moment about the mass
  //   centre, body axes [N m]
  const T minus_N11_1 = T(0.00010000000000000005) * U11_32 - T(3e-04) * U11_23;
  const T minus_N11_2 = T(0.02) * u.motor;
  const T minus_N11_3 = T(3e-04) * U11_21 - T(0.00010000000000000005) * U11_12;

  // ---- body 11 (nut) and what it carries
  // n11 = r_link11~ G11 + N11: moment that drives it, body axes [N m]
  const T b11_1 = minus_G11_2 * T(0.01);
  const T n11_1 = b11_1 - minus_N11_1;
  const T minus_n11_2 = T(0.01) * minus_G11_1 + minus_N11_2;
  // u_11 = b11 . G11 pitch11 + b11 . n11 + effort_nut_11: drives it [N m], [N]
  const T u_11 = b11_1 + minus_n11_2 - minus_effort_nut_11;
  // v11 = invD11 u_11: u/D
  const T v11 = T(1515.1515151515152) * u_11;
  // gt11 = G11 - v11 B11: force with the turn solved [N]
  const T b11_2 = v11 * T(0.003);
  const T gt11_1 = b11_2 - minus_G11_1;
  const T gt11_2 = b11_2 - minus_G11_2;
  // nt11 = n11 - v11 K11: moment with the turn solved [N m]
  const T nt11_1 = n11_1 - v11 * T(3e-05);
  const T nt11_2 = v11 * T(0.0006299999999999999) - minus_n11_2;
  // Mp11 = E11^T M11 E11: M passed on, lower body's axes [kg]
  const T b11_3 = E11_13 * T(0.013636363636363637);
  const T b11_4 = E11_13 * b11_3;
  const T Mp11_11 = T(0.2863636363636364) + b11_4;
  const T minus_Mp11_12 = E11_11 * T(0.013636363636363637);
  const T minus_Mp11_13 = E11_11 * b11_3;
  const T minus_Mp11_23 = E11_13 * T(0.013636363636363637);
  const T Mp11_33 = T(0.3) - b11_4;
  // gp11 = E11^T gt11: force passed on, lower body's axes [N]
  const T gp11_1 = E11_11 * gt11_1 + E11_13 * minus_G11_3;
  const T gp11_3 = E11_13 * gt11_1 - E11_11 * minus_G11_3;
  // Hp11 = E11^T H11 E11: H passed on, lower body's axes [kg m]
  const T b11_5 = E11_13 * T(0.00013636363636363637);
  const T b11_6 = E11_13 * b11_5;
  const T Hp11_11 = T(0.00013636363636363637) - b11_6;
  const T minus_Hp11_12 = E11_11 * T(0.0028636363636363638);
  const T Hp11_13 = E11_11 * b11_5;
  const T Hp11_21 = E11_11 * T(0.00013636363636363637);
  const T Hp11_23 = E11_13 * T(0.00013636363636363637);
  const T minus_Hp11_32 = E11_13 * T(0.0028636363636363638);
  // Jp11 = E11^T J11 E11: J passed on, lower body's axes [kg m^2]
  const T b11_7 = E11_13 * T(2.8636363636363637e-05);
  const T b11_8 = E11_13 * b11_7;
  const T Jp11_11 = T(0.0004286363636363637) - b11_8;
  const T Jp11_12 = E11_11 * T(2.8636363636363637e-05);
  const T Jp11_13 = E11_11 * b11_7;
  const T Jp11_23 = E11_13 * T(2.8636363636363637e-05);
  const T Jp11_33 = T(4e-04) + b11_8;
  // np11 = E11^T nt11: moment passed on, lower body's axes [N m]
  const T np11_1 = E11_11 * nt11_1 + E11_13 * minus_N11_3;
  const T np11_3 = E11_13 * nt11_1 - E11_11 * minus_N11_3;
  // Hb11 = d11~ Mp11 + Hp11: H of the joint at the lower body's origin, its axes
  const T b11_9 = minus_d11_2 * minus_Mp11_13;
  const T Hb11_11 = b11_9 + Hp11_11;
  const T Hb11_12 = minus_d11_2 * minus_Mp11_23 - minus_Hp11_12;
  const T Hb11_13 = Hp11_13 - minus_d11_2 * Mp11_33;
  const T Hb11_31 = Hp11_13 + minus_d11_2 * Mp11_11;
  const T minus_Hb11_32 = minus_d11_2 * minus_Mp11_12 + minus_Hp11_32;
  const T Hb11_33 = b11_6 - b11_9;

  // ---- body 10 (runner) and what it carries
  // n10 = r10~ G10 + N10: moment that drives it, body axes [N m]
  const T n10_1 = N10_1 - (T(0.03) * minus_G10_2 + T(0.01) * minus_G10_3);
  const T n10_2 = T(0.03) * minus_G10_1 + T(0.02) * minus_G10_3 + N10_2;
  const T n10_3 = T(0.01) * minus_G10_1 - T(0.02) * minus_G10_2 - minus_N10_3;
  // w_10 = D(LD10)^-1 L(LD10)^-1 n10: D^-1 L^-1 n
  const T w_10_1 = T(416.6666666666667) * n10_1;
  const T b10_1 = n10_2 + T(0.03333333333333333) * n10_1;
  const T w_10_2 = T(284.30629264594387) * b10_1;
  const T w_10_3 = T(374.3436923513552) * (n10_3 - T(0.1) * n10_1 - T(0.03639120545868082) * b10_1);
  // gb10 = G10 - Y10^T w_10: force with the ball solved [N]
  const T gb10_1 = T(0.012) * w_10_2 - minus_G10_1 + T(0.0035633055344958305) * w_10_3;
  const T minus_gb10_2 = minus_G10_2 + T(4e-04) * w_10_2 + T(0.012) * w_10_1 + T(0.006785443517816528) * w_10_3;
  const T minus_gb10_3 = minus_G10_3 + T(0.004) * w_10_1 - T(0.007866666666666668) * w_10_2 -
      T(0.00011372251705837757) * w_10_3;
  // Mp10 = C10^T M10 C10: M passed on, lower body's axes [kg]
  const T b10_2 = C10_11 * T(0.35430679721867464) + C10_21 * T(0.01041577976443877) - C10_31 *
      T(0.026990208599404004);
  const T b10_3 = C10_11 * T(0.01041577976443877) + C10_21 * T(0.32271888746984534) - C10_31 *
      T(0.018816517667092383);
  const T b10_4 = C10_31 * T(0.3757343550446999) - (C10_11 * T(0.026990208599404004) + C10_21 *
      T(0.018816517667092383));
  const T Mp10_11 = b10_2 * C10_11 + b10_3 * C10_21 + b10_4 * C10_31;
  const T Mp10_12 = b10_2 * C10_12 + b10_3 * C10_22 + b10_4 * C10_32;
  const T Mp10_13 = b10_2 * C10_13 + b10_3 * C10_23 + b10_4 * C10_33;
  const T b10_5 = C10_12 * T(0.35430679721867464) + C10_22 * T(0.01041577976443877) - C10_32 *
      T(0.026990208599404004);
  const T b10_6 = C10_12 * T(0.01041577976443877) + C10_22 * T(0.32271888746984534) - C10_32 *
      T(0.018816517667092383);
  const T b10_7 = C10_32 * T(0.3757343550446999) - (C10_12 * T(0.026990208599404004) + C10_22 *
      T(0.018816517667092383));
  const T Mp10_22 = b10_5 * C10_12 + b10_6 * C10_22 + b10_7 * C10_32;
  const T Mp10_23 = b10_5 * C10_13 + b10_6 * C10_23 + b10_7 * C10_33;
  const T Mp10_33 = T(1.05276003973322) - Mp10_11 - Mp10_22;
  // gp10 = C10^T gb10: force passed on, lower body's axes [N]
  const T gp10_1 = C10_11 * gb10_1 - C10_21 * minus_gb10_2 - C10_31 * minus_gb10_3;
  const T gp10_2 = C10_12 * gb10_1 - C10_22 * minus_gb10_2 - C10_32 * minus_gb10_3;
  const T gp10_3 = C10_13 * gb10_1 - C10_23 * minus_gb10_2 - C10_33 * minus_gb10_3;
  // invD2_10 = D2_10^-1: 1/D
  const T invD2_10 = T(1) / Mp10_22;
  // kB2_10 = invD2_10 B2_10: B/D
  const T kB2_10_1 = invD2_10 * Mp10_12;
  const T kB2_10_3 = invD2_10 * Mp10_23;
  // v2_10 = invD2_10 u_2_10: u/D
  const T v2_10 = invD2_10 * gp10_2;
  // Ms2_10 = P_u10 (Mp10 - kB2_10 B2_10^T) P_u10: M with the slide solved [kg]
  const T Ms2_10_11 = Mp10_11 - kB2_10_1 * Mp10_12;
  const T Ms2_10_13 = Mp10_13 - kB2_10_1 * Mp10_23;
  const T Ms2_10_33 = Mp10_33 - kB2_10_3 * Mp10_23;
  // gs2_10 = P_u10 (gp10 - v2_10 B2_10): force with the slide solved [N]
  const T gs2_10_1 = gp10_1 - v2_10 * Mp10_12;
  const T gs2_10_3 = gp10_3 - v2_10 * Mp10_23;
  // Hb10 = d10~ Ms2_10: H of the joint at the lower body's origin, its axes
  const T Hb10_11 = s10 * Ms2_10_13;
  const T Hb10_13 = s10 * Ms2_10_33;
  const T Hb10_21 = T(0.3) * Ms2_10_11 - T(0.1) * Ms2_10_13;
  const T Hb10_23 = T(0.3) * Ms2_10_13 - T(0.1) * Ms2_10_33;
  const T minus_Hb10_31 = s10 * Ms2_10_11;

  // ---- body 9 (sled) and what it carries
  // v1_9 = invD1_9 u_1_9: u/D
  const T minus_v1_9 = T(10) * N9_1;
  // gt9 = G9 - v1_9 B1_9: force with the turn solved [N]
  const T gt9_2 = minus_v1_9 * T(0.2) - minus_G9_2;
  // Mp9 = E9^T M9 E9: M passed on, lower body's axes [kg]
  const T b9_1 = E9_12 * T(0.4);
  const T b9_2 = E9_12 * b9_1;
  const T Mp9_11 = T(2) - b9_2;
  const T Mp9_12 = E9_11 * b9_1;
  const T Mp9_22 = T(1.5999999999999999) + b9_2;
  // gp9 = E9^T gt9: force passed on, lower body's axes [N]
  const T gp9_1 = E9_11 * G9_1 - E9_12 * gt9_2;
  const T gp9_2 = E9_12 * G9_1 + E9_11 * gt9_2;
  // invD2_9 = D2_9^-1: 1/D
  const T invD2_9 = T(1) / Mp9_11;
  // kB2_9 = invD2_9 B2_9: B/D
  const T kB2_9_2 = invD2_9 * Mp9_12;
  // v2_9 = invD2_9 u_2_9: u/D
  const T v2_9 = invD2_9 * gp9_1;
  // Ms2_9 = P_u9_1 (Mp9 - kB2_9 B2_9^T) P_u9_1: M with the slide solved [kg]
  const T Ms2_9_22 = Mp9_22 - kB2_9_2 * Mp9_12;
  // gs2_9 = P_u9_1 (gp9 - v2_9 B2_9): force with the slide solved [N]
  const T gs2_9_2 = gp9_2 - v2_9 * Mp9_12;
  // invD3_9 = D3_9^-1: 1/D
  const T invD3_9 = T(1) / Ms2_9_22;
  // v3_9 = invD3_9 u_3_9: u/D
  const T v3_9 = invD3_9 * gs2_9_2;
  ydot[24] = v3_9;

  // ---- body 8 (piston) and what it carries
  // MA8 = m8 one + Mp11: force for an acceleration of the origin, home axes [kg]
  const T MA8_11 = T(0.7) + Mp11_11;
  const T MA8_33 = T(0.7) + Mp11_33;
  // HA8 = m8 r_link8~ + Hb11: moment for an acceleration of the origin, body axes [kg m]
  const T HA8_12 = Hb11_12 - T(0.013999999999999999);
  const T HA8_13 = Hb11_13 - T(0.06999999999999999);
  const T HA8_21 = T(0.013999999999999999) + Hp11_21;
  const T HA8_23 = Hp11_23 + T(0.006999999999999999);
  const T HA8_31 = Hb11_31 + T(0.06999999999999999);
  const T minus_HA8_32 = T(0.006999999999999999) + minus_Hb11_32;
  // JA8 = -m8 r_link8~ r_link8~ + I_link8 + d11~ Hp11^T + Jp11 - Hb11 d11~: moment for an angular acceleration, body
  //   axes [kg m^2]
  const T b8_1 = minus_d11_2 * Hp11_13;
  const T JA8_11 = T(0.010280000000000001) - b8_1 + Jp11_11 - Hb11_13 * minus_d11_2;
  const T JA8_12 = Jp11_12 - (T(7e-04) + minus_d11_2 * Hp11_23);
  const T JA8_13 = T(0.00014) - minus_d11_2 * b11_6 + Jp11_13 + Hb11_11 * minus_d11_2;
  const T JA8_23 = T(0.0014) + Jp11_23 + minus_d11_2 * Hp11_21;
  const T JA8_33 = T(0.01107) + b8_1 + Jp11_33 + Hb11_31 * minus_d11_2;
  // g8 = G8 + gp11: force that drives it, home axes [N]
  const T g8_1 = gp11_1 - minus_G8_1;
  const T g8_2 = gt11_2 - minus_G8_2;
  const T g8_3 = gp11_3 - minus_G8_3;
  // n8 = r_link8~ G8 + d11~ gp11 + N8 + np11: moment that drives it, body axes [N m]
  const T n8_1 = np11_1 - minus_N8_1 + T(0.02) * minus_G8_2 + T(0.1) * minus_G8_3 - minus_d11_2 * gp11_3;
  const T n8_2 = nt11_2 - T(0.02) * minus_G8_1 - T(0.01) * minus_G8_3 + N8_2;
  const T n8_3 = np11_3 - minus_N8_3 + T(0.01) * minus_G8_2 - T(0.1) * minus_G8_1 + minus_d11_2 * gp11_1;
  // kB1_8 = invD1_8 B1_8: B/D
  const T minus_kB1_8_1 = T(420.4089432447927) * HA8_21;
  const T minus_kB1_8_3 = T(420.4089432447927) * HA8_23;
  // kK1_8 = invD1_8 K1_8: K/D
  const T minus_kK1_8_1 = T(420.4089432447927) * JA8_12;
  const T minus_kK1_8_3 = T(420.4089432447927) * JA8_23;
  // v1_8 = invD1_8 u_1_8: u/D
  const T minus_v1_8 = T(420.4089432447927) * n8_2;
  // M8 = MA8 - kB1_8 B1_8^T: MA less what the turn takes up [kg]
  const T M8_11 = MA8_11 - minus_kB1_8_1 * HA8_21;
  const T M8_12 = minus_kB1_8_1 * T(0.0028636363636363638) - minus_Mp11_12;
  const T minus_M8_13 = minus_Mp11_13 + minus_kB1_8_1 * HA8_23;
  const T M8_23 = T(1.2038983374737244) * HA8_23 - minus_Mp11_23;
  const T M8_33 = MA8_33 - minus_kB1_8_3 * HA8_23;
  // H8 = P_b8 (HA8 - kK1_8 B1_8^T): HA less what the turn takes up [kg m]
  const T H8_11 = Hb11_11 - minus_kK1_8_1 * HA8_21;
  const T H8_12 = HA8_12 + minus_kK1_8_1 * T(0.0028636363636363638);
  const T H8_13 = HA8_13 - minus_kK1_8_1 * HA8_23;
  const T H8_31 = HA8_31 - minus_kK1_8_3 * HA8_21;
  const T H8_32 = minus_kK1_8_3 * T(0.0028636363636363638) - minus_HA8_32;
  const T H8_33 = Hb11_33 - minus_kK1_8_3 * HA8_23;
  // J8 = P_b8 (JA8 - kK1_8 K1_8^T) P_b8: JA less what the turn takes up [kg m^2]
  const T J8_11 = JA8_11 - minus_kK1_8_1 * JA8_12;
  const T J8_13 = JA8_13 - minus_kK1_8_1 * JA8_23;
  const T J8_33 = JA8_33 - minus_kK1_8_3 * JA8_23;
  // gt8 = g8 - v1_8 B1_8: force with the turn solved [N]
  const T gt8_1 = g8_1 - minus_v1_8 * HA8_21;
  const T gt8_2 = g8_2 + minus_v1_8 * T(0.0028636363636363638);
  const T gt8_3 = g8_3 - minus_v1_8 * HA8_23;
  // nt8 = P_b8 (n8 - v1_8 K1_8): moment with the turn solved [N m]
  const T nt8_1 = n8_1 - minus_v1_8 * JA8_12;
  const T nt8_3 = n8_3 - minus_v1_8 * JA8_23;
  // Mp8 = E8^T M8 E8: M passed on, lower body's axes [kg]
  const T b8_2 = T(2) * E8_11;
  const T b8_3 = b8_2 * minus_M8_13 + E8_13 * (M8_33 - M8_11);
  const T b8_4 = E8_13 * b8_3;
  const T Mp8_11 = M8_11 + b8_4;
  const T Mp8_12 = E8_11 * M8_12 - E8_13 * M8_23;
  const T Mp8_13 = minus_M8_13 - E8_11 * b8_3;
  const T Mp8_23 = E8_11 * M8_23 + E8_13 * M8_12;
  const T Mp8_33 = M8_33 - b8_4;
  // gp8 = E8^T gt8: force passed on, lower body's axes [N]
  const T gp8_1 = E8_11 * gt8_1 - E8_13 * gt8_3;
  const T gp8_3 = E8_13 * gt8_1 + E8_11 * gt8_3;
  // Hp8 = E8^T H8 E8: H passed on, lower body's axes [kg m]
  const T b8_5 = E8_11 * (H8_31 + H8_13) - E8_13 * (H8_33 - H8_11);
  const T b8_6 = E8_13 * b8_5;
  const T Hp8_11 = H8_11 - b8_6;
  const T Hp8_12 = E8_11 * H8_12 - E8_13 * H8_32;
  const T b8_7 = E8_11 * b8_5;
  const T Hp8_13 = b8_7 - H8_31;
  const T Hp8_31 = b8_7 - H8_13;
  const T Hp8_32 = E8_11 * H8_32 + E8_13 * H8_12;
  const T Hp8_33 = H8_33 + b8_6;
  // Jp8 = E8^T J8 E8: J passed on, lower body's axes [kg m^2]
  const T b8_8 = b8_2 * J8_13 - E8_13 * (J8_33 - J8_11);
  const T b8_9 = E8_13 * b8_8;
  const T Jp8_11 = J8_11 - b8_9;
  const T Jp8_13 = E8_11 * b8_8 - J8_13;
  const T Jp8_33 = J8_33 + b8_9;
  // np8 = E8^T nt8: moment passed on, lower body's axes [N m]
  const T np8_1 = E8_11 * nt8_1 - E8_13 * nt8_3;
  const T np8_3 = E8_13 * nt8_1 + E8_11 * nt8_3;
  // kB2_8 = invD2_8 B2_8: B/D
  const T minus_kB2_8_1 = T(1.0173808227700445) * Mp8_12;
  const T minus_kB2_8_3 = T(1.0173808227700445) * Mp8_23;
  // kK2_8 = invD2_8 K2_8: K/D
  const T minus_kK2_8_1 = T(1.0173808227700445) * Hp8_12;
  const T minus_kK2_8_3 = T(1.0173808227700445) * Hp8_32;
  // v2_8 = invD2_8 u_2_8: u/D
  const T minus_v2_8 = T(1.0173808227700445) * gt8_2;
  // Ms2_8 = P_u8 (Mp8 - kB2_8 B2_8^T) P_u8: M with the slide solved [kg]
  const T Ms2_8_11 = Mp8_11 - minus_kB2_8_1 * Mp8_12;
  const T Ms2_8_13 = Mp8_13 - minus_kB2_8_1 * Mp8_23;
  const T Ms2_8_33 = Mp8_33 - minus_kB2_8_3 * Mp8_23;
  // Hs2_8 = (Hp8 - kK2_8 B2_8^T) P_u8: H with the slide solved [kg m]
  const T Hs2_8_11 = Hp8_11 - minus_kK2_8_1 * Mp8_12;
  const T Hs2_8_13 = Hp8_13 - minus_kK2_8_1 * Mp8_23;
  const T Hs2_8_31 = Hp8_31 - minus_kK2_8_3 * Mp8_12;
  const T Hs2_8_33 = Hp8_33 - minus_kK2_8_3 * Mp8_23;
  // Js2_8 = Jp8 - kK2_8 K2_8^T: J with the slide solved [kg m^2]
  const T Js2_8_11 = Jp8_11 - minus_kK2_8_1 * Hp8_12;
  const T Js2_8_13 = Jp8_13 - minus_kK2_8_1 * Hp8_32;
  const T Js2_8_33 = Jp8_33 - minus_kK2_8_3 * Hp8_32;
  // gs2_8 = P_u8 (gp8 - v2_8 B2_8): force with the slide solved [N]
  const T gs2_8_1 = gp8_1 - minus_v2_8 * Mp8_12;
  const T gs2_8_3 = gp8_3 - minus_v2_8 * Mp8_23;
  // ns2_8 = np8 - v2_8 K2_8: moment with the slide solved [N m]
  const T ns2_8_1 = np8_1 - minus_v2_8 * Hp8_12;
  const T ns2_8_3 = np8_3 - minus_v2_8 * Hp8_32;
  // Hb8 = d8~ Ms2_8 + Hs2_8: H of the joint at the lower body's origin, its axes
  const T b8_10 = d8_2 * Ms2_8_13;
  const T Hb8_11 = b8_10 + Hs2_8_11;
  const T Hb8_13 = Hs2_8_13 + d8_2 * Ms2_8_33;
  const T Hb8_31 = Hs2_8_31 - d8_2 * Ms2_8_11;
  const T Hb8_33 = Hs2_8_33 - b8_10;

  // ---- body 6 (telescope) and what it carries
  // n6 = r6~ G6 + N6: moment that drives it, body axes [N m]
  const T n6_1 = N6_1 - T(0.01) * G6_2;
  const T n6_2 = T(0.01) * G6_1 - minus_N6_2 + T(0.1) * minus_G6_3;
  const T n6_3 = N6_3 + T(0.1) * G6_2;
  // u_6 = u6 . G6 + effort_telescope_6: drives it [N m], [N]
  const T u_6 = G6_1 - minus_effort_telescope_6;
  // v6 = invD6 u_6: u/D
  const T v6 = T(2) * u_6;
  // ns6 = n6 - v6 K6: moment with the slide solved [N m]
  const T ns6_2 = n6_2 - v6 * T(0.005);
  // Hb6 = d6~ Ms6 + Hs6: H of the joint at the lower body's origin, its axes
  const T minus_Hb6_23 = T(0.05) + d6_1 * T(0.5);

  // ---- body 5 (camera) and what it carries
  // n5 = r_link5~ G5 + N5: moment that drives it, body axes [N m]
  const T n5_1 = N5_1 - c.r_link5_3 * G5_2;
  const T n5_2 = N5_2 + c.r_link5_3 * G5_1 - c.r_link5_1 * G5_3;
  const T n5_3 = N5_3 + c.r_link5_1 * G5_2;
  // gp5 = E5^T G5: force passed on, lower body's axes [N]
  const T gp5_2 = E5_22 * G5_2 - E5_23 * G5_3;
  const T gp5_3 = E5_23 * G5_2 + E5_22 * G5_3;
  // Hp5 = E5^T HA5 E5: H passed on, lower body's axes [kg m]
  const T minus_Hp5_12 = E5_22 * c.HA5_21;
  const T minus_Hp5_13 = E5_23 * c.HA5_21;
  // Jp5 = E5^T JA5 E5: J passed on, lower body's axes [kg m^2]
  const T minus_Jp5_12 = E5_23 * c.JA5_13;
  const T Jp5_13 = E5_22 * c.JA5_13;
  const T b5_1 = E5_23 * c.c5_2;
  const T b5_2 = E5_23 * b5_1;
  const T Jp5_22 = c.JA5_22 - b5_2;
  const T Jp5_23 = E5_22 * b5_1;
  const T Jp5_33 = c.JA5_33 + b5_2;
  // np5 = E5^T n5: moment passed on, lower body's axes [N m]
  const T np5_2 = E5_22 * n5_2 - E5_23 * n5_3;
  const T np5_3 = E5_23 * n5_2 + E5_22 * n5_3;
  // invD5a = D5a^-1: 1/D
  const T invD5a = T(1) / Jp5_33;
  // kB5a = invD5a B5a: B/D
  const T kB5a_1 = invD5a * minus_Hp5_13;
  const T kB5a_2 = invD5a * c.HA5_32;
  // kK5a = invD5a K5a: K/D
  const T kK5a_1 = invD5a * Jp5_13;
  const T kK5a_2 = invD5a * Jp5_23;
  // v5a = invD5a u_5a: u/D
  const T v5a = invD5a * np5_3;
  // M5a = Mp5 - kB5a B5a^T: MA less what the turn takes up [kg]
  const T M5a_11 = c.m_link5 - kB5a_1 * minus_Hp5_13;
  const T minus_M5a_12 = kB5a_1 * c.HA5_32;
  const T M5a_22 = c.m_link5 - kB5a_2 * c.HA5_32;
  // H5a = P_b5_1 (Hp5 - kK5a B5a^T): HA less what the turn takes up [kg m]
  const T minus_H5a_11 = kK5a_1 * minus_Hp5_13;
  const T minus_H5a_12 = minus_Hp5_12 + kK5a_1 * c.HA5_32;
  const T H5a_21 = minus_Hp5_12 - kK5a_2 * minus_Hp5_13;
  const T minus_H5a_22 = kK5a_2 * c.HA5_32;
  // J5a = P_b5_1 (Jp5 - kK5a K5a^T) P_b5_1: JA less what the turn takes up [kg m^2]
  const T J5a_11 = c.JA5_11 - kK5a_1 * Jp5_13;
  const T minus_J5a_12 = minus_Jp5_12 + kK5a_1 * Jp5_23;
  const T J5a_22 = Jp5_22 - kK5a_2 * Jp5_23;
  // gt5a = gp5 - v5a B5a: force with the turn solved [N]
  const T gt5a_1 = G5_1 - v5a * minus_Hp5_13;
  const T gt5a_2 = gp5_2 - v5a * c.HA5_32;
  // nt5a = P_b5_1 (np5 - v5a K5a): moment with the turn solved [N m]
  const T nt5a_1 = n5_1 - v5a * Jp5_13;
  const T nt5a_2 = np5_2 - v5a * Jp5_23;
  // Mp5a = E5a^T M5a E5a: M passed on, lower body's axes [kg]
  const T b5_3 = T(2) * E5a_11;
  const T b5_4 = E5a_12 * (M5a_11 - M5a_22) - b5_3 * minus_M5a_12;
  const T b5_5 = E5a_12 * b5_4;
  const T Mp5a_11 = M5a_11 - b5_5;
  const T Mp5a_12 = minus_M5a_12 + E5a_11 * b5_4;
  const T Mp5a_22 = M5a_22 + b5_5;
  // gp5a = E5a^T gt5a: force passed on, lower body's axes [N]
  const T gp5a_1 = E5a_11 * gt5a_1 - E5a_12 * gt5a_2;
  const T gp5a_2 = E5a_12 * gt5a_1 + E5a_11 * gt5a_2;
  // Hp5a = E5a^T H5a E5a: H passed on, lower body's axes [kg m]
  const T b5_6 = E5a_12 * (minus_H5a_22 - minus_H5a_11) + E5a_11 * (H5a_21 - minus_H5a_12);
  const T b5_7 = E5a_12 * b5_6;
  const T minus_Hp5a_11 = minus_H5a_11 + b5_7;
  const T b5_8 = E5a_11 * b5_6;
  const T Hp5a_12 = b5_8 - H5a_21;
  const T minus_Hp5a_13 = E5a_11 * minus_Hp5_13 - E5a_12 * c.HA5_32;
  const T Hp5a_21 = b5_8 + minus_H5a_12;
  const T Hp5a_22 = b5_7 - minus_H5a_22;
  const T minus_Hp5a_23 = E5a_11 * c.HA5_32 + E5a_12 * minus_Hp5_13;
  // Jp5a = E5a^T J5a E5a: J passed on, lower body's axes [kg m^2]
  const T b5_9 = E5a_12 * (J5a_11 - J5a_22) - b5_3 * minus_J5a_12;
  const T b5_10 = E5a_12 * b5_9;
  const T Jp5a_11 = J5a_11 - b5_10;
  const T Jp5a_12 = minus_J5a_12 + E5a_11 * b5_9;
  const T Jp5a_22 = J5a_22 + b5_10;
  // np5a = E5a^T nt5a: moment passed on, lower body's axes [N m]
  const T np5a_1 = E5a_11 * nt5a_1 - E5a_12 * nt5a_2;
  const T np5a_2 = E5a_12 * nt5a_1 + E5a_11 * nt5a_2;
  // Hb5a = q5a~ Mp5a + Hp5a: H of the joint at the lower body's origin, its axes
  const T b5_11 = T(0.1) * Mp5a_12;
  const T minus_Hb5a_11 = b5_11 + minus_Hp5a_11;
  const T Hb5a_12 = Hp5a_12 - T(0.1) * Mp5a_22;
  const T minus_Hb5a_13 = c.c5_3 + minus_Hp5a_13;
  const T Hb5a_21 = Hp5a_21 + T(0.1) * Mp5a_11;
  const T Hb5a_22 = b5_11 + Hp5a_22;
  const T Hb5a_31 = T(0.3) * Mp5a_11;
  const T Hb5a_32 = T(0.3) * Mp5a_12;

  // ---- body 4 (cross) and what it carries
  // n4 = r4~ G4 + N4: moment that drives it, body axes [N m]
  const T n4_1 = T(0.1) * minus_G4_2 - minus_N4_1;
  const T n4_2 = T(0.03) * minus_G4_3 - minus_N4_2 - T(0.1) * minus_G4_1;
  const T minus_n4_3 = minus_N4_3 + T(0.03) * minus_G4_2;
  // v4 = invD4 u_4: u/D
  const T v4 = T(59.4883997620464) * n4_2;
  // gt4 = G4 - v4 B4: force with the turn solved [N]
  const T minus_gt4_1 = minus_G4_1 + v4 * T(0.09000000000000001);
  const T gt4_3 = v4 * T(0.027) - minus_G4_3;
  // Mp4 = E4^T M4 E4: M passed on, lower body's axes [kg]
  const T b4_1 = t4_5 * T(0.8566329565734682) - minus_E4_11 * T(0.14455681142177276);
  const T b4_2 = t4_5 * T(0.14455681142177276) - minus_E4_11 * T(0.41814396192742415);
  const T Mp4_11 = b4_1 * t4_5 - b4_2 * minus_E4_11;
  const T Mp4_12 = b4_2 * E4_12 + b4_1 * E4_32;
  const T minus_Mp4_13 = b4_2 * minus_E4_13 + b4_1 * minus_E4_33;
  const T b4_3 = E4_12 * T(0.41814396192742415) + E4_32 * T(0.14455681142177276);
  const T b4_4 = E4_12 * T(0.14455681142177276) + E4_32 * T(0.8566329565734682);
  const T Mp4_22 = b4_3 * E4_12 + T(0.82944) + b4_4 * E4_32;
  const T Mp4_23 = T(0.24192000000000002) - b4_3 * minus_E4_13 - b4_4 * minus_E4_33;
  const T Mp4_33 = T(2.1747769185008923) - Mp4_11 - Mp4_22;
  // gp4 = E4^T gt4: force passed on, lower body's axes [N]
  const T gp4_1 = minus_E4_11 * minus_gt4_1 + t4_5 * gt4_3;
  const T gp4_2 = E4_32 * gt4_3 - (E4_12 * minus_gt4_1 + T(0.96) * minus_G4_2);
  const T gp4_3 = minus_E4_13 * minus_gt4_1 - T(0.28) * minus_G4_2 - minus_E4_33 * gt4_3;
  // Hp4 = E4^T H4 E4: H passed on, lower body's axes [kg m]
  const T b4_5 = minus_E4_11 * T(0.09000000000000001) + t4_5 * T(0.027);
  const T Hp4_12 = b4_5 * T(0.96);
  const T Hp4_13 = b4_5 * T(0.28);
  const T b4_6 = E4_32 * T(0.027) - E4_12 * T(0.09000000000000001);
  const T Hp4_22 = b4_6 * T(0.96);
  const T Hp4_23 = b4_6 * T(0.28);
  const T b4_7 = minus_E4_13 * T(0.09000000000000001) - minus_E4_33 * T(0.027);
  const T Hp4_32 = b4_7 * T(0.96);
  const T Hp4_33 = b4_7 * T(0.28);
  // Jp4 = E4^T J4 E4: J passed on, lower body's axes [kg m^2]
  const T b4_8 = minus_E4_11 * T(0.017) + t4_5 * T(0.0027);
  const T b4_9 = minus_E4_11 * T(0.0027) + t4_5 * T(0.01281);
  const T Jp4_11 = b4_8 * minus_E4_11 + b4_9 * t4_5;
  const T Jp4_12 = b4_9 * E4_32 - b4_8 * E4_12;
  const T Jp4_13 = b4_8 * minus_E4_13 - b4_9 * minus_E4_33;
  const T b4_10 = E4_12 * T(0.017) - E4_32 * T(0.0027);
  const T b4_11 = E4_32 * T(0.01281) - E4_12 * T(0.0027);
  const T Jp4_22 = b4_10 * E4_12 + b4_11 * E4_32;
  const T minus_Jp4_23 = b4_10 * minus_E4_13 + b4_11 * minus_E4_33;
  const T Jp4_33 = T(0.029810000000000003) - Jp4_11 - Jp4_22;
  // np4 = E4^T nt4: moment passed on, lower body's axes [N m]
  const T minus_np4_1 = minus_E4_11 * n4_1 + t4_5 * minus_n4_3;
  const T np4_2 = E4_12 * n4_1 - E4_32 * minus_n4_3;
  const T np4_3 = minus_E4_33 * minus_n4_3 - minus_E4_13 * n4_1;
  // B4a = Hp4^T b4_1: force of a unit of the angle's acceleration [kg m]
  const T B4a_2 = Hp4_22 * T(0.28) - Hp4_32 * T(0.96);
  const T B4a_3 = Hp4_23 * T(0.28) - Hp4_33 * T(0.96);
  // K4a = Jp4 b4_1: its moment about the body origin, body axes [kg m^2]
  const T K4a_1 = Jp4_12 * T(0.28) - Jp4_13 * T(0.96);
  const T K4a_2 = Jp4_22 * T(0.28) + minus_Jp4_23 * T(0.96);
  const T minus_K4a_3 = minus_Jp4_23 * T(0.28) + Jp4_33 * T(0.96);
  // D4a = b4_1 . K4a: pivot: inertia that the angle feels [kg m^2]
  const T D4a = T(0.28) * K4a_2 + T(0.96) * minus_K4a_3;
  // invD4a = D4a^-1: 1/D
  const T invD4a = T(1) / D4a;
  // kB4a = invD4a B4a: B/D
  const T kB4a_2 = invD4a * B4a_2;
  const T kB4a_3 = invD4a * B4a_3;
  // kK4a = invD4a K4a: K/D
  const T kK4a_1 = invD4a * K4a_1;
  const T kK4a_2 = invD4a * K4a_2;
  const T minus_kK4a_3 = invD4a * minus_K4a_3;
  // u_4a = b4_1 . np4: drives it [N m], [N]
  const T u_4a = T(0.28) * np4_2 - T(0.96) * np4_3;
  // v4a = invD4a u_4a: u/D
  const T v4a = invD4a * u_4a;
  // M4a = Mp4 - kB4a B4a^T: MA less what the turn takes up [kg]
  const T M4a_22 = Mp4_22 - kB4a_2 * B4a_2;
  const T M4a_23 = Mp4_23 - kB4a_2 * B4a_3;
  const T M4a_33 = Mp4_33 - kB4a_3 * B4a_3;
  // H4a = Hp4 - kK4a B4a^T: HA less what the turn takes up [kg m]
  const T H4a_12 = Hp4_12 - kK4a_1 * B4a_2;
  const T H4a_13 = Hp4_13 - kK4a_1 * B4a_3;
  const T H4a_22 = Hp4_22 - kK4a_2 * B4a_2;
  const T H4a_23 = Hp4_23 - kK4a_2 * B4a_3;
  const T H4a_32 = Hp4_32 + minus_kK4a_3 * B4a_2;
  const T H4a_33 = Hp4_33 + minus_kK4a_3 * B4a_3;
  // J4a = Jp4 - kK4a K4a^T: JA less what the turn takes up [kg m^2]
  const T J4a_11 = Jp4_11 - kK4a_1 * K4a_1;
  const T J4a_12 = Jp4_12 - kK4a_1 * K4a_2;
  const T J4a_13 = Jp4_13 + kK4a_1 * minus_K4a_3;
  const T J4a_22 = Jp4_22 - kK4a_2 * K4a_2;
  const T J4a_23 = kK4a_2 * minus_K4a_3 - minus_Jp4_23;
  const T J4a_33 = Jp4_33 - minus_kK4a_3 * minus_K4a_3;
  // gt4a = gp4 - v4a B4a: force with the turn solved [N]
  const T gt4a_2 = gp4_2 - v4a * B4a_2;
  const T gt4a_3 = gp4_3 - v4a * B4a_3;
  // nt4a = np4 - v4a K4a: moment with the turn solved [N m]
  const T minus_nt4a_1 = minus_np4_1 + v4a * K4a_1;
  const T nt4a_2 = np4_2 - v4a * K4a_2;
  const T nt4a_3 = np4_3 + v4a * minus_K4a_3;
  // Mp4a = E4a^T M4a E4a: M passed on, lower body's axes [kg]
  const T b4_12 = minus_E4a_12 * Mp4_12;
  const T b4_13 = E4a_11 * Mp4_11 + b4_12 - minus_E4a_13 * minus_Mp4_13;
  const T b4_14 = E4a_11 * Mp4_12 + minus_E4a_12 * M4a_22 + minus_E4a_13 * M4a_23;
  const T b4_15 = minus_E4a_12 * M4a_23 - E4a_11 * minus_Mp4_13 + minus_E4a_13 * M4a_33;
  const T Mp4a_11 = b4_13 * E4a_11 + b4_14 * minus_E4a_12 + b4_15 * minus_E4a_13;
  const T Mp4a_12 = b4_14 * E4a_22 - b4_13 * minus_E4a_12 + b4_15 * E4a_23;
  const T Mp4a_13 = b4_14 * E4a_23 - b4_13 * minus_E4a_13 + b4_15 * E4a_33;
  const T b4_16 = E4a_22 * M4a_22 - b4_12 + E4a_23 * M4a_23;
  const T b4_17 = E4a_22 * Mp4_12 - minus_E4a_12 * Mp4_11 - E4a_23 * minus_Mp4_13;
  const T b4_18 = minus_E4a_12 * minus_Mp4_13 + E4a_22 * M4a_23 + E4a_23 * M4a_33;
  const T Mp4a_22 = b4_16 * E4a_22 - b4_17 * minus_E4a_12 + b4_18 * E4a_23;
  const T Mp4a_23 = b4_16 * E4a_23 - b4_17 * minus_E4a_13 + b4_18 * E4a_33;
  const T Mp4a_33 = Mp4_11 + M4a_22 + M4a_33 - Mp4a_11 - Mp4a_22;
  // gp4a = E4a^T gt4a: force passed on, lower body's axes [N]
  const T gp4a_1 = E4a_11 * gp4_1 + minus_E4a_12 * gt4a_2 + minus_E4a_13 * gt4a_3;
  const T gp4a_2 = E4a_22 * gt4a_2 - minus_E4a_12 * gp4_1 + E4a_23 * gt4a_3;
  const T gp4a_3 = E4a_23 * gt4a_2 - minus_E4a_13 * gp4_1 + E4a_33 * gt4a_3;
  // Hp4a = E4a^T H4a E4a: H passed on, lower body's axes [kg m]
  const T b4_19 = E4a_11 * H4a_12 + minus_E4a_12 * H4a_22 + minus_E4a_13 * H4a_32;
  const T b4_20 = E4a_11 * H4a_13 + minus_E4a_12 * H4a_23 + minus_E4a_13 * H4a_33;
  const T Hp4a_11 = b4_19 * minus_E4a_12 + b4_20 * minus_E4a_13;
  const T Hp4a_12 = b4_19 * E4a_22 + b4_20 * E4a_23;
  const T Hp4a_13 = b4_19 * E4a_23 + b4_20 * E4a_33;
  const T b4_21 = E4a_22 * H4a_22 - minus_E4a_12 * H4a_12 + E4a_23 * H4a_32;
  const T b4_22 = E4a_22 * H4a_23 - minus_E4a_12 * H4a_13 + E4a_23 * H4a_33;
  const T Hp4a_21 = b4_21 * minus_E4a_12 + b4_22 * minus_E4a_13;
  const T Hp4a_22 = b4_21 * E4a_22 + b4_22 * E4a_23;
  const T Hp4a_23 = b4_21 * E4a_23 + b4_22 * E4a_33;
  const T b4_23 = E4a_23 * H4a_22 - minus_E4a_13 * H4a_12 + E4a_33 * H4a_32;
  const T b4_24 = E4a_23 * H4a_23 - minus_E4a_13 * H4a_13 + E4a_33 * H4a_33;
  const T Hp4a_31 = b4_23 * minus_E4a_12 + b4_24 * minus_E4a_13;
  const T Hp4a_32 = b4_23 * E4a_22 + b4_24 * E4a_23;
  const T Hp4a_33 = b4_23 * E4a_23 + b4_24 * E4a_33;
  // Jp4a = E4a^T J4a E4a: J passed on, lower body's axes [kg m^2]
  const T b4_25 = minus_E4a_12 * J4a_12;
  const T b4_26 = E4a_11 * J4a_11 + b4_25 + minus_E4a_13 * J4a_13;
  const T b4_27 = E4a_11 * J4a_12 + minus_E4a_12 * J4a_22 + minus_E4a_13 * J4a_23;
  const T b4_28 = E4a_11 * J4a_13 + minus_E4a_12 * J4a_23 + minus_E4a_13 * J4a_33;
  const T Jp4a_11 = b4_26 * E4a_11 + b4_27 * minus_E4a_12 + b4_28 * minus_E4a_13;
  const T Jp4a_12 = b4_27 * E4a_22 - b4_26 * minus_E4a_12 + b4_28 * E4a_23;
  const T Jp4a_13 = b4_27 * E4a_23 - b4_26 * minus_E4a_13 + b4_28 * E4a_33;
  const T b4_29 = E4a_22 * J4a_22 - b4_25 + E4a_23 * J4a_23;
  const T b4_30 = E4a_22 * J4a_12 - minus_E4a_12 * J4a_11 + E4a_23 * J4a_13;
  const T b4_31 = E4a_22 * J4a_23 - minus_E4a_12 * J4a_13 + E4a_23 * J4a_33;
  const T Jp4a_22 = b4_29 * E4a_22 - b4_30 * minus_E4a_12 + b4_31 * E4a_23;
  const T Jp4a_23 = b4_29 * E4a_23 - b4_30 * minus_E4a_13 + b4_31 * E4a_33;
  const T Jp4a_33 = J4a_11 + J4a_22 + J4a_33 - Jp4a_11 - Jp4a_22;
  // np4a = E4a^T nt4a: moment passed on, lower body's axes [N m]
  const T np4a_1 = minus_E4a_12 * nt4a_2 - E4a_11 * minus_nt4a_1 + minus_E4a_13 * nt4a_3;
  const T np4a_2 = minus_E4a_12 * minus_nt4a_1 + E4a_22 * nt4a_2 + E4a_23 * nt4a_3;
  const T np4a_3 = minus_E4a_13 * minus_nt4a_1 + E4a_23 * nt4a_2 + E4a_33 * nt4a_3;
  // Hb4a = q4a~ Mp4a + Hp4a: H of the joint at the lower body's origin, its axes
  const T b4_32 = T(0.1) * Mp4a_13;
  const T Hb4a_11 = b4_32 + Hp4a_11;
  const T Hb4a_12 = Hp4a_12 + T(0.1) * Mp4a_23;
  const T Hb4a_13 = Hp4a_13 + T(0.1) * Mp4a_33;
  const T Hb4a_21 = Hp4a_21 + T(0.2) * Mp4a_13;
  const T b4_33 = T(0.2) * Mp4a_23;
  const T Hb4a_22 = b4_33 + Hp4a_22;
  const T Hb4a_23 = Hp4a_23 + T(0.2) * Mp4a_33;
  const T Hb4a_31 = Hp4a_31 - T(0.2) * Mp4a_12 - T(0.1) * Mp4a_11;
  const T Hb4a_32 = Hp4a_32 - T(0.2) * Mp4a_22 - T(0.1) * Mp4a_12;
  const T Hb4a_33 = Hp4a_33 - (b4_33 + b4_32);

  // ---- body 3 (boom) and what it carries
  // HA3 = m3 r3~ + Hb6: moment for an acceleration of the origin, body axes [kg m]
  const T minus_HA3_23 = minus_Hb6_23 + T(0.30000000000000004);
  // JA3 = -m3 r3~ r3~ + I3 + d6~ Hs6^T + Js6 - Hb6 d6~: moment for an angular acceleration, body axes [kg m^2]
  const T JA3_13 = T(5e-04) - d6_1 * T(0.005);
  const T b3_1 = d6_1 * T(0.05) + minus_Hb6_23 * d6_1;
  const T JA3_22 = T(0.12100000000000001) + b3_1;
  const T JA3_33 = T(0.0916) + b3_1;
  // g3 = G3 + gs6: force that drives it, home axes [N]
  const T g3_1 = minus_effort_telescope_6 - minus_G3_1;
  const T g3_2 = G6_2 - minus_G3_2;
  const T minus_g3_3 = minus_G3_3 + minus_G6_3;
  // n3 = r3~ G3 + d6~ gs6 + N3 + ns6: moment that drives it, body axes [N m]
  const T n3_1 = n6_1 - minus_N3_1 - T(0.02) * minus_G3_3;
  const T n3_2 = ns6_2 - minus_N3_2 + T(0.2) * minus_G3_3 + d6_1 * minus_G6_3;
  const T n3_3 = n6_3 - minus_N3_3 + T(0.02) * minus_G3_1 - T(0.2) * minus_G3_2 + d6_1 * G6_2;
  // B3 = HA3^T b3: force of a unit of the angle's acceleration [kg m]
  const T B3_2 = T(0.0015763557945883155) + minus_HA3_23 * T(0.8388422987658062);
  const T minus_B3_3 = T(0.009458134767529894) + minus_HA3_23 * T(0.44378789320576517);
  // K3 = JA3 b3: its moment about the body origin, body axes [kg m^2]
  const T K3_1 = JA3_13 * T(0.8388422987658062) - T(0.01490619534174373);
  const T K3_2 = JA3_22 * T(0.44378789320576517) - T(0.001255442260626766);
  const T K3_3 = JA3_33 * T(0.8388422987658062) - (JA3_13 * T(0.3152711589176631) + T(0.0013313636796172955));
  // D3 = b3 . K3: pivot: inertia that the angle feels [kg m^2]
  const T D3 = T(0.44378789320576517) * K3_2 - T(0.3152711589176631) * K3_1 + T(0.8388422987658062) * K3_3;
  // invD3 = D3^-1: 1/D
  const T invD3 = T(1) / D3;
  // kB3 = invD3 B3: B/D
  const T minus_kB3_1 = invD3 * T(0.025165268962974188);
  const T kB3_2 = invD3 * B3_2;
  const T minus_kB3_3 = invD3 * minus_B3_3;
  // kK3 = invD3 K3: K/D
  const T kK3_1 = invD3 * K3_1;
  const T kK3_2 = invD3 * K3_2;
  const T kK3_3 = invD3 * K3_3;
  // u_3 = b3 . n3 + effort_boom_3: drives it [N m], [N]
  const T u_3 = effort_boom_3 + T(0.44378789320576517) * n3_2 - T(0.3152711589176631) * n3_1 + T(0.8388422987658062) *
      n3_3;
  // v3 = invD3 u_3: u/D
  const T v3 = invD3 * u_3;
  // M3 = MA3 - kB3 B3^T: MA less what the turn takes up [kg]
  const T M3_11 = T(1.5) - minus_kB3_1 * T(0.025165268962974188);
  const T M3_12 = minus_kB3_1 * B3_2;
  const T minus_M3_13 = minus_kB3_1 * minus_B3_3;
  const T M3_22 = T(2) - kB3_2 * B3_2;
  const T M3_23 = kB3_2 * minus_B3_3;
  const T M3_33 = T(2) - minus_kB3_3 * minus_B3_3;
  // H3 = HA3 - kK3 B3^T: HA less what the turn takes up [kg m]
  const T H3_11 = kK3_1 * T(0.025165268962974188);
  const T minus_H3_12 = T(0.005) + kK3_1 * B3_2;
  const T H3_13 = T(0.03) + kK3_1 * minus_B3_3;
  const T H3_21 = kK3_2 * T(0.025165268962974188);
  const T minus_H3_22 = kK3_2 * B3_2;
  const T H3_23 = kK3_2 * minus_B3_3 - minus_HA3_23;
  const T H3_31 = kK3_3 * T(0.025165268962974188) - T(0.03);
  const T H3_32 = minus_HA3_23 - kK3_3 * B3_2;
  const T H3_33 = kK3_3 * minus_B3_3;
  // J3 = JA3 - kK3 K3^T: JA less what the turn takes up [kg m^2]
  const T J3_11 = T(0.04165) - kK3_1 * K3_1;
  const T minus_J3_12 = T(0.004) + kK3_1 * K3_2;
  const T J3_13 = JA3_13 - kK3_1 * K3_3;
  const T J3_22 = JA3_22 - kK3_2 * K3_2;
  const T minus_J3_23 = T(0.003) + kK3_2 * K3_3;
  const T J3_33 = JA3_33 - kK3_3 * K3_3;
  // gt3 = g3 - v3 B3: force with the turn solved [N]
  const T gt3_1 = g3_1 + v3 * T(0.025165268962974188);
  const T gt3_2 = g3_2 - v3 * B3_2;
  const T gt3_3 = v3 * minus_B3_3 - minus_g3_3;
  // nt3 = n3 - v3 K3: moment with the turn solved [N m]
  const T nt3_1 = n3_1 - v3 * K3_1;
  const T nt3_2 = n3_2 - v3 * K3_2;
  const T nt3_3 = n3_3 - v3 * K3_3;
  // Mp3 = E3^T M3 E3: M passed on, lower body's axes [kg]
  const T b3_2 = E3_11 * M3_11 + E3_21 * M3_12 - E3_31 * minus_M3_13;
  const T b3_3 = E3_11 * M3_12 + E3_21 * M3_22 + E3_31 * M3_23;
  const T b3_4 = E3_21 * M3_23 - E3_11 * minus_M3_13 + E3_31 * M3_33;
  const T Mp3_11 = b3_2 * E3_11 + b3_3 * E3_21 + b3_4 * E3_31;
  const T Mp3_12 = b3_2 * E3_12 + b3_3 * E3_22 + b3_4 * E3_32;
  const T Mp3_13 = b3_3 * E3_23 - b3_2 * minus_E3_13 + b3_4 * E3_33;
  const T b3_5 = E3_12 * M3_11 + E3_22 * M3_12 - E3_32 * minus_M3_13;
  const T b3_6 = E3_12 * M3_12 + E3_22 * M3_22 + E3_32 * M3_23;
  const T b3_7 = E3_22 * M3_23 - E3_12 * minus_M3_13 + E3_32 * M3_33;
  const T Mp3_22 = b3_5 * E3_12 + b3_6 * E3_22 + b3_7 * E3_32;
  const T Mp3_23 = b3_6 * E3_23 - b3_5 * minus_E3_13 + b3_7 * E3_33;
  const T Mp3_33 = M3_11 + M3_22 + M3_33 - Mp3_11 - Mp3_22;
  // gp3 = E3^T gt3: force passed on, lower body's axes [N]
  const T gp3_1 = E3_11 * gt3_1 + E3_21 * gt3_2 + E3_31 * gt3_3;
  const T gp3_2 = E3_12 * gt3_1 + E3_22 * gt3_2 + E3_32 * gt3_3;
  const T gp3_3 = E3_23 * gt3_2 - minus_E3_13 * gt3_1 + E3_33 * gt3_3;
  // Hp3 = E3^T H3 E3: H passed on, lower body's axes [kg m]
  const T b3_8 = E3_11 * H3_11 + E3_21 * H3_21 + E3_31 * H3_31;
  const T b3_9 = E3_31 * H3_32 - (E3_11 * minus_H3_12 + E3_21 * minus_H3_22);
  const T b3_10 = E3_11 * H3_13 + E3_21 * H3_23 + E3_31 * H3_33;
  const T Hp3_11 = b3_8 * E3_11 + b3_9 * E3_21 + b3_10 * E3_31;
  const T Hp3_12 = b3_8 * E3_12 + b3_9 * E3_22 + b3_10 * E3_32;
  const T Hp3_13 = b3_9 * E3_23 - b3_8 * minus_E3_13 + b3_10 * E3_33;
  const T b3_11 = E3_12 * H3_11 + E3_22 * H3_21 + E3_32 * H3_31;
  const T b3_12 = E3_32 * H3_32 - (E3_12 * minus_H3_12 + E3_22 * minus_H3_22);
  const T b3_13 = E3_12 * H3_13 + E3_22 * H3_23 + E3_32 * H3_33;
  const T Hp3_21 = b3_11 * E3_11 + b3_12 * E3_21 + b3_13 * E3_31;
  const T Hp3_22 = b3_11 * E3_12 + b3_12 * E3_22 + b3_13 * E3_32;
  const T Hp3_23 = b3_12 * E3_23 - b3_11 * minus_E3_13 + b3_13 * E3_33;
  const T b3_14 = E3_23 * H3_21 - minus_E3_13 * H3_11 + E3_33 * H3_31;
  const T b3_15 = minus_E3_13 * minus_H3_12 - E3_23 * minus_H3_22 + E3_33 * H3_32;
  const T b3_16 = E3_23 * H3_23 - minus_E3_13 * H3_13 + E3_33 * H3_33;
  const T Hp3_31 = b3_14 * E3_11 + b3_15 * E3_21 + b3_16 * E3_31;
  const T Hp3_32 = b3_14 * E3_12 + b3_15 * E3_22 + b3_16 * E3_32;
  const T Hp3_33 = b3_15 * E3_23 - b3_14 * minus_E3_13 + b3_16 * E3_33;
  // Jp3 = E3^T J3 E3: J passed on, lower body's axes [kg m^2]
  const T b3_17 = E3_11 * J3_11 - E3_21 * minus_J3_12 + E3_31 * J3_13;
  const T b3_18 = E3_21 * J3_22 - E3_11 * minus_J3_12 - E3_31 * minus_J3_23;
  const T b3_19 = E3_11 * J3_13 - E3_21 * minus_J3_23 + E3_31 * J3_33;
  const T Jp3_11 = b3_17 * E3_11 + b3_18 * E3_21 + b3_19 * E3_31;
  const T Jp3_12 = b3_17 * E3_12 + b3_18 * E3_22 + b3_19 * E3_32;
  const T Jp3_13 = b3_18 * E3_23 - b3_17 * minus_E3_13 + b3_19 * E3_33;
  const T b3_20 = E3_12 * J3_11 - E3_22 * minus_J3_12 + E3_32 * J3_13;
  const T b3_21 = E3_22 * J3_22 - E3_12 * minus_J3_12 - E3_32 * minus_J3_23;
  const T b3_22 = E3_12 * J3_13 - E3_22 * minus_J3_23 + E3_32 * J3_33;
  const T Jp3_22 = b3_20 * E3_12 + b3_21 * E3_22 + b3_22 * E3_32;
  const T Jp3_23 = b3_21 * E3_23 - b3_20 * minus_E3_13 + b3_22 * E3_33;
  const T Jp3_33 = J3_11 + J3_22 + J3_33 - Jp3_11 - Jp3_22;
  // np3 = E3^T nt3: moment passed on, lower body's axes [N m]
  const T np3_1 = E3_11 * nt3_1 + E3_21 * nt3_2 + E3_31 * nt3_3;
  const T np3_2 = E3_12 * nt3_1 + E3_22 * nt3_2 + E3_32 * nt3_3;
  const T np3_3 = E3_23 * nt3_2 - minus_E3_13 * nt3_1 + E3_33 * nt3_3;
  // Hb3 = q3~ Mp3 + Hp3: H of the joint at the lower body's origin, its axes
  const T b3_23 = T(0.1) * Mp3_12;
  const T Hb3_11 = Hp3_11 - b3_23;
  const T Hb3_12 = Hp3_12 - T(0.1) * Mp3_22;
  const T Hb3_13 = Hp3_13 - T(0.1) * Mp3_23;
  const T Hb3_21 = Hp3_21 + T(0.1) * Mp3_11 - T(0.3) * Mp3_13;
  const T b3_24 = T(0.3) * Mp3_23;
  const T Hb3_22 = b3_23 - b3_24 + Hp3_22;
  const T Hb3_23 = Hp3_23 + T(0.1) * Mp3_13 - T(0.3) * Mp3_33;
  const T Hb3_31 = Hp3_31 + T(0.3) * Mp3_12;
  const T Hb3_32 = Hp3_32 + T(0.3) * Mp3_22;
  const T Hb3_33 = b3_24 + Hp3_33;

  // ---- body 2 (clapper) and what it carries
  // n2 = r2~ G2 + N2: moment that drives it, body axes [N m]
  const T minus_n2_1 = minus_N2_1 + T(0.2) * minus_G2_2 + T(0.02) * minus_G2_3;
  const T n2_2 = T(0.2) * minus_G2_1 - minus_N2_2;
  const T n2_3 = T(0.02) * minus_G2_1 - minus_N2_3;
  // w_2 = D(LD2)^-1 L(LD2)^-1 n2: D^-1 L^-1 n
  const T minus_w_2_1 = T(23.62948960302457) * minus_n2_1;
  const T w_2_2 = T(23.25581395348837) * n2_2;
  const T w_2_3 = T(244.9863263445761) * (n2_3 - T(0.07441860465116279) * n2_2);
  // gb2 = G2 - Y2^T w_2: force with the ball solved [N]
  const T gb2_1 = T(0.16000000000000003) * w_2_2 - minus_G2_1 + T(0.004093023255813953) * w_2_3;
  const T gb2_2 = T(0.16000000000000003) * minus_w_2_1 - minus_G2_2;
  const T gb2_3 = T(0.016) * minus_w_2_1 - minus_G2_3;
  // Mb2 = C2^T M2 C2: M of the joint, lower body's axes
  const T b2_1 = C2_11 * T(0.20054694621695532);
  const T b2_2 = C2_21 * T(0.19508506616257087) - C2_31 * T(0.06049149338374291);
  const T b2_3 = C2_31 * T(0.7939508506616257) - C2_21 * T(0.06049149338374291);
  const T Mb2_11 = b2_1 * C2_11 + b2_2 * C2_21 + b2_3 * C2_31;
  const T Mb2_12 = b2_1 * C2_12 + b2_2 * C2_22 + b2_3 * C2_32;
  const T Mb2_13 = b2_1 * C2_13 + b2_2 * C2_23 + b2_3 * C2_33;
  const T b2_4 = C2_12 * T(0.20054694621695532);
  const T b2_5 = C2_22 * T(0.19508506616257087) - C2_32 * T(0.06049149338374291);
  const T b2_6 = C2_32 * T(0.7939508506616257) - C2_22 * T(0.06049149338374291);
  const T Mb2_22 = b2_4 * C2_12 + b2_5 * C2_22 + b2_6 * C2_32;
  const T Mb2_23 = b2_4 * C2_13 + b2_5 * C2_23 + b2_6 * C2_33;
  const T Mb2_33 = T(1.189582863041152) - Mb2_11 - Mb2_22;
  // Hb2 = q2~ Mb2: H of the joint at the lower body's origin, its axes
  const T b2_7 = T(0.2) * Mb2_12;
  const T b2_8 = T(0.1) * Mb2_13;
  const T Hb2_11 = b2_7 + b2_8;
  const T b2_9 = T(0.2) * Mb2_22;
  const T Hb2_12 = b2_9 + T(0.1) * Mb2_23;
  const T b2_10 = T(0.2) * Mb2_23;
  const T Hb2_13 = b2_10 + T(0.1) * Mb2_33;
  const T b2_11 = T(0.2) * Mb2_13;
  const T minus_Hb2_21 = b2_11 + T(0.2) * Mb2_11;
  const T minus_Hb2_22 = b2_7 + b2_10;
  const T minus_Hb2_23 = b2_11 + T(0.2) * Mb2_33;
  const T Hb2_31 = b2_7 - T(0.1) * Mb2_11;
  const T Hb2_32 = b2_9 - T(0.1) * Mb2_12;
  const T Hb2_33 = b2_10 - b2_8;

  // ---- body 1 (hull) and what it carries
  // MA1 = m1 one + Ms2_10 + Ms2_8 + Mp5a + Mp4a + Mp3 + Mb2: force for an acceleration of the origin, home axes [kg]
  const T MA1_11 = T(8) + Ms2_10_11 + Ms2_8_11 + Mp5a_11 + Mp4a_11 + Mp3_11 + Mb2_11;
  const T MA1_12 = Mp5a_12 + Mp4a_12 + Mp3_12 + Mb2_12;
  const T MA1_13 = Ms2_10_13 + Ms2_8_13 + Mp4a_13 + Mp3_13 + Mb2_13;
  const T MA1_22 = T(8) + Mp5a_22 + Mp4a_22 + Mp3_22 + Mb2_22;
  const T MA1_23 = Mp4a_23 + Mp3_23 + Mb2_23;
  const T MA1_33 = T(8) + Ms2_10_33 + Ms2_8_33 + c.m_link5 + Mp4a_33 + Mp3_33 + Mb2_33;
  // HA1 = m1 r1~ + Hb2 + Hb3 + Hb4a + Hb5a + Hb8 + Hb10: moment for an acceleration of the origin, body axes [kg m]
  const T HA1_11 = Hb2_11 + Hb3_11 + Hb4a_11 - minus_Hb5a_11 + Hb8_11 + Hb10_11;
  const T HA1_12 = Hb2_12 - T(0.24) + Hb3_12 + Hb4a_12 + Hb5a_12;
  const T HA1_13 = Hb2_13 - T(0.08) + Hb3_13 + Hb4a_13 - minus_Hb5a_13 + Hb8_13 + Hb10_13;
  const T HA1_21 = T(0.24) - minus_Hb2_21 + Hb3_21 + Hb4a_21 + Hb5a_21 + Hb10_21;
  const T HA1_22 = Hb3_22 - minus_Hb2_22 + Hb4a_22 + Hb5a_22;
  const T HA1_23 = Hb3_23 - (minus_Hb2_23 + T(0.16)) + Hb4a_23 - minus_Hp5a_23 + Hb10_23;
  const T HA1_31 = Hb2_31 + T(0.08) + Hb3_31 + Hb4a_31 + Hb5a_31 + Hb8_31 - minus_Hb10_31;
  const T HA1_32 = T(0.16) + Hb2_32 + Hb3_32 + Hb4a_32 + Hb5a_32;
  const T HA1_33 = Hb2_33 + Hb3_33 + Hb4a_33 + Hb8_33 - Hb10_11;
  // JA1 = q3~ Hp3^T + q4a~ Hp4a^T + q5a~ Hp5a^T - m1 r1~ r1~ + I1 + d8~ Hs2_8^T + Js2_8 + Jp5a + Jp4a + Jp3 - Hb2 q2~
  //   - Hb3 q3~ - Hb4a q4a~ - Hb5a q5a~ - Hb8 d8~ - Hb10 d10~: moment for an angular acceleration, body axes [kg m^2]
  const T b1_1 = Hb2_12 * T(0.2);
  const T JA1_11 = T(0.608) + Js2_8_11 + Jp5a_11 + Jp4a_11 + Jp3_11 + b1_1 + T(0.1) * Hp4a_13 - T(0.1) * Hp3_12 +
      T(0.3) * minus_Hp5a_13 - T(0.1) * Hp5a_12 + d8_2 * Hs2_8_13 + Hb2_13 * T(0.1) - Hb3_12 * T(0.1) + Hb4a_13 *
      T(0.1) - Hb5a_12 * T(0.1) + minus_Hb5a_13 * T(0.3) + Hb8_13 * d8_2 + Hb10_13 * s10;
  const T JA1_12 = T(0.0216) + Jp5a_12 + Jp4a_12 + Jp3_12 + T(0.1) * Hp4a_23 - T(0.1) * Hp3_22 - T(0.1) * Hp5a_22 +
      T(0.3) * minus_Hp5a_23 - Hb2_11 * T(0.2) - Hb2_13 * T(0.2) - Hb3_13 * T(0.3) + Hb3_11 * T(0.1) + Hb4a_13 *
      T(0.2) - minus_Hb5a_11 * T(0.1) - Hb10_13 * T(0.1) + Hb10_11 * T(0.3);
  const T JA1_13 = Js2_8_13 - T(0.0148) + Jp4a_13 + Jp3_13 + b1_1 + T(0.1) * Hp4a_33 - T(0.1) * Hp3_32 + d8_2 *
      Hs2_8_33 - Hb2_11 * T(0.1) + Hb3_12 * T(0.3) - Hb4a_11 * T(0.1) - Hb4a_12 * T(0.2) - minus_Hb5a_11 * T(0.3) -
      Hb8_11 * d8_2 - Hb10_11 * s10;
  const T JA1_22 = T(0.5104) + Jp5a_22 + Jp4a_22 + Jp3_22 + T(0.1) * Hp3_21 - T(0.3) * Hp3_23 + T(0.2) * Hp4a_23 +
      T(0.1) * Hp5a_21 + minus_Hb2_21 * T(0.2) + minus_Hb2_23 * T(0.2) - Hb3_23 * T(0.3) + Hb3_21 * T(0.1) + Hb4a_23 *
      T(0.2) + Hb5a_21 * T(0.1) - Hb10_23 * T(0.1) + Hb10_21 * T(0.3);
  const T JA1_23 = T(0.0324) + Jp4a_23 + Jp3_23 + T(0.1) * Hp3_31 - T(0.3) * Hp3_33 + T(0.2) * Hp4a_33 - minus_Hb2_22
      * T(0.2) + minus_Hb2_21 * T(0.1) + Hb3_22 * T(0.3) - Hb4a_21 * T(0.1) - Hb4a_22 * T(0.2) + Hb5a_21 * T(0.3) -
      Hb10_21 * s10;
  const T JA1_33 = T(0.704) + Js2_8_33 + Jp4a_33 + Jp3_33 + T(0.3) * Hp3_32 - T(0.2) * Hp4a_32 - T(0.1) * Hp4a_31 -
      d8_2 * Hs2_8_31 - Hb2_31 * T(0.1) + Hb2_32 * T(0.2) + Hb3_32 * T(0.3) - Hb4a_31 * T(0.1) - Hb4a_32 * T(0.2) +
      Hb5a_31 * T(0.3) - Hb8_31 * d8_2 + minus_Hb10_31 * s10;
  // g1 = C2^T gb2 + G1 + gs2_10 + gs2_8 + gp5a + gp4a + gp3: force that drives it, home axes [N]
  const T b1_2 = C2_11 * gb2_1 + C2_21 * gb2_2 + C2_31 * gb2_3;
  const T g1_1 = b1_2 + G1_1 + gs2_10_1 + gs2_8_1 + gp5a_1 + gp4a_1 + gp3_1;
  const T b1_3 = C2_12 * gb2_1 + C2_22 * gb2_2 + C2_32 * gb2_3;
  const T g1_2 = b1_3 + G1_2 + gp5a_2 + gp4a_2 + gp3_2;
  const T b1_4 = C2_13 * gb2_1 + C2_23 * gb2_2 + C2_33 * gb2_3;
  const T g1_3 = b1_4 + G1_3 + gs2_10_3 + gs2_8_3 + gp5_3 + gp4a_3 + gp3_3;
  // n1 = q2~ C2^T gb2 + q3~ gp3 + q4a~ gp4a + q5a~ gp5a + r1~ G1 + d8~ gs2_8 + d10~ gs2_10 + N1 + ns2_8 + np5a + np4a
  //   + np3: moment that drives it, body axes [N m]
  const T b1_5 = T(0.2) * b1_3;
  const T n1_1 = b1_5 + N1_1 + ns2_8_1 + np5a_1 + np4a_1 + np3_1 + T(0.1) * b1_4 - T(0.1) * gp3_2 + T(0.1) * gp4a_3 -
      T(0.1) * gp5a_2 - T(0.3) * gp5_3 - T(0.03) * G1_2 - T(0.01) * G1_3 + d8_2 * gs2_8_3 + s10 * gs2_10_3;
  const T n1_2 = N1_2 + np5a_2 + np4a_2 + np3_2 - T(0.2) * b1_2 - T(0.2) * b1_4 + T(0.1) * gp3_1 - T(0.3) * gp3_3 +
      T(0.2) * gp4a_3 + T(0.1) * gp5a_1 + T(0.03) * G1_1 - T(0.02) * G1_3 + T(0.3) * gs2_10_1 - T(0.1) * gs2_10_3;
  const T n1_3 = b1_5 - minus_N1_3 + ns2_8_3 + np4a_3 + np3_3 - T(0.1) * b1_2 + T(0.3) * gp3_2 - T(0.2) * gp4a_2 -
      T(0.1) * gp4a_1 + T(0.3) * gp5a_1 + T(0.02) * G1_2 + T(0.01) * G1_1 - d8_2 * gs2_8_1 - s10 * gs2_10_1;
  // LD1 = L D L^T of JA1: L D L^T = JA: L, and 1/D on the diagonal
  const T LD1_11 = T(1) / JA1_11;
  const T LD1_21 = LD1_11 * JA1_12;
  const T LD1_22 = T(1) / (JA1_22 - LD1_21 * JA1_12);
  const T LD1_31 = LD1_11 * JA1_13;
  const T b1_6 = JA1_23 - LD1_21 * JA1_13;
  const T LD1_32 = LD1_22 * b1_6;
  const T LD1_33 = T(1) / (JA1_33 - LD1_31 * JA1_13 - LD1_32 * b1_6);
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
  const T b1_7 = n1_2 - LD1_21 * n1_1;
  const T w_1_2 = LD1_22 * b1_7;
  const T w_1_3 = LD1_33 * (n1_3 - LD1_31 * n1_1 - LD1_32 * b1_7);
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
  const T b1_8 = M1_23 - LDs1_21 * M1_13;
  const T LDs1_32 = LDs1_22 * b1_8;
  const T LDs1_33 = T(1) / (M1_33 - LDs1_31 * M1_13 - LDs1_32 * b1_8);
  // ws1 = D(LDs1)^-1 L(LDs1)^-1 gb1: D^-1 L^-1 g
  const T ws1_1 = LDs1_11 * gb1_1;
  const T b1_9 = gb1_2 - LDs1_21 * gb1_1;
  const T ws1_2 = LDs1_22 * b1_9;
  const T ws1_3 = LDs1_33 * (gb1_3 - LDs1_31 * gb1_1 - LDs1_32 * b1_9);

  // ---- body 1 (hull), solved
  // Pddot1 = L(LDs1)^-T ws1
  const T z1_1 = ws1_2 - LDs1_32 * ws1_3;
  const T Pddot1_1 = ws1_1 - LDs1_21 * z1_1 - LDs1_31 * ws1_3;
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
  ydot[16] = sddot1_1;
  ydot[17] = sddot1_2;
  ydot[18] = sddot1_3;

  // ---- body 2 (clapper), solved
  // beta2 = -C2 q2~ omegadot1 + C2 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z2_1 = T(0.2) * z1_2;
  const T z2_2 = z2_1 + T(0.2) * omegadot1_1;
  const T z2_3 = T(0.2) * z1_3;
  const T z2_4 = T(0.1) * z1_2;
  const T z2_5 = z2_3 + z2_4;
  const T z2_6 = T(0.1) * omegadot1_1;
  const T z2_7 = z2_3 - z2_6;
  const T beta2_1 = C2_12 * z2_2 - C2_11 * z2_5 - C2_13 * z2_7 + C2_11 * Pddot1_1 + C2_12 * z1_1 + C2_13 * ws1_3;
  const T beta2_2 = C2_22 * z2_2 - C2_21 * z2_5 - C2_23 * z2_7 + C2_21 * Pddot1_1 + C2_22 * z1_1 + C2_23 * ws1_3;
  const T beta2_3 = C2_32 * z2_2 - C2_31 * z2_5 - C2_33 * z2_7 + C2_31 * Pddot1_1 + C2_32 * z1_1 + C2_33 * ws1_3;
  // omegadot2 = L(LD2)^-T (-W2 beta2 + w_2)
  const T minus_omegadot2_1 = minus_w_2_1 + T(3.780718336483932) * beta2_2 + T(0.3780718336483932) * beta2_3;
  const T z2_8 = w_2_3 + T(1.0027347310847765) * beta2_1;
  const T omegadot2_2 = w_2_2 + T(3.7209302325581395) * beta2_1 - T(0.07441860465116279) * z2_8;
  ydot[3] = -minus_omegadot2_1;
  ydot[4] = omegadot2_2;
  ydot[5] = z2_8;

  // ---- body 3 (boom), solved
  // beta3 = -E3 q3~ omegadot1 + E3 Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z3_1 = T(0.1) * z1_3;
  const T z3_2 = T(0.3) * z1_2;
  const T z3_3 = z2_6 - z3_2;
  const T z3_4 = T(0.3) * z1_3;
  const T beta3_1 = E3_11 * z3_1 - E3_12 * z3_3 + minus_E3_13 * z3_4 + E3_11 * Pddot1_1 + E3_12 * z1_1 - minus_E3_13 *
      ws1_3;
  const T beta3_2 = E3_21 * z3_1 - E3_22 * z3_3 - E3_23 * z3_4 + E3_21 * Pddot1_1 + E3_22 * z1_1 + E3_23 * ws1_3;
  const T beta3_3 = E3_31 * z3_1 - E3_32 * z3_3 - E3_33 * z3_4 + E3_31 * Pddot1_1 + E3_32 * z1_1 + E3_33 * ws1_3;
  // alphaL3 = E3 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL3_1 = E3_11 * omegadot1_1 + E3_12 * z1_3 - minus_E3_13 * z1_2;
  const T alphaL3_2 = E3_21 * omegadot1_1 + E3_22 * z1_3 + E3_23 * z1_2;
  const T alphaL3_3 = E3_31 * omegadot1_1 + E3_32 * z1_3 + E3_33 * z1_2;
  // phi3 = -kB3 . beta3 - kK3 . alphaL3 + v3
  const T phi3 = v3 + minus_kB3_1 * beta3_1 - kB3_2 * beta3_2 + minus_kB3_3 * beta3_3 - kK3_1 * alphaL3_1 - kK3_2 *
      alphaL3_2 - kK3_3 * alphaL3_3;
  ydot[6] = phi3;
  // alpha3 = alphaL3 + phi3 b3: angular acceleration beyond that at ydot = 0, body axes [rad/s^2]
  const T alpha3_2 = alphaL3_2 + phi3 * T(0.44378789320576517);

  // ---- body 4 (cross), solved
  // beta4a = -E4a q4a~ omegadot1 + E4a Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z4_1 = z2_3 + z2_6;
  const T beta4a_1 = minus_E4a_12 * z2_1 - E4a_11 * z2_4 - minus_E4a_13 * z4_1 + E4a_11 * Pddot1_1 - minus_E4a_12 *
      z1_1 - minus_E4a_13 * ws1_3;
  const T beta4a_2 = E4a_23 * z4_1 - (minus_E4a_12 * z2_4 + E4a_22 * z2_1) + minus_E4a_12 * Pddot1_1 + E4a_22 * z1_1 +
      E4a_23 * ws1_3;
  const T beta4a_3 = E4a_33 * z4_1 - (minus_E4a_13 * z2_4 + E4a_23 * z2_1) + minus_E4a_13 * Pddot1_1 + E4a_23 * z1_1 +
      E4a_33 * ws1_3;
  // alphaL4a = E4a omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4a_1 = E4a_11 * omegadot1_1 - minus_E4a_12 * z1_3 - minus_E4a_13 * z1_2;
  const T alphaL4a_2 = minus_E4a_12 * omegadot1_1 + E4a_22 * z1_3 + E4a_23 * z1_2;
  const T alphaL4a_3 = minus_E4a_13 * omegadot1_1 + E4a_23 * z1_3 + E4a_33 * z1_2;
  // phi4a = -kB4a . beta4a - kK4a . alphaL4a + v4a
  const T phi4a = v4a - kB4a_2 * beta4a_2 - kB4a_3 * beta4a_3 - kK4a_1 * alphaL4a_1 - kK4a_2 * alphaL4a_2 +
      minus_kK4a_3 * alphaL4a_3;
  ydot[7] = phi4a;
  // alpha4a = alphaL4a + phi4a b4_1: angular acceleration beyond that at ydot = 0, body axes [rad/s^2]
  const T alpha4a_2 = alphaL4a_2 + phi4a * T(0.28);
  const T alpha4a_3 = alphaL4a_3 - phi4a * T(0.96);
  // beta4 = E4 beta4a: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta4_1 = E4_12 * beta4a_2 - minus_E4_11 * beta4a_1 - minus_E4_13 * beta4a_3;
  const T beta4_3 = t4_5 * beta4a_1 + E4_32 * beta4a_2 - minus_E4_33 * beta4a_3;
  // alphaL4 = E4 alpha4a: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL4_2 = T(0.96) * alpha4a_2 + T(0.28) * alpha4a_3;
  // phi4 = -kB4 . beta4 + v4 - (P_b4_2 kK4) . alphaL4
  const T phi4 = v4 + T(1.6061867935752527) * beta4_3 - T(5.353955978584176) * beta4_1;
  // thetaddot4_2 = -b4_2 . alphaL4 + phi4
  const T thetaddot4_2 = phi4 - alphaL4_2;
  ydot[8] = thetaddot4_2;

  // ---- body 5 (camera), solved
  // beta5a = -E5a q5a~ omegadot1 + E5a Pddot1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T z5_1 = z3_1 + z3_2;
  const T beta5a_1 = E5a_11 * z5_1 - E5a_12 * z2_6 + E5a_11 * Pddot1_1 + E5a_12 * z1_1;
  const T beta5a_2 = E5a_11 * z1_1 - (E5a_11 * z2_6 + E5a_12 * z5_1) - E5a_12 * Pddot1_1;
  // alphaL5a = E5a omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL5a_1 = E5a_11 * omegadot1_1 + E5a_12 * z1_3;
  const T alphaL5a_2 = E5a_11 * z1_3 - E5a_12 * omegadot1_1;
  // phi5a = -kB5a . beta5a + v5a - (P_b5_1 kK5a) . alphaL5a
  const T phi5a = v5a - kB5a_1 * beta5a_1 - kB5a_2 * beta5a_2 - kK5a_1 * alphaL5a_1 - kK5a_2 * alphaL5a_2;
  // thetaddot5_1 = -b5_1 . alphaL5a + phi5a
  const T thetaddot5_1 = phi5a - z1_2;
  ydot[9] = thetaddot5_1;

  // ---- body 6 (telescope), solved
  // phi6 = -kK6 . alpha3 + v6 - (P_u6 kB6) . Pj6
  const T phi6 = v6 - T(0.01) * alpha3_2;
  // sddot6 = -u6 . Pj6 + phi6
  const T sddot6 = phi6 - beta3_1;
  ydot[19] = sddot6;

  // ---- body 8 (piston), solved
  // Pj2_8 = -d8~ omegadot1 + Pddot1: acceleration of the joint beyond that at ydot = 0 [m/s^2]
  const T Pj2_8_1 = Pddot1_1 - d8_2 * z1_2;
  const T Pj2_8_3 = ws1_3 + d8_2 * omegadot1_1;
  // phi2_8 = -kK2_8 . omegadot1 + v2_8 - (P_u8 kB2_8) . Pj2_8
  const T phi2_8 = minus_kK2_8_1 * omegadot1_1 - minus_v2_8 + minus_kK2_8_3 * z1_2 + minus_kB2_8_1 * Pj2_8_1 +
      minus_kB2_8_3 * Pj2_8_3;
  // sddot8 = -u8 . Pj2_8 + phi2_8
  const T sddot8 = z1_1 + phi2_8;
  ydot[22] = sddot8;
  // beta8 = E8 P_u8 Pj2_8 + phi2_8 E8 u8: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta8_1 = E8_11 * Pj2_8_1 + E8_13 * Pj2_8_3;
  const T beta8_3 = E8_11 * Pj2_8_3 - E8_13 * Pj2_8_1;
  // alphaL8 = E8 omegadot1: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL8_1 = E8_11 * omegadot1_1 + E8_13 * z1_2;
  const T alphaL8_3 = E8_11 * z1_2 - E8_13 * omegadot1_1;
  // phi8 = -kB1_8 . beta8 + v1_8 - (P_b8 kK1_8) . alphaL8
  const T phi8 = minus_kB1_8_1 * beta8_1 - minus_v1_8 + T(1.2038983374737244) * phi2_8 + minus_kB1_8_3 * beta8_3 +
      minus_kK1_8_1 * alphaL8_1 + minus_kK1_8_3 * alphaL8_3;
  // thetaddot8 = -b8 . alphaL8 + phi8
  const T thetaddot8 = z1_3 + phi8;
  ydot[10] = thetaddot8;

  // ---- body 9 (sled), solved
  // phi2_9 = v2_9 - (P_u9_1 kB2_9) . Pj2_9
  const T phi2_9 = v2_9 - kB2_9_2 * v3_9;
  ydot[23] = phi2_9;
  // beta9 = E9 P_u9_1 Pj2_9 + phi2_9 E9 u9_1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta9_2 = E9_11 * v3_9 - phi2_9 * E9_12;
  // phi9 = -kB1_9 . beta9 + v1_9
  const T minus_phi9 = minus_v1_9 + T(2) * beta9_2;
  ydot[11] = -minus_phi9;

  // ---- body 10 (runner), solved
  // Pj2_10 = -d10~ omegadot1 + Pddot1: acceleration of the joint beyond that at ydot = 0 [m/s^2]
  const T Pj2_10_1 = z3_4 + Pddot1_1 - s10 * z1_2;
  const T Pj2_10_2 = z2_4 + z1_1 - T(0.3) * omegadot1_1;
  const T Pj2_10_3 = ws1_3 - z3_1 + s10 * omegadot1_1;
  // phi2_10 = v2_10 - (P_u10 kB2_10) . Pj2_10
  const T phi2_10 = v2_10 - kB2_10_1 * Pj2_10_1 - kB2_10_3 * Pj2_10_3;
  // sddot10 = -u10 . Pj2_10 + phi2_10
  const T sddot10 = phi2_10 - Pj2_10_2;
  ydot[25] = sddot10;
  // beta10 = C10 P_u10 Pj2_10 + phi2_10 C10 u10: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta10_1 = C10_11 * Pj2_10_1 + C10_13 * Pj2_10_3 + phi2_10 * C10_12;
  const T beta10_2 = C10_21 * Pj2_10_1 + C10_23 * Pj2_10_3 + phi2_10 * C10_22;
  const T beta10_3 = C10_31 * Pj2_10_1 + C10_33 * Pj2_10_3 + phi2_10 * C10_32;
  // omegadot10 = L(LD10)^-T (-W10 beta10 + w_10)
  const T z10_1 = w_10_3 + T(1.3339009507591884) * beta10_1 - T(2.5400879807010077) * beta10_2 +
      T(0.04257130693912303) * beta10_3;
  const T z10_2 = w_10_2 + T(3.411675511751327) * beta10_1 - T(0.11372251705837756) * beta10_2 + T(2.2365428354814254)
      * beta10_3 - T(0.03639120545868082) * z10_1;
  const T omegadot10_1 = w_10_1 - T(5) * beta10_2 - T(1.6666666666666667) * beta10_3 + T(0.03333333333333333) * z10_2
      - T(0.1) * z10_1;
  ydot[12] = omegadot10_1;
  ydot[13] = z10_2;
  ydot[14] = z10_1;

  // ---- body 11 (nut), solved
  // beta11 = -E11 d11~ alpha8 + E11 beta8: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta11_1 = minus_d11_2 * alphaL8_3 * E11_11 - minus_d11_2 * alphaL8_1 * E11_13 + E11_11 * beta8_1 + E11_13 *
      beta8_3;
  // alphaL11 = E11 alpha8: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL11_1 = E11_11 * alphaL8_1 + E11_13 * alphaL8_3;
  // phi11 = -kB11 . beta11 - kK11 . alphaL11 + v11
  const T phi11 = v11 + T(4.545454545454546) * beta11_1 - T(4.545454545454546) * phi2_8 - T(0.045454545454545456) *
      alphaL11_1 - T(0.9545454545454546) * phi8;
  ydot[15] = phi11;

  // ---- body 1 (hull) on the inertial frame
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

  // ---- body 2 (clapper) on body 1
  // w2 = 1/2 omega2: half the angular velocity [rad/s]
  const T w2_1 = T(0.5) * omega2_1;
  const T w2_2 = T(0.5) * omega2_2;
  const T w2_3 = T(0.5) * omega2_3;
  // edot2 = e2~ w2 + eps4_2 w2: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot2_1 = eps2_2 * w2_3 - eps2_3 * w2_2 + eps2_4 * w2_1;
  const T edot2_2 = eps2_3 * w2_1 - eps2_1 * w2_3 + eps2_4 * w2_2;
  const T edot2_3 = eps2_1 * w2_2 - eps2_2 * w2_1 + eps2_4 * w2_3;
  xdot[4] = edot2_1;
  xdot[5] = edot2_2;
  xdot[6] = edot2_3;
  // eps4dot2 = -e2 . w2: rate of eps_4 [1/s]
  const T minus_eps4dot2 = eps2_1 * w2_1 + eps2_2 * w2_2 + eps2_3 * w2_3;
  xdot[7] = -minus_eps4dot2;

  // ---- body 10 (runner) on body 1
  // w10 = 1/2 omega10: half the angular velocity [rad/s]
  const T w10_1 = T(0.5) * omega10_1;
  const T w10_2 = T(0.5) * omega10_2;
  const T w10_3 = T(0.5) * omega10_3;
  // edot10 = e10~ w10 + eps4_10 w10: rates of eps_1, eps_2, eps_3 [1/s]
  const T edot10_1 = eps10_2 * w10_3 - eps10_3 * w10_2 + eps10_4 * w10_1;
  const T edot10_2 = eps10_3 * w10_1 - eps10_1 * w10_3 + eps10_4 * w10_2;
  const T edot10_3 = eps10_1 * w10_2 - eps10_2 * w10_1 + eps10_4 * w10_3;
  xdot[14] = edot10_1;
  xdot[15] = edot10_2;
  xdot[16] = edot10_3;
  // eps4dot10 = -e10 . w10: rate of eps_4 [1/s]
  const T minus_eps4dot10 = eps10_1 * w10_1 + eps10_2 * w10_2 + eps10_3 * w10_3;
  xdot[17] = -minus_eps4dot10;

  // ---- results
  const T sdot7_1 = y[20], sdot7_2 = y[21];
  const T sdot13_1 = y[26], sdot13_2 = y[27], sdot13_3 = y[28];
  xdot[8] = thetadot3;
  xdot[9] = thetadot4_1;
  xdot[10] = thetadot4_2;
  xdot[11] = thetadot5_1;
  xdot[12] = thetadot8;
  xdot[13] = thetadot9;
  xdot[18] = thetadot11;
  xdot[19] = sdot1_1;
  xdot[20] = sdot1_2;
  xdot[21] = sdot1_3;
  xdot[22] = sdot6;
  xdot[23] = sdot7_1;
  xdot[24] = sdot7_2;
  xdot[25] = sdot8;
  xdot[26] = sdot9_1;
  xdot[27] = sdot9_2;
  xdot[28] = sdot10;
  xdot[29] = sdot13_1;
  xdot[30] = sdot13_2;
  xdot[31] = sdot13_3;
  ydot[20] = -T(0);
  ydot[21] = -T(0);
  ydot[26] = -T(0);
  ydot[27] = T(0);
  ydot[28] = -T(9.81);
}

}  // namespace kanec::every_joint
