// Truncated power series as a number type: arithmetic on all coefficients at once, by the definition of each operation.
// Not: the recursions of emitted code, coefficient by coefficient, which are tested against it.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

namespace kanec::test {

// c[0] + c[1] t + ... + c[N] t^N
template <class Real, std::size_t N>
struct PowerSeries {
  std::array<Real, N + 1> c{};

  PowerSeries() = default;
  PowerSeries(Real value) { c[0] = value; }

  PowerSeries operator-() const { return *this * PowerSeries(-1); }
  friend PowerSeries operator+(const PowerSeries& a, const PowerSeries& b) {
    PowerSeries sum;
    for (std::size_t k = 0; k <= N; ++k) sum.c[k] = a.c[k] + b.c[k];
    return sum;
  }
  friend PowerSeries operator-(const PowerSeries& a, const PowerSeries& b) { return a + -b; }
  friend PowerSeries operator*(const PowerSeries& a, const PowerSeries& b) {
    PowerSeries product;
    for (std::size_t i = 0; i <= N; ++i)
      for (std::size_t j = 0; i + j <= N; ++j) product.c[i + j] += a.c[i] * b.c[j];
    return product;
  }
  friend PowerSeries operator/(const PowerSeries& a, const PowerSeries& b) {
    PowerSeries rest = a, result;
    for (std::size_t k = 0; k <= N; ++k) {
      result.c[k] = rest.c[k] / b.c[0];
      for (std::size_t j = 0; k + j <= N; ++j) rest.c[k + j] -= result.c[k] * b.c[j];
    }
    return result;
  }
  friend bool operator<(const PowerSeries& a, const PowerSeries& b) { return a.c[0] < b.c[0]; }

  PowerSeries derivative() const {
    PowerSeries d;
    for (std::size_t k = 0; k < N; ++k) d.c[k] = static_cast<Real>(k + 1) * c[k + 1];
    return d;
  }
  // Begins with `value`.
  PowerSeries integral(Real value) const {
    PowerSeries sum(value);
    for (std::size_t k = 0; k < N; ++k) sum.c[k + 1] = c[k] / static_cast<Real>(k + 1);
    return sum;
  }

  // The sum of f_k (a - a_0)^k, f_k the Taylor coefficients of a function at a_0.
  static PowerSeries composed(const std::array<Real, N + 1>& f, PowerSeries a) {
    a.c[0] = 0;
    PowerSeries sum(f[N]);
    for (std::size_t k = N; k-- > 0;) sum = sum * a + PowerSeries(f[k]);
    return sum;
  }

  friend PowerSeries exp(const PowerSeries& a) {
    std::array<Real, N + 1> f{std::exp(a.c[0])};
    for (std::size_t k = 1; k <= N; ++k) f[k] = f[k - 1] / static_cast<Real>(k);
    return composed(f, a);
  }
  friend PowerSeries sin(const PowerSeries& a) {
    std::array<Real, N + 1> f{std::sin(a.c[0]), std::cos(a.c[0])};
    for (std::size_t k = 2; k <= N; ++k) f[k] = -f[k - 2] / static_cast<Real>(k * (k - 1));
    return composed(f, a);
  }
  friend PowerSeries cos(const PowerSeries& a) {
    std::array<Real, N + 1> f{std::cos(a.c[0]), -std::sin(a.c[0])};
    for (std::size_t k = 2; k <= N; ++k) f[k] = -f[k - 2] / static_cast<Real>(k * (k - 1));
    return composed(f, a);
  }
  friend PowerSeries sqrt(const PowerSeries& a) {  // Newton, each step doubles the coefficients that are right
    PowerSeries root(std::sqrt(a.c[0]));
    for (std::size_t right = 1; right <= N; right *= 2) root = (root + a / root) * PowerSeries(Real(0.5));
    return root;
  }
  friend PowerSeries log(const PowerSeries& a) { return (a.derivative() / a).integral(std::log(a.c[0])); }
  friend PowerSeries tan(const PowerSeries& a) { return sin(a) / cos(a); }
  friend PowerSeries tanh(const PowerSeries& a) {
    const PowerSeries grown = exp(a), shrunk = exp(-a);
    return (grown - shrunk) / (grown + shrunk);
  }
  friend PowerSeries asin(const PowerSeries& a) {
    return (a.derivative() / sqrt(PowerSeries(1) - a * a)).integral(std::asin(a.c[0]));
  }
  friend PowerSeries acos(const PowerSeries& a) { return asin(a) * PowerSeries(-1) + PowerSeries(std::acos(Real(0))); }
  friend PowerSeries abs(const PowerSeries& a) { return a.c[0] < 0 ? -a : a; }
  friend PowerSeries pow(const PowerSeries& a, const PowerSeries& b) { return exp(b * log(a)); }
  friend PowerSeries atan2(const PowerSeries& y, const PowerSeries& x) {
    return ((x * y.derivative() - y * x.derivative()) / (x * x + y * y)).integral(std::atan2(y.c[0], x.c[0]));
  }
};

}  // namespace kanec::test
