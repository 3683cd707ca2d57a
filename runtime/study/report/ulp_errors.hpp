// Errors in many states put together, in units in the last place. Not: how an error is found.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstddef>
#include <limits>
#include <optional>
#include <vector>

namespace kanec {

// In ulps of the largest component, or of its median over the states where it cancels to less.
struct UlpErrors {
  double median = 0.0, largest = 0.0;  // over random states
  double hard = 0.0;                   // largest over the adversarial ones
};

constexpr int digits_of_double = 53, digits_of_float = 24;

// The error in one state and what it is measured by; an error is infinite where a result is not finite.
struct StateError {
  double error = std::numeric_limits<double>::infinity(), size = 0.0;
};

// The random states first.
class StateErrors {
 public:
  explicit StateErrors(std::size_t n_random) : n_random_(n_random) {}

  // Nothing where the result is undefined.
  void add(std::optional<StateError> error) { list_.push_back(error); }

  UlpErrors summary(int digits) const;

 private:
  std::size_t n_random_;
  std::vector<std::optional<StateError>> list_;
};

}  // namespace kanec
