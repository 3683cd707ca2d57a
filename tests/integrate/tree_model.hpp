// Model descriptors written by hand for the tests: trees of free bodies whose mass centres are their origins, where
// Newton and Euler give every acceleration without a mass matrix. Shares nothing with the generator.
// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <vector>

#include "runtime/abi/abi.h"

namespace kanec::integrate::test {

enum class Fault {
  none,
  not_finite,  // the rate of omega_3_2 (of omega_1_2 where there is one body) is NaN from t = 0.5 s on
  blow_up,     // d(sdot_1_1)/dt = sdot_1_1², infinite at t = 1 / sdot_1_1(0)
  stiff,       // body 1 is slowed down by 1e5 times its own velocity
};

// Parameters: gravity (3). Inputs: applied force (inertial axes) and moment (body axes) of every body (6N), body by
// body. One axisymmetric body, m = 2, I = diag(3, 3, 1.5).
const kanec_model& single_body(Fault fault = Fault::none);
// Six bodies with the connection array 0,1,2,2,1,5; principal inertias all different.
const kanec_model& six_bodies(Fault fault = Fault::none);
// The single body without power, energy and momentum.
const kanec_model& bare_body();
// A descriptor without accelerations.
const kanec_model& body_without_accelerations();

// A state of the six bodies in which everything turns and moves.
std::vector<double> six_body_coordinates();
std::vector<double> six_body_speeds();

}  // namespace kanec::integrate::test
