// One step of the classical Runge-Kutta method, for whoever holds an emitted header: no heap, no exceptions, no
// library. Not: which steps are taken, nor what they do to anything but z.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

namespace kanec {

// z += h/6 (k1 + 2 k2 + 2 k3 + k4) (Kutta 1901), from t to t + h.
// z: n entries, in any order; work: 3 n entries, read by nobody; rates(t, z, zdot) writes the n rates of z.
// T is any scalar of emitted code, Time what it is made from: float, double.
template <class T, class Time, class Rates>
void rk4_step(int n, T* z, T* work, Time t, Time h, const Rates& rates) noexcept(noexcept(rates(t, z, work))) {
  T *const stage = work, *const rate = work + n, *const sum = work + 2 * n;
  const auto shift = [&](Time by, const T* along) {
    const T step(by);
    for (int i = 0; i < n; ++i) stage[i] = z[i] + step * along[i];
  };
  const auto add = [&](int weight) {
    const T w(static_cast<Time>(weight));
    for (int i = 0; i < n; ++i) sum[i] = sum[i] + w * rate[i];
  };
  const Time half = h / 2;
  rates(t, z, sum);
  shift(half, sum);
  rates(t + half, stage, rate);
  add(2);
  shift(half, rate);
  rates(t + half, stage, rate);
  add(2);
  shift(h, rate);
  rates(t + h, stage, rate);
  add(1);
  const T sixth(h / 6);
  for (int i = 0; i < n; ++i) z[i] = z[i] + sixth * sum[i];
}

// A set of Euler parameters (4) to unit norm, as emitted code wants them; returns their norm before.
template <class T>
T normalise(T* eps) noexcept {
  using std::sqrt;
  const T length = sqrt(eps[0] * eps[0] + eps[1] * eps[1] + eps[2] * eps[2] + eps[3] * eps[3]);
  for (int i = 0; i < 4; ++i) eps[i] = eps[i] / length;
  return length;
}

}  // namespace kanec
