// What the states of a hard case ought to be, by a closed form or a run in higher precision. Not: how they were found,
// nor what the scene keeps whatever it does (energy, momentum, norm: runtime/trajectory/balance.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "generator/scene/scene.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/trajectory/simulate.hpp"

namespace kanec::hard {

// How far off a run was at worst.
struct Deviation {
  std::string what;  // "attitude"
  std::string unit;  // "rad"; empty where it is relative
  double value = 0.0;

  // Of one more row; NaN stays.
  void add(long double one) { value = integrate::worse(value, static_cast<double>(one)); }
  // The same relative to the largest value that the answer has; of nothing moving that does not, none.
  Deviation beside(long double size) const {
    return {what, unit, value == 0.0 ? 0.0 : value / static_cast<double>(size)};
  }
};

class Answer {
 public:
  virtual ~Answer() = default;

  // Rows in order of time, the first at t = 0. Throws InputError for a start that the closed form has no answer from.
  virtual void compare(const Row& row) = 0;
  virtual std::vector<Deviation> deviations() const = 0;
};

// The numbers of a closed form are read off the scene. Throws InputError for a scene that it is not the answer to, and
// for an unknown name.
std::unique_ptr<Answer> answer(const std::string& name, const scene::Scene& scene);

// "torque_free": one free or ball body with principal axes, no loads (Landau and Lifshitz, Mechanics, §37), in no
// steady turn and not on the separatrix.
std::unique_ptr<Answer> torque_free(const scene::Scene& scene);
// "heavy_top": a symmetric top on a ball joint, mass centre along its positive axis, started at a turning point of its
// nutation (Goldstein, §5.7), whose axis stays off the vertical.
std::unique_ptr<Answer> heavy_top(const scene::Scene& scene);
// "kovalevskaya": the invariant of a top with I1 = I2 = 2 I3 about its fixed point, mass centre on axis 1.
std::unique_ptr<Answer> kovalevskaya(const scene::Scene& scene);
// "uniform_chain": equal masses on a line, each with the same spring and damper to the one before, the first to the
// ground; modes sin((2 j − 1) π i / (2 N + 1)).
std::unique_ptr<Answer> uniform_chain(const scene::Scene& scene);
// "kepler": one point mass, parameter `mu`, attracted by mu / r² a mass, on an ellipse.
std::unique_ptr<Answer> kepler(const scene::Scene& scene);
// "bounce": one sliding mass that meets a spring of parameter `k` where its coordinate is negative, and leaves it.
std::unique_ptr<Answer> bounce(const scene::Scene& scene);
// "switched": one sliding mass whose weight a mass, the one input, two events set, at parameters `low` and `high`.
std::unique_ptr<Answer> switched(const scene::Scene& scene);
// "reference": the generic path in long double, extrapolated to 1e-15 a step; "precise": the program in 50 digits to
// 1e-26 a step.
std::unique_ptr<Answer> reference_answer(const scene::Scene& scene);
std::unique_ptr<Answer> precise_answer(const scene::Scene& scene);

}  // namespace kanec::hard
