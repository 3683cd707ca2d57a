// SPDX-License-Identifier: BSD-3-Clause
// double_pendulum: equations of motion of 2 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model c86d6c4969c1f0dd of double_pendulum/scene.toml; the usual functions
// bodies and their joints:
//   1 upper on the inertial frame: revolute
//   2 lower on 1: revolute
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (theta_1, theta_2)
//   y = (thetadot_1, thetadot_2)
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
//   poses                   12 (4 add, 8 multiply, 4 sine or cosine)
//   energy                  41 (12 add, 29 multiply, 4 sine or cosine)
//   momentum                40 (14 add, 26 multiply, 4 sine or cosine)
//   accelerations           28 (9 add, 18 multiply, 1 divide, 4 sine or cosine)
//   residual                24 (10 add, 14 multiply, 4 sine or cosine)
//   forcing                 15 (5 add, 10 multiply, 4 sine or cosine)
//   mass_matrix             4 (3 add, 1 multiply, 1 sine or cosine)
//   partial_velocities      12 (4 add, 8 multiply, 4 sine or cosine)
//   partial_velocity_rates  17 (5 add, 12 multiply, 4 sine or cosine)
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

namespace kanec::double_pendulum {

inline constexpr int n_bodies = 2;
inline constexpr int nx = 2;
inline constexpr int ny = 2;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 0;
inline constexpr char model_hash[] = "c86d6c4969c1f0dd";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_1 = 0, theta_2 = 1;
inline constexpr int thetadot_1 = 0, thetadot_2 = 1;
inline constexpr int theta_upper = 0, theta_lower = 1;
inline constexpr int thetadot_upper = 0, thetadot_lower = 1;
}  // namespace at

// Entries of mass_matrix that are not always 0, row by row.
inline constexpr int mass_matrix_nonzeros = 4;
inline constexpr int mass_matrix_rows[] = {0, 0, 1, 1};
inline constexpr int mass_matrix_columns[] = {0, 1, 0, 1};

// Run-time parameters with the scene's defaults, SI units.
template <class T>
struct Parameters {
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
  xdot[0] = thetadot1;
  xdot[1] = thetadot2;
}

// poses: attitude R and mass centre p of each body.
// R (3 x 3) and p (3) [m] of body 1, of body 2, ... (n_bodies * 12)
// 4 add, 8 multiply, 4 sine or cosine
template <class T>
void poses([[maybe_unused]] const Prepared<T>& c, const T* x, T* pose) noexcept {
  for (int i = 0; i < 24; ++i) pose[i] = T(0);
  T cosines[2], sines[2];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 2, cosines, sines);

  // ---- body 1 (upper) on the inertial frame
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  pose[0] = E1_11;
  pose[8] = E1_11;
  pose[2] = -minus_E1_13;
  pose[6] = minus_E1_13;
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T minus_p1_1 = minus_E1_13 * T(0.5);
  const T minus_p1_3 = E1_11 * T(0.5);
  pose[9] = -minus_p1_1;
  pose[11] = -minus_p1_3;

  // ---- body 2 (lower) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  pose[12] = R2_11;
  pose[20] = R2_11;
  pose[14] = -minus_R2_13;
  pose[18] = minus_R2_13;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T minus_p2_1 = minus_E1_13 + minus_R2_13 * T(0.3);
  const T minus_p2_3 = E1_11 + R2_11 * T(0.3);
  pose[21] = -minus_p2_1;
  pose[23] = -minus_p2_3;

  // ---- results
  pose[4] = T(1);
  pose[16] = T(1);
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 12 add, 29 multiply, 4 sine or cosine
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  T cosines[2], sines[2];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 2, cosines, sines);

  // ---- body 1 (upper) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T minus_p1_3 = E1_11 * T(0.5);
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_1 = thetadot1 * T(0.5);
  const T minus_v1_1 = E1_11 * t1_1;
  const T v1_3 = minus_E1_13 * t1_1;
  // T1 = 1/2 omega1 . (I1 omega1) + 1/2 m1 v1 . v1: kinetic energy [J]
  const T T1 = T(0.1) * thetadot1 * thetadot1 * T(0.5) + T(0.6) * (minus_v1_1 * minus_v1_1 + v1_3 * v1_3);

  // ---- body 2 (lower) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + thetadot1;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T minus_p2_3 = E1_11 + R2_11 * T(0.3);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T minus_Pdot2_1 = E1_11 * thetadot1;
  const T Pdot2_3 = minus_E1_13 * thetadot1;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_1 = omega2_2 * T(0.3);
  const T minus_v2_1 = R2_11 * t2_1 + minus_Pdot2_1;
  const T v2_3 = minus_R2_13 * t2_1 + Pdot2_3;
  // T2 = 1/2 omega2 . (I2 omega2) + 1/2 m2 v2 . v2: kinetic energy [J]
  const T T2 = T(0.018) * omega2_2 * omega2_2 * T(0.5) + T(0.3) * (minus_v2_1 * minus_v2_1 + v2_3 * v2_3);

  // ---- whole system
  // kinetic = T1 + T2: kinetic energy of the system [J]
  const T kinetic = T1 + T2;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2: first moment of mass, inertial axes [kg m]
  const T minus_mp_3 = T(1.2) * minus_p1_3 + T(0.6) * minus_p2_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T minus_potential = T(9.81) * minus_mp_3;
  energy[1] = -minus_potential;
}

