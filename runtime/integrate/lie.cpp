// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>

#include "runtime/integrate/compensated.hpp"
#include "runtime/integrate/fixed_step.hpp"
#include "runtime/integrate/norm.hpp"

namespace kanec::integrate {
namespace {

using Vector = std::array<double, 3>;

Vector cross(const Vector& a, const Vector& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

double square(const Vector& a) { return a[0] * a[0] + a[1] * a[1] + a[2] * a[2]; }

// ω = 2 Ξ(ε)ᵀ ε̇, body axes, of any joint: all of them move ε by ε̇ = ½ Ξ(ε) ω.
Vector angular_velocity(const double* e, const double* edot) {
  const Vector across = cross({e[0], e[1], e[2]}, {edot[0], edot[1], edot[2]});
  Vector omega;
  for (std::size_t i = 0; i < 3; ++i) omega[i] = 2.0 * (e[3] * edot[i] - edot[3] * e[i] - across[i]);
  return omega;
}

// Below this square of an angle series take over, which are faster, and do not cancel: what they leave out is below
// 1e-17.
constexpr double small_square = 0.02;

// (1 − ½ θ cot ½θ) / θ² of the square of an angle below one turn.
double second_coefficient(double w) {
  if (w < small_square) return 1.0 / 12 + w * (1.0 / 720 + w * (1.0 / 30240 + w * (1.0 / 1209600 + w / 47900160)));
  const double half = 0.5 * std::sqrt(w);
  return (1.0 - half / std::tan(half)) / w;
}

// sin(½θ)/θ and cos(½θ) − 1 of the square of an angle.
struct HalfAngle {
  double sine_part, cosine_less_one;
};
HalfAngle half_angle(double w) {
  if (w < small_square)
    return {0.5 - w * (1.0 / 48 - w * (1.0 / 3840 - w * (1.0 / 645120 - w / 185794560))),
            -w * (1.0 / 8 - w * (1.0 / 384 - w * (1.0 / 46080 - w * (1.0 / 10321920 - w / 3715891200))))};
  const double angle = std::sqrt(w), quarter = std::sin(0.25 * angle);
  return {std::sin(0.5 * angle) / angle, -2.0 * quarter * quarter};
}

// σ̇ = ω + ½ σ × ω + c σ × (σ × ω), where exp(σ) turns the body from where it was, σ in body axes (Bortz 1971).
Vector rotation_vector_rate(const Vector& sigma, const Vector& omega) {
  const Vector once = cross(sigma, omega), twice = cross(sigma, once);
  const double c = second_coefficient(square(sigma));
  Vector rate;
  for (std::size_t i = 0; i < 3; ++i) rate[i] = omega[i] + 0.5 * once[i] + c * twice[i];
  return rate;
}

// ε exp(σ) − ε, without the cancellation of that difference.
std::array<double, 4> change_of_attitude(const double* eps, const Vector& sigma) {
  const auto [part, less] = half_angle(square(sigma));
  const Vector e = {part * sigma[0], part * sigma[1], part * sigma[2]};
  const Vector across = cross({eps[0], eps[1], eps[2]}, e);
  std::array<double, 4> change;
  for (std::size_t i = 0; i < 3; ++i) change[i] = eps[3] * e[i] + across[i] + less * eps[i];
  change[3] = less * eps[3] - (eps[0] * e[0] + eps[1] * e[1] + eps[2] * e[2]);
  return change;
}

// The classical Runge-Kutta method where it is linear, in the rotation vectors since the step's start and all other
// coordinates (Munthe-Kaas 1998): attitudes are products of rotations, which no projection has to mend. Sums and
// products over steps are compensated.
class Lie final : public FixedStep {
 public:
  Lie(System& system, std::vector<double> z, const Options& options, StepBook& book)
      : FixedStep(system, std::move(z), options, book),
        total_(z_),
        stage_(z_),
        rate_(z_.size()),
        sum_(z_.size()),
        at_(z_.size()) {
    carry(total_.rest());
  }

 private:
  // In `at_` and `rate_`, three entries of each set of Euler parameters are the rotation vector and its rate, the
  // fourth is 0.
  double take(double t, double h) override {
    std::fill(at_.begin(), at_.end(), 0.0);
    std::fill(sum_.begin(), sum_.end(), 0.0);
    constexpr std::array<double, 4> part = {0.0, 0.5, 0.5, 1.0}, weight = {1.0, 2.0, 2.0, 1.0};
    for (std::size_t stage = 0; stage < 4; ++stage) {
      for (std::size_t i = 0; i < at_.size(); ++i) at_[i] = part[stage] * h * rate_[i];
      move(at_, [this](std::size_t i, double change) { stage_[i] = total_.with(i, change); });
      evaluate(t + part[stage] * h, stage_.data(), rate_.data());
      turn_rates();
      for (std::size_t i = 0; i < sum_.size(); ++i) sum_[i] += weight[stage] * rate_[i];
    }
    for (double& entry : sum_) entry *= h / 6.0;
    move(sum_, [this](std::size_t i, double change) { total_.add(i, change); });
    return norm_error(z_.data(), system().attitudes());
  }

  // Gives the change of each entry of z by a change of the rotation vectors and the rest.
  template <class Take>
  void move(const std::vector<double>& by, const Take& take) const {
    std::size_t next = 0;
    for (const int first : system().attitudes()) {
      const auto at = static_cast<std::size_t>(first);
      for (; next < at; ++next) take(next, by[next]);
      const std::array<double, 4> change = change_of_attitude(&z_[at], {by[at], by[at + 1], by[at + 2]});
      for (std::size_t i = 0; i < 4; ++i) take(at + i, change[i]);
      next = at + 4;
    }
    for (; next < by.size(); ++next) take(next, by[next]);
  }

  // Rates of Euler parameters in `rate_` to those of rotation vectors.
  void turn_rates() {
    for (const int first : system().attitudes()) {
      const auto at = static_cast<std::size_t>(first);
      const Vector omega = angular_velocity(&stage_[at], &rate_[at]);
      const Vector rate = rotation_vector_rate({at_[at], at_[at + 1], at_[at + 2]}, omega);
      std::copy(rate.begin(), rate.end(), &rate_[at]);
      rate_[at + 3] = 0.0;
    }
  }

  Compensated total_;
  std::vector<double> stage_, rate_, sum_, at_;
};

}  // namespace

std::unique_ptr<Stepper> make_lie(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<Lie>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
