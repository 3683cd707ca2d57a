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
  // Throws InputError where the model was emitted without kinematics or accelerations. The solver must outlive it.
  explicit System(const Solver& solver);

  int n_bodies() const { return n_bodies_; }
  int nx() const { return nx_; }
  int ny() const { return ny_; }
  bool has_work() const { return power_ != nullptr; }
  int size() const { return nx_ + ny_ + (has_work() ? 1 : 0); }

  // z (size) -> zdot (size), the emitted functions working on these arrays themselves. False where a rate is not
  // finite.
  bool rates(double t, const double* z, double* zdot) noexcept;
  std::int64_t evaluations() const { return evaluations_; }

  // z at the start: x, y and no work. Euler parameters are brought to unit norm to the last bit. Throws InputError for
  // wrong sizes, numbers that are not finite, and Euler parameters further than 1e-6 from unit norm.
  std::vector<double> initial_state(std::span<const double> x, std::span<const double> y) const;

  // "body 3, omega_2" for a component of z.
  std::string component(int index) const;

  // The last evaluation that was not finite since clear_fault(), and the error that tells of it.
  struct Fault {
    double t;
    int index;
  };
  const std::optional<Fault>& fault() const { return fault_; }
  void clear_fault() { fault_.reset(); }
  [[noreturn]] void throw_fault() const;

 private:
  const Solver* solver_;
  const kanec_function* kinematics_;
  const kanec_function* accelerations_;
  const kanec_function* power_;
  int n_bodies_, nx_, ny_;
  std::int64_t evaluations_ = 0;
  std::optional<Fault> fault_;
};

// The first entry that is NaN or infinite, or -1.
int first_not_finite(std::span<const double> values) noexcept;

}  // namespace kanec::integrate
