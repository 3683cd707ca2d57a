// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/choice/candidates.hpp"
#include "generator/program/evaluate.hpp"
#include "runtime/generic/evaluate.hpp"
#include "runtime/study/hard/answer.hpp"
#include "runtime/study/hard/attitude.hpp"
#include "runtime/study/hard/extrapolation.hpp"
#include "runtime/verify/attitude_angle.hpp"
#include "runtime/verify/precise.hpp"

namespace kanec::hard {
namespace {

double nearest(long double value) { return static_cast<double>(value); }
double nearest(const Precise& value) { return value.rounded(); }
double distance(const Precise& a, double b) { return (a - Precise(b)).magnitude().rounded(); }
double distance(long double a, double b) { return static_cast<double>(std::fabs(a - static_cast<long double>(b))); }

// Rows beside a run in T: the worst angle of a ball or a turn, the worst translation, the worst speed beside the
// largest that the run has.
template <class T>
class ReferenceAnswer final : public Answer {
 public:
  using Run = Extrapolation<T>;

  ReferenceAnswer(const scene::Scene& scene, typename Run::Rates rates, const typename Run::Accuracy& accuracy)
      : layout_(scene), run_(std::move(rates), start(scene), accuracy) {}

  void compare(const Row& row) override {
    const std::vector<T>& z = run_.advance(row.t);
    const auto nx = static_cast<std::size_t>(layout_.nx);
    std::vector<double> x;
    for (std::size_t i = 0; i < nx; ++i) x.push_back(nearest(z[i]));
    const auto add = [&](const std::vector<int>& places, Deviation& deviation) {
      for (const int i : places)
        if (i >= 0) deviation.add(distance(z[static_cast<std::size_t>(i)], row.x[static_cast<std::size_t>(i)]));
    };
    for (const scene::BodyLayout& body : layout_.bodies) {
      add(body.theta, angle_);
      add(body.s, position_);
      if (body.eps >= 0) angle_.add(attitude_angle(attitude(x, body.eps), attitude(row.x, body.eps)));
    }
    for (std::size_t i = 0; i < row.y.size(); ++i) {
      speed_.add(distance(z[nx + i], row.y[i]));
      size_ = std::max(size_, std::fabs(nearest(z[nx + i])));
    }
  }

  std::vector<Deviation> deviations() const override { return {angle_, position_, speed_.beside(size_)}; }

 private:
  static std::vector<T> start(const scene::Scene& scene) {
    const std::vector<double> x = scene::initial_coordinates(scene), y = scene::initial_speeds(scene);
    std::vector<T> z(x.begin(), x.end());
    for (const double speed : y) z.push_back(T(speed));
    return z;
  }

  scene::Layout layout_;
  Run run_;
  Deviation angle_{"attitude", "rad"}, position_{"position", "m"}, speed_{"speed", ""};
  double size_ = 0.0;
};

}  // namespace

std::unique_ptr<Answer> reference_answer(const scene::Scene& scene) {
  const auto system = std::make_shared<generic::System<Real>>(scene, scene::default_parameters(scene));
  const std::vector<double> inputs = scene::default_inputs(scene);
  const std::vector<Real> u(inputs.begin(), inputs.end());
  const auto nx = static_cast<std::size_t>(scene::n_coordinates(scene));
  const auto rates = [=](Real t, const std::vector<Real>& z) {
    const std::span<const Real> all(z);
    const generic::Arguments<Real> at{t, all.first(nx), all.subspan(nx), {}, u};
    std::vector<Real> rate = generic::evaluate<Real>(*system, "kinematics", at);
    const std::vector<Real> ydot = generic::evaluate<Real>(*system, "accelerations", at);
    rate.insert(rate.end(), ydot.begin(), ydot.end());
    return rate;
  };
  return std::make_unique<ReferenceAnswer<Real>>(scene, rates, Extrapolation<Real>::Accuracy{8, 1e-15, 19});
}

std::unique_ptr<Answer> precise_answer(const scene::Scene& scene) {
  const auto program = std::make_shared<program::Program>(cheapest_program(scene, {"kinematics+accelerations"}));
  const auto precise = [](const std::vector<double>& values) {
    return std::vector<Precise>(values.begin(), values.end());
  };
  program::Arguments<Precise> at{precise(scene::default_parameters(scene)), {},          {}, {},
                                 precise(scene::default_inputs(scene)),     Precise(0.0)};
  const auto nx = static_cast<std::ptrdiff_t>(scene::n_coordinates(scene));
  const auto rates = [=](const Precise& t, const std::vector<Precise>& z) mutable {
    at.time = t;
    at.x.assign(z.begin(), z.begin() + nx);
    at.y.assign(z.begin() + nx, z.end());
    return program::evaluate(*program, program->functions.front(), at);
  };
  return std::make_unique<ReferenceAnswer<Precise>>(scene, rates, Extrapolation<Precise>::Accuracy{12, 1e-26, 50});
}

}  // namespace kanec::hard
