// What the multistep methods of CVODE and IDA have in common: rows, starts, and the book of their steps. Not: the
// libraries' calls (cvode.cpp, ida.cpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <algorithm>
#include <optional>
#include <utility>

#include "runtime/integrate/linear_solver.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/stepper.hpp"
#include "runtime/integrate/sundials.hpp"

namespace kanec::integrate {

// Multistep methods take their own steps; rows are interpolated by the method's own polynomial (its full order), then
// projected. Where the library cannot project inside a step the method runs free, since changing the newest value alone
// would spoil the history, and starts anew from projected values once the norm is off by `drift_limit_`. A start costs
// some twenty short steps and a drift of about the tolerance; a limit of a hundred times that keeps starts hundreds of
// steps apart, and the norm is not the largest of the errors.
class Multistep : public Stepper {
 public:
  double time() const final { return t_; }

  std::span<const double> at(double t) final {
    if (!has_stepped_) return z_;
    interpolate(t, row_vector_.get());
    normalise(row_.data(), attitudes());
    return row_;
  }

  void restart(double t, std::span<const double> z) final {
    std::copy(z.begin(), z.end(), z_.begin());
    t_ = t;
    start_anew();
  }

  void step(double) final {
    if (!projects_ && norm_error(z_.data(), attitudes()) > drift_limit_) {
      start_anew();
      ++book_.restarts;
    }
    t_ = take_step(library_, t_, data_, [this](double* next) { return evolve(next); });
    has_stepped_ = true;
    book_.failed = failed_before_restart_ + failed();
    if (linear_) book_.jacobians = linear_->evaluations();
    book_.accepted(t_, projects_ ? data_.norm_error : norm_error(z_.data(), attitudes()));
  }

 protected:
  // projects: the library does inside every step, and leaves the norm's error before in data_.
  Multistep(const Library& library, bool projects, System& system, std::vector<double> z, const Options& options,
            StepBook& book)
      : data_{system},
        end_(options.duration),
        t_(options.start),
        z_(std::move(z)),
        vector_(view(z_, context_)),
        library_(library),
        projects_(projects),
        drift_limit_(100.0 * std::max(options.relative_tolerance, 1e-13)),
        book_(book),
        row_(z_),
        row_vector_(view(row_, context_)) {
    data_.state = &z_;
  }

  // The state at t within the last step.
  virtual void interpolate(double t, N_Vector row) = 0;
  // One step on to the end at most, t_ and z_ being those of the last one; returns the library's flag.
  virtual int evolve(double* next) = 0;
  // Forgets all steps: the next one begins with t_ and z_.
  virtual void re_init() = 0;
  // Steps rejected since then.
  virtual std::int64_t failed() = 0;

  CallbackData data_;
  double end_, t_;  // of the run; of the last step
  sundials::Context context_;
  std::vector<double> z_;  // at t_
  VectorHandle vector_;
  std::optional<LinearSolver> linear_;  // of methods with Newton's iteration

 private:
  std::span<const int> attitudes() const { return data_.system.attitudes(); }

  void start_anew() {
    failed_before_restart_ += failed();
    normalise(z_.data(), attitudes());
    re_init();
    has_stepped_ = false;
  }

  const Library& library_;
  bool projects_;
  double drift_limit_;
  StepBook& book_;
  std::vector<double> row_;
  VectorHandle row_vector_;
  bool has_stepped_ = false;  // since the last start
  std::int64_t failed_before_restart_ = 0;
};

}  // namespace kanec::integrate