// momentum: linear and angular momentum, inertial axes, about the inertial origin.
// linear (3) [kg m/s], angular (3) [kg m^2/s]
// 14 add, 26 multiply, 4 sine or cosine
template <class T>
void momentum([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* momentum) noexcept {
  T cosines[2], sines[2];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 2, cosines, sines);

  // ---- body 1 (upper) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // p1 = E1^T r1: position of the mass centre, inertial axes [m]
  const T minus_p1_1 = minus_E1_13 * T(0.5);
  const T minus_p1_3 = E1_11 * T(0.5);
  // v1 = E1^T omega1~ r1: velocity of the mass centre, inertial axes [m/s]
  const T t1_1 = thetadot1 * T(0.5);
  const T minus_v1_1 = E1_11 * t1_1;
  const T v1_3 = minus_E1_13 * t1_1;
  // l1 = m1 v1: linear momentum, inertial axes [kg m/s]
  const T minus_l1_1 = T(1.2) * minus_v1_1;
  const T l1_3 = T(1.2) * v1_3;
  // H1 = E1^T I1 omega1 + p1~ l1: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T H1_2 = T(0.1) * thetadot1 + minus_p1_3 * minus_l1_1 + minus_p1_1 * l1_3;

  // ---- body 2 (lower) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + thetadot1;
  // p2 = R2^T r2 + P2: position of the mass centre, inertial axes [m]
  const T minus_p2_1 = minus_E1_13 + minus_R2_13 * T(0.3);
  const T minus_p2_3 = E1_11 + R2_11 * T(0.3);
  // Pdot2 = E1^T omega1~ q2: velocity of the body origin, inertial axes [m/s]
  const T minus_Pdot2_1 = E1_11 * thetadot1;
  const T Pdot2_3 = minus_E1_13 * thetadot1;
  // v2 = R2^T omega2~ r2 + Pdot2: velocity of the mass centre, inertial axes [m/s]
  const T t2_1 = omega2_2 * T(0.3);
  const T minus_v2_1 = R2_11 * t2_1 + minus_Pdot2_1;
  const T v2_3 = minus_R2_13 * t2_1 + Pdot2_3;
  // l2 = m2 v2: linear momentum, inertial axes [kg m/s]
  const T minus_l2_1 = T(0.6) * minus_v2_1;
  const T l2_3 = T(0.6) * v2_3;
  // H2 = R2^T I2 omega2 + p2~ l2: angular momentum about the inertial origin, inertial axes [kg m^2/s]
  const T H2_2 = T(0.018) * omega2_2 + minus_p2_3 * minus_l2_1 + minus_p2_1 * l2_3;

  // ---- whole system
  // linear = l1 + l2: linear momentum of the system [kg m/s]
  const T minus_linear_1 = minus_l1_1 + minus_l2_1;
  const T linear_3 = l1_3 + l2_3;
  momentum[0] = -minus_linear_1;
  momentum[2] = linear_3;
  // angular = H1 + H2: angular momentum of the system about the inertial origin [kg m^2/s]
  const T angular_2 = H1_2 + H2_2;
  momentum[4] = angular_2;

  // ---- results
  momentum[1] = T(0);
  momentum[3] = T(0);
  momentum[5] = T(0);
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 9 add, 18 multiply, 1 divide, 4 sine or cosine
// by: articulated; composite would take 11 add, 17 multiply, 1 divide, 4 sine or cosine
template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* ydot) noexcept {
  T cosines[2], sines[2];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 2, cosines, sines);

  // ---- body 1 (upper) on the inertial frame
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
  const T minus_N1_2 = T(1.2) * minus_Pddot1_1;

  // ---- body 2 (lower) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + thetadot1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U2_11 = omega2_2 * omega2_2;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = E2_11 * minus_Pddot1_1 + minus_E2_13 * (minus_U1_11 + Pddot1_3);
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_3 = minus_U2_11 * T(0.18);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_2 = T(0.18) * minus_Pddot2_1;

  // ---- body 2 (lower) and what it carries
  // v2 = invD2 u_2: u/D
  const T minus_v2 = T(13.888888888888891) * minus_N2_2;
  // gt2 = G2 - v2 B2: force with the turn solved [N]
  const T minus_gt2_1 = minus_v2 * T(0.18);
  // Mp2 = E2^T M2 E2: M passed on, lower body's axes [kg]
  const T Mp2_11 = minus_E2_13 * T(0.44999999999999996) * minus_E2_13 - T(0.44999999999999996);
  // gp2 = E2^T gt2: force passed on, lower body's axes [N]
  const T minus_gp2_1 = E2_11 * minus_gt2_1 + minus_E2_13 * minus_G2_3;

  // ---- body 1 (upper) and what it carries
  // JA1 = q2~ Hp2^T + J_own_1 + Jp2 - Hb2 q2~: moment for an angular acceleration, body axes [kg m^2]
  const T JA1_22 = T(1) + Mp2_11;
  // n1 = q2~ gp2 + N1 + np2: moment that drives it, body axes [N m]
  const T minus_n1_2 = minus_N1_2 - minus_gp2_1;
  // invD1 = D1^-1: 1/D
  const T invD1 = T(1) / JA1_22;
  // v1 = invD1 u_1: u/D
  const T minus_v1 = invD1 * minus_n1_2;
  ydot[0] = -minus_v1;

  // ---- body 2 (lower), solved
  // beta2 = -E2 q2~ alpha1: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta2_1 = E2_11 * minus_v1;
  // phi2 = -kB2 . beta2 + v2 - (P_b2 kK2) . alphaL2
  const T minus_phi2 = minus_v2 - T(2.5) * beta2_1;
  // thetaddot2 = -b2 . alphaL2 + phi2
  const T thetaddot2 = minus_v1 - minus_phi2;
  ydot[1] = thetaddot2;
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 10 add, 14 multiply, 4 sine or cosine
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, T* r) noexcept {
  T cosines[2], sines[2];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 2, cosines, sines);

  // ---- body 1 (upper) on the inertial frame
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
  const T N1_2 = T(1.2) * minus_Pddot1_1 + T(1) * thetaddot1;

  // ---- body 2 (lower) on body 1
  const T thetadot2 = y[1];
  const T thetaddot2 = ydot[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + thetadot1;
  // omegadot2 = -thetadot2 b2~ E2 omega1 + thetaddot2 b2 + E2 omegadot1: angular acceleration, body axes [rad/s^2]
  const T omegadot2_2 = thetaddot2 + thetaddot1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U2_11 = omega2_2 * omega2_2;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = E2_11 * (thetaddot1 + minus_Pddot1_1) + minus_E2_13 * (minus_U1_11 + Pddot1_3);
  // G2 = U2 h_own_2: inertia less applied force, body axes [N]
  const T minus_G2_1 = omegadot2_2 * T(0.18);
  const T G2_3 = minus_U2_11 * T(0.18);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_2 = T(0.18) * minus_Pddot2_1 + T(0.072) * omegadot2_2;
  r[1] = N2_2;

  // ---- body 1 (upper) and what it carries
  // rho1 = q2~ E2^T G2 + E2^T N2 + N1: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T rho1_2 = N2_2 + N1_2 + E2_11 * minus_G2_1 - minus_E2_13 * G2_3;
  r[0] = rho1_2;
}

