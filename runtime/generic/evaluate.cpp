// SPDX-License-Identifier: BSD-3-Clause
#include "runtime/generic/evaluate.inl"

#include <algorithm>

namespace kanec::generic {
namespace {

// Functions that only scenes of some kind have.
bool has(const scene::Scene& scene, std::string_view function) {
  const auto any = [](const auto& list, const auto& holds) { return std::any_of(list.begin(), list.end(), holds); };
  const auto driven = [](const scene::Coordinate& one) { return one.motion != scene::Coordinate::Motion::free; };
  if (function == "power" || function == "load_powers" || function == "power_x" || function == "power_y")
    return !scene.loads.empty() || any(scene.bodies, is_loaded);
  if (function == "accelerations_u" || function == "input_matrix") return !scene.inputs.empty();
  if (function == "events") return !scene.events.empty();
  if (function != "driving_loads") return true;
  return any(scene.bodies, [&](const scene::Body& body) {
    const scene::Joint& joint = body.joint;
    return (joint.ball ? joint.held : any(joint.turns, driven)) || any(joint.slides, driven);
  });
}

}  // namespace

std::vector<std::string_view> function_names() {
  std::vector<std::string_view> names;
  for (const auto& function : usual_functions<double>()) names.push_back(function.name);
  return names;
}

std::vector<std::string> function_names(const scene::Scene& scene) {
  std::vector<std::string> names;
  const auto append = [&](std::string_view name) {
    if (has(scene, name)) names.emplace_back(name);
  };
  for (const auto& function : usual_functions<double>()) append(function.name);
  for (const auto& function : functions_on_request<double>()) append(function.name);
  for (const scene::Point& point : scene.points)
    for (const PointFunction& function : point_functions) names.push_back(point.name + std::string(function.suffix));
  for (const auto& function : derivative_functions<double>()) append(function.name);
  return names;
}

template std::vector<double> evaluate(const System<double>&, std::string_view, const Arguments<double>&);
template std::vector<long double> evaluate(const System<long double>&, std::string_view, const Arguments<long double>&);

}  // namespace kanec::generic
