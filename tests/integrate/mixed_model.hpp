// A model written by hand whose joints differ: an angle under a torque of time, a ball left alone, a slide on a spring.
// Its motion is known in closed form. Shares nothing with the generator.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "runtime/abi/abi.h"
#include "tests/integrate/closed_form.hpp"

namespace kanec::integrate::test {

// Which of its functions are combined into one.
enum class Calls { separate, two_in_one, three_in_one };

// x = (theta_1, eps_2 (4), s_3), y = (thetadot_1, omega_2 (3), sdot_3); no parameters, no inputs.
//   θ̈ = cos t (moment of inertia 1); ω as that of precession(); s̈ = -4 s (mass 1, a spring whose energy is potential)
const kanec_model& mixed_model(Calls calls);
State mixed_motion(double t);
double mixed_work(double t);  // of the torque since t = 0 [J]

// No coordinates at all.
const kanec_model& motionless_model();

}  // namespace kanec::integrate::test
