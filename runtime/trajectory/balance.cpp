// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/trajectory/balance.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/integrate/norm.hpp"

namespace kanec {

using namespace integrate;

namespace {

void add_momentum(MomentumChange& change, const double* now, bool first) {
  std::copy(now, now + 3, change.end.begin());
  if (first) change.start = change.end;
  const auto& a = change.start;
  const double difference = std::hypot(now[0] - a[0], now[1] - a[1], now[2] - a[2]);
  const double scale = worse(change.worst.scale, std::hypot(now[0], now[1], now[2]));
  change.at_end = {difference, scale};
  change.worst = {worse(change.worst.value, difference), scale};
}

}  // namespace

std::optional<Energy> Balance::add(double t, const double* x, const double* y, double work) {
  std::optional<Energy> energy;
  if (energy_) {
    std::array<double, 2> out{};
    solver_->evaluate(*energy_, t, x, y, nullptr, out.data());
    energy = Energy{out[0], out[1]};
    watch_.add(*energy, work);
  }
  if (momentum_) {
    std::array<double, 6> out{};
    solver_->evaluate(*momentum_, t, x, y, nullptr, out.data());
    add_momentum(linear_, out.data(), first_);
    add_momentum(angular_, out.data() + 3, first_);
  }
  first_ = false;
  return energy;
}

void EnergyWatch::add(const Energy& energy, double total_work) {
  if (first_) {
    work_before_ = total_work;
    balance_.start = energy;
    lowest_potential_ = highest_potential_ = energy.potential;
    first_ = false;
  }
  const double work = total_work - work_before_;
  balance_.end = energy;
  balance_.work = work;
  largest_kinetic_ = worse(largest_kinetic_, energy.kinetic);
  largest_work_ = worse(largest_work_, std::fabs(work));
  lowest_potential_ = std::min(lowest_potential_, energy.potential);
  highest_potential_ = std::max(highest_potential_, energy.potential);
  balance_.at_end.value = balance_.change() - work;
  balance_.worst.value = worse(balance_.worst.value, std::fabs(balance_.at_end.value));
}

std::optional<EnergyBalance> Balance::energy() const {
  return energy_ ? std::optional(watch_.balance()) : std::nullopt;
}

EnergyBalance EnergyWatch::balance() const {
  EnergyBalance balance = balance_;
  balance.at_end.scale = largest_kinetic_ + (highest_potential_ - lowest_potential_) + largest_work_;
  balance.worst.scale = balance.at_end.scale;
  return balance;
}

}  // namespace kanec
