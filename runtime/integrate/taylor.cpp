// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>

#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/integrate/compensated.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/integrate/stepper.hpp"

namespace kanec::integrate {
namespace {

const kanec_taylor& series_of(const kanec_model& model, std::size_t scalar_size, int size) {
  for (const kanec_taylor& series : std::span(model.taylor, static_cast<std::size_t>(model.n_taylor)))
    if (static_cast<std::size_t>(series.scalar_size) == scalar_size && series.size == size) return series;
  throw InputError(std::string("model ") + model.name +
                   " was compiled without the Taylor series that this integrator needs");
}

struct Freed {
  std::align_val_t alignment;
  void operator()(void* memory) const { ::operator delete(memory, alignment); }
};
using Memory = std::unique_ptr<void, Freed>;

Memory memory(std::size_t bytes, std::size_t alignment) {
  const std::align_val_t aligned{std::max(alignment, alignof(std::max_align_t))};
  return Memory(::operator new(std::max<std::size_t>(bytes, 1), aligned), Freed{aligned});
}

// The series of one model, with its parameters and inputs.
template <class Real>
class Series {
 public:
  Series(const Solver& solver, int size)
      : solver_(solver),
        abi_(series_of(solver.model(), sizeof(Real), size)),
        prepared_(memory(abi_.prepared_size, abi_.alignment)),
        work_(memory(abi_.work_size, abi_.alignment)) {
    abi_.prepare(solver.parameters().data(), prepared_.get());
  }
  int highest_order() const { return abi_.highest_order; }
  void coefficients(double t, int order, Real* z) const {
    abi_.coefficients(prepared_.get(), t, solver_.inputs().data(), order, z, work_.get());
  }

 private:
  const Solver& solver_;
  const kanec_taylor& abi_;
  Memory prepared_, work_;
};

// z(t + tau) = (z + rest) + sum over k of c_k tau^k, k = 1 ... order; rest is what rounding took from z.
template <class Real>
struct Expansion {
  double t = 0.0;
  int order = 0;
  std::vector<Real> c;  // (order + 1) x size, z first
  std::vector<Real> rest;

  Real change(std::size_t i, Real tau) const {
    const std::size_t size = rest.size();
    Real sum = 0;
    for (int k = order; k >= 1; --k) sum = (sum + c[static_cast<std::size_t>(k) * size + i]) * tau;
    return sum;
  }
  Real rate(std::size_t i, Real tau) const {
    const std::size_t size = rest.size();
    Real sum = 0;
    for (int k = order; k >= 1; --k) sum = sum * tau + static_cast<Real>(k) * c[static_cast<std::size_t>(k) * size + i];
    return sum;
  }
};

// Steps by Taylor series (Jorba & Zou, A software package for the numerical integration of ODEs by means of high-order
// Taylor methods, 2005): a step ends where the last terms reach the tolerance, the order follows the least work a time.
// The next series is made at once: where its rates are not those that the step ended with, or no numbers, the motion is
// not analytic in between, and the step is halved. The sum over steps is compensated.
template <class Real>
class Taylor final : public Stepper {
 public:
  Taylor(System& system, const std::vector<double>& z, const Options& options, StepBook& book)
      : system_(system),
        book_(book),
        series_(system.solver(), system.size()),
        relative_(static_cast<Real>(options.relative_tolerance)),
        absolute_(static_cast<Real>(options.absolute_tolerance)),
        end_(options.duration),
        longest_(options.longest_step > 0.0 ? options.longest_step : std::numeric_limits<double>::infinity()),
        has_kinks_(options.has_kinks),
        order_(first_order(options.relative_tolerance)),
        largest_(z.size()),
        row_(z) {
    for (Expansion<Real>* one : {&now_, &next_, &inner_}) {
      one->c.assign(z.size() * static_cast<std::size_t>(series_.highest_order() + 1), Real(0));
      one->rest.assign(z.size(), Real(0));
    }
    std::copy(z.begin(), z.end(), now_.c.begin());
    expand(now_, options.start);
    begin();
  }

