// Kovalevskaya's invariant, the ellipse, the bounce, the weight that is switched.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <complex>

#include "runtime/base/error.hpp"
#include "runtime/cli/hard/answer.hpp"
#include "runtime/cli/hard/attitude.hpp"
#include "runtime/generic/system.hpp"

namespace kanec::cli::hard {
namespace {

[[noreturn]] void refuse(const std::string& name, const std::string& allowed) {
  throw InputError(name + ": found another scene; allowed: " + allowed);
}

Real parameter(const std::string& answer, const scene::Scene& scene, const std::string& name) {
  for (const scene::Named& parameter : scene.parameters)
    if (parameter.name == name) return parameter.value;
  refuse(answer, "one with a parameter " + name);
}

// |(ω1 + i ω2)² − ν (γ1 + i γ2)|² stays, γ the vertical in body axes, ν = m g a / I3.
class Kovalevskaya final : public Answer {
 public:
  explicit Kovalevskaya(const scene::Scene& scene) : at_(scene::Layout(scene).bodies.at(0)) {
    const generic::System<Real> system(scene, scene::default_parameters(scene));
    const generic::Body<Real>& body = system.body(1);
    const Vector g = system.gravity();
    const Matrix about_point =
        body.I + body.m * (body.r.squaredNorm() * Matrix::Identity() - body.r * body.r.transpose());
    const Vector ratios = about_point.diagonal() / about_point(2, 2);
    if (at_.omega < 0 || (ratios - Vector(2, 2, 1)).norm() > 1e-14L || body.r[1] != 0 || body.r[2] != 0 || g[0] != 0 ||
        g[1] != 0)
      refuse("kovalevskaya", "a ball joint, moments 2 : 2 : 1 about it, mass centre on axis 1");
    nu_ = -body.m * g[2] * body.r[0] / about_point(2, 2);
  }

  void compare(const integrate::Row& row) override {
    const Vector omega = vector(row.y, at_.omega), up = attitude(row.x, at_.eps).row(2);
    const std::complex<Real> speed(omega[0], omega[1]), vertical(up[0], up[1]);
    const Real value = std::norm(speed * speed - nu_ * vertical);
    if (row.t == 0) start_ = value;
    change_ = std::max(change_, std::fabs(value - start_) / start_);
  }

  std::vector<Error> errors() const override { return {{"invariant", "", static_cast<double>(change_)}}; }

 private:
  scene::BodyLayout at_;
  Real nu_ = 0, start_ = 0, change_ = 0;
};

// Kepler's equation by Newton's method; axes P to the nearest point, Q along the speed there.
class Kepler final : public Answer {
 public:
  explicit Kepler(const scene::Scene& scene) : at_(scene::Layout(scene).bodies.at(0)) {
    if (scene::size(scene) != 1 || at_.s.size() != 3) refuse("kepler", "one mass with three translations");
    mu_ = parameter("kepler", scene, "mu");
  }

  void compare(const integrate::Row& row) override {
    const Vector r = vector(row.x, at_.s.front()), v = vector(row.y, at_.sdot.front());
    if (row.t == 0) begin(r, v);
    const Real M = M0_ + n_ * row.t;
    Real E = M + e_ * std::copysign(Real(0.85), std::sin(M));  // Danby's start
    for (int i = 0; i < 100; ++i) {
      const Real step = (E - e_ * std::sin(E) - M) / (1 - e_ * std::cos(E));
      E -= step;
      if (std::fabs(step) < 1e-19L * std::max(Real(1), std::fabs(E))) break;
    }
    const Real rate = n_ / (1 - e_ * std::cos(E));
    const Vector expected = a_ * ((std::cos(E) - e_) * P_ + b_ * std::sin(E) * Q_);
    const Vector speed = a_ * rate * (-std::sin(E) * P_ + b_ * std::cos(E) * Q_);
    position_ = std::max(position_, (r - expected).norm() / a_);
    speed_ = std::max(speed_, (v - speed).norm() / speed.norm());
  }

  std::vector<Error> errors() const override {
    return {{"position", "", static_cast<double>(position_)}, {"speed", "", static_cast<double>(speed_)}};
  }

 private:
  void begin(const Vector& r, const Vector& v) {
    const Real distance = r.norm();
    a_ = 1 / (2 / distance - v.squaredNorm() / mu_);
    n_ = std::sqrt(mu_ / (a_ * a_ * a_));
    const Vector momentum = r.cross(v), eccentric = v.cross(momentum) / mu_ - r / distance;
    e_ = eccentric.norm();
    b_ = momentum.norm() / std::sqrt(mu_ * a_);
    P_ = eccentric / e_;
    Q_ = momentum.cross(eccentric).normalized();
    const Real E = std::atan2(r.dot(v) / std::sqrt(mu_ * a_), 1 - distance / a_);
    M0_ = E - e_ * std::sin(E);
  }

