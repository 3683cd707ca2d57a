// How far two motions of a scene are apart: places, attitudes and velocities of its bodies, by the generic path in long
// double, so that the comparison adds no rounding of its own. Not: how they were integrated (trials.hpp).
// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <span>
#include <vector>

#include "runtime/generic/system.hpp"

namespace kanec {

// One body at one time.
struct BodyMotion {
  generic::Matrix3<long double> R_T;    // body to inertial components
  generic::Vector3<long double> P;      // origin, inertial axes [m]
  generic::Vector3<long double> p;      // mass centre, inertial axes [m]
  generic::Vector3<long double> v;      // its velocity, inertial axes [m/s]
  generic::Vector3<long double> omega;  // angular velocity, body axes [rad/s]
};
using Bodies = std::vector<BodyMotion>;  // of body K: [K - 1]

Bodies bodies_at(const generic::System<long double>& system, double t, std::span<const double> x,
                 std::span<const double> y);

// Each the largest over the bodies.
struct MotionError {
  double position = 0.0;  // of mass centres [m]
  double attitude = 0.0;  // angle of the error rotation [rad]
  double speed = 0.0;     // of mass centres [m/s]
  double spin = 0.0;      // of angular velocities [rad/s]
};

MotionError difference(const Bodies& a, const Bodies& b);

// The larger of each; what is NaN stays.
MotionError worse(const MotionError& a, const MotionError& b);

// What errors of one motion are measured by.
struct MotionScales {
  double length = 0.0;  // largest distance of a mass centre from where body 1's origin was at the start [m]
  double rate = 0.0;    // largest of |ω| and of |v| over the length [1/s]
};

// Of all rows of a motion.
MotionScales scales_of(const std::vector<Bodies>& rows);

// One number without unit: the largest of position / length, attitude, speed / (length rate), spin / rate.
double relative(const MotionError& error, const MotionScales& scales);

}  // namespace kanec