  double time() const override { return next_.t; }

  void step(double) override {
    std::swap(now_, next_);
    find_step();
  }

  // The state is that of the polynomial, which has more digits.
  void restart(double t, std::span<const double>) override {
    go_to(t);
    std::swap(now_, next_);
    begin();
  }

  std::span<const double> at(double t) override {
    const Real tau = static_cast<Real>(t) - static_cast<Real>(now_.t);
    for (std::size_t i = 0; i < row_.size(); ++i)
      row_[i] = static_cast<double>(now_.c[i] + (now_.rest[i] + now_.change(i, tau)));
    normalise(row_.data(), system_.attitudes());
    return row_;
  }

 private:
  // With the series in now_.
  void begin() {
    if (const auto bad = first_not_finite(now_))
      fail(now_.t, bad->component, bad->order < 2 ? "is not finite" : "has no Taylor series: it is not smooth there");
    next_.t = now_.t;
    find_step();
  }

  int first_order(double tolerance) const {
    const double best = 1.0 - 0.5 * std::log(std::max(tolerance, 1e-30));
    return std::clamp(static_cast<int>(std::lround(best)), lowest_order, series_.highest_order());
  }

  void expand(Expansion<Real>& at, double t) {
    at.t = t;
    at.order = order_;
    system_.count_evaluation();
    series_.coefficients(t, order_, at.c.data());
  }

  // From now_ to next_, whose series is made.
  void find_step() {
    if (now_.t >= end_) return;
    for (std::size_t i = 0; i < largest_.size(); ++i) largest_[i] = std::max(largest_[i], std::fabs(now_.c[i]));
    double h = std::min({step_of(now_.order), longest_, end_ - now_.t});
    const int limiting = worst_;
    order_ = next_order();
    worst_ = limiting;
    for (;; h /= 2) {
      // the end is met exactly, and no sliver is left before it
      const double left = end_ - now_.t;
      const double t = h >= left ? end_ : now_.t + (h > left / 2 ? left / 2 : h);
      if (!(t > now_.t)) fail(now_.t, worst_, "changes so fast that no step is short enough");
      const double norm_error = go_to(t);
      if (is_continued()) return book_.accepted(t, norm_error);
      ++book_.failed;
    }
  }

  // The tolerance of component i.
  Real allowed(std::size_t i) const { return relative_ * largest_[i] + absolute_; }

  // How long the term of order k stays below the tolerance, by the component where it leaves it first.
  double reach(int k) {
    Real worst = 0;
    for (std::size_t i = 0; i < row_.size(); ++i) {
      const Real share = std::fabs(now_.c[static_cast<std::size_t>(k) * row_.size() + i]) / allowed(i);
      if (share <= worst) continue;
      if (worst == 0 || static_cast<int>(i) < system_.nx() + system_.ny()) worst_ = static_cast<int>(i);
      worst = share;
    }
    return worst > 0 ? std::exp(-static_cast<double>(std::log(worst)) / k) : std::numeric_limits<double>::infinity();
  }
  // Of a series of this order, the last two terms being looked at: either may vanish by symmetry.
  double step_of(int order) { return std::min(reach(order), reach(order - 1)); }

  // The work of a series: what is done once for each order, and beside it pairs of coefficients in vectors, of which 60
  // take as long (measured on S6B).
  static double work(int order) { return static_cast<double>(order) * (order + 60.0); }

  int next_order() {
    const int order = now_.order;
    const double here = step_of(order) / work(order), below = step_of(order - 1) / work(order - 1);
    if (std::isinf(here)) return order;
    return std::clamp(below > here ? order - 1 : order + 1, lowest_order, series_.highest_order());
  }

  // The state at t, by the polynomial of now_.
  void move(Expansion<Real>& to, double t) const {
    const Real tau = static_cast<Real>(t) - static_cast<Real>(now_.t);
    for (std::size_t i = 0; i < row_.size(); ++i) {
      to.c[i] = now_.c[i];
      to.rest[i] = now_.rest[i];
      add_compensated(to.c[i], to.rest[i], now_.change(i, tau));
    }
  }

