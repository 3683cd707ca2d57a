// One-step methods with error control as steppers. Not: the methods (arkode.cpp, dirk.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "runtime/integrate/stepper.hpp"

namespace kanec::integrate {

// Pair(system, z, t, options) has its own state: z(), t(), norm_error() of the last step, failed() and jacobians()
// since it was made; step(limit) ends at the limit at the latest; begin(t, z, h) starts anew, with h where it is not 0.
// Rows are ends of steps, reached by shortening the last one. Inside the last step a second Pair goes there from its
// start, in one step where it can: the library's interpolants are of lower order than the methods.
template <class Pair>
class EmbeddedPair final : public Stepper {
 public:
  EmbeddedPair(System& system, std::vector<double> z, const Options& options, StepBook& book)
      : system_(system),
        options_(options),
        book_(book),
        pair_(system, z, options.start, options),
        start_(std::move(z)) {
    begin_ = options.start;
  }

  double time() const override { return pair_.t(); }

  void step(double limit) override {
    start_ = pair_.z();
    begin_ = pair_.t();
    pair_.step(limit);
    book_.failed = pair_.failed();
    book_.jacobians = pair_.jacobians() + (inner_ ? inner_->jacobians() : 0);
    book_.accepted(pair_.t(), pair_.norm_error());
  }

  std::span<const double> at(double t) override {
    if (t == pair_.t()) return pair_.z();
    if (!(t > begin_)) return start_;
    if (!inner_) inner_.emplace(system_, start_, begin_, options_);
    inner_->begin(begin_, start_, t - begin_);
    while (inner_->t() < t) inner_->step(t);
    return inner_->z();
  }

  void restart(double t, std::span<const double> z) override {
    start_.assign(z.begin(), z.end());
    begin_ = t;
    pair_.begin(t, start_, 0.0);
  }

 private:
  System& system_;
  Options options_;
  StepBook& book_;
  Pair pair_;
  std::optional<Pair> inner_;
  std::vector<double> start_;  // of the last step
  double begin_;
};

}  // namespace kanec::integrate
