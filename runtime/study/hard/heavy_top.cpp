// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>
#include <optional>

#include "runtime/generic/system.hpp"
#include "runtime/study/hard/answer.hpp"
#include "runtime/study/hard/attitude.hpp"
#include "runtime/study/hard/requirements.hpp"
#include "runtime/verify/attitude_angle.hpp"

namespace kanec::hard {
namespace {

// The height u = cos θ of the axis between two roots of u̇² = weight (u − u1) (u − u2) (u − u3), by sn²; precession and
// spin by quadrature. The start is at a root, which divides the cubic: the others are those of a quadratic, with all
// digits where two of them meet.
class HeavyTop final : public Answer {
 public:
  explicit HeavyTop(const scene::Scene& scene) : at_(scene::Layout(scene).bodies.at(0)) {
    const generic::System<Real> system(scene, scene::default_parameters(scene));
    const generic::Body<Real>& body = system.body(1);
    const Vector g = system.gravity();
    const bool is_top = scene::size(scene) == 1 && at_.omega >= 0 && at_.s.empty() && body.I(0, 0) == body.I(1, 1) &&
                        body.r[0] == 0 && body.r[1] == 0 && body.r[2] > 0 && g[0] == 0 && g[1] == 0 && g[2] < 0;
    if (!is_top)
      refuse_scene("heavy_top",
                   "a symmetric top about its z axis, on a ball, mass centre at positive z; weight along -z");
    const Real across = body.I(0, 0) + body.m * body.r[2] * body.r[2];
    moment_along_ = body.I(2, 2) / across;
    weight_ = -2 * body.m * g[2] * body.r[2] / across;
  }

  void compare(const Row& row) override {
    const Vector omega = vector(row.y, at_.omega);
    const Matrix found = attitude(row.x, at_.eps);
    if (!closed_form_) begin(omega, found);
    turn_to(row.t);
    const Matrix expected = turned(row.t);
    attitude_.add(attitude_angle(found, expected));
    const Vector axis = found.col(2), expected_axis = expected.col(2);
    axis_.add(std::atan2(axis.cross(expected_axis).norm(), axis.dot(expected_axis)));
  }

  std::vector<Deviation> deviations() const override { return {attitude_, axis_}; }

 private:
  void begin(const Vector& omega, const Matrix& start) {
    const Vector up = start.row(2);
    spin_ = omega[2];
    if (std::fabs(up[0] * omega[1] - up[1] * omega[0]) > 1e-12L * omega.norm())
      refuse("heavy_top", "a start between two tilts", "a turning point");
    along_axis_ = moment_along_ * spin_;
    along_vertical_ = omega[0] * up[0] + omega[1] * up[1] + along_axis_ * up[2];
    const Real third = other_roots(up[2], omega);
    if (passes_vertical())
      refuse("heavy_top", "a start from which the axis becomes vertical", "one whose axis stays off it");
    closed_form_.emplace((third - high()) / (third - low()));
    rate_ = std::sqrt(weight_ * (third - low())) / 2;
    phi_ = std::atan2(start(0, 2), -start(1, 2));
    psi_ = std::atan2(start(2, 0), start(2, 1));
  }

  // weight u² + linear u + constant = 0: the nearer one is the other end of the nutation, the farther one is returned.
  Real other_roots(Real start, const Vector& omega) {
    const Real linear = -(omega[0] * omega[0] + omega[1] * omega[1] + along_axis_ * along_axis_);
    const Real constant = linear * start + (2 * along_axis_ * along_vertical_ - weight_);
    const Real third = (-linear + std::sqrt(linear * linear - 4 * weight_ * constant)) / (2 * weight_);
    start_ = start;
    other_ = constant / (weight_ * third);
    return third;
  }

  Real low() const { return std::min(start_, other_); }
  Real high() const { return std::max(start_, other_); }

  // Or comes so near to it, beside the width of the nutation, that the quadrature does not follow.
  bool passes_vertical() const {
    const Real near = 1e-4L * (high() - low());
    return !(1 - high() > near && 1 + low() > near);
  }

  // From the start's root to the other one and back.
  Real tilt(Real t) const {
    const Jacobi f = (*closed_form_)(rate_ * t + (other_ < start_ ? closed_form_->quarter_period() : 0));
    return low() + (high() - low()) * f.sn * f.sn;
  }

  Real precession(Real u) const { return (along_vertical_ - along_axis_ * u) / ((1 - u) * (1 + u)); }

  void turn_to(Real t) {
    phi_ += integral([&](Real at) { return precession(tilt(at)); }, t_, t, panel / rate_);
    psi_ += integral([&](Real at) { return spin_ - precession(tilt(at)) * tilt(at); }, t_, t, panel / rate_);
    t_ = t;
  }

  Matrix turned(Real t) const {
    const Real u = tilt(t);
    const auto about = [](Real turn, int axis) {
      return Eigen::AngleAxis<Real>(turn, Vector::Unit(axis)).toRotationMatrix();
    };
    return about(phi_, 2) * about(std::atan2(std::sqrt((1 - u) * (1 + u)), u), 0) * about(psi_, 2);
  }

  static constexpr Real panel = 0.1L;  // of the argument of sn: precession is quick where the axis is near the vertical

  scene::BodyLayout at_;
  // all beside the moment across the axis
  Real moment_along_ = 0, weight_ = 0;        // twice the weight times its lever [1/s²]
  Real start_ = 1, other_ = 1;                // the roots
  Real spin_ = 0;                             // ω along the axis [rad/s]
  Real along_axis_ = 0, along_vertical_ = 0;  // angular momenta [rad/s]
  std::optional<Elliptic> closed_form_;
  Real rate_ = 0, t_ = 0, phi_ = 0, psi_ = 0;
  Deviation attitude_{"attitude", "rad"}, axis_{"axis", "rad"};
};

}  // namespace

std::unique_ptr<Answer> heavy_top(const scene::Scene& scene) { return std::make_unique<HeavyTop>(scene); }

}  // namespace kanec::hard
