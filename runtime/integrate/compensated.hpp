// A sum over many steps that keeps what rounding takes from it (Kahan 1965). Not: sums of other kinds.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace kanec::integrate {

// value + rest is the sum, to which a change is added.
template <class Real>
void add_compensated(Real& value, Real& rest, Real change) {
  const Real old = value, wanted = change + rest;
  value = old + wanted;
  rest = (old - value) + wanted;
}

// values + rest() is the sum; values must outlive it and keep their place.
class Compensated {
 public:
  explicit Compensated(std::vector<double>& values) : values_(values), rest_(values.size()) {}

  void add(std::size_t i, double change) { add_compensated(values_[i], rest_[i], change); }

  // What is kept beside the values.
  std::vector<double>& rest() { return rest_; }

  // The sum and a small change, rounded once.
  double with(std::size_t i, double change) const { return values_[i] + (rest_[i] + change); }

 private:
  std::vector<double>& values_;
  std::vector<double> rest_;
};

}  // namespace kanec::integrate
