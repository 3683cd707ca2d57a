// Gragg's modified midpoint rule extrapolated in h² (Bulirsch and Stoer), in any arithmetic: reference runs of any
// precision by one loop. Not: an integrator for use; the scalar allocates where it is of 50 digits.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>
#include <vector>

#include "runtime/base/error.hpp"

namespace kanec::hard {

template <class T>
class Extrapolation {
 public:
  using State = std::vector<T>;
  using Rates = std::function<State(const T& t, const State& z)>;

  struct Accuracy {
    int columns;       // order 2 · columns
    double tolerance;  // of a step, beside the largest value that a component has had
    int digits;        // decimal, of T: below their last a step is accepted anyway
  };

  Extrapolation(Rates rates, State z, const Accuracy& accuracy)
      : rates_(std::move(rates)), z_(std::move(z)), accuracy_(accuracy), size_(z_.size(), 0.0) {}

  const State& advance(double end) {
    while (t_ < end) {
      const double h = std::min(h_, end - t_);
      const auto [z, error] = stepped(T(h));
      if (!std::isfinite(error)) throw IntegrationError("the reference run has no rates at t = " + std::to_string(t_));
      const double wanted = std::max(accuracy_.tolerance, std::pow(10.0, 2 - accuracy_.digits));
      const double factor = 0.9 * std::pow(wanted / std::max(error, 1e-300), 1.0 / (2 * accuracy_.columns - 1));
      if (error <= wanted) {
        z_ = z;
        t_ = h == end - t_ ? end : t_ + h;
      }
      if (error > wanted || h == h_) h_ = h * std::clamp(factor, 0.1, 4.0);
      if (h_ < 1e-14 * (end - t_) || ++steps_ > most_steps)
        throw IntegrationError("the reference run stops at t = " + std::to_string(t_) + " s: its rates are too rough");
    }
    return z_;
  }

 private:
  static double magnitude(long double value) { return static_cast<double>(std::fabs(value)); }
  template <class Precise>
  static double magnitude(const Precise& value) {
    return std::fabs(value.rounded());
  }

  // Row j of the table is by 2 (j + 1) substeps; returns its last entry and how far it is from the one before.
  std::pair<State, double> stepped(const T& h) {
    const State first = rates_(T(t_), z_);
    for (std::size_t i = 0; i < z_.size(); ++i)
      size_[i] = std::max({size_[i], magnitude(z_[i]), magnitude(h * first[i])});
    std::vector<State> before;
    for (int j = 0; j < accuracy_.columns; ++j) {
      std::vector<State> row = {midpoint(first, h, 2 * (j + 1))};
      for (int k = 1; k <= j; ++k) {
        row.push_back(combined(row.back(), before[static_cast<std::size_t>(k - 1)], j + 1, j + 1 - k));
      }
      before = std::move(row);
    }
    double error = 0.0;
    const State &last = before.back(), &beside = before[before.size() - 2];
    for (std::size_t i = 0; i < z_.size(); ++i)
      if (size_[i] > 0.0) {
        const double one = magnitude(last[i] - beside[i]) / size_[i];
        error = one <= error ? error : one;  // NaN stays
      }
    return {last, error};
  }

  // a + (a − b) / ((n / m)² − 1)
  static State combined(const State& a, const State& b, int n, int m) {
    const T share = T(static_cast<double>(m * m)) / T(static_cast<double>(n * n - m * m));
    State result;
    for (std::size_t i = 0; i < a.size(); ++i) result.push_back(a[i] + share * (a[i] - b[i]));
    return result;
  }

  State midpoint(const State& first, const T& h, int steps) const {
    const T part = h / T(static_cast<double>(steps));
    State old = z_, now = moved(z_, part, first);
    for (int i = 1; i < steps; ++i) {
      State next = moved(old, part + part, rates_(T(t_) + T(static_cast<double>(i)) * part, now));
      old = std::move(now);
      now = std::move(next);
    }
    return now;
  }

  static State moved(const State& z, const T& h, const State& rate) {
    State result;
    for (std::size_t i = 0; i < z.size(); ++i) result.push_back(z[i] + h * rate[i]);
    return result;
  }

  Rates rates_;
  State z_;
  Accuracy accuracy_;
  std::vector<double> size_;
  static constexpr long most_steps = 1'000'000;
  long steps_ = 0;
  double t_ = 0.0, h_ = 1e-3;
};

}  // namespace kanec::hard
