// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <cmath>

#include "runtime/study/hard/answer.hpp"
#include "runtime/study/hard/attitude.hpp"
#include "runtime/study/hard/requirements.hpp"

namespace kanec::hard {
namespace {

// The eccentric anomaly of a mean one by Newton's method.
Real eccentric_anomaly(Real mean, Real eccentricity) {
  Real eccentric = mean + eccentricity * std::copysign(Real(0.85), std::sin(mean));  // Danby's start
  for (int i = 0; i < 100; ++i) {
    const Real step =
        (eccentric - eccentricity * std::sin(eccentric) - mean) / (1 - eccentricity * std::cos(eccentric));
    eccentric -= step;
    if (std::fabs(step) < 1e-19L * std::max(Real(1), std::fabs(eccentric))) break;
  }
  return eccentric;
}

// An ellipse about its focus, in axes to the periapsis and along the speed there.
class Kepler final : public Answer {
 public:
  explicit Kepler(const scene::Scene& scene)
      : at_(sliding_mass("kepler", scene, 3, "one mass with three free translations")),
        mu_(parameter("kepler", scene, "mu")) {}

  void compare(const Row& row) override {
    const Vector r = vector(row.x, at_.s.front()), v = vector(row.y, at_.sdot.front());
    if (row.t == 0) begin(r, v);
    const Real eccentric = eccentric_anomaly(mean_at_start_ + mean_motion_ * row.t, eccentricity_);
    const Real sine = std::sin(eccentric), cosine = std::cos(eccentric);
    const Real rate = mean_motion_ / (1 - eccentricity_ * cosine);
    const Vector expected = major_ * ((cosine - eccentricity_) * to_periapsis_ + minor_ * sine * across_);
    const Vector speed = major_ * rate * (-sine * to_periapsis_ + minor_ * cosine * across_);
    position_.add((r - expected).norm() / major_);
    speed_.add((v - speed).norm() / speed.norm());
  }

  std::vector<Deviation> deviations() const override { return {position_, speed_}; }

 private:
  // The anomaly is measured from the axis as it is rounded, which in a near circle may be any; in a circle it is the
  // one to the start.
  void begin(const Vector& r, const Vector& v) {
    const Real distance = r.norm();
    const Vector momentum = r.cross(v), eccentricity = v.cross(momentum) / mu_ - r / distance;
    major_ = 1 / (2 / distance - v.squaredNorm() / mu_);
    eccentricity_ = eccentricity.norm();
    const bool is_ellipse = mu_ > 0 && major_ > 0 && eccentricity_ < 1 && momentum.norm() > 0;
    if (!is_ellipse) refuse("kepler", "a start without an ellipse", "one that is bound and does not go to the centre");
    mean_motion_ = std::sqrt(mu_ / major_) / major_;
    minor_ = momentum.norm() / std::sqrt(mu_ * major_);
    across_ = momentum.cross(eccentricity_ > 0 ? eccentricity : r).normalized();
    to_periapsis_ = across_.cross(momentum).normalized();
    const Real eccentric =
        std::atan2(r.dot(across_) / (major_ * minor_), r.dot(to_periapsis_) / major_ + eccentricity_);
    mean_at_start_ = eccentric - eccentricity_ * std::sin(eccentric);
  }

  scene::BodyLayout at_;
  Real mu_, major_ = 0, minor_ = 0;  // half the major axis [m]; the minor one beside it
  Real eccentricity_ = 0, mean_motion_ = 0, mean_at_start_ = 0;
  Vector to_periapsis_, across_;
  Deviation position_{"position", ""}, speed_{"speed", ""};
};

}  // namespace

std::unique_ptr<Answer> kepler(const scene::Scene& scene) { return std::make_unique<Kepler>(scene); }

}  // namespace kanec::hard
