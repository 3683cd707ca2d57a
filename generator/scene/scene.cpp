// SPDX-License-Identifier: BSD-3-Clause
#include "generator/scene/scene.hpp"

namespace kanec::scene {
namespace {

template <class Project>
void append(std::vector<double>& out, const Scene& scene, Project project) {
  for (const Body& body : scene.bodies) {
    const auto& part = project(body.initial);
    out.insert(out.end(), part.begin(), part.end());
  }
}

void append_names(std::vector<std::string>& out, const Scene& scene, const std::string& letter, int components) {
  for (int k = 1; k <= size(scene); ++k)
    for (int i = 1; i <= components; ++i) out.push_back(letter + "_" + std::to_string(k) + "_" + std::to_string(i));
}

std::vector<double> values(const std::vector<Named>& list) {
  std::vector<double> out;
  for (const Named& named : list) out.push_back(named.value);
  return out;
}

}  // namespace

std::vector<double> initial_coordinates(const Scene& scene) {
  std::vector<double> x;
  append(
      x, scene, [](const BodyState& state) -> auto& { return state.eps; });
  append(
      x, scene, [](const BodyState& state) -> auto& { return state.s; });
  return x;
}

std::vector<double> initial_speeds(const Scene& scene) {
  std::vector<double> y;
  append(
      y, scene, [](const BodyState& state) -> auto& { return state.omega; });
  append(
      y, scene, [](const BodyState& state) -> auto& { return state.sdot; });
  return y;
}

std::vector<double> default_parameters(const Scene& scene) { return values(scene.parameters); }
std::vector<double> default_inputs(const Scene& scene) { return values(scene.inputs); }

std::vector<int> depth(const std::vector<int>& lower) {
  std::vector<int> u(lower.size(), 0);
  for (std::size_t k = 0; k < lower.size(); ++k)
    if (lower[k] > 0) u[k] = u[static_cast<std::size_t>(lower[k] - 1)] + 1;
  return u;
}

std::vector<std::string> coordinate_names(const Scene& scene) {
  std::vector<std::string> names;
  append_names(names, scene, "eps", 4);
  append_names(names, scene, "s", 3);
  return names;
}

std::vector<std::string> speed_names(const Scene& scene) {
  std::vector<std::string> names;
  append_names(names, scene, "omega", 3);
  append_names(names, scene, "sdot", 3);
  return names;
}

}  // namespace kanec::scene
