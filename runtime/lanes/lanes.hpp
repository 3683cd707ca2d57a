// Several numbers that are computed with at once: a scalar for emitted code. Not: functions beyond arithmetic
// (lane_functions.hpp), nor any loop over states (batch.hpp). All of it stands in kanec::lanes, where
// argument-dependent lookup finds it and no scene's namespace stands; kanec::Lanes is another name of the type.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#if !defined(__GNUC__)
#error "lanes need the vector extensions of GCC or Clang"
#endif
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC diagnostic ignored "-Wpsabi"  // everything here is inlined: no vector is passed between libraries
#endif

#include <cstdint>
#include <cstring>
#include <type_traits>

namespace kanec::lanes {

// Lanes that the target computes with in one instruction.
#if defined(__AVX512F__)
inline constexpr int register_bytes = 64;
#elif defined(__AVX2__)
inline constexpr int register_bytes = 32;
#else
inline constexpr int register_bytes = 16;
#endif
template <class T>
inline constexpr int native_lanes = register_bytes / static_cast<int>(sizeof(T));

// One truth value a lane, as comparisons give it: all bits set or none.
template <class T, int N>
struct LaneMask {
  using Integer = std::conditional_t<sizeof(T) == 8, std::int64_t, std::int32_t>;
  typedef Integer Vector __attribute__((vector_size(N * sizeof(T))));
  Vector v;

  bool operator[](int lane) const noexcept { return v[lane] != 0; }
};

// N numbers, T float or double, N a power of two; wider ones than a register are computed in several instructions.
// Arithmetic is that of T, lane by lane. There is no conversion to T and none from T but the explicit one.
template <class T, int N>
struct Lanes {
  static_assert(std::is_same_v<T, float> || std::is_same_v<T, double>, "lanes of float or double");
  static_assert(N >= 2 && (N & (N - 1)) == 0, "a power of two");

  using Scalar = T;
  using Mask = LaneMask<T, N>;
  typedef T Vector __attribute__((vector_size(N * sizeof(T))));
  static constexpr int size = N;

  Vector v;

  Lanes() = default;
  // The same number in every lane, rounded to T. By subtraction, which keeps the sign of -0.
  explicit Lanes(double number) noexcept : v(static_cast<T>(number) - Vector{}) {}

  static Lanes of(Vector vector) noexcept {
    Lanes lanes;
    lanes.v = vector;
    return lanes;
  }

  // From and to N numbers in memory, aligned or not.
  static Lanes load(const T* from) noexcept {
    Lanes lanes;
    std::memcpy(&lanes.v, from, sizeof lanes.v);
    return lanes;
  }
  void store(T* to) const noexcept { std::memcpy(to, &v, sizeof v); }

  T operator[](int lane) const noexcept { return v[lane]; }
  void set(int lane, T number) noexcept { v[lane] = number; }

  friend Lanes operator+(Lanes a) noexcept { return a; }
  friend Lanes operator-(Lanes a) noexcept { return of(-a.v); }
  friend Lanes operator+(Lanes a, Lanes b) noexcept { return of(a.v + b.v); }
  friend Lanes operator-(Lanes a, Lanes b) noexcept { return of(a.v - b.v); }
  friend Lanes operator*(Lanes a, Lanes b) noexcept { return of(a.v * b.v); }
  friend Lanes operator/(Lanes a, Lanes b) noexcept { return of(a.v / b.v); }
  Lanes& operator+=(Lanes b) noexcept { return *this = *this + b; }
  Lanes& operator-=(Lanes b) noexcept { return *this = *this - b; }
  Lanes& operator*=(Lanes b) noexcept { return *this = *this * b; }
  Lanes& operator/=(Lanes b) noexcept { return *this = *this / b; }

  friend Mask operator<(Lanes a, Lanes b) noexcept { return {a.v < b.v}; }
  friend Mask operator>(Lanes a, Lanes b) noexcept { return {a.v > b.v}; }
  friend Mask operator<=(Lanes a, Lanes b) noexcept { return {a.v <= b.v}; }
  friend Mask operator>=(Lanes a, Lanes b) noexcept { return {a.v >= b.v}; }
  friend Mask operator==(Lanes a, Lanes b) noexcept { return {a.v == b.v}; }
  friend Mask operator!=(Lanes a, Lanes b) noexcept { return {a.v != b.v}; }

  // a where the mask is set, else b; emitted code calls it in place of ?:, which no class can have.
  friend Lanes select(Mask mask, Lanes a, Lanes b) noexcept { return of(mask.v ? a.v : b.v); }
  // As std::min and std::max: the first where neither is smaller, or one is not a number.
  friend Lanes min(Lanes a, Lanes b) noexcept { return of(b.v < a.v ? b.v : a.v); }
  friend Lanes max(Lanes a, Lanes b) noexcept { return of(a.v < b.v ? b.v : a.v); }
  friend Lanes abs(Lanes a) noexcept {
    using Bits = typename Mask::Vector;
    using Unsigned = std::make_unsigned_t<typename Mask::Integer>;
    constexpr auto all_but_sign = static_cast<typename Mask::Integer>(static_cast<Unsigned>(-1) >> 1);
    return of((Vector)((Bits)a.v & (all_but_sign - Bits{})));
  }
};

}  // namespace kanec::lanes

namespace kanec {
using lanes::Lanes;
}
