// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/system.hpp"

#include <algorithm>
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

// kinematics, accelerations and power in one, which is ż as it stands
constexpr const char* all_rates = "kinematics_and_accelerations_and_power";

std::vector<int> first_indices(const kanec_model& model) {
  std::vector<int> list;
  for (int i = 0; i < model.n_attitudes; ++i) list.push_back(model.attitudes[i].eps);
  return list;
}

std::string component_name(const kanec_model& model, int index) {
  if (index < model.nx) return model.coordinate_names[index];
  if (index < model.nx + model.ny) return model.speed_names[index - model.nx];
  return "work of the applied loads";
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
      nx_(solver.model().nx),
      ny_(solver.model().ny),
      calls_(calls()),
      residual_(solver.find(solver.find("power") || solver.find(all_rates) ? "kinematics_and_residual_and_power"
                                                                           : "kinematics_and_residual")),
      has_work_(solver.find("power") || solver.find(all_rates)),
      size_(std::max(nx_ + ny_ + (has_work_ ? 1 : 0), 1)),
      attitudes_(first_indices(solver.model())) {}

std::vector<System::Call> System::calls() const {
  if (const kanec_function* all = solver_->find(all_rates)) return {{all, 0}};
  std::vector<Call> list;
  if (const kanec_function* both = solver_->find("kinematics_and_accelerations"))
    list = {{both, 0}};
  else
    list = {{required(*solver_, "kinematics"), 0}, {required(*solver_, "accelerations"), nx_}};
  if (const kanec_function* power = solver_->find("power")) list.push_back({power, nx_ + ny_});
  return list;
}

bool System::rates(double t, const double* z, double* zdot) noexcept {
  zdot[size_ - 1] = 0.0;  // where nothing else is written
  for (const Call& call : calls_) solver_->evaluate(*call.function, t, z, z + nx_, nullptr, zdot + call.offset);
  return counted(t, zdot);
}

bool System::residual(double t, const double* z, const double* zdot, double* F) noexcept {
  F[size_ - 1] = 0.0;
  solver_->evaluate(*residual_, t, z, z + nx_, zdot + nx_, F);
  for (int i = 0; i < nx_; ++i) F[i] = zdot[i] - F[i];
  for (int i = nx_ + ny_; i < size_; ++i) F[i] = zdot[i] - F[i];
  return counted(t, F);
}

bool System::counted(double t, const double* results) noexcept {
  ++evaluations_;
  const std::span<const double> all(results, static_cast<std::size_t>(size_));
  if (all_finite(all)) return true;
  fault_ = Fault{t, first_not_finite(all)};
  return false;
}

std::vector<double> state_at_start(const kanec_model& model, std::span<const double> x, std::span<const double> y) {
  require_size("coordinates", x.size(), model.nx);
  require_size("speeds", y.size(), model.ny);
  std::vector<double> z(x.begin(), x.end());
  z.insert(z.end(), y.begin(), y.end());
  const std::vector<int> attitudes = first_indices(model);
  if (const int index = first_not_finite(z); index >= 0)
    throw InputError("initial state: " + component_name(model, index) + ": found " +
                     shortest(z[static_cast<std::size_t>(index)]) + "; allowed: a finite number");
  for (const int at : attitudes)
    if (const double error = std::fabs(norm(&z[static_cast<std::size_t>(at)]) - 1.0); !(error <= 1e-6))
      throw InputError("initial state: " + component_name(model, at) + " to _4: Euler parameters are " +
                       shortest(error) + " from unit norm; allowed: at most 1e-6");
  normalise(z.data(), attitudes);
  return z;
}

std::vector<double> System::initial_state(std::span<const double> x, std::span<const double> y, double work) const {
  std::vector<double> z = state_at_start(solver_->model(), x, y);
  z.resize(static_cast<std::size_t>(size_), 0.0);
  if (has_work_) z.back() = work;
  return z;
}

std::string System::component(int index) const { return component_name(solver_->model(), index); }

std::string System::fastest(double t, const double* z) {
  std::vector<double> rate(static_cast<std::size_t>(size_));
  if (!rates(t, z, rate.data())) return component(fault_->index);
  const auto beside = [&](int i) { return std::fabs(rate[static_cast<std::size_t>(i)]) / (1.0 + std::fabs(z[i])); };
  int fastest = 0;
  for (int i = 1; i < nx_ + ny_; ++i)
    if (beside(i) > beside(fastest)) fastest = i;
  return component(fastest);
}

void System::throw_fault() const {
  if (!fault_) throw InternalError("no rate was found that is not finite");
  throw IntegrationError("integration stopped at t = " + shortest(fault_->t) + " s: the rate of " +
                         component(fault_->index) + " is not finite");
}

}  // namespace kanec::integrate
