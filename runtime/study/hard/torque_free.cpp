// SPDX-License-Identifier: GPL-2.0-or-later
#include <algorithm>
#include <array>
#include <optional>

#include "runtime/generic/system.hpp"
#include "runtime/study/hard/answer.hpp"
#include "runtime/study/hard/attitude.hpp"
#include "runtime/study/hard/requirements.hpp"
#include "runtime/verify/attitude_angle.hpp"

namespace kanec::hard {
namespace {

// ω by sn, cn and dn; the attitude by the angle ψ that the third axis turns about the angular momentum. Axes are
// numbered so that the third is the one that ω goes around.
class TorqueFree final : public Answer {
 public:
  explicit TorqueFree(const scene::Scene& scene) : at_(scene::Layout(scene).bodies.at(0)) {
    const generic::System<Real> system(scene, scene::default_parameters(scene));
    const Matrix I = system.body(1).I;
    if (scene::size(scene) != 1 || at_.omega < 0 || !(I - Matrix(I.diagonal().asDiagonal())).isZero(0))
      refuse_scene("torque_free", "one free or ball body with principal axes");
    moments_ = I.diagonal();
  }

  void compare(const Row& row) override {
    const Vector omega = vector(row.y, at_.omega);
    const Matrix found = attitude(row.x, at_.eps);
    if (!closed_form_) begin(omega, found);
    turn_to(row.t);
    const Vector expected = speeds(row.t);
    attitude_.add(attitude_angle(found, inertial_ * body_axes(expected).transpose()));
    speed_.add((omega - expected).norm() / size_);
  }

  std::vector<Deviation> deviations() const override { return {attitude_, speed_}; }

 private:
  Real& moment(int i) { return moments_[axis_[static_cast<std::size_t>(i)]]; }

  // 2 T I_j − |I ω|² = Σ I_i (I_j − I_i) ω_i², without cancellation.
  Real excess(int j, const Vector& omega) {
    Real sum = 0;
    for (int i = 0; i < 3; ++i) {
      const Real w = omega[axis_[static_cast<std::size_t>(i)]];
      sum += moment(i) * (moment(j) - moment(i)) * w * w;
    }
    return sum;
  }

  void begin(const Vector& omega, const Matrix& start) {
    axis_ = {0, 1, 2};
    std::sort(axis_.begin(), axis_.end(), [&](int a, int b) { return moments_[a] < moments_[b]; });
    if (excess(1, omega) > 0) std::swap(axis_[0], axis_[2]);
    const Real I1 = moment(0), I2 = moment(1), I3 = moment(2);
    const Real by_3 = excess(2, omega), by_1 = -excess(0, omega), by_2 = -excess(1, omega);
    const Real complement = (I3 - I1) * by_2 / ((I3 - I2) * by_1);
    if (!(complement > 0) || by_3 == 0)
      refuse("torque_free", "a start at rest, in a steady turn or on the separatrix",
             "one from which ω goes around an axis");
    rate_ = std::sqrt((I3 - I2) * by_1 / (I1 * I2 * I3));
    closed_form_.emplace(complement);
    const bool is_right_handed = (axis_[1] - axis_[0] + 3) % 3 == 1;
    const Real side = std::copysign(Real(1), omega[axis_[2]]);
    const Real sense = is_right_handed == (I3 > I2) ? side : -side;
    amplitude_ = {sense * std::sqrt(by_3 / (I1 * (I3 - I1))), std::sqrt(by_3 / (I2 * (I3 - I2))),
                  side * std::sqrt(by_1 / (I3 * (I3 - I1)))};
    phase_ = closed_form_->argument(omega[axis_[1]] / amplitude_[1], omega[axis_[0]] / amplitude_[0]);
    momentum_ = moments_.cwiseProduct(omega).norm();
    size_ = omega.norm();
    inertial_ = start * body_axes(omega);
  }

  Vector speeds(Real t) const {
    const Jacobi f = (*closed_form_)(rate_ * t + phase_);
    Vector omega;
    omega[axis_[0]] = amplitude_[0] * f.cn;
    omega[axis_[1]] = amplitude_[1] * f.sn;
    omega[axis_[2]] = amplitude_[2] * f.dn;
    return omega;
  }

  // Columns: the angular momentum's direction, that of the third axis across it, and their product; body axes.
  Matrix body_axes(const Vector& omega) const {
    const Vector along = moments_.cwiseProduct(omega).normalized();
    Matrix axes;
    axes.col(0) = along;
    axes.col(1) = (Vector::Unit(axis_[2]) - along[axis_[2]] * along).normalized();
    axes.col(2) = along.cross(axes.col(1));
    return axes;
  }

  // ψ̇ = |I ω| (I1 ω1² + I2 ω2²) / (I1² ω1² + I2² ω2²); inertial_ turns about its first column.
  void turn_to(Real t) {
    const auto rate = [&](Real at) {
      const Vector omega = speeds(at);
      Real above = 0, below = 0;
      for (int i = 0; i < 2; ++i) {
        const Real part = moment(i) * omega[axis_[static_cast<std::size_t>(i)]];
        above += part * part / moment(i);
        below += part * part;
      }
      return momentum_ * above / below;
    };
    const Real psi = integral(rate, t_, t, panel / rate_);
    inertial_ = Eigen::AngleAxis<Real>(psi, inertial_.col(0).normalized()) * inertial_;
    t_ = t;
  }

  static constexpr Real panel = 0.5L;  // of the argument of sn; its nearest pole is π/2 and more away

  scene::BodyLayout at_;
  Vector moments_;
  std::array<int, 3> axis_{};
  std::optional<Elliptic> closed_form_;
  std::array<Real, 3> amplitude_{};
  Real rate_ = 0, phase_ = 0, momentum_ = 0, size_ = 0, t_ = 0;
  Matrix inertial_;
  Deviation attitude_{"attitude", "rad"}, speed_{"speed", ""};
};

}  // namespace

std::unique_ptr<Answer> torque_free(const scene::Scene& scene) { return std::make_unique<TorqueFree>(scene); }

}  // namespace kanec::hard
