// SPDX-License-Identifier: BSD-3-Clause
// bench_cr64: equations of motion of 64 rigid bodies, made by kanec 0.1.0. Not to be edited by hand.
//
// model 52a887da2311ed7c of bench_cr64/scene.toml; functions kinematics energy accelerations residual
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
//   33 body_33 on 32: revolute
//   34 body_34 on 33: revolute
//   35 body_35 on 34: revolute
//   36 body_36 on 35: revolute
//   37 body_37 on 36: revolute
//   38 body_38 on 37: revolute
//   39 body_39 on 38: revolute
//   40 body_40 on 39: revolute
//   41 body_41 on 40: revolute
//   42 body_42 on 41: revolute
//   43 body_43 on 42: revolute
//   44 body_44 on 43: revolute
//   45 body_45 on 44: revolute
//   46 body_46 on 45: revolute
//   47 body_47 on 46: revolute
//   48 body_48 on 47: revolute
//   49 body_49 on 48: revolute
//   50 body_50 on 49: revolute
//   51 body_51 on 50: revolute
//   52 body_52 on 51: revolute
//   53 body_53 on 52: revolute
//   54 body_54 on 53: revolute
//   55 body_55 on 54: revolute
//   56 body_56 on 55: revolute
//   57 body_57 on 56: revolute
//   58 body_58 on 57: revolute
//   59 body_59 on 58: revolute
//   60 body_60 on 59: revolute
//   61 body_61 on 60: revolute
//   62 body_62 on 61: revolute
//   63 body_63 on 62: revolute
//   64 body_64 on 63: revolute
//
// Units SI, angles in rad. Coordinates and speeds, all rotations before all translations:
//   x = (theta_1, theta_2, theta_3, theta_4, theta_5, theta_6, theta_7, theta_8, theta_9, theta_10, theta_11,
//   theta_12, theta_13, theta_14, theta_15, theta_16, theta_17, theta_18, theta_19, theta_20, theta_21, theta_22,
//   theta_23, theta_24, theta_25, theta_26, theta_27, theta_28, theta_29, theta_30, theta_31, theta_32, theta_33,
//   theta_34, theta_35, theta_36, theta_37, theta_38, theta_39, theta_40, theta_41, theta_42, theta_43, theta_44,
//   theta_45, theta_46, theta_47, theta_48, theta_49, theta_50, theta_51, theta_52, theta_53, theta_54, theta_55,
//   theta_56, theta_57, theta_58, theta_59, theta_60, theta_61, theta_62, theta_63, theta_64)
//   y = (thetadot_1, thetadot_2, thetadot_3, thetadot_4, thetadot_5, thetadot_6, thetadot_7, thetadot_8, thetadot_9,
//   thetadot_10, thetadot_11, thetadot_12, thetadot_13, thetadot_14, thetadot_15, thetadot_16, thetadot_17,
//   thetadot_18, thetadot_19, thetadot_20, thetadot_21, thetadot_22, thetadot_23, thetadot_24, thetadot_25,
//   thetadot_26, thetadot_27, thetadot_28, thetadot_29, thetadot_30, thetadot_31, thetadot_32, thetadot_33,
//   thetadot_34, thetadot_35, thetadot_36, thetadot_37, thetadot_38, thetadot_39, thetadot_40, thetadot_41,
//   thetadot_42, thetadot_43, thetadot_44, thetadot_45, thetadot_46, thetadot_47, thetadot_48, thetadot_49,
//   thetadot_50, thetadot_51, thetadot_52, thetadot_53, thetadot_54, thetadot_55, thetadot_56, thetadot_57,
//   thetadot_58, thetadot_59, thetadot_60, thetadot_61, thetadot_62, thetadot_63, thetadot_64)
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
//   energy                  7474 (3253 add, 4221 multiply, 128 sine or cosine)
//   accelerations           19102 (9318 add, 9721 multiply, 63 divide, 128 sine or cosine)
//   residual                7825 (3878 add, 3947 multiply, 128 sine or cosine)
//
// functions written as loops over bodies; bytes in double, estimated:
//   accelerations: 191 sections of 29 kinds; 41431 of code, 33200 of stack
//     as a straight line: 173070 of code, 4248 of stack
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

namespace kanec::bench_cr64 {

inline constexpr int n_bodies = 64;
inline constexpr int nx = 64;
inline constexpr int ny = 64;
inline constexpr int n_parameters = 0;
inline constexpr int n_inputs = 64;
inline constexpr char model_hash[] = "52a887da2311ed7c";

// Where each coordinate stands in x and each speed in y.
namespace at {
inline constexpr int theta_1 = 0, theta_2 = 1, theta_3 = 2, theta_4 = 3, theta_5 = 4, theta_6 = 5, theta_7 = 6,
    theta_8 = 7, theta_9 = 8, theta_10 = 9, theta_11 = 10, theta_12 = 11, theta_13 = 12, theta_14 = 13, theta_15 = 14,
    theta_16 = 15, theta_17 = 16, theta_18 = 17, theta_19 = 18, theta_20 = 19, theta_21 = 20, theta_22 = 21,
    theta_23 = 22, theta_24 = 23, theta_25 = 24, theta_26 = 25, theta_27 = 26, theta_28 = 27, theta_29 = 28,
    theta_30 = 29, theta_31 = 30, theta_32 = 31, theta_33 = 32, theta_34 = 33, theta_35 = 34, theta_36 = 35,
    theta_37 = 36, theta_38 = 37, theta_39 = 38, theta_40 = 39, theta_41 = 40, theta_42 = 41, theta_43 = 42,
    theta_44 = 43, theta_45 = 44, theta_46 = 45, theta_47 = 46, theta_48 = 47, theta_49 = 48, theta_50 = 49,
    theta_51 = 50, theta_52 = 51, theta_53 = 52, theta_54 = 53, theta_55 = 54, theta_56 = 55, theta_57 = 56,
    theta_58 = 57, theta_59 = 58, theta_60 = 59, theta_61 = 60, theta_62 = 61, theta_63 = 62, theta_64 = 63;
inline constexpr int thetadot_1 = 0, thetadot_2 = 1, thetadot_3 = 2, thetadot_4 = 3, thetadot_5 = 4, thetadot_6 = 5,
    thetadot_7 = 6, thetadot_8 = 7, thetadot_9 = 8, thetadot_10 = 9, thetadot_11 = 10, thetadot_12 = 11,
    thetadot_13 = 12, thetadot_14 = 13, thetadot_15 = 14, thetadot_16 = 15, thetadot_17 = 16, thetadot_18 = 17,
    thetadot_19 = 18, thetadot_20 = 19, thetadot_21 = 20, thetadot_22 = 21, thetadot_23 = 22, thetadot_24 = 23,
    thetadot_25 = 24, thetadot_26 = 25, thetadot_27 = 26, thetadot_28 = 27, thetadot_29 = 28, thetadot_30 = 29,
    thetadot_31 = 30, thetadot_32 = 31, thetadot_33 = 32, thetadot_34 = 33, thetadot_35 = 34, thetadot_36 = 35,
    thetadot_37 = 36, thetadot_38 = 37, thetadot_39 = 38, thetadot_40 = 39, thetadot_41 = 40, thetadot_42 = 41,
    thetadot_43 = 42, thetadot_44 = 43, thetadot_45 = 44, thetadot_46 = 45, thetadot_47 = 46, thetadot_48 = 47,
    thetadot_49 = 48, thetadot_50 = 49, thetadot_51 = 50, thetadot_52 = 51, thetadot_53 = 52, thetadot_54 = 53,
    thetadot_55 = 54, thetadot_56 = 55, thetadot_57 = 56, thetadot_58 = 57, thetadot_59 = 58, thetadot_60 = 59,
    thetadot_61 = 60, thetadot_62 = 61, thetadot_63 = 62, thetadot_64 = 63;
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
  T tau_33 = T(0);
  T tau_34 = T(0);
  T tau_35 = T(0);
  T tau_36 = T(0);
  T tau_37 = T(0);
  T tau_38 = T(0);
  T tau_39 = T(0);
  T tau_40 = T(0);
  T tau_41 = T(0);
  T tau_42 = T(0);
  T tau_43 = T(0);
  T tau_44 = T(0);
  T tau_45 = T(0);
  T tau_46 = T(0);
  T tau_47 = T(0);
  T tau_48 = T(0);
  T tau_49 = T(0);
  T tau_50 = T(0);
  T tau_51 = T(0);
  T tau_52 = T(0);
  T tau_53 = T(0);
  T tau_54 = T(0);
  T tau_55 = T(0);
  T tau_56 = T(0);
  T tau_57 = T(0);
  T tau_58 = T(0);
  T tau_59 = T(0);
  T tau_60 = T(0);
  T tau_61 = T(0);
  T tau_62 = T(0);
  T tau_63 = T(0);
  T tau_64 = T(0);
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
  const T thetadot33 = y[32];
  const T thetadot34 = y[33];
  const T thetadot35 = y[34];
  const T thetadot36 = y[35];
  const T thetadot37 = y[36];
  const T thetadot38 = y[37];
  const T thetadot39 = y[38];
  const T thetadot40 = y[39];
  const T thetadot41 = y[40];
  const T thetadot42 = y[41];
  const T thetadot43 = y[42];
  const T thetadot44 = y[43];
  const T thetadot45 = y[44];
  const T thetadot46 = y[45];
  const T thetadot47 = y[46];
  const T thetadot48 = y[47];
  const T thetadot49 = y[48];
  const T thetadot50 = y[49];
  const T thetadot51 = y[50];
  const T thetadot52 = y[51];
  const T thetadot53 = y[52];
  const T thetadot54 = y[53];
  const T thetadot55 = y[54];
  const T thetadot56 = y[55];
  const T thetadot57 = y[56];
  const T thetadot58 = y[57];
  const T thetadot59 = y[58];
  const T thetadot60 = y[59];
  const T thetadot61 = y[60];
  const T thetadot62 = y[61];
  const T thetadot63 = y[62];
  const T thetadot64 = y[63];
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
  xdot[32] = thetadot33;
  xdot[33] = thetadot34;
  xdot[34] = thetadot35;
  xdot[35] = thetadot36;
  xdot[36] = thetadot37;
  xdot[37] = thetadot38;
  xdot[38] = thetadot39;
  xdot[39] = thetadot40;
  xdot[40] = thetadot41;
  xdot[41] = thetadot42;
  xdot[42] = thetadot43;
  xdot[43] = thetadot44;
  xdot[44] = thetadot45;
  xdot[45] = thetadot46;
  xdot[46] = thetadot47;
  xdot[47] = thetadot48;
  xdot[48] = thetadot49;
  xdot[49] = thetadot50;
  xdot[50] = thetadot51;
  xdot[51] = thetadot52;
  xdot[52] = thetadot53;
  xdot[53] = thetadot54;
  xdot[54] = thetadot55;
  xdot[55] = thetadot56;
  xdot[56] = thetadot57;
  xdot[57] = thetadot58;
  xdot[58] = thetadot59;
  xdot[59] = thetadot60;
  xdot[60] = thetadot61;
  xdot[61] = thetadot62;
  xdot[62] = thetadot63;
  xdot[63] = thetadot64;
}

// energy: kinetic and potential energy [J].
// kinetic, potential (2) [J]
// 3253 add, 4221 multiply, 128 sine or cosine
template <class T>
void energy([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, T* energy) noexcept {
  T cosines[64], sines[64];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 64, cosines, sines);

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
  const T t32_1 = R31_33 * T(0.1);
  const T P32_3 = t32_1 + P31_3 + R31_13 * T(0.3) + R30_23 * T(1.6);
  // p32 = R32^T r32 + P32: position of the mass centre, inertial axes [m]
  const T t32_2 = R32_13 * T(0.1);
  const T p32_3 = t32_2 + t31_1 + P32_3 + R32_23 * T(0.2);
  // Pdot32 = R31^T omega31~ q32 + Pdot31: velocity of the body origin, inertial axes [m/s]
  const T t32_3 = t31_7 - omega31_3 * T(1.6);
  const T t32_4 = omega31_3 * T(0.3) - omega31_1 * T(0.1);
  const T t32_5 = omega31_1 * T(1.6) - omega31_2 * T(0.3);
  const T Pdot32_1 = Pdot31_1 + R31_11 * t32_3 + R30_21 * t32_4 + R31_31 * t32_5;
  const T Pdot32_2 = Pdot31_2 + R31_12 * t32_3 + R30_22 * t32_4 + R31_32 * t32_5;
  const T Pdot32_3 = Pdot31_3 + R31_13 * t32_3 + R30_23 * t32_4 + R31_33 * t32_5;
  // v32 = R32^T omega32~ r32 + Pdot32: velocity of the mass centre, inertial axes [m/s]
  const T t32_6 = omega32_2 * T(0.05) - omega32_3 * T(0.2);
  const T t32_7 = omega32_3 * T(0.1) - omega32_1 * T(0.05);
  const T t32_8 = omega32_2 * T(0.1);
  const T t32_9 = omega32_1 * T(0.2) - t32_8;
  const T v32_1 = Pdot32_1 + R32_11 * t32_6 + R32_21 * t32_7 + R31_31 * t32_9;
  const T v32_2 = Pdot32_2 + R32_12 * t32_6 + R32_22 * t32_7 + R31_32 * t32_9;
  const T v32_3 = Pdot32_3 + R32_13 * t32_6 + R32_23 * t32_7 + R31_33 * t32_9;
  // T32 = 1/2 omega32 . (I32 omega32) + 1/2 m32 v32 . v32: kinetic energy [J]
  const T T32 = T(0.5) * (omega32_1 * (T(0.42) * omega32_1 + T(0.021) * omega32_2 + T(0.0126) * omega32_3) + omega32_2
      * (T(0.021) * omega32_1 + T(0.504) * omega32_2 - T(0.0168) * omega32_3) + omega32_3 * (T(0.0126) * omega32_1 -
      T(0.0168) * omega32_2 + T(0.336) * omega32_3)) + T(2.1) * (v32_1 * v32_1 + v32_2 * v32_2 + v32_3 * v32_3);

  // ---- body 33 (body_33) on body 32
  const T thetadot33 = y[32];
  // E33^T = Rot(b33, theta33): E takes components in the lower body to those in the body
  const T E33_22 = cosines[32];
  const T E33_23 = sines[32];
  // R33^T = R32^T E33^T: R takes inertial components to body components
  const T R33_21 = R32_21 * E33_22 + R31_31 * E33_23;
  const T R33_22 = R32_22 * E33_22 + R31_32 * E33_23;
  const T R33_23 = R32_23 * E33_22 + R31_33 * E33_23;
  const T R33_31 = R31_31 * E33_22 - R32_21 * E33_23;
  const T R33_32 = R31_32 * E33_22 - R32_22 * E33_23;
  const T R33_33 = R31_33 * E33_22 - R32_23 * E33_23;
  // omega33 = thetadot33 b33 + E33 omega32: absolute angular velocity, body axes [rad/s]
  const T omega33_1 = thetadot33 + omega32_1;
  const T omega33_2 = E33_22 * omega32_2 + E33_23 * omega32_3;
  const T omega33_3 = E33_22 * omega32_3 - E33_23 * omega32_2;
  // P33 = R32^T q33 + P32: position of the body origin, inertial axes [m]
  const T t33_1 = R32_13 * T(0.3);
  const T P33_3 = t33_1 + t32_1 + P32_3 + R32_23 * T(1.65);
  // p33 = R33^T r33 + P33: position of the mass centre, inertial axes [m]
  const T t33_2 = R33_23 * T(0.2);
  const T p33_3 = t32_2 + t33_2 + P33_3 + R33_33 * T(0.05);
  // Pdot33 = R32^T omega32~ q33 + Pdot32: velocity of the body origin, inertial axes [m/s]
  const T t33_3 = t32_8 - omega32_3 * T(1.65);
  const T t33_4 = omega32_3 * T(0.3) - omega32_1 * T(0.1);
  const T t33_5 = omega32_1 * T(1.65) - omega32_2 * T(0.3);
  const T Pdot33_1 = Pdot32_1 + R32_11 * t33_3 + R32_21 * t33_4 + R31_31 * t33_5;
  const T Pdot33_2 = Pdot32_2 + R32_12 * t33_3 + R32_22 * t33_4 + R31_32 * t33_5;
  const T Pdot33_3 = Pdot32_3 + R32_13 * t33_3 + R32_23 * t33_4 + R31_33 * t33_5;
  // v33 = R33^T omega33~ r33 + Pdot33: velocity of the mass centre, inertial axes [m/s]
  const T t33_6 = omega33_2 * T(0.05) - omega33_3 * T(0.2);
  const T t33_7 = omega33_3 * T(0.1) - omega33_1 * T(0.05);
  const T t33_8 = omega33_2 * T(0.1);
  const T t33_9 = omega33_1 * T(0.2) - t33_8;
  const T v33_1 = Pdot33_1 + R32_11 * t33_6 + R33_21 * t33_7 + R33_31 * t33_9;
  const T v33_2 = Pdot33_2 + R32_12 * t33_6 + R33_22 * t33_7 + R33_32 * t33_9;
  const T v33_3 = Pdot33_3 + R32_13 * t33_6 + R33_23 * t33_7 + R33_33 * t33_9;
  // T33 = 1/2 omega33 . (I33 omega33) + 1/2 m33 v33 . v33: kinetic energy [J]
  const T T33 = T(0.5) * (omega33_1 * (T(0.43) * omega33_1 + T(0.0215) * omega33_2 + T(0.0129) * omega33_3) +
      omega33_2 * (T(0.0215) * omega33_1 + T(0.516) * omega33_2 - T(0.0172) * omega33_3) + omega33_3 * (T(0.0129) *
      omega33_1 - T(0.0172) * omega33_2 + T(0.344) * omega33_3)) + T(2.15) * (v33_1 * v33_1 + v33_2 * v33_2 + v33_3 *
      v33_3);

  // ---- body 34 (body_34) on body 33
  const T thetadot34 = y[33];
  // E34^T = Rot(b34, theta34): E takes components in the lower body to those in the body
  const T E34_11 = cosines[33];
  const T minus_E34_13 = sines[33];
  // R34^T = R33^T E34^T: R takes inertial components to body components
  const T R34_11 = R32_11 * E34_11 - R33_31 * minus_E34_13;
  const T R34_12 = R32_12 * E34_11 - R33_32 * minus_E34_13;
  const T R34_13 = R32_13 * E34_11 - R33_33 * minus_E34_13;
  const T R34_31 = R32_11 * minus_E34_13 + R33_31 * E34_11;
  const T R34_32 = R32_12 * minus_E34_13 + R33_32 * E34_11;
  const T R34_33 = R32_13 * minus_E34_13 + R33_33 * E34_11;
  // omega34 = thetadot34 b34 + E34 omega33: absolute angular velocity, body axes [rad/s]
  const T omega34_1 = E34_11 * omega33_1 - minus_E34_13 * omega33_3;
  const T omega34_2 = thetadot34 + omega33_2;
  const T omega34_3 = minus_E34_13 * omega33_1 + E34_11 * omega33_3;
  // P34 = R33^T q34 + P33: position of the body origin, inertial axes [m]
  const T P34_3 = t33_1 + P33_3 + R33_23 * T(1.7) + R33_33 * T(0.1);
  // p34 = R34^T r34 + P34: position of the mass centre, inertial axes [m]
  const T t34_1 = R34_33 * T(0.05);
  const T p34_3 = t33_2 + t34_1 + P34_3 + R34_13 * T(0.1);
  // Pdot34 = R33^T omega33~ q34 + Pdot33: velocity of the body origin, inertial axes [m/s]
  const T t34_2 = t33_8 - omega33_3 * T(1.7);
  const T t34_3 = omega33_3 * T(0.3) - omega33_1 * T(0.1);
  const T t34_4 = omega33_1 * T(1.7) - omega33_2 * T(0.3);
  const T Pdot34_1 = Pdot33_1 + R32_11 * t34_2 + R33_21 * t34_3 + R33_31 * t34_4;
  const T Pdot34_2 = Pdot33_2 + R32_12 * t34_2 + R33_22 * t34_3 + R33_32 * t34_4;
  const T Pdot34_3 = Pdot33_3 + R32_13 * t34_2 + R33_23 * t34_3 + R33_33 * t34_4;
  // v34 = R34^T omega34~ r34 + Pdot34: velocity of the mass centre, inertial axes [m/s]
  const T t34_5 = omega34_2 * T(0.05) - omega34_3 * T(0.2);
  const T t34_6 = omega34_3 * T(0.1) - omega34_1 * T(0.05);
  const T t34_7 = omega34_2 * T(0.1);
  const T t34_8 = omega34_1 * T(0.2) - t34_7;
  const T v34_1 = Pdot34_1 + R34_11 * t34_5 + R33_21 * t34_6 + R34_31 * t34_8;
  const T v34_2 = Pdot34_2 + R34_12 * t34_5 + R33_22 * t34_6 + R34_32 * t34_8;
  const T v34_3 = Pdot34_3 + R34_13 * t34_5 + R33_23 * t34_6 + R34_33 * t34_8;
  // T34 = 1/2 omega34 . (I34 omega34) + 1/2 m34 v34 . v34: kinetic energy [J]
  const T T34 = T(0.5) * (omega34_1 * (T(0.44) * omega34_1 + T(0.022) * omega34_2 + T(0.0132) * omega34_3) + omega34_2
      * (T(0.022) * omega34_1 + T(0.528) * omega34_2 - T(0.0176) * omega34_3) + omega34_3 * (T(0.0132) * omega34_1 -
      T(0.0176) * omega34_2 + T(0.352) * omega34_3)) + T(2.2) * (v34_1 * v34_1 + v34_2 * v34_2 + v34_3 * v34_3);

  // ---- body 35 (body_35) on body 34
  const T thetadot35 = y[34];
  // E35^T = Rot(b35, theta35): E takes components in the lower body to those in the body
  const T E35_11 = cosines[34];
  const T E35_12 = sines[34];
  // R35^T = R34^T E35^T: R takes inertial components to body components
  const T R35_11 = R34_11 * E35_11 + R33_21 * E35_12;
  const T R35_12 = R34_12 * E35_11 + R33_22 * E35_12;
  const T R35_13 = R34_13 * E35_11 + R33_23 * E35_12;
  const T R35_21 = R33_21 * E35_11 - R34_11 * E35_12;
  const T R35_22 = R33_22 * E35_11 - R34_12 * E35_12;
  const T R35_23 = R33_23 * E35_11 - R34_13 * E35_12;
  // omega35 = thetadot35 b35 + E35 omega34: absolute angular velocity, body axes [rad/s]
  const T omega35_1 = E35_11 * omega34_1 + E35_12 * omega34_2;
  const T omega35_2 = E35_11 * omega34_2 - E35_12 * omega34_1;
  const T omega35_3 = thetadot35 + omega34_3;
  // P35 = R34^T q35 + P34: position of the body origin, inertial axes [m]
  const T t35_1 = R34_33 * T(0.1);
  const T P35_3 = t35_1 + P34_3 + R34_13 * T(0.3) + R33_23 * T(1.75);
  // p35 = R35^T r35 + P35: position of the mass centre, inertial axes [m]
  const T t35_2 = R35_13 * T(0.1);
  const T p35_3 = t35_2 + t34_1 + P35_3 + R35_23 * T(0.2);
  // Pdot35 = R34^T omega34~ q35 + Pdot34: velocity of the body origin, inertial axes [m/s]
  const T t35_3 = t34_7 - omega34_3 * T(1.75);
  const T t35_4 = omega34_3 * T(0.3) - omega34_1 * T(0.1);
  const T t35_5 = omega34_1 * T(1.75) - omega34_2 * T(0.3);
  const T Pdot35_1 = Pdot34_1 + R34_11 * t35_3 + R33_21 * t35_4 + R34_31 * t35_5;
  const T Pdot35_2 = Pdot34_2 + R34_12 * t35_3 + R33_22 * t35_4 + R34_32 * t35_5;
  const T Pdot35_3 = Pdot34_3 + R34_13 * t35_3 + R33_23 * t35_4 + R34_33 * t35_5;
  // v35 = R35^T omega35~ r35 + Pdot35: velocity of the mass centre, inertial axes [m/s]
  const T t35_6 = omega35_2 * T(0.05) - omega35_3 * T(0.2);
  const T t35_7 = omega35_3 * T(0.1) - omega35_1 * T(0.05);
  const T t35_8 = omega35_2 * T(0.1);
  const T t35_9 = omega35_1 * T(0.2) - t35_8;
  const T v35_1 = Pdot35_1 + R35_11 * t35_6 + R35_21 * t35_7 + R34_31 * t35_9;
  const T v35_2 = Pdot35_2 + R35_12 * t35_6 + R35_22 * t35_7 + R34_32 * t35_9;
  const T v35_3 = Pdot35_3 + R35_13 * t35_6 + R35_23 * t35_7 + R34_33 * t35_9;
  // T35 = 1/2 omega35 . (I35 omega35) + 1/2 m35 v35 . v35: kinetic energy [J]
  const T T35 = T(0.5) * (omega35_1 * (T(0.45) * omega35_1 + T(0.0225) * omega35_2 + T(0.0135) * omega35_3) +
      omega35_2 * (T(0.0225) * omega35_1 + T(0.54) * omega35_2 - T(0.018) * omega35_3) + omega35_3 * (T(0.0135) *
      omega35_1 - T(0.018) * omega35_2 + T(0.36) * omega35_3)) + T(2.25) * (v35_1 * v35_1 + v35_2 * v35_2 + v35_3 *
      v35_3);

  // ---- body 36 (body_36) on body 35
  const T thetadot36 = y[35];
  // E36^T = Rot(b36, theta36): E takes components in the lower body to those in the body
  const T E36_22 = cosines[35];
  const T E36_23 = sines[35];
  // R36^T = R35^T E36^T: R takes inertial components to body components
  const T R36_21 = R35_21 * E36_22 + R34_31 * E36_23;
  const T R36_22 = R35_22 * E36_22 + R34_32 * E36_23;
  const T R36_23 = R35_23 * E36_22 + R34_33 * E36_23;
  const T R36_31 = R34_31 * E36_22 - R35_21 * E36_23;
  const T R36_32 = R34_32 * E36_22 - R35_22 * E36_23;
  const T R36_33 = R34_33 * E36_22 - R35_23 * E36_23;
  // omega36 = thetadot36 b36 + E36 omega35: absolute angular velocity, body axes [rad/s]
  const T omega36_1 = thetadot36 + omega35_1;
  const T omega36_2 = E36_22 * omega35_2 + E36_23 * omega35_3;
  const T omega36_3 = E36_22 * omega35_3 - E36_23 * omega35_2;
  // P36 = R35^T q36 + P35: position of the body origin, inertial axes [m]
  const T t36_1 = R35_13 * T(0.3);
  const T P36_3 = t36_1 + t35_1 + P35_3 + R35_23 * T(1.8);
  // p36 = R36^T r36 + P36: position of the mass centre, inertial axes [m]
  const T t36_2 = R36_23 * T(0.2);
  const T p36_3 = t35_2 + t36_2 + P36_3 + R36_33 * T(0.05);
  // Pdot36 = R35^T omega35~ q36 + Pdot35: velocity of the body origin, inertial axes [m/s]
  const T t36_3 = t35_8 - omega35_3 * T(1.8);
  const T t36_4 = omega35_3 * T(0.3) - omega35_1 * T(0.1);
  const T t36_5 = omega35_1 * T(1.8) - omega35_2 * T(0.3);
  const T Pdot36_1 = Pdot35_1 + R35_11 * t36_3 + R35_21 * t36_4 + R34_31 * t36_5;
  const T Pdot36_2 = Pdot35_2 + R35_12 * t36_3 + R35_22 * t36_4 + R34_32 * t36_5;
  const T Pdot36_3 = Pdot35_3 + R35_13 * t36_3 + R35_23 * t36_4 + R34_33 * t36_5;
  // v36 = R36^T omega36~ r36 + Pdot36: velocity of the mass centre, inertial axes [m/s]
  const T t36_6 = omega36_2 * T(0.05) - omega36_3 * T(0.2);
  const T t36_7 = omega36_3 * T(0.1) - omega36_1 * T(0.05);
  const T t36_8 = omega36_2 * T(0.1);
  const T t36_9 = omega36_1 * T(0.2) - t36_8;
  const T v36_1 = Pdot36_1 + R35_11 * t36_6 + R36_21 * t36_7 + R36_31 * t36_9;
  const T v36_2 = Pdot36_2 + R35_12 * t36_6 + R36_22 * t36_7 + R36_32 * t36_9;
  const T v36_3 = Pdot36_3 + R35_13 * t36_6 + R36_23 * t36_7 + R36_33 * t36_9;
  // T36 = 1/2 omega36 . (I36 omega36) + 1/2 m36 v36 . v36: kinetic energy [J]
  const T T36 = T(0.5) * (omega36_1 * (T(0.46) * omega36_1 + T(0.023) * omega36_2 + T(0.0138) * omega36_3) + omega36_2
      * (T(0.023) * omega36_1 + T(0.552) * omega36_2 - T(0.0184) * omega36_3) + omega36_3 * (T(0.0138) * omega36_1 -
      T(0.0184) * omega36_2 + T(0.368) * omega36_3)) + T(2.3) * (v36_1 * v36_1 + v36_2 * v36_2 + v36_3 * v36_3);

  // ---- body 37 (body_37) on body 36
  const T thetadot37 = y[36];
  // E37^T = Rot(b37, theta37): E takes components in the lower body to those in the body
  const T E37_11 = cosines[36];
  const T minus_E37_13 = sines[36];
  // R37^T = R36^T E37^T: R takes inertial components to body components
  const T R37_11 = R35_11 * E37_11 - R36_31 * minus_E37_13;
  const T R37_12 = R35_12 * E37_11 - R36_32 * minus_E37_13;
  const T R37_13 = R35_13 * E37_11 - R36_33 * minus_E37_13;
  const T R37_31 = R35_11 * minus_E37_13 + R36_31 * E37_11;
  const T R37_32 = R35_12 * minus_E37_13 + R36_32 * E37_11;
  const T R37_33 = R35_13 * minus_E37_13 + R36_33 * E37_11;
  // omega37 = thetadot37 b37 + E37 omega36: absolute angular velocity, body axes [rad/s]
  const T omega37_1 = E37_11 * omega36_1 - minus_E37_13 * omega36_3;
  const T omega37_2 = thetadot37 + omega36_2;
  const T omega37_3 = minus_E37_13 * omega36_1 + E37_11 * omega36_3;
  // P37 = R36^T q37 + P36: position of the body origin, inertial axes [m]
  const T P37_3 = t36_1 + P36_3 + R36_23 * T(1.85) + R36_33 * T(0.1);
  // p37 = R37^T r37 + P37: position of the mass centre, inertial axes [m]
  const T t37_1 = R37_33 * T(0.05);
  const T p37_3 = t36_2 + t37_1 + P37_3 + R37_13 * T(0.1);
  // Pdot37 = R36^T omega36~ q37 + Pdot36: velocity of the body origin, inertial axes [m/s]
  const T t37_2 = t36_8 - omega36_3 * T(1.85);
  const T t37_3 = omega36_3 * T(0.3) - omega36_1 * T(0.1);
  const T t37_4 = omega36_1 * T(1.85) - omega36_2 * T(0.3);
  const T Pdot37_1 = Pdot36_1 + R35_11 * t37_2 + R36_21 * t37_3 + R36_31 * t37_4;
  const T Pdot37_2 = Pdot36_2 + R35_12 * t37_2 + R36_22 * t37_3 + R36_32 * t37_4;
  const T Pdot37_3 = Pdot36_3 + R35_13 * t37_2 + R36_23 * t37_3 + R36_33 * t37_4;
  // v37 = R37^T omega37~ r37 + Pdot37: velocity of the mass centre, inertial axes [m/s]
  const T t37_5 = omega37_2 * T(0.05) - omega37_3 * T(0.2);
  const T t37_6 = omega37_3 * T(0.1) - omega37_1 * T(0.05);
  const T t37_7 = omega37_2 * T(0.1);
  const T t37_8 = omega37_1 * T(0.2) - t37_7;
  const T v37_1 = Pdot37_1 + R37_11 * t37_5 + R36_21 * t37_6 + R37_31 * t37_8;
  const T v37_2 = Pdot37_2 + R37_12 * t37_5 + R36_22 * t37_6 + R37_32 * t37_8;
  const T v37_3 = Pdot37_3 + R37_13 * t37_5 + R36_23 * t37_6 + R37_33 * t37_8;
  // T37 = 1/2 omega37 . (I37 omega37) + 1/2 m37 v37 . v37: kinetic energy [J]
  const T T37 = T(0.5) * (omega37_1 * (T(0.47) * omega37_1 + T(0.0235) * omega37_2 + T(0.0141) * omega37_3) +
      omega37_2 * (T(0.0235) * omega37_1 + T(0.564) * omega37_2 - T(0.0188) * omega37_3) + omega37_3 * (T(0.0141) *
      omega37_1 - T(0.0188) * omega37_2 + T(0.376) * omega37_3)) + T(2.35) * (v37_1 * v37_1 + v37_2 * v37_2 + v37_3 *
      v37_3);

  // ---- body 38 (body_38) on body 37
  const T thetadot38 = y[37];
  // E38^T = Rot(b38, theta38): E takes components in the lower body to those in the body
  const T E38_11 = cosines[37];
  const T E38_12 = sines[37];
  // R38^T = R37^T E38^T: R takes inertial components to body components
  const T R38_11 = R37_11 * E38_11 + R36_21 * E38_12;
  const T R38_12 = R37_12 * E38_11 + R36_22 * E38_12;
  const T R38_13 = R37_13 * E38_11 + R36_23 * E38_12;
  const T R38_21 = R36_21 * E38_11 - R37_11 * E38_12;
  const T R38_22 = R36_22 * E38_11 - R37_12 * E38_12;
  const T R38_23 = R36_23 * E38_11 - R37_13 * E38_12;
  // omega38 = thetadot38 b38 + E38 omega37: absolute angular velocity, body axes [rad/s]
  const T omega38_1 = E38_11 * omega37_1 + E38_12 * omega37_2;
  const T omega38_2 = E38_11 * omega37_2 - E38_12 * omega37_1;
  const T omega38_3 = thetadot38 + omega37_3;
  // P38 = R37^T q38 + P37: position of the body origin, inertial axes [m]
  const T t38_1 = R37_33 * T(0.1);
  const T P38_3 = t38_1 + P37_3 + R37_13 * T(0.3) + R36_23 * T(1.9);
  // p38 = R38^T r38 + P38: position of the mass centre, inertial axes [m]
  const T t38_2 = R38_13 * T(0.1);
  const T p38_3 = t38_2 + t37_1 + P38_3 + R38_23 * T(0.2);
  // Pdot38 = R37^T omega37~ q38 + Pdot37: velocity of the body origin, inertial axes [m/s]
  const T t38_3 = t37_7 - omega37_3 * T(1.9);
  const T t38_4 = omega37_3 * T(0.3) - omega37_1 * T(0.1);
  const T t38_5 = omega37_1 * T(1.9) - omega37_2 * T(0.3);
  const T Pdot38_1 = Pdot37_1 + R37_11 * t38_3 + R36_21 * t38_4 + R37_31 * t38_5;
  const T Pdot38_2 = Pdot37_2 + R37_12 * t38_3 + R36_22 * t38_4 + R37_32 * t38_5;
  const T Pdot38_3 = Pdot37_3 + R37_13 * t38_3 + R36_23 * t38_4 + R37_33 * t38_5;
  // v38 = R38^T omega38~ r38 + Pdot38: velocity of the mass centre, inertial axes [m/s]
  const T t38_6 = omega38_2 * T(0.05) - omega38_3 * T(0.2);
  const T t38_7 = omega38_3 * T(0.1) - omega38_1 * T(0.05);
  const T t38_8 = omega38_2 * T(0.1);
  const T t38_9 = omega38_1 * T(0.2) - t38_8;
  const T v38_1 = Pdot38_1 + R38_11 * t38_6 + R38_21 * t38_7 + R37_31 * t38_9;
  const T v38_2 = Pdot38_2 + R38_12 * t38_6 + R38_22 * t38_7 + R37_32 * t38_9;
  const T v38_3 = Pdot38_3 + R38_13 * t38_6 + R38_23 * t38_7 + R37_33 * t38_9;
  // T38 = 1/2 omega38 . (I38 omega38) + 1/2 m38 v38 . v38: kinetic energy [J]
  const T T38 = T(0.5) * (omega38_1 * (T(0.48) * omega38_1 + T(0.024) * omega38_2 + T(0.0144) * omega38_3) + omega38_2
      * (T(0.024) * omega38_1 + T(0.576) * omega38_2 - T(0.0192) * omega38_3) + omega38_3 * (T(0.0144) * omega38_1 -
      T(0.0192) * omega38_2 + T(0.384) * omega38_3)) + T(2.4) * (v38_1 * v38_1 + v38_2 * v38_2 + v38_3 * v38_3);

  // ---- body 39 (body_39) on body 38
  const T thetadot39 = y[38];
  // E39^T = Rot(b39, theta39): E takes components in the lower body to those in the body
  const T E39_22 = cosines[38];
  const T E39_23 = sines[38];
  // R39^T = R38^T E39^T: R takes inertial components to body components
  const T R39_21 = R38_21 * E39_22 + R37_31 * E39_23;
  const T R39_22 = R38_22 * E39_22 + R37_32 * E39_23;
  const T R39_23 = R38_23 * E39_22 + R37_33 * E39_23;
  const T R39_31 = R37_31 * E39_22 - R38_21 * E39_23;
  const T R39_32 = R37_32 * E39_22 - R38_22 * E39_23;
  const T R39_33 = R37_33 * E39_22 - R38_23 * E39_23;
  // omega39 = thetadot39 b39 + E39 omega38: absolute angular velocity, body axes [rad/s]
  const T omega39_1 = thetadot39 + omega38_1;
  const T omega39_2 = E39_22 * omega38_2 + E39_23 * omega38_3;
  const T omega39_3 = E39_22 * omega38_3 - E39_23 * omega38_2;
  // P39 = R38^T q39 + P38: position of the body origin, inertial axes [m]
  const T t39_1 = R38_13 * T(0.3);
  const T P39_3 = t39_1 + t38_1 + P38_3 + R38_23 * T(1.95);
  // p39 = R39^T r39 + P39: position of the mass centre, inertial axes [m]
  const T t39_2 = R39_23 * T(0.2);
  const T p39_3 = t38_2 + t39_2 + P39_3 + R39_33 * T(0.05);
  // Pdot39 = R38^T omega38~ q39 + Pdot38: velocity of the body origin, inertial axes [m/s]
  const T t39_3 = t38_8 - omega38_3 * T(1.95);
  const T t39_4 = omega38_3 * T(0.3) - omega38_1 * T(0.1);
  const T t39_5 = omega38_1 * T(1.95) - omega38_2 * T(0.3);
  const T Pdot39_1 = Pdot38_1 + R38_11 * t39_3 + R38_21 * t39_4 + R37_31 * t39_5;
  const T Pdot39_2 = Pdot38_2 + R38_12 * t39_3 + R38_22 * t39_4 + R37_32 * t39_5;
  const T Pdot39_3 = Pdot38_3 + R38_13 * t39_3 + R38_23 * t39_4 + R37_33 * t39_5;
  // v39 = R39^T omega39~ r39 + Pdot39: velocity of the mass centre, inertial axes [m/s]
  const T t39_6 = omega39_2 * T(0.05) - omega39_3 * T(0.2);
  const T t39_7 = omega39_3 * T(0.1) - omega39_1 * T(0.05);
  const T t39_8 = omega39_2 * T(0.1);
  const T t39_9 = omega39_1 * T(0.2) - t39_8;
  const T v39_1 = Pdot39_1 + R38_11 * t39_6 + R39_21 * t39_7 + R39_31 * t39_9;
  const T v39_2 = Pdot39_2 + R38_12 * t39_6 + R39_22 * t39_7 + R39_32 * t39_9;
  const T v39_3 = Pdot39_3 + R38_13 * t39_6 + R39_23 * t39_7 + R39_33 * t39_9;
  // T39 = 1/2 omega39 . (I39 omega39) + 1/2 m39 v39 . v39: kinetic energy [J]
  const T T39 = T(0.5) * (omega39_1 * (T(0.49) * omega39_1 + T(0.0245) * omega39_2 + T(0.0147) * omega39_3) +
      omega39_2 * (T(0.0245) * omega39_1 + T(0.588) * omega39_2 - T(0.0196) * omega39_3) + omega39_3 * (T(0.0147) *
      omega39_1 - T(0.0196) * omega39_2 + T(0.392) * omega39_3)) + T(2.45) * (v39_1 * v39_1 + v39_2 * v39_2 + v39_3 *
      v39_3);

  // ---- body 40 (body_40) on body 39
  const T thetadot40 = y[39];
  // E40^T = Rot(b40, theta40): E takes components in the lower body to those in the body
  const T E40_11 = cosines[39];
  const T minus_E40_13 = sines[39];
  // R40^T = R39^T E40^T: R takes inertial components to body components
  const T R40_11 = R38_11 * E40_11 - R39_31 * minus_E40_13;
  const T R40_12 = R38_12 * E40_11 - R39_32 * minus_E40_13;
  const T R40_13 = R38_13 * E40_11 - R39_33 * minus_E40_13;
  const T R40_31 = R38_11 * minus_E40_13 + R39_31 * E40_11;
  const T R40_32 = R38_12 * minus_E40_13 + R39_32 * E40_11;
  const T R40_33 = R38_13 * minus_E40_13 + R39_33 * E40_11;
  // omega40 = thetadot40 b40 + E40 omega39: absolute angular velocity, body axes [rad/s]
  const T omega40_1 = E40_11 * omega39_1 - minus_E40_13 * omega39_3;
  const T omega40_2 = thetadot40 + omega39_2;
  const T omega40_3 = minus_E40_13 * omega39_1 + E40_11 * omega39_3;
  // P40 = R39^T q40 + P39: position of the body origin, inertial axes [m]
  const T P40_3 = t39_1 + P39_3 + R39_23 * T(2) + R39_33 * T(0.1);
  // p40 = R40^T r40 + P40: position of the mass centre, inertial axes [m]
  const T t40_1 = R40_33 * T(0.05);
  const T p40_3 = t39_2 + t40_1 + P40_3 + R40_13 * T(0.1);
  // Pdot40 = R39^T omega39~ q40 + Pdot39: velocity of the body origin, inertial axes [m/s]
  const T t40_2 = t39_8 - omega39_3 * T(2);
  const T t40_3 = omega39_3 * T(0.3) - omega39_1 * T(0.1);
  const T t40_4 = omega39_1 * T(2) - omega39_2 * T(0.3);
  const T Pdot40_1 = Pdot39_1 + R38_11 * t40_2 + R39_21 * t40_3 + R39_31 * t40_4;
  const T Pdot40_2 = Pdot39_2 + R38_12 * t40_2 + R39_22 * t40_3 + R39_32 * t40_4;
  const T Pdot40_3 = Pdot39_3 + R38_13 * t40_2 + R39_23 * t40_3 + R39_33 * t40_4;
  // v40 = R40^T omega40~ r40 + Pdot40: velocity of the mass centre, inertial axes [m/s]
  const T t40_5 = omega40_2 * T(0.05) - omega40_3 * T(0.2);
  const T t40_6 = omega40_3 * T(0.1) - omega40_1 * T(0.05);
  const T t40_7 = omega40_2 * T(0.1);
  const T t40_8 = omega40_1 * T(0.2) - t40_7;
  const T v40_1 = Pdot40_1 + R40_11 * t40_5 + R39_21 * t40_6 + R40_31 * t40_8;
  const T v40_2 = Pdot40_2 + R40_12 * t40_5 + R39_22 * t40_6 + R40_32 * t40_8;
  const T v40_3 = Pdot40_3 + R40_13 * t40_5 + R39_23 * t40_6 + R40_33 * t40_8;
  // T40 = 1/2 omega40 . (I40 omega40) + 1/2 m40 v40 . v40: kinetic energy [J]
  const T T40 = T(0.5) * (omega40_1 * (T(0.5) * omega40_1 + T(0.025) * omega40_2 + T(0.015) * omega40_3) + omega40_2 *
      (T(0.025) * omega40_1 + T(0.6) * omega40_2 - T(0.02) * omega40_3) + omega40_3 * (T(0.015) * omega40_1 - T(0.02)
      * omega40_2 + T(0.4) * omega40_3)) + T(2.5) * (v40_1 * v40_1 + v40_2 * v40_2 + v40_3 * v40_3);

  // ---- body 41 (body_41) on body 40
  const T thetadot41 = y[40];
  // E41^T = Rot(b41, theta41): E takes components in the lower body to those in the body
  const T E41_11 = cosines[40];
  const T E41_12 = sines[40];
  // R41^T = R40^T E41^T: R takes inertial components to body components
  const T R41_11 = R40_11 * E41_11 + R39_21 * E41_12;
  const T R41_12 = R40_12 * E41_11 + R39_22 * E41_12;
  const T R41_13 = R40_13 * E41_11 + R39_23 * E41_12;
  const T R41_21 = R39_21 * E41_11 - R40_11 * E41_12;
  const T R41_22 = R39_22 * E41_11 - R40_12 * E41_12;
  const T R41_23 = R39_23 * E41_11 - R40_13 * E41_12;
  // omega41 = thetadot41 b41 + E41 omega40: absolute angular velocity, body axes [rad/s]
  const T omega41_1 = E41_11 * omega40_1 + E41_12 * omega40_2;
  const T omega41_2 = E41_11 * omega40_2 - E41_12 * omega40_1;
  const T omega41_3 = thetadot41 + omega40_3;
  // P41 = R40^T q41 + P40: position of the body origin, inertial axes [m]
  const T t41_1 = R40_33 * T(0.1);
  const T P41_3 = t41_1 + P40_3 + R40_13 * T(0.3) + R39_23 * T(2.05);
  // p41 = R41^T r41 + P41: position of the mass centre, inertial axes [m]
  const T t41_2 = R41_13 * T(0.1);
  const T p41_3 = t41_2 + t40_1 + P41_3 + R41_23 * T(0.2);
  // Pdot41 = R40^T omega40~ q41 + Pdot40: velocity of the body origin, inertial axes [m/s]
  const T t41_3 = t40_7 - omega40_3 * T(2.05);
  const T t41_4 = omega40_3 * T(0.3) - omega40_1 * T(0.1);
  const T t41_5 = omega40_1 * T(2.05) - omega40_2 * T(0.3);
  const T Pdot41_1 = Pdot40_1 + R40_11 * t41_3 + R39_21 * t41_4 + R40_31 * t41_5;
  const T Pdot41_2 = Pdot40_2 + R40_12 * t41_3 + R39_22 * t41_4 + R40_32 * t41_5;
  const T Pdot41_3 = Pdot40_3 + R40_13 * t41_3 + R39_23 * t41_4 + R40_33 * t41_5;
  // v41 = R41^T omega41~ r41 + Pdot41: velocity of the mass centre, inertial axes [m/s]
  const T t41_6 = omega41_2 * T(0.05) - omega41_3 * T(0.2);
  const T t41_7 = omega41_3 * T(0.1) - omega41_1 * T(0.05);
  const T t41_8 = omega41_2 * T(0.1);
  const T t41_9 = omega41_1 * T(0.2) - t41_8;
  const T v41_1 = Pdot41_1 + R41_11 * t41_6 + R41_21 * t41_7 + R40_31 * t41_9;
  const T v41_2 = Pdot41_2 + R41_12 * t41_6 + R41_22 * t41_7 + R40_32 * t41_9;
  const T v41_3 = Pdot41_3 + R41_13 * t41_6 + R41_23 * t41_7 + R40_33 * t41_9;
  // T41 = 1/2 omega41 . (I41 omega41) + 1/2 m41 v41 . v41: kinetic energy [J]
  const T T41 = T(0.5) * (omega41_1 * (T(0.51) * omega41_1 + T(0.0255) * omega41_2 + T(0.0153) * omega41_3) +
      omega41_2 * (T(0.0255) * omega41_1 + T(0.612) * omega41_2 - T(0.0204) * omega41_3) + omega41_3 * (T(0.0153) *
      omega41_1 - T(0.0204) * omega41_2 + T(0.408) * omega41_3)) + T(2.55) * (v41_1 * v41_1 + v41_2 * v41_2 + v41_3 *
      v41_3);

  // ---- body 42 (body_42) on body 41
  const T thetadot42 = y[41];
  // E42^T = Rot(b42, theta42): E takes components in the lower body to those in the body
  const T E42_22 = cosines[41];
  const T E42_23 = sines[41];
  // R42^T = R41^T E42^T: R takes inertial components to body components
  const T R42_21 = R41_21 * E42_22 + R40_31 * E42_23;
  const T R42_22 = R41_22 * E42_22 + R40_32 * E42_23;
  const T R42_23 = R41_23 * E42_22 + R40_33 * E42_23;
  const T R42_31 = R40_31 * E42_22 - R41_21 * E42_23;
  const T R42_32 = R40_32 * E42_22 - R41_22 * E42_23;
  const T R42_33 = R40_33 * E42_22 - R41_23 * E42_23;
  // omega42 = thetadot42 b42 + E42 omega41: absolute angular velocity, body axes [rad/s]
  const T omega42_1 = thetadot42 + omega41_1;
  const T omega42_2 = E42_22 * omega41_2 + E42_23 * omega41_3;
  const T omega42_3 = E42_22 * omega41_3 - E42_23 * omega41_2;
  // P42 = R41^T q42 + P41: position of the body origin, inertial axes [m]
  const T t42_1 = R41_13 * T(0.3);
  const T P42_3 = t42_1 + t41_1 + P41_3 + R41_23 * T(2.1);
  // p42 = R42^T r42 + P42: position of the mass centre, inertial axes [m]
  const T t42_2 = R42_23 * T(0.2);
  const T p42_3 = t41_2 + t42_2 + P42_3 + R42_33 * T(0.05);
  // Pdot42 = R41^T omega41~ q42 + Pdot41: velocity of the body origin, inertial axes [m/s]
  const T t42_3 = t41_8 - omega41_3 * T(2.1);
  const T t42_4 = omega41_3 * T(0.3) - omega41_1 * T(0.1);
  const T t42_5 = omega41_1 * T(2.1) - omega41_2 * T(0.3);
  const T Pdot42_1 = Pdot41_1 + R41_11 * t42_3 + R41_21 * t42_4 + R40_31 * t42_5;
  const T Pdot42_2 = Pdot41_2 + R41_12 * t42_3 + R41_22 * t42_4 + R40_32 * t42_5;
  const T Pdot42_3 = Pdot41_3 + R41_13 * t42_3 + R41_23 * t42_4 + R40_33 * t42_5;
  // v42 = R42^T omega42~ r42 + Pdot42: velocity of the mass centre, inertial axes [m/s]
  const T t42_6 = omega42_2 * T(0.05) - omega42_3 * T(0.2);
  const T t42_7 = omega42_3 * T(0.1) - omega42_1 * T(0.05);
  const T t42_8 = omega42_2 * T(0.1);
  const T t42_9 = omega42_1 * T(0.2) - t42_8;
  const T v42_1 = Pdot42_1 + R41_11 * t42_6 + R42_21 * t42_7 + R42_31 * t42_9;
  const T v42_2 = Pdot42_2 + R41_12 * t42_6 + R42_22 * t42_7 + R42_32 * t42_9;
  const T v42_3 = Pdot42_3 + R41_13 * t42_6 + R42_23 * t42_7 + R42_33 * t42_9;
  // T42 = 1/2 omega42 . (I42 omega42) + 1/2 m42 v42 . v42: kinetic energy [J]
  const T T42 = T(0.5) * (omega42_1 * (T(0.52) * omega42_1 + T(0.026) * omega42_2 + T(0.0156) * omega42_3) + omega42_2
      * (T(0.026) * omega42_1 + T(0.624) * omega42_2 - T(0.0208) * omega42_3) + omega42_3 * (T(0.0156) * omega42_1 -
      T(0.0208) * omega42_2 + T(0.416) * omega42_3)) + T(2.6) * (v42_1 * v42_1 + v42_2 * v42_2 + v42_3 * v42_3);

  // ---- body 43 (body_43) on body 42
  const T thetadot43 = y[42];
  // E43^T = Rot(b43, theta43): E takes components in the lower body to those in the body
  const T E43_11 = cosines[42];
  const T minus_E43_13 = sines[42];
  // R43^T = R42^T E43^T: R takes inertial components to body components
  const T R43_11 = R41_11 * E43_11 - R42_31 * minus_E43_13;
  const T R43_12 = R41_12 * E43_11 - R42_32 * minus_E43_13;
  const T R43_13 = R41_13 * E43_11 - R42_33 * minus_E43_13;
  const T R43_31 = R41_11 * minus_E43_13 + R42_31 * E43_11;
  const T R43_32 = R41_12 * minus_E43_13 + R42_32 * E43_11;
  const T R43_33 = R41_13 * minus_E43_13 + R42_33 * E43_11;
  // omega43 = thetadot43 b43 + E43 omega42: absolute angular velocity, body axes [rad/s]
  const T omega43_1 = E43_11 * omega42_1 - minus_E43_13 * omega42_3;
  const T omega43_2 = thetadot43 + omega42_2;
  const T omega43_3 = minus_E43_13 * omega42_1 + E43_11 * omega42_3;
  // P43 = R42^T q43 + P42: position of the body origin, inertial axes [m]
  const T P43_3 = t42_1 + P42_3 + R42_23 * T(2.15) + R42_33 * T(0.1);
  // p43 = R43^T r43 + P43: position of the mass centre, inertial axes [m]
  const T t43_1 = R43_33 * T(0.05);
  const T p43_3 = t42_2 + t43_1 + P43_3 + R43_13 * T(0.1);
  // Pdot43 = R42^T omega42~ q43 + Pdot42: velocity of the body origin, inertial axes [m/s]
  const T t43_2 = t42_8 - omega42_3 * T(2.15);
  const T t43_3 = omega42_3 * T(0.3) - omega42_1 * T(0.1);
  const T t43_4 = omega42_1 * T(2.15) - omega42_2 * T(0.3);
  const T Pdot43_1 = Pdot42_1 + R41_11 * t43_2 + R42_21 * t43_3 + R42_31 * t43_4;
  const T Pdot43_2 = Pdot42_2 + R41_12 * t43_2 + R42_22 * t43_3 + R42_32 * t43_4;
  const T Pdot43_3 = Pdot42_3 + R41_13 * t43_2 + R42_23 * t43_3 + R42_33 * t43_4;
  // v43 = R43^T omega43~ r43 + Pdot43: velocity of the mass centre, inertial axes [m/s]
  const T t43_5 = omega43_2 * T(0.05) - omega43_3 * T(0.2);
  const T t43_6 = omega43_3 * T(0.1) - omega43_1 * T(0.05);
  const T t43_7 = omega43_2 * T(0.1);
  const T t43_8 = omega43_1 * T(0.2) - t43_7;
  const T v43_1 = Pdot43_1 + R43_11 * t43_5 + R42_21 * t43_6 + R43_31 * t43_8;
  const T v43_2 = Pdot43_2 + R43_12 * t43_5 + R42_22 * t43_6 + R43_32 * t43_8;
  const T v43_3 = Pdot43_3 + R43_13 * t43_5 + R42_23 * t43_6 + R43_33 * t43_8;
  // T43 = 1/2 omega43 . (I43 omega43) + 1/2 m43 v43 . v43: kinetic energy [J]
  const T T43 = T(0.5) * (omega43_1 * (T(0.53) * omega43_1 + T(0.0265) * omega43_2 + T(0.0159) * omega43_3) +
      omega43_2 * (T(0.0265) * omega43_1 + T(0.636) * omega43_2 - T(0.0212) * omega43_3) + omega43_3 * (T(0.0159) *
      omega43_1 - T(0.0212) * omega43_2 + T(0.424) * omega43_3)) + T(2.65) * (v43_1 * v43_1 + v43_2 * v43_2 + v43_3 *
      v43_3);

  // ---- body 44 (body_44) on body 43
  const T thetadot44 = y[43];
  // E44^T = Rot(b44, theta44): E takes components in the lower body to those in the body
  const T E44_11 = cosines[43];
  const T E44_12 = sines[43];
  // R44^T = R43^T E44^T: R takes inertial components to body components
  const T R44_11 = R43_11 * E44_11 + R42_21 * E44_12;
  const T R44_12 = R43_12 * E44_11 + R42_22 * E44_12;
  const T R44_13 = R43_13 * E44_11 + R42_23 * E44_12;
  const T R44_21 = R42_21 * E44_11 - R43_11 * E44_12;
  const T R44_22 = R42_22 * E44_11 - R43_12 * E44_12;
  const T R44_23 = R42_23 * E44_11 - R43_13 * E44_12;
  // omega44 = thetadot44 b44 + E44 omega43: absolute angular velocity, body axes [rad/s]
  const T omega44_1 = E44_11 * omega43_1 + E44_12 * omega43_2;
  const T omega44_2 = E44_11 * omega43_2 - E44_12 * omega43_1;
  const T omega44_3 = thetadot44 + omega43_3;
  // P44 = R43^T q44 + P43: position of the body origin, inertial axes [m]
  const T t44_1 = R43_33 * T(0.1);
  const T P44_3 = t44_1 + P43_3 + R43_13 * T(0.3) + R42_23 * T(2.2);
  // p44 = R44^T r44 + P44: position of the mass centre, inertial axes [m]
  const T t44_2 = R44_13 * T(0.1);
  const T p44_3 = t44_2 + t43_1 + P44_3 + R44_23 * T(0.2);
  // Pdot44 = R43^T omega43~ q44 + Pdot43: velocity of the body origin, inertial axes [m/s]
  const T t44_3 = t43_7 - omega43_3 * T(2.2);
  const T t44_4 = omega43_3 * T(0.3) - omega43_1 * T(0.1);
  const T t44_5 = omega43_1 * T(2.2) - omega43_2 * T(0.3);
  const T Pdot44_1 = Pdot43_1 + R43_11 * t44_3 + R42_21 * t44_4 + R43_31 * t44_5;
  const T Pdot44_2 = Pdot43_2 + R43_12 * t44_3 + R42_22 * t44_4 + R43_32 * t44_5;
  const T Pdot44_3 = Pdot43_3 + R43_13 * t44_3 + R42_23 * t44_4 + R43_33 * t44_5;
  // v44 = R44^T omega44~ r44 + Pdot44: velocity of the mass centre, inertial axes [m/s]
  const T t44_6 = omega44_2 * T(0.05) - omega44_3 * T(0.2);
  const T t44_7 = omega44_3 * T(0.1) - omega44_1 * T(0.05);
  const T t44_8 = omega44_2 * T(0.1);
  const T t44_9 = omega44_1 * T(0.2) - t44_8;
  const T v44_1 = Pdot44_1 + R44_11 * t44_6 + R44_21 * t44_7 + R43_31 * t44_9;
  const T v44_2 = Pdot44_2 + R44_12 * t44_6 + R44_22 * t44_7 + R43_32 * t44_9;
  const T v44_3 = Pdot44_3 + R44_13 * t44_6 + R44_23 * t44_7 + R43_33 * t44_9;
  // T44 = 1/2 omega44 . (I44 omega44) + 1/2 m44 v44 . v44: kinetic energy [J]
  const T T44 = T(0.5) * (omega44_1 * (T(0.54) * omega44_1 + T(0.027) * omega44_2 + T(0.0162) * omega44_3) + omega44_2
      * (T(0.027) * omega44_1 + T(0.648) * omega44_2 - T(0.0216) * omega44_3) + omega44_3 * (T(0.0162) * omega44_1 -
      T(0.0216) * omega44_2 + T(0.432) * omega44_3)) + T(2.7) * (v44_1 * v44_1 + v44_2 * v44_2 + v44_3 * v44_3);

  // ---- body 45 (body_45) on body 44
  const T thetadot45 = y[44];
  // E45^T = Rot(b45, theta45): E takes components in the lower body to those in the body
  const T E45_22 = cosines[44];
  const T E45_23 = sines[44];
  // R45^T = R44^T E45^T: R takes inertial components to body components
  const T R45_21 = R44_21 * E45_22 + R43_31 * E45_23;
  const T R45_22 = R44_22 * E45_22 + R43_32 * E45_23;
  const T R45_23 = R44_23 * E45_22 + R43_33 * E45_23;
  const T R45_31 = R43_31 * E45_22 - R44_21 * E45_23;
  const T R45_32 = R43_32 * E45_22 - R44_22 * E45_23;
  const T R45_33 = R43_33 * E45_22 - R44_23 * E45_23;
  // omega45 = thetadot45 b45 + E45 omega44: absolute angular velocity, body axes [rad/s]
  const T omega45_1 = thetadot45 + omega44_1;
  const T omega45_2 = E45_22 * omega44_2 + E45_23 * omega44_3;
  const T omega45_3 = E45_22 * omega44_3 - E45_23 * omega44_2;
  // P45 = R44^T q45 + P44: position of the body origin, inertial axes [m]
  const T t45_1 = R44_13 * T(0.3);
  const T P45_3 = t45_1 + t44_1 + P44_3 + R44_23 * T(2.25);
  // p45 = R45^T r45 + P45: position of the mass centre, inertial axes [m]
  const T t45_2 = R45_23 * T(0.2);
  const T p45_3 = t44_2 + t45_2 + P45_3 + R45_33 * T(0.05);
  // Pdot45 = R44^T omega44~ q45 + Pdot44: velocity of the body origin, inertial axes [m/s]
  const T t45_3 = t44_8 - omega44_3 * T(2.25);
  const T t45_4 = omega44_3 * T(0.3) - omega44_1 * T(0.1);
  const T t45_5 = omega44_1 * T(2.25) - omega44_2 * T(0.3);
  const T Pdot45_1 = Pdot44_1 + R44_11 * t45_3 + R44_21 * t45_4 + R43_31 * t45_5;
  const T Pdot45_2 = Pdot44_2 + R44_12 * t45_3 + R44_22 * t45_4 + R43_32 * t45_5;
  const T Pdot45_3 = Pdot44_3 + R44_13 * t45_3 + R44_23 * t45_4 + R43_33 * t45_5;
  // v45 = R45^T omega45~ r45 + Pdot45: velocity of the mass centre, inertial axes [m/s]
  const T t45_6 = omega45_2 * T(0.05) - omega45_3 * T(0.2);
  const T t45_7 = omega45_3 * T(0.1) - omega45_1 * T(0.05);
  const T t45_8 = omega45_2 * T(0.1);
  const T t45_9 = omega45_1 * T(0.2) - t45_8;
  const T v45_1 = Pdot45_1 + R44_11 * t45_6 + R45_21 * t45_7 + R45_31 * t45_9;
  const T v45_2 = Pdot45_2 + R44_12 * t45_6 + R45_22 * t45_7 + R45_32 * t45_9;
  const T v45_3 = Pdot45_3 + R44_13 * t45_6 + R45_23 * t45_7 + R45_33 * t45_9;
  // T45 = 1/2 omega45 . (I45 omega45) + 1/2 m45 v45 . v45: kinetic energy [J]
  const T T45 = T(0.5) * (omega45_1 * (T(0.55) * omega45_1 + T(0.0275) * omega45_2 + T(0.0165) * omega45_3) +
      omega45_2 * (T(0.0275) * omega45_1 + T(0.66) * omega45_2 - T(0.022) * omega45_3) + omega45_3 * (T(0.0165) *
      omega45_1 - T(0.022) * omega45_2 + T(0.44) * omega45_3)) + T(2.75) * (v45_1 * v45_1 + v45_2 * v45_2 + v45_3 *
      v45_3);

  // ---- body 46 (body_46) on body 45
  const T thetadot46 = y[45];
  // E46^T = Rot(b46, theta46): E takes components in the lower body to those in the body
  const T E46_11 = cosines[45];
  const T minus_E46_13 = sines[45];
  // R46^T = R45^T E46^T: R takes inertial components to body components
  const T R46_11 = R44_11 * E46_11 - R45_31 * minus_E46_13;
  const T R46_12 = R44_12 * E46_11 - R45_32 * minus_E46_13;
  const T R46_13 = R44_13 * E46_11 - R45_33 * minus_E46_13;
  const T R46_31 = R44_11 * minus_E46_13 + R45_31 * E46_11;
  const T R46_32 = R44_12 * minus_E46_13 + R45_32 * E46_11;
  const T R46_33 = R44_13 * minus_E46_13 + R45_33 * E46_11;
  // omega46 = thetadot46 b46 + E46 omega45: absolute angular velocity, body axes [rad/s]
  const T omega46_1 = E46_11 * omega45_1 - minus_E46_13 * omega45_3;
  const T omega46_2 = thetadot46 + omega45_2;
  const T omega46_3 = minus_E46_13 * omega45_1 + E46_11 * omega45_3;
  // P46 = R45^T q46 + P45: position of the body origin, inertial axes [m]
  const T P46_3 = t45_1 + P45_3 + R45_23 * T(2.3) + R45_33 * T(0.1);
  // p46 = R46^T r46 + P46: position of the mass centre, inertial axes [m]
  const T t46_1 = R46_33 * T(0.05);
  const T p46_3 = t45_2 + t46_1 + P46_3 + R46_13 * T(0.1);
  // Pdot46 = R45^T omega45~ q46 + Pdot45: velocity of the body origin, inertial axes [m/s]
  const T t46_2 = t45_8 - omega45_3 * T(2.3);
  const T t46_3 = omega45_3 * T(0.3) - omega45_1 * T(0.1);
  const T t46_4 = omega45_1 * T(2.3) - omega45_2 * T(0.3);
  const T Pdot46_1 = Pdot45_1 + R44_11 * t46_2 + R45_21 * t46_3 + R45_31 * t46_4;
  const T Pdot46_2 = Pdot45_2 + R44_12 * t46_2 + R45_22 * t46_3 + R45_32 * t46_4;
  const T Pdot46_3 = Pdot45_3 + R44_13 * t46_2 + R45_23 * t46_3 + R45_33 * t46_4;
  // v46 = R46^T omega46~ r46 + Pdot46: velocity of the mass centre, inertial axes [m/s]
  const T t46_5 = omega46_2 * T(0.05) - omega46_3 * T(0.2);
  const T t46_6 = omega46_3 * T(0.1) - omega46_1 * T(0.05);
  const T t46_7 = omega46_2 * T(0.1);
  const T t46_8 = omega46_1 * T(0.2) - t46_7;
  const T v46_1 = Pdot46_1 + R46_11 * t46_5 + R45_21 * t46_6 + R46_31 * t46_8;
  const T v46_2 = Pdot46_2 + R46_12 * t46_5 + R45_22 * t46_6 + R46_32 * t46_8;
  const T v46_3 = Pdot46_3 + R46_13 * t46_5 + R45_23 * t46_6 + R46_33 * t46_8;
  // T46 = 1/2 omega46 . (I46 omega46) + 1/2 m46 v46 . v46: kinetic energy [J]
  const T T46 = T(0.5) * (omega46_1 * (T(0.56) * omega46_1 + T(0.028) * omega46_2 + T(0.0168) * omega46_3) + omega46_2
      * (T(0.028) * omega46_1 + T(0.672) * omega46_2 - T(0.0224) * omega46_3) + omega46_3 * (T(0.0168) * omega46_1 -
      T(0.0224) * omega46_2 + T(0.448) * omega46_3)) + T(2.8) * (v46_1 * v46_1 + v46_2 * v46_2 + v46_3 * v46_3);

  // ---- body 47 (body_47) on body 46
  const T thetadot47 = y[46];
  // E47^T = Rot(b47, theta47): E takes components in the lower body to those in the body
  const T E47_11 = cosines[46];
  const T E47_12 = sines[46];
  // R47^T = R46^T E47^T: R takes inertial components to body components
  const T R47_11 = R46_11 * E47_11 + R45_21 * E47_12;
  const T R47_12 = R46_12 * E47_11 + R45_22 * E47_12;
  const T R47_13 = R46_13 * E47_11 + R45_23 * E47_12;
  const T R47_21 = R45_21 * E47_11 - R46_11 * E47_12;
  const T R47_22 = R45_22 * E47_11 - R46_12 * E47_12;
  const T R47_23 = R45_23 * E47_11 - R46_13 * E47_12;
  // omega47 = thetadot47 b47 + E47 omega46: absolute angular velocity, body axes [rad/s]
  const T omega47_1 = E47_11 * omega46_1 + E47_12 * omega46_2;
  const T omega47_2 = E47_11 * omega46_2 - E47_12 * omega46_1;
  const T omega47_3 = thetadot47 + omega46_3;
  // P47 = R46^T q47 + P46: position of the body origin, inertial axes [m]
  const T t47_1 = R46_33 * T(0.1);
  const T P47_3 = t47_1 + P46_3 + R46_13 * T(0.3) + R45_23 * T(2.35);
  // p47 = R47^T r47 + P47: position of the mass centre, inertial axes [m]
  const T t47_2 = R47_13 * T(0.1);
  const T p47_3 = t47_2 + t46_1 + P47_3 + R47_23 * T(0.2);
  // Pdot47 = R46^T omega46~ q47 + Pdot46: velocity of the body origin, inertial axes [m/s]
  const T t47_3 = t46_7 - omega46_3 * T(2.35);
  const T t47_4 = omega46_3 * T(0.3) - omega46_1 * T(0.1);
  const T t47_5 = omega46_1 * T(2.35) - omega46_2 * T(0.3);
  const T Pdot47_1 = Pdot46_1 + R46_11 * t47_3 + R45_21 * t47_4 + R46_31 * t47_5;
  const T Pdot47_2 = Pdot46_2 + R46_12 * t47_3 + R45_22 * t47_4 + R46_32 * t47_5;
  const T Pdot47_3 = Pdot46_3 + R46_13 * t47_3 + R45_23 * t47_4 + R46_33 * t47_5;
  // v47 = R47^T omega47~ r47 + Pdot47: velocity of the mass centre, inertial axes [m/s]
  const T t47_6 = omega47_2 * T(0.05) - omega47_3 * T(0.2);
  const T t47_7 = omega47_3 * T(0.1) - omega47_1 * T(0.05);
  const T t47_8 = omega47_2 * T(0.1);
  const T t47_9 = omega47_1 * T(0.2) - t47_8;
  const T v47_1 = Pdot47_1 + R47_11 * t47_6 + R47_21 * t47_7 + R46_31 * t47_9;
  const T v47_2 = Pdot47_2 + R47_12 * t47_6 + R47_22 * t47_7 + R46_32 * t47_9;
  const T v47_3 = Pdot47_3 + R47_13 * t47_6 + R47_23 * t47_7 + R46_33 * t47_9;
  // T47 = 1/2 omega47 . (I47 omega47) + 1/2 m47 v47 . v47: kinetic energy [J]
  const T T47 = T(0.5) * (omega47_1 * (T(0.57) * omega47_1 + T(0.0285) * omega47_2 + T(0.0171) * omega47_3) +
      omega47_2 * (T(0.0285) * omega47_1 + T(0.684) * omega47_2 - T(0.0228) * omega47_3) + omega47_3 * (T(0.0171) *
      omega47_1 - T(0.0228) * omega47_2 + T(0.456) * omega47_3)) + T(2.85) * (v47_1 * v47_1 + v47_2 * v47_2 + v47_3 *
      v47_3);

  // ---- body 48 (body_48) on body 47
  const T thetadot48 = y[47];
  // E48^T = Rot(b48, theta48): E takes components in the lower body to those in the body
  const T E48_22 = cosines[47];
  const T E48_23 = sines[47];
  // R48^T = R47^T E48^T: R takes inertial components to body components
  const T R48_21 = R47_21 * E48_22 + R46_31 * E48_23;
  const T R48_22 = R47_22 * E48_22 + R46_32 * E48_23;
  const T R48_23 = R47_23 * E48_22 + R46_33 * E48_23;
  const T R48_31 = R46_31 * E48_22 - R47_21 * E48_23;
  const T R48_32 = R46_32 * E48_22 - R47_22 * E48_23;
  const T R48_33 = R46_33 * E48_22 - R47_23 * E48_23;
  // omega48 = thetadot48 b48 + E48 omega47: absolute angular velocity, body axes [rad/s]
  const T omega48_1 = thetadot48 + omega47_1;
  const T omega48_2 = E48_22 * omega47_2 + E48_23 * omega47_3;
  const T omega48_3 = E48_22 * omega47_3 - E48_23 * omega47_2;
  // P48 = R47^T q48 + P47: position of the body origin, inertial axes [m]
  const T t48_1 = R47_13 * T(0.3);
  const T P48_3 = t48_1 + t47_1 + P47_3 + R47_23 * T(2.4);
  // p48 = R48^T r48 + P48: position of the mass centre, inertial axes [m]
  const T t48_2 = R48_23 * T(0.2);
  const T p48_3 = t47_2 + t48_2 + P48_3 + R48_33 * T(0.05);
  // Pdot48 = R47^T omega47~ q48 + Pdot47: velocity of the body origin, inertial axes [m/s]
  const T t48_3 = t47_8 - omega47_3 * T(2.4);
  const T t48_4 = omega47_3 * T(0.3) - omega47_1 * T(0.1);
  const T t48_5 = omega47_1 * T(2.4) - omega47_2 * T(0.3);
  const T Pdot48_1 = Pdot47_1 + R47_11 * t48_3 + R47_21 * t48_4 + R46_31 * t48_5;
  const T Pdot48_2 = Pdot47_2 + R47_12 * t48_3 + R47_22 * t48_4 + R46_32 * t48_5;
  const T Pdot48_3 = Pdot47_3 + R47_13 * t48_3 + R47_23 * t48_4 + R46_33 * t48_5;
  // v48 = R48^T omega48~ r48 + Pdot48: velocity of the mass centre, inertial axes [m/s]
  const T t48_6 = omega48_2 * T(0.05) - omega48_3 * T(0.2);
  const T t48_7 = omega48_3 * T(0.1) - omega48_1 * T(0.05);
  const T t48_8 = omega48_2 * T(0.1);
  const T t48_9 = omega48_1 * T(0.2) - t48_8;
  const T v48_1 = Pdot48_1 + R47_11 * t48_6 + R48_21 * t48_7 + R48_31 * t48_9;
  const T v48_2 = Pdot48_2 + R47_12 * t48_6 + R48_22 * t48_7 + R48_32 * t48_9;
  const T v48_3 = Pdot48_3 + R47_13 * t48_6 + R48_23 * t48_7 + R48_33 * t48_9;
  // T48 = 1/2 omega48 . (I48 omega48) + 1/2 m48 v48 . v48: kinetic energy [J]
  const T T48 = T(0.5) * (omega48_1 * (T(0.58) * omega48_1 + T(0.029) * omega48_2 + T(0.0174) * omega48_3) + omega48_2
      * (T(0.029) * omega48_1 + T(0.696) * omega48_2 - T(0.0232) * omega48_3) + omega48_3 * (T(0.0174) * omega48_1 -
      T(0.0232) * omega48_2 + T(0.464) * omega48_3)) + T(2.9) * (v48_1 * v48_1 + v48_2 * v48_2 + v48_3 * v48_3);

  // ---- body 49 (body_49) on body 48
  const T thetadot49 = y[48];
  // E49^T = Rot(b49, theta49): E takes components in the lower body to those in the body
  const T E49_11 = cosines[48];
  const T minus_E49_13 = sines[48];
  // R49^T = R48^T E49^T: R takes inertial components to body components
  const T R49_11 = R47_11 * E49_11 - R48_31 * minus_E49_13;
  const T R49_12 = R47_12 * E49_11 - R48_32 * minus_E49_13;
  const T R49_13 = R47_13 * E49_11 - R48_33 * minus_E49_13;
  const T R49_31 = R47_11 * minus_E49_13 + R48_31 * E49_11;
  const T R49_32 = R47_12 * minus_E49_13 + R48_32 * E49_11;
  const T R49_33 = R47_13 * minus_E49_13 + R48_33 * E49_11;
  // omega49 = thetadot49 b49 + E49 omega48: absolute angular velocity, body axes [rad/s]
  const T omega49_1 = E49_11 * omega48_1 - minus_E49_13 * omega48_3;
  const T omega49_2 = thetadot49 + omega48_2;
  const T omega49_3 = minus_E49_13 * omega48_1 + E49_11 * omega48_3;
  // P49 = R48^T q49 + P48: position of the body origin, inertial axes [m]
  const T P49_3 = t48_1 + P48_3 + R48_23 * T(2.45) + R48_33 * T(0.1);
  // p49 = R49^T r49 + P49: position of the mass centre, inertial axes [m]
  const T t49_1 = R49_33 * T(0.05);
  const T p49_3 = t48_2 + t49_1 + P49_3 + R49_13 * T(0.1);
  // Pdot49 = R48^T omega48~ q49 + Pdot48: velocity of the body origin, inertial axes [m/s]
  const T t49_2 = t48_8 - omega48_3 * T(2.45);
  const T t49_3 = omega48_3 * T(0.3) - omega48_1 * T(0.1);
  const T t49_4 = omega48_1 * T(2.45) - omega48_2 * T(0.3);
  const T Pdot49_1 = Pdot48_1 + R47_11 * t49_2 + R48_21 * t49_3 + R48_31 * t49_4;
  const T Pdot49_2 = Pdot48_2 + R47_12 * t49_2 + R48_22 * t49_3 + R48_32 * t49_4;
  const T Pdot49_3 = Pdot48_3 + R47_13 * t49_2 + R48_23 * t49_3 + R48_33 * t49_4;
  // v49 = R49^T omega49~ r49 + Pdot49: velocity of the mass centre, inertial axes [m/s]
  const T t49_5 = omega49_2 * T(0.05) - omega49_3 * T(0.2);
  const T t49_6 = omega49_3 * T(0.1) - omega49_1 * T(0.05);
  const T t49_7 = omega49_2 * T(0.1);
  const T t49_8 = omega49_1 * T(0.2) - t49_7;
  const T v49_1 = Pdot49_1 + R49_11 * t49_5 + R48_21 * t49_6 + R49_31 * t49_8;
  const T v49_2 = Pdot49_2 + R49_12 * t49_5 + R48_22 * t49_6 + R49_32 * t49_8;
  const T v49_3 = Pdot49_3 + R49_13 * t49_5 + R48_23 * t49_6 + R49_33 * t49_8;
  // T49 = 1/2 omega49 . (I49 omega49) + 1/2 m49 v49 . v49: kinetic energy [J]
  const T T49 = T(0.5) * (omega49_1 * (T(0.59) * omega49_1 + T(0.0295) * omega49_2 + T(0.0177) * omega49_3) +
      omega49_2 * (T(0.0295) * omega49_1 + T(0.708) * omega49_2 - T(0.0236) * omega49_3) + omega49_3 * (T(0.0177) *
      omega49_1 - T(0.0236) * omega49_2 + T(0.472) * omega49_3)) + T(2.95) * (v49_1 * v49_1 + v49_2 * v49_2 + v49_3 *
      v49_3);

  // ---- body 50 (body_50) on body 49
  const T thetadot50 = y[49];
  // E50^T = Rot(b50, theta50): E takes components in the lower body to those in the body
  const T E50_11 = cosines[49];
  const T E50_12 = sines[49];
  // R50^T = R49^T E50^T: R takes inertial components to body components
  const T R50_11 = R49_11 * E50_11 + R48_21 * E50_12;
  const T R50_12 = R49_12 * E50_11 + R48_22 * E50_12;
  const T R50_13 = R49_13 * E50_11 + R48_23 * E50_12;
  const T R50_21 = R48_21 * E50_11 - R49_11 * E50_12;
  const T R50_22 = R48_22 * E50_11 - R49_12 * E50_12;
  const T R50_23 = R48_23 * E50_11 - R49_13 * E50_12;
  // omega50 = thetadot50 b50 + E50 omega49: absolute angular velocity, body axes [rad/s]
  const T omega50_1 = E50_11 * omega49_1 + E50_12 * omega49_2;
  const T omega50_2 = E50_11 * omega49_2 - E50_12 * omega49_1;
  const T omega50_3 = thetadot50 + omega49_3;
  // P50 = R49^T q50 + P49: position of the body origin, inertial axes [m]
  const T t50_1 = R49_33 * T(0.1);
  const T P50_3 = t50_1 + P49_3 + R49_13 * T(0.3) + R48_23 * T(2.5);
  // p50 = R50^T r50 + P50: position of the mass centre, inertial axes [m]
  const T t50_2 = R50_13 * T(0.1);
  const T p50_3 = t50_2 + t49_1 + P50_3 + R50_23 * T(0.2);
  // Pdot50 = R49^T omega49~ q50 + Pdot49: velocity of the body origin, inertial axes [m/s]
  const T t50_3 = t49_7 - omega49_3 * T(2.5);
  const T t50_4 = omega49_3 * T(0.3) - omega49_1 * T(0.1);
  const T t50_5 = omega49_1 * T(2.5) - omega49_2 * T(0.3);
  const T Pdot50_1 = Pdot49_1 + R49_11 * t50_3 + R48_21 * t50_4 + R49_31 * t50_5;
  const T Pdot50_2 = Pdot49_2 + R49_12 * t50_3 + R48_22 * t50_4 + R49_32 * t50_5;
  const T Pdot50_3 = Pdot49_3 + R49_13 * t50_3 + R48_23 * t50_4 + R49_33 * t50_5;
  // v50 = R50^T omega50~ r50 + Pdot50: velocity of the mass centre, inertial axes [m/s]
  const T t50_6 = omega50_2 * T(0.05) - omega50_3 * T(0.2);
  const T t50_7 = omega50_3 * T(0.1) - omega50_1 * T(0.05);
  const T t50_8 = omega50_2 * T(0.1);
  const T t50_9 = omega50_1 * T(0.2) - t50_8;
  const T v50_1 = Pdot50_1 + R50_11 * t50_6 + R50_21 * t50_7 + R49_31 * t50_9;
  const T v50_2 = Pdot50_2 + R50_12 * t50_6 + R50_22 * t50_7 + R49_32 * t50_9;
  const T v50_3 = Pdot50_3 + R50_13 * t50_6 + R50_23 * t50_7 + R49_33 * t50_9;
  // T50 = 1/2 omega50 . (I50 omega50) + 1/2 m50 v50 . v50: kinetic energy [J]
  const T T50 = T(0.5) * (omega50_1 * (T(0.6) * omega50_1 + T(0.03) * omega50_2 + T(0.018) * omega50_3) + omega50_2 *
      (T(0.03) * omega50_1 + T(0.72) * omega50_2 - T(0.024) * omega50_3) + omega50_3 * (T(0.018) * omega50_1 -
      T(0.024) * omega50_2 + T(0.48) * omega50_3)) + T(3) * (v50_1 * v50_1 + v50_2 * v50_2 + v50_3 * v50_3);

  // ---- body 51 (body_51) on body 50
  const T thetadot51 = y[50];
  // E51^T = Rot(b51, theta51): E takes components in the lower body to those in the body
  const T E51_22 = cosines[50];
  const T E51_23 = sines[50];
  // R51^T = R50^T E51^T: R takes inertial components to body components
  const T R51_21 = R50_21 * E51_22 + R49_31 * E51_23;
  const T R51_22 = R50_22 * E51_22 + R49_32 * E51_23;
  const T R51_23 = R50_23 * E51_22 + R49_33 * E51_23;
  const T R51_31 = R49_31 * E51_22 - R50_21 * E51_23;
  const T R51_32 = R49_32 * E51_22 - R50_22 * E51_23;
  const T R51_33 = R49_33 * E51_22 - R50_23 * E51_23;
  // omega51 = thetadot51 b51 + E51 omega50: absolute angular velocity, body axes [rad/s]
  const T omega51_1 = thetadot51 + omega50_1;
  const T omega51_2 = E51_22 * omega50_2 + E51_23 * omega50_3;
  const T omega51_3 = E51_22 * omega50_3 - E51_23 * omega50_2;
  // P51 = R50^T q51 + P50: position of the body origin, inertial axes [m]
  const T t51_1 = R50_13 * T(0.3);
  const T P51_3 = t51_1 + t50_1 + P50_3 + R50_23 * T(2.55);
  // p51 = R51^T r51 + P51: position of the mass centre, inertial axes [m]
  const T t51_2 = R51_23 * T(0.2);
  const T p51_3 = t50_2 + t51_2 + P51_3 + R51_33 * T(0.05);
  // Pdot51 = R50^T omega50~ q51 + Pdot50: velocity of the body origin, inertial axes [m/s]
  const T t51_3 = t50_8 - omega50_3 * T(2.55);
  const T t51_4 = omega50_3 * T(0.3) - omega50_1 * T(0.1);
  const T t51_5 = omega50_1 * T(2.55) - omega50_2 * T(0.3);
  const T Pdot51_1 = Pdot50_1 + R50_11 * t51_3 + R50_21 * t51_4 + R49_31 * t51_5;
  const T Pdot51_2 = Pdot50_2 + R50_12 * t51_3 + R50_22 * t51_4 + R49_32 * t51_5;
  const T Pdot51_3 = Pdot50_3 + R50_13 * t51_3 + R50_23 * t51_4 + R49_33 * t51_5;
  // v51 = R51^T omega51~ r51 + Pdot51: velocity of the mass centre, inertial axes [m/s]
  const T t51_6 = omega51_2 * T(0.05) - omega51_3 * T(0.2);
  const T t51_7 = omega51_3 * T(0.1) - omega51_1 * T(0.05);
  const T t51_8 = omega51_2 * T(0.1);
  const T t51_9 = omega51_1 * T(0.2) - t51_8;
  const T v51_1 = Pdot51_1 + R50_11 * t51_6 + R51_21 * t51_7 + R51_31 * t51_9;
  const T v51_2 = Pdot51_2 + R50_12 * t51_6 + R51_22 * t51_7 + R51_32 * t51_9;
  const T v51_3 = Pdot51_3 + R50_13 * t51_6 + R51_23 * t51_7 + R51_33 * t51_9;
  // T51 = 1/2 omega51 . (I51 omega51) + 1/2 m51 v51 . v51: kinetic energy [J]
  const T T51 = T(0.5) * (omega51_1 * (T(0.61) * omega51_1 + T(0.0305) * omega51_2 + T(0.0183) * omega51_3) +
      omega51_2 * (T(0.0305) * omega51_1 + T(0.732) * omega51_2 - T(0.0244) * omega51_3) + omega51_3 * (T(0.0183) *
      omega51_1 - T(0.0244) * omega51_2 + T(0.488) * omega51_3)) + T(3.05) * (v51_1 * v51_1 + v51_2 * v51_2 + v51_3 *
      v51_3);

  // ---- body 52 (body_52) on body 51
  const T thetadot52 = y[51];
  // E52^T = Rot(b52, theta52): E takes components in the lower body to those in the body
  const T E52_11 = cosines[51];
  const T minus_E52_13 = sines[51];
  // R52^T = R51^T E52^T: R takes inertial components to body components
  const T R52_11 = R50_11 * E52_11 - R51_31 * minus_E52_13;
  const T R52_12 = R50_12 * E52_11 - R51_32 * minus_E52_13;
  const T R52_13 = R50_13 * E52_11 - R51_33 * minus_E52_13;
  const T R52_31 = R50_11 * minus_E52_13 + R51_31 * E52_11;
  const T R52_32 = R50_12 * minus_E52_13 + R51_32 * E52_11;
  const T R52_33 = R50_13 * minus_E52_13 + R51_33 * E52_11;
  // omega52 = thetadot52 b52 + E52 omega51: absolute angular velocity, body axes [rad/s]
  const T omega52_1 = E52_11 * omega51_1 - minus_E52_13 * omega51_3;
  const T omega52_2 = thetadot52 + omega51_2;
  const T omega52_3 = minus_E52_13 * omega51_1 + E52_11 * omega51_3;
  // P52 = R51^T q52 + P51: position of the body origin, inertial axes [m]
  const T P52_3 = t51_1 + P51_3 + R51_23 * T(2.6) + R51_33 * T(0.1);
  // p52 = R52^T r52 + P52: position of the mass centre, inertial axes [m]
  const T t52_1 = R52_33 * T(0.05);
  const T p52_3 = t51_2 + t52_1 + P52_3 + R52_13 * T(0.1);
  // Pdot52 = R51^T omega51~ q52 + Pdot51: velocity of the body origin, inertial axes [m/s]
  const T t52_2 = t51_8 - omega51_3 * T(2.6);
  const T t52_3 = omega51_3 * T(0.3) - omega51_1 * T(0.1);
  const T t52_4 = omega51_1 * T(2.6) - omega51_2 * T(0.3);
  const T Pdot52_1 = Pdot51_1 + R50_11 * t52_2 + R51_21 * t52_3 + R51_31 * t52_4;
  const T Pdot52_2 = Pdot51_2 + R50_12 * t52_2 + R51_22 * t52_3 + R51_32 * t52_4;
  const T Pdot52_3 = Pdot51_3 + R50_13 * t52_2 + R51_23 * t52_3 + R51_33 * t52_4;
  // v52 = R52^T omega52~ r52 + Pdot52: velocity of the mass centre, inertial axes [m/s]
  const T t52_5 = omega52_2 * T(0.05) - omega52_3 * T(0.2);
  const T t52_6 = omega52_3 * T(0.1) - omega52_1 * T(0.05);
  const T t52_7 = omega52_2 * T(0.1);
  const T t52_8 = omega52_1 * T(0.2) - t52_7;
  const T v52_1 = Pdot52_1 + R52_11 * t52_5 + R51_21 * t52_6 + R52_31 * t52_8;
  const T v52_2 = Pdot52_2 + R52_12 * t52_5 + R51_22 * t52_6 + R52_32 * t52_8;
  const T v52_3 = Pdot52_3 + R52_13 * t52_5 + R51_23 * t52_6 + R52_33 * t52_8;
  // T52 = 1/2 omega52 . (I52 omega52) + 1/2 m52 v52 . v52: kinetic energy [J]
  const T T52 = T(0.5) * (omega52_1 * (T(0.62) * omega52_1 + T(0.031) * omega52_2 + T(0.0186) * omega52_3) + omega52_2
      * (T(0.031) * omega52_1 + T(0.744) * omega52_2 - T(0.0248) * omega52_3) + omega52_3 * (T(0.0186) * omega52_1 -
      T(0.0248) * omega52_2 + T(0.496) * omega52_3)) + T(3.1) * (v52_1 * v52_1 + v52_2 * v52_2 + v52_3 * v52_3);

  // ---- body 53 (body_53) on body 52
  const T thetadot53 = y[52];
  // E53^T = Rot(b53, theta53): E takes components in the lower body to those in the body
  const T E53_11 = cosines[52];
  const T E53_12 = sines[52];
  // R53^T = R52^T E53^T: R takes inertial components to body components
  const T R53_11 = R52_11 * E53_11 + R51_21 * E53_12;
  const T R53_12 = R52_12 * E53_11 + R51_22 * E53_12;
  const T R53_13 = R52_13 * E53_11 + R51_23 * E53_12;
  const T R53_21 = R51_21 * E53_11 - R52_11 * E53_12;
  const T R53_22 = R51_22 * E53_11 - R52_12 * E53_12;
  const T R53_23 = R51_23 * E53_11 - R52_13 * E53_12;
  // omega53 = thetadot53 b53 + E53 omega52: absolute angular velocity, body axes [rad/s]
  const T omega53_1 = E53_11 * omega52_1 + E53_12 * omega52_2;
  const T omega53_2 = E53_11 * omega52_2 - E53_12 * omega52_1;
  const T omega53_3 = thetadot53 + omega52_3;
  // P53 = R52^T q53 + P52: position of the body origin, inertial axes [m]
  const T t53_1 = R52_33 * T(0.1);
  const T P53_3 = t53_1 + P52_3 + R52_13 * T(0.3) + R51_23 * T(2.65);
  // p53 = R53^T r53 + P53: position of the mass centre, inertial axes [m]
  const T t53_2 = R53_13 * T(0.1);
  const T p53_3 = t53_2 + t52_1 + P53_3 + R53_23 * T(0.2);
  // Pdot53 = R52^T omega52~ q53 + Pdot52: velocity of the body origin, inertial axes [m/s]
  const T t53_3 = t52_7 - omega52_3 * T(2.65);
  const T t53_4 = omega52_3 * T(0.3) - omega52_1 * T(0.1);
  const T t53_5 = omega52_1 * T(2.65) - omega52_2 * T(0.3);
  const T Pdot53_1 = Pdot52_1 + R52_11 * t53_3 + R51_21 * t53_4 + R52_31 * t53_5;
  const T Pdot53_2 = Pdot52_2 + R52_12 * t53_3 + R51_22 * t53_4 + R52_32 * t53_5;
  const T Pdot53_3 = Pdot52_3 + R52_13 * t53_3 + R51_23 * t53_4 + R52_33 * t53_5;
  // v53 = R53^T omega53~ r53 + Pdot53: velocity of the mass centre, inertial axes [m/s]
  const T t53_6 = omega53_2 * T(0.05) - omega53_3 * T(0.2);
  const T t53_7 = omega53_3 * T(0.1) - omega53_1 * T(0.05);
  const T t53_8 = omega53_2 * T(0.1);
  const T t53_9 = omega53_1 * T(0.2) - t53_8;
  const T v53_1 = Pdot53_1 + R53_11 * t53_6 + R53_21 * t53_7 + R52_31 * t53_9;
  const T v53_2 = Pdot53_2 + R53_12 * t53_6 + R53_22 * t53_7 + R52_32 * t53_9;
  const T v53_3 = Pdot53_3 + R53_13 * t53_6 + R53_23 * t53_7 + R52_33 * t53_9;
  // T53 = 1/2 omega53 . (I53 omega53) + 1/2 m53 v53 . v53: kinetic energy [J]
  const T T53 = T(0.5) * (omega53_1 * (T(0.63) * omega53_1 + T(0.0315) * omega53_2 + T(0.0189) * omega53_3) +
      omega53_2 * (T(0.0315) * omega53_1 + T(0.756) * omega53_2 - T(0.0252) * omega53_3) + omega53_3 * (T(0.0189) *
      omega53_1 - T(0.0252) * omega53_2 + T(0.504) * omega53_3)) + T(3.15) * (v53_1 * v53_1 + v53_2 * v53_2 + v53_3 *
      v53_3);

  // ---- body 54 (body_54) on body 53
  const T thetadot54 = y[53];
  // E54^T = Rot(b54, theta54): E takes components in the lower body to those in the body
  const T E54_22 = cosines[53];
  const T E54_23 = sines[53];
  // R54^T = R53^T E54^T: R takes inertial components to body components
  const T R54_21 = R53_21 * E54_22 + R52_31 * E54_23;
  const T R54_22 = R53_22 * E54_22 + R52_32 * E54_23;
  const T R54_23 = R53_23 * E54_22 + R52_33 * E54_23;
  const T R54_31 = R52_31 * E54_22 - R53_21 * E54_23;
  const T R54_32 = R52_32 * E54_22 - R53_22 * E54_23;
  const T R54_33 = R52_33 * E54_22 - R53_23 * E54_23;
  // omega54 = thetadot54 b54 + E54 omega53: absolute angular velocity, body axes [rad/s]
  const T omega54_1 = thetadot54 + omega53_1;
  const T omega54_2 = E54_22 * omega53_2 + E54_23 * omega53_3;
  const T omega54_3 = E54_22 * omega53_3 - E54_23 * omega53_2;
  // P54 = R53^T q54 + P53: position of the body origin, inertial axes [m]
  const T t54_1 = R53_13 * T(0.3);
  const T P54_3 = t54_1 + t53_1 + P53_3 + R53_23 * T(2.7);
  // p54 = R54^T r54 + P54: position of the mass centre, inertial axes [m]
  const T t54_2 = R54_23 * T(0.2);
  const T p54_3 = t53_2 + t54_2 + P54_3 + R54_33 * T(0.05);
  // Pdot54 = R53^T omega53~ q54 + Pdot53: velocity of the body origin, inertial axes [m/s]
  const T t54_3 = t53_8 - omega53_3 * T(2.7);
  const T t54_4 = omega53_3 * T(0.3) - omega53_1 * T(0.1);
  const T t54_5 = omega53_1 * T(2.7) - omega53_2 * T(0.3);
  const T Pdot54_1 = Pdot53_1 + R53_11 * t54_3 + R53_21 * t54_4 + R52_31 * t54_5;
  const T Pdot54_2 = Pdot53_2 + R53_12 * t54_3 + R53_22 * t54_4 + R52_32 * t54_5;
  const T Pdot54_3 = Pdot53_3 + R53_13 * t54_3 + R53_23 * t54_4 + R52_33 * t54_5;
  // v54 = R54^T omega54~ r54 + Pdot54: velocity of the mass centre, inertial axes [m/s]
  const T t54_6 = omega54_2 * T(0.05) - omega54_3 * T(0.2);
  const T t54_7 = omega54_3 * T(0.1) - omega54_1 * T(0.05);
  const T t54_8 = omega54_2 * T(0.1);
  const T t54_9 = omega54_1 * T(0.2) - t54_8;
  const T v54_1 = Pdot54_1 + R53_11 * t54_6 + R54_21 * t54_7 + R54_31 * t54_9;
  const T v54_2 = Pdot54_2 + R53_12 * t54_6 + R54_22 * t54_7 + R54_32 * t54_9;
  const T v54_3 = Pdot54_3 + R53_13 * t54_6 + R54_23 * t54_7 + R54_33 * t54_9;
  // T54 = 1/2 omega54 . (I54 omega54) + 1/2 m54 v54 . v54: kinetic energy [J]
  const T T54 = T(0.5) * (omega54_1 * (T(0.64) * omega54_1 + T(0.032) * omega54_2 + T(0.0192) * omega54_3) + omega54_2
      * (T(0.032) * omega54_1 + T(0.768) * omega54_2 - T(0.0256) * omega54_3) + omega54_3 * (T(0.0192) * omega54_1 -
      T(0.0256) * omega54_2 + T(0.512) * omega54_3)) + T(3.2) * (v54_1 * v54_1 + v54_2 * v54_2 + v54_3 * v54_3);

  // ---- body 55 (body_55) on body 54
  const T thetadot55 = y[54];
  // E55^T = Rot(b55, theta55): E takes components in the lower body to those in the body
  const T E55_11 = cosines[54];
  const T minus_E55_13 = sines[54];
  // R55^T = R54^T E55^T: R takes inertial components to body components
  const T R55_11 = R53_11 * E55_11 - R54_31 * minus_E55_13;
  const T R55_12 = R53_12 * E55_11 - R54_32 * minus_E55_13;
  const T R55_13 = R53_13 * E55_11 - R54_33 * minus_E55_13;
  const T R55_31 = R53_11 * minus_E55_13 + R54_31 * E55_11;
  const T R55_32 = R53_12 * minus_E55_13 + R54_32 * E55_11;
  const T R55_33 = R53_13 * minus_E55_13 + R54_33 * E55_11;
  // omega55 = thetadot55 b55 + E55 omega54: absolute angular velocity, body axes [rad/s]
  const T omega55_1 = E55_11 * omega54_1 - minus_E55_13 * omega54_3;
  const T omega55_2 = thetadot55 + omega54_2;
  const T omega55_3 = minus_E55_13 * omega54_1 + E55_11 * omega54_3;
  // P55 = R54^T q55 + P54: position of the body origin, inertial axes [m]
  const T P55_3 = t54_1 + P54_3 + R54_23 * T(2.75) + R54_33 * T(0.1);
  // p55 = R55^T r55 + P55: position of the mass centre, inertial axes [m]
  const T t55_1 = R55_33 * T(0.05);
  const T p55_3 = t54_2 + t55_1 + P55_3 + R55_13 * T(0.1);
  // Pdot55 = R54^T omega54~ q55 + Pdot54: velocity of the body origin, inertial axes [m/s]
  const T t55_2 = t54_8 - omega54_3 * T(2.75);
  const T t55_3 = omega54_3 * T(0.3) - omega54_1 * T(0.1);
  const T t55_4 = omega54_1 * T(2.75) - omega54_2 * T(0.3);
  const T Pdot55_1 = Pdot54_1 + R53_11 * t55_2 + R54_21 * t55_3 + R54_31 * t55_4;
  const T Pdot55_2 = Pdot54_2 + R53_12 * t55_2 + R54_22 * t55_3 + R54_32 * t55_4;
  const T Pdot55_3 = Pdot54_3 + R53_13 * t55_2 + R54_23 * t55_3 + R54_33 * t55_4;
  // v55 = R55^T omega55~ r55 + Pdot55: velocity of the mass centre, inertial axes [m/s]
  const T t55_5 = omega55_2 * T(0.05) - omega55_3 * T(0.2);
  const T t55_6 = omega55_3 * T(0.1) - omega55_1 * T(0.05);
  const T t55_7 = omega55_2 * T(0.1);
  const T t55_8 = omega55_1 * T(0.2) - t55_7;
  const T v55_1 = Pdot55_1 + R55_11 * t55_5 + R54_21 * t55_6 + R55_31 * t55_8;
  const T v55_2 = Pdot55_2 + R55_12 * t55_5 + R54_22 * t55_6 + R55_32 * t55_8;
  const T v55_3 = Pdot55_3 + R55_13 * t55_5 + R54_23 * t55_6 + R55_33 * t55_8;
  // T55 = 1/2 omega55 . (I55 omega55) + 1/2 m55 v55 . v55: kinetic energy [J]
  const T T55 = T(0.5) * (omega55_1 * (T(0.65) * omega55_1 + T(0.0325) * omega55_2 + T(0.0195) * omega55_3) +
      omega55_2 * (T(0.0325) * omega55_1 + T(0.78) * omega55_2 - T(0.026) * omega55_3) + omega55_3 * (T(0.0195) *
      omega55_1 - T(0.026) * omega55_2 + T(0.52) * omega55_3)) + T(3.25) * (v55_1 * v55_1 + v55_2 * v55_2 + v55_3 *
      v55_3);

  // ---- body 56 (body_56) on body 55
  const T thetadot56 = y[55];
  // E56^T = Rot(b56, theta56): E takes components in the lower body to those in the body
  const T E56_11 = cosines[55];
  const T E56_12 = sines[55];
  // R56^T = R55^T E56^T: R takes inertial components to body components
  const T R56_11 = R55_11 * E56_11 + R54_21 * E56_12;
  const T R56_12 = R55_12 * E56_11 + R54_22 * E56_12;
  const T R56_13 = R55_13 * E56_11 + R54_23 * E56_12;
  const T R56_21 = R54_21 * E56_11 - R55_11 * E56_12;
  const T R56_22 = R54_22 * E56_11 - R55_12 * E56_12;
  const T R56_23 = R54_23 * E56_11 - R55_13 * E56_12;
  // omega56 = thetadot56 b56 + E56 omega55: absolute angular velocity, body axes [rad/s]
  const T omega56_1 = E56_11 * omega55_1 + E56_12 * omega55_2;
  const T omega56_2 = E56_11 * omega55_2 - E56_12 * omega55_1;
  const T omega56_3 = thetadot56 + omega55_3;
  // P56 = R55^T q56 + P55: position of the body origin, inertial axes [m]
  const T t56_1 = R55_33 * T(0.1);
  const T P56_3 = t56_1 + P55_3 + R55_13 * T(0.3) + R54_23 * T(2.8);
  // p56 = R56^T r56 + P56: position of the mass centre, inertial axes [m]
  const T t56_2 = R56_13 * T(0.1);
  const T p56_3 = t56_2 + t55_1 + P56_3 + R56_23 * T(0.2);
  // Pdot56 = R55^T omega55~ q56 + Pdot55: velocity of the body origin, inertial axes [m/s]
  const T t56_3 = t55_7 - omega55_3 * T(2.8);
  const T t56_4 = omega55_3 * T(0.3) - omega55_1 * T(0.1);
  const T t56_5 = omega55_1 * T(2.8) - omega55_2 * T(0.3);
  const T Pdot56_1 = Pdot55_1 + R55_11 * t56_3 + R54_21 * t56_4 + R55_31 * t56_5;
  const T Pdot56_2 = Pdot55_2 + R55_12 * t56_3 + R54_22 * t56_4 + R55_32 * t56_5;
  const T Pdot56_3 = Pdot55_3 + R55_13 * t56_3 + R54_23 * t56_4 + R55_33 * t56_5;
  // v56 = R56^T omega56~ r56 + Pdot56: velocity of the mass centre, inertial axes [m/s]
  const T t56_6 = omega56_2 * T(0.05) - omega56_3 * T(0.2);
  const T t56_7 = omega56_3 * T(0.1) - omega56_1 * T(0.05);
  const T t56_8 = omega56_2 * T(0.1);
  const T t56_9 = omega56_1 * T(0.2) - t56_8;
  const T v56_1 = Pdot56_1 + R56_11 * t56_6 + R56_21 * t56_7 + R55_31 * t56_9;
  const T v56_2 = Pdot56_2 + R56_12 * t56_6 + R56_22 * t56_7 + R55_32 * t56_9;
  const T v56_3 = Pdot56_3 + R56_13 * t56_6 + R56_23 * t56_7 + R55_33 * t56_9;
  // T56 = 1/2 omega56 . (I56 omega56) + 1/2 m56 v56 . v56: kinetic energy [J]
  const T T56 = T(0.5) * (omega56_1 * (T(0.66) * omega56_1 + T(0.033) * omega56_2 + T(0.0198) * omega56_3) + omega56_2
      * (T(0.033) * omega56_1 + T(0.792) * omega56_2 - T(0.0264) * omega56_3) + omega56_3 * (T(0.0198) * omega56_1 -
      T(0.0264) * omega56_2 + T(0.528) * omega56_3)) + T(3.3) * (v56_1 * v56_1 + v56_2 * v56_2 + v56_3 * v56_3);

  // ---- body 57 (body_57) on body 56
  const T thetadot57 = y[56];
  // E57^T = Rot(b57, theta57): E takes components in the lower body to those in the body
  const T E57_22 = cosines[56];
  const T E57_23 = sines[56];
  // R57^T = R56^T E57^T: R takes inertial components to body components
  const T R57_21 = R56_21 * E57_22 + R55_31 * E57_23;
  const T R57_22 = R56_22 * E57_22 + R55_32 * E57_23;
  const T R57_23 = R56_23 * E57_22 + R55_33 * E57_23;
  const T R57_31 = R55_31 * E57_22 - R56_21 * E57_23;
  const T R57_32 = R55_32 * E57_22 - R56_22 * E57_23;
  const T R57_33 = R55_33 * E57_22 - R56_23 * E57_23;
  // omega57 = thetadot57 b57 + E57 omega56: absolute angular velocity, body axes [rad/s]
  const T omega57_1 = thetadot57 + omega56_1;
  const T omega57_2 = E57_22 * omega56_2 + E57_23 * omega56_3;
  const T omega57_3 = E57_22 * omega56_3 - E57_23 * omega56_2;
  // P57 = R56^T q57 + P56: position of the body origin, inertial axes [m]
  const T t57_1 = R56_13 * T(0.3);
  const T P57_3 = t57_1 + t56_1 + P56_3 + R56_23 * T(2.85);
  // p57 = R57^T r57 + P57: position of the mass centre, inertial axes [m]
  const T t57_2 = R57_23 * T(0.2);
  const T p57_3 = t56_2 + t57_2 + P57_3 + R57_33 * T(0.05);
  // Pdot57 = R56^T omega56~ q57 + Pdot56: velocity of the body origin, inertial axes [m/s]
  const T t57_3 = t56_8 - omega56_3 * T(2.85);
  const T t57_4 = omega56_3 * T(0.3) - omega56_1 * T(0.1);
  const T t57_5 = omega56_1 * T(2.85) - omega56_2 * T(0.3);
  const T Pdot57_1 = Pdot56_1 + R56_11 * t57_3 + R56_21 * t57_4 + R55_31 * t57_5;
  const T Pdot57_2 = Pdot56_2 + R56_12 * t57_3 + R56_22 * t57_4 + R55_32 * t57_5;
  const T Pdot57_3 = Pdot56_3 + R56_13 * t57_3 + R56_23 * t57_4 + R55_33 * t57_5;
  // v57 = R57^T omega57~ r57 + Pdot57: velocity of the mass centre, inertial axes [m/s]
  const T t57_6 = omega57_2 * T(0.05) - omega57_3 * T(0.2);
  const T t57_7 = omega57_3 * T(0.1) - omega57_1 * T(0.05);
  const T t57_8 = omega57_2 * T(0.1);
  const T t57_9 = omega57_1 * T(0.2) - t57_8;
  const T v57_1 = Pdot57_1 + R56_11 * t57_6 + R57_21 * t57_7 + R57_31 * t57_9;
  const T v57_2 = Pdot57_2 + R56_12 * t57_6 + R57_22 * t57_7 + R57_32 * t57_9;
  const T v57_3 = Pdot57_3 + R56_13 * t57_6 + R57_23 * t57_7 + R57_33 * t57_9;
  // T57 = 1/2 omega57 . (I57 omega57) + 1/2 m57 v57 . v57: kinetic energy [J]
  const T T57 = T(0.5) * (omega57_1 * (T(0.67) * omega57_1 + T(0.0335) * omega57_2 + T(0.0201) * omega57_3) +
      omega57_2 * (T(0.0335) * omega57_1 + T(0.804) * omega57_2 - T(0.0268) * omega57_3) + omega57_3 * (T(0.0201) *
      omega57_1 - T(0.0268) * omega57_2 + T(0.536) * omega57_3)) + T(3.35) * (v57_1 * v57_1 + v57_2 * v57_2 + v57_3 *
      v57_3);

  // ---- body 58 (body_58) on body 57
  const T thetadot58 = y[57];
  // E58^T = Rot(b58, theta58): E takes components in the lower body to those in the body
  const T E58_11 = cosines[57];
  const T minus_E58_13 = sines[57];
  // R58^T = R57^T E58^T: R takes inertial components to body components
  const T R58_11 = R56_11 * E58_11 - R57_31 * minus_E58_13;
  const T R58_12 = R56_12 * E58_11 - R57_32 * minus_E58_13;
  const T R58_13 = R56_13 * E58_11 - R57_33 * minus_E58_13;
  const T R58_31 = R56_11 * minus_E58_13 + R57_31 * E58_11;
  const T R58_32 = R56_12 * minus_E58_13 + R57_32 * E58_11;
  const T R58_33 = R56_13 * minus_E58_13 + R57_33 * E58_11;
  // omega58 = thetadot58 b58 + E58 omega57: absolute angular velocity, body axes [rad/s]
  const T omega58_1 = E58_11 * omega57_1 - minus_E58_13 * omega57_3;
  const T omega58_2 = thetadot58 + omega57_2;
  const T omega58_3 = minus_E58_13 * omega57_1 + E58_11 * omega57_3;
  // P58 = R57^T q58 + P57: position of the body origin, inertial axes [m]
  const T P58_3 = t57_1 + P57_3 + R57_23 * T(2.9) + R57_33 * T(0.1);
  // p58 = R58^T r58 + P58: position of the mass centre, inertial axes [m]
  const T t58_1 = R58_33 * T(0.05);
  const T p58_3 = t57_2 + t58_1 + P58_3 + R58_13 * T(0.1);
  // Pdot58 = R57^T omega57~ q58 + Pdot57: velocity of the body origin, inertial axes [m/s]
  const T t58_2 = t57_8 - omega57_3 * T(2.9);
  const T t58_3 = omega57_3 * T(0.3) - omega57_1 * T(0.1);
  const T t58_4 = omega57_1 * T(2.9) - omega57_2 * T(0.3);
  const T Pdot58_1 = Pdot57_1 + R56_11 * t58_2 + R57_21 * t58_3 + R57_31 * t58_4;
  const T Pdot58_2 = Pdot57_2 + R56_12 * t58_2 + R57_22 * t58_3 + R57_32 * t58_4;
  const T Pdot58_3 = Pdot57_3 + R56_13 * t58_2 + R57_23 * t58_3 + R57_33 * t58_4;
  // v58 = R58^T omega58~ r58 + Pdot58: velocity of the mass centre, inertial axes [m/s]
  const T t58_5 = omega58_2 * T(0.05) - omega58_3 * T(0.2);
  const T t58_6 = omega58_3 * T(0.1) - omega58_1 * T(0.05);
  const T t58_7 = omega58_2 * T(0.1);
  const T t58_8 = omega58_1 * T(0.2) - t58_7;
  const T v58_1 = Pdot58_1 + R58_11 * t58_5 + R57_21 * t58_6 + R58_31 * t58_8;
  const T v58_2 = Pdot58_2 + R58_12 * t58_5 + R57_22 * t58_6 + R58_32 * t58_8;
  const T v58_3 = Pdot58_3 + R58_13 * t58_5 + R57_23 * t58_6 + R58_33 * t58_8;
  // T58 = 1/2 omega58 . (I58 omega58) + 1/2 m58 v58 . v58: kinetic energy [J]
  const T T58 = T(0.5) * (omega58_1 * (T(0.68) * omega58_1 + T(0.034) * omega58_2 + T(0.0204) * omega58_3) + omega58_2
      * (T(0.034) * omega58_1 + T(0.816) * omega58_2 - T(0.0272) * omega58_3) + omega58_3 * (T(0.0204) * omega58_1 -
      T(0.0272) * omega58_2 + T(0.544) * omega58_3)) + T(3.4) * (v58_1 * v58_1 + v58_2 * v58_2 + v58_3 * v58_3);

  // ---- body 59 (body_59) on body 58
  const T thetadot59 = y[58];
  // E59^T = Rot(b59, theta59): E takes components in the lower body to those in the body
  const T E59_11 = cosines[58];
  const T E59_12 = sines[58];
  // R59^T = R58^T E59^T: R takes inertial components to body components
  const T R59_11 = R58_11 * E59_11 + R57_21 * E59_12;
  const T R59_12 = R58_12 * E59_11 + R57_22 * E59_12;
  const T R59_13 = R58_13 * E59_11 + R57_23 * E59_12;
  const T R59_21 = R57_21 * E59_11 - R58_11 * E59_12;
  const T R59_22 = R57_22 * E59_11 - R58_12 * E59_12;
  const T R59_23 = R57_23 * E59_11 - R58_13 * E59_12;
  // omega59 = thetadot59 b59 + E59 omega58: absolute angular velocity, body axes [rad/s]
  const T omega59_1 = E59_11 * omega58_1 + E59_12 * omega58_2;
  const T omega59_2 = E59_11 * omega58_2 - E59_12 * omega58_1;
  const T omega59_3 = thetadot59 + omega58_3;
  // P59 = R58^T q59 + P58: position of the body origin, inertial axes [m]
  const T t59_1 = R58_33 * T(0.1);
  const T P59_3 = t59_1 + P58_3 + R58_13 * T(0.3) + R57_23 * T(2.95);
  // p59 = R59^T r59 + P59: position of the mass centre, inertial axes [m]
  const T t59_2 = R59_13 * T(0.1);
  const T p59_3 = t59_2 + t58_1 + P59_3 + R59_23 * T(0.2);
  // Pdot59 = R58^T omega58~ q59 + Pdot58: velocity of the body origin, inertial axes [m/s]
  const T t59_3 = t58_7 - omega58_3 * T(2.95);
  const T t59_4 = omega58_3 * T(0.3) - omega58_1 * T(0.1);
  const T t59_5 = omega58_1 * T(2.95) - omega58_2 * T(0.3);
  const T Pdot59_1 = Pdot58_1 + R58_11 * t59_3 + R57_21 * t59_4 + R58_31 * t59_5;
  const T Pdot59_2 = Pdot58_2 + R58_12 * t59_3 + R57_22 * t59_4 + R58_32 * t59_5;
  const T Pdot59_3 = Pdot58_3 + R58_13 * t59_3 + R57_23 * t59_4 + R58_33 * t59_5;
  // v59 = R59^T omega59~ r59 + Pdot59: velocity of the mass centre, inertial axes [m/s]
  const T t59_6 = omega59_2 * T(0.05) - omega59_3 * T(0.2);
  const T t59_7 = omega59_3 * T(0.1) - omega59_1 * T(0.05);
  const T t59_8 = omega59_2 * T(0.1);
  const T t59_9 = omega59_1 * T(0.2) - t59_8;
  const T v59_1 = Pdot59_1 + R59_11 * t59_6 + R59_21 * t59_7 + R58_31 * t59_9;
  const T v59_2 = Pdot59_2 + R59_12 * t59_6 + R59_22 * t59_7 + R58_32 * t59_9;
  const T v59_3 = Pdot59_3 + R59_13 * t59_6 + R59_23 * t59_7 + R58_33 * t59_9;
  // T59 = 1/2 omega59 . (I59 omega59) + 1/2 m59 v59 . v59: kinetic energy [J]
  const T T59 = T(0.5) * (omega59_1 * (T(0.69) * omega59_1 + T(0.0345) * omega59_2 + T(0.0207) * omega59_3) +
      omega59_2 * (T(0.0345) * omega59_1 + T(0.828) * omega59_2 - T(0.0276) * omega59_3) + omega59_3 * (T(0.0207) *
      omega59_1 - T(0.0276) * omega59_2 + T(0.552) * omega59_3)) + T(3.45) * (v59_1 * v59_1 + v59_2 * v59_2 + v59_3 *
      v59_3);

  // ---- body 60 (body_60) on body 59
  const T thetadot60 = y[59];
  // E60^T = Rot(b60, theta60): E takes components in the lower body to those in the body
  const T E60_22 = cosines[59];
  const T E60_23 = sines[59];
  // R60^T = R59^T E60^T: R takes inertial components to body components
  const T R60_21 = R59_21 * E60_22 + R58_31 * E60_23;
  const T R60_22 = R59_22 * E60_22 + R58_32 * E60_23;
  const T R60_23 = R59_23 * E60_22 + R58_33 * E60_23;
  const T R60_31 = R58_31 * E60_22 - R59_21 * E60_23;
  const T R60_32 = R58_32 * E60_22 - R59_22 * E60_23;
  const T R60_33 = R58_33 * E60_22 - R59_23 * E60_23;
  // omega60 = thetadot60 b60 + E60 omega59: absolute angular velocity, body axes [rad/s]
  const T omega60_1 = thetadot60 + omega59_1;
  const T omega60_2 = E60_22 * omega59_2 + E60_23 * omega59_3;
  const T omega60_3 = E60_22 * omega59_3 - E60_23 * omega59_2;
  // P60 = R59^T q60 + P59: position of the body origin, inertial axes [m]
  const T t60_1 = R59_13 * T(0.3);
  const T P60_3 = t60_1 + t59_1 + P59_3 + R59_23 * T(3);
  // p60 = R60^T r60 + P60: position of the mass centre, inertial axes [m]
  const T t60_2 = R60_23 * T(0.2);
  const T p60_3 = t59_2 + t60_2 + P60_3 + R60_33 * T(0.05);
  // Pdot60 = R59^T omega59~ q60 + Pdot59: velocity of the body origin, inertial axes [m/s]
  const T t60_3 = t59_8 - omega59_3 * T(3);
  const T t60_4 = omega59_3 * T(0.3) - omega59_1 * T(0.1);
  const T t60_5 = omega59_1 * T(3) - omega59_2 * T(0.3);
  const T Pdot60_1 = Pdot59_1 + R59_11 * t60_3 + R59_21 * t60_4 + R58_31 * t60_5;
  const T Pdot60_2 = Pdot59_2 + R59_12 * t60_3 + R59_22 * t60_4 + R58_32 * t60_5;
  const T Pdot60_3 = Pdot59_3 + R59_13 * t60_3 + R59_23 * t60_4 + R58_33 * t60_5;
  // v60 = R60^T omega60~ r60 + Pdot60: velocity of the mass centre, inertial axes [m/s]
  const T t60_6 = omega60_2 * T(0.05) - omega60_3 * T(0.2);
  const T t60_7 = omega60_3 * T(0.1) - omega60_1 * T(0.05);
  const T t60_8 = omega60_2 * T(0.1);
  const T t60_9 = omega60_1 * T(0.2) - t60_8;
  const T v60_1 = Pdot60_1 + R59_11 * t60_6 + R60_21 * t60_7 + R60_31 * t60_9;
  const T v60_2 = Pdot60_2 + R59_12 * t60_6 + R60_22 * t60_7 + R60_32 * t60_9;
  const T v60_3 = Pdot60_3 + R59_13 * t60_6 + R60_23 * t60_7 + R60_33 * t60_9;
  // T60 = 1/2 omega60 . (I60 omega60) + 1/2 m60 v60 . v60: kinetic energy [J]
  const T T60 = T(0.5) * (omega60_1 * (T(0.7) * omega60_1 + T(0.035) * omega60_2 + T(0.021) * omega60_3) + omega60_2 *
      (T(0.035) * omega60_1 + T(0.84) * omega60_2 - T(0.028) * omega60_3) + omega60_3 * (T(0.021) * omega60_1 -
      T(0.028) * omega60_2 + T(0.56) * omega60_3)) + T(3.5) * (v60_1 * v60_1 + v60_2 * v60_2 + v60_3 * v60_3);

  // ---- body 61 (body_61) on body 60
  const T thetadot61 = y[60];
  // E61^T = Rot(b61, theta61): E takes components in the lower body to those in the body
  const T E61_11 = cosines[60];
  const T minus_E61_13 = sines[60];
  // R61^T = R60^T E61^T: R takes inertial components to body components
  const T R61_11 = R59_11 * E61_11 - R60_31 * minus_E61_13;
  const T R61_12 = R59_12 * E61_11 - R60_32 * minus_E61_13;
  const T R61_13 = R59_13 * E61_11 - R60_33 * minus_E61_13;
  const T R61_31 = R59_11 * minus_E61_13 + R60_31 * E61_11;
  const T R61_32 = R59_12 * minus_E61_13 + R60_32 * E61_11;
  const T R61_33 = R59_13 * minus_E61_13 + R60_33 * E61_11;
  // omega61 = thetadot61 b61 + E61 omega60: absolute angular velocity, body axes [rad/s]
  const T omega61_1 = E61_11 * omega60_1 - minus_E61_13 * omega60_3;
  const T omega61_2 = thetadot61 + omega60_2;
  const T omega61_3 = minus_E61_13 * omega60_1 + E61_11 * omega60_3;
  // P61 = R60^T q61 + P60: position of the body origin, inertial axes [m]
  const T P61_3 = t60_1 + P60_3 + R60_23 * T(3.05) + R60_33 * T(0.1);
  // p61 = R61^T r61 + P61: position of the mass centre, inertial axes [m]
  const T t61_1 = R61_33 * T(0.05);
  const T p61_3 = t60_2 + t61_1 + P61_3 + R61_13 * T(0.1);
  // Pdot61 = R60^T omega60~ q61 + Pdot60: velocity of the body origin, inertial axes [m/s]
  const T t61_2 = t60_8 - omega60_3 * T(3.05);
  const T t61_3 = omega60_3 * T(0.3) - omega60_1 * T(0.1);
  const T t61_4 = omega60_1 * T(3.05) - omega60_2 * T(0.3);
  const T Pdot61_1 = Pdot60_1 + R59_11 * t61_2 + R60_21 * t61_3 + R60_31 * t61_4;
  const T Pdot61_2 = Pdot60_2 + R59_12 * t61_2 + R60_22 * t61_3 + R60_32 * t61_4;
  const T Pdot61_3 = Pdot60_3 + R59_13 * t61_2 + R60_23 * t61_3 + R60_33 * t61_4;
  // v61 = R61^T omega61~ r61 + Pdot61: velocity of the mass centre, inertial axes [m/s]
  const T t61_5 = omega61_2 * T(0.05) - omega61_3 * T(0.2);
  const T t61_6 = omega61_3 * T(0.1) - omega61_1 * T(0.05);
  const T t61_7 = omega61_2 * T(0.1);
  const T t61_8 = omega61_1 * T(0.2) - t61_7;
  const T v61_1 = Pdot61_1 + R61_11 * t61_5 + R60_21 * t61_6 + R61_31 * t61_8;
  const T v61_2 = Pdot61_2 + R61_12 * t61_5 + R60_22 * t61_6 + R61_32 * t61_8;
  const T v61_3 = Pdot61_3 + R61_13 * t61_5 + R60_23 * t61_6 + R61_33 * t61_8;
  // T61 = 1/2 omega61 . (I61 omega61) + 1/2 m61 v61 . v61: kinetic energy [J]
  const T T61 = T(0.5) * (omega61_1 * (T(0.71) * omega61_1 + T(0.0355) * omega61_2 + T(0.0213) * omega61_3) +
      omega61_2 * (T(0.0355) * omega61_1 + T(0.852) * omega61_2 - T(0.0284) * omega61_3) + omega61_3 * (T(0.0213) *
      omega61_1 - T(0.0284) * omega61_2 + T(0.568) * omega61_3)) + T(3.55) * (v61_1 * v61_1 + v61_2 * v61_2 + v61_3 *
      v61_3);

  // ---- body 62 (body_62) on body 61
  const T thetadot62 = y[61];
  // E62^T = Rot(b62, theta62): E takes components in the lower body to those in the body
  const T E62_11 = cosines[61];
  const T E62_12 = sines[61];
  // R62^T = R61^T E62^T: R takes inertial components to body components
  const T R62_11 = R61_11 * E62_11 + R60_21 * E62_12;
  const T R62_12 = R61_12 * E62_11 + R60_22 * E62_12;
  const T R62_13 = R61_13 * E62_11 + R60_23 * E62_12;
  const T R62_21 = R60_21 * E62_11 - R61_11 * E62_12;
  const T R62_22 = R60_22 * E62_11 - R61_12 * E62_12;
  const T R62_23 = R60_23 * E62_11 - R61_13 * E62_12;
  // omega62 = thetadot62 b62 + E62 omega61: absolute angular velocity, body axes [rad/s]
  const T omega62_1 = E62_11 * omega61_1 + E62_12 * omega61_2;
  const T omega62_2 = E62_11 * omega61_2 - E62_12 * omega61_1;
  const T omega62_3 = thetadot62 + omega61_3;
  // P62 = R61^T q62 + P61: position of the body origin, inertial axes [m]
  const T t62_1 = R61_33 * T(0.1);
  const T P62_3 = t62_1 + P61_3 + R61_13 * T(0.3) + R60_23 * T(3.1);
  // p62 = R62^T r62 + P62: position of the mass centre, inertial axes [m]
  const T t62_2 = R62_13 * T(0.1);
  const T p62_3 = t62_2 + t61_1 + P62_3 + R62_23 * T(0.2);
  // Pdot62 = R61^T omega61~ q62 + Pdot61: velocity of the body origin, inertial axes [m/s]
  const T t62_3 = t61_7 - omega61_3 * T(3.1);
  const T t62_4 = omega61_3 * T(0.3) - omega61_1 * T(0.1);
  const T t62_5 = omega61_1 * T(3.1) - omega61_2 * T(0.3);
  const T Pdot62_1 = Pdot61_1 + R61_11 * t62_3 + R60_21 * t62_4 + R61_31 * t62_5;
  const T Pdot62_2 = Pdot61_2 + R61_12 * t62_3 + R60_22 * t62_4 + R61_32 * t62_5;
  const T Pdot62_3 = Pdot61_3 + R61_13 * t62_3 + R60_23 * t62_4 + R61_33 * t62_5;
  // v62 = R62^T omega62~ r62 + Pdot62: velocity of the mass centre, inertial axes [m/s]
  const T t62_6 = omega62_2 * T(0.05) - omega62_3 * T(0.2);
  const T t62_7 = omega62_3 * T(0.1) - omega62_1 * T(0.05);
  const T t62_8 = omega62_2 * T(0.1);
  const T t62_9 = omega62_1 * T(0.2) - t62_8;
  const T v62_1 = Pdot62_1 + R62_11 * t62_6 + R62_21 * t62_7 + R61_31 * t62_9;
  const T v62_2 = Pdot62_2 + R62_12 * t62_6 + R62_22 * t62_7 + R61_32 * t62_9;
  const T v62_3 = Pdot62_3 + R62_13 * t62_6 + R62_23 * t62_7 + R61_33 * t62_9;
  // T62 = 1/2 omega62 . (I62 omega62) + 1/2 m62 v62 . v62: kinetic energy [J]
  const T T62 = T(0.5) * (omega62_1 * (T(0.72) * omega62_1 + T(0.036) * omega62_2 + T(0.0216) * omega62_3) + omega62_2
      * (T(0.036) * omega62_1 + T(0.864) * omega62_2 - T(0.0288) * omega62_3) + omega62_3 * (T(0.0216) * omega62_1 -
      T(0.0288) * omega62_2 + T(0.576) * omega62_3)) + T(3.6) * (v62_1 * v62_1 + v62_2 * v62_2 + v62_3 * v62_3);

  // ---- body 63 (body_63) on body 62
  const T thetadot63 = y[62];
  // E63^T = Rot(b63, theta63): E takes components in the lower body to those in the body
  const T E63_22 = cosines[62];
  const T E63_23 = sines[62];
  // R63^T = R62^T E63^T: R takes inertial components to body components
  const T R63_21 = R62_21 * E63_22 + R61_31 * E63_23;
  const T R63_22 = R62_22 * E63_22 + R61_32 * E63_23;
  const T R63_23 = R62_23 * E63_22 + R61_33 * E63_23;
  const T R63_31 = R61_31 * E63_22 - R62_21 * E63_23;
  const T R63_32 = R61_32 * E63_22 - R62_22 * E63_23;
  const T R63_33 = R61_33 * E63_22 - R62_23 * E63_23;
  // omega63 = thetadot63 b63 + E63 omega62: absolute angular velocity, body axes [rad/s]
  const T omega63_1 = thetadot63 + omega62_1;
  const T omega63_2 = E63_22 * omega62_2 + E63_23 * omega62_3;
  const T omega63_3 = E63_22 * omega62_3 - E63_23 * omega62_2;
  // P63 = R62^T q63 + P62: position of the body origin, inertial axes [m]
  const T t63_1 = R62_13 * T(0.3);
  const T P63_3 = t63_1 + t62_1 + P62_3 + R62_23 * T(3.15);
  // p63 = R63^T r63 + P63: position of the mass centre, inertial axes [m]
  const T t63_2 = R63_23 * T(0.2);
  const T p63_3 = t62_2 + t63_2 + P63_3 + R63_33 * T(0.05);
  // Pdot63 = R62^T omega62~ q63 + Pdot62: velocity of the body origin, inertial axes [m/s]
  const T t63_3 = t62_8 - omega62_3 * T(3.15);
  const T t63_4 = omega62_3 * T(0.3) - omega62_1 * T(0.1);
  const T t63_5 = omega62_1 * T(3.15) - omega62_2 * T(0.3);
  const T Pdot63_1 = Pdot62_1 + R62_11 * t63_3 + R62_21 * t63_4 + R61_31 * t63_5;
  const T Pdot63_2 = Pdot62_2 + R62_12 * t63_3 + R62_22 * t63_4 + R61_32 * t63_5;
  const T Pdot63_3 = Pdot62_3 + R62_13 * t63_3 + R62_23 * t63_4 + R61_33 * t63_5;
  // v63 = R63^T omega63~ r63 + Pdot63: velocity of the mass centre, inertial axes [m/s]
  const T t63_6 = omega63_2 * T(0.05) - omega63_3 * T(0.2);
  const T t63_7 = omega63_3 * T(0.1) - omega63_1 * T(0.05);
  const T t63_8 = omega63_2 * T(0.1);
  const T t63_9 = omega63_1 * T(0.2) - t63_8;
  const T v63_1 = Pdot63_1 + R62_11 * t63_6 + R63_21 * t63_7 + R63_31 * t63_9;
  const T v63_2 = Pdot63_2 + R62_12 * t63_6 + R63_22 * t63_7 + R63_32 * t63_9;
  const T v63_3 = Pdot63_3 + R62_13 * t63_6 + R63_23 * t63_7 + R63_33 * t63_9;
  // T63 = 1/2 omega63 . (I63 omega63) + 1/2 m63 v63 . v63: kinetic energy [J]
  const T T63 = T(0.5) * (omega63_1 * (T(0.73) * omega63_1 + T(0.0365) * omega63_2 + T(0.0219) * omega63_3) +
      omega63_2 * (T(0.0365) * omega63_1 + T(0.876) * omega63_2 - T(0.0292) * omega63_3) + omega63_3 * (T(0.0219) *
      omega63_1 - T(0.0292) * omega63_2 + T(0.584) * omega63_3)) + T(3.65) * (v63_1 * v63_1 + v63_2 * v63_2 + v63_3 *
      v63_3);

  // ---- body 64 (body_64) on body 63
  const T thetadot64 = y[63];
  // E64^T = Rot(b64, theta64): E takes components in the lower body to those in the body
  const T E64_11 = cosines[63];
  const T minus_E64_13 = sines[63];
  // R64^T = R63^T E64^T: R takes inertial components to body components
  const T R64_11 = R62_11 * E64_11 - R63_31 * minus_E64_13;
  const T R64_12 = R62_12 * E64_11 - R63_32 * minus_E64_13;
  const T R64_13 = R62_13 * E64_11 - R63_33 * minus_E64_13;
  const T R64_31 = R62_11 * minus_E64_13 + R63_31 * E64_11;
  const T R64_32 = R62_12 * minus_E64_13 + R63_32 * E64_11;
  const T R64_33 = R62_13 * minus_E64_13 + R63_33 * E64_11;
  // omega64 = thetadot64 b64 + E64 omega63: absolute angular velocity, body axes [rad/s]
  const T omega64_1 = E64_11 * omega63_1 - minus_E64_13 * omega63_3;
  const T omega64_2 = thetadot64 + omega63_2;
  const T omega64_3 = minus_E64_13 * omega63_1 + E64_11 * omega63_3;
  // P64 = R63^T q64 + P63: position of the body origin, inertial axes [m]
  const T P64_3 = t63_1 + P63_3 + R63_23 * T(3.2) + R63_33 * T(0.1);
  // p64 = R64^T r64 + P64: position of the mass centre, inertial axes [m]
  const T p64_3 = t63_2 + P64_3 + R64_13 * T(0.1) + R64_33 * T(0.05);
  // Pdot64 = R63^T omega63~ q64 + Pdot63: velocity of the body origin, inertial axes [m/s]
  const T t64_1 = t63_8 - omega63_3 * T(3.2);
  const T t64_2 = omega63_3 * T(0.3) - omega63_1 * T(0.1);
  const T t64_3 = omega63_1 * T(3.2) - omega63_2 * T(0.3);
  const T Pdot64_1 = Pdot63_1 + R62_11 * t64_1 + R63_21 * t64_2 + R63_31 * t64_3;
  const T Pdot64_2 = Pdot63_2 + R62_12 * t64_1 + R63_22 * t64_2 + R63_32 * t64_3;
  const T Pdot64_3 = Pdot63_3 + R62_13 * t64_1 + R63_23 * t64_2 + R63_33 * t64_3;
  // v64 = R64^T omega64~ r64 + Pdot64: velocity of the mass centre, inertial axes [m/s]
  const T t64_4 = omega64_2 * T(0.05) - omega64_3 * T(0.2);
  const T t64_5 = omega64_3 * T(0.1) - omega64_1 * T(0.05);
  const T t64_6 = omega64_1 * T(0.2) - omega64_2 * T(0.1);
  const T v64_1 = Pdot64_1 + R64_11 * t64_4 + R63_21 * t64_5 + R64_31 * t64_6;
  const T v64_2 = Pdot64_2 + R64_12 * t64_4 + R63_22 * t64_5 + R64_32 * t64_6;
  const T v64_3 = Pdot64_3 + R64_13 * t64_4 + R63_23 * t64_5 + R64_33 * t64_6;
  // T64 = 1/2 omega64 . (I64 omega64) + 1/2 m64 v64 . v64: kinetic energy [J]
  const T T64 = T(0.5) * (omega64_1 * (T(0.74) * omega64_1 + T(0.037) * omega64_2 + T(0.0222) * omega64_3) + omega64_2
      * (T(0.037) * omega64_1 + T(0.888) * omega64_2 - T(0.0296) * omega64_3) + omega64_3 * (T(0.0222) * omega64_1 -
      T(0.0296) * omega64_2 + T(0.592) * omega64_3)) + T(3.7) * (v64_1 * v64_1 + v64_2 * v64_2 + v64_3 * v64_3);

  // ---- whole system
  // kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12 + T13 + T14 + T15 + T16 + T17 + T18 + T19
  //   + T20 + T21 + T22 + T23 + T24 + T25 + T26 + T27 + T28 + T29 + T30 + T31 + T32 + T33 + T34 + T35 + T36 + T37 +
  //   T38 + T39 + T40 + T41 + T42 + T43 + T44 + T45 + T46 + T47 + T48 + T49 + T50 + T51 + T52 + T53 + T54 + T55 + T56
  //   + T57 + T58 + T59 + T60 + T61 + T62 + T63 + T64: kinetic energy of the system [J]
  const T kinetic = T1 + T2 + T3 + T4 + T5 + T6 + T7 + T8 + T9 + T10 + T11 + T12 + T13 + T14 + T15 + T16 + T17 + T18 +
      T19 + T20 + T21 + T22 + T23 + T24 + T25 + T26 + T27 + T28 + T29 + T30 + T31 + T32 + T33 + T34 + T35 + T36 + T37
      + T38 + T39 + T40 + T41 + T42 + T43 + T44 + T45 + T46 + T47 + T48 + T49 + T50 + T51 + T52 + T53 + T54 + T55 +
      T56 + T57 + T58 + T59 + T60 + T61 + T62 + T63 + T64;
  energy[0] = kinetic;
  // mp = m1 p1 + m2 p2 + m3 p3 + m4 p4 + m5 p5 + m6 p6 + m7 p7 + m8 p8 + m9 p9 + m10 p10 + m11 p11 + m12 p12 + m13
  //   p13 + m14 p14 + m15 p15 + m16 p16 + m17 p17 + m18 p18 + m19 p19 + m20 p20 + m21 p21 + m22 p22 + m23 p23 + m24
  //   p24 + m25 p25 + m26 p26 + m27 p27 + m28 p28 + m29 p29 + m30 p30 + m31 p31 + m32 p32 + m33 p33 + m34 p34 + m35
  //   p35 + m36 p36 + m37 p37 + m38 p38 + m39 p39 + m40 p40 + m41 p41 + m42 p42 + m43 p43 + m44 p44 + m45 p45 + m46
  //   p46 + m47 p47 + m48 p48 + m49 p49 + m50 p50 + m51 p51 + m52 p52 + m53 p53 + m54 p54 + m55 p55 + m56 p56 + m57
  //   p57 + m58 p58 + m59 p59 + m60 p60 + m61 p61 + m62 p62 + m63 p63 + m64 p64: first moment of mass, inertial axes
  //   [kg m]
  const T mp_3 = T(1.1) * p1_3 + T(1.2) * p2_3 + T(1.3) * p3_3 + T(1.4) * p4_3 + T(1.5) * p5_3 + T(1.6) * p6_3 +
      T(1.7) * p7_3 + T(1.8) * p8_3 + T(1.9) * p9_3 + T(2) * p10_3 + T(2.1) * p11_3 + T(2.2) * p12_3 + T(2.3) * p13_3
      + T(2.4) * p14_3 + T(2.5) * p15_3 + T(2.6) * p16_3 + T(2.7) * p17_3 + T(2.8) * p18_3 + T(2.9) * p19_3 + T(3) *
      p20_3 + T(3.1) * p21_3 + T(3.2) * p22_3 + T(3.3) * p23_3 + T(3.4) * p24_3 + T(3.5) * p25_3 + T(3.6) * p26_3 +
      T(3.7) * p27_3 + T(3.8) * p28_3 + T(3.9) * p29_3 + T(4) * p30_3 + T(4.1) * p31_3 + T(4.2) * p32_3 + T(4.3) *
      p33_3 + T(4.4) * p34_3 + T(4.5) * p35_3 + T(4.6) * p36_3 + T(4.7) * p37_3 + T(4.8) * p38_3 + T(4.9) * p39_3 +
      T(5) * p40_3 + T(5.1) * p41_3 + T(5.2) * p42_3 + T(5.3) * p43_3 + T(5.4) * p44_3 + T(5.5) * p45_3 + T(5.6) *
      p46_3 + T(5.7) * p47_3 + T(5.8) * p48_3 + T(5.9) * p49_3 + T(6) * p50_3 + T(6.1) * p51_3 + T(6.2) * p52_3 +
      T(6.3) * p53_3 + T(6.4) * p54_3 + T(6.5) * p55_3 + T(6.6) * p56_3 + T(6.7) * p57_3 + T(6.8) * p58_3 + T(6.9) *
      p59_3 + T(7) * p60_3 + T(7.1) * p61_3 + T(7.2) * p62_3 + T(7.3) * p63_3 + T(7.4) * p64_3;
  // potential = -g . mp: potential energy of gravity and springs [J]
  const T potential = T(9.81) * mp_3;
  energy[1] = potential;
}

// accelerations: ydot from A ydot = f.
// rates of y (ny) [rad/s^2], [m/s^2]
// 9318 add, 9721 multiply, 63 divide, 128 sine or cosine
namespace accelerations_sections {

// Results of a body's sections that others read, by their place in the body's frame; fields that no body has both
// of may share one. K, L and J in tables: where the frames of a body, of its lower and of an upper one begin.
namespace frame {
inline constexpr int minus_U_11 = 31, Pddot_1 = 2, Pddot_3 = 7, N_2 = 0, E_11 = 32, E_12 = 31, omega_1 = 8, omega_2 =
    9, omegadot_1 = 45, minus_omegadot_2 = 34, U_12 = 46, minus_U_22 = 47, U_32 = 48, minus_U_33 = 33, minus_Pddot_2 =
    7, G_3 = 3, N_1 = 4, N_3 = 5, E_22 = 32, E_23 = 45, omega_3 = 15, omegadot_2 = 46, omegadot_3 = 49, U_13 = 50,
    U_21 = 51, U_23 = 52, U_31 = 53, Pddot_2 = 16, G_1 = 10, G_2 = 11, minus_E_13 = 42, E_13 = 2, v = 1, Mp_33 = 34,
    Mp_11 = 54, Mp_13 = 17, gp_1 = 55, gp_3 = 35, Hp_33 = 36, Hp_11 = 7, Hp_12 = 33, Hp_31 = 37, Hp_13 = 49, Hp_32 =
    38, Jp_11 = 56, Jp_13 = 41, Jp_33 = 39, np_1 = 57, np_3 = 40, Hb_21 = 12, Hb_23 = 6, kB_1 = 18, kB_2 = 19, kB_3 =
    13, kK_2 = 41, kK_3 = 58, M_11 = 55, gt_1 = 47, minus_Mp_12 = 28, Mp_22 = 61, Mp_23 = 26, gp_2 = 59, Hp_21 = 48,
    minus_Hp_22 = 29, Hp_23 = 42, Jp_22 = 43, Jp_23 = 54, np_2 = 44, Hb_11 = 20, Hb_12 = 21, Hb_13 = 22, minus_Hb_22 =
    30, Hb_31 = 23, Hb_32 = 27, Hb_33 = 24, kK_1 = 60, M_33 = 36, gt_3 = 35, Mp_12 = 29, Jp_12 = 37, Hb_22 = 30, M_22
    = 43, gt_2 = 44, Hp_22 = 56, beta_3 = 14, alphaL_1 = 63, alphaL_2 = 62, minus_phi = 64, beta_1 = 25, beta_2 = 28,
    minus_alphaL_3 = 57, phi = 64, alphaL_3 = 65, minus_alphaL_2 = 38, minus_alphaL_1 = 50;
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

inline constexpr unsigned short outward_4_places[20][5] = {  // L, J, K, y_at, x_at
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
    {2062, 1997, 2127, 33, 33},
    {2258, 2193, 2324, 36, 36},
    {2455, 2390, 2520, 39, 39},
    {2651, 2586, 2717, 42, 42},
    {2848, 2783, 2913, 45, 45},
    {3044, 2979, 3110, 48, 48},
    {3241, 3176, 3306, 51, 51},
    {3437, 3372, 3503, 54, 54},
    {3634, 3569, 3699, 57, 57},
    {3830, 3765, 3896, 60, 60},
};
template <class C>
inline constexpr C outward_4_numbers[20][14] = {
    {C(0.13999999999999999), C(-0.06999999999999999), C(-0.13999999999999999), C(0.06999999999999999), C(-0.0336),
     C(0.1015), C(0.084), C(-0.049), C(0.0028000000000000004), C(-0.1015), C(0.049), C(0.0336),
     C(-0.0028000000000000004), C(-0.084)},
    {C(0.17), C(-0.085), C(-0.17), C(0.085), C(-0.05355), C(0.12325), C(0.102), C(-0.085), C(0.0034000000000000002),
     C(-0.12325), C(0.085), C(0.05355), C(-0.0034000000000000002), C(-0.102)},
    {C(0.2), C(-0.1), C(-0.2), C(0.1), C(-0.078), C(0.145), C(0.12), C(-0.13), C(0.004000000000000001), C(-0.145),
     C(0.13), C(0.078), C(-0.004000000000000001), C(-0.12)},
    {C(0.22999999999999998), C(-0.11499999999999999), C(-0.22999999999999998), C(0.11499999999999999), C(-0.10695),
     C(0.16675), C(0.138), C(-0.184), C(0.004600000000000001), C(-0.16675), C(0.184), C(0.10695),
     C(-0.004600000000000001), C(-0.138)},
    {C(0.26), C(-0.13), C(-0.26), C(0.13), C(-0.14040000000000002), C(0.1885), C(0.156), C(-0.24700000000000003),
     C(0.005200000000000002), C(-0.1885), C(0.24700000000000003), C(0.14040000000000002), C(-0.005200000000000002),
     C(-0.156)},
    {C(0.29), C(-0.145), C(-0.29), C(0.145), C(-0.17835), C(0.21024999999999996), C(0.17400000000000002), C(-0.319),
     C(0.005800000000000001), C(-0.21024999999999996), C(0.319), C(0.17835), C(-0.005800000000000001),
     C(-0.17400000000000002)},
    {C(0.32000000000000006), C(-0.16000000000000003), C(-0.32000000000000006), C(0.16000000000000003),
     C(-0.22080000000000005), C(0.232), C(0.192), C(-0.4000000000000001), C(0.006400000000000004), C(-0.232),
     C(0.4000000000000001), C(0.22080000000000005), C(-0.006400000000000004), C(-0.192)},
    {C(0.35000000000000003), C(-0.17500000000000002), C(-0.35000000000000003), C(0.17500000000000002),
     C(-0.26775000000000004), C(0.25375), C(0.21000000000000002), C(-0.49000000000000005), C(0.007000000000000001),
     C(-0.25375), C(0.49000000000000005), C(0.26775000000000004), C(-0.007000000000000001), C(-0.21000000000000002)},
    {C(0.38), C(-0.19), C(-0.38), C(0.19), C(-0.3192), C(0.2755), C(0.228), C(-0.589), C(0.007600000000000001),
     C(-0.2755), C(0.589), C(0.3192), C(-0.007600000000000001), C(-0.228)},
    {C(0.41), C(-0.205), C(-0.41), C(0.205), C(-0.37515), C(0.29724999999999996), C(0.24600000000000002), C(-0.697),
     C(0.0082), C(-0.29724999999999996), C(0.697), C(0.37515), C(-0.0082), C(-0.24600000000000002)},
    {C(0.44000000000000006), C(-0.22000000000000003), C(-0.44000000000000006), C(0.22000000000000003),
     C(-0.43560000000000004), C(0.319), C(0.264), C(-0.8140000000000001), C(0.008800000000000004), C(-0.319),
     C(0.8140000000000001), C(0.43560000000000004), C(-0.008800000000000004), C(-0.264)},
    {C(0.47000000000000003), C(-0.23500000000000001), C(-0.47000000000000003), C(0.23500000000000001), C(-0.50055),
     C(0.34074999999999994), C(0.282), C(-0.9400000000000002), C(0.009400000000000004), C(-0.34074999999999994),
     C(0.9400000000000002), C(0.50055), C(-0.009400000000000004), C(-0.282)},
    {C(0.5), C(-0.25), C(-0.5), C(0.25), C(-0.5700000000000001), C(0.3625), C(0.3), C(-1.075),
     C(0.010000000000000004), C(-0.3625), C(1.075), C(0.5700000000000001), C(-0.010000000000000004), C(-0.3)},
    {C(0.53), C(-0.265), C(-0.53), C(0.265), C(-0.64395), C(0.38425000000000004), C(0.318), C(-1.219),
     C(0.010600000000000002), C(-0.38425000000000004), C(1.219), C(0.64395), C(-0.010600000000000002), C(-0.318)},
    {C(0.5599999999999999), C(-0.27999999999999997), C(-0.5599999999999999), C(0.27999999999999997),
     C(-0.7223999999999999), C(0.406), C(0.336), C(-1.3719999999999999), C(0.011200000000000002), C(-0.406),
     C(1.3719999999999999), C(0.7223999999999999), C(-0.011200000000000002), C(-0.336)},
    {C(0.5900000000000001), C(-0.29500000000000004), C(-0.5900000000000001), C(0.29500000000000004),
     C(-0.8053500000000001), C(0.42774999999999996), C(0.354), C(-1.5340000000000003), C(0.011800000000000005),
     C(-0.42774999999999996), C(1.5340000000000003), C(0.8053500000000001), C(-0.011800000000000005), C(-0.354)},
    {C(0.6200000000000001), C(-0.31000000000000005), C(-0.6200000000000001), C(0.31000000000000005),
     C(-0.8928000000000001), C(0.4495), C(0.372), C(-1.7050000000000003), C(0.012400000000000007), C(-0.4495),
     C(1.7050000000000003), C(0.8928000000000001), C(-0.012400000000000007), C(-0.372)},
    {C(0.65), C(-0.325), C(-0.65), C(0.325), C(-0.98475), C(0.47125), C(0.39), C(-1.885), C(0.013000000000000003),
     C(-0.47125), C(1.885), C(0.98475), C(-0.013000000000000003), C(-0.39)},
    {C(0.68), C(-0.34), C(-0.68), C(0.34), C(-1.0812), C(0.493), C(0.408), C(-2.074), C(0.013600000000000001),
     C(-0.493), C(2.074), C(1.0812), C(-0.013600000000000001), C(-0.408)},
    {C(0.71), C(-0.355), C(-0.71), C(0.355), C(-1.18215), C(0.51475), C(0.426), C(-2.272), C(0.014200000000000003),
     C(-0.51475), C(2.272), C(1.18215), C(-0.014200000000000003), C(-0.426)},
};
inline constexpr unsigned short outward_5_places[20][5] = {  // L, J, K, y_at, x_at
    {162, 97, 228, 4, 4},
    {359, 293, 425, 7, 7},
    {555, 490, 621, 10, 10},
    {752, 686, 818, 13, 13},
    {948, 883, 1014, 16, 16},
    {1145, 1079, 1211, 19, 19},
    {1341, 1276, 1407, 22, 22},
    {1538, 1472, 1604, 25, 25},
    {1734, 1669, 1800, 28, 28},
    {1931, 1865, 1997, 31, 31},
    {2127, 2062, 2193, 34, 34},
    {2324, 2258, 2390, 37, 37},
    {2520, 2455, 2586, 40, 40},
    {2717, 2651, 2783, 43, 43},
    {2913, 2848, 2979, 46, 46},
    {3110, 3044, 3176, 49, 49},
    {3306, 3241, 3372, 52, 52},
    {3503, 3437, 3569, 55, 55},
    {3699, 3634, 3765, 58, 58},
    {3896, 3830, 3962, 61, 61},
};
template <class C>
inline constexpr C outward_5_numbers[20][21] = {
    {C(0.45), C(-0.45), C(-0.885), C(1.81), C(-4.8), C(-1.29), C(1.29), C(-1.81), C(0.885), C(-0.5205), C(0.27075),
     C(-0.40199999999999997), C(-0.249), C(0.35000000000000003), C(-0.27075), C(1.171), C(0.5205), C(0.249),
     C(0.40199999999999997), C(-1.171), C(-0.35000000000000003)},
    {C(0.75), C(-0.75), C(-1.05), C(2.14), C(-5.7), C(-2.115), C(2.115), C(-2.14), C(1.05), C(-0.909), C(0.3225),
     C(-0.9157500000000001), C(-0.4122), C(0.4136), C(-0.3225), C(1.38475), C(0.909), C(0.4122),
     C(0.9157500000000001), C(-1.38475), C(-0.4136)},
    {C(1.05), C(-1.05), C(-1.215), C(2.4699999999999998), C(-6.6), C(-3.12), C(3.12), C(-2.4699999999999998),
     C(1.215), C(-1.3875), C(0.37425), C(-1.767), C(-0.6114), C(0.4772), C(-0.37425), C(1.5984999999999998),
     C(1.3875), C(0.6114), C(1.767), C(-1.5984999999999998), C(-0.4772)},
    {C(1.35), C(-1.35), C(-1.3800000000000001), C(2.8), C(-7.5), C(-4.305), C(4.305), C(-2.8), C(1.3800000000000001),
     C(-1.956), C(0.426), C(-3.03675), C(-0.8466), C(0.5408000000000001), C(-0.426), C(1.81225), C(1.956), C(0.8466),
     C(3.03675), C(-1.81225), C(-0.5408000000000001)},
    {C(1.65), C(-1.65), C(-1.5450000000000002), C(3.13), C(-8.4), C(-5.67), C(5.67), C(-3.13), C(1.5450000000000002),
     C(-2.6145), C(0.47775000000000006), C(-4.806), C(-1.1178000000000001), C(0.6044), C(-0.47775000000000006),
     C(2.026), C(2.6145), C(1.1178000000000001), C(4.806), C(-2.026), C(-0.6044)},
    {C(1.95), C(-1.95), C(-1.7100000000000002), C(3.46), C(-9.3), C(-7.215000000000001), C(7.215000000000001),
     C(-3.46), C(1.7100000000000002), C(-3.363), C(0.5295000000000001), C(-7.155750000000001), C(-1.4250000000000003),
     C(0.668), C(-0.5295000000000001), C(2.23975), C(3.363), C(1.4250000000000003), C(7.155750000000001), C(-2.23975),
     C(-0.668)},
    {C(2.25), C(-2.25), C(-1.875), C(3.79), C(-10.2), C(-8.94), C(8.94), C(-3.79), C(1.875), C(-4.201499999999999),
     C(0.58125), C(-10.167), C(-1.7682), C(0.7316), C(-0.58125), C(2.4535), C(4.201499999999999), C(1.7682),
     C(10.167), C(-2.4535), C(-0.7316)},
    {C(2.55), C(-2.55), C(-2.04), C(4.12), C(-11.1), C(-10.845), C(10.845), C(-4.12), C(2.04), C(-5.13), C(0.633),
     C(-13.920750000000002), C(-2.1474), C(0.7952), C(-0.633), C(2.6672499999999997), C(5.13), C(2.1474),
     C(13.920750000000002), C(-2.6672499999999997), C(-0.7952)},
    {C(2.8499999999999996), C(-2.8499999999999996), C(-2.205), C(4.449999999999999), C(-12), C(-12.93), C(12.93),
     C(-4.449999999999999), C(2.205), C(-6.148499999999999), C(0.6847500000000001), C(-18.497999999999998),
     C(-2.5626), C(0.8588), C(-0.6847500000000001), C(2.881), C(6.148499999999999), C(2.5626), C(18.497999999999998),
     C(-2.881), C(-0.8588)},
    {C(3.1500000000000004), C(-3.1500000000000004), C(-2.37), C(4.78), C(-12.9), C(-15.195), C(15.195), C(-4.78),
     C(2.37), C(-7.257), C(0.7365), C(-23.97975), C(-3.0138000000000003), C(0.9224000000000001), C(-0.7365),
     C(3.09475), C(7.257), C(3.0138000000000003), C(23.97975), C(-3.09475), C(-0.9224000000000001)},
    {C(3.45), C(-3.45), C(-2.535), C(5.109999999999999), C(-13.8), C(-17.64), C(17.64), C(-5.109999999999999),
     C(2.535), C(-8.4555), C(0.7882500000000001), C(-30.447), C(-3.5010000000000003), C(0.986),
     C(-0.7882500000000001), C(3.3085), C(8.4555), C(3.5010000000000003), C(30.447), C(-3.3085), C(-0.986)},
    {C(3.75), C(-3.75), C(-2.7), C(5.44), C(-14.7), C(-20.265), C(20.265), C(-5.44), C(2.7), C(-9.744),
     C(0.8400000000000001), C(-37.98075), C(-4.0242), C(1.0496), C(-0.8400000000000001), C(3.5222499999999997),
     C(9.744), C(4.0242), C(37.98075), C(-3.5222499999999997), C(-1.0496)},
    {C(4.05), C(-4.05), C(-2.865), C(5.77), C(-15.6), C(-23.07), C(23.07), C(-5.77), C(2.865), C(-11.1225),
     C(0.89175), C(-46.662000000000006), C(-4.5834), C(1.1132), C(-0.89175), C(3.7359999999999998), C(11.1225),
     C(4.5834), C(46.662000000000006), C(-3.7359999999999998), C(-1.1132)},
    {C(4.35), C(-4.35), C(-3.0300000000000002), C(6.1), C(-16.5), C(-26.055), C(26.055), C(-6.1),
     C(3.0300000000000002), C(-12.591), C(0.9435000000000001), C(-56.57175), C(-5.1786), C(1.1768),
     C(-0.9435000000000001), C(3.94975), C(12.591), C(5.1786), C(56.57175), C(-3.94975), C(-1.1768)},
    {C(4.65), C(-4.65), C(-3.1950000000000003), C(6.43), C(-17.4), C(-29.22), C(29.22), C(-6.43),
     C(3.1950000000000003), C(-14.1495), C(0.9952500000000001), C(-67.791), C(-5.8098), C(1.2404000000000002),
     C(-0.9952500000000001), C(4.1635), C(14.1495), C(5.8098), C(67.791), C(-4.1635), C(-1.2404000000000002)},
    {C(4.95), C(-4.95), C(-3.3600000000000003), C(6.76), C(-18.3), C(-32.565), C(32.565), C(-6.76),
     C(3.3600000000000003), C(-15.797999999999998), C(1.0470000000000002), C(-80.40074999999999),
     C(-6.476999999999999), C(1.304), C(-1.0470000000000002), C(4.37725), C(15.797999999999998), C(6.476999999999999),
     C(80.40074999999999), C(-4.37725), C(-1.304)},
    {C(5.25), C(-5.25), C(-3.5250000000000004), C(7.09), C(-19.2), C(-36.09), C(36.09), C(-7.09),
     C(3.5250000000000004), C(-17.5365), C(1.0987500000000001), C(-94.48200000000001), C(-7.180200000000001),
     C(1.3676000000000001), C(-1.0987500000000001), C(4.591), C(17.5365), C(7.180200000000001), C(94.48200000000001),
     C(-4.591), C(-1.3676000000000001)},
    {C(5.55), C(-5.55), C(-3.69), C(7.42), C(-20.1), C(-39.795), C(39.795), C(-7.42), C(3.69), C(-19.365), C(1.1505),
     C(-110.11575), C(-7.9194), C(1.4312), C(-1.1505), C(4.804749999999999), C(19.365), C(7.9194), C(110.11575),
     C(-4.804749999999999), C(-1.4312)},
    {C(5.85), C(-5.85), C(-3.855), C(7.75), C(-21), C(-43.68), C(43.68), C(-7.75), C(3.855), C(-21.2835), C(1.20225),
     C(-127.383), C(-8.6946), C(1.4948), C(-1.20225), C(5.0184999999999995), C(21.2835), C(8.6946), C(127.383),
     C(-5.0184999999999995), C(-1.4948)},
    {C(6.15), C(-6.15), C(-4.0200000000000005), C(8.08), C(-21.9), C(-47.745), C(47.745), C(-8.08),
     C(4.0200000000000005), C(-23.291999999999998), C(1.254), C(-146.36475), C(-9.5058), C(1.5584), C(-1.254),
     C(5.23225), C(23.291999999999998), C(9.5058), C(146.36475), C(-5.23225), C(-1.5584)},
};
inline constexpr unsigned short outward_6_places[20][5] = {  // L, J, K, y_at, x_at
    {228, 162, 293, 5, 5},
    {425, 359, 490, 8, 8},
    {621, 555, 686, 11, 11},
    {818, 752, 883, 14, 14},
    {1014, 948, 1079, 17, 17},
    {1211, 1145, 1276, 20, 20},
    {1407, 1341, 1472, 23, 23},
    {1604, 1538, 1669, 26, 26},
    {1800, 1734, 1865, 29, 29},
    {1997, 1931, 2062, 32, 32},
    {2193, 2127, 2258, 35, 35},
    {2390, 2324, 2455, 38, 38},
    {2586, 2520, 2651, 41, 41},
    {2783, 2717, 2848, 44, 44},
    {2979, 2913, 3044, 47, 47},
    {3176, 3110, 3241, 50, 50},
    {3372, 3306, 3437, 53, 53},
    {3569, 3503, 3634, 56, 56},
    {3765, 3699, 3830, 59, 59},
    {3962, 3896, 4027, 62, 62},
};
template <class C>
inline constexpr C outward_6_numbers[20][16] = {
    {C(0.3), C(-0.3), C(-0.25), C(-1.255), C(1.255), C(0.25), C(0.1292), C(-0.6809999999999999), C(-0.1159), C(0.133),
     C(-0.77925), C(0.6809999999999999), C(-0.133), C(0.77925), C(-0.1292), C(0.1159)},
    {C(0.45), C(-0.45), C(-0.295), C(-1.78), C(1.78), C(0.295), C(0.1523), C(-0.9824999999999999), C(-0.1666),
     C(0.15775), C(-1.293), C(0.9824999999999999), C(-0.15775), C(1.293), C(-0.1523), C(0.1666)},
    {C(0.6), C(-0.6), C(-0.34), C(-2.395), C(2.395), C(0.34), C(0.1754), C(-1.3379999999999999), C(-0.2263),
     C(0.18250000000000002), C(-2.02275), C(1.3379999999999999), C(-0.18250000000000002), C(2.02275), C(-0.1754),
     C(0.2263)},
    {C(0.75), C(-0.75), C(-0.385), C(-3.1), C(3.1), C(0.385), C(0.1985), C(-1.7475), C(-0.29500000000000004),
     C(0.20725), C(-3.0090000000000003), C(1.7475), C(-0.20725), C(3.0090000000000003), C(-0.1985),
     C(0.29500000000000004)},
    {C(0.9), C(-0.9), C(-0.43), C(-3.895), C(3.895), C(0.43), C(0.2216), C(-2.211), C(-0.3727), C(0.232), C(-4.29225),
     C(2.211), C(-0.232), C(4.29225), C(-0.2216), C(0.3727)},
    {C(1.05), C(-1.05), C(-0.47500000000000003), C(-4.78), C(4.78), C(0.47500000000000003), C(0.24470000000000003),
     C(-2.7285000000000004), C(-0.4594000000000001), C(0.25675), C(-5.913000000000001), C(2.7285000000000004),
     C(-0.25675), C(5.913000000000001), C(-0.24470000000000003), C(0.4594000000000001)},
    {C(1.2), C(-1.2), C(-0.52), C(-5.755), C(5.755), C(0.52), C(0.2678), C(-3.3), C(-0.5551), C(0.2815),
     C(-7.9117500000000005), C(3.3), C(-0.2815), C(7.9117500000000005), C(-0.2678), C(0.5551)},
    {C(1.35), C(-1.35), C(-0.5650000000000001), C(-6.819999999999999), C(6.819999999999999), C(0.5650000000000001),
     C(0.2909), C(-3.9254999999999995), C(-0.6597999999999999), C(0.30625), C(-10.328999999999999),
     C(3.9254999999999995), C(-0.30625), C(10.328999999999999), C(-0.2909), C(0.6597999999999999)},
    {C(1.5), C(-1.5), C(-0.61), C(-7.975), C(7.975), C(0.61), C(0.314), C(-4.6049999999999995), C(-0.7735), C(0.331),
     C(-13.20525), C(4.6049999999999995), C(-0.331), C(13.20525), C(-0.314), C(0.7735)},
    {C(1.65), C(-1.65), C(-0.655), C(-9.22), C(9.22), C(0.655), C(0.3371), C(-5.3385), C(-0.8962000000000001),
     C(0.35575), C(-16.581), C(5.3385), C(-0.35575), C(16.581), C(-0.3371), C(0.8962000000000001)},
    {C(1.8), C(-1.8), C(-0.7000000000000001), C(-10.555000000000001), C(10.555000000000001), C(0.7000000000000001),
     C(0.3602), C(-6.126), C(-1.0279), C(0.38050000000000006), C(-20.496750000000002), C(6.126),
     C(-0.38050000000000006), C(20.496750000000002), C(-0.3602), C(1.0279)},
    {C(1.95), C(-1.95), C(-0.7450000000000001), C(-11.98), C(11.98), C(0.7450000000000001), C(0.38330000000000003),
     C(-6.9675), C(-1.1686), C(0.40525), C(-24.993000000000002), C(6.9675), C(-0.40525), C(24.993000000000002),
     C(-0.38330000000000003), C(1.1686)},
    {C(2.1), C(-2.1), C(-0.79), C(-13.495), C(13.495), C(0.79), C(0.4064), C(-7.8629999999999995), C(-1.3183),
     C(0.43000000000000005), C(-30.110249999999997), C(7.8629999999999995), C(-0.43000000000000005),
     C(30.110249999999997), C(-0.4064), C(1.3183)},
    {C(2.25), C(-2.25), C(-0.835), C(-15.099999999999998), C(15.099999999999998), C(0.835), C(0.4295),
     C(-8.812499999999998), C(-1.4769999999999999), C(0.45475000000000004), C(-35.888999999999996),
     C(8.812499999999998), C(-0.45475000000000004), C(35.888999999999996), C(-0.4295), C(1.4769999999999999)},
    {C(2.4), C(-2.4), C(-0.8800000000000001), C(-16.795), C(16.795), C(0.8800000000000001), C(0.45260000000000006),
     C(-9.816), C(-1.6447000000000003), C(0.4795), C(-42.36975000000001), C(9.816), C(-0.4795), C(42.36975000000001),
     C(-0.45260000000000006), C(1.6447000000000003)},
    {C(2.55), C(-2.55), C(-0.925), C(-18.580000000000002), C(18.580000000000002), C(0.925), C(0.4757), C(-10.8735),
     C(-1.8214000000000001), C(0.50425), C(-49.593), C(10.8735), C(-0.50425), C(49.593), C(-0.4757),
     C(1.8214000000000001)},
    {C(2.7), C(-2.7), C(-0.9700000000000001), C(-20.455000000000002), C(20.455000000000002), C(0.9700000000000001),
     C(0.4988), C(-11.985), C(-2.0071000000000003), C(0.529), C(-57.59925), C(11.985), C(-0.529), C(57.59925),
     C(-0.4988), C(2.0071000000000003)},
    {C(2.85), C(-2.85), C(-1.0150000000000001), C(-22.419999999999998), C(22.419999999999998), C(1.0150000000000001),
     C(0.5219), C(-13.1505), C(-2.2018), C(0.5537500000000001), C(-66.429), C(13.1505), C(-0.5537500000000001),
     C(66.429), C(-0.5219), C(2.2018)},
    {C(3), C(-3), C(-1.06), C(-24.474999999999998), C(24.474999999999998), C(1.06), C(0.545), C(-14.369999999999997),
     C(-2.4055), C(0.5784999999999999), C(-76.12274999999998), C(14.369999999999997), C(-0.5784999999999999),
     C(76.12274999999998), C(-0.545), C(2.4055)},
    {C(3.15), C(-3.15), C(-1.105), C(-26.620000000000005), C(26.620000000000005), C(1.105), C(0.5681),
     C(-15.643500000000001), C(-2.6182000000000007), C(0.6032500000000001), C(-86.78316000000002),
     C(15.643500000000001), C(-0.6032500000000001), C(86.78316000000002), C(-0.5681), C(2.6182000000000007)},
};
inline constexpr unsigned short inward_4_places[20][3] = {  // J, K, u_at
    {3962, 3896, 0},
    {3765, 3699, 1},
    {3569, 3503, 2},
    {3372, 3306, 3},
    {3176, 3110, 4},
    {2979, 2913, 5},
    {2783, 2717, 6},
    {2586, 2520, 7},
    {2390, 2324, 8},
    {2193, 2127, 9},
    {1997, 1931, 10},
    {1800, 1734, 11},
    {1604, 1538, 12},
    {1407, 1341, 13},
    {1211, 1145, 14},
    {1014, 948, 15},
    {818, 752, 16},
    {621, 555, 17},
    {425, 359, 18},
    {228, 162, 19},
};
template <class C>
inline constexpr C inward_4_numbers[20][11] = {
    {C(-0.355), C(0.355), C(-0.71), C(0.71), C(6.15), C(0.08875000000000001), C(-2.272), C(-6.15),
     C(-0.014200000000000003), C(0.94075), C(-1.18215)},
    {C(-0.34), C(0.34), C(-0.68), C(0.68), C(5.85), C(0.085), C(-2.074), C(-5.85), C(-0.013600000000000001),
     C(0.9009999999999999), C(-1.0812)},
    {C(-0.325), C(0.325), C(-0.65), C(0.65), C(5.55), C(0.08125), C(-1.885), C(-5.55), C(-0.013000000000000003),
     C(0.8612500000000001), C(-0.98475)},
    {C(-0.31000000000000005), C(0.31000000000000005), C(-0.6200000000000001), C(0.6200000000000001), C(5.25),
     C(0.0775), C(-1.7050000000000003), C(-5.25), C(-0.012400000000000007), C(0.8215), C(-0.8928000000000001)},
    {C(-0.29500000000000004), C(0.29500000000000004), C(-0.5900000000000001), C(0.5900000000000001), C(4.95),
     C(0.07374999999999998), C(-1.5340000000000003), C(-4.95), C(-0.011800000000000005), C(0.78175),
     C(-0.8053500000000001)},
    {C(-0.27999999999999997), C(0.27999999999999997), C(-0.5599999999999999), C(0.5599999999999999), C(4.65),
     C(0.07000000000000005), C(-1.3719999999999999), C(-4.65), C(-0.011200000000000002), C(0.742),
     C(-0.7223999999999999)},
    {C(-0.265), C(0.265), C(-0.53), C(0.53), C(4.35), C(0.06625000000000003), C(-1.219), C(-4.35),
     C(-0.010600000000000002), C(0.70225), C(-0.64395)},
    {C(-0.25), C(0.25), C(-0.5), C(0.5), C(4.05), C(0.06249999999999997), C(-1.075), C(-4.05),
     C(-0.010000000000000004), C(0.6625), C(-0.5700000000000001)},
    {C(-0.23500000000000001), C(0.23500000000000001), C(-0.47000000000000003), C(0.47000000000000003), C(3.75),
     C(0.05874999999999997), C(-0.9400000000000002), C(-3.75), C(-0.009400000000000004), C(0.6227499999999999),
     C(-0.50055)},
    {C(-0.22000000000000003), C(0.22000000000000003), C(-0.44000000000000006), C(0.44000000000000006), C(3.45),
     C(0.055000000000000014), C(-0.8140000000000001), C(-3.45), C(-0.008800000000000004), C(0.5830000000000001),
     C(-0.43560000000000004)},
    {C(-0.205), C(0.205), C(-0.41), C(0.41), C(3.1500000000000004), C(0.05124999999999996), C(-0.697),
     C(-3.1500000000000004), C(-0.0082), C(0.54325), C(-0.37515)},
    {C(-0.19), C(0.19), C(-0.38), C(0.38), C(2.8499999999999996), C(0.04750000000000001), C(-0.589),
     C(-2.8499999999999996), C(-0.007600000000000001), C(0.5035000000000001), C(-0.3192)},
    {C(-0.17500000000000002), C(0.17500000000000002), C(-0.35000000000000003), C(0.35000000000000003), C(2.55),
     C(0.04374999999999995), C(-0.49000000000000005), C(-2.55), C(-0.007000000000000001), C(0.46375),
     C(-0.26775000000000004)},
    {C(-0.16000000000000003), C(0.16000000000000003), C(-0.32000000000000006), C(0.32000000000000006), C(2.25),
     C(0.039999999999999994), C(-0.4000000000000001), C(-2.25), C(-0.006400000000000004), C(0.424),
     C(-0.22080000000000005)},
    {C(-0.145), C(0.145), C(-0.29), C(0.29), C(1.95), C(0.03624999999999997), C(-0.319), C(-1.95),
     C(-0.005800000000000001), C(0.38425), C(-0.17835)},
    {C(-0.13), C(0.13), C(-0.26), C(0.26), C(1.65), C(0.032500000000000015), C(-0.24700000000000003), C(-1.65),
     C(-0.005200000000000002), C(0.34450000000000003), C(-0.14040000000000002)},
    {C(-0.11499999999999999), C(0.11499999999999999), C(-0.22999999999999998), C(0.22999999999999998), C(1.35),
     C(0.02875000000000001), C(-0.184), C(-1.35), C(-0.004600000000000001), C(0.30475), C(-0.10695)},
    {C(-0.1), C(0.1), C(-0.2), C(0.2), C(1.05), C(0.025000000000000005), C(-0.13), C(-1.05), C(-0.004000000000000001),
     C(0.265), C(-0.078)},
    {C(-0.085), C(0.085), C(-0.17), C(0.17), C(0.75), C(0.02125), C(-0.085), C(-0.75), C(-0.0034000000000000002),
     C(0.22524999999999998), C(-0.05355)},
    {C(-0.06999999999999999), C(0.06999999999999999), C(-0.13999999999999999), C(0.13999999999999999), C(0.45),
     C(0.017500000000000012), C(-0.049), C(-0.45), C(-0.0028000000000000004), C(0.1855), C(-0.0336)},
};
inline constexpr unsigned short inward_5_places[19][3] = {  // J, K, u_at
    {3896, 3830, 20},
    {3699, 3634, 21},
    {3503, 3437, 22},
    {3306, 3241, 23},
    {3110, 3044, 24},
    {2913, 2848, 25},
    {2717, 2651, 26},
    {2520, 2455, 27},
    {2324, 2258, 28},
    {2127, 2062, 29},
    {1931, 1865, 30},
    {1734, 1669, 31},
    {1538, 1472, 32},
    {1341, 1276, 33},
    {1145, 1079, 34},
    {948, 883, 35},
    {752, 686, 36},
    {555, 490, 37},
    {359, 293, 38},
};
template <class C>
inline constexpr C inward_5_numbers[19][11] = {
    {C(-1.06), C(24.474999999999998), C(1.06), C(-24.474999999999998), C(76.70124999999999), C(-14.369999999999997),
     C(-0.545), C(-2.4055), C(75.54424999999999), C(3), C(-3)},
    {C(-1.0150000000000001), C(22.419999999999998), C(1.0150000000000001), C(-22.419999999999998), C(66.98275),
     C(-13.1505), C(-0.5219), C(-2.2018), C(65.87525), C(2.85), C(-2.85)},
    {C(-0.9700000000000001), C(20.455000000000002), C(0.9700000000000001), C(-20.455000000000002), C(58.12825),
     C(-11.985), C(-0.4988), C(-2.0071000000000003), C(57.07025), C(2.7), C(-2.7)},
    {C(-0.925), C(18.580000000000002), C(0.925), C(-18.580000000000002), C(50.09725), C(-10.8735), C(-0.4757),
     C(-1.8214000000000001), C(49.088750000000005), C(2.55), C(-2.55)},
    {C(-0.8800000000000001), C(16.795), C(0.8800000000000001), C(-16.795), C(42.849250000000005), C(-9.816),
     C(-0.45260000000000006), C(-1.6447000000000003), C(41.89025000000001), C(2.4), C(-2.4)},
    {C(-0.835), C(15.099999999999998), C(0.835), C(-15.099999999999998), C(36.34374999999999), C(-8.812499999999998),
     C(-0.4295), C(-1.4769999999999999), C(35.43424999999999), C(2.25), C(-2.25)},
    {C(-0.79), C(13.495), C(0.79), C(-13.495), C(30.540249999999997), C(-7.8629999999999995), C(-0.4064), C(-1.3183),
     C(29.680249999999997), C(2.1), C(-2.1)},
    {C(-0.7450000000000001), C(11.98), C(0.7450000000000001), C(-11.98), C(25.39825), C(-6.9675),
     C(-0.38330000000000003), C(-1.1686), C(24.58775), C(1.95), C(-1.95)},
    {C(-0.7000000000000001), C(10.555000000000001), C(0.7000000000000001), C(-10.555000000000001),
     C(20.877250000000004), C(-6.126), C(-0.3602), C(-1.0279), C(20.11625), C(1.8), C(-1.8)},
    {C(-0.655), C(9.22), C(0.655), C(-9.22), C(16.93675), C(-5.3385), C(-0.3371), C(-0.8962000000000001), C(16.22525),
     C(1.65), C(-1.65)},
    {C(-0.61), C(7.975), C(0.61), C(-7.975), C(13.536249999999999), C(-4.6049999999999995), C(-0.314), C(-0.7735),
     C(12.87425), C(1.5), C(-1.5)},
    {C(-0.5650000000000001), C(6.819999999999999), C(0.5650000000000001), C(-6.819999999999999), C(10.63525),
     C(-3.9254999999999995), C(-0.2909), C(-0.6597999999999999), C(10.022749999999998), C(1.35), C(-1.35)},
    {C(-0.52), C(5.755), C(0.52), C(-5.755), C(8.19325), C(-3.3), C(-0.2678), C(-0.5551), C(7.63025), C(1.2),
     C(-1.2)},
    {C(-0.47500000000000003), C(4.78), C(0.47500000000000003), C(-4.78), C(6.169750000000001), C(-2.7285000000000004),
     C(-0.24470000000000003), C(-0.4594000000000001), C(5.656250000000001), C(1.05), C(-1.05)},
    {C(-0.43), C(3.895), C(0.43), C(-3.895), C(4.524249999999999), C(-2.211), C(-0.2216), C(-0.3727), C(4.06025),
     C(0.9), C(-0.9)},
    {C(-0.385), C(3.1), C(0.385), C(-3.1), C(3.2162500000000005), C(-1.7475), C(-0.1985), C(-0.29500000000000004),
     C(2.80175), C(0.75), C(-0.75)},
    {C(-0.34), C(2.395), C(0.34), C(-2.395), C(2.20525), C(-1.3379999999999999), C(-0.1754), C(-0.2263), C(1.84025),
     C(0.6), C(-0.6)},
    {C(-0.295), C(1.78), C(0.295), C(-1.78), C(1.45075), C(-0.9824999999999999), C(-0.1523), C(-0.1666), C(1.13525),
     C(0.45), C(-0.45)},
    {C(-0.25), C(1.255), C(0.25), C(-1.255), C(0.91225), C(-0.6809999999999999), C(-0.1292), C(-0.1159), C(0.64625),
     C(0.3), C(-0.3)},
};
inline constexpr unsigned short inward_6_places[19][3] = {  // J, K, u_at
    {3830, 3765, 1},
    {3634, 3569, 2},
    {3437, 3372, 3},
    {3241, 3176, 4},
    {3044, 2979, 5},
    {2848, 2783, 6},
    {2651, 2586, 7},
    {2455, 2390, 8},
    {2258, 2193, 9},
    {2062, 1997, 10},
    {1865, 1800, 11},
    {1669, 1604, 12},
    {1472, 1407, 13},
    {1276, 1211, 14},
    {1079, 1014, 15},
    {883, 818, 16},
    {686, 621, 17},
    {490, 425, 18},
    {293, 228, 19},
};
template <class C>
inline constexpr C inward_6_numbers[19][17] = {
    {C(21), C(-3.855), C(43.68), C(3.855), C(-7.75), C(-43.68), C(7.75), C(3), C(128.58525), C(-21.2835), C(-3),
     C(-1.4948), C(6.22075), C(-8.6946), C(132.4015), C(-5.85), C(5.85)},
    {C(20.1), C(-3.69), C(39.795), C(3.69), C(-7.42), C(-39.795), C(7.42), C(2.85), C(111.26625000000001), C(-19.365),
     C(-2.85), C(-1.4312), C(5.9552499999999995), C(-7.9194), C(114.9205), C(-5.55), C(5.55)},
    {C(19.2), C(-3.5250000000000004), C(36.09), C(3.5250000000000004), C(-7.09), C(-36.09), C(7.09), C(2.7),
     C(95.58075000000001), C(-17.5365), C(-2.7), C(-1.3676000000000001), C(5.68975), C(-7.180200000000001),
     C(99.07300000000002), C(-5.25), C(5.25)},
    {C(18.3), C(-3.3600000000000003), C(32.565), C(3.3600000000000003), C(-6.76), C(-32.565), C(6.76), C(2.55),
     C(81.44774999999998), C(-15.797999999999998), C(-2.55), C(-1.304), C(5.42425), C(-6.476999999999999),
     C(84.77799999999999), C(-4.95), C(4.95)},
    {C(17.4), C(-3.1950000000000003), C(29.22), C(3.1950000000000003), C(-6.43), C(-29.22), C(6.43), C(2.4),
     C(68.78625), C(-14.1495), C(-2.4), C(-1.2404000000000002), C(5.15875), C(-5.8098), C(71.9545), C(-4.65),
     C(4.65)},
    {C(16.5), C(-3.0300000000000002), C(26.055), C(3.0300000000000002), C(-6.1), C(-26.055), C(6.1), C(2.25),
     C(57.51525), C(-12.591), C(-2.25), C(-1.1768), C(4.89325), C(-5.1786), C(60.521499999999996), C(-4.35), C(4.35)},
    {C(15.6), C(-2.865), C(23.07), C(2.865), C(-5.77), C(-23.07), C(5.77), C(2.1), C(47.55375), C(-11.1225), C(-2.1),
     C(-1.1132), C(4.62775), C(-4.5834), C(50.398), C(-4.05), C(4.05)},
    {C(14.7), C(-2.7), C(20.265), C(2.7), C(-5.44), C(-20.265), C(5.44), C(1.95), C(38.82075), C(-9.744), C(-1.95),
     C(-1.0496), C(4.3622499999999995), C(-4.0242), C(41.503), C(-3.75), C(3.75)},
    {C(13.8), C(-2.535), C(17.64), C(2.535), C(-5.109999999999999), C(-17.64), C(5.109999999999999), C(1.8),
     C(31.23525), C(-8.4555), C(-1.8), C(-0.986), C(4.09675), C(-3.5010000000000003), C(33.7555), C(-3.45), C(3.45)},
    {C(12.9), C(-2.37), C(15.195), C(2.37), C(-4.78), C(-15.195), C(4.78), C(1.65), C(24.71625), C(-7.257), C(-1.65),
     C(-0.9224000000000001), C(3.8312500000000003), C(-3.0138000000000003), C(27.074499999999997),
     C(-3.1500000000000004), C(3.1500000000000004)},
    {C(12), C(-2.205), C(12.93), C(2.205), C(-4.449999999999999), C(-12.93), C(4.449999999999999), C(1.5),
     C(19.18275), C(-6.148499999999999), C(-1.5), C(-0.8588), C(3.56575), C(-2.5626), C(21.378999999999998),
     C(-2.8499999999999996), C(2.8499999999999996)},
    {C(11.1), C(-2.04), C(10.845), C(2.04), C(-4.12), C(-10.845), C(4.12), C(1.35), C(14.553750000000003), C(-5.13),
     C(-1.35), C(-0.7952), C(3.3002499999999997), C(-2.1474), C(16.588), C(-2.55), C(2.55)},
    {C(10.2), C(-1.875), C(8.94), C(1.875), C(-3.79), C(-8.94), C(3.79), C(1.2), C(10.748249999999999),
     C(-4.201499999999999), C(-1.2), C(-0.7316), C(3.03475), C(-1.7682), C(12.6205), C(-2.25), C(2.25)},
    {C(9.3), C(-1.7100000000000002), C(7.215000000000001), C(1.7100000000000002), C(-3.46), C(-7.215000000000001),
     C(3.46), C(1.05), C(7.685250000000001), C(-3.363), C(-1.05), C(-0.668), C(2.76925), C(-1.4250000000000003),
     C(9.3955), C(-1.95), C(1.95)},
    {C(8.4), C(-1.5450000000000002), C(5.67), C(1.5450000000000002), C(-3.13), C(-5.67), C(3.13), C(0.9), C(5.28375),
     C(-2.6145), C(-0.9), C(-0.6044), C(2.5037499999999997), C(-1.1178000000000001), C(6.832), C(-1.65), C(1.65)},
    {C(7.5), C(-1.3800000000000001), C(4.305), C(1.3800000000000001), C(-2.8), C(-4.305), C(2.8), C(0.75), C(3.46275),
     C(-1.956), C(-0.75), C(-0.5408000000000001), C(2.23825), C(-0.8466), C(4.849), C(-1.35), C(1.35)},
    {C(6.6), C(-1.215), C(3.12), C(1.215), C(-2.4699999999999998), C(-3.12), C(2.4699999999999998), C(0.6),
     C(2.14125), C(-1.3875), C(-0.6), C(-0.4772), C(1.97275), C(-0.6114), C(3.3655), C(-1.05), C(1.05)},
    {C(5.7), C(-1.05), C(2.115), C(1.05), C(-2.14), C(-2.115), C(2.14), C(0.45), C(1.23825), C(-0.909), C(-0.45),
     C(-0.4136), C(1.70725), C(-0.4122), C(2.3005), C(-0.75), C(0.75)},
    {C(4.8), C(-0.885), C(1.29), C(0.885), C(-1.81), C(-1.29), C(1.81), C(0.3), C(0.67275), C(-0.5205), C(-0.3),
     C(-0.35000000000000003), C(1.4417499999999999), C(-0.249), C(1.573), C(-0.45), C(0.45)},
};
inline constexpr unsigned short solved_5_places[10][5] = {  // L, K, s_at, s_at2, ydot_at
    {228, 293, 38, 64, 5},
    {621, 686, 64, 38, 11},
    {1014, 1079, 64, 38, 17},
    {1407, 1472, 64, 38, 23},
    {1800, 1865, 64, 38, 29},
    {2193, 2258, 64, 38, 35},
    {2586, 2651, 64, 38, 41},
    {2979, 3044, 64, 38, 47},
    {3372, 3437, 64, 38, 53},
    {3765, 3830, 64, 38, 59},
};
template <class C>
inline constexpr C solved_5_numbers[10][3] = {
    {C(-0.2), C(-0.3), C(0.3)},
    {C(-0.6), C(-0.2), C(0.6)},
    {C(-0.9), C(-0.2), C(0.9)},
    {C(-1.2), C(-0.2), C(1.2)},
    {C(-1.5), C(-0.2), C(1.5)},
    {C(-1.8), C(-0.2), C(1.8)},
    {C(-2.1), C(-0.2), C(2.1)},
    {C(-2.4), C(-0.2), C(2.4)},
    {C(-2.7), C(-0.2), C(2.7)},
    {C(-3), C(-0.2), C(3)},
};
inline constexpr unsigned short solved_7_places[10][3] = {  // K, L, ydot_at
    {425, 359, 7},
    {818, 752, 13},
    {1211, 1145, 19},
    {1604, 1538, 25},
    {1997, 1931, 31},
    {2390, 2324, 37},
    {2783, 2717, 43},
    {3176, 3110, 49},
    {3569, 3503, 55},
    {3962, 3896, 61},
};
template <class C>
inline constexpr C solved_7_numbers[10][2] = {
    {C(0.75), C(-0.75)},
    {C(1.35), C(-1.35)},
    {C(1.95), C(-1.95)},
    {C(2.55), C(-2.55)},
    {C(3.1500000000000004), C(-3.1500000000000004)},
    {C(3.75), C(-3.75)},
    {C(4.35), C(-4.35)},
    {C(4.95), C(-4.95)},
    {C(5.55), C(-5.55)},
    {C(6.15), C(-6.15)},
};
inline constexpr unsigned short solved_8_places[9][3] = {  // L, K, ydot_at
    {425, 490, 8},
    {818, 883, 14},
    {1211, 1276, 20},
    {1604, 1669, 26},
    {1997, 2062, 32},
    {2390, 2455, 38},
    {2783, 2848, 44},
    {3176, 3241, 50},
    {3569, 3634, 56},
};
template <class C>
inline constexpr C solved_8_numbers[9][1] = {
    {C(0.45)},
    {C(0.75)},
    {C(1.05)},
    {C(1.35)},
    {C(1.65)},
    {C(1.95)},
    {C(2.25)},
    {C(2.55)},
    {C(2.85)},
};
inline constexpr unsigned short solved_9_places[9][3] = {  // L, K, ydot_at
    {490, 555, 9},
    {883, 948, 15},
    {1276, 1341, 21},
    {1669, 1734, 27},
    {2062, 2127, 33},
    {2455, 2520, 39},
    {2848, 2913, 45},
    {3241, 3306, 51},
    {3634, 3699, 57},
};
inline constexpr unsigned short solved_10_places[9][3] = {  // K, L, ydot_at
    {621, 555, 10},
    {1014, 948, 16},
    {1407, 1341, 22},
    {1800, 1734, 28},
    {2193, 2127, 34},
    {2586, 2520, 40},
    {2979, 2913, 46},
    {3372, 3306, 52},
    {3765, 3699, 58},
};
template <class C>
inline constexpr C solved_10_numbers[9][1] = {
    {C(1.05)},
    {C(1.65)},
    {C(2.25)},
    {C(2.8499999999999996)},
    {C(3.45)},
    {C(4.05)},
    {C(4.65)},
    {C(5.25)},
    {C(5.85)},
};
inline constexpr unsigned short solved_11_places[9][3] = {  // L, K, ydot_at
    {686, 752, 12},
    {1079, 1145, 18},
    {1472, 1538, 24},
    {1865, 1931, 30},
    {2258, 2324, 36},
    {2651, 2717, 42},
    {3044, 3110, 48},
    {3437, 3503, 54},
    {3830, 3896, 60},
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
  const T N1_2 = T(0.11000000000000001) * Pddot1_3 + T(0.05500000000000001) * minus_Pddot1_1;
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
  // G2 = -m_all_2 Pddot2 - U2 h_all_2: applied less inertia force, body axes [N]
  const T G2_3 = minus_U2_33 * T(0.72) - (T(3.9) * Pddot1_3 + U2_31 * T(1.48) + U2_32 * T(0.645));
  // N2 = -h_all_2~ Pddot2 - axial(U2 (tr(J_all_2)/2 - J_all_2)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(0.2864) * U2_12 - (T(0.645) * Pddot1_3 + T(0.72) * minus_Pddot2_2 + T(0.14475) * U2_32 + T(0.1218)
      * (minus_U2_22 - minus_U2_33) + T(0.22199999999999998) * U2_31);
  const T N2_2 = T(1.48) * Pddot1_3 - T(0.72) * Pddot2_1 + T(0.2864) * (minus_U2_11 - minus_U2_33) +
      T(0.9572499999999999) * U2_31 - T(0.1218) * U2_12 + T(0.22199999999999998) * U2_32;
  const T N2_3 = T(1.48) * minus_Pddot2_2 + T(0.645) * Pddot2_1 - T(0.8124999999999999) * U2_12 -
      T(0.22199999999999998) * (minus_U2_11 - minus_U2_22);
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
  own[frame::G_3] = G2_3;
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
  // G3 = -U3 h_own_3: applied less inertia force, body axes [N]
  const T minus_G3_1 = U3_12 * T(0.8200000000000001) + U3_13 * T(0.20500000000000002);
  const T G3_2 = minus_U3_22 * T(0.8200000000000001) - U3_23 * T(0.20500000000000002);
  const T G3_3 = minus_U3_33 * T(0.20500000000000002) - U3_32 * T(0.8200000000000001);
  // N3 = -h_own_3~ Pddot3 - axial(U3 (tr(J_own_3)/2 - J_own_3)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(0.20500000000000002) * Pddot3_2 - T(0.8200000000000001) * Pddot3_3 - T(0.441) * U3_32 + T(0.10825)
      * U3_23 - T(0.0742) * (minus_U3_22 - minus_U3_33) - T(0.4335) * U3_31 + T(0.1061) * U3_21;
  const T N3_2 = T(0.1061) * (minus_U3_11 - minus_U3_33) - (T(0.20500000000000002) * Pddot3_1 + T(0.10825) * U3_13 +
      T(0.10825) * U3_31) - T(0.0742) * U3_12 + T(0.4335) * U3_32;
  const T N3_3 = T(0.10825) * U3_21 + T(0.441) * U3_12 - T(0.4335) * (minus_U3_11 - minus_U3_22) - T(0.1061) * U3_23 +
      T(0.0742) * U3_13 + T(0.8200000000000001) * Pddot3_1;
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
  own[frame::G_1] = -minus_G3_1;
  own[frame::G_2] = G3_2;
}

// bodies 4, 7, 10, 13, 16, 19, 22, 25, 28, 31, 34, 37, 40, 43, 46, 49, 52, 55, 58, 61
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

// bodies 5, 8, 11, 14, 17, 20, 23, 26, 29, 32, 35, 38, 41, 44, 47, 50, 53, 56, 59, 62
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
  // GK = -m_all_K PddotK - UK h_all_K: applied less inertia force, body axes [N]
  const T GK_1 = T(k[4]) * PddotK_1 + UK_12 * T(k[5]) + minus_UK_11 * T(k[3]) + UK_13 * T(k[2]);
  const T GK_2 = T(k[4]) * PddotK_2 + UK_21 * T(k[7]) + minus_UK_22 * T(k[6]) + UK_23 * T(k[2]);
  const T GK_3 = T(k[4]) * PddotK_3 + UK_31 * T(k[7]) + UK_32 * T(k[5]) + minus_UK_33 * T(k[8]);
  // NK = -h_all_K~ PddotK - axial(UK (tr(J_all_K)/2 - J_all_K)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T NK_1 = T(k[5]) * PddotK_3 + T(k[8]) * PddotK_2 + T(k[11]) * UK_32 + T(k[10]) * UK_23 + T(k[12]) *
      (minus_UK_22 - minus_UK_33) + T(k[9]) * UK_31 + T(k[13]) * UK_21;
  const T NK_2 = T(k[2]) * PddotK_1 + T(k[3]) * PddotK_3 + T(k[14]) * UK_13 + T(k[15]) * UK_31 + T(k[13]) *
      (minus_UK_11 - minus_UK_33) + T(k[12]) * UK_12 + T(k[16]) * UK_32;
  const T NK_3 = T(k[7]) * PddotK_2 + T(k[6]) * PddotK_1 + T(k[19]) * UK_21 + T(k[18]) * UK_12 + T(k[9]) *
      (minus_UK_11 - minus_UK_22) + T(k[20]) * UK_23 + T(k[17]) * UK_13;
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

// bodies 6, 9, 12, 15, 18, 21, 24, 27, 30, 33, 36, 39, 42, 45, 48, 51, 54, 57, 60, 63
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
  // GK = -UK h_own_K: applied less inertia force, body axes [N]
  const T GK_1 = UK_12 * T(k[3]) + UK_13 * T(k[2]);
  const T GK_2 = UK_23 * T(k[2]) + minus_UK_22 * T(k[4]);
  const T GK_3 = UK_32 * T(k[3]) + minus_UK_33 * T(k[5]);
  // NK = -h_own_K~ PddotK - axial(UK (tr(J_own_K)/2 - J_own_K)): applied less inertia moment about the body origin,
  //   body axes [N m]
  const T NK_1 = T(k[3]) * PddotK_3 + T(k[5]) * PddotK_2 + T(k[10]) * UK_32 + T(k[9]) * UK_23 + T(k[8]) * (minus_UK_22
      - minus_UK_33) + T(k[7]) * UK_31 + T(k[6]) * UK_21;
  const T NK_2 = T(k[2]) * PddotK_1 + T(k[12]) * UK_13 + T(k[12]) * UK_31 + T(k[6]) * (minus_UK_11 - minus_UK_33) +
      T(k[8]) * UK_12 + T(k[11]) * UK_32;
  const T NK_3 = T(k[9]) * UK_21 + T(k[13]) * UK_12 + T(k[7]) * (minus_UK_11 - minus_UK_22) + T(k[14]) * UK_23 +
      T(k[15]) * UK_13 + T(k[4]) * PddotK_1;
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

// body 64
template <class T>
[[gnu::noinline]] void outward_7(const T* y, const T* cosines, const T* sines, T* frames) noexcept {
  const T* const of_63 = frames + 4027;
  const T* const of_62 = frames + 3962;
  T* const own = frames + 4092;
  const T omega63_1 = of_63[frame::omega_1];
  const T omega63_3 = of_63[frame::omega_3];
  const T thetadot64 = y[63];
  const T omega63_2 = of_63[frame::omega_2];
  const T omegadot62_1 = of_62[frame::omegadot_1];
  const T omegadot63_3 = of_63[frame::omegadot_3];
  const T omegadot63_2 = of_63[frame::omegadot_2];
  const T minus_U63_11 = of_63[frame::minus_U_11];
  const T U63_13 = of_63[frame::U_13];
  const T Pddot63_1 = of_63[frame::Pddot_1];
  const T minus_U63_33 = of_63[frame::minus_U_33];
  const T U63_31 = of_63[frame::U_31];
  const T Pddot63_3 = of_63[frame::Pddot_3];
  const T U63_23 = of_63[frame::U_23];
  const T U63_21 = of_63[frame::U_21];
  const T Pddot63_2 = of_63[frame::Pddot_2];
  // E64^T = Z64^T Rot(b64, theta64): E takes components in the lower body to those in the body
  const T t64_1 = cosines[63];
  const T t64_2 = sines[63];
  const T E64_11 = T(0.44721359549995804) * t64_1 - T(0.8944271909999159) * t64_2;
  const T minus_E64_13 = T(0.8944271909999159) * t64_1 + T(0.44721359549995804) * t64_2;
  // omega64 = thetadot64 b64 + E64 omega63: absolute angular velocity, body axes [rad/s]
  const T omega64_1 = E64_11 * omega63_1 - minus_E64_13 * omega63_3;
  const T omega64_2 = thetadot64 + omega63_2;
  const T omega64_3 = E64_11 * omega63_3 + minus_E64_13 * omega63_1;
  // omegadot64 = -thetadot64 b64~ E64 omega63 + E64 omegadot63: angular acceleration, body axes [rad/s^2]
  const T omegadot64_1 = E64_11 * omegadot62_1 - minus_E64_13 * omegadot63_3 - thetadot64 * omega64_3;
  const T omegadot64_3 = thetadot64 * omega64_1 + minus_E64_13 * omegadot62_1 + E64_11 * omegadot63_3;
  // U64 = omega64~ omega64~ + omegadot64~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t64_3 = omega64_3 * omega64_3;
  const T t64_4 = omega64_2 * omega64_2;
  const T minus_U64_11 = t64_3 + t64_4;
  const T t64_5 = omega64_2 * omega64_1;
  const T U64_12 = t64_5 - omegadot64_3;
  const T t64_6 = omega64_3 * omega64_1;
  const T U64_13 = t64_6 + omegadot63_2;
  const T U64_21 = t64_5 + omegadot64_3;
  const T t64_7 = omega64_1 * omega64_1;
  const T minus_U64_22 = t64_3 + t64_7;
  const T t64_8 = omega64_3 * omega64_2;
  const T U64_23 = t64_8 - omegadot64_1;
  const T U64_31 = t64_6 - omegadot63_2;
  const T U64_32 = t64_8 + omegadot64_1;
  const T minus_U64_33 = t64_4 + t64_7;
  // Pddot64 = E64 (U63 q64 + Pddot63): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot64_1 = E64_11 * (Pddot63_1 + U63_13 * T(0.1) - minus_U63_11 * T(0.6)) - minus_E64_13 * (Pddot63_3 +
      U63_31 * T(0.6) - minus_U63_33 * T(0.1));
  const T Pddot64_2 = Pddot63_2 + U63_21 * T(0.6) + U63_23 * T(0.1);
  // G64 = -U64 h_own_64: applied less inertia force, body axes [N]
  const T minus_G64_1 = U64_13 * T(0.8273451516749223);
  const T minus_G64_2 = U64_23 * T(0.8273451516749223);
  const T G64_3 = minus_U64_33 * T(0.8273451516749223);
  // N64 = -h_own_64~ Pddot64 - axial(U64 (tr(J_own_64)/2 - J_own_64)): applied less inertia moment about the body
  //   origin, body axes [N m]
  const T N64_1 = T(0.50616) * U64_32 + T(0.47434000000000004) * U64_23 - T(2.793117232054538) * (minus_U64_22 -
      minus_U64_33) + T(0.04302194788709596) * U64_31 - T(0.045880000000000025) * U64_21 + T(0.8273451516749223) *
      Pddot64_2;
  const T N64_2 = T(0.50616) * U64_31 - (T(0.8273451516749223) * Pddot64_1 + T(0.47434000000000004) * U64_13) -
      T(0.045880000000000025) * (minus_U64_11 - minus_U64_33) - T(2.793117232054538) * U64_12 - T(0.04302194788709596)
      * U64_32;
  const T N64_3 = T(0.04302194788709596) * (minus_U64_11 - minus_U64_22) - (T(0.50616) * U64_21 + T(0.50616) * U64_12)
      + T(0.045880000000000025) * U64_23 + T(2.793117232054538) * U64_13;
  own[frame::N_2] = N64_2;
  own[frame::E_11] = E64_11;
  own[frame::G_3] = G64_3;
  own[frame::N_1] = N64_1;
  own[frame::N_3] = N64_3;
  own[frame::G_1] = -minus_G64_1;
  own[frame::G_2] = -minus_G64_2;
  own[frame::E_13] = -minus_E64_13;
}

// body 64 and what they carry
template <class T>
[[gnu::noinline]] void inward_1(const Inputs<T>& u, T* frames) noexcept {
  T* const own = frames + 4092;
  const T N64_2 = own[frame::N_2];
  const T G64_1 = own[frame::G_1];
  const T N64_1 = own[frame::N_1];
  const T N64_3 = own[frame::N_3];
  const T E64_13 = own[frame::E_13];
  const T E64_11 = own[frame::E_11];
  const T G64_3 = own[frame::G_3];
  // u_64 = b64 . N64 + tau_body_64_: drives it [N m], [N]
  const T u_64 = u.tau_64 + N64_2;
  // v64 = invD64 u_64: u/D
  const T v64 = T(1.0198878123406425) * u_64;
  // gt64 = G64 - v64 B64: force with the turn solved [N]
  const T gt64_1 = G64_1 - v64 * T(0.8273451516749223);
  // nt64 = -tau_body_64_ b64 + P_b64 (N64 - v64 K64): moment with the turn solved [N m]
  const T nt64_1 = N64_1 - v64 * T(0.04302194788709596);
  const T nt64_3 = v64 * T(2.793117232054538) + N64_3;
  // Mp64 = E64^T M64 E64: M passed on, lower body's axes [kg]
  const T minus_b64_1 = E64_13 * T(0.69811320754717);
  const T minus_b64_2 = E64_13 * minus_b64_1;
  const T Mp64_11 = minus_b64_2 - T(0.69811320754717);
  const T minus_Mp64_13 = E64_11 * minus_b64_1;
  // gp64 = E64^T gt64: force passed on, lower body's axes [N]
  const T gp64_1 = E64_11 * gt64_1 - E64_13 * G64_3;
  const T gp64_3 = E64_13 * gt64_1 + E64_11 * G64_3;
  // Hp64 = E64^T H64 E64: H passed on, lower body's axes [kg m]
  const T b64_3 = E64_11 * T(2.356830188679246) - E64_13 * T(0.03630188679245284);
  const T b64_4 = E64_13 * b64_3;
  const T minus_Hp64_11 = T(0.03630188679245284) + b64_4;
  const T minus_Hp64_12 = E64_11 * T(0.8273451516749223);
  const T b64_5 = E64_11 * b64_3;
  const T Hp64_13 = b64_5 - T(2.356830188679246);
  const T minus_Hp64_32 = E64_13 * T(0.8273451516749223);
  // Jp64 = E64^T J64 E64: J passed on, lower body's axes [kg m^2]
  const T b64_6 = T(2) * E64_11 * T(0.1684351698113208) + E64_13 * T(7.922951018867928);
  const T b64_7 = E64_13 * b64_6;
  const T minus_Jp64_11 = T(0.033707698113207535) + b64_7;
  const T Jp64_13 = E64_11 * b64_6 - T(0.1684351698113208);
  const T Jp64_33 = b64_7 - T(7.956658716981136);
  // np64 = E64^T nt64: moment passed on, lower body's axes [N m]
  const T np64_1 = E64_11 * nt64_1 - E64_13 * nt64_3;
  const T np64_3 = E64_13 * nt64_1 + E64_11 * nt64_3;
  // Hb64 = q64~ Mp64 + Hp64: H of the joint at the lower body's origin, its axes
  const T Hb64_21 = T(0.1) * Mp64_11 + T(0.6) * minus_Mp64_13;
  const T Hb64_23 = T(0.6) * minus_b64_2 - T(0.1) * minus_Mp64_13;
  own[frame::v] = v64;
  own[frame::Mp_33] = -minus_b64_2;
  own[frame::Mp_11] = Mp64_11;
  own[frame::Mp_13] = -minus_Mp64_13;
  own[frame::gp_1] = gp64_1;
  own[frame::gp_3] = gp64_3;
  own[frame::Hp_33] = b64_4;
  own[frame::Hp_11] = -minus_Hp64_11;
  own[frame::Hp_12] = -minus_Hp64_12;
  own[frame::Hp_31] = b64_5;
  own[frame::Hp_13] = Hp64_13;
  own[frame::Hp_32] = -minus_Hp64_32;
  own[frame::Jp_11] = -minus_Jp64_11;
  own[frame::Jp_13] = Jp64_13;
  own[frame::Jp_33] = Jp64_33;
  own[frame::np_1] = np64_1;
  own[frame::np_3] = np64_3;
  own[frame::Hb_21] = Hb64_21;
  own[frame::Hb_23] = Hb64_23;
}

// body 63 and what they carry
template <class T>
[[gnu::noinline]] void inward_2(const Inputs<T>& u, T* frames) noexcept {
  const T* const of_64 = frames + 4092;
  T* const own = frames + 4027;
  const T Hp64_12 = of_64[frame::Hp_12];
  const T Hp64_13 = of_64[frame::Hp_13];
  const T Hb64_21 = of_64[frame::Hb_21];
  const T Hp64_31 = of_64[frame::Hp_31];
  const T Jp64_11 = of_64[frame::Jp_11];
  const T Hp64_11 = of_64[frame::Hp_11];
  const T Hp64_32 = of_64[frame::Hp_32];
  const T Jp64_13 = of_64[frame::Jp_13];
  const T Hb64_23 = of_64[frame::Hb_23];
  const T Hp64_33 = of_64[frame::Hp_33];
  const T Jp64_33 = of_64[frame::Jp_33];
  const T gp64_1 = of_64[frame::gp_1];
  const T G63_1 = own[frame::G_1];
  const T G64_2 = of_64[frame::G_2];
  const T G63_2 = own[frame::G_2];
  const T gp64_3 = of_64[frame::gp_3];
  const T G63_3 = own[frame::G_3];
  const T np64_1 = of_64[frame::np_1];
  const T N63_1 = own[frame::N_1];
  const T N63_2 = own[frame::N_2];
  const T np64_3 = of_64[frame::np_3];
  const T N63_3 = own[frame::N_3];
  const T Mp64_11 = of_64[frame::Mp_11];
  const T Mp64_13 = of_64[frame::Mp_13];
  const T Mp64_33 = of_64[frame::Mp_33];
  const T E63_22 = own[frame::E_22];
  const T E63_23 = own[frame::E_23];
  // HA63 = h_own_63~ + Hb64: moment for an acceleration of the origin, body axes [kg m]
  const T HA63_12 = Hp64_12 - T(1.105);
  const T HA63_13 = T(26.620000000000005) + Hp64_13;
  const T HA63_21 = T(1.105) + Hb64_21;
  const T HA63_31 = Hp64_31 - T(26.620000000000005);
  // JA63 = q64~ Hp64^T + J_own_63 + Jp64 - Hb64 q64~: moment for an angular acceleration, body axes [kg m^2]
  const T JA63_11 = T(87.38641000000003) + Jp64_11 - T(0.2) * Hp64_12;
  const T JA63_12 = T(0.1) * Hp64_11 - T(15.643500000000001) - T(0.6) * Hp64_13;
  const T JA63_13 = Jp64_13 - T(0.5681) - T(0.1) * Hp64_32 + T(0.6) * Hp64_12;
  const T JA63_22 = Hb64_21 * T(0.1) - Hb64_23 * T(0.6);
  const T JA63_23 = T(0.1) * Hp64_31 - T(2.6182000000000007) - T(0.6) * Hp64_33;
  const T JA63_33 = T(86.17991000000002) + Jp64_33 + T(1.2) * Hp64_32;
  // g63 = G63 + gp64: force that drives it, home axes [N]
  const T g63_1 = gp64_1 + G63_1;
  const T g63_2 = G64_2 + G63_2;
  const T g63_3 = gp64_3 + G63_3;
  // n63 = q64~ gp64 + N63 + np64: moment that drives it, body axes [N m]
  const T n63_1 = np64_1 + N63_1 - T(0.1) * G64_2;
  const T minus_n63_2 = u.tau_64 - N63_2 - T(0.1) * gp64_1 + T(0.6) * gp64_3;
  const T n63_3 = np64_3 + N63_3 + T(0.6) * G64_2;
  // invD63 = D63^-1: 1/D
  const T invD63 = T(1) / JA63_11;
  // kB63 = invD63 B63: B/D
  const T kB63_1 = invD63 * Hp64_11;
  const T kB63_2 = invD63 * HA63_12;
  const T kB63_3 = invD63 * HA63_13;
  // kK63 = invD63 K63: K/D
  const T kK63_2 = invD63 * JA63_12;
  const T kK63_3 = invD63 * JA63_13;
  // u_63 = b63 . n63 + tau_body_63_: drives it [N m], [N]
  const T u_63 = n63_1 + u.tau_63;
  // v63 = invD63 u_63: u/D
  const T v63 = invD63 * u_63;
  // M63 = Mp64 - kB63 B63^T: MA less what the turn takes up [kg]
  const T M63_11 = Mp64_11 - kB63_1 * Hp64_11;
  const T minus_M63_12 = kB63_1 * HA63_12;
  const T M63_13 = Mp64_13 - kB63_1 * HA63_13;
  const T minus_M63_22 = kB63_2 * HA63_12;
  const T minus_M63_23 = kB63_2 * HA63_13;
  const T M63_33 = Mp64_33 - kB63_3 * HA63_13;
  // H63 = P_b63 (HA63 - kK63 B63^T): HA less what the turn takes up [kg m]
  const T H63_21 = HA63_21 - kK63_2 * Hp64_11;
  const T minus_H63_22 = kK63_2 * HA63_12;
  const T H63_23 = Hb64_23 - kK63_2 * HA63_13;
  const T H63_31 = HA63_31 - kK63_3 * Hp64_11;
  const T H63_32 = Hp64_32 - kK63_3 * HA63_12;
  const T H63_33 = Hp64_33 - kK63_3 * HA63_13;
  // J63 = P_b63 (JA63 - kK63 K63^T) P_b63: JA less what the turn takes up [kg m^2]
  const T J63_22 = JA63_22 - kK63_2 * JA63_12;
  const T J63_23 = JA63_23 - kK63_2 * JA63_13;
  const T J63_33 = JA63_33 - kK63_3 * JA63_13;
  // gt63 = g63 - v63 B63: force with the turn solved [N]
  const T gt63_1 = g63_1 - v63 * Hp64_11;
  const T gt63_2 = g63_2 - v63 * HA63_12;
  const T gt63_3 = g63_3 - v63 * HA63_13;
  // nt63 = -tau_body_63_ b63 + P_b63 (n63 - v63 K63): moment with the turn solved [N m]
  const T minus_nt63_2 = minus_n63_2 + v63 * JA63_12;
  const T nt63_3 = n63_3 - v63 * JA63_13;
  // Mp63 = E63^T M63 E63: M passed on, lower body's axes [kg]
  const T minus_Mp63_12 = E63_23 * M63_13 + E63_22 * minus_M63_12;
  const T Mp63_13 = E63_22 * M63_13 - E63_23 * minus_M63_12;
  const T b63_1 = T(2) * E63_22;
  const T b63_2 = E63_23 * (M63_33 + minus_M63_22) + b63_1 * minus_M63_23;
  const T b63_3 = E63_23 * b63_2;
  const T Mp63_22 = b63_3 - minus_M63_22;
  const T Mp63_23 = minus_M63_23 - E63_22 * b63_2;
  const T Mp63_33 = M63_33 - b63_3;
  // gp63 = E63^T gt63: force passed on, lower body's axes [N]
  const T gp63_2 = E63_22 * gt63_2 - E63_23 * gt63_3;
  const T gp63_3 = E63_23 * gt63_2 + E63_22 * gt63_3;
  // Hp63 = E63^T H63 E63: H passed on, lower body's axes [kg m]
  const T Hp63_21 = E63_22 * H63_21 - E63_23 * H63_31;
  const T b63_4 = E63_22 * (H63_23 + H63_32) - E63_23 * (H63_33 + minus_H63_22);
  const T b63_5 = E63_23 * b63_4;
  const T minus_Hp63_22 = b63_5 + minus_H63_22;
  const T b63_6 = E63_22 * b63_4;
  const T Hp63_23 = b63_6 - H63_32;
  const T Hp63_31 = E63_23 * H63_21 + E63_22 * H63_31;
  const T Hp63_32 = b63_6 - H63_23;
  const T Hp63_33 = b63_5 + H63_33;
  // Jp63 = E63^T J63 E63: J passed on, lower body's axes [kg m^2]
  const T b63_7 = b63_1 * J63_23 + E63_23 * (J63_22 - J63_33);
  const T b63_8 = E63_23 * b63_7;
  const T Jp63_22 = J63_22 - b63_8;
  const T Jp63_23 = E63_22 * b63_7 - J63_23;
  const T Jp63_33 = J63_33 + b63_8;
  // np63 = E63^T nt63: moment passed on, lower body's axes [N m]
  const T minus_np63_2 = E63_22 * minus_nt63_2 + E63_23 * nt63_3;
  const T np63_3 = E63_22 * nt63_3 - E63_23 * minus_nt63_2;
  // Hb63 = q63~ Mp63 + Hp63: H of the joint at the lower body's origin, its axes
  const T b63_9 = T(0.2) * minus_Mp63_12;
  const T b63_10 = T(3.15) * Mp63_13;
  const T Hb63_11 = b63_9 + b63_10;
  const T Hb63_12 = T(3.15) * Mp63_23 - T(0.2) * Mp63_22;
  const T Hb63_13 = T(3.15) * Mp63_33 - T(0.2) * Mp63_23;
  const T Hb63_21 = Hp63_21 + T(0.2) * M63_11;
  const T minus_Hb63_22 = minus_Hp63_22 + b63_9;
  const T Hb63_23 = Hp63_23 + T(0.2) * Mp63_13;
  const T Hb63_31 = Hp63_31 - T(3.15) * M63_11;
  const T Hb63_32 = Hp63_32 + T(3.15) * minus_Mp63_12;
  const T Hb63_33 = Hp63_33 - b63_10;
  own[frame::v] = v63;
  own[frame::Mp_33] = Mp63_33;
  own[frame::Mp_13] = Mp63_13;
  own[frame::gp_3] = gp63_3;
  own[frame::Hp_33] = Hp63_33;
  own[frame::Hp_31] = Hp63_31;
  own[frame::Hp_32] = Hp63_32;
  own[frame::Jp_33] = Jp63_33;
  own[frame::np_3] = np63_3;
  own[frame::Hb_21] = Hb63_21;
  own[frame::Hb_23] = Hb63_23;
  own[frame::kB_1] = kB63_1;
  own[frame::kB_2] = kB63_2;
  own[frame::kB_3] = kB63_3;
  own[frame::kK_2] = kK63_2;
  own[frame::kK_3] = kK63_3;
  own[frame::M_11] = M63_11;
  own[frame::gt_1] = gt63_1;
  own[frame::minus_Mp_12] = minus_Mp63_12;
  own[frame::Mp_22] = Mp63_22;
  own[frame::Mp_23] = Mp63_23;
  own[frame::gp_2] = gp63_2;
  own[frame::Hp_21] = Hp63_21;
  own[frame::minus_Hp_22] = minus_Hp63_22;
  own[frame::Hp_23] = Hp63_23;
  own[frame::Jp_22] = Jp63_22;
  own[frame::Jp_23] = Jp63_23;
  own[frame::np_2] = -minus_np63_2;
  own[frame::Hb_11] = Hb63_11;
  own[frame::Hb_12] = Hb63_12;
  own[frame::Hb_13] = Hb63_13;
  own[frame::minus_Hb_22] = minus_Hb63_22;
  own[frame::Hb_31] = Hb63_31;
  own[frame::Hb_32] = Hb63_32;
  own[frame::Hb_33] = Hb63_33;
}

// body 62 and what they carry
template <class T>
[[gnu::noinline]] void inward_3(const Inputs<T>& u, T* frames) noexcept {
  const T* const of_63 = frames + 4027;
  T* const own = frames + 3962;
  const T M63_11 = of_63[frame::M_11];
  const T Mp63_22 = of_63[frame::Mp_22];
  const T Mp63_33 = of_63[frame::Mp_33];
  const T Hb63_12 = of_63[frame::Hb_12];
  const T Hb63_13 = of_63[frame::Hb_13];
  const T Hb63_21 = of_63[frame::Hb_21];
  const T Hb63_23 = of_63[frame::Hb_23];
  const T Hb63_31 = of_63[frame::Hb_31];
  const T Hb63_32 = of_63[frame::Hb_32];
  const T Hb63_11 = of_63[frame::Hb_11];
  const T Hp63_23 = of_63[frame::Hp_23];
  const T minus_Hp63_22 = of_63[frame::minus_Hp_22];
  const T Hp63_32 = of_63[frame::Hp_32];
  const T Hp63_33 = of_63[frame::Hp_33];
  const T Hp63_21 = of_63[frame::Hp_21];
  const T Jp63_22 = of_63[frame::Jp_22];
  const T Hp63_31 = of_63[frame::Hp_31];
  const T Jp63_23 = of_63[frame::Jp_23];
  const T Jp63_33 = of_63[frame::Jp_33];
  const T gt63_1 = of_63[frame::gt_1];
  const T G62_1 = own[frame::G_1];
  const T gp63_2 = of_63[frame::gp_2];
  const T G62_2 = own[frame::G_2];
  const T gp63_3 = of_63[frame::gp_3];
  const T G62_3 = own[frame::G_3];
  const T N62_1 = own[frame::N_1];
  const T np63_2 = of_63[frame::np_2];
  const T N62_2 = own[frame::N_2];
  const T np63_3 = of_63[frame::np_3];
  const T N62_3 = own[frame::N_3];
  const T Hb63_33 = of_63[frame::Hb_33];
  const T minus_Mp63_12 = of_63[frame::minus_Mp_12];
  const T Mp63_13 = of_63[frame::Mp_13];
  const T Mp63_23 = of_63[frame::Mp_23];
  const T minus_Hb63_22 = of_63[frame::minus_Hb_22];
  const T E62_11 = own[frame::E_11];
  const T E62_12 = own[frame::E_12];
  // MA62 = m_all_62 one + Mp63: force for an acceleration of the origin, home axes [kg]
  const T MA62_11 = T(21.9) + M63_11;
  const T MA62_22 = T(21.9) + Mp63_22;
  const T MA62_33 = T(21.9) + Mp63_33;
  // HA62 = h_all_62~ + Hb63: moment for an acceleration of the origin, body axes [kg m]
  const T HA62_12 = Hb63_12 - T(4.0200000000000005);
  const T HA62_13 = T(47.745) + Hb63_13;
  const T HA62_21 = T(4.0200000000000005) + Hb63_21;
  const T HA62_23 = Hb63_23 - T(8.08);
  const T HA62_31 = Hb63_31 - T(47.745);
  const T HA62_32 = T(8.08) + Hb63_32;
  // JA62 = q63~ Hp63^T + J_all_62 + Jp63 - Hb63 q63~: moment for an angular acceleration, body axes [kg m^2]
  const T JA62_11 = T(147.61875) + Hb63_13 * T(3.15) - Hb63_12 * T(0.2);
  const T JA62_12 = T(0.2) * minus_Hp63_22 - T(23.291999999999998) + T(3.15) * Hp63_23 + Hb63_11 * T(0.2);
  const T JA62_13 = T(3.15) * Hp63_33 - T(1.5584) - T(0.2) * Hp63_32 - Hb63_11 * T(3.15);
  const T JA62_22 = T(6.48625) + Jp63_22 + T(0.2) * Hp63_21 + Hb63_21 * T(0.2);
  const T JA62_23 = Jp63_23 - T(9.5058) + T(0.2) * Hp63_31 - Hb63_21 * T(3.15);
  const T JA62_33 = T(151.59699999999998) + Jp63_33 - T(3.15) * Hp63_31 - Hb63_31 * T(3.15);
  // g62 = G62 + gp63: force that drives it, home axes [N]
  const T g62_1 = gt63_1 + G62_1;
  const T g62_2 = gp63_2 + G62_2;
  const T g62_3 = gp63_3 + G62_3;
  // n62 = q63~ gp63 + N62 + np63: moment that drives it, body axes [N m]
  const T minus_n62_1 = u.tau_63 - N62_1 - T(3.15) * gp63_3 + T(0.2) * gp63_2;
  const T n62_2 = np63_2 + N62_2 + T(0.2) * gt63_1;
  const T n62_3 = np63_3 + N62_3 - T(3.15) * gt63_1;
  // invD62 = D62^-1: 1/D
  const T invD62 = T(1) / JA62_33;
  // kB62 = invD62 B62: B/D
  const T kB62_1 = invD62 * HA62_31;
  const T kB62_2 = invD62 * HA62_32;
  const T kB62_3 = invD62 * Hb63_33;
  // kK62 = invD62 K62: K/D
  const T kK62_1 = invD62 * JA62_13;
  const T kK62_2 = invD62 * JA62_23;
  // u_62 = b62 . n62 + tau_body_62_: drives it [N m], [N]
  const T u_62 = n62_3 + u.tau_62;
  // v62 = invD62 u_62: u/D
  const T v62 = invD62 * u_62;
  // M62 = MA62 - kB62 B62^T: MA less what the turn takes up [kg]
  const T M62_11 = MA62_11 - kB62_1 * HA62_31;
  const T minus_M62_12 = minus_Mp63_12 + kB62_1 * HA62_32;
  const T M62_13 = Mp63_13 - kB62_1 * Hb63_33;
  const T M62_22 = MA62_22 - kB62_2 * HA62_32;
  const T M62_23 = Mp63_23 - kB62_2 * Hb63_33;
  const T M62_33 = MA62_33 - kB62_3 * Hb63_33;
  // H62 = P_b62 (HA62 - kK62 B62^T): HA less what the turn takes up [kg m]
  const T H62_11 = Hb63_11 - kK62_1 * HA62_31;
  const T H62_12 = HA62_12 - kK62_1 * HA62_32;
  const T H62_13 = HA62_13 - kK62_1 * Hb63_33;
  const T H62_21 = HA62_21 - kK62_2 * HA62_31;
  const T minus_H62_22 = minus_Hb63_22 + kK62_2 * HA62_32;
  const T H62_23 = HA62_23 - kK62_2 * Hb63_33;
  // J62 = P_b62 (JA62 - kK62 K62^T) P_b62: JA less what the turn takes up [kg m^2]
  const T J62_11 = JA62_11 - kK62_1 * JA62_13;
  const T J62_12 = JA62_12 - kK62_1 * JA62_23;
  const T J62_22 = JA62_22 - kK62_2 * JA62_23;
  // gt62 = g62 - v62 B62: force with the turn solved [N]
  const T gt62_1 = g62_1 - v62 * HA62_31;
  const T gt62_2 = g62_2 - v62 * HA62_32;
  const T gt62_3 = g62_3 - v62 * Hb63_33;
  // nt62 = -tau_body_62_ b62 + P_b62 (n62 - v62 K62): moment with the turn solved [N m]
  const T minus_nt62_1 = minus_n62_1 + v62 * JA62_13;
  const T nt62_2 = n62_2 - v62 * JA62_23;
  // Mp62 = E62^T M62 E62: M passed on, lower body's axes [kg]
  const T b62_1 = T(2) * E62_11;
  const T b62_2 = b62_1 * minus_M62_12 - E62_12 * (M62_11 - M62_22);
  const T b62_3 = E62_12 * b62_2;
  const T Mp62_11 = M62_11 + b62_3;
  const T Mp62_12 = minus_M62_12 - E62_11 * b62_2;
  const T Mp62_13 = E62_11 * M62_13 - E62_12 * M62_23;
  const T Mp62_22 = M62_22 - b62_3;
  const T Mp62_23 = E62_12 * M62_13 + E62_11 * M62_23;
  // gp62 = E62^T gt62: force passed on, lower body's axes [N]
  const T gp62_1 = E62_11 * gt62_1 - E62_12 * gt62_2;
  const T gp62_2 = E62_12 * gt62_1 + E62_11 * gt62_2;
  // Hp62 = E62^T H62 E62: H passed on, lower body's axes [kg m]
  const T b62_4 = E62_12 * (H62_11 + minus_H62_22) + E62_11 * (H62_12 + H62_21);
  const T b62_5 = E62_12 * b62_4;
  const T Hp62_11 = H62_11 - b62_5;
  const T b62_6 = E62_11 * b62_4;
  const T Hp62_12 = b62_6 - H62_21;
  const T Hp62_13 = E62_11 * H62_13 - E62_12 * H62_23;
  const T Hp62_21 = b62_6 - H62_12;
  const T Hp62_22 = b62_5 - minus_H62_22;
  const T Hp62_23 = E62_12 * H62_13 + E62_11 * H62_23;
  // Jp62 = E62^T J62 E62: J passed on, lower body's axes [kg m^2]
  const T b62_7 = E62_12 * (J62_11 - J62_22) + b62_1 * J62_12;
  const T b62_8 = E62_12 * b62_7;
  const T Jp62_11 = J62_11 - b62_8;
  const T Jp62_12 = E62_11 * b62_7 - J62_12;
  const T Jp62_22 = J62_22 + b62_8;
  // np62 = E62^T nt62: moment passed on, lower body's axes [N m]
  const T minus_np62_1 = E62_11 * minus_nt62_1 + E62_12 * nt62_2;
  const T np62_2 = E62_11 * nt62_2 - E62_12 * minus_nt62_1;
  // Hb62 = q62~ Mp62 + Hp62: H of the joint at the lower body's origin, its axes
  const T minus_b62_9 = T(6.15) * Mp62_13;
  const T Hb62_11 = Hp62_11 + minus_b62_9;
  const T Hb62_12 = Hp62_12 + T(6.15) * Mp62_23;
  const T Hb62_13 = Hp62_13 + T(6.15) * M62_33;
  const T Hb62_21 = Hp62_21 - T(0.3) * Mp62_13;
  const T b62_10 = T(0.3) * Mp62_23;
  const T Hb62_22 = Hp62_22 - b62_10;
  const T Hb62_23 = Hp62_23 - T(0.3) * M62_33;
  const T Hb62_31 = T(0.3) * Mp62_12 - T(6.15) * Mp62_11;
  const T Hb62_32 = T(0.3) * Mp62_22 - T(6.15) * Mp62_12;
  const T Hb62_33 = b62_10 - minus_b62_9;
  own[frame::v] = v62;
  own[frame::Mp_11] = Mp62_11;
  own[frame::Mp_13] = Mp62_13;
  own[frame::gp_1] = gp62_1;
  own[frame::Hp_13] = Hp62_13;
  own[frame::Jp_11] = Jp62_11;
  own[frame::np_1] = -minus_np62_1;
  own[frame::Hb_21] = Hb62_21;
  own[frame::Hb_23] = Hb62_23;
  own[frame::kB_1] = kB62_1;
  own[frame::kB_2] = kB62_2;
  own[frame::kB_3] = kB62_3;
  own[frame::kK_2] = kK62_2;
  own[frame::Mp_22] = Mp62_22;
  own[frame::Mp_23] = Mp62_23;
  own[frame::gp_2] = gp62_2;
  own[frame::Hp_23] = Hp62_23;
  own[frame::Jp_22] = Jp62_22;
  own[frame::np_2] = np62_2;
  own[frame::Hb_11] = Hb62_11;
  own[frame::Hb_12] = Hb62_12;
  own[frame::Hb_13] = Hb62_13;
  own[frame::Hb_31] = Hb62_31;
  own[frame::Hb_32] = Hb62_32;
  own[frame::Hb_33] = Hb62_33;
  own[frame::kK_1] = kK62_1;
  own[frame::M_33] = M62_33;
  own[frame::gt_3] = gt62_3;
  own[frame::Mp_12] = Mp62_12;
  own[frame::Jp_12] = Jp62_12;
  own[frame::Hb_22] = Hb62_22;
}

// bodies 61, 58, 55, 52, 49, 46, 43, 40, 37, 34, 31, 28, 25, 22, 19, 16, 13, 10, 7, 4 and what they carry
template <class T>
[[gnu::noinline]] void inward_4(const T* inputs, T* frames, int row) noexcept {
  const auto& [J, K, u_at] = inward_4_places[row];
  const auto& k = inward_4_numbers<Number<T>>[row];
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
  const T tau_K = inputs[u_at + 20];
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
  own[frame::Mp_33] = MpK_33;
  own[frame::Mp_11] = MpK_11;
  own[frame::Mp_13] = MpK_13;
  own[frame::gp_1] = gpK_1;
  own[frame::gp_3] = gpK_3;
  own[frame::Hp_33] = HpK_33;
  own[frame::Hp_12] = HpK_12;
  own[frame::Hp_31] = HpK_31;
  own[frame::Hp_32] = HpK_32;
  own[frame::Jp_11] = JpK_11;
  own[frame::Jp_13] = JpK_13;
  own[frame::Jp_33] = JpK_33;
  own[frame::np_1] = npK_1;
  own[frame::np_3] = npK_3;
  own[frame::Hb_21] = HbK_21;
  own[frame::Hb_23] = HbK_23;
  own[frame::kB_1] = kBK_1;
  own[frame::kB_2] = kBK_2;
  own[frame::kB_3] = kBK_3;
  own[frame::kK_3] = kKK_3;
  own[frame::Mp_23] = MpK_23;
  own[frame::Hb_11] = HbK_11;
  own[frame::Hb_12] = HbK_12;
  own[frame::Hb_13] = HbK_13;
  own[frame::Hb_31] = HbK_31;
  own[frame::Hb_32] = HbK_32;
  own[frame::Hb_33] = HbK_33;
  own[frame::kK_1] = kKK_1;
  own[frame::Mp_12] = MpK_12;
  own[frame::Hb_22] = HbK_22;
  own[frame::M_22] = MK_22;
  own[frame::gt_2] = gtK_2;
}

// bodies 60, 57, 54, 51, 48, 45, 42, 39, 36, 33, 30, 27, 24, 21, 18, 15, 12, 9, 6 and what they carry
template <class T>
[[gnu::noinline]] void inward_5(const T* inputs, T* frames, int row) noexcept {
  const auto& [J, K, u_at] = inward_5_places[row];
  const auto& k = inward_5_numbers<Number<T>>[row];
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T HbJ_12 = of_J[frame::Hb_12];
  const T HbJ_13 = of_J[frame::Hb_13];
  const T HbJ_21 = of_J[frame::Hb_21];
  const T HbJ_31 = of_J[frame::Hb_31];
  const T HpJ_12 = of_J[frame::Hp_12];
  const T JpJ_11 = of_J[frame::Jp_11];
  const T HbJ_11 = of_J[frame::Hb_11];
  const T HpJ_32 = of_J[frame::Hp_32];
  const T JpJ_13 = of_J[frame::Jp_13];
  const T HbJ_23 = of_J[frame::Hb_23];
  const T HbJ_22 = of_J[frame::Hb_22];
  const T HpJ_33 = of_J[frame::Hp_33];
  const T HpJ_31 = of_J[frame::Hp_31];
  const T HbJ_32 = of_J[frame::Hb_32];
  const T JpJ_33 = of_J[frame::Jp_33];
  const T gpJ_1 = of_J[frame::gp_1];
  const T GK_1 = own[frame::G_1];
  const T gtJ_2 = of_J[frame::gt_2];
  const T GK_2 = own[frame::G_2];
  const T gpJ_3 = of_J[frame::gp_3];
  const T GK_3 = own[frame::G_3];
  const T npJ_1 = of_J[frame::np_1];
  const T NK_1 = own[frame::N_1];
  const T tau_J = inputs[u_at];
  const T NK_2 = own[frame::N_2];
  const T npJ_3 = of_J[frame::np_3];
  const T NK_3 = own[frame::N_3];
  const T tau_K = inputs[u_at + 20];
  const T MpJ_11 = of_J[frame::Mp_11];
  const T MpJ_12 = of_J[frame::Mp_12];
  const T MpJ_13 = of_J[frame::Mp_13];
  const T MJ_22 = of_J[frame::M_22];
  const T MpJ_23 = of_J[frame::Mp_23];
  const T MpJ_33 = of_J[frame::Mp_33];
  const T HbJ_33 = of_J[frame::Hb_33];
  const T EK_22 = own[frame::E_22];
  const T EK_23 = own[frame::E_23];
  // HAK = h_own_K~ + HbJ: moment for an acceleration of the origin, body axes [kg m]
  const T HAK_12 = HbJ_12 + T(k[0]);
  const T HAK_13 = T(k[1]) + HbJ_13;
  const T HAK_21 = T(k[2]) + HbJ_21;
  const T HAK_31 = HbJ_31 + T(k[3]);
  // JAK = qJ~ HpJ^T + J_own_K + JpJ - HbJ qJ~: moment for an angular acceleration, body axes [kg m^2]
  const T JAK_11 = T(k[4]) + JpJ_11 - T(0.1) * HpJ_12 - HbJ_12 * T(0.1);
  const T JAK_12 = T(k[5]) - HbJ_13 * T(0.6) + HbJ_11 * T(0.1);
  const T JAK_13 = JpJ_13 + T(k[6]) - T(0.1) * HpJ_32 + HbJ_12 * T(0.6);
  const T JAK_22 = HbJ_21 * T(0.1) - HbJ_23 * T(0.6);
  const T JAK_23 = T(0.1) * HpJ_31 + T(k[7]) - T(0.6) * HpJ_33 + HbJ_22 * T(0.6);
  const T JAK_33 = T(k[8]) + JpJ_33 + T(0.6) * HpJ_32 + HbJ_32 * T(0.6);
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
  // MK = MpJ - kBK BK^T: MA less what the turn takes up [kg]
  const T MK_11 = MpJ_11 - kBK_1 * HbJ_11;
  const T MK_12 = MpJ_12 - kBK_1 * HAK_12;
  const T MK_13 = MpJ_13 - kBK_1 * HAK_13;
  const T MK_22 = MJ_22 - kBK_2 * HAK_12;
  const T MK_23 = MpJ_23 - kBK_2 * HAK_13;
  const T MK_33 = MpJ_33 - kBK_3 * HAK_13;
  // HK = P_bK (HAK - kKK BK^T): HA less what the turn takes up [kg m]
  const T HK_21 = HAK_21 - kKK_2 * HbJ_11;
  const T HK_22 = HbJ_22 - kKK_2 * HAK_12;
  const T HK_23 = HbJ_23 - kKK_2 * HAK_13;
  const T HK_31 = HAK_31 - kKK_3 * HbJ_11;
  const T HK_32 = HbJ_32 - kKK_3 * HAK_12;
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
  const T bK_7 = bK_1 * JK_23 + EK_23 * (JK_22 - JK_33);
  const T bK_8 = EK_23 * bK_7;
  const T JpK_22 = JK_22 - bK_8;
  const T JpK_23 = EK_22 * bK_7 - JK_23;
  const T JpK_33 = JK_33 + bK_8;
  // npK = EK^T ntK: moment passed on, lower body's axes [N m]
  const T minus_npK_2 = EK_22 * minus_ntK_2 + EK_23 * ntK_3;
  const T npK_3 = EK_22 * ntK_3 - EK_23 * minus_ntK_2;
  // HbK = qK~ MpK + HpK: H of the joint at the lower body's origin, its axes
  const T bK_9 = T(k[9]) * MpK_13;
  const T minus_bK_10 = T(0.2) * MpK_12;
  const T HbK_11 = bK_9 - minus_bK_10;
  const T HbK_12 = T(k[9]) * MpK_23 - T(0.2) * MpK_22;
  const T HbK_13 = T(k[9]) * MpK_33 - T(0.2) * MpK_23;
  const T HbK_21 = HpK_21 + T(0.2) * MK_11;
  const T HbK_22 = HpK_22 + minus_bK_10;
  const T HbK_23 = HpK_23 + T(0.2) * MpK_13;
  const T HbK_31 = HpK_31 + T(k[10]) * MK_11;
  const T HbK_32 = HpK_32 + T(k[10]) * MpK_12;
  const T HbK_33 = HpK_33 - bK_9;
  own[frame::v] = vK;
  own[frame::Mp_33] = MpK_33;
  own[frame::Mp_13] = MpK_13;
  own[frame::gp_3] = gpK_3;
  own[frame::Hp_33] = HpK_33;
  own[frame::Hp_31] = HpK_31;
  own[frame::Hp_32] = HpK_32;
  own[frame::Jp_33] = JpK_33;
  own[frame::np_3] = npK_3;
  own[frame::Hb_21] = HbK_21;
  own[frame::Hb_23] = HbK_23;
  own[frame::kB_1] = kBK_1;
  own[frame::kB_2] = kBK_2;
  own[frame::kB_3] = kBK_3;
  own[frame::kK_2] = kKK_2;
  own[frame::kK_3] = kKK_3;
  own[frame::M_11] = MK_11;
  own[frame::gt_1] = gtK_1;
  own[frame::Mp_22] = MpK_22;
  own[frame::Mp_23] = MpK_23;
  own[frame::gp_2] = gpK_2;
  own[frame::Hp_21] = HpK_21;
  own[frame::Hp_23] = HpK_23;
  own[frame::Jp_22] = JpK_22;
  own[frame::Jp_23] = JpK_23;
  own[frame::np_2] = -minus_npK_2;
  own[frame::Hb_11] = HbK_11;
  own[frame::Hb_12] = HbK_12;
  own[frame::Hb_13] = HbK_13;
  own[frame::Hb_31] = HbK_31;
  own[frame::Hb_32] = HbK_32;
  own[frame::Hb_33] = HbK_33;
  own[frame::Mp_12] = MpK_12;
  own[frame::Hb_22] = HbK_22;
  own[frame::Hp_22] = HpK_22;
}

// bodies 59, 56, 53, 50, 47, 44, 41, 38, 35, 32, 29, 26, 23, 20, 17, 14, 11, 8, 5 and what they carry
template <class T>
[[gnu::noinline]] void inward_6(const T* inputs, T* frames, int row) noexcept {
  const auto& [J, K, u_at] = inward_6_places[row];
  const auto& k = inward_6_numbers<Number<T>>[row];
  const T* const of_J = frames + J;
  T* const own = frames + K;
  const T MJ_11 = of_J[frame::M_11];
  const T MpJ_22 = of_J[frame::Mp_22];
  const T MpJ_33 = of_J[frame::Mp_33];
  const T HbJ_12 = of_J[frame::Hb_12];
  const T HbJ_13 = of_J[frame::Hb_13];
  const T HbJ_21 = of_J[frame::Hb_21];
  const T HbJ_23 = of_J[frame::Hb_23];
  const T HbJ_31 = of_J[frame::Hb_31];
  const T HbJ_32 = of_J[frame::Hb_32];
  const T HbJ_11 = of_J[frame::Hb_11];
  const T HpJ_22 = of_J[frame::Hp_22];
  const T HpJ_23 = of_J[frame::Hp_23];
  const T HpJ_32 = of_J[frame::Hp_32];
  const T HpJ_33 = of_J[frame::Hp_33];
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
  const T tau_J = inputs[u_at + 39];
  const T NK_1 = own[frame::N_1];
  const T npJ_2 = of_J[frame::np_2];
  const T NK_2 = own[frame::N_2];
  const T npJ_3 = of_J[frame::np_3];
  const T NK_3 = own[frame::N_3];
  const T HbJ_33 = of_J[frame::Hb_33];
  const T tau_K = inputs[u_at];
  const T MpJ_12 = of_J[frame::Mp_12];
  const T MpJ_13 = of_J[frame::Mp_13];
  const T MpJ_23 = of_J[frame::Mp_23];
  const T HbJ_22 = of_J[frame::Hb_22];
  const T EK_12 = own[frame::E_12];
  const T EK_11 = own[frame::E_11];
  // MAK = m_all_K one + MpJ: force for an acceleration of the origin, home axes [kg]
  const T MAK_11 = T(k[0]) + MJ_11;
  const T MAK_22 = T(k[0]) + MpJ_22;
  const T MAK_33 = T(k[0]) + MpJ_33;
  // HAK = h_all_K~ + HbJ: moment for an acceleration of the origin, body axes [kg m]
  const T HAK_12 = HbJ_12 + T(k[1]);
  const T HAK_13 = T(k[2]) + HbJ_13;
  const T HAK_21 = T(k[3]) + HbJ_21;
  const T HAK_23 = HbJ_23 + T(k[4]);
  const T HAK_31 = HbJ_31 + T(k[5]);
  const T HAK_32 = T(k[6]) + HbJ_32;
  // JAK = qJ~ HpJ^T + J_all_K + JpJ - HbJ qJ~: moment for an angular acceleration, body axes [kg m^2]
  const T JAK_11 = T(k[8]) + HbJ_13 * T(k[7]) - HbJ_12 * T(0.2);
  const T JAK_12 = T(k[7]) * HpJ_23 + T(k[9]) - T(0.2) * HpJ_22 + HbJ_11 * T(0.2);
  const T JAK_13 = T(k[7]) * HpJ_33 + T(k[11]) - T(0.2) * HpJ_32 + HbJ_11 * T(k[10]);
  const T JAK_22 = T(k[12]) + JpJ_22 + T(0.2) * HpJ_21 + HbJ_21 * T(0.2);
  const T JAK_23 = JpJ_23 + T(k[13]) + T(0.2) * HpJ_31 + HbJ_21 * T(k[10]);
  const T JAK_33 = T(k[14]) + JpJ_33 + T(k[10]) * HpJ_31 + HbJ_31 * T(k[10]);
  // gK = GK + gpJ: force that drives it, home axes [N]
  const T gK_1 = gtJ_1 + GK_1;
  const T gK_2 = gpJ_2 + GK_2;
  const T gK_3 = gpJ_3 + GK_3;
  // nK = qJ~ gpJ + NK + npJ: moment that drives it, body axes [N m]
  const T minus_nK_1 = tau_J - NK_1 + T(k[10]) * gpJ_3 + T(0.2) * gpJ_2;
  const T nK_2 = npJ_2 + NK_2 + T(0.2) * gtJ_1;
  const T nK_3 = npJ_3 + NK_3 + T(k[10]) * gtJ_1;
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
  // MK = MAK - kBK BK^T: MA less what the turn takes up [kg]
  const T MK_11 = MAK_11 - kBK_1 * HAK_31;
  const T MK_12 = MpJ_12 - kBK_1 * HAK_32;
  const T MK_13 = MpJ_13 - kBK_1 * HbJ_33;
  const T MK_22 = MAK_22 - kBK_2 * HAK_32;
  const T MK_23 = MpJ_23 - kBK_2 * HbJ_33;
  const T MK_33 = MAK_33 - kBK_3 * HbJ_33;
  // HK = P_bK (HAK - kKK BK^T): HA less what the turn takes up [kg m]
  const T HK_11 = HbJ_11 - kKK_1 * HAK_31;
  const T HK_12 = HAK_12 - kKK_1 * HAK_32;
  const T HK_13 = HAK_13 - kKK_1 * HbJ_33;
  const T HK_21 = HAK_21 - kKK_2 * HAK_31;
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
  const T bK_7 = EK_12 * (JK_11 - JK_22) + bK_1 * JK_12;
  const T bK_8 = EK_12 * bK_7;
  const T JpK_11 = JK_11 - bK_8;
  const T JpK_12 = EK_11 * bK_7 - JK_12;
  const T JpK_22 = JK_22 + bK_8;
  // npK = EK^T ntK: moment passed on, lower body's axes [N m]
  const T minus_npK_1 = EK_11 * minus_ntK_1 + EK_12 * ntK_2;
  const T npK_2 = EK_11 * ntK_2 - EK_12 * minus_ntK_1;
  // HbK = qK~ MpK + HpK: H of the joint at the lower body's origin, its axes
  const T bK_9 = T(k[15]) * MpK_13;
  const T HbK_11 = HpK_11 - bK_9;
  const T HbK_12 = HpK_12 + T(k[16]) * MpK_23;
  const T HbK_13 = HpK_13 + T(k[16]) * MK_33;
  const T HbK_21 = HpK_21 - T(0.3) * MpK_13;
  const T bK_10 = T(0.3) * MpK_23;
  const T HbK_22 = HpK_22 - bK_10;
  const T HbK_23 = HpK_23 - T(0.3) * MK_33;
  const T HbK_31 = T(0.3) * MpK_12 + T(k[15]) * MpK_11;
  const T HbK_32 = T(0.3) * MpK_22 + T(k[15]) * MpK_12;
  const T HbK_33 = bK_10 + bK_9;
  own[frame::v] = vK;
  own[frame::Mp_11] = MpK_11;
  own[frame::Mp_13] = MpK_13;
  own[frame::gp_1] = gpK_1;
  own[frame::Hp_13] = HpK_13;
  own[frame::Jp_11] = JpK_11;
  own[frame::np_1] = -minus_npK_1;
  own[frame::Hb_21] = HbK_21;
  own[frame::Hb_23] = HbK_23;
  own[frame::kB_1] = kBK_1;
  own[frame::kB_2] = kBK_2;
  own[frame::kB_3] = kBK_3;
  own[frame::kK_2] = kKK_2;
  own[frame::Mp_22] = MpK_22;
  own[frame::Mp_23] = MpK_23;
  own[frame::gp_2] = gpK_2;
  own[frame::Hp_23] = HpK_23;
  own[frame::Jp_22] = JpK_22;
  own[frame::np_2] = npK_2;
  own[frame::Hb_11] = HbK_11;
  own[frame::Hb_12] = HbK_12;
  own[frame::Hb_13] = HbK_13;
  own[frame::Hb_31] = HbK_31;
  own[frame::Hb_32] = HbK_32;
  own[frame::Hb_33] = HbK_33;
  own[frame::kK_1] = kKK_1;
  own[frame::M_33] = MK_33;
  own[frame::gt_3] = gtK_3;
  own[frame::Mp_12] = MpK_12;
  own[frame::Jp_12] = JpK_12;
  own[frame::Hb_22] = HbK_22;
}

// body 3 and what they carry
template <class T>
[[gnu::noinline]] void inward_7(const Inputs<T>& u, T* frames) noexcept {
  const T* const of_4 = frames + 162;
  T* const own = frames + 97;
  const T Hb4_12 = of_4[frame::Hb_12];
  const T Hb4_13 = of_4[frame::Hb_13];
  const T Hb4_21 = of_4[frame::Hb_21];
  const T Hb4_31 = of_4[frame::Hb_31];
  const T Hp4_12 = of_4[frame::Hp_12];
  const T Jp4_11 = of_4[frame::Jp_11];
  const T Hb4_11 = of_4[frame::Hb_11];
  const T Hp4_32 = of_4[frame::Hp_32];
  const T Jp4_13 = of_4[frame::Jp_13];
  const T Hb4_23 = of_4[frame::Hb_23];
  const T Hb4_22 = of_4[frame::Hb_22];
  const T Hp4_33 = of_4[frame::Hp_33];
  const T Hp4_31 = of_4[frame::Hp_31];
  const T Hb4_32 = of_4[frame::Hb_32];
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
  const T Mp4_11 = of_4[frame::Mp_11];
  const T Mp4_12 = of_4[frame::Mp_12];
  const T Mp4_13 = of_4[frame::Mp_13];
  const T M4_22 = of_4[frame::M_22];
  const T Mp4_23 = of_4[frame::Mp_23];
  const T Mp4_33 = of_4[frame::Mp_33];
  const T Hb4_33 = of_4[frame::Hb_33];
  const T E3_22 = own[frame::E_22];
  const T E3_23 = own[frame::E_23];
  // HA3 = h_own_3~ + Hb4: moment for an acceleration of the origin, body axes [kg m]
  const T HA3_12 = Hb4_12 - T(0.20500000000000002);
  const T HA3_13 = T(0.8200000000000001) + Hb4_13;
  const T HA3_21 = T(0.20500000000000002) + Hb4_21;
  const T HA3_31 = Hb4_31 - T(0.8200000000000001);
  // JA3 = q4~ Hp4^T + J_own_3 + Jp4 - Hb4 q4~: moment for an angular acceleration, body axes [kg m^2]
  const T JA3_11 = T(0.54925) + Jp4_11 - T(0.1) * Hp4_12 - Hb4_12 * T(0.1);
  const T JA3_12 = Hb4_11 * T(0.1) - (T(0.4335) + Hb4_13 * T(0.6));
  const T JA3_13 = Jp4_13 - T(0.1061) - T(0.1) * Hp4_32 + Hb4_12 * T(0.6);
  const T JA3_22 = Hb4_21 * T(0.1) - Hb4_23 * T(0.6);
  const T JA3_23 = T(0.1) * Hp4_31 - T(0.0742) - T(0.6) * Hp4_33 + Hb4_22 * T(0.6);
  const T JA3_33 = T(0.33275) + Jp4_33 + T(0.6) * Hp4_32 + Hb4_32 * T(0.6);
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
  // M3 = Mp4 - kB3 B3^T: MA less what the turn takes up [kg]
  const T M3_11 = Mp4_11 - kB3_1 * Hb4_11;
  const T M3_12 = Mp4_12 - kB3_1 * HA3_12;
  const T M3_13 = Mp4_13 - kB3_1 * HA3_13;
  const T M3_22 = M4_22 - kB3_2 * HA3_12;
  const T M3_23 = Mp4_23 - kB3_2 * HA3_13;
  const T M3_33 = Mp4_33 - kB3_3 * HA3_13;
  // H3 = P_b3 (HA3 - kK3 B3^T): HA less what the turn takes up [kg m]
  const T H3_21 = HA3_21 - kK3_2 * Hb4_11;
  const T H3_22 = Hb4_22 - kK3_2 * HA3_12;
  const T H3_23 = Hb4_23 - kK3_2 * HA3_13;
  const T H3_31 = HA3_31 - kK3_3 * Hb4_11;
  const T H3_32 = Hb4_32 - kK3_3 * HA3_12;
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
  const T b3_7 = b3_1 * J3_23 + E3_23 * (J3_22 - J3_33);
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
  own[frame::Mp_33] = Mp3_33;
  own[frame::gp_3] = gp3_3;
  own[frame::Hp_33] = Hp3_33;
  own[frame::Hp_31] = Hp3_31;
  own[frame::Hp_32] = Hp3_32;
  own[frame::Jp_33] = Jp3_33;
  own[frame::np_3] = np3_3;
  own[frame::Hb_21] = Hb3_21;
  own[frame::Hb_23] = Hb3_23;
  own[frame::kB_1] = kB3_1;
  own[frame::kB_2] = kB3_2;
  own[frame::kB_3] = kB3_3;
  own[frame::kK_2] = kK3_2;
  own[frame::kK_3] = kK3_3;
  own[frame::gt_1] = gt3_1;
  own[frame::gp_2] = gp3_2;
  own[frame::Hp_21] = Hp3_21;
  own[frame::Hp_23] = Hp3_23;
  own[frame::Jp_22] = Jp3_22;
  own[frame::Jp_23] = Jp3_23;
  own[frame::np_2] = -minus_np3_2;
  own[frame::Hb_11] = Hb3_11;
  own[frame::Hb_12] = Hb3_12;
  own[frame::Hb_13] = Hb3_13;
  own[frame::Hb_31] = Hb3_31;
  own[frame::Hb_33] = Hb3_33;
  own[frame::Hp_22] = Hp3_22;
}

// body 2 and what they carry
template <class T>
[[gnu::noinline]] void inward_8(const Inputs<T>& u, T* frames) noexcept {
  const T* const of_3 = frames + 97;
  T* const own = frames + 32;
  const T Mp3_33 = of_3[frame::Mp_33];
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
  const T E2_11 = own[frame::E_11];
  const T E2_12 = own[frame::E_12];
  // MA2 = m_all_2 one + Mp3: force for an acceleration of the origin, home axes [kg]
  const T MA2_33 = T(3.9) + Mp3_33;
  // HA2 = h_all_2~ + Hb3: moment for an acceleration of the origin, body axes [kg m]
  const T HA2_13 = T(0.645) + Hb3_13;
  const T HA2_23 = Hb3_23 - T(1.48);
  // JA2 = q3~ Hp3^T + J_all_2 + Jp3 - Hb3 q3~: moment for an angular acceleration, body axes [kg m^2]
  const T JA2_11 = T(0.36375) + Hb3_13 * T(0.15) - Hb3_12 * T(0.2);
  const T JA2_12 = T(0.15) * Hp3_23 - T(0.22199999999999998) - T(0.2) * Hp3_22 + Hb3_11 * T(0.2);
  const T JA2_13 = T(0.15) * Hp3_33 - T(0.2864) - T(0.2) * Hp3_32 - Hb3_11 * T(0.15);
  const T JA2_22 = T(1.17625) + Jp3_22 + T(0.2) * Hp3_21 + Hb3_21 * T(0.2);
  const T JA2_23 = Jp3_23 - T(0.1218) + T(0.2) * Hp3_31 - Hb3_21 * T(0.15);
  const T JA2_33 = T(1.1019999999999999) + Jp3_33 - T(0.15) * Hp3_31 - Hb3_31 * T(0.15);
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
  const T minus_nt2_1 = minus_n2_1 + v2 * JA2_13;
  const T nt2_2 = n2_2 - v2 * JA2_23;
  // Hp2 = E2^T H2 E2: H passed on, lower body's axes [kg m]
  const T Hp2_23 = E2_12 * H2_13 + E2_11 * H2_23;
  // Jp2 = E2^T J2 E2: J passed on, lower body's axes [kg m^2]
  const T Jp2_22 = J2_22 + E2_12 * (E2_12 * (J2_11 - J2_22) + T(2) * E2_11 * J2_12);
  // np2 = E2^T nt2: moment passed on, lower body's axes [N m]
  const T np2_2 = E2_11 * nt2_2 - E2_12 * minus_nt2_1;
  // Hb2 = q2~ Mp2 + Hp2: H of the joint at the lower body's origin, its axes
  const T Hb2_23 = Hp2_23 - T(0.3) * M2_33;
  own[frame::v] = v2;
  own[frame::Hb_23] = Hb2_23;
  own[frame::kB_3] = kB2_3;
  own[frame::kK_2] = kK2_2;
  own[frame::Hp_23] = Hp2_23;
  own[frame::Jp_22] = Jp2_22;
  own[frame::np_2] = np2_2;
  own[frame::kK_1] = kK2_1;
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

// bodies 6, 12, 18, 24, 30, 36, 42, 48, 54, 60, solved
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

// bodies 8, 14, 20, 26, 32, 38, 44, 50, 56, 62, solved
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

// bodies 9, 15, 21, 27, 33, 39, 45, 51, 57, solved
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

// bodies 10, 16, 22, 28, 34, 40, 46, 52, 58, solved
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

// bodies 11, 17, 23, 29, 35, 41, 47, 53, 59, solved
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

// bodies 13, 19, 25, 31, 37, 43, 49, 55, 61, solved
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

// body 63, solved
template <class T>
[[gnu::noinline]] void solved_12(T* ydot, T* frames) noexcept {
  const T* const of_62 = frames + 3962;
  T* const own = frames + 4027;
  const T minus_phi62 = of_62[frame::minus_phi];
  const T alphaL62_2 = of_62[frame::alphaL_2];
  const T beta62_1 = of_62[frame::beta_1];
  const T E63_23 = own[frame::E_23];
  const T beta62_3 = of_62[frame::beta_3];
  const T E63_22 = own[frame::E_22];
  const T beta62_2 = of_62[frame::beta_2];
  const T alphaL62_1 = of_62[frame::alphaL_1];
  const T kK63_3 = own[frame::kK_3];
  const T kB63_3 = own[frame::kB_3];
  const T kB63_1 = own[frame::kB_1];
  const T kB63_2 = own[frame::kB_2];
  const T v63 = own[frame::v];
  const T kK63_2 = own[frame::kK_2];
  // beta63 = -E63 q63~ alpha62 + E63 beta62: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta63_1 = beta62_1 + T(0.2) * alphaL62_2 + T(3.15) * minus_phi62;
  const T z63_1 = T(0.2) * alphaL62_1;
  const T z63_2 = T(3.15) * alphaL62_1;
  const T beta63_2 = E63_22 * beta62_2 - (E63_22 * z63_1 - E63_23 * z63_2) + E63_23 * beta62_3;
  const T beta63_3 = E63_23 * z63_1 - (E63_23 * beta62_2 - E63_22 * beta62_3) + E63_22 * z63_2;
  // alphaL63 = E63 alpha62: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL63_2 = E63_22 * alphaL62_2 - E63_23 * minus_phi62;
  const T minus_alphaL63_3 = E63_22 * minus_phi62 + E63_23 * alphaL62_2;
  // phi63 = -kB63 . beta63 + v63 - (P_b63 kK63) . alphaL63
  const T phi63 = kK63_3 * minus_alphaL63_3 - (kB63_1 * beta63_1 - (v63 - kB63_2 * beta63_2) + kB63_3 * beta63_3) -
      kK63_2 * alphaL63_2;
  // thetaddot63 = -b63 . alphaL63 + phi63
  const T thetaddot63 = phi63 - alphaL62_1;
  ydot[62] = thetaddot63;
  own[frame::beta_3] = beta63_3;
  own[frame::alphaL_2] = alphaL63_2;
  own[frame::beta_1] = beta63_1;
  own[frame::minus_alphaL_3] = minus_alphaL63_3;
  own[frame::phi] = phi63;
}

// body 64, solved
template <class T>
[[gnu::noinline]] void solved_13(T* ydot, T* frames) noexcept {
  const T* const of_63 = frames + 4027;
  T* const own = frames + 4092;
  const T alphaL63_2 = of_63[frame::alphaL_2];
  const T E64_13 = own[frame::E_13];
  const T E64_11 = own[frame::E_11];
  const T beta63_1 = of_63[frame::beta_1];
  const T beta63_3 = of_63[frame::beta_3];
  const T phi63 = of_63[frame::phi];
  const T minus_alphaL63_3 = of_63[frame::minus_alphaL_3];
  const T v64 = own[frame::v];
  // beta64 = -E64 q64~ alpha63 + E64 beta63: acceleration of the origin beyond that at ydot = 0 [m/s^2]
  const T beta64_1 = E64_11 * beta63_1 + E64_13 * beta63_3 + T(0.1) * alphaL63_2 * E64_11 - T(0.6) * alphaL63_2 *
      E64_13;
  // alphaL64 = E64 alpha63: angular acceleration of the lower body beyond that at ydot = 0, body axes
  const T alphaL64_1 = E64_11 * phi63 - E64_13 * minus_alphaL63_3;
  const T minus_alphaL64_3 = E64_13 * phi63 + E64_11 * minus_alphaL63_3;
  // phi64 = -kB64 . beta64 + v64 - (P_b64 kK64) . alphaL64
  const T phi64 = v64 - T(0.8437992367923736) * beta64_1 - T(0.043877560313203424) * alphaL64_1 -
      T(2.8486662234110534) * minus_alphaL64_3;
  // thetaddot64 = -b64 . alphaL64 + phi64
  const T thetaddot64 = phi64 - alphaL63_2;
  ydot[63] = thetaddot64;
}

}  // namespace accelerations_sections

template <class T>
void accelerations([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const Inputs<T>& u, T* ydot)
    noexcept {
  using namespace accelerations_sections;
  [[maybe_unused]] T frames[4150];
  const T inputs[] = {u.tau_62, u.tau_59, u.tau_56, u.tau_53, u.tau_50, u.tau_47, u.tau_44, u.tau_41, u.tau_38,
      u.tau_35, u.tau_32, u.tau_29, u.tau_26, u.tau_23, u.tau_20, u.tau_17, u.tau_14, u.tau_11, u.tau_8, u.tau_5,
      u.tau_61, u.tau_58, u.tau_55, u.tau_52, u.tau_49, u.tau_46, u.tau_43, u.tau_40, u.tau_37, u.tau_34, u.tau_31,
      u.tau_28, u.tau_25, u.tau_22, u.tau_19, u.tau_16, u.tau_13, u.tau_10, u.tau_7, u.tau_4, u.tau_60, u.tau_57,
      u.tau_54, u.tau_51, u.tau_48, u.tau_45, u.tau_42, u.tau_39, u.tau_36, u.tau_33, u.tau_30, u.tau_27, u.tau_24,
      u.tau_21, u.tau_18, u.tau_15, u.tau_12, u.tau_9, u.tau_6};
  T cosines[64], sines[64];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 64, cosines, sines);
  // kind of section, and row of its tables
  static constexpr unsigned char steps[][2] = {
      {0,0}, {1,0}, {2,0}, {3,0}, {4,0}, {5,0}, {3,1}, {4,1}, {5,1}, {3,2}, {4,2}, {5,2}, {3,3}, {4,3}, {5,3}, {3,4},
      {4,4}, {5,4}, {3,5}, {4,5}, {5,5}, {3,6}, {4,6}, {5,6}, {3,7}, {4,7}, {5,7}, {3,8}, {4,8}, {5,8}, {3,9}, {4,9},
      {5,9}, {3,10}, {4,10}, {5,10}, {3,11}, {4,11}, {5,11}, {3,12}, {4,12}, {5,12}, {3,13}, {4,13}, {5,13}, {3,14},
      {4,14}, {5,14}, {3,15}, {4,15}, {5,15}, {3,16}, {4,16}, {5,16}, {3,17}, {4,17}, {5,17}, {3,18}, {4,18}, {5,18},
      {3,19}, {4,19}, {5,19}, {6,0}, {7,0}, {8,0}, {9,0}, {10,0}, {11,0}, {12,0}, {10,1}, {11,1}, {12,1}, {10,2},
      {11,2}, {12,2}, {10,3}, {11,3}, {12,3}, {10,4}, {11,4}, {12,4}, {10,5}, {11,5}, {12,5}, {10,6}, {11,6}, {12,6},
      {10,7}, {11,7}, {12,7}, {10,8}, {11,8}, {12,8}, {10,9}, {11,9}, {12,9}, {10,10}, {11,10}, {12,10}, {10,11},
      {11,11}, {12,11}, {10,12}, {11,12}, {12,12}, {10,13}, {11,13}, {12,13}, {10,14}, {11,14}, {12,14}, {10,15},
      {11,15}, {12,15}, {10,16}, {11,16}, {12,16}, {10,17}, {11,17}, {12,17}, {10,18}, {11,18}, {12,18}, {10,19},
      {13,0}, {14,0}, {15,0}, {16,0}, {17,0}, {18,0}, {19,0}, {20,0}, {21,0}, {22,0}, {23,0}, {24,0}, {25,0}, {20,1},
      {26,0}, {22,1}, {23,1}, {24,1}, {25,1}, {20,2}, {26,1}, {22,2}, {23,2}, {24,2}, {25,2}, {20,3}, {26,2}, {22,3},
      {23,3}, {24,3}, {25,3}, {20,4}, {26,3}, {22,4}, {23,4}, {24,4}, {25,4}, {20,5}, {26,4}, {22,5}, {23,5}, {24,5},
      {25,5}, {20,6}, {26,5}, {22,6}, {23,6}, {24,6}, {25,6}, {20,7}, {26,6}, {22,7}, {23,7}, {24,7}, {25,7}, {20,8},
      {26,7}, {22,8}, {23,8}, {24,8}, {25,8}, {20,9}, {26,8}, {22,9}, {27,0}, {28,0}};
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
      case 28: solved_13(ydot, frames); break;
    }
  }
}

// residual: r = A ydot - f.
// r (ny) [N m], [N]
// 3878 add, 3947 multiply, 128 sine or cosine
template <class T>
void residual([[maybe_unused]] const Prepared<T>& c, const T* x, const T* y, const T* ydot, const Inputs<T>& u, T* r)
    noexcept {
  T cosines[64], sines[64];  // of angles, at their places in x
  using kanec_cos_sin::cos_sin;
  cos_sin(x, 64, cosines, sines);

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
  const T N1_2 = T(41.577999999999996) * thetaddot1 - T(81.38) * Pddot1_3 - T(54.175000000000004) * minus_Pddot1_1;

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
  const T G2_3 = U2_31 * T(161.68) + U2_32 * T(40.695);
  // N2 = h_own_2~ Pddot2 + axial(U2 (tr(J_own_2)/2 - J_own_2)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N2_1 = T(40.695) * Pddot2_3 + T(6.1522499999999996) * U2_32 + T(6.1522499999999996) * U2_23 + T(8.1318) *
      (minus_U2_22 - minus_U2_33) + T(24.252) * U2_31 - T(32.3264) * U2_21;
  const T N2_2 = T(32.3264) * (minus_U2_33 - minus_U2_11) - (T(6.1522499999999996) * U2_13 + T(99.74725) * U2_31) +
      T(8.1318) * U2_12 - T(24.252) * U2_32 - T(161.68) * Pddot2_3;
  const T N2_3 = T(161.68) * Pddot2_2 + T(40.695) * minus_Pddot2_1 + T(99.74725) * U2_21 - T(6.1522499999999996) *
      U2_12 + T(24.252) * (minus_U2_11 - minus_U2_22) + T(32.3264) * U2_23 - T(8.1318) * U2_13;

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
  const T G3_1 = U3_12 * T(120.97) + U3_13 * T(26.905);
  const T G3_2 = U3_23 * T(26.905) - minus_U3_22 * T(120.97);
  const T G3_3 = U3_32 * T(120.97) - minus_U3_33 * T(26.905);
  // N3 = h_own_3~ Pddot3 + axial(U3 (tr(J_own_3)/2 - J_own_3)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N3_1 = T(120.97) * Pddot3_3 - T(26.905) * Pddot3_2 + T(78.5385) * U3_32 - T(2.7782500000000003) * U3_23 +
      T(12.089200000000002) * (minus_U3_22 - minus_U3_33) + T(72.5235) * U3_31 - T(16.1261) * U3_21;
  const T N3_2 = T(26.905) * Pddot3_1 + T(2.7782500000000003) * U3_13 + T(2.7782500000000003) * U3_31 + T(16.1261) *
      (minus_U3_33 - minus_U3_11) + T(12.089200000000002) * U3_12 - T(72.5235) * U3_32;
  const T N3_3 = T(72.5235) * (minus_U3_11 - minus_U3_22) - (T(2.7782500000000003) * U3_21 + T(78.5385) * U3_12) +
      T(16.1261) * U3_23 - T(12.089200000000002) * U3_13 - T(120.97) * Pddot3_1;

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
  const T G4_1 = U4_13 * T(53.395) - minus_U4_11 * T(80.24);
  const T G4_2 = U4_21 * T(80.24) + U4_23 * T(53.395);
  const T G4_3 = U4_31 * T(80.24) - minus_U4_33 * T(53.395);
  // N4 = h_own_4~ Pddot4 + axial(U4 (tr(J_own_4)/2 - J_own_4)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N4_1 = T(24.029850000000003) * (minus_U4_22 - minus_U4_33) - (T(24.113999999999997) * U4_32 + T(34.86025) *
      U4_23) + T(36.094) * U4_31 - T(16.0003) * U4_21 - T(53.395) * Pddot4_2;
  const T N4_2 = T(53.395) * Pddot4_1 - T(80.24) * Pddot4_3 + T(34.86025) * U4_13 - T(24.113999999999997) * U4_31 +
      T(16.0003) * (minus_U4_33 - minus_U4_11) + T(24.029850000000003) * U4_12 - T(36.094) * U4_32;
  const T N4_3 = T(80.24) * Pddot4_2 + T(24.113999999999997) * U4_21 + T(24.113999999999997) * U4_12 + T(36.094) *
      (minus_U4_11 - minus_U4_22) + T(16.0003) * U4_23 - T(24.029850000000003) * U4_13;

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
  const T G5_1 = U5_12 * T(79.95) - minus_U5_11 * T(159.13);
  const T G5_2 = U5_21 * T(159.13) - minus_U5_22 * T(79.95);
  const T G5_3 = U5_31 * T(159.13) + U5_32 * T(79.95);
  // N5 = h_own_5~ Pddot5 + axial(U5 (tr(J_own_5)/2 - J_own_5)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N5_1 = T(79.95) * Pddot5_3 + T(24) * U5_32 + T(24) * U5_23 + T(15.981) * (minus_U5_22 - minus_U5_33) +
      T(47.716499999999996) * U5_31 - T(31.814) * U5_21;
  const T N5_2 = T(31.814) * (minus_U5_33 - minus_U5_11) - (T(24) * U5_13 + T(98.18499999999999) * U5_31) + T(15.981)
      * U5_12 - T(47.716499999999996) * U5_32 - T(159.13) * Pddot5_3;
  const T N5_3 = T(159.13) * Pddot5_2 - T(79.95) * Pddot5_1 + T(98.18499999999999) * U5_21 - T(24) * U5_12 +
      T(47.716499999999996) * (minus_U5_11 - minus_U5_22) + T(31.814) * U5_23 - T(15.981) * U5_13;

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
  const T G6_1 = U6_12 * T(197.905) + U6_13 * T(26.470000000000002);
  const T G6_2 = U6_23 * T(26.470000000000002) - minus_U6_22 * T(197.905);
  const T G6_3 = U6_32 * T(197.905) - minus_U6_33 * T(26.470000000000002);
  // N6 = h_own_6~ Pddot6 + axial(U6 (tr(J_own_6)/2 - J_own_6)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N6_1 = T(197.905) * Pddot6_3 - T(26.470000000000002) * Pddot6_2 + T(171.86475) * U6_32 -
      T(2.7550000000000003) * U6_23 + T(19.780900000000003) * (minus_U6_22 - minus_U6_33) + T(118.67099999999999) *
      U6_31 - T(15.8612) * U6_21;
  const T N6_2 = T(26.470000000000002) * Pddot6_1 + T(2.7550000000000003) * U6_13 + T(2.7550000000000003) * U6_31 +
      T(15.8612) * (minus_U6_33 - minus_U6_11) + T(19.780900000000003) * U6_12 - T(118.67099999999999) * U6_32;
  const T N6_3 = T(118.67099999999999) * (minus_U6_11 - minus_U6_22) - (T(2.7550000000000003) * U6_21 + T(171.86475) *
      U6_12) + T(15.8612) * U6_23 - T(19.780900000000003) * U6_13 - T(197.905) * Pddot6_1;

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
  const T G7_1 = U7_13 * T(52.435) - minus_U7_11 * T(78.83);
  const T G7_2 = U7_21 * T(78.83) + U7_23 * T(52.435);
  const T G7_3 = U7_31 * T(78.83) - minus_U7_33 * T(52.435);
  // N7 = h_own_7~ Pddot7 + axial(U7 (tr(J_own_7)/2 - J_own_7)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N7_1 = T(39.316050000000004) * (minus_U7_22 - minus_U7_33) - (T(23.7) * U7_32 + T(63.56275) * U7_23) +
      T(59.08) * U7_31 - T(15.708400000000001) * U7_21 - T(52.435) * Pddot7_2;
  const T N7_2 = T(52.435) * Pddot7_1 - T(78.83) * Pddot7_3 + T(63.56275) * U7_13 - T(23.7) * U7_31 +
      T(15.708400000000001) * (minus_U7_33 - minus_U7_11) + T(39.316050000000004) * U7_12 - T(59.08) * U7_32;
  const T N7_3 = T(78.83) * Pddot7_2 + T(23.7) * U7_21 + T(23.7) * U7_12 + T(59.08) * (minus_U7_11 - minus_U7_22) +
      T(15.708400000000001) * U7_23 - T(39.316050000000004) * U7_13;

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
  const T G8_1 = U8_12 * T(117.54) - minus_U8_11 * T(156.04);
  const T G8_2 = U8_21 * T(156.04) - minus_U8_22 * T(117.54);
  const T G8_3 = U8_31 * T(156.04) + U8_32 * T(117.54);
  // N8 = h_own_8~ Pddot8 + axial(U8 (tr(J_own_8)/2 - J_own_8)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N8_1 = T(117.54) * Pddot8_3 + T(52.857) * U8_32 + T(52.857) * U8_23 + T(23.497200000000003) * (minus_U8_22 -
      minus_U8_33) + T(70.164) * U8_31 - T(31.1936) * U8_21;
  const T N8_2 = T(31.1936) * (minus_U8_33 - minus_U8_11) - (T(52.857) * U8_13 + T(96.28975) * U8_31) +
      T(23.497200000000003) * U8_12 - T(70.164) * U8_32 - T(156.04) * Pddot8_3;
  const T N8_3 = T(156.04) * Pddot8_2 - T(117.54) * Pddot8_1 + T(96.28975) * U8_21 - T(52.857) * U8_12 + T(70.164) *
      (minus_U8_11 - minus_U8_22) + T(31.1936) * U8_23 - T(23.497200000000003) * U8_13;

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
  const T G9_1 = U9_12 * T(271.105) + U9_13 * T(25.945);
  const T G9_2 = U9_23 * T(25.945) - minus_U9_22 * T(271.105);
  const T G9_3 = U9_32 * T(271.105) - minus_U9_33 * T(25.945);
  // N9 = h_own_9~ Pddot9 + axial(U9 (tr(J_own_9)/2 - J_own_9)): inertia less applied moment about the body origin,
  //   body axes [N m]
  const T N9_1 = T(271.105) * Pddot9_3 - T(25.945) * Pddot9_2 + T(307.16925000000003) * U9_32 - T(2.7227500000000004)
      * U9_23 + T(27.099100000000004) * (minus_U9_22 - minus_U9_33) + T(162.57750000000001) * U9_31 -
      T(15.542300000000001) * U9_21;
  const T N9_2 = T(25.945) * Pddot9_1 + T(2.7227500000000004) * U9_13 + T(2.7227500000000004) * U9_31 +
      T(15.542300000000001) * (minus_U9_33 - minus_U9_11) + T(27.099100000000004) * U9_12 - T(162.57750000000001) *
      U9_32;
  const T N9_3 = T(162.57750000000001) * (minus_U9_11 - minus_U9_22) - (T(2.7227500000000004) * U9_21 +
      T(307.16925000000003) * U9_12) + T(15.542300000000001) * U9_23 - T(27.099100000000004) * U9_13 - T(271.105) *
      Pddot9_1;

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
  const T G10_1 = U10_13 * T(51.295) - minus_U10_11 * T(77.14999999999999);
  const T G10_2 = U10_21 * T(77.14999999999999) + U10_23 * T(51.295);
  const T G10_3 = U10_31 * T(77.14999999999999) - minus_U10_33 * T(51.295);
  // N10 = h_own_10~ Pddot10 + axial(U10 (tr(J_own_10)/2 - J_own_10)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N10_1 = T(53.832750000000004) * (minus_U10_22 - minus_U10_33) - (T(23.205) * U10_32 + T(102.24624999999999)
      * U10_23) + T(80.9275) * U10_31 - T(15.3625) * U10_21 - T(51.295) * Pddot10_2;
  const T N10_2 = T(51.295) * Pddot10_1 - T(77.14999999999999) * Pddot10_3 + T(102.24624999999999) * U10_13 -
      T(23.205) * U10_31 + T(15.3625) * (minus_U10_33 - minus_U10_11) + T(53.832750000000004) * U10_12 - T(80.9275) *
      U10_32;
  const T N10_3 = T(77.14999999999999) * Pddot10_2 + T(23.205) * U10_21 + T(23.205) * U10_12 + T(80.9275) *
      (minus_U10_11 - minus_U10_22) + T(15.3625) * U10_23 - T(53.832750000000004) * U10_13;

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
  const T G11_1 = U11_12 * T(153.06) - minus_U11_11 * T(152.41);
  const T G11_2 = U11_21 * T(152.41) - minus_U11_22 * T(153.06);
  const T G11_3 = U11_31 * T(152.41) + U11_32 * T(153.06);
  // N11 = h_own_11~ Pddot11 + axial(U11 (tr(J_own_11)/2 - J_own_11)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N11_1 = T(153.06) * Pddot11_3 + T(91.731) * U11_32 + T(91.731) * U11_23 + T(30.5994) * (minus_U11_22 -
      minus_U11_33) + T(91.35149999999999) * U11_31 - T(30.4652) * U11_21;
  const T N11_2 = T(30.4652) * (minus_U11_33 - minus_U11_11) - (T(91.731) * U11_13 + T(94.0615) * U11_31) + T(30.5994)
      * U11_12 - T(91.35149999999999) * U11_32 - T(152.41) * Pddot11_3;
  const T N11_3 = T(152.41) * Pddot11_2 - T(153.06) * Pddot11_1 + T(94.0615) * U11_21 - T(91.731) * U11_12 +
      T(91.35149999999999) * (minus_U11_11 - minus_U11_22) + T(30.4652) * U11_23 - T(30.5994) * U11_13;

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
  const T G12_1 = U12_12 * T(339.76) + U12_13 * T(25.330000000000002);
  const T G12_2 = U12_23 * T(25.330000000000002) - minus_U12_22 * T(339.76);
  const T G12_3 = U12_32 * T(339.76) - minus_U12_33 * T(25.330000000000002);
  // N12 = h_own_12~ Pddot12 + axial(U12 (tr(J_own_12)/2 - J_own_12)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N12_1 = T(339.76) * Pddot12_3 - T(25.330000000000002) * Pddot12_2 + T(479.9565) * U12_32 - T(2.6815) *
      U12_23 + T(33.9628) * (minus_U12_22 - minus_U12_33) + T(203.75699999999998) * U12_31 - T(15.1694) * U12_21;
  const T N12_2 = T(25.330000000000002) * Pddot12_1 + T(2.6815) * U12_13 + T(2.6815) * U12_31 + T(15.1694) *
      (minus_U12_33 - minus_U12_11) + T(33.9628) * U12_12 - T(203.75699999999998) * U12_32;
  const T N12_3 = T(203.75699999999998) * (minus_U12_11 - minus_U12_22) - (T(2.6815) * U12_21 + T(479.9565) * U12_12)
      + T(15.1694) * U12_23 - T(33.9628) * U12_13 - T(339.76) * Pddot12_1;

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
  const T G13_1 = U13_13 * T(49.975) - minus_U13_11 * T(75.2);
  const T G13_2 = U13_21 * T(75.2) + U13_23 * T(49.975);
  const T G13_3 = U13_31 * T(75.2) - minus_U13_33 * T(49.975);
  // N13 = h_own_13~ Pddot13 + axial(U13 (tr(J_own_13)/2 - J_own_13)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N13_1 = T(67.41795) * (minus_U13_22 - minus_U13_33) - (T(22.628999999999998) * U13_32 + T(149.6755) *
      U13_23) + T(101.39349999999999) * U13_31 - T(14.9626) * U13_21 - T(49.975) * Pddot13_2;
  const T N13_2 = T(49.975) * Pddot13_1 - T(75.2) * Pddot13_3 + T(149.6755) * U13_13 - T(22.628999999999998) * U13_31
      + T(14.9626) * (minus_U13_33 - minus_U13_11) + T(67.41795) * U13_12 - T(101.39349999999999) * U13_32;
  const T N13_3 = T(75.2) * Pddot13_2 + T(22.628999999999998) * U13_21 + T(22.628999999999998) * U13_12 +
      T(101.39349999999999) * (minus_U13_11 - minus_U13_22) + T(14.9626) * U13_23 - T(67.41795) * U13_13;

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
  const T G14_1 = U14_12 * T(186.105) - minus_U14_11 * T(148.23999999999998);
  const T G14_2 = U14_21 * T(148.23999999999998) - minus_U14_22 * T(186.105);
  const T G14_3 = U14_31 * T(148.23999999999998) + U14_32 * T(186.105);
  // N14 = h_own_14~ Pddot14 + axial(U14 (tr(J_own_14)/2 - J_own_14)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N14_1 = T(186.105) * Pddot14_3 + T(139.38675) * U14_32 + T(139.38675) * U14_23 + T(37.2066) * (minus_U14_22
      - minus_U14_33) + T(111.036) * U14_31 - T(29.628800000000002) * U14_21;
  const T N14_2 = T(29.628800000000002) * (minus_U14_33 - minus_U14_11) - (T(139.38675) * U14_13 + T(91.50025) *
      U14_31) + T(37.2066) * U14_12 - T(111.036) * U14_32 - T(148.23999999999998) * Pddot14_3;
  const T N14_3 = T(148.23999999999998) * Pddot14_2 - T(186.105) * Pddot14_1 + T(91.50025) * U14_21 - T(139.38675) *
      U14_12 + T(111.036) * (minus_U14_11 - minus_U14_22) + T(29.628800000000002) * U14_23 - T(37.2066) * U14_13;

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
  const T G15_1 = U15_12 * T(403.06) + U15_13 * T(24.625);
  const T G15_2 = U15_23 * T(24.625) - minus_U15_22 * T(403.06);
  const T G15_3 = U15_32 * T(403.06) - minus_U15_33 * T(24.625);
  // N15 = h_own_15~ Pddot15 + axial(U15 (tr(J_own_15)/2 - J_own_15)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N15_1 = T(403.06) * Pddot15_3 - T(24.625) * Pddot15_2 + T(684.759) * U15_32 - T(2.63125) * U15_23 +
      T(40.291000000000004) * (minus_U15_22 - minus_U15_33) + T(241.7235) * U15_31 - T(14.7425) * U15_21;
  const T N15_2 = T(24.625) * Pddot15_1 + T(2.63125) * U15_13 + T(2.63125) * U15_31 + T(14.7425) * (minus_U15_33 -
      minus_U15_11) + T(40.291000000000004) * U15_12 - T(241.7235) * U15_32;
  const T N15_3 = T(241.7235) * (minus_U15_11 - minus_U15_22) - (T(2.63125) * U15_21 + T(684.759) * U15_12) +
      T(14.7425) * U15_23 - T(40.291000000000004) * U15_13 - T(403.06) * Pddot15_1;

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
  const T G16_1 = U16_13 * T(48.475) - minus_U16_11 * T(72.98);
  const T G16_2 = U16_21 * T(72.98) + U16_23 * T(48.475);
  const T G16_3 = U16_31 * T(72.98) - minus_U16_33 * T(48.475);
  // N16 = h_own_16~ Pddot16 + axial(U16 (tr(J_own_16)/2 - J_own_16)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N16_1 = T(79.90965) * (minus_U16_22 - minus_U16_33) - (T(21.971999999999998) * U16_32 + T(204.37225) *
      U16_23) + T(120.235) * U16_31 - T(14.508700000000001) * U16_21 - T(48.475) * Pddot16_2;
  const T N16_2 = T(48.475) * Pddot16_1 - T(72.98) * Pddot16_3 + T(204.37225) * U16_13 - T(21.971999999999998) *
      U16_31 + T(14.508700000000001) * (minus_U16_33 - minus_U16_11) + T(79.90965) * U16_12 - T(120.235) * U16_32;
  const T N16_3 = T(72.98) * Pddot16_2 + T(21.971999999999998) * U16_21 + T(21.971999999999998) * U16_12 + T(120.235)
      * (minus_U16_11 - minus_U16_22) + T(14.508700000000001) * U16_23 - T(79.90965) * U16_13;

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
  const T G17_1 = U17_12 * T(216.27) - minus_U17_11 * T(143.53);
  const T G17_2 = U17_21 * T(143.53) - minus_U17_22 * T(216.27);
  const T G17_3 = U17_31 * T(143.53) + U17_32 * T(216.27);
  // N17 = h_own_17~ Pddot17 + axial(U17 (tr(J_own_17)/2 - J_own_17)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N17_1 = T(216.27) * Pddot17_3 + T(194.346) * U17_32 + T(194.346) * U17_23 + T(43.2378) * (minus_U17_22 -
      minus_U17_33) + T(128.9745) * U17_31 - T(28.6844) * U17_21;
  const T N17_2 = T(28.6844) * (minus_U17_33 - minus_U17_11) - (T(194.346) * U17_13 + T(88.606) * U17_31) + T(43.2378)
      * U17_12 - T(128.9745) * U17_32 - T(143.53) * Pddot17_3;
  const T N17_3 = T(143.53) * Pddot17_2 - T(216.27) * Pddot17_1 + T(88.606) * U17_21 - T(194.346) * U17_12 +
      T(128.9745) * (minus_U17_11 - minus_U17_22) + T(28.6844) * U17_23 - T(43.2378) * U17_13;

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
  const T G18_1 = U18_12 * T(460.195) + U18_13 * T(23.830000000000002);
  const T G18_2 = U18_23 * T(23.830000000000002) - minus_U18_22 * T(460.195);
  const T G18_3 = U18_32 * T(460.195) - minus_U18_33 * T(23.830000000000002);
  // N18 = h_own_18~ Pddot18 + axial(U18 (tr(J_own_18)/2 - J_own_18)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N18_1 = T(460.195) * Pddot18_3 - T(23.830000000000002) * Pddot18_2 + T(915.13725) * U18_32 - T(2.572) *
      U18_23 + T(46.002700000000004) * (minus_U18_22 - minus_U18_33) + T(275.991) * U18_31 - T(14.2616) * U18_21;
  const T N18_2 = T(23.830000000000002) * Pddot18_1 + T(2.572) * U18_13 + T(2.572) * U18_31 + T(14.2616) *
      (minus_U18_33 - minus_U18_11) + T(46.002700000000004) * U18_12 - T(275.991) * U18_32;
  const T N18_3 = T(275.991) * (minus_U18_11 - minus_U18_22) - (T(2.572) * U18_21 + T(915.13725) * U18_12) +
      T(14.2616) * U18_23 - T(46.002700000000004) * U18_13 - T(460.195) * Pddot18_1;

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
  const T G19_1 = U19_13 * T(46.795) - minus_U19_11 * T(70.49);
  const T G19_2 = U19_21 * T(70.49) + U19_23 * T(46.795);
  const T G19_3 = U19_31 * T(70.49) - minus_U19_33 * T(46.795);
  // N19 = h_own_19~ Pddot19 + axial(U19 (tr(J_own_19)/2 - J_own_19)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N19_1 = T(91.14585000000001) * (minus_U19_22 - minus_U19_33) - (T(21.233999999999998) * U19_32 +
      T(264.61525) * U19_23) + T(137.209) * U19_31 - T(14.0008) * U19_21 - T(46.795) * Pddot19_2;
  const T N19_2 = T(46.795) * Pddot19_1 - T(70.49) * Pddot19_3 + T(264.61525) * U19_13 - T(21.233999999999998) *
      U19_31 + T(14.0008) * (minus_U19_33 - minus_U19_11) + T(91.14585000000001) * U19_12 - T(137.209) * U19_32;
  const T N19_3 = T(70.49) * Pddot19_2 + T(21.233999999999998) * U19_21 + T(21.233999999999998) * U19_12 + T(137.209)
      * (minus_U19_11 - minus_U19_22) + T(14.0008) * U19_23 - T(91.14585000000001) * U19_13;

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
  const T G20_1 = U20_12 * T(243.15) - minus_U20_11 * T(138.28);
  const T G20_2 = U20_21 * T(138.28) - minus_U20_22 * T(243.15);
  const T G20_3 = U20_31 * T(138.28) + U20_32 * T(243.15);
  // N20 = h_own_20~ Pddot20 + axial(U20 (tr(J_own_20)/2 - J_own_20)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N20_1 = T(243.15) * Pddot20_3 + T(254.88750000000002) * U20_32 + T(254.88750000000002) * U20_23 + T(48.612)
      * (minus_U20_22 - minus_U20_33) + T(144.924) * U20_31 - T(27.632) * U20_21;
  const T N20_2 = T(27.632) * (minus_U20_33 - minus_U20_11) - (T(254.88750000000002) * U20_13 + T(85.37875) * U20_31)
      + T(48.612) * U20_12 - T(144.924) * U20_32 - T(138.28) * Pddot20_3;
  const T N20_3 = T(138.28) * Pddot20_2 - T(243.15) * Pddot20_1 + T(85.37875) * U20_21 - T(254.88750000000002) *
      U20_12 + T(144.924) * (minus_U20_11 - minus_U20_22) + T(27.632) * U20_23 - T(48.612) * U20_13;

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
  const T G21_1 = U21_12 * T(510.355) + U21_13 * T(22.945);
  const T G21_2 = U21_23 * T(22.945) - minus_U21_22 * T(510.355);
  const T G21_3 = U21_32 * T(510.355) - minus_U21_33 * T(22.945);
  // N21 = h_own_21~ Pddot21 + axial(U21 (tr(J_own_21)/2 - J_own_21)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N21_1 = T(510.355) * Pddot21_3 - T(22.945) * Pddot21_2 + T(1163.67975) * U21_32 - T(2.50375) * U21_23 +
      T(51.0169) * (minus_U21_22 - minus_U21_33) + T(306.07349999999997) * U21_31 - T(13.726700000000001) * U21_21;
  const T N21_2 = T(22.945) * Pddot21_1 + T(2.50375) * U21_13 + T(2.50375) * U21_31 + T(13.726700000000001) *
      (minus_U21_33 - minus_U21_11) + T(51.0169) * U21_12 - T(306.07349999999997) * U21_32;
  const T N21_3 = T(306.07349999999997) * (minus_U21_11 - minus_U21_22) - (T(2.50375) * U21_21 + T(1163.67975) *
      U21_12) + T(13.726700000000001) * U21_23 - T(51.0169) * U21_13 - T(510.355) * Pddot21_1;

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
  const T G22_1 = U22_13 * T(44.935) - minus_U22_11 * T(67.73);
  const T G22_2 = U22_21 * T(67.73) + U22_23 * T(44.935);
  const T G22_3 = U22_31 * T(67.73) - minus_U22_33 * T(44.935);
  // N22 = h_own_22~ Pddot22 + axial(U22 (tr(J_own_22)/2 - J_own_22)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N22_1 = T(100.96455) * (minus_U22_22 - minus_U22_33) - (T(20.415) * U22_32 + T(328.44025) * U22_23) +
      T(152.0725) * U22_31 - T(13.4389) * U22_21 - T(44.935) * Pddot22_2;
  const T N22_2 = T(44.935) * Pddot22_1 - T(67.73) * Pddot22_3 + T(328.44025) * U22_13 - T(20.415) * U22_31 +
      T(13.4389) * (minus_U22_33 - minus_U22_11) + T(100.96455) * U22_12 - T(152.0725) * U22_32;
  const T N22_3 = T(67.73) * Pddot22_2 + T(20.415) * U22_21 + T(20.415) * U22_12 + T(152.0725) * (minus_U22_11 -
      minus_U22_22) + T(13.4389) * U22_23 - T(100.96455) * U22_13;

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
  const T G23_1 = U23_12 * T(266.34) - minus_U23_11 * T(132.49);
  const T G23_2 = U23_21 * T(132.49) - minus_U23_22 * T(266.34);
  const T G23_3 = U23_31 * T(132.49) + U23_32 * T(266.34);
  // N23 = h_own_23~ Pddot23 + axial(U23 (tr(J_own_23)/2 - J_own_23)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N23_1 = T(266.34) * Pddot23_3 + T(319.04699999999997) * U23_32 + T(319.04699999999997) * U23_23 +
      T(53.248200000000004) * (minus_U23_22 - minus_U23_33) + T(158.64149999999998) * U23_31 - T(26.471600000000002) *
      U23_21;
  const T N23_2 = T(26.471600000000002) * (minus_U23_33 - minus_U23_11) - (T(319.04699999999997) * U23_13 + T(81.8185)
      * U23_31) + T(53.248200000000004) * U23_12 - T(158.64149999999998) * U23_32 - T(132.49) * Pddot23_3;
  const T N23_3 = T(132.49) * Pddot23_2 - T(266.34) * Pddot23_1 + T(81.8185) * U23_21 - T(319.04699999999997) * U23_12
      + T(158.64149999999998) * (minus_U23_11 - minus_U23_22) + T(26.471600000000002) * U23_23 - T(53.248200000000004)
      * U23_13;

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
  const T G24_1 = U24_12 * T(552.73) + U24_13 * T(21.970000000000002);
  const T G24_2 = U24_23 * T(21.970000000000002) - minus_U24_22 * T(552.73);
  const T G24_3 = U24_32 * T(552.73) - minus_U24_33 * T(21.970000000000002);
  // N24 = h_own_24~ Pddot24 + axial(U24 (tr(J_own_24)/2 - J_own_24)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N24_1 = T(552.73) * Pddot24_3 - T(21.970000000000002) * Pddot24_2 + T(1422.0030000000002) * U24_32 -
      T(2.4265000000000003) * U24_23 + T(55.2526) * (minus_U24_22 - minus_U24_33) + T(331.485) * U24_31 - T(13.1378) *
      U24_21;
  const T N24_2 = T(21.970000000000002) * Pddot24_1 + T(2.4265000000000003) * U24_13 + T(2.4265000000000003) * U24_31
      + T(13.1378) * (minus_U24_33 - minus_U24_11) + T(55.2526) * U24_12 - T(331.485) * U24_32;
  const T N24_3 = T(331.485) * (minus_U24_11 - minus_U24_22) - (T(2.4265000000000003) * U24_21 + T(1422.0030000000002)
      * U24_12) + T(13.1378) * U24_23 - T(55.2526) * U24_13 - T(552.73) * Pddot24_1;

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
  const T G25_1 = U25_13 * T(42.895) - minus_U25_11 * T(64.7);
  const T G25_2 = U25_21 * T(64.7) + U25_23 * T(42.895);
  const T G25_3 = U25_31 * T(64.7) - minus_U25_33 * T(42.895);
  // N25 = h_own_25~ Pddot25 + axial(U25 (tr(J_own_25)/2 - J_own_25)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N25_1 = T(109.20375000000001) * (minus_U25_22 - minus_U25_33) - (T(19.514999999999997) * U25_32 +
      T(393.64000000000004) * U25_23) + T(164.5825) * U25_31 - T(12.823) * U25_21 - T(42.895) * Pddot25_2;
  const T N25_2 = T(42.895) * Pddot25_1 - T(64.7) * Pddot25_3 + T(393.64000000000004) * U25_13 - T(19.514999999999997)
      * U25_31 + T(12.823) * (minus_U25_33 - minus_U25_11) + T(109.20375000000001) * U25_12 - T(164.5825) * U25_32;
  const T N25_3 = T(64.7) * Pddot25_2 + T(19.514999999999997) * U25_21 + T(19.514999999999997) * U25_12 + T(164.5825)
      * (minus_U25_11 - minus_U25_22) + T(12.823) * U25_23 - T(109.20375000000001) * U25_13;

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
  const T G26_1 = U26_12 * T(285.435) - minus_U26_11 * T(126.16);
  const T G26_2 = U26_21 * T(126.16) - minus_U26_22 * T(285.435);
  const T G26_3 = U26_31 * T(126.16) + U26_32 * T(285.435);
  // N26 = h_own_26~ Pddot26 + axial(U26 (tr(J_own_26)/2 - J_own_26)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N26_1 = T(285.435) * Pddot26_3 + T(384.61725000000007) * U26_32 + T(384.61725000000007) * U26_23 +
      T(57.065400000000004) * (minus_U26_22 - minus_U26_33) + T(169.88400000000001) * U26_31 - T(25.2032) * U26_21;
  const T N26_2 = T(25.2032) * (minus_U26_33 - minus_U26_11) - (T(384.61725000000007) * U26_13 + T(77.92524999999999)
      * U26_31) + T(57.065400000000004) * U26_12 - T(169.88400000000001) * U26_32 - T(126.16) * Pddot26_3;
  const T N26_3 = T(126.16) * Pddot26_2 - T(285.435) * Pddot26_1 + T(77.92524999999999) * U26_21 -
      T(384.61725000000007) * U26_12 + T(169.88400000000001) * (minus_U26_11 - minus_U26_22) + T(25.2032) * U26_23 -
      T(57.065400000000004) * U26_13;

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
  const T G27_1 = U27_12 * T(586.51) + U27_13 * T(20.905);
  const T G27_2 = U27_23 * T(20.905) - minus_U27_22 * T(586.51);
  const T G27_3 = U27_32 * T(586.51) - minus_U27_33 * T(20.905);
  // N27 = h_own_27~ Pddot27 + axial(U27 (tr(J_own_27)/2 - J_own_27)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N27_1 = T(586.51) * Pddot27_3 - T(20.905) * Pddot27_2 + T(1680.7514999999999) * U27_32 - T(2.34025) * U27_23
      + T(58.6288) * (minus_U27_22 - minus_U27_33) + T(351.73949999999996) * U27_31 - T(12.4949) * U27_21;
  const T N27_2 = T(20.905) * Pddot27_1 + T(2.34025) * U27_13 + T(2.34025) * U27_31 + T(12.4949) * (minus_U27_33 -
      minus_U27_11) + T(58.6288) * U27_12 - T(351.73949999999996) * U27_32;
  const T N27_3 = T(351.73949999999996) * (minus_U27_11 - minus_U27_22) - (T(2.34025) * U27_21 + T(1680.7514999999999)
      * U27_12) + T(12.4949) * U27_23 - T(58.6288) * U27_13 - T(586.51) * Pddot27_1;

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
  const T G28_1 = U28_13 * T(40.675000000000004) - minus_U28_11 * T(61.4);
  const T G28_2 = U28_21 * T(61.4) + U28_23 * T(40.675000000000004);
  const T G28_3 = U28_31 * T(61.4) - minus_U28_33 * T(40.675000000000004);
  // N28 = h_own_28~ Pddot28 + axial(U28 (tr(J_own_28)/2 - J_own_28)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N28_1 = T(115.70145) * (minus_U28_22 - minus_U28_33) - (T(18.534) * U28_32 + T(457.76425) * U28_23) +
      T(174.49599999999998) * U28_31 - T(12.1531) * U28_21 - T(40.675000000000004) * Pddot28_2;
  const T N28_2 = T(40.675000000000004) * Pddot28_1 - T(61.4) * Pddot28_3 + T(457.76425) * U28_13 - T(18.534) * U28_31
      + T(12.1531) * (minus_U28_33 - minus_U28_11) + T(115.70145) * U28_12 - T(174.49599999999998) * U28_32;
  const T N28_3 = T(61.4) * Pddot28_2 + T(18.534) * U28_21 + T(18.534) * U28_12 + T(174.49599999999998) *
      (minus_U28_11 - minus_U28_22) + T(12.1531) * U28_23 - T(115.70145) * U28_13;

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
  const T G29_1 = U29_12 * T(300.03) - minus_U29_11 * T(119.28999999999999);
  const T G29_2 = U29_21 * T(119.28999999999999) - minus_U29_22 * T(300.03);
  const T G29_3 = U29_31 * T(119.28999999999999) + U29_32 * T(300.03);
  // N29 = h_own_29~ Pddot29 + axial(U29 (tr(J_own_29)/2 - J_own_29)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N29_1 = T(300.03) * Pddot29_3 + T(449.148) * U29_32 + T(449.148) * U29_23 + T(59.982600000000005) *
      (minus_U29_22 - minus_U29_33) + T(178.4085) * U29_31 - T(23.826800000000002) * U29_21;
  const T N29_2 = T(23.826800000000002) * (minus_U29_33 - minus_U29_11) - (T(449.148) * U29_13 + T(73.699) * U29_31) +
      T(59.982600000000005) * U29_12 - T(178.4085) * U29_32 - T(119.28999999999999) * Pddot29_3;
  const T N29_3 = T(119.28999999999999) * Pddot29_2 - T(300.03) * Pddot29_1 + T(73.699) * U29_21 - T(449.148) * U29_12
      + T(178.4085) * (minus_U29_11 - minus_U29_22) + T(23.826800000000002) * U29_23 - T(59.982600000000005) * U29_13;

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
  const T G30_1 = U30_12 * T(610.885) + U30_13 * T(19.75);
  const T G30_2 = U30_23 * T(19.75) - minus_U30_22 * T(610.885);
  const T G30_3 = U30_32 * T(610.885) - minus_U30_33 * T(19.75);
  // N30 = h_own_30~ Pddot30 + axial(U30 (tr(J_own_30)/2 - J_own_30)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N30_1 = T(610.885) * Pddot30_3 - T(19.75) * Pddot30_2 + T(1929.5977500000001) * U30_32 - T(2.245) * U30_23 +
      T(61.06450000000001) * (minus_U30_22 - minus_U30_33) + T(366.351) * U30_31 - T(11.798) * U30_21;
  const T N30_2 = T(19.75) * Pddot30_1 + T(2.245) * U30_13 + T(2.245) * U30_31 + T(11.798) * (minus_U30_33 -
      minus_U30_11) + T(61.06450000000001) * U30_12 - T(366.351) * U30_32;
  const T N30_3 = T(366.351) * (minus_U30_11 - minus_U30_22) - (T(2.245) * U30_21 + T(1929.5977500000001) * U30_12) +
      T(11.798) * U30_23 - T(61.06450000000001) * U30_13 - T(610.885) * Pddot30_1;

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
  const T G31_1 = U31_13 * T(38.275000000000006) - minus_U31_11 * T(57.83);
  const T G31_2 = U31_21 * T(57.83) + U31_23 * T(38.275000000000006);
  const T G31_3 = U31_31 * T(57.83) - minus_U31_33 * T(38.275000000000006);
  // N31 = h_own_31~ Pddot31 + axial(U31 (tr(J_own_31)/2 - J_own_31)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N31_1 = T(120.29565000000001) * (minus_U31_22 - minus_U31_33) - (T(17.471999999999998) * U31_32 +
      T(518.11975) * U31_23) + T(181.57) * U31_31 - T(11.4292) * U31_21 - T(38.275000000000006) * Pddot31_2;
  const T N31_2 = T(38.275000000000006) * Pddot31_1 - T(57.83) * Pddot31_3 + T(518.11975) * U31_13 -
      T(17.471999999999998) * U31_31 + T(11.4292) * (minus_U31_33 - minus_U31_11) + T(120.29565000000001) * U31_12 -
      T(181.57) * U31_32;
  const T N31_3 = T(57.83) * Pddot31_2 + T(17.471999999999998) * U31_21 + T(17.471999999999998) * U31_12 + T(181.57) *
      (minus_U31_11 - minus_U31_22) + T(11.4292) * U31_23 - T(120.29565000000001) * U31_13;

  // ---- body 32 (body_32) on body 31
  const T thetadot32 = y[31];
  const T thetaddot32 = ydot[31];
  // E32^T = Rot(b32, theta32): E takes components in the lower body to those in the body
  const T E32_11 = cosines[31];
  const T E32_12 = sines[31];
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
  const T t32_1 = omega32_3 * omega32_3;
  const T t32_2 = omega32_2 * omega32_2;
  const T minus_U32_11 = t32_1 + t32_2;
  const T t32_3 = omega32_2 * omega32_1;
  const T U32_12 = t32_3 - omegadot32_3;
  const T t32_4 = omega32_3 * omega32_1;
  const T U32_13 = t32_4 + omegadot32_2;
  const T U32_21 = t32_3 + omegadot32_3;
  const T t32_5 = omega32_1 * omega32_1;
  const T minus_U32_22 = t32_1 + t32_5;
  const T t32_6 = omega32_3 * omega32_2;
  const T U32_23 = t32_6 - omegadot32_1;
  const T U32_31 = t32_4 - omegadot32_2;
  const T U32_32 = t32_6 + omegadot32_1;
  const T minus_U32_33 = t32_2 + t32_5;
  // Pddot32 = E32 (U31 q32 + Pddot31): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t32_7 = Pddot31_1 + U31_12 * T(3.1500000000000004) - minus_U31_11 * T(0.3);
  const T t32_8 = Pddot31_2 + U31_21 * T(0.3) - minus_U31_22 * T(3.1500000000000004);
  const T Pddot32_1 = E32_11 * t32_7 + E32_12 * t32_8;
  const T Pddot32_2 = E32_11 * t32_8 - E32_12 * t32_7;
  const T Pddot32_3 = Pddot31_3 + U31_31 * T(0.3) + U31_32 * T(3.1500000000000004);
  // G32 = U32 h_own_32: inertia less applied force, body axes [N]
  const T G32_1 = U32_12 * T(309.71999999999997) - minus_U32_11 * T(111.88);
  const T G32_2 = U32_21 * T(111.88) - minus_U32_22 * T(309.71999999999997);
  const T G32_3 = U32_31 * T(111.88) + U32_32 * T(309.71999999999997);
  // N32 = h_own_32~ Pddot32 + axial(U32 (tr(J_own_32)/2 - J_own_32)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N32_1 = T(309.71999999999997) * Pddot32_3 + T(509.94599999999997) * U32_32 + T(509.94599999999997) * U32_23
      + T(61.9188) * (minus_U32_22 - minus_U32_33) + T(183.97199999999998) * U32_31 - T(22.3424) * U32_21;
  const T N32_2 = T(22.3424) * (minus_U32_33 - minus_U32_11) - (T(509.94599999999997) * U32_13 + T(69.13974999999999)
      * U32_31) + T(61.9188) * U32_12 - T(183.97199999999998) * U32_32 - T(111.88) * Pddot32_3;
  const T N32_3 = T(111.88) * Pddot32_2 - T(309.71999999999997) * Pddot32_1 + T(69.13974999999999) * U32_21 -
      T(509.94599999999997) * U32_12 + T(183.97199999999998) * (minus_U32_11 - minus_U32_22) + T(22.3424) * U32_23 -
      T(61.9188) * U32_13;

  // ---- body 33 (body_33) on body 32
  const T thetadot33 = y[32];
  const T thetaddot33 = ydot[32];
  // E33^T = Rot(b33, theta33): E takes components in the lower body to those in the body
  const T E33_22 = cosines[32];
  const T E33_23 = sines[32];
  // omega33 = thetadot33 b33 + E33 omega32: absolute angular velocity, body axes [rad/s]
  const T omega33_1 = thetadot33 + omega32_1;
  const T omega33_2 = E33_22 * omega32_2 + E33_23 * omega32_3;
  const T omega33_3 = E33_22 * omega32_3 - E33_23 * omega32_2;
  // omegadot33 = -thetadot33 b33~ E33 omega32 + thetaddot33 b33 + E33 omegadot32: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot33_1 = thetaddot33 + omegadot32_1;
  const T omegadot33_2 = thetadot33 * omega33_3 + E33_22 * omegadot32_2 + E33_23 * omegadot32_3;
  const T omegadot33_3 = E33_22 * omegadot32_3 - E33_23 * omegadot32_2 - thetadot33 * omega33_2;
  // U33 = omega33~ omega33~ + omegadot33~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t33_1 = omega33_3 * omega33_3;
  const T t33_2 = omega33_2 * omega33_2;
  const T minus_U33_11 = t33_1 + t33_2;
  const T t33_3 = omega33_2 * omega33_1;
  const T U33_12 = t33_3 - omegadot33_3;
  const T t33_4 = omega33_3 * omega33_1;
  const T U33_13 = t33_4 + omegadot33_2;
  const T U33_21 = t33_3 + omegadot33_3;
  const T t33_5 = omega33_1 * omega33_1;
  const T minus_U33_22 = t33_1 + t33_5;
  const T t33_6 = omega33_3 * omega33_2;
  const T U33_23 = t33_6 - omegadot33_1;
  const T U33_31 = t33_4 - omegadot33_2;
  const T U33_32 = t33_6 + omegadot33_1;
  const T minus_U33_33 = t33_2 + t33_5;
  // Pddot33 = E33 (U32 q33 + Pddot32): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot33_1 = Pddot32_1 + U32_12 * T(1.65) + U32_13 * T(0.2);
  const T t33_7 = Pddot32_2 + U32_23 * T(0.2) - minus_U32_22 * T(1.65);
  const T t33_8 = Pddot32_3 + U32_32 * T(1.65) - minus_U32_33 * T(0.2);
  const T Pddot33_2 = E33_22 * t33_7 + E33_23 * t33_8;
  const T Pddot33_3 = E33_22 * t33_8 - E33_23 * t33_7;
  // G33 = U33 h_own_33: inertia less applied force, body axes [N]
  const T G33_1 = U33_12 * T(625.045) + U33_13 * T(18.505000000000003);
  const T G33_2 = U33_23 * T(18.505000000000003) - minus_U33_22 * T(625.045);
  const T G33_3 = U33_32 * T(625.045) - minus_U33_33 * T(18.505000000000003);
  // N33 = h_own_33~ Pddot33 + axial(U33 (tr(J_own_33)/2 - J_own_33)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N33_1 = T(625.045) * Pddot33_3 - T(18.505000000000003) * Pddot33_2 + T(2157.24225) * U33_32 - T(2.14075) *
      U33_23 + T(62.4787) * (minus_U33_22 - minus_U33_33) + T(374.83349999999996) * U33_31 - T(11.0471) * U33_21;
  const T N33_2 = T(18.505000000000003) * Pddot33_1 + T(2.14075) * U33_13 + T(2.14075) * U33_31 + T(11.0471) *
      (minus_U33_33 - minus_U33_11) + T(62.4787) * U33_12 - T(374.83349999999996) * U33_32;
  const T N33_3 = T(374.83349999999996) * (minus_U33_11 - minus_U33_22) - (T(2.14075) * U33_21 + T(2157.24225) *
      U33_12) + T(11.0471) * U33_23 - T(62.4787) * U33_13 - T(625.045) * Pddot33_1;

  // ---- body 34 (body_34) on body 33
  const T thetadot34 = y[33];
  const T thetaddot34 = ydot[33];
  // E34^T = Rot(b34, theta34): E takes components in the lower body to those in the body
  const T E34_11 = cosines[33];
  const T minus_E34_13 = sines[33];
  // omega34 = thetadot34 b34 + E34 omega33: absolute angular velocity, body axes [rad/s]
  const T omega34_1 = E34_11 * omega33_1 - minus_E34_13 * omega33_3;
  const T omega34_2 = thetadot34 + omega33_2;
  const T omega34_3 = minus_E34_13 * omega33_1 + E34_11 * omega33_3;
  // omegadot34 = -thetadot34 b34~ E34 omega33 + thetaddot34 b34 + E34 omegadot33: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot34_1 = E34_11 * omegadot33_1 - minus_E34_13 * omegadot33_3 - thetadot34 * omega34_3;
  const T omegadot34_2 = thetaddot34 + omegadot33_2;
  const T omegadot34_3 = thetadot34 * omega34_1 + minus_E34_13 * omegadot33_1 + E34_11 * omegadot33_3;
  // U34 = omega34~ omega34~ + omegadot34~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t34_1 = omega34_3 * omega34_3;
  const T t34_2 = omega34_2 * omega34_2;
  const T minus_U34_11 = t34_1 + t34_2;
  const T t34_3 = omega34_2 * omega34_1;
  const T U34_12 = t34_3 - omegadot34_3;
  const T t34_4 = omega34_3 * omega34_1;
  const T U34_13 = t34_4 + omegadot34_2;
  const T U34_21 = t34_3 + omegadot34_3;
  const T t34_5 = omega34_1 * omega34_1;
  const T minus_U34_22 = t34_1 + t34_5;
  const T t34_6 = omega34_3 * omega34_2;
  const T U34_23 = t34_6 - omegadot34_1;
  const T U34_31 = t34_4 - omegadot34_2;
  const T U34_32 = t34_6 + omegadot34_1;
  const T minus_U34_33 = t34_2 + t34_5;
  // Pddot34 = E34 (U33 q34 + Pddot33): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t34_7 = Pddot33_1 + U33_13 * T(0.1) - minus_U33_11 * T(0.6);
  const T t34_8 = Pddot33_3 + U33_31 * T(0.6) - minus_U33_33 * T(0.1);
  const T Pddot34_1 = E34_11 * t34_7 - minus_E34_13 * t34_8;
  const T Pddot34_2 = Pddot33_2 + U33_21 * T(0.6) + U33_23 * T(0.1);
  const T Pddot34_3 = minus_E34_13 * t34_7 + E34_11 * t34_8;
  // G34 = U34 h_own_34: inertia less applied force, body axes [N]
  const T G34_1 = U34_13 * T(35.695) - minus_U34_11 * T(53.989999999999995);
  const T G34_2 = U34_21 * T(53.989999999999995) + U34_23 * T(35.695);
  const T G34_3 = U34_31 * T(53.989999999999995) - minus_U34_33 * T(35.695);
  // N34 = h_own_34~ Pddot34 + axial(U34 (tr(J_own_34)/2 - J_own_34)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N34_1 = T(122.82435000000001) * (minus_U34_22 - minus_U34_33) - (T(16.328999999999997) * U34_32 +
      T(571.77025) * U34_23) + T(185.5615) * U34_31 - T(10.6513) * U34_21 - T(35.695) * Pddot34_2;
  const T N34_2 = T(35.695) * Pddot34_1 - T(53.989999999999995) * Pddot34_3 + T(571.77025) * U34_13 -
      T(16.328999999999997) * U34_31 + T(10.6513) * (minus_U34_33 - minus_U34_11) + T(122.82435000000001) * U34_12 -
      T(185.5615) * U34_32;
  const T N34_3 = T(53.989999999999995) * Pddot34_2 + T(16.328999999999997) * U34_21 + T(16.328999999999997) * U34_12
      + T(185.5615) * (minus_U34_11 - minus_U34_22) + T(10.6513) * U34_23 - T(122.82435000000001) * U34_13;

  // ---- body 35 (body_35) on body 34
  const T thetadot35 = y[34];
  const T thetaddot35 = ydot[34];
  // E35^T = Rot(b35, theta35): E takes components in the lower body to those in the body
  const T E35_11 = cosines[34];
  const T E35_12 = sines[34];
  // omega35 = thetadot35 b35 + E35 omega34: absolute angular velocity, body axes [rad/s]
  const T omega35_1 = E35_11 * omega34_1 + E35_12 * omega34_2;
  const T omega35_2 = E35_11 * omega34_2 - E35_12 * omega34_1;
  const T omega35_3 = thetadot35 + omega34_3;
  // omegadot35 = -thetadot35 b35~ E35 omega34 + thetaddot35 b35 + E35 omegadot34: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot35_1 = thetadot35 * omega35_2 + E35_11 * omegadot34_1 + E35_12 * omegadot34_2;
  const T omegadot35_2 = E35_11 * omegadot34_2 - E35_12 * omegadot34_1 - thetadot35 * omega35_1;
  const T omegadot35_3 = thetaddot35 + omegadot34_3;
  // U35 = omega35~ omega35~ + omegadot35~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t35_1 = omega35_3 * omega35_3;
  const T t35_2 = omega35_2 * omega35_2;
  const T minus_U35_11 = t35_1 + t35_2;
  const T t35_3 = omega35_2 * omega35_1;
  const T U35_12 = t35_3 - omegadot35_3;
  const T t35_4 = omega35_3 * omega35_1;
  const T U35_13 = t35_4 + omegadot35_2;
  const T U35_21 = t35_3 + omegadot35_3;
  const T t35_5 = omega35_1 * omega35_1;
  const T minus_U35_22 = t35_1 + t35_5;
  const T t35_6 = omega35_3 * omega35_2;
  const T U35_23 = t35_6 - omegadot35_1;
  const T U35_31 = t35_4 - omegadot35_2;
  const T U35_32 = t35_6 + omegadot35_1;
  const T minus_U35_33 = t35_2 + t35_5;
  // Pddot35 = E35 (U34 q35 + Pddot34): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t35_7 = Pddot34_1 + U34_12 * T(3.45) - minus_U34_11 * T(0.3);
  const T t35_8 = Pddot34_2 + U34_21 * T(0.3) - minus_U34_22 * T(3.45);
  const T Pddot35_1 = E35_11 * t35_7 + E35_12 * t35_8;
  const T Pddot35_2 = E35_11 * t35_8 - E35_12 * t35_7;
  const T Pddot35_3 = Pddot34_3 + U34_31 * T(0.3) + U34_32 * T(3.45);
  // G35 = U35 h_own_35: inertia less applied force, body axes [N]
  const T G35_1 = U35_12 * T(314.1) - minus_U35_11 * T(103.92999999999999);
  const T G35_2 = U35_21 * T(103.92999999999999) - minus_U35_22 * T(314.1);
  const T G35_3 = U35_31 * T(103.92999999999999) + U35_32 * T(314.1);
  // N35 = h_own_35~ Pddot35 + axial(U35 (tr(J_own_35)/2 - J_own_35)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N35_1 = T(314.1) * Pddot35_3 + T(564.075) * U35_32 + T(564.075) * U35_23 + T(62.793000000000006) *
      (minus_U35_22 - minus_U35_33) + T(186.3315) * U35_31 - T(20.75) * U35_21;
  const T N35_2 = T(20.75) * (minus_U35_33 - minus_U35_11) - (T(564.075) * U35_13 + T(64.2475) * U35_31) +
      T(62.793000000000006) * U35_12 - T(186.3315) * U35_32 - T(103.92999999999999) * Pddot35_3;
  const T N35_3 = T(103.92999999999999) * Pddot35_2 - T(314.1) * Pddot35_1 + T(64.2475) * U35_21 - T(564.075) * U35_12
      + T(186.3315) * (minus_U35_11 - minus_U35_22) + T(20.75) * U35_23 - T(62.793000000000006) * U35_13;

  // ---- body 36 (body_36) on body 35
  const T thetadot36 = y[35];
  const T thetaddot36 = ydot[35];
  // E36^T = Rot(b36, theta36): E takes components in the lower body to those in the body
  const T E36_22 = cosines[35];
  const T E36_23 = sines[35];
  // omega36 = thetadot36 b36 + E36 omega35: absolute angular velocity, body axes [rad/s]
  const T omega36_1 = thetadot36 + omega35_1;
  const T omega36_2 = E36_22 * omega35_2 + E36_23 * omega35_3;
  const T omega36_3 = E36_22 * omega35_3 - E36_23 * omega35_2;
  // omegadot36 = -thetadot36 b36~ E36 omega35 + thetaddot36 b36 + E36 omegadot35: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot36_1 = thetaddot36 + omegadot35_1;
  const T omegadot36_2 = thetadot36 * omega36_3 + E36_22 * omegadot35_2 + E36_23 * omegadot35_3;
  const T omegadot36_3 = E36_22 * omegadot35_3 - E36_23 * omegadot35_2 - thetadot36 * omega36_2;
  // U36 = omega36~ omega36~ + omegadot36~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t36_1 = omega36_3 * omega36_3;
  const T t36_2 = omega36_2 * omega36_2;
  const T minus_U36_11 = t36_1 + t36_2;
  const T t36_3 = omega36_2 * omega36_1;
  const T U36_12 = t36_3 - omegadot36_3;
  const T t36_4 = omega36_3 * omega36_1;
  const T U36_13 = t36_4 + omegadot36_2;
  const T U36_21 = t36_3 + omegadot36_3;
  const T t36_5 = omega36_1 * omega36_1;
  const T minus_U36_22 = t36_1 + t36_5;
  const T t36_6 = omega36_3 * omega36_2;
  const T U36_23 = t36_6 - omegadot36_1;
  const T U36_31 = t36_4 - omegadot36_2;
  const T U36_32 = t36_6 + omegadot36_1;
  const T minus_U36_33 = t36_2 + t36_5;
  // Pddot36 = E36 (U35 q36 + Pddot35): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot36_1 = Pddot35_1 + U35_12 * T(1.8) + U35_13 * T(0.2);
  const T t36_7 = Pddot35_2 + U35_23 * T(0.2) - minus_U35_22 * T(1.8);
  const T t36_8 = Pddot35_3 + U35_32 * T(1.8) - minus_U35_33 * T(0.2);
  const T Pddot36_2 = E36_22 * t36_7 + E36_23 * t36_8;
  const T Pddot36_3 = E36_22 * t36_8 - E36_23 * t36_7;
  // G36 = U36 h_own_36: inertia less applied force, body axes [N]
  const T G36_1 = U36_12 * T(628.18) + U36_13 * T(17.17);
  const T G36_2 = U36_23 * T(17.17) - minus_U36_22 * T(628.18);
  const T G36_3 = U36_32 * T(628.18) - minus_U36_33 * T(17.17);
  // N36 = h_own_36~ Pddot36 + axial(U36 (tr(J_own_36)/2 - J_own_36)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N36_1 = T(628.18) * Pddot36_3 - T(17.17) * Pddot36_2 + T(2351.4135) * U36_32 - T(2.0275000000000003) *
      U36_23 + T(62.790400000000005) * (minus_U36_22 - minus_U36_33) + T(376.70099999999996) * U36_31 - T(10.2422) *
      U36_21;
  const T N36_2 = T(17.17) * Pddot36_1 + T(2.0275000000000003) * U36_13 + T(2.0275000000000003) * U36_31 + T(10.2422)
      * (minus_U36_33 - minus_U36_11) + T(62.790400000000005) * U36_12 - T(376.70099999999996) * U36_32;
  const T N36_3 = T(376.70099999999996) * (minus_U36_11 - minus_U36_22) - (T(2.0275000000000003) * U36_21 +
      T(2351.4135) * U36_12) + T(10.2422) * U36_23 - T(62.790400000000005) * U36_13 - T(628.18) * Pddot36_1;

  // ---- body 37 (body_37) on body 36
  const T thetadot37 = y[36];
  const T thetaddot37 = ydot[36];
  // E37^T = Rot(b37, theta37): E takes components in the lower body to those in the body
  const T E37_11 = cosines[36];
  const T minus_E37_13 = sines[36];
  // omega37 = thetadot37 b37 + E37 omega36: absolute angular velocity, body axes [rad/s]
  const T omega37_1 = E37_11 * omega36_1 - minus_E37_13 * omega36_3;
  const T omega37_2 = thetadot37 + omega36_2;
  const T omega37_3 = minus_E37_13 * omega36_1 + E37_11 * omega36_3;
  // omegadot37 = -thetadot37 b37~ E37 omega36 + thetaddot37 b37 + E37 omegadot36: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot37_1 = E37_11 * omegadot36_1 - minus_E37_13 * omegadot36_3 - thetadot37 * omega37_3;
  const T omegadot37_2 = thetaddot37 + omegadot36_2;
  const T omegadot37_3 = thetadot37 * omega37_1 + minus_E37_13 * omegadot36_1 + E37_11 * omegadot36_3;
  // U37 = omega37~ omega37~ + omegadot37~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t37_1 = omega37_3 * omega37_3;
  const T t37_2 = omega37_2 * omega37_2;
  const T minus_U37_11 = t37_1 + t37_2;
  const T t37_3 = omega37_2 * omega37_1;
  const T U37_12 = t37_3 - omegadot37_3;
  const T t37_4 = omega37_3 * omega37_1;
  const T U37_13 = t37_4 + omegadot37_2;
  const T U37_21 = t37_3 + omegadot37_3;
  const T t37_5 = omega37_1 * omega37_1;
  const T minus_U37_22 = t37_1 + t37_5;
  const T t37_6 = omega37_3 * omega37_2;
  const T U37_23 = t37_6 - omegadot37_1;
  const T U37_31 = t37_4 - omegadot37_2;
  const T U37_32 = t37_6 + omegadot37_1;
  const T minus_U37_33 = t37_2 + t37_5;
  // Pddot37 = E37 (U36 q37 + Pddot36): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t37_7 = Pddot36_1 + U36_13 * T(0.1) - minus_U36_11 * T(0.6);
  const T t37_8 = Pddot36_3 + U36_31 * T(0.6) - minus_U36_33 * T(0.1);
  const T Pddot37_1 = E37_11 * t37_7 - minus_E37_13 * t37_8;
  const T Pddot37_2 = Pddot36_2 + U36_21 * T(0.6) + U36_23 * T(0.1);
  const T Pddot37_3 = minus_E37_13 * t37_7 + E37_11 * t37_8;
  // G37 = U37 h_own_37: inertia less applied force, body axes [N]
  const T G37_1 = U37_13 * T(32.935) - minus_U37_11 * T(49.879999999999995);
  const T G37_2 = U37_21 * T(49.879999999999995) + U37_23 * T(32.935);
  const T G37_3 = U37_31 * T(49.879999999999995) - minus_U37_33 * T(32.935);
  // N37 = h_own_37~ Pddot37 + axial(U37 (tr(J_own_37)/2 - J_own_37)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N37_1 = T(123.12555) * (minus_U37_22 - minus_U37_33) - (T(15.104999999999999) * U37_32 +
      T(615.5364999999999) * U37_23) + T(186.2275) * U37_31 - T(9.8194) * U37_21 - T(32.935) * Pddot37_2;
  const T N37_2 = T(32.935) * Pddot37_1 - T(49.879999999999995) * Pddot37_3 + T(615.5364999999999) * U37_13 -
      T(15.104999999999999) * U37_31 + T(9.8194) * (minus_U37_33 - minus_U37_11) + T(123.12555) * U37_12 - T(186.2275)
      * U37_32;
  const T N37_3 = T(49.879999999999995) * Pddot37_2 + T(15.104999999999999) * U37_21 + T(15.104999999999999) * U37_12
      + T(186.2275) * (minus_U37_11 - minus_U37_22) + T(9.8194) * U37_23 - T(123.12555) * U37_13;

  // ---- body 38 (body_38) on body 37
  const T thetadot38 = y[37];
  const T thetaddot38 = ydot[37];
  // E38^T = Rot(b38, theta38): E takes components in the lower body to those in the body
  const T E38_11 = cosines[37];
  const T E38_12 = sines[37];
  // omega38 = thetadot38 b38 + E38 omega37: absolute angular velocity, body axes [rad/s]
  const T omega38_1 = E38_11 * omega37_1 + E38_12 * omega37_2;
  const T omega38_2 = E38_11 * omega37_2 - E38_12 * omega37_1;
  const T omega38_3 = thetadot38 + omega37_3;
  // omegadot38 = -thetadot38 b38~ E38 omega37 + thetaddot38 b38 + E38 omegadot37: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot38_1 = thetadot38 * omega38_2 + E38_11 * omegadot37_1 + E38_12 * omegadot37_2;
  const T omegadot38_2 = E38_11 * omegadot37_2 - E38_12 * omegadot37_1 - thetadot38 * omega38_1;
  const T omegadot38_3 = thetaddot38 + omegadot37_3;
  // U38 = omega38~ omega38~ + omegadot38~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t38_1 = omega38_3 * omega38_3;
  const T t38_2 = omega38_2 * omega38_2;
  const T minus_U38_11 = t38_1 + t38_2;
  const T t38_3 = omega38_2 * omega38_1;
  const T U38_12 = t38_3 - omegadot38_3;
  const T t38_4 = omega38_3 * omega38_1;
  const T U38_13 = t38_4 + omegadot38_2;
  const T U38_21 = t38_3 + omegadot38_3;
  const T t38_5 = omega38_1 * omega38_1;
  const T minus_U38_22 = t38_1 + t38_5;
  const T t38_6 = omega38_3 * omega38_2;
  const T U38_23 = t38_6 - omegadot38_1;
  const T U38_31 = t38_4 - omegadot38_2;
  const T U38_32 = t38_6 + omegadot38_1;
  const T minus_U38_33 = t38_2 + t38_5;
  // Pddot38 = E38 (U37 q38 + Pddot37): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t38_7 = Pddot37_1 + U37_12 * T(3.75) - minus_U37_11 * T(0.3);
  const T t38_8 = Pddot37_2 + U37_21 * T(0.3) - minus_U37_22 * T(3.75);
  const T Pddot38_1 = E38_11 * t38_7 + E38_12 * t38_8;
  const T Pddot38_2 = E38_11 * t38_8 - E38_12 * t38_7;
  const T Pddot38_3 = Pddot37_3 + U37_31 * T(0.3) + U37_32 * T(3.75);
  // G38 = U38 h_own_38: inertia less applied force, body axes [N]
  const T G38_1 = U38_12 * T(312.765) - minus_U38_11 * T(95.44);
  const T G38_2 = U38_21 * T(95.44) - minus_U38_22 * T(312.765);
  const T G38_3 = U38_31 * T(95.44) + U38_32 * T(312.765);
  // N38 = h_own_38~ Pddot38 + axial(U38 (tr(J_own_38)/2 - J_own_38)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N38_1 = T(312.765) * Pddot38_3 + T(608.35575) * U38_32 + T(608.35575) * U38_23 + T(62.5242) * (minus_U38_22
      - minus_U38_33) + T(185.244) * U38_31 - T(19.0496) * U38_21;
  const T N38_2 = T(19.0496) * (minus_U38_33 - minus_U38_11) - (T(608.35575) * U38_13 + T(59.02224999999999) * U38_31)
      + T(62.5242) * U38_12 - T(185.244) * U38_32 - T(95.44) * Pddot38_3;
  const T N38_3 = T(95.44) * Pddot38_2 - T(312.765) * Pddot38_1 + T(59.02224999999999) * U38_21 - T(608.35575) *
      U38_12 + T(185.244) * (minus_U38_11 - minus_U38_22) + T(19.0496) * U38_23 - T(62.5242) * U38_13;

  // ---- body 39 (body_39) on body 38
  const T thetadot39 = y[38];
  const T thetaddot39 = ydot[38];
  // E39^T = Rot(b39, theta39): E takes components in the lower body to those in the body
  const T E39_22 = cosines[38];
  const T E39_23 = sines[38];
  // omega39 = thetadot39 b39 + E39 omega38: absolute angular velocity, body axes [rad/s]
  const T omega39_1 = thetadot39 + omega38_1;
  const T omega39_2 = E39_22 * omega38_2 + E39_23 * omega38_3;
  const T omega39_3 = E39_22 * omega38_3 - E39_23 * omega38_2;
  // omegadot39 = -thetadot39 b39~ E39 omega38 + thetaddot39 b39 + E39 omegadot38: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot39_1 = thetaddot39 + omegadot38_1;
  const T omegadot39_2 = thetadot39 * omega39_3 + E39_22 * omegadot38_2 + E39_23 * omegadot38_3;
  const T omegadot39_3 = E39_22 * omegadot38_3 - E39_23 * omegadot38_2 - thetadot39 * omega39_2;
  // U39 = omega39~ omega39~ + omegadot39~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t39_1 = omega39_3 * omega39_3;
  const T t39_2 = omega39_2 * omega39_2;
  const T minus_U39_11 = t39_1 + t39_2;
  const T t39_3 = omega39_2 * omega39_1;
  const T U39_12 = t39_3 - omegadot39_3;
  const T t39_4 = omega39_3 * omega39_1;
  const T U39_13 = t39_4 + omegadot39_2;
  const T U39_21 = t39_3 + omegadot39_3;
  const T t39_5 = omega39_1 * omega39_1;
  const T minus_U39_22 = t39_1 + t39_5;
  const T t39_6 = omega39_3 * omega39_2;
  const T U39_23 = t39_6 - omegadot39_1;
  const T U39_31 = t39_4 - omegadot39_2;
  const T U39_32 = t39_6 + omegadot39_1;
  const T minus_U39_33 = t39_2 + t39_5;
  // Pddot39 = E39 (U38 q39 + Pddot38): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot39_1 = Pddot38_1 + U38_12 * T(1.95) + U38_13 * T(0.2);
  const T t39_7 = Pddot38_2 + U38_23 * T(0.2) - minus_U38_22 * T(1.95);
  const T t39_8 = Pddot38_3 + U38_32 * T(1.95) - minus_U38_33 * T(0.2);
  const T Pddot39_2 = E39_22 * t39_7 + E39_23 * t39_8;
  const T Pddot39_3 = E39_22 * t39_8 - E39_23 * t39_7;
  // G39 = U39 h_own_39: inertia less applied force, body axes [N]
  const T G39_1 = U39_12 * T(619.48) + U39_13 * T(15.745000000000001);
  const T G39_2 = U39_23 * T(15.745000000000001) - minus_U39_22 * T(619.48);
  const T G39_3 = U39_32 * T(619.48) - minus_U39_33 * T(15.745000000000001);
  // N39 = h_own_39~ Pddot39 + axial(U39 (tr(J_own_39)/2 - J_own_39)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N39_1 = T(619.48) * Pddot39_3 - T(15.745000000000001) * Pddot39_2 + T(2498.868) * U39_32 - T(1.90525) *
      U39_23 + T(61.9186) * (minus_U39_22 - minus_U39_33) + T(371.4675) * U39_31 - T(9.3833) * U39_21;
  const T N39_2 = T(15.745000000000001) * Pddot39_1 + T(1.90525) * U39_13 + T(1.90525) * U39_31 + T(9.3833) *
      (minus_U39_33 - minus_U39_11) + T(61.9186) * U39_12 - T(371.4675) * U39_32;
  const T N39_3 = T(371.4675) * (minus_U39_11 - minus_U39_22) - (T(1.90525) * U39_21 + T(2498.868) * U39_12) +
      T(9.3833) * U39_23 - T(61.9186) * U39_13 - T(619.48) * Pddot39_1;

  // ---- body 40 (body_40) on body 39
  const T thetadot40 = y[39];
  const T thetaddot40 = ydot[39];
  // E40^T = Rot(b40, theta40): E takes components in the lower body to those in the body
  const T E40_11 = cosines[39];
  const T minus_E40_13 = sines[39];
  // omega40 = thetadot40 b40 + E40 omega39: absolute angular velocity, body axes [rad/s]
  const T omega40_1 = E40_11 * omega39_1 - minus_E40_13 * omega39_3;
  const T omega40_2 = thetadot40 + omega39_2;
  const T omega40_3 = minus_E40_13 * omega39_1 + E40_11 * omega39_3;
  // omegadot40 = -thetadot40 b40~ E40 omega39 + thetaddot40 b40 + E40 omegadot39: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot40_1 = E40_11 * omegadot39_1 - minus_E40_13 * omegadot39_3 - thetadot40 * omega40_3;
  const T omegadot40_2 = thetaddot40 + omegadot39_2;
  const T omegadot40_3 = thetadot40 * omega40_1 + minus_E40_13 * omegadot39_1 + E40_11 * omegadot39_3;
  // U40 = omega40~ omega40~ + omegadot40~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t40_1 = omega40_3 * omega40_3;
  const T t40_2 = omega40_2 * omega40_2;
  const T minus_U40_11 = t40_1 + t40_2;
  const T t40_3 = omega40_2 * omega40_1;
  const T U40_12 = t40_3 - omegadot40_3;
  const T t40_4 = omega40_3 * omega40_1;
  const T U40_13 = t40_4 + omegadot40_2;
  const T U40_21 = t40_3 + omegadot40_3;
  const T t40_5 = omega40_1 * omega40_1;
  const T minus_U40_22 = t40_1 + t40_5;
  const T t40_6 = omega40_3 * omega40_2;
  const T U40_23 = t40_6 - omegadot40_1;
  const T U40_31 = t40_4 - omegadot40_2;
  const T U40_32 = t40_6 + omegadot40_1;
  const T minus_U40_33 = t40_2 + t40_5;
  // Pddot40 = E40 (U39 q40 + Pddot39): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t40_7 = Pddot39_1 + U39_13 * T(0.1) - minus_U39_11 * T(0.6);
  const T t40_8 = Pddot39_3 + U39_31 * T(0.6) - minus_U39_33 * T(0.1);
  const T Pddot40_1 = E40_11 * t40_7 - minus_E40_13 * t40_8;
  const T Pddot40_2 = Pddot39_2 + U39_21 * T(0.6) + U39_23 * T(0.1);
  const T Pddot40_3 = minus_E40_13 * t40_7 + E40_11 * t40_8;
  // G40 = U40 h_own_40: inertia less applied force, body axes [N]
  const T G40_1 = U40_13 * T(29.995) - minus_U40_11 * T(45.5);
  const T G40_2 = U40_21 * T(45.5) + U40_23 * T(29.995);
  const T G40_3 = U40_31 * T(45.5) - minus_U40_33 * T(29.995);
  // N40 = h_own_40~ Pddot40 + axial(U40 (tr(J_own_40)/2 - J_own_40)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N40_1 = T(121.03725) * (minus_U40_22 - minus_U40_33) - (T(13.799999999999999) * U40_32 + T(645.99625) *
      U40_23) + T(183.325) * U40_31 - T(8.9335) * U40_21 - T(29.995) * Pddot40_2;
  const T N40_2 = T(29.995) * Pddot40_1 - T(45.5) * Pddot40_3 + T(645.99625) * U40_13 - T(13.799999999999999) * U40_31
      + T(8.9335) * (minus_U40_33 - minus_U40_11) + T(121.03725) * U40_12 - T(183.325) * U40_32;
  const T N40_3 = T(45.5) * Pddot40_2 + T(13.799999999999999) * U40_21 + T(13.799999999999999) * U40_12 + T(183.325) *
      (minus_U40_11 - minus_U40_22) + T(8.9335) * U40_23 - T(121.03725) * U40_13;

  // ---- body 41 (body_41) on body 40
  const T thetadot41 = y[40];
  const T thetaddot41 = ydot[40];
  // E41^T = Rot(b41, theta41): E takes components in the lower body to those in the body
  const T E41_11 = cosines[40];
  const T E41_12 = sines[40];
  // omega41 = thetadot41 b41 + E41 omega40: absolute angular velocity, body axes [rad/s]
  const T omega41_1 = E41_11 * omega40_1 + E41_12 * omega40_2;
  const T omega41_2 = E41_11 * omega40_2 - E41_12 * omega40_1;
  const T omega41_3 = thetadot41 + omega40_3;
  // omegadot41 = -thetadot41 b41~ E41 omega40 + thetaddot41 b41 + E41 omegadot40: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot41_1 = thetadot41 * omega41_2 + E41_11 * omegadot40_1 + E41_12 * omegadot40_2;
  const T omegadot41_2 = E41_11 * omegadot40_2 - E41_12 * omegadot40_1 - thetadot41 * omega41_1;
  const T omegadot41_3 = thetaddot41 + omegadot40_3;
  // U41 = omega41~ omega41~ + omegadot41~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t41_1 = omega41_3 * omega41_3;
  const T t41_2 = omega41_2 * omega41_2;
  const T minus_U41_11 = t41_1 + t41_2;
  const T t41_3 = omega41_2 * omega41_1;
  const T U41_12 = t41_3 - omegadot41_3;
  const T t41_4 = omega41_3 * omega41_1;
  const T U41_13 = t41_4 + omegadot41_2;
  const T U41_21 = t41_3 + omegadot41_3;
  const T t41_5 = omega41_1 * omega41_1;
  const T minus_U41_22 = t41_1 + t41_5;
  const T t41_6 = omega41_3 * omega41_2;
  const T U41_23 = t41_6 - omegadot41_1;
  const T U41_31 = t41_4 - omegadot41_2;
  const T U41_32 = t41_6 + omegadot41_1;
  const T minus_U41_33 = t41_2 + t41_5;
  // Pddot41 = E41 (U40 q41 + Pddot40): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t41_7 = Pddot40_1 + U40_12 * T(4.05) - minus_U40_11 * T(0.3);
  const T t41_8 = Pddot40_2 + U40_21 * T(0.3) - minus_U40_22 * T(4.05);
  const T Pddot41_1 = E41_11 * t41_7 + E41_12 * t41_8;
  const T Pddot41_2 = E41_11 * t41_8 - E41_12 * t41_7;
  const T Pddot41_3 = Pddot40_3 + U40_31 * T(0.3) + U40_32 * T(4.05);
  // G41 = U41 h_own_41: inertia less applied force, body axes [N]
  const T G41_1 = U41_12 * T(305.31) - minus_U41_11 * T(86.41);
  const T G41_2 = U41_21 * T(86.41) - minus_U41_22 * T(305.31);
  const T G41_3 = U41_31 * T(86.41) + U41_32 * T(305.31);
  // N41 = h_own_41~ Pddot41 + axial(U41 (tr(J_own_41)/2 - J_own_41)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N41_1 = T(305.31) * Pddot41_3 + T(639.3660000000001) * U41_32 + T(639.3660000000001) * U41_23 +
      T(61.031400000000005) * (minus_U41_22 - minus_U41_33) + T(180.4665) * U41_31 - T(17.2412) * U41_21;
  const T N41_2 = T(17.2412) * (minus_U41_33 - minus_U41_11) - (T(639.3660000000001) * U41_13 + T(53.464) * U41_31) +
      T(61.031400000000005) * U41_12 - T(180.4665) * U41_32 - T(86.41) * Pddot41_3;
  const T N41_3 = T(86.41) * Pddot41_2 - T(305.31) * Pddot41_1 + T(53.464) * U41_21 - T(639.3660000000001) * U41_12 +
      T(180.4665) * (minus_U41_11 - minus_U41_22) + T(17.2412) * U41_23 - T(61.031400000000005) * U41_13;

  // ---- body 42 (body_42) on body 41
  const T thetadot42 = y[41];
  const T thetaddot42 = ydot[41];
  // E42^T = Rot(b42, theta42): E takes components in the lower body to those in the body
  const T E42_22 = cosines[41];
  const T E42_23 = sines[41];
  // omega42 = thetadot42 b42 + E42 omega41: absolute angular velocity, body axes [rad/s]
  const T omega42_1 = thetadot42 + omega41_1;
  const T omega42_2 = E42_22 * omega41_2 + E42_23 * omega41_3;
  const T omega42_3 = E42_22 * omega41_3 - E42_23 * omega41_2;
  // omegadot42 = -thetadot42 b42~ E42 omega41 + thetaddot42 b42 + E42 omegadot41: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot42_1 = thetaddot42 + omegadot41_1;
  const T omegadot42_2 = thetadot42 * omega42_3 + E42_22 * omegadot41_2 + E42_23 * omegadot41_3;
  const T omegadot42_3 = E42_22 * omegadot41_3 - E42_23 * omegadot41_2 - thetadot42 * omega42_2;
  // U42 = omega42~ omega42~ + omegadot42~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t42_1 = omega42_3 * omega42_3;
  const T t42_2 = omega42_2 * omega42_2;
  const T minus_U42_11 = t42_1 + t42_2;
  const T t42_3 = omega42_2 * omega42_1;
  const T U42_12 = t42_3 - omegadot42_3;
  const T t42_4 = omega42_3 * omega42_1;
  const T U42_13 = t42_4 + omegadot42_2;
  const T U42_21 = t42_3 + omegadot42_3;
  const T t42_5 = omega42_1 * omega42_1;
  const T minus_U42_22 = t42_1 + t42_5;
  const T t42_6 = omega42_3 * omega42_2;
  const T U42_23 = t42_6 - omegadot42_1;
  const T U42_31 = t42_4 - omegadot42_2;
  const T U42_32 = t42_6 + omegadot42_1;
  const T minus_U42_33 = t42_2 + t42_5;
  // Pddot42 = E42 (U41 q42 + Pddot41): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot42_1 = Pddot41_1 + U41_12 * T(2.1) + U41_13 * T(0.2);
  const T t42_7 = Pddot41_2 + U41_23 * T(0.2) - minus_U41_22 * T(2.1);
  const T t42_8 = Pddot41_3 + U41_32 * T(2.1) - minus_U41_33 * T(0.2);
  const T Pddot42_2 = E42_22 * t42_7 + E42_23 * t42_8;
  const T Pddot42_3 = E42_22 * t42_8 - E42_23 * t42_7;
  // G42 = U42 h_own_42: inertia less applied force, body axes [N]
  const T G42_1 = U42_12 * T(598.135) + U42_13 * T(14.23);
  const T G42_2 = U42_23 * T(14.23) - minus_U42_22 * T(598.135);
  const T G42_3 = U42_32 * T(598.135) - minus_U42_33 * T(14.23);
  // N42 = h_own_42~ Pddot42 + axial(U42 (tr(J_own_42)/2 - J_own_42)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N42_1 = T(598.135) * Pddot42_3 - T(14.23) * Pddot42_2 + T(2585.39025) * U42_32 - T(1.7740000000000002) *
      U42_23 + T(59.782300000000006) * (minus_U42_22 - minus_U42_33) + T(358.647) * U42_31 - T(8.4704) * U42_21;
  const T N42_2 = T(14.23) * Pddot42_1 + T(1.7740000000000002) * U42_13 + T(1.7740000000000002) * U42_31 + T(8.4704) *
      (minus_U42_33 - minus_U42_11) + T(59.782300000000006) * U42_12 - T(358.647) * U42_32;
  const T N42_3 = T(358.647) * (minus_U42_11 - minus_U42_22) - (T(1.7740000000000002) * U42_21 + T(2585.39025) *
      U42_12) + T(8.4704) * U42_23 - T(59.782300000000006) * U42_13 - T(598.135) * Pddot42_1;

  // ---- body 43 (body_43) on body 42
  const T thetadot43 = y[42];
  const T thetaddot43 = ydot[42];
  // E43^T = Rot(b43, theta43): E takes components in the lower body to those in the body
  const T E43_11 = cosines[42];
  const T minus_E43_13 = sines[42];
  // omega43 = thetadot43 b43 + E43 omega42: absolute angular velocity, body axes [rad/s]
  const T omega43_1 = E43_11 * omega42_1 - minus_E43_13 * omega42_3;
  const T omega43_2 = thetadot43 + omega42_2;
  const T omega43_3 = minus_E43_13 * omega42_1 + E43_11 * omega42_3;
  // omegadot43 = -thetadot43 b43~ E43 omega42 + thetaddot43 b43 + E43 omegadot42: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot43_1 = E43_11 * omegadot42_1 - minus_E43_13 * omegadot42_3 - thetadot43 * omega43_3;
  const T omegadot43_2 = thetaddot43 + omegadot42_2;
  const T omegadot43_3 = thetadot43 * omega43_1 + minus_E43_13 * omegadot42_1 + E43_11 * omegadot42_3;
  // U43 = omega43~ omega43~ + omegadot43~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t43_1 = omega43_3 * omega43_3;
  const T t43_2 = omega43_2 * omega43_2;
  const T minus_U43_11 = t43_1 + t43_2;
  const T t43_3 = omega43_2 * omega43_1;
  const T U43_12 = t43_3 - omegadot43_3;
  const T t43_4 = omega43_3 * omega43_1;
  const T U43_13 = t43_4 + omegadot43_2;
  const T U43_21 = t43_3 + omegadot43_3;
  const T t43_5 = omega43_1 * omega43_1;
  const T minus_U43_22 = t43_1 + t43_5;
  const T t43_6 = omega43_3 * omega43_2;
  const T U43_23 = t43_6 - omegadot43_1;
  const T U43_31 = t43_4 - omegadot43_2;
  const T U43_32 = t43_6 + omegadot43_1;
  const T minus_U43_33 = t43_2 + t43_5;
  // Pddot43 = E43 (U42 q43 + Pddot42): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t43_7 = Pddot42_1 + U42_13 * T(0.1) - minus_U42_11 * T(0.6);
  const T t43_8 = Pddot42_3 + U42_31 * T(0.6) - minus_U42_33 * T(0.1);
  const T Pddot43_1 = E43_11 * t43_7 - minus_E43_13 * t43_8;
  const T Pddot43_2 = Pddot42_2 + U42_21 * T(0.6) + U42_23 * T(0.1);
  const T Pddot43_3 = minus_E43_13 * t43_7 + E43_11 * t43_8;
  // G43 = U43 h_own_43: inertia less applied force, body axes [N]
  const T G43_1 = U43_13 * T(26.875) - minus_U43_11 * T(40.85);
  const T G43_2 = U43_21 * T(40.85) + U43_23 * T(26.875);
  const T G43_3 = U43_31 * T(40.85) - minus_U43_33 * T(26.875);
  // N43 = h_own_43~ Pddot43 + axial(U43 (tr(J_own_43)/2 - J_own_43)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N43_1 = T(116.39745) * (minus_U43_22 - minus_U43_33) - (T(12.414) * U43_32 + T(659.48425) * U43_23) +
      T(176.611) * U43_31 - T(7.9936) * U43_21 - T(26.875) * Pddot43_2;
  const T N43_2 = T(26.875) * Pddot43_1 - T(40.85) * Pddot43_3 + T(659.48425) * U43_13 - T(12.414) * U43_31 +
      T(7.9936) * (minus_U43_33 - minus_U43_11) + T(116.39745) * U43_12 - T(176.611) * U43_32;
  const T N43_3 = T(40.85) * Pddot43_2 + T(12.414) * U43_21 + T(12.414) * U43_12 + T(176.611) * (minus_U43_11 -
      minus_U43_22) + T(7.9936) * U43_23 - T(116.39745) * U43_13;

  // ---- body 44 (body_44) on body 43
  const T thetadot44 = y[43];
  const T thetaddot44 = ydot[43];
  // E44^T = Rot(b44, theta44): E takes components in the lower body to those in the body
  const T E44_11 = cosines[43];
  const T E44_12 = sines[43];
  // omega44 = thetadot44 b44 + E44 omega43: absolute angular velocity, body axes [rad/s]
  const T omega44_1 = E44_11 * omega43_1 + E44_12 * omega43_2;
  const T omega44_2 = E44_11 * omega43_2 - E44_12 * omega43_1;
  const T omega44_3 = thetadot44 + omega43_3;
  // omegadot44 = -thetadot44 b44~ E44 omega43 + thetaddot44 b44 + E44 omegadot43: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot44_1 = thetadot44 * omega44_2 + E44_11 * omegadot43_1 + E44_12 * omegadot43_2;
  const T omegadot44_2 = E44_11 * omegadot43_2 - E44_12 * omegadot43_1 - thetadot44 * omega44_1;
  const T omegadot44_3 = thetaddot44 + omegadot43_3;
  // U44 = omega44~ omega44~ + omegadot44~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t44_1 = omega44_3 * omega44_3;
  const T t44_2 = omega44_2 * omega44_2;
  const T minus_U44_11 = t44_1 + t44_2;
  const T t44_3 = omega44_2 * omega44_1;
  const T U44_12 = t44_3 - omegadot44_3;
  const T t44_4 = omega44_3 * omega44_1;
  const T U44_13 = t44_4 + omegadot44_2;
  const T U44_21 = t44_3 + omegadot44_3;
  const T t44_5 = omega44_1 * omega44_1;
  const T minus_U44_22 = t44_1 + t44_5;
  const T t44_6 = omega44_3 * omega44_2;
  const T U44_23 = t44_6 - omegadot44_1;
  const T U44_31 = t44_4 - omegadot44_2;
  const T U44_32 = t44_6 + omegadot44_1;
  const T minus_U44_33 = t44_2 + t44_5;
  // Pddot44 = E44 (U43 q44 + Pddot43): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t44_7 = Pddot43_1 + U43_12 * T(4.35) - minus_U43_11 * T(0.3);
  const T t44_8 = Pddot43_2 + U43_21 * T(0.3) - minus_U43_22 * T(4.35);
  const T Pddot44_1 = E44_11 * t44_7 + E44_12 * t44_8;
  const T Pddot44_2 = E44_11 * t44_8 - E44_12 * t44_7;
  const T Pddot44_3 = Pddot43_3 + U43_31 * T(0.3) + U43_32 * T(4.35);
  // G44 = U44 h_own_44: inertia less applied force, body axes [N]
  const T G44_1 = U44_12 * T(291.33) - minus_U44_11 * T(76.84);
  const T G44_2 = U44_21 * T(76.84) - minus_U44_22 * T(291.33);
  const T G44_3 = U44_31 * T(76.84) + U44_32 * T(291.33);
  // N44 = h_own_44~ Pddot44 + axial(U44 (tr(J_own_44)/2 - J_own_44)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N44_1 = T(291.33) * Pddot44_3 + T(653.4405) * U44_32 + T(653.4405) * U44_23 + T(58.2336) * (minus_U44_22 -
      minus_U44_33) + T(171.756) * U44_31 - T(15.3248) * U44_21;
  const T N44_2 = T(15.3248) * (minus_U44_33 - minus_U44_11) - (T(653.4405) * U44_13 + T(47.57275) * U44_31) +
      T(58.2336) * U44_12 - T(171.756) * U44_32 - T(76.84) * Pddot44_3;
  const T N44_3 = T(76.84) * Pddot44_2 - T(291.33) * Pddot44_1 + T(47.57275) * U44_21 - T(653.4405) * U44_12 +
      T(171.756) * (minus_U44_11 - minus_U44_22) + T(15.3248) * U44_23 - T(58.2336) * U44_13;

  // ---- body 45 (body_45) on body 44
  const T thetadot45 = y[44];
  const T thetaddot45 = ydot[44];
  // E45^T = Rot(b45, theta45): E takes components in the lower body to those in the body
  const T E45_22 = cosines[44];
  const T E45_23 = sines[44];
  // omega45 = thetadot45 b45 + E45 omega44: absolute angular velocity, body axes [rad/s]
  const T omega45_1 = thetadot45 + omega44_1;
  const T omega45_2 = E45_22 * omega44_2 + E45_23 * omega44_3;
  const T omega45_3 = E45_22 * omega44_3 - E45_23 * omega44_2;
  // omegadot45 = -thetadot45 b45~ E45 omega44 + thetaddot45 b45 + E45 omegadot44: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot45_1 = thetaddot45 + omegadot44_1;
  const T omegadot45_2 = thetadot45 * omega45_3 + E45_22 * omegadot44_2 + E45_23 * omegadot44_3;
  const T omegadot45_3 = E45_22 * omegadot44_3 - E45_23 * omegadot44_2 - thetadot45 * omega45_2;
  // U45 = omega45~ omega45~ + omegadot45~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t45_1 = omega45_3 * omega45_3;
  const T t45_2 = omega45_2 * omega45_2;
  const T minus_U45_11 = t45_1 + t45_2;
  const T t45_3 = omega45_2 * omega45_1;
  const T U45_12 = t45_3 - omegadot45_3;
  const T t45_4 = omega45_3 * omega45_1;
  const T U45_13 = t45_4 + omegadot45_2;
  const T U45_21 = t45_3 + omegadot45_3;
  const T t45_5 = omega45_1 * omega45_1;
  const T minus_U45_22 = t45_1 + t45_5;
  const T t45_6 = omega45_3 * omega45_2;
  const T U45_23 = t45_6 - omegadot45_1;
  const T U45_31 = t45_4 - omegadot45_2;
  const T U45_32 = t45_6 + omegadot45_1;
  const T minus_U45_33 = t45_2 + t45_5;
  // Pddot45 = E45 (U44 q45 + Pddot44): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot45_1 = Pddot44_1 + U44_12 * T(2.25) + U44_13 * T(0.2);
  const T t45_7 = Pddot44_2 + U44_23 * T(0.2) - minus_U44_22 * T(2.25);
  const T t45_8 = Pddot44_3 + U44_32 * T(2.25) - minus_U44_33 * T(0.2);
  const T Pddot45_2 = E45_22 * t45_7 + E45_23 * t45_8;
  const T Pddot45_3 = E45_22 * t45_8 - E45_23 * t45_7;
  // G45 = U45 h_own_45: inertia less applied force, body axes [N]
  const T G45_1 = U45_12 * T(563.335) + U45_13 * T(12.625);
  const T G45_2 = U45_23 * T(12.625) - minus_U45_22 * T(563.335);
  const T G45_3 = U45_32 * T(563.335) - minus_U45_33 * T(12.625);
  // N45 = h_own_45~ Pddot45 + axial(U45 (tr(J_own_45)/2 - J_own_45)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N45_1 = T(563.335) * Pddot45_3 - T(12.625) * Pddot45_2 + T(2595.79275) * U45_32 - T(1.6337500000000003) *
      U45_23 + T(56.3005) * (minus_U45_22 - minus_U45_33) + T(337.7535) * U45_31 - T(7.5035) * U45_21;
  const T N45_2 = T(12.625) * Pddot45_1 + T(1.6337500000000003) * U45_13 + T(1.6337500000000003) * U45_31 + T(7.5035)
      * (minus_U45_33 - minus_U45_11) + T(56.3005) * U45_12 - T(337.7535) * U45_32;
  const T N45_3 = T(337.7535) * (minus_U45_11 - minus_U45_22) - (T(1.6337500000000003) * U45_21 + T(2595.79275) *
      U45_12) + T(7.5035) * U45_23 - T(56.3005) * U45_13 - T(563.335) * Pddot45_1;

  // ---- body 46 (body_46) on body 45
  const T thetadot46 = y[45];
  const T thetaddot46 = ydot[45];
  // E46^T = Rot(b46, theta46): E takes components in the lower body to those in the body
  const T E46_11 = cosines[45];
  const T minus_E46_13 = sines[45];
  // omega46 = thetadot46 b46 + E46 omega45: absolute angular velocity, body axes [rad/s]
  const T omega46_1 = E46_11 * omega45_1 - minus_E46_13 * omega45_3;
  const T omega46_2 = thetadot46 + omega45_2;
  const T omega46_3 = minus_E46_13 * omega45_1 + E46_11 * omega45_3;
  // omegadot46 = -thetadot46 b46~ E46 omega45 + thetaddot46 b46 + E46 omegadot45: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot46_1 = E46_11 * omegadot45_1 - minus_E46_13 * omegadot45_3 - thetadot46 * omega46_3;
  const T omegadot46_2 = thetaddot46 + omegadot45_2;
  const T omegadot46_3 = thetadot46 * omega46_1 + minus_E46_13 * omegadot45_1 + E46_11 * omegadot45_3;
  // U46 = omega46~ omega46~ + omegadot46~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t46_1 = omega46_3 * omega46_3;
  const T t46_2 = omega46_2 * omega46_2;
  const T minus_U46_11 = t46_1 + t46_2;
  const T t46_3 = omega46_2 * omega46_1;
  const T U46_12 = t46_3 - omegadot46_3;
  const T t46_4 = omega46_3 * omega46_1;
  const T U46_13 = t46_4 + omegadot46_2;
  const T U46_21 = t46_3 + omegadot46_3;
  const T t46_5 = omega46_1 * omega46_1;
  const T minus_U46_22 = t46_1 + t46_5;
  const T t46_6 = omega46_3 * omega46_2;
  const T U46_23 = t46_6 - omegadot46_1;
  const T U46_31 = t46_4 - omegadot46_2;
  const T U46_32 = t46_6 + omegadot46_1;
  const T minus_U46_33 = t46_2 + t46_5;
  // Pddot46 = E46 (U45 q46 + Pddot45): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t46_7 = Pddot45_1 + U45_13 * T(0.1) - minus_U45_11 * T(0.6);
  const T t46_8 = Pddot45_3 + U45_31 * T(0.6) - minus_U45_33 * T(0.1);
  const T Pddot46_1 = E46_11 * t46_7 - minus_E46_13 * t46_8;
  const T Pddot46_2 = Pddot45_2 + U45_21 * T(0.6) + U45_23 * T(0.1);
  const T Pddot46_3 = minus_E46_13 * t46_7 + E46_11 * t46_8;
  // G46 = U46 h_own_46: inertia less applied force, body axes [N]
  const T G46_1 = U46_13 * T(23.575000000000003) - minus_U46_11 * T(35.93);
  const T G46_2 = U46_21 * T(35.93) + U46_23 * T(23.575000000000003);
  const T G46_3 = U46_31 * T(35.93) - minus_U46_33 * T(23.575000000000003);
  // N46 = h_own_46~ Pddot46 + axial(U46 (tr(J_own_46)/2 - J_own_46)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N46_1 = T(109.04415) * (minus_U46_22 - minus_U46_33) - (T(10.947) * U46_32 + T(652.0922499999999) * U46_23)
      + T(165.8425) * U46_31 - T(6.9997) * U46_21 - T(23.575000000000003) * Pddot46_2;
  const T N46_2 = T(23.575000000000003) * Pddot46_1 - T(35.93) * Pddot46_3 + T(652.0922499999999) * U46_13 - T(10.947)
      * U46_31 + T(6.9997) * (minus_U46_33 - minus_U46_11) + T(109.04415) * U46_12 - T(165.8425) * U46_32;
  const T N46_3 = T(35.93) * Pddot46_2 + T(10.947) * U46_21 + T(10.947) * U46_12 + T(165.8425) * (minus_U46_11 -
      minus_U46_22) + T(6.9997) * U46_23 - T(109.04415) * U46_13;

  // ---- body 47 (body_47) on body 46
  const T thetadot47 = y[46];
  const T thetaddot47 = ydot[46];
  // E47^T = Rot(b47, theta47): E takes components in the lower body to those in the body
  const T E47_11 = cosines[46];
  const T E47_12 = sines[46];
  // omega47 = thetadot47 b47 + E47 omega46: absolute angular velocity, body axes [rad/s]
  const T omega47_1 = E47_11 * omega46_1 + E47_12 * omega46_2;
  const T omega47_2 = E47_11 * omega46_2 - E47_12 * omega46_1;
  const T omega47_3 = thetadot47 + omega46_3;
  // omegadot47 = -thetadot47 b47~ E47 omega46 + thetaddot47 b47 + E47 omegadot46: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot47_1 = thetadot47 * omega47_2 + E47_11 * omegadot46_1 + E47_12 * omegadot46_2;
  const T omegadot47_2 = E47_11 * omegadot46_2 - E47_12 * omegadot46_1 - thetadot47 * omega47_1;
  const T omegadot47_3 = thetaddot47 + omegadot46_3;
  // U47 = omega47~ omega47~ + omegadot47~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t47_1 = omega47_3 * omega47_3;
  const T t47_2 = omega47_2 * omega47_2;
  const T minus_U47_11 = t47_1 + t47_2;
  const T t47_3 = omega47_2 * omega47_1;
  const T U47_12 = t47_3 - omegadot47_3;
  const T t47_4 = omega47_3 * omega47_1;
  const T U47_13 = t47_4 + omegadot47_2;
  const T U47_21 = t47_3 + omegadot47_3;
  const T t47_5 = omega47_1 * omega47_1;
  const T minus_U47_22 = t47_1 + t47_5;
  const T t47_6 = omega47_3 * omega47_2;
  const T U47_23 = t47_6 - omegadot47_1;
  const T U47_31 = t47_4 - omegadot47_2;
  const T U47_32 = t47_6 + omegadot47_1;
  const T minus_U47_33 = t47_2 + t47_5;
  // Pddot47 = E47 (U46 q47 + Pddot46): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t47_7 = Pddot46_1 + U46_12 * T(4.65) - minus_U46_11 * T(0.3);
  const T t47_8 = Pddot46_2 + U46_21 * T(0.3) - minus_U46_22 * T(4.65);
  const T Pddot47_1 = E47_11 * t47_7 + E47_12 * t47_8;
  const T Pddot47_2 = E47_11 * t47_8 - E47_12 * t47_7;
  const T Pddot47_3 = Pddot46_3 + U46_31 * T(0.3) + U46_32 * T(4.65);
  // G47 = U47 h_own_47: inertia less applied force, body axes [N]
  const T G47_1 = U47_12 * T(270.42) - minus_U47_11 * T(66.73);
  const T G47_2 = U47_21 * T(66.73) - minus_U47_22 * T(270.42);
  const T G47_3 = U47_31 * T(66.73) + U47_32 * T(270.42);
  // N47 = h_own_47~ Pddot47 + axial(U47 (tr(J_own_47)/2 - J_own_47)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N47_1 = T(270.42) * Pddot47_3 + T(646.6709999999999) * U47_32 + T(646.6709999999999) * U47_23 + T(54.0498) *
      (minus_U47_22 - minus_U47_33) + T(158.8695) * U47_31 - T(13.3004) * U47_21;
  const T N47_2 = T(13.3004) * (minus_U47_33 - minus_U47_11) - (T(646.6709999999999) * U47_13 + T(41.348499999999994)
      * U47_31) + T(54.0498) * U47_12 - T(158.8695) * U47_32 - T(66.73) * Pddot47_3;
  const T N47_3 = T(66.73) * Pddot47_2 - T(270.42) * Pddot47_1 + T(41.348499999999994) * U47_21 - T(646.6709999999999)
      * U47_12 + T(158.8695) * (minus_U47_11 - minus_U47_22) + T(13.3004) * U47_23 - T(54.0498) * U47_13;

  // ---- body 48 (body_48) on body 47
  const T thetadot48 = y[47];
  const T thetaddot48 = ydot[47];
  // E48^T = Rot(b48, theta48): E takes components in the lower body to those in the body
  const T E48_22 = cosines[47];
  const T E48_23 = sines[47];
  // omega48 = thetadot48 b48 + E48 omega47: absolute angular velocity, body axes [rad/s]
  const T omega48_1 = thetadot48 + omega47_1;
  const T omega48_2 = E48_22 * omega47_2 + E48_23 * omega47_3;
  const T omega48_3 = E48_22 * omega47_3 - E48_23 * omega47_2;
  // omegadot48 = -thetadot48 b48~ E48 omega47 + thetaddot48 b48 + E48 omegadot47: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot48_1 = thetaddot48 + omegadot47_1;
  const T omegadot48_2 = thetadot48 * omega48_3 + E48_22 * omegadot47_2 + E48_23 * omegadot47_3;
  const T omegadot48_3 = E48_22 * omegadot47_3 - E48_23 * omegadot47_2 - thetadot48 * omega48_2;
  // U48 = omega48~ omega48~ + omegadot48~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t48_1 = omega48_3 * omega48_3;
  const T t48_2 = omega48_2 * omega48_2;
  const T minus_U48_11 = t48_1 + t48_2;
  const T t48_3 = omega48_2 * omega48_1;
  const T U48_12 = t48_3 - omegadot48_3;
  const T t48_4 = omega48_3 * omega48_1;
  const T U48_13 = t48_4 + omegadot48_2;
  const T U48_21 = t48_3 + omegadot48_3;
  const T t48_5 = omega48_1 * omega48_1;
  const T minus_U48_22 = t48_1 + t48_5;
  const T t48_6 = omega48_3 * omega48_2;
  const T U48_23 = t48_6 - omegadot48_1;
  const T U48_31 = t48_4 - omegadot48_2;
  const T U48_32 = t48_6 + omegadot48_1;
  const T minus_U48_33 = t48_2 + t48_5;
  // Pddot48 = E48 (U47 q48 + Pddot47): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot48_1 = Pddot47_1 + U47_12 * T(2.4) + U47_13 * T(0.2);
  const T t48_7 = Pddot47_2 + U47_23 * T(0.2) - minus_U47_22 * T(2.4);
  const T t48_8 = Pddot47_3 + U47_32 * T(2.4) - minus_U47_33 * T(0.2);
  const T Pddot48_2 = E48_22 * t48_7 + E48_23 * t48_8;
  const T Pddot48_3 = E48_22 * t48_8 - E48_23 * t48_7;
  // G48 = U48 h_own_48: inertia less applied force, body axes [N]
  const T G48_1 = U48_12 * T(514.27) + U48_13 * T(10.930000000000001);
  const T G48_2 = U48_23 * T(10.930000000000001) - minus_U48_22 * T(514.27);
  const T G48_3 = U48_32 * T(514.27) - minus_U48_33 * T(10.930000000000001);
  // N48 = h_own_48~ Pddot48 + axial(U48 (tr(J_own_48)/2 - J_own_48)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N48_1 = T(514.27) * Pddot48_3 - T(10.930000000000001) * Pddot48_2 + T(2513.916) * U48_32 -
      T(1.4845000000000002) * U48_23 + T(51.3922) * (minus_U48_22 - minus_U48_33) + T(308.301) * U48_31 -
      T(6.482600000000001) * U48_21;
  const T N48_2 = T(10.930000000000001) * Pddot48_1 + T(1.4845000000000002) * U48_13 + T(1.4845000000000002) * U48_31
      + T(6.482600000000001) * (minus_U48_33 - minus_U48_11) + T(51.3922) * U48_12 - T(308.301) * U48_32;
  const T N48_3 = T(308.301) * (minus_U48_11 - minus_U48_22) - (T(1.4845000000000002) * U48_21 + T(2513.916) * U48_12)
      + T(6.482600000000001) * U48_23 - T(51.3922) * U48_13 - T(514.27) * Pddot48_1;

  // ---- body 49 (body_49) on body 48
  const T thetadot49 = y[48];
  const T thetaddot49 = ydot[48];
  // E49^T = Rot(b49, theta49): E takes components in the lower body to those in the body
  const T E49_11 = cosines[48];
  const T minus_E49_13 = sines[48];
  // omega49 = thetadot49 b49 + E49 omega48: absolute angular velocity, body axes [rad/s]
  const T omega49_1 = E49_11 * omega48_1 - minus_E49_13 * omega48_3;
  const T omega49_2 = thetadot49 + omega48_2;
  const T omega49_3 = minus_E49_13 * omega48_1 + E49_11 * omega48_3;
  // omegadot49 = -thetadot49 b49~ E49 omega48 + thetaddot49 b49 + E49 omegadot48: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot49_1 = E49_11 * omegadot48_1 - minus_E49_13 * omegadot48_3 - thetadot49 * omega49_3;
  const T omegadot49_2 = thetaddot49 + omegadot48_2;
  const T omegadot49_3 = thetadot49 * omega49_1 + minus_E49_13 * omegadot48_1 + E49_11 * omegadot48_3;
  // U49 = omega49~ omega49~ + omegadot49~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t49_1 = omega49_3 * omega49_3;
  const T t49_2 = omega49_2 * omega49_2;
  const T minus_U49_11 = t49_1 + t49_2;
  const T t49_3 = omega49_2 * omega49_1;
  const T U49_12 = t49_3 - omegadot49_3;
  const T t49_4 = omega49_3 * omega49_1;
  const T U49_13 = t49_4 + omegadot49_2;
  const T U49_21 = t49_3 + omegadot49_3;
  const T t49_5 = omega49_1 * omega49_1;
  const T minus_U49_22 = t49_1 + t49_5;
  const T t49_6 = omega49_3 * omega49_2;
  const T U49_23 = t49_6 - omegadot49_1;
  const T U49_31 = t49_4 - omegadot49_2;
  const T U49_32 = t49_6 + omegadot49_1;
  const T minus_U49_33 = t49_2 + t49_5;
  // Pddot49 = E49 (U48 q49 + Pddot48): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t49_7 = Pddot48_1 + U48_13 * T(0.1) - minus_U48_11 * T(0.6);
  const T t49_8 = Pddot48_3 + U48_31 * T(0.6) - minus_U48_33 * T(0.1);
  const T Pddot49_1 = E49_11 * t49_7 - minus_E49_13 * t49_8;
  const T Pddot49_2 = Pddot48_2 + U48_21 * T(0.6) + U48_23 * T(0.1);
  const T Pddot49_3 = minus_E49_13 * t49_7 + E49_11 * t49_8;
  // G49 = U49 h_own_49: inertia less applied force, body axes [N]
  const T G49_1 = U49_13 * T(20.095000000000002) - minus_U49_11 * T(30.74);
  const T G49_2 = U49_21 * T(30.74) + U49_23 * T(20.095000000000002);
  const T G49_3 = U49_31 * T(30.74) - minus_U49_33 * T(20.095000000000002);
  // N49 = h_own_49~ Pddot49 + axial(U49 (tr(J_own_49)/2 - J_own_49)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N49_1 = T(98.81535000000001) * (minus_U49_22 - minus_U49_33) - (T(9.399) * U49_32 + T(619.6689999999999) *
      U49_23) + T(150.7765) * U49_31 - T(5.9518) * U49_21 - T(20.095000000000002) * Pddot49_2;
  const T N49_2 = T(20.095000000000002) * Pddot49_1 - T(30.74) * Pddot49_3 + T(619.6689999999999) * U49_13 - T(9.399)
      * U49_31 + T(5.9518) * (minus_U49_33 - minus_U49_11) + T(98.81535000000001) * U49_12 - T(150.7765) * U49_32;
  const T N49_3 = T(30.74) * Pddot49_2 + T(9.399) * U49_21 + T(9.399) * U49_12 + T(150.7765) * (minus_U49_11 -
      minus_U49_22) + T(5.9518) * U49_23 - T(98.81535000000001) * U49_13;

  // ---- body 50 (body_50) on body 49
  const T thetadot50 = y[49];
  const T thetaddot50 = ydot[49];
  // E50^T = Rot(b50, theta50): E takes components in the lower body to those in the body
  const T E50_11 = cosines[49];
  const T E50_12 = sines[49];
  // omega50 = thetadot50 b50 + E50 omega49: absolute angular velocity, body axes [rad/s]
  const T omega50_1 = E50_11 * omega49_1 + E50_12 * omega49_2;
  const T omega50_2 = E50_11 * omega49_2 - E50_12 * omega49_1;
  const T omega50_3 = thetadot50 + omega49_3;
  // omegadot50 = -thetadot50 b50~ E50 omega49 + thetaddot50 b50 + E50 omegadot49: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot50_1 = thetadot50 * omega50_2 + E50_11 * omegadot49_1 + E50_12 * omegadot49_2;
  const T omegadot50_2 = E50_11 * omegadot49_2 - E50_12 * omegadot49_1 - thetadot50 * omega50_1;
  const T omegadot50_3 = thetaddot50 + omegadot49_3;
  // U50 = omega50~ omega50~ + omegadot50~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t50_1 = omega50_3 * omega50_3;
  const T t50_2 = omega50_2 * omega50_2;
  const T minus_U50_11 = t50_1 + t50_2;
  const T t50_3 = omega50_2 * omega50_1;
  const T U50_12 = t50_3 - omegadot50_3;
  const T t50_4 = omega50_3 * omega50_1;
  const T U50_13 = t50_4 + omegadot50_2;
  const T U50_21 = t50_3 + omegadot50_3;
  const T t50_5 = omega50_1 * omega50_1;
  const T minus_U50_22 = t50_1 + t50_5;
  const T t50_6 = omega50_3 * omega50_2;
  const T U50_23 = t50_6 - omegadot50_1;
  const T U50_31 = t50_4 - omegadot50_2;
  const T U50_32 = t50_6 + omegadot50_1;
  const T minus_U50_33 = t50_2 + t50_5;
  // Pddot50 = E50 (U49 q50 + Pddot49): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t50_7 = Pddot49_1 + U49_12 * T(4.95) - minus_U49_11 * T(0.3);
  const T t50_8 = Pddot49_2 + U49_21 * T(0.3) - minus_U49_22 * T(4.95);
  const T Pddot50_1 = E50_11 * t50_7 + E50_12 * t50_8;
  const T Pddot50_2 = E50_11 * t50_8 - E50_12 * t50_7;
  const T Pddot50_3 = Pddot49_3 + U49_31 * T(0.3) + U49_32 * T(4.95);
  // G50 = U50 h_own_50: inertia less applied force, body axes [N]
  const T G50_1 = U50_12 * T(242.17499999999998) - minus_U50_11 * T(56.08);
  const T G50_2 = U50_21 * T(56.08) - minus_U50_22 * T(242.17499999999998);
  const T G50_3 = U50_31 * T(56.08) + U50_32 * T(242.17499999999998);
  // N50 = h_own_50~ Pddot50 + axial(U50 (tr(J_own_50)/2 - J_own_50)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N50_1 = T(242.17499999999998) * Pddot50_3 + T(614.9062499999999) * U50_32 + T(614.9062499999999) * U50_23 +
      T(48.399) * (minus_U50_22 - minus_U50_33) + T(141.564) * U50_31 - T(11.168000000000001) * U50_21;
  const T N50_2 = T(11.168000000000001) * (minus_U50_33 - minus_U50_11) - (T(614.9062499999999) * U50_13 + T(34.79125)
      * U50_31) + T(48.399) * U50_12 - T(141.564) * U50_32 - T(56.08) * Pddot50_3;
  const T N50_3 = T(56.08) * Pddot50_2 - T(242.17499999999998) * Pddot50_1 + T(34.79125) * U50_21 -
      T(614.9062499999999) * U50_12 + T(141.564) * (minus_U50_11 - minus_U50_22) + T(11.168000000000001) * U50_23 -
      T(48.399) * U50_13;

  // ---- body 51 (body_51) on body 50
  const T thetadot51 = y[50];
  const T thetaddot51 = ydot[50];
  // E51^T = Rot(b51, theta51): E takes components in the lower body to those in the body
  const T E51_22 = cosines[50];
  const T E51_23 = sines[50];
  // omega51 = thetadot51 b51 + E51 omega50: absolute angular velocity, body axes [rad/s]
  const T omega51_1 = thetadot51 + omega50_1;
  const T omega51_2 = E51_22 * omega50_2 + E51_23 * omega50_3;
  const T omega51_3 = E51_22 * omega50_3 - E51_23 * omega50_2;
  // omegadot51 = -thetadot51 b51~ E51 omega50 + thetaddot51 b51 + E51 omegadot50: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot51_1 = thetaddot51 + omegadot50_1;
  const T omegadot51_2 = thetadot51 * omega51_3 + E51_22 * omegadot50_2 + E51_23 * omegadot50_3;
  const T omegadot51_3 = E51_22 * omegadot50_3 - E51_23 * omegadot50_2 - thetadot51 * omega51_2;
  // U51 = omega51~ omega51~ + omegadot51~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t51_1 = omega51_3 * omega51_3;
  const T t51_2 = omega51_2 * omega51_2;
  const T minus_U51_11 = t51_1 + t51_2;
  const T t51_3 = omega51_2 * omega51_1;
  const T U51_12 = t51_3 - omegadot51_3;
  const T t51_4 = omega51_3 * omega51_1;
  const T U51_13 = t51_4 + omegadot51_2;
  const T U51_21 = t51_3 + omegadot51_3;
  const T t51_5 = omega51_1 * omega51_1;
  const T minus_U51_22 = t51_1 + t51_5;
  const T t51_6 = omega51_3 * omega51_2;
  const T U51_23 = t51_6 - omegadot51_1;
  const T U51_31 = t51_4 - omegadot51_2;
  const T U51_32 = t51_6 + omegadot51_1;
  const T minus_U51_33 = t51_2 + t51_5;
  // Pddot51 = E51 (U50 q51 + Pddot50): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot51_1 = Pddot50_1 + U50_12 * T(2.55) + U50_13 * T(0.2);
  const T t51_7 = Pddot50_2 + U50_23 * T(0.2) - minus_U50_22 * T(2.55);
  const T t51_8 = Pddot50_3 + U50_32 * T(2.55) - minus_U50_33 * T(0.2);
  const T Pddot51_2 = E51_22 * t51_7 + E51_23 * t51_8;
  const T Pddot51_3 = E51_22 * t51_8 - E51_23 * t51_7;
  // G51 = U51 h_own_51: inertia less applied force, body axes [N]
  const T G51_1 = U51_12 * T(450.13) + U51_13 * T(9.145000000000001);
  const T G51_2 = U51_23 * T(9.145000000000001) - minus_U51_22 * T(450.13);
  const T G51_3 = U51_32 * T(450.13) - minus_U51_33 * T(9.145000000000001);
  // N51 = h_own_51~ Pddot51 + axial(U51 (tr(J_own_51)/2 - J_own_51)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N51_1 = T(450.13) * Pddot51_3 - T(9.145000000000001) * Pddot51_2 + T(2322.6285) * U51_32 -
      T(1.3262500000000002) * U51_23 + T(44.976400000000005) * (minus_U51_22 - minus_U51_33) + T(269.8035) * U51_31 -
      T(5.4077) * U51_21;
  const T N51_2 = T(9.145000000000001) * Pddot51_1 + T(1.3262500000000002) * U51_13 + T(1.3262500000000002) * U51_31 +
      T(5.4077) * (minus_U51_33 - minus_U51_11) + T(44.976400000000005) * U51_12 - T(269.8035) * U51_32;
  const T N51_3 = T(269.8035) * (minus_U51_11 - minus_U51_22) - (T(1.3262500000000002) * U51_21 + T(2322.6285) *
      U51_12) + T(5.4077) * U51_23 - T(44.976400000000005) * U51_13 - T(450.13) * Pddot51_1;

  // ---- body 52 (body_52) on body 51
  const T thetadot52 = y[51];
  const T thetaddot52 = ydot[51];
  // E52^T = Rot(b52, theta52): E takes components in the lower body to those in the body
  const T E52_11 = cosines[51];
  const T minus_E52_13 = sines[51];
  // omega52 = thetadot52 b52 + E52 omega51: absolute angular velocity, body axes [rad/s]
  const T omega52_1 = E52_11 * omega51_1 - minus_E52_13 * omega51_3;
  const T omega52_2 = thetadot52 + omega51_2;
  const T omega52_3 = minus_E52_13 * omega51_1 + E52_11 * omega51_3;
  // omegadot52 = -thetadot52 b52~ E52 omega51 + thetaddot52 b52 + E52 omegadot51: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot52_1 = E52_11 * omegadot51_1 - minus_E52_13 * omegadot51_3 - thetadot52 * omega52_3;
  const T omegadot52_2 = thetaddot52 + omegadot51_2;
  const T omegadot52_3 = thetadot52 * omega52_1 + minus_E52_13 * omegadot51_1 + E52_11 * omegadot51_3;
  // U52 = omega52~ omega52~ + omegadot52~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t52_1 = omega52_3 * omega52_3;
  const T t52_2 = omega52_2 * omega52_2;
  const T minus_U52_11 = t52_1 + t52_2;
  const T t52_3 = omega52_2 * omega52_1;
  const T U52_12 = t52_3 - omegadot52_3;
  const T t52_4 = omega52_3 * omega52_1;
  const T U52_13 = t52_4 + omegadot52_2;
  const T U52_21 = t52_3 + omegadot52_3;
  const T t52_5 = omega52_1 * omega52_1;
  const T minus_U52_22 = t52_1 + t52_5;
  const T t52_6 = omega52_3 * omega52_2;
  const T U52_23 = t52_6 - omegadot52_1;
  const T U52_31 = t52_4 - omegadot52_2;
  const T U52_32 = t52_6 + omegadot52_1;
  const T minus_U52_33 = t52_2 + t52_5;
  // Pddot52 = E52 (U51 q52 + Pddot51): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t52_7 = Pddot51_1 + U51_13 * T(0.1) - minus_U51_11 * T(0.6);
  const T t52_8 = Pddot51_3 + U51_31 * T(0.6) - minus_U51_33 * T(0.1);
  const T Pddot52_1 = E52_11 * t52_7 - minus_E52_13 * t52_8;
  const T Pddot52_2 = Pddot51_2 + U51_21 * T(0.6) + U51_23 * T(0.1);
  const T Pddot52_3 = minus_E52_13 * t52_7 + E52_11 * t52_8;
  // G52 = U52 h_own_52: inertia less applied force, body axes [N]
  const T G52_1 = U52_13 * T(16.435000000000002) - minus_U52_11 * T(25.279999999999998);
  const T G52_2 = U52_21 * T(25.279999999999998) + U52_23 * T(16.435000000000002);
  const T G52_3 = U52_31 * T(25.279999999999998) - minus_U52_33 * T(16.435000000000002);
  // N52 = h_own_52~ Pddot52 + axial(U52 (tr(J_own_52)/2 - J_own_52)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N52_1 = T(85.54905000000001) * (minus_U52_22 - minus_U52_33) - (T(7.77) * U52_32 + T(557.8202500000001) *
      U52_23) + T(131.17) * U52_31 - T(4.8499) * U52_21 - T(16.435000000000002) * Pddot52_2;
  const T N52_2 = T(16.435000000000002) * Pddot52_1 - T(25.279999999999998) * Pddot52_3 + T(557.8202500000001) *
      U52_13 - T(7.77) * U52_31 + T(4.8499) * (minus_U52_33 - minus_U52_11) + T(85.54905000000001) * U52_12 -
      T(131.17) * U52_32;
  const T N52_3 = T(25.279999999999998) * Pddot52_2 + T(7.77) * U52_21 + T(7.77) * U52_12 + T(131.17) * (minus_U52_11
      - minus_U52_22) + T(4.8499) * U52_23 - T(85.54905000000001) * U52_13;

  // ---- body 53 (body_53) on body 52
  const T thetadot53 = y[52];
  const T thetaddot53 = ydot[52];
  // E53^T = Rot(b53, theta53): E takes components in the lower body to those in the body
  const T E53_11 = cosines[52];
  const T E53_12 = sines[52];
  // omega53 = thetadot53 b53 + E53 omega52: absolute angular velocity, body axes [rad/s]
  const T omega53_1 = E53_11 * omega52_1 + E53_12 * omega52_2;
  const T omega53_2 = E53_11 * omega52_2 - E53_12 * omega52_1;
  const T omega53_3 = thetadot53 + omega52_3;
  // omegadot53 = -thetadot53 b53~ E53 omega52 + thetaddot53 b53 + E53 omegadot52: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot53_1 = thetadot53 * omega53_2 + E53_11 * omegadot52_1 + E53_12 * omegadot52_2;
  const T omegadot53_2 = E53_11 * omegadot52_2 - E53_12 * omegadot52_1 - thetadot53 * omega53_1;
  const T omegadot53_3 = thetaddot53 + omegadot52_3;
  // U53 = omega53~ omega53~ + omegadot53~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t53_1 = omega53_3 * omega53_3;
  const T t53_2 = omega53_2 * omega53_2;
  const T minus_U53_11 = t53_1 + t53_2;
  const T t53_3 = omega53_2 * omega53_1;
  const T U53_12 = t53_3 - omegadot53_3;
  const T t53_4 = omega53_3 * omega53_1;
  const T U53_13 = t53_4 + omegadot53_2;
  const T U53_21 = t53_3 + omegadot53_3;
  const T t53_5 = omega53_1 * omega53_1;
  const T minus_U53_22 = t53_1 + t53_5;
  const T t53_6 = omega53_3 * omega53_2;
  const T U53_23 = t53_6 - omegadot53_1;
  const T U53_31 = t53_4 - omegadot53_2;
  const T U53_32 = t53_6 + omegadot53_1;
  const T minus_U53_33 = t53_2 + t53_5;
  // Pddot53 = E53 (U52 q53 + Pddot52): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t53_7 = Pddot52_1 + U52_12 * T(5.25) - minus_U52_11 * T(0.3);
  const T t53_8 = Pddot52_2 + U52_21 * T(0.3) - minus_U52_22 * T(5.25);
  const T Pddot53_1 = E53_11 * t53_7 + E53_12 * t53_8;
  const T Pddot53_2 = E53_11 * t53_8 - E53_12 * t53_7;
  const T Pddot53_3 = Pddot52_3 + U52_31 * T(0.3) + U52_32 * T(5.25);
  // G53 = U53 h_own_53: inertia less applied force, body axes [N]
  const T G53_1 = U53_12 * T(206.19000000000003) - minus_U53_11 * T(44.89);
  const T G53_2 = U53_21 * T(44.89) - minus_U53_22 * T(206.19000000000003);
  const T G53_3 = U53_31 * T(44.89) + U53_32 * T(206.19000000000003);
  // N53 = h_own_53~ Pddot53 + axial(U53 (tr(J_own_53)/2 - J_own_53)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N53_1 = T(206.19000000000003) * Pddot53_3 + T(553.7520000000001) * U53_32 + T(553.7520000000001) * U53_23 +
      T(41.2002) * (minus_U53_22 - minus_U53_33) + T(119.5965) * U53_31 - T(8.9276) * U53_21;
  const T N53_2 = T(8.9276) * (minus_U53_33 - minus_U53_11) - (T(553.7520000000001) * U53_13 + T(27.901) * U53_31) +
      T(41.2002) * U53_12 - T(119.5965) * U53_32 - T(44.89) * Pddot53_3;
  const T N53_3 = T(44.89) * Pddot53_2 - T(206.19000000000003) * Pddot53_1 + T(27.901) * U53_21 - T(553.7520000000001)
      * U53_12 + T(119.5965) * (minus_U53_11 - minus_U53_22) + T(8.9276) * U53_23 - T(41.2002) * U53_13;

  // ---- body 54 (body_54) on body 53
  const T thetadot54 = y[53];
  const T thetaddot54 = ydot[53];
  // E54^T = Rot(b54, theta54): E takes components in the lower body to those in the body
  const T E54_22 = cosines[53];
  const T E54_23 = sines[53];
  // omega54 = thetadot54 b54 + E54 omega53: absolute angular velocity, body axes [rad/s]
  const T omega54_1 = thetadot54 + omega53_1;
  const T omega54_2 = E54_22 * omega53_2 + E54_23 * omega53_3;
  const T omega54_3 = E54_22 * omega53_3 - E54_23 * omega53_2;
  // omegadot54 = -thetadot54 b54~ E54 omega53 + thetaddot54 b54 + E54 omegadot53: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot54_1 = thetaddot54 + omegadot53_1;
  const T omegadot54_2 = thetadot54 * omega54_3 + E54_22 * omegadot53_2 + E54_23 * omegadot53_3;
  const T omegadot54_3 = E54_22 * omegadot53_3 - E54_23 * omegadot53_2 - thetadot54 * omega54_2;
  // U54 = omega54~ omega54~ + omegadot54~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t54_1 = omega54_3 * omega54_3;
  const T t54_2 = omega54_2 * omega54_2;
  const T minus_U54_11 = t54_1 + t54_2;
  const T t54_3 = omega54_2 * omega54_1;
  const T U54_12 = t54_3 - omegadot54_3;
  const T t54_4 = omega54_3 * omega54_1;
  const T U54_13 = t54_4 + omegadot54_2;
  const T U54_21 = t54_3 + omegadot54_3;
  const T t54_5 = omega54_1 * omega54_1;
  const T minus_U54_22 = t54_1 + t54_5;
  const T t54_6 = omega54_3 * omega54_2;
  const T U54_23 = t54_6 - omegadot54_1;
  const T U54_31 = t54_4 - omegadot54_2;
  const T U54_32 = t54_6 + omegadot54_1;
  const T minus_U54_33 = t54_2 + t54_5;
  // Pddot54 = E54 (U53 q54 + Pddot53): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot54_1 = Pddot53_1 + U53_12 * T(2.7) + U53_13 * T(0.2);
  const T t54_7 = Pddot53_2 + U53_23 * T(0.2) - minus_U53_22 * T(2.7);
  const T t54_8 = Pddot53_3 + U53_32 * T(2.7) - minus_U53_33 * T(0.2);
  const T Pddot54_2 = E54_22 * t54_7 + E54_23 * t54_8;
  const T Pddot54_3 = E54_22 * t54_8 - E54_23 * t54_7;
  // G54 = U54 h_own_54: inertia less applied force, body axes [N]
  const T G54_1 = U54_12 * T(370.10499999999996) + U54_13 * T(7.2700000000000005);
  const T G54_2 = U54_23 * T(7.2700000000000005) - minus_U54_22 * T(370.10499999999996);
  const T G54_3 = U54_32 * T(370.10499999999996) - minus_U54_33 * T(7.2700000000000005);
  // N54 = h_own_54~ Pddot54 + axial(U54 (tr(J_own_54)/2 - J_own_54)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N54_1 = T(370.10499999999996) * Pddot54_3 - T(7.2700000000000005) * Pddot54_2 + T(2003.82675) * U54_32 -
      T(1.159) * U54_23 + T(36.9721) * (minus_U54_22 - minus_U54_33) + T(221.77499999999998) * U54_31 - T(4.2788) *
      U54_21;
  const T N54_2 = T(7.2700000000000005) * Pddot54_1 + T(1.159) * U54_13 + T(1.159) * U54_31 + T(4.2788) *
      (minus_U54_33 - minus_U54_11) + T(36.9721) * U54_12 - T(221.77499999999998) * U54_32;
  const T N54_3 = T(221.77499999999998) * (minus_U54_11 - minus_U54_22) - (T(1.159) * U54_21 + T(2003.82675) * U54_12)
      + T(4.2788) * U54_23 - T(36.9721) * U54_13 - T(370.10499999999996) * Pddot54_1;

  // ---- body 55 (body_55) on body 54
  const T thetadot55 = y[54];
  const T thetaddot55 = ydot[54];
  // E55^T = Rot(b55, theta55): E takes components in the lower body to those in the body
  const T E55_11 = cosines[54];
  const T minus_E55_13 = sines[54];
  // omega55 = thetadot55 b55 + E55 omega54: absolute angular velocity, body axes [rad/s]
  const T omega55_1 = E55_11 * omega54_1 - minus_E55_13 * omega54_3;
  const T omega55_2 = thetadot55 + omega54_2;
  const T omega55_3 = minus_E55_13 * omega54_1 + E55_11 * omega54_3;
  // omegadot55 = -thetadot55 b55~ E55 omega54 + thetaddot55 b55 + E55 omegadot54: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot55_1 = E55_11 * omegadot54_1 - minus_E55_13 * omegadot54_3 - thetadot55 * omega55_3;
  const T omegadot55_2 = thetaddot55 + omegadot54_2;
  const T omegadot55_3 = thetadot55 * omega55_1 + minus_E55_13 * omegadot54_1 + E55_11 * omegadot54_3;
  // U55 = omega55~ omega55~ + omegadot55~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t55_1 = omega55_3 * omega55_3;
  const T t55_2 = omega55_2 * omega55_2;
  const T minus_U55_11 = t55_1 + t55_2;
  const T t55_3 = omega55_2 * omega55_1;
  const T U55_12 = t55_3 - omegadot55_3;
  const T t55_4 = omega55_3 * omega55_1;
  const T U55_13 = t55_4 + omegadot55_2;
  const T U55_21 = t55_3 + omegadot55_3;
  const T t55_5 = omega55_1 * omega55_1;
  const T minus_U55_22 = t55_1 + t55_5;
  const T t55_6 = omega55_3 * omega55_2;
  const T U55_23 = t55_6 - omegadot55_1;
  const T U55_31 = t55_4 - omegadot55_2;
  const T U55_32 = t55_6 + omegadot55_1;
  const T minus_U55_33 = t55_2 + t55_5;
  // Pddot55 = E55 (U54 q55 + Pddot54): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t55_7 = Pddot54_1 + U54_13 * T(0.1) - minus_U54_11 * T(0.6);
  const T t55_8 = Pddot54_3 + U54_31 * T(0.6) - minus_U54_33 * T(0.1);
  const T Pddot55_1 = E55_11 * t55_7 - minus_E55_13 * t55_8;
  const T Pddot55_2 = Pddot54_2 + U54_21 * T(0.6) + U54_23 * T(0.1);
  const T Pddot55_3 = minus_E55_13 * t55_7 + E55_11 * t55_8;
  // G55 = U55 h_own_55: inertia less applied force, body axes [N]
  const T G55_1 = U55_13 * T(12.595) - minus_U55_11 * T(19.55);
  const T G55_2 = U55_21 * T(19.55) + U55_23 * T(12.595);
  const T G55_3 = U55_31 * T(19.55) - minus_U55_33 * T(12.595);
  // N55 = h_own_55~ Pddot55 + axial(U55 (tr(J_own_55)/2 - J_own_55)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N55_1 = T(69.08325) * (minus_U55_22 - minus_U55_33) - (T(6.06) * U55_32 + T(461.90875000000005) * U55_23) +
      T(106.77999999999999) * U55_31 - T(3.694) * U55_21 - T(12.595) * Pddot55_2;
  const T N55_2 = T(12.595) * Pddot55_1 - T(19.55) * Pddot55_3 + T(461.90875000000005) * U55_13 - T(6.06) * U55_31 +
      T(3.694) * (minus_U55_33 - minus_U55_11) + T(69.08325) * U55_12 - T(106.77999999999999) * U55_32;
  const T N55_3 = T(19.55) * Pddot55_2 + T(6.06) * U55_21 + T(6.06) * U55_12 + T(106.77999999999999) * (minus_U55_11 -
      minus_U55_22) + T(3.694) * U55_23 - T(69.08325) * U55_13;

  // ---- body 56 (body_56) on body 55
  const T thetadot56 = y[55];
  const T thetaddot56 = ydot[55];
  // E56^T = Rot(b56, theta56): E takes components in the lower body to those in the body
  const T E56_11 = cosines[55];
  const T E56_12 = sines[55];
  // omega56 = thetadot56 b56 + E56 omega55: absolute angular velocity, body axes [rad/s]
  const T omega56_1 = E56_11 * omega55_1 + E56_12 * omega55_2;
  const T omega56_2 = E56_11 * omega55_2 - E56_12 * omega55_1;
  const T omega56_3 = thetadot56 + omega55_3;
  // omegadot56 = -thetadot56 b56~ E56 omega55 + thetaddot56 b56 + E56 omegadot55: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot56_1 = thetadot56 * omega56_2 + E56_11 * omegadot55_1 + E56_12 * omegadot55_2;
  const T omegadot56_2 = E56_11 * omegadot55_2 - E56_12 * omegadot55_1 - thetadot56 * omega56_1;
  const T omegadot56_3 = thetaddot56 + omegadot55_3;
  // U56 = omega56~ omega56~ + omegadot56~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t56_1 = omega56_3 * omega56_3;
  const T t56_2 = omega56_2 * omega56_2;
  const T minus_U56_11 = t56_1 + t56_2;
  const T t56_3 = omega56_2 * omega56_1;
  const T U56_12 = t56_3 - omegadot56_3;
  const T t56_4 = omega56_3 * omega56_1;
  const T U56_13 = t56_4 + omegadot56_2;
  const T U56_21 = t56_3 + omegadot56_3;
  const T t56_5 = omega56_1 * omega56_1;
  const T minus_U56_22 = t56_1 + t56_5;
  const T t56_6 = omega56_3 * omega56_2;
  const T U56_23 = t56_6 - omegadot56_1;
  const T U56_31 = t56_4 - omegadot56_2;
  const T U56_32 = t56_6 + omegadot56_1;
  const T minus_U56_33 = t56_2 + t56_5;
  // Pddot56 = E56 (U55 q56 + Pddot55): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t56_7 = Pddot55_1 + U55_12 * T(5.55) - minus_U55_11 * T(0.3);
  const T t56_8 = Pddot55_2 + U55_21 * T(0.3) - minus_U55_22 * T(5.55);
  const T Pddot56_1 = E56_11 * t56_7 + E56_12 * t56_8;
  const T Pddot56_2 = E56_11 * t56_8 - E56_12 * t56_7;
  const T Pddot56_3 = Pddot55_3 + U55_31 * T(0.3) + U55_32 * T(5.55);
  // G56 = U56 h_own_56: inertia less applied force, body axes [N]
  const T G56_1 = U56_12 * T(162.06) - minus_U56_11 * T(33.16);
  const T G56_2 = U56_21 * T(33.16) - minus_U56_22 * T(162.06);
  const T G56_3 = U56_31 * T(33.16) + U56_32 * T(162.06);
  // N56 = h_own_56~ Pddot56 + axial(U56 (tr(J_own_56)/2 - J_own_56)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N56_1 = T(162.06) * Pddot56_3 + T(458.571) * U56_32 + T(458.571) * U56_23 + T(32.372400000000006) *
      (minus_U56_22 - minus_U56_33) + T(92.724) * U56_31 - T(6.5792) * U56_21;
  const T N56_2 = T(6.5792) * (minus_U56_33 - minus_U56_11) - (T(458.571) * U56_13 + T(20.67775) * U56_31) +
      T(32.372400000000006) * U56_12 - T(92.724) * U56_32 - T(33.16) * Pddot56_3;
  const T N56_3 = T(33.16) * Pddot56_2 - T(162.06) * Pddot56_1 + T(20.67775) * U56_21 - T(458.571) * U56_12 +
      T(92.724) * (minus_U56_11 - minus_U56_22) + T(6.5792) * U56_23 - T(32.372400000000006) * U56_13;

  // ---- body 57 (body_57) on body 56
  const T thetadot57 = y[56];
  const T thetaddot57 = ydot[56];
  // E57^T = Rot(b57, theta57): E takes components in the lower body to those in the body
  const T E57_22 = cosines[56];
  const T E57_23 = sines[56];
  // omega57 = thetadot57 b57 + E57 omega56: absolute angular velocity, body axes [rad/s]
  const T omega57_1 = thetadot57 + omega56_1;
  const T omega57_2 = E57_22 * omega56_2 + E57_23 * omega56_3;
  const T omega57_3 = E57_22 * omega56_3 - E57_23 * omega56_2;
  // omegadot57 = -thetadot57 b57~ E57 omega56 + thetaddot57 b57 + E57 omegadot56: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot57_1 = thetaddot57 + omegadot56_1;
  const T omegadot57_2 = thetadot57 * omega57_3 + E57_22 * omegadot56_2 + E57_23 * omegadot56_3;
  const T omegadot57_3 = E57_22 * omegadot56_3 - E57_23 * omegadot56_2 - thetadot57 * omega57_2;
  // U57 = omega57~ omega57~ + omegadot57~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t57_1 = omega57_3 * omega57_3;
  const T t57_2 = omega57_2 * omega57_2;
  const T minus_U57_11 = t57_1 + t57_2;
  const T t57_3 = omega57_2 * omega57_1;
  const T U57_12 = t57_3 - omegadot57_3;
  const T t57_4 = omega57_3 * omega57_1;
  const T U57_13 = t57_4 + omegadot57_2;
  const T U57_21 = t57_3 + omegadot57_3;
  const T t57_5 = omega57_1 * omega57_1;
  const T minus_U57_22 = t57_1 + t57_5;
  const T t57_6 = omega57_3 * omega57_2;
  const T U57_23 = t57_6 - omegadot57_1;
  const T U57_31 = t57_4 - omegadot57_2;
  const T U57_32 = t57_6 + omegadot57_1;
  const T minus_U57_33 = t57_2 + t57_5;
  // Pddot57 = E57 (U56 q57 + Pddot56): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot57_1 = Pddot56_1 + U56_12 * T(2.85) + U56_13 * T(0.2);
  const T t57_7 = Pddot56_2 + U56_23 * T(0.2) - minus_U56_22 * T(2.85);
  const T t57_8 = Pddot56_3 + U56_32 * T(2.85) - minus_U56_33 * T(0.2);
  const T Pddot57_2 = E57_22 * t57_7 + E57_23 * t57_8;
  const T Pddot57_3 = E57_22 * t57_8 - E57_23 * t57_7;
  // G57 = U57 h_own_57: inertia less applied force, body axes [N]
  const T G57_1 = U57_12 * T(273.385) + U57_13 * T(5.305000000000001);
  const T G57_2 = U57_23 * T(5.305000000000001) - minus_U57_22 * T(273.385);
  const T G57_3 = U57_32 * T(273.385) - minus_U57_33 * T(5.305000000000001);
  // N57 = h_own_57~ Pddot57 + axial(U57 (tr(J_own_57)/2 - J_own_57)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N57_1 = T(273.385) * Pddot57_3 - T(5.305000000000001) * Pddot57_2 + T(1538.43525) * U57_32 -
      T(0.9827500000000001) * U57_23 + T(27.2983) * (minus_U57_22 - minus_U57_33) + T(163.7295) * U57_31 - T(3.0959) *
      U57_21;
  const T N57_2 = T(5.305000000000001) * Pddot57_1 + T(0.9827500000000001) * U57_13 + T(0.9827500000000001) * U57_31 +
      T(3.0959) * (minus_U57_33 - minus_U57_11) + T(27.2983) * U57_12 - T(163.7295) * U57_32;
  const T N57_3 = T(163.7295) * (minus_U57_11 - minus_U57_22) - (T(0.9827500000000001) * U57_21 + T(1538.43525) *
      U57_12) + T(3.0959) * U57_23 - T(27.2983) * U57_13 - T(273.385) * Pddot57_1;

  // ---- body 58 (body_58) on body 57
  const T thetadot58 = y[57];
  const T thetaddot58 = ydot[57];
  // E58^T = Rot(b58, theta58): E takes components in the lower body to those in the body
  const T E58_11 = cosines[57];
  const T minus_E58_13 = sines[57];
  // omega58 = thetadot58 b58 + E58 omega57: absolute angular velocity, body axes [rad/s]
  const T omega58_1 = E58_11 * omega57_1 - minus_E58_13 * omega57_3;
  const T omega58_2 = thetadot58 + omega57_2;
  const T omega58_3 = minus_E58_13 * omega57_1 + E58_11 * omega57_3;
  // omegadot58 = -thetadot58 b58~ E58 omega57 + thetaddot58 b58 + E58 omegadot57: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot58_1 = E58_11 * omegadot57_1 - minus_E58_13 * omegadot57_3 - thetadot58 * omega58_3;
  const T omegadot58_2 = thetaddot58 + omegadot57_2;
  const T omegadot58_3 = thetadot58 * omega58_1 + minus_E58_13 * omegadot57_1 + E58_11 * omegadot57_3;
  // U58 = omega58~ omega58~ + omegadot58~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t58_1 = omega58_3 * omega58_3;
  const T t58_2 = omega58_2 * omega58_2;
  const T minus_U58_11 = t58_1 + t58_2;
  const T t58_3 = omega58_2 * omega58_1;
  const T U58_12 = t58_3 - omegadot58_3;
  const T t58_4 = omega58_3 * omega58_1;
  const T U58_13 = t58_4 + omegadot58_2;
  const T U58_21 = t58_3 + omegadot58_3;
  const T t58_5 = omega58_1 * omega58_1;
  const T minus_U58_22 = t58_1 + t58_5;
  const T t58_6 = omega58_3 * omega58_2;
  const T U58_23 = t58_6 - omegadot58_1;
  const T U58_31 = t58_4 - omegadot58_2;
  const T U58_32 = t58_6 + omegadot58_1;
  const T minus_U58_33 = t58_2 + t58_5;
  // Pddot58 = E58 (U57 q58 + Pddot57): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t58_7 = Pddot57_1 + U57_13 * T(0.1) - minus_U57_11 * T(0.6);
  const T t58_8 = Pddot57_3 + U57_31 * T(0.6) - minus_U57_33 * T(0.1);
  const T Pddot58_1 = E58_11 * t58_7 - minus_E58_13 * t58_8;
  const T Pddot58_2 = Pddot57_2 + U57_21 * T(0.6) + U57_23 * T(0.1);
  const T Pddot58_3 = minus_E58_13 * t58_7 + E58_11 * t58_8;
  // G58 = U58 h_own_58: inertia less applied force, body axes [N]
  const T G58_1 = U58_13 * T(8.575000000000001) - minus_U58_11 * T(13.549999999999999);
  const T G58_2 = U58_21 * T(13.549999999999999) + U58_23 * T(8.575000000000001);
  const T G58_3 = U58_31 * T(13.549999999999999) - minus_U58_33 * T(8.575000000000001);
  // N58 = h_own_58~ Pddot58 + axial(U58 (tr(J_own_58)/2 - J_own_58)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N58_1 = T(49.255950000000006) * (minus_U58_22 - minus_U58_33) - (T(4.269) * U58_32 + T(327.05425) * U58_23)
      + T(77.3635) * U58_31 - T(2.4841) * U58_21 - T(8.575000000000001) * Pddot58_2;
  const T N58_2 = T(8.575000000000001) * Pddot58_1 - T(13.549999999999999) * Pddot58_3 + T(327.05425) * U58_13 -
      T(4.269) * U58_31 + T(2.4841) * (minus_U58_33 - minus_U58_11) + T(49.255950000000006) * U58_12 - T(77.3635) *
      U58_32;
  const T N58_3 = T(13.549999999999999) * Pddot58_2 + T(4.269) * U58_21 + T(4.269) * U58_12 + T(77.3635) *
      (minus_U58_11 - minus_U58_22) + T(2.4841) * U58_23 - T(49.255950000000006) * U58_13;

  // ---- body 59 (body_59) on body 58
  const T thetadot59 = y[58];
  const T thetaddot59 = ydot[58];
  // E59^T = Rot(b59, theta59): E takes components in the lower body to those in the body
  const T E59_11 = cosines[58];
  const T E59_12 = sines[58];
  // omega59 = thetadot59 b59 + E59 omega58: absolute angular velocity, body axes [rad/s]
  const T omega59_1 = E59_11 * omega58_1 + E59_12 * omega58_2;
  const T omega59_2 = E59_11 * omega58_2 - E59_12 * omega58_1;
  const T omega59_3 = thetadot59 + omega58_3;
  // omegadot59 = -thetadot59 b59~ E59 omega58 + thetaddot59 b59 + E59 omegadot58: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot59_1 = thetadot59 * omega59_2 + E59_11 * omegadot58_1 + E59_12 * omegadot58_2;
  const T omegadot59_2 = E59_11 * omegadot58_2 - E59_12 * omegadot58_1 - thetadot59 * omega59_1;
  const T omegadot59_3 = thetaddot59 + omegadot58_3;
  // U59 = omega59~ omega59~ + omegadot59~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t59_1 = omega59_3 * omega59_3;
  const T t59_2 = omega59_2 * omega59_2;
  const T minus_U59_11 = t59_1 + t59_2;
  const T t59_3 = omega59_2 * omega59_1;
  const T U59_12 = t59_3 - omegadot59_3;
  const T t59_4 = omega59_3 * omega59_1;
  const T U59_13 = t59_4 + omegadot59_2;
  const T U59_21 = t59_3 + omegadot59_3;
  const T t59_5 = omega59_1 * omega59_1;
  const T minus_U59_22 = t59_1 + t59_5;
  const T t59_6 = omega59_3 * omega59_2;
  const T U59_23 = t59_6 - omegadot59_1;
  const T U59_31 = t59_4 - omegadot59_2;
  const T U59_32 = t59_6 + omegadot59_1;
  const T minus_U59_33 = t59_2 + t59_5;
  // Pddot59 = E59 (U58 q59 + Pddot58): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t59_7 = Pddot58_1 + U58_12 * T(5.85) - minus_U58_11 * T(0.3);
  const T t59_8 = Pddot58_2 + U58_21 * T(0.3) - minus_U58_22 * T(5.85);
  const T Pddot59_1 = E59_11 * t59_7 + E59_12 * t59_8;
  const T Pddot59_2 = E59_11 * t59_8 - E59_12 * t59_7;
  const T Pddot59_3 = Pddot58_3 + U58_31 * T(0.3) + U58_32 * T(5.85);
  // G59 = U59 h_own_59: inertia less applied force, body axes [N]
  const T G59_1 = U59_12 * T(109.38) - minus_U59_11 * T(20.89);
  const T G59_2 = U59_21 * T(20.89) - minus_U59_22 * T(109.38);
  const T G59_3 = U59_31 * T(20.89) + U59_32 * T(109.38);
  // N59 = h_own_59~ Pddot59 + axial(U59 (tr(J_own_59)/2 - J_own_59)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N59_1 = T(109.38) * Pddot59_3 + T(324.483) * U59_32 + T(324.483) * U59_23 + T(21.834600000000002) *
      (minus_U59_22 - minus_U59_33) + T(60.7035) * U59_31 - T(4.1228) * U59_21;
  const T N59_2 = T(4.1228) * (minus_U59_33 - minus_U59_11) - (T(324.483) * U59_13 + T(13.1215) * U59_31) +
      T(21.834600000000002) * U59_12 - T(60.7035) * U59_32 - T(20.89) * Pddot59_3;
  const T N59_3 = T(20.89) * Pddot59_2 - T(109.38) * Pddot59_1 + T(13.1215) * U59_21 - T(324.483) * U59_12 +
      T(60.7035) * (minus_U59_11 - minus_U59_22) + T(4.1228) * U59_23 - T(21.834600000000002) * U59_13;

  // ---- body 60 (body_60) on body 59
  const T thetadot60 = y[59];
  const T thetaddot60 = ydot[59];
  // E60^T = Rot(b60, theta60): E takes components in the lower body to those in the body
  const T E60_22 = cosines[59];
  const T E60_23 = sines[59];
  // omega60 = thetadot60 b60 + E60 omega59: absolute angular velocity, body axes [rad/s]
  const T omega60_1 = thetadot60 + omega59_1;
  const T omega60_2 = E60_22 * omega59_2 + E60_23 * omega59_3;
  const T omega60_3 = E60_22 * omega59_3 - E60_23 * omega59_2;
  // omegadot60 = -thetadot60 b60~ E60 omega59 + thetaddot60 b60 + E60 omegadot59: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot60_1 = thetaddot60 + omegadot59_1;
  const T omegadot60_2 = thetadot60 * omega60_3 + E60_22 * omegadot59_2 + E60_23 * omegadot59_3;
  const T omegadot60_3 = E60_22 * omegadot59_3 - E60_23 * omegadot59_2 - thetadot60 * omega60_2;
  // U60 = omega60~ omega60~ + omegadot60~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t60_1 = omega60_3 * omega60_3;
  const T t60_2 = omega60_2 * omega60_2;
  const T minus_U60_11 = t60_1 + t60_2;
  const T t60_3 = omega60_2 * omega60_1;
  const T U60_12 = t60_3 - omegadot60_3;
  const T t60_4 = omega60_3 * omega60_1;
  const T U60_13 = t60_4 + omegadot60_2;
  const T U60_21 = t60_3 + omegadot60_3;
  const T t60_5 = omega60_1 * omega60_1;
  const T minus_U60_22 = t60_1 + t60_5;
  const T t60_6 = omega60_3 * omega60_2;
  const T U60_23 = t60_6 - omegadot60_1;
  const T U60_31 = t60_4 - omegadot60_2;
  const T U60_32 = t60_6 + omegadot60_1;
  const T minus_U60_33 = t60_2 + t60_5;
  // Pddot60 = E60 (U59 q60 + Pddot59): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot60_1 = Pddot59_1 + U59_12 * T(3) + U59_13 * T(0.2);
  const T t60_7 = Pddot59_2 + U59_23 * T(0.2) - minus_U59_22 * T(3);
  const T t60_8 = Pddot59_3 + U59_32 * T(3) - minus_U59_33 * T(0.2);
  const T Pddot60_2 = E60_22 * t60_7 + E60_23 * t60_8;
  const T Pddot60_3 = E60_22 * t60_8 - E60_23 * t60_7;
  // G60 = U60 h_own_60: inertia less applied force, body axes [N]
  const T G60_1 = U60_12 * T(159.16) + U60_13 * T(3.25);
  const T G60_2 = U60_23 * T(3.25) - minus_U60_22 * T(159.16);
  const T G60_3 = U60_32 * T(159.16) - minus_U60_33 * T(3.25);
  // N60 = h_own_60~ Pddot60 + axial(U60 (tr(J_own_60)/2 - J_own_60)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N60_1 = T(159.16) * Pddot60_3 - T(3.25) * Pddot60_2 + T(906.4064999999999) * U60_32 - T(0.7975) * U60_23 +
      T(15.874) * (minus_U60_22 - minus_U60_33) + T(95.181) * U60_31 - T(1.859) * U60_21;
  const T N60_2 = T(3.25) * Pddot60_1 + T(0.7975) * U60_13 + T(0.7975) * U60_31 + T(1.859) * (minus_U60_33 -
      minus_U60_11) + T(15.874) * U60_12 - T(95.181) * U60_32;
  const T N60_3 = T(95.181) * (minus_U60_11 - minus_U60_22) - (T(0.7975) * U60_21 + T(906.4064999999999) * U60_12) +
      T(1.859) * U60_23 - T(15.874) * U60_13 - T(159.16) * Pddot60_1;

  // ---- body 61 (body_61) on body 60
  const T thetadot61 = y[60];
  const T thetaddot61 = ydot[60];
  // E61^T = Rot(b61, theta61): E takes components in the lower body to those in the body
  const T E61_11 = cosines[60];
  const T minus_E61_13 = sines[60];
  // omega61 = thetadot61 b61 + E61 omega60: absolute angular velocity, body axes [rad/s]
  const T omega61_1 = E61_11 * omega60_1 - minus_E61_13 * omega60_3;
  const T omega61_2 = thetadot61 + omega60_2;
  const T omega61_3 = minus_E61_13 * omega60_1 + E61_11 * omega60_3;
  // omegadot61 = -thetadot61 b61~ E61 omega60 + thetaddot61 b61 + E61 omegadot60: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot61_1 = E61_11 * omegadot60_1 - minus_E61_13 * omegadot60_3 - thetadot61 * omega61_3;
  const T omegadot61_2 = thetaddot61 + omegadot60_2;
  const T omegadot61_3 = thetadot61 * omega61_1 + minus_E61_13 * omegadot60_1 + E61_11 * omegadot60_3;
  // U61 = omega61~ omega61~ + omegadot61~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t61_1 = omega61_3 * omega61_3;
  const T t61_2 = omega61_2 * omega61_2;
  const T minus_U61_11 = t61_1 + t61_2;
  const T t61_3 = omega61_2 * omega61_1;
  const T U61_12 = t61_3 - omegadot61_3;
  const T t61_4 = omega61_3 * omega61_1;
  const T U61_13 = t61_4 + omegadot61_2;
  const T U61_21 = t61_3 + omegadot61_3;
  const T t61_5 = omega61_1 * omega61_1;
  const T minus_U61_22 = t61_1 + t61_5;
  const T t61_6 = omega61_3 * omega61_2;
  const T U61_23 = t61_6 - omegadot61_1;
  const T U61_31 = t61_4 - omegadot61_2;
  const T U61_32 = t61_6 + omegadot61_1;
  const T minus_U61_33 = t61_2 + t61_5;
  // Pddot61 = E61 (U60 q61 + Pddot60): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t61_7 = Pddot60_1 + U60_13 * T(0.1) - minus_U60_11 * T(0.6);
  const T t61_8 = Pddot60_3 + U60_31 * T(0.6) - minus_U60_33 * T(0.1);
  const T Pddot61_1 = E61_11 * t61_7 - minus_E61_13 * t61_8;
  const T Pddot61_2 = Pddot60_2 + U60_21 * T(0.6) + U60_23 * T(0.1);
  const T Pddot61_3 = minus_E61_13 * t61_7 + E61_11 * t61_8;
  // G61 = U61 h_own_61: inertia less applied force, body axes [N]
  const T G61_1 = U61_13 * T(4.375) - minus_U61_11 * T(7.28);
  const T G61_2 = U61_21 * T(7.28) + U61_23 * T(4.375);
  const T G61_3 = U61_31 * T(7.28) - minus_U61_33 * T(4.375);
  // N61 = h_own_61~ Pddot61 + axial(U61 (tr(J_own_61)/2 - J_own_61)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N61_1 = T(25.905150000000003) * (minus_U61_22 - minus_U61_33) - (T(2.397) * U61_32 + T(148.1335) * U61_23) +
      T(42.6775) * U61_31 - T(1.2202) * U61_21 - T(4.375) * Pddot61_2;
  const T N61_2 = T(4.375) * Pddot61_1 - T(7.28) * Pddot61_3 + T(148.1335) * U61_13 - T(2.397) * U61_31 + T(1.2202) *
      (minus_U61_33 - minus_U61_11) + T(25.905150000000003) * U61_12 - T(42.6775) * U61_32;
  const T N61_3 = T(7.28) * Pddot61_2 + T(2.397) * U61_21 + T(2.397) * U61_12 + T(42.6775) * (minus_U61_11 -
      minus_U61_22) + T(1.2202) * U61_23 - T(25.905150000000003) * U61_13;

  // ---- body 62 (body_62) on body 61
  const T thetadot62 = y[61];
  const T thetaddot62 = ydot[61];
  // E62^T = Rot(b62, theta62): E takes components in the lower body to those in the body
  const T E62_11 = cosines[61];
  const T E62_12 = sines[61];
  // omega62 = thetadot62 b62 + E62 omega61: absolute angular velocity, body axes [rad/s]
  const T omega62_1 = E62_11 * omega61_1 + E62_12 * omega61_2;
  const T omega62_2 = E62_11 * omega61_2 - E62_12 * omega61_1;
  const T omega62_3 = thetadot62 + omega61_3;
  // omegadot62 = -thetadot62 b62~ E62 omega61 + thetaddot62 b62 + E62 omegadot61: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot62_1 = thetadot62 * omega62_2 + E62_11 * omegadot61_1 + E62_12 * omegadot61_2;
  const T omegadot62_2 = E62_11 * omegadot61_2 - E62_12 * omegadot61_1 - thetadot62 * omega62_1;
  const T omegadot62_3 = thetaddot62 + omegadot61_3;
  // U62 = omega62~ omega62~ + omegadot62~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t62_1 = omega62_3 * omega62_3;
  const T t62_2 = omega62_2 * omega62_2;
  const T minus_U62_11 = t62_1 + t62_2;
  const T t62_3 = omega62_2 * omega62_1;
  const T U62_12 = t62_3 - omegadot62_3;
  const T t62_4 = omega62_3 * omega62_1;
  const T U62_13 = t62_4 + omegadot62_2;
  const T U62_21 = t62_3 + omegadot62_3;
  const T t62_5 = omega62_1 * omega62_1;
  const T minus_U62_22 = t62_1 + t62_5;
  const T t62_6 = omega62_3 * omega62_2;
  const T U62_23 = t62_6 - omegadot62_1;
  const T U62_31 = t62_4 - omegadot62_2;
  const T U62_32 = t62_6 + omegadot62_1;
  const T minus_U62_33 = t62_2 + t62_5;
  // Pddot62 = E62 (U61 q62 + Pddot61): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T t62_7 = Pddot61_1 + U61_12 * T(6.15) - minus_U61_11 * T(0.3);
  const T t62_8 = Pddot61_2 + U61_21 * T(0.3) - minus_U61_22 * T(6.15);
  const T Pddot62_1 = E62_11 * t62_7 + E62_12 * t62_8;
  const T Pddot62_2 = E62_11 * t62_8 - E62_12 * t62_7;
  const T Pddot62_3 = Pddot61_3 + U61_31 * T(0.3) + U61_32 * T(6.15);
  // G62 = U62 h_own_62: inertia less applied force, body axes [N]
  const T G62_1 = U62_12 * T(47.745) - minus_U62_11 * T(8.08);
  const T G62_2 = U62_21 * T(8.08) - minus_U62_22 * T(47.745);
  const T G62_3 = U62_31 * T(8.08) + U62_32 * T(47.745);
  // N62 = h_own_62~ Pddot62 + axial(U62 (tr(J_own_62)/2 - J_own_62)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N62_1 = T(47.745) * Pddot62_3 + T(146.36475) * U62_32 + T(146.36475) * U62_23 + T(9.5058) * (minus_U62_22 -
      minus_U62_33) + T(23.291999999999998) * U62_31 - T(1.5584) * U62_21;
  const T N62_2 = T(1.5584) * (minus_U62_33 - minus_U62_11) - (T(146.36475) * U62_13 + T(5.23225) * U62_31) +
      T(9.5058) * U62_12 - T(23.291999999999998) * U62_32 - T(8.08) * Pddot62_3;
  const T N62_3 = T(8.08) * Pddot62_2 - T(47.745) * Pddot62_1 + T(5.23225) * U62_21 - T(146.36475) * U62_12 +
      T(23.291999999999998) * (minus_U62_11 - minus_U62_22) + T(1.5584) * U62_23 - T(9.5058) * U62_13;

  // ---- body 63 (body_63) on body 62
  const T thetadot63 = y[62];
  const T thetaddot63 = ydot[62];
  // E63^T = Rot(b63, theta63): E takes components in the lower body to those in the body
  const T E63_22 = cosines[62];
  const T E63_23 = sines[62];
  // omega63 = thetadot63 b63 + E63 omega62: absolute angular velocity, body axes [rad/s]
  const T omega63_1 = thetadot63 + omega62_1;
  const T omega63_2 = E63_22 * omega62_2 + E63_23 * omega62_3;
  const T omega63_3 = E63_22 * omega62_3 - E63_23 * omega62_2;
  // omegadot63 = -thetadot63 b63~ E63 omega62 + thetaddot63 b63 + E63 omegadot62: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot63_1 = thetaddot63 + omegadot62_1;
  const T omegadot63_2 = thetadot63 * omega63_3 + E63_22 * omegadot62_2 + E63_23 * omegadot62_3;
  const T omegadot63_3 = E63_22 * omegadot62_3 - E63_23 * omegadot62_2 - thetadot63 * omega63_2;
  // U63 = omega63~ omega63~ + omegadot63~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t63_1 = omega63_3 * omega63_3;
  const T t63_2 = omega63_2 * omega63_2;
  const T minus_U63_11 = t63_1 + t63_2;
  const T t63_3 = omega63_2 * omega63_1;
  const T U63_12 = t63_3 - omegadot63_3;
  const T t63_4 = omega63_3 * omega63_1;
  const T U63_13 = t63_4 + omegadot63_2;
  const T U63_21 = t63_3 + omegadot63_3;
  const T t63_5 = omega63_1 * omega63_1;
  const T minus_U63_22 = t63_1 + t63_5;
  const T t63_6 = omega63_3 * omega63_2;
  const T U63_23 = t63_6 - omegadot63_1;
  const T U63_31 = t63_4 - omegadot63_2;
  const T U63_32 = t63_6 + omegadot63_1;
  const T minus_U63_33 = t63_2 + t63_5;
  // Pddot63 = E63 (U62 q63 + Pddot62): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot63_1 = Pddot62_1 + U62_12 * T(3.15) + U62_13 * T(0.2);
  const T t63_7 = Pddot62_2 + U62_23 * T(0.2) - minus_U62_22 * T(3.15);
  const T t63_8 = Pddot62_3 + U62_32 * T(3.15) - minus_U62_33 * T(0.2);
  const T Pddot63_2 = E63_22 * t63_7 + E63_23 * t63_8;
  const T Pddot63_3 = E63_22 * t63_8 - E63_23 * t63_7;
  // G63 = U63 h_own_63: inertia less applied force, body axes [N]
  const T G63_1 = U63_12 * T(26.620000000000005) + U63_13 * T(1.105);
  const T G63_2 = U63_23 * T(1.105) - minus_U63_22 * T(26.620000000000005);
  const T G63_3 = U63_32 * T(26.620000000000005) - minus_U63_33 * T(1.105);
  // N63 = h_own_63~ Pddot63 + axial(U63 (tr(J_own_63)/2 - J_own_63)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N63_1 = T(26.620000000000005) * Pddot63_3 - T(1.105) * Pddot63_2 + T(86.78316000000002) * U63_32 -
      T(0.6032500000000001) * U63_23 + T(2.6182000000000007) * (minus_U63_22 - minus_U63_33) + T(15.643500000000001) *
      U63_31 - T(0.5681) * U63_21;
  const T N63_2 = T(1.105) * Pddot63_1 + T(0.6032500000000001) * U63_13 + T(0.6032500000000001) * U63_31 + T(0.5681) *
      (minus_U63_33 - minus_U63_11) + T(2.6182000000000007) * U63_12 - T(15.643500000000001) * U63_32;
  const T N63_3 = T(15.643500000000001) * (minus_U63_11 - minus_U63_22) - (T(0.6032500000000001) * U63_21 +
      T(86.78316000000002) * U63_12) + T(0.5681) * U63_23 - T(2.6182000000000007) * U63_13 - T(26.620000000000005) *
      Pddot63_1;

  // ---- body 64 (body_64) on body 63
  const T thetadot64 = y[63];
  const T thetaddot64 = ydot[63];
  // E64^T = Z64^T Rot(b64, theta64): E takes components in the lower body to those in the body
  const T t64_1 = cosines[63];
  const T t64_2 = sines[63];
  const T E64_11 = T(0.44721359549995804) * t64_1 - T(0.8944271909999159) * t64_2;
  const T minus_E64_13 = T(0.8944271909999159) * t64_1 + T(0.44721359549995804) * t64_2;
  // omega64 = thetadot64 b64 + E64 omega63: absolute angular velocity, body axes [rad/s]
  const T omega64_1 = E64_11 * omega63_1 - minus_E64_13 * omega63_3;
  const T omega64_2 = thetadot64 + omega63_2;
  const T omega64_3 = minus_E64_13 * omega63_1 + E64_11 * omega63_3;
  // omegadot64 = -thetadot64 b64~ E64 omega63 + thetaddot64 b64 + E64 omegadot63: angular acceleration, body axes
  //   [rad/s^2]
  const T omegadot64_1 = E64_11 * omegadot63_1 - minus_E64_13 * omegadot63_3 - thetadot64 * omega64_3;
  const T omegadot64_2 = thetaddot64 + omegadot63_2;
  const T omegadot64_3 = thetadot64 * omega64_1 + minus_E64_13 * omegadot63_1 + E64_11 * omegadot63_3;
  // U64 = omega64~ omega64~ + omegadot64~: takes a point fixed in the body to its acceleration due to rotation, body
  //   axes [1/s^2]
  const T t64_3 = omega64_3 * omega64_3;
  const T t64_4 = omega64_2 * omega64_2;
  const T minus_U64_11 = t64_3 + t64_4;
  const T t64_5 = omega64_2 * omega64_1;
  const T U64_12 = t64_5 - omegadot64_3;
  const T t64_6 = omega64_3 * omega64_1;
  const T U64_13 = t64_6 + omegadot64_2;
  const T U64_21 = t64_5 + omegadot64_3;
  const T t64_7 = omega64_1 * omega64_1;
  const T minus_U64_22 = t64_3 + t64_7;
  const T t64_8 = omega64_3 * omega64_2;
  const T U64_23 = t64_8 - omegadot64_1;
  const T U64_31 = t64_6 - omegadot64_2;
  const T U64_32 = t64_8 + omegadot64_1;
  const T minus_U64_33 = t64_4 + t64_7;
  // Pddot64 = E64 (U63 q64 + Pddot63): acceleration of the body origin, less gravity, body axes [m/s^2]
  const T Pddot64_1 = E64_11 * (Pddot63_1 + U63_13 * T(0.1) - minus_U63_11 * T(0.6)) - minus_E64_13 * (Pddot63_3 +
      U63_31 * T(0.6) - minus_U63_33 * T(0.1));
  const T Pddot64_2 = Pddot63_2 + U63_21 * T(0.6) + U63_23 * T(0.1);
  // G64 = U64 h_own_64: inertia less applied force, body axes [N]
  const T G64_1 = U64_13 * T(0.8273451516749223);
  const T G64_2 = U64_23 * T(0.8273451516749223);
  const T minus_G64_3 = minus_U64_33 * T(0.8273451516749223);
  // N64 = h_own_64~ Pddot64 + axial(U64 (tr(J_own_64)/2 - J_own_64)): inertia less applied moment about the body
  //   origin, body axes [N m]
  const T N64_1 = T(2.793117232054538) * (minus_U64_22 - minus_U64_33) - (T(0.50616) * U64_32 + T(0.47434000000000004)
      * U64_23) - T(0.04302194788709596) * U64_31 + T(0.045880000000000025) * U64_21 - T(0.8273451516749223) *
      Pddot64_2;
  const T N64_2 = T(0.8273451516749223) * Pddot64_1 + T(0.47434000000000004) * U64_13 - T(0.50616) * U64_31 -
      T(0.045880000000000025) * (minus_U64_33 - minus_U64_11) + T(2.793117232054538) * U64_12 + T(0.04302194788709596)
      * U64_32;
  const T N64_3 = T(0.50616) * U64_21 + T(0.50616) * U64_12 - T(0.04302194788709596) * (minus_U64_11 - minus_U64_22) -
      T(0.045880000000000025) * U64_23 - T(2.793117232054538) * U64_13;

  // ---- body 64 (body_64) and what it carries
  // r_theta64 = b64 . N64 - tau_body_64_: Kane's equation of the angle [N m]
  const T r_theta64 = N64_2 - u.tau_64;
  r[63] = r_theta64;

  // ---- body 63 (body_63) and what it carries
  // S63 = E64^T G64 + G63: sum of the force balances of the subtree, body axes [N]
  const T b63_1 = E64_11 * G64_1 - minus_E64_13 * minus_G64_3;
  const T S63_1 = b63_1 + G63_1;
  const T S63_2 = G64_2 + G63_2;
  const T b63_2 = minus_E64_13 * G64_1 + E64_11 * minus_G64_3;
  const T S63_3 = G63_3 - b63_2;
  // rho63 = q64~ E64^T G64 + E64^T N64 + N63: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho63_1 = N63_1 + E64_11 * N64_1 + minus_E64_13 * N64_3 - T(0.1) * G64_2;
  const T rho63_2 = N64_2 + N63_2 + T(0.1) * b63_1 + T(0.6) * b63_2;
  const T rho63_3 = N63_3 + T(0.6) * G64_2 + E64_11 * N64_3 - minus_E64_13 * N64_1;
  // r_theta63 = b63 . rho63 - tau_body_63_: Kane's equation of the angle [N m]
  const T r_theta63 = rho63_1 - u.tau_63;
  r[62] = r_theta63;

  // ---- body 62 (body_62) and what it carries
  // S62 = E63^T S63 + G62: sum of the force balances of the subtree, body axes [N]
  const T S62_1 = S63_1 + G62_1;
  const T b62_1 = E63_22 * S63_2 - E63_23 * S63_3;
  const T S62_2 = b62_1 + G62_2;
  const T b62_2 = E63_23 * S63_2 + E63_22 * S63_3;
  const T S62_3 = b62_2 + G62_3;
  // rho62 = q63~ E63^T S63 + E63^T rho63 + N62: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho62_1 = rho63_1 + N62_1 + T(3.15) * b62_2 - T(0.2) * b62_1;
  const T rho62_2 = N62_2 + T(0.2) * S63_1 + E63_22 * rho63_2 - E63_23 * rho63_3;
  const T rho62_3 = N62_3 + E63_23 * rho63_2 + E63_22 * rho63_3 - T(3.15) * S63_1;
  // r_theta62 = b62 . rho62 - tau_body_62_: Kane's equation of the angle [N m]
  const T r_theta62 = rho62_3 - u.tau_62;
  r[61] = r_theta62;

  // ---- body 61 (body_61) and what it carries
  // S61 = E62^T S62 + G61: sum of the force balances of the subtree, body axes [N]
  const T b61_1 = E62_11 * S62_1 - E62_12 * S62_2;
  const T S61_1 = b61_1 + G61_1;
  const T b61_2 = E62_12 * S62_1 + E62_11 * S62_2;
  const T S61_2 = b61_2 + G61_2;
  const T S61_3 = S62_3 + G61_3;
  // rho61 = q62~ E62^T S62 + E62^T rho62 + N61: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho61_1 = N61_1 + T(6.15) * S62_3 + E62_11 * rho62_1 - E62_12 * rho62_2;
  const T rho61_2 = N61_2 + E62_12 * rho62_1 + E62_11 * rho62_2 - T(0.3) * S62_3;
  const T rho61_3 = rho62_3 + N61_3 + T(0.3) * b61_2 - T(6.15) * b61_1;
  // r_theta61 = b61 . rho61 - tau_body_61_: Kane's equation of the angle [N m]
  const T r_theta61 = rho61_2 - u.tau_61;
  r[60] = r_theta61;

  // ---- body 60 (body_60) and what it carries
  // S60 = E61^T S61 + G60: sum of the force balances of the subtree, body axes [N]
  const T b60_1 = E61_11 * S61_1 + minus_E61_13 * S61_3;
  const T S60_1 = b60_1 + G60_1;
  const T S60_2 = S61_2 + G60_2;
  const T b60_2 = E61_11 * S61_3 - minus_E61_13 * S61_1;
  const T S60_3 = b60_2 + G60_3;
  // rho60 = q61~ E61^T S61 + E61^T rho61 + N60: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho60_1 = N60_1 + E61_11 * rho61_1 + minus_E61_13 * rho61_3 - T(0.1) * S61_2;
  const T rho60_2 = rho61_2 + N60_2 + T(0.1) * b60_1 - T(0.6) * b60_2;
  const T rho60_3 = N60_3 + T(0.6) * S61_2 + E61_11 * rho61_3 - minus_E61_13 * rho61_1;
  // r_theta60 = b60 . rho60 - tau_body_60_: Kane's equation of the angle [N m]
  const T r_theta60 = rho60_1 - u.tau_60;
  r[59] = r_theta60;

  // ---- body 59 (body_59) and what it carries
  // S59 = E60^T S60 + G59: sum of the force balances of the subtree, body axes [N]
  const T S59_1 = S60_1 + G59_1;
  const T b59_1 = E60_22 * S60_2 - E60_23 * S60_3;
  const T S59_2 = b59_1 + G59_2;
  const T b59_2 = E60_23 * S60_2 + E60_22 * S60_3;
  const T S59_3 = b59_2 + G59_3;
  // rho59 = q60~ E60^T S60 + E60^T rho60 + N59: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho59_1 = rho60_1 + N59_1 + T(3) * b59_2 - T(0.2) * b59_1;
  const T rho59_2 = N59_2 + T(0.2) * S60_1 + E60_22 * rho60_2 - E60_23 * rho60_3;
  const T rho59_3 = N59_3 + E60_23 * rho60_2 + E60_22 * rho60_3 - T(3) * S60_1;
  // r_theta59 = b59 . rho59 - tau_body_59_: Kane's equation of the angle [N m]
  const T r_theta59 = rho59_3 - u.tau_59;
  r[58] = r_theta59;

  // ---- body 58 (body_58) and what it carries
  // S58 = E59^T S59 + G58: sum of the force balances of the subtree, body axes [N]
  const T b58_1 = E59_11 * S59_1 - E59_12 * S59_2;
  const T S58_1 = b58_1 + G58_1;
  const T b58_2 = E59_12 * S59_1 + E59_11 * S59_2;
  const T S58_2 = b58_2 + G58_2;
  const T S58_3 = S59_3 + G58_3;
  // rho58 = q59~ E59^T S59 + E59^T rho59 + N58: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho58_1 = N58_1 + T(5.85) * S59_3 + E59_11 * rho59_1 - E59_12 * rho59_2;
  const T rho58_2 = N58_2 + E59_12 * rho59_1 + E59_11 * rho59_2 - T(0.3) * S59_3;
  const T rho58_3 = rho59_3 + N58_3 + T(0.3) * b58_2 - T(5.85) * b58_1;
  // r_theta58 = b58 . rho58 - tau_body_58_: Kane's equation of the angle [N m]
  const T r_theta58 = rho58_2 - u.tau_58;
  r[57] = r_theta58;

  // ---- body 57 (body_57) and what it carries
  // S57 = E58^T S58 + G57: sum of the force balances of the subtree, body axes [N]
  const T b57_1 = E58_11 * S58_1 + minus_E58_13 * S58_3;
  const T S57_1 = b57_1 + G57_1;
  const T S57_2 = S58_2 + G57_2;
  const T b57_2 = E58_11 * S58_3 - minus_E58_13 * S58_1;
  const T S57_3 = b57_2 + G57_3;
  // rho57 = q58~ E58^T S58 + E58^T rho58 + N57: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho57_1 = N57_1 + E58_11 * rho58_1 + minus_E58_13 * rho58_3 - T(0.1) * S58_2;
  const T rho57_2 = rho58_2 + N57_2 + T(0.1) * b57_1 - T(0.6) * b57_2;
  const T rho57_3 = N57_3 + T(0.6) * S58_2 + E58_11 * rho58_3 - minus_E58_13 * rho58_1;
  // r_theta57 = b57 . rho57 - tau_body_57_: Kane's equation of the angle [N m]
  const T r_theta57 = rho57_1 - u.tau_57;
  r[56] = r_theta57;

  // ---- body 56 (body_56) and what it carries
  // S56 = E57^T S57 + G56: sum of the force balances of the subtree, body axes [N]
  const T S56_1 = S57_1 + G56_1;
  const T b56_1 = E57_22 * S57_2 - E57_23 * S57_3;
  const T S56_2 = b56_1 + G56_2;
  const T b56_2 = E57_23 * S57_2 + E57_22 * S57_3;
  const T S56_3 = b56_2 + G56_3;
  // rho56 = q57~ E57^T S57 + E57^T rho57 + N56: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho56_1 = rho57_1 + N56_1 + T(2.85) * b56_2 - T(0.2) * b56_1;
  const T rho56_2 = N56_2 + T(0.2) * S57_1 + E57_22 * rho57_2 - E57_23 * rho57_3;
  const T rho56_3 = N56_3 + E57_23 * rho57_2 + E57_22 * rho57_3 - T(2.85) * S57_1;
  // r_theta56 = b56 . rho56 - tau_body_56_: Kane's equation of the angle [N m]
  const T r_theta56 = rho56_3 - u.tau_56;
  r[55] = r_theta56;

  // ---- body 55 (body_55) and what it carries
  // S55 = E56^T S56 + G55: sum of the force balances of the subtree, body axes [N]
  const T b55_1 = E56_11 * S56_1 - E56_12 * S56_2;
  const T S55_1 = b55_1 + G55_1;
  const T b55_2 = E56_12 * S56_1 + E56_11 * S56_2;
  const T S55_2 = b55_2 + G55_2;
  const T S55_3 = S56_3 + G55_3;
  // rho55 = q56~ E56^T S56 + E56^T rho56 + N55: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho55_1 = N55_1 + T(5.55) * S56_3 + E56_11 * rho56_1 - E56_12 * rho56_2;
  const T rho55_2 = N55_2 + E56_12 * rho56_1 + E56_11 * rho56_2 - T(0.3) * S56_3;
  const T rho55_3 = rho56_3 + N55_3 + T(0.3) * b55_2 - T(5.55) * b55_1;
  // r_theta55 = b55 . rho55 - tau_body_55_: Kane's equation of the angle [N m]
  const T r_theta55 = rho55_2 - u.tau_55;
  r[54] = r_theta55;

  // ---- body 54 (body_54) and what it carries
  // S54 = E55^T S55 + G54: sum of the force balances of the subtree, body axes [N]
  const T b54_1 = E55_11 * S55_1 + minus_E55_13 * S55_3;
  const T S54_1 = b54_1 + G54_1;
  const T S54_2 = S55_2 + G54_2;
  const T b54_2 = E55_11 * S55_3 - minus_E55_13 * S55_1;
  const T S54_3 = b54_2 + G54_3;
  // rho54 = q55~ E55^T S55 + E55^T rho55 + N54: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho54_1 = N54_1 + E55_11 * rho55_1 + minus_E55_13 * rho55_3 - T(0.1) * S55_2;
  const T rho54_2 = rho55_2 + N54_2 + T(0.1) * b54_1 - T(0.6) * b54_2;
  const T rho54_3 = N54_3 + T(0.6) * S55_2 + E55_11 * rho55_3 - minus_E55_13 * rho55_1;
  // r_theta54 = b54 . rho54 - tau_body_54_: Kane's equation of the angle [N m]
  const T r_theta54 = rho54_1 - u.tau_54;
  r[53] = r_theta54;

  // ---- body 53 (body_53) and what it carries
  // S53 = E54^T S54 + G53: sum of the force balances of the subtree, body axes [N]
  const T S53_1 = S54_1 + G53_1;
  const T b53_1 = E54_22 * S54_2 - E54_23 * S54_3;
  const T S53_2 = b53_1 + G53_2;
  const T b53_2 = E54_23 * S54_2 + E54_22 * S54_3;
  const T S53_3 = b53_2 + G53_3;
  // rho53 = q54~ E54^T S54 + E54^T rho54 + N53: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho53_1 = rho54_1 + N53_1 + T(2.7) * b53_2 - T(0.2) * b53_1;
  const T rho53_2 = N53_2 + T(0.2) * S54_1 + E54_22 * rho54_2 - E54_23 * rho54_3;
  const T rho53_3 = N53_3 + E54_23 * rho54_2 + E54_22 * rho54_3 - T(2.7) * S54_1;
  // r_theta53 = b53 . rho53 - tau_body_53_: Kane's equation of the angle [N m]
  const T r_theta53 = rho53_3 - u.tau_53;
  r[52] = r_theta53;

  // ---- body 52 (body_52) and what it carries
  // S52 = E53^T S53 + G52: sum of the force balances of the subtree, body axes [N]
  const T b52_1 = E53_11 * S53_1 - E53_12 * S53_2;
  const T S52_1 = b52_1 + G52_1;
  const T b52_2 = E53_12 * S53_1 + E53_11 * S53_2;
  const T S52_2 = b52_2 + G52_2;
  const T S52_3 = S53_3 + G52_3;
  // rho52 = q53~ E53^T S53 + E53^T rho53 + N52: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho52_1 = N52_1 + T(5.25) * S53_3 + E53_11 * rho53_1 - E53_12 * rho53_2;
  const T rho52_2 = N52_2 + E53_12 * rho53_1 + E53_11 * rho53_2 - T(0.3) * S53_3;
  const T rho52_3 = rho53_3 + N52_3 + T(0.3) * b52_2 - T(5.25) * b52_1;
  // r_theta52 = b52 . rho52 - tau_body_52_: Kane's equation of the angle [N m]
  const T r_theta52 = rho52_2 - u.tau_52;
  r[51] = r_theta52;

  // ---- body 51 (body_51) and what it carries
  // S51 = E52^T S52 + G51: sum of the force balances of the subtree, body axes [N]
  const T b51_1 = E52_11 * S52_1 + minus_E52_13 * S52_3;
  const T S51_1 = b51_1 + G51_1;
  const T S51_2 = S52_2 + G51_2;
  const T b51_2 = E52_11 * S52_3 - minus_E52_13 * S52_1;
  const T S51_3 = b51_2 + G51_3;
  // rho51 = q52~ E52^T S52 + E52^T rho52 + N51: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho51_1 = N51_1 + E52_11 * rho52_1 + minus_E52_13 * rho52_3 - T(0.1) * S52_2;
  const T rho51_2 = rho52_2 + N51_2 + T(0.1) * b51_1 - T(0.6) * b51_2;
  const T rho51_3 = N51_3 + T(0.6) * S52_2 + E52_11 * rho52_3 - minus_E52_13 * rho52_1;
  // r_theta51 = b51 . rho51 - tau_body_51_: Kane's equation of the angle [N m]
  const T r_theta51 = rho51_1 - u.tau_51;
  r[50] = r_theta51;

  // ---- body 50 (body_50) and what it carries
  // S50 = E51^T S51 + G50: sum of the force balances of the subtree, body axes [N]
  const T S50_1 = S51_1 + G50_1;
  const T b50_1 = E51_22 * S51_2 - E51_23 * S51_3;
  const T S50_2 = b50_1 + G50_2;
  const T b50_2 = E51_23 * S51_2 + E51_22 * S51_3;
  const T S50_3 = b50_2 + G50_3;
  // rho50 = q51~ E51^T S51 + E51^T rho51 + N50: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho50_1 = rho51_1 + N50_1 + T(2.55) * b50_2 - T(0.2) * b50_1;
  const T rho50_2 = N50_2 + T(0.2) * S51_1 + E51_22 * rho51_2 - E51_23 * rho51_3;
  const T rho50_3 = N50_3 + E51_23 * rho51_2 + E51_22 * rho51_3 - T(2.55) * S51_1;
  // r_theta50 = b50 . rho50 - tau_body_50_: Kane's equation of the angle [N m]
  const T r_theta50 = rho50_3 - u.tau_50;
  r[49] = r_theta50;

  // ---- body 49 (body_49) and what it carries
  // S49 = E50^T S50 + G49: sum of the force balances of the subtree, body axes [N]
  const T b49_1 = E50_11 * S50_1 - E50_12 * S50_2;
  const T S49_1 = b49_1 + G49_1;
  const T b49_2 = E50_12 * S50_1 + E50_11 * S50_2;
  const T S49_2 = b49_2 + G49_2;
  const T S49_3 = S50_3 + G49_3;
  // rho49 = q50~ E50^T S50 + E50^T rho50 + N49: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho49_1 = N49_1 + T(4.95) * S50_3 + E50_11 * rho50_1 - E50_12 * rho50_2;
  const T rho49_2 = N49_2 + E50_12 * rho50_1 + E50_11 * rho50_2 - T(0.3) * S50_3;
  const T rho49_3 = rho50_3 + N49_3 + T(0.3) * b49_2 - T(4.95) * b49_1;
  // r_theta49 = b49 . rho49 - tau_body_49_: Kane's equation of the angle [N m]
  const T r_theta49 = rho49_2 - u.tau_49;
  r[48] = r_theta49;

  // ---- body 48 (body_48) and what it carries
  // S48 = E49^T S49 + G48: sum of the force balances of the subtree, body axes [N]
  const T b48_1 = E49_11 * S49_1 + minus_E49_13 * S49_3;
  const T S48_1 = b48_1 + G48_1;
  const T S48_2 = S49_2 + G48_2;
  const T b48_2 = E49_11 * S49_3 - minus_E49_13 * S49_1;
  const T S48_3 = b48_2 + G48_3;
  // rho48 = q49~ E49^T S49 + E49^T rho49 + N48: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho48_1 = N48_1 + E49_11 * rho49_1 + minus_E49_13 * rho49_3 - T(0.1) * S49_2;
  const T rho48_2 = rho49_2 + N48_2 + T(0.1) * b48_1 - T(0.6) * b48_2;
  const T rho48_3 = N48_3 + T(0.6) * S49_2 + E49_11 * rho49_3 - minus_E49_13 * rho49_1;
  // r_theta48 = b48 . rho48 - tau_body_48_: Kane's equation of the angle [N m]
  const T r_theta48 = rho48_1 - u.tau_48;
  r[47] = r_theta48;

  // ---- body 47 (body_47) and what it carries
  // S47 = E48^T S48 + G47: sum of the force balances of the subtree, body axes [N]
  const T S47_1 = S48_1 + G47_1;
  const T b47_1 = E48_22 * S48_2 - E48_23 * S48_3;
  const T S47_2 = b47_1 + G47_2;
  const T b47_2 = E48_23 * S48_2 + E48_22 * S48_3;
  const T S47_3 = b47_2 + G47_3;
  // rho47 = q48~ E48^T S48 + E48^T rho48 + N47: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho47_1 = rho48_1 + N47_1 + T(2.4) * b47_2 - T(0.2) * b47_1;
  const T rho47_2 = N47_2 + T(0.2) * S48_1 + E48_22 * rho48_2 - E48_23 * rho48_3;
  const T rho47_3 = N47_3 + E48_23 * rho48_2 + E48_22 * rho48_3 - T(2.4) * S48_1;
  // r_theta47 = b47 . rho47 - tau_body_47_: Kane's equation of the angle [N m]
  const T r_theta47 = rho47_3 - u.tau_47;
  r[46] = r_theta47;

  // ---- body 46 (body_46) and what it carries
  // S46 = E47^T S47 + G46: sum of the force balances of the subtree, body axes [N]
  const T b46_1 = E47_11 * S47_1 - E47_12 * S47_2;
  const T S46_1 = b46_1 + G46_1;
  const T b46_2 = E47_12 * S47_1 + E47_11 * S47_2;
  const T S46_2 = b46_2 + G46_2;
  const T S46_3 = S47_3 + G46_3;
  // rho46 = q47~ E47^T S47 + E47^T rho47 + N46: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho46_1 = N46_1 + T(4.65) * S47_3 + E47_11 * rho47_1 - E47_12 * rho47_2;
  const T rho46_2 = N46_2 + E47_12 * rho47_1 + E47_11 * rho47_2 - T(0.3) * S47_3;
  const T rho46_3 = rho47_3 + N46_3 + T(0.3) * b46_2 - T(4.65) * b46_1;
  // r_theta46 = b46 . rho46 - tau_body_46_: Kane's equation of the angle [N m]
  const T r_theta46 = rho46_2 - u.tau_46;
  r[45] = r_theta46;

  // ---- body 45 (body_45) and what it carries
  // S45 = E46^T S46 + G45: sum of the force balances of the subtree, body axes [N]
  const T b45_1 = E46_11 * S46_1 + minus_E46_13 * S46_3;
  const T S45_1 = b45_1 + G45_1;
  const T S45_2 = S46_2 + G45_2;
  const T b45_2 = E46_11 * S46_3 - minus_E46_13 * S46_1;
  const T S45_3 = b45_2 + G45_3;
  // rho45 = q46~ E46^T S46 + E46^T rho46 + N45: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho45_1 = N45_1 + E46_11 * rho46_1 + minus_E46_13 * rho46_3 - T(0.1) * S46_2;
  const T rho45_2 = rho46_2 + N45_2 + T(0.1) * b45_1 - T(0.6) * b45_2;
  const T rho45_3 = N45_3 + T(0.6) * S46_2 + E46_11 * rho46_3 - minus_E46_13 * rho46_1;
  // r_theta45 = b45 . rho45 - tau_body_45_: Kane's equation of the angle [N m]
  const T r_theta45 = rho45_1 - u.tau_45;
  r[44] = r_theta45;

  // ---- body 44 (body_44) and what it carries
  // S44 = E45^T S45 + G44: sum of the force balances of the subtree, body axes [N]
  const T S44_1 = S45_1 + G44_1;
  const T b44_1 = E45_22 * S45_2 - E45_23 * S45_3;
  const T S44_2 = b44_1 + G44_2;
  const T b44_2 = E45_23 * S45_2 + E45_22 * S45_3;
  const T S44_3 = b44_2 + G44_3;
  // rho44 = q45~ E45^T S45 + E45^T rho45 + N44: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho44_1 = rho45_1 + N44_1 + T(2.25) * b44_2 - T(0.2) * b44_1;
  const T rho44_2 = N44_2 + T(0.2) * S45_1 + E45_22 * rho45_2 - E45_23 * rho45_3;
  const T rho44_3 = N44_3 + E45_23 * rho45_2 + E45_22 * rho45_3 - T(2.25) * S45_1;
  // r_theta44 = b44 . rho44 - tau_body_44_: Kane's equation of the angle [N m]
  const T r_theta44 = rho44_3 - u.tau_44;
  r[43] = r_theta44;

  // ---- body 43 (body_43) and what it carries
  // S43 = E44^T S44 + G43: sum of the force balances of the subtree, body axes [N]
  const T b43_1 = E44_11 * S44_1 - E44_12 * S44_2;
  const T S43_1 = b43_1 + G43_1;
  const T b43_2 = E44_12 * S44_1 + E44_11 * S44_2;
  const T S43_2 = b43_2 + G43_2;
  const T S43_3 = S44_3 + G43_3;
  // rho43 = q44~ E44^T S44 + E44^T rho44 + N43: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho43_1 = N43_1 + T(4.35) * S44_3 + E44_11 * rho44_1 - E44_12 * rho44_2;
  const T rho43_2 = N43_2 + E44_12 * rho44_1 + E44_11 * rho44_2 - T(0.3) * S44_3;
  const T rho43_3 = rho44_3 + N43_3 + T(0.3) * b43_2 - T(4.35) * b43_1;
  // r_theta43 = b43 . rho43 - tau_body_43_: Kane's equation of the angle [N m]
  const T r_theta43 = rho43_2 - u.tau_43;
  r[42] = r_theta43;

  // ---- body 42 (body_42) and what it carries
  // S42 = E43^T S43 + G42: sum of the force balances of the subtree, body axes [N]
  const T b42_1 = E43_11 * S43_1 + minus_E43_13 * S43_3;
  const T S42_1 = b42_1 + G42_1;
  const T S42_2 = S43_2 + G42_2;
  const T b42_2 = E43_11 * S43_3 - minus_E43_13 * S43_1;
  const T S42_3 = b42_2 + G42_3;
  // rho42 = q43~ E43^T S43 + E43^T rho43 + N42: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho42_1 = N42_1 + E43_11 * rho43_1 + minus_E43_13 * rho43_3 - T(0.1) * S43_2;
  const T rho42_2 = rho43_2 + N42_2 + T(0.1) * b42_1 - T(0.6) * b42_2;
  const T rho42_3 = N42_3 + T(0.6) * S43_2 + E43_11 * rho43_3 - minus_E43_13 * rho43_1;
  // r_theta42 = b42 . rho42 - tau_body_42_: Kane's equation of the angle [N m]
  const T r_theta42 = rho42_1 - u.tau_42;
  r[41] = r_theta42;

  // ---- body 41 (body_41) and what it carries
  // S41 = E42^T S42 + G41: sum of the force balances of the subtree, body axes [N]
  const T S41_1 = S42_1 + G41_1;
  const T b41_1 = E42_22 * S42_2 - E42_23 * S42_3;
  const T S41_2 = b41_1 + G41_2;
  const T b41_2 = E42_23 * S42_2 + E42_22 * S42_3;
  const T S41_3 = b41_2 + G41_3;
  // rho41 = q42~ E42^T S42 + E42^T rho42 + N41: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho41_1 = rho42_1 + N41_1 + T(2.1) * b41_2 - T(0.2) * b41_1;
  const T rho41_2 = N41_2 + T(0.2) * S42_1 + E42_22 * rho42_2 - E42_23 * rho42_3;
  const T rho41_3 = N41_3 + E42_23 * rho42_2 + E42_22 * rho42_3 - T(2.1) * S42_1;
  // r_theta41 = b41 . rho41 - tau_body_41_: Kane's equation of the angle [N m]
  const T r_theta41 = rho41_3 - u.tau_41;
  r[40] = r_theta41;

  // ---- body 40 (body_40) and what it carries
  // S40 = E41^T S41 + G40: sum of the force balances of the subtree, body axes [N]
  const T b40_1 = E41_11 * S41_1 - E41_12 * S41_2;
  const T S40_1 = b40_1 + G40_1;
  const T b40_2 = E41_12 * S41_1 + E41_11 * S41_2;
  const T S40_2 = b40_2 + G40_2;
  const T S40_3 = S41_3 + G40_3;
  // rho40 = q41~ E41^T S41 + E41^T rho41 + N40: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho40_1 = N40_1 + T(4.05) * S41_3 + E41_11 * rho41_1 - E41_12 * rho41_2;
  const T rho40_2 = N40_2 + E41_12 * rho41_1 + E41_11 * rho41_2 - T(0.3) * S41_3;
  const T rho40_3 = rho41_3 + N40_3 + T(0.3) * b40_2 - T(4.05) * b40_1;
  // r_theta40 = b40 . rho40 - tau_body_40_: Kane's equation of the angle [N m]
  const T r_theta40 = rho40_2 - u.tau_40;
  r[39] = r_theta40;

  // ---- body 39 (body_39) and what it carries
  // S39 = E40^T S40 + G39: sum of the force balances of the subtree, body axes [N]
  const T b39_1 = E40_11 * S40_1 + minus_E40_13 * S40_3;
  const T S39_1 = b39_1 + G39_1;
  const T S39_2 = S40_2 + G39_2;
  const T b39_2 = E40_11 * S40_3 - minus_E40_13 * S40_1;
  const T S39_3 = b39_2 + G39_3;
  // rho39 = q40~ E40^T S40 + E40^T rho40 + N39: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho39_1 = N39_1 + E40_11 * rho40_1 + minus_E40_13 * rho40_3 - T(0.1) * S40_2;
  const T rho39_2 = rho40_2 + N39_2 + T(0.1) * b39_1 - T(0.6) * b39_2;
  const T rho39_3 = N39_3 + T(0.6) * S40_2 + E40_11 * rho40_3 - minus_E40_13 * rho40_1;
  // r_theta39 = b39 . rho39 - tau_body_39_: Kane's equation of the angle [N m]
  const T r_theta39 = rho39_1 - u.tau_39;
  r[38] = r_theta39;

  // ---- body 38 (body_38) and what it carries
  // S38 = E39^T S39 + G38: sum of the force balances of the subtree, body axes [N]
  const T S38_1 = S39_1 + G38_1;
  const T b38_1 = E39_22 * S39_2 - E39_23 * S39_3;
  const T S38_2 = b38_1 + G38_2;
  const T b38_2 = E39_23 * S39_2 + E39_22 * S39_3;
  const T S38_3 = b38_2 + G38_3;
  // rho38 = q39~ E39^T S39 + E39^T rho39 + N38: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho38_1 = rho39_1 + N38_1 + T(1.95) * b38_2 - T(0.2) * b38_1;
  const T rho38_2 = N38_2 + T(0.2) * S39_1 + E39_22 * rho39_2 - E39_23 * rho39_3;
  const T rho38_3 = N38_3 + E39_23 * rho39_2 + E39_22 * rho39_3 - T(1.95) * S39_1;
  // r_theta38 = b38 . rho38 - tau_body_38_: Kane's equation of the angle [N m]
  const T r_theta38 = rho38_3 - u.tau_38;
  r[37] = r_theta38;

  // ---- body 37 (body_37) and what it carries
  // S37 = E38^T S38 + G37: sum of the force balances of the subtree, body axes [N]
  const T b37_1 = E38_11 * S38_1 - E38_12 * S38_2;
  const T S37_1 = b37_1 + G37_1;
  const T b37_2 = E38_12 * S38_1 + E38_11 * S38_2;
  const T S37_2 = b37_2 + G37_2;
  const T S37_3 = S38_3 + G37_3;
  // rho37 = q38~ E38^T S38 + E38^T rho38 + N37: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho37_1 = N37_1 + T(3.75) * S38_3 + E38_11 * rho38_1 - E38_12 * rho38_2;
  const T rho37_2 = N37_2 + E38_12 * rho38_1 + E38_11 * rho38_2 - T(0.3) * S38_3;
  const T rho37_3 = rho38_3 + N37_3 + T(0.3) * b37_2 - T(3.75) * b37_1;
  // r_theta37 = b37 . rho37 - tau_body_37_: Kane's equation of the angle [N m]
  const T r_theta37 = rho37_2 - u.tau_37;
  r[36] = r_theta37;

  // ---- body 36 (body_36) and what it carries
  // S36 = E37^T S37 + G36: sum of the force balances of the subtree, body axes [N]
  const T b36_1 = E37_11 * S37_1 + minus_E37_13 * S37_3;
  const T S36_1 = b36_1 + G36_1;
  const T S36_2 = S37_2 + G36_2;
  const T b36_2 = E37_11 * S37_3 - minus_E37_13 * S37_1;
  const T S36_3 = b36_2 + G36_3;
  // rho36 = q37~ E37^T S37 + E37^T rho37 + N36: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho36_1 = N36_1 + E37_11 * rho37_1 + minus_E37_13 * rho37_3 - T(0.1) * S37_2;
  const T rho36_2 = rho37_2 + N36_2 + T(0.1) * b36_1 - T(0.6) * b36_2;
  const T rho36_3 = N36_3 + T(0.6) * S37_2 + E37_11 * rho37_3 - minus_E37_13 * rho37_1;
  // r_theta36 = b36 . rho36 - tau_body_36_: Kane's equation of the angle [N m]
  const T r_theta36 = rho36_1 - u.tau_36;
  r[35] = r_theta36;

  // ---- body 35 (body_35) and what it carries
  // S35 = E36^T S36 + G35: sum of the force balances of the subtree, body axes [N]
  const T S35_1 = S36_1 + G35_1;
  const T b35_1 = E36_22 * S36_2 - E36_23 * S36_3;
  const T S35_2 = b35_1 + G35_2;
  const T b35_2 = E36_23 * S36_2 + E36_22 * S36_3;
  const T S35_3 = b35_2 + G35_3;
  // rho35 = q36~ E36^T S36 + E36^T rho36 + N35: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho35_1 = rho36_1 + N35_1 + T(1.8) * b35_2 - T(0.2) * b35_1;
  const T rho35_2 = N35_2 + T(0.2) * S36_1 + E36_22 * rho36_2 - E36_23 * rho36_3;
  const T rho35_3 = N35_3 + E36_23 * rho36_2 + E36_22 * rho36_3 - T(1.8) * S36_1;
  // r_theta35 = b35 . rho35 - tau_body_35_: Kane's equation of the angle [N m]
  const T r_theta35 = rho35_3 - u.tau_35;
  r[34] = r_theta35;

  // ---- body 34 (body_34) and what it carries
  // S34 = E35^T S35 + G34: sum of the force balances of the subtree, body axes [N]
  const T b34_1 = E35_11 * S35_1 - E35_12 * S35_2;
  const T S34_1 = b34_1 + G34_1;
  const T b34_2 = E35_12 * S35_1 + E35_11 * S35_2;
  const T S34_2 = b34_2 + G34_2;
  const T S34_3 = S35_3 + G34_3;
  // rho34 = q35~ E35^T S35 + E35^T rho35 + N34: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho34_1 = N34_1 + T(3.45) * S35_3 + E35_11 * rho35_1 - E35_12 * rho35_2;
  const T rho34_2 = N34_2 + E35_12 * rho35_1 + E35_11 * rho35_2 - T(0.3) * S35_3;
  const T rho34_3 = rho35_3 + N34_3 + T(0.3) * b34_2 - T(3.45) * b34_1;
  // r_theta34 = b34 . rho34 - tau_body_34_: Kane's equation of the angle [N m]
  const T r_theta34 = rho34_2 - u.tau_34;
  r[33] = r_theta34;

  // ---- body 33 (body_33) and what it carries
  // S33 = E34^T S34 + G33: sum of the force balances of the subtree, body axes [N]
  const T b33_1 = E34_11 * S34_1 + minus_E34_13 * S34_3;
  const T S33_1 = b33_1 + G33_1;
  const T S33_2 = S34_2 + G33_2;
  const T b33_2 = E34_11 * S34_3 - minus_E34_13 * S34_1;
  const T S33_3 = b33_2 + G33_3;
  // rho33 = q34~ E34^T S34 + E34^T rho34 + N33: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho33_1 = N33_1 + E34_11 * rho34_1 + minus_E34_13 * rho34_3 - T(0.1) * S34_2;
  const T rho33_2 = rho34_2 + N33_2 + T(0.1) * b33_1 - T(0.6) * b33_2;
  const T rho33_3 = N33_3 + T(0.6) * S34_2 + E34_11 * rho34_3 - minus_E34_13 * rho34_1;
  // r_theta33 = b33 . rho33 - tau_body_33_: Kane's equation of the angle [N m]
  const T r_theta33 = rho33_1 - u.tau_33;
  r[32] = r_theta33;

  // ---- body 32 (body_32) and what it carries
  // S32 = E33^T S33 + G32: sum of the force balances of the subtree, body axes [N]
  const T S32_1 = S33_1 + G32_1;
  const T b32_1 = E33_22 * S33_2 - E33_23 * S33_3;
  const T S32_2 = b32_1 + G32_2;
  const T b32_2 = E33_23 * S33_2 + E33_22 * S33_3;
  const T S32_3 = b32_2 + G32_3;
  // rho32 = q33~ E33^T S33 + E33^T rho33 + N32: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho32_1 = rho33_1 + N32_1 + T(1.65) * b32_2 - T(0.2) * b32_1;
  const T rho32_2 = N32_2 + T(0.2) * S33_1 + E33_22 * rho33_2 - E33_23 * rho33_3;
  const T rho32_3 = N32_3 + E33_23 * rho33_2 + E33_22 * rho33_3 - T(1.65) * S33_1;
  // r_theta32 = b32 . rho32 - tau_body_32_: Kane's equation of the angle [N m]
  const T r_theta32 = rho32_3 - u.tau_32;
  r[31] = r_theta32;

  // ---- body 31 (body_31) and what it carries
  // S31 = E32^T S32 + G31: sum of the force balances of the subtree, body axes [N]
  const T b31_1 = E32_11 * S32_1 - E32_12 * S32_2;
  const T S31_1 = b31_1 + G31_1;
  const T b31_2 = E32_12 * S32_1 + E32_11 * S32_2;
  const T S31_2 = b31_2 + G31_2;
  const T S31_3 = S32_3 + G31_3;
  // rho31 = q32~ E32^T S32 + E32^T rho32 + N31: sum of the moment balances of the subtree about the body origin, body
  //   axes [N m]
  const T rho31_1 = N31_1 + T(3.1500000000000004) * S32_3 + E32_11 * rho32_1 - E32_12 * rho32_2;
  const T rho31_2 = N31_2 + E32_12 * rho32_1 + E32_11 * rho32_2 - T(0.3) * S32_3;
  const T rho31_3 = rho32_3 + N31_3 + T(0.3) * b31_2 - T(3.1500000000000004) * b31_1;
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

}  // namespace kanec::bench_cr64