// forcing: f of A ydot = f.
// f (ny) [N m], [N]
// 5 add, 10 multiply, 4 sine or cosine
template <class T>
void forcing([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* f) noexcept {
  T cosines[2], sines[2];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 2, cosines, sines);

  // ---- body 1 (upper) on the inertial frame
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
  const T minus_N1_2 = T(1.2) * minus_Pddot1_1;

  // ---- body 2 (lower) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + thetadot1;
  // U2 = omega2~ omega2~ + omegadot2~: takes a point fixed in the body to its acceleration due to rotation, body axes
  //   [1/s^2]
  const T minus_U2_11 = omega2_2 * omega2_2;
  // Pddot2 = E2 (U1 q2 + Pddot1): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T minus_Pddot2_1 = E2_11 * minus_Pddot1_1 + minus_E2_13 * (minus_U1_11 + Pddot1_3);
  // G2 = -U2 h_own_2: applied less inertia force, body axes [N]
  const T minus_G2_3 = minus_U2_11 * T(0.18);
  // N2 = -h_own_2~ Pddot2 - axial(U2 (tr(J_own_2)/2 - J_own_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T minus_N2_2 = T(0.18) * minus_Pddot2_1;
  f[1] = -minus_N2_2;

  // ---- body 1 (upper) and what it carries
  // rho1 = q2~ E2^T G2 + E2^T N2 + N1: sum of the moment balances of the subtree about the body origin, body axes [N
  //   m]
  const T minus_rho1_2 = minus_N2_2 - minus_E2_13 * minus_G2_3 + minus_N1_2;
  f[0] = -minus_rho1_2;
}

