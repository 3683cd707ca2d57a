// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/system.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/norm.hpp"

namespace kanec::integrate {
namespace {

const kanec_function* required(const Solver& solver, const char* name) {
  const kanec_function* function = solver.find(name);
  if (!function)
    throw InputError(std::string("model ") + solver.model().name + " has no function '" + name +
                     "', which integration needs");
  return function;
}

// All exponents at once, in integers: adding one to an exponent of all ones carries into the sign bit.
bool all_finite(std::span<const double> values) noexcept {
  constexpr std::uint64_t exponent = 0x7ff0000000000000u, one = 0x0010000000000000u;
  std::uint64_t carries = 0;
  for (const double value : values) carries |= (std::bit_cast<std::uint64_t>(value) & exponent) + one;
  return (carries >> 63) == 0;
}

void require_size(const char* what, std::size_t found, int allowed) {
  if (found != static_cast<std::size_t>(allowed))
    throw InputError(std::string("initial ") + what + ": found " + std::to_string(found) +
                     " numbers; allowed: " + std::to_string(allowed));
}

}  // namespace

int first_not_finite(std::span<const double> values) noexcept {
  for (std::size_t i = 0; i < values.size(); ++i)
    if (!std::isfinite(values[i])) return static_cast<int>(i);
  return -1;
}

System::System(const Solver& solver)
    : solver_(&solver),
      kinematics_(required(solver, "kinematics")),
      accelerations_(required(solver, "accelerations")),
      power_(solver.find("power")),
      n_bodies_(solver.model().n_bodies),
      nx_(solver.model().nx),
      ny_(solver.model().ny) {
  if (nx_ != 7 * n_bodies_ || ny_ != 6 * n_bodies_)
    throw InternalError(std::string("model ") + solver.model().name + " has joints that integration does not know");
}

bool System::rates(double t, const double* z, double* zdot) noexcept {
  const double* x = z;
  const double* y = z + nx_;
  double* ydot = zdot + nx_;
  solver_->evaluate(*kinematics_, t, x, y, nullptr, zdot);
  solver_->evaluate(*accelerations_, t, x, y, nullptr, ydot);
  if (power_) solver_->evaluate(*power_, t, x, y, ydot, ydot + ny_);
  ++evaluations_;
  const std::span<const double> all(zdot, static_cast<std::size_t>(size()));
  if (all_finite(all)) return true;
  fault_ = Fault{t, first_not_finite(all)};
  return false;
}

std::vector<double> System::initial_state(std::span<const double> x, std::span<const double> y) const {
  require_size("coordinates", x.size(), nx_);
  require_size("speeds", y.size(), ny_);
  std::vector<double> z(x.begin(), x.end());
  z.insert(z.end(), y.begin(), y.end());
  z.resize(static_cast<std::size_t>(size()), 0.0);
  if (const int index = first_not_finite(z); index >= 0)
    throw InputError("initial state: " + component(index) + ": found " + shortest(z[static_cast<std::size_t>(index)]) +
                     "; allowed: a finite number");
  for (int body = 0; body < n_bodies_; ++body)
    if (const double error = norm_error(&z[static_cast<std::size_t>(4 * body)], 1); error > 1e-6)
      throw InputError("initial state: body " + std::to_string(body + 1) + ": Euler parameters are " + shortest(error) +
                       " from unit norm; allowed: at most 1e-6");
  normalise(z.data(), n_bodies_);
  return z;
}

std::string System::component(int index) const {
  struct Block {
    const char* name;
    int width, begin;
  };
  const std::array<Block, 4> blocks = {
      {{"eps", 4, 0}, {"s", 3, 4 * n_bodies_}, {"omega", 3, nx_}, {"sdot", 3, nx_ + 3 * n_bodies_}}};
  if (index >= nx_ + ny_) return "work of the applied loads";
  const auto block = std::find_if(blocks.rbegin(), blocks.rend(), [&](const Block& b) { return index >= b.begin; });
  const int offset = index - block->begin;
  return "body " + std::to_string(offset / block->width + 1) + ", " + block->name + "_" +
         std::to_string(offset % block->width + 1);
}

void System::throw_fault() const {
  if (!fault_) throw InternalError("no rate was found that is not finite");
  throw IntegrationError("integration stopped at t = " + shortest(fault_->t) + " s: the rate of " +
                         component(fault_->index) + " is not finite");
}

}  // namespace kanec::integrate
