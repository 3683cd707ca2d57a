// SPDX-License-Identifier: GPL-2.0-or-later
#include <optional>

#include "runtime/base/error.hpp"
#include "runtime/cli/hard/answer.hpp"
#include "runtime/cli/hard/attitude.hpp"
#include "runtime/generic/system.hpp"

namespace kanec::cli::hard {
namespace {

// u = cos θ between two roots of u̇² = β (u − u1) (u − u2) (u − u3), by sn²; precession and spin by quadrature. The
// start is at a root, which divides the cubic: the others are those of a quadratic, with all digits where two of them
// meet.
class HeavyTop final : public Answer {
 public:
  explicit HeavyTop(const scene::Scene& scene) : at_(scene::Layout(scene).bodies.at(0)) {
    const generic::System<Real> system(scene, scene::default_parameters(scene));
    const generic::Body<Real>& body = system.body(1);
    const Vector g = system.gravity();
    const bool is_top = scene::size(scene) == 1 && at_.omega >= 0 && at_.s.empty() && body.I(0, 0) == body.I(1, 1) &&
                        body.r[0] == 0 && body.r[1] == 0 && g[0] == 0 && g[1] == 0 && g[2] < 0;
    if (!is_top)
      throw InputError("heavy_top: found another scene; allowed: a symmetric top about its z axis, on a ball");
    A_ = body.I(0, 0) + body.m * body.r[2] * body.r[2];
    C_ = body.I(2, 2);
    mgl_ = -body.m * g[2] * body.r[2];
  }

  void compare(const integrate::Row& row) override {
    const Vector omega = vector(row.y, at_.omega);
    const Matrix found = attitude(row.x, at_.eps);
    if (!closed_form_) begin(omega, found);
    turn_to(row.t);
    const Matrix expected = turned(row.t);
    attitude_ = std::max(attitude_, angle(found, expected));
    axis_ = std::max(axis_, 2 * std::asin((found.col(2) - expected.col(2)).norm() / 2));
  }

  std::vector<Error> errors() const override {
    return {{"attitude", "rad", static_cast<double>(attitude_)}, {"axis", "rad", static_cast<double>(axis_)}};
  }

 private:
  void begin(const Vector& omega, const Matrix& start) {
    const Vector up = start.row(2);
    u0_ = up[2];
    omega3_ = omega[2];
    if (std::fabs(up[0] * omega[1] - up[1] * omega[0]) > 1e-12L * omega.norm())
      throw InputError("heavy_top: found a start between two tilts; allowed: a turning point");
    a_ = C_ * omega3_ / A_;
    b_ = omega[0] * up[0] + omega[1] * up[1] + a_ * up[2];
    const Real alpha = omega[0] * omega[0] + omega[1] * omega[1] + 2 * mgl_ / A_ * u0_, beta = 2 * mgl_ / A_;
    const Real p = beta * u0_ - (alpha + a_ * a_), q = p * u0_ + (2 * a_ * b_ - beta);
    const Real far = (-p + std::sqrt(p * p - 4 * beta * q)) / (2 * beta);  // p < 0
    other_ = q / (beta * far);
    closed_form_.emplace((far - std::max(u0_, other_)) / (far - std::min(u0_, other_)));
    rate_ = std::sqrt(beta * (far - std::min(u0_, other_))) / 2;
    phi_ = std::atan2(start(0, 2), -start(1, 2));
    psi_ = std::atan2(start(2, 0), start(2, 1));
  }

  // From the start's root to the other one and back.
  Real tilt(Real t) const {
    const Jacobi f = (*closed_form_)(rate_ * t + (other_ < u0_ ? closed_form_->quarter_period() : 0));
    const Real low = std::min(u0_, other_), high = std::max(u0_, other_);
    return low + (high - low) * f.sn * f.sn;
  }

  Real precession(Real u) const { return (b_ - a_ * u) / ((1 - u) * (1 + u)); }

  void turn_to(Real t) {
    phi_ += integral([&](Real at) { return precession(tilt(at)); }, t_, t, panel / rate_);
    psi_ += integral([&](Real at) { return omega3_ - precession(tilt(at)) * tilt(at); }, t_, t, panel / rate_);
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
  Real A_ = 0, C_ = 0, mgl_ = 0;  // moments about the point and the axis; weight times its lever
  Real u0_ = 1, other_ = 1, omega3_ = 0, a_ = 0, b_ = 0;
  std::optional<Elliptic> closed_form_;
  Real rate_ = 0, t_ = 0, phi_ = 0, psi_ = 0;
  Real attitude_ = 0, axis_ = 0;
};

}  // namespace

std::unique_ptr<Answer> heavy_top(const scene::Scene& scene) { return std::make_unique<HeavyTop>(scene); }

}  // namespace kanec::cli::hard
