// SPDX-License-Identifier: BSD-3-Clause
#include "tests/generic/sample.hpp"

namespace kanec::generic {
namespace {

template <class Number>
std::span<const Number> span(const VectorX<Number>& a) {
  return {a.data(), static_cast<std::size_t>(a.size())};
}

Vector wide(const std::vector<double>& a) {
  return Eigen::Map<const Eigen::VectorXd>(a.data(), static_cast<Eigen::Index>(a.size())).cast<Real>();
}

Matrix in_rows(const Vector& flat, Eigen::Index rows) {
  return Eigen::Map<const Matrix>(flat.data(), rows, rows == 0 ? 0 : flat.size() / rows);
}

// ε of unit norm to the last bit of long double, where the equations hold.
void normalise(Vector& x, const scene::Scene& scene) {
  for (const scene::BodyLayout& at : scene::Layout(scene).bodies)
    if (at.eps >= 0) x.segment<4>(at.eps).normalize();
}

}  // namespace

Vector Sample::operator()(std::string_view function) const {
  const std::vector<Real> flat = evaluate(system<Real>(), function, {t, span(x), span(y), span(ydot), span(u)});
  return Eigen::Map<const Vector>(flat.data(), static_cast<Eigen::Index>(flat.size()));
}

Matrix Sample::matrix(std::string_view function, Eigen::Index rows) const { return in_rows((*this)(function), rows); }

Vector Sample::rate(std::string_view function) const {
  using Moving = Dual<Real>;
  const auto moving_x = test::along<Real>(x, (*this)("kinematics")), moving_y = test::along<Real>(y, ydot);
  const auto still_ydot = test::along<Real>(ydot, Vector::Zero(ydot.size()));
  const auto still_u = test::along<Real>(u, Vector::Zero(u.size()));
  const std::vector<Moving> flat = evaluate(
      system<Moving>(), function, {Moving(t, 1), span(moving_x), span(moving_y), span(still_ydot), span(still_u)});
  return test::rates(Eigen::Map<const VectorX<Moving>>(flat.data(), static_cast<Eigen::Index>(flat.size())));
}

Matrix Sample::matrix_rate(std::string_view function, Eigen::Index rows) const { return in_rows(rate(function), rows); }

Sample Sample::falling() const { return with(&Sample::ydot, (*this)("accelerations")); }

Sample Sample::with(Vector Sample::*argument, Vector value) const {
  Sample changed = *this;
  changed.*argument = std::move(value);
  return changed;
}

Sample sample(const scene::Scene& scene, test::Random& random) {
  const test::State state = test::random_state(random, scene);
  Sample sample{scene, test::random_parameters(random, scene), 0, wide(state.x), wide(state.y), wide(state.ydot), {}};
  sample.u = wide(test::random_inputs(random, scene));
  sample.t = random.uniform(0, 2);
  normalise(sample.x, scene);
  return sample;
}

std::vector<Sample> samples(const test::RandomSceneOptions& options) {
  std::vector<Sample> samples;
  for (int n_bodies = 1; n_bodies <= 12; ++n_bodies) {
    test::Random random(static_cast<std::uint64_t>(1000 + n_bodies));
    const scene::Scene scene = test::random_scene(random, n_bodies, options);
    samples.push_back(sample(scene, random));
  }
  return samples;
}

std::vector<Sample> free_samples() { return samples({.parameter_share = 0.5, .input_share = 0.5}); }

std::vector<Sample> samples() {
  std::vector<Sample> all = free_samples();
  for (Sample& s : samples(test::everything())) all.push_back(std::move(s));
  return all;
}

Real value(const Sample& s, const scene::Number& number) {
  const auto index = static_cast<std::size_t>(number.index);
  if (number.kind == scene::Number::Kind::parameter) return s.parameters[index];
  return number.kind == scene::Number::Kind::input ? s.u[number.index] : Real(number.value);
}

Vector3<Real> values(const Sample& s, const scene::Vector& a) {
  return {value(s, a[0]), value(s, a[1]), value(s, a[2])};
}

Matrix3<Real> inertia(const Sample& s, const scene::Symmetric& a) {
  Matrix3<Real> I;
  I << value(s, a.xx), value(s, a.xy), value(s, a.xz), value(s, a.xy), value(s, a.yy), value(s, a.yz), value(s, a.xz),
      value(s, a.yz), value(s, a.zz);
  return I;
}

}  // namespace kanec::generic
