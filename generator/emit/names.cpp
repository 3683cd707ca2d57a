// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/names.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <utility>
#include <vector>

#include "generator/emit/statements.hpp"
#include "generator/scene/entry_names.hpp"

namespace kanec::emit {
namespace {

bool is_safe_word(const std::string& name) {
  const auto fits = [](unsigned char c) { return std::isalnum(c) || c == '_'; };
  return !name.empty() && std::isalpha(static_cast<unsigned char>(name[0])) && name.find("__") == std::string::npos &&
         name.back() != '_' && std::all_of(name.begin(), name.end(), fits);
}

// "theta_elbow" for "theta_3"; empty where body 3 has no name of its own.
std::string by_body(const scene::Scene& scene, const std::string& name) {
  const std::size_t first = name.find('_') + 1;
  const std::size_t end = std::min(name.find('_', first), name.size());
  const std::string number = name.substr(first, end - first);
  const std::string& body = scene.bodies[std::stoul(number) - 1].name;
  if (body == "body" + number || body == "body_" + number || !is_safe_word(body)) return "";
  return scene::name_by_body(scene, name);
}

class Constants {
 public:
  explicit Constants(Syntax syntax) : syntax_(std::move(syntax)) {}

  void add(const std::string& name, std::size_t index) {
    if (name.empty() || !names_.insert(name).second) return;
    list_ += (list_.empty() ? "" : ", ") + syntax_.global(name) + no_break + "=" + no_break + std::to_string(index);
  }

  std::string take_lines() {
    if (list_.empty()) return "";
    return syntax_.constants(std::exchange(list_, ""));
  }

 private:
  Syntax syntax_;
  std::set<std::string> names_;
  std::string list_;
};

}  // namespace

std::string state_constants(const scene::Scene& scene, const Syntax& syntax) {
  const std::vector<std::string> groups[] = {coordinate_names(scene), speed_names(scene)};
  Constants constants(syntax.within("at"));
  std::string text;
  for (const std::vector<std::string>& names : groups) {
    for (std::size_t i = 0; i < names.size(); ++i) constants.add(names[i], i);
    text += constants.take_lines();
  }
  for (const std::vector<std::string>& names : groups) {
    for (std::size_t i = 0; i < names.size(); ++i) constants.add(by_body(scene, names[i]), i);
    text += constants.take_lines();
  }
  return "// Where each coordinate stands in x and each speed in y.\n" + syntax.open("at") + text + syntax.close("at") +
         "\n";
}

}  // namespace kanec::emit
