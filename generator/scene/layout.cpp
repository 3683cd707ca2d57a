// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/layout.hpp"

#include "generator/scene/scene.hpp"

namespace kanec::scene {
namespace {

// Assigns the next index to each coordinate that is part of the state.
void place(const std::vector<Coordinate>& coordinates, std::vector<int>& at, std::vector<int>& rate_at,
           Layout& layout) {
  for (const Coordinate& coordinate : coordinates) {
    const bool in_state = coordinate.motion == Coordinate::Motion::free;
    at.push_back(in_state ? layout.nx++ : -1);
    rate_at.push_back(in_state ? layout.ny++ : -1);
  }
}

// Letters of the names: of an attitude, an angle, a translation.
struct Letters {
  std::string ball, turn, slide;
  int ball_components;
};

std::vector<std::string> names(const Scene& scene, const Letters& letters) {
  std::vector<std::string> result;
  const auto append = [&](const std::vector<Coordinate>& coordinates, const std::string& name) {
    for (std::size_t i = 0; i < coordinates.size(); ++i)
      if (coordinates[i].motion == Coordinate::Motion::free)
        result.push_back(coordinates.size() == 1 ? name : name + "_" + std::to_string(i + 1));
  };
  for (int k = 1; k <= size(scene); ++k) {
    const Joint& joint = scene.bodies[static_cast<std::size_t>(k - 1)].joint;
    const std::string body = "_" + std::to_string(k);
    if (joint.ball && !joint.held)
      for (int i = 1; i <= letters.ball_components; ++i)
        result.push_back(letters.ball + body + "_" + std::to_string(i));
    if (!joint.ball) append(joint.turns, letters.turn + body);
  }
  for (int k = 1; k <= size(scene); ++k)
    append(scene.bodies[static_cast<std::size_t>(k - 1)].joint.slides, letters.slide + "_" + std::to_string(k));
  return result;
}

}  // namespace

Layout::Layout(const Scene& scene) : bodies(scene.bodies.size()) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Joint& joint = scene.bodies[k].joint;
    if (!joint.ball) {
      place(joint.turns, bodies[k].theta, bodies[k].thetadot, *this);
    } else if (!joint.held) {
      bodies[k].eps = nx;
      bodies[k].omega = ny;
      nx += 4;
      ny += 3;
    }
  }
  for (std::size_t k = 0; k < bodies.size(); ++k)
    place(scene.bodies[k].joint.slides, bodies[k].s, bodies[k].sdot, *this);
}

std::vector<std::string> coordinate_names(const Scene& scene) { return names(scene, {"eps", "theta", "s", 4}); }
std::vector<std::string> speed_names(const Scene& scene) { return names(scene, {"omega", "thetadot", "sdot", 3}); }
std::vector<std::string> speed_rate_names(const Scene& scene) {
  return names(scene, {"omegadot", "thetaddot", "sddot", 3});
}

}  // namespace kanec::scene