// mass_matrix: A, symmetric positive definite.
// A (ny x ny) [kg m^2], [kg m], [kg]
// 3 add, 1 multiply, 1 sine or cosine
template <class T>
void mass_matrix([[maybe_unused]] const Prepared<T>& c, const T* x, T* A) noexcept {
  using std::cos;

  // ---- body 2 (lower) on body 1
  const T theta2 = x[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cos(theta2);

  // ---- body 2 (lower) and what it carries
  // hc2 = E2^T h_own_2: first moment carried, about the body origin, lower body's axes [kg m]
  const T minus_hc2_3 = E2_11 * T(0.18);

  // ---- body 1 (upper) and what it carries
  // J1 = -q2~ hc2~ + E2^T J_own_2 E2 + J_own_1 - hc2~ q2~: inertia carried, about the body origin, body axes [kg m^2]
  const T b1_1 = minus_hc2_3 + T(0.072);
  const T J1_22 = b1_1 + T(1) + minus_hc2_3;
  A[0] = J1_22;
  A[1] = b1_1;
  A[2] = b1_1;

  // ---- results
  A[3] = T(0.072);
}

// partial_velocities: partial velocities v_y of the mass centres: v = v_y y.
// v_y of body 1, of body 2, ... (n_bodies x 3 x ny)
// 4 add, 8 multiply, 4 sine or cosine
template <class T>
void partial_velocities([[maybe_unused]] const Prepared<T>& c, const T* x, T* v_y) noexcept {
  T cosines[2], sines[2];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 2, cosines, sines);

  // ---- body 1 (upper) on the inertial frame
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // B1_1 = -E1^T r1~ b1
  const T minus_B1_1_1 = E1_11 * T(0.5);
  const T B1_1_3 = minus_E1_13 * T(0.5);
  v_y[0] = -minus_B1_1_1;
  v_y[4] = B1_1_3;

  // ---- body 2 (lower) on body 1
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // B2_1 = -R2^T r2~ omega_thetadot1_2 + P_thetadot1_2
  const T t2_1 = R2_11 * T(0.3);
  const T minus_B2_1_1 = E1_11 + t2_1;
  const T t2_2 = minus_R2_13 * T(0.3);
  const T B2_1_3 = minus_E1_13 + t2_2;
  v_y[6] = -minus_B2_1_1;
  v_y[10] = B2_1_3;
  v_y[7] = -t2_1;
  v_y[11] = t2_2;

  // ---- results
  v_y[1] = T(0);
  v_y[2] = -T(0);
  v_y[3] = T(0);
  v_y[5] = T(0);
  v_y[8] = -T(0);
  v_y[9] = -T(0);
}

