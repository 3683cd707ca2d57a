// SPDX-License-Identifier: GPL-2.0-or-later
#include <complex>
#include <numbers>

#include "runtime/generic/system.hpp"
#include "runtime/study/hard/answer.hpp"
#include "runtime/study/hard/elliptic.hpp"
#include "runtime/study/hard/requirements.hpp"

namespace kanec::hard {
namespace {

// q̈ + 2 γ q̇ + ω² q = 0 from q0, v0; q and q̇ at t. Of the two rates the small one is ω² over the large one; as long
// as they are no matter apart, cosh and sinh of half their difference, which may be 0 or imaginary.
struct Motion {
  Real q, v;
};
Motion oscillation(Real gamma, Real omega, Real q0, Real v0, Real t) {
  using Complex = std::complex<Real>;
  const Complex root = std::sqrt(Complex(gamma * gamma - omega * omega));
  if (const Complex apart = root * t; std::abs(apart) < 1) {
    const Real even = std::cosh(apart).real(), decay = std::exp(-gamma * t);
    const Real odd = apart == Complex(0) ? t : t * (std::sinh(apart) / apart).real();
    return {decay * (q0 * even + (v0 + gamma * q0) * odd),
            decay * (v0 * even - (gamma * v0 + omega * omega * q0) * odd)};
  }
  const Complex fast = -gamma - root, slow = omega * omega / fast;
  const Complex a = (v0 - fast * q0) / (slow - fast), b = q0 - a;
  const Complex of_slow = a * std::exp(slow * t), of_fast = b * std::exp(fast * t);
  return {(of_slow + of_fast).real(), (slow * of_slow + fast * of_fast).real()};
}

class UniformChain final : public Answer {
 public:
  explicit UniformChain(const scene::Scene& scene) : layout_(scene), n_(scene::size(scene)) {
    const generic::System<Real> system(scene, scene::default_parameters(scene));
    const std::string allowed = "equal masses on a line, parameters k > 0, c";
    refuse_bound_slides("uniform_chain", layout_, allowed);
    Real k = -1, c = 0;
    for (const scene::Named& parameter : scene.parameters) {
      if (parameter.name == "k") k = parameter.value;
      if (parameter.name == "c") c = parameter.value;
    }
    bool is_chain = k > 0 && layout_.ny == n_;
    for (int i = 1; i <= n_; ++i)
      is_chain = is_chain && system.body(i).m == system.body(1).m && system.body(i).lower == i - 1 &&
                 layout_.bodies[static_cast<std::size_t>(i - 1)].s.size() == 1;
    if (!is_chain) refuse_scene("uniform_chain", allowed);
    stiffness_ = k / system.body(1).m;
    damping_ = c / system.body(1).m;
  }

  void compare(const Row& row) override {
    const std::vector<Real> place = summed(row.x, &scene::BodyLayout::s),
                            speed = summed(row.y, &scene::BodyLayout::sdot);
    if (row.t == 0) begin(place, speed);
    for (int i = 1; i <= n_; ++i) {
      Motion expected{0, 0};
      for (int j = 1; j <= n_; ++j) {
        const auto [q0, v0] = start_[static_cast<std::size_t>(j - 1)];
        const Real eigenvalue = 4 * std::pow(std::sin(phase(j) / 2), 2);
        const Motion mode = oscillation(damping_ * eigenvalue / 2, std::sqrt(stiffness_ * eigenvalue), q0, v0, row.t);
        expected.q += mode.q * std::sin(i * phase(j));
        expected.v += mode.v * std::sin(i * phase(j));
      }
      const auto at = static_cast<std::size_t>(i - 1);
      position_.add(std::fabs(place[at] - expected.q));
      speed_.add(std::fabs(speed[at] - expected.v));
      place_size_ = std::max(place_size_, std::fabs(expected.q));
      speed_size_ = std::max(speed_size_, std::fabs(expected.v));
    }
  }

  std::vector<Deviation> deviations() const override {
    return {position_.beside(place_size_), speed_.beside(speed_size_)};
  }

 private:
  Real phase(int j) const {
    return std::numbers::pi_v<Real> * static_cast<Real>(2 * j - 1) / static_cast<Real>(2 * n_ + 1);
  }

  // Displacements of the masses from those along the joints.
  std::vector<Real> summed(std::span<const double> values, std::vector<int> scene::BodyLayout::*at) const {
    std::vector<Real> list;
    Real sum = 0;
    for (const scene::BodyLayout& body : layout_.bodies)
      list.push_back(sum += values[static_cast<std::size_t>((body.*at).front())]);
    return list;
  }

  // In modes, whose squares sum to (2 N + 1) / 4 over the masses.
  void begin(const std::vector<Real>& place, const std::vector<Real>& speed) {
    for (int j = 1; j <= n_; ++j) {
      Motion mode{0, 0};
      for (int i = 1; i <= n_; ++i) {
        const Real share = std::sin(i * phase(j)) * 4 / static_cast<Real>(2 * n_ + 1);
        mode.q += share * place[static_cast<std::size_t>(i - 1)];
        mode.v += share * speed[static_cast<std::size_t>(i - 1)];
      }
      start_.push_back(mode);
    }
  }

  scene::Layout layout_;
  int n_;
  Real stiffness_ = 0, damping_ = 0;
  std::vector<Motion> start_;
  Deviation position_{"position", ""}, speed_{"speed", ""};
  Real place_size_ = 0, speed_size_ = 0;
};

}  // namespace

std::unique_ptr<Answer> uniform_chain(const scene::Scene& scene) { return std::make_unique<UniformChain>(scene); }

}  // namespace kanec::hard
