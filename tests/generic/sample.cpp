// SPDX-License-Identifier: BSD-3-Clause
#include "tests/generic/sample.hpp"

#include "runtime/generic/system.inl"

namespace kanec::generic {

template class System<Dual>;

namespace {

Vector wide(const std::vector<double>& a) {
  return Eigen::Map<const Eigen::VectorXd>(a.data(), static_cast<Eigen::Index>(a.size())).cast<Real>();
}

// ε of unit norm to the last bit of long double, where the equations hold.
void normalise(Vector& x, int n_bodies) {
  for (int k = 0; k < n_bodies; ++k) x.segment<4>(4 * k).normalize();
}

}  // namespace

Sample sample(const scene::Scene& scene, test::Random& random) {
  const test::State state = test::random_state(random, scene);
  Sample sample{scene, test::random_parameters(random, scene), wide(state.x), wide(state.y), wide(state.ydot), {}};
  sample.u = wide(test::random_inputs(random, scene));
  normalise(sample.x, scene::size(scene));
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

std::vector<Sample> samples() {
  test::RandomSceneOptions options;
  options.parameter_share = 0.5;
  options.input_share = 0.5;
  return samples(options);
}

}  // namespace kanec::generic
