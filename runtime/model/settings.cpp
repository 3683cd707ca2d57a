// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/model/settings.hpp"

#include <optional>

#include "generator/scene/place.hpp"
#include "generator/scene/read.hpp"
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
  return "one of the scene's " + std::to_string(known.size()) + " parameters and inputs" +
         (near.empty() ? "" : " (did you mean " + near + "?)");
}

scene::Named& find(scene::Scene& scene, const std::string& name) {
  std::vector<std::string> known;
  for (auto* list : {&scene.parameters, &scene.inputs})
    for (scene::Named& named : *list) {
      if (named.name == name) return named;
      known.push_back(named.name);
    }
  if (known.empty())
    refuse_setting(scene::in_quotes(name), "nothing: scene " + scene.name + " has no parameters and no inputs");
  refuse_setting(scene::in_quotes(name), listed(known, name));
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
    scene::Named& named = find(scene, name);
    const std::optional<double> value = finite_number(text);
    if (!value) refuse_setting(name + " = " + scene::in_quotes(text), "a finite number");
    named.value = *value;
  }
  if (!settings.empty()) check_defaults(scene, "--set");
  return scene;
}

}  // namespace kanec
