// A model as the first-order system ż = g(t, z), z = (x, y, W): W is the work of the applied loads since the start [J],
// there only where the model has `power`. Not: how it is stepped, nor the norm of the Euler parameters (norm.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "runtime/abi/solver.hpp"

namespace kanec::integrate {

class System {
 public:
  // Calls the combined functions where the model has them. Throws InputError where it gives no kinematics or no
  // accelerations. The solver must outlive it.
  explicit System(const Solver& solver);

  const Solver& solver() const { return *solver_; }
  int nx() const { return nx_; }
  int ny() const { return ny_; }
  bool has_work() const { return has_work_; }
  // At least 1: a model without coordinates (all prescribed) and without `power` has one entry that stays zero.
  int size() const { return size_; }
  // Where sets of Euler parameters begin in z.
  std::span<const int> attitudes() const { return attitudes_; }

  // z (size) -> zdot (size), the emitted functions working on these arrays themselves. False where a rate is not
  // finite.
  bool rates(double t, const double* z, double* zdot) noexcept;
  // F = (ẋ - kinematics, A ẏ - f, Ẇ - power) (size), which is 0 where zdot are the rates. False as rates(). Only where
  // has_residual(): the model has the functions combined.
  bool residual(double t, const double* z, const double* zdot, double* F) noexcept;
  bool has_residual() const { return residual_ != nullptr; }
  // Of rates and of the residual.
  std::int64_t evaluations() const { return evaluations_; }
  void count_evaluation() { ++evaluations_; }  // made elsewhere

  // z at the start: state_at_start() and the work before.
  std::vector<double> initial_state(std::span<const double> x, std::span<const double> y, double work = 0.0) const;

  // "omega_3_2" for a component of z.
  std::string component(int index) const;

  // The component whose rate is the largest beside itself, which is what steps become short for.
  std::string fastest(double t, const double* z);

  // The last evaluation that was not finite since clear_fault(), and the error that tells of it.
  struct Fault {
    double t;
    int index;
  };
  const std::optional<Fault>& fault() const { return fault_; }
  void clear_fault() { fault_.reset(); }
  [[noreturn]] void throw_fault() const;

 private:
  // One emitted function and the entry of zdot at which its results begin.
  struct Call {
    const kanec_function* function;
    int offset;
  };
  std::vector<Call> calls() const;
  // Whether all (size) are finite; a fault where not.
  bool counted(double t, const double* results) noexcept;

  const Solver* solver_;
  int nx_, ny_;
  std::vector<Call> calls_;
  const kanec_function* residual_;
  bool has_work_;
  int size_;
  std::vector<int> attitudes_;
  std::int64_t evaluations_ = 0;
  std::optional<Fault> fault_;
};

// (x, y) of a model at the start. Euler parameters are brought to unit norm to the last bit. Throws InputError for
// wrong sizes, numbers that are not finite, and Euler parameters further than 1e-6 from unit norm.
std::vector<double> state_at_start(const kanec_model& model, std::span<const double> x, std::span<const double> y);

// The first entry that is NaN or infinite, or -1.
int first_not_finite(std::span<const double> values) noexcept;

}  // namespace kanec::integrate
