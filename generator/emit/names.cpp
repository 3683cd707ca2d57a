// SPDX-License-Identifier: BSD-3-Clause
#include "generator/emit/names.hpp"

#include <set>
#include <utility>
#include <vector>

#include "generator/emit/statements.hpp"
#include "generator/scene/entry_names.hpp"

namespace kanec::emit {
namespace {

class Constants {
 public:
  explicit Constants(Syntax syntax) : syntax_(std::move(syntax)) {}

  void add(const std::string& name, std::size_t index) {
    if (!names_.insert(name).second) return;
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
  const std::vector<std::string> words = scene::body_words(scene);
  for (const std::vector<std::string>& names : groups) {
    for (std::size_t i = 0; i < names.size(); ++i) constants.add(scene::in_words(names[i], words), i);
    text += constants.take_lines();
  }
  return "// Where each coordinate stands in x and each speed in y.\n" + syntax.open("at") + text + syntax.close("at") +
         "\n";
}

}  // namespace kanec::emit
