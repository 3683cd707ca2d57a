// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/run/conservation.hpp"

#include <algorithm>

namespace kanec {
namespace {

using scene::Coordinate;
using scene::Load;

bool any_prescribed(const std::vector<Coordinate>& coordinates) {
  return std::any_of(coordinates.begin(), coordinates.end(),
                     [](const Coordinate& c) { return c.motion == Coordinate::Motion::prescribed; });
}

// Six free coordinates on the inertial frame.
bool moves_freely(const scene::Joint& joint) {
  const bool slides_freely = std::all_of(joint.slides.begin(), joint.slides.end(),
                                         [](const Coordinate& c) { return c.motion == Coordinate::Motion::free; });
  return joint.ball && !joint.held && joint.slides.size() == 3 && slides_freely;
}

bool acts_from_outside(const scene::Scene& scene, const Load& load) {
  switch (load.kind) {
    case Load::Kind::force:
    case Load::Kind::moment:
      return load.reaction < 1;
    case Load::Kind::joint:
      return scene.lower[static_cast<std::size_t>(load.point.body - 1)] == 0;
    case Load::Kind::spring:
      return load.point.body == 0 || load.other.body == 0;
  }
  return true;
}

}  // namespace

bool has_drives(const scene::Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const scene::Body& body) {
    return any_prescribed(body.joint.turns) || any_prescribed(body.joint.slides);
  });
}

bool has_attitudes(const scene::Scene& scene) {
  return std::any_of(scene.bodies.begin(), scene.bodies.end(),
                     [](const scene::Body& body) { return body.joint.ball && !body.joint.held; });
}

bool is_isolated(const scene::Scene& scene) {
  if (!is_zero(scene.gravity)) return false;
  for (std::size_t k = 0; k < scene.bodies.size(); ++k) {
    const scene::Body& body = scene.bodies[k];
    if (!is_zero(body.force) || !is_zero(body.moment)) return false;
    if (scene.lower[k] == 0 && !moves_freely(body.joint)) return false;
  }
  return std::none_of(scene.loads.begin(), scene.loads.end(),
                      [&](const Load& load) { return acts_from_outside(scene, load); });
}

}  // namespace kanec
