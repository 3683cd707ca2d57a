// A mass on a spring under a constant input, with events: written by hand, its motion known in closed form.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>

#include "runtime/abi/abi.h"
#include "tests/integrate/closed_form.hpp"

namespace kanec::integrate::test {

// x = (s_1), y = (sdot_1), input u: s̈ = u - 4 s. Events: s, sdot, t - 0.5.
const kanec_model& oscillator();

// From this state on.
inline State oscillation(const State& from, double u, double t) {
  const double rest = u / 4, s = from.x[0] - rest, half = from.y[0] / 2;
  return {{rest + s * std::cos(2 * t) + half * std::sin(2 * t)},
          {2 * half * std::cos(2 * t) - 2 * s * std::sin(2 * t)}};
}

}  // namespace kanec::integrate::test
