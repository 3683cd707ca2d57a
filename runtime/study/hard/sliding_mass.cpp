// The bounce, and the weight that is switched.
// SPDX-License-Identifier: GPL-2.0-or-later
#include <array>
#include <cmath>
#include <numbers>

#include "runtime/generic/system.hpp"
#include "runtime/study/hard/answer.hpp"
#include "runtime/study/hard/elliptic.hpp"
#include "runtime/study/hard/requirements.hpp"

namespace kanec::hard {
namespace {

struct Slide {
  Real s, v;
};

Slide slide(const Row& row, const scene::BodyLayout& at) {
  return {row.x[static_cast<std::size_t>(at.s.front())], row.y[static_cast<std::size_t>(at.sdot.front())]};
}

// In time k: free until the spring is met, half a swing on it, free again.
class Bounce final : public Answer {
 public:
  explicit Bounce(const scene::Scene& scene) : at_(sliding_mass("bounce", scene, 1, "one free prismatic joint")) {
    const generic::System<Real> system(scene, scene::default_parameters(scene));
    const Real stiffness = parameter("bounce", scene, "k");
    if (!(stiffness > 0)) refuse("bounce", "a spring that does not push", "k > 0");
    rate_ = std::sqrt(stiffness / system.body(1).m);
  }

  void compare(const Row& row) override {
    const Slide found = slide(row, at_);
    if (row.t == 0) begin(found);
    const Slide expected = at(row.t);
    position_.add(std::fabs(found.s - expected.s) / start_.s);
    speed_.add(std::fabs((found.v - expected.v) / start_.v));
  }

  std::vector<Deviation> deviations() const override { return {position_, speed_}; }

 private:
  void begin(const Slide& start) {
    if (!(start.s > 0 && start.v < 0)) refuse("bounce", "another start", "one above the spring, towards it");
    start_ = start;
  }

  Slide at(Real t) const {
    const Real since = t + start_.s / start_.v, half_swing = std::numbers::pi_v<Real> / rate_;
    if (since > half_swing) return {-start_.v * (since - half_swing), -start_.v};
    if (since > 0) return {start_.v / rate_ * std::sin(rate_ * since), start_.v * std::cos(rate_ * since)};
    return {start_.s + start_.v * t, start_.v};
  }

  scene::BodyLayout at_;
  Real rate_ = 0;
  Slide start_{0, 0};
  Deviation position_{"position", ""}, speed_{"speed", ""};
};

// Parabolas: from the start to `low`, from there to `high`, and on.
class Switched final : public Answer {
 public:
  explicit Switched(const scene::Scene& scene)
      : at_(sliding_mass("switched", scene, 1, "one free prismatic joint")),
        ends_{parameter("switched", scene, "low"), parameter("switched", scene, "high")} {
    const bool is_right = scene.events.size() == 2 && scene.inputs.size() == 1 &&
                          scene.events[0].settings.size() == 1 && scene.events[1].settings.size() == 1;
    if (!is_right) refuse_scene("switched", "one input, two events that set it");
    weights_[0] = scene.inputs[0].value;
    for (std::size_t i = 0; i < 2; ++i) weights_[i + 1] = scene.events[i].settings[0].value;
  }

  void compare(const Row& row) override {
    const Slide found = slide(row, at_);
    if (row.t == 0) begin(found);
    std::size_t i = 0;
    while (i < 2 && row.t >= begin_[i + 1]) ++i;
    const Real tau = row.t - begin_[i];
    const Slide& from = from_[i];
    position_.add(std::fabs(found.s - (from.s + tau * (from.v - tau * weights_[i] / 2))));
    speed_.add(std::fabs((found.v - (from.v - tau * weights_[i])) / from_[0].v));
  }

  std::vector<Deviation> deviations() const override { return {position_, speed_}; }

 private:
  void begin(const Slide& start) {
    from_[0] = start;
    bool is_reached = start.v > 0;
    for (std::size_t i = 0; i < 2; ++i) {
      const auto [s, v] = from_[i];
      const Real square = v * v - 2 * weights_[i] * (ends_[i] - s);
      is_reached = is_reached && ends_[i] > s && square > 0;
      from_[i + 1] = {ends_[i], std::sqrt(square)};
      begin_[i + 1] = begin_[i] + 2 * (ends_[i] - s) / (v + from_[i + 1].v);
    }
    if (!is_reached) refuse("switched", "another start", "one upwards, fast enough, below `low`, that below `high`");
  }

  scene::BodyLayout at_;
  std::array<Real, 2> ends_;                 // of the first two parabolas
  std::array<Real, 3> weights_{}, begin_{};  // of each: weight a mass, when it begins
  std::array<Slide, 3> from_{};              // and where
  Deviation position_{"position", "m"}, speed_{"speed", ""};
};

}  // namespace

std::unique_ptr<Answer> bounce(const scene::Scene& scene) { return std::make_unique<Bounce>(scene); }
std::unique_ptr<Answer> switched(const scene::Scene& scene) { return std::make_unique<Switched>(scene); }

}  // namespace kanec::hard
