// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/verify/samples.hpp"

#include "generator/scene/states.hpp"
#include "runtime/base/error.hpp"
#include "runtime/model/settings.hpp"

namespace kanec {
namespace {

constexpr double parameter_share = 0.01;
constexpr double parameter_of_zero = 0.001;

std::vector<double> near_defaults(const scene::Scene& scene, Random& random) {
  scene::Scene changed = scene;
  for (scene::Named& parameter : changed.parameters) {
    const double change = random.between(-1.0, 1.0);
    parameter.value += change * (parameter.value == 0.0 ? parameter_of_zero : parameter_share * parameter.value);
  }
  try {
    check_defaults(changed, scene.name);
  } catch (const SceneError&) {
    return default_parameters(scene);
  }
  return default_parameters(changed);
}

State sample(const scene::Scene& scene, Random& random, bool defaults) {
  const RandomState drawn = random_state(scene, random);
  State state = initial_state(scene);
  state.t = drawn.t;
  state.x = drawn.x;
  state.y = drawn.y;
  state.ydot = drawn.ydot;
  if (defaults) return state;
  state.parameters = near_defaults(scene, random);
  state.inputs = random_inputs(scene, random);
  return state;
}

}  // namespace

std::vector<State> samples(const scene::Scene& scene, int count, std::uint64_t seed) {
  Random random(seed);
  std::vector<State> list = {initial_state(scene)};
  list.front().ydot = random.numbers(list.front().ydot.size());
  while (static_cast<int>(list.size()) < count) list.push_back(sample(scene, random, list.size() % 2 == 0));
  return list;
}

}  // namespace kanec
