// Numbers modulo the prime 2^61 - 1: a scalar in which a program is evaluated exactly, so that two programs agree or do
// not, without a tolerance. Two that differ agree by chance in one of some 10^17 random arguments. Not ordered as real
// numbers are, but for short ones.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstdint>
#include <ostream>

#include "tests/support/random.hpp"

namespace kanec::test {

class Field {
 public:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;

  Field() = default;
  // Every double is an integer times a power of two, and so has an exact image.
  explicit Field(double value) {
    int exponent = 0;
    const auto mantissa = static_cast<std::int64_t>(std::ldexp(std::frexp(value, &exponent), 53));
    exponent -= 53;
    const Field magnitude = of(static_cast<std::uint64_t>(mantissa < 0 ? -mantissa : mantissa) % prime);
    const Field two = of(2);
    const Field scale = exponent < 0 ? of(1) / two.power(static_cast<std::uint64_t>(-exponent))
                                     : two.power(static_cast<std::uint64_t>(exponent));
    *this = mantissa < 0 ? -(magnitude * scale) : magnitude * scale;
  }

  // Any element, each about as likely.
  static Field random(Random& random) {
    const auto half = [&] { return static_cast<std::uint64_t>(random.below(1 << 30)); };
    return of(((half() << 31) ^ half()) % prime);
  }

  friend Field operator-(Field a) { return of(a.value_ == 0 ? 0 : prime - a.value_); }
  friend Field operator+(Field a, Field b) { return of((a.value_ + b.value_) % prime); }
  friend Field operator-(Field a, Field b) { return a + -b; }
  friend Field operator*(Field a, Field b) {
    std::uint64_t high = 0;
    std::uint64_t low = 0;
    multiply(a.value_, b.value_, high, low);
    // 2^64 = 8 modulo the prime
    return of(((low & prime) + (low >> 61) + ((high << 3) % prime)) % prime);
  }
  friend Field operator/(Field a, Field b) { return a * b.power(prime - 2); }  // Fermat; 0 where b = 0
  bool operator==(const Field&) const = default;

  Field power(std::uint64_t n) const {
    Field result = of(1);
    for (Field base = *this; n > 0; n >>= 1, base = base * base)
      if (n & 1) result = result * base;
    return result;
  }

  // Stand-ins with the properties that programs may use: odd and even functions, values at 0 and 1, powers, and the
  // order of short numbers.
  friend Field sqrt(Field a) { return a * a * a + of(7) * a * (a - of(1)); }
  friend Field sin(Field a) { return a * a * a + of(5) * a; }
  friend Field cos(Field a) { return a * a + of(1); }
  friend Field tan(Field a) { return a * a * a + of(11) * a; }
  friend Field asin(Field a) { return a * a * a + of(13) * a; }
  friend Field acos(Field a) { return (a - of(1)) * (a * a + of(2)); }
  friend Field exp(Field a) { return a * a + of(3) * a + of(1); }
  friend Field log(Field a) { return (a - of(1)) * (a + of(5)); }
  friend Field tanh(Field a) { return a * a * a + of(17) * a; }
  friend Field abs(Field a) { return a < Field() ? -a : a; }
  friend Field atan2(Field a, Field b) { return a * (a * a + b); }
  friend Field min(Field a, Field b) { return a < b ? a : b; }
  friend Field max(Field a, Field b) { return a < b ? b : a; }
  friend Field pow(Field a, Field b) {
    for (std::uint64_t n = 0; n <= 8; ++n) {
      if (b == of(n)) return a.power(n);
      if (b == -of(n)) return of(1) / a.power(n);
    }
    if (b == of(1) / of(2)) return sqrt(a);
    return a == of(1) ? a : a * a * b + of(19) * b;
  }
  // As real numbers where both are short: below 2^19 with up to 40 binary places.
  friend bool operator<(Field a, Field b) { return ((a - b) * of(std::uint64_t{1} << 40)).value_ > prime / 2; }

  friend std::ostream& operator<<(std::ostream& out, Field a) { return out << a.value_; }

 private:
  static Field of(std::uint64_t value) {
    Field result;
    result.value_ = value;
    return result;
  }

  // The 128 bits of a product, by halves.
  static void multiply(std::uint64_t a, std::uint64_t b, std::uint64_t& high, std::uint64_t& low) {
    constexpr std::uint64_t mask = 0xffffffff;
    const std::uint64_t a0 = a & mask, a1 = a >> 32, b0 = b & mask, b1 = b >> 32;
    const std::uint64_t middle = (a0 * b0 >> 32) + (a1 * b0 & mask) + (a0 * b1 & mask);
    low = a * b;
    high = a1 * b1 + (a1 * b0 >> 32) + (a0 * b1 >> 32) + (middle >> 32);
  }

  std::uint64_t value_ = 0;
};

}  // namespace kanec::test