  // next_: the state at t and its series; returns | |eps| - 1 | before the correction.
  double go_to(double t) {
    move(next_, t);
    const double norm_error = correct_norms();
    expand(next_, t);
    return norm_error;
  }

  void add(std::size_t i, Real change) { add_compensated(next_.c[i], next_.rest[i], change); }

  double correct_norms() {
    double worst = 0.0;
    for (const int first : system_.attitudes()) {
      const auto at = static_cast<std::size_t>(first);
      Real excess = -1;  // of |eps|^2
      for (std::size_t i = at; i < at + 4; ++i) excess += next_.c[i] * next_.c[i];
      for (std::size_t i = at; i < at + 4; ++i) add(i, -excess / 2 * next_.c[i]);
      worst = worse(worst, static_cast<double>(std::fabs(excess)) / 2);
    }
    return worst;
  }

  struct Coefficient {
    int component, order;
  };

  static std::optional<Coefficient> first_not_finite(const Expansion<Real>& series) {
    const std::size_t size = series.rest.size();
    for (std::size_t i = 0; i < size * static_cast<std::size_t>(series.order + 1); ++i)
      if (!std::isfinite(series.c[i])) return Coefficient{static_cast<int>(i % size), static_cast<int>(i / size)};
    return std::nullopt;
  }

  // Whether the rates that next_ begins with are those that now_ ends with, and, where there are kinks, those within
  // the step are too: a load may leave the series and come back.
  bool is_continued() {
    if (!goes_through(next_)) return false;
    if (!has_kinks_) return true;
    const double h = next_.t - now_.t;
    return std::all_of(std::begin(inner_points), std::end(inner_points), [&](double share) {
      inner_.t = now_.t + share * h;
      inner_.order = 1;
      move(inner_, inner_.t);
      system_.count_evaluation();
      series_.coefficients(inner_.t, 1, inner_.c.data());
      return goes_through(inner_);
    });
  }

  // But for what the terms left out and rounding can do to a rate.
  bool goes_through(const Expansion<Real>& at) {
    if (const auto bad = first_not_finite(at)) {
      worst_ = bad->component;
      return false;
    }
    constexpr Real rounding = 1000 * std::numeric_limits<Real>::epsilon();
    const Real tau = static_cast<Real>(at.t) - static_cast<Real>(now_.t);
    for (std::size_t i = 0; i < row_.size(); ++i) {
      const Real difference = std::fabs(now_.rate(i, tau) - at.c[row_.size() + i]) * tau;
      const Real change = std::fabs(at.c[row_.size() + i]) * tau + largest_[i];
      if (difference <= static_cast<Real>(10 * now_.order) * allowed(i) + rounding * change) continue;
      worst_ = static_cast<int>(i);
      return false;
    }
    return true;
  }

  [[noreturn]] void fail(double t, int component, const std::string& how) const {
    throw IntegrationError("integration stopped at t = " + shortest(t) + " s: the rate of " +
                           system_.component(component) + " " + how);
  }

  System& system_;
  StepBook& book_;
  Series<Real> series_;
  Real relative_, absolute_;
  double end_, longest_;
  bool has_kinks_;
  int order_;                  // of the next series
  int worst_ = 0;              // the component that was last in the way, of the state rather than the work
  std::vector<Real> largest_;  // magnitude of each component so far
  std::vector<double> row_;
  Expansion<Real> now_, next_, inner_;
  static constexpr double inner_points[] = {0.07, 0.19, 0.31, 0.44, 0.56, 0.69, 0.81, 0.93};  // of a step
  static constexpr int lowest_order = 4;
};

}  // namespace

std::unique_ptr<Stepper> make_taylor(System& system, std::vector<double> z, const Options& options, StepBook& book) {
  if (options.method == Method::taylor) return std::make_unique<Taylor<double>>(system, z, options, book);
  return std::make_unique<Taylor<long double>>(system, z, options, book);
}

}  // namespace kanec::integrate
