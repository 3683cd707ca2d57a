// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/study/hard/answer.hpp"

#include <map>

#include "generator/scene/place.hpp"
#include "runtime/base/error.hpp"

namespace kanec::hard {

std::unique_ptr<Answer> answer(const std::string& name, const scene::Scene& scene) {
  static const std::map<std::string, std::unique_ptr<Answer> (*)(const scene::Scene&)> answers = {
      {"torque_free", torque_free}, {"heavy_top", heavy_top},         {"kovalevskaya", kovalevskaya},
      {"kepler", kepler},           {"uniform_chain", uniform_chain}, {"bounce", bounce},
      {"switched", switched},       {"reference", reference_answer},  {"precise", precise_answer}};
  const auto found = answers.find(name);
  if (found != answers.end()) return found->second(scene);
  std::vector<std::string> known;
  for (const auto& [one, make] : answers) known.push_back(one);
  throw InputError("answer: found " + scene::in_quotes(name) + "; allowed: " + scene::one_of(known, name));
}

}  // namespace kanec::hard
