// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/component.hpp"

#include <array>

namespace kanec::scene {
namespace {

const Body& body_of(const Scene& scene, const Component& component) {
  return scene.bodies[static_cast<std::size_t>(component.body - 1)];
}

std::vector<Component> components(const Scene& scene, int attitude_components) {
  std::vector<Component> out;
  const auto append = [&out](Component::Kind kind, int body, int count) {
    for (int i = 0; i < count; ++i) out.push_back({kind, body, i, count});
  };
  for (int k = 1; k <= size(scene); ++k) {
    const Joint& joint = scene.bodies[static_cast<std::size_t>(k - 1)].joint;
    if (joint.ball)
      append(Component::Kind::attitude, k, attitude_components);
    else
      append(Component::Kind::turn, k, static_cast<int>(joint.turns.size()));
    append(Component::Kind::slide, k, static_cast<int>(joint.slides.size()));
  }
  return out;
}

// Letters of an attitude, a turn and a slide.
using LetterRow = std::array<const char*, 3>;
constexpr LetterRow coordinate_letters = {"eps", "theta", "s"};
constexpr LetterRow speed_letters = {"omega", "thetadot", "sdot"};

std::string name(const LetterRow& of, const std::string& owner, const Component& component) {
  const std::string out = std::string(of[static_cast<std::size_t>(component.kind)]) + "_" + owner;
  return component.count == 1 ? out : out + "_" + std::to_string(component.index + 1);
}

int index(const Component& component, int attitude, const std::vector<int>& turns, const std::vector<int>& slides) {
  if (component.kind == Component::Kind::attitude) return attitude < 0 ? -1 : attitude + component.index;
  return (component.kind == Component::Kind::turn ? turns : slides)[static_cast<std::size_t>(component.index)];
}

}  // namespace

std::vector<Component> components(const Scene& scene) { return components(scene, 4); }
std::vector<Component> speed_components(const Scene& scene) { return components(scene, 3); }

std::string coordinate_name(const Component& component) {
  return name(coordinate_letters, std::to_string(component.body), component);
}

std::string coordinate_name_by_body(const Scene& scene, const Component& component) {
  return name(coordinate_letters, body_of(scene, component).name, component);
}

std::string speed_name(const Component& component) {
  return name(speed_letters, std::to_string(component.body), component);
}

std::string speed_name_by_body(const Scene& scene, const Component& component) {
  return name(speed_letters, body_of(scene, component).name, component);
}

int index_in_x(const Layout& layout, const Component& component) {
  const BodyLayout& at = layout.bodies[static_cast<std::size_t>(component.body - 1)];
  return index(component, at.eps, at.theta, at.s);
}

int index_in_y(const Layout& layout, const Component& component) {
  const BodyLayout& at = layout.bodies[static_cast<std::size_t>(component.body - 1)];
  return index(component, at.omega, at.thetadot, at.sdot);
}

const Coordinate* coordinate_of(const Scene& scene, const Component& component) {
  const Joint& joint = body_of(scene, component).joint;
  if (component.kind == Component::Kind::attitude) return nullptr;
  return &(component.kind == Component::Kind::turn ? joint.turns
                                                   : joint.slides)[static_cast<std::size_t>(component.index)];
}

}  // namespace kanec::scene
