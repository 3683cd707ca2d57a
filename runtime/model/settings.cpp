// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/settings.hpp"

#include <optional>

#include "generator/read/read.hpp"
#include "generator/scene/component.hpp"
#include "generator/scene/entry_names.hpp"
#include "generator/scene/place.hpp"
#include "runtime/base/error.hpp"
#include "runtime/base/text.hpp"
#include "runtime/model/scene_text.hpp"

namespace kanec {
namespace {

[[noreturn]] void refuse_setting(const std::string& found, const std::string& allowed) {
  throw InputError("--set: found " + found + "; allowed: " + allowed);
}

// The known names, or, where they are too many to read, the nearest.
std::string listed(const std::vector<std::string>& known, const std::string& name) {
  if (known.size() <= 20) return scene::one_of(known, name);
  const std::string near = nearest(name, known);
  return "one of the scene's " + std::to_string(known.size()) + " parameters, inputs, coordinates and speeds" +
         (near.empty() ? "" : " (did you mean " + near + "?)");
}

// Where the initial value of an entry of x or y stands; nothing of an Euler parameter.
double* initial_value(scene::Scene& scene, const scene::Entry& entry) {
  const scene::Layout layout(scene);
  const bool is_speed = entry.among == scene::Entry::Among::y;
  for (const scene::Component& component : is_speed ? scene::speed_components(scene) : scene::components(scene)) {
    if ((is_speed ? index_in_y(layout, component) : index_in_x(layout, component)) != entry.index) continue;
    scene::Body& body = scene.bodies[static_cast<std::size_t>(component.body - 1)];
    const auto i = static_cast<std::size_t>(component.index);
    if (component.kind == scene::Component::Kind::attitude) return is_speed ? &body.initial.omega[i] : nullptr;
    auto& list = component.kind == scene::Component::Kind::turn ? body.joint.turns : body.joint.slides;
    return is_speed ? &list[i].rate : &list[i].value;
  }
  return nullptr;
}

double& find(scene::Scene& scene, const std::string& name) {
  using enum scene::Entry::Among;
  const scene::EntryNames names(scene);
  const std::optional<scene::Entry> entry = names.find(name);
  if (!entry || entry->among == ydot) {
    const bool has_values = !scene.parameters.empty() || !scene.inputs.empty();
    const std::vector<std::string> values = names.known({parameters, inputs}),
                                   all = names.known({parameters, inputs, x, y});
    if (nearest(name, values).empty() && !nearest(name, all).empty())
      refuse_setting(scene::in_quotes(name), listed(all, name));
    if (!has_values)
      refuse_setting(scene::in_quotes(name),
                     "coordinates and speeds: scene " + scene.name + " has no parameters and no inputs");
    refuse_setting(scene::in_quotes(name), listed(values, name));
  }
  if (entry->among == parameters) return scene.parameters[static_cast<std::size_t>(entry->index)].value;
  if (entry->among == inputs) return scene.inputs[static_cast<std::size_t>(entry->index)].value;
  double* const value = initial_value(scene, *entry);
  if (value == nullptr)
    refuse_setting(scene::in_quotes(name) + ", an Euler parameter alone",
                   "what is no part of an attitude: [body.initial] has all four");
  return *value;
}

}  // namespace

void check_defaults(const scene::Scene& scene, const std::string& origin) {
  try {
    scene::parse(scene_text(scene), origin);
  } catch (const SceneError& error) {
    SceneFault fault = error.fault();
    fault.line = 0;  // of a text that nobody sees
    throw SceneError(fault);
  }
}

scene::Scene with_settings(scene::Scene scene, const std::vector<std::string>& settings) {
  for (const std::string& setting : settings) {
    const std::size_t sign = setting.find('=');
    if (sign == std::string::npos) refuse_setting(scene::in_quotes(setting), "NAME=VALUE");
    const std::string name = setting.substr(0, sign), text = setting.substr(sign + 1);
    double& named = find(scene, name);
    const std::optional<double> value = finite_number(text);
    if (!value) refuse_setting(name + " = " + scene::in_quotes(text), "a finite number");
    named = *value;
  }
  if (!settings.empty()) check_defaults(scene, "--set");
  return scene;
}

}  // namespace kanec
