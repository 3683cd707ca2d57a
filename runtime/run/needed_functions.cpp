// SPDX-License-Identifier: GPL-2.0-or-later
#include "runtime/run/needed_functions.hpp"

#include <algorithm>

#include "generator/choice/reach.hpp"
#include "generator/choice/requests.hpp"
#include "generator/symbolic/functions.hpp"

namespace kanec {

std::vector<std::string> functions_to_integrate(const scene::Scene& scene, integrate::Options& options) {
  using integrate::JacobianChoice;
  constexpr long much = 4000;  // operations of A; its derivatives take some ten times as many
  if (options.jacobian == JacobianChoice::automatic && mass_matrix_operations(scene) > much)
    options.jacobian = JacobianChoice::differences;
  std::vector<std::string> list = needed_functions(options, symbolic::has_loads(scene), n_coordinates(scene));
  if (!options.events.empty()) list.emplace_back("events");
  return list;
}

std::string all_rates(const scene::Scene& scene) {
  integrate::Options explicit_method;
  return functions_to_integrate(scene, explicit_method).front();
}

std::vector<std::string> functions_with_rates(const scene::Scene& scene, std::vector<std::string> chosen,
                                              const std::function<void(const std::string&)>& tell) {
  if (chosen.empty()) {
    const Reach reach = within_reach(scene, requested_functions(scene, {}), !scene.functions.empty());
    for (const std::string& note : reach.notes) tell(note);
    chosen = reach.names;
  }
  const std::string rates = all_rates(scene);
  if (std::find(chosen.begin(), chosen.end(), rates) == chosen.end()) chosen.insert(chosen.begin(), rates);
  return chosen;
}

}  // namespace kanec
