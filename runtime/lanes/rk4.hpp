// The classical Runge-Kutta method in lanes: one group of scenarios stepped together, compiled with the model. Not:
// which scenarios, nor what is kept of them (runtime/trajectory/batch_ensemble.hpp).
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "batch.hpp"
#include "rk4_step.hpp"

namespace kanec::lanes::batch {

// Each set of Euler parameters of z to unit norm; returns the worst | |eps| - 1 | before, or `worst` where that is
// worse.
template <class Lane, class Model>
Lane normalise(Lane* z, Lane worst) noexcept {
  for (int k = 0; k < Model::n_attitudes; ++k) {
    const Lane length = kanec::normalise(z + Model::attitudes[k].eps);
    worst = max(worst, abs(length - Lane(1)));
  }
  return worst;
}

// Model: sizes and attitudes. Rates: the function whose n_out results are the rates of z = (x, y), or (x, y, work).
template <class Lane, class Prepared, class Model, class Rates>
class Rk4 {
 public:
  static constexpr int n = Rates::n_out;

  explicit Rk4(const kanec_group* group) noexcept
      : prepared_(*static_cast<const Prepared*>(group->prepared)), u_(static_cast<const Lane*>(group->u)) {}

  // kanec_rk4: steps()
  static void steps(const kanec_group* group) noexcept {
    Rk4 method(group);
    Lane* z = static_cast<Lane*>(group->z);
    Lane worst = *static_cast<const Lane*>(group->norm_error), finite = *static_cast<const Lane*>(group->finite_until);
    double t = group->begin;
    for (std::int64_t i = 1; i <= group->steps; ++i) {
      const double part = static_cast<double>(i) / static_cast<double>(group->steps);
      const double end = i == group->steps ? group->end : group->begin + (group->end - group->begin) * part;
      method.step(z, t, end - t);
      t = end;
      worst = normalise<Lane, Model>(z, worst);
      finite = select(is_finite(z), Lane(t), finite);
    }
    *static_cast<Lane*>(group->norm_error) = worst;
    *static_cast<Lane*>(group->finite_until) = finite;
  }

 private:
  void step(Lane* z, double t, double h) noexcept {
    rk4_step(n, z, work_, t, h, [this](double at, const Lane* state, Lane* rate) noexcept {
      Rates::call(prepared_, Lane(at), state, state + Model::nx, nullptr, u_, rate);
    });
  }
  // Zero times what is not finite is no number.
  static typename Lane::Mask is_finite(const Lane* z) noexcept {
    Lane zero(0);
    for (int i = 0; i < n; ++i) zero += z[i] * Lane(0);
    return zero == Lane(0);
  }

  const Prepared& prepared_;
  const Lane* u_;
  Lane work_[n > 0 ? 3 * n : 1];
};

}  // namespace kanec::lanes::batch
