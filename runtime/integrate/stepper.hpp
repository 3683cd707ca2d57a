// What every integration method offers, and the book of its steps. Not: the methods (rk4, arkode, ...) themselves.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "runtime/integrate/options.hpp"
#include "runtime/integrate/system.hpp"

namespace kanec::integrate {

// Steps taken so far; one for all methods.
class StepBook {
 public:
  StepBook(std::int64_t max_steps, std::function<void(double)> at_time)
      : max_steps_(max_steps), at_time_(std::move(at_time)) {}

  // An accepted step that ends at t, with | |ε| - 1 | before any projection. Throws IntegrationError beyond max_steps.
  void accepted(double t, double norm_error);

  std::int64_t steps = 0;
  std::int64_t failed = 0;     // rejected by error control or not converged
  std::int64_t restarts = 0;   // of a multistep method, because of the norm of the Euler parameters
  std::int64_t jacobians = 0;  // evaluations of emitted derivatives
  double worst_norm_error = 0.0;

 private:
  std::int64_t max_steps_;
  std::function<void(double)> at_time_;  // may be empty
};

class Stepper {
 public:
  virtual ~Stepper() = default;

  // The end of the last step; before the first one the start, or later.
  virtual double time() const = 0;

  // One step, on from time(). Beyond `limit` goes only a method whose interpolation is as exact as its steps; none
  // evaluates beyond the end it was made for. Throws IntegrationError.
  virtual void step(double limit) = 0;

  // z at t within the last step, as exact as its end, Euler parameters of unit norm, projected or kept so by the
  // method. Valid until the next call. Throws IntegrationError.
  virtual std::span<const double> at(double t) = 0;

  // Begins anew from z, which at(t) gave within the last step: the rates are others from there on.
  virtual void restart(double t, std::span<const double> z) = 0;

  // Steps on to t, not before the last step's start, and gives the state there.
  std::span<const double> advance(double t) {
    while (time() < t) step(t);
    return at(t);
  }
};

// `z` at options.start; system and book must outlive the stepper.
std::unique_ptr<Stepper> make_rk4(System& system, std::vector<double> z, const Options& options, StepBook& book);
std::unique_ptr<Stepper> make_lie(System& system, std::vector<double> z, const Options& options, StepBook& book);
std::unique_ptr<Stepper> make_gauss(System& system, std::vector<double> z, const Options& options, StepBook& book);
std::unique_ptr<Stepper> make_dop853(System& system, std::vector<double> z, const Options& options, StepBook& book);
std::unique_ptr<Stepper> make_arkode(System& system, std::vector<double> z, const Options& options, StepBook& book);
std::unique_ptr<Stepper> make_dirk(System& system, std::vector<double> z, const Options& options, StepBook& book);
std::unique_ptr<Stepper> make_cvode(System& system, std::vector<double> z, const Options& options, StepBook& book);
std::unique_ptr<Stepper> make_taylor(System& system, std::vector<double> z, const Options& options, StepBook& book);
std::unique_ptr<Stepper> make_ida(System& system, std::vector<double> z, const Options& options, StepBook& book);
std::unique_ptr<Stepper> make_stepper(System& system, std::vector<double> z, const Options& options, StepBook& book);

}  // namespace kanec::integrate