  scene::BodyLayout at_;
  Real mu_ = 0, a_ = 0, b_ = 0, e_ = 0, n_ = 0, M0_ = 0;  // b: minor axis beside major
  Vector P_, Q_;
  Real position_ = 0, speed_ = 0;
};

// In time k: free until the spring is met, half a swing on it, free again.
class Bounce final : public Answer {
 public:
  explicit Bounce(const scene::Scene& scene) : at_(scene::Layout(scene).bodies.at(0)) {
    if (scene::size(scene) != 1 || at_.s.size() != 1 || at_.s.front() < 0) refuse("bounce", "one prismatic joint");
    const generic::System<Real> system(scene, scene::default_parameters(scene));
    rate_ = std::sqrt(parameter("bounce", scene, "k") / system.body(1).m);
  }

  void compare(const integrate::Row& row) override {
    const Real s = row.x[static_cast<std::size_t>(at_.s.front())];
    const Real v = row.y[static_cast<std::size_t>(at_.sdot.front())];
    if (row.t == 0) begin(s, v);
    const Real since = row.t - meets_, half_swing = std::acos(Real(-1)) / rate_;
    Real expected = s0_ + v0_ * row.t, speed = v0_;
    if (since > half_swing) {
      expected = -v0_ * (since - half_swing);
      speed = -v0_;
    } else if (since > 0) {
      expected = v0_ / rate_ * std::sin(rate_ * since);
      speed = v0_ * std::cos(rate_ * since);
    }
    position_ = std::max(position_, std::fabs(s - expected) / s0_);
    speed_ = std::max(speed_, std::fabs((v - speed) / v0_));
  }

  std::vector<Error> errors() const override {
    return {{"position", "", static_cast<double>(position_)}, {"speed", "", static_cast<double>(speed_)}};
  }

 private:
  void begin(Real s, Real v) {
    if (s <= 0 || v >= 0) refuse("bounce", "a start above the spring, towards it");
    s0_ = s;
    v0_ = v;
    meets_ = -s / v;
  }

  scene::BodyLayout at_;
  Real rate_ = 0, s0_ = 0, v0_ = 0, meets_ = 0, position_ = 0, speed_ = 0;
};

// Parabolas: from the start to `low`, from there to `high`, and on.
class Switched final : public Answer {
 public:
  explicit Switched(const scene::Scene& scene) : at_(scene::Layout(scene).bodies.at(0)) {
    const bool is_right = scene::size(scene) == 1 && at_.s.size() == 1 && scene.events.size() == 2 &&
                          scene.inputs.size() == 1 && scene.events[0].settings.size() == 1 &&
                          scene.events[1].settings.size() == 1;
    if (!is_right) refuse("switched", "one prismatic joint, one input, two events that set it");
    ends_[0] = parameter("switched", scene, "low");
    ends_[1] = parameter("switched", scene, "high");
    g_[0] = scene.inputs[0].value;
    for (std::size_t i = 0; i < 2; ++i) g_[i + 1] = scene.events[i].settings[0].value;
  }

  void compare(const integrate::Row& row) override {
    const Real s = row.x[static_cast<std::size_t>(at_.s.front())];
    const Real v = row.y[static_cast<std::size_t>(at_.sdot.front())];
    if (row.t == 0) begin(s, v);
    std::size_t i = 0;
    while (i < 2 && row.t >= begin_[i + 1]) ++i;
    const Real tau = row.t - begin_[i];
    position_ = std::max(position_, std::fabs(s - (s_[i] + tau * (v_[i] - tau * g_[i] / 2))));
    speed_ = std::max(speed_, std::fabs((v - (v_[i] - tau * g_[i])) / v_[0]));
  }

  std::vector<Error> errors() const override {
    return {{"position", "m", static_cast<double>(position_)}, {"speed", "", static_cast<double>(speed_)}};
  }

 private:
  void begin(Real s, Real v) {
    s_[0] = s;
    v_[0] = v;
    for (std::size_t i = 0; i < 2; ++i) {
      const Real square = v_[i] * v_[i] - 2 * g_[i] * (ends_[i] - s_[i]);
      if (square <= 0) refuse("switched", "a start from which both events are reached upwards");
      s_[i + 1] = ends_[i];
      v_[i + 1] = std::sqrt(square);
      begin_[i + 1] = begin_[i] + 2 * (ends_[i] - s_[i]) / (v_[i] + v_[i + 1]);
    }
  }

  scene::BodyLayout at_;
  std::array<Real, 2> ends_{};                     // of the first two parabolas
  std::array<Real, 3> g_{}, begin_{}, s_{}, v_{};  // of each: weight a mass, and where it begins
  Real position_ = 0, speed_ = 0;
};

}  // namespace

std::unique_ptr<Answer> kovalevskaya(const scene::Scene& scene) { return std::make_unique<Kovalevskaya>(scene); }
std::unique_ptr<Answer> kepler(const scene::Scene& scene) { return std::make_unique<Kepler>(scene); }
std::unique_ptr<Answer> bounce(const scene::Scene& scene) { return std::make_unique<Bounce>(scene); }
std::unique_ptr<Answer> switched(const scene::Scene& scene) { return std::make_unique<Switched>(scene); }

}  // namespace kanec::cli::hard
