// What physics keeps, watched row by row: energy against work, linear and angular momentum. Not: the integration.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <array>
#include <optional>

#include "runtime/abi/solver.hpp"

namespace kanec {

struct Energy {
  double kinetic = 0.0, potential = 0.0;  // [J]
  double total() const { return kinetic + potential; }
};

// A deviation beside the size of what it deviates from. 0 / 0 counts as 0.
struct Deviation {
  double value = 0.0;
  double scale = 0.0;
  double relative() const { return value == 0.0 ? 0.0 : value / scale; }
};

// Energy change minus work of the applied loads, which is zero but for errors.
struct EnergyBalance {
  Energy start, end;
  double work = 0.0;  // of the applied loads since the first row, gravity not included [J]
  double change() const { return end.total() - start.total(); }
  Deviation
      at_end;  // signed; scale: largest kinetic energy + range of the potential one + largest |work|, over all rows
  Deviation worst;  // magnitude, over all rows; same scale
};

// Change of a momentum vector, inertial axes: kept where neither gravity nor loads act on the system as a whole.
struct MomentumChange {
  std::array<double, 3> start{}, end{};
  Deviation at_end;  // |end - start|; scale: largest magnitude of the vector over all rows
  Deviation worst;   // the same over all rows
};

// The same for the energies of one run, row by row.
class EnergyWatch {
 public:
  void add(const Energy& energy, double work);
  EnergyBalance balance() const;

 private:
  bool first_ = true;
  EnergyBalance balance_;
  double work_before_ = 0.0;
  double largest_kinetic_ = 0.0, largest_work_ = 0.0, lowest_potential_ = 0.0, highest_potential_ = 0.0;
};

class Balance {
 public:
  explicit Balance(const Solver& solver)
      : solver_(&solver), energy_(solver.find("energy")), momentum_(solver.find("momentum")) {}

  // Takes in one row; returns its energy where the model has that function.
  std::optional<Energy> add(double t, const double* x, const double* y, double work);

  // Empty where the model was emitted without `energy`, `momentum`.
  std::optional<EnergyBalance> energy() const;
  std::optional<MomentumChange> linear_momentum() const { return momentum_ ? std::optional(linear_) : std::nullopt; }
  std::optional<MomentumChange> angular_momentum() const { return momentum_ ? std::optional(angular_) : std::nullopt; }

 private:
  const Solver* solver_;
  const kanec_function *energy_, *momentum_;
  bool first_ = true;
  EnergyWatch watch_;
  MomentumChange linear_, angular_;
};

}  // namespace kanec
