// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/compensated.hpp"
#include "runtime/integrate/dop853_coefficients.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/stepper.hpp"

namespace kanec::integrate {
namespace {

// Steps of order 8, as long as the estimate of order 5 alone allows (weighted root of the mean square at most 1): of
// the estimates that this pair and others offer it is the one that vanishes least where loads saturate or switch. Rows
// are values of the polynomial within a step. The sum over steps is compensated.
class Dop853 final : public Stepper {
 public:
  Dop853(System& system, std::vector<double> z, const Options& options, StepBook& book)
      : system_(system),
        book_(book),
        relative_(options.relative_tolerance),
        absolute_(options.absolute_tolerance),
        end_(options.duration),
        longest_(options.longest_step > 0.0 ? options.longest_step : std::numeric_limits<double>::infinity()),
        z_(std::move(z)),
        total_(z_),
        start_(z_),
        stage_(z_),
        row_(z_),
        t_(options.start),
        begin_(options.start) {
    for (std::vector<double>& rate : rates_) rate.assign(z_.size(), 0.0);
    for (std::vector<double>& coefficient : polynomial_) coefficient.assign(z_.size(), 0.0);
    begin();
  }

  double time() const override { return t_; }

  void step(double) override {
    if (t_ >= end_) return;
    start_ = z_;
    rest_at_start_ = total_.rest();
    begin_ = t_;
    has_polynomial_ = false;
    if (is_ended_) std::swap(rates_[0], rates_[n_stages]);
    is_ended_ = false;
    for (bool is_tried_again = false;; is_tried_again = true) {
      const double end = end_of_step();
      if (!(end > begin_)) give_up();
      const double error = attempt(end - begin_);
      if (error <= 1.0 && finish(end)) return adapt(error, is_tried_again);
      ++book_.failed;
      if (end - begin_ <= least_step * std::fabs(begin_)) give_up();
      h_ = (end - begin_) *
           (error > 1.0 ? std::max(shortest_factor, safety * std::pow(error, -exponent)) : shortest_factor);
    }
  }

  std::span<const double> at(double t) override {
    if (t == t_) return z_;
    if (!(t > begin_)) return start_;
    if (!has_polynomial_) find_polynomial();
    const double x = (t - begin_) / (t_ - begin_);
    for (std::size_t i = 0; i < row_.size(); ++i) {
      double change = 0.0;
      for (std::size_t k = polynomial_.size(); k-- > 0;)
        change = (change + polynomial_[k][i]) * ((polynomial_.size() - 1 - k) % 2 == 0 ? x : 1.0 - x);
      row_[i] = start_[i] + change;
    }
    normalise(row_.data(), system_.attitudes());
    return row_;
  }

  void restart(double t, std::span<const double> z) override {
    std::copy(z.begin(), z.end(), z_.begin());
    std::fill(total_.rest().begin(), total_.rest().end(), 0.0);
    t_ = begin_ = t;
    start_ = z_;
    has_polynomial_ = is_ended_ = false;
    begin();
  }

 private:
  static constexpr std::size_t n_stages = dop853::n_stages, n_rates = n_stages + 1 + dop853::n_dense_stages;
  // Of the step by the error (Hairer, Nørsett & Wanner II.4); the estimate falls with the sixth power.
  static constexpr double safety = 0.9, shortest_factor = 0.2, longest_factor = 5.0, exponent = 1.0 / 6;
  static constexpr double exponent_now = 0.7 / 6, exponent_before = 0.4 / 6;
  static constexpr double least_error = 1e-4;                                        // that is remembered
  static constexpr double least_step = 10 * std::numeric_limits<double>::epsilon();  // beside the time

  // With the rate at the start, and a first step (Hairer, Nørsett & Wanner II.4).
  void begin() {
    if (t_ >= end_) return;
    evaluate(t_, z_, rates_[0]);
    const double size = weighted(z_, z_), change = weighted(rates_[0], z_);
    double h = size < 1e-5 || change < 1e-5 ? 1e-6 : 0.01 * size / change;
    h = std::min({h, longest_, end_ - t_});
    for (std::size_t i = 0; i < z_.size(); ++i) stage_[i] = z_[i] + h * rates_[0][i];
    normalise(stage_.data(), system_.attitudes());
    double turn = change;
    if (system_.rates(t_ + h, stage_.data(), rates_[1].data())) {
      for (std::size_t i = 0; i < z_.size(); ++i) stage_[i] = rates_[1][i] - rates_[0][i];
      turn = std::max(change, weighted(stage_, z_) / h);
    }
    const double longer = turn <= 1e-15 ? std::max(1e-6, h * 1e-3) : std::pow(0.01 / turn, 1.0 / 8);
    h_ = std::min({100 * h, longer, longest_});
    error_before_ = least_error;
  }

  // No sliver is left before the end.
  double end_of_step() const {
    const double h = std::min(h_, longest_), left = end_ - begin_;
    return 1.01 * h >= left ? end_ : begin_ + h;
  }

