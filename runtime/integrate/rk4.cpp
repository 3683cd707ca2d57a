// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>

#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/stepper.hpp"

namespace kanec::integrate {
namespace {

// The classical fourth-order method (Kutta 1901); projects after every step.
class Rk4 final : public Stepper {
 public:
  Rk4(System& system, std::vector<double> z, double step, StepBook& book)
      : system_(system), book_(book), longest_(step), z_(std::move(z)), stage_(z_), rate_(z_.size()), sum_(z_.size()) {}

  std::span<const double> advance(double t) override {
    const double begin = t_;
    const std::int64_t steps = equal_steps(t - begin, longest_);
    for (std::int64_t i = 0; i < steps; ++i) {
      const double end =
          i + 1 == steps ? t : begin + (t - begin) * (static_cast<double>(i + 1) / static_cast<double>(steps));
      step(end - t_);
      t_ = end;
      book_.accepted(t_, normalise(z_.data(), system_.attitudes()));
    }
    return z_;
  }

 private:
  // z += h/6 (k1 + 2 k2 + 2 k3 + k4); no allocation
  void step(double h) {
    evaluate(t_, z_);
    std::copy(rate_.begin(), rate_.end(), sum_.begin());
    for (const double c : {0.5, 0.5, 1.0}) {
      for (std::size_t i = 0; i < z_.size(); ++i) stage_[i] = z_[i] + c * h * rate_[i];
      evaluate(t_ + c * h, stage_);
      const double weight = c == 0.5 ? 2.0 : 1.0;
      for (std::size_t i = 0; i < z_.size(); ++i) sum_[i] += weight * rate_[i];
    }
    for (std::size_t i = 0; i < z_.size(); ++i) z_[i] += h / 6.0 * sum_[i];
  }

  void evaluate(double t, const std::vector<double>& z) {
    if (!system_.rates(t, z.data(), rate_.data())) system_.throw_fault();
  }

  System& system_;
  StepBook& book_;
  double longest_;
  double t_ = 0.0;
  std::vector<double> z_, stage_, rate_, sum_;
};

}  // namespace

std::unique_ptr<Stepper> make_rk4(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<Rk4>(system, std::move(z), options.step, book);
}

}  // namespace kanec::integrate
