// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/integrate/fixed_step.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/lanes/rk4_step.hpp"

namespace kanec::integrate {
namespace {

// The classical fourth-order method; projects after every step.
class Rk4 final : public FixedStep {
 public:
  Rk4(System& system, std::vector<double> z, const Options& options, StepBook& book)
      : FixedStep(system, std::move(z), options, book), work_(3 * z_.size()) {}

 private:
  double take(double t, double h) override {
    const auto rates = [this](double at, const double* z, double* zdot) { evaluate(at, z, zdot); };
    rk4_step(static_cast<int>(z_.size()), z_.data(), work_.data(), t, h, rates);
    return normalise(z_.data(), system().attitudes());
  }

  std::vector<double> work_;
};

}  // namespace

std::unique_ptr<Stepper> make_rk4(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<Rk4>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
