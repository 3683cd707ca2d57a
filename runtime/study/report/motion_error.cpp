// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/report/motion_error.hpp"

#include <algorithm>
#include <cmath>

#include "runtime/generic/motion.hpp"
#include "runtime/integrate/norm.hpp"
#include "runtime/verify/attitude_angle.hpp"

namespace kanec {
namespace {

double largest(double a, long double b) { return integrate::worse(a, static_cast<double>(b)); }

// Nothing moves there, or what moves is rounding.
double ratio(double value, double scale) { return value == 0.0 || scale == 0.0 ? 0.0 : value / scale; }

}  // namespace

Bodies bodies_at(const generic::System<long double>& system, double t, std::span<const double> x,
                 std::span<const double> y) {
  const std::vector<long double> wide_x(x.begin(), x.end()), wide_y(y.begin(), y.end());
  generic::Arguments<long double> at;
  at.t = t;
  at.x = wide_x;
  at.y = wide_y;
  const generic::Motion<long double> motion(system, at);
  Bodies bodies;
  for (int k = 1; k <= system.n_bodies(); ++k)
    bodies.push_back({motion[k].R_T, motion[k].P, motion.point(k, system.body(k).r),
                      motion.velocity(motion.mass_centre(k)), motion[k].omega});
  return bodies;
}

MotionError difference(const Bodies& a, const Bodies& b) {
  MotionError error;
  for (std::size_t k = 0; k < a.size(); ++k) {
    error.position = largest(error.position, (a[k].p - b[k].p).norm());
    error.attitude = largest(error.attitude, attitude_angle(b[k].R_T, a[k].R_T));
    error.speed = largest(error.speed, (a[k].v - b[k].v).norm());
    error.spin = largest(error.spin, (a[k].omega - b[k].omega).norm());
  }
  return error;
}

MotionError worse(const MotionError& a, const MotionError& b) {
  using integrate::worse;
  return {worse(a.position, b.position), worse(a.attitude, b.attitude), worse(a.speed, b.speed), worse(a.spin, b.spin)};
}

MotionScales scales_of(const std::vector<Bodies>& rows) {
  double length = 0.0, speed = 0.0, spin = 0.0;
  for (const Bodies& bodies : rows)
    for (const BodyMotion& body : bodies) {
      length = largest(length, (body.p - rows.front().front().P).norm());
      speed = largest(speed, body.v.norm());
      spin = largest(spin, body.omega.norm());
    }
  return {length, std::max(spin, ratio(speed, length))};
}

double relative(const MotionError& error, const MotionScales& scales) {
  double worst = ratio(error.position, scales.length);
  worst = integrate::worse(worst, error.attitude);
  worst = integrate::worse(worst, ratio(error.speed, scales.length * scales.rate));
  return integrate::worse(worst, ratio(error.spin, scales.rate));
}

}  // namespace kanec
