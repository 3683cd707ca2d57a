// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/compensated.hpp"
#include "runtime/integrate/fixed_step.hpp"
#include "runtime/integrate/norm.hpp"

namespace kanec::integrate {
namespace {

// Collocation at the zeros of the Legendre polynomial of degree s, order 2 s (Hairer, Lubich & Wanner, II.1.3).
template <std::size_t s>
struct Tableau {
  std::array<double, s> c, b;
  std::array<std::array<double, s>, s> a;
};

const double r3 = std::sqrt(3.0), r15 = std::sqrt(15.0);

const Tableau<2> order_4 = {{0.5 - r3 / 6, 0.5 + r3 / 6}, {0.5, 0.5}, {{{0.25, 0.25 - r3 / 6}, {0.25 + r3 / 6, 0.25}}}};

const Tableau<3> order_6 = {{0.5 - r15 / 10, 0.5, 0.5 + r15 / 10},
                            {5.0 / 18, 4.0 / 9, 5.0 / 18},
                            {{{5.0 / 36, 2.0 / 9 - r15 / 15, 5.0 / 36 - r15 / 30},
                              {5.0 / 36 + r15 / 24, 2.0 / 9, 5.0 / 36 - r15 / 24},
                              {5.0 / 36 + r15 / 30, 2.0 / 9 + r15 / 15, 5.0 / 36}}}};

// Keeps every quadratic invariant, so that |ε| = 1 needs no projection: ε̇ is linear in ε and in ω. Symmetric: energy
// does not drift. The stages are iterated until rounding stops them; the sum over steps is compensated.
template <std::size_t s>
class Gauss final : public FixedStep {
 public:
  Gauss(System& system, std::vector<double> z, const Options& options, const Tableau<s>& tableau, StepBook& book)
      : FixedStep(system, std::move(z), options, book),
        tableau_(tableau),
        least_size_(1000 * options.absolute_tolerance),
        sum_(z_),
        size_(z_.size()),
        stage_(z_),
        rate_(z_.size()) {
    for (auto* list : {&rates_, &guesses_}) list->fill(std::vector<double>(z_.size()));
    for (std::vector<double>& rate : rates_) carry(rate);
    carry(sum_.rest());
    carry(last_step_);
  }

 private:
  double take(double t, double h) override {
    guess(t, h);
    iterate(t, h);
    for (std::size_t i = 0; i < z_.size(); ++i) {
      double change = 0.0;
      for (std::size_t j = 0; j < s; ++j) change += tableau_.b[j] * rates_[j][i];
      sum_.add(i, h * change);
    }
    last_step_[0] = h;
    return norm_error(z_.data(), system().attitudes());
  }

  // The rates as the last step's polynomial goes on; at first those at the start.
  void guess(double t, double h) {
    if (last_step_[0] == 0.0) {
      evaluate(t, z_.data(), rate_.data());
      rates_.fill(rate_);
      return;
    }
    guesses_ = rates_;
    for (std::size_t j = 0; j < s; ++j) {
      std::array<double, s> weight;
      for (std::size_t l = 0; l < s; ++l) weight[l] = lagrange(l, 1.0 + tableau_.c[j] * h / last_step_[0]);
      for (std::size_t i = 0; i < z_.size(); ++i) {
        rates_[j][i] = 0.0;
        for (std::size_t l = 0; l < s; ++l) rates_[j][i] += weight[l] * guesses_[l][i];
      }
    }
  }

  double lagrange(std::size_t l, double c) const {
    double value = 1.0;
    for (std::size_t m = 0; m < s; ++m)
      if (m != l) value *= (c - tableau_.c[m]) / (tableau_.c[l] - tableau_.c[m]);
    return value;
  }

  // Until the stages change by rounding alone, which no longer falls (Hairer, Lubich & Wanner, VIII.6).
  void iterate(double t, double h) {
    for (std::size_t i = 0; i < z_.size(); ++i) size_[i] = std::max(size_[i], std::fabs(z_[i]));
    double least = std::numeric_limits<double>::infinity();
    int stalled = 0;
    for (int count = 0; count < most_iterations; ++count) {
      const double change = improve(t, h, count == 0);
      if (!std::isfinite(change)) refuse(t, h);
      if (change == 0.0 || (change >= least && change < rounding)) return;
      stalled = change < least ? 0 : stalled + 1;
      least = std::min(least, change);
      if (stalled >= patience && least < noise) return;
    }
    if (least >= rounding) refuse(t, h);  // below it each iteration was a little better
  }

  [[noreturn]] void refuse(double t, double h) const {
    throw IntegrationError("integration stopped at t = " + shortest(t) + " s: the stages of a step of " + shortest(h) +
                           " s do not converge, least of all " + system().component(worst_) +
                           "; take shorter steps, or a method for stiff systems");
  }

  // One sweep; returns the largest change of a stage beside the largest value that its component has had.
  double improve(double t, double h, bool is_first) {
    double largest = 0.0;
    for (std::size_t j = 0; j < s; ++j) {
      for (std::size_t i = 0; i < z_.size(); ++i) {
        double sum = 0.0;
        for (std::size_t l = 0; l < s; ++l) sum += tableau_.a[j][l] * rates_[l][i];
        stage_[i] = sum_.with(i, h * sum);
      }
      if (!system().rates(t + tableau_.c[j] * h, stage_.data(), rate_.data())) {
        if (is_first) system().throw_fault();
        return std::numeric_limits<double>::infinity();  // the stages run away
      }
      for (std::size_t i = 0; i < z_.size(); ++i) {
        const double change = std::fabs(h * (rate_[i] - rates_[j][i]));
        if (change > 0.0) {
          const double share = change / (least_size_ + size_[i] + std::fabs(h * rate_[i]));
          const bool is_state = static_cast<int>(i) < system().nx() + system().ny();
          if (!(share <= largest) && (is_state || largest == 0.0)) worst_ = static_cast<int>(i);
          largest = worse(largest, share);
        }
        rates_[j][i] = rate_[i];
      }
    }
    return largest;
  }

  static constexpr int most_iterations = 100;
  static constexpr double rounding = 1e-12;  // below it a change that no longer falls is taken for rounding
  static constexpr int patience = 6;         // changes in a row that do not fall
  static constexpr double noise = 1e-6;      // below it these are taken for rounding of the rates

  const Tableau<s>& tableau_;
  double least_size_;  // that changes are set beside: what rounding makes of a zero does not converge
  std::vector<double> last_step_ = {0.0};  // its length; one entry
  int worst_ = 0;                          // component that changed most in the last sweep, of the state if any
  Compensated sum_;                        // over the steps
  std::vector<double> size_;               // largest magnitude of each component so far
  std::vector<double> stage_, rate_;
  std::array<std::vector<double>, s> rates_, guesses_;
};

}  // namespace

std::unique_ptr<Stepper> make_gauss(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  if (options.method == Method::gauss4) return std::make_unique<Gauss<2>>(system, std::move(z), options, order_4, book);
  return std::make_unique<Gauss<3>>(system, std::move(z), options, order_6, book);
}

}  // namespace kanec::integrate
