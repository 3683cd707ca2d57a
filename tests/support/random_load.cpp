// SPDX-License-Identifier: BSD-3-Clause
#include "tests/support/random_load.hpp"

namespace kanec::test {
namespace {

using scene::Load;

scene::Point random_point(RandomNumbers& make, int body, const std::string& name) {
  return {name, body, make.vector(name + "_r", 0.4)};
}

Load named(const scene::Scene& scene, Load::Kind kind) {
  Load load;
  load.kind = kind;
  load.name = "load_" + std::to_string(scene.loads.size() + 1);
  return load;
}

// `rest` near one, where lengths and coordinates are.
void randomise_spring(RandomNumbers& make, Load& load) {
  load.stiffness = make.magnitude(load.name + "_k", 2, 20);
  load.damping = make.magnitude(load.name + "_c", 0.2, 2);
  load.rest = make.magnitude(load.name + "_rest", 0.2, 1);
}

void add_along(Random& random, RandomNumbers& make, scene::Scene& scene, int body, bool turn, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    if (random.chance(0.5)) continue;
    Load load = named(scene, Load::Kind::joint);
    load.point.body = body;
    load.turn = turn;
    load.coordinate = static_cast<int>(i);
    load.effort = make.magnitude(load.name + "_effort", -5, 5);
    if (random.chance(0.7)) randomise_spring(make, load);
    scene.loads.push_back(load);
  }
}

void add_spring(Random& random, RandomNumbers& make, scene::Scene& scene) {
  const int n_bodies = scene::size(scene);
  Load load = named(scene, Load::Kind::spring);
  const int body = 1 + random.below(n_bodies);
  const int other = (body + 1 + random.below(n_bodies)) % (n_bodies + 1);  // not the same
  load.point = random_point(make, body, load.name + "_a");
  load.other = random_point(make, other, load.name + "_b");
  randomise_spring(make, load);
  scene.loads.push_back(load);
}

void add_point_load(Random& random, RandomNumbers& make, scene::Scene& scene) {
  Load load = named(scene, random.chance(0.5) ? Load::Kind::force : Load::Kind::moment);
  load.point = random_point(make, 1 + random.below(scene::size(scene)), load.name + "_at");
  load.axes = static_cast<scene::Axes>(random.below(3));
  for (scene::Number& entry : load.vector) {
    const std::string entry_name = load.name + "_" + std::to_string(&entry - load.vector.data() + 1);
    entry = make.magnitude(entry_name, -5, 5);
  }
  if (random.chance(0.5)) load.reaction = random.below(scene::size(scene) + 1);
  scene.loads.push_back(load);
}

}  // namespace

void add_loads(Random& random, RandomNumbers& make, scene::Scene& scene, const RandomSceneOptions& options) {
  for (scene::Body& body : scene.bodies) {
    if (!options.loads || options.expression_share == 0) break;
    make.some_to_expressions(body.force, 10);
    make.some_to_expressions(body.moment, 5);
  }
  const int some = 1 + scene::size(scene) / 3;
  if (options.springs) {
    for (int k = 1; k <= scene::size(scene); ++k) {
      const scene::Joint& joint = scene.bodies[static_cast<std::size_t>(k - 1)].joint;
      if (!joint.ball) add_along(random, make, scene, k, true, joint.turns.size());
      add_along(random, make, scene, k, false, joint.slides.size());
    }
    for (int i = 0; i < some; ++i) add_spring(random, make, scene);
  }
  for (int i = 0; options.point_loads && i < some; ++i) add_point_load(random, make, scene);
}

void add_points(Random& random, RandomNumbers& make, scene::Scene& scene, int n) {
  for (int i = 1; i <= n; ++i) {
    const int body = 1 + random.below(scene::size(scene));
    scene.points.push_back(random_point(make, body, "point_" + std::to_string(i)));
  }
}

}  // namespace kanec::test
