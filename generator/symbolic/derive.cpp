// SPDX-License-Identifier: GPL-2.0-or-later
#include "generator/symbolic/derive.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include "generator/symbolic/functions.hpp"
#include "generator/symbolic/kane.hpp"
#include "generator/symbolic/partials.hpp"
#include "generator/symbolic/stages.hpp"
#include "runtime/base/error.hpp"

namespace kanec::symbolic {
namespace {

using Stage = void (*)(Derivation&);

const std::map<std::string, Stage>& stages() {
  static const std::map<std::string, Stage> known = {{"kinematics", derive_kinematics},
                                                     {"poses", derive_poses},
                                                     {"energy", derive_energy},
                                                     {"momentum", derive_momentum},
                                                     {"power", derive_power},
                                                     {"load_powers", derive_load_powers},
                                                     {"events", derive_events},
                                                     {"accelerations", derive_accelerations},
                                                     {"residual", derive_residual},
                                                     {"forcing", derive_forcing},
                                                     {"mass_matrix", derive_mass_matrix},
                                                     {"inertia_xi", derive_inertia_xi},
                                                     {"inertia_y", derive_inertia_y},
                                                     {"applied", derive_applied},
                                                     {"driving_loads", derive_driving_loads},
                                                     {"reactions", derive_reactions}};
  return known;
}

void derive_function(Derivation& derivation, const std::string& name) {
  const auto stage = stages().find(name);
  if (stage != stages().end()) return stage->second(derivation);
  if (name.rfind("partial_", 0) == 0) return derive_partial_velocity_functions(derivation, name);
  derive_point_function(derivation, name);
}

// Keeps the functions that are wanted, in order.
std::vector<Function> chosen(std::vector<Function> all, const std::vector<std::string>& names) {
  std::vector<Function> result;
  std::string known;
  for (const Function& function : all) {
    known += (known.empty() ? "" : ", ") + function.name;
    const bool is_named = std::find(names.begin(), names.end(), function.name) != names.end();
    if (names.empty() ? function.usual : is_named) result.push_back(function);
  }
  for (const std::string& name : names)
    if (std::none_of(all.begin(), all.end(), [&](const Function& function) { return function.name == name; }))
      throw InputError("no function '" + name + "' in this model; it has: " + known);
  return result;
}

}  // namespace

bool needs_whole_mechanism(const std::string& function) {
  return function == "driving_loads" || function == "reactions";
}

Equations derive(const scene::Scene& scene, const std::vector<std::string>& names, const Way& way) {
  Derivation derivation(scene, way);
  std::vector<Function> known = functions(scene);
  for (Function& part : derivative_parts(scene)) known.push_back(std::move(part));
  derivation.equations.functions = chosen(std::move(known), names);
  derive_positions(derivation);
  derive_velocities(derivation);
  std::vector<std::string> wanted;
  for (const Function& function : derivation.equations.functions) wanted.push_back(function.name);
  for (const std::string& name : wanted) derive_function(derivation, name);
  return std::move(derivation.equations);
}

}  // namespace kanec::symbolic