  // Rates of the stages and the change of z, into stage_; the error beside the tolerance, infinite where a rate is not
  // finite.
  double attempt(double h) {
    for (std::size_t stage = 1; stage < n_stages; ++stage) {
      combine(dop853::stages[stage - 1], h);
      for (std::size_t i = 0; i < z_.size(); ++i) stage_[i] = total_.with(i, stage_[i]);
      if (!system_.rates(begin_ + dop853::times[stage - 1] * h, stage_.data(), rates_[stage].data()))
        return std::numeric_limits<double>::infinity();
    }
    double squares = 0.0;
    combine(dop853::b, h);
    for (std::size_t i = 0; i < z_.size(); ++i) {
      double error = 0.0;
      for (const auto& [stage, weight] : dop853::error_of_order_5) error += weight * rates_[stage][i];
      const double size = std::max(std::fabs(z_[i]), std::fabs(z_[i] + stage_[i]));
      const double share = h * error / (absolute_ + relative_ * size);
      squares += share * share;
    }
    return std::sqrt(squares / static_cast<double>(z_.size()));
  }

  // The step to this end is taken, unless the rates there are not finite.
  bool finish(double end) {
    for (std::size_t i = 0; i < z_.size(); ++i) total_.add(i, stage_[i]);
    const double norm_error = normalise(z_.data(), system_.attitudes());
    if (!system_.rates(end, z_.data(), rates_[n_stages].data())) {
      z_ = start_;
      total_.rest() = rest_at_start_;
      return false;
    }
    is_ended_ = true;
    t_ = end;
    book_.accepted(end, norm_error);
    return true;
  }

  void adapt(double error, bool is_tried_again) {
    const double now = std::max(error, least_error);
    double factor = safety * std::pow(now, -exponent_now) * std::pow(error_before_, exponent_before);
    factor = std::clamp(factor, shortest_factor, is_tried_again ? 1.0 : longest_factor);
    error_before_ = now;
    h_ = (t_ - begin_) * factor;
  }

  // h times a weighted sum of rates, into stage_.
  void combine(std::span<const dop853::Weight> weights, double h) {
    std::fill(stage_.begin(), stage_.end(), 0.0);
    for (const auto& [stage, weight] : weights)
      for (std::size_t i = 0; i < stage_.size(); ++i) stage_[i] += weight * rates_[stage][i];
    for (double& entry : stage_) entry *= h;
  }

  void find_polynomial() {
    const double h = t_ - begin_;
    for (std::size_t k = 0; k < dop853::n_dense_stages; ++k) {
      combine(dop853::dense_stages[k], h);
      for (std::size_t i = 0; i < stage_.size(); ++i) stage_[i] += start_[i];
      evaluate(begin_ + dop853::dense_times[k] * h, stage_, rates_[n_stages + 1 + k]);
    }
    for (std::size_t i = 0; i < start_.size(); ++i) {
      const double change = z_[i] - start_[i], first = h * rates_[0][i], last = h * rates_[n_stages][i];
      polynomial_[0][i] = change;
      polynomial_[1][i] = first - change;
      polynomial_[2][i] = 2 * change - (first + last);
    }
    for (std::size_t k = 0; k < dop853::dense.size(); ++k) {
      combine(dop853::dense[k], h);
      polynomial_[3 + k] = stage_;
    }
    has_polynomial_ = true;
  }

  // Root of the mean square of entries beside the tolerance of z.
  double weighted(const std::vector<double>& entries, const std::vector<double>& z) const {
    double squares = 0.0;
    for (std::size_t i = 0; i < z.size(); ++i) {
      const double share = entries[i] / (absolute_ + relative_ * std::fabs(z[i]));
      squares += share * share;
    }
    return std::sqrt(squares / static_cast<double>(z.size()));
  }

  void evaluate(double t, const std::vector<double>& z, std::vector<double>& rate) {
    if (!system_.rates(t, z.data(), rate.data())) system_.throw_fault();
  }

  [[noreturn]] void give_up() {
    if (system_.fault() && system_.fault()->t >= begin_) system_.throw_fault();
    throw IntegrationError("integration stopped at t = " + shortest(begin_) + " s: the rate of " +
                           system_.fastest(begin_, start_.data()) + " changes so fast that no step is short enough");
  }

  System& system_;
  StepBook& book_;
  double relative_, absolute_, end_, longest_;
  std::vector<double> z_;  // at t_
  Compensated total_;
  std::vector<double> start_, stage_, row_, rest_at_start_;
  double t_, begin_;  // of the last step
  double h_ = 0.0;    // wanted
  double error_before_ = least_error;
  std::array<std::vector<double>, n_rates> rates_;  // of the stages, at the end, of the further stages
  bool is_ended_ = false;                           // the rate at the end is that of t_
  bool has_polynomial_ = false;
  std::array<std::vector<double>, 7> polynomial_;  // of the last step
};

}  // namespace

std::unique_ptr<Stepper> make_dop853(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  return std::make_unique<Dop853>(system, std::move(z), options, book);
}

}  // namespace kanec::integrate
