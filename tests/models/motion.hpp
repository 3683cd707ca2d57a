// A model's motion by its own program: kinematics and accelerations, Runge and Kutta's classical method. Not: the
// integrators that kanec ships.
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "tests/models/model.hpp"

namespace kanec::test {

// The state after `duration` [s] in so many equal steps.
program::Arguments<double> after(const Model& model, program::Arguments<double> at, double duration, int steps);

}  // namespace kanec::test
