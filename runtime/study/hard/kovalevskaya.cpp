// SPDX-License-Identifier: GPL-2.0-or-later
#include <cmath>
#include <complex>

#include "runtime/generic/system.hpp"
#include "runtime/study/hard/answer.hpp"
#include "runtime/study/hard/attitude.hpp"
#include "runtime/study/hard/requirements.hpp"

namespace kanec::hard {
namespace {

// |(ω1 + i ω2)² − ν (γ1 + i γ2)|² stays, γ the vertical in body axes, ν = m g a / I3.
class Kovalevskaya final : public Answer {
 public:
  explicit Kovalevskaya(const scene::Scene& scene) : at_(scene::Layout(scene).bodies.at(0)) {
    const generic::System<Real> system(scene, scene::default_parameters(scene));
    const generic::Body<Real>& body = system.body(1);
    const Vector g = system.gravity();
    const Matrix about_point =
        body.I + body.m * (body.r.squaredNorm() * Matrix::Identity() - body.r * body.r.transpose());
    const Matrix ratios = about_point / about_point(2, 2), wanted = Vector(2, 2, 1).asDiagonal();
    const bool is_top = scene::size(scene) == 1 && at_.omega >= 0 && at_.s.empty() &&
                        (ratios - wanted).norm() <= 1e-14L && body.r[1] == 0 && body.r[2] == 0 && g[0] == 0 &&
                        g[1] == 0;
    if (!is_top) refuse_scene("kovalevskaya", "a ball joint, moments 2 : 2 : 1 about it, mass centre on axis 1");
    nu_ = -body.m * g[2] * body.r[0] / about_point(2, 2);
  }

  void compare(const Row& row) override {
    const Vector omega = vector(row.y, at_.omega), up = attitude(row.x, at_.eps).row(2);
    const std::complex<Real> speed(omega[0], omega[1]), vertical(up[0], up[1]);
    const Real value = std::norm(speed * speed - nu_ * vertical);
    if (row.t == 0) start_ = value;
    if (start_ == 0) refuse("kovalevskaya", "a start with an invariant of 0", "another: changes are relative to it");
    change_.add(std::fabs(value - start_) / start_);
  }

  std::vector<Deviation> deviations() const override { return {change_}; }

 private:
  scene::BodyLayout at_;
  Real nu_ = 0, start_ = 0;
  Deviation change_{"invariant", ""};
};

}  // namespace

std::unique_ptr<Answer> kovalevskaya(const scene::Scene& scene) { return std::make_unique<Kovalevskaya>(scene); }

}  // namespace kanec::hard