// partial_velocity_rates: time derivatives of the partial velocities.
// v_y_dot of body 1, of body 2, ... (n_bodies x 3 x ny)
// 5 add, 12 multiply, 4 sine or cosine
template <class T>
void partial_velocity_rates([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* v_y_dot) noexcept {
  T cosines[2], sines[2];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 2, cosines, sines);

  // ---- body 1 (upper) on the inertial frame
  const T thetadot1 = y[0];
  // E1^T = Rot(b1, theta1): E takes components in the lower body to those in the body
  const T E1_11 = cosines[0];
  const T minus_E1_13 = sines[0];
  // B1_1 = -E1^T omega1~ r1~ b1
  const T t1_1 = thetadot1 * T(0.5);
  const T B1_1_1 = minus_E1_13 * t1_1;
  const T B1_1_3 = E1_11 * t1_1;
  v_y_dot[0] = B1_1_1;
  v_y_dot[4] = B1_1_3;

  // ---- body 2 (lower) on body 1
  const T thetadot2 = y[1];
  // E2^T = Rot(b2, theta2): E takes components in the lower body to those in the body
  const T E2_11 = cosines[1];
  const T minus_E2_13 = sines[1];
  // R2^T = E1^T E2^T: R takes inertial components to body components
  const T R2_11 = E1_11 * E2_11 - minus_E1_13 * minus_E2_13;
  const T minus_R2_13 = minus_E1_13 * E2_11 + E1_11 * minus_E2_13;
  // omega2 = thetadot2 b2 + E2 omega1: absolute angular velocity, body axes [rad/s]
  const T omega2_2 = thetadot2 + thetadot1;
  // P_dot_thetadot1_2 = -E1^T omega1~ q2~ b1: its rate
  const T P_dot_thetadot1_2_1 = minus_E1_13 * thetadot1;
  const T P_dot_thetadot1_2_3 = E1_11 * thetadot1;
  // B2_1 = -R2^T omega2~ r2~ omega_thetadot1_2 - R2^T r2~ omega_dot_thetadot1_2 + P_dot_thetadot1_2
  const T t2_1 = omega2_2 * T(0.3);
  const T t2_2 = minus_R2_13 * t2_1;
  const T B2_1_1 = t2_2 + P_dot_thetadot1_2_1;
  const T t2_3 = R2_11 * t2_1;
  const T B2_1_3 = t2_3 + P_dot_thetadot1_2_3;
  v_y_dot[6] = B2_1_1;
  v_y_dot[10] = B2_1_3;
  v_y_dot[7] = t2_2;
  v_y_dot[11] = t2_3;

  // ---- results
  v_y_dot[1] = T(0);
  v_y_dot[2] = -T(0);
  v_y_dot[3] = T(0);
  v_y_dot[5] = T(0);
  v_y_dot[8] = -T(0);
  v_y_dot[9] = -T(0);
}

}  // namespace kanec::double_pendulum
