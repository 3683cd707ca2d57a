// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/requirements.hpp"

#include "runtime/base/error.hpp"

namespace kanec::hard {

void refuse(const std::string& answer, const std::string& found, const std::string& allowed) {
  throw InputError(answer + ": found " + found + "; allowed: " + allowed);
}

void refuse_scene(const std::string& answer, const std::string& allowed) { refuse(answer, "another scene", allowed); }

void refuse_bound_slides(const std::string& answer, const scene::Layout& layout, const std::string& allowed) {
  for (std::size_t k = 0; k < layout.bodies.size(); ++k)
    for (const int at : layout.bodies[k].s)
      if (at < 0) refuse(answer, "a slide of body " + std::to_string(k + 1) + " locked or prescribed", allowed);
}

scene::BodyLayout sliding_mass(const std::string& answer, const scene::Scene& scene, std::size_t n_slides,
                               const std::string& allowed) {
  const scene::Layout layout(scene);
  if (layout.bodies.size() != 1 || layout.bodies.front().s.size() != n_slides) refuse_scene(answer, allowed);
  refuse_bound_slides(answer, layout, allowed);
  return layout.bodies.front();
}

long double parameter(const std::string& answer, const scene::Scene& scene, const std::string& name) {
  for (const scene::Named& one : scene.parameters)
    if (one.name == name) return one.value;
  refuse_scene(answer, "one with a parameter " + name);
}

}  // namespace kanec::hard
