// What methods of a fixed step have in common: a stretch of time divided into equal steps, and the state. Not: a step.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <utility>
#include <vector>

#include "runtime/integrate/stepper.hpp"

namespace kanec::integrate {

class FixedStep : public Stepper {
 public:
  FixedStep(System& system, std::vector<double> z, double longest, StepBook& book)
      : z_(std::move(z)), system_(system), book_(book), longest_(longest) {}

  std::span<const double> advance(double t) final {
    const double begin = t_;
    const std::int64_t steps = equal_steps(t - begin, longest_);
    for (std::int64_t i = 1; i <= steps; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(steps);
      const double end = i == steps ? t : begin + (t - begin) * part;
      const double norm_error = step(t_, end - t_);
      t_ = end;
      book_.accepted(t_, norm_error);
    }
    return z_;
  }

 protected:
  // z_ from t to t + h; returns the worst | |ε| - 1 | there before any projection. No allocation.
  virtual double step(double t, double h) = 0;

  // Throws IntegrationError where a rate is not finite.
  void evaluate(double t, const double* z, double* rate) {
    if (!system_.rates(t, z, rate)) system_.throw_fault();
  }

  System& system() const { return system_; }

  std::vector<double> z_;

 private:
  System& system_;
  StepBook& book_;
  double longest_;
  double t_ = 0.0;
};

}  // namespace kanec::integrate
