// SPDX-License-Identifier: GPL-2.0-or-later
#include "tests/lower/trees.hpp"

#include "generator/choice/requests.hpp"
#include "generator/lower/derivatives.hpp"
#include "runtime/model/tangent.hpp"

namespace kanec::test {

std::vector<std::string> every_function(const scene::Scene& scene) {
  std::vector<std::string> names;
  for (const Available& available : available_functions(scene)) names.push_back(available.name);
  return names;
}

std::vector<std::string> without_derivatives(const scene::Scene& scene) {
  std::vector<std::string> names = every_function(scene);
  for (const lower::Derived& derived : lower::derived_functions(scene)) std::erase(names, derived.name);
  return names;
}

std::vector<long double> comparable(const Sample& s, const std::string& function,
                                    const std::vector<long double>& result) {
  const bool by_x = function == "residual_x" || function == "accelerations_x" || function == "power_x";
  return by_x ? along_tangent(s.scene, s.state.x, result) : result;
}

}  // namespace kanec::test
