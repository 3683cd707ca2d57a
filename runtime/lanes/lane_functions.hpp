// sqrt, sin, cos and what else expressions may call, for lanes: glibc's libmvec where it has the function for this
// target (errors of a few ulps, measured in tests/lanes), else the scalar function lane by lane. Not: arithmetic.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstring>

#include "cos_sin.hpp"
#include "lanes.hpp"

#if defined(__x86_64__) && defined(__GLIBC__) && !defined(KANEC_WITHOUT_LIBMVEC)
#define KANEC_LIBMVEC 1
#endif
#if defined(__has_builtin)
#define KANEC_HAS_BUILTIN(builtin) __has_builtin(builtin)
#else
#define KANEC_HAS_BUILTIN(builtin) 0
#endif

namespace kanec::lanes {
namespace detail {

// Every lane by the scalar function.
template <class F, class T, int N, class... More>
Lanes<T, N> each(F f, const Lanes<T, N>& a, const More&... more) noexcept {
  Lanes<T, N> result;
  for (int i = 0; i < N; ++i) result.v[i] = f(a.v[i], more.v[i]...);
  return result;
}

// The lower (0) or upper (1) half.
template <int Which, class T, int N>
Lanes<T, N / 2> half(const Lanes<T, N>& a) noexcept {
  Lanes<T, N / 2> part;
  std::memcpy(&part.v, reinterpret_cast<const char*>(&a.v) + Which * sizeof part.v, sizeof part.v);
  return part;
}

template <class T, int N>
Lanes<T, 2 * N> joined(const Lanes<T, N>& lower, const Lanes<T, N>& upper) noexcept {
  Lanes<T, 2 * N> whole;
  std::memcpy(&whole.v, &lower.v, sizeof lower.v);
  std::memcpy(reinterpret_cast<char*>(&whole.v) + sizeof lower.v, &upper.v, sizeof upper.v);
  return whole;
}

// By f, a function of vectors that fit a register: wider lanes half by half, narrower ones lane by lane with g.
template <class F, class G, class T, int N, class... More>
Lanes<T, N> by_register(F f, G g, const Lanes<T, N>& a, const More&... more) noexcept {
  constexpr int bytes = N * static_cast<int>(sizeof(T));
  if constexpr (bytes > register_bytes)
    return joined(by_register(f, g, half<0>(a), half<0>(more)...), by_register(f, g, half<1>(a), half<1>(more)...));
  else if constexpr (bytes < 16)
    return each(g, a, more...);
  else
    return Lanes<T, N>::of(f(a.v, more.v...));
}

// The vectors that functions take, and the functions themselves by overloading.
namespace in_register {

typedef double Double2 __attribute__((vector_size(16)));
typedef float Float4 __attribute__((vector_size(16)));
#if defined(__AVX2__)
typedef double Double4 __attribute__((vector_size(32)));
typedef float Float8 __attribute__((vector_size(32)));
#endif
#if defined(__AVX512F__)
typedef double Double8 __attribute__((vector_size(64)));
typedef float Float16 __attribute__((vector_size(64)));
#endif

#if KANEC_HAS_BUILTIN(__builtin_elementwise_sqrt)
#define KANEC_LANE_SQRT 1
template <class Vector>
Vector sqrt(Vector a) noexcept {
  return __builtin_elementwise_sqrt(a);
}
#elif KANEC_HAS_BUILTIN(__builtin_ia32_sqrtpd)
#define KANEC_LANE_SQRT 1
inline Double2 sqrt(Double2 a) noexcept { return __builtin_ia32_sqrtpd(a); }
inline Float4 sqrt(Float4 a) noexcept { return __builtin_ia32_sqrtps(a); }
#if defined(__AVX2__)
inline Double4 sqrt(Double4 a) noexcept { return __builtin_ia32_sqrtpd256(a); }
inline Float8 sqrt(Float8 a) noexcept { return __builtin_ia32_sqrtps256(a); }
#endif
#if defined(__AVX512F__) && defined(__clang__)
inline Double8 sqrt(Double8 a) noexcept { return __builtin_ia32_sqrtpd512(a, 4); }  // 4: rounding as it is set
inline Float16 sqrt(Float16 a) noexcept { return __builtin_ia32_sqrtps512(a, 4); }
#elif defined(__AVX512F__)
inline Double8 sqrt(Double8 a) noexcept {
  return __builtin_ia32_sqrtpd512_mask(a, a, static_cast<unsigned char>(-1), 4);
}
inline Float16 sqrt(Float16 a) noexcept {
  return __builtin_ia32_sqrtps512_mask(a, a, static_cast<unsigned short>(-1), 4);
}
#endif
#endif

// libmvec names a function by the target (b: SSE, d: AVX2, e: AVX-512), lanes and arguments: _ZGVeN8v_sin.
#if defined(KANEC_LIBMVEC)
#define KANEC_LIBMVEC_1(vector, symbol, name)                       \
  extern "C" vector symbol(vector) noexcept __attribute__((const)); \
  inline vector name(vector a) noexcept { return symbol(a); }
#define KANEC_LIBMVEC_2(vector, symbol, name)                               \
  extern "C" vector symbol(vector, vector) noexcept __attribute__((const)); \
  inline vector name(vector a, vector b) noexcept { return symbol(a, b); }
#if defined(__AVX512F__)
#define KANEC_LIBMVEC_512(n, v, name) \
  KANEC_LIBMVEC_##n(Double8, _ZGVeN8##v##_##name, name) KANEC_LIBMVEC_##n(Float16, _ZGVeN16##v##_##name##f, name)
#else
#define KANEC_LIBMVEC_512(n, v, name)
#endif
#if defined(__AVX2__)
#define KANEC_LIBMVEC_256(n, v, name) \
  KANEC_LIBMVEC_##n(Double4, _ZGVdN4##v##_##name, name) KANEC_LIBMVEC_##n(Float8, _ZGVdN8##v##_##name##f, name)
#else
#define KANEC_LIBMVEC_256(n, v, name)
#endif
#define KANEC_LIBMVEC_ALL(n, v, name)                                                                           \
  KANEC_LIBMVEC_##n(Double2, _ZGVbN2##v##_##name, name) KANEC_LIBMVEC_##n(Float4, _ZGVbN4##v##_##name##f, name) \
      KANEC_LIBMVEC_256(n, v, name) KANEC_LIBMVEC_512(n, v, name)

KANEC_LIBMVEC_ALL(1, v, sin)
KANEC_LIBMVEC_ALL(1, v, cos)
KANEC_LIBMVEC_ALL(1, v, exp)
KANEC_LIBMVEC_ALL(1, v, log)
KANEC_LIBMVEC_ALL(2, vv, pow)
#if __GLIBC_PREREQ(2, 35)
#define KANEC_LIBMVEC_235 1
KANEC_LIBMVEC_ALL(1, v, tan)
KANEC_LIBMVEC_ALL(1, v, asin)
KANEC_LIBMVEC_ALL(1, v, acos)
KANEC_LIBMVEC_ALL(1, v, tanh)
KANEC_LIBMVEC_ALL(2, vv, atan2)
#endif
#undef KANEC_LIBMVEC_1
#undef KANEC_LIBMVEC_2
#undef KANEC_LIBMVEC_256
#undef KANEC_LIBMVEC_512
#undef KANEC_LIBMVEC_ALL
#endif

}  // namespace in_register
}  // namespace detail

#define KANEC_IN_REGISTER_1(name)                                                            \
  template <class T, int N>                                                                  \
  Lanes<T, N> name(const Lanes<T, N>& a) noexcept {                                          \
    return detail::by_register([](auto v) noexcept { return detail::in_register::name(v); }, \
                               [](T x) noexcept { return std::name(x); }, a);                \
  }
#define KANEC_IN_REGISTER_2(name)                                                                       \
  template <class T, int N>                                                                             \
  Lanes<T, N> name(const Lanes<T, N>& a, const Lanes<T, N>& b) noexcept {                               \
    return detail::by_register([](auto v, auto w) noexcept { return detail::in_register::name(v, w); }, \
                               [](T x, T y) noexcept { return std::name(x, y); }, a, b);                \
  }
#define KANEC_LANE_BY_LANE_1(name)                                     \
  template <class T, int N>                                            \
  Lanes<T, N> name(const Lanes<T, N>& a) noexcept {                    \
    return detail::each([](T x) noexcept { return std::name(x); }, a); \
  }
#define KANEC_LANE_BY_LANE_2(name)                                                \
  template <class T, int N>                                                       \
  Lanes<T, N> name(const Lanes<T, N>& a, const Lanes<T, N>& b) noexcept {         \
    return detail::each([](T x, T y) noexcept { return std::name(x, y); }, a, b); \
  }

#if defined(KANEC_LANE_SQRT)
KANEC_IN_REGISTER_1(sqrt)
#else
KANEC_LANE_BY_LANE_1(sqrt)
#endif
#if defined(KANEC_LIBMVEC)
KANEC_IN_REGISTER_1(sin)
KANEC_IN_REGISTER_1(cos)
KANEC_IN_REGISTER_1(exp)
KANEC_IN_REGISTER_1(log)
KANEC_IN_REGISTER_2(pow)
#else
KANEC_LANE_BY_LANE_1(sin)
KANEC_LANE_BY_LANE_1(cos)
KANEC_LANE_BY_LANE_1(exp)
KANEC_LANE_BY_LANE_1(log)
KANEC_LANE_BY_LANE_2(pow)
#endif
#if defined(KANEC_LIBMVEC_235)
KANEC_IN_REGISTER_1(tan)
KANEC_IN_REGISTER_1(asin)
KANEC_IN_REGISTER_1(acos)
KANEC_IN_REGISTER_1(tanh)
KANEC_IN_REGISTER_2(atan2)
#else
KANEC_LANE_BY_LANE_1(tan)
KANEC_LANE_BY_LANE_1(asin)
KANEC_LANE_BY_LANE_1(acos)
KANEC_LANE_BY_LANE_1(tanh)
KANEC_LANE_BY_LANE_2(atan2)
#endif
#if defined(KANEC_COS_SIN_VECTORS)
namespace detail {

// Of lanes that are no wider than a register; wider ones half by half.
template <int N>
void cos_sin_of(const Lanes<double, N>& a, Lanes<double, N>& c, Lanes<double, N>& s) noexcept {
  if constexpr (sizeof a.v > register_bytes) {
    Lanes<double, N / 2> c0, c1, s0, s1;
    cos_sin_of(half<0>(a), c0, s0);
    cos_sin_of(half<1>(a), c1, s1);
    c = joined(c0, c1);
    s = joined(s0, s1);
  } else {
    typedef std::uint64_t Bits __attribute__((vector_size(N * sizeof(std::uint64_t))));
    kanec_cos_sin::cos_sin_of<decltype(a.v), Bits>(a.v, c.v, s.v);
  }
}

}  // namespace detail

// c = cos(a), s = sin(a) for n angles, errors below 0.95 ulps: what emitted code calls. A lane with large angles, or
// what is no number, goes by the scalar functions, whatever its neighbours hold.
template <int N>
void cos_sin(const Lanes<double, N>* a, int n, Lanes<double, N>* c, Lanes<double, N>* s) noexcept {
  Lanes<double, N> sum(0);
  for (int i = 0; i < n; ++i) {
    detail::cos_sin_of(a[i], c[i], s[i]);
    sum += abs(a[i]);
  }
  const LaneMask<double, N> small = sum <= Lanes<double, N>(4096);
  for (int lane = 0; lane < N; ++lane)
    for (int i = 0; i < n && !small[lane]; ++i) {
      c[i].set(lane, std::cos(a[i][lane]));
      s[i].set(lane, std::sin(a[i][lane]));
    }
}
#endif
#undef KANEC_IN_REGISTER_1
#undef KANEC_IN_REGISTER_2
#undef KANEC_LANE_BY_LANE_1
#undef KANEC_LANE_BY_LANE_2

}  // namespace kanec::lanes
