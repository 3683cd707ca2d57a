// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/random_scene.hpp"

#include <array>
#include <cmath>
#include <string>

namespace kanec::test {
namespace {

using scene::Number;

// Makes the numbers of one scene: constants, or the parameters and inputs that the options ask for.
class Maker {
 public:
  Maker(Random& random, scene::Scene& scene, const RandomSceneOptions& options)
      : random_(random), scene_(scene), options_(options) {}

  Number number(const std::string& name, double value) {
    if (!random_.chance(options_.parameter_share)) return Number::constant(value);
    scene_.parameters.push_back({name, value});
    return Number::parameter(static_cast<int>(scene_.parameters.size()) - 1);
  }

  Number number_or_zero(const std::string& name, double range) {
    const double value = random_.uniform(-range, range);
    return random_.chance(options_.zero_share) ? Number::constant(0) : number(name, value);
  }

  scene::Vector vector(const std::string& name, double range) {
    return {number_or_zero(name + "_1", range), number_or_zero(name + "_2", range), number_or_zero(name + "_3", range)};
  }

  scene::Vector load(const std::string& name, double range) {
    return {load_entry(name + "_1", range), load_entry(name + "_2", range), load_entry(name + "_3", range)};
  }

  scene::Symmetric inertia(const std::string& name, double m);

 private:
  Number load_entry(const std::string& name, double range) {
    if (!random_.chance(options_.input_share)) return number_or_zero(name, range);
    scene_.inputs.push_back({name, random_.uniform(-range, range)});
    return Number::input(static_cast<int>(scene_.inputs.size()) - 1);
  }

  Random& random_;
  scene::Scene& scene_;
  const RandomSceneOptions& options_;
};

// Four mass points and a small ball: positive definite and within the triangle inequality by construction. Without the
// products of inertia the diagonal still is.
scene::Symmetric Maker::inertia(const std::string& name, double m) {
  double xx = 0, yy = 0, zz = 0, xy = 0, xz = 0, yz = 0;
  for (int point = 0; point < 4; ++point) {
    const double a = random_.uniform(-0.5, 0.5);
    const double b = random_.uniform(-0.5, 0.5);
    const double c = random_.uniform(-0.5, 0.5);
    xx += m / 4 * (b * b + c * c), yy += m / 4 * (a * a + c * c), zz += m / 4 * (a * a + b * b);
    xy -= m / 4 * a * b, xz -= m / 4 * a * c, yz -= m / 4 * b * c;
  }
  const double ball = 0.1 * m;
  scene::Symmetric I;
  I.xx = number(name + "_xx", xx + ball);
  I.yy = number(name + "_yy", yy + ball);
  I.zz = number(name + "_zz", zz + ball);
  if (random_.chance(options_.zero_share)) return I;
  I.xy = number(name + "_xy", xy);
  I.xz = number(name + "_xz", xz);
  I.yz = number(name + "_yz", yz);
  return I;
}

template <std::size_t n>
std::array<double, n> random_array(Random& random, double range) {
  std::array<double, n> a;
  for (double& entry : a) entry = random.uniform(-range, range);
  return a;
}

// Each of the two signs of ε, and every rotation, may come.
std::array<double, 4> random_eps(Random& random) {
  std::array<double, 4> eps;
  double square = 0;
  do {
    eps = random_array<4>(random, 1);
    square = eps[0] * eps[0] + eps[1] * eps[1] + eps[2] * eps[2] + eps[3] * eps[3];
  } while (square > 1 || square < 0.01);
  for (double& entry : eps) entry /= std::sqrt(square);
  return eps;
}

void randomise_state(Random& random, scene::Body& body) {
  body.initial.eps = random_eps(random);
  body.initial.omega = random_array<3>(random, 3);
  for (scene::Coordinate& slide : body.joint.slides) slide.value = random.uniform(-1, 1);
  for (scene::Coordinate& slide : body.joint.slides) slide.rate = random.uniform(-2, 2);
}

scene::Body random_body(Random& random, Maker& make, int k, bool loads) {
  const std::string number = std::to_string(k);
  scene::Body body;
  body.name = "body_" + number;
  const double m = random.uniform(0.5, 3);
  body.mass = make.number("m_" + number, m);
  body.inertia = make.inertia("I_" + number, m);
  body.r = make.vector("r_" + number, 0.3);
  body.q = make.vector("q_" + number, 0.5);
  if (loads) {
    body.force = make.load("F_" + number, 10);
    body.moment = make.load("M_" + number, 5);
  }
  randomise_state(random, body);
  return body;
}

}  // namespace

std::vector<int> random_connection(Random& random, int n_bodies, bool forest) {
  std::vector<int> lower;
  for (int k = 1; k <= n_bodies; ++k) lower.push_back(k == 1 ? 0 : forest ? random.below(k) : 1 + random.below(k - 1));
  return lower;
}

scene::Scene random_scene(Random& random, const std::vector<int>& lower, const RandomSceneOptions& options) {
  scene::Scene scene;
  scene.name = "random";
  scene.lower = lower;
  Maker make(random, scene, options);
  if (options.gravity) scene.gravity = make.vector("g", 10);
  const int n_bodies = static_cast<int>(lower.size());
  for (int k = 1; k <= n_bodies; ++k) scene.bodies.push_back(random_body(random, make, k, options.loads));
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
