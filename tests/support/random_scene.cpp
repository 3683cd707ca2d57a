// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/random_scene.hpp"

#include "tests/support/random_joint.hpp"
#include "tests/support/random_load.hpp"
#include "tests/support/random_numbers.hpp"

namespace kanec::test {
namespace {

void randomise_state(Random& random, scene::Body& body) {
  if (!body.joint.held) body.initial.eps = random_eps(random);
  for (double& entry : body.initial.omega) entry = random.uniform(-3, 3);
  randomise_coordinates(random, body.joint);
}

scene::Body random_body(Random& random, RandomNumbers& make, scene::Scene& scene, const RandomSceneOptions& options) {
  const std::string number = std::to_string(scene.bodies.size() + 1);
  scene::Body body;
  body.name = "body_" + number;
  const double m = random.uniform(0.5, 3);
  body.mass = make.number("m_" + number, m);
  body.inertia = make.inertia("I_" + number, m);
  body.r = make.vector("r_" + number, 0.3);
  body.q = make.vector("q_" + number, 0.5);
  if (options.loads) {
    body.force = make.load("F_" + number, 10);
    body.moment = make.load("M_" + number, 5);
  }
  if (!options.joints.empty()) {
    const int kind = options.in_order ? static_cast<int>(scene.bodies.size())
                                      : random.below(static_cast<int>(options.joints.size()));
    body.joint = random_joint(random, scene, options.joints[static_cast<std::size_t>(kind)], options);
    body.initial.eps = random_eps(random);
    if (body.joint.kind == "weld" && random.chance(options.massless_share))
      body.mass = scene::Number(), body.inertia = {};
  }
  randomise_state(random, body);
  return body;
}

}  // namespace

RandomSceneOptions everything() {
  return {.parameter_share = 0.3,
          .input_share = 0.3,
          .zero_share = 0.2,
          .joints = every_joint(),
          .locked_share = 0.15,
          .prescribed_share = 0.15,
          .springs = true,
          .point_loads = true,
          .expression_share = 0.3,
          .points = 2,
          .massless_share = 0.3};
}

std::vector<int> random_connection(Random& random, int n_bodies, bool forest) {
  std::vector<int> lower;
  for (int k = 1; k <= n_bodies; ++k) lower.push_back(k == 1 ? 0 : forest ? random.below(k) : 1 + random.below(k - 1));
  return lower;
}

scene::Scene random_scene(Random& random, const std::vector<int>& lower, const RandomSceneOptions& options) {
  scene::Scene scene;
  scene.name = "random";
  scene.lower = lower;
  RandomNumbers make(random, scene, options);
  if (options.gravity) scene.gravity = make.vector("g", 10);
  while (scene.bodies.size() < lower.size()) scene.bodies.push_back(random_body(random, make, scene, options));
  add_loads(random, make, scene, options);
  add_points(random, make, scene, options.points);
  return scene;
}

scene::Scene random_scene(Random& random, int n_bodies, const RandomSceneOptions& options) {
  const std::vector<int> lower = random_connection(random, n_bodies, options.forest);
  return random_scene(random, lower, options);
}

State random_state(Random& random, const scene::Scene& scene) {
  scene::Scene moved = scene;
  for (scene::Body& body : moved.bodies) randomise_state(random, body);
  State state{scene::initial_coordinates(moved), scene::initial_speeds(moved), {}};
  for (int i = 0; i < scene::n_speeds(scene); ++i) state.ydot.push_back(random.uniform(-10, 10));
  return state;
}

std::vector<double> random_parameters(Random& random, const scene::Scene& scene) {
  std::vector<double> parameters = scene::default_parameters(scene);
  for (double& parameter : parameters) parameter *= 1 + random.uniform(-0.01, 0.01);
  return parameters;
}

std::vector<double> random_inputs(Random& random, const scene::Scene& scene) {
  std::vector<double> inputs;
  for (std::size_t i = 0; i < scene.inputs.size(); ++i) inputs.push_back(random.uniform(-10, 10));
  return inputs;
}

}  // namespace kanec::test
