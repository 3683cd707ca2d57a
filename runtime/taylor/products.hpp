// Products of Taylor series, coefficient by coefficient, as emitted recursions need them: what is known of both factors
// is added at once to all later coefficients. Not: the recursions (emitted), nor steps (runtime/integrate/taylor.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <cstring>

// What stands between the marks also stands in emitted headers.
// --------
#if !defined(KANEC_SERIES_PRODUCTS)
#define KANEC_SERIES_PRODUCTS
namespace kanec_series {

// sum += sign a b: rows of coefficients.
struct Product {
  std::int32_t sum, a, b, sign;
};

// Coefficients are taken in groups of so many; rows are that much longer than a series.
inline constexpr int group = 8;

// into[j] += x b[j] + y a[j] for one group
template <class T>
inline void add_group(T* into, const T& x, const T* b, const T& y, const T* a) noexcept {
  for (int j = 0; j < group; ++j) into[j] += x * b[j] + y * a[j];
}

#if defined(__GNUC__) && !defined(__FAST_MATH__)
inline void add_group(double* into, const double& x, const double* b, const double& y, const double* a) noexcept {
  typedef double Vector __attribute__((vector_size(8 * group)));
  Vector sum, from_a, from_b;
  std::memcpy(&sum, into, sizeof sum);
  std::memcpy(&from_a, a, sizeof from_a);
  std::memcpy(&from_b, b, sizeof from_b);
  sum += x * from_b + y * from_a;
  std::memcpy(into, &sum, sizeof sum);
}
#endif

// What the coefficients k of all factors, `now`, add to the sums' coefficients k + 1 ... order, together with coefficients
// 1 ... k of the other factors. Factors' rows are 0 from k on before, and hold coefficient k after. 1 <= k < order.
template <class T, int stride>
inline void add_products(const Product* products, int n_products, int n_factors, int k, int order, const T* now,
                         T (*factors)[stride], T (*sums)[stride]) noexcept {
  const int others = k < order - k ? k : order - k;
  for (int i = 0; i < n_factors; ++i) factors[i][k] = T(0.5) * now[i];  // the pair k, k is added twice
  for (const Product* p = products; p != products + n_products; ++p) {
    T* const into = sums[p->sum] + k;
    const T a = T(p->sign) * now[p->a], b = T(p->sign) * now[p->b];
    for (int j = 1; j <= others; j += group) add_group(into + j, a, factors[p->b] + j, b, factors[p->a] + j);
  }
  for (int i = 0; i < n_factors; ++i) factors[i][k] = now[i];
}

}  // namespace kanec_series
#endif
// --------
