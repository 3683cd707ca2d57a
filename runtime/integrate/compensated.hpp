// A sum over many steps that keeps what rounding takes from it (Kahan 1965). Not: sums of other kinds.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace kanec::integrate {

// values + rest() is the sum; values must outlive it and keep their place.
class Compensated {
 public:
  explicit Compensated(std::vector<double>& values) : values_(values), rest_(values.size()) {}

  void add(std::size_t i, double change) {
    const double old = values_[i], wanted = change + rest_[i];
    values_[i] = old + wanted;
    rest_[i] = (old - values_[i]) + wanted;
  }

  // What is kept beside the values.
  std::vector<double>& rest() { return rest_; }

  // The sum and a small change, rounded once.
  double with(std::size_t i, double change) const { return values_[i] + (rest_[i] + change); }

 private:
  std::vector<double>& values_;
  std::vector<double> rest_;
};

}  // namespace kanec::integrate
