// What methods of a fixed step have in common: a stretch of time divided into equal steps, and the state. Not: a step.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "runtime/integrate/stepper.hpp"

namespace kanec::integrate {

// Each stretch up to a limit is divided evenly. Inside the last step the state is that of a shorter step from its
// start.
class FixedStep : public Stepper {
 public:
  FixedStep(System& system, std::vector<double> z, const Options& options, StepBook& book)
      : z_(std::move(z)), system_(system), book_(book), longest_(options.step), t_(options.start) {
    carry(z_);
  }

  double time() const final { return t_; }

  void step(double limit) final {
    if (limit != limit_ || taken_ == steps_) divide(limit);
    ++taken_;
    const double part = static_cast<double>(taken_) / static_cast<double>(steps_);
    const double end = taken_ == steps_ ? limit : begin_ + (limit - begin_) * part;
    keep(start_);
    step_begin_ = t_;
    const double norm_error = take(t_, end - t_);
    t_ = end;
    book_.accepted(t_, norm_error);
  }

  std::span<const double> at(double t) final {
    if (t == t_) return z_;
    keep(end_);
    repeat(t);
    inside_ = z_;
    bring_back(end_);
    return inside_;
  }

  void restart(double t, std::span<const double> z) final {
    for (std::vector<double>* array : carried_) std::fill(array->begin(), array->end(), 0.0);
    std::copy(z.begin(), z.end(), z_.begin());
    t_ = t;
    taken_ = steps_ = 0;
  }

 protected:
  // z_ from t to t + h; returns the worst | |ε| - 1 | there before any projection. No allocation.
  virtual double take(double t, double h) = 0;

  // Another array that steps change, and that is zero in a new start: a repeated step begins with it as it was. In the
  // constructor, at its full size.
  void carry(std::vector<double>& array) {
    carried_.push_back(&array);
    for (auto* list : {&start_, &end_}) list->push_back(array);
    inside_ = z_;
  }

  // Throws IntegrationError where a rate is not finite.
  void evaluate(double t, const double* z, double* rate) {
    if (!system_.rates(t, z, rate)) system_.throw_fault();
  }

  System& system() const { return system_; }

  std::vector<double> z_;

 private:
  using Arrays = std::vector<std::vector<double>>;

  void divide(double limit) {
    limit_ = limit;
    begin_ = t_;
    taken_ = 0;
    steps_ = equal_steps(limit - t_, longest_);
  }

  // From the start of the last step.
  void repeat(double t) {
    bring_back(start_);
    if (t > step_begin_) take(step_begin_, t - step_begin_);
  }

  void keep(Arrays& copies) const {
    for (std::size_t i = 0; i < carried_.size(); ++i) copies[i] = *carried_[i];
  }
  void bring_back(const Arrays& copies) {
    for (std::size_t i = 0; i < carried_.size(); ++i) *carried_[i] = copies[i];
  }

  System& system_;
  StepBook& book_;
  double longest_;
  double t_, step_begin_ = 0.0;
  double begin_ = 0.0, limit_ = 0.0;    // of the stretch that is divided
  std::int64_t taken_ = 0, steps_ = 0;  // of it
  std::vector<std::vector<double>*> carried_;
  Arrays start_, end_;  // of the last step, in the order of carried_
  std::vector<double> inside_;
};

}  // namespace kanec::integrate
